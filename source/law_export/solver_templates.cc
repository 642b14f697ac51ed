#include <asperity/law_export/generated_source.h>
#include <asperity/law_export/solver_templates.h>

#include "export_text.h"

namespace asperity
{
  namespace
  {
    /** mu_eff = min(mu, k/p) and its derivatives, in the solver's units. */
    const char *const effective_coefficient = R"(C
C     MU = MIN(MU, K/P) AND ITS DERIVATIVES BY P, V, T IN YOUR UNITS:
C     FP, FV MAKE SI OF A PRESSURE AND A VELOCITY, T0 IS ADDED TO A
C     TEMPERATURE
      SUBROUTINE TRIBEF(P,V,T,FP,FV,T0,XMU,DMUP,DMUV,DMUT)
      IMPLICIT NONE
      INTEGER INSIDE
      DOUBLE PRECISION P,V,T,FP,FV,T0,XMU,DMUP,DMUV,DMUT
      DOUBLE PRECISION PS,VS,TS,DMU(3),XK,DXK
      PS=P*FP
      VS=V*FV
      TS=T+T0
      CALL TRIBMU(PS,VS,TS,XMU,DMU,INSIDE)
      CALL TRIBK(TS,XK,DXK)
      DMUP=DMU(1)*FP
      DMUV=DMU(2)*FV
      DMUT=DMU(3)
      IF (XMU*PS.GT.XK) THEN
        XMU=XK/PS
        DMUP=-XMU/P
        DMUV=0D0
        DMUT=DXK/PS
      END IF
      END
)";

    const char *const fric_coef = R"(      subroutine fric_coef(
     &  fCoef, fCoefDeriv,
     &  nBlock, nProps, nTemp, nFields,
     &  iData, rData,
     &  surfInt, surfSec, surfMain,
     &  props, slipData, pressure,
     &  tempAvg, fieldAvg )
C
      include 'aba_param.inc'
C
      dimension fCoef(nBlock,2),
     &  fCoefDeriv(nBlock,20,2),
     &  props(nProps),
     &  slipData(nBlock,6),
     &  pressure(nBlock),
     &  tempAvg(nBlock),
     &  fieldAvg(nBlock,nFields)
      dimension iData(*), rData(*)
      character*80 surfInt, surfSec, surfMain
C
C     UNITS: MPA TO PA, MM/S TO M/S, DEGC TO K
      double precision FP, FV, T0
      parameter ( FP=1D6, FV=1D-3, T0=273.15D0 )
C     TEMPERATURE IN A MODEL WITHOUT ANY
      double precision TNONE
      parameter ( TNONE=20D0 )
C
      integer k
      double precision P, V, T, XMU, DMUP, DMUV, DMUT
C
      do 10 k = 1, nBlock
        P = pressure(k)
        V = slipData(k,1)
        T = TNONE
        if (nTemp.gt.0) T = tempAvg(k)
        call TRIBEF(P,V,T,FP,FV,T0,XMU,DMUP,DMUV,DMUT)
        fCoef(k,1) = XMU
        fCoefDeriv(k,1,1) = DMUV
        fCoefDeriv(k,2,1) = DMUP
        fCoefDeriv(k,3,1) = DMUT
   10 continue
      return
      end
)";

    const char *const vfriction = R"(      subroutine vfriction(
     &  fTangential,
     &  state,
     &  nBlock, nBlockAnal, nBlockEdge,
     &  nNodState, nNodSlv, nNodMst,
     &  nFricDir, nDir,
     &  nStates, nProps, nTemp, nFields,
     &  jFlags, rData,
     &  surfInt, surfSlv, surfMst,
     &  jConSlvUid, jConMstUid, props,
     &  dSlipFric, fStickForce, fTangPrev, fNormal,
     &  areaCont, dircosN, dircosS1,
     &  shapeSlv, shapeMst,
     &  coordSlv, coordMst,
     &  velSlv, velMst,
     &  tempSlv, tempMst,
     &  fieldSlv, fieldMst )
C
      include 'vaba_param.inc'
C
      dimension fTangential(nFricDir,nBlock),
     &  state(nStates,nNodState,nBlock),
     &  jConSlvUid(nNodSlv,nBlock),
     &  jConMstUid(nNodMst,nBlockAnal),
     &  props(nProps),
     &  dSlipFric(nDir,nBlock),
     &  fStickForce(nBlock),
     &  fTangPrev(nDir,nBlock),
     &  fNormal(nBlock),
     &  areaCont(nBlock),
     &  dircosN(nDir,nBlock),
     &  dircosS1(nDir,nBlock),
     &  shapeSlv(nNodSlv,nBlockEdge),
     &  shapeMst(nNodMst,nBlockAnal),
     &  coordSlv(nDir,nNodSlv,nBlock),
     &  coordMst(nDir,nNodMst,nBlockAnal),
     &  velSlv(nDir,nNodSlv,nBlock),
     &  velMst(nDir,nNodMst,nBlockAnal),
     &  tempSlv(nBlock),
     &  tempMst(nBlockAnal),
     &  fieldSlv(nFields,nBlock),
     &  fieldMst(nFields,nBlockAnal)
      dimension jFlags(3), rData(4)
      character*80 surfInt, surfSlv, surfMst
