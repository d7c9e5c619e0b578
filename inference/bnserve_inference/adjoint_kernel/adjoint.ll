; sources: db24e6ccb1211083c07a5b8acdf016b17751ecfc81cb70c51728fe6689958a4e
; built by: numba 0.68.1, llvmlite 0.50.0, Python 3.11, x86_64
; ModuleID = '<string>'
source_filename = "<string>"


; Function Attrs: nofree norecurse nosync nounwind memory(readwrite, inaccessiblemem: none, target_mem0: none, target_mem1: none)
define noundef i32 @bnserve_pull_back(ptr noalias writeonly captures(none) initializes((0, 8)) %retptr, ptr noalias readnone captures(none) %excinfo, ptr readonly captures(none) %arg.arguments) local_unnamed_addr #0 {
entry:
  %.43 = alloca i64, align 8
  store i64 0, ptr %.43, align 8
  call fastcc void @inner_0(ptr nonnull %.43, ptr %arg.arguments)
  store i64 0, ptr %retptr, align 8
  ret i32 0
}

; Function Attrs: mustprogress nocallback nofree nounwind willreturn memory(argmem: write)
declare void @llvm.memset.p0.i64(ptr writeonly captures(none), i8, i64, i1 immarg) #1

; Function Attrs: nofree norecurse nosync nounwind memory(readwrite, inaccessiblemem: none, target_mem0: none, target_mem1: none)
define internal fastcc void @inner_0(ptr noalias nonnull writeonly captures(none) %retptr, ptr readonly captures(none) %arg.arguments.4) unnamed_addr #0 {
entry:
  %.880.i.i173 = alloca double, align 8
  %.747.i = alloca ptr, align 8
  %.782.i = alloca ptr, align 8
  %.690.i = alloca double, align 8
  %.47 = load i64, ptr %arg.arguments.4, align 8
  %.76 = getelementptr i8, ptr %arg.arguments.4, i64 16
  %.77 = load i64, ptr %.76, align 8
  %.106 = getelementptr i8, ptr %arg.arguments.4, i64 8
  %.140 = getelementptr i8, ptr %arg.arguments.4, i64 24
  %.141 = load i64, ptr %.140, align 8
  %.142 = sub i64 0, %.141
  %.150.1 = and i64 %.142, -8
  %.184 = sub i64 0, %.150.1
  %.193 = mul nsw i64 %.47, 44
  %.223 = getelementptr i8, ptr %arg.arguments.4, i64 224
  %.224 = load i64, ptr %.223, align 8
  %.230 = inttoptr i64 %.224 to ptr
  %.363.idx = mul i64 %.47, 200
  %.363 = getelementptr i8, ptr %.230, i64 %.363.idx
  %.430 = getelementptr inbounds double, ptr %.230, i64 %.193
  %.idx = mul i64 %.77, 27648
  %0 = getelementptr i8, ptr %.230, i64 %.idx
  %1 = getelementptr i8, ptr %0, i64 14336
  %.498 = getelementptr double, ptr %1, i64 %.193
  %.586 = getelementptr inbounds nuw i8, ptr %.430, i64 12288
  %.683 = getelementptr i8, ptr %arg.arguments.4, i64 120
  %.684 = load i64, ptr %.683, align 8
  %.7641025.not = icmp slt i64 %.684, 1
  br i1 %.7641025.not, label %B1452, label %B666.if.lr.ph

B1212:                                            ; preds = %_ZN17bnserve_inference14adjoint_kernel7_source12_in_detectorB4v131B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxx5ArrayIxLi1E1C7mutable7alignedEd5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit, %_ZN17bnserve_inference14adjoint_kernel7_source9_polariseB3v77B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit
  %.84.i = load i64, ptr %.106, align 8, !noalias !0
  %.114.i = load i64, ptr %.76, align 8, !noalias !0
  %.144.i = load i64, ptr %.140, align 8, !noalias !0
  %.149.i = sub i64 0, %.144.i
  %.157.1.i = and i64 %.149.i, -8
  %.193.i = sub nsw i64 %.144.i, %.1090933952
  %.13.i.i = tail call i64 @llvm.smin.i64(i64 %.193.i, i64 range(i64 -9223372036854775808, 129) %.13.i)
  %.464729.not.i = icmp slt i64 %.84.i, 1
  br i1 %.464729.not.i, label %B482.i, label %B334.if.lr.ph.i

B482.i:                                           ; preds = %_ZN17bnserve_inference14adjoint_kernel5_back10waves_backB4v492B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE.exit.i, %B1212
  %.781.i = load i64, ptr %.780.i, align 8, !noalias !0
  %.782.not.i = icmp eq i64 %.781.i, 0
  %.978758.not.i = icmp slt i64 %.114.i, 1
  %or.cond.i = select i1 %.782.not.i, i1 true, i1 %.978758.not.i
  br i1 %or.cond.i, label %_ZN17bnserve_inference14adjoint_kernel7_source11_block_backB4v479B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit, label %B632.if.lr.ph.i

B934.loopexit.unr-lcssa.i:                        ; preds = %B860.if.i
  br i1 %42, label %B934.i, label %B860.if.epil.preheader.i

B860.if.epil.preheader.i:                         ; preds = %B632.if.i, %B934.loopexit.unr-lcssa.i
  %.1373734736.epil.init.i = phi i64 [ 0, %B632.if.i ], [ %.1380.1.i, %B934.loopexit.unr-lcssa.i ]
  %2 = inttoptr i64 %.1056.i to ptr
  %.1412.epil.i = getelementptr inbounds double, ptr %.1218.i, i64 %.1373734736.epil.init.i
  %.1414.epil.i = load <8 x double>, ptr %.1412.epil.i, align 8, !noalias !0
  %.8.i.epil.i = fmul contract <8 x double> %.7.i.i, %.1414.epil.i
  %.1447.epil.i = getelementptr inbounds double, ptr %2, i64 %.1373734736.epil.init.i
  store <8 x double> %.8.i.epil.i, ptr %.1447.epil.i, align 8, !noalias !0
  br label %B934.i

B934.i:                                           ; preds = %B632.if.i, %B860.if.epil.preheader.i, %B934.loopexit.unr-lcssa.i
  %scevgep125.i = getelementptr i8, ptr %lsr.iv.i3, i64 27648
  %exitcond793.not.i = icmp eq i64 %.991.i, %.114.i
  br i1 %exitcond793.not.i, label %_ZN17bnserve_inference14adjoint_kernel7_source11_block_backB4v479B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit, label %B632.if.i

B334.if.lr.ph.i:                                  ; preds = %B1212
  %.261.i = load i64, ptr %.456.i, align 8, !noalias !0
  %3 = shl i64 %.1090933952, 4
  %scevgep135.i = getelementptr i8, ptr %.498, i64 %3
  %4 = lshr i64 %.149.i, 3
  %5 = mul i64 %4, -128
  %6 = inttoptr i64 %.261.i to ptr
  %.654.i.i = sub i64 0, %.13.i.i
  %.662.1.i.i = and i64 %.654.i.i, -8
  %.696.i.i = sub i64 0, %.662.1.i.i
  %.302246.not.i.i.i = icmp slt i64 %.13.i.i, 1
  %.515.i.i.i = sub i64 %.696.i.i, %.13.i.i
  %.558252.not.i.i.i = icmp slt i64 %.515.i.i.i, 1
  %7 = add nsw i64 %.13.i.i, 7
  %.831.i.i = lshr i64 %7, 3
  %.8521700.not1712.i.i = icmp eq i64 %.831.i.i, 0
  %.8521700.not.i.i = select i1 %.302246.not.i.i.i, i1 true, i1 %.8521700.not1712.i.i
  %8 = icmp eq i64 %.13.i.i, 1
  %9 = add nsw i64 %.13.i.i, -2
  %10 = lshr i64 %9, 1
  %11 = icmp eq i64 %10, 0
  %12 = add nuw nsw i64 %10, 1
  %13 = lshr i64 %12, 1
  %14 = mul nsw i64 %13, -2
  %15 = and i64 %9, 2
  %lcmp.mod.not.not.i.i = icmp eq i64 %15, 0
  %16 = and i64 %.13.i.i, 1
  %lcmp.mod.not.i.i.i = icmp eq i64 %16, 0
  %.neg.i.i.i = add nsw i64 %.13.i.i, 1
  %xtraiter23.i.i.i = and i64 %.515.i.i.i, 1
  %lcmp.mod24.not.i.i.i = icmp eq i64 %xtraiter23.i.i.i, 0
  %.567.prol.i.i.i = add nsw i64 %.515.i.i.i, -1
  %17 = lshr i64 %.13.i.i, 56
  %.610.prol.i.i.i = and i64 %17, 128
  %18 = getelementptr double, ptr %.54.i.i.i, i64 %.13.i.i
  %.624.prol.i.i.i = getelementptr double, ptr %18, i64 %.610.prol.i.i.i
  %19 = getelementptr double, ptr %.141.i.i.i, i64 %.13.i.i
  %.654.prol.i.i.i = getelementptr double, ptr %19, i64 %.610.prol.i.i.i
  %20 = icmp eq i64 %.neg.i.i.i, %.696.i.i
  %21 = add nuw nsw i64 %.831.i.i, 4
  br label %B334.if.i

B334.if.i:                                        ; preds = %_ZN17bnserve_inference14adjoint_kernel5_back10waves_backB4v492B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE.exit.i, %B334.if.lr.ph.i
  %lsr.iv136.i = phi ptr [ %scevgep135.i, %B334.if.lr.ph.i ], [ %scevgep137.i, %_ZN17bnserve_inference14adjoint_kernel5_back10waves_backB4v492B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE.exit.i ]
  %.470726730.i = phi i64 [ 0, %B334.if.lr.ph.i ], [ %.477.i, %_ZN17bnserve_inference14adjoint_kernel5_back10waves_backB4v492B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE.exit.i ]
  %22 = shl i64 %.470726730.i, 3
  %scevgep134.i = getelementptr i8, ptr %6, i64 %22
  %.602.i = load i64, ptr %scevgep134.i, align 8, !noalias !0
  %.idx713.i = mul i64 %.602.i, 27648
  %23 = getelementptr i8, ptr %.430, i64 %.idx713.i
  %.624.i = getelementptr i8, ptr %23, i64 14336
  %.90.i.i = load i64, ptr %.106, align 8, !noalias !3
  %.119.i.i = load i64, ptr %.140, align 8, !noalias !3
  %.149.i.i = load i64, ptr %.275.i132, align 8, !noalias !3
  %.150.i.i = mul nsw i64 %.90.i.i, %.7709701030
  %.151.i.i = add nsw i64 %.150.i.i, %.470726730.i
  %.152.i.i = shl nsw i64 %.151.i.i, 3
  %.153.i.i = add nsw i64 %.152.i.i, %.149.i.i
  %.154.i.i = inttoptr i64 %.153.i.i to ptr
  %.232.i.i = load double, ptr %.154.i.i, align 8, !noalias !3
  %.268.i.i = load i64, ptr %.365.i, align 8, !noalias !3
  %.271.i.i = shl nsw i64 %.151.i.i, 4
  %.272.i.i = add nsw i64 %.268.i.i, %.271.i.i
  %.273.i.i = inttoptr i64 %.272.i.i to ptr
  %.349.i.i = load double, ptr %.273.i.i, align 8, !noalias !3
  %.377.i.i = getelementptr i8, ptr %.273.i.i, i64 8
  %.378.i.i = load double, ptr %.377.i.i, align 8, !noalias !3
  %.417.i.i = load i64, ptr %.178.i, align 8, !noalias !3
  %.420.i.i = mul nsw i64 %.151.i.i, %.119.i.i
  %.421.i.i = add nsw i64 %.420.i.i, %.1090933952
  %.422.i.i = shl nsw i64 %.421.i.i, 4
  %.423.i.i = add nsw i64 %.417.i.i, %.422.i.i
  %.502.i.i = load i64, ptr %.501.i.i, align 8, !noalias !3
  br i1 %.302246.not.i.i.i, label %B212.i.i.i, label %B144.if.preheader.i.i.i

B144.if.preheader.i.i.i:                          ; preds = %B334.if.i
  br i1 %8, label %B144.if.epil.preheader.i.i.i, label %B144.if.preheader.new.i.i.i

B144.if.preheader.new.i.i.i:                      ; preds = %B144.if.preheader.i.i.i
  %24 = inttoptr i64 %.423.i.i to ptr
  %scevgep35.i.i.i = getelementptr i8, ptr %24, i64 24
  br i1 %11, label %B144.if.i.epil.preheader.i.i, label %B144.if.preheader.new.i.new.i.i

B144.if.preheader.new.i.new.i.i:                  ; preds = %B144.if.preheader.new.i.i.i
  %scevgep409.i.i = getelementptr i8, ptr %24, i64 56
  br label %B144.if.i.i.i

B212.loopexit.unr-lcssa.i.unr-lcssa.i.i:          ; preds = %B144.if.i.i.i
  %scevgep27.i.i = getelementptr i8, ptr %lsr.iv410.i.i, i64 32
  br i1 %lcmp.mod.not.not.i.i, label %B144.if.i.epil.preheader.i.i, label %B212.loopexit.unr-lcssa.i.i.i

B144.if.i.epil.preheader.i.i:                     ; preds = %B212.loopexit.unr-lcssa.i.unr-lcssa.i.i, %B144.if.preheader.new.i.i.i
  %lsr.iv36.i.epil.init.i.i = phi ptr [ %scevgep35.i.i.i, %B144.if.preheader.new.i.i.i ], [ %scevgep27.i.i, %B212.loopexit.unr-lcssa.i.unr-lcssa.i.i ]
  %.308245247.i.epil.init.i.i = phi i64 [ 0, %B144.if.preheader.new.i.i.i ], [ %.315.1.i.1.i.i, %B212.loopexit.unr-lcssa.i.unr-lcssa.i.i ]
  %scevgep39.i.epil.i.i = getelementptr i8, ptr %lsr.iv36.i.epil.init.i.i, i64 -24
  %.370.i.epil.i.i = load double, ptr %scevgep39.i.epil.i.i, align 8, !noalias !6
  %sunkaddr.i.epil.i.i = shl i64 %.308245247.i.epil.init.i.i, 3
  %sunkaddr49.i.epil.i.i = getelementptr i8, ptr %.430, i64 %sunkaddr.i.epil.i.i
  %sunkaddr50.i.epil.i.i = getelementptr i8, ptr %sunkaddr49.i.epil.i.i, i64 10240
  store double %.370.i.epil.i.i, ptr %sunkaddr50.i.epil.i.i, align 8, !noalias !6
  %scevgep40.i.epil.i.i = getelementptr i8, ptr %lsr.iv36.i.epil.init.i.i, i64 -16
  %.432.i.epil.i.i = load double, ptr %scevgep40.i.epil.i.i, align 8, !noalias !6
  %sunkaddr53.i.epil.i.i = getelementptr i8, ptr %sunkaddr49.i.epil.i.i, i64 11264
  store double %.432.i.epil.i.i, ptr %sunkaddr53.i.epil.i.i, align 8, !noalias !6
  %.315.1.i.epil.i.i = add nuw i64 %.308245247.i.epil.init.i.i, 2
  %scevgep38.i.epil.i.i = getelementptr i8, ptr %lsr.iv36.i.epil.init.i.i, i64 -8
  %.370.1.i.epil.i.i = load double, ptr %scevgep38.i.epil.i.i, align 8, !noalias !6
  %sunkaddr56.i.epil.i.i = getelementptr i8, ptr %sunkaddr49.i.epil.i.i, i64 10248
  store double %.370.1.i.epil.i.i, ptr %sunkaddr56.i.epil.i.i, align 8, !noalias !6
  %.432.1.i.epil.i.i = load double, ptr %lsr.iv36.i.epil.init.i.i, align 8, !noalias !6
  %sunkaddr59.i.epil.i.i = getelementptr i8, ptr %sunkaddr49.i.epil.i.i, i64 11272
  store double %.432.1.i.epil.i.i, ptr %sunkaddr59.i.epil.i.i, align 8, !noalias !6
  br label %B212.loopexit.unr-lcssa.i.i.i

B212.loopexit.unr-lcssa.i.i.i:                    ; preds = %B144.if.i.epil.preheader.i.i, %B212.loopexit.unr-lcssa.i.unr-lcssa.i.i
  %.315.1.i.lcssa.i.i = phi i64 [ %.315.1.i.epil.i.i, %B144.if.i.epil.preheader.i.i ], [ %.315.1.i.1.i.i, %B212.loopexit.unr-lcssa.i.unr-lcssa.i.i ]
  br i1 %lcmp.mod.not.i.i.i, label %B212.i.i.i, label %B144.if.epil.preheader.i.i.i

B144.if.epil.preheader.i.i.i:                     ; preds = %B212.loopexit.unr-lcssa.i.i.i, %B144.if.preheader.i.i.i
  %.308245247.epil.init.i.i.i = phi i64 [ 0, %B144.if.preheader.i.i.i ], [ %.315.1.i.lcssa.i.i, %B212.loopexit.unr-lcssa.i.i.i ]
  %25 = inttoptr i64 %.423.i.i to ptr
  %.idx.epil.i.i.i = shl i64 %.308245247.epil.init.i.i.i, 4
  %26 = getelementptr i8, ptr %25, i64 %.idx.epil.i.i.i
  %.370.epil.i.i.i = load double, ptr %26, align 8, !noalias !6
  %27 = getelementptr double, ptr %.54.i.i.i, i64 %.308245247.epil.init.i.i.i
  store double %.370.epil.i.i.i, ptr %27, align 8, !noalias !6
  %28 = getelementptr i8, ptr %26, i64 8
  %.432.epil.i.i.i = load double, ptr %28, align 8, !noalias !6
  %29 = getelementptr double, ptr %.141.i.i.i, i64 %.308245247.epil.init.i.i.i
  store double %.432.epil.i.i.i, ptr %29, align 8, !noalias !6
  br label %B212.i.i.i

B212.i.i.i:                                       ; preds = %B144.if.epil.preheader.i.i.i, %B212.loopexit.unr-lcssa.i.i.i, %B334.if.i
  br i1 %.558252.not.i.i.i, label %B0.endif.endif.endif.endif.endif.endif.endif.i.i, label %B244.if.preheader.i.i.i

B244.if.preheader.i.i.i:                          ; preds = %B212.i.i.i
  br i1 %lcmp.mod24.not.i.i.i, label %B244.if.prol.loopexit.i.i.i, label %B244.if.prol.i.i.i

B244.if.prol.i.i.i:                               ; preds = %B244.if.preheader.i.i.i
  store double 0.000000e+00, ptr %.624.prol.i.i.i, align 8, !noalias !6
  store double 0.000000e+00, ptr %.654.prol.i.i.i, align 8, !noalias !6
  br label %B244.if.prol.loopexit.i.i.i

B244.if.prol.loopexit.i.i.i:                      ; preds = %B244.if.prol.i.i.i, %B244.if.preheader.i.i.i
  %.557250254.unr.i.i.i = phi i64 [ %.515.i.i.i, %B244.if.preheader.i.i.i ], [ %.567.prol.i.i.i, %B244.if.prol.i.i.i ]
  %.564251253.unr.i.i.i = phi i64 [ %.13.i.i, %B244.if.preheader.i.i.i ], [ %.neg.i.i.i, %B244.if.prol.i.i.i ]
  br i1 %20, label %B0.endif.endif.endif.endif.endif.endif.endif.i.i, label %B244.if.preheader25.i.i.i

B244.if.preheader25.i.i.i:                        ; preds = %B244.if.prol.loopexit.i.i.i
  %30 = add nuw i64 %.557250254.unr.i.i.i, 2
  %31 = add nsw i64 %.564251253.unr.i.i.i, 1
  br label %B244.if.i.i.i

B144.if.i.i.i:                                    ; preds = %B144.if.i.i.i, %B144.if.preheader.new.i.new.i.i
  %lsr.iv25.i.i = phi i64 [ %lsr.iv.next26.i.i, %B144.if.i.i.i ], [ %14, %B144.if.preheader.new.i.new.i.i ]
  %lsr.iv410.i.i = phi ptr [ %scevgep411.i.i, %B144.if.i.i.i ], [ %scevgep409.i.i, %B144.if.preheader.new.i.new.i.i ]
  %.308245247.i.i.i = phi i64 [ %.315.1.i.1.i.i, %B144.if.i.i.i ], [ 0, %B144.if.preheader.new.i.new.i.i ]
  %scevgep416.i.i = getelementptr i8, ptr %lsr.iv410.i.i, i64 -32
  %scevgep419.i.i = getelementptr i8, ptr %lsr.iv410.i.i, i64 -56
  %.370.i.i.i = load double, ptr %scevgep419.i.i, align 8, !noalias !6
  %sunkaddr45.i.i = shl i64 %.308245247.i.i.i, 3
  %sunkaddr46.i.i = getelementptr i8, ptr %.430, i64 %sunkaddr45.i.i
  %sunkaddr47.i.i = getelementptr i8, ptr %sunkaddr46.i.i, i64 10240
  store double %.370.i.i.i, ptr %sunkaddr47.i.i, align 8, !noalias !6
  %scevgep418.i.i = getelementptr i8, ptr %lsr.iv410.i.i, i64 -48
  %.432.i.i.i = load double, ptr %scevgep418.i.i, align 8, !noalias !6
  %sunkaddr49.i.i = getelementptr i8, ptr %sunkaddr46.i.i, i64 11264
  store double %.432.i.i.i, ptr %sunkaddr49.i.i, align 8, !noalias !6
  %scevgep417.i.i = getelementptr i8, ptr %lsr.iv410.i.i, i64 -40
  %.370.1.i.i.i = load double, ptr %scevgep417.i.i, align 8, !noalias !6
  %sunkaddr52.i.i = getelementptr i8, ptr %sunkaddr46.i.i, i64 10248
  store double %.370.1.i.i.i, ptr %sunkaddr52.i.i, align 8, !noalias !6
  %.432.1.i.i.i = load double, ptr %scevgep416.i.i, align 8, !noalias !6
  %sunkaddr55.i.i = getelementptr i8, ptr %sunkaddr46.i.i, i64 11272
  store double %.432.1.i.i.i, ptr %sunkaddr55.i.i, align 8, !noalias !6
  %scevgep415.i.i = getelementptr i8, ptr %lsr.iv410.i.i, i64 -24
  %.370.i.1.i.i = load double, ptr %scevgep415.i.i, align 8, !noalias !6
  %sunkaddr58.i.i = getelementptr i8, ptr %sunkaddr46.i.i, i64 10256
  store double %.370.i.1.i.i, ptr %sunkaddr58.i.i, align 8, !noalias !6
  %scevgep414.i.i = getelementptr i8, ptr %lsr.iv410.i.i, i64 -16
  %.432.i.1.i.i = load double, ptr %scevgep414.i.i, align 8, !noalias !6
  %sunkaddr61.i.i = getelementptr i8, ptr %sunkaddr46.i.i, i64 11280
  store double %.432.i.1.i.i, ptr %sunkaddr61.i.i, align 8, !noalias !6
  %.315.1.i.1.i.i = add i64 %.308245247.i.i.i, 4
  %scevgep413.i.i = getelementptr i8, ptr %lsr.iv410.i.i, i64 -8
  %.370.1.i.1.i.i = load double, ptr %scevgep413.i.i, align 8, !noalias !6
  %sunkaddr62.i.i = shl i64 %.315.1.i.1.i.i, 3
  %sunkaddr63.i.i = getelementptr i8, ptr %.430, i64 %sunkaddr62.i.i
  %sunkaddr64.i.i = getelementptr i8, ptr %sunkaddr63.i.i, i64 10232
  store double %.370.1.i.1.i.i, ptr %sunkaddr64.i.i, align 8, !noalias !6
  %.432.1.i.1.i.i = load double, ptr %lsr.iv410.i.i, align 8, !noalias !6
  %sunkaddr67.i.i = getelementptr i8, ptr %sunkaddr63.i.i, i64 11256
  store double %.432.1.i.1.i.i, ptr %sunkaddr67.i.i, align 8, !noalias !6
  %scevgep411.i.i = getelementptr i8, ptr %lsr.iv410.i.i, i64 64
  %lsr.iv.next26.i.i = add i64 %lsr.iv25.i.i, 2
  %niter.ncmp.1.i.i = icmp eq i64 %lsr.iv.next26.i.i, 0
  br i1 %niter.ncmp.1.i.i, label %B212.loopexit.unr-lcssa.i.unr-lcssa.i.i, label %B144.if.i.i.i

B244.if.i.i.i:                                    ; preds = %B244.if.i.i.i, %B244.if.preheader25.i.i.i
  %lsr.iv30.i.i.i = phi i64 [ %lsr.iv.next31.i.i.i, %B244.if.i.i.i ], [ %31, %B244.if.preheader25.i.i.i ]
  %lsr.iv.i.i.i = phi i64 [ %lsr.iv.next.i.i.i, %B244.if.i.i.i ], [ %30, %B244.if.preheader25.i.i.i ]
  %.564251253.i.i.i = phi i64 [ %.571.1.i.i.i, %B244.if.i.i.i ], [ %.564251253.unr.i.i.i, %B244.if.preheader25.i.i.i ]
  %32 = lshr i64 %lsr.iv30.i.i.i, 53
  %33 = and i64 %32, 1024
  %34 = lshr i64 %.564251253.i.i.i, 53
  %35 = and i64 %34, 1024
  %36 = getelementptr i8, ptr %.430, i64 %35
  %scevgep19.i.i = getelementptr i8, ptr %36, i64 11264
  %37 = shl i64 %.564251253.i.i.i, 3
  %scevgep24.i.i = getelementptr i8, ptr %scevgep19.i.i, i64 %37
  %scevgep18.i.i = getelementptr i8, ptr %scevgep24.i.i, i64 -1024
  store double 0.000000e+00, ptr %scevgep18.i.i, align 8, !noalias !6
  store double 0.000000e+00, ptr %scevgep24.i.i, align 8, !noalias !6
  %.571.1.i.i.i = add i64 %.564251253.i.i.i, 2
  %38 = getelementptr i8, ptr %.430, i64 %33
  %scevgep11.i.i = getelementptr i8, ptr %38, i64 11272
  %scevgep12.i.i = getelementptr i8, ptr %scevgep11.i.i, i64 %37
  %scevgep13.i.i = getelementptr i8, ptr %scevgep12.i.i, i64 -1024
  store double 0.000000e+00, ptr %scevgep13.i.i, align 8, !noalias !6
  store double 0.000000e+00, ptr %scevgep12.i.i, align 8, !noalias !6
  %lsr.iv.next.i.i.i = add i64 %lsr.iv.i.i.i, -2
  %lsr.iv.next31.i.i.i = add i64 %lsr.iv30.i.i.i, 2
  %.558.1.i.i.i = icmp sgt i64 %lsr.iv.next.i.i.i, 2
  br i1 %.558.1.i.i.i, label %B244.if.i.i.i, label %B0.endif.endif.endif.endif.endif.endif.endif.i.i

B0.endif.endif.endif.endif.endif.endif.endif.i.i: ; preds = %B244.if.i.i.i, %B244.if.prol.loopexit.i.i.i, %B212.i.i.i
  br i1 %.8521700.not.i.i, label %_ZN17bnserve_inference14adjoint_kernel5_back10waves_backB4v492B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE.exit.i, label %B774.if.lr.ph.i.i

B774.if.lr.ph.i.i:                                ; preds = %B0.endif.endif.endif.endif.endif.endif.endif.i.i
  %.1458.i.i = fneg contract double %.378.i.i
  %.1494.i.i = fneg contract double %.349.i.i
  %.1492.i.i = fneg contract double %.232.i.i
  %.1488.i.i = insertelement <8 x double> poison, double %.232.i.i, i64 0
  %.1489.i.i = shufflevector <8 x double> %.1488.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1484.i.i = insertelement <8 x double> poison, double %.349.i.i, i64 0
  %.1485.i.i = shufflevector <8 x double> %.1484.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1521.i.i = insertelement <8 x double> poison, double %.1494.i.i, i64 0
  %.1522.i.i = shufflevector <8 x double> %.1521.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1524.i.i = insertelement <8 x double> poison, double %.1492.i.i, i64 0
  %.1525.i.i = shufflevector <8 x double> %.1524.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.6.i.i.i = insertelement <8 x double> poison, double %.1458.i.i, i64 0
  %.7.i.i.i = shufflevector <8 x double> %.6.i.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  br label %B774.if.i.i

B774.if.i.i:                                      ; preds = %B774.if.i.i, %B774.if.lr.ph.i.i
  %lsr.iv.i.i = phi i64 [ %lsr.iv.next.i.i, %B774.if.i.i ], [ %21, %B774.if.lr.ph.i.i ]
  %lsr.iv386.i.i = phi i64 [ %lsr.iv.next387.i.i, %B774.if.i.i ], [ 0, %B774.if.lr.ph.i.i ]
  %d.2.01706.i.i = phi <8 x double> [ %.6.i294.i.i, %B774.if.i.i ], [ zeroinitializer, %B774.if.lr.ph.i.i ]
  %c.2.01705.i.i = phi <8 x double> [ %.6.i292.i.i, %B774.if.i.i ], [ zeroinitializer, %B774.if.lr.ph.i.i ]
  %b.2.01704.i.i = phi <8 x double> [ %.6.i288.i.i, %B774.if.i.i ], [ zeroinitializer, %B774.if.lr.ph.i.i ]
  %a.2.01703.i.i = phi <8 x double> [ %.6.i286.i.i, %B774.if.i.i ], [ zeroinitializer, %B774.if.lr.ph.i.i ]
  %sunkaddr68.i.i = getelementptr i8, ptr %.624.i, i64 %lsr.iv386.i.i
  %sunkaddr69.i.i = getelementptr i8, ptr %sunkaddr68.i.i, i64 22528
  %.980.i.i = load <8 x double>, ptr %sunkaddr69.i.i, align 8, !noalias !3
  %sunkaddr71.i.i = getelementptr i8, ptr %sunkaddr68.i.i, i64 23552
  %.1075.i.i = load <8 x double>, ptr %sunkaddr71.i.i, align 8, !noalias !3
  %sunkaddr73.i.i = getelementptr i8, ptr %sunkaddr68.i.i, i64 24576
  %.1169.i.i = load <8 x double>, ptr %sunkaddr73.i.i, align 8, !noalias !3
  %sunkaddr75.i.i = getelementptr i8, ptr %sunkaddr68.i.i, i64 25600
  %.1264.i.i = load <8 x double>, ptr %sunkaddr75.i.i, align 8, !noalias !3
  %scevgep389.i.i = getelementptr i8, ptr %.141.i.i.i, i64 %lsr.iv386.i.i
  %scevgep390.i.i = getelementptr i8, ptr %scevgep389.i.i, i64 -1024
  %.1358.i.i = load <8 x double>, ptr %scevgep390.i.i, align 8, !noalias !3
  %.1453.i.i = load <8 x double>, ptr %scevgep389.i.i, align 8, !noalias !3
  %.8.i.i.i = fmul contract <8 x double> %.7.i.i.i, %.1264.i.i
  %.8.i282.i.i = fmul contract <8 x double> %.7.i.i.i, %.1169.i.i
  %.1486.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1169.i.i, <8 x double> %.1485.i.i, <8 x double> %.8.i.i.i)
  %.1490.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.980.i.i, <8 x double> %.1489.i.i, <8 x double> %.1486.i.i)
  %.1523.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1264.i.i, <8 x double> %.1522.i.i, <8 x double> %.8.i282.i.i)
  %.1526.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1075.i.i, <8 x double> %.1525.i.i, <8 x double> %.1523.i.i)
  %39 = shl i64 %lsr.iv386.i.i, 1
  %scevgep.i.i = getelementptr i8, ptr %lsr.iv136.i, i64 %39
  %.1536.i.i = shufflevector <8 x double> %.1490.i.i, <8 x double> %.1526.i.i, <16 x i32> <i32 0, i32 8, i32 1, i32 9, i32 2, i32 10, i32 3, i32 11, i32 4, i32 12, i32 5, i32 13, i32 6, i32 14, i32 7, i32 15>
  store <16 x double> %.1536.i.i, ptr %scevgep.i.i, align 4, !noalias !3
  %.6.i283.i.i = fmul contract <8 x double> %.980.i.i, %.1358.i.i
  %.6.i284.i.i = fmul contract <8 x double> %.1075.i.i, %.1453.i.i
  %.6.i285.i.i = fsub contract <8 x double> %.6.i283.i.i, %.6.i284.i.i
  %.6.i286.i.i = fadd contract <8 x double> %a.2.01703.i.i, %.6.i285.i.i
  %.6.i287.i.i = fmul contract <8 x double> %.1075.i.i, %.1358.i.i
  %.1660.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.980.i.i, <8 x double> %.1453.i.i, <8 x double> %.6.i287.i.i)
  %.6.i288.i.i = fadd contract <8 x double> %b.2.01704.i.i, %.1660.i.i
  %.6.i289.i.i = fmul contract <8 x double> %.1169.i.i, %.1358.i.i
  %.6.i290.i.i = fmul contract <8 x double> %.1264.i.i, %.1453.i.i
  %.6.i291.i.i = fsub contract <8 x double> %.6.i289.i.i, %.6.i290.i.i
  %.6.i292.i.i = fadd contract <8 x double> %c.2.01705.i.i, %.6.i291.i.i
  %.6.i293.i.i = fmul contract <8 x double> %.1264.i.i, %.1358.i.i
  %.1811.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1169.i.i, <8 x double> %.1453.i.i, <8 x double> %.6.i293.i.i)
  %.6.i294.i.i = fadd contract <8 x double> %d.2.01706.i.i, %.1811.i.i
  %lsr.iv.next387.i.i = add i64 %lsr.iv386.i.i, 64
  %lsr.iv.next.i.i = add nsw i64 %lsr.iv.i.i, -1
  %.852.i.i = icmp sgt i64 %lsr.iv.i.i, 5
  br i1 %.852.i.i, label %B774.if.i.i, label %_ZN17bnserve_inference14adjoint_kernel5_back10waves_backB4v492B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE.exit.i

_ZN17bnserve_inference14adjoint_kernel5_back10waves_backB4v492B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE.exit.i: ; preds = %B774.if.i.i, %B0.endif.endif.endif.endif.endif.endif.endif.i.i
  %a.2.0.lcssa.i.i = phi <8 x double> [ zeroinitializer, %B0.endif.endif.endif.endif.endif.endif.endif.i.i ], [ %.6.i286.i.i, %B774.if.i.i ]
  %b.2.0.lcssa.i.i = phi <8 x double> [ zeroinitializer, %B0.endif.endif.endif.endif.endif.endif.endif.i.i ], [ %.6.i288.i.i, %B774.if.i.i ]
  %c.2.0.lcssa.i.i = phi <8 x double> [ zeroinitializer, %B0.endif.endif.endif.endif.endif.endif.endif.i.i ], [ %.6.i292.i.i, %B774.if.i.i ]
  %d.2.0.lcssa.i.i = phi <8 x double> [ zeroinitializer, %B0.endif.endif.endif.endif.endif.endif.endif.i.i ], [ %.6.i294.i.i, %B774.if.i.i ]
  %.508.i.i = shl nsw i64 %.151.i.i, 5
  %.509.i.i = add nsw i64 %.502.i.i, %.508.i.i
  %.510.i.i = inttoptr i64 %.509.i.i to ptr
  %.1896.i.i = load double, ptr %.510.i.i, align 8, !noalias !3
  store <8 x double> %a.2.0.lcssa.i.i, ptr %.586, align 8, !noalias !3
  %.1942.i.i = load double, ptr %.586, align 8, !noalias !3
  %.1971.i.i = load double, ptr %.1970.i.i, align 8, !noalias !3
  %.1972.i.i = fadd contract double %.1942.i.i, %.1971.i.i
  %.2001.i.i = load double, ptr %.2000.i.i, align 8, !noalias !3
  %.2030.i.i = load double, ptr %.2029.i.i, align 8, !noalias !3
  %.2031.i.i = fadd contract double %.2001.i.i, %.2030.i.i
  %.2032.i.i = fadd contract double %.1972.i.i, %.2031.i.i
  %.2061.i.i = load double, ptr %.2060.i.i, align 8, !noalias !3
  %.2090.i.i = load double, ptr %.2089.i.i, align 8, !noalias !3
  %.2091.i.i = fadd contract double %.2061.i.i, %.2090.i.i
  %.2120.i.i = load double, ptr %.2119.i.i, align 8, !noalias !3
  %.2149.i.i = load double, ptr %.2148.i.i, align 8, !noalias !3
  %.2153.i.i = fadd contract double %.2120.i.i, %.2149.i.i
  %.2154.i.i = fadd contract double %.2091.i.i, %.2153.i.i
  %.2155.i.i = fadd contract double %.2032.i.i, %.2154.i.i
  %.2156.i.i = fadd contract double %.1896.i.i, %.2155.i.i
  store double %.2156.i.i, ptr %.510.i.i, align 8, !noalias !3
  %.2215.i.i = getelementptr i8, ptr %.510.i.i, i64 8
  %.2216.i.i = load double, ptr %.2215.i.i, align 8, !noalias !3
  store <8 x double> %b.2.0.lcssa.i.i, ptr %.586, align 8, !noalias !3
  %.2262.i.i = load double, ptr %.586, align 8, !noalias !3
  %.2291.i.i = load double, ptr %.1970.i.i, align 8, !noalias !3
  %.2292.i.i = fadd contract double %.2262.i.i, %.2291.i.i
  %.2321.i.i = load double, ptr %.2000.i.i, align 8, !noalias !3
  %.2350.i.i = load double, ptr %.2029.i.i, align 8, !noalias !3
  %.2351.i.i = fadd contract double %.2321.i.i, %.2350.i.i
  %.2352.i.i = fadd contract double %.2292.i.i, %.2351.i.i
  %.2381.i.i = load double, ptr %.2060.i.i, align 8, !noalias !3
  %.2410.i.i = load double, ptr %.2089.i.i, align 8, !noalias !3
  %.2411.i.i = fadd contract double %.2381.i.i, %.2410.i.i
  %.2440.i.i = load double, ptr %.2119.i.i, align 8, !noalias !3
  %.2469.i.i = load double, ptr %.2148.i.i, align 8, !noalias !3
  %.2473.i.i = fadd contract double %.2440.i.i, %.2469.i.i
  %.2474.i.i = fadd contract double %.2411.i.i, %.2473.i.i
  %.2475.i.i = fadd contract double %.2352.i.i, %.2474.i.i
  %.2476.i.i = fadd contract double %.2216.i.i, %.2475.i.i
  store double %.2476.i.i, ptr %.2215.i.i, align 8, !noalias !3
  %.2535.i.i = getelementptr i8, ptr %.510.i.i, i64 16
  %.2536.i.i = load double, ptr %.2535.i.i, align 8, !noalias !3
  store <8 x double> %c.2.0.lcssa.i.i, ptr %.586, align 8, !noalias !3
  %.2582.i.i = load double, ptr %.586, align 8, !noalias !3
  %.2611.i.i = load double, ptr %.1970.i.i, align 8, !noalias !3
  %.2612.i.i = fadd contract double %.2582.i.i, %.2611.i.i
  %.2641.i.i = load double, ptr %.2000.i.i, align 8, !noalias !3
  %.2670.i.i = load double, ptr %.2029.i.i, align 8, !noalias !3
  %.2671.i.i = fadd contract double %.2641.i.i, %.2670.i.i
  %.2672.i.i = fadd contract double %.2612.i.i, %.2671.i.i
  %.2701.i.i = load double, ptr %.2060.i.i, align 8, !noalias !3
  %.2730.i.i = load double, ptr %.2089.i.i, align 8, !noalias !3
  %.2731.i.i = fadd contract double %.2701.i.i, %.2730.i.i
  %.2760.i.i = load double, ptr %.2119.i.i, align 8, !noalias !3
  %.2789.i.i = load double, ptr %.2148.i.i, align 8, !noalias !3
  %.2793.i.i = fadd contract double %.2760.i.i, %.2789.i.i
  %.2794.i.i = fadd contract double %.2731.i.i, %.2793.i.i
  %.2795.i.i = fadd contract double %.2672.i.i, %.2794.i.i
  %.2796.i.i = fadd contract double %.2536.i.i, %.2795.i.i
  store double %.2796.i.i, ptr %.2535.i.i, align 8, !noalias !3
  %.2855.i.i = getelementptr i8, ptr %.510.i.i, i64 24
  %.2856.i.i = load double, ptr %.2855.i.i, align 8, !noalias !3
  store <8 x double> %d.2.0.lcssa.i.i, ptr %.586, align 8, !noalias !3
  %.2907.i.i = load double, ptr %.586, align 8, !noalias !3
  %.2936.i.i = load double, ptr %.1970.i.i, align 8, !noalias !3
  %.2937.i.i = fadd contract double %.2907.i.i, %.2936.i.i
  %.2966.i.i = load double, ptr %.2000.i.i, align 8, !noalias !3
  %.2995.i.i = load double, ptr %.2029.i.i, align 8, !noalias !3
  %.2996.i.i = fadd contract double %.2966.i.i, %.2995.i.i
  %.2997.i.i = fadd contract double %.2937.i.i, %.2996.i.i
  %.3026.i.i = load double, ptr %.2060.i.i, align 8, !noalias !3
  %.3055.i.i = load double, ptr %.2089.i.i, align 8, !noalias !3
  %.3056.i.i = fadd contract double %.3026.i.i, %.3055.i.i
  %.3085.i.i = load double, ptr %.2119.i.i, align 8, !noalias !3
  %.3114.i.i = load double, ptr %.2148.i.i, align 8, !noalias !3
  %.3118.i.i = fadd contract double %.3085.i.i, %.3114.i.i
  %.3119.i.i = fadd contract double %.3056.i.i, %.3118.i.i
  %.3120.i.i = fadd contract double %.2997.i.i, %.3119.i.i
  %.3121.i.i = fadd contract double %.2856.i.i, %.3120.i.i
  store double %.3121.i.i, ptr %.2855.i.i, align 8, !noalias !3
  %.477.i = add nuw nsw i64 %.470726730.i, 1
  %scevgep137.i = getelementptr i8, ptr %lsr.iv136.i, i64 %5
  %exitcond.not.i1 = icmp eq i64 %.84.i, %.477.i
  br i1 %exitcond.not.i1, label %B482.i, label %B334.if.i

B632.if.lr.ph.i:                                  ; preds = %B482.i
  %.814.i = load i64, ptr %.813.i, align 8, !noalias !0
  %.815.i = inttoptr i64 %.814.i to ptr
  %.890.i = getelementptr i8, ptr %.815.i, i64 8
  %.891.i = load double, ptr %.890.i, align 8, !noalias !0
  %.1049.i = mul nuw nsw i64 %.114.i, %.7709701030
  %.1346.i = lshr exact i64 %.13.i, 3
  %.1325.inv.i = icmp sgt i64 %.1127, 0
  %storemerge712.i = select i1 %.1325.inv.i, i64 %.1346.i, i64 0
  %.6.i.i = insertelement <8 x double> poison, double %.891.i, i64 0
  %.7.i.i = shufflevector <8 x double> %.6.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %40 = and i64 %storemerge712.i, 2305843009213693950
  %trunc.i = trunc nuw i64 %storemerge712.i to i61
  %41 = and i64 %storemerge712.i, 1
  %42 = icmp eq i64 %41, 0
  br label %B632.if.i

B632.if.i:                                        ; preds = %B632.if.lr.ph.i, %B934.i
  %lsr.iv.i3 = phi ptr [ %scevgep.i2, %B632.if.lr.ph.i ], [ %scevgep125.i, %B934.i ]
  %.984744761.i = phi i64 [ 0, %B632.if.lr.ph.i ], [ %.991.i, %B934.i ]
  %.991.i = add nuw nsw i64 %.984744761.i, 1
  %.1046.i = load i64, ptr %.780.i, align 8, !noalias !0
  %.1050.i = add nuw nsw i64 %.984744761.i, %.1049.i
  %43 = mul i64 %.1050.i, %.157.1.i
  %.1054.i = sub i64 %.1090933952, %43
  %.1055.i = shl nsw i64 %.1054.i, 3
  %.1056.i = add nsw i64 %.1055.i, %.1046.i
  %.idx.i = mul i64 %.984744761.i, 27648
  %44 = getelementptr i8, ptr %.430, i64 %.idx.i
  %.1218.i = getelementptr i8, ptr %44, i64 40960
  switch i61 %trunc.i, label %B860.if.preheader.i [
    i61 0, label %B934.i
    i61 1, label %B860.if.epil.preheader.i
  ]

B860.if.preheader.i:                              ; preds = %B632.if.i
  %45 = inttoptr i64 %.1056.i to ptr
  %scevgep129.i = getelementptr i8, ptr %45, i64 64
  br label %B860.if.i

B860.if.i:                                        ; preds = %B860.if.i, %B860.if.preheader.i
  %lsr.iv8.i = phi i64 [ %lsr.iv.next.i4, %B860.if.i ], [ %40, %B860.if.preheader.i ]
  %.1373734736.i = phi i64 [ %.1380.1.i, %B860.if.i ], [ 0, %B860.if.preheader.i ]
  %46 = shl i64 %.1373734736.i, 3
  %scevgep127.i = getelementptr i8, ptr %lsr.iv.i3, i64 %46
  %scevgep128.i = getelementptr i8, ptr %scevgep127.i, i64 -64
  %.1414.i = load <8 x double>, ptr %scevgep128.i, align 8, !noalias !0
  %.8.i.i = fmul contract <8 x double> %.7.i.i, %.1414.i
  %scevgep131.i = getelementptr i8, ptr %scevgep129.i, i64 %46
  %scevgep11.i = getelementptr i8, ptr %scevgep131.i, i64 -64
  store <8 x double> %.8.i.i, ptr %scevgep11.i, align 8, !noalias !0
  %.1414.1.i = load <8 x double>, ptr %scevgep127.i, align 8, !noalias !0
  %.8.i.1.i = fmul contract <8 x double> %.7.i.i, %.1414.1.i
  %.1380.1.i = add i64 %.1373734736.i, 16
  store <8 x double> %.8.i.1.i, ptr %scevgep131.i, align 8, !noalias !0
  %lsr.iv.next.i4 = add i64 %lsr.iv8.i, -2
  %niter.ncmp.1.not.i = icmp eq i64 %lsr.iv.next.i4, 0
  br i1 %niter.ncmp.1.not.i, label %B934.loopexit.unr-lcssa.i, label %B860.if.i

_ZN17bnserve_inference14adjoint_kernel7_source11_block_backB4v479B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit: ; preds = %B934.i, %B482.i
  %.1084 = icmp sgt i64 %.1083927953, 1
  br i1 %.1084, label %B918.if, label %B1254

B1254:                                            ; preds = %_ZN17bnserve_inference14adjoint_kernel7_source11_block_backB4v479B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit, %_ZN17bnserve_inference13moving_kernel8_passing12find_passingB3v59B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIxLi1E1C7mutable7alignedE.exit
  %.74.i = load i64, ptr %sunkaddr115, align 8, !noalias !9
  %.75.i = inttoptr i64 %.74.i to ptr
  %.152.i = getelementptr i8, ptr %.75.i, i64 8
  %.153.i = load double, ptr %.152.i, align 8, !noalias !9
  %.275.i = load i64, ptr %arg.arguments.4, align 8, !noalias !9
  %.358494.not.i = icmp slt i64 %.275.i, 1
  br i1 %.358494.not.i, label %B1254.endif, label %B244.if.lr.ph.i

B244.if.lr.ph.i:                                  ; preds = %B1254
  %.189.i = load i64, ptr %sunkaddr, align 8, !noalias !9
  %.191.i = mul nuw nsw i64 %.7709701030, 80
  %sunkaddr.i = inttoptr i64 %.189.i to ptr
  %sunkaddr62.i = getelementptr i8, ptr %sunkaddr.i, i64 %.191.i
  %sunkaddr63.i = getelementptr i8, ptr %sunkaddr62.i, i64 48
  %sunkaddr66.i = getelementptr i8, ptr %sunkaddr62.i, i64 56
  %sunkaddr69.i = getelementptr i8, ptr %sunkaddr62.i, i64 64
  %sunkaddr72.i = getelementptr i8, ptr %sunkaddr62.i, i64 72
  %sunkaddr63.promoted.i = load double, ptr %sunkaddr63.i, align 8, !noalias !9
  %sunkaddr66.promoted.i = load double, ptr %sunkaddr66.i, align 8, !noalias !9
  %sunkaddr69.promoted.i = load double, ptr %sunkaddr69.i, align 8, !noalias !9
  %sunkaddr72.promoted.i = load double, ptr %sunkaddr72.i, align 8, !noalias !9
  br label %B244.if.i

B244.if.i:                                        ; preds = %B244.if.i, %B244.if.lr.ph.i
  %.9954.i = phi double [ %sunkaddr72.promoted.i, %B244.if.lr.ph.i ], [ %.995.i, %B244.if.i ]
  %.9313.i = phi double [ %sunkaddr69.promoted.i, %B244.if.lr.ph.i ], [ %.931.i, %B244.if.i ]
  %.8382.i = phi double [ %sunkaddr66.promoted.i, %B244.if.lr.ph.i ], [ %.838.i, %B244.if.i ]
  %.7771.i = phi double [ %sunkaddr63.promoted.i, %B244.if.lr.ph.i ], [ %.777.i, %B244.if.i ]
  %lsr.iv61.i = phi i64 [ %.275.i, %B244.if.lr.ph.i ], [ %lsr.iv.next.i, %B244.if.i ]
  %lsr.iv59.i = phi ptr [ %scevgep58.i, %B244.if.lr.ph.i ], [ %scevgep60.i, %B244.if.i ]
  %lsr.iv.i = phi ptr [ %scevgep.i, %B244.if.lr.ph.i ], [ %scevgep51.i, %B244.if.i ]
  %.556.i = load double, ptr %lsr.iv.i, align 8, !noalias !9
  %scevgep52.i = getelementptr i8, ptr %lsr.iv.i, i64 -24
  %.585.i = load double, ptr %scevgep52.i, align 8, !noalias !9
  %.614.i = load double, ptr %lsr.iv59.i, align 8, !noalias !9
  %.618.i = fmul contract double %.556.i, %.614.i
  %.619.i = fadd contract double %.585.i, %.618.i
  %scevgep53.i = getelementptr i8, ptr %lsr.iv.i, i64 -16
  %.648.i = load double, ptr %scevgep53.i, align 8, !noalias !9
  %scevgep54.i = getelementptr i8, ptr %lsr.iv.i, i64 -64
  %.677.i = load double, ptr %scevgep54.i, align 8, !noalias !9
  %.678.i = fmul contract double %.556.i, %.677.i
  %.679.i = fadd contract double %.648.i, %.678.i
  %scevgep55.i = getelementptr i8, ptr %lsr.iv.i, i64 -32
  %.709.i = load double, ptr %scevgep55.i, align 8, !noalias !9
  %.711.i = fmul contract double %.153.i, %.709.i
  %.712.i = fmul contract double %.619.i, %.711.i
  %.713.i = fadd contract double %.679.i, %.712.i
  %scevgep56.i = getelementptr i8, ptr %lsr.iv.i, i64 -40
  %.742.i = load double, ptr %scevgep56.i, align 8, !noalias !9
  %.744.i = fmul contract double %.153.i, %.742.i
  %.745.i = fmul contract double %.619.i, %.744.i
  %.746.i = fadd contract double %.619.i, %.745.i
  %.777.i = fsub contract double %.7771.i, %.746.i
  store double %.777.i, ptr %sunkaddr63.i, align 8, !noalias !9
  %.838.i = fadd contract double %.8382.i, %.713.i
  store double %.838.i, ptr %sunkaddr66.i, align 8, !noalias !9
  %scevgep57.i = getelementptr i8, ptr %lsr.iv.i, i64 -8
  %.927.i = load double, ptr %scevgep57.i, align 8, !noalias !9
  %.931.i = fadd contract double %.9313.i, %.927.i
  store double %.931.i, ptr %sunkaddr69.i, align 8, !noalias !9
  %.993.i = fmul contract double %.153.i, %.746.i
  %.994.i = fadd contract double %.556.i, %.993.i
  %.995.i = fadd contract double %.9954.i, %.994.i
  store double %.995.i, ptr %sunkaddr72.i, align 8, !noalias !9
  %scevgep51.i = getelementptr i8, ptr %lsr.iv.i, i64 152
  %scevgep60.i = getelementptr i8, ptr %lsr.iv59.i, i64 200
  %lsr.iv.next.i = add i64 %lsr.iv61.i, -1
  %exitcond.not.i = icmp eq i64 %lsr.iv.next.i, 0
  br i1 %exitcond.not.i, label %B1254.endif, label %B244.if.i

B1334:                                            ; preds = %B1254.endif
  %.1639 = load i64, ptr %.193.i80, align 8
  %.1640 = icmp eq i64 %.1639, 0
  br i1 %.1640, label %B1378, label %B1412

B1378:                                            ; preds = %B1334
  %.64.i = load i64, ptr %.76, align 8, !noalias !12
  %.94.i = load i64, ptr %.140, align 8, !noalias !12
  %.124.i = load i64, ptr %.106, align 8, !noalias !12
  %.133.i = sub i64 0, %.94.i
  %.141.1.i = and i64 %.133.i, -8
  %.175.i = sub i64 0, %.141.1.i
  %.216.i = shl i64 %.94.i, 1
  %.390.i = load i64, ptr %.389.i, align 8, !noalias !12
  %.393.i = inttoptr i64 %.390.i to ptr
  %.518.i = getelementptr double, ptr %.393.i, i64 %.175.i
  %.667832.not.i = icmp slt i64 %.64.i, 1
  br i1 %.667832.not.i, label %B1412, label %B474.if.lr.ph.i

B1068.i:                                          ; preds = %_ZN17bnserve_inference14adjoint_kernel8_passing10_turn_backB4v532B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedExx8UniTupleIdLi3EE5ArrayIdLi1E1C7mutable7alignedE.exit.i, %B474.if.i
  %exitcond868.not.i = icmp eq i64 %.680.i, %.64.i
  br i1 %exitcond868.not.i, label %B1412, label %B474.if.i

B474.if.lr.ph.i:                                  ; preds = %B1378
  %.305.i = load i64, ptr %.304.i, align 8, !noalias !12
  %.210.i = shl i64 %.7709701030, 4
  %.212.i = mul i64 %.210.i, %.94.i
  %.214.i = mul i64 %.212.i, %.124.i
  %.209.i = load i64, ptr %.208.i, align 8, !noalias !12
  %.215.i = add nsw i64 %.209.i, %.214.i
  %.740.i = shl i64 %.175.i, 4
  %.973.i = mul nuw nsw i64 %.64.i, %.7709701030
  %.976.i = shl i64 %.175.i, 3
  %47 = tail call i64 @llvm.smax.i64(i64 %.94.i, i64 1)
  %48 = shl i64 %.133.i, 3
  %49 = and i64 %48, -64
  %50 = sub i64 8, %49
  %51 = icmp sgt i64 %.94.i, 1
  %52 = inttoptr i64 %.305.i to ptr
  %53 = inttoptr i64 %.215.i to ptr
  %.187.i.i = icmp sgt i64 %.124.i, 0
  %.218.i = shl i64 %.124.i, 3
  %54 = mul i64 %.218.i, %.216.i
  %55 = add i64 %54, 16
  %56 = add i64 %54, 24
  %57 = or disjoint i64 %54, 8
  %.699491.not.i.i = icmp slt i64 %.124.i, 1
  %58 = shl i64 %.94.i, 4
  %59 = lshr i64 %.133.i, 3
  %60 = mul i64 %59, -128
  br label %B474.if.i

B474.if.i:                                        ; preds = %B474.if.lr.ph.i, %B1068.i
  %.673815835.i = phi i64 [ 0, %B474.if.lr.ph.i ], [ %.680.i, %B1068.i ]
  %.680.i = add nuw nsw i64 %.673815835.i, 1
  br i1 %51, label %B766.if.preheader.i, label %B1068.i

B766.if.preheader.i:                              ; preds = %B474.if.i
  %.970.i = load i64, ptr %sunkaddr136, align 8, !noalias !12
  %.975.i = add nuw nsw i64 %.673815835.i, %.973.i
  %.978.i = mul i64 %.976.i, %.975.i
  %.979.i = add nsw i64 %.970.i, %.978.i
  %.738.i = load i64, ptr %sunkaddr27.i, align 8, !noalias !12
  %.742.i5 = mul i64 %.740.i, %.673815835.i
  %.743.i = add nsw i64 %.738.i, %.742.i5
  %61 = inttoptr i64 %.979.i to ptr
  %62 = inttoptr i64 %.743.i to ptr
  %scevgep.i6 = getelementptr i8, ptr %61, i64 8
  %scevgep139.i = getelementptr i8, ptr %62, i64 %50
  br label %B766.if.i

B766.if.i:                                        ; preds = %_ZN17bnserve_inference14adjoint_kernel8_passing10_turn_backB4v532B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedExx8UniTupleIdLi3EE5ArrayIdLi1E1C7mutable7alignedE.exit.i, %B766.if.preheader.i
  %.1122805807.i = phi i64 [ %77, %_ZN17bnserve_inference14adjoint_kernel8_passing10_turn_backB4v532B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedExx8UniTupleIdLi3EE5ArrayIdLi1E1C7mutable7alignedE.exit.i ], [ 0, %B766.if.preheader.i ]
  %sunkaddr28.i = shl i64 %.1122805807.i, 3
  %sunkaddr29.i = getelementptr i8, ptr %62, i64 %sunkaddr28.i
  %sunkaddr30.i = getelementptr i8, ptr %sunkaddr29.i, i64 8
  %.1184.i = load double, ptr %sunkaddr30.i, align 8, !noalias !12
  %.1214.i = load double, ptr %sunkaddr29.i, align 8, !noalias !12
  %.1215.i = fmul contract double %.1184.i, %.1214.i
  %scevgep22.i = getelementptr i8, ptr %scevgep139.i, i64 %sunkaddr28.i
  %.1246.i = load double, ptr %scevgep22.i, align 8, !noalias !12
  %scevgep21.i = getelementptr i8, ptr %scevgep22.i, i64 -8
  %.1276.i = load double, ptr %scevgep21.i, align 8, !noalias !12
  %.1277.i = fmul contract double %.1246.i, %.1276.i
  %.1278.i = fadd contract double %.1215.i, %.1277.i
  %.1340.i = fmul contract double %.1184.i, %.1276.i
  %.1402.i = fmul contract double %.1214.i, %.1246.i
  %.1403.i = fsub contract double %.1340.i, %.1402.i
  %scevgep18.i = getelementptr i8, ptr %.393.i, i64 %sunkaddr28.i
  %scevgep19.i = getelementptr i8, ptr %scevgep18.i, i64 8
  %.1434.i = load double, ptr %scevgep19.i, align 8, !noalias !12
  %scevgep16.i = getelementptr i8, ptr %scevgep.i6, i64 %sunkaddr28.i
  %.1465.i = load double, ptr %scevgep16.i, align 8, !noalias !12
  %.1466.i = fmul contract double %.1434.i, %.1465.i
  %scevgep17.i = getelementptr i8, ptr %.518.i, i64 %sunkaddr28.i
  %.1496.i = load double, ptr %scevgep17.i, align 8, !noalias !12
  %scevgep13.i = getelementptr i8, ptr %scevgep16.i, i64 -8
  %.1526.i = load double, ptr %scevgep13.i, align 8, !noalias !12
  %.1527.i = fmul contract double %.1496.i, %.1526.i
  %.1528.i = fadd contract double %.1466.i, %.1527.i
  %.1529.i = fneg contract double %.1528.i
  br i1 %.187.i.i, label %B106.if.lr.ph.i.i, label %B242.i.i

B106.if.lr.ph.i.i:                                ; preds = %B766.if.i
  %.328.i.i = shl nuw i64 %.1122805807.i, 1
  br label %B106.if.i.i

B134.i.i:                                         ; preds = %B106.if.i.i
  %.343.i.i = icmp slt i64 %lsr.iv23.i.i, -2
  %63 = shl i64 %lsr.iv23.i.i, 3
  %64 = select i1 %.343.i.i, i64 %55, i64 16
  %scevgep41.i.i = getelementptr i8, ptr %53, i64 %64
  %scevgep42.i.i = getelementptr i8, ptr %scevgep41.i.i, i64 %63
  %.359.i.i = load double, ptr %scevgep42.i.i, align 8, !noalias !15
  %.375.i.i = icmp slt i64 %lsr.iv23.i.i, -3
  %65 = select i1 %.375.i.i, i64 %56, i64 24
  %scevgep39.i.i = getelementptr i8, ptr %53, i64 %65
  %scevgep30.i.i = getelementptr i8, ptr %scevgep39.i.i, i64 %63
  %.391.i.i = load double, ptr %scevgep30.i.i, align 8, !noalias !15
  %.406.i.i = icmp slt i64 %lsr.iv23.i.i, 0
  %66 = select i1 %.406.i.i, i64 %57, i64 8
  %scevgep27.i.i15 = getelementptr i8, ptr %53, i64 %66
  %scevgep28.i.i = getelementptr i8, ptr %scevgep27.i.i15, i64 %63
  %scevgep29.i.i = getelementptr i8, ptr %scevgep28.i.i, i64 -8
  %.422.i.i16 = load double, ptr %scevgep29.i.i, align 8, !noalias !15
  %.454.i.i = load double, ptr %scevgep28.i.i, align 8, !noalias !15
  %.458.i.i = fmul contract double %.359.i.i, %.422.i.i16
  %.459.i.i = fmul contract double %.391.i.i, %.454.i.i
  %.460.i.i = fadd contract double %.458.i.i, %.459.i.i
  %.461.i.i = fmul contract double %.391.i.i, %.422.i.i16
  %.462.i.i = fmul contract double %.359.i.i, %.454.i.i
  %.463.i.i = fsub contract double %.461.i.i, %.462.i.i
  %.464.i.i = fmul contract double %.1278.i, %.460.i.i
  %.465.i.i = fmul contract double %.1403.i, %.463.i.i
  %.466.i.i = fsub contract double %.464.i.i, %.465.i.i
  %.467.i.i = fmul contract double %.1403.i, %.460.i.i
  %.468.i.i = fmul contract double %.1278.i, %.463.i.i
  %.469.i.i = fadd contract double %.467.i.i, %.468.i.i
  %.490.i.i = fmul contract double %.466.i.i, %.466.i.i
  %.491.i.i = fmul contract double %.469.i.i, %.469.i.i
  %.492.i.i = fsub contract double %.490.i.i, %.491.i.i
  %.494.i.i = fadd contract double %real.3.0484.i.i, %.492.i.i
  %.499.i.i = fmul contract double %.466.i.i, 2.000000e+00
  %.500.i.i = fmul contract double %.469.i.i, %.499.i.i
  %.502.i.i17 = fadd contract double %imaginary.3.0485.i.i, %.500.i.i
  br label %B240.i.i

B240.i.i:                                         ; preds = %B106.if.i.i, %B134.i.i
  %real.4.1.i.i = phi double [ %.494.i.i, %B134.i.i ], [ %real.3.0484.i.i, %B106.if.i.i ]
  %imaginary.4.1.i.i = phi double [ %.502.i.i17, %B134.i.i ], [ %imaginary.3.0485.i.i, %B106.if.i.i ]
  %lsr.iv.next24.i.i = add i64 %lsr.iv23.i.i, %.216.i
  %exitcond.not.i.i = icmp eq i64 %.124.i, %.244.i.i
  br i1 %exitcond.not.i.i, label %B242.i.i, label %B106.if.i.i

B242.i.i:                                         ; preds = %B240.i.i, %B766.if.i
  %real.3.0.lcssa.i.i = phi double [ 0.000000e+00, %B766.if.i ], [ %real.4.1.i.i, %B240.i.i ]
  %imaginary.3.0.lcssa.i.i = phi double [ 0.000000e+00, %B766.if.i ], [ %imaginary.4.1.i.i, %B240.i.i ]
  %.526.i.i = tail call contract double @llvm.fabs.f64(double %real.3.0.lcssa.i.i)
  %.528.i.i = tail call contract double @llvm.fabs.f64(double %imaginary.3.0.lcssa.i.i)
  %.12.i.i.i = fcmp contract ogt double %.528.i.i, %.526.i.i
  %.13.i.i.i = select i1 %.12.i.i.i, double %.528.i.i, double %.526.i.i
  %.561.i.i = fcmp contract ogt double %.13.i.i.i, 0.000000e+00
  br i1 %.561.i.i, label %B338.endif.i.i, label %_ZN17bnserve_inference14adjoint_kernel8_passing10_turn_backB4v532B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedExx8UniTupleIdLi3EE5ArrayIdLi1E1C7mutable7alignedE.exit.i

B452.i.i:                                         ; preds = %B342.if.i.i
  %.801.i.i = icmp slt i64 %lsr.iv.i.i8, -2
  %67 = select i1 %.801.i.i, i64 %55, i64 16
  %68 = getelementptr i8, ptr %lsr.iv3.i.i, i64 %75
  %scevgep24.i.i13 = getelementptr i8, ptr %68, i64 %67
  %.817.i.i = load double, ptr %scevgep24.i.i13, align 8, !noalias !15
  %.833.i.i = icmp slt i64 %lsr.iv.i.i8, -3
  %69 = select i1 %.833.i.i, i64 %56, i64 24
  %scevgep23.i.i = getelementptr i8, ptr %68, i64 %69
  %.849.i.i = load double, ptr %scevgep23.i.i, align 8, !noalias !15
  %.864.i.i = icmp slt i64 %lsr.iv.i.i8, 0
  %70 = select i1 %.864.i.i, i64 %57, i64 8
  %scevgep21.i.i = getelementptr i8, ptr %68, i64 %70
  %scevgep19.i.i14 = getelementptr i8, ptr %scevgep21.i.i, i64 -8
  %.880.i.i = load double, ptr %scevgep19.i.i14, align 8, !noalias !15
  %.912.i.i = load double, ptr %scevgep21.i.i, align 8, !noalias !15
  %.916.i.i = fmul contract double %.817.i.i, %.880.i.i
  %.917.i.i = fmul contract double %.849.i.i, %.912.i.i
  %.918.i.i = fadd contract double %.916.i.i, %.917.i.i
  %.919.i.i = fmul contract double %.849.i.i, %.880.i.i
  %.920.i.i = fmul contract double %.817.i.i, %.912.i.i
  %.921.i.i = fsub contract double %.919.i.i, %.920.i.i
  %.922.i.i = fmul contract double %.1278.i, %.918.i.i
  %.923.i.i = fmul contract double %.1403.i, %.921.i.i
  %.924.i.i = fsub contract double %.922.i.i, %.923.i.i
  %.925.i.i = fmul contract double %.1403.i, %.918.i.i
  %.926.i.i = fmul contract double %.1278.i, %.921.i.i
  %.927.i.i = fadd contract double %.925.i.i, %.926.i.i
  %.949.i.i = fmul contract double %.568.i.i, %.924.i.i
  %.951.i.i = fmul contract double %.576.i.i, %.927.i.i
  %.952.i.i = fadd contract double %.949.i.i, %.951.i.i
  %.954.i.i = fmul contract double %.568.i.i, %.927.i.i
  %.956.i.i = fmul contract double %.576.i.i, %.924.i.i
  %.957.i.i = fsub contract double %.954.i.i, %.956.i.i
  %.959.i.i = fmul contract double %.603.i.i, %.957.i.i
  %.960.i.i = fneg contract double %.952.i.i
  %.962.i.i = fmul contract double %.603.i.i, %.960.i.i
  %.964.i.i = fmul contract double %.1278.i, %.959.i.i
  %.966.i.i = fmul contract double %.1403.i, %.962.i.i
  %.967.i.i = fsub contract double %.964.i.i, %.966.i.i
  %.969.i.i = fmul contract double %.1403.i, %.959.i.i
  %.971.i.i = fmul contract double %.1278.i, %.962.i.i
  %.972.i.i = fadd contract double %.969.i.i, %.971.i.i
  %.1130.i.i = icmp slt i64 %lsr.iv21.i.i, -1
  %71 = select i1 %.1130.i.i, i64 %90, i64 24
  %72 = getelementptr i8, ptr %lsr.iv12.i.i, i64 %75
  %scevgep8.i.i = getelementptr i8, ptr %72, i64 %71
  %scevgep10.i.i = getelementptr i8, ptr %scevgep8.i.i, i64 -8
  %.1146.i.i = load double, ptr %scevgep10.i.i, align 8, !noalias !15
  %.1147.i.i = fmul contract double %.880.i.i, %.967.i.i
  %.1148.i.i = fmul contract double %.912.i.i, %.972.i.i
  %.1149.i.i = fadd contract double %.1147.i.i, %.1148.i.i
  %.1150.i.i = fadd contract double %.1146.i.i, %.1149.i.i
  store double %.1150.i.i, ptr %scevgep10.i.i, align 8, !noalias !15
  %.1211.i.i = load double, ptr %scevgep8.i.i, align 8, !noalias !15
  %.1212.i.i = fmul contract double %.880.i.i, %.972.i.i
  %.1213.i.i = fmul contract double %.912.i.i, %.967.i.i
  %.1214.i.i = fsub contract double %.1212.i.i, %.1213.i.i
  %.1215.i.i = fsub contract double %.1211.i.i, %.1214.i.i
  store double %.1215.i.i, ptr %scevgep8.i.i, align 8, !noalias !15
  %.1259.i.i = icmp slt i64 %lsr.iv21.i.i, 0
  %73 = select i1 %.1259.i.i, i64 %91, i64 8
  %scevgep3.i.i = getelementptr i8, ptr %72, i64 %73
  %scevgep4.i.i = getelementptr i8, ptr %scevgep3.i.i, i64 -8
  %.1275.i.i = load double, ptr %scevgep4.i.i, align 8, !noalias !15
  %.1276.i.i = fmul contract double %.817.i.i, %.967.i.i
  %.1277.i.i = fmul contract double %.849.i.i, %.972.i.i
  %.1278.i.i = fsub contract double %.1276.i.i, %.1277.i.i
  %.1279.i.i = fadd contract double %.1275.i.i, %.1278.i.i
  store double %.1279.i.i, ptr %scevgep4.i.i, align 8, !noalias !15
  %.1340.i.i = load double, ptr %scevgep3.i.i, align 8, !noalias !15
  %.1341.i.i = fmul contract double %.849.i.i, %.967.i.i
  %.1342.i.i = fmul contract double %.817.i.i, %.972.i.i
  %.1343.i.i = fadd contract double %.1341.i.i, %.1342.i.i
  %.1344.i.i = fadd contract double %.1340.i.i, %.1343.i.i
  store double %.1344.i.i, ptr %scevgep3.i.i, align 8, !noalias !15
  br label %B480.i.i

B480.i.i:                                         ; preds = %B342.if.i.i, %B452.i.i
  %lsr.iv.next.i.i9 = add i64 %lsr.iv.i.i8, %.216.i
  %lsr.iv.next2.i.i = add nsw i64 %lsr.iv1.i.i, -1
  %scevgep.i.i10 = getelementptr i8, ptr %lsr.iv3.i.i, i64 %58
  %scevgep11.i.i11 = getelementptr i8, ptr %lsr.iv10.i.i, i64 8
  %scevgep13.i.i12 = getelementptr i8, ptr %lsr.iv12.i.i, i64 %60
  %lsr.iv.next22.i.i = sub i64 %lsr.iv21.i.i, %.141.1.i
  %exitcond496.not.i.i = icmp eq i64 %lsr.iv.next2.i.i, 0
  br i1 %exitcond496.not.i.i, label %_ZN17bnserve_inference14adjoint_kernel8_passing10_turn_backB4v532B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedExx8UniTupleIdLi3EE5ArrayIdLi1E1C7mutable7alignedE.exit.i, label %B342.if.i.i

B106.if.i.i:                                      ; preds = %B240.i.i, %B106.if.lr.ph.i.i
  %lsr.iv23.i.i = phi i64 [ %.328.i.i, %B106.if.lr.ph.i.i ], [ %lsr.iv.next24.i.i, %B240.i.i ]
  %imaginary.3.0485.i.i = phi double [ 0.000000e+00, %B106.if.lr.ph.i.i ], [ %imaginary.4.1.i.i, %B240.i.i ]
  %real.3.0484.i.i = phi double [ 0.000000e+00, %B106.if.lr.ph.i.i ], [ %real.4.1.i.i, %B240.i.i ]
  %.237480482.i.i = phi i64 [ 0, %B106.if.lr.ph.i.i ], [ %.244.i.i, %B240.i.i ]
  %.244.i.i = add nuw nsw i64 %.237480482.i.i, 1
  %74 = shl i64 %.237480482.i.i, 3
  %scevgep36.i.i = getelementptr i8, ptr %52, i64 %74
  %.310.i.i = load i64, ptr %scevgep36.i.i, align 8, !noalias !15
  %.312.i.i = icmp eq i64 %.310.i.i, %.673815835.i
  br i1 %.312.i.i, label %B134.i.i, label %B240.i.i

B338.endif.i.i:                                   ; preds = %B242.i.i
  %.568.i.i = fdiv contract double %real.3.0.lcssa.i.i, %.13.i.i.i
  %.576.i.i = fdiv contract double %imaginary.3.0.lcssa.i.i, %.13.i.i.i
  %.587.i.i = fmul contract double %.568.i.i, %.568.i.i
  %.590.i.i = fmul contract double %.576.i.i, %.576.i.i
  %.591.i.i = fadd contract double %.587.i.i, %.590.i.i
  %.596.i.i = fdiv contract double %.1529.i, %.591.i.i
  %.603.i.i = fdiv contract double %.596.i.i, %.13.i.i.i
  br i1 %.699491.not.i.i, label %_ZN17bnserve_inference14adjoint_kernel8_passing10_turn_backB4v532B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedExx8UniTupleIdLi3EE5ArrayIdLi1E1C7mutable7alignedE.exit.i, label %B342.if.lr.ph.i.i

B342.if.lr.ph.i.i:                                ; preds = %B338.endif.i.i
  %.786.i.i = shl nuw i64 %.1122805807.i, 1
  %75 = shl i64 %.1122805807.i, 4
  br label %B342.if.i.i

B342.if.i.i:                                      ; preds = %B342.if.lr.ph.i.i, %B480.i.i
  %lsr.iv21.i.i = phi i64 [ %.1122805807.i, %B342.if.lr.ph.i.i ], [ %lsr.iv.next22.i.i, %B480.i.i ]
  %lsr.iv12.i.i = phi ptr [ %.498, %B342.if.lr.ph.i.i ], [ %scevgep13.i.i12, %B480.i.i ]
  %lsr.iv10.i.i = phi ptr [ %52, %B342.if.lr.ph.i.i ], [ %scevgep11.i.i11, %B480.i.i ]
  %lsr.iv3.i.i = phi ptr [ %53, %B342.if.lr.ph.i.i ], [ %scevgep.i.i10, %B480.i.i ]
  %lsr.iv1.i.i = phi i64 [ %.124.i, %B342.if.lr.ph.i.i ], [ %lsr.iv.next2.i.i, %B480.i.i ]
  %lsr.iv.i.i8 = phi i64 [ %.786.i.i, %B342.if.lr.ph.i.i ], [ %lsr.iv.next.i.i9, %B480.i.i ]
  %.770.i.i = load i64, ptr %lsr.iv10.i.i, align 8, !noalias !15
  %.772.i.i = icmp eq i64 %.770.i.i, %.673815835.i
  br i1 %.772.i.i, label %B452.i.i, label %B480.i.i

_ZN17bnserve_inference14adjoint_kernel8_passing10_turn_backB4v532B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedExx8UniTupleIdLi3EE5ArrayIdLi1E1C7mutable7alignedE.exit.i: ; preds = %B480.i.i, %B338.endif.i.i, %B242.i.i
  %76 = add nuw nsw i64 %.1122805807.i, 2
  %exitcond.not.i7 = icmp eq i64 %47, %76
  %77 = add nuw nsw i64 %.1122805807.i, 1
  br i1 %exitcond.not.i7, label %B1068.i, label %B766.if.i

B1412:                                            ; preds = %B1068.i, %B1378, %B1254.endif, %B1334
  call void @llvm.lifetime.start.p0(ptr nonnull %.690.i)
  store double 0.000000e+00, ptr %.690.i, align 8, !noalias !18
  %.78.i = load i64, ptr %.106, align 8, !noalias !18
  %.286409.not.i = icmp slt i64 %.78.i, 1
  br i1 %.286409.not.i, label %_ZN17bnserve_inference14adjoint_kernel5_back11binary_backB4v537B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit, label %B208.if.lr.ph.i

B554.i:                                           ; preds = %B330.if.i
  %.299.i = add nuw nsw i64 %.292400412.i, 1
  %lsr.iv.next.i24 = add i64 %lsr.iv.i21, %82
  %exitcond434.not.i = icmp eq i64 %.299.i, %.78.i
  br i1 %exitcond434.not.i, label %_ZN17bnserve_inference14adjoint_kernel5_back11binary_backB4v537B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit, label %B208.if.i

B208.if.lr.ph.i:                                  ; preds = %B1412
  %.145.i = load i64, ptr %.144.i18, align 8, !noalias !18
  %.148.i = mul nuw nsw i64 %.7709701030, 80
  %.149.i19 = add nsw i64 %.145.i, %.148.i
  %.108.i = load i64, ptr %.140, align 8, !noalias !18
  %.neg.i = mul i64 %.108.i, -2
  %78 = and i64 %.neg.i, -16
  %.377.i = shl nsw i64 %.108.i, 1
  %.593.i = shl i64 %.108.i, 4
  %79 = mul i64 %.7709701030, 96
  %80 = mul i64 %79, %.78.i
  %81 = mul i64 %80, %.108.i
  %82 = mul i64 %.108.i, 96
  %83 = inttoptr i64 %.149.i19 to ptr
  br label %B208.if.i

B208.if.i:                                        ; preds = %B208.if.lr.ph.i, %B554.i
  %lsr.iv.i21 = phi i64 [ %81, %B208.if.lr.ph.i ], [ %lsr.iv.next.i24, %B554.i ]
  %.292400412.i = phi i64 [ 0, %B208.if.lr.ph.i ], [ %.299.i, %B554.i ]
  %84 = mul i64 %78, %.292400412.i
  %.375.i = sub i64 0, %84
  %.388.i = getelementptr inbounds double, ptr %.498, i64 %.375.i
  br label %B330.if.i

B330.if.i:                                        ; preds = %B330.if.i, %B208.if.i
  %lsr.iv48.i = phi i64 [ %lsr.iv.i21, %B208.if.i ], [ %lsr.iv.next49.i, %B330.if.i ]
  %.530391394.i = phi i64 [ 0, %B208.if.i ], [ %.537.i, %B330.if.i ]
  %.591.i = load i64, ptr %sunkaddr.i20, align 8, !noalias !18
  %85 = add i64 %.591.i, %lsr.iv48.i
  %86 = shl nuw nsw i64 %.530391394.i, 3
  %scevgep.i22 = getelementptr i8, ptr %83, i64 %86
  %.633.i = load double, ptr %scevgep.i22, align 8, !noalias !18
  %.638.i = inttoptr i64 %85 to ptr
  store double 0.000000e+00, ptr %.690.i, align 8, !noalias !18
  call fastcc void @inner_1(ptr nonnull %.690.i, ptr readonly %.388.i, i64 %.377.i, ptr %.638.i, i64 %.377.i, i64 %.377.i, ptr nonnull %.586)
  %.537.i = add nuw nsw i64 %.530391394.i, 1
  %.710.i = load double, ptr %.690.i, align 8, !noalias !18
  %.723.i = fadd contract double %.633.i, %.710.i
  store double %.723.i, ptr %scevgep.i22, align 8, !noalias !18
  %lsr.iv.next49.i = add i64 %lsr.iv48.i, %.593.i
  %exitcond.not.i23 = icmp eq i64 %.537.i, 6
  br i1 %exitcond.not.i23, label %B554.i, label %B330.if.i

_ZN17bnserve_inference14adjoint_kernel5_back11binary_backB4v537B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit: ; preds = %B554.i, %B1412
  call void @llvm.lifetime.end.p0(ptr nonnull %.690.i)
  %exitcond1194.not = icmp eq i64 %.777, %.684
  br i1 %exitcond1194.not, label %B1452, label %B666.if

B1452:                                            ; preds = %_ZN17bnserve_inference14adjoint_kernel5_back11binary_backB4v537B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit, %entry
  store i64 0, ptr %retptr, align 8
  ret void

B666.if.lr.ph:                                    ; preds = %entry
  %.107 = load i64, ptr %.106, align 8
  %.1057 = and i64 %.184, 120
  %.1060.not = icmp ne i64 %.1057, 0
  %.1061870 = lshr i64 %.184, 7
  %.1062 = zext i1 %.1060.not to i64
  %.1063 = add nuw nsw i64 %.1061870, %.1062
  %.1042.inv = icmp slt i64 %.184, 1
  %.1084949.not1195 = icmp eq i64 %.1063, 0
  %.1084949.not = select i1 %.1042.inv, i1 true, i1 %.1084949.not1195
  %scevgep.i = getelementptr i8, ptr %.363, i64 144
  %scevgep58.i = getelementptr i8, ptr %.230, i64 96
  %sunkaddr129 = getelementptr i8, ptr %arg.arguments.4, i64 152
  %.193.i80 = getelementptr i8, ptr %arg.arguments.4, i64 272
  %.227.i = getelementptr i8, ptr %arg.arguments.4, i64 280
  %factor.op.mul = mul i64 %.107, %.184
  %.244.i = getelementptr i8, ptr %arg.arguments.4, i64 264
  %.166.i = getelementptr i8, ptr %arg.arguments.4, i64 56
  %sunkaddr3.i = getelementptr i8, ptr %arg.arguments.4, i64 64
  %sunkaddr4.i = getelementptr i8, ptr %arg.arguments.4, i64 72
  %sunkaddr.i26 = getelementptr i8, ptr %arg.arguments.4, i64 232
  %.547.i = getelementptr i8, ptr %arg.arguments.4, i64 240
  %.459.i = getelementptr i8, ptr %arg.arguments.4, i64 88
  %.361.i = getelementptr i8, ptr %arg.arguments.4, i64 128
  %.724.i = getelementptr i8, ptr %arg.arguments.4, i64 256
  %.636.i = getelementptr i8, ptr %arg.arguments.4, i64 248
  %.178.i = getelementptr i8, ptr %arg.arguments.4, i64 128
  %.275.i132 = getelementptr i8, ptr %arg.arguments.4, i64 136
  %.365.i = getelementptr i8, ptr %arg.arguments.4, i64 144
  %.456.i = getelementptr i8, ptr %arg.arguments.4, i64 88
  %87 = icmp slt i64 %.47, 1
  %.542.i = getelementptr i8, ptr %arg.arguments.4, i64 56
  %sunkaddr148.i = getelementptr i8, ptr %arg.arguments.4, i64 264
  %.54.i.i = getelementptr i8, ptr %.430, i64 10240
  %.141.i.i = getelementptr i8, ptr %.430, i64 11264
  %scevgep256.i = getelementptr i8, ptr %.430, i64 17408
  %scevgep107.i = getelementptr i8, ptr %.430, i64 10248
  %.133.i174 = getelementptr i8, ptr %arg.arguments.4, i64 160
  %.171.i = getelementptr i8, ptr %arg.arguments.4, i64 80
  %.607.i.i = getelementptr i8, ptr %.430, i64 3072
  %.734.i.i = getelementptr i8, ptr %arg.arguments.4, i64 112
  %.817.i.i179 = getelementptr i8, ptr %arg.arguments.4, i64 168
  %.536.i.i = getelementptr inbounds nuw i8, ptr %.430, i64 2048
  %.935.i.i = getelementptr i8, ptr %arg.arguments.4, i64 176
  %.1448.i.i184 = getelementptr inbounds nuw i8, ptr %.430, i64 4096
  %sunkaddr48.i = getelementptr i8, ptr %arg.arguments.4, i64 264
  %.138.i.i = getelementptr i8, ptr %arg.arguments.4, i64 32
  %.376.i.i233 = getelementptr i8, ptr %arg.arguments.4, i64 48
  %.454.i.i234 = getelementptr i8, ptr %arg.arguments.4, i64 192
  %.500.i.i235 = getelementptr i8, ptr %arg.arguments.4, i64 40
  %.557.i.i = getelementptr i8, ptr %arg.arguments.4, i64 96
  %.999.i.i236 = getelementptr i8, ptr %arg.arguments.4, i64 184
  %.5616.i.i = getelementptr i8, ptr %.430, i64 12296
  %.5646.i.i = getelementptr i8, ptr %.430, i64 12304
  %.5675.i.i = getelementptr i8, ptr %.430, i64 12312
  %.5706.i.i = getelementptr i8, ptr %.430, i64 12320
  %.5735.i.i = getelementptr i8, ptr %.430, i64 12328
  %.5765.i.i = getelementptr i8, ptr %.430, i64 12336
  %.5794.i.i = getelementptr i8, ptr %.430, i64 12344
  %.882.i.i = getelementptr i8, ptr %.430, i64 6144
  %.882.1.i.i = getelementptr i8, ptr %.430, i64 7168
  %.882.2.i.i = getelementptr i8, ptr %.430, i64 8192
  %.882.3.i.i = getelementptr i8, ptr %.430, i64 9216
  %.358.i.i.i = getelementptr i8, ptr %arg.arguments.4, i64 296
  %.1419.i.i.i = getelementptr i8, ptr %arg.arguments.4, i64 288
  %.265.i.i239 = getelementptr i8, ptr %arg.arguments.4, i64 304
  %scevgep266.i.i = getelementptr i8, ptr %.430, i64 21504
  %sunkaddr12.i41.i = getelementptr i8, ptr %arg.arguments.4, i64 104
  %.307.i.i = getelementptr i8, ptr %arg.arguments.4, i64 112
  %.592.i.i = getelementptr i8, ptr %.430, i64 4096
  %88 = getelementptr i8, ptr %arg.arguments.4, i64 344
  %89 = getelementptr i8, ptr %arg.arguments.4, i64 352
  %.592.1.i.i = getelementptr i8, ptr %.430, i64 5120
  %.501.i.i = getelementptr i8, ptr %arg.arguments.4, i64 328
  %.54.i.i.i = getelementptr inbounds nuw i8, ptr %.430, i64 10240
  %.141.i.i.i = getelementptr i8, ptr %.430, i64 11264
  %.1970.i.i = getelementptr i8, ptr %.430, i64 12296
  %.2000.i.i = getelementptr i8, ptr %.430, i64 12304
  %.2029.i.i = getelementptr i8, ptr %.430, i64 12312
  %.2060.i.i = getelementptr i8, ptr %.430, i64 12320
  %.2089.i.i = getelementptr i8, ptr %.430, i64 12328
  %.2119.i.i = getelementptr i8, ptr %.430, i64 12336
  %.2148.i.i = getelementptr i8, ptr %.430, i64 12344
  %.780.i = getelementptr i8, ptr %arg.arguments.4, i64 336
  %.813.i = getelementptr i8, ptr %arg.arguments.4, i64 56
  %scevgep.i2 = getelementptr i8, ptr %.430, i64 41024
  %sunkaddr115 = getelementptr i8, ptr %arg.arguments.4, i64 56
  %sunkaddr = getelementptr i8, ptr %arg.arguments.4, i64 320
  %sunkaddr136 = getelementptr i8, ptr %arg.arguments.4, i64 336
  %.389.i = getelementptr i8, ptr %arg.arguments.4, i64 256
  %.304.i = getelementptr i8, ptr %arg.arguments.4, i64 88
  %.208.i = getelementptr i8, ptr %arg.arguments.4, i64 128
  %sunkaddr27.i = getelementptr i8, ptr %arg.arguments.4, i64 240
  %.228.reass = shl i64 %factor.op.mul, 4
  %90 = or disjoint i64 %.228.reass, 24
  %91 = or disjoint i64 %.228.reass, 8
  %.144.i18 = getelementptr i8, ptr %arg.arguments.4, i64 320
  %sunkaddr.i20 = getelementptr i8, ptr %arg.arguments.4, i64 312
  br label %B666.if

B666.if:                                          ; preds = %B666.if.lr.ph, %_ZN17bnserve_inference14adjoint_kernel5_back11binary_backB4v537B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit
  %.7709701030 = phi i64 [ 0, %B666.if.lr.ph ], [ %.777, %_ZN17bnserve_inference14adjoint_kernel5_back11binary_backB4v537B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit ]
  %.777 = add nuw nsw i64 %.7709701030, 1
  %.835 = load i64, ptr %sunkaddr129, align 8
  %.838 = mul nuw nsw i64 %.7709701030, 56
  %.839 = add nsw i64 %.835, %.838
  %.840 = inttoptr i64 %.839 to ptr
  %.915 = getelementptr i8, ptr %.840, i64 24
  %.916 = load double, ptr %.915, align 8
  %.290.i = load i64, ptr %arg.arguments.4, align 8, !noalias !21
  %.370466.not.i = icmp slt i64 %.290.i, 1
  br i1 %.370466.not.i, label %_ZN17bnserve_inference14adjoint_kernel7_source6_placeB3v16B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit, label %B268.if.preheader.i

B268.if.preheader.i:                              ; preds = %B666.if
  %.245.i = load i64, ptr %.244.i, align 8, !noalias !21
  %.167.i = load i64, ptr %.166.i, align 8, !noalias !21
  %92 = inttoptr i64 %.167.i to ptr
  %.145.i.i = getelementptr i8, ptr %92, i64 8
  %.345.i.i = getelementptr i8, ptr %.840, i64 8
  %.542.i.i = icmp eq i64 %.245.i, 1
  %.2102.i.i = getelementptr i8, ptr %.840, i64 16
  br label %B268.if.i

B268.if.i:                                        ; preds = %_ZN17bnserve_inference14adjoint_kernel9_response13fill_geometryB3v43B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i, %B268.if.preheader.i
  %lsr.iv138.i = phi i64 [ %lsr.iv.next139.i, %_ZN17bnserve_inference14adjoint_kernel9_response13fill_geometryB3v43B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i ], [ %.290.i, %B268.if.preheader.i ]
  %lsr.iv136.i27 = phi i64 [ %lsr.iv.next137.i, %_ZN17bnserve_inference14adjoint_kernel9_response13fill_geometryB3v43B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i ], [ 0, %B268.if.preheader.i ]
  %lsr.iv134.i = phi i64 [ %lsr.iv.next135.i, %_ZN17bnserve_inference14adjoint_kernel9_response13fill_geometryB3v43B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i ], [ 0, %B268.if.preheader.i ]
  %lsr.iv133.i = phi i64 [ %lsr.iv.next.i73, %_ZN17bnserve_inference14adjoint_kernel9_response13fill_geometryB3v43B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i ], [ 0, %B268.if.preheader.i ]
  %lsr.iv131.i = phi ptr [ %scevgep132.i, %_ZN17bnserve_inference14adjoint_kernel9_response13fill_geometryB3v43B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i ], [ %.230, %B268.if.preheader.i ]
  %lsr.iv.i28 = phi ptr [ %scevgep.i72, %_ZN17bnserve_inference14adjoint_kernel9_response13fill_geometryB3v43B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i ], [ %.363, %B268.if.preheader.i ]
  %.438.i = load i64, ptr %sunkaddr3.i, align 8, !noalias !21
  %93 = add i64 %.438.i, %lsr.iv136.i27
  %.441.i = inttoptr i64 %93 to ptr
  %.519.i = load i64, ptr %sunkaddr4.i, align 8, !noalias !21
  %94 = add i64 %.519.i, %lsr.iv134.i
  %.522.i = inttoptr i64 %94 to ptr
  %.600.i = load i64, ptr %sunkaddr.i26, align 8, !noalias !21
  %95 = add i64 %.600.i, %lsr.iv133.i
  %.603.i = inttoptr i64 %95 to ptr
  %.116.i.i = load double, ptr %92, align 8, !noalias !24
  %.146.i.i = load double, ptr %.145.i.i, align 8, !noalias !24
  %.176.i.i = load double, ptr %.915, align 8, !noalias !24
  %.177.i.i = fmul contract double %.146.i.i, %.176.i.i
  %.178.i.i = fadd contract double %.116.i.i, %.177.i.i
  %.208.i.i = load double, ptr %.840, align 8, !noalias !24
  %.209.i.i = fsub contract double %.178.i.i, %.208.i.i
  %.215.i.i = tail call contract double @llvm.fma.f64(double %.209.i.i, double 0x3FE45F306DC9C883, double 0x4338000000000000)
  %.216.i.i = fadd contract double %.215.i.i, 0xC338000000000000
  %.231.i.i = tail call contract double @llvm.fma.f64(double %.216.i.i, double 0xBFF921FB54442D18, double %.209.i.i)
  %.246.i.i = tail call contract double @llvm.fma.f64(double %.216.i.i, double 0xBC91A62633145C07, double %.231.i.i)
  %.247.i.i = fmul contract double %.246.i.i, %.246.i.i
  %.248.i.i = tail call contract double @llvm.fma.f64(double %.247.i.i, double 0xBD6AE7F3E733B81F, double 0x3DE6124613A86D09)
  %.249.i.i = tail call contract double @llvm.fma.f64(double %.247.i.i, double %.248.i.i, double 0xBE5AE64567F544E4)
  %.250.i.i = tail call contract double @llvm.fma.f64(double %.247.i.i, double %.249.i.i, double 0x3EC71DE3A556C734)
  %.251.i.i = tail call contract double @llvm.fma.f64(double %.247.i.i, double %.250.i.i, double 0xBF2A01A01A01A01A)
  %.252.i.i = tail call contract double @llvm.fma.f64(double %.247.i.i, double %.251.i.i, double 0x3F81111111111111)
  %.253.i.i = tail call contract double @llvm.fma.f64(double %.247.i.i, double %.252.i.i, double 0xBFC5555555555555)
  %.254.i.i = fmul contract double %.246.i.i, %.247.i.i
  %.255.i.i = tail call contract double @llvm.fma.f64(double %.254.i.i, double %.253.i.i, double %.246.i.i)
  %.256.i.i = tail call contract double @llvm.fma.f64(double %.247.i.i, double 0x3D2AE7F3E733B81F, double 0xBDA93974A8C07C9D)
  %.257.i.i = tail call contract double @llvm.fma.f64(double %.247.i.i, double %.256.i.i, double 0x3E21EED8EFF8D898)
  %.258.i.i = tail call contract double @llvm.fma.f64(double %.247.i.i, double %.257.i.i, double 0xBE927E4FB7789F5C)
  %.259.i.i = tail call contract double @llvm.fma.f64(double %.247.i.i, double %.258.i.i, double 0x3EFA01A01A01A01A)
  %.260.i.i = tail call contract double @llvm.fma.f64(double %.247.i.i, double %.259.i.i, double 0xBF56C16C16C16C17)
  %.261.i.i = tail call contract double @llvm.fma.f64(double %.247.i.i, double %.260.i.i, double 0x3FA5555555555555)
  %.262.i.i = tail call contract double @llvm.fma.f64(double %.247.i.i, double %.261.i.i, double -5.000000e-01)
  %.263.i.i = tail call contract double @llvm.fma.f64(double %.247.i.i, double %.262.i.i, double 1.000000e+00)
  %.264.i.i = bitcast double %.215.i.i to i64
  %.265.i.i = bitcast double %.255.i.i to i64
  %.266.i.i = bitcast double %.263.i.i to i64
  %.267.i.i29 = xor i64 %.266.i.i, %.265.i.i
  %.268.i.i30 = and i64 %.264.i.i, 1
  %96 = icmp eq i64 %.268.i.i30, 0
  %.270.i.i = select i1 %96, i64 0, i64 %.267.i.i29
  %.271.i.i31 = shl i64 %.264.i.i, 62
  %.272.i.i32 = and i64 %.271.i.i31, -9223372036854775808
  %.274.i.i = add i64 %.271.i.i31, 4611686018427387904
  %.275.i.i = and i64 %.274.i.i, -9223372036854775808
  %97 = xor i64 %.272.i.i32, %.265.i.i
  %.277.i.i = xor i64 %97, %.270.i.i
  %.278.i.i = bitcast i64 %.277.i.i to double
  %98 = xor i64 %.275.i.i, %.266.i.i
  %.280.i.i = xor i64 %98, %.270.i.i
  %.281.i.i = bitcast i64 %.280.i.i to double
  %.346.i.i = load double, ptr %.345.i.i, align 8, !noalias !24
  %.347.i.i = tail call contract double @llvm.fma.f64(double %.346.i.i, double 0x3FE45F306DC9C883, double 0x4338000000000000)
  %.348.i.i = fadd contract double %.347.i.i, 0xC338000000000000
  %.363.i.i = tail call contract double @llvm.fma.f64(double %.348.i.i, double 0xBFF921FB54442D18, double %.346.i.i)
  %.378.i.i33 = tail call contract double @llvm.fma.f64(double %.348.i.i, double 0xBC91A62633145C07, double %.363.i.i)
  %.379.i.i = fmul contract double %.378.i.i33, %.378.i.i33
  %.380.i.i = tail call contract double @llvm.fma.f64(double %.379.i.i, double 0xBD6AE7F3E733B81F, double 0x3DE6124613A86D09)
  %.381.i.i = tail call contract double @llvm.fma.f64(double %.379.i.i, double %.380.i.i, double 0xBE5AE64567F544E4)
  %.382.i.i = tail call contract double @llvm.fma.f64(double %.379.i.i, double %.381.i.i, double 0x3EC71DE3A556C734)
  %.383.i.i = tail call contract double @llvm.fma.f64(double %.379.i.i, double %.382.i.i, double 0xBF2A01A01A01A01A)
  %.384.i.i = tail call contract double @llvm.fma.f64(double %.379.i.i, double %.383.i.i, double 0x3F81111111111111)
  %.385.i.i = tail call contract double @llvm.fma.f64(double %.379.i.i, double %.384.i.i, double 0xBFC5555555555555)
  %.386.i.i = fmul contract double %.378.i.i33, %.379.i.i
  %.387.i.i = tail call contract double @llvm.fma.f64(double %.386.i.i, double %.385.i.i, double %.378.i.i33)
  %.388.i.i = tail call contract double @llvm.fma.f64(double %.379.i.i, double 0x3D2AE7F3E733B81F, double 0xBDA93974A8C07C9D)
  %.389.i.i = tail call contract double @llvm.fma.f64(double %.379.i.i, double %.388.i.i, double 0x3E21EED8EFF8D898)
  %.390.i.i = tail call contract double @llvm.fma.f64(double %.379.i.i, double %.389.i.i, double 0xBE927E4FB7789F5C)
  %.391.i.i34 = tail call contract double @llvm.fma.f64(double %.379.i.i, double %.390.i.i, double 0x3EFA01A01A01A01A)
  %.392.i.i = tail call contract double @llvm.fma.f64(double %.379.i.i, double %.391.i.i34, double 0xBF56C16C16C16C17)
  %.393.i.i = tail call contract double @llvm.fma.f64(double %.379.i.i, double %.392.i.i, double 0x3FA5555555555555)
  %.394.i.i = tail call contract double @llvm.fma.f64(double %.379.i.i, double %.393.i.i, double -5.000000e-01)
  %.395.i.i = tail call contract double @llvm.fma.f64(double %.379.i.i, double %.394.i.i, double 1.000000e+00)
  %.396.i.i = bitcast double %.347.i.i to i64
  %.397.i.i = bitcast double %.387.i.i to i64
  %.398.i.i = bitcast double %.395.i.i to i64
  %.399.i.i = xor i64 %.398.i.i, %.397.i.i
  %.400.i.i = and i64 %.396.i.i, 1
  %99 = icmp eq i64 %.400.i.i, 0
  %.402.i.i = select i1 %99, i64 0, i64 %.399.i.i
  %.403.i.i = shl i64 %.396.i.i, 62
  %.404.i.i = and i64 %.403.i.i, -9223372036854775808
  %.406.i.i35 = add i64 %.403.i.i, 4611686018427387904
  %.407.i.i = and i64 %.406.i.i35, -9223372036854775808
  %100 = xor i64 %.404.i.i, %.397.i.i
  %.409.i.i = xor i64 %100, %.402.i.i
  %.410.i.i = bitcast i64 %.409.i.i to double
  %101 = xor i64 %.407.i.i, %.398.i.i
  %.412.i.i = xor i64 %101, %.402.i.i
  %.413.i.i = bitcast i64 %.412.i.i to double
  %.468.i.i36 = load double, ptr %.522.i, align 8, !noalias !24
  %.496.i.i = getelementptr i8, ptr %.522.i, i64 8
  %.497.i.i = load double, ptr %.496.i.i, align 8, !noalias !24
  %.525.i.i = getelementptr i8, ptr %.522.i, i64 16
  %.526.i.i37 = load double, ptr %.525.i.i, align 8, !noalias !24
  br i1 %.542.i.i, label %B276.i.i, label %_ZN17bnserve_inference13moving_kernel9_response12coefficientsB3v24B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i

B276.i.i:                                         ; preds = %B268.if.i
  %.547.i.i = fmul contract double %.468.i.i36, %.281.i.i
  %.553.i.i = fmul contract double %.497.i.i, %.278.i.i
  %.556.i.i = fsub contract double %.547.i.i, %.553.i.i
  %.558.i.i = fmul contract double %.556.i.i, %.413.i.i
  %.562.i.i = fmul contract double %.526.i.i37, %.410.i.i
  %.563.i.i = fadd contract double %.562.i.i, %.558.i.i
  %.568.i.i76 = fdiv contract double %.563.i.i, 0x41B1DE784A000000
  %.605.i.i = fmul contract double %.146.i.i, %.568.i.i76
  %102 = fsub contract double %.209.i.i, %.605.i.i
  %.610.i.i = tail call contract double @llvm.fma.f64(double %102, double 0x3FE45F306DC9C883, double 0x4338000000000000)
  %.611.i.i = fadd contract double %.610.i.i, 0xC338000000000000
  %.626.i.i = tail call contract double @llvm.fma.f64(double %.611.i.i, double 0xBFF921FB54442D18, double %102)
  %.641.i.i = tail call contract double @llvm.fma.f64(double %.611.i.i, double 0xBC91A62633145C07, double %.626.i.i)
  %.642.i.i = fmul contract double %.641.i.i, %.641.i.i
  %.643.i.i = tail call contract double @llvm.fma.f64(double %.642.i.i, double 0xBD6AE7F3E733B81F, double 0x3DE6124613A86D09)
  %.644.i.i = tail call contract double @llvm.fma.f64(double %.642.i.i, double %.643.i.i, double 0xBE5AE64567F544E4)
  %.645.i.i = tail call contract double @llvm.fma.f64(double %.642.i.i, double %.644.i.i, double 0x3EC71DE3A556C734)
  %.646.i.i = tail call contract double @llvm.fma.f64(double %.642.i.i, double %.645.i.i, double 0xBF2A01A01A01A01A)
  %.647.i.i = tail call contract double @llvm.fma.f64(double %.642.i.i, double %.646.i.i, double 0x3F81111111111111)
  %.648.i.i = tail call contract double @llvm.fma.f64(double %.642.i.i, double %.647.i.i, double 0xBFC5555555555555)
  %.649.i.i = fmul contract double %.641.i.i, %.642.i.i
  %.650.i.i = tail call contract double @llvm.fma.f64(double %.649.i.i, double %.648.i.i, double %.641.i.i)
  %.651.i.i = tail call contract double @llvm.fma.f64(double %.642.i.i, double 0x3D2AE7F3E733B81F, double 0xBDA93974A8C07C9D)
  %.652.i.i = tail call contract double @llvm.fma.f64(double %.642.i.i, double %.651.i.i, double 0x3E21EED8EFF8D898)
  %.653.i.i = tail call contract double @llvm.fma.f64(double %.642.i.i, double %.652.i.i, double 0xBE927E4FB7789F5C)
  %.654.i.i77 = tail call contract double @llvm.fma.f64(double %.642.i.i, double %.653.i.i, double 0x3EFA01A01A01A01A)
  %.655.i.i = tail call contract double @llvm.fma.f64(double %.642.i.i, double %.654.i.i77, double 0xBF56C16C16C16C17)
  %.656.i.i = tail call contract double @llvm.fma.f64(double %.642.i.i, double %.655.i.i, double 0x3FA5555555555555)
  %.657.i.i = tail call contract double @llvm.fma.f64(double %.642.i.i, double %.656.i.i, double -5.000000e-01)
  %.658.i.i = tail call contract double @llvm.fma.f64(double %.642.i.i, double %.657.i.i, double 1.000000e+00)
  %.659.i.i = bitcast double %.610.i.i to i64
  %.660.i.i = bitcast double %.650.i.i to i64
  %.661.i.i = bitcast double %.658.i.i to i64
  %.662.i.i = xor i64 %.661.i.i, %.660.i.i
  %.663.i.i = and i64 %.659.i.i, 1
  %103 = icmp eq i64 %.663.i.i, 0
  %.665.i.i = select i1 %103, i64 0, i64 %.662.i.i
  %.666.i.i = shl i64 %.659.i.i, 62
  %.667.i.i = and i64 %.666.i.i, -9223372036854775808
  %.669.i.i = add i64 %.666.i.i, 4611686018427387904
  %.670.i.i = and i64 %.669.i.i, -9223372036854775808
  %104 = xor i64 %.667.i.i, %.660.i.i
  %.672.i.i = xor i64 %104, %.665.i.i
  %.673.i.i = bitcast i64 %.672.i.i to double
  %105 = xor i64 %.670.i.i, %.661.i.i
  %.675.i.i = xor i64 %105, %.665.i.i
  %.676.i.i = bitcast i64 %.675.i.i to double
  br label %_ZN17bnserve_inference13moving_kernel9_response12coefficientsB3v24B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i

_ZN17bnserve_inference13moving_kernel9_response12coefficientsB3v24B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i: ; preds = %B276.i.i, %B268.if.i
  %sin_h.2.0.i.i = phi double [ %.673.i.i, %B276.i.i ], [ %.278.i.i, %B268.if.i ]
  %cos_h.2.0.i.i = phi double [ %.676.i.i, %B276.i.i ], [ %.281.i.i, %B268.if.i ]
  %.775.i.i = fmul contract double %.468.i.i36, %cos_h.2.0.i.i
  %106 = fmul contract double %.497.i.i, %sin_h.2.0.i.i
  %.779.i.i = fsub contract double %.775.i.i, %106
  %.788.i.i = fmul contract double %.526.i.i37, 0.000000e+00
  %.789.i.i = fadd contract double %.788.i.i, %.779.i.i
  %.791.i.i = fmul contract double %.789.i.i, %.413.i.i
  %.795.i.i = fmul contract double %.526.i.i37, %.410.i.i
  %.796.i.i = fadd contract double %.795.i.i, %.791.i.i
  %.801.i.i38 = fdiv contract double %.796.i.i, 0xC1B1DE784A000000
  store double %.801.i.i38, ptr %lsr.iv131.i, align 8, !noalias !24
  %.863.i.i = fdiv contract double %.791.i.i, 0x41B1DE784A000000
  %.892.i.i = getelementptr i8, ptr %lsr.iv131.i, i64 88
  store double %.863.i.i, ptr %.892.i.i, align 8, !noalias !24
  %.910.i.i = fmul contract double %.468.i.i36, %sin_h.2.0.i.i
  %.913.i.i = fmul contract double %.497.i.i, %cos_h.2.0.i.i
  %.914.i.i = fadd contract double %.910.i.i, %.913.i.i
  %.924.i.i39 = fadd contract double %.788.i.i, %.914.i.i
  %.926.i.i40 = fmul contract double %.924.i.i39, %.413.i.i
  %.930.i.i = fdiv contract double %.926.i.i40, 0x41B1DE784A000000
  %.959.i.i41 = getelementptr i8, ptr %lsr.iv131.i, i64 96
  store double %.930.i.i, ptr %.959.i.i41, align 8, !noalias !24
  %.998.i.i = load double, ptr %.441.i, align 8, !noalias !24
  %.1000.i.i = fmul contract double %cos_h.2.0.i.i, %.998.i.i
  %.1028.i.i = getelementptr i8, ptr %.441.i, i64 8
  %.1029.i.i = load double, ptr %.1028.i.i, align 8, !noalias !24
  %107 = fmul contract double %sin_h.2.0.i.i, %.1029.i.i
  %.1032.i.i = fsub contract double %.1000.i.i, %107
  %.1060.i.i = getelementptr i8, ptr %.441.i, i64 16
  %.1061.i.i = load double, ptr %.1060.i.i, align 8, !noalias !24
  %.1063.i.i = fmul contract double %.1061.i.i, 0.000000e+00
  %.1064.i.i = fadd contract double %.1032.i.i, %.1063.i.i
  %.1092.i.i = getelementptr i8, ptr %.441.i, i64 24
  %.1093.i.i = load double, ptr %.1092.i.i, align 8, !noalias !24
  %.1095.i.i = fmul contract double %cos_h.2.0.i.i, %.1093.i.i
  %.1123.i.i = getelementptr i8, ptr %.441.i, i64 32
  %.1124.i.i = load double, ptr %.1123.i.i, align 8, !noalias !24
  %108 = fmul contract double %sin_h.2.0.i.i, %.1124.i.i
  %.1127.i.i = fsub contract double %.1095.i.i, %108
  %.1155.i.i = getelementptr i8, ptr %.441.i, i64 40
  %.1156.i.i = load double, ptr %.1155.i.i, align 8, !noalias !24
  %.1158.i.i = fmul contract double %.1156.i.i, 0.000000e+00
  %.1159.i.i = fadd contract double %.1127.i.i, %.1158.i.i
  %.1187.i.i = getelementptr i8, ptr %.441.i, i64 48
  %.1188.i.i = load double, ptr %.1187.i.i, align 8, !noalias !24
  %.1190.i.i = fmul contract double %cos_h.2.0.i.i, %.1188.i.i
  %.1218.i.i = getelementptr i8, ptr %.441.i, i64 56
  %.1219.i.i = load double, ptr %.1218.i.i, align 8, !noalias !24
  %109 = fmul contract double %sin_h.2.0.i.i, %.1219.i.i
  %.1222.i.i = fsub contract double %.1190.i.i, %109
  %.1250.i.i = getelementptr i8, ptr %.441.i, i64 64
  %.1251.i.i = load double, ptr %.1250.i.i, align 8, !noalias !24
  %.1259.i.i42 = fmul contract double %.1251.i.i, 0.000000e+00
  %.1260.i.i = fadd contract double %.1222.i.i, %.1259.i.i42
  %.1318.i.i = fmul contract double %sin_h.2.0.i.i, %.998.i.i
  %.1349.i.i = fmul contract double %cos_h.2.0.i.i, %.1029.i.i
  %.1350.i.i = fadd contract double %.1318.i.i, %.1349.i.i
  %.1382.i.i = fadd contract double %.1350.i.i, %.1063.i.i
  %.1413.i.i = fmul contract double %sin_h.2.0.i.i, %.1093.i.i
  %.1444.i.i = fmul contract double %cos_h.2.0.i.i, %.1124.i.i
  %.1445.i.i = fadd contract double %.1413.i.i, %.1444.i.i
  %.1477.i.i = fadd contract double %.1445.i.i, %.1158.i.i
  %.1508.i.i = fmul contract double %sin_h.2.0.i.i, %.1188.i.i
  %.1539.i.i = fmul contract double %cos_h.2.0.i.i, %.1219.i.i
  %.1540.i.i = fadd contract double %.1508.i.i, %.1539.i.i
  %.1578.i.i = fadd contract double %.1540.i.i, %.1259.i.i42
  %.1643.i.i = fmul contract double %.998.i.i, 0.000000e+00
  %.1674.i.i = fmul contract double %.1029.i.i, 0.000000e+00
  %.1675.i.i = fadd contract double %.1643.i.i, %.1674.i.i
  %.1707.i.i = fadd contract double %.1061.i.i, %.1675.i.i
  %.1738.i.i = fmul contract double %.1093.i.i, 0.000000e+00
  %.1769.i.i = fmul contract double %.1124.i.i, 0.000000e+00
  %.1770.i.i = fadd contract double %.1738.i.i, %.1769.i.i
  %.1802.i.i = fadd contract double %.1156.i.i, %.1770.i.i
  %.1833.i.i = fmul contract double %.1188.i.i, 0.000000e+00
  %.1864.i.i = fmul contract double %.1219.i.i, 0.000000e+00
  %.1865.i.i = fadd contract double %.1833.i.i, %.1864.i.i
  %.1903.i.i = fadd contract double %.1251.i.i, %.1865.i.i
  %.1947.i.i = fmul contract double %cos_h.2.0.i.i, %.1064.i.i
  %110 = fmul contract double %sin_h.2.0.i.i, %.1159.i.i
  %.1951.i.i = fsub contract double %.1947.i.i, %110
  %.1960.i.i = fmul contract double %.1260.i.i, 0.000000e+00
  %.1961.i.i = fadd contract double %.1951.i.i, %.1960.i.i
  %.1972.i.i43 = fmul contract double %cos_h.2.0.i.i, %.1382.i.i
  %111 = fmul contract double %sin_h.2.0.i.i, %.1477.i.i
  %.1976.i.i = fsub contract double %.1972.i.i43, %111
  %.1985.i.i = fmul contract double %.1578.i.i, 0.000000e+00
  %.1986.i.i = fadd contract double %.1976.i.i, %.1985.i.i
  %.2000.i.i44 = fmul contract double %sin_h.2.0.i.i, %.1382.i.i
  %.2003.i.i = fmul contract double %cos_h.2.0.i.i, %.1477.i.i
  %.2004.i.i = fadd contract double %.2000.i.i44, %.2003.i.i
  %.2014.i.i = fadd contract double %.2004.i.i, %.1985.i.i
  %.2025.i.i = fmul contract double %cos_h.2.0.i.i, %.1707.i.i
  %112 = fmul contract double %sin_h.2.0.i.i, %.1802.i.i
  %.2029.i.i45 = fsub contract double %.2025.i.i, %112
  %.2038.i.i = fmul contract double %.1903.i.i, 0.000000e+00
  %.2039.i.i = fadd contract double %.2029.i.i45, %.2038.i.i
  %.2050.i.i = fmul contract double %sin_h.2.0.i.i, %.1707.i.i
  %.2053.i.i = fmul contract double %cos_h.2.0.i.i, %.1802.i.i
  %.2054.i.i = fadd contract double %.2050.i.i, %.2053.i.i
  %.2064.i.i = fadd contract double %.2054.i.i, %.2038.i.i
  %.2069.i.i = fadd contract double %.1961.i.i, %.2014.i.i
  %.2070.i.i = fmul contract double %.2069.i.i, 5.000000e-01
  %.2071.i.i = fsub contract double %.2014.i.i, %.1961.i.i
  %.2072.i.i = fmul contract double %.2071.i.i, 5.000000e-01
  %.2103.i.i = load double, ptr %.2102.i.i, align 8, !noalias !24
  %.2109.i.i = fmul contract double %.2103.i.i, 2.000000e+00
  %.2110.i.i = tail call contract double @llvm.fma.f64(double %.2109.i.i, double 0x3FE45F306DC9C883, double 0x4338000000000000)
  %.2111.i.i = fadd contract double %.2110.i.i, 0xC338000000000000
  %.2126.i.i = tail call contract double @llvm.fma.f64(double %.2111.i.i, double 0xBFF921FB54442D18, double %.2109.i.i)
  %.2141.i.i = tail call contract double @llvm.fma.f64(double %.2111.i.i, double 0xBC91A62633145C07, double %.2126.i.i)
  %.2142.i.i = fmul contract double %.2141.i.i, %.2141.i.i
  %.2143.i.i = tail call contract double @llvm.fma.f64(double %.2142.i.i, double 0xBD6AE7F3E733B81F, double 0x3DE6124613A86D09)
  %.2144.i.i = tail call contract double @llvm.fma.f64(double %.2142.i.i, double %.2143.i.i, double 0xBE5AE64567F544E4)
  %.2145.i.i = tail call contract double @llvm.fma.f64(double %.2142.i.i, double %.2144.i.i, double 0x3EC71DE3A556C734)
  %.2146.i.i = tail call contract double @llvm.fma.f64(double %.2142.i.i, double %.2145.i.i, double 0xBF2A01A01A01A01A)
  %.2147.i.i = tail call contract double @llvm.fma.f64(double %.2142.i.i, double %.2146.i.i, double 0x3F81111111111111)
  %.2148.i.i46 = tail call contract double @llvm.fma.f64(double %.2142.i.i, double %.2147.i.i, double 0xBFC5555555555555)
  %.2149.i.i47 = fmul contract double %.2141.i.i, %.2142.i.i
  %.2150.i.i = tail call contract double @llvm.fma.f64(double %.2149.i.i47, double %.2148.i.i46, double %.2141.i.i)
  %.2151.i.i = tail call contract double @llvm.fma.f64(double %.2142.i.i, double 0x3D2AE7F3E733B81F, double 0xBDA93974A8C07C9D)
  %.2152.i.i = tail call contract double @llvm.fma.f64(double %.2142.i.i, double %.2151.i.i, double 0x3E21EED8EFF8D898)
  %.2153.i.i48 = tail call contract double @llvm.fma.f64(double %.2142.i.i, double %.2152.i.i, double 0xBE927E4FB7789F5C)
  %.2154.i.i49 = tail call contract double @llvm.fma.f64(double %.2142.i.i, double %.2153.i.i48, double 0x3EFA01A01A01A01A)
  %.2155.i.i50 = tail call contract double @llvm.fma.f64(double %.2142.i.i, double %.2154.i.i49, double 0xBF56C16C16C16C17)
  %.2156.i.i51 = tail call contract double @llvm.fma.f64(double %.2142.i.i, double %.2155.i.i50, double 0x3FA5555555555555)
  %.2157.i.i = tail call contract double @llvm.fma.f64(double %.2142.i.i, double %.2156.i.i51, double -5.000000e-01)
  %.2158.i.i = tail call contract double @llvm.fma.f64(double %.2142.i.i, double %.2157.i.i, double 1.000000e+00)
  %.2159.i.i = bitcast double %.2110.i.i to i64
  %.2160.i.i = bitcast double %.2150.i.i to i64
  %.2161.i.i = bitcast double %.2158.i.i to i64
  %.2162.i.i = xor i64 %.2161.i.i, %.2160.i.i
  %.2163.i.i = and i64 %.2159.i.i, 1
  %113 = icmp eq i64 %.2163.i.i, 0
  %.2165.i.i = select i1 %113, i64 0, i64 %.2162.i.i
  %.2166.i.i = shl i64 %.2159.i.i, 62
  %.2167.i.i = and i64 %.2166.i.i, -9223372036854775808
  %.2169.i.i = add i64 %.2166.i.i, 4611686018427387904
  %.2170.i.i = and i64 %.2169.i.i, -9223372036854775808
  %114 = xor i64 %.2167.i.i, %.2160.i.i
  %.2172.i.i = xor i64 %114, %.2165.i.i
  %.2173.i.i = bitcast i64 %.2172.i.i to double
  %115 = xor i64 %.2170.i.i, %.2161.i.i
  %.2175.i.i = xor i64 %115, %.2165.i.i
  %.2176.i.i = bitcast i64 %.2175.i.i to double
  %.2204.i.i = fmul contract double %.2070.i.i, %.413.i.i
  %.2206.i.i = fmul contract double %.2204.i.i, %.413.i.i
  %.2209.i.i = fmul contract double %.413.i.i, %.413.i.i
  %.2210.i.i = fmul contract double %.2209.i.i, %.1903.i.i
  %.2211.i.i = fsub contract double %.2206.i.i, %.2210.i.i
  %.2213.i.i = fmul contract double %.410.i.i, 2.000000e+00
  %.2215.i.i52 = fmul contract double %.2213.i.i, %.413.i.i
  %.2216.i.i53 = fmul contract double %.2215.i.i52, %.2039.i.i
  %.2218.i.i = fmul contract double %.410.i.i, -2.000000e+00
  %.2220.i.i = fmul contract double %.2218.i.i, %.413.i.i
  %.2221.i.i = fmul contract double %.2220.i.i, %.2064.i.i
  %.2224.i.i = fmul contract double %.410.i.i, %.410.i.i
  %.2225.i.i = fadd contract double %.2224.i.i, 1.000000e+00
  %.2226.i.i = fmul contract double %.2225.i.i, %.2072.i.i
  %.2231.i.i = fmul contract double %.2225.i.i, %.1986.i.i
  %.2251.i.i = fmul contract double %.413.i.i, -2.000000e+00
  %.2252.i.i = fmul contract double %.2251.i.i, %.2064.i.i
  %.2255.i.i = fmul contract double %.2251.i.i, %.2039.i.i
  %.2258.i.i = fmul contract double %.2213.i.i, %.1986.i.i
  %.2261.i.i = fmul contract double %.2218.i.i, %.2072.i.i
  %.2418.i.i = fmul contract double %.2211.i.i, %.2176.i.i
  %.2438.i.i = fmul contract double %.2173.i.i, 0.000000e+00
  %.2439.i.i = fadd contract double %.2418.i.i, %.2438.i.i
  %116 = getelementptr i8, ptr %lsr.iv131.i, i64 8
  store double %.2439.i.i, ptr %116, align 8, !noalias !24
  %.2490.i.i = fmul contract double %.2176.i.i, 0.000000e+00
  %.2510.i.i = fmul contract double %.2211.i.i, %.2173.i.i
  %.2511.i.i = fsub contract double %.2490.i.i, %.2510.i.i
  %117 = getelementptr i8, ptr %lsr.iv131.i, i64 48
  store double %.2511.i.i, ptr %117, align 8, !noalias !24
  %.2418.1.i.i = fmul contract double %.2216.i.i53, %.2176.i.i
  %.2438.1.i.i = fmul contract double %.2252.i.i, %.2173.i.i
  %.2439.1.i.i = fadd contract double %.2418.1.i.i, %.2438.1.i.i
  %118 = getelementptr i8, ptr %lsr.iv131.i, i64 16
  store double %.2439.1.i.i, ptr %118, align 8, !noalias !24
  %.2490.1.i.i = fmul contract double %.2252.i.i, %.2176.i.i
  %.2510.1.i.i = fmul contract double %.2216.i.i53, %.2173.i.i
  %.2511.1.i.i = fsub contract double %.2490.1.i.i, %.2510.1.i.i
  %119 = getelementptr i8, ptr %lsr.iv131.i, i64 56
  store double %.2511.1.i.i, ptr %119, align 8, !noalias !24
  %.2418.2.i.i = fmul contract double %.2221.i.i, %.2176.i.i
  %.2438.2.i.i = fmul contract double %.2255.i.i, %.2173.i.i
  %.2439.2.i.i = fadd contract double %.2418.2.i.i, %.2438.2.i.i
  %120 = getelementptr i8, ptr %lsr.iv131.i, i64 24
  store double %.2439.2.i.i, ptr %120, align 8, !noalias !24
  %.2490.2.i.i = fmul contract double %.2255.i.i, %.2176.i.i
  %.2510.2.i.i = fmul contract double %.2221.i.i, %.2173.i.i
  %.2511.2.i.i = fsub contract double %.2490.2.i.i, %.2510.2.i.i
  %121 = getelementptr i8, ptr %lsr.iv131.i, i64 64
  store double %.2511.2.i.i, ptr %121, align 8, !noalias !24
  %.2418.3.i.i = fmul contract double %.2226.i.i, %.2176.i.i
  %.2438.3.i.i = fmul contract double %.2258.i.i, %.2173.i.i
  %.2439.3.i.i = fadd contract double %.2418.3.i.i, %.2438.3.i.i
  %122 = getelementptr i8, ptr %lsr.iv131.i, i64 32
  store double %.2439.3.i.i, ptr %122, align 8, !noalias !24
  %.2490.3.i.i = fmul contract double %.2258.i.i, %.2176.i.i
  %.2510.3.i.i = fmul contract double %.2226.i.i, %.2173.i.i
  %.2511.3.i.i = fsub contract double %.2490.3.i.i, %.2510.3.i.i
  %123 = getelementptr i8, ptr %lsr.iv131.i, i64 72
  store double %.2511.3.i.i, ptr %123, align 8, !noalias !24
  %.2418.4.i.i = fmul contract double %.2231.i.i, %.2176.i.i
  %.2438.4.i.i = fmul contract double %.2261.i.i, %.2173.i.i
  %.2439.4.i.i = fadd contract double %.2418.4.i.i, %.2438.4.i.i
  %124 = getelementptr i8, ptr %lsr.iv131.i, i64 40
  store double %.2439.4.i.i, ptr %124, align 8, !noalias !24
  %.2490.4.i.i = fmul contract double %.2261.i.i, %.2176.i.i
  %.2510.4.i.i = fmul contract double %.2231.i.i, %.2173.i.i
  %.2511.4.i.i = fsub contract double %.2490.4.i.i, %.2510.4.i.i
  %125 = getelementptr i8, ptr %lsr.iv131.i, i64 80
  store double %.2511.4.i.i, ptr %125, align 8, !noalias !24
  %.2591.i.i = getelementptr i8, ptr %lsr.iv131.i, i64 104
  store i64 %.2175.i.i, ptr %.2591.i.i, align 8, !noalias !24
  %.2624.i.i = getelementptr i8, ptr %lsr.iv131.i, i64 112
  store i64 %.2172.i.i, ptr %.2624.i.i, align 8, !noalias !24
  %.2657.i.i = getelementptr i8, ptr %lsr.iv131.i, i64 120
  store i64 %.412.i.i, ptr %.2657.i.i, align 8, !noalias !24
  %.2690.i.i = getelementptr i8, ptr %lsr.iv131.i, i64 128
  store i64 %.409.i.i, ptr %.2690.i.i, align 8, !noalias !24
  %.2841.i.i = load double, ptr %.603.i, align 8, !noalias !24
  %126 = getelementptr i8, ptr %.603.i, i64 8
  %.2873.i.i = load double, ptr %126, align 8, !noalias !24
  %127 = getelementptr i8, ptr %.603.i, i64 16
  %.2905.i.i = load double, ptr %127, align 8, !noalias !24
  %.2929.i.i = fmul contract double %.2841.i.i, %.2841.i.i
  %.2932.i.i = fmul contract double %.2873.i.i, %.2873.i.i
  %.2933.i.i = fadd contract double %.2929.i.i, %.2932.i.i
  %.2942.i.i = fmul contract double %.2905.i.i, %.2905.i.i
  %.2943.i.i = fadd contract double %.2933.i.i, %.2942.i.i
  %.2951.i.i = tail call contract double @sqrt(double %.2943.i.i)
  %.2951.fr.i.i = freeze double %.2951.i.i
  %.2975.i.i = fcmp contract ogt double %.2951.fr.i.i, 0.000000e+00
  %.2981.i.i = fdiv contract double 1.000000e+00, %.2951.fr.i.i
  %"$phi1856.1.2.1.i.i" = select i1 %.2975.i.i, double %.2981.i.i, double 0.000000e+00
  %.3003.i.i = fmul contract double %cos_h.2.0.i.i, %.2841.i.i
  %128 = fmul contract double %sin_h.2.0.i.i, %.2873.i.i
  %.3007.i.i = fsub contract double %.3003.i.i, %128
  %.3016.i.i = fmul contract double %.2905.i.i, 0.000000e+00
  %.3017.i.i = fadd contract double %.3007.i.i, %.3016.i.i
  %.3018.i.i = fmul contract double %.3017.i.i, %"$phi1856.1.2.1.i.i"
  %.3030.i.i = fmul contract double %sin_h.2.0.i.i, %.2841.i.i
  %.3033.i.i = fmul contract double %cos_h.2.0.i.i, %.2873.i.i
  %.3034.i.i = fadd contract double %.3030.i.i, %.3033.i.i
  %.3044.i.i = fadd contract double %.3034.i.i, %.3016.i.i
  %.3045.i.i = fmul contract double %.3044.i.i, %"$phi1856.1.2.1.i.i"
  %.3075.i.i = getelementptr i8, ptr %lsr.iv131.i, i64 136
  store double %.3018.i.i, ptr %.3075.i.i, align 8, !noalias !24
  %.3107.i.i = getelementptr i8, ptr %lsr.iv131.i, i64 144
  store double %.3045.i.i, ptr %.3107.i.i, align 8, !noalias !24
  %.3116.i.i = fmul contract double %.2905.i.i, %"$phi1856.1.2.1.i.i"
  %.3121.i.i54 = fdiv contract double %.2951.fr.i.i, 0x41B1DE784A000000
  %.3154.i.i = getelementptr i8, ptr %lsr.iv131.i, i64 152
  store double %.3116.i.i, ptr %.3154.i.i, align 8, !noalias !24
  %.3188.i.i = getelementptr i8, ptr %lsr.iv131.i, i64 160
  store double %.3121.i.i54, ptr %.3188.i.i, align 8, !noalias !24
  %129 = getelementptr i8, ptr %.603.i, i64 24
  %.2841.1.i.i = load double, ptr %129, align 8, !noalias !24
  %130 = getelementptr i8, ptr %.603.i, i64 32
  %.2873.1.i.i = load double, ptr %130, align 8, !noalias !24
  %131 = getelementptr i8, ptr %.603.i, i64 40
  %.2905.1.i.i = load double, ptr %131, align 8, !noalias !24
  %.2929.1.i.i = fmul contract double %.2841.1.i.i, %.2841.1.i.i
  %.2932.1.i.i = fmul contract double %.2873.1.i.i, %.2873.1.i.i
  %.2933.1.i.i = fadd contract double %.2929.1.i.i, %.2932.1.i.i
  %.2942.1.i.i = fmul contract double %.2905.1.i.i, %.2905.1.i.i
  %.2943.1.i.i = fadd contract double %.2933.1.i.i, %.2942.1.i.i
  %.2951.1.i.i = tail call contract double @sqrt(double %.2943.1.i.i)
  %.2951.1.fr.i.i = freeze double %.2951.1.i.i
  %.2975.1.i.i = fcmp contract ogt double %.2951.1.fr.i.i, 0.000000e+00
  %.2981.1.i.i = fdiv contract double 1.000000e+00, %.2951.1.fr.i.i
  %"$phi1856.1.2.1.1.i.i" = select i1 %.2975.1.i.i, double %.2981.1.i.i, double 0.000000e+00
  %.3003.1.i.i = fmul contract double %cos_h.2.0.i.i, %.2841.1.i.i
  %132 = fmul contract double %sin_h.2.0.i.i, %.2873.1.i.i
  %.3007.1.i.i = fsub contract double %.3003.1.i.i, %132
  %.3016.1.i.i = fmul contract double %.2905.1.i.i, 0.000000e+00
  %.3017.1.i.i = fadd contract double %.3007.1.i.i, %.3016.1.i.i
  %.3018.1.i.i = fmul contract double %.3017.1.i.i, %"$phi1856.1.2.1.1.i.i"
  %.3030.1.i.i = fmul contract double %sin_h.2.0.i.i, %.2841.1.i.i
  %.3033.1.i.i = fmul contract double %cos_h.2.0.i.i, %.2873.1.i.i
  %.3034.1.i.i = fadd contract double %.3030.1.i.i, %.3033.1.i.i
  %.3044.1.i.i = fadd contract double %.3034.1.i.i, %.3016.1.i.i
  %.3045.1.i.i = fmul contract double %.3044.1.i.i, %"$phi1856.1.2.1.1.i.i"
  %.3075.1.i.i = getelementptr i8, ptr %lsr.iv131.i, i64 168
  store double %.3018.1.i.i, ptr %.3075.1.i.i, align 8, !noalias !24
  %.3107.1.i.i = getelementptr i8, ptr %lsr.iv131.i, i64 176
  store double %.3045.1.i.i, ptr %.3107.1.i.i, align 8, !noalias !24
  %.3116.1.i.i = fmul contract double %.2905.1.i.i, %"$phi1856.1.2.1.1.i.i"
  %.3121.1.i.i = fdiv contract double %.2951.1.fr.i.i, 0x41B1DE784A000000
  %.3154.1.i.i = getelementptr i8, ptr %lsr.iv131.i, i64 184
  store double %.3116.1.i.i, ptr %.3154.1.i.i, align 8, !noalias !24
  %.3188.1.i.i = getelementptr i8, ptr %lsr.iv131.i, i64 192
  store double %.3121.1.i.i, ptr %.3188.1.i.i, align 8, !noalias !24
  %.102.i.i = load double, ptr %92, align 8, !noalias !27
  %.132.i.i = load double, ptr %.145.i.i, align 8, !noalias !27
  %.162.i.i = load double, ptr %.915, align 8, !noalias !27
  %.163.i.i = fmul contract double %.132.i.i, %.162.i.i
  %.164.i.i = fadd contract double %.102.i.i, %.163.i.i
  %.194.i.i = load double, ptr %.840, align 8, !noalias !27
  %.195.i.i = fsub contract double %.164.i.i, %.194.i.i
  %.201.i.i = tail call contract double @llvm.fma.f64(double %.195.i.i, double 0x3FE45F306DC9C883, double 0x4338000000000000)
  %.202.i.i = fadd contract double %.201.i.i, 0xC338000000000000
  %.217.i.i = tail call contract double @llvm.fma.f64(double %.202.i.i, double 0xBFF921FB54442D18, double %.195.i.i)
  %.232.i.i55 = tail call contract double @llvm.fma.f64(double %.202.i.i, double 0xBC91A62633145C07, double %.217.i.i)
  %.233.i.i = fmul contract double %.232.i.i55, %.232.i.i55
  %.234.i.i = tail call contract double @llvm.fma.f64(double %.233.i.i, double 0xBD6AE7F3E733B81F, double 0x3DE6124613A86D09)
  %.235.i.i = tail call contract double @llvm.fma.f64(double %.233.i.i, double %.234.i.i, double 0xBE5AE64567F544E4)
  %.236.i.i = tail call contract double @llvm.fma.f64(double %.233.i.i, double %.235.i.i, double 0x3EC71DE3A556C734)
  %.237.i.i = tail call contract double @llvm.fma.f64(double %.233.i.i, double %.236.i.i, double 0xBF2A01A01A01A01A)
  %.238.i.i = tail call contract double @llvm.fma.f64(double %.233.i.i, double %.237.i.i, double 0x3F81111111111111)
  %.239.i.i = tail call contract double @llvm.fma.f64(double %.233.i.i, double %.238.i.i, double 0xBFC5555555555555)
  %.240.i.i = fmul contract double %.232.i.i55, %.233.i.i
  %.241.i.i = tail call contract double @llvm.fma.f64(double %.240.i.i, double %.239.i.i, double %.232.i.i55)
  %.242.i.i = tail call contract double @llvm.fma.f64(double %.233.i.i, double 0x3D2AE7F3E733B81F, double 0xBDA93974A8C07C9D)
  %.243.i.i = tail call contract double @llvm.fma.f64(double %.233.i.i, double %.242.i.i, double 0x3E21EED8EFF8D898)
  %.244.i.i56 = tail call contract double @llvm.fma.f64(double %.233.i.i, double %.243.i.i, double 0xBE927E4FB7789F5C)
  %.245.i.i = tail call contract double @llvm.fma.f64(double %.233.i.i, double %.244.i.i56, double 0x3EFA01A01A01A01A)
  %.246.i1.i = tail call contract double @llvm.fma.f64(double %.233.i.i, double %.245.i.i, double 0xBF56C16C16C16C17)
  %.247.i2.i = tail call contract double @llvm.fma.f64(double %.233.i.i, double %.246.i1.i, double 0x3FA5555555555555)
  %.248.i3.i = tail call contract double @llvm.fma.f64(double %.233.i.i, double %.247.i2.i, double -5.000000e-01)
  %.249.i4.i = tail call contract double @llvm.fma.f64(double %.233.i.i, double %.248.i3.i, double 1.000000e+00)
  %.250.i5.i = bitcast double %.201.i.i to i64
  %.251.i6.i = bitcast double %.241.i.i to i64
  %.252.i7.i = bitcast double %.249.i4.i to i64
  %.253.i8.i = xor i64 %.252.i7.i, %.251.i6.i
  %.254.i9.i = and i64 %.250.i5.i, 1
  %133 = icmp eq i64 %.254.i9.i, 0
  %.256.i10.i = select i1 %133, i64 0, i64 %.253.i8.i
  %.257.i11.i = shl i64 %.250.i5.i, 62
  %.258.i12.i = and i64 %.257.i11.i, -9223372036854775808
  %.260.i13.i = add i64 %.257.i11.i, 4611686018427387904
  %.261.i14.i = and i64 %.260.i13.i, -9223372036854775808
  %134 = xor i64 %.258.i12.i, %.251.i6.i
  %.263.i15.i = xor i64 %134, %.256.i10.i
  %.264.i16.i = bitcast i64 %.263.i15.i to double
  %135 = xor i64 %.261.i14.i, %.252.i7.i
  %.266.i17.i = xor i64 %135, %.256.i10.i
  %.267.i18.i = bitcast i64 %.266.i17.i to double
  %.332.i.i = load double, ptr %.345.i.i, align 8, !noalias !27
  %.333.i.i = tail call contract double @llvm.fma.f64(double %.332.i.i, double 0x3FE45F306DC9C883, double 0x4338000000000000)
  %.334.i.i = fadd contract double %.333.i.i, 0xC338000000000000
  %.349.i.i57 = tail call contract double @llvm.fma.f64(double %.334.i.i, double 0xBFF921FB54442D18, double %.332.i.i)
  %.364.i.i = tail call contract double @llvm.fma.f64(double %.334.i.i, double 0xBC91A62633145C07, double %.349.i.i57)
  %.365.i.i = fmul contract double %.364.i.i, %.364.i.i
  %.366.i.i = tail call contract double @llvm.fma.f64(double %.365.i.i, double 0xBD6AE7F3E733B81F, double 0x3DE6124613A86D09)
  %.367.i.i = tail call contract double @llvm.fma.f64(double %.365.i.i, double %.366.i.i, double 0xBE5AE64567F544E4)
  %.368.i.i = tail call contract double @llvm.fma.f64(double %.365.i.i, double %.367.i.i, double 0x3EC71DE3A556C734)
  %.369.i.i = tail call contract double @llvm.fma.f64(double %.365.i.i, double %.368.i.i, double 0xBF2A01A01A01A01A)
  %.370.i.i = tail call contract double @llvm.fma.f64(double %.365.i.i, double %.369.i.i, double 0x3F81111111111111)
  %.371.i.i = tail call contract double @llvm.fma.f64(double %.365.i.i, double %.370.i.i, double 0xBFC5555555555555)
  %.372.i.i = fmul contract double %.364.i.i, %.365.i.i
  %.373.i.i = tail call contract double @llvm.fma.f64(double %.372.i.i, double %.371.i.i, double %.364.i.i)
  %.374.i.i = tail call contract double @llvm.fma.f64(double %.365.i.i, double 0x3D2AE7F3E733B81F, double 0xBDA93974A8C07C9D)
  %.375.i.i58 = tail call contract double @llvm.fma.f64(double %.365.i.i, double %.374.i.i, double 0x3E21EED8EFF8D898)
  %.376.i.i = tail call contract double @llvm.fma.f64(double %.365.i.i, double %.375.i.i58, double 0xBE927E4FB7789F5C)
  %.377.i.i59 = tail call contract double @llvm.fma.f64(double %.365.i.i, double %.376.i.i, double 0x3EFA01A01A01A01A)
  %.378.i19.i = tail call contract double @llvm.fma.f64(double %.365.i.i, double %.377.i.i59, double 0xBF56C16C16C16C17)
  %.379.i20.i = tail call contract double @llvm.fma.f64(double %.365.i.i, double %.378.i19.i, double 0x3FA5555555555555)
  %.380.i21.i = tail call contract double @llvm.fma.f64(double %.365.i.i, double %.379.i20.i, double -5.000000e-01)
  %.381.i22.i = tail call contract double @llvm.fma.f64(double %.365.i.i, double %.380.i21.i, double 1.000000e+00)
  %.382.i23.i = bitcast double %.333.i.i to i64
  %.383.i24.i = bitcast double %.373.i.i to i64
  %.384.i25.i = bitcast double %.381.i22.i to i64
  %.385.i26.i = xor i64 %.384.i25.i, %.383.i24.i
  %.386.i27.i = and i64 %.382.i23.i, 1
  %136 = icmp eq i64 %.386.i27.i, 0
  %.388.i28.i = select i1 %136, i64 0, i64 %.385.i26.i
  %.389.i29.i = shl i64 %.382.i23.i, 62
  %.390.i30.i = and i64 %.389.i29.i, -9223372036854775808
  %.392.i31.i = add i64 %.389.i29.i, 4611686018427387904
  %.393.i32.i = and i64 %.392.i31.i, -9223372036854775808
  %137 = xor i64 %.390.i30.i, %.383.i24.i
  %.395.i33.i = xor i64 %137, %.388.i28.i
  %.396.i34.i = bitcast i64 %.395.i33.i to double
  %138 = xor i64 %.393.i32.i, %.384.i25.i
  %.398.i35.i = xor i64 %138, %.388.i28.i
  %.399.i36.i = bitcast i64 %.398.i35.i to double
  %.454.i.i60 = load double, ptr %.522.i, align 8, !noalias !27
  %.483.i.i = load double, ptr %.496.i.i, align 8, !noalias !27
  %.512.i.i = load double, ptr %.525.i.i, align 8, !noalias !27
  %.568.i37.i = getelementptr i8, ptr %lsr.iv.i28, i64 104
  tail call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(16) %.568.i37.i, i8 0, i64 16, i1 false), !noalias !27
  br i1 %.542.i.i, label %B344.i.i, label %_ZN17bnserve_inference14adjoint_kernel9_response13fill_geometryB3v43B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i

B344.i.i:                                         ; preds = %_ZN17bnserve_inference13moving_kernel9_response12coefficientsB3v24B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i
  %.599.i.i = getelementptr i8, ptr %lsr.iv.i28, i64 112
  %.606.i.i = fmul contract double %.454.i.i60, %.267.i18.i
  %.610.i53.i = fmul contract double %.483.i.i, %.264.i16.i
  %.611.i54.i = fsub contract double %.606.i.i, %.610.i53.i
  %.615.i.i = fmul contract double %.454.i.i60, %.264.i16.i
  %.621.i.i = fmul contract double %.483.i.i, %.267.i18.i
  %.624.i.i = fadd contract double %.615.i.i, %.621.i.i
  %.626.i55.i = fmul contract double %.611.i54.i, %.399.i36.i
  %.630.i.i = fmul contract double %.512.i.i, %.396.i34.i
  %.631.i.i = fadd contract double %.630.i.i, %.626.i55.i
  %.636.i.i = fdiv contract double %.631.i.i, 0x41B1DE784A000000
  %.638.i.i = fmul contract double %.624.i.i, %.399.i36.i
  %.642.i56.i = fdiv contract double %.638.i.i, 0x41B1DE784A000000
  store double %.642.i56.i, ptr %.568.i37.i, align 8, !noalias !27
  %.674.i.i = fmul contract double %.611.i54.i, %.396.i34.i
  %.678.i.i = fmul contract double %.512.i.i, %.399.i36.i
  %.679.i.i = fsub contract double %.674.i.i, %.678.i.i
  %.683.i.i = fdiv contract double %.679.i.i, 0x41B1DE784A000000
  store double %.683.i.i, ptr %.599.i.i, align 8, !noalias !27
  %.745.i.i = load double, ptr %.145.i.i, align 8, !noalias !27
  %.751.i.i = fmul contract double %.636.i.i, %.745.i.i
  %139 = fsub contract double %.195.i.i, %.751.i.i
  %.756.i.i = tail call contract double @llvm.fma.f64(double %139, double 0x3FE45F306DC9C883, double 0x4338000000000000)
  %.757.i.i = fadd contract double %.756.i.i, 0xC338000000000000
  %.772.i.i75 = tail call contract double @llvm.fma.f64(double %.757.i.i, double 0xBFF921FB54442D18, double %139)
  %.787.i.i = tail call contract double @llvm.fma.f64(double %.757.i.i, double 0xBC91A62633145C07, double %.772.i.i75)
  %.788.i57.i = fmul contract double %.787.i.i, %.787.i.i
  %.789.i58.i = tail call contract double @llvm.fma.f64(double %.788.i57.i, double 0xBD6AE7F3E733B81F, double 0x3DE6124613A86D09)
  %.790.i.i = tail call contract double @llvm.fma.f64(double %.788.i57.i, double %.789.i58.i, double 0xBE5AE64567F544E4)
  %.791.i59.i = tail call contract double @llvm.fma.f64(double %.788.i57.i, double %.790.i.i, double 0x3EC71DE3A556C734)
  %.792.i.i = tail call contract double @llvm.fma.f64(double %.788.i57.i, double %.791.i59.i, double 0xBF2A01A01A01A01A)
  %.793.i.i = tail call contract double @llvm.fma.f64(double %.788.i57.i, double %.792.i.i, double 0x3F81111111111111)
  %.794.i.i = tail call contract double @llvm.fma.f64(double %.788.i57.i, double %.793.i.i, double 0xBFC5555555555555)
  %.795.i60.i = fmul contract double %.787.i.i, %.788.i57.i
  %.796.i61.i = tail call contract double @llvm.fma.f64(double %.795.i60.i, double %.794.i.i, double %.787.i.i)
  %.797.i.i = tail call contract double @llvm.fma.f64(double %.788.i57.i, double 0x3D2AE7F3E733B81F, double 0xBDA93974A8C07C9D)
  %.798.i.i = tail call contract double @llvm.fma.f64(double %.788.i57.i, double %.797.i.i, double 0x3E21EED8EFF8D898)
  %.799.i.i = tail call contract double @llvm.fma.f64(double %.788.i57.i, double %.798.i.i, double 0xBE927E4FB7789F5C)
  %.800.i.i = tail call contract double @llvm.fma.f64(double %.788.i57.i, double %.799.i.i, double 0x3EFA01A01A01A01A)
  %.801.i62.i = tail call contract double @llvm.fma.f64(double %.788.i57.i, double %.800.i.i, double 0xBF56C16C16C16C17)
  %.802.i.i = tail call contract double @llvm.fma.f64(double %.788.i57.i, double %.801.i62.i, double 0x3FA5555555555555)
  %.803.i.i = tail call contract double @llvm.fma.f64(double %.788.i57.i, double %.802.i.i, double -5.000000e-01)
  %.804.i.i = tail call contract double @llvm.fma.f64(double %.788.i57.i, double %.803.i.i, double 1.000000e+00)
  %.805.i.i = bitcast double %.756.i.i to i64
  %.806.i.i = bitcast double %.796.i61.i to i64
  %.807.i.i = bitcast double %.804.i.i to i64
  %.808.i.i = xor i64 %.807.i.i, %.806.i.i
  %.809.i.i = and i64 %.805.i.i, 1
  %140 = icmp eq i64 %.809.i.i, 0
  %.811.i.i = select i1 %140, i64 0, i64 %.808.i.i
  %.812.i.i = shl i64 %.805.i.i, 62
  %.813.i.i = and i64 %.812.i.i, -9223372036854775808
  %.815.i.i = add i64 %.812.i.i, 4611686018427387904
  %.816.i.i = and i64 %.815.i.i, -9223372036854775808
  %141 = xor i64 %.813.i.i, %.806.i.i
  %.818.i.i = xor i64 %141, %.811.i.i
  %.819.i.i = bitcast i64 %.818.i.i to double
  %142 = xor i64 %.816.i.i, %.807.i.i
  %.821.i.i = xor i64 %142, %.811.i.i
  %.822.i.i = bitcast i64 %.821.i.i to double
  br label %_ZN17bnserve_inference14adjoint_kernel9_response13fill_geometryB3v43B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i

_ZN17bnserve_inference14adjoint_kernel9_response13fill_geometryB3v43B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i: ; preds = %B344.i.i, %_ZN17bnserve_inference13moving_kernel9_response12coefficientsB3v24B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i
  %sin_h.2.0.i38.i = phi double [ %.819.i.i, %B344.i.i ], [ %.264.i16.i, %_ZN17bnserve_inference13moving_kernel9_response12coefficientsB3v24B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i ]
  %cos_h.2.0.i39.i = phi double [ %.822.i.i, %B344.i.i ], [ %.267.i18.i, %_ZN17bnserve_inference13moving_kernel9_response12coefficientsB3v24B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i ]
  %.908.i.i = fmul contract double %.454.i.i60, %cos_h.2.0.i39.i
  %143 = fmul contract double %.483.i.i, %sin_h.2.0.i38.i
  %.912.i.i61 = fsub contract double %.908.i.i, %143
  %.921.i.i62 = fmul contract double %.512.i.i, 0.000000e+00
  %.922.i.i63 = fadd contract double %.921.i.i62, %.912.i.i61
  %.924.i40.i = fmul contract double %.922.i.i63, %.396.i34.i
  %.928.i.i = fmul contract double %.512.i.i, %.399.i36.i
  %.929.i.i = fsub contract double %.924.i40.i, %.928.i.i
  %.933.i.i = fdiv contract double %.929.i.i, 0x41B1DE784A000000
  %.962.i.i64 = getelementptr i8, ptr %lsr.iv.i28, i64 80
  store double %.933.i.i, ptr %.962.i.i64, align 8, !noalias !27
  %.965.i.i = fneg contract double %.396.i34.i
  %.991.i.i = fmul contract double %.922.i.i63, %.965.i.i
  %.995.i.i = fdiv contract double %.991.i.i, 0x41B1DE784A000000
  %.1024.i.i = getelementptr i8, ptr %lsr.iv.i28, i64 88
  store double %.995.i.i, ptr %.1024.i.i, align 8, !noalias !27
  %.1043.i.i = fmul contract double %.454.i.i60, %sin_h.2.0.i38.i
  %.1046.i.i = fmul contract double %.483.i.i, %cos_h.2.0.i39.i
  %.1047.i.i = fadd contract double %.1043.i.i, %.1046.i.i
  %.1057.i.i = fadd contract double %.921.i.i62, %.1047.i.i
  %.1058.i.i = fmul contract double %.1057.i.i, %.965.i.i
  %.1062.i.i = fdiv contract double %.1058.i.i, 0x41B1DE784A000000
  %.1091.i.i = getelementptr i8, ptr %lsr.iv.i28, i64 96
  store double %.1062.i.i, ptr %.1091.i.i, align 8, !noalias !27
  %.1129.i.i = load double, ptr %.441.i, align 8, !noalias !27
  %.1131.i.i = fmul contract double %cos_h.2.0.i39.i, %.1129.i.i
  %.1160.i.i = load double, ptr %.1028.i.i, align 8, !noalias !27
  %144 = fmul contract double %sin_h.2.0.i38.i, %.1160.i.i
  %.1163.i.i = fsub contract double %.1131.i.i, %144
  %.1192.i.i = load double, ptr %.1060.i.i, align 8, !noalias !27
  %.1194.i.i = fmul contract double %.1192.i.i, 0.000000e+00
  %.1195.i.i = fadd contract double %.1163.i.i, %.1194.i.i
  %.1224.i.i = load double, ptr %.1092.i.i, align 8, !noalias !27
  %.1226.i.i = fmul contract double %cos_h.2.0.i39.i, %.1224.i.i
  %.1255.i.i = load double, ptr %.1123.i.i, align 8, !noalias !27
  %145 = fmul contract double %sin_h.2.0.i38.i, %.1255.i.i
  %.1258.i.i = fsub contract double %.1226.i.i, %145
  %.1287.i.i = load double, ptr %.1155.i.i, align 8, !noalias !27
  %.1289.i.i = fmul contract double %.1287.i.i, 0.000000e+00
  %.1290.i.i = fadd contract double %.1258.i.i, %.1289.i.i
  %.1319.i.i = load double, ptr %.1187.i.i, align 8, !noalias !27
  %.1321.i.i = fmul contract double %cos_h.2.0.i39.i, %.1319.i.i
  %.1350.i44.i = load double, ptr %.1218.i.i, align 8, !noalias !27
  %146 = fmul contract double %sin_h.2.0.i38.i, %.1350.i44.i
  %.1353.i.i = fsub contract double %.1321.i.i, %146
  %.1382.i45.i = load double, ptr %.1250.i.i, align 8, !noalias !27
  %.1390.i.i = fmul contract double %.1382.i45.i, 0.000000e+00
  %.1391.i.i = fadd contract double %.1353.i.i, %.1390.i.i
  %.1448.i.i = fmul contract double %sin_h.2.0.i38.i, %.1129.i.i
  %.1479.i.i = fmul contract double %cos_h.2.0.i39.i, %.1160.i.i
  %.1480.i.i = fadd contract double %.1448.i.i, %.1479.i.i
  %.1512.i.i = fadd contract double %.1480.i.i, %.1194.i.i
  %.1543.i.i = fmul contract double %sin_h.2.0.i38.i, %.1224.i.i
  %.1574.i.i = fmul contract double %cos_h.2.0.i39.i, %.1255.i.i
  %.1575.i.i = fadd contract double %.1543.i.i, %.1574.i.i
  %.1607.i.i = fadd contract double %.1575.i.i, %.1289.i.i
  %.1638.i.i = fmul contract double %sin_h.2.0.i38.i, %.1319.i.i
  %.1669.i.i = fmul contract double %cos_h.2.0.i39.i, %.1350.i44.i
  %.1670.i.i = fadd contract double %.1638.i.i, %.1669.i.i
  %.1708.i.i = fadd contract double %.1670.i.i, %.1390.i.i
  %.1773.i.i = fmul contract double %.1129.i.i, 0.000000e+00
  %.1804.i.i = fmul contract double %.1160.i.i, 0.000000e+00
  %.1805.i.i = fadd contract double %.1773.i.i, %.1804.i.i
  %.1837.i.i = fadd contract double %.1192.i.i, %.1805.i.i
  %.1868.i.i = fmul contract double %.1224.i.i, 0.000000e+00
  %.1899.i.i = fmul contract double %.1255.i.i, 0.000000e+00
  %.1900.i.i = fadd contract double %.1868.i.i, %.1899.i.i
  %.1932.i.i = fadd contract double %.1287.i.i, %.1900.i.i
  %.1963.i.i = fmul contract double %.1319.i.i, 0.000000e+00
  %.1994.i.i = fmul contract double %.1350.i44.i, 0.000000e+00
  %.1995.i.i = fadd contract double %.1963.i.i, %.1994.i.i
  %.2033.i.i = fadd contract double %.1382.i45.i, %.1995.i.i
  %.2076.i.i = fmul contract double %cos_h.2.0.i39.i, %.1195.i.i
  %147 = fmul contract double %sin_h.2.0.i38.i, %.1290.i.i
  %.2080.i.i = fsub contract double %.2076.i.i, %147
  %.2089.i.i65 = fmul contract double %.1391.i.i, 0.000000e+00
  %.2090.i.i66 = fadd contract double %.2080.i.i, %.2089.i.i65
  %.2100.i.i = fmul contract double %cos_h.2.0.i39.i, %.1512.i.i
  %148 = fmul contract double %sin_h.2.0.i38.i, %.1607.i.i
  %.2104.i.i = fsub contract double %.2100.i.i, %148
  %.2113.i.i = fmul contract double %.1708.i.i, 0.000000e+00
  %.2114.i.i = fadd contract double %.2104.i.i, %.2113.i.i
  %.2127.i.i = fmul contract double %sin_h.2.0.i38.i, %.1512.i.i
  %.2130.i.i = fmul contract double %cos_h.2.0.i39.i, %.1607.i.i
  %.2131.i.i = fadd contract double %.2127.i.i, %.2130.i.i
  %.2141.i46.i = fadd contract double %.2131.i.i, %.2113.i.i
  %.2154.i47.i = fmul contract double %cos_h.2.0.i39.i, %.1837.i.i
  %149 = fmul contract double %sin_h.2.0.i38.i, %.1932.i.i
  %.2158.i48.i = fsub contract double %.2154.i47.i, %149
  %.2167.i49.i = fmul contract double %.2033.i.i, 0.000000e+00
  %.2168.i.i = fadd contract double %.2158.i48.i, %.2167.i49.i
  %.2181.i.i = fmul contract double %sin_h.2.0.i38.i, %.1837.i.i
  %.2184.i.i = fmul contract double %cos_h.2.0.i39.i, %.1932.i.i
  %.2185.i.i = fadd contract double %.2181.i.i, %.2184.i.i
  %.2195.i.i = fadd contract double %.2185.i.i, %.2167.i49.i
  %.2200.i.i = fadd contract double %.2090.i.i66, %.2141.i46.i
  %.2201.i.i = fmul contract double %.2200.i.i, 5.000000e-01
  %.2202.i.i = fsub contract double %.2141.i46.i, %.2090.i.i66
  %.2203.i.i = fmul contract double %.2202.i.i, 5.000000e-01
  %.2206.i50.i = fmul contract double %.399.i36.i, %.399.i36.i
  %.2209.i51.i = fmul contract double %.396.i34.i, %.396.i34.i
  %.2210.i52.i = fsub contract double %.2206.i50.i, %.2209.i51.i
  %.2241.i.i = load double, ptr %.2102.i.i, align 8, !noalias !27
  %.2247.i.i = fmul contract double %.2241.i.i, 2.000000e+00
  %.2248.i.i = tail call contract double @llvm.fma.f64(double %.2247.i.i, double 0x3FE45F306DC9C883, double 0x4338000000000000)
  %.2249.i.i = fadd contract double %.2248.i.i, 0xC338000000000000
  %.2264.i.i = tail call contract double @llvm.fma.f64(double %.2249.i.i, double 0xBFF921FB54442D18, double %.2247.i.i)
  %.2279.i.i = tail call contract double @llvm.fma.f64(double %.2249.i.i, double 0xBC91A62633145C07, double %.2264.i.i)
  %.2280.i.i = fmul contract double %.2279.i.i, %.2279.i.i
  %.2281.i.i = tail call contract double @llvm.fma.f64(double %.2280.i.i, double 0xBD6AE7F3E733B81F, double 0x3DE6124613A86D09)
  %.2282.i.i = tail call contract double @llvm.fma.f64(double %.2280.i.i, double %.2281.i.i, double 0xBE5AE64567F544E4)
  %.2283.i.i = tail call contract double @llvm.fma.f64(double %.2280.i.i, double %.2282.i.i, double 0x3EC71DE3A556C734)
  %.2284.i.i = tail call contract double @llvm.fma.f64(double %.2280.i.i, double %.2283.i.i, double 0xBF2A01A01A01A01A)
  %.2285.i.i = tail call contract double @llvm.fma.f64(double %.2280.i.i, double %.2284.i.i, double 0x3F81111111111111)
  %.2286.i.i = tail call contract double @llvm.fma.f64(double %.2280.i.i, double %.2285.i.i, double 0xBFC5555555555555)
  %.2287.i.i = fmul contract double %.2279.i.i, %.2280.i.i
  %.2288.i.i = tail call contract double @llvm.fma.f64(double %.2287.i.i, double %.2286.i.i, double %.2279.i.i)
  %.2289.i.i = tail call contract double @llvm.fma.f64(double %.2280.i.i, double 0x3D2AE7F3E733B81F, double 0xBDA93974A8C07C9D)
  %.2290.i.i = tail call contract double @llvm.fma.f64(double %.2280.i.i, double %.2289.i.i, double 0x3E21EED8EFF8D898)
  %.2291.i.i67 = tail call contract double @llvm.fma.f64(double %.2280.i.i, double %.2290.i.i, double 0xBE927E4FB7789F5C)
  %.2292.i.i68 = tail call contract double @llvm.fma.f64(double %.2280.i.i, double %.2291.i.i67, double 0x3EFA01A01A01A01A)
  %.2293.i.i = tail call contract double @llvm.fma.f64(double %.2280.i.i, double %.2292.i.i68, double 0xBF56C16C16C16C17)
  %.2294.i.i = tail call contract double @llvm.fma.f64(double %.2280.i.i, double %.2293.i.i, double 0x3FA5555555555555)
  %.2295.i.i = tail call contract double @llvm.fma.f64(double %.2280.i.i, double %.2294.i.i, double -5.000000e-01)
  %.2296.i.i = tail call contract double @llvm.fma.f64(double %.2280.i.i, double %.2295.i.i, double 1.000000e+00)
  %.2297.i.i = bitcast double %.2248.i.i to i64
  %.2298.i.i = bitcast double %.2288.i.i to i64
  %.2299.i.i = bitcast double %.2296.i.i to i64
  %.2300.i.i = xor i64 %.2299.i.i, %.2298.i.i
  %.2301.i.i = and i64 %.2297.i.i, 1
  %150 = icmp eq i64 %.2301.i.i, 0
  %.2303.i.i = select i1 %150, i64 0, i64 %.2300.i.i
  %.2304.i.i = shl i64 %.2297.i.i, 62
  %.2305.i.i = and i64 %.2304.i.i, -9223372036854775808
  %.2307.i.i = add i64 %.2304.i.i, 4611686018427387904
  %.2308.i.i = and i64 %.2307.i.i, -9223372036854775808
  %151 = xor i64 %.2305.i.i, %.2298.i.i
  %.2310.i.i = xor i64 %151, %.2303.i.i
  %.2311.i.i = bitcast i64 %.2310.i.i to double
  %152 = xor i64 %.2308.i.i, %.2299.i.i
  %.2313.i.i = xor i64 %152, %.2303.i.i
  %.2314.i.i = bitcast i64 %.2313.i.i to double
  %.2342.i.i = fmul contract double %.396.i34.i, -2.000000e+00
  %.2344.i.i = fmul contract double %.2342.i.i, %.399.i36.i
  %.2345.i.i = fsub contract double %.2201.i.i, %.2033.i.i
  %.2346.i.i = fmul contract double %.2344.i.i, %.2345.i.i
  %.2347.i.i = fmul contract double %.2210.i52.i, 2.000000e+00
  %.2348.i.i = fmul contract double %.2347.i.i, %.2168.i.i
  %.2349.i.i = fmul contract double %.2210.i52.i, -2.000000e+00
  %.2350.i.i69 = fmul contract double %.2349.i.i, %.2195.i.i
  %.2352.i.i70 = fmul contract double %.396.i34.i, 2.000000e+00
  %.2354.i.i = fmul contract double %.2352.i.i70, %.399.i36.i
  %.2355.i.i = fmul contract double %.2354.i.i, %.2203.i.i
  %.2360.i.i = fmul contract double %.2354.i.i, %.2114.i.i
  %.2381.i.i71 = fmul contract double %.2352.i.i70, %.2195.i.i
  %.2386.i.i = fmul contract double %.2352.i.i70, %.2168.i.i
  %.2388.i.i = fmul contract double %.399.i36.i, 2.000000e+00
  %.2389.i.i = fmul contract double %.2388.i.i, %.2114.i.i
  %.2391.i.i = fmul contract double %.399.i36.i, -2.000000e+00
  %.2394.i.i = fmul contract double %.2391.i.i, %.2203.i.i
  %.2551.i.i = fmul contract double %.2346.i.i, %.2314.i.i
  %.2571.i.i = fmul contract double %.2311.i.i, 0.000000e+00
  %.2572.i.i = fadd contract double %.2551.i.i, %.2571.i.i
  store double %.2572.i.i, ptr %lsr.iv.i28, align 8, !noalias !27
  %.2623.i.i = fmul contract double %.2314.i.i, 0.000000e+00
  %.2643.i.i = fmul contract double %.2346.i.i, %.2311.i.i
  %.2644.i.i = fsub contract double %.2623.i.i, %.2643.i.i
  %153 = getelementptr i8, ptr %lsr.iv.i28, i64 40
  store double %.2644.i.i, ptr %153, align 8, !noalias !27
  %.2551.1.i.i = fmul contract double %.2348.i.i, %.2314.i.i
  %.2571.1.i.i = fmul contract double %.2381.i.i71, %.2311.i.i
  %.2572.1.i.i = fadd contract double %.2551.1.i.i, %.2571.1.i.i
  %154 = getelementptr i8, ptr %lsr.iv.i28, i64 8
  store double %.2572.1.i.i, ptr %154, align 8, !noalias !27
  %.2623.1.i.i = fmul contract double %.2381.i.i71, %.2314.i.i
  %.2643.1.i.i = fmul contract double %.2348.i.i, %.2311.i.i
  %.2644.1.i.i = fsub contract double %.2623.1.i.i, %.2643.1.i.i
  %155 = getelementptr i8, ptr %lsr.iv.i28, i64 48
  store double %.2644.1.i.i, ptr %155, align 8, !noalias !27
  %.2551.2.i.i = fmul contract double %.2350.i.i69, %.2314.i.i
  %.2571.2.i.i = fmul contract double %.2386.i.i, %.2311.i.i
  %.2572.2.i.i = fadd contract double %.2551.2.i.i, %.2571.2.i.i
  %156 = getelementptr i8, ptr %lsr.iv.i28, i64 16
  store double %.2572.2.i.i, ptr %156, align 8, !noalias !27
  %.2623.2.i.i = fmul contract double %.2386.i.i, %.2314.i.i
  %.2643.2.i.i = fmul contract double %.2350.i.i69, %.2311.i.i
  %.2644.2.i.i = fsub contract double %.2623.2.i.i, %.2643.2.i.i
  %157 = getelementptr i8, ptr %lsr.iv.i28, i64 56
  store double %.2644.2.i.i, ptr %157, align 8, !noalias !27
  %.2551.3.i.i = fmul contract double %.2355.i.i, %.2314.i.i
  %.2571.3.i.i = fmul contract double %.2389.i.i, %.2311.i.i
  %.2572.3.i.i = fadd contract double %.2551.3.i.i, %.2571.3.i.i
  %158 = getelementptr i8, ptr %lsr.iv.i28, i64 24
  store double %.2572.3.i.i, ptr %158, align 8, !noalias !27
  %.2623.3.i.i = fmul contract double %.2389.i.i, %.2314.i.i
  %.2643.3.i.i = fmul contract double %.2355.i.i, %.2311.i.i
  %.2644.3.i.i = fsub contract double %.2623.3.i.i, %.2643.3.i.i
  %159 = getelementptr i8, ptr %lsr.iv.i28, i64 64
  store double %.2644.3.i.i, ptr %159, align 8, !noalias !27
  %.2551.4.i.i = fmul contract double %.2360.i.i, %.2314.i.i
  %.2571.4.i.i = fmul contract double %.2394.i.i, %.2311.i.i
  %.2572.4.i.i = fadd contract double %.2551.4.i.i, %.2571.4.i.i
  %160 = getelementptr i8, ptr %lsr.iv.i28, i64 32
  store double %.2572.4.i.i, ptr %160, align 8, !noalias !27
  %.2623.4.i.i = fmul contract double %.2394.i.i, %.2314.i.i
  %.2643.4.i.i = fmul contract double %.2360.i.i, %.2311.i.i
  %.2644.4.i.i = fsub contract double %.2623.4.i.i, %.2643.4.i.i
  %161 = getelementptr i8, ptr %lsr.iv.i28, i64 72
  store double %.2644.4.i.i, ptr %161, align 8, !noalias !27
  %162 = getelementptr i8, ptr %lsr.iv.i28, i64 120
  tail call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(32) %162, i8 0, i64 32, i1 false), !noalias !27
  %scevgep.i72 = getelementptr i8, ptr %lsr.iv.i28, i64 152
  %scevgep132.i = getelementptr i8, ptr %lsr.iv131.i, i64 200
  %lsr.iv.next.i73 = add i64 %lsr.iv133.i, 48
  %lsr.iv.next135.i = add i64 %lsr.iv134.i, 24
  %lsr.iv.next137.i = add i64 %lsr.iv136.i27, 72
  %lsr.iv.next139.i = add nsw i64 %lsr.iv138.i, -1
  %exitcond.not.i74 = icmp eq i64 %lsr.iv.next139.i, 0
  br i1 %exitcond.not.i74, label %_ZN17bnserve_inference14adjoint_kernel7_source6_placeB3v16B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit, label %B268.if.i

_ZN17bnserve_inference14adjoint_kernel7_source6_placeB3v16B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit: ; preds = %_ZN17bnserve_inference14adjoint_kernel9_response13fill_geometryB3v43B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i, %B666.if
  %.50.i = load i64, ptr %.76, align 8, !noalias !30
  %.80.i79 = load i64, ptr %.140, align 8, !noalias !30
  %.110.i = load i64, ptr %.106, align 8, !noalias !30
  %.122.i = sub i64 0, %.80.i79
  %.130.1.i = and i64 %.122.i, -8
  %.164.i = sub i64 0, %.130.1.i
  %.194.i = load i64, ptr %.193.i80, align 8, !noalias !30
  %.228.i = load i64, ptr %.227.i, align 8, !noalias !30
  %.229.i = shl i64 %.7709701030, 3
  %.231.i = mul i64 %.194.i, %.229.i
  %.232.i = add nsw i64 %.231.i, %.228.i
  %.293.i = icmp sgt i64 %.194.i, 0
  br i1 %.293.i, label %_ZN17bnserve_inference13moving_kernel8_passing12find_passingB3v59B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIxLi1E1C7mutable7alignedE.exit, label %B288.i

B288.i:                                           ; preds = %_ZN17bnserve_inference14adjoint_kernel7_source6_placeB3v16B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit
  %.373.i = shl i64 %.80.i79, 1
  %.640.i = mul nsw i64 %.50.i, %.164.i
  %.10071109.not.i = icmp slt i64 %.50.i, 1
  br i1 %.10071109.not.i, label %_ZN17bnserve_inference13moving_kernel8_passing12find_passingB3v59B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIxLi1E1C7mutable7alignedE.exit, label %B766.if.lr.ph.i

B1206.i:                                          ; preds = %B1088.if.i, %_ZN17bnserve_inference13moving_kernel8_passing6_turnsB3v74B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedExx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i
  br i1 %186, label %B1254.i, label %B1238.if.preheader.i

B1238.if.preheader.i:                             ; preds = %B1206.i
  br i1 %201, label %B1238.if.prol.loopexit.i, label %B1238.if.prol.i

B1238.if.prol.i:                                  ; preds = %B1238.if.preheader.i, %B1238.if.prol.i
  %prol.iter.i = phi i64 [ %prol.iter.next.i, %B1238.if.prol.i ], [ 0, %B1238.if.preheader.i ]
  %163 = add i64 %prol.iter.i, %.80.i79
  %.1964.prol.i = icmp slt i64 %163, 0
  %164 = select i1 %.1964.prol.i, i64 %sunkaddr217.i, i64 0
  %scevgep200.i = getelementptr i8, ptr %lsr.iv198.i, i64 %164
  %165 = shl nuw nsw i64 %prol.iter.i, 3
  %scevgep24.i = getelementptr i8, ptr %scevgep200.i, i64 %165
  store double 0.000000e+00, ptr %scevgep24.i, align 8, !noalias !30
  %prol.iter.next.i = add nuw nsw i64 %prol.iter.i, 1
  %prol.iter.cmp.not.i = icmp eq i64 %xtraiter.i, %prol.iter.next.i
  br i1 %prol.iter.cmp.not.i, label %B1238.if.prol.loopexit.loopexit.i, label %B1238.if.prol.i, !llvm.loop !33

B1238.if.prol.loopexit.loopexit.i:                ; preds = %B1238.if.prol.i
  %166 = sub nsw i64 %..1870.i, %prol.iter.next.i
  %167 = add i64 %prol.iter.next.i, %.80.i79
  br label %B1238.if.prol.loopexit.i

B1238.if.prol.loopexit.i:                         ; preds = %B1238.if.prol.loopexit.loopexit.i, %B1238.if.preheader.i
  %.191210641068.unr.i = phi i64 [ %..1870.i, %B1238.if.preheader.i ], [ %166, %B1238.if.prol.loopexit.loopexit.i ]
  %.191910651067.unr.i = phi i64 [ %.80.i79, %B1238.if.preheader.i ], [ %167, %B1238.if.prol.loopexit.loopexit.i ]
  br i1 %202, label %B1254.i, label %B1238.if.preheader179.i

B1238.if.preheader179.i:                          ; preds = %B1238.if.prol.loopexit.i
  %168 = add i64 %.191210641068.unr.i, 4
  br label %B1238.if.i

B1254.i:                                          ; preds = %B1238.if.i, %B1238.if.prol.loopexit.i, %B1206.i
  %scevgep181.i = getelementptr i8, ptr %lsr.iv180.i, i64 %173
  %scevgep192.i = getelementptr i8, ptr %lsr.iv191.i, i64 %173
  %lsr.iv.next196.i = sub i64 %lsr.iv195.i, %.130.1.i
  %scevgep199.i = getelementptr i8, ptr %lsr.iv198.i, i64 %173
  %scevgep205.i = getelementptr i8, ptr %lsr.iv204.i, i64 %173
  %exitcond1157.not.i = icmp eq i64 %.1020.i, %.50.i
  br i1 %exitcond1157.not.i, label %_ZN17bnserve_inference13moving_kernel8_passing12find_passingB3v59B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIxLi1E1C7mutable7alignedE.exit, label %B766.if.i82

B766.if.lr.ph.i:                                  ; preds = %B288.i
  %.548.i = load i64, ptr %.547.i, align 8, !noalias !30
  %.460.i = load i64, ptr %.459.i, align 8, !noalias !30
  %.362.i = load i64, ptr %.361.i, align 8, !noalias !30
  %.364.i = shl i64 %.7709701030, 4
  %.366.i = mul i64 %.364.i, %.80.i79
  %.368.i = mul i64 %.366.i, %.110.i
  %.371.i = add nsw i64 %.362.i, %.368.i
  %.725.i = load i64, ptr %.724.i, align 8, !noalias !30
  %.637.i = load i64, ptr %.636.i, align 8, !noalias !30
  %169 = inttoptr i64 %.725.i to ptr
  %170 = inttoptr i64 %.637.i to ptr
  %171 = inttoptr i64 %.232.i to ptr
  %.1129.i = getelementptr inbounds double, ptr %171, i64 %.640.i
  %.1550.i = add i64 %.80.i79, -1
  %.1870.i = sub i64 %.164.i, %.80.i79
  %..1870.i = tail call i64 @llvm.smax.i64(i64 %.1870.i, i64 0)
  %xtraiter.i = and i64 %..1870.i, 3
  %scevgep.i81 = getelementptr i8, ptr %171, i64 8
  %172 = lshr i64 %.122.i, 3
  %173 = mul i64 %172, -64
  %174 = shl i64 %172, 6
  %175 = sub i64 8, %174
  %scevgep183.i = getelementptr i8, ptr %169, i64 %175
  %176 = shl i64 %.50.i, 6
  %177 = mul i64 %176, %172
  %178 = sub i64 8, %177
  %scevgep185.i = getelementptr i8, ptr %171, i64 %178
  %scevgep190.i = getelementptr i8, ptr %170, i64 8
  %179 = shl i64 %.80.i79, 3
  %scevgep197.i = getelementptr i8, ptr %171, i64 %179
  %sunkaddr217.i = shl i64 %.164.i, 3
  %180 = shl i64 %.640.i, 3
  %181 = inttoptr i64 %.548.i to ptr
  %182 = inttoptr i64 %.460.i to ptr
  %183 = inttoptr i64 %.371.i to ptr
  %.176508.not.i.i = icmp slt i64 %.80.i79, 1
  %.369527.not.i.i = icmp slt i64 %.110.i, 1
  %.1171.i.i = icmp slt i64 %.80.i79, 2
  %..1133.i.i = select i1 %.1171.i.i, i64 0, i64 %.1550.i
  %.1213538.i.i = icmp sgt i64 %..1133.i.i, 0
  %.1406.inv.i.i = icmp sgt i64 %.80.i79, 0
  %.1407.i.i = select i1 %.1406.inv.i.i, i64 0, i64 %.164.i
  %184 = getelementptr double, ptr %.1129.i, i64 %.1550.i
  %.1421.i.i = getelementptr double, ptr %184, i64 %.1407.i.i
  %185 = icmp slt i64 %.1550.i, 1
  %sunkaddr31.i = getelementptr inbounds i8, ptr %169, i64 %sunkaddr217.i
  %186 = icmp slt i64 %.1870.i, 1
  %xtraiter.i.i = and i64 %.80.i79, 3
  %187 = icmp ult i64 %.80.i79, 4
  %188 = add nsw i64 %.80.i79, -4
  %189 = lshr i64 %188, 2
  %190 = icmp eq i64 %189, 0
  %191 = add nuw nsw i64 %189, 1
  %192 = and i64 %191, 9223372036854775806
  %193 = and i64 %188, 4
  %lcmp.mod.not9.not.i.i = icmp eq i64 %193, 0
  %lcmp.mod.not.i.i = icmp eq i64 %xtraiter.i.i, 0
  %194 = tail call i64 @llvm.smax.i64(i64 %.80.i79, i64 1)
  %195 = add nsw i64 %194, -1
  %196 = shl i64 %.80.i79, 4
  %factor.op.mul.i = shl i64 %.80.i79, 4
  %.375.reass.i = mul i64 %factor.op.mul.i, %.110.i
  %197 = add i64 %.375.reass.i, 16
  %198 = add i64 %.375.reass.i, 24
  %199 = icmp sgt i64 %.80.i79, 1
  %200 = or disjoint i64 %.375.reass.i, 8
  %201 = icmp eq i64 %xtraiter.i, 0
  %202 = icmp slt i64 %.1870.i, 4
  br label %B766.if.i82

B766.if.i82:                                      ; preds = %B766.if.lr.ph.i, %B1254.i
  %lsr.iv204.i = phi ptr [ %171, %B766.if.lr.ph.i ], [ %scevgep205.i, %B1254.i ]
  %lsr.iv198.i = phi ptr [ %scevgep197.i, %B766.if.lr.ph.i ], [ %scevgep199.i, %B1254.i ]
  %lsr.iv195.i = phi i64 [ 1, %B766.if.lr.ph.i ], [ %lsr.iv.next196.i, %B1254.i ]
  %lsr.iv191.i = phi ptr [ %scevgep190.i, %B766.if.lr.ph.i ], [ %scevgep192.i, %B1254.i ]
  %lsr.iv180.i = phi ptr [ %scevgep.i81, %B766.if.lr.ph.i ], [ %scevgep181.i, %B1254.i ]
  %.101310761114.i = phi i64 [ 0, %B766.if.lr.ph.i ], [ %.1020.i, %B1254.i ]
  %.1020.i = add nuw nsw i64 %.101310761114.i, 1
  %.1051.i = mul nsw i64 %.101310761114.i, %.164.i
  %.1063.i = getelementptr inbounds double, ptr %171, i64 %.1051.i
  %.1200.i = shl nuw nsw i64 %.101310761114.i, 1
  %.1202.i = mul nsw i64 %.1200.i, %.164.i
  %.1214.i83 = getelementptr inbounds double, ptr %181, i64 %.1202.i
  %.1268.neg.i = xor i64 %.1200.i, -1
  %.1270.i = mul i64 %.130.1.i, %.1268.neg.i
  %.1282.i = getelementptr inbounds double, ptr %181, i64 %.1270.i
  br i1 %.176508.not.i.i, label %B60.i.i, label %B34.if.preheader.i.i

B34.if.preheader.i.i:                             ; preds = %B766.if.i82
  br i1 %187, label %B34.if.epil.preheader.i.i, label %B34.if.preheader.new.i.i

B34.if.preheader.new.i.i:                         ; preds = %B34.if.preheader.i.i
  br i1 %190, label %B34.if.epil.preheader1.i.i, label %B34.if.i.i

B60.loopexit.unr-lcssa.unr-lcssa.i.i:             ; preds = %B34.if.i.i
  br i1 %lcmp.mod.not9.not.i.i, label %B34.if.epil.preheader1.i.i, label %B60.loopexit.unr-lcssa.i.i

B34.if.epil.preheader1.i.i:                       ; preds = %B60.loopexit.unr-lcssa.unr-lcssa.i.i, %B34.if.preheader.new.i.i
  %.182507509.epil.init5.i.i = phi i64 [ 0, %B34.if.preheader.new.i.i ], [ %.189.3.1.i.i, %B60.loopexit.unr-lcssa.unr-lcssa.i.i ]
  %sunkaddr.epil.i.i = shl i64 %.182507509.epil.init5.i.i, 3
  %sunkaddr50.epil.i.i = getelementptr i8, ptr %.1063.i, i64 %sunkaddr.epil.i.i
  store double 0.000000e+00, ptr %sunkaddr50.epil.i.i, align 8, !noalias !35
  %sunkaddr52.epil.i.i = getelementptr i8, ptr %.1129.i, i64 %sunkaddr.epil.i.i
  store double 0.000000e+00, ptr %sunkaddr52.epil.i.i, align 8, !noalias !35
  %sunkaddr55.epil.i.i = getelementptr i8, ptr %sunkaddr50.epil.i.i, i64 8
  store double 0.000000e+00, ptr %sunkaddr55.epil.i.i, align 8, !noalias !35
  %sunkaddr58.epil.i.i = getelementptr i8, ptr %sunkaddr52.epil.i.i, i64 8
  store double 0.000000e+00, ptr %sunkaddr58.epil.i.i, align 8, !noalias !35
  %sunkaddr61.epil.i.i = getelementptr i8, ptr %sunkaddr50.epil.i.i, i64 16
  store double 0.000000e+00, ptr %sunkaddr61.epil.i.i, align 8, !noalias !35
  %sunkaddr64.epil.i.i = getelementptr i8, ptr %sunkaddr52.epil.i.i, i64 16
  store double 0.000000e+00, ptr %sunkaddr64.epil.i.i, align 8, !noalias !35
  %.189.3.epil.i.i = add nuw nsw i64 %.182507509.epil.init5.i.i, 4
  %sunkaddr67.epil.i.i = getelementptr i8, ptr %sunkaddr50.epil.i.i, i64 24
  store double 0.000000e+00, ptr %sunkaddr67.epil.i.i, align 8, !noalias !35
  %sunkaddr70.epil.i.i = getelementptr i8, ptr %sunkaddr52.epil.i.i, i64 24
  store double 0.000000e+00, ptr %sunkaddr70.epil.i.i, align 8, !noalias !35
  br label %B60.loopexit.unr-lcssa.i.i

B60.loopexit.unr-lcssa.i.i:                       ; preds = %B34.if.epil.preheader1.i.i, %B60.loopexit.unr-lcssa.unr-lcssa.i.i
  %.189.3.lcssa.i.i = phi i64 [ %.189.3.epil.i.i, %B34.if.epil.preheader1.i.i ], [ %.189.3.1.i.i, %B60.loopexit.unr-lcssa.unr-lcssa.i.i ]
  br i1 %lcmp.mod.not.i.i, label %B60.i.i, label %B34.if.epil.preheader.i.i

B34.if.epil.preheader.i.i:                        ; preds = %B60.loopexit.unr-lcssa.i.i, %B34.if.preheader.i.i
  %.182507509.epil.init.i.i = phi i64 [ 0, %B34.if.preheader.i.i ], [ %.189.3.lcssa.i.i, %B60.loopexit.unr-lcssa.i.i ]
  %203 = shl i64 %.182507509.epil.init.i.i, 3
  %scevgep30.i.i91 = getelementptr i8, ptr %.1129.i, i64 %203
  %scevgep32.i.i = getelementptr i8, ptr %.1063.i, i64 %203
  br label %B34.if.epil.i.i

B34.if.epil.i.i:                                  ; preds = %B34.if.epil.i.i, %B34.if.epil.preheader.i.i
  %epil.iter.i.i = phi i64 [ %epil.iter.next.i.i, %B34.if.epil.i.i ], [ 0, %B34.if.epil.preheader.i.i ]
  %204 = shl i64 %epil.iter.i.i, 3
  %scevgep42.i.i92 = getelementptr i8, ptr %scevgep32.i.i, i64 %204
  store double 0.000000e+00, ptr %scevgep42.i.i92, align 8, !noalias !35
  %scevgep41.i.i93 = getelementptr i8, ptr %scevgep30.i.i91, i64 %204
  store double 0.000000e+00, ptr %scevgep41.i.i93, align 8, !noalias !35
  %epil.iter.next.i.i = add i64 %epil.iter.i.i, 1
  %epil.iter.cmp.not.i.i = icmp eq i64 %xtraiter.i.i, %epil.iter.next.i.i
  br i1 %epil.iter.cmp.not.i.i, label %B60.i.i, label %B34.if.epil.i.i, !llvm.loop !38

B60.i.i:                                          ; preds = %B34.if.epil.i.i, %B60.loopexit.unr-lcssa.i.i, %B766.if.i82
  br i1 %.369527.not.i.i, label %B682.i.i, label %B112.if.i.i

B678.i.i:                                         ; preds = %B196.if.i.i, %B112.if.i.i
  %lsr.iv.next8.i.i = add i64 %lsr.iv7.i.i, %.373.i
  %scevgep14.i.i = getelementptr i8, ptr %lsr.iv13.i.i, i64 %196
  %exitcond544.not.i.i = icmp eq i64 %.382.i.i94, %.110.i
  br i1 %exitcond544.not.i.i, label %B682.i.i, label %B112.if.i.i

B682.i.i:                                         ; preds = %B678.i.i, %B60.i.i
  br i1 %.1213538.i.i, label %B718.if.i.i, label %_ZN17bnserve_inference13moving_kernel8_passing6_turnsB3v74B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedExx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i

B34.if.i.i:                                       ; preds = %B34.if.preheader.new.i.i, %B34.if.i.i
  %lsr.iv23.i.i84 = phi i64 [ %lsr.iv.next24.i.i89, %B34.if.i.i ], [ %192, %B34.if.preheader.new.i.i ]
  %.182507509.i.i = phi i64 [ %.189.3.1.i.i, %B34.if.i.i ], [ 0, %B34.if.preheader.new.i.i ]
  %sunkaddr64.i.i85 = shl i64 %.182507509.i.i, 3
  %sunkaddr65.i.i = getelementptr i8, ptr %.1063.i, i64 %sunkaddr64.i.i85
  store double 0.000000e+00, ptr %sunkaddr65.i.i, align 8, !noalias !35
  %sunkaddr67.i.i86 = getelementptr i8, ptr %.1129.i, i64 %sunkaddr64.i.i85
  store double 0.000000e+00, ptr %sunkaddr67.i.i86, align 8, !noalias !35
  %sunkaddr69.i.i87 = getelementptr i8, ptr %sunkaddr65.i.i, i64 8
  store double 0.000000e+00, ptr %sunkaddr69.i.i87, align 8, !noalias !35
  %sunkaddr72.i.i = getelementptr i8, ptr %sunkaddr67.i.i86, i64 8
  store double 0.000000e+00, ptr %sunkaddr72.i.i, align 8, !noalias !35
  %sunkaddr75.i.i88 = getelementptr i8, ptr %sunkaddr65.i.i, i64 16
  store double 0.000000e+00, ptr %sunkaddr75.i.i88, align 8, !noalias !35
  %sunkaddr78.i.i = getelementptr i8, ptr %sunkaddr67.i.i86, i64 16
  store double 0.000000e+00, ptr %sunkaddr78.i.i, align 8, !noalias !35
  %sunkaddr81.i.i = getelementptr i8, ptr %sunkaddr65.i.i, i64 24
  store double 0.000000e+00, ptr %sunkaddr81.i.i, align 8, !noalias !35
  %sunkaddr84.i.i = getelementptr i8, ptr %sunkaddr67.i.i86, i64 24
  store double 0.000000e+00, ptr %sunkaddr84.i.i, align 8, !noalias !35
  %sunkaddr87.i.i = getelementptr i8, ptr %sunkaddr65.i.i, i64 32
  store double 0.000000e+00, ptr %sunkaddr87.i.i, align 8, !noalias !35
  %sunkaddr90.i.i = getelementptr i8, ptr %sunkaddr67.i.i86, i64 32
  store double 0.000000e+00, ptr %sunkaddr90.i.i, align 8, !noalias !35
  %sunkaddr93.i.i = getelementptr i8, ptr %sunkaddr65.i.i, i64 40
  store double 0.000000e+00, ptr %sunkaddr93.i.i, align 8, !noalias !35
  %sunkaddr96.i.i = getelementptr i8, ptr %sunkaddr67.i.i86, i64 40
  store double 0.000000e+00, ptr %sunkaddr96.i.i, align 8, !noalias !35
  %sunkaddr99.i.i = getelementptr i8, ptr %sunkaddr65.i.i, i64 48
  store double 0.000000e+00, ptr %sunkaddr99.i.i, align 8, !noalias !35
  %sunkaddr102.i.i = getelementptr i8, ptr %sunkaddr67.i.i86, i64 48
  store double 0.000000e+00, ptr %sunkaddr102.i.i, align 8, !noalias !35
  %.189.3.1.i.i = add i64 %.182507509.i.i, 8
  %sunkaddr103.i.i = shl i64 %.189.3.1.i.i, 3
  %sunkaddr104.i.i = getelementptr i8, ptr %.1063.i, i64 %sunkaddr103.i.i
  %sunkaddr106.i.i = getelementptr i8, ptr %sunkaddr104.i.i, i64 -8
  store double 0.000000e+00, ptr %sunkaddr106.i.i, align 8, !noalias !35
  %sunkaddr108.i.i = getelementptr i8, ptr %.1129.i, i64 %sunkaddr103.i.i
  %sunkaddr109.i.i = getelementptr i8, ptr %sunkaddr108.i.i, i64 -8
  store double 0.000000e+00, ptr %sunkaddr109.i.i, align 8, !noalias !35
  %lsr.iv.next24.i.i89 = add i64 %lsr.iv23.i.i84, -2
  %niter.ncmp.1.i.i90 = icmp eq i64 %lsr.iv.next24.i.i89, 0
  br i1 %niter.ncmp.1.i.i90, label %B60.loopexit.unr-lcssa.unr-lcssa.i.i, label %B34.if.i.i

B112.if.i.i:                                      ; preds = %B60.i.i, %B678.i.i
  %lsr.iv13.i.i = phi ptr [ %scevgep14.i.i, %B678.i.i ], [ %183, %B60.i.i ]
  %lsr.iv7.i.i = phi i64 [ %lsr.iv.next8.i.i, %B678.i.i ], [ 0, %B60.i.i ]
  %.375520530.i.i = phi i64 [ %.382.i.i94, %B678.i.i ], [ 0, %B60.i.i ]
  %.382.i.i94 = add nuw nsw i64 %.375520530.i.i, 1
  %205 = getelementptr i64, ptr %182, i64 %.375520530.i.i
  %.440.i.i = load i64, ptr %205, align 8, !noalias !35
  %.442.i.i = icmp eq i64 %.440.i.i, %.101310761114.i
  %or.cond.i.i = and i1 %199, %.442.i.i
  br i1 %or.cond.i.i, label %B196.if.i.i, label %B678.i.i

B196.if.i.i:                                      ; preds = %B112.if.i.i, %B196.if.i.i
  %lsr.iv3.i.i108 = phi i64 [ %lsr.iv.next4.i.i, %B196.if.i.i ], [ 0, %B112.if.i.i ]
  %lsr.iv.i.i109 = phi i64 [ %lsr.iv.next.i.i131, %B196.if.i.i ], [ %195, %B112.if.i.i ]
  %sunkaddr110.i.i = shl i64 %lsr.iv3.i.i108, 2
  %sunkaddr111.i.i = getelementptr i8, ptr %.1214.i83, i64 %sunkaddr110.i.i
  %sunkaddr112.i.i = getelementptr i8, ptr %sunkaddr111.i.i, i64 8
  %.602.i.i = load double, ptr %sunkaddr112.i.i, align 8, !noalias !35
  %.632.i.i = load double, ptr %sunkaddr111.i.i, align 8, !noalias !35
  %.633.i.i = fmul contract double %.602.i.i, %.632.i.i
  %sunkaddr116.i.i = getelementptr i8, ptr %.1282.i, i64 %sunkaddr110.i.i
  %sunkaddr117.i.i = getelementptr i8, ptr %sunkaddr116.i.i, i64 8
  %.664.i.i = load double, ptr %sunkaddr117.i.i, align 8, !noalias !35
  %.694.i.i = load double, ptr %sunkaddr116.i.i, align 8, !noalias !35
  %.695.i.i = fmul contract double %.664.i.i, %.694.i.i
  %.696.i.i110 = fadd contract double %.633.i.i, %.695.i.i
  %.758.i.i = fmul contract double %.602.i.i, %.694.i.i
  %.820.i.i = fmul contract double %.632.i.i, %.664.i.i
  %.821.i.i111 = fsub contract double %.758.i.i, %.820.i.i
  %206 = add i64 %lsr.iv3.i.i108, %lsr.iv7.i.i
  %.839.i.i = icmp slt i64 %206, -2
  %207 = shl i64 %lsr.iv3.i.i108, 3
  %208 = select i1 %.839.i.i, i64 %197, i64 16
  %scevgep39.i.i112 = getelementptr i8, ptr %lsr.iv13.i.i, i64 %208
  %scevgep40.i.i = getelementptr i8, ptr %scevgep39.i.i112, i64 %207
  %.855.i.i = load double, ptr %scevgep40.i.i, align 8, !noalias !35
  %.873.i.i = icmp slt i64 %206, -3
  %209 = select i1 %.873.i.i, i64 %198, i64 24
  %scevgep37.i.i = getelementptr i8, ptr %lsr.iv13.i.i, i64 %209
  %scevgep22.i.i = getelementptr i8, ptr %scevgep37.i.i, i64 %207
  %.889.i.i = load double, ptr %scevgep22.i.i, align 8, !noalias !35
  %.906.i.i = icmp slt i64 %206, 0
  %210 = select i1 %.906.i.i, i64 %200, i64 8
  %scevgep19.i.i113 = getelementptr i8, ptr %lsr.iv13.i.i, i64 %210
  %scevgep20.i.i = getelementptr i8, ptr %scevgep19.i.i113, i64 %207
  %scevgep21.i.i114 = getelementptr i8, ptr %scevgep20.i.i, i64 -8
  %.922.i.i115 = load double, ptr %scevgep21.i.i114, align 8, !noalias !35
  %.956.i.i116 = load double, ptr %scevgep20.i.i, align 8, !noalias !35
  %.957.i.i117 = fmul contract double %.855.i.i, %.922.i.i115
  %.958.i.i = fmul contract double %.889.i.i, %.956.i.i116
  %.959.i.i118 = fadd contract double %.957.i.i117, %.958.i.i
  %.960.i.i119 = fmul contract double %.889.i.i, %.922.i.i115
  %.961.i.i = fmul contract double %.855.i.i, %.956.i.i116
  %.962.i.i120 = fsub contract double %.960.i.i119, %.961.i.i
  %.963.i.i = fmul contract double %.696.i.i110, %.959.i.i118
  %.964.i.i121 = fmul contract double %.821.i.i111, %.962.i.i120
  %.965.i.i122 = fsub contract double %.963.i.i, %.964.i.i121
  %.966.i.i123 = fmul contract double %.821.i.i111, %.959.i.i118
  %.967.i.i124 = fmul contract double %.696.i.i110, %.962.i.i120
  %.968.i.i = fadd contract double %.966.i.i123, %.967.i.i124
  %scevgep5.i.i = getelementptr i8, ptr %.1063.i, i64 %sunkaddr110.i.i
  %.998.i.i125 = load double, ptr %scevgep5.i.i, align 8, !noalias !35
  %.999.i.i = fmul contract double %.965.i.i122, %.965.i.i122
  %.1000.i.i126 = fmul contract double %.968.i.i, %.968.i.i
  %.1001.i.i = fsub contract double %.999.i.i, %.1000.i.i126
  %.1002.i.i = fadd contract double %.998.i.i125, %.1001.i.i
  store double %.1002.i.i, ptr %scevgep5.i.i, align 8, !noalias !35
  %scevgep4.i.i127 = getelementptr i8, ptr %.1129.i, i64 %sunkaddr110.i.i
  %.1062.i.i128 = load double, ptr %scevgep4.i.i127, align 8, !noalias !35
  %.1063.i.i129 = fmul contract double %.965.i.i122, 2.000000e+00
  %.1064.i.i130 = fmul contract double %.968.i.i, %.1063.i.i129
  %.1065.i.i = fadd contract double %.1062.i.i128, %.1064.i.i130
  store double %.1065.i.i, ptr %scevgep4.i.i127, align 8, !noalias !35
  %lsr.iv.next.i.i131 = add nsw i64 %lsr.iv.i.i109, -1
  %lsr.iv.next4.i.i = add nuw i64 %lsr.iv3.i.i108, 2
  %exitcond543.not.i.i = icmp eq i64 %lsr.iv.next.i.i131, 0
  br i1 %exitcond543.not.i.i, label %B678.i.i, label %B196.if.i.i

B718.if.i.i:                                      ; preds = %B682.i.i, %B718.if.i.i
  %.1219537539.i.i = phi i64 [ %.1226.i.i100, %B718.if.i.i ], [ 0, %B682.i.i ]
  %.1226.i.i100 = add nuw nsw i64 %.1219537539.i.i, 1
  %211 = shl i64 %.1219537539.i.i, 3
  %scevgep2.i.i = getelementptr i8, ptr %.1063.i, i64 %211
  %.1281.i.i = load double, ptr %scevgep2.i.i, align 8, !noalias !35
  %scevgep.i.i101 = getelementptr i8, ptr %.1129.i, i64 %211
  %.1311.i.i = load double, ptr %scevgep.i.i101, align 8, !noalias !35
  %.1312.i.i = fmul contract double %.1281.i.i, %.1281.i.i
  %.1313.i.i = fmul contract double %.1311.i.i, %.1311.i.i
  %.1314.i.i = fadd contract double %.1312.i.i, %.1313.i.i
  %.1315.i.i = tail call contract double @llvm.sqrt.f64(double %.1314.i.i)
  %.1316.i.i = fadd contract double %.1281.i.i, %.1315.i.i
  %.1317.i.i = fadd contract double %.1316.i.i, 1.000000e-300
  %.1321.i.i102 = fdiv contract double %.1311.i.i, %.1317.i.i
  %.1322.i.i = fmul contract double %.1321.i.i102, %.1321.i.i102
  %.1323.i.i = fadd contract double %.1322.i.i, 1.000000e+00
  %.1324.i.i = tail call contract double @llvm.sqrt.f64(double %.1323.i.i)
  %.1325.i.i = fadd contract double %.1324.i.i, 1.000000e+00
  %.1329.i.i = fdiv contract double %.1321.i.i102, %.1325.i.i
  %.1330.i.i = fmul contract double %.1329.i.i, %.1329.i.i
  %.1331.i.i = fmul contract double %.1330.i.i, 0x3F677AE9349F5F7A
  %.1332.i.i = fadd contract double %.1331.i.i, 0xBF908DC039C4DC63
  %.1333.i.i = fmul contract double %.1330.i.i, %.1332.i.i
  %.1334.i.i = fadd contract double %.1333.i.i, 0x3FA5F83FB7E8F47D
  %.1335.i.i = fmul contract double %.1330.i.i, %.1334.i.i
  %.1336.i.i = fadd contract double %.1335.i.i, 0xBFB3462E8D8711AD
  %.1337.i.i = fmul contract double %.1330.i.i, %.1336.i.i
  %.1338.i.i = fadd contract double %.1337.i.i, 0x3FBB47B06AC4D989
  %.1339.i.i = fmul contract double %.1330.i.i, %.1338.i.i
  %.1340.i.i103 = fadd contract double %.1339.i.i, 0xBFC22FF8E008E644
  %.1341.i.i104 = fmul contract double %.1330.i.i, %.1340.i.i103
  %.1342.i.i105 = fadd contract double %.1341.i.i104, 0x3FC9977C9B288755
  %.1343.i.i106 = fmul contract double %.1330.i.i, %.1342.i.i105
  %.1344.i.i107 = fadd contract double %.1343.i.i106, 0xBFD5554D72204448
  %.1345.i.i = fmul contract double %.1330.i.i, %.1344.i.i107
  %.1346.i.i = fadd contract double %.1345.i.i, 1.000000e+00
  %.1347.i.i = fmul contract double %.1329.i.i, 2.000000e+00
  %.1348.i.i = fmul contract double %.1347.i.i, %.1346.i.i
  store double %.1348.i.i, ptr %scevgep.i.i101, align 8, !noalias !35
  %exitcond545.not.i.i = icmp eq i64 %..1133.i.i, %.1226.i.i100
  br i1 %exitcond545.not.i.i, label %_ZN17bnserve_inference13moving_kernel8_passing6_turnsB3v74B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedExx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i, label %B718.if.i.i

_ZN17bnserve_inference13moving_kernel8_passing6_turnsB3v74B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedExx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i: ; preds = %B718.if.i.i, %B682.i.i
  store double 0.000000e+00, ptr %.1421.i.i, align 8, !noalias !35
  %.1404.i = icmp slt i64 %.1051.i, 0
  %.1405.i = select i1 %.1404.i, i64 %.640.i, i64 0
  %212 = getelementptr double, ptr %170, i64 %.1051.i
  %.1419.i = getelementptr double, ptr %212, i64 %.1405.i
  %.1420.i = load double, ptr %.1419.i, align 8, !noalias !30
  %.1450.i = load double, ptr %sunkaddr31.i, align 8, !noalias !30
  %.1480.i = load double, ptr %.1129.i, align 8, !noalias !30
  %.1481.i = fmul contract double %.1450.i, %.1480.i
  %.1482.i = fsub contract double %.1420.i, %.1481.i
  store double %.1482.i, ptr %.1063.i, align 8, !noalias !30
  br i1 %185, label %B1206.i, label %B1088.if.i

B1088.if.i:                                       ; preds = %_ZN17bnserve_inference13moving_kernel8_passing6_turnsB3v74B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedExx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i, %B1088.if.i
  %lsr.iv.i95 = phi i64 [ %lsr.iv.next.i98, %B1088.if.i ], [ 0, %_ZN17bnserve_inference13moving_kernel8_passing6_turnsB3v74B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedExx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i ]
  %213 = add i64 %lsr.iv.i95, %lsr.iv195.i
  %.1648.i = icmp slt i64 %213, 0
  %214 = select i1 %.1648.i, i64 %180, i64 0
  %scevgep193.i = getelementptr i8, ptr %lsr.iv191.i, i64 %214
  %215 = shl i64 %lsr.iv.i95, 3
  %scevgep194.i = getelementptr i8, ptr %scevgep193.i, i64 %215
  %.1664.i = load double, ptr %scevgep194.i, align 8, !noalias !30
  %sunkaddr32.i = getelementptr i8, ptr %169, i64 %215
  %sunkaddr33.i = getelementptr i8, ptr %sunkaddr32.i, i64 8
  %.1694.i = load double, ptr %sunkaddr33.i, align 8, !noalias !30
  %scevgep20.i = getelementptr i8, ptr %scevgep185.i, i64 %215
  %scevgep21.i96 = getelementptr i8, ptr %scevgep20.i, i64 -8
  %.1725.i = load double, ptr %scevgep21.i96, align 8, !noalias !30
  %.1726.i = fmul contract double %.1694.i, %.1725.i
  %scevgep12.i = getelementptr i8, ptr %scevgep183.i, i64 %215
  %.1756.i = load double, ptr %scevgep12.i, align 8, !noalias !30
  %.1786.i = load double, ptr %scevgep20.i, align 8, !noalias !30
  %.1787.i = fmul contract double %.1756.i, %.1786.i
  %.1788.i = fadd contract double %.1726.i, %.1787.i
  %.1789.i = fsub contract double %.1664.i, %.1788.i
  %scevgep11.i97 = getelementptr i8, ptr %lsr.iv180.i, i64 %215
  store double %.1789.i, ptr %scevgep11.i97, align 8, !noalias !30
  %lsr.iv.next.i98 = add nuw nsw i64 %lsr.iv.i95, 1
  %exitcond.not.i99 = icmp eq i64 %.1550.i, %lsr.iv.next.i98
  br i1 %exitcond.not.i99, label %B1206.i, label %B1088.if.i

B1238.if.i:                                       ; preds = %B1238.if.i, %B1238.if.preheader179.i
  %lsr.iv202.i = phi i64 [ %168, %B1238.if.preheader179.i ], [ %lsr.iv.next203.i, %B1238.if.i ]
  %.191910651067.i = phi i64 [ %.191910651067.unr.i, %B1238.if.preheader179.i ], [ %224, %B1238.if.i ]
  %.1964.i = icmp slt i64 %.191910651067.i, 0
  %216 = select i1 %.1964.i, i64 %sunkaddr217.i, i64 0
  %scevgep212.i = getelementptr i8, ptr %lsr.iv204.i, i64 %216
  %217 = shl i64 %.191910651067.i, 3
  %scevgep213.i = getelementptr i8, ptr %scevgep212.i, i64 %217
  store double 0.000000e+00, ptr %scevgep213.i, align 8, !noalias !30
  %218 = add i64 %.191910651067.i, 1
  %.1964.1.i = icmp slt i64 %218, 0
  %219 = select i1 %.1964.1.i, i64 %sunkaddr217.i, i64 0
  %scevgep214.i = getelementptr i8, ptr %lsr.iv204.i, i64 %219
  %scevgep29.i = getelementptr i8, ptr %scevgep214.i, i64 %217
  %scevgep30.i = getelementptr i8, ptr %scevgep29.i, i64 8
  store double 0.000000e+00, ptr %scevgep30.i, align 8, !noalias !30
  %220 = add i64 %.191910651067.i, 2
  %.1964.2.i = icmp slt i64 %220, 0
  %221 = select i1 %.1964.2.i, i64 %sunkaddr217.i, i64 0
  %scevgep209.i = getelementptr i8, ptr %lsr.iv204.i, i64 %221
  %scevgep27.i = getelementptr i8, ptr %scevgep209.i, i64 %217
  %scevgep28.i = getelementptr i8, ptr %scevgep27.i, i64 16
  store double 0.000000e+00, ptr %scevgep28.i, align 8, !noalias !30
  %222 = add i64 %.191910651067.i, 3
  %.1964.3.i = icmp slt i64 %222, 0
  %223 = select i1 %.1964.3.i, i64 %sunkaddr217.i, i64 0
  %scevgep206.i = getelementptr i8, ptr %lsr.iv204.i, i64 %223
  %scevgep25.i = getelementptr i8, ptr %scevgep206.i, i64 %217
  %scevgep26.i = getelementptr i8, ptr %scevgep25.i, i64 24
  store double 0.000000e+00, ptr %scevgep26.i, align 8, !noalias !30
  %lsr.iv.next203.i = add i64 %lsr.iv202.i, -4
  %.1913.3.i = icmp sgt i64 %lsr.iv.next203.i, 4
  %224 = add i64 %.191910651067.i, 4
  br i1 %.1913.3.i, label %B1238.if.i, label %B1254.i

_ZN17bnserve_inference13moving_kernel8_passing12find_passingB3v59B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIxLi1E1C7mutable7alignedE.exit: ; preds = %B1254.i, %B288.i, %_ZN17bnserve_inference14adjoint_kernel7_source6_placeB3v16B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit
  %.961.sroa.12.1 = inttoptr i64 %.232.i to ptr
  br i1 %.1084949.not, label %B1254, label %B918.if.preheader

B918.if.preheader:                                ; preds = %_ZN17bnserve_inference13moving_kernel8_passing12find_passingB3v59B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIxLi1E1C7mutable7alignedE.exit
  %.268.i.i238 = shl i64 %.7709701030, 4
  br label %B918.if

B918.if:                                          ; preds = %B918.if.preheader, %_ZN17bnserve_inference14adjoint_kernel7_source11_block_backB4v479B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit
  %.1083927953 = phi i64 [ %.1093, %_ZN17bnserve_inference14adjoint_kernel7_source11_block_backB4v479B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit ], [ %.1063, %B918.if.preheader ]
  %.1090933952 = phi i64 [ %.1097, %_ZN17bnserve_inference14adjoint_kernel7_source11_block_backB4v479B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit ], [ 0, %B918.if.preheader ]
  %.1093 = add nsw i64 %.1083927953, -1
  %.1097 = add i64 %.1090933952, 128
  %.1127 = sub nsw i64 %.184, %.1090933952
  %.13.i = tail call i64 @llvm.smin.i64(i64 %.1127, i64 128)
  %.82.i = load i64, ptr %.106, align 8, !noalias !39
  %.112.i = load i64, ptr %.76, align 8, !noalias !39
  %.142.i = load i64, ptr %.140, align 8, !noalias !39
  %.179.i = load i64, ptr %.178.i, align 8, !noalias !39
  %.181.i = shl nsw i64 %.82.i, 4
  %.183.i = mul i64 %.181.i, %.7709701030
  %.184.i = mul i64 %.183.i, %.142.i
  %.185.i = add nsw i64 %.184.i, %.179.i
  %.276.i = load i64, ptr %.275.i132, align 8, !noalias !39
  %.279.i = mul i64 %.82.i, %.229.i
  %.280.i = add nsw i64 %.276.i, %.279.i
  %.366.i133 = load i64, ptr %.365.i, align 8, !noalias !39
  %.370.i = add nsw i64 %.366.i133, %.183.i
  %.457.i = load i64, ptr %.456.i, align 8, !noalias !39
  %.754833.not.i = icmp slt i64 %.112.i, 1
  br i1 %.754833.not.i, label %B732.i, label %B582.if.lr.ph.i

B732.i:                                           ; preds = %B584.endif.endif.endif.i, %B918.if
  %.1112851.not.i = icmp slt i64 %.82.i, 1
  br i1 %.1112851.not.i, label %_ZN17bnserve_inference14adjoint_kernel7_source9_polariseB3v77B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit, label %B762.if.lr.ph.i

B762.if.lr.ph.i:                                  ; preds = %B732.i
  %.1272.i = sub i64 %.142.i, %.1090933952
  %.13.i.i149 = tail call i64 @llvm.smin.i64(i64 %.1272.i, i64 range(i64 -9223372036854775808, 129) %.13.i)
  %.515.i.i = sub i64 %.13.i, %.13.i.i149
  %unroll_iter.i81.i = and i64 %.13.i.i149, 9223372036854775806
  %.neg.i.i = add nsw i64 %.13.i.i149, 1
  %.567.prol.i.i = add nsw i64 %.515.i.i, -1
  %225 = getelementptr double, ptr %.54.i.i, i64 %.13.i.i149
  %226 = getelementptr double, ptr %.141.i.i, i64 %.13.i.i149
  %.102.i.i150 = lshr exact i64 %.13.i, 3
  %.79.inv.i.i = icmp slt i64 %.1127, 1
  %227 = add nsw i64 %unroll_iter.i81.i, -2
  %228 = lshr exact i64 %227, 1
  %229 = add nuw i64 %228, 1
  %230 = shl i64 %.1090933952, 4
  %231 = sub nuw nsw i64 -24, %230
  %232 = shl i64 %.142.i, 4
  %233 = lshr i64 %.13.i.i149, 53
  %sunkaddr349.i = and i64 %233, 1024
  %234 = and i64 %229, -2
  %235 = add nuw nsw i64 %.102.i.i150, 4
  %236 = icmp slt i64 %.13.i.i149, 1
  %237 = inttoptr i64 %.457.i to ptr
  %238 = inttoptr i64 %.185.i to ptr
  %239 = icmp slt i64 %.515.i.i, 1
  %240 = icmp eq i64 %.13.i.i149, 1
  %241 = icmp eq i64 %227, 0
  %242 = and i64 %227, 2
  %243 = icmp eq i64 %242, 0
  %244 = and i64 %.13.i.i149, 1
  %245 = icmp eq i64 %244, 0
  %246 = and i64 %.515.i.i, 1
  %247 = icmp eq i64 %246, 0
  %sunkaddr152.i = getelementptr inbounds nuw i8, ptr %225, i64 %sunkaddr349.i
  %sunkaddr.i151 = getelementptr inbounds nuw i8, ptr %226, i64 %sunkaddr349.i
  %248 = icmp eq i64 %.13.i, %.neg.i.i
  %249 = inttoptr i64 %.370.i to ptr
  %250 = inttoptr i64 %.280.i to ptr
  br label %B762.if.i

B582.if.lr.ph.i:                                  ; preds = %B918.if
  %.626.i = sub i64 0, %.142.i
  %.543.i = load i64, ptr %.542.i, align 8, !noalias !39
  %.544.i = inttoptr i64 %.543.i to ptr
  %.619.i134 = getelementptr i8, ptr %.544.i, i64 8
  %.620.i = load double, ptr %.619.i134, align 8, !noalias !39
  %.387.i.i135 = lshr exact i64 %.13.i, 3
  %.366.inv.i.i = icmp slt i64 %.1127, 1
  %xtraiter.i.i136 = and i64 %.387.i.i135, 3
  %251 = shl nuw nsw i64 %xtraiter.i.i136, 6
  %.6.i.i.i137 = insertelement <8 x double> poison, double %.620.i, i64 0
  %.7.i.i.i138 = shufflevector <8 x double> %.6.i.i.i137, <8 x double> poison, <8 x i32> zeroinitializer
  %252 = add nsw i64 %.387.i.i135, -4
  %253 = lshr i64 %252, 2
  %254 = add nuw nsw i64 %253, 1
  %xtraiter.i139 = and i64 %254, 3
  %255 = shl i64 %.1090933952, 3
  %scevgep335.i = getelementptr i8, ptr %.961.sroa.12.1, i64 %255
  %256 = lshr i64 %.626.i, 3
  %257 = mul i64 %256, -64
  %258 = add nsw i64 %253, -3
  %259 = lshr i64 %258, 2
  %260 = add nuw nsw i64 %259, 1
  %xtraiter29.i = and i64 %260, 3
  %261 = sub nsw i64 0, %xtraiter.i139
  %262 = and i64 %252, 12
  %263 = add nsw i64 %259, -3
  %264 = lshr i64 %263, 2
  %265 = add nuw nsw i64 %264, 1
  %266 = and i64 %265, 9223372036854775804
  %267 = trunc i64 %264 to i2
  %268 = add i2 %267, 1
  %269 = zext i2 %268 to i64
  %270 = sub nsw i64 0, %xtraiter29.i
  %271 = add nuw nsw i64 %.387.i.i135, 4
  %272 = icmp ult i64 %.13.i, 32
  %273 = icmp ult i64 %252, 12
  %274 = icmp ult i64 %258, 12
  %275 = icmp ult i64 %263, 12
  %276 = and i64 %265, 3
  %277 = icmp eq i64 %276, 0
  %278 = and i64 %258, 12
  %279 = icmp eq i64 %278, 12
  %280 = icmp eq i64 %262, 12
  %281 = icmp eq i64 %xtraiter.i.i136, 0
  br label %B582.if.i

B582.if.i:                                        ; preds = %B584.endif.endif.endif.i, %B582.if.lr.ph.i
  %lsr.iv336.i = phi ptr [ %scevgep335.i, %B582.if.lr.ph.i ], [ %scevgep337.i, %B584.endif.endif.endif.i ]
  %lsr.iv297.i = phi ptr [ %.430, %B582.if.lr.ph.i ], [ %scevgep298.i, %B584.endif.endif.endif.i ]
  %.760830834.i = phi i64 [ 0, %B582.if.lr.ph.i ], [ %.767.i, %B584.endif.endif.endif.i ]
  %.767.i = add nuw nsw i64 %.760830834.i, 1
  %.idx802.i = mul i64 %.760830834.i, 27648
  %282 = getelementptr i8, ptr %.430, i64 %.idx802.i
  %.974.i = load i64, ptr %sunkaddr148.i, align 8, !noalias !39
  br i1 %.366.inv.i.i, label %B584.endif.endif.endif.i, label %B214.if.preheader.i.i

B214.if.preheader.i.i:                            ; preds = %B582.if.i
  br i1 %272, label %B214.if.epil.preheader.i.i, label %B214.if.i.preheader.i

B214.if.i.preheader.i:                            ; preds = %B214.if.preheader.i.i
  br i1 %273, label %B214.if.i.epil.i.preheader, label %B214.if.i.preheader27.i

B214.if.i.preheader27.i:                          ; preds = %B214.if.i.preheader.i
  br i1 %274, label %B214.if.i.epil30.i.preheader, label %B214.if.i.preheader28.i

B214.if.i.preheader28.i:                          ; preds = %B214.if.i.preheader27.i
  br i1 %275, label %B214.if.i.epil31.i.preheader, label %B214.if.i.i

B340.unr-lcssa.i.unr-lcssa.unr-lcssa.unr-lcssa.i: ; preds = %B214.if.i.i
  br i1 %277, label %B340.unr-lcssa.i.unr-lcssa.unr-lcssa.i, label %B214.if.i.epil31.i.preheader

B214.if.i.epil31.i.preheader:                     ; preds = %B340.unr-lcssa.i.unr-lcssa.unr-lcssa.unr-lcssa.i, %B214.if.i.preheader28.i
  %.414647649.i.epil32.i.ph = phi i64 [ 0, %B214.if.i.preheader28.i ], [ %.421.3238.i.3.3.3.i, %B340.unr-lcssa.i.unr-lcssa.unr-lcssa.unr-lcssa.i ]
  br label %B214.if.i.epil31.i

B214.if.i.epil31.i:                               ; preds = %B214.if.i.epil31.i.preheader, %B214.if.i.epil31.i
  %lsr.iv121.i = phi i64 [ %lsr.iv.next122.i, %B214.if.i.epil31.i ], [ %269, %B214.if.i.epil31.i.preheader ]
  %.414647649.i.epil32.i = phi i64 [ %.421.3238.i.3.3.epil.i, %B214.if.i.epil31.i ], [ %.414647649.i.epil32.i.ph, %B214.if.i.epil31.i.preheader ]
  %sunkaddr336.i.epil33.i = shl i64 %.414647649.i.epil32.i, 3
  %scevgep100.epil.i = getelementptr i8, ptr %lsr.iv297.i, i64 %sunkaddr336.i.epil33.i
  %scevgep101.epil.i = getelementptr i8, ptr %scevgep100.epil.i, i64 14336
  %.421.3238.i.3.3.epil.i = add i64 %.414647649.i.epil32.i, 512
  tail call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(5120) %scevgep101.epil.i, i8 0, i64 5120, i1 false), !noalias !39
  %lsr.iv.next122.i = add nsw i64 %lsr.iv121.i, -1
  %epil.iter.cmp.not.i = icmp eq i64 %lsr.iv.next122.i, 0
  br i1 %epil.iter.cmp.not.i, label %B340.unr-lcssa.i.unr-lcssa.unr-lcssa.i, label %B214.if.i.epil31.i, !llvm.loop !42

B340.unr-lcssa.i.unr-lcssa.unr-lcssa.i:           ; preds = %B214.if.i.epil31.i, %B340.unr-lcssa.i.unr-lcssa.unr-lcssa.unr-lcssa.i
  %.421.3238.i.3.3.lcssa.i = phi i64 [ %.421.3238.i.3.3.3.i, %B340.unr-lcssa.i.unr-lcssa.unr-lcssa.unr-lcssa.i ], [ %.421.3238.i.3.3.epil.i, %B214.if.i.epil31.i ]
  br i1 %279, label %B340.unr-lcssa.i.unr-lcssa.i, label %B214.if.i.epil30.i.preheader

B214.if.i.epil30.i.preheader:                     ; preds = %B340.unr-lcssa.i.unr-lcssa.unr-lcssa.i, %B214.if.i.preheader27.i
  %.414647649.i.epil31.i.ph = phi i64 [ 0, %B214.if.i.preheader27.i ], [ %.421.3238.i.3.3.lcssa.i, %B340.unr-lcssa.i.unr-lcssa.unr-lcssa.i ]
  br label %B214.if.i.epil30.i

B214.if.i.epil30.i:                               ; preds = %B214.if.i.epil30.i.preheader, %B214.if.i.epil30.i
  %lsr.iv123.i = phi i64 [ %math.i, %B214.if.i.epil30.i ], [ %270, %B214.if.i.epil30.i.preheader ]
  %.414647649.i.epil31.i = phi i64 [ %.421.3238.i.3.epil.i, %B214.if.i.epil30.i ], [ %.414647649.i.epil31.i.ph, %B214.if.i.epil30.i.preheader ]
  %sunkaddr336.i.epil32.i = shl i64 %.414647649.i.epil31.i, 3
  %scevgep104.i = getelementptr i8, ptr %lsr.iv297.i, i64 %sunkaddr336.i.epil32.i
  %scevgep105.i = getelementptr i8, ptr %scevgep104.i, i64 14336
  %.421.3238.i.3.epil.i = add i64 %.414647649.i.epil31.i, 128
  tail call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(2048) %scevgep105.i, i8 0, i64 2048, i1 false), !noalias !39
  %283 = tail call { i64, i1 } @llvm.uadd.with.overflow.i64(i64 %lsr.iv123.i, i64 1)
  %math.i = extractvalue { i64, i1 } %283, 0
  %ov149.i = extractvalue { i64, i1 } %283, 1
  br i1 %ov149.i, label %B340.unr-lcssa.i.unr-lcssa.i, label %B214.if.i.epil30.i, !llvm.loop !43

B340.unr-lcssa.i.unr-lcssa.i:                     ; preds = %B214.if.i.epil30.i, %B340.unr-lcssa.i.unr-lcssa.unr-lcssa.i
  %.421.3238.i.3.lcssa.i = phi i64 [ %.421.3238.i.3.3.lcssa.i, %B340.unr-lcssa.i.unr-lcssa.unr-lcssa.i ], [ %.421.3238.i.3.epil.i, %B214.if.i.epil30.i ]
  br i1 %280, label %B340.unr-lcssa.i.i, label %B214.if.i.epil.i.preheader

B214.if.i.epil.i.preheader:                       ; preds = %B340.unr-lcssa.i.unr-lcssa.i, %B214.if.i.preheader.i
  %.414647649.i.epil.i.ph = phi i64 [ 0, %B214.if.i.preheader.i ], [ %.421.3238.i.3.lcssa.i, %B340.unr-lcssa.i.unr-lcssa.i ]
  br label %B214.if.i.epil.i

B214.if.i.epil.i:                                 ; preds = %B214.if.i.epil.i.preheader, %B214.if.i.epil.i
  %lsr.iv125.i = phi i64 [ %lsr.iv.next126.i, %B214.if.i.epil.i ], [ %261, %B214.if.i.epil.i.preheader ]
  %.414647649.i.epil.i = phi i64 [ %.421.3238.i.epil.i, %B214.if.i.epil.i ], [ %.414647649.i.epil.i.ph, %B214.if.i.epil.i.preheader ]
  %sunkaddr336.i.epil.i = shl i64 %.414647649.i.epil.i, 3
  %.421.3238.i.epil.i = add i64 %.414647649.i.epil.i, 32
  %scevgep128.i140 = getelementptr i8, ptr %lsr.iv297.i, i64 %sunkaddr336.i.epil.i
  %scevgep129.i141 = getelementptr i8, ptr %scevgep128.i140, i64 15360
  %scevgep111.i = getelementptr i8, ptr %scevgep128.i140, i64 14336
  tail call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(256) %scevgep111.i, i8 0, i64 256, i1 false), !noalias !44
  tail call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(256) %scevgep129.i141, i8 0, i64 256, i1 false), !noalias !44
  %ov.i = icmp eq i64 %lsr.iv125.i, -1
  %lsr.iv.next126.i = add i64 %lsr.iv125.i, 1
  br i1 %ov.i, label %B340.unr-lcssa.i.i, label %B214.if.i.epil.i, !llvm.loop !47

B340.unr-lcssa.i.i:                               ; preds = %B214.if.i.epil.i, %B340.unr-lcssa.i.unr-lcssa.i
  %.421.3238.i.lcssa.i = phi i64 [ %.421.3238.i.3.lcssa.i, %B340.unr-lcssa.i.unr-lcssa.i ], [ %.421.3238.i.epil.i, %B214.if.i.epil.i ]
  br i1 %281, label %B340.i.i, label %B214.if.epil.preheader.i.i

B214.if.epil.preheader.i.i:                       ; preds = %B340.unr-lcssa.i.i, %B214.if.preheader.i.i
  %.414647649.epil.init.i.i = phi i64 [ 0, %B214.if.preheader.i.i ], [ %.421.3238.i.lcssa.i, %B340.unr-lcssa.i.i ]
  %284 = shl i64 %.414647649.epil.init.i.i, 3
  %scevgep299.i = getelementptr i8, ptr %lsr.iv297.i, i64 %284
  br label %B214.if.epil.i.i

B214.if.epil.i.i:                                 ; preds = %B214.if.epil.i.i, %B214.if.epil.preheader.i.i
  %lsr.iv288.i.i = phi i64 [ %lsr.iv.next289.i.i, %B214.if.epil.i.i ], [ 0, %B214.if.epil.preheader.i.i ]
  %scevgep300.i = getelementptr i8, ptr %scevgep299.i, i64 %lsr.iv288.i.i
  %scevgep301.i = getelementptr i8, ptr %scevgep300.i, i64 15360
  %scevgep302.i = getelementptr i8, ptr %scevgep300.i, i64 14336
  store <8 x double> zeroinitializer, ptr %scevgep302.i, align 8, !noalias !44
  store <8 x double> zeroinitializer, ptr %scevgep301.i, align 8, !noalias !44
  %lsr.iv.next289.i.i = add nuw nsw i64 %lsr.iv288.i.i, 64
  %epil.iter.cmp.not.i.i142 = icmp eq i64 %251, %lsr.iv.next289.i.i
  br i1 %epil.iter.cmp.not.i.i142, label %B340.i.i, label %B214.if.epil.i.i, !llvm.loop !48

B340.i.i:                                         ; preds = %B214.if.epil.i.i, %B340.unr-lcssa.i.i
  %.247.1.i.i = getelementptr i8, ptr %282, i64 17408
  br label %B214.if.1.i.i

B214.if.1.i.i:                                    ; preds = %B214.if.1.i.i, %B340.i.i
  %lsr.iv130.i = phi i64 [ %lsr.iv.next131.i, %B214.if.1.i.i ], [ %271, %B340.i.i ]
  %lsr.iv284.i.i = phi ptr [ %scevgep285.i.i, %B214.if.1.i.i ], [ %.247.1.i.i, %B340.i.i ]
  %scevgep286.i.i = getelementptr i8, ptr %lsr.iv284.i.i, i64 -1024
  store <8 x double> zeroinitializer, ptr %scevgep286.i.i, align 8, !noalias !44
  store <8 x double> zeroinitializer, ptr %lsr.iv284.i.i, align 8, !noalias !44
  %scevgep285.i.i = getelementptr i8, ptr %lsr.iv284.i.i, i64 64
  %lsr.iv.next131.i = add nsw i64 %lsr.iv130.i, -1
  %.408.1.i.i = icmp sgt i64 %lsr.iv130.i, 5
  br i1 %.408.1.i.i, label %B214.if.1.i.i, label %B214.if.2.preheader.i.i

B214.if.2.preheader.i.i:                          ; preds = %B214.if.1.i.i
  br i1 %272, label %B214.if.2.epil.preheader.i.i, label %B214.if.2.i.preheader.i

B214.if.2.i.preheader.i:                          ; preds = %B214.if.2.preheader.i.i
  br i1 %273, label %B214.if.2.i.epil.i.preheader, label %B214.if.2.i.preheader26.i

B214.if.2.i.preheader26.i:                        ; preds = %B214.if.2.i.preheader.i
  br i1 %274, label %B214.if.2.i.epil39.i.preheader, label %B214.if.2.i.preheader27.i

B214.if.2.i.preheader27.i:                        ; preds = %B214.if.2.i.preheader26.i
  br i1 %275, label %B214.if.2.i.epil38.i.preheader, label %B214.if.2.i.i

B214.if.2.i.i:                                    ; preds = %B214.if.2.i.preheader27.i, %B214.if.2.i.i
  %lsr.iv132.i = phi i64 [ %lsr.iv.next133.i, %B214.if.2.i.i ], [ %266, %B214.if.2.i.preheader27.i ]
  %.414647649.2.i.i = phi i64 [ %.421.2.3.i.3.3.3.i, %B214.if.2.i.i ], [ 0, %B214.if.2.i.preheader27.i ]
  %sunkaddr.i.i = shl i64 %.414647649.2.i.i, 3
  %scevgep319.i = getelementptr i8, ptr %lsr.iv297.i, i64 %sunkaddr.i.i
  %scevgep320.i = getelementptr i8, ptr %scevgep319.i, i64 36864
  %.421.2.3.i.3.3.3.i = add i64 %.414647649.2.i.i, 2048
  %lsr.iv.next133.i = add i64 %lsr.iv132.i, -4
  %niter48.ncmp.3.i = icmp eq i64 %lsr.iv.next133.i, 0
  tail call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(17408) %scevgep320.i, i8 0, i64 17408, i1 false), !noalias !39
  br i1 %niter48.ncmp.3.i, label %B340.2.unr-lcssa.i.unr-lcssa.unr-lcssa.unr-lcssa.i, label %B214.if.2.i.i

B340.2.unr-lcssa.i.unr-lcssa.unr-lcssa.unr-lcssa.i: ; preds = %B214.if.2.i.i
  br i1 %277, label %B340.2.unr-lcssa.i.unr-lcssa.unr-lcssa.i, label %B214.if.2.i.epil38.i.preheader

B214.if.2.i.epil38.i.preheader:                   ; preds = %B340.2.unr-lcssa.i.unr-lcssa.unr-lcssa.unr-lcssa.i, %B214.if.2.i.preheader27.i
  %.414647649.2.i.epil39.i.ph = phi i64 [ 0, %B214.if.2.i.preheader27.i ], [ %.421.2.3.i.3.3.3.i, %B340.2.unr-lcssa.i.unr-lcssa.unr-lcssa.unr-lcssa.i ]
  br label %B214.if.2.i.epil38.i

B214.if.2.i.epil38.i:                             ; preds = %B214.if.2.i.epil38.i.preheader, %B214.if.2.i.epil38.i
  %lsr.iv134.i143 = phi i64 [ %lsr.iv.next135.i144, %B214.if.2.i.epil38.i ], [ %269, %B214.if.2.i.epil38.i.preheader ]
  %.414647649.2.i.epil39.i = phi i64 [ %.421.2.3.i.3.3.epil.i, %B214.if.2.i.epil38.i ], [ %.414647649.2.i.epil39.i.ph, %B214.if.2.i.epil38.i.preheader ]
  %sunkaddr.i.epil40.i = shl i64 %.414647649.2.i.epil39.i, 3
  %scevgep319.epil41.i = getelementptr i8, ptr %lsr.iv297.i, i64 %sunkaddr.i.epil40.i
  %scevgep320.epil42.i = getelementptr i8, ptr %scevgep319.epil41.i, i64 36864
  %.421.2.3.i.3.3.epil.i = add i64 %.414647649.2.i.epil39.i, 512
  tail call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(5120) %scevgep320.epil42.i, i8 0, i64 5120, i1 false), !noalias !39
  %lsr.iv.next135.i144 = add nsw i64 %lsr.iv134.i143, -1
  %epil.iter43.cmp.not.i = icmp eq i64 %lsr.iv.next135.i144, 0
  br i1 %epil.iter43.cmp.not.i, label %B340.2.unr-lcssa.i.unr-lcssa.unr-lcssa.i, label %B214.if.2.i.epil38.i, !llvm.loop !49

B340.2.unr-lcssa.i.unr-lcssa.unr-lcssa.i:         ; preds = %B214.if.2.i.epil38.i, %B340.2.unr-lcssa.i.unr-lcssa.unr-lcssa.unr-lcssa.i
  %.421.2.3.i.3.3.lcssa.i = phi i64 [ %.421.2.3.i.3.3.3.i, %B340.2.unr-lcssa.i.unr-lcssa.unr-lcssa.unr-lcssa.i ], [ %.421.2.3.i.3.3.epil.i, %B214.if.2.i.epil38.i ]
  br i1 %279, label %B340.2.unr-lcssa.i.unr-lcssa.i, label %B214.if.2.i.epil39.i.preheader

B214.if.2.i.epil39.i.preheader:                   ; preds = %B340.2.unr-lcssa.i.unr-lcssa.unr-lcssa.i, %B214.if.2.i.preheader26.i
  %.414647649.2.i.epil40.i.ph = phi i64 [ 0, %B214.if.2.i.preheader26.i ], [ %.421.2.3.i.3.3.lcssa.i, %B340.2.unr-lcssa.i.unr-lcssa.unr-lcssa.i ]
  br label %B214.if.2.i.epil39.i

B214.if.2.i.epil39.i:                             ; preds = %B214.if.2.i.epil39.i.preheader, %B214.if.2.i.epil39.i
  %lsr.iv136.i145 = phi i64 [ %math150.i, %B214.if.2.i.epil39.i ], [ %270, %B214.if.2.i.epil39.i.preheader ]
  %.414647649.2.i.epil40.i = phi i64 [ %.421.2.3.i.3.epil.i, %B214.if.2.i.epil39.i ], [ %.414647649.2.i.epil40.i.ph, %B214.if.2.i.epil39.i.preheader ]
  %sunkaddr.i.epil41.i = shl i64 %.414647649.2.i.epil40.i, 3
  %scevgep319.epil.i = getelementptr i8, ptr %lsr.iv297.i, i64 %sunkaddr.i.epil41.i
  %scevgep320.epil.i = getelementptr i8, ptr %scevgep319.epil.i, i64 36864
  %.421.2.3.i.3.epil.i = add i64 %.414647649.2.i.epil40.i, 128
  tail call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(2048) %scevgep320.epil.i, i8 0, i64 2048, i1 false), !noalias !39
  %285 = tail call { i64, i1 } @llvm.uadd.with.overflow.i64(i64 %lsr.iv136.i145, i64 1)
  %math150.i = extractvalue { i64, i1 } %285, 0
  %ov151.i = extractvalue { i64, i1 } %285, 1
  br i1 %ov151.i, label %B340.2.unr-lcssa.i.unr-lcssa.i, label %B214.if.2.i.epil39.i, !llvm.loop !50

B340.2.unr-lcssa.i.unr-lcssa.i:                   ; preds = %B214.if.2.i.epil39.i, %B340.2.unr-lcssa.i.unr-lcssa.unr-lcssa.i
  %.421.2.3.i.3.lcssa.i = phi i64 [ %.421.2.3.i.3.3.lcssa.i, %B340.2.unr-lcssa.i.unr-lcssa.unr-lcssa.i ], [ %.421.2.3.i.3.epil.i, %B214.if.2.i.epil39.i ]
  br i1 %280, label %B340.2.unr-lcssa.i.i, label %B214.if.2.i.epil.i.preheader

B214.if.2.i.epil.i.preheader:                     ; preds = %B340.2.unr-lcssa.i.unr-lcssa.i, %B214.if.2.i.preheader.i
  %.414647649.2.i.epil.i.ph = phi i64 [ 0, %B214.if.2.i.preheader.i ], [ %.421.2.3.i.3.lcssa.i, %B340.2.unr-lcssa.i.unr-lcssa.i ]
  br label %B214.if.2.i.epil.i

B214.if.2.i.epil.i:                               ; preds = %B214.if.2.i.epil.i.preheader, %B214.if.2.i.epil.i
  %lsr.iv138.i146 = phi i64 [ %lsr.iv.next139.i147, %B214.if.2.i.epil.i ], [ %261, %B214.if.2.i.epil.i.preheader ]
  %.414647649.2.i.epil.i = phi i64 [ %.421.2.3.i.epil.i, %B214.if.2.i.epil.i ], [ %.414647649.2.i.epil.i.ph, %B214.if.2.i.epil.i.preheader ]
  %sunkaddr.i.epil.i = shl i64 %.414647649.2.i.epil.i, 3
  %scevgep325.i = getelementptr i8, ptr %lsr.iv297.i, i64 %sunkaddr.i.epil.i
  %scevgep326.i = getelementptr i8, ptr %scevgep325.i, i64 36864
  %.421.2.3.i.epil.i = add i64 %.414647649.2.i.epil.i, 32
  %scevgep328.i = getelementptr i8, ptr %scevgep325.i, i64 37888
  tail call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(256) %scevgep326.i, i8 0, i64 256, i1 false), !noalias !44
  tail call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(256) %scevgep328.i, i8 0, i64 256, i1 false), !noalias !44
  %ov130.i = icmp eq i64 %lsr.iv138.i146, -1
  %lsr.iv.next139.i147 = add i64 %lsr.iv138.i146, 1
  br i1 %ov130.i, label %B340.2.unr-lcssa.i.i, label %B214.if.2.i.epil.i, !llvm.loop !51

B340.2.unr-lcssa.i.i:                             ; preds = %B214.if.2.i.epil.i, %B340.2.unr-lcssa.i.unr-lcssa.i
  %.421.2.3.i.lcssa.i = phi i64 [ %.421.2.3.i.3.lcssa.i, %B340.2.unr-lcssa.i.unr-lcssa.i ], [ %.421.2.3.i.epil.i, %B214.if.2.i.epil.i ]
  br i1 %281, label %B340.2.i.i, label %B214.if.2.epil.preheader.i.i

B214.if.2.epil.preheader.i.i:                     ; preds = %B340.2.unr-lcssa.i.i, %B214.if.2.preheader.i.i
  %.414647649.2.epil.init.i.i = phi i64 [ 0, %B214.if.2.preheader.i.i ], [ %.421.2.3.i.lcssa.i, %B340.2.unr-lcssa.i.i ]
  %286 = shl i64 %.414647649.2.epil.init.i.i, 3
  %scevgep329.i = getelementptr i8, ptr %lsr.iv297.i, i64 %286
  br label %B214.if.2.epil.i.i

B214.if.2.epil.i.i:                               ; preds = %B214.if.2.epil.i.i, %B214.if.2.epil.preheader.i.i
  %lsr.iv262.i.i = phi i64 [ %lsr.iv.next263.i.i, %B214.if.2.epil.i.i ], [ 0, %B214.if.2.epil.preheader.i.i ]
  %scevgep330.i = getelementptr i8, ptr %scevgep329.i, i64 %lsr.iv262.i.i
  %scevgep331.i = getelementptr i8, ptr %scevgep330.i, i64 37888
  %scevgep332.i = getelementptr i8, ptr %scevgep330.i, i64 36864
  store <8 x double> zeroinitializer, ptr %scevgep332.i, align 8, !noalias !44
  store <8 x double> zeroinitializer, ptr %scevgep331.i, align 8, !noalias !44
  %lsr.iv.next263.i.i = add nuw nsw i64 %lsr.iv262.i.i, 64
  %epil.iter244.cmp.not.i.i = icmp eq i64 %251, %lsr.iv.next263.i.i
  br i1 %epil.iter244.cmp.not.i.i, label %B340.2.i.i, label %B214.if.2.epil.i.i, !llvm.loop !52

B340.2.i.i:                                       ; preds = %B214.if.2.epil.i.i, %B340.2.unr-lcssa.i.i
  %.247.3.i.i = getelementptr i8, ptr %282, i64 39936
  br label %B214.if.3.i.i

B214.if.3.i.i:                                    ; preds = %B214.if.3.i.i, %B340.2.i.i
  %lsr.iv140.i = phi i64 [ %lsr.iv.next141.i, %B214.if.3.i.i ], [ %271, %B340.2.i.i ]
  %lsr.iv258.i.i = phi ptr [ %scevgep259.i.i, %B214.if.3.i.i ], [ %.247.3.i.i, %B340.2.i.i ]
  %scevgep260.i.i = getelementptr i8, ptr %lsr.iv258.i.i, i64 -1024
  store <8 x double> zeroinitializer, ptr %scevgep260.i.i, align 8, !noalias !44
  store <8 x double> zeroinitializer, ptr %lsr.iv258.i.i, align 8, !noalias !44
  %scevgep259.i.i = getelementptr i8, ptr %lsr.iv258.i.i, i64 64
  %lsr.iv.next141.i = add nsw i64 %lsr.iv140.i, -1
  %.408.3.i.i = icmp sgt i64 %lsr.iv140.i, 5
  br i1 %.408.3.i.i, label %B214.if.3.i.i, label %B548.if.i.preheader.i

B548.if.i.preheader.i:                            ; preds = %B214.if.3.i.i
  %287 = icmp eq i64 %.974.i, 1
  br label %B548.if.i.i

B624.i.i:                                         ; preds = %B548.if.i.i
  %scevgep340.i = getelementptr i8, ptr %lsr.iv336.i, i64 %lsr.iv338.i
  %scevgep341.i = getelementptr i8, ptr %scevgep340.i, i64 -40960
  %.926.i.i166 = load <8 x double>, ptr %scevgep341.i, align 8, !noalias !44
  %.8.i.i.i167 = fmul contract <8 x double> %.7.i.i.i138, %.926.i.i166
  %.956.i.i168 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i.i.i167, <8 x double> splat (double 0x3FE45F306DC9C883), <8 x double> splat (double 0x4338000000000000))
  %.8.i160.i.i = fadd contract <8 x double> %.956.i.i168, splat (double 0xC338000000000000)
  %.997.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i160.i.i, <8 x double> splat (double 0xBFF921FB54442D18), <8 x double> %.8.i.i.i167)
  %.1014.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i160.i.i, <8 x double> splat (double 0xBC91A62633145C07), <8 x double> %.997.i.i)
  %.6.i161.i.i = fmul contract <8 x double> %.1014.i.i, %.1014.i.i
  %.6.i162.i.i = fmul contract <8 x double> %.1014.i.i, %.6.i161.i.i
  %.1043.i.i169 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i161.i.i, <8 x double> splat (double 0xBD6AE7F3E733B81F), <8 x double> splat (double 0x3DE6124613A86D09))
  %.1046.i.i170 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i161.i.i, <8 x double> %.1043.i.i169, <8 x double> splat (double 0xBE5AE64567F544E4))
  %.1049.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i161.i.i, <8 x double> %.1046.i.i170, <8 x double> splat (double 0x3EC71DE3A556C734))
  %.1052.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i161.i.i, <8 x double> %.1049.i.i, <8 x double> splat (double 0xBF2A01A01A01A01A))
  %.1055.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i161.i.i, <8 x double> %.1052.i.i, <8 x double> splat (double 0x3F81111111111111))
  %.1058.i.i171 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i161.i.i, <8 x double> %.1055.i.i, <8 x double> splat (double 0xBFC5555555555555))
  %.1083.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i162.i.i, <8 x double> %.1058.i.i171, <8 x double> %.1014.i.i)
  %.1088.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i161.i.i, <8 x double> splat (double 0x3D2AE7F3E733B81F), <8 x double> splat (double 0xBDA93974A8C07C9D))
  %.1091.i.i172 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i161.i.i, <8 x double> %.1088.i.i, <8 x double> splat (double 0x3E21EED8EFF8D898))
  %.1094.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i161.i.i, <8 x double> %.1091.i.i172, <8 x double> splat (double 0xBE927E4FB7789F5C))
  %.1097.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i161.i.i, <8 x double> %.1094.i.i, <8 x double> splat (double 0x3EFA01A01A01A01A))
  %.1100.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i161.i.i, <8 x double> %.1097.i.i, <8 x double> splat (double 0xBF56C16C16C16C17))
  %.1103.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i161.i.i, <8 x double> %.1100.i.i, <8 x double> splat (double 0x3FA5555555555555))
  %.1106.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i161.i.i, <8 x double> %.1103.i.i, <8 x double> splat (double -5.000000e-01))
  %.1109.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i161.i.i, <8 x double> %.1106.i.i, <8 x double> splat (double 1.000000e+00))
  %.1110.i.i = bitcast <8 x double> %.956.i.i168 to <8 x i64>
  %.1111.i.i = bitcast <8 x double> %.1083.i.i to <8 x i64>
  %.1112.i.i = bitcast <8 x double> %.1109.i.i to <8 x i64>
  %.6.i163.i.i = xor <8 x i64> %.1112.i.i, %.1111.i.i
  %.8.i164.i.i = and <8 x i64> %.1110.i.i, splat (i64 1)
  %288 = icmp eq <8 x i64> %.8.i164.i.i, zeroinitializer
  %.6.i166.i.i = select <8 x i1> %288, <8 x i64> zeroinitializer, <8 x i64> %.6.i163.i.i
  %.8.i167.i.i = shl <8 x i64> %.1110.i.i, splat (i64 62)
  %.8.i168.i.i = and <8 x i64> %.8.i167.i.i, splat (i64 -9223372036854775808)
  %.8.i170.i.i = add <8 x i64> %.8.i167.i.i, splat (i64 4611686018427387904)
  %.8.i171.i.i = and <8 x i64> %.8.i170.i.i, splat (i64 -9223372036854775808)
  %289 = xor <8 x i64> %.8.i168.i.i, %.1111.i.i
  %.6.i173.i.i = xor <8 x i64> %289, %.6.i166.i.i
  %290 = bitcast <8 x i64> %.6.i173.i.i to <8 x double>
  %291 = xor <8 x i64> %.8.i171.i.i, %.1112.i.i
  %.6.i175.i.i = xor <8 x i64> %291, %.6.i166.i.i
  %292 = bitcast <8 x i64> %.6.i175.i.i to <8 x double>
  br label %B746.i.i

B746.i.i:                                         ; preds = %B548.if.i.i, %B624.i.i
  %"$phi746.1.2.sroa.8.1.i.i" = phi <8 x double> [ %292, %B624.i.i ], [ splat (double 1.000000e+00), %B548.if.i.i ]
  %"$phi746.1.2.sroa.0.1.i.i" = phi <8 x double> [ %290, %B624.i.i ], [ zeroinitializer, %B548.if.i.i ]
  %scevgep147.i = getelementptr i8, ptr %scevgep346.i, i64 -22528
  store <8 x double> %"$phi746.1.2.sroa.8.1.i.i", ptr %scevgep147.i, align 8, !noalias !44
  %scevgep145.i = getelementptr i8, ptr %scevgep346.i, i64 -21504
  store <8 x double> %"$phi746.1.2.sroa.0.1.i.i", ptr %scevgep145.i, align 8, !noalias !44
  %lsr.iv.next339.i = add i64 %lsr.iv338.i, 64
  %lsr.iv.next143.i = add nsw i64 %lsr.iv142.i, -1
  %.858.i.i = icmp sgt i64 %lsr.iv142.i, 5
  br i1 %.858.i.i, label %B548.if.i.i, label %B584.endif.endif.endif.i

B214.if.i.i:                                      ; preds = %B214.if.i.preheader28.i, %B214.if.i.i
  %lsr.iv119.i = phi i64 [ %lsr.iv.next120.i, %B214.if.i.i ], [ %266, %B214.if.i.preheader28.i ]
  %.414647649.i.i = phi i64 [ %.421.3238.i.3.3.3.i, %B214.if.i.i ], [ 0, %B214.if.i.preheader28.i ]
  %sunkaddr336.i.i = shl i64 %.414647649.i.i, 3
  %scevgep100.i = getelementptr i8, ptr %lsr.iv297.i, i64 %sunkaddr336.i.i
  %scevgep101.i = getelementptr i8, ptr %scevgep100.i, i64 14336
  %.421.3238.i.3.3.3.i = add i64 %.414647649.i.i, 2048
  %lsr.iv.next120.i = add i64 %lsr.iv119.i, -4
  %niter.ncmp.3.i = icmp eq i64 %lsr.iv.next120.i, 0
  tail call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(17408) %scevgep101.i, i8 0, i64 17408, i1 false), !noalias !39
  br i1 %niter.ncmp.3.i, label %B340.unr-lcssa.i.unr-lcssa.unr-lcssa.unr-lcssa.i, label %B214.if.i.i

B548.if.i.i:                                      ; preds = %B746.i.i, %B548.if.i.preheader.i
  %lsr.iv142.i = phi i64 [ %lsr.iv.next143.i, %B746.i.i ], [ %271, %B548.if.i.preheader.i ]
  %lsr.iv338.i = phi i64 [ %lsr.iv.next339.i, %B746.i.i ], [ 40960, %B548.if.i.preheader.i ]
  %scevgep346.i = getelementptr i8, ptr %lsr.iv297.i, i64 %lsr.iv338.i
  store <8 x double> zeroinitializer, ptr %scevgep346.i, align 8, !noalias !44
  br i1 %287, label %B624.i.i, label %B746.i.i

B584.endif.endif.endif.i:                         ; preds = %B746.i.i, %B582.if.i
  %scevgep298.i = getelementptr i8, ptr %lsr.iv297.i, i64 27648
  %scevgep337.i = getelementptr i8, ptr %lsr.iv336.i, i64 %257
  %exitcond.not.i148 = icmp eq i64 %.767.i, %.112.i
  br i1 %exitcond.not.i148, label %B732.i, label %B582.if.i

B762.if.i:                                        ; preds = %B764.endif.endif.endif.endif.endif.endif.endif.i, %B762.if.lr.ph.i
  %lsr.iv209.i = phi i64 [ %230, %B762.if.lr.ph.i ], [ %lsr.iv.next210.i, %B764.endif.endif.endif.endif.endif.endif.endif.i ]
  %lsr.iv207.i = phi i64 [ %231, %B762.if.lr.ph.i ], [ %lsr.iv.next.i165, %B764.endif.endif.endif.endif.endif.endif.endif.i ]
  %.1118844852.i = phi i64 [ 0, %B762.if.lr.ph.i ], [ %.1125.i, %B764.endif.endif.endif.endif.endif.endif.endif.i ]
  %.1125.i = add nuw nsw i64 %.1118844852.i, 1
  %293 = getelementptr i64, ptr %237, i64 %.1118844852.i
  %.1180.i = load i64, ptr %293, align 8, !noalias !39
  %.idx.i152 = mul i64 %.1180.i, 27648
  %.1266.i = mul nsw i64 %.1118844852.i, %.142.i
  %.1268.i = add nsw i64 %.1266.i, %.1090933952
  %.1321.idx.i = shl nsw i64 %.1268.i, 4
  %.1321.i = getelementptr inbounds i8, ptr %238, i64 %.1321.idx.i
  br i1 %236, label %B212.i.i, label %B144.if.preheader.i.i

B144.if.preheader.i.i:                            ; preds = %B762.if.i
  br i1 %240, label %B144.if.epil.preheader.i.i, label %B144.if.preheader.new.i.i

B144.if.preheader.new.i.i:                        ; preds = %B144.if.preheader.i.i
  %scevgep35.i.i = getelementptr i8, ptr %.1321.i, i64 24
  br i1 %241, label %B144.if.i.epil.preheader.i, label %B144.if.i.i

B212.loopexit.unr-lcssa.i.unr-lcssa.i:            ; preds = %B144.if.i.i
  %294 = sub i64 0, %lsr.iv207.i
  %scevgep54.i157 = getelementptr i8, ptr %scevgep.i156, i64 %294
  br i1 %243, label %B144.if.i.epil.preheader.i, label %B212.loopexit.unr-lcssa.i.i

B144.if.i.epil.preheader.i:                       ; preds = %B212.loopexit.unr-lcssa.i.unr-lcssa.i, %B144.if.preheader.new.i.i
  %lsr.iv36.i.epil.init.i = phi ptr [ %scevgep35.i.i, %B144.if.preheader.new.i.i ], [ %scevgep54.i157, %B212.loopexit.unr-lcssa.i.unr-lcssa.i ]
  %.308245247.i.epil.init.i = phi i64 [ 0, %B144.if.preheader.new.i.i ], [ %.315.1.i.1.i, %B212.loopexit.unr-lcssa.i.unr-lcssa.i ]
  %scevgep39.i.epil.i = getelementptr i8, ptr %lsr.iv36.i.epil.init.i, i64 -24
  %.370.i.epil.i = load double, ptr %scevgep39.i.epil.i, align 8, !noalias !53
  %sunkaddr.i82.epil.i = shl i64 %.308245247.i.epil.init.i, 3
  %sunkaddr49.i.epil.i = getelementptr i8, ptr %.430, i64 %sunkaddr.i82.epil.i
  %sunkaddr50.i.epil.i = getelementptr i8, ptr %sunkaddr49.i.epil.i, i64 10240
  store double %.370.i.epil.i, ptr %sunkaddr50.i.epil.i, align 8, !noalias !53
  %scevgep40.i.epil.i = getelementptr i8, ptr %lsr.iv36.i.epil.init.i, i64 -16
  %.432.i.epil.i = load double, ptr %scevgep40.i.epil.i, align 8, !noalias !53
  %sunkaddr53.i.epil.i = getelementptr i8, ptr %sunkaddr49.i.epil.i, i64 11264
  store double %.432.i.epil.i, ptr %sunkaddr53.i.epil.i, align 8, !noalias !53
  %.315.1.i.epil.i = add nuw i64 %.308245247.i.epil.init.i, 2
  %scevgep38.i.epil.i = getelementptr i8, ptr %lsr.iv36.i.epil.init.i, i64 -8
  %.370.1.i.epil.i = load double, ptr %scevgep38.i.epil.i, align 8, !noalias !53
  %sunkaddr56.i.epil.i = getelementptr i8, ptr %sunkaddr49.i.epil.i, i64 10248
  store double %.370.1.i.epil.i, ptr %sunkaddr56.i.epil.i, align 8, !noalias !53
  %.432.1.i.epil.i = load double, ptr %lsr.iv36.i.epil.init.i, align 8, !noalias !53
  %sunkaddr59.i.epil.i = getelementptr i8, ptr %sunkaddr49.i.epil.i, i64 11272
  store double %.432.1.i.epil.i, ptr %sunkaddr59.i.epil.i, align 8, !noalias !53
  br label %B212.loopexit.unr-lcssa.i.i

B212.loopexit.unr-lcssa.i.i:                      ; preds = %B144.if.i.epil.preheader.i, %B212.loopexit.unr-lcssa.i.unr-lcssa.i
  %.315.1.i.lcssa.i = phi i64 [ %.315.1.i.epil.i, %B144.if.i.epil.preheader.i ], [ %.315.1.i.1.i, %B212.loopexit.unr-lcssa.i.unr-lcssa.i ]
  br i1 %245, label %B212.i.i, label %B144.if.epil.preheader.i.i

B144.if.epil.preheader.i.i:                       ; preds = %B212.loopexit.unr-lcssa.i.i, %B144.if.preheader.i.i
  %.308245247.epil.init.i.i = phi i64 [ 0, %B144.if.preheader.i.i ], [ %.315.1.i.lcssa.i, %B212.loopexit.unr-lcssa.i.i ]
  %.idx.epil.i.i = shl i64 %.308245247.epil.init.i.i, 4
  %295 = getelementptr i8, ptr %.1321.i, i64 %.idx.epil.i.i
  %.370.epil.i.i = load double, ptr %295, align 8, !noalias !53
  %296 = getelementptr double, ptr %.54.i.i, i64 %.308245247.epil.init.i.i
  store double %.370.epil.i.i, ptr %296, align 8, !noalias !53
  %297 = getelementptr i8, ptr %295, i64 8
  %.432.epil.i.i = load double, ptr %297, align 8, !noalias !53
  %298 = getelementptr double, ptr %.141.i.i, i64 %.308245247.epil.init.i.i
  store double %.432.epil.i.i, ptr %298, align 8, !noalias !53
  br label %B212.i.i

B212.i.i:                                         ; preds = %B144.if.epil.preheader.i.i, %B212.loopexit.unr-lcssa.i.i, %B762.if.i
  br i1 %239, label %B764.endif.endif.endif.endif.endif.i, label %B244.if.preheader.i.i

B244.if.preheader.i.i:                            ; preds = %B212.i.i
  br i1 %247, label %B244.if.prol.loopexit.i.i, label %B244.if.prol.i.i

B244.if.prol.i.i:                                 ; preds = %B244.if.preheader.i.i
  store double 0.000000e+00, ptr %sunkaddr152.i, align 8, !noalias !53
  store double 0.000000e+00, ptr %sunkaddr.i151, align 8, !noalias !53
  br label %B244.if.prol.loopexit.i.i

B244.if.prol.loopexit.i.i:                        ; preds = %B244.if.prol.i.i, %B244.if.preheader.i.i
  %.557250254.unr.i.i = phi i64 [ %.515.i.i, %B244.if.preheader.i.i ], [ %.567.prol.i.i, %B244.if.prol.i.i ]
  %.564251253.unr.i.i = phi i64 [ %.13.i.i149, %B244.if.preheader.i.i ], [ %.neg.i.i, %B244.if.prol.i.i ]
  br i1 %248, label %B764.endif.endif.endif.endif.endif.i, label %B244.if.preheader25.i.i

B244.if.preheader25.i.i:                          ; preds = %B244.if.prol.loopexit.i.i
  %299 = add nuw i64 %.557250254.unr.i.i, 2
  %300 = add nsw i64 %.564251253.unr.i.i, 1
  %301 = shl i64 %.564251253.unr.i.i, 3
  %scevgep99.i = getelementptr i8, ptr %.141.i.i, i64 %301
  %scevgep108.i = getelementptr i8, ptr %scevgep107.i, i64 %301
  br label %B244.if.i.i

B144.if.i.i:                                      ; preds = %B144.if.preheader.new.i.i, %B144.if.i.i
  %lsr.iv52.i = phi i64 [ %lsr.iv.next53.i, %B144.if.i.i ], [ %234, %B144.if.preheader.new.i.i ]
  %lsr.iv.i153 = phi ptr [ %scevgep.i156, %B144.if.i.i ], [ %238, %B144.if.preheader.new.i.i ]
  %.308245247.i.i = phi i64 [ %.315.1.i.1.i, %B144.if.i.i ], [ 0, %B144.if.preheader.new.i.i ]
  %scevgep219.i = getelementptr i8, ptr %lsr.iv.i153, i64 %lsr.iv209.i
  %scevgep220.i = getelementptr i8, ptr %scevgep219.i, i64 24
  %.370.i.i154 = load double, ptr %scevgep219.i, align 8, !noalias !53
  %sunkaddr153.i = shl i64 %.308245247.i.i, 3
  %sunkaddr154.i = getelementptr i8, ptr %.430, i64 %sunkaddr153.i
  %sunkaddr155.i = getelementptr i8, ptr %sunkaddr154.i, i64 10240
  store double %.370.i.i154, ptr %sunkaddr155.i, align 8, !noalias !53
  %scevgep72.i = getelementptr i8, ptr %scevgep219.i, i64 8
  %.432.i.i = load double, ptr %scevgep72.i, align 8, !noalias !53
  %sunkaddr158.i = getelementptr i8, ptr %sunkaddr154.i, i64 11264
  store double %.432.i.i, ptr %sunkaddr158.i, align 8, !noalias !53
  %scevgep70.i = getelementptr i8, ptr %scevgep219.i, i64 16
  %.370.1.i.i = load double, ptr %scevgep70.i, align 8, !noalias !53
  %sunkaddr161.i = getelementptr i8, ptr %sunkaddr154.i, i64 10248
  store double %.370.1.i.i, ptr %sunkaddr161.i, align 8, !noalias !53
  %.432.1.i.i = load double, ptr %scevgep220.i, align 8, !noalias !53
  %sunkaddr164.i = getelementptr i8, ptr %sunkaddr154.i, i64 11272
  store double %.432.1.i.i, ptr %sunkaddr164.i, align 8, !noalias !53
  %scevgep68.i = getelementptr i8, ptr %scevgep219.i, i64 56
  %scevgep66.i = getelementptr i8, ptr %scevgep219.i, i64 32
  %.370.i.1.i = load double, ptr %scevgep66.i, align 8, !noalias !53
  %sunkaddr167.i = getelementptr i8, ptr %sunkaddr154.i, i64 10256
  store double %.370.i.1.i, ptr %sunkaddr167.i, align 8, !noalias !53
  %scevgep62.i = getelementptr i8, ptr %scevgep219.i, i64 40
  %.432.i.1.i = load double, ptr %scevgep62.i, align 8, !noalias !53
  %sunkaddr170.i = getelementptr i8, ptr %sunkaddr154.i, i64 11280
  store double %.432.i.1.i, ptr %sunkaddr170.i, align 8, !noalias !53
  %.315.1.i.1.i = add i64 %.308245247.i.i, 4
  %scevgep58.i155 = getelementptr i8, ptr %scevgep219.i, i64 48
  %.370.1.i.1.i = load double, ptr %scevgep58.i155, align 8, !noalias !53
  %sunkaddr171.i = shl i64 %.315.1.i.1.i, 3
  %sunkaddr172.i = getelementptr i8, ptr %.430, i64 %sunkaddr171.i
  %sunkaddr173.i = getelementptr i8, ptr %sunkaddr172.i, i64 10232
  store double %.370.1.i.1.i, ptr %sunkaddr173.i, align 8, !noalias !53
  %.432.1.i.1.i = load double, ptr %scevgep68.i, align 8, !noalias !53
  %sunkaddr176.i = getelementptr i8, ptr %sunkaddr172.i, i64 11256
  store double %.432.1.i.1.i, ptr %sunkaddr176.i, align 8, !noalias !53
  %scevgep.i156 = getelementptr i8, ptr %lsr.iv.i153, i64 64
  %lsr.iv.next53.i = add i64 %lsr.iv52.i, -2
  %niter204.ncmp.1.i = icmp eq i64 %lsr.iv.next53.i, 0
  br i1 %niter204.ncmp.1.i, label %B212.loopexit.unr-lcssa.i.unr-lcssa.i, label %B144.if.i.i

B244.if.i.i:                                      ; preds = %B244.if.i.i, %B244.if.preheader25.i.i
  %lsr.iv96.i = phi i64 [ %lsr.iv.next97.i, %B244.if.i.i ], [ 0, %B244.if.preheader25.i.i ]
  %lsr.iv30.i.i = phi i64 [ %lsr.iv.next31.i.i, %B244.if.i.i ], [ %300, %B244.if.preheader25.i.i ]
  %lsr.iv.i84.i = phi i64 [ %lsr.iv.next.i85.i, %B244.if.i.i ], [ %299, %B244.if.preheader25.i.i ]
  %.564251253.i.i = phi i64 [ %.571.1.i.i, %B244.if.i.i ], [ %.564251253.unr.i.i, %B244.if.preheader25.i.i ]
  %302 = lshr i64 %.564251253.i.i, 53
  %303 = and i64 %302, 1024
  %scevgep102.i = getelementptr i8, ptr %scevgep99.i, i64 %303
  %304 = lshr i64 %lsr.iv30.i.i, 53
  %305 = and i64 %304, 1024
  %scevgep109.i = getelementptr i8, ptr %scevgep108.i, i64 %305
  %306 = shl i64 %lsr.iv96.i, 3
  %scevgep103.i = getelementptr i8, ptr %scevgep102.i, i64 %306
  %scevgep106.i = getelementptr i8, ptr %scevgep103.i, i64 -1024
  store double 0.000000e+00, ptr %scevgep106.i, align 8, !noalias !53
  store double 0.000000e+00, ptr %scevgep103.i, align 8, !noalias !53
  %.571.1.i.i = add i64 %.564251253.i.i, 2
  %scevgep113.i = getelementptr i8, ptr %scevgep109.i, i64 %306
  %scevgep114.i = getelementptr i8, ptr %scevgep113.i, i64 1024
  store double 0.000000e+00, ptr %scevgep113.i, align 8, !noalias !53
  store double 0.000000e+00, ptr %scevgep114.i, align 8, !noalias !53
  %lsr.iv.next.i85.i = add i64 %lsr.iv.i84.i, -2
  %lsr.iv.next31.i.i = add i64 %lsr.iv30.i.i, 2
  %lsr.iv.next97.i = add nuw i64 %lsr.iv96.i, 2
  %.558.1.i.i = icmp sgt i64 %lsr.iv.next.i85.i, 2
  br i1 %.558.1.i.i, label %B244.if.i.i, label %B764.endif.endif.endif.endif.endif.i

B764.endif.endif.endif.endif.endif.i:             ; preds = %B244.if.i.i, %B244.if.prol.loopexit.i.i, %B212.i.i
  br i1 %.79.inv.i.i, label %B764.endif.endif.endif.endif.endif.endif.endif.i, label %B48.if.lr.ph.i.i

B48.if.lr.ph.i.i:                                 ; preds = %B764.endif.endif.endif.endif.endif.i
  %.idx35.i = shl i64 %.1118844852.i, 4
  %307 = getelementptr i8, ptr %249, i64 %.idx35.i
  %308 = getelementptr i8, ptr %307, i64 8
  %.1563.i = load double, ptr %308, align 8, !noalias !39
  %.1531.i = load double, ptr %307, align 8, !noalias !39
  %309 = getelementptr double, ptr %250, i64 %.1118844852.i
  %.1500.i = load double, ptr %309, align 8, !noalias !39
  %.702.i.i = insertelement <8 x double> poison, double %.1500.i, i64 0
  %.703.i.i = shufflevector <8 x double> %.702.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.743.i.i = fneg contract double %.1563.i
  %.753.i.i = insertelement <8 x double> poison, double %.743.i.i, i64 0
  %.754.i.i = shufflevector <8 x double> %.753.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.757.i.i158 = insertelement <8 x double> poison, double %.1531.i, i64 0
  %.758.i.i159 = shufflevector <8 x double> %.757.i.i158, <8 x double> poison, <8 x i32> zeroinitializer
  %.786.i.i160 = insertelement <8 x double> poison, double %.1563.i, i64 0
  %.787.i.i161 = shufflevector <8 x double> %.786.i.i160, <8 x double> poison, <8 x i32> zeroinitializer
  br label %B48.if.i.i

B48.if.i.i:                                       ; preds = %B48.if.i.i, %B48.if.lr.ph.i.i
  %lsr.iv115.i = phi i64 [ %lsr.iv.next116.i, %B48.if.i.i ], [ %235, %B48.if.lr.ph.i.i ]
  %lsr.iv257.i = phi ptr [ %scevgep258.i, %B48.if.i.i ], [ %scevgep256.i, %B48.if.lr.ph.i.i ]
  %scevgep267.i = getelementptr i8, ptr %lsr.iv257.i, i64 -7168
  %.251.i.i162 = load <8 x double>, ptr %scevgep267.i, align 8, !noalias !56
  %scevgep266.i = getelementptr i8, ptr %lsr.iv257.i, i64 -6144
  %.346.i.i163 = load <8 x double>, ptr %scevgep266.i, align 8, !noalias !56
  %scevgep264.i = getelementptr i8, ptr %lsr.iv257.i, i64 %.idx.i152
  %scevgep265.i = getelementptr i8, ptr %scevgep264.i, i64 -3072
  %.700.i.i = load <8 x double>, ptr %scevgep265.i, align 8, !noalias !56
  %.704.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.251.i.i162, <8 x double> %.703.i.i, <8 x double> %.700.i.i)
  store <8 x double> %.704.i.i, ptr %scevgep265.i, align 8, !noalias !56
  %scevgep263.i = getelementptr i8, ptr %scevgep264.i, i64 -2048
  %.725.i.i = load <8 x double>, ptr %scevgep263.i, align 8, !noalias !56
  %.729.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.346.i.i163, <8 x double> %.703.i.i, <8 x double> %.725.i.i)
  store <8 x double> %.729.i.i, ptr %scevgep263.i, align 8, !noalias !56
  %scevgep118.i = getelementptr i8, ptr %scevgep264.i, i64 -1024
  %.752.i.i = load <8 x double>, ptr %scevgep118.i, align 8, !noalias !56
  %.755.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.346.i.i163, <8 x double> %.754.i.i, <8 x double> %.752.i.i)
  %.759.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.251.i.i162, <8 x double> %.758.i.i159, <8 x double> %.755.i.i)
  store <8 x double> %.759.i.i, ptr %scevgep118.i, align 8, !noalias !56
  %.780.i.i = load <8 x double>, ptr %scevgep264.i, align 8, !noalias !56
  %.784.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.346.i.i163, <8 x double> %.758.i.i159, <8 x double> %.780.i.i)
  %.788.i.i164 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.251.i.i162, <8 x double> %.787.i.i161, <8 x double> %.784.i.i)
  store <8 x double> %.788.i.i164, ptr %scevgep264.i, align 8, !noalias !56
  %scevgep258.i = getelementptr i8, ptr %lsr.iv257.i, i64 64
  %lsr.iv.next116.i = add nsw i64 %lsr.iv115.i, -1
  %.123.i.i = icmp sgt i64 %lsr.iv115.i, 5
  br i1 %.123.i.i, label %B48.if.i.i, label %B764.endif.endif.endif.endif.endif.endif.endif.i

B764.endif.endif.endif.endif.endif.endif.endif.i: ; preds = %B48.if.i.i, %B764.endif.endif.endif.endif.endif.i
  %lsr.iv.next.i165 = sub i64 %lsr.iv207.i, %232
  %lsr.iv.next210.i = add i64 %lsr.iv209.i, %232
  %exitcond890.not.i = icmp eq i64 %.1125.i, %.82.i
  br i1 %exitcond890.not.i, label %_ZN17bnserve_inference14adjoint_kernel7_source9_polariseB3v77B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit, label %B762.if.i

_ZN17bnserve_inference14adjoint_kernel7_source9_polariseB3v77B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit: ; preds = %B764.endif.endif.endif.endif.endif.endif.endif.i, %B732.i
  br i1 %87, label %B1212, label %B1040.if.preheader

B1040.if.preheader:                               ; preds = %_ZN17bnserve_inference14adjoint_kernel7_source9_polariseB3v77B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit
  %.104.i.i.i = icmp sgt i64 %.1127, 0
  %310 = shl nuw nsw i64 %.13.i, 3
  %unroll_iter.i.i.i = and i64 %.13.i, 9223372036854775800
  %311 = add nsw i64 %unroll_iter.i.i.i, -2
  %312 = lshr exact i64 %311, 1
  %313 = add nuw i64 %312, 1
  %314 = lshr exact i64 %313, 1
  %315 = mul nsw i64 %314, -2
  %316 = icmp slt i64 %.1127, 1
  %317 = shl nuw nsw i64 %.13.i, 3
  %unroll_iter.i80.i.i = and i64 %.13.i, 9223372036854775800
  %318 = add nsw i64 %unroll_iter.i80.i.i, -2
  %319 = lshr exact i64 %318, 1
  %320 = add nuw i64 %319, 1
  %321 = lshr exact i64 %320, 1
  %322 = mul nsw i64 %321, -2
  %323 = icmp slt i64 %.1127, 1
  %.1077.inv.i.i = icmp slt i64 %.1127, 1
  %.1098.i.i = lshr exact i64 %.13.i, 3
  %324 = add nuw nsw i64 %.1098.i.i, 4
  %.423.i.i295 = lshr exact i64 %.13.i, 3
  %.402.inv.i.i = icmp slt i64 %.1127, 1
  %xtraiter226.i.i = and i64 %.423.i.i295, 3
  %325 = icmp slt i64 %.1127, 32
  %326 = add nsw i64 %.423.i.i295, -4
  %327 = lshr i64 %326, 2
  %328 = icmp eq i64 %327, 0
  %329 = add nuw nsw i64 %327, 1
  %330 = and i64 %329, 9223372036854775806
  %331 = and i64 %326, 4
  %lcmp.mod.not.not.i.i305 = icmp eq i64 %331, 0
  %lcmp.mod227.not.i.i = icmp eq i64 %xtraiter226.i.i, 0
  %332 = shl nuw nsw i64 %xtraiter226.i.i, 6
  %.116.i.i194 = lshr exact i64 %.13.i, 3
  %.93.inv.i.i = icmp slt i64 %.1127, 1
  %333 = tail call i64 @llvm.smax.i64(i64 %.116.i.i194, i64 1)
  %334 = add nuw nsw i64 %.116.i.i194, 4
  %335 = shl nuw i64 %.13.i, 3
  %336 = icmp eq i64 %.1127, 8
  %337 = and i64 %.116.i.i194, 1152921504606846974
  %338 = and i64 %.13.i, 8
  %lcmp.mod.not.i.i.i237 = icmp eq i64 %338, 0
  %339 = add nuw nsw i64 %.116.i.i194, 5
  br label %B1040.if

B1040.if:                                         ; preds = %B1040.if.preheader, %_ZN17bnserve_inference14adjoint_kernel7_source12_in_detectorB4v131B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxx5ArrayIxLi1E1C7mutable7alignedEd5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit
  %lsr.iv270 = phi ptr [ %scevgep271, %_ZN17bnserve_inference14adjoint_kernel7_source12_in_detectorB4v131B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxx5ArrayIxLi1E1C7mutable7alignedEd5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit ], [ %.230, %B1040.if.preheader ]
  %lsr.iv = phi ptr [ %scevgep, %_ZN17bnserve_inference14adjoint_kernel7_source12_in_detectorB4v131B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxx5ArrayIxLi1E1C7mutable7alignedEd5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit ], [ %.363, %B1040.if.preheader ]
  %.1282920924 = phi i64 [ %.1289, %_ZN17bnserve_inference14adjoint_kernel7_source12_in_detectorB4v131B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxx5ArrayIxLi1E1C7mutable7alignedEd5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit ], [ 0, %B1040.if.preheader ]
  call void @llvm.lifetime.start.p0(ptr nonnull %.747.i)
  call void @llvm.lifetime.start.p0(ptr nonnull %.782.i)
  store ptr null, ptr %.747.i, align 8, !noalias !59
  store ptr null, ptr %.782.i, align 8, !noalias !59
  %.104.i = load i64, ptr %.76, align 8, !noalias !59
  %.134.i = load i64, ptr %.133.i174, align 8, !noalias !59
  %.172.i = load i64, ptr %.171.i, align 8, !noalias !59
  %.247.i = inttoptr i64 %.172.i to ptr
  %.311.i = getelementptr inbounds double, ptr %.247.i, i64 %.1090933952
  %.289.i.i = load i64, ptr %.140, align 8, !noalias !62
  %.290.i.i = sub i64 0, %.289.i.i
  %.298.1.i.i = and i64 %.290.i.i, -8
  %.332.i.i175 = sub i64 0, %.298.1.i.i
  %.340.i.i = icmp eq i64 %.134.i, 0
  br i1 %.340.i.i, label %B224.i.i, label %B398.i.i

B224.i.i:                                         ; preds = %B1040.if
  br i1 %.402.inv.i.i, label %_ZN17bnserve_inference14adjoint_kernel7_source10_calibrateB4v142B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i, label %B268.if.preheader.i.i

B268.if.preheader.i.i:                            ; preds = %B224.i.i
  br i1 %325, label %B268.if.epil.preheader.i.i, label %B268.if.preheader.new.i.i

B268.if.preheader.new.i.i:                        ; preds = %B268.if.preheader.i.i
  br i1 %328, label %B268.if.epil.preheader4.i.i, label %B268.if.i3.i

B394.loopexit.unr-lcssa.unr-lcssa.i.i:            ; preds = %B268.if.i3.i
  br i1 %lcmp.mod.not.not.i.i305, label %B268.if.epil.preheader4.i.i, label %B394.loopexit.unr-lcssa.i.i

B268.if.epil.preheader4.i.i:                      ; preds = %B394.loopexit.unr-lcssa.unr-lcssa.i.i, %B268.if.preheader.new.i.i
  %.450957959.epil.init6.i.i = phi i64 [ 0, %B268.if.preheader.new.i.i ], [ %.457.3.1.i.i, %B394.loopexit.unr-lcssa.unr-lcssa.i.i ]
  %sunkaddr.epil.i.i310 = shl i64 %.450957959.epil.init6.i.i, 3
  %sunkaddr292.epil.i.i = getelementptr i8, ptr %.430, i64 %sunkaddr.epil.i.i310
  store <8 x double> splat (double 1.000000e+00), ptr %sunkaddr292.epil.i.i, align 8, !noalias !62
  %sunkaddr295.epil.i.i = getelementptr i8, ptr %sunkaddr292.epil.i.i, i64 1024
  store <8 x double> zeroinitializer, ptr %sunkaddr295.epil.i.i, align 8, !noalias !62
  %sunkaddr298.epil.i.i = getelementptr i8, ptr %sunkaddr292.epil.i.i, i64 64
  store <8 x double> splat (double 1.000000e+00), ptr %sunkaddr298.epil.i.i, align 8, !noalias !62
  %sunkaddr301.epil.i.i = getelementptr i8, ptr %sunkaddr292.epil.i.i, i64 1088
  store <8 x double> zeroinitializer, ptr %sunkaddr301.epil.i.i, align 8, !noalias !62
  %sunkaddr304.epil.i.i = getelementptr i8, ptr %sunkaddr292.epil.i.i, i64 128
  store <8 x double> splat (double 1.000000e+00), ptr %sunkaddr304.epil.i.i, align 8, !noalias !62
  %sunkaddr307.epil.i.i = getelementptr i8, ptr %sunkaddr292.epil.i.i, i64 1152
  store <8 x double> zeroinitializer, ptr %sunkaddr307.epil.i.i, align 8, !noalias !62
  %.457.3.epil.i.i = add i64 %.450957959.epil.init6.i.i, 32
  %sunkaddr308.epil.i.i = shl i64 %.457.3.epil.i.i, 3
  %sunkaddr309.epil.i.i = getelementptr i8, ptr %.430, i64 %sunkaddr308.epil.i.i
  %sunkaddr310.epil.i.i = getelementptr i8, ptr %sunkaddr309.epil.i.i, i64 -64
  store <8 x double> splat (double 1.000000e+00), ptr %sunkaddr310.epil.i.i, align 8, !noalias !62
  %sunkaddr313.epil.i.i = getelementptr i8, ptr %sunkaddr309.epil.i.i, i64 960
  store <8 x double> zeroinitializer, ptr %sunkaddr313.epil.i.i, align 8, !noalias !62
  br label %B394.loopexit.unr-lcssa.i.i

B394.loopexit.unr-lcssa.i.i:                      ; preds = %B268.if.epil.preheader4.i.i, %B394.loopexit.unr-lcssa.unr-lcssa.i.i
  %.457.3.lcssa.i.i = phi i64 [ %.457.3.epil.i.i, %B268.if.epil.preheader4.i.i ], [ %.457.3.1.i.i, %B394.loopexit.unr-lcssa.unr-lcssa.i.i ]
  br i1 %lcmp.mod227.not.i.i, label %_ZN17bnserve_inference14adjoint_kernel7_source10_calibrateB4v142B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i, label %B268.if.epil.preheader.i.i

B268.if.epil.preheader.i.i:                       ; preds = %B394.loopexit.unr-lcssa.i.i, %B268.if.preheader.i.i
  %.450957959.epil.init.i.i = phi i64 [ 0, %B268.if.preheader.i.i ], [ %.457.3.lcssa.i.i, %B394.loopexit.unr-lcssa.i.i ]
  %340 = shl i64 %.450957959.epil.init.i.i, 3
  %341 = getelementptr i8, ptr %.430, i64 %340
  %scevgep.i.i306 = getelementptr i8, ptr %341, i64 1024
  br label %B268.if.epil.i.i

B268.if.epil.i.i:                                 ; preds = %B268.if.epil.i.i, %B268.if.epil.preheader.i.i
  %lsr.iv.i.i307 = phi i64 [ %lsr.iv.next.i.i308, %B268.if.epil.i.i ], [ 0, %B268.if.epil.preheader.i.i ]
  %scevgep232.i.i = getelementptr i8, ptr %scevgep.i.i306, i64 %lsr.iv.i.i307
  %scevgep233.i.i = getelementptr i8, ptr %scevgep232.i.i, i64 -1024
  store <8 x double> splat (double 1.000000e+00), ptr %scevgep233.i.i, align 8, !noalias !62
  store <8 x double> zeroinitializer, ptr %scevgep232.i.i, align 8, !noalias !62
  %lsr.iv.next.i.i308 = add nuw nsw i64 %lsr.iv.i.i307, 64
  %epil.iter.cmp.not.i.i309 = icmp eq i64 %332, %lsr.iv.next.i.i308
  br i1 %epil.iter.cmp.not.i.i309, label %_ZN17bnserve_inference14adjoint_kernel7_source10_calibrateB4v142B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i, label %B268.if.epil.i.i, !llvm.loop !65

B398.i.i:                                         ; preds = %B1040.if
  %.665.i.i176 = shl nsw i64 %.134.i, 3
  %.695.i.i177 = load i64, ptr %arg.arguments.4, align 8, !noalias !62
  %.697.i.i = mul nsw i64 %.695.i.i177, %.7709701030
  %.701.i.i = add nsw i64 %.697.i.i, %.1282920924
  %.704.i.i178 = mul nsw i64 %.701.i.i, %.665.i.i176
  %.735.i.i = load i64, ptr %.734.i.i, align 8, !noalias !62
  %.738.i.i = mul nsw i64 %.134.i, %.332.i.i175
  %.818.i.i180 = load i64, ptr %.817.i.i179, align 8, !noalias !62
  %.819.i.i181 = add nsw i64 %.704.i.i178, %.818.i.i180
  br i1 %.104.i.i.i, label %B60.if.preheader.i.i.i, label %B76.i.i.i

B1142.i.i:                                        ; preds = %B926.if.i.i, %B398.endif.endif.endif.endif.endif.endif.endif.i.i
  tail call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(2048) %.1448.i.i184, i8 0, i64 2048, i1 false), !noalias !62
  br label %_ZN17bnserve_inference14adjoint_kernel7_source10_calibrateB4v142B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i

B268.if.i3.i:                                     ; preds = %B268.if.preheader.new.i.i, %B268.if.i3.i
  %lsr.iv5.i.i = phi i64 [ %lsr.iv.next6.i.i, %B268.if.i3.i ], [ %330, %B268.if.preheader.new.i.i ]
  %.450957959.i.i = phi i64 [ %.457.3.1.i.i, %B268.if.i3.i ], [ 0, %B268.if.preheader.new.i.i ]
  %sunkaddr81.i.i296 = shl i64 %.450957959.i.i, 3
  %sunkaddr82.i.i = getelementptr i8, ptr %.430, i64 %sunkaddr81.i.i296
  store <8 x double> splat (double 1.000000e+00), ptr %sunkaddr82.i.i, align 8, !noalias !62
  %sunkaddr85.i.i = getelementptr i8, ptr %sunkaddr82.i.i, i64 1024
  store <8 x double> zeroinitializer, ptr %sunkaddr85.i.i, align 8, !noalias !62
  %sunkaddr88.i.i = getelementptr i8, ptr %sunkaddr82.i.i, i64 64
  store <8 x double> splat (double 1.000000e+00), ptr %sunkaddr88.i.i, align 8, !noalias !62
  %sunkaddr90.i.i297 = getelementptr i8, ptr %sunkaddr82.i.i, i64 1088
  store <8 x double> zeroinitializer, ptr %sunkaddr90.i.i297, align 8, !noalias !62
  %sunkaddr93.i.i298 = getelementptr i8, ptr %sunkaddr82.i.i, i64 128
  store <8 x double> splat (double 1.000000e+00), ptr %sunkaddr93.i.i298, align 8, !noalias !62
  %sunkaddr96.i.i299 = getelementptr i8, ptr %sunkaddr82.i.i, i64 1152
  store <8 x double> zeroinitializer, ptr %sunkaddr96.i.i299, align 8, !noalias !62
  %sunkaddr99.i.i300 = getelementptr i8, ptr %sunkaddr82.i.i, i64 192
  store <8 x double> splat (double 1.000000e+00), ptr %sunkaddr99.i.i300, align 8, !noalias !62
  %sunkaddr102.i.i301 = getelementptr i8, ptr %sunkaddr82.i.i, i64 1216
  store <8 x double> zeroinitializer, ptr %sunkaddr102.i.i301, align 8, !noalias !62
  %sunkaddr105.i.i = getelementptr i8, ptr %sunkaddr82.i.i, i64 256
  store <8 x double> splat (double 1.000000e+00), ptr %sunkaddr105.i.i, align 8, !noalias !62
  %sunkaddr108.i.i302 = getelementptr i8, ptr %sunkaddr82.i.i, i64 1280
  store <8 x double> zeroinitializer, ptr %sunkaddr108.i.i302, align 8, !noalias !62
  %sunkaddr111.i.i303 = getelementptr i8, ptr %sunkaddr82.i.i, i64 320
  store <8 x double> splat (double 1.000000e+00), ptr %sunkaddr111.i.i303, align 8, !noalias !62
  %sunkaddr114.i.i = getelementptr i8, ptr %sunkaddr82.i.i, i64 1344
  store <8 x double> zeroinitializer, ptr %sunkaddr114.i.i, align 8, !noalias !62
  %sunkaddr117.i.i304 = getelementptr i8, ptr %sunkaddr82.i.i, i64 384
  store <8 x double> splat (double 1.000000e+00), ptr %sunkaddr117.i.i304, align 8, !noalias !62
  %sunkaddr120.i.i = getelementptr i8, ptr %sunkaddr82.i.i, i64 1408
  store <8 x double> zeroinitializer, ptr %sunkaddr120.i.i, align 8, !noalias !62
  %.457.3.1.i.i = add i64 %.450957959.i.i, 64
  %sunkaddr121.i.i = shl i64 %.457.3.1.i.i, 3
  %sunkaddr122.i.i = getelementptr i8, ptr %.430, i64 %sunkaddr121.i.i
  %sunkaddr124.i.i = getelementptr i8, ptr %sunkaddr122.i.i, i64 -64
  store <8 x double> splat (double 1.000000e+00), ptr %sunkaddr124.i.i, align 8, !noalias !62
  %sunkaddr127.i.i = getelementptr i8, ptr %sunkaddr122.i.i, i64 960
  store <8 x double> zeroinitializer, ptr %sunkaddr127.i.i, align 8, !noalias !62
  %lsr.iv.next6.i.i = add i64 %lsr.iv5.i.i, -2
  %niter.ncmp.110.i.i = icmp eq i64 %lsr.iv.next6.i.i, 0
  br i1 %niter.ncmp.110.i.i, label %B394.loopexit.unr-lcssa.unr-lcssa.i.i, label %B268.if.i3.i

B60.if.preheader.i.i.i:                           ; preds = %B398.i.i
  tail call void @llvm.memset.p0.i64(ptr nonnull align 8 %.536.i.i, i8 0, i64 %310, i1 false), !noalias !66
  br label %B76.i.i.i

B76.i.i.i:                                        ; preds = %B60.if.preheader.i.i.i, %B398.i.i
  %.311284.not.i.i.i = icmp slt i64 %.134.i, 1
  br i1 %.311284.not.i.i.i, label %B398.endif.endif.endif.endif.endif.i.i, label %B128.if.lr.ph.i.i.i

B128.if.lr.ph.i.i.i:                              ; preds = %B76.i.i.i
  %342 = inttoptr i64 %.735.i.i to ptr
  %scevgep282.i.i = getelementptr i8, ptr %342, i64 24
  %343 = inttoptr i64 %.819.i.i181 to ptr
  br label %B128.if.i.i.i

B284.i.i.i:                                       ; preds = %B228.if.i.i.i, %B130.else.endif.endif.endif.endif.i.i.i
  %exitcond292.not.i.i.i = icmp eq i64 %.324.i.i.i, %.134.i
  br i1 %exitcond292.not.i.i.i, label %B398.endif.endif.endif.endif.endif.i.i, label %B128.if.i.i.i

B128.if.i.i.i:                                    ; preds = %B284.i.i.i, %B128.if.lr.ph.i.i.i
  %.317279285.i.i.i = phi i64 [ 0, %B128.if.lr.ph.i.i.i ], [ %.324.i.i.i, %B284.i.i.i ]
  %.324.i.i.i = add nuw nsw i64 %.317279285.i.i.i, 1
  %.350.i.i.i = mul nsw i64 %.317279285.i.i.i, %.332.i.i175
  %.352.i.i.i = add nsw i64 %.350.i.i.i, %.1090933952
  %.395.i.i.i = icmp slt i64 %.352.i.i.i, 0
  %.396.i.i.i = select i1 %.395.i.i.i, i64 %.738.i.i, i64 0
  %.397.i.i.i = add i64 %.396.i.i.i, %.352.i.i.i
  %.400.i.i.i = icmp slt i64 %.397.i.i.i, 0
  br i1 %.400.i.i.i, label %B130.else.if.i.i.i, label %B130.else.endif.i.i.i, !prof !69

B130.else.if.i.i.i:                               ; preds = %B128.if.i.i.i
  br label %B130.else.endif.i.i.i

B130.else.endif.i.i.i:                            ; preds = %B130.else.if.i.i.i, %B128.if.i.i.i
  %.385.sroa.0.1.i.i.i = phi i64 [ 0, %B130.else.if.i.i.i ], [ %.397.i.i.i, %B128.if.i.i.i ]
  %.405.not.i.i.i = icmp slt i64 %.397.i.i.i, %.738.i.i
  br i1 %.405.not.i.i.i, label %B130.else.endif.endif.endif.endif.i.i.i, label %B130.else.endif.if.i.i.i, !prof !70

B130.else.endif.if.i.i.i:                         ; preds = %B130.else.endif.i.i.i
  br label %B130.else.endif.endif.endif.endif.i.i.i

B130.else.endif.endif.endif.endif.i.i.i:          ; preds = %B130.else.endif.if.i.i.i, %B130.else.endif.i.i.i
  %.385.sroa.0.3.i.i.i = phi i64 [ %.738.i.i, %B130.else.endif.if.i.i.i ], [ %.385.sroa.0.1.i.i.i, %B130.else.endif.i.i.i ]
  %344 = getelementptr double, ptr %343, i64 %.317279285.i.i.i
  %.565.i.i.i = load double, ptr %344, align 8, !noalias !66
  br i1 %316, label %B284.i.i.i, label %B228.if.preheader.i.i.i

B228.if.preheader.i.i.i:                          ; preds = %B130.else.endif.endif.endif.endif.i.i.i
  %345 = shl i64 %.385.sroa.0.3.i.i.i, 3
  %scevgep283.i.i = getelementptr i8, ptr %scevgep282.i.i, i64 %345
  br label %B228.if.i.i.i

B228.if.i.i.i:                                    ; preds = %B228.if.i.i.i, %B228.if.preheader.i.i.i
  %lsr.iv63.i.i = phi i64 [ %lsr.iv.next64.i.i, %B228.if.i.i.i ], [ %315, %B228.if.preheader.i.i.i ]
  %.655272274.i.i.i = phi i64 [ %.662.1.i.1.i.i, %B228.if.i.i.i ], [ 0, %B228.if.preheader.i.i.i ]
  %sunkaddr128.i.i = shl i64 %.655272274.i.i.i, 3
  %sunkaddr129.i.i = getelementptr i8, ptr %.430, i64 %sunkaddr128.i.i
  %sunkaddr130.i.i = getelementptr i8, ptr %sunkaddr129.i.i, i64 2048
  %.716.i.i.i = load double, ptr %sunkaddr130.i.i, align 8, !noalias !66
  %scevgep79.i.i = getelementptr i8, ptr %scevgep283.i.i, i64 %sunkaddr128.i.i
  %scevgep80.i.i = getelementptr i8, ptr %scevgep79.i.i, i64 -16
  %scevgep78.i.i = getelementptr i8, ptr %scevgep79.i.i, i64 -24
  %.746.i.i.i = load double, ptr %scevgep78.i.i, align 8, !noalias !66
  %.748.i.i.i = fmul contract double %.565.i.i.i, %.746.i.i.i
  %.749.i.i.i = fadd contract double %.716.i.i.i, %.748.i.i.i
  store double %.749.i.i.i, ptr %sunkaddr130.i.i, align 8, !noalias !66
  %sunkaddr133.i.i = getelementptr i8, ptr %sunkaddr129.i.i, i64 2056
  %.716.1.i.i.i = load double, ptr %sunkaddr133.i.i, align 8, !noalias !66
  %.746.1.i.i.i = load double, ptr %scevgep80.i.i, align 8, !noalias !66
  %.748.1.i.i.i = fmul contract double %.565.i.i.i, %.746.1.i.i.i
  %.749.1.i.i.i = fadd contract double %.716.1.i.i.i, %.748.1.i.i.i
  store double %.749.1.i.i.i, ptr %sunkaddr133.i.i, align 8, !noalias !66
  %sunkaddr137.i.i = getelementptr i8, ptr %sunkaddr129.i.i, i64 2064
  %.716.i.1.i.i = load double, ptr %sunkaddr137.i.i, align 8, !noalias !66
  %scevgep76.i.i = getelementptr i8, ptr %scevgep79.i.i, i64 -8
  %.746.i.1.i.i = load double, ptr %scevgep76.i.i, align 8, !noalias !66
  %.748.i.1.i.i = fmul contract double %.565.i.i.i, %.746.i.1.i.i
  %.749.i.1.i.i = fadd contract double %.716.i.1.i.i, %.748.i.1.i.i
  store double %.749.i.1.i.i, ptr %sunkaddr137.i.i, align 8, !noalias !66
  %.662.1.i.1.i.i = add i64 %.655272274.i.i.i, 4
  %sunkaddr138.i.i = shl i64 %.662.1.i.1.i.i, 3
  %sunkaddr139.i.i = getelementptr i8, ptr %.430, i64 %sunkaddr138.i.i
  %sunkaddr140.i.i = getelementptr i8, ptr %sunkaddr139.i.i, i64 2040
  %.716.1.i.1.i.i = load double, ptr %sunkaddr140.i.i, align 8, !noalias !66
  %.746.1.i.1.i.i = load double, ptr %scevgep79.i.i, align 8, !noalias !66
  %.748.1.i.1.i.i = fmul contract double %.565.i.i.i, %.746.1.i.1.i.i
  %.749.1.i.1.i.i = fadd contract double %.716.1.i.1.i.i, %.748.1.i.1.i.i
  store double %.749.1.i.1.i.i, ptr %sunkaddr140.i.i, align 8, !noalias !66
  %lsr.iv.next64.i.i = add i64 %lsr.iv63.i.i, 2
  %niter.ncmp.1.i.i182 = icmp eq i64 %lsr.iv.next64.i.i, 0
  br i1 %niter.ncmp.1.i.i182, label %B284.i.i.i, label %B228.if.i.i.i

B398.endif.endif.endif.endif.endif.i.i:           ; preds = %B284.i.i.i, %B76.i.i.i
  %.936.i.i = load i64, ptr %.935.i.i, align 8, !noalias !62
  %.942.i.i = add nsw i64 %.936.i.i, %.704.i.i178
  br i1 %.104.i.i.i, label %B60.if.preheader.i128.i.i, label %B76.i77.i.i

B60.if.preheader.i128.i.i:                        ; preds = %B398.endif.endif.endif.endif.endif.i.i
  tail call void @llvm.memset.p0.i64(ptr nonnull align 8 %.607.i.i, i8 0, i64 %317, i1 false), !noalias !71
  br label %B76.i77.i.i

B76.i77.i.i:                                      ; preds = %B60.if.preheader.i128.i.i, %B398.endif.endif.endif.endif.endif.i.i
  br i1 %.311284.not.i.i.i, label %B398.endif.endif.endif.endif.endif.endif.endif.i.i, label %B128.if.lr.ph.i79.i.i

B128.if.lr.ph.i79.i.i:                            ; preds = %B76.i77.i.i
  %346 = inttoptr i64 %.735.i.i to ptr
  %scevgep264.i.i = getelementptr i8, ptr %346, i64 24
  %347 = inttoptr i64 %.942.i.i to ptr
  br label %B128.if.i82.i.i

B284.i125.i.i:                                    ; preds = %B228.if.i102.i.i, %B130.else.endif.endif.endif.endif.i95.i.i
  %exitcond292.not.i126.i.i = icmp eq i64 %.324.i84.i.i, %.134.i
  br i1 %exitcond292.not.i126.i.i, label %B398.endif.endif.endif.endif.endif.endif.endif.i.i, label %B128.if.i82.i.i

B128.if.i82.i.i:                                  ; preds = %B284.i125.i.i, %B128.if.lr.ph.i79.i.i
  %.317279285.i83.i.i = phi i64 [ 0, %B128.if.lr.ph.i79.i.i ], [ %.324.i84.i.i, %B284.i125.i.i ]
  %.324.i84.i.i = add nuw nsw i64 %.317279285.i83.i.i, 1
  %.350.i85.i.i = mul nsw i64 %.317279285.i83.i.i, %.332.i.i175
  %.352.i86.i.i = add nsw i64 %.350.i85.i.i, %.1090933952
  %.395.i87.i.i = icmp slt i64 %.352.i86.i.i, 0
  %.396.i88.i.i = select i1 %.395.i87.i.i, i64 %.738.i.i, i64 0
  %.397.i89.i.i = add i64 %.396.i88.i.i, %.352.i86.i.i
  %.400.i90.i.i = icmp slt i64 %.397.i89.i.i, 0
  br i1 %.400.i90.i.i, label %B130.else.if.i127.i.i, label %B130.else.endif.i91.i.i, !prof !69

B130.else.if.i127.i.i:                            ; preds = %B128.if.i82.i.i
  br label %B130.else.endif.i91.i.i

B130.else.endif.i91.i.i:                          ; preds = %B130.else.if.i127.i.i, %B128.if.i82.i.i
  %.385.sroa.0.1.i92.i.i = phi i64 [ 0, %B130.else.if.i127.i.i ], [ %.397.i89.i.i, %B128.if.i82.i.i ]
  %.405.not.i93.i.i = icmp slt i64 %.397.i89.i.i, %.738.i.i
  br i1 %.405.not.i93.i.i, label %B130.else.endif.endif.endif.endif.i95.i.i, label %B130.else.endif.if.i94.i.i, !prof !70

B130.else.endif.if.i94.i.i:                       ; preds = %B130.else.endif.i91.i.i
  br label %B130.else.endif.endif.endif.endif.i95.i.i

B130.else.endif.endif.endif.endif.i95.i.i:        ; preds = %B130.else.endif.if.i94.i.i, %B130.else.endif.i91.i.i
  %.385.sroa.0.3.i96.i.i = phi i64 [ %.738.i.i, %B130.else.endif.if.i94.i.i ], [ %.385.sroa.0.1.i92.i.i, %B130.else.endif.i91.i.i ]
  %348 = getelementptr double, ptr %347, i64 %.317279285.i83.i.i
  %.565.i98.i.i = load double, ptr %348, align 8, !noalias !71
  br i1 %323, label %B284.i125.i.i, label %B228.if.preheader.i99.i.i

B228.if.preheader.i99.i.i:                        ; preds = %B130.else.endif.endif.endif.endif.i95.i.i
  %349 = shl i64 %.385.sroa.0.3.i96.i.i, 3
  %scevgep265.i.i = getelementptr i8, ptr %scevgep264.i.i, i64 %349
  br label %B228.if.i102.i.i

B228.if.i102.i.i:                                 ; preds = %B228.if.i102.i.i, %B228.if.preheader.i99.i.i
  %lsr.iv41.i.i = phi i64 [ %lsr.iv.next42.i.i, %B228.if.i102.i.i ], [ %322, %B228.if.preheader.i99.i.i ]
  %.655272274.i103.i.i = phi i64 [ %.662.1.i111.1.i.i, %B228.if.i102.i.i ], [ 0, %B228.if.preheader.i99.i.i ]
  %sunkaddr141.i.i = shl i64 %.655272274.i103.i.i, 3
  %sunkaddr142.i.i = getelementptr i8, ptr %.430, i64 %sunkaddr141.i.i
  %sunkaddr143.i.i = getelementptr i8, ptr %sunkaddr142.i.i, i64 3072
  %.716.i105.i.i = load double, ptr %sunkaddr143.i.i, align 8, !noalias !71
  %scevgep59.i.i = getelementptr i8, ptr %scevgep265.i.i, i64 %sunkaddr141.i.i
  %scevgep62.i.i = getelementptr i8, ptr %scevgep59.i.i, i64 -16
  %scevgep56.i.i = getelementptr i8, ptr %scevgep59.i.i, i64 -24
  %.746.i108.i.i = load double, ptr %scevgep56.i.i, align 8, !noalias !71
  %.748.i109.i.i = fmul contract double %.565.i98.i.i, %.746.i108.i.i
  %.749.i110.i.i = fadd contract double %.716.i105.i.i, %.748.i109.i.i
  store double %.749.i110.i.i, ptr %sunkaddr143.i.i, align 8, !noalias !71
  %sunkaddr146.i.i = getelementptr i8, ptr %sunkaddr142.i.i, i64 3080
  %.716.1.i113.i.i = load double, ptr %sunkaddr146.i.i, align 8, !noalias !71
  %.746.1.i114.i.i = load double, ptr %scevgep62.i.i, align 8, !noalias !71
  %.748.1.i115.i.i = fmul contract double %.565.i98.i.i, %.746.1.i114.i.i
  %.749.1.i116.i.i = fadd contract double %.716.1.i113.i.i, %.748.1.i115.i.i
  store double %.749.1.i116.i.i, ptr %sunkaddr146.i.i, align 8, !noalias !71
  %sunkaddr149.i.i = getelementptr i8, ptr %sunkaddr142.i.i, i64 3088
  %.716.i105.1.i.i = load double, ptr %sunkaddr149.i.i, align 8, !noalias !71
  %scevgep54.i.i = getelementptr i8, ptr %scevgep59.i.i, i64 -8
  %.746.i108.1.i.i = load double, ptr %scevgep54.i.i, align 8, !noalias !71
  %.748.i109.1.i.i = fmul contract double %.565.i98.i.i, %.746.i108.1.i.i
  %.749.i110.1.i.i = fadd contract double %.716.i105.1.i.i, %.748.i109.1.i.i
  store double %.749.i110.1.i.i, ptr %sunkaddr149.i.i, align 8, !noalias !71
  %.662.1.i111.1.i.i = add i64 %.655272274.i103.i.i, 4
  %sunkaddr150.i.i = shl i64 %.662.1.i111.1.i.i, 3
  %sunkaddr151.i.i = getelementptr i8, ptr %.430, i64 %sunkaddr150.i.i
  %sunkaddr152.i.i = getelementptr i8, ptr %sunkaddr151.i.i, i64 3064
  %.716.1.i113.1.i.i = load double, ptr %sunkaddr152.i.i, align 8, !noalias !71
  %.746.1.i114.1.i.i = load double, ptr %scevgep59.i.i, align 8, !noalias !71
  %.748.1.i115.1.i.i = fmul contract double %.565.i98.i.i, %.746.1.i114.1.i.i
  %.749.1.i116.1.i.i = fadd contract double %.716.1.i113.1.i.i, %.748.1.i115.1.i.i
  store double %.749.1.i116.1.i.i, ptr %sunkaddr152.i.i, align 8, !noalias !71
  %lsr.iv.next42.i.i = add i64 %lsr.iv41.i.i, 2
  %niter225.ncmp.1.i.i = icmp eq i64 %lsr.iv.next42.i.i, 0
  br i1 %niter225.ncmp.1.i.i, label %B284.i125.i.i, label %B228.if.i102.i.i

B398.endif.endif.endif.endif.endif.endif.endif.i.i: ; preds = %B284.i125.i.i, %B76.i77.i.i
  br i1 %.1077.inv.i.i, label %B1142.i.i, label %B926.if.i.i

B926.if.i.i:                                      ; preds = %B398.endif.endif.endif.endif.endif.endif.endif.i.i, %B926.if.i.i
  %lsr.iv39.i.i = phi i64 [ %lsr.iv.next40.i.i, %B926.if.i.i ], [ %324, %B398.endif.endif.endif.endif.endif.endif.endif.i.i ]
  %lsr.iv251.i.i = phi ptr [ %scevgep252.i.i, %B926.if.i.i ], [ %.607.i.i, %B398.endif.endif.endif.endif.endif.endif.endif.i.i ]
  %.1166.i.i = load <8 x double>, ptr %lsr.iv251.i.i, align 8, !noalias !62
  %scevgep255.i.i = getelementptr i8, ptr %lsr.iv251.i.i, i64 -1024
  %.1176.i.i = load <8 x double>, ptr %scevgep255.i.i, align 8, !noalias !62
  %.8.i.i1.i = fadd contract <8 x double> %.1176.i.i, splat (double 1.000000e+00)
  %.1203.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1166.i.i, <8 x double> %.1166.i.i, <8 x double> splat (double 4.000000e+00))
  %.6.i.i.i183 = fdiv contract <8 x double> %.8.i.i1.i, %.1203.i.i
  %350 = fmul contract <8 x double> %.1166.i.i, %.1166.i.i
  %.8.i132.i.i = fsub contract <8 x double> splat (double 4.000000e+00), %350
  %.6.i133.i2.i = fmul contract <8 x double> %.8.i132.i.i, %.6.i.i.i183
  %scevgep254.i.i = getelementptr i8, ptr %lsr.iv251.i.i, i64 -3072
  store <8 x double> %.6.i133.i2.i, ptr %scevgep254.i.i, align 8, !noalias !62
  %.6.i134.i.i = fmul contract <8 x double> %.1166.i.i, %.6.i.i.i183
  %.8.i135.i.i = fmul contract <8 x double> %.6.i134.i.i, splat (double 4.000000e+00)
  %scevgep253.i.i = getelementptr i8, ptr %lsr.iv251.i.i, i64 -2048
  store <8 x double> %.8.i135.i.i, ptr %scevgep253.i.i, align 8, !noalias !62
  %scevgep252.i.i = getelementptr i8, ptr %lsr.iv251.i.i, i64 64
  %lsr.iv.next40.i.i = add nsw i64 %lsr.iv39.i.i, -1
  %.1119.i.i = icmp sgt i64 %lsr.iv39.i.i, 5
  br i1 %.1119.i.i, label %B926.if.i.i, label %B1142.i.i

_ZN17bnserve_inference14adjoint_kernel7_source10_calibrateB4v142B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i: ; preds = %B268.if.epil.i.i, %B1142.i.i, %B394.loopexit.unr-lcssa.i.i, %B224.i.i
  %.510.i = icmp sgt i64 %.104.i, 0
  br i1 %.510.i, label %B358.if.lr.ph.i, label %B1100.i

B444.i:                                           ; preds = %B358.if.i
  %.157.i.i = getelementptr i8, ptr %378, i64 24576
  tail call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(12288) %.157.i.i, i8 0, i64 12288, i1 false), !noalias !74
  store ptr null, ptr %.747.i, align 8, !noalias !59
  call fastcc void @inner_2(ptr nonnull %.747.i, ptr readonly %lsr.iv270, i64 17, double 1.000000e+00, ptr %.311.i, i64 range(i64 -9223372036854775808, 129) %.13.i, i64 range(i64 -9223372036854775808, 129) %.13.i, ptr %.612.i)
  store ptr null, ptr %.782.i, align 8, !noalias !59
  call fastcc void @inner_2(ptr nonnull %.782.i, ptr readonly %lsr.iv270, i64 21, double -1.000000e+00, ptr %.311.i, i64 range(i64 -9223372036854775808, 129) %.13.i, i64 range(i64 -9223372036854775808, 129) %.13.i, ptr %.612.i)
  br label %B632.i

B596.i:                                           ; preds = %B358.if.i
  br i1 %.93.inv.i.i, label %B632.endif.i, label %B158.if.lr.ph.i.i

B158.if.lr.ph.i.i:                                ; preds = %B596.i
  %.2220.5.i.i = getelementptr i8, ptr %378, i64 35840
  br label %B158.if.i.i

B158.if.i.i:                                      ; preds = %B158.if.i.i, %B158.if.lr.ph.i.i
  %lsr.iv6.i.i = phi i64 [ %lsr.iv.next7.i.i, %B158.if.i.i ], [ %334, %B158.if.lr.ph.i.i ]
  %lsr.iv226.i.i = phi ptr [ %scevgep.i16.i, %B158.if.i.i ], [ %.2220.5.i.i, %B158.if.lr.ph.i.i ]
  %scevgep239.i.i = getelementptr i8, ptr %lsr.iv226.i.i, i64 -17408
  %.362.i.i = load <8 x double>, ptr %scevgep239.i.i, align 8, !noalias !77
  %scevgep238.i.i = getelementptr i8, ptr %lsr.iv226.i.i, i64 -16384
  %.373.i.i198 = load <8 x double>, ptr %scevgep238.i.i, align 8, !noalias !77
  %.6.i.i6.i = fmul contract <8 x double> %.362.i.i, %.362.i.i
  %.6.i111.i.i = fmul contract <8 x double> %.373.i.i198, %.373.i.i198
  %.6.i112.i.i = fsub contract <8 x double> %.6.i.i6.i, %.6.i111.i.i
  %.6.i113.i.i = fmul contract <8 x double> %.362.i.i, %.373.i.i198
  %.8.i.i7.i = fmul contract <8 x double> %.6.i113.i.i, splat (double 2.000000e+00)
  %.610.i.i199 = load double, ptr %sunkaddr8.i.i, align 8, !noalias !77
  %.640.i.i = load double, ptr %sunkaddr9.i.i, align 8, !noalias !77
  %.669.i.i200 = load double, ptr %sunkaddr10.i.i, align 8, !noalias !77
  %.670.i.i201 = insertelement <8 x double> poison, double %.669.i.i200, i64 0
  %.671.i.i = shufflevector <8 x double> %.670.i.i201, <8 x double> poison, <8 x i32> zeroinitializer
  %.672.i.i202 = insertelement <8 x double> poison, double %.640.i.i, i64 0
  %.673.i.i203 = shufflevector <8 x double> %.672.i.i202, <8 x double> poison, <8 x i32> zeroinitializer
  %.674.i.i204 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.362.i.i, <8 x double> %.673.i.i203, <8 x double> %.671.i.i)
  %.675.i.i205 = insertelement <8 x double> poison, double %.610.i.i199, i64 0
  %.676.i.i206 = shufflevector <8 x double> %.675.i.i205, <8 x double> poison, <8 x i32> zeroinitializer
  %.677.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.373.i.i198, <8 x double> %.676.i.i206, <8 x double> %.674.i.i204)
  %.707.i.i = load double, ptr %sunkaddr11.i.i, align 8, !noalias !77
  %.737.i.i = load double, ptr %sunkaddr12.i.i, align 8, !noalias !77
  %.741.i.i = insertelement <8 x double> poison, double %.737.i.i, i64 0
  %.742.i.i = shufflevector <8 x double> %.741.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.743.i.i207 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i112.i.i, <8 x double> %.742.i.i, <8 x double> %.677.i.i)
  %.744.i.i = insertelement <8 x double> poison, double %.707.i.i, i64 0
  %.745.i.i208 = shufflevector <8 x double> %.744.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.746.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i.i7.i, <8 x double> %.745.i.i208, <8 x double> %.743.i.i207)
  %scevgep237.i.i = getelementptr i8, ptr %lsr.iv226.i.i, i64 -11264
  store <8 x double> %.746.i.i, ptr %scevgep237.i.i, align 8, !noalias !77
  %.877.i.i = load double, ptr %sunkaddr13.i.i, align 8, !noalias !77
  %.907.i.i = load double, ptr %sunkaddr14.i.i, align 8, !noalias !77
  %.936.i8.i = load double, ptr %sunkaddr15.i.i, align 8, !noalias !77
  %.937.i.i = insertelement <8 x double> poison, double %.936.i8.i, i64 0
  %.938.i.i = shufflevector <8 x double> %.937.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.939.i.i = insertelement <8 x double> poison, double %.907.i.i, i64 0
  %.940.i.i = shufflevector <8 x double> %.939.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.941.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.362.i.i, <8 x double> %.940.i.i, <8 x double> %.938.i.i)
  %.942.i9.i = insertelement <8 x double> poison, double %.877.i.i, i64 0
  %.943.i.i = shufflevector <8 x double> %.942.i9.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.944.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.373.i.i198, <8 x double> %.943.i.i, <8 x double> %.941.i.i)
  %.974.i.i = load double, ptr %sunkaddr16.i.i, align 8, !noalias !77
  %.1004.i.i = load double, ptr %sunkaddr17.i.i, align 8, !noalias !77
  %.1008.i.i = insertelement <8 x double> poison, double %.1004.i.i, i64 0
  %.1009.i.i = shufflevector <8 x double> %.1008.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1010.i10.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i112.i.i, <8 x double> %.1009.i.i, <8 x double> %.944.i.i)
  %.1011.i.i = insertelement <8 x double> poison, double %.974.i.i, i64 0
  %.1012.i.i = shufflevector <8 x double> %.1011.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1013.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i.i7.i, <8 x double> %.1012.i.i, <8 x double> %.1010.i10.i)
  %scevgep236.i.i = getelementptr i8, ptr %lsr.iv226.i.i, i64 -9216
  store <8 x double> %.1013.i.i, ptr %scevgep236.i.i, align 8, !noalias !77
  %.1144.i.i = load double, ptr %sunkaddr8.i.i, align 8, !noalias !77
  %.1174.i.i = load double, ptr %sunkaddr9.i.i, align 8, !noalias !77
  %.1175.i.i = fsub contract double 0.000000e+00, %.1174.i.i
  %.6.i129.i11.i = insertelement <8 x double> poison, double %.1175.i.i, i64 0
  %.7.i.i12.i = shufflevector <8 x double> %.6.i129.i11.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.8.i130.i.i = fmul contract <8 x double> %.373.i.i198, %.7.i.i12.i
  %.1200.i.i = insertelement <8 x double> poison, double %.1144.i.i, i64 0
  %.1201.i.i = shufflevector <8 x double> %.1200.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1202.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.362.i.i, <8 x double> %.1201.i.i, <8 x double> %.8.i130.i.i)
  %.1232.i.i = load double, ptr %sunkaddr11.i.i, align 8, !noalias !77
  %.1233.i.i = fmul contract double %.1232.i.i, 2.000000e+00
  %.1263.i.i = load double, ptr %sunkaddr12.i.i, align 8, !noalias !77
  %.1267.i.i = fmul contract double %.1263.i.i, -2.000000e+00
  %.1268.i.i = insertelement <8 x double> poison, double %.1267.i.i, i64 0
  %.1269.i.i = shufflevector <8 x double> %.1268.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1270.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i.i7.i, <8 x double> %.1269.i.i, <8 x double> %.1202.i.i)
  %.1271.i.i = insertelement <8 x double> poison, double %.1233.i.i, i64 0
  %.1272.i.i = shufflevector <8 x double> %.1271.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1273.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i112.i.i, <8 x double> %.1272.i.i, <8 x double> %.1270.i.i)
  %scevgep235.i.i = getelementptr i8, ptr %lsr.iv226.i.i, i64 -7168
  store <8 x double> %.1273.i.i, ptr %scevgep235.i.i, align 8, !noalias !77
  %.1404.i.i = load double, ptr %sunkaddr13.i.i, align 8, !noalias !77
  %.1434.i.i = load double, ptr %sunkaddr14.i.i, align 8, !noalias !77
  %.1435.i.i = fsub contract double 0.000000e+00, %.1434.i.i
  %.6.i136.i.i = insertelement <8 x double> poison, double %.1435.i.i, i64 0
  %.7.i137.i.i = shufflevector <8 x double> %.6.i136.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.8.i138.i.i = fmul contract <8 x double> %.373.i.i198, %.7.i137.i.i
  %.1460.i.i = insertelement <8 x double> poison, double %.1404.i.i, i64 0
  %.1461.i.i = shufflevector <8 x double> %.1460.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1462.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.362.i.i, <8 x double> %.1461.i.i, <8 x double> %.8.i138.i.i)
  %.1492.i.i209 = load double, ptr %sunkaddr16.i.i, align 8, !noalias !77
  %.1493.i.i = fmul contract double %.1492.i.i209, 2.000000e+00
  %.1523.i.i210 = load double, ptr %sunkaddr17.i.i, align 8, !noalias !77
  %.1527.i13.i = fmul contract double %.1523.i.i210, -2.000000e+00
  %.1528.i.i = insertelement <8 x double> poison, double %.1527.i13.i, i64 0
  %.1529.i.i = shufflevector <8 x double> %.1528.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1530.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i.i7.i, <8 x double> %.1529.i.i, <8 x double> %.1462.i.i)
  %.1531.i.i = insertelement <8 x double> poison, double %.1493.i.i, i64 0
  %.1532.i.i = shufflevector <8 x double> %.1531.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1533.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i112.i.i, <8 x double> %.1532.i.i, <8 x double> %.1530.i.i)
  %scevgep234.i.i = getelementptr i8, ptr %lsr.iv226.i.i, i64 -5120
  store <8 x double> %.1533.i.i, ptr %scevgep234.i.i, align 8, !noalias !77
  %.1664.i.i = load double, ptr %sunkaddr18.i.i, align 8, !noalias !77
  %.1694.i.i = load double, ptr %sunkaddr19.i.i, align 8, !noalias !77
  %.1723.i.i = load double, ptr %lsr.iv, align 8, !noalias !77
  %.1724.i.i = insertelement <8 x double> poison, double %.1723.i.i, i64 0
  %.1725.i.i = shufflevector <8 x double> %.1724.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1726.i.i = insertelement <8 x double> poison, double %.1694.i.i, i64 0
  %.1727.i.i = shufflevector <8 x double> %.1726.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1728.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.362.i.i, <8 x double> %.1727.i.i, <8 x double> %.1725.i.i)
  %.1729.i.i = insertelement <8 x double> poison, double %.1664.i.i, i64 0
  %.1730.i.i = shufflevector <8 x double> %.1729.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1731.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.373.i.i198, <8 x double> %.1730.i.i, <8 x double> %.1728.i.i)
  %.1761.i.i = load double, ptr %sunkaddr.i5.i, align 8, !noalias !77
  %.1791.i.i = load double, ptr %sunkaddr20.i.i, align 8, !noalias !77
  %.1795.i.i = insertelement <8 x double> poison, double %.1791.i.i, i64 0
  %.1796.i.i = shufflevector <8 x double> %.1795.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1797.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i112.i.i, <8 x double> %.1796.i.i, <8 x double> %.1731.i.i)
  %.1798.i.i = insertelement <8 x double> poison, double %.1761.i.i, i64 0
  %.1799.i.i = shufflevector <8 x double> %.1798.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1800.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i.i7.i, <8 x double> %.1799.i.i, <8 x double> %.1797.i.i)
  %scevgep233.i14.i = getelementptr i8, ptr %lsr.iv226.i.i, i64 -3072
  store <8 x double> %.1800.i.i, ptr %scevgep233.i14.i, align 8, !noalias !77
  %.1931.i.i = load double, ptr %sunkaddr21.i.i, align 8, !noalias !77
  %.1961.i.i211 = load double, ptr %sunkaddr22.i.i, align 8, !noalias !77
  %.1990.i.i = load double, ptr %sunkaddr23.i.i, align 8, !noalias !77
  %.1991.i.i = insertelement <8 x double> poison, double %.1990.i.i, i64 0
  %.1992.i.i = shufflevector <8 x double> %.1991.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1993.i.i = insertelement <8 x double> poison, double %.1961.i.i211, i64 0
  %.1994.i.i212 = shufflevector <8 x double> %.1993.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1995.i.i213 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.362.i.i, <8 x double> %.1994.i.i212, <8 x double> %.1992.i.i)
  %.1996.i.i = insertelement <8 x double> poison, double %.1931.i.i, i64 0
  %.1997.i.i = shufflevector <8 x double> %.1996.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1998.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.373.i.i198, <8 x double> %.1997.i.i, <8 x double> %.1995.i.i213)
  %.2028.i.i = load double, ptr %sunkaddr24.i.i, align 8, !noalias !77
  %.2058.i.i = load double, ptr %sunkaddr25.i.i, align 8, !noalias !77
  %.2062.i.i = insertelement <8 x double> poison, double %.2058.i.i, i64 0
  %.2063.i.i = shufflevector <8 x double> %.2062.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.2064.i.i214 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i112.i.i, <8 x double> %.2063.i.i, <8 x double> %.1998.i.i)
  %.2065.i.i = insertelement <8 x double> poison, double %.2028.i.i, i64 0
  %.2066.i.i = shufflevector <8 x double> %.2065.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.2067.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i.i7.i, <8 x double> %.2066.i.i, <8 x double> %.2064.i.i214)
  %scevgep232.i15.i = getelementptr i8, ptr %lsr.iv226.i.i, i64 -1024
  store <8 x double> %.2067.i.i, ptr %scevgep232.i15.i, align 8, !noalias !77
  %scevgep231.i.i = getelementptr i8, ptr %lsr.iv226.i.i, i64 -10240
  store <8 x double> zeroinitializer, ptr %scevgep231.i.i, align 8, !noalias !77
  %scevgep230.i.i = getelementptr i8, ptr %lsr.iv226.i.i, i64 -8192
  store <8 x double> zeroinitializer, ptr %scevgep230.i.i, align 8, !noalias !77
  %scevgep229.i.i = getelementptr i8, ptr %lsr.iv226.i.i, i64 -6144
  store <8 x double> zeroinitializer, ptr %scevgep229.i.i, align 8, !noalias !77
  %scevgep228.i.i = getelementptr i8, ptr %lsr.iv226.i.i, i64 -4096
  store <8 x double> zeroinitializer, ptr %scevgep228.i.i, align 8, !noalias !77
  %scevgep227.i.i = getelementptr i8, ptr %lsr.iv226.i.i, i64 -2048
  store <8 x double> zeroinitializer, ptr %scevgep227.i.i, align 8, !noalias !77
  store <8 x double> zeroinitializer, ptr %lsr.iv226.i.i, align 8, !noalias !77
  %scevgep.i16.i = getelementptr i8, ptr %lsr.iv226.i.i, i64 64
  %lsr.iv.next7.i.i = add nsw i64 %lsr.iv6.i.i, -1
  %.311.i.i = icmp sgt i64 %lsr.iv6.i.i, 5
  br i1 %.311.i.i, label %B158.if.i.i, label %B632.i

B632.i:                                           ; preds = %B158.if.i.i, %B444.i
  %.909.i = load double, ptr %sunkaddr47.i, align 8, !noalias !59
  %.1401.i.i = insertelement <8 x double> poison, double %.909.i, i64 0
  %.1402.i.i = shufflevector <8 x double> %.1401.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  br i1 %.93.inv.i.i, label %B632.endif.i, label %B52.lr.ph.i.i

B52.lr.ph.i.i:                                    ; preds = %B632.i
  %.939.i = load i64, ptr %sunkaddr48.i, align 8, !noalias !59
  %.879.i = load double, ptr %sunkaddr.i195, align 8, !noalias !59
  %.6.i980.i.i = insertelement <8 x double> poison, double %.879.i, i64 0
  %.7.i.i.i215 = shufflevector <8 x double> %.6.i980.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %351 = icmp eq i64 %.939.i, 1
  br label %B52.i.i

B52.i.i:                                          ; preds = %B1190.i.i, %B52.lr.ph.i.i
  %.127.sroa.0.0923.i.i = phi i64 [ 0, %B52.lr.ph.i.i ], [ %.127.sroa.0.0.i.i, %B1190.i.i ]
  %.82.1922.in.i.i = phi i64 [ %333, %B52.lr.ph.i.i ], [ %362, %B1190.i.i ]
  %.79.1921.i.i = phi i64 [ 8, %B52.lr.ph.i.i ], [ %.79.1.i.i, %B1190.i.i ]
  %.267.i.i216 = getelementptr inbounds double, ptr %.612.i, i64 %.127.sroa.0.0923.i.i
  %.269.i.i = load <8 x double>, ptr %.267.i.i216, align 8, !noalias !80
  %sunkaddr.i.i217 = shl i64 %.127.sroa.0.0923.i.i, 3
  %sunkaddr1161.i.i = getelementptr inbounds i8, ptr %.612.i, i64 %sunkaddr.i.i217
  %sunkaddr1162.i.i = getelementptr inbounds nuw i8, ptr %sunkaddr1161.i.i, i64 1024
  %.365.i.i218 = load <8 x double>, ptr %sunkaddr1162.i.i, align 8, !noalias !80
  %sunkaddr1165.i.i = getelementptr inbounds nuw i8, ptr %sunkaddr1161.i.i, i64 2048
  %.460.i.i219 = load <8 x double>, ptr %sunkaddr1165.i.i, align 8, !noalias !80
  %sunkaddr1168.i.i = getelementptr inbounds nuw i8, ptr %sunkaddr1161.i.i, i64 3072
  %.556.i.i220 = load <8 x double>, ptr %sunkaddr1168.i.i, align 8, !noalias !80
  %sunkaddr1171.i.i = getelementptr inbounds nuw i8, ptr %sunkaddr1161.i.i, i64 10240
  %.652.i.i221 = load <8 x double>, ptr %sunkaddr1171.i.i, align 8, !noalias !80
  %sunkaddr1174.i.i = getelementptr inbounds nuw i8, ptr %sunkaddr1161.i.i, i64 11264
  %.748.i.i = load <8 x double>, ptr %sunkaddr1174.i.i, align 8, !noalias !80
  %352 = fneg contract <8 x double> %.365.i.i218
  %.8.i.i.i222 = fmul contract <8 x double> %.748.i.i, %352
  %.800.i.i223 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.652.i.i221, <8 x double> %.269.i.i, <8 x double> %.8.i.i.i222)
  %.6.i960.i.i = fmul contract <8 x double> %.269.i.i, %.748.i.i
  %.825.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.652.i.i221, <8 x double> %.365.i.i218, <8 x double> %.6.i960.i.i)
  %sunkaddr1177.i.i = getelementptr inbounds nuw i8, ptr %sunkaddr1161.i.i, i64 12288
  %.945.i.i = load <8 x double>, ptr %sunkaddr1177.i.i, align 8, !noalias !80
  %sunkaddr1180.i.i = getelementptr inbounds nuw i8, ptr %sunkaddr1161.i.i, i64 13312
  %.1041.i.i = load <8 x double>, ptr %sunkaddr1180.i.i, align 8, !noalias !80
  %353 = fneg contract <8 x double> %.556.i.i220
  %.8.i972.i.i = fmul contract <8 x double> %.1041.i.i, %353
  %.1093.i.i224 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.945.i.i, <8 x double> %.460.i.i219, <8 x double> %.8.i972.i.i)
  %.6.i973.i.i = fmul contract <8 x double> %.460.i.i219, %.1041.i.i
  %.1118.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.945.i.i, <8 x double> %.556.i.i220, <8 x double> %.6.i973.i.i)
  br i1 %351, label %B864.i.i, label %B1190.i.i

B864.i.i:                                         ; preds = %B52.i.i
  %sunkaddr53.i = getelementptr i8, ptr %sunkaddr1161.i.i, i64 4096
  %.1249.i.i = load <8 x double>, ptr %sunkaddr53.i, align 8, !noalias !80
  %sunkaddr57.i = getelementptr i8, ptr %sunkaddr1161.i.i, i64 5120
  %.1345.i.i292 = load <8 x double>, ptr %sunkaddr57.i, align 8, !noalias !80
  %.6.i979.i.i = fsub contract <8 x double> splat (double 1.000000e+00), %.1249.i.i
  %.8.i981.i.i = fmul contract <8 x double> %.7.i.i.i215, %.6.i979.i.i
  %.1413.i.i293 = getelementptr inbounds double, ptr %.311.i, i64 %.127.sroa.0.0923.i.i
  %.1415.i.i = load <8 x double>, ptr %.1413.i.i293, align 8, !noalias !80
  %.8.i982.i.i = fmul contract <8 x double> %.1415.i.i, splat (double 0xC01921FB54442D18)
  %.1403.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1345.i.i292, <8 x double> %.1402.i.i, <8 x double> %.8.i981.i.i)
  %.6.i983.i.i = fmul contract <8 x double> %.1403.i.i, %.8.i982.i.i
  %.1469.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i983.i.i, <8 x double> splat (double 0x3FE45F306DC9C883), <8 x double> splat (double 0x4338000000000000))
  %.8.i984.i.i = fadd contract <8 x double> %.1469.i.i, splat (double 0xC338000000000000)
  %.1510.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i984.i.i, <8 x double> splat (double 0xBFF921FB54442D18), <8 x double> %.6.i983.i.i)
  %.1527.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i984.i.i, <8 x double> splat (double 0xBC91A62633145C07), <8 x double> %.1510.i.i)
  %.6.i985.i.i = fmul contract <8 x double> %.1527.i.i, %.1527.i.i
  %.6.i986.i.i = fmul contract <8 x double> %.1527.i.i, %.6.i985.i.i
  %.1556.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i985.i.i, <8 x double> splat (double 0xBD6AE7F3E733B81F), <8 x double> splat (double 0x3DE6124613A86D09))
  %.1559.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i985.i.i, <8 x double> %.1556.i.i, <8 x double> splat (double 0xBE5AE64567F544E4))
  %.1562.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i985.i.i, <8 x double> %.1559.i.i, <8 x double> splat (double 0x3EC71DE3A556C734))
  %.1565.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i985.i.i, <8 x double> %.1562.i.i, <8 x double> splat (double 0xBF2A01A01A01A01A))
  %.1568.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i985.i.i, <8 x double> %.1565.i.i, <8 x double> splat (double 0x3F81111111111111))
  %.1571.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i985.i.i, <8 x double> %.1568.i.i, <8 x double> splat (double 0xBFC5555555555555))
  %.1596.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i986.i.i, <8 x double> %.1571.i.i, <8 x double> %.1527.i.i)
  %.1601.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i985.i.i, <8 x double> splat (double 0x3D2AE7F3E733B81F), <8 x double> splat (double 0xBDA93974A8C07C9D))
  %.1604.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i985.i.i, <8 x double> %.1601.i.i, <8 x double> splat (double 0x3E21EED8EFF8D898))
  %.1607.i.i294 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i985.i.i, <8 x double> %.1604.i.i, <8 x double> splat (double 0xBE927E4FB7789F5C))
  %.1610.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i985.i.i, <8 x double> %.1607.i.i294, <8 x double> splat (double 0x3EFA01A01A01A01A))
  %.1613.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i985.i.i, <8 x double> %.1610.i.i, <8 x double> splat (double 0xBF56C16C16C16C17))
  %.1616.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i985.i.i, <8 x double> %.1613.i.i, <8 x double> splat (double 0x3FA5555555555555))
  %.1619.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i985.i.i, <8 x double> %.1616.i.i, <8 x double> splat (double -5.000000e-01))
  %.1622.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i985.i.i, <8 x double> %.1619.i.i, <8 x double> splat (double 1.000000e+00))
  %.1623.i.i = bitcast <8 x double> %.1469.i.i to <8 x i64>
  %.1624.i.i = bitcast <8 x double> %.1596.i.i to <8 x i64>
  %.1625.i.i = bitcast <8 x double> %.1622.i.i to <8 x i64>
  %.6.i987.i.i = xor <8 x i64> %.1625.i.i, %.1624.i.i
  %.8.i988.i.i = and <8 x i64> %.1623.i.i, splat (i64 1)
  %354 = icmp eq <8 x i64> %.8.i988.i.i, zeroinitializer
  %.6.i990.i.i = select <8 x i1> %354, <8 x i64> zeroinitializer, <8 x i64> %.6.i987.i.i
  %.8.i991.i.i = shl <8 x i64> %.1623.i.i, splat (i64 62)
  %.8.i992.i.i = and <8 x i64> %.8.i991.i.i, splat (i64 -9223372036854775808)
  %.8.i994.i.i = add <8 x i64> %.8.i991.i.i, splat (i64 4611686018427387904)
  %.8.i995.i.i = and <8 x i64> %.8.i994.i.i, splat (i64 -9223372036854775808)
  %355 = xor <8 x i64> %.8.i992.i.i, %.1624.i.i
  %.6.i997.i.i = xor <8 x i64> %355, %.6.i990.i.i
  %356 = bitcast <8 x i64> %.6.i997.i.i to <8 x double>
  %357 = xor <8 x i64> %.8.i995.i.i, %.1625.i.i
  %.6.i999.i.i = xor <8 x i64> %357, %.6.i990.i.i
  %358 = bitcast <8 x i64> %.6.i999.i.i to <8 x double>
  br label %B1190.i.i

B1190.i.i:                                        ; preds = %B864.i.i, %B52.i.i
  %sine.2.1.i.i = phi <8 x double> [ %356, %B864.i.i ], [ zeroinitializer, %B52.i.i ]
  %cosine.2.1.i.i = phi <8 x double> [ %358, %B864.i.i ], [ splat (double 1.000000e+00), %B52.i.i ]
  %sunkaddr63.i225 = getelementptr i8, ptr %sunkaddr1161.i.i, i64 8192
  store <8 x double> %cosine.2.1.i.i, ptr %sunkaddr63.i225, align 8, !noalias !80
  %sunkaddr69.i226 = getelementptr i8, ptr %sunkaddr1161.i.i, i64 9216
  store <8 x double> %sine.2.1.i.i, ptr %sunkaddr69.i226, align 8, !noalias !80
  %.6.i1005.i.i = fadd contract <8 x double> %.800.i.i223, %.1093.i.i224
  %.6.i1006.i.i = fadd contract <8 x double> %.825.i.i, %.1118.i.i
  %359 = fneg contract <8 x double> %sine.2.1.i.i
  %.8.i1008.i.i = fmul contract <8 x double> %.6.i1006.i.i, %359
  %.2273.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i1005.i.i, <8 x double> %cosine.2.1.i.i, <8 x double> %.8.i1008.i.i)
  %.6.i1009.i.i = fmul contract <8 x double> %.6.i1006.i.i, %cosine.2.1.i.i
  %.2298.i.i227 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i1005.i.i, <8 x double> %sine.2.1.i.i, <8 x double> %.6.i1009.i.i)
  %.2408.i.i = getelementptr inbounds double, ptr %.430, i64 %.127.sroa.0.0923.i.i
  %.2410.i.i228 = load <8 x double>, ptr %.2408.i.i, align 8, !noalias !80
  %sunkaddr71.i = getelementptr i8, ptr %.430, i64 %sunkaddr.i.i217
  %sunkaddr72.i229 = getelementptr i8, ptr %sunkaddr71.i, i64 1024
  %.2506.i.i = load <8 x double>, ptr %sunkaddr72.i229, align 8, !noalias !80
  %360 = fneg contract <8 x double> %.2506.i.i
  %.8.i1021.i.i = fmul contract <8 x double> %.2298.i.i227, %360
  %.2559.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.2273.i.i, <8 x double> %.2410.i.i228, <8 x double> %.8.i1021.i.i)
  %.6.i1022.i.i = fmul contract <8 x double> %.2298.i.i227, %.2410.i.i228
  %.2584.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.2273.i.i, <8 x double> %.2506.i.i, <8 x double> %.6.i1022.i.i)
  %sunkaddr75.i = getelementptr i8, ptr %sunkaddr1161.i.i, i64 6144
  store <8 x double> %.2559.i.i, ptr %sunkaddr75.i, align 8, !noalias !80
  %sunkaddr78.i = getelementptr i8, ptr %sunkaddr1161.i.i, i64 7168
  store <8 x double> %.2584.i.i, ptr %sunkaddr78.i, align 8, !noalias !80
  %.137.i.i = icmp samesign ugt i64 %.82.1922.in.i.i, 1
  %.150.i.i230 = add i64 %.79.1921.i.i, 8
  %.79.1.i.i = select i1 %.137.i.i, i64 %.150.i.i230, i64 %.79.1921.i.i
  %361 = tail call i64 @llvm.smax.i64(i64 %.82.1922.in.i.i, i64 2)
  %362 = add nsw i64 %361, -1
  %.127.sroa.0.0.i.i = select i1 %.137.i.i, i64 %.79.1921.i.i, i64 0
  br i1 %.137.i.i, label %B52.i.i, label %B632.endif.i

B802.if.lr.ph.i:                                  ; preds = %B632.endif.i
  %.1298.i = icmp slt i64 %.134.i, 1
  %or.cond.i232 = or i1 %.93.inv.i.i, %.1298.i
  %.5541.i.i = getelementptr i8, ptr %lsr.iv, i64 120
  %.5861.i.i = getelementptr i8, ptr %lsr.iv, i64 128
  %.6181.i.i = getelementptr i8, ptr %lsr.iv, i64 136
  %.6501.i.i = getelementptr i8, ptr %lsr.iv, i64 144
  %sunkaddr37.i.i = getelementptr i8, ptr %lsr.iv, i64 88
  %sunkaddr38.i.i = getelementptr i8, ptr %lsr.iv, i64 96
  br label %B802.if.i

B268.if.i.i:                                      ; preds = %_ZN17bnserve_inference14adjoint_kernel7_source14_through_pairsB4v343B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i, %B268.if.i.i
  %lsr.iv44.i = phi i64 [ %lsr.iv.next45.i, %B268.if.i.i ], [ %334, %_ZN17bnserve_inference14adjoint_kernel7_source14_through_pairsB4v343B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i ]
  %lsr.iv145.i = phi ptr [ %scevgep.i277, %B268.if.i.i ], [ %.430, %_ZN17bnserve_inference14adjoint_kernel7_source14_through_pairsB4v343B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i ]
  %scevgep154.i = getelementptr i8, ptr %lsr.iv145.i, i64 6144
  %.608.i.i = load <8 x double>, ptr %scevgep154.i, align 8, !noalias !83
  %scevgep153.i = getelementptr i8, ptr %lsr.iv145.i, i64 7168
  %.703.i.i271 = load <8 x double>, ptr %scevgep153.i, align 8, !noalias !83
  %scevgep147.i272 = getelementptr i8, ptr %lsr.iv145.i, i64 %lsr.iv.i240
  %scevgep148.i = getelementptr i8, ptr %scevgep147.i272, i64 -1024
  %.797.i.i273 = load <8 x double>, ptr %scevgep148.i, align 8, !noalias !83
  %.892.i.i274 = load <8 x double>, ptr %scevgep147.i272, align 8, !noalias !83
  %363 = fneg contract <8 x double> %.892.i.i274
  %.8.i.i30.i = fmul contract <8 x double> %.703.i.i271, %363
  %.945.i31.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.608.i.i, <8 x double> %.797.i.i273, <8 x double> %.8.i.i30.i)
  %.6.i127.i.i = fmul contract <8 x double> %.703.i.i271, %.797.i.i273
  %.970.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.608.i.i, <8 x double> %.892.i.i274, <8 x double> %.6.i127.i.i)
  %scevgep152.i = getelementptr i8, ptr %lsr.iv145.i, i64 4096
  %.1000.i.i275 = load <8 x double>, ptr %scevgep152.i, align 8, !noalias !83
  %scevgep151.i = getelementptr i8, ptr %lsr.iv145.i, i64 2048
  %.1010.i.i = load <8 x double>, ptr %scevgep151.i, align 8, !noalias !83
  %.8.i128.i.i = fadd contract <8 x double> %.1010.i.i, splat (double 1.000000e+00)
  %.6.i129.i.i = fdiv contract <8 x double> %.945.i31.i, %.8.i128.i.i
  %.6.i130.i.i = fadd contract <8 x double> %.1000.i.i275, %.6.i129.i.i
  store <8 x double> %.6.i130.i.i, ptr %scevgep152.i, align 8, !noalias !83
  %scevgep150.i = getelementptr i8, ptr %lsr.iv145.i, i64 3072
  %.1102.i.i = load <8 x double>, ptr %scevgep150.i, align 8, !noalias !83
  %scevgep149.i = getelementptr i8, ptr %lsr.iv145.i, i64 5120
  %.1112.i.i276 = load <8 x double>, ptr %scevgep149.i, align 8, !noalias !83
  %.8.i131.i.i = fmul contract <8 x double> %.970.i.i, splat (double 4.000000e+00)
  %.1139.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1102.i.i, <8 x double> %.1102.i.i, <8 x double> splat (double 4.000000e+00))
  %.6.i132.i.i = fdiv contract <8 x double> %.8.i131.i.i, %.1139.i.i
  %.6.i133.i.i = fsub contract <8 x double> %.1112.i.i276, %.6.i132.i.i
  store <8 x double> %.6.i133.i.i, ptr %scevgep149.i, align 8, !noalias !83
  %scevgep.i277 = getelementptr i8, ptr %lsr.iv145.i, i64 64
  %lsr.iv.next45.i = add nsw i64 %lsr.iv44.i, -1
  %.480.i.i = icmp sgt i64 %lsr.iv44.i, 5
  br i1 %.480.i.i, label %B268.if.i.i, label %B1008.i

B1008.i:                                          ; preds = %B268.if.i.i, %_ZN17bnserve_inference14adjoint_kernel7_source14_through_pairsB4v343B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i
  br i1 %.93.inv.i.i, label %_ZN17bnserve_inference14adjoint_kernel5_back9pull_backB4v386B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i, label %B250.lr.ph.i.i

B250.lr.ph.i.i:                                   ; preds = %B1008.i
  %.144.i.i = load double, ptr %sunkaddr47.i, align 8, !noalias !86
  %.115.i.i = load double, ptr %sunkaddr.i195, align 8, !noalias !86
  %.6.i4376.i.i = insertelement <8 x double> poison, double %.115.i.i, i64 0
  %.7.i.i18.i = shufflevector <8 x double> %.6.i4376.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.6.i4378.i.i = insertelement <8 x double> poison, double %.144.i.i, i64 0
  %.7.i4379.i.i = shufflevector <8 x double> %.6.i4378.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  br label %B250.i.i

B250.i.i:                                         ; preds = %B5991.i.i, %B250.lr.ph.i.i
  %.269.sroa.0.04226.i.i = phi i64 [ 0, %B250.lr.ph.i.i ], [ %.269.sroa.0.0.i.i, %B5991.i.i ]
  %.224.14225.in.i.i = phi i64 [ %333, %B250.lr.ph.i.i ], [ %369, %B5991.i.i ]
  %.221.14224.i.i = phi i64 [ 8, %B250.lr.ph.i.i ], [ %.221.1.i.i, %B5991.i.i ]
  %by_time.2.04223.i.i = phi <8 x double> [ zeroinitializer, %B250.lr.ph.i.i ], [ %.6.i4263.i.i, %B5991.i.i ]
  %by_polarization.2.04222.i.i = phi <8 x double> [ zeroinitializer, %B250.lr.ph.i.i ], [ %.6.i4464.i.i, %B5991.i.i ]
  %by_declination.2.04221.i.i = phi <8 x double> [ zeroinitializer, %B250.lr.ph.i.i ], [ %.6.i4435.i.i, %B5991.i.i ]
  %by_hour.2.04220.i.i = phi <8 x double> [ zeroinitializer, %B250.lr.ph.i.i ], [ %.6.i4382.i.i, %B5991.i.i ]
  %sunkaddr.i19.i = shl i64 %.269.sroa.0.04226.i.i, 3
  %sunkaddr4737.i.i = getelementptr inbounds i8, ptr %.430, i64 %sunkaddr.i19.i
  %sunkaddr4738.i.i = getelementptr inbounds nuw i8, ptr %sunkaddr4737.i.i, i64 6144
  %.411.i.i = load <8 x double>, ptr %sunkaddr4738.i.i, align 8, !noalias !86
  %sunkaddr4741.i.i = getelementptr inbounds nuw i8, ptr %sunkaddr4737.i.i, i64 7168
  %.507.i.i = load <8 x double>, ptr %sunkaddr4741.i.i, align 8, !noalias !86
  %sunkaddr4743.i.i = getelementptr inbounds i8, ptr %.1126.i, i64 %sunkaddr.i19.i
  %sunkaddr4744.i.i = getelementptr inbounds nuw i8, ptr %sunkaddr4743.i.i, i64 6144
  %.602.i.i278 = load <8 x double>, ptr %sunkaddr4744.i.i, align 8, !noalias !86
  %sunkaddr4747.i.i = getelementptr inbounds nuw i8, ptr %sunkaddr4743.i.i, i64 7168
  %.698.i.i = load <8 x double>, ptr %sunkaddr4747.i.i, align 8, !noalias !86
  %sunkaddr4750.i.i = getelementptr inbounds nuw i8, ptr %sunkaddr4737.i.i, i64 8192
  %.793.i.i279 = load <8 x double>, ptr %sunkaddr4750.i.i, align 8, !noalias !86
  %sunkaddr4753.i.i = getelementptr inbounds nuw i8, ptr %sunkaddr4737.i.i, i64 9216
  %.889.i.i280 = load <8 x double>, ptr %sunkaddr4753.i.i, align 8, !noalias !86
  %.1028.i.i281 = getelementptr inbounds double, ptr %.311.i, i64 %.269.sroa.0.04226.i.i
  %.1030.i.i = load <8 x double>, ptr %.1028.i.i281, align 8, !noalias !86
  %sunkaddr4756.i.i = getelementptr inbounds nuw i8, ptr %sunkaddr4743.i.i, i64 4096
  %.1173.i.i = load <8 x double>, ptr %sunkaddr4756.i.i, align 8, !noalias !86
  %sunkaddr4759.i.i = getelementptr inbounds nuw i8, ptr %sunkaddr4743.i.i, i64 5120
  %.1269.i20.i = load <8 x double>, ptr %sunkaddr4759.i.i, align 8, !noalias !86
  %.1368.i.i = getelementptr inbounds double, ptr %.430, i64 %.269.sroa.0.04226.i.i
  %.1370.i.i = load <8 x double>, ptr %.1368.i.i, align 8, !noalias !86
  %sunkaddr4762.i.i = getelementptr inbounds nuw i8, ptr %sunkaddr4737.i.i, i64 1024
  %.1466.i.i = load <8 x double>, ptr %sunkaddr4762.i.i, align 8, !noalias !86
  %364 = fneg contract <8 x double> %.1466.i.i
  %.8.i4287.i.i = fmul contract <8 x double> %.507.i.i, %364
  %.1519.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.411.i.i, <8 x double> %.1370.i.i, <8 x double> %.8.i4287.i.i)
  %.6.i4288.i.i = fmul contract <8 x double> %.507.i.i, %.1370.i.i
  %.1544.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.411.i.i, <8 x double> %.1466.i.i, <8 x double> %.6.i4288.i.i)
  %sunkaddr4765.i.i = getelementptr inbounds nuw i8, ptr %sunkaddr4743.i.i, i64 8192
  %.1657.i.i = load <8 x double>, ptr %sunkaddr4765.i.i, align 8, !noalias !86
  %sunkaddr4768.i.i = getelementptr inbounds nuw i8, ptr %sunkaddr4743.i.i, i64 9216
  %.1753.i.i = load <8 x double>, ptr %sunkaddr4768.i.i, align 8, !noalias !86
  %365 = fneg contract <8 x double> %.1753.i.i
  %.8.i4300.i.i = fmul contract <8 x double> %.1544.i.i, %365
  %.1805.i.i282 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1519.i.i, <8 x double> %.1657.i.i, <8 x double> %.8.i4300.i.i)
  %.6.i4301.i.i = fmul contract <8 x double> %.1544.i.i, %.1657.i.i
  %.1830.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1519.i.i, <8 x double> %.1753.i.i, <8 x double> %.6.i4301.i.i)
  br label %B2058.if.i.i

B5991.i.i:                                        ; preds = %B2058.if.i.i
  %.6.i.i21.i = fmul contract <8 x double> %.602.i.i278, %.793.i.i279
  %.6.i4261.i.i = fmul contract <8 x double> %.698.i.i, %.889.i.i280
  %.6.i4262.i.i = fsub contract <8 x double> %.6.i.i21.i, %.6.i4261.i.i
  %.6.i4263.i.i = fadd contract <8 x double> %by_time.2.04223.i.i, %.6.i4262.i.i
  %.6.i4264.i.i = fmul contract <8 x double> %.507.i.i, %.602.i.i278
  %.8.i.i22.i = fmul contract <8 x double> %.1030.i.i, splat (double 0x401921FB54442D18)
  %.1019.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.411.i.i, <8 x double> %.698.i.i, <8 x double> %.6.i4264.i.i)
  %.6.i4265.i.i = fmul contract <8 x double> %.1019.i.i, %.8.i.i22.i
  %.2648.i.i = getelementptr inbounds double, ptr %.1126.i, i64 %.269.sroa.0.04226.i.i
  %.2650.i.i = load <8 x double>, ptr %.2648.i.i, align 8, !noalias !86
  %sunkaddr3.i.i = getelementptr i8, ptr %sunkaddr4743.i.i, i64 1024
  %.2746.i.i = load <8 x double>, ptr %sunkaddr3.i.i, align 8, !noalias !86
  %366 = fneg contract <8 x double> %.2746.i.i
  %.8.i4333.i.i = fmul contract <8 x double> %.1830.i.i, %366
  %.2800.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1805.i.i282, <8 x double> %.2650.i.i, <8 x double> %.8.i4333.i.i)
  %.6.i4334.i.i = fmul contract <8 x double> %.1830.i.i, %.2650.i.i
  %.2825.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1805.i.i282, <8 x double> %.2746.i.i, <8 x double> %.6.i4334.i.i)
  %sunkaddr6.i.i = getelementptr i8, ptr %sunkaddr4743.i.i, i64 2048
  %.2938.i.i = load <8 x double>, ptr %sunkaddr6.i.i, align 8, !noalias !86
  %sunkaddr9.i23.i = getelementptr i8, ptr %sunkaddr4743.i.i, i64 3072
  %.3039.i.i = load <8 x double>, ptr %sunkaddr9.i23.i, align 8, !noalias !86
  %367 = fneg contract <8 x double> %.3039.i.i
  %.8.i4346.i.i = fmul contract <8 x double> %.1830.i.i, %367
  %.3099.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1805.i.i282, <8 x double> %.2938.i.i, <8 x double> %.8.i4346.i.i)
  %.6.i4347.i.i = fmul contract <8 x double> %.1830.i.i, %.2938.i.i
  %.3124.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1805.i.i282, <8 x double> %.3039.i.i, <8 x double> %.6.i4347.i.i)
  %sunkaddr12.i24.i = getelementptr i8, ptr %sunkaddr4743.i.i, i64 14336
  %.3282.i.i = load <8 x double>, ptr %sunkaddr12.i24.i, align 8, !noalias !86
  %.6.i4353.i.i = fmul contract <8 x double> %.2800.i.i, %.3282.i.i
  %sunkaddr15.i25.i = getelementptr i8, ptr %sunkaddr4743.i.i, i64 15360
  %.3400.i.i = load <8 x double>, ptr %sunkaddr15.i25.i, align 8, !noalias !86
  %.6.i4359.i.i = fmul contract <8 x double> %.2825.i.i, %.3400.i.i
  %.6.i4360.i.i = fsub contract <8 x double> %.6.i4353.i.i, %.6.i4359.i.i
  %sunkaddr18.i26.i = getelementptr i8, ptr %sunkaddr4743.i.i, i64 16384
  %.3542.i.i = load <8 x double>, ptr %sunkaddr18.i26.i, align 8, !noalias !86
  %.6.i4366.i.i = fmul contract <8 x double> %.3099.i.i, %.3542.i.i
  %sunkaddr21.i27.i = getelementptr i8, ptr %sunkaddr4743.i.i, i64 17408
  %.3663.i.i = load <8 x double>, ptr %sunkaddr21.i27.i, align 8, !noalias !86
  %.6.i4372.i.i = fmul contract <8 x double> %.3124.i.i, %.3663.i.i
  %.6.i4373.i.i = fsub contract <8 x double> %.6.i4366.i.i, %.6.i4372.i.i
  %.6.i4374.i.i = fadd contract <8 x double> %.6.i4360.i.i, %.6.i4373.i.i
  %.6.i4375.i.i = fsub contract <8 x double> splat (double 1.000000e+00), %.1173.i.i
  %.8.i4377.i.i = fmul contract <8 x double> %.7.i.i18.i, %.1269.i20.i
  %.8.i4380.i.i = fmul contract <8 x double> %.7.i4379.i.i, %.6.i4375.i.i
  %.6.i4381.i.i = fsub contract <8 x double> %.8.i4377.i.i, %.8.i4380.i.i
  %.3842.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i4265.i.i, <8 x double> %.6.i4381.i.i, <8 x double> %.6.i4374.i.i)
  %.6.i4382.i.i = fadd contract <8 x double> %by_hour.2.04220.i.i, %.3842.i.i
  %sunkaddr24.i28.i = getelementptr i8, ptr %sunkaddr4743.i.i, i64 26624
  %.3961.i.i = load <8 x double>, ptr %sunkaddr24.i28.i, align 8, !noalias !86
  %.8.i4398.i.i = fmul contract <8 x double> %.7.i4379.i.i, %.1173.i.i
  %.6.i4399.i.i = fadd contract <8 x double> %.8.i4398.i.i, %.8.i4377.i.i
  %.4126.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i4265.i.i, <8 x double> %.6.i4399.i.i, <8 x double> %.6.i4374.i.i)
  %.6.i4400.i.i = fadd contract <8 x double> %.3961.i.i, %.4126.i.i
  store <8 x double> %.6.i4400.i.i, ptr %sunkaddr24.i28.i, align 8, !noalias !86
  %sunkaddr27.i.i = getelementptr i8, ptr %sunkaddr4743.i.i, i64 18432
  %.4261.i.i = load <8 x double>, ptr %sunkaddr27.i.i, align 8, !noalias !86
  %.6.i4406.i.i = fmul contract <8 x double> %.2800.i.i, %.4261.i.i
  %sunkaddr30.i.i = getelementptr i8, ptr %sunkaddr4743.i.i, i64 19456
  %.4379.i.i = load <8 x double>, ptr %sunkaddr30.i.i, align 8, !noalias !86
  %.6.i4412.i.i = fmul contract <8 x double> %.2825.i.i, %.4379.i.i
  %.6.i4413.i.i = fsub contract <8 x double> %.6.i4406.i.i, %.6.i4412.i.i
  %sunkaddr33.i.i = getelementptr i8, ptr %sunkaddr4743.i.i, i64 20480
  %.4521.i.i = load <8 x double>, ptr %sunkaddr33.i.i, align 8, !noalias !86
  %.6.i4419.i.i = fmul contract <8 x double> %.3099.i.i, %.4521.i.i
  %sunkaddr36.i.i = getelementptr i8, ptr %sunkaddr4743.i.i, i64 21504
  %.4642.i.i = load <8 x double>, ptr %sunkaddr36.i.i, align 8, !noalias !86
  %.6.i4425.i.i = fmul contract <8 x double> %.3124.i.i, %.4642.i.i
  %.6.i4426.i.i = fsub contract <8 x double> %.6.i4419.i.i, %.6.i4425.i.i
  %.6.i4427.i.i = fadd contract <8 x double> %.6.i4413.i.i, %.6.i4426.i.i
  %.4747.i.i = load double, ptr %sunkaddr37.i.i, align 8, !noalias !86
  %.6.i4428.i.i = insertelement <8 x double> poison, double %.4747.i.i, i64 0
  %.7.i4429.i.i = shufflevector <8 x double> %.6.i4428.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.8.i4430.i.i = fmul contract <8 x double> %.6.i4375.i.i, %.7.i4429.i.i
  %.4801.i.i = load double, ptr %sunkaddr38.i.i, align 8, !noalias !86
  %.6.i4431.i.i = insertelement <8 x double> poison, double %.4801.i.i, i64 0
  %.7.i4432.i.i = shufflevector <8 x double> %.6.i4431.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.8.i4433.i.i = fmul contract <8 x double> %.1269.i20.i, %.7.i4432.i.i
  %.6.i4434.i.i = fadd contract <8 x double> %.8.i4430.i.i, %.8.i4433.i.i
  %.4854.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i4265.i.i, <8 x double> %.6.i4434.i.i, <8 x double> %.6.i4427.i.i)
  %.6.i4435.i.i = fadd contract <8 x double> %by_declination.2.04221.i.i, %.4854.i.i
  %sunkaddr41.i.i = getelementptr i8, ptr %sunkaddr4743.i.i, i64 12288
  %.4982.i.i = load <8 x double>, ptr %sunkaddr41.i.i, align 8, !noalias !86
  %.6.i4441.i.i = fmul contract <8 x double> %.2800.i.i, %.4982.i.i
  %sunkaddr44.i.i = getelementptr i8, ptr %sunkaddr4743.i.i, i64 13312
  %.5100.i.i = load <8 x double>, ptr %sunkaddr44.i.i, align 8, !noalias !86
  %.6.i4447.i.i = fmul contract <8 x double> %.2825.i.i, %.5100.i.i
  %.6.i4448.i.i = fsub contract <8 x double> %.6.i4441.i.i, %.6.i4447.i.i
  %sunkaddr47.i.i287 = getelementptr i8, ptr %sunkaddr4743.i.i, i64 10240
  %.5241.i.i = load <8 x double>, ptr %sunkaddr47.i.i287, align 8, !noalias !86
  %.6.i4454.i.i = fmul contract <8 x double> %.3099.i.i, %.5241.i.i
  %sunkaddr50.i.i = getelementptr i8, ptr %sunkaddr4743.i.i, i64 11264
  %.5362.i.i = load <8 x double>, ptr %sunkaddr50.i.i, align 8, !noalias !86
  %.6.i4460.i.i = fmul contract <8 x double> %.3124.i.i, %.5362.i.i
  %.6.i4461.i.i = fsub contract <8 x double> %.6.i4454.i.i, %.6.i4460.i.i
  %.6.i4462.i.i = fsub contract <8 x double> %.6.i4448.i.i, %.6.i4461.i.i
  %.8.i4463.i.i = fmul contract <8 x double> %.6.i4462.i.i, splat (double 2.000000e+00)
  %.6.i4464.i.i = fadd contract <8 x double> %by_polarization.2.04222.i.i, %.8.i4463.i.i
  %.279.i.i = icmp samesign ugt i64 %.224.14225.in.i.i, 1
  %.292.i.i = add i64 %.221.14224.i.i, 8
  %.221.1.i.i = select i1 %.279.i.i, i64 %.292.i.i, i64 %.221.14224.i.i
  %368 = tail call i64 @llvm.smax.i64(i64 %.224.14225.in.i.i, i64 2)
  %369 = add nsw i64 %368, -1
  %.269.sroa.0.0.i.i = select i1 %.279.i.i, i64 %.221.14224.i.i, i64 0
  br i1 %.279.i.i, label %B250.i.i, label %_ZN17bnserve_inference14adjoint_kernel5_back9pull_backB4v386B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i

B2058.if.i.i:                                     ; preds = %B2058.if.i.i, %B250.i.i
  %exitcond.not.i.i283 = phi i1 [ true, %B2058.if.i.i ], [ false, %B250.i.i ]
  %.195769656975.i.i = phi i64 [ 2048, %B2058.if.i.i ], [ 0, %B250.i.i ]
  %370 = getelementptr i8, ptr %.1126.i, i64 %.195769656975.i.i
  %.2011.i.i = getelementptr i8, ptr %370, i64 10240
  %.2081.i.i = getelementptr inbounds double, ptr %.2011.i.i, i64 %.269.sroa.0.04226.i.i
  %.2083.i.i = load <8 x double>, ptr %.2081.i.i, align 8, !noalias !86
  %.2107.i.i = getelementptr i8, ptr %370, i64 11264
  %.2177.i.i = getelementptr inbounds double, ptr %.2107.i.i, i64 %.269.sroa.0.04226.i.i
  %.2179.i.i = load <8 x double>, ptr %.2177.i.i, align 8, !noalias !86
  %371 = fneg contract <8 x double> %.2179.i.i
  %.8.i4313.i.i = fmul contract <8 x double> %.1830.i.i, %371
  %.2233.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1805.i.i282, <8 x double> %.2083.i.i, <8 x double> %.8.i4313.i.i)
  %.6.i4314.i.i = fmul contract <8 x double> %.1830.i.i, %.2083.i.i
  %.2258.i.i284 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1805.i.i282, <8 x double> %.2179.i.i, <8 x double> %.6.i4314.i.i)
  %.2300.i.i285 = getelementptr i8, ptr %370, i64 22528
  %.2385.i.i = getelementptr i8, ptr %370, i64 23552
  %.2461.i.i = getelementptr inbounds double, ptr %.2300.i.i285, i64 %.269.sroa.0.04226.i.i
  %.2463.i.i = load <8 x double>, ptr %.2461.i.i, align 8, !noalias !86
  %.6.i4325.i.i = fadd contract <8 x double> %.2463.i.i, %.2233.i.i
  store <8 x double> %.6.i4325.i.i, ptr %.2461.i.i, align 8, !noalias !86
  %.2508.i.i = getelementptr inbounds double, ptr %.2385.i.i, i64 %.269.sroa.0.04226.i.i
  %.2510.i.i286 = load <8 x double>, ptr %.2508.i.i, align 8, !noalias !86
  %.6.i4326.i.i = fadd contract <8 x double> %.2258.i.i284, %.2510.i.i286
  store <8 x double> %.6.i4326.i.i, ptr %.2508.i.i, align 8, !noalias !86
  br i1 %exitcond.not.i.i283, label %B5991.i.i, label %B2058.if.i.i

_ZN17bnserve_inference14adjoint_kernel5_back9pull_backB4v386B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i: ; preds = %B5991.i.i, %B1008.i
  %by_hour.2.0.lcssa.i.i = phi <8 x double> [ zeroinitializer, %B1008.i ], [ %.6.i4382.i.i, %B5991.i.i ]
  %by_declination.2.0.lcssa.i.i = phi <8 x double> [ zeroinitializer, %B1008.i ], [ %.6.i4435.i.i, %B5991.i.i ]
  %by_polarization.2.0.lcssa.i.i = phi <8 x double> [ zeroinitializer, %B1008.i ], [ %.6.i4464.i.i, %B5991.i.i ]
  %by_time.2.0.lcssa.i.i = phi <8 x double> [ zeroinitializer, %B1008.i ], [ %.6.i4263.i.i, %B5991.i.i ]
  %.5542.i.i = load double, ptr %.5541.i.i, align 8, !noalias !86
  store <8 x double> %by_hour.2.0.lcssa.i.i, ptr %.586, align 8, !noalias !86
  %.5588.i.i = load double, ptr %.586, align 8, !noalias !86
  %.5617.i.i = load double, ptr %.5616.i.i, align 8, !noalias !86
  %.5618.i.i = fadd contract double %.5588.i.i, %.5617.i.i
  %.5647.i.i = load double, ptr %.5646.i.i, align 8, !noalias !86
  %.5676.i.i = load double, ptr %.5675.i.i, align 8, !noalias !86
  %.5677.i.i = fadd contract double %.5647.i.i, %.5676.i.i
  %.5678.i.i = fadd contract double %.5618.i.i, %.5677.i.i
  %.5707.i.i = load double, ptr %.5706.i.i, align 8, !noalias !86
  %.5736.i.i = load double, ptr %.5735.i.i, align 8, !noalias !86
  %.5737.i.i = fadd contract double %.5707.i.i, %.5736.i.i
  %.5766.i.i = load double, ptr %.5765.i.i, align 8, !noalias !86
  %.5795.i.i = load double, ptr %.5794.i.i, align 8, !noalias !86
  %.5799.i.i = fadd contract double %.5766.i.i, %.5795.i.i
  %.5800.i.i = fadd contract double %.5737.i.i, %.5799.i.i
  %.5801.i.i = fadd contract double %.5678.i.i, %.5800.i.i
  %.5802.i.i = fadd contract double %.5542.i.i, %.5801.i.i
  store double %.5802.i.i, ptr %.5541.i.i, align 8, !noalias !86
  %.5862.i.i = load double, ptr %.5861.i.i, align 8, !noalias !86
  store <8 x double> %by_declination.2.0.lcssa.i.i, ptr %.586, align 8, !noalias !86
  %.5908.i.i = load double, ptr %.586, align 8, !noalias !86
  %.5937.i.i = load double, ptr %.5616.i.i, align 8, !noalias !86
  %.5938.i.i = fadd contract double %.5908.i.i, %.5937.i.i
  %.5967.i.i = load double, ptr %.5646.i.i, align 8, !noalias !86
  %.5996.i.i = load double, ptr %.5675.i.i, align 8, !noalias !86
  %.5997.i.i = fadd contract double %.5967.i.i, %.5996.i.i
  %.5998.i.i = fadd contract double %.5938.i.i, %.5997.i.i
  %.6027.i.i = load double, ptr %.5706.i.i, align 8, !noalias !86
  %.6056.i.i = load double, ptr %.5735.i.i, align 8, !noalias !86
  %.6057.i.i = fadd contract double %.6027.i.i, %.6056.i.i
  %.6086.i.i = load double, ptr %.5765.i.i, align 8, !noalias !86
  %.6115.i.i = load double, ptr %.5794.i.i, align 8, !noalias !86
  %.6119.i.i = fadd contract double %.6086.i.i, %.6115.i.i
  %.6120.i.i = fadd contract double %.6057.i.i, %.6119.i.i
  %.6121.i.i = fadd contract double %.5998.i.i, %.6120.i.i
  %.6122.i.i = fadd contract double %.5862.i.i, %.6121.i.i
  store double %.6122.i.i, ptr %.5861.i.i, align 8, !noalias !86
  %.6182.i.i = load double, ptr %.6181.i.i, align 8, !noalias !86
  store <8 x double> %by_polarization.2.0.lcssa.i.i, ptr %.586, align 8, !noalias !86
  %.6228.i.i = load double, ptr %.586, align 8, !noalias !86
  %.6257.i.i = load double, ptr %.5616.i.i, align 8, !noalias !86
  %.6258.i.i = fadd contract double %.6228.i.i, %.6257.i.i
  %.6287.i.i = load double, ptr %.5646.i.i, align 8, !noalias !86
  %.6316.i.i = load double, ptr %.5675.i.i, align 8, !noalias !86
  %.6317.i.i = fadd contract double %.6287.i.i, %.6316.i.i
  %.6318.i.i = fadd contract double %.6258.i.i, %.6317.i.i
  %.6347.i.i = load double, ptr %.5706.i.i, align 8, !noalias !86
  %.6376.i.i = load double, ptr %.5735.i.i, align 8, !noalias !86
  %.6377.i.i = fadd contract double %.6347.i.i, %.6376.i.i
  %.6406.i.i = load double, ptr %.5765.i.i, align 8, !noalias !86
  %.6435.i.i = load double, ptr %.5794.i.i, align 8, !noalias !86
  %.6439.i.i = fadd contract double %.6406.i.i, %.6435.i.i
  %.6440.i.i = fadd contract double %.6377.i.i, %.6439.i.i
  %.6441.i.i = fadd contract double %.6318.i.i, %.6440.i.i
  %.6442.i.i = fadd contract double %.6182.i.i, %.6441.i.i
  store double %.6442.i.i, ptr %.6181.i.i, align 8, !noalias !86
  %.6502.i.i = load double, ptr %.6501.i.i, align 8, !noalias !86
  store <8 x double> %by_time.2.0.lcssa.i.i, ptr %.586, align 8, !noalias !86
  %.6553.i.i = load double, ptr %.586, align 8, !noalias !86
  %.6582.i.i = load double, ptr %.5616.i.i, align 8, !noalias !86
  %.6583.i.i = fadd contract double %.6553.i.i, %.6582.i.i
  %.6612.i.i = load double, ptr %.5646.i.i, align 8, !noalias !86
  %.6641.i.i = load double, ptr %.5675.i.i, align 8, !noalias !86
  %.6642.i.i = fadd contract double %.6612.i.i, %.6641.i.i
  %.6643.i.i = fadd contract double %.6583.i.i, %.6642.i.i
  %.6672.i.i = load double, ptr %.5706.i.i, align 8, !noalias !86
  %.6701.i.i = load double, ptr %.5735.i.i, align 8, !noalias !86
  %.6702.i.i = fadd contract double %.6672.i.i, %.6701.i.i
  %.6731.i.i = load double, ptr %.5765.i.i, align 8, !noalias !86
  %.6760.i.i = load double, ptr %.5794.i.i, align 8, !noalias !86
  %.6764.i.i = fadd contract double %.6731.i.i, %.6760.i.i
  %.6765.i.i = fadd contract double %.6702.i.i, %.6764.i.i
  %.6766.i.i = fadd contract double %.6643.i.i, %.6765.i.i
  %.6767.i.i = fadd contract double %.6502.i.i, %.6766.i.i
  store double %.6767.i.i, ptr %.6501.i.i, align 8, !noalias !86
  %lsr.iv.next.i288 = add i64 %lsr.iv.i240, 27648
  %exitcond857.not.i = icmp eq i64 %.1079.i, %.104.i
  br i1 %exitcond857.not.i, label %B1100.i, label %B802.if.i

B1100.i:                                          ; preds = %_ZN17bnserve_inference14adjoint_kernel5_back9pull_backB4v386B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i, %_ZN17bnserve_inference14adjoint_kernel7_source10_calibrateB4v142B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i
  %.1494.i = icmp sgt i64 %.134.i, 0
  br i1 %.1494.i, label %B1112.i, label %_ZN17bnserve_inference14adjoint_kernel7_source12_in_detectorB4v131B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxx5ArrayIxLi1E1C7mutable7alignedEd5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit

B1112.i:                                          ; preds = %B1100.i
  call void @llvm.lifetime.start.p0(ptr nonnull %.880.i.i173), !noalias !59
  store double 0.000000e+00, ptr %.880.i.i173, align 8, !noalias !89
  %.69.i.i = load i64, ptr %.133.i174, align 8, !noalias !89
  %.241.i.i185 = shl nsw i64 %.69.i.i, 3
  %.271.i.i186 = load i64, ptr %arg.arguments.4, align 8, !noalias !89
  %.272.i.i187 = mul nsw i64 %.271.i.i186, %.7709701030
  %.273.i.i188 = add nsw i64 %.272.i.i187, %.1282920924
  %.274.i.i189 = mul nsw i64 %.273.i.i188, %.241.i.i185
  %.308.i.i = load i64, ptr %.307.i.i, align 8, !noalias !89
  %.312.i.i190 = inttoptr i64 %.308.i.i to ptr
  %invariant.gep.i.i = getelementptr double, ptr %.312.i.i190, i64 %.1090933952
  %.741503.not.i.i = icmp slt i64 %.69.i.i, 1
  br i1 %.741503.not.i.i, label %_ZN17bnserve_inference14adjoint_kernel5_back15errors_to_nodesB4v468B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i, label %B482.if.preheader.i.i

B482.if.preheader.i.i:                            ; preds = %B1112.i
  %.514.i.i = load i64, ptr %88, align 8, !noalias !89
  %.516.i.i = add nsw i64 %.514.i.i, %.274.i.i189
  %.100.i.i = load i64, ptr %.140, align 8, !noalias !89
  %.101.i.i = sub i64 0, %.100.i.i
  %372 = lshr i64 %.101.i.i, 3
  %373 = mul i64 %372, -64
  %374 = inttoptr i64 %.516.i.i to ptr
  br label %B482.if.i.i

B594.i.i:                                         ; preds = %B482.if.i.i
  %.514.1.i.i = load i64, ptr %89, align 8, !noalias !89
  %.516.1.i.i = add nsw i64 %.514.1.i.i, %.274.i.i189
  %375 = inttoptr i64 %.516.1.i.i to ptr
  br label %B482.if.1.i.i

B482.if.1.i.i:                                    ; preds = %B482.if.1.i.i, %B594.i.i
  %lsr.iv.i30.i = phi ptr [ %invariant.gep.i.i, %B594.i.i ], [ %scevgep.i31.i, %B482.if.1.i.i ]
  %.747501504.1.i.i = phi i64 [ 0, %B594.i.i ], [ %.754.1.i.i, %B482.if.1.i.i ]
  %376 = shl i64 %.747501504.1.i.i, 3
  %scevgep88.i.i = getelementptr i8, ptr %375, i64 %376
  %.808.1.i.i = load double, ptr %scevgep88.i.i, align 8, !noalias !89
  store double 0.000000e+00, ptr %.880.i.i173, align 8, !noalias !89
  call fastcc void @inner_1(ptr nonnull %.880.i.i173, ptr %.592.1.i.i, i64 128, ptr %lsr.iv.i30.i, i64 range(i64 -9223372036854775808, 129) %.13.i, i64 range(i64 -9223372036854775808, 129) %.13.i, ptr nonnull %.586)
  %.754.1.i.i = add nuw nsw i64 %.747501504.1.i.i, 1
  %.900.1.i.i = load double, ptr %.880.i.i173, align 8, !noalias !89
  %.913.1.i.i = fadd contract double %.808.1.i.i, %.900.1.i.i
  store double %.913.1.i.i, ptr %scevgep88.i.i, align 8, !noalias !89
  %scevgep.i31.i = getelementptr i8, ptr %lsr.iv.i30.i, i64 %373
  %exitcond.not.1.i.i = icmp eq i64 %.69.i.i, %.754.1.i.i
  br i1 %exitcond.not.1.i.i, label %_ZN17bnserve_inference14adjoint_kernel5_back15errors_to_nodesB4v468B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i, label %B482.if.1.i.i

B482.if.i.i:                                      ; preds = %B482.if.i.i, %B482.if.preheader.i.i
  %lsr.iv89.i.i = phi ptr [ %invariant.gep.i.i, %B482.if.preheader.i.i ], [ %scevgep90.i.i, %B482.if.i.i ]
  %.747501504.i.i = phi i64 [ 0, %B482.if.preheader.i.i ], [ %.754.i.i192, %B482.if.i.i ]
  %377 = shl i64 %.747501504.i.i, 3
  %scevgep91.i.i = getelementptr i8, ptr %374, i64 %377
  %.808.i.i191 = load double, ptr %scevgep91.i.i, align 8, !noalias !89
  store double 0.000000e+00, ptr %.880.i.i173, align 8, !noalias !89
  call fastcc void @inner_1(ptr nonnull %.880.i.i173, ptr %.592.i.i, i64 128, ptr %lsr.iv89.i.i, i64 range(i64 -9223372036854775808, 129) %.13.i, i64 range(i64 -9223372036854775808, 129) %.13.i, ptr nonnull %.586)
  %.754.i.i192 = add nuw nsw i64 %.747501504.i.i, 1
  %.900.i.i = load double, ptr %.880.i.i173, align 8, !noalias !89
  %.913.i.i193 = fadd contract double %.808.i.i191, %.900.i.i
  store double %.913.i.i193, ptr %scevgep91.i.i, align 8, !noalias !89
  %scevgep90.i.i = getelementptr i8, ptr %lsr.iv89.i.i, i64 %373
  %exitcond.not.i29.i = icmp eq i64 %.69.i.i, %.754.i.i192
  br i1 %exitcond.not.i29.i, label %B594.i.i, label %B482.if.i.i

_ZN17bnserve_inference14adjoint_kernel5_back15errors_to_nodesB4v468B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i: ; preds = %B482.if.1.i.i, %B1112.i
  call void @llvm.lifetime.end.p0(ptr nonnull %.880.i.i173), !noalias !59
  br label %_ZN17bnserve_inference14adjoint_kernel7_source12_in_detectorB4v131B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxx5ArrayIxLi1E1C7mutable7alignedEd5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit

B358.if.lr.ph.i:                                  ; preds = %_ZN17bnserve_inference14adjoint_kernel7_source10_calibrateB4v142B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i
  %sunkaddr79.i = getelementptr i8, ptr %lsr.iv270, i64 160
  %sunkaddr8.i.i = getelementptr i8, ptr %lsr.iv270, i64 24
  %sunkaddr9.i.i = getelementptr i8, ptr %lsr.iv270, i64 16
  %sunkaddr10.i.i = getelementptr i8, ptr %lsr.iv270, i64 8
  %sunkaddr11.i.i = getelementptr i8, ptr %lsr.iv270, i64 40
  %sunkaddr12.i.i = getelementptr i8, ptr %lsr.iv270, i64 32
  %sunkaddr13.i.i = getelementptr i8, ptr %lsr.iv270, i64 64
  %sunkaddr14.i.i = getelementptr i8, ptr %lsr.iv270, i64 56
  %sunkaddr15.i.i = getelementptr i8, ptr %lsr.iv270, i64 48
  %sunkaddr16.i.i = getelementptr i8, ptr %lsr.iv270, i64 80
  %sunkaddr17.i.i = getelementptr i8, ptr %lsr.iv270, i64 72
  %sunkaddr18.i.i = getelementptr i8, ptr %lsr.iv, i64 16
  %sunkaddr19.i.i = getelementptr i8, ptr %lsr.iv, i64 8
  %sunkaddr.i5.i = getelementptr i8, ptr %lsr.iv, i64 32
  %sunkaddr20.i.i = getelementptr i8, ptr %lsr.iv, i64 24
  %sunkaddr21.i.i = getelementptr i8, ptr %lsr.iv, i64 56
  %sunkaddr22.i.i = getelementptr i8, ptr %lsr.iv, i64 48
  %sunkaddr23.i.i = getelementptr i8, ptr %lsr.iv, i64 40
  %sunkaddr24.i.i = getelementptr i8, ptr %lsr.iv, i64 72
  %sunkaddr25.i.i = getelementptr i8, ptr %lsr.iv, i64 64
  %sunkaddr47.i = getelementptr i8, ptr %lsr.iv270, i64 96
  %sunkaddr.i195 = getelementptr i8, ptr %lsr.iv270, i64 88
  br label %B358.if.i

B358.if.i:                                        ; preds = %B632.endif.i, %B358.if.lr.ph.i
  %.558802809.i = phi i64 [ 0, %B358.if.lr.ph.i ], [ %.565.i, %B632.endif.i ]
  %.565.i = add nuw nsw i64 %.558802809.i, 1
  %.idx773.i = mul i64 %.558802809.i, 27648
  %378 = getelementptr i8, ptr %.430, i64 %.idx773.i
  %.612.i = getelementptr i8, ptr %378, i64 14336
  %.711.i196 = load double, ptr %sunkaddr79.i, align 8, !noalias !59
  %.712.i197 = fcmp contract ogt double %.711.i196, 0.000000e+00
  br i1 %.712.i197, label %B444.i, label %B596.i

B632.endif.i:                                     ; preds = %B1190.i.i, %B596.i, %B632.i
  %exitcond.not.i231 = icmp eq i64 %.565.i, %.104.i
  br i1 %exitcond.not.i231, label %B802.if.lr.ph.i, label %B358.if.i

B802.if.i:                                        ; preds = %_ZN17bnserve_inference14adjoint_kernel5_back9pull_backB4v386B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i, %B802.if.lr.ph.i
  %lsr.iv.i240 = phi i64 [ 21504, %B802.if.lr.ph.i ], [ %lsr.iv.next.i288, %_ZN17bnserve_inference14adjoint_kernel5_back9pull_backB4v386B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i ]
  %.1072818825.i = phi i64 [ 0, %B802.if.lr.ph.i ], [ %.1079.i, %_ZN17bnserve_inference14adjoint_kernel5_back9pull_backB4v386B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i ]
  %.1079.i = add nuw nsw i64 %.1072818825.i, 1
  %.idx.i241 = mul i64 %.1072818825.i, 27648
  %379 = getelementptr i8, ptr %.430, i64 %.idx.i241
  %.1126.i = getelementptr i8, ptr %379, i64 14336
  %.1225.i = load double, ptr %lsr.iv270, align 8, !noalias !59
  %.1227.i = fadd contract double %.916, %.1225.i
  %.79.i.i = load i64, ptr %.76, align 8, !noalias !92
  %.109.i.i = load i64, ptr %.140, align 8, !noalias !92
  %.139.i.i = load i64, ptr %.138.i.i, align 8, !noalias !92
  %.224.i.i = load i64, ptr %.171.i, align 8, !noalias !92
  %.377.i.i242 = load i64, ptr %.376.i.i233, align 8, !noalias !92
  %.455747.i.i = load double, ptr %.454.i.i234, align 8, !noalias !92
  %.501.i.i243 = load i64, ptr %.500.i.i235, align 8, !noalias !92
  %.558.i.i244 = load i64, ptr %.557.i.i, align 8, !noalias !92
  br i1 %.93.inv.i.i, label %B604.loopexit.3.i.i, label %B652.if.lr.ph.i.i

B604.loopexit.3.i.i:                              ; preds = %B652.if.lr.ph.i.i, %B802.if.i
  %.147.i.i = sub i64 0, %.109.i.i
  %.155.1.i.i = and i64 %.147.i.i, -8
  %.189.i.i = sub i64 0, %.155.1.i.i
  %.226.i.i = inttoptr i64 %.224.i.i to ptr
  %.290.i32.i = getelementptr inbounds double, ptr %.226.i.i, i64 %.1090933952
  %.566.i.i = shl nsw i64 %.189.i.i, 1
  %.1000.i33.i = load i64, ptr %.999.i.i236, align 8, !noalias !92
  %.1080809.not.i.i = icmp slt i64 %.1000.i33.i, 1
  br i1 %.1080809.not.i.i, label %_ZN17bnserve_inference14adjoint_kernel7_source16_through_weightsB4v285B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxxx5ArrayIxLi1E1C7mutable7alignedEd5ArrayIdLi1E1C7mutable7alignedE.exit.i, label %B810.if.lr.ph.i.i

B810.if.lr.ph.i.i:                                ; preds = %B604.loopexit.3.i.i
  %.560.i.i = shl nsw i64 %.189.i.i, 4
  %.562.i.i245 = mul nsw i64 %.560.i.i, %.139.i.i
  %.502.i.i246 = icmp eq i64 %.501.i.i243, 1
  %.515.i.i247 = mul nsw i64 %.79.i.i, %.1282920924
  %.521.i.i = add nsw i64 %.515.i.i247, %.1072818825.i
  %"$phi424.0.2.0.i.i" = select i1 %.502.i.i246, i64 %.1282920924, i64 %.521.i.i
  %.563.i.i248 = mul nsw i64 %.562.i.i245, %"$phi424.0.2.0.i.i"
  %.564.i.i = add nsw i64 %.563.i.i248, %.558.i.i244
  %380 = inttoptr i64 %.564.i.i to ptr
  %.1583.i.i = add nsw i64 %.139.i.i, -4
  %.1178.i.i = getelementptr inbounds double, ptr %380, i64 %.1090933952
  %.1232.i34.i = sub i64 %.1090933952, %.155.1.i.i
  %.1244.i.i = getelementptr inbounds double, ptr %380, i64 %.1232.i34.i
  %invariant.gep.i.i.i = getelementptr double, ptr %380, i64 %.566.i.i
  %invariant.gep1621.idx.i.i.i = mul i64 %.155.1.i.i, -48
  %invariant.gep1621.i.i.i = getelementptr i8, ptr %380, i64 %invariant.gep1621.idx.i.i.i
  %invariant.gep1623.idx.i.i.i = shl i64 %.189.i.i, 5
  %invariant.gep1623.i.i.i = getelementptr i8, ptr %380, i64 %invariant.gep1623.idx.i.i.i
  %invariant.gep1625.idx.i.i.i = mul i64 %.155.1.i.i, -80
  %invariant.gep1625.i.i.i = getelementptr i8, ptr %380, i64 %invariant.gep1625.idx.i.i.i
  %invariant.gep1627.idx.i.i.i = shl i64 %.189.i.i, 6
  %invariant.gep1627.i.i.i = getelementptr i8, ptr %380, i64 %invariant.gep1627.idx.i.i.i
  %381 = icmp eq i64 %.139.i.i, 1
  %382 = inttoptr i64 %.377.i.i242 to ptr
  %sunkaddr13.i35.i = getelementptr i8, ptr %382, i64 8
  br label %B810.if.i.i

B884.i.i:                                         ; preds = %_ZN17bnserve_inference14adjoint_kernel7_source10_fill_barsB4v296B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i.i
  br i1 %.93.inv.i.i, label %B1112.i.i, label %B382.lr.ph.i.i.i

B992.i.i:                                         ; preds = %_ZN17bnserve_inference14adjoint_kernel7_source10_fill_barsB4v296B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i.i
  %.48.i.i.i = load double, ptr %382, align 8, !noalias !95
  %.49.i.i.i = fsub contract double %.1157.i.i, %.48.i.i.i
  %.78.i.i.i = load double, ptr %sunkaddr13.i35.i, align 8, !noalias !95
  %.85.i.i.i = fdiv contract double %.49.i.i.i, %.78.i.i.i
  %.93.le.i.i.i = tail call contract double @llvm.floor.f64(double %.85.i.i.i)
  %.5.i.i.i.i = fptosi double %.93.le.i.i.i to i64
  %.13.i.i.i.i = tail call i64 @llvm.smax.i64(i64 %.5.i.i.i.i, i64 2)
  %.13.i1.i.i.i = tail call i64 @llvm.smin.i64(i64 %.1583.i.i, i64 %.13.i.i.i.i)
  %.181.i.i.i = sitofp i64 %.13.i1.i.i.i to double
  %.182.i.i.i = fsub contract double %.85.i.i.i, %.181.i.i.i
  %.183.i.i.i = fsub contract double 1.000000e+00, %.182.i.i.i
  %.184.i.i.i = fmul contract double %.183.i.i.i, %.183.i.i.i
  %.185.i.i.i = fmul contract double %.183.i.i.i, %.184.i.i.i
  %.192.i.i.i = fmul contract double %.182.i.i.i, 5.000000e+00
  %.193.i.i.i = fadd contract double %.192.i.i.i, -2.000000e+01
  %.194.i.i.i = fmul contract double %.182.i.i.i, %.193.i.i.i
  %.195.i.i.i = fadd contract double %.194.i.i.i, 2.000000e+01
  %.196.i.i.i = fmul contract double %.182.i.i.i, %.195.i.i.i
  %.197.i.i.i = fadd contract double %.196.i.i.i, 2.000000e+01
  %.198.i.i.i = fmul contract double %.182.i.i.i, %.197.i.i.i
  %.199.i.i.i = fadd contract double %.198.i.i.i, -5.000000e+01
  %.200.i.i.i = fmul contract double %.182.i.i.i, %.199.i.i.i
  %.201.i.i.i = fadd contract double %.200.i.i.i, 2.600000e+01
  %.205.i.i.i = fdiv contract double %.201.i.i.i, 1.200000e+02
  %.206.i.i.i = fmul contract double %.182.i.i.i, %.182.i.i.i
  %.208.i.i.i = fmul contract double %.182.i.i.i, 1.000000e+01
  %.209.i.i.i = fsub contract double 3.000000e+01, %.208.i.i.i
  %.210.i.i.i = fmul contract double %.206.i.i.i, %.209.i.i.i
  %.211.i.i.i = fadd contract double %.210.i.i.i, -6.000000e+01
  %.212.i.i.i = fmul contract double %.206.i.i.i, %.211.i.i.i
  %.213.i.i.i = fadd contract double %.212.i.i.i, 6.600000e+01
  %.217.i.i.i = fdiv contract double %.213.i.i.i, 1.200000e+02
  %.220.i.i.i = fmul contract double %.183.i.i.i, 1.000000e+01
  %.221.i.i.i = fsub contract double 3.000000e+01, %.220.i.i.i
  %.222.i.i.i = fmul contract double %.184.i.i.i, %.221.i.i.i
  %.223.i.i.i = fadd contract double %.222.i.i.i, -6.000000e+01
  %.224.i.i.i = fmul contract double %.184.i.i.i, %.223.i.i.i
  %.225.i.i.i = fadd contract double %.224.i.i.i, 6.600000e+01
  %.229.i.i.i = fdiv contract double %.225.i.i.i, 1.200000e+02
  %.230.i.i.i = fmul contract double %.183.i.i.i, 5.000000e+00
  %.231.i.i.i = fadd contract double %.230.i.i.i, -2.000000e+01
  %.232.i.i.i = fmul contract double %.183.i.i.i, %.231.i.i.i
  %.233.i.i.i = fadd contract double %.232.i.i.i, 2.000000e+01
  %.234.i.i.i = fmul contract double %.183.i.i.i, %.233.i.i.i
  %.235.i.i.i = fadd contract double %.234.i.i.i, 2.000000e+01
  %.236.i.i.i = fmul contract double %.183.i.i.i, %.235.i.i.i
  %.237.i.i.i = fadd contract double %.236.i.i.i, -5.000000e+01
  %.238.i.i.i = fmul contract double %.183.i.i.i, %.237.i.i.i
  %.239.i.i.i = fadd contract double %.238.i.i.i, 2.600000e+01
  %.243.i.i.i = fdiv contract double %.239.i.i.i, 1.200000e+02
  %.245.i.i.i = fmul contract double %.182.i.i.i, %.206.i.i.i
  %.246.i.i.i = fmul contract double %.182.i.i.i, %.245.i.i.i
  %.247.i.i.i = fmul contract double %.182.i.i.i, %.246.i.i.i
  %.251.i.i.i = fdiv contract double %.247.i.i.i, 1.200000e+02
  %.265.i.i.i = add nsw i64 %.13.i1.i.i.i, -2
  %.266.i.i.i = mul nsw i64 %.265.i.i.i, %.566.i.i
  %.267.i.i.i = add nsw i64 %.266.i.i.i, %.1090933952
  %.1647.i.i = fmul contract double %.78.i.i.i, 2.400000e+01
  %.1651.i.i = fdiv contract double 1.000000e+00, %.1647.i.i
  %.1652.i.i = fmul contract double %.182.i.i.i, 2.400000e+01
  %.1656.i.i = fsub contract double 2.400000e+01, %.208.i.i.i
  %.1657.i37.i = fmul contract double %.245.i.i.i, %.1656.i.i
  %383 = fsub contract double %.1657.i37.i, %.1652.i.i
  %.1659.i.i = fmul contract double %.183.i.i.i, 2.400000e+01
  %.1663.i.i = fsub contract double 2.400000e+01, %.220.i.i.i
  %.1664.i38.i = fmul contract double %.185.i.i.i, %.1663.i.i
  %384 = fsub contract double %.1664.i38.i, %.1659.i.i
  %.1667.i.i = fadd contract double %.192.i.i.i, -1.600000e+01
  %.1668.i.i = fmul contract double %.182.i.i.i, %.1667.i.i
  %.1669.i.i250 = fadd contract double %.1668.i.i, 1.200000e+01
  %.1670.i.i251 = fmul contract double %.182.i.i.i, %.1669.i.i250
  %.1671.i.i = fadd contract double %.1670.i.i251, 8.000000e+00
  %.1672.i.i = fmul contract double %.182.i.i.i, %.1671.i.i
  %.1673.i.i = fadd contract double %.1672.i.i, -1.000000e+01
  %.1675.i.i252 = fadd contract double %.230.i.i.i, -1.600000e+01
  %.1676.i.i = fmul contract double %.183.i.i.i, %.1675.i.i252
  %.1677.i.i = fadd contract double %.1676.i.i, 1.200000e+01
  %.1678.i.i = fmul contract double %.183.i.i.i, %.1677.i.i
  %.1679.i.i = fadd contract double %.1678.i.i, 8.000000e+00
  %.1680.i.i = fmul contract double %.183.i.i.i, %.1679.i.i
  %.1681.i.i = fadd contract double %.1680.i.i, -1.000000e+01
  %.1687.i.i = fmul contract double %.1651.i.i, %.1673.i.i
  %.1688.i.i = fmul contract double %.1651.i.i, %383
  %.1689.i.i = fneg contract double %384
  %.1690.i.i = fmul contract double %.1651.i.i, %.1689.i.i
  %.1691.i.i = fneg contract double %.1681.i.i
  %.1692.i.i = fmul contract double %.1651.i.i, %.1691.i.i
  %.1696.i.i = fmul contract double %.1651.i.i, %.246.i.i.i
  %.1458.i.i.i = sub i64 %.267.i.i.i, %.155.1.i.i
  %.1519.i.i.i = insertelement <8 x double> poison, double %.205.i.i.i, i64 0
  %.1520.i.i.i = shufflevector <8 x double> %.1519.i.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1546.i.i.i = insertelement <8 x double> poison, double %.217.i.i.i, i64 0
  %.1547.i.i.i = shufflevector <8 x double> %.1546.i.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1549.i.i.i = insertelement <8 x double> poison, double %.229.i.i.i, i64 0
  %.1550.i.i.i = shufflevector <8 x double> %.1549.i.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1585.i.i.i = insertelement <8 x double> poison, double %.243.i.i.i, i64 0
  %.1586.i.i.i = shufflevector <8 x double> %.1585.i.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1588.i.i.i = insertelement <8 x double> poison, double %.251.i.i.i, i64 0
  %.1589.i.i.i = shufflevector <8 x double> %.1588.i.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1874.i.i.i = insertelement <8 x double> poison, double %.1687.i.i, i64 0
  %.1875.i.i.i = shufflevector <8 x double> %.1874.i.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1901.i.i.i = insertelement <8 x double> poison, double %.1688.i.i, i64 0
  %.1902.i.i.i = shufflevector <8 x double> %.1901.i.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1904.i.i.i = insertelement <8 x double> poison, double %.1690.i.i, i64 0
  %.1905.i.i.i = shufflevector <8 x double> %.1904.i.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1940.i.i.i = insertelement <8 x double> poison, double %.1692.i.i, i64 0
  %.1941.i.i.i = shufflevector <8 x double> %.1940.i.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1943.i.i.i = insertelement <8 x double> poison, double %.1696.i.i, i64 0
  %.1944.i.i.i = shufflevector <8 x double> %.1943.i.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  br i1 %.93.inv.i.i, label %B1112.i.i, label %B394.lr.ph.i.i.i

B1112.i.i:                                        ; preds = %B394.i.i.i, %B382.i.i.i, %B992.i.i, %B884.i.i
  %exitcond838.not.i.i = icmp eq i64 %.1093.i36.i, %.1000.i33.i
  br i1 %exitcond838.not.i.i, label %_ZN17bnserve_inference14adjoint_kernel7_source16_through_weightsB4v285B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxxx5ArrayIxLi1E1C7mutable7alignedEd5ArrayIdLi1E1C7mutable7alignedE.exit.i, label %B810.if.i.i

B652.if.lr.ph.i.i:                                ; preds = %B802.if.i
  tail call void @llvm.memset.p0.i64(ptr align 8 %.882.i.i, i8 0, i64 %335, i1 false), !noalias !92
  tail call void @llvm.memset.p0.i64(ptr align 8 %.882.1.i.i, i8 0, i64 %335, i1 false), !noalias !92
  tail call void @llvm.memset.p0.i64(ptr align 8 %.882.2.i.i, i8 0, i64 %335, i1 false), !noalias !92
  tail call void @llvm.memset.p0.i64(ptr align 8 %.882.3.i.i, i8 0, i64 %335, i1 false), !noalias !92
  br label %B604.loopexit.3.i.i

B810.if.i.i:                                      ; preds = %B1112.i.i, %B810.if.lr.ph.i.i
  %.1086800810.i.i = phi i64 [ 0, %B810.if.lr.ph.i.i ], [ %.1093.i36.i, %B1112.i.i ]
  %.1093.i36.i = add nuw nsw i64 %.1086800810.i.i, 1
  %.260.i.i.i = load i64, ptr %.76, align 8, !noalias !98
  %.359.i.i.i = load i64, ptr %.358.i.i.i, align 8, !noalias !98
  %.360.i.i.i = icmp eq i64 %.359.i.i.i, 1
  br i1 %.360.i.i.i, label %B266.i.i.i, label %B544.i.i.i

B266.i.i.i:                                       ; preds = %B810.if.i.i
  %.290.i.i.i = load i64, ptr %.140, align 8, !noalias !98
  %.368.i.i.i = sub i64 %.290.i.i.i, %.1090933952
  %.13.i.i5.i.i = tail call i64 @llvm.smin.i64(i64 %.368.i.i.i, i64 range(i64 -9223372036854775808, 129) %.13.i)
  %.430.i.i.i = load i64, ptr %.1419.i.i.i, align 8, !noalias !98
  %.438.i.i.i = mul nsw i64 %.260.i.i.i, %.7709701030
  %.444.i.i.i = add nsw i64 %.438.i.i.i, %.1072818825.i
  %.448.i.i.i = mul nsw i64 %.290.i.i.i, %.444.i.i.i
  %.452.i.i.i = add nsw i64 %.448.i.i.i, %.1090933952
  %.455.i.i.i = shl nsw i64 %.452.i.i.i, 4
  %.456.i.i.i = add nsw i64 %.455.i.i.i, %.430.i.i.i
  %.1203746.not.i.i.i = icmp slt i64 %.13.i.i5.i.i, 1
  tail call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(2048) %.586, i8 0, i64 2048, i1 false), !noalias !98
  br i1 %.1203746.not.i.i.i, label %_ZN17bnserve_inference14adjoint_kernel7_source10_fill_barsB4v296B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i.i, label %B470.if.preheader.i.i.i

B470.if.preheader.i.i.i:                          ; preds = %B266.i.i.i
  %385 = icmp eq i64 %.13.i.i5.i.i, 1
  br i1 %385, label %B470.if.epil.preheader.i.i.i, label %B470.if.preheader.new.i.i.i

B470.if.preheader.new.i.i.i:                      ; preds = %B470.if.preheader.i.i.i
  %386 = inttoptr i64 %.456.i.i.i to ptr
  %scevgep.i.i.i = getelementptr i8, ptr %386, i64 24
  %387 = add nsw i64 %.13.i.i5.i.i, -2
  %388 = lshr i64 %387, 1
  %389 = icmp eq i64 %388, 0
  br i1 %389, label %B470.if.epil.preheader1.i.i.i, label %B470.if.preheader.new.new.i.i.i

B470.if.preheader.new.new.i.i.i:                  ; preds = %B470.if.preheader.new.i.i.i
  %390 = add nuw nsw i64 %388, 1
  %scevgep11.i.i.i = getelementptr i8, ptr %386, i64 56
  %391 = lshr i64 %390, 1
  %392 = mul nsw i64 %391, -2
  br label %B470.if.i.i.i

common.ret.loopexit.unr-lcssa.unr-lcssa.i.i.i:    ; preds = %B470.if.i.i.i
  %393 = and i64 %387, 2
  %lcmp.mod.not10.not.i.i.i = icmp eq i64 %393, 0
  %scevgep4.i.i.i = getelementptr i8, ptr %lsr.iv12.i.i.i, i64 32
  br i1 %lcmp.mod.not10.not.i.i.i, label %B470.if.epil.preheader1.i.i.i, label %common.ret.loopexit.unr-lcssa.i.i.i

B470.if.epil.preheader1.i.i.i:                    ; preds = %common.ret.loopexit.unr-lcssa.unr-lcssa.i.i.i, %B470.if.preheader.new.i.i.i
  %lsr.iv.epil.init.i.i.i = phi ptr [ %scevgep.i.i.i, %B470.if.preheader.new.i.i.i ], [ %scevgep4.i.i.i, %common.ret.loopexit.unr-lcssa.unr-lcssa.i.i.i ]
  %.1209745747.epil.init4.i.i.i = phi i64 [ 0, %B470.if.preheader.new.i.i.i ], [ %.1216.1.1.i.i.i, %common.ret.loopexit.unr-lcssa.unr-lcssa.i.i.i ]
  %scevgep61.epil.i.i.i = getelementptr i8, ptr %lsr.iv.epil.init.i.i.i, i64 -24
  %.1271.epil2.i.i.i = load double, ptr %scevgep61.epil.i.i.i, align 8, !noalias !98
  %scevgep62.epil.i.i.i = getelementptr i8, ptr %lsr.iv.epil.init.i.i.i, i64 -16
  %.1303.epil3.i.i.i = load double, ptr %scevgep62.epil.i.i.i, align 8, !noalias !98
  %sunkaddr89.epil.i.i.i = shl i64 %.1209745747.epil.init4.i.i.i, 3
  %sunkaddr90.epil.i.i.i = getelementptr i8, ptr %.430, i64 %sunkaddr89.epil.i.i.i
  %sunkaddr91.epil.i.i.i = getelementptr i8, ptr %sunkaddr90.epil.i.i.i, i64 12288
  store double %.1271.epil2.i.i.i, ptr %sunkaddr91.epil.i.i.i, align 8, !noalias !98
  %sunkaddr94.epil.i.i.i = getelementptr i8, ptr %sunkaddr90.epil.i.i.i, i64 13312
  store double %.1303.epil3.i.i.i, ptr %sunkaddr94.epil.i.i.i, align 8, !noalias !98
  %.1216.1.epil.i.i.i = add nuw i64 %.1209745747.epil.init4.i.i.i, 2
  %scevgep60.epil.i.i.i = getelementptr i8, ptr %lsr.iv.epil.init.i.i.i, i64 -8
  %.1271.1.epil.i.i.i = load double, ptr %scevgep60.epil.i.i.i, align 8, !noalias !98
  %.1303.1.epil.i.i.i = load double, ptr %lsr.iv.epil.init.i.i.i, align 8, !noalias !98
  %sunkaddr97.epil.i.i.i = getelementptr i8, ptr %sunkaddr90.epil.i.i.i, i64 12296
  store double %.1271.1.epil.i.i.i, ptr %sunkaddr97.epil.i.i.i, align 8, !noalias !98
  %sunkaddr100.epil.i.i.i = getelementptr i8, ptr %sunkaddr90.epil.i.i.i, i64 13320
  store double %.1303.1.epil.i.i.i, ptr %sunkaddr100.epil.i.i.i, align 8, !noalias !98
  br label %common.ret.loopexit.unr-lcssa.i.i.i

common.ret.loopexit.unr-lcssa.i.i.i:              ; preds = %B470.if.epil.preheader1.i.i.i, %common.ret.loopexit.unr-lcssa.unr-lcssa.i.i.i
  %.1216.1.lcssa.i.i.i = phi i64 [ %.1216.1.epil.i.i.i, %B470.if.epil.preheader1.i.i.i ], [ %.1216.1.1.i.i.i, %common.ret.loopexit.unr-lcssa.unr-lcssa.i.i.i ]
  %394 = and i64 %.13.i.i5.i.i, 1
  %lcmp.mod55.not.i.i.i = icmp eq i64 %394, 0
  br i1 %lcmp.mod55.not.i.i.i, label %_ZN17bnserve_inference14adjoint_kernel7_source10_fill_barsB4v296B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i.i, label %B470.if.epil.preheader.i.i.i

B470.if.epil.preheader.i.i.i:                     ; preds = %common.ret.loopexit.unr-lcssa.i.i.i, %B470.if.preheader.i.i.i
  %.1209745747.epil.init.i.i.i = phi i64 [ 0, %B470.if.preheader.i.i.i ], [ %.1216.1.lcssa.i.i.i, %common.ret.loopexit.unr-lcssa.i.i.i ]
  %395 = inttoptr i64 %.456.i.i.i to ptr
  %.idx.epil.i.i.i291 = shl i64 %.1209745747.epil.init.i.i.i, 4
  %396 = getelementptr i8, ptr %395, i64 %.idx.epil.i.i.i291
  %.1271.epil.i.i.i = load double, ptr %396, align 8, !noalias !98
  %397 = getelementptr i8, ptr %396, i64 8
  %.1303.epil.i.i.i = load double, ptr %397, align 8, !noalias !98
  %sunkaddr118.i.i.i = shl i64 %.1209745747.epil.init.i.i.i, 3
  %sunkaddr119.i.i.i = getelementptr i8, ptr %.430, i64 %sunkaddr118.i.i.i
  %sunkaddr120.i.i.i = getelementptr i8, ptr %sunkaddr119.i.i.i, i64 12288
  store double %.1271.epil.i.i.i, ptr %sunkaddr120.i.i.i, align 8, !noalias !98
  %sunkaddr80.i.i.i = getelementptr i8, ptr %sunkaddr119.i.i.i, i64 13312
  store double %.1303.epil.i.i.i, ptr %sunkaddr80.i.i.i, align 8, !noalias !98
  br label %_ZN17bnserve_inference14adjoint_kernel7_source10_fill_barsB4v296B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i.i

common.ret.loopexit52.unr-lcssa.i.i.i:            ; preds = %B688.if.i.i.i
  br i1 %lcmp.mod.not.i.i.i237, label %_ZN17bnserve_inference14adjoint_kernel7_source10_fill_barsB4v296B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i.i, label %B688.if.epil.preheader.i.i.i

B688.if.epil.preheader.i.i.i:                     ; preds = %B688.if.lr.ph.i.i.i, %common.ret.loopexit52.unr-lcssa.i.i.i
  %.1589735737.epil.init.i.i.i = phi i64 [ 0, %B688.if.lr.ph.i.i.i ], [ %.1596.1.i.i.i, %common.ret.loopexit52.unr-lcssa.i.i.i ]
  %sunkaddr81.i.i.i = inttoptr i64 %.1445.i.i.i to ptr
  %sunkaddr82.i.i.i = getelementptr i8, ptr %sunkaddr81.i.i.i, i64 %.1420.i.i.i
  %.1650.epil.i.i.i = load double, ptr %sunkaddr82.i.i.i, align 8, !noalias !98
  %.1651.epil.i.i.i = insertelement <8 x double> poison, double %.1650.epil.i.i.i, i64 0
  %.1652.epil.i.i.i = shufflevector <8 x double> %.1651.epil.i.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %sunkaddr121.i.i.i = shl i64 %.1589735737.epil.init.i.i.i, 3
  %sunkaddr122.i.i.i = getelementptr inbounds i8, ptr %.430, i64 %sunkaddr121.i.i.i
  %sunkaddr123.i.i.i = getelementptr inbounds nuw i8, ptr %sunkaddr122.i.i.i, i64 12288
  store <8 x double> %.1652.epil.i.i.i, ptr %sunkaddr123.i.i.i, align 8, !noalias !98
  %sunkaddr85.i.i.i = getelementptr i8, ptr %sunkaddr82.i.i.i, i64 8
  %.1692.epil.i.i.i = load double, ptr %sunkaddr85.i.i.i, align 8, !noalias !98
  %.1693.epil.i.i.i = insertelement <8 x double> poison, double %.1692.epil.i.i.i, i64 0
  %.1694.epil.i.i.i = shufflevector <8 x double> %.1693.epil.i.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %sunkaddr88.i.i.i = getelementptr inbounds nuw i8, ptr %sunkaddr122.i.i.i, i64 13312
  store <8 x double> %.1694.epil.i.i.i, ptr %sunkaddr88.i.i.i, align 8, !noalias !98
  br label %_ZN17bnserve_inference14adjoint_kernel7_source10_fill_barsB4v296B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i.i

B544.i.i.i:                                       ; preds = %B810.if.i.i
  %.320.i.i.i = load i64, ptr %.999.i.i236, align 8, !noalias !98
  %.1420.i.i.i = load i64, ptr %.1419.i.i.i, align 8, !noalias !98
  %.1428.i.i.i = mul nsw i64 %.260.i.i.i, %.7709701030
  %.1434.i.i.i = add nsw i64 %.1428.i.i.i, %.1072818825.i
  %.1438.i.i.i = mul nsw i64 %.320.i.i.i, %.1434.i.i.i
  %.1442.i.i.i = add nsw i64 %.1438.i.i.i, %.1086800810.i.i
  %.1445.i.i.i = shl nsw i64 %.1442.i.i.i, 4
  br i1 %.93.inv.i.i, label %_ZN17bnserve_inference14adjoint_kernel7_source10_fill_barsB4v296B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i.i, label %B688.if.lr.ph.i.i.i

B470.if.i.i.i:                                    ; preds = %B470.if.i.i.i, %B470.if.preheader.new.new.i.i.i
  %lsr.iv1.i.i.i = phi i64 [ %lsr.iv.next2.i.i.i, %B470.if.i.i.i ], [ %392, %B470.if.preheader.new.new.i.i.i ]
  %lsr.iv12.i.i.i = phi ptr [ %scevgep13.i.i.i, %B470.if.i.i.i ], [ %scevgep11.i.i.i, %B470.if.preheader.new.new.i.i.i ]
  %.1209745747.i.i.i = phi i64 [ %.1216.1.1.i.i.i, %B470.if.i.i.i ], [ 0, %B470.if.preheader.new.new.i.i.i ]
  %scevgep18.i.i.i = getelementptr i8, ptr %lsr.iv12.i.i.i, i64 -32
  %scevgep21.i.i.i = getelementptr i8, ptr %lsr.iv12.i.i.i, i64 -56
  %.1271.i.i.i = load double, ptr %scevgep21.i.i.i, align 8, !noalias !98
  %scevgep20.i.i.i = getelementptr i8, ptr %lsr.iv12.i.i.i, i64 -48
  %.1303.i6.i.i = load double, ptr %scevgep20.i.i.i, align 8, !noalias !98
  %sunkaddr39.i.i.i = shl i64 %.1209745747.i.i.i, 3
  %sunkaddr40.i.i.i = getelementptr i8, ptr %.430, i64 %sunkaddr39.i.i.i
  %sunkaddr41.i.i.i = getelementptr i8, ptr %sunkaddr40.i.i.i, i64 12288
  store double %.1271.i.i.i, ptr %sunkaddr41.i.i.i, align 8, !noalias !98
  %sunkaddr44.i.i.i = getelementptr i8, ptr %sunkaddr40.i.i.i, i64 13312
  store double %.1303.i6.i.i, ptr %sunkaddr44.i.i.i, align 8, !noalias !98
  %scevgep19.i.i.i = getelementptr i8, ptr %lsr.iv12.i.i.i, i64 -40
  %.1271.1.i.i.i = load double, ptr %scevgep19.i.i.i, align 8, !noalias !98
  %.1303.1.i.i.i = load double, ptr %scevgep18.i.i.i, align 8, !noalias !98
  %sunkaddr46.i.i.i = getelementptr i8, ptr %sunkaddr40.i.i.i, i64 12296
  store double %.1271.1.i.i.i, ptr %sunkaddr46.i.i.i, align 8, !noalias !98
  %sunkaddr49.i.i.i = getelementptr i8, ptr %sunkaddr40.i.i.i, i64 13320
  store double %.1303.1.i.i.i, ptr %sunkaddr49.i.i.i, align 8, !noalias !98
  %scevgep17.i.i.i = getelementptr i8, ptr %lsr.iv12.i.i.i, i64 -24
  %.1271.18.i.i.i = load double, ptr %scevgep17.i.i.i, align 8, !noalias !98
  %scevgep16.i.i.i = getelementptr i8, ptr %lsr.iv12.i.i.i, i64 -16
  %.1303.19.i.i.i = load double, ptr %scevgep16.i.i.i, align 8, !noalias !98
  %sunkaddr52.i.i.i = getelementptr i8, ptr %sunkaddr40.i.i.i, i64 12304
  store double %.1271.18.i.i.i, ptr %sunkaddr52.i.i.i, align 8, !noalias !98
  %sunkaddr55.i.i.i = getelementptr i8, ptr %sunkaddr40.i.i.i, i64 13328
  store double %.1303.19.i.i.i, ptr %sunkaddr55.i.i.i, align 8, !noalias !98
  %.1216.1.1.i.i.i = add i64 %.1209745747.i.i.i, 4
  %scevgep15.i.i.i = getelementptr i8, ptr %lsr.iv12.i.i.i, i64 -8
  %.1271.1.1.i.i.i = load double, ptr %scevgep15.i.i.i, align 8, !noalias !98
  %.1303.1.1.i.i.i = load double, ptr %lsr.iv12.i.i.i, align 8, !noalias !98
  %sunkaddr56.i.i.i = shl i64 %.1216.1.1.i.i.i, 3
  %sunkaddr57.i.i.i = getelementptr i8, ptr %.430, i64 %sunkaddr56.i.i.i
  %sunkaddr58.i.i.i = getelementptr i8, ptr %sunkaddr57.i.i.i, i64 12280
  store double %.1271.1.1.i.i.i, ptr %sunkaddr58.i.i.i, align 8, !noalias !98
  %sunkaddr61.i.i.i = getelementptr i8, ptr %sunkaddr57.i.i.i, i64 13304
  store double %.1303.1.1.i.i.i, ptr %sunkaddr61.i.i.i, align 8, !noalias !98
  %scevgep13.i.i.i = getelementptr i8, ptr %lsr.iv12.i.i.i, i64 64
  %lsr.iv.next2.i.i.i = add i64 %lsr.iv1.i.i.i, 2
  %niter.ncmp.1.i.i.i = icmp eq i64 %lsr.iv.next2.i.i.i, 0
  br i1 %niter.ncmp.1.i.i.i, label %common.ret.loopexit.unr-lcssa.unr-lcssa.i.i.i, label %B470.if.i.i.i

B688.if.lr.ph.i.i.i:                              ; preds = %B544.i.i.i
  br i1 %336, label %B688.if.epil.preheader.i.i.i, label %B688.if.lr.ph.new.i.i.i

B688.if.lr.ph.new.i.i.i:                          ; preds = %B688.if.lr.ph.i.i.i
  %sunkaddr62.i.i.i = inttoptr i64 %.1445.i.i.i to ptr
  %sunkaddr63.i.i.i = getelementptr i8, ptr %sunkaddr62.i.i.i, i64 %.1420.i.i.i
  %sunkaddr72.i.i.i = getelementptr i8, ptr %sunkaddr63.i.i.i, i64 8
  br label %B688.if.i.i.i

B688.if.i.i.i:                                    ; preds = %B688.if.i.i.i, %B688.if.lr.ph.new.i.i.i
  %lsr.iv.i2.i.i = phi i64 [ %lsr.iv.next30.i.i.i, %B688.if.i.i.i ], [ %337, %B688.if.lr.ph.new.i.i.i ]
  %.1589735737.i.i.i = phi i64 [ %.1596.1.i.i.i, %B688.if.i.i.i ], [ 0, %B688.if.lr.ph.new.i.i.i ]
  %.1650.i.i.i = load double, ptr %sunkaddr63.i.i.i, align 8, !noalias !98
  %.1651.i3.i.i = insertelement <8 x double> poison, double %.1650.i.i.i, i64 0
  %.1652.i.i.i = shufflevector <8 x double> %.1651.i3.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %sunkaddr64.i.i.i = shl i64 %.1589735737.i.i.i, 3
  %sunkaddr65.i.i.i = getelementptr i8, ptr %.430, i64 %sunkaddr64.i.i.i
  %sunkaddr69.i.i.i = getelementptr i8, ptr %sunkaddr65.i.i.i, i64 12288
  store <8 x double> %.1652.i.i.i, ptr %sunkaddr69.i.i.i, align 8, !noalias !98
  %.1692.i4.i.i = load double, ptr %sunkaddr72.i.i.i, align 8, !noalias !98
  %.1693.i.i.i = insertelement <8 x double> poison, double %.1692.i4.i.i, i64 0
  %.1694.i.i.i = shufflevector <8 x double> %.1693.i.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %sunkaddr76.i.i.i = getelementptr i8, ptr %sunkaddr65.i.i.i, i64 13312
  store <8 x double> %.1694.i.i.i, ptr %sunkaddr76.i.i.i, align 8, !noalias !98
  %.1596.1.i.i.i = add i64 %.1589735737.i.i.i, 16
  %.1650.1.i.i.i = load double, ptr %sunkaddr63.i.i.i, align 8, !noalias !98
  %.1651.1.i.i.i = insertelement <8 x double> poison, double %.1650.1.i.i.i, i64 0
  %.1652.1.i.i.i = shufflevector <8 x double> %.1651.1.i.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %sunkaddr77.i.i.i = shl i64 %.1596.1.i.i.i, 3
  %sunkaddr78.i.i.i = getelementptr i8, ptr %.430, i64 %sunkaddr77.i.i.i
  %sunkaddr79.i.i.i = getelementptr i8, ptr %sunkaddr78.i.i.i, i64 12224
  store <8 x double> %.1652.1.i.i.i, ptr %sunkaddr79.i.i.i, align 8, !noalias !98
  %.1692.1.i.i.i = load double, ptr %sunkaddr72.i.i.i, align 8, !noalias !98
  %.1693.1.i.i.i = insertelement <8 x double> poison, double %.1692.1.i.i.i, i64 0
  %.1694.1.i.i.i = shufflevector <8 x double> %.1693.1.i.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %sunkaddr86.i.i.i = getelementptr i8, ptr %sunkaddr78.i.i.i, i64 13248
  store <8 x double> %.1694.1.i.i.i, ptr %sunkaddr86.i.i.i, align 8, !noalias !98
  %lsr.iv.next30.i.i.i = add i64 %lsr.iv.i2.i.i, -2
  %niter.ncmp.1.not.i.i.i = icmp eq i64 %lsr.iv.next30.i.i.i, 0
  br i1 %niter.ncmp.1.not.i.i.i, label %common.ret.loopexit52.unr-lcssa.i.i.i, label %B688.if.i.i.i

_ZN17bnserve_inference14adjoint_kernel7_source10_fill_barsB4v296B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i.i: ; preds = %B544.i.i.i, %B688.if.epil.preheader.i.i.i, %common.ret.loopexit52.unr-lcssa.i.i.i, %B470.if.epil.preheader.i.i.i, %common.ret.loopexit.unr-lcssa.i.i.i, %B266.i.i.i
  %.1154.i.i = uitofp nneg i64 %.1086800810.i.i to double
  %.1155.i.i249 = fmul contract double %.455747.i.i, %.1154.i.i
  %.1157.i.i = fadd contract double %.1227.i, %.1155.i.i249
  br i1 %381, label %B884.i.i, label %B992.i.i

B382.i.i.i:                                       ; preds = %B382.lr.ph.i.i.i, %B382.i.i.i
  %lsr.iv.i.i.i289 = phi i64 [ %.116.i.i194, %B382.lr.ph.i.i.i ], [ %lsr.iv.next.i.i.i290, %B382.i.i.i ]
  %.679.sroa.0.0385.i.i.i = phi i64 [ 0, %B382.lr.ph.i.i.i ], [ %.679.sroa.0.0.i.i.i, %B382.i.i.i ]
  %.695954383.i.i.i = phi i64 [ 8, %B382.lr.ph.i.i.i ], [ %.695954.i.i.i, %B382.i.i.i ]
  %.734.i.i.i = getelementptr inbounds double, ptr %.290.i32.i, i64 %.679.sroa.0.0385.i.i.i
  %.736.i.i.i = load <8 x double>, ptr %.734.i.i.i, align 8, !noalias !101
  %.8.i.i.i.i = fmul contract <8 x double> %.736.i.i.i, splat (double 0xC01921FB54442D18)
  %.8.i412.i.i.i = fmul contract <8 x double> %.7.i.i.i.i, %.8.i.i.i.i
  %.792.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i412.i.i.i, <8 x double> splat (double 0x3FE45F306DC9C883), <8 x double> splat (double 0x4338000000000000))
  %.8.i413.i.i.i = fadd contract <8 x double> %.792.i.i.i, splat (double 0xC338000000000000)
  %.833.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i413.i.i.i, <8 x double> splat (double 0xBFF921FB54442D18), <8 x double> %.8.i412.i.i.i)
  %.850.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i413.i.i.i, <8 x double> splat (double 0xBC91A62633145C07), <8 x double> %.833.i.i.i)
  %.6.i414.i.i.i = fmul contract <8 x double> %.850.i.i.i, %.850.i.i.i
  %.6.i415.i.i.i = fmul contract <8 x double> %.850.i.i.i, %.6.i414.i.i.i
  %.879.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i414.i.i.i, <8 x double> splat (double 0xBD6AE7F3E733B81F), <8 x double> splat (double 0x3DE6124613A86D09))
  %.882.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i414.i.i.i, <8 x double> %.879.i.i.i, <8 x double> splat (double 0xBE5AE64567F544E4))
  %.885.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i414.i.i.i, <8 x double> %.882.i.i.i, <8 x double> splat (double 0x3EC71DE3A556C734))
  %.888.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i414.i.i.i, <8 x double> %.885.i.i.i, <8 x double> splat (double 0xBF2A01A01A01A01A))
  %.891.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i414.i.i.i, <8 x double> %.888.i.i.i, <8 x double> splat (double 0x3F81111111111111))
  %.894.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i414.i.i.i, <8 x double> %.891.i.i.i, <8 x double> splat (double 0xBFC5555555555555))
  %.919.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i415.i.i.i, <8 x double> %.894.i.i.i, <8 x double> %.850.i.i.i)
  %.924.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i414.i.i.i, <8 x double> splat (double 0x3D2AE7F3E733B81F), <8 x double> splat (double 0xBDA93974A8C07C9D))
  %.927.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i414.i.i.i, <8 x double> %.924.i.i.i, <8 x double> splat (double 0x3E21EED8EFF8D898))
  %.930.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i414.i.i.i, <8 x double> %.927.i.i.i, <8 x double> splat (double 0xBE927E4FB7789F5C))
  %.933.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i414.i.i.i, <8 x double> %.930.i.i.i, <8 x double> splat (double 0x3EFA01A01A01A01A))
  %.936.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i414.i.i.i, <8 x double> %.933.i.i.i, <8 x double> splat (double 0xBF56C16C16C16C17))
  %.939.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i414.i.i.i, <8 x double> %.936.i.i.i, <8 x double> splat (double 0x3FA5555555555555))
  %.942.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i414.i.i.i, <8 x double> %.939.i.i.i, <8 x double> splat (double -5.000000e-01))
  %.945.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i414.i.i.i, <8 x double> %.942.i.i.i, <8 x double> splat (double 1.000000e+00))
  %.946.i.i.i = bitcast <8 x double> %.792.i.i.i to <8 x i64>
  %.947.i.i.i = bitcast <8 x double> %.919.i.i.i to <8 x i64>
  %.948.i.i.i = bitcast <8 x double> %.945.i.i.i to <8 x i64>
  %.6.i416.i.i.i = xor <8 x i64> %.948.i.i.i, %.947.i.i.i
  %.8.i417.i.i.i = and <8 x i64> %.946.i.i.i, splat (i64 1)
  %398 = icmp eq <8 x i64> %.8.i417.i.i.i, zeroinitializer
  %.6.i419.i.i.i = select <8 x i1> %398, <8 x i64> zeroinitializer, <8 x i64> %.6.i416.i.i.i
  %.8.i420.i.i.i = shl <8 x i64> %.946.i.i.i, splat (i64 62)
  %.8.i421.i.i.i = and <8 x i64> %.8.i420.i.i.i, splat (i64 -9223372036854775808)
  %.8.i423.i.i.i = add <8 x i64> %.8.i420.i.i.i, splat (i64 4611686018427387904)
  %.8.i424.i.i.i = and <8 x i64> %.8.i423.i.i.i, splat (i64 -9223372036854775808)
  %399 = xor <8 x i64> %.8.i421.i.i.i, %.947.i.i.i
  %.6.i426.i.i.i = xor <8 x i64> %399, %.6.i419.i.i.i
  %400 = bitcast <8 x i64> %.6.i426.i.i.i to <8 x double>
  %401 = xor <8 x i64> %.8.i424.i.i.i, %.948.i.i.i
  %.6.i428.i.i.i = xor <8 x i64> %401, %.6.i419.i.i.i
  %402 = bitcast <8 x i64> %.6.i428.i.i.i to <8 x double>
  %sunkaddr.i.i.i = shl i64 %.679.sroa.0.0385.i.i.i, 3
  %sunkaddr487.i.i.i = getelementptr inbounds i8, ptr %.430, i64 %sunkaddr.i.i.i
  %sunkaddr488.i.i.i = getelementptr inbounds nuw i8, ptr %sunkaddr487.i.i.i, i64 12288
  %.1293.i.i.i = load <8 x double>, ptr %sunkaddr488.i.i.i, align 8, !noalias !101
  %sunkaddr491.i.i.i = getelementptr inbounds nuw i8, ptr %sunkaddr487.i.i.i, i64 13312
  %.1303.i.i.i = load <8 x double>, ptr %sunkaddr491.i.i.i, align 8, !noalias !101
  %403 = fneg contract <8 x double> %400
  %.8.i430.i.i.i = fmul contract <8 x double> %.1303.i.i.i, %403
  %.1352.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1293.i.i.i, <8 x double> %402, <8 x double> %.8.i430.i.i.i)
  %.6.i431.i.i.i = fmul contract <8 x double> %.1303.i.i.i, %402
  %.1377.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1293.i.i.i, <8 x double> %400, <8 x double> %.6.i431.i.i.i)
  %.1406.i.i.i = getelementptr inbounds double, ptr %.1178.i.i, i64 %.679.sroa.0.0385.i.i.i
  %.1408.i.i.i = load <8 x double>, ptr %.1406.i.i.i, align 8, !noalias !101
  %.1416.i.i.i = getelementptr inbounds double, ptr %.1244.i.i, i64 %.679.sroa.0.0385.i.i.i
  %.1418.i.i.i = load <8 x double>, ptr %.1416.i.i.i, align 8, !noalias !101
  %404 = fneg contract <8 x double> %.1377.i.i.i
  %.8.i433.i.i.i = fmul contract <8 x double> %.1418.i.i.i, %404
  %.1467.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1408.i.i.i, <8 x double> %.1352.i.i.i, <8 x double> %.8.i433.i.i.i)
  %.6.i434.i.i.i = fmul contract <8 x double> %.1418.i.i.i, %.1352.i.i.i
  %.1492.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1408.i.i.i, <8 x double> %.1377.i.i.i, <8 x double> %.6.i434.i.i.i)
  %sunkaddr494.i.i.i = getelementptr inbounds nuw i8, ptr %sunkaddr487.i.i.i, i64 6144
  %.1522.i.i.i = load <8 x double>, ptr %sunkaddr494.i.i.i, align 8, !noalias !101
  %.6.i435.i.i.i = fadd contract <8 x double> %.1522.i.i.i, %.1467.i.i.i
  store <8 x double> %.6.i435.i.i.i, ptr %sunkaddr494.i.i.i, align 8, !noalias !101
  %sunkaddr497.i.i.i = getelementptr inbounds nuw i8, ptr %sunkaddr487.i.i.i, i64 7168
  %.1566.i.i.i = load <8 x double>, ptr %sunkaddr497.i.i.i, align 8, !noalias !101
  %.6.i436.i.i.i = fadd contract <8 x double> %.1566.i.i.i, %.1492.i.i.i
  store <8 x double> %.6.i436.i.i.i, ptr %sunkaddr497.i.i.i, align 8, !noalias !101
  %sunkaddr500.i.i.i = getelementptr inbounds nuw i8, ptr %sunkaddr487.i.i.i, i64 8192
  %.1610.i.i.i = load <8 x double>, ptr %sunkaddr500.i.i.i, align 8, !noalias !101
  %.6.i437.i.i.i = fmul contract <8 x double> %.8.i.i.i.i, %.1492.i.i.i
  %.6.i438.i.i.i = fsub contract <8 x double> %.1610.i.i.i, %.6.i437.i.i.i
  store <8 x double> %.6.i438.i.i.i, ptr %sunkaddr500.i.i.i, align 8, !noalias !101
  %sunkaddr503.i.i.i = getelementptr inbounds nuw i8, ptr %sunkaddr487.i.i.i, i64 9216
  %.1678.i.i.i = load <8 x double>, ptr %sunkaddr503.i.i.i, align 8, !noalias !101
  %.1679.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i.i.i.i, <8 x double> %.1467.i.i.i, <8 x double> %.1678.i.i.i)
  store <8 x double> %.1679.i.i.i, ptr %sunkaddr503.i.i.i, align 8, !noalias !101
  %.689.i.i.i = icmp samesign ugt i64 %lsr.iv.i.i.i289, 1
  %.702.i.i.i = add i64 %.695954383.i.i.i, 8
  %.695954.i.i.i = select i1 %.689.i.i.i, i64 %.702.i.i.i, i64 %.695954383.i.i.i
  %.679.sroa.0.0.i.i.i = select i1 %.689.i.i.i, i64 %.695954383.i.i.i, i64 0
  %lsr.iv.next.i.i.i290 = add nsw i64 %lsr.iv.i.i.i289, -1
  %B382.termcond.i.i.i = icmp sgt i64 %lsr.iv.i.i.i289, 1
  br i1 %B382.termcond.i.i.i, label %B382.i.i.i, label %B1112.i.i

B382.lr.ph.i.i.i:                                 ; preds = %B884.i.i
  %.6.i.i.i.i = insertelement <8 x double> poison, double %.1157.i.i, i64 0
  %.7.i.i.i.i = shufflevector <8 x double> %.6.i.i.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  br label %B382.i.i.i

B394.i.i.i:                                       ; preds = %B394.lr.ph.i.i.i, %B394.i.i.i
  %lsr.iv.i57.i.i = phi i64 [ %.116.i.i194, %B394.lr.ph.i.i.i ], [ %lsr.iv.next.i64.i.i, %B394.i.i.i ]
  %.735.sroa.0.0673.i.i.i = phi i64 [ 0, %B394.lr.ph.i.i.i ], [ %.735.sroa.0.0.i.i.i, %B394.i.i.i ]
  %.7511582671.i.i.i = phi i64 [ 8, %B394.lr.ph.i.i.i ], [ %.7511582.i.i.i, %B394.i.i.i ]
  %.790.i.i.i = getelementptr inbounds double, ptr %.290.i32.i, i64 %.735.sroa.0.0673.i.i.i
  %.792.i58.i.i = load <8 x double>, ptr %.790.i.i.i, align 8, !noalias !104
  %.8.i.i59.i.i = fmul contract <8 x double> %.792.i58.i.i, splat (double 0xC01921FB54442D18)
  %.8.i700.i.i.i = fmul contract <8 x double> %.7.i.i56.i.i, %.8.i.i59.i.i
  %.848.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i700.i.i.i, <8 x double> splat (double 0x3FE45F306DC9C883), <8 x double> splat (double 0x4338000000000000))
  %.8.i701.i.i.i = fadd contract <8 x double> %.848.i.i.i, splat (double 0xC338000000000000)
  %.889.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i701.i.i.i, <8 x double> splat (double 0xBFF921FB54442D18), <8 x double> %.8.i700.i.i.i)
  %.906.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i701.i.i.i, <8 x double> splat (double 0xBC91A62633145C07), <8 x double> %.889.i.i.i)
  %.6.i702.i.i.i = fmul contract <8 x double> %.906.i.i.i, %.906.i.i.i
  %.6.i703.i.i.i = fmul contract <8 x double> %.906.i.i.i, %.6.i702.i.i.i
  %.935.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i702.i.i.i, <8 x double> splat (double 0xBD6AE7F3E733B81F), <8 x double> splat (double 0x3DE6124613A86D09))
  %.938.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i702.i.i.i, <8 x double> %.935.i.i.i, <8 x double> splat (double 0xBE5AE64567F544E4))
  %.941.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i702.i.i.i, <8 x double> %.938.i.i.i, <8 x double> splat (double 0x3EC71DE3A556C734))
  %.944.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i702.i.i.i, <8 x double> %.941.i.i.i, <8 x double> splat (double 0xBF2A01A01A01A01A))
  %.947.i60.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i702.i.i.i, <8 x double> %.944.i.i.i, <8 x double> splat (double 0x3F81111111111111))
  %.950.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i702.i.i.i, <8 x double> %.947.i60.i.i, <8 x double> splat (double 0xBFC5555555555555))
  %.975.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i703.i.i.i, <8 x double> %.950.i.i.i, <8 x double> %.906.i.i.i)
  %.980.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i702.i.i.i, <8 x double> splat (double 0x3D2AE7F3E733B81F), <8 x double> splat (double 0xBDA93974A8C07C9D))
  %.983.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i702.i.i.i, <8 x double> %.980.i.i.i, <8 x double> splat (double 0x3E21EED8EFF8D898))
  %.986.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i702.i.i.i, <8 x double> %.983.i.i.i, <8 x double> splat (double 0xBE927E4FB7789F5C))
  %.989.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i702.i.i.i, <8 x double> %.986.i.i.i, <8 x double> splat (double 0x3EFA01A01A01A01A))
  %.992.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i702.i.i.i, <8 x double> %.989.i.i.i, <8 x double> splat (double 0xBF56C16C16C16C17))
  %.995.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i702.i.i.i, <8 x double> %.992.i.i.i, <8 x double> splat (double 0x3FA5555555555555))
  %.998.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i702.i.i.i, <8 x double> %.995.i.i.i, <8 x double> splat (double -5.000000e-01))
  %.1001.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i702.i.i.i, <8 x double> %.998.i.i.i, <8 x double> splat (double 1.000000e+00))
  %.1002.i.i.i = bitcast <8 x double> %.848.i.i.i to <8 x i64>
  %.1003.i.i.i = bitcast <8 x double> %.975.i.i.i to <8 x i64>
  %.1004.i.i.i = bitcast <8 x double> %.1001.i.i.i to <8 x i64>
  %.6.i704.i.i.i = xor <8 x i64> %.1004.i.i.i, %.1003.i.i.i
  %.8.i705.i.i.i = and <8 x i64> %.1002.i.i.i, splat (i64 1)
  %405 = icmp eq <8 x i64> %.8.i705.i.i.i, zeroinitializer
  %.6.i707.i.i.i = select <8 x i1> %405, <8 x i64> zeroinitializer, <8 x i64> %.6.i704.i.i.i
  %.8.i708.i.i.i = shl <8 x i64> %.1002.i.i.i, splat (i64 62)
  %.8.i709.i.i.i = and <8 x i64> %.8.i708.i.i.i, splat (i64 -9223372036854775808)
  %.8.i711.i.i.i = add <8 x i64> %.8.i708.i.i.i, splat (i64 4611686018427387904)
  %.8.i712.i.i.i = and <8 x i64> %.8.i711.i.i.i, splat (i64 -9223372036854775808)
  %406 = xor <8 x i64> %.8.i709.i.i.i, %.1003.i.i.i
  %.6.i714.i.i.i = xor <8 x i64> %406, %.6.i707.i.i.i
  %407 = bitcast <8 x i64> %.6.i714.i.i.i to <8 x double>
  %408 = xor <8 x i64> %.8.i712.i.i.i, %.1004.i.i.i
  %.6.i716.i.i.i = xor <8 x i64> %408, %.6.i707.i.i.i
  %409 = bitcast <8 x i64> %.6.i716.i.i.i to <8 x double>
  %sunkaddr.i61.i.i = shl i64 %.735.sroa.0.0673.i.i.i, 3
  %sunkaddr792.i.i.i = getelementptr inbounds i8, ptr %.430, i64 %sunkaddr.i61.i.i
  %sunkaddr793.i.i.i = getelementptr inbounds nuw i8, ptr %sunkaddr792.i.i.i, i64 12288
  %.1349.i.i.i = load <8 x double>, ptr %sunkaddr793.i.i.i, align 8, !noalias !104
  %sunkaddr796.i.i.i = getelementptr inbounds nuw i8, ptr %sunkaddr792.i.i.i, i64 13312
  %.1359.i.i.i = load <8 x double>, ptr %sunkaddr796.i.i.i, align 8, !noalias !104
  %410 = fneg contract <8 x double> %407
  %.8.i718.i.i.i = fmul contract <8 x double> %.1359.i.i.i, %410
  %.1408.i62.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1349.i.i.i, <8 x double> %409, <8 x double> %.8.i718.i.i.i)
  %.6.i719.i.i.i = fmul contract <8 x double> %.1359.i.i.i, %409
  %.1433.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1349.i.i.i, <8 x double> %407, <8 x double> %.6.i719.i.i.i)
  %.1455.i.i.i = add nsw i64 %.735.sroa.0.0673.i.i.i, %.267.i.i.i
  %.1459.i.i.i = add nsw i64 %.735.sroa.0.0673.i.i.i, %.1458.i.i.i
  %gep.i.i.i = getelementptr double, ptr %invariant.gep.i.i.i, i64 %.1455.i.i.i
  %.1483.i.i.i = load <8 x double>, ptr %gep.i.i.i, align 8, !noalias !104
  %.1491.i.i.i = getelementptr inbounds double, ptr %380, i64 %.1455.i.i.i
  %.1493.i.i.i = load <8 x double>, ptr %.1491.i.i.i, align 8, !noalias !104
  %.8.i722.i.i.i = fmul contract <8 x double> %.7.i721.i.i.i, %.1493.i.i.i
  %.1521.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1483.i.i.i, <8 x double> %.1520.i.i.i, <8 x double> %.8.i722.i.i.i)
  %gep1622.i.i.i = getelementptr double, ptr %invariant.gep1621.i.i.i, i64 %.1455.i.i.i
  %.1532.i.i.i = load <8 x double>, ptr %gep1622.i.i.i, align 8, !noalias !104
  %gep1624.i.i.i = getelementptr double, ptr %invariant.gep1623.i.i.i, i64 %.1455.i.i.i
  %.1544.i.i.i = load <8 x double>, ptr %gep1624.i.i.i, align 8, !noalias !104
  %.1548.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1544.i.i.i, <8 x double> %.1547.i.i.i, <8 x double> %.1521.i.i.i)
  %.1551.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1532.i.i.i, <8 x double> %.1550.i.i.i, <8 x double> %.1548.i.i.i)
  %gep1626.i.i.i = getelementptr double, ptr %invariant.gep1625.i.i.i, i64 %.1455.i.i.i
  %.1562.i.i.i = load <8 x double>, ptr %gep1626.i.i.i, align 8, !noalias !104
  %gep1628.i.i.i = getelementptr double, ptr %invariant.gep1627.i.i.i, i64 %.1455.i.i.i
  %.1574.i.i.i = load <8 x double>, ptr %gep1628.i.i.i, align 8, !noalias !104
  %.1587.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1574.i.i.i, <8 x double> %.1586.i.i.i, <8 x double> %.1551.i.i.i)
  %.1590.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1562.i.i.i, <8 x double> %.1589.i.i.i, <8 x double> %.1587.i.i.i)
  %gep1542.i.i.i = getelementptr double, ptr %invariant.gep.i.i.i, i64 %.1459.i.i.i
  %.1613.i.i.i = load <8 x double>, ptr %gep1542.i.i.i, align 8, !noalias !104
  %.1621.i.i.i = getelementptr inbounds double, ptr %380, i64 %.1459.i.i.i
  %.1623.i.i.i = load <8 x double>, ptr %.1621.i.i.i, align 8, !noalias !104
  %.8.i725.i.i.i = fmul contract <8 x double> %.7.i721.i.i.i, %.1623.i.i.i
  %.1651.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1613.i.i.i, <8 x double> %.1520.i.i.i, <8 x double> %.8.i725.i.i.i)
  %gep1630.i.i.i = getelementptr double, ptr %invariant.gep1621.i.i.i, i64 %.1459.i.i.i
  %.1662.i.i.i = load <8 x double>, ptr %gep1630.i.i.i, align 8, !noalias !104
  %gep1632.i.i.i = getelementptr double, ptr %invariant.gep1623.i.i.i, i64 %.1459.i.i.i
  %.1674.i.i.i = load <8 x double>, ptr %gep1632.i.i.i, align 8, !noalias !104
  %.1678.i63.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1674.i.i.i, <8 x double> %.1547.i.i.i, <8 x double> %.1651.i.i.i)
  %.1681.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1662.i.i.i, <8 x double> %.1550.i.i.i, <8 x double> %.1678.i63.i.i)
  %gep1634.i.i.i = getelementptr double, ptr %invariant.gep1625.i.i.i, i64 %.1459.i.i.i
  %.1692.i.i.i = load <8 x double>, ptr %gep1634.i.i.i, align 8, !noalias !104
  %gep1636.i.i.i = getelementptr double, ptr %invariant.gep1627.i.i.i, i64 %.1459.i.i.i
  %.1704.i.i.i = load <8 x double>, ptr %gep1636.i.i.i, align 8, !noalias !104
  %.1717.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1704.i.i.i, <8 x double> %.1586.i.i.i, <8 x double> %.1681.i.i.i)
  %.1720.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1692.i.i.i, <8 x double> %.1589.i.i.i, <8 x double> %.1717.i.i.i)
  %411 = fneg contract <8 x double> %.1433.i.i.i
  %.8.i727.i.i.i = fmul contract <8 x double> %.1720.i.i.i, %411
  %.1769.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1590.i.i.i, <8 x double> %.1408.i62.i.i, <8 x double> %.8.i727.i.i.i)
  %.6.i728.i.i.i = fmul contract <8 x double> %.1720.i.i.i, %.1408.i62.i.i
  %.1794.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1590.i.i.i, <8 x double> %.1433.i.i.i, <8 x double> %.6.i728.i.i.i)
  %.8.i731.i.i.i = fmul contract <8 x double> %.7.i730.i.i.i, %.1493.i.i.i
  %.1876.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1483.i.i.i, <8 x double> %.1875.i.i.i, <8 x double> %.8.i731.i.i.i)
  %.1903.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1544.i.i.i, <8 x double> %.1902.i.i.i, <8 x double> %.1876.i.i.i)
  %.1906.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1532.i.i.i, <8 x double> %.1905.i.i.i, <8 x double> %.1903.i.i.i)
  %.1942.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1574.i.i.i, <8 x double> %.1941.i.i.i, <8 x double> %.1906.i.i.i)
  %.1945.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1562.i.i.i, <8 x double> %.1944.i.i.i, <8 x double> %.1942.i.i.i)
  %.8.i734.i.i.i = fmul contract <8 x double> %.7.i730.i.i.i, %.1623.i.i.i
  %.2006.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1613.i.i.i, <8 x double> %.1875.i.i.i, <8 x double> %.8.i734.i.i.i)
  %.2033.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1674.i.i.i, <8 x double> %.1902.i.i.i, <8 x double> %.2006.i.i.i)
  %.2036.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1662.i.i.i, <8 x double> %.1905.i.i.i, <8 x double> %.2033.i.i.i)
  %.2072.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1704.i.i.i, <8 x double> %.1941.i.i.i, <8 x double> %.2036.i.i.i)
  %.2075.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1692.i.i.i, <8 x double> %.1944.i.i.i, <8 x double> %.2072.i.i.i)
  %.8.i736.i.i.i = fmul contract <8 x double> %.2075.i.i.i, %411
  %.2124.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1945.i.i.i, <8 x double> %.1408.i62.i.i, <8 x double> %.8.i736.i.i.i)
  %.6.i737.i.i.i = fmul contract <8 x double> %.2075.i.i.i, %.1408.i62.i.i
  %.2149.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1945.i.i.i, <8 x double> %.1433.i.i.i, <8 x double> %.6.i737.i.i.i)
  %sunkaddr799.i.i.i = getelementptr inbounds nuw i8, ptr %sunkaddr792.i.i.i, i64 6144
  %.2179.i.i.i = load <8 x double>, ptr %sunkaddr799.i.i.i, align 8, !noalias !104
  %.6.i738.i.i.i = fadd contract <8 x double> %.2179.i.i.i, %.1769.i.i.i
  store <8 x double> %.6.i738.i.i.i, ptr %sunkaddr799.i.i.i, align 8, !noalias !104
  %sunkaddr802.i.i.i = getelementptr inbounds nuw i8, ptr %sunkaddr792.i.i.i, i64 7168
  %.2223.i.i.i = load <8 x double>, ptr %sunkaddr802.i.i.i, align 8, !noalias !104
  %.6.i739.i.i.i = fadd contract <8 x double> %.2223.i.i.i, %.1794.i.i.i
  store <8 x double> %.6.i739.i.i.i, ptr %sunkaddr802.i.i.i, align 8, !noalias !104
  %sunkaddr805.i.i.i = getelementptr inbounds nuw i8, ptr %sunkaddr792.i.i.i, i64 8192
  %.2267.i.i.i = load <8 x double>, ptr %sunkaddr805.i.i.i, align 8, !noalias !104
  %.6.i740.i.i.i = fmul contract <8 x double> %.8.i.i59.i.i, %.1794.i.i.i
  %.6.i741.i.i.i = fsub contract <8 x double> %.2124.i.i.i, %.6.i740.i.i.i
  %.6.i742.i.i.i = fadd contract <8 x double> %.2267.i.i.i, %.6.i741.i.i.i
  store <8 x double> %.6.i742.i.i.i, ptr %sunkaddr805.i.i.i, align 8, !noalias !104
  %sunkaddr808.i.i.i = getelementptr inbounds nuw i8, ptr %sunkaddr792.i.i.i, i64 9216
  %.2359.i.i.i = load <8 x double>, ptr %sunkaddr808.i.i.i, align 8, !noalias !104
  %.2360.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i.i59.i.i, <8 x double> %.1769.i.i.i, <8 x double> %.2149.i.i.i)
  %.6.i743.i.i.i = fadd contract <8 x double> %.2359.i.i.i, %.2360.i.i.i
  store <8 x double> %.6.i743.i.i.i, ptr %sunkaddr808.i.i.i, align 8, !noalias !104
  %.745.i.i.i = icmp samesign ugt i64 %lsr.iv.i57.i.i, 1
  %.758.i.i.i = add i64 %.7511582671.i.i.i, 8
  %.7511582.i.i.i = select i1 %.745.i.i.i, i64 %.758.i.i.i, i64 %.7511582671.i.i.i
  %.735.sroa.0.0.i.i.i = select i1 %.745.i.i.i, i64 %.7511582671.i.i.i, i64 0
  %lsr.iv.next.i64.i.i = add nsw i64 %lsr.iv.i57.i.i, -1
  %B394.termcond.i.i.i = icmp sgt i64 %lsr.iv.i57.i.i, 1
  br i1 %B394.termcond.i.i.i, label %B394.i.i.i, label %B1112.i.i

B394.lr.ph.i.i.i:                                 ; preds = %B992.i.i
  %.1682.i.i = fneg contract double %.183.i.i.i
  %.1683.i.i = fmul contract double %.183.i.i.i, %.1682.i.i
  %.1684.i.i = fmul contract double %.183.i.i.i, %.1683.i.i
  %.1685.i.i = fmul contract double %.183.i.i.i, %.1684.i.i
  %.1686.i.i = fmul contract double %.1651.i.i, %.1685.i.i
  %.186.i.i.i = fmul contract double %.183.i.i.i, %.185.i.i.i
  %.187.i.i.i = fmul contract double %.183.i.i.i, %.186.i.i.i
  %.191.i.i.i = fdiv contract double %.187.i.i.i, 1.200000e+02
  %.6.i.i55.i.i = insertelement <8 x double> poison, double %.1157.i.i, i64 0
  %.7.i.i56.i.i = shufflevector <8 x double> %.6.i.i55.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.6.i720.i.i.i = insertelement <8 x double> poison, double %.191.i.i.i, i64 0
  %.7.i721.i.i.i = shufflevector <8 x double> %.6.i720.i.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.6.i729.i.i.i = insertelement <8 x double> poison, double %.1686.i.i, i64 0
  %.7.i730.i.i.i = shufflevector <8 x double> %.6.i729.i.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  br label %B394.i.i.i

_ZN17bnserve_inference14adjoint_kernel7_source16_through_weightsB4v285B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxxx5ArrayIxLi1E1C7mutable7alignedEd5ArrayIdLi1E1C7mutable7alignedE.exit.i: ; preds = %B1112.i.i, %B604.loopexit.3.i.i
  %.74.i.i = load i64, ptr %.76, align 8, !noalias !107
  %.190.i.i = add nsw i64 %.74.i.i, 1
  %.192.i.i = mul nsw i64 %.190.i.i, %.74.i.i
  %.272.i39.i = and i64 %.192.i.i, -2
  %.412887.not.i.i = icmp slt i64 %.74.i.i, 1
  br i1 %.412887.not.i.i, label %_ZN17bnserve_inference14adjoint_kernel7_source14_through_pairsB4v343B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i, label %B290.if.lr.ph.i.i

B290.loopexit.i.i:                                ; preds = %B1078.i.i
  %.425.i.i = add nuw nsw i64 %.356.0.i.i, 1
  %scevgep267.i.i = getelementptr i8, ptr %lsr.iv.i42.i, i64 27648
  %exitcond262.not.i.i = icmp eq i64 %.425.i.i, %.74.i.i
  br i1 %exitcond262.not.i.i, label %_ZN17bnserve_inference14adjoint_kernel7_source14_through_pairsB4v343B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i, label %B290.if.i.i

B836.i.i:                                         ; preds = %B274.i.i.i, %B328.if.i.i
  br i1 %brmerge1.i.i, label %B1078.i.i, label %B174.if.preheader.i117.i.i

B1078.i.i:                                        ; preds = %B274.i130.i.i, %B836.i.i
  %.1704.i.i = add nsw i64 %at.2.1884.i.i, 1
  %scevgep276.i.i = getelementptr i8, ptr %lsr.iv275.i.i, i64 27648
  %exitcond.not.i55.i = icmp eq i64 %.553.i.i258, %.74.i.i
  br i1 %exitcond.not.i55.i, label %B290.loopexit.i.i, label %B328.if.i.i

B290.if.lr.ph.i.i:                                ; preds = %_ZN17bnserve_inference14adjoint_kernel7_source16_through_weightsB4v285B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxxx5ArrayIxLi1E1C7mutable7alignedEd5ArrayIdLi1E1C7mutable7alignedE.exit.i
  %.200.1.i.i = lshr i64 %.192.i.i, 1
  %.269.i40.i = mul i64 %.268.i.i238, %.200.1.i.i
  %.266.i.i253 = load i64, ptr %.265.i.i239, align 8, !noalias !107
  %.270.i.i254 = add nsw i64 %.266.i.i253, %.269.i40.i
  %.178.i.i255 = load i64, ptr %.500.i.i235, align 8, !noalias !107
  %412 = icmp eq i64 %.178.i.i255, 1
  %.105.i.i = load i64, ptr %.140, align 8, !noalias !107
  %.106.i.i = sub i64 0, %.105.i.i
  %.114.1.i.i = and i64 %.106.i.i, -8
  %.148.i.i256 = sub i64 0, %.114.1.i.i
  %.585.i.i = mul nsw i64 %.1282920924, %.148.i.i256
  %.591.i.i257 = shl nsw i64 %.148.i.i256, 1
  %.594.i.i = mul nuw nsw i64 %.200.1.i.i, %.1282920924
  %413 = mul i64 %.114.1.i.i, -8
  %414 = select i1 %412, i64 0, i64 %413
  %415 = inttoptr i64 %.270.i.i254 to ptr
  br label %B290.if.i.i

B290.if.i.i:                                      ; preds = %B290.if.lr.ph.i.i, %B290.loopexit.i.i
  %lsr.iv.i42.i = phi ptr [ %scevgep266.i.i, %B290.if.lr.ph.i.i ], [ %scevgep267.i.i, %B290.loopexit.i.i ]
  %.356.0.i.i = phi i64 [ 0, %B290.if.lr.ph.i.i ], [ %.425.i.i, %B290.loopexit.i.i ]
  %at.3.0888.i.i = phi i64 [ 0, %B290.if.lr.ph.i.i ], [ %.1704.i.i, %B290.loopexit.i.i ]
  %416 = icmp ne i64 %.356.0.i.i, %.1072818825.i
  %brmerge1.i.i = select i1 %416, i1 true, i1 %.93.inv.i.i
  br label %B328.if.i.i

B328.if.i.i:                                      ; preds = %B290.if.i.i, %B1078.i.i
  %lsr.iv275.i.i = phi ptr [ %lsr.iv.i42.i, %B290.if.i.i ], [ %scevgep276.i.i, %B1078.i.i ]
  %.484.0.i.i = phi i64 [ %.356.0.i.i, %B290.if.i.i ], [ %.553.i.i258, %B1078.i.i ]
  %at.2.1884.i.i = phi i64 [ %at.3.0888.i.i, %B290.if.i.i ], [ %.1704.i.i, %B1078.i.i ]
  %.553.i.i258 = add nuw i64 %.484.0.i.i, 1
  %.596.i.i259 = add nsw i64 %at.2.1884.i.i, %.594.i.i
  %.597.i.i = mul nsw i64 %.591.i.i257, %.596.i.i259
  %"$phi374.2.2.2.i.i" = select i1 %412, i64 %.585.i.i, i64 %.597.i.i
  %.634.i.i = load i64, ptr %sunkaddr12.i41.i, align 8, !noalias !107
  %.635.i.i = shl nsw i64 %"$phi374.2.2.2.i.i", 3
  %.636.i.i260 = add nsw i64 %.635.i.i, %.634.i.i
  %.639.i.i = inttoptr i64 %.636.i.i260 to ptr
  %.805.i.i261 = getelementptr double, ptr %.639.i.i, i64 %.1090933952
  %.873.i.i262 = icmp slt i64 %at.2.1884.i.i, 0
  %.874.i.i = select i1 %.873.i.i262, i64 %.272.i39.i, i64 0
  %.idx57.i.i = shl i64 %at.2.1884.i.i, 4
  %417 = getelementptr i8, ptr %415, i64 %.idx57.i.i
  %.888.i.i = getelementptr double, ptr %417, i64 %.874.i.i
  %.889.i43.i = load double, ptr %.888.i.i, align 8, !noalias !107
  %418 = getelementptr i8, ptr %417, i64 8
  %.921.i.i263 = getelementptr double, ptr %418, i64 %.874.i.i
  %.922.i.i264 = load double, ptr %.921.i.i263, align 8, !noalias !107
  %.951.i.i265 = icmp ne i64 %.484.0.i.i, %.1072818825.i
  %brmerge.i.i = or i1 %.93.inv.i.i, %.951.i.i265
  br i1 %brmerge.i.i, label %B836.i.i, label %B174.if.preheader.i.i.i

B174.if.preheader.i.i.i:                          ; preds = %B328.if.i.i
  %.6.i.i.i44.i = insertelement <8 x double> poison, double %.889.i43.i, i64 0
  %.7.i.i.i45.i = shufflevector <8 x double> %.6.i.i.i44.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.6.i97.i.i.i = insertelement <8 x double> poison, double %.922.i.i264, i64 0
  %.7.i98.i.i.i = shufflevector <8 x double> %.6.i97.i.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %scevgep7.i.i = getelementptr i8, ptr %.805.i.i261, i64 %414
  br label %B174.if.i.i.i

B214.i.i.i:                                       ; preds = %B174.if.i.i.i
  %scevgep8.i.i266 = getelementptr i8, ptr %scevgep7.i.i, i64 %lsr.iv133.i.i.i
  %.478.i.i.i = load <8 x double>, ptr %scevgep8.i.i266, align 8, !noalias !110
  br label %B274.i.i.i

B274.i.i.i:                                       ; preds = %B174.if.i.i.i, %B214.i.i.i
  %"$phi274.1.2.1.i.i.i" = phi <8 x double> [ %.478.i.i.i, %B214.i.i.i ], [ zeroinitializer, %B174.if.i.i.i ]
  %.8.i.i.i46.i = fmul contract <8 x double> %.7.i.i.i45.i, %.462.i.i.i
  %.8.i99.i.i.i = fmul contract <8 x double> %.7.i98.i.i.i, %"$phi274.1.2.1.i.i.i"
  %.6.i100.i.i.i = fsub contract <8 x double> %.8.i.i.i46.i, %.8.i99.i.i.i
  %.8.i103.i.i.i = fmul contract <8 x double> %.7.i98.i.i.i, %.462.i.i.i
  %.8.i106.i.i.i = fmul contract <8 x double> %.7.i.i.i45.i, %"$phi274.1.2.1.i.i.i"
  %.6.i107.i.i.i = fadd contract <8 x double> %.8.i103.i.i.i, %.8.i106.i.i.i
  %scevgep269.i.i = getelementptr i8, ptr %lsr.iv.i42.i, i64 %lsr.iv133.i.i.i
  %scevgep270.i.i = getelementptr i8, ptr %scevgep269.i.i, i64 -1024
  %.678.i.i.i = load <8 x double>, ptr %scevgep270.i.i, align 8, !noalias !110
  %.689.i.i47.i = load <8 x double>, ptr %scevgep269.i.i, align 8, !noalias !110
  %sunkaddr.i48.i = getelementptr i8, ptr %.430, i64 %lsr.iv133.i.i.i
  %sunkaddr13.i49.i = getelementptr i8, ptr %sunkaddr.i48.i, i64 6144
  %.700.i.i.i = load <8 x double>, ptr %sunkaddr13.i49.i, align 8, !noalias !110
  %.6.i111.i.i.i = fmul contract <8 x double> %.689.i.i47.i, %.6.i107.i.i.i
  %.725.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i100.i.i.i, <8 x double> %.678.i.i.i, <8 x double> %.6.i111.i.i.i)
  %.6.i112.i.i.i = fadd contract <8 x double> %.700.i.i.i, %.725.i.i.i
  store <8 x double> %.6.i112.i.i.i, ptr %sunkaddr13.i49.i, align 8, !noalias !110
  %sunkaddr15.i50.i = getelementptr i8, ptr %sunkaddr.i48.i, i64 7168
  %.771.i.i.i = load <8 x double>, ptr %sunkaddr15.i50.i, align 8, !noalias !110
  %.6.i113.i.i.i = fmul contract <8 x double> %.678.i.i.i, %.6.i107.i.i.i
  %.6.i114.i.i.i = fmul contract <8 x double> %.6.i100.i.i.i, %.689.i.i47.i
  %.6.i115.i.i.i = fsub contract <8 x double> %.6.i113.i.i.i, %.6.i114.i.i.i
  %.6.i116.i.i.i = fadd contract <8 x double> %.6.i115.i.i.i, %.771.i.i.i
  store <8 x double> %.6.i116.i.i.i, ptr %sunkaddr15.i50.i, align 8, !noalias !110
  %lsr.iv.next134.i.i.i = add i64 %lsr.iv133.i.i.i, 64
  %lsr.iv.next.i51.i = add nsw i64 %lsr.iv2.i.i, -1
  %.411.i.i.i = icmp sgt i64 %lsr.iv2.i.i, 6
  br i1 %.411.i.i.i, label %B174.if.i.i.i, label %B836.i.i

B174.if.i.i.i:                                    ; preds = %B274.i.i.i, %B174.if.preheader.i.i.i
  %lsr.iv2.i.i = phi i64 [ %lsr.iv.next.i51.i, %B274.i.i.i ], [ %339, %B174.if.preheader.i.i.i ]
  %lsr.iv133.i.i.i = phi i64 [ %lsr.iv.next134.i.i.i, %B274.i.i.i ], [ 0, %B174.if.preheader.i.i.i ]
  %scevgep140.i.i.i = getelementptr i8, ptr %.805.i.i261, i64 %lsr.iv133.i.i.i
  %.462.i.i.i = load <8 x double>, ptr %scevgep140.i.i.i, align 8, !noalias !110
  br i1 %412, label %B274.i.i.i, label %B214.i.i.i

B174.if.preheader.i117.i.i:                       ; preds = %B836.i.i
  %.6.i.i118.i.i = insertelement <8 x double> poison, double %.889.i43.i, i64 0
  %.7.i.i119.i.i = shufflevector <8 x double> %.6.i.i118.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.6.i97.i120.i.i = insertelement <8 x double> poison, double %.922.i.i264, i64 0
  %.7.i98.i121.i.i = shufflevector <8 x double> %.6.i97.i120.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %scevgep13.i.i267 = getelementptr i8, ptr %.805.i.i261, i64 %414
  br label %B174.if.i122.i.i

B214.i127.i.i:                                    ; preds = %B174.if.i122.i.i
  %scevgep14.i.i269 = getelementptr i8, ptr %scevgep13.i.i267, i64 %lsr.iv133.i123.i.i
  %.478.i129.i.i = load <8 x double>, ptr %scevgep14.i.i269, align 8, !noalias !113
  br label %B274.i130.i.i

B274.i130.i.i:                                    ; preds = %B174.if.i122.i.i, %B214.i127.i.i
  %"$phi274.1.2.1.i131.i.i" = phi <8 x double> [ %.478.i129.i.i, %B214.i127.i.i ], [ zeroinitializer, %B174.if.i122.i.i ]
  %.8.i.i132.i.i = fmul contract <8 x double> %.7.i.i119.i.i, %.462.i126.i.i
  %.8.i99.i133.i.i = fmul contract <8 x double> %.7.i98.i121.i.i, %"$phi274.1.2.1.i131.i.i"
  %.6.i100.i134.i.i = fsub contract <8 x double> %.8.i.i132.i.i, %.8.i99.i133.i.i
  %.8.i103.i135.i.i = fmul contract <8 x double> %.7.i98.i121.i.i, %.462.i126.i.i
  %.8.i106.i136.i.i = fmul contract <8 x double> %.7.i.i119.i.i, %"$phi274.1.2.1.i131.i.i"
  %.6.i107.i137.i.i = fadd contract <8 x double> %.8.i103.i135.i.i, %.8.i106.i136.i.i
  %.8.i110.i.i.i = fneg contract <8 x double> %.6.i107.i137.i.i
  %scevgep278.i.i = getelementptr i8, ptr %lsr.iv275.i.i, i64 %lsr.iv133.i123.i.i
  %scevgep279.i.i = getelementptr i8, ptr %scevgep278.i.i, i64 -1024
  %.678.i139.i.i = load <8 x double>, ptr %scevgep279.i.i, align 8, !noalias !113
  %.689.i141.i.i = load <8 x double>, ptr %scevgep278.i.i, align 8, !noalias !113
  %sunkaddr16.i52.i = getelementptr i8, ptr %.430, i64 %lsr.iv133.i123.i.i
  %sunkaddr17.i53.i = getelementptr i8, ptr %sunkaddr16.i52.i, i64 6144
  %.700.i144.i.i = load <8 x double>, ptr %sunkaddr17.i53.i, align 8, !noalias !113
  %.6.i111.i145.i.i = fmul contract <8 x double> %.689.i141.i.i, %.8.i110.i.i.i
  %.725.i146.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i100.i134.i.i, <8 x double> %.678.i139.i.i, <8 x double> %.6.i111.i145.i.i)
  %.6.i112.i147.i.i = fadd contract <8 x double> %.700.i144.i.i, %.725.i146.i.i
  store <8 x double> %.6.i112.i147.i.i, ptr %sunkaddr17.i53.i, align 8, !noalias !113
  %sunkaddr19.i54.i = getelementptr i8, ptr %sunkaddr16.i52.i, i64 7168
  %.771.i149.i.i = load <8 x double>, ptr %sunkaddr19.i54.i, align 8, !noalias !113
  %.6.i113.i150.i.i = fmul contract <8 x double> %.678.i139.i.i, %.8.i110.i.i.i
  %.6.i114.i151.i.i = fmul contract <8 x double> %.6.i100.i134.i.i, %.689.i141.i.i
  %.6.i115.i152.i.i = fsub contract <8 x double> %.6.i113.i150.i.i, %.6.i114.i151.i.i
  %.6.i116.i153.i.i = fadd contract <8 x double> %.6.i115.i152.i.i, %.771.i149.i.i
  store <8 x double> %.6.i116.i153.i.i, ptr %sunkaddr19.i54.i, align 8, !noalias !113
  %lsr.iv.next134.i155.i.i = add i64 %lsr.iv133.i123.i.i, 64
  %lsr.iv.next8.i.i270 = add nsw i64 %lsr.iv7.i.i268, -1
  %.411.i156.i.i = icmp sgt i64 %lsr.iv7.i.i268, 6
  br i1 %.411.i156.i.i, label %B174.if.i122.i.i, label %B1078.i.i

B174.if.i122.i.i:                                 ; preds = %B274.i130.i.i, %B174.if.preheader.i117.i.i
  %lsr.iv7.i.i268 = phi i64 [ %lsr.iv.next8.i.i270, %B274.i130.i.i ], [ %339, %B174.if.preheader.i117.i.i ]
  %lsr.iv133.i123.i.i = phi i64 [ %lsr.iv.next134.i155.i.i, %B274.i130.i.i ], [ 0, %B174.if.preheader.i117.i.i ]
  %scevgep140.i125.i.i = getelementptr i8, ptr %.805.i.i261, i64 %lsr.iv133.i123.i.i
  %.462.i126.i.i = load <8 x double>, ptr %scevgep140.i125.i.i, align 8, !noalias !113
  br i1 %412, label %B274.i130.i.i, label %B214.i127.i.i

_ZN17bnserve_inference14adjoint_kernel7_source14_through_pairsB4v343B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i: ; preds = %B290.loopexit.i.i, %_ZN17bnserve_inference14adjoint_kernel7_source16_through_weightsB4v285B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxxx5ArrayIxLi1E1C7mutable7alignedEd5ArrayIdLi1E1C7mutable7alignedE.exit.i
  br i1 %or.cond.i232, label %B1008.i, label %B268.if.i.i

_ZN17bnserve_inference14adjoint_kernel7_source12_in_detectorB4v131B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxx5ArrayIxLi1E1C7mutable7alignedEd5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit: ; preds = %B1100.i, %_ZN17bnserve_inference14adjoint_kernel5_back15errors_to_nodesB4v468B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i
  call void @llvm.lifetime.end.p0(ptr nonnull %.747.i)
  call void @llvm.lifetime.end.p0(ptr nonnull %.782.i)
  %.1289 = add nuw nsw i64 %.1282920924, 1
  %scevgep = getelementptr i8, ptr %lsr.iv, i64 152
  %scevgep271 = getelementptr i8, ptr %lsr.iv270, i64 200
  %exitcond.not = icmp eq i64 %.47, %.1289
  br i1 %exitcond.not, label %B1212, label %B1040.if

B1254.endif:                                      ; preds = %B244.if.i, %B1254
  %.1607 = load i64, ptr %sunkaddr136, align 8
  %.1608.not = icmp eq i64 %.1607, 0
  br i1 %.1608.not, label %B1412, label %B1334
}

; Function Attrs: mustprogress nocallback nocreateundeforpoison nofree nosync nounwind speculatable willreturn memory(none)
declare i64 @llvm.smin.i64(i64, i64) #2

; Function Attrs: nofree norecurse nosync nounwind memory(argmem: readwrite)
define internal fastcc void @inner_2(ptr noalias nonnull writeonly captures(none) %retptr, ptr readonly captures(none) %arg.k.4, i64 range(i64 17, 22) %arg.first, double %arg.sign, ptr readonly captures(none) %arg.f.4, i64 range(i64 -9223372036854775808, 129) %arg.f.5.0, i64 range(i64 -9223372036854775808, 129) %arg.size, ptr captures(none) %arg.own.4) unnamed_addr #3 {
entry:
  %0 = getelementptr double, ptr %arg.k.4, i64 %arg.first
  %.77 = load double, ptr %0, align 8
  %1 = getelementptr i8, ptr %0, i64 8
  %.107 = load double, ptr %1, align 8
  %2 = getelementptr i8, ptr %0, i64 16
  %.137 = load double, ptr %2, align 8
  %3 = getelementptr i8, ptr %0, i64 24
  %.167 = load double, ptr %3, align 8
  %.231 = getelementptr i8, ptr %arg.k.4, i64 104
  %.232 = load double, ptr %.231, align 8
  %.260 = getelementptr i8, ptr %arg.k.4, i64 112
  %.261 = load double, ptr %.260, align 8
  %.295 = getelementptr i8, ptr %arg.k.4, i64 120
  %.296 = load double, ptr %.295, align 8
  %.324 = getelementptr i8, ptr %arg.k.4, i64 128
  %.325 = load double, ptr %.324, align 8
  %.354 = getelementptr inbounds nuw i8, ptr %arg.own.4, i64 4096
  %.439 = getelementptr inbounds nuw i8, ptr %arg.own.4, i64 5120
  %.784 = fmul contract double %.137, %.296
  %.800 = fmul contract double %.137, %.325
  %.1629 = getelementptr inbounds nuw i8, ptr %arg.own.4, i64 10240
  %.1774 = getelementptr inbounds nuw i8, ptr %arg.own.4, i64 11264
  %.1919 = getelementptr inbounds nuw i8, ptr %arg.own.4, i64 12288
  %.2067 = getelementptr inbounds nuw i8, ptr %arg.own.4, i64 13312
  %.2241 = getelementptr inbounds nuw i8, ptr %arg.own.4, i64 14336
  %.2386 = getelementptr inbounds nuw i8, ptr %arg.own.4, i64 15360
  %.2531 = getelementptr inbounds nuw i8, ptr %arg.own.4, i64 16384
  %.2679 = getelementptr inbounds nuw i8, ptr %arg.own.4, i64 17408
  %.3453 = getelementptr inbounds nuw i8, ptr %arg.own.4, i64 18432
  %.3598 = getelementptr inbounds nuw i8, ptr %arg.own.4, i64 19456
  %.3743 = getelementptr inbounds nuw i8, ptr %arg.own.4, i64 20480
  %.3891 = getelementptr inbounds nuw i8, ptr %arg.own.4, i64 21504
  %.599191 = icmp sgt i64 %arg.size, 0
  br i1 %.599191, label %B380, label %B5202

B380:                                             ; preds = %entry, %B5201
  %lsr.iv = phi i64 [ %lsr.iv.next, %B5201 ], [ 1, %entry ]
  %.589.sroa.0.0196 = phi i64 [ %.589.sroa.0.0, %B5201 ], [ 0, %entry ]
  %.546.1195.in = phi i64 [ %33, %B5201 ], [ %arg.size, %entry ]
  %.654 = icmp slt i64 %.589.sroa.0.0196, 0
  %.655 = select i1 %.654, i64 128, i64 0
  %4 = getelementptr double, ptr %.354, i64 %.589.sroa.0.0196
  %.669 = getelementptr double, ptr %4, i64 %.655
  %.670 = load double, ptr %.669, align 8
  %.672 = fmul contract double %.77, %.670
  %5 = getelementptr double, ptr %.439, i64 %.589.sroa.0.0196
  %.702 = getelementptr double, ptr %5, i64 %.655
  %.703 = load double, ptr %.702, align 8
  %.705 = fmul contract double %.107, %.703
  %.706 = fsub contract double %.672, %.705
  %.739 = fmul contract double %.107, %.670
  %.772 = fmul contract double %.77, %.703
  %.773 = fadd contract double %.739, %.772
  %.781 = fneg contract double %.773
  %.787 = fmul contract double %.325, %.706
  %.788 = fsub contract double %.784, %.787
  %.797 = fmul contract double %.296, %.706
  %.801 = fadd contract double %.800, %.797
  %.823 = select i1 %.654, i64 %arg.f.5.0, i64 0
  %6 = getelementptr double, ptr %arg.f.4, i64 %.589.sroa.0.0196
  %.837 = getelementptr double, ptr %6, i64 %.823
  %.838 = load double, ptr %.837, align 8
  %.839 = fmul contract double %.838, 0x400921FB54442D18
  %.841 = fmul contract double %.167, %.839
  %.851 = fsub contract double 1.000000e+00, %.801
  %.853 = fmul contract double %.841, %.851
  %.859 = fmul contract double %.853, %.853
  %.959 = fcmp contract olt double %.859, 0x3EB0C6F7A0B5ED8D
  br i1 %.959, label %B1030.endif, label %B5047

B5047:                                            ; preds = %B380
  %.865 = tail call contract double @llvm.fma.f64(double %.853, double 0x3FE45F306DC9C883, double 0x4338000000000000)
  %.914 = bitcast double %.865 to i64
  %.923 = shl i64 %.914, 62
  %.924 = add i64 %.923, 4611686018427387904
  %.925 = and i64 %.924, -9223372036854775808
  %.866 = fadd contract double %.865, 0xC338000000000000
  %.881 = tail call contract double @llvm.fma.f64(double %.866, double 0xBFF921FB54442D18, double %.853)
  %.896 = tail call contract double @llvm.fma.f64(double %.866, double 0xBC91A62633145C07, double %.881)
  %.897 = fmul contract double %.896, %.896
  %.906 = tail call contract double @llvm.fma.f64(double %.897, double 0x3D2AE7F3E733B81F, double 0xBDA93974A8C07C9D)
  %.907 = tail call contract double @llvm.fma.f64(double %.897, double %.906, double 0x3E21EED8EFF8D898)
  %.908 = tail call contract double @llvm.fma.f64(double %.897, double %.907, double 0xBE927E4FB7789F5C)
  %.909 = tail call contract double @llvm.fma.f64(double %.897, double %.908, double 0x3EFA01A01A01A01A)
  %.910 = tail call contract double @llvm.fma.f64(double %.897, double %.909, double 0xBF56C16C16C16C17)
  %.911 = tail call contract double @llvm.fma.f64(double %.897, double %.910, double 0x3FA5555555555555)
  %.912 = tail call contract double @llvm.fma.f64(double %.897, double %.911, double -5.000000e-01)
  %.913 = tail call contract double @llvm.fma.f64(double %.897, double %.912, double 1.000000e+00)
  %.916 = bitcast double %.913 to i64
  %7 = xor i64 %.925, %.916
  %.918 = and i64 %.914, 1
  %8 = icmp eq i64 %.918, 0
  %.904 = fmul contract double %.896, %.897
  %.898 = tail call contract double @llvm.fma.f64(double %.897, double 0xBD6AE7F3E733B81F, double 0x3DE6124613A86D09)
  %.899 = tail call contract double @llvm.fma.f64(double %.897, double %.898, double 0xBE5AE64567F544E4)
  %.900 = tail call contract double @llvm.fma.f64(double %.897, double %.899, double 0x3EC71DE3A556C734)
  %.901 = tail call contract double @llvm.fma.f64(double %.897, double %.900, double 0xBF2A01A01A01A01A)
  %.902 = tail call contract double @llvm.fma.f64(double %.897, double %.901, double 0x3F81111111111111)
  %.903 = tail call contract double @llvm.fma.f64(double %.897, double %.902, double 0xBFC5555555555555)
  %.905 = tail call contract double @llvm.fma.f64(double %.904, double %.903, double %.896)
  %.915 = bitcast double %.905 to i64
  %.917 = xor i64 %.916, %.915
  %.920 = select i1 %8, i64 0, i64 %.917
  %.930 = xor i64 %7, %.920
  %.931 = bitcast i64 %.930 to double
  %.922 = and i64 %.923, -9223372036854775808
  %9 = xor i64 %.922, %.915
  %.927 = xor i64 %9, %.920
  %.928 = bitcast i64 %.927 to double
  %.1012 = fdiv contract double %.928, %.853
  %.1022 = fsub contract double %.931, %.1012
  %.1029 = fdiv contract double %.1022, %.853
  br label %B5085

B5085:                                            ; preds = %B1030.endif, %B5047
  %_transfer_v164__v34call_7.2.sroa.8.1 = phi double [ %.980, %B1030.endif ], [ %.1029, %B5047 ]
  %_transfer_v164__v34call_7.2.sroa.0.1 = phi double [ %.970, %B1030.endif ], [ %.1012, %B5047 ]
  %.1072 = fadd contract double %.801, 1.000000e+00
  %.1074 = fmul contract double %.841, %.1072
  %.1080 = fmul contract double %.1074, %.1074
  %.1180 = fcmp contract olt double %.1080, 0x3EB0C6F7A0B5ED8D
  br i1 %.1180, label %B5086.endif, label %B5163

B5163:                                            ; preds = %B5085
  %.1086 = tail call contract double @llvm.fma.f64(double %.1074, double 0x3FE45F306DC9C883, double 0x4338000000000000)
  %.1135 = bitcast double %.1086 to i64
  %.1144 = shl i64 %.1135, 62
  %.1145 = add i64 %.1144, 4611686018427387904
  %.1146 = and i64 %.1145, -9223372036854775808
  %.1087 = fadd contract double %.1086, 0xC338000000000000
  %.1102 = tail call contract double @llvm.fma.f64(double %.1087, double 0xBFF921FB54442D18, double %.1074)
  %.1117 = tail call contract double @llvm.fma.f64(double %.1087, double 0xBC91A62633145C07, double %.1102)
  %.1118 = fmul contract double %.1117, %.1117
  %.1127 = tail call contract double @llvm.fma.f64(double %.1118, double 0x3D2AE7F3E733B81F, double 0xBDA93974A8C07C9D)
  %.1128 = tail call contract double @llvm.fma.f64(double %.1118, double %.1127, double 0x3E21EED8EFF8D898)
  %.1129 = tail call contract double @llvm.fma.f64(double %.1118, double %.1128, double 0xBE927E4FB7789F5C)
  %.1130 = tail call contract double @llvm.fma.f64(double %.1118, double %.1129, double 0x3EFA01A01A01A01A)
  %.1131 = tail call contract double @llvm.fma.f64(double %.1118, double %.1130, double 0xBF56C16C16C16C17)
  %.1132 = tail call contract double @llvm.fma.f64(double %.1118, double %.1131, double 0x3FA5555555555555)
  %.1133 = tail call contract double @llvm.fma.f64(double %.1118, double %.1132, double -5.000000e-01)
  %.1134 = tail call contract double @llvm.fma.f64(double %.1118, double %.1133, double 1.000000e+00)
  %.1137 = bitcast double %.1134 to i64
  %10 = xor i64 %.1146, %.1137
  %.1139 = and i64 %.1135, 1
  %11 = icmp eq i64 %.1139, 0
  %.1125 = fmul contract double %.1117, %.1118
  %.1119 = tail call contract double @llvm.fma.f64(double %.1118, double 0xBD6AE7F3E733B81F, double 0x3DE6124613A86D09)
  %.1120 = tail call contract double @llvm.fma.f64(double %.1118, double %.1119, double 0xBE5AE64567F544E4)
  %.1121 = tail call contract double @llvm.fma.f64(double %.1118, double %.1120, double 0x3EC71DE3A556C734)
  %.1122 = tail call contract double @llvm.fma.f64(double %.1118, double %.1121, double 0xBF2A01A01A01A01A)
  %.1123 = tail call contract double @llvm.fma.f64(double %.1118, double %.1122, double 0x3F81111111111111)
  %.1124 = tail call contract double @llvm.fma.f64(double %.1118, double %.1123, double 0xBFC5555555555555)
  %.1126 = tail call contract double @llvm.fma.f64(double %.1125, double %.1124, double %.1117)
  %.1136 = bitcast double %.1126 to i64
  %.1138 = xor i64 %.1137, %.1136
  %.1141 = select i1 %11, i64 0, i64 %.1138
  %.1151 = xor i64 %10, %.1141
  %.1152 = bitcast i64 %.1151 to double
  %.1143 = and i64 %.1144, -9223372036854775808
  %12 = xor i64 %.1143, %.1136
  %.1148 = xor i64 %12, %.1141
  %.1149 = bitcast i64 %.1148 to double
  %.1233 = fdiv contract double %.1149, %.1074
  %.1243 = fsub contract double %.1152, %.1233
  %.1250 = fdiv contract double %.1243, %.1074
  br label %B5201

B5201:                                            ; preds = %B5086.endif, %B5163
  %_transfer_v164__v82call_18.2.sroa.8.1 = phi double [ %.1201, %B5086.endif ], [ %.1250, %B5163 ]
  %_transfer_v164__v82call_18.2.sroa.0.1 = phi double [ %.1191, %B5086.endif ], [ %.1233, %B5163 ]
  %.1287 = tail call contract double @llvm.fma.f64(double %.841, double 0x3FE45F306DC9C883, double 0x4338000000000000)
  %.1288 = fadd contract double %.1287, 0xC338000000000000
  %.1303 = tail call contract double @llvm.fma.f64(double %.1288, double 0xBFF921FB54442D18, double %.841)
  %.1318 = tail call contract double @llvm.fma.f64(double %.1288, double 0xBC91A62633145C07, double %.1303)
  %.1319 = fmul contract double %.1318, %.1318
  %.1320 = tail call contract double @llvm.fma.f64(double %.1319, double 0xBD6AE7F3E733B81F, double 0x3DE6124613A86D09)
  %.1321 = tail call contract double @llvm.fma.f64(double %.1319, double %.1320, double 0xBE5AE64567F544E4)
  %.1322 = tail call contract double @llvm.fma.f64(double %.1319, double %.1321, double 0x3EC71DE3A556C734)
  %.1323 = tail call contract double @llvm.fma.f64(double %.1319, double %.1322, double 0xBF2A01A01A01A01A)
  %.1324 = tail call contract double @llvm.fma.f64(double %.1319, double %.1323, double 0x3F81111111111111)
  %.1325 = tail call contract double @llvm.fma.f64(double %.1319, double %.1324, double 0xBFC5555555555555)
  %.1326 = fmul contract double %.1318, %.1319
  %.1327 = tail call contract double @llvm.fma.f64(double %.1326, double %.1325, double %.1318)
  %.1328 = tail call contract double @llvm.fma.f64(double %.1319, double 0x3D2AE7F3E733B81F, double 0xBDA93974A8C07C9D)
  %.1329 = tail call contract double @llvm.fma.f64(double %.1319, double %.1328, double 0x3E21EED8EFF8D898)
  %.1330 = tail call contract double @llvm.fma.f64(double %.1319, double %.1329, double 0xBE927E4FB7789F5C)
  %.1331 = tail call contract double @llvm.fma.f64(double %.1319, double %.1330, double 0x3EFA01A01A01A01A)
  %.1332 = tail call contract double @llvm.fma.f64(double %.1319, double %.1331, double 0xBF56C16C16C16C17)
  %.1333 = tail call contract double @llvm.fma.f64(double %.1319, double %.1332, double 0x3FA5555555555555)
  %.1334 = tail call contract double @llvm.fma.f64(double %.1319, double %.1333, double -5.000000e-01)
  %.1335 = tail call contract double @llvm.fma.f64(double %.1319, double %.1334, double 1.000000e+00)
  %.1336 = bitcast double %.1287 to i64
  %.1337 = bitcast double %.1327 to i64
  %.1338 = bitcast double %.1335 to i64
  %.1339 = xor i64 %.1338, %.1337
  %.1340 = and i64 %.1336, 1
  %13 = icmp eq i64 %.1340, 0
  %.1342 = select i1 %13, i64 0, i64 %.1339
  %.1343 = shl i64 %.1336, 62
  %.1344 = and i64 %.1343, -9223372036854775808
  %.1346 = add i64 %.1343, 4611686018427387904
  %.1347 = and i64 %.1346, -9223372036854775808
  %14 = xor i64 %.1344, %.1337
  %.1349 = xor i64 %14, %.1342
  %.1350 = bitcast i64 %.1349 to double
  %15 = xor i64 %.1347, %.1338
  %.1352 = xor i64 %15, %.1342
  %.1353 = bitcast i64 %.1352 to double
  %.1374 = fmul contract double %.1353, 5.000000e-01
  %.1376 = fadd contract double %_transfer_v164__v34call_7.2.sroa.0.1, %_transfer_v164__v82call_18.2.sroa.0.1
  %.1377 = fmul contract double %.1374, %.1376
  %.1378 = fmul contract double %.1350, 5.000000e-01
  %.1380 = fsub contract double %_transfer_v164__v34call_7.2.sroa.0.1, %_transfer_v164__v82call_18.2.sroa.0.1
  %.1383 = fmul contract double %.1378, %.1380
  %.1386 = fmul contract double %.841, %.1374
  %.1388 = fsub contract double %_transfer_v164__v34call_7.2.sroa.8.1, %_transfer_v164__v82call_18.2.sroa.8.1
  %.1389 = fmul contract double %.1386, %.1388
  %.1392 = fmul contract double %.841, %.1378
  %.1394 = fadd contract double %_transfer_v164__v34call_7.2.sroa.8.1, %_transfer_v164__v82call_18.2.sroa.8.1
  %.1397 = fmul contract double %.1392, %.1394
  %.1402 = fmul contract double %.841, %.801
  %.1405 = tail call contract double @llvm.fma.f64(double %.1402, double 0x3FE45F306DC9C883, double 0x4338000000000000)
  %.1406 = fadd contract double %.1405, 0xC338000000000000
  %.1421 = tail call contract double @llvm.fma.f64(double %.1406, double 0xBFF921FB54442D18, double %.1402)
  %.1436 = tail call contract double @llvm.fma.f64(double %.1406, double 0xBC91A62633145C07, double %.1421)
  %.1437 = fmul contract double %.1436, %.1436
  %.1438 = tail call contract double @llvm.fma.f64(double %.1437, double 0xBD6AE7F3E733B81F, double 0x3DE6124613A86D09)
  %.1439 = tail call contract double @llvm.fma.f64(double %.1437, double %.1438, double 0xBE5AE64567F544E4)
  %.1440 = tail call contract double @llvm.fma.f64(double %.1437, double %.1439, double 0x3EC71DE3A556C734)
  %.1441 = tail call contract double @llvm.fma.f64(double %.1437, double %.1440, double 0xBF2A01A01A01A01A)
  %.1442 = tail call contract double @llvm.fma.f64(double %.1437, double %.1441, double 0x3F81111111111111)
  %.1443 = tail call contract double @llvm.fma.f64(double %.1437, double %.1442, double 0xBFC5555555555555)
  %.1444 = fmul contract double %.1436, %.1437
  %.1445 = tail call contract double @llvm.fma.f64(double %.1444, double %.1443, double %.1436)
  %.1446 = tail call contract double @llvm.fma.f64(double %.1437, double 0x3D2AE7F3E733B81F, double 0xBDA93974A8C07C9D)
  %.1447 = tail call contract double @llvm.fma.f64(double %.1437, double %.1446, double 0x3E21EED8EFF8D898)
  %.1448 = tail call contract double @llvm.fma.f64(double %.1437, double %.1447, double 0xBE927E4FB7789F5C)
  %.1449 = tail call contract double @llvm.fma.f64(double %.1437, double %.1448, double 0x3EFA01A01A01A01A)
  %.1450 = tail call contract double @llvm.fma.f64(double %.1437, double %.1449, double 0xBF56C16C16C16C17)
  %.1451 = tail call contract double @llvm.fma.f64(double %.1437, double %.1450, double 0x3FA5555555555555)
  %.1452 = tail call contract double @llvm.fma.f64(double %.1437, double %.1451, double -5.000000e-01)
  %.1453 = tail call contract double @llvm.fma.f64(double %.1437, double %.1452, double 1.000000e+00)
  %.1454 = bitcast double %.1405 to i64
  %.1455 = bitcast double %.1445 to i64
  %.1456 = bitcast double %.1453 to i64
  %.1457 = xor i64 %.1456, %.1455
  %.1458 = and i64 %.1454, 1
  %16 = icmp eq i64 %.1458, 0
  %.1460 = select i1 %16, i64 0, i64 %.1457
  %.1461 = shl i64 %.1454, 62
  %.1462 = and i64 %.1461, -9223372036854775808
  %.1464 = add i64 %.1461, 4611686018427387904
  %.1465 = and i64 %.1464, -9223372036854775808
  %17 = xor i64 %.1462, %.1455
  %.1467 = xor i64 %17, %.1460
  %.1468 = bitcast i64 %.1467 to double
  %18 = xor i64 %.1465, %.1456
  %.1470 = xor i64 %18, %.1460
  %.1471 = bitcast i64 %.1470 to double
  %.1492 = fmul contract double %.1377, %.1471
  %.1493 = fmul contract double %.1383, %.1468
  %.1494 = fsub contract double %.1492, %.1493
  %.1495 = fmul contract double %.1377, %.1468
  %.1496 = fmul contract double %.1383, %.1471
  %.1497 = fadd contract double %.1495, %.1496
  %.1498 = fmul contract double %.1389, %.1471
  %.1499 = fmul contract double %.1397, %.1468
  %.1500 = fsub contract double %.1498, %.1499
  %.1502 = fmul contract double %.841, %.1497
  %.1503 = fadd contract double %.1500, %.1502
  %.1504 = fmul contract double %.1389, %.1468
  %.1505 = fmul contract double %.1397, %.1471
  %.1506 = fadd contract double %.1504, %.1505
  %.1508 = fmul contract double %.841, %.1494
  %.1511 = fsub contract double %.1506, %.1508
  %.1554 = fmul contract double %.773, %.773
  %.1557 = fmul contract double %.788, %.788
  %.1558 = fsub contract double %.1554, %.1557
  %.1559 = fmul contract double %.1558, 5.000000e-01
  %.1562 = fmul contract double %.788, %.781
  %.1564 = fmul contract double %arg.sign, %.1494
  %.1566 = fmul contract double %arg.sign, %.1497
  %.1568 = fmul contract double %arg.sign, %.1503
  %.1570 = fmul contract double %arg.sign, %.1511
  %.1603 = fmul contract double %.232, %.1559
  %.1604 = fmul contract double %.261, %.1562
  %.1605 = fadd contract double %.1604, %.1603
  %.1606 = fmul contract double %.232, %.1562
  %.1607 = fmul contract double %.261, %.1559
  %.1608 = fsub contract double %.1606, %.1607
  %19 = getelementptr double, ptr %.1629, i64 %.589.sroa.0.0196
  %.1719 = getelementptr double, ptr %19, i64 %.655
  %.1720 = load double, ptr %.1719, align 8
  %.1721 = fmul contract double %.1605, %.1564
  %.1722 = fadd contract double %.1720, %.1721
  store double %.1722, ptr %.1719, align 8
  %20 = getelementptr double, ptr %.1774, i64 %.589.sroa.0.0196
  %.1864 = getelementptr double, ptr %20, i64 %.655
  %.1865 = load double, ptr %.1864, align 8
  %.1866 = fmul contract double %.1605, %.1566
  %.1867 = fadd contract double %.1865, %.1866
  store double %.1867, ptr %.1864, align 8
  %21 = getelementptr double, ptr %.1919, i64 %.589.sroa.0.0196
  %.2009 = getelementptr double, ptr %21, i64 %.655
  %.2010 = load double, ptr %.2009, align 8
  %.2011 = fmul contract double %.1608, %.1564
  %.2012 = fadd contract double %.2010, %.2011
  store double %.2012, ptr %.2009, align 8
  %22 = getelementptr double, ptr %.2067, i64 %.589.sroa.0.0196
  %.2157 = getelementptr double, ptr %22, i64 %.655
  %.2158 = load double, ptr %.2157, align 8
  %.2159 = fmul contract double %.1608, %.1566
  %.2160 = fadd contract double %.2159, %.2158
  store double %.2160, ptr %.2157, align 8
  %.2199 = fmul contract double %.325, %.773
  %.2202 = fmul contract double %.296, %.773
  %.2206 = fmul contract double %.2202, %.1568
  %.2207 = fmul contract double %.2202, %.1570
  %23 = getelementptr double, ptr %.2241, i64 %.589.sroa.0.0196
  %.2331 = getelementptr double, ptr %23, i64 %.655
  %.2332 = load double, ptr %.2331, align 8
  %.2333 = fmul contract double %.1605, %.2206
  %.2334 = fadd contract double %.2333, %.2332
  store double %.2334, ptr %.2331, align 8
  %24 = getelementptr double, ptr %.2386, i64 %.589.sroa.0.0196
  %.2476 = getelementptr double, ptr %24, i64 %.655
  %.2477 = load double, ptr %.2476, align 8
  %.2478 = fmul contract double %.1605, %.2207
  %.2479 = fadd contract double %.2478, %.2477
  store double %.2479, ptr %.2476, align 8
  %25 = getelementptr double, ptr %.2531, i64 %.589.sroa.0.0196
  %.2621 = getelementptr double, ptr %25, i64 %.655
  %.2622 = load double, ptr %.2621, align 8
  %.2623 = fmul contract double %.1608, %.2206
  %.2624 = fadd contract double %.2623, %.2622
  store double %.2624, ptr %.2621, align 8
  %26 = getelementptr double, ptr %.2679, i64 %.589.sroa.0.0196
  %.2769 = getelementptr double, ptr %26, i64 %.655
  %.2770 = load double, ptr %.2769, align 8
  %.2771 = fmul contract double %.1608, %.2207
  %.2772 = fadd contract double %.2771, %.2770
  store double %.2772, ptr %.2769, align 8
  %.2807 = fmul contract double %.773, %.706
  %.2809 = fmul contract double %.2199, %.788
  %.2810 = fsub contract double %.2807, %.2809
  %.2814 = fmul contract double %.2199, %.781
  %27 = fmul contract double %.706, %.788
  %.2815 = fsub contract double %.2814, %27
  %.2823 = fmul contract double %.232, %.2810
  %.2824 = fmul contract double %.261, %.2815
  %.2825 = fadd contract double %.2823, %.2824
  %.2826 = fmul contract double %.232, %.2815
  %.2827 = fmul contract double %.261, %.2810
  %.2828 = fsub contract double %.2826, %.2827
  %.2941 = fmul contract double %.2825, %.1564
  %.2942 = fadd contract double %.2941, %.2334
  store double %.2942, ptr %.2331, align 8
  %.3086 = fmul contract double %.2825, %.1566
  %.3087 = fadd contract double %.3086, %.2479
  store double %.3087, ptr %.2476, align 8
  %.3231 = fmul contract double %.2828, %.1564
  %.3232 = fadd contract double %.3231, %.2624
  store double %.3232, ptr %.2621, align 8
  %.3379 = fmul contract double %.2828, %.1566
  %.3380 = fadd contract double %.3379, %.2772
  store double %.3380, ptr %.2769, align 8
  %.3414 = fneg contract double %.1568
  %.3416 = fmul contract double %.788, %.3414
  %.3417 = fneg contract double %.1570
  %.3419 = fmul contract double %.788, %.3417
  %28 = getelementptr double, ptr %.3453, i64 %.589.sroa.0.0196
  %.3543 = getelementptr double, ptr %28, i64 %.655
  %.3544 = load double, ptr %.3543, align 8
  %.3545 = fmul contract double %.1605, %.3416
  %.3546 = fadd contract double %.3545, %.3544
  store double %.3546, ptr %.3543, align 8
  %29 = getelementptr double, ptr %.3598, i64 %.589.sroa.0.0196
  %.3688 = getelementptr double, ptr %29, i64 %.655
  %.3689 = load double, ptr %.3688, align 8
  %.3690 = fmul contract double %.1605, %.3419
  %.3691 = fadd contract double %.3690, %.3689
  store double %.3691, ptr %.3688, align 8
  %30 = getelementptr double, ptr %.3743, i64 %.589.sroa.0.0196
  %.3833 = getelementptr double, ptr %30, i64 %.655
  %.3834 = load double, ptr %.3833, align 8
  %.3835 = fmul contract double %.1608, %.3416
  %.3836 = fadd contract double %.3835, %.3834
  store double %.3836, ptr %.3833, align 8
  %31 = getelementptr double, ptr %.3891, i64 %.589.sroa.0.0196
  %.3981 = getelementptr double, ptr %31, i64 %.655
  %.3982 = load double, ptr %.3981, align 8
  %.3983 = fmul contract double %.1608, %.3419
  %.3984 = fadd contract double %.3983, %.3982
  store double %.3984, ptr %.3981, align 8
  %.4023 = fmul contract double %.788, %.801
  %.4026 = fmul contract double %.773, %.801
  %.4040 = fmul contract double %.232, %.4023
  %.4041 = fmul contract double %.261, %.4026
  %.4042 = fadd contract double %.4040, %.4041
  %.4043 = fmul contract double %.232, %.4026
  %.4044 = fmul contract double %.261, %.4023
  %.4045 = fsub contract double %.4043, %.4044
  %.4158 = fmul contract double %.4042, %.1564
  %.4159 = fadd contract double %.4158, %.3546
  store double %.4159, ptr %.3543, align 8
  %.4303 = fmul contract double %.4042, %.1566
  %.4304 = fadd contract double %.4303, %.3691
  store double %.4304, ptr %.3688, align 8
  %.4448 = fmul contract double %.4045, %.1564
  %.4449 = fadd contract double %.4448, %.3836
  store double %.4449, ptr %.3833, align 8
  %.4596 = fmul contract double %.4045, %.1566
  %.4597 = fadd contract double %.4596, %.3984
  store double %.4597, ptr %.3981, align 8
  %.599 = icmp sgt i64 %.546.1195.in, 1
  %32 = tail call i64 @llvm.smax.i64(i64 %.546.1195.in, i64 2)
  %33 = add nsw i64 %32, -1
  %.589.sroa.0.0 = select i1 %.599, i64 %lsr.iv, i64 0
  %lsr.iv.next = add i64 %lsr.iv, 1
  br i1 %.599, label %B380, label %B5202

B5202:                                            ; preds = %B5201, %entry
  store ptr null, ptr %retptr, align 8
  ret void

B1030.endif:                                      ; preds = %B380
  %.969 = fdiv contract double %.859, 6.000000e+00
  %.970 = fsub contract double 1.000000e+00, %.969
  %.975 = fdiv contract double %.859, 3.000000e+01
  %.978 = fadd contract double %.975, 0xBFD5555555555555
  %.980 = fmul contract double %.853, %.978
  br label %B5085

B5086.endif:                                      ; preds = %B5085
  %.1190 = fdiv contract double %.1080, 6.000000e+00
  %.1191 = fsub contract double 1.000000e+00, %.1190
  %.1196 = fdiv contract double %.1080, 3.000000e+01
  %.1199 = fadd contract double %.1196, 0xBFD5555555555555
  %.1201 = fmul contract double %.1074, %.1199
  br label %B5201
}

; Function Attrs: mustprogress nocallback nocreateundeforpoison nofree nosync nounwind speculatable willreturn memory(none)
declare <8 x double> @llvm.fma.v8f64(<8 x double>, <8 x double>, <8 x double>) #2

; Function Attrs: mustprogress nocallback nocreateundeforpoison nofree nosync nounwind speculatable willreturn memory(none)
declare i64 @llvm.smax.i64(i64, i64) #2

; Function Attrs: mustprogress nocallback nocreateundeforpoison nofree nosync nounwind speculatable willreturn memory(none)
declare double @llvm.floor.f64(double) #2

; Function Attrs: nofree norecurse nosync nounwind memory(argmem: readwrite)
define internal fastcc void @inner_1(ptr noalias nonnull writeonly captures(none) %retptr, ptr readonly captures(none) %arg.a.4, i64 range(i64 -9223372036854775808, 9223372036854775807) %arg.a.5.0, ptr readonly captures(none) %arg.b.4, i64 range(i64 -9223372036854775808, 9223372036854775807) %arg.b.5.0, i64 range(i64 -9223372036854775808, 9223372036854775807) %arg.size, ptr captures(none) %arg.lanes.4) unnamed_addr #3 {
entry:
  %.95 = and i64 %arg.size, -8
  %0 = tail call i64 @llvm.smax.i64(i64 %arg.size, i64 7)
  %storemerge = lshr i64 %0, 3
  %.181288.not = icmp eq i64 %storemerge, 0
  br i1 %.181288.not, label %B210, label %B114.if.preheader

B114.if.preheader:                                ; preds = %entry
  %1 = add nuw nsw i64 %storemerge, 5
  br label %B114.if

B210:                                             ; preds = %B114.if, %entry
  %total.2.0.lcssa = phi <8 x double> [ zeroinitializer, %entry ], [ %.240, %B114.if ]
  %.293 = and i64 %arg.size, 7
  %.336296.not = icmp eq i64 %.293, 0
  br i1 %.336296.not, label %B292, label %B246.if

B292:                                             ; preds = %B246.if.6, %B246.if.5, %B246.if.4, %B246.if.3, %B246.if.2, %B246.if.1, %B246.if, %B210
  %rest.2.0.lcssa = phi double [ 0.000000e+00, %B210 ], [ %.436, %B246.if ], [ %.436.1, %B246.if.1 ], [ %.436.2, %B246.if.2 ], [ %.436.3, %B246.if.3 ], [ %.436.4, %B246.if.4 ], [ %.436.5, %B246.if.5 ], [ %.436.6, %B246.if.6 ]
  store <8 x double> %total.2.0.lcssa, ptr %arg.lanes.4, align 8
  %.504 = load double, ptr %arg.lanes.4, align 8
  %.532 = getelementptr i8, ptr %arg.lanes.4, i64 8
  %.533 = load double, ptr %.532, align 8
  %.534 = fadd contract double %.504, %.533
  %.562 = getelementptr i8, ptr %arg.lanes.4, i64 16
  %.563 = load double, ptr %.562, align 8
  %.591 = getelementptr i8, ptr %arg.lanes.4, i64 24
  %.592 = load double, ptr %.591, align 8
  %.593 = fadd contract double %.563, %.592
  %.594 = fadd contract double %.534, %.593
  %.622 = getelementptr i8, ptr %arg.lanes.4, i64 32
  %.623 = load double, ptr %.622, align 8
  %.651 = getelementptr i8, ptr %arg.lanes.4, i64 40
  %.652 = load double, ptr %.651, align 8
  %.653 = fadd contract double %.623, %.652
  %.681 = getelementptr i8, ptr %arg.lanes.4, i64 48
  %.682 = load double, ptr %.681, align 8
  %.710 = getelementptr i8, ptr %arg.lanes.4, i64 56
  %.711 = load double, ptr %.710, align 8
  %.715 = fadd contract double %.682, %.711
  %.716 = fadd contract double %.653, %.715
  %.717 = fadd contract double %.594, %.716
  %.719 = fadd contract double %rest.2.0.lcssa, %.717
  store double %.719, ptr %retptr, align 8
  ret void

B114.if:                                          ; preds = %B114.if, %B114.if.preheader
  %lsr.iv = phi i64 [ %lsr.iv.next, %B114.if ], [ %1, %B114.if.preheader ]
  %lsr.iv1 = phi i64 [ %lsr.iv.next2, %B114.if ], [ 0, %B114.if.preheader ]
  %total.2.0291 = phi <8 x double> [ %.240, %B114.if ], [ zeroinitializer, %B114.if.preheader ]
  %scevgep3 = getelementptr i8, ptr %arg.a.4, i64 %lsr.iv1
  %.228 = load <8 x double>, ptr %scevgep3, align 8
  %scevgep = getelementptr i8, ptr %arg.b.4, i64 %lsr.iv1
  %.238 = load <8 x double>, ptr %scevgep, align 8
  %.240 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.228, <8 x double> %.238, <8 x double> %total.2.0291)
  %lsr.iv.next2 = add nuw i64 %lsr.iv1, 64
  %lsr.iv.next = add nsw i64 %lsr.iv, -1
  %.181 = icmp sgt i64 %lsr.iv, 6
  br i1 %.181, label %B114.if, label %B210

B246.if:                                          ; preds = %B210
  %.387 = icmp slt i64 %arg.size, 0
  %.388 = select i1 %.387, i64 %arg.a.5.0, i64 0
  %2 = getelementptr double, ptr %arg.a.4, i64 %.95
  %.402 = getelementptr double, ptr %2, i64 %.388
  %.403 = load double, ptr %.402, align 8
  %.418 = select i1 %.387, i64 %arg.b.5.0, i64 0
  %3 = getelementptr double, ptr %arg.b.4, i64 %.95
  %.432 = getelementptr double, ptr %3, i64 %.418
  %.433 = load double, ptr %.432, align 8
  %.434 = fmul contract double %.403, %.433
  %.436 = fadd contract double %.434, 0.000000e+00
  %.336.not = icmp eq i64 %.293, 1
  br i1 %.336.not, label %B292, label %B246.if.1

B246.if.1:                                        ; preds = %B246.if
  %.349 = or disjoint i64 %.95, 1
  %4 = getelementptr double, ptr %arg.a.4, i64 %.349
  %.402.1 = getelementptr double, ptr %4, i64 %.388
  %.403.1 = load double, ptr %.402.1, align 8
  %5 = getelementptr double, ptr %arg.b.4, i64 %.349
  %.432.1 = getelementptr double, ptr %5, i64 %.418
  %.433.1 = load double, ptr %.432.1, align 8
  %.434.1 = fmul contract double %.403.1, %.433.1
  %.436.1 = fadd contract double %.436, %.434.1
  %.336.1 = icmp samesign ugt i64 %.293, 2
  br i1 %.336.1, label %B246.if.2, label %B292

B246.if.2:                                        ; preds = %B246.if.1
  %.349.1 = or disjoint i64 %.95, 2
  %6 = getelementptr double, ptr %arg.a.4, i64 %.349.1
  %.402.2 = getelementptr double, ptr %6, i64 %.388
  %.403.2 = load double, ptr %.402.2, align 8
  %7 = getelementptr double, ptr %arg.b.4, i64 %.349.1
  %.432.2 = getelementptr double, ptr %7, i64 %.418
  %.433.2 = load double, ptr %.432.2, align 8
  %.434.2 = fmul contract double %.403.2, %.433.2
  %.436.2 = fadd contract double %.436.1, %.434.2
  %.336.2.not = icmp eq i64 %.293, 3
  br i1 %.336.2.not, label %B292, label %B246.if.3

B246.if.3:                                        ; preds = %B246.if.2
  %.349.2 = or disjoint i64 %.95, 3
  %8 = getelementptr double, ptr %arg.a.4, i64 %.349.2
  %.402.3 = getelementptr double, ptr %8, i64 %.388
  %.403.3 = load double, ptr %.402.3, align 8
  %9 = getelementptr double, ptr %arg.b.4, i64 %.349.2
  %.432.3 = getelementptr double, ptr %9, i64 %.418
  %.433.3 = load double, ptr %.432.3, align 8
  %.434.3 = fmul contract double %.403.3, %.433.3
  %.436.3 = fadd contract double %.436.2, %.434.3
  %.336.3 = icmp samesign ugt i64 %.293, 4
  br i1 %.336.3, label %B246.if.4, label %B292

B246.if.4:                                        ; preds = %B246.if.3
  %.349.3 = or disjoint i64 %.95, 4
  %10 = getelementptr double, ptr %arg.a.4, i64 %.349.3
  %.402.4 = getelementptr double, ptr %10, i64 %.388
  %.403.4 = load double, ptr %.402.4, align 8
  %11 = getelementptr double, ptr %arg.b.4, i64 %.349.3
  %.432.4 = getelementptr double, ptr %11, i64 %.418
  %.433.4 = load double, ptr %.432.4, align 8
  %.434.4 = fmul contract double %.403.4, %.433.4
  %.436.4 = fadd contract double %.436.3, %.434.4
  %.336.4.not = icmp eq i64 %.293, 5
  br i1 %.336.4.not, label %B292, label %B246.if.5

B246.if.5:                                        ; preds = %B246.if.4
  %.349.4 = or disjoint i64 %.95, 5
  %12 = getelementptr double, ptr %arg.a.4, i64 %.349.4
  %.402.5 = getelementptr double, ptr %12, i64 %.388
  %.403.5 = load double, ptr %.402.5, align 8
  %13 = getelementptr double, ptr %arg.b.4, i64 %.349.4
  %.432.5 = getelementptr double, ptr %13, i64 %.418
  %.433.5 = load double, ptr %.432.5, align 8
  %.434.5 = fmul contract double %.403.5, %.433.5
  %.436.5 = fadd contract double %.436.4, %.434.5
  %.336.5 = icmp eq i64 %.293, 7
  br i1 %.336.5, label %B246.if.6, label %B292

B246.if.6:                                        ; preds = %B246.if.5
  %.349.5 = or disjoint i64 %.95, 6
  %14 = getelementptr double, ptr %arg.a.4, i64 %.349.5
  %.402.6 = getelementptr double, ptr %14, i64 %.388
  %.403.6 = load double, ptr %.402.6, align 8
  %15 = getelementptr double, ptr %arg.b.4, i64 %.349.5
  %.432.6 = getelementptr double, ptr %15, i64 %.418
  %.433.6 = load double, ptr %.432.6, align 8
  %.434.6 = fmul contract double %.403.6, %.433.6
  %.436.6 = fadd contract double %.436.5, %.434.6
  br label %B292
}

; Function Attrs: mustprogress nocallback nocreateundeforpoison nofree nosync nounwind speculatable willreturn memory(none)
declare double @llvm.fma.f64(double, double, double) #2

; Function Attrs: mustprogress nocallback nocreateundeforpoison nofree nosync nounwind speculatable willreturn memory(none)
declare { i64, i1 } @llvm.uadd.with.overflow.i64(i64, i64) #2

; Function Attrs: mustprogress nocallback nocreateundeforpoison nofree nosync nounwind speculatable willreturn memory(none)
declare double @llvm.sqrt.f64(double) #2

; Function Attrs: mustprogress nocallback nofree nosync nounwind willreturn memory(none)
declare double @sqrt(double) local_unnamed_addr #4

; Function Attrs: mustprogress nocallback nocreateundeforpoison nofree nosync nounwind speculatable willreturn memory(none)
declare double @llvm.fabs.f64(double) #2

; Function Attrs: nocallback nofree nosync nounwind willreturn memory(argmem: readwrite)
declare void @llvm.lifetime.start.p0(ptr captures(none)) #5

; Function Attrs: nocallback nofree nosync nounwind willreturn memory(argmem: readwrite)
declare void @llvm.lifetime.end.p0(ptr captures(none)) #5

attributes #0 = { nofree norecurse nosync nounwind memory(readwrite, inaccessiblemem: none, target_mem0: none, target_mem1: none) }
attributes #1 = { mustprogress nocallback nofree nounwind willreturn memory(argmem: write) }
attributes #2 = { mustprogress nocallback nocreateundeforpoison nofree nosync nounwind speculatable willreturn memory(none) }
attributes #3 = { nofree norecurse nosync nounwind memory(argmem: readwrite) }
attributes #4 = { mustprogress nocallback nofree nosync nounwind willreturn memory(none) }
attributes #5 = { nocallback nofree nosync nounwind willreturn memory(argmem: readwrite) }

!0 = !{!1}
!1 = distinct !{!1, !2, !"_ZN17bnserve_inference14adjoint_kernel7_source11_block_backB4v479B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!2 = distinct !{!2, !"_ZN17bnserve_inference14adjoint_kernel7_source11_block_backB4v479B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!3 = !{!4, !1}
!4 = distinct !{!4, !5, !"_ZN17bnserve_inference14adjoint_kernel5_back10waves_backB4v492B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!5 = distinct !{!5, !"_ZN17bnserve_inference14adjoint_kernel5_back10waves_backB4v492B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE"}
!6 = !{!7, !4, !1}
!7 = distinct !{!7, !8, !"_ZN17bnserve_inference14adjoint_kernel5_sums5splitB4v113B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedExx5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!8 = distinct !{!8, !"_ZN17bnserve_inference14adjoint_kernel5_sums5splitB4v113B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedExx5ArrayIdLi1E1C7mutable7alignedE"}
!9 = !{!10}
!10 = distinct !{!10, !11, !"_ZN17bnserve_inference14adjoint_kernel7_source9_sky_backB4v516B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!11 = distinct !{!11, !"_ZN17bnserve_inference14adjoint_kernel7_source9_sky_backB4v516B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!12 = !{!13}
!13 = distinct !{!13, !14, !"_ZN17bnserve_inference14adjoint_kernel8_passing12passing_backB4v521B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!14 = distinct !{!14, !"_ZN17bnserve_inference14adjoint_kernel8_passing12passing_backB4v521B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!15 = !{!16, !13}
!16 = distinct !{!16, !17, !"_ZN17bnserve_inference14adjoint_kernel8_passing10_turn_backB4v532B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedExx8UniTupleIdLi3EE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!17 = distinct !{!17, !"_ZN17bnserve_inference14adjoint_kernel8_passing10_turn_backB4v532B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedExx8UniTupleIdLi3EE5ArrayIdLi1E1C7mutable7alignedE"}
!18 = !{!19}
!19 = distinct !{!19, !20, !"_ZN17bnserve_inference14adjoint_kernel5_back11binary_backB4v537B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!20 = distinct !{!20, !"_ZN17bnserve_inference14adjoint_kernel5_back11binary_backB4v537B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!21 = !{!22}
!22 = distinct !{!22, !23, !"_ZN17bnserve_inference14adjoint_kernel7_source6_placeB3v16B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!23 = distinct !{!23, !"_ZN17bnserve_inference14adjoint_kernel7_source6_placeB3v16B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!24 = !{!25, !22}
!25 = distinct !{!25, !26, !"_ZN17bnserve_inference13moving_kernel9_response12coefficientsB3v24B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!26 = distinct !{!26, !"_ZN17bnserve_inference13moving_kernel9_response12coefficientsB3v24B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!27 = !{!28, !22}
!28 = distinct !{!28, !29, !"_ZN17bnserve_inference14adjoint_kernel9_response13fill_geometryB3v43B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!29 = distinct !{!29, !"_ZN17bnserve_inference14adjoint_kernel9_response13fill_geometryB3v43B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!30 = !{!31}
!31 = distinct !{!31, !32, !"_ZN17bnserve_inference13moving_kernel8_passing12find_passingB3v59B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIxLi1E1C7mutable7alignedE: %retptr"}
!32 = distinct !{!32, !"_ZN17bnserve_inference13moving_kernel8_passing12find_passingB3v59B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIxLi1E1C7mutable7alignedE"}
!33 = distinct !{!33, !34}
!34 = !{!"llvm.loop.unroll.disable"}
!35 = !{!36, !31}
!36 = distinct !{!36, !37, !"_ZN17bnserve_inference13moving_kernel8_passing6_turnsB3v74B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedExx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!37 = distinct !{!37, !"_ZN17bnserve_inference13moving_kernel8_passing6_turnsB3v74B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedExx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!38 = distinct !{!38, !34}
!39 = !{!40}
!40 = distinct !{!40, !41, !"_ZN17bnserve_inference14adjoint_kernel7_source9_polariseB3v77B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!41 = distinct !{!41, !"_ZN17bnserve_inference14adjoint_kernel7_source9_polariseB3v77B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!42 = distinct !{!42, !34}
!43 = distinct !{!43, !34}
!44 = !{!45, !40}
!45 = distinct !{!45, !46, !"_ZN17bnserve_inference14adjoint_kernel7_source6_beginB3v92B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEdxx: %retptr"}
!46 = distinct !{!46, !"_ZN17bnserve_inference14adjoint_kernel7_source6_beginB3v92B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEdxx"}
!47 = distinct !{!47, !34}
!48 = distinct !{!48, !34}
!49 = distinct !{!49, !34}
!50 = distinct !{!50, !34}
!51 = distinct !{!51, !34}
!52 = distinct !{!52, !34}
!53 = !{!54, !40}
!54 = distinct !{!54, !55, !"_ZN17bnserve_inference14adjoint_kernel5_sums5splitB4v113B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedExx5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!55 = distinct !{!55, !"_ZN17bnserve_inference14adjoint_kernel5_sums5splitB4v113B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedExx5ArrayIdLi1E1C7mutable7alignedE"}
!56 = !{!57, !40}
!57 = distinct !{!57, !58, !"_ZN17bnserve_inference14adjoint_kernel5_sums8add_modeB4v118B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEdddx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!58 = distinct !{!58, !"_ZN17bnserve_inference14adjoint_kernel5_sums8add_modeB4v118B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEdddx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!59 = !{!60}
!60 = distinct !{!60, !61, !"_ZN17bnserve_inference14adjoint_kernel7_source12_in_detectorB4v131B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxx5ArrayIxLi1E1C7mutable7alignedEd5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!61 = distinct !{!61, !"_ZN17bnserve_inference14adjoint_kernel7_source12_in_detectorB4v131B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxx5ArrayIxLi1E1C7mutable7alignedEd5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!62 = !{!63, !60}
!63 = distinct !{!63, !64, !"_ZN17bnserve_inference14adjoint_kernel7_source10_calibrateB4v142B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!64 = distinct !{!64, !"_ZN17bnserve_inference14adjoint_kernel7_source10_calibrateB4v142B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!65 = distinct !{!65, !34}
!66 = !{!67, !63, !60}
!67 = distinct !{!67, !68, !"_ZN17bnserve_inference6kernel5_sums9errors_atB4v157B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedExx5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!68 = distinct !{!68, !"_ZN17bnserve_inference6kernel5_sums9errors_atB4v157B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedExx5ArrayIdLi1E1C7mutable7alignedE"}
!69 = !{!"branch_weights", i32 1, i32 99}
!70 = !{!"branch_weights", i32 99, i32 1}
!71 = !{!72, !63, !60}
!72 = distinct !{!72, !73, !"_ZN17bnserve_inference6kernel5_sums9errors_atB4v157B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedExx5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!73 = distinct !{!73, !"_ZN17bnserve_inference6kernel5_sums9errors_atB4v157B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedExx5ArrayIdLi1E1C7mutable7alignedE"}
!74 = !{!75, !60}
!75 = distinct !{!75, !76, !"_ZN17bnserve_inference14adjoint_kernel9_response14clear_patternsB4v160B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!76 = distinct !{!76, !"_ZN17bnserve_inference14adjoint_kernel9_response14clear_patternsB4v160B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE"}
!77 = !{!78, !60}
!78 = distinct !{!78, !79, !"_ZN17bnserve_inference14adjoint_kernel9_response14short_patternsB4v220B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!79 = distinct !{!79, !"_ZN17bnserve_inference14adjoint_kernel9_response14short_patternsB4v220B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE"}
!80 = !{!81, !60}
!81 = distinct !{!81, !82, !"_ZN17bnserve_inference14adjoint_kernel5_sums7respondB4v246B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedEddxx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!82 = distinct !{!82, !"_ZN17bnserve_inference14adjoint_kernel5_sums7respondB4v246B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedEddxx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!83 = !{!84, !60}
!84 = distinct !{!84, !85, !"_ZN17bnserve_inference14adjoint_kernel5_back11errors_backB4v368B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!85 = distinct !{!85, !"_ZN17bnserve_inference14adjoint_kernel5_back11errors_backB4v368B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!86 = !{!87, !60}
!87 = distinct !{!87, !88, !"_ZN17bnserve_inference14adjoint_kernel5_back9pull_backB4v386B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!88 = distinct !{!88, !"_ZN17bnserve_inference14adjoint_kernel5_back9pull_backB4v386B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!89 = !{!90, !60}
!90 = distinct !{!90, !91, !"_ZN17bnserve_inference14adjoint_kernel5_back15errors_to_nodesB4v468B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!91 = distinct !{!91, !"_ZN17bnserve_inference14adjoint_kernel5_back15errors_to_nodesB4v468B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!92 = !{!93, !60}
!93 = distinct !{!93, !94, !"_ZN17bnserve_inference14adjoint_kernel7_source16_through_weightsB4v285B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxxx5ArrayIxLi1E1C7mutable7alignedEd5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!94 = distinct !{!94, !"_ZN17bnserve_inference14adjoint_kernel7_source16_through_weightsB4v285B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxxx5ArrayIxLi1E1C7mutable7alignedEd5ArrayIdLi1E1C7mutable7alignedE"}
!95 = !{!96, !93, !60}
!96 = distinct !{!96, !97, !"_ZN17bnserve_inference6kernel5_sums9spline_atB4v319B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dEd5ArrayIdLi1E1C7mutable7alignedExxx: %retptr"}
!97 = distinct !{!97, !"_ZN17bnserve_inference6kernel5_sums9spline_atB4v319B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dEd5ArrayIdLi1E1C7mutable7alignedExxx"}
!98 = !{!99, !93, !60}
!99 = distinct !{!99, !100, !"_ZN17bnserve_inference14adjoint_kernel7_source10_fill_barsB4v296B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!100 = distinct !{!100, !"_ZN17bnserve_inference14adjoint_kernel7_source10_fill_barsB4v296B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!101 = !{!102, !93, !60}
!102 = distinct !{!102, !103, !"_ZN17bnserve_inference14adjoint_kernel5_sums9add_fixedB4v303B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedEd5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!103 = distinct !{!103, !"_ZN17bnserve_inference14adjoint_kernel5_sums9add_fixedB4v303B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedEd5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE"}
!104 = !{!105, !93, !60}
!105 = distinct !{!105, !106, !"_ZN17bnserve_inference14adjoint_kernel5_sums11add_splinedB4v322B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedEd5ArrayIdLi1E1C7mutable7alignedE8UniTupleIxLi3EE8UniTupleIdLi6EE8UniTupleIdLi6EEx5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!106 = distinct !{!106, !"_ZN17bnserve_inference14adjoint_kernel5_sums11add_splinedB4v322B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedEd5ArrayIdLi1E1C7mutable7alignedE8UniTupleIxLi3EE8UniTupleIdLi6EE8UniTupleIdLi6EEx5ArrayIdLi1E1C7mutable7alignedE"}
!107 = !{!108, !60}
!108 = distinct !{!108, !109, !"_ZN17bnserve_inference14adjoint_kernel7_source14_through_pairsB4v343B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!109 = distinct !{!109, !"_ZN17bnserve_inference14adjoint_kernel7_source14_through_pairsB4v343B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!110 = !{!111, !108, !60}
!111 = distinct !{!111, !112, !"_ZN17bnserve_inference14adjoint_kernel5_sums8add_pairB4v363B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEbddEdx5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!112 = distinct !{!112, !"_ZN17bnserve_inference14adjoint_kernel5_sums8add_pairB4v363B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEbddEdx5ArrayIdLi1E1C7mutable7alignedE"}
!113 = !{!114, !108, !60}
!114 = distinct !{!114, !115, !"_ZN17bnserve_inference14adjoint_kernel5_sums8add_pairB4v363B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEbddEdx5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!115 = distinct !{!115, !"_ZN17bnserve_inference14adjoint_kernel5_sums8add_pairB4v363B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEbddEdx5ArrayIdLi1E1C7mutable7alignedE"}
