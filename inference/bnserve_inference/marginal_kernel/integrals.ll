; sources: aec4a35c936ab9c1cbefc2fdfe4fcdf3162c62b2d87953a62e0b1f8770aaf62a
; built by: numba 0.68.1, llvmlite 0.50.0, Python 3.11, x86_64
; ModuleID = '<string>'
source_filename = "<string>"


; Function Attrs: nofree norecurse nosync nounwind memory(readwrite, inaccessiblemem: none, target_mem0: none, target_mem1: none)
define noundef i32 @bnserve_integrate(ptr noalias writeonly captures(none) %retptr, ptr noalias readnone captures(none) %excinfo, ptr readonly captures(none) %arg.arguments) local_unnamed_addr #0 {
entry:
  %.603.i.i = alloca [4 x double], align 8
  %.854.i15.i.i.i = alloca ptr, align 8
  %.854.i.i.i.i = alloca ptr, align 8
  %.2851.i.i.i = alloca [4 x double], align 8
  %.3119.i.i.i = alloca ptr, align 8
  %.3347.i.i.i = alloca ptr, align 8
  %.218.i = getelementptr i8, ptr %arg.arguments, i64 152
  %.219.i = load i64, ptr %.218.i, align 8, !noalias !0
  %.299200.not.i = icmp slt i64 %.219.i, 1
  br i1 %.299200.not.i, label %_ZN17bnserve_inference15marginal_kernel7_source9integrateB2v3B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIxLi1E1C7mutable7alignedE.exit, label %B214.if.preheader.i

B214.if.preheader.i:                              ; preds = %entry
  %.134.i = getelementptr i8, ptr %arg.arguments, i64 200
  %.135.i = load i64, ptr %.134.i, align 8, !noalias !0
  %.47.i = getelementptr i8, ptr %arg.arguments, i64 56
  %.48.i = load i64, ptr %.47.i, align 8, !noalias !0
  %0 = inttoptr i64 %.48.i to ptr
  %1 = inttoptr i64 %.135.i to ptr
  %.145.i.i = getelementptr i8, ptr %arg.arguments, i64 160
  %.235.i.i = getelementptr i8, ptr %arg.arguments, i64 168
  %sunkaddr63.i.i = getelementptr inbounds nuw i8, ptr %.603.i.i, i64 24
  %sunkaddr64.i.i = getelementptr inbounds nuw i8, ptr %.603.i.i, i64 16
  %sunkaddr65.i.i = getelementptr inbounds nuw i8, ptr %.603.i.i, i64 8
  %.814.i.i = getelementptr i8, ptr %0, i64 32
  %.851.i.i = getelementptr i8, ptr %arg.arguments, i64 176
  %.963.i.i = getelementptr i8, ptr %arg.arguments, i64 184
  %.1347.i.i = getelementptr i8, ptr %arg.arguments, i64 192
  %.107.i.i = getelementptr i8, ptr %arg.arguments, i64 8
  %.137.i.i = getelementptr i8, ptr %arg.arguments, i64 24
  %.357.i.i = getelementptr i8, ptr %arg.arguments, i64 16
  %.437.i.i = getelementptr i8, ptr %arg.arguments, i64 32
  %.532.i.i.i = getelementptr i8, ptr %0, i64 8
  %.562.i.i.i = getelementptr i8, ptr %0, i64 16
  %.592.i.i.i = getelementptr i8, ptr %0, i64 24
  %.631.i.i.i = getelementptr i8, ptr %arg.arguments, i64 48
  %.666.i.i.i = getelementptr i8, ptr %arg.arguments, i64 40
  %sunkaddr171.i.i.i = getelementptr i8, ptr %0, i64 40
  %sunkaddr211.i.i.i = getelementptr inbounds nuw i8, ptr %.2851.i.i.i, i64 24
  %sunkaddr212.i.i.i = getelementptr inbounds nuw i8, ptr %.2851.i.i.i, i64 16
  %sunkaddr213.i.i.i = getelementptr inbounds nuw i8, ptr %.2851.i.i.i, i64 8
  br label %B214.if.i

B282.i:                                           ; preds = %B214.if.i
  %.78.i.i = load i64, ptr %.218.i, align 8, !noalias !3
  %.108.i.i = load i64, ptr %.107.i.i, align 8, !noalias !3
  %.138.i.i = load i64, ptr %.137.i.i, align 8, !noalias !3
  %.178.i.i = load i64, ptr %.145.i.i, align 8, !noalias !3
  %.180.i.i = shl nsw i64 %.108.i.i, 1
  %.182.i.i = mul nsw i64 %.180.i.i, %.78.i.i
  %.269.i.i = load i64, ptr %.235.i.i, align 8, !noalias !3
  %.271.i.i = shl nsw i64 %.138.i.i, 1
  %.273.i.i = mul nsw i64 %.271.i.i, %.78.i.i
  %.358.i.i = load i64, ptr %.357.i.i, align 8, !noalias !3
  %.360.i.i = inttoptr i64 %.358.i.i to ptr
  %.438.i.i = load i64, ptr %.437.i.i, align 8, !noalias !3
  %.440.i.i = inttoptr i64 %.438.i.i to ptr
  %.522.i.i = tail call i64 @llvm.smin.i64(i64 %.108.i.i, i64 0)
  %2 = getelementptr i64, ptr %.360.i.i, i64 %.108.i.i
  %3 = getelementptr i8, ptr %2, i64 -8
  %.536.i.i = getelementptr i64, ptr %3, i64 %.522.i.i
  %.537.i.i = load i64, ptr %.536.i.i, align 8, !noalias !3
  %.554.i.i = tail call i64 @llvm.smin.i64(i64 %.138.i.i, i64 0)
  %4 = getelementptr i64, ptr %.440.i.i, i64 %.138.i.i
  %5 = getelementptr i8, ptr %4, i64 -8
  %.568.i.i = getelementptr i64, ptr %5, i64 %.554.i.i
  %.569.i.i = load i64, ptr %.568.i.i, align 8, !noalias !3
  %.13.i.i.i = tail call i64 @llvm.smax.i64(i64 %.569.i.i, i64 %.537.i.i)
  %.598.i.i = add nsw i64 %.13.i.i.i, 1
  %.604.i.i = shl nsw i64 %.598.i.i, 3
  %.711.i.i = icmp slt i64 %.13.i.i.i, 0
  %..604.i.i = select i1 %.711.i.i, i64 0, i64 %.604.i.i
  %.7531395.i.i = icmp sgt i64 %..604.i.i, 0
  br i1 %.7531395.i.i, label %B542.if.preheader.i.i, label %B558.i.i

B542.if.preheader.i.i:                            ; preds = %B282.i
  %6 = shl nuw i64 %..604.i.i, 3
  tail call void @llvm.memset.p0.i64(ptr align 8 %1, i8 0, i64 %6, i1 false), !noalias !3
  br label %B558.i.i

B558.i.i:                                         ; preds = %B542.if.preheader.i.i, %B282.i
  %7 = icmp sgt i64 %.108.i.i, 0
  br i1 %7, label %B602.if.preheader.i.i, label %B806.i.i

B602.if.preheader.i.i:                            ; preds = %B558.i.i
  %8 = inttoptr i64 %.178.i.i to ptr
  %9 = shl i64 %.305198201.i, 4
  %10 = getelementptr i8, ptr %8, i64 %9
  %scevgep142.i.i = getelementptr i8, ptr %10, i64 8
  %11 = shl i64 %.78.i.i, 4
  %12 = shl i64 %.182.i.i, 3
  br label %B602.if.i.i

B806.i.i:                                         ; preds = %B602.if.i.i, %B558.i.i
  %bend_x.2.0.lcssa.i.i = phi double [ 0.000000e+00, %B558.i.i ], [ %.1151.i.i, %B602.if.i.i ]
  %size_x.2.0.lcssa.i.i = phi double [ 0.000000e+00, %B558.i.i ], [ %.1155.i.i, %B602.if.i.i ]
  %13 = icmp sgt i64 %.138.i.i, 0
  br i1 %13, label %B836.if.lr.ph.i.i, label %B1058.i.i

B836.if.lr.ph.i.i:                                ; preds = %B806.i.i
  %14 = inttoptr i64 %.269.i.i to ptr
  %.1404.i.i = shl nsw i64 %.598.i.i, 1
  %.1437.i.i = mul nsw i64 %.598.i.i, 3
  %15 = shl i64 %.305198201.i, 4
  %16 = getelementptr i8, ptr %14, i64 %15
  %scevgep134.i.i = getelementptr i8, ptr %16, i64 8
  %17 = shl i64 %.78.i.i, 4
  %18 = shl i64 %.273.i.i, 3
  br label %B836.if.i.i

B1058.i.i:                                        ; preds = %B836.if.i.i, %B806.i.i
  %bend_n.2.0.lcssa.i.i = phi double [ 0.000000e+00, %B806.i.i ], [ %.1473.i.i, %B836.if.i.i ]
  %size_n.2.0.lcssa.i.i = phi double [ 0.000000e+00, %B806.i.i ], [ %.1477.i.i, %B836.if.i.i ]
  %.1520.i.i = load i64, ptr %.851.i.i, align 8, !noalias !3
  %.1584.i.i = fadd contract double %size_x.2.0.lcssa.i.i, %size_n.2.0.lcssa.i.i
  %.1585.i.i = fcmp contract ueq double %.1584.i.i, 0x7FF0000000000000
  br i1 %.1585.i.i, label %B1286.i.i, label %B1188.i.i

B1188.i.i:                                        ; preds = %B1058.i.i
  %.1620.i.i = getelementptr inbounds double, ptr %1, i64 %.604.i.i
  call void @llvm.lifetime.start.p0(ptr nonnull %.2851.i.i.i), !noalias !3
  call void @llvm.lifetime.start.p0(ptr nonnull %.3119.i.i.i), !noalias !3
  call void @llvm.lifetime.start.p0(ptr nonnull %.3347.i.i.i), !noalias !3
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(32) %.2851.i.i.i, i8 0, i64 32, i1 false), !noalias !6
  store ptr null, ptr %.3119.i.i.i, align 8, !noalias !6
  store ptr null, ptr %.3347.i.i.i, align 8, !noalias !6
  %.148.i.i.i = getelementptr inbounds nuw i8, ptr %.1620.i.i, i64 576
  %.232.i.i.i = getelementptr inbounds nuw i8, ptr %.1620.i.i, i64 640
  %.299.i.i.i = getelementptr inbounds nuw i8, ptr %.1620.i.i, i64 3200
  %.361.i.i.i = getelementptr inbounds nuw i8, ptr %.1620.i.i, i64 7552
  %.447.i.i.i = getelementptr inbounds nuw i8, ptr %.1620.i.i, i64 11904
  %.533.i.i.i = load double, ptr %.532.i.i.i, align 8, !noalias !6
  %.563.i.i.i = load double, ptr %.562.i.i.i, align 8, !noalias !6
  %.593.i.i.i = load double, ptr %.592.i.i.i, align 8, !noalias !6
  %.632.i.i.i = load i64, ptr %.631.i.i.i, align 8, !noalias !6
  %.667.i.i.i = load i64, ptr %.666.i.i.i, align 8, !noalias !6
  %.165.i.i.i.i = sitofp i64 %.667.i.i.i to double
  %.169.i1.i.i.i = fdiv contract double 0x400921FB54442D18, %.165.i.i.i.i
  %19 = add nuw i64 %.667.i.i.i, 7
  %.276.i.i.i.i = lshr i64 %19, 3
  %.253.inv.i.i.i.i = icmp slt i64 %.667.i.i.i, 1
  %.297513.not568.i.i.i.i = icmp eq i64 %.276.i.i.i.i, 0
  %.297513.not.i.i.i.i = select i1 %.253.inv.i.i.i.i, i1 true, i1 %.297513.not568.i.i.i.i
  br i1 %.297513.not.i.i.i.i, label %B620.i.i.i.i, label %B230.if.preheader.i.i.i.i

B230.if.preheader.i.i.i.i:                        ; preds = %B1188.i.i
  %.990.i101.i.i.i.i = fmul contract double %size_n.2.0.lcssa.i.i, 1.000000e-09
  %.991.i102.i.i.i.i = fadd contract double %.990.i101.i.i.i.i, 0x10000000000000
  %.1020.i103.i.i.i.i = fneg contract double %.991.i102.i.i.i.i
  %.1021.i104.i.i.i.i = insertelement <8 x double> poison, double %.1020.i103.i.i.i.i, i64 0
  %.1022.i105.i.i.i.i = shufflevector <8 x double> %.1021.i104.i.i.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1197.i116.i.i.i.i = fneg contract double %.533.i.i.i
  %.1198.i117.i.i.i.i = insertelement <8 x double> poison, double %.1197.i116.i.i.i.i, i64 0
  %.1199.i118.i.i.i.i = shufflevector <8 x double> %.1198.i117.i.i.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1225.i121.i.i.i.i = insertelement <8 x double> poison, double %.563.i.i.i, i64 0
  %.1226.i122.i.i.i.i = shufflevector <8 x double> %.1225.i121.i.i.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1366.i.i.i.i.i = insertelement <8 x double> poison, double %.169.i1.i.i.i, i64 0
  %.1367.i.i.i.i.i = shufflevector <8 x double> %.1366.i.i.i.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1372.i.i.i.i.i = fmul contract double %.169.i1.i.i.i, 5.000000e-01
  %.1374.i.i.i.i.i = fmul contract double %.169.i1.i.i.i, %.1372.i.i.i.i.i
  %.1377.i130.i.i.i.i = fmul contract double %bend_x.2.0.lcssa.i.i, %.1374.i.i.i.i.i
  %.6.i48.i131.i.i.i.i = insertelement <8 x double> poison, double %.1377.i130.i.i.i.i, i64 0
  %.7.i.i132.i.i.i.i = shufflevector <8 x double> %.6.i48.i131.i.i.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1434.i.i.i.i.i = fneg contract double %.169.i1.i.i.i
  %.1435.i.i.i.i.i = insertelement <8 x double> poison, double %.1434.i.i.i.i.i, i64 0
  %.1436.i.i.i.i.i = shufflevector <8 x double> %.1435.i.i.i.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1451.i135.i.i.i.i = fmul contract double %bend_n.2.0.lcssa.i.i, %.1374.i.i.i.i.i
  %.6.i51.i136.i.i.i.i = insertelement <8 x double> poison, double %.1451.i135.i.i.i.i, i64 0
  %.7.i52.i137.i.i.i.i = shufflevector <8 x double> %.6.i51.i136.i.i.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %20 = getelementptr double, ptr %1, i64 %.598.i.i
  %.idx.i41.i.i.i.i = shl i64 %.598.i.i, 4
  %21 = getelementptr i8, ptr %1, i64 %.idx.i41.i.i.i.i
  %.idx288.i42.i.i.i.i = mul i64 %.598.i.i, 24
  %22 = getelementptr i8, ptr %1, i64 %.idx288.i42.i.i.i.i
  %sunkaddr105.i.i.i.i = getelementptr i8, ptr %.1620.i.i, i64 8
  %sunkaddr106.i.i.i.i = getelementptr i8, ptr %.1620.i.i, i64 16
  %sunkaddr107.i.i.i.i = getelementptr i8, ptr %.1620.i.i, i64 24
  %sunkaddr108.i.i.i.i = getelementptr i8, ptr %.1620.i.i, i64 32
  %sunkaddr109.i.i.i.i = getelementptr i8, ptr %.1620.i.i, i64 40
  %sunkaddr110.i.i.i.i = getelementptr i8, ptr %.1620.i.i, i64 48
  %sunkaddr111.i.i.i.i = getelementptr i8, ptr %.1620.i.i, i64 56
  %sunkaddr112.i.i.i.i = getelementptr inbounds nuw i8, ptr %.1620.i.i, i64 64
  %sunkaddr113.i.i.i.i = getelementptr inbounds nuw i8, ptr %.1620.i.i, i64 128
  %sunkaddr114.i.i.i.i = getelementptr inbounds nuw i8, ptr %.1620.i.i, i64 192
  %sunkaddr115.i.i.i.i = getelementptr inbounds nuw i8, ptr %.1620.i.i, i64 256
  %sunkaddr116.i.i.i.i = getelementptr inbounds nuw i8, ptr %.1620.i.i, i64 320
  %sunkaddr117.i.i.i.i = getelementptr inbounds nuw i8, ptr %.1620.i.i, i64 384
  %sunkaddr118.i.i.i.i = getelementptr inbounds nuw i8, ptr %.1620.i.i, i64 448
  %sunkaddr119.i.i.i.i = getelementptr inbounds nuw i8, ptr %.1620.i.i, i64 512
  %sunkaddr62.i.i.i.i = getelementptr i8, ptr %.1620.i.i, i64 456
  %sunkaddr65.i.i.i.i = getelementptr i8, ptr %.1620.i.i, i64 464
  %sunkaddr68.i.i.i.i = getelementptr i8, ptr %.1620.i.i, i64 472
  %sunkaddr71.i.i.i.i = getelementptr i8, ptr %.1620.i.i, i64 480
  %sunkaddr74.i.i.i.i = getelementptr i8, ptr %.1620.i.i, i64 488
  %sunkaddr77.i.i.i.i = getelementptr i8, ptr %.1620.i.i, i64 496
  %sunkaddr80.i.i.i.i = getelementptr i8, ptr %.1620.i.i, i64 504
  %sunkaddr63.i.i.i.i = getelementptr i8, ptr %.1620.i.i, i64 200
  %sunkaddr64.i.i.i.i = getelementptr i8, ptr %.1620.i.i, i64 264
  %sunkaddr66.i.i.i.i = getelementptr i8, ptr %.1620.i.i, i64 208
  %sunkaddr67.i.i.i.i = getelementptr i8, ptr %.1620.i.i, i64 272
  %sunkaddr69.i.i.i.i = getelementptr i8, ptr %.1620.i.i, i64 216
  %sunkaddr70.i.i.i.i = getelementptr i8, ptr %.1620.i.i, i64 280
  %sunkaddr72.i.i.i.i = getelementptr i8, ptr %.1620.i.i, i64 224
  %sunkaddr73.i.i.i.i = getelementptr i8, ptr %.1620.i.i, i64 288
  %sunkaddr75.i.i.i.i = getelementptr i8, ptr %.1620.i.i, i64 232
  %sunkaddr76.i.i.i.i = getelementptr i8, ptr %.1620.i.i, i64 296
  %sunkaddr78.i.i.i.i = getelementptr i8, ptr %.1620.i.i, i64 240
  %sunkaddr79.i.i.i.i = getelementptr i8, ptr %.1620.i.i, i64 304
  %sunkaddr81.i.i.i.i = getelementptr i8, ptr %.1620.i.i, i64 248
  %sunkaddr82.i.i.i.i = getelementptr i8, ptr %.1620.i.i, i64 312
  br label %B230.if.i.i.i.i

B456.i.i.i.i:                                     ; preds = %_ZN17bnserve_inference15marginal_kernel7_circle10_at_phasesB3v30B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedExd8UniTupleIdLi3EEdd.exit151.i.i.i.i
  %.805.i.i.i.i = load double, ptr %.1620.i.i, align 8, !noalias !9
  %.842.i.i.i.i = load double, ptr %sunkaddr114.i.i.i.i, align 8, !noalias !9
  %.877.i4.i.i.i = load double, ptr %sunkaddr115.i.i.i.i, align 8, !noalias !9
  br label %B616.i.i.i.i

B616.i.i.i.i:                                     ; preds = %_ZN17bnserve_inference15marginal_kernel7_circle10_at_phasesB3v30B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedExd8UniTupleIdLi3EEdd.exit151.i.i.i.i, %B456.i.i.i.i
  %best.4.2.i.i.i.i = phi double [ %.736.i.i.i.i, %B456.i.i.i.i ], [ %best.5.0518.i.i.i.i, %_ZN17bnserve_inference15marginal_kernel7_circle10_at_phasesB3v30B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedExd8UniTupleIdLi3EEdd.exit151.i.i.i.i ]
  %where.6.2.i.i.i.i = phi double [ %.805.i.i.i.i, %B456.i.i.i.i ], [ %where.4.0519.i.i.i.i, %_ZN17bnserve_inference15marginal_kernel7_circle10_at_phasesB3v30B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedExd8UniTupleIdLi3EEdd.exit151.i.i.i.i ]
  %x.4.2.i.i.i.i = phi double [ %.842.i.i.i.i, %B456.i.i.i.i ], [ %x.2.0520.i.i.i.i, %_ZN17bnserve_inference15marginal_kernel7_circle10_at_phasesB3v30B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedExd8UniTupleIdLi3EEdd.exit151.i.i.i.i ]
  %n.4.2.i.i.i.i = phi double [ %.877.i4.i.i.i, %B456.i.i.i.i ], [ %n.2.0521.i.i.i.i, %_ZN17bnserve_inference15marginal_kernel7_circle10_at_phasesB3v30B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedExd8UniTupleIdLi3EEdd.exit151.i.i.i.i ]
  %.736.1.i.i.i.i = load double, ptr %sunkaddr62.i.i.i.i, align 8, !noalias !9
  %.738.1.i.i.i.i = fcmp contract ogt double %.736.1.i.i.i.i, %best.4.2.i.i.i.i
  br i1 %.738.1.i.i.i.i, label %B456.1.i.i.i.i, label %B616.1.i.i.i.i

B456.1.i.i.i.i:                                   ; preds = %B616.i.i.i.i
  %.842.1.i.i.i.i = load double, ptr %sunkaddr63.i.i.i.i, align 8, !noalias !9
  %.877.1.i.i.i.i = load double, ptr %sunkaddr64.i.i.i.i, align 8, !noalias !9
  br label %B616.1.i.i.i.i

B616.1.i.i.i.i:                                   ; preds = %B456.1.i.i.i.i, %B616.i.i.i.i
  %best.4.2.1.i.i.i.i = phi double [ %.736.1.i.i.i.i, %B456.1.i.i.i.i ], [ %best.4.2.i.i.i.i, %B616.i.i.i.i ]
  %where.6.2.1.i.i.i.i = phi double [ %.461.1.i.i.i.i, %B456.1.i.i.i.i ], [ %where.6.2.i.i.i.i, %B616.i.i.i.i ]
  %x.4.2.1.i.i.i.i = phi double [ %.842.1.i.i.i.i, %B456.1.i.i.i.i ], [ %x.4.2.i.i.i.i, %B616.i.i.i.i ]
  %n.4.2.1.i.i.i.i = phi double [ %.877.1.i.i.i.i, %B456.1.i.i.i.i ], [ %n.4.2.i.i.i.i, %B616.i.i.i.i ]
  %.736.2.i.i.i.i = load double, ptr %sunkaddr65.i.i.i.i, align 8, !noalias !9
  %.738.2.i.i.i.i = fcmp contract ogt double %.736.2.i.i.i.i, %best.4.2.1.i.i.i.i
  br i1 %.738.2.i.i.i.i, label %B456.2.i.i.i.i, label %B616.2.i.i.i.i

B456.2.i.i.i.i:                                   ; preds = %B616.1.i.i.i.i
  %.842.2.i.i.i.i = load double, ptr %sunkaddr66.i.i.i.i, align 8, !noalias !9
  %.877.2.i.i.i.i = load double, ptr %sunkaddr67.i.i.i.i, align 8, !noalias !9
  br label %B616.2.i.i.i.i

B616.2.i.i.i.i:                                   ; preds = %B456.2.i.i.i.i, %B616.1.i.i.i.i
  %best.4.2.2.i.i.i.i = phi double [ %.736.2.i.i.i.i, %B456.2.i.i.i.i ], [ %best.4.2.1.i.i.i.i, %B616.1.i.i.i.i ]
  %where.6.2.2.i.i.i.i = phi double [ %.461.2.i.i.i.i, %B456.2.i.i.i.i ], [ %where.6.2.1.i.i.i.i, %B616.1.i.i.i.i ]
  %x.4.2.2.i.i.i.i = phi double [ %.842.2.i.i.i.i, %B456.2.i.i.i.i ], [ %x.4.2.1.i.i.i.i, %B616.1.i.i.i.i ]
  %n.4.2.2.i.i.i.i = phi double [ %.877.2.i.i.i.i, %B456.2.i.i.i.i ], [ %n.4.2.1.i.i.i.i, %B616.1.i.i.i.i ]
  %.736.3.i.i.i.i = load double, ptr %sunkaddr68.i.i.i.i, align 8, !noalias !9
  %.738.3.i.i.i.i = fcmp contract ogt double %.736.3.i.i.i.i, %best.4.2.2.i.i.i.i
  br i1 %.738.3.i.i.i.i, label %B456.3.i.i.i.i, label %B616.3.i.i.i.i

B456.3.i.i.i.i:                                   ; preds = %B616.2.i.i.i.i
  %.842.3.i.i.i.i = load double, ptr %sunkaddr69.i.i.i.i, align 8, !noalias !9
  %.877.3.i.i.i.i = load double, ptr %sunkaddr70.i.i.i.i, align 8, !noalias !9
  br label %B616.3.i.i.i.i

B616.3.i.i.i.i:                                   ; preds = %B456.3.i.i.i.i, %B616.2.i.i.i.i
  %best.4.2.3.i.i.i.i = phi double [ %.736.3.i.i.i.i, %B456.3.i.i.i.i ], [ %best.4.2.2.i.i.i.i, %B616.2.i.i.i.i ]
  %where.6.2.3.i.i.i.i = phi double [ %.461.3.i.i.i.i, %B456.3.i.i.i.i ], [ %where.6.2.2.i.i.i.i, %B616.2.i.i.i.i ]
  %x.4.2.3.i.i.i.i = phi double [ %.842.3.i.i.i.i, %B456.3.i.i.i.i ], [ %x.4.2.2.i.i.i.i, %B616.2.i.i.i.i ]
  %n.4.2.3.i.i.i.i = phi double [ %.877.3.i.i.i.i, %B456.3.i.i.i.i ], [ %n.4.2.2.i.i.i.i, %B616.2.i.i.i.i ]
  %.736.4.i.i.i.i = load double, ptr %sunkaddr71.i.i.i.i, align 8, !noalias !9
  %.738.4.i.i.i.i = fcmp contract ogt double %.736.4.i.i.i.i, %best.4.2.3.i.i.i.i
  br i1 %.738.4.i.i.i.i, label %B456.4.i.i.i.i, label %B616.4.i.i.i.i

B456.4.i.i.i.i:                                   ; preds = %B616.3.i.i.i.i
  %.842.4.i.i.i.i = load double, ptr %sunkaddr72.i.i.i.i, align 8, !noalias !9
  %.877.4.i.i.i.i = load double, ptr %sunkaddr73.i.i.i.i, align 8, !noalias !9
  br label %B616.4.i.i.i.i

B616.4.i.i.i.i:                                   ; preds = %B456.4.i.i.i.i, %B616.3.i.i.i.i
  %best.4.2.4.i.i.i.i = phi double [ %.736.4.i.i.i.i, %B456.4.i.i.i.i ], [ %best.4.2.3.i.i.i.i, %B616.3.i.i.i.i ]
  %where.6.2.4.i.i.i.i = phi double [ %.461.4.i.i.i.i, %B456.4.i.i.i.i ], [ %where.6.2.3.i.i.i.i, %B616.3.i.i.i.i ]
  %x.4.2.4.i.i.i.i = phi double [ %.842.4.i.i.i.i, %B456.4.i.i.i.i ], [ %x.4.2.3.i.i.i.i, %B616.3.i.i.i.i ]
  %n.4.2.4.i.i.i.i = phi double [ %.877.4.i.i.i.i, %B456.4.i.i.i.i ], [ %n.4.2.3.i.i.i.i, %B616.3.i.i.i.i ]
  %.736.5.i.i.i.i = load double, ptr %sunkaddr74.i.i.i.i, align 8, !noalias !9
  %.738.5.i.i.i.i = fcmp contract ogt double %.736.5.i.i.i.i, %best.4.2.4.i.i.i.i
  br i1 %.738.5.i.i.i.i, label %B456.5.i.i.i.i, label %B616.5.i.i.i.i

B456.5.i.i.i.i:                                   ; preds = %B616.4.i.i.i.i
  %.842.5.i.i.i.i = load double, ptr %sunkaddr75.i.i.i.i, align 8, !noalias !9
  %.877.5.i.i.i.i = load double, ptr %sunkaddr76.i.i.i.i, align 8, !noalias !9
  br label %B616.5.i.i.i.i

B616.5.i.i.i.i:                                   ; preds = %B456.5.i.i.i.i, %B616.4.i.i.i.i
  %best.4.2.5.i.i.i.i = phi double [ %.736.5.i.i.i.i, %B456.5.i.i.i.i ], [ %best.4.2.4.i.i.i.i, %B616.4.i.i.i.i ]
  %where.6.2.5.i.i.i.i = phi double [ %.461.5.i.i.i.i, %B456.5.i.i.i.i ], [ %where.6.2.4.i.i.i.i, %B616.4.i.i.i.i ]
  %x.4.2.5.i.i.i.i = phi double [ %.842.5.i.i.i.i, %B456.5.i.i.i.i ], [ %x.4.2.4.i.i.i.i, %B616.4.i.i.i.i ]
  %n.4.2.5.i.i.i.i = phi double [ %.877.5.i.i.i.i, %B456.5.i.i.i.i ], [ %n.4.2.4.i.i.i.i, %B616.4.i.i.i.i ]
  %.736.6.i.i.i.i = load double, ptr %sunkaddr77.i.i.i.i, align 8, !noalias !9
  %.738.6.i.i.i.i = fcmp contract ogt double %.736.6.i.i.i.i, %best.4.2.5.i.i.i.i
  br i1 %.738.6.i.i.i.i, label %B456.6.i.i.i.i, label %B616.6.i.i.i.i

B456.6.i.i.i.i:                                   ; preds = %B616.5.i.i.i.i
  %.842.6.i.i.i.i = load double, ptr %sunkaddr78.i.i.i.i, align 8, !noalias !9
  %.877.6.i.i.i.i = load double, ptr %sunkaddr79.i.i.i.i, align 8, !noalias !9
  br label %B616.6.i.i.i.i

B616.6.i.i.i.i:                                   ; preds = %B456.6.i.i.i.i, %B616.5.i.i.i.i
  %best.4.2.6.i.i.i.i = phi double [ %.736.6.i.i.i.i, %B456.6.i.i.i.i ], [ %best.4.2.5.i.i.i.i, %B616.5.i.i.i.i ]
  %where.6.2.6.i.i.i.i = phi double [ %.461.6.i.i.i.i, %B456.6.i.i.i.i ], [ %where.6.2.5.i.i.i.i, %B616.5.i.i.i.i ]
  %x.4.2.6.i.i.i.i = phi double [ %.842.6.i.i.i.i, %B456.6.i.i.i.i ], [ %x.4.2.5.i.i.i.i, %B616.5.i.i.i.i ]
  %n.4.2.6.i.i.i.i = phi double [ %.877.6.i.i.i.i, %B456.6.i.i.i.i ], [ %n.4.2.5.i.i.i.i, %B616.5.i.i.i.i ]
  %.736.7.i.i.i.i = load double, ptr %sunkaddr80.i.i.i.i, align 8, !noalias !9
  %.738.7.i.i.i.i = fcmp contract ogt double %.736.7.i.i.i.i, %best.4.2.6.i.i.i.i
  br i1 %.738.7.i.i.i.i, label %B456.7.i.i.i.i, label %B616.7.i.i.i.i

B456.7.i.i.i.i:                                   ; preds = %B616.6.i.i.i.i
  %.842.7.i.i.i.i = load double, ptr %sunkaddr81.i.i.i.i, align 8, !noalias !9
  %.877.7.i.i.i.i = load double, ptr %sunkaddr82.i.i.i.i, align 8, !noalias !9
  br label %B616.7.i.i.i.i

B616.7.i.i.i.i:                                   ; preds = %B456.7.i.i.i.i, %B616.6.i.i.i.i
  %best.4.2.7.i.i.i.i = phi double [ %.736.7.i.i.i.i, %B456.7.i.i.i.i ], [ %best.4.2.6.i.i.i.i, %B616.6.i.i.i.i ]
  %where.6.2.7.i.i.i.i = phi double [ %.461.7.i.i.i.i, %B456.7.i.i.i.i ], [ %where.6.2.6.i.i.i.i, %B616.6.i.i.i.i ]
  %x.4.2.7.i.i.i.i = phi double [ %.842.7.i.i.i.i, %B456.7.i.i.i.i ], [ %x.4.2.6.i.i.i.i, %B616.6.i.i.i.i ]
  %n.4.2.7.i.i.i.i = phi double [ %.877.7.i.i.i.i, %B456.7.i.i.i.i ], [ %n.4.2.6.i.i.i.i, %B616.6.i.i.i.i ]
  %.297.i.i.i.i = icmp sgt i64 %.296501517.i.i.i.i, 1
  br i1 %.297.i.i.i.i, label %B230.if.i.i.i.i, label %B620.i.i.i.i

B620.i.i.i.i:                                     ; preds = %B616.7.i.i.i.i, %B1188.i.i
  %best.5.0.lcssa.i.i.i.i = phi double [ 0xFFF0000000000000, %B1188.i.i ], [ %best.4.2.7.i.i.i.i, %B616.7.i.i.i.i ]
  %where.4.0.lcssa.i.i.i.i = phi double [ 0.000000e+00, %B1188.i.i ], [ %where.6.2.7.i.i.i.i, %B616.7.i.i.i.i ]
  %x.2.0.lcssa.i2.i.i.i = phi double [ 0.000000e+00, %B1188.i.i ], [ %x.4.2.7.i.i.i.i, %B616.7.i.i.i.i ]
  %n.2.0.lcssa.i.i.i.i = phi double [ 1.000000e+00, %B1188.i.i ], [ %n.4.2.7.i.i.i.i, %B616.7.i.i.i.i ]
  %.940.i.i.i.i = fdiv contract double %x.2.0.lcssa.i2.i.i.i, %n.2.0.lcssa.i.i.i.i
  %.12.i.i.i.i.i = fcmp contract ogt double %.533.i.i.i, %.940.i.i.i.i
  %.13.i.i.i.i.i = select i1 %.12.i.i.i.i.i, double %.533.i.i.i, double %.940.i.i.i.i
  %.12.i152.i.i.i.i = fcmp contract olt double %.563.i.i.i, %.13.i.i.i.i.i
  %.13.i153.i.i.i.i = select i1 %.12.i152.i.i.i.i, double %.563.i.i.i, double %.13.i.i.i.i.i
  %.1002.i.i.i.i = fmul contract double %.593.i.i.i, 2.000000e+00
  %.1009.i.i.i.i = fdiv contract double %.1002.i.i.i.i, %n.2.0.lcssa.i.i.i.i
  %.1012.i.i.i.i = tail call contract double @llvm.sqrt.f64(double %.1009.i.i.i.i)
  %.1013.i.i.i.i = fadd contract double %.1012.i.i.i.i, %.13.i153.i.i.i.i
  %.1014.i.i.i.i = fmul contract double %.1013.i.i.i.i, 1.100000e+00
  %.1020.i3.i.i.i = fcmp contract olt double %.1014.i.i.i.i, %.563.i.i.i
  %"$phi754.0.2.0.i.i.i.i" = select i1 %.1020.i3.i.i.i, double %.1014.i.i.i.i, double %.563.i.i.i
  %.1040.i.i.i.i = fmul contract double %"$phi754.0.2.0.i.i.i.i", 5.000000e-01
  %.1043.i.i.i.i = fmul contract double %bend_n.2.0.lcssa.i.i, %.1040.i.i.i.i
  %.1044.i.i.i.i = fadd contract double %bend_x.2.0.lcssa.i.i, %.1043.i.i.i.i
  %.1045.i.i.i.i = fmul contract double %"$phi754.0.2.0.i.i.i.i", %.1044.i.i.i.i
  %.1046.i.i.i.i = tail call contract double @llvm.sqrt.f64(double %.1045.i.i.i.i)
  %.1047.i.i.i.i = fmul contract double %.1046.i.i.i.i, 8.500000e+00
  %.1048.i.i.i.i = fadd contract double %.1047.i.i.i.i, 3.200000e+01
  %.1065.i.i.i.i = fmul contract double %size_n.2.0.lcssa.i.i, %"$phi754.0.2.0.i.i.i.i"
  %.1067.i.i.i.i = fadd contract double %size_x.2.0.lcssa.i.i, %.1065.i.i.i.i
  %.1070.i.i.i.i = fmul contract double %"$phi754.0.2.0.i.i.i.i", %.1067.i.i.i.i
  %.1071.i.i.i.i = fcmp contract olt double %.1070.i.i.i.i, 1.000000e+13
  br i1 %.1071.i.i.i.i, label %B922.i.i.i.i, label %B1022.i.i.i.i

B922.i.i.i.i:                                     ; preds = %B620.i.i.i.i
  %.1081.i.i.i.i = fmul contract double %.165.i.i.i.i, 2.000000e+00
  %.1083.i.i.i.i = fcmp contract ult double %.1048.i.i.i.i, %.1081.i.i.i.i
  br i1 %.1083.i.i.i.i, label %B1022.i.i.i.i, label %B962.i.i.i.i

B962.i.i.i.i:                                     ; preds = %B922.i.i.i.i, %B962.i.i.i.i
  %steps.2.1.i.i.i.i = phi double [ %.1112.i.i.i.i, %B962.i.i.i.i ], [ %.1048.i.i.i.i, %B922.i.i.i.i ]
  %halvings.2.1.i.i.i.i = phi i64 [ %.1122.i.i.i.i, %B962.i.i.i.i ], [ 0, %B922.i.i.i.i ]
  %.1112.i.i.i.i = fmul contract double %steps.2.1.i.i.i.i, 5.000000e-01
  %.1122.i.i.i.i = add nuw nsw i64 %halvings.2.1.i.i.i.i, 1
  %.1135.i.i.i.i = fcmp contract oge double %.1112.i.i.i.i, %.1081.i.i.i.i
  %.1152.i.i.i.i = icmp samesign ult i64 %halvings.2.1.i.i.i.i, 23
  %or.cond.i.i.i.i = select i1 %.1135.i.i.i.i, i1 %.1152.i.i.i.i, i1 false
  br i1 %or.cond.i.i.i.i, label %B962.i.i.i.i, label %B1022.i.i.i.i

B1022.i.i.i.i:                                    ; preds = %B962.i.i.i.i, %B922.i.i.i.i, %B620.i.i.i.i
  %steps.3.0.i.i.i.i = phi double [ %.1048.i.i.i.i, %B620.i.i.i.i ], [ %.1048.i.i.i.i, %B922.i.i.i.i ], [ %.1112.i.i.i.i, %B962.i.i.i.i ]
  %halvings.3.0.i.i.i.i = phi i64 [ 0, %B620.i.i.i.i ], [ 0, %B922.i.i.i.i ], [ %.1122.i.i.i.i, %B962.i.i.i.i ]
  %.1176.i.i.i.i = fcmp contract ogt double %steps.3.0.i.i.i.i, %.165.i.i.i.i
  %.1188.i.i.i.i = fmul contract double %.165.i.i.i.i, 2.000000e+00
  %.1192.i.i.i.i = fcmp contract olt double %steps.3.0.i.i.i.i, %.1188.i.i.i.i
  %or.cond468.i.i.i.i = and i1 %.1176.i.i.i.i, %.1192.i.i.i.i
  br i1 %or.cond468.i.i.i.i, label %B1060.endif.i.i.i.i, label %B1158.i.i.i.i

B1158.i.i.i.i:                                    ; preds = %B1060.endif.i.i.i.i, %B1022.i.i.i.i
  %cells.2.0.i.i.i.i = phi i64 [ %.1253.i.i.i.i, %B1060.endif.i.i.i.i ], [ %.667.i.i.i, %B1022.i.i.i.i ]
  %.1260.i.i.i.i = fmul contract double %.169.i1.i.i.i, 2.000000e+00
  %.1267.i.i.i.i = sitofp i64 %cells.2.0.i.i.i.i to double
  %.1271.i.i.i.i = fdiv contract double 0x400921FB54442D18, %.1267.i.i.i.i
  %.1355535.i.i.i.i = icmp sgt i64 %halvings.3.0.i.i.i.i, 0
  br i1 %.1355535.i.i.i.i, label %B1228.if.preheader.i.i.i.i, label %B1244.i.i.i.i

B1228.if.preheader.i.i.i.i:                       ; preds = %B1158.i.i.i.i
  %xtraiter.i.i.i.i = and i64 %halvings.3.0.i.i.i.i, 7
  %lcmp.mod.not.i.i.i.i = icmp eq i64 %xtraiter.i.i.i.i, 0
  br i1 %lcmp.mod.not.i.i.i.i, label %B1228.if.prol.loopexit.i.i.i.i, label %B1228.if.prol.i.i.i.i

B1228.if.prol.i.i.i.i:                            ; preds = %B1228.if.preheader.i.i.i.i, %B1228.if.prol.i.i.i.i
  %lsr.iv.i.i.i.i = phi i64 [ %lsr.iv.next.i.i.i.i, %B1228.if.prol.i.i.i.i ], [ %xtraiter.i.i.i.i, %B1228.if.preheader.i.i.i.i ]
  %finest.2.0538.prol.i.i.i.i = phi double [ %.1394.prol.i.i.i.i, %B1228.if.prol.i.i.i.i ], [ %.1271.i.i.i.i, %B1228.if.preheader.i.i.i.i ]
  %.1394.prol.i.i.i.i = fmul contract double %finest.2.0538.prol.i.i.i.i, 5.000000e-01
  %lsr.iv.next.i.i.i.i = add nsw i64 %lsr.iv.i.i.i.i, -1
  %prol.iter.cmp.not.i.i.i.i = icmp eq i64 %lsr.iv.next.i.i.i.i, 0
  br i1 %prol.iter.cmp.not.i.i.i.i, label %B1228.if.prol.loopexit.loopexit.i.i.i.i, label %B1228.if.prol.i.i.i.i, !llvm.loop !12

B1228.if.prol.loopexit.loopexit.i.i.i.i:          ; preds = %B1228.if.prol.i.i.i.i
  %23 = and i64 %halvings.3.0.i.i.i.i, 9223372036854775800
  br label %B1228.if.prol.loopexit.i.i.i.i

B1228.if.prol.loopexit.i.i.i.i:                   ; preds = %B1228.if.prol.loopexit.loopexit.i.i.i.i, %B1228.if.preheader.i.i.i.i
  %finest.2.0538.unr.i.i.i.i = phi double [ %.1271.i.i.i.i, %B1228.if.preheader.i.i.i.i ], [ %.1394.prol.i.i.i.i, %B1228.if.prol.loopexit.loopexit.i.i.i.i ]
  %.1354533537.unr.i.i.i.i = phi i64 [ %halvings.3.0.i.i.i.i, %B1228.if.preheader.i.i.i.i ], [ %23, %B1228.if.prol.loopexit.loopexit.i.i.i.i ]
  %.1394.lcssa.unr.i.i.i.i = phi double [ poison, %B1228.if.preheader.i.i.i.i ], [ %.1394.prol.i.i.i.i, %B1228.if.prol.loopexit.loopexit.i.i.i.i ]
  %24 = icmp ult i64 %halvings.3.0.i.i.i.i, 8
  br i1 %24, label %B1244.i.i.i.i, label %B1228.if.i.i.i.i

B1244.i.i.i.i:                                    ; preds = %B1228.if.2.i.i.i.i, %B1228.if.1.i.i.i.i, %B1228.if.i.i.i.i, %B1228.if.prol.loopexit.i.i.i.i, %B1158.i.i.i.i
  %finest.2.0.lcssa.i.i.i.i = phi double [ %.1271.i.i.i.i, %B1158.i.i.i.i ], [ %.1394.lcssa.unr.i.i.i.i, %B1228.if.prol.loopexit.i.i.i.i ], [ %.1394.7.i.i.i.i, %B1228.if.i.i.i.i ], [ %.1394.7.1.i.i.i.i, %B1228.if.1.i.i.i.i ], [ %.1394.7.2.i.i.i.i, %B1228.if.2.i.i.i.i ]
  %.1424.i.i.i.i = fcmp contract ogt double %.1260.i.i.i.i, %finest.2.0.lcssa.i.i.i.i
  br i1 %.1424.i.i.i.i, label %B1256.preheader.i.i.i.i, label %_ZN17bnserve_inference15marginal_kernel7_circle7_surveyB3v29B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedExx8UniTupleIdLi3EEd5ArrayIdLi1E1C7mutable7alignedE.exit.i.i.i

B1256.preheader.i.i.i.i:                          ; preds = %B1244.i.i.i.i
  %.990.i.i.i.i.i = fmul contract double %size_n.2.0.lcssa.i.i, 1.000000e-09
  %.991.i.i.i.i.i = fadd contract double %.990.i.i.i.i.i, 0x10000000000000
  %.1020.i.i.i.i.i = fneg contract double %.991.i.i.i.i.i
  %.1021.i.i.i.i.i = insertelement <8 x double> poison, double %.1020.i.i.i.i.i, i64 0
  %.1022.i.i.i.i.i = shufflevector <8 x double> %.1021.i.i.i.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1197.i.i.i.i.i = fneg contract double %.533.i.i.i
  %.1198.i.i.i.i.i = insertelement <8 x double> poison, double %.1197.i.i.i.i.i, i64 0
  %.1199.i.i.i.i.i = shufflevector <8 x double> %.1198.i.i.i.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1225.i.i.i.i.i = insertelement <8 x double> poison, double %.563.i.i.i, i64 0
  %.1226.i.i.i.i.i = shufflevector <8 x double> %.1225.i.i.i.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1377.i.i.i.i.i = fmul contract double %bend_x.2.0.lcssa.i.i, 0.000000e+00
  %.6.i48.i.i.i.i.i = insertelement <8 x double> poison, double %.1377.i.i.i.i.i, i64 0
  %.7.i.i.i.i.i.i = shufflevector <8 x double> %.6.i48.i.i.i.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1451.i.i.i.i.i = fmul contract double %bend_n.2.0.lcssa.i.i, 0.000000e+00
  %.6.i51.i.i.i.i.i = insertelement <8 x double> poison, double %.1451.i.i.i.i.i, i64 0
  %.7.i52.i.i.i.i.i = shufflevector <8 x double> %.6.i51.i.i.i.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %25 = getelementptr double, ptr %1, i64 %.598.i.i
  %.idx.i.i.i.i.i = shl i64 %.598.i.i, 4
  %26 = getelementptr i8, ptr %1, i64 %.idx.i.i.i.i.i
  %.idx288.i.i.i.i.i = mul i64 %.598.i.i, 24
  %27 = getelementptr i8, ptr %1, i64 %.idx288.i.i.i.i.i
  %sunkaddr83.i.i.i.i = getelementptr i8, ptr %.1620.i.i, i64 8
  %sunkaddr84.i.i.i.i = getelementptr i8, ptr %.1620.i.i, i64 16
  %sunkaddr85.i.i.i.i = getelementptr i8, ptr %.1620.i.i, i64 24
  %sunkaddr86.i.i.i.i = getelementptr i8, ptr %.1620.i.i, i64 32
  %sunkaddr87.i.i.i.i = getelementptr i8, ptr %.1620.i.i, i64 40
  %sunkaddr88.i.i.i.i = getelementptr i8, ptr %.1620.i.i, i64 48
  %sunkaddr89.i.i.i.i = getelementptr i8, ptr %.1620.i.i, i64 56
  %sunkaddr90.i.i.i.i = getelementptr inbounds nuw i8, ptr %.1620.i.i, i64 64
  %sunkaddr91.i.i.i.i = getelementptr inbounds nuw i8, ptr %.1620.i.i, i64 128
  %sunkaddr92.i.i.i.i = getelementptr inbounds nuw i8, ptr %.1620.i.i, i64 192
  %sunkaddr93.i.i.i.i = getelementptr inbounds nuw i8, ptr %.1620.i.i, i64 256
  %sunkaddr94.i.i.i.i = getelementptr inbounds nuw i8, ptr %.1620.i.i, i64 320
  %sunkaddr95.i.i.i.i = getelementptr inbounds nuw i8, ptr %.1620.i.i, i64 384
  %sunkaddr96.i.i.i.i = getelementptr inbounds nuw i8, ptr %.1620.i.i, i64 448
  %sunkaddr97.i.i.i.i = getelementptr inbounds nuw i8, ptr %.1620.i.i, i64 512
  %sunkaddr98.i.i.i.i = getelementptr i8, ptr %.1620.i.i, i64 456
  %sunkaddr99.i.i.i.i = getelementptr i8, ptr %.1620.i.i, i64 464
  %sunkaddr100.i.i.i.i = getelementptr i8, ptr %.1620.i.i, i64 472
  %sunkaddr101.i.i.i.i = getelementptr i8, ptr %.1620.i.i, i64 480
  %sunkaddr102.i.i.i.i = getelementptr i8, ptr %.1620.i.i, i64 488
  %sunkaddr103.i.i.i.i = getelementptr i8, ptr %.1620.i.i, i64 496
  %sunkaddr104.i.i.i.i = getelementptr i8, ptr %.1620.i.i, i64 504
  br label %B1256.i.i.i.i

B1256.i.i.i.i:                                    ; preds = %B1564.i.i.i.i, %B1256.preheader.i.i.i.i
  %best.8.0.i.i.i.i = phi double [ %best.7.2.7.i.i.i.i, %B1564.i.i.i.i ], [ %best.5.0.lcssa.i.i.i.i, %B1256.preheader.i.i.i.i ]
  %where.3.0.i.i.i.i = phi double [ %where.8.2.7.i.i.i.i, %B1564.i.i.i.i ], [ %where.4.0.lcssa.i.i.i.i, %B1256.preheader.i.i.i.i ]
  %width.2.0.i.i.i.i = phi double [ %.1918.i.i.i.i, %B1564.i.i.i.i ], [ %.1260.i.i.i.i, %B1256.preheader.i.i.i.i ]
  %.1560.i.i.i.i = fmul contract double %width.2.0.i.i.i.i, 8.750000e-01
  %28 = fsub contract double %where.3.0.i.i.i.i, %.1560.i.i.i.i
  store double %28, ptr %.1620.i.i, align 8, !noalias !9
  %.1560.1.i.i.i.i = fmul contract double %width.2.0.i.i.i.i, 6.250000e-01
  %29 = fsub contract double %where.3.0.i.i.i.i, %.1560.1.i.i.i.i
  store double %29, ptr %sunkaddr83.i.i.i.i, align 8, !noalias !9
  %.1560.2.i.i.i.i = fmul contract double %width.2.0.i.i.i.i, 3.750000e-01
  %30 = fsub contract double %where.3.0.i.i.i.i, %.1560.2.i.i.i.i
  store double %30, ptr %sunkaddr84.i.i.i.i, align 8, !noalias !9
  %.1560.3.i.i.i.i = fmul contract double %width.2.0.i.i.i.i, 1.250000e-01
  %31 = fsub contract double %where.3.0.i.i.i.i, %.1560.3.i.i.i.i
  store double %31, ptr %sunkaddr85.i.i.i.i, align 8, !noalias !9
  %.1562.4.i.i.i.i = fadd contract double %where.3.0.i.i.i.i, %.1560.3.i.i.i.i
  store double %.1562.4.i.i.i.i, ptr %sunkaddr86.i.i.i.i, align 8, !noalias !9
  %.1562.5.i.i.i.i = fadd contract double %where.3.0.i.i.i.i, %.1560.2.i.i.i.i
  store double %.1562.5.i.i.i.i, ptr %sunkaddr87.i.i.i.i, align 8, !noalias !9
  %.1562.6.i.i.i.i = fadd contract double %where.3.0.i.i.i.i, %.1560.1.i.i.i.i
  store double %.1562.6.i.i.i.i, ptr %sunkaddr88.i.i.i.i, align 8, !noalias !9
  %.1562.7.i.i.i.i = fadd contract double %where.3.0.i.i.i.i, %.1560.i.i.i.i
  store double %.1562.7.i.i.i.i, ptr %sunkaddr89.i.i.i.i, align 8, !noalias !9
  %.66.i.i.i.i.i = load <8 x double>, ptr %.1620.i.i, align 8, !noalias !14
  %.71.i.i.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.66.i.i.i.i.i, <8 x double> splat (double 0x3FE45F306DC9C883), <8 x double> splat (double 0x4338000000000000))
  %.8.i.i.i.i.i.i = fadd contract <8 x double> %.71.i.i.i.i.i, splat (double 0xC338000000000000)
  %.114.i.i.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i.i.i.i.i.i, <8 x double> splat (double 0xBFF921FB54442D18), <8 x double> %.66.i.i.i.i.i)
  %.131.i.i.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i.i.i.i.i.i, <8 x double> splat (double 0xBC91A62633145C07), <8 x double> %.114.i.i.i.i.i)
  %.6.i.i.i.i.i.i = fmul contract <8 x double> %.131.i.i.i.i.i, %.131.i.i.i.i.i
  %.6.i20.i.i.i.i.i = fmul contract <8 x double> %.131.i.i.i.i.i, %.6.i.i.i.i.i.i
  %.160.i.i.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i.i.i.i.i, <8 x double> splat (double 0xBD6AE7F3E733B81F), <8 x double> splat (double 0x3DE6124613A86D09))
  %.163.i.i.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i.i.i.i.i, <8 x double> %.160.i.i.i.i.i, <8 x double> splat (double 0xBE5AE64567F544E4))
  %.166.i.i.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i.i.i.i.i, <8 x double> %.163.i.i.i.i.i, <8 x double> splat (double 0x3EC71DE3A556C734))
  %.169.i.i.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i.i.i.i.i, <8 x double> %.166.i.i.i.i.i, <8 x double> splat (double 0xBF2A01A01A01A01A))
  %.172.i.i.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i.i.i.i.i, <8 x double> %.169.i.i.i.i.i, <8 x double> splat (double 0x3F81111111111111))
  %.175.i.i.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i.i.i.i.i, <8 x double> %.172.i.i.i.i.i, <8 x double> splat (double 0xBFC5555555555555))
  %.200.i.i.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i20.i.i.i.i.i, <8 x double> %.175.i.i.i.i.i, <8 x double> %.131.i.i.i.i.i)
  %.205.i.i.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i.i.i.i.i, <8 x double> splat (double 0x3D2AE7F3E733B81F), <8 x double> splat (double 0xBDA93974A8C07C9D))
  %.208.i.i.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i.i.i.i.i, <8 x double> %.205.i.i.i.i.i, <8 x double> splat (double 0x3E21EED8EFF8D898))
  %.211.i.i.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i.i.i.i.i, <8 x double> %.208.i.i.i.i.i, <8 x double> splat (double 0xBE927E4FB7789F5C))
  %.214.i.i.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i.i.i.i.i, <8 x double> %.211.i.i.i.i.i, <8 x double> splat (double 0x3EFA01A01A01A01A))
  %.217.i.i.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i.i.i.i.i, <8 x double> %.214.i.i.i.i.i, <8 x double> splat (double 0xBF56C16C16C16C17))
  %.220.i.i.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i.i.i.i.i, <8 x double> %.217.i.i.i.i.i, <8 x double> splat (double 0x3FA5555555555555))
  %.223.i.i.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i.i.i.i.i, <8 x double> %.220.i.i.i.i.i, <8 x double> splat (double -5.000000e-01))
  %.226.i.i.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i.i.i.i.i, <8 x double> %.223.i.i.i.i.i, <8 x double> splat (double 1.000000e+00))
  %.227.i.i.i.i.i = bitcast <8 x double> %.71.i.i.i.i.i to <8 x i64>
  %.228.i.i.i.i.i = bitcast <8 x double> %.200.i.i.i.i.i to <8 x i64>
  %.229.i.i.i.i.i = bitcast <8 x double> %.226.i.i.i.i.i to <8 x i64>
  %.6.i21.i.i.i.i.i = xor <8 x i64> %.229.i.i.i.i.i, %.228.i.i.i.i.i
  %.8.i22.i.i.i.i.i = and <8 x i64> %.227.i.i.i.i.i, splat (i64 1)
  %32 = icmp eq <8 x i64> %.8.i22.i.i.i.i.i, zeroinitializer
  %.6.i24.i.i.i.i.i = select <8 x i1> %32, <8 x i64> zeroinitializer, <8 x i64> %.6.i21.i.i.i.i.i
  %.8.i25.i.i.i.i.i = shl <8 x i64> %.227.i.i.i.i.i, splat (i64 62)
  %.8.i26.i.i.i.i.i = and <8 x i64> %.8.i25.i.i.i.i.i, splat (i64 -9223372036854775808)
  %.8.i28.i.i.i.i.i = add <8 x i64> %.8.i25.i.i.i.i.i, splat (i64 4611686018427387904)
  %.8.i29.i.i.i.i.i = and <8 x i64> %.8.i28.i.i.i.i.i, splat (i64 -9223372036854775808)
  %33 = xor <8 x i64> %.8.i26.i.i.i.i.i, %.228.i.i.i.i.i
  %.6.i31.i.i.i.i.i = xor <8 x i64> %33, %.6.i24.i.i.i.i.i
  %34 = bitcast <8 x i64> %.6.i31.i.i.i.i.i to <8 x double>
  %35 = xor <8 x i64> %.8.i29.i.i.i.i.i, %.229.i.i.i.i.i
  %.6.i33.i.i.i.i.i = xor <8 x i64> %35, %.6.i24.i.i.i.i.i
  %36 = bitcast <8 x i64> %.6.i33.i.i.i.i.i to <8 x double>
  store <8 x i64> %.6.i33.i.i.i.i.i, ptr %sunkaddr90.i.i.i.i, align 8, !noalias !14
  store <8 x i64> %.6.i31.i.i.i.i.i, ptr %sunkaddr91.i.i.i.i, align 8, !noalias !14
  br i1 %.711.i.i, label %_ZN17bnserve_inference15marginal_kernel7_circle10_at_phasesB3v30B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedExd8UniTupleIdLi3EEdd.exit.i.i.i.i, label %B356.if.i.i.i.i.i

B904.loopexit.i.i.i.i.i:                          ; preds = %B356.if.i.i.i.i.i
  %37 = tail call <8 x double> @llvm.fabs.v8f64(<8 x double> %.864.i.i.i.i.i)
  %38 = tail call <8 x double> @llvm.fabs.v8f64(<8 x double> %.879.i.i.i.i.i)
  %39 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %37, <8 x double> zeroinitializer, <8 x double> %.837.i.i.i.i.i)
  br label %_ZN17bnserve_inference15marginal_kernel7_circle10_at_phasesB3v30B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedExd8UniTupleIdLi3EEdd.exit.i.i.i.i

B356.if.i.i.i.i.i:                                ; preds = %B1256.i.i.i.i, %B356.if.i.i.i.i.i
  %dn.2.0318.i.i.i.i.i = phi <8 x double> [ %.879.i.i.i.i.i, %B356.if.i.i.i.i.i ], [ zeroinitializer, %B1256.i.i.i.i ]
  %dx.2.0317.i.i.i.i.i = phi <8 x double> [ %.864.i.i.i.i.i, %B356.if.i.i.i.i.i ], [ zeroinitializer, %B1256.i.i.i.i ]
  %n.3.0316.i.i.i.i.i = phi <8 x double> [ %.849.i.i.i.i.i, %B356.if.i.i.i.i.i ], [ zeroinitializer, %B1256.i.i.i.i ]
  %x.2.0315.i.i.i.i.i = phi <8 x double> [ %.837.i.i.i.i.i, %B356.if.i.i.i.i.i ], [ zeroinitializer, %B1256.i.i.i.i ]
  %real.2.0314.i.i.i.i.i = phi <8 x double> [ %.934.i.i.i.i.i, %B356.if.i.i.i.i.i ], [ splat (double 1.000000e+00), %B1256.i.i.i.i ]
  %imaginary.2.0313.i.i.i.i.i = phi <8 x double> [ %.963.i.i.i.i.i, %B356.if.i.i.i.i.i ], [ zeroinitializer, %B1256.i.i.i.i ]
  %.728307311.i.i.i.i.i = phi i64 [ %.735.i.i.i.i.i, %B356.if.i.i.i.i.i ], [ 0, %B1256.i.i.i.i ]
  %.735.i.i.i.i.i = add nuw nsw i64 %.728307311.i.i.i.i.i, 1
  %40 = shl i64 %.728307311.i.i.i.i.i, 3
  %scevgep65.i.i.i.i.i = getelementptr i8, ptr %1, i64 %40
  %.768.i.i.i.i.i = load double, ptr %scevgep65.i.i.i.i.i, align 8, !noalias !14
  %scevgep64.i.i.i.i.i = getelementptr i8, ptr %25, i64 %40
  %.779.i.i.i.i.i = load double, ptr %scevgep64.i.i.i.i.i, align 8, !noalias !14
  %scevgep63.i.i.i.i.i = getelementptr i8, ptr %26, i64 %40
  %.791.i.i.i.i.i = load double, ptr %scevgep63.i.i.i.i.i, align 8, !noalias !14
  %scevgep2.i.i.i.i = getelementptr i8, ptr %27, i64 %40
  %.803.i.i.i.i.i = load double, ptr %scevgep2.i.i.i.i, align 8, !noalias !14
  %.828.i.i.i.i.i = fneg contract double %.779.i.i.i.i.i
  %.831.i.i.i.i.i = insertelement <8 x double> poison, double %.828.i.i.i.i.i, i64 0
  %.832.i.i.i.i.i = shufflevector <8 x double> %.831.i.i.i.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.833.i.i.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %imaginary.2.0313.i.i.i.i.i, <8 x double> %.832.i.i.i.i.i, <8 x double> %x.2.0315.i.i.i.i.i)
  %.835.i.i.i.i.i = insertelement <8 x double> poison, double %.768.i.i.i.i.i, i64 0
  %.836.i.i.i.i.i = shufflevector <8 x double> %.835.i.i.i.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.837.i.i.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %real.2.0314.i.i.i.i.i, <8 x double> %.836.i.i.i.i.i, <8 x double> %.833.i.i.i.i.i)
  %.840.i.i.i.i.i = fneg contract double %.803.i.i.i.i.i
  %.843.i.i.i.i.i = insertelement <8 x double> poison, double %.840.i.i.i.i.i, i64 0
  %.844.i.i.i.i.i = shufflevector <8 x double> %.843.i.i.i.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.845.i.i.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %imaginary.2.0313.i.i.i.i.i, <8 x double> %.844.i.i.i.i.i, <8 x double> %n.3.0316.i.i.i.i.i)
  %.847.i.i.i.i.i = insertelement <8 x double> poison, double %.791.i.i.i.i.i, i64 0
  %.848.i.i.i.i.i = shufflevector <8 x double> %.847.i.i.i.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.849.i.i.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %real.2.0314.i.i.i.i.i, <8 x double> %.848.i.i.i.i.i, <8 x double> %.845.i.i.i.i.i)
  %.852.i.i.i.i.i = uitofp nneg i64 %.728307311.i.i.i.i.i to double
  %.853.i.i.i.i.i = fmul contract double %.779.i.i.i.i.i, %.852.i.i.i.i.i
  %.855.i.i.i.i.i = fmul contract double %.768.i.i.i.i.i, %.852.i.i.i.i.i
  %.858.i.i.i.i.i = insertelement <8 x double> poison, double %.855.i.i.i.i.i, i64 0
  %.859.i.i.i.i.i = shufflevector <8 x double> %.858.i.i.i.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.860.i.i.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %imaginary.2.0313.i.i.i.i.i, <8 x double> %.859.i.i.i.i.i, <8 x double> %dx.2.0317.i.i.i.i.i)
  %.862.i.i.i.i.i = insertelement <8 x double> poison, double %.853.i.i.i.i.i, i64 0
  %.863.i.i.i.i.i = shufflevector <8 x double> %.862.i.i.i.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.864.i.i.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %real.2.0314.i.i.i.i.i, <8 x double> %.863.i.i.i.i.i, <8 x double> %.860.i.i.i.i.i)
  %.868.i.i.i.i.i = fmul contract double %.803.i.i.i.i.i, %.852.i.i.i.i.i
  %.870.i.i.i.i.i = fmul contract double %.791.i.i.i.i.i, %.852.i.i.i.i.i
  %.873.i.i.i.i.i = insertelement <8 x double> poison, double %.870.i.i.i.i.i, i64 0
  %.874.i.i.i.i.i = shufflevector <8 x double> %.873.i.i.i.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.875.i.i.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %imaginary.2.0313.i.i.i.i.i, <8 x double> %.874.i.i.i.i.i, <8 x double> %dn.2.0318.i.i.i.i.i)
  %.877.i.i.i.i.i = insertelement <8 x double> poison, double %.868.i.i.i.i.i, i64 0
  %.878.i.i.i.i.i = shufflevector <8 x double> %.877.i.i.i.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.879.i.i.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %real.2.0314.i.i.i.i.i, <8 x double> %.878.i.i.i.i.i, <8 x double> %.875.i.i.i.i.i)
  %.6.i34.i.i.i.i.i = fmul contract <8 x double> %imaginary.2.0313.i.i.i.i.i, %34
  %.8.i35.i.i.i.i.i = fsub contract <8 x double> zeroinitializer, %.6.i34.i.i.i.i.i
  %.6.i36.i.i.i.i.i = fmul contract <8 x double> %imaginary.2.0313.i.i.i.i.i, %36
  %.934.i.i.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %real.2.0314.i.i.i.i.i, <8 x double> %36, <8 x double> %.8.i35.i.i.i.i.i)
  %.963.i.i.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %real.2.0314.i.i.i.i.i, <8 x double> %34, <8 x double> %.6.i36.i.i.i.i.i)
  %exitcond.not.i.i.i.i.i = icmp eq i64 %.13.i.i.i, %.728307311.i.i.i.i.i
  br i1 %exitcond.not.i.i.i.i.i, label %B904.loopexit.i.i.i.i.i, label %B356.if.i.i.i.i.i

_ZN17bnserve_inference15marginal_kernel7_circle10_at_phasesB3v30B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedExd8UniTupleIdLi3EEdd.exit.i.i.i.i: ; preds = %B904.loopexit.i.i.i.i.i, %B1256.i.i.i.i
  %x.2.0.lcssa.i.i.i.i.i = phi <8 x double> [ zeroinitializer, %B1256.i.i.i.i ], [ %.837.i.i.i.i.i, %B904.loopexit.i.i.i.i.i ]
  %n.3.0.lcssa.i.i.i.i.i = phi <8 x double> [ zeroinitializer, %B1256.i.i.i.i ], [ %.849.i.i.i.i.i, %B904.loopexit.i.i.i.i.i ]
  %.1368.i.i.i.i.i = phi <8 x double> [ zeroinitializer, %B1256.i.i.i.i ], [ %39, %B904.loopexit.i.i.i.i.i ]
  %41 = phi <8 x double> [ zeroinitializer, %B1256.i.i.i.i ], [ %38, %B904.loopexit.i.i.i.i.i ]
  %.8.i19.i.i.i.i.i = fsub contract <8 x double> zeroinitializer, %n.3.0.lcssa.i.i.i.i.i
  %.1023.i.i.i.i.i = tail call <8 x double> @llvm.minnum.v8f64(<8 x double> %.8.i19.i.i.i.i.i, <8 x double> %.1022.i.i.i.i.i)
  %.8.i37.i.i.i.i.i = fsub contract <8 x double> zeroinitializer, %.1023.i.i.i.i.i
  store <8 x double> %x.2.0.lcssa.i.i.i.i.i, ptr %sunkaddr92.i.i.i.i, align 8, !noalias !14
  store <8 x double> %.8.i37.i.i.i.i.i, ptr %sunkaddr93.i.i.i.i, align 8, !noalias !14
  %.6.i38.i.i.i.i.i = fdiv contract <8 x double> %x.2.0.lcssa.i.i.i.i.i, %.8.i37.i.i.i.i.i
  store <8 x double> %.6.i38.i.i.i.i.i, ptr %sunkaddr94.i.i.i.i, align 8, !noalias !14
  %.1108.i.i.i.i.i = tail call <8 x double> @llvm.sqrt.v8f64(<8 x double> %.8.i37.i.i.i.i.i)
  %.8.i39.i.i.i.i.i = fdiv contract <8 x double> splat (double 1.000000e+00), %.1108.i.i.i.i.i
  store <8 x double> %.8.i39.i.i.i.i.i, ptr %sunkaddr95.i.i.i.i, align 8, !noalias !14
  %.8.i41.i.i.i.i.i = fsub contract <8 x double> zeroinitializer, %.6.i38.i.i.i.i.i
  %.1200.i.i.i.i.i = tail call <8 x double> @llvm.minnum.v8f64(<8 x double> %.8.i41.i.i.i.i.i, <8 x double> %.1199.i.i.i.i.i)
  %.8.i42.i.i.i.i.i = fsub contract <8 x double> zeroinitializer, %.1200.i.i.i.i.i
  %.1227.i.i.i.i.i = tail call <8 x double> @llvm.minnum.v8f64(<8 x double> %.8.i42.i.i.i.i.i, <8 x double> %.1226.i.i.i.i.i)
  %.8.i43.i.i.i.i.i = fmul contract <8 x double> %.1227.i.i.i.i.i, splat (double 5.000000e-01)
  %.6.i44.i.i.i.i.i = fmul contract <8 x double> %.8.i37.i.i.i.i.i, %.8.i43.i.i.i.i.i
  %.6.i45.i.i.i.i.i = fsub contract <8 x double> %x.2.0.lcssa.i.i.i.i.i, %.6.i44.i.i.i.i.i
  %.6.i46.i.i.i.i.i = fmul contract <8 x double> %.1227.i.i.i.i.i, %.6.i45.i.i.i.i.i
  store <8 x double> %.6.i46.i.i.i.i.i, ptr %sunkaddr96.i.i.i.i, align 8, !noalias !14
  %.8.i49.i.i.i.i.i = fadd contract <8 x double> %.7.i.i.i.i.i.i, %.1368.i.i.i.i.i
  %.1437.i.i.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %41, <8 x double> splat (double -0.000000e+00), <8 x double> %.8.i37.i.i.i.i.i)
  %42 = fsub contract <8 x double> %.7.i52.i.i.i.i.i, %.1437.i.i.i.i.i
  %.8.i54.i.i.i.i.i = fadd contract <8 x double> %42, zeroinitializer
  %.1503.i.i.i.i.i = tail call <8 x double> @llvm.minnum.v8f64(<8 x double> %.8.i54.i.i.i.i.i, <8 x double> %.1022.i.i.i.i.i)
  %.8.i55.i.i.i.i.i = fsub contract <8 x double> zeroinitializer, %.1503.i.i.i.i.i
  %.6.i56.i.i.i.i.i = fdiv contract <8 x double> %.8.i49.i.i.i.i.i, %.8.i55.i.i.i.i.i
  %.8.i57.i.i.i.i.i = fsub contract <8 x double> zeroinitializer, %.6.i56.i.i.i.i.i
  %.1588.i.i.i.i.i = tail call <8 x double> @llvm.minnum.v8f64(<8 x double> %.8.i57.i.i.i.i.i, <8 x double> %.1199.i.i.i.i.i)
  %.8.i58.i.i.i.i.i = fsub contract <8 x double> zeroinitializer, %.1588.i.i.i.i.i
  %.1615.i.i.i.i.i = tail call <8 x double> @llvm.minnum.v8f64(<8 x double> %.8.i58.i.i.i.i.i, <8 x double> %.1226.i.i.i.i.i)
  %.8.i59.i.i.i.i.i = fmul contract <8 x double> %.1615.i.i.i.i.i, splat (double 5.000000e-01)
  %.6.i60.i.i.i.i.i = fmul contract <8 x double> %.8.i55.i.i.i.i.i, %.8.i59.i.i.i.i.i
  %.6.i61.i.i.i.i.i = fsub contract <8 x double> %.8.i49.i.i.i.i.i, %.6.i60.i.i.i.i.i
  %.6.i62.i.i.i.i.i = fmul contract <8 x double> %.1615.i.i.i.i.i, %.6.i61.i.i.i.i.i
  store <8 x double> %.6.i62.i.i.i.i.i, ptr %sunkaddr97.i.i.i.i, align 8, !noalias !14
  %.1810.i.i.i.i = load double, ptr %sunkaddr96.i.i.i.i, align 8, !noalias !9
  %.1812.i.i.i.i = fcmp contract ogt double %.1810.i.i.i.i, %best.8.0.i.i.i.i
  br i1 %.1812.i.i.i.i, label %B1500.i.i.i.i, label %B1564.i.i.i.i

B1500.i.i.i.i:                                    ; preds = %_ZN17bnserve_inference15marginal_kernel7_circle10_at_phasesB3v30B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedExd8UniTupleIdLi3EEdd.exit.i.i.i.i
  %.1879.i.i.i.i = load double, ptr %.1620.i.i, align 8, !noalias !9
  br label %B1564.i.i.i.i

B1564.i.i.i.i:                                    ; preds = %B1500.i.i.i.i, %_ZN17bnserve_inference15marginal_kernel7_circle10_at_phasesB3v30B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedExd8UniTupleIdLi3EEdd.exit.i.i.i.i
  %best.7.2.i.i.i.i = phi double [ %.1810.i.i.i.i, %B1500.i.i.i.i ], [ %best.8.0.i.i.i.i, %_ZN17bnserve_inference15marginal_kernel7_circle10_at_phasesB3v30B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedExd8UniTupleIdLi3EEdd.exit.i.i.i.i ]
  %where.8.2.i.i.i.i = phi double [ %.1879.i.i.i.i, %B1500.i.i.i.i ], [ %where.3.0.i.i.i.i, %_ZN17bnserve_inference15marginal_kernel7_circle10_at_phasesB3v30B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedExd8UniTupleIdLi3EEdd.exit.i.i.i.i ]
  %.1810.1.i.i.i.i = load double, ptr %sunkaddr98.i.i.i.i, align 8, !noalias !9
  %.1812.1.i.i.i.i = fcmp contract ogt double %.1810.1.i.i.i.i, %best.7.2.i.i.i.i
  %best.7.2.1.i.i.i.i = select i1 %.1812.1.i.i.i.i, double %.1810.1.i.i.i.i, double %best.7.2.i.i.i.i
  %where.8.2.1.i.i.i.i = select i1 %.1812.1.i.i.i.i, double %29, double %where.8.2.i.i.i.i
  %.1810.2.i.i.i.i = load double, ptr %sunkaddr99.i.i.i.i, align 8, !noalias !9
  %.1812.2.i.i.i.i = fcmp contract ogt double %.1810.2.i.i.i.i, %best.7.2.1.i.i.i.i
  %best.7.2.2.i.i.i.i = select i1 %.1812.2.i.i.i.i, double %.1810.2.i.i.i.i, double %best.7.2.1.i.i.i.i
  %where.8.2.2.i.i.i.i = select i1 %.1812.2.i.i.i.i, double %30, double %where.8.2.1.i.i.i.i
  %.1810.3.i.i.i.i = load double, ptr %sunkaddr100.i.i.i.i, align 8, !noalias !9
  %.1812.3.i.i.i.i = fcmp contract ogt double %.1810.3.i.i.i.i, %best.7.2.2.i.i.i.i
  %best.7.2.3.i.i.i.i = select i1 %.1812.3.i.i.i.i, double %.1810.3.i.i.i.i, double %best.7.2.2.i.i.i.i
  %where.8.2.3.i.i.i.i = select i1 %.1812.3.i.i.i.i, double %31, double %where.8.2.2.i.i.i.i
  %.1810.4.i.i.i.i = load double, ptr %sunkaddr101.i.i.i.i, align 8, !noalias !9
  %.1812.4.i.i.i.i = fcmp contract ogt double %.1810.4.i.i.i.i, %best.7.2.3.i.i.i.i
  %best.7.2.4.i.i.i.i = select i1 %.1812.4.i.i.i.i, double %.1810.4.i.i.i.i, double %best.7.2.3.i.i.i.i
  %where.8.2.4.i.i.i.i = select i1 %.1812.4.i.i.i.i, double %.1562.4.i.i.i.i, double %where.8.2.3.i.i.i.i
  %.1810.5.i.i.i.i = load double, ptr %sunkaddr102.i.i.i.i, align 8, !noalias !9
  %.1812.5.i.i.i.i = fcmp contract ogt double %.1810.5.i.i.i.i, %best.7.2.4.i.i.i.i
  %best.7.2.5.i.i.i.i = select i1 %.1812.5.i.i.i.i, double %.1810.5.i.i.i.i, double %best.7.2.4.i.i.i.i
  %where.8.2.5.i.i.i.i = select i1 %.1812.5.i.i.i.i, double %.1562.5.i.i.i.i, double %where.8.2.4.i.i.i.i
  %.1810.6.i.i.i.i = load double, ptr %sunkaddr103.i.i.i.i, align 8, !noalias !9
  %.1812.6.i.i.i.i = fcmp contract ogt double %.1810.6.i.i.i.i, %best.7.2.5.i.i.i.i
  %best.7.2.6.i.i.i.i = select i1 %.1812.6.i.i.i.i, double %.1810.6.i.i.i.i, double %best.7.2.5.i.i.i.i
  %where.8.2.6.i.i.i.i = select i1 %.1812.6.i.i.i.i, double %.1562.6.i.i.i.i, double %where.8.2.5.i.i.i.i
  %.1810.7.i.i.i.i = load double, ptr %sunkaddr104.i.i.i.i, align 8, !noalias !9
  %.1812.7.i.i.i.i = fcmp contract ogt double %.1810.7.i.i.i.i, %best.7.2.6.i.i.i.i
  %best.7.2.7.i.i.i.i = select i1 %.1812.7.i.i.i.i, double %.1810.7.i.i.i.i, double %best.7.2.6.i.i.i.i
  %where.8.2.7.i.i.i.i = select i1 %.1812.7.i.i.i.i, double %.1562.7.i.i.i.i, double %where.8.2.6.i.i.i.i
  %.1918.i.i.i.i = fmul contract double %width.2.0.i.i.i.i, 2.500000e-01
  %.1922.i.i.i.i = fcmp contract ogt double %.1918.i.i.i.i, %finest.2.0.lcssa.i.i.i.i
  br i1 %.1922.i.i.i.i, label %B1256.i.i.i.i, label %_ZN17bnserve_inference15marginal_kernel7_circle7_surveyB3v29B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedExx8UniTupleIdLi3EEd5ArrayIdLi1E1C7mutable7alignedE.exit.i.i.i

B230.if.i.i.i.i:                                  ; preds = %B616.7.i.i.i.i, %B230.if.preheader.i.i.i.i
  %n.2.0521.i.i.i.i = phi double [ %n.4.2.7.i.i.i.i, %B616.7.i.i.i.i ], [ 1.000000e+00, %B230.if.preheader.i.i.i.i ]
  %x.2.0520.i.i.i.i = phi double [ %x.4.2.7.i.i.i.i, %B616.7.i.i.i.i ], [ 0.000000e+00, %B230.if.preheader.i.i.i.i ]
  %where.4.0519.i.i.i.i = phi double [ %where.6.2.7.i.i.i.i, %B616.7.i.i.i.i ], [ 0.000000e+00, %B230.if.preheader.i.i.i.i ]
  %best.5.0518.i.i.i.i = phi double [ %best.4.2.7.i.i.i.i, %B616.7.i.i.i.i ], [ 0xFFF0000000000000, %B230.if.preheader.i.i.i.i ]
  %.296501517.i.i.i.i = phi i64 [ %.306.i.i.i.i, %B616.7.i.i.i.i ], [ %.276.i.i.i.i, %B230.if.preheader.i.i.i.i ]
  %.303502516.i.i.i.i = phi i64 [ %.310.i.i.i.i, %B616.7.i.i.i.i ], [ 0, %B230.if.preheader.i.i.i.i ]
  %.306.i.i.i.i = add nsw i64 %.296501517.i.i.i.i, -1
  %.310.i.i.i.i = add nuw i64 %.303502516.i.i.i.i, 8
  %.457.i.i.i.i = shl i64 %.303502516.i.i.i.i, 1
  %.458.i.i.i.i = or disjoint i64 %.457.i.i.i.i, 1
  %.460.i.i.i.i = sitofp i64 %.458.i.i.i.i to double
  %.461.i.i.i.i = fmul contract double %.169.i1.i.i.i, %.460.i.i.i.i
  store double %.461.i.i.i.i, ptr %.1620.i.i, align 8, !noalias !9
  %.458.1.i.i.i.i = or disjoint i64 %.457.i.i.i.i, 3
  %.460.1.i.i.i.i = sitofp i64 %.458.1.i.i.i.i to double
  %.461.1.i.i.i.i = fmul contract double %.169.i1.i.i.i, %.460.1.i.i.i.i
  store double %.461.1.i.i.i.i, ptr %sunkaddr105.i.i.i.i, align 8, !noalias !9
  %.458.2.i.i.i.i = or disjoint i64 %.457.i.i.i.i, 5
  %.460.2.i.i.i.i = sitofp i64 %.458.2.i.i.i.i to double
  %.461.2.i.i.i.i = fmul contract double %.169.i1.i.i.i, %.460.2.i.i.i.i
  store double %.461.2.i.i.i.i, ptr %sunkaddr106.i.i.i.i, align 8, !noalias !9
  %.458.3.i.i.i.i = or disjoint i64 %.457.i.i.i.i, 7
  %.460.3.i.i.i.i = sitofp i64 %.458.3.i.i.i.i to double
  %.461.3.i.i.i.i = fmul contract double %.169.i1.i.i.i, %.460.3.i.i.i.i
  store double %.461.3.i.i.i.i, ptr %sunkaddr107.i.i.i.i, align 8, !noalias !9
  %.458.4.i.i.i.i = or disjoint i64 %.457.i.i.i.i, 9
  %.460.4.i.i.i.i = sitofp i64 %.458.4.i.i.i.i to double
  %.461.4.i.i.i.i = fmul contract double %.169.i1.i.i.i, %.460.4.i.i.i.i
  store double %.461.4.i.i.i.i, ptr %sunkaddr108.i.i.i.i, align 8, !noalias !9
  %.458.5.i.i.i.i = or disjoint i64 %.457.i.i.i.i, 11
  %.460.5.i.i.i.i = sitofp i64 %.458.5.i.i.i.i to double
  %.461.5.i.i.i.i = fmul contract double %.169.i1.i.i.i, %.460.5.i.i.i.i
  store double %.461.5.i.i.i.i, ptr %sunkaddr109.i.i.i.i, align 8, !noalias !9
  %.458.6.i.i.i.i = or disjoint i64 %.457.i.i.i.i, 13
  %.460.6.i.i.i.i = sitofp i64 %.458.6.i.i.i.i to double
  %.461.6.i.i.i.i = fmul contract double %.169.i1.i.i.i, %.460.6.i.i.i.i
  store double %.461.6.i.i.i.i, ptr %sunkaddr110.i.i.i.i, align 8, !noalias !9
  %.458.7.i.i.i.i = or disjoint i64 %.457.i.i.i.i, 15
  %.460.7.i.i.i.i = sitofp i64 %.458.7.i.i.i.i to double
  %.461.7.i.i.i.i = fmul contract double %.169.i1.i.i.i, %.460.7.i.i.i.i
  store double %.461.7.i.i.i.i, ptr %sunkaddr111.i.i.i.i, align 8, !noalias !9
  %.66.i3.i.i.i.i = load <8 x double>, ptr %.1620.i.i, align 8, !noalias !17
  %.71.i4.i.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.66.i3.i.i.i.i, <8 x double> splat (double 0x3FE45F306DC9C883), <8 x double> splat (double 0x4338000000000000))
  %.8.i.i5.i.i.i.i = fadd contract <8 x double> %.71.i4.i.i.i.i, splat (double 0xC338000000000000)
  %.114.i6.i.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i.i5.i.i.i.i, <8 x double> splat (double 0xBFF921FB54442D18), <8 x double> %.66.i3.i.i.i.i)
  %.131.i7.i.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i.i5.i.i.i.i, <8 x double> splat (double 0xBC91A62633145C07), <8 x double> %.114.i6.i.i.i.i)
  %.6.i.i8.i.i.i.i = fmul contract <8 x double> %.131.i7.i.i.i.i, %.131.i7.i.i.i.i
  %.6.i20.i9.i.i.i.i = fmul contract <8 x double> %.131.i7.i.i.i.i, %.6.i.i8.i.i.i.i
  %.160.i10.i.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i8.i.i.i.i, <8 x double> splat (double 0xBD6AE7F3E733B81F), <8 x double> splat (double 0x3DE6124613A86D09))
  %.163.i11.i.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i8.i.i.i.i, <8 x double> %.160.i10.i.i.i.i, <8 x double> splat (double 0xBE5AE64567F544E4))
  %.166.i12.i.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i8.i.i.i.i, <8 x double> %.163.i11.i.i.i.i, <8 x double> splat (double 0x3EC71DE3A556C734))
  %.169.i13.i.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i8.i.i.i.i, <8 x double> %.166.i12.i.i.i.i, <8 x double> splat (double 0xBF2A01A01A01A01A))
  %.172.i14.i.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i8.i.i.i.i, <8 x double> %.169.i13.i.i.i.i, <8 x double> splat (double 0x3F81111111111111))
  %.175.i15.i.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i8.i.i.i.i, <8 x double> %.172.i14.i.i.i.i, <8 x double> splat (double 0xBFC5555555555555))
  %.200.i16.i.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i20.i9.i.i.i.i, <8 x double> %.175.i15.i.i.i.i, <8 x double> %.131.i7.i.i.i.i)
  %.205.i17.i.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i8.i.i.i.i, <8 x double> splat (double 0x3D2AE7F3E733B81F), <8 x double> splat (double 0xBDA93974A8C07C9D))
  %.208.i18.i.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i8.i.i.i.i, <8 x double> %.205.i17.i.i.i.i, <8 x double> splat (double 0x3E21EED8EFF8D898))
  %.211.i19.i.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i8.i.i.i.i, <8 x double> %.208.i18.i.i.i.i, <8 x double> splat (double 0xBE927E4FB7789F5C))
  %.214.i20.i.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i8.i.i.i.i, <8 x double> %.211.i19.i.i.i.i, <8 x double> splat (double 0x3EFA01A01A01A01A))
  %.217.i21.i.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i8.i.i.i.i, <8 x double> %.214.i20.i.i.i.i, <8 x double> splat (double 0xBF56C16C16C16C17))
  %.220.i22.i.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i8.i.i.i.i, <8 x double> %.217.i21.i.i.i.i, <8 x double> splat (double 0x3FA5555555555555))
  %.223.i23.i.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i8.i.i.i.i, <8 x double> %.220.i22.i.i.i.i, <8 x double> splat (double -5.000000e-01))
  %.226.i24.i.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i8.i.i.i.i, <8 x double> %.223.i23.i.i.i.i, <8 x double> splat (double 1.000000e+00))
  %.227.i25.i.i.i.i = bitcast <8 x double> %.71.i4.i.i.i.i to <8 x i64>
  %.228.i26.i.i.i.i = bitcast <8 x double> %.200.i16.i.i.i.i to <8 x i64>
  %.229.i27.i.i.i.i = bitcast <8 x double> %.226.i24.i.i.i.i to <8 x i64>
  %.6.i21.i28.i.i.i.i = xor <8 x i64> %.229.i27.i.i.i.i, %.228.i26.i.i.i.i
  %.8.i22.i29.i.i.i.i = and <8 x i64> %.227.i25.i.i.i.i, splat (i64 1)
  %43 = icmp eq <8 x i64> %.8.i22.i29.i.i.i.i, zeroinitializer
  %.6.i24.i30.i.i.i.i = select <8 x i1> %43, <8 x i64> zeroinitializer, <8 x i64> %.6.i21.i28.i.i.i.i
  %.8.i25.i31.i.i.i.i = shl <8 x i64> %.227.i25.i.i.i.i, splat (i64 62)
  %.8.i26.i32.i.i.i.i = and <8 x i64> %.8.i25.i31.i.i.i.i, splat (i64 -9223372036854775808)
  %.8.i28.i33.i.i.i.i = add <8 x i64> %.8.i25.i31.i.i.i.i, splat (i64 4611686018427387904)
  %.8.i29.i34.i.i.i.i = and <8 x i64> %.8.i28.i33.i.i.i.i, splat (i64 -9223372036854775808)
  %44 = xor <8 x i64> %.8.i26.i32.i.i.i.i, %.228.i26.i.i.i.i
  %.6.i31.i35.i.i.i.i = xor <8 x i64> %44, %.6.i24.i30.i.i.i.i
  %45 = bitcast <8 x i64> %.6.i31.i35.i.i.i.i to <8 x double>
  %46 = xor <8 x i64> %.8.i29.i34.i.i.i.i, %.229.i27.i.i.i.i
  %.6.i33.i36.i.i.i.i = xor <8 x i64> %46, %.6.i24.i30.i.i.i.i
  %47 = bitcast <8 x i64> %.6.i33.i36.i.i.i.i to <8 x double>
  store <8 x i64> %.6.i33.i36.i.i.i.i, ptr %sunkaddr112.i.i.i.i, align 8, !noalias !17
  store <8 x i64> %.6.i31.i35.i.i.i.i, ptr %sunkaddr113.i.i.i.i, align 8, !noalias !17
  br i1 %.711.i.i, label %_ZN17bnserve_inference15marginal_kernel7_circle10_at_phasesB3v30B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedExd8UniTupleIdLi3EEdd.exit151.i.i.i.i, label %B356.if.i43.i.i.i.i

B904.loopexit.i97.i.i.i.i:                        ; preds = %B356.if.i43.i.i.i.i
  %48 = tail call <8 x double> @llvm.fabs.v8f64(<8 x double> %.864.i82.i.i.i.i)
  %49 = tail call <8 x double> @llvm.fabs.v8f64(<8 x double> %.879.i90.i.i.i.i)
  br label %_ZN17bnserve_inference15marginal_kernel7_circle10_at_phasesB3v30B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedExd8UniTupleIdLi3EEdd.exit151.i.i.i.i

B356.if.i43.i.i.i.i:                              ; preds = %B230.if.i.i.i.i, %B356.if.i43.i.i.i.i
  %dn.2.0318.i44.i.i.i.i = phi <8 x double> [ %.879.i90.i.i.i.i, %B356.if.i43.i.i.i.i ], [ zeroinitializer, %B230.if.i.i.i.i ]
  %dx.2.0317.i45.i.i.i.i = phi <8 x double> [ %.864.i82.i.i.i.i, %B356.if.i43.i.i.i.i ], [ zeroinitializer, %B230.if.i.i.i.i ]
  %n.3.0316.i46.i.i.i.i = phi <8 x double> [ %.849.i73.i.i.i.i, %B356.if.i43.i.i.i.i ], [ zeroinitializer, %B230.if.i.i.i.i ]
  %x.2.0315.i47.i.i.i.i = phi <8 x double> [ %.837.i66.i.i.i.i, %B356.if.i43.i.i.i.i ], [ zeroinitializer, %B230.if.i.i.i.i ]
  %real.2.0314.i48.i.i.i.i = phi <8 x double> [ %.934.i94.i.i.i.i, %B356.if.i43.i.i.i.i ], [ splat (double 1.000000e+00), %B230.if.i.i.i.i ]
  %imaginary.2.0313.i49.i.i.i.i = phi <8 x double> [ %.963.i95.i.i.i.i, %B356.if.i43.i.i.i.i ], [ zeroinitializer, %B230.if.i.i.i.i ]
  %.728307311.i50.i.i.i.i = phi i64 [ %.735.i51.i.i.i.i, %B356.if.i43.i.i.i.i ], [ 0, %B230.if.i.i.i.i ]
  %.735.i51.i.i.i.i = add nuw nsw i64 %.728307311.i50.i.i.i.i, 1
  %50 = shl i64 %.728307311.i50.i.i.i.i, 3
  %scevgep65.i52.i.i.i.i = getelementptr i8, ptr %1, i64 %50
  %.768.i53.i.i.i.i = load double, ptr %scevgep65.i52.i.i.i.i, align 8, !noalias !17
  %scevgep64.i54.i.i.i.i = getelementptr i8, ptr %20, i64 %50
  %.779.i55.i.i.i.i = load double, ptr %scevgep64.i54.i.i.i.i, align 8, !noalias !17
  %scevgep63.i56.i.i.i.i = getelementptr i8, ptr %21, i64 %50
  %.791.i57.i.i.i.i = load double, ptr %scevgep63.i56.i.i.i.i, align 8, !noalias !17
  %scevgep.i.i.i.i = getelementptr i8, ptr %22, i64 %50
  %.803.i59.i.i.i.i = load double, ptr %scevgep.i.i.i.i, align 8, !noalias !17
  %.828.i60.i.i.i.i = fneg contract double %.779.i55.i.i.i.i
  %.831.i61.i.i.i.i = insertelement <8 x double> poison, double %.828.i60.i.i.i.i, i64 0
  %.832.i62.i.i.i.i = shufflevector <8 x double> %.831.i61.i.i.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.833.i63.i.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %imaginary.2.0313.i49.i.i.i.i, <8 x double> %.832.i62.i.i.i.i, <8 x double> %x.2.0315.i47.i.i.i.i)
  %.835.i64.i.i.i.i = insertelement <8 x double> poison, double %.768.i53.i.i.i.i, i64 0
  %.836.i65.i.i.i.i = shufflevector <8 x double> %.835.i64.i.i.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.837.i66.i.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %real.2.0314.i48.i.i.i.i, <8 x double> %.836.i65.i.i.i.i, <8 x double> %.833.i63.i.i.i.i)
  %.840.i67.i.i.i.i = fneg contract double %.803.i59.i.i.i.i
  %.843.i68.i.i.i.i = insertelement <8 x double> poison, double %.840.i67.i.i.i.i, i64 0
  %.844.i69.i.i.i.i = shufflevector <8 x double> %.843.i68.i.i.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.845.i70.i.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %imaginary.2.0313.i49.i.i.i.i, <8 x double> %.844.i69.i.i.i.i, <8 x double> %n.3.0316.i46.i.i.i.i)
  %.847.i71.i.i.i.i = insertelement <8 x double> poison, double %.791.i57.i.i.i.i, i64 0
  %.848.i72.i.i.i.i = shufflevector <8 x double> %.847.i71.i.i.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.849.i73.i.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %real.2.0314.i48.i.i.i.i, <8 x double> %.848.i72.i.i.i.i, <8 x double> %.845.i70.i.i.i.i)
  %.852.i74.i.i.i.i = uitofp nneg i64 %.728307311.i50.i.i.i.i to double
  %.853.i75.i.i.i.i = fmul contract double %.779.i55.i.i.i.i, %.852.i74.i.i.i.i
  %.855.i76.i.i.i.i = fmul contract double %.768.i53.i.i.i.i, %.852.i74.i.i.i.i
  %.858.i77.i.i.i.i = insertelement <8 x double> poison, double %.855.i76.i.i.i.i, i64 0
  %.859.i78.i.i.i.i = shufflevector <8 x double> %.858.i77.i.i.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.860.i79.i.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %imaginary.2.0313.i49.i.i.i.i, <8 x double> %.859.i78.i.i.i.i, <8 x double> %dx.2.0317.i45.i.i.i.i)
  %.862.i80.i.i.i.i = insertelement <8 x double> poison, double %.853.i75.i.i.i.i, i64 0
  %.863.i81.i.i.i.i = shufflevector <8 x double> %.862.i80.i.i.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.864.i82.i.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %real.2.0314.i48.i.i.i.i, <8 x double> %.863.i81.i.i.i.i, <8 x double> %.860.i79.i.i.i.i)
  %.868.i83.i.i.i.i = fmul contract double %.803.i59.i.i.i.i, %.852.i74.i.i.i.i
  %.870.i84.i.i.i.i = fmul contract double %.791.i57.i.i.i.i, %.852.i74.i.i.i.i
  %.873.i85.i.i.i.i = insertelement <8 x double> poison, double %.870.i84.i.i.i.i, i64 0
  %.874.i86.i.i.i.i = shufflevector <8 x double> %.873.i85.i.i.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.875.i87.i.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %imaginary.2.0313.i49.i.i.i.i, <8 x double> %.874.i86.i.i.i.i, <8 x double> %dn.2.0318.i44.i.i.i.i)
  %.877.i88.i.i.i.i = insertelement <8 x double> poison, double %.868.i83.i.i.i.i, i64 0
  %.878.i89.i.i.i.i = shufflevector <8 x double> %.877.i88.i.i.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.879.i90.i.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %real.2.0314.i48.i.i.i.i, <8 x double> %.878.i89.i.i.i.i, <8 x double> %.875.i87.i.i.i.i)
  %.6.i34.i91.i.i.i.i = fmul contract <8 x double> %imaginary.2.0313.i49.i.i.i.i, %45
  %.8.i35.i92.i.i.i.i = fsub contract <8 x double> zeroinitializer, %.6.i34.i91.i.i.i.i
  %.6.i36.i93.i.i.i.i = fmul contract <8 x double> %imaginary.2.0313.i49.i.i.i.i, %47
  %.934.i94.i.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %real.2.0314.i48.i.i.i.i, <8 x double> %47, <8 x double> %.8.i35.i92.i.i.i.i)
  %.963.i95.i.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %real.2.0314.i48.i.i.i.i, <8 x double> %45, <8 x double> %.6.i36.i93.i.i.i.i)
  %exitcond.not.i96.i.i.i.i = icmp eq i64 %.13.i.i.i, %.728307311.i50.i.i.i.i
  br i1 %exitcond.not.i96.i.i.i.i, label %B904.loopexit.i97.i.i.i.i, label %B356.if.i43.i.i.i.i

_ZN17bnserve_inference15marginal_kernel7_circle10_at_phasesB3v30B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedExd8UniTupleIdLi3EEdd.exit151.i.i.i.i: ; preds = %B904.loopexit.i97.i.i.i.i, %B230.if.i.i.i.i
  %x.2.0.lcssa.i98.i.i.i.i = phi <8 x double> [ zeroinitializer, %B230.if.i.i.i.i ], [ %.837.i66.i.i.i.i, %B904.loopexit.i97.i.i.i.i ]
  %n.3.0.lcssa.i99.i.i.i.i = phi <8 x double> [ zeroinitializer, %B230.if.i.i.i.i ], [ %.849.i73.i.i.i.i, %B904.loopexit.i97.i.i.i.i ]
  %51 = phi <8 x double> [ zeroinitializer, %B230.if.i.i.i.i ], [ %48, %B904.loopexit.i97.i.i.i.i ]
  %52 = phi <8 x double> [ zeroinitializer, %B230.if.i.i.i.i ], [ %49, %B904.loopexit.i97.i.i.i.i ]
  %.8.i19.i100.i.i.i.i = fsub contract <8 x double> zeroinitializer, %n.3.0.lcssa.i99.i.i.i.i
  %.1023.i106.i.i.i.i = tail call <8 x double> @llvm.minnum.v8f64(<8 x double> %.8.i19.i100.i.i.i.i, <8 x double> %.1022.i105.i.i.i.i)
  %.8.i37.i107.i.i.i.i = fsub contract <8 x double> zeroinitializer, %.1023.i106.i.i.i.i
  store <8 x double> %x.2.0.lcssa.i98.i.i.i.i, ptr %sunkaddr114.i.i.i.i, align 8, !noalias !17
  store <8 x double> %.8.i37.i107.i.i.i.i, ptr %sunkaddr115.i.i.i.i, align 8, !noalias !17
  %.6.i38.i110.i.i.i.i = fdiv contract <8 x double> %x.2.0.lcssa.i98.i.i.i.i, %.8.i37.i107.i.i.i.i
  store <8 x double> %.6.i38.i110.i.i.i.i, ptr %sunkaddr116.i.i.i.i, align 8, !noalias !17
  %.1108.i112.i.i.i.i = tail call <8 x double> @llvm.sqrt.v8f64(<8 x double> %.8.i37.i107.i.i.i.i)
  %.8.i39.i113.i.i.i.i = fdiv contract <8 x double> splat (double 1.000000e+00), %.1108.i112.i.i.i.i
  store <8 x double> %.8.i39.i113.i.i.i.i, ptr %sunkaddr117.i.i.i.i, align 8, !noalias !17
  %.8.i41.i115.i.i.i.i = fsub contract <8 x double> zeroinitializer, %.6.i38.i110.i.i.i.i
  %.1200.i119.i.i.i.i = tail call <8 x double> @llvm.minnum.v8f64(<8 x double> %.8.i41.i115.i.i.i.i, <8 x double> %.1199.i118.i.i.i.i)
  %.8.i42.i120.i.i.i.i = fsub contract <8 x double> zeroinitializer, %.1200.i119.i.i.i.i
  %.1227.i123.i.i.i.i = tail call <8 x double> @llvm.minnum.v8f64(<8 x double> %.8.i42.i120.i.i.i.i, <8 x double> %.1226.i122.i.i.i.i)
  %.8.i43.i124.i.i.i.i = fmul contract <8 x double> %.1227.i123.i.i.i.i, splat (double 5.000000e-01)
  %.6.i44.i125.i.i.i.i = fmul contract <8 x double> %.8.i37.i107.i.i.i.i, %.8.i43.i124.i.i.i.i
  %.6.i45.i126.i.i.i.i = fsub contract <8 x double> %x.2.0.lcssa.i98.i.i.i.i, %.6.i44.i125.i.i.i.i
  %.6.i46.i127.i.i.i.i = fmul contract <8 x double> %.1227.i123.i.i.i.i, %.6.i45.i126.i.i.i.i
  store <8 x double> %.6.i46.i127.i.i.i.i, ptr %sunkaddr118.i.i.i.i, align 8, !noalias !17
  %.1368.i129.i.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %51, <8 x double> %.1367.i.i.i.i.i, <8 x double> %x.2.0.lcssa.i98.i.i.i.i)
  %.8.i49.i133.i.i.i.i = fadd contract <8 x double> %.7.i.i132.i.i.i.i, %.1368.i129.i.i.i.i
  %.1437.i134.i.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %52, <8 x double> %.1436.i.i.i.i.i, <8 x double> %.8.i37.i107.i.i.i.i)
  %53 = fsub contract <8 x double> %.7.i52.i137.i.i.i.i, %.1437.i134.i.i.i.i
  %.8.i54.i138.i.i.i.i = fadd contract <8 x double> %53, zeroinitializer
  %.1503.i139.i.i.i.i = tail call <8 x double> @llvm.minnum.v8f64(<8 x double> %.8.i54.i138.i.i.i.i, <8 x double> %.1022.i105.i.i.i.i)
  %.8.i55.i140.i.i.i.i = fsub contract <8 x double> zeroinitializer, %.1503.i139.i.i.i.i
  %.6.i56.i141.i.i.i.i = fdiv contract <8 x double> %.8.i49.i133.i.i.i.i, %.8.i55.i140.i.i.i.i
  %.8.i57.i142.i.i.i.i = fsub contract <8 x double> zeroinitializer, %.6.i56.i141.i.i.i.i
  %.1588.i143.i.i.i.i = tail call <8 x double> @llvm.minnum.v8f64(<8 x double> %.8.i57.i142.i.i.i.i, <8 x double> %.1199.i118.i.i.i.i)
  %.8.i58.i144.i.i.i.i = fsub contract <8 x double> zeroinitializer, %.1588.i143.i.i.i.i
  %.1615.i145.i.i.i.i = tail call <8 x double> @llvm.minnum.v8f64(<8 x double> %.8.i58.i144.i.i.i.i, <8 x double> %.1226.i122.i.i.i.i)
  %.8.i59.i146.i.i.i.i = fmul contract <8 x double> %.1615.i145.i.i.i.i, splat (double 5.000000e-01)
  %.6.i60.i147.i.i.i.i = fmul contract <8 x double> %.8.i55.i140.i.i.i.i, %.8.i59.i146.i.i.i.i
  %.6.i61.i148.i.i.i.i = fsub contract <8 x double> %.8.i49.i133.i.i.i.i, %.6.i60.i147.i.i.i.i
  %.6.i62.i149.i.i.i.i = fmul contract <8 x double> %.1615.i145.i.i.i.i, %.6.i61.i148.i.i.i.i
  store <8 x double> %.6.i62.i149.i.i.i.i, ptr %sunkaddr119.i.i.i.i, align 8, !noalias !17
  %.736.i.i.i.i = load double, ptr %sunkaddr118.i.i.i.i, align 8, !noalias !9
  %.738.i.i.i.i = fcmp contract ogt double %.736.i.i.i.i, %best.5.0518.i.i.i.i
  br i1 %.738.i.i.i.i, label %B456.i.i.i.i, label %B616.i.i.i.i

B1060.endif.i.i.i.i:                              ; preds = %B1022.i.i.i.i
  %.1214.i.i.i.i = fmul contract double %steps.3.0.i.i.i.i, 1.250000e-01
  %.1224.le.i.i.i.i = tail call contract double @llvm.ceil.f64(double %.1214.i.i.i.i)
  %.5.i.i.i.i.i = fptosi double %.1224.le.i.i.i.i to i64
  %.1253.i.i.i.i = shl nsw i64 %.5.i.i.i.i.i, 3
  br label %B1158.i.i.i.i

B1228.if.i.i.i.i:                                 ; preds = %B1228.if.prol.loopexit.i.i.i.i
  %.1394.i.i.i.i = fmul contract double %finest.2.0538.unr.i.i.i.i, 5.000000e-01
  %.1394.1.i.i.i.i = fmul contract double %.1394.i.i.i.i, 5.000000e-01
  %.1394.2.i.i.i.i = fmul contract double %.1394.1.i.i.i.i, 5.000000e-01
  %.1394.3.i.i.i.i = fmul contract double %.1394.2.i.i.i.i, 5.000000e-01
  %.1394.4.i.i.i.i = fmul contract double %.1394.3.i.i.i.i, 5.000000e-01
  %.1394.5.i.i.i.i = fmul contract double %.1394.4.i.i.i.i, 5.000000e-01
  %.1394.6.i.i.i.i = fmul contract double %.1394.5.i.i.i.i, 5.000000e-01
  %.1394.7.i.i.i.i = fmul contract double %.1394.6.i.i.i.i, 5.000000e-01
  %.1355.7.i.i.i.i = icmp sgt i64 %.1354533537.unr.i.i.i.i, 8
  br i1 %.1355.7.i.i.i.i, label %B1228.if.1.i.i.i.i, label %B1244.i.i.i.i

B1228.if.1.i.i.i.i:                               ; preds = %B1228.if.i.i.i.i
  %.1394.11.i.i.i.i = fmul contract double %.1394.7.i.i.i.i, 5.000000e-01
  %.1394.1.1.i.i.i.i = fmul contract double %.1394.11.i.i.i.i, 5.000000e-01
  %.1394.2.1.i.i.i.i = fmul contract double %.1394.1.1.i.i.i.i, 5.000000e-01
  %.1394.3.1.i.i.i.i = fmul contract double %.1394.2.1.i.i.i.i, 5.000000e-01
  %.1394.4.1.i.i.i.i = fmul contract double %.1394.3.1.i.i.i.i, 5.000000e-01
  %.1394.5.1.i.i.i.i = fmul contract double %.1394.4.1.i.i.i.i, 5.000000e-01
  %.1394.6.1.i.i.i.i = fmul contract double %.1394.5.1.i.i.i.i, 5.000000e-01
  %.1394.7.1.i.i.i.i = fmul contract double %.1394.6.1.i.i.i.i, 5.000000e-01
  %.1355.7.1.i.i.i.i = icmp sgt i64 %.1354533537.unr.i.i.i.i, 16
  br i1 %.1355.7.1.i.i.i.i, label %B1228.if.2.i.i.i.i, label %B1244.i.i.i.i

B1228.if.2.i.i.i.i:                               ; preds = %B1228.if.1.i.i.i.i
  %.1394.22.i.i.i.i = fmul contract double %.1394.7.1.i.i.i.i, 5.000000e-01
  %.1394.1.2.i.i.i.i = fmul contract double %.1394.22.i.i.i.i, 5.000000e-01
  %.1394.2.2.i.i.i.i = fmul contract double %.1394.1.2.i.i.i.i, 5.000000e-01
  %.1394.3.2.i.i.i.i = fmul contract double %.1394.2.2.i.i.i.i, 5.000000e-01
  %.1394.4.2.i.i.i.i = fmul contract double %.1394.3.2.i.i.i.i, 5.000000e-01
  %.1394.5.2.i.i.i.i = fmul contract double %.1394.4.2.i.i.i.i, 5.000000e-01
  %.1394.6.2.i.i.i.i = fmul contract double %.1394.5.2.i.i.i.i, 5.000000e-01
  %.1394.7.2.i.i.i.i = fmul contract double %.1394.6.2.i.i.i.i, 5.000000e-01
  br label %B1244.i.i.i.i

_ZN17bnserve_inference15marginal_kernel7_circle7_surveyB3v29B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedExx8UniTupleIdLi3EEd5ArrayIdLi1E1C7mutable7alignedE.exit.i.i.i: ; preds = %B1564.i.i.i.i, %B1244.i.i.i.i
  %best.9.1.i.i.i.i = phi double [ %best.5.0.lcssa.i.i.i.i, %B1244.i.i.i.i ], [ %best.7.2.7.i.i.i.i, %B1564.i.i.i.i ]
  store double 0xFFF0000000000000, ptr %.148.i.i.i, align 8, !noalias !6
  %.780.i.i.i = getelementptr i8, ptr %.1620.i.i, i64 584
  store double 0.000000e+00, ptr %.780.i.i.i, align 8, !noalias !6
  %54 = add nuw i64 %cells.2.0.i.i.i.i, 7
  %.859.i.i.i = lshr i64 %54, 3
  %.838.inv.i.i.i = icmp slt i64 %cells.2.0.i.i.i.i, 1
  %.8802207.not2235.i.i.i = icmp eq i64 %.859.i.i.i, 0
  %.8802207.not.i.i.i = select i1 %.838.inv.i.i.i, i1 true, i1 %.8802207.not2235.i.i.i
  br i1 %.8802207.not.i.i.i, label %B2972.i.i.i, label %B758.if.lr.ph.i.i.i

B900.i.i.i:                                       ; preds = %B900.outer.i.i.i, %_ZN17bnserve_inference15marginal_kernel7_circle7_halvedB3v57B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedEdx5ArrayIdLi1E1C7mutable7alignedEx.exit.i.i.i
  %best.3.2.i.i.i = phi double [ %best.2.4.lcssa.i.i.i, %_ZN17bnserve_inference15marginal_kernel7_circle7_halvedB3v57B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedEdx5ArrayIdLi1E1C7mutable7alignedEx.exit.i.i.i ], [ %best.3.2.ph.i.i.i, %B900.outer.i.i.i ]
  %waiting.4.2.i.i.i = phi i64 [ %waiting.3.1.1.i.i.i.i, %_ZN17bnserve_inference15marginal_kernel7_circle7_halvedB3v57B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedEdx5ArrayIdLi1E1C7mutable7alignedEx.exit.i.i.i ], [ %waiting.4.2.ph.i.i.i, %B900.outer.i.i.i ]
  %.1211.i.i.i = add nsw i64 %waiting.4.2.i.i.i, -1
  %.1232.idx.i.i.i = mul nsw i64 %.1211.i.i.i, 80
  %.1232.i.i.i = getelementptr inbounds i8, ptr %.447.i.i.i, i64 %.1232.idx.i.i.i
  %.1317.i.i.i = getelementptr i8, ptr %.1232.i.i.i, i64 64
  %.1318.i.i.i = load double, ptr %.1317.i.i.i, align 8, !noalias !6
  %.5.i.i.i.i = fptosi double %.1318.i.i.i to i64
  %.1372.i.i.i = getelementptr i8, ptr %.1232.i.i.i, i64 72
  %.1373.i.i.i = load double, ptr %.1372.i.i.i, align 8, !noalias !6
  %.5.i98.i.i.i = fptosi double %.1373.i.i.i to i64
  %.14931895.not.i.i.i = icmp slt i64 %.5.i98.i.i.i, 1
  br i1 %.14931895.not.i.i.i, label %B1208.if.i.i.i, label %B1152.if.preheader.i.i.i

B1152.if.preheader.i.i.i:                         ; preds = %B900.i.i.i
  %xtraiter.i.i.i = and i64 %.5.i98.i.i.i, 7
  %55 = icmp ult i64 %.5.i98.i.i.i, 8
  br i1 %55, label %B1152.if.epil.i.i.i.preheader, label %B1152.if.preheader.new.i.i.i

B1152.if.preheader.new.i.i.i:                     ; preds = %B1152.if.preheader.i.i.i
  %56 = add nsw i64 %.5.i98.i.i.i, -8
  %57 = icmp ult i64 %56, 8
  br i1 %57, label %B1208.if.loopexit.unr-lcssa.i.i.i, label %B1152.if.preheader147.i.i.i

B1152.if.preheader147.i.i.i:                      ; preds = %B1152.if.preheader.new.i.i.i
  %58 = and i64 %56, 8
  %lcmp.mod.not123.not.i.i.i = icmp eq i64 %58, 0
  %half.2.41898.unr.i.i.i = select i1 %lcmp.mod.not123.not.i.i.i, double %.1532.7.prol.i.i.i, double %.1409.i.i.i
  %unroll_iter.i.i.i = and i64 %.5.i98.i.i.i, 9223372036854775800
  %lsr.iv.next.prol.i.i.i = add nsw i64 %unroll_iter.i.i.i, -8
  %lsr.iv.unr.i.i.i = select i1 %lcmp.mod.not123.not.i.i.i, i64 %lsr.iv.next.prol.i.i.i, i64 %unroll_iter.i.i.i
  br label %B1152.if.i.i.i

B1400.loopexit.unr-lcssa.i.i.i:                   ; preds = %B1326.if.i.i.i
  %lcmp.mod267.not.i.i.i = icmp eq i64 %xtraiter265.i.i.i, 0
  br i1 %lcmp.mod267.not.i.i.i, label %B1400.i.i.i, label %B1326.if.epil.preheader.i.i.i

B1326.if.epil.preheader.i.i.i:                    ; preds = %B1326.if.preheader.i.i.i, %B1400.loopexit.unr-lcssa.i.i.i
  %best.2.41914.epil.init.i.i.i = phi double [ %best.3.2.i.i.i, %B1326.if.preheader.i.i.i ], [ %.1927.best.2.4.3.i.i.i, %B1400.loopexit.unr-lcssa.i.i.i ]
  %.186419101912.epil.init.i.i.i = phi i64 [ 0, %B1326.if.preheader.i.i.i ], [ %unroll_iter270.i.i.i, %B1400.loopexit.unr-lcssa.i.i.i ]
  %59 = shl i64 %.186419101912.epil.init.i.i.i, 3
  %scevgep307.i.i.i = getelementptr i8, ptr %scevgep306.i.i.i, i64 %59
  br label %B1326.if.epil.i.i.i

B1326.if.epil.i.i.i:                              ; preds = %B1326.if.epil.i.i.i, %B1326.if.epil.preheader.i.i.i
  %best.2.41914.epil.i.i.i = phi double [ %.1927.best.2.4.epil.i.i.i, %B1326.if.epil.i.i.i ], [ %best.2.41914.epil.init.i.i.i, %B1326.if.epil.preheader.i.i.i ]
  %epil.iter266.i.i.i = phi i64 [ %epil.iter266.next.i.i.i, %B1326.if.epil.i.i.i ], [ 0, %B1326.if.epil.preheader.i.i.i ]
  %60 = shl i64 %epil.iter266.i.i.i, 3
  %scevgep157.i.i.i = getelementptr i8, ptr %scevgep307.i.i.i, i64 %60
  %.1927.epil.i.i.i = load double, ptr %scevgep157.i.i.i, align 8, !noalias !6
  %.1933.epil.i.i.i = fcmp contract ogt double %.1927.epil.i.i.i, %best.2.41914.epil.i.i.i
  %.1927.best.2.4.epil.i.i.i = select i1 %.1933.epil.i.i.i, double %.1927.epil.i.i.i, double %best.2.41914.epil.i.i.i
  %epil.iter266.next.i.i.i = add i64 %epil.iter266.i.i.i, 1
  %epil.iter266.cmp.not.i.i.i = icmp eq i64 %xtraiter265.i.i.i, %epil.iter266.next.i.i.i
  br i1 %epil.iter266.cmp.not.i.i.i, label %B1400.i.i.i, label %B1326.if.epil.i.i.i, !llvm.loop !20

B1400.i.i.i:                                      ; preds = %B1326.if.epil.i.i.i, %_ZN17bnserve_inference15marginal_kernel7_circle10_at_phasesB3v30B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedExd8UniTupleIdLi3EEdd.exit.i.i.i, %B1400.loopexit.unr-lcssa.i.i.i
  %best.2.4.lcssa.i.i.i = phi double [ %best.3.2.i.i.i, %_ZN17bnserve_inference15marginal_kernel7_circle10_at_phasesB3v30B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedExd8UniTupleIdLi3EEdd.exit.i.i.i ], [ %.1927.best.2.4.3.i.i.i, %B1400.loopexit.unr-lcssa.i.i.i ], [ %.1927.best.2.4.epil.i.i.i, %B1326.if.epil.i.i.i ]
  %.1964.i.i.i = icmp sgt i64 %halvings.3.0.i.i.i.i, %.5.i98.i.i.i
  br i1 %.1964.i.i.i, label %B1412.i.i.i, label %B1460.i.i.i

B1412.i.i.i:                                      ; preds = %B1400.i.i.i
  %.1984.i.i.i = fsub contract double %best.2.4.lcssa.i.i.i, %.593.i.i.i
  %.214.i5.i.i.i = load double, ptr %.1372.i.i.i, align 8, !noalias !21
  %.215.i.i.i.i = fadd contract double %.214.i5.i.i.i, 1.000000e+00
  %.301472.not.i.i.i.i = icmp slt i64 %.5.i.i.i.i, 1
  br i1 %.301472.not.i.i.i.i, label %_ZN17bnserve_inference15marginal_kernel7_circle7_halvedB3v57B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedEdx5ArrayIdLi1E1C7mutable7alignedEx.exit.i.i.i, label %B230.if.preheader.i6.i.i.i

B230.if.preheader.i6.i.i.i:                       ; preds = %B1412.i.i.i
  %61 = icmp eq i64 %.5.i.i.i.i, 1
  br i1 %61, label %B230.if.epil.preheader.i.i.i.i, label %B230.if.preheader.new.i.i.i.i

B230.if.preheader.new.i.i.i.i:                    ; preds = %B230.if.preheader.i6.i.i.i
  %unroll_iter.i.i.i.i = and i64 %.5.i.i.i.i, 9223372036854775806
  %scevgep46.i.i.i.i = getelementptr i8, ptr %.1232.i.i.i, i64 8
  br label %B230.if.i7.i.i.i

B290.i.i.i.i:                                     ; preds = %B230.if.i7.i.i.i
  %scevgep3.i.i.i.i = getelementptr i8, ptr %scevgep46.i.i.i.i, i64 %sunkaddr23.i.i.i.i
  %scevgep4.i.i.i.i = getelementptr i8, ptr %scevgep3.i.i.i.i, i64 -8
  %.412.i.i.i.i = load double, ptr %scevgep4.i.i.i.i, align 8, !noalias !21
  %.415.i.i.i.i = fmul contract double %.412.i.i.i.i, 2.000000e+00
  %62 = lshr i64 %kept.2.0475.i.i.i.i, 60
  %.431.i.i.i.i = and i64 %62, 8
  %63 = getelementptr double, ptr %.53.i.i.i.i, i64 %kept.2.0475.i.i.i.i
  %.445.i.i.i.i = getelementptr double, ptr %63, i64 %.431.i.i.i.i
  store double %.415.i.i.i.i, ptr %.445.i.i.i.i, align 8, !noalias !21
  %.448.i.i.i.i = add nsw i64 %kept.2.0475.i.i.i.i, 1
  br label %B328.i.i.i.i

B328.i.i.i.i:                                     ; preds = %B230.if.i7.i.i.i, %B290.i.i.i.i
  %kept.3.1.i.i.i.i = phi i64 [ %.448.i.i.i.i, %B290.i.i.i.i ], [ %kept.2.0475.i.i.i.i, %B230.if.i7.i.i.i ]
  %.314.1.i.i.i.i = add nuw i64 %.307471473.i.i.i.i, 2
  %sunkaddr21.i.i.i.i = getelementptr i8, ptr %sunkaddr33.i.i.i.i, i64 520
  %.378.1.i.i.i.i = load double, ptr %sunkaddr21.i.i.i.i, align 8, !noalias !21
  %.380.1.i.i.i.i = fcmp contract ult double %.378.1.i.i.i.i, %.1984.i.i.i
  br i1 %.380.1.i.i.i.i, label %B328.1.i.i.i.i, label %B290.1.i.i.i.i

B290.1.i.i.i.i:                                   ; preds = %B328.i.i.i.i
  %scevgep5.i.i.i.i = getelementptr i8, ptr %scevgep46.i.i.i.i, i64 %sunkaddr23.i.i.i.i
  %.412.1.i.i.i.i = load double, ptr %scevgep5.i.i.i.i, align 8, !noalias !21
  %.415.1.i.i.i.i = fmul contract double %.412.1.i.i.i.i, 2.000000e+00
  %64 = lshr i64 %kept.3.1.i.i.i.i, 60
  %.431.1.i.i.i.i = and i64 %64, 8
  %65 = getelementptr double, ptr %.53.i.i.i.i, i64 %kept.3.1.i.i.i.i
  %.445.1.i.i.i.i = getelementptr double, ptr %65, i64 %.431.1.i.i.i.i
  store double %.415.1.i.i.i.i, ptr %.445.1.i.i.i.i, align 8, !noalias !21
  %.448.1.i.i.i.i = add nsw i64 %kept.3.1.i.i.i.i, 1
  br label %B328.1.i.i.i.i

B328.1.i.i.i.i:                                   ; preds = %B290.1.i.i.i.i, %B328.i.i.i.i
  %kept.3.1.1.i.i.i.i = phi i64 [ %.448.1.i.i.i.i, %B290.1.i.i.i.i ], [ %kept.3.1.i.i.i.i, %B328.i.i.i.i ]
  %niter.ncmp.1.i.i.i.i = icmp eq i64 %unroll_iter.i.i.i.i, %.314.1.i.i.i.i
  br i1 %niter.ncmp.1.i.i.i.i, label %B330.loopexit.unr-lcssa.i.i.i.i, label %B230.if.i7.i.i.i

B330.loopexit.unr-lcssa.i.i.i.i:                  ; preds = %B328.1.i.i.i.i
  %66 = and i64 %.5.i.i.i.i, 1
  %lcmp.mod.not.i8.i.i.i = icmp eq i64 %66, 0
  br i1 %lcmp.mod.not.i8.i.i.i, label %B354.if.i.i.i.i, label %B230.if.epil.preheader.i.i.i.i

B230.if.epil.preheader.i.i.i.i:                   ; preds = %B330.loopexit.unr-lcssa.i.i.i.i, %B230.if.preheader.i6.i.i.i
  %kept.2.0475.epil.init.i.i.i.i = phi i64 [ 0, %B230.if.preheader.i6.i.i.i ], [ %kept.3.1.1.i.i.i.i, %B330.loopexit.unr-lcssa.i.i.i.i ]
  %.307471473.epil.init.i.i.i.i = phi i64 [ 0, %B230.if.preheader.i6.i.i.i ], [ %.314.1.i.i.i.i, %B330.loopexit.unr-lcssa.i.i.i.i ]
  %67 = getelementptr double, ptr %.1620.i.i, i64 %.307471473.epil.init.i.i.i.i
  %68 = getelementptr i8, ptr %67, i64 512
  %.378.epil.i.i.i.i = load double, ptr %68, align 8, !noalias !21
  %.380.epil.i.i.i.i = fcmp contract ult double %.378.epil.i.i.i.i, %.1984.i.i.i
  br i1 %.380.epil.i.i.i.i, label %B354.if.i.i.i.i, label %B290.epil.i.i.i.i

B290.epil.i.i.i.i:                                ; preds = %B230.if.epil.preheader.i.i.i.i
  %69 = getelementptr double, ptr %.1232.i.i.i, i64 %.307471473.epil.init.i.i.i.i
  %.412.epil.i.i.i.i = load double, ptr %69, align 8, !noalias !21
  %.415.epil.i.i.i.i = fmul contract double %.412.epil.i.i.i.i, 2.000000e+00
  %70 = lshr i64 %kept.2.0475.epil.init.i.i.i.i, 60
  %.431.epil.i.i.i.i = and i64 %70, 8
  %71 = getelementptr double, ptr %.53.i.i.i.i, i64 %kept.2.0475.epil.init.i.i.i.i
  %.445.epil.i.i.i.i = getelementptr double, ptr %71, i64 %.431.epil.i.i.i.i
  store double %.415.epil.i.i.i.i, ptr %.445.epil.i.i.i.i, align 8, !noalias !21
  %.448.epil.i.i.i.i = add nsw i64 %kept.2.0475.epil.init.i.i.i.i, 1
  br label %B354.if.i.i.i.i

B684.i.i.i.i:                                     ; preds = %B354.if.i.i.i.i
  %.690.1.i.i.i.i = icmp sgt i64 %kept.2.0.lcssa.i.i.i.i, 0
  br i1 %.690.1.i.i.i.i, label %B536.if.1.i.i.i.i, label %_ZN17bnserve_inference15marginal_kernel7_circle7_halvedB3v57B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedEdx5ArrayIdLi1E1C7mutable7alignedEx.exit.i.i.i

B536.if.1.i.i.i.i:                                ; preds = %B684.thread.i.i.i.i, %B684.i.i.i.i
  %waiting.3.13.i.i.i.i = phi i64 [ %waiting.4.2.i.i.i, %B684.thread.i.i.i.i ], [ %.1211.i.i.i, %B684.i.i.i.i ]
  %.13.i.1.i.i.i.i = tail call i64 @llvm.smin.i64(i64 %kept.2.0.lcssa.i.i.i.i, i64 4)
  %.924.1.i.i.i.i = add nsw i64 %.13.i.1.i.i.i.i, -1
  %.709.idx.1.i.i.i.i = mul nsw i64 %waiting.3.13.i.i.i.i, 80
  %.709.1.i.i.i.i = getelementptr inbounds i8, ptr %.447.i.i.i, i64 %.709.idx.1.i.i.i.i
  %.984.11.i.i.i.i = load double, ptr %.53.i.i.i.i, align 8, !noalias !21
  %.1026.12.i.i.i.i = fadd contract double %.984.11.i.i.i.i, 0.000000e+00
  store double %.1026.12.i.i.i.i, ptr %.709.1.i.i.i.i, align 8, !noalias !21
  %.984.1.1.i.i.i.i = load double, ptr %.53.i.i.i.i, align 8, !noalias !21
  %.1026.1.1.i.i.i.i = fadd contract double %.984.1.1.i.i.i.i, 1.000000e+00
  %72 = getelementptr i8, ptr %.709.1.i.i.i.i, i64 8
  store double %.1026.1.1.i.i.i.i, ptr %72, align 8, !noalias !21
  %.13.i16.2.1.i.i.i.i = tail call i64 @llvm.smin.i64(i64 %.924.1.i.i.i.i, i64 1)
  %sunkaddr12.i.i.i.i = shl i64 %.13.i16.2.1.i.i.i.i, 3
  %sunkaddr13.i.i.i.i = getelementptr i8, ptr %.447.i.i.i, i64 %sunkaddr12.i.i.i.i
  %sunkaddr14.i.i.i.i = getelementptr i8, ptr %sunkaddr13.i.i.i.i, i64 2480
  %.984.2.1.i.i.i.i = load double, ptr %sunkaddr14.i.i.i.i, align 8, !noalias !21
  %.1026.2.1.i.i.i.i = fadd contract double %.984.2.1.i.i.i.i, 0.000000e+00
  %73 = getelementptr i8, ptr %.709.1.i.i.i.i, i64 16
  store double %.1026.2.1.i.i.i.i, ptr %73, align 8, !noalias !21
  %.984.3.1.i.i.i.i = load double, ptr %sunkaddr14.i.i.i.i, align 8, !noalias !21
  %.1026.3.1.i.i.i.i = fadd contract double %.984.3.1.i.i.i.i, 1.000000e+00
  %74 = getelementptr i8, ptr %.709.1.i.i.i.i, i64 24
  store double %.1026.3.1.i.i.i.i, ptr %74, align 8, !noalias !21
  %.13.i16.4.1.i.i.i.i = tail call i64 @llvm.smin.i64(i64 %.924.1.i.i.i.i, i64 2)
  %sunkaddr15.i.i.i.i = shl i64 %.13.i16.4.1.i.i.i.i, 3
  %sunkaddr16.i.i.i.i = getelementptr i8, ptr %.447.i.i.i, i64 %sunkaddr15.i.i.i.i
  %sunkaddr17.i.i.i.i = getelementptr i8, ptr %sunkaddr16.i.i.i.i, i64 2480
  %.984.4.1.i.i.i.i = load double, ptr %sunkaddr17.i.i.i.i, align 8, !noalias !21
  %.1026.4.1.i.i.i.i = fadd contract double %.984.4.1.i.i.i.i, 0.000000e+00
  %75 = getelementptr i8, ptr %.709.1.i.i.i.i, i64 32
  store double %.1026.4.1.i.i.i.i, ptr %75, align 8, !noalias !21
  %.984.5.1.i.i.i.i = load double, ptr %sunkaddr17.i.i.i.i, align 8, !noalias !21
  %.1026.5.1.i.i.i.i = fadd contract double %.984.5.1.i.i.i.i, 1.000000e+00
  %76 = getelementptr i8, ptr %.709.1.i.i.i.i, i64 40
  store double %.1026.5.1.i.i.i.i, ptr %76, align 8, !noalias !21
  %.13.i16.6.1.i.i.i.i = tail call i64 @llvm.smin.i64(i64 %.924.1.i.i.i.i, i64 3)
  %sunkaddr18.i.i.i.i = shl i64 %.13.i16.6.1.i.i.i.i, 3
  %sunkaddr19.i.i.i.i = getelementptr i8, ptr %.447.i.i.i, i64 %sunkaddr18.i.i.i.i
  %sunkaddr20.i.i.i.i = getelementptr i8, ptr %sunkaddr19.i.i.i.i, i64 2480
  %.984.6.1.i.i.i.i = load double, ptr %sunkaddr20.i.i.i.i, align 8, !noalias !21
  %.1026.6.1.i.i.i.i = fadd contract double %.984.6.1.i.i.i.i, 0.000000e+00
  %77 = getelementptr i8, ptr %.709.1.i.i.i.i, i64 48
  store double %.1026.6.1.i.i.i.i, ptr %77, align 8, !noalias !21
  %.984.7.1.i.i.i.i = load double, ptr %sunkaddr20.i.i.i.i, align 8, !noalias !21
  %.1026.7.1.i.i.i.i = fadd contract double %.984.7.1.i.i.i.i, 1.000000e+00
  %78 = getelementptr i8, ptr %.709.1.i.i.i.i, i64 56
  store double %.1026.7.1.i.i.i.i, ptr %78, align 8, !noalias !21
  %.1065.1.i.i.i.i = uitofp nneg i64 %.13.i.1.i.i.i.i to double
  %.1066.1.i.i.i.i = fmul contract double %.1065.1.i.i.i.i, 2.000000e+00
  %.1097.1.i.i.i.i = getelementptr i8, ptr %.709.1.i.i.i.i, i64 64
  store double %.1066.1.i.i.i.i, ptr %.1097.1.i.i.i.i, align 8, !noalias !21
  %.1129.1.i.i.i.i = getelementptr i8, ptr %.709.1.i.i.i.i, i64 72
  store double %.215.i.i.i.i, ptr %.1129.1.i.i.i.i, align 8, !noalias !21
  %.1137.1.i.i.i.i = add nsw i64 %waiting.3.13.i.i.i.i, 1
  br label %_ZN17bnserve_inference15marginal_kernel7_circle7_halvedB3v57B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedEdx5ArrayIdLi1E1C7mutable7alignedEx.exit.i.i.i

B230.if.i7.i.i.i:                                 ; preds = %B328.1.i.i.i.i, %B230.if.preheader.new.i.i.i.i
  %kept.2.0475.i.i.i.i = phi i64 [ 0, %B230.if.preheader.new.i.i.i.i ], [ %kept.3.1.1.i.i.i.i, %B328.1.i.i.i.i ]
  %.307471473.i.i.i.i = phi i64 [ 0, %B230.if.preheader.new.i.i.i.i ], [ %.314.1.i.i.i.i, %B328.1.i.i.i.i ]
  %sunkaddr23.i.i.i.i = shl i64 %.307471473.i.i.i.i, 3
  %sunkaddr33.i.i.i.i = getelementptr i8, ptr %.1620.i.i, i64 %sunkaddr23.i.i.i.i
  %sunkaddr34.i.i.i.i = getelementptr i8, ptr %sunkaddr33.i.i.i.i, i64 512
  %.378.i.i.i.i = load double, ptr %sunkaddr34.i.i.i.i, align 8, !noalias !21
  %.380.i.i.i.i = fcmp contract ult double %.378.i.i.i.i, %.1984.i.i.i
  br i1 %.380.i.i.i.i, label %B328.i.i.i.i, label %B290.i.i.i.i

B354.if.i.i.i.i:                                  ; preds = %B290.epil.i.i.i.i, %B230.if.epil.preheader.i.i.i.i, %B330.loopexit.unr-lcssa.i.i.i.i
  %kept.2.0.lcssa.i.i.i.i = phi i64 [ %kept.2.0475.epil.init.i.i.i.i, %B230.if.epil.preheader.i.i.i.i ], [ %kept.3.1.1.i.i.i.i, %B330.loopexit.unr-lcssa.i.i.i.i ], [ %.448.epil.i.i.i.i, %B290.epil.i.i.i.i ]
  %.690.i.i.i.i = icmp sgt i64 %kept.2.0.lcssa.i.i.i.i, 4
  br i1 %.690.i.i.i.i, label %B684.thread.i.i.i.i, label %B684.i.i.i.i

B684.thread.i.i.i.i:                              ; preds = %B354.if.i.i.i.i
  %79 = tail call i64 @llvm.smin.i64(i64 %kept.2.0.lcssa.i.i.i.i, i64 8)
  %.13.i.i9.i.i.i = add nsw i64 %79, -4
  %.924.i.i.i.i = add nsw i64 %79, -5
  %.984.i.i.i.i = load double, ptr %137, align 8, !noalias !21
  %.1026.i.i.i.i = fadd contract double %.984.i.i.i.i, 0.000000e+00
  store double %.1026.i.i.i.i, ptr %.1232.i.i.i, align 8, !noalias !21
  %.1026.1.i.i.i.i = fadd contract double %.984.i.i.i.i, 1.000000e+00
  %80 = getelementptr i8, ptr %.1232.i.i.i, i64 8
  store double %.1026.1.i.i.i.i, ptr %80, align 8, !noalias !21
  %.13.i16.2.i.i.i.i = tail call i64 @llvm.smin.i64(i64 %.924.i.i.i.i, i64 1)
  %sunkaddr24.i.i.i.i = shl nuw nsw i64 %.13.i16.2.i.i.i.i, 3
  %sunkaddr25.i.i.i.i = getelementptr i8, ptr %.447.i.i.i, i64 %sunkaddr24.i.i.i.i
  %sunkaddr26.i.i.i.i = getelementptr i8, ptr %sunkaddr25.i.i.i.i, i64 2512
  %.984.2.i.i.i.i = load double, ptr %sunkaddr26.i.i.i.i, align 8, !noalias !21
  %.1026.2.i.i.i.i = fadd contract double %.984.2.i.i.i.i, 0.000000e+00
  %81 = getelementptr i8, ptr %.1232.i.i.i, i64 16
  store double %.1026.2.i.i.i.i, ptr %81, align 8, !noalias !21
  %.984.3.i.i.i.i = load double, ptr %sunkaddr26.i.i.i.i, align 8, !noalias !21
  %.1026.3.i.i.i.i = fadd contract double %.984.3.i.i.i.i, 1.000000e+00
  %82 = getelementptr i8, ptr %.1232.i.i.i, i64 24
  store double %.1026.3.i.i.i.i, ptr %82, align 8, !noalias !21
  %.13.i16.4.i.i.i.i = tail call i64 @llvm.smin.i64(i64 %.924.i.i.i.i, i64 2)
  %sunkaddr27.i.i.i.i = shl nuw nsw i64 %.13.i16.4.i.i.i.i, 3
  %sunkaddr28.i.i.i.i = getelementptr i8, ptr %.447.i.i.i, i64 %sunkaddr27.i.i.i.i
  %sunkaddr29.i.i.i.i = getelementptr i8, ptr %sunkaddr28.i.i.i.i, i64 2512
  %.984.4.i.i.i.i = load double, ptr %sunkaddr29.i.i.i.i, align 8, !noalias !21
  %.1026.4.i.i.i.i = fadd contract double %.984.4.i.i.i.i, 0.000000e+00
  %83 = getelementptr i8, ptr %.1232.i.i.i, i64 32
  store double %.1026.4.i.i.i.i, ptr %83, align 8, !noalias !21
  %.984.5.i.i.i.i = load double, ptr %sunkaddr29.i.i.i.i, align 8, !noalias !21
  %.1026.5.i.i.i.i = fadd contract double %.984.5.i.i.i.i, 1.000000e+00
  %84 = getelementptr i8, ptr %.1232.i.i.i, i64 40
  store double %.1026.5.i.i.i.i, ptr %84, align 8, !noalias !21
  %.13.i16.6.i.i.i.i = tail call i64 @llvm.smin.i64(i64 %.924.i.i.i.i, i64 3)
  %sunkaddr30.i.i.i.i = shl nuw nsw i64 %.13.i16.6.i.i.i.i, 3
  %sunkaddr31.i.i.i.i = getelementptr i8, ptr %.447.i.i.i, i64 %sunkaddr30.i.i.i.i
  %sunkaddr32.i.i.i.i = getelementptr i8, ptr %sunkaddr31.i.i.i.i, i64 2512
  %.984.6.i.i.i.i = load double, ptr %sunkaddr32.i.i.i.i, align 8, !noalias !21
  %.1026.6.i.i.i.i = fadd contract double %.984.6.i.i.i.i, 0.000000e+00
  %85 = getelementptr i8, ptr %.1232.i.i.i, i64 48
  store double %.1026.6.i.i.i.i, ptr %85, align 8, !noalias !21
  %.984.7.i.i.i.i = load double, ptr %sunkaddr32.i.i.i.i, align 8, !noalias !21
  %.1026.7.i.i.i.i = fadd contract double %.984.7.i.i.i.i, 1.000000e+00
  %86 = getelementptr i8, ptr %.1232.i.i.i, i64 56
  store double %.1026.7.i.i.i.i, ptr %86, align 8, !noalias !21
  %.1065.i10.i.i.i = uitofp nneg i64 %.13.i.i9.i.i.i to double
  %.1066.i.i.i.i = fmul contract double %.1065.i10.i.i.i, 2.000000e+00
  store double %.1066.i.i.i.i, ptr %.1317.i.i.i, align 8, !noalias !21
  store double %.215.i.i.i.i, ptr %.1372.i.i.i, align 8, !noalias !21
  br label %B536.if.1.i.i.i.i

_ZN17bnserve_inference15marginal_kernel7_circle7_halvedB3v57B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedEdx5ArrayIdLi1E1C7mutable7alignedEx.exit.i.i.i: ; preds = %B536.if.1.i.i.i.i, %B684.i.i.i.i, %B1412.i.i.i
  %waiting.3.1.1.i.i.i.i = phi i64 [ %.1137.1.i.i.i.i, %B536.if.1.i.i.i.i ], [ %.1211.i.i.i, %B684.i.i.i.i ], [ %.1211.i.i.i, %B1412.i.i.i ]
  %.1197.i.i.i = icmp sgt i64 %waiting.3.1.1.i.i.i.i, 0
  br i1 %.1197.i.i.i, label %B900.i.i.i, label %B2924.i.i.i

B1460.i.i.i:                                      ; preds = %B1400.i.i.i
  %.21201924.not.i.i.i = icmp slt i64 %.5.i.i.i.i, 1
  br i1 %.21201924.not.i.i.i, label %B2792.i.i.i, label %B1490.if.lr.ph.i.i.i

B1490.if.lr.ph.i.i.i:                             ; preds = %B1460.i.i.i
  %.2204.i.i.i = fsub contract double %best.2.4.lcssa.i.i.i, %.593.i.i.i
  br label %B1490.if.i.i.i

B1560.i.i.i:                                      ; preds = %B1490.if.i.i.i
  %scevgep170.i.i.i = getelementptr i8, ptr %scevgep321.i.i.i, i64 -256
  %.2243.i.i.i = load double, ptr %scevgep170.i.i.i, align 8, !noalias !6
  %scevgep167.i.i.i = getelementptr i8, ptr %scevgep321.i.i.i, i64 -192
  %.2276.i.i.i = load double, ptr %scevgep167.i.i.i, align 8, !noalias !6
  %scevgep165.i.i.i = getelementptr i8, ptr %scevgep321.i.i.i, i64 -128
  %.2315.i.i.i = load double, ptr %scevgep165.i.i.i, align 8, !noalias !6
  %scevgep162.i.i.i = getelementptr i8, ptr %scevgep321.i.i.i, i64 -64
  %.2348.i.i.i = load double, ptr %scevgep162.i.i.i, align 8, !noalias !6
  %scevgep159.i.i.i = getelementptr i8, ptr %scevgep321.i.i.i, i64 -384
  %.2387.i.i.i = load double, ptr %scevgep159.i.i.i, align 8, !noalias !6
  %scevgep155.i.i.i = getelementptr i8, ptr %scevgep321.i.i.i, i64 -320
  %.2422.i.i.i = load double, ptr %scevgep155.i.i.i, align 8, !noalias !6
  br i1 %138, label %B1852.i.i.i, label %B2582.i.i.i

B1852.i.i.i:                                      ; preds = %B1560.i.i.i
  %.2461.i.i.i = load double, ptr %sunkaddr171.i.i.i, align 8, !noalias !6
  %.2512.i.i.i = load double, ptr %.592.i.i.i, align 8, !noalias !6
  %.2513.i.i.i = fmul contract double %.2512.i.i.i, 2.000000e+00
  %.2514.i.i.i = tail call contract double @llvm.sqrt.f64(double %.2513.i.i.i)
  %.2516.i.i.i = fmul contract double %.2348.i.i.i, %.2514.i.i.i
  %.2522.i.i.i = fsub contract double %.2315.i.i.i, %.2516.i.i.i
  %.2552.i.i.i = load double, ptr %.532.i.i.i, align 8, !noalias !6
  %.2553.i.i.i = fcmp contract ogt double %.2522.i.i.i, %.2552.i.i.i
  br i1 %.2553.i.i.i, label %B1920.i.i.i, label %B2142.i.i.i

B1920.i.i.i:                                      ; preds = %B1852.i.i.i
  %.2560.i.i.i = fadd contract double %.2315.i.i.i, %.2516.i.i.i
  %.2592.i.i.i = load double, ptr %.562.i.i.i, align 8, !noalias !6
  %.2598.i.i.i = fcmp contract olt double %.2560.i.i.i, %.2592.i.i.i
  br label %B2142.i.i.i

B2142.i.i.i:                                      ; preds = %B1920.i.i.i, %B1852.i.i.i
  %is_normal_v21__vphi176_0.2.7.i.i.i = phi i1 [ %.2598.i.i.i, %B1920.i.i.i ], [ false, %B1852.i.i.i ]
  %.2618.i.i.i = fmul contract double %.2315.i.i.i, %.2461.i.i.i
  %.2624.i.i.i = fcmp contract olt double %.2348.i.i.i, %.2618.i.i.i
  %is_normal_v21__vphi198_0.2.7.i.i.i = select i1 %is_normal_v21__vphi176_0.2.7.i.i.i, i1 %.2624.i.i.i, i1 false
  br i1 %is_normal_v21__vphi198_0.2.7.i.i.i, label %B2560.i.i.i, label %B2582.i.i.i

B2560.i.i.i:                                      ; preds = %B2142.i.i.i
  %.2665.i.i.i = icmp slt i64 %normals.3.41927.i.i.i, 0
  %.2666.i.i.i = select i1 %.2665.i.i.i, i64 544, i64 0
  %87 = getelementptr double, ptr %.299.i.i.i, i64 %normals.3.41927.i.i.i
  %.2680.i.i.i = getelementptr double, ptr %87, i64 %.2666.i.i.i
  store double %.2243.i.i.i, ptr %.2680.i.i.i, align 8, !noalias !6
  %.2701.i.i.i = icmp slt i64 %normals.3.41927.i.i.i, -32
  %.2702.i.i.i = select i1 %.2701.i.i.i, i64 544, i64 0
  %88 = getelementptr i8, ptr %87, i64 256
  %.2716.i.i.i = getelementptr double, ptr %88, i64 %.2702.i.i.i
  store double %.2315.i.i.i, ptr %.2716.i.i.i, align 8, !noalias !6
  %.2737.i.i.i = icmp slt i64 %normals.3.41927.i.i.i, -64
  %.2738.i.i.i = select i1 %.2737.i.i.i, i64 544, i64 0
  %89 = getelementptr i8, ptr %87, i64 512
  %.2752.i.i.i = getelementptr double, ptr %89, i64 %.2738.i.i.i
  store double %.2348.i.i.i, ptr %.2752.i.i.i, align 8, !noalias !6
  %.2773.i.i.i = icmp slt i64 %normals.3.41927.i.i.i, -96
  %.2774.i.i.i = select i1 %.2773.i.i.i, i64 544, i64 0
  %90 = getelementptr i8, ptr %87, i64 768
  %.2788.i.i.i = getelementptr double, ptr %90, i64 %.2774.i.i.i
  store double %.2387.i.i.i, ptr %.2788.i.i.i, align 8, !noalias !6
  %.2809.i.i.i = icmp slt i64 %normals.3.41927.i.i.i, -128
  %.2810.i.i.i = select i1 %.2809.i.i.i, i64 544, i64 0
  %91 = getelementptr i8, ptr %87, i64 1024
  %.2824.i.i.i = getelementptr double, ptr %91, i64 %.2810.i.i.i
  store double %.2422.i.i.i, ptr %.2824.i.i.i, align 8, !noalias !6
  %.2829.i.i.i = add nsw i64 %normals.3.41927.i.i.i, 1
  br label %B2630.i.i.i

B2582.i.i.i:                                      ; preds = %B2142.i.i.i, %B1560.i.i.i
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(32) %.2851.i.i.i, i8 0, i64 32, i1 false), !noalias !6
  call fastcc void @inner_0(ptr nonnull %.2851.i.i.i, double %.2243.i.i.i, double %.2276.i.i.i, ptr nonnull readonly %arg.arguments, ptr readonly %0, ptr nonnull %.232.i.i.i)
  %.2871.fca.3.load.i.i.i = load double, ptr %sunkaddr211.i.i.i, align 8, !noalias !6
  %.2871.fca.2.load.i.i.i = load double, ptr %sunkaddr212.i.i.i, align 8, !noalias !6
  %.2871.fca.1.load.i.i.i = load double, ptr %sunkaddr213.i.i.i, align 8, !noalias !6
  %.2871.fca.0.load.i.i.i = load double, ptr %.2851.i.i.i, align 8, !noalias !6
  %.2902.i.i.i = icmp slt i64 %others.3.41928.i.i.i, -288
  %.2903.i.i.i = select i1 %.2902.i.i.i, i64 544, i64 0
  %92 = getelementptr double, ptr %.361.i.i.i, i64 %others.3.41928.i.i.i
  %93 = getelementptr i8, ptr %92, i64 2304
  %.2917.i.i.i = getelementptr double, ptr %93, i64 %.2903.i.i.i
  store double %.2871.fca.0.load.i.i.i, ptr %.2917.i.i.i, align 8, !noalias !6
  %.2936.i.i.i = icmp slt i64 %others.3.41928.i.i.i, -192
  %.2937.i.i.i = select i1 %.2936.i.i.i, i64 544, i64 0
  %94 = getelementptr i8, ptr %92, i64 1536
  %.2951.i.i.i = getelementptr double, ptr %94, i64 %.2937.i.i.i
  store double %.2871.fca.1.load.i.i.i, ptr %.2951.i.i.i, align 8, !noalias !6
  %.2970.i.i.i = icmp slt i64 %others.3.41928.i.i.i, -224
  %.2971.i.i.i = select i1 %.2970.i.i.i, i64 544, i64 0
  %95 = getelementptr i8, ptr %92, i64 1792
  %.2985.i.i.i = getelementptr double, ptr %95, i64 %.2971.i.i.i
  store double %.2871.fca.2.load.i.i.i, ptr %.2985.i.i.i, align 8, !noalias !6
  %.3008.i.i.i = icmp slt i64 %others.3.41928.i.i.i, -256
  %.3009.i.i.i = select i1 %.3008.i.i.i, i64 544, i64 0
  %96 = getelementptr i8, ptr %92, i64 2048
  %.3023.i.i.i = getelementptr double, ptr %96, i64 %.3009.i.i.i
  store double %.2871.fca.3.load.i.i.i, ptr %.3023.i.i.i, align 8, !noalias !6
  %.3042.i.i.i = icmp slt i64 %others.3.41928.i.i.i, -96
  %.3043.i.i.i = select i1 %.3042.i.i.i, i64 544, i64 0
  %97 = getelementptr i8, ptr %92, i64 768
  %.3057.i.i.i = getelementptr double, ptr %97, i64 %.3043.i.i.i
  store double %.2387.i.i.i, ptr %.3057.i.i.i, align 8, !noalias !6
  %.3078.i.i.i = icmp slt i64 %others.3.41928.i.i.i, -128
  %.3079.i.i.i = select i1 %.3078.i.i.i, i64 544, i64 0
  %98 = getelementptr i8, ptr %92, i64 1024
  %.3093.i.i.i = getelementptr double, ptr %98, i64 %.3079.i.i.i
  store double %.2422.i.i.i, ptr %.3093.i.i.i, align 8, !noalias !6
  %.3098.i.i.i = add nsw i64 %others.3.41928.i.i.i, 1
  br label %B2630.i.i.i

B2630.i.i.i:                                      ; preds = %B2582.i.i.i, %B2560.i.i.i
  %others.5.6.i.i.i = phi i64 [ %others.3.41928.i.i.i, %B2560.i.i.i ], [ %.3098.i.i.i, %B2582.i.i.i ]
  %normals.6.6.i.i.i = phi i64 [ %.2829.i.i.i, %B2560.i.i.i ], [ %normals.3.41927.i.i.i, %B2582.i.i.i ]
  %.3109.i.i.i = icmp eq i64 %normals.6.6.i.i.i, 32
  br i1 %.3109.i.i.i, label %B2634.i.i.i, label %B2648.i.i.i

B2634.i.i.i:                                      ; preds = %B2630.i.i.i
  store ptr null, ptr %.3119.i.i.i, align 8, !noalias !6
  call fastcc void @inner_1(ptr nonnull %.3119.i.i.i, ptr nonnull %.299.i.i.i, i64 32, i64 range(i64 -9223372036854775807, -9223372036854775808) %.598.i.i, ptr %1, i64 range(i64 -9223372036854775808, 9223372036854775801) %.604.i.i, ptr nonnull readonly %arg.arguments, ptr readonly %0, ptr nonnull %.148.i.i.i)
  br label %B2648.i.i.i

B2648.i.i.i:                                      ; preds = %B2634.i.i.i, %B2630.i.i.i
  %normals.5.6.i.i.i = phi i64 [ %normals.6.6.i.i.i, %B2630.i.i.i ], [ 0, %B2634.i.i.i ]
  %.3168.i.i.i = icmp eq i64 %others.5.6.i.i.i, 32
  br i1 %.3168.i.i.i, label %B2652.i.i.i, label %B2764.i.i.i

B2652.i.i.i:                                      ; preds = %B2648.i.i.i
  call void @llvm.lifetime.start.p0(ptr nonnull %.854.i.i.i.i), !noalias !6
  store ptr null, ptr %.854.i.i.i.i, align 8, !noalias !24
  %.842.i12.i.i.i = load i64, ptr %.963.i.i, align 8, !noalias !24
  %.848.i13.i.i.i = icmp ne i64 %.842.i12.i.i.i, 0
  store ptr null, ptr %.854.i.i.i.i, align 8, !noalias !24
  %.862.i14.i.i.i = zext i1 %.848.i13.i.i.i to i8
  call fastcc void @inner_2(ptr nonnull %.854.i.i.i.i, ptr nonnull %.361.i.i.i, i64 32, i64 range(i64 -9223372036854775807, -9223372036854775808) %.598.i.i, ptr %1, i64 range(i64 -9223372036854775808, 9223372036854775801) %.604.i.i, i8 %.862.i14.i.i.i, ptr nonnull %.148.i.i.i)
  call void @llvm.lifetime.end.p0(ptr nonnull %.854.i.i.i.i), !noalias !6
  br label %B2764.i.i.i

B2764.i.i.i:                                      ; preds = %B1490.if.i.i.i, %B2652.i.i.i, %B2648.i.i.i
  %normals.4.5.i.i.i = phi i64 [ %normals.3.41927.i.i.i, %B1490.if.i.i.i ], [ %normals.5.6.i.i.i, %B2648.i.i.i ], [ %normals.5.6.i.i.i, %B2652.i.i.i ]
  %others.4.5.i.i.i = phi i64 [ %others.3.41928.i.i.i, %B1490.if.i.i.i ], [ %others.5.6.i.i.i, %B2648.i.i.i ], [ 0, %B2652.i.i.i ]
  %exitcond2569.not.i.i.i = icmp eq i64 %.2133.i.i.i, %.5.i.i.i.i
  br i1 %exitcond2569.not.i.i.i, label %B2792.i.i.i, label %B1490.if.i.i.i

B2792.i.i.i:                                      ; preds = %B2764.i.i.i, %B1460.i.i.i
  %normals.3.4.lcssa.i.i.i = phi i64 [ %normals.7.2.ph.i.i.i, %B1460.i.i.i ], [ %normals.4.5.i.i.i, %B2764.i.i.i ]
  %others.3.4.lcssa.i.i.i = phi i64 [ %others.6.2.ph.i.i.i, %B1460.i.i.i ], [ %others.4.5.i.i.i, %B2764.i.i.i ]
  %.3272.i.i.i = icmp sgt i64 %waiting.4.2.i.i.i, 1
  br i1 %.3272.i.i.i, label %B900.outer.i.i.i, label %B2924.i.i.i

B2924.i.i.i:                                      ; preds = %B2792.i.i.i, %_ZN17bnserve_inference15marginal_kernel7_circle7_halvedB3v57B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedEdx5ArrayIdLi1E1C7mutable7alignedEx.exit.i.i.i
  %normals.10.3.i.i.i = phi i64 [ %normals.7.2.ph.i.i.i, %_ZN17bnserve_inference15marginal_kernel7_circle7_halvedB3v57B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedEdx5ArrayIdLi1E1C7mutable7alignedEx.exit.i.i.i ], [ %normals.3.4.lcssa.i.i.i, %B2792.i.i.i ]
  %others.9.3.i.i.i = phi i64 [ %others.6.2.ph.i.i.i, %_ZN17bnserve_inference15marginal_kernel7_circle7_halvedB3v57B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedEdx5ArrayIdLi1E1C7mutable7alignedEx.exit.i.i.i ], [ %others.3.4.lcssa.i.i.i, %B2792.i.i.i ]
  %.880.i.i.i = icmp sgt i64 %.87920852217.i.i.i, 1
  br i1 %.880.i.i.i, label %B758.if.i.i.i, label %B2972.i.i.i

B2972.i.i.i:                                      ; preds = %B2924.i.i.i, %_ZN17bnserve_inference15marginal_kernel7_circle7_surveyB3v29B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedExx8UniTupleIdLi3EEd5ArrayIdLi1E1C7mutable7alignedE.exit.i.i.i
  %normals.9.0.lcssa.i.i.i = phi i64 [ 0, %_ZN17bnserve_inference15marginal_kernel7_circle7_surveyB3v29B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedExx8UniTupleIdLi3EEd5ArrayIdLi1E1C7mutable7alignedE.exit.i.i.i ], [ %normals.10.3.i.i.i, %B2924.i.i.i ]
  %others.8.0.lcssa.i.i.i = phi i64 [ 0, %_ZN17bnserve_inference15marginal_kernel7_circle7_surveyB3v29B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedExx8UniTupleIdLi3EEd5ArrayIdLi1E1C7mutable7alignedE.exit.i.i.i ], [ %others.9.3.i.i.i, %B2924.i.i.i ]
  store ptr null, ptr %.3347.i.i.i, align 8, !noalias !6
  call fastcc void @inner_1(ptr nonnull %.3347.i.i.i, ptr nonnull %.299.i.i.i, i64 %normals.9.0.lcssa.i.i.i, i64 range(i64 -9223372036854775807, -9223372036854775808) %.598.i.i, ptr %1, i64 range(i64 -9223372036854775808, 9223372036854775801) %.604.i.i, ptr nonnull readonly %arg.arguments, ptr readonly %0, ptr nonnull %.148.i.i.i)
  call void @llvm.lifetime.start.p0(ptr nonnull %.854.i15.i.i.i), !noalias !6
  store ptr null, ptr %.854.i15.i.i.i, align 8, !noalias !27
  %.93.i.i.i.i = icmp eq i64 %others.8.0.lcssa.i.i.i, 0
  br i1 %.93.i.i.i.i, label %_ZN17bnserve_inference15marginal_kernel7_circle7_finishB4v162B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedEx28Literal_5bbool_5d_28False_29x5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit42.i.i.i, label %B20.i.i.i.i

B20.i.i.i.i:                                      ; preds = %B2972.i.i.i
  %.130.i.i.i.i = sub i64 0, %others.8.0.lcssa.i.i.i
  %.138.1.i.i.i.i = and i64 %.130.i.i.i.i, -8
  %.172.i17.i.i.i = sub i64 0, %.138.1.i.i.i.i
  %.336.i.i.i.i = sub i64 %.172.i17.i.i.i, %others.8.0.lcssa.i.i.i
  %..336.i.i.i.i = tail call i64 @llvm.smax.i64(i64 %.336.i.i.i.i, i64 0)
  %.388.prol.i.i.i.i = add nsw i64 %..336.i.i.i.i, -1
  %.392.prol.i.i.i.i = add i64 %others.8.0.lcssa.i.i.i, 1
  %99 = icmp slt i64 %.336.i.i.i.i, 1
  %100 = and i64 %..336.i.i.i.i, 1
  %101 = icmp eq i64 %100, 0
  %102 = icmp eq i64 %.336.i.i.i.i, 1
  br label %B90.if.i18.i.i.i

B90.loopexit.i.i.i.i:                             ; preds = %B126.if.i.i.i.i, %B126.if.prol.loopexit.i.i.i.i, %B90.if.i18.i.i.i
  %lsr.iv.next49.i27.i.i.i = add nuw nsw i64 %lsr.iv48.i19.i.i.i, 32
  %exitcond.not.i28.i.i.i = icmp eq i64 %.270.i21.i.i.i, 17
  br i1 %exitcond.not.i28.i.i.i, label %B246.i.i.i.i, label %B90.if.i18.i.i.i

B246.i.i.i.i:                                     ; preds = %B90.loopexit.i.i.i.i
  br i1 %99, label %B362.i.i.i.i, label %B322.if.preheader.i.i.i.i

B322.if.preheader.i.i.i.i:                        ; preds = %B246.i.i.i.i
  %xtraiter1.i.i.i.i = and i64 %..336.i.i.i.i, 3
  %lcmp.mod2.not.i.i.i.i = icmp eq i64 %xtraiter1.i.i.i.i, 0
  br i1 %lcmp.mod2.not.i.i.i.i, label %B322.if.prol.loopexit.i.i.i.i, label %B322.if.prol.preheader.i.i.i.i

B322.if.prol.preheader.i.i.i.i:                   ; preds = %B322.if.preheader.i.i.i.i
  %103 = shl i64 %others.8.0.lcssa.i.i.i, 3
  %104 = getelementptr i8, ptr %.361.i.i.i, i64 %103
  %scevgep43.i.i.i.i = getelementptr i8, ptr %104, i64 1536
  br label %B322.if.prol.i.i.i.i

B322.if.prol.i.i.i.i:                             ; preds = %B322.if.prol.i.i.i.i, %B322.if.prol.preheader.i.i.i.i
  %prol.iter.i.i.i.i = phi i64 [ %prol.iter.next.i.i.i.i, %B322.if.prol.i.i.i.i ], [ 0, %B322.if.prol.preheader.i.i.i.i ]
  %105 = add i64 %prol.iter.i.i.i.i, %others.8.0.lcssa.i.i.i
  %.778.prol.i.i.i.i = icmp slt i64 %105, -192
  %106 = select i1 %.778.prol.i.i.i.i, i64 4352, i64 0
  %scevgep44.i.i.i.i = getelementptr i8, ptr %scevgep43.i.i.i.i, i64 %106
  %107 = shl nuw nsw i64 %prol.iter.i.i.i.i, 3
  %scevgep9.i.i.i.i = getelementptr i8, ptr %scevgep44.i.i.i.i, i64 %107
  store double 0.000000e+00, ptr %scevgep9.i.i.i.i, align 8, !noalias !27
  %prol.iter.next.i.i.i.i = add nuw nsw i64 %prol.iter.i.i.i.i, 1
  %prol.iter.cmp.not.i29.i.i.i = icmp eq i64 %xtraiter1.i.i.i.i, %prol.iter.next.i.i.i.i
  br i1 %prol.iter.cmp.not.i29.i.i.i, label %B322.if.prol.loopexit.loopexit.i.i.i.i, label %B322.if.prol.i.i.i.i, !llvm.loop !30

B322.if.prol.loopexit.loopexit.i.i.i.i:           ; preds = %B322.if.prol.i.i.i.i
  %108 = sub nsw i64 %..336.i.i.i.i, %prol.iter.next.i.i.i.i
  %109 = add i64 %prol.iter.next.i.i.i.i, %others.8.0.lcssa.i.i.i
  br label %B322.if.prol.loopexit.i.i.i.i

B322.if.prol.loopexit.i.i.i.i:                    ; preds = %B322.if.prol.loopexit.loopexit.i.i.i.i, %B322.if.preheader.i.i.i.i
  %.723349353.unr.i.i.i.i = phi i64 [ %..336.i.i.i.i, %B322.if.preheader.i.i.i.i ], [ %108, %B322.if.prol.loopexit.loopexit.i.i.i.i ]
  %.730350352.unr.i.i.i.i = phi i64 [ %others.8.0.lcssa.i.i.i, %B322.if.preheader.i.i.i.i ], [ %109, %B322.if.prol.loopexit.loopexit.i.i.i.i ]
  %110 = icmp slt i64 %.336.i.i.i.i, 4
  br i1 %110, label %B322.if.1.preheader.i.i.i.i, label %B322.if.preheader21.i.i.i.i

B322.if.preheader21.i.i.i.i:                      ; preds = %B322.if.prol.loopexit.i.i.i.i
  %111 = add i64 %.723349353.unr.i.i.i.i, 4
  %112 = shl i64 %.730350352.unr.i.i.i.i, 3
  %scevgep1.i.i.i.i = getelementptr i8, ptr %.361.i.i.i, i64 %112
  br label %B322.if.i.i.i.i

B322.if.1.i.i.i.i:                                ; preds = %B322.if.1.preheader.i.i.i.i, %B322.if.1.i.i.i.i
  %lsr.iv24.i.i.i.i = phi i64 [ %132, %B322.if.1.preheader.i.i.i.i ], [ %lsr.iv.next25.i.i.i.i, %B322.if.1.i.i.i.i ]
  %.730350352.1.i.i.i.i = phi i64 [ %others.8.0.lcssa.i.i.i, %B322.if.1.preheader.i.i.i.i ], [ %.737.1.i.i.i.i, %B322.if.1.i.i.i.i ]
  %.737.1.i.i.i.i = add i64 %.730350352.1.i.i.i.i, 1
  %.778.1.i.i.i.i = icmp slt i64 %.730350352.1.i.i.i.i, -224
  %113 = select i1 %.778.1.i.i.i.i, i64 4352, i64 0
  %114 = shl i64 %.730350352.1.i.i.i.i, 3
  %scevgep5.i31.i.i.i = getelementptr i8, ptr %scevgep.i30.i.i.i, i64 %113
  %scevgep6.i.i.i.i = getelementptr i8, ptr %scevgep5.i31.i.i.i, i64 %114
  store double 0.000000e+00, ptr %scevgep6.i.i.i.i, align 8, !noalias !27
  %lsr.iv.next25.i.i.i.i = add i64 %lsr.iv24.i.i.i.i, -1
  %.724.1.i.i.i.i = icmp sgt i64 %lsr.iv.next25.i.i.i.i, 1
  br i1 %.724.1.i.i.i.i, label %B322.if.1.i.i.i.i, label %B322.if.2.preheader.i.i.i.i

B322.if.2.preheader.i.i.i.i:                      ; preds = %B322.if.1.i.i.i.i
  %scevgep2.i32.i.i.i = getelementptr i8, ptr %.1620.i.i, i64 9600
  br label %B322.if.2.i.i.i.i

B322.if.2.i.i.i.i:                                ; preds = %B322.if.2.i.i.i.i, %B322.if.2.preheader.i.i.i.i
  %lsr.iv.i33.i.i.i = phi i64 [ %lsr.iv.next.i36.i.i.i, %B322.if.2.i.i.i.i ], [ %132, %B322.if.2.preheader.i.i.i.i ]
  %.730350352.2.i.i.i.i = phi i64 [ %.737.2.i.i.i.i, %B322.if.2.i.i.i.i ], [ %others.8.0.lcssa.i.i.i, %B322.if.2.preheader.i.i.i.i ]
  %.737.2.i.i.i.i = add i64 %.730350352.2.i.i.i.i, 1
  %.778.2.i.i.i.i = icmp slt i64 %.730350352.2.i.i.i.i, -256
  %115 = select i1 %.778.2.i.i.i.i, i64 4352, i64 0
  %116 = shl i64 %.730350352.2.i.i.i.i, 3
  %scevgep3.i34.i.i.i = getelementptr i8, ptr %scevgep2.i32.i.i.i, i64 %115
  %scevgep4.i35.i.i.i = getelementptr i8, ptr %scevgep3.i34.i.i.i, i64 %116
  store double 0.000000e+00, ptr %scevgep4.i35.i.i.i, align 8, !noalias !27
  %lsr.iv.next.i36.i.i.i = add i64 %lsr.iv.i33.i.i.i, -1
  %.724.2.i.i.i.i = icmp sgt i64 %lsr.iv.next.i36.i.i.i, 1
  br i1 %.724.2.i.i.i.i, label %B322.if.2.i.i.i.i, label %B362.i.i.i.i

B362.i.i.i.i:                                     ; preds = %B322.if.2.i.i.i.i, %B246.i.i.i.i
  %.842.i38.i.i.i = load i64, ptr %.963.i.i, align 8, !noalias !27
  %.848.i39.i.i.i = icmp ne i64 %.842.i38.i.i.i, 0
  store ptr null, ptr %.854.i15.i.i.i, align 8, !noalias !27
  %.862.i40.i.i.i = zext i1 %.848.i39.i.i.i to i8
  call fastcc void @inner_2(ptr nonnull %.854.i15.i.i.i, ptr nonnull %.361.i.i.i, i64 %.172.i17.i.i.i, i64 range(i64 -9223372036854775807, -9223372036854775808) %.598.i.i, ptr %1, i64 range(i64 -9223372036854775808, 9223372036854775801) %.604.i.i, i8 %.862.i40.i.i.i, ptr nonnull %.148.i.i.i)
  br label %_ZN17bnserve_inference15marginal_kernel7_circle7_finishB4v162B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedEx28Literal_5bbool_5d_28False_29x5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit42.i.i.i

B90.if.i18.i.i.i:                                 ; preds = %B90.loopexit.i.i.i.i, %B20.i.i.i.i
  %lsr.iv48.i19.i.i.i = phi i64 [ 1, %B20.i.i.i.i ], [ %lsr.iv.next49.i27.i.i.i, %B90.loopexit.i.i.i.i ]
  %.263337343.i20.i.i.i = phi i64 [ 0, %B20.i.i.i.i ], [ %.270.i21.i.i.i, %B90.loopexit.i.i.i.i ]
  %.270.i21.i.i.i = add nuw nsw i64 %.263337343.i20.i.i.i, 1
  br i1 %99, label %B90.loopexit.i.i.i.i, label %B126.if.lr.ph.i.i.i.i

B126.if.lr.ph.i.i.i.i:                            ; preds = %B90.if.i18.i.i.i
  %.418.i.i.i.i = shl nsw i64 %.263337343.i20.i.i.i, 5
  %.420.i.i.i.i = add nsw i64 %.418.i.i.i.i, %others.8.0.lcssa.i.i.i
  %.435.inv.i.i.i.i = icmp sgt i64 %.420.i.i.i.i, 0
  %.436.i.i.i.i = select i1 %.435.inv.i.i.i.i, i64 0, i64 544
  %117 = getelementptr double, ptr %.361.i.i.i, i64 %.420.i.i.i.i
  br i1 %101, label %B126.if.prol.loopexit.i.i.i.i, label %B126.if.prol.i.i.i.i

B126.if.prol.i.i.i.i:                             ; preds = %B126.if.lr.ph.i.i.i.i
  %sunkaddr19.i22.i.i.i = shl nuw nsw i64 %.436.i.i.i.i, 3
  %sunkaddr20.i23.i.i.i = getelementptr i8, ptr %117, i64 %sunkaddr19.i22.i.i.i
  %sunkaddr21.i24.i.i.i = getelementptr i8, ptr %sunkaddr20.i23.i.i.i, i64 -8
  %.451.prol.i.i.i.i = load double, ptr %sunkaddr21.i24.i.i.i, align 8, !noalias !27
  %.468.prol.i.i.i.i = icmp slt i64 %.420.i.i.i.i, 0
  %.469.prol.i.i.i.i = select i1 %.468.prol.i.i.i.i, i64 544, i64 0
  %.483.prol.i.i.i.i = getelementptr double, ptr %117, i64 %.469.prol.i.i.i.i
  store double %.451.prol.i.i.i.i, ptr %.483.prol.i.i.i.i, align 8, !noalias !27
  br label %B126.if.prol.loopexit.i.i.i.i

B126.if.prol.loopexit.i.i.i.i:                    ; preds = %B126.if.prol.i.i.i.i, %B126.if.lr.ph.i.i.i.i
  %.378330334.unr.i.i.i.i = phi i64 [ %..336.i.i.i.i, %B126.if.lr.ph.i.i.i.i ], [ %.388.prol.i.i.i.i, %B126.if.prol.i.i.i.i ]
  %.385331333.unr.i.i.i.i = phi i64 [ %others.8.0.lcssa.i.i.i, %B126.if.lr.ph.i.i.i.i ], [ %.392.prol.i.i.i.i, %B126.if.prol.i.i.i.i ]
  br i1 %102, label %B90.loopexit.i.i.i.i, label %B126.if.lr.ph.new.i.i.i.i

B126.if.lr.ph.new.i.i.i.i:                        ; preds = %B126.if.prol.loopexit.i.i.i.i
  %118 = add i64 %.378330334.unr.i.i.i.i, 2
  %119 = add i64 %.385331333.unr.i.i.i.i, %lsr.iv48.i19.i.i.i
  %sunkaddr11.i.i.i.i = shl nuw nsw i64 %.436.i.i.i.i, 3
  %sunkaddr12.i25.i.i.i = getelementptr i8, ptr %117, i64 %sunkaddr11.i.i.i.i
  %sunkaddr13.i26.i.i.i = getelementptr i8, ptr %sunkaddr12.i25.i.i.i, i64 -8
  br label %B126.if.i.i.i.i

B126.if.i.i.i.i:                                  ; preds = %B126.if.i.i.i.i, %B126.if.lr.ph.new.i.i.i.i
  %lsr.iv50.i.i.i.i = phi i64 [ %lsr.iv.next51.i.i.i.i, %B126.if.i.i.i.i ], [ %119, %B126.if.lr.ph.new.i.i.i.i ]
  %lsr.iv46.i.i.i.i = phi i64 [ %lsr.iv.next47.i.i.i.i, %B126.if.i.i.i.i ], [ %118, %B126.if.lr.ph.new.i.i.i.i ]
  %.451.i.i.i.i = load double, ptr %sunkaddr13.i26.i.i.i, align 8, !noalias !27
  %120 = add i64 %lsr.iv50.i.i.i.i, -1
  %.468.i.i.i.i = icmp slt i64 %120, 0
  %121 = shl i64 %lsr.iv50.i.i.i.i, 3
  %122 = select i1 %.468.i.i.i.i, i64 4344, i64 -8
  %scevgep17.i.i.i.i = getelementptr i8, ptr %.361.i.i.i, i64 %122
  %scevgep18.i.i.i.i = getelementptr i8, ptr %scevgep17.i.i.i.i, i64 %121
  store double %.451.i.i.i.i, ptr %scevgep18.i.i.i.i, align 8, !noalias !27
  %.451.1.i.i.i.i = load double, ptr %sunkaddr13.i26.i.i.i, align 8, !noalias !27
  %.468.1.i.i.i.i = icmp slt i64 %lsr.iv50.i.i.i.i, 0
  %123 = select i1 %.468.1.i.i.i.i, i64 4352, i64 0
  %scevgep52.i.i.i.i = getelementptr i8, ptr %.361.i.i.i, i64 %123
  %scevgep10.i.i.i.i = getelementptr i8, ptr %scevgep52.i.i.i.i, i64 %121
  store double %.451.1.i.i.i.i, ptr %scevgep10.i.i.i.i, align 8, !noalias !27
  %lsr.iv.next47.i.i.i.i = add i64 %lsr.iv46.i.i.i.i, -2
  %lsr.iv.next51.i.i.i.i = add i64 %lsr.iv50.i.i.i.i, 2
  %.379.1.i.i.i.i = icmp sgt i64 %lsr.iv.next47.i.i.i.i, 2
  br i1 %.379.1.i.i.i.i, label %B126.if.i.i.i.i, label %B90.loopexit.i.i.i.i

B322.if.i.i.i.i:                                  ; preds = %B322.if.i.i.i.i, %B322.if.preheader21.i.i.i.i
  %lsr.iv2.i.i.i.i = phi ptr [ %scevgep19.i.i.i.i, %B322.if.i.i.i.i ], [ %scevgep1.i.i.i.i, %B322.if.preheader21.i.i.i.i ]
  %lsr.iv29.i.i.i.i = phi i64 [ %lsr.iv.next30.i.i.i.i, %B322.if.i.i.i.i ], [ %111, %B322.if.preheader21.i.i.i.i ]
  %.730350352.i.i.i.i = phi i64 [ %131, %B322.if.i.i.i.i ], [ %.730350352.unr.i.i.i.i, %B322.if.preheader21.i.i.i.i ]
  %.778.i.i.i.i = icmp slt i64 %.730350352.i.i.i.i, -192
  %124 = select i1 %.778.i.i.i.i, i64 5888, i64 1536
  %scevgep23.i.i.i.i = getelementptr i8, ptr %lsr.iv2.i.i.i.i, i64 %124
  store double 0.000000e+00, ptr %scevgep23.i.i.i.i, align 8, !noalias !27
  %125 = add i64 %.730350352.i.i.i.i, 1
  %.778.17.i.i.i.i = icmp slt i64 %125, -192
  %126 = select i1 %.778.17.i.i.i.i, i64 5896, i64 1544
  %scevgep22.i.i.i.i = getelementptr i8, ptr %lsr.iv2.i.i.i.i, i64 %126
  store double 0.000000e+00, ptr %scevgep22.i.i.i.i, align 8, !noalias !27
  %127 = add i64 %.730350352.i.i.i.i, 2
  %.778.216.i.i.i.i = icmp slt i64 %127, -192
  %128 = select i1 %.778.216.i.i.i.i, i64 5904, i64 1552
  %scevgep21.i.i.i.i = getelementptr i8, ptr %lsr.iv2.i.i.i.i, i64 %128
  store double 0.000000e+00, ptr %scevgep21.i.i.i.i, align 8, !noalias !27
  %129 = add i64 %.730350352.i.i.i.i, 3
  %.778.3.i.i.i.i = icmp slt i64 %129, -192
  %130 = select i1 %.778.3.i.i.i.i, i64 5912, i64 1560
  %scevgep20.i.i.i.i = getelementptr i8, ptr %lsr.iv2.i.i.i.i, i64 %130
  store double 0.000000e+00, ptr %scevgep20.i.i.i.i, align 8, !noalias !27
  %lsr.iv.next30.i.i.i.i = add i64 %lsr.iv29.i.i.i.i, -4
  %scevgep19.i.i.i.i = getelementptr i8, ptr %lsr.iv2.i.i.i.i, i64 32
  %.724.3.i.i.i.i = icmp sgt i64 %lsr.iv.next30.i.i.i.i, 4
  %131 = add i64 %.730350352.i.i.i.i, 4
  br i1 %.724.3.i.i.i.i, label %B322.if.i.i.i.i, label %B322.if.1.preheader.i.i.i.i

B322.if.1.preheader.i.i.i.i:                      ; preds = %B322.if.i.i.i.i, %B322.if.prol.loopexit.i.i.i.i
  %132 = add nuw i64 %..336.i.i.i.i, 1
  %scevgep.i30.i.i.i = getelementptr i8, ptr %.1620.i.i, i64 9344
  br label %B322.if.1.i.i.i.i

_ZN17bnserve_inference15marginal_kernel7_circle7_finishB4v162B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedEx28Literal_5bbool_5d_28False_29x5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit42.i.i.i: ; preds = %B362.i.i.i.i, %B2972.i.i.i
  call void @llvm.lifetime.end.p0(ptr nonnull %.854.i15.i.i.i), !noalias !6
  %.3485.i.i.i = load double, ptr %.780.i.i.i, align 8, !noalias !6
  %.3486.i.i.i = fcmp contract ogt double %.3485.i.i.i, 0.000000e+00
  br i1 %.3486.i.i.i, label %B2994.i.i.i, label %_ZN17bnserve_inference15marginal_kernel7_circle10_integrateB3v19B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedEx8UniTupleIdLi3EEd5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i.i

B2994.i.i.i:                                      ; preds = %_ZN17bnserve_inference15marginal_kernel7_circle7_finishB4v162B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedEx28Literal_5bbool_5d_28False_29x5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit42.i.i.i
  %.3536.i.i.i = load double, ptr %.148.i.i.i, align 8, !noalias !6
  %.3573.i.i.i = fdiv contract double %.3485.i.i.i, %.1267.i.i.i.i
  %.3576.i.i.i = bitcast double %.3573.i.i.i to i64
  %.3577.i.i.i = add nsw i64 %.3576.i.i.i, -4604544271217802189
  %.3578.i.i.i = ashr i64 %.3577.i.i.i, 52
  %.3579.i.i.i = and i64 %.3577.i.i.i, -4503599627370496
  %.3580.i.i.i = sub nsw i64 %.3576.i.i.i, %.3579.i.i.i
  %.3581.i.i.i = bitcast i64 %.3580.i.i.i to double
  %.3582.i.i.i = fadd contract double %.3581.i.i.i, -1.000000e+00
  %.3583.i.i.i = fadd contract double %.3582.i.i.i, 2.000000e+00
  %.3587.i.i.i = fdiv contract double %.3582.i.i.i, %.3583.i.i.i
  %.3588.i.i.i = fmul contract double %.3587.i.i.i, %.3587.i.i.i
  %.3589.i.i.i = fmul contract double %.3588.i.i.i, %.3588.i.i.i
  %.3590.i.i.i = fmul contract double %.3589.i.i.i, 0x3FC39A09D078C69F
  %.3591.i.i.i = fadd contract double %.3590.i.i.i, 0x3FCC71C51D8E78AF
  %.3592.i.i.i = fmul contract double %.3589.i.i.i, %.3591.i.i.i
  %.3593.i.i.i = fadd contract double %.3592.i.i.i, 0x3FD999999997FA04
  %.3594.i.i.i = fmul contract double %.3589.i.i.i, %.3593.i.i.i
  %.3595.i.i.i = fmul contract double %.3589.i.i.i, 0x3FC2F112DF3E5244
  %.3596.i.i.i = fadd contract double %.3595.i.i.i, 0x3FC7466496CB03DE
  %.3597.i.i.i = fmul contract double %.3589.i.i.i, %.3596.i.i.i
  %.3598.i.i.i = fadd contract double %.3597.i.i.i, 0x3FD2492494229359
  %.3599.i.i.i = fmul contract double %.3589.i.i.i, %.3598.i.i.i
  %.3600.i.i.i = fadd contract double %.3599.i.i.i, 0x3FE5555555555593
  %.3601.i.i.i = fmul contract double %.3588.i.i.i, %.3600.i.i.i
  %.3602.i.i.i = fadd contract double %.3594.i.i.i, %.3601.i.i.i
  %.3603.i.i.i = fmul contract double %.3582.i.i.i, 5.000000e-01
  %.3604.i.i.i = fmul contract double %.3582.i.i.i, %.3603.i.i.i
  %.3605.i.i.i = add nsw i64 %.3578.i.i.i, 4843621399236968448
  %.3606.i.i.i = bitcast i64 %.3605.i.i.i to double
  %.3607.i.i.i = fadd contract double %.3606.i.i.i, 0xC338000000000000
  %.3608.i.i.i = fmul contract double %.3607.i.i.i, 0x3FE62E42FEE00000
  %.3609.i.i.i = fadd contract double %.3604.i.i.i, %.3602.i.i.i
  %.3610.i.i.i = fmul contract double %.3587.i.i.i, %.3609.i.i.i
  %.3611.i.i.i = fmul contract double %.3607.i.i.i, 0x3DEA39EF35793C76
  %.3612.i.i.i = fadd contract double %.3611.i.i.i, %.3610.i.i.i
  %.3613.i.i.i = fsub contract double %.3604.i.i.i, %.3612.i.i.i
  %.3614.i.i.i = fsub contract double %.3613.i.i.i, %.3582.i.i.i
  %.3615.i.i.i = fsub contract double %.3608.i.i.i, %.3614.i.i.i
  %.3617.i.i.i = sitofp i64 %halvings.3.0.i.i.i.i to double
  %.3618.i.i.i = fmul contract double %.3617.i.i.i, 0x3FE62E42FEFA39EF
  %.3621.i.i.i = fsub contract double %.3615.i.i.i, %.3618.i.i.i
  %.3622.i.i.i = fadd contract double %.3621.i.i.i, %.3536.i.i.i
  %133 = freeze double %.3622.i.i.i
  br label %_ZN17bnserve_inference15marginal_kernel7_circle10_integrateB3v19B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedEx8UniTupleIdLi3EEd5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i.i

B758.if.lr.ph.i.i.i:                              ; preds = %_ZN17bnserve_inference15marginal_kernel7_circle7_surveyB3v29B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedExx8UniTupleIdLi3EEd5ArrayIdLi1E1C7mutable7alignedE.exit.i.i.i
  %.1405.i.i.i = uitofp nneg i64 %cells.2.0.i.i.i.i to double
  %.1409.i.i.i = fdiv contract double 0x400921FB54442D18, %.1405.i.i.i
  %134 = getelementptr double, ptr %1, i64 %.598.i.i
  %.idx.i.i.i.i = shl i64 %.598.i.i, 4
  %135 = getelementptr i8, ptr %1, i64 %.idx.i.i.i.i
  %.idx288.i.i.i.i = mul i64 %.598.i.i, 24
  %136 = getelementptr i8, ptr %1, i64 %.idx288.i.i.i.i
  %.990.i.i.i.i = fmul contract double %size_n.2.0.lcssa.i.i, 1.000000e-09
  %.991.i.i.i.i = fadd contract double %.990.i.i.i.i, 0x10000000000000
  %.1020.i.i.i.i = fneg contract double %.991.i.i.i.i
  %.1021.i.i.i.i = insertelement <8 x double> poison, double %.1020.i.i.i.i, i64 0
  %.1022.i.i.i.i = shufflevector <8 x double> %.1021.i.i.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1197.i.i.i.i = fneg contract double %.533.i.i.i
  %.1198.i.i.i.i = insertelement <8 x double> poison, double %.1197.i.i.i.i, i64 0
  %.1199.i.i.i.i = shufflevector <8 x double> %.1198.i.i.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1225.i.i.i.i = insertelement <8 x double> poison, double %.563.i.i.i, i64 0
  %.1226.i.i.i.i = shufflevector <8 x double> %.1225.i.i.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %scevgep306.i.i.i = getelementptr i8, ptr %.1620.i.i, i64 448
  %.1532.prol.i.i.i = fmul contract double %.1409.i.i.i, 5.000000e-01
  %.1532.1.prol.i.i.i = fmul contract double %.1532.prol.i.i.i, 5.000000e-01
  %.1532.2.prol.i.i.i = fmul contract double %.1532.1.prol.i.i.i, 5.000000e-01
  %.1532.3.prol.i.i.i = fmul contract double %.1532.2.prol.i.i.i, 5.000000e-01
  %.1532.4.prol.i.i.i = fmul contract double %.1532.3.prol.i.i.i, 5.000000e-01
  %.1532.5.prol.i.i.i = fmul contract double %.1532.4.prol.i.i.i, 5.000000e-01
  %.1532.6.prol.i.i.i = fmul contract double %.1532.5.prol.i.i.i, 5.000000e-01
  %.1532.7.prol.i.i.i = fmul contract double %.1532.6.prol.i.i.i, 5.000000e-01
  %sunkaddr175.i.i.i = getelementptr i8, ptr %.1620.i.i, i64 11912
  %sunkaddr176.i.i.i = getelementptr i8, ptr %.1620.i.i, i64 11920
  %sunkaddr177.i.i.i = getelementptr i8, ptr %.1620.i.i, i64 11928
  %sunkaddr178.i.i.i = getelementptr i8, ptr %.1620.i.i, i64 11936
  %sunkaddr179.i.i.i = getelementptr i8, ptr %.1620.i.i, i64 11944
  %sunkaddr180.i.i.i = getelementptr i8, ptr %.1620.i.i, i64 11952
  %sunkaddr181.i.i.i = getelementptr i8, ptr %.1620.i.i, i64 11960
  %sunkaddr182.i.i.i = getelementptr i8, ptr %.1620.i.i, i64 11968
  %sunkaddr183.i.i.i = getelementptr i8, ptr %.1620.i.i, i64 11976
  %sunkaddr184.i.i.i = getelementptr i8, ptr %.1620.i.i, i64 8
  %sunkaddr185.i.i.i = getelementptr i8, ptr %.1620.i.i, i64 16
  %sunkaddr186.i.i.i = getelementptr i8, ptr %.1620.i.i, i64 24
  %sunkaddr187.i.i.i = getelementptr i8, ptr %.1620.i.i, i64 32
  %sunkaddr188.i.i.i = getelementptr i8, ptr %.1620.i.i, i64 40
  %sunkaddr189.i.i.i = getelementptr i8, ptr %.1620.i.i, i64 48
  %sunkaddr190.i.i.i = getelementptr i8, ptr %.1620.i.i, i64 56
  %sunkaddr191.i.i.i = getelementptr inbounds nuw i8, ptr %.1620.i.i, i64 64
  %sunkaddr192.i.i.i = getelementptr inbounds nuw i8, ptr %.1620.i.i, i64 128
  %sunkaddr193.i.i.i = getelementptr inbounds nuw i8, ptr %.1620.i.i, i64 192
  %sunkaddr194.i.i.i = getelementptr inbounds nuw i8, ptr %.1620.i.i, i64 256
  %sunkaddr195.i.i.i = getelementptr inbounds nuw i8, ptr %.1620.i.i, i64 320
  %sunkaddr196.i.i.i = getelementptr inbounds nuw i8, ptr %.1620.i.i, i64 384
  %sunkaddr198.i.i.i = getelementptr inbounds nuw i8, ptr %.1620.i.i, i64 512
  %.53.i.i.i.i = getelementptr inbounds nuw i8, ptr %.1620.i.i, i64 14384
  %137 = getelementptr i8, ptr %.1620.i.i, i64 14416
  %138 = icmp eq i64 %.632.i.i.i, 1
  br label %B758.if.i.i.i

B758.if.i.i.i:                                    ; preds = %B758.if.lr.ph.i.i.i, %B2924.i.i.i
  %others.8.02220.i.i.i = phi i64 [ 0, %B758.if.lr.ph.i.i.i ], [ %others.9.3.i.i.i, %B2924.i.i.i ]
  %normals.9.02219.i.i.i = phi i64 [ 0, %B758.if.lr.ph.i.i.i ], [ %normals.10.3.i.i.i, %B2924.i.i.i ]
  %best.5.02218.i.i.i = phi double [ %best.9.1.i.i.i.i, %B758.if.lr.ph.i.i.i ], [ %best.2.4.lcssa.i.i.i, %B2924.i.i.i ]
  %.87920852217.i.i.i = phi i64 [ %.859.i.i.i, %B758.if.lr.ph.i.i.i ], [ %.889.i.i.i, %B2924.i.i.i ]
  %.88620932216.i.i.i = phi i64 [ 0, %B758.if.lr.ph.i.i.i ], [ %.893.i.i.i, %B2924.i.i.i ]
  %.889.i.i.i = add nsw i64 %.87920852217.i.i.i, -1
  %.893.i.i.i = add nuw i64 %.88620932216.i.i.i, 8
  %.1069.i.i.i = sitofp i64 %.88620932216.i.i.i to double
  store double %.1069.i.i.i, ptr %.447.i.i.i, align 8, !noalias !6
  %.1039.1.i.i.i = or disjoint i64 %.88620932216.i.i.i, 1
  %.1069.1.i.i.i = sitofp i64 %.1039.1.i.i.i to double
  store double %.1069.1.i.i.i, ptr %sunkaddr175.i.i.i, align 8, !noalias !6
  %.1039.2.i.i.i = or disjoint i64 %.88620932216.i.i.i, 2
  %.1069.2.i.i.i = sitofp i64 %.1039.2.i.i.i to double
  store double %.1069.2.i.i.i, ptr %sunkaddr176.i.i.i, align 8, !noalias !6
  %.1039.3.i.i.i = or disjoint i64 %.88620932216.i.i.i, 3
  %.1069.3.i.i.i = sitofp i64 %.1039.3.i.i.i to double
  store double %.1069.3.i.i.i, ptr %sunkaddr177.i.i.i, align 8, !noalias !6
  %.1039.4.i.i.i = or disjoint i64 %.88620932216.i.i.i, 4
  %.1069.4.i.i.i = sitofp i64 %.1039.4.i.i.i to double
  store double %.1069.4.i.i.i, ptr %sunkaddr178.i.i.i, align 8, !noalias !6
  %.1039.5.i.i.i = or disjoint i64 %.88620932216.i.i.i, 5
  %.1069.5.i.i.i = sitofp i64 %.1039.5.i.i.i to double
  store double %.1069.5.i.i.i, ptr %sunkaddr179.i.i.i, align 8, !noalias !6
  %.1039.6.i.i.i = or disjoint i64 %.88620932216.i.i.i, 6
  %.1069.6.i.i.i = sitofp i64 %.1039.6.i.i.i to double
  store double %.1069.6.i.i.i, ptr %sunkaddr180.i.i.i, align 8, !noalias !6
  %.1039.7.i.i.i = or disjoint i64 %.88620932216.i.i.i, 7
  %.1069.7.i.i.i = sitofp i64 %.1039.7.i.i.i to double
  store double %.1069.7.i.i.i, ptr %sunkaddr181.i.i.i, align 8, !noalias !6
  store double 8.000000e+00, ptr %sunkaddr182.i.i.i, align 8, !noalias !6
  store double 0.000000e+00, ptr %sunkaddr183.i.i.i, align 8, !noalias !6
  br label %B900.outer.i.i.i

B900.outer.i.i.i:                                 ; preds = %B758.if.i.i.i, %B2792.i.i.i
  %best.3.2.ph.i.i.i = phi double [ %best.5.02218.i.i.i, %B758.if.i.i.i ], [ %best.2.4.lcssa.i.i.i, %B2792.i.i.i ]
  %normals.7.2.ph.i.i.i = phi i64 [ %normals.9.02219.i.i.i, %B758.if.i.i.i ], [ %normals.3.4.lcssa.i.i.i, %B2792.i.i.i ]
  %others.6.2.ph.i.i.i = phi i64 [ %others.8.02220.i.i.i, %B758.if.i.i.i ], [ %others.3.4.lcssa.i.i.i, %B2792.i.i.i ]
  %waiting.4.2.ph.i.i.i = phi i64 [ 1, %B758.if.i.i.i ], [ %.1211.i.i.i, %B2792.i.i.i ]
  br label %B900.i.i.i

B1152.if.i.i.i:                                   ; preds = %B1152.if.i.i.i, %B1152.if.preheader147.i.i.i
  %lsr.iv.i.i.i = phi i64 [ %lsr.iv.next.1.i.i.i, %B1152.if.i.i.i ], [ %lsr.iv.unr.i.i.i, %B1152.if.preheader147.i.i.i ]
  %half.2.41898.i.i.i = phi double [ %.1532.7.1.i.i.i, %B1152.if.i.i.i ], [ %half.2.41898.unr.i.i.i, %B1152.if.preheader147.i.i.i ]
  %.1532.i.i.i = fmul contract double %half.2.41898.i.i.i, 5.000000e-01
  %.1532.1.i.i.i = fmul contract double %.1532.i.i.i, 5.000000e-01
  %.1532.2.i.i.i = fmul contract double %.1532.1.i.i.i, 5.000000e-01
  %.1532.3.i.i.i = fmul contract double %.1532.2.i.i.i, 5.000000e-01
  %.1532.4.i.i.i = fmul contract double %.1532.3.i.i.i, 5.000000e-01
  %.1532.5.i.i.i = fmul contract double %.1532.4.i.i.i, 5.000000e-01
  %.1532.6.i.i.i = fmul contract double %.1532.5.i.i.i, 5.000000e-01
  %.1532.7.i.i.i = fmul contract double %.1532.6.i.i.i, 5.000000e-01
  %.1532.1122.i.i.i = fmul contract double %.1532.7.i.i.i, 5.000000e-01
  %.1532.1.1.i.i.i = fmul contract double %.1532.1122.i.i.i, 5.000000e-01
  %.1532.2.1.i.i.i = fmul contract double %.1532.1.1.i.i.i, 5.000000e-01
  %.1532.3.1.i.i.i = fmul contract double %.1532.2.1.i.i.i, 5.000000e-01
  %.1532.4.1.i.i.i = fmul contract double %.1532.3.1.i.i.i, 5.000000e-01
  %.1532.5.1.i.i.i = fmul contract double %.1532.4.1.i.i.i, 5.000000e-01
  %.1532.6.1.i.i.i = fmul contract double %.1532.5.1.i.i.i, 5.000000e-01
  %.1532.7.1.i.i.i = fmul contract double %.1532.6.1.i.i.i, 5.000000e-01
  %lsr.iv.next.1.i.i.i = add nsw i64 %lsr.iv.i.i.i, -16
  %niter.ncmp.7.1.i.i.i = icmp eq i64 %lsr.iv.next.1.i.i.i, 0
  br i1 %niter.ncmp.7.1.i.i.i, label %B1208.if.loopexit.unr-lcssa.i.i.i, label %B1152.if.i.i.i

B1208.if.loopexit.unr-lcssa.i.i.i:                ; preds = %B1152.if.i.i.i, %B1152.if.preheader.new.i.i.i
  %.1532.7.lcssa.i.i.i = phi double [ %.1532.7.prol.i.i.i, %B1152.if.preheader.new.i.i.i ], [ %.1532.7.1.i.i.i, %B1152.if.i.i.i ]
  %lcmp.mod.not.i.i.i = icmp eq i64 %xtraiter.i.i.i, 0
  br i1 %lcmp.mod.not.i.i.i, label %B1208.if.i.i.i, label %B1152.if.epil.i.i.i.preheader

B1152.if.epil.i.i.i.preheader:                    ; preds = %B1208.if.loopexit.unr-lcssa.i.i.i, %B1152.if.preheader.i.i.i
  %half.2.41898.epil.i.i.i.ph = phi double [ %.1409.i.i.i, %B1152.if.preheader.i.i.i ], [ %.1532.7.lcssa.i.i.i, %B1208.if.loopexit.unr-lcssa.i.i.i ]
  br label %B1152.if.epil.i.i.i

B1152.if.epil.i.i.i:                              ; preds = %B1152.if.epil.i.i.i.preheader, %B1152.if.epil.i.i.i
  %lsr.iv296.i.i.i = phi i64 [ %lsr.iv.next297.i.i.i, %B1152.if.epil.i.i.i ], [ %xtraiter.i.i.i, %B1152.if.epil.i.i.i.preheader ]
  %half.2.41898.epil.i.i.i = phi double [ %.1532.epil.i.i.i, %B1152.if.epil.i.i.i ], [ %half.2.41898.epil.i.i.i.ph, %B1152.if.epil.i.i.i.preheader ]
  %.1532.epil.i.i.i = fmul contract double %half.2.41898.epil.i.i.i, 5.000000e-01
  %lsr.iv.next297.i.i.i = add nsw i64 %lsr.iv296.i.i.i, -1
  %epil.iter.cmp.not.i.i.i = icmp eq i64 %lsr.iv.next297.i.i.i, 0
  br i1 %epil.iter.cmp.not.i.i.i, label %B1208.if.i.i.i, label %B1152.if.epil.i.i.i, !llvm.loop !31

B1208.if.i.i.i:                                   ; preds = %B1152.if.epil.i.i.i, %B1208.if.loopexit.unr-lcssa.i.i.i, %B900.i.i.i
  %half.2.4.lcssa.i.i.i = phi double [ %.1409.i.i.i, %B900.i.i.i ], [ %.1532.7.lcssa.i.i.i, %B1208.if.loopexit.unr-lcssa.i.i.i ], [ %.1532.epil.i.i.i, %B1152.if.epil.i.i.i ]
  %sunkaddr335.i.i.i = getelementptr i8, ptr %.1620.i.i, i64 %.1232.idx.i.i.i
  %sunkaddr336.i.i.i = getelementptr i8, ptr %sunkaddr335.i.i.i, i64 11904
  %.1686.i.i.i = load double, ptr %sunkaddr336.i.i.i, align 8, !noalias !6
  %.1687.i.i.i = fmul contract double %.1686.i.i.i, 2.000000e+00
  %.1688.i.i.i = fadd contract double %.1687.i.i.i, 1.000000e+00
  %.1690.i.i.i = fmul contract double %half.2.4.lcssa.i.i.i, %.1688.i.i.i
  store double %.1690.i.i.i, ptr %.1620.i.i, align 8, !noalias !6
  %sunkaddr338.i.i.i = getelementptr i8, ptr %sunkaddr335.i.i.i, i64 11912
  %.1686.1.i.i.i = load double, ptr %sunkaddr338.i.i.i, align 8, !noalias !6
  %.1687.1.i.i.i = fmul contract double %.1686.1.i.i.i, 2.000000e+00
  %.1688.1.i.i.i = fadd contract double %.1687.1.i.i.i, 1.000000e+00
  %.1690.1.i.i.i = fmul contract double %half.2.4.lcssa.i.i.i, %.1688.1.i.i.i
  store double %.1690.1.i.i.i, ptr %sunkaddr184.i.i.i, align 8, !noalias !6
  %sunkaddr341.i.i.i = getelementptr i8, ptr %sunkaddr335.i.i.i, i64 11920
  %.1686.2.i.i.i = load double, ptr %sunkaddr341.i.i.i, align 8, !noalias !6
  %.1687.2.i.i.i = fmul contract double %.1686.2.i.i.i, 2.000000e+00
  %.1688.2.i.i.i = fadd contract double %.1687.2.i.i.i, 1.000000e+00
  %.1690.2.i.i.i = fmul contract double %half.2.4.lcssa.i.i.i, %.1688.2.i.i.i
  store double %.1690.2.i.i.i, ptr %sunkaddr185.i.i.i, align 8, !noalias !6
  %sunkaddr344.i.i.i = getelementptr i8, ptr %sunkaddr335.i.i.i, i64 11928
  %.1686.3.i.i.i = load double, ptr %sunkaddr344.i.i.i, align 8, !noalias !6
  %.1687.3.i.i.i = fmul contract double %.1686.3.i.i.i, 2.000000e+00
  %.1688.3.i.i.i = fadd contract double %.1687.3.i.i.i, 1.000000e+00
  %.1690.3.i.i.i = fmul contract double %half.2.4.lcssa.i.i.i, %.1688.3.i.i.i
  store double %.1690.3.i.i.i, ptr %sunkaddr186.i.i.i, align 8, !noalias !6
  %sunkaddr347.i.i.i = getelementptr i8, ptr %sunkaddr335.i.i.i, i64 11936
  %.1686.4.i.i.i = load double, ptr %sunkaddr347.i.i.i, align 8, !noalias !6
  %.1687.4.i.i.i = fmul contract double %.1686.4.i.i.i, 2.000000e+00
  %.1688.4.i.i.i = fadd contract double %.1687.4.i.i.i, 1.000000e+00
  %.1690.4.i.i.i = fmul contract double %half.2.4.lcssa.i.i.i, %.1688.4.i.i.i
  store double %.1690.4.i.i.i, ptr %sunkaddr187.i.i.i, align 8, !noalias !6
  %sunkaddr350.i.i.i = getelementptr i8, ptr %sunkaddr335.i.i.i, i64 11944
  %.1686.5.i.i.i = load double, ptr %sunkaddr350.i.i.i, align 8, !noalias !6
  %.1687.5.i.i.i = fmul contract double %.1686.5.i.i.i, 2.000000e+00
  %.1688.5.i.i.i = fadd contract double %.1687.5.i.i.i, 1.000000e+00
  %.1690.5.i.i.i = fmul contract double %half.2.4.lcssa.i.i.i, %.1688.5.i.i.i
  store double %.1690.5.i.i.i, ptr %sunkaddr188.i.i.i, align 8, !noalias !6
  %sunkaddr353.i.i.i = getelementptr i8, ptr %sunkaddr335.i.i.i, i64 11952
  %.1686.6.i.i.i = load double, ptr %sunkaddr353.i.i.i, align 8, !noalias !6
  %.1687.6.i.i.i = fmul contract double %.1686.6.i.i.i, 2.000000e+00
  %.1688.6.i.i.i = fadd contract double %.1687.6.i.i.i, 1.000000e+00
  %.1690.6.i.i.i = fmul contract double %half.2.4.lcssa.i.i.i, %.1688.6.i.i.i
  store double %.1690.6.i.i.i, ptr %sunkaddr189.i.i.i, align 8, !noalias !6
  %sunkaddr356.i.i.i = getelementptr i8, ptr %sunkaddr335.i.i.i, i64 11960
  %.1686.7.i.i.i = load double, ptr %sunkaddr356.i.i.i, align 8, !noalias !6
  %.1687.7.i.i.i = fmul contract double %.1686.7.i.i.i, 2.000000e+00
  %.1688.7.i.i.i = fadd contract double %.1687.7.i.i.i, 1.000000e+00
  %.1690.7.i.i.i = fmul contract double %half.2.4.lcssa.i.i.i, %.1688.7.i.i.i
  store double %.1690.7.i.i.i, ptr %sunkaddr190.i.i.i, align 8, !noalias !6
  %.66.i.i.i.i = load <8 x double>, ptr %.1620.i.i, align 8, !noalias !32
  %.71.i.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.66.i.i.i.i, <8 x double> splat (double 0x3FE45F306DC9C883), <8 x double> splat (double 0x4338000000000000))
  %.8.i.i.i.i.i = fadd contract <8 x double> %.71.i.i.i.i, splat (double 0xC338000000000000)
  %.114.i.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i.i.i.i.i, <8 x double> splat (double 0xBFF921FB54442D18), <8 x double> %.66.i.i.i.i)
  %.131.i.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i.i.i.i.i, <8 x double> splat (double 0xBC91A62633145C07), <8 x double> %.114.i.i.i.i)
  %.6.i.i.i.i.i = fmul contract <8 x double> %.131.i.i.i.i, %.131.i.i.i.i
  %.6.i20.i.i.i.i = fmul contract <8 x double> %.131.i.i.i.i, %.6.i.i.i.i.i
  %.160.i.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i.i.i.i, <8 x double> splat (double 0xBD6AE7F3E733B81F), <8 x double> splat (double 0x3DE6124613A86D09))
  %.163.i.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i.i.i.i, <8 x double> %.160.i.i.i.i, <8 x double> splat (double 0xBE5AE64567F544E4))
  %.166.i.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i.i.i.i, <8 x double> %.163.i.i.i.i, <8 x double> splat (double 0x3EC71DE3A556C734))
  %.169.i.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i.i.i.i, <8 x double> %.166.i.i.i.i, <8 x double> splat (double 0xBF2A01A01A01A01A))
  %.172.i.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i.i.i.i, <8 x double> %.169.i.i.i.i, <8 x double> splat (double 0x3F81111111111111))
  %.175.i.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i.i.i.i, <8 x double> %.172.i.i.i.i, <8 x double> splat (double 0xBFC5555555555555))
  %.200.i.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i20.i.i.i.i, <8 x double> %.175.i.i.i.i, <8 x double> %.131.i.i.i.i)
  %.205.i.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i.i.i.i, <8 x double> splat (double 0x3D2AE7F3E733B81F), <8 x double> splat (double 0xBDA93974A8C07C9D))
  %.208.i.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i.i.i.i, <8 x double> %.205.i.i.i.i, <8 x double> splat (double 0x3E21EED8EFF8D898))
  %.211.i.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i.i.i.i, <8 x double> %.208.i.i.i.i, <8 x double> splat (double 0xBE927E4FB7789F5C))
  %.214.i.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i.i.i.i, <8 x double> %.211.i.i.i.i, <8 x double> splat (double 0x3EFA01A01A01A01A))
  %.217.i.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i.i.i.i, <8 x double> %.214.i.i.i.i, <8 x double> splat (double 0xBF56C16C16C16C17))
  %.220.i.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i.i.i.i, <8 x double> %.217.i.i.i.i, <8 x double> splat (double 0x3FA5555555555555))
  %.223.i.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i.i.i.i, <8 x double> %.220.i.i.i.i, <8 x double> splat (double -5.000000e-01))
  %.226.i.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i.i.i.i, <8 x double> %.223.i.i.i.i, <8 x double> splat (double 1.000000e+00))
  %.227.i.i.i.i = bitcast <8 x double> %.71.i.i.i.i to <8 x i64>
  %.228.i.i.i.i = bitcast <8 x double> %.200.i.i.i.i to <8 x i64>
  %.229.i.i.i.i = bitcast <8 x double> %.226.i.i.i.i to <8 x i64>
  %.6.i21.i.i.i.i = xor <8 x i64> %.229.i.i.i.i, %.228.i.i.i.i
  %.8.i22.i.i.i.i = and <8 x i64> %.227.i.i.i.i, splat (i64 1)
  %139 = icmp eq <8 x i64> %.8.i22.i.i.i.i, zeroinitializer
  %.6.i24.i.i.i.i = select <8 x i1> %139, <8 x i64> zeroinitializer, <8 x i64> %.6.i21.i.i.i.i
  %.8.i25.i.i.i.i = shl <8 x i64> %.227.i.i.i.i, splat (i64 62)
  %.8.i26.i.i.i.i = and <8 x i64> %.8.i25.i.i.i.i, splat (i64 -9223372036854775808)
  %.8.i28.i.i.i.i = add <8 x i64> %.8.i25.i.i.i.i, splat (i64 4611686018427387904)
  %.8.i29.i.i.i.i = and <8 x i64> %.8.i28.i.i.i.i, splat (i64 -9223372036854775808)
  %140 = xor <8 x i64> %.8.i26.i.i.i.i, %.228.i.i.i.i
  %.6.i31.i.i.i.i = xor <8 x i64> %140, %.6.i24.i.i.i.i
  %141 = bitcast <8 x i64> %.6.i31.i.i.i.i to <8 x double>
  %142 = xor <8 x i64> %.8.i29.i.i.i.i, %.229.i.i.i.i
  %.6.i33.i.i.i.i = xor <8 x i64> %142, %.6.i24.i.i.i.i
  %143 = bitcast <8 x i64> %.6.i33.i.i.i.i to <8 x double>
  store <8 x i64> %.6.i33.i.i.i.i, ptr %sunkaddr191.i.i.i, align 8, !noalias !32
  store <8 x i64> %.6.i31.i.i.i.i, ptr %sunkaddr192.i.i.i, align 8, !noalias !32
  br i1 %.711.i.i, label %_ZN17bnserve_inference15marginal_kernel7_circle10_at_phasesB3v30B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedExd8UniTupleIdLi3EEdd.exit.i.i.i, label %B356.if.i.i.i.i

B904.loopexit.i.i.i.i:                            ; preds = %B356.if.i.i.i.i
  %144 = tail call <8 x double> @llvm.fabs.v8f64(<8 x double> %.864.i.i.i.i)
  %145 = tail call <8 x double> @llvm.fabs.v8f64(<8 x double> %.879.i.i.i.i)
  br label %_ZN17bnserve_inference15marginal_kernel7_circle10_at_phasesB3v30B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedExd8UniTupleIdLi3EEdd.exit.i.i.i

B356.if.i.i.i.i:                                  ; preds = %B1208.if.i.i.i, %B356.if.i.i.i.i
  %dn.2.0318.i.i.i.i = phi <8 x double> [ %.879.i.i.i.i, %B356.if.i.i.i.i ], [ zeroinitializer, %B1208.if.i.i.i ]
  %dx.2.0317.i.i.i.i = phi <8 x double> [ %.864.i.i.i.i, %B356.if.i.i.i.i ], [ zeroinitializer, %B1208.if.i.i.i ]
  %n.3.0316.i.i.i.i = phi <8 x double> [ %.849.i.i.i.i, %B356.if.i.i.i.i ], [ zeroinitializer, %B1208.if.i.i.i ]
  %x.2.0315.i.i.i.i = phi <8 x double> [ %.837.i.i.i.i, %B356.if.i.i.i.i ], [ zeroinitializer, %B1208.if.i.i.i ]
  %real.2.0314.i.i.i.i = phi <8 x double> [ %.934.i.i.i.i, %B356.if.i.i.i.i ], [ splat (double 1.000000e+00), %B1208.if.i.i.i ]
  %imaginary.2.0313.i.i.i.i = phi <8 x double> [ %.963.i.i.i.i, %B356.if.i.i.i.i ], [ zeroinitializer, %B1208.if.i.i.i ]
  %.728307311.i.i.i.i = phi i64 [ %.735.i.i.i.i, %B356.if.i.i.i.i ], [ 0, %B1208.if.i.i.i ]
  %.735.i.i.i.i = add nuw nsw i64 %.728307311.i.i.i.i, 1
  %146 = shl i64 %.728307311.i.i.i.i, 3
  %scevgep65.i.i.i.i = getelementptr i8, ptr %1, i64 %146
  %.768.i.i.i.i = load double, ptr %scevgep65.i.i.i.i, align 8, !noalias !32
  %scevgep64.i.i.i.i = getelementptr i8, ptr %134, i64 %146
  %.779.i.i.i.i = load double, ptr %scevgep64.i.i.i.i, align 8, !noalias !32
  %scevgep63.i.i.i.i = getelementptr i8, ptr %135, i64 %146
  %.791.i.i.i.i = load double, ptr %scevgep63.i.i.i.i, align 8, !noalias !32
  %scevgep145.i.i.i = getelementptr i8, ptr %136, i64 %146
  %.803.i.i.i.i = load double, ptr %scevgep145.i.i.i, align 8, !noalias !32
  %.828.i.i.i.i = fneg contract double %.779.i.i.i.i
  %.831.i.i.i.i = insertelement <8 x double> poison, double %.828.i.i.i.i, i64 0
  %.832.i.i.i.i = shufflevector <8 x double> %.831.i.i.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.833.i.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %imaginary.2.0313.i.i.i.i, <8 x double> %.832.i.i.i.i, <8 x double> %x.2.0315.i.i.i.i)
  %.835.i.i.i.i = insertelement <8 x double> poison, double %.768.i.i.i.i, i64 0
  %.836.i.i.i.i = shufflevector <8 x double> %.835.i.i.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.837.i.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %real.2.0314.i.i.i.i, <8 x double> %.836.i.i.i.i, <8 x double> %.833.i.i.i.i)
  %.840.i.i.i.i = fneg contract double %.803.i.i.i.i
  %.843.i.i.i.i = insertelement <8 x double> poison, double %.840.i.i.i.i, i64 0
  %.844.i.i.i.i = shufflevector <8 x double> %.843.i.i.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.845.i.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %imaginary.2.0313.i.i.i.i, <8 x double> %.844.i.i.i.i, <8 x double> %n.3.0316.i.i.i.i)
  %.847.i.i.i.i = insertelement <8 x double> poison, double %.791.i.i.i.i, i64 0
  %.848.i.i.i.i = shufflevector <8 x double> %.847.i.i.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.849.i.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %real.2.0314.i.i.i.i, <8 x double> %.848.i.i.i.i, <8 x double> %.845.i.i.i.i)
  %.852.i.i.i.i = uitofp nneg i64 %.728307311.i.i.i.i to double
  %.853.i.i.i.i = fmul contract double %.779.i.i.i.i, %.852.i.i.i.i
  %.855.i.i.i.i = fmul contract double %.768.i.i.i.i, %.852.i.i.i.i
  %.858.i.i.i.i = insertelement <8 x double> poison, double %.855.i.i.i.i, i64 0
  %.859.i.i.i.i = shufflevector <8 x double> %.858.i.i.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.860.i.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %imaginary.2.0313.i.i.i.i, <8 x double> %.859.i.i.i.i, <8 x double> %dx.2.0317.i.i.i.i)
  %.862.i.i.i.i = insertelement <8 x double> poison, double %.853.i.i.i.i, i64 0
  %.863.i.i.i.i = shufflevector <8 x double> %.862.i.i.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.864.i.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %real.2.0314.i.i.i.i, <8 x double> %.863.i.i.i.i, <8 x double> %.860.i.i.i.i)
  %.868.i.i.i.i = fmul contract double %.803.i.i.i.i, %.852.i.i.i.i
  %.870.i.i.i.i = fmul contract double %.791.i.i.i.i, %.852.i.i.i.i
  %.873.i.i.i.i = insertelement <8 x double> poison, double %.870.i.i.i.i, i64 0
  %.874.i.i.i.i = shufflevector <8 x double> %.873.i.i.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.875.i.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %imaginary.2.0313.i.i.i.i, <8 x double> %.874.i.i.i.i, <8 x double> %dn.2.0318.i.i.i.i)
  %.877.i.i.i.i = insertelement <8 x double> poison, double %.868.i.i.i.i, i64 0
  %.878.i.i.i.i = shufflevector <8 x double> %.877.i.i.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.879.i.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %real.2.0314.i.i.i.i, <8 x double> %.878.i.i.i.i, <8 x double> %.875.i.i.i.i)
  %.6.i34.i.i.i.i = fmul contract <8 x double> %imaginary.2.0313.i.i.i.i, %141
  %.8.i35.i.i.i.i = fsub contract <8 x double> zeroinitializer, %.6.i34.i.i.i.i
  %.6.i36.i.i.i.i = fmul contract <8 x double> %imaginary.2.0313.i.i.i.i, %143
  %.934.i.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %real.2.0314.i.i.i.i, <8 x double> %143, <8 x double> %.8.i35.i.i.i.i)
  %.963.i.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %real.2.0314.i.i.i.i, <8 x double> %141, <8 x double> %.6.i36.i.i.i.i)
  %exitcond.not.i.i.i.i = icmp eq i64 %.13.i.i.i, %.728307311.i.i.i.i
  br i1 %exitcond.not.i.i.i.i, label %B904.loopexit.i.i.i.i, label %B356.if.i.i.i.i

_ZN17bnserve_inference15marginal_kernel7_circle10_at_phasesB3v30B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedExd8UniTupleIdLi3EEdd.exit.i.i.i: ; preds = %B904.loopexit.i.i.i.i, %B1208.if.i.i.i
  %x.2.0.lcssa.i.i.i.i = phi <8 x double> [ zeroinitializer, %B1208.if.i.i.i ], [ %.837.i.i.i.i, %B904.loopexit.i.i.i.i ]
  %n.3.0.lcssa.i.i.i.i = phi <8 x double> [ zeroinitializer, %B1208.if.i.i.i ], [ %.849.i.i.i.i, %B904.loopexit.i.i.i.i ]
  %147 = phi <8 x double> [ zeroinitializer, %B1208.if.i.i.i ], [ %144, %B904.loopexit.i.i.i.i ]
  %148 = phi <8 x double> [ zeroinitializer, %B1208.if.i.i.i ], [ %145, %B904.loopexit.i.i.i.i ]
  %.8.i19.i.i.i.i = fsub contract <8 x double> zeroinitializer, %n.3.0.lcssa.i.i.i.i
  %.1023.i.i.i.i = tail call <8 x double> @llvm.minnum.v8f64(<8 x double> %.8.i19.i.i.i.i, <8 x double> %.1022.i.i.i.i)
  %.8.i37.i.i.i.i = fsub contract <8 x double> zeroinitializer, %.1023.i.i.i.i
  store <8 x double> %x.2.0.lcssa.i.i.i.i, ptr %sunkaddr193.i.i.i, align 8, !noalias !32
  store <8 x double> %.8.i37.i.i.i.i, ptr %sunkaddr194.i.i.i, align 8, !noalias !32
  %.6.i38.i.i.i.i = fdiv contract <8 x double> %x.2.0.lcssa.i.i.i.i, %.8.i37.i.i.i.i
  store <8 x double> %.6.i38.i.i.i.i, ptr %sunkaddr195.i.i.i, align 8, !noalias !32
  %.1108.i.i.i.i = tail call <8 x double> @llvm.sqrt.v8f64(<8 x double> %.8.i37.i.i.i.i)
  %.8.i39.i.i.i.i = fdiv contract <8 x double> splat (double 1.000000e+00), %.1108.i.i.i.i
  store <8 x double> %.8.i39.i.i.i.i, ptr %sunkaddr196.i.i.i, align 8, !noalias !32
  %.8.i41.i.i.i.i = fsub contract <8 x double> zeroinitializer, %.6.i38.i.i.i.i
  %.1200.i.i.i.i = tail call <8 x double> @llvm.minnum.v8f64(<8 x double> %.8.i41.i.i.i.i, <8 x double> %.1199.i.i.i.i)
  %.8.i42.i.i.i.i = fsub contract <8 x double> zeroinitializer, %.1200.i.i.i.i
  %.1227.i.i.i.i = tail call <8 x double> @llvm.minnum.v8f64(<8 x double> %.8.i42.i.i.i.i, <8 x double> %.1226.i.i.i.i)
  %.8.i43.i.i.i.i = fmul contract <8 x double> %.1227.i.i.i.i, splat (double 5.000000e-01)
  %.6.i44.i.i.i.i = fmul contract <8 x double> %.8.i37.i.i.i.i, %.8.i43.i.i.i.i
  %.6.i45.i.i.i.i = fsub contract <8 x double> %x.2.0.lcssa.i.i.i.i, %.6.i44.i.i.i.i
  %.6.i46.i.i.i.i = fmul contract <8 x double> %.1227.i.i.i.i, %.6.i45.i.i.i.i
  store <8 x double> %.6.i46.i.i.i.i, ptr %scevgep306.i.i.i, align 8, !noalias !32
  %.1366.i.i.i.i = insertelement <8 x double> poison, double %half.2.4.lcssa.i.i.i, i64 0
  %.1367.i.i.i.i = shufflevector <8 x double> %.1366.i.i.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1368.i.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %147, <8 x double> %.1367.i.i.i.i, <8 x double> %x.2.0.lcssa.i.i.i.i)
  %.1372.i.i.i.i = fmul contract double %half.2.4.lcssa.i.i.i, 5.000000e-01
  %.1374.i.i.i.i = fmul contract double %half.2.4.lcssa.i.i.i, %.1372.i.i.i.i
  %.1377.i.i.i.i = fmul contract double %bend_x.2.0.lcssa.i.i, %.1374.i.i.i.i
  %.6.i48.i.i.i.i = insertelement <8 x double> poison, double %.1377.i.i.i.i, i64 0
  %.7.i.i.i.i.i = shufflevector <8 x double> %.6.i48.i.i.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.8.i49.i.i.i.i = fadd contract <8 x double> %.7.i.i.i.i.i, %.1368.i.i.i.i
  %.1434.i.i.i.i = fneg contract double %half.2.4.lcssa.i.i.i
  %.1435.i.i.i.i = insertelement <8 x double> poison, double %.1434.i.i.i.i, i64 0
  %.1436.i.i.i.i = shufflevector <8 x double> %.1435.i.i.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1437.i.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %148, <8 x double> %.1436.i.i.i.i, <8 x double> %.8.i37.i.i.i.i)
  %.1451.i.i.i.i = fmul contract double %bend_n.2.0.lcssa.i.i, %.1374.i.i.i.i
  %.6.i51.i.i.i.i = insertelement <8 x double> poison, double %.1451.i.i.i.i, i64 0
  %.7.i52.i.i.i.i = shufflevector <8 x double> %.6.i51.i.i.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %149 = fsub contract <8 x double> %.7.i52.i.i.i.i, %.1437.i.i.i.i
  %.8.i54.i.i.i.i = fadd contract <8 x double> %149, zeroinitializer
  %.1503.i.i.i.i = tail call <8 x double> @llvm.minnum.v8f64(<8 x double> %.8.i54.i.i.i.i, <8 x double> %.1022.i.i.i.i)
  %.8.i55.i.i.i.i = fsub contract <8 x double> zeroinitializer, %.1503.i.i.i.i
  %.6.i56.i.i.i.i = fdiv contract <8 x double> %.8.i49.i.i.i.i, %.8.i55.i.i.i.i
  %.8.i57.i.i.i.i = fsub contract <8 x double> zeroinitializer, %.6.i56.i.i.i.i
  %.1588.i.i.i.i = tail call <8 x double> @llvm.minnum.v8f64(<8 x double> %.8.i57.i.i.i.i, <8 x double> %.1199.i.i.i.i)
  %.8.i58.i.i.i.i = fsub contract <8 x double> zeroinitializer, %.1588.i.i.i.i
  %.1615.i.i.i.i = tail call <8 x double> @llvm.minnum.v8f64(<8 x double> %.8.i58.i.i.i.i, <8 x double> %.1226.i.i.i.i)
  %.8.i59.i.i.i.i = fmul contract <8 x double> %.1615.i.i.i.i, splat (double 5.000000e-01)
  %.6.i60.i.i.i.i = fmul contract <8 x double> %.8.i55.i.i.i.i, %.8.i59.i.i.i.i
  %.6.i61.i.i.i.i = fsub contract <8 x double> %.8.i49.i.i.i.i, %.6.i60.i.i.i.i
  %.6.i62.i.i.i.i = fmul contract <8 x double> %.1615.i.i.i.i, %.6.i61.i.i.i.i
  store <8 x double> %.6.i62.i.i.i.i, ptr %sunkaddr198.i.i.i, align 8, !noalias !32
  %.1816.i.i.i = icmp sgt i64 %.5.i.i.i.i, 0
  br i1 %.1816.i.i.i, label %B1326.if.preheader.i.i.i, label %B1400.i.i.i

B1326.if.preheader.i.i.i:                         ; preds = %_ZN17bnserve_inference15marginal_kernel7_circle10_at_phasesB3v30B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedExd8UniTupleIdLi3EEdd.exit.i.i.i
  %xtraiter265.i.i.i = and i64 %.5.i.i.i.i, 3
  %150 = icmp ult i64 %.5.i.i.i.i, 4
  br i1 %150, label %B1326.if.epil.preheader.i.i.i, label %B1326.if.preheader.new.i.i.i

B1326.if.preheader.new.i.i.i:                     ; preds = %B1326.if.preheader.i.i.i
  %unroll_iter270.i.i.i = and i64 %.5.i.i.i.i, 9223372036854775804
  br label %B1326.if.i.i.i

B1326.if.i.i.i:                                   ; preds = %B1326.if.i.i.i, %B1326.if.preheader.new.i.i.i
  %best.2.41914.i.i.i = phi double [ %best.3.2.i.i.i, %B1326.if.preheader.new.i.i.i ], [ %.1927.best.2.4.3.i.i.i, %B1326.if.i.i.i ]
  %.186419101912.i.i.i = phi i64 [ 0, %B1326.if.preheader.new.i.i.i ], [ %.1871.3.i.i.i, %B1326.if.i.i.i ]
  %sunkaddr199.i.i.i = shl i64 %.186419101912.i.i.i, 3
  %sunkaddr200.i.i.i = getelementptr i8, ptr %.1620.i.i, i64 %sunkaddr199.i.i.i
  %sunkaddr201.i.i.i = getelementptr i8, ptr %sunkaddr200.i.i.i, i64 448
  %.1927.i.i.i = load double, ptr %sunkaddr201.i.i.i, align 8, !noalias !6
  %.1933.i.i.i = fcmp contract ogt double %.1927.i.i.i, %best.2.41914.i.i.i
  %.1927.best.2.4.i.i.i = select i1 %.1933.i.i.i, double %.1927.i.i.i, double %best.2.41914.i.i.i
  %sunkaddr204.i.i.i = getelementptr i8, ptr %sunkaddr200.i.i.i, i64 456
  %.1927.1.i.i.i = load double, ptr %sunkaddr204.i.i.i, align 8, !noalias !6
  %.1933.1.i.i.i = fcmp contract ogt double %.1927.1.i.i.i, %.1927.best.2.4.i.i.i
  %.1927.best.2.4.1.i.i.i = select i1 %.1933.1.i.i.i, double %.1927.1.i.i.i, double %.1927.best.2.4.i.i.i
  %sunkaddr207.i.i.i = getelementptr i8, ptr %sunkaddr200.i.i.i, i64 464
  %.1927.2.i.i.i = load double, ptr %sunkaddr207.i.i.i, align 8, !noalias !6
  %.1933.2.i.i.i = fcmp contract ogt double %.1927.2.i.i.i, %.1927.best.2.4.1.i.i.i
  %.1927.best.2.4.2.i.i.i = select i1 %.1933.2.i.i.i, double %.1927.2.i.i.i, double %.1927.best.2.4.1.i.i.i
  %.1871.3.i.i.i = add nuw nsw i64 %.186419101912.i.i.i, 4
  %sunkaddr210.i.i.i = getelementptr i8, ptr %sunkaddr200.i.i.i, i64 472
  %.1927.3.i.i.i = load double, ptr %sunkaddr210.i.i.i, align 8, !noalias !6
  %.1933.3.i.i.i = fcmp contract ogt double %.1927.3.i.i.i, %.1927.best.2.4.2.i.i.i
  %.1927.best.2.4.3.i.i.i = select i1 %.1933.3.i.i.i, double %.1927.3.i.i.i, double %.1927.best.2.4.2.i.i.i
  %niter271.ncmp.3.i.i.i = icmp eq i64 %unroll_iter270.i.i.i, %.1871.3.i.i.i
  br i1 %niter271.ncmp.3.i.i.i, label %B1400.loopexit.unr-lcssa.i.i.i, label %B1326.if.i.i.i

B1490.if.i.i.i:                                   ; preds = %B2764.i.i.i, %B1490.if.lr.ph.i.i.i
  %others.3.41928.i.i.i = phi i64 [ %others.6.2.ph.i.i.i, %B1490.if.lr.ph.i.i.i ], [ %others.4.5.i.i.i, %B2764.i.i.i ]
  %normals.3.41927.i.i.i = phi i64 [ %normals.7.2.ph.i.i.i, %B1490.if.lr.ph.i.i.i ], [ %normals.4.5.i.i.i, %B2764.i.i.i ]
  %.212619211925.i.i.i = phi i64 [ 0, %B1490.if.lr.ph.i.i.i ], [ %.2133.i.i.i, %B2764.i.i.i ]
  %.2133.i.i.i = add nuw nsw i64 %.212619211925.i.i.i, 1
  %151 = shl i64 %.212619211925.i.i.i, 3
  %scevgep321.i.i.i = getelementptr i8, ptr %scevgep306.i.i.i, i64 %151
  %.2201.i.i.i = load double, ptr %scevgep321.i.i.i, align 8, !noalias !6
  %.2205.i.i.i = fcmp contract ult double %.2201.i.i.i, %.2204.i.i.i
  br i1 %.2205.i.i.i, label %B2764.i.i.i, label %B1560.i.i.i

_ZN17bnserve_inference15marginal_kernel7_circle10_integrateB3v19B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedEx8UniTupleIdLi3EEd5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i.i: ; preds = %B2994.i.i.i, %_ZN17bnserve_inference15marginal_kernel7_circle7_finishB4v162B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedEx28Literal_5bbool_5d_28False_29x5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit42.i.i.i
  %.1683.sroa.5.0.i.i = phi double [ %.3485.i.i.i, %B2994.i.i.i ], [ 1.000000e+00, %_ZN17bnserve_inference15marginal_kernel7_circle7_finishB4v162B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedEx28Literal_5bbool_5d_28False_29x5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit42.i.i.i ]
  %.1683.sroa.0.0.i.i = phi double [ %133, %B2994.i.i.i ], [ 0x7FF8000000000000, %_ZN17bnserve_inference15marginal_kernel7_circle7_finishB4v162B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedEx28Literal_5bbool_5d_28False_29x5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit42.i.i.i ]
  call void @llvm.lifetime.end.p0(ptr nonnull %.2851.i.i.i), !noalias !3
  call void @llvm.lifetime.end.p0(ptr nonnull %.3119.i.i.i), !noalias !3
  call void @llvm.lifetime.end.p0(ptr nonnull %.3347.i.i.i), !noalias !3
  br label %B1286.i.i

B1286.i.i:                                        ; preds = %_ZN17bnserve_inference15marginal_kernel7_circle10_integrateB3v19B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedEx8UniTupleIdLi3EEd5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i.i, %B1058.i.i
  %factor.2.0.i.i = phi double [ %.1683.sroa.5.0.i.i, %_ZN17bnserve_inference15marginal_kernel7_circle10_integrateB3v19B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedEx8UniTupleIdLi3EEd5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i.i ], [ 1.000000e+00, %B1058.i.i ]
  %value.2.0.i.i = phi double [ %.1683.sroa.0.0.i.i, %_ZN17bnserve_inference15marginal_kernel7_circle10_integrateB3v19B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedEx8UniTupleIdLi3EEd5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i.i ], [ 0x7FF8000000000000, %B1058.i.i ]
  %152 = inttoptr i64 %.1520.i.i to ptr
  %.1781.i.i = load double, ptr %.814.i.i, align 8, !noalias !3
  %.1788.i.i = fsub contract double %value.2.0.i.i, %.1781.i.i
  %153 = getelementptr double, ptr %152, i64 %.305198201.i
  store double %.1788.i.i, ptr %153, align 8, !noalias !3
  %.1854.i.i = load i64, ptr %.963.i.i, align 8, !noalias !3
  %.1855.i.i = icmp eq i64 %.1854.i.i, 0
  br i1 %.1855.i.i, label %B358.i, label %B1382.i.i

B1382.i.i:                                        ; preds = %B1286.i.i
  %.2012.i.i = load i64, ptr %.1347.i.i, align 8, !noalias !3
  %.2078.i.i = fcmp contract ord double %value.2.0.i.i, 0.000000e+00
  %.2086.i.i = fdiv contract double 1.000000e+00, %factor.2.0.i.i
  %"$phi1578.0.2.0.i.i" = select i1 %.2078.i.i, double %.2086.i.i, double 0x7FF8000000000000
  %.21861423.not.i.i = icmp slt i64 %.108.i.i, 1
  br i1 %.21861423.not.i.i, label %B1762.i.i, label %B1610.if.lr.ph.i.i

B1762.i.i:                                        ; preds = %B1610.if.i.i, %B1382.i.i
  %.25221430.not.i.i = icmp slt i64 %.138.i.i, 1
  br i1 %.25221430.not.i.i, label %B358.i, label %B1792.if.lr.ph.i.i

B1792.if.lr.ph.i.i:                               ; preds = %B1762.i.i
  %154 = inttoptr i64 %.2012.i.i to ptr
  %.2561.i.i = fmul contract double %"$phi1578.0.2.0.i.i", -5.000000e-01
  %.2563.i.i = mul nsw i64 %.598.i.i, 6
  %.2664.i.i = mul nsw i64 %.598.i.i, 7
  %155 = shl i64 %.305198201.i, 4
  %156 = getelementptr i8, ptr %154, i64 %155
  %scevgep118.i.i = getelementptr i8, ptr %156, i64 8
  %157 = shl i64 %.78.i.i, 4
  %158 = shl i64 %.273.i.i, 3
  br label %B1792.if.i.i

B602.if.i.i:                                      ; preds = %B602.if.i.i, %B602.if.preheader.i.i
  %lsr.iv147.i.i = phi i64 [ %.305198201.i, %B602.if.preheader.i.i ], [ %lsr.iv.next148.i.i, %B602.if.i.i ]
  %lsr.iv143.i.i = phi ptr [ %scevgep142.i.i, %B602.if.preheader.i.i ], [ %scevgep144.i.i, %B602.if.i.i ]
  %size_x.2.01405.i.i = phi double [ 0.000000e+00, %B602.if.preheader.i.i ], [ %.1155.i.i, %B602.if.i.i ]
  %bend_x.2.01404.i.i = phi double [ 0.000000e+00, %B602.if.preheader.i.i ], [ %.1151.i.i, %B602.if.i.i ]
  %.94814001402.i.i = phi i64 [ 0, %B602.if.preheader.i.i ], [ %.955.i.i, %B602.if.i.i ]
  %.955.i.i = add nuw nsw i64 %.94814001402.i.i, 1
  %159 = shl i64 %.94814001402.i.i, 3
  %scevgep141.i.i = getelementptr i8, ptr %.360.i.i, i64 %159
  %.1009.i.i = load i64, ptr %scevgep141.i.i, align 8, !noalias !3
  %.1028.i.i = icmp slt i64 %lsr.iv147.i.i, 0
  %160 = select i1 %.1028.i.i, i64 %12, i64 0
  %scevgep145.i.i = getelementptr i8, ptr %lsr.iv143.i.i, i64 %160
  %scevgep146.i.i = getelementptr i8, ptr %scevgep145.i.i, i64 -8
  %.1044.i.i = load double, ptr %scevgep146.i.i, align 8, !noalias !3
  %.1080.i.i = load double, ptr %scevgep145.i.i, align 8, !noalias !3
  %.1081.i.i = fmul contract double %.1044.i.i, %.1044.i.i
  %.1082.i.i = fmul contract double %.1080.i.i, %.1080.i.i
  %.1083.i.i = fadd contract double %.1081.i.i, %.1082.i.i
  %.1084.i.i = tail call contract double @llvm.sqrt.f64(double %.1083.i.i)
  %.1098.i.i = icmp slt i64 %.1009.i.i, 0
  %.1099.i.i = select i1 %.1098.i.i, i64 %.604.i.i, i64 0
  %161 = getelementptr double, ptr %1, i64 %.1009.i.i
  %.1113.i.i = getelementptr double, ptr %161, i64 %.1099.i.i
  store double %.1044.i.i, ptr %.1113.i.i, align 8, !noalias !3
  %.1116.i.i = add nsw i64 %.1009.i.i, %.598.i.i
  %.1130.i.i = icmp slt i64 %.1116.i.i, 0
  %.1131.i.i = select i1 %.1130.i.i, i64 %.604.i.i, i64 0
  %162 = getelementptr double, ptr %1, i64 %.1116.i.i
  %.1145.i.i = getelementptr double, ptr %162, i64 %.1131.i.i
  store double %.1080.i.i, ptr %.1145.i.i, align 8, !noalias !3
  %.1147.i.i = mul nsw i64 %.1009.i.i, %.1009.i.i
  %.1148.i.i = uitofp nneg i64 %.1147.i.i to double
  %.1149.i.i = fmul contract double %.1084.i.i, %.1148.i.i
  %.1151.i.i = fadd contract double %bend_x.2.01404.i.i, %.1149.i.i
  %.1155.i.i = fadd contract double %size_x.2.01405.i.i, %.1084.i.i
  %scevgep144.i.i = getelementptr i8, ptr %lsr.iv143.i.i, i64 %11
  %lsr.iv.next148.i.i = add i64 %lsr.iv147.i.i, %.78.i.i
  %exitcond1435.not.i.i = icmp eq i64 %.108.i.i, %.955.i.i
  br i1 %exitcond1435.not.i.i, label %B806.i.i, label %B602.if.i.i

B836.if.i.i:                                      ; preds = %B836.if.i.i, %B836.if.lr.ph.i.i
  %lsr.iv139.i.i = phi i64 [ %.305198201.i, %B836.if.lr.ph.i.i ], [ %lsr.iv.next140.i.i, %B836.if.i.i ]
  %lsr.iv135.i.i = phi ptr [ %scevgep134.i.i, %B836.if.lr.ph.i.i ], [ %scevgep136.i.i, %B836.if.i.i ]
  %size_n.2.01416.i.i = phi double [ 0.000000e+00, %B836.if.lr.ph.i.i ], [ %.1477.i.i, %B836.if.i.i ]
  %bend_n.2.01415.i.i = phi double [ 0.000000e+00, %B836.if.lr.ph.i.i ], [ %.1473.i.i, %B836.if.i.i ]
  %.126614111413.i.i = phi i64 [ 0, %B836.if.lr.ph.i.i ], [ %.1273.i.i, %B836.if.i.i ]
  %.1273.i.i = add nuw nsw i64 %.126614111413.i.i, 1
  %163 = shl i64 %.126614111413.i.i, 3
  %scevgep133.i.i = getelementptr i8, ptr %.440.i.i, i64 %163
  %.1327.i.i = load i64, ptr %scevgep133.i.i, align 8, !noalias !3
  %.1346.i.i = icmp slt i64 %lsr.iv139.i.i, 0
  %164 = select i1 %.1346.i.i, i64 %18, i64 0
  %scevgep137.i.i = getelementptr i8, ptr %lsr.iv135.i.i, i64 %164
  %scevgep138.i.i = getelementptr i8, ptr %scevgep137.i.i, i64 -8
  %.1362.i.i = load double, ptr %scevgep138.i.i, align 8, !noalias !3
  %.1398.i.i = load double, ptr %scevgep137.i.i, align 8, !noalias !3
  %.1399.i.i = fmul contract double %.1362.i.i, %.1362.i.i
  %.1400.i.i = fmul contract double %.1398.i.i, %.1398.i.i
  %.1401.i.i = fadd contract double %.1399.i.i, %.1400.i.i
  %.1402.i.i = tail call contract double @llvm.sqrt.f64(double %.1401.i.i)
  %.1405.i.i = add nsw i64 %.1327.i.i, %.1404.i.i
  %.1419.i.i = icmp slt i64 %.1405.i.i, 0
  %.1420.i.i = select i1 %.1419.i.i, i64 %.604.i.i, i64 0
  %165 = getelementptr double, ptr %1, i64 %.1405.i.i
  %.1434.i.i = getelementptr double, ptr %165, i64 %.1420.i.i
  store double %.1362.i.i, ptr %.1434.i.i, align 8, !noalias !3
  %.1438.i.i = add nsw i64 %.1327.i.i, %.1437.i.i
  %.1452.i.i = icmp slt i64 %.1438.i.i, 0
  %.1453.i.i = select i1 %.1452.i.i, i64 %.604.i.i, i64 0
  %166 = getelementptr double, ptr %1, i64 %.1438.i.i
  %.1467.i.i = getelementptr double, ptr %166, i64 %.1453.i.i
  store double %.1398.i.i, ptr %.1467.i.i, align 8, !noalias !3
  %.1469.i.i = mul nsw i64 %.1327.i.i, %.1327.i.i
  %.1470.i.i = uitofp nneg i64 %.1469.i.i to double
  %.1471.i.i = fmul contract double %.1402.i.i, %.1470.i.i
  %.1473.i.i = fadd contract double %bend_n.2.01415.i.i, %.1471.i.i
  %.1477.i.i = fadd contract double %size_n.2.01416.i.i, %.1402.i.i
  %scevgep136.i.i = getelementptr i8, ptr %lsr.iv135.i.i, i64 %17
  %lsr.iv.next140.i.i = add i64 %lsr.iv139.i.i, %.78.i.i
  %exitcond1436.not.i.i = icmp eq i64 %.138.i.i, %.1273.i.i
  br i1 %exitcond1436.not.i.i, label %B1058.i.i, label %B836.if.i.i

B1610.if.lr.ph.i.i:                               ; preds = %B1382.i.i
  %167 = inttoptr i64 %.1854.i.i to ptr
  %.2225.i.i = shl nsw i64 %.598.i.i, 2
  %.2325.i.i = mul nsw i64 %.598.i.i, 5
  %168 = shl i64 %.305198201.i, 4
  %169 = getelementptr i8, ptr %167, i64 %168
  %scevgep125.i.i = getelementptr i8, ptr %169, i64 8
  %170 = shl i64 %.78.i.i, 4
  %171 = shl i64 %.182.i.i, 3
  br label %B1610.if.i.i

B1610.if.i.i:                                     ; preds = %B1610.if.i.i, %B1610.if.lr.ph.i.i
  %lsr.iv131.i.i = phi i64 [ %.305198201.i, %B1610.if.lr.ph.i.i ], [ %lsr.iv.next132.i.i, %B1610.if.i.i ]
  %lsr.iv126.i.i = phi ptr [ %scevgep125.i.i, %B1610.if.lr.ph.i.i ], [ %scevgep127.i.i, %B1610.if.i.i ]
  %.219214221424.i.i = phi i64 [ 0, %B1610.if.lr.ph.i.i ], [ %.2199.i.i, %B1610.if.i.i ]
  %.2199.i.i = add nuw nsw i64 %.219214221424.i.i, 1
  %172 = shl i64 %.219214221424.i.i, 3
  %scevgep124.i.i = getelementptr i8, ptr %.360.i.i, i64 %172
  %.2255.i.i = load i64, ptr %scevgep124.i.i, align 8, !noalias !3
  %.2256.i.i = add nsw i64 %.2255.i.i, %.2225.i.i
  %.2270.i.i = icmp slt i64 %.2256.i.i, 0
  %.2271.i.i = select i1 %.2270.i.i, i64 %.604.i.i, i64 0
  %173 = getelementptr double, ptr %1, i64 %.2256.i.i
  %.2285.i.i = getelementptr double, ptr %173, i64 %.2271.i.i
  %.2286.i.i = load double, ptr %.2285.i.i, align 8, !noalias !3
  %.2288.i.i = fmul contract double %"$phi1578.0.2.0.i.i", %.2286.i.i
  %.2307.i.i = icmp slt i64 %lsr.iv131.i.i, 0
  %174 = select i1 %.2307.i.i, i64 %171, i64 0
  %scevgep128.i.i = getelementptr i8, ptr %lsr.iv126.i.i, i64 %174
  %scevgep129.i.i = getelementptr i8, ptr %scevgep128.i.i, i64 -8
  store double %.2288.i.i, ptr %scevgep129.i.i, align 8, !noalias !3
  %.2355.i.i = load i64, ptr %scevgep124.i.i, align 8, !noalias !3
  %.2356.i.i = add nsw i64 %.2355.i.i, %.2325.i.i
  %.2370.i.i = icmp slt i64 %.2356.i.i, 0
  %.2371.i.i = select i1 %.2370.i.i, i64 %.604.i.i, i64 0
  %175 = getelementptr double, ptr %1, i64 %.2356.i.i
  %.2385.i.i = getelementptr double, ptr %175, i64 %.2371.i.i
  %.2386.i.i = load double, ptr %.2385.i.i, align 8, !noalias !3
  %.2388.i.i = fmul contract double %"$phi1578.0.2.0.i.i", %.2386.i.i
  store double %.2388.i.i, ptr %scevgep128.i.i, align 8, !noalias !3
  %scevgep127.i.i = getelementptr i8, ptr %lsr.iv126.i.i, i64 %170
  %lsr.iv.next132.i.i = add i64 %lsr.iv131.i.i, %.78.i.i
  %exitcond1437.not.i.i = icmp eq i64 %.108.i.i, %.2199.i.i
  br i1 %exitcond1437.not.i.i, label %B1762.i.i, label %B1610.if.i.i

B1792.if.i.i:                                     ; preds = %B1792.if.i.i, %B1792.if.lr.ph.i.i
  %lsr.iv123.i.i = phi i64 [ %.305198201.i, %B1792.if.lr.ph.i.i ], [ %lsr.iv.next.i.i, %B1792.if.i.i ]
  %lsr.iv.i.i = phi ptr [ %scevgep118.i.i, %B1792.if.lr.ph.i.i ], [ %scevgep119.i.i, %B1792.if.i.i ]
  %.252814291431.i.i = phi i64 [ 0, %B1792.if.lr.ph.i.i ], [ %.2535.i.i, %B1792.if.i.i ]
  %.2535.i.i = add nuw nsw i64 %.252814291431.i.i, 1
  %176 = shl i64 %.252814291431.i.i, 3
  %scevgep.i.i = getelementptr i8, ptr %.440.i.i, i64 %176
  %.2593.i.i = load i64, ptr %scevgep.i.i, align 8, !noalias !3
  %.2594.i.i = add nsw i64 %.2593.i.i, %.2563.i.i
  %.2608.i.i = icmp slt i64 %.2594.i.i, 0
  %.2609.i.i = select i1 %.2608.i.i, i64 %.604.i.i, i64 0
  %177 = getelementptr double, ptr %1, i64 %.2594.i.i
  %.2623.i.i = getelementptr double, ptr %177, i64 %.2609.i.i
  %.2624.i.i = load double, ptr %.2623.i.i, align 8, !noalias !3
  %.2625.i.i = fmul contract double %.2561.i.i, %.2624.i.i
  %.2644.i.i = icmp slt i64 %lsr.iv123.i.i, 0
  %178 = select i1 %.2644.i.i, i64 %158, i64 0
  %scevgep120.i.i = getelementptr i8, ptr %lsr.iv.i.i, i64 %178
  %scevgep121.i.i = getelementptr i8, ptr %scevgep120.i.i, i64 -8
  store double %.2625.i.i, ptr %scevgep121.i.i, align 8, !noalias !3
  %.2694.i.i = load i64, ptr %scevgep.i.i, align 8, !noalias !3
  %.2695.i.i = add nsw i64 %.2694.i.i, %.2664.i.i
  %.2709.i.i = icmp slt i64 %.2695.i.i, 0
  %.2710.i.i = select i1 %.2709.i.i, i64 %.604.i.i, i64 0
  %179 = getelementptr double, ptr %1, i64 %.2695.i.i
  %.2724.i.i = getelementptr double, ptr %179, i64 %.2710.i.i
  %.2725.i.i = load double, ptr %.2724.i.i, align 8, !noalias !3
  %.2726.i.i = fmul contract double %.2561.i.i, %.2725.i.i
  store double %.2726.i.i, ptr %scevgep120.i.i, align 8, !noalias !3
  %scevgep119.i.i = getelementptr i8, ptr %lsr.iv.i.i, i64 %157
  %lsr.iv.next.i.i = add i64 %lsr.iv123.i.i, %.78.i.i
  %exitcond1438.not.i.i = icmp eq i64 %.138.i.i, %.2535.i.i
  br i1 %exitcond1438.not.i.i, label %B358.i, label %B1792.if.i.i

B320.i:                                           ; preds = %B214.if.i
  call void @llvm.lifetime.start.p0(ptr nonnull %.603.i.i), !noalias !0
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(32) %.603.i.i, i8 0, i64 32, i1 false), !noalias !35
  %.109.i.i = icmp eq i64 %.369.i, 1
  %.146.i.i = load i64, ptr %.145.i.i, align 8, !noalias !35
  %.148.i.i = shl nsw i64 %.305198201.i, 4
  %.149.i.i = add nsw i64 %.146.i.i, %.148.i.i
  %.150.i.i = inttoptr i64 %.149.i.i to ptr
  %.236.i.i = load i64, ptr %.235.i.i, align 8, !noalias !35
  %.238.i.i = inttoptr i64 %.236.i.i to ptr
  %180 = getelementptr double, ptr %.238.i.i, i64 %.305198201.i
  %.315.i.i = load double, ptr %180, align 8, !noalias !35
  %.353.i.i = load double, ptr %.150.i.i, align 8, !noalias !35
  br i1 %.109.i.i, label %B260.i.i, label %B370.i.i

B260.i.i:                                         ; preds = %B320.i
  %.384.i.i = fmul contract double %.353.i.i, %.353.i.i
  %sunkaddr.i.i = inttoptr i64 %.146.i.i to ptr
  %sunkaddr61.i.i = getelementptr i8, ptr %sunkaddr.i.i, i64 %.148.i.i
  %sunkaddr62.i.i = getelementptr i8, ptr %sunkaddr61.i.i, i64 8
  %.414.i.i = load double, ptr %sunkaddr62.i.i, align 8, !noalias !35
  %.445.i.i = fmul contract double %.414.i.i, %.414.i.i
  %.446.i.i = fadd contract double %.384.i.i, %.445.i.i
  %.447.i.i = tail call contract double @llvm.sqrt.f64(double %.446.i.i)
  br label %B370.i.i

B370.i.i:                                         ; preds = %B260.i.i, %B320.i
  %"$phi370.0.2.0.i.i" = phi double [ %.447.i.i, %B260.i.i ], [ %.353.i.i, %B320.i ]
  %"$phi370.0.2.0.fr.i.i" = freeze double %"$phi370.0.2.0.i.i"
  %181 = tail call double @llvm.fabs.f64(double %"$phi370.0.2.0.fr.i.i")
  %or.cond.i.i = fcmp ueq double %181, 0x7FF0000000000000
  %182 = tail call double @llvm.fabs.f64(double %.315.i.i)
  %183 = fcmp ueq double %182, 0x7FF0000000000000
  %or.cond2.i.i = select i1 %or.cond.i.i, i1 true, i1 %183
  br i1 %or.cond2.i.i, label %B650.i.i, label %B566.i.i

B566.i.i:                                         ; preds = %B370.i.i
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(32) %.603.i.i, i8 0, i64 32, i1 false), !noalias !35
  call fastcc void @inner_0(ptr nonnull %.603.i.i, double %"$phi370.0.2.0.fr.i.i", double %.315.i.i, ptr nonnull readonly %arg.arguments, ptr readonly %0, ptr %1)
  %.623.fca.3.load.i.i = load double, ptr %sunkaddr63.i.i, align 8, !noalias !35
  %.623.fca.2.load.i.i = load double, ptr %sunkaddr64.i.i, align 8, !noalias !35
  %.623.fca.1.load.i.i = load double, ptr %sunkaddr65.i.i, align 8, !noalias !35
  %.623.fca.0.load.i.i = load double, ptr %.603.i.i, align 8, !noalias !35
  %184 = fmul contract double %.623.fca.3.load.i.i, -5.000000e-01
  br label %B650.i.i

B650.i.i:                                         ; preds = %B566.i.i, %B370.i.i
  %exponent.2.0.i.i = phi double [ %.623.fca.0.load.i.i, %B566.i.i ], [ 0x7FF8000000000000, %B370.i.i ]
  %factor.2.0.i4.i = phi double [ %.623.fca.1.load.i.i, %B566.i.i ], [ 1.000000e+00, %B370.i.i ]
  %firsts.2.0.i.i = phi double [ %.623.fca.2.load.i.i, %B566.i.i ], [ 0x7FF8000000000000, %B370.i.i ]
  %squares.2.0.i.i = phi double [ %184, %B566.i.i ], [ 0x7FF8000000000000, %B370.i.i ]
  %.815.i.i = load double, ptr %.814.i.i, align 8, !noalias !35
  %.852.i.i = load i64, ptr %.851.i.i, align 8, !noalias !35
  %.854.i.i = inttoptr i64 %.852.i.i to ptr
  %.742.i.i = bitcast double %factor.2.0.i4.i to i64
  %.743.i.i = add nsw i64 %.742.i.i, -4604544271217802189
  %.744.i.i = ashr i64 %.743.i.i, 52
  %.771.i.i = add nsw i64 %.744.i.i, 4843621399236968448
  %.772.i.i = bitcast i64 %.771.i.i to double
  %.773.i.i = fadd contract double %.772.i.i, 0xC338000000000000
  %.774.i.i = fmul contract double %.773.i.i, 0x3FE62E42FEE00000
  %.745.i.i = and i64 %.743.i.i, -4503599627370496
  %.746.i.i = sub nsw i64 %.742.i.i, %.745.i.i
  %.747.i.i = bitcast i64 %.746.i.i to double
  %.748.i.i = fadd contract double %.747.i.i, -1.000000e+00
  %.769.i.i = fmul contract double %.748.i.i, 5.000000e-01
  %.770.i.i = fmul contract double %.748.i.i, %.769.i.i
  %.749.i.i = fadd contract double %.748.i.i, 2.000000e+00
  %.753.i.i = fdiv contract double %.748.i.i, %.749.i.i
  %.754.i.i = fmul contract double %.753.i.i, %.753.i.i
  %.755.i.i = fmul contract double %.754.i.i, %.754.i.i
  %.761.i.i = fmul contract double %.755.i.i, 0x3FC2F112DF3E5244
  %.762.i.i = fadd contract double %.761.i.i, 0x3FC7466496CB03DE
  %.763.i.i = fmul contract double %.755.i.i, %.762.i.i
  %.764.i.i = fadd contract double %.763.i.i, 0x3FD2492494229359
  %.765.i.i = fmul contract double %.755.i.i, %.764.i.i
  %.766.i.i = fadd contract double %.765.i.i, 0x3FE5555555555593
  %.767.i.i = fmul contract double %.754.i.i, %.766.i.i
  %.756.i.i = fmul contract double %.755.i.i, 0x3FC39A09D078C69F
  %.757.i.i = fadd contract double %.756.i.i, 0x3FCC71C51D8E78AF
  %.758.i.i = fmul contract double %.755.i.i, %.757.i.i
  %.759.i.i = fadd contract double %.758.i.i, 0x3FD999999997FA04
  %.760.i.i = fmul contract double %.755.i.i, %.759.i.i
  %.768.i.i = fadd contract double %.760.i.i, %.767.i.i
  %.775.i.i = fadd contract double %.770.i.i, %.768.i.i
  %.776.i.i = fmul contract double %.753.i.i, %.775.i.i
  %.777.i.i = fmul contract double %.773.i.i, 0x3DEA39EF35793C76
  %.778.i.i = fadd contract double %.777.i.i, %.776.i.i
  %.779.i.i = fsub contract double %.770.i.i, %.778.i.i
  %.780.i.i = fsub contract double %.779.i.i, %.748.i.i
  %.781.i.i = fsub contract double %.774.i.i, %.780.i.i
  %.783.i.i = fadd contract double %exponent.2.0.i.i, %.781.i.i
  %.821.i.i = fsub contract double %.783.i.i, %.815.i.i
  %185 = getelementptr double, ptr %.854.i.i, i64 %.305198201.i
  store double %.821.i.i, ptr %185, align 8, !noalias !35
  %.964.i.i = load i64, ptr %.963.i.i, align 8, !noalias !35
  %.965.not.i.i = icmp eq i64 %.964.i.i, 0
  br i1 %.965.not.i.i, label %_ZN17bnserve_inference15marginal_kernel7_source8_at_onceB4v168B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i, label %B834.i.i

B834.i.i:                                         ; preds = %B650.i.i
  %.972.i.i = fdiv contract double %firsts.2.0.i.i, %factor.2.0.i4.i
  %.1011.i.i = add nsw i64 %.964.i.i, %.148.i.i
  %.1012.i.i = inttoptr i64 %.1011.i.i to ptr
  store double %.972.i.i, ptr %.1012.i.i, align 8, !noalias !35
  %.1125.i.i = getelementptr i8, ptr %.1012.i.i, i64 8
  store double 0.000000e+00, ptr %.1125.i.i, align 8, !noalias !35
  br i1 %.109.i.i, label %B946.i.i, label %B1032.i.i

B946.i.i:                                         ; preds = %B834.i.i
  %.1132.i.i = fcmp contract ogt double %"$phi370.0.2.0.fr.i.i", 0.000000e+00
  %.1139.i.i = fdiv contract double %.972.i.i, %"$phi370.0.2.0.fr.i.i"
  %"$phi970.0.2.0.i.i" = select i1 %.1132.i.i, double %.1139.i.i, double %.972.i.i
  %sunkaddr66.i.i = inttoptr i64 %.146.i.i to ptr
  %sunkaddr67.i.i = getelementptr i8, ptr %sunkaddr66.i.i, i64 %.148.i.i
  %.1188.i.i = load double, ptr %sunkaddr67.i.i, align 8, !noalias !35
  %.1189.i.i = fmul contract double %"$phi970.0.2.0.i.i", %.1188.i.i
  %.1190.i.i = fneg contract double %"$phi970.0.2.0.i.i"
  %sunkaddr70.i.i = getelementptr i8, ptr %sunkaddr67.i.i, i64 8
  %.1220.i.i = load double, ptr %sunkaddr70.i.i, align 8, !noalias !35
  %.1226.i.i = fmul contract double %.1220.i.i, %.1190.i.i
  %sunkaddr71.i.i = inttoptr i64 %.964.i.i to ptr
  %sunkaddr72.i.i = getelementptr i8, ptr %sunkaddr71.i.i, i64 %.148.i.i
  store double %.1189.i.i, ptr %sunkaddr72.i.i, align 8, !noalias !35
  %sunkaddr75.i.i = getelementptr i8, ptr %sunkaddr72.i.i, i64 8
  store double %.1226.i.i, ptr %sunkaddr75.i.i, align 8, !noalias !35
  br label %B1032.i.i

B1032.i.i:                                        ; preds = %B946.i.i, %B834.i.i
  %.1348.i.i = load i64, ptr %.1347.i.i, align 8, !noalias !35
  %.1357.i.i = inttoptr i64 %.1348.i.i to ptr
  %.1315.i.i = fdiv contract double %squares.2.0.i.i, %factor.2.0.i4.i
  %186 = getelementptr double, ptr %.1357.i.i, i64 %.305198201.i
  store double %.1315.i.i, ptr %186, align 8, !noalias !35
  br label %_ZN17bnserve_inference15marginal_kernel7_source8_at_onceB4v168B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i

_ZN17bnserve_inference15marginal_kernel7_source8_at_onceB4v168B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i: ; preds = %B1032.i.i, %B650.i.i
  call void @llvm.lifetime.end.p0(ptr nonnull %.603.i.i), !noalias !0
  br label %B358.i

B358.i:                                           ; preds = %B1792.if.i.i, %_ZN17bnserve_inference15marginal_kernel7_source8_at_onceB4v168B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i, %B1762.i.i, %B1286.i.i
  %exitcond.not.i = icmp eq i64 %.219.i, %.312.i
  br i1 %exitcond.not.i, label %_ZN17bnserve_inference15marginal_kernel7_source9integrateB2v3B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIxLi1E1C7mutable7alignedE.exit, label %B214.if.i

B214.if.i:                                        ; preds = %B358.i, %B214.if.preheader.i
  %.305198201.i = phi i64 [ %.312.i, %B358.i ], [ 0, %B214.if.preheader.i ]
  %.312.i = add nuw nsw i64 %.305198201.i, 1
  %.369.i = load i64, ptr %arg.arguments, align 8, !noalias !0
  %.370.i = icmp eq i64 %.369.i, 2
  br i1 %.370.i, label %B282.i, label %B320.i

_ZN17bnserve_inference15marginal_kernel7_source9integrateB2v3B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIxLi1E1C7mutable7alignedE.exit: ; preds = %B358.i, %entry
  store i64 0, ptr %retptr, align 8
  ret i32 0
}

; Function Attrs: mustprogress nocallback nofree nounwind willreturn memory(argmem: write)
declare void @llvm.memset.p0.i64(ptr writeonly captures(none), i8, i64, i1 immarg) #1

; Function Attrs: mustprogress nocallback nocreateundeforpoison nofree nosync nounwind speculatable willreturn memory(none)
declare double @llvm.sqrt.f64(double) #2

; Function Attrs: nofree norecurse nosync nounwind memory(readwrite, inaccessiblemem: none, target_mem0: none, target_mem1: none)
define internal fastcc void @inner_0(ptr noalias nonnull writeonly captures(none) %retptr, double %arg.x, double %arg.n, ptr readonly captures(none) %arg.arguments.4, ptr readonly captures(none) %arg.prior.4, ptr %arg.room.4) unnamed_addr #0 {
entry:
  %.1212.i572 = alloca ptr, align 8
  %.2411.i574 = alloca ptr, align 8
  %.1212.i251 = alloca ptr, align 8
  %.2411.i253 = alloca ptr, align 8
  %.1212.i3 = alloca ptr, align 8
  %.2411.i5 = alloca ptr, align 8
  %.1212.i = alloca ptr, align 8
  %.2411.i = alloca ptr, align 8
  %.605.i = alloca ptr, align 8
  %.676.i = alloca ptr, align 8
  %.80 = getelementptr i8, ptr %arg.arguments.4, i64 48
  %.81 = load i64, ptr %.80, align 8
  %.82 = icmp eq i64 %.81, 0
  br i1 %.82, label %B48, label %B84

B48:                                              ; preds = %entry
  call void @llvm.lifetime.start.p0(ptr nonnull %.605.i)
  call void @llvm.lifetime.start.p0(ptr nonnull %.676.i)
  store ptr null, ptr %.605.i, align 8, !noalias !38
  store ptr null, ptr %.676.i, align 8, !noalias !38
  %.67.i = load i64, ptr %arg.arguments.4, align 8, !noalias !38
  %.68.not.i = icmp eq i64 %.67.i, 1
  br i1 %.68.not.i, label %B92.i, label %B68.i

B68.i:                                            ; preds = %B48
  %.81.i = fmul contract double %arg.n, 5.000000e-01
  %.85.i = fsub contract double %arg.x, %.81.i
  br label %_ZN17bnserve_inference15marginal_kernel9_distance9_as_it_isB3v75B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEdd5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit

B92.i:                                            ; preds = %B48
  %.181.i = getelementptr inbounds nuw i8, ptr %arg.room.4, i64 64
  %.262.i = getelementptr inbounds nuw i8, ptr %arg.room.4, i64 128
  store double 1.000000e+00, ptr %arg.room.4, align 8, !noalias !38
  store double 0.000000e+00, ptr %.181.i, align 8, !noalias !38
  store double %arg.x, ptr %.262.i, align 8, !noalias !38
  %0 = getelementptr i8, ptr %arg.room.4, i64 8
  store double 1.000000e+00, ptr %0, align 8, !noalias !38
  %1 = getelementptr i8, ptr %arg.room.4, i64 72
  store double 0.000000e+00, ptr %1, align 8, !noalias !38
  %2 = getelementptr i8, ptr %arg.room.4, i64 136
  store double %arg.x, ptr %2, align 8, !noalias !38
  %3 = getelementptr i8, ptr %arg.room.4, i64 16
  store double 1.000000e+00, ptr %3, align 8, !noalias !38
  %4 = getelementptr i8, ptr %arg.room.4, i64 80
  store double 0.000000e+00, ptr %4, align 8, !noalias !38
  %5 = getelementptr i8, ptr %arg.room.4, i64 144
  store double %arg.x, ptr %5, align 8, !noalias !38
  %6 = getelementptr i8, ptr %arg.room.4, i64 24
  store double 1.000000e+00, ptr %6, align 8, !noalias !38
  %7 = getelementptr i8, ptr %arg.room.4, i64 88
  store double 0.000000e+00, ptr %7, align 8, !noalias !38
  %8 = getelementptr i8, ptr %arg.room.4, i64 152
  store double %arg.x, ptr %8, align 8, !noalias !38
  %9 = getelementptr i8, ptr %arg.room.4, i64 32
  store double 1.000000e+00, ptr %9, align 8, !noalias !38
  %10 = getelementptr i8, ptr %arg.room.4, i64 96
  store double 0.000000e+00, ptr %10, align 8, !noalias !38
  %11 = getelementptr i8, ptr %arg.room.4, i64 160
  store double %arg.x, ptr %11, align 8, !noalias !38
  %12 = getelementptr i8, ptr %arg.room.4, i64 40
  store double 1.000000e+00, ptr %12, align 8, !noalias !38
  %13 = getelementptr i8, ptr %arg.room.4, i64 104
  store double 0.000000e+00, ptr %13, align 8, !noalias !38
  %14 = getelementptr i8, ptr %arg.room.4, i64 168
  store double %arg.x, ptr %14, align 8, !noalias !38
  %15 = getelementptr i8, ptr %arg.room.4, i64 48
  store double 1.000000e+00, ptr %15, align 8, !noalias !38
  %16 = getelementptr i8, ptr %arg.room.4, i64 112
  store double 0.000000e+00, ptr %16, align 8, !noalias !38
  %17 = getelementptr i8, ptr %arg.room.4, i64 176
  store double %arg.x, ptr %17, align 8, !noalias !38
  %18 = getelementptr i8, ptr %arg.room.4, i64 56
  store double 1.000000e+00, ptr %18, align 8, !noalias !38
  %19 = getelementptr i8, ptr %arg.room.4, i64 120
  store double 0.000000e+00, ptr %19, align 8, !noalias !38
  %20 = getelementptr i8, ptr %arg.room.4, i64 184
  store double %arg.x, ptr %20, align 8, !noalias !38
  %.551.i = getelementptr inbounds nuw i8, ptr %arg.room.4, i64 1536
  store ptr null, ptr %.605.i, align 8, !noalias !38
  call fastcc void @inner_3(ptr nonnull %.605.i, ptr nonnull %.262.i, i64 8, ptr nonnull readonly %arg.arguments.4, ptr nonnull %.551.i, ptr nonnull %.181.i)
  %.668.i = getelementptr i8, ptr %arg.arguments.4, i64 184
  %.669.i = load i64, ptr %.668.i, align 8, !noalias !38
  %.670.not.i = icmp eq i64 %.669.i, 0
  br i1 %.670.not.i, label %B502.i, label %B468.i

B468.i:                                           ; preds = %B92.i
  store ptr null, ptr %.676.i, align 8, !noalias !38
  call fastcc void @inner_4(ptr nonnull %.676.i, ptr nonnull %.262.i, i64 8, ptr nonnull %arg.room.4, ptr nonnull readonly %arg.arguments.4)
  br label %B502.i

B502.i:                                           ; preds = %B468.i, %B92.i
  %.756.i = load double, ptr %.181.i, align 8, !noalias !38
  %.763.i = fadd contract double %arg.x, %.756.i
  %.767.i = fmul contract double %arg.n, 5.000000e-01
  %.770.i = fsub contract double %.763.i, %.767.i
  %.800.i = load double, ptr %arg.room.4, align 8, !noalias !38
  br label %_ZN17bnserve_inference15marginal_kernel9_distance9_as_it_isB3v75B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEdd5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit

_ZN17bnserve_inference15marginal_kernel9_distance9_as_it_isB3v75B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEdd5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit: ; preds = %B68.i, %B502.i
  %.94.sroa.8.0 = phi double [ %.800.i, %B502.i ], [ 1.000000e+00, %B68.i ]
  %.94.sroa.0.0 = phi double [ %.770.i, %B502.i ], [ %.85.i, %B68.i ]
  call void @llvm.lifetime.end.p0(ptr nonnull %.605.i)
  call void @llvm.lifetime.end.p0(ptr nonnull %.676.i)
  br label %common.ret

B84:                                              ; preds = %entry
  %.149 = fcmp contract ogt double %arg.x, 0.000000e+00
  %.152 = fcmp contract ogt double %arg.n, 0.000000e+00
  %or.cond = select i1 %.149, i1 %.152, i1 false
  br i1 %or.cond, label %B108.endif, label %B1408

B222:                                             ; preds = %B108.endif
  %.301 = fadd contract double %.159, %.257
  %.332 = getelementptr i8, ptr %arg.prior.4, i64 16
  %.333 = load double, ptr %.332, align 8
  %.339 = fcmp contract olt double %.301, %.333
  br label %B360

B360:                                             ; preds = %B108.endif, %B222
  %is_normal_v74__vphi176_0.2.0 = phi i1 [ %.339, %B222 ], [ false, %B108.endif ]
  %.359 = fmul contract double %.159, %.202
  %.365 = fcmp contract olt double %.165, %.359
  %is_normal_v74__vphi198_0.2.0 = select i1 %is_normal_v74__vphi176_0.2.0, i1 %.365, i1 false
  br i1 %is_normal_v74__vphi198_0.2.0, label %B682, label %B686

B682:                                             ; preds = %B360
  %.410 = getelementptr i8, ptr %arg.arguments.4, i64 80
  %.411 = load i64, ptr %.410, align 8
  %.413 = inttoptr i64 %.411 to ptr
  call void @llvm.lifetime.start.p0(ptr nonnull %.1212.i)
  call void @llvm.lifetime.start.p0(ptr nonnull %.2411.i)
  store ptr null, ptr %.1212.i, align 8, !noalias !41
  store ptr null, ptr %.2411.i, align 8, !noalias !41
  %.380.i = load double, ptr %.413, align 8, !noalias !41
  %.382.i = fmul contract double %.165, %.380.i
  %.384.i = fadd contract double %.159, %.382.i
  store double %.384.i, ptr %arg.room.4, align 8, !noalias !41
  %21 = getelementptr i8, ptr %.413, i64 8
  %.380.1.i = load double, ptr %21, align 8, !noalias !41
  %.382.1.i = fmul contract double %.165, %.380.1.i
  %.384.1.i = fadd contract double %.159, %.382.1.i
  %22 = getelementptr i8, ptr %arg.room.4, i64 8
  store double %.384.1.i, ptr %22, align 8, !noalias !41
  %23 = getelementptr i8, ptr %.413, i64 16
  %.380.2.i = load double, ptr %23, align 8, !noalias !41
  %.382.2.i = fmul contract double %.165, %.380.2.i
  %.384.2.i = fadd contract double %.159, %.382.2.i
  %24 = getelementptr i8, ptr %arg.room.4, i64 16
  store double %.384.2.i, ptr %24, align 8, !noalias !41
  %25 = getelementptr i8, ptr %.413, i64 24
  %.380.3.i = load double, ptr %25, align 8, !noalias !41
  %.382.3.i = fmul contract double %.165, %.380.3.i
  %.384.3.i = fadd contract double %.159, %.382.3.i
  %26 = getelementptr i8, ptr %arg.room.4, i64 24
  store double %.384.3.i, ptr %26, align 8, !noalias !41
  %27 = getelementptr i8, ptr %.413, i64 32
  %.380.4.i = load double, ptr %27, align 8, !noalias !41
  %.382.4.i = fmul contract double %.165, %.380.4.i
  %.384.4.i = fadd contract double %.159, %.382.4.i
  %28 = getelementptr i8, ptr %arg.room.4, i64 32
  store double %.384.4.i, ptr %28, align 8, !noalias !41
  %29 = getelementptr i8, ptr %.413, i64 40
  %.380.5.i = load double, ptr %29, align 8, !noalias !41
  %.382.5.i = fmul contract double %.165, %.380.5.i
  %.384.5.i = fadd contract double %.159, %.382.5.i
  %30 = getelementptr i8, ptr %arg.room.4, i64 40
  store double %.384.5.i, ptr %30, align 8, !noalias !41
  %31 = getelementptr i8, ptr %.413, i64 48
  %.380.6.i = load double, ptr %31, align 8, !noalias !41
  %.382.6.i = fmul contract double %.165, %.380.6.i
  %.384.6.i = fadd contract double %.159, %.382.6.i
  %32 = getelementptr i8, ptr %arg.room.4, i64 48
  store double %.384.6.i, ptr %32, align 8, !noalias !41
  %33 = getelementptr i8, ptr %.413, i64 56
  %.380.7.i = load double, ptr %33, align 8, !noalias !41
  %.382.7.i = fmul contract double %.165, %.380.7.i
  %.384.7.i = fadd contract double %.159, %.382.7.i
  %34 = getelementptr i8, ptr %arg.room.4, i64 56
  store double %.384.7.i, ptr %34, align 8, !noalias !41
  br label %B182.if.i

B274.i:                                           ; preds = %B182.if.i
  %.164.i = getelementptr i8, ptr %arg.room.4, i64 512
  %.703.i = getelementptr i8, ptr %arg.arguments.4, i64 64
  %.704.i = load i64, ptr %.703.i, align 8, !noalias !41
  %.709.i = icmp sgt i64 %.704.i, 0
  br i1 %.709.i, label %B322.i, label %B436.i

B322.i:                                           ; preds = %B274.i
  %.741.i = getelementptr i8, ptr %arg.arguments.4, i64 72
  %.742.i = load i64, ptr %.741.i, align 8, !noalias !41
  %.88.i.i = getelementptr i8, ptr %arg.prior.4, i64 56
  %.89.i.i = load double, ptr %.88.i.i, align 8, !noalias !44
  %.117.i.i = getelementptr i8, ptr %arg.prior.4, i64 64
  %.118.i.i = load double, ptr %.117.i.i, align 8, !noalias !44
  %.125.i.i = fdiv contract double 1.000000e+00, %.118.i.i
  %.355.i.i = add nsw i64 %.704.i, -1
  %35 = inttoptr i64 %.742.i to ptr
  br label %B134.if.i.i

B436.i:                                           ; preds = %B134.if.i.i, %B274.i
  %.876.i = load i64, ptr %arg.arguments.4, align 8, !noalias !41
  %.877.i = icmp eq i64 %.876.i, 1
  %.894.i = getelementptr inbounds nuw i8, ptr %arg.room.4, i64 1024
  br i1 %.877.i, label %B584.if.i, label %B706.i

B706.i:                                           ; preds = %B584.if.i, %B436.i
  %.1561.i = load double, ptr %.164.i, align 8, !noalias !41
  %36 = getelementptr i8, ptr %arg.room.4, i64 520
  %.1716.1.i = load double, ptr %36, align 8, !noalias !41
  %.1718.1.i = fcmp contract ogt double %.1716.1.i, %.1561.i
  %.1716.top.2.0.1.i = select i1 %.1718.1.i, double %.1716.1.i, double %.1561.i
  %37 = getelementptr i8, ptr %arg.room.4, i64 528
  %.1716.2.i = load double, ptr %37, align 8, !noalias !41
  %.1718.2.i = fcmp contract ogt double %.1716.2.i, %.1716.top.2.0.1.i
  %.1716.top.2.0.2.i = select i1 %.1718.2.i, double %.1716.2.i, double %.1716.top.2.0.1.i
  %38 = getelementptr i8, ptr %arg.room.4, i64 536
  %.1716.3.i = load double, ptr %38, align 8, !noalias !41
  %.1718.3.i = fcmp contract ogt double %.1716.3.i, %.1716.top.2.0.2.i
  %.1716.top.2.0.3.i = select i1 %.1718.3.i, double %.1716.3.i, double %.1716.top.2.0.2.i
  %39 = getelementptr i8, ptr %arg.room.4, i64 544
  %.1716.4.i = load double, ptr %39, align 8, !noalias !41
  %.1718.4.i = fcmp contract ogt double %.1716.4.i, %.1716.top.2.0.3.i
  %.1716.top.2.0.4.i = select i1 %.1718.4.i, double %.1716.4.i, double %.1716.top.2.0.3.i
  %40 = getelementptr i8, ptr %arg.room.4, i64 552
  %.1716.5.i = load double, ptr %40, align 8, !noalias !41
  %.1718.5.i = fcmp contract ogt double %.1716.5.i, %.1716.top.2.0.4.i
  %.1716.top.2.0.5.i = select i1 %.1718.5.i, double %.1716.5.i, double %.1716.top.2.0.4.i
  %41 = getelementptr i8, ptr %arg.room.4, i64 560
  %.1716.6.i = load double, ptr %41, align 8, !noalias !41
  %.1718.6.i = fcmp contract ogt double %.1716.6.i, %.1716.top.2.0.5.i
  %.1716.top.2.0.6.i = select i1 %.1718.6.i, double %.1716.6.i, double %.1716.top.2.0.5.i
  %42 = getelementptr i8, ptr %arg.room.4, i64 568
  %.1716.7.i = load double, ptr %42, align 8, !noalias !41
  %.1718.7.i = fcmp contract ogt double %.1716.7.i, %.1716.top.2.0.6.i
  %.1716.top.2.0.7.i = select i1 %.1718.7.i, double %.1716.7.i, double %.1716.top.2.0.6.i
  br label %B972.if.i

B1188.i:                                          ; preds = %B972.if.i
  %.487.i.i = load double, ptr %42, align 8, !noalias !47
  %.489.i.i = fadd contract double %.487.i.i, 0.000000e+00
  %.452.i.i = load double, ptr %41, align 8, !noalias !47
  %.454.i.i = fadd contract double %.452.i.i, 0.000000e+00
  %.417.i.i = load double, ptr %40, align 8, !noalias !47
  %.419.i.i = fadd contract double %.417.i.i, 0.000000e+00
  %.382.i.i = load double, ptr %39, align 8, !noalias !47
  %.384.i.i = fadd contract double %.382.i.i, 0.000000e+00
  %.347.i.i = load double, ptr %38, align 8, !noalias !47
  %.349.i.i = fadd contract double %.347.i.i, 0.000000e+00
  %.312.i.i = load double, ptr %37, align 8, !noalias !47
  %.314.i.i = fadd contract double %.312.i.i, 0.000000e+00
  %.277.i.i = load double, ptr %36, align 8, !noalias !47
  %.279.i.i = fadd contract double %.277.i.i, 0.000000e+00
  %.242.i.i = load double, ptr %.164.i, align 8, !noalias !47
  %.244.i.i = fadd contract double %.242.i.i, 0.000000e+00
  %.1254.i = fmul contract double %arg.x, 5.000000e-01
  %.1256.i = fmul contract double %.1254.i, %.159
  %43 = fadd contract double %.279.i.i, %.244.i.i
  %44 = fadd contract double %.349.i.i, %.314.i.i
  %45 = fadd contract double %44, %43
  %46 = fadd contract double %.419.i.i, %.384.i.i
  %47 = fadd contract double %.489.i.i, %.454.i.i
  %48 = fadd contract double %47, %46
  %49 = fadd contract double %48, %45
  %.2091.i = fmul contract double %.165, %49
  %.2123.i = getelementptr i8, ptr %arg.arguments.4, i64 184
  %.2124.i = load i64, ptr %.2123.i, align 8, !noalias !41
  %.2125.i = icmp eq i64 %.2124.i, 0
  br i1 %.2125.i, label %_ZN17bnserve_inference15marginal_kernel9_distance8_by_ruleB3v92B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEdddd27Literal_5bbool_5d_28True_295ArrayIdLi1E1C7mutable7alignedE23Literal_5bint_5d_288_295ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit, label %B1256.if.i

B1326.i:                                          ; preds = %B1256.if.i
  store ptr null, ptr %.2411.i, align 8, !noalias !41
  call fastcc void @inner_4(ptr nonnull %.2411.i, ptr nonnull %.894.i, i64 8, ptr nonnull %arg.room.4, ptr nonnull readonly %arg.arguments.4)
  br label %B1370.i

B1370.i:                                          ; preds = %B1256.if.i, %B1326.i
  %.2614.i = load double, ptr %.164.i, align 8, !noalias !41
  %.2644.i = load double, ptr %arg.room.4, align 8, !noalias !41
  %.2645.i = fmul contract double %.2614.i, %.2644.i
  %.2647.i = fadd contract double %.2645.i, 0.000000e+00
  %.2614.1.i = load double, ptr %36, align 8, !noalias !41
  %.2644.1.i = load double, ptr %22, align 8, !noalias !41
  %.2645.1.i = fmul contract double %.2614.1.i, %.2644.1.i
  %.2647.1.i = fadd contract double %.2647.i, %.2645.1.i
  %.2614.2.i = load double, ptr %37, align 8, !noalias !41
  %.2644.2.i = load double, ptr %24, align 8, !noalias !41
  %.2645.2.i = fmul contract double %.2614.2.i, %.2644.2.i
  %.2647.2.i = fadd contract double %.2647.1.i, %.2645.2.i
  %.2614.3.i = load double, ptr %38, align 8, !noalias !41
  %.2644.3.i = load double, ptr %26, align 8, !noalias !41
  %.2645.3.i = fmul contract double %.2614.3.i, %.2644.3.i
  %.2647.3.i = fadd contract double %.2647.2.i, %.2645.3.i
  %.2614.4.i = load double, ptr %39, align 8, !noalias !41
  %.2644.4.i = load double, ptr %28, align 8, !noalias !41
  %.2645.4.i = fmul contract double %.2614.4.i, %.2644.4.i
  %.2647.4.i = fadd contract double %.2647.3.i, %.2645.4.i
  %.2614.5.i = load double, ptr %40, align 8, !noalias !41
  %.2644.5.i = load double, ptr %30, align 8, !noalias !41
  %.2645.5.i = fmul contract double %.2614.5.i, %.2644.5.i
  %.2647.5.i = fadd contract double %.2647.4.i, %.2645.5.i
  %.2614.6.i = load double, ptr %41, align 8, !noalias !41
  %.2644.6.i = load double, ptr %32, align 8, !noalias !41
  %.2645.6.i = fmul contract double %.2614.6.i, %.2644.6.i
  %.2647.6.i = fadd contract double %.2647.5.i, %.2645.6.i
  %.2614.7.i = load double, ptr %42, align 8, !noalias !41
  %.2644.7.i = load double, ptr %34, align 8, !noalias !41
  %.2645.7.i = fmul contract double %.2614.7.i, %.2644.7.i
  %.2647.7.i = fadd contract double %.2647.6.i, %.2645.7.i
  %.2674.i = fmul contract double %.165, %.2647.7.i
  %.2679.i = fmul contract double %.165, %.2395.7.i
  br label %_ZN17bnserve_inference15marginal_kernel9_distance8_by_ruleB3v92B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEdddd27Literal_5bbool_5d_28True_295ArrayIdLi1E1C7mutable7alignedE23Literal_5bint_5d_288_295ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit

B182.if.i:                                        ; preds = %B182.if.i, %B682
  %.50611811183.i = phi i64 [ %.513.i, %B182.if.i ], [ 0, %B682 ]
  %.513.i = add nuw nsw i64 %.50611811183.i, 1
  %.567.i = load double, ptr %arg.prior.4, align 8, !noalias !41
  %50 = shl nuw nsw i64 %.50611811183.i, 3
  %scevgep8.i = getelementptr i8, ptr %arg.room.4, i64 %50
  %.5981173.i = load i64, ptr %scevgep8.i, align 8, !noalias !41
  %.600.i = add nsw i64 %.5981173.i, -4604544271217802189
  %.601.i = ashr i64 %.600.i, 52
  %.602.i = and i64 %.600.i, -4503599627370496
  %.603.i = sub nsw i64 %.5981173.i, %.602.i
  %.604.i = bitcast i64 %.603.i to double
  %.605.i1 = fadd contract double %.604.i, -1.000000e+00
  %.606.i = fadd contract double %.605.i1, 2.000000e+00
  %.610.i = fdiv contract double %.605.i1, %.606.i
  %.611.i = fmul contract double %.610.i, %.610.i
  %.612.i = fmul contract double %.611.i, %.611.i
  %.613.i = fmul contract double %.612.i, 0x3FC39A09D078C69F
  %.614.i = fadd contract double %.613.i, 0x3FCC71C51D8E78AF
  %.615.i = fmul contract double %.612.i, %.614.i
  %.616.i = fadd contract double %.615.i, 0x3FD999999997FA04
  %.617.i2 = fmul contract double %.612.i, %.616.i
  %.618.i = fmul contract double %.612.i, 0x3FC2F112DF3E5244
  %.619.i = fadd contract double %.618.i, 0x3FC7466496CB03DE
  %.620.i = fmul contract double %.612.i, %.619.i
  %.621.i = fadd contract double %.620.i, 0x3FD2492494229359
  %.622.i = fmul contract double %.612.i, %.621.i
  %.623.i = fadd contract double %.622.i, 0x3FE5555555555593
  %.624.i = fmul contract double %.611.i, %.623.i
  %.625.i = fadd contract double %.617.i2, %.624.i
  %.626.i = fmul contract double %.605.i1, 5.000000e-01
  %.627.i = fmul contract double %.605.i1, %.626.i
  %.628.i = add nsw i64 %.601.i, 4843621399236968448
  %.629.i = bitcast i64 %.628.i to double
  %.630.i = fadd contract double %.629.i, 0xC338000000000000
  %.631.i = fmul contract double %.630.i, 0x3FE62E42FEE00000
  %.632.i = fadd contract double %.627.i, %.625.i
  %.633.i = fmul contract double %.610.i, %.632.i
  %.634.i = fmul contract double %.630.i, 0x3DEA39EF35793C76
  %.635.i = fadd contract double %.634.i, %.633.i
  %.636.i = fsub contract double %.627.i, %.635.i
  %.637.i = fsub contract double %.636.i, %.605.i1
  %.638.i = fsub contract double %.631.i, %.637.i
  %.639.i = fmul contract double %.567.i, %.638.i
  %scevgep7.i = getelementptr i8, ptr %scevgep8.i, i64 512
  store double %.639.i, ptr %scevgep7.i, align 8, !noalias !41
  %exitcond.not.i = icmp eq i64 %.513.i, 8
  br i1 %exitcond.not.i, label %B274.i, label %B182.if.i

B134.if.i.i:                                      ; preds = %B134.if.i.i, %B322.i
  %.230207209.i.i = phi i64 [ 0, %B322.i ], [ %.237.i.i, %B134.if.i.i ]
  %.237.i.i = add nuw nsw i64 %.230207209.i.i, 1
  %51 = shl nuw nsw i64 %.230207209.i.i, 3
  %scevgep5.i = getelementptr i8, ptr %.164.i, i64 %51
  %scevgep4.i = getelementptr i8, ptr %scevgep5.i, i64 -512
  %.296205.i.i = load i64, ptr %scevgep4.i, align 8, !noalias !44
  %.298.i.i = add nsw i64 %.296205.i.i, -4604544271217802189
  %.299.i.i = ashr i64 %.298.i.i, 52
  %.300.i.i = and i64 %.298.i.i, -4503599627370496
  %.301.i.i = sub nsw i64 %.296205.i.i, %.300.i.i
  %.302.i.i = bitcast i64 %.301.i.i to double
  %.303.i.i = fadd contract double %.302.i.i, -1.000000e+00
  %.304.i.i = fadd contract double %.303.i.i, 2.000000e+00
  %.308.i.i = fdiv contract double %.303.i.i, %.304.i.i
  %.309.i.i = fmul contract double %.308.i.i, %.308.i.i
  %.310.i.i = fmul contract double %.309.i.i, %.309.i.i
  %.311.i.i = fmul contract double %.310.i.i, 0x3FC39A09D078C69F
  %.312.i17.i = fadd contract double %.311.i.i, 0x3FCC71C51D8E78AF
  %.313.i.i = fmul contract double %.310.i.i, %.312.i17.i
  %.314.i18.i = fadd contract double %.313.i.i, 0x3FD999999997FA04
  %.315.i.i = fmul contract double %.310.i.i, %.314.i18.i
  %.316.i.i = fmul contract double %.310.i.i, 0x3FC2F112DF3E5244
  %.317.i.i = fadd contract double %.316.i.i, 0x3FC7466496CB03DE
  %.318.i.i = fmul contract double %.310.i.i, %.317.i.i
  %.319.i.i = fadd contract double %.318.i.i, 0x3FD2492494229359
  %.320.i.i = fmul contract double %.310.i.i, %.319.i.i
  %.321.i.i = fadd contract double %.320.i.i, 0x3FE5555555555593
  %.322.i.i = fmul contract double %.309.i.i, %.321.i.i
  %.323.i.i = fadd contract double %.315.i.i, %.322.i.i
  %.324.i.i = fmul contract double %.303.i.i, 5.000000e-01
  %.325.i.i = fmul contract double %.303.i.i, %.324.i.i
  %.326.i.i = add nsw i64 %.299.i.i, 4843621399236968448
  %.327.i.i = bitcast i64 %.326.i.i to double
  %.328.i.i = fadd contract double %.327.i.i, 0xC338000000000000
  %.329.i.i = fmul contract double %.328.i.i, 0x3FE62E42FEE00000
  %.330.i.i = fadd contract double %.325.i.i, %.323.i.i
  %.331.i.i = fmul contract double %.308.i.i, %.330.i.i
  %.332.i.i = fmul contract double %.328.i.i, 0x3DEA39EF35793C76
  %.333.i.i = fadd contract double %.332.i.i, %.331.i.i
  %.334.i.i = fsub contract double %.325.i.i, %.333.i.i
  %.335.i.i = fsub contract double %.334.i.i, %.303.i.i
  %.336.i.i = fsub contract double %.329.i.i, %.335.i.i
  %.337.i.i = fneg contract double %.336.i.i
  %.339.i.i = fsub contract double %.337.i.i, %.89.i.i
  %.341.i.i = fmul contract double %.125.i.i, %.339.i.i
  %.348.i.i = fadd contract double %.341.i.i, -5.000000e-01
  %.349.i19.i = fadd contract double %.348.i.i, 0x4338000000000000
  %.350.i.i = bitcast double %.349.i19.i to i64
  %52 = tail call i64 @llvm.smax.i64(i64 %.350.i.i, i64 4843621399236968448)
  %nearest_cell_v103__vphi100_0.2.1.i.i = add nsw i64 %52, -4843621399236968448
  %nearest_cell_v103__vphi120_0.2.1.i.i = tail call i64 @llvm.smin.i64(i64 %nearest_cell_v103__vphi100_0.2.1.i.i, i64 %.355.i.i)
  %.405.i.i = uitofp nneg i64 %nearest_cell_v103__vphi120_0.2.1.i.i to double
  %.406.i.i = fsub contract double %.341.i.i, %.405.i.i
  %.440.i.i = load double, ptr %scevgep5.i, align 8, !noalias !44
  %.idx.i.i = mul i64 %nearest_cell_v103__vphi120_0.2.1.i.i, 48
  %53 = getelementptr i8, ptr %35, i64 %.idx.i.i
  %.470.i.i = load double, ptr %53, align 8, !noalias !44
  %54 = getelementptr i8, ptr %53, i64 8
  %.501.i.i = load double, ptr %54, align 8, !noalias !44
  %55 = getelementptr i8, ptr %53, i64 16
  %.532.i.i = load double, ptr %55, align 8, !noalias !44
  %56 = getelementptr i8, ptr %53, i64 24
  %.563.i.i = load double, ptr %56, align 8, !noalias !44
  %.564.i.i = fmul contract double %.563.i.i, %.406.i.i
  %.565.i.i = fadd contract double %.532.i.i, %.564.i.i
  %.566.i.i = fmul contract double %.406.i.i, %.565.i.i
  %.567.i.i = fadd contract double %.501.i.i, %.566.i.i
  %.568.i.i = fmul contract double %.406.i.i, %.567.i.i
  %.569.i.i = fadd contract double %.470.i.i, %.568.i.i
  %.570.i.i = fadd contract double %.440.i.i, %.569.i.i
  store double %.570.i.i, ptr %scevgep5.i, align 8, !noalias !44
  %exitcond.not.i22.i = icmp eq i64 %.237.i.i, 8
  br i1 %exitcond.not.i22.i, label %B436.i, label %B134.if.i.i

B584.if.i:                                        ; preds = %B436.i
  %.1102.i = fmul contract double %arg.x, %.384.i
  store double %.1102.i, ptr %.894.i, align 8, !noalias !41
  %.1102.1.i = fmul contract double %arg.x, %.384.1.i
  %57 = getelementptr i8, ptr %arg.room.4, i64 1032
  store double %.1102.1.i, ptr %57, align 8, !noalias !41
  %.1102.2.i = fmul contract double %arg.x, %.384.2.i
  %58 = getelementptr i8, ptr %arg.room.4, i64 1040
  store double %.1102.2.i, ptr %58, align 8, !noalias !41
  %.1102.3.i = fmul contract double %arg.x, %.384.3.i
  %59 = getelementptr i8, ptr %arg.room.4, i64 1048
  store double %.1102.3.i, ptr %59, align 8, !noalias !41
  %.1102.4.i = fmul contract double %arg.x, %.384.4.i
  %60 = getelementptr i8, ptr %arg.room.4, i64 1056
  store double %.1102.4.i, ptr %60, align 8, !noalias !41
  %.1102.5.i = fmul contract double %arg.x, %.384.5.i
  %61 = getelementptr i8, ptr %arg.room.4, i64 1064
  store double %.1102.5.i, ptr %61, align 8, !noalias !41
  %.1102.6.i = fmul contract double %arg.x, %.384.6.i
  %62 = getelementptr i8, ptr %arg.room.4, i64 1072
  store double %.1102.6.i, ptr %62, align 8, !noalias !41
  %.1102.7.i = fmul contract double %arg.x, %.384.7.i
  %63 = getelementptr i8, ptr %arg.room.4, i64 1080
  store double %.1102.7.i, ptr %63, align 8, !noalias !41
  %.1158.i = getelementptr inbounds nuw i8, ptr %arg.room.4, i64 1536
  store ptr null, ptr %.1212.i, align 8, !noalias !41
  call fastcc void @inner_3(ptr nonnull %.1212.i, ptr nonnull %.894.i, i64 8, ptr nonnull readonly %arg.arguments.4, ptr nonnull %.1158.i, ptr nonnull %.164.i)
  br label %B706.i

B972.if.i:                                        ; preds = %B972.if.i, %B706.i
  %lsr.iv.i = phi i64 [ 64, %B706.i ], [ %lsr.iv.next.i, %B972.if.i ]
  %64 = shl nuw nsw i64 %lsr.iv.i, 3
  %scevgep1.i = getelementptr i8, ptr %.413, i64 %64
  %scevgep2.i = getelementptr i8, ptr %scevgep1.i, i64 -448
  %.1930.i = load double, ptr %scevgep2.i, align 8, !noalias !41
  %scevgep.i = getelementptr i8, ptr %arg.room.4, i64 %64
  %.1965.i = load double, ptr %scevgep.i, align 8, !noalias !41
  %.1967.i = fsub contract double %.1965.i, %.1716.top.2.0.7.i
  %.1973.i = fcmp contract ogt double %.1967.i, -7.000000e+02
  %.1967..i = select i1 %.1973.i, double %.1967.i, double -7.000000e+02
  %.1990.i = tail call contract double @llvm.fma.f64(double %.1967..i, double 0x3FF71547652B82FE, double 0x4338000000000000)
  %.1991.i = fadd contract double %.1990.i, 0xC338000000000000
  %.1994.i = tail call contract double @llvm.fma.f64(double %.1991.i, double 0xBFE62E42FEFA39EF, double %.1967..i)
  %.1995.i = tail call contract double @llvm.fma.f64(double %.1991.i, double 0xBC7ABC9E3B39803F, double %.1994.i)
  %.1996.i = tail call contract double @llvm.fma.f64(double %.1995.i, double 0x3DE6124613A86D09, double 0x3E21EED8EFF8D898)
  %.1997.i = tail call contract double @llvm.fma.f64(double %.1995.i, double %.1996.i, double 0x3E5AE64567F544E4)
  %.1998.i = tail call contract double @llvm.fma.f64(double %.1995.i, double %.1997.i, double 0x3E927E4FB7789F5C)
  %.1999.i = tail call contract double @llvm.fma.f64(double %.1995.i, double %.1998.i, double 0x3EC71DE3A556C734)
  %.2000.i = tail call contract double @llvm.fma.f64(double %.1995.i, double %.1999.i, double 0x3EFA01A01A01A01A)
  %.2001.i = tail call contract double @llvm.fma.f64(double %.1995.i, double %.2000.i, double 0x3F2A01A01A01A01A)
  %.2002.i = tail call contract double @llvm.fma.f64(double %.1995.i, double %.2001.i, double 0x3F56C16C16C16C17)
  %.2003.i = tail call contract double @llvm.fma.f64(double %.1995.i, double %.2002.i, double 0x3F81111111111111)
  %.2004.i = tail call contract double @llvm.fma.f64(double %.1995.i, double %.2003.i, double 0x3FA5555555555555)
  %.2005.i = tail call contract double @llvm.fma.f64(double %.1995.i, double %.2004.i, double 0x3FC5555555555555)
  %.2006.i = tail call contract double @llvm.fma.f64(double %.1995.i, double %.2005.i, double 5.000000e-01)
  %.2007.i = fmul contract double %.1995.i, %.1995.i
  %.2008.i = fadd contract double %.1995.i, 1.000000e+00
  %.2009.i = tail call contract double @llvm.fma.f64(double %.2007.i, double %.2006.i, double %.2008.i)
  %.2010.i = bitcast double %.1990.i to i64
  %.2011.i = shl i64 %.2010.i, 52
  %.2012.i = add i64 %.2011.i, 4607182418800017408
  %.2013.i = bitcast i64 %.2012.i to double
  %.2014.i = fmul contract double %.2009.i, %.2013.i
  %.2016.i = fmul contract double %.1930.i, %.2014.i
  store double %.2016.i, ptr %scevgep.i, align 8, !noalias !41
  %lsr.iv.next.i = add nuw nsw i64 %lsr.iv.i, 1
  %exitcond1230.not.i = icmp eq i64 %lsr.iv.next.i, 72
  br i1 %exitcond1230.not.i, label %B1188.i, label %B972.if.i

B1256.if.i:                                       ; preds = %B1188.i
  %.2361.i = load double, ptr %arg.room.4, align 8, !noalias !41
  %.2362.i = fmul contract double %.242.i.i, %.2361.i
  %.2393.i = fmul contract double %.2361.i, %.2362.i
  %.2395.i = fadd contract double %.2393.i, 0.000000e+00
  %.2361.1.i = load double, ptr %22, align 8, !noalias !41
  %.2362.1.i = fmul contract double %.277.i.i, %.2361.1.i
  %.2393.1.i = fmul contract double %.2361.1.i, %.2362.1.i
  %.2395.1.i = fadd contract double %.2395.i, %.2393.1.i
  %.2361.2.i = load double, ptr %24, align 8, !noalias !41
  %.2362.2.i = fmul contract double %.312.i.i, %.2361.2.i
  %.2393.2.i = fmul contract double %.2361.2.i, %.2362.2.i
  %.2395.2.i = fadd contract double %.2395.1.i, %.2393.2.i
  %.2361.3.i = load double, ptr %26, align 8, !noalias !41
  %.2362.3.i = fmul contract double %.347.i.i, %.2361.3.i
  %.2393.3.i = fmul contract double %.2361.3.i, %.2362.3.i
  %.2395.3.i = fadd contract double %.2395.2.i, %.2393.3.i
  %.2361.4.i = load double, ptr %28, align 8, !noalias !41
  %.2362.4.i = fmul contract double %.382.i.i, %.2361.4.i
  %.2393.4.i = fmul contract double %.2361.4.i, %.2362.4.i
  %.2395.4.i = fadd contract double %.2395.3.i, %.2393.4.i
  %.2361.5.i = load double, ptr %30, align 8, !noalias !41
  %.2362.5.i = fmul contract double %.417.i.i, %.2361.5.i
  %.2393.5.i = fmul contract double %.2361.5.i, %.2362.5.i
  %.2395.5.i = fadd contract double %.2395.4.i, %.2393.5.i
  %.2361.6.i = load double, ptr %32, align 8, !noalias !41
  %.2362.6.i = fmul contract double %.452.i.i, %.2361.6.i
  %.2393.6.i = fmul contract double %.2361.6.i, %.2362.6.i
  %.2395.6.i = fadd contract double %.2395.5.i, %.2393.6.i
  %.2361.7.i = load double, ptr %34, align 8, !noalias !41
  %.2362.7.i = fmul contract double %.487.i.i, %.2361.7.i
  %.2393.7.i = fmul contract double %.2361.7.i, %.2362.7.i
  %.2395.7.i = fadd contract double %.2395.6.i, %.2393.7.i
  br i1 %.877.i, label %B1326.i, label %B1370.i

_ZN17bnserve_inference15marginal_kernel9_distance8_by_ruleB3v92B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEdddd27Literal_5bbool_5d_28True_295ArrayIdLi1E1C7mutable7alignedE23Literal_5bint_5d_288_295ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit: ; preds = %B1188.i, %B1370.i
  %.469.sroa.8.0 = phi double [ %.2674.i, %B1370.i ], [ 0.000000e+00, %B1188.i ]
  %.469.sroa.11.0 = phi double [ %.2679.i, %B1370.i ], [ 0.000000e+00, %B1188.i ]
  %.469.sroa.0.0 = fadd contract double %.1256.i, %.1716.top.2.0.7.i
  call void @llvm.lifetime.end.p0(ptr nonnull %.1212.i)
  call void @llvm.lifetime.end.p0(ptr nonnull %.2411.i)
  br label %common.ret

B686:                                             ; preds = %B360
  %.567 = getelementptr i8, ptr %arg.prior.4, i64 48
  %.568 = load double, ptr %.567, align 8
  br i1 %.294, label %B688, label %B962

B688:                                             ; preds = %B686
  %.667 = fadd contract double %.159, %.257
  %.698 = getelementptr i8, ptr %arg.prior.4, i64 16
  %.699 = load double, ptr %.698, align 8
  %.705 = fcmp contract olt double %.667, %.699
  br label %B962

B962:                                             ; preds = %B688, %B686
  %is_normal_v72__vphi176_0.2.0 = phi i1 [ %.705, %B688 ], [ false, %B686 ]
  %.725 = fmul contract double %.159, %.568
  %.731 = fcmp contract olt double %.165, %.725
  %is_normal_v72__vphi198_0.2.0 = select i1 %is_normal_v72__vphi176_0.2.0, i1 %.731, i1 false
  br i1 %is_normal_v72__vphi198_0.2.0, label %B1324, label %B1408

B1324:                                            ; preds = %B962
  %.776 = getelementptr i8, ptr %arg.arguments.4, i64 88
  %.777 = load i64, ptr %.776, align 8
  %.779 = inttoptr i64 %.777 to ptr
  call void @llvm.lifetime.start.p0(ptr nonnull %.1212.i3)
  call void @llvm.lifetime.start.p0(ptr nonnull %.2411.i5)
  store ptr null, ptr %.1212.i3, align 8, !noalias !50
  store ptr null, ptr %.2411.i5, align 8, !noalias !50
  br label %B112.if.i

B274.i60:                                         ; preds = %B182.if.i20
  %.703.i61 = getelementptr i8, ptr %arg.arguments.4, i64 64
  %.704.i62 = load i64, ptr %.703.i61, align 8, !noalias !50
  %.709.i63 = icmp sgt i64 %.704.i62, 0
  br i1 %.709.i63, label %B322.i182, label %B436.i64

B322.i182:                                        ; preds = %B274.i60
  %.88.i.i183 = getelementptr i8, ptr %arg.prior.4, i64 56
  %.89.i.i184 = load double, ptr %.88.i.i183, align 8, !noalias !53
  %.117.i.i185 = getelementptr i8, ptr %arg.prior.4, i64 64
  %.118.i.i186 = load double, ptr %.117.i.i185, align 8, !noalias !53
  %.125.i.i187 = fdiv contract double 1.000000e+00, %.118.i.i186
  %.741.i188 = getelementptr i8, ptr %arg.arguments.4, i64 72
  %.742.i189 = load i64, ptr %.741.i188, align 8, !noalias !50
  %.355.i.i190 = add nsw i64 %.704.i62, -1
  %65 = inttoptr i64 %.742.i189 to ptr
  br label %B134.if.i.i191

B436.i64:                                         ; preds = %B134.if.i.i191, %B274.i60
  %.876.i65 = load i64, ptr %arg.arguments.4, align 8, !noalias !50
  %.877.i66 = icmp eq i64 %.876.i65, 1
  %.894.i67 = getelementptr inbounds nuw i8, ptr %arg.room.4, i64 1024
  br i1 %.877.i66, label %B584.if.i175, label %B706.i68

B618.i:                                           ; preds = %B584.if.i175
  %.1158.i180 = getelementptr inbounds nuw i8, ptr %arg.room.4, i64 1536
  store ptr null, ptr %.1212.i3, align 8, !noalias !50
  call fastcc void @inner_3(ptr nonnull %.1212.i3, ptr nonnull %.894.i67, i64 16, ptr nonnull readonly %arg.arguments.4, ptr nonnull %.1158.i180, ptr nonnull %.164.i19)
  br label %B706.i68

B706.i68:                                         ; preds = %B618.i, %B436.i64
  %.1561.i69 = load double, ptr %.164.i19, align 8, !noalias !50
  br label %B892.if.i

B1188.i109:                                       ; preds = %B972.if.i79
  %scevgep.i.i = getelementptr i8, ptr %arg.room.4, i64 568
  br label %B104.if.i.i

B104.if.i.i:                                      ; preds = %B104.if.i.i, %B1188.i109
  %lsr.iv9.i.i = phi i64 [ 2, %B1188.i109 ], [ %lsr.iv.next.i.i, %B104.if.i.i ]
  %lsr.iv.i.i = phi ptr [ %scevgep.i.i, %B1188.i109 ], [ %scevgep1.i.i, %B104.if.i.i ]
  %s7.2.0168.i.i = phi double [ 0.000000e+00, %B1188.i109 ], [ %.489.i.i125, %B104.if.i.i ]
  %s6.2.0167.i.i = phi double [ 0.000000e+00, %B1188.i109 ], [ %.454.i.i123, %B104.if.i.i ]
  %s5.2.0166.i.i = phi double [ 0.000000e+00, %B1188.i109 ], [ %.419.i.i121, %B104.if.i.i ]
  %s4.2.0165.i.i = phi double [ 0.000000e+00, %B1188.i109 ], [ %.384.i.i119, %B104.if.i.i ]
  %s3.2.0164.i.i = phi double [ 0.000000e+00, %B1188.i109 ], [ %.349.i.i117, %B104.if.i.i ]
  %s2.2.0163.i.i = phi double [ 0.000000e+00, %B1188.i109 ], [ %.314.i.i115, %B104.if.i.i ]
  %s1.2.0162.i.i = phi double [ 0.000000e+00, %B1188.i109 ], [ %.279.i.i113, %B104.if.i.i ]
  %s0.2.0161.i.i = phi double [ 0.000000e+00, %B1188.i109 ], [ %.244.i.i111, %B104.if.i.i ]
  %scevgep2.i.i = getelementptr i8, ptr %lsr.iv.i.i, i64 -56
  %.242.i.i110 = load double, ptr %scevgep2.i.i, align 8, !noalias !56
  %.244.i.i111 = fadd contract double %s0.2.0161.i.i, %.242.i.i110
  %scevgep3.i.i = getelementptr i8, ptr %lsr.iv.i.i, i64 -48
  %.277.i.i112 = load double, ptr %scevgep3.i.i, align 8, !noalias !56
  %.279.i.i113 = fadd contract double %s1.2.0162.i.i, %.277.i.i112
  %scevgep4.i.i = getelementptr i8, ptr %lsr.iv.i.i, i64 -40
  %.312.i.i114 = load double, ptr %scevgep4.i.i, align 8, !noalias !56
  %.314.i.i115 = fadd contract double %s2.2.0163.i.i, %.312.i.i114
  %scevgep5.i.i = getelementptr i8, ptr %lsr.iv.i.i, i64 -32
  %.347.i.i116 = load double, ptr %scevgep5.i.i, align 8, !noalias !56
  %.349.i.i117 = fadd contract double %s3.2.0164.i.i, %.347.i.i116
  %scevgep6.i.i = getelementptr i8, ptr %lsr.iv.i.i, i64 -24
  %.382.i.i118 = load double, ptr %scevgep6.i.i, align 8, !noalias !56
  %.384.i.i119 = fadd contract double %s4.2.0165.i.i, %.382.i.i118
  %scevgep7.i.i = getelementptr i8, ptr %lsr.iv.i.i, i64 -16
  %.417.i.i120 = load double, ptr %scevgep7.i.i, align 8, !noalias !56
  %.419.i.i121 = fadd contract double %s5.2.0166.i.i, %.417.i.i120
  %scevgep8.i.i = getelementptr i8, ptr %lsr.iv.i.i, i64 -8
  %.452.i.i122 = load double, ptr %scevgep8.i.i, align 8, !noalias !56
  %.454.i.i123 = fadd contract double %s6.2.0167.i.i, %.452.i.i122
  %.487.i.i124 = load double, ptr %lsr.iv.i.i, align 8, !noalias !56
  %.489.i.i125 = fadd contract double %s7.2.0168.i.i, %.487.i.i124
  %scevgep1.i.i = getelementptr i8, ptr %lsr.iv.i.i, i64 64
  %lsr.iv.next.i.i = add nsw i64 %lsr.iv9.i.i, -1
  %exitcond.not.i.i = icmp eq i64 %lsr.iv.next.i.i, 0
  br i1 %exitcond.not.i.i, label %B1188.endif.i, label %B104.if.i.i

B1324.i:                                          ; preds = %B1256.if.i132
  br i1 %.877.i66, label %B1326.i171, label %B3875.if.i.preheader

B3875.if.i.preheader:                             ; preds = %B1326.i171, %B1324.i
  br label %B3875.if.i

B1326.i171:                                       ; preds = %B1324.i
  store ptr null, ptr %.2411.i5, align 8, !noalias !50
  call fastcc void @inner_4(ptr nonnull %.2411.i5, ptr nonnull %.894.i67, i64 16, ptr %arg.room.4, ptr nonnull readonly %arg.arguments.4)
  br label %B3875.if.i.preheader

B3891.i:                                          ; preds = %B3875.if.i
  %.2674.i167 = fmul contract double %.165, %.2647.3.i165
  %.2679.i168 = fmul contract double %.165, %.2395.3.i148
  br label %_ZN17bnserve_inference15marginal_kernel9_distance8_by_ruleB4v105B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEdddd27Literal_5bbool_5d_28True_295ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit

B112.if.i:                                        ; preds = %B112.if.i, %B1324
  %.31911871189.i = phi i64 [ 0, %B1324 ], [ %.326.3.i, %B112.if.i ]
  %sunkaddr83.i = shl i64 %.31911871189.i, 3
  %sunkaddr84.i = getelementptr i8, ptr %.779, i64 %sunkaddr83.i
  %.380.i7 = load double, ptr %sunkaddr84.i, align 8, !noalias !50
  %.382.i8 = fmul contract double %.165, %.380.i7
  %.384.i9 = fadd contract double %.159, %.382.i8
  %sunkaddr86.i = getelementptr i8, ptr %arg.room.4, i64 %sunkaddr83.i
  store double %.384.i9, ptr %sunkaddr86.i, align 8, !noalias !50
  %sunkaddr88.i = getelementptr i8, ptr %sunkaddr84.i, i64 8
  %.380.1.i10 = load double, ptr %sunkaddr88.i, align 8, !noalias !50
  %.382.1.i11 = fmul contract double %.165, %.380.1.i10
  %.384.1.i12 = fadd contract double %.159, %.382.1.i11
  %sunkaddr91.i = getelementptr i8, ptr %sunkaddr86.i, i64 8
  store double %.384.1.i12, ptr %sunkaddr91.i, align 8, !noalias !50
  %sunkaddr94.i = getelementptr i8, ptr %sunkaddr84.i, i64 16
  %.380.2.i13 = load double, ptr %sunkaddr94.i, align 8, !noalias !50
  %.382.2.i14 = fmul contract double %.165, %.380.2.i13
  %.384.2.i15 = fadd contract double %.159, %.382.2.i14
  %sunkaddr97.i = getelementptr i8, ptr %sunkaddr86.i, i64 16
  store double %.384.2.i15, ptr %sunkaddr97.i, align 8, !noalias !50
  %.326.3.i = add nuw nsw i64 %.31911871189.i, 4
  %sunkaddr100.i = getelementptr i8, ptr %sunkaddr84.i, i64 24
  %.380.3.i16 = load double, ptr %sunkaddr100.i, align 8, !noalias !50
  %.382.3.i17 = fmul contract double %.165, %.380.3.i16
  %.384.3.i18 = fadd contract double %.159, %.382.3.i17
  %sunkaddr103.i = getelementptr i8, ptr %sunkaddr86.i, i64 24
  store double %.384.3.i18, ptr %sunkaddr103.i, align 8, !noalias !50
  %niter.ncmp.3.i = icmp eq i64 %.326.3.i, 16
  br i1 %niter.ncmp.3.i, label %B182.if.preheader.i, label %B112.if.i

B182.if.preheader.i:                              ; preds = %B112.if.i
  %.164.i19 = getelementptr i8, ptr %arg.room.4, i64 512
  br label %B182.if.i20

B182.if.i20:                                      ; preds = %B182.if.i20, %B182.if.preheader.i
  %.50611931195.i = phi i64 [ %.513.i21, %B182.if.i20 ], [ 0, %B182.if.preheader.i ]
  %.513.i21 = add nuw nsw i64 %.50611931195.i, 1
  %.567.i22 = load double, ptr %arg.prior.4, align 8, !noalias !50
  %66 = shl i64 %.50611931195.i, 3
  %scevgep171.i = getelementptr i8, ptr %.164.i19, i64 %66
  %scevgep172.i = getelementptr i8, ptr %scevgep171.i, i64 -512
  %.5981179.i = load i64, ptr %scevgep172.i, align 8, !noalias !50
  %.600.i23 = add nsw i64 %.5981179.i, -4604544271217802189
  %.601.i24 = ashr i64 %.600.i23, 52
  %.602.i25 = and i64 %.600.i23, -4503599627370496
  %.603.i26 = sub nsw i64 %.5981179.i, %.602.i25
  %.604.i27 = bitcast i64 %.603.i26 to double
  %.605.i28 = fadd contract double %.604.i27, -1.000000e+00
  %.606.i29 = fadd contract double %.605.i28, 2.000000e+00
  %.610.i30 = fdiv contract double %.605.i28, %.606.i29
  %.611.i31 = fmul contract double %.610.i30, %.610.i30
  %.612.i32 = fmul contract double %.611.i31, %.611.i31
  %.613.i33 = fmul contract double %.612.i32, 0x3FC39A09D078C69F
  %.614.i34 = fadd contract double %.613.i33, 0x3FCC71C51D8E78AF
  %.615.i35 = fmul contract double %.612.i32, %.614.i34
  %.616.i36 = fadd contract double %.615.i35, 0x3FD999999997FA04
  %.617.i37 = fmul contract double %.612.i32, %.616.i36
  %.618.i38 = fmul contract double %.612.i32, 0x3FC2F112DF3E5244
  %.619.i39 = fadd contract double %.618.i38, 0x3FC7466496CB03DE
  %.620.i40 = fmul contract double %.612.i32, %.619.i39
  %.621.i41 = fadd contract double %.620.i40, 0x3FD2492494229359
  %.622.i42 = fmul contract double %.612.i32, %.621.i41
  %.623.i43 = fadd contract double %.622.i42, 0x3FE5555555555593
  %.624.i44 = fmul contract double %.611.i31, %.623.i43
  %.625.i45 = fadd contract double %.617.i37, %.624.i44
  %.626.i46 = fmul contract double %.605.i28, 5.000000e-01
  %.627.i47 = fmul contract double %.605.i28, %.626.i46
  %.628.i48 = add nsw i64 %.601.i24, 4843621399236968448
  %.629.i49 = bitcast i64 %.628.i48 to double
  %.630.i50 = fadd contract double %.629.i49, 0xC338000000000000
  %.631.i51 = fmul contract double %.630.i50, 0x3FE62E42FEE00000
  %.632.i52 = fadd contract double %.627.i47, %.625.i45
  %.633.i53 = fmul contract double %.610.i30, %.632.i52
  %.634.i54 = fmul contract double %.630.i50, 0x3DEA39EF35793C76
  %.635.i55 = fadd contract double %.634.i54, %.633.i53
  %.636.i56 = fsub contract double %.627.i47, %.635.i55
  %.637.i57 = fsub contract double %.636.i56, %.605.i28
  %.638.i58 = fsub contract double %.631.i51, %.637.i57
  %.639.i59 = fmul contract double %.567.i22, %.638.i58
  store double %.639.i59, ptr %scevgep171.i, align 8, !noalias !50
  %exitcond1240.not.i = icmp eq i64 %.513.i21, 16
  br i1 %exitcond1240.not.i, label %B274.i60, label %B182.if.i20

B134.if.i.i191:                                   ; preds = %B134.if.i.i191, %B322.i182
  %.230207209.i.i192 = phi i64 [ 0, %B322.i182 ], [ %.237.i.i193, %B134.if.i.i191 ]
  %.237.i.i193 = add nuw nsw i64 %.230207209.i.i192, 1
  %67 = shl i64 %.230207209.i.i192, 3
  %scevgep168.i = getelementptr i8, ptr %.164.i19, i64 %67
  %scevgep169.i = getelementptr i8, ptr %scevgep168.i, i64 -512
  %.296205.i.i194 = load i64, ptr %scevgep169.i, align 8, !noalias !53
  %.298.i.i195 = add nsw i64 %.296205.i.i194, -4604544271217802189
  %.299.i.i196 = ashr i64 %.298.i.i195, 52
  %.300.i.i197 = and i64 %.298.i.i195, -4503599627370496
  %.301.i.i198 = sub nsw i64 %.296205.i.i194, %.300.i.i197
  %.302.i.i199 = bitcast i64 %.301.i.i198 to double
  %.303.i.i200 = fadd contract double %.302.i.i199, -1.000000e+00
  %.304.i.i201 = fadd contract double %.303.i.i200, 2.000000e+00
  %.308.i.i202 = fdiv contract double %.303.i.i200, %.304.i.i201
  %.309.i.i203 = fmul contract double %.308.i.i202, %.308.i.i202
  %.310.i.i204 = fmul contract double %.309.i.i203, %.309.i.i203
  %.311.i.i205 = fmul contract double %.310.i.i204, 0x3FC39A09D078C69F
  %.312.i26.i = fadd contract double %.311.i.i205, 0x3FCC71C51D8E78AF
  %.313.i.i206 = fmul contract double %.310.i.i204, %.312.i26.i
  %.314.i27.i = fadd contract double %.313.i.i206, 0x3FD999999997FA04
  %.315.i.i207 = fmul contract double %.310.i.i204, %.314.i27.i
  %.316.i.i208 = fmul contract double %.310.i.i204, 0x3FC2F112DF3E5244
  %.317.i.i209 = fadd contract double %.316.i.i208, 0x3FC7466496CB03DE
  %.318.i.i210 = fmul contract double %.310.i.i204, %.317.i.i209
  %.319.i.i211 = fadd contract double %.318.i.i210, 0x3FD2492494229359
  %.320.i.i212 = fmul contract double %.310.i.i204, %.319.i.i211
  %.321.i.i213 = fadd contract double %.320.i.i212, 0x3FE5555555555593
  %.322.i.i214 = fmul contract double %.309.i.i203, %.321.i.i213
  %.323.i.i215 = fadd contract double %.315.i.i207, %.322.i.i214
  %.324.i.i216 = fmul contract double %.303.i.i200, 5.000000e-01
  %.325.i.i217 = fmul contract double %.303.i.i200, %.324.i.i216
  %.326.i.i218 = add nsw i64 %.299.i.i196, 4843621399236968448
  %.327.i.i219 = bitcast i64 %.326.i.i218 to double
  %.328.i.i220 = fadd contract double %.327.i.i219, 0xC338000000000000
  %.329.i.i221 = fmul contract double %.328.i.i220, 0x3FE62E42FEE00000
  %.330.i.i222 = fadd contract double %.325.i.i217, %.323.i.i215
  %.331.i.i223 = fmul contract double %.308.i.i202, %.330.i.i222
  %.332.i.i224 = fmul contract double %.328.i.i220, 0x3DEA39EF35793C76
  %.333.i.i225 = fadd contract double %.332.i.i224, %.331.i.i223
  %.334.i.i226 = fsub contract double %.325.i.i217, %.333.i.i225
  %.335.i.i227 = fsub contract double %.334.i.i226, %.303.i.i200
  %.336.i.i228 = fsub contract double %.329.i.i221, %.335.i.i227
  %.337.i.i229 = fneg contract double %.336.i.i228
  %.339.i.i230 = fsub contract double %.337.i.i229, %.89.i.i184
  %.341.i.i231 = fmul contract double %.125.i.i187, %.339.i.i230
  %.348.i.i232 = fadd contract double %.341.i.i231, -5.000000e-01
  %.349.i28.i = fadd contract double %.348.i.i232, 0x4338000000000000
  %.350.i.i233 = bitcast double %.349.i28.i to i64
  %68 = tail call i64 @llvm.smax.i64(i64 %.350.i.i233, i64 4843621399236968448)
  %nearest_cell_v103__vphi100_0.2.1.i.i234 = add nsw i64 %68, -4843621399236968448
  %nearest_cell_v103__vphi120_0.2.1.i.i235 = tail call i64 @llvm.smin.i64(i64 %nearest_cell_v103__vphi100_0.2.1.i.i234, i64 %.355.i.i190)
  %.405.i.i236 = uitofp nneg i64 %nearest_cell_v103__vphi120_0.2.1.i.i235 to double
  %.406.i.i237 = fsub contract double %.341.i.i231, %.405.i.i236
  %.440.i.i238 = load double, ptr %scevgep168.i, align 8, !noalias !53
  %.idx.i.i239 = mul i64 %nearest_cell_v103__vphi120_0.2.1.i.i235, 48
  %69 = getelementptr i8, ptr %65, i64 %.idx.i.i239
  %.470.i.i240 = load double, ptr %69, align 8, !noalias !53
  %70 = getelementptr i8, ptr %69, i64 8
  %.501.i.i241 = load double, ptr %70, align 8, !noalias !53
  %71 = getelementptr i8, ptr %69, i64 16
  %.532.i.i242 = load double, ptr %71, align 8, !noalias !53
  %72 = getelementptr i8, ptr %69, i64 24
  %.563.i.i243 = load double, ptr %72, align 8, !noalias !53
  %.564.i.i244 = fmul contract double %.563.i.i243, %.406.i.i237
  %.565.i.i245 = fadd contract double %.532.i.i242, %.564.i.i244
  %.566.i.i246 = fmul contract double %.406.i.i237, %.565.i.i245
  %.567.i.i247 = fadd contract double %.501.i.i241, %.566.i.i246
  %.568.i.i248 = fmul contract double %.406.i.i237, %.567.i.i247
  %.569.i.i249 = fadd contract double %.470.i.i240, %.568.i.i248
  %.570.i.i250 = fadd contract double %.440.i.i238, %.569.i.i249
  store double %.570.i.i250, ptr %scevgep168.i, align 8, !noalias !53
  %exitcond.not.i31.i = icmp eq i64 %.237.i.i193, 16
  br i1 %exitcond.not.i31.i, label %B436.i64, label %B134.if.i.i191

B584.if.i175:                                     ; preds = %B436.i64, %B584.if.i175
  %.103912001202.i = phi i64 [ %.1046.3.i, %B584.if.i175 ], [ 0, %B436.i64 ]
  %sunkaddr104.i = shl i64 %.103912001202.i, 3
  %sunkaddr105.i = getelementptr i8, ptr %arg.room.4, i64 %sunkaddr104.i
  %.1100.i = load double, ptr %sunkaddr105.i, align 8, !noalias !50
  %.1102.i176 = fmul contract double %arg.x, %.1100.i
  %sunkaddr109.i = getelementptr i8, ptr %sunkaddr105.i, i64 1024
  store double %.1102.i176, ptr %sunkaddr109.i, align 8, !noalias !50
  %sunkaddr112.i = getelementptr i8, ptr %sunkaddr105.i, i64 8
  %.1100.1.i = load double, ptr %sunkaddr112.i, align 8, !noalias !50
  %.1102.1.i177 = fmul contract double %arg.x, %.1100.1.i
  %sunkaddr115.i = getelementptr i8, ptr %sunkaddr105.i, i64 1032
  store double %.1102.1.i177, ptr %sunkaddr115.i, align 8, !noalias !50
  %sunkaddr118.i = getelementptr i8, ptr %sunkaddr105.i, i64 16
  %.1100.2.i = load double, ptr %sunkaddr118.i, align 8, !noalias !50
  %.1102.2.i178 = fmul contract double %arg.x, %.1100.2.i
  %sunkaddr121.i = getelementptr i8, ptr %sunkaddr105.i, i64 1040
  store double %.1102.2.i178, ptr %sunkaddr121.i, align 8, !noalias !50
  %.1046.3.i = add nuw nsw i64 %.103912001202.i, 4
  %sunkaddr124.i = getelementptr i8, ptr %sunkaddr105.i, i64 24
  %.1100.3.i = load double, ptr %sunkaddr124.i, align 8, !noalias !50
  %.1102.3.i179 = fmul contract double %arg.x, %.1100.3.i
  %sunkaddr127.i = getelementptr i8, ptr %sunkaddr105.i, i64 1048
  store double %.1102.3.i179, ptr %sunkaddr127.i, align 8, !noalias !50
  %niter83.ncmp.3.i = icmp eq i64 %.1046.3.i, 16
  br i1 %niter83.ncmp.3.i, label %B618.i, label %B584.if.i175

B892.if.i:                                        ; preds = %B892.if.i, %B706.i68
  %top.2.01211.i = phi double [ %.1561.i69, %B706.i68 ], [ %.1716.top.2.0.3.i78, %B892.if.i ]
  %.165112071209.i = phi i64 [ 0, %B706.i68 ], [ %.1658.3.i, %B892.if.i ]
  %sunkaddr128.i = shl i64 %.165112071209.i, 3
  %sunkaddr129.i = getelementptr i8, ptr %arg.room.4, i64 %sunkaddr128.i
  %sunkaddr131.i = getelementptr i8, ptr %sunkaddr129.i, i64 512
  %.1716.i = load double, ptr %sunkaddr131.i, align 8, !noalias !50
  %.1718.i = fcmp contract ogt double %.1716.i, %top.2.01211.i
  %.1716.top.2.0.i = select i1 %.1718.i, double %.1716.i, double %top.2.01211.i
  %sunkaddr134.i = getelementptr i8, ptr %sunkaddr129.i, i64 520
  %.1716.1.i70 = load double, ptr %sunkaddr134.i, align 8, !noalias !50
  %.1718.1.i71 = fcmp contract ogt double %.1716.1.i70, %.1716.top.2.0.i
  %.1716.top.2.0.1.i72 = select i1 %.1718.1.i71, double %.1716.1.i70, double %.1716.top.2.0.i
  %sunkaddr137.i = getelementptr i8, ptr %sunkaddr129.i, i64 528
  %.1716.2.i73 = load double, ptr %sunkaddr137.i, align 8, !noalias !50
  %.1718.2.i74 = fcmp contract ogt double %.1716.2.i73, %.1716.top.2.0.1.i72
  %.1716.top.2.0.2.i75 = select i1 %.1718.2.i74, double %.1716.2.i73, double %.1716.top.2.0.1.i72
  %.1658.3.i = add nuw nsw i64 %.165112071209.i, 4
  %sunkaddr140.i = getelementptr i8, ptr %sunkaddr129.i, i64 536
  %.1716.3.i76 = load double, ptr %sunkaddr140.i, align 8, !noalias !50
  %.1718.3.i77 = fcmp contract ogt double %.1716.3.i76, %.1716.top.2.0.2.i75
  %.1716.top.2.0.3.i78 = select i1 %.1718.3.i77, double %.1716.3.i76, double %.1716.top.2.0.2.i75
  %niter90.ncmp.3.i = icmp eq i64 %.1658.3.i, 16
  br i1 %niter90.ncmp.3.i, label %B972.if.preheader.i, label %B892.if.i

B972.if.preheader.i:                              ; preds = %B892.if.i
  %invariant.gep.i = getelementptr i8, ptr %.779, i64 128
  br label %B972.if.i79

B972.if.i79:                                      ; preds = %B972.if.i79, %B972.if.preheader.i
  %.186312161218.i = phi i64 [ %.1870.i, %B972.if.i79 ], [ 0, %B972.if.preheader.i ]
  %.1870.i = add nuw nsw i64 %.186312161218.i, 1
  %73 = shl i64 %.186312161218.i, 3
  %scevgep138.i = getelementptr i8, ptr %invariant.gep.i, i64 %73
  %.1930.i80 = load double, ptr %scevgep138.i, align 8, !noalias !50
  %scevgep139.i = getelementptr i8, ptr %.164.i19, i64 %73
  %.1965.i81 = load double, ptr %scevgep139.i, align 8, !noalias !50
  %.1967.i82 = fsub contract double %.1965.i81, %.1716.top.2.0.3.i78
  %.1973.i83 = fcmp contract ogt double %.1967.i82, -7.000000e+02
  %.1967..i84 = select i1 %.1973.i83, double %.1967.i82, double -7.000000e+02
  %.1990.i85 = tail call contract double @llvm.fma.f64(double %.1967..i84, double 0x3FF71547652B82FE, double 0x4338000000000000)
  %.1991.i86 = fadd contract double %.1990.i85, 0xC338000000000000
  %.1994.i87 = tail call contract double @llvm.fma.f64(double %.1991.i86, double 0xBFE62E42FEFA39EF, double %.1967..i84)
  %.1995.i88 = tail call contract double @llvm.fma.f64(double %.1991.i86, double 0xBC7ABC9E3B39803F, double %.1994.i87)
  %.1996.i89 = tail call contract double @llvm.fma.f64(double %.1995.i88, double 0x3DE6124613A86D09, double 0x3E21EED8EFF8D898)
  %.1997.i90 = tail call contract double @llvm.fma.f64(double %.1995.i88, double %.1996.i89, double 0x3E5AE64567F544E4)
  %.1998.i91 = tail call contract double @llvm.fma.f64(double %.1995.i88, double %.1997.i90, double 0x3E927E4FB7789F5C)
  %.1999.i92 = tail call contract double @llvm.fma.f64(double %.1995.i88, double %.1998.i91, double 0x3EC71DE3A556C734)
  %.2000.i93 = tail call contract double @llvm.fma.f64(double %.1995.i88, double %.1999.i92, double 0x3EFA01A01A01A01A)
  %.2001.i94 = tail call contract double @llvm.fma.f64(double %.1995.i88, double %.2000.i93, double 0x3F2A01A01A01A01A)
  %.2002.i95 = tail call contract double @llvm.fma.f64(double %.1995.i88, double %.2001.i94, double 0x3F56C16C16C16C17)
  %.2003.i96 = tail call contract double @llvm.fma.f64(double %.1995.i88, double %.2002.i95, double 0x3F81111111111111)
  %.2004.i97 = tail call contract double @llvm.fma.f64(double %.1995.i88, double %.2003.i96, double 0x3FA5555555555555)
  %.2005.i98 = tail call contract double @llvm.fma.f64(double %.1995.i88, double %.2004.i97, double 0x3FC5555555555555)
  %.2006.i99 = tail call contract double @llvm.fma.f64(double %.1995.i88, double %.2005.i98, double 5.000000e-01)
  %.2007.i100 = fmul contract double %.1995.i88, %.1995.i88
  %.2008.i101 = fadd contract double %.1995.i88, 1.000000e+00
  %.2009.i102 = tail call contract double @llvm.fma.f64(double %.2007.i100, double %.2006.i99, double %.2008.i101)
  %.2010.i103 = bitcast double %.1990.i85 to i64
  %.2011.i104 = shl i64 %.2010.i103, 52
  %.2012.i105 = add i64 %.2011.i104, 4607182418800017408
  %.2013.i106 = bitcast i64 %.2012.i105 to double
  %.2014.i107 = fmul contract double %.2009.i102, %.2013.i106
  %.2016.i108 = fmul contract double %.1930.i80, %.2014.i107
  store double %.2016.i108, ptr %scevgep139.i, align 8, !noalias !50
  %exitcond1243.not.i = icmp eq i64 %.1870.i, 16
  br i1 %exitcond1243.not.i, label %B1188.i109, label %B972.if.i79

B1188.endif.i:                                    ; preds = %B104.if.i.i
  %.1254.i126 = fmul contract double %arg.x, 5.000000e-01
  %.1256.i127 = fmul contract double %.1254.i126, %.159
  %74 = fadd contract double %.244.i.i111, %.279.i.i113
  %75 = fadd contract double %.314.i.i115, %.349.i.i117
  %76 = fadd contract double %74, %75
  %77 = fadd contract double %.384.i.i119, %.419.i.i121
  %78 = fadd contract double %.454.i.i123, %.489.i.i125
  %79 = fadd contract double %77, %78
  %80 = fadd contract double %76, %79
  %.2091.i128 = fmul contract double %.165, %80
  %.2123.i129 = getelementptr i8, ptr %arg.arguments.4, i64 184
  %.2124.i130 = load i64, ptr %.2123.i129, align 8, !noalias !50
  %.2125.i131 = icmp eq i64 %.2124.i130, 0
  br i1 %.2125.i131, label %_ZN17bnserve_inference15marginal_kernel9_distance8_by_ruleB4v105B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEdddd27Literal_5bbool_5d_28True_295ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit, label %B1256.if.i132

B1256.if.i132:                                    ; preds = %B1188.endif.i, %B1256.if.i132
  %squares.2.01227.i = phi double [ %.2395.3.i148, %B1256.if.i132 ], [ 0.000000e+00, %B1188.endif.i ]
  %.227012231225.i = phi i64 [ %.2277.3.i, %B1256.if.i132 ], [ 0, %B1188.endif.i ]
  %sunkaddr141.i = shl i64 %.227012231225.i, 3
  %sunkaddr142.i = getelementptr i8, ptr %arg.room.4, i64 %sunkaddr141.i
  %sunkaddr144.i = getelementptr i8, ptr %sunkaddr142.i, i64 512
  %.2331.i = load double, ptr %sunkaddr144.i, align 8, !noalias !50
  %.2361.i133 = load double, ptr %sunkaddr142.i, align 8, !noalias !50
  %.2362.i134 = fmul contract double %.2331.i, %.2361.i133
  %.2393.i135 = fmul contract double %.2361.i133, %.2362.i134
  %.2395.i136 = fadd contract double %squares.2.01227.i, %.2393.i135
  %sunkaddr149.i = getelementptr i8, ptr %sunkaddr142.i, i64 520
  %.2331.1.i = load double, ptr %sunkaddr149.i, align 8, !noalias !50
  %sunkaddr152.i = getelementptr i8, ptr %sunkaddr142.i, i64 8
  %.2361.1.i137 = load double, ptr %sunkaddr152.i, align 8, !noalias !50
  %.2362.1.i138 = fmul contract double %.2331.1.i, %.2361.1.i137
  %.2393.1.i139 = fmul contract double %.2361.1.i137, %.2362.1.i138
  %.2395.1.i140 = fadd contract double %.2395.i136, %.2393.1.i139
  %sunkaddr155.i = getelementptr i8, ptr %sunkaddr142.i, i64 528
  %.2331.2.i = load double, ptr %sunkaddr155.i, align 8, !noalias !50
  %sunkaddr158.i = getelementptr i8, ptr %sunkaddr142.i, i64 16
  %.2361.2.i141 = load double, ptr %sunkaddr158.i, align 8, !noalias !50
  %.2362.2.i142 = fmul contract double %.2331.2.i, %.2361.2.i141
  %.2393.2.i143 = fmul contract double %.2361.2.i141, %.2362.2.i142
  %.2395.2.i144 = fadd contract double %.2395.1.i140, %.2393.2.i143
  %.2277.3.i = add nuw nsw i64 %.227012231225.i, 4
  %sunkaddr161.i = getelementptr i8, ptr %sunkaddr142.i, i64 536
  %.2331.3.i = load double, ptr %sunkaddr161.i, align 8, !noalias !50
  %sunkaddr164.i = getelementptr i8, ptr %sunkaddr142.i, i64 24
  %.2361.3.i145 = load double, ptr %sunkaddr164.i, align 8, !noalias !50
  %.2362.3.i146 = fmul contract double %.2331.3.i, %.2361.3.i145
  %.2393.3.i147 = fmul contract double %.2361.3.i145, %.2362.3.i146
  %.2395.3.i148 = fadd contract double %.2395.2.i144, %.2393.3.i147
  %niter97.ncmp.3.i = icmp eq i64 %.2277.3.i, 16
  br i1 %niter97.ncmp.3.i, label %B1324.i, label %B1256.if.i132

B3875.if.i:                                       ; preds = %B3875.if.i.preheader, %B3875.if.i
  %firsts.2.01236.i = phi double [ %.2647.3.i165, %B3875.if.i ], [ 0.000000e+00, %B3875.if.i.preheader ]
  %.255312321234.i = phi i64 [ %.2560.3.i, %B3875.if.i ], [ 0, %B3875.if.i.preheader ]
  %sunkaddr165.i = shl i64 %.255312321234.i, 3
  %sunkaddr166.i = getelementptr i8, ptr %arg.room.4, i64 %sunkaddr165.i
  %sunkaddr168.i = getelementptr i8, ptr %sunkaddr166.i, i64 512
  %.2614.i150 = load double, ptr %sunkaddr168.i, align 8, !noalias !50
  %.2644.i151 = load double, ptr %sunkaddr166.i, align 8, !noalias !50
  %.2645.i152 = fmul contract double %.2614.i150, %.2644.i151
  %.2647.i153 = fadd contract double %firsts.2.01236.i, %.2645.i152
  %sunkaddr173.i = getelementptr i8, ptr %sunkaddr166.i, i64 520
  %.2614.1.i154 = load double, ptr %sunkaddr173.i, align 8, !noalias !50
  %sunkaddr176.i = getelementptr i8, ptr %sunkaddr166.i, i64 8
  %.2644.1.i155 = load double, ptr %sunkaddr176.i, align 8, !noalias !50
  %.2645.1.i156 = fmul contract double %.2614.1.i154, %.2644.1.i155
  %.2647.1.i157 = fadd contract double %.2647.i153, %.2645.1.i156
  %sunkaddr179.i = getelementptr i8, ptr %sunkaddr166.i, i64 528
  %.2614.2.i158 = load double, ptr %sunkaddr179.i, align 8, !noalias !50
  %sunkaddr182.i = getelementptr i8, ptr %sunkaddr166.i, i64 16
  %.2644.2.i159 = load double, ptr %sunkaddr182.i, align 8, !noalias !50
  %.2645.2.i160 = fmul contract double %.2614.2.i158, %.2644.2.i159
  %.2647.2.i161 = fadd contract double %.2647.1.i157, %.2645.2.i160
  %.2560.3.i = add nuw nsw i64 %.255312321234.i, 4
  %sunkaddr185.i = getelementptr i8, ptr %sunkaddr166.i, i64 536
  %.2614.3.i162 = load double, ptr %sunkaddr185.i, align 8, !noalias !50
  %sunkaddr188.i = getelementptr i8, ptr %sunkaddr166.i, i64 24
  %.2644.3.i163 = load double, ptr %sunkaddr188.i, align 8, !noalias !50
  %.2645.3.i164 = fmul contract double %.2614.3.i162, %.2644.3.i163
  %.2647.3.i165 = fadd contract double %.2647.2.i161, %.2645.3.i164
  %niter104.ncmp.3.i = icmp eq i64 %.2560.3.i, 16
  br i1 %niter104.ncmp.3.i, label %B3891.i, label %B3875.if.i

_ZN17bnserve_inference15marginal_kernel9_distance8_by_ruleB4v105B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEdddd27Literal_5bbool_5d_28True_295ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit: ; preds = %B1188.endif.i, %B3891.i
  %.836.sroa.8.0 = phi double [ %.2674.i167, %B3891.i ], [ 0.000000e+00, %B1188.endif.i ]
  %.836.sroa.11.0 = phi double [ %.2679.i168, %B3891.i ], [ 0.000000e+00, %B1188.endif.i ]
  %.836.sroa.0.0 = fadd contract double %.1256.i127, %.1716.top.2.0.3.i78
  call void @llvm.lifetime.end.p0(ptr nonnull %.1212.i3)
  call void @llvm.lifetime.end.p0(ptr nonnull %.2411.i5)
  br label %common.ret

B1408:                                            ; preds = %B962, %B84
  %.937 = getelementptr i8, ptr %arg.prior.4, i64 8
  %.938 = load double, ptr %.937, align 8
  %.967 = getelementptr i8, ptr %arg.prior.4, i64 16
  %.968 = load double, ptr %.967, align 8
  %.977 = fmul contract double %.968, %.968
  %.981 = fdiv contract double 0x3EB0C6F7A0B5ED8D, %.977
  %.987 = fcmp contract ogt double %arg.n, %.981
  %"$phi688.0.2.0" = select i1 %.987, double %arg.n, double %.981
  %.1009 = fdiv contract double %arg.x, %"$phi688.0.2.0"
  %.12.i = fcmp contract ogt double %.938, %.1009
  %.13.i = select i1 %.12.i, double %.938, double %.1009
  %.12.i17 = fcmp contract olt double %.968, %.13.i
  %.13.i18 = select i1 %.12.i17, double %.968, double %.13.i
  %.1068 = fsub contract double %.13.i18, %.1009
  %.1070 = fmul contract double %.1068, %.1068
  %.1099 = getelementptr i8, ptr %arg.prior.4, i64 24
  %.1100 = load double, ptr %.1099, align 8
  %.1101 = fmul contract double %.1100, 2.000000e+00
  %.1105 = fdiv contract double %.1101, %"$phi688.0.2.0"
  %.1106 = fadd contract double %.1105, %.1070
  %.1107 = tail call contract double @llvm.sqrt.f64(double %.1106)
  %.1108 = fsub contract double %.1009, %.1107
  %.12.i19 = fcmp contract ogt double %.1108, %.938
  %.13.i20 = select i1 %.12.i19, double %.1108, double %.938
  %.1140 = fadd contract double %.1009, %.1107
  %.12.i21 = fcmp contract olt double %.1140, %.968
  %.13.i22 = select i1 %.12.i21, double %.1140, double %.968
  %.1179 = fmul contract double %.13.i20, 1.500000e+00
  %.1181 = fcmp contract olt double %.13.i22, %.1179
  br i1 %.1181, label %B1442, label %B1536

B1442:                                            ; preds = %B1408
  %.1211 = getelementptr i8, ptr %arg.arguments.4, i64 96
  %.1212 = load i64, ptr %.1211, align 8
  %.1242 = getelementptr i8, ptr %arg.arguments.4, i64 104
  %.1243 = load i64, ptr %.1242, align 8
  %.1245 = inttoptr i64 %.1243 to ptr
  %.1295 = fsub contract double %.13.i22, %.13.i20
  %.1298 = fmul contract double %.1295, 5.000000e-01
  %.1307 = fadd contract double %.13.i20, %.1298
  call void @llvm.lifetime.start.p0(ptr nonnull %.1212.i251)
  call void @llvm.lifetime.start.p0(ptr nonnull %.2411.i253)
  store ptr null, ptr %.1212.i251, align 8, !noalias !59
  store ptr null, ptr %.2411.i253, align 8, !noalias !59
  %.164.i255 = getelementptr i8, ptr %arg.room.4, i64 512
  %.271.i = icmp sgt i64 %.1212, 0
  br i1 %.271.i, label %B112.if.preheader.i, label %B274.i256

B112.if.preheader.i:                              ; preds = %B1442
  %xtraiter.i = and i64 %.1212, 3
  %81 = icmp slt i64 %.1212, 4
  br i1 %81, label %B112.if.epil.preheader.i, label %B112.if.preheader.new.i

B112.if.preheader.new.i:                          ; preds = %B112.if.preheader.i
  %unroll_iter.i = and i64 %.1212, 9223372036854775804
  br label %B112.if.i509

B274.i256:                                        ; preds = %B182.if.i532, %B1442
  %.703.i257 = getelementptr i8, ptr %arg.arguments.4, i64 64
  %.704.i258 = load i64, ptr %.703.i257, align 8, !noalias !59
  %.709.i259 = icmp sgt i64 %.704.i258, 0
  br i1 %.709.i259, label %B322.i440, label %B436.i260

B322.i440:                                        ; preds = %B274.i256
  %.88.i.i441 = getelementptr i8, ptr %arg.prior.4, i64 56
  %.89.i.i442 = load double, ptr %.88.i.i441, align 8, !noalias !62
  %.117.i.i443 = getelementptr i8, ptr %arg.prior.4, i64 64
  %.118.i.i444 = load double, ptr %.117.i.i443, align 8, !noalias !62
  %.125.i.i445 = fdiv contract double 1.000000e+00, %.118.i.i444
  %.224208.not.i.i = icmp slt i64 %.1212, 1
  br i1 %.224208.not.i.i, label %B436.i260, label %B134.if.lr.ph.i.i

B436.i260:                                        ; preds = %B134.if.i.i449, %B322.i440, %B274.i256
  %.876.i261 = load i64, ptr %arg.arguments.4, align 8, !noalias !59
  %.877.i262 = icmp eq i64 %.876.i261, 1
  %.894.i263 = getelementptr inbounds nuw i8, ptr %arg.room.4, i64 1024
  br i1 %.877.i262, label %B554.i, label %B706.i264

B554.i:                                           ; preds = %B436.i260
  %.10331203.not.i = icmp slt i64 %.1212, 1
  br i1 %.10331203.not.i, label %B618.i437, label %B584.if.preheader.i

B584.if.preheader.i:                              ; preds = %B554.i
  %xtraiter80.i = and i64 %.1212, 3
  %82 = icmp slt i64 %.1212, 4
  br i1 %82, label %B584.if.epil.preheader.i, label %B584.if.preheader.new.i

B584.if.preheader.new.i:                          ; preds = %B584.if.preheader.i
  %unroll_iter84.i = and i64 %.1212, 9223372036854775804
  br label %B584.if.i422

B618.loopexit.unr-lcssa.i:                        ; preds = %B584.if.i422
  %lcmp.mod82.not.i = icmp eq i64 %xtraiter80.i, 0
  br i1 %lcmp.mod82.not.i, label %B618.i437, label %B584.if.epil.preheader.i

B584.if.epil.preheader.i:                         ; preds = %B618.loopexit.unr-lcssa.i, %B584.if.preheader.i
  %.103912021204.epil.init.i = phi i64 [ 0, %B584.if.preheader.i ], [ %.1046.3.i434, %B618.loopexit.unr-lcssa.i ]
  %83 = shl i64 %.103912021204.epil.init.i, 3
  %84 = getelementptr i8, ptr %arg.room.4, i64 %83
  %scevgep165.i = getelementptr i8, ptr %84, i64 1024
  br label %B584.if.epil.i

B584.if.epil.i:                                   ; preds = %B584.if.epil.i, %B584.if.epil.preheader.i
  %epil.iter81.i = phi i64 [ %epil.iter81.next.i, %B584.if.epil.i ], [ 0, %B584.if.epil.preheader.i ]
  %85 = shl i64 %epil.iter81.i, 3
  %scevgep53.i = getelementptr i8, ptr %scevgep165.i, i64 %85
  %scevgep54.i = getelementptr i8, ptr %scevgep53.i, i64 -1024
  %.1100.epil.i = load double, ptr %scevgep54.i, align 8, !noalias !59
  %.1102.epil.i = fmul contract double %arg.x, %.1100.epil.i
  store double %.1102.epil.i, ptr %scevgep53.i, align 8, !noalias !59
  %epil.iter81.next.i = add i64 %epil.iter81.i, 1
  %epil.iter81.cmp.not.i = icmp eq i64 %xtraiter80.i, %epil.iter81.next.i
  br i1 %epil.iter81.cmp.not.i, label %B618.i437, label %B584.if.epil.i, !llvm.loop !65

B618.i437:                                        ; preds = %B584.if.epil.i, %B618.loopexit.unr-lcssa.i, %B554.i
  %.1158.i438 = getelementptr inbounds nuw i8, ptr %arg.room.4, i64 1536
  store ptr null, ptr %.1212.i251, align 8, !noalias !59
  call fastcc void @inner_3(ptr nonnull %.1212.i251, ptr nonnull %.894.i263, i64 %.1212, ptr nonnull readonly %arg.arguments.4, ptr nonnull %.1158.i438, ptr nonnull %.164.i255)
  br label %B706.i264

B706.i264:                                        ; preds = %B618.i437, %B436.i260
  %.13541210.not.i = icmp slt i64 %.1212, 1
  br i1 %.13541210.not.i, label %B942.thread.i, label %B760.if.lr.ph.i

B942.thread.i:                                    ; preds = %B706.i264
  %.15612.i = load double, ptr %.164.i255, align 8, !noalias !59
  br label %B1188.i320

B760.if.lr.ph.i:                                  ; preds = %B706.i264
  %.1455.i = fmul contract double %arg.n, 5.000000e-01
  %86 = add nsw i64 %.1212, -1
  %87 = icmp eq i64 %86, 0
  br i1 %87, label %B760.if.epil.preheader.i, label %B760.if.lr.ph.new.i

B760.if.lr.ph.new.i:                              ; preds = %B760.if.lr.ph.i
  %unroll_iter90.i = and i64 %.1212, 9223372036854775806
  br label %B760.if.i

B892.if.preheader.unr-lcssa.i:                    ; preds = %B760.if.i
  %88 = and i64 %.1212, 1
  %lcmp.mod88.not.i = icmp eq i64 %88, 0
  br i1 %lcmp.mod88.not.i, label %B892.if.preheader.i, label %B760.if.epil.preheader.i

B760.if.epil.preheader.i:                         ; preds = %B892.if.preheader.unr-lcssa.i, %B760.if.lr.ph.i
  %.136012091211.epil.init.i = phi i64 [ 0, %B760.if.lr.ph.i ], [ %.1367.1.i, %B892.if.preheader.unr-lcssa.i ]
  %sunkaddr.i = shl i64 %.136012091211.epil.init.i, 3
  %sunkaddr211.i = getelementptr i8, ptr %arg.room.4, i64 %sunkaddr.i
  %sunkaddr212.i = getelementptr i8, ptr %sunkaddr211.i, i64 512
  %.1423.epil.i = load double, ptr %sunkaddr212.i, align 8, !noalias !59
  %89 = getelementptr double, ptr %arg.room.4, i64 %.136012091211.epil.init.i
  %.1453.epil.i = load double, ptr %89, align 8, !noalias !59
  %.1486.epil.i = fmul contract double %.1455.i, %.1453.epil.i
  %.1488.epil.i = fsub contract double %arg.x, %.1486.epil.i
  %.1489.epil.i = fmul contract double %.1453.epil.i, %.1488.epil.i
  %.1490.epil.i = fadd contract double %.1423.epil.i, %.1489.epil.i
  store double %.1490.epil.i, ptr %sunkaddr212.i, align 8, !noalias !59
  br label %B892.if.preheader.i

B892.if.preheader.i:                              ; preds = %B760.if.epil.preheader.i, %B892.if.preheader.unr-lcssa.i
  %.1561.i267 = load double, ptr %.164.i255, align 8, !noalias !59
  %xtraiter92.i = and i64 %.1212, 3
  %90 = icmp ult i64 %86, 3
  br i1 %90, label %B892.if.epil.preheader.i, label %B892.if.preheader.new.i

B892.if.preheader.new.i:                          ; preds = %B892.if.preheader.i
  %unroll_iter97.i = and i64 %.1212, 9223372036854775804
  br label %B892.if.i268

B1188.i320:                                       ; preds = %B972.if.i289, %B942.thread.i
  %top.2.0.lcssa6.i = phi double [ %.15612.i, %B942.thread.i ], [ %.1716.top.2.0.lcssa.i, %B972.if.i289 ]
  %.60.1.i.i = ashr i64 %.1212, 3
  %.174158.not.i.i = icmp slt i64 %.60.1.i.i, 1
  br i1 %.174158.not.i.i, label %B1188.endif.i359, label %B104.if.preheader.i.i

B104.if.preheader.i.i:                            ; preds = %B1188.i320
  %scevgep.i.i321 = getelementptr i8, ptr %arg.room.4, i64 568
  br label %B104.if.i.i322

B348.loopexit.i.i:                                ; preds = %B104.if.i.i322
  %91 = fadd contract double %.244.i.i335, %.279.i.i338
  %92 = fadd contract double %.314.i.i341, %.349.i.i344
  %93 = fadd contract double %91, %92
  %94 = fadd contract double %.384.i.i347, %.419.i.i350
  %95 = fadd contract double %.454.i.i353, %.489.i.i355
  %96 = fadd contract double %94, %95
  %97 = fadd contract double %93, %96
  br label %B1188.endif.i359

B104.if.i.i322:                                   ; preds = %B104.if.i.i322, %B104.if.preheader.i.i
  %lsr.iv9.i.i323 = phi i64 [ %.60.1.i.i, %B104.if.preheader.i.i ], [ %lsr.iv.next.i.i357, %B104.if.i.i322 ]
  %lsr.iv.i.i324 = phi ptr [ %scevgep.i.i321, %B104.if.preheader.i.i ], [ %scevgep1.i.i356, %B104.if.i.i322 ]
  %s7.2.0168.i.i325 = phi double [ 0.000000e+00, %B104.if.preheader.i.i ], [ %.489.i.i355, %B104.if.i.i322 ]
  %s6.2.0167.i.i326 = phi double [ 0.000000e+00, %B104.if.preheader.i.i ], [ %.454.i.i353, %B104.if.i.i322 ]
  %s5.2.0166.i.i327 = phi double [ 0.000000e+00, %B104.if.preheader.i.i ], [ %.419.i.i350, %B104.if.i.i322 ]
  %s4.2.0165.i.i328 = phi double [ 0.000000e+00, %B104.if.preheader.i.i ], [ %.384.i.i347, %B104.if.i.i322 ]
  %s3.2.0164.i.i329 = phi double [ 0.000000e+00, %B104.if.preheader.i.i ], [ %.349.i.i344, %B104.if.i.i322 ]
  %s2.2.0163.i.i330 = phi double [ 0.000000e+00, %B104.if.preheader.i.i ], [ %.314.i.i341, %B104.if.i.i322 ]
  %s1.2.0162.i.i331 = phi double [ 0.000000e+00, %B104.if.preheader.i.i ], [ %.279.i.i338, %B104.if.i.i322 ]
  %s0.2.0161.i.i332 = phi double [ 0.000000e+00, %B104.if.preheader.i.i ], [ %.244.i.i335, %B104.if.i.i322 ]
  %scevgep2.i.i333 = getelementptr i8, ptr %lsr.iv.i.i324, i64 -56
  %.242.i.i334 = load double, ptr %scevgep2.i.i333, align 8, !noalias !66
  %.244.i.i335 = fadd contract double %s0.2.0161.i.i332, %.242.i.i334
  %scevgep3.i.i336 = getelementptr i8, ptr %lsr.iv.i.i324, i64 -48
  %.277.i.i337 = load double, ptr %scevgep3.i.i336, align 8, !noalias !66
  %.279.i.i338 = fadd contract double %s1.2.0162.i.i331, %.277.i.i337
  %scevgep4.i.i339 = getelementptr i8, ptr %lsr.iv.i.i324, i64 -40
  %.312.i.i340 = load double, ptr %scevgep4.i.i339, align 8, !noalias !66
  %.314.i.i341 = fadd contract double %s2.2.0163.i.i330, %.312.i.i340
  %scevgep5.i.i342 = getelementptr i8, ptr %lsr.iv.i.i324, i64 -32
  %.347.i.i343 = load double, ptr %scevgep5.i.i342, align 8, !noalias !66
  %.349.i.i344 = fadd contract double %s3.2.0164.i.i329, %.347.i.i343
  %scevgep6.i.i345 = getelementptr i8, ptr %lsr.iv.i.i324, i64 -24
  %.382.i.i346 = load double, ptr %scevgep6.i.i345, align 8, !noalias !66
  %.384.i.i347 = fadd contract double %s4.2.0165.i.i328, %.382.i.i346
  %scevgep7.i.i348 = getelementptr i8, ptr %lsr.iv.i.i324, i64 -16
  %.417.i.i349 = load double, ptr %scevgep7.i.i348, align 8, !noalias !66
  %.419.i.i350 = fadd contract double %s5.2.0166.i.i327, %.417.i.i349
  %scevgep8.i.i351 = getelementptr i8, ptr %lsr.iv.i.i324, i64 -8
  %.452.i.i352 = load double, ptr %scevgep8.i.i351, align 8, !noalias !66
  %.454.i.i353 = fadd contract double %s6.2.0167.i.i326, %.452.i.i352
  %.487.i.i354 = load double, ptr %lsr.iv.i.i324, align 8, !noalias !66
  %.489.i.i355 = fadd contract double %s7.2.0168.i.i325, %.487.i.i354
  %scevgep1.i.i356 = getelementptr i8, ptr %lsr.iv.i.i324, i64 64
  %lsr.iv.next.i.i357 = add nsw i64 %lsr.iv9.i.i323, -1
  %exitcond.not.i.i358 = icmp eq i64 %lsr.iv.next.i.i357, 0
  br i1 %exitcond.not.i.i358, label %B348.loopexit.i.i, label %B104.if.i.i322

B1252.i:                                          ; preds = %B1188.endif.i359
  br i1 %.13541210.not.i, label %B1324.i393, label %B1256.if.preheader.i

B1256.if.preheader.i:                             ; preds = %B1252.i
  %xtraiter99.i = and i64 %.1212, 3
  %98 = icmp ult i64 %.1212, 4
  br i1 %98, label %B1256.if.epil.preheader.i, label %B1256.if.preheader.new.i

B1256.if.preheader.new.i:                         ; preds = %B1256.if.preheader.i
  %unroll_iter104.i = and i64 %.1212, 9223372036854775804
  br label %B1256.if.i364

B1324.loopexit.unr-lcssa.i:                       ; preds = %B1256.if.i364
  %lcmp.mod101.not.i = icmp eq i64 %xtraiter99.i, 0
  br i1 %lcmp.mod101.not.i, label %B1324.i393, label %B1256.if.epil.preheader.i

B1256.if.epil.preheader.i:                        ; preds = %B1324.loopexit.unr-lcssa.i, %B1256.if.preheader.i
  %squares.2.01236.epil.init.i = phi double [ 0.000000e+00, %B1256.if.preheader.i ], [ %.2395.3.i392, %B1324.loopexit.unr-lcssa.i ]
  %.227012321234.epil.init.i = phi i64 [ 0, %B1256.if.preheader.i ], [ %unroll_iter104.i, %B1324.loopexit.unr-lcssa.i ]
  %99 = shl i64 %.227012321234.epil.init.i, 3
  %100 = getelementptr i8, ptr %arg.room.4, i64 %99
  %scevgep129.i = getelementptr i8, ptr %100, i64 512
  br label %B1256.if.epil.i

B1256.if.epil.i:                                  ; preds = %B1256.if.epil.i, %B1256.if.epil.preheader.i
  %squares.2.01236.epil.i = phi double [ %.2395.epil.i, %B1256.if.epil.i ], [ %squares.2.01236.epil.init.i, %B1256.if.epil.preheader.i ]
  %epil.iter100.i = phi i64 [ %epil.iter100.next.i, %B1256.if.epil.i ], [ 0, %B1256.if.epil.preheader.i ]
  %101 = shl i64 %epil.iter100.i, 3
  %scevgep21.i = getelementptr i8, ptr %scevgep129.i, i64 %101
  %.2331.epil.i = load double, ptr %scevgep21.i, align 8, !noalias !59
  %scevgep20.i = getelementptr i8, ptr %scevgep21.i, i64 -512
  %.2361.epil.i = load double, ptr %scevgep20.i, align 8, !noalias !59
  %.2362.epil.i = fmul contract double %.2331.epil.i, %.2361.epil.i
  %.2393.epil.i = fmul contract double %.2361.epil.i, %.2362.epil.i
  %.2395.epil.i = fadd contract double %squares.2.01236.epil.i, %.2393.epil.i
  %epil.iter100.next.i = add i64 %epil.iter100.i, 1
  %epil.iter100.cmp.not.i = icmp eq i64 %xtraiter99.i, %epil.iter100.next.i
  br i1 %epil.iter100.cmp.not.i, label %B1324.i393, label %B1256.if.epil.i, !llvm.loop !69

B1324.i393:                                       ; preds = %B1256.if.epil.i, %B1324.loopexit.unr-lcssa.i, %B1252.i
  %squares.2.0.lcssa.i = phi double [ 0.000000e+00, %B1252.i ], [ %.2395.3.i392, %B1324.loopexit.unr-lcssa.i ], [ %.2395.epil.i, %B1256.if.epil.i ]
  br i1 %.877.i262, label %B1326.i418, label %B1370.i394

B1326.i418:                                       ; preds = %B1324.i393
  store ptr null, ptr %.2411.i253, align 8, !noalias !59
  call fastcc void @inner_4(ptr nonnull %.2411.i253, ptr nonnull %.894.i263, i64 %.1212, ptr %arg.room.4, ptr nonnull readonly %arg.arguments.4)
  br label %B1370.i394

B1370.i394:                                       ; preds = %B1326.i418, %B1324.i393
  br i1 %.13541210.not.i, label %B3969.i, label %B3953.if.preheader.i

B3953.if.preheader.i:                             ; preds = %B1370.i394
  %xtraiter106.i = and i64 %.1212, 3
  %102 = icmp ult i64 %.1212, 4
  br i1 %102, label %B3953.if.epil.preheader.i, label %B3953.if.preheader.new.i

B3953.if.preheader.new.i:                         ; preds = %B3953.if.preheader.i
  %unroll_iter111.i = and i64 %.1212, 9223372036854775804
  br label %B3953.if.i

B3969.loopexit.unr-lcssa.i:                       ; preds = %B3953.if.i
  %lcmp.mod108.not.i = icmp eq i64 %xtraiter106.i, 0
  br i1 %lcmp.mod108.not.i, label %B3969.i, label %B3953.if.epil.preheader.i

B3953.if.epil.preheader.i:                        ; preds = %B3969.loopexit.unr-lcssa.i, %B3953.if.preheader.i
  %firsts.2.01245.epil.init.i = phi double [ 0.000000e+00, %B3953.if.preheader.i ], [ %.2647.3.i412, %B3969.loopexit.unr-lcssa.i ]
  %.255312411243.epil.init.i = phi i64 [ 0, %B3953.if.preheader.i ], [ %unroll_iter111.i, %B3969.loopexit.unr-lcssa.i ]
  %103 = shl i64 %.255312411243.epil.init.i, 3
  %104 = getelementptr i8, ptr %arg.room.4, i64 %103
  %scevgep.i413 = getelementptr i8, ptr %104, i64 512
  br label %B3953.if.epil.i

B3953.if.epil.i:                                  ; preds = %B3953.if.epil.i, %B3953.if.epil.preheader.i
  %firsts.2.01245.epil.i = phi double [ %.2647.epil.i, %B3953.if.epil.i ], [ %firsts.2.01245.epil.init.i, %B3953.if.epil.preheader.i ]
  %epil.iter107.i = phi i64 [ %epil.iter107.next.i, %B3953.if.epil.i ], [ 0, %B3953.if.epil.preheader.i ]
  %105 = shl i64 %epil.iter107.i, 3
  %scevgep3.i = getelementptr i8, ptr %scevgep.i413, i64 %105
  %.2614.epil.i = load double, ptr %scevgep3.i, align 8, !noalias !59
  %scevgep2.i414 = getelementptr i8, ptr %scevgep3.i, i64 -512
  %.2644.epil.i = load double, ptr %scevgep2.i414, align 8, !noalias !59
  %.2645.epil.i = fmul contract double %.2614.epil.i, %.2644.epil.i
  %.2647.epil.i = fadd contract double %firsts.2.01245.epil.i, %.2645.epil.i
  %epil.iter107.next.i = add i64 %epil.iter107.i, 1
  %epil.iter107.cmp.not.i = icmp eq i64 %xtraiter106.i, %epil.iter107.next.i
  br i1 %epil.iter107.cmp.not.i, label %B3969.i, label %B3953.if.epil.i, !llvm.loop !70

B3969.i:                                          ; preds = %B3953.if.epil.i, %B3969.loopexit.unr-lcssa.i, %B1370.i394
  %firsts.2.0.lcssa.i = phi double [ 0.000000e+00, %B1370.i394 ], [ %.2647.3.i412, %B3969.loopexit.unr-lcssa.i ], [ %.2647.epil.i, %B3953.if.epil.i ]
  %.2674.i416 = fmul contract double %.1298, %firsts.2.0.lcssa.i
  %.2679.i417 = fmul contract double %.1298, %squares.2.0.lcssa.i
  br label %_ZN17bnserve_inference15marginal_kernel9_distance8_by_ruleB4v114B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEdddd28Literal_5bbool_5d_28False_295ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit

B112.if.i509:                                     ; preds = %B112.if.i509, %B112.if.preheader.new.i
  %.31911891191.i = phi i64 [ 0, %B112.if.preheader.new.i ], [ %.326.3.i524, %B112.if.i509 ]
  %sunkaddr91.i510 = shl i64 %.31911891191.i, 3
  %sunkaddr92.i = getelementptr i8, ptr %.1245, i64 %sunkaddr91.i510
  %.380.i511 = load double, ptr %sunkaddr92.i, align 8, !noalias !59
  %.382.i512 = fmul contract double %.1298, %.380.i511
  %.384.i513 = fadd contract double %.1307, %.382.i512
  %sunkaddr94.i514 = getelementptr i8, ptr %arg.room.4, i64 %sunkaddr91.i510
  store double %.384.i513, ptr %sunkaddr94.i514, align 8, !noalias !59
  %sunkaddr97.i515 = getelementptr i8, ptr %sunkaddr92.i, i64 8
  %.380.1.i516 = load double, ptr %sunkaddr97.i515, align 8, !noalias !59
  %.382.1.i517 = fmul contract double %.1298, %.380.1.i516
  %.384.1.i518 = fadd contract double %.1307, %.382.1.i517
  %sunkaddr100.i519 = getelementptr i8, ptr %sunkaddr94.i514, i64 8
  store double %.384.1.i518, ptr %sunkaddr100.i519, align 8, !noalias !59
  %sunkaddr103.i520 = getelementptr i8, ptr %sunkaddr92.i, i64 16
  %.380.2.i521 = load double, ptr %sunkaddr103.i520, align 8, !noalias !59
  %.382.2.i522 = fmul contract double %.1298, %.380.2.i521
  %.384.2.i523 = fadd contract double %.1307, %.382.2.i522
  %sunkaddr106.i = getelementptr i8, ptr %sunkaddr94.i514, i64 16
  store double %.384.2.i523, ptr %sunkaddr106.i, align 8, !noalias !59
  %.326.3.i524 = add nuw nsw i64 %.31911891191.i, 4
  %sunkaddr109.i525 = getelementptr i8, ptr %sunkaddr92.i, i64 24
  %.380.3.i526 = load double, ptr %sunkaddr109.i525, align 8, !noalias !59
  %.382.3.i527 = fmul contract double %.1298, %.380.3.i526
  %.384.3.i528 = fadd contract double %.1307, %.382.3.i527
  %sunkaddr112.i529 = getelementptr i8, ptr %sunkaddr94.i514, i64 24
  store double %.384.3.i528, ptr %sunkaddr112.i529, align 8, !noalias !59
  %niter.ncmp.3.i530 = icmp eq i64 %unroll_iter.i, %.326.3.i524
  br i1 %niter.ncmp.3.i530, label %B182.if.preheader.unr-lcssa.i, label %B112.if.i509

B182.if.preheader.unr-lcssa.i:                    ; preds = %B112.if.i509
  %lcmp.mod.not.i = icmp eq i64 %xtraiter.i, 0
  br i1 %lcmp.mod.not.i, label %B182.if.i532.preheader, label %B112.if.epil.preheader.i

B112.if.epil.preheader.i:                         ; preds = %B182.if.preheader.unr-lcssa.i, %B112.if.preheader.i
  %.31911891191.epil.init.i = phi i64 [ 0, %B112.if.preheader.i ], [ %.326.3.i524, %B182.if.preheader.unr-lcssa.i ]
  %106 = shl i64 %.31911891191.epil.init.i, 3
  %scevgep188.i = getelementptr i8, ptr %arg.room.4, i64 %106
  %scevgep190.i = getelementptr i8, ptr %.1245, i64 %106
  br label %B112.if.epil.i

B112.if.epil.i:                                   ; preds = %B112.if.epil.i, %B112.if.epil.preheader.i
  %epil.iter.i = phi i64 [ %epil.iter.next.i, %B112.if.epil.i ], [ 0, %B112.if.epil.preheader.i ]
  %107 = shl i64 %epil.iter.i, 3
  %scevgep72.i = getelementptr i8, ptr %scevgep190.i, i64 %107
  %.380.epil.i = load double, ptr %scevgep72.i, align 8, !noalias !59
  %.382.epil.i = fmul contract double %.1298, %.380.epil.i
  %.384.epil.i = fadd contract double %.1307, %.382.epil.i
  %scevgep71.i = getelementptr i8, ptr %scevgep188.i, i64 %107
  store double %.384.epil.i, ptr %scevgep71.i, align 8, !noalias !59
  %epil.iter.next.i = add i64 %epil.iter.i, 1
  %epil.iter.cmp.not.i = icmp eq i64 %xtraiter.i, %epil.iter.next.i
  br i1 %epil.iter.cmp.not.i, label %B182.if.i532.preheader, label %B112.if.epil.i, !llvm.loop !71

B182.if.i532.preheader:                           ; preds = %B112.if.epil.i, %B182.if.preheader.unr-lcssa.i
  br label %B182.if.i532

B182.if.i532:                                     ; preds = %B182.if.i532.preheader, %B182.if.i532
  %.50611951197.i = phi i64 [ %.513.i533, %B182.if.i532 ], [ 0, %B182.if.i532.preheader ]
  %.513.i533 = add nuw nsw i64 %.50611951197.i, 1
  %.567.i534 = load double, ptr %arg.prior.4, align 8, !noalias !59
  %108 = shl i64 %.50611951197.i, 3
  %scevgep186.i = getelementptr i8, ptr %.164.i255, i64 %108
  %scevgep187.i = getelementptr i8, ptr %scevgep186.i, i64 -512
  %.5981180.i = load i64, ptr %scevgep187.i, align 8, !noalias !59
  %.600.i535 = add nsw i64 %.5981180.i, -4604544271217802189
  %.601.i536 = ashr i64 %.600.i535, 52
  %.602.i537 = and i64 %.600.i535, -4503599627370496
  %.603.i538 = sub nsw i64 %.5981180.i, %.602.i537
  %.604.i539 = bitcast i64 %.603.i538 to double
  %.605.i540 = fadd contract double %.604.i539, -1.000000e+00
  %.606.i541 = fadd contract double %.605.i540, 2.000000e+00
  %.610.i542 = fdiv contract double %.605.i540, %.606.i541
  %.611.i543 = fmul contract double %.610.i542, %.610.i542
  %.612.i544 = fmul contract double %.611.i543, %.611.i543
  %.613.i545 = fmul contract double %.612.i544, 0x3FC39A09D078C69F
  %.614.i546 = fadd contract double %.613.i545, 0x3FCC71C51D8E78AF
  %.615.i547 = fmul contract double %.612.i544, %.614.i546
  %.616.i548 = fadd contract double %.615.i547, 0x3FD999999997FA04
  %.617.i549 = fmul contract double %.612.i544, %.616.i548
  %.618.i550 = fmul contract double %.612.i544, 0x3FC2F112DF3E5244
  %.619.i551 = fadd contract double %.618.i550, 0x3FC7466496CB03DE
  %.620.i552 = fmul contract double %.612.i544, %.619.i551
  %.621.i553 = fadd contract double %.620.i552, 0x3FD2492494229359
  %.622.i554 = fmul contract double %.612.i544, %.621.i553
  %.623.i555 = fadd contract double %.622.i554, 0x3FE5555555555593
  %.624.i556 = fmul contract double %.611.i543, %.623.i555
  %.625.i557 = fadd contract double %.617.i549, %.624.i556
  %.626.i558 = fmul contract double %.605.i540, 5.000000e-01
  %.627.i559 = fmul contract double %.605.i540, %.626.i558
  %.628.i560 = add nsw i64 %.601.i536, 4843621399236968448
  %.629.i561 = bitcast i64 %.628.i560 to double
  %.630.i562 = fadd contract double %.629.i561, 0xC338000000000000
  %.631.i563 = fmul contract double %.630.i562, 0x3FE62E42FEE00000
  %.632.i564 = fadd contract double %.627.i559, %.625.i557
  %.633.i565 = fmul contract double %.610.i542, %.632.i564
  %.634.i566 = fmul contract double %.630.i562, 0x3DEA39EF35793C76
  %.635.i567 = fadd contract double %.634.i566, %.633.i565
  %.636.i568 = fsub contract double %.627.i559, %.635.i567
  %.637.i569 = fsub contract double %.636.i568, %.605.i540
  %.638.i570 = fsub contract double %.631.i563, %.637.i569
  %.639.i571 = fmul contract double %.567.i534, %.638.i570
  store double %.639.i571, ptr %scevgep186.i, align 8, !noalias !59
  %exitcond1249.not.i = icmp eq i64 %.1212, %.513.i533
  br i1 %exitcond1249.not.i, label %B274.i256, label %B182.if.i532

B134.if.lr.ph.i.i:                                ; preds = %B322.i440
  %.741.i446 = getelementptr i8, ptr %arg.arguments.4, i64 72
  %.742.i447 = load i64, ptr %.741.i446, align 8, !noalias !59
  %.355.i.i448 = add nsw i64 %.704.i258, -1
  %109 = inttoptr i64 %.742.i447 to ptr
  br label %B134.if.i.i449

B134.if.i.i449:                                   ; preds = %B134.if.i.i449, %B134.if.lr.ph.i.i
  %.230207209.i.i450 = phi i64 [ 0, %B134.if.lr.ph.i.i ], [ %.237.i.i451, %B134.if.i.i449 ]
  %.237.i.i451 = add nuw nsw i64 %.230207209.i.i450, 1
  %110 = shl i64 %.230207209.i.i450, 3
  %scevgep183.i = getelementptr i8, ptr %.164.i255, i64 %110
  %scevgep184.i = getelementptr i8, ptr %scevgep183.i, i64 -512
  %.296205.i.i452 = load i64, ptr %scevgep184.i, align 8, !noalias !62
  %.298.i.i453 = add nsw i64 %.296205.i.i452, -4604544271217802189
  %.299.i.i454 = ashr i64 %.298.i.i453, 52
  %.300.i.i455 = and i64 %.298.i.i453, -4503599627370496
  %.301.i.i456 = sub nsw i64 %.296205.i.i452, %.300.i.i455
  %.302.i.i457 = bitcast i64 %.301.i.i456 to double
  %.303.i.i458 = fadd contract double %.302.i.i457, -1.000000e+00
  %.304.i.i459 = fadd contract double %.303.i.i458, 2.000000e+00
  %.308.i.i460 = fdiv contract double %.303.i.i458, %.304.i.i459
  %.309.i.i461 = fmul contract double %.308.i.i460, %.308.i.i460
  %.310.i.i462 = fmul contract double %.309.i.i461, %.309.i.i461
  %.311.i.i463 = fmul contract double %.310.i.i462, 0x3FC39A09D078C69F
  %.312.i28.i = fadd contract double %.311.i.i463, 0x3FCC71C51D8E78AF
  %.313.i.i464 = fmul contract double %.310.i.i462, %.312.i28.i
  %.314.i29.i = fadd contract double %.313.i.i464, 0x3FD999999997FA04
  %.315.i.i465 = fmul contract double %.310.i.i462, %.314.i29.i
  %.316.i.i466 = fmul contract double %.310.i.i462, 0x3FC2F112DF3E5244
  %.317.i.i467 = fadd contract double %.316.i.i466, 0x3FC7466496CB03DE
  %.318.i.i468 = fmul contract double %.310.i.i462, %.317.i.i467
  %.319.i.i469 = fadd contract double %.318.i.i468, 0x3FD2492494229359
  %.320.i.i470 = fmul contract double %.310.i.i462, %.319.i.i469
  %.321.i.i471 = fadd contract double %.320.i.i470, 0x3FE5555555555593
  %.322.i.i472 = fmul contract double %.309.i.i461, %.321.i.i471
  %.323.i.i473 = fadd contract double %.315.i.i465, %.322.i.i472
  %.324.i.i474 = fmul contract double %.303.i.i458, 5.000000e-01
  %.325.i.i475 = fmul contract double %.303.i.i458, %.324.i.i474
  %.326.i.i476 = add nsw i64 %.299.i.i454, 4843621399236968448
  %.327.i.i477 = bitcast i64 %.326.i.i476 to double
  %.328.i.i478 = fadd contract double %.327.i.i477, 0xC338000000000000
  %.329.i.i479 = fmul contract double %.328.i.i478, 0x3FE62E42FEE00000
  %.330.i.i480 = fadd contract double %.325.i.i475, %.323.i.i473
  %.331.i.i481 = fmul contract double %.308.i.i460, %.330.i.i480
  %.332.i.i482 = fmul contract double %.328.i.i478, 0x3DEA39EF35793C76
  %.333.i.i483 = fadd contract double %.332.i.i482, %.331.i.i481
  %.334.i.i484 = fsub contract double %.325.i.i475, %.333.i.i483
  %.335.i.i485 = fsub contract double %.334.i.i484, %.303.i.i458
  %.336.i.i486 = fsub contract double %.329.i.i479, %.335.i.i485
  %.337.i.i487 = fneg contract double %.336.i.i486
  %.339.i.i488 = fsub contract double %.337.i.i487, %.89.i.i442
  %.341.i.i489 = fmul contract double %.125.i.i445, %.339.i.i488
  %.348.i.i490 = fadd contract double %.341.i.i489, -5.000000e-01
  %.349.i30.i = fadd contract double %.348.i.i490, 0x4338000000000000
  %.350.i.i491 = bitcast double %.349.i30.i to i64
  %111 = tail call i64 @llvm.smax.i64(i64 %.350.i.i491, i64 4843621399236968448)
  %nearest_cell_v103__vphi100_0.2.1.i.i492 = add nsw i64 %111, -4843621399236968448
  %nearest_cell_v103__vphi120_0.2.1.i.i493 = tail call i64 @llvm.smin.i64(i64 %nearest_cell_v103__vphi100_0.2.1.i.i492, i64 %.355.i.i448)
  %.405.i.i494 = uitofp nneg i64 %nearest_cell_v103__vphi120_0.2.1.i.i493 to double
  %.406.i.i495 = fsub contract double %.341.i.i489, %.405.i.i494
  %.440.i.i496 = load double, ptr %scevgep183.i, align 8, !noalias !62
  %.idx.i.i497 = mul i64 %nearest_cell_v103__vphi120_0.2.1.i.i493, 48
  %112 = getelementptr i8, ptr %109, i64 %.idx.i.i497
  %.470.i.i498 = load double, ptr %112, align 8, !noalias !62
  %113 = getelementptr i8, ptr %112, i64 8
  %.501.i.i499 = load double, ptr %113, align 8, !noalias !62
  %114 = getelementptr i8, ptr %112, i64 16
  %.532.i.i500 = load double, ptr %114, align 8, !noalias !62
  %115 = getelementptr i8, ptr %112, i64 24
  %.563.i.i501 = load double, ptr %115, align 8, !noalias !62
  %.564.i.i502 = fmul contract double %.563.i.i501, %.406.i.i495
  %.565.i.i503 = fadd contract double %.532.i.i500, %.564.i.i502
  %.566.i.i504 = fmul contract double %.406.i.i495, %.565.i.i503
  %.567.i.i505 = fadd contract double %.501.i.i499, %.566.i.i504
  %.568.i.i506 = fmul contract double %.406.i.i495, %.567.i.i505
  %.569.i.i507 = fadd contract double %.470.i.i498, %.568.i.i506
  %.570.i.i508 = fadd contract double %.440.i.i496, %.569.i.i507
  store double %.570.i.i508, ptr %scevgep183.i, align 8, !noalias !62
  %exitcond.not.i33.i = icmp eq i64 %.1212, %.237.i.i451
  br i1 %exitcond.not.i33.i, label %B436.i260, label %B134.if.i.i449

B584.if.i422:                                     ; preds = %B584.if.i422, %B584.if.preheader.new.i
  %.103912021204.i = phi i64 [ 0, %B584.if.preheader.new.i ], [ %.1046.3.i434, %B584.if.i422 ]
  %sunkaddr114.i = shl i64 %.103912021204.i, 3
  %sunkaddr115.i423 = getelementptr i8, ptr %arg.room.4, i64 %sunkaddr114.i
  %.1100.i424 = load double, ptr %sunkaddr115.i423, align 8, !noalias !59
  %.1102.i425 = fmul contract double %arg.x, %.1100.i424
  %sunkaddr118.i426 = getelementptr i8, ptr %sunkaddr115.i423, i64 1024
  store double %.1102.i425, ptr %sunkaddr118.i426, align 8, !noalias !59
  %sunkaddr121.i427 = getelementptr i8, ptr %sunkaddr115.i423, i64 8
  %.1100.1.i428 = load double, ptr %sunkaddr121.i427, align 8, !noalias !59
  %.1102.1.i429 = fmul contract double %arg.x, %.1100.1.i428
  %sunkaddr124.i430 = getelementptr i8, ptr %sunkaddr115.i423, i64 1032
  store double %.1102.1.i429, ptr %sunkaddr124.i430, align 8, !noalias !59
  %sunkaddr127.i431 = getelementptr i8, ptr %sunkaddr115.i423, i64 16
  %.1100.2.i432 = load double, ptr %sunkaddr127.i431, align 8, !noalias !59
  %.1102.2.i433 = fmul contract double %arg.x, %.1100.2.i432
  %sunkaddr130.i = getelementptr i8, ptr %sunkaddr115.i423, i64 1040
  store double %.1102.2.i433, ptr %sunkaddr130.i, align 8, !noalias !59
  %.1046.3.i434 = add nuw nsw i64 %.103912021204.i, 4
  %sunkaddr133.i = getelementptr i8, ptr %sunkaddr115.i423, i64 24
  %.1100.3.i435 = load double, ptr %sunkaddr133.i, align 8, !noalias !59
  %.1102.3.i436 = fmul contract double %arg.x, %.1100.3.i435
  %sunkaddr136.i = getelementptr i8, ptr %sunkaddr115.i423, i64 1048
  store double %.1102.3.i436, ptr %sunkaddr136.i, align 8, !noalias !59
  %niter85.ncmp.3.i = icmp eq i64 %unroll_iter84.i, %.1046.3.i434
  br i1 %niter85.ncmp.3.i, label %B618.loopexit.unr-lcssa.i, label %B584.if.i422

B760.if.i:                                        ; preds = %B760.if.i, %B760.if.lr.ph.new.i
  %.136012091211.i = phi i64 [ 0, %B760.if.lr.ph.new.i ], [ %.1367.1.i, %B760.if.i ]
  %sunkaddr137.i265 = shl i64 %.136012091211.i, 3
  %sunkaddr139.i = getelementptr i8, ptr %arg.room.4, i64 %sunkaddr137.i265
  %sunkaddr140.i266 = getelementptr i8, ptr %sunkaddr139.i, i64 512
  %.1423.i = load double, ptr %sunkaddr140.i266, align 8, !noalias !59
  %.1453.i = load double, ptr %sunkaddr139.i, align 8, !noalias !59
  %.1486.i = fmul contract double %.1455.i, %.1453.i
  %.1488.i = fsub contract double %arg.x, %.1486.i
  %.1489.i = fmul contract double %.1453.i, %.1488.i
  %.1490.i = fadd contract double %.1423.i, %.1489.i
  store double %.1490.i, ptr %sunkaddr140.i266, align 8, !noalias !59
  %.1367.1.i = add nuw i64 %.136012091211.i, 2
  %sunkaddr145.i = getelementptr i8, ptr %sunkaddr139.i, i64 520
  %.1423.1.i = load double, ptr %sunkaddr145.i, align 8, !noalias !59
  %sunkaddr148.i = getelementptr i8, ptr %sunkaddr139.i, i64 8
  %.1453.1.i = load double, ptr %sunkaddr148.i, align 8, !noalias !59
  %.1486.1.i = fmul contract double %.1455.i, %.1453.1.i
  %.1488.1.i = fsub contract double %arg.x, %.1486.1.i
  %.1489.1.i = fmul contract double %.1453.1.i, %.1488.1.i
  %.1490.1.i = fadd contract double %.1423.1.i, %.1489.1.i
  store double %.1490.1.i, ptr %sunkaddr145.i, align 8, !noalias !59
  %niter91.ncmp.1.i = icmp eq i64 %unroll_iter90.i, %.1367.1.i
  br i1 %niter91.ncmp.1.i, label %B892.if.preheader.unr-lcssa.i, label %B760.if.i

B892.if.i268:                                     ; preds = %B892.if.i268, %B892.if.preheader.new.i
  %top.2.01220.i = phi double [ %.1561.i267, %B892.if.preheader.new.i ], [ %.1716.top.2.0.3.i286, %B892.if.i268 ]
  %.165112161218.i = phi i64 [ 0, %B892.if.preheader.new.i ], [ %.1658.3.i282, %B892.if.i268 ]
  %sunkaddr149.i269 = shl i64 %.165112161218.i, 3
  %sunkaddr151.i = getelementptr i8, ptr %arg.room.4, i64 %sunkaddr149.i269
  %sunkaddr152.i270 = getelementptr i8, ptr %sunkaddr151.i, i64 512
  %.1716.i271 = load double, ptr %sunkaddr152.i270, align 8, !noalias !59
  %.1718.i272 = fcmp contract ogt double %.1716.i271, %top.2.01220.i
  %.1716.top.2.0.i273 = select i1 %.1718.i272, double %.1716.i271, double %top.2.01220.i
  %sunkaddr155.i274 = getelementptr i8, ptr %sunkaddr151.i, i64 520
  %.1716.1.i275 = load double, ptr %sunkaddr155.i274, align 8, !noalias !59
  %.1718.1.i276 = fcmp contract ogt double %.1716.1.i275, %.1716.top.2.0.i273
  %.1716.top.2.0.1.i277 = select i1 %.1718.1.i276, double %.1716.1.i275, double %.1716.top.2.0.i273
  %sunkaddr158.i278 = getelementptr i8, ptr %sunkaddr151.i, i64 528
  %.1716.2.i279 = load double, ptr %sunkaddr158.i278, align 8, !noalias !59
  %.1718.2.i280 = fcmp contract ogt double %.1716.2.i279, %.1716.top.2.0.1.i277
  %.1716.top.2.0.2.i281 = select i1 %.1718.2.i280, double %.1716.2.i279, double %.1716.top.2.0.1.i277
  %.1658.3.i282 = add nuw i64 %.165112161218.i, 4
  %sunkaddr161.i283 = getelementptr i8, ptr %sunkaddr151.i, i64 536
  %.1716.3.i284 = load double, ptr %sunkaddr161.i283, align 8, !noalias !59
  %.1718.3.i285 = fcmp contract ogt double %.1716.3.i284, %.1716.top.2.0.2.i281
  %.1716.top.2.0.3.i286 = select i1 %.1718.3.i285, double %.1716.3.i284, double %.1716.top.2.0.2.i281
  %niter98.ncmp.3.i = icmp eq i64 %unroll_iter97.i, %.1658.3.i282
  br i1 %niter98.ncmp.3.i, label %B972.if.preheader.unr-lcssa.i, label %B892.if.i268

B972.if.preheader.unr-lcssa.i:                    ; preds = %B892.if.i268
  %lcmp.mod94.not.i = icmp eq i64 %xtraiter92.i, 0
  br i1 %lcmp.mod94.not.i, label %B972.if.preheader.i287, label %B892.if.epil.preheader.i

B892.if.epil.preheader.i:                         ; preds = %B972.if.preheader.unr-lcssa.i, %B892.if.preheader.i
  %top.2.01220.epil.init.i = phi double [ %.1561.i267, %B892.if.preheader.i ], [ %.1716.top.2.0.3.i286, %B972.if.preheader.unr-lcssa.i ]
  %.165112161218.epil.init.i = phi i64 [ 0, %B892.if.preheader.i ], [ %unroll_iter97.i, %B972.if.preheader.unr-lcssa.i ]
  %116 = shl i64 %.165112161218.epil.init.i, 3
  %117 = getelementptr i8, ptr %arg.room.4, i64 %116
  %scevgep148.i = getelementptr i8, ptr %117, i64 512
  br label %B892.if.epil.i

B892.if.epil.i:                                   ; preds = %B892.if.epil.i, %B892.if.epil.preheader.i
  %top.2.01220.epil.i = phi double [ %.1716.top.2.0.epil.i, %B892.if.epil.i ], [ %top.2.01220.epil.init.i, %B892.if.epil.preheader.i ]
  %epil.iter93.i = phi i64 [ %epil.iter93.next.i, %B892.if.epil.i ], [ 0, %B892.if.epil.preheader.i ]
  %118 = shl i64 %epil.iter93.i, 3
  %scevgep37.i = getelementptr i8, ptr %scevgep148.i, i64 %118
  %.1716.epil.i = load double, ptr %scevgep37.i, align 8, !noalias !59
  %.1718.epil.i = fcmp contract ogt double %.1716.epil.i, %top.2.01220.epil.i
  %.1716.top.2.0.epil.i = select i1 %.1718.epil.i, double %.1716.epil.i, double %top.2.01220.epil.i
  %epil.iter93.next.i = add i64 %epil.iter93.i, 1
  %epil.iter93.cmp.not.i = icmp eq i64 %xtraiter92.i, %epil.iter93.next.i
  br i1 %epil.iter93.cmp.not.i, label %B972.if.preheader.i287, label %B892.if.epil.i, !llvm.loop !72

B972.if.preheader.i287:                           ; preds = %B892.if.epil.i, %B972.if.preheader.unr-lcssa.i
  %.1716.top.2.0.lcssa.i = phi double [ %.1716.top.2.0.3.i286, %B972.if.preheader.unr-lcssa.i ], [ %.1716.top.2.0.epil.i, %B892.if.epil.i ]
  %invariant.gep.i288 = getelementptr double, ptr %.1245, i64 %.1212
  br label %B972.if.i289

B972.if.i289:                                     ; preds = %B972.if.i289, %B972.if.preheader.i287
  %.186312251227.i = phi i64 [ %.1870.i290, %B972.if.i289 ], [ 0, %B972.if.preheader.i287 ]
  %.1870.i290 = add nuw nsw i64 %.186312251227.i, 1
  %119 = shl i64 %.186312251227.i, 3
  %scevgep146.i = getelementptr i8, ptr %invariant.gep.i288, i64 %119
  %.1930.i291 = load double, ptr %scevgep146.i, align 8, !noalias !59
  %scevgep147.i = getelementptr i8, ptr %.164.i255, i64 %119
  %.1965.i292 = load double, ptr %scevgep147.i, align 8, !noalias !59
  %.1967.i293 = fsub contract double %.1965.i292, %.1716.top.2.0.lcssa.i
  %.1973.i294 = fcmp contract ogt double %.1967.i293, -7.000000e+02
  %.1967..i295 = select i1 %.1973.i294, double %.1967.i293, double -7.000000e+02
  %.1990.i296 = tail call contract double @llvm.fma.f64(double %.1967..i295, double 0x3FF71547652B82FE, double 0x4338000000000000)
  %.1991.i297 = fadd contract double %.1990.i296, 0xC338000000000000
  %.1994.i298 = tail call contract double @llvm.fma.f64(double %.1991.i297, double 0xBFE62E42FEFA39EF, double %.1967..i295)
  %.1995.i299 = tail call contract double @llvm.fma.f64(double %.1991.i297, double 0xBC7ABC9E3B39803F, double %.1994.i298)
  %.1996.i300 = tail call contract double @llvm.fma.f64(double %.1995.i299, double 0x3DE6124613A86D09, double 0x3E21EED8EFF8D898)
  %.1997.i301 = tail call contract double @llvm.fma.f64(double %.1995.i299, double %.1996.i300, double 0x3E5AE64567F544E4)
  %.1998.i302 = tail call contract double @llvm.fma.f64(double %.1995.i299, double %.1997.i301, double 0x3E927E4FB7789F5C)
  %.1999.i303 = tail call contract double @llvm.fma.f64(double %.1995.i299, double %.1998.i302, double 0x3EC71DE3A556C734)
  %.2000.i304 = tail call contract double @llvm.fma.f64(double %.1995.i299, double %.1999.i303, double 0x3EFA01A01A01A01A)
  %.2001.i305 = tail call contract double @llvm.fma.f64(double %.1995.i299, double %.2000.i304, double 0x3F2A01A01A01A01A)
  %.2002.i306 = tail call contract double @llvm.fma.f64(double %.1995.i299, double %.2001.i305, double 0x3F56C16C16C16C17)
  %.2003.i307 = tail call contract double @llvm.fma.f64(double %.1995.i299, double %.2002.i306, double 0x3F81111111111111)
  %.2004.i308 = tail call contract double @llvm.fma.f64(double %.1995.i299, double %.2003.i307, double 0x3FA5555555555555)
  %.2005.i309 = tail call contract double @llvm.fma.f64(double %.1995.i299, double %.2004.i308, double 0x3FC5555555555555)
  %.2006.i310 = tail call contract double @llvm.fma.f64(double %.1995.i299, double %.2005.i309, double 5.000000e-01)
  %.2007.i311 = fmul contract double %.1995.i299, %.1995.i299
  %.2008.i312 = fadd contract double %.1995.i299, 1.000000e+00
  %.2009.i313 = tail call contract double @llvm.fma.f64(double %.2007.i311, double %.2006.i310, double %.2008.i312)
  %.2010.i314 = bitcast double %.1990.i296 to i64
  %.2011.i315 = shl i64 %.2010.i314, 52
  %.2012.i316 = add i64 %.2011.i315, 4607182418800017408
  %.2013.i317 = bitcast i64 %.2012.i316 to double
  %.2014.i318 = fmul contract double %.2009.i313, %.2013.i317
  %.2016.i319 = fmul contract double %.1930.i291, %.2014.i318
  store double %.2016.i319, ptr %scevgep147.i, align 8, !noalias !59
  %exitcond1253.not.i = icmp eq i64 %.1212, %.1870.i290
  br i1 %exitcond1253.not.i, label %B1188.i320, label %B972.if.i289

B1188.endif.i359:                                 ; preds = %B348.loopexit.i.i, %B1188.i320
  %s0.2.0.lcssa.i.i = phi double [ 0.000000e+00, %B1188.i320 ], [ %97, %B348.loopexit.i.i ]
  %.2091.i360 = fmul contract double %.1298, %s0.2.0.lcssa.i.i
  %.2123.i361 = getelementptr i8, ptr %arg.arguments.4, i64 184
  %.2124.i362 = load i64, ptr %.2123.i361, align 8, !noalias !59
  %.2125.i363 = icmp eq i64 %.2124.i362, 0
  br i1 %.2125.i363, label %_ZN17bnserve_inference15marginal_kernel9_distance8_by_ruleB4v114B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEdddd28Literal_5bbool_5d_28False_295ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit, label %B1252.i

B1256.if.i364:                                    ; preds = %B1256.if.i364, %B1256.if.preheader.new.i
  %squares.2.01236.i = phi double [ 0.000000e+00, %B1256.if.preheader.new.i ], [ %.2395.3.i392, %B1256.if.i364 ]
  %.227012321234.i = phi i64 [ 0, %B1256.if.preheader.new.i ], [ %.2277.3.i385, %B1256.if.i364 ]
  %sunkaddr162.i = shl i64 %.227012321234.i, 3
  %sunkaddr164.i365 = getelementptr i8, ptr %arg.room.4, i64 %sunkaddr162.i
  %sunkaddr165.i366 = getelementptr i8, ptr %sunkaddr164.i365, i64 512
  %.2331.i367 = load double, ptr %sunkaddr165.i366, align 8, !noalias !59
  %.2361.i368 = load double, ptr %sunkaddr164.i365, align 8, !noalias !59
  %.2362.i369 = fmul contract double %.2331.i367, %.2361.i368
  %.2393.i370 = fmul contract double %.2361.i368, %.2362.i369
  %.2395.i371 = fadd contract double %squares.2.01236.i, %.2393.i370
  %sunkaddr170.i = getelementptr i8, ptr %sunkaddr164.i365, i64 520
  %.2331.1.i372 = load double, ptr %sunkaddr170.i, align 8, !noalias !59
  %sunkaddr173.i373 = getelementptr i8, ptr %sunkaddr164.i365, i64 8
  %.2361.1.i374 = load double, ptr %sunkaddr173.i373, align 8, !noalias !59
  %.2362.1.i375 = fmul contract double %.2331.1.i372, %.2361.1.i374
  %.2393.1.i376 = fmul contract double %.2361.1.i374, %.2362.1.i375
  %.2395.1.i377 = fadd contract double %.2395.i371, %.2393.1.i376
  %sunkaddr176.i378 = getelementptr i8, ptr %sunkaddr164.i365, i64 528
  %.2331.2.i379 = load double, ptr %sunkaddr176.i378, align 8, !noalias !59
  %sunkaddr179.i380 = getelementptr i8, ptr %sunkaddr164.i365, i64 16
  %.2361.2.i381 = load double, ptr %sunkaddr179.i380, align 8, !noalias !59
  %.2362.2.i382 = fmul contract double %.2331.2.i379, %.2361.2.i381
  %.2393.2.i383 = fmul contract double %.2361.2.i381, %.2362.2.i382
  %.2395.2.i384 = fadd contract double %.2395.1.i377, %.2393.2.i383
  %.2277.3.i385 = add nuw nsw i64 %.227012321234.i, 4
  %sunkaddr182.i386 = getelementptr i8, ptr %sunkaddr164.i365, i64 536
  %.2331.3.i387 = load double, ptr %sunkaddr182.i386, align 8, !noalias !59
  %sunkaddr185.i388 = getelementptr i8, ptr %sunkaddr164.i365, i64 24
  %.2361.3.i389 = load double, ptr %sunkaddr185.i388, align 8, !noalias !59
  %.2362.3.i390 = fmul contract double %.2331.3.i387, %.2361.3.i389
  %.2393.3.i391 = fmul contract double %.2361.3.i389, %.2362.3.i390
  %.2395.3.i392 = fadd contract double %.2395.2.i384, %.2393.3.i391
  %niter105.ncmp.3.i = icmp eq i64 %unroll_iter104.i, %.2277.3.i385
  br i1 %niter105.ncmp.3.i, label %B1324.loopexit.unr-lcssa.i, label %B1256.if.i364

B3953.if.i:                                       ; preds = %B3953.if.i, %B3953.if.preheader.new.i
  %firsts.2.01245.i = phi double [ 0.000000e+00, %B3953.if.preheader.new.i ], [ %.2647.3.i412, %B3953.if.i ]
  %.255312411243.i = phi i64 [ 0, %B3953.if.preheader.new.i ], [ %.2560.3.i408, %B3953.if.i ]
  %sunkaddr186.i = shl i64 %.255312411243.i, 3
  %sunkaddr188.i395 = getelementptr i8, ptr %arg.room.4, i64 %sunkaddr186.i
  %sunkaddr189.i = getelementptr i8, ptr %sunkaddr188.i395, i64 512
  %.2614.i396 = load double, ptr %sunkaddr189.i, align 8, !noalias !59
  %.2644.i397 = load double, ptr %sunkaddr188.i395, align 8, !noalias !59
  %.2645.i398 = fmul contract double %.2614.i396, %.2644.i397
  %.2647.i399 = fadd contract double %firsts.2.01245.i, %.2645.i398
  %sunkaddr194.i = getelementptr i8, ptr %sunkaddr188.i395, i64 520
  %.2614.1.i400 = load double, ptr %sunkaddr194.i, align 8, !noalias !59
  %sunkaddr197.i = getelementptr i8, ptr %sunkaddr188.i395, i64 8
  %.2644.1.i401 = load double, ptr %sunkaddr197.i, align 8, !noalias !59
  %.2645.1.i402 = fmul contract double %.2614.1.i400, %.2644.1.i401
  %.2647.1.i403 = fadd contract double %.2647.i399, %.2645.1.i402
  %sunkaddr200.i = getelementptr i8, ptr %sunkaddr188.i395, i64 528
  %.2614.2.i404 = load double, ptr %sunkaddr200.i, align 8, !noalias !59
  %sunkaddr203.i = getelementptr i8, ptr %sunkaddr188.i395, i64 16
  %.2644.2.i405 = load double, ptr %sunkaddr203.i, align 8, !noalias !59
  %.2645.2.i406 = fmul contract double %.2614.2.i404, %.2644.2.i405
  %.2647.2.i407 = fadd contract double %.2647.1.i403, %.2645.2.i406
  %.2560.3.i408 = add nuw nsw i64 %.255312411243.i, 4
  %sunkaddr206.i = getelementptr i8, ptr %sunkaddr188.i395, i64 536
  %.2614.3.i409 = load double, ptr %sunkaddr206.i, align 8, !noalias !59
  %sunkaddr209.i = getelementptr i8, ptr %sunkaddr188.i395, i64 24
  %.2644.3.i410 = load double, ptr %sunkaddr209.i, align 8, !noalias !59
  %.2645.3.i411 = fmul contract double %.2614.3.i409, %.2644.3.i410
  %.2647.3.i412 = fadd contract double %.2647.2.i407, %.2645.3.i411
  %niter112.ncmp.3.i = icmp eq i64 %unroll_iter111.i, %.2560.3.i408
  br i1 %niter112.ncmp.3.i, label %B3969.loopexit.unr-lcssa.i, label %B3953.if.i

_ZN17bnserve_inference15marginal_kernel9_distance8_by_ruleB4v114B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEdddd28Literal_5bbool_5d_28False_295ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit: ; preds = %B1188.endif.i359, %B3969.i
  %.1315.sroa.8.0 = phi double [ %.2674.i416, %B3969.i ], [ 0.000000e+00, %B1188.endif.i359 ]
  %.1315.sroa.11.0 = phi double [ %.2679.i417, %B3969.i ], [ 0.000000e+00, %B1188.endif.i359 ]
  %.1315.sroa.0.0 = fadd contract double %top.2.0.lcssa6.i, 0.000000e+00
  call void @llvm.lifetime.end.p0(ptr nonnull %.1212.i251)
  call void @llvm.lifetime.end.p0(ptr nonnull %.2411.i253)
  br label %common.ret

B1536:                                            ; preds = %B1408
  %.1409 = getelementptr i8, ptr %arg.arguments.4, i64 112
  %.1410 = load i64, ptr %.1409, align 8
  %.1472 = fdiv contract double %.13.i22, %.13.i20
  %.1473 = bitcast double %.1472 to i64
  %.1474 = add nsw i64 %.1473, -4604544271217802189
  %.1475 = ashr i64 %.1474, 52
  %.1476 = and i64 %.1474, -4503599627370496
  %.1477 = sub nsw i64 %.1473, %.1476
  %.1478 = bitcast i64 %.1477 to double
  %.1479 = fadd contract double %.1478, -1.000000e+00
  %.1480 = fadd contract double %.1479, 2.000000e+00
  %.1484 = fdiv contract double %.1479, %.1480
  %.1485 = fmul contract double %.1484, %.1484
  %.1486 = fmul contract double %.1485, %.1485
  %.1487 = fmul contract double %.1486, 0x3FC39A09D078C69F
  %.1488 = fadd contract double %.1487, 0x3FCC71C51D8E78AF
  %.1489 = fmul contract double %.1486, %.1488
  %.1490 = fadd contract double %.1489, 0x3FD999999997FA04
  %.1491 = fmul contract double %.1486, %.1490
  %.1492 = fmul contract double %.1486, 0x3FC2F112DF3E5244
  %.1493 = fadd contract double %.1492, 0x3FC7466496CB03DE
  %.1494 = fmul contract double %.1486, %.1493
  %.1495 = fadd contract double %.1494, 0x3FD2492494229359
  %.1496 = fmul contract double %.1486, %.1495
  %.1497 = fadd contract double %.1496, 0x3FE5555555555593
  %.1498 = fmul contract double %.1485, %.1497
  %.1499 = fadd contract double %.1491, %.1498
  %.1500 = fmul contract double %.1479, 5.000000e-01
  %.1501 = fmul contract double %.1479, %.1500
  %.1502 = add nsw i64 %.1475, 4843621399236968448
  %.1503 = bitcast i64 %.1502 to double
  %.1504 = fadd contract double %.1503, 0xC338000000000000
  %.1505 = fmul contract double %.1504, 0x3FE62E42FEE00000
  %.1506 = fadd contract double %.1501, %.1499
  %.1507 = fmul contract double %.1484, %.1506
  %.1508 = fmul contract double %.1504, 0x3DEA39EF35793C76
  %.1509 = fadd contract double %.1508, %.1507
  %.1510 = fsub contract double %.1501, %.1509
  %.1511 = fsub contract double %.1510, %.1479
  %.1512 = fsub contract double %.1505, %.1511
  %.1525 = fcmp contract ogt double %.1512, 0x400BB9D3BEB8C86B
  br i1 %.1525, label %B1560, label %B1572

B1560:                                            ; preds = %B1536, %B1560
  %pieces.2.0 = phi i64 [ %.1528, %B1560 ], [ 1, %B1536 ]
  %.1528 = add i64 %pieces.2.0, 1
  %.1533 = uitofp nneg i64 %.1528 to double
  %.1534 = fmul contract double %.1533, 0x400BB9D3BEB8C86B
  %.1536 = fcmp contract olt double %.1534, %.1512
  br i1 %.1536, label %B1560, label %B1572

B1572:                                            ; preds = %B1560, %B1536
  %pieces.3.1 = phi i64 [ 1, %B1536 ], [ %.1528, %B1560 ]
  %.1543 = sitofp i64 %pieces.3.1 to double
  %.1547 = fdiv contract double %.1512, %.1543
  %.1550 = tail call contract double @llvm.fma.f64(double %.1547, double 0x3FF71547652B82FE, double 0x4338000000000000)
  %.1551 = fadd contract double %.1550, 0xC338000000000000
  %.1554 = tail call contract double @llvm.fma.f64(double %.1551, double 0xBFE62E42FEFA39EF, double %.1547)
  %.1555 = tail call contract double @llvm.fma.f64(double %.1551, double 0xBC7ABC9E3B39803F, double %.1554)
  %.1556 = tail call contract double @llvm.fma.f64(double %.1555, double 0x3DE6124613A86D09, double 0x3E21EED8EFF8D898)
  %.1557 = tail call contract double @llvm.fma.f64(double %.1555, double %.1556, double 0x3E5AE64567F544E4)
  %.1558 = tail call contract double @llvm.fma.f64(double %.1555, double %.1557, double 0x3E927E4FB7789F5C)
  %.1559 = tail call contract double @llvm.fma.f64(double %.1555, double %.1558, double 0x3EC71DE3A556C734)
  %.1560 = tail call contract double @llvm.fma.f64(double %.1555, double %.1559, double 0x3EFA01A01A01A01A)
  %.1561 = tail call contract double @llvm.fma.f64(double %.1555, double %.1560, double 0x3F2A01A01A01A01A)
  %.1562 = tail call contract double @llvm.fma.f64(double %.1555, double %.1561, double 0x3F56C16C16C16C17)
  %.1563 = tail call contract double @llvm.fma.f64(double %.1555, double %.1562, double 0x3F81111111111111)
  %.1564 = tail call contract double @llvm.fma.f64(double %.1555, double %.1563, double 0x3FA5555555555555)
  %.1565 = tail call contract double @llvm.fma.f64(double %.1555, double %.1564, double 0x3FC5555555555555)
  %.1566 = tail call contract double @llvm.fma.f64(double %.1555, double %.1565, double 5.000000e-01)
  %.1567 = fmul contract double %.1555, %.1555
  %.1568 = fadd contract double %.1555, 1.000000e+00
  %.1569 = tail call contract double @llvm.fma.f64(double %.1567, double %.1566, double %.1568)
  %.1570 = bitcast double %.1550 to i64
  %.1571 = shl i64 %.1570, 52
  %.1572 = add i64 %.1571, 4607182418800017408
  %.1573 = bitcast i64 %.1572 to double
  %.1574 = fmul contract double %.1569, %.1573
  %120 = add i64 %pieces.3.1, -1
  %121 = inttoptr i64 %.1410 to ptr
  %.164.i633 = getelementptr i8, ptr %arg.room.4, i64 512
  %.703.i634 = getelementptr i8, ptr %arg.arguments.4, i64 64
  %.894.i640 = getelementptr inbounds nuw i8, ptr %arg.room.4, i64 1024
  %.741.i816 = getelementptr i8, ptr %arg.arguments.4, i64 72
  %.88.i.i818 = getelementptr i8, ptr %arg.prior.4, i64 56
  %.117.i.i820 = getelementptr i8, ptr %arg.prior.4, i64 64
  %.1158.i813 = getelementptr inbounds nuw i8, ptr %arg.room.4, i64 1536
  %.1455.i642 = fmul contract double %arg.n, 5.000000e-01
  %scevgep.i.i703 = getelementptr i8, ptr %arg.room.4, i64 568
  %scevgep3.i.i706 = getelementptr i8, ptr %arg.room.4, i64 520
  %scevgep4.i.i709 = getelementptr i8, ptr %arg.room.4, i64 528
  %scevgep5.i.i712 = getelementptr i8, ptr %arg.room.4, i64 536
  %scevgep6.i.i715 = getelementptr i8, ptr %arg.room.4, i64 544
  %scevgep7.i.i718 = getelementptr i8, ptr %arg.room.4, i64 552
  %scevgep8.i.i721 = getelementptr i8, ptr %arg.room.4, i64 560
  %scevgep1.i.i726 = getelementptr i8, ptr %arg.room.4, i64 632
  %scevgep2.i.1.i = getelementptr i8, ptr %arg.room.4, i64 576
  %scevgep3.i.1.i = getelementptr i8, ptr %arg.room.4, i64 584
  %scevgep4.i.1.i = getelementptr i8, ptr %arg.room.4, i64 592
  %scevgep5.i.1.i = getelementptr i8, ptr %arg.room.4, i64 600
  %scevgep6.i.1.i = getelementptr i8, ptr %arg.room.4, i64 608
  %scevgep7.i.1.i = getelementptr i8, ptr %arg.room.4, i64 616
  %scevgep8.i.1.i = getelementptr i8, ptr %arg.room.4, i64 624
  %scevgep1.i.1.i = getelementptr i8, ptr %arg.room.4, i64 696
  %scevgep2.i.2.i = getelementptr i8, ptr %arg.room.4, i64 640
  %scevgep3.i.2.i = getelementptr i8, ptr %arg.room.4, i64 648
  %scevgep4.i.2.i = getelementptr i8, ptr %arg.room.4, i64 656
  %scevgep5.i.2.i = getelementptr i8, ptr %arg.room.4, i64 664
  %scevgep6.i.2.i = getelementptr i8, ptr %arg.room.4, i64 672
  %scevgep7.i.2.i = getelementptr i8, ptr %arg.room.4, i64 680
  %scevgep8.i.2.i = getelementptr i8, ptr %arg.room.4, i64 688
  %scevgep1.i.2.i = getelementptr i8, ptr %arg.room.4, i64 760
  %scevgep2.i.3.i = getelementptr i8, ptr %arg.room.4, i64 704
  %scevgep3.i.3.i = getelementptr i8, ptr %arg.room.4, i64 712
  %scevgep4.i.3.i = getelementptr i8, ptr %arg.room.4, i64 720
  %scevgep5.i.3.i = getelementptr i8, ptr %arg.room.4, i64 728
  %scevgep6.i.3.i = getelementptr i8, ptr %arg.room.4, i64 736
  %scevgep7.i.3.i = getelementptr i8, ptr %arg.room.4, i64 744
  %scevgep8.i.3.i = getelementptr i8, ptr %arg.room.4, i64 752
  %scevgep1.i.3.i = getelementptr i8, ptr %arg.room.4, i64 824
  %scevgep2.i.4.i = getelementptr i8, ptr %arg.room.4, i64 768
  %scevgep3.i.4.i = getelementptr i8, ptr %arg.room.4, i64 776
  %scevgep4.i.4.i = getelementptr i8, ptr %arg.room.4, i64 784
  %scevgep5.i.4.i = getelementptr i8, ptr %arg.room.4, i64 792
  %scevgep6.i.4.i = getelementptr i8, ptr %arg.room.4, i64 800
  %scevgep7.i.4.i = getelementptr i8, ptr %arg.room.4, i64 808
  %scevgep8.i.4.i = getelementptr i8, ptr %arg.room.4, i64 816
  %scevgep1.i.4.i = getelementptr i8, ptr %arg.room.4, i64 888
  %scevgep2.i.5.i = getelementptr i8, ptr %arg.room.4, i64 832
  %scevgep3.i.5.i = getelementptr i8, ptr %arg.room.4, i64 840
  %scevgep4.i.5.i = getelementptr i8, ptr %arg.room.4, i64 848
  %scevgep5.i.5.i = getelementptr i8, ptr %arg.room.4, i64 856
  %scevgep6.i.5.i = getelementptr i8, ptr %arg.room.4, i64 864
  %scevgep7.i.5.i = getelementptr i8, ptr %arg.room.4, i64 872
  %scevgep8.i.5.i = getelementptr i8, ptr %arg.room.4, i64 880
  %scevgep1.i.5.i = getelementptr i8, ptr %arg.room.4, i64 952
  %scevgep2.i.6.i = getelementptr i8, ptr %arg.room.4, i64 896
  %scevgep3.i.6.i = getelementptr i8, ptr %arg.room.4, i64 904
  %scevgep4.i.6.i = getelementptr i8, ptr %arg.room.4, i64 912
  %scevgep5.i.6.i = getelementptr i8, ptr %arg.room.4, i64 920
  %scevgep6.i.6.i = getelementptr i8, ptr %arg.room.4, i64 928
  %scevgep7.i.6.i = getelementptr i8, ptr %arg.room.4, i64 936
  %scevgep8.i.6.i = getelementptr i8, ptr %arg.room.4, i64 944
  %scevgep1.i.6.i = getelementptr i8, ptr %arg.room.4, i64 1016
  %scevgep2.i.7.i = getelementptr i8, ptr %arg.room.4, i64 960
  %scevgep3.i.7.i = getelementptr i8, ptr %arg.room.4, i64 968
  %scevgep4.i.7.i = getelementptr i8, ptr %arg.room.4, i64 976
  %scevgep5.i.7.i = getelementptr i8, ptr %arg.room.4, i64 984
  %scevgep6.i.7.i = getelementptr i8, ptr %arg.room.4, i64 992
  %scevgep7.i.7.i = getelementptr i8, ptr %arg.room.4, i64 1000
  %scevgep8.i.7.i = getelementptr i8, ptr %arg.room.4, i64 1008
  %.2123.i728 = getelementptr i8, ptr %arg.arguments.4, i64 184
  br label %B1576.if

B3111:                                            ; preds = %_ZN17bnserve_inference15marginal_kernel9_distance8_by_ruleB4v123B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEdddd28Literal_5bbool_5d_28False_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2864_295ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit
  br i1 %.1819, label %B3371, label %B3159

B3159:                                            ; preds = %B3111
  %.1865 = fsub contract double %top.2.0873, %.1778.sroa.0.1
  %.1873 = fcmp contract ogt double %.1865, -7.000000e+02
  %.1865. = select i1 %.1873, double %.1865, double -7.000000e+02
  %.1890 = tail call contract double @llvm.fma.f64(double %.1865., double 0x3FF71547652B82FE, double 0x4338000000000000)
  %.1891 = fadd contract double %.1890, 0xC338000000000000
  %.1894 = tail call contract double @llvm.fma.f64(double %.1891, double 0xBFE62E42FEFA39EF, double %.1865.)
  %.1895 = tail call contract double @llvm.fma.f64(double %.1891, double 0xBC7ABC9E3B39803F, double %.1894)
  %.1896 = tail call contract double @llvm.fma.f64(double %.1895, double 0x3DE6124613A86D09, double 0x3E21EED8EFF8D898)
  %.1897 = tail call contract double @llvm.fma.f64(double %.1895, double %.1896, double 0x3E5AE64567F544E4)
  %.1898 = tail call contract double @llvm.fma.f64(double %.1895, double %.1897, double 0x3E927E4FB7789F5C)
  %.1899 = tail call contract double @llvm.fma.f64(double %.1895, double %.1898, double 0x3EC71DE3A556C734)
  %.1900 = tail call contract double @llvm.fma.f64(double %.1895, double %.1899, double 0x3EFA01A01A01A01A)
  %.1901 = tail call contract double @llvm.fma.f64(double %.1895, double %.1900, double 0x3F2A01A01A01A01A)
  %.1902 = tail call contract double @llvm.fma.f64(double %.1895, double %.1901, double 0x3F56C16C16C16C17)
  %.1903 = tail call contract double @llvm.fma.f64(double %.1895, double %.1902, double 0x3F81111111111111)
  %.1904 = tail call contract double @llvm.fma.f64(double %.1895, double %.1903, double 0x3FA5555555555555)
  %.1905 = tail call contract double @llvm.fma.f64(double %.1895, double %.1904, double 0x3FC5555555555555)
  %.1906 = tail call contract double @llvm.fma.f64(double %.1895, double %.1905, double 5.000000e-01)
  %.1907 = fmul contract double %.1895, %.1895
  %.1908 = fadd contract double %.1895, 1.000000e+00
  %.1909 = tail call contract double @llvm.fma.f64(double %.1907, double %.1906, double %.1908)
  %.1910 = bitcast double %.1890 to i64
  %.1911 = shl i64 %.1910, 52
  %.1912 = add i64 %.1911, 4607182418800017408
  %.1913 = bitcast i64 %.1912 to double
  %.1914 = fmul contract double %.1909, %.1913
  br label %B3371

B3371:                                            ; preds = %B3159, %B3111
  %"$phi1622.1.2.2" = phi double [ %.1914, %B3159 ], [ 0.000000e+00, %B3111 ]
  %.1924 = fmul contract double %factor.3.0874, %"$phi1622.1.2.2"
  %.1928 = fmul contract double %firsts.3.0875, %"$phi1622.1.2.2"
  %.1932 = fmul contract double %squares.3.0876, %"$phi1622.1.2.2"
  br label %B3387

B3387:                                            ; preds = %_ZN17bnserve_inference15marginal_kernel9_distance8_by_ruleB4v123B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEdddd28Literal_5bbool_5d_28False_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2864_295ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit, %B3371
  %top.3.2 = phi double [ %.1778.sroa.0.1, %B3371 ], [ %top.2.0873, %_ZN17bnserve_inference15marginal_kernel9_distance8_by_ruleB4v123B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEdddd28Literal_5bbool_5d_28False_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2864_295ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit ]
  %factor.4.2 = phi double [ %.1924, %B3371 ], [ %factor.3.0874, %_ZN17bnserve_inference15marginal_kernel9_distance8_by_ruleB4v123B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEdddd28Literal_5bbool_5d_28False_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2864_295ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit ]
  %firsts.4.2 = phi double [ %.1928, %B3371 ], [ %firsts.3.0875, %_ZN17bnserve_inference15marginal_kernel9_distance8_by_ruleB4v123B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEdddd28Literal_5bbool_5d_28False_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2864_295ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit ]
  %squares.4.2 = phi double [ %.1932, %B3371 ], [ %squares.3.0876, %_ZN17bnserve_inference15marginal_kernel9_distance8_by_ruleB4v123B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEdddd28Literal_5bbool_5d_28False_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2864_295ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit ]
  %.1982 = fsub contract double %.1778.sroa.0.1, %top.3.2
  %.1988 = fcmp contract ogt double %.1982, -7.000000e+02
  %.1982. = select i1 %.1988, double %.1982, double -7.000000e+02
  %.2010 = tail call contract double @llvm.fma.f64(double %.1982., double 0x3FF71547652B82FE, double 0x4338000000000000)
  %.2011 = fadd contract double %.2010, 0xC338000000000000
  %.2014 = tail call contract double @llvm.fma.f64(double %.2011, double 0xBFE62E42FEFA39EF, double %.1982.)
  %.2015 = tail call contract double @llvm.fma.f64(double %.2011, double 0xBC7ABC9E3B39803F, double %.2014)
  %.2016 = tail call contract double @llvm.fma.f64(double %.2015, double 0x3DE6124613A86D09, double 0x3E21EED8EFF8D898)
  %.2017 = tail call contract double @llvm.fma.f64(double %.2015, double %.2016, double 0x3E5AE64567F544E4)
  %.2018 = tail call contract double @llvm.fma.f64(double %.2015, double %.2017, double 0x3E927E4FB7789F5C)
  %.2019 = tail call contract double @llvm.fma.f64(double %.2015, double %.2018, double 0x3EC71DE3A556C734)
  %.2020 = tail call contract double @llvm.fma.f64(double %.2015, double %.2019, double 0x3EFA01A01A01A01A)
  %.2021 = tail call contract double @llvm.fma.f64(double %.2015, double %.2020, double 0x3F2A01A01A01A01A)
  %.2022 = tail call contract double @llvm.fma.f64(double %.2015, double %.2021, double 0x3F56C16C16C16C17)
  %.2023 = tail call contract double @llvm.fma.f64(double %.2015, double %.2022, double 0x3F81111111111111)
  %.2024 = tail call contract double @llvm.fma.f64(double %.2015, double %.2023, double 0x3FA5555555555555)
  %.2025 = tail call contract double @llvm.fma.f64(double %.2015, double %.2024, double 0x3FC5555555555555)
  %.2026 = tail call contract double @llvm.fma.f64(double %.2015, double %.2025, double 5.000000e-01)
  %.2027 = fmul contract double %.2015, %.2015
  %.2028 = fadd contract double %.2015, 1.000000e+00
  %.2029 = tail call contract double @llvm.fma.f64(double %.2027, double %.2026, double %.2028)
  %.2030 = bitcast double %.2010 to i64
  %.2031 = shl i64 %.2030, 52
  %.2032 = add i64 %.2031, 4607182418800017408
  %.2033 = bitcast i64 %.2032 to double
  %.2034 = fmul contract double %.2029, %.2033
  %.2037 = fmul contract double %.2091.i727, %.2034
  %.2039 = fadd contract double %factor.4.2, %.2037
  %.2046 = fmul contract double %.1778.sroa.8.1, %.2034
  %.2048 = fadd contract double %firsts.4.2, %.2046
  %.2061 = fmul contract double %.1778.sroa.11.1, %.2034
  %.2063 = fadd contract double %squares.4.2, %.2061
  %exitcond.not = icmp eq i64 %pieces.3.1, %.1713
  br i1 %exitcond.not, label %common.ret, label %B1576.if

common.ret:                                       ; preds = %B3387, %_ZN17bnserve_inference15marginal_kernel9_distance8_by_ruleB4v114B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEdddd28Literal_5bbool_5d_28False_295ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit, %_ZN17bnserve_inference15marginal_kernel9_distance8_by_ruleB4v105B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEdddd27Literal_5bbool_5d_28True_295ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit, %_ZN17bnserve_inference15marginal_kernel9_distance8_by_ruleB3v92B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEdddd27Literal_5bbool_5d_28True_295ArrayIdLi1E1C7mutable7alignedE23Literal_5bint_5d_288_295ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit, %_ZN17bnserve_inference15marginal_kernel9_distance9_as_it_isB3v75B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEdd5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit
  %.1315.sroa.0.0.sink = phi double [ %.1315.sroa.0.0, %_ZN17bnserve_inference15marginal_kernel9_distance8_by_ruleB4v114B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEdddd28Literal_5bbool_5d_28False_295ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit ], [ %.836.sroa.0.0, %_ZN17bnserve_inference15marginal_kernel9_distance8_by_ruleB4v105B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEdddd27Literal_5bbool_5d_28True_295ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit ], [ %.469.sroa.0.0, %_ZN17bnserve_inference15marginal_kernel9_distance8_by_ruleB3v92B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEdddd27Literal_5bbool_5d_28True_295ArrayIdLi1E1C7mutable7alignedE23Literal_5bint_5d_288_295ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit ], [ %.94.sroa.0.0, %_ZN17bnserve_inference15marginal_kernel9_distance9_as_it_isB3v75B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEdd5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit ], [ %top.3.2, %B3387 ]
  %.2091.i360.sink = phi double [ %.2091.i360, %_ZN17bnserve_inference15marginal_kernel9_distance8_by_ruleB4v114B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEdddd28Literal_5bbool_5d_28False_295ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit ], [ %.2091.i128, %_ZN17bnserve_inference15marginal_kernel9_distance8_by_ruleB4v105B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEdddd27Literal_5bbool_5d_28True_295ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit ], [ %.2091.i, %_ZN17bnserve_inference15marginal_kernel9_distance8_by_ruleB3v92B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEdddd27Literal_5bbool_5d_28True_295ArrayIdLi1E1C7mutable7alignedE23Literal_5bint_5d_288_295ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit ], [ 1.000000e+00, %_ZN17bnserve_inference15marginal_kernel9_distance9_as_it_isB3v75B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEdd5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit ], [ %.2039, %B3387 ]
  %.1315.sroa.8.0.sink = phi double [ %.1315.sroa.8.0, %_ZN17bnserve_inference15marginal_kernel9_distance8_by_ruleB4v114B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEdddd28Literal_5bbool_5d_28False_295ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit ], [ %.836.sroa.8.0, %_ZN17bnserve_inference15marginal_kernel9_distance8_by_ruleB4v105B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEdddd27Literal_5bbool_5d_28True_295ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit ], [ %.469.sroa.8.0, %_ZN17bnserve_inference15marginal_kernel9_distance8_by_ruleB3v92B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEdddd27Literal_5bbool_5d_28True_295ArrayIdLi1E1C7mutable7alignedE23Literal_5bint_5d_288_295ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit ], [ %.94.sroa.8.0, %_ZN17bnserve_inference15marginal_kernel9_distance9_as_it_isB3v75B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEdd5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit ], [ %.2048, %B3387 ]
  %.1315.sroa.11.0.sink = phi double [ %.1315.sroa.11.0, %_ZN17bnserve_inference15marginal_kernel9_distance8_by_ruleB4v114B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEdddd28Literal_5bbool_5d_28False_295ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit ], [ %.836.sroa.11.0, %_ZN17bnserve_inference15marginal_kernel9_distance8_by_ruleB4v105B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEdddd27Literal_5bbool_5d_28True_295ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit ], [ %.469.sroa.11.0, %_ZN17bnserve_inference15marginal_kernel9_distance8_by_ruleB3v92B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEdddd27Literal_5bbool_5d_28True_295ArrayIdLi1E1C7mutable7alignedE23Literal_5bint_5d_288_295ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit ], [ 1.000000e+00, %_ZN17bnserve_inference15marginal_kernel9_distance9_as_it_isB3v75B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEdd5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit ], [ %.2063, %B3387 ]
  store double %.1315.sroa.0.0.sink, ptr %retptr, align 8
  %retptr.repack839 = getelementptr inbounds nuw i8, ptr %retptr, i64 8
  store double %.2091.i360.sink, ptr %retptr.repack839, align 8
  %retptr.repack841 = getelementptr inbounds nuw i8, ptr %retptr, i64 16
  store double %.1315.sroa.8.0.sink, ptr %retptr.repack841, align 8
  %retptr.repack843 = getelementptr inbounds nuw i8, ptr %retptr, i64 24
  store double %.1315.sroa.11.0.sink, ptr %retptr.repack843, align 8
  ret void

B108.endif:                                       ; preds = %B84
  %.159 = fdiv contract double %arg.x, %arg.n
  %.161 = tail call contract double @llvm.sqrt.f64(double %arg.n)
  %.165 = fdiv contract double 1.000000e+00, %.161
  %.201 = getelementptr i8, ptr %arg.prior.4, i64 40
  %.202 = load double, ptr %.201, align 8
  %.252 = getelementptr i8, ptr %arg.prior.4, i64 24
  %.253 = load double, ptr %.252, align 8
  %.254 = fmul contract double %.253, 2.000000e+00
  %.255 = tail call contract double @llvm.sqrt.f64(double %.254)
  %.257 = fmul contract double %.165, %.255
  %.263 = fsub contract double %.159, %.257
  %.292 = getelementptr i8, ptr %arg.prior.4, i64 8
  %.293 = load double, ptr %.292, align 8
  %.294 = fcmp contract ogt double %.263, %.293
  br i1 %.294, label %B222, label %B360

B1576.if:                                         ; preds = %B3387, %B1572
  %squares.3.0876 = phi double [ 0.000000e+00, %B1572 ], [ %.2063, %B3387 ]
  %firsts.3.0875 = phi double [ 0.000000e+00, %B1572 ], [ %.2048, %B3387 ]
  %factor.3.0874 = phi double [ 0.000000e+00, %B1572 ], [ %.2039, %B3387 ]
  %top.2.0873 = phi double [ 0.000000e+00, %B1572 ], [ %top.3.2, %B3387 ]
  %low.2.0872 = phi double [ %.13.i20, %B1572 ], [ %"$phi1442.1.2.1", %B3387 ]
  %.1706868870 = phi i64 [ 0, %B1572 ], [ %.1713, %B3387 ]
  %.1744 = icmp eq i64 %120, %.1706868870
  %.1753 = fmul contract double %.1574, %low.2.0872
  %"$phi1442.1.2.1" = select i1 %.1744, double %.13.i22, double %.1753
  %.1765 = fsub contract double %"$phi1442.1.2.1", %low.2.0872
  %.1766 = fmul contract double %.1765, 5.000000e-01
  %.1769 = fadd contract double %low.2.0872, %.1766
  call void @llvm.lifetime.start.p0(ptr nonnull %.1212.i572)
  call void @llvm.lifetime.start.p0(ptr nonnull %.2411.i574)
  store ptr null, ptr %.1212.i572, align 8, !noalias !73
  store ptr null, ptr %.2411.i574, align 8, !noalias !73
  br label %B112.if.i576

B274.i632:                                        ; preds = %B182.if.i589
  %.1713 = add i64 %.1706868870, 1
  %.704.i635 = load i64, ptr %.703.i634, align 8, !noalias !73
  %.709.i636 = icmp sgt i64 %.704.i635, 0
  br i1 %.709.i636, label %B322.i815, label %B436.i637

B322.i815:                                        ; preds = %B274.i632
  %.742.i817 = load i64, ptr %.741.i816, align 8, !noalias !73
  %.89.i.i819 = load double, ptr %.88.i.i818, align 8, !noalias !76
  %.118.i.i821 = load double, ptr %.117.i.i820, align 8, !noalias !76
  %.125.i.i822 = fdiv contract double 1.000000e+00, %.118.i.i821
  %.355.i.i823 = add nsw i64 %.704.i635, -1
  %122 = inttoptr i64 %.742.i817 to ptr
  br label %B134.if.i.i824

B436.i637:                                        ; preds = %B134.if.i.i824, %B274.i632
  %.876.i638 = load i64, ptr %arg.arguments.4, align 8, !noalias !73
  %.877.i639 = icmp eq i64 %.876.i638, 1
  br i1 %.877.i639, label %B584.if.i794, label %B760.if.i643.preheader

B760.if.i643.preheader:                           ; preds = %B618.i812, %B436.i637
  br label %B760.if.i643

B618.i812:                                        ; preds = %B584.if.i794
  store ptr null, ptr %.1212.i572, align 8, !noalias !73
  call fastcc void @inner_3(ptr nonnull %.1212.i572, ptr nonnull %.894.i640, i64 64, ptr nonnull readonly %arg.arguments.4, ptr nonnull %.1158.i813, ptr nonnull %.164.i633)
  br label %B760.if.i643.preheader

B892.if.preheader.i656:                           ; preds = %B760.if.i643
  %.1561.i657 = load double, ptr %.164.i633, align 8, !noalias !73
  br label %B892.if.i658

B1188.i702:                                       ; preds = %B972.if.i671
  %.242.i.i704 = load double, ptr %.164.i633, align 8, !noalias !79
  %.244.i.i705 = fadd contract double %.242.i.i704, 0.000000e+00
  %.277.i.i707 = load double, ptr %scevgep3.i.i706, align 8, !noalias !79
  %.279.i.i708 = fadd contract double %.277.i.i707, 0.000000e+00
  %.312.i.i710 = load double, ptr %scevgep4.i.i709, align 8, !noalias !79
  %.314.i.i711 = fadd contract double %.312.i.i710, 0.000000e+00
  %.347.i.i713 = load double, ptr %scevgep5.i.i712, align 8, !noalias !79
  %.349.i.i714 = fadd contract double %.347.i.i713, 0.000000e+00
  %.382.i.i716 = load double, ptr %scevgep6.i.i715, align 8, !noalias !79
  %.384.i.i717 = fadd contract double %.382.i.i716, 0.000000e+00
  %.417.i.i719 = load double, ptr %scevgep7.i.i718, align 8, !noalias !79
  %.419.i.i720 = fadd contract double %.417.i.i719, 0.000000e+00
  %.452.i.i722 = load double, ptr %scevgep8.i.i721, align 8, !noalias !79
  %.454.i.i723 = fadd contract double %.452.i.i722, 0.000000e+00
  %.487.i.i724 = load double, ptr %scevgep.i.i703, align 8, !noalias !79
  %.489.i.i725 = fadd contract double %.487.i.i724, 0.000000e+00
  %.242.i.1.i = load double, ptr %scevgep2.i.1.i, align 8, !noalias !79
  %.244.i.1.i = fadd contract double %.244.i.i705, %.242.i.1.i
  %.277.i.1.i = load double, ptr %scevgep3.i.1.i, align 8, !noalias !79
  %.279.i.1.i = fadd contract double %.279.i.i708, %.277.i.1.i
  %.312.i.1.i = load double, ptr %scevgep4.i.1.i, align 8, !noalias !79
  %.314.i.1.i = fadd contract double %.314.i.i711, %.312.i.1.i
  %.347.i.1.i = load double, ptr %scevgep5.i.1.i, align 8, !noalias !79
  %.349.i.1.i = fadd contract double %.349.i.i714, %.347.i.1.i
  %.382.i.1.i = load double, ptr %scevgep6.i.1.i, align 8, !noalias !79
  %.384.i.1.i = fadd contract double %.384.i.i717, %.382.i.1.i
  %.417.i.1.i = load double, ptr %scevgep7.i.1.i, align 8, !noalias !79
  %.419.i.1.i = fadd contract double %.419.i.i720, %.417.i.1.i
  %.452.i.1.i = load double, ptr %scevgep8.i.1.i, align 8, !noalias !79
  %.454.i.1.i = fadd contract double %.454.i.i723, %.452.i.1.i
  %.487.i.1.i = load double, ptr %scevgep1.i.i726, align 8, !noalias !79
  %.489.i.1.i = fadd contract double %.489.i.i725, %.487.i.1.i
  %.242.i.2.i = load double, ptr %scevgep2.i.2.i, align 8, !noalias !79
  %.244.i.2.i = fadd contract double %.244.i.1.i, %.242.i.2.i
  %.277.i.2.i = load double, ptr %scevgep3.i.2.i, align 8, !noalias !79
  %.279.i.2.i = fadd contract double %.279.i.1.i, %.277.i.2.i
  %.312.i.2.i = load double, ptr %scevgep4.i.2.i, align 8, !noalias !79
  %.314.i.2.i = fadd contract double %.314.i.1.i, %.312.i.2.i
  %.347.i.2.i = load double, ptr %scevgep5.i.2.i, align 8, !noalias !79
  %.349.i.2.i = fadd contract double %.349.i.1.i, %.347.i.2.i
  %.382.i.2.i = load double, ptr %scevgep6.i.2.i, align 8, !noalias !79
  %.384.i.2.i = fadd contract double %.384.i.1.i, %.382.i.2.i
  %.417.i.2.i = load double, ptr %scevgep7.i.2.i, align 8, !noalias !79
  %.419.i.2.i = fadd contract double %.419.i.1.i, %.417.i.2.i
  %.452.i.2.i = load double, ptr %scevgep8.i.2.i, align 8, !noalias !79
  %.454.i.2.i = fadd contract double %.454.i.1.i, %.452.i.2.i
  %.487.i.2.i = load double, ptr %scevgep1.i.1.i, align 8, !noalias !79
  %.489.i.2.i = fadd contract double %.489.i.1.i, %.487.i.2.i
  %.242.i.3.i = load double, ptr %scevgep2.i.3.i, align 8, !noalias !79
  %.244.i.3.i = fadd contract double %.244.i.2.i, %.242.i.3.i
  %.277.i.3.i = load double, ptr %scevgep3.i.3.i, align 8, !noalias !79
  %.279.i.3.i = fadd contract double %.279.i.2.i, %.277.i.3.i
  %.312.i.3.i = load double, ptr %scevgep4.i.3.i, align 8, !noalias !79
  %.314.i.3.i = fadd contract double %.314.i.2.i, %.312.i.3.i
  %.347.i.3.i = load double, ptr %scevgep5.i.3.i, align 8, !noalias !79
  %.349.i.3.i = fadd contract double %.349.i.2.i, %.347.i.3.i
  %.382.i.3.i = load double, ptr %scevgep6.i.3.i, align 8, !noalias !79
  %.384.i.3.i = fadd contract double %.384.i.2.i, %.382.i.3.i
  %.417.i.3.i = load double, ptr %scevgep7.i.3.i, align 8, !noalias !79
  %.419.i.3.i = fadd contract double %.419.i.2.i, %.417.i.3.i
  %.452.i.3.i = load double, ptr %scevgep8.i.3.i, align 8, !noalias !79
  %.454.i.3.i = fadd contract double %.454.i.2.i, %.452.i.3.i
  %.487.i.3.i = load double, ptr %scevgep1.i.2.i, align 8, !noalias !79
  %.489.i.3.i = fadd contract double %.489.i.2.i, %.487.i.3.i
  %.242.i.4.i = load double, ptr %scevgep2.i.4.i, align 8, !noalias !79
  %.244.i.4.i = fadd contract double %.244.i.3.i, %.242.i.4.i
  %.277.i.4.i = load double, ptr %scevgep3.i.4.i, align 8, !noalias !79
  %.279.i.4.i = fadd contract double %.279.i.3.i, %.277.i.4.i
  %.312.i.4.i = load double, ptr %scevgep4.i.4.i, align 8, !noalias !79
  %.314.i.4.i = fadd contract double %.314.i.3.i, %.312.i.4.i
  %.347.i.4.i = load double, ptr %scevgep5.i.4.i, align 8, !noalias !79
  %.349.i.4.i = fadd contract double %.349.i.3.i, %.347.i.4.i
  %.382.i.4.i = load double, ptr %scevgep6.i.4.i, align 8, !noalias !79
  %.384.i.4.i = fadd contract double %.384.i.3.i, %.382.i.4.i
  %.417.i.4.i = load double, ptr %scevgep7.i.4.i, align 8, !noalias !79
  %.419.i.4.i = fadd contract double %.419.i.3.i, %.417.i.4.i
  %.452.i.4.i = load double, ptr %scevgep8.i.4.i, align 8, !noalias !79
  %.454.i.4.i = fadd contract double %.454.i.3.i, %.452.i.4.i
  %.487.i.4.i = load double, ptr %scevgep1.i.3.i, align 8, !noalias !79
  %.489.i.4.i = fadd contract double %.489.i.3.i, %.487.i.4.i
  %.242.i.5.i = load double, ptr %scevgep2.i.5.i, align 8, !noalias !79
  %.244.i.5.i = fadd contract double %.244.i.4.i, %.242.i.5.i
  %.277.i.5.i = load double, ptr %scevgep3.i.5.i, align 8, !noalias !79
  %.279.i.5.i = fadd contract double %.279.i.4.i, %.277.i.5.i
  %.312.i.5.i = load double, ptr %scevgep4.i.5.i, align 8, !noalias !79
  %.314.i.5.i = fadd contract double %.314.i.4.i, %.312.i.5.i
  %.347.i.5.i = load double, ptr %scevgep5.i.5.i, align 8, !noalias !79
  %.349.i.5.i = fadd contract double %.349.i.4.i, %.347.i.5.i
  %.382.i.5.i = load double, ptr %scevgep6.i.5.i, align 8, !noalias !79
  %.384.i.5.i = fadd contract double %.384.i.4.i, %.382.i.5.i
  %.417.i.5.i = load double, ptr %scevgep7.i.5.i, align 8, !noalias !79
  %.419.i.5.i = fadd contract double %.419.i.4.i, %.417.i.5.i
  %.452.i.5.i = load double, ptr %scevgep8.i.5.i, align 8, !noalias !79
  %.454.i.5.i = fadd contract double %.454.i.4.i, %.452.i.5.i
  %.487.i.5.i = load double, ptr %scevgep1.i.4.i, align 8, !noalias !79
  %.489.i.5.i = fadd contract double %.489.i.4.i, %.487.i.5.i
  %.242.i.6.i = load double, ptr %scevgep2.i.6.i, align 8, !noalias !79
  %.244.i.6.i = fadd contract double %.244.i.5.i, %.242.i.6.i
  %.277.i.6.i = load double, ptr %scevgep3.i.6.i, align 8, !noalias !79
  %.279.i.6.i = fadd contract double %.279.i.5.i, %.277.i.6.i
  %.312.i.6.i = load double, ptr %scevgep4.i.6.i, align 8, !noalias !79
  %.314.i.6.i = fadd contract double %.314.i.5.i, %.312.i.6.i
  %.347.i.6.i = load double, ptr %scevgep5.i.6.i, align 8, !noalias !79
  %.349.i.6.i = fadd contract double %.349.i.5.i, %.347.i.6.i
  %.382.i.6.i = load double, ptr %scevgep6.i.6.i, align 8, !noalias !79
  %.384.i.6.i = fadd contract double %.384.i.5.i, %.382.i.6.i
  %.417.i.6.i = load double, ptr %scevgep7.i.6.i, align 8, !noalias !79
  %.419.i.6.i = fadd contract double %.419.i.5.i, %.417.i.6.i
  %.452.i.6.i = load double, ptr %scevgep8.i.6.i, align 8, !noalias !79
  %.454.i.6.i = fadd contract double %.454.i.5.i, %.452.i.6.i
  %.487.i.6.i = load double, ptr %scevgep1.i.5.i, align 8, !noalias !79
  %.489.i.6.i = fadd contract double %.489.i.5.i, %.487.i.6.i
  %.242.i.7.i = load double, ptr %scevgep2.i.7.i, align 8, !noalias !79
  %.244.i.7.i = fadd contract double %.244.i.6.i, %.242.i.7.i
  %.277.i.7.i = load double, ptr %scevgep3.i.7.i, align 8, !noalias !79
  %.279.i.7.i = fadd contract double %.279.i.6.i, %.277.i.7.i
  %.312.i.7.i = load double, ptr %scevgep4.i.7.i, align 8, !noalias !79
  %.314.i.7.i = fadd contract double %.314.i.6.i, %.312.i.7.i
  %.347.i.7.i = load double, ptr %scevgep5.i.7.i, align 8, !noalias !79
  %.349.i.7.i = fadd contract double %.349.i.6.i, %.347.i.7.i
  %.382.i.7.i = load double, ptr %scevgep6.i.7.i, align 8, !noalias !79
  %.384.i.7.i = fadd contract double %.384.i.6.i, %.382.i.7.i
  %.417.i.7.i = load double, ptr %scevgep7.i.7.i, align 8, !noalias !79
  %.419.i.7.i = fadd contract double %.419.i.6.i, %.417.i.7.i
  %.452.i.7.i = load double, ptr %scevgep8.i.7.i, align 8, !noalias !79
  %.454.i.7.i = fadd contract double %.454.i.6.i, %.452.i.7.i
  %.487.i.7.i = load double, ptr %scevgep1.i.6.i, align 8, !noalias !79
  %.489.i.7.i = fadd contract double %.489.i.6.i, %.487.i.7.i
  %123 = fadd contract double %.244.i.7.i, %.279.i.7.i
  %124 = fadd contract double %.314.i.7.i, %.349.i.7.i
  %125 = fadd contract double %123, %124
  %126 = fadd contract double %.384.i.7.i, %.419.i.7.i
  %127 = fadd contract double %.454.i.7.i, %.489.i.7.i
  %128 = fadd contract double %126, %127
  %129 = fadd contract double %125, %128
  %.2091.i727 = fmul contract double %.1766, %129
  %.2124.i729 = load i64, ptr %.2123.i728, align 8, !noalias !73
  %.2125.i730 = icmp eq i64 %.2124.i729, 0
  br i1 %.2125.i730, label %_ZN17bnserve_inference15marginal_kernel9_distance8_by_ruleB4v123B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEdddd28Literal_5bbool_5d_28False_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2864_295ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit, label %B1256.if.i731

B1324.i753:                                       ; preds = %B1256.if.i731
  br i1 %.877.i639, label %B1326.i788, label %B4031.if.i.preheader

B4031.if.i.preheader:                             ; preds = %B1326.i788, %B1324.i753
  br label %B4031.if.i

B1326.i788:                                       ; preds = %B1324.i753
  store ptr null, ptr %.2411.i574, align 8, !noalias !73
  call fastcc void @inner_4(ptr nonnull %.2411.i574, ptr nonnull %.894.i640, i64 64, ptr %arg.room.4, ptr nonnull readonly %arg.arguments.4)
  br label %B4031.if.i.preheader

B4047.i:                                          ; preds = %B4031.if.i
  %.2674.i783 = fmul contract double %.1766, %.2647.3.i780
  %.2679.i784 = fmul contract double %.1766, %.2395.3.i752
  br label %_ZN17bnserve_inference15marginal_kernel9_distance8_by_ruleB4v123B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEdddd28Literal_5bbool_5d_28False_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2864_295ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit

B112.if.i576:                                     ; preds = %B112.if.i576, %B1576.if
  %lsr.iv149.i = phi i64 [ %lsr.iv.next150.i, %B112.if.i576 ], [ 3, %B1576.if ]
  %130 = shl nuw nsw i64 %lsr.iv149.i, 3
  %scevgep87.i = getelementptr i8, ptr %121, i64 %130
  %scevgep86.i = getelementptr i8, ptr %scevgep87.i, i64 -24
  %.380.i577 = load double, ptr %scevgep86.i, align 8, !noalias !73
  %.382.i578 = fmul contract double %.1766, %.380.i577
  %.384.i579 = fadd contract double %.1769, %.382.i578
  %scevgep80.i = getelementptr i8, ptr %arg.room.4, i64 %130
  %scevgep79.i = getelementptr i8, ptr %scevgep80.i, i64 -24
  store double %.384.i579, ptr %scevgep79.i, align 8, !noalias !73
  %scevgep84.i = getelementptr i8, ptr %scevgep87.i, i64 -16
  %.380.1.i580 = load double, ptr %scevgep84.i, align 8, !noalias !73
  %.382.1.i581 = fmul contract double %.1766, %.380.1.i580
  %.384.1.i582 = fadd contract double %.1769, %.382.1.i581
  %scevgep77.i = getelementptr i8, ptr %scevgep80.i, i64 -16
  store double %.384.1.i582, ptr %scevgep77.i, align 8, !noalias !73
  %scevgep82.i = getelementptr i8, ptr %scevgep87.i, i64 -8
  %.380.2.i583 = load double, ptr %scevgep82.i, align 8, !noalias !73
  %.382.2.i584 = fmul contract double %.1766, %.380.2.i583
  %.384.2.i585 = fadd contract double %.1769, %.382.2.i584
  %scevgep75.i = getelementptr i8, ptr %scevgep80.i, i64 -8
  store double %.384.2.i585, ptr %scevgep75.i, align 8, !noalias !73
  %.380.3.i586 = load double, ptr %scevgep87.i, align 8, !noalias !73
  %.382.3.i587 = fmul contract double %.1766, %.380.3.i586
  %.384.3.i588 = fadd contract double %.1769, %.382.3.i587
  store double %.384.3.i588, ptr %scevgep80.i, align 8, !noalias !73
  %lsr.iv.next150.i = add nuw nsw i64 %lsr.iv149.i, 4
  %exitcond.not.3.i = icmp eq i64 %lsr.iv.next150.i, 67
  br i1 %exitcond.not.3.i, label %B182.if.i589, label %B112.if.i576

B182.if.i589:                                     ; preds = %B112.if.i576, %B182.if.i589
  %.50611811183.i590 = phi i64 [ %.513.i591, %B182.if.i589 ], [ 0, %B112.if.i576 ]
  %.513.i591 = add nuw nsw i64 %.50611811183.i590, 1
  %.567.i592 = load double, ptr %arg.prior.4, align 8, !noalias !73
  %131 = shl nuw nsw i64 %.50611811183.i590, 3
  %scevgep73.i = getelementptr i8, ptr %arg.room.4, i64 %131
  %.5981173.i593 = load i64, ptr %scevgep73.i, align 8, !noalias !73
  %.600.i594 = add nsw i64 %.5981173.i593, -4604544271217802189
  %.601.i595 = ashr i64 %.600.i594, 52
  %.602.i596 = and i64 %.600.i594, -4503599627370496
  %.603.i597 = sub nsw i64 %.5981173.i593, %.602.i596
  %.604.i598 = bitcast i64 %.603.i597 to double
  %.605.i599 = fadd contract double %.604.i598, -1.000000e+00
  %.606.i600 = fadd contract double %.605.i599, 2.000000e+00
  %.610.i601 = fdiv contract double %.605.i599, %.606.i600
  %.611.i602 = fmul contract double %.610.i601, %.610.i601
  %.612.i603 = fmul contract double %.611.i602, %.611.i602
  %.613.i604 = fmul contract double %.612.i603, 0x3FC39A09D078C69F
  %.614.i605 = fadd contract double %.613.i604, 0x3FCC71C51D8E78AF
  %.615.i606 = fmul contract double %.612.i603, %.614.i605
  %.616.i607 = fadd contract double %.615.i606, 0x3FD999999997FA04
  %.617.i608 = fmul contract double %.612.i603, %.616.i607
  %.618.i609 = fmul contract double %.612.i603, 0x3FC2F112DF3E5244
  %.619.i610 = fadd contract double %.618.i609, 0x3FC7466496CB03DE
  %.620.i611 = fmul contract double %.612.i603, %.619.i610
  %.621.i612 = fadd contract double %.620.i611, 0x3FD2492494229359
  %.622.i613 = fmul contract double %.612.i603, %.621.i612
  %.623.i614 = fadd contract double %.622.i613, 0x3FE5555555555593
  %.624.i615 = fmul contract double %.611.i602, %.623.i614
  %.625.i616 = fadd contract double %.617.i608, %.624.i615
  %.626.i617 = fmul contract double %.605.i599, 5.000000e-01
  %.627.i618 = fmul contract double %.605.i599, %.626.i617
  %.628.i619 = add nsw i64 %.601.i595, 4843621399236968448
  %.629.i620 = bitcast i64 %.628.i619 to double
  %.630.i621 = fadd contract double %.629.i620, 0xC338000000000000
  %.631.i622 = fmul contract double %.630.i621, 0x3FE62E42FEE00000
  %.632.i623 = fadd contract double %.627.i618, %.625.i616
  %.633.i624 = fmul contract double %.610.i601, %.632.i623
  %.634.i625 = fmul contract double %.630.i621, 0x3DEA39EF35793C76
  %.635.i626 = fadd contract double %.634.i625, %.633.i624
  %.636.i627 = fsub contract double %.627.i618, %.635.i626
  %.637.i628 = fsub contract double %.636.i627, %.605.i599
  %.638.i629 = fsub contract double %.631.i622, %.637.i628
  %.639.i630 = fmul contract double %.567.i592, %.638.i629
  %scevgep72.i631 = getelementptr i8, ptr %scevgep73.i, i64 512
  store double %.639.i630, ptr %scevgep72.i631, align 8, !noalias !73
  %exitcond1235.not.i = icmp eq i64 %.513.i591, 64
  br i1 %exitcond1235.not.i, label %B274.i632, label %B182.if.i589

B134.if.i.i824:                                   ; preds = %B134.if.i.i824, %B322.i815
  %.230207209.i.i825 = phi i64 [ 0, %B322.i815 ], [ %.237.i.i826, %B134.if.i.i824 ]
  %.237.i.i826 = add nuw nsw i64 %.230207209.i.i825, 1
  %132 = shl nuw nsw i64 %.230207209.i.i825, 3
  %scevgep70.i = getelementptr i8, ptr %.164.i633, i64 %132
  %scevgep69.i = getelementptr i8, ptr %scevgep70.i, i64 -512
  %.296205.i.i827 = load i64, ptr %scevgep69.i, align 8, !noalias !76
  %.298.i.i828 = add nsw i64 %.296205.i.i827, -4604544271217802189
  %.299.i.i829 = ashr i64 %.298.i.i828, 52
  %.300.i.i830 = and i64 %.298.i.i828, -4503599627370496
  %.301.i.i831 = sub nsw i64 %.296205.i.i827, %.300.i.i830
  %.302.i.i832 = bitcast i64 %.301.i.i831 to double
  %.303.i.i833 = fadd contract double %.302.i.i832, -1.000000e+00
  %.304.i.i834 = fadd contract double %.303.i.i833, 2.000000e+00
  %.308.i.i835 = fdiv contract double %.303.i.i833, %.304.i.i834
  %.309.i.i836 = fmul contract double %.308.i.i835, %.308.i.i835
  %.310.i.i837 = fmul contract double %.309.i.i836, %.309.i.i836
  %.311.i.i838 = fmul contract double %.310.i.i837, 0x3FC39A09D078C69F
  %.312.i22.i = fadd contract double %.311.i.i838, 0x3FCC71C51D8E78AF
  %.313.i.i839 = fmul contract double %.310.i.i837, %.312.i22.i
  %.314.i23.i = fadd contract double %.313.i.i839, 0x3FD999999997FA04
  %.315.i.i840 = fmul contract double %.310.i.i837, %.314.i23.i
  %.316.i.i841 = fmul contract double %.310.i.i837, 0x3FC2F112DF3E5244
  %.317.i.i842 = fadd contract double %.316.i.i841, 0x3FC7466496CB03DE
  %.318.i.i843 = fmul contract double %.310.i.i837, %.317.i.i842
  %.319.i.i844 = fadd contract double %.318.i.i843, 0x3FD2492494229359
  %.320.i.i845 = fmul contract double %.310.i.i837, %.319.i.i844
  %.321.i.i846 = fadd contract double %.320.i.i845, 0x3FE5555555555593
  %.322.i.i847 = fmul contract double %.309.i.i836, %.321.i.i846
  %.323.i.i848 = fadd contract double %.315.i.i840, %.322.i.i847
  %.324.i.i849 = fmul contract double %.303.i.i833, 5.000000e-01
  %.325.i.i850 = fmul contract double %.303.i.i833, %.324.i.i849
  %.326.i.i851 = add nsw i64 %.299.i.i829, 4843621399236968448
  %.327.i.i852 = bitcast i64 %.326.i.i851 to double
  %.328.i.i853 = fadd contract double %.327.i.i852, 0xC338000000000000
  %.329.i.i854 = fmul contract double %.328.i.i853, 0x3FE62E42FEE00000
  %.330.i.i855 = fadd contract double %.325.i.i850, %.323.i.i848
  %.331.i.i856 = fmul contract double %.308.i.i835, %.330.i.i855
  %.332.i.i857 = fmul contract double %.328.i.i853, 0x3DEA39EF35793C76
  %.333.i.i858 = fadd contract double %.332.i.i857, %.331.i.i856
  %.334.i.i859 = fsub contract double %.325.i.i850, %.333.i.i858
  %.335.i.i860 = fsub contract double %.334.i.i859, %.303.i.i833
  %.336.i.i861 = fsub contract double %.329.i.i854, %.335.i.i860
  %.337.i.i862 = fneg contract double %.336.i.i861
  %.339.i.i863 = fsub contract double %.337.i.i862, %.89.i.i819
  %.341.i.i864 = fmul contract double %.125.i.i822, %.339.i.i863
  %.348.i.i865 = fadd contract double %.341.i.i864, -5.000000e-01
  %.349.i24.i = fadd contract double %.348.i.i865, 0x4338000000000000
  %.350.i.i866 = bitcast double %.349.i24.i to i64
  %133 = tail call i64 @llvm.smax.i64(i64 %.350.i.i866, i64 4843621399236968448)
  %nearest_cell_v103__vphi100_0.2.1.i.i867 = add nsw i64 %133, -4843621399236968448
  %nearest_cell_v103__vphi120_0.2.1.i.i868 = tail call i64 @llvm.smin.i64(i64 %nearest_cell_v103__vphi100_0.2.1.i.i867, i64 %.355.i.i823)
  %.405.i.i869 = uitofp nneg i64 %nearest_cell_v103__vphi120_0.2.1.i.i868 to double
  %.406.i.i870 = fsub contract double %.341.i.i864, %.405.i.i869
  %.440.i.i871 = load double, ptr %scevgep70.i, align 8, !noalias !76
  %.idx.i.i872 = mul i64 %nearest_cell_v103__vphi120_0.2.1.i.i868, 48
  %134 = getelementptr i8, ptr %122, i64 %.idx.i.i872
  %.470.i.i873 = load double, ptr %134, align 8, !noalias !76
  %135 = getelementptr i8, ptr %134, i64 8
  %.501.i.i874 = load double, ptr %135, align 8, !noalias !76
  %136 = getelementptr i8, ptr %134, i64 16
  %.532.i.i875 = load double, ptr %136, align 8, !noalias !76
  %137 = getelementptr i8, ptr %134, i64 24
  %.563.i.i876 = load double, ptr %137, align 8, !noalias !76
  %.564.i.i877 = fmul contract double %.563.i.i876, %.406.i.i870
  %.565.i.i878 = fadd contract double %.532.i.i875, %.564.i.i877
  %.566.i.i879 = fmul contract double %.406.i.i870, %.565.i.i878
  %.567.i.i880 = fadd contract double %.501.i.i874, %.566.i.i879
  %.568.i.i881 = fmul contract double %.406.i.i870, %.567.i.i880
  %.569.i.i882 = fadd contract double %.470.i.i873, %.568.i.i881
  %.570.i.i883 = fadd contract double %.440.i.i871, %.569.i.i882
  store double %.570.i.i883, ptr %scevgep70.i, align 8, !noalias !76
  %exitcond.not.i27.i = icmp eq i64 %.237.i.i826, 64
  br i1 %exitcond.not.i27.i, label %B436.i637, label %B134.if.i.i824

B584.if.i794:                                     ; preds = %B436.i637, %B584.if.i794
  %.103911881190.i = phi i64 [ %.1046.3.i807, %B584.if.i794 ], [ 0, %B436.i637 ]
  %sunkaddr90.i = shl i64 %.103911881190.i, 3
  %sunkaddr91.i795 = getelementptr i8, ptr %arg.room.4, i64 %sunkaddr90.i
  %.1100.i796 = load double, ptr %sunkaddr91.i795, align 8, !noalias !73
  %.1102.i797 = fmul contract double %arg.x, %.1100.i796
  %sunkaddr94.i798 = getelementptr i8, ptr %sunkaddr91.i795, i64 1024
  store double %.1102.i797, ptr %sunkaddr94.i798, align 8, !noalias !73
  %sunkaddr97.i799 = getelementptr i8, ptr %sunkaddr91.i795, i64 8
  %.1100.1.i800 = load double, ptr %sunkaddr97.i799, align 8, !noalias !73
  %.1102.1.i801 = fmul contract double %arg.x, %.1100.1.i800
  %sunkaddr100.i802 = getelementptr i8, ptr %sunkaddr91.i795, i64 1032
  store double %.1102.1.i801, ptr %sunkaddr100.i802, align 8, !noalias !73
  %sunkaddr103.i803 = getelementptr i8, ptr %sunkaddr91.i795, i64 16
  %.1100.2.i804 = load double, ptr %sunkaddr103.i803, align 8, !noalias !73
  %.1102.2.i805 = fmul contract double %arg.x, %.1100.2.i804
  %sunkaddr106.i806 = getelementptr i8, ptr %sunkaddr91.i795, i64 1040
  store double %.1102.2.i805, ptr %sunkaddr106.i806, align 8, !noalias !73
  %.1046.3.i807 = add nuw nsw i64 %.103911881190.i, 4
  %sunkaddr109.i808 = getelementptr i8, ptr %sunkaddr91.i795, i64 24
  %.1100.3.i809 = load double, ptr %sunkaddr109.i808, align 8, !noalias !73
  %.1102.3.i810 = fmul contract double %arg.x, %.1100.3.i809
  %sunkaddr112.i811 = getelementptr i8, ptr %sunkaddr91.i795, i64 1048
  store double %.1102.3.i810, ptr %sunkaddr112.i811, align 8, !noalias !73
  %exitcond1236.not.3.i = icmp eq i64 %.1046.3.i807, 64
  br i1 %exitcond1236.not.3.i, label %B618.i812, label %B584.if.i794

B760.if.i643:                                     ; preds = %B760.if.i643.preheader, %B760.if.i643
  %lsr.iv118.i = phi i64 [ %lsr.iv.next119.i, %B760.if.i643 ], [ 65, %B760.if.i643.preheader ]
  %138 = shl nuw nsw i64 %lsr.iv118.i, 3
  %scevgep51.i = getelementptr i8, ptr %arg.room.4, i64 %138
  %scevgep50.i = getelementptr i8, ptr %scevgep51.i, i64 -8
  %.1423.i644 = load double, ptr %scevgep50.i, align 8, !noalias !73
  %scevgep48.i = getelementptr i8, ptr %scevgep51.i, i64 -520
  %.1453.i645 = load double, ptr %scevgep48.i, align 8, !noalias !73
  %.1486.i646 = fmul contract double %.1455.i642, %.1453.i645
  %.1488.i647 = fsub contract double %arg.x, %.1486.i646
  %.1489.i648 = fmul contract double %.1453.i645, %.1488.i647
  %.1490.i649 = fadd contract double %.1423.i644, %.1489.i648
  store double %.1490.i649, ptr %scevgep50.i, align 8, !noalias !73
  %.1423.1.i650 = load double, ptr %scevgep51.i, align 8, !noalias !73
  %scevgep46.i = getelementptr i8, ptr %scevgep51.i, i64 -512
  %.1453.1.i651 = load double, ptr %scevgep46.i, align 8, !noalias !73
  %.1486.1.i652 = fmul contract double %.1455.i642, %.1453.1.i651
  %.1488.1.i653 = fsub contract double %arg.x, %.1486.1.i652
  %.1489.1.i654 = fmul contract double %.1453.1.i651, %.1488.1.i653
  %.1490.1.i655 = fadd contract double %.1423.1.i650, %.1489.1.i654
  store double %.1490.1.i655, ptr %scevgep51.i, align 8, !noalias !73
  %lsr.iv.next119.i = add nuw nsw i64 %lsr.iv118.i, 2
  %exitcond1237.not.1.i = icmp eq i64 %lsr.iv.next119.i, 129
  br i1 %exitcond1237.not.1.i, label %B892.if.preheader.i656, label %B760.if.i643

B892.if.i658:                                     ; preds = %B892.if.i658, %B892.if.preheader.i656
  %lsr.iv109.i = phi i64 [ %lsr.iv.next110.i, %B892.if.i658 ], [ 67, %B892.if.preheader.i656 ]
  %top.2.01206.i = phi double [ %.1716.top.2.0.3.i670, %B892.if.i658 ], [ %.1561.i657, %B892.if.preheader.i656 ]
  %139 = shl nuw nsw i64 %lsr.iv109.i, 3
  %scevgep44.i = getelementptr i8, ptr %arg.room.4, i64 %139
  %scevgep43.i = getelementptr i8, ptr %scevgep44.i, i64 -24
  %.1716.i659 = load double, ptr %scevgep43.i, align 8, !noalias !73
  %.1718.i660 = fcmp contract ogt double %.1716.i659, %top.2.01206.i
  %.1716.top.2.0.i661 = select i1 %.1718.i660, double %.1716.i659, double %top.2.01206.i
  %scevgep41.i = getelementptr i8, ptr %scevgep44.i, i64 -16
  %.1716.1.i662 = load double, ptr %scevgep41.i, align 8, !noalias !73
  %.1718.1.i663 = fcmp contract ogt double %.1716.1.i662, %.1716.top.2.0.i661
  %.1716.top.2.0.1.i664 = select i1 %.1718.1.i663, double %.1716.1.i662, double %.1716.top.2.0.i661
  %scevgep39.i = getelementptr i8, ptr %scevgep44.i, i64 -8
  %.1716.2.i665 = load double, ptr %scevgep39.i, align 8, !noalias !73
  %.1718.2.i666 = fcmp contract ogt double %.1716.2.i665, %.1716.top.2.0.1.i664
  %.1716.top.2.0.2.i667 = select i1 %.1718.2.i666, double %.1716.2.i665, double %.1716.top.2.0.1.i664
  %.1716.3.i668 = load double, ptr %scevgep44.i, align 8, !noalias !73
  %.1718.3.i669 = fcmp contract ogt double %.1716.3.i668, %.1716.top.2.0.2.i667
  %.1716.top.2.0.3.i670 = select i1 %.1718.3.i669, double %.1716.3.i668, double %.1716.top.2.0.2.i667
  %lsr.iv.next110.i = add nuw nsw i64 %lsr.iv109.i, 4
  %exitcond1238.not.3.i = icmp eq i64 %lsr.iv.next110.i, 131
  br i1 %exitcond1238.not.3.i, label %B972.if.i671, label %B892.if.i658

B972.if.i671:                                     ; preds = %B892.if.i658, %B972.if.i671
  %lsr.iv105.i = phi i64 [ %lsr.iv.next106.i, %B972.if.i671 ], [ 64, %B892.if.i658 ]
  %140 = shl nuw nsw i64 %lsr.iv105.i, 3
  %scevgep37.i672 = getelementptr i8, ptr %121, i64 %140
  %.1930.i673 = load double, ptr %scevgep37.i672, align 8, !noalias !73
  %scevgep36.i = getelementptr i8, ptr %arg.room.4, i64 %140
  %.1965.i674 = load double, ptr %scevgep36.i, align 8, !noalias !73
  %.1967.i675 = fsub contract double %.1965.i674, %.1716.top.2.0.3.i670
  %.1973.i676 = fcmp contract ogt double %.1967.i675, -7.000000e+02
  %.1967..i677 = select i1 %.1973.i676, double %.1967.i675, double -7.000000e+02
  %.1990.i678 = tail call contract double @llvm.fma.f64(double %.1967..i677, double 0x3FF71547652B82FE, double 0x4338000000000000)
  %.1991.i679 = fadd contract double %.1990.i678, 0xC338000000000000
  %.1994.i680 = tail call contract double @llvm.fma.f64(double %.1991.i679, double 0xBFE62E42FEFA39EF, double %.1967..i677)
  %.1995.i681 = tail call contract double @llvm.fma.f64(double %.1991.i679, double 0xBC7ABC9E3B39803F, double %.1994.i680)
  %.1996.i682 = tail call contract double @llvm.fma.f64(double %.1995.i681, double 0x3DE6124613A86D09, double 0x3E21EED8EFF8D898)
  %.1997.i683 = tail call contract double @llvm.fma.f64(double %.1995.i681, double %.1996.i682, double 0x3E5AE64567F544E4)
  %.1998.i684 = tail call contract double @llvm.fma.f64(double %.1995.i681, double %.1997.i683, double 0x3E927E4FB7789F5C)
  %.1999.i685 = tail call contract double @llvm.fma.f64(double %.1995.i681, double %.1998.i684, double 0x3EC71DE3A556C734)
  %.2000.i686 = tail call contract double @llvm.fma.f64(double %.1995.i681, double %.1999.i685, double 0x3EFA01A01A01A01A)
  %.2001.i687 = tail call contract double @llvm.fma.f64(double %.1995.i681, double %.2000.i686, double 0x3F2A01A01A01A01A)
  %.2002.i688 = tail call contract double @llvm.fma.f64(double %.1995.i681, double %.2001.i687, double 0x3F56C16C16C16C17)
  %.2003.i689 = tail call contract double @llvm.fma.f64(double %.1995.i681, double %.2002.i688, double 0x3F81111111111111)
  %.2004.i690 = tail call contract double @llvm.fma.f64(double %.1995.i681, double %.2003.i689, double 0x3FA5555555555555)
  %.2005.i691 = tail call contract double @llvm.fma.f64(double %.1995.i681, double %.2004.i690, double 0x3FC5555555555555)
  %.2006.i692 = tail call contract double @llvm.fma.f64(double %.1995.i681, double %.2005.i691, double 5.000000e-01)
  %.2007.i693 = fmul contract double %.1995.i681, %.1995.i681
  %.2008.i694 = fadd contract double %.1995.i681, 1.000000e+00
  %.2009.i695 = tail call contract double @llvm.fma.f64(double %.2007.i693, double %.2006.i692, double %.2008.i694)
  %.2010.i696 = bitcast double %.1990.i678 to i64
  %.2011.i697 = shl i64 %.2010.i696, 52
  %.2012.i698 = add i64 %.2011.i697, 4607182418800017408
  %.2013.i699 = bitcast i64 %.2012.i698 to double
  %.2014.i700 = fmul contract double %.2009.i695, %.2013.i699
  %.2016.i701 = fmul contract double %.1930.i673, %.2014.i700
  store double %.2016.i701, ptr %scevgep36.i, align 8, !noalias !73
  %lsr.iv.next106.i = add nuw nsw i64 %lsr.iv105.i, 1
  %exitcond1239.not.i = icmp eq i64 %lsr.iv.next106.i, 128
  br i1 %exitcond1239.not.i, label %B1188.i702, label %B972.if.i671

B1256.if.i731:                                    ; preds = %B1188.i702, %B1256.if.i731
  %lsr.iv88.i = phi i64 [ %lsr.iv.next89.i, %B1256.if.i731 ], [ 67, %B1188.i702 ]
  %squares.2.01222.i = phi double [ %.2395.3.i752, %B1256.if.i731 ], [ 0.000000e+00, %B1188.i702 ]
  %141 = shl nuw nsw i64 %lsr.iv88.i, 3
  %scevgep35.i = getelementptr i8, ptr %arg.room.4, i64 %141
  %scevgep34.i = getelementptr i8, ptr %scevgep35.i, i64 -24
  %.2331.i732 = load double, ptr %scevgep34.i, align 8, !noalias !73
  %scevgep32.i = getelementptr i8, ptr %scevgep35.i, i64 -536
  %.2361.i733 = load double, ptr %scevgep32.i, align 8, !noalias !73
  %.2362.i734 = fmul contract double %.2331.i732, %.2361.i733
  %.2393.i735 = fmul contract double %.2361.i733, %.2362.i734
  %.2395.i736 = fadd contract double %squares.2.01222.i, %.2393.i735
  %scevgep29.i = getelementptr i8, ptr %scevgep35.i, i64 -16
  %.2331.1.i737 = load double, ptr %scevgep29.i, align 8, !noalias !73
  %scevgep26.i = getelementptr i8, ptr %scevgep35.i, i64 -528
  %.2361.1.i738 = load double, ptr %scevgep26.i, align 8, !noalias !73
  %.2362.1.i739 = fmul contract double %.2331.1.i737, %.2361.1.i738
  %.2393.1.i740 = fmul contract double %.2361.1.i738, %.2362.1.i739
  %.2395.1.i741 = fadd contract double %.2395.i736, %.2393.1.i740
  %scevgep23.i = getelementptr i8, ptr %scevgep35.i, i64 -8
  %.2331.2.i742 = load double, ptr %scevgep23.i, align 8, !noalias !73
  %scevgep20.i743 = getelementptr i8, ptr %scevgep35.i, i64 -520
  %.2361.2.i744 = load double, ptr %scevgep20.i743, align 8, !noalias !73
  %.2362.2.i745 = fmul contract double %.2331.2.i742, %.2361.2.i744
  %.2393.2.i746 = fmul contract double %.2361.2.i744, %.2362.2.i745
  %.2395.2.i747 = fadd contract double %.2395.1.i741, %.2393.2.i746
  %.2331.3.i748 = load double, ptr %scevgep35.i, align 8, !noalias !73
  %scevgep17.i = getelementptr i8, ptr %scevgep35.i, i64 -512
  %.2361.3.i749 = load double, ptr %scevgep17.i, align 8, !noalias !73
  %.2362.3.i750 = fmul contract double %.2331.3.i748, %.2361.3.i749
  %.2393.3.i751 = fmul contract double %.2361.3.i749, %.2362.3.i750
  %.2395.3.i752 = fadd contract double %.2395.2.i747, %.2393.3.i751
  %lsr.iv.next89.i = add nuw nsw i64 %lsr.iv88.i, 4
  %exitcond1240.not.3.i = icmp eq i64 %lsr.iv.next89.i, 131
  br i1 %exitcond1240.not.3.i, label %B1324.i753, label %B1256.if.i731

B4031.if.i:                                       ; preds = %B4031.if.i.preheader, %B4031.if.i
  %lsr.iv.i755 = phi i64 [ %lsr.iv.next.i781, %B4031.if.i ], [ -64, %B4031.if.i.preheader ]
  %firsts.2.01231.i = phi double [ %.2647.3.i780, %B4031.if.i ], [ 0.000000e+00, %B4031.if.i.preheader ]
  %sunkaddr113.i = shl i64 %lsr.iv.i755, 3
  %sunkaddr114.i756 = getelementptr i8, ptr %arg.room.4, i64 %sunkaddr113.i
  %sunkaddr115.i757 = getelementptr i8, ptr %sunkaddr114.i756, i64 1024
  %.2614.i758 = load double, ptr %sunkaddr115.i757, align 8, !noalias !73
  %sunkaddr118.i759 = getelementptr i8, ptr %sunkaddr114.i756, i64 512
  %.2644.i760 = load double, ptr %sunkaddr118.i759, align 8, !noalias !73
  %.2645.i761 = fmul contract double %.2614.i758, %.2644.i760
  %.2647.i762 = fadd contract double %firsts.2.01231.i, %.2645.i761
  %sunkaddr121.i763 = getelementptr i8, ptr %sunkaddr114.i756, i64 1032
  %.2614.1.i764 = load double, ptr %sunkaddr121.i763, align 8, !noalias !73
  %sunkaddr124.i765 = getelementptr i8, ptr %sunkaddr114.i756, i64 520
  %.2644.1.i766 = load double, ptr %sunkaddr124.i765, align 8, !noalias !73
  %.2645.1.i767 = fmul contract double %.2614.1.i764, %.2644.1.i766
  %.2647.1.i768 = fadd contract double %.2647.i762, %.2645.1.i767
  %sunkaddr127.i769 = getelementptr i8, ptr %sunkaddr114.i756, i64 1040
  %.2614.2.i770 = load double, ptr %sunkaddr127.i769, align 8, !noalias !73
  %sunkaddr130.i771 = getelementptr i8, ptr %sunkaddr114.i756, i64 528
  %.2644.2.i772 = load double, ptr %sunkaddr130.i771, align 8, !noalias !73
  %.2645.2.i773 = fmul contract double %.2614.2.i770, %.2644.2.i772
  %.2647.2.i774 = fadd contract double %.2647.1.i768, %.2645.2.i773
  %sunkaddr133.i775 = getelementptr i8, ptr %sunkaddr114.i756, i64 1048
  %.2614.3.i776 = load double, ptr %sunkaddr133.i775, align 8, !noalias !73
  %sunkaddr136.i777 = getelementptr i8, ptr %sunkaddr114.i756, i64 536
  %.2644.3.i778 = load double, ptr %sunkaddr136.i777, align 8, !noalias !73
  %.2645.3.i779 = fmul contract double %.2614.3.i776, %.2644.3.i778
  %.2647.3.i780 = fadd contract double %.2647.2.i774, %.2645.3.i779
  %lsr.iv.next.i781 = add nsw i64 %lsr.iv.i755, 4
  %exitcond1241.not.3.i = icmp eq i64 %lsr.iv.next.i781, 0
  br i1 %exitcond1241.not.3.i, label %B4047.i, label %B4031.if.i

_ZN17bnserve_inference15marginal_kernel9_distance8_by_ruleB4v123B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEdddd28Literal_5bbool_5d_28False_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2864_295ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit: ; preds = %B1188.i702, %B4047.i
  %.1778.sroa.8.1 = phi double [ %.2674.i783, %B4047.i ], [ 0.000000e+00, %B1188.i702 ]
  %.1778.sroa.11.1 = phi double [ %.2679.i784, %B4047.i ], [ 0.000000e+00, %B1188.i702 ]
  %.1778.sroa.0.1 = fadd contract double %.1716.top.2.0.3.i670, 0.000000e+00
  call void @llvm.lifetime.end.p0(ptr nonnull %.1212.i572)
  call void @llvm.lifetime.end.p0(ptr nonnull %.2411.i574)
  %.1819 = icmp eq i64 %.1706868870, 0
  %.1840 = fcmp contract ogt double %.1716.top.2.0.3.i670, %top.2.0873
  %or.cond832 = select i1 %.1819, i1 true, i1 %.1840
  br i1 %or.cond832, label %B3111, label %B3387
}

; Function Attrs: mustprogress nocallback nocreateundeforpoison nofree nosync nounwind speculatable willreturn memory(none)
declare double @llvm.fma.f64(double, double, double) #2

; Function Attrs: nofree norecurse nosync nounwind memory(read, argmem: readwrite, inaccessiblemem: none, target_mem0: none, target_mem1: none)
define internal fastcc void @inner_3(ptr noalias nonnull writeonly captures(none) %retptr, ptr readonly captures(none) %arg.x.4, i64 %arg.x.5.0, ptr readonly captures(none) %arg.arguments.4, ptr captures(none) %arg.room.4, ptr captures(none) %arg.out.4) unnamed_addr #3 {
entry:
  %.103 = load double, ptr %arg.x.4, align 8
  %.178 = icmp sgt i64 %arg.x.5.0, 0
  br i1 %.178, label %B92.if.preheader, label %B186

B92.if.preheader:                                 ; preds = %entry
  %0 = icmp eq i64 %arg.x.5.0, 1
  br i1 %0, label %B92.if.epil.preheader, label %B92.if.preheader.new

B92.if.preheader.new:                             ; preds = %B92.if.preheader
  %unroll_iter = and i64 %arg.x.5.0, 9223372036854775806
  br label %B92.if

B186.loopexit.unr-lcssa:                          ; preds = %B92.if
  %1 = and i64 %arg.x.5.0, 1
  %lcmp.mod.not = icmp eq i64 %1, 0
  br i1 %lcmp.mod.not, label %B186, label %B92.if.epil.preheader

B92.if.epil.preheader:                            ; preds = %B186.loopexit.unr-lcssa, %B92.if.preheader
  %least.2.0882.epil.init = phi double [ %.103, %B92.if.preheader ], [ %.293.least.2.0.1, %B186.loopexit.unr-lcssa ]
  %most.2.0881.epil.init = phi double [ %.103, %B92.if.preheader ], [ %"$phi182.1.2.1.1", %B186.loopexit.unr-lcssa ]
  %.228877879.epil.init = phi i64 [ 0, %B92.if.preheader ], [ %unroll_iter, %B186.loopexit.unr-lcssa ]
  %2 = getelementptr double, ptr %arg.x.4, i64 %.228877879.epil.init
  %.293.epil = load double, ptr %2, align 8
  %.295.epil = fcmp contract olt double %.293.epil, %least.2.0882.epil.init
  %.293.least.2.0.epil = select i1 %.295.epil, double %.293.epil, double %least.2.0882.epil.init
  %.378.epil = fcmp contract ogt double %.293.epil, %most.2.0881.epil.init
  %"$phi182.1.2.1.epil" = select i1 %.378.epil, double %.293.epil, double %most.2.0881.epil.init
  br label %B186

B186:                                             ; preds = %B92.if.epil.preheader, %B186.loopexit.unr-lcssa, %entry
  %most.2.0.lcssa = phi double [ %.103, %entry ], [ %"$phi182.1.2.1.1", %B186.loopexit.unr-lcssa ], [ %"$phi182.1.2.1.epil", %B92.if.epil.preheader ]
  %least.2.0.lcssa = phi double [ %.103, %entry ], [ %.293.least.2.0.1, %B186.loopexit.unr-lcssa ], [ %.293.least.2.0.epil, %B92.if.epil.preheader ]
  %.523 = getelementptr double, ptr %arg.room.4, i64 %arg.x.5.0
  %.593 = fcmp contract ogt double %most.2.0.lcssa, 8.000000e+00
  br i1 %.593, label %B276, label %B408

B276:                                             ; preds = %B186
  %.625 = getelementptr i8, ptr %arg.arguments.4, i64 128
  %.626 = load i64, ptr %.625, align 8
  %.657 = getelementptr i8, ptr %arg.arguments.4, i64 120
  %.658 = load i64, ptr %.657, align 8
  br i1 %.178, label %B60.if.preheader.i, label %B86.i

B408:                                             ; preds = %B396.if.i, %B366.i, %B186
  %.747 = fcmp contract ult double %least.2.0.lcssa, 8.000000e+00
  br i1 %.747, label %B582, label %B430

B430:                                             ; preds = %B408
  %.843888.not = icmp slt i64 %arg.x.5.0, 1
  br i1 %.843888.not, label %common.ret, label %B460.if

common.ret:                                       ; preds = %B460.if, %B940, %B582.endif.endif, %B430
  store ptr null, ptr %retptr, align 8
  ret void

B582:                                             ; preds = %B408
  %.1129 = getelementptr i8, ptr %arg.arguments.4, i64 144
  %.1130 = load i64, ptr %.1129, align 8
  %.1161 = getelementptr i8, ptr %arg.arguments.4, i64 136
  %.1162 = load i64, ptr %.1161, align 8
  br i1 %.178, label %B56.if.preheader.i, label %B72.i

B798:                                             ; preds = %B742.if
  %scevgep = getelementptr i8, ptr %arg.room.4, i64 %28
  %.1486 = load double, ptr %scevgep, align 8
  %.1518 = fmul contract double %.1486, %.1486
  %.1555 = fdiv contract double %.1518, %.1435
  %.1556 = bitcast double %.1555 to i64
  %.1557 = add nsw i64 %.1556, -4604544271217802189
  %.1558 = ashr i64 %.1557, 52
  %.1559 = and i64 %.1557, -4503599627370496
  %.1560 = sub nsw i64 %.1556, %.1559
  %.1561 = bitcast i64 %.1560 to double
  %.1562 = fadd contract double %.1561, -1.000000e+00
  %.1563 = fadd contract double %.1562, 2.000000e+00
  %.1567 = fdiv contract double %.1562, %.1563
  %.1568 = fmul contract double %.1567, %.1567
  %.1569 = fmul contract double %.1568, %.1568
  %.1570 = fmul contract double %.1569, 0x3FC39A09D078C69F
  %.1571 = fadd contract double %.1570, 0x3FCC71C51D8E78AF
  %.1572 = fmul contract double %.1569, %.1571
  %.1573 = fadd contract double %.1572, 0x3FD999999997FA04
  %.1574 = fmul contract double %.1569, %.1573
  %.1575 = fmul contract double %.1569, 0x3FC2F112DF3E5244
  %.1576 = fadd contract double %.1575, 0x3FC7466496CB03DE
  %.1577 = fmul contract double %.1569, %.1576
  %.1578 = fadd contract double %.1577, 0x3FD2492494229359
  %.1579 = fmul contract double %.1569, %.1578
  %.1580 = fadd contract double %.1579, 0x3FE5555555555593
  %.1581 = fmul contract double %.1568, %.1580
  %.1582 = fadd contract double %.1574, %.1581
  %.1583 = fmul contract double %.1562, 5.000000e-01
  %.1584 = fmul contract double %.1562, %.1583
  %.1585 = add nsw i64 %.1558, 4843621399236968448
  %.1586 = bitcast i64 %.1585 to double
  %.1587 = fadd contract double %.1586, 0xC338000000000000
  %.1588 = fmul contract double %.1587, 0x3FE62E42FEE00000
  %.1589 = fadd contract double %.1584, %.1582
  %.1590 = fmul contract double %.1567, %.1589
  %.1591 = fmul contract double %.1587, 0x3DEA39EF35793C76
  %.1592 = fadd contract double %.1591, %.1590
  %.1593 = fsub contract double %.1584, %.1592
  %.1594 = fsub contract double %.1593, %.1562
  %.1595 = fsub contract double %.1588, %.1594
  %.1596 = fmul contract double %.1595, 5.000000e-01
  br label %B940

B882:                                             ; preds = %B742.if
  %scevgep1 = getelementptr i8, ptr %scevgep63, i64 %28
  %.1632872 = load i64, ptr %scevgep1, align 8
  %.1634 = add nsw i64 %.1632872, -4604544271217802189
  %.1635 = ashr i64 %.1634, 52
  %.1636 = and i64 %.1634, -4503599627370496
  %.1637 = sub nsw i64 %.1632872, %.1636
  %.1638 = bitcast i64 %.1637 to double
  %.1639 = fadd contract double %.1638, -1.000000e+00
  %.1640 = fadd contract double %.1639, 2.000000e+00
  %.1644 = fdiv contract double %.1639, %.1640
  %.1645 = fmul contract double %.1644, %.1644
  %.1646 = fmul contract double %.1645, %.1645
  %.1647 = fmul contract double %.1646, 0x3FC39A09D078C69F
  %.1648 = fadd contract double %.1647, 0x3FCC71C51D8E78AF
  %.1649 = fmul contract double %.1646, %.1648
  %.1650 = fadd contract double %.1649, 0x3FD999999997FA04
  %.1651 = fmul contract double %.1646, %.1650
  %.1652 = fmul contract double %.1646, 0x3FC2F112DF3E5244
  %.1653 = fadd contract double %.1652, 0x3FC7466496CB03DE
  %.1654 = fmul contract double %.1646, %.1653
  %.1655 = fadd contract double %.1654, 0x3FD2492494229359
  %.1656 = fmul contract double %.1646, %.1655
  %.1657 = fadd contract double %.1656, 0x3FE5555555555593
  %.1658 = fmul contract double %.1645, %.1657
  %.1659 = fadd contract double %.1651, %.1658
  %.1660 = fmul contract double %.1639, 5.000000e-01
  %.1661 = fmul contract double %.1639, %.1660
  %.1662 = add nsw i64 %.1635, 4843621399236968448
  %.1663 = bitcast i64 %.1662 to double
  %.1664 = fadd contract double %.1663, 0xC338000000000000
  %.1665 = fmul contract double %.1664, 0x3FE62E42FEE00000
  %.1666 = fadd contract double %.1661, %.1659
  %.1667 = fmul contract double %.1644, %.1666
  %.1668 = fmul contract double %.1664, 0x3DEA39EF35793C76
  %.1669 = fadd contract double %.1668, %.1667
  %.1670 = fsub contract double %.1661, %.1669
  %.1671 = fsub contract double %.1670, %.1639
  %.1672 = fsub contract double %.1665, %.1671
  %.1706 = fsub contract double %.1672, %.1435
  br label %B940

B940:                                             ; preds = %B882, %B798
  %"$phi940.4.2.1" = phi double [ %.1596, %B798 ], [ %.1706, %B882 ]
  %.1712 = fadd contract double %.1404, %"$phi940.4.2.1"
  store double %.1712, ptr %scevgep66, align 8
  %exitcond901.not = icmp eq i64 %arg.x.5.0, %.1346
  br i1 %exitcond901.not, label %common.ret, label %B742.if

B92.if:                                           ; preds = %B92.if, %B92.if.preheader.new
  %least.2.0882 = phi double [ %.103, %B92.if.preheader.new ], [ %.293.least.2.0.1, %B92.if ]
  %most.2.0881 = phi double [ %.103, %B92.if.preheader.new ], [ %"$phi182.1.2.1.1", %B92.if ]
  %.228877879 = phi i64 [ 0, %B92.if.preheader.new ], [ %.235.1, %B92.if ]
  %sunkaddr55 = shl i64 %.228877879, 3
  %sunkaddr56 = getelementptr i8, ptr %arg.x.4, i64 %sunkaddr55
  %.293 = load double, ptr %sunkaddr56, align 8
  %.295 = fcmp contract olt double %.293, %least.2.0882
  %.293.least.2.0 = select i1 %.295, double %.293, double %least.2.0882
  %.378 = fcmp contract ogt double %.293, %most.2.0881
  %"$phi182.1.2.1" = select i1 %.378, double %.293, double %most.2.0881
  %.235.1 = add nuw i64 %.228877879, 2
  %sunkaddr61 = getelementptr i8, ptr %sunkaddr56, i64 8
  %.293.1 = load double, ptr %sunkaddr61, align 8
  %.295.1 = fcmp contract olt double %.293.1, %.293.least.2.0
  %.293.least.2.0.1 = select i1 %.295.1, double %.293.1, double %.293.least.2.0
  %.378.1 = fcmp contract ogt double %.293.1, %"$phi182.1.2.1"
  %"$phi182.1.2.1.1" = select i1 %.378.1, double %.293.1, double %"$phi182.1.2.1"
  %niter.ncmp.1 = icmp eq i64 %unroll_iter, %.235.1
  br i1 %niter.ncmp.1, label %B186.loopexit.unr-lcssa, label %B92.if

B60.if.preheader.i:                               ; preds = %B276
  %xtraiter.i = and i64 %arg.x.5.0, 3
  %3 = icmp ult i64 %arg.x.5.0, 4
  br i1 %3, label %B60.if.epil.preheader.i, label %B60.if.preheader.new.i

B60.if.preheader.new.i:                           ; preds = %B60.if.preheader.i
  %4 = add nsw i64 %arg.x.5.0, -4
  %5 = lshr i64 %4, 2
  %6 = icmp eq i64 %5, 0
  br i1 %6, label %B60.if.i.epil.preheader, label %B60.if.preheader.new.i.new

B60.if.preheader.new.i.new:                       ; preds = %B60.if.preheader.new.i
  %7 = add nuw nsw i64 %5, 1
  %scevgep76 = getelementptr i8, ptr %arg.room.4, i64 56
  %8 = shl i64 %arg.x.5.0, 3
  %scevgep92 = getelementptr i8, ptr %scevgep76, i64 %8
  %9 = and i64 %7, 9223372036854775806
  br label %B60.if.i

B86.loopexit.unr-lcssa.i.unr-lcssa:               ; preds = %B60.if.i
  %10 = and i64 %4, 4
  %lcmp.mod58.not.not = icmp eq i64 %10, 0
  br i1 %lcmp.mod58.not.not, label %B60.if.i.epil.preheader, label %B86.loopexit.unr-lcssa.i

B60.if.i.epil.preheader:                          ; preds = %B86.loopexit.unr-lcssa.i.unr-lcssa, %B60.if.preheader.new.i
  %.162406408.i.epil.init = phi i64 [ 0, %B60.if.preheader.new.i ], [ %.169.3.i.1, %B86.loopexit.unr-lcssa.i.unr-lcssa ]
  %sunkaddr.i.epil = shl i64 %.162406408.i.epil.init, 3
  %sunkaddr27.i.epil = getelementptr i8, ptr %arg.room.4, i64 %sunkaddr.i.epil
  store double 0.000000e+00, ptr %sunkaddr27.i.epil, align 8, !noalias !82
  %sunkaddr29.i.epil = getelementptr i8, ptr %.523, i64 %sunkaddr.i.epil
  store double 0.000000e+00, ptr %sunkaddr29.i.epil, align 8, !noalias !82
  %sunkaddr32.i.epil = getelementptr i8, ptr %sunkaddr27.i.epil, i64 8
  store double 0.000000e+00, ptr %sunkaddr32.i.epil, align 8, !noalias !82
  %sunkaddr35.i.epil = getelementptr i8, ptr %sunkaddr29.i.epil, i64 8
  store double 0.000000e+00, ptr %sunkaddr35.i.epil, align 8, !noalias !82
  %sunkaddr38.i.epil = getelementptr i8, ptr %sunkaddr27.i.epil, i64 16
  store double 0.000000e+00, ptr %sunkaddr38.i.epil, align 8, !noalias !82
  %sunkaddr41.i.epil = getelementptr i8, ptr %sunkaddr29.i.epil, i64 16
  store double 0.000000e+00, ptr %sunkaddr41.i.epil, align 8, !noalias !82
  %.169.3.i.epil = add nuw nsw i64 %.162406408.i.epil.init, 4
  %sunkaddr44.i.epil = getelementptr i8, ptr %sunkaddr27.i.epil, i64 24
  store double 0.000000e+00, ptr %sunkaddr44.i.epil, align 8, !noalias !82
  %sunkaddr47.i.epil = getelementptr i8, ptr %sunkaddr29.i.epil, i64 24
  store double 0.000000e+00, ptr %sunkaddr47.i.epil, align 8, !noalias !82
  br label %B86.loopexit.unr-lcssa.i

B86.loopexit.unr-lcssa.i:                         ; preds = %B60.if.i.epil.preheader, %B86.loopexit.unr-lcssa.i.unr-lcssa
  %.169.3.i.lcssa = phi i64 [ %.169.3.i.epil, %B60.if.i.epil.preheader ], [ %.169.3.i.1, %B86.loopexit.unr-lcssa.i.unr-lcssa ]
  %lcmp.mod.not.i = icmp eq i64 %xtraiter.i, 0
  br i1 %lcmp.mod.not.i, label %B86.i, label %B60.if.epil.preheader.i

B60.if.epil.preheader.i:                          ; preds = %B86.loopexit.unr-lcssa.i, %B60.if.preheader.i
  %.162406408.epil.init.i = phi i64 [ 0, %B60.if.preheader.i ], [ %.169.3.i.lcssa, %B86.loopexit.unr-lcssa.i ]
  %11 = shl i64 %.162406408.epil.init.i, 3
  %scevgep7.i = getelementptr i8, ptr %.523, i64 %11
  %scevgep9.i = getelementptr i8, ptr %arg.room.4, i64 %11
  br label %B60.if.epil.i

B60.if.epil.i:                                    ; preds = %B60.if.epil.i, %B60.if.epil.preheader.i
  %epil.iter.i = phi i64 [ %epil.iter.next.i, %B60.if.epil.i ], [ 0, %B60.if.epil.preheader.i ]
  %12 = shl i64 %epil.iter.i, 3
  %scevgep75 = getelementptr i8, ptr %scevgep9.i, i64 %12
  store double 0.000000e+00, ptr %scevgep75, align 8, !noalias !82
  %scevgep74 = getelementptr i8, ptr %scevgep7.i, i64 %12
  store double 0.000000e+00, ptr %scevgep74, align 8, !noalias !82
  %epil.iter.next.i = add i64 %epil.iter.i, 1
  %epil.iter.cmp.not.i = icmp eq i64 %xtraiter.i, %epil.iter.next.i
  br i1 %epil.iter.cmp.not.i, label %B86.i, label %B60.if.epil.i, !llvm.loop !85

B86.i:                                            ; preds = %B60.if.epil.i, %B86.loopexit.unr-lcssa.i, %B276
  %notsub.i = add i64 %.626, -2
  %.308.i = icmp slt i64 %notsub.i, -1
  %.307.neg.i = add i64 %.626, -1
  %storemerge400.i = select i1 %.308.i, i64 0, i64 %.307.neg.i
  %.350424.i = icmp sgt i64 %storemerge400.i, 0
  br i1 %.350424.i, label %B148.if.preheader.i, label %B366.i

B148.if.preheader.i:                              ; preds = %B86.i
  %13 = shl i64 %.626, 3
  %14 = icmp slt i64 %arg.x.5.0, 1
  %15 = inttoptr i64 %.658 to ptr
  br label %B148.if.i

B148.loopexit.i:                                  ; preds = %B182.if.i, %B148.if.i
  %.350.i = icmp sgt i64 %.349418426.i, 1
  br i1 %.350.i, label %B148.if.i, label %B366.i

B366.i:                                           ; preds = %B148.loopexit.i, %B86.i
  %.847433.not.i = icmp slt i64 %arg.x.5.0, 1
  br i1 %.847433.not.i, label %B408, label %B396.if.i.preheader

B396.if.i.preheader:                              ; preds = %B366.i
  %16 = inttoptr i64 %.658 to ptr
  br label %B396.if.i

B60.if.i:                                         ; preds = %B60.if.i, %B60.if.preheader.new.i.new
  %lsr.iv = phi i64 [ %lsr.iv.next, %B60.if.i ], [ %9, %B60.if.preheader.new.i.new ]
  %.162406408.i = phi i64 [ %.169.3.i.1, %B60.if.i ], [ 0, %B60.if.preheader.new.i.new ]
  %sunkaddr.i = shl i64 %.162406408.i, 3
  %scevgep90 = getelementptr i8, ptr %scevgep76, i64 %sunkaddr.i
  %scevgep91 = getelementptr i8, ptr %scevgep90, i64 -56
  store double 0.000000e+00, ptr %scevgep91, align 8, !noalias !82
  %scevgep106 = getelementptr i8, ptr %scevgep92, i64 %sunkaddr.i
  %scevgep107 = getelementptr i8, ptr %scevgep106, i64 -56
  store double 0.000000e+00, ptr %scevgep107, align 8, !noalias !82
  %scevgep42 = getelementptr i8, ptr %scevgep90, i64 -48
  store double 0.000000e+00, ptr %scevgep42, align 8, !noalias !82
  %scevgep24 = getelementptr i8, ptr %scevgep106, i64 -48
  store double 0.000000e+00, ptr %scevgep24, align 8, !noalias !82
  %scevgep39 = getelementptr i8, ptr %scevgep90, i64 -40
  store double 0.000000e+00, ptr %scevgep39, align 8, !noalias !82
  %scevgep21 = getelementptr i8, ptr %scevgep106, i64 -40
  store double 0.000000e+00, ptr %scevgep21, align 8, !noalias !82
  %scevgep36 = getelementptr i8, ptr %scevgep90, i64 -32
  store double 0.000000e+00, ptr %scevgep36, align 8, !noalias !82
  %scevgep18 = getelementptr i8, ptr %scevgep106, i64 -32
  store double 0.000000e+00, ptr %scevgep18, align 8, !noalias !82
  %scevgep33 = getelementptr i8, ptr %scevgep90, i64 -24
  store double 0.000000e+00, ptr %scevgep33, align 8, !noalias !82
  %scevgep14 = getelementptr i8, ptr %scevgep106, i64 -24
  store double 0.000000e+00, ptr %scevgep14, align 8, !noalias !82
  %scevgep30 = getelementptr i8, ptr %scevgep90, i64 -16
  store double 0.000000e+00, ptr %scevgep30, align 8, !noalias !82
  %scevgep10 = getelementptr i8, ptr %scevgep106, i64 -16
  store double 0.000000e+00, ptr %scevgep10, align 8, !noalias !82
  %scevgep27 = getelementptr i8, ptr %scevgep90, i64 -8
  store double 0.000000e+00, ptr %scevgep27, align 8, !noalias !82
  %scevgep8 = getelementptr i8, ptr %scevgep106, i64 -8
  store double 0.000000e+00, ptr %scevgep8, align 8, !noalias !82
  %.169.3.i.1 = add i64 %.162406408.i, 8
  store double 0.000000e+00, ptr %scevgep90, align 8, !noalias !82
  store double 0.000000e+00, ptr %scevgep106, align 8, !noalias !82
  %lsr.iv.next = add i64 %lsr.iv, -2
  %niter62.ncmp.1 = icmp eq i64 %lsr.iv.next, 0
  br i1 %niter62.ncmp.1, label %B86.loopexit.unr-lcssa.i.unr-lcssa, label %B60.if.i

B148.if.i:                                        ; preds = %B148.loopexit.i, %B148.if.preheader.i
  %.349418426.i = phi i64 [ %.359.i, %B148.loopexit.i ], [ %storemerge400.i, %B148.if.preheader.i ]
  %.356419425.in.i = phi i64 [ %.356419425.i, %B148.loopexit.i ], [ %.626, %B148.if.preheader.i ]
  %.356419425.i = add i64 %.356419425.in.i, -1
  %.359.i = add nsw i64 %.349418426.i, -1
  br i1 %14, label %B148.loopexit.i, label %B182.if.lr.ph.i

B182.if.lr.ph.i:                                  ; preds = %B148.if.i
  %.631.i = icmp slt i64 %.356419425.i, 0
  %17 = getelementptr double, ptr %15, i64 %.356419425.i
  %sunkaddr48.i = select i1 %.631.i, i64 %13, i64 0
  %sunkaddr62 = getelementptr inbounds i8, ptr %17, i64 %sunkaddr48.i
  br label %B182.if.i

B182.if.i:                                        ; preds = %B182.if.i, %B182.if.lr.ph.i
  %.477412414.i = phi i64 [ 0, %B182.if.lr.ph.i ], [ %.484.i, %B182.if.i ]
  %.484.i = add nuw nsw i64 %.477412414.i, 1
  %18 = shl i64 %.477412414.i, 3
  %scevgep6.i = getelementptr i8, ptr %arg.x.4, i64 %18
  %.542.i = load double, ptr %scevgep6.i, align 8, !noalias !82
  %.543.i = fcmp contract ogt double %.542.i, 8.000000e+00
  %.542..i = select i1 %.543.i, double %.542.i, double 8.000000e+00
  %scevgep5.i = getelementptr i8, ptr %arg.room.4, i64 %18
  %.616.i = load double, ptr %scevgep5.i, align 8, !noalias !82
  %.647.i = load double, ptr %sunkaddr62, align 8, !noalias !82
  %.652.i = fdiv contract double 1.600000e+01, %.542..i
  %.653.i = fadd contract double %.652.i, -1.000000e+00
  %.654.i = fmul contract double %.653.i, 2.000000e+00
  %.655.i = fmul contract double %.616.i, %.654.i
  %.656.i = fadd contract double %.647.i, %.655.i
  %scevgep6 = getelementptr i8, ptr %.523, i64 %18
  %.687.i = load double, ptr %scevgep6, align 8, !noalias !82
  %.688.i = fsub contract double %.656.i, %.687.i
  store double %.688.i, ptr %scevgep5.i, align 8, !noalias !82
  store double %.616.i, ptr %scevgep6, align 8, !noalias !82
  %exitcond438.not.i = icmp eq i64 %arg.x.5.0, %.484.i
  br i1 %exitcond438.not.i, label %B148.loopexit.i, label %B182.if.i

B396.if.i:                                        ; preds = %B396.if.i.preheader, %B396.if.i
  %.853432434.i = phi i64 [ %.860.i, %B396.if.i ], [ 0, %B396.if.i.preheader ]
  %.860.i = add nuw nsw i64 %.853432434.i, 1
  %19 = shl i64 %.853432434.i, 3
  %scevgep3.i = getelementptr i8, ptr %arg.x.4, i64 %19
  %.918.i = load double, ptr %scevgep3.i, align 8, !noalias !82
  %.919.i = fcmp contract ogt double %.918.i, 8.000000e+00
  %.918..i = select i1 %.919.i, double %.918.i, double 8.000000e+00
  %.991.i = load double, ptr %16, align 8, !noalias !82
  %.996.i = fdiv contract double 1.600000e+01, %.918..i
  %.997.i = fadd contract double %.996.i, -1.000000e+00
  %scevgep5 = getelementptr i8, ptr %arg.room.4, i64 %19
  %.1028.i = load double, ptr %scevgep5, align 8, !noalias !82
  %.1029.i = fmul contract double %.1028.i, %.997.i
  %.1030.i = fadd contract double %.991.i, %.1029.i
  %scevgep4 = getelementptr i8, ptr %.523, i64 %19
  %.1061.i = load double, ptr %scevgep4, align 8, !noalias !82
  %.1062.i = fsub contract double %.1030.i, %.1061.i
  store double %.1062.i, ptr %scevgep5, align 8, !noalias !82
  %exitcond439.not.i = icmp eq i64 %arg.x.5.0, %.860.i
  br i1 %exitcond439.not.i, label %B408, label %B396.if.i

B460.if:                                          ; preds = %B430, %B460.if
  %.849887889 = phi i64 [ %.856, %B460.if ], [ 0, %B430 ]
  %.856 = add nuw nsw i64 %.849887889, 1
  %20 = shl i64 %.849887889, 3
  %scevgep70 = getelementptr i8, ptr %arg.out.4, i64 %20
  %.910 = load double, ptr %scevgep70, align 8
  %scevgep69 = getelementptr i8, ptr %arg.room.4, i64 %20
  %.941 = load double, ptr %scevgep69, align 8
  %.972 = fmul contract double %.941, %.941
  %scevgep3 = getelementptr i8, ptr %arg.x.4, i64 %20
  %.1002 = load double, ptr %scevgep3, align 8
  %.1006 = fdiv contract double %.972, %.1002
  %.1007 = bitcast double %.1006 to i64
  %.1008 = add nsw i64 %.1007, -4604544271217802189
  %.1009 = ashr i64 %.1008, 52
  %.1010 = and i64 %.1008, -4503599627370496
  %.1011 = sub nsw i64 %.1007, %.1010
  %.1012 = bitcast i64 %.1011 to double
  %.1013 = fadd contract double %.1012, -1.000000e+00
  %.1014 = fadd contract double %.1013, 2.000000e+00
  %.1018 = fdiv contract double %.1013, %.1014
  %.1019 = fmul contract double %.1018, %.1018
  %.1020 = fmul contract double %.1019, %.1019
  %.1021 = fmul contract double %.1020, 0x3FC39A09D078C69F
  %.1022 = fadd contract double %.1021, 0x3FCC71C51D8E78AF
  %.1023 = fmul contract double %.1020, %.1022
  %.1024 = fadd contract double %.1023, 0x3FD999999997FA04
  %.1025 = fmul contract double %.1020, %.1024
  %.1026 = fmul contract double %.1020, 0x3FC2F112DF3E5244
  %.1027 = fadd contract double %.1026, 0x3FC7466496CB03DE
  %.1028 = fmul contract double %.1020, %.1027
  %.1029 = fadd contract double %.1028, 0x3FD2492494229359
  %.1030 = fmul contract double %.1020, %.1029
  %.1031 = fadd contract double %.1030, 0x3FE5555555555593
  %.1032 = fmul contract double %.1019, %.1031
  %.1033 = fadd contract double %.1025, %.1032
  %.1034 = fmul contract double %.1013, 5.000000e-01
  %.1035 = fmul contract double %.1013, %.1034
  %.1036 = add nsw i64 %.1009, 4843621399236968448
  %.1037 = bitcast i64 %.1036 to double
  %.1038 = fadd contract double %.1037, 0xC338000000000000
  %.1039 = fmul contract double %.1038, 0x3FE62E42FEE00000
  %.1040 = fadd contract double %.1035, %.1033
  %.1041 = fmul contract double %.1018, %.1040
  %.1042 = fmul contract double %.1038, 0x3DEA39EF35793C76
  %.1043 = fadd contract double %.1042, %.1041
  %.1044 = fsub contract double %.1035, %.1043
  %.1045 = fsub contract double %.1044, %.1013
  %.1046 = fsub contract double %.1039, %.1045
  %.1047 = fmul contract double %.1046, 5.000000e-01
  %.1048 = fadd contract double %.910, %.1047
  store double %.1048, ptr %scevgep70, align 8
  %exitcond900.not = icmp eq i64 %arg.x.5.0, %.856
  br i1 %exitcond900.not, label %common.ret, label %B460.if

B56.if.preheader.i:                               ; preds = %B582
  %21 = shl nuw i64 %arg.x.5.0, 3
  tail call void @llvm.memset.p0.i64(ptr nonnull align 8 %.523, i8 0, i64 %21, i1 false), !noalias !86
  br label %B72.i

B72.i:                                            ; preds = %B56.if.preheader.i, %B582
  %.260.i = icmp ugt i64 %.1130, -9223372036854775808
  %.arg.series.5.0.i = select i1 %.260.i, i64 0, i64 %.1130
  %.302263.i = icmp sgt i64 %.arg.series.5.0.i, 0
  br i1 %.302263.i, label %B134.if.preheader.i, label %B582.endif.endif

B134.if.preheader.i:                              ; preds = %B72.i
  %22 = shl i64 %.1130, 3
  %23 = icmp slt i64 %arg.x.5.0, 1
  %24 = inttoptr i64 %.1162 to ptr
  br label %B134.if.i

B134.loopexit.i:                                  ; preds = %B190.if.i, %B134.if.i
  %.302.i = icmp sgt i64 %.301257265.i, 1
  br i1 %.302.i, label %B134.if.i, label %B582.endif.endif

B134.if.i:                                        ; preds = %B134.loopexit.i, %B134.if.preheader.i
  %.301257265.i = phi i64 [ %.311.i, %B134.loopexit.i ], [ %.arg.series.5.0.i, %B134.if.preheader.i ]
  %.308258264.in.i = phi i64 [ %.308258264.i, %B134.loopexit.i ], [ %.1130, %B134.if.preheader.i ]
  %.308258264.i = add i64 %.308258264.in.i, -1
  %.311.i = add nsw i64 %.301257265.i, -1
  br i1 %23, label %B134.loopexit.i, label %B190.if.lr.ph.i

B190.if.lr.ph.i:                                  ; preds = %B134.if.i
  %.562.i = icmp slt i64 %.308258264.i, 0
  %25 = getelementptr double, ptr %24, i64 %.308258264.i
  %sunkaddr.i16 = select i1 %.562.i, i64 %22, i64 0
  %sunkaddr63 = getelementptr inbounds i8, ptr %25, i64 %sunkaddr.i16
  br label %B190.if.i

B190.if.i:                                        ; preds = %B190.if.i, %B190.if.lr.ph.i
  %.439251253.i = phi i64 [ 0, %B190.if.lr.ph.i ], [ %.446.i, %B190.if.i ]
  %.446.i = add nuw nsw i64 %.439251253.i, 1
  %26 = shl i64 %.439251253.i, 3
  %scevgep1.i = getelementptr i8, ptr %arg.x.4, i64 %26
  %.504.i = load double, ptr %scevgep1.i, align 8, !noalias !86
  %.505.i = fcmp contract olt double %.504.i, 8.000000e+00
  %.504..i = select i1 %.505.i, double %.504.i, double 8.000000e+00
  %.578.i = load double, ptr %sunkaddr63, align 8, !noalias !86
  %.579.i = fmul contract double %.504..i, 2.500000e-01
  %.580.i = fmul contract double %.504..i, %.579.i
  %scevgep2 = getelementptr i8, ptr %.523, i64 %26
  %.611.i = load double, ptr %scevgep2, align 8, !noalias !86
  %.612.i = fmul contract double %.611.i, %.580.i
  %.613.i = fadd contract double %.578.i, %.612.i
  store double %.613.i, ptr %scevgep2, align 8, !noalias !86
  %exitcond270.not.i = icmp eq i64 %arg.x.5.0, %.446.i
  br i1 %exitcond270.not.i, label %B134.loopexit.i, label %B190.if.i

B582.endif.endif:                                 ; preds = %B134.loopexit.i, %B72.i
  %.1333895.not = icmp slt i64 %arg.x.5.0, 1
  br i1 %.1333895.not, label %common.ret, label %B742.if.preheader

B742.if.preheader:                                ; preds = %B582.endif.endif
  %27 = shl i64 %arg.x.5.0, 3
  %scevgep63 = getelementptr i8, ptr %arg.room.4, i64 %27
  br label %B742.if

B742.if:                                          ; preds = %B742.if.preheader, %B940
  %.1339894896 = phi i64 [ %.1346, %B940 ], [ 0, %B742.if.preheader ]
  %.1346 = add nuw nsw i64 %.1339894896, 1
  %28 = shl i64 %.1339894896, 3
  %scevgep66 = getelementptr i8, ptr %arg.out.4, i64 %28
  %.1404 = load double, ptr %scevgep66, align 8
  %scevgep65 = getelementptr i8, ptr %arg.x.4, i64 %28
  %.1435 = load double, ptr %scevgep65, align 8
  %.1436 = fcmp contract ult double %.1435, 8.000000e+00
  br i1 %.1436, label %B882, label %B798
}

; Function Attrs: nofree norecurse nosync nounwind memory(read, argmem: readwrite, inaccessiblemem: none, target_mem0: none, target_mem1: none)
define internal fastcc void @inner_4(ptr noalias nonnull writeonly captures(none) %retptr, ptr readonly captures(none) %arg.x.4, i64 %arg.x.5.0, ptr captures(none) %arg.u.4, ptr readonly captures(none) %arg.arguments.4) unnamed_addr #3 {
entry:
  %.71 = getelementptr i8, ptr %arg.arguments.4, i64 128
  %.72 = load i64, ptr %.71, align 8
  %.256422.not = icmp slt i64 %arg.x.5.0, 1
  br i1 %.256422.not, label %B713, label %B156.if.lr.ph

B196:                                             ; preds = %B156.if
  %.365 = fdiv contract double 1.600000e+01, %.327
  %.366 = fadd contract double %.365, -1.000000e+00
  br i1 %8, label %B294.if.lr.ph, label %B386

B294.if.lr.ph:                                    ; preds = %B196
  %.528 = fmul contract double %.366, 2.000000e+00
  br i1 %10, label %B294.if.prol.loopexit, label %B294.if.prol

B294.if.prol:                                     ; preds = %B294.if.lr.ph
  %.530.prol = fmul contract double %.528, 0.000000e+00
  %.531.prol = fadd contract double %.530.prol, 0.000000e+00
  %.568.prol = load double, ptr %sunkaddr9, align 8
  %.573.prol = fadd contract double %.530.prol, %.568.prol
  br label %B294.if.prol.loopexit

B294.if.prol.loopexit:                            ; preds = %B294.if.prol, %B294.if.lr.ph
  %slope_one.2.1400.unr = phi double [ 0.000000e+00, %B294.if.lr.ph ], [ %.531.prol, %B294.if.prol ]
  %one.2.1398.unr = phi double [ 0.000000e+00, %B294.if.lr.ph ], [ %.573.prol, %B294.if.prol ]
  %.486393397.unr = phi i64 [ %storemerge384, %B294.if.lr.ph ], [ %.496.prol, %B294.if.prol ]
  %.493394396.in.unr = phi i64 [ %.72, %B294.if.lr.ph ], [ %.444.neg, %B294.if.prol ]
  %.533.lcssa.unr = phi double [ poison, %B294.if.lr.ph ], [ %.531.prol, %B294.if.prol ]
  %.575.lcssa.unr = phi double [ poison, %B294.if.lr.ph ], [ %.573.prol, %B294.if.prol ]
  br i1 %11, label %B386, label %B294.if.preheader

B294.if.preheader:                                ; preds = %B294.if.prol.loopexit
  %0 = add i64 %.486393397.unr, 2
  %1 = add i64 %.493394396.in.unr, -1
  br label %B294.if

B386:                                             ; preds = %B294.if, %B294.if.prol.loopexit, %B196
  %one.2.1.lcssa = phi double [ 0.000000e+00, %B196 ], [ %.575.lcssa.unr, %B294.if.prol.loopexit ], [ %.575.1, %B294.if ]
  %two.2.1.lcssa = phi double [ 0.000000e+00, %B196 ], [ 0.000000e+00, %B294.if.prol.loopexit ], [ %.575, %B294.if ]
  %slope_one.2.1.lcssa = phi double [ 0.000000e+00, %B196 ], [ %.533.lcssa.unr, %B294.if.prol.loopexit ], [ %.533.1, %B294.if ]
  %slope_two.2.1.lcssa = phi double [ 0.000000e+00, %B196 ], [ 0.000000e+00, %B294.if.prol.loopexit ], [ %.533, %B294.if ]
  %.588 = fmul contract double %.366, %slope_one.2.1.lcssa
  %.592 = fadd contract double %one.2.1.lcssa, %.588
  %.594 = fsub contract double %.592, %slope_two.2.1.lcssa
  %.626 = load double, ptr %3, align 8
  %.629 = fmul contract double %.366, %one.2.1.lcssa
  %.634 = fadd contract double %.629, %.626
  %.636 = fsub contract double %.634, %two.2.1.lcssa
  %2 = getelementptr double, ptr %arg.u.4, i64 %.262409427
  %.669 = load double, ptr %2, align 8
  %.704 = fdiv contract double 5.000000e-01, %.327
  %.705 = fsub contract double 1.000000e+00, %.704
  %.769 = fmul contract double %.327, %.327
  %.773 = fdiv contract double 1.600000e+01, %.769
  %.774 = fmul contract double %.773, %.594
  %.778 = fdiv contract double %.774, %.636
  %.779 = fsub contract double %.705, %.778
  %.780 = fmul contract double %.669, %.779
  store double %.780, ptr %2, align 8
  br label %B712

B712:                                             ; preds = %B618.if, %B386
  %exitcond.not = icmp eq i64 %.269, %arg.x.5.0
  br i1 %exitcond.not, label %B713, label %B156.if

B713:                                             ; preds = %B712, %entry
  store ptr null, ptr %retptr, align 8
  ret void

B156.if.lr.ph:                                    ; preds = %entry
  %.104 = getelementptr i8, ptr %arg.arguments.4, i64 120
  %.105 = load i64, ptr %.104, align 8
  %3 = inttoptr i64 %.105 to ptr
  %notsub = add i64 %.72, -2
  %.445 = icmp slt i64 %notsub, -1
  %.444.neg = add i64 %.72, -1
  %storemerge384 = select i1 %.445, i64 0, i64 %.444.neg
  %.496.prol = add nsw i64 %storemerge384, -1
  %.552.prol = icmp slt i64 %.444.neg, 0
  %4 = getelementptr double, ptr %3, i64 %.444.neg
  %5 = shl i64 %.72, 3
  %sunkaddr = select i1 %.552.prol, i64 %5, i64 0
  %6 = add i64 %5, -8
  %7 = add i64 %5, -16
  %8 = icmp sgt i64 %storemerge384, 0
  %9 = and i64 %storemerge384, 1
  %10 = icmp eq i64 %9, 0
  %sunkaddr9 = getelementptr inbounds i8, ptr %4, i64 %sunkaddr
  %11 = icmp eq i64 %notsub, 0
  br label %B156.if

B156.if:                                          ; preds = %B156.if.lr.ph, %B712
  %.262409427 = phi i64 [ 0, %B156.if.lr.ph ], [ %.269, %B712 ]
  %.269 = add nuw nsw i64 %.262409427, 1
  %12 = getelementptr double, ptr %arg.x.4, i64 %.262409427
  %.327 = load double, ptr %12, align 8
  %.328 = fcmp contract ogt double %.327, 8.000000e+00
  br i1 %.328, label %B196, label %B618.if

B294.if:                                          ; preds = %B294.if, %B294.if.preheader
  %lsr.iv2 = phi i64 [ %lsr.iv.next3, %B294.if ], [ %1, %B294.if.preheader ]
  %lsr.iv = phi i64 [ %lsr.iv.next, %B294.if ], [ %0, %B294.if.preheader ]
  %slope_two.2.1401 = phi double [ %.533, %B294.if ], [ 0.000000e+00, %B294.if.preheader ]
  %slope_one.2.1400 = phi double [ %.533.1, %B294.if ], [ %slope_one.2.1400.unr, %B294.if.preheader ]
  %two.2.1399 = phi double [ %.575, %B294.if ], [ 0.000000e+00, %B294.if.preheader ]
  %one.2.1398 = phi double [ %.575.1, %B294.if ], [ %one.2.1398.unr, %B294.if.preheader ]
  %13 = add i64 %lsr.iv2, -1
  %.526 = fmul contract double %one.2.1398, 2.000000e+00
  %.530 = fmul contract double %.528, %slope_one.2.1400
  %.531 = fadd contract double %.530, %.526
  %.533 = fsub contract double %.531, %slope_two.2.1401
  %.552 = icmp slt i64 %lsr.iv2, 0
  %14 = select i1 %.552, i64 %6, i64 -8
  %scevgep6 = getelementptr i8, ptr %3, i64 %14
  %15 = shl i64 %lsr.iv2, 3
  %scevgep7 = getelementptr i8, ptr %scevgep6, i64 %15
  %scevgep8 = getelementptr i8, ptr %scevgep7, i64 8
  %.568 = load double, ptr %scevgep8, align 8
  %.572 = fmul contract double %.528, %one.2.1398
  %.573 = fadd contract double %.572, %.568
  %.575 = fsub contract double %.573, %two.2.1399
  %.526.1 = fmul contract double %.575, 2.000000e+00
  %.530.1 = fmul contract double %.528, %.533
  %.531.1 = fadd contract double %.530.1, %.526.1
  %.533.1 = fsub contract double %.531.1, %slope_one.2.1400
  %.552.1 = icmp slt i64 %13, 0
  %16 = select i1 %.552.1, i64 %7, i64 -16
  %scevgep = getelementptr i8, ptr %3, i64 %16
  %scevgep4 = getelementptr i8, ptr %scevgep, i64 %15
  %scevgep5 = getelementptr i8, ptr %scevgep4, i64 8
  %.568.1 = load double, ptr %scevgep5, align 8
  %.572.1 = fmul contract double %.528, %.575
  %.573.1 = fadd contract double %.568.1, %.572.1
  %.575.1 = fsub contract double %.573.1, %one.2.1398
  %lsr.iv.next = add i64 %lsr.iv, -2
  %lsr.iv.next3 = add i64 %lsr.iv2, -2
  %.487.1 = icmp sgt i64 %lsr.iv.next, 2
  br i1 %.487.1, label %B294.if, label %B386

B618.if:                                          ; preds = %B156.if
  %.1000 = fmul contract double %.327, 0.000000e+00
  %.1001 = fadd contract double %.1000, 6.400000e+01
  %.1005 = fdiv contract double %.327, %.1001
  %.1000.1 = fmul contract double %.327, %.1005
  %.1001.1 = fadd contract double %.1000.1, 6.200000e+01
  %.1005.1 = fdiv contract double %.327, %.1001.1
  %.1000.2 = fmul contract double %.327, %.1005.1
  %.1001.2 = fadd contract double %.1000.2, 6.000000e+01
  %.1005.2 = fdiv contract double %.327, %.1001.2
  %.1000.3 = fmul contract double %.327, %.1005.2
  %.1001.3 = fadd contract double %.1000.3, 5.800000e+01
  %.1005.3 = fdiv contract double %.327, %.1001.3
  %.1000.13 = fmul contract double %.327, %.1005.3
  %.1001.14 = fadd contract double %.1000.13, 5.600000e+01
  %.1005.15 = fdiv contract double %.327, %.1001.14
  %.1000.1.1 = fmul contract double %.327, %.1005.15
  %.1001.1.1 = fadd contract double %.1000.1.1, 5.400000e+01
  %.1005.1.1 = fdiv contract double %.327, %.1001.1.1
  %.1000.2.1 = fmul contract double %.327, %.1005.1.1
  %.1001.2.1 = fadd contract double %.1000.2.1, 5.200000e+01
  %.1005.2.1 = fdiv contract double %.327, %.1001.2.1
  %.1000.3.1 = fmul contract double %.327, %.1005.2.1
  %.1001.3.1 = fadd contract double %.1000.3.1, 5.000000e+01
  %.1005.3.1 = fdiv contract double %.327, %.1001.3.1
  %.1000.28 = fmul contract double %.327, %.1005.3.1
  %.1001.29 = fadd contract double %.1000.28, 4.800000e+01
  %.1005.210 = fdiv contract double %.327, %.1001.29
  %.1000.1.2 = fmul contract double %.327, %.1005.210
  %.1001.1.2 = fadd contract double %.1000.1.2, 4.600000e+01
  %.1005.1.2 = fdiv contract double %.327, %.1001.1.2
  %.1000.2.2 = fmul contract double %.327, %.1005.1.2
  %.1001.2.2 = fadd contract double %.1000.2.2, 4.400000e+01
  %.1005.2.2 = fdiv contract double %.327, %.1001.2.2
  %.1000.3.2 = fmul contract double %.327, %.1005.2.2
  %.1001.3.2 = fadd contract double %.1000.3.2, 4.200000e+01
  %.1005.3.2 = fdiv contract double %.327, %.1001.3.2
  %.1000.313 = fmul contract double %.327, %.1005.3.2
  %.1001.314 = fadd contract double %.1000.313, 4.000000e+01
  %.1005.315 = fdiv contract double %.327, %.1001.314
  %.1000.1.3 = fmul contract double %.327, %.1005.315
  %.1001.1.3 = fadd contract double %.1000.1.3, 3.800000e+01
  %.1005.1.3 = fdiv contract double %.327, %.1001.1.3
  %.1000.2.3 = fmul contract double %.327, %.1005.1.3
  %.1001.2.3 = fadd contract double %.1000.2.3, 3.600000e+01
  %.1005.2.3 = fdiv contract double %.327, %.1001.2.3
  %.1000.3.3 = fmul contract double %.327, %.1005.2.3
  %.1001.3.3 = fadd contract double %.1000.3.3, 3.400000e+01
  %.1005.3.3 = fdiv contract double %.327, %.1001.3.3
  %.1000.4 = fmul contract double %.327, %.1005.3.3
  %.1001.4 = fadd contract double %.1000.4, 3.200000e+01
  %.1005.4 = fdiv contract double %.327, %.1001.4
  %.1000.1.4 = fmul contract double %.327, %.1005.4
  %.1001.1.4 = fadd contract double %.1000.1.4, 3.000000e+01
  %.1005.1.4 = fdiv contract double %.327, %.1001.1.4
  %.1000.2.4 = fmul contract double %.327, %.1005.1.4
  %.1001.2.4 = fadd contract double %.1000.2.4, 2.800000e+01
  %.1005.2.4 = fdiv contract double %.327, %.1001.2.4
  %.1000.3.4 = fmul contract double %.327, %.1005.2.4
  %.1001.3.4 = fadd contract double %.1000.3.4, 2.600000e+01
  %.1005.3.4 = fdiv contract double %.327, %.1001.3.4
  %.1000.5 = fmul contract double %.327, %.1005.3.4
  %.1001.5 = fadd contract double %.1000.5, 2.400000e+01
  %.1005.5 = fdiv contract double %.327, %.1001.5
  %.1000.1.5 = fmul contract double %.327, %.1005.5
  %.1001.1.5 = fadd contract double %.1000.1.5, 2.200000e+01
  %.1005.1.5 = fdiv contract double %.327, %.1001.1.5
  %.1000.2.5 = fmul contract double %.327, %.1005.1.5
  %.1001.2.5 = fadd contract double %.1000.2.5, 2.000000e+01
  %.1005.2.5 = fdiv contract double %.327, %.1001.2.5
  %.1000.3.5 = fmul contract double %.327, %.1005.2.5
  %.1001.3.5 = fadd contract double %.1000.3.5, 1.800000e+01
  %.1005.3.5 = fdiv contract double %.327, %.1001.3.5
  %.1000.6 = fmul contract double %.327, %.1005.3.5
  %.1001.6 = fadd contract double %.1000.6, 1.600000e+01
  %.1005.6 = fdiv contract double %.327, %.1001.6
  %.1000.1.6 = fmul contract double %.327, %.1005.6
  %.1001.1.6 = fadd contract double %.1000.1.6, 1.400000e+01
  %.1005.1.6 = fdiv contract double %.327, %.1001.1.6
  %.1000.2.6 = fmul contract double %.327, %.1005.1.6
  %.1001.2.6 = fadd contract double %.1000.2.6, 1.200000e+01
  %.1005.2.6 = fdiv contract double %.327, %.1001.2.6
  %.1000.3.6 = fmul contract double %.327, %.1005.2.6
  %.1001.3.6 = fadd contract double %.1000.3.6, 1.000000e+01
  %.1005.3.6 = fdiv contract double %.327, %.1001.3.6
  %.1000.7 = fmul contract double %.327, %.1005.3.6
  %.1001.7 = fadd contract double %.1000.7, 8.000000e+00
  %.1005.7 = fdiv contract double %.327, %.1001.7
  %.1000.1.7 = fmul contract double %.327, %.1005.7
  %.1001.1.7 = fadd contract double %.1000.1.7, 6.000000e+00
  %.1005.1.7 = fdiv contract double %.327, %.1001.1.7
  %.1000.2.7 = fmul contract double %.327, %.1005.1.7
  %.1001.2.7 = fadd contract double %.1000.2.7, 4.000000e+00
  %.1005.2.7 = fdiv contract double %.327, %.1001.2.7
  %.1000.3.7 = fmul contract double %.327, %.1005.2.7
  %.1001.3.7 = fadd contract double %.1000.3.7, 2.000000e+00
  %.1005.3.7 = fdiv contract double %.327, %.1001.3.7
  %17 = getelementptr double, ptr %arg.u.4, i64 %.262409427
  %.1043 = load double, ptr %17, align 8
  %.1045 = fmul contract double %.1005.3.7, %.1043
  store double %.1045, ptr %17, align 8
  br label %B712
}

; Function Attrs: mustprogress nocallback nocreateundeforpoison nofree nosync nounwind speculatable willreturn memory(none)
declare i64 @llvm.smax.i64(i64, i64) #2

; Function Attrs: mustprogress nocallback nocreateundeforpoison nofree nosync nounwind speculatable willreturn memory(none)
declare i64 @llvm.smin.i64(i64, i64) #2

; Function Attrs: nofree norecurse nosync nounwind memory(readwrite, inaccessiblemem: none, target_mem0: none, target_mem1: none)
define internal fastcc void @inner_1(ptr noalias nonnull writeonly captures(none) %retptr, ptr captures(none) %arg.waiting.4, i64 %arg.count, i64 range(i64 -9223372036854775807, -9223372036854775808) %arg.orders, ptr captures(none) %arg.terms.4, i64 range(i64 -9223372036854775808, 9223372036854775801) %arg.terms.5.0, ptr readonly captures(none) %arg.arguments.4, ptr readonly captures(none) %arg.prior.4, ptr captures(none) %arg.so_far.4) unnamed_addr #0 {
entry:
  %.854 = alloca ptr, align 8
  store ptr null, ptr %.854, align 8
  %.93 = icmp eq i64 %arg.count, 0
  br i1 %.93, label %common.ret.sink.split, label %B20

common.ret.sink.split:                            ; preds = %entry, %B362
  store ptr null, ptr %retptr, align 8
  ret void

B20:                                              ; preds = %entry
  %.130 = sub i64 0, %arg.count
  %.138.1 = and i64 %.130, -8
  %.172 = sub i64 0, %.138.1
  %.336 = sub i64 %.172, %arg.count
  %..336 = tail call i64 @llvm.smax.i64(i64 %.336, i64 0)
  %.388.prol = add nsw i64 %..336, -1
  %.392.prol = add i64 %arg.count, 1
  %0 = icmp slt i64 %.336, 1
  %1 = and i64 %..336, 1
  %2 = icmp eq i64 %1, 0
  %3 = icmp eq i64 %.336, 1
  br label %B90.if

B90.loopexit:                                     ; preds = %B126.if, %B126.if.prol.loopexit, %B90.if
  %lsr.iv.next49 = add nuw nsw i64 %lsr.iv48, 32
  %exitcond.not = icmp eq i64 %.270, 17
  br i1 %exitcond.not, label %B210, label %B90.if

B210:                                             ; preds = %B90.loopexit
  %.73.i = getelementptr i8, ptr %arg.arguments.4, i64 80
  %.74.i = load i64, ptr %.73.i, align 8, !noalias !89
  %.153.i = getelementptr i8, ptr %arg.arguments.4, i64 64
  %.154.i = load i64, ptr %.153.i, align 8, !noalias !89
  %.204.i = mul nsw i64 %.154.i, 6
  %.286.i = getelementptr i8, ptr %arg.prior.4, i64 56
  %.287.i = load double, ptr %.286.i, align 8, !noalias !89
  %.315.i = getelementptr i8, ptr %arg.prior.4, i64 64
  %.316.i = load double, ptr %.315.i, align 8, !noalias !89
  %.320.i = fdiv contract double 1.000000e+00, %.316.i
  %.349.i = load double, ptr %arg.prior.4, align 8, !noalias !89
  %.4422551.not.i = icmp slt i64 %.172, 1
  br i1 %.4422551.not.i, label %_ZN17bnserve_inference15marginal_kernel7_circle9_togetherB4v134B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit, label %B344.if.lr.ph.i

B360.i:                                           ; preds = %B344.if.i
  %4 = shl i64 %lsr.iv1927.i, 3
  %scevgep1947.i = getelementptr i8, ptr %arg.waiting.4, i64 %4
  %scevgep1948.i = getelementptr i8, ptr %scevgep1947.i, i64 -3840
  %.519714.i = load i64, ptr %scevgep1948.i, align 8, !noalias !89
  %.521.i = add nsw i64 %.519714.i, -4604544271217802189
  %.522.i = ashr i64 %.521.i, 52
  %.523.i = and i64 %.521.i, -4503599627370496
  %.524.i = sub nsw i64 %.519714.i, %.523.i
  %.525.i = bitcast i64 %.524.i to double
  %.526.i = fadd contract double %.525.i, -1.000000e+00
  %.527.i = fadd contract double %.526.i, 2.000000e+00
  %.531.i = fdiv contract double %.526.i, %.527.i
  %.532.i = fmul contract double %.531.i, %.531.i
  %.533.i = fmul contract double %.532.i, %.532.i
  %.534.i = fmul contract double %.533.i, 0x3FC39A09D078C69F
  %.535.i = fadd contract double %.534.i, 0x3FCC71C51D8E78AF
  %.536.i = fmul contract double %.533.i, %.535.i
  %.537.i = fadd contract double %.536.i, 0x3FD999999997FA04
  %.538.i = fmul contract double %.533.i, %.537.i
  %.539.i = fmul contract double %.533.i, 0x3FC2F112DF3E5244
  %.540.i = fadd contract double %.539.i, 0x3FC7466496CB03DE
  %.541.i = fmul contract double %.533.i, %.540.i
  %.542.i = fadd contract double %.541.i, 0x3FD2492494229359
  %.543.i = fmul contract double %.533.i, %.542.i
  %.544.i = fadd contract double %.543.i, 0x3FE5555555555593
  %.545.i = fmul contract double %.532.i, %.544.i
  %.546.i = fadd contract double %.538.i, %.545.i
  %.547.i = fmul contract double %.526.i, 5.000000e-01
  %.548.i = fmul contract double %.526.i, %.547.i
  %.549.i = add nsw i64 %.522.i, 4843621399236968448
  %.550.i = bitcast i64 %.549.i to double
  %.551.i = fadd contract double %.550.i, 0xC338000000000000
  %.552.i = fmul contract double %.551.i, 0x3FE62E42FEE00000
  %.553.i = fadd contract double %.548.i, %.546.i
  %.554.i = fmul contract double %.531.i, %.553.i
  %.555.i = fmul contract double %.551.i, 0x3DEA39EF35793C76
  %.556.i = fadd contract double %.555.i, %.554.i
  %.557.i = fsub contract double %.548.i, %.556.i
  %.558.i = fsub contract double %.557.i, %.526.i
  %.559.i = fsub contract double %.552.i, %.558.i
  %.560.i = fneg contract double %.559.i
  %.562.i = fsub contract double %.560.i, %.287.i
  %.564.i = fmul contract double %.320.i, %.562.i
  %.567.i = fadd contract double %.564.i, -5.000000e-01
  %.568.i = fadd contract double %.567.i, 0x4338000000000000
  %.569.i = bitcast double %.568.i to i64
  %5 = tail call i64 @llvm.smax.i64(i64 %.569.i, i64 4843621399236968448)
  %nearest_cell_v140__vphi100_0.2.2.i = add nsw i64 %5, -4843621399236968448
  %nearest_cell_v140__vphi120_0.2.2.i = tail call i64 @llvm.smin.i64(i64 %nearest_cell_v140__vphi100_0.2.2.i, i64 %.574.i)
  %scevgep20.i = getelementptr i8, ptr %scevgep1947.i, i64 -1536
  %.659.i = sitofp i64 %nearest_cell_v140__vphi120_0.2.2.i to double
  store double %.659.i, ptr %scevgep20.i, align 8, !noalias !89
  %6 = add i64 %lsr.iv1927.i, -160
  %.794.i = icmp slt i64 %nearest_cell_v140__vphi120_0.2.2.i, 0
  %.795.i = select i1 %.794.i, i64 %.204.i, i64 0
  %.idx.i = mul i64 %nearest_cell_v140__vphi120_0.2.2.i, 48
  %7 = getelementptr i8, ptr %33, i64 %.idx.i
  %.809.i = getelementptr double, ptr %7, i64 %.795.i
  %.810.i = load double, ptr %.809.i, align 8, !noalias !89
  %.828.i = icmp slt i64 %6, 0
  %8 = select i1 %.828.i, i64 4352, i64 0
  %scevgep1942.i = getelementptr i8, ptr %arg.waiting.4, i64 %8
  %scevgep15.i = getelementptr i8, ptr %scevgep1942.i, i64 %4
  %scevgep16.i = getelementptr i8, ptr %scevgep15.i, i64 -1280
  store double %.810.i, ptr %scevgep16.i, align 8, !noalias !89
  %9 = getelementptr i8, ptr %7, i64 8
  %.809.1.i = getelementptr double, ptr %9, i64 %.795.i
  %.810.1.i = load double, ptr %.809.1.i, align 8, !noalias !89
  %10 = add i64 %lsr.iv1927.i, -128
  %.828.1.i = icmp slt i64 %10, 0
  %11 = select i1 %.828.1.i, i64 4352, i64 0
  %scevgep1939.i = getelementptr i8, ptr %arg.waiting.4, i64 %11
  %scevgep13.i = getelementptr i8, ptr %scevgep1939.i, i64 %4
  %scevgep14.i = getelementptr i8, ptr %scevgep13.i, i64 -1024
  store double %.810.1.i, ptr %scevgep14.i, align 8, !noalias !89
  %12 = getelementptr i8, ptr %7, i64 16
  %.809.2.i = getelementptr double, ptr %12, i64 %.795.i
  %.810.2.i = load double, ptr %.809.2.i, align 8, !noalias !89
  %13 = add i64 %lsr.iv1927.i, -96
  %.828.2.i = icmp slt i64 %13, 0
  %14 = select i1 %.828.2.i, i64 4352, i64 0
  %scevgep1936.i = getelementptr i8, ptr %arg.waiting.4, i64 %14
  %scevgep11.i = getelementptr i8, ptr %scevgep1936.i, i64 %4
  %scevgep12.i = getelementptr i8, ptr %scevgep11.i, i64 -768
  store double %.810.2.i, ptr %scevgep12.i, align 8, !noalias !89
  %15 = getelementptr i8, ptr %7, i64 24
  %.809.3.i = getelementptr double, ptr %15, i64 %.795.i
  %.810.3.i = load double, ptr %.809.3.i, align 8, !noalias !89
  %16 = add i64 %lsr.iv1927.i, -64
  %.828.3.i = icmp slt i64 %16, 0
  %17 = select i1 %.828.3.i, i64 4352, i64 0
  %scevgep1933.i = getelementptr i8, ptr %arg.waiting.4, i64 %17
  %scevgep9.i = getelementptr i8, ptr %scevgep1933.i, i64 %4
  %scevgep10.i = getelementptr i8, ptr %scevgep9.i, i64 -512
  store double %.810.3.i, ptr %scevgep10.i, align 8, !noalias !89
  %18 = getelementptr i8, ptr %7, i64 32
  %.809.4.i = getelementptr double, ptr %18, i64 %.795.i
  %.810.4.i = load double, ptr %.809.4.i, align 8, !noalias !89
  %19 = add i64 %lsr.iv1927.i, -32
  %.828.4.i = icmp slt i64 %19, 0
  %20 = select i1 %.828.4.i, i64 4352, i64 0
  %scevgep1930.i = getelementptr i8, ptr %arg.waiting.4, i64 %20
  %scevgep2.i = getelementptr i8, ptr %scevgep1930.i, i64 %4
  %scevgep8.i = getelementptr i8, ptr %scevgep2.i, i64 -256
  store double %.810.4.i, ptr %scevgep8.i, align 8, !noalias !89
  %21 = getelementptr i8, ptr %7, i64 40
  %.809.5.i = getelementptr double, ptr %21, i64 %.795.i
  %.810.5.i = load double, ptr %.809.5.i, align 8, !noalias !89
  %.828.5.i = icmp slt i64 %lsr.iv1927.i, 0
  %22 = select i1 %.828.5.i, i64 4352, i64 0
  %scevgep.i = getelementptr i8, ptr %arg.waiting.4, i64 %22
  %scevgep1.i = getelementptr i8, ptr %scevgep.i, i64 %4
  store double %.810.5.i, ptr %scevgep1.i, align 8, !noalias !89
  br label %B1594.i

B1594.i:                                          ; preds = %B344.if.i, %B360.i
  %lsr.iv.next1928.i = add nuw i64 %lsr.iv1927.i, 1
  %23 = add i64 %lsr.iv.next1928.i, %.138.1
  %exitcond.i = icmp eq i64 %23, 512
  br i1 %exitcond.i, label %B1910.i, label %B344.if.i

B1910.i:                                          ; preds = %B1594.i
  %.2256.i = insertelement <8 x double> poison, double %.320.i, i64 0
  %.2257.i = shufflevector <8 x double> %.2256.i, <8 x double> poison, <8 x i32> zeroinitializer
  %24 = sub i64 0, %.138.1
  %.925.i = lshr exact i64 %24, 3
  %.94526821833.i = add nsw i64 %.925.i, -1
  %.6.i1878.i = insertelement <8 x double> poison, double %.349.i, i64 0
  %.7.i.i = shufflevector <8 x double> %.6.i1878.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.6.i1880.i = insertelement <8 x double> poison, double %.287.i, i64 0
  %.7.i1881.i = shufflevector <8 x double> %.6.i1880.i, <8 x double> poison, <8 x i32> zeroinitializer
  %25 = inttoptr i64 %.74.i to ptr
  br label %B1926.i

B1926.i:                                          ; preds = %B4204.i, %B1910.i
  %.936.sroa.0.01836.i = phi i64 [ 0, %B1910.i ], [ %.936.sroa.0.0.i, %B4204.i ]
  %.94526821835.i = phi i64 [ %.94526821833.i, %B1910.i ], [ %.9452682.i, %B4204.i ]
  %.95227491834.i = phi i64 [ 8, %B1910.i ], [ %.9522749.i, %B4204.i ]
  %26 = getelementptr double, ptr %arg.waiting.4, i64 %.936.sroa.0.01836.i
  %.997.i = getelementptr i8, ptr %26, i64 256
  %.999.i = load <8 x double>, ptr %.997.i, align 8, !noalias !89
  %.1010.i = getelementptr i8, ptr %26, i64 512
  %.1012.i = load <8 x double>, ptr %.1010.i, align 8, !noalias !89
  %.1029.i = getelementptr i8, ptr %26, i64 2560
  %.1031.i = load <8 x double>, ptr %.1029.i, align 8, !noalias !89
  %.1042.i = getelementptr i8, ptr %26, i64 2816
  %.1044.i = load <8 x double>, ptr %.1042.i, align 8, !noalias !89
  %.1056.i = getelementptr i8, ptr %26, i64 3072
  %.1058.i = load <8 x double>, ptr %.1056.i, align 8, !noalias !89
  %.1079.i = getelementptr i8, ptr %26, i64 3328
  %.1081.i = load <8 x double>, ptr %.1079.i, align 8, !noalias !89
  %.1093.i = getelementptr i8, ptr %26, i64 3584
  %.1095.i = load <8 x double>, ptr %.1093.i, align 8, !noalias !89
  %.1113.i = getelementptr i8, ptr %26, i64 3840
  %.1115.i = load <8 x double>, ptr %.1113.i, align 8, !noalias !89
  %.1127.i = getelementptr i8, ptr %26, i64 4096
  %.1129.i = load <8 x double>, ptr %.1127.i, align 8, !noalias !89
  %.8.i1883.i = fsub contract <8 x double> zeroinitializer, %.1031.i
  br label %B2464.i

B2464.i:                                          ; preds = %B4184.i, %B1926.i
  %lsr.iv2.i = phi i64 [ %math.i, %B4184.i ], [ -8, %B1926.i ]
  %.1249.sroa.0.01829.i = phi i64 [ %.1249.sroa.0.0.i, %B4184.i ], [ 0, %B1926.i ]
  %top.3.11826.i = phi <8 x double> [ %top.2.2.i, %B4184.i ], [ zeroinitializer, %B1926.i ]
  %squares.2.11825.i = phi <8 x double> [ %.2892.i, %B4184.i ], [ zeroinitializer, %B1926.i ]
  %firsts.2.11824.i = phi <8 x double> [ %.2862.i, %B4184.i ], [ zeroinitializer, %B1926.i ]
  %factor.2.11823.i = phi <8 x double> [ %.6.i1904.i, %B4184.i ], [ zeroinitializer, %B1926.i ]
  %.1308.i = getelementptr inbounds double, ptr %25, i64 %.1249.sroa.0.01829.i
  %.1309.i = load double, ptr %.1308.i, align 8, !noalias !89
  %.1312.i = insertelement <8 x double> poison, double %.1309.i, i64 0
  %.1313.i = shufflevector <8 x double> %.1312.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1314.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1012.i, <8 x double> %.1313.i, <8 x double> %.999.i)
  %.1320.i = bitcast <8 x double> %.1314.i to <8 x i64>
  %.8.i.i = add <8 x i64> %.1320.i, splat (i64 -4604544271217802189)
  %.8.i1845.i = ashr <8 x i64> %.8.i.i, splat (i64 52)
  %.8.i1846.i = and <8 x i64> %.8.i.i, splat (i64 -4503599627370496)
  %.6.i1847.i = sub <8 x i64> %.1320.i, %.8.i1846.i
  %27 = bitcast <8 x i64> %.6.i1847.i to <8 x double>
  %.8.i1848.i = fadd contract <8 x double> %27, splat (double -1.000000e+00)
  %.8.i1849.i = fadd contract <8 x double> %.8.i1848.i, splat (double 2.000000e+00)
  %.6.i1850.i = fdiv contract <8 x double> %.8.i1848.i, %.8.i1849.i
  %.6.i1851.i = fmul contract <8 x double> %.6.i1850.i, %.6.i1850.i
  %.6.i1852.i = fmul contract <8 x double> %.6.i1851.i, %.6.i1851.i
  %.8.i1853.i = fmul contract <8 x double> %.6.i1852.i, splat (double 0x3FC39A09D078C69F)
  %.8.i1854.i = fadd contract <8 x double> %.8.i1853.i, splat (double 0x3FCC71C51D8E78AF)
  %.6.i1855.i = fmul contract <8 x double> %.6.i1852.i, %.8.i1854.i
  %.8.i1856.i = fadd contract <8 x double> %.6.i1855.i, splat (double 0x3FD999999997FA04)
  %.6.i1857.i = fmul contract <8 x double> %.6.i1852.i, %.8.i1856.i
  %.8.i1858.i = fmul contract <8 x double> %.6.i1852.i, splat (double 0x3FC2F112DF3E5244)
  %.8.i1859.i = fadd contract <8 x double> %.8.i1858.i, splat (double 0x3FC7466496CB03DE)
  %.6.i1860.i = fmul contract <8 x double> %.6.i1852.i, %.8.i1859.i
  %.8.i1861.i = fadd contract <8 x double> %.6.i1860.i, splat (double 0x3FD2492494229359)
  %.6.i1862.i = fmul contract <8 x double> %.6.i1852.i, %.8.i1861.i
  %.8.i1863.i = fadd contract <8 x double> %.6.i1862.i, splat (double 0x3FE5555555555593)
  %.6.i1864.i = fmul contract <8 x double> %.6.i1851.i, %.8.i1863.i
  %.6.i1865.i = fadd contract <8 x double> %.6.i1857.i, %.6.i1864.i
  %.8.i1866.i = fmul contract <8 x double> %.8.i1848.i, splat (double 5.000000e-01)
  %.6.i1867.i = fmul contract <8 x double> %.8.i1848.i, %.8.i1866.i
  %.8.i1868.i = add nsw <8 x i64> %.8.i1845.i, splat (i64 4843621399236968448)
  %28 = bitcast <8 x i64> %.8.i1868.i to <8 x double>
  %.8.i1869.i = fadd contract <8 x double> %28, splat (double 0xC338000000000000)
  %.8.i1870.i = fmul contract <8 x double> %.8.i1869.i, splat (double 0x3FE62E42FEE00000)
  %.6.i1871.i = fadd contract <8 x double> %.6.i1867.i, %.6.i1865.i
  %.6.i1872.i = fmul contract <8 x double> %.6.i1850.i, %.6.i1871.i
  %.8.i1873.i = fmul contract <8 x double> %.8.i1869.i, splat (double 0x3DEA39EF35793C76)
  %.6.i1874.i = fadd contract <8 x double> %.8.i1873.i, %.6.i1872.i
  %.6.i1875.i = fsub contract <8 x double> %.6.i1867.i, %.6.i1874.i
  %.6.i1876.i = fsub contract <8 x double> %.6.i1875.i, %.8.i1848.i
  %.6.i1877.i = fsub contract <8 x double> %.8.i1870.i, %.6.i1876.i
  %.8.i1879.i = fmul contract <8 x double> %.7.i.i, %.6.i1877.i
  br i1 %32, label %B4180.i, label %B4184.i

B4180.i:                                          ; preds = %B2464.i
  %.8.i1838.i = fsub contract <8 x double> zeroinitializer, %.6.i1877.i
  %.8.i1882.i = fsub contract <8 x double> %.8.i1838.i, %.7.i1881.i
  %.2258.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i1882.i, <8 x double> %.2257.i, <8 x double> %.8.i1883.i)
  %.8.i1884.i = fadd contract <8 x double> %.2258.i, splat (double -1.000000e+00)
  %.8.i1885.i = fsub contract <8 x double> zeroinitializer, %.8.i1884.i
  %.2311.i = tail call <8 x double> @llvm.minnum.v8f64(<8 x double> %.8.i1885.i, <8 x double> splat (double -0.000000e+00))
  %.8.i1886.i = fsub contract <8 x double> zeroinitializer, %.2311.i
  %.8.i1888.i = fadd contract <8 x double> %.2258.i, zeroinitializer
  %.2388.i = tail call <8 x double> @llvm.minnum.v8f64(<8 x double> %.8.i1888.i, <8 x double> splat (double -0.000000e+00))
  %.8.i1889.i = fsub contract <8 x double> zeroinitializer, %.2388.i
  %.2415.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1095.i, <8 x double> %.2258.i, <8 x double> %.1081.i)
  %.2417.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.2415.i, <8 x double> %.2258.i, <8 x double> %.1058.i)
  %.2419.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.2417.i, <8 x double> %.2258.i, <8 x double> %.1044.i)
  %.6.i1890.i = fadd contract <8 x double> %.8.i1879.i, %.2419.i
  %.6.i1891.i = fmul contract <8 x double> %.1115.i, %.8.i1886.i
  %.6.i1892.i = fmul contract <8 x double> %.8.i1886.i, %.8.i1886.i
  %.6.i1893.i = fmul contract <8 x double> %.1129.i, %.8.i1889.i
  %.6.i1894.i = fmul contract <8 x double> %.8.i1889.i, %.8.i1889.i
  %.2545.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i1893.i, <8 x double> %.6.i1894.i, <8 x double> %.6.i1890.i)
  %.2546.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i1891.i, <8 x double> %.6.i1892.i, <8 x double> %.2545.i)
  br label %B4184.i

B4184.i:                                          ; preds = %B4180.i, %B2464.i
  %beside.3.2.i = phi <8 x double> [ %.2546.i, %B4180.i ], [ %.8.i1879.i, %B2464.i ]
  %.2561.i = icmp eq i64 %.1249.sroa.0.01829.i, 0
  %top.2.2.i = select i1 %.2561.i, <8 x double> %beside.3.2.i, <8 x double> %top.3.11826.i
  %sunkaddr1949.i = shl i64 %.1249.sroa.0.01829.i, 3
  %sunkaddr1950.i = getelementptr i8, ptr %25, i64 %sunkaddr1949.i
  %sunkaddr1951.i = getelementptr i8, ptr %sunkaddr1950.i, i64 64
  %.2582.i = load double, ptr %sunkaddr1951.i, align 8, !noalias !89
  %.6.i.i = fsub contract <8 x double> %beside.3.2.i, %top.2.2.i
  %.2618.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i, <8 x double> splat (double 0x3FF71547652B82FE), <8 x double> splat (double 0x4338000000000000))
  %.8.i1895.i = fadd contract <8 x double> %.2618.i, splat (double 0xC338000000000000)
  %.2647.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i1895.i, <8 x double> splat (double 0xBFE62E42FEFA39EF), <8 x double> %.6.i.i)
  %.2650.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i1895.i, <8 x double> splat (double 0xBC7ABC9E3B39803F), <8 x double> %.2647.i)
  %.2655.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.2650.i, <8 x double> splat (double 0x3DE6124613A86D09), <8 x double> splat (double 0x3E21EED8EFF8D898))
  %.2658.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.2650.i, <8 x double> %.2655.i, <8 x double> splat (double 0x3E5AE64567F544E4))
  %.2661.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.2650.i, <8 x double> %.2658.i, <8 x double> splat (double 0x3E927E4FB7789F5C))
  %.2664.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.2650.i, <8 x double> %.2661.i, <8 x double> splat (double 0x3EC71DE3A556C734))
  %.2667.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.2650.i, <8 x double> %.2664.i, <8 x double> splat (double 0x3EFA01A01A01A01A))
  %.2670.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.2650.i, <8 x double> %.2667.i, <8 x double> splat (double 0x3F2A01A01A01A01A))
  %.2673.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.2650.i, <8 x double> %.2670.i, <8 x double> splat (double 0x3F56C16C16C16C17))
  %.2676.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.2650.i, <8 x double> %.2673.i, <8 x double> splat (double 0x3F81111111111111))
  %.2679.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.2650.i, <8 x double> %.2676.i, <8 x double> splat (double 0x3FA5555555555555))
  %.2682.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.2650.i, <8 x double> %.2679.i, <8 x double> splat (double 0x3FC5555555555555))
  %.2685.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.2650.i, <8 x double> %.2682.i, <8 x double> splat (double 5.000000e-01))
  %.6.i1896.i = fmul contract <8 x double> %.2650.i, %.2650.i
  %.8.i1897.i = fadd contract <8 x double> %.2650.i, splat (double 1.000000e+00)
  %.2734.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i1896.i, <8 x double> %.2685.i, <8 x double> %.8.i1897.i)
  %.2735.i = bitcast <8 x double> %.2618.i to <8 x i64>
  %.8.i1898.i = shl <8 x i64> %.2735.i, splat (i64 52)
  %.8.i1899.i = add <8 x i64> %.8.i1898.i, splat (i64 4607182418800017408)
  %29 = bitcast <8 x i64> %.8.i1899.i to <8 x double>
  %.6.i1900.i = fmul contract <8 x double> %.2734.i, %29
  %.6.i1901.i = insertelement <8 x double> poison, double %.2582.i, i64 0
  %.7.i1902.i = shufflevector <8 x double> %.6.i1901.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.8.i1903.i = fmul contract <8 x double> %.7.i1902.i, %.6.i1900.i
  %.6.i1904.i = fadd contract <8 x double> %factor.2.11823.i, %.8.i1903.i
  %.6.i1905.i = fmul contract <8 x double> %.1314.i, %.8.i1903.i
  %.2862.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i1903.i, <8 x double> %.1314.i, <8 x double> %firsts.2.11824.i)
  %.2892.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i1905.i, <8 x double> %.1314.i, <8 x double> %squares.2.11825.i)
  %30 = tail call { i64, i1 } @llvm.uadd.with.overflow.i64(i64 %lsr.iv2.i, i64 1)
  %math.i = extractvalue { i64, i1 } %30, 0
  %ov.i = extractvalue { i64, i1 } %30, 1
  %31 = add nsw i64 %lsr.iv2.i, 9
  %.1249.sroa.0.0.i = select i1 %ov.i, i64 0, i64 %31
  br i1 %ov.i, label %B4204.i, label %B2464.i

B4204.i:                                          ; preds = %B4184.i
  %sunkaddr1952.i = shl i64 %.936.sroa.0.01836.i, 3
  %sunkaddr1953.i = getelementptr i8, ptr %arg.waiting.4, i64 %sunkaddr1952.i
  %.2931.i = load <8 x double>, ptr %sunkaddr1953.i, align 8, !noalias !89
  %.8.i1839.i = fmul contract <8 x double> %.2931.i, splat (double 5.000000e-01)
  %.6.i1906.i = fmul contract <8 x double> %.999.i, %.8.i1839.i
  %.6.i1907.i = fadd contract <8 x double> %top.2.2.i, %.6.i1906.i
  %sunkaddr1956.i = getelementptr i8, ptr %sunkaddr1953.i, i64 2304
  store <8 x double> %.6.i1907.i, ptr %sunkaddr1956.i, align 8, !noalias !89
  %.6.i1908.i = fmul contract <8 x double> %.1012.i, %.6.i1904.i
  %sunkaddr1959.i = getelementptr i8, ptr %sunkaddr1953.i, i64 1536
  store <8 x double> %.6.i1908.i, ptr %sunkaddr1959.i, align 8, !noalias !89
  %.6.i1909.i = fmul contract <8 x double> %.1012.i, %.2862.i
  %sunkaddr1962.i = getelementptr i8, ptr %sunkaddr1953.i, i64 1792
  store <8 x double> %.6.i1909.i, ptr %sunkaddr1962.i, align 8, !noalias !89
  %.6.i1910.i = fmul contract <8 x double> %.1012.i, %.2892.i
  %sunkaddr1965.i = getelementptr i8, ptr %sunkaddr1953.i, i64 2048
  store <8 x double> %.6.i1910.i, ptr %sunkaddr1965.i, align 8, !noalias !89
  %.946.i = icmp sgt i64 %.94526821835.i, 0
  %.959.i = add i64 %.95227491834.i, 8
  %.9522749.i = select i1 %.946.i, i64 %.959.i, i64 %.95227491834.i
  %.955.i = sext i1 %.946.i to i64
  %.9452682.i = add nsw i64 %.94526821835.i, %.955.i
  %.936.sroa.0.0.i = select i1 %.946.i, i64 %.95227491834.i, i64 0
  br i1 %.946.i, label %B1926.i, label %_ZN17bnserve_inference15marginal_kernel7_circle9_togetherB4v134B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit

B344.if.lr.ph.i:                                  ; preds = %B210
  %.198.i = getelementptr i8, ptr %arg.arguments.4, i64 72
  %.199.i = load i64, ptr %.198.i, align 8, !noalias !89
  %.574.i = add nsw i64 %.154.i, -1
  %32 = icmp sgt i64 %.154.i, 0
  %33 = inttoptr i64 %.199.i to ptr
  br label %B344.if.i

B344.if.i:                                        ; preds = %B344.if.lr.ph.i, %B1594.i
  %lsr.iv1927.i = phi i64 [ 512, %B344.if.lr.ph.i ], [ %lsr.iv.next1928.i, %B1594.i ]
  br i1 %32, label %B360.i, label %B1594.i

_ZN17bnserve_inference15marginal_kernel7_circle9_togetherB4v134B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit: ; preds = %B4204.i, %B210
  br i1 %0, label %B362, label %B322.if.preheader

B322.if.1:                                        ; preds = %B322.if.1.preheader, %B322.if.1
  %lsr.iv24 = phi i64 [ %63, %B322.if.1.preheader ], [ %lsr.iv.next25, %B322.if.1 ]
  %.730350352.1 = phi i64 [ %arg.count, %B322.if.1.preheader ], [ %.737.1, %B322.if.1 ]
  %.737.1 = add i64 %.730350352.1, 1
  %.778.1 = icmp slt i64 %.730350352.1, -224
  %34 = select i1 %.778.1, i64 4352, i64 0
  %35 = shl i64 %.730350352.1, 3
  %scevgep5 = getelementptr i8, ptr %scevgep, i64 %34
  %scevgep6 = getelementptr i8, ptr %scevgep5, i64 %35
  store double 0.000000e+00, ptr %scevgep6, align 8
  %lsr.iv.next25 = add i64 %lsr.iv24, -1
  %.724.1 = icmp sgt i64 %lsr.iv.next25, 1
  br i1 %.724.1, label %B322.if.1, label %B322.if.2.preheader

B322.if.2.preheader:                              ; preds = %B322.if.1
  %scevgep2 = getelementptr i8, ptr %arg.waiting.4, i64 2048
  br label %B322.if.2

B322.if.2:                                        ; preds = %B322.if.2, %B322.if.2.preheader
  %lsr.iv = phi i64 [ %lsr.iv.next, %B322.if.2 ], [ %63, %B322.if.2.preheader ]
  %.730350352.2 = phi i64 [ %.737.2, %B322.if.2 ], [ %arg.count, %B322.if.2.preheader ]
  %.737.2 = add i64 %.730350352.2, 1
  %.778.2 = icmp slt i64 %.730350352.2, -256
  %36 = select i1 %.778.2, i64 4352, i64 0
  %37 = shl i64 %.730350352.2, 3
  %scevgep3 = getelementptr i8, ptr %scevgep2, i64 %36
  %scevgep4 = getelementptr i8, ptr %scevgep3, i64 %37
  store double 0.000000e+00, ptr %scevgep4, align 8
  %lsr.iv.next = add i64 %lsr.iv, -1
  %.724.2 = icmp sgt i64 %lsr.iv.next, 1
  br i1 %.724.2, label %B322.if.2, label %B362

B362:                                             ; preds = %B322.if.2, %_ZN17bnserve_inference15marginal_kernel7_circle9_togetherB4v134B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit
  %.841 = getelementptr i8, ptr %arg.arguments.4, i64 184
  %.842 = load i64, ptr %.841, align 8
  %.848 = icmp ne i64 %.842, 0
  store ptr null, ptr %.854, align 8
  %.862 = zext i1 %.848 to i8
  call fastcc void @inner_2(ptr nonnull %.854, ptr %arg.waiting.4, i64 %.172, i64 %arg.orders, ptr %arg.terms.4, i64 %arg.terms.5.0, i8 %.862, ptr %arg.so_far.4)
  br label %common.ret.sink.split

B90.if:                                           ; preds = %B90.loopexit, %B20
  %lsr.iv48 = phi i64 [ 1, %B20 ], [ %lsr.iv.next49, %B90.loopexit ]
  %.263337343 = phi i64 [ 0, %B20 ], [ %.270, %B90.loopexit ]
  %.270 = add nuw nsw i64 %.263337343, 1
  br i1 %0, label %B90.loopexit, label %B126.if.lr.ph

B126.if.lr.ph:                                    ; preds = %B90.if
  %.418 = shl nsw i64 %.263337343, 5
  %.420 = add nsw i64 %.418, %arg.count
  %.435.inv = icmp sgt i64 %.420, 0
  %.436 = select i1 %.435.inv, i64 0, i64 544
  %38 = getelementptr double, ptr %arg.waiting.4, i64 %.420
  br i1 %2, label %B126.if.prol.loopexit, label %B126.if.prol

B126.if.prol:                                     ; preds = %B126.if.lr.ph
  %sunkaddr19 = shl nuw nsw i64 %.436, 3
  %sunkaddr20 = getelementptr i8, ptr %38, i64 %sunkaddr19
  %sunkaddr21 = getelementptr i8, ptr %sunkaddr20, i64 -8
  %.451.prol = load double, ptr %sunkaddr21, align 8
  %.468.prol = icmp slt i64 %.420, 0
  %.469.prol = select i1 %.468.prol, i64 544, i64 0
  %.483.prol = getelementptr double, ptr %38, i64 %.469.prol
  store double %.451.prol, ptr %.483.prol, align 8
  br label %B126.if.prol.loopexit

B126.if.prol.loopexit:                            ; preds = %B126.if.prol, %B126.if.lr.ph
  %.378330334.unr = phi i64 [ %..336, %B126.if.lr.ph ], [ %.388.prol, %B126.if.prol ]
  %.385331333.unr = phi i64 [ %arg.count, %B126.if.lr.ph ], [ %.392.prol, %B126.if.prol ]
  br i1 %3, label %B90.loopexit, label %B126.if.lr.ph.new

B126.if.lr.ph.new:                                ; preds = %B126.if.prol.loopexit
  %39 = add i64 %.378330334.unr, 2
  %40 = add i64 %.385331333.unr, %lsr.iv48
  %sunkaddr11 = shl nuw nsw i64 %.436, 3
  %sunkaddr12 = getelementptr i8, ptr %38, i64 %sunkaddr11
  %sunkaddr13 = getelementptr i8, ptr %sunkaddr12, i64 -8
  br label %B126.if

B126.if:                                          ; preds = %B126.if, %B126.if.lr.ph.new
  %lsr.iv50 = phi i64 [ %lsr.iv.next51, %B126.if ], [ %40, %B126.if.lr.ph.new ]
  %lsr.iv46 = phi i64 [ %lsr.iv.next47, %B126.if ], [ %39, %B126.if.lr.ph.new ]
  %.451 = load double, ptr %sunkaddr13, align 8
  %41 = add i64 %lsr.iv50, -1
  %.468 = icmp slt i64 %41, 0
  %42 = shl i64 %lsr.iv50, 3
  %43 = select i1 %.468, i64 4344, i64 -8
  %scevgep17 = getelementptr i8, ptr %arg.waiting.4, i64 %43
  %scevgep18 = getelementptr i8, ptr %scevgep17, i64 %42
  store double %.451, ptr %scevgep18, align 8
  %.451.1 = load double, ptr %sunkaddr13, align 8
  %.468.1 = icmp slt i64 %lsr.iv50, 0
  %44 = select i1 %.468.1, i64 4352, i64 0
  %scevgep52 = getelementptr i8, ptr %arg.waiting.4, i64 %44
  %scevgep10 = getelementptr i8, ptr %scevgep52, i64 %42
  store double %.451.1, ptr %scevgep10, align 8
  %lsr.iv.next47 = add i64 %lsr.iv46, -2
  %lsr.iv.next51 = add i64 %lsr.iv50, 2
  %.379.1 = icmp sgt i64 %lsr.iv.next47, 2
  br i1 %.379.1, label %B126.if, label %B90.loopexit

B322.if.preheader:                                ; preds = %_ZN17bnserve_inference15marginal_kernel7_circle9_togetherB4v134B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit
  %xtraiter1 = and i64 %..336, 3
  %lcmp.mod2.not = icmp eq i64 %xtraiter1, 0
  br i1 %lcmp.mod2.not, label %B322.if.prol.loopexit, label %B322.if.prol.preheader

B322.if.prol.preheader:                           ; preds = %B322.if.preheader
  %45 = shl i64 %arg.count, 3
  %46 = getelementptr i8, ptr %arg.waiting.4, i64 %45
  %scevgep43 = getelementptr i8, ptr %46, i64 1536
  br label %B322.if.prol

B322.if.prol:                                     ; preds = %B322.if.prol, %B322.if.prol.preheader
  %prol.iter = phi i64 [ %prol.iter.next, %B322.if.prol ], [ 0, %B322.if.prol.preheader ]
  %47 = add i64 %prol.iter, %arg.count
  %.778.prol = icmp slt i64 %47, -192
  %48 = select i1 %.778.prol, i64 4352, i64 0
  %scevgep44 = getelementptr i8, ptr %scevgep43, i64 %48
  %49 = shl nuw nsw i64 %prol.iter, 3
  %scevgep9 = getelementptr i8, ptr %scevgep44, i64 %49
  store double 0.000000e+00, ptr %scevgep9, align 8
  %prol.iter.next = add nuw nsw i64 %prol.iter, 1
  %prol.iter.cmp.not = icmp eq i64 %xtraiter1, %prol.iter.next
  br i1 %prol.iter.cmp.not, label %B322.if.prol.loopexit.loopexit, label %B322.if.prol, !llvm.loop !92

B322.if.prol.loopexit.loopexit:                   ; preds = %B322.if.prol
  %50 = sub nsw i64 %..336, %prol.iter.next
  %51 = add i64 %prol.iter.next, %arg.count
  br label %B322.if.prol.loopexit

B322.if.prol.loopexit:                            ; preds = %B322.if.prol.loopexit.loopexit, %B322.if.preheader
  %.723349353.unr = phi i64 [ %..336, %B322.if.preheader ], [ %50, %B322.if.prol.loopexit.loopexit ]
  %.730350352.unr = phi i64 [ %arg.count, %B322.if.preheader ], [ %51, %B322.if.prol.loopexit.loopexit ]
  %52 = icmp slt i64 %.336, 4
  br i1 %52, label %B322.if.1.preheader, label %B322.if.preheader21

B322.if.preheader21:                              ; preds = %B322.if.prol.loopexit
  %53 = add i64 %.723349353.unr, 4
  %54 = shl i64 %.730350352.unr, 3
  %scevgep1 = getelementptr i8, ptr %arg.waiting.4, i64 %54
  br label %B322.if

B322.if:                                          ; preds = %B322.if, %B322.if.preheader21
  %lsr.iv2 = phi ptr [ %scevgep19, %B322.if ], [ %scevgep1, %B322.if.preheader21 ]
  %lsr.iv29 = phi i64 [ %lsr.iv.next30, %B322.if ], [ %53, %B322.if.preheader21 ]
  %.730350352 = phi i64 [ %62, %B322.if ], [ %.730350352.unr, %B322.if.preheader21 ]
  %.778 = icmp slt i64 %.730350352, -192
  %55 = select i1 %.778, i64 5888, i64 1536
  %scevgep23 = getelementptr i8, ptr %lsr.iv2, i64 %55
  store double 0.000000e+00, ptr %scevgep23, align 8
  %56 = add i64 %.730350352, 1
  %.778.17 = icmp slt i64 %56, -192
  %57 = select i1 %.778.17, i64 5896, i64 1544
  %scevgep22 = getelementptr i8, ptr %lsr.iv2, i64 %57
  store double 0.000000e+00, ptr %scevgep22, align 8
  %58 = add i64 %.730350352, 2
  %.778.216 = icmp slt i64 %58, -192
  %59 = select i1 %.778.216, i64 5904, i64 1552
  %scevgep21 = getelementptr i8, ptr %lsr.iv2, i64 %59
  store double 0.000000e+00, ptr %scevgep21, align 8
  %60 = add i64 %.730350352, 3
  %.778.3 = icmp slt i64 %60, -192
  %61 = select i1 %.778.3, i64 5912, i64 1560
  %scevgep20 = getelementptr i8, ptr %lsr.iv2, i64 %61
  store double 0.000000e+00, ptr %scevgep20, align 8
  %lsr.iv.next30 = add i64 %lsr.iv29, -4
  %scevgep19 = getelementptr i8, ptr %lsr.iv2, i64 32
  %.724.3 = icmp sgt i64 %lsr.iv.next30, 4
  %62 = add i64 %.730350352, 4
  br i1 %.724.3, label %B322.if, label %B322.if.1.preheader

B322.if.1.preheader:                              ; preds = %B322.if, %B322.if.prol.loopexit
  %63 = add nuw i64 %..336, 1
  %scevgep = getelementptr i8, ptr %arg.waiting.4, i64 1792
  br label %B322.if.1
}

; Function Attrs: mustprogress nocallback nocreateundeforpoison nofree nosync nounwind speculatable willreturn memory(none)
declare <8 x double> @llvm.fma.v8f64(<8 x double>, <8 x double>, <8 x double>) #2

; Function Attrs: mustprogress nocallback nocreateundeforpoison nofree nosync nounwind speculatable willreturn memory(none)
declare <8 x double> @llvm.fabs.v8f64(<8 x double>) #2

; Function Attrs: mustprogress nocallback nocreateundeforpoison nofree nosync nounwind speculatable willreturn memory(none)
declare <8 x double> @llvm.minnum.v8f64(<8 x double>, <8 x double>) #2

; Function Attrs: mustprogress nocallback nocreateundeforpoison nofree nosync nounwind speculatable willreturn memory(none)
declare <8 x double> @llvm.sqrt.v8f64(<8 x double>) #2

; Function Attrs: nofree norecurse nosync nounwind memory(argmem: readwrite)
define internal fastcc void @inner_2(ptr noalias nonnull writeonly captures(none) %retptr, ptr captures(none) %arg.waiting.4, i64 range(i64 8, 1) %arg.count, i64 range(i64 -9223372036854775807, -9223372036854775808) %arg.orders, ptr captures(none) %arg.terms.4, i64 range(i64 -9223372036854775808, 9223372036854775801) %arg.terms.5.0, i8 range(i8 0, 2) %arg.differentiated, ptr captures(none) %arg.so_far.4) unnamed_addr #4 {
entry:
  %.311 = load double, ptr %arg.so_far.4, align 8
  %.353 = icmp sgt i64 %arg.count, 0
  br i1 %.353, label %B230.if.preheader, label %B1420

B230.if.preheader:                                ; preds = %entry
  %unroll_iter = and i64 %arg.count, 9223372036854775804
  br label %B230.if

B280.unr-lcssa:                                   ; preds = %B230.if
  %xtraiter = and i64 %arg.count, 3
  %lcmp.mod.not = icmp eq i64 %xtraiter, 0
  br i1 %lcmp.mod.not, label %B280, label %B230.if.epil.preheader

B230.if.epil.preheader:                           ; preds = %B280.unr-lcssa
  %0 = shl i64 %unroll_iter, 3
  %1 = getelementptr i8, ptr %arg.waiting.4, i64 %0
  %scevgep136 = getelementptr i8, ptr %1, i64 2304
  br label %B230.if.epil

B230.if.epil:                                     ; preds = %B230.if.epil, %B230.if.epil.preheader
  %top.2.01345.epil = phi double [ %.466.top.2.0.epil, %B230.if.epil ], [ %.466.top.2.0.3, %B230.if.epil.preheader ]
  %epil.iter = phi i64 [ %epil.iter.next, %B230.if.epil ], [ 0, %B230.if.epil.preheader ]
  %2 = shl i64 %epil.iter, 3
  %scevgep34 = getelementptr i8, ptr %scevgep136, i64 %2
  %.466.epil = load double, ptr %scevgep34, align 8
  %.468.epil = fcmp contract ogt double %.466.epil, %top.2.01345.epil
  %.466.top.2.0.epil = select i1 %.468.epil, double %.466.epil, double %top.2.01345.epil
  %epil.iter.next = add nuw nsw i64 %epil.iter, 1
  %epil.iter.cmp.not = icmp eq i64 %xtraiter, %epil.iter.next
  br i1 %epil.iter.cmp.not, label %B280, label %B230.if.epil, !llvm.loop !93

B280:                                             ; preds = %B230.if.epil, %B280.unr-lcssa
  %.466.top.2.0.lcssa = phi double [ %.466.top.2.0.3, %B280.unr-lcssa ], [ %.466.top.2.0.epil, %B230.if.epil ]
  %.558 = fcmp contract ogt double %.466.top.2.0.lcssa, %.311
  br i1 %.558, label %B304, label %B604.if.preheader

B304:                                             ; preds = %B280
  %3 = icmp eq i8 %arg.differentiated, 0
  %.592 = fsub contract double %.311, %.466.top.2.0.lcssa
  %.598 = fcmp contract ogt double %.592, -7.000000e+02
  %.592. = select i1 %.598, double %.592, double -7.000000e+02
  %.615 = tail call contract double @llvm.fma.f64(double %.592., double 0x3FF71547652B82FE, double 0x4338000000000000)
  %.616 = fadd contract double %.615, 0xC338000000000000
  %.619 = tail call contract double @llvm.fma.f64(double %.616, double 0xBFE62E42FEFA39EF, double %.592.)
  %.620 = tail call contract double @llvm.fma.f64(double %.616, double 0xBC7ABC9E3B39803F, double %.619)
  %.621 = tail call contract double @llvm.fma.f64(double %.620, double 0x3DE6124613A86D09, double 0x3E21EED8EFF8D898)
  %.622 = tail call contract double @llvm.fma.f64(double %.620, double %.621, double 0x3E5AE64567F544E4)
  %.623 = tail call contract double @llvm.fma.f64(double %.620, double %.622, double 0x3E927E4FB7789F5C)
  %.624 = tail call contract double @llvm.fma.f64(double %.620, double %.623, double 0x3EC71DE3A556C734)
  %.625 = tail call contract double @llvm.fma.f64(double %.620, double %.624, double 0x3EFA01A01A01A01A)
  %.626 = tail call contract double @llvm.fma.f64(double %.620, double %.625, double 0x3F2A01A01A01A01A)
  %.627 = tail call contract double @llvm.fma.f64(double %.620, double %.626, double 0x3F56C16C16C16C17)
  %.628 = tail call contract double @llvm.fma.f64(double %.620, double %.627, double 0x3F81111111111111)
  %.629 = tail call contract double @llvm.fma.f64(double %.620, double %.628, double 0x3FA5555555555555)
  %.630 = tail call contract double @llvm.fma.f64(double %.620, double %.629, double 0x3FC5555555555555)
  %.631 = tail call contract double @llvm.fma.f64(double %.620, double %.630, double 5.000000e-01)
  %.632 = fmul contract double %.620, %.620
  %.633 = fadd contract double %.620, 1.000000e+00
  %.634 = tail call contract double @llvm.fma.f64(double %.632, double %.631, double %.633)
  %.635 = bitcast double %.615 to i64
  %.636 = shl i64 %.635, 52
  %.637 = add i64 %.636, 4607182418800017408
  %.638 = bitcast i64 %.637 to double
  %.639 = fmul contract double %.634, %.638
  store double %.466.top.2.0.lcssa, ptr %arg.so_far.4, align 8
  %.702 = getelementptr i8, ptr %arg.so_far.4, i64 8
  %.703 = load double, ptr %.702, align 8
  %.705 = fmul contract double %.639, %.703
  store double %.705, ptr %.702, align 8
  %.778 = shl i64 %arg.orders, 2
  %.8211350.not = icmp slt i64 %.778, 1
  %or.cond = select i1 %3, i1 true, i1 %.8211350.not
  br i1 %or.cond, label %B604.if.preheader, label %B510.if.preheader

B510.if.preheader:                                ; preds = %B304
  %4 = shl i64 %arg.terms.5.0, 3
  %5 = add nuw i64 %.778, 4
  %scevgep28 = getelementptr i8, ptr %arg.terms.4, i64 8
  br label %B510.if

B1420.loopexit.unr-lcssa:                         ; preds = %B1002.if
  br i1 %lcmp.mod.not, label %B1420, label %B1002.if.epil.preheader

B1002.if.epil.preheader:                          ; preds = %B1420.loopexit.unr-lcssa
  %6 = shl i64 %unroll_iter, 3
  %7 = getelementptr i8, ptr %arg.waiting.4, i64 %6
  %scevgep111 = getelementptr i8, ptr %7, i64 1536
  br label %B1002.if.epil

B1002.if.epil:                                    ; preds = %B1002.if.epil, %B1002.if.epil.preheader
  %total.2.01367.epil = phi double [ %.1358.epil, %B1002.if.epil ], [ %.1358.3, %B1002.if.epil.preheader ]
  %epil.iter98 = phi i64 [ %epil.iter98.next, %B1002.if.epil ], [ 0, %B1002.if.epil.preheader ]
  %8 = shl i64 %epil.iter98, 3
  %scevgep4 = getelementptr i8, ptr %scevgep111, i64 %8
  %scevgep5 = getelementptr i8, ptr %scevgep4, i64 -256
  %.1325.epil = load double, ptr %scevgep5, align 8
  %.1355.epil = load double, ptr %scevgep4, align 8
  %.1356.epil = fmul contract double %.1325.epil, %.1355.epil
  %.1358.epil = fadd contract double %total.2.01367.epil, %.1356.epil
  %epil.iter98.next = add nuw nsw i64 %epil.iter98, 1
  %epil.iter98.cmp.not = icmp eq i64 %xtraiter, %epil.iter98.next
  br i1 %epil.iter98.cmp.not, label %B1420, label %B1002.if.epil, !llvm.loop !94

B1420:                                            ; preds = %B1002.if.epil, %B1420.loopexit.unr-lcssa, %entry
  %total.2.0.lcssa = phi double [ 0.000000e+00, %entry ], [ %.1358.3, %B1420.loopexit.unr-lcssa ], [ %.1358.epil, %B1002.if.epil ]
  %9 = icmp eq i8 %arg.differentiated, 0
  %.1399 = getelementptr i8, ptr %arg.so_far.4, i64 8
  %.1400 = load double, ptr %.1399, align 8
  %.1402 = fadd contract double %total.2.0.lcssa, %.1400
  store double %.1402, ptr %.1399, align 8
  %.18231386.not = icmp slt i64 %arg.count, 1
  %or.cond1 = or i1 %.18231386.not, %9
  br i1 %or.cond1, label %common.ret, label %B1426.if.lr.ph

B1426.loopexit:                                   ; preds = %B4272.if, %B1426.if
  %exitcond1396.not = icmp eq i64 %.1836, %arg.count
  br i1 %exitcond1396.not, label %common.ret, label %B1426.if

common.ret:                                       ; preds = %B1426.loopexit, %B1420
  store ptr null, ptr %retptr, align 8
  ret void

B230.if:                                          ; preds = %B230.if, %B230.if.preheader
  %top.2.01345 = phi double [ %.311, %B230.if.preheader ], [ %.466.top.2.0.3, %B230.if ]
  %.40113411343 = phi i64 [ 0, %B230.if.preheader ], [ %.408.3, %B230.if ]
  %sunkaddr40 = shl i64 %.40113411343, 3
  %sunkaddr41 = getelementptr i8, ptr %arg.waiting.4, i64 %sunkaddr40
  %sunkaddr42 = getelementptr i8, ptr %sunkaddr41, i64 2304
  %.466 = load double, ptr %sunkaddr42, align 8
  %.468 = fcmp contract ogt double %.466, %top.2.01345
  %.466.top.2.0 = select i1 %.468, double %.466, double %top.2.01345
  %sunkaddr44 = getelementptr i8, ptr %sunkaddr41, i64 2312
  %.466.1 = load double, ptr %sunkaddr44, align 8
  %.468.1 = fcmp contract ogt double %.466.1, %.466.top.2.0
  %.466.top.2.0.1 = select i1 %.468.1, double %.466.1, double %.466.top.2.0
  %sunkaddr47 = getelementptr i8, ptr %sunkaddr41, i64 2320
  %.466.2 = load double, ptr %sunkaddr47, align 8
  %.468.2 = fcmp contract ogt double %.466.2, %.466.top.2.0.1
  %.466.top.2.0.2 = select i1 %.468.2, double %.466.2, double %.466.top.2.0.1
  %.408.3 = add nuw nsw i64 %.40113411343, 4
  %sunkaddr50 = getelementptr i8, ptr %sunkaddr41, i64 2328
  %.466.3 = load double, ptr %sunkaddr50, align 8
  %.468.3 = fcmp contract ogt double %.466.3, %.466.top.2.0.2
  %.466.top.2.0.3 = select i1 %.468.3, double %.466.3, double %.466.top.2.0.2
  %niter.ncmp.3 = icmp eq i64 %unroll_iter, %.408.3
  br i1 %niter.ncmp.3, label %B280.unr-lcssa, label %B230.if

B510.if:                                          ; preds = %B510.if, %B510.if.preheader
  %lsr.iv26 = phi i64 [ %lsr.iv.next27, %B510.if ], [ %5, %B510.if.preheader ]
  %.82713491351 = phi i64 [ %.834.1, %B510.if ], [ %.778, %B510.if.preheader ]
  %.872 = icmp slt i64 %.82713491351, 0
  %10 = select i1 %.872, i64 %4, i64 0
  %11 = shl i64 %.82713491351, 3
  %scevgep31 = getelementptr i8, ptr %scevgep28, i64 %10
  %scevgep32 = getelementptr i8, ptr %scevgep31, i64 %11
  %scevgep33 = getelementptr i8, ptr %scevgep32, i64 -8
  %.888 = load double, ptr %scevgep33, align 8
  %.890 = fmul contract double %.639, %.888
  store double %.890, ptr %scevgep33, align 8
  %.834.1 = add i64 %.82713491351, 2
  %.888.1 = load double, ptr %scevgep32, align 8
  %.890.1 = fmul contract double %.639, %.888.1
  store double %.890.1, ptr %scevgep32, align 8
  %lsr.iv.next27 = add i64 %lsr.iv26, -2
  %.821.1 = icmp sgt i64 %lsr.iv.next27, 4
  br i1 %.821.1, label %B510.if, label %B604.if.preheader

B604.if.preheader:                                ; preds = %B510.if, %B304, %B280
  br label %B604.if

B604.if:                                          ; preds = %B604.if.preheader, %B604.if
  %.101413561358 = phi i64 [ %.1021, %B604.if ], [ 0, %B604.if.preheader ]
  %.1021 = add nuw nsw i64 %.101413561358, 1
  %sunkaddr51 = shl i64 %.101413561358, 3
  %sunkaddr52 = getelementptr i8, ptr %arg.waiting.4, i64 %sunkaddr51
  %sunkaddr53 = getelementptr i8, ptr %sunkaddr52, i64 2304
  %.1080 = load double, ptr %sunkaddr53, align 8
  %.1082 = fsub contract double %.1080, %.466.top.2.0.lcssa
  %.1088 = fcmp contract ogt double %.1082, -7.000000e+02
  %.1082. = select i1 %.1088, double %.1082, double -7.000000e+02
  %.1105 = tail call contract double @llvm.fma.f64(double %.1082., double 0x3FF71547652B82FE, double 0x4338000000000000)
  %.1106 = fadd contract double %.1105, 0xC338000000000000
  %.1109 = tail call contract double @llvm.fma.f64(double %.1106, double 0xBFE62E42FEFA39EF, double %.1082.)
  %.1110 = tail call contract double @llvm.fma.f64(double %.1106, double 0xBC7ABC9E3B39803F, double %.1109)
  %.1111 = tail call contract double @llvm.fma.f64(double %.1110, double 0x3DE6124613A86D09, double 0x3E21EED8EFF8D898)
  %.1112 = tail call contract double @llvm.fma.f64(double %.1110, double %.1111, double 0x3E5AE64567F544E4)
  %.1113 = tail call contract double @llvm.fma.f64(double %.1110, double %.1112, double 0x3E927E4FB7789F5C)
  %.1114 = tail call contract double @llvm.fma.f64(double %.1110, double %.1113, double 0x3EC71DE3A556C734)
  %.1115 = tail call contract double @llvm.fma.f64(double %.1110, double %.1114, double 0x3EFA01A01A01A01A)
  %.1116 = tail call contract double @llvm.fma.f64(double %.1110, double %.1115, double 0x3F2A01A01A01A01A)
  %.1117 = tail call contract double @llvm.fma.f64(double %.1110, double %.1116, double 0x3F56C16C16C16C17)
  %.1118 = tail call contract double @llvm.fma.f64(double %.1110, double %.1117, double 0x3F81111111111111)
  %.1119 = tail call contract double @llvm.fma.f64(double %.1110, double %.1118, double 0x3FA5555555555555)
  %.1120 = tail call contract double @llvm.fma.f64(double %.1110, double %.1119, double 0x3FC5555555555555)
  %.1121 = tail call contract double @llvm.fma.f64(double %.1110, double %.1120, double 5.000000e-01)
  %.1122 = fmul contract double %.1110, %.1110
  %.1123 = fadd contract double %.1110, 1.000000e+00
  %.1124 = tail call contract double @llvm.fma.f64(double %.1122, double %.1121, double %.1123)
  %.1125 = bitcast double %.1105 to i64
  %.1126 = shl i64 %.1125, 52
  %.1127 = add i64 %.1126, 4607182418800017408
  %.1128 = bitcast i64 %.1127 to double
  %.1129 = fmul contract double %.1124, %.1128
  %sunkaddr56 = getelementptr i8, ptr %sunkaddr52, i64 1280
  store double %.1129, ptr %sunkaddr56, align 8
  %exitcond1393.not = icmp eq i64 %arg.count, %.1021
  br i1 %exitcond1393.not, label %B1002.if, label %B604.if

B1002.if:                                         ; preds = %B604.if, %B1002.if
  %total.2.01367 = phi double [ %.1358.3, %B1002.if ], [ 0.000000e+00, %B604.if ]
  %.126413631365 = phi i64 [ %.1271.3, %B1002.if ], [ 0, %B604.if ]
  %sunkaddr57 = shl i64 %.126413631365, 3
  %sunkaddr58 = getelementptr i8, ptr %arg.waiting.4, i64 %sunkaddr57
  %sunkaddr59 = getelementptr i8, ptr %sunkaddr58, i64 1280
  %.1325 = load double, ptr %sunkaddr59, align 8
  %sunkaddr63 = getelementptr i8, ptr %sunkaddr58, i64 1536
  %.1355 = load double, ptr %sunkaddr63, align 8
  %.1356 = fmul contract double %.1325, %.1355
  %.1358 = fadd contract double %total.2.01367, %.1356
  %sunkaddr66 = getelementptr i8, ptr %sunkaddr58, i64 1288
  %.1325.1 = load double, ptr %sunkaddr66, align 8
  %sunkaddr69 = getelementptr i8, ptr %sunkaddr58, i64 1544
  %.1355.1 = load double, ptr %sunkaddr69, align 8
  %.1356.1 = fmul contract double %.1325.1, %.1355.1
  %.1358.1 = fadd contract double %.1358, %.1356.1
  %sunkaddr72 = getelementptr i8, ptr %sunkaddr58, i64 1296
  %.1325.2 = load double, ptr %sunkaddr72, align 8
  %sunkaddr75 = getelementptr i8, ptr %sunkaddr58, i64 1552
  %.1355.2 = load double, ptr %sunkaddr75, align 8
  %.1356.2 = fmul contract double %.1325.2, %.1355.2
  %.1358.2 = fadd contract double %.1358.1, %.1356.2
  %.1271.3 = add nuw i64 %.126413631365, 4
  %sunkaddr78 = getelementptr i8, ptr %sunkaddr58, i64 1304
  %.1325.3 = load double, ptr %sunkaddr78, align 8
  %sunkaddr81 = getelementptr i8, ptr %sunkaddr58, i64 1560
  %.1355.3 = load double, ptr %sunkaddr81, align 8
  %.1356.3 = fmul contract double %.1325.3, %.1355.3
  %.1358.3 = fadd contract double %.1358.2, %.1356.3
  %niter103.ncmp.3 = icmp eq i64 %unroll_iter, %.1271.3
  br i1 %niter103.ncmp.3, label %B1420.loopexit.unr-lcssa, label %B1002.if

B1426.if.lr.ph:                                   ; preds = %B1420
  %.idx = shl i64 %arg.orders, 5
  %.idx1397 = mul i64 %arg.orders, 40
  %.idx1398 = mul i64 %arg.orders, 48
  %.idx1399 = mul i64 %arg.orders, 56
  %scevgep = getelementptr i8, ptr %arg.terms.4, i64 %.idx1399
  %scevgep105 = getelementptr i8, ptr %arg.terms.4, i64 %.idx1398
  %scevgep107 = getelementptr i8, ptr %arg.terms.4, i64 %.idx1397
  %scevgep109 = getelementptr i8, ptr %arg.terms.4, i64 %.idx
  %12 = icmp slt i64 %arg.orders, 1
  br label %B1426.if

B1426.if:                                         ; preds = %B1426.if.lr.ph, %B1426.loopexit
  %.182913811387 = phi i64 [ 0, %B1426.if.lr.ph ], [ %.1836, %B1426.loopexit ]
  %.1836 = add nuw nsw i64 %.182913811387, 1
  br i1 %12, label %B1426.loopexit, label %B4272.if.preheader

B4272.if.preheader:                               ; preds = %B1426.if
  %sunkaddr82 = shl i64 %.182913811387, 3
  %sunkaddr83 = getelementptr i8, ptr %arg.waiting.4, i64 %sunkaddr82
  %sunkaddr84 = getelementptr i8, ptr %sunkaddr83, i64 1280
  %sunkaddr87 = getelementptr i8, ptr %sunkaddr83, i64 1792
  %sunkaddr90 = getelementptr i8, ptr %sunkaddr83, i64 2048
  %sunkaddr95 = getelementptr i8, ptr %sunkaddr83, i64 768
  %sunkaddr98 = getelementptr i8, ptr %sunkaddr83, i64 1024
  br label %B4272.if

B4272.if:                                         ; preds = %B4272.if.preheader, %B4272.if
  %imaginary.2.11377 = phi double [ %.2649, %B4272.if ], [ 0.000000e+00, %B4272.if.preheader ]
  %real.2.11376 = phi double [ %.2582, %B4272.if ], [ 1.000000e+00, %B4272.if.preheader ]
  %.196813721374 = phi i64 [ %.1975, %B4272.if ], [ 0, %B4272.if.preheader ]
  %.1975 = add nuw nsw i64 %.196813721374, 1
  %13 = shl i64 %.196813721374, 3
  %scevgep110 = getelementptr i8, ptr %scevgep109, i64 %13
  %.2032 = load double, ptr %scevgep110, align 8
  %.2063 = load double, ptr %sunkaddr84, align 8
  %.2094 = load double, ptr %sunkaddr87, align 8
  %.2095 = fmul contract double %.2063, %.2094
  %.2097 = fmul contract double %real.2.11376, %.2095
  %.2098 = fadd contract double %.2032, %.2097
  store double %.2098, ptr %scevgep110, align 8
  %scevgep3 = getelementptr i8, ptr %scevgep107, i64 %13
  %.2161 = load double, ptr %scevgep3, align 8
  %.2192 = load double, ptr %sunkaddr84, align 8
  %.2223 = load double, ptr %sunkaddr87, align 8
  %.2224 = fmul contract double %.2192, %.2223
  %.2226 = fmul contract double %imaginary.2.11377, %.2224
  %.2227 = fadd contract double %.2161, %.2226
  store double %.2227, ptr %scevgep3, align 8
  %scevgep2 = getelementptr i8, ptr %scevgep105, i64 %13
  %.2290 = load double, ptr %scevgep2, align 8
  %.2321 = load double, ptr %sunkaddr84, align 8
  %.2352 = load double, ptr %sunkaddr90, align 8
  %.2353 = fmul contract double %.2321, %.2352
  %.2355 = fmul contract double %real.2.11376, %.2353
  %.2356 = fadd contract double %.2290, %.2355
  store double %.2356, ptr %scevgep2, align 8
  %scevgep1 = getelementptr i8, ptr %scevgep, i64 %13
  %.2419 = load double, ptr %scevgep1, align 8
  %.2450 = load double, ptr %sunkaddr84, align 8
  %.2481 = load double, ptr %sunkaddr90, align 8
  %.2482 = fmul contract double %.2450, %.2481
  %.2484 = fmul contract double %imaginary.2.11377, %.2482
  %.2485 = fadd contract double %.2419, %.2484
  store double %.2485, ptr %scevgep1, align 8
  %.2546 = load double, ptr %sunkaddr95, align 8
  %.2548 = fmul contract double %real.2.11376, %.2546
  %.2579 = load double, ptr %sunkaddr98, align 8
  %.2581 = fmul contract double %imaginary.2.11377, %.2579
  %.2582 = fsub contract double %.2548, %.2581
  %.2615 = fmul contract double %real.2.11376, %.2579
  %.2648 = fmul contract double %imaginary.2.11377, %.2546
  %.2649 = fadd contract double %.2648, %.2615
  %exitcond1395.not = icmp eq i64 %arg.orders, %.1975
  br i1 %exitcond1395.not, label %B1426.loopexit, label %B4272.if
}

; Function Attrs: mustprogress nocallback nocreateundeforpoison nofree nosync nounwind speculatable willreturn memory(none)
declare double @llvm.ceil.f64(double) #2

; Function Attrs: mustprogress nocallback nocreateundeforpoison nofree nosync nounwind speculatable willreturn memory(none)
declare { i64, i1 } @llvm.uadd.with.overflow.i64(i64, i64) #2

; Function Attrs: nocallback nofree nosync nounwind willreturn memory(argmem: readwrite)
declare void @llvm.lifetime.start.p0(ptr captures(none)) #5

; Function Attrs: nocallback nofree nosync nounwind willreturn memory(argmem: readwrite)
declare void @llvm.lifetime.end.p0(ptr captures(none)) #5

; Function Attrs: nocallback nocreateundeforpoison nofree nosync nounwind speculatable willreturn memory(none)
declare double @llvm.fabs.f64(double) #6

attributes #0 = { nofree norecurse nosync nounwind memory(readwrite, inaccessiblemem: none, target_mem0: none, target_mem1: none) }
attributes #1 = { mustprogress nocallback nofree nounwind willreturn memory(argmem: write) }
attributes #2 = { mustprogress nocallback nocreateundeforpoison nofree nosync nounwind speculatable willreturn memory(none) }
attributes #3 = { nofree norecurse nosync nounwind memory(read, argmem: readwrite, inaccessiblemem: none, target_mem0: none, target_mem1: none) }
attributes #4 = { nofree norecurse nosync nounwind memory(argmem: readwrite) }
attributes #5 = { nocallback nofree nosync nounwind willreturn memory(argmem: readwrite) }
attributes #6 = { nocallback nocreateundeforpoison nofree nosync nounwind speculatable willreturn memory(none) }

!0 = !{!1}
!1 = distinct !{!1, !2, !"_ZN17bnserve_inference15marginal_kernel7_source9integrateB2v3B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIxLi1E1C7mutable7alignedE: %retptr"}
!2 = distinct !{!2, !"_ZN17bnserve_inference15marginal_kernel7_source9integrateB2v3B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIxLi1E1C7mutable7alignedE"}
!3 = !{!4, !1}
!4 = distinct !{!4, !5, !"_ZN17bnserve_inference15marginal_kernel7_circle11over_circleB2v7B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!5 = distinct !{!5, !"_ZN17bnserve_inference15marginal_kernel7_circle11over_circleB2v7B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!6 = !{!7, !4, !1}
!7 = distinct !{!7, !8, !"_ZN17bnserve_inference15marginal_kernel7_circle10_integrateB3v19B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedEx8UniTupleIdLi3EEd5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!8 = distinct !{!8, !"_ZN17bnserve_inference15marginal_kernel7_circle10_integrateB3v19B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedEx8UniTupleIdLi3EEd5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!9 = !{!10, !7, !4, !1}
!10 = distinct !{!10, !11, !"_ZN17bnserve_inference15marginal_kernel7_circle7_surveyB3v29B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedExx8UniTupleIdLi3EEd5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!11 = distinct !{!11, !"_ZN17bnserve_inference15marginal_kernel7_circle7_surveyB3v29B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedExx8UniTupleIdLi3EEd5ArrayIdLi1E1C7mutable7alignedE"}
!12 = distinct !{!12, !13}
!13 = !{!"llvm.loop.unroll.disable"}
!14 = !{!15, !10, !7, !4, !1}
!15 = distinct !{!15, !16, !"_ZN17bnserve_inference15marginal_kernel7_circle10_at_phasesB3v30B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedExd8UniTupleIdLi3EEdd: %retptr"}
!16 = distinct !{!16, !"_ZN17bnserve_inference15marginal_kernel7_circle10_at_phasesB3v30B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedExd8UniTupleIdLi3EEdd"}
!17 = !{!18, !10, !7, !4, !1}
!18 = distinct !{!18, !19, !"_ZN17bnserve_inference15marginal_kernel7_circle10_at_phasesB3v30B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedExd8UniTupleIdLi3EEdd: %retptr"}
!19 = distinct !{!19, !"_ZN17bnserve_inference15marginal_kernel7_circle10_at_phasesB3v30B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedExd8UniTupleIdLi3EEdd"}
!20 = distinct !{!20, !13}
!21 = !{!22, !7, !4, !1}
!22 = distinct !{!22, !23, !"_ZN17bnserve_inference15marginal_kernel7_circle7_halvedB3v57B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedEdx5ArrayIdLi1E1C7mutable7alignedEx: %retptr"}
!23 = distinct !{!23, !"_ZN17bnserve_inference15marginal_kernel7_circle7_halvedB3v57B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedEdx5ArrayIdLi1E1C7mutable7alignedEx"}
!24 = !{!25, !7, !4, !1}
!25 = distinct !{!25, !26, !"_ZN17bnserve_inference15marginal_kernel7_circle7_finishB4v162B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedEx28Literal_5bbool_5d_28False_29x5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!26 = distinct !{!26, !"_ZN17bnserve_inference15marginal_kernel7_circle7_finishB4v162B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedEx28Literal_5bbool_5d_28False_29x5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!27 = !{!28, !7, !4, !1}
!28 = distinct !{!28, !29, !"_ZN17bnserve_inference15marginal_kernel7_circle7_finishB4v162B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedEx28Literal_5bbool_5d_28False_29x5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!29 = distinct !{!29, !"_ZN17bnserve_inference15marginal_kernel7_circle7_finishB4v162B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedEx28Literal_5bbool_5d_28False_29x5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!30 = distinct !{!30, !13}
!31 = distinct !{!31, !13}
!32 = !{!33, !7, !4, !1}
!33 = distinct !{!33, !34, !"_ZN17bnserve_inference15marginal_kernel7_circle10_at_phasesB3v30B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedExd8UniTupleIdLi3EEdd: %retptr"}
!34 = distinct !{!34, !"_ZN17bnserve_inference15marginal_kernel7_circle10_at_phasesB3v30B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedExd8UniTupleIdLi3EEdd"}
!35 = !{!36, !1}
!36 = distinct !{!36, !37, !"_ZN17bnserve_inference15marginal_kernel7_source8_at_onceB4v168B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!37 = distinct !{!37, !"_ZN17bnserve_inference15marginal_kernel7_source8_at_onceB4v168B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!38 = !{!39}
!39 = distinct !{!39, !40, !"_ZN17bnserve_inference15marginal_kernel9_distance9_as_it_isB3v75B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEdd5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!40 = distinct !{!40, !"_ZN17bnserve_inference15marginal_kernel9_distance9_as_it_isB3v75B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEdd5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!41 = !{!42}
!42 = distinct !{!42, !43, !"_ZN17bnserve_inference15marginal_kernel9_distance8_by_ruleB3v92B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEdddd27Literal_5bbool_5d_28True_295ArrayIdLi1E1C7mutable7alignedE23Literal_5bint_5d_288_295ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!43 = distinct !{!43, !"_ZN17bnserve_inference15marginal_kernel9_distance8_by_ruleB3v92B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEdddd27Literal_5bbool_5d_28True_295ArrayIdLi1E1C7mutable7alignedE23Literal_5bint_5d_288_295ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!44 = !{!45, !42}
!45 = distinct !{!45, !46, !"_ZN17bnserve_inference15marginal_kernel9_distance10_add_tableB4v101B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!46 = distinct !{!46, !"_ZN17bnserve_inference15marginal_kernel9_distance10_add_tableB4v101B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE"}
!47 = !{!48, !42}
!48 = distinct !{!48, !49, !"_ZN17bnserve_inference6kernel5_sums8lane_sumB4v104B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!49 = distinct !{!49, !"_ZN17bnserve_inference6kernel5_sums8lane_sumB4v104B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE"}
!50 = !{!51}
!51 = distinct !{!51, !52, !"_ZN17bnserve_inference15marginal_kernel9_distance8_by_ruleB4v105B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEdddd27Literal_5bbool_5d_28True_295ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!52 = distinct !{!52, !"_ZN17bnserve_inference15marginal_kernel9_distance8_by_ruleB4v105B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEdddd27Literal_5bbool_5d_28True_295ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!53 = !{!54, !51}
!54 = distinct !{!54, !55, !"_ZN17bnserve_inference15marginal_kernel9_distance10_add_tableB4v101B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!55 = distinct !{!55, !"_ZN17bnserve_inference15marginal_kernel9_distance10_add_tableB4v101B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE"}
!56 = !{!57, !51}
!57 = distinct !{!57, !58, !"_ZN17bnserve_inference6kernel5_sums8lane_sumB4v104B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!58 = distinct !{!58, !"_ZN17bnserve_inference6kernel5_sums8lane_sumB4v104B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE"}
!59 = !{!60}
!60 = distinct !{!60, !61, !"_ZN17bnserve_inference15marginal_kernel9_distance8_by_ruleB4v114B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEdddd28Literal_5bbool_5d_28False_295ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!61 = distinct !{!61, !"_ZN17bnserve_inference15marginal_kernel9_distance8_by_ruleB4v114B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEdddd28Literal_5bbool_5d_28False_295ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!62 = !{!63, !60}
!63 = distinct !{!63, !64, !"_ZN17bnserve_inference15marginal_kernel9_distance10_add_tableB4v101B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!64 = distinct !{!64, !"_ZN17bnserve_inference15marginal_kernel9_distance10_add_tableB4v101B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE"}
!65 = distinct !{!65, !13}
!66 = !{!67, !60}
!67 = distinct !{!67, !68, !"_ZN17bnserve_inference6kernel5_sums8lane_sumB4v104B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!68 = distinct !{!68, !"_ZN17bnserve_inference6kernel5_sums8lane_sumB4v104B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE"}
!69 = distinct !{!69, !13}
!70 = distinct !{!70, !13}
!71 = distinct !{!71, !13}
!72 = distinct !{!72, !13}
!73 = !{!74}
!74 = distinct !{!74, !75, !"_ZN17bnserve_inference15marginal_kernel9_distance8_by_ruleB4v123B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEdddd28Literal_5bbool_5d_28False_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2864_295ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!75 = distinct !{!75, !"_ZN17bnserve_inference15marginal_kernel9_distance8_by_ruleB4v123B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEdddd28Literal_5bbool_5d_28False_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2864_295ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!76 = !{!77, !74}
!77 = distinct !{!77, !78, !"_ZN17bnserve_inference15marginal_kernel9_distance10_add_tableB4v101B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!78 = distinct !{!78, !"_ZN17bnserve_inference15marginal_kernel9_distance10_add_tableB4v101B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE"}
!79 = !{!80, !74}
!80 = distinct !{!80, !81, !"_ZN17bnserve_inference6kernel5_sums8lane_sumB4v104B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!81 = distinct !{!81, !"_ZN17bnserve_inference6kernel5_sums8lane_sumB4v104B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE"}
!82 = !{!83}
!83 = distinct !{!83, !84, !"_ZN17bnserve_inference15marginal_kernel9_distance13_large_besselB3v88B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!84 = distinct !{!84, !"_ZN17bnserve_inference15marginal_kernel9_distance13_large_besselB3v88B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!85 = distinct !{!85, !13}
!86 = !{!87}
!87 = distinct !{!87, !88, !"_ZN17bnserve_inference15marginal_kernel9_distance13_small_besselB3v89B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!88 = distinct !{!88, !"_ZN17bnserve_inference15marginal_kernel9_distance13_small_besselB3v89B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!89 = !{!90}
!90 = distinct !{!90, !91, !"_ZN17bnserve_inference15marginal_kernel7_circle9_togetherB4v134B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!91 = distinct !{!91, !"_ZN17bnserve_inference15marginal_kernel7_circle9_togetherB4v134B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!92 = distinct !{!92, !13}
!93 = distinct !{!93, !13}
!94 = distinct !{!94, !13}