C
C     UNITS: MPA TO PA, MM/S TO M/S, DEGC TO K
      double precision FP, FV, T0
      parameter ( FP=1D6, FV=1D-3, T0=273.15D0 )
C     TEMPERATURE IN A MODEL WITHOUT ANY
      double precision TNONE
      parameter ( TNONE=20D0 )
C
      integer k, i
      double precision P, V, T, XMU, DMUP, DMUV, DMUT, F, SLIP, DT
C
C     THE CURRENT TIME INCREMENT
      DT = rData(3)
      do 30 k = 1, nBlock
        do 10 i = 1, nFricDir
          fTangential(i,k) = 0
   10   continue
        if (fNormal(k).gt.0 .and. areaCont(k).gt.0) then
          SLIP = 0D0
          do 20 i = 1, nDir
            SLIP = SLIP + dble(dSlipFric(i,k))**2
   20     continue
          P = dble(fNormal(k))/dble(areaCont(k))
          V = 0D0
          if (DT.gt.0D0) V = sqrt(SLIP)/DT
          T = TNONE
C         AN ANALYTICAL RIGID SURFACE HAS ONE TEMPERATURE FOR ALL
          if (nTemp.gt.0) T = 0.5D0*(dble(tempSlv(k)) +
     &      dble(tempMst(min(k,nBlockAnal))))
          call TRIBEF(P,V,T,FP,FV,T0,XMU,DMUP,DMUV,DMUT)
          F = XMU*dble(fNormal(k))
C         THE FIRST DIRECTION IS THAT OF THE SLIP
          fTangential(1,k) = -min(F,dble(fStickForce(k)))
        end if
   30 continue
      return
      end
)";

    const char *const usrbcc =
      R"(      SUBROUTINE USRBCC(VARIABLE,NODE1,NODE2,IELEM,NBCD,NDIE,RZ,
     &  DRZ,USRNOD,NUSRN,ENVTEM,TEMO,TEMC,CURTIM,MODEL,IMODE,ITYPE,
     &  NURZ)
      IMPLICIT REAL*8 (A-H,O-Z), INTEGER*4 (I-N)
      DIMENSION NBCD(NURZ,2),RZ(2,2),DRZ(NURZ,2),USRNOD(NUSRN,1),
     &  TEMO(2),TEMC(2)
C     TEMPERATURES OF THE OTHER AND OF THIS OBJECT, VELOCITY, PRESSURE
      COMMON /UFHCOM/ TMPENV,TMPSLF,SLDVEL,PRESS
C
C     UNITS: MPA TO PA, MM/S TO M/S, DEGC TO K
      DOUBLE PRECISION FP,FV,T0
      PARAMETER ( FP=1D6, FV=1D-3, T0=273.15D0 )
C
      DOUBLE PRECISION P,V,T,XMU,DMUP,DMUV,DMUT
C
      VARIABLE=0D0
C     DEFORMATION (1), FRICTION (2)
      IF (IMODE.EQ.1 .AND. ITYPE.EQ.2) THEN
        P=ABS(PRESS)
        V=ABS(SLDVEL)
        T=0.5D0*(TMPENV+TMPSLF)
        CALL TRIBEF(P,V,T,FP,FV,T0,XMU,DMUP,DMUV,DMUT)
        VARIABLE=XMU
      END IF
      RETURN
      END
)";

    std::string
    assemble(std::vector<std::string> title,
             const ContactPointLaw   &law,
             const std::string       &routine)
    {
      for (const char *const line :
           {"mu is limited by k(T)/p, so that tau = min(mu p, k).",
            "",
            "Written by asperity; the law and its licence follow below, and",
            "the licence holds for all of this file."})
        title.push_back(line);
      std::string text;
      for (const std::string &line : title)
        text += line.empty() ? "C\n" : "C " + line + "\n";
      return text + routine + effective_coefficient + "C\n" +
             fortran_source(law, false);
    }
  } // namespace



  std::string
  abaqus_fric_coef(const ContactPointLaw &law)
  {
    return assemble(
      {"FRIC_COEF for Abaqus/Standard: friction coefficient and derivatives.",
       "NOT RUN IN THAT PROGRAM; compiled and tested by itself.",
       "Use: *FRICTION, USER=COEFFICIENT. Units: mm, t, s, N, MPa, degC; to",
       "change them, change FP, FV and T0."},
      law,
      fric_coef);
  }



  std::string
  abaqus_vfriction(const ContactPointLaw &law)
  {
    return assemble(
      {"VFRICTION for Abaqus/Explicit, general contact: friction force.",
       "NOT RUN IN THAT PROGRAM; compiled and tested by itself.",
       "Use: *FRICTION, USER. Units: mm, t, s, N, MPa, degC; to change",
       "them, change FP, FV and T0."},
      law,
      vfriction);
  }



  std::string
  deform_usr_bcc(const ContactPointLaw &law)
  {
    return assemble(
      {"USRBCC for DEFORM: coefficient of Coulomb friction.",
       "NOT RUN IN THAT PROGRAM; compiled and tested by itself.",
       "Use: FRCFAC with the friction type 2 and the user's routine. Units:",
       "mm, s, N, MPa, degC; to change them, change FP, FV and T0."},
      law,
      usrbcc);
  }
} // namespace asperity
