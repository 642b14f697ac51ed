      subroutine vfriction(
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
C     BEGIN PARAMETERS NQ
      INTEGER NQ
      PARAMETER (NQ=1)
C     END PARAMETERS
      integer k, i
      double precision Q(NQ+1)
      double precision P, V, T, XMU, DMUP, DMUV, DMUT, F, SLIP, DT
C
C     FURTHER INPUTS OF THE LAW: THE PROPERTIES, IF THERE ARE ENOUGH
      call TRIBST(Q)
      if (nProps.ge.NQ) then
        do 5 k = 1, min(NQ,nProps)
          Q(k) = props(k)
    5   continue
      end if
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
          call TRIBEF(P,V,T,Q,FP,FV,T0,XMU,DMUP,DMUV,DMUT)
          F = XMU*dble(fNormal(k))
C         THE FIRST DIRECTION IS THAT OF THE SLIP
          fTangential(1,k) = -min(F,dble(fStickForce(k)))
        end if
   30 continue
      return
      end
