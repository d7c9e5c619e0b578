; sources: 729a6ec9be5cedaf2e61a70e40ffcdd208164d9379b3d9fc524ff99e01de336e
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
  %.509.i.i.i = alloca ptr, align 8
  %.880.i.i128 = alloca double, align 8
  %.869.i = alloca ptr, align 8
  %.904.i = alloca ptr, align 8
  %.1607.i = alloca ptr, align 8
  %.823.i.i = alloca ptr, align 8
  %.47 = load i64, ptr %arg.arguments.4, align 8
  %.76 = getelementptr i8, ptr %arg.arguments.4, i64 136
  %.143 = getelementptr i8, ptr %arg.arguments.4, i64 8
  %.144 = load i64, ptr %.143, align 8
  %.145 = sub i64 0, %.144
  %.153.1 = and i64 %.145, -8
  %.187 = sub i64 0, %.153.1
  %.226 = getelementptr i8, ptr %arg.arguments.4, i64 248
  %.227 = load i64, ptr %.226, align 8
  %.229 = inttoptr i64 %.227 to ptr
  %.362.idx = mul i64 %.47, 200
  %.362 = getelementptr i8, ptr %.229, i64 %.362.idx
  %.432.idx = mul nsw i64 %.47, 352
  %.432 = getelementptr inbounds i8, ptr %.229, i64 %.432.idx
  %.517 = getelementptr i8, ptr %arg.arguments.4, i64 160
  %.518 = load i64, ptr %.517, align 8
  %.598983.not = icmp slt i64 %.518, 1
  br i1 %.598983.not, label %B1394, label %B544.if.lr.ph

B1190:                                            ; preds = %_ZN17bnserve_inference14adjoint_kernel7_source12_in_detectorB4v146B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxx5ArrayIxLi1E1C7mutable7alignedEd5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit, %_ZN17bnserve_inference14adjoint_kernel7_source9_polariseB3v94B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit
  %.84.i = load i64, ptr %.106, align 8, !noalias !0
  %.114.i = load i64, ptr %.76, align 8, !noalias !0
  %.144.i = load i64, ptr %.143, align 8, !noalias !0
  %.149.i = sub i64 0, %.144.i
  %.157.1.i = and i64 %.149.i, -8
  %.193.i = sub nsw i64 %.144.i, %.1020890909
  %.13.i.i = tail call i64 @llvm.smin.i64(i64 %.193.i, i64 range(i64 -9223372036854775808, 129) %.13.i)
  %.464729.not.i = icmp slt i64 %.84.i, 1
  br i1 %.464729.not.i, label %B482.i, label %B334.if.lr.ph.i

B482.i:                                           ; preds = %_ZN17bnserve_inference14adjoint_kernel5_back10waves_backB4v570B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE.exit.i, %B1190
  %.781.i = load i64, ptr %.780.i, align 8, !noalias !0
  %.782.not.i = icmp eq i64 %.781.i, 0
  %.978758.not.i = icmp slt i64 %.114.i, 1
  %or.cond.i = select i1 %.782.not.i, i1 true, i1 %.978758.not.i
  br i1 %or.cond.i, label %_ZN17bnserve_inference14adjoint_kernel7_source11_block_backB4v557B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit, label %B632.if.lr.ph.i

B934.loopexit.unr-lcssa.i:                        ; preds = %B860.if.i
  br i1 %13, label %B934.i, label %B860.if.epil.preheader.i

B860.if.epil.preheader.i:                         ; preds = %B632.if.i, %B934.loopexit.unr-lcssa.i
  %.1373734736.epil.init.i = phi i64 [ 0, %B632.if.i ], [ %.1380.1.i, %B934.loopexit.unr-lcssa.i ]
  %0 = inttoptr i64 %.1056.i to ptr
  %.1412.epil.i = getelementptr inbounds double, ptr %.1218.i, i64 %.1373734736.epil.init.i
  %.1414.epil.i = load <8 x double>, ptr %.1412.epil.i, align 8, !noalias !0
  %.8.i.epil.i = fmul contract <8 x double> %.7.i.i, %.1414.epil.i
  %.1447.epil.i = getelementptr inbounds double, ptr %0, i64 %.1373734736.epil.init.i
  store <8 x double> %.8.i.epil.i, ptr %.1447.epil.i, align 8, !noalias !0
  br label %B934.i

B934.i:                                           ; preds = %B632.if.i, %B860.if.epil.preheader.i, %B934.loopexit.unr-lcssa.i
  %scevgep125.i = getelementptr i8, ptr %lsr.iv.i3, i64 27648
  %exitcond793.not.i = icmp eq i64 %.991.i, %.114.i
  br i1 %exitcond793.not.i, label %_ZN17bnserve_inference14adjoint_kernel7_source11_block_backB4v557B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit, label %B632.if.i

B334.if.lr.ph.i:                                  ; preds = %B1190
  %.261.i = load i64, ptr %.456.i, align 8, !noalias !0
  %1 = shl i64 %.1020890909, 4
  %scevgep135.i = getelementptr i8, ptr %166, i64 %1
  %2 = lshr i64 %.149.i, 3
  %3 = mul i64 %2, -128
  %4 = inttoptr i64 %.261.i to ptr
  %.431.i.i = shl nsw i64 %.13.i.i, 1
  %5 = add nsw i64 %.13.i.i, 7
  %.964.i.i = lshr i64 %5, 3
  %.943.inv.i.i = icmp slt i64 %.13.i.i, 1
  %.9851871.not1883.i.i = icmp eq i64 %.964.i.i, 0
  %.9851871.not.i.i = select i1 %.943.inv.i.i, i1 true, i1 %.9851871.not1883.i.i
  %6 = add nuw nsw i64 %.964.i.i, 4
  br label %B334.if.i

B334.if.i:                                        ; preds = %_ZN17bnserve_inference14adjoint_kernel5_back10waves_backB4v570B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE.exit.i, %B334.if.lr.ph.i
  %lsr.iv136.i = phi ptr [ %scevgep135.i, %B334.if.lr.ph.i ], [ %scevgep137.i, %_ZN17bnserve_inference14adjoint_kernel5_back10waves_backB4v570B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE.exit.i ]
  %.470726730.i = phi i64 [ 0, %B334.if.lr.ph.i ], [ %.477.i, %_ZN17bnserve_inference14adjoint_kernel5_back10waves_backB4v570B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE.exit.i ]
  %7 = shl i64 %.470726730.i, 3
  %scevgep134.i = getelementptr i8, ptr %4, i64 %7
  %.602.i = load i64, ptr %scevgep134.i, align 8, !noalias !0
  %.idx713.i = mul i64 %.602.i, 27648
  %8 = getelementptr i8, ptr %.432, i64 %.idx713.i
  %.624.i = getelementptr i8, ptr %8, i64 14336
  call void @llvm.lifetime.start.p0(ptr nonnull %.823.i.i), !noalias !0
  store ptr null, ptr %.823.i.i, align 8, !noalias !3
  %.93.i.i = load i64, ptr %.106, align 8, !noalias !3
  %.123.i.i = load i64, ptr %.143, align 8, !noalias !3
  %.154.i.i = load i64, ptr %.275.i90, align 8, !noalias !3
  %.155.i.i = mul nsw i64 %.93.i.i, %.604928988
  %.156.i.i = add nsw i64 %.155.i.i, %.470726730.i
  %.157.i.i = shl nsw i64 %.156.i.i, 3
  %.158.i.i = add nsw i64 %.157.i.i, %.154.i.i
  %.159.i.i = inttoptr i64 %.158.i.i to ptr
  %.237.i.i = load double, ptr %.159.i.i, align 8, !noalias !3
  %.274.i.i = load i64, ptr %.365.i, align 8, !noalias !3
  %.277.i.i = shl nsw i64 %.156.i.i, 4
  %.278.i.i = add nsw i64 %.274.i.i, %.277.i.i
  %.279.i.i = inttoptr i64 %.278.i.i to ptr
  %.355.i.i = load double, ptr %.279.i.i, align 8, !noalias !3
  %.383.i.i = getelementptr i8, ptr %.279.i.i, i64 8
  %.384.i.i = load double, ptr %.383.i.i, align 8, !noalias !3
  %.424.i.i = load i64, ptr %.178.i, align 8, !noalias !3
  %.427.i.i = mul nsw i64 %.156.i.i, %.123.i.i
  %.428.i.i = add nsw i64 %.427.i.i, %.1020890909
  %.429.i.i = shl nsw i64 %.428.i.i, 4
  %.430.i.i = add nsw i64 %.424.i.i, %.429.i.i
  %.432.i.i = inttoptr i64 %.430.i.i to ptr
  %.510.i.i = load i64, ptr %.509.i.i, align 8, !noalias !3
  store ptr null, ptr %.823.i.i, align 8, !noalias !3
  call fastcc void @inner_1(ptr nonnull %.823.i.i, i64 range(i64 -9223372036854775808, 129) %.13.i.i, ptr %.432.i.i, i64 %.431.i.i, ptr nonnull %.677.i.i, ptr nonnull %.760.i.i)
  br i1 %.9851871.not.i.i, label %_ZN17bnserve_inference14adjoint_kernel5_back10waves_backB4v570B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE.exit.i, label %B850.if.lr.ph.i.i

B1546.i.i:                                        ; preds = %B850.if.i.i
  %9 = shl i64 %lsr.iv431.i.i, 1
  %scevgep433.i.i = getelementptr i8, ptr %lsr.iv136.i, i64 %9
  %.1750.i.i = load <16 x double>, ptr %scevgep433.i.i, align 8, !noalias !3
  %.1751.i.i = shufflevector <16 x double> %.1750.i.i, <16 x double> poison, <8 x i32> <i32 0, i32 2, i32 4, i32 6, i32 8, i32 10, i32 12, i32 14>
  %.6.i.i.i = fadd contract <8 x double> %.1653.i.i, %.1751.i.i
  %.1752.i.i = shufflevector <16 x double> %.1750.i.i, <16 x double> poison, <8 x i32> <i32 1, i32 3, i32 5, i32 7, i32 9, i32 11, i32 13, i32 15>
  %.6.i312.i.i = fadd contract <8 x double> %.1692.i.i, %.1752.i.i
  br label %B1622.i.i

B1622.i.i:                                        ; preds = %B850.if.i.i, %B1546.i.i
  %imaginary.2.1.i.i = phi <8 x double> [ %.1692.i.i, %B850.if.i.i ], [ %.6.i312.i.i, %B1546.i.i ]
  %real.2.1.i.i = phi <8 x double> [ %.1653.i.i, %B850.if.i.i ], [ %.6.i.i.i, %B1546.i.i ]
  %10 = shl i64 %lsr.iv431.i.i, 1
  %scevgep.i.i = getelementptr i8, ptr %lsr.iv136.i, i64 %10
  %.1834.i.i = shufflevector <8 x double> %real.2.1.i.i, <8 x double> %imaginary.2.1.i.i, <16 x i32> <i32 0, i32 8, i32 1, i32 9, i32 2, i32 10, i32 3, i32 11, i32 4, i32 12, i32 5, i32 13, i32 6, i32 14, i32 7, i32 15>
  store <16 x double> %.1834.i.i, ptr %scevgep.i.i, align 4, !noalias !3
  %.6.i247.i.i = fmul contract <8 x double> %.1117.i.i, %.1511.i.i
  %.6.i313.i.i = fmul contract <8 x double> %.1213.i.i, %.1607.i.i
  %.6.i314.i.i = fsub contract <8 x double> %.6.i247.i.i, %.6.i313.i.i
  %.6.i315.i.i = fadd contract <8 x double> %a.2.01874.i.i, %.6.i314.i.i
  %.6.i316.i.i = fmul contract <8 x double> %.1213.i.i, %.1511.i.i
  %.1974.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1117.i.i, <8 x double> %.1607.i.i, <8 x double> %.6.i316.i.i)
  %.6.i317.i.i = fadd contract <8 x double> %b.2.01875.i.i, %.1974.i.i
  %.6.i318.i.i = fmul contract <8 x double> %.1314.i.i, %.1511.i.i
  %.6.i319.i.i = fmul contract <8 x double> %.1410.i.i, %.1607.i.i
  %.6.i320.i.i = fsub contract <8 x double> %.6.i318.i.i, %.6.i319.i.i
  %.6.i321.i.i = fadd contract <8 x double> %c.2.01876.i.i, %.6.i320.i.i
  %.6.i322.i.i = fmul contract <8 x double> %.1410.i.i, %.1511.i.i
  %.2139.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1314.i.i, <8 x double> %.1607.i.i, <8 x double> %.6.i322.i.i)
  %.6.i323.i.i = fadd contract <8 x double> %d.2.01877.i.i, %.2139.i.i
  %lsr.iv.next432.i.i = add i64 %lsr.iv431.i.i, 64
  %lsr.iv.next2.i.i = add nsw i64 %lsr.iv1.i.i, -1
  %.985.i.i = icmp sgt i64 %lsr.iv1.i.i, 5
  br i1 %.985.i.i, label %B850.if.i.i, label %_ZN17bnserve_inference14adjoint_kernel5_back10waves_backB4v570B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE.exit.i

B850.if.lr.ph.i.i:                                ; preds = %B334.if.i
  %.1618.i.i = fneg contract double %.384.i.i
  %.1646.i.i = insertelement <8 x double> poison, double %.355.i.i, i64 0
  %.1647.i.i = shufflevector <8 x double> %.1646.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1651.i.i = insertelement <8 x double> poison, double %.237.i.i, i64 0
  %.1652.i.i = shufflevector <8 x double> %.1651.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1657.i.i = fneg contract double %.355.i.i
  %.1655.i.i = fneg contract double %.237.i.i
  %.1686.i.i = insertelement <8 x double> poison, double %.1657.i.i, i64 0
  %.1687.i.i = shufflevector <8 x double> %.1686.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1690.i.i = insertelement <8 x double> poison, double %.1655.i.i, i64 0
  %.1691.i.i = shufflevector <8 x double> %.1690.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.6.i308.i.i = insertelement <8 x double> poison, double %.1618.i.i, i64 0
  %.7.i.i.i = shufflevector <8 x double> %.6.i308.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  br label %B850.if.i.i

B850.if.i.i:                                      ; preds = %B850.if.lr.ph.i.i, %B1622.i.i
  %lsr.iv1.i.i = phi i64 [ %6, %B850.if.lr.ph.i.i ], [ %lsr.iv.next2.i.i, %B1622.i.i ]
  %lsr.iv431.i.i = phi i64 [ 0, %B850.if.lr.ph.i.i ], [ %lsr.iv.next432.i.i, %B1622.i.i ]
  %d.2.01877.i.i = phi <8 x double> [ zeroinitializer, %B850.if.lr.ph.i.i ], [ %.6.i323.i.i, %B1622.i.i ]
  %c.2.01876.i.i = phi <8 x double> [ zeroinitializer, %B850.if.lr.ph.i.i ], [ %.6.i321.i.i, %B1622.i.i ]
  %b.2.01875.i.i = phi <8 x double> [ zeroinitializer, %B850.if.lr.ph.i.i ], [ %.6.i317.i.i, %B1622.i.i ]
  %a.2.01874.i.i = phi <8 x double> [ zeroinitializer, %B850.if.lr.ph.i.i ], [ %.6.i315.i.i, %B1622.i.i ]
  %sunkaddr11.i.i = getelementptr i8, ptr %.624.i, i64 %lsr.iv431.i.i
  %sunkaddr12.i.i = getelementptr i8, ptr %sunkaddr11.i.i, i64 22528
  %.1117.i.i = load <8 x double>, ptr %sunkaddr12.i.i, align 8, !noalias !3
  %sunkaddr14.i.i = getelementptr i8, ptr %sunkaddr11.i.i, i64 23552
  %.1213.i.i = load <8 x double>, ptr %sunkaddr14.i.i, align 8, !noalias !3
  %sunkaddr16.i.i = getelementptr i8, ptr %sunkaddr11.i.i, i64 24576
  %.1314.i.i = load <8 x double>, ptr %sunkaddr16.i.i, align 8, !noalias !3
  %sunkaddr19.i.i = getelementptr i8, ptr %sunkaddr11.i.i, i64 25600
  %.1410.i.i = load <8 x double>, ptr %sunkaddr19.i.i, align 8, !noalias !3
  %scevgep435.i.i = getelementptr i8, ptr %.760.i.i, i64 %lsr.iv431.i.i
  %scevgep436.i.i = getelementptr i8, ptr %scevgep435.i.i, i64 -1024
  %.1511.i.i = load <8 x double>, ptr %scevgep436.i.i, align 8, !noalias !3
  %.1607.i.i = load <8 x double>, ptr %scevgep435.i.i, align 8, !noalias !3
  %.8.i.i.i = fmul contract <8 x double> %.7.i.i.i, %.1410.i.i
  %.1648.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1314.i.i, <8 x double> %.1647.i.i, <8 x double> %.8.i.i.i)
  %.1653.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1117.i.i, <8 x double> %.1652.i.i, <8 x double> %.1648.i.i)
  %.8.i311.i.i = fmul contract <8 x double> %.7.i.i.i, %.1314.i.i
  %.1688.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1410.i.i, <8 x double> %.1687.i.i, <8 x double> %.8.i311.i.i)
  %.1692.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1213.i.i, <8 x double> %.1691.i.i, <8 x double> %.1688.i.i)
  %.1736.i.i = load i64, ptr %sunkaddr20.i.i, align 8, !noalias !3
  %.1737.i.i = icmp eq i64 %.1736.i.i, 1
  br i1 %.1737.i.i, label %B1546.i.i, label %B1622.i.i

_ZN17bnserve_inference14adjoint_kernel5_back10waves_backB4v570B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE.exit.i: ; preds = %B1622.i.i, %B334.if.i
  %a.2.0.lcssa.i.i = phi <8 x double> [ zeroinitializer, %B334.if.i ], [ %.6.i315.i.i, %B1622.i.i ]
  %b.2.0.lcssa.i.i = phi <8 x double> [ zeroinitializer, %B334.if.i ], [ %.6.i317.i.i, %B1622.i.i ]
  %c.2.0.lcssa.i.i = phi <8 x double> [ zeroinitializer, %B334.if.i ], [ %.6.i321.i.i, %B1622.i.i ]
  %d.2.0.lcssa.i.i = phi <8 x double> [ zeroinitializer, %B334.if.i ], [ %.6.i323.i.i, %B1622.i.i ]
  %.513.i.i = shl nsw i64 %.156.i.i, 5
  %sunkaddr.i.i = inttoptr i64 %.510.i.i to ptr
  %sunkaddr444.i.i = getelementptr i8, ptr %sunkaddr.i.i, i64 %.513.i.i
  %.2233.i.i = load double, ptr %sunkaddr444.i.i, align 8, !noalias !3
  store <8 x double> %a.2.0.lcssa.i.i, ptr %sunkaddr445.i.i, align 8, !noalias !3
  %.2279.i.i = load double, ptr %sunkaddr445.i.i, align 8, !noalias !3
  %.2308.i.i = load double, ptr %.2307.i.i, align 8, !noalias !3
  %.2309.i.i = fadd contract double %.2279.i.i, %.2308.i.i
  %.2338.i.i = load double, ptr %.2337.i.i, align 8, !noalias !3
  %.2367.i.i = load double, ptr %.2366.i.i, align 8, !noalias !3
  %.2368.i.i = fadd contract double %.2338.i.i, %.2367.i.i
  %.2369.i.i = fadd contract double %.2309.i.i, %.2368.i.i
  %.2398.i.i = load double, ptr %.2397.i.i, align 8, !noalias !3
  %.2427.i.i = load double, ptr %.2426.i.i, align 8, !noalias !3
  %.2428.i.i = fadd contract double %.2398.i.i, %.2427.i.i
  %.2457.i.i = load double, ptr %.2456.i.i, align 8, !noalias !3
  %.2486.i.i = load double, ptr %.2485.i.i, align 8, !noalias !3
  %.2490.i.i = fadd contract double %.2457.i.i, %.2486.i.i
  %.2491.i.i = fadd contract double %.2428.i.i, %.2490.i.i
  %.2492.i.i = fadd contract double %.2369.i.i, %.2491.i.i
  %.2493.i.i = fadd contract double %.2233.i.i, %.2492.i.i
  store double %.2493.i.i, ptr %sunkaddr444.i.i, align 8, !noalias !3
  %sunkaddr448.i.i = getelementptr i8, ptr %sunkaddr444.i.i, i64 8
  %.2553.i.i = load double, ptr %sunkaddr448.i.i, align 8, !noalias !3
  store <8 x double> %b.2.0.lcssa.i.i, ptr %sunkaddr445.i.i, align 8, !noalias !3
  %.2599.i.i = load double, ptr %sunkaddr445.i.i, align 8, !noalias !3
  %.2628.i.i = load double, ptr %.2307.i.i, align 8, !noalias !3
  %.2629.i.i = fadd contract double %.2599.i.i, %.2628.i.i
  %.2658.i.i = load double, ptr %.2337.i.i, align 8, !noalias !3
  %.2687.i.i = load double, ptr %.2366.i.i, align 8, !noalias !3
  %.2688.i.i = fadd contract double %.2658.i.i, %.2687.i.i
  %.2689.i.i = fadd contract double %.2629.i.i, %.2688.i.i
  %.2718.i.i = load double, ptr %.2397.i.i, align 8, !noalias !3
  %.2747.i.i = load double, ptr %.2426.i.i, align 8, !noalias !3
  %.2748.i.i = fadd contract double %.2718.i.i, %.2747.i.i
  %.2777.i.i = load double, ptr %.2456.i.i, align 8, !noalias !3
  %.2806.i.i = load double, ptr %.2485.i.i, align 8, !noalias !3
  %.2810.i.i = fadd contract double %.2777.i.i, %.2806.i.i
  %.2811.i.i = fadd contract double %.2748.i.i, %.2810.i.i
  %.2812.i.i = fadd contract double %.2689.i.i, %.2811.i.i
  %.2813.i.i = fadd contract double %.2553.i.i, %.2812.i.i
  store double %.2813.i.i, ptr %sunkaddr448.i.i, align 8, !noalias !3
  %sunkaddr451.i.i = getelementptr i8, ptr %sunkaddr444.i.i, i64 16
  %.2873.i.i = load double, ptr %sunkaddr451.i.i, align 8, !noalias !3
  store <8 x double> %c.2.0.lcssa.i.i, ptr %sunkaddr445.i.i, align 8, !noalias !3
  %.2919.i.i = load double, ptr %sunkaddr445.i.i, align 8, !noalias !3
  %.2948.i.i = load double, ptr %.2307.i.i, align 8, !noalias !3
  %.2949.i.i = fadd contract double %.2919.i.i, %.2948.i.i
  %.2978.i.i = load double, ptr %.2337.i.i, align 8, !noalias !3
  %.3007.i.i = load double, ptr %.2366.i.i, align 8, !noalias !3
  %.3008.i.i = fadd contract double %.2978.i.i, %.3007.i.i
  %.3009.i.i = fadd contract double %.2949.i.i, %.3008.i.i
  %.3038.i.i = load double, ptr %.2397.i.i, align 8, !noalias !3
  %.3067.i.i = load double, ptr %.2426.i.i, align 8, !noalias !3
  %.3068.i.i = fadd contract double %.3038.i.i, %.3067.i.i
  %.3097.i.i = load double, ptr %.2456.i.i, align 8, !noalias !3
  %.3126.i.i = load double, ptr %.2485.i.i, align 8, !noalias !3
  %.3130.i.i = fadd contract double %.3097.i.i, %.3126.i.i
  %.3131.i.i = fadd contract double %.3068.i.i, %.3130.i.i
  %.3132.i.i = fadd contract double %.3009.i.i, %.3131.i.i
  %.3133.i.i = fadd contract double %.2873.i.i, %.3132.i.i
  store double %.3133.i.i, ptr %sunkaddr451.i.i, align 8, !noalias !3
  %sunkaddr454.i.i = getelementptr i8, ptr %sunkaddr444.i.i, i64 24
  %.3193.i.i = load double, ptr %sunkaddr454.i.i, align 8, !noalias !3
  store <8 x double> %d.2.0.lcssa.i.i, ptr %sunkaddr445.i.i, align 8, !noalias !3
  %.3244.i.i = load double, ptr %sunkaddr445.i.i, align 8, !noalias !3
  %.3273.i.i = load double, ptr %.2307.i.i, align 8, !noalias !3
  %.3274.i.i = fadd contract double %.3244.i.i, %.3273.i.i
  %.3303.i.i = load double, ptr %.2337.i.i, align 8, !noalias !3
  %.3332.i.i = load double, ptr %.2366.i.i, align 8, !noalias !3
  %.3333.i.i = fadd contract double %.3303.i.i, %.3332.i.i
  %.3334.i.i = fadd contract double %.3274.i.i, %.3333.i.i
  %.3363.i.i = load double, ptr %.2397.i.i, align 8, !noalias !3
  %.3392.i.i = load double, ptr %.2426.i.i, align 8, !noalias !3
  %.3393.i.i = fadd contract double %.3363.i.i, %.3392.i.i
  %.3422.i.i = load double, ptr %.2456.i.i, align 8, !noalias !3
  %.3451.i.i = load double, ptr %.2485.i.i, align 8, !noalias !3
  %.3455.i.i = fadd contract double %.3422.i.i, %.3451.i.i
  %.3456.i.i = fadd contract double %.3393.i.i, %.3455.i.i
  %.3457.i.i = fadd contract double %.3334.i.i, %.3456.i.i
  %.3458.i.i = fadd contract double %.3193.i.i, %.3457.i.i
  store double %.3458.i.i, ptr %sunkaddr454.i.i, align 8, !noalias !3
  call void @llvm.lifetime.end.p0(ptr nonnull %.823.i.i), !noalias !0
  %.477.i = add nuw nsw i64 %.470726730.i, 1
  %scevgep137.i = getelementptr i8, ptr %lsr.iv136.i, i64 %3
  %exitcond.not.i1 = icmp eq i64 %.84.i, %.477.i
  br i1 %exitcond.not.i1, label %B482.i, label %B334.if.i

B632.if.lr.ph.i:                                  ; preds = %B482.i
  %.814.i = load i64, ptr %.813.i, align 8, !noalias !0
  %.815.i = inttoptr i64 %.814.i to ptr
  %.890.i = getelementptr i8, ptr %.815.i, i64 8
  %.891.i = load double, ptr %.890.i, align 8, !noalias !0
  %.1049.i = mul nuw nsw i64 %.114.i, %.604928988
  %.1346.i = lshr exact i64 %.13.i, 3
  %.1325.inv.i = icmp sgt i64 %.1057, 0
  %storemerge712.i = select i1 %.1325.inv.i, i64 %.1346.i, i64 0
  %.6.i.i = insertelement <8 x double> poison, double %.891.i, i64 0
  %.7.i.i = shufflevector <8 x double> %.6.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %11 = and i64 %storemerge712.i, 2305843009213693950
  %trunc.i = trunc nuw i64 %storemerge712.i to i61
  %12 = and i64 %storemerge712.i, 1
  %13 = icmp eq i64 %12, 0
  br label %B632.if.i

B632.if.i:                                        ; preds = %B632.if.lr.ph.i, %B934.i
  %lsr.iv.i3 = phi ptr [ %scevgep.i2, %B632.if.lr.ph.i ], [ %scevgep125.i, %B934.i ]
  %.984744761.i = phi i64 [ 0, %B632.if.lr.ph.i ], [ %.991.i, %B934.i ]
  %.991.i = add nuw nsw i64 %.984744761.i, 1
  %.1046.i = load i64, ptr %.780.i, align 8, !noalias !0
  %.1050.i = add nuw nsw i64 %.984744761.i, %.1049.i
  %14 = mul i64 %.1050.i, %.157.1.i
  %.1054.i = sub i64 %.1020890909, %14
  %.1055.i = shl nsw i64 %.1054.i, 3
  %.1056.i = add nsw i64 %.1055.i, %.1046.i
  %.idx.i = mul i64 %.984744761.i, 27648
  %15 = getelementptr i8, ptr %.432, i64 %.idx.i
  %.1218.i = getelementptr i8, ptr %15, i64 40960
  switch i61 %trunc.i, label %B860.if.preheader.i [
    i61 0, label %B934.i
    i61 1, label %B860.if.epil.preheader.i
  ]

B860.if.preheader.i:                              ; preds = %B632.if.i
  %16 = inttoptr i64 %.1056.i to ptr
  %scevgep129.i = getelementptr i8, ptr %16, i64 64
  br label %B860.if.i

B860.if.i:                                        ; preds = %B860.if.i, %B860.if.preheader.i
  %lsr.iv8.i = phi i64 [ %lsr.iv.next.i4, %B860.if.i ], [ %11, %B860.if.preheader.i ]
  %.1373734736.i = phi i64 [ %.1380.1.i, %B860.if.i ], [ 0, %B860.if.preheader.i ]
  %17 = shl i64 %.1373734736.i, 3
  %scevgep127.i = getelementptr i8, ptr %lsr.iv.i3, i64 %17
  %scevgep128.i = getelementptr i8, ptr %scevgep127.i, i64 -64
  %.1414.i = load <8 x double>, ptr %scevgep128.i, align 8, !noalias !0
  %.8.i.i = fmul contract <8 x double> %.7.i.i, %.1414.i
  %scevgep131.i = getelementptr i8, ptr %scevgep129.i, i64 %17
  %scevgep11.i = getelementptr i8, ptr %scevgep131.i, i64 -64
  store <8 x double> %.8.i.i, ptr %scevgep11.i, align 8, !noalias !0
  %.1414.1.i = load <8 x double>, ptr %scevgep127.i, align 8, !noalias !0
  %.8.i.1.i = fmul contract <8 x double> %.7.i.i, %.1414.1.i
  %.1380.1.i = add i64 %.1373734736.i, 16
  store <8 x double> %.8.i.1.i, ptr %scevgep131.i, align 8, !noalias !0
  %lsr.iv.next.i4 = add i64 %lsr.iv8.i, -2
  %niter.ncmp.1.not.i = icmp eq i64 %lsr.iv.next.i4, 0
  br i1 %niter.ncmp.1.not.i, label %B934.loopexit.unr-lcssa.i, label %B860.if.i

_ZN17bnserve_inference14adjoint_kernel7_source11_block_backB4v557B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit: ; preds = %B934.i, %B482.i
  %.1014 = icmp sgt i64 %.1013884910, 1
  br i1 %.1014, label %B896.if, label %B1232

B1232:                                            ; preds = %_ZN17bnserve_inference14adjoint_kernel7_source11_block_backB4v557B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit, %_ZN17bnserve_inference13moving_kernel8_passing12find_passingB3v57B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIxLi1E1C7mutable7alignedE.exit
  %.74.i = load i64, ptr %sunkaddr97, align 8, !noalias !6
  %.75.i = inttoptr i64 %.74.i to ptr
  %.152.i = getelementptr i8, ptr %.75.i, i64 8
  %.153.i = load double, ptr %.152.i, align 8, !noalias !6
  %.275.i = load i64, ptr %arg.arguments.4, align 8, !noalias !6
  %.358494.not.i = icmp slt i64 %.275.i, 1
  br i1 %.358494.not.i, label %B1232.endif, label %B244.if.lr.ph.i

B244.if.lr.ph.i:                                  ; preds = %B1232
  %.191.i = shl nsw i64 %.604928988, 5
  %.189.i = load i64, ptr %sunkaddr, align 8, !noalias !6
  %sunkaddr.i = inttoptr i64 %.189.i to ptr
  %sunkaddr62.i = getelementptr i8, ptr %sunkaddr.i, i64 %.191.i
  %sunkaddr65.i = getelementptr i8, ptr %sunkaddr62.i, i64 8
  %sunkaddr68.i = getelementptr i8, ptr %sunkaddr62.i, i64 16
  %sunkaddr71.i = getelementptr i8, ptr %sunkaddr62.i, i64 24
  %sunkaddr62.promoted.i = load double, ptr %sunkaddr62.i, align 8, !noalias !6
  %sunkaddr65.promoted.i = load double, ptr %sunkaddr65.i, align 8, !noalias !6
  %sunkaddr68.promoted.i = load double, ptr %sunkaddr68.i, align 8, !noalias !6
  %sunkaddr71.promoted.i = load double, ptr %sunkaddr71.i, align 8, !noalias !6
  br label %B244.if.i

B244.if.i:                                        ; preds = %B244.if.i, %B244.if.lr.ph.i
  %.9954.i = phi double [ %sunkaddr71.promoted.i, %B244.if.lr.ph.i ], [ %.995.i, %B244.if.i ]
  %.9313.i = phi double [ %sunkaddr68.promoted.i, %B244.if.lr.ph.i ], [ %.931.i, %B244.if.i ]
  %.8382.i = phi double [ %sunkaddr65.promoted.i, %B244.if.lr.ph.i ], [ %.838.i, %B244.if.i ]
  %.7771.i = phi double [ %sunkaddr62.promoted.i, %B244.if.lr.ph.i ], [ %.777.i, %B244.if.i ]
  %lsr.iv61.i = phi i64 [ %.275.i, %B244.if.lr.ph.i ], [ %lsr.iv.next.i, %B244.if.i ]
  %lsr.iv59.i = phi ptr [ %scevgep58.i, %B244.if.lr.ph.i ], [ %scevgep60.i, %B244.if.i ]
  %lsr.iv.i = phi ptr [ %scevgep.i, %B244.if.lr.ph.i ], [ %scevgep51.i, %B244.if.i ]
  %.556.i = load double, ptr %lsr.iv.i, align 8, !noalias !6
  %scevgep52.i = getelementptr i8, ptr %lsr.iv.i, i64 -24
  %.585.i = load double, ptr %scevgep52.i, align 8, !noalias !6
  %.614.i = load double, ptr %lsr.iv59.i, align 8, !noalias !6
  %.618.i = fmul contract double %.556.i, %.614.i
  %.619.i = fadd contract double %.585.i, %.618.i
  %scevgep53.i = getelementptr i8, ptr %lsr.iv.i, i64 -16
  %.648.i = load double, ptr %scevgep53.i, align 8, !noalias !6
  %scevgep54.i = getelementptr i8, ptr %lsr.iv.i, i64 -64
  %.677.i = load double, ptr %scevgep54.i, align 8, !noalias !6
  %.678.i = fmul contract double %.556.i, %.677.i
  %.679.i = fadd contract double %.648.i, %.678.i
  %scevgep55.i = getelementptr i8, ptr %lsr.iv.i, i64 -32
  %.709.i = load double, ptr %scevgep55.i, align 8, !noalias !6
  %.711.i = fmul contract double %.153.i, %.709.i
  %.712.i = fmul contract double %.619.i, %.711.i
  %.713.i = fadd contract double %.679.i, %.712.i
  %scevgep56.i = getelementptr i8, ptr %lsr.iv.i, i64 -40
  %.742.i = load double, ptr %scevgep56.i, align 8, !noalias !6
  %.744.i = fmul contract double %.153.i, %.742.i
  %.745.i = fmul contract double %.619.i, %.744.i
  %.746.i = fadd contract double %.619.i, %.745.i
  %.777.i = fsub contract double %.7771.i, %.746.i
  store double %.777.i, ptr %sunkaddr62.i, align 8, !noalias !6
  %.838.i = fadd contract double %.8382.i, %.713.i
  store double %.838.i, ptr %sunkaddr65.i, align 8, !noalias !6
  %scevgep57.i = getelementptr i8, ptr %lsr.iv.i, i64 -8
  %.927.i = load double, ptr %scevgep57.i, align 8, !noalias !6
  %.931.i = fadd contract double %.9313.i, %.927.i
  store double %.931.i, ptr %sunkaddr68.i, align 8, !noalias !6
  %.993.i = fmul contract double %.153.i, %.746.i
  %.994.i = fadd contract double %.556.i, %.993.i
  %.995.i = fadd contract double %.9954.i, %.994.i
  store double %.995.i, ptr %sunkaddr71.i, align 8, !noalias !6
  %scevgep51.i = getelementptr i8, ptr %lsr.iv.i, i64 152
  %scevgep60.i = getelementptr i8, ptr %lsr.iv59.i, i64 200
  %lsr.iv.next.i = add i64 %lsr.iv61.i, -1
  %exitcond.not.i = icmp eq i64 %lsr.iv.next.i, 0
  br i1 %exitcond.not.i, label %B1232.endif, label %B244.if.i

B1312:                                            ; preds = %B1232.endif
  %.1569 = load i64, ptr %.193.i53, align 8
  %.1570 = icmp eq i64 %.1569, 0
  br i1 %.1570, label %B1356, label %B1390

B1356:                                            ; preds = %B1312
  %18 = inttoptr i64 %.875 to ptr
  %.64.i = load i64, ptr %.76, align 8, !noalias !9
  %.94.i = load i64, ptr %.143, align 8, !noalias !9
  %.124.i = load i64, ptr %.106, align 8, !noalias !9
  %.133.i = sub i64 0, %.94.i
  %.141.1.i = and i64 %.133.i, -8
  %.175.i = sub i64 0, %.141.1.i
  %.216.i = shl i64 %.94.i, 1
  %.390.i = load i64, ptr %.389.i, align 8, !noalias !9
  %.393.i = inttoptr i64 %.390.i to ptr
  %.518.i = getelementptr double, ptr %.393.i, i64 %.175.i
  %.667832.not.i = icmp slt i64 %.64.i, 1
  br i1 %.667832.not.i, label %B1390, label %B474.if.lr.ph.i

B1068.i:                                          ; preds = %_ZN17bnserve_inference14adjoint_kernel8_passing10_turn_backB4v613B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedExx8UniTupleIdLi3EE5ArrayIdLi1E1C7mutable7alignedE.exit.i, %B474.if.i
  %exitcond868.not.i = icmp eq i64 %.680.i, %.64.i
  br i1 %exitcond868.not.i, label %B1390, label %B474.if.i

B474.if.lr.ph.i:                                  ; preds = %B1356
  %.305.i = load i64, ptr %.304.i, align 8, !noalias !9
  %.210.i = shl i64 %.604928988, 4
  %.212.i = mul i64 %.210.i, %.94.i
  %.214.i = mul i64 %.212.i, %.124.i
  %.209.i = load i64, ptr %.208.i, align 8, !noalias !9
  %.215.i = add nsw i64 %.209.i, %.214.i
  %.740.i = shl i64 %.175.i, 4
  %.973.i = mul nuw nsw i64 %.64.i, %.604928988
  %.976.i = shl i64 %.175.i, 3
  %19 = tail call i64 @llvm.smax.i64(i64 %.94.i, i64 1)
  %20 = shl i64 %.133.i, 3
  %21 = and i64 %20, -64
  %22 = sub i64 8, %21
  %23 = icmp sgt i64 %.94.i, 1
  %24 = inttoptr i64 %.305.i to ptr
  %25 = inttoptr i64 %.215.i to ptr
  %.187.i.i = icmp sgt i64 %.124.i, 0
  %.218.i = shl i64 %.124.i, 3
  %26 = mul i64 %.218.i, %.216.i
  %27 = add i64 %26, 16
  %28 = add i64 %26, 24
  %29 = or disjoint i64 %26, 8
  %.699491.not.i.i = icmp slt i64 %.124.i, 1
  %30 = shl i64 %.94.i, 4
  %31 = lshr i64 %.133.i, 3
  %32 = mul i64 %31, -128
  br label %B474.if.i

B474.if.i:                                        ; preds = %B474.if.lr.ph.i, %B1068.i
  %.673815835.i = phi i64 [ 0, %B474.if.lr.ph.i ], [ %.680.i, %B1068.i ]
  %.680.i = add nuw nsw i64 %.673815835.i, 1
  br i1 %23, label %B766.if.preheader.i, label %B1068.i

B766.if.preheader.i:                              ; preds = %B474.if.i
  %.970.i = load i64, ptr %sunkaddr118, align 8, !noalias !9
  %.975.i = add nuw nsw i64 %.673815835.i, %.973.i
  %.978.i = mul i64 %.976.i, %.975.i
  %.979.i = add nsw i64 %.970.i, %.978.i
  %.738.i = load i64, ptr %sunkaddr27.i, align 8, !noalias !9
  %.742.i5 = mul i64 %.740.i, %.673815835.i
  %.743.i = add nsw i64 %.738.i, %.742.i5
  %33 = inttoptr i64 %.979.i to ptr
  %34 = inttoptr i64 %.743.i to ptr
  %scevgep.i6 = getelementptr i8, ptr %33, i64 8
  %scevgep139.i = getelementptr i8, ptr %34, i64 %22
  br label %B766.if.i

B766.if.i:                                        ; preds = %_ZN17bnserve_inference14adjoint_kernel8_passing10_turn_backB4v613B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedExx8UniTupleIdLi3EE5ArrayIdLi1E1C7mutable7alignedE.exit.i, %B766.if.preheader.i
  %.1122805807.i = phi i64 [ %49, %_ZN17bnserve_inference14adjoint_kernel8_passing10_turn_backB4v613B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedExx8UniTupleIdLi3EE5ArrayIdLi1E1C7mutable7alignedE.exit.i ], [ 0, %B766.if.preheader.i ]
  %sunkaddr28.i = shl i64 %.1122805807.i, 3
  %sunkaddr29.i = getelementptr i8, ptr %34, i64 %sunkaddr28.i
  %sunkaddr30.i = getelementptr i8, ptr %sunkaddr29.i, i64 8
  %.1184.i = load double, ptr %sunkaddr30.i, align 8, !noalias !9
  %.1214.i = load double, ptr %sunkaddr29.i, align 8, !noalias !9
  %.1215.i = fmul contract double %.1184.i, %.1214.i
  %scevgep22.i = getelementptr i8, ptr %scevgep139.i, i64 %sunkaddr28.i
  %.1246.i = load double, ptr %scevgep22.i, align 8, !noalias !9
  %scevgep21.i = getelementptr i8, ptr %scevgep22.i, i64 -8
  %.1276.i = load double, ptr %scevgep21.i, align 8, !noalias !9
  %.1277.i = fmul contract double %.1246.i, %.1276.i
  %.1278.i = fadd contract double %.1215.i, %.1277.i
  %.1340.i = fmul contract double %.1184.i, %.1276.i
  %.1402.i = fmul contract double %.1214.i, %.1246.i
  %.1403.i = fsub contract double %.1340.i, %.1402.i
  %scevgep18.i = getelementptr i8, ptr %.393.i, i64 %sunkaddr28.i
  %scevgep19.i = getelementptr i8, ptr %scevgep18.i, i64 8
  %.1434.i = load double, ptr %scevgep19.i, align 8, !noalias !9
  %scevgep16.i = getelementptr i8, ptr %scevgep.i6, i64 %sunkaddr28.i
  %.1465.i = load double, ptr %scevgep16.i, align 8, !noalias !9
  %.1466.i = fmul contract double %.1434.i, %.1465.i
  %scevgep17.i = getelementptr i8, ptr %.518.i, i64 %sunkaddr28.i
  %.1496.i = load double, ptr %scevgep17.i, align 8, !noalias !9
  %scevgep13.i = getelementptr i8, ptr %scevgep16.i, i64 -8
  %.1526.i = load double, ptr %scevgep13.i, align 8, !noalias !9
  %.1527.i = fmul contract double %.1496.i, %.1526.i
  %.1528.i = fadd contract double %.1466.i, %.1527.i
  %.1529.i = fneg contract double %.1528.i
  br i1 %.187.i.i, label %B106.if.lr.ph.i.i, label %B242.i.i

B106.if.lr.ph.i.i:                                ; preds = %B766.if.i
  %.328.i.i = shl nuw i64 %.1122805807.i, 1
  br label %B106.if.i.i

B134.i.i:                                         ; preds = %B106.if.i.i
  %.343.i.i = icmp slt i64 %lsr.iv23.i.i, -2
  %35 = shl i64 %lsr.iv23.i.i, 3
  %36 = select i1 %.343.i.i, i64 %27, i64 16
  %scevgep41.i.i = getelementptr i8, ptr %25, i64 %36
  %scevgep42.i.i = getelementptr i8, ptr %scevgep41.i.i, i64 %35
  %.359.i.i = load double, ptr %scevgep42.i.i, align 8, !noalias !12
  %.375.i.i = icmp slt i64 %lsr.iv23.i.i, -3
  %37 = select i1 %.375.i.i, i64 %28, i64 24
  %scevgep39.i.i = getelementptr i8, ptr %25, i64 %37
  %scevgep30.i.i = getelementptr i8, ptr %scevgep39.i.i, i64 %35
  %.391.i.i = load double, ptr %scevgep30.i.i, align 8, !noalias !12
  %.406.i.i = icmp slt i64 %lsr.iv23.i.i, 0
  %38 = select i1 %.406.i.i, i64 %29, i64 8
  %scevgep27.i.i = getelementptr i8, ptr %25, i64 %38
  %scevgep28.i.i = getelementptr i8, ptr %scevgep27.i.i, i64 %35
  %scevgep29.i.i = getelementptr i8, ptr %scevgep28.i.i, i64 -8
  %.422.i.i = load double, ptr %scevgep29.i.i, align 8, !noalias !12
  %.454.i.i = load double, ptr %scevgep28.i.i, align 8, !noalias !12
  %.458.i.i = fmul contract double %.359.i.i, %.422.i.i
  %.459.i.i = fmul contract double %.391.i.i, %.454.i.i
  %.460.i.i = fadd contract double %.458.i.i, %.459.i.i
  %.461.i.i = fmul contract double %.391.i.i, %.422.i.i
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
  %.502.i.i = fadd contract double %imaginary.3.0485.i.i, %.500.i.i
  br label %B240.i.i

B240.i.i:                                         ; preds = %B106.if.i.i, %B134.i.i
  %real.4.1.i.i = phi double [ %.494.i.i, %B134.i.i ], [ %real.3.0484.i.i, %B106.if.i.i ]
  %imaginary.4.1.i.i = phi double [ %.502.i.i, %B134.i.i ], [ %imaginary.3.0485.i.i, %B106.if.i.i ]
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
  br i1 %.561.i.i, label %B338.endif.i.i, label %_ZN17bnserve_inference14adjoint_kernel8_passing10_turn_backB4v613B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedExx8UniTupleIdLi3EE5ArrayIdLi1E1C7mutable7alignedE.exit.i

B452.i.i:                                         ; preds = %B342.if.i.i
  %.801.i.i = icmp slt i64 %lsr.iv.i.i, -2
  %39 = select i1 %.801.i.i, i64 %27, i64 16
  %40 = getelementptr i8, ptr %lsr.iv3.i.i, i64 %47
  %scevgep24.i.i = getelementptr i8, ptr %40, i64 %39
  %.817.i.i = load double, ptr %scevgep24.i.i, align 8, !noalias !12
  %.833.i.i11 = icmp slt i64 %lsr.iv.i.i, -3
  %41 = select i1 %.833.i.i11, i64 %28, i64 24
  %scevgep23.i.i = getelementptr i8, ptr %40, i64 %41
  %.849.i.i = load double, ptr %scevgep23.i.i, align 8, !noalias !12
  %.864.i.i = icmp slt i64 %lsr.iv.i.i, 0
  %42 = select i1 %.864.i.i, i64 %29, i64 8
  %scevgep21.i.i = getelementptr i8, ptr %40, i64 %42
  %scevgep19.i.i = getelementptr i8, ptr %scevgep21.i.i, i64 -8
  %.880.i.i = load double, ptr %scevgep19.i.i, align 8, !noalias !12
  %.912.i.i = load double, ptr %scevgep21.i.i, align 8, !noalias !12
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
  %.964.i.i12 = fmul contract double %.1278.i, %.959.i.i
  %.966.i.i = fmul contract double %.1403.i, %.962.i.i
  %.967.i.i = fsub contract double %.964.i.i12, %.966.i.i
  %.969.i.i = fmul contract double %.1403.i, %.959.i.i
  %.971.i.i = fmul contract double %.1278.i, %.962.i.i
  %.972.i.i = fadd contract double %.969.i.i, %.971.i.i
  %.1130.i.i = icmp slt i64 %lsr.iv21.i.i, -1
  %43 = select i1 %.1130.i.i, i64 %53, i64 24
  %44 = getelementptr i8, ptr %lsr.iv12.i.i, i64 %47
  %scevgep8.i.i = getelementptr i8, ptr %44, i64 %43
  %scevgep10.i.i = getelementptr i8, ptr %scevgep8.i.i, i64 -8
  %.1146.i.i = load double, ptr %scevgep10.i.i, align 8, !noalias !12
  %.1147.i.i = fmul contract double %.880.i.i, %.967.i.i
  %.1148.i.i = fmul contract double %.912.i.i, %.972.i.i
  %.1149.i.i = fadd contract double %.1147.i.i, %.1148.i.i
  %.1150.i.i = fadd contract double %.1146.i.i, %.1149.i.i
  store double %.1150.i.i, ptr %scevgep10.i.i, align 8, !noalias !12
  %.1211.i.i = load double, ptr %scevgep8.i.i, align 8, !noalias !12
  %.1212.i.i = fmul contract double %.880.i.i, %.972.i.i
  %.1213.i.i13 = fmul contract double %.912.i.i, %.967.i.i
  %.1214.i.i = fsub contract double %.1212.i.i, %.1213.i.i13
  %.1215.i.i = fsub contract double %.1211.i.i, %.1214.i.i
  store double %.1215.i.i, ptr %scevgep8.i.i, align 8, !noalias !12
  %.1259.i.i = icmp slt i64 %lsr.iv21.i.i, 0
  %45 = select i1 %.1259.i.i, i64 %54, i64 8
  %scevgep3.i.i = getelementptr i8, ptr %44, i64 %45
  %scevgep4.i.i = getelementptr i8, ptr %scevgep3.i.i, i64 -8
  %.1275.i.i = load double, ptr %scevgep4.i.i, align 8, !noalias !12
  %.1276.i.i = fmul contract double %.817.i.i, %.967.i.i
  %.1277.i.i = fmul contract double %.849.i.i, %.972.i.i
  %.1278.i.i = fsub contract double %.1276.i.i, %.1277.i.i
  %.1279.i.i = fadd contract double %.1275.i.i, %.1278.i.i
  store double %.1279.i.i, ptr %scevgep4.i.i, align 8, !noalias !12
  %.1340.i.i = load double, ptr %scevgep3.i.i, align 8, !noalias !12
  %.1341.i.i = fmul contract double %.849.i.i, %.967.i.i
  %.1342.i.i = fmul contract double %.817.i.i, %.972.i.i
  %.1343.i.i = fadd contract double %.1341.i.i, %.1342.i.i
  %.1344.i.i = fadd contract double %.1340.i.i, %.1343.i.i
  store double %.1344.i.i, ptr %scevgep3.i.i, align 8, !noalias !12
  br label %B480.i.i

B480.i.i:                                         ; preds = %B342.if.i.i, %B452.i.i
  %lsr.iv.next.i.i = add i64 %lsr.iv.i.i, %.216.i
  %lsr.iv.next2.i.i9 = add nsw i64 %lsr.iv1.i.i8, -1
  %scevgep.i.i10 = getelementptr i8, ptr %lsr.iv3.i.i, i64 %30
  %scevgep11.i.i = getelementptr i8, ptr %lsr.iv10.i.i, i64 8
  %scevgep13.i.i = getelementptr i8, ptr %lsr.iv12.i.i, i64 %32
  %lsr.iv.next22.i.i = sub i64 %lsr.iv21.i.i, %.141.1.i
  %exitcond496.not.i.i = icmp eq i64 %lsr.iv.next2.i.i9, 0
  br i1 %exitcond496.not.i.i, label %_ZN17bnserve_inference14adjoint_kernel8_passing10_turn_backB4v613B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedExx8UniTupleIdLi3EE5ArrayIdLi1E1C7mutable7alignedE.exit.i, label %B342.if.i.i

B106.if.i.i:                                      ; preds = %B240.i.i, %B106.if.lr.ph.i.i
  %lsr.iv23.i.i = phi i64 [ %.328.i.i, %B106.if.lr.ph.i.i ], [ %lsr.iv.next24.i.i, %B240.i.i ]
  %imaginary.3.0485.i.i = phi double [ 0.000000e+00, %B106.if.lr.ph.i.i ], [ %imaginary.4.1.i.i, %B240.i.i ]
  %real.3.0484.i.i = phi double [ 0.000000e+00, %B106.if.lr.ph.i.i ], [ %real.4.1.i.i, %B240.i.i ]
  %.237480482.i.i = phi i64 [ 0, %B106.if.lr.ph.i.i ], [ %.244.i.i, %B240.i.i ]
  %.244.i.i = add nuw nsw i64 %.237480482.i.i, 1
  %46 = shl i64 %.237480482.i.i, 3
  %scevgep36.i.i = getelementptr i8, ptr %24, i64 %46
  %.310.i.i = load i64, ptr %scevgep36.i.i, align 8, !noalias !12
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
  br i1 %.699491.not.i.i, label %_ZN17bnserve_inference14adjoint_kernel8_passing10_turn_backB4v613B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedExx8UniTupleIdLi3EE5ArrayIdLi1E1C7mutable7alignedE.exit.i, label %B342.if.lr.ph.i.i

B342.if.lr.ph.i.i:                                ; preds = %B338.endif.i.i
  %.786.i.i = shl nuw i64 %.1122805807.i, 1
  %47 = shl i64 %.1122805807.i, 4
  br label %B342.if.i.i

B342.if.i.i:                                      ; preds = %B342.if.lr.ph.i.i, %B480.i.i
  %lsr.iv21.i.i = phi i64 [ %.1122805807.i, %B342.if.lr.ph.i.i ], [ %lsr.iv.next22.i.i, %B480.i.i ]
  %lsr.iv12.i.i = phi ptr [ %18, %B342.if.lr.ph.i.i ], [ %scevgep13.i.i, %B480.i.i ]
  %lsr.iv10.i.i = phi ptr [ %24, %B342.if.lr.ph.i.i ], [ %scevgep11.i.i, %B480.i.i ]
  %lsr.iv3.i.i = phi ptr [ %25, %B342.if.lr.ph.i.i ], [ %scevgep.i.i10, %B480.i.i ]
  %lsr.iv1.i.i8 = phi i64 [ %.124.i, %B342.if.lr.ph.i.i ], [ %lsr.iv.next2.i.i9, %B480.i.i ]
  %lsr.iv.i.i = phi i64 [ %.786.i.i, %B342.if.lr.ph.i.i ], [ %lsr.iv.next.i.i, %B480.i.i ]
  %.770.i.i = load i64, ptr %lsr.iv10.i.i, align 8, !noalias !12
  %.772.i.i = icmp eq i64 %.770.i.i, %.673815835.i
  br i1 %.772.i.i, label %B452.i.i, label %B480.i.i

_ZN17bnserve_inference14adjoint_kernel8_passing10_turn_backB4v613B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedExx8UniTupleIdLi3EE5ArrayIdLi1E1C7mutable7alignedE.exit.i: ; preds = %B480.i.i, %B338.endif.i.i, %B242.i.i
  %48 = add nuw nsw i64 %.1122805807.i, 2
  %exitcond.not.i7 = icmp eq i64 %19, %48
  %49 = add nuw nsw i64 %.1122805807.i, 1
  br i1 %exitcond.not.i7, label %B1068.i, label %B766.if.i

B1390:                                            ; preds = %B1068.i, %B1356, %B1232.endif, %B1312
  %exitcond1154.not = icmp eq i64 %.611, %.518
  br i1 %exitcond1154.not, label %B1394, label %B544.if

B1394:                                            ; preds = %B1390, %entry
  store i64 0, ptr %retptr, align 8
  ret void

B544.if.lr.ph:                                    ; preds = %entry
  %.106 = getelementptr i8, ptr %arg.arguments.4, i64 128
  %.107 = load i64, ptr %.106, align 8
  %factor.op.mul915 = mul i64 %.107, %.187
  %.870.reass = shl i64 %factor.op.mul915, 4
  %.877.reass = shl i64 %factor.op.mul915, 4
  %.987 = and i64 %.187, 120
  %.990.not = icmp ne i64 %.987, 0
  %.991820 = lshr i64 %.187, 7
  %.992 = zext i1 %.990.not to i64
  %.993 = add nuw nsw i64 %.991820, %.992
  %.972.inv = icmp slt i64 %.187, 1
  %.1014906.not1155 = icmp eq i64 %.993, 0
  %.1014906.not = select i1 %.972.inv, i1 true, i1 %.1014906.not1155
  %scevgep.i = getelementptr i8, ptr %.362, i64 144
  %scevgep58.i = getelementptr i8, ptr %.229, i64 96
  %sunkaddr110 = getelementptr i8, ptr %arg.arguments.4, i64 176
  %.193.i53 = getelementptr i8, ptr %arg.arguments.4, i64 312
  %.227.i = getelementptr i8, ptr %arg.arguments.4, i64 320
  %sunkaddr117 = getelementptr i8, ptr %arg.arguments.4, i64 352
  %.244.i = getelementptr i8, ptr %arg.arguments.4, i64 304
  %.166.i = getelementptr i8, ptr %arg.arguments.4, i64 32
  %sunkaddr3.i = getelementptr i8, ptr %arg.arguments.4, i64 40
  %sunkaddr4.i = getelementptr i8, ptr %arg.arguments.4, i64 48
  %sunkaddr.i14 = getelementptr i8, ptr %arg.arguments.4, i64 272
  %.724.i = getelementptr i8, ptr %arg.arguments.4, i64 296
  %.547.i = getelementptr i8, ptr %arg.arguments.4, i64 280
  %.459.i = getelementptr i8, ptr %arg.arguments.4, i64 152
  %.361.i = getelementptr i8, ptr %arg.arguments.4, i64 168
  %.636.i = getelementptr i8, ptr %arg.arguments.4, i64 288
  %.178.i = getelementptr i8, ptr %arg.arguments.4, i64 168
  %.275.i90 = getelementptr i8, ptr %arg.arguments.4, i64 256
  %.365.i = getelementptr i8, ptr %arg.arguments.4, i64 264
  %.456.i = getelementptr i8, ptr %arg.arguments.4, i64 152
  %.542.i = getelementptr i8, ptr %arg.arguments.4, i64 32
  %sunkaddr.i97 = getelementptr i8, ptr %arg.arguments.4, i64 304
  %.1389.i = getelementptr inbounds nuw i8, ptr %.432, i64 10240
  %.1474.i = getelementptr inbounds nuw i8, ptr %.432, i64 11264
  %scevgep.i103 = getelementptr i8, ptr %.432, i64 17408
  %50 = icmp slt i64 %.47, 1
  %.133.i129 = getelementptr i8, ptr %arg.arguments.4, i64 184
  %.171.i = getelementptr i8, ptr %arg.arguments.4, i64 56
  %.500.i = getelementptr i8, ptr %arg.arguments.4, i64 304
  %.607.i.i = getelementptr i8, ptr %.432, i64 3072
  %.734.i.i = getelementptr i8, ptr %arg.arguments.4, i64 80
  %.817.i.i133 = getelementptr i8, ptr %arg.arguments.4, i64 192
  %.536.i.i = getelementptr inbounds nuw i8, ptr %.432, i64 2048
  %.935.i.i = getelementptr i8, ptr %arg.arguments.4, i64 200
  %.1448.i.i136 = getelementptr inbounds nuw i8, ptr %.432, i64 4096
  %.1612.i = getelementptr inbounds nuw i8, ptr %.432, i64 12288
  %.138.i.i = getelementptr i8, ptr %arg.arguments.4, i64 16
  %.376.i.i189 = getelementptr i8, ptr %arg.arguments.4, i64 24
  %.454.i.i190 = getelementptr i8, ptr %arg.arguments.4, i64 216
  %.500.i.i191 = getelementptr i8, ptr %arg.arguments.4, i64 144
  %.557.i.i = getelementptr i8, ptr %arg.arguments.4, i64 64
  %.999.i.i = getelementptr i8, ptr %arg.arguments.4, i64 208
  %.882.i.i = getelementptr i8, ptr %.432, i64 6144
  %.882.1.i.i = getelementptr i8, ptr %.432, i64 7168
  %.882.2.i.i = getelementptr i8, ptr %.432, i64 8192
  %.882.3.i.i = getelementptr i8, ptr %.432, i64 9216
  %.150.i.i.i = getelementptr inbounds nuw i8, ptr %.432, i64 13312
  %sunkaddr18.i57.i = getelementptr i8, ptr %arg.arguments.4, i64 336
  %sunkaddr22.i58.i = getelementptr i8, ptr %arg.arguments.4, i64 328
  %.265.i.i193 = getelementptr i8, ptr %arg.arguments.4, i64 344
  %scevgep266.i.i = getelementptr i8, ptr %.432, i64 21504
  %sunkaddr12.i77.i = getelementptr i8, ptr %arg.arguments.4, i64 72
  %.5616.i.i = getelementptr i8, ptr %.432, i64 12296
  %.5646.i.i = getelementptr i8, ptr %.432, i64 12304
  %.5675.i.i = getelementptr i8, ptr %.432, i64 12312
  %.5706.i.i = getelementptr i8, ptr %.432, i64 12320
  %.5735.i.i = getelementptr i8, ptr %.432, i64 12328
  %.5765.i.i = getelementptr i8, ptr %.432, i64 12336
  %.5794.i.i = getelementptr i8, ptr %.432, i64 12344
  %.169.i.i137 = getelementptr inbounds nuw i8, ptr %.432, i64 12288
  %.307.i.i = getelementptr i8, ptr %arg.arguments.4, i64 80
  %.592.i.i = getelementptr i8, ptr %.432, i64 4096
  %51 = getelementptr i8, ptr %arg.arguments.4, i64 392
  %52 = getelementptr i8, ptr %arg.arguments.4, i64 400
  %.592.1.i.i = getelementptr i8, ptr %.432, i64 5120
  %.509.i.i = getelementptr i8, ptr %arg.arguments.4, i64 376
  %.677.i.i = getelementptr inbounds nuw i8, ptr %.432, i64 10240
  %.760.i.i = getelementptr i8, ptr %.432, i64 11264
  %sunkaddr20.i.i = getelementptr i8, ptr %arg.arguments.4, i64 360
  %sunkaddr445.i.i = getelementptr inbounds nuw i8, ptr %.432, i64 12288
  %.2307.i.i = getelementptr i8, ptr %.432, i64 12296
  %.2337.i.i = getelementptr i8, ptr %.432, i64 12304
  %.2366.i.i = getelementptr i8, ptr %.432, i64 12312
  %.2397.i.i = getelementptr i8, ptr %.432, i64 12320
  %.2426.i.i = getelementptr i8, ptr %.432, i64 12328
  %.2456.i.i = getelementptr i8, ptr %.432, i64 12336
  %.2485.i.i = getelementptr i8, ptr %.432, i64 12344
  %.780.i = getelementptr i8, ptr %arg.arguments.4, i64 384
  %.813.i = getelementptr i8, ptr %arg.arguments.4, i64 32
  %scevgep.i2 = getelementptr i8, ptr %.432, i64 41024
  %sunkaddr97 = getelementptr i8, ptr %arg.arguments.4, i64 32
  %sunkaddr = getelementptr i8, ptr %arg.arguments.4, i64 368
  %sunkaddr118 = getelementptr i8, ptr %arg.arguments.4, i64 384
  %.389.i = getelementptr i8, ptr %arg.arguments.4, i64 296
  %.304.i = getelementptr i8, ptr %arg.arguments.4, i64 152
  %.208.i = getelementptr i8, ptr %arg.arguments.4, i64 168
  %sunkaddr27.i = getelementptr i8, ptr %arg.arguments.4, i64 280
  %53 = or disjoint i64 %.877.reass, 24
  %54 = or disjoint i64 %.877.reass, 8
  br label %B544.if

B544.if:                                          ; preds = %B544.if.lr.ph, %B1390
  %.604928988 = phi i64 [ 0, %B544.if.lr.ph ], [ %.611, %B1390 ]
  %.611 = add nuw nsw i64 %.604928988, 1
  %.669 = load i64, ptr %sunkaddr110, align 8
  %.672 = mul nuw nsw i64 %.604928988, 56
  %.673 = add nsw i64 %.669, %.672
  %.674 = inttoptr i64 %.673 to ptr
  %.749 = getelementptr i8, ptr %.674, i64 24
  %.750 = load double, ptr %.749, align 8
  %.290.i = load i64, ptr %arg.arguments.4, align 8, !noalias !15
  %.370466.not.i = icmp slt i64 %.290.i, 1
  br i1 %.370466.not.i, label %_ZN17bnserve_inference14adjoint_kernel7_source6_placeB3v14B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit, label %B268.if.preheader.i

B268.if.preheader.i:                              ; preds = %B544.if
  %.245.i = load i64, ptr %.244.i, align 8, !noalias !15
  %.167.i = load i64, ptr %.166.i, align 8, !noalias !15
  %55 = inttoptr i64 %.167.i to ptr
  %.145.i.i = getelementptr i8, ptr %55, i64 8
  %.345.i.i = getelementptr i8, ptr %.674, i64 8
  %.542.i.i = icmp eq i64 %.245.i, 1
  %.2102.i.i = getelementptr i8, ptr %.674, i64 16
  br label %B268.if.i

B268.if.i:                                        ; preds = %_ZN17bnserve_inference14adjoint_kernel9_response13fill_geometryB3v41B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i, %B268.if.preheader.i
  %lsr.iv138.i = phi i64 [ %lsr.iv.next139.i, %_ZN17bnserve_inference14adjoint_kernel9_response13fill_geometryB3v41B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i ], [ %.290.i, %B268.if.preheader.i ]
  %lsr.iv136.i15 = phi i64 [ %lsr.iv.next137.i, %_ZN17bnserve_inference14adjoint_kernel9_response13fill_geometryB3v41B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i ], [ 0, %B268.if.preheader.i ]
  %lsr.iv134.i = phi i64 [ %lsr.iv.next135.i, %_ZN17bnserve_inference14adjoint_kernel9_response13fill_geometryB3v41B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i ], [ 0, %B268.if.preheader.i ]
  %lsr.iv133.i = phi i64 [ %lsr.iv.next.i47, %_ZN17bnserve_inference14adjoint_kernel9_response13fill_geometryB3v41B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i ], [ 0, %B268.if.preheader.i ]
  %lsr.iv131.i = phi ptr [ %scevgep132.i, %_ZN17bnserve_inference14adjoint_kernel9_response13fill_geometryB3v41B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i ], [ %.229, %B268.if.preheader.i ]
  %lsr.iv.i16 = phi ptr [ %scevgep.i46, %_ZN17bnserve_inference14adjoint_kernel9_response13fill_geometryB3v41B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i ], [ %.362, %B268.if.preheader.i ]
  %.438.i = load i64, ptr %sunkaddr3.i, align 8, !noalias !15
  %56 = add i64 %.438.i, %lsr.iv136.i15
  %.441.i = inttoptr i64 %56 to ptr
  %.519.i = load i64, ptr %sunkaddr4.i, align 8, !noalias !15
  %57 = add i64 %.519.i, %lsr.iv134.i
  %.522.i = inttoptr i64 %57 to ptr
  %.600.i = load i64, ptr %sunkaddr.i14, align 8, !noalias !15
  %58 = add i64 %.600.i, %lsr.iv133.i
  %.603.i = inttoptr i64 %58 to ptr
  %.116.i.i = load double, ptr %55, align 8, !noalias !18
  %.146.i.i = load double, ptr %.145.i.i, align 8, !noalias !18
  %.176.i.i = load double, ptr %.749, align 8, !noalias !18
  %.177.i.i = fmul contract double %.146.i.i, %.176.i.i
  %.178.i.i = fadd contract double %.116.i.i, %.177.i.i
  %.208.i.i = load double, ptr %.674, align 8, !noalias !18
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
  %.267.i.i = xor i64 %.266.i.i, %.265.i.i
  %.268.i.i = and i64 %.264.i.i, 1
  %59 = icmp eq i64 %.268.i.i, 0
  %.270.i.i = select i1 %59, i64 0, i64 %.267.i.i
  %.271.i.i = shl i64 %.264.i.i, 62
  %.272.i.i = and i64 %.271.i.i, -9223372036854775808
  %.274.i.i17 = add i64 %.271.i.i, 4611686018427387904
  %.275.i.i = and i64 %.274.i.i17, -9223372036854775808
  %60 = xor i64 %.272.i.i, %.265.i.i
  %.277.i.i18 = xor i64 %60, %.270.i.i
  %.278.i.i19 = bitcast i64 %.277.i.i18 to double
  %61 = xor i64 %.275.i.i, %.266.i.i
  %.280.i.i = xor i64 %61, %.270.i.i
  %.281.i.i = bitcast i64 %.280.i.i to double
  %.346.i.i = load double, ptr %.345.i.i, align 8, !noalias !18
  %.347.i.i = tail call contract double @llvm.fma.f64(double %.346.i.i, double 0x3FE45F306DC9C883, double 0x4338000000000000)
  %.348.i.i = fadd contract double %.347.i.i, 0xC338000000000000
  %.363.i.i = tail call contract double @llvm.fma.f64(double %.348.i.i, double 0xBFF921FB54442D18, double %.346.i.i)
  %.378.i.i = tail call contract double @llvm.fma.f64(double %.348.i.i, double 0xBC91A62633145C07, double %.363.i.i)
  %.379.i.i = fmul contract double %.378.i.i, %.378.i.i
  %.380.i.i = tail call contract double @llvm.fma.f64(double %.379.i.i, double 0xBD6AE7F3E733B81F, double 0x3DE6124613A86D09)
  %.381.i.i = tail call contract double @llvm.fma.f64(double %.379.i.i, double %.380.i.i, double 0xBE5AE64567F544E4)
  %.382.i.i = tail call contract double @llvm.fma.f64(double %.379.i.i, double %.381.i.i, double 0x3EC71DE3A556C734)
  %.383.i.i20 = tail call contract double @llvm.fma.f64(double %.379.i.i, double %.382.i.i, double 0xBF2A01A01A01A01A)
  %.384.i.i21 = tail call contract double @llvm.fma.f64(double %.379.i.i, double %.383.i.i20, double 0x3F81111111111111)
  %.385.i.i = tail call contract double @llvm.fma.f64(double %.379.i.i, double %.384.i.i21, double 0xBFC5555555555555)
  %.386.i.i = fmul contract double %.378.i.i, %.379.i.i
  %.387.i.i = tail call contract double @llvm.fma.f64(double %.386.i.i, double %.385.i.i, double %.378.i.i)
  %.388.i.i = tail call contract double @llvm.fma.f64(double %.379.i.i, double 0x3D2AE7F3E733B81F, double 0xBDA93974A8C07C9D)
  %.389.i.i = tail call contract double @llvm.fma.f64(double %.379.i.i, double %.388.i.i, double 0x3E21EED8EFF8D898)
  %.390.i.i = tail call contract double @llvm.fma.f64(double %.379.i.i, double %.389.i.i, double 0xBE927E4FB7789F5C)
  %.391.i.i22 = tail call contract double @llvm.fma.f64(double %.379.i.i, double %.390.i.i, double 0x3EFA01A01A01A01A)
  %.392.i.i = tail call contract double @llvm.fma.f64(double %.379.i.i, double %.391.i.i22, double 0xBF56C16C16C16C17)
  %.393.i.i = tail call contract double @llvm.fma.f64(double %.379.i.i, double %.392.i.i, double 0x3FA5555555555555)
  %.394.i.i = tail call contract double @llvm.fma.f64(double %.379.i.i, double %.393.i.i, double -5.000000e-01)
  %.395.i.i = tail call contract double @llvm.fma.f64(double %.379.i.i, double %.394.i.i, double 1.000000e+00)
  %.396.i.i = bitcast double %.347.i.i to i64
  %.397.i.i = bitcast double %.387.i.i to i64
  %.398.i.i = bitcast double %.395.i.i to i64
  %.399.i.i = xor i64 %.398.i.i, %.397.i.i
  %.400.i.i = and i64 %.396.i.i, 1
  %62 = icmp eq i64 %.400.i.i, 0
  %.402.i.i = select i1 %62, i64 0, i64 %.399.i.i
  %.403.i.i = shl i64 %.396.i.i, 62
  %.404.i.i = and i64 %.403.i.i, -9223372036854775808
  %.406.i.i23 = add i64 %.403.i.i, 4611686018427387904
  %.407.i.i = and i64 %.406.i.i23, -9223372036854775808
  %63 = xor i64 %.404.i.i, %.397.i.i
  %.409.i.i = xor i64 %63, %.402.i.i
  %.410.i.i = bitcast i64 %.409.i.i to double
  %64 = xor i64 %.407.i.i, %.398.i.i
  %.412.i.i = xor i64 %64, %.402.i.i
  %.413.i.i = bitcast i64 %.412.i.i to double
  %.468.i.i24 = load double, ptr %.522.i, align 8, !noalias !18
  %.496.i.i = getelementptr i8, ptr %.522.i, i64 8
  %.497.i.i = load double, ptr %.496.i.i, align 8, !noalias !18
  %.525.i.i = getelementptr i8, ptr %.522.i, i64 16
  %.526.i.i25 = load double, ptr %.525.i.i, align 8, !noalias !18
  br i1 %.542.i.i, label %B276.i.i, label %_ZN17bnserve_inference13moving_kernel9_response12coefficientsB3v22B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i

B276.i.i:                                         ; preds = %B268.if.i
  %.547.i.i = fmul contract double %.468.i.i24, %.281.i.i
  %.553.i.i = fmul contract double %.497.i.i, %.278.i.i19
  %.556.i.i = fsub contract double %.547.i.i, %.553.i.i
  %.558.i.i = fmul contract double %.556.i.i, %.413.i.i
  %.562.i.i = fmul contract double %.526.i.i25, %.410.i.i
  %.563.i.i = fadd contract double %.562.i.i, %.558.i.i
  %.568.i.i50 = fdiv contract double %.563.i.i, 0x41B1DE784A000000
  %.605.i.i = fmul contract double %.146.i.i, %.568.i.i50
  %65 = fsub contract double %.209.i.i, %.605.i.i
  %.610.i.i = tail call contract double @llvm.fma.f64(double %65, double 0x3FE45F306DC9C883, double 0x4338000000000000)
  %.611.i.i = fadd contract double %.610.i.i, 0xC338000000000000
  %.626.i.i = tail call contract double @llvm.fma.f64(double %.611.i.i, double 0xBFF921FB54442D18, double %65)
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
  %.654.i.i = tail call contract double @llvm.fma.f64(double %.642.i.i, double %.653.i.i, double 0x3EFA01A01A01A01A)
  %.655.i.i = tail call contract double @llvm.fma.f64(double %.642.i.i, double %.654.i.i, double 0xBF56C16C16C16C17)
  %.656.i.i = tail call contract double @llvm.fma.f64(double %.642.i.i, double %.655.i.i, double 0x3FA5555555555555)
  %.657.i.i = tail call contract double @llvm.fma.f64(double %.642.i.i, double %.656.i.i, double -5.000000e-01)
  %.658.i.i = tail call contract double @llvm.fma.f64(double %.642.i.i, double %.657.i.i, double 1.000000e+00)
  %.659.i.i = bitcast double %.610.i.i to i64
  %.660.i.i = bitcast double %.650.i.i to i64
  %.661.i.i = bitcast double %.658.i.i to i64
  %.662.i.i = xor i64 %.661.i.i, %.660.i.i
  %.663.i.i = and i64 %.659.i.i, 1
  %66 = icmp eq i64 %.663.i.i, 0
  %.665.i.i = select i1 %66, i64 0, i64 %.662.i.i
  %.666.i.i = shl i64 %.659.i.i, 62
  %.667.i.i = and i64 %.666.i.i, -9223372036854775808
  %.669.i.i = add i64 %.666.i.i, 4611686018427387904
  %.670.i.i = and i64 %.669.i.i, -9223372036854775808
  %67 = xor i64 %.667.i.i, %.660.i.i
  %.672.i.i = xor i64 %67, %.665.i.i
  %.673.i.i = bitcast i64 %.672.i.i to double
  %68 = xor i64 %.670.i.i, %.661.i.i
  %.675.i.i = xor i64 %68, %.665.i.i
  %.676.i.i = bitcast i64 %.675.i.i to double
  br label %_ZN17bnserve_inference13moving_kernel9_response12coefficientsB3v22B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i

_ZN17bnserve_inference13moving_kernel9_response12coefficientsB3v22B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i: ; preds = %B276.i.i, %B268.if.i
  %sin_h.2.0.i.i = phi double [ %.673.i.i, %B276.i.i ], [ %.278.i.i19, %B268.if.i ]
  %cos_h.2.0.i.i = phi double [ %.676.i.i, %B276.i.i ], [ %.281.i.i, %B268.if.i ]
  %.775.i.i = fmul contract double %.468.i.i24, %cos_h.2.0.i.i
  %69 = fmul contract double %.497.i.i, %sin_h.2.0.i.i
  %.779.i.i = fsub contract double %.775.i.i, %69
  %.788.i.i = fmul contract double %.526.i.i25, 0.000000e+00
  %.789.i.i = fadd contract double %.788.i.i, %.779.i.i
  %.791.i.i = fmul contract double %.789.i.i, %.413.i.i
  %.795.i.i = fmul contract double %.526.i.i25, %.410.i.i
  %.796.i.i = fadd contract double %.795.i.i, %.791.i.i
  %.801.i.i26 = fdiv contract double %.796.i.i, 0xC1B1DE784A000000
  store double %.801.i.i26, ptr %lsr.iv131.i, align 8, !noalias !18
  %.863.i.i = fdiv contract double %.791.i.i, 0x41B1DE784A000000
  %.892.i.i = getelementptr i8, ptr %lsr.iv131.i, i64 88
  store double %.863.i.i, ptr %.892.i.i, align 8, !noalias !18
  %.910.i.i = fmul contract double %.468.i.i24, %sin_h.2.0.i.i
  %.913.i.i = fmul contract double %.497.i.i, %cos_h.2.0.i.i
  %.914.i.i = fadd contract double %.910.i.i, %.913.i.i
  %.924.i.i27 = fadd contract double %.788.i.i, %.914.i.i
  %.926.i.i28 = fmul contract double %.924.i.i27, %.413.i.i
  %.930.i.i = fdiv contract double %.926.i.i28, 0x41B1DE784A000000
  %.959.i.i29 = getelementptr i8, ptr %lsr.iv131.i, i64 96
  store double %.930.i.i, ptr %.959.i.i29, align 8, !noalias !18
  %.998.i.i = load double, ptr %.441.i, align 8, !noalias !18
  %.1000.i.i = fmul contract double %cos_h.2.0.i.i, %.998.i.i
  %.1028.i.i = getelementptr i8, ptr %.441.i, i64 8
  %.1029.i.i = load double, ptr %.1028.i.i, align 8, !noalias !18
  %70 = fmul contract double %sin_h.2.0.i.i, %.1029.i.i
  %.1032.i.i = fsub contract double %.1000.i.i, %70
  %.1060.i.i = getelementptr i8, ptr %.441.i, i64 16
  %.1061.i.i = load double, ptr %.1060.i.i, align 8, !noalias !18
  %.1063.i.i = fmul contract double %.1061.i.i, 0.000000e+00
  %.1064.i.i = fadd contract double %.1032.i.i, %.1063.i.i
  %.1092.i.i = getelementptr i8, ptr %.441.i, i64 24
  %.1093.i.i = load double, ptr %.1092.i.i, align 8, !noalias !18
  %.1095.i.i = fmul contract double %cos_h.2.0.i.i, %.1093.i.i
  %.1123.i.i = getelementptr i8, ptr %.441.i, i64 32
  %.1124.i.i = load double, ptr %.1123.i.i, align 8, !noalias !18
  %71 = fmul contract double %sin_h.2.0.i.i, %.1124.i.i
  %.1127.i.i = fsub contract double %.1095.i.i, %71
  %.1155.i.i = getelementptr i8, ptr %.441.i, i64 40
  %.1156.i.i = load double, ptr %.1155.i.i, align 8, !noalias !18
  %.1158.i.i = fmul contract double %.1156.i.i, 0.000000e+00
  %.1159.i.i = fadd contract double %.1127.i.i, %.1158.i.i
  %.1187.i.i = getelementptr i8, ptr %.441.i, i64 48
  %.1188.i.i = load double, ptr %.1187.i.i, align 8, !noalias !18
  %.1190.i.i = fmul contract double %cos_h.2.0.i.i, %.1188.i.i
  %.1218.i.i = getelementptr i8, ptr %.441.i, i64 56
  %.1219.i.i = load double, ptr %.1218.i.i, align 8, !noalias !18
  %72 = fmul contract double %sin_h.2.0.i.i, %.1219.i.i
  %.1222.i.i = fsub contract double %.1190.i.i, %72
  %.1250.i.i = getelementptr i8, ptr %.441.i, i64 64
  %.1251.i.i = load double, ptr %.1250.i.i, align 8, !noalias !18
  %.1259.i.i30 = fmul contract double %.1251.i.i, 0.000000e+00
  %.1260.i.i = fadd contract double %.1222.i.i, %.1259.i.i30
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
  %.1578.i.i = fadd contract double %.1540.i.i, %.1259.i.i30
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
  %73 = fmul contract double %sin_h.2.0.i.i, %.1159.i.i
  %.1951.i.i = fsub contract double %.1947.i.i, %73
  %.1960.i.i = fmul contract double %.1260.i.i, 0.000000e+00
  %.1961.i.i = fadd contract double %.1951.i.i, %.1960.i.i
  %.1972.i.i = fmul contract double %cos_h.2.0.i.i, %.1382.i.i
  %74 = fmul contract double %sin_h.2.0.i.i, %.1477.i.i
  %.1976.i.i = fsub contract double %.1972.i.i, %74
  %.1985.i.i = fmul contract double %.1578.i.i, 0.000000e+00
  %.1986.i.i = fadd contract double %.1976.i.i, %.1985.i.i
  %.2000.i.i = fmul contract double %sin_h.2.0.i.i, %.1382.i.i
  %.2003.i.i = fmul contract double %cos_h.2.0.i.i, %.1477.i.i
  %.2004.i.i = fadd contract double %.2000.i.i, %.2003.i.i
  %.2014.i.i = fadd contract double %.2004.i.i, %.1985.i.i
  %.2025.i.i = fmul contract double %cos_h.2.0.i.i, %.1707.i.i
  %75 = fmul contract double %sin_h.2.0.i.i, %.1802.i.i
  %.2029.i.i = fsub contract double %.2025.i.i, %75
  %.2038.i.i = fmul contract double %.1903.i.i, 0.000000e+00
  %.2039.i.i = fadd contract double %.2029.i.i, %.2038.i.i
  %.2050.i.i = fmul contract double %sin_h.2.0.i.i, %.1707.i.i
  %.2053.i.i = fmul contract double %cos_h.2.0.i.i, %.1802.i.i
  %.2054.i.i = fadd contract double %.2050.i.i, %.2053.i.i
  %.2064.i.i = fadd contract double %.2054.i.i, %.2038.i.i
  %.2069.i.i = fadd contract double %.1961.i.i, %.2014.i.i
  %.2070.i.i = fmul contract double %.2069.i.i, 5.000000e-01
  %.2071.i.i = fsub contract double %.2014.i.i, %.1961.i.i
  %.2072.i.i = fmul contract double %.2071.i.i, 5.000000e-01
  %.2103.i.i = load double, ptr %.2102.i.i, align 8, !noalias !18
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
  %.2148.i.i = tail call contract double @llvm.fma.f64(double %.2142.i.i, double %.2147.i.i, double 0xBFC5555555555555)
  %.2149.i.i = fmul contract double %.2141.i.i, %.2142.i.i
  %.2150.i.i = tail call contract double @llvm.fma.f64(double %.2149.i.i, double %.2148.i.i, double %.2141.i.i)
  %.2151.i.i = tail call contract double @llvm.fma.f64(double %.2142.i.i, double 0x3D2AE7F3E733B81F, double 0xBDA93974A8C07C9D)
  %.2152.i.i = tail call contract double @llvm.fma.f64(double %.2142.i.i, double %.2151.i.i, double 0x3E21EED8EFF8D898)
  %.2153.i.i = tail call contract double @llvm.fma.f64(double %.2142.i.i, double %.2152.i.i, double 0xBE927E4FB7789F5C)
  %.2154.i.i = tail call contract double @llvm.fma.f64(double %.2142.i.i, double %.2153.i.i, double 0x3EFA01A01A01A01A)
  %.2155.i.i = tail call contract double @llvm.fma.f64(double %.2142.i.i, double %.2154.i.i, double 0xBF56C16C16C16C17)
  %.2156.i.i = tail call contract double @llvm.fma.f64(double %.2142.i.i, double %.2155.i.i, double 0x3FA5555555555555)
  %.2157.i.i = tail call contract double @llvm.fma.f64(double %.2142.i.i, double %.2156.i.i, double -5.000000e-01)
  %.2158.i.i = tail call contract double @llvm.fma.f64(double %.2142.i.i, double %.2157.i.i, double 1.000000e+00)
  %.2159.i.i = bitcast double %.2110.i.i to i64
  %.2160.i.i = bitcast double %.2150.i.i to i64
  %.2161.i.i = bitcast double %.2158.i.i to i64
  %.2162.i.i = xor i64 %.2161.i.i, %.2160.i.i
  %.2163.i.i = and i64 %.2159.i.i, 1
  %76 = icmp eq i64 %.2163.i.i, 0
  %.2165.i.i = select i1 %76, i64 0, i64 %.2162.i.i
  %.2166.i.i = shl i64 %.2159.i.i, 62
  %.2167.i.i = and i64 %.2166.i.i, -9223372036854775808
  %.2169.i.i = add i64 %.2166.i.i, 4611686018427387904
  %.2170.i.i = and i64 %.2169.i.i, -9223372036854775808
  %77 = xor i64 %.2167.i.i, %.2160.i.i
  %.2172.i.i = xor i64 %77, %.2165.i.i
  %.2173.i.i = bitcast i64 %.2172.i.i to double
  %78 = xor i64 %.2170.i.i, %.2161.i.i
  %.2175.i.i = xor i64 %78, %.2165.i.i
  %.2176.i.i = bitcast i64 %.2175.i.i to double
  %.2204.i.i = fmul contract double %.2070.i.i, %.413.i.i
  %.2206.i.i = fmul contract double %.2204.i.i, %.413.i.i
  %.2209.i.i = fmul contract double %.413.i.i, %.413.i.i
  %.2210.i.i = fmul contract double %.2209.i.i, %.1903.i.i
  %.2211.i.i = fsub contract double %.2206.i.i, %.2210.i.i
  %.2213.i.i = fmul contract double %.410.i.i, 2.000000e+00
  %.2215.i.i = fmul contract double %.2213.i.i, %.413.i.i
  %.2216.i.i = fmul contract double %.2215.i.i, %.2039.i.i
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
  %79 = getelementptr i8, ptr %lsr.iv131.i, i64 8
  store double %.2439.i.i, ptr %79, align 8, !noalias !18
  %.2490.i.i31 = fmul contract double %.2176.i.i, 0.000000e+00
  %.2510.i.i = fmul contract double %.2211.i.i, %.2173.i.i
  %.2511.i.i = fsub contract double %.2490.i.i31, %.2510.i.i
  %80 = getelementptr i8, ptr %lsr.iv131.i, i64 48
  store double %.2511.i.i, ptr %80, align 8, !noalias !18
  %.2418.1.i.i = fmul contract double %.2216.i.i, %.2176.i.i
  %.2438.1.i.i = fmul contract double %.2252.i.i, %.2173.i.i
  %.2439.1.i.i = fadd contract double %.2418.1.i.i, %.2438.1.i.i
  %81 = getelementptr i8, ptr %lsr.iv131.i, i64 16
  store double %.2439.1.i.i, ptr %81, align 8, !noalias !18
  %.2490.1.i.i = fmul contract double %.2252.i.i, %.2176.i.i
  %.2510.1.i.i = fmul contract double %.2216.i.i, %.2173.i.i
  %.2511.1.i.i = fsub contract double %.2490.1.i.i, %.2510.1.i.i
  %82 = getelementptr i8, ptr %lsr.iv131.i, i64 56
  store double %.2511.1.i.i, ptr %82, align 8, !noalias !18
  %.2418.2.i.i = fmul contract double %.2221.i.i, %.2176.i.i
  %.2438.2.i.i = fmul contract double %.2255.i.i, %.2173.i.i
  %.2439.2.i.i = fadd contract double %.2418.2.i.i, %.2438.2.i.i
  %83 = getelementptr i8, ptr %lsr.iv131.i, i64 24
  store double %.2439.2.i.i, ptr %83, align 8, !noalias !18
  %.2490.2.i.i = fmul contract double %.2255.i.i, %.2176.i.i
  %.2510.2.i.i = fmul contract double %.2221.i.i, %.2173.i.i
  %.2511.2.i.i = fsub contract double %.2490.2.i.i, %.2510.2.i.i
  %84 = getelementptr i8, ptr %lsr.iv131.i, i64 64
  store double %.2511.2.i.i, ptr %84, align 8, !noalias !18
  %.2418.3.i.i = fmul contract double %.2226.i.i, %.2176.i.i
  %.2438.3.i.i = fmul contract double %.2258.i.i, %.2173.i.i
  %.2439.3.i.i = fadd contract double %.2418.3.i.i, %.2438.3.i.i
  %85 = getelementptr i8, ptr %lsr.iv131.i, i64 32
  store double %.2439.3.i.i, ptr %85, align 8, !noalias !18
  %.2490.3.i.i = fmul contract double %.2258.i.i, %.2176.i.i
  %.2510.3.i.i = fmul contract double %.2226.i.i, %.2173.i.i
  %.2511.3.i.i = fsub contract double %.2490.3.i.i, %.2510.3.i.i
  %86 = getelementptr i8, ptr %lsr.iv131.i, i64 72
  store double %.2511.3.i.i, ptr %86, align 8, !noalias !18
  %.2418.4.i.i = fmul contract double %.2231.i.i, %.2176.i.i
  %.2438.4.i.i = fmul contract double %.2261.i.i, %.2173.i.i
  %.2439.4.i.i = fadd contract double %.2418.4.i.i, %.2438.4.i.i
  %87 = getelementptr i8, ptr %lsr.iv131.i, i64 40
  store double %.2439.4.i.i, ptr %87, align 8, !noalias !18
  %.2490.4.i.i = fmul contract double %.2261.i.i, %.2176.i.i
  %.2510.4.i.i = fmul contract double %.2231.i.i, %.2173.i.i
  %.2511.4.i.i = fsub contract double %.2490.4.i.i, %.2510.4.i.i
  %88 = getelementptr i8, ptr %lsr.iv131.i, i64 80
  store double %.2511.4.i.i, ptr %88, align 8, !noalias !18
  %.2591.i.i = getelementptr i8, ptr %lsr.iv131.i, i64 104
  store i64 %.2175.i.i, ptr %.2591.i.i, align 8, !noalias !18
  %.2624.i.i = getelementptr i8, ptr %lsr.iv131.i, i64 112
  store i64 %.2172.i.i, ptr %.2624.i.i, align 8, !noalias !18
  %.2657.i.i = getelementptr i8, ptr %lsr.iv131.i, i64 120
  store i64 %.412.i.i, ptr %.2657.i.i, align 8, !noalias !18
  %.2690.i.i = getelementptr i8, ptr %lsr.iv131.i, i64 128
  store i64 %.409.i.i, ptr %.2690.i.i, align 8, !noalias !18
  %.2841.i.i = load double, ptr %.603.i, align 8, !noalias !18
  %89 = getelementptr i8, ptr %.603.i, i64 8
  %.2873.i.i32 = load double, ptr %89, align 8, !noalias !18
  %90 = getelementptr i8, ptr %.603.i, i64 16
  %.2905.i.i = load double, ptr %90, align 8, !noalias !18
  %.2929.i.i = fmul contract double %.2841.i.i, %.2841.i.i
  %.2932.i.i = fmul contract double %.2873.i.i32, %.2873.i.i32
  %.2933.i.i = fadd contract double %.2929.i.i, %.2932.i.i
  %.2942.i.i = fmul contract double %.2905.i.i, %.2905.i.i
  %.2943.i.i = fadd contract double %.2933.i.i, %.2942.i.i
  %.2951.i.i = tail call contract double @sqrt(double %.2943.i.i)
  %.2951.fr.i.i = freeze double %.2951.i.i
  %.2975.i.i = fcmp contract ogt double %.2951.fr.i.i, 0.000000e+00
  %.2981.i.i = fdiv contract double 1.000000e+00, %.2951.fr.i.i
  %"$phi1856.1.2.1.i.i" = select i1 %.2975.i.i, double %.2981.i.i, double 0.000000e+00
  %.3003.i.i = fmul contract double %cos_h.2.0.i.i, %.2841.i.i
  %91 = fmul contract double %sin_h.2.0.i.i, %.2873.i.i32
  %.3007.i.i33 = fsub contract double %.3003.i.i, %91
  %.3016.i.i = fmul contract double %.2905.i.i, 0.000000e+00
  %.3017.i.i = fadd contract double %.3007.i.i33, %.3016.i.i
  %.3018.i.i = fmul contract double %.3017.i.i, %"$phi1856.1.2.1.i.i"
  %.3030.i.i = fmul contract double %sin_h.2.0.i.i, %.2841.i.i
  %.3033.i.i = fmul contract double %cos_h.2.0.i.i, %.2873.i.i32
  %.3034.i.i = fadd contract double %.3030.i.i, %.3033.i.i
  %.3044.i.i = fadd contract double %.3034.i.i, %.3016.i.i
  %.3045.i.i = fmul contract double %.3044.i.i, %"$phi1856.1.2.1.i.i"
  %.3075.i.i = getelementptr i8, ptr %lsr.iv131.i, i64 136
  store double %.3018.i.i, ptr %.3075.i.i, align 8, !noalias !18
  %.3107.i.i = getelementptr i8, ptr %lsr.iv131.i, i64 144
  store double %.3045.i.i, ptr %.3107.i.i, align 8, !noalias !18
  %.3116.i.i = fmul contract double %.2905.i.i, %"$phi1856.1.2.1.i.i"
  %.3121.i.i = fdiv contract double %.2951.fr.i.i, 0x41B1DE784A000000
  %.3154.i.i = getelementptr i8, ptr %lsr.iv131.i, i64 152
  store double %.3116.i.i, ptr %.3154.i.i, align 8, !noalias !18
  %.3188.i.i = getelementptr i8, ptr %lsr.iv131.i, i64 160
  store double %.3121.i.i, ptr %.3188.i.i, align 8, !noalias !18
  %92 = getelementptr i8, ptr %.603.i, i64 24
  %.2841.1.i.i = load double, ptr %92, align 8, !noalias !18
  %93 = getelementptr i8, ptr %.603.i, i64 32
  %.2873.1.i.i = load double, ptr %93, align 8, !noalias !18
  %94 = getelementptr i8, ptr %.603.i, i64 40
  %.2905.1.i.i = load double, ptr %94, align 8, !noalias !18
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
  %95 = fmul contract double %sin_h.2.0.i.i, %.2873.1.i.i
  %.3007.1.i.i = fsub contract double %.3003.1.i.i, %95
  %.3016.1.i.i = fmul contract double %.2905.1.i.i, 0.000000e+00
  %.3017.1.i.i = fadd contract double %.3007.1.i.i, %.3016.1.i.i
  %.3018.1.i.i = fmul contract double %.3017.1.i.i, %"$phi1856.1.2.1.1.i.i"
  %.3030.1.i.i = fmul contract double %sin_h.2.0.i.i, %.2841.1.i.i
  %.3033.1.i.i = fmul contract double %cos_h.2.0.i.i, %.2873.1.i.i
  %.3034.1.i.i = fadd contract double %.3030.1.i.i, %.3033.1.i.i
  %.3044.1.i.i = fadd contract double %.3034.1.i.i, %.3016.1.i.i
  %.3045.1.i.i = fmul contract double %.3044.1.i.i, %"$phi1856.1.2.1.1.i.i"
  %.3075.1.i.i = getelementptr i8, ptr %lsr.iv131.i, i64 168
  store double %.3018.1.i.i, ptr %.3075.1.i.i, align 8, !noalias !18
  %.3107.1.i.i = getelementptr i8, ptr %lsr.iv131.i, i64 176
  store double %.3045.1.i.i, ptr %.3107.1.i.i, align 8, !noalias !18
  %.3116.1.i.i = fmul contract double %.2905.1.i.i, %"$phi1856.1.2.1.1.i.i"
  %.3121.1.i.i = fdiv contract double %.2951.1.fr.i.i, 0x41B1DE784A000000
  %.3154.1.i.i = getelementptr i8, ptr %lsr.iv131.i, i64 184
  store double %.3116.1.i.i, ptr %.3154.1.i.i, align 8, !noalias !18
  %.3188.1.i.i = getelementptr i8, ptr %lsr.iv131.i, i64 192
  store double %.3121.1.i.i, ptr %.3188.1.i.i, align 8, !noalias !18
  %.102.i.i = load double, ptr %55, align 8, !noalias !21
  %.132.i.i = load double, ptr %.145.i.i, align 8, !noalias !21
  %.162.i.i = load double, ptr %.749, align 8, !noalias !21
  %.163.i.i = fmul contract double %.132.i.i, %.162.i.i
  %.164.i.i = fadd contract double %.102.i.i, %.163.i.i
  %.194.i.i = load double, ptr %.674, align 8, !noalias !21
  %.195.i.i = fsub contract double %.164.i.i, %.194.i.i
  %.201.i.i = tail call contract double @llvm.fma.f64(double %.195.i.i, double 0x3FE45F306DC9C883, double 0x4338000000000000)
  %.202.i.i = fadd contract double %.201.i.i, 0xC338000000000000
  %.217.i.i = tail call contract double @llvm.fma.f64(double %.202.i.i, double 0xBFF921FB54442D18, double %.195.i.i)
  %.232.i.i = tail call contract double @llvm.fma.f64(double %.202.i.i, double 0xBC91A62633145C07, double %.217.i.i)
  %.233.i.i = fmul contract double %.232.i.i, %.232.i.i
  %.234.i.i = tail call contract double @llvm.fma.f64(double %.233.i.i, double 0xBD6AE7F3E733B81F, double 0x3DE6124613A86D09)
  %.235.i.i = tail call contract double @llvm.fma.f64(double %.233.i.i, double %.234.i.i, double 0xBE5AE64567F544E4)
  %.236.i.i = tail call contract double @llvm.fma.f64(double %.233.i.i, double %.235.i.i, double 0x3EC71DE3A556C734)
  %.237.i.i34 = tail call contract double @llvm.fma.f64(double %.233.i.i, double %.236.i.i, double 0xBF2A01A01A01A01A)
  %.238.i.i = tail call contract double @llvm.fma.f64(double %.233.i.i, double %.237.i.i34, double 0x3F81111111111111)
  %.239.i.i = tail call contract double @llvm.fma.f64(double %.233.i.i, double %.238.i.i, double 0xBFC5555555555555)
  %.240.i.i = fmul contract double %.232.i.i, %.233.i.i
  %.241.i.i = tail call contract double @llvm.fma.f64(double %.240.i.i, double %.239.i.i, double %.232.i.i)
  %.242.i.i = tail call contract double @llvm.fma.f64(double %.233.i.i, double 0x3D2AE7F3E733B81F, double 0xBDA93974A8C07C9D)
  %.243.i.i = tail call contract double @llvm.fma.f64(double %.233.i.i, double %.242.i.i, double 0x3E21EED8EFF8D898)
  %.244.i.i35 = tail call contract double @llvm.fma.f64(double %.233.i.i, double %.243.i.i, double 0xBE927E4FB7789F5C)
  %.245.i.i = tail call contract double @llvm.fma.f64(double %.233.i.i, double %.244.i.i35, double 0x3EFA01A01A01A01A)
  %.246.i1.i = tail call contract double @llvm.fma.f64(double %.233.i.i, double %.245.i.i, double 0xBF56C16C16C16C17)
  %.247.i2.i = tail call contract double @llvm.fma.f64(double %.233.i.i, double %.246.i1.i, double 0x3FA5555555555555)
  %.248.i3.i = tail call contract double @llvm.fma.f64(double %.233.i.i, double %.247.i2.i, double -5.000000e-01)
  %.249.i4.i = tail call contract double @llvm.fma.f64(double %.233.i.i, double %.248.i3.i, double 1.000000e+00)
  %.250.i5.i = bitcast double %.201.i.i to i64
  %.251.i6.i = bitcast double %.241.i.i to i64
  %.252.i7.i = bitcast double %.249.i4.i to i64
  %.253.i8.i = xor i64 %.252.i7.i, %.251.i6.i
  %.254.i9.i = and i64 %.250.i5.i, 1
  %96 = icmp eq i64 %.254.i9.i, 0
  %.256.i10.i = select i1 %96, i64 0, i64 %.253.i8.i
  %.257.i11.i = shl i64 %.250.i5.i, 62
  %.258.i12.i = and i64 %.257.i11.i, -9223372036854775808
  %.260.i13.i = add i64 %.257.i11.i, 4611686018427387904
  %.261.i14.i = and i64 %.260.i13.i, -9223372036854775808
  %97 = xor i64 %.258.i12.i, %.251.i6.i
  %.263.i15.i = xor i64 %97, %.256.i10.i
  %.264.i16.i = bitcast i64 %.263.i15.i to double
  %98 = xor i64 %.261.i14.i, %.252.i7.i
  %.266.i17.i = xor i64 %98, %.256.i10.i
  %.267.i18.i = bitcast i64 %.266.i17.i to double
  %.332.i.i = load double, ptr %.345.i.i, align 8, !noalias !21
  %.333.i.i = tail call contract double @llvm.fma.f64(double %.332.i.i, double 0x3FE45F306DC9C883, double 0x4338000000000000)
  %.334.i.i = fadd contract double %.333.i.i, 0xC338000000000000
  %.349.i.i = tail call contract double @llvm.fma.f64(double %.334.i.i, double 0xBFF921FB54442D18, double %.332.i.i)
  %.364.i.i = tail call contract double @llvm.fma.f64(double %.334.i.i, double 0xBC91A62633145C07, double %.349.i.i)
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
  %.375.i.i36 = tail call contract double @llvm.fma.f64(double %.365.i.i, double %.374.i.i, double 0x3E21EED8EFF8D898)
  %.376.i.i = tail call contract double @llvm.fma.f64(double %.365.i.i, double %.375.i.i36, double 0xBE927E4FB7789F5C)
  %.377.i.i = tail call contract double @llvm.fma.f64(double %.365.i.i, double %.376.i.i, double 0x3EFA01A01A01A01A)
  %.378.i19.i = tail call contract double @llvm.fma.f64(double %.365.i.i, double %.377.i.i, double 0xBF56C16C16C16C17)
  %.379.i20.i = tail call contract double @llvm.fma.f64(double %.365.i.i, double %.378.i19.i, double 0x3FA5555555555555)
  %.380.i21.i = tail call contract double @llvm.fma.f64(double %.365.i.i, double %.379.i20.i, double -5.000000e-01)
  %.381.i22.i = tail call contract double @llvm.fma.f64(double %.365.i.i, double %.380.i21.i, double 1.000000e+00)
  %.382.i23.i = bitcast double %.333.i.i to i64
  %.383.i24.i = bitcast double %.373.i.i to i64
  %.384.i25.i = bitcast double %.381.i22.i to i64
  %.385.i26.i = xor i64 %.384.i25.i, %.383.i24.i
  %.386.i27.i = and i64 %.382.i23.i, 1
  %99 = icmp eq i64 %.386.i27.i, 0
  %.388.i28.i = select i1 %99, i64 0, i64 %.385.i26.i
  %.389.i29.i = shl i64 %.382.i23.i, 62
  %.390.i30.i = and i64 %.389.i29.i, -9223372036854775808
  %.392.i31.i = add i64 %.389.i29.i, 4611686018427387904
  %.393.i32.i = and i64 %.392.i31.i, -9223372036854775808
  %100 = xor i64 %.390.i30.i, %.383.i24.i
  %.395.i33.i = xor i64 %100, %.388.i28.i
  %.396.i34.i = bitcast i64 %.395.i33.i to double
  %101 = xor i64 %.393.i32.i, %.384.i25.i
  %.398.i35.i = xor i64 %101, %.388.i28.i
  %.399.i36.i = bitcast i64 %.398.i35.i to double
  %.454.i.i37 = load double, ptr %.522.i, align 8, !noalias !21
  %.483.i.i = load double, ptr %.496.i.i, align 8, !noalias !21
  %.512.i.i = load double, ptr %.525.i.i, align 8, !noalias !21
  %.568.i37.i = getelementptr i8, ptr %lsr.iv.i16, i64 104
  tail call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(16) %.568.i37.i, i8 0, i64 16, i1 false), !noalias !21
  br i1 %.542.i.i, label %B344.i.i, label %_ZN17bnserve_inference14adjoint_kernel9_response13fill_geometryB3v41B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i

B344.i.i:                                         ; preds = %_ZN17bnserve_inference13moving_kernel9_response12coefficientsB3v22B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i
  %.599.i.i = getelementptr i8, ptr %lsr.iv.i16, i64 112
  %.606.i.i = fmul contract double %.454.i.i37, %.267.i18.i
  %.610.i53.i = fmul contract double %.483.i.i, %.264.i16.i
  %.611.i54.i = fsub contract double %.606.i.i, %.610.i53.i
  %.615.i.i = fmul contract double %.454.i.i37, %.264.i16.i
  %.621.i.i = fmul contract double %.483.i.i, %.267.i18.i
  %.624.i.i = fadd contract double %.615.i.i, %.621.i.i
  %.626.i55.i = fmul contract double %.611.i54.i, %.399.i36.i
  %.630.i.i = fmul contract double %.512.i.i, %.396.i34.i
  %.631.i.i = fadd contract double %.630.i.i, %.626.i55.i
  %.636.i.i = fdiv contract double %.631.i.i, 0x41B1DE784A000000
  %.638.i.i = fmul contract double %.624.i.i, %.399.i36.i
  %.642.i56.i = fdiv contract double %.638.i.i, 0x41B1DE784A000000
  store double %.642.i56.i, ptr %.568.i37.i, align 8, !noalias !21
  %.674.i.i = fmul contract double %.611.i54.i, %.396.i34.i
  %.678.i.i = fmul contract double %.512.i.i, %.399.i36.i
  %.679.i.i = fsub contract double %.674.i.i, %.678.i.i
  %.683.i.i = fdiv contract double %.679.i.i, 0x41B1DE784A000000
  store double %.683.i.i, ptr %.599.i.i, align 8, !noalias !21
  %.745.i.i = load double, ptr %.145.i.i, align 8, !noalias !21
  %.751.i.i = fmul contract double %.636.i.i, %.745.i.i
  %102 = fsub contract double %.195.i.i, %.751.i.i
  %.756.i.i = tail call contract double @llvm.fma.f64(double %102, double 0x3FE45F306DC9C883, double 0x4338000000000000)
  %.757.i.i = fadd contract double %.756.i.i, 0xC338000000000000
  %.772.i.i49 = tail call contract double @llvm.fma.f64(double %.757.i.i, double 0xBFF921FB54442D18, double %102)
  %.787.i.i = tail call contract double @llvm.fma.f64(double %.757.i.i, double 0xBC91A62633145C07, double %.772.i.i49)
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
  %103 = icmp eq i64 %.809.i.i, 0
  %.811.i.i = select i1 %103, i64 0, i64 %.808.i.i
  %.812.i.i = shl i64 %.805.i.i, 62
  %.813.i.i = and i64 %.812.i.i, -9223372036854775808
  %.815.i.i = add i64 %.812.i.i, 4611686018427387904
  %.816.i.i = and i64 %.815.i.i, -9223372036854775808
  %104 = xor i64 %.813.i.i, %.806.i.i
  %.818.i.i = xor i64 %104, %.811.i.i
  %.819.i.i = bitcast i64 %.818.i.i to double
  %105 = xor i64 %.816.i.i, %.807.i.i
  %.821.i.i = xor i64 %105, %.811.i.i
  %.822.i.i = bitcast i64 %.821.i.i to double
  br label %_ZN17bnserve_inference14adjoint_kernel9_response13fill_geometryB3v41B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i

_ZN17bnserve_inference14adjoint_kernel9_response13fill_geometryB3v41B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i: ; preds = %B344.i.i, %_ZN17bnserve_inference13moving_kernel9_response12coefficientsB3v22B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i
  %sin_h.2.0.i38.i = phi double [ %.819.i.i, %B344.i.i ], [ %.264.i16.i, %_ZN17bnserve_inference13moving_kernel9_response12coefficientsB3v22B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i ]
  %cos_h.2.0.i39.i = phi double [ %.822.i.i, %B344.i.i ], [ %.267.i18.i, %_ZN17bnserve_inference13moving_kernel9_response12coefficientsB3v22B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i ]
  %.908.i.i = fmul contract double %.454.i.i37, %cos_h.2.0.i39.i
  %106 = fmul contract double %.483.i.i, %sin_h.2.0.i38.i
  %.912.i.i38 = fsub contract double %.908.i.i, %106
  %.921.i.i39 = fmul contract double %.512.i.i, 0.000000e+00
  %.922.i.i40 = fadd contract double %.921.i.i39, %.912.i.i38
  %.924.i40.i = fmul contract double %.922.i.i40, %.396.i34.i
  %.928.i.i = fmul contract double %.512.i.i, %.399.i36.i
  %.929.i.i = fsub contract double %.924.i40.i, %.928.i.i
  %.933.i.i = fdiv contract double %.929.i.i, 0x41B1DE784A000000
  %.962.i.i41 = getelementptr i8, ptr %lsr.iv.i16, i64 80
  store double %.933.i.i, ptr %.962.i.i41, align 8, !noalias !21
  %.965.i.i = fneg contract double %.396.i34.i
  %.991.i.i = fmul contract double %.922.i.i40, %.965.i.i
  %.995.i.i = fdiv contract double %.991.i.i, 0x41B1DE784A000000
  %.1024.i.i = getelementptr i8, ptr %lsr.iv.i16, i64 88
  store double %.995.i.i, ptr %.1024.i.i, align 8, !noalias !21
  %.1043.i.i = fmul contract double %.454.i.i37, %sin_h.2.0.i38.i
  %.1046.i.i = fmul contract double %.483.i.i, %cos_h.2.0.i39.i
  %.1047.i.i = fadd contract double %.1043.i.i, %.1046.i.i
  %.1057.i.i = fadd contract double %.921.i.i39, %.1047.i.i
  %.1058.i.i = fmul contract double %.1057.i.i, %.965.i.i
  %.1062.i.i = fdiv contract double %.1058.i.i, 0x41B1DE784A000000
  %.1091.i.i = getelementptr i8, ptr %lsr.iv.i16, i64 96
  store double %.1062.i.i, ptr %.1091.i.i, align 8, !noalias !21
  %.1129.i.i = load double, ptr %.441.i, align 8, !noalias !21
  %.1131.i.i = fmul contract double %cos_h.2.0.i39.i, %.1129.i.i
  %.1160.i.i = load double, ptr %.1028.i.i, align 8, !noalias !21
  %107 = fmul contract double %sin_h.2.0.i38.i, %.1160.i.i
  %.1163.i.i = fsub contract double %.1131.i.i, %107
  %.1192.i.i = load double, ptr %.1060.i.i, align 8, !noalias !21
  %.1194.i.i = fmul contract double %.1192.i.i, 0.000000e+00
  %.1195.i.i = fadd contract double %.1163.i.i, %.1194.i.i
  %.1224.i.i = load double, ptr %.1092.i.i, align 8, !noalias !21
  %.1226.i.i = fmul contract double %cos_h.2.0.i39.i, %.1224.i.i
  %.1255.i.i = load double, ptr %.1123.i.i, align 8, !noalias !21
  %108 = fmul contract double %sin_h.2.0.i38.i, %.1255.i.i
  %.1258.i.i = fsub contract double %.1226.i.i, %108
  %.1287.i.i = load double, ptr %.1155.i.i, align 8, !noalias !21
  %.1289.i.i = fmul contract double %.1287.i.i, 0.000000e+00
  %.1290.i.i = fadd contract double %.1258.i.i, %.1289.i.i
  %.1319.i.i = load double, ptr %.1187.i.i, align 8, !noalias !21
  %.1321.i.i = fmul contract double %cos_h.2.0.i39.i, %.1319.i.i
  %.1350.i44.i = load double, ptr %.1218.i.i, align 8, !noalias !21
  %109 = fmul contract double %sin_h.2.0.i38.i, %.1350.i44.i
  %.1353.i.i = fsub contract double %.1321.i.i, %109
  %.1382.i45.i = load double, ptr %.1250.i.i, align 8, !noalias !21
  %.1390.i.i = fmul contract double %.1382.i45.i, 0.000000e+00
  %.1391.i.i = fadd contract double %.1353.i.i, %.1390.i.i
  %.1448.i.i = fmul contract double %sin_h.2.0.i38.i, %.1129.i.i
  %.1479.i.i = fmul contract double %cos_h.2.0.i39.i, %.1160.i.i
  %.1480.i.i = fadd contract double %.1448.i.i, %.1479.i.i
  %.1512.i.i = fadd contract double %.1480.i.i, %.1194.i.i
  %.1543.i.i = fmul contract double %sin_h.2.0.i38.i, %.1224.i.i
  %.1574.i.i = fmul contract double %cos_h.2.0.i39.i, %.1255.i.i
  %.1575.i.i = fadd contract double %.1543.i.i, %.1574.i.i
  %.1607.i.i42 = fadd contract double %.1575.i.i, %.1289.i.i
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
  %110 = fmul contract double %sin_h.2.0.i38.i, %.1290.i.i
  %.2080.i.i = fsub contract double %.2076.i.i, %110
  %.2089.i.i = fmul contract double %.1391.i.i, 0.000000e+00
  %.2090.i.i = fadd contract double %.2080.i.i, %.2089.i.i
  %.2100.i.i = fmul contract double %cos_h.2.0.i39.i, %.1512.i.i
  %111 = fmul contract double %sin_h.2.0.i38.i, %.1607.i.i42
  %.2104.i.i = fsub contract double %.2100.i.i, %111
  %.2113.i.i = fmul contract double %.1708.i.i, 0.000000e+00
  %.2114.i.i = fadd contract double %.2104.i.i, %.2113.i.i
  %.2127.i.i = fmul contract double %sin_h.2.0.i38.i, %.1512.i.i
  %.2130.i.i = fmul contract double %cos_h.2.0.i39.i, %.1607.i.i42
  %.2131.i.i = fadd contract double %.2127.i.i, %.2130.i.i
  %.2141.i46.i = fadd contract double %.2131.i.i, %.2113.i.i
  %.2154.i47.i = fmul contract double %cos_h.2.0.i39.i, %.1837.i.i
  %112 = fmul contract double %sin_h.2.0.i38.i, %.1932.i.i
  %.2158.i48.i = fsub contract double %.2154.i47.i, %112
  %.2167.i49.i = fmul contract double %.2033.i.i, 0.000000e+00
  %.2168.i.i = fadd contract double %.2158.i48.i, %.2167.i49.i
  %.2181.i.i = fmul contract double %sin_h.2.0.i38.i, %.1837.i.i
  %.2184.i.i = fmul contract double %cos_h.2.0.i39.i, %.1932.i.i
  %.2185.i.i = fadd contract double %.2181.i.i, %.2184.i.i
  %.2195.i.i = fadd contract double %.2185.i.i, %.2167.i49.i
  %.2200.i.i = fadd contract double %.2090.i.i, %.2141.i46.i
  %.2201.i.i = fmul contract double %.2200.i.i, 5.000000e-01
  %.2202.i.i = fsub contract double %.2141.i46.i, %.2090.i.i
  %.2203.i.i = fmul contract double %.2202.i.i, 5.000000e-01
  %.2206.i50.i = fmul contract double %.399.i36.i, %.399.i36.i
  %.2209.i51.i = fmul contract double %.396.i34.i, %.396.i34.i
  %.2210.i52.i = fsub contract double %.2206.i50.i, %.2209.i51.i
  %.2241.i.i = load double, ptr %.2102.i.i, align 8, !noalias !21
  %.2247.i.i = fmul contract double %.2241.i.i, 2.000000e+00
  %.2248.i.i = tail call contract double @llvm.fma.f64(double %.2247.i.i, double 0x3FE45F306DC9C883, double 0x4338000000000000)
  %.2249.i.i = fadd contract double %.2248.i.i, 0xC338000000000000
  %.2264.i.i = tail call contract double @llvm.fma.f64(double %.2249.i.i, double 0xBFF921FB54442D18, double %.2247.i.i)
  %.2279.i.i43 = tail call contract double @llvm.fma.f64(double %.2249.i.i, double 0xBC91A62633145C07, double %.2264.i.i)
  %.2280.i.i = fmul contract double %.2279.i.i43, %.2279.i.i43
  %.2281.i.i = tail call contract double @llvm.fma.f64(double %.2280.i.i, double 0xBD6AE7F3E733B81F, double 0x3DE6124613A86D09)
  %.2282.i.i = tail call contract double @llvm.fma.f64(double %.2280.i.i, double %.2281.i.i, double 0xBE5AE64567F544E4)
  %.2283.i.i = tail call contract double @llvm.fma.f64(double %.2280.i.i, double %.2282.i.i, double 0x3EC71DE3A556C734)
  %.2284.i.i = tail call contract double @llvm.fma.f64(double %.2280.i.i, double %.2283.i.i, double 0xBF2A01A01A01A01A)
  %.2285.i.i = tail call contract double @llvm.fma.f64(double %.2280.i.i, double %.2284.i.i, double 0x3F81111111111111)
  %.2286.i.i = tail call contract double @llvm.fma.f64(double %.2280.i.i, double %.2285.i.i, double 0xBFC5555555555555)
  %.2287.i.i = fmul contract double %.2279.i.i43, %.2280.i.i
  %.2288.i.i = tail call contract double @llvm.fma.f64(double %.2287.i.i, double %.2286.i.i, double %.2279.i.i43)
  %.2289.i.i = tail call contract double @llvm.fma.f64(double %.2280.i.i, double 0x3D2AE7F3E733B81F, double 0xBDA93974A8C07C9D)
  %.2290.i.i = tail call contract double @llvm.fma.f64(double %.2280.i.i, double %.2289.i.i, double 0x3E21EED8EFF8D898)
  %.2291.i.i = tail call contract double @llvm.fma.f64(double %.2280.i.i, double %.2290.i.i, double 0xBE927E4FB7789F5C)
  %.2292.i.i = tail call contract double @llvm.fma.f64(double %.2280.i.i, double %.2291.i.i, double 0x3EFA01A01A01A01A)
  %.2293.i.i = tail call contract double @llvm.fma.f64(double %.2280.i.i, double %.2292.i.i, double 0xBF56C16C16C16C17)
  %.2294.i.i = tail call contract double @llvm.fma.f64(double %.2280.i.i, double %.2293.i.i, double 0x3FA5555555555555)
  %.2295.i.i = tail call contract double @llvm.fma.f64(double %.2280.i.i, double %.2294.i.i, double -5.000000e-01)
  %.2296.i.i = tail call contract double @llvm.fma.f64(double %.2280.i.i, double %.2295.i.i, double 1.000000e+00)
  %.2297.i.i = bitcast double %.2248.i.i to i64
  %.2298.i.i = bitcast double %.2288.i.i to i64
  %.2299.i.i = bitcast double %.2296.i.i to i64
  %.2300.i.i = xor i64 %.2299.i.i, %.2298.i.i
  %.2301.i.i = and i64 %.2297.i.i, 1
  %113 = icmp eq i64 %.2301.i.i, 0
  %.2303.i.i = select i1 %113, i64 0, i64 %.2300.i.i
  %.2304.i.i = shl i64 %.2297.i.i, 62
  %.2305.i.i = and i64 %.2304.i.i, -9223372036854775808
  %.2307.i.i44 = add i64 %.2304.i.i, 4611686018427387904
  %.2308.i.i45 = and i64 %.2307.i.i44, -9223372036854775808
  %114 = xor i64 %.2305.i.i, %.2298.i.i
  %.2310.i.i = xor i64 %114, %.2303.i.i
  %.2311.i.i = bitcast i64 %.2310.i.i to double
  %115 = xor i64 %.2308.i.i45, %.2299.i.i
  %.2313.i.i = xor i64 %115, %.2303.i.i
  %.2314.i.i = bitcast i64 %.2313.i.i to double
  %.2342.i.i = fmul contract double %.396.i34.i, -2.000000e+00
  %.2344.i.i = fmul contract double %.2342.i.i, %.399.i36.i
  %.2345.i.i = fsub contract double %.2201.i.i, %.2033.i.i
  %.2346.i.i = fmul contract double %.2344.i.i, %.2345.i.i
  %.2347.i.i = fmul contract double %.2210.i52.i, 2.000000e+00
  %.2348.i.i = fmul contract double %.2347.i.i, %.2168.i.i
  %.2349.i.i = fmul contract double %.2210.i52.i, -2.000000e+00
  %.2350.i.i = fmul contract double %.2349.i.i, %.2195.i.i
  %.2352.i.i = fmul contract double %.396.i34.i, 2.000000e+00
  %.2354.i.i = fmul contract double %.2352.i.i, %.399.i36.i
  %.2355.i.i = fmul contract double %.2354.i.i, %.2203.i.i
  %.2360.i.i = fmul contract double %.2354.i.i, %.2114.i.i
  %.2381.i.i = fmul contract double %.2352.i.i, %.2195.i.i
  %.2386.i.i = fmul contract double %.2352.i.i, %.2168.i.i
  %.2388.i.i = fmul contract double %.399.i36.i, 2.000000e+00
  %.2389.i.i = fmul contract double %.2388.i.i, %.2114.i.i
  %.2391.i.i = fmul contract double %.399.i36.i, -2.000000e+00
  %.2394.i.i = fmul contract double %.2391.i.i, %.2203.i.i
  %.2551.i.i = fmul contract double %.2346.i.i, %.2314.i.i
  %.2571.i.i = fmul contract double %.2311.i.i, 0.000000e+00
  %.2572.i.i = fadd contract double %.2551.i.i, %.2571.i.i
  store double %.2572.i.i, ptr %lsr.iv.i16, align 8, !noalias !21
  %.2623.i.i = fmul contract double %.2314.i.i, 0.000000e+00
  %.2643.i.i = fmul contract double %.2346.i.i, %.2311.i.i
  %.2644.i.i = fsub contract double %.2623.i.i, %.2643.i.i
  %116 = getelementptr i8, ptr %lsr.iv.i16, i64 40
  store double %.2644.i.i, ptr %116, align 8, !noalias !21
  %.2551.1.i.i = fmul contract double %.2348.i.i, %.2314.i.i
  %.2571.1.i.i = fmul contract double %.2381.i.i, %.2311.i.i
  %.2572.1.i.i = fadd contract double %.2551.1.i.i, %.2571.1.i.i
  %117 = getelementptr i8, ptr %lsr.iv.i16, i64 8
  store double %.2572.1.i.i, ptr %117, align 8, !noalias !21
  %.2623.1.i.i = fmul contract double %.2381.i.i, %.2314.i.i
  %.2643.1.i.i = fmul contract double %.2348.i.i, %.2311.i.i
  %.2644.1.i.i = fsub contract double %.2623.1.i.i, %.2643.1.i.i
  %118 = getelementptr i8, ptr %lsr.iv.i16, i64 48
  store double %.2644.1.i.i, ptr %118, align 8, !noalias !21
  %.2551.2.i.i = fmul contract double %.2350.i.i, %.2314.i.i
  %.2571.2.i.i = fmul contract double %.2386.i.i, %.2311.i.i
  %.2572.2.i.i = fadd contract double %.2551.2.i.i, %.2571.2.i.i
  %119 = getelementptr i8, ptr %lsr.iv.i16, i64 16
  store double %.2572.2.i.i, ptr %119, align 8, !noalias !21
  %.2623.2.i.i = fmul contract double %.2386.i.i, %.2314.i.i
  %.2643.2.i.i = fmul contract double %.2350.i.i, %.2311.i.i
  %.2644.2.i.i = fsub contract double %.2623.2.i.i, %.2643.2.i.i
  %120 = getelementptr i8, ptr %lsr.iv.i16, i64 56
  store double %.2644.2.i.i, ptr %120, align 8, !noalias !21
  %.2551.3.i.i = fmul contract double %.2355.i.i, %.2314.i.i
  %.2571.3.i.i = fmul contract double %.2389.i.i, %.2311.i.i
  %.2572.3.i.i = fadd contract double %.2551.3.i.i, %.2571.3.i.i
  %121 = getelementptr i8, ptr %lsr.iv.i16, i64 24
  store double %.2572.3.i.i, ptr %121, align 8, !noalias !21
  %.2623.3.i.i = fmul contract double %.2389.i.i, %.2314.i.i
  %.2643.3.i.i = fmul contract double %.2355.i.i, %.2311.i.i
  %.2644.3.i.i = fsub contract double %.2623.3.i.i, %.2643.3.i.i
  %122 = getelementptr i8, ptr %lsr.iv.i16, i64 64
  store double %.2644.3.i.i, ptr %122, align 8, !noalias !21
  %.2551.4.i.i = fmul contract double %.2360.i.i, %.2314.i.i
  %.2571.4.i.i = fmul contract double %.2394.i.i, %.2311.i.i
  %.2572.4.i.i = fadd contract double %.2551.4.i.i, %.2571.4.i.i
  %123 = getelementptr i8, ptr %lsr.iv.i16, i64 32
  store double %.2572.4.i.i, ptr %123, align 8, !noalias !21
  %.2623.4.i.i = fmul contract double %.2394.i.i, %.2314.i.i
  %.2643.4.i.i = fmul contract double %.2360.i.i, %.2311.i.i
  %.2644.4.i.i = fsub contract double %.2623.4.i.i, %.2643.4.i.i
  %124 = getelementptr i8, ptr %lsr.iv.i16, i64 72
  store double %.2644.4.i.i, ptr %124, align 8, !noalias !21
  %125 = getelementptr i8, ptr %lsr.iv.i16, i64 120
  tail call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(32) %125, i8 0, i64 32, i1 false), !noalias !21
  %scevgep.i46 = getelementptr i8, ptr %lsr.iv.i16, i64 152
  %scevgep132.i = getelementptr i8, ptr %lsr.iv131.i, i64 200
  %lsr.iv.next.i47 = add i64 %lsr.iv133.i, 48
  %lsr.iv.next135.i = add i64 %lsr.iv134.i, 24
  %lsr.iv.next137.i = add i64 %lsr.iv136.i15, 72
  %lsr.iv.next139.i = add nsw i64 %lsr.iv138.i, -1
  %exitcond.not.i48 = icmp eq i64 %lsr.iv.next139.i, 0
  br i1 %exitcond.not.i48, label %_ZN17bnserve_inference14adjoint_kernel7_source6_placeB3v14B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit, label %B268.if.i

_ZN17bnserve_inference14adjoint_kernel7_source6_placeB3v14B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit: ; preds = %_ZN17bnserve_inference14adjoint_kernel9_response13fill_geometryB3v41B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i, %B544.if
  %.50.i = load i64, ptr %.76, align 8, !noalias !24
  %.80.i52 = load i64, ptr %.143, align 8, !noalias !24
  %.110.i = load i64, ptr %.106, align 8, !noalias !24
  %.122.i = sub i64 0, %.80.i52
  %.130.1.i = and i64 %.122.i, -8
  %.164.i = sub i64 0, %.130.1.i
  %.194.i = load i64, ptr %.193.i53, align 8, !noalias !24
  %.228.i = load i64, ptr %.227.i, align 8, !noalias !24
  %.229.i = shl i64 %.604928988, 3
  %.231.i = mul i64 %.194.i, %.229.i
  %.232.i = add nsw i64 %.231.i, %.228.i
  %.293.i = icmp sgt i64 %.194.i, 0
  br i1 %.293.i, label %_ZN17bnserve_inference13moving_kernel8_passing12find_passingB3v57B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIxLi1E1C7mutable7alignedE.exit, label %B288.i

B288.i:                                           ; preds = %_ZN17bnserve_inference14adjoint_kernel7_source6_placeB3v14B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit
  %.725.i = load i64, ptr %.724.i, align 8, !noalias !24
  %.733.i = inttoptr i64 %.725.i to ptr
  %.858.i = getelementptr double, ptr %.733.i, i64 %.164.i
  %.10071199.not.i = icmp slt i64 %.50.i, 1
  br i1 %.10071199.not.i, label %_ZN17bnserve_inference13moving_kernel8_passing12find_passingB3v57B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIxLi1E1C7mutable7alignedE.exit, label %B766.if.lr.ph.i

B766.if.lr.ph.i:                                  ; preds = %B288.i
  %.548.i = load i64, ptr %.547.i, align 8, !noalias !24
  %.460.i = load i64, ptr %.459.i, align 8, !noalias !24
  %.362.i = load i64, ptr %.361.i, align 8, !noalias !24
  %.364.i = shl i64 %.604928988, 4
  %.366.i = mul i64 %.364.i, %.80.i52
  %.368.i = mul i64 %.366.i, %.110.i
  %.371.i = add nsw i64 %.362.i, %.368.i
  %.637.i = load i64, ptr %.636.i, align 8, !noalias !24
  %126 = inttoptr i64 %.637.i to ptr
  %127 = inttoptr i64 %.232.i to ptr
  %.640.i = mul i64 %.50.i, %.164.i
  %.1125.i = getelementptr double, ptr %127, i64 %.640.i
  %128 = tail call i64 @llvm.smax.i64(i64 %.164.i, i64 0)
  %storemerge1090.i = lshr exact i64 %128, 3
  %129 = lshr i64 %.122.i, 3
  %130 = mul i64 %129, -64
  %131 = add nuw nsw i64 %storemerge1090.i, 3
  %132 = inttoptr i64 %.548.i to ptr
  %133 = inttoptr i64 %.460.i to ptr
  %134 = inttoptr i64 %.371.i to ptr
  %.146.i.i54 = icmp slt i64 %.164.i, 1
  %135 = sub i64 7, %.130.1.i
  %.169.i.i = lshr i64 %135, 3
  %.1901286.not2107.i.i = icmp eq i64 %.169.i.i, 0
  %.1901286.not.i.i = or i1 %.146.i.i54, %.1901286.not2107.i.i
  %.258.i.i55 = add i64 %.80.i52, -1
  %.303.i.i = and i64 %.258.i.i55, -8
  %.3971410.not.i.i = icmp slt i64 %.110.i, 1
  %sunkaddr10.i = getelementptr i8, ptr %.733.i, i64 8
  %sunkaddr11.i = getelementptr i8, ptr %.858.i, i64 8
  %sunkaddr12.i = getelementptr i8, ptr %.1125.i, i64 8
  %sunkaddr15.i = getelementptr i8, ptr %.733.i, i64 16
  %sunkaddr16.i = getelementptr i8, ptr %.858.i, i64 16
  %sunkaddr17.i = getelementptr i8, ptr %.1125.i, i64 16
  %sunkaddr23.i = getelementptr i8, ptr %.733.i, i64 24
  %sunkaddr27.i56 = getelementptr i8, ptr %.858.i, i64 24
  %sunkaddr31.i = getelementptr i8, ptr %.1125.i, i64 24
  %sunkaddr39.i = getelementptr i8, ptr %.733.i, i64 32
  %sunkaddr40.i = getelementptr i8, ptr %.858.i, i64 32
  %sunkaddr41.i = getelementptr i8, ptr %.1125.i, i64 32
  %sunkaddr43.i = getelementptr i8, ptr %.733.i, i64 40
  %sunkaddr44.i = getelementptr i8, ptr %.858.i, i64 40
  %sunkaddr45.i = getelementptr i8, ptr %.1125.i, i64 40
  %sunkaddr47.i = getelementptr i8, ptr %.733.i, i64 48
  %sunkaddr48.i = getelementptr i8, ptr %.858.i, i64 48
  %sunkaddr49.i = getelementptr i8, ptr %.1125.i, i64 48
  %sunkaddr51.i = getelementptr i8, ptr %.733.i, i64 56
  %sunkaddr52.i = getelementptr i8, ptr %.858.i, i64 56
  %sunkaddr53.i = getelementptr i8, ptr %.1125.i, i64 56
  %136 = add nsw i64 %.169.i.i, -1
  %xtraiter.i.i = and i64 %.169.i.i, 3
  %137 = icmp ult i64 %136, 3
  %138 = lshr i64 %135, 5
  %139 = mul nsw i64 %138, -4
  %lcmp.mod.not.i.i = icmp eq i64 %xtraiter.i.i, 0
  %140 = shl nuw nsw i64 %xtraiter.i.i, 6
  %.586.i.i = icmp slt i64 %.80.i52, 9
  %.605.i.i57 = ashr i64 %.258.i.i55, 3
  %storemerge785.i.i = select i1 %.586.i.i, i64 0, i64 %.605.i.i57
  %.1255.i.i58 = and i64 %.258.i.i55, 7
  %scevgep604.i.i = getelementptr i8, ptr %134, i64 16
  %141 = shl i64 %.80.i52, 4
  %142 = shl i64 %.258.i.i55, 4
  %143 = and i64 %142, -128
  %144 = getelementptr i8, ptr %134, i64 %143
  %scevgep614.i.i = getelementptr i8, ptr %144, i64 24
  %145 = shl i64 %.164.i, 3
  %146 = or disjoint i64 %145, 8
  %147 = add nsw i64 %storemerge785.i.i, 4
  %148 = add nuw nsw i64 %.1255.i.i58, 4
  %149 = icmp sgt i64 %storemerge785.i.i, 0
  %150 = icmp eq i64 %.1255.i.i58, 0
  %151 = add nuw nsw i64 %.169.i.i, 4
  %152 = icmp sgt i64 %.164.i, 8
  %sunkaddr8.i = getelementptr i8, ptr %.733.i, i64 %145
  br label %B766.if.i59

B766.if.i59:                                      ; preds = %B1398.if.i, %B766.if.lr.ph.i
  %lsr.iv245.i = phi ptr [ %126, %B766.if.lr.ph.i ], [ %scevgep246.i, %B1398.if.i ]
  %lsr.iv242.i = phi ptr [ %127, %B766.if.lr.ph.i ], [ %scevgep243.i, %B1398.if.i ]
  %.101311541204.i = phi i64 [ 0, %B766.if.lr.ph.i ], [ %.1020.i, %B1398.if.i ]
  %.1020.i = add nuw nsw i64 %.101311541204.i, 1
  %.1047.i = mul nsw i64 %.101311541204.i, %.164.i
  %.1059.i = getelementptr inbounds double, ptr %127, i64 %.1047.i
  %.1266.i = shl nuw nsw i64 %.101311541204.i, 1
  %.1268.i = mul nsw i64 %.1266.i, %.164.i
  %.1280.i = getelementptr inbounds double, ptr %132, i64 %.1268.i
  %.1333.neg.i = xor i64 %.1266.i, -1
  %.1335.i = mul i64 %.130.1.i, %.1333.neg.i
  %.1347.i = getelementptr inbounds double, ptr %132, i64 %.1335.i
  br i1 %.1901286.not.i.i, label %B200.i.i, label %B74.if.preheader.i.i

B74.if.preheader.i.i:                             ; preds = %B766.if.i59
  br i1 %137, label %B74.if.epil.preheader.i.i, label %B74.if.i.i

B200.loopexit.unr-lcssa.i.i:                      ; preds = %B74.if.i.i
  br i1 %lcmp.mod.not.i.i, label %B200.i.i, label %B74.if.epil.preheader.i.i

B74.if.epil.preheader.i.i:                        ; preds = %B200.loopexit.unr-lcssa.i.i, %B74.if.preheader.i.i
  %.19612851287.epil.init.i.i = phi i64 [ 0, %B74.if.preheader.i.i ], [ %.203.3.i.i, %B200.loopexit.unr-lcssa.i.i ]
  %153 = shl i64 %.19612851287.epil.init.i.i, 3
  %scevgep636.i.i = getelementptr i8, ptr %.1125.i, i64 %153
  %scevgep640.i.i = getelementptr i8, ptr %.1059.i, i64 %153
  br label %B74.if.epil.i.i

B74.if.epil.i.i:                                  ; preds = %B74.if.epil.i.i, %B74.if.epil.preheader.i.i
  %lsr.iv637.i.i = phi i64 [ %lsr.iv.next638.i.i, %B74.if.epil.i.i ], [ 0, %B74.if.epil.preheader.i.i ]
  %scevgep641.i.i = getelementptr i8, ptr %scevgep640.i.i, i64 %lsr.iv637.i.i
  store <8 x double> zeroinitializer, ptr %scevgep641.i.i, align 8, !noalias !27
  %scevgep639.i.i = getelementptr i8, ptr %scevgep636.i.i, i64 %lsr.iv637.i.i
  store <8 x double> zeroinitializer, ptr %scevgep639.i.i, align 8, !noalias !27
  %lsr.iv.next638.i.i = add nuw nsw i64 %lsr.iv637.i.i, 64
  %epil.iter.cmp.not.i.i = icmp eq i64 %140, %lsr.iv.next638.i.i
  br i1 %epil.iter.cmp.not.i.i, label %B200.i.i, label %B74.if.epil.i.i, !llvm.loop !30

B200.i.i:                                         ; preds = %B74.if.epil.i.i, %B200.loopexit.unr-lcssa.i.i, %B766.if.i59
  br i1 %.3971410.not.i.i, label %B1324.i.i, label %B298.if.i.i

B330.i.i:                                         ; preds = %B298.if.i.i
  br i1 %149, label %B426.if.i.i, label %B912.i.i

B912.i.i:                                         ; preds = %B426.if.i.i, %B330.i.i
  br i1 %150, label %B1320.i.i, label %B944.if.i.i

B1320.i.i:                                        ; preds = %B944.if.i.i, %B298.if.i.i, %B912.i.i
  %scevgep606.i.i = getelementptr i8, ptr %lsr.iv605.i.i, i64 %141
  %scevgep616.i.i = getelementptr i8, ptr %lsr.iv615.i.i, i64 %141
  %exitcond.not.i.i64 = icmp eq i64 %.410.i.i62, %.110.i
  br i1 %exitcond.not.i.i64, label %B1324.i.i, label %B298.if.i.i

B1324.i.i:                                        ; preds = %B1320.i.i, %B200.i.i
  br i1 %.1901286.not.i.i, label %_ZN17bnserve_inference13moving_kernel8_passing6_turnsB3v73B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedExx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i, label %B1368.if.i.i

B74.if.i.i:                                       ; preds = %B74.if.preheader.i.i, %B74.if.i.i
  %lsr.iv.i.i60 = phi i64 [ %lsr.iv.next.i.i61, %B74.if.i.i ], [ %139, %B74.if.preheader.i.i ]
  %.19612851287.i.i = phi i64 [ %.203.3.i.i, %B74.if.i.i ], [ 0, %B74.if.preheader.i.i ]
  %sunkaddr41.i.i = shl i64 %.19612851287.i.i, 3
  %sunkaddr42.i.i = getelementptr i8, ptr %.1059.i, i64 %sunkaddr41.i.i
  store <8 x double> zeroinitializer, ptr %sunkaddr42.i.i, align 8, !noalias !27
  %sunkaddr44.i.i = getelementptr i8, ptr %.1125.i, i64 %sunkaddr41.i.i
  store <8 x double> zeroinitializer, ptr %sunkaddr44.i.i, align 8, !noalias !27
  %sunkaddr46.i.i = getelementptr i8, ptr %sunkaddr42.i.i, i64 64
  store <8 x double> zeroinitializer, ptr %sunkaddr46.i.i, align 8, !noalias !27
  %sunkaddr49.i.i = getelementptr i8, ptr %sunkaddr44.i.i, i64 64
  store <8 x double> zeroinitializer, ptr %sunkaddr49.i.i, align 8, !noalias !27
  %sunkaddr52.i.i = getelementptr i8, ptr %sunkaddr42.i.i, i64 128
  store <8 x double> zeroinitializer, ptr %sunkaddr52.i.i, align 8, !noalias !27
  %sunkaddr55.i.i = getelementptr i8, ptr %sunkaddr44.i.i, i64 128
  store <8 x double> zeroinitializer, ptr %sunkaddr55.i.i, align 8, !noalias !27
  %.203.3.i.i = add i64 %.19612851287.i.i, 32
  %sunkaddr56.i.i = shl i64 %.203.3.i.i, 3
  %sunkaddr57.i.i = getelementptr i8, ptr %.1059.i, i64 %sunkaddr56.i.i
  %sunkaddr58.i.i = getelementptr i8, ptr %sunkaddr57.i.i, i64 -64
  store <8 x double> zeroinitializer, ptr %sunkaddr58.i.i, align 8, !noalias !27
  %sunkaddr60.i.i = getelementptr i8, ptr %.1125.i, i64 %sunkaddr56.i.i
  %sunkaddr61.i.i = getelementptr i8, ptr %sunkaddr60.i.i, i64 -64
  store <8 x double> zeroinitializer, ptr %sunkaddr61.i.i, align 8, !noalias !27
  %lsr.iv.next.i.i61 = add i64 %lsr.iv.i.i60, 4
  %niter.ncmp.3.not.i.i = icmp eq i64 %lsr.iv.next.i.i61, 0
  br i1 %niter.ncmp.3.not.i.i, label %B200.loopexit.unr-lcssa.i.i, label %B74.if.i.i

B298.if.i.i:                                      ; preds = %B200.i.i, %B1320.i.i
  %lsr.iv615.i.i = phi ptr [ %scevgep616.i.i, %B1320.i.i ], [ %scevgep614.i.i, %B200.i.i ]
  %lsr.iv605.i.i = phi ptr [ %scevgep606.i.i, %B1320.i.i ], [ %scevgep604.i.i, %B200.i.i ]
  %.40313421415.i.i = phi i64 [ %.410.i.i62, %B1320.i.i ], [ 0, %B200.i.i ]
  %.410.i.i62 = add nuw nsw i64 %.40313421415.i.i, 1
  %154 = getelementptr i64, ptr %133, i64 %.40313421415.i.i
  %.468.i.i63 = load i64, ptr %154, align 8, !noalias !27
  %.470.i.i = icmp eq i64 %.468.i.i63, %.101311541204.i
  br i1 %.470.i.i, label %B330.i.i, label %B1320.i.i

B426.if.i.i:                                      ; preds = %B330.i.i, %B426.if.i.i
  %lsr.iv3.i.i80 = phi i64 [ %lsr.iv.next4.i.i, %B426.if.i.i ], [ %147, %B330.i.i ]
  %lsr.iv595.i.i = phi i64 [ %lsr.iv.next596.i.i, %B426.if.i.i ], [ 0, %B330.i.i ]
  %sunkaddr62.i.i = getelementptr i8, ptr %.1280.i, i64 %lsr.iv595.i.i
  %.675.i.i81 = load <8 x double>, ptr %sunkaddr62.i.i, align 8, !noalias !27
  %sunkaddr63.i.i = getelementptr i8, ptr %.1347.i, i64 %lsr.iv595.i.i
  %.685.i.i = load <8 x double>, ptr %sunkaddr63.i.i, align 8, !noalias !27
  %sunkaddr65.i.i = getelementptr i8, ptr %sunkaddr62.i.i, i64 8
  %.696.i.i = load <8 x double>, ptr %sunkaddr65.i.i, align 8, !noalias !27
  %sunkaddr67.i.i = getelementptr i8, ptr %sunkaddr63.i.i, i64 8
  %.707.i.i = load <8 x double>, ptr %sunkaddr67.i.i, align 8, !noalias !27
  %155 = shl i64 %lsr.iv595.i.i, 1
  %scevgep607.i.i = getelementptr i8, ptr %lsr.iv605.i.i, i64 %155
  %.744.i.i = load <16 x double>, ptr %scevgep607.i.i, align 8, !noalias !27
  %.745.i.i82 = shufflevector <16 x double> %.744.i.i, <16 x double> poison, <8 x i32> <i32 0, i32 2, i32 4, i32 6, i32 8, i32 10, i32 12, i32 14>
  %.746.i.i = shufflevector <16 x double> %.744.i.i, <16 x double> poison, <8 x i32> <i32 1, i32 3, i32 5, i32 7, i32 9, i32 11, i32 13, i32 15>
  %scevgep609.i.i = getelementptr i8, ptr %scevgep607.i.i, i64 -16
  %.759.i.i = load <16 x double>, ptr %scevgep609.i.i, align 8, !noalias !27
  %.760.i.i83 = shufflevector <16 x double> %.759.i.i, <16 x double> poison, <8 x i32> <i32 0, i32 2, i32 4, i32 6, i32 8, i32 10, i32 12, i32 14>
  %.761.i.i = shufflevector <16 x double> %.759.i.i, <16 x double> poison, <8 x i32> <i32 1, i32 3, i32 5, i32 7, i32 9, i32 11, i32 13, i32 15>
  %.8.i.i.i84 = fsub contract <8 x double> zeroinitializer, %.761.i.i
  %.6.i.i.i85 = fmul contract <8 x double> %.746.i.i, %.8.i.i.i84
  %.8.i540.i.i = fsub contract <8 x double> zeroinitializer, %.6.i.i.i85
  %.853.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.745.i.i82, <8 x double> %.760.i.i83, <8 x double> %.8.i540.i.i)
  %.6.i541.i.i = fmul contract <8 x double> %.746.i.i, %.760.i.i83
  %.878.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.745.i.i82, <8 x double> %.8.i.i.i84, <8 x double> %.6.i541.i.i)
  %.8.i542.i.i = fsub contract <8 x double> zeroinitializer, %.707.i.i
  %.6.i543.i.i = fmul contract <8 x double> %.685.i.i, %.8.i542.i.i
  %.8.i544.i.i = fsub contract <8 x double> zeroinitializer, %.6.i543.i.i
  %.972.i.i86 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.675.i.i81, <8 x double> %.696.i.i, <8 x double> %.8.i544.i.i)
  %.6.i545.i.i = fmul contract <8 x double> %.685.i.i, %.696.i.i
  %.997.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.675.i.i81, <8 x double> %.8.i542.i.i, <8 x double> %.6.i545.i.i)
  %.6.i546.i.i = fmul contract <8 x double> %.997.i.i, %.878.i.i
  %.8.i547.i.i = fsub contract <8 x double> zeroinitializer, %.6.i546.i.i
  %.1067.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.853.i.i, <8 x double> %.972.i.i86, <8 x double> %.8.i547.i.i)
  %.6.i548.i.i = fmul contract <8 x double> %.972.i.i86, %.878.i.i
  %.1092.i.i87 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.853.i.i, <8 x double> %.997.i.i, <8 x double> %.6.i548.i.i)
  %.8.i549.i.i = fsub contract <8 x double> zeroinitializer, %.1092.i.i87
  %scevgep611.i.i = getelementptr i8, ptr %.1059.i, i64 %lsr.iv595.i.i
  %.1154.i.i = load <8 x double>, ptr %scevgep611.i.i, align 8, !noalias !27
  %.1155.i.i88 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i549.i.i, <8 x double> %.1092.i.i87, <8 x double> %.1154.i.i)
  %.1156.i.i89 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1067.i.i, <8 x double> %.1067.i.i, <8 x double> %.1155.i.i88)
  store <8 x double> %.1156.i.i89, ptr %scevgep611.i.i, align 8, !noalias !27
  %.8.i550.i.i = fmul contract <8 x double> %.1067.i.i, splat (double 2.000000e+00)
  %scevgep610.i.i = getelementptr i8, ptr %.1125.i, i64 %lsr.iv595.i.i
  %.1200.i.i = load <8 x double>, ptr %scevgep610.i.i, align 8, !noalias !27
  %.1201.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i550.i.i, <8 x double> %.1092.i.i87, <8 x double> %.1200.i.i)
  store <8 x double> %.1201.i.i, ptr %scevgep610.i.i, align 8, !noalias !27
  %lsr.iv.next596.i.i = add nuw i64 %lsr.iv595.i.i, 64
  %lsr.iv.next4.i.i = add nsw i64 %lsr.iv3.i.i80, -1
  %.628.i.i = icmp sgt i64 %lsr.iv3.i.i80, 5
  br i1 %.628.i.i, label %B426.if.i.i, label %B912.i.i

B944.if.i.i:                                      ; preds = %B912.i.i, %B944.if.i.i
  %lsr.iv13.i.i = phi i64 [ %lsr.iv.next14.i.i, %B944.if.i.i ], [ %148, %B912.i.i ]
  %lsr.iv617.i.i = phi ptr [ %scevgep618.i.i, %B944.if.i.i ], [ %lsr.iv615.i.i, %B912.i.i ]
  %.130413221324.i.i = phi i64 [ %.1311.i.i, %B944.if.i.i ], [ %.303.i.i, %B912.i.i ]
  %.1311.i.i = add nuw nsw i64 %.130413221324.i.i, 1
  %scevgep620.i.i = getelementptr i8, ptr %lsr.iv617.i.i, i64 -24
  %scevgep619.i.i = getelementptr i8, ptr %lsr.iv617.i.i, i64 -8
  %.1346.i.i = load double, ptr %scevgep619.i.i, align 8, !noalias !27
  %.1357.i.i = load double, ptr %lsr.iv617.i.i, align 8, !noalias !27
  %.1371.i.i = load double, ptr %scevgep620.i.i, align 8, !noalias !27
  %scevgep621.i.i = getelementptr i8, ptr %lsr.iv617.i.i, i64 -16
  %.1382.i.i74 = load double, ptr %scevgep621.i.i, align 8, !noalias !27
  %.1405.i.i = icmp slt i64 %.130413221324.i.i, 0
  %156 = select i1 %.1405.i.i, i64 %145, i64 0
  %scevgep628.i.i = getelementptr i8, ptr %.1280.i, i64 %156
  %157 = shl i64 %.130413221324.i.i, 3
  %scevgep629.i.i = getelementptr i8, ptr %scevgep628.i.i, i64 %157
  %.1421.i.i = load double, ptr %scevgep629.i.i, align 8, !noalias !27
  %scevgep626.i.i = getelementptr i8, ptr %.1347.i, i64 %156
  %scevgep627.i.i = getelementptr i8, ptr %scevgep626.i.i, i64 %157
  %.1451.i.i = load double, ptr %scevgep627.i.i, align 8, !noalias !27
  %.1466.i.i = icmp slt i64 %.130413221324.i.i, -1
  %158 = select i1 %.1466.i.i, i64 %146, i64 8
  %scevgep17.i.i = getelementptr i8, ptr %.1280.i, i64 %158
  %scevgep24.i.i75 = getelementptr i8, ptr %scevgep17.i.i, i64 %157
  %.1482.i.i = load double, ptr %scevgep24.i.i75, align 8, !noalias !27
  %scevgep15.i.i = getelementptr i8, ptr %.1347.i, i64 %158
  %scevgep19.i.i76 = getelementptr i8, ptr %scevgep15.i.i, i64 %157
  %.1513.i.i = load double, ptr %scevgep19.i.i76, align 8, !noalias !27
  %.1531.i.i = fsub contract double 0.000000e+00, %.1382.i.i74
  %.1532.i.i = fmul contract double %.1357.i.i, %.1531.i.i
  %.1533.i.i = fsub contract double 0.000000e+00, %.1532.i.i
  %.1534.i.i = tail call contract double @llvm.fma.f64(double %.1346.i.i, double %.1371.i.i, double %.1533.i.i)
  %.1535.i.i = fmul contract double %.1357.i.i, %.1371.i.i
  %.1536.i.i = tail call contract double @llvm.fma.f64(double %.1346.i.i, double %.1531.i.i, double %.1535.i.i)
  %.1558.i.i = fsub contract double 0.000000e+00, %.1513.i.i
  %.1559.i.i = fmul contract double %.1451.i.i, %.1558.i.i
  %.1560.i.i = fsub contract double 0.000000e+00, %.1559.i.i
  %.1561.i.i = tail call contract double @llvm.fma.f64(double %.1421.i.i, double %.1482.i.i, double %.1560.i.i)
  %.1562.i.i = fmul contract double %.1451.i.i, %.1482.i.i
  %.1563.i.i = tail call contract double @llvm.fma.f64(double %.1421.i.i, double %.1558.i.i, double %.1562.i.i)
  %.1585.i.i = fmul contract double %.1536.i.i, %.1563.i.i
  %.1586.i.i = fsub contract double 0.000000e+00, %.1585.i.i
  %.1587.i.i = tail call contract double @llvm.fma.f64(double %.1534.i.i, double %.1561.i.i, double %.1586.i.i)
  %.1588.i.i = fmul contract double %.1536.i.i, %.1561.i.i
  %.1589.i.i = tail call contract double @llvm.fma.f64(double %.1534.i.i, double %.1563.i.i, double %.1588.i.i)
  %scevgep624.i.i = getelementptr i8, ptr %.1059.i, i64 %156
  %scevgep18.i.i = getelementptr i8, ptr %scevgep624.i.i, i64 %157
  %.1647.i.i77 = load double, ptr %scevgep18.i.i, align 8, !noalias !27
  %.1648.i.i78 = fmul contract double %.1587.i.i, %.1587.i.i
  %.1649.i.i = fmul contract double %.1589.i.i, %.1589.i.i
  %.1650.i.i = fsub contract double %.1648.i.i78, %.1649.i.i
  %.1651.i.i79 = fadd contract double %.1647.i.i77, %.1650.i.i
  store double %.1651.i.i79, ptr %scevgep18.i.i, align 8, !noalias !27
  %scevgep622.i.i = getelementptr i8, ptr %.1125.i, i64 %156
  %scevgep16.i.i = getelementptr i8, ptr %scevgep622.i.i, i64 %157
  %.1711.i.i = load double, ptr %scevgep16.i.i, align 8, !noalias !27
  %.1712.i.i = fmul contract double %.1587.i.i, 2.000000e+00
  %.1713.i.i = fmul contract double %.1712.i.i, %.1589.i.i
  %.1714.i.i = fadd contract double %.1711.i.i, %.1713.i.i
  store double %.1714.i.i, ptr %scevgep16.i.i, align 8, !noalias !27
  %scevgep618.i.i = getelementptr i8, ptr %lsr.iv617.i.i, i64 16
  %lsr.iv.next14.i.i = add nsw i64 %lsr.iv13.i.i, -1
  %.1298.i.i = icmp sgt i64 %lsr.iv13.i.i, 5
  br i1 %.1298.i.i, label %B944.if.i.i, label %B1320.i.i

B1368.if.i.i:                                     ; preds = %B1324.i.i, %B1368.if.i.i
  %lsr.iv1.i.i65 = phi i64 [ %lsr.iv.next2.i.i68, %B1368.if.i.i ], [ %151, %B1324.i.i ]
  %lsr.iv589.i.i = phi i64 [ %lsr.iv.next590.i.i, %B1368.if.i.i ], [ 0, %B1324.i.i ]
  %scevgep591.i.i = getelementptr i8, ptr %.1059.i, i64 %lsr.iv589.i.i
  %.1920.i.i = load <8 x double>, ptr %scevgep591.i.i, align 8, !noalias !27
  %scevgep.i.i66 = getelementptr i8, ptr %.1125.i, i64 %lsr.iv589.i.i
  %.1930.i.i = load <8 x double>, ptr %scevgep.i.i66, align 8, !noalias !27
  %.6.i551.i.i = fmul contract <8 x double> %.1920.i.i, %.1920.i.i
  %.6.i552.i.i = fmul contract <8 x double> %.1930.i.i, %.1930.i.i
  %.6.i553.i.i = fadd contract <8 x double> %.6.i551.i.i, %.6.i552.i.i
  %.2003.i.i67 = tail call <8 x double> @llvm.sqrt.v8f64(<8 x double> %.6.i553.i.i)
  %.6.i554.i.i = fadd contract <8 x double> %.1920.i.i, %.2003.i.i67
  %.8.i555.i.i = fadd contract <8 x double> %.6.i554.i.i, splat (double 1.000000e-300)
  %.6.i556.i.i = fdiv contract <8 x double> %.1930.i.i, %.8.i555.i.i
  %.6.i557.i.i = fmul contract <8 x double> %.6.i556.i.i, %.6.i556.i.i
  %.8.i558.i.i = fadd contract <8 x double> %.6.i557.i.i, splat (double 1.000000e+00)
  %.2124.i.i = tail call <8 x double> @llvm.sqrt.v8f64(<8 x double> %.8.i558.i.i)
  %.8.i559.i.i = fadd contract <8 x double> %.2124.i.i, splat (double 1.000000e+00)
  %.6.i560.i.i = fdiv contract <8 x double> %.6.i556.i.i, %.8.i559.i.i
  %.6.i561.i.i = fmul contract <8 x double> %.6.i560.i.i, %.6.i560.i.i
  %.8.i562.i.i = fmul contract <8 x double> %.6.i561.i.i, splat (double 0x3F677AE9349F5F7A)
  %.8.i563.i.i = fadd contract <8 x double> %.8.i562.i.i, splat (double 0xBF908DC039C4DC63)
  %.6.i564.i.i = fmul contract <8 x double> %.6.i561.i.i, %.8.i563.i.i
  %.8.i565.i.i = fadd contract <8 x double> %.6.i564.i.i, splat (double 0x3FA5F83FB7E8F47D)
  %.6.i566.i.i = fmul contract <8 x double> %.6.i561.i.i, %.8.i565.i.i
  %.8.i567.i.i = fadd contract <8 x double> %.6.i566.i.i, splat (double 0xBFB3462E8D8711AD)
  %.6.i568.i.i = fmul contract <8 x double> %.6.i561.i.i, %.8.i567.i.i
  %.8.i569.i.i = fadd contract <8 x double> %.6.i568.i.i, splat (double 0x3FBB47B06AC4D989)
  %.6.i570.i.i = fmul contract <8 x double> %.6.i561.i.i, %.8.i569.i.i
  %.8.i571.i.i = fadd contract <8 x double> %.6.i570.i.i, splat (double 0xBFC22FF8E008E644)
  %.6.i572.i.i = fmul contract <8 x double> %.6.i561.i.i, %.8.i571.i.i
  %.8.i573.i.i = fadd contract <8 x double> %.6.i572.i.i, splat (double 0x3FC9977C9B288755)
  %.6.i574.i.i = fmul contract <8 x double> %.6.i561.i.i, %.8.i573.i.i
  %.8.i575.i.i = fadd contract <8 x double> %.6.i574.i.i, splat (double 0xBFD5554D72204448)
  %.6.i576.i.i = fmul contract <8 x double> %.6.i561.i.i, %.8.i575.i.i
  %.8.i577.i.i = fadd contract <8 x double> %.6.i576.i.i, splat (double 1.000000e+00)
  %.8.i578.i.i = fmul contract <8 x double> %.6.i560.i.i, splat (double 2.000000e+00)
  %.6.i579.i.i = fmul contract <8 x double> %.8.i578.i.i, %.8.i577.i.i
  store <8 x double> %.6.i579.i.i, ptr %scevgep.i.i66, align 8, !noalias !27
  %lsr.iv.next590.i.i = add i64 %lsr.iv589.i.i, 64
  %lsr.iv.next2.i.i68 = add nsw i64 %lsr.iv1.i.i65, -1
  %.1872.i.i = icmp sgt i64 %lsr.iv1.i.i65, 5
  br i1 %.1872.i.i, label %B1368.if.i.i, label %_ZN17bnserve_inference13moving_kernel8_passing6_turnsB3v73B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedExx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i

_ZN17bnserve_inference13moving_kernel8_passing6_turnsB3v73B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedExx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i: ; preds = %B1368.if.i.i, %B1324.i.i
  br i1 %.146.i.i54, label %B1398.if.i, label %B1160.peel.i

B1160.peel.i:                                     ; preds = %_ZN17bnserve_inference13moving_kernel8_passing6_turnsB3v73B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedExx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i
  %.1610.peel.i = load <8 x double>, ptr %.733.i, align 8, !noalias !24
  %.1621.peel.i = load <8 x double>, ptr %sunkaddr8.i, align 8, !noalias !24
  %.1632.peel.i = load <8 x double>, ptr %.1125.i, align 8, !noalias !24
  %.6.i.i69 = fmul contract <8 x double> %.1621.peel.i, %.1632.peel.i
  %.1657.peel.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1610.peel.i, <8 x double> zeroinitializer, <8 x double> %.6.i.i69)
  %sunkaddr253.i = shl i64 %.1047.i, 3
  %sunkaddr254.i = getelementptr inbounds i8, ptr %126, i64 %sunkaddr253.i
  %.1668.peel.i = load <8 x double>, ptr %sunkaddr254.i, align 8, !noalias !24
  %.6.i118.i = fsub contract <8 x double> %.1668.peel.i, %.1657.peel.i
  store <8 x double> %.6.i118.i, ptr %.1059.i, align 8, !noalias !24
  br i1 %152, label %B1078.if.i, label %B1398.if.i

B1078.if.i:                                       ; preds = %B1160.peel.i, %B1078.if.i
  %lsr.iv.i71 = phi i64 [ %lsr.iv.next.i73, %B1078.if.i ], [ %131, %B1160.peel.i ]
  %lsr.iv239.i = phi i64 [ %lsr.iv.next240.i, %B1078.if.i ], [ 64, %B1160.peel.i ]
  %scevgep.i72 = getelementptr i8, ptr %.1125.i, i64 %lsr.iv239.i
  %scevgep241.i = getelementptr i8, ptr %scevgep.i72, i64 -8
  %.1587.i = load <8 x double>, ptr %scevgep241.i, align 8, !noalias !24
  %scevgep249.i = getelementptr i8, ptr %.733.i, i64 %lsr.iv239.i
  %.1610.i = load <8 x double>, ptr %scevgep249.i, align 8, !noalias !24
  %scevgep248.i = getelementptr i8, ptr %.858.i, i64 %lsr.iv239.i
  %.1621.i = load <8 x double>, ptr %scevgep248.i, align 8, !noalias !24
  %.1632.i = load <8 x double>, ptr %scevgep.i72, align 8, !noalias !24
  %.6.i119.i = fmul contract <8 x double> %.1621.i, %.1632.i
  %.1657.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1610.i, <8 x double> %.1587.i, <8 x double> %.6.i119.i)
  %scevgep247.i = getelementptr i8, ptr %lsr.iv245.i, i64 %lsr.iv239.i
  %.1668.i = load <8 x double>, ptr %scevgep247.i, align 8, !noalias !24
  %.6.i120.i = fsub contract <8 x double> %.1668.i, %.1657.i
  %scevgep244.i = getelementptr i8, ptr %lsr.iv242.i, i64 %lsr.iv239.i
  store <8 x double> %.6.i120.i, ptr %scevgep244.i, align 8, !noalias !24
  %lsr.iv.next240.i = add nuw i64 %lsr.iv239.i, 64
  %lsr.iv.next.i73 = add nsw i64 %lsr.iv.i71, -1
  %.1532.i = icmp sgt i64 %lsr.iv.i71, 5
  br i1 %.1532.i, label %B1078.if.i, label %B1398.if.i, !llvm.loop !32

B1398.if.i:                                       ; preds = %B1078.if.i, %B1160.peel.i, %_ZN17bnserve_inference13moving_kernel8_passing6_turnsB3v73B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedExx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i
  %sunkaddr256.i = shl i64 %.1047.i, 3
  %sunkaddr257.i = getelementptr i8, ptr %126, i64 %sunkaddr256.i
  %sunkaddr258.i = getelementptr i8, ptr %sunkaddr257.i, i64 8
  %.1857.i = load double, ptr %sunkaddr258.i, align 8, !noalias !24
  %.1887.i = load double, ptr %sunkaddr10.i, align 8, !noalias !24
  %.1918.i = load double, ptr %.1125.i, align 8, !noalias !24
  %.1919.i = fmul contract double %.1887.i, %.1918.i
  %.1949.i = load double, ptr %sunkaddr11.i, align 8, !noalias !24
  %.1979.i = load double, ptr %sunkaddr12.i, align 8, !noalias !24
  %.1980.i = fmul contract double %.1949.i, %.1979.i
  %.1981.i = fadd contract double %.1919.i, %.1980.i
  %.1982.i = fsub contract double %.1857.i, %.1981.i
  %159 = getelementptr i8, ptr %.1059.i, i64 8
  store double %.1982.i, ptr %159, align 8, !noalias !24
  %sunkaddr266.i = getelementptr i8, ptr %sunkaddr257.i, i64 16
  %.1857.1.i = load double, ptr %sunkaddr266.i, align 8, !noalias !24
  %.1887.1.i = load double, ptr %sunkaddr15.i, align 8, !noalias !24
  %.1918.1.i = load double, ptr %sunkaddr12.i, align 8, !noalias !24
  %.1919.1.i = fmul contract double %.1887.1.i, %.1918.1.i
  %.1949.1.i = load double, ptr %sunkaddr16.i, align 8, !noalias !24
  %.1979.1.i = load double, ptr %sunkaddr17.i, align 8, !noalias !24
  %.1980.1.i = fmul contract double %.1949.1.i, %.1979.1.i
  %.1981.1.i = fadd contract double %.1919.1.i, %.1980.1.i
  %.1982.1.i = fsub contract double %.1857.1.i, %.1981.1.i
  %160 = getelementptr i8, ptr %.1059.i, i64 16
  store double %.1982.1.i, ptr %160, align 8, !noalias !24
  %sunkaddr274.i = getelementptr i8, ptr %sunkaddr257.i, i64 24
  %.1857.2.i = load double, ptr %sunkaddr274.i, align 8, !noalias !24
  %.1887.2.i = load double, ptr %sunkaddr23.i, align 8, !noalias !24
  %.1918.2.i = load double, ptr %sunkaddr17.i, align 8, !noalias !24
  %.1919.2.i = fmul contract double %.1887.2.i, %.1918.2.i
  %.1949.2.i = load double, ptr %sunkaddr27.i56, align 8, !noalias !24
  %.1979.2.i = load double, ptr %sunkaddr31.i, align 8, !noalias !24
  %.1980.2.i = fmul contract double %.1949.2.i, %.1979.2.i
  %.1981.2.i = fadd contract double %.1919.2.i, %.1980.2.i
  %.1982.2.i = fsub contract double %.1857.2.i, %.1981.2.i
  %161 = getelementptr i8, ptr %.1059.i, i64 24
  store double %.1982.2.i, ptr %161, align 8, !noalias !24
  %sunkaddr282.i = getelementptr i8, ptr %sunkaddr257.i, i64 32
  %.1857.3.i = load double, ptr %sunkaddr282.i, align 8, !noalias !24
  %.1887.3.i = load double, ptr %sunkaddr39.i, align 8, !noalias !24
  %.1918.3.i = load double, ptr %sunkaddr31.i, align 8, !noalias !24
  %.1919.3.i = fmul contract double %.1887.3.i, %.1918.3.i
  %.1949.3.i = load double, ptr %sunkaddr40.i, align 8, !noalias !24
  %.1979.3.i = load double, ptr %sunkaddr41.i, align 8, !noalias !24
  %.1980.3.i = fmul contract double %.1949.3.i, %.1979.3.i
  %.1981.3.i = fadd contract double %.1919.3.i, %.1980.3.i
  %.1982.3.i = fsub contract double %.1857.3.i, %.1981.3.i
  %162 = getelementptr i8, ptr %.1059.i, i64 32
  store double %.1982.3.i, ptr %162, align 8, !noalias !24
  %sunkaddr290.i = getelementptr i8, ptr %sunkaddr257.i, i64 40
  %.1857.4.i = load double, ptr %sunkaddr290.i, align 8, !noalias !24
  %.1887.4.i = load double, ptr %sunkaddr43.i, align 8, !noalias !24
  %.1918.4.i = load double, ptr %sunkaddr41.i, align 8, !noalias !24
  %.1919.4.i = fmul contract double %.1887.4.i, %.1918.4.i
  %.1949.4.i = load double, ptr %sunkaddr44.i, align 8, !noalias !24
  %.1979.4.i = load double, ptr %sunkaddr45.i, align 8, !noalias !24
  %.1980.4.i = fmul contract double %.1949.4.i, %.1979.4.i
  %.1981.4.i = fadd contract double %.1919.4.i, %.1980.4.i
  %.1982.4.i = fsub contract double %.1857.4.i, %.1981.4.i
  %163 = getelementptr i8, ptr %.1059.i, i64 40
  store double %.1982.4.i, ptr %163, align 8, !noalias !24
  %sunkaddr298.i = getelementptr i8, ptr %sunkaddr257.i, i64 48
  %.1857.5.i = load double, ptr %sunkaddr298.i, align 8, !noalias !24
  %.1887.5.i = load double, ptr %sunkaddr47.i, align 8, !noalias !24
  %.1918.5.i = load double, ptr %sunkaddr45.i, align 8, !noalias !24
  %.1919.5.i = fmul contract double %.1887.5.i, %.1918.5.i
  %.1949.5.i = load double, ptr %sunkaddr48.i, align 8, !noalias !24
  %.1979.5.i = load double, ptr %sunkaddr49.i, align 8, !noalias !24
  %.1980.5.i = fmul contract double %.1949.5.i, %.1979.5.i
  %.1981.5.i = fadd contract double %.1919.5.i, %.1980.5.i
  %.1982.5.i = fsub contract double %.1857.5.i, %.1981.5.i
  %164 = getelementptr i8, ptr %.1059.i, i64 48
  store double %.1982.5.i, ptr %164, align 8, !noalias !24
  %sunkaddr306.i = getelementptr i8, ptr %sunkaddr257.i, i64 56
  %.1857.6.i = load double, ptr %sunkaddr306.i, align 8, !noalias !24
  %.1887.6.i = load double, ptr %sunkaddr51.i, align 8, !noalias !24
  %.1918.6.i = load double, ptr %sunkaddr49.i, align 8, !noalias !24
  %.1919.6.i = fmul contract double %.1887.6.i, %.1918.6.i
  %.1949.6.i = load double, ptr %sunkaddr52.i, align 8, !noalias !24
  %.1979.6.i = load double, ptr %sunkaddr53.i, align 8, !noalias !24
  %.1980.6.i = fmul contract double %.1949.6.i, %.1979.6.i
  %.1981.6.i = fadd contract double %.1919.6.i, %.1980.6.i
  %.1982.6.i = fsub contract double %.1857.6.i, %.1981.6.i
  %165 = getelementptr i8, ptr %.1059.i, i64 56
  store double %.1982.6.i, ptr %165, align 8, !noalias !24
  %scevgep243.i = getelementptr i8, ptr %lsr.iv242.i, i64 %130
  %scevgep246.i = getelementptr i8, ptr %lsr.iv245.i, i64 %130
  %exitcond.not.i70 = icmp eq i64 %.1020.i, %.50.i
  br i1 %exitcond.not.i70, label %_ZN17bnserve_inference13moving_kernel8_passing12find_passingB3v57B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIxLi1E1C7mutable7alignedE.exit, label %B766.if.i59

_ZN17bnserve_inference13moving_kernel8_passing12find_passingB3v57B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIxLi1E1C7mutable7alignedE.exit: ; preds = %B1398.if.i, %B288.i, %_ZN17bnserve_inference14adjoint_kernel7_source6_placeB3v14B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit
  %.795.sroa.12.1 = inttoptr i64 %.232.i to ptr
  %.868 = load i64, ptr %sunkaddr117, align 8
  %.874 = mul nsw i64 %.870.reass, %.604928988
  %.875 = add nsw i64 %.868, %.874
  br i1 %.1014906.not, label %B1232, label %B896.if.preheader

B896.if.preheader:                                ; preds = %_ZN17bnserve_inference13moving_kernel8_passing12find_passingB3v57B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIxLi1E1C7mutable7alignedE.exit
  %.268.i.i192 = shl i64 %.604928988, 4
  %166 = inttoptr i64 %.875 to ptr
  br label %B896.if

B896.if:                                          ; preds = %B896.if.preheader, %_ZN17bnserve_inference14adjoint_kernel7_source11_block_backB4v557B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit
  %.1013884910 = phi i64 [ %.1023, %_ZN17bnserve_inference14adjoint_kernel7_source11_block_backB4v557B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit ], [ %.993, %B896.if.preheader ]
  %.1020890909 = phi i64 [ %.1027, %_ZN17bnserve_inference14adjoint_kernel7_source11_block_backB4v557B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit ], [ 0, %B896.if.preheader ]
  %.1023 = add nsw i64 %.1013884910, -1
  %.1027 = add i64 %.1020890909, 128
  %.1057 = sub nsw i64 %.187, %.1020890909
  %.13.i = tail call i64 @llvm.smin.i64(i64 %.1057, i64 128)
  call void @llvm.lifetime.start.p0(ptr nonnull %.1607.i)
  store ptr null, ptr %.1607.i, align 8, !noalias !34
  %.82.i = load i64, ptr %.106, align 8, !noalias !34
  %.112.i = load i64, ptr %.76, align 8, !noalias !34
  %.142.i = load i64, ptr %.143, align 8, !noalias !34
  %.179.i = load i64, ptr %.178.i, align 8, !noalias !34
  %.181.i = shl nsw i64 %.82.i, 4
  %.183.i = mul i64 %.181.i, %.604928988
  %.184.i = mul i64 %.183.i, %.142.i
  %.185.i = add nsw i64 %.184.i, %.179.i
  %.276.i = load i64, ptr %.275.i90, align 8, !noalias !34
  %.279.i = mul i64 %.82.i, %.229.i
  %.280.i = add nsw i64 %.276.i, %.279.i
  %.366.i91 = load i64, ptr %.365.i, align 8, !noalias !34
  %.370.i = add nsw i64 %.366.i91, %.183.i
  %.457.i = load i64, ptr %.456.i, align 8, !noalias !34
  %.754912.not.i = icmp slt i64 %.112.i, 1
  br i1 %.754912.not.i, label %B732.i, label %B582.if.lr.ph.i

B732.i:                                           ; preds = %B584.endif.endif.endif.i, %B896.if
  %.1112934.not.i = icmp slt i64 %.82.i, 1
  br i1 %.1112934.not.i, label %_ZN17bnserve_inference14adjoint_kernel7_source9_polariseB3v94B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit, label %B762.if.lr.ph.i

B762.if.lr.ph.i:                                  ; preds = %B732.i
  %.1272.i = sub nsw i64 %.142.i, %.1020890909
  %.13.i.i101 = tail call i64 @llvm.smin.i64(i64 %.1272.i, i64 range(i64 -9223372036854775808, 129) %.13.i)
  %.1545.i = shl nsw i64 %.13.i.i101, 1
  %.102.i.i102 = lshr exact i64 %.13.i, 3
  %.79.inv.i.i = icmp slt i64 %.1057, 1
  %167 = add nuw nsw i64 %.102.i.i102, 4
  %168 = inttoptr i64 %.457.i to ptr
  %169 = inttoptr i64 %.185.i to ptr
  %170 = inttoptr i64 %.370.i to ptr
  %171 = inttoptr i64 %.280.i to ptr
  br label %B762.if.i

B582.if.lr.ph.i:                                  ; preds = %B896.if
  %.626.i = sub i64 0, %.142.i
  %.543.i = load i64, ptr %.542.i, align 8, !noalias !34
  %.544.i = inttoptr i64 %.543.i to ptr
  %.619.i92 = getelementptr i8, ptr %.544.i, i64 8
  %.620.i = load double, ptr %.619.i92, align 8, !noalias !34
  %.387.i.i93 = lshr exact i64 %.13.i, 3
  %.366.inv.i.i = icmp slt i64 %.1057, 1
  %xtraiter.i.i94 = and i64 %.387.i.i93, 3
  %172 = shl nuw nsw i64 %xtraiter.i.i94, 6
  %.6.i.i.i95 = insertelement <8 x double> poison, double %.620.i, i64 0
  %.7.i.i.i96 = shufflevector <8 x double> %.6.i.i.i95, <8 x double> poison, <8 x i32> zeroinitializer
  %173 = add nsw i64 %.387.i.i93, -4
  %174 = lshr i64 %173, 2
  %175 = add nuw nsw i64 %174, 1
  %xtraiter.i = and i64 %175, 3
  %176 = shl i64 %.1020890909, 3
  %scevgep320.i = getelementptr i8, ptr %.795.sroa.12.1, i64 %176
  %177 = lshr i64 %.626.i, 3
  %178 = mul i64 %177, -64
  %179 = add nsw i64 %174, -3
  %180 = lshr i64 %179, 2
  %181 = add nuw nsw i64 %180, 1
  %xtraiter34.i = and i64 %181, 3
  %182 = sub nsw i64 0, %xtraiter.i
  %183 = and i64 %173, 12
  %184 = add nsw i64 %180, -3
  %185 = lshr i64 %184, 2
  %186 = add nuw nsw i64 %185, 1
  %187 = and i64 %186, 9223372036854775804
  %188 = trunc i64 %185 to i2
  %189 = add i2 %188, 1
  %190 = zext i2 %189 to i64
  %191 = sub nsw i64 0, %xtraiter34.i
  %192 = add nuw nsw i64 %.387.i.i93, 4
  %193 = icmp ult i64 %.13.i, 32
  %194 = icmp ult i64 %173, 12
  %195 = icmp ult i64 %179, 12
  %196 = icmp ult i64 %184, 12
  %197 = and i64 %186, 3
  %198 = icmp eq i64 %197, 0
  %199 = and i64 %179, 12
  %200 = icmp eq i64 %199, 12
  %201 = icmp eq i64 %183, 12
  %202 = icmp eq i64 %xtraiter.i.i94, 0
  br label %B582.if.i

B582.if.i:                                        ; preds = %B584.endif.endif.endif.i, %B582.if.lr.ph.i
  %lsr.iv321.i = phi ptr [ %scevgep320.i, %B582.if.lr.ph.i ], [ %scevgep322.i, %B584.endif.endif.endif.i ]
  %lsr.iv282.i = phi ptr [ %.432, %B582.if.lr.ph.i ], [ %scevgep283.i, %B584.endif.endif.endif.i ]
  %.760909913.i = phi i64 [ 0, %B582.if.lr.ph.i ], [ %.767.i, %B584.endif.endif.endif.i ]
  %.767.i = add nuw nsw i64 %.760909913.i, 1
  %.idx866.i = mul i64 %.760909913.i, 27648
  %203 = getelementptr i8, ptr %.432, i64 %.idx866.i
  %.974.i = load i64, ptr %sunkaddr.i97, align 8, !noalias !34
  br i1 %.366.inv.i.i, label %B584.endif.endif.endif.i, label %B214.if.preheader.i.i

B214.if.preheader.i.i:                            ; preds = %B582.if.i
  br i1 %193, label %B214.if.epil.preheader.i.i, label %B214.if.i.preheader.i

B214.if.i.preheader.i:                            ; preds = %B214.if.preheader.i.i
  br i1 %194, label %B214.if.i.epil.i.preheader, label %B214.if.i.preheader32.i

B214.if.i.preheader32.i:                          ; preds = %B214.if.i.preheader.i
  br i1 %195, label %B214.if.i.epil35.i.preheader, label %B214.if.i.preheader33.i

B214.if.i.preheader33.i:                          ; preds = %B214.if.i.preheader32.i
  br i1 %196, label %B214.if.i.epil36.i.preheader, label %B214.if.i.i

B340.unr-lcssa.i.unr-lcssa.unr-lcssa.unr-lcssa.i: ; preds = %B214.if.i.i
  br i1 %198, label %B340.unr-lcssa.i.unr-lcssa.unr-lcssa.i, label %B214.if.i.epil36.i.preheader

B214.if.i.epil36.i.preheader:                     ; preds = %B340.unr-lcssa.i.unr-lcssa.unr-lcssa.unr-lcssa.i, %B214.if.i.preheader33.i
  %.414647649.i.epil37.i.ph = phi i64 [ 0, %B214.if.i.preheader33.i ], [ %.421.3238.i.3.3.3.i, %B340.unr-lcssa.i.unr-lcssa.unr-lcssa.unr-lcssa.i ]
  br label %B214.if.i.epil36.i

B214.if.i.epil36.i:                               ; preds = %B214.if.i.epil36.i.preheader, %B214.if.i.epil36.i
  %lsr.iv64.i = phi i64 [ %lsr.iv.next65.i, %B214.if.i.epil36.i ], [ %190, %B214.if.i.epil36.i.preheader ]
  %.414647649.i.epil37.i = phi i64 [ %.421.3238.i.3.3.epil.i, %B214.if.i.epil36.i ], [ %.414647649.i.epil37.i.ph, %B214.if.i.epil36.i.preheader ]
  %sunkaddr336.i.epil38.i = shl i64 %.414647649.i.epil37.i, 3
  %scevgep67.epil.i = getelementptr i8, ptr %lsr.iv282.i, i64 %sunkaddr336.i.epil38.i
  %scevgep68.epil.i = getelementptr i8, ptr %scevgep67.epil.i, i64 14336
  %.421.3238.i.3.3.epil.i = add i64 %.414647649.i.epil37.i, 512
  tail call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(5120) %scevgep68.epil.i, i8 0, i64 5120, i1 false), !noalias !34
  %lsr.iv.next65.i = add nsw i64 %lsr.iv64.i, -1
  %epil.iter.cmp.not.i = icmp eq i64 %lsr.iv.next65.i, 0
  br i1 %epil.iter.cmp.not.i, label %B340.unr-lcssa.i.unr-lcssa.unr-lcssa.i, label %B214.if.i.epil36.i, !llvm.loop !37

B340.unr-lcssa.i.unr-lcssa.unr-lcssa.i:           ; preds = %B214.if.i.epil36.i, %B340.unr-lcssa.i.unr-lcssa.unr-lcssa.unr-lcssa.i
  %.421.3238.i.3.3.lcssa.i = phi i64 [ %.421.3238.i.3.3.3.i, %B340.unr-lcssa.i.unr-lcssa.unr-lcssa.unr-lcssa.i ], [ %.421.3238.i.3.3.epil.i, %B214.if.i.epil36.i ]
  br i1 %200, label %B340.unr-lcssa.i.unr-lcssa.i, label %B214.if.i.epil35.i.preheader

B214.if.i.epil35.i.preheader:                     ; preds = %B340.unr-lcssa.i.unr-lcssa.unr-lcssa.i, %B214.if.i.preheader32.i
  %.414647649.i.epil36.i.ph = phi i64 [ 0, %B214.if.i.preheader32.i ], [ %.421.3238.i.3.3.lcssa.i, %B340.unr-lcssa.i.unr-lcssa.unr-lcssa.i ]
  br label %B214.if.i.epil35.i

B214.if.i.epil35.i:                               ; preds = %B214.if.i.epil35.i.preheader, %B214.if.i.epil35.i
  %lsr.iv66.i = phi i64 [ %math.i, %B214.if.i.epil35.i ], [ %191, %B214.if.i.epil35.i.preheader ]
  %.414647649.i.epil36.i = phi i64 [ %.421.3238.i.3.epil.i, %B214.if.i.epil35.i ], [ %.414647649.i.epil36.i.ph, %B214.if.i.epil35.i.preheader ]
  %sunkaddr336.i.epil37.i = shl i64 %.414647649.i.epil36.i, 3
  %scevgep70.i = getelementptr i8, ptr %lsr.iv282.i, i64 %sunkaddr336.i.epil37.i
  %scevgep71.i = getelementptr i8, ptr %scevgep70.i, i64 14336
  %.421.3238.i.3.epil.i = add i64 %.414647649.i.epil36.i, 128
  tail call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(2048) %scevgep71.i, i8 0, i64 2048, i1 false), !noalias !34
  %204 = tail call { i64, i1 } @llvm.uadd.with.overflow.i64(i64 %lsr.iv66.i, i64 1)
  %math.i = extractvalue { i64, i1 } %204, 0
  %ov93.i = extractvalue { i64, i1 } %204, 1
  br i1 %ov93.i, label %B340.unr-lcssa.i.unr-lcssa.i, label %B214.if.i.epil35.i, !llvm.loop !38

B340.unr-lcssa.i.unr-lcssa.i:                     ; preds = %B214.if.i.epil35.i, %B340.unr-lcssa.i.unr-lcssa.unr-lcssa.i
  %.421.3238.i.3.lcssa.i = phi i64 [ %.421.3238.i.3.3.lcssa.i, %B340.unr-lcssa.i.unr-lcssa.unr-lcssa.i ], [ %.421.3238.i.3.epil.i, %B214.if.i.epil35.i ]
  br i1 %201, label %B340.unr-lcssa.i.i, label %B214.if.i.epil.i.preheader

B214.if.i.epil.i.preheader:                       ; preds = %B340.unr-lcssa.i.unr-lcssa.i, %B214.if.i.preheader.i
  %.414647649.i.epil.i.ph = phi i64 [ 0, %B214.if.i.preheader.i ], [ %.421.3238.i.3.lcssa.i, %B340.unr-lcssa.i.unr-lcssa.i ]
  br label %B214.if.i.epil.i

B214.if.i.epil.i:                                 ; preds = %B214.if.i.epil.i.preheader, %B214.if.i.epil.i
  %lsr.iv68.i = phi i64 [ %lsr.iv.next69.i, %B214.if.i.epil.i ], [ %182, %B214.if.i.epil.i.preheader ]
  %.414647649.i.epil.i = phi i64 [ %.421.3238.i.epil.i, %B214.if.i.epil.i ], [ %.414647649.i.epil.i.ph, %B214.if.i.epil.i.preheader ]
  %sunkaddr336.i.epil.i = shl i64 %.414647649.i.epil.i, 3
  %.421.3238.i.epil.i = add i64 %.414647649.i.epil.i, 32
  %scevgep72.i = getelementptr i8, ptr %lsr.iv282.i, i64 %sunkaddr336.i.epil.i
  %scevgep73.i = getelementptr i8, ptr %scevgep72.i, i64 15360
  %scevgep77.i = getelementptr i8, ptr %scevgep72.i, i64 14336
  tail call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(256) %scevgep77.i, i8 0, i64 256, i1 false), !noalias !39
  tail call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(256) %scevgep73.i, i8 0, i64 256, i1 false), !noalias !39
  %ov.i = icmp eq i64 %lsr.iv68.i, -1
  %lsr.iv.next69.i = add i64 %lsr.iv68.i, 1
  br i1 %ov.i, label %B340.unr-lcssa.i.i, label %B214.if.i.epil.i, !llvm.loop !42

B340.unr-lcssa.i.i:                               ; preds = %B214.if.i.epil.i, %B340.unr-lcssa.i.unr-lcssa.i
  %.421.3238.i.lcssa.i = phi i64 [ %.421.3238.i.3.lcssa.i, %B340.unr-lcssa.i.unr-lcssa.i ], [ %.421.3238.i.epil.i, %B214.if.i.epil.i ]
  br i1 %202, label %B340.i.i, label %B214.if.epil.preheader.i.i

B214.if.epil.preheader.i.i:                       ; preds = %B340.unr-lcssa.i.i, %B214.if.preheader.i.i
  %.414647649.epil.init.i.i = phi i64 [ 0, %B214.if.preheader.i.i ], [ %.421.3238.i.lcssa.i, %B340.unr-lcssa.i.i ]
  %205 = shl i64 %.414647649.epil.init.i.i, 3
  %scevgep284.i = getelementptr i8, ptr %lsr.iv282.i, i64 %205
  br label %B214.if.epil.i.i

B214.if.epil.i.i:                                 ; preds = %B214.if.epil.i.i, %B214.if.epil.preheader.i.i
  %lsr.iv288.i.i = phi i64 [ %lsr.iv.next289.i.i, %B214.if.epil.i.i ], [ 0, %B214.if.epil.preheader.i.i ]
  %scevgep285.i = getelementptr i8, ptr %scevgep284.i, i64 %lsr.iv288.i.i
  %scevgep286.i = getelementptr i8, ptr %scevgep285.i, i64 15360
  %scevgep287.i = getelementptr i8, ptr %scevgep285.i, i64 14336
  store <8 x double> zeroinitializer, ptr %scevgep287.i, align 8, !noalias !39
  store <8 x double> zeroinitializer, ptr %scevgep286.i, align 8, !noalias !39
  %lsr.iv.next289.i.i = add nuw nsw i64 %lsr.iv288.i.i, 64
  %epil.iter.cmp.not.i.i98 = icmp eq i64 %172, %lsr.iv.next289.i.i
  br i1 %epil.iter.cmp.not.i.i98, label %B340.i.i, label %B214.if.epil.i.i, !llvm.loop !43

B340.i.i:                                         ; preds = %B214.if.epil.i.i, %B340.unr-lcssa.i.i
  %.247.1.i.i = getelementptr i8, ptr %203, i64 17408
  br label %B214.if.1.i.i

B214.if.1.i.i:                                    ; preds = %B214.if.1.i.i, %B340.i.i
  %lsr.iv74.i = phi i64 [ %lsr.iv.next75.i, %B214.if.1.i.i ], [ %192, %B340.i.i ]
  %lsr.iv284.i.i = phi ptr [ %scevgep285.i.i, %B214.if.1.i.i ], [ %.247.1.i.i, %B340.i.i ]
  %scevgep286.i.i = getelementptr i8, ptr %lsr.iv284.i.i, i64 -1024
  store <8 x double> zeroinitializer, ptr %scevgep286.i.i, align 8, !noalias !39
  store <8 x double> zeroinitializer, ptr %lsr.iv284.i.i, align 8, !noalias !39
  %scevgep285.i.i = getelementptr i8, ptr %lsr.iv284.i.i, i64 64
  %lsr.iv.next75.i = add nsw i64 %lsr.iv74.i, -1
  %.408.1.i.i = icmp sgt i64 %lsr.iv74.i, 5
  br i1 %.408.1.i.i, label %B214.if.1.i.i, label %B214.if.2.preheader.i.i

B214.if.2.preheader.i.i:                          ; preds = %B214.if.1.i.i
  br i1 %193, label %B214.if.2.epil.preheader.i.i, label %B214.if.2.i.preheader.i

B214.if.2.i.preheader.i:                          ; preds = %B214.if.2.preheader.i.i
  br i1 %194, label %B214.if.2.i.epil.i.preheader, label %B214.if.2.i.preheader31.i

B214.if.2.i.preheader31.i:                        ; preds = %B214.if.2.i.preheader.i
  br i1 %195, label %B214.if.2.i.epil44.i.preheader, label %B214.if.2.i.preheader32.i

B214.if.2.i.preheader32.i:                        ; preds = %B214.if.2.i.preheader31.i
  br i1 %196, label %B214.if.2.i.epil43.i.preheader, label %B214.if.2.i.i

B214.if.2.i.i:                                    ; preds = %B214.if.2.i.preheader32.i, %B214.if.2.i.i
  %lsr.iv76.i = phi i64 [ %lsr.iv.next77.i, %B214.if.2.i.i ], [ %187, %B214.if.2.i.preheader32.i ]
  %.414647649.2.i.i = phi i64 [ %.421.2.3.i.3.3.3.i, %B214.if.2.i.i ], [ 0, %B214.if.2.i.preheader32.i ]
  %sunkaddr.i.i99 = shl i64 %.414647649.2.i.i, 3
  %scevgep304.i = getelementptr i8, ptr %lsr.iv282.i, i64 %sunkaddr.i.i99
  %scevgep305.i = getelementptr i8, ptr %scevgep304.i, i64 36864
  %.421.2.3.i.3.3.3.i = add i64 %.414647649.2.i.i, 2048
  %lsr.iv.next77.i = add i64 %lsr.iv76.i, -4
  %niter53.ncmp.3.i = icmp eq i64 %lsr.iv.next77.i, 0
  tail call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(17408) %scevgep305.i, i8 0, i64 17408, i1 false), !noalias !34
  br i1 %niter53.ncmp.3.i, label %B340.2.unr-lcssa.i.unr-lcssa.unr-lcssa.unr-lcssa.i, label %B214.if.2.i.i

B340.2.unr-lcssa.i.unr-lcssa.unr-lcssa.unr-lcssa.i: ; preds = %B214.if.2.i.i
  br i1 %198, label %B340.2.unr-lcssa.i.unr-lcssa.unr-lcssa.i, label %B214.if.2.i.epil43.i.preheader

B214.if.2.i.epil43.i.preheader:                   ; preds = %B340.2.unr-lcssa.i.unr-lcssa.unr-lcssa.unr-lcssa.i, %B214.if.2.i.preheader32.i
  %.414647649.2.i.epil44.i.ph = phi i64 [ 0, %B214.if.2.i.preheader32.i ], [ %.421.2.3.i.3.3.3.i, %B340.2.unr-lcssa.i.unr-lcssa.unr-lcssa.unr-lcssa.i ]
  br label %B214.if.2.i.epil43.i

B214.if.2.i.epil43.i:                             ; preds = %B214.if.2.i.epil43.i.preheader, %B214.if.2.i.epil43.i
  %lsr.iv78.i = phi i64 [ %lsr.iv.next79.i, %B214.if.2.i.epil43.i ], [ %190, %B214.if.2.i.epil43.i.preheader ]
  %.414647649.2.i.epil44.i = phi i64 [ %.421.2.3.i.3.3.epil.i, %B214.if.2.i.epil43.i ], [ %.414647649.2.i.epil44.i.ph, %B214.if.2.i.epil43.i.preheader ]
  %sunkaddr.i.epil45.i = shl i64 %.414647649.2.i.epil44.i, 3
  %scevgep304.epil46.i = getelementptr i8, ptr %lsr.iv282.i, i64 %sunkaddr.i.epil45.i
  %scevgep305.epil47.i = getelementptr i8, ptr %scevgep304.epil46.i, i64 36864
  %.421.2.3.i.3.3.epil.i = add i64 %.414647649.2.i.epil44.i, 512
  tail call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(5120) %scevgep305.epil47.i, i8 0, i64 5120, i1 false), !noalias !34
  %lsr.iv.next79.i = add nsw i64 %lsr.iv78.i, -1
  %epil.iter48.cmp.not.i = icmp eq i64 %lsr.iv.next79.i, 0
  br i1 %epil.iter48.cmp.not.i, label %B340.2.unr-lcssa.i.unr-lcssa.unr-lcssa.i, label %B214.if.2.i.epil43.i, !llvm.loop !44

B340.2.unr-lcssa.i.unr-lcssa.unr-lcssa.i:         ; preds = %B214.if.2.i.epil43.i, %B340.2.unr-lcssa.i.unr-lcssa.unr-lcssa.unr-lcssa.i
  %.421.2.3.i.3.3.lcssa.i = phi i64 [ %.421.2.3.i.3.3.3.i, %B340.2.unr-lcssa.i.unr-lcssa.unr-lcssa.unr-lcssa.i ], [ %.421.2.3.i.3.3.epil.i, %B214.if.2.i.epil43.i ]
  br i1 %200, label %B340.2.unr-lcssa.i.unr-lcssa.i, label %B214.if.2.i.epil44.i.preheader

B214.if.2.i.epil44.i.preheader:                   ; preds = %B340.2.unr-lcssa.i.unr-lcssa.unr-lcssa.i, %B214.if.2.i.preheader31.i
  %.414647649.2.i.epil45.i.ph = phi i64 [ 0, %B214.if.2.i.preheader31.i ], [ %.421.2.3.i.3.3.lcssa.i, %B340.2.unr-lcssa.i.unr-lcssa.unr-lcssa.i ]
  br label %B214.if.2.i.epil44.i

B214.if.2.i.epil44.i:                             ; preds = %B214.if.2.i.epil44.i.preheader, %B214.if.2.i.epil44.i
  %lsr.iv80.i = phi i64 [ %math94.i, %B214.if.2.i.epil44.i ], [ %191, %B214.if.2.i.epil44.i.preheader ]
  %.414647649.2.i.epil45.i = phi i64 [ %.421.2.3.i.3.epil.i, %B214.if.2.i.epil44.i ], [ %.414647649.2.i.epil45.i.ph, %B214.if.2.i.epil44.i.preheader ]
  %sunkaddr.i.epil46.i = shl i64 %.414647649.2.i.epil45.i, 3
  %scevgep304.epil.i = getelementptr i8, ptr %lsr.iv282.i, i64 %sunkaddr.i.epil46.i
  %scevgep305.epil.i = getelementptr i8, ptr %scevgep304.epil.i, i64 36864
  %.421.2.3.i.3.epil.i = add i64 %.414647649.2.i.epil45.i, 128
  tail call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(2048) %scevgep305.epil.i, i8 0, i64 2048, i1 false), !noalias !34
  %206 = tail call { i64, i1 } @llvm.uadd.with.overflow.i64(i64 %lsr.iv80.i, i64 1)
  %math94.i = extractvalue { i64, i1 } %206, 0
  %ov95.i = extractvalue { i64, i1 } %206, 1
  br i1 %ov95.i, label %B340.2.unr-lcssa.i.unr-lcssa.i, label %B214.if.2.i.epil44.i, !llvm.loop !45

B340.2.unr-lcssa.i.unr-lcssa.i:                   ; preds = %B214.if.2.i.epil44.i, %B340.2.unr-lcssa.i.unr-lcssa.unr-lcssa.i
  %.421.2.3.i.3.lcssa.i = phi i64 [ %.421.2.3.i.3.3.lcssa.i, %B340.2.unr-lcssa.i.unr-lcssa.unr-lcssa.i ], [ %.421.2.3.i.3.epil.i, %B214.if.2.i.epil44.i ]
  br i1 %201, label %B340.2.unr-lcssa.i.i, label %B214.if.2.i.epil.i.preheader

B214.if.2.i.epil.i.preheader:                     ; preds = %B340.2.unr-lcssa.i.unr-lcssa.i, %B214.if.2.i.preheader.i
  %.414647649.2.i.epil.i.ph = phi i64 [ 0, %B214.if.2.i.preheader.i ], [ %.421.2.3.i.3.lcssa.i, %B340.2.unr-lcssa.i.unr-lcssa.i ]
  br label %B214.if.2.i.epil.i

B214.if.2.i.epil.i:                               ; preds = %B214.if.2.i.epil.i.preheader, %B214.if.2.i.epil.i
  %lsr.iv82.i = phi i64 [ %lsr.iv.next83.i, %B214.if.2.i.epil.i ], [ %182, %B214.if.2.i.epil.i.preheader ]
  %.414647649.2.i.epil.i = phi i64 [ %.421.2.3.i.epil.i, %B214.if.2.i.epil.i ], [ %.414647649.2.i.epil.i.ph, %B214.if.2.i.epil.i.preheader ]
  %sunkaddr.i.epil.i = shl i64 %.414647649.2.i.epil.i, 3
  %scevgep310.i = getelementptr i8, ptr %lsr.iv282.i, i64 %sunkaddr.i.epil.i
  %scevgep311.i = getelementptr i8, ptr %scevgep310.i, i64 36864
  %.421.2.3.i.epil.i = add i64 %.414647649.2.i.epil.i, 32
  %scevgep313.i = getelementptr i8, ptr %scevgep310.i, i64 37888
  tail call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(256) %scevgep311.i, i8 0, i64 256, i1 false), !noalias !39
  tail call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(256) %scevgep313.i, i8 0, i64 256, i1 false), !noalias !39
  %ov96.i = icmp eq i64 %lsr.iv82.i, -1
  %lsr.iv.next83.i = add i64 %lsr.iv82.i, 1
  br i1 %ov96.i, label %B340.2.unr-lcssa.i.i, label %B214.if.2.i.epil.i, !llvm.loop !46

B340.2.unr-lcssa.i.i:                             ; preds = %B214.if.2.i.epil.i, %B340.2.unr-lcssa.i.unr-lcssa.i
  %.421.2.3.i.lcssa.i = phi i64 [ %.421.2.3.i.3.lcssa.i, %B340.2.unr-lcssa.i.unr-lcssa.i ], [ %.421.2.3.i.epil.i, %B214.if.2.i.epil.i ]
  br i1 %202, label %B340.2.i.i, label %B214.if.2.epil.preheader.i.i

B214.if.2.epil.preheader.i.i:                     ; preds = %B340.2.unr-lcssa.i.i, %B214.if.2.preheader.i.i
  %.414647649.2.epil.init.i.i = phi i64 [ 0, %B214.if.2.preheader.i.i ], [ %.421.2.3.i.lcssa.i, %B340.2.unr-lcssa.i.i ]
  %207 = shl i64 %.414647649.2.epil.init.i.i, 3
  %scevgep314.i = getelementptr i8, ptr %lsr.iv282.i, i64 %207
  br label %B214.if.2.epil.i.i

B214.if.2.epil.i.i:                               ; preds = %B214.if.2.epil.i.i, %B214.if.2.epil.preheader.i.i
  %lsr.iv262.i.i = phi i64 [ %lsr.iv.next263.i.i, %B214.if.2.epil.i.i ], [ 0, %B214.if.2.epil.preheader.i.i ]
  %scevgep315.i = getelementptr i8, ptr %scevgep314.i, i64 %lsr.iv262.i.i
  %scevgep316.i = getelementptr i8, ptr %scevgep315.i, i64 37888
  %scevgep317.i = getelementptr i8, ptr %scevgep315.i, i64 36864
  store <8 x double> zeroinitializer, ptr %scevgep317.i, align 8, !noalias !39
  store <8 x double> zeroinitializer, ptr %scevgep316.i, align 8, !noalias !39
  %lsr.iv.next263.i.i = add nuw nsw i64 %lsr.iv262.i.i, 64
  %epil.iter244.cmp.not.i.i = icmp eq i64 %172, %lsr.iv.next263.i.i
  br i1 %epil.iter244.cmp.not.i.i, label %B340.2.i.i, label %B214.if.2.epil.i.i, !llvm.loop !47

B340.2.i.i:                                       ; preds = %B214.if.2.epil.i.i, %B340.2.unr-lcssa.i.i
  %.247.3.i.i = getelementptr i8, ptr %203, i64 39936
  br label %B214.if.3.i.i

B214.if.3.i.i:                                    ; preds = %B214.if.3.i.i, %B340.2.i.i
  %lsr.iv84.i = phi i64 [ %lsr.iv.next85.i, %B214.if.3.i.i ], [ %192, %B340.2.i.i ]
  %lsr.iv258.i.i = phi ptr [ %scevgep259.i.i, %B214.if.3.i.i ], [ %.247.3.i.i, %B340.2.i.i ]
  %scevgep260.i.i = getelementptr i8, ptr %lsr.iv258.i.i, i64 -1024
  store <8 x double> zeroinitializer, ptr %scevgep260.i.i, align 8, !noalias !39
  store <8 x double> zeroinitializer, ptr %lsr.iv258.i.i, align 8, !noalias !39
  %scevgep259.i.i = getelementptr i8, ptr %lsr.iv258.i.i, i64 64
  %lsr.iv.next85.i = add nsw i64 %lsr.iv84.i, -1
  %.408.3.i.i = icmp sgt i64 %lsr.iv84.i, 5
  br i1 %.408.3.i.i, label %B214.if.3.i.i, label %B548.if.i.preheader.i

B548.if.i.preheader.i:                            ; preds = %B214.if.3.i.i
  %208 = icmp eq i64 %.974.i, 1
  br label %B548.if.i.i

B624.i.i:                                         ; preds = %B548.if.i.i
  %scevgep325.i = getelementptr i8, ptr %lsr.iv321.i, i64 %lsr.iv323.i
  %scevgep326.i = getelementptr i8, ptr %scevgep325.i, i64 -40960
  %.926.i.i120 = load <8 x double>, ptr %scevgep326.i, align 8, !noalias !39
  %.8.i.i.i121 = fmul contract <8 x double> %.7.i.i.i96, %.926.i.i120
  %.956.i.i122 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i.i.i121, <8 x double> splat (double 0x3FE45F306DC9C883), <8 x double> splat (double 0x4338000000000000))
  %.8.i160.i.i = fadd contract <8 x double> %.956.i.i122, splat (double 0xC338000000000000)
  %.997.i.i123 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i160.i.i, <8 x double> splat (double 0xBFF921FB54442D18), <8 x double> %.8.i.i.i121)
  %.1014.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i160.i.i, <8 x double> splat (double 0xBC91A62633145C07), <8 x double> %.997.i.i123)
  %.6.i161.i.i = fmul contract <8 x double> %.1014.i.i, %.1014.i.i
  %.6.i162.i.i = fmul contract <8 x double> %.1014.i.i, %.6.i161.i.i
  %.1043.i.i124 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i161.i.i, <8 x double> splat (double 0xBD6AE7F3E733B81F), <8 x double> splat (double 0x3DE6124613A86D09))
  %.1046.i.i125 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i161.i.i, <8 x double> %.1043.i.i124, <8 x double> splat (double 0xBE5AE64567F544E4))
  %.1049.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i161.i.i, <8 x double> %.1046.i.i125, <8 x double> splat (double 0x3EC71DE3A556C734))
  %.1052.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i161.i.i, <8 x double> %.1049.i.i, <8 x double> splat (double 0xBF2A01A01A01A01A))
  %.1055.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i161.i.i, <8 x double> %.1052.i.i, <8 x double> splat (double 0x3F81111111111111))
  %.1058.i.i126 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i161.i.i, <8 x double> %.1055.i.i, <8 x double> splat (double 0xBFC5555555555555))
  %.1083.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i162.i.i, <8 x double> %.1058.i.i126, <8 x double> %.1014.i.i)
  %.1088.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i161.i.i, <8 x double> splat (double 0x3D2AE7F3E733B81F), <8 x double> splat (double 0xBDA93974A8C07C9D))
  %.1091.i.i127 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i161.i.i, <8 x double> %.1088.i.i, <8 x double> splat (double 0x3E21EED8EFF8D898))
  %.1094.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i161.i.i, <8 x double> %.1091.i.i127, <8 x double> splat (double 0xBE927E4FB7789F5C))
  %.1097.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i161.i.i, <8 x double> %.1094.i.i, <8 x double> splat (double 0x3EFA01A01A01A01A))
  %.1100.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i161.i.i, <8 x double> %.1097.i.i, <8 x double> splat (double 0xBF56C16C16C16C17))
  %.1103.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i161.i.i, <8 x double> %.1100.i.i, <8 x double> splat (double 0x3FA5555555555555))
  %.1106.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i161.i.i, <8 x double> %.1103.i.i, <8 x double> splat (double -5.000000e-01))
  %.1109.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i161.i.i, <8 x double> %.1106.i.i, <8 x double> splat (double 1.000000e+00))
  %.1110.i.i = bitcast <8 x double> %.956.i.i122 to <8 x i64>
  %.1111.i.i = bitcast <8 x double> %.1083.i.i to <8 x i64>
  %.1112.i.i = bitcast <8 x double> %.1109.i.i to <8 x i64>
  %.6.i163.i.i = xor <8 x i64> %.1112.i.i, %.1111.i.i
  %.8.i164.i.i = and <8 x i64> %.1110.i.i, splat (i64 1)
  %209 = icmp eq <8 x i64> %.8.i164.i.i, zeroinitializer
  %.6.i166.i.i = select <8 x i1> %209, <8 x i64> zeroinitializer, <8 x i64> %.6.i163.i.i
  %.8.i167.i.i = shl <8 x i64> %.1110.i.i, splat (i64 62)
  %.8.i168.i.i = and <8 x i64> %.8.i167.i.i, splat (i64 -9223372036854775808)
  %.8.i170.i.i = add <8 x i64> %.8.i167.i.i, splat (i64 4611686018427387904)
  %.8.i171.i.i = and <8 x i64> %.8.i170.i.i, splat (i64 -9223372036854775808)
  %210 = xor <8 x i64> %.8.i168.i.i, %.1111.i.i
  %.6.i173.i.i = xor <8 x i64> %210, %.6.i166.i.i
  %211 = bitcast <8 x i64> %.6.i173.i.i to <8 x double>
  %212 = xor <8 x i64> %.8.i171.i.i, %.1112.i.i
  %.6.i175.i.i = xor <8 x i64> %212, %.6.i166.i.i
  %213 = bitcast <8 x i64> %.6.i175.i.i to <8 x double>
  br label %B746.i.i

B746.i.i:                                         ; preds = %B548.if.i.i, %B624.i.i
  %"$phi746.1.2.sroa.8.1.i.i" = phi <8 x double> [ %213, %B624.i.i ], [ splat (double 1.000000e+00), %B548.if.i.i ]
  %"$phi746.1.2.sroa.0.1.i.i" = phi <8 x double> [ %211, %B624.i.i ], [ zeroinitializer, %B548.if.i.i ]
  %scevgep92.i = getelementptr i8, ptr %scevgep331.i, i64 -22528
  store <8 x double> %"$phi746.1.2.sroa.8.1.i.i", ptr %scevgep92.i, align 8, !noalias !39
  %scevgep89.i = getelementptr i8, ptr %scevgep331.i, i64 -21504
  store <8 x double> %"$phi746.1.2.sroa.0.1.i.i", ptr %scevgep89.i, align 8, !noalias !39
  %lsr.iv.next324.i = add i64 %lsr.iv323.i, 64
  %lsr.iv.next87.i = add nsw i64 %lsr.iv86.i, -1
  %.858.i.i = icmp sgt i64 %lsr.iv86.i, 5
  br i1 %.858.i.i, label %B548.if.i.i, label %B584.endif.endif.endif.i

B214.if.i.i:                                      ; preds = %B214.if.i.preheader33.i, %B214.if.i.i
  %lsr.iv62.i = phi i64 [ %lsr.iv.next63.i, %B214.if.i.i ], [ %187, %B214.if.i.preheader33.i ]
  %.414647649.i.i = phi i64 [ %.421.3238.i.3.3.3.i, %B214.if.i.i ], [ 0, %B214.if.i.preheader33.i ]
  %sunkaddr336.i.i = shl i64 %.414647649.i.i, 3
  %scevgep67.i = getelementptr i8, ptr %lsr.iv282.i, i64 %sunkaddr336.i.i
  %scevgep68.i = getelementptr i8, ptr %scevgep67.i, i64 14336
  %.421.3238.i.3.3.3.i = add i64 %.414647649.i.i, 2048
  %lsr.iv.next63.i = add i64 %lsr.iv62.i, -4
  %niter.ncmp.3.i = icmp eq i64 %lsr.iv.next63.i, 0
  tail call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(17408) %scevgep68.i, i8 0, i64 17408, i1 false), !noalias !34
  br i1 %niter.ncmp.3.i, label %B340.unr-lcssa.i.unr-lcssa.unr-lcssa.unr-lcssa.i, label %B214.if.i.i

B548.if.i.i:                                      ; preds = %B746.i.i, %B548.if.i.preheader.i
  %lsr.iv86.i = phi i64 [ %lsr.iv.next87.i, %B746.i.i ], [ %192, %B548.if.i.preheader.i ]
  %lsr.iv323.i = phi i64 [ %lsr.iv.next324.i, %B746.i.i ], [ 40960, %B548.if.i.preheader.i ]
  %scevgep331.i = getelementptr i8, ptr %lsr.iv282.i, i64 %lsr.iv323.i
  store <8 x double> zeroinitializer, ptr %scevgep331.i, align 8, !noalias !39
  br i1 %208, label %B624.i.i, label %B746.i.i

B584.endif.endif.endif.i:                         ; preds = %B746.i.i, %B582.if.i
  %scevgep283.i = getelementptr i8, ptr %lsr.iv282.i, i64 27648
  %scevgep322.i = getelementptr i8, ptr %lsr.iv321.i, i64 %178
  %exitcond.not.i100 = icmp eq i64 %.767.i, %.112.i
  br i1 %exitcond.not.i100, label %B732.i, label %B582.if.i

B762.if.i:                                        ; preds = %B764.endif.endif.endif.en...endif.i, %B762.if.lr.ph.i
  %.1118925935.i = phi i64 [ 0, %B762.if.lr.ph.i ], [ %.1125.i104, %B764.endif.endif.endif.en...endif.i ]
  %.1125.i104 = add nuw nsw i64 %.1118925935.i, 1
  %214 = getelementptr i64, ptr %168, i64 %.1118925935.i
  %.1180.i = load i64, ptr %214, align 8, !noalias !34
  %.idx.i105 = mul i64 %.1180.i, 27648
  %.1266.i106 = mul nsw i64 %.1118925935.i, %.142.i
  %.1268.i107 = add nsw i64 %.1266.i106, %.1020890909
  %.1556.idx.i = shl nsw i64 %.1268.i107, 4
  %.1556.i = getelementptr inbounds i8, ptr %169, i64 %.1556.idx.i
  store ptr null, ptr %.1607.i, align 8, !noalias !34
  call fastcc void @inner_1(ptr nonnull %.1607.i, i64 %.13.i.i101, ptr %.1556.i, i64 %.1545.i, ptr nonnull %.1389.i, ptr nonnull %.1474.i)
  br i1 %.79.inv.i.i, label %B764.endif.endif.endif.en...endif.i, label %B48.if.lr.ph.i.i

B48.if.lr.ph.i.i:                                 ; preds = %B762.if.i
  %.idx52.i = shl i64 %.1118925935.i, 4
  %215 = getelementptr i8, ptr %170, i64 %.idx52.i
  %216 = getelementptr i8, ptr %215, i64 8
  %.1739.i = load double, ptr %216, align 8, !noalias !34
  %.1707.i = load double, ptr %215, align 8, !noalias !34
  %217 = getelementptr double, ptr %171, i64 %.1118925935.i
  %.1676.i = load double, ptr %217, align 8, !noalias !34
  %.702.i.i = insertelement <8 x double> poison, double %.1676.i, i64 0
  %.703.i.i = shufflevector <8 x double> %.702.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.743.i.i = fneg contract double %.1739.i
  %.753.i.i = insertelement <8 x double> poison, double %.743.i.i, i64 0
  %.754.i.i = shufflevector <8 x double> %.753.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.757.i.i108 = insertelement <8 x double> poison, double %.1707.i, i64 0
  %.758.i.i = shufflevector <8 x double> %.757.i.i108, <8 x double> poison, <8 x i32> zeroinitializer
  %.786.i.i109 = insertelement <8 x double> poison, double %.1739.i, i64 0
  %.787.i.i110 = shufflevector <8 x double> %.786.i.i109, <8 x double> poison, <8 x i32> zeroinitializer
  br label %B48.if.i.i

B48.if.i.i:                                       ; preds = %B48.if.i.i, %B48.if.lr.ph.i.i
  %lsr.iv58.i = phi i64 [ %lsr.iv.next.i118, %B48.if.i.i ], [ %167, %B48.if.lr.ph.i.i ]
  %lsr.iv.i111 = phi ptr [ %scevgep244.i117, %B48.if.i.i ], [ %scevgep.i103, %B48.if.lr.ph.i.i ]
  %scevgep253.i = getelementptr i8, ptr %lsr.iv.i111, i64 -7168
  %.251.i.i112 = load <8 x double>, ptr %scevgep253.i, align 8, !noalias !48
  %scevgep252.i = getelementptr i8, ptr %lsr.iv.i111, i64 -6144
  %.346.i.i113 = load <8 x double>, ptr %scevgep252.i, align 8, !noalias !48
  %scevgep250.i = getelementptr i8, ptr %lsr.iv.i111, i64 %.idx.i105
  %scevgep251.i = getelementptr i8, ptr %scevgep250.i, i64 -3072
  %.700.i.i = load <8 x double>, ptr %scevgep251.i, align 8, !noalias !48
  %.704.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.251.i.i112, <8 x double> %.703.i.i, <8 x double> %.700.i.i)
  store <8 x double> %.704.i.i, ptr %scevgep251.i, align 8, !noalias !48
  %scevgep249.i114 = getelementptr i8, ptr %scevgep250.i, i64 -2048
  %.725.i.i = load <8 x double>, ptr %scevgep249.i114, align 8, !noalias !48
  %.729.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.346.i.i113, <8 x double> %.703.i.i, <8 x double> %.725.i.i)
  store <8 x double> %.729.i.i, ptr %scevgep249.i114, align 8, !noalias !48
  %scevgep61.i = getelementptr i8, ptr %scevgep250.i, i64 -1024
  %.752.i.i = load <8 x double>, ptr %scevgep61.i, align 8, !noalias !48
  %.755.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.346.i.i113, <8 x double> %.754.i.i, <8 x double> %.752.i.i)
  %.759.i.i115 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.251.i.i112, <8 x double> %.758.i.i, <8 x double> %.755.i.i)
  store <8 x double> %.759.i.i115, ptr %scevgep61.i, align 8, !noalias !48
  %.780.i.i = load <8 x double>, ptr %scevgep250.i, align 8, !noalias !48
  %.784.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.346.i.i113, <8 x double> %.758.i.i, <8 x double> %.780.i.i)
  %.788.i.i116 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.251.i.i112, <8 x double> %.787.i.i110, <8 x double> %.784.i.i)
  store <8 x double> %.788.i.i116, ptr %scevgep250.i, align 8, !noalias !48
  %scevgep244.i117 = getelementptr i8, ptr %lsr.iv.i111, i64 64
  %lsr.iv.next.i118 = add nsw i64 %lsr.iv58.i, -1
  %.123.i.i119 = icmp sgt i64 %lsr.iv58.i, 5
  br i1 %.123.i.i119, label %B48.if.i.i, label %B764.endif.endif.endif.en...endif.i

B764.endif.endif.endif.en...endif.i:              ; preds = %B48.if.i.i, %B762.if.i
  %exitcond990.not.i = icmp eq i64 %.1125.i104, %.82.i
  br i1 %exitcond990.not.i, label %_ZN17bnserve_inference14adjoint_kernel7_source9_polariseB3v94B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit, label %B762.if.i

_ZN17bnserve_inference14adjoint_kernel7_source9_polariseB3v94B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit: ; preds = %B764.endif.endif.endif.en...endif.i, %B732.i
  call void @llvm.lifetime.end.p0(ptr nonnull %.1607.i)
  br i1 %50, label %B1190, label %B1018.if.preheader

B1018.if.preheader:                               ; preds = %_ZN17bnserve_inference14adjoint_kernel7_source9_polariseB3v94B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit
  %.104.i.i.i = icmp sgt i64 %.1057, 0
  %218 = shl nuw nsw i64 %.13.i, 3
  %unroll_iter.i.i.i = and i64 %.13.i, 9223372036854775800
  %219 = add nsw i64 %unroll_iter.i.i.i, -2
  %220 = lshr exact i64 %219, 1
  %221 = add nuw i64 %220, 1
  %222 = lshr exact i64 %221, 1
  %223 = mul nsw i64 %222, -2
  %224 = icmp slt i64 %.1057, 1
  %225 = shl nuw nsw i64 %.13.i, 3
  %unroll_iter.i80.i.i = and i64 %.13.i, 9223372036854775800
  %226 = add nsw i64 %unroll_iter.i80.i.i, -2
  %227 = lshr exact i64 %226, 1
  %228 = add nuw i64 %227, 1
  %229 = lshr exact i64 %228, 1
  %230 = mul nsw i64 %229, -2
  %231 = icmp slt i64 %.1057, 1
  %.1077.inv.i.i = icmp slt i64 %.1057, 1
  %.1098.i.i = lshr exact i64 %.13.i, 3
  %232 = add nuw nsw i64 %.1098.i.i, 4
  %.423.i.i291 = lshr exact i64 %.13.i, 3
  %.402.inv.i.i = icmp slt i64 %.1057, 1
  %xtraiter226.i.i = and i64 %.423.i.i291, 3
  %233 = icmp slt i64 %.1057, 32
  %234 = add nsw i64 %.423.i.i291, -4
  %235 = lshr i64 %234, 2
  %236 = icmp eq i64 %235, 0
  %237 = add nuw nsw i64 %235, 1
  %238 = and i64 %237, 9223372036854775806
  %239 = and i64 %234, 4
  %lcmp.mod.not.not.i.i = icmp eq i64 %239, 0
  %lcmp.mod227.not.i.i = icmp eq i64 %xtraiter226.i.i, 0
  %240 = shl nuw nsw i64 %xtraiter226.i.i, 6
  %.116.i.i147 = lshr exact i64 %.13.i, 3
  %.93.inv.i.i = icmp slt i64 %.1057, 1
  %241 = tail call i64 @llvm.smax.i64(i64 %.116.i.i147, i64 1)
  %242 = add nuw nsw i64 %.116.i.i147, 4
  %.438.inv.i.i = icmp sgt i64 %.1057, 0
  %243 = shl nuw i64 %.13.i, 3
  %244 = and i64 %.116.i.i147, 2305843009213693950
  %245 = icmp eq i64 %.1057, 8
  %246 = and i64 %.13.i, 8
  %247 = icmp eq i64 %246, 0
  %248 = add nuw nsw i64 %.116.i.i147, 5
  br label %B1018.if

B1018.if:                                         ; preds = %B1018.if.preheader, %_ZN17bnserve_inference14adjoint_kernel7_source12_in_detectorB4v146B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxx5ArrayIxLi1E1C7mutable7alignedEd5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit
  %lsr.iv248 = phi ptr [ %scevgep249, %_ZN17bnserve_inference14adjoint_kernel7_source12_in_detectorB4v146B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxx5ArrayIxLi1E1C7mutable7alignedEd5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit ], [ %.229, %B1018.if.preheader ]
  %lsr.iv = phi ptr [ %scevgep, %_ZN17bnserve_inference14adjoint_kernel7_source12_in_detectorB4v146B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxx5ArrayIxLi1E1C7mutable7alignedEd5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit ], [ %.362, %B1018.if.preheader ]
  %.1212877881 = phi i64 [ %.1219, %_ZN17bnserve_inference14adjoint_kernel7_source12_in_detectorB4v146B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxx5ArrayIxLi1E1C7mutable7alignedEd5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit ], [ 0, %B1018.if.preheader ]
  call void @llvm.lifetime.start.p0(ptr nonnull %.869.i)
  call void @llvm.lifetime.start.p0(ptr nonnull %.904.i)
  store ptr null, ptr %.869.i, align 8, !noalias !51
  store ptr null, ptr %.904.i, align 8, !noalias !51
  %.104.i = load i64, ptr %.76, align 8, !noalias !51
  %.134.i = load i64, ptr %.133.i129, align 8, !noalias !51
  %.172.i = load i64, ptr %.171.i, align 8, !noalias !51
  %.247.i = inttoptr i64 %.172.i to ptr
  %.311.i = getelementptr inbounds double, ptr %.247.i, i64 %.1020890909
  %.289.i.i = load i64, ptr %.143, align 8, !noalias !54
  %.290.i.i = sub i64 0, %.289.i.i
  %.298.1.i.i = and i64 %.290.i.i, -8
  %.332.i.i130 = sub i64 0, %.298.1.i.i
  %.340.i.i = icmp eq i64 %.134.i, 0
  br i1 %.340.i.i, label %B224.i.i, label %B398.i.i

B224.i.i:                                         ; preds = %B1018.if
  br i1 %.402.inv.i.i, label %_ZN17bnserve_inference14adjoint_kernel7_source10_calibrateB4v159B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i, label %B268.if.preheader.i.i

B268.if.preheader.i.i:                            ; preds = %B224.i.i
  br i1 %233, label %B268.if.epil.preheader.i.i, label %B268.if.preheader.new.i.i

B268.if.preheader.new.i.i:                        ; preds = %B268.if.preheader.i.i
  br i1 %236, label %B268.if.epil.preheader4.i.i, label %B268.if.i4.i

B394.loopexit.unr-lcssa.unr-lcssa.i.i:            ; preds = %B268.if.i4.i
  br i1 %lcmp.mod.not.not.i.i, label %B268.if.epil.preheader4.i.i, label %B394.loopexit.unr-lcssa.i.i

B268.if.epil.preheader4.i.i:                      ; preds = %B394.loopexit.unr-lcssa.unr-lcssa.i.i, %B268.if.preheader.new.i.i
  %.450957959.epil.init6.i.i = phi i64 [ 0, %B268.if.preheader.new.i.i ], [ %.457.3.1.i.i, %B394.loopexit.unr-lcssa.unr-lcssa.i.i ]
  %sunkaddr.epil.i.i = shl i64 %.450957959.epil.init6.i.i, 3
  %sunkaddr292.epil.i.i = getelementptr i8, ptr %.432, i64 %sunkaddr.epil.i.i
  store <8 x double> splat (double 1.000000e+00), ptr %sunkaddr292.epil.i.i, align 8, !noalias !54
  %sunkaddr295.epil.i.i = getelementptr i8, ptr %sunkaddr292.epil.i.i, i64 1024
  store <8 x double> zeroinitializer, ptr %sunkaddr295.epil.i.i, align 8, !noalias !54
  %sunkaddr298.epil.i.i = getelementptr i8, ptr %sunkaddr292.epil.i.i, i64 64
  store <8 x double> splat (double 1.000000e+00), ptr %sunkaddr298.epil.i.i, align 8, !noalias !54
  %sunkaddr301.epil.i.i = getelementptr i8, ptr %sunkaddr292.epil.i.i, i64 1088
  store <8 x double> zeroinitializer, ptr %sunkaddr301.epil.i.i, align 8, !noalias !54
  %sunkaddr304.epil.i.i = getelementptr i8, ptr %sunkaddr292.epil.i.i, i64 128
  store <8 x double> splat (double 1.000000e+00), ptr %sunkaddr304.epil.i.i, align 8, !noalias !54
  %sunkaddr307.epil.i.i = getelementptr i8, ptr %sunkaddr292.epil.i.i, i64 1152
  store <8 x double> zeroinitializer, ptr %sunkaddr307.epil.i.i, align 8, !noalias !54
  %.457.3.epil.i.i = add i64 %.450957959.epil.init6.i.i, 32
  %sunkaddr308.epil.i.i = shl i64 %.457.3.epil.i.i, 3
  %sunkaddr309.epil.i.i = getelementptr i8, ptr %.432, i64 %sunkaddr308.epil.i.i
  %sunkaddr310.epil.i.i = getelementptr i8, ptr %sunkaddr309.epil.i.i, i64 -64
  store <8 x double> splat (double 1.000000e+00), ptr %sunkaddr310.epil.i.i, align 8, !noalias !54
  %sunkaddr313.epil.i.i = getelementptr i8, ptr %sunkaddr309.epil.i.i, i64 960
  store <8 x double> zeroinitializer, ptr %sunkaddr313.epil.i.i, align 8, !noalias !54
  br label %B394.loopexit.unr-lcssa.i.i

B394.loopexit.unr-lcssa.i.i:                      ; preds = %B268.if.epil.preheader4.i.i, %B394.loopexit.unr-lcssa.unr-lcssa.i.i
  %.457.3.lcssa.i.i = phi i64 [ %.457.3.epil.i.i, %B268.if.epil.preheader4.i.i ], [ %.457.3.1.i.i, %B394.loopexit.unr-lcssa.unr-lcssa.i.i ]
  br i1 %lcmp.mod227.not.i.i, label %_ZN17bnserve_inference14adjoint_kernel7_source10_calibrateB4v159B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i, label %B268.if.epil.preheader.i.i

B268.if.epil.preheader.i.i:                       ; preds = %B394.loopexit.unr-lcssa.i.i, %B268.if.preheader.i.i
  %.450957959.epil.init.i.i = phi i64 [ 0, %B268.if.preheader.i.i ], [ %.457.3.lcssa.i.i, %B394.loopexit.unr-lcssa.i.i ]
  %249 = shl i64 %.450957959.epil.init.i.i, 3
  %250 = getelementptr i8, ptr %.432, i64 %249
  %scevgep.i.i292 = getelementptr i8, ptr %250, i64 1024
  br label %B268.if.epil.i.i

B268.if.epil.i.i:                                 ; preds = %B268.if.epil.i.i, %B268.if.epil.preheader.i.i
  %lsr.iv.i.i293 = phi i64 [ %lsr.iv.next.i.i294, %B268.if.epil.i.i ], [ 0, %B268.if.epil.preheader.i.i ]
  %scevgep232.i.i = getelementptr i8, ptr %scevgep.i.i292, i64 %lsr.iv.i.i293
  %scevgep233.i.i = getelementptr i8, ptr %scevgep232.i.i, i64 -1024
  store <8 x double> splat (double 1.000000e+00), ptr %scevgep233.i.i, align 8, !noalias !54
  store <8 x double> zeroinitializer, ptr %scevgep232.i.i, align 8, !noalias !54
  %lsr.iv.next.i.i294 = add nuw nsw i64 %lsr.iv.i.i293, 64
  %epil.iter.cmp.not.i.i295 = icmp eq i64 %240, %lsr.iv.next.i.i294
  br i1 %epil.iter.cmp.not.i.i295, label %_ZN17bnserve_inference14adjoint_kernel7_source10_calibrateB4v159B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i, label %B268.if.epil.i.i, !llvm.loop !57

B398.i.i:                                         ; preds = %B1018.if
  %.665.i.i131 = shl nsw i64 %.134.i, 3
  %.695.i.i = load i64, ptr %arg.arguments.4, align 8, !noalias !54
  %.697.i.i = mul nsw i64 %.695.i.i, %.604928988
  %.701.i.i = add nsw i64 %.697.i.i, %.1212877881
  %.704.i.i132 = mul nsw i64 %.701.i.i, %.665.i.i131
  %.735.i.i = load i64, ptr %.734.i.i, align 8, !noalias !54
  %.738.i.i = mul nsw i64 %.134.i, %.332.i.i130
  %.818.i.i134 = load i64, ptr %.817.i.i133, align 8, !noalias !54
  %.819.i.i135 = add nsw i64 %.704.i.i132, %.818.i.i134
  br i1 %.104.i.i.i, label %B60.if.preheader.i.i.i, label %B76.i.i.i

B1142.i.i:                                        ; preds = %B926.if.i.i, %B398.endif.endif.endif.endif.endif.endif.endif.i.i
  tail call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(2048) %.1448.i.i136, i8 0, i64 2048, i1 false), !noalias !54
  br label %_ZN17bnserve_inference14adjoint_kernel7_source10_calibrateB4v159B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i

B268.if.i4.i:                                     ; preds = %B268.if.preheader.new.i.i, %B268.if.i4.i
  %lsr.iv5.i.i = phi i64 [ %lsr.iv.next6.i.i, %B268.if.i4.i ], [ %238, %B268.if.preheader.new.i.i ]
  %.450957959.i.i = phi i64 [ %.457.3.1.i.i, %B268.if.i4.i ], [ 0, %B268.if.preheader.new.i.i ]
  %sunkaddr81.i.i = shl i64 %.450957959.i.i, 3
  %sunkaddr82.i.i = getelementptr i8, ptr %.432, i64 %sunkaddr81.i.i
  store <8 x double> splat (double 1.000000e+00), ptr %sunkaddr82.i.i, align 8, !noalias !54
  %sunkaddr85.i.i = getelementptr i8, ptr %sunkaddr82.i.i, i64 1024
  store <8 x double> zeroinitializer, ptr %sunkaddr85.i.i, align 8, !noalias !54
  %sunkaddr88.i.i = getelementptr i8, ptr %sunkaddr82.i.i, i64 64
  store <8 x double> splat (double 1.000000e+00), ptr %sunkaddr88.i.i, align 8, !noalias !54
  %sunkaddr90.i.i = getelementptr i8, ptr %sunkaddr82.i.i, i64 1088
  store <8 x double> zeroinitializer, ptr %sunkaddr90.i.i, align 8, !noalias !54
  %sunkaddr93.i.i = getelementptr i8, ptr %sunkaddr82.i.i, i64 128
  store <8 x double> splat (double 1.000000e+00), ptr %sunkaddr93.i.i, align 8, !noalias !54
  %sunkaddr96.i.i = getelementptr i8, ptr %sunkaddr82.i.i, i64 1152
  store <8 x double> zeroinitializer, ptr %sunkaddr96.i.i, align 8, !noalias !54
  %sunkaddr99.i.i = getelementptr i8, ptr %sunkaddr82.i.i, i64 192
  store <8 x double> splat (double 1.000000e+00), ptr %sunkaddr99.i.i, align 8, !noalias !54
  %sunkaddr102.i.i = getelementptr i8, ptr %sunkaddr82.i.i, i64 1216
  store <8 x double> zeroinitializer, ptr %sunkaddr102.i.i, align 8, !noalias !54
  %sunkaddr105.i.i = getelementptr i8, ptr %sunkaddr82.i.i, i64 256
  store <8 x double> splat (double 1.000000e+00), ptr %sunkaddr105.i.i, align 8, !noalias !54
  %sunkaddr108.i.i = getelementptr i8, ptr %sunkaddr82.i.i, i64 1280
  store <8 x double> zeroinitializer, ptr %sunkaddr108.i.i, align 8, !noalias !54
  %sunkaddr111.i.i = getelementptr i8, ptr %sunkaddr82.i.i, i64 320
  store <8 x double> splat (double 1.000000e+00), ptr %sunkaddr111.i.i, align 8, !noalias !54
  %sunkaddr114.i.i = getelementptr i8, ptr %sunkaddr82.i.i, i64 1344
  store <8 x double> zeroinitializer, ptr %sunkaddr114.i.i, align 8, !noalias !54
  %sunkaddr117.i.i = getelementptr i8, ptr %sunkaddr82.i.i, i64 384
  store <8 x double> splat (double 1.000000e+00), ptr %sunkaddr117.i.i, align 8, !noalias !54
  %sunkaddr120.i.i = getelementptr i8, ptr %sunkaddr82.i.i, i64 1408
  store <8 x double> zeroinitializer, ptr %sunkaddr120.i.i, align 8, !noalias !54
  %.457.3.1.i.i = add i64 %.450957959.i.i, 64
  %sunkaddr121.i.i = shl i64 %.457.3.1.i.i, 3
  %sunkaddr122.i.i = getelementptr i8, ptr %.432, i64 %sunkaddr121.i.i
  %sunkaddr124.i.i = getelementptr i8, ptr %sunkaddr122.i.i, i64 -64
  store <8 x double> splat (double 1.000000e+00), ptr %sunkaddr124.i.i, align 8, !noalias !54
  %sunkaddr127.i.i = getelementptr i8, ptr %sunkaddr122.i.i, i64 960
  store <8 x double> zeroinitializer, ptr %sunkaddr127.i.i, align 8, !noalias !54
  %lsr.iv.next6.i.i = add i64 %lsr.iv5.i.i, -2
  %niter.ncmp.110.i.i = icmp eq i64 %lsr.iv.next6.i.i, 0
  br i1 %niter.ncmp.110.i.i, label %B394.loopexit.unr-lcssa.unr-lcssa.i.i, label %B268.if.i4.i

B60.if.preheader.i.i.i:                           ; preds = %B398.i.i
  tail call void @llvm.memset.p0.i64(ptr nonnull align 8 %.536.i.i, i8 0, i64 %218, i1 false), !noalias !58
  br label %B76.i.i.i

B76.i.i.i:                                        ; preds = %B60.if.preheader.i.i.i, %B398.i.i
  %.311284.not.i.i.i = icmp slt i64 %.134.i, 1
  br i1 %.311284.not.i.i.i, label %B398.endif.endif.endif.endif.endif.i.i, label %B128.if.lr.ph.i.i.i

B128.if.lr.ph.i.i.i:                              ; preds = %B76.i.i.i
  %251 = inttoptr i64 %.735.i.i to ptr
  %scevgep282.i.i = getelementptr i8, ptr %251, i64 24
  %252 = inttoptr i64 %.819.i.i135 to ptr
  br label %B128.if.i.i.i

B284.i.i.i:                                       ; preds = %B228.if.i.i.i, %B130.else.endif.endif.endif.endif.i.i.i
  %exitcond292.not.i.i.i = icmp eq i64 %.324.i.i.i, %.134.i
  br i1 %exitcond292.not.i.i.i, label %B398.endif.endif.endif.endif.endif.i.i, label %B128.if.i.i.i

B128.if.i.i.i:                                    ; preds = %B284.i.i.i, %B128.if.lr.ph.i.i.i
  %.317279285.i.i.i = phi i64 [ 0, %B128.if.lr.ph.i.i.i ], [ %.324.i.i.i, %B284.i.i.i ]
  %.324.i.i.i = add nuw nsw i64 %.317279285.i.i.i, 1
  %.350.i.i.i = mul nsw i64 %.317279285.i.i.i, %.332.i.i130
  %.352.i.i.i = add nsw i64 %.350.i.i.i, %.1020890909
  %.395.i.i.i = icmp slt i64 %.352.i.i.i, 0
  %.396.i.i.i = select i1 %.395.i.i.i, i64 %.738.i.i, i64 0
  %.397.i.i.i = add i64 %.396.i.i.i, %.352.i.i.i
  %.400.i.i.i = icmp slt i64 %.397.i.i.i, 0
  br i1 %.400.i.i.i, label %B130.else.if.i.i.i, label %B130.else.endif.i.i.i, !prof !61

B130.else.if.i.i.i:                               ; preds = %B128.if.i.i.i
  br label %B130.else.endif.i.i.i

B130.else.endif.i.i.i:                            ; preds = %B130.else.if.i.i.i, %B128.if.i.i.i
  %.385.sroa.0.1.i.i.i = phi i64 [ 0, %B130.else.if.i.i.i ], [ %.397.i.i.i, %B128.if.i.i.i ]
  %.405.not.i.i.i = icmp slt i64 %.397.i.i.i, %.738.i.i
  br i1 %.405.not.i.i.i, label %B130.else.endif.endif.endif.endif.i.i.i, label %B130.else.endif.if.i.i.i, !prof !62

B130.else.endif.if.i.i.i:                         ; preds = %B130.else.endif.i.i.i
  br label %B130.else.endif.endif.endif.endif.i.i.i

B130.else.endif.endif.endif.endif.i.i.i:          ; preds = %B130.else.endif.if.i.i.i, %B130.else.endif.i.i.i
  %.385.sroa.0.3.i.i.i = phi i64 [ %.738.i.i, %B130.else.endif.if.i.i.i ], [ %.385.sroa.0.1.i.i.i, %B130.else.endif.i.i.i ]
  %253 = getelementptr double, ptr %252, i64 %.317279285.i.i.i
  %.565.i.i.i = load double, ptr %253, align 8, !noalias !58
  br i1 %224, label %B284.i.i.i, label %B228.if.preheader.i.i.i

B228.if.preheader.i.i.i:                          ; preds = %B130.else.endif.endif.endif.endif.i.i.i
  %254 = shl i64 %.385.sroa.0.3.i.i.i, 3
  %scevgep283.i.i = getelementptr i8, ptr %scevgep282.i.i, i64 %254
  br label %B228.if.i.i.i

B228.if.i.i.i:                                    ; preds = %B228.if.i.i.i, %B228.if.preheader.i.i.i
  %lsr.iv63.i.i = phi i64 [ %lsr.iv.next64.i.i, %B228.if.i.i.i ], [ %223, %B228.if.preheader.i.i.i ]
  %.655272274.i.i.i = phi i64 [ %.662.1.i.1.i.i, %B228.if.i.i.i ], [ 0, %B228.if.preheader.i.i.i ]
  %sunkaddr128.i.i = shl i64 %.655272274.i.i.i, 3
  %sunkaddr129.i.i = getelementptr i8, ptr %.432, i64 %sunkaddr128.i.i
  %sunkaddr130.i.i = getelementptr i8, ptr %sunkaddr129.i.i, i64 2048
  %.716.i.i.i = load double, ptr %sunkaddr130.i.i, align 8, !noalias !58
  %scevgep79.i.i = getelementptr i8, ptr %scevgep283.i.i, i64 %sunkaddr128.i.i
  %scevgep80.i.i = getelementptr i8, ptr %scevgep79.i.i, i64 -16
  %scevgep78.i.i = getelementptr i8, ptr %scevgep79.i.i, i64 -24
  %.746.i.i.i = load double, ptr %scevgep78.i.i, align 8, !noalias !58
  %.748.i.i.i = fmul contract double %.565.i.i.i, %.746.i.i.i
  %.749.i.i.i = fadd contract double %.716.i.i.i, %.748.i.i.i
  store double %.749.i.i.i, ptr %sunkaddr130.i.i, align 8, !noalias !58
  %sunkaddr133.i.i = getelementptr i8, ptr %sunkaddr129.i.i, i64 2056
  %.716.1.i.i.i = load double, ptr %sunkaddr133.i.i, align 8, !noalias !58
  %.746.1.i.i.i = load double, ptr %scevgep80.i.i, align 8, !noalias !58
  %.748.1.i.i.i = fmul contract double %.565.i.i.i, %.746.1.i.i.i
  %.749.1.i.i.i = fadd contract double %.716.1.i.i.i, %.748.1.i.i.i
  store double %.749.1.i.i.i, ptr %sunkaddr133.i.i, align 8, !noalias !58
  %sunkaddr137.i.i = getelementptr i8, ptr %sunkaddr129.i.i, i64 2064
  %.716.i.1.i.i = load double, ptr %sunkaddr137.i.i, align 8, !noalias !58
  %scevgep76.i.i = getelementptr i8, ptr %scevgep79.i.i, i64 -8
  %.746.i.1.i.i = load double, ptr %scevgep76.i.i, align 8, !noalias !58
  %.748.i.1.i.i = fmul contract double %.565.i.i.i, %.746.i.1.i.i
  %.749.i.1.i.i = fadd contract double %.716.i.1.i.i, %.748.i.1.i.i
  store double %.749.i.1.i.i, ptr %sunkaddr137.i.i, align 8, !noalias !58
  %.662.1.i.1.i.i = add i64 %.655272274.i.i.i, 4
  %sunkaddr138.i.i = shl i64 %.662.1.i.1.i.i, 3
  %sunkaddr139.i.i = getelementptr i8, ptr %.432, i64 %sunkaddr138.i.i
  %sunkaddr140.i.i = getelementptr i8, ptr %sunkaddr139.i.i, i64 2040
  %.716.1.i.1.i.i = load double, ptr %sunkaddr140.i.i, align 8, !noalias !58
  %.746.1.i.1.i.i = load double, ptr %scevgep79.i.i, align 8, !noalias !58
  %.748.1.i.1.i.i = fmul contract double %.565.i.i.i, %.746.1.i.1.i.i
  %.749.1.i.1.i.i = fadd contract double %.716.1.i.1.i.i, %.748.1.i.1.i.i
  store double %.749.1.i.1.i.i, ptr %sunkaddr140.i.i, align 8, !noalias !58
  %lsr.iv.next64.i.i = add i64 %lsr.iv63.i.i, 2
  %niter.ncmp.1.i.i = icmp eq i64 %lsr.iv.next64.i.i, 0
  br i1 %niter.ncmp.1.i.i, label %B284.i.i.i, label %B228.if.i.i.i

B398.endif.endif.endif.endif.endif.i.i:           ; preds = %B284.i.i.i, %B76.i.i.i
  %.936.i.i = load i64, ptr %.935.i.i, align 8, !noalias !54
  %.942.i.i = add nsw i64 %.936.i.i, %.704.i.i132
  br i1 %.104.i.i.i, label %B60.if.preheader.i128.i.i, label %B76.i77.i.i

B60.if.preheader.i128.i.i:                        ; preds = %B398.endif.endif.endif.endif.endif.i.i
  tail call void @llvm.memset.p0.i64(ptr nonnull align 8 %.607.i.i, i8 0, i64 %225, i1 false), !noalias !63
  br label %B76.i77.i.i

B76.i77.i.i:                                      ; preds = %B60.if.preheader.i128.i.i, %B398.endif.endif.endif.endif.endif.i.i
  br i1 %.311284.not.i.i.i, label %B398.endif.endif.endif.endif.endif.endif.endif.i.i, label %B128.if.lr.ph.i79.i.i

B128.if.lr.ph.i79.i.i:                            ; preds = %B76.i77.i.i
  %255 = inttoptr i64 %.735.i.i to ptr
  %scevgep264.i.i = getelementptr i8, ptr %255, i64 24
  %256 = inttoptr i64 %.942.i.i to ptr
  br label %B128.if.i82.i.i

B284.i125.i.i:                                    ; preds = %B228.if.i102.i.i, %B130.else.endif.endif.endif.endif.i95.i.i
  %exitcond292.not.i126.i.i = icmp eq i64 %.324.i84.i.i, %.134.i
  br i1 %exitcond292.not.i126.i.i, label %B398.endif.endif.endif.endif.endif.endif.endif.i.i, label %B128.if.i82.i.i

B128.if.i82.i.i:                                  ; preds = %B284.i125.i.i, %B128.if.lr.ph.i79.i.i
  %.317279285.i83.i.i = phi i64 [ 0, %B128.if.lr.ph.i79.i.i ], [ %.324.i84.i.i, %B284.i125.i.i ]
  %.324.i84.i.i = add nuw nsw i64 %.317279285.i83.i.i, 1
  %.350.i85.i.i = mul nsw i64 %.317279285.i83.i.i, %.332.i.i130
  %.352.i86.i.i = add nsw i64 %.350.i85.i.i, %.1020890909
  %.395.i87.i.i = icmp slt i64 %.352.i86.i.i, 0
  %.396.i88.i.i = select i1 %.395.i87.i.i, i64 %.738.i.i, i64 0
  %.397.i89.i.i = add i64 %.396.i88.i.i, %.352.i86.i.i
  %.400.i90.i.i = icmp slt i64 %.397.i89.i.i, 0
  br i1 %.400.i90.i.i, label %B130.else.if.i127.i.i, label %B130.else.endif.i91.i.i, !prof !61

B130.else.if.i127.i.i:                            ; preds = %B128.if.i82.i.i
  br label %B130.else.endif.i91.i.i

B130.else.endif.i91.i.i:                          ; preds = %B130.else.if.i127.i.i, %B128.if.i82.i.i
  %.385.sroa.0.1.i92.i.i = phi i64 [ 0, %B130.else.if.i127.i.i ], [ %.397.i89.i.i, %B128.if.i82.i.i ]
  %.405.not.i93.i.i = icmp slt i64 %.397.i89.i.i, %.738.i.i
  br i1 %.405.not.i93.i.i, label %B130.else.endif.endif.endif.endif.i95.i.i, label %B130.else.endif.if.i94.i.i, !prof !62

B130.else.endif.if.i94.i.i:                       ; preds = %B130.else.endif.i91.i.i
  br label %B130.else.endif.endif.endif.endif.i95.i.i

B130.else.endif.endif.endif.endif.i95.i.i:        ; preds = %B130.else.endif.if.i94.i.i, %B130.else.endif.i91.i.i
  %.385.sroa.0.3.i96.i.i = phi i64 [ %.738.i.i, %B130.else.endif.if.i94.i.i ], [ %.385.sroa.0.1.i92.i.i, %B130.else.endif.i91.i.i ]
  %257 = getelementptr double, ptr %256, i64 %.317279285.i83.i.i
  %.565.i98.i.i = load double, ptr %257, align 8, !noalias !63
  br i1 %231, label %B284.i125.i.i, label %B228.if.preheader.i99.i.i

B228.if.preheader.i99.i.i:                        ; preds = %B130.else.endif.endif.endif.endif.i95.i.i
  %258 = shl i64 %.385.sroa.0.3.i96.i.i, 3
  %scevgep265.i.i = getelementptr i8, ptr %scevgep264.i.i, i64 %258
  br label %B228.if.i102.i.i

B228.if.i102.i.i:                                 ; preds = %B228.if.i102.i.i, %B228.if.preheader.i99.i.i
  %lsr.iv41.i.i = phi i64 [ %lsr.iv.next42.i.i, %B228.if.i102.i.i ], [ %230, %B228.if.preheader.i99.i.i ]
  %.655272274.i103.i.i = phi i64 [ %.662.1.i111.1.i.i, %B228.if.i102.i.i ], [ 0, %B228.if.preheader.i99.i.i ]
  %sunkaddr141.i.i = shl i64 %.655272274.i103.i.i, 3
  %sunkaddr142.i.i = getelementptr i8, ptr %.432, i64 %sunkaddr141.i.i
  %sunkaddr143.i.i = getelementptr i8, ptr %sunkaddr142.i.i, i64 3072
  %.716.i105.i.i = load double, ptr %sunkaddr143.i.i, align 8, !noalias !63
  %scevgep59.i.i = getelementptr i8, ptr %scevgep265.i.i, i64 %sunkaddr141.i.i
  %scevgep62.i.i = getelementptr i8, ptr %scevgep59.i.i, i64 -16
  %scevgep56.i.i = getelementptr i8, ptr %scevgep59.i.i, i64 -24
  %.746.i108.i.i = load double, ptr %scevgep56.i.i, align 8, !noalias !63
  %.748.i109.i.i = fmul contract double %.565.i98.i.i, %.746.i108.i.i
  %.749.i110.i.i = fadd contract double %.716.i105.i.i, %.748.i109.i.i
  store double %.749.i110.i.i, ptr %sunkaddr143.i.i, align 8, !noalias !63
  %sunkaddr146.i.i = getelementptr i8, ptr %sunkaddr142.i.i, i64 3080
  %.716.1.i113.i.i = load double, ptr %sunkaddr146.i.i, align 8, !noalias !63
  %.746.1.i114.i.i = load double, ptr %scevgep62.i.i, align 8, !noalias !63
  %.748.1.i115.i.i = fmul contract double %.565.i98.i.i, %.746.1.i114.i.i
  %.749.1.i116.i.i = fadd contract double %.716.1.i113.i.i, %.748.1.i115.i.i
  store double %.749.1.i116.i.i, ptr %sunkaddr146.i.i, align 8, !noalias !63
  %sunkaddr149.i.i = getelementptr i8, ptr %sunkaddr142.i.i, i64 3088
  %.716.i105.1.i.i = load double, ptr %sunkaddr149.i.i, align 8, !noalias !63
  %scevgep54.i.i = getelementptr i8, ptr %scevgep59.i.i, i64 -8
  %.746.i108.1.i.i = load double, ptr %scevgep54.i.i, align 8, !noalias !63
  %.748.i109.1.i.i = fmul contract double %.565.i98.i.i, %.746.i108.1.i.i
  %.749.i110.1.i.i = fadd contract double %.716.i105.1.i.i, %.748.i109.1.i.i
  store double %.749.i110.1.i.i, ptr %sunkaddr149.i.i, align 8, !noalias !63
  %.662.1.i111.1.i.i = add i64 %.655272274.i103.i.i, 4
  %sunkaddr150.i.i = shl i64 %.662.1.i111.1.i.i, 3
  %sunkaddr151.i.i = getelementptr i8, ptr %.432, i64 %sunkaddr150.i.i
  %sunkaddr152.i.i = getelementptr i8, ptr %sunkaddr151.i.i, i64 3064
  %.716.1.i113.1.i.i = load double, ptr %sunkaddr152.i.i, align 8, !noalias !63
  %.746.1.i114.1.i.i = load double, ptr %scevgep59.i.i, align 8, !noalias !63
  %.748.1.i115.1.i.i = fmul contract double %.565.i98.i.i, %.746.1.i114.1.i.i
  %.749.1.i116.1.i.i = fadd contract double %.716.1.i113.1.i.i, %.748.1.i115.1.i.i
  store double %.749.1.i116.1.i.i, ptr %sunkaddr152.i.i, align 8, !noalias !63
  %lsr.iv.next42.i.i = add i64 %lsr.iv41.i.i, 2
  %niter225.ncmp.1.i.i = icmp eq i64 %lsr.iv.next42.i.i, 0
  br i1 %niter225.ncmp.1.i.i, label %B284.i125.i.i, label %B228.if.i102.i.i

B398.endif.endif.endif.endif.endif.endif.endif.i.i: ; preds = %B284.i125.i.i, %B76.i77.i.i
  br i1 %.1077.inv.i.i, label %B1142.i.i, label %B926.if.i.i

B926.if.i.i:                                      ; preds = %B398.endif.endif.endif.endif.endif.endif.endif.i.i, %B926.if.i.i
  %lsr.iv39.i.i = phi i64 [ %lsr.iv.next40.i.i, %B926.if.i.i ], [ %232, %B398.endif.endif.endif.endif.endif.endif.endif.i.i ]
  %lsr.iv251.i.i = phi ptr [ %scevgep252.i.i, %B926.if.i.i ], [ %.607.i.i, %B398.endif.endif.endif.endif.endif.endif.endif.i.i ]
  %.1166.i.i = load <8 x double>, ptr %lsr.iv251.i.i, align 8, !noalias !54
  %scevgep255.i.i = getelementptr i8, ptr %lsr.iv251.i.i, i64 -1024
  %.1176.i.i = load <8 x double>, ptr %scevgep255.i.i, align 8, !noalias !54
  %.8.i.i1.i = fadd contract <8 x double> %.1176.i.i, splat (double 1.000000e+00)
  %.1203.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1166.i.i, <8 x double> %.1166.i.i, <8 x double> splat (double 4.000000e+00))
  %.6.i.i2.i = fdiv contract <8 x double> %.8.i.i1.i, %.1203.i.i
  %259 = fmul contract <8 x double> %.1166.i.i, %.1166.i.i
  %.8.i132.i.i = fsub contract <8 x double> splat (double 4.000000e+00), %259
  %.6.i133.i3.i = fmul contract <8 x double> %.8.i132.i.i, %.6.i.i2.i
  %scevgep254.i.i = getelementptr i8, ptr %lsr.iv251.i.i, i64 -3072
  store <8 x double> %.6.i133.i3.i, ptr %scevgep254.i.i, align 8, !noalias !54
  %.6.i134.i.i = fmul contract <8 x double> %.1166.i.i, %.6.i.i2.i
  %.8.i135.i.i = fmul contract <8 x double> %.6.i134.i.i, splat (double 4.000000e+00)
  %scevgep253.i.i = getelementptr i8, ptr %lsr.iv251.i.i, i64 -2048
  store <8 x double> %.8.i135.i.i, ptr %scevgep253.i.i, align 8, !noalias !54
  %scevgep252.i.i = getelementptr i8, ptr %lsr.iv251.i.i, i64 64
  %lsr.iv.next40.i.i = add nsw i64 %lsr.iv39.i.i, -1
  %.1119.i.i = icmp sgt i64 %lsr.iv39.i.i, 5
  br i1 %.1119.i.i, label %B926.if.i.i, label %B1142.i.i

_ZN17bnserve_inference14adjoint_kernel7_source10_calibrateB4v159B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i: ; preds = %B268.if.epil.i.i, %B1142.i.i, %B394.loopexit.unr-lcssa.i.i, %B224.i.i
  %.501.i = load i64, ptr %.500.i, align 8, !noalias !51
  %.502.i = icmp eq i64 %.501.i, 0
  br i1 %.502.i, label %B372.i, label %B420.i

B372.i:                                           ; preds = %_ZN17bnserve_inference14adjoint_kernel7_source10_calibrateB4v159B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i
  %.536.i = getelementptr i8, ptr %lsr.iv248, i64 160
  %.537.i = load double, ptr %.536.i, align 8, !noalias !51
  %.538.i = fcmp contract oeq double %.537.i, 0.000000e+00
  br label %B420.i

B420.i:                                           ; preds = %B372.i, %_ZN17bnserve_inference14adjoint_kernel7_source10_calibrateB4v159B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i
  %"$phi420.0.2.0.i" = phi i1 [ %.538.i, %B372.i ], [ false, %_ZN17bnserve_inference14adjoint_kernel7_source10_calibrateB4v159B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i ]
  %.586.i = icmp sgt i64 %.104.i, 0
  br i1 %.586.i, label %B452.if.lr.ph.i, label %B1406.i

B452.if.lr.ph.i:                                  ; preds = %B420.i
  %.761.i = icmp sgt i64 %.134.i, 0
  %sunkaddr81.i = getelementptr i8, ptr %lsr.iv248, i64 160
  %sunkaddr8.i.i = getelementptr i8, ptr %lsr.iv248, i64 24
  %sunkaddr9.i.i = getelementptr i8, ptr %lsr.iv248, i64 16
  %sunkaddr10.i.i = getelementptr i8, ptr %lsr.iv248, i64 8
  %sunkaddr11.i.i148 = getelementptr i8, ptr %lsr.iv248, i64 40
  %sunkaddr12.i.i149 = getelementptr i8, ptr %lsr.iv248, i64 32
  %sunkaddr13.i.i = getelementptr i8, ptr %lsr.iv248, i64 64
  %sunkaddr14.i.i150 = getelementptr i8, ptr %lsr.iv248, i64 56
  %sunkaddr15.i.i = getelementptr i8, ptr %lsr.iv248, i64 48
  %sunkaddr16.i.i151 = getelementptr i8, ptr %lsr.iv248, i64 80
  %sunkaddr17.i.i = getelementptr i8, ptr %lsr.iv248, i64 72
  %sunkaddr18.i.i = getelementptr i8, ptr %lsr.iv, i64 16
  %sunkaddr19.i.i152 = getelementptr i8, ptr %lsr.iv, i64 8
  %sunkaddr.i.i153 = getelementptr i8, ptr %lsr.iv, i64 32
  %sunkaddr20.i.i154 = getelementptr i8, ptr %lsr.iv, i64 24
  %sunkaddr21.i.i = getelementptr i8, ptr %lsr.iv, i64 56
  %sunkaddr22.i.i = getelementptr i8, ptr %lsr.iv, i64 48
  %sunkaddr23.i.i = getelementptr i8, ptr %lsr.iv, i64 40
  %sunkaddr24.i.i = getelementptr i8, ptr %lsr.iv, i64 72
  %sunkaddr25.i.i = getelementptr i8, ptr %lsr.iv, i64 64
  %sunkaddr82.i = getelementptr i8, ptr %lsr.iv248, i64 96
  %sunkaddr85.i = getelementptr i8, ptr %lsr.iv248, i64 88
  br label %B452.if.i

B492.i:                                           ; preds = %B452.if.i
  br i1 %.93.inv.i.i, label %B918.i, label %B152.if.lr.ph.i.i

B152.if.lr.ph.i.i:                                ; preds = %B492.i
  %.190.i.i = load double, ptr %sunkaddr15.i.i, align 8, !noalias !66
  %.220.i.i = load double, ptr %sunkaddr14.i.i150, align 8, !noalias !66
  %.221.i.i = fadd contract double %.190.i.i, %.220.i.i
  %.251.i.i278 = load double, ptr %sunkaddr17.i.i, align 8, !noalias !66
  %.255.i.i279 = fadd contract double %.221.i.i, %.251.i.i278
  %.150.i.i = load double, ptr %sunkaddr12.i.i149, align 8, !noalias !66
  %.119.i.i = load double, ptr %sunkaddr9.i.i, align 8, !noalias !66
  %.89.i.i = load double, ptr %sunkaddr10.i.i, align 8, !noalias !66
  %.120.i.i = fadd contract double %.119.i.i, %.89.i.i
  %.154.i.i280 = fadd contract double %.150.i.i, %.120.i.i
  %.600.i.i = insertelement <8 x double> poison, double %.154.i.i280, i64 0
  %.601.i.i = shufflevector <8 x double> %.600.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.6.i.i.i281 = insertelement <8 x double> poison, double %.255.i.i279, i64 0
  %.7.i.i.i282 = shufflevector <8 x double> %.6.i.i.i281, <8 x double> poison, <8 x i32> zeroinitializer
  br label %B152.if.i.i

B558.i.i:                                         ; preds = %B152.if.i.i
  %.932.i.i = load <8 x double>, ptr %lsr.iv190.i, align 8, !noalias !66
  %scevgep192.i = getelementptr i8, ptr %lsr.iv190.i, i64 1024
  %.1028.i.i289 = load <8 x double>, ptr %scevgep192.i, align 8, !noalias !66
  %260 = fneg contract <8 x double> %.1028.i.i289
  %.8.i111.i.i = fmul contract <8 x double> %.830.i.i, %260
  %.6.i112.i.i = fmul contract <8 x double> %.830.i.i, %.932.i.i
  %.1086.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.602.i.i, <8 x double> %.932.i.i, <8 x double> %.8.i111.i.i)
  %.1111.i.i290 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.602.i.i, <8 x double> %.1028.i.i289, <8 x double> %.6.i112.i.i)
  br label %B742.i.i

B742.i.i:                                         ; preds = %B152.if.i.i, %B558.i.i
  %sr.2.1.i.i = phi <8 x double> [ %.1086.i.i, %B558.i.i ], [ %.602.i.i, %B152.if.i.i ]
  %si.2.1.i.i = phi <8 x double> [ %.1111.i.i290, %B558.i.i ], [ %.830.i.i, %B152.if.i.i ]
  %scevgep63.i = getelementptr i8, ptr %scevgep204.i, i64 -1024
  store <8 x double> %sr.2.1.i.i, ptr %scevgep63.i, align 8, !noalias !66
  store <8 x double> %si.2.1.i.i, ptr %scevgep204.i, align 8, !noalias !66
  %scevgep191.i = getelementptr i8, ptr %lsr.iv190.i, i64 64
  %lsr.iv.next59.i = add nsw i64 %lsr.iv58.i283, -1
  %.343.i.i288 = icmp sgt i64 %lsr.iv58.i283, 5
  br i1 %.343.i.i288, label %B152.if.i.i, label %B918.i

B152.if.i.i:                                      ; preds = %B742.i.i, %B152.if.lr.ph.i.i
  %lsr.iv58.i283 = phi i64 [ %lsr.iv.next59.i, %B742.i.i ], [ %242, %B152.if.lr.ph.i.i ]
  %lsr.iv190.i = phi ptr [ %scevgep191.i, %B742.i.i ], [ %.432, %B152.if.lr.ph.i.i ]
  %scevgep204.i = getelementptr i8, ptr %lsr.iv190.i, i64 %lsr.iv193.i
  %scevgep205.i = getelementptr i8, ptr %scevgep204.i, i64 -7168
  %.475.i.i = load <8 x double>, ptr %scevgep205.i, align 8, !noalias !66
  %scevgep203.i = getelementptr i8, ptr %scevgep204.i, i64 -5120
  %.570.i.i = load <8 x double>, ptr %scevgep203.i, align 8, !noalias !66
  %.8.i.i.i284 = fmul contract <8 x double> %.7.i.i.i282, %.570.i.i
  %.602.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.475.i.i, <8 x double> %.601.i.i, <8 x double> %.8.i.i.i284)
  %scevgep68.i285 = getelementptr i8, ptr %scevgep204.i, i64 -6144
  %.702.i.i286 = load <8 x double>, ptr %scevgep68.i285, align 8, !noalias !66
  %scevgep66.i = getelementptr i8, ptr %scevgep204.i, i64 -4096
  %.798.i.i287 = load <8 x double>, ptr %scevgep66.i, align 8, !noalias !66
  %.8.i104.i.i = fmul contract <8 x double> %.7.i.i.i282, %.798.i.i287
  %.830.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.702.i.i286, <8 x double> %.601.i.i, <8 x double> %.8.i104.i.i)
  br i1 %.761.i, label %B558.i.i, label %B742.i.i

B540.i:                                           ; preds = %B452.if.i
  %.833.i = load double, ptr %sunkaddr81.i, align 8, !noalias !51
  %.834.i = fcmp contract ogt double %.833.i, 0.000000e+00
  br i1 %.834.i, label %B590.i, label %B742.i

B590.i:                                           ; preds = %B540.i
  %.157.i.i277 = getelementptr i8, ptr %291, i64 24576
  tail call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(12288) %.157.i.i277, i8 0, i64 12288, i1 false), !noalias !69
  store ptr null, ptr %.869.i, align 8, !noalias !51
  call fastcc void @inner_2(ptr nonnull %.869.i, ptr readonly %lsr.iv248, i64 17, double 1.000000e+00, ptr %.311.i, i64 range(i64 -9223372036854775808, 129) %.13.i, i64 range(i64 -9223372036854775808, 129) %.13.i, ptr %.688.i)
  store ptr null, ptr %.904.i, align 8, !noalias !51
  call fastcc void @inner_2(ptr nonnull %.904.i, ptr readonly %lsr.iv248, i64 21, double -1.000000e+00, ptr %.311.i, i64 range(i64 -9223372036854775808, 129) %.13.i, i64 range(i64 -9223372036854775808, 129) %.13.i, ptr %.688.i)
  br label %B778.i

B742.i:                                           ; preds = %B540.i
  br i1 %.93.inv.i.i, label %B918.i, label %B158.if.lr.ph.i.i

B158.if.lr.ph.i.i:                                ; preds = %B742.i
  %.2220.5.i.i = getelementptr i8, ptr %291, i64 35840
  br label %B158.if.i.i

B158.if.i.i:                                      ; preds = %B158.if.i.i, %B158.if.lr.ph.i.i
  %lsr.iv6.i.i = phi i64 [ %lsr.iv.next7.i.i, %B158.if.i.i ], [ %242, %B158.if.lr.ph.i.i ]
  %lsr.iv226.i.i = phi ptr [ %scevgep.i17.i, %B158.if.i.i ], [ %.2220.5.i.i, %B158.if.lr.ph.i.i ]
  %scevgep239.i.i = getelementptr i8, ptr %lsr.iv226.i.i, i64 -17408
  %.362.i.i = load <8 x double>, ptr %scevgep239.i.i, align 8, !noalias !72
  %scevgep238.i.i = getelementptr i8, ptr %lsr.iv226.i.i, i64 -16384
  %.373.i.i156 = load <8 x double>, ptr %scevgep238.i.i, align 8, !noalias !72
  %.6.i.i6.i = fmul contract <8 x double> %.362.i.i, %.362.i.i
  %.6.i111.i.i = fmul contract <8 x double> %.373.i.i156, %.373.i.i156
  %.6.i112.i7.i = fsub contract <8 x double> %.6.i.i6.i, %.6.i111.i.i
  %.6.i113.i.i = fmul contract <8 x double> %.362.i.i, %.373.i.i156
  %.8.i.i8.i = fmul contract <8 x double> %.6.i113.i.i, splat (double 2.000000e+00)
  %.610.i.i157 = load double, ptr %sunkaddr8.i.i, align 8, !noalias !72
  %.640.i.i = load double, ptr %sunkaddr9.i.i, align 8, !noalias !72
  %.669.i.i158 = load double, ptr %sunkaddr10.i.i, align 8, !noalias !72
  %.670.i.i159 = insertelement <8 x double> poison, double %.669.i.i158, i64 0
  %.671.i.i = shufflevector <8 x double> %.670.i.i159, <8 x double> poison, <8 x i32> zeroinitializer
  %.672.i.i160 = insertelement <8 x double> poison, double %.640.i.i, i64 0
  %.673.i.i161 = shufflevector <8 x double> %.672.i.i160, <8 x double> poison, <8 x i32> zeroinitializer
  %.674.i.i162 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.362.i.i, <8 x double> %.673.i.i161, <8 x double> %.671.i.i)
  %.675.i.i163 = insertelement <8 x double> poison, double %.610.i.i157, i64 0
  %.676.i.i164 = shufflevector <8 x double> %.675.i.i163, <8 x double> poison, <8 x i32> zeroinitializer
  %.677.i.i165 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.373.i.i156, <8 x double> %.676.i.i164, <8 x double> %.674.i.i162)
  %.707.i.i166 = load double, ptr %sunkaddr11.i.i148, align 8, !noalias !72
  %.737.i.i = load double, ptr %sunkaddr12.i.i149, align 8, !noalias !72
  %.741.i.i = insertelement <8 x double> poison, double %.737.i.i, i64 0
  %.742.i.i = shufflevector <8 x double> %.741.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.743.i.i167 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i112.i7.i, <8 x double> %.742.i.i, <8 x double> %.677.i.i165)
  %.744.i.i168 = insertelement <8 x double> poison, double %.707.i.i166, i64 0
  %.745.i.i169 = shufflevector <8 x double> %.744.i.i168, <8 x double> poison, <8 x i32> zeroinitializer
  %.746.i.i170 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i.i8.i, <8 x double> %.745.i.i169, <8 x double> %.743.i.i167)
  %scevgep237.i.i = getelementptr i8, ptr %lsr.iv226.i.i, i64 -11264
  store <8 x double> %.746.i.i170, ptr %scevgep237.i.i, align 8, !noalias !72
  %.877.i.i = load double, ptr %sunkaddr13.i.i, align 8, !noalias !72
  %.907.i.i = load double, ptr %sunkaddr14.i.i150, align 8, !noalias !72
  %.936.i9.i = load double, ptr %sunkaddr15.i.i, align 8, !noalias !72
  %.937.i.i = insertelement <8 x double> poison, double %.936.i9.i, i64 0
  %.938.i.i = shufflevector <8 x double> %.937.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.939.i.i = insertelement <8 x double> poison, double %.907.i.i, i64 0
  %.940.i.i = shufflevector <8 x double> %.939.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.941.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.362.i.i, <8 x double> %.940.i.i, <8 x double> %.938.i.i)
  %.942.i10.i = insertelement <8 x double> poison, double %.877.i.i, i64 0
  %.943.i.i = shufflevector <8 x double> %.942.i10.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.944.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.373.i.i156, <8 x double> %.943.i.i, <8 x double> %.941.i.i)
  %.974.i.i = load double, ptr %sunkaddr16.i.i151, align 8, !noalias !72
  %.1004.i.i = load double, ptr %sunkaddr17.i.i, align 8, !noalias !72
  %.1008.i.i = insertelement <8 x double> poison, double %.1004.i.i, i64 0
  %.1009.i.i = shufflevector <8 x double> %.1008.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1010.i11.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i112.i7.i, <8 x double> %.1009.i.i, <8 x double> %.944.i.i)
  %.1011.i.i = insertelement <8 x double> poison, double %.974.i.i, i64 0
  %.1012.i.i = shufflevector <8 x double> %.1011.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1013.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i.i8.i, <8 x double> %.1012.i.i, <8 x double> %.1010.i11.i)
  %scevgep236.i.i = getelementptr i8, ptr %lsr.iv226.i.i, i64 -9216
  store <8 x double> %.1013.i.i, ptr %scevgep236.i.i, align 8, !noalias !72
  %.1144.i.i = load double, ptr %sunkaddr8.i.i, align 8, !noalias !72
  %.1174.i.i = load double, ptr %sunkaddr9.i.i, align 8, !noalias !72
  %.1175.i.i = fsub contract double 0.000000e+00, %.1174.i.i
  %.6.i129.i12.i = insertelement <8 x double> poison, double %.1175.i.i, i64 0
  %.7.i.i13.i = shufflevector <8 x double> %.6.i129.i12.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.8.i130.i.i = fmul contract <8 x double> %.373.i.i156, %.7.i.i13.i
  %.1200.i.i171 = insertelement <8 x double> poison, double %.1144.i.i, i64 0
  %.1201.i.i172 = shufflevector <8 x double> %.1200.i.i171, <8 x double> poison, <8 x i32> zeroinitializer
  %.1202.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.362.i.i, <8 x double> %.1201.i.i172, <8 x double> %.8.i130.i.i)
  %.1232.i.i = load double, ptr %sunkaddr11.i.i148, align 8, !noalias !72
  %.1233.i.i = fmul contract double %.1232.i.i, 2.000000e+00
  %.1263.i.i = load double, ptr %sunkaddr12.i.i149, align 8, !noalias !72
  %.1267.i.i = fmul contract double %.1263.i.i, -2.000000e+00
  %.1268.i.i = insertelement <8 x double> poison, double %.1267.i.i, i64 0
  %.1269.i.i = shufflevector <8 x double> %.1268.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1270.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i.i8.i, <8 x double> %.1269.i.i, <8 x double> %.1202.i.i)
  %.1271.i.i = insertelement <8 x double> poison, double %.1233.i.i, i64 0
  %.1272.i.i = shufflevector <8 x double> %.1271.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1273.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i112.i7.i, <8 x double> %.1272.i.i, <8 x double> %.1270.i.i)
  %scevgep235.i.i = getelementptr i8, ptr %lsr.iv226.i.i, i64 -7168
  store <8 x double> %.1273.i.i, ptr %scevgep235.i.i, align 8, !noalias !72
  %.1404.i.i = load double, ptr %sunkaddr13.i.i, align 8, !noalias !72
  %.1434.i.i = load double, ptr %sunkaddr14.i.i150, align 8, !noalias !72
  %.1435.i.i = fsub contract double 0.000000e+00, %.1434.i.i
  %.6.i136.i.i = insertelement <8 x double> poison, double %.1435.i.i, i64 0
  %.7.i137.i.i = shufflevector <8 x double> %.6.i136.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.8.i138.i.i = fmul contract <8 x double> %.373.i.i156, %.7.i137.i.i
  %.1460.i.i = insertelement <8 x double> poison, double %.1404.i.i, i64 0
  %.1461.i.i = shufflevector <8 x double> %.1460.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1462.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.362.i.i, <8 x double> %.1461.i.i, <8 x double> %.8.i138.i.i)
  %.1492.i.i = load double, ptr %sunkaddr16.i.i151, align 8, !noalias !72
  %.1493.i.i = fmul contract double %.1492.i.i, 2.000000e+00
  %.1523.i.i = load double, ptr %sunkaddr17.i.i, align 8, !noalias !72
  %.1527.i14.i = fmul contract double %.1523.i.i, -2.000000e+00
  %.1528.i.i = insertelement <8 x double> poison, double %.1527.i14.i, i64 0
  %.1529.i.i = shufflevector <8 x double> %.1528.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1530.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i.i8.i, <8 x double> %.1529.i.i, <8 x double> %.1462.i.i)
  %.1531.i.i173 = insertelement <8 x double> poison, double %.1493.i.i, i64 0
  %.1532.i.i174 = shufflevector <8 x double> %.1531.i.i173, <8 x double> poison, <8 x i32> zeroinitializer
  %.1533.i.i175 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i112.i7.i, <8 x double> %.1532.i.i174, <8 x double> %.1530.i.i)
  %scevgep234.i.i = getelementptr i8, ptr %lsr.iv226.i.i, i64 -5120
  store <8 x double> %.1533.i.i175, ptr %scevgep234.i.i, align 8, !noalias !72
  %.1664.i.i = load double, ptr %sunkaddr18.i.i, align 8, !noalias !72
  %.1694.i.i = load double, ptr %sunkaddr19.i.i152, align 8, !noalias !72
  %.1723.i.i = load double, ptr %lsr.iv, align 8, !noalias !72
  %.1724.i.i = insertelement <8 x double> poison, double %.1723.i.i, i64 0
  %.1725.i.i = shufflevector <8 x double> %.1724.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1726.i.i = insertelement <8 x double> poison, double %.1694.i.i, i64 0
  %.1727.i.i = shufflevector <8 x double> %.1726.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1728.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.362.i.i, <8 x double> %.1727.i.i, <8 x double> %.1725.i.i)
  %.1729.i.i = insertelement <8 x double> poison, double %.1664.i.i, i64 0
  %.1730.i.i = shufflevector <8 x double> %.1729.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1731.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.373.i.i156, <8 x double> %.1730.i.i, <8 x double> %.1728.i.i)
  %.1761.i.i = load double, ptr %sunkaddr.i.i153, align 8, !noalias !72
  %.1791.i.i = load double, ptr %sunkaddr20.i.i154, align 8, !noalias !72
  %.1795.i.i = insertelement <8 x double> poison, double %.1791.i.i, i64 0
  %.1796.i.i = shufflevector <8 x double> %.1795.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1797.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i112.i7.i, <8 x double> %.1796.i.i, <8 x double> %.1731.i.i)
  %.1798.i.i = insertelement <8 x double> poison, double %.1761.i.i, i64 0
  %.1799.i.i = shufflevector <8 x double> %.1798.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1800.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i.i8.i, <8 x double> %.1799.i.i, <8 x double> %.1797.i.i)
  %scevgep233.i15.i = getelementptr i8, ptr %lsr.iv226.i.i, i64 -3072
  store <8 x double> %.1800.i.i, ptr %scevgep233.i15.i, align 8, !noalias !72
  %.1931.i.i = load double, ptr %sunkaddr21.i.i, align 8, !noalias !72
  %.1961.i.i176 = load double, ptr %sunkaddr22.i.i, align 8, !noalias !72
  %.1990.i.i = load double, ptr %sunkaddr23.i.i, align 8, !noalias !72
  %.1991.i.i = insertelement <8 x double> poison, double %.1990.i.i, i64 0
  %.1992.i.i = shufflevector <8 x double> %.1991.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1993.i.i = insertelement <8 x double> poison, double %.1961.i.i176, i64 0
  %.1994.i.i177 = shufflevector <8 x double> %.1993.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1995.i.i178 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.362.i.i, <8 x double> %.1994.i.i177, <8 x double> %.1992.i.i)
  %.1996.i.i = insertelement <8 x double> poison, double %.1931.i.i, i64 0
  %.1997.i.i = shufflevector <8 x double> %.1996.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1998.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.373.i.i156, <8 x double> %.1997.i.i, <8 x double> %.1995.i.i178)
  %.2028.i.i = load double, ptr %sunkaddr24.i.i, align 8, !noalias !72
  %.2058.i.i = load double, ptr %sunkaddr25.i.i, align 8, !noalias !72
  %.2062.i.i = insertelement <8 x double> poison, double %.2058.i.i, i64 0
  %.2063.i.i = shufflevector <8 x double> %.2062.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.2064.i.i179 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i112.i7.i, <8 x double> %.2063.i.i, <8 x double> %.1998.i.i)
  %.2065.i.i = insertelement <8 x double> poison, double %.2028.i.i, i64 0
  %.2066.i.i = shufflevector <8 x double> %.2065.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.2067.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i.i8.i, <8 x double> %.2066.i.i, <8 x double> %.2064.i.i179)
  %scevgep232.i16.i = getelementptr i8, ptr %lsr.iv226.i.i, i64 -1024
  store <8 x double> %.2067.i.i, ptr %scevgep232.i16.i, align 8, !noalias !72
  %scevgep231.i.i = getelementptr i8, ptr %lsr.iv226.i.i, i64 -10240
  store <8 x double> zeroinitializer, ptr %scevgep231.i.i, align 8, !noalias !72
  %scevgep230.i.i = getelementptr i8, ptr %lsr.iv226.i.i, i64 -8192
  store <8 x double> zeroinitializer, ptr %scevgep230.i.i, align 8, !noalias !72
  %scevgep229.i.i = getelementptr i8, ptr %lsr.iv226.i.i, i64 -6144
  store <8 x double> zeroinitializer, ptr %scevgep229.i.i, align 8, !noalias !72
  %scevgep228.i.i = getelementptr i8, ptr %lsr.iv226.i.i, i64 -4096
  store <8 x double> zeroinitializer, ptr %scevgep228.i.i, align 8, !noalias !72
  %scevgep227.i.i = getelementptr i8, ptr %lsr.iv226.i.i, i64 -2048
  store <8 x double> zeroinitializer, ptr %scevgep227.i.i, align 8, !noalias !72
  store <8 x double> zeroinitializer, ptr %lsr.iv226.i.i, align 8, !noalias !72
  %scevgep.i17.i = getelementptr i8, ptr %lsr.iv226.i.i, i64 64
  %lsr.iv.next7.i.i = add nsw i64 %lsr.iv6.i.i, -1
  %.311.i.i = icmp sgt i64 %lsr.iv6.i.i, 5
  br i1 %.311.i.i, label %B158.if.i.i, label %B778.i

B778.i:                                           ; preds = %B158.if.i.i, %B590.i
  %.1031.i = load double, ptr %sunkaddr82.i, align 8, !noalias !51
  %.1401.i.i = insertelement <8 x double> poison, double %.1031.i, i64 0
  %.1402.i.i = shufflevector <8 x double> %.1401.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  br i1 %.93.inv.i.i, label %B918.i, label %B52.lr.ph.i.i

B52.lr.ph.i.i:                                    ; preds = %B778.i
  %.1061.i = load i64, ptr %.500.i, align 8, !noalias !51
  %.1001.i = load double, ptr %sunkaddr85.i, align 8, !noalias !51
  %.6.i980.i.i = insertelement <8 x double> poison, double %.1001.i, i64 0
  %.7.i.i35.i = shufflevector <8 x double> %.6.i980.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %261 = icmp eq i64 %.1061.i, 1
  br label %B52.i.i

B52.i.i:                                          ; preds = %B1190.i.i, %B52.lr.ph.i.i
  %.127.sroa.0.0923.i.i = phi i64 [ 0, %B52.lr.ph.i.i ], [ %.127.sroa.0.0.i.i, %B1190.i.i ]
  %.82.1922.in.i.i = phi i64 [ %241, %B52.lr.ph.i.i ], [ %272, %B1190.i.i ]
  %.79.1921.i.i = phi i64 [ 8, %B52.lr.ph.i.i ], [ %.79.1.i.i, %B1190.i.i ]
  %.267.i.i180 = getelementptr inbounds double, ptr %.688.i, i64 %.127.sroa.0.0923.i.i
  %.269.i.i = load <8 x double>, ptr %.267.i.i180, align 8, !noalias !75
  %sunkaddr.i36.i = shl i64 %.127.sroa.0.0923.i.i, 3
  %sunkaddr1161.i.i = getelementptr inbounds i8, ptr %.688.i, i64 %sunkaddr.i36.i
  %sunkaddr1162.i.i = getelementptr inbounds nuw i8, ptr %sunkaddr1161.i.i, i64 1024
  %.365.i.i181 = load <8 x double>, ptr %sunkaddr1162.i.i, align 8, !noalias !75
  %sunkaddr1165.i.i = getelementptr inbounds nuw i8, ptr %sunkaddr1161.i.i, i64 2048
  %.460.i.i182 = load <8 x double>, ptr %sunkaddr1165.i.i, align 8, !noalias !75
  %sunkaddr1168.i.i = getelementptr inbounds nuw i8, ptr %sunkaddr1161.i.i, i64 3072
  %.556.i.i183 = load <8 x double>, ptr %sunkaddr1168.i.i, align 8, !noalias !75
  %sunkaddr1171.i.i = getelementptr inbounds nuw i8, ptr %sunkaddr1161.i.i, i64 10240
  %.652.i.i184 = load <8 x double>, ptr %sunkaddr1171.i.i, align 8, !noalias !75
  %sunkaddr1174.i.i = getelementptr inbounds nuw i8, ptr %sunkaddr1161.i.i, i64 11264
  %.748.i.i = load <8 x double>, ptr %sunkaddr1174.i.i, align 8, !noalias !75
  %262 = fneg contract <8 x double> %.365.i.i181
  %.8.i.i37.i = fmul contract <8 x double> %.748.i.i, %262
  %.800.i.i185 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.652.i.i184, <8 x double> %.269.i.i, <8 x double> %.8.i.i37.i)
  %.6.i960.i.i = fmul contract <8 x double> %.269.i.i, %.748.i.i
  %.825.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.652.i.i184, <8 x double> %.365.i.i181, <8 x double> %.6.i960.i.i)
  %sunkaddr1177.i.i = getelementptr inbounds nuw i8, ptr %sunkaddr1161.i.i, i64 12288
  %.945.i.i = load <8 x double>, ptr %sunkaddr1177.i.i, align 8, !noalias !75
  %sunkaddr1180.i.i = getelementptr inbounds nuw i8, ptr %sunkaddr1161.i.i, i64 13312
  %.1041.i.i = load <8 x double>, ptr %sunkaddr1180.i.i, align 8, !noalias !75
  %263 = fneg contract <8 x double> %.556.i.i183
  %.8.i972.i.i = fmul contract <8 x double> %.1041.i.i, %263
  %.1093.i.i186 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.945.i.i, <8 x double> %.460.i.i182, <8 x double> %.8.i972.i.i)
  %.6.i973.i.i = fmul contract <8 x double> %.460.i.i182, %.1041.i.i
  %.1118.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.945.i.i, <8 x double> %.556.i.i183, <8 x double> %.6.i973.i.i)
  br i1 %261, label %B864.i.i, label %B1190.i.i

B864.i.i:                                         ; preds = %B52.i.i
  %sunkaddr91.i = getelementptr i8, ptr %sunkaddr1161.i.i, i64 4096
  %.1249.i.i = load <8 x double>, ptr %sunkaddr91.i, align 8, !noalias !75
  %sunkaddr96.i = getelementptr i8, ptr %sunkaddr1161.i.i, i64 5120
  %.1345.i.i = load <8 x double>, ptr %sunkaddr96.i, align 8, !noalias !75
  %.6.i979.i.i = fsub contract <8 x double> splat (double 1.000000e+00), %.1249.i.i
  %.8.i981.i.i = fmul contract <8 x double> %.7.i.i35.i, %.6.i979.i.i
  %.1413.i.i273 = getelementptr inbounds double, ptr %.311.i, i64 %.127.sroa.0.0923.i.i
  %.1415.i.i = load <8 x double>, ptr %.1413.i.i273, align 8, !noalias !75
  %.8.i982.i.i = fmul contract <8 x double> %.1415.i.i, splat (double 0xC01921FB54442D18)
  %.1403.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1345.i.i, <8 x double> %.1402.i.i, <8 x double> %.8.i981.i.i)
  %.6.i983.i.i = fmul contract <8 x double> %.1403.i.i, %.8.i982.i.i
  %.1469.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i983.i.i, <8 x double> splat (double 0x3FE45F306DC9C883), <8 x double> splat (double 0x4338000000000000))
  %.8.i984.i.i = fadd contract <8 x double> %.1469.i.i, splat (double 0xC338000000000000)
  %.1510.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i984.i.i, <8 x double> splat (double 0xBFF921FB54442D18), <8 x double> %.6.i983.i.i)
  %.1527.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i984.i.i, <8 x double> splat (double 0xBC91A62633145C07), <8 x double> %.1510.i.i)
  %.6.i985.i.i = fmul contract <8 x double> %.1527.i.i, %.1527.i.i
  %.6.i986.i.i = fmul contract <8 x double> %.1527.i.i, %.6.i985.i.i
  %.1556.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i985.i.i, <8 x double> splat (double 0xBD6AE7F3E733B81F), <8 x double> splat (double 0x3DE6124613A86D09))
  %.1559.i.i274 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i985.i.i, <8 x double> %.1556.i.i, <8 x double> splat (double 0xBE5AE64567F544E4))
  %.1562.i.i275 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i985.i.i, <8 x double> %.1559.i.i274, <8 x double> splat (double 0x3EC71DE3A556C734))
  %.1565.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i985.i.i, <8 x double> %.1562.i.i275, <8 x double> splat (double 0xBF2A01A01A01A01A))
  %.1568.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i985.i.i, <8 x double> %.1565.i.i, <8 x double> splat (double 0x3F81111111111111))
  %.1571.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i985.i.i, <8 x double> %.1568.i.i, <8 x double> splat (double 0xBFC5555555555555))
  %.1596.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i986.i.i, <8 x double> %.1571.i.i, <8 x double> %.1527.i.i)
  %.1601.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i985.i.i, <8 x double> splat (double 0x3D2AE7F3E733B81F), <8 x double> splat (double 0xBDA93974A8C07C9D))
  %.1604.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i985.i.i, <8 x double> %.1601.i.i, <8 x double> splat (double 0x3E21EED8EFF8D898))
  %.1607.i.i276 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i985.i.i, <8 x double> %.1604.i.i, <8 x double> splat (double 0xBE927E4FB7789F5C))
  %.1610.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i985.i.i, <8 x double> %.1607.i.i276, <8 x double> splat (double 0x3EFA01A01A01A01A))
  %.1613.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i985.i.i, <8 x double> %.1610.i.i, <8 x double> splat (double 0xBF56C16C16C16C17))
  %.1616.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i985.i.i, <8 x double> %.1613.i.i, <8 x double> splat (double 0x3FA5555555555555))
  %.1619.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i985.i.i, <8 x double> %.1616.i.i, <8 x double> splat (double -5.000000e-01))
  %.1622.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i985.i.i, <8 x double> %.1619.i.i, <8 x double> splat (double 1.000000e+00))
  %.1623.i.i = bitcast <8 x double> %.1469.i.i to <8 x i64>
  %.1624.i.i = bitcast <8 x double> %.1596.i.i to <8 x i64>
  %.1625.i.i = bitcast <8 x double> %.1622.i.i to <8 x i64>
  %.6.i987.i.i = xor <8 x i64> %.1625.i.i, %.1624.i.i
  %.8.i988.i.i = and <8 x i64> %.1623.i.i, splat (i64 1)
  %264 = icmp eq <8 x i64> %.8.i988.i.i, zeroinitializer
  %.6.i990.i.i = select <8 x i1> %264, <8 x i64> zeroinitializer, <8 x i64> %.6.i987.i.i
  %.8.i991.i.i = shl <8 x i64> %.1623.i.i, splat (i64 62)
  %.8.i992.i.i = and <8 x i64> %.8.i991.i.i, splat (i64 -9223372036854775808)
  %.8.i994.i.i = add <8 x i64> %.8.i991.i.i, splat (i64 4611686018427387904)
  %.8.i995.i.i = and <8 x i64> %.8.i994.i.i, splat (i64 -9223372036854775808)
  %265 = xor <8 x i64> %.8.i992.i.i, %.1624.i.i
  %.6.i997.i.i = xor <8 x i64> %265, %.6.i990.i.i
  %266 = bitcast <8 x i64> %.6.i997.i.i to <8 x double>
  %267 = xor <8 x i64> %.8.i995.i.i, %.1625.i.i
  %.6.i999.i.i = xor <8 x i64> %267, %.6.i990.i.i
  %268 = bitcast <8 x i64> %.6.i999.i.i to <8 x double>
  br label %B1190.i.i

B1190.i.i:                                        ; preds = %B864.i.i, %B52.i.i
  %sine.2.1.i.i = phi <8 x double> [ %266, %B864.i.i ], [ zeroinitializer, %B52.i.i ]
  %cosine.2.1.i.i = phi <8 x double> [ %268, %B864.i.i ], [ splat (double 1.000000e+00), %B52.i.i ]
  %sunkaddr99.i = getelementptr i8, ptr %sunkaddr1161.i.i, i64 8192
  store <8 x double> %cosine.2.1.i.i, ptr %sunkaddr99.i, align 8, !noalias !75
  %sunkaddr102.i = getelementptr i8, ptr %sunkaddr1161.i.i, i64 9216
  store <8 x double> %sine.2.1.i.i, ptr %sunkaddr102.i, align 8, !noalias !75
  %.6.i1005.i.i = fadd contract <8 x double> %.800.i.i185, %.1093.i.i186
  %.6.i1006.i.i = fadd contract <8 x double> %.825.i.i, %.1118.i.i
  %269 = fneg contract <8 x double> %sine.2.1.i.i
  %.8.i1008.i.i = fmul contract <8 x double> %.6.i1006.i.i, %269
  %.2273.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i1005.i.i, <8 x double> %cosine.2.1.i.i, <8 x double> %.8.i1008.i.i)
  %.6.i1009.i.i = fmul contract <8 x double> %.6.i1006.i.i, %cosine.2.1.i.i
  %.2298.i.i187 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i1005.i.i, <8 x double> %sine.2.1.i.i, <8 x double> %.6.i1009.i.i)
  %.2408.i.i = getelementptr inbounds double, ptr %.432, i64 %.127.sroa.0.0923.i.i
  %.2410.i.i = load <8 x double>, ptr %.2408.i.i, align 8, !noalias !75
  %sunkaddr104.i = getelementptr i8, ptr %.432, i64 %sunkaddr.i36.i
  %sunkaddr105.i = getelementptr i8, ptr %sunkaddr104.i, i64 1024
  %.2506.i.i = load <8 x double>, ptr %sunkaddr105.i, align 8, !noalias !75
  %270 = fneg contract <8 x double> %.2506.i.i
  %.8.i1021.i.i = fmul contract <8 x double> %.2298.i.i187, %270
  %.2559.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.2273.i.i, <8 x double> %.2410.i.i, <8 x double> %.8.i1021.i.i)
  %.6.i1022.i.i = fmul contract <8 x double> %.2298.i.i187, %.2410.i.i
  %.2584.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.2273.i.i, <8 x double> %.2506.i.i, <8 x double> %.6.i1022.i.i)
  %sunkaddr108.i = getelementptr i8, ptr %sunkaddr1161.i.i, i64 6144
  store <8 x double> %.2559.i.i, ptr %sunkaddr108.i, align 8, !noalias !75
  %sunkaddr111.i = getelementptr i8, ptr %sunkaddr1161.i.i, i64 7168
  store <8 x double> %.2584.i.i, ptr %sunkaddr111.i, align 8, !noalias !75
  %.137.i.i = icmp samesign ugt i64 %.82.1922.in.i.i, 1
  %.150.i38.i = add i64 %.79.1921.i.i, 8
  %.79.1.i.i = select i1 %.137.i.i, i64 %.150.i38.i, i64 %.79.1921.i.i
  %271 = tail call i64 @llvm.smax.i64(i64 %.82.1922.in.i.i, i64 2)
  %272 = add nsw i64 %271, -1
  %.127.sroa.0.0.i.i = select i1 %.137.i.i, i64 %.79.1921.i.i, i64 0
  br i1 %.137.i.i, label %B52.i.i, label %B918.i

B918.i:                                           ; preds = %B1190.i.i, %B742.i.i, %B742.i, %B778.i, %B492.i
  %lsr.iv.next194.i = add i64 %lsr.iv193.i, 27648
  %exitcond.not.i188 = icmp eq i64 %.641.i, %.104.i
  br i1 %exitcond.not.i188, label %B950.if.lr.ph.i, label %B452.if.i

B950.if.lr.ph.i:                                  ; preds = %B918.i
  %brmerge.not.i = select i1 %.761.i, i1 %.438.inv.i.i, i1 false
  %sunkaddr37.i.i = getelementptr i8, ptr %lsr.iv, i64 88
  %sunkaddr38.i.i = getelementptr i8, ptr %lsr.iv, i64 96
  %.5541.i.i = getelementptr i8, ptr %lsr.iv, i64 120
  %.5861.i.i = getelementptr i8, ptr %lsr.iv, i64 128
  %.6181.i.i = getelementptr i8, ptr %lsr.iv, i64 136
  %.6501.i.i = getelementptr i8, ptr %lsr.iv, i64 144
  br label %B950.if.i

B268.if.i.i:                                      ; preds = %_ZN17bnserve_inference14adjoint_kernel7_source14_through_pairsB4v376B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i, %B268.if.i.i
  %lsr.iv56.i = phi i64 [ %lsr.iv.next57.i, %B268.if.i.i ], [ %242, %_ZN17bnserve_inference14adjoint_kernel7_source14_through_pairsB4v376B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i ]
  %lsr.iv178.i = phi ptr [ %scevgep.i272, %B268.if.i.i ], [ %.432, %_ZN17bnserve_inference14adjoint_kernel7_source14_through_pairsB4v376B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i ]
  %scevgep187.i = getelementptr i8, ptr %lsr.iv178.i, i64 6144
  %.608.i.i = load <8 x double>, ptr %scevgep187.i, align 8, !noalias !78
  %scevgep186.i = getelementptr i8, ptr %lsr.iv178.i, i64 7168
  %.703.i.i267 = load <8 x double>, ptr %scevgep186.i, align 8, !noalias !78
  %scevgep180.i = getelementptr i8, ptr %lsr.iv178.i, i64 %lsr.iv.i196
  %scevgep181.i = getelementptr i8, ptr %scevgep180.i, i64 -1024
  %.797.i.i268 = load <8 x double>, ptr %scevgep181.i, align 8, !noalias !78
  %.892.i.i269 = load <8 x double>, ptr %scevgep180.i, align 8, !noalias !78
  %273 = fneg contract <8 x double> %.892.i.i269
  %.8.i.i40.i = fmul contract <8 x double> %.703.i.i267, %273
  %.945.i41.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.608.i.i, <8 x double> %.797.i.i268, <8 x double> %.8.i.i40.i)
  %.6.i127.i.i = fmul contract <8 x double> %.703.i.i267, %.797.i.i268
  %.970.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.608.i.i, <8 x double> %.892.i.i269, <8 x double> %.6.i127.i.i)
  %scevgep185.i = getelementptr i8, ptr %lsr.iv178.i, i64 4096
  %.1000.i.i270 = load <8 x double>, ptr %scevgep185.i, align 8, !noalias !78
  %scevgep184.i = getelementptr i8, ptr %lsr.iv178.i, i64 2048
  %.1010.i.i = load <8 x double>, ptr %scevgep184.i, align 8, !noalias !78
  %.8.i128.i.i = fadd contract <8 x double> %.1010.i.i, splat (double 1.000000e+00)
  %.6.i129.i.i = fdiv contract <8 x double> %.945.i41.i, %.8.i128.i.i
  %.6.i130.i.i = fadd contract <8 x double> %.1000.i.i270, %.6.i129.i.i
  store <8 x double> %.6.i130.i.i, ptr %scevgep185.i, align 8, !noalias !78
  %scevgep183.i = getelementptr i8, ptr %lsr.iv178.i, i64 3072
  %.1102.i.i = load <8 x double>, ptr %scevgep183.i, align 8, !noalias !78
  %scevgep182.i = getelementptr i8, ptr %lsr.iv178.i, i64 5120
  %.1112.i.i271 = load <8 x double>, ptr %scevgep182.i, align 8, !noalias !78
  %.8.i131.i.i = fmul contract <8 x double> %.970.i.i, splat (double 4.000000e+00)
  %.1139.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1102.i.i, <8 x double> %.1102.i.i, <8 x double> splat (double 4.000000e+00))
  %.6.i132.i.i = fdiv contract <8 x double> %.8.i131.i.i, %.1139.i.i
  %.6.i133.i.i = fsub contract <8 x double> %.1112.i.i271, %.6.i132.i.i
  store <8 x double> %.6.i133.i.i, ptr %scevgep182.i, align 8, !noalias !78
  %scevgep.i272 = getelementptr i8, ptr %lsr.iv178.i, i64 64
  %lsr.iv.next57.i = add nsw i64 %lsr.iv56.i, -1
  %.480.i.i = icmp sgt i64 %lsr.iv56.i, 5
  br i1 %.480.i.i, label %B268.if.i.i, label %B1158.i

B1158.i:                                          ; preds = %B268.if.i.i, %_ZN17bnserve_inference14adjoint_kernel7_source14_through_pairsB4v376B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i
  br i1 %"$phi420.0.2.0.i", label %B1258.i, label %B1350.i

B1258.i:                                          ; preds = %B1158.i
  %.120.i19.i = load double, ptr %sunkaddr10.i.i, align 8, !noalias !81
  %.150.i20.i = load double, ptr %sunkaddr9.i.i, align 8, !noalias !81
  %.151.i.i = fadd contract double %.120.i19.i, %.150.i20.i
  %.181.i.i = load double, ptr %sunkaddr12.i.i149, align 8, !noalias !81
  %.185.i.i = fadd contract double %.151.i.i, %.181.i.i
  %.219.i.i = load double, ptr %sunkaddr15.i.i, align 8, !noalias !81
  %.249.i.i242 = load double, ptr %sunkaddr14.i.i150, align 8, !noalias !81
  %.250.i.i243 = fadd contract double %.219.i.i, %.249.i.i242
  %.280.i.i244 = load double, ptr %sunkaddr17.i.i, align 8, !noalias !81
  %.284.i.i = fadd contract double %.250.i.i243, %.280.i.i244
  %.1615.i.i = insertelement <8 x double> poison, double %.185.i.i, i64 0
  %.1616.i21.i = shufflevector <8 x double> %.1615.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1844.i.i = insertelement <8 x double> poison, double %.284.i.i, i64 0
  %.1845.i.i = shufflevector <8 x double> %.1844.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  br i1 %.93.inv.i.i, label %_ZN17bnserve_inference14adjoint_kernel9_standing18pull_back_standingB4v419B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEbx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i, label %B246.i.i

B246.i.i:                                         ; preds = %B1258.i, %B962.i.i
  %.377.sroa.0.0487.i.i = phi i64 [ %.377.sroa.0.0.i.i, %B962.i.i ], [ 0, %B1258.i ]
  %.332.1486.in.i.i = phi i64 [ %276, %B962.i.i ], [ %241, %B1258.i ]
  %.329.1485.i.i = phi i64 [ %.329.1.i.i, %B962.i.i ], [ 8, %B1258.i ]
  %by_time.2.0484.i.i = phi <8 x double> [ %.6.i528.i.i, %B962.i.i ], [ zeroinitializer, %B1258.i ]
  %by_plus.2.0483.i.i = phi <8 x double> [ %.6.i574.i.i253, %B962.i.i ], [ zeroinitializer, %B1258.i ]
  %by_cross.2.0482.i.i = phi <8 x double> [ %.6.i578.i.i, %B962.i.i ], [ zeroinitializer, %B1258.i ]
  %sunkaddr.i22.i = shl i64 %.377.sroa.0.0487.i.i, 3
  %sunkaddr707.i.i = getelementptr inbounds i8, ptr %.432, i64 %sunkaddr.i22.i
  %sunkaddr708.i.i = getelementptr inbounds nuw i8, ptr %sunkaddr707.i.i, i64 6144
  %.519.i.i = load <8 x double>, ptr %sunkaddr708.i.i, align 8, !noalias !81
  %sunkaddr711.i.i = getelementptr inbounds nuw i8, ptr %sunkaddr707.i.i, i64 7168
  %.615.i.i245 = load <8 x double>, ptr %sunkaddr711.i.i, align 8, !noalias !81
  %sunkaddr713.i.i = getelementptr inbounds i8, ptr %.1249.i, i64 %sunkaddr.i22.i
  %sunkaddr714.i.i = getelementptr inbounds nuw i8, ptr %sunkaddr713.i.i, i64 6144
  %.724.i.i = load <8 x double>, ptr %sunkaddr714.i.i, align 8, !noalias !81
  %sunkaddr717.i.i = getelementptr inbounds nuw i8, ptr %sunkaddr713.i.i, i64 7168
  %.820.i.i = load <8 x double>, ptr %sunkaddr717.i.i, align 8, !noalias !81
  %sunkaddr720.i.i = getelementptr inbounds nuw i8, ptr %sunkaddr707.i.i, i64 8192
  %.915.i.i = load <8 x double>, ptr %sunkaddr720.i.i, align 8, !noalias !81
  %sunkaddr723.i.i = getelementptr inbounds nuw i8, ptr %sunkaddr707.i.i, i64 9216
  %.1011.i23.i = load <8 x double>, ptr %sunkaddr723.i.i, align 8, !noalias !81
  %.6.i.i24.i = fmul contract <8 x double> %.724.i.i, %.915.i.i
  %.6.i526.i.i = fmul contract <8 x double> %.820.i.i, %.1011.i23.i
  %.6.i527.i.i = fsub contract <8 x double> %.6.i.i24.i, %.6.i526.i.i
  %.6.i528.i.i = fadd contract <8 x double> %by_time.2.0484.i.i, %.6.i527.i.i
  br i1 %.761.i, label %B778.i.i, label %B962.i.i

B778.i.i:                                         ; preds = %B246.i.i
  %.1209.i.i = getelementptr inbounds double, ptr %.432, i64 %.377.sroa.0.0487.i.i
  %.1211.i.i265 = load <8 x double>, ptr %.1209.i.i, align 8, !noalias !81
  %sunkaddr3.i.i = getelementptr i8, ptr %sunkaddr707.i.i, i64 1024
  %.1307.i.i = load <8 x double>, ptr %sunkaddr3.i.i, align 8, !noalias !81
  %274 = fneg contract <8 x double> %.1307.i.i
  %.8.i.i25.i = fmul contract <8 x double> %.615.i.i245, %274
  %.6.i535.i.i = fmul contract <8 x double> %.615.i.i245, %.1211.i.i265
  %.1365.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.519.i.i, <8 x double> %.1211.i.i265, <8 x double> %.8.i.i25.i)
  %.1390.i.i266 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.519.i.i, <8 x double> %.1307.i.i, <8 x double> %.6.i535.i.i)
  br label %B962.i.i

B962.i.i:                                         ; preds = %B778.i.i, %B246.i.i
  %ai.2.1.i.i = phi <8 x double> [ %.1390.i.i266, %B778.i.i ], [ %.615.i.i245, %B246.i.i ]
  %ar.2.1.i.i = phi <8 x double> [ %.1365.i.i, %B778.i.i ], [ %.519.i.i, %B246.i.i ]
  %sunkaddr6.i.i = getelementptr i8, ptr %sunkaddr713.i.i, i64 22528
  %.1614.i.i = load <8 x double>, ptr %sunkaddr6.i.i, align 8, !noalias !81
  %.1617.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %ar.2.1.i.i, <8 x double> %.1616.i21.i, <8 x double> %.1614.i.i)
  store <8 x double> %.1617.i.i, ptr %sunkaddr6.i.i, align 8, !noalias !81
  %sunkaddr9.i26.i = getelementptr i8, ptr %sunkaddr713.i.i, i64 23552
  %.1638.i.i246 = load <8 x double>, ptr %sunkaddr9.i26.i, align 8, !noalias !81
  %.1641.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %ai.2.1.i.i, <8 x double> %.1616.i21.i, <8 x double> %.1638.i.i246)
  store <8 x double> %.1641.i.i, ptr %sunkaddr9.i26.i, align 8, !noalias !81
  %sunkaddr12.i27.i = getelementptr i8, ptr %sunkaddr713.i.i, i64 24576
  %.1843.i.i = load <8 x double>, ptr %sunkaddr12.i27.i, align 8, !noalias !81
  %.1846.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %ar.2.1.i.i, <8 x double> %.1845.i.i, <8 x double> %.1843.i.i)
  store <8 x double> %.1846.i.i, ptr %sunkaddr12.i27.i, align 8, !noalias !81
  %sunkaddr15.i28.i = getelementptr i8, ptr %sunkaddr713.i.i, i64 25600
  %.1867.i.i = load <8 x double>, ptr %sunkaddr15.i28.i, align 8, !noalias !81
  %.1870.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %ai.2.1.i.i, <8 x double> %.1845.i.i, <8 x double> %.1867.i.i)
  store <8 x double> %.1870.i.i, ptr %sunkaddr15.i28.i, align 8, !noalias !81
  %.1972.i.i247 = getelementptr inbounds double, ptr %.1249.i, i64 %.377.sroa.0.0487.i.i
  %.1974.i.i248 = load <8 x double>, ptr %.1972.i.i247, align 8, !noalias !81
  %sunkaddr18.i29.i = getelementptr i8, ptr %sunkaddr713.i.i, i64 1024
  %.2070.i.i249 = load <8 x double>, ptr %sunkaddr18.i29.i, align 8, !noalias !81
  %sunkaddr21.i30.i = getelementptr i8, ptr %sunkaddr713.i.i, i64 2048
  %.2165.i.i250 = load <8 x double>, ptr %sunkaddr21.i30.i, align 8, !noalias !81
  %sunkaddr24.i31.i = getelementptr i8, ptr %sunkaddr713.i.i, i64 3072
  %.2261.i.i251 = load <8 x double>, ptr %sunkaddr24.i31.i, align 8, !noalias !81
  %.6.i571.i.i = fmul contract <8 x double> %ar.2.1.i.i, %.1974.i.i248
  %.6.i572.i.i252 = fmul contract <8 x double> %ai.2.1.i.i, %.2070.i.i249
  %.6.i573.i.i = fsub contract <8 x double> %.6.i571.i.i, %.6.i572.i.i252
  %.6.i574.i.i253 = fadd contract <8 x double> %by_plus.2.0483.i.i, %.6.i573.i.i
  %.6.i575.i.i = fmul contract <8 x double> %ar.2.1.i.i, %.2165.i.i250
  %.6.i576.i.i254 = fmul contract <8 x double> %ai.2.1.i.i, %.2261.i.i251
  %.6.i577.i.i = fsub contract <8 x double> %.6.i575.i.i, %.6.i576.i.i254
  %.6.i578.i.i = fadd contract <8 x double> %by_cross.2.0482.i.i, %.6.i577.i.i
  %.387.i.i255 = icmp samesign ugt i64 %.332.1486.in.i.i, 1
  %.400.i.i256 = add i64 %.329.1485.i.i, 8
  %.329.1.i.i = select i1 %.387.i.i255, i64 %.400.i.i256, i64 %.329.1485.i.i
  %275 = tail call i64 @llvm.smax.i64(i64 %.332.1486.in.i.i, i64 2)
  %276 = add nsw i64 %275, -1
  %.377.sroa.0.0.i.i = select i1 %.387.i.i255, i64 %.329.1485.i.i, i64 0
  br i1 %.387.i.i255, label %B246.i.i, label %_ZN17bnserve_inference14adjoint_kernel9_standing18pull_back_standingB4v419B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEbx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i

_ZN17bnserve_inference14adjoint_kernel9_standing18pull_back_standingB4v419B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEbx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i: ; preds = %B962.i.i, %B1258.i
  %by_cross.2.0.lcssa.i.i = phi <8 x double> [ zeroinitializer, %B1258.i ], [ %.6.i578.i.i, %B962.i.i ]
  %by_plus.2.0.lcssa.i.i = phi <8 x double> [ zeroinitializer, %B1258.i ], [ %.6.i574.i.i253, %B962.i.i ]
  %by_time.2.0.lcssa.i.i = phi <8 x double> [ zeroinitializer, %B1258.i ], [ %.6.i528.i.i, %B962.i.i ]
  store <8 x double> %by_plus.2.0.lcssa.i.i, ptr %.1612.i, align 8, !noalias !81
  %.2535.i.i = load double, ptr %.1612.i, align 8, !noalias !81
  %.2564.i.i = load double, ptr %.5616.i.i, align 8, !noalias !81
  %.2565.i.i = fadd contract double %.2535.i.i, %.2564.i.i
  %.2594.i.i = load double, ptr %.5646.i.i, align 8, !noalias !81
  %.2623.i.i257 = load double, ptr %.5675.i.i, align 8, !noalias !81
  %.2624.i.i258 = fadd contract double %.2594.i.i, %.2623.i.i257
  %.2625.i.i = fadd contract double %.2565.i.i, %.2624.i.i258
  %.2654.i.i = load double, ptr %.5706.i.i, align 8, !noalias !81
  %.2683.i.i = load double, ptr %.5735.i.i, align 8, !noalias !81
  %.2684.i.i = fadd contract double %.2654.i.i, %.2683.i.i
  %.2713.i.i = load double, ptr %.5765.i.i, align 8, !noalias !81
  %.2742.i.i = load double, ptr %.5794.i.i, align 8, !noalias !81
  %.2746.i.i = fadd contract double %.2713.i.i, %.2742.i.i
  %.2747.i.i259 = fadd contract double %.2684.i.i, %.2746.i.i
  %.2748.i.i260 = fadd contract double %.2625.i.i, %.2747.i.i259
  store <8 x double> %by_cross.2.0.lcssa.i.i, ptr %.1612.i, align 8, !noalias !81
  %.2794.i.i = load double, ptr %.1612.i, align 8, !noalias !81
  %.2823.i.i = load double, ptr %.5616.i.i, align 8, !noalias !81
  %.2824.i.i = fadd contract double %.2794.i.i, %.2823.i.i
  %.2853.i.i = load double, ptr %.5646.i.i, align 8, !noalias !81
  %.2882.i.i = load double, ptr %.5675.i.i, align 8, !noalias !81
  %.2883.i.i = fadd contract double %.2853.i.i, %.2882.i.i
  %.2884.i.i = fadd contract double %.2824.i.i, %.2883.i.i
  %.2913.i.i = load double, ptr %.5706.i.i, align 8, !noalias !81
  %.2942.i.i261 = load double, ptr %.5735.i.i, align 8, !noalias !81
  %.2943.i.i262 = fadd contract double %.2913.i.i, %.2942.i.i261
  %.2972.i.i = load double, ptr %.5765.i.i, align 8, !noalias !81
  %.3001.i.i = load double, ptr %.5794.i.i, align 8, !noalias !81
  %.3005.i.i = fadd contract double %.2972.i.i, %.3001.i.i
  %.3006.i.i = fadd contract double %.2943.i.i262, %.3005.i.i
  %.3007.i.i263 = fadd contract double %.2884.i.i, %.3006.i.i
  %.3037.i.i = load double, ptr %.5541.i.i, align 8, !noalias !81
  %.3072.i.i = load double, ptr %sunkaddr8.i.i, align 8, !noalias !81
  %.3102.i.i = load double, ptr %sunkaddr11.i.i148, align 8, !noalias !81
  %.3106.i.i = fmul contract double %.3102.i.i, 2.000000e+00
  %.3107.i.i264 = fadd contract double %.3072.i.i, %.3106.i.i
  %.3108.i.i = fmul contract double %.2748.i.i260, %.3107.i.i264
  %.3148.i.i = load double, ptr %sunkaddr13.i.i, align 8, !noalias !81
  %.3178.i.i = load double, ptr %sunkaddr16.i.i151, align 8, !noalias !81
  %.3182.i.i = fmul contract double %.3178.i.i, 2.000000e+00
  %.3183.i.i = fadd contract double %.3148.i.i, %.3182.i.i
  %.3184.i.i = fmul contract double %.3007.i.i263, %.3183.i.i
  %.3185.i.i = fadd contract double %.3108.i.i, %.3184.i.i
  %.3186.i.i = fadd contract double %.3037.i.i, %.3185.i.i
  store double %.3186.i.i, ptr %.5541.i.i, align 8, !noalias !81
  %.3246.i.i = load double, ptr %.5861.i.i, align 8, !noalias !81
  %.3280.i.i = load double, ptr %lsr.iv, align 8, !noalias !81
  %.3310.i.i = load double, ptr %sunkaddr19.i.i152, align 8, !noalias !81
  %.3311.i.i = fadd contract double %.3280.i.i, %.3310.i.i
  %.3341.i.i = load double, ptr %sunkaddr20.i.i154, align 8, !noalias !81
  %.3345.i.i = fadd contract double %.3311.i.i, %.3341.i.i
  %.3346.i.i = fmul contract double %.2748.i.i260, %.3345.i.i
  %.3347.i.i = fadd contract double %.3246.i.i, %.3346.i.i
  store double %.3347.i.i, ptr %.5861.i.i, align 8, !noalias !81
  %.3441.i.i = load double, ptr %sunkaddr23.i.i, align 8, !noalias !81
  %.3471.i.i = load double, ptr %sunkaddr22.i.i, align 8, !noalias !81
  %.3472.i.i = fadd contract double %.3441.i.i, %.3471.i.i
  %.3502.i.i = load double, ptr %sunkaddr25.i.i, align 8, !noalias !81
  %.3506.i.i = fadd contract double %.3472.i.i, %.3502.i.i
  %.3507.i.i = fmul contract double %.3007.i.i263, %.3506.i.i
  %.3508.i.i = fadd contract double %.3347.i.i, %.3507.i.i
  store double %.3508.i.i, ptr %.5861.i.i, align 8, !noalias !81
  %.3568.i.i = load double, ptr %.6181.i.i, align 8, !noalias !81
  %.3570.i.i = fmul contract double %.284.i.i, %.2748.i.i260
  %.3574.i.i = fmul contract double %.185.i.i, %.3007.i.i263
  %.3577.i.i = fsub contract double %.3570.i.i, %.3574.i.i
  %.3578.i.i = fmul contract double %.3577.i.i, 2.000000e+00
  %.3579.i.i = fadd contract double %.3578.i.i, %.3568.i.i
  br label %B1362.i

B1350.i:                                          ; preds = %B1158.i
  br i1 %.93.inv.i.i, label %_ZN17bnserve_inference14adjoint_kernel5_back9pull_backB4v464B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i, label %B250.lr.ph.i.i

B250.lr.ph.i.i:                                   ; preds = %B1350.i
  %.144.i.i = load double, ptr %sunkaddr82.i, align 8, !noalias !84
  %.115.i.i = load double, ptr %sunkaddr85.i, align 8, !noalias !84
  %.6.i4376.i.i = insertelement <8 x double> poison, double %.115.i.i, i64 0
  %.7.i.i33.i = shufflevector <8 x double> %.6.i4376.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.6.i4378.i.i = insertelement <8 x double> poison, double %.144.i.i, i64 0
  %.7.i4379.i.i = shufflevector <8 x double> %.6.i4378.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  br label %B250.i.i

B250.i.i:                                         ; preds = %B6309.i.i, %B250.lr.ph.i.i
  %.269.sroa.0.04226.i.i = phi i64 [ 0, %B250.lr.ph.i.i ], [ %.269.sroa.0.0.i.i, %B6309.i.i ]
  %.224.14225.in.i.i = phi i64 [ %241, %B250.lr.ph.i.i ], [ %282, %B6309.i.i ]
  %.221.14224.i.i = phi i64 [ 8, %B250.lr.ph.i.i ], [ %.221.1.i.i, %B6309.i.i ]
  %by_time.2.04223.i.i = phi <8 x double> [ zeroinitializer, %B250.lr.ph.i.i ], [ %.6.i4263.i.i, %B6309.i.i ]
  %by_polarization.2.04222.i.i = phi <8 x double> [ zeroinitializer, %B250.lr.ph.i.i ], [ %.6.i4464.i.i, %B6309.i.i ]
  %by_declination.2.04221.i.i = phi <8 x double> [ zeroinitializer, %B250.lr.ph.i.i ], [ %.6.i4435.i.i, %B6309.i.i ]
  %by_hour.2.04220.i.i = phi <8 x double> [ zeroinitializer, %B250.lr.ph.i.i ], [ %.6.i4382.i.i, %B6309.i.i ]
  %sunkaddr.i34.i = shl i64 %.269.sroa.0.04226.i.i, 3
  %sunkaddr4737.i.i = getelementptr inbounds i8, ptr %.432, i64 %sunkaddr.i34.i
  %sunkaddr4738.i.i = getelementptr inbounds nuw i8, ptr %sunkaddr4737.i.i, i64 6144
  %.411.i.i = load <8 x double>, ptr %sunkaddr4738.i.i, align 8, !noalias !84
  %sunkaddr4741.i.i = getelementptr inbounds nuw i8, ptr %sunkaddr4737.i.i, i64 7168
  %.507.i.i = load <8 x double>, ptr %sunkaddr4741.i.i, align 8, !noalias !84
  %sunkaddr4743.i.i = getelementptr inbounds i8, ptr %.1249.i, i64 %sunkaddr.i34.i
  %sunkaddr4744.i.i = getelementptr inbounds nuw i8, ptr %sunkaddr4743.i.i, i64 6144
  %.602.i35.i = load <8 x double>, ptr %sunkaddr4744.i.i, align 8, !noalias !84
  %sunkaddr4747.i.i = getelementptr inbounds nuw i8, ptr %sunkaddr4743.i.i, i64 7168
  %.698.i.i = load <8 x double>, ptr %sunkaddr4747.i.i, align 8, !noalias !84
  %sunkaddr4750.i.i = getelementptr inbounds nuw i8, ptr %sunkaddr4737.i.i, i64 8192
  %.793.i.i230 = load <8 x double>, ptr %sunkaddr4750.i.i, align 8, !noalias !84
  %sunkaddr4753.i.i = getelementptr inbounds nuw i8, ptr %sunkaddr4737.i.i, i64 9216
  %.889.i.i = load <8 x double>, ptr %sunkaddr4753.i.i, align 8, !noalias !84
  %.1028.i36.i = getelementptr inbounds double, ptr %.311.i, i64 %.269.sroa.0.04226.i.i
  %.1030.i.i = load <8 x double>, ptr %.1028.i36.i, align 8, !noalias !84
  %sunkaddr4756.i.i = getelementptr inbounds nuw i8, ptr %sunkaddr4743.i.i, i64 4096
  %.1173.i.i = load <8 x double>, ptr %sunkaddr4756.i.i, align 8, !noalias !84
  %sunkaddr4759.i.i = getelementptr inbounds nuw i8, ptr %sunkaddr4743.i.i, i64 5120
  %.1269.i37.i = load <8 x double>, ptr %sunkaddr4759.i.i, align 8, !noalias !84
  %.1368.i.i = getelementptr inbounds double, ptr %.432, i64 %.269.sroa.0.04226.i.i
  %.1370.i.i = load <8 x double>, ptr %.1368.i.i, align 8, !noalias !84
  %sunkaddr4762.i.i = getelementptr inbounds nuw i8, ptr %sunkaddr4737.i.i, i64 1024
  %.1466.i.i231 = load <8 x double>, ptr %sunkaddr4762.i.i, align 8, !noalias !84
  %277 = fneg contract <8 x double> %.1466.i.i231
  %.8.i4287.i.i = fmul contract <8 x double> %.507.i.i, %277
  %.1519.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.411.i.i, <8 x double> %.1370.i.i, <8 x double> %.8.i4287.i.i)
  %.6.i4288.i.i = fmul contract <8 x double> %.507.i.i, %.1370.i.i
  %.1544.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.411.i.i, <8 x double> %.1466.i.i231, <8 x double> %.6.i4288.i.i)
  %sunkaddr4765.i.i = getelementptr inbounds nuw i8, ptr %sunkaddr4743.i.i, i64 8192
  %.1657.i.i232 = load <8 x double>, ptr %sunkaddr4765.i.i, align 8, !noalias !84
  %sunkaddr4768.i.i = getelementptr inbounds nuw i8, ptr %sunkaddr4743.i.i, i64 9216
  %.1753.i.i = load <8 x double>, ptr %sunkaddr4768.i.i, align 8, !noalias !84
  %278 = fneg contract <8 x double> %.1753.i.i
  %.8.i4300.i.i = fmul contract <8 x double> %.1544.i.i, %278
  %.1805.i.i233 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1519.i.i, <8 x double> %.1657.i.i232, <8 x double> %.8.i4300.i.i)
  %.6.i4301.i.i = fmul contract <8 x double> %.1544.i.i, %.1657.i.i232
  %.1830.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1519.i.i, <8 x double> %.1753.i.i, <8 x double> %.6.i4301.i.i)
  br label %B2058.if.i.i

B6309.i.i:                                        ; preds = %B2058.if.i.i
  %.6.i.i38.i = fmul contract <8 x double> %.602.i35.i, %.793.i.i230
  %.6.i4261.i.i = fmul contract <8 x double> %.698.i.i, %.889.i.i
  %.6.i4262.i.i = fsub contract <8 x double> %.6.i.i38.i, %.6.i4261.i.i
  %.6.i4263.i.i = fadd contract <8 x double> %by_time.2.04223.i.i, %.6.i4262.i.i
  %.6.i4264.i.i = fmul contract <8 x double> %.507.i.i, %.602.i35.i
  %.8.i.i39.i = fmul contract <8 x double> %.1030.i.i, splat (double 0x401921FB54442D18)
  %.1019.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.411.i.i, <8 x double> %.698.i.i, <8 x double> %.6.i4264.i.i)
  %.6.i4265.i.i = fmul contract <8 x double> %.1019.i.i, %.8.i.i39.i
  %.2648.i.i = getelementptr inbounds double, ptr %.1249.i, i64 %.269.sroa.0.04226.i.i
  %.2650.i.i = load <8 x double>, ptr %.2648.i.i, align 8, !noalias !84
  %sunkaddr3.i40.i = getelementptr i8, ptr %sunkaddr4743.i.i, i64 1024
  %.2746.i41.i = load <8 x double>, ptr %sunkaddr3.i40.i, align 8, !noalias !84
  %279 = fneg contract <8 x double> %.2746.i41.i
  %.8.i4333.i.i = fmul contract <8 x double> %.1830.i.i, %279
  %.2800.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1805.i.i233, <8 x double> %.2650.i.i, <8 x double> %.8.i4333.i.i)
  %.6.i4334.i.i = fmul contract <8 x double> %.1830.i.i, %.2650.i.i
  %.2825.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1805.i.i233, <8 x double> %.2746.i41.i, <8 x double> %.6.i4334.i.i)
  %sunkaddr6.i42.i = getelementptr i8, ptr %sunkaddr4743.i.i, i64 2048
  %.2938.i.i = load <8 x double>, ptr %sunkaddr6.i42.i, align 8, !noalias !84
  %sunkaddr9.i43.i = getelementptr i8, ptr %sunkaddr4743.i.i, i64 3072
  %.3039.i.i = load <8 x double>, ptr %sunkaddr9.i43.i, align 8, !noalias !84
  %280 = fneg contract <8 x double> %.3039.i.i
  %.8.i4346.i.i = fmul contract <8 x double> %.1830.i.i, %280
  %.3099.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1805.i.i233, <8 x double> %.2938.i.i, <8 x double> %.8.i4346.i.i)
  %.6.i4347.i.i = fmul contract <8 x double> %.1830.i.i, %.2938.i.i
  %.3124.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1805.i.i233, <8 x double> %.3039.i.i, <8 x double> %.6.i4347.i.i)
  %sunkaddr12.i44.i = getelementptr i8, ptr %sunkaddr4743.i.i, i64 14336
  %.3282.i.i = load <8 x double>, ptr %sunkaddr12.i44.i, align 8, !noalias !84
  %.6.i4353.i.i = fmul contract <8 x double> %.2800.i.i, %.3282.i.i
  %sunkaddr15.i45.i = getelementptr i8, ptr %sunkaddr4743.i.i, i64 15360
  %.3400.i.i = load <8 x double>, ptr %sunkaddr15.i45.i, align 8, !noalias !84
  %.6.i4359.i.i = fmul contract <8 x double> %.2825.i.i, %.3400.i.i
  %.6.i4360.i.i = fsub contract <8 x double> %.6.i4353.i.i, %.6.i4359.i.i
  %sunkaddr18.i46.i = getelementptr i8, ptr %sunkaddr4743.i.i, i64 16384
  %.3542.i.i = load <8 x double>, ptr %sunkaddr18.i46.i, align 8, !noalias !84
  %.6.i4366.i.i = fmul contract <8 x double> %.3099.i.i, %.3542.i.i
  %sunkaddr21.i47.i = getelementptr i8, ptr %sunkaddr4743.i.i, i64 17408
  %.3663.i.i = load <8 x double>, ptr %sunkaddr21.i47.i, align 8, !noalias !84
  %.6.i4372.i.i = fmul contract <8 x double> %.3124.i.i, %.3663.i.i
  %.6.i4373.i.i = fsub contract <8 x double> %.6.i4366.i.i, %.6.i4372.i.i
  %.6.i4374.i.i = fadd contract <8 x double> %.6.i4360.i.i, %.6.i4373.i.i
  %.6.i4375.i.i = fsub contract <8 x double> splat (double 1.000000e+00), %.1173.i.i
  %.8.i4377.i.i = fmul contract <8 x double> %.7.i.i33.i, %.1269.i37.i
  %.8.i4380.i.i = fmul contract <8 x double> %.7.i4379.i.i, %.6.i4375.i.i
  %.6.i4381.i.i = fsub contract <8 x double> %.8.i4377.i.i, %.8.i4380.i.i
  %.3842.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i4265.i.i, <8 x double> %.6.i4381.i.i, <8 x double> %.6.i4374.i.i)
  %.6.i4382.i.i = fadd contract <8 x double> %by_hour.2.04220.i.i, %.3842.i.i
  %sunkaddr24.i48.i = getelementptr i8, ptr %sunkaddr4743.i.i, i64 26624
  %.3961.i.i = load <8 x double>, ptr %sunkaddr24.i48.i, align 8, !noalias !84
  %.8.i4398.i.i = fmul contract <8 x double> %.7.i4379.i.i, %.1173.i.i
  %.6.i4399.i.i = fadd contract <8 x double> %.8.i4398.i.i, %.8.i4377.i.i
  %.4126.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i4265.i.i, <8 x double> %.6.i4399.i.i, <8 x double> %.6.i4374.i.i)
  %.6.i4400.i.i = fadd contract <8 x double> %.3961.i.i, %.4126.i.i
  store <8 x double> %.6.i4400.i.i, ptr %sunkaddr24.i48.i, align 8, !noalias !84
  %sunkaddr27.i.i = getelementptr i8, ptr %sunkaddr4743.i.i, i64 18432
  %.4261.i.i = load <8 x double>, ptr %sunkaddr27.i.i, align 8, !noalias !84
  %.6.i4406.i.i = fmul contract <8 x double> %.2800.i.i, %.4261.i.i
  %sunkaddr30.i.i = getelementptr i8, ptr %sunkaddr4743.i.i, i64 19456
  %.4379.i.i = load <8 x double>, ptr %sunkaddr30.i.i, align 8, !noalias !84
  %.6.i4412.i.i = fmul contract <8 x double> %.2825.i.i, %.4379.i.i
  %.6.i4413.i.i = fsub contract <8 x double> %.6.i4406.i.i, %.6.i4412.i.i
  %sunkaddr33.i.i = getelementptr i8, ptr %sunkaddr4743.i.i, i64 20480
  %.4521.i.i = load <8 x double>, ptr %sunkaddr33.i.i, align 8, !noalias !84
  %.6.i4419.i.i = fmul contract <8 x double> %.3099.i.i, %.4521.i.i
  %sunkaddr36.i.i = getelementptr i8, ptr %sunkaddr4743.i.i, i64 21504
  %.4642.i.i = load <8 x double>, ptr %sunkaddr36.i.i, align 8, !noalias !84
  %.6.i4425.i.i = fmul contract <8 x double> %.3124.i.i, %.4642.i.i
  %.6.i4426.i.i = fsub contract <8 x double> %.6.i4419.i.i, %.6.i4425.i.i
  %.6.i4427.i.i = fadd contract <8 x double> %.6.i4413.i.i, %.6.i4426.i.i
  %.4747.i.i = load double, ptr %sunkaddr37.i.i, align 8, !noalias !84
  %.6.i4428.i.i = insertelement <8 x double> poison, double %.4747.i.i, i64 0
  %.7.i4429.i.i = shufflevector <8 x double> %.6.i4428.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.8.i4430.i.i = fmul contract <8 x double> %.6.i4375.i.i, %.7.i4429.i.i
  %.4801.i.i = load double, ptr %sunkaddr38.i.i, align 8, !noalias !84
  %.6.i4431.i.i = insertelement <8 x double> poison, double %.4801.i.i, i64 0
  %.7.i4432.i.i = shufflevector <8 x double> %.6.i4431.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.8.i4433.i.i = fmul contract <8 x double> %.1269.i37.i, %.7.i4432.i.i
  %.6.i4434.i.i = fadd contract <8 x double> %.8.i4430.i.i, %.8.i4433.i.i
  %.4854.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i4265.i.i, <8 x double> %.6.i4434.i.i, <8 x double> %.6.i4427.i.i)
  %.6.i4435.i.i = fadd contract <8 x double> %by_declination.2.04221.i.i, %.4854.i.i
  %sunkaddr41.i.i239 = getelementptr i8, ptr %sunkaddr4743.i.i, i64 12288
  %.4982.i.i = load <8 x double>, ptr %sunkaddr41.i.i239, align 8, !noalias !84
  %.6.i4441.i.i = fmul contract <8 x double> %.2800.i.i, %.4982.i.i
  %sunkaddr44.i.i240 = getelementptr i8, ptr %sunkaddr4743.i.i, i64 13312
  %.5100.i.i = load <8 x double>, ptr %sunkaddr44.i.i240, align 8, !noalias !84
  %.6.i4447.i.i = fmul contract <8 x double> %.2825.i.i, %.5100.i.i
  %.6.i4448.i.i = fsub contract <8 x double> %.6.i4441.i.i, %.6.i4447.i.i
  %sunkaddr47.i.i = getelementptr i8, ptr %sunkaddr4743.i.i, i64 10240
  %.5241.i.i = load <8 x double>, ptr %sunkaddr47.i.i, align 8, !noalias !84
  %.6.i4454.i.i = fmul contract <8 x double> %.3099.i.i, %.5241.i.i
  %sunkaddr50.i.i = getelementptr i8, ptr %sunkaddr4743.i.i, i64 11264
  %.5362.i.i = load <8 x double>, ptr %sunkaddr50.i.i, align 8, !noalias !84
  %.6.i4460.i.i = fmul contract <8 x double> %.3124.i.i, %.5362.i.i
  %.6.i4461.i.i = fsub contract <8 x double> %.6.i4454.i.i, %.6.i4460.i.i
  %.6.i4462.i.i = fsub contract <8 x double> %.6.i4448.i.i, %.6.i4461.i.i
  %.8.i4463.i.i = fmul contract <8 x double> %.6.i4462.i.i, splat (double 2.000000e+00)
  %.6.i4464.i.i = fadd contract <8 x double> %by_polarization.2.04222.i.i, %.8.i4463.i.i
  %.279.i49.i = icmp samesign ugt i64 %.224.14225.in.i.i, 1
  %.292.i.i = add i64 %.221.14224.i.i, 8
  %.221.1.i.i = select i1 %.279.i49.i, i64 %.292.i.i, i64 %.221.14224.i.i
  %281 = tail call i64 @llvm.smax.i64(i64 %.224.14225.in.i.i, i64 2)
  %282 = add nsw i64 %281, -1
  %.269.sroa.0.0.i.i = select i1 %.279.i49.i, i64 %.221.14224.i.i, i64 0
  br i1 %.279.i49.i, label %B250.i.i, label %_ZN17bnserve_inference14adjoint_kernel5_back9pull_backB4v464B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i

B2058.if.i.i:                                     ; preds = %B2058.if.i.i, %B250.i.i
  %exitcond.not.i.i234 = phi i1 [ true, %B2058.if.i.i ], [ false, %B250.i.i ]
  %.195769656975.i.i = phi i64 [ 2048, %B2058.if.i.i ], [ 0, %B250.i.i ]
  %283 = getelementptr i8, ptr %.1249.i, i64 %.195769656975.i.i
  %.2011.i.i = getelementptr i8, ptr %283, i64 10240
  %.2081.i.i = getelementptr inbounds double, ptr %.2011.i.i, i64 %.269.sroa.0.04226.i.i
  %.2083.i.i = load <8 x double>, ptr %.2081.i.i, align 8, !noalias !84
  %.2107.i.i = getelementptr i8, ptr %283, i64 11264
  %.2177.i.i = getelementptr inbounds double, ptr %.2107.i.i, i64 %.269.sroa.0.04226.i.i
  %.2179.i.i = load <8 x double>, ptr %.2177.i.i, align 8, !noalias !84
  %284 = fneg contract <8 x double> %.2179.i.i
  %.8.i4313.i.i = fmul contract <8 x double> %.1830.i.i, %284
  %.2233.i.i235 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1805.i.i233, <8 x double> %.2083.i.i, <8 x double> %.8.i4313.i.i)
  %.6.i4314.i.i = fmul contract <8 x double> %.1830.i.i, %.2083.i.i
  %.2258.i.i236 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1805.i.i233, <8 x double> %.2179.i.i, <8 x double> %.6.i4314.i.i)
  %.2300.i.i237 = getelementptr i8, ptr %283, i64 22528
  %.2385.i.i = getelementptr i8, ptr %283, i64 23552
  %.2461.i.i = getelementptr inbounds double, ptr %.2300.i.i237, i64 %.269.sroa.0.04226.i.i
  %.2463.i.i = load <8 x double>, ptr %.2461.i.i, align 8, !noalias !84
  %.6.i4325.i.i = fadd contract <8 x double> %.2463.i.i, %.2233.i.i235
  store <8 x double> %.6.i4325.i.i, ptr %.2461.i.i, align 8, !noalias !84
  %.2508.i.i = getelementptr inbounds double, ptr %.2385.i.i, i64 %.269.sroa.0.04226.i.i
  %.2510.i.i238 = load <8 x double>, ptr %.2508.i.i, align 8, !noalias !84
  %.6.i4326.i.i = fadd contract <8 x double> %.2258.i.i236, %.2510.i.i238
  store <8 x double> %.6.i4326.i.i, ptr %.2508.i.i, align 8, !noalias !84
  br i1 %exitcond.not.i.i234, label %B6309.i.i, label %B2058.if.i.i

_ZN17bnserve_inference14adjoint_kernel5_back9pull_backB4v464B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i: ; preds = %B6309.i.i, %B1350.i
  %by_hour.2.0.lcssa.i.i = phi <8 x double> [ zeroinitializer, %B1350.i ], [ %.6.i4382.i.i, %B6309.i.i ]
  %by_declination.2.0.lcssa.i.i = phi <8 x double> [ zeroinitializer, %B1350.i ], [ %.6.i4435.i.i, %B6309.i.i ]
  %by_polarization.2.0.lcssa.i.i = phi <8 x double> [ zeroinitializer, %B1350.i ], [ %.6.i4464.i.i, %B6309.i.i ]
  %by_time.2.0.lcssa.i50.i = phi <8 x double> [ zeroinitializer, %B1350.i ], [ %.6.i4263.i.i, %B6309.i.i ]
  %.5542.i.i = load double, ptr %.5541.i.i, align 8, !noalias !84
  store <8 x double> %by_hour.2.0.lcssa.i.i, ptr %.1612.i, align 8, !noalias !84
  %.5588.i.i = load double, ptr %.1612.i, align 8, !noalias !84
  %.5617.i.i = load double, ptr %.5616.i.i, align 8, !noalias !84
  %.5618.i.i = fadd contract double %.5588.i.i, %.5617.i.i
  %.5647.i.i = load double, ptr %.5646.i.i, align 8, !noalias !84
  %.5676.i.i = load double, ptr %.5675.i.i, align 8, !noalias !84
  %.5677.i.i = fadd contract double %.5647.i.i, %.5676.i.i
  %.5678.i.i = fadd contract double %.5618.i.i, %.5677.i.i
  %.5707.i.i = load double, ptr %.5706.i.i, align 8, !noalias !84
  %.5736.i.i = load double, ptr %.5735.i.i, align 8, !noalias !84
  %.5737.i.i = fadd contract double %.5707.i.i, %.5736.i.i
  %.5766.i.i = load double, ptr %.5765.i.i, align 8, !noalias !84
  %.5795.i.i = load double, ptr %.5794.i.i, align 8, !noalias !84
  %.5799.i.i = fadd contract double %.5766.i.i, %.5795.i.i
  %.5800.i.i = fadd contract double %.5737.i.i, %.5799.i.i
  %.5801.i.i = fadd contract double %.5678.i.i, %.5800.i.i
  %.5802.i.i = fadd contract double %.5542.i.i, %.5801.i.i
  store double %.5802.i.i, ptr %.5541.i.i, align 8, !noalias !84
  %.5862.i.i = load double, ptr %.5861.i.i, align 8, !noalias !84
  store <8 x double> %by_declination.2.0.lcssa.i.i, ptr %.1612.i, align 8, !noalias !84
  %.5908.i.i = load double, ptr %.1612.i, align 8, !noalias !84
  %.5937.i.i = load double, ptr %.5616.i.i, align 8, !noalias !84
  %.5938.i.i = fadd contract double %.5908.i.i, %.5937.i.i
  %.5967.i.i = load double, ptr %.5646.i.i, align 8, !noalias !84
  %.5996.i.i = load double, ptr %.5675.i.i, align 8, !noalias !84
  %.5997.i.i = fadd contract double %.5967.i.i, %.5996.i.i
  %.5998.i.i = fadd contract double %.5938.i.i, %.5997.i.i
  %.6027.i.i = load double, ptr %.5706.i.i, align 8, !noalias !84
  %.6056.i.i = load double, ptr %.5735.i.i, align 8, !noalias !84
  %.6057.i.i = fadd contract double %.6027.i.i, %.6056.i.i
  %.6086.i.i = load double, ptr %.5765.i.i, align 8, !noalias !84
  %.6115.i.i = load double, ptr %.5794.i.i, align 8, !noalias !84
  %.6119.i.i = fadd contract double %.6086.i.i, %.6115.i.i
  %.6120.i.i = fadd contract double %.6057.i.i, %.6119.i.i
  %.6121.i.i = fadd contract double %.5998.i.i, %.6120.i.i
  %.6122.i.i = fadd contract double %.5862.i.i, %.6121.i.i
  store double %.6122.i.i, ptr %.5861.i.i, align 8, !noalias !84
  %.6182.i.i = load double, ptr %.6181.i.i, align 8, !noalias !84
  store <8 x double> %by_polarization.2.0.lcssa.i.i, ptr %.1612.i, align 8, !noalias !84
  %.6228.i.i = load double, ptr %.1612.i, align 8, !noalias !84
  %.6257.i.i = load double, ptr %.5616.i.i, align 8, !noalias !84
  %.6258.i.i = fadd contract double %.6228.i.i, %.6257.i.i
  %.6287.i.i = load double, ptr %.5646.i.i, align 8, !noalias !84
  %.6316.i.i = load double, ptr %.5675.i.i, align 8, !noalias !84
  %.6317.i.i = fadd contract double %.6287.i.i, %.6316.i.i
  %.6318.i.i = fadd contract double %.6258.i.i, %.6317.i.i
  %.6347.i.i = load double, ptr %.5706.i.i, align 8, !noalias !84
  %.6376.i.i = load double, ptr %.5735.i.i, align 8, !noalias !84
  %.6377.i.i = fadd contract double %.6347.i.i, %.6376.i.i
  %.6406.i.i = load double, ptr %.5765.i.i, align 8, !noalias !84
  %.6435.i.i = load double, ptr %.5794.i.i, align 8, !noalias !84
  %.6439.i.i = fadd contract double %.6406.i.i, %.6435.i.i
  %.6440.i.i = fadd contract double %.6377.i.i, %.6439.i.i
  %.6441.i.i = fadd contract double %.6318.i.i, %.6440.i.i
  %.6442.i.i = fadd contract double %.6182.i.i, %.6441.i.i
  br label %B1362.i

B1362.i:                                          ; preds = %_ZN17bnserve_inference14adjoint_kernel5_back9pull_backB4v464B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i, %_ZN17bnserve_inference14adjoint_kernel9_standing18pull_back_standingB4v419B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEbx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i
  %.6442.i.i.sink = phi double [ %.6442.i.i, %_ZN17bnserve_inference14adjoint_kernel5_back9pull_backB4v464B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i ], [ %.3579.i.i, %_ZN17bnserve_inference14adjoint_kernel9_standing18pull_back_standingB4v419B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEbx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i ]
  %by_time.2.0.lcssa.i50.i.sink = phi <8 x double> [ %by_time.2.0.lcssa.i50.i, %_ZN17bnserve_inference14adjoint_kernel5_back9pull_backB4v464B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i ], [ %by_time.2.0.lcssa.i.i, %_ZN17bnserve_inference14adjoint_kernel9_standing18pull_back_standingB4v419B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEbx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i ]
  store double %.6442.i.i.sink, ptr %.6181.i.i, align 8, !noalias !51
  %.6502.i.i = load double, ptr %.6501.i.i, align 8, !noalias !51
  store <8 x double> %by_time.2.0.lcssa.i50.i.sink, ptr %.1612.i, align 8, !noalias !51
  %.6553.i.i = load double, ptr %.1612.i, align 8, !noalias !51
  %.6582.i.i = load double, ptr %.5616.i.i, align 8, !noalias !51
  %.6583.i.i = fadd contract double %.6553.i.i, %.6582.i.i
  %.6612.i.i = load double, ptr %.5646.i.i, align 8, !noalias !51
  %.6641.i.i = load double, ptr %.5675.i.i, align 8, !noalias !51
  %.6642.i.i = fadd contract double %.6612.i.i, %.6641.i.i
  %.6643.i.i = fadd contract double %.6583.i.i, %.6642.i.i
  %.6672.i.i = load double, ptr %.5706.i.i, align 8, !noalias !51
  %.6701.i.i = load double, ptr %.5735.i.i, align 8, !noalias !51
  %.6702.i.i = fadd contract double %.6672.i.i, %.6701.i.i
  %.6731.i.i = load double, ptr %.5765.i.i, align 8, !noalias !51
  %.6760.i.i = load double, ptr %.5794.i.i, align 8, !noalias !51
  %.6764.i.i = fadd contract double %.6731.i.i, %.6760.i.i
  %.6765.i.i = fadd contract double %.6702.i.i, %.6764.i.i
  %.6766.i.i = fadd contract double %.6643.i.i, %.6765.i.i
  %.6767.i.i = fadd contract double %.6502.i.i, %.6766.i.i
  store double %.6767.i.i, ptr %.6501.i.i, align 8, !noalias !51
  %lsr.iv.next.i241 = add i64 %lsr.iv.i196, 27648
  %exitcond1005.not.i = icmp eq i64 %.1202.i, %.104.i
  br i1 %exitcond1005.not.i, label %B1406.i, label %B950.if.i

B1406.i:                                          ; preds = %B1362.i, %B420.i
  %.1756.i = icmp sgt i64 %.134.i, 0
  br i1 %.1756.i, label %B1407.i, label %_ZN17bnserve_inference14adjoint_kernel7_source12_in_detectorB4v146B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxx5ArrayIxLi1E1C7mutable7alignedEd5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit

B1407.i:                                          ; preds = %B1406.i
  call void @llvm.lifetime.start.p0(ptr nonnull %.880.i.i128), !noalias !51
  store double 0.000000e+00, ptr %.880.i.i128, align 8, !noalias !87
  %.69.i.i = load i64, ptr %.133.i129, align 8, !noalias !87
  %.241.i.i138 = shl nsw i64 %.69.i.i, 3
  %.271.i.i139 = load i64, ptr %arg.arguments.4, align 8, !noalias !87
  %.272.i.i140 = mul nsw i64 %.271.i.i139, %.604928988
  %.273.i.i141 = add nsw i64 %.272.i.i140, %.1212877881
  %.274.i.i142 = mul nsw i64 %.273.i.i141, %.241.i.i138
  %.308.i.i = load i64, ptr %.307.i.i, align 8, !noalias !87
  %.312.i.i143 = inttoptr i64 %.308.i.i to ptr
  %invariant.gep.i.i = getelementptr double, ptr %.312.i.i143, i64 %.1020890909
  %.741503.not.i.i = icmp slt i64 %.69.i.i, 1
  br i1 %.741503.not.i.i, label %_ZN17bnserve_inference14adjoint_kernel5_back15errors_to_nodesB4v546B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i, label %B482.if.preheader.i.i

B482.if.preheader.i.i:                            ; preds = %B1407.i
  %.514.i.i = load i64, ptr %51, align 8, !noalias !87
  %.516.i.i = add nsw i64 %.514.i.i, %.274.i.i142
  %.100.i.i = load i64, ptr %.143, align 8, !noalias !87
  %.101.i.i = sub i64 0, %.100.i.i
  %285 = lshr i64 %.101.i.i, 3
  %286 = mul i64 %285, -64
  %287 = inttoptr i64 %.516.i.i to ptr
  br label %B482.if.i.i

B594.i.i:                                         ; preds = %B482.if.i.i
  %.514.1.i.i = load i64, ptr %52, align 8, !noalias !87
  %.516.1.i.i = add nsw i64 %.514.1.i.i, %.274.i.i142
  %288 = inttoptr i64 %.516.1.i.i to ptr
  br label %B482.if.1.i.i

B482.if.1.i.i:                                    ; preds = %B482.if.1.i.i, %B594.i.i
  %lsr.iv.i52.i = phi ptr [ %invariant.gep.i.i, %B594.i.i ], [ %scevgep.i53.i, %B482.if.1.i.i ]
  %.747501504.1.i.i = phi i64 [ 0, %B594.i.i ], [ %.754.1.i.i, %B482.if.1.i.i ]
  %289 = shl i64 %.747501504.1.i.i, 3
  %scevgep88.i.i = getelementptr i8, ptr %288, i64 %289
  %.808.1.i.i = load double, ptr %scevgep88.i.i, align 8, !noalias !87
  store double 0.000000e+00, ptr %.880.i.i128, align 8, !noalias !87
  call fastcc void @inner_3(ptr nonnull %.880.i.i128, ptr %.592.1.i.i, ptr %lsr.iv.i52.i, i64 range(i64 -9223372036854775808, 129) %.13.i, i64 range(i64 -9223372036854775808, 129) %.13.i, ptr nonnull %.169.i.i137)
  %.754.1.i.i = add nuw nsw i64 %.747501504.1.i.i, 1
  %.900.1.i.i = load double, ptr %.880.i.i128, align 8, !noalias !87
  %.913.1.i.i = fadd contract double %.808.1.i.i, %.900.1.i.i
  store double %.913.1.i.i, ptr %scevgep88.i.i, align 8, !noalias !87
  %scevgep.i53.i = getelementptr i8, ptr %lsr.iv.i52.i, i64 %286
  %exitcond.not.1.i.i = icmp eq i64 %.69.i.i, %.754.1.i.i
  br i1 %exitcond.not.1.i.i, label %_ZN17bnserve_inference14adjoint_kernel5_back15errors_to_nodesB4v546B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i, label %B482.if.1.i.i

B482.if.i.i:                                      ; preds = %B482.if.i.i, %B482.if.preheader.i.i
  %lsr.iv89.i.i = phi ptr [ %invariant.gep.i.i, %B482.if.preheader.i.i ], [ %scevgep90.i.i, %B482.if.i.i ]
  %.747501504.i.i = phi i64 [ 0, %B482.if.preheader.i.i ], [ %.754.i.i145, %B482.if.i.i ]
  %290 = shl i64 %.747501504.i.i, 3
  %scevgep91.i.i = getelementptr i8, ptr %287, i64 %290
  %.808.i.i144 = load double, ptr %scevgep91.i.i, align 8, !noalias !87
  store double 0.000000e+00, ptr %.880.i.i128, align 8, !noalias !87
  call fastcc void @inner_3(ptr nonnull %.880.i.i128, ptr %.592.i.i, ptr %lsr.iv89.i.i, i64 range(i64 -9223372036854775808, 129) %.13.i, i64 range(i64 -9223372036854775808, 129) %.13.i, ptr nonnull %.169.i.i137)
  %.754.i.i145 = add nuw nsw i64 %.747501504.i.i, 1
  %.900.i.i = load double, ptr %.880.i.i128, align 8, !noalias !87
  %.913.i.i146 = fadd contract double %.808.i.i144, %.900.i.i
  store double %.913.i.i146, ptr %scevgep91.i.i, align 8, !noalias !87
  %scevgep90.i.i = getelementptr i8, ptr %lsr.iv89.i.i, i64 %286
  %exitcond.not.i51.i = icmp eq i64 %.69.i.i, %.754.i.i145
  br i1 %exitcond.not.i51.i, label %B594.i.i, label %B482.if.i.i

_ZN17bnserve_inference14adjoint_kernel5_back15errors_to_nodesB4v546B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i: ; preds = %B482.if.1.i.i, %B1407.i
  call void @llvm.lifetime.end.p0(ptr nonnull %.880.i.i128), !noalias !51
  br label %_ZN17bnserve_inference14adjoint_kernel7_source12_in_detectorB4v146B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxx5ArrayIxLi1E1C7mutable7alignedEd5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit

B452.if.i:                                        ; preds = %B918.i, %B452.if.lr.ph.i
  %lsr.iv193.i = phi i64 [ 21504, %B452.if.lr.ph.i ], [ %lsr.iv.next194.i, %B918.i ]
  %.634940948.i = phi i64 [ 0, %B452.if.lr.ph.i ], [ %.641.i, %B918.i ]
  %.641.i = add nuw nsw i64 %.634940948.i, 1
  %.idx902.i = mul i64 %.634940948.i, 27648
  %291 = getelementptr i8, ptr %.432, i64 %.idx902.i
  %.688.i = getelementptr i8, ptr %291, i64 14336
  br i1 %"$phi420.0.2.0.i", label %B492.i, label %B540.i

B950.if.i:                                        ; preds = %B1362.i, %B950.if.lr.ph.i
  %lsr.iv.i196 = phi i64 [ 21504, %B950.if.lr.ph.i ], [ %lsr.iv.next.i241, %B1362.i ]
  %.1195959968.i = phi i64 [ 0, %B950.if.lr.ph.i ], [ %.1202.i, %B1362.i ]
  %.1202.i = add nuw nsw i64 %.1195959968.i, 1
  %.idx.i197 = mul i64 %.1195959968.i, 27648
  %292 = getelementptr i8, ptr %.432, i64 %.idx.i197
  %.1249.i = getelementptr i8, ptr %292, i64 14336
  %.1348.i = load double, ptr %lsr.iv248, align 8, !noalias !51
  %.1350.i = fadd contract double %.750, %.1348.i
  %.79.i.i = load i64, ptr %.76, align 8, !noalias !90
  %.109.i.i = load i64, ptr %.143, align 8, !noalias !90
  %.139.i.i = load i64, ptr %.138.i.i, align 8, !noalias !90
  %.224.i.i = load i64, ptr %.171.i, align 8, !noalias !90
  %.377.i.i198 = load i64, ptr %.376.i.i189, align 8, !noalias !90
  %.455747.i.i = load double, ptr %.454.i.i190, align 8, !noalias !90
  %.501.i.i = load i64, ptr %.500.i.i191, align 8, !noalias !90
  %.558.i.i199 = load i64, ptr %.557.i.i, align 8, !noalias !90
  br i1 %.93.inv.i.i, label %B604.loopexit.3.i.i, label %B652.if.lr.ph.i.i

B604.loopexit.3.i.i:                              ; preds = %B652.if.lr.ph.i.i, %B950.if.i
  %.147.i.i = sub i64 0, %.109.i.i
  %.155.1.i.i = and i64 %.147.i.i, -8
  %.189.i.i = sub i64 0, %.155.1.i.i
  %.226.i.i = inttoptr i64 %.224.i.i to ptr
  %.290.i54.i = getelementptr inbounds double, ptr %.226.i.i, i64 %.1020890909
  %.566.i.i = shl nsw i64 %.189.i.i, 1
  %.1000.i55.i = load i64, ptr %.999.i.i, align 8, !noalias !90
  %.1080809.not.i.i = icmp slt i64 %.1000.i55.i, 1
  br i1 %.1080809.not.i.i, label %_ZN17bnserve_inference14adjoint_kernel7_source16_through_weightsB4v318B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxxx5ArrayIxLi1E1C7mutable7alignedEd5ArrayIdLi1E1C7mutable7alignedE.exit.i, label %B810.if.lr.ph.i.i

B810.if.lr.ph.i.i:                                ; preds = %B604.loopexit.3.i.i
  %.560.i.i = shl nsw i64 %.189.i.i, 4
  %.562.i.i200 = mul nsw i64 %.560.i.i, %.139.i.i
  %.502.i.i201 = icmp eq i64 %.501.i.i, 1
  %.515.i.i = mul nsw i64 %.79.i.i, %.1212877881
  %.521.i.i = add nsw i64 %.515.i.i, %.1195959968.i
  %"$phi424.0.2.0.i.i" = select i1 %.502.i.i201, i64 %.1212877881, i64 %.521.i.i
  %.563.i.i202 = mul nsw i64 %.562.i.i200, %"$phi424.0.2.0.i.i"
  %.564.i.i = add nsw i64 %.563.i.i202, %.558.i.i199
  %293 = inttoptr i64 %.564.i.i to ptr
  %.1583.i.i = add nsw i64 %.139.i.i, -4
  %.1178.i.i = getelementptr inbounds double, ptr %293, i64 %.1020890909
  %.1232.i56.i = sub i64 %.1020890909, %.155.1.i.i
  %.1244.i.i = getelementptr inbounds double, ptr %293, i64 %.1232.i56.i
  %invariant.gep.i.i.i = getelementptr double, ptr %293, i64 %.566.i.i
  %invariant.gep1621.idx.i.i.i = mul i64 %.155.1.i.i, -48
  %invariant.gep1621.i.i.i = getelementptr i8, ptr %293, i64 %invariant.gep1621.idx.i.i.i
  %invariant.gep1623.idx.i.i.i = shl i64 %.189.i.i, 5
  %invariant.gep1623.i.i.i = getelementptr i8, ptr %293, i64 %invariant.gep1623.idx.i.i.i
  %invariant.gep1625.idx.i.i.i = mul i64 %.155.1.i.i, -80
  %invariant.gep1625.i.i.i = getelementptr i8, ptr %293, i64 %invariant.gep1625.idx.i.i.i
  %invariant.gep1627.idx.i.i.i = shl i64 %.189.i.i, 6
  %invariant.gep1627.i.i.i = getelementptr i8, ptr %293, i64 %invariant.gep1627.idx.i.i.i
  %294 = icmp eq i64 %.139.i.i, 1
  %295 = inttoptr i64 %.377.i.i198 to ptr
  %sunkaddr16.i60.i = getelementptr i8, ptr %295, i64 8
  br label %B810.if.i.i

B884.i.i:                                         ; preds = %_ZN17bnserve_inference14adjoint_kernel7_source10_fill_barsB4v329B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.thread.i.i
  br i1 %.93.inv.i.i, label %B1112.i.i, label %B382.lr.ph.i.i.i

B992.i.i:                                         ; preds = %_ZN17bnserve_inference14adjoint_kernel7_source10_fill_barsB4v329B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.thread.thread.i.i, %_ZN17bnserve_inference14adjoint_kernel7_source10_fill_barsB4v329B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.thread.i.i
  %.11575.i.i = phi double [ %.11574.i.i, %_ZN17bnserve_inference14adjoint_kernel7_source10_fill_barsB4v329B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.thread.thread.i.i ], [ %.1157.i.i, %_ZN17bnserve_inference14adjoint_kernel7_source10_fill_barsB4v329B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.thread.i.i ]
  %.48.i.i.i = load double, ptr %295, align 8, !noalias !93
  %.49.i.i.i = fsub contract double %.11575.i.i, %.48.i.i.i
  %.78.i.i.i = load double, ptr %sunkaddr16.i60.i, align 8, !noalias !93
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
  %.267.i.i.i = add nsw i64 %.266.i.i.i, %.1020890909
  %.1647.i.i205 = fmul contract double %.78.i.i.i, 2.400000e+01
  %.1651.i.i206 = fdiv contract double 1.000000e+00, %.1647.i.i205
  %.1652.i.i207 = fmul contract double %.182.i.i.i, 2.400000e+01
  %.1656.i.i = fsub contract double 2.400000e+01, %.208.i.i.i
  %.1657.i72.i = fmul contract double %.245.i.i.i, %.1656.i.i
  %296 = fsub contract double %.1657.i72.i, %.1652.i.i207
  %.1659.i.i = fmul contract double %.183.i.i.i, 2.400000e+01
  %.1663.i.i = fsub contract double 2.400000e+01, %.220.i.i.i
  %.1664.i73.i = fmul contract double %.185.i.i.i, %.1663.i.i
  %297 = fsub contract double %.1664.i73.i, %.1659.i.i
  %.1667.i.i = fadd contract double %.192.i.i.i, -1.600000e+01
  %.1668.i.i = fmul contract double %.182.i.i.i, %.1667.i.i
  %.1669.i.i208 = fadd contract double %.1668.i.i, 1.200000e+01
  %.1670.i.i209 = fmul contract double %.182.i.i.i, %.1669.i.i208
  %.1671.i.i = fadd contract double %.1670.i.i209, 8.000000e+00
  %.1672.i.i = fmul contract double %.182.i.i.i, %.1671.i.i
  %.1673.i.i = fadd contract double %.1672.i.i, -1.000000e+01
  %.1675.i.i210 = fadd contract double %.230.i.i.i, -1.600000e+01
  %.1676.i.i = fmul contract double %.183.i.i.i, %.1675.i.i210
  %.1677.i.i = fadd contract double %.1676.i.i, 1.200000e+01
  %.1678.i.i = fmul contract double %.183.i.i.i, %.1677.i.i
  %.1679.i.i = fadd contract double %.1678.i.i, 8.000000e+00
  %.1680.i.i = fmul contract double %.183.i.i.i, %.1679.i.i
  %.1681.i.i = fadd contract double %.1680.i.i, -1.000000e+01
  %.1687.i.i211 = fmul contract double %.1651.i.i206, %.1673.i.i
  %.1688.i.i212 = fmul contract double %.1651.i.i206, %296
  %.1689.i.i = fneg contract double %297
  %.1690.i.i213 = fmul contract double %.1651.i.i206, %.1689.i.i
  %.1691.i.i214 = fneg contract double %.1681.i.i
  %.1692.i.i215 = fmul contract double %.1651.i.i206, %.1691.i.i214
  %.1696.i.i = fmul contract double %.1651.i.i206, %.246.i.i.i
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
  %.1874.i.i.i = insertelement <8 x double> poison, double %.1687.i.i211, i64 0
  %.1875.i.i.i = shufflevector <8 x double> %.1874.i.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1901.i.i.i = insertelement <8 x double> poison, double %.1688.i.i212, i64 0
  %.1902.i.i.i = shufflevector <8 x double> %.1901.i.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1904.i.i.i = insertelement <8 x double> poison, double %.1690.i.i213, i64 0
  %.1905.i.i.i = shufflevector <8 x double> %.1904.i.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1940.i.i.i = insertelement <8 x double> poison, double %.1692.i.i215, i64 0
  %.1941.i.i.i = shufflevector <8 x double> %.1940.i.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1943.i.i.i = insertelement <8 x double> poison, double %.1696.i.i, i64 0
  %.1944.i.i.i = shufflevector <8 x double> %.1943.i.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  br i1 %.93.inv.i.i, label %B1112.i.i, label %B394.lr.ph.i.i.i

B1112.i.i:                                        ; preds = %B394.i.i.i, %B382.i.i.i, %_ZN17bnserve_inference14adjoint_kernel7_source10_fill_barsB4v329B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.thread.thread.i.i, %B992.i.i, %B884.i.i
  %exitcond838.not.i.i = icmp eq i64 %.1093.i61.i, %.1000.i55.i
  br i1 %exitcond838.not.i.i, label %_ZN17bnserve_inference14adjoint_kernel7_source16_through_weightsB4v318B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxxx5ArrayIxLi1E1C7mutable7alignedEd5ArrayIdLi1E1C7mutable7alignedE.exit.i, label %B810.if.i.i

B652.if.lr.ph.i.i:                                ; preds = %B950.if.i
  tail call void @llvm.memset.p0.i64(ptr align 8 %.882.i.i, i8 0, i64 %243, i1 false), !noalias !90
  tail call void @llvm.memset.p0.i64(ptr align 8 %.882.1.i.i, i8 0, i64 %243, i1 false), !noalias !90
  tail call void @llvm.memset.p0.i64(ptr align 8 %.882.2.i.i, i8 0, i64 %243, i1 false), !noalias !90
  tail call void @llvm.memset.p0.i64(ptr align 8 %.882.3.i.i, i8 0, i64 %243, i1 false), !noalias !90
  br label %B604.loopexit.3.i.i

B810.if.i.i:                                      ; preds = %B1112.i.i, %B810.if.lr.ph.i.i
  %.1086800810.i.i = phi i64 [ 0, %B810.if.lr.ph.i.i ], [ %.1093.i61.i, %B1112.i.i ]
  %.1093.i61.i = add nuw nsw i64 %.1086800810.i.i, 1
  call void @llvm.lifetime.start.p0(ptr nonnull %.509.i.i.i), !noalias !90
  store ptr null, ptr %.509.i.i.i, align 8, !noalias !96
  %.260.i.i.i = load i64, ptr %.76, align 8, !noalias !96
  %.359.i.i.i = load i64, ptr %sunkaddr18.i57.i, align 8, !noalias !96
  %.360.i.i.i = icmp eq i64 %.359.i.i.i, 1
  br i1 %.360.i.i.i, label %B266.i.i.i, label %B450.i.i.i

B266.i.i.i:                                       ; preds = %B810.if.i.i
  %.290.i.i.i = load i64, ptr %.143, align 8, !noalias !96
  %.368.i.i.i = sub nsw i64 %.290.i.i.i, %.1020890909
  %.13.i.i49.i.i = tail call i64 @llvm.smin.i64(i64 %.368.i.i.i, i64 range(i64 -9223372036854775808, 129) %.13.i)
  %.430.i.i.i = load i64, ptr %sunkaddr22.i58.i, align 8, !noalias !96
  %.438.i.i.i = mul nsw i64 %.260.i.i.i, %.604928988
  %.444.i.i.i = add nsw i64 %.438.i.i.i, %.1195959968.i
  %.448.i.i.i = mul nsw i64 %.290.i.i.i, %.444.i.i.i
  %.452.i.i.i = add nsw i64 %.448.i.i.i, %.1020890909
  %.455.i.i.i = shl nsw i64 %.452.i.i.i, 4
  %.456.i.i.i = add nsw i64 %.455.i.i.i, %.430.i.i.i
  %.457.i.i.i = shl nsw i64 %.13.i.i49.i.i, 1
  %.458.i.i.i = inttoptr i64 %.456.i.i.i to ptr
  store ptr null, ptr %.509.i.i.i, align 8, !noalias !96
  call fastcc void @inner_1(ptr nonnull %.509.i.i.i, i64 %.13.i.i49.i.i, ptr %.458.i.i.i, i64 %.457.i.i.i, ptr nonnull %.1612.i, ptr nonnull %.150.i.i.i)
  br label %_ZN17bnserve_inference14adjoint_kernel7_source10_fill_barsB4v329B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.thread.i.i

B450.i.i.i:                                       ; preds = %B810.if.i.i
  %.320.i.i.i = load i64, ptr %.999.i.i, align 8, !noalias !96
  %.588.i.i.i = load i64, ptr %sunkaddr22.i58.i, align 8, !noalias !96
  %.596.i.i.i = mul nsw i64 %.260.i.i.i, %.604928988
  %.602.i.i.i = add nsw i64 %.596.i.i.i, %.1195959968.i
  %.606.i.i.i = mul nsw i64 %.320.i.i.i, %.602.i.i.i
  %.610.i.i.i = add nsw i64 %.606.i.i.i, %.1086800810.i.i
  %.613.i.i.i = shl nsw i64 %.610.i.i.i, 4
  br i1 %.93.inv.i.i, label %_ZN17bnserve_inference14adjoint_kernel7_source10_fill_barsB4v329B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.thread.thread.i.i, label %B594.if.lr.ph.i.i.i

common.ret.sink.split.loopexit.unr-lcssa.i.i.i:   ; preds = %B594.if.i.i.i
  br i1 %247, label %_ZN17bnserve_inference14adjoint_kernel7_source10_fill_barsB4v329B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.thread.i.i, label %B594.if.epil.preheader.i.i.i

B594.if.epil.preheader.i.i.i:                     ; preds = %B594.if.lr.ph.i.i.i, %common.ret.sink.split.loopexit.unr-lcssa.i.i.i
  %.757421423.epil.init.i.i.i = phi i64 [ 0, %B594.if.lr.ph.i.i.i ], [ %.764.1.i.i.i, %common.ret.sink.split.loopexit.unr-lcssa.i.i.i ]
  %sunkaddr.i.i.i = inttoptr i64 %.613.i.i.i to ptr
  %sunkaddr59.i.i.i = getelementptr i8, ptr %sunkaddr.i.i.i, i64 %.588.i.i.i
  %.818.epil.i.i.i = load double, ptr %sunkaddr59.i.i.i, align 8, !noalias !96
  %.819.epil.i.i.i = insertelement <8 x double> poison, double %.818.epil.i.i.i, i64 0
  %.820.epil.i.i.i = shufflevector <8 x double> %.819.epil.i.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.828.epil.i.i.i = getelementptr inbounds double, ptr %.1612.i, i64 %.757421423.epil.init.i.i.i
  store <8 x double> %.820.epil.i.i.i, ptr %.828.epil.i.i.i, align 8, !noalias !96
  %sunkaddr62.i.i.i = getelementptr i8, ptr %sunkaddr59.i.i.i, i64 8
  %.860.epil.i.i.i = load double, ptr %sunkaddr62.i.i.i, align 8, !noalias !96
  %.861.epil.i.i.i = insertelement <8 x double> poison, double %.860.epil.i.i.i, i64 0
  %.862.epil.i.i.i = shufflevector <8 x double> %.861.epil.i.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.870.epil.i.i.i = getelementptr inbounds double, ptr %.150.i.i.i, i64 %.757421423.epil.init.i.i.i
  store <8 x double> %.862.epil.i.i.i, ptr %.870.epil.i.i.i, align 8, !noalias !96
  br label %_ZN17bnserve_inference14adjoint_kernel7_source10_fill_barsB4v329B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.thread.i.i

_ZN17bnserve_inference14adjoint_kernel7_source10_fill_barsB4v329B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.thread.i.i: ; preds = %B594.if.epil.preheader.i.i.i, %common.ret.sink.split.loopexit.unr-lcssa.i.i.i, %B266.i.i.i
  call void @llvm.lifetime.end.p0(ptr nonnull %.509.i.i.i), !noalias !90
  %.1154.i.i203 = uitofp nneg i64 %.1086800810.i.i to double
  %.1155.i.i204 = fmul contract double %.455747.i.i, %.1154.i.i203
  %.1157.i.i = fadd contract double %.1350.i, %.1155.i.i204
  br i1 %294, label %B884.i.i, label %B992.i.i

_ZN17bnserve_inference14adjoint_kernel7_source10_fill_barsB4v329B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.thread.thread.i.i: ; preds = %B450.i.i.i
  call void @llvm.lifetime.end.p0(ptr nonnull %.509.i.i.i), !noalias !90
  %.11542.i.i = uitofp nneg i64 %.1086800810.i.i to double
  %.11553.i.i = fmul contract double %.455747.i.i, %.11542.i.i
  %.11574.i.i = fadd contract double %.1350.i, %.11553.i.i
  br i1 %294, label %B1112.i.i, label %B992.i.i

B594.if.lr.ph.i.i.i:                              ; preds = %B450.i.i.i
  br i1 %245, label %B594.if.epil.preheader.i.i.i, label %B594.if.i.preheader.i.i

B594.if.i.preheader.i.i:                          ; preds = %B594.if.lr.ph.i.i.i
  %sunkaddr23.i62.i = inttoptr i64 %.613.i.i.i to ptr
  %sunkaddr24.i63.i = getelementptr i8, ptr %sunkaddr23.i62.i, i64 %.588.i.i.i
  %sunkaddr30.i64.i = getelementptr i8, ptr %sunkaddr24.i63.i, i64 8
  br label %B594.if.i.i.i

B594.if.i.i.i:                                    ; preds = %B594.if.i.i.i, %B594.if.i.preheader.i.i
  %lsr.iv7.i.i = phi i64 [ %lsr.iv.next8.i.i, %B594.if.i.i.i ], [ %244, %B594.if.i.preheader.i.i ]
  %.757421423.i.i.i = phi i64 [ %.764.1.i.i.i, %B594.if.i.i.i ], [ 0, %B594.if.i.preheader.i.i ]
  %.818.i.i.i = load double, ptr %sunkaddr24.i63.i, align 8, !noalias !96
  %.819.i.i.i = insertelement <8 x double> poison, double %.818.i.i.i, i64 0
  %.820.i.i.i = shufflevector <8 x double> %.819.i.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %sunkaddr25.i65.i = shl i64 %.757421423.i.i.i, 3
  %sunkaddr26.i.i = getelementptr i8, ptr %.432, i64 %sunkaddr25.i65.i
  %sunkaddr27.i66.i = getelementptr i8, ptr %sunkaddr26.i.i, i64 12288
  store <8 x double> %.820.i.i.i, ptr %sunkaddr27.i66.i, align 8, !noalias !96
  %.860.i.i.i = load double, ptr %sunkaddr30.i64.i, align 8, !noalias !96
  %.861.i.i.i = insertelement <8 x double> poison, double %.860.i.i.i, i64 0
  %.862.i.i.i = shufflevector <8 x double> %.861.i.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %sunkaddr33.i67.i = getelementptr i8, ptr %sunkaddr26.i.i, i64 13312
  store <8 x double> %.862.i.i.i, ptr %sunkaddr33.i67.i, align 8, !noalias !96
  %.764.1.i.i.i = add i64 %.757421423.i.i.i, 16
  %.818.1.i.i.i = load double, ptr %sunkaddr24.i63.i, align 8, !noalias !96
  %.819.1.i.i.i = insertelement <8 x double> poison, double %.818.1.i.i.i, i64 0
  %.820.1.i.i.i = shufflevector <8 x double> %.819.1.i.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %sunkaddr36.i68.i = shl i64 %.764.1.i.i.i, 3
  %sunkaddr37.i69.i = getelementptr i8, ptr %.432, i64 %sunkaddr36.i68.i
  %sunkaddr38.i70.i = getelementptr i8, ptr %sunkaddr37.i69.i, i64 12224
  store <8 x double> %.820.1.i.i.i, ptr %sunkaddr38.i70.i, align 8, !noalias !96
  %.860.1.i.i.i = load double, ptr %sunkaddr30.i64.i, align 8, !noalias !96
  %.861.1.i.i.i = insertelement <8 x double> poison, double %.860.1.i.i.i, i64 0
  %.862.1.i.i.i = shufflevector <8 x double> %.861.1.i.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %sunkaddr41.i71.i = getelementptr i8, ptr %sunkaddr37.i69.i, i64 13248
  store <8 x double> %.862.1.i.i.i, ptr %sunkaddr41.i71.i, align 8, !noalias !96
  %lsr.iv.next8.i.i = add i64 %lsr.iv7.i.i, -2
  %niter.ncmp.1.not.i.i.i = icmp eq i64 %lsr.iv.next8.i.i, 0
  br i1 %niter.ncmp.1.not.i.i.i, label %common.ret.sink.split.loopexit.unr-lcssa.i.i.i, label %B594.if.i.i.i

B382.i.i.i:                                       ; preds = %B382.lr.ph.i.i.i, %B382.i.i.i
  %lsr.iv.i55.i.i = phi i64 [ %.116.i.i147, %B382.lr.ph.i.i.i ], [ %lsr.iv.next.i57.i.i, %B382.i.i.i ]
  %.679.sroa.0.0385.i.i.i = phi i64 [ 0, %B382.lr.ph.i.i.i ], [ %.679.sroa.0.0.i.i.i, %B382.i.i.i ]
  %.695954383.i.i.i = phi i64 [ 8, %B382.lr.ph.i.i.i ], [ %.695954.i.i.i, %B382.i.i.i ]
  %.734.i.i.i = getelementptr inbounds double, ptr %.290.i54.i, i64 %.679.sroa.0.0385.i.i.i
  %.736.i.i.i = load <8 x double>, ptr %.734.i.i.i, align 8, !noalias !100
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
  %298 = icmp eq <8 x i64> %.8.i417.i.i.i, zeroinitializer
  %.6.i419.i.i.i = select <8 x i1> %298, <8 x i64> zeroinitializer, <8 x i64> %.6.i416.i.i.i
  %.8.i420.i.i.i = shl <8 x i64> %.946.i.i.i, splat (i64 62)
  %.8.i421.i.i.i = and <8 x i64> %.8.i420.i.i.i, splat (i64 -9223372036854775808)
  %.8.i423.i.i.i = add <8 x i64> %.8.i420.i.i.i, splat (i64 4611686018427387904)
  %.8.i424.i.i.i = and <8 x i64> %.8.i423.i.i.i, splat (i64 -9223372036854775808)
  %299 = xor <8 x i64> %.8.i421.i.i.i, %.947.i.i.i
  %.6.i426.i.i.i = xor <8 x i64> %299, %.6.i419.i.i.i
  %300 = bitcast <8 x i64> %.6.i426.i.i.i to <8 x double>
  %301 = xor <8 x i64> %.8.i424.i.i.i, %.948.i.i.i
  %.6.i428.i.i.i = xor <8 x i64> %301, %.6.i419.i.i.i
  %302 = bitcast <8 x i64> %.6.i428.i.i.i to <8 x double>
  %sunkaddr.i56.i.i = shl i64 %.679.sroa.0.0385.i.i.i, 3
  %sunkaddr487.i.i.i = getelementptr inbounds i8, ptr %.432, i64 %sunkaddr.i56.i.i
  %sunkaddr488.i.i.i = getelementptr inbounds nuw i8, ptr %sunkaddr487.i.i.i, i64 12288
  %.1293.i.i.i = load <8 x double>, ptr %sunkaddr488.i.i.i, align 8, !noalias !100
  %sunkaddr491.i.i.i = getelementptr inbounds nuw i8, ptr %sunkaddr487.i.i.i, i64 13312
  %.1303.i.i.i = load <8 x double>, ptr %sunkaddr491.i.i.i, align 8, !noalias !100
  %303 = fneg contract <8 x double> %300
  %.8.i430.i.i.i = fmul contract <8 x double> %.1303.i.i.i, %303
  %.1352.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1293.i.i.i, <8 x double> %302, <8 x double> %.8.i430.i.i.i)
  %.6.i431.i.i.i = fmul contract <8 x double> %.1303.i.i.i, %302
  %.1377.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1293.i.i.i, <8 x double> %300, <8 x double> %.6.i431.i.i.i)
  %.1406.i.i.i = getelementptr inbounds double, ptr %.1178.i.i, i64 %.679.sroa.0.0385.i.i.i
  %.1408.i.i.i = load <8 x double>, ptr %.1406.i.i.i, align 8, !noalias !100
  %.1416.i.i.i = getelementptr inbounds double, ptr %.1244.i.i, i64 %.679.sroa.0.0385.i.i.i
  %.1418.i.i.i = load <8 x double>, ptr %.1416.i.i.i, align 8, !noalias !100
  %304 = fneg contract <8 x double> %.1377.i.i.i
  %.8.i433.i.i.i = fmul contract <8 x double> %.1418.i.i.i, %304
  %.1467.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1408.i.i.i, <8 x double> %.1352.i.i.i, <8 x double> %.8.i433.i.i.i)
  %.6.i434.i.i.i = fmul contract <8 x double> %.1418.i.i.i, %.1352.i.i.i
  %.1492.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1408.i.i.i, <8 x double> %.1377.i.i.i, <8 x double> %.6.i434.i.i.i)
  %sunkaddr494.i.i.i = getelementptr inbounds nuw i8, ptr %sunkaddr487.i.i.i, i64 6144
  %.1522.i.i.i = load <8 x double>, ptr %sunkaddr494.i.i.i, align 8, !noalias !100
  %.6.i435.i.i.i = fadd contract <8 x double> %.1522.i.i.i, %.1467.i.i.i
  store <8 x double> %.6.i435.i.i.i, ptr %sunkaddr494.i.i.i, align 8, !noalias !100
  %sunkaddr497.i.i.i = getelementptr inbounds nuw i8, ptr %sunkaddr487.i.i.i, i64 7168
  %.1566.i.i.i = load <8 x double>, ptr %sunkaddr497.i.i.i, align 8, !noalias !100
  %.6.i436.i.i.i = fadd contract <8 x double> %.1566.i.i.i, %.1492.i.i.i
  store <8 x double> %.6.i436.i.i.i, ptr %sunkaddr497.i.i.i, align 8, !noalias !100
  %sunkaddr500.i.i.i = getelementptr inbounds nuw i8, ptr %sunkaddr487.i.i.i, i64 8192
  %.1610.i.i.i = load <8 x double>, ptr %sunkaddr500.i.i.i, align 8, !noalias !100
  %.6.i437.i.i.i = fmul contract <8 x double> %.8.i.i.i.i, %.1492.i.i.i
  %.6.i438.i.i.i = fsub contract <8 x double> %.1610.i.i.i, %.6.i437.i.i.i
  store <8 x double> %.6.i438.i.i.i, ptr %sunkaddr500.i.i.i, align 8, !noalias !100
  %sunkaddr503.i.i.i = getelementptr inbounds nuw i8, ptr %sunkaddr487.i.i.i, i64 9216
  %.1678.i.i.i = load <8 x double>, ptr %sunkaddr503.i.i.i, align 8, !noalias !100
  %.1679.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i.i.i.i, <8 x double> %.1467.i.i.i, <8 x double> %.1678.i.i.i)
  store <8 x double> %.1679.i.i.i, ptr %sunkaddr503.i.i.i, align 8, !noalias !100
  %.689.i.i.i = icmp samesign ugt i64 %lsr.iv.i55.i.i, 1
  %.702.i.i.i = add i64 %.695954383.i.i.i, 8
  %.695954.i.i.i = select i1 %.689.i.i.i, i64 %.702.i.i.i, i64 %.695954383.i.i.i
  %.679.sroa.0.0.i.i.i = select i1 %.689.i.i.i, i64 %.695954383.i.i.i, i64 0
  %lsr.iv.next.i57.i.i = add nsw i64 %lsr.iv.i55.i.i, -1
  %B382.termcond.i.i.i = icmp sgt i64 %lsr.iv.i55.i.i, 1
  br i1 %B382.termcond.i.i.i, label %B382.i.i.i, label %B1112.i.i

B382.lr.ph.i.i.i:                                 ; preds = %B884.i.i
  %.6.i.i.i.i = insertelement <8 x double> poison, double %.1157.i.i, i64 0
  %.7.i.i.i.i = shufflevector <8 x double> %.6.i.i.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  br label %B382.i.i.i

B394.i.i.i:                                       ; preds = %B394.lr.ph.i.i.i, %B394.i.i.i
  %lsr.iv.i61.i.i = phi i64 [ %.116.i.i147, %B394.lr.ph.i.i.i ], [ %lsr.iv.next.i68.i.i, %B394.i.i.i ]
  %.735.sroa.0.0673.i.i.i = phi i64 [ 0, %B394.lr.ph.i.i.i ], [ %.735.sroa.0.0.i.i.i, %B394.i.i.i ]
  %.7511582671.i.i.i = phi i64 [ 8, %B394.lr.ph.i.i.i ], [ %.7511582.i.i.i, %B394.i.i.i ]
  %.790.i.i.i = getelementptr inbounds double, ptr %.290.i54.i, i64 %.735.sroa.0.0673.i.i.i
  %.792.i62.i.i = load <8 x double>, ptr %.790.i.i.i, align 8, !noalias !103
  %.8.i.i63.i.i = fmul contract <8 x double> %.792.i62.i.i, splat (double 0xC01921FB54442D18)
  %.8.i700.i.i.i = fmul contract <8 x double> %.7.i.i60.i.i, %.8.i.i63.i.i
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
  %.947.i64.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i702.i.i.i, <8 x double> %.944.i.i.i, <8 x double> splat (double 0x3F81111111111111))
  %.950.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i702.i.i.i, <8 x double> %.947.i64.i.i, <8 x double> splat (double 0xBFC5555555555555))
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
  %305 = icmp eq <8 x i64> %.8.i705.i.i.i, zeroinitializer
  %.6.i707.i.i.i = select <8 x i1> %305, <8 x i64> zeroinitializer, <8 x i64> %.6.i704.i.i.i
  %.8.i708.i.i.i = shl <8 x i64> %.1002.i.i.i, splat (i64 62)
  %.8.i709.i.i.i = and <8 x i64> %.8.i708.i.i.i, splat (i64 -9223372036854775808)
  %.8.i711.i.i.i = add <8 x i64> %.8.i708.i.i.i, splat (i64 4611686018427387904)
  %.8.i712.i.i.i = and <8 x i64> %.8.i711.i.i.i, splat (i64 -9223372036854775808)
  %306 = xor <8 x i64> %.8.i709.i.i.i, %.1003.i.i.i
  %.6.i714.i.i.i = xor <8 x i64> %306, %.6.i707.i.i.i
  %307 = bitcast <8 x i64> %.6.i714.i.i.i to <8 x double>
  %308 = xor <8 x i64> %.8.i712.i.i.i, %.1004.i.i.i
  %.6.i716.i.i.i = xor <8 x i64> %308, %.6.i707.i.i.i
  %309 = bitcast <8 x i64> %.6.i716.i.i.i to <8 x double>
  %sunkaddr.i65.i.i = shl i64 %.735.sroa.0.0673.i.i.i, 3
  %sunkaddr792.i.i.i = getelementptr inbounds i8, ptr %.432, i64 %sunkaddr.i65.i.i
  %sunkaddr793.i.i.i = getelementptr inbounds nuw i8, ptr %sunkaddr792.i.i.i, i64 12288
  %.1349.i.i.i = load <8 x double>, ptr %sunkaddr793.i.i.i, align 8, !noalias !103
  %sunkaddr796.i.i.i = getelementptr inbounds nuw i8, ptr %sunkaddr792.i.i.i, i64 13312
  %.1359.i.i.i = load <8 x double>, ptr %sunkaddr796.i.i.i, align 8, !noalias !103
  %310 = fneg contract <8 x double> %307
  %.8.i718.i.i.i = fmul contract <8 x double> %.1359.i.i.i, %310
  %.1408.i66.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1349.i.i.i, <8 x double> %309, <8 x double> %.8.i718.i.i.i)
  %.6.i719.i.i.i = fmul contract <8 x double> %.1359.i.i.i, %309
  %.1433.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1349.i.i.i, <8 x double> %307, <8 x double> %.6.i719.i.i.i)
  %.1455.i.i.i = add nsw i64 %.735.sroa.0.0673.i.i.i, %.267.i.i.i
  %.1459.i.i.i = add nsw i64 %.735.sroa.0.0673.i.i.i, %.1458.i.i.i
  %gep.i.i.i = getelementptr double, ptr %invariant.gep.i.i.i, i64 %.1455.i.i.i
  %.1483.i.i.i = load <8 x double>, ptr %gep.i.i.i, align 8, !noalias !103
  %.1491.i.i.i = getelementptr inbounds double, ptr %293, i64 %.1455.i.i.i
  %.1493.i.i.i = load <8 x double>, ptr %.1491.i.i.i, align 8, !noalias !103
  %.8.i722.i.i.i = fmul contract <8 x double> %.7.i721.i.i.i, %.1493.i.i.i
  %.1521.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1483.i.i.i, <8 x double> %.1520.i.i.i, <8 x double> %.8.i722.i.i.i)
  %gep1622.i.i.i = getelementptr double, ptr %invariant.gep1621.i.i.i, i64 %.1455.i.i.i
  %.1532.i.i.i = load <8 x double>, ptr %gep1622.i.i.i, align 8, !noalias !103
  %gep1624.i.i.i = getelementptr double, ptr %invariant.gep1623.i.i.i, i64 %.1455.i.i.i
  %.1544.i.i.i = load <8 x double>, ptr %gep1624.i.i.i, align 8, !noalias !103
  %.1548.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1544.i.i.i, <8 x double> %.1547.i.i.i, <8 x double> %.1521.i.i.i)
  %.1551.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1532.i.i.i, <8 x double> %.1550.i.i.i, <8 x double> %.1548.i.i.i)
  %gep1626.i.i.i = getelementptr double, ptr %invariant.gep1625.i.i.i, i64 %.1455.i.i.i
  %.1562.i.i.i = load <8 x double>, ptr %gep1626.i.i.i, align 8, !noalias !103
  %gep1628.i.i.i = getelementptr double, ptr %invariant.gep1627.i.i.i, i64 %.1455.i.i.i
  %.1574.i.i.i = load <8 x double>, ptr %gep1628.i.i.i, align 8, !noalias !103
  %.1587.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1574.i.i.i, <8 x double> %.1586.i.i.i, <8 x double> %.1551.i.i.i)
  %.1590.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1562.i.i.i, <8 x double> %.1589.i.i.i, <8 x double> %.1587.i.i.i)
  %gep1542.i.i.i = getelementptr double, ptr %invariant.gep.i.i.i, i64 %.1459.i.i.i
  %.1613.i.i.i = load <8 x double>, ptr %gep1542.i.i.i, align 8, !noalias !103
  %.1621.i.i.i = getelementptr inbounds double, ptr %293, i64 %.1459.i.i.i
  %.1623.i.i.i = load <8 x double>, ptr %.1621.i.i.i, align 8, !noalias !103
  %.8.i725.i.i.i = fmul contract <8 x double> %.7.i721.i.i.i, %.1623.i.i.i
  %.1651.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1613.i.i.i, <8 x double> %.1520.i.i.i, <8 x double> %.8.i725.i.i.i)
  %gep1630.i.i.i = getelementptr double, ptr %invariant.gep1621.i.i.i, i64 %.1459.i.i.i
  %.1662.i.i.i = load <8 x double>, ptr %gep1630.i.i.i, align 8, !noalias !103
  %gep1632.i.i.i = getelementptr double, ptr %invariant.gep1623.i.i.i, i64 %.1459.i.i.i
  %.1674.i.i.i = load <8 x double>, ptr %gep1632.i.i.i, align 8, !noalias !103
  %.1678.i67.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1674.i.i.i, <8 x double> %.1547.i.i.i, <8 x double> %.1651.i.i.i)
  %.1681.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1662.i.i.i, <8 x double> %.1550.i.i.i, <8 x double> %.1678.i67.i.i)
  %gep1634.i.i.i = getelementptr double, ptr %invariant.gep1625.i.i.i, i64 %.1459.i.i.i
  %.1692.i.i.i = load <8 x double>, ptr %gep1634.i.i.i, align 8, !noalias !103
  %gep1636.i.i.i = getelementptr double, ptr %invariant.gep1627.i.i.i, i64 %.1459.i.i.i
  %.1704.i.i.i = load <8 x double>, ptr %gep1636.i.i.i, align 8, !noalias !103
  %.1717.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1704.i.i.i, <8 x double> %.1586.i.i.i, <8 x double> %.1681.i.i.i)
  %.1720.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1692.i.i.i, <8 x double> %.1589.i.i.i, <8 x double> %.1717.i.i.i)
  %311 = fneg contract <8 x double> %.1433.i.i.i
  %.8.i727.i.i.i = fmul contract <8 x double> %.1720.i.i.i, %311
  %.1769.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1590.i.i.i, <8 x double> %.1408.i66.i.i, <8 x double> %.8.i727.i.i.i)
  %.6.i728.i.i.i = fmul contract <8 x double> %.1720.i.i.i, %.1408.i66.i.i
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
  %.8.i736.i.i.i = fmul contract <8 x double> %.2075.i.i.i, %311
  %.2124.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1945.i.i.i, <8 x double> %.1408.i66.i.i, <8 x double> %.8.i736.i.i.i)
  %.6.i737.i.i.i = fmul contract <8 x double> %.2075.i.i.i, %.1408.i66.i.i
  %.2149.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1945.i.i.i, <8 x double> %.1433.i.i.i, <8 x double> %.6.i737.i.i.i)
  %sunkaddr799.i.i.i = getelementptr inbounds nuw i8, ptr %sunkaddr792.i.i.i, i64 6144
  %.2179.i.i.i = load <8 x double>, ptr %sunkaddr799.i.i.i, align 8, !noalias !103
  %.6.i738.i.i.i = fadd contract <8 x double> %.2179.i.i.i, %.1769.i.i.i
  store <8 x double> %.6.i738.i.i.i, ptr %sunkaddr799.i.i.i, align 8, !noalias !103
  %sunkaddr802.i.i.i = getelementptr inbounds nuw i8, ptr %sunkaddr792.i.i.i, i64 7168
  %.2223.i.i.i = load <8 x double>, ptr %sunkaddr802.i.i.i, align 8, !noalias !103
  %.6.i739.i.i.i = fadd contract <8 x double> %.2223.i.i.i, %.1794.i.i.i
  store <8 x double> %.6.i739.i.i.i, ptr %sunkaddr802.i.i.i, align 8, !noalias !103
  %sunkaddr805.i.i.i = getelementptr inbounds nuw i8, ptr %sunkaddr792.i.i.i, i64 8192
  %.2267.i.i.i = load <8 x double>, ptr %sunkaddr805.i.i.i, align 8, !noalias !103
  %.6.i740.i.i.i = fmul contract <8 x double> %.8.i.i63.i.i, %.1794.i.i.i
  %.6.i741.i.i.i = fsub contract <8 x double> %.2124.i.i.i, %.6.i740.i.i.i
  %.6.i742.i.i.i = fadd contract <8 x double> %.2267.i.i.i, %.6.i741.i.i.i
  store <8 x double> %.6.i742.i.i.i, ptr %sunkaddr805.i.i.i, align 8, !noalias !103
  %sunkaddr808.i.i.i = getelementptr inbounds nuw i8, ptr %sunkaddr792.i.i.i, i64 9216
  %.2359.i.i.i = load <8 x double>, ptr %sunkaddr808.i.i.i, align 8, !noalias !103
  %.2360.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i.i63.i.i, <8 x double> %.1769.i.i.i, <8 x double> %.2149.i.i.i)
  %.6.i743.i.i.i = fadd contract <8 x double> %.2359.i.i.i, %.2360.i.i.i
  store <8 x double> %.6.i743.i.i.i, ptr %sunkaddr808.i.i.i, align 8, !noalias !103
  %.745.i.i.i = icmp samesign ugt i64 %lsr.iv.i61.i.i, 1
  %.758.i.i.i = add i64 %.7511582671.i.i.i, 8
  %.7511582.i.i.i = select i1 %.745.i.i.i, i64 %.758.i.i.i, i64 %.7511582671.i.i.i
  %.735.sroa.0.0.i.i.i = select i1 %.745.i.i.i, i64 %.7511582671.i.i.i, i64 0
  %lsr.iv.next.i68.i.i = add nsw i64 %lsr.iv.i61.i.i, -1
  %B394.termcond.i.i.i = icmp sgt i64 %lsr.iv.i61.i.i, 1
  br i1 %B394.termcond.i.i.i, label %B394.i.i.i, label %B1112.i.i

B394.lr.ph.i.i.i:                                 ; preds = %B992.i.i
  %.1682.i.i = fneg contract double %.183.i.i.i
  %.1683.i.i = fmul contract double %.183.i.i.i, %.1682.i.i
  %.1684.i.i = fmul contract double %.183.i.i.i, %.1683.i.i
  %.1685.i.i = fmul contract double %.183.i.i.i, %.1684.i.i
  %.1686.i.i216 = fmul contract double %.1651.i.i206, %.1685.i.i
  %.186.i.i.i = fmul contract double %.183.i.i.i, %.185.i.i.i
  %.187.i.i.i = fmul contract double %.183.i.i.i, %.186.i.i.i
  %.191.i.i.i = fdiv contract double %.187.i.i.i, 1.200000e+02
  %.6.i.i59.i.i = insertelement <8 x double> poison, double %.11575.i.i, i64 0
  %.7.i.i60.i.i = shufflevector <8 x double> %.6.i.i59.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.6.i720.i.i.i = insertelement <8 x double> poison, double %.191.i.i.i, i64 0
  %.7.i721.i.i.i = shufflevector <8 x double> %.6.i720.i.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.6.i729.i.i.i = insertelement <8 x double> poison, double %.1686.i.i216, i64 0
  %.7.i730.i.i.i = shufflevector <8 x double> %.6.i729.i.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  br label %B394.i.i.i

_ZN17bnserve_inference14adjoint_kernel7_source16_through_weightsB4v318B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxxx5ArrayIxLi1E1C7mutable7alignedEd5ArrayIdLi1E1C7mutable7alignedE.exit.i: ; preds = %B1112.i.i, %B604.loopexit.3.i.i
  %.74.i.i = load i64, ptr %.76, align 8, !noalias !106
  %.190.i74.i = add nsw i64 %.74.i.i, 1
  %.192.i.i = mul nsw i64 %.190.i74.i, %.74.i.i
  %.272.i75.i = and i64 %.192.i.i, -2
  %.412887.not.i.i = icmp slt i64 %.74.i.i, 1
  br i1 %.412887.not.i.i, label %_ZN17bnserve_inference14adjoint_kernel7_source14_through_pairsB4v376B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i, label %B290.if.lr.ph.i.i

B290.loopexit.i.i:                                ; preds = %B1078.i.i
  %.425.i.i = add nuw nsw i64 %.356.0.i.i, 1
  %scevgep267.i.i = getelementptr i8, ptr %lsr.iv.i78.i, i64 27648
  %exitcond262.not.i.i = icmp eq i64 %.425.i.i, %.74.i.i
  br i1 %exitcond262.not.i.i, label %_ZN17bnserve_inference14adjoint_kernel7_source14_through_pairsB4v376B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i, label %B290.if.i.i

B836.i.i:                                         ; preds = %B274.i.i.i, %B328.if.i.i
  br i1 %brmerge1.i.i, label %B1078.i.i, label %B174.if.preheader.i117.i.i

B1078.i.i:                                        ; preds = %B274.i130.i.i, %B836.i.i
  %.1704.i.i = add nsw i64 %at.2.1884.i.i, 1
  %scevgep276.i.i = getelementptr i8, ptr %lsr.iv275.i.i, i64 27648
  %exitcond.not.i93.i = icmp eq i64 %.553.i.i221, %.74.i.i
  br i1 %exitcond.not.i93.i, label %B290.loopexit.i.i, label %B328.if.i.i

B290.if.lr.ph.i.i:                                ; preds = %_ZN17bnserve_inference14adjoint_kernel7_source16_through_weightsB4v318B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxxx5ArrayIxLi1E1C7mutable7alignedEd5ArrayIdLi1E1C7mutable7alignedE.exit.i
  %.200.1.i.i = lshr i64 %.192.i.i, 1
  %.269.i76.i = mul i64 %.268.i.i192, %.200.1.i.i
  %.266.i.i217 = load i64, ptr %.265.i.i193, align 8, !noalias !106
  %.270.i.i218 = add nsw i64 %.266.i.i217, %.269.i76.i
  %.178.i.i219 = load i64, ptr %.500.i.i191, align 8, !noalias !106
  %312 = icmp eq i64 %.178.i.i219, 1
  %.105.i.i = load i64, ptr %.143, align 8, !noalias !106
  %.106.i.i = sub i64 0, %.105.i.i
  %.114.1.i.i = and i64 %.106.i.i, -8
  %.148.i.i = sub i64 0, %.114.1.i.i
  %.585.i.i = mul nsw i64 %.1212877881, %.148.i.i
  %.591.i.i220 = shl nsw i64 %.148.i.i, 1
  %.594.i.i = mul nuw nsw i64 %.200.1.i.i, %.1212877881
  %313 = mul i64 %.114.1.i.i, -8
  %314 = select i1 %312, i64 0, i64 %313
  %315 = inttoptr i64 %.270.i.i218 to ptr
  br label %B290.if.i.i

B290.if.i.i:                                      ; preds = %B290.if.lr.ph.i.i, %B290.loopexit.i.i
  %lsr.iv.i78.i = phi ptr [ %scevgep266.i.i, %B290.if.lr.ph.i.i ], [ %scevgep267.i.i, %B290.loopexit.i.i ]
  %.356.0.i.i = phi i64 [ 0, %B290.if.lr.ph.i.i ], [ %.425.i.i, %B290.loopexit.i.i ]
  %at.3.0888.i.i = phi i64 [ 0, %B290.if.lr.ph.i.i ], [ %.1704.i.i, %B290.loopexit.i.i ]
  %316 = icmp ne i64 %.356.0.i.i, %.1195959968.i
  %brmerge1.i.i = select i1 %316, i1 true, i1 %.93.inv.i.i
  br label %B328.if.i.i

B328.if.i.i:                                      ; preds = %B290.if.i.i, %B1078.i.i
  %lsr.iv275.i.i = phi ptr [ %lsr.iv.i78.i, %B290.if.i.i ], [ %scevgep276.i.i, %B1078.i.i ]
  %.484.0.i.i = phi i64 [ %.356.0.i.i, %B290.if.i.i ], [ %.553.i.i221, %B1078.i.i ]
  %at.2.1884.i.i = phi i64 [ %at.3.0888.i.i, %B290.if.i.i ], [ %.1704.i.i, %B1078.i.i ]
  %.553.i.i221 = add nuw i64 %.484.0.i.i, 1
  %.596.i.i222 = add nsw i64 %at.2.1884.i.i, %.594.i.i
  %.597.i.i = mul nsw i64 %.591.i.i220, %.596.i.i222
  %"$phi374.2.2.2.i.i" = select i1 %312, i64 %.585.i.i, i64 %.597.i.i
  %.634.i.i = load i64, ptr %sunkaddr12.i77.i, align 8, !noalias !106
  %.635.i.i = shl nsw i64 %"$phi374.2.2.2.i.i", 3
  %.636.i.i223 = add nsw i64 %.635.i.i, %.634.i.i
  %.639.i.i = inttoptr i64 %.636.i.i223 to ptr
  %.805.i.i224 = getelementptr double, ptr %.639.i.i, i64 %.1020890909
  %.873.i.i = icmp slt i64 %at.2.1884.i.i, 0
  %.874.i.i = select i1 %.873.i.i, i64 %.272.i75.i, i64 0
  %.idx57.i.i = shl i64 %at.2.1884.i.i, 4
  %317 = getelementptr i8, ptr %315, i64 %.idx57.i.i
  %.888.i.i = getelementptr double, ptr %317, i64 %.874.i.i
  %.889.i79.i = load double, ptr %.888.i.i, align 8, !noalias !106
  %318 = getelementptr i8, ptr %317, i64 8
  %.921.i.i225 = getelementptr double, ptr %318, i64 %.874.i.i
  %.922.i.i226 = load double, ptr %.921.i.i225, align 8, !noalias !106
  %.951.i.i227 = icmp ne i64 %.484.0.i.i, %.1195959968.i
  %brmerge.i.i = or i1 %.93.inv.i.i, %.951.i.i227
  br i1 %brmerge.i.i, label %B836.i.i, label %B174.if.preheader.i.i.i

B174.if.preheader.i.i.i:                          ; preds = %B328.if.i.i
  %.6.i.i.i80.i = insertelement <8 x double> poison, double %.889.i79.i, i64 0
  %.7.i.i.i81.i = shufflevector <8 x double> %.6.i.i.i80.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.6.i97.i.i.i = insertelement <8 x double> poison, double %.922.i.i226, i64 0
  %.7.i98.i.i.i = shufflevector <8 x double> %.6.i97.i.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %scevgep7.i.i = getelementptr i8, ptr %.805.i.i224, i64 %314
  br label %B174.if.i.i.i

B214.i.i.i:                                       ; preds = %B174.if.i.i.i
  %scevgep8.i.i228 = getelementptr i8, ptr %scevgep7.i.i, i64 %lsr.iv133.i.i.i
  %.478.i.i.i = load <8 x double>, ptr %scevgep8.i.i228, align 8, !noalias !109
  br label %B274.i.i.i

B274.i.i.i:                                       ; preds = %B174.if.i.i.i, %B214.i.i.i
  %"$phi274.1.2.1.i.i.i" = phi <8 x double> [ %.478.i.i.i, %B214.i.i.i ], [ zeroinitializer, %B174.if.i.i.i ]
  %.8.i.i.i82.i = fmul contract <8 x double> %.7.i.i.i81.i, %.462.i.i.i
  %.8.i99.i.i.i = fmul contract <8 x double> %.7.i98.i.i.i, %"$phi274.1.2.1.i.i.i"
  %.6.i100.i.i.i = fsub contract <8 x double> %.8.i.i.i82.i, %.8.i99.i.i.i
  %.8.i103.i.i.i = fmul contract <8 x double> %.7.i98.i.i.i, %.462.i.i.i
  %.8.i106.i.i.i = fmul contract <8 x double> %.7.i.i.i81.i, %"$phi274.1.2.1.i.i.i"
  %.6.i107.i.i.i = fadd contract <8 x double> %.8.i103.i.i.i, %.8.i106.i.i.i
  %scevgep269.i.i = getelementptr i8, ptr %lsr.iv.i78.i, i64 %lsr.iv133.i.i.i
  %scevgep270.i.i = getelementptr i8, ptr %scevgep269.i.i, i64 -1024
  %.678.i.i.i = load <8 x double>, ptr %scevgep270.i.i, align 8, !noalias !109
  %.689.i.i83.i = load <8 x double>, ptr %scevgep269.i.i, align 8, !noalias !109
  %sunkaddr.i84.i = getelementptr i8, ptr %.432, i64 %lsr.iv133.i.i.i
  %sunkaddr13.i85.i = getelementptr i8, ptr %sunkaddr.i84.i, i64 6144
  %.700.i.i.i = load <8 x double>, ptr %sunkaddr13.i85.i, align 8, !noalias !109
  %.6.i111.i.i.i = fmul contract <8 x double> %.689.i.i83.i, %.6.i107.i.i.i
  %.725.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i100.i.i.i, <8 x double> %.678.i.i.i, <8 x double> %.6.i111.i.i.i)
  %.6.i112.i.i.i = fadd contract <8 x double> %.700.i.i.i, %.725.i.i.i
  store <8 x double> %.6.i112.i.i.i, ptr %sunkaddr13.i85.i, align 8, !noalias !109
  %sunkaddr15.i86.i = getelementptr i8, ptr %sunkaddr.i84.i, i64 7168
  %.771.i.i.i = load <8 x double>, ptr %sunkaddr15.i86.i, align 8, !noalias !109
  %.6.i113.i.i.i = fmul contract <8 x double> %.678.i.i.i, %.6.i107.i.i.i
  %.6.i114.i.i.i = fmul contract <8 x double> %.6.i100.i.i.i, %.689.i.i83.i
  %.6.i115.i.i.i = fsub contract <8 x double> %.6.i113.i.i.i, %.6.i114.i.i.i
  %.6.i116.i.i.i = fadd contract <8 x double> %.6.i115.i.i.i, %.771.i.i.i
  store <8 x double> %.6.i116.i.i.i, ptr %sunkaddr15.i86.i, align 8, !noalias !109
  %lsr.iv.next134.i.i.i = add i64 %lsr.iv133.i.i.i, 64
  %lsr.iv.next.i87.i = add nsw i64 %lsr.iv2.i.i, -1
  %.411.i.i.i = icmp sgt i64 %lsr.iv2.i.i, 6
  br i1 %.411.i.i.i, label %B174.if.i.i.i, label %B836.i.i

B174.if.i.i.i:                                    ; preds = %B274.i.i.i, %B174.if.preheader.i.i.i
  %lsr.iv2.i.i = phi i64 [ %lsr.iv.next.i87.i, %B274.i.i.i ], [ %248, %B174.if.preheader.i.i.i ]
  %lsr.iv133.i.i.i = phi i64 [ %lsr.iv.next134.i.i.i, %B274.i.i.i ], [ 0, %B174.if.preheader.i.i.i ]
  %scevgep140.i.i.i = getelementptr i8, ptr %.805.i.i224, i64 %lsr.iv133.i.i.i
  %.462.i.i.i = load <8 x double>, ptr %scevgep140.i.i.i, align 8, !noalias !109
  br i1 %312, label %B274.i.i.i, label %B214.i.i.i

B174.if.preheader.i117.i.i:                       ; preds = %B836.i.i
  %.6.i.i118.i.i = insertelement <8 x double> poison, double %.889.i79.i, i64 0
  %.7.i.i119.i.i = shufflevector <8 x double> %.6.i.i118.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.6.i97.i120.i.i = insertelement <8 x double> poison, double %.922.i.i226, i64 0
  %.7.i98.i121.i.i = shufflevector <8 x double> %.6.i97.i120.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %scevgep13.i.i229 = getelementptr i8, ptr %.805.i.i224, i64 %314
  br label %B174.if.i122.i.i

B214.i127.i.i:                                    ; preds = %B174.if.i122.i.i
  %scevgep14.i.i = getelementptr i8, ptr %scevgep13.i.i229, i64 %lsr.iv133.i123.i.i
  %.478.i129.i.i = load <8 x double>, ptr %scevgep14.i.i, align 8, !noalias !112
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
  %.678.i139.i.i = load <8 x double>, ptr %scevgep279.i.i, align 8, !noalias !112
  %.689.i141.i.i = load <8 x double>, ptr %scevgep278.i.i, align 8, !noalias !112
  %sunkaddr16.i89.i = getelementptr i8, ptr %.432, i64 %lsr.iv133.i123.i.i
  %sunkaddr17.i90.i = getelementptr i8, ptr %sunkaddr16.i89.i, i64 6144
  %.700.i144.i.i = load <8 x double>, ptr %sunkaddr17.i90.i, align 8, !noalias !112
  %.6.i111.i145.i.i = fmul contract <8 x double> %.689.i141.i.i, %.8.i110.i.i.i
  %.725.i146.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i100.i134.i.i, <8 x double> %.678.i139.i.i, <8 x double> %.6.i111.i145.i.i)
  %.6.i112.i147.i.i = fadd contract <8 x double> %.700.i144.i.i, %.725.i146.i.i
  store <8 x double> %.6.i112.i147.i.i, ptr %sunkaddr17.i90.i, align 8, !noalias !112
  %sunkaddr19.i91.i = getelementptr i8, ptr %sunkaddr16.i89.i, i64 7168
  %.771.i149.i.i = load <8 x double>, ptr %sunkaddr19.i91.i, align 8, !noalias !112
  %.6.i113.i150.i.i = fmul contract <8 x double> %.678.i139.i.i, %.8.i110.i.i.i
  %.6.i114.i151.i.i = fmul contract <8 x double> %.6.i100.i134.i.i, %.689.i141.i.i
  %.6.i115.i152.i.i = fsub contract <8 x double> %.6.i113.i150.i.i, %.6.i114.i151.i.i
  %.6.i116.i153.i.i = fadd contract <8 x double> %.6.i115.i152.i.i, %.771.i149.i.i
  store <8 x double> %.6.i116.i153.i.i, ptr %sunkaddr19.i91.i, align 8, !noalias !112
  %lsr.iv.next134.i155.i.i = add i64 %lsr.iv133.i123.i.i, 64
  %lsr.iv.next8.i92.i = add nsw i64 %lsr.iv7.i88.i, -1
  %.411.i156.i.i = icmp sgt i64 %lsr.iv7.i88.i, 6
  br i1 %.411.i156.i.i, label %B174.if.i122.i.i, label %B1078.i.i

B174.if.i122.i.i:                                 ; preds = %B274.i130.i.i, %B174.if.preheader.i117.i.i
  %lsr.iv7.i88.i = phi i64 [ %lsr.iv.next8.i92.i, %B274.i130.i.i ], [ %248, %B174.if.preheader.i117.i.i ]
  %lsr.iv133.i123.i.i = phi i64 [ %lsr.iv.next134.i155.i.i, %B274.i130.i.i ], [ 0, %B174.if.preheader.i117.i.i ]
  %scevgep140.i125.i.i = getelementptr i8, ptr %.805.i.i224, i64 %lsr.iv133.i123.i.i
  %.462.i126.i.i = load <8 x double>, ptr %scevgep140.i125.i.i, align 8, !noalias !112
  br i1 %312, label %B274.i130.i.i, label %B214.i127.i.i

_ZN17bnserve_inference14adjoint_kernel7_source14_through_pairsB4v376B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i: ; preds = %B290.loopexit.i.i, %_ZN17bnserve_inference14adjoint_kernel7_source16_through_weightsB4v318B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxxx5ArrayIxLi1E1C7mutable7alignedEd5ArrayIdLi1E1C7mutable7alignedE.exit.i
  br i1 %brmerge.not.i, label %B268.if.i.i, label %B1158.i

_ZN17bnserve_inference14adjoint_kernel7_source12_in_detectorB4v146B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxx5ArrayIxLi1E1C7mutable7alignedEd5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit: ; preds = %B1406.i, %_ZN17bnserve_inference14adjoint_kernel5_back15errors_to_nodesB4v546B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i
  call void @llvm.lifetime.end.p0(ptr nonnull %.869.i)
  call void @llvm.lifetime.end.p0(ptr nonnull %.904.i)
  %.1219 = add nuw nsw i64 %.1212877881, 1
  %scevgep = getelementptr i8, ptr %lsr.iv, i64 152
  %scevgep249 = getelementptr i8, ptr %lsr.iv248, i64 200
  %exitcond.not = icmp eq i64 %.47, %.1219
  br i1 %exitcond.not, label %B1190, label %B1018.if

B1232.endif:                                      ; preds = %B244.if.i, %B1232
  %.1537 = load i64, ptr %sunkaddr118, align 8
  %.1538.not = icmp eq i64 %.1537, 0
  br i1 %.1538.not, label %B1390, label %B1312
}

; Function Attrs: mustprogress nocallback nocreateundeforpoison nofree nosync nounwind speculatable willreturn memory(none)
declare i64 @llvm.smin.i64(i64, i64) #2

; Function Attrs: mustprogress nocallback nocreateundeforpoison nofree nosync nounwind speculatable willreturn memory(none)
declare i64 @llvm.smax.i64(i64, i64) #2

; Function Attrs: mustprogress nocallback nocreateundeforpoison nofree nosync nounwind speculatable willreturn memory(none)
declare <8 x double> @llvm.fma.v8f64(<8 x double>, <8 x double>, <8 x double>) #2

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
  br i1 %.599191, label %B380, label %B5388

B380:                                             ; preds = %entry, %B5387
  %lsr.iv = phi i64 [ %lsr.iv.next, %B5387 ], [ 1, %entry ]
  %.589.sroa.0.0196 = phi i64 [ %.589.sroa.0.0, %B5387 ], [ 0, %entry ]
  %.546.1195.in = phi i64 [ %33, %B5387 ], [ %arg.size, %entry ]
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
  br i1 %.959, label %B1030.endif, label %B5233

B5233:                                            ; preds = %B380
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
  br label %B5271

B5271:                                            ; preds = %B1030.endif, %B5233
  %_transfer_v199__v34call_7.2.sroa.8.1 = phi double [ %.980, %B1030.endif ], [ %.1029, %B5233 ]
  %_transfer_v199__v34call_7.2.sroa.0.1 = phi double [ %.970, %B1030.endif ], [ %.1012, %B5233 ]
  %.1072 = fadd contract double %.801, 1.000000e+00
  %.1074 = fmul contract double %.841, %.1072
  %.1080 = fmul contract double %.1074, %.1074
  %.1180 = fcmp contract olt double %.1080, 0x3EB0C6F7A0B5ED8D
  br i1 %.1180, label %B5272.endif, label %B5349

B5349:                                            ; preds = %B5271
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
  br label %B5387

B5387:                                            ; preds = %B5272.endif, %B5349
  %_transfer_v199__v82call_18.2.sroa.8.1 = phi double [ %.1201, %B5272.endif ], [ %.1250, %B5349 ]
  %_transfer_v199__v82call_18.2.sroa.0.1 = phi double [ %.1191, %B5272.endif ], [ %.1233, %B5349 ]
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
  %.1376 = fadd contract double %_transfer_v199__v34call_7.2.sroa.0.1, %_transfer_v199__v82call_18.2.sroa.0.1
  %.1377 = fmul contract double %.1374, %.1376
  %.1378 = fmul contract double %.1350, 5.000000e-01
  %.1380 = fsub contract double %_transfer_v199__v34call_7.2.sroa.0.1, %_transfer_v199__v82call_18.2.sroa.0.1
  %.1383 = fmul contract double %.1378, %.1380
  %.1386 = fmul contract double %.841, %.1374
  %.1388 = fsub contract double %_transfer_v199__v34call_7.2.sroa.8.1, %_transfer_v199__v82call_18.2.sroa.8.1
  %.1389 = fmul contract double %.1386, %.1388
  %.1392 = fmul contract double %.841, %.1378
  %.1394 = fadd contract double %_transfer_v199__v34call_7.2.sroa.8.1, %_transfer_v199__v82call_18.2.sroa.8.1
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
  br i1 %.599, label %B380, label %B5388

B5388:                                            ; preds = %B5387, %entry
  store ptr null, ptr %retptr, align 8
  ret void

B1030.endif:                                      ; preds = %B380
  %.969 = fdiv contract double %.859, 6.000000e+00
  %.970 = fsub contract double 1.000000e+00, %.969
  %.975 = fdiv contract double %.859, 3.000000e+01
  %.978 = fadd contract double %.975, 0xBFD5555555555555
  %.980 = fmul contract double %.853, %.978
  br label %B5271

B5272.endif:                                      ; preds = %B5271
  %.1190 = fdiv contract double %.1080, 6.000000e+00
  %.1191 = fsub contract double 1.000000e+00, %.1190
  %.1196 = fdiv contract double %.1080, 3.000000e+01
  %.1199 = fadd contract double %.1196, 0xBFD5555555555555
  %.1201 = fmul contract double %.1074, %.1199
  br label %B5387
}

; Function Attrs: mustprogress nocallback nocreateundeforpoison nofree nosync nounwind speculatable willreturn memory(none)
declare double @llvm.floor.f64(double) #2

; Function Attrs: mustprogress nocallback nofree nosync nounwind willreturn memory(argmem: readwrite)
declare void @llvm.lifetime.start.p0(ptr captures(none)) #4

; Function Attrs: nofree norecurse nosync nounwind memory(argmem: readwrite)
define internal fastcc void @inner_1(ptr noalias nonnull writeonly captures(none) %retptr, i64 range(i64 -9223372036854775808, 129) %arg.count, ptr readonly captures(none) %arg.numbers.4, i64 range(i64 -9223372036854775808, 257) %arg.numbers.5.0, ptr writeonly captures(none) %arg.real.4, ptr writeonly captures(none) %arg.imaginary.4) unnamed_addr #3 {
entry:
  %.90 = and i64 %arg.count, -8
  %0 = tail call i64 @llvm.smax.i64(i64 %arg.count, i64 7)
  %storemerge = lshr i64 %0, 3
  %.176243.not = icmp eq i64 %storemerge, 0
  br i1 %.176243.not, label %B196, label %B84.if.preheader

B84.if.preheader:                                 ; preds = %entry
  %1 = add nuw nsw i64 %storemerge, 4
  br label %B84.if

B196:                                             ; preds = %B84.if, %entry
  %.264.not = icmp eq i64 %.90, %arg.count
  br i1 %.264.not, label %common.ret, label %B208

B208:                                             ; preds = %B196
  %.276 = getelementptr inbounds double, ptr %arg.real.4, i64 %.90
  store <8 x double> zeroinitializer, ptr %.276, align 8
  %.289 = getelementptr inbounds double, ptr %arg.imaginary.4, i64 %.90
  store <8 x double> zeroinitializer, ptr %.289, align 8
  %.334 = and i64 %arg.count, 7
  %.377249.not = icmp eq i64 %.334, 0
  br i1 %.377249.not, label %common.ret, label %B360.if

common.ret:                                       ; preds = %B360.if.6, %B360.if.5, %B360.if.4, %B360.if.3, %B360.if.2, %B360.if.1, %B360.if, %B208, %B196
  store ptr null, ptr %retptr, align 8
  ret void

B84.if:                                           ; preds = %B84.if, %B84.if.preheader
  %lsr.iv2 = phi i64 [ %lsr.iv.next3, %B84.if ], [ %1, %B84.if.preheader ]
  %lsr.iv1 = phi i64 [ %lsr.iv.next2, %B84.if ], [ 0, %B84.if.preheader ]
  %2 = shl nuw i64 %lsr.iv1, 1
  %scevgep = getelementptr i8, ptr %arg.numbers.4, i64 %2
  %.224 = load <16 x double>, ptr %scevgep, align 8
  %.225 = shufflevector <16 x double> %.224, <16 x double> poison, <8 x i32> <i32 0, i32 2, i32 4, i32 6, i32 8, i32 10, i32 12, i32 14>
  %.226 = shufflevector <16 x double> %.224, <16 x double> poison, <8 x i32> <i32 1, i32 3, i32 5, i32 7, i32 9, i32 11, i32 13, i32 15>
  %scevgep4 = getelementptr i8, ptr %arg.real.4, i64 %lsr.iv1
  store <8 x double> %.225, ptr %scevgep4, align 8
  %scevgep3 = getelementptr i8, ptr %arg.imaginary.4, i64 %lsr.iv1
  store <8 x double> %.226, ptr %scevgep3, align 8
  %lsr.iv.next2 = add nuw nsw i64 %lsr.iv1, 64
  %lsr.iv.next3 = add nsw i64 %lsr.iv2, -1
  %.176 = icmp sgt i64 %lsr.iv2, 5
  br i1 %.176, label %B84.if, label %B196

B360.if:                                          ; preds = %B208
  %.429 = icmp slt i64 %arg.count, 0
  %.430 = select i1 %.429, i64 %arg.numbers.5.0, i64 0
  %.idx = shl i64 %.90, 4
  %3 = getelementptr i8, ptr %arg.numbers.4, i64 %.idx
  %.444 = getelementptr double, ptr %3, i64 %.430
  %.445 = load double, ptr %.444, align 8
  %.460 = select i1 %.429, i64 128, i64 0
  %.474 = getelementptr double, ptr %.276, i64 %.460
  store double %.445, ptr %.474, align 8
  %4 = getelementptr i8, ptr %3, i64 8
  %.506 = getelementptr double, ptr %4, i64 %.430
  %.507 = load double, ptr %.506, align 8
  %.536 = getelementptr double, ptr %.289, i64 %.460
  store double %.507, ptr %.536, align 8
  %.377.not = icmp eq i64 %.334, 1
  br i1 %.377.not, label %common.ret, label %B360.if.1

B360.if.1:                                        ; preds = %B360.if
  %.390 = or disjoint i64 %.90, 1
  %.idx.1 = shl i64 %.390, 4
  %5 = getelementptr i8, ptr %arg.numbers.4, i64 %.idx.1
  %.444.1 = getelementptr double, ptr %5, i64 %.430
  %.445.1 = load double, ptr %.444.1, align 8
  %6 = getelementptr double, ptr %arg.real.4, i64 %.390
  %.474.1 = getelementptr double, ptr %6, i64 %.460
  store double %.445.1, ptr %.474.1, align 8
  %7 = getelementptr i8, ptr %5, i64 8
  %.506.1 = getelementptr double, ptr %7, i64 %.430
  %.507.1 = load double, ptr %.506.1, align 8
  %8 = getelementptr double, ptr %arg.imaginary.4, i64 %.390
  %.536.1 = getelementptr double, ptr %8, i64 %.460
  store double %.507.1, ptr %.536.1, align 8
  %.377.1 = icmp samesign ugt i64 %.334, 2
  br i1 %.377.1, label %B360.if.2, label %common.ret

B360.if.2:                                        ; preds = %B360.if.1
  %.390.1 = or disjoint i64 %.90, 2
  %.idx.2 = shl i64 %.390.1, 4
  %9 = getelementptr i8, ptr %arg.numbers.4, i64 %.idx.2
  %.444.2 = getelementptr double, ptr %9, i64 %.430
  %.445.2 = load double, ptr %.444.2, align 8
  %10 = getelementptr double, ptr %arg.real.4, i64 %.390.1
  %.474.2 = getelementptr double, ptr %10, i64 %.460
  store double %.445.2, ptr %.474.2, align 8
  %11 = getelementptr i8, ptr %9, i64 8
  %.506.2 = getelementptr double, ptr %11, i64 %.430
  %.507.2 = load double, ptr %.506.2, align 8
  %12 = getelementptr double, ptr %arg.imaginary.4, i64 %.390.1
  %.536.2 = getelementptr double, ptr %12, i64 %.460
  store double %.507.2, ptr %.536.2, align 8
  %.377.2.not = icmp eq i64 %.334, 3
  br i1 %.377.2.not, label %common.ret, label %B360.if.3

B360.if.3:                                        ; preds = %B360.if.2
  %.390.2 = or disjoint i64 %.90, 3
  %.idx.3 = shl i64 %.390.2, 4
  %13 = getelementptr i8, ptr %arg.numbers.4, i64 %.idx.3
  %.444.3 = getelementptr double, ptr %13, i64 %.430
  %.445.3 = load double, ptr %.444.3, align 8
  %14 = getelementptr double, ptr %arg.real.4, i64 %.390.2
  %.474.3 = getelementptr double, ptr %14, i64 %.460
  store double %.445.3, ptr %.474.3, align 8
  %15 = getelementptr i8, ptr %13, i64 8
  %.506.3 = getelementptr double, ptr %15, i64 %.430
  %.507.3 = load double, ptr %.506.3, align 8
  %16 = getelementptr double, ptr %arg.imaginary.4, i64 %.390.2
  %.536.3 = getelementptr double, ptr %16, i64 %.460
  store double %.507.3, ptr %.536.3, align 8
  %.377.3 = icmp samesign ugt i64 %.334, 4
  br i1 %.377.3, label %B360.if.4, label %common.ret

B360.if.4:                                        ; preds = %B360.if.3
  %.390.3 = or disjoint i64 %.90, 4
  %.idx.4 = shl i64 %.390.3, 4
  %17 = getelementptr i8, ptr %arg.numbers.4, i64 %.idx.4
  %.444.4 = getelementptr double, ptr %17, i64 %.430
  %.445.4 = load double, ptr %.444.4, align 8
  %18 = getelementptr double, ptr %arg.real.4, i64 %.390.3
  %.474.4 = getelementptr double, ptr %18, i64 %.460
  store double %.445.4, ptr %.474.4, align 8
  %19 = getelementptr i8, ptr %17, i64 8
  %.506.4 = getelementptr double, ptr %19, i64 %.430
  %.507.4 = load double, ptr %.506.4, align 8
  %20 = getelementptr double, ptr %arg.imaginary.4, i64 %.390.3
  %.536.4 = getelementptr double, ptr %20, i64 %.460
  store double %.507.4, ptr %.536.4, align 8
  %.377.4.not = icmp eq i64 %.334, 5
  br i1 %.377.4.not, label %common.ret, label %B360.if.5

B360.if.5:                                        ; preds = %B360.if.4
  %.390.4 = or disjoint i64 %.90, 5
  %.idx.5 = shl i64 %.390.4, 4
  %21 = getelementptr i8, ptr %arg.numbers.4, i64 %.idx.5
  %.444.5 = getelementptr double, ptr %21, i64 %.430
  %.445.5 = load double, ptr %.444.5, align 8
  %22 = getelementptr double, ptr %arg.real.4, i64 %.390.4
  %.474.5 = getelementptr double, ptr %22, i64 %.460
  store double %.445.5, ptr %.474.5, align 8
  %23 = getelementptr i8, ptr %21, i64 8
  %.506.5 = getelementptr double, ptr %23, i64 %.430
  %.507.5 = load double, ptr %.506.5, align 8
  %24 = getelementptr double, ptr %arg.imaginary.4, i64 %.390.4
  %.536.5 = getelementptr double, ptr %24, i64 %.460
  store double %.507.5, ptr %.536.5, align 8
  %.377.5 = icmp eq i64 %.334, 7
  br i1 %.377.5, label %B360.if.6, label %common.ret

B360.if.6:                                        ; preds = %B360.if.5
  %.390.5 = or disjoint i64 %.90, 6
  %.idx.6 = shl i64 %.390.5, 4
  %25 = getelementptr i8, ptr %arg.numbers.4, i64 %.idx.6
  %.444.6 = getelementptr double, ptr %25, i64 %.430
  %.445.6 = load double, ptr %.444.6, align 8
  %26 = getelementptr double, ptr %arg.real.4, i64 %.390.5
  %.474.6 = getelementptr double, ptr %26, i64 %.460
  store double %.445.6, ptr %.474.6, align 8
  %27 = getelementptr i8, ptr %25, i64 8
  %.506.6 = getelementptr double, ptr %27, i64 %.430
  %.507.6 = load double, ptr %.506.6, align 8
  %28 = getelementptr double, ptr %arg.imaginary.4, i64 %.390.5
  %.536.6 = getelementptr double, ptr %28, i64 %.460
  store double %.507.6, ptr %.536.6, align 8
  br label %common.ret
}

; Function Attrs: mustprogress nocallback nofree nosync nounwind willreturn memory(argmem: readwrite)
declare void @llvm.lifetime.end.p0(ptr captures(none)) #4

; Function Attrs: nofree norecurse nosync nounwind memory(argmem: readwrite)
define internal fastcc void @inner_3(ptr noalias nonnull writeonly captures(none) %retptr, ptr readonly captures(none) %arg.a.4, ptr readonly captures(none) %arg.b.4, i64 range(i64 -9223372036854775808, 129) %arg.b.5.0, i64 range(i64 -9223372036854775808, 129) %arg.size, ptr captures(none) %arg.lanes.4) unnamed_addr #3 {
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
  %lsr.iv.next2 = add nuw nsw i64 %lsr.iv1, 64
  %lsr.iv.next = add nsw i64 %lsr.iv, -1
  %.181 = icmp sgt i64 %lsr.iv, 6
  br i1 %.181, label %B114.if, label %B210

B246.if:                                          ; preds = %B210
  %.387 = icmp slt i64 %arg.size, 0
  %.388 = select i1 %.387, i64 128, i64 0
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
declare <8 x double> @llvm.sqrt.v8f64(<8 x double>) #2

; Function Attrs: mustprogress nocallback nofree nosync nounwind willreturn memory(none)
declare double @sqrt(double) local_unnamed_addr #5

; Function Attrs: mustprogress nocallback nocreateundeforpoison nofree nosync nounwind speculatable willreturn memory(none)
declare double @llvm.fabs.f64(double) #2

attributes #0 = { nofree norecurse nosync nounwind memory(readwrite, inaccessiblemem: none, target_mem0: none, target_mem1: none) }
attributes #1 = { mustprogress nocallback nofree nounwind willreturn memory(argmem: write) }
attributes #2 = { mustprogress nocallback nocreateundeforpoison nofree nosync nounwind speculatable willreturn memory(none) }
attributes #3 = { nofree norecurse nosync nounwind memory(argmem: readwrite) }
attributes #4 = { mustprogress nocallback nofree nosync nounwind willreturn memory(argmem: readwrite) }
attributes #5 = { mustprogress nocallback nofree nosync nounwind willreturn memory(none) }

!0 = !{!1}
!1 = distinct !{!1, !2, !"_ZN17bnserve_inference14adjoint_kernel7_source11_block_backB4v557B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!2 = distinct !{!2, !"_ZN17bnserve_inference14adjoint_kernel7_source11_block_backB4v557B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!3 = !{!4, !1}
!4 = distinct !{!4, !5, !"_ZN17bnserve_inference14adjoint_kernel5_back10waves_backB4v570B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!5 = distinct !{!5, !"_ZN17bnserve_inference14adjoint_kernel5_back10waves_backB4v570B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE"}
!6 = !{!7}
!7 = distinct !{!7, !8, !"_ZN17bnserve_inference14adjoint_kernel7_source9_sky_backB4v597B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!8 = distinct !{!8, !"_ZN17bnserve_inference14adjoint_kernel7_source9_sky_backB4v597B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!9 = !{!10}
!10 = distinct !{!10, !11, !"_ZN17bnserve_inference14adjoint_kernel8_passing12passing_backB4v602B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!11 = distinct !{!11, !"_ZN17bnserve_inference14adjoint_kernel8_passing12passing_backB4v602B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!12 = !{!13, !10}
!13 = distinct !{!13, !14, !"_ZN17bnserve_inference14adjoint_kernel8_passing10_turn_backB4v613B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedExx8UniTupleIdLi3EE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!14 = distinct !{!14, !"_ZN17bnserve_inference14adjoint_kernel8_passing10_turn_backB4v613B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedExx8UniTupleIdLi3EE5ArrayIdLi1E1C7mutable7alignedE"}
!15 = !{!16}
!16 = distinct !{!16, !17, !"_ZN17bnserve_inference14adjoint_kernel7_source6_placeB3v14B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!17 = distinct !{!17, !"_ZN17bnserve_inference14adjoint_kernel7_source6_placeB3v14B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!18 = !{!19, !16}
!19 = distinct !{!19, !20, !"_ZN17bnserve_inference13moving_kernel9_response12coefficientsB3v22B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!20 = distinct !{!20, !"_ZN17bnserve_inference13moving_kernel9_response12coefficientsB3v22B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!21 = !{!22, !16}
!22 = distinct !{!22, !23, !"_ZN17bnserve_inference14adjoint_kernel9_response13fill_geometryB3v41B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!23 = distinct !{!23, !"_ZN17bnserve_inference14adjoint_kernel9_response13fill_geometryB3v41B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!24 = !{!25}
!25 = distinct !{!25, !26, !"_ZN17bnserve_inference13moving_kernel8_passing12find_passingB3v57B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIxLi1E1C7mutable7alignedE: %retptr"}
!26 = distinct !{!26, !"_ZN17bnserve_inference13moving_kernel8_passing12find_passingB3v57B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIxLi1E1C7mutable7alignedE"}
!27 = !{!28, !25}
!28 = distinct !{!28, !29, !"_ZN17bnserve_inference13moving_kernel8_passing6_turnsB3v73B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedExx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!29 = distinct !{!29, !"_ZN17bnserve_inference13moving_kernel8_passing6_turnsB3v73B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedExx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!30 = distinct !{!30, !31}
!31 = !{!"llvm.loop.unroll.disable"}
!32 = distinct !{!32, !33}
!33 = !{!"llvm.loop.peeled.count", i32 1}
!34 = !{!35}
!35 = distinct !{!35, !36, !"_ZN17bnserve_inference14adjoint_kernel7_source9_polariseB3v94B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!36 = distinct !{!36, !"_ZN17bnserve_inference14adjoint_kernel7_source9_polariseB3v94B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!37 = distinct !{!37, !31}
!38 = distinct !{!38, !31}
!39 = !{!40, !35}
!40 = distinct !{!40, !41, !"_ZN17bnserve_inference14adjoint_kernel7_source6_beginB4v113B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEdxx: %retptr"}
!41 = distinct !{!41, !"_ZN17bnserve_inference14adjoint_kernel7_source6_beginB4v113B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEdxx"}
!42 = distinct !{!42, !31}
!43 = distinct !{!43, !31}
!44 = distinct !{!44, !31}
!45 = distinct !{!45, !31}
!46 = distinct !{!46, !31}
!47 = distinct !{!47, !31}
!48 = !{!49, !35}
!49 = distinct !{!49, !50, !"_ZN17bnserve_inference14adjoint_kernel5_sums8add_modeB4v133B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEdddx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!50 = distinct !{!50, !"_ZN17bnserve_inference14adjoint_kernel5_sums8add_modeB4v133B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEdddx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!51 = !{!52}
!52 = distinct !{!52, !53, !"_ZN17bnserve_inference14adjoint_kernel7_source12_in_detectorB4v146B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxx5ArrayIxLi1E1C7mutable7alignedEd5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!53 = distinct !{!53, !"_ZN17bnserve_inference14adjoint_kernel7_source12_in_detectorB4v146B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxx5ArrayIxLi1E1C7mutable7alignedEd5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!54 = !{!55, !52}
!55 = distinct !{!55, !56, !"_ZN17bnserve_inference14adjoint_kernel7_source10_calibrateB4v159B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!56 = distinct !{!56, !"_ZN17bnserve_inference14adjoint_kernel7_source10_calibrateB4v159B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!57 = distinct !{!57, !31}
!58 = !{!59, !55, !52}
!59 = distinct !{!59, !60, !"_ZN17bnserve_inference6kernel5_sums9errors_atB4v174B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedExx5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!60 = distinct !{!60, !"_ZN17bnserve_inference6kernel5_sums9errors_atB4v174B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedExx5ArrayIdLi1E1C7mutable7alignedE"}
!61 = !{!"branch_weights", i32 1, i32 99}
!62 = !{!"branch_weights", i32 99, i32 1}
!63 = !{!64, !55, !52}
!64 = distinct !{!64, !65, !"_ZN17bnserve_inference6kernel5_sums9errors_atB4v174B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedExx5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!65 = distinct !{!65, !"_ZN17bnserve_inference6kernel5_sums9errors_atB4v174B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedExx5ArrayIdLi1E1C7mutable7alignedE"}
!66 = !{!67, !52}
!67 = distinct !{!67, !68, !"_ZN17bnserve_inference14adjoint_kernel9_standing16respond_standingB4v175B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedEbx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!68 = distinct !{!68, !"_ZN17bnserve_inference14adjoint_kernel9_standing16respond_standingB4v175B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedEbx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!69 = !{!70, !52}
!70 = distinct !{!70, !71, !"_ZN17bnserve_inference14adjoint_kernel9_response14clear_patternsB4v195B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!71 = distinct !{!71, !"_ZN17bnserve_inference14adjoint_kernel9_response14clear_patternsB4v195B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE"}
!72 = !{!73, !52}
!73 = distinct !{!73, !74, !"_ZN17bnserve_inference14adjoint_kernel9_response14short_patternsB4v255B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!74 = distinct !{!74, !"_ZN17bnserve_inference14adjoint_kernel9_response14short_patternsB4v255B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE"}
!75 = !{!76, !52}
!76 = distinct !{!76, !77, !"_ZN17bnserve_inference14adjoint_kernel5_sums7respondB4v280B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedEddxx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!77 = distinct !{!77, !"_ZN17bnserve_inference14adjoint_kernel5_sums7respondB4v280B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedEddxx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!78 = !{!79, !52}
!79 = distinct !{!79, !80, !"_ZN17bnserve_inference14adjoint_kernel5_back11errors_backB4v401B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!80 = distinct !{!80, !"_ZN17bnserve_inference14adjoint_kernel5_back11errors_backB4v401B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!81 = !{!82, !52}
!82 = distinct !{!82, !83, !"_ZN17bnserve_inference14adjoint_kernel9_standing18pull_back_standingB4v419B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEbx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!83 = distinct !{!83, !"_ZN17bnserve_inference14adjoint_kernel9_standing18pull_back_standingB4v419B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEbx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!84 = !{!85, !52}
!85 = distinct !{!85, !86, !"_ZN17bnserve_inference14adjoint_kernel5_back9pull_backB4v464B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!86 = distinct !{!86, !"_ZN17bnserve_inference14adjoint_kernel5_back9pull_backB4v464B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!87 = !{!88, !52}
!88 = distinct !{!88, !89, !"_ZN17bnserve_inference14adjoint_kernel5_back15errors_to_nodesB4v546B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!89 = distinct !{!89, !"_ZN17bnserve_inference14adjoint_kernel5_back15errors_to_nodesB4v546B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!90 = !{!91, !52}
!91 = distinct !{!91, !92, !"_ZN17bnserve_inference14adjoint_kernel7_source16_through_weightsB4v318B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxxx5ArrayIxLi1E1C7mutable7alignedEd5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!92 = distinct !{!92, !"_ZN17bnserve_inference14adjoint_kernel7_source16_through_weightsB4v318B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxxx5ArrayIxLi1E1C7mutable7alignedEd5ArrayIdLi1E1C7mutable7alignedE"}
!93 = !{!94, !91, !52}
!94 = distinct !{!94, !95, !"_ZN17bnserve_inference6kernel5_sums9spline_atB4v352B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dEd5ArrayIdLi1E1C7mutable7alignedExxx: %retptr"}
!95 = distinct !{!95, !"_ZN17bnserve_inference6kernel5_sums9spline_atB4v352B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dEd5ArrayIdLi1E1C7mutable7alignedExxx"}
!96 = !{!97, !99, !91, !52}
!97 = distinct !{!97, !98, !"_ZN17bnserve_inference14adjoint_kernel7_source10_fill_barsB4v329B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!98 = distinct !{!98, !"_ZN17bnserve_inference14adjoint_kernel7_source10_fill_barsB4v329B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!99 = distinct !{!99, !98, !"_ZN17bnserve_inference14adjoint_kernel7_source10_fill_barsB4v329B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %excinfo"}
!100 = !{!101, !91, !52}
!101 = distinct !{!101, !102, !"_ZN17bnserve_inference14adjoint_kernel5_sums9add_fixedB4v336B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedEd5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!102 = distinct !{!102, !"_ZN17bnserve_inference14adjoint_kernel5_sums9add_fixedB4v336B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedEd5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE"}
!103 = !{!104, !91, !52}
!104 = distinct !{!104, !105, !"_ZN17bnserve_inference14adjoint_kernel5_sums11add_splinedB4v355B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedEd5ArrayIdLi1E1C7mutable7alignedE8UniTupleIxLi3EE8UniTupleIdLi6EE8UniTupleIdLi6EEx5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!105 = distinct !{!105, !"_ZN17bnserve_inference14adjoint_kernel5_sums11add_splinedB4v355B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedEd5ArrayIdLi1E1C7mutable7alignedE8UniTupleIxLi3EE8UniTupleIdLi6EE8UniTupleIdLi6EEx5ArrayIdLi1E1C7mutable7alignedE"}
!106 = !{!107, !52}
!107 = distinct !{!107, !108, !"_ZN17bnserve_inference14adjoint_kernel7_source14_through_pairsB4v376B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!108 = distinct !{!108, !"_ZN17bnserve_inference14adjoint_kernel7_source14_through_pairsB4v376B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!109 = !{!110, !107, !52}
!110 = distinct !{!110, !111, !"_ZN17bnserve_inference14adjoint_kernel5_sums8add_pairB4v396B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEbddEdx5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!111 = distinct !{!111, !"_ZN17bnserve_inference14adjoint_kernel5_sums8add_pairB4v396B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEbddEdx5ArrayIdLi1E1C7mutable7alignedE"}
!112 = !{!113, !107, !52}
!113 = distinct !{!113, !114, !"_ZN17bnserve_inference14adjoint_kernel5_sums8add_pairB4v396B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEbddEdx5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!114 = distinct !{!114, !"_ZN17bnserve_inference14adjoint_kernel5_sums8add_pairB4v396B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEbddEdx5ArrayIdLi1E1C7mutable7alignedE"}
