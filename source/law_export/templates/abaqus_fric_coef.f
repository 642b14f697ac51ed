      subroutine fric_coef(
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
C     BEGIN PARAMETERS NQ
      INTEGER NQ
      PARAMETER (NQ=1)
C     END PARAMETERS
      integer k
      double precision Q(NQ+1)
      double precision P, V, T, XMU, DMUP, DMUV, DMUT
C
C     FURTHER INPUTS OF THE LAW: THE PROPERTIES, IF THERE ARE ENOUGH
      call TRIBST(Q)
      if (nProps.ge.NQ) then
        do 5 k = 1, min(NQ,nProps)
          Q(k) = props(k)
    5   continue
      end if
      do 10 k = 1, nBlock
        P = pressure(k)
        V = slipData(k,1)
        T = TNONE
        if (nTemp.gt.0) T = tempAvg(k)
        call TRIBEF(P,V,T,Q,FP,FV,T0,XMU,DMUP,DMUV,DMUT)
        fCoef(k,1) = XMU
        fCoefDeriv(k,1,1) = DMUV
        fCoefDeriv(k,2,1) = DMUP
        fCoefDeriv(k,3,1) = DMUT
   10 continue
      return
      end
