; sources: 4ad78a795dc05e6a5b69ab883ae67dc970e58520837fbecfead561eba9d10e4a
; built by: numba 0.68.1, llvmlite 0.50.0, Python 3.11, x86_64
; ModuleID = '<string>'
source_filename = "<string>"


; Function Attrs: nofree norecurse nosync nounwind memory(readwrite, inaccessiblemem: none, target_mem0: none, target_mem1: none)
define noundef i32 @bnserve_integrate(ptr noalias writeonly captures(none) %retptr, ptr noalias readnone captures(none) %excinfo, ptr readonly captures(none) %arg.arguments) local_unnamed_addr #0 {
entry:
  %.1029.i.i = alloca ptr, align 8
  %.1100.i.i = alloca ptr, align 8
  %.603.i.i = alloca [4 x double], align 8
  %.854.i15.i.i.i = alloca ptr, align 8
  %.854.i.i.i.i = alloca ptr, align 8
  %.2851.i.i.i = alloca [4 x double], align 8
  %.3119.i.i.i = alloca ptr, align 8
  %.3347.i.i.i = alloca ptr, align 8
  %.47.i = getelementptr i8, ptr %arg.arguments, i64 56
  %.48.i = load i64, ptr %.47.i, align 8, !noalias !0
  %.128.i = load i64, ptr %arg.arguments, align 8, !noalias !0
  %.173.i = getelementptr i8, ptr %arg.arguments, i64 200
  %.174.i = load i64, ptr %.173.i, align 8, !noalias !0
  %.230.i = icmp eq i64 %.128.i, 1
  br i1 %.230.i, label %B220.i, label %B384.i

B220.i:                                           ; preds = %entry
  %.260.i = getelementptr i8, ptr %arg.arguments, i64 48
  %.261.i = load i64, ptr %.260.i, align 8, !noalias !0
  %.262.i = icmp eq i64 %.261.i, 0
  br i1 %.262.i, label %B264.i, label %B384.i

B264.i:                                           ; preds = %B220.i
  %.299.i = getelementptr i8, ptr %arg.arguments, i64 152
  %.300.i = load i64, ptr %.299.i, align 8, !noalias !0
  %0 = add i64 %.300.i, 7
  %.359.i = lshr i64 %0, 3
  %.338.inv.i = icmp slt i64 %.300.i, 1
  %.380321.not327.i = icmp eq i64 %.359.i, 0
  %.380321.not.i = or i1 %.338.inv.i, %.380321.not327.i
  br i1 %.380321.not.i, label %_ZN17bnserve_inference15marginal_kernel7_source9integrateB2v3B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIxLi1E1C7mutable7alignedE.exit, label %B340.if.preheader.i

B340.if.preheader.i:                              ; preds = %B264.i
  %1 = add nuw nsw i64 %.359.i, 2
  %2 = inttoptr i64 %.174.i to ptr
  %.97.i.i = getelementptr i8, ptr %arg.arguments, i64 160
  %.186.i.i = getelementptr i8, ptr %arg.arguments, i64 168
  %.266.i.i = getelementptr i8, ptr %arg.arguments, i64 176
  %scevgep143.i.i = getelementptr i8, ptr %2, i64 64
  %scevgep141.i6.i = getelementptr i8, ptr %2, i64 128
  %scevgep144.1.i.i = getelementptr i8, ptr %2, i64 8
  %scevgep143.1.i.i = getelementptr i8, ptr %2, i64 72
  %scevgep141.1.i.i = getelementptr i8, ptr %2, i64 136
  %scevgep144.2.i.i = getelementptr i8, ptr %2, i64 16
  %scevgep143.2.i.i = getelementptr i8, ptr %2, i64 80
  %scevgep141.2.i.i = getelementptr i8, ptr %2, i64 144
  %scevgep144.3.i.i = getelementptr i8, ptr %2, i64 24
  %scevgep143.3.i.i = getelementptr i8, ptr %2, i64 88
  %scevgep141.3.i.i = getelementptr i8, ptr %2, i64 152
  %scevgep144.4.i.i = getelementptr i8, ptr %2, i64 32
  %scevgep143.4.i.i = getelementptr i8, ptr %2, i64 96
  %scevgep141.4.i.i = getelementptr i8, ptr %2, i64 160
  %scevgep144.5.i.i = getelementptr i8, ptr %2, i64 40
  %scevgep143.5.i.i = getelementptr i8, ptr %2, i64 104
  %scevgep141.5.i.i = getelementptr i8, ptr %2, i64 168
  %scevgep144.6.i.i = getelementptr i8, ptr %2, i64 48
  %scevgep143.6.i.i = getelementptr i8, ptr %2, i64 112
  %scevgep141.6.i.i = getelementptr i8, ptr %2, i64 176
  %scevgep144.7.i.i = getelementptr i8, ptr %2, i64 56
  %scevgep143.7.i.i = getelementptr i8, ptr %2, i64 120
  %scevgep141.7.i.i = getelementptr i8, ptr %2, i64 184
  %.975.i.i = getelementptr inbounds nuw i8, ptr %2, i64 192
  %.1092.i.i = getelementptr i8, ptr %arg.arguments, i64 184
  %sunkaddr13.i.i = getelementptr i8, ptr %arg.arguments, i64 192
  br label %B340.if.i

B384.i:                                           ; preds = %B220.i, %entry
  %.494.i = getelementptr i8, ptr %arg.arguments, i64 152
  %.495.i = load i64, ptr %.494.i, align 8, !noalias !0
  %.575315.not.i = icmp slt i64 %.495.i, 1
  br i1 %.575315.not.i, label %_ZN17bnserve_inference15marginal_kernel7_source9integrateB2v3B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIxLi1E1C7mutable7alignedE.exit, label %B446.if.preheader.i

B446.if.preheader.i:                              ; preds = %B384.i
  %3 = icmp eq i64 %.128.i, 2
  %4 = inttoptr i64 %.48.i to ptr
  %5 = inttoptr i64 %.174.i to ptr
  %.145.i.i = getelementptr i8, ptr %arg.arguments, i64 160
  %.235.i.i = getelementptr i8, ptr %arg.arguments, i64 168
  %sunkaddr63.i.i = getelementptr inbounds nuw i8, ptr %.603.i.i, i64 24
  %sunkaddr64.i.i = getelementptr inbounds nuw i8, ptr %.603.i.i, i64 16
  %sunkaddr65.i.i = getelementptr inbounds nuw i8, ptr %.603.i.i, i64 8
  %.814.i.i = getelementptr i8, ptr %4, i64 32
  %.851.i.i = getelementptr i8, ptr %arg.arguments, i64 176
  %.963.i.i = getelementptr i8, ptr %arg.arguments, i64 184
  %.1347.i.i = getelementptr i8, ptr %arg.arguments, i64 192
  %.107.i.i = getelementptr i8, ptr %arg.arguments, i64 8
  %.137.i.i = getelementptr i8, ptr %arg.arguments, i64 24
  %.357.i.i = getelementptr i8, ptr %arg.arguments, i64 16
  %.437.i.i = getelementptr i8, ptr %arg.arguments, i64 32
  %.532.i.i.i = getelementptr i8, ptr %4, i64 8
  %.562.i.i.i = getelementptr i8, ptr %4, i64 16
  %.592.i.i.i = getelementptr i8, ptr %4, i64 24
  %.631.i.i.i = getelementptr i8, ptr %arg.arguments, i64 48
  %.666.i.i.i = getelementptr i8, ptr %arg.arguments, i64 40
  %sunkaddr171.i.i.i = getelementptr i8, ptr %4, i64 40
  %sunkaddr211.i.i.i = getelementptr inbounds nuw i8, ptr %.2851.i.i.i, i64 24
  %sunkaddr212.i.i.i = getelementptr inbounds nuw i8, ptr %.2851.i.i.i, i64 16
  %sunkaddr213.i.i.i = getelementptr inbounds nuw i8, ptr %.2851.i.i.i, i64 8
  br label %B446.if.i

B482.i:                                           ; preds = %B446.if.i
  %.78.i.i = load i64, ptr %.494.i, align 8, !noalias !3
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
  %6 = getelementptr i64, ptr %.360.i.i, i64 %.108.i.i
  %7 = getelementptr i8, ptr %6, i64 -8
  %.536.i.i = getelementptr i64, ptr %7, i64 %.522.i.i
  %.537.i.i = load i64, ptr %.536.i.i, align 8, !noalias !3
  %.554.i.i = tail call i64 @llvm.smin.i64(i64 %.138.i.i, i64 0)
  %8 = getelementptr i64, ptr %.440.i.i, i64 %.138.i.i
  %9 = getelementptr i8, ptr %8, i64 -8
  %.568.i.i = getelementptr i64, ptr %9, i64 %.554.i.i
  %.569.i.i = load i64, ptr %.568.i.i, align 8, !noalias !3
  %.13.i.i.i = tail call i64 @llvm.smax.i64(i64 %.569.i.i, i64 %.537.i.i)
  %.598.i.i = add nsw i64 %.13.i.i.i, 1
  %.604.i.i = shl nsw i64 %.598.i.i, 3
  %.711.i.i = icmp slt i64 %.13.i.i.i, 0
  %..604.i.i = select i1 %.711.i.i, i64 0, i64 %.604.i.i
  %.7531395.i.i = icmp sgt i64 %..604.i.i, 0
  br i1 %.7531395.i.i, label %B542.if.preheader.i.i, label %B558.i.i

B542.if.preheader.i.i:                            ; preds = %B482.i
  %10 = shl nuw i64 %..604.i.i, 3
  tail call void @llvm.memset.p0.i64(ptr align 8 %5, i8 0, i64 %10, i1 false), !noalias !3
  br label %B558.i.i

B558.i.i:                                         ; preds = %B542.if.preheader.i.i, %B482.i
  %11 = icmp sgt i64 %.108.i.i, 0
  br i1 %11, label %B602.if.preheader.i.i, label %B806.i.i

B602.if.preheader.i.i:                            ; preds = %B558.i.i
  %12 = inttoptr i64 %.178.i.i to ptr
  %13 = shl i64 %.581313316.i, 4
  %14 = getelementptr i8, ptr %12, i64 %13
  %scevgep142.i.i = getelementptr i8, ptr %14, i64 8
  %15 = shl i64 %.78.i.i, 4
  %16 = shl i64 %.182.i.i, 3
  br label %B602.if.i.i

B806.i.i:                                         ; preds = %B602.if.i.i, %B558.i.i
  %bend_x.2.0.lcssa.i.i = phi double [ 0.000000e+00, %B558.i.i ], [ %.1151.i.i, %B602.if.i.i ]
  %size_x.2.0.lcssa.i.i = phi double [ 0.000000e+00, %B558.i.i ], [ %.1155.i.i, %B602.if.i.i ]
  %17 = icmp sgt i64 %.138.i.i, 0
  br i1 %17, label %B836.if.lr.ph.i.i, label %B1058.i.i

B836.if.lr.ph.i.i:                                ; preds = %B806.i.i
  %18 = inttoptr i64 %.269.i.i to ptr
  %.1404.i.i = shl nsw i64 %.598.i.i, 1
  %.1437.i.i = mul nsw i64 %.598.i.i, 3
  %19 = shl i64 %.581313316.i, 4
  %20 = getelementptr i8, ptr %18, i64 %19
  %scevgep134.i.i = getelementptr i8, ptr %20, i64 8
  %21 = shl i64 %.78.i.i, 4
  %22 = shl i64 %.273.i.i, 3
  br label %B836.if.i.i

B1058.i.i:                                        ; preds = %B836.if.i.i, %B806.i.i
  %bend_n.2.0.lcssa.i.i = phi double [ 0.000000e+00, %B806.i.i ], [ %.1473.i.i, %B836.if.i.i ]
  %size_n.2.0.lcssa.i.i = phi double [ 0.000000e+00, %B806.i.i ], [ %.1477.i.i, %B836.if.i.i ]
  %.1520.i.i = load i64, ptr %.851.i.i, align 8, !noalias !3
  %.1584.i.i = fadd contract double %size_x.2.0.lcssa.i.i, %size_n.2.0.lcssa.i.i
  %.1585.i.i = fcmp contract ueq double %.1584.i.i, 0x7FF0000000000000
  br i1 %.1585.i.i, label %B1286.i.i, label %B1188.i.i

B1188.i.i:                                        ; preds = %B1058.i.i
  %.1620.i.i = getelementptr inbounds double, ptr %5, i64 %.604.i.i
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
  %23 = add nuw i64 %.667.i.i.i, 7
  %.276.i.i.i.i = lshr i64 %23, 3
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
  %24 = getelementptr double, ptr %5, i64 %.598.i.i
  %.idx.i41.i.i.i.i = shl i64 %.598.i.i, 4
  %25 = getelementptr i8, ptr %5, i64 %.idx.i41.i.i.i.i
  %.idx288.i42.i.i.i.i = mul i64 %.598.i.i, 24
  %26 = getelementptr i8, ptr %5, i64 %.idx288.i42.i.i.i.i
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

B456.i.i.i.i:                                     ; preds = %_ZN17bnserve_inference15marginal_kernel7_circle10_at_phasesB3v66B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedExd8UniTupleIdLi3EEdd.exit151.i.i.i.i
  %.805.i.i.i.i = load double, ptr %.1620.i.i, align 8, !noalias !9
  %.842.i.i.i.i = load double, ptr %sunkaddr114.i.i.i.i, align 8, !noalias !9
  %.877.i4.i.i.i = load double, ptr %sunkaddr115.i.i.i.i, align 8, !noalias !9
  br label %B616.i.i.i.i

B616.i.i.i.i:                                     ; preds = %_ZN17bnserve_inference15marginal_kernel7_circle10_at_phasesB3v66B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedExd8UniTupleIdLi3EEdd.exit151.i.i.i.i, %B456.i.i.i.i
  %best.4.2.i.i.i.i = phi double [ %.736.i.i.i.i, %B456.i.i.i.i ], [ %best.5.0518.i.i.i.i, %_ZN17bnserve_inference15marginal_kernel7_circle10_at_phasesB3v66B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedExd8UniTupleIdLi3EEdd.exit151.i.i.i.i ]
  %where.6.2.i.i.i.i = phi double [ %.805.i.i.i.i, %B456.i.i.i.i ], [ %where.4.0519.i.i.i.i, %_ZN17bnserve_inference15marginal_kernel7_circle10_at_phasesB3v66B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedExd8UniTupleIdLi3EEdd.exit151.i.i.i.i ]
  %x.4.2.i.i.i.i = phi double [ %.842.i.i.i.i, %B456.i.i.i.i ], [ %x.2.0520.i.i.i.i, %_ZN17bnserve_inference15marginal_kernel7_circle10_at_phasesB3v66B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedExd8UniTupleIdLi3EEdd.exit151.i.i.i.i ]
  %n.4.2.i.i.i.i = phi double [ %.877.i4.i.i.i, %B456.i.i.i.i ], [ %n.2.0521.i.i.i.i, %_ZN17bnserve_inference15marginal_kernel7_circle10_at_phasesB3v66B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedExd8UniTupleIdLi3EEdd.exit151.i.i.i.i ]
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
  %27 = and i64 %halvings.3.0.i.i.i.i, 9223372036854775800
  br label %B1228.if.prol.loopexit.i.i.i.i

B1228.if.prol.loopexit.i.i.i.i:                   ; preds = %B1228.if.prol.loopexit.loopexit.i.i.i.i, %B1228.if.preheader.i.i.i.i
  %finest.2.0538.unr.i.i.i.i = phi double [ %.1271.i.i.i.i, %B1228.if.preheader.i.i.i.i ], [ %.1394.prol.i.i.i.i, %B1228.if.prol.loopexit.loopexit.i.i.i.i ]
  %.1354533537.unr.i.i.i.i = phi i64 [ %halvings.3.0.i.i.i.i, %B1228.if.preheader.i.i.i.i ], [ %27, %B1228.if.prol.loopexit.loopexit.i.i.i.i ]
  %.1394.lcssa.unr.i.i.i.i = phi double [ poison, %B1228.if.preheader.i.i.i.i ], [ %.1394.prol.i.i.i.i, %B1228.if.prol.loopexit.loopexit.i.i.i.i ]
  %28 = icmp ult i64 %halvings.3.0.i.i.i.i, 8
  br i1 %28, label %B1244.i.i.i.i, label %B1228.if.i.i.i.i

B1244.i.i.i.i:                                    ; preds = %B1228.if.2.i.i.i.i, %B1228.if.1.i.i.i.i, %B1228.if.i.i.i.i, %B1228.if.prol.loopexit.i.i.i.i, %B1158.i.i.i.i
  %finest.2.0.lcssa.i.i.i.i = phi double [ %.1271.i.i.i.i, %B1158.i.i.i.i ], [ %.1394.lcssa.unr.i.i.i.i, %B1228.if.prol.loopexit.i.i.i.i ], [ %.1394.7.i.i.i.i, %B1228.if.i.i.i.i ], [ %.1394.7.1.i.i.i.i, %B1228.if.1.i.i.i.i ], [ %.1394.7.2.i.i.i.i, %B1228.if.2.i.i.i.i ]
  %.1424.i.i.i.i = fcmp contract ogt double %.1260.i.i.i.i, %finest.2.0.lcssa.i.i.i.i
  br i1 %.1424.i.i.i.i, label %B1256.preheader.i.i.i.i, label %_ZN17bnserve_inference15marginal_kernel7_circle7_surveyB3v65B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedExx8UniTupleIdLi3EEd5ArrayIdLi1E1C7mutable7alignedE.exit.i.i.i

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
  %29 = getelementptr double, ptr %5, i64 %.598.i.i
  %.idx.i.i.i.i.i = shl i64 %.598.i.i, 4
  %30 = getelementptr i8, ptr %5, i64 %.idx.i.i.i.i.i
  %.idx288.i.i.i.i.i = mul i64 %.598.i.i, 24
  %31 = getelementptr i8, ptr %5, i64 %.idx288.i.i.i.i.i
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
  %32 = fsub contract double %where.3.0.i.i.i.i, %.1560.i.i.i.i
  store double %32, ptr %.1620.i.i, align 8, !noalias !9
  %.1560.1.i.i.i.i = fmul contract double %width.2.0.i.i.i.i, 6.250000e-01
  %33 = fsub contract double %where.3.0.i.i.i.i, %.1560.1.i.i.i.i
  store double %33, ptr %sunkaddr83.i.i.i.i, align 8, !noalias !9
  %.1560.2.i.i.i.i = fmul contract double %width.2.0.i.i.i.i, 3.750000e-01
  %34 = fsub contract double %where.3.0.i.i.i.i, %.1560.2.i.i.i.i
  store double %34, ptr %sunkaddr84.i.i.i.i, align 8, !noalias !9
  %.1560.3.i.i.i.i = fmul contract double %width.2.0.i.i.i.i, 1.250000e-01
  %35 = fsub contract double %where.3.0.i.i.i.i, %.1560.3.i.i.i.i
  store double %35, ptr %sunkaddr85.i.i.i.i, align 8, !noalias !9
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
  %36 = icmp eq <8 x i64> %.8.i22.i.i.i.i.i, zeroinitializer
  %.6.i24.i.i.i.i.i = select <8 x i1> %36, <8 x i64> zeroinitializer, <8 x i64> %.6.i21.i.i.i.i.i
  %.8.i25.i.i.i.i.i = shl <8 x i64> %.227.i.i.i.i.i, splat (i64 62)
  %.8.i26.i.i.i.i.i = and <8 x i64> %.8.i25.i.i.i.i.i, splat (i64 -9223372036854775808)
  %.8.i28.i.i.i.i.i = add <8 x i64> %.8.i25.i.i.i.i.i, splat (i64 4611686018427387904)
  %.8.i29.i.i.i.i.i = and <8 x i64> %.8.i28.i.i.i.i.i, splat (i64 -9223372036854775808)
  %37 = xor <8 x i64> %.8.i26.i.i.i.i.i, %.228.i.i.i.i.i
  %.6.i31.i.i.i.i.i = xor <8 x i64> %37, %.6.i24.i.i.i.i.i
  %38 = bitcast <8 x i64> %.6.i31.i.i.i.i.i to <8 x double>
  %39 = xor <8 x i64> %.8.i29.i.i.i.i.i, %.229.i.i.i.i.i
  %.6.i33.i.i.i.i.i = xor <8 x i64> %39, %.6.i24.i.i.i.i.i
  %40 = bitcast <8 x i64> %.6.i33.i.i.i.i.i to <8 x double>
  store <8 x i64> %.6.i33.i.i.i.i.i, ptr %sunkaddr90.i.i.i.i, align 8, !noalias !14
  store <8 x i64> %.6.i31.i.i.i.i.i, ptr %sunkaddr91.i.i.i.i, align 8, !noalias !14
  br i1 %.711.i.i, label %_ZN17bnserve_inference15marginal_kernel7_circle10_at_phasesB3v66B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedExd8UniTupleIdLi3EEdd.exit.i.i.i.i, label %B356.if.i.i.i.i.i

B904.loopexit.i.i.i.i.i:                          ; preds = %B356.if.i.i.i.i.i
  %41 = tail call <8 x double> @llvm.fabs.v8f64(<8 x double> %.864.i.i.i.i.i)
  %42 = tail call <8 x double> @llvm.fabs.v8f64(<8 x double> %.879.i.i.i.i.i)
  %43 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %41, <8 x double> zeroinitializer, <8 x double> %.837.i.i.i.i.i)
  br label %_ZN17bnserve_inference15marginal_kernel7_circle10_at_phasesB3v66B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedExd8UniTupleIdLi3EEdd.exit.i.i.i.i

B356.if.i.i.i.i.i:                                ; preds = %B1256.i.i.i.i, %B356.if.i.i.i.i.i
  %dn.2.0318.i.i.i.i.i = phi <8 x double> [ %.879.i.i.i.i.i, %B356.if.i.i.i.i.i ], [ zeroinitializer, %B1256.i.i.i.i ]
  %dx.2.0317.i.i.i.i.i = phi <8 x double> [ %.864.i.i.i.i.i, %B356.if.i.i.i.i.i ], [ zeroinitializer, %B1256.i.i.i.i ]
  %n.3.0316.i.i.i.i.i = phi <8 x double> [ %.849.i.i.i.i.i, %B356.if.i.i.i.i.i ], [ zeroinitializer, %B1256.i.i.i.i ]
  %x.2.0315.i.i.i.i.i = phi <8 x double> [ %.837.i.i.i.i.i, %B356.if.i.i.i.i.i ], [ zeroinitializer, %B1256.i.i.i.i ]
  %real.2.0314.i.i.i.i.i = phi <8 x double> [ %.934.i.i.i.i.i, %B356.if.i.i.i.i.i ], [ splat (double 1.000000e+00), %B1256.i.i.i.i ]
  %imaginary.2.0313.i.i.i.i.i = phi <8 x double> [ %.963.i.i.i.i.i, %B356.if.i.i.i.i.i ], [ zeroinitializer, %B1256.i.i.i.i ]
  %.728307311.i.i.i.i.i = phi i64 [ %.735.i.i.i.i.i, %B356.if.i.i.i.i.i ], [ 0, %B1256.i.i.i.i ]
  %.735.i.i.i.i.i = add nuw nsw i64 %.728307311.i.i.i.i.i, 1
  %44 = shl i64 %.728307311.i.i.i.i.i, 3
  %scevgep65.i.i.i.i.i = getelementptr i8, ptr %5, i64 %44
  %.768.i.i.i.i.i = load double, ptr %scevgep65.i.i.i.i.i, align 8, !noalias !14
  %scevgep64.i.i.i.i.i = getelementptr i8, ptr %29, i64 %44
  %.779.i.i.i.i.i = load double, ptr %scevgep64.i.i.i.i.i, align 8, !noalias !14
  %scevgep63.i.i.i.i.i = getelementptr i8, ptr %30, i64 %44
  %.791.i.i.i.i.i = load double, ptr %scevgep63.i.i.i.i.i, align 8, !noalias !14
  %scevgep2.i.i.i.i = getelementptr i8, ptr %31, i64 %44
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
  %.6.i34.i.i.i.i.i = fmul contract <8 x double> %imaginary.2.0313.i.i.i.i.i, %38
  %.8.i35.i.i.i.i.i = fsub contract <8 x double> zeroinitializer, %.6.i34.i.i.i.i.i
  %.6.i36.i.i.i.i.i = fmul contract <8 x double> %imaginary.2.0313.i.i.i.i.i, %40
  %.934.i.i.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %real.2.0314.i.i.i.i.i, <8 x double> %40, <8 x double> %.8.i35.i.i.i.i.i)
  %.963.i.i.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %real.2.0314.i.i.i.i.i, <8 x double> %38, <8 x double> %.6.i36.i.i.i.i.i)
  %exitcond.not.i.i.i.i.i = icmp eq i64 %.13.i.i.i, %.728307311.i.i.i.i.i
  br i1 %exitcond.not.i.i.i.i.i, label %B904.loopexit.i.i.i.i.i, label %B356.if.i.i.i.i.i

_ZN17bnserve_inference15marginal_kernel7_circle10_at_phasesB3v66B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedExd8UniTupleIdLi3EEdd.exit.i.i.i.i: ; preds = %B904.loopexit.i.i.i.i.i, %B1256.i.i.i.i
  %x.2.0.lcssa.i.i.i.i.i = phi <8 x double> [ zeroinitializer, %B1256.i.i.i.i ], [ %.837.i.i.i.i.i, %B904.loopexit.i.i.i.i.i ]
  %n.3.0.lcssa.i.i.i.i.i = phi <8 x double> [ zeroinitializer, %B1256.i.i.i.i ], [ %.849.i.i.i.i.i, %B904.loopexit.i.i.i.i.i ]
  %.1368.i.i.i.i.i = phi <8 x double> [ zeroinitializer, %B1256.i.i.i.i ], [ %43, %B904.loopexit.i.i.i.i.i ]
  %45 = phi <8 x double> [ zeroinitializer, %B1256.i.i.i.i ], [ %42, %B904.loopexit.i.i.i.i.i ]
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
  %.1437.i.i.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %45, <8 x double> splat (double -0.000000e+00), <8 x double> %.8.i37.i.i.i.i.i)
  %46 = fsub contract <8 x double> %.7.i52.i.i.i.i.i, %.1437.i.i.i.i.i
  %.8.i54.i.i.i.i.i = fadd contract <8 x double> %46, zeroinitializer
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

B1500.i.i.i.i:                                    ; preds = %_ZN17bnserve_inference15marginal_kernel7_circle10_at_phasesB3v66B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedExd8UniTupleIdLi3EEdd.exit.i.i.i.i
  %.1879.i.i.i.i = load double, ptr %.1620.i.i, align 8, !noalias !9
  br label %B1564.i.i.i.i

B1564.i.i.i.i:                                    ; preds = %B1500.i.i.i.i, %_ZN17bnserve_inference15marginal_kernel7_circle10_at_phasesB3v66B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedExd8UniTupleIdLi3EEdd.exit.i.i.i.i
  %best.7.2.i.i.i.i = phi double [ %.1810.i.i.i.i, %B1500.i.i.i.i ], [ %best.8.0.i.i.i.i, %_ZN17bnserve_inference15marginal_kernel7_circle10_at_phasesB3v66B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedExd8UniTupleIdLi3EEdd.exit.i.i.i.i ]
  %where.8.2.i.i.i.i = phi double [ %.1879.i.i.i.i, %B1500.i.i.i.i ], [ %where.3.0.i.i.i.i, %_ZN17bnserve_inference15marginal_kernel7_circle10_at_phasesB3v66B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedExd8UniTupleIdLi3EEdd.exit.i.i.i.i ]
  %.1810.1.i.i.i.i = load double, ptr %sunkaddr98.i.i.i.i, align 8, !noalias !9
  %.1812.1.i.i.i.i = fcmp contract ogt double %.1810.1.i.i.i.i, %best.7.2.i.i.i.i
  %best.7.2.1.i.i.i.i = select i1 %.1812.1.i.i.i.i, double %.1810.1.i.i.i.i, double %best.7.2.i.i.i.i
  %where.8.2.1.i.i.i.i = select i1 %.1812.1.i.i.i.i, double %33, double %where.8.2.i.i.i.i
  %.1810.2.i.i.i.i = load double, ptr %sunkaddr99.i.i.i.i, align 8, !noalias !9
  %.1812.2.i.i.i.i = fcmp contract ogt double %.1810.2.i.i.i.i, %best.7.2.1.i.i.i.i
  %best.7.2.2.i.i.i.i = select i1 %.1812.2.i.i.i.i, double %.1810.2.i.i.i.i, double %best.7.2.1.i.i.i.i
  %where.8.2.2.i.i.i.i = select i1 %.1812.2.i.i.i.i, double %34, double %where.8.2.1.i.i.i.i
  %.1810.3.i.i.i.i = load double, ptr %sunkaddr100.i.i.i.i, align 8, !noalias !9
  %.1812.3.i.i.i.i = fcmp contract ogt double %.1810.3.i.i.i.i, %best.7.2.2.i.i.i.i
  %best.7.2.3.i.i.i.i = select i1 %.1812.3.i.i.i.i, double %.1810.3.i.i.i.i, double %best.7.2.2.i.i.i.i
  %where.8.2.3.i.i.i.i = select i1 %.1812.3.i.i.i.i, double %35, double %where.8.2.2.i.i.i.i
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
  br i1 %.1922.i.i.i.i, label %B1256.i.i.i.i, label %_ZN17bnserve_inference15marginal_kernel7_circle7_surveyB3v65B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedExx8UniTupleIdLi3EEd5ArrayIdLi1E1C7mutable7alignedE.exit.i.i.i

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
  %47 = icmp eq <8 x i64> %.8.i22.i29.i.i.i.i, zeroinitializer
  %.6.i24.i30.i.i.i.i = select <8 x i1> %47, <8 x i64> zeroinitializer, <8 x i64> %.6.i21.i28.i.i.i.i
  %.8.i25.i31.i.i.i.i = shl <8 x i64> %.227.i25.i.i.i.i, splat (i64 62)
  %.8.i26.i32.i.i.i.i = and <8 x i64> %.8.i25.i31.i.i.i.i, splat (i64 -9223372036854775808)
  %.8.i28.i33.i.i.i.i = add <8 x i64> %.8.i25.i31.i.i.i.i, splat (i64 4611686018427387904)
  %.8.i29.i34.i.i.i.i = and <8 x i64> %.8.i28.i33.i.i.i.i, splat (i64 -9223372036854775808)
  %48 = xor <8 x i64> %.8.i26.i32.i.i.i.i, %.228.i26.i.i.i.i
  %.6.i31.i35.i.i.i.i = xor <8 x i64> %48, %.6.i24.i30.i.i.i.i
  %49 = bitcast <8 x i64> %.6.i31.i35.i.i.i.i to <8 x double>
  %50 = xor <8 x i64> %.8.i29.i34.i.i.i.i, %.229.i27.i.i.i.i
  %.6.i33.i36.i.i.i.i = xor <8 x i64> %50, %.6.i24.i30.i.i.i.i
  %51 = bitcast <8 x i64> %.6.i33.i36.i.i.i.i to <8 x double>
  store <8 x i64> %.6.i33.i36.i.i.i.i, ptr %sunkaddr112.i.i.i.i, align 8, !noalias !17
  store <8 x i64> %.6.i31.i35.i.i.i.i, ptr %sunkaddr113.i.i.i.i, align 8, !noalias !17
  br i1 %.711.i.i, label %_ZN17bnserve_inference15marginal_kernel7_circle10_at_phasesB3v66B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedExd8UniTupleIdLi3EEdd.exit151.i.i.i.i, label %B356.if.i43.i.i.i.i

B904.loopexit.i97.i.i.i.i:                        ; preds = %B356.if.i43.i.i.i.i
  %52 = tail call <8 x double> @llvm.fabs.v8f64(<8 x double> %.864.i82.i.i.i.i)
  %53 = tail call <8 x double> @llvm.fabs.v8f64(<8 x double> %.879.i90.i.i.i.i)
  br label %_ZN17bnserve_inference15marginal_kernel7_circle10_at_phasesB3v66B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedExd8UniTupleIdLi3EEdd.exit151.i.i.i.i

B356.if.i43.i.i.i.i:                              ; preds = %B230.if.i.i.i.i, %B356.if.i43.i.i.i.i
  %dn.2.0318.i44.i.i.i.i = phi <8 x double> [ %.879.i90.i.i.i.i, %B356.if.i43.i.i.i.i ], [ zeroinitializer, %B230.if.i.i.i.i ]
  %dx.2.0317.i45.i.i.i.i = phi <8 x double> [ %.864.i82.i.i.i.i, %B356.if.i43.i.i.i.i ], [ zeroinitializer, %B230.if.i.i.i.i ]
  %n.3.0316.i46.i.i.i.i = phi <8 x double> [ %.849.i73.i.i.i.i, %B356.if.i43.i.i.i.i ], [ zeroinitializer, %B230.if.i.i.i.i ]
  %x.2.0315.i47.i.i.i.i = phi <8 x double> [ %.837.i66.i.i.i.i, %B356.if.i43.i.i.i.i ], [ zeroinitializer, %B230.if.i.i.i.i ]
  %real.2.0314.i48.i.i.i.i = phi <8 x double> [ %.934.i94.i.i.i.i, %B356.if.i43.i.i.i.i ], [ splat (double 1.000000e+00), %B230.if.i.i.i.i ]
  %imaginary.2.0313.i49.i.i.i.i = phi <8 x double> [ %.963.i95.i.i.i.i, %B356.if.i43.i.i.i.i ], [ zeroinitializer, %B230.if.i.i.i.i ]
  %.728307311.i50.i.i.i.i = phi i64 [ %.735.i51.i.i.i.i, %B356.if.i43.i.i.i.i ], [ 0, %B230.if.i.i.i.i ]
  %.735.i51.i.i.i.i = add nuw nsw i64 %.728307311.i50.i.i.i.i, 1
  %54 = shl i64 %.728307311.i50.i.i.i.i, 3
  %scevgep65.i52.i.i.i.i = getelementptr i8, ptr %5, i64 %54
  %.768.i53.i.i.i.i = load double, ptr %scevgep65.i52.i.i.i.i, align 8, !noalias !17
  %scevgep64.i54.i.i.i.i = getelementptr i8, ptr %24, i64 %54
  %.779.i55.i.i.i.i = load double, ptr %scevgep64.i54.i.i.i.i, align 8, !noalias !17
  %scevgep63.i56.i.i.i.i = getelementptr i8, ptr %25, i64 %54
  %.791.i57.i.i.i.i = load double, ptr %scevgep63.i56.i.i.i.i, align 8, !noalias !17
  %scevgep.i.i.i.i = getelementptr i8, ptr %26, i64 %54
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
  %.6.i34.i91.i.i.i.i = fmul contract <8 x double> %imaginary.2.0313.i49.i.i.i.i, %49
  %.8.i35.i92.i.i.i.i = fsub contract <8 x double> zeroinitializer, %.6.i34.i91.i.i.i.i
  %.6.i36.i93.i.i.i.i = fmul contract <8 x double> %imaginary.2.0313.i49.i.i.i.i, %51
  %.934.i94.i.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %real.2.0314.i48.i.i.i.i, <8 x double> %51, <8 x double> %.8.i35.i92.i.i.i.i)
  %.963.i95.i.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %real.2.0314.i48.i.i.i.i, <8 x double> %49, <8 x double> %.6.i36.i93.i.i.i.i)
  %exitcond.not.i96.i.i.i.i = icmp eq i64 %.13.i.i.i, %.728307311.i50.i.i.i.i
  br i1 %exitcond.not.i96.i.i.i.i, label %B904.loopexit.i97.i.i.i.i, label %B356.if.i43.i.i.i.i

_ZN17bnserve_inference15marginal_kernel7_circle10_at_phasesB3v66B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedExd8UniTupleIdLi3EEdd.exit151.i.i.i.i: ; preds = %B904.loopexit.i97.i.i.i.i, %B230.if.i.i.i.i
  %x.2.0.lcssa.i98.i.i.i.i = phi <8 x double> [ zeroinitializer, %B230.if.i.i.i.i ], [ %.837.i66.i.i.i.i, %B904.loopexit.i97.i.i.i.i ]
  %n.3.0.lcssa.i99.i.i.i.i = phi <8 x double> [ zeroinitializer, %B230.if.i.i.i.i ], [ %.849.i73.i.i.i.i, %B904.loopexit.i97.i.i.i.i ]
  %55 = phi <8 x double> [ zeroinitializer, %B230.if.i.i.i.i ], [ %52, %B904.loopexit.i97.i.i.i.i ]
  %56 = phi <8 x double> [ zeroinitializer, %B230.if.i.i.i.i ], [ %53, %B904.loopexit.i97.i.i.i.i ]
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
  %.1368.i129.i.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %55, <8 x double> %.1367.i.i.i.i.i, <8 x double> %x.2.0.lcssa.i98.i.i.i.i)
  %.8.i49.i133.i.i.i.i = fadd contract <8 x double> %.7.i.i132.i.i.i.i, %.1368.i129.i.i.i.i
  %.1437.i134.i.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %56, <8 x double> %.1436.i.i.i.i.i, <8 x double> %.8.i37.i107.i.i.i.i)
  %57 = fsub contract <8 x double> %.7.i52.i137.i.i.i.i, %.1437.i134.i.i.i.i
  %.8.i54.i138.i.i.i.i = fadd contract <8 x double> %57, zeroinitializer
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

_ZN17bnserve_inference15marginal_kernel7_circle7_surveyB3v65B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedExx8UniTupleIdLi3EEd5ArrayIdLi1E1C7mutable7alignedE.exit.i.i.i: ; preds = %B1564.i.i.i.i, %B1244.i.i.i.i
  %best.9.1.i.i.i.i = phi double [ %best.5.0.lcssa.i.i.i.i, %B1244.i.i.i.i ], [ %best.7.2.7.i.i.i.i, %B1564.i.i.i.i ]
  store double 0xFFF0000000000000, ptr %.148.i.i.i, align 8, !noalias !6
  %.780.i.i.i = getelementptr i8, ptr %.1620.i.i, i64 584
  store double 0.000000e+00, ptr %.780.i.i.i, align 8, !noalias !6
  %58 = add nuw i64 %cells.2.0.i.i.i.i, 7
  %.859.i.i.i = lshr i64 %58, 3
  %.838.inv.i.i.i = icmp slt i64 %cells.2.0.i.i.i.i, 1
  %.8802207.not2235.i.i.i = icmp eq i64 %.859.i.i.i, 0
  %.8802207.not.i.i.i = select i1 %.838.inv.i.i.i, i1 true, i1 %.8802207.not2235.i.i.i
  br i1 %.8802207.not.i.i.i, label %B2972.i.i.i, label %B758.if.lr.ph.i.i.i

B900.i.i.i:                                       ; preds = %B900.outer.i.i.i, %_ZN17bnserve_inference15marginal_kernel7_circle7_halvedB3v85B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedEdx5ArrayIdLi1E1C7mutable7alignedEx.exit.i.i.i
  %best.3.2.i.i.i = phi double [ %best.2.4.lcssa.i.i.i, %_ZN17bnserve_inference15marginal_kernel7_circle7_halvedB3v85B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedEdx5ArrayIdLi1E1C7mutable7alignedEx.exit.i.i.i ], [ %best.3.2.ph.i.i.i, %B900.outer.i.i.i ]
  %waiting.4.2.i.i.i = phi i64 [ %waiting.3.1.1.i.i.i.i, %_ZN17bnserve_inference15marginal_kernel7_circle7_halvedB3v85B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedEdx5ArrayIdLi1E1C7mutable7alignedEx.exit.i.i.i ], [ %waiting.4.2.ph.i.i.i, %B900.outer.i.i.i ]
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
  %59 = icmp ult i64 %.5.i98.i.i.i, 8
  br i1 %59, label %B1152.if.epil.i.i.i.preheader, label %B1152.if.preheader.new.i.i.i

B1152.if.preheader.new.i.i.i:                     ; preds = %B1152.if.preheader.i.i.i
  %60 = add nsw i64 %.5.i98.i.i.i, -8
  %61 = icmp ult i64 %60, 8
  br i1 %61, label %B1208.if.loopexit.unr-lcssa.i.i.i, label %B1152.if.preheader147.i.i.i

B1152.if.preheader147.i.i.i:                      ; preds = %B1152.if.preheader.new.i.i.i
  %62 = and i64 %60, 8
  %lcmp.mod.not123.not.i.i.i = icmp eq i64 %62, 0
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
  %63 = shl i64 %.186419101912.epil.init.i.i.i, 3
  %scevgep307.i.i.i = getelementptr i8, ptr %scevgep306.i.i.i, i64 %63
  br label %B1326.if.epil.i.i.i

B1326.if.epil.i.i.i:                              ; preds = %B1326.if.epil.i.i.i, %B1326.if.epil.preheader.i.i.i
  %best.2.41914.epil.i.i.i = phi double [ %.1927.best.2.4.epil.i.i.i, %B1326.if.epil.i.i.i ], [ %best.2.41914.epil.init.i.i.i, %B1326.if.epil.preheader.i.i.i ]
  %epil.iter266.i.i.i = phi i64 [ %epil.iter266.next.i.i.i, %B1326.if.epil.i.i.i ], [ 0, %B1326.if.epil.preheader.i.i.i ]
  %64 = shl i64 %epil.iter266.i.i.i, 3
  %scevgep157.i.i.i = getelementptr i8, ptr %scevgep307.i.i.i, i64 %64
  %.1927.epil.i.i.i = load double, ptr %scevgep157.i.i.i, align 8, !noalias !6
  %.1933.epil.i.i.i = fcmp contract ogt double %.1927.epil.i.i.i, %best.2.41914.epil.i.i.i
  %.1927.best.2.4.epil.i.i.i = select i1 %.1933.epil.i.i.i, double %.1927.epil.i.i.i, double %best.2.41914.epil.i.i.i
  %epil.iter266.next.i.i.i = add i64 %epil.iter266.i.i.i, 1
  %epil.iter266.cmp.not.i.i.i = icmp eq i64 %xtraiter265.i.i.i, %epil.iter266.next.i.i.i
  br i1 %epil.iter266.cmp.not.i.i.i, label %B1400.i.i.i, label %B1326.if.epil.i.i.i, !llvm.loop !20

B1400.i.i.i:                                      ; preds = %B1326.if.epil.i.i.i, %_ZN17bnserve_inference15marginal_kernel7_circle10_at_phasesB3v66B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedExd8UniTupleIdLi3EEdd.exit.i.i.i, %B1400.loopexit.unr-lcssa.i.i.i
  %best.2.4.lcssa.i.i.i = phi double [ %best.3.2.i.i.i, %_ZN17bnserve_inference15marginal_kernel7_circle10_at_phasesB3v66B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedExd8UniTupleIdLi3EEdd.exit.i.i.i ], [ %.1927.best.2.4.3.i.i.i, %B1400.loopexit.unr-lcssa.i.i.i ], [ %.1927.best.2.4.epil.i.i.i, %B1326.if.epil.i.i.i ]
  %.1964.i.i.i = icmp sgt i64 %halvings.3.0.i.i.i.i, %.5.i98.i.i.i
  br i1 %.1964.i.i.i, label %B1412.i.i.i, label %B1460.i.i.i

B1412.i.i.i:                                      ; preds = %B1400.i.i.i
  %.1984.i.i.i = fsub contract double %best.2.4.lcssa.i.i.i, %.593.i.i.i
  %.214.i5.i.i.i = load double, ptr %.1372.i.i.i, align 8, !noalias !21
  %.215.i.i.i.i = fadd contract double %.214.i5.i.i.i, 1.000000e+00
  %.301472.not.i.i.i.i = icmp slt i64 %.5.i.i.i.i, 1
  br i1 %.301472.not.i.i.i.i, label %_ZN17bnserve_inference15marginal_kernel7_circle7_halvedB3v85B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedEdx5ArrayIdLi1E1C7mutable7alignedEx.exit.i.i.i, label %B230.if.preheader.i6.i.i.i

B230.if.preheader.i6.i.i.i:                       ; preds = %B1412.i.i.i
  %65 = icmp eq i64 %.5.i.i.i.i, 1
  br i1 %65, label %B230.if.epil.preheader.i.i.i.i, label %B230.if.preheader.new.i.i.i.i

B230.if.preheader.new.i.i.i.i:                    ; preds = %B230.if.preheader.i6.i.i.i
  %unroll_iter.i.i.i.i = and i64 %.5.i.i.i.i, 9223372036854775806
  %scevgep46.i.i.i.i = getelementptr i8, ptr %.1232.i.i.i, i64 8
  br label %B230.if.i7.i.i.i

B290.i.i.i.i:                                     ; preds = %B230.if.i7.i.i.i
  %scevgep3.i.i.i.i = getelementptr i8, ptr %scevgep46.i.i.i.i, i64 %sunkaddr23.i.i.i.i
  %scevgep4.i.i.i.i = getelementptr i8, ptr %scevgep3.i.i.i.i, i64 -8
  %.412.i.i.i.i = load double, ptr %scevgep4.i.i.i.i, align 8, !noalias !21
  %.415.i.i.i.i = fmul contract double %.412.i.i.i.i, 2.000000e+00
  %66 = lshr i64 %kept.2.0475.i.i.i.i, 60
  %.431.i.i.i.i = and i64 %66, 8
  %67 = getelementptr double, ptr %.53.i.i.i.i, i64 %kept.2.0475.i.i.i.i
  %.445.i.i.i.i = getelementptr double, ptr %67, i64 %.431.i.i.i.i
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
  %68 = lshr i64 %kept.3.1.i.i.i.i, 60
  %.431.1.i.i.i.i = and i64 %68, 8
  %69 = getelementptr double, ptr %.53.i.i.i.i, i64 %kept.3.1.i.i.i.i
  %.445.1.i.i.i.i = getelementptr double, ptr %69, i64 %.431.1.i.i.i.i
  store double %.415.1.i.i.i.i, ptr %.445.1.i.i.i.i, align 8, !noalias !21
  %.448.1.i.i.i.i = add nsw i64 %kept.3.1.i.i.i.i, 1
  br label %B328.1.i.i.i.i

B328.1.i.i.i.i:                                   ; preds = %B290.1.i.i.i.i, %B328.i.i.i.i
  %kept.3.1.1.i.i.i.i = phi i64 [ %.448.1.i.i.i.i, %B290.1.i.i.i.i ], [ %kept.3.1.i.i.i.i, %B328.i.i.i.i ]
  %niter.ncmp.1.i.i.i.i = icmp eq i64 %unroll_iter.i.i.i.i, %.314.1.i.i.i.i
  br i1 %niter.ncmp.1.i.i.i.i, label %B330.loopexit.unr-lcssa.i.i.i.i, label %B230.if.i7.i.i.i

B330.loopexit.unr-lcssa.i.i.i.i:                  ; preds = %B328.1.i.i.i.i
  %70 = and i64 %.5.i.i.i.i, 1
  %lcmp.mod.not.i8.i.i.i = icmp eq i64 %70, 0
  br i1 %lcmp.mod.not.i8.i.i.i, label %B354.if.i.i.i.i, label %B230.if.epil.preheader.i.i.i.i

B230.if.epil.preheader.i.i.i.i:                   ; preds = %B330.loopexit.unr-lcssa.i.i.i.i, %B230.if.preheader.i6.i.i.i
  %kept.2.0475.epil.init.i.i.i.i = phi i64 [ 0, %B230.if.preheader.i6.i.i.i ], [ %kept.3.1.1.i.i.i.i, %B330.loopexit.unr-lcssa.i.i.i.i ]
  %.307471473.epil.init.i.i.i.i = phi i64 [ 0, %B230.if.preheader.i6.i.i.i ], [ %.314.1.i.i.i.i, %B330.loopexit.unr-lcssa.i.i.i.i ]
  %71 = getelementptr double, ptr %.1620.i.i, i64 %.307471473.epil.init.i.i.i.i
  %72 = getelementptr i8, ptr %71, i64 512
  %.378.epil.i.i.i.i = load double, ptr %72, align 8, !noalias !21
  %.380.epil.i.i.i.i = fcmp contract ult double %.378.epil.i.i.i.i, %.1984.i.i.i
  br i1 %.380.epil.i.i.i.i, label %B354.if.i.i.i.i, label %B290.epil.i.i.i.i

B290.epil.i.i.i.i:                                ; preds = %B230.if.epil.preheader.i.i.i.i
  %73 = getelementptr double, ptr %.1232.i.i.i, i64 %.307471473.epil.init.i.i.i.i
  %.412.epil.i.i.i.i = load double, ptr %73, align 8, !noalias !21
  %.415.epil.i.i.i.i = fmul contract double %.412.epil.i.i.i.i, 2.000000e+00
  %74 = lshr i64 %kept.2.0475.epil.init.i.i.i.i, 60
  %.431.epil.i.i.i.i = and i64 %74, 8
  %75 = getelementptr double, ptr %.53.i.i.i.i, i64 %kept.2.0475.epil.init.i.i.i.i
  %.445.epil.i.i.i.i = getelementptr double, ptr %75, i64 %.431.epil.i.i.i.i
  store double %.415.epil.i.i.i.i, ptr %.445.epil.i.i.i.i, align 8, !noalias !21
  %.448.epil.i.i.i.i = add nsw i64 %kept.2.0475.epil.init.i.i.i.i, 1
  br label %B354.if.i.i.i.i

B684.i.i.i.i:                                     ; preds = %B354.if.i.i.i.i
  %.690.1.i.i.i.i = icmp sgt i64 %kept.2.0.lcssa.i.i.i.i, 0
  br i1 %.690.1.i.i.i.i, label %B536.if.1.i.i.i.i, label %_ZN17bnserve_inference15marginal_kernel7_circle7_halvedB3v85B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedEdx5ArrayIdLi1E1C7mutable7alignedEx.exit.i.i.i

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
  %76 = getelementptr i8, ptr %.709.1.i.i.i.i, i64 8
  store double %.1026.1.1.i.i.i.i, ptr %76, align 8, !noalias !21
  %.13.i16.2.1.i.i.i.i = tail call i64 @llvm.smin.i64(i64 %.924.1.i.i.i.i, i64 1)
  %sunkaddr12.i.i.i.i = shl i64 %.13.i16.2.1.i.i.i.i, 3
  %sunkaddr13.i.i.i.i = getelementptr i8, ptr %.447.i.i.i, i64 %sunkaddr12.i.i.i.i
  %sunkaddr14.i.i.i.i = getelementptr i8, ptr %sunkaddr13.i.i.i.i, i64 2480
  %.984.2.1.i.i.i.i = load double, ptr %sunkaddr14.i.i.i.i, align 8, !noalias !21
  %.1026.2.1.i.i.i.i = fadd contract double %.984.2.1.i.i.i.i, 0.000000e+00
  %77 = getelementptr i8, ptr %.709.1.i.i.i.i, i64 16
  store double %.1026.2.1.i.i.i.i, ptr %77, align 8, !noalias !21
  %.984.3.1.i.i.i.i = load double, ptr %sunkaddr14.i.i.i.i, align 8, !noalias !21
  %.1026.3.1.i.i.i.i = fadd contract double %.984.3.1.i.i.i.i, 1.000000e+00
  %78 = getelementptr i8, ptr %.709.1.i.i.i.i, i64 24
  store double %.1026.3.1.i.i.i.i, ptr %78, align 8, !noalias !21
  %.13.i16.4.1.i.i.i.i = tail call i64 @llvm.smin.i64(i64 %.924.1.i.i.i.i, i64 2)
  %sunkaddr15.i.i.i.i = shl i64 %.13.i16.4.1.i.i.i.i, 3
  %sunkaddr16.i.i.i.i = getelementptr i8, ptr %.447.i.i.i, i64 %sunkaddr15.i.i.i.i
  %sunkaddr17.i.i.i.i = getelementptr i8, ptr %sunkaddr16.i.i.i.i, i64 2480
  %.984.4.1.i.i.i.i = load double, ptr %sunkaddr17.i.i.i.i, align 8, !noalias !21
  %.1026.4.1.i.i.i.i = fadd contract double %.984.4.1.i.i.i.i, 0.000000e+00
  %79 = getelementptr i8, ptr %.709.1.i.i.i.i, i64 32
  store double %.1026.4.1.i.i.i.i, ptr %79, align 8, !noalias !21
  %.984.5.1.i.i.i.i = load double, ptr %sunkaddr17.i.i.i.i, align 8, !noalias !21
  %.1026.5.1.i.i.i.i = fadd contract double %.984.5.1.i.i.i.i, 1.000000e+00
  %80 = getelementptr i8, ptr %.709.1.i.i.i.i, i64 40
  store double %.1026.5.1.i.i.i.i, ptr %80, align 8, !noalias !21
  %.13.i16.6.1.i.i.i.i = tail call i64 @llvm.smin.i64(i64 %.924.1.i.i.i.i, i64 3)
  %sunkaddr18.i.i.i.i = shl i64 %.13.i16.6.1.i.i.i.i, 3
  %sunkaddr19.i.i.i.i = getelementptr i8, ptr %.447.i.i.i, i64 %sunkaddr18.i.i.i.i
  %sunkaddr20.i.i.i.i = getelementptr i8, ptr %sunkaddr19.i.i.i.i, i64 2480
  %.984.6.1.i.i.i.i = load double, ptr %sunkaddr20.i.i.i.i, align 8, !noalias !21
  %.1026.6.1.i.i.i.i = fadd contract double %.984.6.1.i.i.i.i, 0.000000e+00
  %81 = getelementptr i8, ptr %.709.1.i.i.i.i, i64 48
  store double %.1026.6.1.i.i.i.i, ptr %81, align 8, !noalias !21
  %.984.7.1.i.i.i.i = load double, ptr %sunkaddr20.i.i.i.i, align 8, !noalias !21
  %.1026.7.1.i.i.i.i = fadd contract double %.984.7.1.i.i.i.i, 1.000000e+00
  %82 = getelementptr i8, ptr %.709.1.i.i.i.i, i64 56
  store double %.1026.7.1.i.i.i.i, ptr %82, align 8, !noalias !21
  %.1065.1.i.i.i.i = uitofp nneg i64 %.13.i.1.i.i.i.i to double
  %.1066.1.i.i.i.i = fmul contract double %.1065.1.i.i.i.i, 2.000000e+00
  %.1097.1.i.i.i.i = getelementptr i8, ptr %.709.1.i.i.i.i, i64 64
  store double %.1066.1.i.i.i.i, ptr %.1097.1.i.i.i.i, align 8, !noalias !21
  %.1129.1.i.i.i.i = getelementptr i8, ptr %.709.1.i.i.i.i, i64 72
  store double %.215.i.i.i.i, ptr %.1129.1.i.i.i.i, align 8, !noalias !21
  %.1137.1.i.i.i.i = add nsw i64 %waiting.3.13.i.i.i.i, 1
  br label %_ZN17bnserve_inference15marginal_kernel7_circle7_halvedB3v85B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedEdx5ArrayIdLi1E1C7mutable7alignedEx.exit.i.i.i

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
  %83 = tail call i64 @llvm.smin.i64(i64 %kept.2.0.lcssa.i.i.i.i, i64 8)
  %.13.i.i9.i.i.i = add nsw i64 %83, -4
  %.924.i.i.i.i = add nsw i64 %83, -5
  %.984.i.i.i.i = load double, ptr %141, align 8, !noalias !21
  %.1026.i.i.i.i = fadd contract double %.984.i.i.i.i, 0.000000e+00
  store double %.1026.i.i.i.i, ptr %.1232.i.i.i, align 8, !noalias !21
  %.1026.1.i.i.i.i = fadd contract double %.984.i.i.i.i, 1.000000e+00
  %84 = getelementptr i8, ptr %.1232.i.i.i, i64 8
  store double %.1026.1.i.i.i.i, ptr %84, align 8, !noalias !21
  %.13.i16.2.i.i.i.i = tail call i64 @llvm.smin.i64(i64 %.924.i.i.i.i, i64 1)
  %sunkaddr24.i.i.i.i = shl nuw nsw i64 %.13.i16.2.i.i.i.i, 3
  %sunkaddr25.i.i.i.i = getelementptr i8, ptr %.447.i.i.i, i64 %sunkaddr24.i.i.i.i
  %sunkaddr26.i.i.i.i = getelementptr i8, ptr %sunkaddr25.i.i.i.i, i64 2512
  %.984.2.i.i.i.i = load double, ptr %sunkaddr26.i.i.i.i, align 8, !noalias !21
  %.1026.2.i.i.i.i = fadd contract double %.984.2.i.i.i.i, 0.000000e+00
  %85 = getelementptr i8, ptr %.1232.i.i.i, i64 16
  store double %.1026.2.i.i.i.i, ptr %85, align 8, !noalias !21
  %.984.3.i.i.i.i = load double, ptr %sunkaddr26.i.i.i.i, align 8, !noalias !21
  %.1026.3.i.i.i.i = fadd contract double %.984.3.i.i.i.i, 1.000000e+00
  %86 = getelementptr i8, ptr %.1232.i.i.i, i64 24
  store double %.1026.3.i.i.i.i, ptr %86, align 8, !noalias !21
  %.13.i16.4.i.i.i.i = tail call i64 @llvm.smin.i64(i64 %.924.i.i.i.i, i64 2)
  %sunkaddr27.i.i.i.i = shl nuw nsw i64 %.13.i16.4.i.i.i.i, 3
  %sunkaddr28.i.i.i.i = getelementptr i8, ptr %.447.i.i.i, i64 %sunkaddr27.i.i.i.i
  %sunkaddr29.i.i.i.i = getelementptr i8, ptr %sunkaddr28.i.i.i.i, i64 2512
  %.984.4.i.i.i.i = load double, ptr %sunkaddr29.i.i.i.i, align 8, !noalias !21
  %.1026.4.i.i.i.i = fadd contract double %.984.4.i.i.i.i, 0.000000e+00
  %87 = getelementptr i8, ptr %.1232.i.i.i, i64 32
  store double %.1026.4.i.i.i.i, ptr %87, align 8, !noalias !21
  %.984.5.i.i.i.i = load double, ptr %sunkaddr29.i.i.i.i, align 8, !noalias !21
  %.1026.5.i.i.i.i = fadd contract double %.984.5.i.i.i.i, 1.000000e+00
  %88 = getelementptr i8, ptr %.1232.i.i.i, i64 40
  store double %.1026.5.i.i.i.i, ptr %88, align 8, !noalias !21
  %.13.i16.6.i.i.i.i = tail call i64 @llvm.smin.i64(i64 %.924.i.i.i.i, i64 3)
  %sunkaddr30.i.i.i.i = shl nuw nsw i64 %.13.i16.6.i.i.i.i, 3
  %sunkaddr31.i.i.i.i = getelementptr i8, ptr %.447.i.i.i, i64 %sunkaddr30.i.i.i.i
  %sunkaddr32.i.i.i.i = getelementptr i8, ptr %sunkaddr31.i.i.i.i, i64 2512
  %.984.6.i.i.i.i = load double, ptr %sunkaddr32.i.i.i.i, align 8, !noalias !21
  %.1026.6.i.i.i.i = fadd contract double %.984.6.i.i.i.i, 0.000000e+00
  %89 = getelementptr i8, ptr %.1232.i.i.i, i64 48
  store double %.1026.6.i.i.i.i, ptr %89, align 8, !noalias !21
  %.984.7.i.i.i.i = load double, ptr %sunkaddr32.i.i.i.i, align 8, !noalias !21
  %.1026.7.i.i.i.i = fadd contract double %.984.7.i.i.i.i, 1.000000e+00
  %90 = getelementptr i8, ptr %.1232.i.i.i, i64 56
  store double %.1026.7.i.i.i.i, ptr %90, align 8, !noalias !21
  %.1065.i10.i.i.i = uitofp nneg i64 %.13.i.i9.i.i.i to double
  %.1066.i.i.i.i = fmul contract double %.1065.i10.i.i.i, 2.000000e+00
  store double %.1066.i.i.i.i, ptr %.1317.i.i.i, align 8, !noalias !21
  store double %.215.i.i.i.i, ptr %.1372.i.i.i, align 8, !noalias !21
  br label %B536.if.1.i.i.i.i

_ZN17bnserve_inference15marginal_kernel7_circle7_halvedB3v85B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedEdx5ArrayIdLi1E1C7mutable7alignedEx.exit.i.i.i: ; preds = %B536.if.1.i.i.i.i, %B684.i.i.i.i, %B1412.i.i.i
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
  br i1 %142, label %B1852.i.i.i, label %B2582.i.i.i

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
  %is_normal_v57__vphi176_0.2.7.i.i.i = phi i1 [ %.2598.i.i.i, %B1920.i.i.i ], [ false, %B1852.i.i.i ]
  %.2618.i.i.i = fmul contract double %.2315.i.i.i, %.2461.i.i.i
  %.2624.i.i.i = fcmp contract olt double %.2348.i.i.i, %.2618.i.i.i
  %is_normal_v57__vphi198_0.2.7.i.i.i = select i1 %is_normal_v57__vphi176_0.2.7.i.i.i, i1 %.2624.i.i.i, i1 false
  br i1 %is_normal_v57__vphi198_0.2.7.i.i.i, label %B2560.i.i.i, label %B2582.i.i.i

B2560.i.i.i:                                      ; preds = %B2142.i.i.i
  %.2665.i.i.i = icmp slt i64 %normals.3.41927.i.i.i, 0
  %.2666.i.i.i = select i1 %.2665.i.i.i, i64 544, i64 0
  %91 = getelementptr double, ptr %.299.i.i.i, i64 %normals.3.41927.i.i.i
  %.2680.i.i.i = getelementptr double, ptr %91, i64 %.2666.i.i.i
  store double %.2243.i.i.i, ptr %.2680.i.i.i, align 8, !noalias !6
  %.2701.i.i.i = icmp slt i64 %normals.3.41927.i.i.i, -32
  %.2702.i.i.i = select i1 %.2701.i.i.i, i64 544, i64 0
  %92 = getelementptr i8, ptr %91, i64 256
  %.2716.i.i.i = getelementptr double, ptr %92, i64 %.2702.i.i.i
  store double %.2315.i.i.i, ptr %.2716.i.i.i, align 8, !noalias !6
  %.2737.i.i.i = icmp slt i64 %normals.3.41927.i.i.i, -64
  %.2738.i.i.i = select i1 %.2737.i.i.i, i64 544, i64 0
  %93 = getelementptr i8, ptr %91, i64 512
  %.2752.i.i.i = getelementptr double, ptr %93, i64 %.2738.i.i.i
  store double %.2348.i.i.i, ptr %.2752.i.i.i, align 8, !noalias !6
  %.2773.i.i.i = icmp slt i64 %normals.3.41927.i.i.i, -96
  %.2774.i.i.i = select i1 %.2773.i.i.i, i64 544, i64 0
  %94 = getelementptr i8, ptr %91, i64 768
  %.2788.i.i.i = getelementptr double, ptr %94, i64 %.2774.i.i.i
  store double %.2387.i.i.i, ptr %.2788.i.i.i, align 8, !noalias !6
  %.2809.i.i.i = icmp slt i64 %normals.3.41927.i.i.i, -128
  %.2810.i.i.i = select i1 %.2809.i.i.i, i64 544, i64 0
  %95 = getelementptr i8, ptr %91, i64 1024
  %.2824.i.i.i = getelementptr double, ptr %95, i64 %.2810.i.i.i
  store double %.2422.i.i.i, ptr %.2824.i.i.i, align 8, !noalias !6
  %.2829.i.i.i = add nsw i64 %normals.3.41927.i.i.i, 1
  br label %B2630.i.i.i

B2582.i.i.i:                                      ; preds = %B2142.i.i.i, %B1560.i.i.i
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(32) %.2851.i.i.i, i8 0, i64 32, i1 false), !noalias !6
  call fastcc void @inner_0(ptr nonnull %.2851.i.i.i, double %.2243.i.i.i, double %.2276.i.i.i, ptr nonnull readonly %arg.arguments, ptr readonly %4, ptr nonnull %.232.i.i.i)
  %.2871.fca.3.load.i.i.i = load double, ptr %sunkaddr211.i.i.i, align 8, !noalias !6
  %.2871.fca.2.load.i.i.i = load double, ptr %sunkaddr212.i.i.i, align 8, !noalias !6
  %.2871.fca.1.load.i.i.i = load double, ptr %sunkaddr213.i.i.i, align 8, !noalias !6
  %.2871.fca.0.load.i.i.i = load double, ptr %.2851.i.i.i, align 8, !noalias !6
  %.2902.i.i.i = icmp slt i64 %others.3.41928.i.i.i, -288
  %.2903.i.i.i = select i1 %.2902.i.i.i, i64 544, i64 0
  %96 = getelementptr double, ptr %.361.i.i.i, i64 %others.3.41928.i.i.i
  %97 = getelementptr i8, ptr %96, i64 2304
  %.2917.i.i.i = getelementptr double, ptr %97, i64 %.2903.i.i.i
  store double %.2871.fca.0.load.i.i.i, ptr %.2917.i.i.i, align 8, !noalias !6
  %.2936.i.i.i = icmp slt i64 %others.3.41928.i.i.i, -192
  %.2937.i.i.i = select i1 %.2936.i.i.i, i64 544, i64 0
  %98 = getelementptr i8, ptr %96, i64 1536
  %.2951.i.i.i = getelementptr double, ptr %98, i64 %.2937.i.i.i
  store double %.2871.fca.1.load.i.i.i, ptr %.2951.i.i.i, align 8, !noalias !6
  %.2970.i.i.i = icmp slt i64 %others.3.41928.i.i.i, -224
  %.2971.i.i.i = select i1 %.2970.i.i.i, i64 544, i64 0
  %99 = getelementptr i8, ptr %96, i64 1792
  %.2985.i.i.i = getelementptr double, ptr %99, i64 %.2971.i.i.i
  store double %.2871.fca.2.load.i.i.i, ptr %.2985.i.i.i, align 8, !noalias !6
  %.3008.i.i.i = icmp slt i64 %others.3.41928.i.i.i, -256
  %.3009.i.i.i = select i1 %.3008.i.i.i, i64 544, i64 0
  %100 = getelementptr i8, ptr %96, i64 2048
  %.3023.i.i.i = getelementptr double, ptr %100, i64 %.3009.i.i.i
  store double %.2871.fca.3.load.i.i.i, ptr %.3023.i.i.i, align 8, !noalias !6
  %.3042.i.i.i = icmp slt i64 %others.3.41928.i.i.i, -96
  %.3043.i.i.i = select i1 %.3042.i.i.i, i64 544, i64 0
  %101 = getelementptr i8, ptr %96, i64 768
  %.3057.i.i.i = getelementptr double, ptr %101, i64 %.3043.i.i.i
  store double %.2387.i.i.i, ptr %.3057.i.i.i, align 8, !noalias !6
  %.3078.i.i.i = icmp slt i64 %others.3.41928.i.i.i, -128
  %.3079.i.i.i = select i1 %.3078.i.i.i, i64 544, i64 0
  %102 = getelementptr i8, ptr %96, i64 1024
  %.3093.i.i.i = getelementptr double, ptr %102, i64 %.3079.i.i.i
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
  call fastcc void @inner_1(ptr nonnull %.3119.i.i.i, ptr nonnull %.299.i.i.i, i64 32, i64 range(i64 -9223372036854775807, -9223372036854775808) %.598.i.i, ptr %5, i64 range(i64 -9223372036854775808, 9223372036854775801) %.604.i.i, ptr nonnull readonly %arg.arguments, ptr readonly %4, ptr nonnull %.148.i.i.i)
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
  call fastcc void @inner_2(ptr nonnull %.854.i.i.i.i, ptr nonnull %.361.i.i.i, i64 32, i64 range(i64 -9223372036854775807, -9223372036854775808) %.598.i.i, ptr %5, i64 range(i64 -9223372036854775808, 9223372036854775801) %.604.i.i, i8 %.862.i14.i.i.i, ptr nonnull %.148.i.i.i)
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

B2924.i.i.i:                                      ; preds = %B2792.i.i.i, %_ZN17bnserve_inference15marginal_kernel7_circle7_halvedB3v85B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedEdx5ArrayIdLi1E1C7mutable7alignedEx.exit.i.i.i
  %normals.10.3.i.i.i = phi i64 [ %normals.7.2.ph.i.i.i, %_ZN17bnserve_inference15marginal_kernel7_circle7_halvedB3v85B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedEdx5ArrayIdLi1E1C7mutable7alignedEx.exit.i.i.i ], [ %normals.3.4.lcssa.i.i.i, %B2792.i.i.i ]
  %others.9.3.i.i.i = phi i64 [ %others.6.2.ph.i.i.i, %_ZN17bnserve_inference15marginal_kernel7_circle7_halvedB3v85B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedEdx5ArrayIdLi1E1C7mutable7alignedEx.exit.i.i.i ], [ %others.3.4.lcssa.i.i.i, %B2792.i.i.i ]
  %.880.i.i.i = icmp sgt i64 %.87920852217.i.i.i, 1
  br i1 %.880.i.i.i, label %B758.if.i.i.i, label %B2972.i.i.i

B2972.i.i.i:                                      ; preds = %B2924.i.i.i, %_ZN17bnserve_inference15marginal_kernel7_circle7_surveyB3v65B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedExx8UniTupleIdLi3EEd5ArrayIdLi1E1C7mutable7alignedE.exit.i.i.i
  %normals.9.0.lcssa.i.i.i = phi i64 [ 0, %_ZN17bnserve_inference15marginal_kernel7_circle7_surveyB3v65B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedExx8UniTupleIdLi3EEd5ArrayIdLi1E1C7mutable7alignedE.exit.i.i.i ], [ %normals.10.3.i.i.i, %B2924.i.i.i ]
  %others.8.0.lcssa.i.i.i = phi i64 [ 0, %_ZN17bnserve_inference15marginal_kernel7_circle7_surveyB3v65B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedExx8UniTupleIdLi3EEd5ArrayIdLi1E1C7mutable7alignedE.exit.i.i.i ], [ %others.9.3.i.i.i, %B2924.i.i.i ]
  store ptr null, ptr %.3347.i.i.i, align 8, !noalias !6
  call fastcc void @inner_1(ptr nonnull %.3347.i.i.i, ptr nonnull %.299.i.i.i, i64 %normals.9.0.lcssa.i.i.i, i64 range(i64 -9223372036854775807, -9223372036854775808) %.598.i.i, ptr %5, i64 range(i64 -9223372036854775808, 9223372036854775801) %.604.i.i, ptr nonnull readonly %arg.arguments, ptr readonly %4, ptr nonnull %.148.i.i.i)
  call void @llvm.lifetime.start.p0(ptr nonnull %.854.i15.i.i.i), !noalias !6
  store ptr null, ptr %.854.i15.i.i.i, align 8, !noalias !27
  %.93.i.i.i.i = icmp eq i64 %others.8.0.lcssa.i.i.i, 0
  br i1 %.93.i.i.i.i, label %_ZN17bnserve_inference15marginal_kernel7_circle7_finishB4v165B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedEx28Literal_5bbool_5d_28False_29x5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit42.i.i.i, label %B20.i.i.i.i

B20.i.i.i.i:                                      ; preds = %B2972.i.i.i
  %.130.i.i.i.i = sub i64 0, %others.8.0.lcssa.i.i.i
  %.138.1.i.i.i.i = and i64 %.130.i.i.i.i, -8
  %.172.i17.i.i.i = sub i64 0, %.138.1.i.i.i.i
  %.336.i.i.i.i = sub i64 %.172.i17.i.i.i, %others.8.0.lcssa.i.i.i
  %..336.i.i.i.i = tail call i64 @llvm.smax.i64(i64 %.336.i.i.i.i, i64 0)
  %.388.prol.i.i.i.i = add nsw i64 %..336.i.i.i.i, -1
  %.392.prol.i.i.i.i = add i64 %others.8.0.lcssa.i.i.i, 1
  %103 = icmp slt i64 %.336.i.i.i.i, 1
  %104 = and i64 %..336.i.i.i.i, 1
  %105 = icmp eq i64 %104, 0
  %106 = icmp eq i64 %.336.i.i.i.i, 1
  br label %B90.if.i18.i.i.i

B90.loopexit.i.i.i.i:                             ; preds = %B126.if.i.i.i.i, %B126.if.prol.loopexit.i.i.i.i, %B90.if.i18.i.i.i
  %lsr.iv.next49.i27.i.i.i = add nuw nsw i64 %lsr.iv48.i19.i.i.i, 32
  %exitcond.not.i28.i.i.i = icmp eq i64 %.270.i21.i.i.i, 17
  br i1 %exitcond.not.i28.i.i.i, label %B246.i.i.i.i, label %B90.if.i18.i.i.i

B246.i.i.i.i:                                     ; preds = %B90.loopexit.i.i.i.i
  br i1 %103, label %B362.i.i.i.i, label %B322.if.preheader.i.i.i.i

B322.if.preheader.i.i.i.i:                        ; preds = %B246.i.i.i.i
  %xtraiter1.i.i.i.i = and i64 %..336.i.i.i.i, 3
  %lcmp.mod2.not.i.i.i.i = icmp eq i64 %xtraiter1.i.i.i.i, 0
  br i1 %lcmp.mod2.not.i.i.i.i, label %B322.if.prol.loopexit.i.i.i.i, label %B322.if.prol.preheader.i.i.i.i

B322.if.prol.preheader.i.i.i.i:                   ; preds = %B322.if.preheader.i.i.i.i
  %107 = shl i64 %others.8.0.lcssa.i.i.i, 3
  %108 = getelementptr i8, ptr %.361.i.i.i, i64 %107
  %scevgep43.i.i.i.i = getelementptr i8, ptr %108, i64 1536
  br label %B322.if.prol.i.i.i.i

B322.if.prol.i.i.i.i:                             ; preds = %B322.if.prol.i.i.i.i, %B322.if.prol.preheader.i.i.i.i
  %prol.iter.i.i.i.i = phi i64 [ %prol.iter.next.i.i.i.i, %B322.if.prol.i.i.i.i ], [ 0, %B322.if.prol.preheader.i.i.i.i ]
  %109 = add i64 %prol.iter.i.i.i.i, %others.8.0.lcssa.i.i.i
  %.778.prol.i.i.i.i = icmp slt i64 %109, -192
  %110 = select i1 %.778.prol.i.i.i.i, i64 4352, i64 0
  %scevgep44.i.i.i.i = getelementptr i8, ptr %scevgep43.i.i.i.i, i64 %110
  %111 = shl nuw nsw i64 %prol.iter.i.i.i.i, 3
  %scevgep9.i.i.i.i = getelementptr i8, ptr %scevgep44.i.i.i.i, i64 %111
  store double 0.000000e+00, ptr %scevgep9.i.i.i.i, align 8, !noalias !27
  %prol.iter.next.i.i.i.i = add nuw nsw i64 %prol.iter.i.i.i.i, 1
  %prol.iter.cmp.not.i29.i.i.i = icmp eq i64 %xtraiter1.i.i.i.i, %prol.iter.next.i.i.i.i
  br i1 %prol.iter.cmp.not.i29.i.i.i, label %B322.if.prol.loopexit.loopexit.i.i.i.i, label %B322.if.prol.i.i.i.i, !llvm.loop !30

B322.if.prol.loopexit.loopexit.i.i.i.i:           ; preds = %B322.if.prol.i.i.i.i
  %112 = sub nsw i64 %..336.i.i.i.i, %prol.iter.next.i.i.i.i
  %113 = add i64 %prol.iter.next.i.i.i.i, %others.8.0.lcssa.i.i.i
  br label %B322.if.prol.loopexit.i.i.i.i

B322.if.prol.loopexit.i.i.i.i:                    ; preds = %B322.if.prol.loopexit.loopexit.i.i.i.i, %B322.if.preheader.i.i.i.i
  %.723349353.unr.i.i.i.i = phi i64 [ %..336.i.i.i.i, %B322.if.preheader.i.i.i.i ], [ %112, %B322.if.prol.loopexit.loopexit.i.i.i.i ]
  %.730350352.unr.i.i.i.i = phi i64 [ %others.8.0.lcssa.i.i.i, %B322.if.preheader.i.i.i.i ], [ %113, %B322.if.prol.loopexit.loopexit.i.i.i.i ]
  %114 = icmp slt i64 %.336.i.i.i.i, 4
  br i1 %114, label %B322.if.1.preheader.i.i.i.i, label %B322.if.preheader21.i.i.i.i

B322.if.preheader21.i.i.i.i:                      ; preds = %B322.if.prol.loopexit.i.i.i.i
  %115 = add i64 %.723349353.unr.i.i.i.i, 4
  %116 = shl i64 %.730350352.unr.i.i.i.i, 3
  %scevgep1.i.i.i.i = getelementptr i8, ptr %.361.i.i.i, i64 %116
  br label %B322.if.i.i.i.i

B322.if.1.i.i.i.i:                                ; preds = %B322.if.1.preheader.i.i.i.i, %B322.if.1.i.i.i.i
  %lsr.iv24.i.i.i.i = phi i64 [ %136, %B322.if.1.preheader.i.i.i.i ], [ %lsr.iv.next25.i.i.i.i, %B322.if.1.i.i.i.i ]
  %.730350352.1.i.i.i.i = phi i64 [ %others.8.0.lcssa.i.i.i, %B322.if.1.preheader.i.i.i.i ], [ %.737.1.i.i.i.i, %B322.if.1.i.i.i.i ]
  %.737.1.i.i.i.i = add i64 %.730350352.1.i.i.i.i, 1
  %.778.1.i.i.i.i = icmp slt i64 %.730350352.1.i.i.i.i, -224
  %117 = select i1 %.778.1.i.i.i.i, i64 4352, i64 0
  %118 = shl i64 %.730350352.1.i.i.i.i, 3
  %scevgep5.i31.i.i.i = getelementptr i8, ptr %scevgep.i30.i.i.i, i64 %117
  %scevgep6.i.i.i.i = getelementptr i8, ptr %scevgep5.i31.i.i.i, i64 %118
  store double 0.000000e+00, ptr %scevgep6.i.i.i.i, align 8, !noalias !27
  %lsr.iv.next25.i.i.i.i = add i64 %lsr.iv24.i.i.i.i, -1
  %.724.1.i.i.i.i = icmp sgt i64 %lsr.iv.next25.i.i.i.i, 1
  br i1 %.724.1.i.i.i.i, label %B322.if.1.i.i.i.i, label %B322.if.2.preheader.i.i.i.i

B322.if.2.preheader.i.i.i.i:                      ; preds = %B322.if.1.i.i.i.i
  %scevgep2.i32.i.i.i = getelementptr i8, ptr %.1620.i.i, i64 9600
  br label %B322.if.2.i.i.i.i

B322.if.2.i.i.i.i:                                ; preds = %B322.if.2.i.i.i.i, %B322.if.2.preheader.i.i.i.i
  %lsr.iv.i33.i.i.i = phi i64 [ %lsr.iv.next.i36.i.i.i, %B322.if.2.i.i.i.i ], [ %136, %B322.if.2.preheader.i.i.i.i ]
  %.730350352.2.i.i.i.i = phi i64 [ %.737.2.i.i.i.i, %B322.if.2.i.i.i.i ], [ %others.8.0.lcssa.i.i.i, %B322.if.2.preheader.i.i.i.i ]
  %.737.2.i.i.i.i = add i64 %.730350352.2.i.i.i.i, 1
  %.778.2.i.i.i.i = icmp slt i64 %.730350352.2.i.i.i.i, -256
  %119 = select i1 %.778.2.i.i.i.i, i64 4352, i64 0
  %120 = shl i64 %.730350352.2.i.i.i.i, 3
  %scevgep3.i34.i.i.i = getelementptr i8, ptr %scevgep2.i32.i.i.i, i64 %119
  %scevgep4.i35.i.i.i = getelementptr i8, ptr %scevgep3.i34.i.i.i, i64 %120
  store double 0.000000e+00, ptr %scevgep4.i35.i.i.i, align 8, !noalias !27
  %lsr.iv.next.i36.i.i.i = add i64 %lsr.iv.i33.i.i.i, -1
  %.724.2.i.i.i.i = icmp sgt i64 %lsr.iv.next.i36.i.i.i, 1
  br i1 %.724.2.i.i.i.i, label %B322.if.2.i.i.i.i, label %B362.i.i.i.i

B362.i.i.i.i:                                     ; preds = %B322.if.2.i.i.i.i, %B246.i.i.i.i
  %.842.i38.i.i.i = load i64, ptr %.963.i.i, align 8, !noalias !27
  %.848.i39.i.i.i = icmp ne i64 %.842.i38.i.i.i, 0
  store ptr null, ptr %.854.i15.i.i.i, align 8, !noalias !27
  %.862.i40.i.i.i = zext i1 %.848.i39.i.i.i to i8
  call fastcc void @inner_2(ptr nonnull %.854.i15.i.i.i, ptr nonnull %.361.i.i.i, i64 %.172.i17.i.i.i, i64 range(i64 -9223372036854775807, -9223372036854775808) %.598.i.i, ptr %5, i64 range(i64 -9223372036854775808, 9223372036854775801) %.604.i.i, i8 %.862.i40.i.i.i, ptr nonnull %.148.i.i.i)
  br label %_ZN17bnserve_inference15marginal_kernel7_circle7_finishB4v165B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedEx28Literal_5bbool_5d_28False_29x5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit42.i.i.i

B90.if.i18.i.i.i:                                 ; preds = %B90.loopexit.i.i.i.i, %B20.i.i.i.i
  %lsr.iv48.i19.i.i.i = phi i64 [ 1, %B20.i.i.i.i ], [ %lsr.iv.next49.i27.i.i.i, %B90.loopexit.i.i.i.i ]
  %.263337343.i20.i.i.i = phi i64 [ 0, %B20.i.i.i.i ], [ %.270.i21.i.i.i, %B90.loopexit.i.i.i.i ]
  %.270.i21.i.i.i = add nuw nsw i64 %.263337343.i20.i.i.i, 1
  br i1 %103, label %B90.loopexit.i.i.i.i, label %B126.if.lr.ph.i.i.i.i

B126.if.lr.ph.i.i.i.i:                            ; preds = %B90.if.i18.i.i.i
  %.418.i.i.i.i = shl nsw i64 %.263337343.i20.i.i.i, 5
  %.420.i.i.i.i = add nsw i64 %.418.i.i.i.i, %others.8.0.lcssa.i.i.i
  %.435.inv.i.i.i.i = icmp sgt i64 %.420.i.i.i.i, 0
  %.436.i.i.i.i = select i1 %.435.inv.i.i.i.i, i64 0, i64 544
  %121 = getelementptr double, ptr %.361.i.i.i, i64 %.420.i.i.i.i
  br i1 %105, label %B126.if.prol.loopexit.i.i.i.i, label %B126.if.prol.i.i.i.i

B126.if.prol.i.i.i.i:                             ; preds = %B126.if.lr.ph.i.i.i.i
  %sunkaddr19.i22.i.i.i = shl nuw nsw i64 %.436.i.i.i.i, 3
  %sunkaddr20.i23.i.i.i = getelementptr i8, ptr %121, i64 %sunkaddr19.i22.i.i.i
  %sunkaddr21.i24.i.i.i = getelementptr i8, ptr %sunkaddr20.i23.i.i.i, i64 -8
  %.451.prol.i.i.i.i = load double, ptr %sunkaddr21.i24.i.i.i, align 8, !noalias !27
  %.468.prol.i.i.i.i = icmp slt i64 %.420.i.i.i.i, 0
  %.469.prol.i.i.i.i = select i1 %.468.prol.i.i.i.i, i64 544, i64 0
  %.483.prol.i.i.i.i = getelementptr double, ptr %121, i64 %.469.prol.i.i.i.i
  store double %.451.prol.i.i.i.i, ptr %.483.prol.i.i.i.i, align 8, !noalias !27
  br label %B126.if.prol.loopexit.i.i.i.i

B126.if.prol.loopexit.i.i.i.i:                    ; preds = %B126.if.prol.i.i.i.i, %B126.if.lr.ph.i.i.i.i
  %.378330334.unr.i.i.i.i = phi i64 [ %..336.i.i.i.i, %B126.if.lr.ph.i.i.i.i ], [ %.388.prol.i.i.i.i, %B126.if.prol.i.i.i.i ]
  %.385331333.unr.i.i.i.i = phi i64 [ %others.8.0.lcssa.i.i.i, %B126.if.lr.ph.i.i.i.i ], [ %.392.prol.i.i.i.i, %B126.if.prol.i.i.i.i ]
  br i1 %106, label %B90.loopexit.i.i.i.i, label %B126.if.lr.ph.new.i.i.i.i

B126.if.lr.ph.new.i.i.i.i:                        ; preds = %B126.if.prol.loopexit.i.i.i.i
  %122 = add i64 %.378330334.unr.i.i.i.i, 2
  %123 = add i64 %.385331333.unr.i.i.i.i, %lsr.iv48.i19.i.i.i
  %sunkaddr11.i.i.i.i = shl nuw nsw i64 %.436.i.i.i.i, 3
  %sunkaddr12.i25.i.i.i = getelementptr i8, ptr %121, i64 %sunkaddr11.i.i.i.i
  %sunkaddr13.i26.i.i.i = getelementptr i8, ptr %sunkaddr12.i25.i.i.i, i64 -8
  br label %B126.if.i.i.i.i

B126.if.i.i.i.i:                                  ; preds = %B126.if.i.i.i.i, %B126.if.lr.ph.new.i.i.i.i
  %lsr.iv50.i.i.i.i = phi i64 [ %lsr.iv.next51.i.i.i.i, %B126.if.i.i.i.i ], [ %123, %B126.if.lr.ph.new.i.i.i.i ]
  %lsr.iv46.i.i.i.i = phi i64 [ %lsr.iv.next47.i.i.i.i, %B126.if.i.i.i.i ], [ %122, %B126.if.lr.ph.new.i.i.i.i ]
  %.451.i.i.i.i = load double, ptr %sunkaddr13.i26.i.i.i, align 8, !noalias !27
  %124 = add i64 %lsr.iv50.i.i.i.i, -1
  %.468.i.i.i.i = icmp slt i64 %124, 0
  %125 = shl i64 %lsr.iv50.i.i.i.i, 3
  %126 = select i1 %.468.i.i.i.i, i64 4344, i64 -8
  %scevgep17.i.i.i.i = getelementptr i8, ptr %.361.i.i.i, i64 %126
  %scevgep18.i.i.i.i = getelementptr i8, ptr %scevgep17.i.i.i.i, i64 %125
  store double %.451.i.i.i.i, ptr %scevgep18.i.i.i.i, align 8, !noalias !27
  %.451.1.i.i.i.i = load double, ptr %sunkaddr13.i26.i.i.i, align 8, !noalias !27
  %.468.1.i.i.i.i = icmp slt i64 %lsr.iv50.i.i.i.i, 0
  %127 = select i1 %.468.1.i.i.i.i, i64 4352, i64 0
  %scevgep52.i.i.i.i = getelementptr i8, ptr %.361.i.i.i, i64 %127
  %scevgep10.i.i.i.i = getelementptr i8, ptr %scevgep52.i.i.i.i, i64 %125
  store double %.451.1.i.i.i.i, ptr %scevgep10.i.i.i.i, align 8, !noalias !27
  %lsr.iv.next47.i.i.i.i = add i64 %lsr.iv46.i.i.i.i, -2
  %lsr.iv.next51.i.i.i.i = add i64 %lsr.iv50.i.i.i.i, 2
  %.379.1.i.i.i.i = icmp sgt i64 %lsr.iv.next47.i.i.i.i, 2
  br i1 %.379.1.i.i.i.i, label %B126.if.i.i.i.i, label %B90.loopexit.i.i.i.i

B322.if.i.i.i.i:                                  ; preds = %B322.if.i.i.i.i, %B322.if.preheader21.i.i.i.i
  %lsr.iv2.i.i.i.i = phi ptr [ %scevgep19.i.i.i.i, %B322.if.i.i.i.i ], [ %scevgep1.i.i.i.i, %B322.if.preheader21.i.i.i.i ]
  %lsr.iv29.i.i.i.i = phi i64 [ %lsr.iv.next30.i.i.i.i, %B322.if.i.i.i.i ], [ %115, %B322.if.preheader21.i.i.i.i ]
  %.730350352.i.i.i.i = phi i64 [ %135, %B322.if.i.i.i.i ], [ %.730350352.unr.i.i.i.i, %B322.if.preheader21.i.i.i.i ]
  %.778.i.i.i.i = icmp slt i64 %.730350352.i.i.i.i, -192
  %128 = select i1 %.778.i.i.i.i, i64 5888, i64 1536
  %scevgep23.i.i.i.i = getelementptr i8, ptr %lsr.iv2.i.i.i.i, i64 %128
  store double 0.000000e+00, ptr %scevgep23.i.i.i.i, align 8, !noalias !27
  %129 = add i64 %.730350352.i.i.i.i, 1
  %.778.17.i.i.i.i = icmp slt i64 %129, -192
  %130 = select i1 %.778.17.i.i.i.i, i64 5896, i64 1544
  %scevgep22.i.i.i.i = getelementptr i8, ptr %lsr.iv2.i.i.i.i, i64 %130
  store double 0.000000e+00, ptr %scevgep22.i.i.i.i, align 8, !noalias !27
  %131 = add i64 %.730350352.i.i.i.i, 2
  %.778.216.i.i.i.i = icmp slt i64 %131, -192
  %132 = select i1 %.778.216.i.i.i.i, i64 5904, i64 1552
  %scevgep21.i.i.i.i = getelementptr i8, ptr %lsr.iv2.i.i.i.i, i64 %132
  store double 0.000000e+00, ptr %scevgep21.i.i.i.i, align 8, !noalias !27
  %133 = add i64 %.730350352.i.i.i.i, 3
  %.778.3.i.i.i.i = icmp slt i64 %133, -192
  %134 = select i1 %.778.3.i.i.i.i, i64 5912, i64 1560
  %scevgep20.i.i.i.i = getelementptr i8, ptr %lsr.iv2.i.i.i.i, i64 %134
  store double 0.000000e+00, ptr %scevgep20.i.i.i.i, align 8, !noalias !27
  %lsr.iv.next30.i.i.i.i = add i64 %lsr.iv29.i.i.i.i, -4
  %scevgep19.i.i.i.i = getelementptr i8, ptr %lsr.iv2.i.i.i.i, i64 32
  %.724.3.i.i.i.i = icmp sgt i64 %lsr.iv.next30.i.i.i.i, 4
  %135 = add i64 %.730350352.i.i.i.i, 4
  br i1 %.724.3.i.i.i.i, label %B322.if.i.i.i.i, label %B322.if.1.preheader.i.i.i.i

B322.if.1.preheader.i.i.i.i:                      ; preds = %B322.if.i.i.i.i, %B322.if.prol.loopexit.i.i.i.i
  %136 = add nuw i64 %..336.i.i.i.i, 1
  %scevgep.i30.i.i.i = getelementptr i8, ptr %.1620.i.i, i64 9344
  br label %B322.if.1.i.i.i.i

_ZN17bnserve_inference15marginal_kernel7_circle7_finishB4v165B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedEx28Literal_5bbool_5d_28False_29x5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit42.i.i.i: ; preds = %B362.i.i.i.i, %B2972.i.i.i
  call void @llvm.lifetime.end.p0(ptr nonnull %.854.i15.i.i.i), !noalias !6
  %.3485.i.i.i = load double, ptr %.780.i.i.i, align 8, !noalias !6
  %.3486.i.i.i = fcmp contract ogt double %.3485.i.i.i, 0.000000e+00
  br i1 %.3486.i.i.i, label %B2994.i.i.i, label %_ZN17bnserve_inference15marginal_kernel7_circle10_integrateB3v55B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedEx8UniTupleIdLi3EEd5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i.i

B2994.i.i.i:                                      ; preds = %_ZN17bnserve_inference15marginal_kernel7_circle7_finishB4v165B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedEx28Literal_5bbool_5d_28False_29x5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit42.i.i.i
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
  %137 = freeze double %.3622.i.i.i
  br label %_ZN17bnserve_inference15marginal_kernel7_circle10_integrateB3v55B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedEx8UniTupleIdLi3EEd5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i.i

B758.if.lr.ph.i.i.i:                              ; preds = %_ZN17bnserve_inference15marginal_kernel7_circle7_surveyB3v65B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedExx8UniTupleIdLi3EEd5ArrayIdLi1E1C7mutable7alignedE.exit.i.i.i
  %.1405.i.i.i = uitofp nneg i64 %cells.2.0.i.i.i.i to double
  %.1409.i.i.i = fdiv contract double 0x400921FB54442D18, %.1405.i.i.i
  %138 = getelementptr double, ptr %5, i64 %.598.i.i
  %.idx.i.i.i.i = shl i64 %.598.i.i, 4
  %139 = getelementptr i8, ptr %5, i64 %.idx.i.i.i.i
  %.idx288.i.i.i.i = mul i64 %.598.i.i, 24
  %140 = getelementptr i8, ptr %5, i64 %.idx288.i.i.i.i
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
  %141 = getelementptr i8, ptr %.1620.i.i, i64 14416
  %142 = icmp eq i64 %.632.i.i.i, 1
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
  %143 = icmp eq <8 x i64> %.8.i22.i.i.i.i, zeroinitializer
  %.6.i24.i.i.i.i = select <8 x i1> %143, <8 x i64> zeroinitializer, <8 x i64> %.6.i21.i.i.i.i
  %.8.i25.i.i.i.i = shl <8 x i64> %.227.i.i.i.i, splat (i64 62)
  %.8.i26.i.i.i.i = and <8 x i64> %.8.i25.i.i.i.i, splat (i64 -9223372036854775808)
  %.8.i28.i.i.i.i = add <8 x i64> %.8.i25.i.i.i.i, splat (i64 4611686018427387904)
  %.8.i29.i.i.i.i = and <8 x i64> %.8.i28.i.i.i.i, splat (i64 -9223372036854775808)
  %144 = xor <8 x i64> %.8.i26.i.i.i.i, %.228.i.i.i.i
  %.6.i31.i.i.i.i = xor <8 x i64> %144, %.6.i24.i.i.i.i
  %145 = bitcast <8 x i64> %.6.i31.i.i.i.i to <8 x double>
  %146 = xor <8 x i64> %.8.i29.i.i.i.i, %.229.i.i.i.i
  %.6.i33.i.i.i.i = xor <8 x i64> %146, %.6.i24.i.i.i.i
  %147 = bitcast <8 x i64> %.6.i33.i.i.i.i to <8 x double>
  store <8 x i64> %.6.i33.i.i.i.i, ptr %sunkaddr191.i.i.i, align 8, !noalias !32
  store <8 x i64> %.6.i31.i.i.i.i, ptr %sunkaddr192.i.i.i, align 8, !noalias !32
  br i1 %.711.i.i, label %_ZN17bnserve_inference15marginal_kernel7_circle10_at_phasesB3v66B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedExd8UniTupleIdLi3EEdd.exit.i.i.i, label %B356.if.i.i.i.i

B904.loopexit.i.i.i.i:                            ; preds = %B356.if.i.i.i.i
  %148 = tail call <8 x double> @llvm.fabs.v8f64(<8 x double> %.864.i.i.i.i)
  %149 = tail call <8 x double> @llvm.fabs.v8f64(<8 x double> %.879.i.i.i.i)
  br label %_ZN17bnserve_inference15marginal_kernel7_circle10_at_phasesB3v66B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedExd8UniTupleIdLi3EEdd.exit.i.i.i

B356.if.i.i.i.i:                                  ; preds = %B1208.if.i.i.i, %B356.if.i.i.i.i
  %dn.2.0318.i.i.i.i = phi <8 x double> [ %.879.i.i.i.i, %B356.if.i.i.i.i ], [ zeroinitializer, %B1208.if.i.i.i ]
  %dx.2.0317.i.i.i.i = phi <8 x double> [ %.864.i.i.i.i, %B356.if.i.i.i.i ], [ zeroinitializer, %B1208.if.i.i.i ]
  %n.3.0316.i.i.i.i = phi <8 x double> [ %.849.i.i.i.i, %B356.if.i.i.i.i ], [ zeroinitializer, %B1208.if.i.i.i ]
  %x.2.0315.i.i.i.i = phi <8 x double> [ %.837.i.i.i.i, %B356.if.i.i.i.i ], [ zeroinitializer, %B1208.if.i.i.i ]
  %real.2.0314.i.i.i.i = phi <8 x double> [ %.934.i.i.i.i, %B356.if.i.i.i.i ], [ splat (double 1.000000e+00), %B1208.if.i.i.i ]
  %imaginary.2.0313.i.i.i.i = phi <8 x double> [ %.963.i.i.i.i, %B356.if.i.i.i.i ], [ zeroinitializer, %B1208.if.i.i.i ]
  %.728307311.i.i.i.i = phi i64 [ %.735.i.i.i.i, %B356.if.i.i.i.i ], [ 0, %B1208.if.i.i.i ]
  %.735.i.i.i.i = add nuw nsw i64 %.728307311.i.i.i.i, 1
  %150 = shl i64 %.728307311.i.i.i.i, 3
  %scevgep65.i.i.i.i = getelementptr i8, ptr %5, i64 %150
  %.768.i.i.i.i = load double, ptr %scevgep65.i.i.i.i, align 8, !noalias !32
  %scevgep64.i.i.i.i = getelementptr i8, ptr %138, i64 %150
  %.779.i.i.i.i = load double, ptr %scevgep64.i.i.i.i, align 8, !noalias !32
  %scevgep63.i.i.i.i = getelementptr i8, ptr %139, i64 %150
  %.791.i.i.i.i = load double, ptr %scevgep63.i.i.i.i, align 8, !noalias !32
  %scevgep145.i.i.i = getelementptr i8, ptr %140, i64 %150
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
  %.6.i34.i.i.i.i = fmul contract <8 x double> %imaginary.2.0313.i.i.i.i, %145
  %.8.i35.i.i.i.i = fsub contract <8 x double> zeroinitializer, %.6.i34.i.i.i.i
  %.6.i36.i.i.i.i = fmul contract <8 x double> %imaginary.2.0313.i.i.i.i, %147
  %.934.i.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %real.2.0314.i.i.i.i, <8 x double> %147, <8 x double> %.8.i35.i.i.i.i)
  %.963.i.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %real.2.0314.i.i.i.i, <8 x double> %145, <8 x double> %.6.i36.i.i.i.i)
  %exitcond.not.i.i.i.i = icmp eq i64 %.13.i.i.i, %.728307311.i.i.i.i
  br i1 %exitcond.not.i.i.i.i, label %B904.loopexit.i.i.i.i, label %B356.if.i.i.i.i

_ZN17bnserve_inference15marginal_kernel7_circle10_at_phasesB3v66B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedExd8UniTupleIdLi3EEdd.exit.i.i.i: ; preds = %B904.loopexit.i.i.i.i, %B1208.if.i.i.i
  %x.2.0.lcssa.i.i.i.i = phi <8 x double> [ zeroinitializer, %B1208.if.i.i.i ], [ %.837.i.i.i.i, %B904.loopexit.i.i.i.i ]
  %n.3.0.lcssa.i.i.i.i = phi <8 x double> [ zeroinitializer, %B1208.if.i.i.i ], [ %.849.i.i.i.i, %B904.loopexit.i.i.i.i ]
  %151 = phi <8 x double> [ zeroinitializer, %B1208.if.i.i.i ], [ %148, %B904.loopexit.i.i.i.i ]
  %152 = phi <8 x double> [ zeroinitializer, %B1208.if.i.i.i ], [ %149, %B904.loopexit.i.i.i.i ]
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
  %.1368.i.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %151, <8 x double> %.1367.i.i.i.i, <8 x double> %x.2.0.lcssa.i.i.i.i)
  %.1372.i.i.i.i = fmul contract double %half.2.4.lcssa.i.i.i, 5.000000e-01
  %.1374.i.i.i.i = fmul contract double %half.2.4.lcssa.i.i.i, %.1372.i.i.i.i
  %.1377.i.i.i.i = fmul contract double %bend_x.2.0.lcssa.i.i, %.1374.i.i.i.i
  %.6.i48.i.i.i.i = insertelement <8 x double> poison, double %.1377.i.i.i.i, i64 0
  %.7.i.i.i.i.i = shufflevector <8 x double> %.6.i48.i.i.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.8.i49.i.i.i.i = fadd contract <8 x double> %.7.i.i.i.i.i, %.1368.i.i.i.i
  %.1434.i.i.i.i = fneg contract double %half.2.4.lcssa.i.i.i
  %.1435.i.i.i.i = insertelement <8 x double> poison, double %.1434.i.i.i.i, i64 0
  %.1436.i.i.i.i = shufflevector <8 x double> %.1435.i.i.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1437.i.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %152, <8 x double> %.1436.i.i.i.i, <8 x double> %.8.i37.i.i.i.i)
  %.1451.i.i.i.i = fmul contract double %bend_n.2.0.lcssa.i.i, %.1374.i.i.i.i
  %.6.i51.i.i.i.i = insertelement <8 x double> poison, double %.1451.i.i.i.i, i64 0
  %.7.i52.i.i.i.i = shufflevector <8 x double> %.6.i51.i.i.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %153 = fsub contract <8 x double> %.7.i52.i.i.i.i, %.1437.i.i.i.i
  %.8.i54.i.i.i.i = fadd contract <8 x double> %153, zeroinitializer
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

B1326.if.preheader.i.i.i:                         ; preds = %_ZN17bnserve_inference15marginal_kernel7_circle10_at_phasesB3v66B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedExd8UniTupleIdLi3EEdd.exit.i.i.i
  %xtraiter265.i.i.i = and i64 %.5.i.i.i.i, 3
  %154 = icmp ult i64 %.5.i.i.i.i, 4
  br i1 %154, label %B1326.if.epil.preheader.i.i.i, label %B1326.if.preheader.new.i.i.i

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
  %155 = shl i64 %.212619211925.i.i.i, 3
  %scevgep321.i.i.i = getelementptr i8, ptr %scevgep306.i.i.i, i64 %155
  %.2201.i.i.i = load double, ptr %scevgep321.i.i.i, align 8, !noalias !6
  %.2205.i.i.i = fcmp contract ult double %.2201.i.i.i, %.2204.i.i.i
  br i1 %.2205.i.i.i, label %B2764.i.i.i, label %B1560.i.i.i

_ZN17bnserve_inference15marginal_kernel7_circle10_integrateB3v55B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedEx8UniTupleIdLi3EEd5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i.i: ; preds = %B2994.i.i.i, %_ZN17bnserve_inference15marginal_kernel7_circle7_finishB4v165B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedEx28Literal_5bbool_5d_28False_29x5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit42.i.i.i
  %.1683.sroa.5.0.i.i = phi double [ %.3485.i.i.i, %B2994.i.i.i ], [ 1.000000e+00, %_ZN17bnserve_inference15marginal_kernel7_circle7_finishB4v165B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedEx28Literal_5bbool_5d_28False_29x5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit42.i.i.i ]
  %.1683.sroa.0.0.i.i = phi double [ %137, %B2994.i.i.i ], [ 0x7FF8000000000000, %_ZN17bnserve_inference15marginal_kernel7_circle7_finishB4v165B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedEx28Literal_5bbool_5d_28False_29x5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit42.i.i.i ]
  call void @llvm.lifetime.end.p0(ptr nonnull %.2851.i.i.i), !noalias !3
  call void @llvm.lifetime.end.p0(ptr nonnull %.3119.i.i.i), !noalias !3
  call void @llvm.lifetime.end.p0(ptr nonnull %.3347.i.i.i), !noalias !3
  br label %B1286.i.i

B1286.i.i:                                        ; preds = %_ZN17bnserve_inference15marginal_kernel7_circle10_integrateB3v55B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedEx8UniTupleIdLi3EEd5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i.i, %B1058.i.i
  %factor.2.0.i.i = phi double [ %.1683.sroa.5.0.i.i, %_ZN17bnserve_inference15marginal_kernel7_circle10_integrateB3v55B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedEx8UniTupleIdLi3EEd5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i.i ], [ 1.000000e+00, %B1058.i.i ]
  %value.2.0.i.i = phi double [ %.1683.sroa.0.0.i.i, %_ZN17bnserve_inference15marginal_kernel7_circle10_integrateB3v55B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedEx8UniTupleIdLi3EEd5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i.i ], [ 0x7FF8000000000000, %B1058.i.i ]
  %156 = inttoptr i64 %.1520.i.i to ptr
  %.1781.i.i = load double, ptr %.814.i.i, align 8, !noalias !3
  %.1788.i.i = fsub contract double %value.2.0.i.i, %.1781.i.i
  %157 = getelementptr double, ptr %156, i64 %.581313316.i
  store double %.1788.i.i, ptr %157, align 8, !noalias !3
  %.1854.i.i = load i64, ptr %.963.i.i, align 8, !noalias !3
  %.1855.i.i = icmp eq i64 %.1854.i.i, 0
  br i1 %.1855.i.i, label %B558.i, label %B1382.i.i

B1382.i.i:                                        ; preds = %B1286.i.i
  %.2012.i.i = load i64, ptr %.1347.i.i, align 8, !noalias !3
  %.2078.i.i = fcmp contract ord double %value.2.0.i.i, 0.000000e+00
  %.2086.i.i = fdiv contract double 1.000000e+00, %factor.2.0.i.i
  %"$phi1578.0.2.0.i.i" = select i1 %.2078.i.i, double %.2086.i.i, double 0x7FF8000000000000
  %.21861423.not.i.i = icmp slt i64 %.108.i.i, 1
  br i1 %.21861423.not.i.i, label %B1762.i.i, label %B1610.if.lr.ph.i.i

B1762.i.i:                                        ; preds = %B1610.if.i.i, %B1382.i.i
  %.25221430.not.i.i = icmp slt i64 %.138.i.i, 1
  br i1 %.25221430.not.i.i, label %B558.i, label %B1792.if.lr.ph.i.i

B1792.if.lr.ph.i.i:                               ; preds = %B1762.i.i
  %158 = inttoptr i64 %.2012.i.i to ptr
  %.2561.i.i = fmul contract double %"$phi1578.0.2.0.i.i", -5.000000e-01
  %.2563.i.i = mul nsw i64 %.598.i.i, 6
  %.2664.i.i = mul nsw i64 %.598.i.i, 7
  %159 = shl i64 %.581313316.i, 4
  %160 = getelementptr i8, ptr %158, i64 %159
  %scevgep118.i.i = getelementptr i8, ptr %160, i64 8
  %161 = shl i64 %.78.i.i, 4
  %162 = shl i64 %.273.i.i, 3
  br label %B1792.if.i.i

B602.if.i.i:                                      ; preds = %B602.if.i.i, %B602.if.preheader.i.i
  %lsr.iv147.i.i = phi i64 [ %.581313316.i, %B602.if.preheader.i.i ], [ %lsr.iv.next148.i.i, %B602.if.i.i ]
  %lsr.iv143.i.i = phi ptr [ %scevgep142.i.i, %B602.if.preheader.i.i ], [ %scevgep144.i.i, %B602.if.i.i ]
  %size_x.2.01405.i.i = phi double [ 0.000000e+00, %B602.if.preheader.i.i ], [ %.1155.i.i, %B602.if.i.i ]
  %bend_x.2.01404.i.i = phi double [ 0.000000e+00, %B602.if.preheader.i.i ], [ %.1151.i.i, %B602.if.i.i ]
  %.94814001402.i.i = phi i64 [ 0, %B602.if.preheader.i.i ], [ %.955.i.i, %B602.if.i.i ]
  %.955.i.i = add nuw nsw i64 %.94814001402.i.i, 1
  %163 = shl i64 %.94814001402.i.i, 3
  %scevgep141.i.i = getelementptr i8, ptr %.360.i.i, i64 %163
  %.1009.i.i = load i64, ptr %scevgep141.i.i, align 8, !noalias !3
  %.1028.i.i = icmp slt i64 %lsr.iv147.i.i, 0
  %164 = select i1 %.1028.i.i, i64 %16, i64 0
  %scevgep145.i.i = getelementptr i8, ptr %lsr.iv143.i.i, i64 %164
  %scevgep146.i.i = getelementptr i8, ptr %scevgep145.i.i, i64 -8
  %.1044.i.i = load double, ptr %scevgep146.i.i, align 8, !noalias !3
  %.1080.i.i = load double, ptr %scevgep145.i.i, align 8, !noalias !3
  %.1081.i.i = fmul contract double %.1044.i.i, %.1044.i.i
  %.1082.i.i = fmul contract double %.1080.i.i, %.1080.i.i
  %.1083.i.i = fadd contract double %.1081.i.i, %.1082.i.i
  %.1084.i.i = tail call contract double @llvm.sqrt.f64(double %.1083.i.i)
  %.1098.i.i = icmp slt i64 %.1009.i.i, 0
  %.1099.i.i = select i1 %.1098.i.i, i64 %.604.i.i, i64 0
  %165 = getelementptr double, ptr %5, i64 %.1009.i.i
  %.1113.i.i = getelementptr double, ptr %165, i64 %.1099.i.i
  store double %.1044.i.i, ptr %.1113.i.i, align 8, !noalias !3
  %.1116.i.i = add nsw i64 %.1009.i.i, %.598.i.i
  %.1130.i.i = icmp slt i64 %.1116.i.i, 0
  %.1131.i.i = select i1 %.1130.i.i, i64 %.604.i.i, i64 0
  %166 = getelementptr double, ptr %5, i64 %.1116.i.i
  %.1145.i.i = getelementptr double, ptr %166, i64 %.1131.i.i
  store double %.1080.i.i, ptr %.1145.i.i, align 8, !noalias !3
  %.1147.i.i = mul nsw i64 %.1009.i.i, %.1009.i.i
  %.1148.i.i = uitofp nneg i64 %.1147.i.i to double
  %.1149.i.i = fmul contract double %.1084.i.i, %.1148.i.i
  %.1151.i.i = fadd contract double %bend_x.2.01404.i.i, %.1149.i.i
  %.1155.i.i = fadd contract double %size_x.2.01405.i.i, %.1084.i.i
  %scevgep144.i.i = getelementptr i8, ptr %lsr.iv143.i.i, i64 %15
  %lsr.iv.next148.i.i = add i64 %lsr.iv147.i.i, %.78.i.i
  %exitcond1435.not.i.i = icmp eq i64 %.108.i.i, %.955.i.i
  br i1 %exitcond1435.not.i.i, label %B806.i.i, label %B602.if.i.i

B836.if.i.i:                                      ; preds = %B836.if.i.i, %B836.if.lr.ph.i.i
  %lsr.iv139.i.i = phi i64 [ %.581313316.i, %B836.if.lr.ph.i.i ], [ %lsr.iv.next140.i.i, %B836.if.i.i ]
  %lsr.iv135.i.i = phi ptr [ %scevgep134.i.i, %B836.if.lr.ph.i.i ], [ %scevgep136.i.i, %B836.if.i.i ]
  %size_n.2.01416.i.i = phi double [ 0.000000e+00, %B836.if.lr.ph.i.i ], [ %.1477.i.i, %B836.if.i.i ]
  %bend_n.2.01415.i.i = phi double [ 0.000000e+00, %B836.if.lr.ph.i.i ], [ %.1473.i.i, %B836.if.i.i ]
  %.126614111413.i.i = phi i64 [ 0, %B836.if.lr.ph.i.i ], [ %.1273.i.i, %B836.if.i.i ]
  %.1273.i.i = add nuw nsw i64 %.126614111413.i.i, 1
  %167 = shl i64 %.126614111413.i.i, 3
  %scevgep133.i.i = getelementptr i8, ptr %.440.i.i, i64 %167
  %.1327.i.i = load i64, ptr %scevgep133.i.i, align 8, !noalias !3
  %.1346.i.i = icmp slt i64 %lsr.iv139.i.i, 0
  %168 = select i1 %.1346.i.i, i64 %22, i64 0
  %scevgep137.i.i = getelementptr i8, ptr %lsr.iv135.i.i, i64 %168
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
  %169 = getelementptr double, ptr %5, i64 %.1405.i.i
  %.1434.i.i = getelementptr double, ptr %169, i64 %.1420.i.i
  store double %.1362.i.i, ptr %.1434.i.i, align 8, !noalias !3
  %.1438.i.i = add nsw i64 %.1327.i.i, %.1437.i.i
  %.1452.i.i = icmp slt i64 %.1438.i.i, 0
  %.1453.i.i = select i1 %.1452.i.i, i64 %.604.i.i, i64 0
  %170 = getelementptr double, ptr %5, i64 %.1438.i.i
  %.1467.i.i = getelementptr double, ptr %170, i64 %.1453.i.i
  store double %.1398.i.i, ptr %.1467.i.i, align 8, !noalias !3
  %.1469.i.i = mul nsw i64 %.1327.i.i, %.1327.i.i
  %.1470.i.i = uitofp nneg i64 %.1469.i.i to double
  %.1471.i.i = fmul contract double %.1402.i.i, %.1470.i.i
  %.1473.i.i = fadd contract double %bend_n.2.01415.i.i, %.1471.i.i
  %.1477.i.i = fadd contract double %size_n.2.01416.i.i, %.1402.i.i
  %scevgep136.i.i = getelementptr i8, ptr %lsr.iv135.i.i, i64 %21
  %lsr.iv.next140.i.i = add i64 %lsr.iv139.i.i, %.78.i.i
  %exitcond1436.not.i.i = icmp eq i64 %.138.i.i, %.1273.i.i
  br i1 %exitcond1436.not.i.i, label %B1058.i.i, label %B836.if.i.i

B1610.if.lr.ph.i.i:                               ; preds = %B1382.i.i
  %171 = inttoptr i64 %.1854.i.i to ptr
  %.2225.i.i = shl nsw i64 %.598.i.i, 2
  %.2325.i.i = mul nsw i64 %.598.i.i, 5
  %172 = shl i64 %.581313316.i, 4
  %173 = getelementptr i8, ptr %171, i64 %172
  %scevgep125.i.i = getelementptr i8, ptr %173, i64 8
  %174 = shl i64 %.78.i.i, 4
  %175 = shl i64 %.182.i.i, 3
  br label %B1610.if.i.i

B1610.if.i.i:                                     ; preds = %B1610.if.i.i, %B1610.if.lr.ph.i.i
  %lsr.iv131.i.i = phi i64 [ %.581313316.i, %B1610.if.lr.ph.i.i ], [ %lsr.iv.next132.i.i, %B1610.if.i.i ]
  %lsr.iv126.i.i = phi ptr [ %scevgep125.i.i, %B1610.if.lr.ph.i.i ], [ %scevgep127.i.i, %B1610.if.i.i ]
  %.219214221424.i.i = phi i64 [ 0, %B1610.if.lr.ph.i.i ], [ %.2199.i.i, %B1610.if.i.i ]
  %.2199.i.i = add nuw nsw i64 %.219214221424.i.i, 1
  %176 = shl i64 %.219214221424.i.i, 3
  %scevgep124.i.i = getelementptr i8, ptr %.360.i.i, i64 %176
  %.2255.i.i = load i64, ptr %scevgep124.i.i, align 8, !noalias !3
  %.2256.i.i = add nsw i64 %.2255.i.i, %.2225.i.i
  %.2270.i.i = icmp slt i64 %.2256.i.i, 0
  %.2271.i.i = select i1 %.2270.i.i, i64 %.604.i.i, i64 0
  %177 = getelementptr double, ptr %5, i64 %.2256.i.i
  %.2285.i.i = getelementptr double, ptr %177, i64 %.2271.i.i
  %.2286.i.i = load double, ptr %.2285.i.i, align 8, !noalias !3
  %.2288.i.i = fmul contract double %"$phi1578.0.2.0.i.i", %.2286.i.i
  %.2307.i.i = icmp slt i64 %lsr.iv131.i.i, 0
  %178 = select i1 %.2307.i.i, i64 %175, i64 0
  %scevgep128.i.i = getelementptr i8, ptr %lsr.iv126.i.i, i64 %178
  %scevgep129.i.i = getelementptr i8, ptr %scevgep128.i.i, i64 -8
  store double %.2288.i.i, ptr %scevgep129.i.i, align 8, !noalias !3
  %.2355.i.i = load i64, ptr %scevgep124.i.i, align 8, !noalias !3
  %.2356.i.i = add nsw i64 %.2355.i.i, %.2325.i.i
  %.2370.i.i = icmp slt i64 %.2356.i.i, 0
  %.2371.i.i = select i1 %.2370.i.i, i64 %.604.i.i, i64 0
  %179 = getelementptr double, ptr %5, i64 %.2356.i.i
  %.2385.i.i = getelementptr double, ptr %179, i64 %.2371.i.i
  %.2386.i.i = load double, ptr %.2385.i.i, align 8, !noalias !3
  %.2388.i.i = fmul contract double %"$phi1578.0.2.0.i.i", %.2386.i.i
  store double %.2388.i.i, ptr %scevgep128.i.i, align 8, !noalias !3
  %scevgep127.i.i = getelementptr i8, ptr %lsr.iv126.i.i, i64 %174
  %lsr.iv.next132.i.i = add i64 %lsr.iv131.i.i, %.78.i.i
  %exitcond1437.not.i.i = icmp eq i64 %.108.i.i, %.2199.i.i
  br i1 %exitcond1437.not.i.i, label %B1762.i.i, label %B1610.if.i.i

B1792.if.i.i:                                     ; preds = %B1792.if.i.i, %B1792.if.lr.ph.i.i
  %lsr.iv123.i.i = phi i64 [ %.581313316.i, %B1792.if.lr.ph.i.i ], [ %lsr.iv.next.i.i, %B1792.if.i.i ]
  %lsr.iv.i.i = phi ptr [ %scevgep118.i.i, %B1792.if.lr.ph.i.i ], [ %scevgep119.i.i, %B1792.if.i.i ]
  %.252814291431.i.i = phi i64 [ 0, %B1792.if.lr.ph.i.i ], [ %.2535.i.i, %B1792.if.i.i ]
  %.2535.i.i = add nuw nsw i64 %.252814291431.i.i, 1
  %180 = shl i64 %.252814291431.i.i, 3
  %scevgep.i.i = getelementptr i8, ptr %.440.i.i, i64 %180
  %.2593.i.i = load i64, ptr %scevgep.i.i, align 8, !noalias !3
  %.2594.i.i = add nsw i64 %.2593.i.i, %.2563.i.i
  %.2608.i.i = icmp slt i64 %.2594.i.i, 0
  %.2609.i.i = select i1 %.2608.i.i, i64 %.604.i.i, i64 0
  %181 = getelementptr double, ptr %5, i64 %.2594.i.i
  %.2623.i.i = getelementptr double, ptr %181, i64 %.2609.i.i
  %.2624.i.i = load double, ptr %.2623.i.i, align 8, !noalias !3
  %.2625.i.i = fmul contract double %.2561.i.i, %.2624.i.i
  %.2644.i.i = icmp slt i64 %lsr.iv123.i.i, 0
  %182 = select i1 %.2644.i.i, i64 %162, i64 0
  %scevgep120.i.i = getelementptr i8, ptr %lsr.iv.i.i, i64 %182
  %scevgep121.i.i = getelementptr i8, ptr %scevgep120.i.i, i64 -8
  store double %.2625.i.i, ptr %scevgep121.i.i, align 8, !noalias !3
  %.2694.i.i = load i64, ptr %scevgep.i.i, align 8, !noalias !3
  %.2695.i.i = add nsw i64 %.2694.i.i, %.2664.i.i
  %.2709.i.i = icmp slt i64 %.2695.i.i, 0
  %.2710.i.i = select i1 %.2709.i.i, i64 %.604.i.i, i64 0
  %183 = getelementptr double, ptr %5, i64 %.2695.i.i
  %.2724.i.i = getelementptr double, ptr %183, i64 %.2710.i.i
  %.2725.i.i = load double, ptr %.2724.i.i, align 8, !noalias !3
  %.2726.i.i = fmul contract double %.2561.i.i, %.2725.i.i
  store double %.2726.i.i, ptr %scevgep120.i.i, align 8, !noalias !3
  %scevgep119.i.i = getelementptr i8, ptr %lsr.iv.i.i, i64 %161
  %lsr.iv.next.i.i = add i64 %lsr.iv123.i.i, %.78.i.i
  %exitcond1438.not.i.i = icmp eq i64 %.138.i.i, %.2535.i.i
  br i1 %exitcond1438.not.i.i, label %B558.i, label %B1792.if.i.i

B520.i:                                           ; preds = %B446.if.i
  call void @llvm.lifetime.start.p0(ptr nonnull %.603.i.i), !noalias !0
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(32) %.603.i.i, i8 0, i64 32, i1 false), !noalias !35
  %.108.i3.i = load i64, ptr %arg.arguments, align 8, !noalias !35
  %.109.i.i = icmp eq i64 %.108.i3.i, 1
  %.146.i.i = load i64, ptr %.145.i.i, align 8, !noalias !35
  %.148.i.i = shl nsw i64 %.581313316.i, 4
  %.149.i.i = add nsw i64 %.146.i.i, %.148.i.i
  %.150.i.i = inttoptr i64 %.149.i.i to ptr
  %.236.i.i = load i64, ptr %.235.i.i, align 8, !noalias !35
  %.238.i.i = inttoptr i64 %.236.i.i to ptr
  %184 = getelementptr double, ptr %.238.i.i, i64 %.581313316.i
  %.315.i.i = load double, ptr %184, align 8, !noalias !35
  %.353.i.i = load double, ptr %.150.i.i, align 8, !noalias !35
  br i1 %.109.i.i, label %B260.i.i, label %B370.i.i

B260.i.i:                                         ; preds = %B520.i
  %.384.i.i = fmul contract double %.353.i.i, %.353.i.i
  %sunkaddr.i.i = inttoptr i64 %.146.i.i to ptr
  %sunkaddr61.i.i = getelementptr i8, ptr %sunkaddr.i.i, i64 %.148.i.i
  %sunkaddr62.i.i = getelementptr i8, ptr %sunkaddr61.i.i, i64 8
  %.414.i.i = load double, ptr %sunkaddr62.i.i, align 8, !noalias !35
  %.445.i.i = fmul contract double %.414.i.i, %.414.i.i
  %.446.i.i = fadd contract double %.384.i.i, %.445.i.i
  %.447.i.i = tail call contract double @llvm.sqrt.f64(double %.446.i.i)
  br label %B370.i.i

B370.i.i:                                         ; preds = %B260.i.i, %B520.i
  %"$phi370.0.2.0.i.i" = phi double [ %.447.i.i, %B260.i.i ], [ %.353.i.i, %B520.i ]
  %"$phi370.0.2.0.fr.i.i" = freeze double %"$phi370.0.2.0.i.i"
  %185 = tail call double @llvm.fabs.f64(double %"$phi370.0.2.0.fr.i.i")
  %or.cond.i.i = fcmp ueq double %185, 0x7FF0000000000000
  %186 = tail call double @llvm.fabs.f64(double %.315.i.i)
  %187 = fcmp ueq double %186, 0x7FF0000000000000
  %or.cond2.i.i = select i1 %or.cond.i.i, i1 true, i1 %187
  br i1 %or.cond2.i.i, label %B650.i.i, label %B566.i.i

B566.i.i:                                         ; preds = %B370.i.i
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(32) %.603.i.i, i8 0, i64 32, i1 false), !noalias !35
  call fastcc void @inner_0(ptr nonnull %.603.i.i, double %"$phi370.0.2.0.fr.i.i", double %.315.i.i, ptr nonnull readonly %arg.arguments, ptr readonly %4, ptr %5)
  %.623.fca.3.load.i.i = load double, ptr %sunkaddr63.i.i, align 8, !noalias !35
  %.623.fca.2.load.i.i = load double, ptr %sunkaddr64.i.i, align 8, !noalias !35
  %.623.fca.1.load.i.i = load double, ptr %sunkaddr65.i.i, align 8, !noalias !35
  %.623.fca.0.load.i.i = load double, ptr %.603.i.i, align 8, !noalias !35
  %188 = fmul contract double %.623.fca.3.load.i.i, -5.000000e-01
  br label %B650.i.i

B650.i.i:                                         ; preds = %B566.i.i, %B370.i.i
  %exponent.2.0.i.i = phi double [ %.623.fca.0.load.i.i, %B566.i.i ], [ 0x7FF8000000000000, %B370.i.i ]
  %factor.2.0.i4.i = phi double [ %.623.fca.1.load.i.i, %B566.i.i ], [ 1.000000e+00, %B370.i.i ]
  %firsts.2.0.i.i = phi double [ %.623.fca.2.load.i.i, %B566.i.i ], [ 0x7FF8000000000000, %B370.i.i ]
  %squares.2.0.i.i = phi double [ %188, %B566.i.i ], [ 0x7FF8000000000000, %B370.i.i ]
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
  %189 = getelementptr double, ptr %.854.i.i, i64 %.581313316.i
  store double %.821.i.i, ptr %189, align 8, !noalias !35
  %.964.i.i = load i64, ptr %.963.i.i, align 8, !noalias !35
  %.965.not.i.i = icmp eq i64 %.964.i.i, 0
  br i1 %.965.not.i.i, label %_ZN17bnserve_inference15marginal_kernel7_source8_at_onceB4v171B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i, label %B834.i.i

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
  %190 = getelementptr double, ptr %.1357.i.i, i64 %.581313316.i
  store double %.1315.i.i, ptr %190, align 8, !noalias !35
  br label %_ZN17bnserve_inference15marginal_kernel7_source8_at_onceB4v171B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i

_ZN17bnserve_inference15marginal_kernel7_source8_at_onceB4v171B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i: ; preds = %B1032.i.i, %B650.i.i
  call void @llvm.lifetime.end.p0(ptr nonnull %.603.i.i), !noalias !0
  br label %B558.i

B558.i:                                           ; preds = %B1792.if.i.i, %_ZN17bnserve_inference15marginal_kernel7_source8_at_onceB4v171B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i, %B1762.i.i, %B1286.i.i
  %exitcond.not.i = icmp eq i64 %.495.i, %.588.i
  br i1 %exitcond.not.i, label %_ZN17bnserve_inference15marginal_kernel7_source9integrateB2v3B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIxLi1E1C7mutable7alignedE.exit, label %B446.if.i

B340.if.i:                                        ; preds = %_ZN17bnserve_inference15marginal_kernel7_source12_over_phasesB2v7B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i, %B340.if.preheader.i
  %lsr.iv7.i = phi i64 [ %lsr.iv.next8.i, %_ZN17bnserve_inference15marginal_kernel7_source12_over_phasesB2v7B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i ], [ %1, %B340.if.preheader.i ]
  %.386320322.i = phi i64 [ %.393.i, %_ZN17bnserve_inference15marginal_kernel7_source12_over_phasesB2v7B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i ], [ 0, %B340.if.preheader.i ]
  call void @llvm.lifetime.start.p0(ptr nonnull %.1029.i.i), !noalias !0
  call void @llvm.lifetime.start.p0(ptr nonnull %.1100.i.i), !noalias !0
  store ptr null, ptr %.1029.i.i, align 8, !noalias !38
  store ptr null, ptr %.1100.i.i, align 8, !noalias !38
  %.64.i.i = load i64, ptr %.299.i, align 8, !noalias !38
  %.98.i.i = load i64, ptr %.97.i.i, align 8, !noalias !38
  %.187.i.i = load i64, ptr %.186.i.i, align 8, !noalias !38
  %.267.i.i = load i64, ptr %.266.i.i, align 8, !noalias !38
  %191 = inttoptr i64 %.98.i.i to ptr
  %.676.i.i = add nsw i64 %.64.i.i, -1
  %.100.i.i = shl nsw i64 %.64.i.i, 1
  %.13.i44.i.i = tail call i64 @llvm.smin.i64(i64 %.676.i.i, i64 %.386320322.i)
  %.719.i.i = icmp slt i64 %.13.i44.i.i, 0
  %.720.i.i = select i1 %.719.i.i, i64 %.100.i.i, i64 0
  %.idx.i.i = shl i64 %.13.i44.i.i, 4
  %192 = getelementptr i8, ptr %191, i64 %.idx.i.i
  %.734.i.i = getelementptr double, ptr %192, i64 %.720.i.i
  %.735.i.i = load double, ptr %.734.i.i, align 8, !noalias !38
  %.767.i5.i = fmul contract double %.735.i.i, %.735.i.i
  %193 = getelementptr i8, ptr %192, i64 8
  %.798.i.i = getelementptr double, ptr %193, i64 %.720.i.i
  %.799.i.i = load double, ptr %.798.i.i, align 8, !noalias !38
  %.832.i.i = fmul contract double %.799.i.i, %.799.i.i
  %.833.i.i = fadd contract double %.767.i5.i, %.832.i.i
  %.834.i.i = tail call contract double @llvm.sqrt.f64(double %.833.i.i)
  %.839.i.i = fcmp contract one double %.834.i.i, 0x7FF0000000000000
  %"$phi654.1.2.1.i.i" = select i1 %.839.i.i, double %.834.i.i, double 0.000000e+00
  store double %"$phi654.1.2.1.i.i", ptr %2, align 8, !noalias !38
  store double 0.000000e+00, ptr %scevgep143.i.i, align 8, !noalias !38
  store double 1.000000e+00, ptr %scevgep141.i6.i, align 8, !noalias !38
  %194 = or disjoint i64 %.386320322.i, 1
  %.13.i44.1.i.i = tail call i64 @llvm.smin.i64(i64 %.676.i.i, i64 %194)
  %.719.1.i.i = icmp slt i64 %.13.i44.1.i.i, 0
  %.720.1.i.i = select i1 %.719.1.i.i, i64 %.100.i.i, i64 0
  %.idx.1.i.i = shl i64 %.13.i44.1.i.i, 4
  %195 = getelementptr i8, ptr %191, i64 %.idx.1.i.i
  %.734.1.i.i = getelementptr double, ptr %195, i64 %.720.1.i.i
  %.735.1.i.i = load double, ptr %.734.1.i.i, align 8, !noalias !38
  %.767.1.i.i = fmul contract double %.735.1.i.i, %.735.1.i.i
  %196 = getelementptr i8, ptr %195, i64 8
  %.798.1.i.i = getelementptr double, ptr %196, i64 %.720.1.i.i
  %.799.1.i.i = load double, ptr %.798.1.i.i, align 8, !noalias !38
  %.832.1.i.i = fmul contract double %.799.1.i.i, %.799.1.i.i
  %.833.1.i.i = fadd contract double %.767.1.i.i, %.832.1.i.i
  %.834.1.i.i = tail call contract double @llvm.sqrt.f64(double %.833.1.i.i)
  %.839.1.i.i = fcmp contract one double %.834.1.i.i, 0x7FF0000000000000
  %"$phi654.1.2.1.1.i.i" = select i1 %.839.1.i.i, double %.834.1.i.i, double 0.000000e+00
  store double %"$phi654.1.2.1.1.i.i", ptr %scevgep144.1.i.i, align 8, !noalias !38
  store double 0.000000e+00, ptr %scevgep143.1.i.i, align 8, !noalias !38
  store double 1.000000e+00, ptr %scevgep141.1.i.i, align 8, !noalias !38
  %197 = or disjoint i64 %.386320322.i, 2
  %.13.i44.2.i.i = tail call i64 @llvm.smin.i64(i64 %.676.i.i, i64 %197)
  %.719.2.i.i = icmp slt i64 %.13.i44.2.i.i, 0
  %.720.2.i.i = select i1 %.719.2.i.i, i64 %.100.i.i, i64 0
  %.idx.2.i.i = shl i64 %.13.i44.2.i.i, 4
  %198 = getelementptr i8, ptr %191, i64 %.idx.2.i.i
  %.734.2.i.i = getelementptr double, ptr %198, i64 %.720.2.i.i
  %.735.2.i.i = load double, ptr %.734.2.i.i, align 8, !noalias !38
  %.767.2.i.i = fmul contract double %.735.2.i.i, %.735.2.i.i
  %199 = getelementptr i8, ptr %198, i64 8
  %.798.2.i.i = getelementptr double, ptr %199, i64 %.720.2.i.i
  %.799.2.i.i = load double, ptr %.798.2.i.i, align 8, !noalias !38
  %.832.2.i.i = fmul contract double %.799.2.i.i, %.799.2.i.i
  %.833.2.i.i = fadd contract double %.767.2.i.i, %.832.2.i.i
  %.834.2.i.i = tail call contract double @llvm.sqrt.f64(double %.833.2.i.i)
  %.839.2.i.i = fcmp contract one double %.834.2.i.i, 0x7FF0000000000000
  %"$phi654.1.2.1.2.i.i" = select i1 %.839.2.i.i, double %.834.2.i.i, double 0.000000e+00
  store double %"$phi654.1.2.1.2.i.i", ptr %scevgep144.2.i.i, align 8, !noalias !38
  store double 0.000000e+00, ptr %scevgep143.2.i.i, align 8, !noalias !38
  store double 1.000000e+00, ptr %scevgep141.2.i.i, align 8, !noalias !38
  %200 = or disjoint i64 %.386320322.i, 3
  %.13.i44.3.i.i = tail call i64 @llvm.smin.i64(i64 %.676.i.i, i64 %200)
  %.719.3.i.i = icmp slt i64 %.13.i44.3.i.i, 0
  %.720.3.i.i = select i1 %.719.3.i.i, i64 %.100.i.i, i64 0
  %.idx.3.i.i = shl i64 %.13.i44.3.i.i, 4
  %201 = getelementptr i8, ptr %191, i64 %.idx.3.i.i
  %.734.3.i.i = getelementptr double, ptr %201, i64 %.720.3.i.i
  %.735.3.i.i = load double, ptr %.734.3.i.i, align 8, !noalias !38
  %.767.3.i.i = fmul contract double %.735.3.i.i, %.735.3.i.i
  %202 = getelementptr i8, ptr %201, i64 8
  %.798.3.i.i = getelementptr double, ptr %202, i64 %.720.3.i.i
  %.799.3.i.i = load double, ptr %.798.3.i.i, align 8, !noalias !38
  %.832.3.i.i = fmul contract double %.799.3.i.i, %.799.3.i.i
  %.833.3.i.i = fadd contract double %.767.3.i.i, %.832.3.i.i
  %.834.3.i.i = tail call contract double @llvm.sqrt.f64(double %.833.3.i.i)
  %.839.3.i.i = fcmp contract one double %.834.3.i.i, 0x7FF0000000000000
  %"$phi654.1.2.1.3.i.i" = select i1 %.839.3.i.i, double %.834.3.i.i, double 0.000000e+00
  store double %"$phi654.1.2.1.3.i.i", ptr %scevgep144.3.i.i, align 8, !noalias !38
  store double 0.000000e+00, ptr %scevgep143.3.i.i, align 8, !noalias !38
  store double 1.000000e+00, ptr %scevgep141.3.i.i, align 8, !noalias !38
  %203 = or disjoint i64 %.386320322.i, 4
  %.13.i44.4.i.i = tail call i64 @llvm.smin.i64(i64 %.676.i.i, i64 %203)
  %.719.4.i.i = icmp slt i64 %.13.i44.4.i.i, 0
  %.720.4.i.i = select i1 %.719.4.i.i, i64 %.100.i.i, i64 0
  %.idx.4.i.i = shl i64 %.13.i44.4.i.i, 4
  %204 = getelementptr i8, ptr %191, i64 %.idx.4.i.i
  %.734.4.i.i = getelementptr double, ptr %204, i64 %.720.4.i.i
  %.735.4.i.i = load double, ptr %.734.4.i.i, align 8, !noalias !38
  %.767.4.i.i = fmul contract double %.735.4.i.i, %.735.4.i.i
  %205 = getelementptr i8, ptr %204, i64 8
  %.798.4.i.i = getelementptr double, ptr %205, i64 %.720.4.i.i
  %.799.4.i.i = load double, ptr %.798.4.i.i, align 8, !noalias !38
  %.832.4.i.i = fmul contract double %.799.4.i.i, %.799.4.i.i
  %.833.4.i.i = fadd contract double %.767.4.i.i, %.832.4.i.i
  %.834.4.i.i = tail call contract double @llvm.sqrt.f64(double %.833.4.i.i)
  %.839.4.i.i = fcmp contract one double %.834.4.i.i, 0x7FF0000000000000
  %"$phi654.1.2.1.4.i.i" = select i1 %.839.4.i.i, double %.834.4.i.i, double 0.000000e+00
  store double %"$phi654.1.2.1.4.i.i", ptr %scevgep144.4.i.i, align 8, !noalias !38
  store double 0.000000e+00, ptr %scevgep143.4.i.i, align 8, !noalias !38
  store double 1.000000e+00, ptr %scevgep141.4.i.i, align 8, !noalias !38
  %206 = or disjoint i64 %.386320322.i, 5
  %.13.i44.5.i.i = tail call i64 @llvm.smin.i64(i64 %.676.i.i, i64 %206)
  %.719.5.i.i = icmp slt i64 %.13.i44.5.i.i, 0
  %.720.5.i.i = select i1 %.719.5.i.i, i64 %.100.i.i, i64 0
  %.idx.5.i.i = shl i64 %.13.i44.5.i.i, 4
  %207 = getelementptr i8, ptr %191, i64 %.idx.5.i.i
  %.734.5.i.i = getelementptr double, ptr %207, i64 %.720.5.i.i
  %.735.5.i.i = load double, ptr %.734.5.i.i, align 8, !noalias !38
  %.767.5.i.i = fmul contract double %.735.5.i.i, %.735.5.i.i
  %208 = getelementptr i8, ptr %207, i64 8
  %.798.5.i.i = getelementptr double, ptr %208, i64 %.720.5.i.i
  %.799.5.i.i = load double, ptr %.798.5.i.i, align 8, !noalias !38
  %.832.5.i.i = fmul contract double %.799.5.i.i, %.799.5.i.i
  %.833.5.i.i = fadd contract double %.767.5.i.i, %.832.5.i.i
  %.834.5.i.i = tail call contract double @llvm.sqrt.f64(double %.833.5.i.i)
  %.839.5.i.i = fcmp contract one double %.834.5.i.i, 0x7FF0000000000000
  %"$phi654.1.2.1.5.i.i" = select i1 %.839.5.i.i, double %.834.5.i.i, double 0.000000e+00
  store double %"$phi654.1.2.1.5.i.i", ptr %scevgep144.5.i.i, align 8, !noalias !38
  store double 0.000000e+00, ptr %scevgep143.5.i.i, align 8, !noalias !38
  store double 1.000000e+00, ptr %scevgep141.5.i.i, align 8, !noalias !38
  %209 = or disjoint i64 %.386320322.i, 6
  %.13.i44.6.i.i = tail call i64 @llvm.smin.i64(i64 %.676.i.i, i64 %209)
  %.719.6.i.i = icmp slt i64 %.13.i44.6.i.i, 0
  %.720.6.i.i = select i1 %.719.6.i.i, i64 %.100.i.i, i64 0
  %.idx.6.i.i = shl i64 %.13.i44.6.i.i, 4
  %210 = getelementptr i8, ptr %191, i64 %.idx.6.i.i
  %.734.6.i.i = getelementptr double, ptr %210, i64 %.720.6.i.i
  %.735.6.i.i = load double, ptr %.734.6.i.i, align 8, !noalias !38
  %.767.6.i.i = fmul contract double %.735.6.i.i, %.735.6.i.i
  %211 = getelementptr i8, ptr %210, i64 8
  %.798.6.i.i = getelementptr double, ptr %211, i64 %.720.6.i.i
  %.799.6.i.i = load double, ptr %.798.6.i.i, align 8, !noalias !38
  %.832.6.i.i = fmul contract double %.799.6.i.i, %.799.6.i.i
  %.833.6.i.i = fadd contract double %.767.6.i.i, %.832.6.i.i
  %.834.6.i.i = tail call contract double @llvm.sqrt.f64(double %.833.6.i.i)
  %.839.6.i.i = fcmp contract one double %.834.6.i.i, 0x7FF0000000000000
  %"$phi654.1.2.1.6.i.i" = select i1 %.839.6.i.i, double %.834.6.i.i, double 0.000000e+00
  store double %"$phi654.1.2.1.6.i.i", ptr %scevgep144.6.i.i, align 8, !noalias !38
  store double 0.000000e+00, ptr %scevgep143.6.i.i, align 8, !noalias !38
  store double 1.000000e+00, ptr %scevgep141.6.i.i, align 8, !noalias !38
  %212 = or disjoint i64 %.386320322.i, 7
  %.13.i44.7.i.i = tail call i64 @llvm.smin.i64(i64 %.676.i.i, i64 %212)
  %.719.7.i.i = icmp slt i64 %.13.i44.7.i.i, 0
  %.720.7.i.i = select i1 %.719.7.i.i, i64 %.100.i.i, i64 0
  %.idx.7.i.i = shl i64 %.13.i44.7.i.i, 4
  %213 = getelementptr i8, ptr %191, i64 %.idx.7.i.i
  %.734.7.i.i = getelementptr double, ptr %213, i64 %.720.7.i.i
  %.735.7.i.i = load double, ptr %.734.7.i.i, align 8, !noalias !38
  %.767.7.i.i = fmul contract double %.735.7.i.i, %.735.7.i.i
  %214 = getelementptr i8, ptr %213, i64 8
  %.798.7.i.i = getelementptr double, ptr %214, i64 %.720.7.i.i
  %.799.7.i.i = load double, ptr %.798.7.i.i, align 8, !noalias !38
  %.832.7.i.i = fmul contract double %.799.7.i.i, %.799.7.i.i
  %.833.7.i.i = fadd contract double %.767.7.i.i, %.832.7.i.i
  %.834.7.i.i = tail call contract double @llvm.sqrt.f64(double %.833.7.i.i)
  %.839.7.i.i = fcmp contract one double %.834.7.i.i, 0x7FF0000000000000
  %"$phi654.1.2.1.7.i.i" = select i1 %.839.7.i.i, double %.834.7.i.i, double 0.000000e+00
  store double %"$phi654.1.2.1.7.i.i", ptr %scevgep144.7.i.i, align 8, !noalias !38
  store double 0.000000e+00, ptr %scevgep143.7.i.i, align 8, !noalias !38
  store double 1.000000e+00, ptr %scevgep141.7.i.i, align 8, !noalias !38
  store ptr null, ptr %.1029.i.i, align 8, !noalias !38
  call fastcc void @inner_3(ptr nonnull %.1029.i.i, ptr nonnull %2, i64 8, ptr nonnull readonly %arg.arguments, ptr nonnull %.975.i.i, ptr nonnull %scevgep143.i.i, i64 8)
  %.1093.i.i = load i64, ptr %.1092.i.i, align 8, !noalias !38
  %.1094.not.i.i = icmp eq i64 %.1093.i.i, 0
  br i1 %.1094.not.i.i, label %B862.i.i, label %B828.i.i

B828.i.i:                                         ; preds = %B340.if.i
  store ptr null, ptr %.1100.i.i, align 8, !noalias !38
  call fastcc void @inner_4(ptr nonnull %.1100.i.i, ptr nonnull %2, i64 8, ptr nonnull %scevgep141.i6.i, ptr nonnull readonly %arg.arguments)
  br label %B862.i.i

B862.i.i:                                         ; preds = %B828.i.i, %B340.if.i
  %.1133.i.i = sub nsw i64 %.64.i.i, %.386320322.i
  %.13.i.i7.i = tail call i64 @llvm.smin.i64(i64 %.1133.i.i, i64 8)
  %.12411095.not.i.i = icmp slt i64 %.1133.i.i, 1
  br i1 %.12411095.not.i.i, label %_ZN17bnserve_inference15marginal_kernel7_source12_over_phasesB2v7B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i, label %B936.if.lr.ph.i.i

B1082.i.i:                                        ; preds = %B936.if.i.i
  %215 = shl i64 %.124710931096.i.i, 3
  %scevgep124.i12.i = getelementptr i8, ptr %2, i64 %215
  %scevgep125.i13.i = getelementptr i8, ptr %scevgep124.i12.i, i64 64
  %.1403.i.i = load double, ptr %scevgep125.i13.i, align 8, !noalias !38
  %216 = select i1 %.1303.i.i, i64 %225, i64 0
  %scevgep138.i14.i = getelementptr i8, ptr %scevgep137.i9.i, i64 %216
  %scevgep12.i.i = getelementptr i8, ptr %scevgep138.i14.i, i64 %215
  %.1434.i15.i = load double, ptr %scevgep12.i.i, align 8, !noalias !38
  %.1435.i.i = fmul contract double %.1434.i15.i, 5.000000e-01
  %.1436.i.i = fsub contract double %.1403.i.i, %.1435.i.i
  %.1467.i16.i = load double, ptr %scevgep124.i12.i, align 8, !noalias !38
  %.1468.i.i = fadd contract double %.1467.i16.i, %.1436.i.i
  br label %B1162.i.i

B1162.i.i:                                        ; preds = %B936.if.i.i, %B1082.i.i
  %"$phi1162.1.2.1.i.i" = phi double [ %.1468.i.i, %B1082.i.i ], [ 0x7FF8000000000000, %B936.if.i.i ]
  %217 = select i1 %.1303.i.i, i64 %225, i64 0
  %scevgep135.i.i = getelementptr i8, ptr %scevgep134.i8.i, i64 %217
  %218 = shl i64 %.124710931096.i.i, 3
  %scevgep136.i17.i = getelementptr i8, ptr %scevgep135.i.i, i64 %218
  store double %"$phi1162.1.2.1.i.i", ptr %scevgep136.i17.i, align 8, !noalias !38
  %.1539.i.i = load i64, ptr %.1092.i.i, align 8, !noalias !38
  %.1540.not.i.i = icmp eq i64 %.1539.i.i, 0
  br i1 %.1540.not.i.i, label %B1526.i.i, label %B1214.i.i

B1214.i.i:                                        ; preds = %B1162.i.i
  %scevgep11.i.i = getelementptr i8, ptr %2, i64 %218
  %.1660.i.i = load double, ptr %scevgep11.i.i, align 8, !noalias !38
  %.1660.fr.i.i = freeze double %.1660.i.i
  %.1661.i.i = fcmp contract ogt double %.1660.fr.i.i, 0.000000e+00
  %scevgep7.i.i = getelementptr i8, ptr %scevgep11.i.i, i64 128
  %.1693.i.i = load double, ptr %scevgep7.i.i, align 8, !noalias !38
  %.1730.i.i = fdiv contract double %.1693.i.i, %.1660.fr.i.i
  %"$phi1362.1.2.2.i.i" = select i1 %.1661.i.i, double %.1730.i.i, double %.1693.i.i
  %219 = fcmp one double %.1366.i.i, 0x7FF0000000000000
  %.1783.i.i = fmul contract double %.1319.i.i, %"$phi1362.1.2.2.i.i"
  %.1787.i.i = fneg contract double %"$phi1362.1.2.2.i.i"
  %.1791.i.i = fmul contract double %.1352.i.i, %.1787.i.i
  %"$phi1436.1.2.sroa.8.2.i.i" = select i1 %219, double %.1791.i.i, double 0x7FF8000000000000
  %"$phi1436.1.2.sroa.0.2.i.i" = select i1 %219, double %.1783.i.i, double 0x7FF8000000000000
  %sunkaddr145.i.i = inttoptr i64 %lsr.iv.i11.i to ptr
  %sunkaddr146.i.i = getelementptr i8, ptr %sunkaddr145.i.i, i64 %.1539.i.i
  store double %"$phi1436.1.2.sroa.0.2.i.i", ptr %sunkaddr146.i.i, align 8, !noalias !38
  %sunkaddr149.i.i = getelementptr i8, ptr %sunkaddr146.i.i, i64 8
  store double %"$phi1436.1.2.sroa.8.2.i.i", ptr %sunkaddr149.i.i, align 8, !noalias !38
  %.1941.i.i = load i64, ptr %sunkaddr13.i.i, align 8, !noalias !38
  %.1943.i.i = inttoptr i64 %.1941.i.i to ptr
  %scevgep131.i.i = getelementptr i8, ptr %.1943.i.i, i64 %217
  %scevgep132.i.i = getelementptr i8, ptr %scevgep131.i.i, i64 %223
  %scevgep1.i.i = getelementptr i8, ptr %scevgep132.i.i, i64 %218
  store double -5.000000e-01, ptr %scevgep1.i.i, align 8, !noalias !38
  br label %B1526.i.i

B1526.i.i:                                        ; preds = %B1214.i.i, %B1162.i.i
  %lsr.iv.next.i18.i = add i64 %lsr.iv.i11.i, 16
  %exitcond1102.not.i.i = icmp eq i64 %.13.i.i7.i, %.1254.i.i
  br i1 %exitcond1102.not.i.i, label %_ZN17bnserve_inference15marginal_kernel7_source12_over_phasesB2v7B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i, label %B936.if.i.i

B936.if.lr.ph.i.i:                                ; preds = %B862.i.i
  %220 = inttoptr i64 %.267.i.i to ptr
  %221 = inttoptr i64 %.187.i.i to ptr
  %222 = shl i64 %.386320322.i, 4
  %223 = shl i64 %.386320322.i, 3
  %scevgep134.i8.i = getelementptr i8, ptr %220, i64 %223
  %scevgep137.i9.i = getelementptr i8, ptr %221, i64 %223
  %224 = shl i64 %.64.i.i, 4
  %225 = shl i64 %.64.i.i, 3
  %scevgep.i10.i = getelementptr i8, ptr %191, i64 8
  br label %B936.if.i.i

B936.if.i.i:                                      ; preds = %B936.if.lr.ph.i.i, %B1526.i.i
  %lsr.iv.i11.i = phi i64 [ %222, %B936.if.lr.ph.i.i ], [ %lsr.iv.next.i18.i, %B1526.i.i ]
  %.124710931096.i.i = phi i64 [ 0, %B936.if.lr.ph.i.i ], [ %.1254.i.i, %B1526.i.i ]
  %.1254.i.i = add nuw nsw i64 %.124710931096.i.i, 1
  %226 = add i64 %.124710931096.i.i, %.386320322.i
  %.1303.i.i = icmp slt i64 %226, 0
  %227 = select i1 %.1303.i.i, i64 %224, i64 0
  %scevgep3.i.i = getelementptr i8, ptr %scevgep.i10.i, i64 %227
  %scevgep4.i.i = getelementptr i8, ptr %scevgep3.i.i, i64 %lsr.iv.i11.i
  %scevgep5.i.i = getelementptr i8, ptr %scevgep4.i.i, i64 -8
  %.1319.i.i = load double, ptr %scevgep5.i.i, align 8, !noalias !38
  %.1352.i.i = load double, ptr %scevgep4.i.i, align 8, !noalias !38
  %.1361.i.i = fmul contract double %.1319.i.i, %.1319.i.i
  %.1364.i.i = fmul contract double %.1352.i.i, %.1352.i.i
  %.1365.i.i = fadd contract double %.1361.i.i, %.1364.i.i
  %.1366.i.i = tail call contract double @llvm.sqrt.f64(double %.1365.i.i)
  %.1367.i.i = fcmp contract ueq double %.1366.i.i, 0x7FF0000000000000
  br i1 %.1367.i.i, label %B1162.i.i, label %B1082.i.i

_ZN17bnserve_inference15marginal_kernel7_source12_over_phasesB2v7B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i: ; preds = %B1526.i.i, %B862.i.i
  call void @llvm.lifetime.end.p0(ptr nonnull %.1029.i.i), !noalias !0
  call void @llvm.lifetime.end.p0(ptr nonnull %.1100.i.i), !noalias !0
  %.393.i = add nuw i64 %.386320322.i, 8
  %lsr.iv.next8.i = add nsw i64 %lsr.iv7.i, -1
  %.380.i = icmp sgt i64 %lsr.iv7.i, 3
  br i1 %.380.i, label %B340.if.i, label %_ZN17bnserve_inference15marginal_kernel7_source9integrateB2v3B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIxLi1E1C7mutable7alignedE.exit

B446.if.i:                                        ; preds = %B558.i, %B446.if.preheader.i
  %.581313316.i = phi i64 [ %.588.i, %B558.i ], [ 0, %B446.if.preheader.i ]
  %.588.i = add nuw nsw i64 %.581313316.i, 1
  br i1 %3, label %B482.i, label %B520.i

_ZN17bnserve_inference15marginal_kernel7_source9integrateB2v3B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIxLi1E1C7mutable7alignedE.exit: ; preds = %B558.i, %_ZN17bnserve_inference15marginal_kernel7_source12_over_phasesB2v7B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i, %B264.i, %B384.i
  store i64 0, ptr %retptr, align 8
  ret i32 0
}

; Function Attrs: mustprogress nocallback nofree nounwind willreturn memory(argmem: write)
declare void @llvm.memset.p0.i64(ptr writeonly captures(none), i8, i64, i1 immarg) #1

; Function Attrs: mustprogress nocallback nocreateundeforpoison nofree nosync nounwind speculatable willreturn memory(none)
declare i64 @llvm.smin.i64(i64, i64) #2

; Function Attrs: mustprogress nocallback nocreateundeforpoison nofree nosync nounwind speculatable willreturn memory(none)
declare double @llvm.sqrt.f64(double) #2

; Function Attrs: nofree norecurse nosync nounwind memory(read, argmem: readwrite, inaccessiblemem: none, target_mem0: none, target_mem1: none)
define internal fastcc void @inner_3(ptr noalias nonnull writeonly captures(none) %retptr, ptr readonly captures(none) %arg.x.4, i64 %arg.x.5.0, ptr readonly captures(none) %arg.arguments.4, ptr captures(none) %arg.room.4, ptr captures(none) %arg.out.4, i64 %arg.out.5.0) unnamed_addr #3 {
entry:
  %0 = add nuw i64 %arg.x.5.0, 7
  %.364 = lshr i64 %0, 3
  %.343.inv = icmp slt i64 %arg.x.5.0, 1
  %.3853095.not3101 = icmp eq i64 %.364, 0
  %.3853095.not = select i1 %.343.inv, i1 true, i1 %.3853095.not3101
  br i1 %.3853095.not, label %B2076, label %B272.lr.ph

B272:                                             ; preds = %B746.if, %B272.lr.ph
  %.375.sroa.0.03100 = phi i64 [ 0, %B272.lr.ph ], [ %.375.sroa.0.0, %B746.if ]
  %.332.13099.in = phi i64 [ %16, %B272.lr.ph ], [ %34, %B746.if ]
  %.329.13098 = phi i64 [ 8, %B272.lr.ph ], [ %.329.1, %B746.if ]
  %.434 = getelementptr inbounds double, ptr %arg.x.4, i64 %.375.sroa.0.03100
  %.436 = load <8 x double>, ptr %.434, align 8
  %.8.i = fsub contract <8 x double> zeroinitializer, %.436
  %.486 = tail call <8 x double> @llvm.minnum.v8f64(<8 x double> %.8.i, <8 x double> splat (double -8.000000e+00))
  %.8.i3110 = fsub contract <8 x double> zeroinitializer, %.486
  %.8.i3111 = fdiv contract <8 x double> splat (double 1.600000e+01), %.8.i3110
  %.8.i3112 = fadd contract <8 x double> %.8.i3111, splat (double -1.000000e+00)
  br i1 %23, label %B432.if.preheader, label %B460

B432.if.preheader:                                ; preds = %B272
  %.8.i3113 = fmul contract <8 x double> %.8.i3112, splat (double 2.000000e+00)
  br label %B432.if

B460:                                             ; preds = %B432.if, %B272
  %_large_bessel_v21_two.2.1.lcssa = phi <8 x double> [ zeroinitializer, %B272 ], [ %_large_bessel_v21_one.2.13835, %B432.if ]
  %_large_bessel_v21_one.2.1.lcssa = phi <8 x double> [ zeroinitializer, %B272 ], [ %.766, %B432.if ]
  %.785 = load double, ptr %15, align 8
  %.6.i = insertelement <8 x double> poison, double %.785, i64 0
  %.7.i = shufflevector <8 x double> %.6.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.8.i3102 = fsub contract <8 x double> %.7.i, %_large_bessel_v21_two.2.1.lcssa
  %.820 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i3112, <8 x double> %_large_bessel_v21_one.2.1.lcssa, <8 x double> %.8.i3102)
  %.6.i3117 = fmul contract <8 x double> %.820, %.820
  %.6.i3118 = fdiv contract <8 x double> %.6.i3117, %.8.i3110
  %1 = bitcast <8 x double> %.6.i3118 to <8 x i64>
  %.8.i3119 = add <8 x i64> %1, splat (i64 -4604544271217802189)
  %.8.i3120 = ashr <8 x i64> %.8.i3119, splat (i64 52)
  %.8.i3121 = and <8 x i64> %.8.i3119, splat (i64 -4503599627370496)
  %.6.i3122 = sub <8 x i64> %1, %.8.i3121
  %2 = bitcast <8 x i64> %.6.i3122 to <8 x double>
  %.8.i3123 = fadd contract <8 x double> %2, splat (double -1.000000e+00)
  %.8.i3124 = fadd contract <8 x double> %.8.i3123, splat (double 2.000000e+00)
  %.6.i3125 = fdiv contract <8 x double> %.8.i3123, %.8.i3124
  %.6.i3126 = fmul contract <8 x double> %.6.i3125, %.6.i3125
  %.6.i3127 = fmul contract <8 x double> %.6.i3126, %.6.i3126
  %.8.i3128 = fmul contract <8 x double> %.6.i3127, splat (double 0x3FC39A09D078C69F)
  %.8.i3129 = fadd contract <8 x double> %.8.i3128, splat (double 0x3FCC71C51D8E78AF)
  %.6.i3130 = fmul contract <8 x double> %.6.i3127, %.8.i3129
  %.8.i3131 = fadd contract <8 x double> %.6.i3130, splat (double 0x3FD999999997FA04)
  %.6.i3132 = fmul contract <8 x double> %.6.i3127, %.8.i3131
  %.8.i3133 = fmul contract <8 x double> %.6.i3127, splat (double 0x3FC2F112DF3E5244)
  %.8.i3134 = fadd contract <8 x double> %.8.i3133, splat (double 0x3FC7466496CB03DE)
  %.6.i3135 = fmul contract <8 x double> %.6.i3127, %.8.i3134
  %.8.i3136 = fadd contract <8 x double> %.6.i3135, splat (double 0x3FD2492494229359)
  %.6.i3137 = fmul contract <8 x double> %.6.i3127, %.8.i3136
  %.8.i3138 = fadd contract <8 x double> %.6.i3137, splat (double 0x3FE5555555555593)
  %.6.i3139 = fmul contract <8 x double> %.6.i3126, %.8.i3138
  %.6.i3140 = fadd contract <8 x double> %.6.i3132, %.6.i3139
  %.8.i3141 = fmul contract <8 x double> %.8.i3123, splat (double 5.000000e-01)
  %.6.i3142 = fmul contract <8 x double> %.8.i3123, %.8.i3141
  %.8.i3143 = add nsw <8 x i64> %.8.i3120, splat (i64 4843621399236968448)
  %3 = bitcast <8 x i64> %.8.i3143 to <8 x double>
  %.8.i3144 = fadd contract <8 x double> %3, splat (double 0xC338000000000000)
  %.8.i3145 = fmul contract <8 x double> %.8.i3144, splat (double 0x3FE62E42FEE00000)
  %.6.i3146 = fadd contract <8 x double> %.6.i3142, %.6.i3140
  %.6.i3147 = fmul contract <8 x double> %.6.i3125, %.6.i3146
  %.8.i3148 = fmul contract <8 x double> %.8.i3144, splat (double 0x3DEA39EF35793C76)
  %.6.i3149 = fadd contract <8 x double> %.8.i3148, %.6.i3147
  %.6.i3150 = fsub contract <8 x double> %.6.i3142, %.6.i3149
  %.6.i3151 = fsub contract <8 x double> %.6.i3150, %.8.i3123
  %.6.i3152 = fsub contract <8 x double> %.8.i3145, %.6.i3151
  %.8.i3153 = fmul contract <8 x double> %.6.i3152, splat (double 5.000000e-01)
  store <8 x double> %.8.i3153, ptr %arg.room.4, align 8
  %.1749 = icmp slt i64 %.375.sroa.0.03100, 0
  %.1750 = select i1 %.1749, i64 %arg.x.5.0, i64 0
  %.1764 = getelementptr double, ptr %.434, i64 %.1750
  %.1765 = load double, ptr %.1764, align 8
  %.1864.6 = add i64 %.375.sroa.0.03100, 7
  %4 = getelementptr double, ptr %arg.x.4, i64 %.1864.6
  %.1906.7 = icmp slt i64 %.1864.6, 0
  %.1907.7 = select i1 %.1906.7, i64 %arg.x.5.0, i64 0
  %.1921.7 = getelementptr double, ptr %4, i64 %.1907.7
  %.1922.7 = load double, ptr %.1921.7, align 8
  %.1864.5 = add i64 %.375.sroa.0.03100, 6
  %5 = getelementptr double, ptr %arg.x.4, i64 %.1864.5
  %.1906.6 = icmp slt i64 %.1864.5, 0
  %.1907.6 = select i1 %.1906.6, i64 %arg.x.5.0, i64 0
  %.1921.6 = getelementptr double, ptr %5, i64 %.1907.6
  %.1922.6 = load double, ptr %.1921.6, align 8
  %.1864.4 = add i64 %.375.sroa.0.03100, 5
  %6 = getelementptr double, ptr %arg.x.4, i64 %.1864.4
  %.1906.5 = icmp slt i64 %.1864.4, 0
  %.1907.5 = select i1 %.1906.5, i64 %arg.x.5.0, i64 0
  %.1921.5 = getelementptr double, ptr %6, i64 %.1907.5
  %.1922.5 = load double, ptr %.1921.5, align 8
  %.1864.3 = add i64 %.375.sroa.0.03100, 4
  %7 = getelementptr double, ptr %arg.x.4, i64 %.1864.3
  %.1906.4 = icmp slt i64 %.1864.3, 0
  %.1907.4 = select i1 %.1906.4, i64 %arg.x.5.0, i64 0
  %.1921.4 = getelementptr double, ptr %7, i64 %.1907.4
  %.1922.4 = load double, ptr %.1921.4, align 8
  %.1864.2 = add i64 %.375.sroa.0.03100, 3
  %8 = getelementptr double, ptr %arg.x.4, i64 %.1864.2
  %.1906.3 = icmp slt i64 %.1864.2, 0
  %.1907.3 = select i1 %.1906.3, i64 %arg.x.5.0, i64 0
  %.1921.3 = getelementptr double, ptr %8, i64 %.1907.3
  %.1922.3 = load double, ptr %.1921.3, align 8
  %.1864.1 = add i64 %.375.sroa.0.03100, 2
  %9 = getelementptr double, ptr %arg.x.4, i64 %.1864.1
  %.1906.2 = icmp slt i64 %.1864.1, 0
  %.1907.2 = select i1 %.1906.2, i64 %arg.x.5.0, i64 0
  %.1921.2 = getelementptr double, ptr %9, i64 %.1907.2
  %.1922.2 = load double, ptr %.1921.2, align 8
  %.1864 = add i64 %.375.sroa.0.03100, 1
  %10 = getelementptr double, ptr %arg.x.4, i64 %.1864
  %.1906.1 = icmp slt i64 %.1864, 0
  %.1907.1 = select i1 %.1906.1, i64 %arg.x.5.0, i64 0
  %.1921.1 = getelementptr double, ptr %10, i64 %.1907.1
  %.1922.1 = load double, ptr %.1921.1, align 8
  %.1924.1 = fcmp contract olt double %.1922.1, %.1765
  %.1922.least.2.1.1 = select i1 %.1924.1, double %.1922.1, double %.1765
  %.1924.2 = fcmp contract olt double %.1922.2, %.1922.least.2.1.1
  %.1922.least.2.1.2 = select i1 %.1924.2, double %.1922.2, double %.1922.least.2.1.1
  %.1924.3 = fcmp contract olt double %.1922.3, %.1922.least.2.1.2
  %.1922.least.2.1.3 = select i1 %.1924.3, double %.1922.3, double %.1922.least.2.1.2
  %.1924.4 = fcmp contract olt double %.1922.4, %.1922.least.2.1.3
  %.1922.least.2.1.4 = select i1 %.1924.4, double %.1922.4, double %.1922.least.2.1.3
  %.1924.5 = fcmp contract olt double %.1922.5, %.1922.least.2.1.4
  %.1922.least.2.1.5 = select i1 %.1924.5, double %.1922.5, double %.1922.least.2.1.4
  %.1924.6 = fcmp contract olt double %.1922.6, %.1922.least.2.1.5
  %.1922.least.2.1.6 = select i1 %.1924.6, double %.1922.6, double %.1922.least.2.1.5
  %.1924.7 = fcmp contract olt double %.1922.7, %.1922.least.2.1.6
  %.1922.least.2.1.7 = select i1 %.1924.7, double %.1922.7, double %.1922.least.2.1.6
  %.1984 = fcmp contract olt double %.1922.least.2.1.7, 8.000000e+00
  br i1 %.1984, label %B618, label %B746.if

B618:                                             ; preds = %B460
  %.2010 = tail call <8 x double> @llvm.minnum.v8f64(<8 x double> %.436, <8 x double> splat (double 8.000000e+00))
  %.8.i3103 = fmul contract <8 x double> %.2010, splat (double 2.500000e-01)
  %.6.i3154 = fmul contract <8 x double> %.2010, %.8.i3103
  br i1 %24, label %B684.if, label %B730

B730.loopexit:                                    ; preds = %B684.if
  %11 = bitcast <8 x double> %.2214 to <8 x i64>
  br label %B730

B730:                                             ; preds = %B730.loopexit, %B618
  %_small_bessel_v19_found.2.2.lcssa = phi <8 x i64> [ zeroinitializer, %B618 ], [ %11, %B730.loopexit ]
  %.8.i3104 = add <8 x i64> %_small_bessel_v19_found.2.2.lcssa, splat (i64 -4604544271217802189)
  %.8.i3155 = ashr <8 x i64> %.8.i3104, splat (i64 52)
  %.8.i3156 = and <8 x i64> %.8.i3104, splat (i64 -4503599627370496)
  %.6.i3157 = sub <8 x i64> %_small_bessel_v19_found.2.2.lcssa, %.8.i3156
  %12 = bitcast <8 x i64> %.6.i3157 to <8 x double>
  %.8.i3158 = fadd contract <8 x double> %12, splat (double -1.000000e+00)
  %.8.i3159 = fadd contract <8 x double> %.8.i3158, splat (double 2.000000e+00)
  %.6.i3160 = fdiv contract <8 x double> %.8.i3158, %.8.i3159
  %.6.i3161 = fmul contract <8 x double> %.6.i3160, %.6.i3160
  %.6.i3162 = fmul contract <8 x double> %.6.i3161, %.6.i3161
  %.8.i3163 = fmul contract <8 x double> %.6.i3162, splat (double 0x3FC39A09D078C69F)
  %.8.i3164 = fadd contract <8 x double> %.8.i3163, splat (double 0x3FCC71C51D8E78AF)
  %.6.i3165 = fmul contract <8 x double> %.6.i3162, %.8.i3164
  %.8.i3166 = fadd contract <8 x double> %.6.i3165, splat (double 0x3FD999999997FA04)
  %.6.i3167 = fmul contract <8 x double> %.6.i3162, %.8.i3166
  %.8.i3168 = fmul contract <8 x double> %.6.i3162, splat (double 0x3FC2F112DF3E5244)
  %.8.i3169 = fadd contract <8 x double> %.8.i3168, splat (double 0x3FC7466496CB03DE)
  %.6.i3170 = fmul contract <8 x double> %.6.i3162, %.8.i3169
  %.8.i3171 = fadd contract <8 x double> %.6.i3170, splat (double 0x3FD2492494229359)
  %.6.i3172 = fmul contract <8 x double> %.6.i3162, %.8.i3171
  %.8.i3173 = fadd contract <8 x double> %.6.i3172, splat (double 0x3FE5555555555593)
  %.6.i3174 = fmul contract <8 x double> %.6.i3161, %.8.i3173
  %.6.i3175 = fadd contract <8 x double> %.6.i3167, %.6.i3174
  %.8.i3176 = fmul contract <8 x double> %.8.i3158, splat (double 5.000000e-01)
  %.6.i3177 = fmul contract <8 x double> %.8.i3158, %.8.i3176
  %.8.i3178 = add nsw <8 x i64> %.8.i3155, splat (i64 4843621399236968448)
  %13 = bitcast <8 x i64> %.8.i3178 to <8 x double>
  %.8.i3179 = fadd contract <8 x double> %13, splat (double 0xC338000000000000)
  %.8.i3180 = fmul contract <8 x double> %.8.i3179, splat (double 0x3FE62E42FEE00000)
  %.6.i3181 = fadd contract <8 x double> %.6.i3177, %.6.i3175
  %.6.i3182 = fmul contract <8 x double> %.6.i3160, %.6.i3181
  %.8.i3183 = fmul contract <8 x double> %.8.i3179, splat (double 0x3DEA39EF35793C76)
  %.6.i3184 = fadd contract <8 x double> %.8.i3183, %.6.i3182
  %.6.i3185 = fsub contract <8 x double> %.6.i3177, %.6.i3184
  %.6.i3186 = fsub contract <8 x double> %.6.i3185, %.8.i3158
  %.6.i3187 = fsub contract <8 x double> %.8.i3180, %.6.i3186
  %.6.i3188 = fsub contract <8 x double> %.6.i3187, %.2010
  store <8 x double> %.6.i3188, ptr %sunkaddr7, align 8
  br label %B746.if

B2076:                                            ; preds = %B746.if, %entry
  store ptr null, ptr %retptr, align 8
  ret void

B272.lr.ph:                                       ; preds = %entry
  %.114 = getelementptr i8, ptr %arg.arguments.4, i64 144
  %.115 = load i64, ptr %.114, align 8
  %.2121 = icmp ugt i64 %.115, -9223372036854775808
  %..244.fca.5.0.load = select i1 %.2121, i64 0, i64 %.115
  %.144 = getelementptr i8, ptr %arg.arguments.4, i64 120
  %.145 = load i64, ptr %.144, align 8
  %.85 = getelementptr i8, ptr %arg.arguments.4, i64 128
  %.86 = load i64, ptr %.85, align 8
  %notsub = add i64 %.86, -2
  %.224 = getelementptr i8, ptr %arg.arguments.4, i64 136
  %.225 = load i64, ptr %.224, align 8
  %14 = inttoptr i64 %.225 to ptr
  %15 = inttoptr i64 %.145 to ptr
  %16 = tail call i64 @llvm.smax.i64(i64 %.364, i64 1)
  %smax = tail call i64 @llvm.smax.i64(i64 %notsub, i64 -1)
  %17 = add i64 %smax, 2
  %18 = shl i64 %.86, 3
  %19 = add i64 %..244.fca.5.0.load, 1
  %20 = shl i64 %.115, 3
  %21 = getelementptr i8, ptr %15, i64 %18
  %22 = getelementptr i8, ptr %14, i64 %20
  %23 = icmp ult i64 %notsub, 9223372036854775807
  %24 = icmp sgt i64 %..244.fca.5.0.load, 0
  %sunkaddr7 = getelementptr inbounds nuw i8, ptr %arg.room.4, i64 64
  br label %B272

B432.if:                                          ; preds = %B432.if, %B432.if.preheader
  %lsr.iv2.pn = phi ptr [ %lsr.iv2, %B432.if ], [ %21, %B432.if.preheader ]
  %lsr.iv = phi i64 [ %lsr.iv.next, %B432.if ], [ %17, %B432.if.preheader ]
  %_large_bessel_v21_one.2.13835 = phi <8 x double> [ %.766, %B432.if ], [ zeroinitializer, %B432.if.preheader ]
  %_large_bessel_v21_two.2.13834 = phi <8 x double> [ %_large_bessel_v21_one.2.13835, %B432.if ], [ zeroinitializer, %B432.if.preheader ]
  %lsr.iv2 = getelementptr i8, ptr %lsr.iv2.pn, i64 -8
  %.739 = load double, ptr %lsr.iv2, align 8
  %.6.i3114 = insertelement <8 x double> poison, double %.739, i64 0
  %.7.i3115 = shufflevector <8 x double> %.6.i3114, <8 x double> poison, <8 x i32> zeroinitializer
  %.8.i3116 = fsub contract <8 x double> %.7.i3115, %_large_bessel_v21_two.2.13834
  %.766 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i3113, <8 x double> %_large_bessel_v21_one.2.13835, <8 x double> %.8.i3116)
  %lsr.iv.next = add i64 %lsr.iv, -1
  %.668 = icmp sgt i64 %lsr.iv.next, 1
  br i1 %.668, label %B432.if, label %B460

B684.if:                                          ; preds = %B618, %B684.if
  %lsr.iv5.pn = phi ptr [ %lsr.iv5, %B684.if ], [ %22, %B618 ]
  %lsr.iv3210 = phi i64 [ %lsr.iv.next3211, %B684.if ], [ %19, %B618 ]
  %_small_bessel_v19_found.2.23853 = phi <8 x double> [ %.2214, %B684.if ], [ zeroinitializer, %B618 ]
  %lsr.iv5 = getelementptr i8, ptr %lsr.iv5.pn, i64 -8
  %.2209 = load double, ptr %lsr.iv5, align 8
  %.2212 = insertelement <8 x double> poison, double %.2209, i64 0
  %.2213 = shufflevector <8 x double> %.2212, <8 x double> poison, <8 x i32> zeroinitializer
  %.2214 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i3154, <8 x double> %_small_bessel_v19_found.2.23853, <8 x double> %.2213)
  %lsr.iv.next3211 = add i64 %lsr.iv3210, -1
  %.2163 = icmp sgt i64 %lsr.iv.next3211, 1
  br i1 %.2163, label %B684.if, label %B730.loopexit

B746.if:                                          ; preds = %B730, %B460
  %.3234 = select i1 %.1749, i64 %arg.out.5.0, i64 0
  %25 = getelementptr double, ptr %arg.out.4, i64 %.375.sroa.0.03100
  %.3248 = getelementptr double, ptr %25, i64 %.3234
  %.3249 = load double, ptr %.3248, align 8
  %sunkaddr = shl i64 %.1750, 3
  %sunkaddr8 = getelementptr i8, ptr %.434, i64 %sunkaddr
  %.3282 = load double, ptr %sunkaddr8, align 8
  %.3283 = fcmp contract ult double %.3282, 8.000000e+00
  %"$phi730.5.2.2.in.idx" = select i1 %.3283, i64 64, i64 0
  %"$phi730.5.2.2.in" = getelementptr i8, ptr %arg.room.4, i64 %"$phi730.5.2.2.in.idx"
  %"$phi730.5.2.2" = load double, ptr %"$phi730.5.2.2.in", align 8
  %.3377 = fadd contract double %.3249, %"$phi730.5.2.2"
  store double %.3377, ptr %.3248, align 8
  %.3233.1 = icmp slt i64 %.375.sroa.0.03100, -1
  %.3234.1 = select i1 %.3233.1, i64 %arg.out.5.0, i64 0
  %26 = getelementptr double, ptr %arg.out.4, i64 %.1864
  %.3248.1 = getelementptr double, ptr %26, i64 %.3234.1
  %.3249.1 = load double, ptr %.3248.1, align 8
  %.3267.1 = select i1 %.3233.1, i64 %arg.x.5.0, i64 0
  %.3281.1 = getelementptr double, ptr %10, i64 %.3267.1
  %.3282.1 = load double, ptr %.3281.1, align 8
  %.3283.1 = fcmp contract ult double %.3282.1, 8.000000e+00
  %"$phi730.5.2.2.in.idx.1" = select i1 %.3283.1, i64 64, i64 0
  %sunkaddr3215 = getelementptr i8, ptr %arg.room.4, i64 %"$phi730.5.2.2.in.idx.1"
  %sunkaddr3216 = getelementptr i8, ptr %sunkaddr3215, i64 8
  %"$phi730.5.2.2.1" = load double, ptr %sunkaddr3216, align 8
  %.3377.1 = fadd contract double %.3249.1, %"$phi730.5.2.2.1"
  store double %.3377.1, ptr %.3248.1, align 8
  %.3233.2 = icmp slt i64 %.375.sroa.0.03100, -2
  %.3234.2 = select i1 %.3233.2, i64 %arg.out.5.0, i64 0
  %27 = getelementptr double, ptr %arg.out.4, i64 %.1864.1
  %.3248.2 = getelementptr double, ptr %27, i64 %.3234.2
  %.3249.2 = load double, ptr %.3248.2, align 8
  %.3267.2 = select i1 %.3233.2, i64 %arg.x.5.0, i64 0
  %.3281.2 = getelementptr double, ptr %9, i64 %.3267.2
  %.3282.2 = load double, ptr %.3281.2, align 8
  %.3283.2 = fcmp contract ult double %.3282.2, 8.000000e+00
  %"$phi730.5.2.2.in.idx.2" = select i1 %.3283.2, i64 64, i64 0
  %sunkaddr3217 = getelementptr i8, ptr %arg.room.4, i64 %"$phi730.5.2.2.in.idx.2"
  %sunkaddr3218 = getelementptr i8, ptr %sunkaddr3217, i64 16
  %"$phi730.5.2.2.2" = load double, ptr %sunkaddr3218, align 8
  %.3377.2 = fadd contract double %.3249.2, %"$phi730.5.2.2.2"
  store double %.3377.2, ptr %.3248.2, align 8
  %.3233.3 = icmp slt i64 %.375.sroa.0.03100, -3
  %.3234.3 = select i1 %.3233.3, i64 %arg.out.5.0, i64 0
  %28 = getelementptr double, ptr %arg.out.4, i64 %.1864.2
  %.3248.3 = getelementptr double, ptr %28, i64 %.3234.3
  %.3249.3 = load double, ptr %.3248.3, align 8
  %.3267.3 = select i1 %.3233.3, i64 %arg.x.5.0, i64 0
  %.3281.3 = getelementptr double, ptr %8, i64 %.3267.3
  %.3282.3 = load double, ptr %.3281.3, align 8
  %.3283.3 = fcmp contract ult double %.3282.3, 8.000000e+00
  %"$phi730.5.2.2.in.idx.3" = select i1 %.3283.3, i64 64, i64 0
  %sunkaddr3219 = getelementptr i8, ptr %arg.room.4, i64 %"$phi730.5.2.2.in.idx.3"
  %sunkaddr3220 = getelementptr i8, ptr %sunkaddr3219, i64 24
  %"$phi730.5.2.2.3" = load double, ptr %sunkaddr3220, align 8
  %.3377.3 = fadd contract double %.3249.3, %"$phi730.5.2.2.3"
  store double %.3377.3, ptr %.3248.3, align 8
  %.3233.4 = icmp slt i64 %.375.sroa.0.03100, -4
  %.3234.4 = select i1 %.3233.4, i64 %arg.out.5.0, i64 0
  %29 = getelementptr double, ptr %arg.out.4, i64 %.1864.3
  %.3248.4 = getelementptr double, ptr %29, i64 %.3234.4
  %.3249.4 = load double, ptr %.3248.4, align 8
  %.3267.4 = select i1 %.3233.4, i64 %arg.x.5.0, i64 0
  %.3281.4 = getelementptr double, ptr %7, i64 %.3267.4
  %.3282.4 = load double, ptr %.3281.4, align 8
  %.3283.4 = fcmp contract ult double %.3282.4, 8.000000e+00
  %"$phi730.5.2.2.in.idx.4" = select i1 %.3283.4, i64 64, i64 0
  %sunkaddr3221 = getelementptr i8, ptr %arg.room.4, i64 %"$phi730.5.2.2.in.idx.4"
  %sunkaddr3222 = getelementptr i8, ptr %sunkaddr3221, i64 32
  %"$phi730.5.2.2.4" = load double, ptr %sunkaddr3222, align 8
  %.3377.4 = fadd contract double %.3249.4, %"$phi730.5.2.2.4"
  store double %.3377.4, ptr %.3248.4, align 8
  %.3233.5 = icmp slt i64 %.375.sroa.0.03100, -5
  %.3234.5 = select i1 %.3233.5, i64 %arg.out.5.0, i64 0
  %30 = getelementptr double, ptr %arg.out.4, i64 %.1864.4
  %.3248.5 = getelementptr double, ptr %30, i64 %.3234.5
  %.3249.5 = load double, ptr %.3248.5, align 8
  %.3267.5 = select i1 %.3233.5, i64 %arg.x.5.0, i64 0
  %.3281.5 = getelementptr double, ptr %6, i64 %.3267.5
  %.3282.5 = load double, ptr %.3281.5, align 8
  %.3283.5 = fcmp contract ult double %.3282.5, 8.000000e+00
  %"$phi730.5.2.2.in.idx.5" = select i1 %.3283.5, i64 64, i64 0
  %sunkaddr3223 = getelementptr i8, ptr %arg.room.4, i64 %"$phi730.5.2.2.in.idx.5"
  %sunkaddr3224 = getelementptr i8, ptr %sunkaddr3223, i64 40
  %"$phi730.5.2.2.5" = load double, ptr %sunkaddr3224, align 8
  %.3377.5 = fadd contract double %.3249.5, %"$phi730.5.2.2.5"
  store double %.3377.5, ptr %.3248.5, align 8
  %.3233.6 = icmp slt i64 %.375.sroa.0.03100, -6
  %.3234.6 = select i1 %.3233.6, i64 %arg.out.5.0, i64 0
  %31 = getelementptr double, ptr %arg.out.4, i64 %.1864.5
  %.3248.6 = getelementptr double, ptr %31, i64 %.3234.6
  %.3249.6 = load double, ptr %.3248.6, align 8
  %.3267.6 = select i1 %.3233.6, i64 %arg.x.5.0, i64 0
  %.3281.6 = getelementptr double, ptr %5, i64 %.3267.6
  %.3282.6 = load double, ptr %.3281.6, align 8
  %.3283.6 = fcmp contract ult double %.3282.6, 8.000000e+00
  %"$phi730.5.2.2.in.idx.6" = select i1 %.3283.6, i64 64, i64 0
  %sunkaddr3225 = getelementptr i8, ptr %arg.room.4, i64 %"$phi730.5.2.2.in.idx.6"
  %sunkaddr3226 = getelementptr i8, ptr %sunkaddr3225, i64 48
  %"$phi730.5.2.2.6" = load double, ptr %sunkaddr3226, align 8
  %.3377.6 = fadd contract double %.3249.6, %"$phi730.5.2.2.6"
  store double %.3377.6, ptr %.3248.6, align 8
  %.3233.7 = icmp slt i64 %.375.sroa.0.03100, -7
  %.3234.7 = select i1 %.3233.7, i64 %arg.out.5.0, i64 0
  %32 = getelementptr double, ptr %arg.out.4, i64 %.1864.6
  %.3248.7 = getelementptr double, ptr %32, i64 %.3234.7
  %.3249.7 = load double, ptr %.3248.7, align 8
  %.3267.7 = select i1 %.3233.7, i64 %arg.x.5.0, i64 0
  %.3281.7 = getelementptr double, ptr %4, i64 %.3267.7
  %.3282.7 = load double, ptr %.3281.7, align 8
  %.3283.7 = fcmp contract ult double %.3282.7, 8.000000e+00
  %"$phi730.5.2.2.in.idx.7" = select i1 %.3283.7, i64 64, i64 0
  %sunkaddr3227 = getelementptr i8, ptr %arg.room.4, i64 %"$phi730.5.2.2.in.idx.7"
  %sunkaddr3228 = getelementptr i8, ptr %sunkaddr3227, i64 56
  %"$phi730.5.2.2.7" = load double, ptr %sunkaddr3228, align 8
  %.3377.7 = fadd contract double %.3249.7, %"$phi730.5.2.2.7"
  store double %.3377.7, ptr %.3248.7, align 8
  %.385 = icmp samesign ugt i64 %.332.13099.in, 1
  %.398 = add i64 %.329.13098, 8
  %.329.1 = select i1 %.385, i64 %.398, i64 %.329.13098
  %33 = tail call i64 @llvm.smax.i64(i64 %.332.13099.in, i64 2)
  %34 = add nsw i64 %33, -1
  %.375.sroa.0.0 = select i1 %.385, i64 %.329.13098, i64 0
  br i1 %.385, label %B272, label %B2076
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
declare <8 x double> @llvm.minnum.v8f64(<8 x double>, <8 x double>) #2

; Function Attrs: mustprogress nocallback nocreateundeforpoison nofree nosync nounwind speculatable willreturn memory(none)
declare <8 x double> @llvm.fma.v8f64(<8 x double>, <8 x double>, <8 x double>) #2

; Function Attrs: mustprogress nocallback nocreateundeforpoison nofree nosync nounwind speculatable willreturn memory(none)
declare i64 @llvm.smax.i64(i64, i64) #2

; Function Attrs: nofree norecurse nosync nounwind memory(readwrite, inaccessiblemem: none, target_mem0: none, target_mem1: none)
define internal fastcc void @inner_0(ptr noalias nonnull writeonly captures(none) %retptr, double %arg.x, double %arg.n, ptr readonly captures(none) %arg.arguments.4, ptr readonly captures(none) %arg.prior.4, ptr %arg.room.4) unnamed_addr #0 {
entry:
  %.1211.i570 = alloca ptr, align 8
  %.2410.i572 = alloca ptr, align 8
  %.1211.i249 = alloca ptr, align 8
  %.2410.i251 = alloca ptr, align 8
  %.1211.i1 = alloca ptr, align 8
  %.2410.i3 = alloca ptr, align 8
  %.1211.i = alloca ptr, align 8
  %.2410.i = alloca ptr, align 8
  %.80 = getelementptr i8, ptr %arg.arguments.4, i64 48
  %.81 = load i64, ptr %.80, align 8
  %.82 = icmp eq i64 %.81, 0
  br i1 %.82, label %B48, label %B72

common.ret:                                       ; preds = %B3387, %_ZN17bnserve_inference15marginal_kernel9_distance8_by_ruleB4v124B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEdddd28Literal_5bbool_5d_28False_295ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit, %_ZN17bnserve_inference15marginal_kernel9_distance8_by_ruleB4v115B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEdddd27Literal_5bbool_5d_28True_295ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit, %_ZN17bnserve_inference15marginal_kernel9_distance8_by_ruleB4v102B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEdddd27Literal_5bbool_5d_28True_295ArrayIdLi1E1C7mutable7alignedE23Literal_5bint_5d_288_295ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit, %B48
  %.1294.sroa.0.0.sink = phi double [ %.1294.sroa.0.0, %_ZN17bnserve_inference15marginal_kernel9_distance8_by_ruleB4v124B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEdddd28Literal_5bbool_5d_28False_295ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit ], [ %.815.sroa.0.0, %_ZN17bnserve_inference15marginal_kernel9_distance8_by_ruleB4v115B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEdddd27Literal_5bbool_5d_28True_295ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit ], [ %.448.sroa.0.0, %_ZN17bnserve_inference15marginal_kernel9_distance8_by_ruleB4v102B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEdddd27Literal_5bbool_5d_28True_295ArrayIdLi1E1C7mutable7alignedE23Literal_5bint_5d_288_295ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit ], [ %.104, %B48 ], [ %top.3.2, %B3387 ]
  %.2090.i358.sink = phi double [ %.2090.i358, %_ZN17bnserve_inference15marginal_kernel9_distance8_by_ruleB4v124B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEdddd28Literal_5bbool_5d_28False_295ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit ], [ %.2090.i126, %_ZN17bnserve_inference15marginal_kernel9_distance8_by_ruleB4v115B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEdddd27Literal_5bbool_5d_28True_295ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit ], [ %.2090.i, %_ZN17bnserve_inference15marginal_kernel9_distance8_by_ruleB4v102B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEdddd27Literal_5bbool_5d_28True_295ArrayIdLi1E1C7mutable7alignedE23Literal_5bint_5d_288_295ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit ], [ 1.000000e+00, %B48 ], [ %.2018, %B3387 ]
  %.1294.sroa.8.0.sink = phi double [ %.1294.sroa.8.0, %_ZN17bnserve_inference15marginal_kernel9_distance8_by_ruleB4v124B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEdddd28Literal_5bbool_5d_28False_295ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit ], [ %.815.sroa.8.0, %_ZN17bnserve_inference15marginal_kernel9_distance8_by_ruleB4v115B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEdddd27Literal_5bbool_5d_28True_295ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit ], [ %.448.sroa.8.0, %_ZN17bnserve_inference15marginal_kernel9_distance8_by_ruleB4v102B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEdddd27Literal_5bbool_5d_28True_295ArrayIdLi1E1C7mutable7alignedE23Literal_5bint_5d_288_295ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit ], [ 1.000000e+00, %B48 ], [ %.2027, %B3387 ]
  %.1294.sroa.11.0.sink = phi double [ %.1294.sroa.11.0, %_ZN17bnserve_inference15marginal_kernel9_distance8_by_ruleB4v124B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEdddd28Literal_5bbool_5d_28False_295ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit ], [ %.815.sroa.11.0, %_ZN17bnserve_inference15marginal_kernel9_distance8_by_ruleB4v115B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEdddd27Literal_5bbool_5d_28True_295ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit ], [ %.448.sroa.11.0, %_ZN17bnserve_inference15marginal_kernel9_distance8_by_ruleB4v102B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEdddd27Literal_5bbool_5d_28True_295ArrayIdLi1E1C7mutable7alignedE23Literal_5bint_5d_288_295ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit ], [ 1.000000e+00, %B48 ], [ %.2042, %B3387 ]
  store double %.1294.sroa.0.0.sink, ptr %retptr, align 8
  %retptr.repack822 = getelementptr inbounds nuw i8, ptr %retptr, i64 8
  store double %.2090.i358.sink, ptr %retptr.repack822, align 8
  %retptr.repack824 = getelementptr inbounds nuw i8, ptr %retptr, i64 16
  store double %.1294.sroa.8.0.sink, ptr %retptr.repack824, align 8
  %retptr.repack826 = getelementptr inbounds nuw i8, ptr %retptr, i64 24
  store double %.1294.sroa.11.0.sink, ptr %retptr.repack826, align 8
  ret void

B48:                                              ; preds = %entry
  %.100 = fmul contract double %arg.n, 5.000000e-01
  %.104 = fsub contract double %arg.x, %.100
  br label %common.ret

B72:                                              ; preds = %entry
  %.126 = fcmp contract ogt double %arg.x, 0.000000e+00
  %.129 = fcmp contract ogt double %arg.n, 0.000000e+00
  %or.cond = select i1 %.126, i1 %.129, i1 false
  br i1 %or.cond, label %B96.endif, label %B1396

B210:                                             ; preds = %B96.endif
  %.278 = fadd contract double %.136, %.234
  %.309 = getelementptr i8, ptr %arg.prior.4, i64 16
  %.310 = load double, ptr %.309, align 8
  %.316 = fcmp contract olt double %.278, %.310
  br label %B348

B348:                                             ; preds = %B96.endif, %B210
  %is_normal_v101__vphi176_0.2.0 = phi i1 [ %.316, %B210 ], [ false, %B96.endif ]
  %.336 = fmul contract double %.136, %.179
  %.342 = fcmp contract olt double %.142, %.336
  %is_normal_v101__vphi198_0.2.0 = select i1 %is_normal_v101__vphi176_0.2.0, i1 %.342, i1 false
  br i1 %is_normal_v101__vphi198_0.2.0, label %B670, label %B674

B670:                                             ; preds = %B348
  %.387 = getelementptr i8, ptr %arg.arguments.4, i64 80
  %.388 = load i64, ptr %.387, align 8
  %.390 = inttoptr i64 %.388 to ptr
  call void @llvm.lifetime.start.p0(ptr nonnull %.1211.i)
  call void @llvm.lifetime.start.p0(ptr nonnull %.2410.i)
  store ptr null, ptr %.1211.i, align 8, !noalias !41
  store ptr null, ptr %.2410.i, align 8, !noalias !41
  %.380.i = load double, ptr %.390, align 8, !noalias !41
  %.382.i = fmul contract double %.142, %.380.i
  %.384.i = fadd contract double %.136, %.382.i
  store double %.384.i, ptr %arg.room.4, align 8, !noalias !41
  %0 = getelementptr i8, ptr %.390, i64 8
  %.380.1.i = load double, ptr %0, align 8, !noalias !41
  %.382.1.i = fmul contract double %.142, %.380.1.i
  %.384.1.i = fadd contract double %.136, %.382.1.i
  %1 = getelementptr i8, ptr %arg.room.4, i64 8
  store double %.384.1.i, ptr %1, align 8, !noalias !41
  %2 = getelementptr i8, ptr %.390, i64 16
  %.380.2.i = load double, ptr %2, align 8, !noalias !41
  %.382.2.i = fmul contract double %.142, %.380.2.i
  %.384.2.i = fadd contract double %.136, %.382.2.i
  %3 = getelementptr i8, ptr %arg.room.4, i64 16
  store double %.384.2.i, ptr %3, align 8, !noalias !41
  %4 = getelementptr i8, ptr %.390, i64 24
  %.380.3.i = load double, ptr %4, align 8, !noalias !41
  %.382.3.i = fmul contract double %.142, %.380.3.i
  %.384.3.i = fadd contract double %.136, %.382.3.i
  %5 = getelementptr i8, ptr %arg.room.4, i64 24
  store double %.384.3.i, ptr %5, align 8, !noalias !41
  %6 = getelementptr i8, ptr %.390, i64 32
  %.380.4.i = load double, ptr %6, align 8, !noalias !41
  %.382.4.i = fmul contract double %.142, %.380.4.i
  %.384.4.i = fadd contract double %.136, %.382.4.i
  %7 = getelementptr i8, ptr %arg.room.4, i64 32
  store double %.384.4.i, ptr %7, align 8, !noalias !41
  %8 = getelementptr i8, ptr %.390, i64 40
  %.380.5.i = load double, ptr %8, align 8, !noalias !41
  %.382.5.i = fmul contract double %.142, %.380.5.i
  %.384.5.i = fadd contract double %.136, %.382.5.i
  %9 = getelementptr i8, ptr %arg.room.4, i64 40
  store double %.384.5.i, ptr %9, align 8, !noalias !41
  %10 = getelementptr i8, ptr %.390, i64 48
  %.380.6.i = load double, ptr %10, align 8, !noalias !41
  %.382.6.i = fmul contract double %.142, %.380.6.i
  %.384.6.i = fadd contract double %.136, %.382.6.i
  %11 = getelementptr i8, ptr %arg.room.4, i64 48
  store double %.384.6.i, ptr %11, align 8, !noalias !41
  %12 = getelementptr i8, ptr %.390, i64 56
  %.380.7.i = load double, ptr %12, align 8, !noalias !41
  %.382.7.i = fmul contract double %.142, %.380.7.i
  %.384.7.i = fadd contract double %.136, %.382.7.i
  %13 = getelementptr i8, ptr %arg.room.4, i64 56
  store double %.384.7.i, ptr %13, align 8, !noalias !41
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
  %14 = inttoptr i64 %.742.i to ptr
  br label %B134.if.i.i

B436.i:                                           ; preds = %B134.if.i.i, %B274.i
  %.876.i = load i64, ptr %arg.arguments.4, align 8, !noalias !41
  %.877.i = icmp eq i64 %.876.i, 1
  %.894.i = getelementptr inbounds nuw i8, ptr %arg.room.4, i64 1024
  br i1 %.877.i, label %B584.if.i, label %B716.i

B716.i:                                           ; preds = %B584.if.i, %B436.i
  %.1560.i = load double, ptr %.164.i, align 8, !noalias !41
  %15 = getelementptr i8, ptr %arg.room.4, i64 520
  %.1715.1.i = load double, ptr %15, align 8, !noalias !41
  %.1717.1.i = fcmp contract ogt double %.1715.1.i, %.1560.i
  %.1715.top.2.0.1.i = select i1 %.1717.1.i, double %.1715.1.i, double %.1560.i
  %16 = getelementptr i8, ptr %arg.room.4, i64 528
  %.1715.2.i = load double, ptr %16, align 8, !noalias !41
  %.1717.2.i = fcmp contract ogt double %.1715.2.i, %.1715.top.2.0.1.i
  %.1715.top.2.0.2.i = select i1 %.1717.2.i, double %.1715.2.i, double %.1715.top.2.0.1.i
  %17 = getelementptr i8, ptr %arg.room.4, i64 536
  %.1715.3.i = load double, ptr %17, align 8, !noalias !41
  %.1717.3.i = fcmp contract ogt double %.1715.3.i, %.1715.top.2.0.2.i
  %.1715.top.2.0.3.i = select i1 %.1717.3.i, double %.1715.3.i, double %.1715.top.2.0.2.i
  %18 = getelementptr i8, ptr %arg.room.4, i64 544
  %.1715.4.i = load double, ptr %18, align 8, !noalias !41
  %.1717.4.i = fcmp contract ogt double %.1715.4.i, %.1715.top.2.0.3.i
  %.1715.top.2.0.4.i = select i1 %.1717.4.i, double %.1715.4.i, double %.1715.top.2.0.3.i
  %19 = getelementptr i8, ptr %arg.room.4, i64 552
  %.1715.5.i = load double, ptr %19, align 8, !noalias !41
  %.1717.5.i = fcmp contract ogt double %.1715.5.i, %.1715.top.2.0.4.i
  %.1715.top.2.0.5.i = select i1 %.1717.5.i, double %.1715.5.i, double %.1715.top.2.0.4.i
  %20 = getelementptr i8, ptr %arg.room.4, i64 560
  %.1715.6.i = load double, ptr %20, align 8, !noalias !41
  %.1717.6.i = fcmp contract ogt double %.1715.6.i, %.1715.top.2.0.5.i
  %.1715.top.2.0.6.i = select i1 %.1717.6.i, double %.1715.6.i, double %.1715.top.2.0.5.i
  %21 = getelementptr i8, ptr %arg.room.4, i64 568
  %.1715.7.i = load double, ptr %21, align 8, !noalias !41
  %.1717.7.i = fcmp contract ogt double %.1715.7.i, %.1715.top.2.0.6.i
  %.1715.top.2.0.7.i = select i1 %.1717.7.i, double %.1715.7.i, double %.1715.top.2.0.6.i
  br label %B982.if.i

B1198.i:                                          ; preds = %B982.if.i
  %.487.i.i = load double, ptr %21, align 8, !noalias !47
  %.489.i.i = fadd contract double %.487.i.i, 0.000000e+00
  %.452.i.i = load double, ptr %20, align 8, !noalias !47
  %.454.i.i = fadd contract double %.452.i.i, 0.000000e+00
  %.417.i.i = load double, ptr %19, align 8, !noalias !47
  %.419.i.i = fadd contract double %.417.i.i, 0.000000e+00
  %.382.i.i = load double, ptr %18, align 8, !noalias !47
  %.384.i.i = fadd contract double %.382.i.i, 0.000000e+00
  %.347.i.i = load double, ptr %17, align 8, !noalias !47
  %.349.i.i = fadd contract double %.347.i.i, 0.000000e+00
  %.312.i.i = load double, ptr %16, align 8, !noalias !47
  %.314.i.i = fadd contract double %.312.i.i, 0.000000e+00
  %.277.i.i = load double, ptr %15, align 8, !noalias !47
  %.279.i.i = fadd contract double %.277.i.i, 0.000000e+00
  %.242.i.i = load double, ptr %.164.i, align 8, !noalias !47
  %.244.i.i = fadd contract double %.242.i.i, 0.000000e+00
  %.1253.i = fmul contract double %arg.x, 5.000000e-01
  %.1255.i = fmul contract double %.1253.i, %.136
  %22 = fadd contract double %.279.i.i, %.244.i.i
  %23 = fadd contract double %.349.i.i, %.314.i.i
  %24 = fadd contract double %23, %22
  %25 = fadd contract double %.419.i.i, %.384.i.i
  %26 = fadd contract double %.489.i.i, %.454.i.i
  %27 = fadd contract double %26, %25
  %28 = fadd contract double %27, %24
  %.2090.i = fmul contract double %.142, %28
  %.2122.i = getelementptr i8, ptr %arg.arguments.4, i64 184
  %.2123.i = load i64, ptr %.2122.i, align 8, !noalias !41
  %.2124.i = icmp eq i64 %.2123.i, 0
  br i1 %.2124.i, label %_ZN17bnserve_inference15marginal_kernel9_distance8_by_ruleB4v102B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEdddd27Literal_5bbool_5d_28True_295ArrayIdLi1E1C7mutable7alignedE23Literal_5bint_5d_288_295ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit, label %B1266.if.i

B1336.i:                                          ; preds = %B1266.if.i
  store ptr null, ptr %.2410.i, align 8, !noalias !41
  call fastcc void @inner_4(ptr nonnull %.2410.i, ptr nonnull %.894.i, i64 8, ptr nonnull %arg.room.4, ptr nonnull readonly %arg.arguments.4)
  br label %B1380.i

B1380.i:                                          ; preds = %B1266.if.i, %B1336.i
  %.2613.i = load double, ptr %.164.i, align 8, !noalias !41
  %.2643.i = load double, ptr %arg.room.4, align 8, !noalias !41
  %.2644.i = fmul contract double %.2613.i, %.2643.i
  %.2646.i = fadd contract double %.2644.i, 0.000000e+00
  %.2613.1.i = load double, ptr %15, align 8, !noalias !41
  %.2643.1.i = load double, ptr %1, align 8, !noalias !41
  %.2644.1.i = fmul contract double %.2613.1.i, %.2643.1.i
  %.2646.1.i = fadd contract double %.2646.i, %.2644.1.i
  %.2613.2.i = load double, ptr %16, align 8, !noalias !41
  %.2643.2.i = load double, ptr %3, align 8, !noalias !41
  %.2644.2.i = fmul contract double %.2613.2.i, %.2643.2.i
  %.2646.2.i = fadd contract double %.2646.1.i, %.2644.2.i
  %.2613.3.i = load double, ptr %17, align 8, !noalias !41
  %.2643.3.i = load double, ptr %5, align 8, !noalias !41
  %.2644.3.i = fmul contract double %.2613.3.i, %.2643.3.i
  %.2646.3.i = fadd contract double %.2646.2.i, %.2644.3.i
  %.2613.4.i = load double, ptr %18, align 8, !noalias !41
  %.2643.4.i = load double, ptr %7, align 8, !noalias !41
  %.2644.4.i = fmul contract double %.2613.4.i, %.2643.4.i
  %.2646.4.i = fadd contract double %.2646.3.i, %.2644.4.i
  %.2613.5.i = load double, ptr %19, align 8, !noalias !41
  %.2643.5.i = load double, ptr %9, align 8, !noalias !41
  %.2644.5.i = fmul contract double %.2613.5.i, %.2643.5.i
  %.2646.5.i = fadd contract double %.2646.4.i, %.2644.5.i
  %.2613.6.i = load double, ptr %20, align 8, !noalias !41
  %.2643.6.i = load double, ptr %11, align 8, !noalias !41
  %.2644.6.i = fmul contract double %.2613.6.i, %.2643.6.i
  %.2646.6.i = fadd contract double %.2646.5.i, %.2644.6.i
  %.2613.7.i = load double, ptr %21, align 8, !noalias !41
  %.2643.7.i = load double, ptr %13, align 8, !noalias !41
  %.2644.7.i = fmul contract double %.2613.7.i, %.2643.7.i
  %.2646.7.i = fadd contract double %.2646.6.i, %.2644.7.i
  %.2673.i = fmul contract double %.142, %.2646.7.i
  %.2678.i = fmul contract double %.142, %.2394.7.i
  br label %_ZN17bnserve_inference15marginal_kernel9_distance8_by_ruleB4v102B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEdddd27Literal_5bbool_5d_28True_295ArrayIdLi1E1C7mutable7alignedE23Literal_5bint_5d_288_295ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit

B182.if.i:                                        ; preds = %B182.if.i, %B670
  %.50611801182.i = phi i64 [ %.513.i, %B182.if.i ], [ 0, %B670 ]
  %.513.i = add nuw nsw i64 %.50611801182.i, 1
  %.567.i = load double, ptr %arg.prior.4, align 8, !noalias !41
  %29 = shl nuw nsw i64 %.50611801182.i, 3
  %scevgep8.i = getelementptr i8, ptr %arg.room.4, i64 %29
  %.5981172.i = load i64, ptr %scevgep8.i, align 8, !noalias !41
  %.600.i = add nsw i64 %.5981172.i, -4604544271217802189
  %.601.i = ashr i64 %.600.i, 52
  %.602.i = and i64 %.600.i, -4503599627370496
  %.603.i = sub nsw i64 %.5981172.i, %.602.i
  %.604.i = bitcast i64 %.603.i to double
  %.605.i = fadd contract double %.604.i, -1.000000e+00
  %.606.i = fadd contract double %.605.i, 2.000000e+00
  %.610.i = fdiv contract double %.605.i, %.606.i
  %.611.i = fmul contract double %.610.i, %.610.i
  %.612.i = fmul contract double %.611.i, %.611.i
  %.613.i = fmul contract double %.612.i, 0x3FC39A09D078C69F
  %.614.i = fadd contract double %.613.i, 0x3FCC71C51D8E78AF
  %.615.i = fmul contract double %.612.i, %.614.i
  %.616.i = fadd contract double %.615.i, 0x3FD999999997FA04
  %.617.i = fmul contract double %.612.i, %.616.i
  %.618.i = fmul contract double %.612.i, 0x3FC2F112DF3E5244
  %.619.i = fadd contract double %.618.i, 0x3FC7466496CB03DE
  %.620.i = fmul contract double %.612.i, %.619.i
  %.621.i = fadd contract double %.620.i, 0x3FD2492494229359
  %.622.i = fmul contract double %.612.i, %.621.i
  %.623.i = fadd contract double %.622.i, 0x3FE5555555555593
  %.624.i = fmul contract double %.611.i, %.623.i
  %.625.i = fadd contract double %.617.i, %.624.i
  %.626.i = fmul contract double %.605.i, 5.000000e-01
  %.627.i = fmul contract double %.605.i, %.626.i
  %.628.i = add nsw i64 %.601.i, 4843621399236968448
  %.629.i = bitcast i64 %.628.i to double
  %.630.i = fadd contract double %.629.i, 0xC338000000000000
  %.631.i = fmul contract double %.630.i, 0x3FE62E42FEE00000
  %.632.i = fadd contract double %.627.i, %.625.i
  %.633.i = fmul contract double %.610.i, %.632.i
  %.634.i = fmul contract double %.630.i, 0x3DEA39EF35793C76
  %.635.i = fadd contract double %.634.i, %.633.i
  %.636.i = fsub contract double %.627.i, %.635.i
  %.637.i = fsub contract double %.636.i, %.605.i
  %.638.i = fsub contract double %.631.i, %.637.i
  %.639.i = fmul contract double %.567.i, %.638.i
  %scevgep7.i = getelementptr i8, ptr %scevgep8.i, i64 512
  store double %.639.i, ptr %scevgep7.i, align 8, !noalias !41
  %exitcond.not.i = icmp eq i64 %.513.i, 8
  br i1 %exitcond.not.i, label %B274.i, label %B182.if.i

B134.if.i.i:                                      ; preds = %B134.if.i.i, %B322.i
  %.230207209.i.i = phi i64 [ 0, %B322.i ], [ %.237.i.i, %B134.if.i.i ]
  %.237.i.i = add nuw nsw i64 %.230207209.i.i, 1
  %30 = shl nuw nsw i64 %.230207209.i.i, 3
  %scevgep5.i = getelementptr i8, ptr %.164.i, i64 %30
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
  %31 = tail call i64 @llvm.smax.i64(i64 %.350.i.i, i64 4843621399236968448)
  %nearest_cell_v113__vphi100_0.2.1.i.i = add nsw i64 %31, -4843621399236968448
  %nearest_cell_v113__vphi120_0.2.1.i.i = tail call i64 @llvm.smin.i64(i64 %nearest_cell_v113__vphi100_0.2.1.i.i, i64 %.355.i.i)
  %.405.i.i = uitofp nneg i64 %nearest_cell_v113__vphi120_0.2.1.i.i to double
  %.406.i.i = fsub contract double %.341.i.i, %.405.i.i
  %.440.i.i = load double, ptr %scevgep5.i, align 8, !noalias !44
  %.idx.i.i = mul i64 %nearest_cell_v113__vphi120_0.2.1.i.i, 48
  %32 = getelementptr i8, ptr %14, i64 %.idx.i.i
  %.470.i.i = load double, ptr %32, align 8, !noalias !44
  %33 = getelementptr i8, ptr %32, i64 8
  %.501.i.i = load double, ptr %33, align 8, !noalias !44
  %34 = getelementptr i8, ptr %32, i64 16
  %.532.i.i = load double, ptr %34, align 8, !noalias !44
  %35 = getelementptr i8, ptr %32, i64 24
  %.563.i.i = load double, ptr %35, align 8, !noalias !44
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
  %36 = getelementptr i8, ptr %arg.room.4, i64 1032
  store double %.1102.1.i, ptr %36, align 8, !noalias !41
  %.1102.2.i = fmul contract double %arg.x, %.384.2.i
  %37 = getelementptr i8, ptr %arg.room.4, i64 1040
  store double %.1102.2.i, ptr %37, align 8, !noalias !41
  %.1102.3.i = fmul contract double %arg.x, %.384.3.i
  %38 = getelementptr i8, ptr %arg.room.4, i64 1048
  store double %.1102.3.i, ptr %38, align 8, !noalias !41
  %.1102.4.i = fmul contract double %arg.x, %.384.4.i
  %39 = getelementptr i8, ptr %arg.room.4, i64 1056
  store double %.1102.4.i, ptr %39, align 8, !noalias !41
  %.1102.5.i = fmul contract double %arg.x, %.384.5.i
  %40 = getelementptr i8, ptr %arg.room.4, i64 1064
  store double %.1102.5.i, ptr %40, align 8, !noalias !41
  %.1102.6.i = fmul contract double %arg.x, %.384.6.i
  %41 = getelementptr i8, ptr %arg.room.4, i64 1072
  store double %.1102.6.i, ptr %41, align 8, !noalias !41
  %.1102.7.i = fmul contract double %arg.x, %.384.7.i
  %42 = getelementptr i8, ptr %arg.room.4, i64 1080
  store double %.1102.7.i, ptr %42, align 8, !noalias !41
  %.1157.i = getelementptr inbounds nuw i8, ptr %arg.room.4, i64 1536
  store ptr null, ptr %.1211.i, align 8, !noalias !41
  call fastcc void @inner_3(ptr nonnull %.1211.i, ptr nonnull %.894.i, i64 8, ptr nonnull readonly %arg.arguments.4, ptr nonnull %.1157.i, ptr nonnull %.164.i, i64 8)
  br label %B716.i

B982.if.i:                                        ; preds = %B982.if.i, %B716.i
  %lsr.iv.i = phi i64 [ 64, %B716.i ], [ %lsr.iv.next.i, %B982.if.i ]
  %43 = shl nuw nsw i64 %lsr.iv.i, 3
  %scevgep1.i = getelementptr i8, ptr %.390, i64 %43
  %scevgep2.i = getelementptr i8, ptr %scevgep1.i, i64 -448
  %.1929.i = load double, ptr %scevgep2.i, align 8, !noalias !41
  %scevgep.i = getelementptr i8, ptr %arg.room.4, i64 %43
  %.1964.i = load double, ptr %scevgep.i, align 8, !noalias !41
  %.1966.i = fsub contract double %.1964.i, %.1715.top.2.0.7.i
  %.1972.i = fcmp contract ogt double %.1966.i, -7.000000e+02
  %.1966..i = select i1 %.1972.i, double %.1966.i, double -7.000000e+02
  %.1989.i = tail call contract double @llvm.fma.f64(double %.1966..i, double 0x3FF71547652B82FE, double 0x4338000000000000)
  %.1990.i = fadd contract double %.1989.i, 0xC338000000000000
  %.1993.i = tail call contract double @llvm.fma.f64(double %.1990.i, double 0xBFE62E42FEFA39EF, double %.1966..i)
  %.1994.i = tail call contract double @llvm.fma.f64(double %.1990.i, double 0xBC7ABC9E3B39803F, double %.1993.i)
  %.1995.i = tail call contract double @llvm.fma.f64(double %.1994.i, double 0x3DE6124613A86D09, double 0x3E21EED8EFF8D898)
  %.1996.i = tail call contract double @llvm.fma.f64(double %.1994.i, double %.1995.i, double 0x3E5AE64567F544E4)
  %.1997.i = tail call contract double @llvm.fma.f64(double %.1994.i, double %.1996.i, double 0x3E927E4FB7789F5C)
  %.1998.i = tail call contract double @llvm.fma.f64(double %.1994.i, double %.1997.i, double 0x3EC71DE3A556C734)
  %.1999.i = tail call contract double @llvm.fma.f64(double %.1994.i, double %.1998.i, double 0x3EFA01A01A01A01A)
  %.2000.i = tail call contract double @llvm.fma.f64(double %.1994.i, double %.1999.i, double 0x3F2A01A01A01A01A)
  %.2001.i = tail call contract double @llvm.fma.f64(double %.1994.i, double %.2000.i, double 0x3F56C16C16C16C17)
  %.2002.i = tail call contract double @llvm.fma.f64(double %.1994.i, double %.2001.i, double 0x3F81111111111111)
  %.2003.i = tail call contract double @llvm.fma.f64(double %.1994.i, double %.2002.i, double 0x3FA5555555555555)
  %.2004.i = tail call contract double @llvm.fma.f64(double %.1994.i, double %.2003.i, double 0x3FC5555555555555)
  %.2005.i = tail call contract double @llvm.fma.f64(double %.1994.i, double %.2004.i, double 5.000000e-01)
  %.2006.i = fmul contract double %.1994.i, %.1994.i
  %.2007.i = fadd contract double %.1994.i, 1.000000e+00
  %.2008.i = tail call contract double @llvm.fma.f64(double %.2006.i, double %.2005.i, double %.2007.i)
  %.2009.i = bitcast double %.1989.i to i64
  %.2010.i = shl i64 %.2009.i, 52
  %.2011.i = add i64 %.2010.i, 4607182418800017408
  %.2012.i = bitcast i64 %.2011.i to double
  %.2013.i = fmul contract double %.2008.i, %.2012.i
  %.2015.i = fmul contract double %.1929.i, %.2013.i
  store double %.2015.i, ptr %scevgep.i, align 8, !noalias !41
  %lsr.iv.next.i = add nuw nsw i64 %lsr.iv.i, 1
  %exitcond1229.not.i = icmp eq i64 %lsr.iv.next.i, 72
  br i1 %exitcond1229.not.i, label %B1198.i, label %B982.if.i

B1266.if.i:                                       ; preds = %B1198.i
  %.2360.i = load double, ptr %arg.room.4, align 8, !noalias !41
  %.2361.i = fmul contract double %.242.i.i, %.2360.i
  %.2392.i = fmul contract double %.2360.i, %.2361.i
  %.2394.i = fadd contract double %.2392.i, 0.000000e+00
  %.2360.1.i = load double, ptr %1, align 8, !noalias !41
  %.2361.1.i = fmul contract double %.277.i.i, %.2360.1.i
  %.2392.1.i = fmul contract double %.2360.1.i, %.2361.1.i
  %.2394.1.i = fadd contract double %.2394.i, %.2392.1.i
  %.2360.2.i = load double, ptr %3, align 8, !noalias !41
  %.2361.2.i = fmul contract double %.312.i.i, %.2360.2.i
  %.2392.2.i = fmul contract double %.2360.2.i, %.2361.2.i
  %.2394.2.i = fadd contract double %.2394.1.i, %.2392.2.i
  %.2360.3.i = load double, ptr %5, align 8, !noalias !41
  %.2361.3.i = fmul contract double %.347.i.i, %.2360.3.i
  %.2392.3.i = fmul contract double %.2360.3.i, %.2361.3.i
  %.2394.3.i = fadd contract double %.2394.2.i, %.2392.3.i
  %.2360.4.i = load double, ptr %7, align 8, !noalias !41
  %.2361.4.i = fmul contract double %.382.i.i, %.2360.4.i
  %.2392.4.i = fmul contract double %.2360.4.i, %.2361.4.i
  %.2394.4.i = fadd contract double %.2394.3.i, %.2392.4.i
  %.2360.5.i = load double, ptr %9, align 8, !noalias !41
  %.2361.5.i = fmul contract double %.417.i.i, %.2360.5.i
  %.2392.5.i = fmul contract double %.2360.5.i, %.2361.5.i
  %.2394.5.i = fadd contract double %.2394.4.i, %.2392.5.i
  %.2360.6.i = load double, ptr %11, align 8, !noalias !41
  %.2361.6.i = fmul contract double %.452.i.i, %.2360.6.i
  %.2392.6.i = fmul contract double %.2360.6.i, %.2361.6.i
  %.2394.6.i = fadd contract double %.2394.5.i, %.2392.6.i
  %.2360.7.i = load double, ptr %13, align 8, !noalias !41
  %.2361.7.i = fmul contract double %.487.i.i, %.2360.7.i
  %.2392.7.i = fmul contract double %.2360.7.i, %.2361.7.i
  %.2394.7.i = fadd contract double %.2394.6.i, %.2392.7.i
  br i1 %.877.i, label %B1336.i, label %B1380.i

_ZN17bnserve_inference15marginal_kernel9_distance8_by_ruleB4v102B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEdddd27Literal_5bbool_5d_28True_295ArrayIdLi1E1C7mutable7alignedE23Literal_5bint_5d_288_295ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit: ; preds = %B1198.i, %B1380.i
  %.448.sroa.11.0 = phi double [ %.2678.i, %B1380.i ], [ 0.000000e+00, %B1198.i ]
  %.448.sroa.8.0 = phi double [ %.2673.i, %B1380.i ], [ 0.000000e+00, %B1198.i ]
  %.448.sroa.0.0 = fadd contract double %.1255.i, %.1715.top.2.0.7.i
  call void @llvm.lifetime.end.p0(ptr nonnull %.1211.i)
  call void @llvm.lifetime.end.p0(ptr nonnull %.2410.i)
  br label %common.ret

B674:                                             ; preds = %B348
  %.546 = getelementptr i8, ptr %arg.prior.4, i64 48
  %.547 = load double, ptr %.546, align 8
  br i1 %.271, label %B676, label %B950

B676:                                             ; preds = %B674
  %.646 = fadd contract double %.136, %.234
  %.677 = getelementptr i8, ptr %arg.prior.4, i64 16
  %.678 = load double, ptr %.677, align 8
  %.684 = fcmp contract olt double %.646, %.678
  br label %B950

B950:                                             ; preds = %B676, %B674
  %is_normal_v99__vphi176_0.2.0 = phi i1 [ %.684, %B676 ], [ false, %B674 ]
  %.704 = fmul contract double %.136, %.547
  %.710 = fcmp contract olt double %.142, %.704
  %is_normal_v99__vphi198_0.2.0 = select i1 %is_normal_v99__vphi176_0.2.0, i1 %.710, i1 false
  br i1 %is_normal_v99__vphi198_0.2.0, label %B1312, label %B1396

B1312:                                            ; preds = %B950
  %.755 = getelementptr i8, ptr %arg.arguments.4, i64 88
  %.756 = load i64, ptr %.755, align 8
  %.758 = inttoptr i64 %.756 to ptr
  call void @llvm.lifetime.start.p0(ptr nonnull %.1211.i1)
  call void @llvm.lifetime.start.p0(ptr nonnull %.2410.i3)
  store ptr null, ptr %.1211.i1, align 8, !noalias !50
  store ptr null, ptr %.2410.i3, align 8, !noalias !50
  br label %B112.if.i

B274.i58:                                         ; preds = %B182.if.i18
  %.703.i59 = getelementptr i8, ptr %arg.arguments.4, i64 64
  %.704.i60 = load i64, ptr %.703.i59, align 8, !noalias !50
  %.709.i61 = icmp sgt i64 %.704.i60, 0
  br i1 %.709.i61, label %B322.i180, label %B436.i62

B322.i180:                                        ; preds = %B274.i58
  %.88.i.i181 = getelementptr i8, ptr %arg.prior.4, i64 56
  %.89.i.i182 = load double, ptr %.88.i.i181, align 8, !noalias !53
  %.117.i.i183 = getelementptr i8, ptr %arg.prior.4, i64 64
  %.118.i.i184 = load double, ptr %.117.i.i183, align 8, !noalias !53
  %.125.i.i185 = fdiv contract double 1.000000e+00, %.118.i.i184
  %.741.i186 = getelementptr i8, ptr %arg.arguments.4, i64 72
  %.742.i187 = load i64, ptr %.741.i186, align 8, !noalias !50
  %.355.i.i188 = add nsw i64 %.704.i60, -1
  %44 = inttoptr i64 %.742.i187 to ptr
  br label %B134.if.i.i189

B436.i62:                                         ; preds = %B134.if.i.i189, %B274.i58
  %.876.i63 = load i64, ptr %arg.arguments.4, align 8, !noalias !50
  %.877.i64 = icmp eq i64 %.876.i63, 1
  %.894.i65 = getelementptr inbounds nuw i8, ptr %arg.room.4, i64 1024
  br i1 %.877.i64, label %B584.if.i173, label %B716.i66

B618.i:                                           ; preds = %B584.if.i173
  %.1157.i178 = getelementptr inbounds nuw i8, ptr %arg.room.4, i64 1536
  store ptr null, ptr %.1211.i1, align 8, !noalias !50
  call fastcc void @inner_3(ptr nonnull %.1211.i1, ptr nonnull %.894.i65, i64 16, ptr nonnull readonly %arg.arguments.4, ptr nonnull %.1157.i178, ptr nonnull %.164.i17, i64 16)
  br label %B716.i66

B716.i66:                                         ; preds = %B618.i, %B436.i62
  %.1560.i67 = load double, ptr %.164.i17, align 8, !noalias !50
  br label %B902.if.i

B1198.i107:                                       ; preds = %B982.if.i77
  %scevgep.i.i = getelementptr i8, ptr %arg.room.4, i64 568
  br label %B104.if.i.i

B104.if.i.i:                                      ; preds = %B104.if.i.i, %B1198.i107
  %lsr.iv9.i.i = phi i64 [ 2, %B1198.i107 ], [ %lsr.iv.next.i.i, %B104.if.i.i ]
  %lsr.iv.i.i = phi ptr [ %scevgep.i.i, %B1198.i107 ], [ %scevgep1.i.i, %B104.if.i.i ]
  %s7.2.0168.i.i = phi double [ 0.000000e+00, %B1198.i107 ], [ %.489.i.i123, %B104.if.i.i ]
  %s6.2.0167.i.i = phi double [ 0.000000e+00, %B1198.i107 ], [ %.454.i.i121, %B104.if.i.i ]
  %s5.2.0166.i.i = phi double [ 0.000000e+00, %B1198.i107 ], [ %.419.i.i119, %B104.if.i.i ]
  %s4.2.0165.i.i = phi double [ 0.000000e+00, %B1198.i107 ], [ %.384.i.i117, %B104.if.i.i ]
  %s3.2.0164.i.i = phi double [ 0.000000e+00, %B1198.i107 ], [ %.349.i.i115, %B104.if.i.i ]
  %s2.2.0163.i.i = phi double [ 0.000000e+00, %B1198.i107 ], [ %.314.i.i113, %B104.if.i.i ]
  %s1.2.0162.i.i = phi double [ 0.000000e+00, %B1198.i107 ], [ %.279.i.i111, %B104.if.i.i ]
  %s0.2.0161.i.i = phi double [ 0.000000e+00, %B1198.i107 ], [ %.244.i.i109, %B104.if.i.i ]
  %scevgep2.i.i = getelementptr i8, ptr %lsr.iv.i.i, i64 -56
  %.242.i.i108 = load double, ptr %scevgep2.i.i, align 8, !noalias !56
  %.244.i.i109 = fadd contract double %s0.2.0161.i.i, %.242.i.i108
  %scevgep3.i.i = getelementptr i8, ptr %lsr.iv.i.i, i64 -48
  %.277.i.i110 = load double, ptr %scevgep3.i.i, align 8, !noalias !56
  %.279.i.i111 = fadd contract double %s1.2.0162.i.i, %.277.i.i110
  %scevgep4.i.i = getelementptr i8, ptr %lsr.iv.i.i, i64 -40
  %.312.i.i112 = load double, ptr %scevgep4.i.i, align 8, !noalias !56
  %.314.i.i113 = fadd contract double %s2.2.0163.i.i, %.312.i.i112
  %scevgep5.i.i = getelementptr i8, ptr %lsr.iv.i.i, i64 -32
  %.347.i.i114 = load double, ptr %scevgep5.i.i, align 8, !noalias !56
  %.349.i.i115 = fadd contract double %s3.2.0164.i.i, %.347.i.i114
  %scevgep6.i.i = getelementptr i8, ptr %lsr.iv.i.i, i64 -24
  %.382.i.i116 = load double, ptr %scevgep6.i.i, align 8, !noalias !56
  %.384.i.i117 = fadd contract double %s4.2.0165.i.i, %.382.i.i116
  %scevgep7.i.i = getelementptr i8, ptr %lsr.iv.i.i, i64 -16
  %.417.i.i118 = load double, ptr %scevgep7.i.i, align 8, !noalias !56
  %.419.i.i119 = fadd contract double %s5.2.0166.i.i, %.417.i.i118
  %scevgep8.i.i = getelementptr i8, ptr %lsr.iv.i.i, i64 -8
  %.452.i.i120 = load double, ptr %scevgep8.i.i, align 8, !noalias !56
  %.454.i.i121 = fadd contract double %s6.2.0167.i.i, %.452.i.i120
  %.487.i.i122 = load double, ptr %lsr.iv.i.i, align 8, !noalias !56
  %.489.i.i123 = fadd contract double %s7.2.0168.i.i, %.487.i.i122
  %scevgep1.i.i = getelementptr i8, ptr %lsr.iv.i.i, i64 64
  %lsr.iv.next.i.i = add nsw i64 %lsr.iv9.i.i, -1
  %exitcond.not.i.i = icmp eq i64 %lsr.iv.next.i.i, 0
  br i1 %exitcond.not.i.i, label %B1198.endif.i, label %B104.if.i.i

B1334.i:                                          ; preds = %B1266.if.i130
  br i1 %.877.i64, label %B1336.i169, label %B3839.if.i.preheader

B3839.if.i.preheader:                             ; preds = %B1336.i169, %B1334.i
  br label %B3839.if.i

B1336.i169:                                       ; preds = %B1334.i
  store ptr null, ptr %.2410.i3, align 8, !noalias !50
  call fastcc void @inner_4(ptr nonnull %.2410.i3, ptr nonnull %.894.i65, i64 16, ptr %arg.room.4, ptr nonnull readonly %arg.arguments.4)
  br label %B3839.if.i.preheader

B3855.i:                                          ; preds = %B3839.if.i
  %.2673.i165 = fmul contract double %.142, %.2646.3.i163
  %.2678.i166 = fmul contract double %.142, %.2394.3.i146
  br label %_ZN17bnserve_inference15marginal_kernel9_distance8_by_ruleB4v115B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEdddd27Literal_5bbool_5d_28True_295ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit

B112.if.i:                                        ; preds = %B112.if.i, %B1312
  %.31911861188.i = phi i64 [ 0, %B1312 ], [ %.326.3.i, %B112.if.i ]
  %sunkaddr83.i = shl i64 %.31911861188.i, 3
  %sunkaddr84.i = getelementptr i8, ptr %.758, i64 %sunkaddr83.i
  %.380.i5 = load double, ptr %sunkaddr84.i, align 8, !noalias !50
  %.382.i6 = fmul contract double %.142, %.380.i5
  %.384.i7 = fadd contract double %.136, %.382.i6
  %sunkaddr86.i = getelementptr i8, ptr %arg.room.4, i64 %sunkaddr83.i
  store double %.384.i7, ptr %sunkaddr86.i, align 8, !noalias !50
  %sunkaddr88.i = getelementptr i8, ptr %sunkaddr84.i, i64 8
  %.380.1.i8 = load double, ptr %sunkaddr88.i, align 8, !noalias !50
  %.382.1.i9 = fmul contract double %.142, %.380.1.i8
  %.384.1.i10 = fadd contract double %.136, %.382.1.i9
  %sunkaddr91.i = getelementptr i8, ptr %sunkaddr86.i, i64 8
  store double %.384.1.i10, ptr %sunkaddr91.i, align 8, !noalias !50
  %sunkaddr94.i = getelementptr i8, ptr %sunkaddr84.i, i64 16
  %.380.2.i11 = load double, ptr %sunkaddr94.i, align 8, !noalias !50
  %.382.2.i12 = fmul contract double %.142, %.380.2.i11
  %.384.2.i13 = fadd contract double %.136, %.382.2.i12
  %sunkaddr97.i = getelementptr i8, ptr %sunkaddr86.i, i64 16
  store double %.384.2.i13, ptr %sunkaddr97.i, align 8, !noalias !50
  %.326.3.i = add nuw nsw i64 %.31911861188.i, 4
  %sunkaddr100.i = getelementptr i8, ptr %sunkaddr84.i, i64 24
  %.380.3.i14 = load double, ptr %sunkaddr100.i, align 8, !noalias !50
  %.382.3.i15 = fmul contract double %.142, %.380.3.i14
  %.384.3.i16 = fadd contract double %.136, %.382.3.i15
  %sunkaddr103.i = getelementptr i8, ptr %sunkaddr86.i, i64 24
  store double %.384.3.i16, ptr %sunkaddr103.i, align 8, !noalias !50
  %niter.ncmp.3.i = icmp eq i64 %.326.3.i, 16
  br i1 %niter.ncmp.3.i, label %B182.if.preheader.i, label %B112.if.i

B182.if.preheader.i:                              ; preds = %B112.if.i
  %.164.i17 = getelementptr i8, ptr %arg.room.4, i64 512
  br label %B182.if.i18

B182.if.i18:                                      ; preds = %B182.if.i18, %B182.if.preheader.i
  %.50611921194.i = phi i64 [ %.513.i19, %B182.if.i18 ], [ 0, %B182.if.preheader.i ]
  %.513.i19 = add nuw nsw i64 %.50611921194.i, 1
  %.567.i20 = load double, ptr %arg.prior.4, align 8, !noalias !50
  %45 = shl i64 %.50611921194.i, 3
  %scevgep171.i = getelementptr i8, ptr %.164.i17, i64 %45
  %scevgep172.i = getelementptr i8, ptr %scevgep171.i, i64 -512
  %.5981178.i = load i64, ptr %scevgep172.i, align 8, !noalias !50
  %.600.i21 = add nsw i64 %.5981178.i, -4604544271217802189
  %.601.i22 = ashr i64 %.600.i21, 52
  %.602.i23 = and i64 %.600.i21, -4503599627370496
  %.603.i24 = sub nsw i64 %.5981178.i, %.602.i23
  %.604.i25 = bitcast i64 %.603.i24 to double
  %.605.i26 = fadd contract double %.604.i25, -1.000000e+00
  %.606.i27 = fadd contract double %.605.i26, 2.000000e+00
  %.610.i28 = fdiv contract double %.605.i26, %.606.i27
  %.611.i29 = fmul contract double %.610.i28, %.610.i28
  %.612.i30 = fmul contract double %.611.i29, %.611.i29
  %.613.i31 = fmul contract double %.612.i30, 0x3FC39A09D078C69F
  %.614.i32 = fadd contract double %.613.i31, 0x3FCC71C51D8E78AF
  %.615.i33 = fmul contract double %.612.i30, %.614.i32
  %.616.i34 = fadd contract double %.615.i33, 0x3FD999999997FA04
  %.617.i35 = fmul contract double %.612.i30, %.616.i34
  %.618.i36 = fmul contract double %.612.i30, 0x3FC2F112DF3E5244
  %.619.i37 = fadd contract double %.618.i36, 0x3FC7466496CB03DE
  %.620.i38 = fmul contract double %.612.i30, %.619.i37
  %.621.i39 = fadd contract double %.620.i38, 0x3FD2492494229359
  %.622.i40 = fmul contract double %.612.i30, %.621.i39
  %.623.i41 = fadd contract double %.622.i40, 0x3FE5555555555593
  %.624.i42 = fmul contract double %.611.i29, %.623.i41
  %.625.i43 = fadd contract double %.617.i35, %.624.i42
  %.626.i44 = fmul contract double %.605.i26, 5.000000e-01
  %.627.i45 = fmul contract double %.605.i26, %.626.i44
  %.628.i46 = add nsw i64 %.601.i22, 4843621399236968448
  %.629.i47 = bitcast i64 %.628.i46 to double
  %.630.i48 = fadd contract double %.629.i47, 0xC338000000000000
  %.631.i49 = fmul contract double %.630.i48, 0x3FE62E42FEE00000
  %.632.i50 = fadd contract double %.627.i45, %.625.i43
  %.633.i51 = fmul contract double %.610.i28, %.632.i50
  %.634.i52 = fmul contract double %.630.i48, 0x3DEA39EF35793C76
  %.635.i53 = fadd contract double %.634.i52, %.633.i51
  %.636.i54 = fsub contract double %.627.i45, %.635.i53
  %.637.i55 = fsub contract double %.636.i54, %.605.i26
  %.638.i56 = fsub contract double %.631.i49, %.637.i55
  %.639.i57 = fmul contract double %.567.i20, %.638.i56
  store double %.639.i57, ptr %scevgep171.i, align 8, !noalias !50
  %exitcond1239.not.i = icmp eq i64 %.513.i19, 16
  br i1 %exitcond1239.not.i, label %B274.i58, label %B182.if.i18

B134.if.i.i189:                                   ; preds = %B134.if.i.i189, %B322.i180
  %.230207209.i.i190 = phi i64 [ 0, %B322.i180 ], [ %.237.i.i191, %B134.if.i.i189 ]
  %.237.i.i191 = add nuw nsw i64 %.230207209.i.i190, 1
  %46 = shl i64 %.230207209.i.i190, 3
  %scevgep168.i = getelementptr i8, ptr %.164.i17, i64 %46
  %scevgep169.i = getelementptr i8, ptr %scevgep168.i, i64 -512
  %.296205.i.i192 = load i64, ptr %scevgep169.i, align 8, !noalias !53
  %.298.i.i193 = add nsw i64 %.296205.i.i192, -4604544271217802189
  %.299.i.i194 = ashr i64 %.298.i.i193, 52
  %.300.i.i195 = and i64 %.298.i.i193, -4503599627370496
  %.301.i.i196 = sub nsw i64 %.296205.i.i192, %.300.i.i195
  %.302.i.i197 = bitcast i64 %.301.i.i196 to double
  %.303.i.i198 = fadd contract double %.302.i.i197, -1.000000e+00
  %.304.i.i199 = fadd contract double %.303.i.i198, 2.000000e+00
  %.308.i.i200 = fdiv contract double %.303.i.i198, %.304.i.i199
  %.309.i.i201 = fmul contract double %.308.i.i200, %.308.i.i200
  %.310.i.i202 = fmul contract double %.309.i.i201, %.309.i.i201
  %.311.i.i203 = fmul contract double %.310.i.i202, 0x3FC39A09D078C69F
  %.312.i26.i = fadd contract double %.311.i.i203, 0x3FCC71C51D8E78AF
  %.313.i.i204 = fmul contract double %.310.i.i202, %.312.i26.i
  %.314.i27.i = fadd contract double %.313.i.i204, 0x3FD999999997FA04
  %.315.i.i205 = fmul contract double %.310.i.i202, %.314.i27.i
  %.316.i.i206 = fmul contract double %.310.i.i202, 0x3FC2F112DF3E5244
  %.317.i.i207 = fadd contract double %.316.i.i206, 0x3FC7466496CB03DE
  %.318.i.i208 = fmul contract double %.310.i.i202, %.317.i.i207
  %.319.i.i209 = fadd contract double %.318.i.i208, 0x3FD2492494229359
  %.320.i.i210 = fmul contract double %.310.i.i202, %.319.i.i209
  %.321.i.i211 = fadd contract double %.320.i.i210, 0x3FE5555555555593
  %.322.i.i212 = fmul contract double %.309.i.i201, %.321.i.i211
  %.323.i.i213 = fadd contract double %.315.i.i205, %.322.i.i212
  %.324.i.i214 = fmul contract double %.303.i.i198, 5.000000e-01
  %.325.i.i215 = fmul contract double %.303.i.i198, %.324.i.i214
  %.326.i.i216 = add nsw i64 %.299.i.i194, 4843621399236968448
  %.327.i.i217 = bitcast i64 %.326.i.i216 to double
  %.328.i.i218 = fadd contract double %.327.i.i217, 0xC338000000000000
  %.329.i.i219 = fmul contract double %.328.i.i218, 0x3FE62E42FEE00000
  %.330.i.i220 = fadd contract double %.325.i.i215, %.323.i.i213
  %.331.i.i221 = fmul contract double %.308.i.i200, %.330.i.i220
  %.332.i.i222 = fmul contract double %.328.i.i218, 0x3DEA39EF35793C76
  %.333.i.i223 = fadd contract double %.332.i.i222, %.331.i.i221
  %.334.i.i224 = fsub contract double %.325.i.i215, %.333.i.i223
  %.335.i.i225 = fsub contract double %.334.i.i224, %.303.i.i198
  %.336.i.i226 = fsub contract double %.329.i.i219, %.335.i.i225
  %.337.i.i227 = fneg contract double %.336.i.i226
  %.339.i.i228 = fsub contract double %.337.i.i227, %.89.i.i182
  %.341.i.i229 = fmul contract double %.125.i.i185, %.339.i.i228
  %.348.i.i230 = fadd contract double %.341.i.i229, -5.000000e-01
  %.349.i28.i = fadd contract double %.348.i.i230, 0x4338000000000000
  %.350.i.i231 = bitcast double %.349.i28.i to i64
  %47 = tail call i64 @llvm.smax.i64(i64 %.350.i.i231, i64 4843621399236968448)
  %nearest_cell_v113__vphi100_0.2.1.i.i232 = add nsw i64 %47, -4843621399236968448
  %nearest_cell_v113__vphi120_0.2.1.i.i233 = tail call i64 @llvm.smin.i64(i64 %nearest_cell_v113__vphi100_0.2.1.i.i232, i64 %.355.i.i188)
  %.405.i.i234 = uitofp nneg i64 %nearest_cell_v113__vphi120_0.2.1.i.i233 to double
  %.406.i.i235 = fsub contract double %.341.i.i229, %.405.i.i234
  %.440.i.i236 = load double, ptr %scevgep168.i, align 8, !noalias !53
  %.idx.i.i237 = mul i64 %nearest_cell_v113__vphi120_0.2.1.i.i233, 48
  %48 = getelementptr i8, ptr %44, i64 %.idx.i.i237
  %.470.i.i238 = load double, ptr %48, align 8, !noalias !53
  %49 = getelementptr i8, ptr %48, i64 8
  %.501.i.i239 = load double, ptr %49, align 8, !noalias !53
  %50 = getelementptr i8, ptr %48, i64 16
  %.532.i.i240 = load double, ptr %50, align 8, !noalias !53
  %51 = getelementptr i8, ptr %48, i64 24
  %.563.i.i241 = load double, ptr %51, align 8, !noalias !53
  %.564.i.i242 = fmul contract double %.563.i.i241, %.406.i.i235
  %.565.i.i243 = fadd contract double %.532.i.i240, %.564.i.i242
  %.566.i.i244 = fmul contract double %.406.i.i235, %.565.i.i243
  %.567.i.i245 = fadd contract double %.501.i.i239, %.566.i.i244
  %.568.i.i246 = fmul contract double %.406.i.i235, %.567.i.i245
  %.569.i.i247 = fadd contract double %.470.i.i238, %.568.i.i246
  %.570.i.i248 = fadd contract double %.440.i.i236, %.569.i.i247
  store double %.570.i.i248, ptr %scevgep168.i, align 8, !noalias !53
  %exitcond.not.i31.i = icmp eq i64 %.237.i.i191, 16
  br i1 %exitcond.not.i31.i, label %B436.i62, label %B134.if.i.i189

B584.if.i173:                                     ; preds = %B436.i62, %B584.if.i173
  %.103911991201.i = phi i64 [ %.1046.3.i, %B584.if.i173 ], [ 0, %B436.i62 ]
  %sunkaddr104.i = shl i64 %.103911991201.i, 3
  %sunkaddr105.i = getelementptr i8, ptr %arg.room.4, i64 %sunkaddr104.i
  %.1100.i = load double, ptr %sunkaddr105.i, align 8, !noalias !50
  %.1102.i174 = fmul contract double %arg.x, %.1100.i
  %sunkaddr109.i = getelementptr i8, ptr %sunkaddr105.i, i64 1024
  store double %.1102.i174, ptr %sunkaddr109.i, align 8, !noalias !50
  %sunkaddr112.i = getelementptr i8, ptr %sunkaddr105.i, i64 8
  %.1100.1.i = load double, ptr %sunkaddr112.i, align 8, !noalias !50
  %.1102.1.i175 = fmul contract double %arg.x, %.1100.1.i
  %sunkaddr115.i = getelementptr i8, ptr %sunkaddr105.i, i64 1032
  store double %.1102.1.i175, ptr %sunkaddr115.i, align 8, !noalias !50
  %sunkaddr118.i = getelementptr i8, ptr %sunkaddr105.i, i64 16
  %.1100.2.i = load double, ptr %sunkaddr118.i, align 8, !noalias !50
  %.1102.2.i176 = fmul contract double %arg.x, %.1100.2.i
  %sunkaddr121.i = getelementptr i8, ptr %sunkaddr105.i, i64 1040
  store double %.1102.2.i176, ptr %sunkaddr121.i, align 8, !noalias !50
  %.1046.3.i = add nuw nsw i64 %.103911991201.i, 4
  %sunkaddr124.i = getelementptr i8, ptr %sunkaddr105.i, i64 24
  %.1100.3.i = load double, ptr %sunkaddr124.i, align 8, !noalias !50
  %.1102.3.i177 = fmul contract double %arg.x, %.1100.3.i
  %sunkaddr127.i = getelementptr i8, ptr %sunkaddr105.i, i64 1048
  store double %.1102.3.i177, ptr %sunkaddr127.i, align 8, !noalias !50
  %niter83.ncmp.3.i = icmp eq i64 %.1046.3.i, 16
  br i1 %niter83.ncmp.3.i, label %B618.i, label %B584.if.i173

B902.if.i:                                        ; preds = %B902.if.i, %B716.i66
  %top.2.01210.i = phi double [ %.1560.i67, %B716.i66 ], [ %.1715.top.2.0.3.i76, %B902.if.i ]
  %.165012061208.i = phi i64 [ 0, %B716.i66 ], [ %.1657.3.i, %B902.if.i ]
  %sunkaddr128.i = shl i64 %.165012061208.i, 3
  %sunkaddr129.i = getelementptr i8, ptr %arg.room.4, i64 %sunkaddr128.i
  %sunkaddr131.i = getelementptr i8, ptr %sunkaddr129.i, i64 512
  %.1715.i = load double, ptr %sunkaddr131.i, align 8, !noalias !50
  %.1717.i = fcmp contract ogt double %.1715.i, %top.2.01210.i
  %.1715.top.2.0.i = select i1 %.1717.i, double %.1715.i, double %top.2.01210.i
  %sunkaddr134.i = getelementptr i8, ptr %sunkaddr129.i, i64 520
  %.1715.1.i68 = load double, ptr %sunkaddr134.i, align 8, !noalias !50
  %.1717.1.i69 = fcmp contract ogt double %.1715.1.i68, %.1715.top.2.0.i
  %.1715.top.2.0.1.i70 = select i1 %.1717.1.i69, double %.1715.1.i68, double %.1715.top.2.0.i
  %sunkaddr137.i = getelementptr i8, ptr %sunkaddr129.i, i64 528
  %.1715.2.i71 = load double, ptr %sunkaddr137.i, align 8, !noalias !50
  %.1717.2.i72 = fcmp contract ogt double %.1715.2.i71, %.1715.top.2.0.1.i70
  %.1715.top.2.0.2.i73 = select i1 %.1717.2.i72, double %.1715.2.i71, double %.1715.top.2.0.1.i70
  %.1657.3.i = add nuw nsw i64 %.165012061208.i, 4
  %sunkaddr140.i = getelementptr i8, ptr %sunkaddr129.i, i64 536
  %.1715.3.i74 = load double, ptr %sunkaddr140.i, align 8, !noalias !50
  %.1717.3.i75 = fcmp contract ogt double %.1715.3.i74, %.1715.top.2.0.2.i73
  %.1715.top.2.0.3.i76 = select i1 %.1717.3.i75, double %.1715.3.i74, double %.1715.top.2.0.2.i73
  %niter90.ncmp.3.i = icmp eq i64 %.1657.3.i, 16
  br i1 %niter90.ncmp.3.i, label %B982.if.preheader.i, label %B902.if.i

B982.if.preheader.i:                              ; preds = %B902.if.i
  %invariant.gep.i = getelementptr i8, ptr %.758, i64 128
  br label %B982.if.i77

B982.if.i77:                                      ; preds = %B982.if.i77, %B982.if.preheader.i
  %.186212151217.i = phi i64 [ %.1869.i, %B982.if.i77 ], [ 0, %B982.if.preheader.i ]
  %.1869.i = add nuw nsw i64 %.186212151217.i, 1
  %52 = shl i64 %.186212151217.i, 3
  %scevgep138.i = getelementptr i8, ptr %invariant.gep.i, i64 %52
  %.1929.i78 = load double, ptr %scevgep138.i, align 8, !noalias !50
  %scevgep139.i = getelementptr i8, ptr %.164.i17, i64 %52
  %.1964.i79 = load double, ptr %scevgep139.i, align 8, !noalias !50
  %.1966.i80 = fsub contract double %.1964.i79, %.1715.top.2.0.3.i76
  %.1972.i81 = fcmp contract ogt double %.1966.i80, -7.000000e+02
  %.1966..i82 = select i1 %.1972.i81, double %.1966.i80, double -7.000000e+02
  %.1989.i83 = tail call contract double @llvm.fma.f64(double %.1966..i82, double 0x3FF71547652B82FE, double 0x4338000000000000)
  %.1990.i84 = fadd contract double %.1989.i83, 0xC338000000000000
  %.1993.i85 = tail call contract double @llvm.fma.f64(double %.1990.i84, double 0xBFE62E42FEFA39EF, double %.1966..i82)
  %.1994.i86 = tail call contract double @llvm.fma.f64(double %.1990.i84, double 0xBC7ABC9E3B39803F, double %.1993.i85)
  %.1995.i87 = tail call contract double @llvm.fma.f64(double %.1994.i86, double 0x3DE6124613A86D09, double 0x3E21EED8EFF8D898)
  %.1996.i88 = tail call contract double @llvm.fma.f64(double %.1994.i86, double %.1995.i87, double 0x3E5AE64567F544E4)
  %.1997.i89 = tail call contract double @llvm.fma.f64(double %.1994.i86, double %.1996.i88, double 0x3E927E4FB7789F5C)
  %.1998.i90 = tail call contract double @llvm.fma.f64(double %.1994.i86, double %.1997.i89, double 0x3EC71DE3A556C734)
  %.1999.i91 = tail call contract double @llvm.fma.f64(double %.1994.i86, double %.1998.i90, double 0x3EFA01A01A01A01A)
  %.2000.i92 = tail call contract double @llvm.fma.f64(double %.1994.i86, double %.1999.i91, double 0x3F2A01A01A01A01A)
  %.2001.i93 = tail call contract double @llvm.fma.f64(double %.1994.i86, double %.2000.i92, double 0x3F56C16C16C16C17)
  %.2002.i94 = tail call contract double @llvm.fma.f64(double %.1994.i86, double %.2001.i93, double 0x3F81111111111111)
  %.2003.i95 = tail call contract double @llvm.fma.f64(double %.1994.i86, double %.2002.i94, double 0x3FA5555555555555)
  %.2004.i96 = tail call contract double @llvm.fma.f64(double %.1994.i86, double %.2003.i95, double 0x3FC5555555555555)
  %.2005.i97 = tail call contract double @llvm.fma.f64(double %.1994.i86, double %.2004.i96, double 5.000000e-01)
  %.2006.i98 = fmul contract double %.1994.i86, %.1994.i86
  %.2007.i99 = fadd contract double %.1994.i86, 1.000000e+00
  %.2008.i100 = tail call contract double @llvm.fma.f64(double %.2006.i98, double %.2005.i97, double %.2007.i99)
  %.2009.i101 = bitcast double %.1989.i83 to i64
  %.2010.i102 = shl i64 %.2009.i101, 52
  %.2011.i103 = add i64 %.2010.i102, 4607182418800017408
  %.2012.i104 = bitcast i64 %.2011.i103 to double
  %.2013.i105 = fmul contract double %.2008.i100, %.2012.i104
  %.2015.i106 = fmul contract double %.1929.i78, %.2013.i105
  store double %.2015.i106, ptr %scevgep139.i, align 8, !noalias !50
  %exitcond1242.not.i = icmp eq i64 %.1869.i, 16
  br i1 %exitcond1242.not.i, label %B1198.i107, label %B982.if.i77

B1198.endif.i:                                    ; preds = %B104.if.i.i
  %.1253.i124 = fmul contract double %arg.x, 5.000000e-01
  %.1255.i125 = fmul contract double %.1253.i124, %.136
  %53 = fadd contract double %.244.i.i109, %.279.i.i111
  %54 = fadd contract double %.314.i.i113, %.349.i.i115
  %55 = fadd contract double %53, %54
  %56 = fadd contract double %.384.i.i117, %.419.i.i119
  %57 = fadd contract double %.454.i.i121, %.489.i.i123
  %58 = fadd contract double %56, %57
  %59 = fadd contract double %55, %58
  %.2090.i126 = fmul contract double %.142, %59
  %.2122.i127 = getelementptr i8, ptr %arg.arguments.4, i64 184
  %.2123.i128 = load i64, ptr %.2122.i127, align 8, !noalias !50
  %.2124.i129 = icmp eq i64 %.2123.i128, 0
  br i1 %.2124.i129, label %_ZN17bnserve_inference15marginal_kernel9_distance8_by_ruleB4v115B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEdddd27Literal_5bbool_5d_28True_295ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit, label %B1266.if.i130

B1266.if.i130:                                    ; preds = %B1198.endif.i, %B1266.if.i130
  %squares.2.01226.i = phi double [ %.2394.3.i146, %B1266.if.i130 ], [ 0.000000e+00, %B1198.endif.i ]
  %.226912221224.i = phi i64 [ %.2276.3.i, %B1266.if.i130 ], [ 0, %B1198.endif.i ]
  %sunkaddr141.i = shl i64 %.226912221224.i, 3
  %sunkaddr142.i = getelementptr i8, ptr %arg.room.4, i64 %sunkaddr141.i
  %sunkaddr144.i = getelementptr i8, ptr %sunkaddr142.i, i64 512
  %.2330.i = load double, ptr %sunkaddr144.i, align 8, !noalias !50
  %.2360.i131 = load double, ptr %sunkaddr142.i, align 8, !noalias !50
  %.2361.i132 = fmul contract double %.2330.i, %.2360.i131
  %.2392.i133 = fmul contract double %.2360.i131, %.2361.i132
  %.2394.i134 = fadd contract double %squares.2.01226.i, %.2392.i133
  %sunkaddr149.i = getelementptr i8, ptr %sunkaddr142.i, i64 520
  %.2330.1.i = load double, ptr %sunkaddr149.i, align 8, !noalias !50
  %sunkaddr152.i = getelementptr i8, ptr %sunkaddr142.i, i64 8
  %.2360.1.i135 = load double, ptr %sunkaddr152.i, align 8, !noalias !50
  %.2361.1.i136 = fmul contract double %.2330.1.i, %.2360.1.i135
  %.2392.1.i137 = fmul contract double %.2360.1.i135, %.2361.1.i136
  %.2394.1.i138 = fadd contract double %.2394.i134, %.2392.1.i137
  %sunkaddr155.i = getelementptr i8, ptr %sunkaddr142.i, i64 528
  %.2330.2.i = load double, ptr %sunkaddr155.i, align 8, !noalias !50
  %sunkaddr158.i = getelementptr i8, ptr %sunkaddr142.i, i64 16
  %.2360.2.i139 = load double, ptr %sunkaddr158.i, align 8, !noalias !50
  %.2361.2.i140 = fmul contract double %.2330.2.i, %.2360.2.i139
  %.2392.2.i141 = fmul contract double %.2360.2.i139, %.2361.2.i140
  %.2394.2.i142 = fadd contract double %.2394.1.i138, %.2392.2.i141
  %.2276.3.i = add nuw nsw i64 %.226912221224.i, 4
  %sunkaddr161.i = getelementptr i8, ptr %sunkaddr142.i, i64 536
  %.2330.3.i = load double, ptr %sunkaddr161.i, align 8, !noalias !50
  %sunkaddr164.i = getelementptr i8, ptr %sunkaddr142.i, i64 24
  %.2360.3.i143 = load double, ptr %sunkaddr164.i, align 8, !noalias !50
  %.2361.3.i144 = fmul contract double %.2330.3.i, %.2360.3.i143
  %.2392.3.i145 = fmul contract double %.2360.3.i143, %.2361.3.i144
  %.2394.3.i146 = fadd contract double %.2394.2.i142, %.2392.3.i145
  %niter97.ncmp.3.i = icmp eq i64 %.2276.3.i, 16
  br i1 %niter97.ncmp.3.i, label %B1334.i, label %B1266.if.i130

B3839.if.i:                                       ; preds = %B3839.if.i.preheader, %B3839.if.i
  %firsts.2.01235.i = phi double [ %.2646.3.i163, %B3839.if.i ], [ 0.000000e+00, %B3839.if.i.preheader ]
  %.255212311233.i = phi i64 [ %.2559.3.i, %B3839.if.i ], [ 0, %B3839.if.i.preheader ]
  %sunkaddr165.i = shl i64 %.255212311233.i, 3
  %sunkaddr166.i = getelementptr i8, ptr %arg.room.4, i64 %sunkaddr165.i
  %sunkaddr168.i = getelementptr i8, ptr %sunkaddr166.i, i64 512
  %.2613.i148 = load double, ptr %sunkaddr168.i, align 8, !noalias !50
  %.2643.i149 = load double, ptr %sunkaddr166.i, align 8, !noalias !50
  %.2644.i150 = fmul contract double %.2613.i148, %.2643.i149
  %.2646.i151 = fadd contract double %firsts.2.01235.i, %.2644.i150
  %sunkaddr173.i = getelementptr i8, ptr %sunkaddr166.i, i64 520
  %.2613.1.i152 = load double, ptr %sunkaddr173.i, align 8, !noalias !50
  %sunkaddr176.i = getelementptr i8, ptr %sunkaddr166.i, i64 8
  %.2643.1.i153 = load double, ptr %sunkaddr176.i, align 8, !noalias !50
  %.2644.1.i154 = fmul contract double %.2613.1.i152, %.2643.1.i153
  %.2646.1.i155 = fadd contract double %.2646.i151, %.2644.1.i154
  %sunkaddr179.i = getelementptr i8, ptr %sunkaddr166.i, i64 528
  %.2613.2.i156 = load double, ptr %sunkaddr179.i, align 8, !noalias !50
  %sunkaddr182.i = getelementptr i8, ptr %sunkaddr166.i, i64 16
  %.2643.2.i157 = load double, ptr %sunkaddr182.i, align 8, !noalias !50
  %.2644.2.i158 = fmul contract double %.2613.2.i156, %.2643.2.i157
  %.2646.2.i159 = fadd contract double %.2646.1.i155, %.2644.2.i158
  %.2559.3.i = add nuw nsw i64 %.255212311233.i, 4
  %sunkaddr185.i = getelementptr i8, ptr %sunkaddr166.i, i64 536
  %.2613.3.i160 = load double, ptr %sunkaddr185.i, align 8, !noalias !50
  %sunkaddr188.i = getelementptr i8, ptr %sunkaddr166.i, i64 24
  %.2643.3.i161 = load double, ptr %sunkaddr188.i, align 8, !noalias !50
  %.2644.3.i162 = fmul contract double %.2613.3.i160, %.2643.3.i161
  %.2646.3.i163 = fadd contract double %.2646.2.i159, %.2644.3.i162
  %niter104.ncmp.3.i = icmp eq i64 %.2559.3.i, 16
  br i1 %niter104.ncmp.3.i, label %B3855.i, label %B3839.if.i

_ZN17bnserve_inference15marginal_kernel9_distance8_by_ruleB4v115B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEdddd27Literal_5bbool_5d_28True_295ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit: ; preds = %B1198.endif.i, %B3855.i
  %.815.sroa.8.0 = phi double [ %.2673.i165, %B3855.i ], [ 0.000000e+00, %B1198.endif.i ]
  %.815.sroa.11.0 = phi double [ %.2678.i166, %B3855.i ], [ 0.000000e+00, %B1198.endif.i ]
  %.815.sroa.0.0 = fadd contract double %.1255.i125, %.1715.top.2.0.3.i76
  call void @llvm.lifetime.end.p0(ptr nonnull %.1211.i1)
  call void @llvm.lifetime.end.p0(ptr nonnull %.2410.i3)
  br label %common.ret

B1396:                                            ; preds = %B950, %B72
  %.916 = getelementptr i8, ptr %arg.prior.4, i64 8
  %.917 = load double, ptr %.916, align 8
  %.946 = getelementptr i8, ptr %arg.prior.4, i64 16
  %.947 = load double, ptr %.946, align 8
  %.956 = fmul contract double %.947, %.947
  %.960 = fdiv contract double 0x3EB0C6F7A0B5ED8D, %.956
  %.966 = fcmp contract ogt double %arg.n, %.960
  %"$phi676.0.2.0" = select i1 %.966, double %arg.n, double %.960
  %.988 = fdiv contract double %arg.x, %"$phi676.0.2.0"
  %.12.i = fcmp contract ogt double %.917, %.988
  %.13.i = select i1 %.12.i, double %.917, double %.988
  %.12.i17 = fcmp contract olt double %.947, %.13.i
  %.13.i18 = select i1 %.12.i17, double %.947, double %.13.i
  %.1047 = fsub contract double %.13.i18, %.988
  %.1049 = fmul contract double %.1047, %.1047
  %.1078 = getelementptr i8, ptr %arg.prior.4, i64 24
  %.1079 = load double, ptr %.1078, align 8
  %.1080 = fmul contract double %.1079, 2.000000e+00
  %.1084 = fdiv contract double %.1080, %"$phi676.0.2.0"
  %.1085 = fadd contract double %.1084, %.1049
  %.1086 = tail call contract double @llvm.sqrt.f64(double %.1085)
  %.1087 = fsub contract double %.988, %.1086
  %.12.i19 = fcmp contract ogt double %.1087, %.917
  %.13.i20 = select i1 %.12.i19, double %.1087, double %.917
  %.1119 = fadd contract double %.988, %.1086
  %.12.i21 = fcmp contract olt double %.1119, %.947
  %.13.i22 = select i1 %.12.i21, double %.1119, double %.947
  %.1158 = fmul contract double %.13.i20, 1.500000e+00
  %.1160 = fcmp contract olt double %.13.i22, %.1158
  br i1 %.1160, label %B1430, label %B1524

B1430:                                            ; preds = %B1396
  %.1190 = getelementptr i8, ptr %arg.arguments.4, i64 96
  %.1191 = load i64, ptr %.1190, align 8
  %.1221 = getelementptr i8, ptr %arg.arguments.4, i64 104
  %.1222 = load i64, ptr %.1221, align 8
  %.1224 = inttoptr i64 %.1222 to ptr
  %.1274 = fsub contract double %.13.i22, %.13.i20
  %.1277 = fmul contract double %.1274, 5.000000e-01
  %.1286 = fadd contract double %.13.i20, %.1277
  call void @llvm.lifetime.start.p0(ptr nonnull %.1211.i249)
  call void @llvm.lifetime.start.p0(ptr nonnull %.2410.i251)
  store ptr null, ptr %.1211.i249, align 8, !noalias !59
  store ptr null, ptr %.2410.i251, align 8, !noalias !59
  %.164.i253 = getelementptr i8, ptr %arg.room.4, i64 512
  %.271.i = icmp sgt i64 %.1191, 0
  br i1 %.271.i, label %B112.if.preheader.i, label %B274.i254

B112.if.preheader.i:                              ; preds = %B1430
  %xtraiter.i = and i64 %.1191, 3
  %60 = icmp slt i64 %.1191, 4
  br i1 %60, label %B112.if.epil.preheader.i, label %B112.if.preheader.new.i

B112.if.preheader.new.i:                          ; preds = %B112.if.preheader.i
  %unroll_iter.i = and i64 %.1191, 9223372036854775804
  br label %B112.if.i507

B274.i254:                                        ; preds = %B182.if.i530, %B1430
  %.703.i255 = getelementptr i8, ptr %arg.arguments.4, i64 64
  %.704.i256 = load i64, ptr %.703.i255, align 8, !noalias !59
  %.709.i257 = icmp sgt i64 %.704.i256, 0
  br i1 %.709.i257, label %B322.i438, label %B436.i258

B322.i438:                                        ; preds = %B274.i254
  %.88.i.i439 = getelementptr i8, ptr %arg.prior.4, i64 56
  %.89.i.i440 = load double, ptr %.88.i.i439, align 8, !noalias !62
  %.117.i.i441 = getelementptr i8, ptr %arg.prior.4, i64 64
  %.118.i.i442 = load double, ptr %.117.i.i441, align 8, !noalias !62
  %.125.i.i443 = fdiv contract double 1.000000e+00, %.118.i.i442
  %.224208.not.i.i = icmp slt i64 %.1191, 1
  br i1 %.224208.not.i.i, label %B436.i258, label %B134.if.lr.ph.i.i

B436.i258:                                        ; preds = %B134.if.i.i447, %B322.i438, %B274.i254
  %.876.i259 = load i64, ptr %arg.arguments.4, align 8, !noalias !59
  %.877.i260 = icmp eq i64 %.876.i259, 1
  %.894.i261 = getelementptr inbounds nuw i8, ptr %arg.room.4, i64 1024
  br i1 %.877.i260, label %B554.i, label %B716.i262

B554.i:                                           ; preds = %B436.i258
  %.10331202.not.i = icmp slt i64 %.1191, 1
  br i1 %.10331202.not.i, label %B618.i435, label %B584.if.preheader.i

B584.if.preheader.i:                              ; preds = %B554.i
  %xtraiter80.i = and i64 %.1191, 3
  %61 = icmp slt i64 %.1191, 4
  br i1 %61, label %B584.if.epil.preheader.i, label %B584.if.preheader.new.i

B584.if.preheader.new.i:                          ; preds = %B584.if.preheader.i
  %unroll_iter84.i = and i64 %.1191, 9223372036854775804
  br label %B584.if.i420

B618.loopexit.unr-lcssa.i:                        ; preds = %B584.if.i420
  %lcmp.mod82.not.i = icmp eq i64 %xtraiter80.i, 0
  br i1 %lcmp.mod82.not.i, label %B618.i435, label %B584.if.epil.preheader.i

B584.if.epil.preheader.i:                         ; preds = %B618.loopexit.unr-lcssa.i, %B584.if.preheader.i
  %.103912011203.epil.init.i = phi i64 [ 0, %B584.if.preheader.i ], [ %.1046.3.i432, %B618.loopexit.unr-lcssa.i ]
  %62 = shl i64 %.103912011203.epil.init.i, 3
  %63 = getelementptr i8, ptr %arg.room.4, i64 %62
  %scevgep165.i = getelementptr i8, ptr %63, i64 1024
  br label %B584.if.epil.i

B584.if.epil.i:                                   ; preds = %B584.if.epil.i, %B584.if.epil.preheader.i
  %epil.iter81.i = phi i64 [ %epil.iter81.next.i, %B584.if.epil.i ], [ 0, %B584.if.epil.preheader.i ]
  %64 = shl i64 %epil.iter81.i, 3
  %scevgep53.i = getelementptr i8, ptr %scevgep165.i, i64 %64
  %scevgep54.i = getelementptr i8, ptr %scevgep53.i, i64 -1024
  %.1100.epil.i = load double, ptr %scevgep54.i, align 8, !noalias !59
  %.1102.epil.i = fmul contract double %arg.x, %.1100.epil.i
  store double %.1102.epil.i, ptr %scevgep53.i, align 8, !noalias !59
  %epil.iter81.next.i = add i64 %epil.iter81.i, 1
  %epil.iter81.cmp.not.i = icmp eq i64 %xtraiter80.i, %epil.iter81.next.i
  br i1 %epil.iter81.cmp.not.i, label %B618.i435, label %B584.if.epil.i, !llvm.loop !65

B618.i435:                                        ; preds = %B584.if.epil.i, %B618.loopexit.unr-lcssa.i, %B554.i
  %.1157.i436 = getelementptr inbounds nuw i8, ptr %arg.room.4, i64 1536
  store ptr null, ptr %.1211.i249, align 8, !noalias !59
  call fastcc void @inner_3(ptr nonnull %.1211.i249, ptr nonnull %.894.i261, i64 %.1191, ptr nonnull readonly %arg.arguments.4, ptr nonnull %.1157.i436, ptr nonnull %.164.i253, i64 %.1191)
  br label %B716.i262

B716.i262:                                        ; preds = %B618.i435, %B436.i258
  %.13531209.not.i = icmp slt i64 %.1191, 1
  br i1 %.13531209.not.i, label %B952.thread.i, label %B770.if.lr.ph.i

B952.thread.i:                                    ; preds = %B716.i262
  %.15602.i = load double, ptr %.164.i253, align 8, !noalias !59
  br label %B1198.i318

B770.if.lr.ph.i:                                  ; preds = %B716.i262
  %.1454.i = fmul contract double %arg.n, 5.000000e-01
  %65 = add nsw i64 %.1191, -1
  %66 = icmp eq i64 %65, 0
  br i1 %66, label %B770.if.epil.preheader.i, label %B770.if.lr.ph.new.i

B770.if.lr.ph.new.i:                              ; preds = %B770.if.lr.ph.i
  %unroll_iter90.i = and i64 %.1191, 9223372036854775806
  br label %B770.if.i

B902.if.preheader.unr-lcssa.i:                    ; preds = %B770.if.i
  %67 = and i64 %.1191, 1
  %lcmp.mod88.not.i = icmp eq i64 %67, 0
  br i1 %lcmp.mod88.not.i, label %B902.if.preheader.i, label %B770.if.epil.preheader.i

B770.if.epil.preheader.i:                         ; preds = %B902.if.preheader.unr-lcssa.i, %B770.if.lr.ph.i
  %.135912081210.epil.init.i = phi i64 [ 0, %B770.if.lr.ph.i ], [ %.1366.1.i, %B902.if.preheader.unr-lcssa.i ]
  %sunkaddr.i = shl i64 %.135912081210.epil.init.i, 3
  %sunkaddr211.i = getelementptr i8, ptr %arg.room.4, i64 %sunkaddr.i
  %sunkaddr212.i = getelementptr i8, ptr %sunkaddr211.i, i64 512
  %.1422.epil.i = load double, ptr %sunkaddr212.i, align 8, !noalias !59
  %68 = getelementptr double, ptr %arg.room.4, i64 %.135912081210.epil.init.i
  %.1452.epil.i = load double, ptr %68, align 8, !noalias !59
  %.1485.epil.i = fmul contract double %.1454.i, %.1452.epil.i
  %.1487.epil.i = fsub contract double %arg.x, %.1485.epil.i
  %.1488.epil.i = fmul contract double %.1452.epil.i, %.1487.epil.i
  %.1489.epil.i = fadd contract double %.1422.epil.i, %.1488.epil.i
  store double %.1489.epil.i, ptr %sunkaddr212.i, align 8, !noalias !59
  br label %B902.if.preheader.i

B902.if.preheader.i:                              ; preds = %B770.if.epil.preheader.i, %B902.if.preheader.unr-lcssa.i
  %.1560.i265 = load double, ptr %.164.i253, align 8, !noalias !59
  %xtraiter92.i = and i64 %.1191, 3
  %69 = icmp ult i64 %65, 3
  br i1 %69, label %B902.if.epil.preheader.i, label %B902.if.preheader.new.i

B902.if.preheader.new.i:                          ; preds = %B902.if.preheader.i
  %unroll_iter97.i = and i64 %.1191, 9223372036854775804
  br label %B902.if.i266

B1198.i318:                                       ; preds = %B982.if.i287, %B952.thread.i
  %top.2.0.lcssa6.i = phi double [ %.15602.i, %B952.thread.i ], [ %.1715.top.2.0.lcssa.i, %B982.if.i287 ]
  %.60.1.i.i = ashr i64 %.1191, 3
  %.174158.not.i.i = icmp slt i64 %.60.1.i.i, 1
  br i1 %.174158.not.i.i, label %B1198.endif.i357, label %B104.if.preheader.i.i

B104.if.preheader.i.i:                            ; preds = %B1198.i318
  %scevgep.i.i319 = getelementptr i8, ptr %arg.room.4, i64 568
  br label %B104.if.i.i320

B348.loopexit.i.i:                                ; preds = %B104.if.i.i320
  %70 = fadd contract double %.244.i.i333, %.279.i.i336
  %71 = fadd contract double %.314.i.i339, %.349.i.i342
  %72 = fadd contract double %70, %71
  %73 = fadd contract double %.384.i.i345, %.419.i.i348
  %74 = fadd contract double %.454.i.i351, %.489.i.i353
  %75 = fadd contract double %73, %74
  %76 = fadd contract double %72, %75
  br label %B1198.endif.i357

B104.if.i.i320:                                   ; preds = %B104.if.i.i320, %B104.if.preheader.i.i
  %lsr.iv9.i.i321 = phi i64 [ %.60.1.i.i, %B104.if.preheader.i.i ], [ %lsr.iv.next.i.i355, %B104.if.i.i320 ]
  %lsr.iv.i.i322 = phi ptr [ %scevgep.i.i319, %B104.if.preheader.i.i ], [ %scevgep1.i.i354, %B104.if.i.i320 ]
  %s7.2.0168.i.i323 = phi double [ 0.000000e+00, %B104.if.preheader.i.i ], [ %.489.i.i353, %B104.if.i.i320 ]
  %s6.2.0167.i.i324 = phi double [ 0.000000e+00, %B104.if.preheader.i.i ], [ %.454.i.i351, %B104.if.i.i320 ]
  %s5.2.0166.i.i325 = phi double [ 0.000000e+00, %B104.if.preheader.i.i ], [ %.419.i.i348, %B104.if.i.i320 ]
  %s4.2.0165.i.i326 = phi double [ 0.000000e+00, %B104.if.preheader.i.i ], [ %.384.i.i345, %B104.if.i.i320 ]
  %s3.2.0164.i.i327 = phi double [ 0.000000e+00, %B104.if.preheader.i.i ], [ %.349.i.i342, %B104.if.i.i320 ]
  %s2.2.0163.i.i328 = phi double [ 0.000000e+00, %B104.if.preheader.i.i ], [ %.314.i.i339, %B104.if.i.i320 ]
  %s1.2.0162.i.i329 = phi double [ 0.000000e+00, %B104.if.preheader.i.i ], [ %.279.i.i336, %B104.if.i.i320 ]
  %s0.2.0161.i.i330 = phi double [ 0.000000e+00, %B104.if.preheader.i.i ], [ %.244.i.i333, %B104.if.i.i320 ]
  %scevgep2.i.i331 = getelementptr i8, ptr %lsr.iv.i.i322, i64 -56
  %.242.i.i332 = load double, ptr %scevgep2.i.i331, align 8, !noalias !66
  %.244.i.i333 = fadd contract double %s0.2.0161.i.i330, %.242.i.i332
  %scevgep3.i.i334 = getelementptr i8, ptr %lsr.iv.i.i322, i64 -48
  %.277.i.i335 = load double, ptr %scevgep3.i.i334, align 8, !noalias !66
  %.279.i.i336 = fadd contract double %s1.2.0162.i.i329, %.277.i.i335
  %scevgep4.i.i337 = getelementptr i8, ptr %lsr.iv.i.i322, i64 -40
  %.312.i.i338 = load double, ptr %scevgep4.i.i337, align 8, !noalias !66
  %.314.i.i339 = fadd contract double %s2.2.0163.i.i328, %.312.i.i338
  %scevgep5.i.i340 = getelementptr i8, ptr %lsr.iv.i.i322, i64 -32
  %.347.i.i341 = load double, ptr %scevgep5.i.i340, align 8, !noalias !66
  %.349.i.i342 = fadd contract double %s3.2.0164.i.i327, %.347.i.i341
  %scevgep6.i.i343 = getelementptr i8, ptr %lsr.iv.i.i322, i64 -24
  %.382.i.i344 = load double, ptr %scevgep6.i.i343, align 8, !noalias !66
  %.384.i.i345 = fadd contract double %s4.2.0165.i.i326, %.382.i.i344
  %scevgep7.i.i346 = getelementptr i8, ptr %lsr.iv.i.i322, i64 -16
  %.417.i.i347 = load double, ptr %scevgep7.i.i346, align 8, !noalias !66
  %.419.i.i348 = fadd contract double %s5.2.0166.i.i325, %.417.i.i347
  %scevgep8.i.i349 = getelementptr i8, ptr %lsr.iv.i.i322, i64 -8
  %.452.i.i350 = load double, ptr %scevgep8.i.i349, align 8, !noalias !66
  %.454.i.i351 = fadd contract double %s6.2.0167.i.i324, %.452.i.i350
  %.487.i.i352 = load double, ptr %lsr.iv.i.i322, align 8, !noalias !66
  %.489.i.i353 = fadd contract double %s7.2.0168.i.i323, %.487.i.i352
  %scevgep1.i.i354 = getelementptr i8, ptr %lsr.iv.i.i322, i64 64
  %lsr.iv.next.i.i355 = add nsw i64 %lsr.iv9.i.i321, -1
  %exitcond.not.i.i356 = icmp eq i64 %lsr.iv.next.i.i355, 0
  br i1 %exitcond.not.i.i356, label %B348.loopexit.i.i, label %B104.if.i.i320

B1262.i:                                          ; preds = %B1198.endif.i357
  br i1 %.13531209.not.i, label %B1334.i391, label %B1266.if.preheader.i

B1266.if.preheader.i:                             ; preds = %B1262.i
  %xtraiter99.i = and i64 %.1191, 3
  %77 = icmp ult i64 %.1191, 4
  br i1 %77, label %B1266.if.epil.preheader.i, label %B1266.if.preheader.new.i

B1266.if.preheader.new.i:                         ; preds = %B1266.if.preheader.i
  %unroll_iter104.i = and i64 %.1191, 9223372036854775804
  br label %B1266.if.i362

B1334.loopexit.unr-lcssa.i:                       ; preds = %B1266.if.i362
  %lcmp.mod101.not.i = icmp eq i64 %xtraiter99.i, 0
  br i1 %lcmp.mod101.not.i, label %B1334.i391, label %B1266.if.epil.preheader.i

B1266.if.epil.preheader.i:                        ; preds = %B1334.loopexit.unr-lcssa.i, %B1266.if.preheader.i
  %squares.2.01235.epil.init.i = phi double [ 0.000000e+00, %B1266.if.preheader.i ], [ %.2394.3.i390, %B1334.loopexit.unr-lcssa.i ]
  %.226912311233.epil.init.i = phi i64 [ 0, %B1266.if.preheader.i ], [ %unroll_iter104.i, %B1334.loopexit.unr-lcssa.i ]
  %78 = shl i64 %.226912311233.epil.init.i, 3
  %79 = getelementptr i8, ptr %arg.room.4, i64 %78
  %scevgep129.i = getelementptr i8, ptr %79, i64 512
  br label %B1266.if.epil.i

B1266.if.epil.i:                                  ; preds = %B1266.if.epil.i, %B1266.if.epil.preheader.i
  %squares.2.01235.epil.i = phi double [ %.2394.epil.i, %B1266.if.epil.i ], [ %squares.2.01235.epil.init.i, %B1266.if.epil.preheader.i ]
  %epil.iter100.i = phi i64 [ %epil.iter100.next.i, %B1266.if.epil.i ], [ 0, %B1266.if.epil.preheader.i ]
  %80 = shl i64 %epil.iter100.i, 3
  %scevgep21.i = getelementptr i8, ptr %scevgep129.i, i64 %80
  %.2330.epil.i = load double, ptr %scevgep21.i, align 8, !noalias !59
  %scevgep20.i = getelementptr i8, ptr %scevgep21.i, i64 -512
  %.2360.epil.i = load double, ptr %scevgep20.i, align 8, !noalias !59
  %.2361.epil.i = fmul contract double %.2330.epil.i, %.2360.epil.i
  %.2392.epil.i = fmul contract double %.2360.epil.i, %.2361.epil.i
  %.2394.epil.i = fadd contract double %squares.2.01235.epil.i, %.2392.epil.i
  %epil.iter100.next.i = add i64 %epil.iter100.i, 1
  %epil.iter100.cmp.not.i = icmp eq i64 %xtraiter99.i, %epil.iter100.next.i
  br i1 %epil.iter100.cmp.not.i, label %B1334.i391, label %B1266.if.epil.i, !llvm.loop !69

B1334.i391:                                       ; preds = %B1266.if.epil.i, %B1334.loopexit.unr-lcssa.i, %B1262.i
  %squares.2.0.lcssa.i = phi double [ 0.000000e+00, %B1262.i ], [ %.2394.3.i390, %B1334.loopexit.unr-lcssa.i ], [ %.2394.epil.i, %B1266.if.epil.i ]
  br i1 %.877.i260, label %B1336.i416, label %B1380.i392

B1336.i416:                                       ; preds = %B1334.i391
  store ptr null, ptr %.2410.i251, align 8, !noalias !59
  call fastcc void @inner_4(ptr nonnull %.2410.i251, ptr nonnull %.894.i261, i64 %.1191, ptr %arg.room.4, ptr nonnull readonly %arg.arguments.4)
  br label %B1380.i392

B1380.i392:                                       ; preds = %B1336.i416, %B1334.i391
  br i1 %.13531209.not.i, label %B3933.i, label %B3917.if.preheader.i

B3917.if.preheader.i:                             ; preds = %B1380.i392
  %xtraiter106.i = and i64 %.1191, 3
  %81 = icmp ult i64 %.1191, 4
  br i1 %81, label %B3917.if.epil.preheader.i, label %B3917.if.preheader.new.i

B3917.if.preheader.new.i:                         ; preds = %B3917.if.preheader.i
  %unroll_iter111.i = and i64 %.1191, 9223372036854775804
  br label %B3917.if.i

B3933.loopexit.unr-lcssa.i:                       ; preds = %B3917.if.i
  %lcmp.mod108.not.i = icmp eq i64 %xtraiter106.i, 0
  br i1 %lcmp.mod108.not.i, label %B3933.i, label %B3917.if.epil.preheader.i

B3917.if.epil.preheader.i:                        ; preds = %B3933.loopexit.unr-lcssa.i, %B3917.if.preheader.i
  %firsts.2.01244.epil.init.i = phi double [ 0.000000e+00, %B3917.if.preheader.i ], [ %.2646.3.i410, %B3933.loopexit.unr-lcssa.i ]
  %.255212401242.epil.init.i = phi i64 [ 0, %B3917.if.preheader.i ], [ %unroll_iter111.i, %B3933.loopexit.unr-lcssa.i ]
  %82 = shl i64 %.255212401242.epil.init.i, 3
  %83 = getelementptr i8, ptr %arg.room.4, i64 %82
  %scevgep.i411 = getelementptr i8, ptr %83, i64 512
  br label %B3917.if.epil.i

B3917.if.epil.i:                                  ; preds = %B3917.if.epil.i, %B3917.if.epil.preheader.i
  %firsts.2.01244.epil.i = phi double [ %.2646.epil.i, %B3917.if.epil.i ], [ %firsts.2.01244.epil.init.i, %B3917.if.epil.preheader.i ]
  %epil.iter107.i = phi i64 [ %epil.iter107.next.i, %B3917.if.epil.i ], [ 0, %B3917.if.epil.preheader.i ]
  %84 = shl i64 %epil.iter107.i, 3
  %scevgep3.i = getelementptr i8, ptr %scevgep.i411, i64 %84
  %.2613.epil.i = load double, ptr %scevgep3.i, align 8, !noalias !59
  %scevgep2.i412 = getelementptr i8, ptr %scevgep3.i, i64 -512
  %.2643.epil.i = load double, ptr %scevgep2.i412, align 8, !noalias !59
  %.2644.epil.i = fmul contract double %.2613.epil.i, %.2643.epil.i
  %.2646.epil.i = fadd contract double %firsts.2.01244.epil.i, %.2644.epil.i
  %epil.iter107.next.i = add i64 %epil.iter107.i, 1
  %epil.iter107.cmp.not.i = icmp eq i64 %xtraiter106.i, %epil.iter107.next.i
  br i1 %epil.iter107.cmp.not.i, label %B3933.i, label %B3917.if.epil.i, !llvm.loop !70

B3933.i:                                          ; preds = %B3917.if.epil.i, %B3933.loopexit.unr-lcssa.i, %B1380.i392
  %firsts.2.0.lcssa.i = phi double [ 0.000000e+00, %B1380.i392 ], [ %.2646.3.i410, %B3933.loopexit.unr-lcssa.i ], [ %.2646.epil.i, %B3917.if.epil.i ]
  %.2673.i414 = fmul contract double %.1277, %firsts.2.0.lcssa.i
  %.2678.i415 = fmul contract double %.1277, %squares.2.0.lcssa.i
  br label %_ZN17bnserve_inference15marginal_kernel9_distance8_by_ruleB4v124B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEdddd28Literal_5bbool_5d_28False_295ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit

B112.if.i507:                                     ; preds = %B112.if.i507, %B112.if.preheader.new.i
  %.31911881190.i = phi i64 [ 0, %B112.if.preheader.new.i ], [ %.326.3.i522, %B112.if.i507 ]
  %sunkaddr91.i508 = shl i64 %.31911881190.i, 3
  %sunkaddr92.i = getelementptr i8, ptr %.1224, i64 %sunkaddr91.i508
  %.380.i509 = load double, ptr %sunkaddr92.i, align 8, !noalias !59
  %.382.i510 = fmul contract double %.1277, %.380.i509
  %.384.i511 = fadd contract double %.1286, %.382.i510
  %sunkaddr94.i512 = getelementptr i8, ptr %arg.room.4, i64 %sunkaddr91.i508
  store double %.384.i511, ptr %sunkaddr94.i512, align 8, !noalias !59
  %sunkaddr97.i513 = getelementptr i8, ptr %sunkaddr92.i, i64 8
  %.380.1.i514 = load double, ptr %sunkaddr97.i513, align 8, !noalias !59
  %.382.1.i515 = fmul contract double %.1277, %.380.1.i514
  %.384.1.i516 = fadd contract double %.1286, %.382.1.i515
  %sunkaddr100.i517 = getelementptr i8, ptr %sunkaddr94.i512, i64 8
  store double %.384.1.i516, ptr %sunkaddr100.i517, align 8, !noalias !59
  %sunkaddr103.i518 = getelementptr i8, ptr %sunkaddr92.i, i64 16
  %.380.2.i519 = load double, ptr %sunkaddr103.i518, align 8, !noalias !59
  %.382.2.i520 = fmul contract double %.1277, %.380.2.i519
  %.384.2.i521 = fadd contract double %.1286, %.382.2.i520
  %sunkaddr106.i = getelementptr i8, ptr %sunkaddr94.i512, i64 16
  store double %.384.2.i521, ptr %sunkaddr106.i, align 8, !noalias !59
  %.326.3.i522 = add nuw nsw i64 %.31911881190.i, 4
  %sunkaddr109.i523 = getelementptr i8, ptr %sunkaddr92.i, i64 24
  %.380.3.i524 = load double, ptr %sunkaddr109.i523, align 8, !noalias !59
  %.382.3.i525 = fmul contract double %.1277, %.380.3.i524
  %.384.3.i526 = fadd contract double %.1286, %.382.3.i525
  %sunkaddr112.i527 = getelementptr i8, ptr %sunkaddr94.i512, i64 24
  store double %.384.3.i526, ptr %sunkaddr112.i527, align 8, !noalias !59
  %niter.ncmp.3.i528 = icmp eq i64 %unroll_iter.i, %.326.3.i522
  br i1 %niter.ncmp.3.i528, label %B182.if.preheader.unr-lcssa.i, label %B112.if.i507

B182.if.preheader.unr-lcssa.i:                    ; preds = %B112.if.i507
  %lcmp.mod.not.i = icmp eq i64 %xtraiter.i, 0
  br i1 %lcmp.mod.not.i, label %B182.if.i530.preheader, label %B112.if.epil.preheader.i

B112.if.epil.preheader.i:                         ; preds = %B182.if.preheader.unr-lcssa.i, %B112.if.preheader.i
  %.31911881190.epil.init.i = phi i64 [ 0, %B112.if.preheader.i ], [ %.326.3.i522, %B182.if.preheader.unr-lcssa.i ]
  %85 = shl i64 %.31911881190.epil.init.i, 3
  %scevgep188.i = getelementptr i8, ptr %arg.room.4, i64 %85
  %scevgep190.i = getelementptr i8, ptr %.1224, i64 %85
  br label %B112.if.epil.i

B112.if.epil.i:                                   ; preds = %B112.if.epil.i, %B112.if.epil.preheader.i
  %epil.iter.i = phi i64 [ %epil.iter.next.i, %B112.if.epil.i ], [ 0, %B112.if.epil.preheader.i ]
  %86 = shl i64 %epil.iter.i, 3
  %scevgep72.i = getelementptr i8, ptr %scevgep190.i, i64 %86
  %.380.epil.i = load double, ptr %scevgep72.i, align 8, !noalias !59
  %.382.epil.i = fmul contract double %.1277, %.380.epil.i
  %.384.epil.i = fadd contract double %.1286, %.382.epil.i
  %scevgep71.i = getelementptr i8, ptr %scevgep188.i, i64 %86
  store double %.384.epil.i, ptr %scevgep71.i, align 8, !noalias !59
  %epil.iter.next.i = add i64 %epil.iter.i, 1
  %epil.iter.cmp.not.i = icmp eq i64 %xtraiter.i, %epil.iter.next.i
  br i1 %epil.iter.cmp.not.i, label %B182.if.i530.preheader, label %B112.if.epil.i, !llvm.loop !71

B182.if.i530.preheader:                           ; preds = %B112.if.epil.i, %B182.if.preheader.unr-lcssa.i
  br label %B182.if.i530

B182.if.i530:                                     ; preds = %B182.if.i530.preheader, %B182.if.i530
  %.50611941196.i = phi i64 [ %.513.i531, %B182.if.i530 ], [ 0, %B182.if.i530.preheader ]
  %.513.i531 = add nuw nsw i64 %.50611941196.i, 1
  %.567.i532 = load double, ptr %arg.prior.4, align 8, !noalias !59
  %87 = shl i64 %.50611941196.i, 3
  %scevgep186.i = getelementptr i8, ptr %.164.i253, i64 %87
  %scevgep187.i = getelementptr i8, ptr %scevgep186.i, i64 -512
  %.5981179.i = load i64, ptr %scevgep187.i, align 8, !noalias !59
  %.600.i533 = add nsw i64 %.5981179.i, -4604544271217802189
  %.601.i534 = ashr i64 %.600.i533, 52
  %.602.i535 = and i64 %.600.i533, -4503599627370496
  %.603.i536 = sub nsw i64 %.5981179.i, %.602.i535
  %.604.i537 = bitcast i64 %.603.i536 to double
  %.605.i538 = fadd contract double %.604.i537, -1.000000e+00
  %.606.i539 = fadd contract double %.605.i538, 2.000000e+00
  %.610.i540 = fdiv contract double %.605.i538, %.606.i539
  %.611.i541 = fmul contract double %.610.i540, %.610.i540
  %.612.i542 = fmul contract double %.611.i541, %.611.i541
  %.613.i543 = fmul contract double %.612.i542, 0x3FC39A09D078C69F
  %.614.i544 = fadd contract double %.613.i543, 0x3FCC71C51D8E78AF
  %.615.i545 = fmul contract double %.612.i542, %.614.i544
  %.616.i546 = fadd contract double %.615.i545, 0x3FD999999997FA04
  %.617.i547 = fmul contract double %.612.i542, %.616.i546
  %.618.i548 = fmul contract double %.612.i542, 0x3FC2F112DF3E5244
  %.619.i549 = fadd contract double %.618.i548, 0x3FC7466496CB03DE
  %.620.i550 = fmul contract double %.612.i542, %.619.i549
  %.621.i551 = fadd contract double %.620.i550, 0x3FD2492494229359
  %.622.i552 = fmul contract double %.612.i542, %.621.i551
  %.623.i553 = fadd contract double %.622.i552, 0x3FE5555555555593
  %.624.i554 = fmul contract double %.611.i541, %.623.i553
  %.625.i555 = fadd contract double %.617.i547, %.624.i554
  %.626.i556 = fmul contract double %.605.i538, 5.000000e-01
  %.627.i557 = fmul contract double %.605.i538, %.626.i556
  %.628.i558 = add nsw i64 %.601.i534, 4843621399236968448
  %.629.i559 = bitcast i64 %.628.i558 to double
  %.630.i560 = fadd contract double %.629.i559, 0xC338000000000000
  %.631.i561 = fmul contract double %.630.i560, 0x3FE62E42FEE00000
  %.632.i562 = fadd contract double %.627.i557, %.625.i555
  %.633.i563 = fmul contract double %.610.i540, %.632.i562
  %.634.i564 = fmul contract double %.630.i560, 0x3DEA39EF35793C76
  %.635.i565 = fadd contract double %.634.i564, %.633.i563
  %.636.i566 = fsub contract double %.627.i557, %.635.i565
  %.637.i567 = fsub contract double %.636.i566, %.605.i538
  %.638.i568 = fsub contract double %.631.i561, %.637.i567
  %.639.i569 = fmul contract double %.567.i532, %.638.i568
  store double %.639.i569, ptr %scevgep186.i, align 8, !noalias !59
  %exitcond1248.not.i = icmp eq i64 %.1191, %.513.i531
  br i1 %exitcond1248.not.i, label %B274.i254, label %B182.if.i530

B134.if.lr.ph.i.i:                                ; preds = %B322.i438
  %.741.i444 = getelementptr i8, ptr %arg.arguments.4, i64 72
  %.742.i445 = load i64, ptr %.741.i444, align 8, !noalias !59
  %.355.i.i446 = add nsw i64 %.704.i256, -1
  %88 = inttoptr i64 %.742.i445 to ptr
  br label %B134.if.i.i447

B134.if.i.i447:                                   ; preds = %B134.if.i.i447, %B134.if.lr.ph.i.i
  %.230207209.i.i448 = phi i64 [ 0, %B134.if.lr.ph.i.i ], [ %.237.i.i449, %B134.if.i.i447 ]
  %.237.i.i449 = add nuw nsw i64 %.230207209.i.i448, 1
  %89 = shl i64 %.230207209.i.i448, 3
  %scevgep183.i = getelementptr i8, ptr %.164.i253, i64 %89
  %scevgep184.i = getelementptr i8, ptr %scevgep183.i, i64 -512
  %.296205.i.i450 = load i64, ptr %scevgep184.i, align 8, !noalias !62
  %.298.i.i451 = add nsw i64 %.296205.i.i450, -4604544271217802189
  %.299.i.i452 = ashr i64 %.298.i.i451, 52
  %.300.i.i453 = and i64 %.298.i.i451, -4503599627370496
  %.301.i.i454 = sub nsw i64 %.296205.i.i450, %.300.i.i453
  %.302.i.i455 = bitcast i64 %.301.i.i454 to double
  %.303.i.i456 = fadd contract double %.302.i.i455, -1.000000e+00
  %.304.i.i457 = fadd contract double %.303.i.i456, 2.000000e+00
  %.308.i.i458 = fdiv contract double %.303.i.i456, %.304.i.i457
  %.309.i.i459 = fmul contract double %.308.i.i458, %.308.i.i458
  %.310.i.i460 = fmul contract double %.309.i.i459, %.309.i.i459
  %.311.i.i461 = fmul contract double %.310.i.i460, 0x3FC39A09D078C69F
  %.312.i28.i = fadd contract double %.311.i.i461, 0x3FCC71C51D8E78AF
  %.313.i.i462 = fmul contract double %.310.i.i460, %.312.i28.i
  %.314.i29.i = fadd contract double %.313.i.i462, 0x3FD999999997FA04
  %.315.i.i463 = fmul contract double %.310.i.i460, %.314.i29.i
  %.316.i.i464 = fmul contract double %.310.i.i460, 0x3FC2F112DF3E5244
  %.317.i.i465 = fadd contract double %.316.i.i464, 0x3FC7466496CB03DE
  %.318.i.i466 = fmul contract double %.310.i.i460, %.317.i.i465
  %.319.i.i467 = fadd contract double %.318.i.i466, 0x3FD2492494229359
  %.320.i.i468 = fmul contract double %.310.i.i460, %.319.i.i467
  %.321.i.i469 = fadd contract double %.320.i.i468, 0x3FE5555555555593
  %.322.i.i470 = fmul contract double %.309.i.i459, %.321.i.i469
  %.323.i.i471 = fadd contract double %.315.i.i463, %.322.i.i470
  %.324.i.i472 = fmul contract double %.303.i.i456, 5.000000e-01
  %.325.i.i473 = fmul contract double %.303.i.i456, %.324.i.i472
  %.326.i.i474 = add nsw i64 %.299.i.i452, 4843621399236968448
  %.327.i.i475 = bitcast i64 %.326.i.i474 to double
  %.328.i.i476 = fadd contract double %.327.i.i475, 0xC338000000000000
  %.329.i.i477 = fmul contract double %.328.i.i476, 0x3FE62E42FEE00000
  %.330.i.i478 = fadd contract double %.325.i.i473, %.323.i.i471
  %.331.i.i479 = fmul contract double %.308.i.i458, %.330.i.i478
  %.332.i.i480 = fmul contract double %.328.i.i476, 0x3DEA39EF35793C76
  %.333.i.i481 = fadd contract double %.332.i.i480, %.331.i.i479
  %.334.i.i482 = fsub contract double %.325.i.i473, %.333.i.i481
  %.335.i.i483 = fsub contract double %.334.i.i482, %.303.i.i456
  %.336.i.i484 = fsub contract double %.329.i.i477, %.335.i.i483
  %.337.i.i485 = fneg contract double %.336.i.i484
  %.339.i.i486 = fsub contract double %.337.i.i485, %.89.i.i440
  %.341.i.i487 = fmul contract double %.125.i.i443, %.339.i.i486
  %.348.i.i488 = fadd contract double %.341.i.i487, -5.000000e-01
  %.349.i30.i = fadd contract double %.348.i.i488, 0x4338000000000000
  %.350.i.i489 = bitcast double %.349.i30.i to i64
  %90 = tail call i64 @llvm.smax.i64(i64 %.350.i.i489, i64 4843621399236968448)
  %nearest_cell_v113__vphi100_0.2.1.i.i490 = add nsw i64 %90, -4843621399236968448
  %nearest_cell_v113__vphi120_0.2.1.i.i491 = tail call i64 @llvm.smin.i64(i64 %nearest_cell_v113__vphi100_0.2.1.i.i490, i64 %.355.i.i446)
  %.405.i.i492 = uitofp nneg i64 %nearest_cell_v113__vphi120_0.2.1.i.i491 to double
  %.406.i.i493 = fsub contract double %.341.i.i487, %.405.i.i492
  %.440.i.i494 = load double, ptr %scevgep183.i, align 8, !noalias !62
  %.idx.i.i495 = mul i64 %nearest_cell_v113__vphi120_0.2.1.i.i491, 48
  %91 = getelementptr i8, ptr %88, i64 %.idx.i.i495
  %.470.i.i496 = load double, ptr %91, align 8, !noalias !62
  %92 = getelementptr i8, ptr %91, i64 8
  %.501.i.i497 = load double, ptr %92, align 8, !noalias !62
  %93 = getelementptr i8, ptr %91, i64 16
  %.532.i.i498 = load double, ptr %93, align 8, !noalias !62
  %94 = getelementptr i8, ptr %91, i64 24
  %.563.i.i499 = load double, ptr %94, align 8, !noalias !62
  %.564.i.i500 = fmul contract double %.563.i.i499, %.406.i.i493
  %.565.i.i501 = fadd contract double %.532.i.i498, %.564.i.i500
  %.566.i.i502 = fmul contract double %.406.i.i493, %.565.i.i501
  %.567.i.i503 = fadd contract double %.501.i.i497, %.566.i.i502
  %.568.i.i504 = fmul contract double %.406.i.i493, %.567.i.i503
  %.569.i.i505 = fadd contract double %.470.i.i496, %.568.i.i504
  %.570.i.i506 = fadd contract double %.440.i.i494, %.569.i.i505
  store double %.570.i.i506, ptr %scevgep183.i, align 8, !noalias !62
  %exitcond.not.i33.i = icmp eq i64 %.1191, %.237.i.i449
  br i1 %exitcond.not.i33.i, label %B436.i258, label %B134.if.i.i447

B584.if.i420:                                     ; preds = %B584.if.i420, %B584.if.preheader.new.i
  %.103912011203.i = phi i64 [ 0, %B584.if.preheader.new.i ], [ %.1046.3.i432, %B584.if.i420 ]
  %sunkaddr114.i = shl i64 %.103912011203.i, 3
  %sunkaddr115.i421 = getelementptr i8, ptr %arg.room.4, i64 %sunkaddr114.i
  %.1100.i422 = load double, ptr %sunkaddr115.i421, align 8, !noalias !59
  %.1102.i423 = fmul contract double %arg.x, %.1100.i422
  %sunkaddr118.i424 = getelementptr i8, ptr %sunkaddr115.i421, i64 1024
  store double %.1102.i423, ptr %sunkaddr118.i424, align 8, !noalias !59
  %sunkaddr121.i425 = getelementptr i8, ptr %sunkaddr115.i421, i64 8
  %.1100.1.i426 = load double, ptr %sunkaddr121.i425, align 8, !noalias !59
  %.1102.1.i427 = fmul contract double %arg.x, %.1100.1.i426
  %sunkaddr124.i428 = getelementptr i8, ptr %sunkaddr115.i421, i64 1032
  store double %.1102.1.i427, ptr %sunkaddr124.i428, align 8, !noalias !59
  %sunkaddr127.i429 = getelementptr i8, ptr %sunkaddr115.i421, i64 16
  %.1100.2.i430 = load double, ptr %sunkaddr127.i429, align 8, !noalias !59
  %.1102.2.i431 = fmul contract double %arg.x, %.1100.2.i430
  %sunkaddr130.i = getelementptr i8, ptr %sunkaddr115.i421, i64 1040
  store double %.1102.2.i431, ptr %sunkaddr130.i, align 8, !noalias !59
  %.1046.3.i432 = add nuw nsw i64 %.103912011203.i, 4
  %sunkaddr133.i = getelementptr i8, ptr %sunkaddr115.i421, i64 24
  %.1100.3.i433 = load double, ptr %sunkaddr133.i, align 8, !noalias !59
  %.1102.3.i434 = fmul contract double %arg.x, %.1100.3.i433
  %sunkaddr136.i = getelementptr i8, ptr %sunkaddr115.i421, i64 1048
  store double %.1102.3.i434, ptr %sunkaddr136.i, align 8, !noalias !59
  %niter85.ncmp.3.i = icmp eq i64 %unroll_iter84.i, %.1046.3.i432
  br i1 %niter85.ncmp.3.i, label %B618.loopexit.unr-lcssa.i, label %B584.if.i420

B770.if.i:                                        ; preds = %B770.if.i, %B770.if.lr.ph.new.i
  %.135912081210.i = phi i64 [ 0, %B770.if.lr.ph.new.i ], [ %.1366.1.i, %B770.if.i ]
  %sunkaddr137.i263 = shl i64 %.135912081210.i, 3
  %sunkaddr139.i = getelementptr i8, ptr %arg.room.4, i64 %sunkaddr137.i263
  %sunkaddr140.i264 = getelementptr i8, ptr %sunkaddr139.i, i64 512
  %.1422.i = load double, ptr %sunkaddr140.i264, align 8, !noalias !59
  %.1452.i = load double, ptr %sunkaddr139.i, align 8, !noalias !59
  %.1485.i = fmul contract double %.1454.i, %.1452.i
  %.1487.i = fsub contract double %arg.x, %.1485.i
  %.1488.i = fmul contract double %.1452.i, %.1487.i
  %.1489.i = fadd contract double %.1422.i, %.1488.i
  store double %.1489.i, ptr %sunkaddr140.i264, align 8, !noalias !59
  %.1366.1.i = add nuw i64 %.135912081210.i, 2
  %sunkaddr145.i = getelementptr i8, ptr %sunkaddr139.i, i64 520
  %.1422.1.i = load double, ptr %sunkaddr145.i, align 8, !noalias !59
  %sunkaddr148.i = getelementptr i8, ptr %sunkaddr139.i, i64 8
  %.1452.1.i = load double, ptr %sunkaddr148.i, align 8, !noalias !59
  %.1485.1.i = fmul contract double %.1454.i, %.1452.1.i
  %.1487.1.i = fsub contract double %arg.x, %.1485.1.i
  %.1488.1.i = fmul contract double %.1452.1.i, %.1487.1.i
  %.1489.1.i = fadd contract double %.1422.1.i, %.1488.1.i
  store double %.1489.1.i, ptr %sunkaddr145.i, align 8, !noalias !59
  %niter91.ncmp.1.i = icmp eq i64 %unroll_iter90.i, %.1366.1.i
  br i1 %niter91.ncmp.1.i, label %B902.if.preheader.unr-lcssa.i, label %B770.if.i

B902.if.i266:                                     ; preds = %B902.if.i266, %B902.if.preheader.new.i
  %top.2.01219.i = phi double [ %.1560.i265, %B902.if.preheader.new.i ], [ %.1715.top.2.0.3.i284, %B902.if.i266 ]
  %.165012151217.i = phi i64 [ 0, %B902.if.preheader.new.i ], [ %.1657.3.i280, %B902.if.i266 ]
  %sunkaddr149.i267 = shl i64 %.165012151217.i, 3
  %sunkaddr151.i = getelementptr i8, ptr %arg.room.4, i64 %sunkaddr149.i267
  %sunkaddr152.i268 = getelementptr i8, ptr %sunkaddr151.i, i64 512
  %.1715.i269 = load double, ptr %sunkaddr152.i268, align 8, !noalias !59
  %.1717.i270 = fcmp contract ogt double %.1715.i269, %top.2.01219.i
  %.1715.top.2.0.i271 = select i1 %.1717.i270, double %.1715.i269, double %top.2.01219.i
  %sunkaddr155.i272 = getelementptr i8, ptr %sunkaddr151.i, i64 520
  %.1715.1.i273 = load double, ptr %sunkaddr155.i272, align 8, !noalias !59
  %.1717.1.i274 = fcmp contract ogt double %.1715.1.i273, %.1715.top.2.0.i271
  %.1715.top.2.0.1.i275 = select i1 %.1717.1.i274, double %.1715.1.i273, double %.1715.top.2.0.i271
  %sunkaddr158.i276 = getelementptr i8, ptr %sunkaddr151.i, i64 528
  %.1715.2.i277 = load double, ptr %sunkaddr158.i276, align 8, !noalias !59
  %.1717.2.i278 = fcmp contract ogt double %.1715.2.i277, %.1715.top.2.0.1.i275
  %.1715.top.2.0.2.i279 = select i1 %.1717.2.i278, double %.1715.2.i277, double %.1715.top.2.0.1.i275
  %.1657.3.i280 = add nuw i64 %.165012151217.i, 4
  %sunkaddr161.i281 = getelementptr i8, ptr %sunkaddr151.i, i64 536
  %.1715.3.i282 = load double, ptr %sunkaddr161.i281, align 8, !noalias !59
  %.1717.3.i283 = fcmp contract ogt double %.1715.3.i282, %.1715.top.2.0.2.i279
  %.1715.top.2.0.3.i284 = select i1 %.1717.3.i283, double %.1715.3.i282, double %.1715.top.2.0.2.i279
  %niter98.ncmp.3.i = icmp eq i64 %unroll_iter97.i, %.1657.3.i280
  br i1 %niter98.ncmp.3.i, label %B982.if.preheader.unr-lcssa.i, label %B902.if.i266

B982.if.preheader.unr-lcssa.i:                    ; preds = %B902.if.i266
  %lcmp.mod94.not.i = icmp eq i64 %xtraiter92.i, 0
  br i1 %lcmp.mod94.not.i, label %B982.if.preheader.i285, label %B902.if.epil.preheader.i

B902.if.epil.preheader.i:                         ; preds = %B982.if.preheader.unr-lcssa.i, %B902.if.preheader.i
  %top.2.01219.epil.init.i = phi double [ %.1560.i265, %B902.if.preheader.i ], [ %.1715.top.2.0.3.i284, %B982.if.preheader.unr-lcssa.i ]
  %.165012151217.epil.init.i = phi i64 [ 0, %B902.if.preheader.i ], [ %unroll_iter97.i, %B982.if.preheader.unr-lcssa.i ]
  %95 = shl i64 %.165012151217.epil.init.i, 3
  %96 = getelementptr i8, ptr %arg.room.4, i64 %95
  %scevgep148.i = getelementptr i8, ptr %96, i64 512
  br label %B902.if.epil.i

B902.if.epil.i:                                   ; preds = %B902.if.epil.i, %B902.if.epil.preheader.i
  %top.2.01219.epil.i = phi double [ %.1715.top.2.0.epil.i, %B902.if.epil.i ], [ %top.2.01219.epil.init.i, %B902.if.epil.preheader.i ]
  %epil.iter93.i = phi i64 [ %epil.iter93.next.i, %B902.if.epil.i ], [ 0, %B902.if.epil.preheader.i ]
  %97 = shl i64 %epil.iter93.i, 3
  %scevgep37.i = getelementptr i8, ptr %scevgep148.i, i64 %97
  %.1715.epil.i = load double, ptr %scevgep37.i, align 8, !noalias !59
  %.1717.epil.i = fcmp contract ogt double %.1715.epil.i, %top.2.01219.epil.i
  %.1715.top.2.0.epil.i = select i1 %.1717.epil.i, double %.1715.epil.i, double %top.2.01219.epil.i
  %epil.iter93.next.i = add i64 %epil.iter93.i, 1
  %epil.iter93.cmp.not.i = icmp eq i64 %xtraiter92.i, %epil.iter93.next.i
  br i1 %epil.iter93.cmp.not.i, label %B982.if.preheader.i285, label %B902.if.epil.i, !llvm.loop !72

B982.if.preheader.i285:                           ; preds = %B902.if.epil.i, %B982.if.preheader.unr-lcssa.i
  %.1715.top.2.0.lcssa.i = phi double [ %.1715.top.2.0.3.i284, %B982.if.preheader.unr-lcssa.i ], [ %.1715.top.2.0.epil.i, %B902.if.epil.i ]
  %invariant.gep.i286 = getelementptr double, ptr %.1224, i64 %.1191
  br label %B982.if.i287

B982.if.i287:                                     ; preds = %B982.if.i287, %B982.if.preheader.i285
  %.186212241226.i = phi i64 [ %.1869.i288, %B982.if.i287 ], [ 0, %B982.if.preheader.i285 ]
  %.1869.i288 = add nuw nsw i64 %.186212241226.i, 1
  %98 = shl i64 %.186212241226.i, 3
  %scevgep146.i = getelementptr i8, ptr %invariant.gep.i286, i64 %98
  %.1929.i289 = load double, ptr %scevgep146.i, align 8, !noalias !59
  %scevgep147.i = getelementptr i8, ptr %.164.i253, i64 %98
  %.1964.i290 = load double, ptr %scevgep147.i, align 8, !noalias !59
  %.1966.i291 = fsub contract double %.1964.i290, %.1715.top.2.0.lcssa.i
  %.1972.i292 = fcmp contract ogt double %.1966.i291, -7.000000e+02
  %.1966..i293 = select i1 %.1972.i292, double %.1966.i291, double -7.000000e+02
  %.1989.i294 = tail call contract double @llvm.fma.f64(double %.1966..i293, double 0x3FF71547652B82FE, double 0x4338000000000000)
  %.1990.i295 = fadd contract double %.1989.i294, 0xC338000000000000
  %.1993.i296 = tail call contract double @llvm.fma.f64(double %.1990.i295, double 0xBFE62E42FEFA39EF, double %.1966..i293)
  %.1994.i297 = tail call contract double @llvm.fma.f64(double %.1990.i295, double 0xBC7ABC9E3B39803F, double %.1993.i296)
  %.1995.i298 = tail call contract double @llvm.fma.f64(double %.1994.i297, double 0x3DE6124613A86D09, double 0x3E21EED8EFF8D898)
  %.1996.i299 = tail call contract double @llvm.fma.f64(double %.1994.i297, double %.1995.i298, double 0x3E5AE64567F544E4)
  %.1997.i300 = tail call contract double @llvm.fma.f64(double %.1994.i297, double %.1996.i299, double 0x3E927E4FB7789F5C)
  %.1998.i301 = tail call contract double @llvm.fma.f64(double %.1994.i297, double %.1997.i300, double 0x3EC71DE3A556C734)
  %.1999.i302 = tail call contract double @llvm.fma.f64(double %.1994.i297, double %.1998.i301, double 0x3EFA01A01A01A01A)
  %.2000.i303 = tail call contract double @llvm.fma.f64(double %.1994.i297, double %.1999.i302, double 0x3F2A01A01A01A01A)
  %.2001.i304 = tail call contract double @llvm.fma.f64(double %.1994.i297, double %.2000.i303, double 0x3F56C16C16C16C17)
  %.2002.i305 = tail call contract double @llvm.fma.f64(double %.1994.i297, double %.2001.i304, double 0x3F81111111111111)
  %.2003.i306 = tail call contract double @llvm.fma.f64(double %.1994.i297, double %.2002.i305, double 0x3FA5555555555555)
  %.2004.i307 = tail call contract double @llvm.fma.f64(double %.1994.i297, double %.2003.i306, double 0x3FC5555555555555)
  %.2005.i308 = tail call contract double @llvm.fma.f64(double %.1994.i297, double %.2004.i307, double 5.000000e-01)
  %.2006.i309 = fmul contract double %.1994.i297, %.1994.i297
  %.2007.i310 = fadd contract double %.1994.i297, 1.000000e+00
  %.2008.i311 = tail call contract double @llvm.fma.f64(double %.2006.i309, double %.2005.i308, double %.2007.i310)
  %.2009.i312 = bitcast double %.1989.i294 to i64
  %.2010.i313 = shl i64 %.2009.i312, 52
  %.2011.i314 = add i64 %.2010.i313, 4607182418800017408
  %.2012.i315 = bitcast i64 %.2011.i314 to double
  %.2013.i316 = fmul contract double %.2008.i311, %.2012.i315
  %.2015.i317 = fmul contract double %.1929.i289, %.2013.i316
  store double %.2015.i317, ptr %scevgep147.i, align 8, !noalias !59
  %exitcond1252.not.i = icmp eq i64 %.1191, %.1869.i288
  br i1 %exitcond1252.not.i, label %B1198.i318, label %B982.if.i287

B1198.endif.i357:                                 ; preds = %B348.loopexit.i.i, %B1198.i318
  %s0.2.0.lcssa.i.i = phi double [ 0.000000e+00, %B1198.i318 ], [ %76, %B348.loopexit.i.i ]
  %.2090.i358 = fmul contract double %.1277, %s0.2.0.lcssa.i.i
  %.2122.i359 = getelementptr i8, ptr %arg.arguments.4, i64 184
  %.2123.i360 = load i64, ptr %.2122.i359, align 8, !noalias !59
  %.2124.i361 = icmp eq i64 %.2123.i360, 0
  br i1 %.2124.i361, label %_ZN17bnserve_inference15marginal_kernel9_distance8_by_ruleB4v124B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEdddd28Literal_5bbool_5d_28False_295ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit, label %B1262.i

B1266.if.i362:                                    ; preds = %B1266.if.i362, %B1266.if.preheader.new.i
  %squares.2.01235.i = phi double [ 0.000000e+00, %B1266.if.preheader.new.i ], [ %.2394.3.i390, %B1266.if.i362 ]
  %.226912311233.i = phi i64 [ 0, %B1266.if.preheader.new.i ], [ %.2276.3.i383, %B1266.if.i362 ]
  %sunkaddr162.i = shl i64 %.226912311233.i, 3
  %sunkaddr164.i363 = getelementptr i8, ptr %arg.room.4, i64 %sunkaddr162.i
  %sunkaddr165.i364 = getelementptr i8, ptr %sunkaddr164.i363, i64 512
  %.2330.i365 = load double, ptr %sunkaddr165.i364, align 8, !noalias !59
  %.2360.i366 = load double, ptr %sunkaddr164.i363, align 8, !noalias !59
  %.2361.i367 = fmul contract double %.2330.i365, %.2360.i366
  %.2392.i368 = fmul contract double %.2360.i366, %.2361.i367
  %.2394.i369 = fadd contract double %squares.2.01235.i, %.2392.i368
  %sunkaddr170.i = getelementptr i8, ptr %sunkaddr164.i363, i64 520
  %.2330.1.i370 = load double, ptr %sunkaddr170.i, align 8, !noalias !59
  %sunkaddr173.i371 = getelementptr i8, ptr %sunkaddr164.i363, i64 8
  %.2360.1.i372 = load double, ptr %sunkaddr173.i371, align 8, !noalias !59
  %.2361.1.i373 = fmul contract double %.2330.1.i370, %.2360.1.i372
  %.2392.1.i374 = fmul contract double %.2360.1.i372, %.2361.1.i373
  %.2394.1.i375 = fadd contract double %.2394.i369, %.2392.1.i374
  %sunkaddr176.i376 = getelementptr i8, ptr %sunkaddr164.i363, i64 528
  %.2330.2.i377 = load double, ptr %sunkaddr176.i376, align 8, !noalias !59
  %sunkaddr179.i378 = getelementptr i8, ptr %sunkaddr164.i363, i64 16
  %.2360.2.i379 = load double, ptr %sunkaddr179.i378, align 8, !noalias !59
  %.2361.2.i380 = fmul contract double %.2330.2.i377, %.2360.2.i379
  %.2392.2.i381 = fmul contract double %.2360.2.i379, %.2361.2.i380
  %.2394.2.i382 = fadd contract double %.2394.1.i375, %.2392.2.i381
  %.2276.3.i383 = add nuw nsw i64 %.226912311233.i, 4
  %sunkaddr182.i384 = getelementptr i8, ptr %sunkaddr164.i363, i64 536
  %.2330.3.i385 = load double, ptr %sunkaddr182.i384, align 8, !noalias !59
  %sunkaddr185.i386 = getelementptr i8, ptr %sunkaddr164.i363, i64 24
  %.2360.3.i387 = load double, ptr %sunkaddr185.i386, align 8, !noalias !59
  %.2361.3.i388 = fmul contract double %.2330.3.i385, %.2360.3.i387
  %.2392.3.i389 = fmul contract double %.2360.3.i387, %.2361.3.i388
  %.2394.3.i390 = fadd contract double %.2394.2.i382, %.2392.3.i389
  %niter105.ncmp.3.i = icmp eq i64 %unroll_iter104.i, %.2276.3.i383
  br i1 %niter105.ncmp.3.i, label %B1334.loopexit.unr-lcssa.i, label %B1266.if.i362

B3917.if.i:                                       ; preds = %B3917.if.i, %B3917.if.preheader.new.i
  %firsts.2.01244.i = phi double [ 0.000000e+00, %B3917.if.preheader.new.i ], [ %.2646.3.i410, %B3917.if.i ]
  %.255212401242.i = phi i64 [ 0, %B3917.if.preheader.new.i ], [ %.2559.3.i406, %B3917.if.i ]
  %sunkaddr186.i = shl i64 %.255212401242.i, 3
  %sunkaddr188.i393 = getelementptr i8, ptr %arg.room.4, i64 %sunkaddr186.i
  %sunkaddr189.i = getelementptr i8, ptr %sunkaddr188.i393, i64 512
  %.2613.i394 = load double, ptr %sunkaddr189.i, align 8, !noalias !59
  %.2643.i395 = load double, ptr %sunkaddr188.i393, align 8, !noalias !59
  %.2644.i396 = fmul contract double %.2613.i394, %.2643.i395
  %.2646.i397 = fadd contract double %firsts.2.01244.i, %.2644.i396
  %sunkaddr194.i = getelementptr i8, ptr %sunkaddr188.i393, i64 520
  %.2613.1.i398 = load double, ptr %sunkaddr194.i, align 8, !noalias !59
  %sunkaddr197.i = getelementptr i8, ptr %sunkaddr188.i393, i64 8
  %.2643.1.i399 = load double, ptr %sunkaddr197.i, align 8, !noalias !59
  %.2644.1.i400 = fmul contract double %.2613.1.i398, %.2643.1.i399
  %.2646.1.i401 = fadd contract double %.2646.i397, %.2644.1.i400
  %sunkaddr200.i = getelementptr i8, ptr %sunkaddr188.i393, i64 528
  %.2613.2.i402 = load double, ptr %sunkaddr200.i, align 8, !noalias !59
  %sunkaddr203.i = getelementptr i8, ptr %sunkaddr188.i393, i64 16
  %.2643.2.i403 = load double, ptr %sunkaddr203.i, align 8, !noalias !59
  %.2644.2.i404 = fmul contract double %.2613.2.i402, %.2643.2.i403
  %.2646.2.i405 = fadd contract double %.2646.1.i401, %.2644.2.i404
  %.2559.3.i406 = add nuw nsw i64 %.255212401242.i, 4
  %sunkaddr206.i = getelementptr i8, ptr %sunkaddr188.i393, i64 536
  %.2613.3.i407 = load double, ptr %sunkaddr206.i, align 8, !noalias !59
  %sunkaddr209.i = getelementptr i8, ptr %sunkaddr188.i393, i64 24
  %.2643.3.i408 = load double, ptr %sunkaddr209.i, align 8, !noalias !59
  %.2644.3.i409 = fmul contract double %.2613.3.i407, %.2643.3.i408
  %.2646.3.i410 = fadd contract double %.2646.2.i405, %.2644.3.i409
  %niter112.ncmp.3.i = icmp eq i64 %unroll_iter111.i, %.2559.3.i406
  br i1 %niter112.ncmp.3.i, label %B3933.loopexit.unr-lcssa.i, label %B3917.if.i

_ZN17bnserve_inference15marginal_kernel9_distance8_by_ruleB4v124B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEdddd28Literal_5bbool_5d_28False_295ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit: ; preds = %B1198.endif.i357, %B3933.i
  %.1294.sroa.8.0 = phi double [ %.2673.i414, %B3933.i ], [ 0.000000e+00, %B1198.endif.i357 ]
  %.1294.sroa.11.0 = phi double [ %.2678.i415, %B3933.i ], [ 0.000000e+00, %B1198.endif.i357 ]
  %.1294.sroa.0.0 = fadd contract double %top.2.0.lcssa6.i, 0.000000e+00
  call void @llvm.lifetime.end.p0(ptr nonnull %.1211.i249)
  call void @llvm.lifetime.end.p0(ptr nonnull %.2410.i251)
  br label %common.ret

B1524:                                            ; preds = %B1396
  %.1388 = getelementptr i8, ptr %arg.arguments.4, i64 112
  %.1389 = load i64, ptr %.1388, align 8
  %.1451 = fdiv contract double %.13.i22, %.13.i20
  %.1452 = bitcast double %.1451 to i64
  %.1453 = add nsw i64 %.1452, -4604544271217802189
  %.1454 = ashr i64 %.1453, 52
  %.1455 = and i64 %.1453, -4503599627370496
  %.1456 = sub nsw i64 %.1452, %.1455
  %.1457 = bitcast i64 %.1456 to double
  %.1458 = fadd contract double %.1457, -1.000000e+00
  %.1459 = fadd contract double %.1458, 2.000000e+00
  %.1463 = fdiv contract double %.1458, %.1459
  %.1464 = fmul contract double %.1463, %.1463
  %.1465 = fmul contract double %.1464, %.1464
  %.1466 = fmul contract double %.1465, 0x3FC39A09D078C69F
  %.1467 = fadd contract double %.1466, 0x3FCC71C51D8E78AF
  %.1468 = fmul contract double %.1465, %.1467
  %.1469 = fadd contract double %.1468, 0x3FD999999997FA04
  %.1470 = fmul contract double %.1465, %.1469
  %.1471 = fmul contract double %.1465, 0x3FC2F112DF3E5244
  %.1472 = fadd contract double %.1471, 0x3FC7466496CB03DE
  %.1473 = fmul contract double %.1465, %.1472
  %.1474 = fadd contract double %.1473, 0x3FD2492494229359
  %.1475 = fmul contract double %.1465, %.1474
  %.1476 = fadd contract double %.1475, 0x3FE5555555555593
  %.1477 = fmul contract double %.1464, %.1476
  %.1478 = fadd contract double %.1470, %.1477
  %.1479 = fmul contract double %.1458, 5.000000e-01
  %.1480 = fmul contract double %.1458, %.1479
  %.1481 = add nsw i64 %.1454, 4843621399236968448
  %.1482 = bitcast i64 %.1481 to double
  %.1483 = fadd contract double %.1482, 0xC338000000000000
  %.1484 = fmul contract double %.1483, 0x3FE62E42FEE00000
  %.1485 = fadd contract double %.1480, %.1478
  %.1486 = fmul contract double %.1463, %.1485
  %.1487 = fmul contract double %.1483, 0x3DEA39EF35793C76
  %.1488 = fadd contract double %.1487, %.1486
  %.1489 = fsub contract double %.1480, %.1488
  %.1490 = fsub contract double %.1489, %.1458
  %.1491 = fsub contract double %.1484, %.1490
  %.1504 = fcmp contract ogt double %.1491, 0x400BB9D3BEB8C86B
  br i1 %.1504, label %B1548, label %B1560

B1548:                                            ; preds = %B1524, %B1548
  %pieces.2.0 = phi i64 [ %.1507, %B1548 ], [ 1, %B1524 ]
  %.1507 = add i64 %pieces.2.0, 1
  %.1512 = uitofp nneg i64 %.1507 to double
  %.1513 = fmul contract double %.1512, 0x400BB9D3BEB8C86B
  %.1515 = fcmp contract olt double %.1513, %.1491
  br i1 %.1515, label %B1548, label %B1560

B1560:                                            ; preds = %B1548, %B1524
  %pieces.3.1 = phi i64 [ 1, %B1524 ], [ %.1507, %B1548 ]
  %.1522 = sitofp i64 %pieces.3.1 to double
  %.1526 = fdiv contract double %.1491, %.1522
  %.1529 = tail call contract double @llvm.fma.f64(double %.1526, double 0x3FF71547652B82FE, double 0x4338000000000000)
  %.1530 = fadd contract double %.1529, 0xC338000000000000
  %.1533 = tail call contract double @llvm.fma.f64(double %.1530, double 0xBFE62E42FEFA39EF, double %.1526)
  %.1534 = tail call contract double @llvm.fma.f64(double %.1530, double 0xBC7ABC9E3B39803F, double %.1533)
  %.1535 = tail call contract double @llvm.fma.f64(double %.1534, double 0x3DE6124613A86D09, double 0x3E21EED8EFF8D898)
  %.1536 = tail call contract double @llvm.fma.f64(double %.1534, double %.1535, double 0x3E5AE64567F544E4)
  %.1537 = tail call contract double @llvm.fma.f64(double %.1534, double %.1536, double 0x3E927E4FB7789F5C)
  %.1538 = tail call contract double @llvm.fma.f64(double %.1534, double %.1537, double 0x3EC71DE3A556C734)
  %.1539 = tail call contract double @llvm.fma.f64(double %.1534, double %.1538, double 0x3EFA01A01A01A01A)
  %.1540 = tail call contract double @llvm.fma.f64(double %.1534, double %.1539, double 0x3F2A01A01A01A01A)
  %.1541 = tail call contract double @llvm.fma.f64(double %.1534, double %.1540, double 0x3F56C16C16C16C17)
  %.1542 = tail call contract double @llvm.fma.f64(double %.1534, double %.1541, double 0x3F81111111111111)
  %.1543 = tail call contract double @llvm.fma.f64(double %.1534, double %.1542, double 0x3FA5555555555555)
  %.1544 = tail call contract double @llvm.fma.f64(double %.1534, double %.1543, double 0x3FC5555555555555)
  %.1545 = tail call contract double @llvm.fma.f64(double %.1534, double %.1544, double 5.000000e-01)
  %.1546 = fmul contract double %.1534, %.1534
  %.1547 = fadd contract double %.1534, 1.000000e+00
  %.1548 = tail call contract double @llvm.fma.f64(double %.1546, double %.1545, double %.1547)
  %.1549 = bitcast double %.1529 to i64
  %.1550 = shl i64 %.1549, 52
  %.1551 = add i64 %.1550, 4607182418800017408
  %.1552 = bitcast i64 %.1551 to double
  %.1553 = fmul contract double %.1548, %.1552
  %99 = add i64 %pieces.3.1, -1
  %100 = inttoptr i64 %.1389 to ptr
  %.164.i631 = getelementptr i8, ptr %arg.room.4, i64 512
  %.703.i632 = getelementptr i8, ptr %arg.arguments.4, i64 64
  %.894.i638 = getelementptr inbounds nuw i8, ptr %arg.room.4, i64 1024
  %.741.i814 = getelementptr i8, ptr %arg.arguments.4, i64 72
  %.88.i.i816 = getelementptr i8, ptr %arg.prior.4, i64 56
  %.117.i.i818 = getelementptr i8, ptr %arg.prior.4, i64 64
  %.1157.i811 = getelementptr inbounds nuw i8, ptr %arg.room.4, i64 1536
  %.1454.i640 = fmul contract double %arg.n, 5.000000e-01
  %scevgep.i.i701 = getelementptr i8, ptr %arg.room.4, i64 568
  %scevgep3.i.i704 = getelementptr i8, ptr %arg.room.4, i64 520
  %scevgep4.i.i707 = getelementptr i8, ptr %arg.room.4, i64 528
  %scevgep5.i.i710 = getelementptr i8, ptr %arg.room.4, i64 536
  %scevgep6.i.i713 = getelementptr i8, ptr %arg.room.4, i64 544
  %scevgep7.i.i716 = getelementptr i8, ptr %arg.room.4, i64 552
  %scevgep8.i.i719 = getelementptr i8, ptr %arg.room.4, i64 560
  %scevgep1.i.i724 = getelementptr i8, ptr %arg.room.4, i64 632
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
  %.2122.i726 = getelementptr i8, ptr %arg.arguments.4, i64 184
  br label %B1564.if

B3111:                                            ; preds = %_ZN17bnserve_inference15marginal_kernel9_distance8_by_ruleB4v133B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEdddd28Literal_5bbool_5d_28False_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2864_295ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit
  br i1 %.1798, label %B3371, label %B3159

B3159:                                            ; preds = %B3111
  %.1844 = fsub contract double %top.2.0856, %.1757.sroa.0.1
  %.1852 = fcmp contract ogt double %.1844, -7.000000e+02
  %.1844. = select i1 %.1852, double %.1844, double -7.000000e+02
  %.1869 = tail call contract double @llvm.fma.f64(double %.1844., double 0x3FF71547652B82FE, double 0x4338000000000000)
  %.1870 = fadd contract double %.1869, 0xC338000000000000
  %.1873 = tail call contract double @llvm.fma.f64(double %.1870, double 0xBFE62E42FEFA39EF, double %.1844.)
  %.1874 = tail call contract double @llvm.fma.f64(double %.1870, double 0xBC7ABC9E3B39803F, double %.1873)
  %.1875 = tail call contract double @llvm.fma.f64(double %.1874, double 0x3DE6124613A86D09, double 0x3E21EED8EFF8D898)
  %.1876 = tail call contract double @llvm.fma.f64(double %.1874, double %.1875, double 0x3E5AE64567F544E4)
  %.1877 = tail call contract double @llvm.fma.f64(double %.1874, double %.1876, double 0x3E927E4FB7789F5C)
  %.1878 = tail call contract double @llvm.fma.f64(double %.1874, double %.1877, double 0x3EC71DE3A556C734)
  %.1879 = tail call contract double @llvm.fma.f64(double %.1874, double %.1878, double 0x3EFA01A01A01A01A)
  %.1880 = tail call contract double @llvm.fma.f64(double %.1874, double %.1879, double 0x3F2A01A01A01A01A)
  %.1881 = tail call contract double @llvm.fma.f64(double %.1874, double %.1880, double 0x3F56C16C16C16C17)
  %.1882 = tail call contract double @llvm.fma.f64(double %.1874, double %.1881, double 0x3F81111111111111)
  %.1883 = tail call contract double @llvm.fma.f64(double %.1874, double %.1882, double 0x3FA5555555555555)
  %.1884 = tail call contract double @llvm.fma.f64(double %.1874, double %.1883, double 0x3FC5555555555555)
  %.1885 = tail call contract double @llvm.fma.f64(double %.1874, double %.1884, double 5.000000e-01)
  %.1886 = fmul contract double %.1874, %.1874
  %.1887 = fadd contract double %.1874, 1.000000e+00
  %.1888 = tail call contract double @llvm.fma.f64(double %.1886, double %.1885, double %.1887)
  %.1889 = bitcast double %.1869 to i64
  %.1890 = shl i64 %.1889, 52
  %.1891 = add i64 %.1890, 4607182418800017408
  %.1892 = bitcast i64 %.1891 to double
  %.1893 = fmul contract double %.1888, %.1892
  br label %B3371

B3371:                                            ; preds = %B3159, %B3111
  %"$phi1610.1.2.2" = phi double [ %.1893, %B3159 ], [ 0.000000e+00, %B3111 ]
  %.1903 = fmul contract double %factor.3.0857, %"$phi1610.1.2.2"
  %.1907 = fmul contract double %firsts.3.0858, %"$phi1610.1.2.2"
  %.1911 = fmul contract double %squares.3.0859, %"$phi1610.1.2.2"
  br label %B3387

B3387:                                            ; preds = %_ZN17bnserve_inference15marginal_kernel9_distance8_by_ruleB4v133B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEdddd28Literal_5bbool_5d_28False_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2864_295ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit, %B3371
  %top.3.2 = phi double [ %.1757.sroa.0.1, %B3371 ], [ %top.2.0856, %_ZN17bnserve_inference15marginal_kernel9_distance8_by_ruleB4v133B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEdddd28Literal_5bbool_5d_28False_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2864_295ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit ]
  %factor.4.2 = phi double [ %.1903, %B3371 ], [ %factor.3.0857, %_ZN17bnserve_inference15marginal_kernel9_distance8_by_ruleB4v133B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEdddd28Literal_5bbool_5d_28False_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2864_295ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit ]
  %firsts.4.2 = phi double [ %.1907, %B3371 ], [ %firsts.3.0858, %_ZN17bnserve_inference15marginal_kernel9_distance8_by_ruleB4v133B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEdddd28Literal_5bbool_5d_28False_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2864_295ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit ]
  %squares.4.2 = phi double [ %.1911, %B3371 ], [ %squares.3.0859, %_ZN17bnserve_inference15marginal_kernel9_distance8_by_ruleB4v133B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEdddd28Literal_5bbool_5d_28False_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2864_295ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit ]
  %.1961 = fsub contract double %.1757.sroa.0.1, %top.3.2
  %.1967 = fcmp contract ogt double %.1961, -7.000000e+02
  %.1961. = select i1 %.1967, double %.1961, double -7.000000e+02
  %.1989 = tail call contract double @llvm.fma.f64(double %.1961., double 0x3FF71547652B82FE, double 0x4338000000000000)
  %.1990 = fadd contract double %.1989, 0xC338000000000000
  %.1993 = tail call contract double @llvm.fma.f64(double %.1990, double 0xBFE62E42FEFA39EF, double %.1961.)
  %.1994 = tail call contract double @llvm.fma.f64(double %.1990, double 0xBC7ABC9E3B39803F, double %.1993)
  %.1995 = tail call contract double @llvm.fma.f64(double %.1994, double 0x3DE6124613A86D09, double 0x3E21EED8EFF8D898)
  %.1996 = tail call contract double @llvm.fma.f64(double %.1994, double %.1995, double 0x3E5AE64567F544E4)
  %.1997 = tail call contract double @llvm.fma.f64(double %.1994, double %.1996, double 0x3E927E4FB7789F5C)
  %.1998 = tail call contract double @llvm.fma.f64(double %.1994, double %.1997, double 0x3EC71DE3A556C734)
  %.1999 = tail call contract double @llvm.fma.f64(double %.1994, double %.1998, double 0x3EFA01A01A01A01A)
  %.2000 = tail call contract double @llvm.fma.f64(double %.1994, double %.1999, double 0x3F2A01A01A01A01A)
  %.2001 = tail call contract double @llvm.fma.f64(double %.1994, double %.2000, double 0x3F56C16C16C16C17)
  %.2002 = tail call contract double @llvm.fma.f64(double %.1994, double %.2001, double 0x3F81111111111111)
  %.2003 = tail call contract double @llvm.fma.f64(double %.1994, double %.2002, double 0x3FA5555555555555)
  %.2004 = tail call contract double @llvm.fma.f64(double %.1994, double %.2003, double 0x3FC5555555555555)
  %.2005 = tail call contract double @llvm.fma.f64(double %.1994, double %.2004, double 5.000000e-01)
  %.2006 = fmul contract double %.1994, %.1994
  %.2007 = fadd contract double %.1994, 1.000000e+00
  %.2008 = tail call contract double @llvm.fma.f64(double %.2006, double %.2005, double %.2007)
  %.2009 = bitcast double %.1989 to i64
  %.2010 = shl i64 %.2009, 52
  %.2011 = add i64 %.2010, 4607182418800017408
  %.2012 = bitcast i64 %.2011 to double
  %.2013 = fmul contract double %.2008, %.2012
  %.2016 = fmul contract double %.2090.i725, %.2013
  %.2018 = fadd contract double %factor.4.2, %.2016
  %.2025 = fmul contract double %.1757.sroa.8.1, %.2013
  %.2027 = fadd contract double %firsts.4.2, %.2025
  %.2040 = fmul contract double %.1757.sroa.11.1, %.2013
  %.2042 = fadd contract double %squares.4.2, %.2040
  %exitcond.not = icmp eq i64 %pieces.3.1, %.1692
  br i1 %exitcond.not, label %common.ret, label %B1564.if

B96.endif:                                        ; preds = %B72
  %.136 = fdiv contract double %arg.x, %arg.n
  %.138 = tail call contract double @llvm.sqrt.f64(double %arg.n)
  %.142 = fdiv contract double 1.000000e+00, %.138
  %.178 = getelementptr i8, ptr %arg.prior.4, i64 40
  %.179 = load double, ptr %.178, align 8
  %.229 = getelementptr i8, ptr %arg.prior.4, i64 24
  %.230 = load double, ptr %.229, align 8
  %.231 = fmul contract double %.230, 2.000000e+00
  %.232 = tail call contract double @llvm.sqrt.f64(double %.231)
  %.234 = fmul contract double %.142, %.232
  %.240 = fsub contract double %.136, %.234
  %.269 = getelementptr i8, ptr %arg.prior.4, i64 8
  %.270 = load double, ptr %.269, align 8
  %.271 = fcmp contract ogt double %.240, %.270
  br i1 %.271, label %B210, label %B348

B1564.if:                                         ; preds = %B3387, %B1560
  %squares.3.0859 = phi double [ 0.000000e+00, %B1560 ], [ %.2042, %B3387 ]
  %firsts.3.0858 = phi double [ 0.000000e+00, %B1560 ], [ %.2027, %B3387 ]
  %factor.3.0857 = phi double [ 0.000000e+00, %B1560 ], [ %.2018, %B3387 ]
  %top.2.0856 = phi double [ 0.000000e+00, %B1560 ], [ %top.3.2, %B3387 ]
  %low.2.0855 = phi double [ %.13.i20, %B1560 ], [ %"$phi1430.1.2.1", %B3387 ]
  %.1685851853 = phi i64 [ 0, %B1560 ], [ %.1692, %B3387 ]
  %.1723 = icmp eq i64 %99, %.1685851853
  %.1732 = fmul contract double %.1553, %low.2.0855
  %"$phi1430.1.2.1" = select i1 %.1723, double %.13.i22, double %.1732
  %.1744 = fsub contract double %"$phi1430.1.2.1", %low.2.0855
  %.1745 = fmul contract double %.1744, 5.000000e-01
  %.1748 = fadd contract double %low.2.0855, %.1745
  call void @llvm.lifetime.start.p0(ptr nonnull %.1211.i570)
  call void @llvm.lifetime.start.p0(ptr nonnull %.2410.i572)
  store ptr null, ptr %.1211.i570, align 8, !noalias !73
  store ptr null, ptr %.2410.i572, align 8, !noalias !73
  br label %B112.if.i574

B274.i630:                                        ; preds = %B182.if.i587
  %.1692 = add i64 %.1685851853, 1
  %.704.i633 = load i64, ptr %.703.i632, align 8, !noalias !73
  %.709.i634 = icmp sgt i64 %.704.i633, 0
  br i1 %.709.i634, label %B322.i813, label %B436.i635

B322.i813:                                        ; preds = %B274.i630
  %.742.i815 = load i64, ptr %.741.i814, align 8, !noalias !73
  %.89.i.i817 = load double, ptr %.88.i.i816, align 8, !noalias !76
  %.118.i.i819 = load double, ptr %.117.i.i818, align 8, !noalias !76
  %.125.i.i820 = fdiv contract double 1.000000e+00, %.118.i.i819
  %.355.i.i821 = add nsw i64 %.704.i633, -1
  %101 = inttoptr i64 %.742.i815 to ptr
  br label %B134.if.i.i822

B436.i635:                                        ; preds = %B134.if.i.i822, %B274.i630
  %.876.i636 = load i64, ptr %arg.arguments.4, align 8, !noalias !73
  %.877.i637 = icmp eq i64 %.876.i636, 1
  br i1 %.877.i637, label %B584.if.i792, label %B770.if.i641.preheader

B770.if.i641.preheader:                           ; preds = %B618.i810, %B436.i635
  br label %B770.if.i641

B618.i810:                                        ; preds = %B584.if.i792
  store ptr null, ptr %.1211.i570, align 8, !noalias !73
  call fastcc void @inner_3(ptr nonnull %.1211.i570, ptr nonnull %.894.i638, i64 64, ptr nonnull readonly %arg.arguments.4, ptr nonnull %.1157.i811, ptr nonnull %.164.i631, i64 64)
  br label %B770.if.i641.preheader

B902.if.preheader.i654:                           ; preds = %B770.if.i641
  %.1560.i655 = load double, ptr %.164.i631, align 8, !noalias !73
  br label %B902.if.i656

B1198.i700:                                       ; preds = %B982.if.i669
  %.242.i.i702 = load double, ptr %.164.i631, align 8, !noalias !79
  %.244.i.i703 = fadd contract double %.242.i.i702, 0.000000e+00
  %.277.i.i705 = load double, ptr %scevgep3.i.i704, align 8, !noalias !79
  %.279.i.i706 = fadd contract double %.277.i.i705, 0.000000e+00
  %.312.i.i708 = load double, ptr %scevgep4.i.i707, align 8, !noalias !79
  %.314.i.i709 = fadd contract double %.312.i.i708, 0.000000e+00
  %.347.i.i711 = load double, ptr %scevgep5.i.i710, align 8, !noalias !79
  %.349.i.i712 = fadd contract double %.347.i.i711, 0.000000e+00
  %.382.i.i714 = load double, ptr %scevgep6.i.i713, align 8, !noalias !79
  %.384.i.i715 = fadd contract double %.382.i.i714, 0.000000e+00
  %.417.i.i717 = load double, ptr %scevgep7.i.i716, align 8, !noalias !79
  %.419.i.i718 = fadd contract double %.417.i.i717, 0.000000e+00
  %.452.i.i720 = load double, ptr %scevgep8.i.i719, align 8, !noalias !79
  %.454.i.i721 = fadd contract double %.452.i.i720, 0.000000e+00
  %.487.i.i722 = load double, ptr %scevgep.i.i701, align 8, !noalias !79
  %.489.i.i723 = fadd contract double %.487.i.i722, 0.000000e+00
  %.242.i.1.i = load double, ptr %scevgep2.i.1.i, align 8, !noalias !79
  %.244.i.1.i = fadd contract double %.244.i.i703, %.242.i.1.i
  %.277.i.1.i = load double, ptr %scevgep3.i.1.i, align 8, !noalias !79
  %.279.i.1.i = fadd contract double %.279.i.i706, %.277.i.1.i
  %.312.i.1.i = load double, ptr %scevgep4.i.1.i, align 8, !noalias !79
  %.314.i.1.i = fadd contract double %.314.i.i709, %.312.i.1.i
  %.347.i.1.i = load double, ptr %scevgep5.i.1.i, align 8, !noalias !79
  %.349.i.1.i = fadd contract double %.349.i.i712, %.347.i.1.i
  %.382.i.1.i = load double, ptr %scevgep6.i.1.i, align 8, !noalias !79
  %.384.i.1.i = fadd contract double %.384.i.i715, %.382.i.1.i
  %.417.i.1.i = load double, ptr %scevgep7.i.1.i, align 8, !noalias !79
  %.419.i.1.i = fadd contract double %.419.i.i718, %.417.i.1.i
  %.452.i.1.i = load double, ptr %scevgep8.i.1.i, align 8, !noalias !79
  %.454.i.1.i = fadd contract double %.454.i.i721, %.452.i.1.i
  %.487.i.1.i = load double, ptr %scevgep1.i.i724, align 8, !noalias !79
  %.489.i.1.i = fadd contract double %.489.i.i723, %.487.i.1.i
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
  %102 = fadd contract double %.244.i.7.i, %.279.i.7.i
  %103 = fadd contract double %.314.i.7.i, %.349.i.7.i
  %104 = fadd contract double %102, %103
  %105 = fadd contract double %.384.i.7.i, %.419.i.7.i
  %106 = fadd contract double %.454.i.7.i, %.489.i.7.i
  %107 = fadd contract double %105, %106
  %108 = fadd contract double %104, %107
  %.2090.i725 = fmul contract double %.1745, %108
  %.2123.i727 = load i64, ptr %.2122.i726, align 8, !noalias !73
  %.2124.i728 = icmp eq i64 %.2123.i727, 0
  br i1 %.2124.i728, label %_ZN17bnserve_inference15marginal_kernel9_distance8_by_ruleB4v133B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEdddd28Literal_5bbool_5d_28False_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2864_295ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit, label %B1266.if.i729

B1334.i751:                                       ; preds = %B1266.if.i729
  br i1 %.877.i637, label %B1336.i786, label %B3995.if.i.preheader

B3995.if.i.preheader:                             ; preds = %B1336.i786, %B1334.i751
  br label %B3995.if.i

B1336.i786:                                       ; preds = %B1334.i751
  store ptr null, ptr %.2410.i572, align 8, !noalias !73
  call fastcc void @inner_4(ptr nonnull %.2410.i572, ptr nonnull %.894.i638, i64 64, ptr %arg.room.4, ptr nonnull readonly %arg.arguments.4)
  br label %B3995.if.i.preheader

B4011.i:                                          ; preds = %B3995.if.i
  %.2673.i781 = fmul contract double %.1745, %.2646.3.i778
  %.2678.i782 = fmul contract double %.1745, %.2394.3.i750
  br label %_ZN17bnserve_inference15marginal_kernel9_distance8_by_ruleB4v133B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEdddd28Literal_5bbool_5d_28False_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2864_295ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit

B112.if.i574:                                     ; preds = %B112.if.i574, %B1564.if
  %lsr.iv149.i = phi i64 [ %lsr.iv.next150.i, %B112.if.i574 ], [ 3, %B1564.if ]
  %109 = shl nuw nsw i64 %lsr.iv149.i, 3
  %scevgep87.i = getelementptr i8, ptr %100, i64 %109
  %scevgep86.i = getelementptr i8, ptr %scevgep87.i, i64 -24
  %.380.i575 = load double, ptr %scevgep86.i, align 8, !noalias !73
  %.382.i576 = fmul contract double %.1745, %.380.i575
  %.384.i577 = fadd contract double %.1748, %.382.i576
  %scevgep80.i = getelementptr i8, ptr %arg.room.4, i64 %109
  %scevgep79.i = getelementptr i8, ptr %scevgep80.i, i64 -24
  store double %.384.i577, ptr %scevgep79.i, align 8, !noalias !73
  %scevgep84.i = getelementptr i8, ptr %scevgep87.i, i64 -16
  %.380.1.i578 = load double, ptr %scevgep84.i, align 8, !noalias !73
  %.382.1.i579 = fmul contract double %.1745, %.380.1.i578
  %.384.1.i580 = fadd contract double %.1748, %.382.1.i579
  %scevgep77.i = getelementptr i8, ptr %scevgep80.i, i64 -16
  store double %.384.1.i580, ptr %scevgep77.i, align 8, !noalias !73
  %scevgep82.i = getelementptr i8, ptr %scevgep87.i, i64 -8
  %.380.2.i581 = load double, ptr %scevgep82.i, align 8, !noalias !73
  %.382.2.i582 = fmul contract double %.1745, %.380.2.i581
  %.384.2.i583 = fadd contract double %.1748, %.382.2.i582
  %scevgep75.i = getelementptr i8, ptr %scevgep80.i, i64 -8
  store double %.384.2.i583, ptr %scevgep75.i, align 8, !noalias !73
  %.380.3.i584 = load double, ptr %scevgep87.i, align 8, !noalias !73
  %.382.3.i585 = fmul contract double %.1745, %.380.3.i584
  %.384.3.i586 = fadd contract double %.1748, %.382.3.i585
  store double %.384.3.i586, ptr %scevgep80.i, align 8, !noalias !73
  %lsr.iv.next150.i = add nuw nsw i64 %lsr.iv149.i, 4
  %exitcond.not.3.i = icmp eq i64 %lsr.iv.next150.i, 67
  br i1 %exitcond.not.3.i, label %B182.if.i587, label %B112.if.i574

B182.if.i587:                                     ; preds = %B112.if.i574, %B182.if.i587
  %.50611801182.i588 = phi i64 [ %.513.i589, %B182.if.i587 ], [ 0, %B112.if.i574 ]
  %.513.i589 = add nuw nsw i64 %.50611801182.i588, 1
  %.567.i590 = load double, ptr %arg.prior.4, align 8, !noalias !73
  %110 = shl nuw nsw i64 %.50611801182.i588, 3
  %scevgep73.i = getelementptr i8, ptr %arg.room.4, i64 %110
  %.5981172.i591 = load i64, ptr %scevgep73.i, align 8, !noalias !73
  %.600.i592 = add nsw i64 %.5981172.i591, -4604544271217802189
  %.601.i593 = ashr i64 %.600.i592, 52
  %.602.i594 = and i64 %.600.i592, -4503599627370496
  %.603.i595 = sub nsw i64 %.5981172.i591, %.602.i594
  %.604.i596 = bitcast i64 %.603.i595 to double
  %.605.i597 = fadd contract double %.604.i596, -1.000000e+00
  %.606.i598 = fadd contract double %.605.i597, 2.000000e+00
  %.610.i599 = fdiv contract double %.605.i597, %.606.i598
  %.611.i600 = fmul contract double %.610.i599, %.610.i599
  %.612.i601 = fmul contract double %.611.i600, %.611.i600
  %.613.i602 = fmul contract double %.612.i601, 0x3FC39A09D078C69F
  %.614.i603 = fadd contract double %.613.i602, 0x3FCC71C51D8E78AF
  %.615.i604 = fmul contract double %.612.i601, %.614.i603
  %.616.i605 = fadd contract double %.615.i604, 0x3FD999999997FA04
  %.617.i606 = fmul contract double %.612.i601, %.616.i605
  %.618.i607 = fmul contract double %.612.i601, 0x3FC2F112DF3E5244
  %.619.i608 = fadd contract double %.618.i607, 0x3FC7466496CB03DE
  %.620.i609 = fmul contract double %.612.i601, %.619.i608
  %.621.i610 = fadd contract double %.620.i609, 0x3FD2492494229359
  %.622.i611 = fmul contract double %.612.i601, %.621.i610
  %.623.i612 = fadd contract double %.622.i611, 0x3FE5555555555593
  %.624.i613 = fmul contract double %.611.i600, %.623.i612
  %.625.i614 = fadd contract double %.617.i606, %.624.i613
  %.626.i615 = fmul contract double %.605.i597, 5.000000e-01
  %.627.i616 = fmul contract double %.605.i597, %.626.i615
  %.628.i617 = add nsw i64 %.601.i593, 4843621399236968448
  %.629.i618 = bitcast i64 %.628.i617 to double
  %.630.i619 = fadd contract double %.629.i618, 0xC338000000000000
  %.631.i620 = fmul contract double %.630.i619, 0x3FE62E42FEE00000
  %.632.i621 = fadd contract double %.627.i616, %.625.i614
  %.633.i622 = fmul contract double %.610.i599, %.632.i621
  %.634.i623 = fmul contract double %.630.i619, 0x3DEA39EF35793C76
  %.635.i624 = fadd contract double %.634.i623, %.633.i622
  %.636.i625 = fsub contract double %.627.i616, %.635.i624
  %.637.i626 = fsub contract double %.636.i625, %.605.i597
  %.638.i627 = fsub contract double %.631.i620, %.637.i626
  %.639.i628 = fmul contract double %.567.i590, %.638.i627
  %scevgep72.i629 = getelementptr i8, ptr %scevgep73.i, i64 512
  store double %.639.i628, ptr %scevgep72.i629, align 8, !noalias !73
  %exitcond1234.not.i = icmp eq i64 %.513.i589, 64
  br i1 %exitcond1234.not.i, label %B274.i630, label %B182.if.i587

B134.if.i.i822:                                   ; preds = %B134.if.i.i822, %B322.i813
  %.230207209.i.i823 = phi i64 [ 0, %B322.i813 ], [ %.237.i.i824, %B134.if.i.i822 ]
  %.237.i.i824 = add nuw nsw i64 %.230207209.i.i823, 1
  %111 = shl nuw nsw i64 %.230207209.i.i823, 3
  %scevgep70.i = getelementptr i8, ptr %.164.i631, i64 %111
  %scevgep69.i = getelementptr i8, ptr %scevgep70.i, i64 -512
  %.296205.i.i825 = load i64, ptr %scevgep69.i, align 8, !noalias !76
  %.298.i.i826 = add nsw i64 %.296205.i.i825, -4604544271217802189
  %.299.i.i827 = ashr i64 %.298.i.i826, 52
  %.300.i.i828 = and i64 %.298.i.i826, -4503599627370496
  %.301.i.i829 = sub nsw i64 %.296205.i.i825, %.300.i.i828
  %.302.i.i830 = bitcast i64 %.301.i.i829 to double
  %.303.i.i831 = fadd contract double %.302.i.i830, -1.000000e+00
  %.304.i.i832 = fadd contract double %.303.i.i831, 2.000000e+00
  %.308.i.i833 = fdiv contract double %.303.i.i831, %.304.i.i832
  %.309.i.i834 = fmul contract double %.308.i.i833, %.308.i.i833
  %.310.i.i835 = fmul contract double %.309.i.i834, %.309.i.i834
  %.311.i.i836 = fmul contract double %.310.i.i835, 0x3FC39A09D078C69F
  %.312.i22.i = fadd contract double %.311.i.i836, 0x3FCC71C51D8E78AF
  %.313.i.i837 = fmul contract double %.310.i.i835, %.312.i22.i
  %.314.i23.i = fadd contract double %.313.i.i837, 0x3FD999999997FA04
  %.315.i.i838 = fmul contract double %.310.i.i835, %.314.i23.i
  %.316.i.i839 = fmul contract double %.310.i.i835, 0x3FC2F112DF3E5244
  %.317.i.i840 = fadd contract double %.316.i.i839, 0x3FC7466496CB03DE
  %.318.i.i841 = fmul contract double %.310.i.i835, %.317.i.i840
  %.319.i.i842 = fadd contract double %.318.i.i841, 0x3FD2492494229359
  %.320.i.i843 = fmul contract double %.310.i.i835, %.319.i.i842
  %.321.i.i844 = fadd contract double %.320.i.i843, 0x3FE5555555555593
  %.322.i.i845 = fmul contract double %.309.i.i834, %.321.i.i844
  %.323.i.i846 = fadd contract double %.315.i.i838, %.322.i.i845
  %.324.i.i847 = fmul contract double %.303.i.i831, 5.000000e-01
  %.325.i.i848 = fmul contract double %.303.i.i831, %.324.i.i847
  %.326.i.i849 = add nsw i64 %.299.i.i827, 4843621399236968448
  %.327.i.i850 = bitcast i64 %.326.i.i849 to double
  %.328.i.i851 = fadd contract double %.327.i.i850, 0xC338000000000000
  %.329.i.i852 = fmul contract double %.328.i.i851, 0x3FE62E42FEE00000
  %.330.i.i853 = fadd contract double %.325.i.i848, %.323.i.i846
  %.331.i.i854 = fmul contract double %.308.i.i833, %.330.i.i853
  %.332.i.i855 = fmul contract double %.328.i.i851, 0x3DEA39EF35793C76
  %.333.i.i856 = fadd contract double %.332.i.i855, %.331.i.i854
  %.334.i.i857 = fsub contract double %.325.i.i848, %.333.i.i856
  %.335.i.i858 = fsub contract double %.334.i.i857, %.303.i.i831
  %.336.i.i859 = fsub contract double %.329.i.i852, %.335.i.i858
  %.337.i.i860 = fneg contract double %.336.i.i859
  %.339.i.i861 = fsub contract double %.337.i.i860, %.89.i.i817
  %.341.i.i862 = fmul contract double %.125.i.i820, %.339.i.i861
  %.348.i.i863 = fadd contract double %.341.i.i862, -5.000000e-01
  %.349.i24.i = fadd contract double %.348.i.i863, 0x4338000000000000
  %.350.i.i864 = bitcast double %.349.i24.i to i64
  %112 = tail call i64 @llvm.smax.i64(i64 %.350.i.i864, i64 4843621399236968448)
  %nearest_cell_v113__vphi100_0.2.1.i.i865 = add nsw i64 %112, -4843621399236968448
  %nearest_cell_v113__vphi120_0.2.1.i.i866 = tail call i64 @llvm.smin.i64(i64 %nearest_cell_v113__vphi100_0.2.1.i.i865, i64 %.355.i.i821)
  %.405.i.i867 = uitofp nneg i64 %nearest_cell_v113__vphi120_0.2.1.i.i866 to double
  %.406.i.i868 = fsub contract double %.341.i.i862, %.405.i.i867
  %.440.i.i869 = load double, ptr %scevgep70.i, align 8, !noalias !76
  %.idx.i.i870 = mul i64 %nearest_cell_v113__vphi120_0.2.1.i.i866, 48
  %113 = getelementptr i8, ptr %101, i64 %.idx.i.i870
  %.470.i.i871 = load double, ptr %113, align 8, !noalias !76
  %114 = getelementptr i8, ptr %113, i64 8
  %.501.i.i872 = load double, ptr %114, align 8, !noalias !76
  %115 = getelementptr i8, ptr %113, i64 16
  %.532.i.i873 = load double, ptr %115, align 8, !noalias !76
  %116 = getelementptr i8, ptr %113, i64 24
  %.563.i.i874 = load double, ptr %116, align 8, !noalias !76
  %.564.i.i875 = fmul contract double %.563.i.i874, %.406.i.i868
  %.565.i.i876 = fadd contract double %.532.i.i873, %.564.i.i875
  %.566.i.i877 = fmul contract double %.406.i.i868, %.565.i.i876
  %.567.i.i878 = fadd contract double %.501.i.i872, %.566.i.i877
  %.568.i.i879 = fmul contract double %.406.i.i868, %.567.i.i878
  %.569.i.i880 = fadd contract double %.470.i.i871, %.568.i.i879
  %.570.i.i881 = fadd contract double %.440.i.i869, %.569.i.i880
  store double %.570.i.i881, ptr %scevgep70.i, align 8, !noalias !76
  %exitcond.not.i27.i = icmp eq i64 %.237.i.i824, 64
  br i1 %exitcond.not.i27.i, label %B436.i635, label %B134.if.i.i822

B584.if.i792:                                     ; preds = %B436.i635, %B584.if.i792
  %.103911871189.i = phi i64 [ %.1046.3.i805, %B584.if.i792 ], [ 0, %B436.i635 ]
  %sunkaddr90.i = shl i64 %.103911871189.i, 3
  %sunkaddr91.i793 = getelementptr i8, ptr %arg.room.4, i64 %sunkaddr90.i
  %.1100.i794 = load double, ptr %sunkaddr91.i793, align 8, !noalias !73
  %.1102.i795 = fmul contract double %arg.x, %.1100.i794
  %sunkaddr94.i796 = getelementptr i8, ptr %sunkaddr91.i793, i64 1024
  store double %.1102.i795, ptr %sunkaddr94.i796, align 8, !noalias !73
  %sunkaddr97.i797 = getelementptr i8, ptr %sunkaddr91.i793, i64 8
  %.1100.1.i798 = load double, ptr %sunkaddr97.i797, align 8, !noalias !73
  %.1102.1.i799 = fmul contract double %arg.x, %.1100.1.i798
  %sunkaddr100.i800 = getelementptr i8, ptr %sunkaddr91.i793, i64 1032
  store double %.1102.1.i799, ptr %sunkaddr100.i800, align 8, !noalias !73
  %sunkaddr103.i801 = getelementptr i8, ptr %sunkaddr91.i793, i64 16
  %.1100.2.i802 = load double, ptr %sunkaddr103.i801, align 8, !noalias !73
  %.1102.2.i803 = fmul contract double %arg.x, %.1100.2.i802
  %sunkaddr106.i804 = getelementptr i8, ptr %sunkaddr91.i793, i64 1040
  store double %.1102.2.i803, ptr %sunkaddr106.i804, align 8, !noalias !73
  %.1046.3.i805 = add nuw nsw i64 %.103911871189.i, 4
  %sunkaddr109.i806 = getelementptr i8, ptr %sunkaddr91.i793, i64 24
  %.1100.3.i807 = load double, ptr %sunkaddr109.i806, align 8, !noalias !73
  %.1102.3.i808 = fmul contract double %arg.x, %.1100.3.i807
  %sunkaddr112.i809 = getelementptr i8, ptr %sunkaddr91.i793, i64 1048
  store double %.1102.3.i808, ptr %sunkaddr112.i809, align 8, !noalias !73
  %exitcond1235.not.3.i = icmp eq i64 %.1046.3.i805, 64
  br i1 %exitcond1235.not.3.i, label %B618.i810, label %B584.if.i792

B770.if.i641:                                     ; preds = %B770.if.i641.preheader, %B770.if.i641
  %lsr.iv118.i = phi i64 [ %lsr.iv.next119.i, %B770.if.i641 ], [ 65, %B770.if.i641.preheader ]
  %117 = shl nuw nsw i64 %lsr.iv118.i, 3
  %scevgep51.i = getelementptr i8, ptr %arg.room.4, i64 %117
  %scevgep50.i = getelementptr i8, ptr %scevgep51.i, i64 -8
  %.1422.i642 = load double, ptr %scevgep50.i, align 8, !noalias !73
  %scevgep48.i = getelementptr i8, ptr %scevgep51.i, i64 -520
  %.1452.i643 = load double, ptr %scevgep48.i, align 8, !noalias !73
  %.1485.i644 = fmul contract double %.1454.i640, %.1452.i643
  %.1487.i645 = fsub contract double %arg.x, %.1485.i644
  %.1488.i646 = fmul contract double %.1452.i643, %.1487.i645
  %.1489.i647 = fadd contract double %.1422.i642, %.1488.i646
  store double %.1489.i647, ptr %scevgep50.i, align 8, !noalias !73
  %.1422.1.i648 = load double, ptr %scevgep51.i, align 8, !noalias !73
  %scevgep46.i = getelementptr i8, ptr %scevgep51.i, i64 -512
  %.1452.1.i649 = load double, ptr %scevgep46.i, align 8, !noalias !73
  %.1485.1.i650 = fmul contract double %.1454.i640, %.1452.1.i649
  %.1487.1.i651 = fsub contract double %arg.x, %.1485.1.i650
  %.1488.1.i652 = fmul contract double %.1452.1.i649, %.1487.1.i651
  %.1489.1.i653 = fadd contract double %.1422.1.i648, %.1488.1.i652
  store double %.1489.1.i653, ptr %scevgep51.i, align 8, !noalias !73
  %lsr.iv.next119.i = add nuw nsw i64 %lsr.iv118.i, 2
  %exitcond1236.not.1.i = icmp eq i64 %lsr.iv.next119.i, 129
  br i1 %exitcond1236.not.1.i, label %B902.if.preheader.i654, label %B770.if.i641

B902.if.i656:                                     ; preds = %B902.if.i656, %B902.if.preheader.i654
  %lsr.iv109.i = phi i64 [ %lsr.iv.next110.i, %B902.if.i656 ], [ 67, %B902.if.preheader.i654 ]
  %top.2.01205.i = phi double [ %.1715.top.2.0.3.i668, %B902.if.i656 ], [ %.1560.i655, %B902.if.preheader.i654 ]
  %118 = shl nuw nsw i64 %lsr.iv109.i, 3
  %scevgep44.i = getelementptr i8, ptr %arg.room.4, i64 %118
  %scevgep43.i = getelementptr i8, ptr %scevgep44.i, i64 -24
  %.1715.i657 = load double, ptr %scevgep43.i, align 8, !noalias !73
  %.1717.i658 = fcmp contract ogt double %.1715.i657, %top.2.01205.i
  %.1715.top.2.0.i659 = select i1 %.1717.i658, double %.1715.i657, double %top.2.01205.i
  %scevgep41.i = getelementptr i8, ptr %scevgep44.i, i64 -16
  %.1715.1.i660 = load double, ptr %scevgep41.i, align 8, !noalias !73
  %.1717.1.i661 = fcmp contract ogt double %.1715.1.i660, %.1715.top.2.0.i659
  %.1715.top.2.0.1.i662 = select i1 %.1717.1.i661, double %.1715.1.i660, double %.1715.top.2.0.i659
  %scevgep39.i = getelementptr i8, ptr %scevgep44.i, i64 -8
  %.1715.2.i663 = load double, ptr %scevgep39.i, align 8, !noalias !73
  %.1717.2.i664 = fcmp contract ogt double %.1715.2.i663, %.1715.top.2.0.1.i662
  %.1715.top.2.0.2.i665 = select i1 %.1717.2.i664, double %.1715.2.i663, double %.1715.top.2.0.1.i662
  %.1715.3.i666 = load double, ptr %scevgep44.i, align 8, !noalias !73
  %.1717.3.i667 = fcmp contract ogt double %.1715.3.i666, %.1715.top.2.0.2.i665
  %.1715.top.2.0.3.i668 = select i1 %.1717.3.i667, double %.1715.3.i666, double %.1715.top.2.0.2.i665
  %lsr.iv.next110.i = add nuw nsw i64 %lsr.iv109.i, 4
  %exitcond1237.not.3.i = icmp eq i64 %lsr.iv.next110.i, 131
  br i1 %exitcond1237.not.3.i, label %B982.if.i669, label %B902.if.i656

B982.if.i669:                                     ; preds = %B902.if.i656, %B982.if.i669
  %lsr.iv105.i = phi i64 [ %lsr.iv.next106.i, %B982.if.i669 ], [ 64, %B902.if.i656 ]
  %119 = shl nuw nsw i64 %lsr.iv105.i, 3
  %scevgep37.i670 = getelementptr i8, ptr %100, i64 %119
  %.1929.i671 = load double, ptr %scevgep37.i670, align 8, !noalias !73
  %scevgep36.i = getelementptr i8, ptr %arg.room.4, i64 %119
  %.1964.i672 = load double, ptr %scevgep36.i, align 8, !noalias !73
  %.1966.i673 = fsub contract double %.1964.i672, %.1715.top.2.0.3.i668
  %.1972.i674 = fcmp contract ogt double %.1966.i673, -7.000000e+02
  %.1966..i675 = select i1 %.1972.i674, double %.1966.i673, double -7.000000e+02
  %.1989.i676 = tail call contract double @llvm.fma.f64(double %.1966..i675, double 0x3FF71547652B82FE, double 0x4338000000000000)
  %.1990.i677 = fadd contract double %.1989.i676, 0xC338000000000000
  %.1993.i678 = tail call contract double @llvm.fma.f64(double %.1990.i677, double 0xBFE62E42FEFA39EF, double %.1966..i675)
  %.1994.i679 = tail call contract double @llvm.fma.f64(double %.1990.i677, double 0xBC7ABC9E3B39803F, double %.1993.i678)
  %.1995.i680 = tail call contract double @llvm.fma.f64(double %.1994.i679, double 0x3DE6124613A86D09, double 0x3E21EED8EFF8D898)
  %.1996.i681 = tail call contract double @llvm.fma.f64(double %.1994.i679, double %.1995.i680, double 0x3E5AE64567F544E4)
  %.1997.i682 = tail call contract double @llvm.fma.f64(double %.1994.i679, double %.1996.i681, double 0x3E927E4FB7789F5C)
  %.1998.i683 = tail call contract double @llvm.fma.f64(double %.1994.i679, double %.1997.i682, double 0x3EC71DE3A556C734)
  %.1999.i684 = tail call contract double @llvm.fma.f64(double %.1994.i679, double %.1998.i683, double 0x3EFA01A01A01A01A)
  %.2000.i685 = tail call contract double @llvm.fma.f64(double %.1994.i679, double %.1999.i684, double 0x3F2A01A01A01A01A)
  %.2001.i686 = tail call contract double @llvm.fma.f64(double %.1994.i679, double %.2000.i685, double 0x3F56C16C16C16C17)
  %.2002.i687 = tail call contract double @llvm.fma.f64(double %.1994.i679, double %.2001.i686, double 0x3F81111111111111)
  %.2003.i688 = tail call contract double @llvm.fma.f64(double %.1994.i679, double %.2002.i687, double 0x3FA5555555555555)
  %.2004.i689 = tail call contract double @llvm.fma.f64(double %.1994.i679, double %.2003.i688, double 0x3FC5555555555555)
  %.2005.i690 = tail call contract double @llvm.fma.f64(double %.1994.i679, double %.2004.i689, double 5.000000e-01)
  %.2006.i691 = fmul contract double %.1994.i679, %.1994.i679
  %.2007.i692 = fadd contract double %.1994.i679, 1.000000e+00
  %.2008.i693 = tail call contract double @llvm.fma.f64(double %.2006.i691, double %.2005.i690, double %.2007.i692)
  %.2009.i694 = bitcast double %.1989.i676 to i64
  %.2010.i695 = shl i64 %.2009.i694, 52
  %.2011.i696 = add i64 %.2010.i695, 4607182418800017408
  %.2012.i697 = bitcast i64 %.2011.i696 to double
  %.2013.i698 = fmul contract double %.2008.i693, %.2012.i697
  %.2015.i699 = fmul contract double %.1929.i671, %.2013.i698
  store double %.2015.i699, ptr %scevgep36.i, align 8, !noalias !73
  %lsr.iv.next106.i = add nuw nsw i64 %lsr.iv105.i, 1
  %exitcond1238.not.i = icmp eq i64 %lsr.iv.next106.i, 128
  br i1 %exitcond1238.not.i, label %B1198.i700, label %B982.if.i669

B1266.if.i729:                                    ; preds = %B1198.i700, %B1266.if.i729
  %lsr.iv88.i = phi i64 [ %lsr.iv.next89.i, %B1266.if.i729 ], [ 67, %B1198.i700 ]
  %squares.2.01221.i = phi double [ %.2394.3.i750, %B1266.if.i729 ], [ 0.000000e+00, %B1198.i700 ]
  %120 = shl nuw nsw i64 %lsr.iv88.i, 3
  %scevgep35.i = getelementptr i8, ptr %arg.room.4, i64 %120
  %scevgep34.i = getelementptr i8, ptr %scevgep35.i, i64 -24
  %.2330.i730 = load double, ptr %scevgep34.i, align 8, !noalias !73
  %scevgep32.i = getelementptr i8, ptr %scevgep35.i, i64 -536
  %.2360.i731 = load double, ptr %scevgep32.i, align 8, !noalias !73
  %.2361.i732 = fmul contract double %.2330.i730, %.2360.i731
  %.2392.i733 = fmul contract double %.2360.i731, %.2361.i732
  %.2394.i734 = fadd contract double %squares.2.01221.i, %.2392.i733
  %scevgep29.i = getelementptr i8, ptr %scevgep35.i, i64 -16
  %.2330.1.i735 = load double, ptr %scevgep29.i, align 8, !noalias !73
  %scevgep26.i = getelementptr i8, ptr %scevgep35.i, i64 -528
  %.2360.1.i736 = load double, ptr %scevgep26.i, align 8, !noalias !73
  %.2361.1.i737 = fmul contract double %.2330.1.i735, %.2360.1.i736
  %.2392.1.i738 = fmul contract double %.2360.1.i736, %.2361.1.i737
  %.2394.1.i739 = fadd contract double %.2394.i734, %.2392.1.i738
  %scevgep23.i = getelementptr i8, ptr %scevgep35.i, i64 -8
  %.2330.2.i740 = load double, ptr %scevgep23.i, align 8, !noalias !73
  %scevgep20.i741 = getelementptr i8, ptr %scevgep35.i, i64 -520
  %.2360.2.i742 = load double, ptr %scevgep20.i741, align 8, !noalias !73
  %.2361.2.i743 = fmul contract double %.2330.2.i740, %.2360.2.i742
  %.2392.2.i744 = fmul contract double %.2360.2.i742, %.2361.2.i743
  %.2394.2.i745 = fadd contract double %.2394.1.i739, %.2392.2.i744
  %.2330.3.i746 = load double, ptr %scevgep35.i, align 8, !noalias !73
  %scevgep17.i = getelementptr i8, ptr %scevgep35.i, i64 -512
  %.2360.3.i747 = load double, ptr %scevgep17.i, align 8, !noalias !73
  %.2361.3.i748 = fmul contract double %.2330.3.i746, %.2360.3.i747
  %.2392.3.i749 = fmul contract double %.2360.3.i747, %.2361.3.i748
  %.2394.3.i750 = fadd contract double %.2394.2.i745, %.2392.3.i749
  %lsr.iv.next89.i = add nuw nsw i64 %lsr.iv88.i, 4
  %exitcond1239.not.3.i = icmp eq i64 %lsr.iv.next89.i, 131
  br i1 %exitcond1239.not.3.i, label %B1334.i751, label %B1266.if.i729

B3995.if.i:                                       ; preds = %B3995.if.i.preheader, %B3995.if.i
  %lsr.iv.i753 = phi i64 [ %lsr.iv.next.i779, %B3995.if.i ], [ -64, %B3995.if.i.preheader ]
  %firsts.2.01230.i = phi double [ %.2646.3.i778, %B3995.if.i ], [ 0.000000e+00, %B3995.if.i.preheader ]
  %sunkaddr113.i = shl i64 %lsr.iv.i753, 3
  %sunkaddr114.i754 = getelementptr i8, ptr %arg.room.4, i64 %sunkaddr113.i
  %sunkaddr115.i755 = getelementptr i8, ptr %sunkaddr114.i754, i64 1024
  %.2613.i756 = load double, ptr %sunkaddr115.i755, align 8, !noalias !73
  %sunkaddr118.i757 = getelementptr i8, ptr %sunkaddr114.i754, i64 512
  %.2643.i758 = load double, ptr %sunkaddr118.i757, align 8, !noalias !73
  %.2644.i759 = fmul contract double %.2613.i756, %.2643.i758
  %.2646.i760 = fadd contract double %firsts.2.01230.i, %.2644.i759
  %sunkaddr121.i761 = getelementptr i8, ptr %sunkaddr114.i754, i64 1032
  %.2613.1.i762 = load double, ptr %sunkaddr121.i761, align 8, !noalias !73
  %sunkaddr124.i763 = getelementptr i8, ptr %sunkaddr114.i754, i64 520
  %.2643.1.i764 = load double, ptr %sunkaddr124.i763, align 8, !noalias !73
  %.2644.1.i765 = fmul contract double %.2613.1.i762, %.2643.1.i764
  %.2646.1.i766 = fadd contract double %.2646.i760, %.2644.1.i765
  %sunkaddr127.i767 = getelementptr i8, ptr %sunkaddr114.i754, i64 1040
  %.2613.2.i768 = load double, ptr %sunkaddr127.i767, align 8, !noalias !73
  %sunkaddr130.i769 = getelementptr i8, ptr %sunkaddr114.i754, i64 528
  %.2643.2.i770 = load double, ptr %sunkaddr130.i769, align 8, !noalias !73
  %.2644.2.i771 = fmul contract double %.2613.2.i768, %.2643.2.i770
  %.2646.2.i772 = fadd contract double %.2646.1.i766, %.2644.2.i771
  %sunkaddr133.i773 = getelementptr i8, ptr %sunkaddr114.i754, i64 1048
  %.2613.3.i774 = load double, ptr %sunkaddr133.i773, align 8, !noalias !73
  %sunkaddr136.i775 = getelementptr i8, ptr %sunkaddr114.i754, i64 536
  %.2643.3.i776 = load double, ptr %sunkaddr136.i775, align 8, !noalias !73
  %.2644.3.i777 = fmul contract double %.2613.3.i774, %.2643.3.i776
  %.2646.3.i778 = fadd contract double %.2646.2.i772, %.2644.3.i777
  %lsr.iv.next.i779 = add nsw i64 %lsr.iv.i753, 4
  %exitcond1240.not.3.i = icmp eq i64 %lsr.iv.next.i779, 0
  br i1 %exitcond1240.not.3.i, label %B4011.i, label %B3995.if.i

_ZN17bnserve_inference15marginal_kernel9_distance8_by_ruleB4v133B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEdddd28Literal_5bbool_5d_28False_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2864_295ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit: ; preds = %B1198.i700, %B4011.i
  %.1757.sroa.8.1 = phi double [ %.2673.i781, %B4011.i ], [ 0.000000e+00, %B1198.i700 ]
  %.1757.sroa.11.1 = phi double [ %.2678.i782, %B4011.i ], [ 0.000000e+00, %B1198.i700 ]
  %.1757.sroa.0.1 = fadd contract double %.1715.top.2.0.3.i668, 0.000000e+00
  call void @llvm.lifetime.end.p0(ptr nonnull %.1211.i570)
  call void @llvm.lifetime.end.p0(ptr nonnull %.2410.i572)
  %.1798 = icmp eq i64 %.1685851853, 0
  %.1819 = fcmp contract ogt double %.1715.top.2.0.3.i668, %top.2.0856
  %or.cond815 = select i1 %.1798, i1 true, i1 %.1819
  br i1 %or.cond815, label %B3111, label %B3387
}

; Function Attrs: mustprogress nocallback nocreateundeforpoison nofree nosync nounwind speculatable willreturn memory(none)
declare double @llvm.fma.f64(double, double, double) #2

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
  %.74.i = load i64, ptr %.73.i, align 8, !noalias !82
  %.153.i = getelementptr i8, ptr %arg.arguments.4, i64 64
  %.154.i = load i64, ptr %.153.i, align 8, !noalias !82
  %.204.i = mul nsw i64 %.154.i, 6
  %.286.i = getelementptr i8, ptr %arg.prior.4, i64 56
  %.287.i = load double, ptr %.286.i, align 8, !noalias !82
  %.315.i = getelementptr i8, ptr %arg.prior.4, i64 64
  %.316.i = load double, ptr %.315.i, align 8, !noalias !82
  %.320.i = fdiv contract double 1.000000e+00, %.316.i
  %.349.i = load double, ptr %arg.prior.4, align 8, !noalias !82
  %.4422551.not.i = icmp slt i64 %.172, 1
  br i1 %.4422551.not.i, label %_ZN17bnserve_inference15marginal_kernel7_circle9_togetherB4v144B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit, label %B344.if.lr.ph.i

B360.i:                                           ; preds = %B344.if.i
  %4 = shl i64 %lsr.iv1927.i, 3
  %scevgep1947.i = getelementptr i8, ptr %arg.waiting.4, i64 %4
  %scevgep1948.i = getelementptr i8, ptr %scevgep1947.i, i64 -3840
  %.519714.i = load i64, ptr %scevgep1948.i, align 8, !noalias !82
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
  %nearest_cell_v150__vphi100_0.2.2.i = add nsw i64 %5, -4843621399236968448
  %nearest_cell_v150__vphi120_0.2.2.i = tail call i64 @llvm.smin.i64(i64 %nearest_cell_v150__vphi100_0.2.2.i, i64 %.574.i)
  %scevgep20.i = getelementptr i8, ptr %scevgep1947.i, i64 -1536
  %.659.i = sitofp i64 %nearest_cell_v150__vphi120_0.2.2.i to double
  store double %.659.i, ptr %scevgep20.i, align 8, !noalias !82
  %6 = add i64 %lsr.iv1927.i, -160
  %.794.i = icmp slt i64 %nearest_cell_v150__vphi120_0.2.2.i, 0
  %.795.i = select i1 %.794.i, i64 %.204.i, i64 0
  %.idx.i = mul i64 %nearest_cell_v150__vphi120_0.2.2.i, 48
  %7 = getelementptr i8, ptr %33, i64 %.idx.i
  %.809.i = getelementptr double, ptr %7, i64 %.795.i
  %.810.i = load double, ptr %.809.i, align 8, !noalias !82
  %.828.i = icmp slt i64 %6, 0
  %8 = select i1 %.828.i, i64 4352, i64 0
  %scevgep1942.i = getelementptr i8, ptr %arg.waiting.4, i64 %8
  %scevgep15.i = getelementptr i8, ptr %scevgep1942.i, i64 %4
  %scevgep16.i = getelementptr i8, ptr %scevgep15.i, i64 -1280
  store double %.810.i, ptr %scevgep16.i, align 8, !noalias !82
  %9 = getelementptr i8, ptr %7, i64 8
  %.809.1.i = getelementptr double, ptr %9, i64 %.795.i
  %.810.1.i = load double, ptr %.809.1.i, align 8, !noalias !82
  %10 = add i64 %lsr.iv1927.i, -128
  %.828.1.i = icmp slt i64 %10, 0
  %11 = select i1 %.828.1.i, i64 4352, i64 0
  %scevgep1939.i = getelementptr i8, ptr %arg.waiting.4, i64 %11
  %scevgep13.i = getelementptr i8, ptr %scevgep1939.i, i64 %4
  %scevgep14.i = getelementptr i8, ptr %scevgep13.i, i64 -1024
  store double %.810.1.i, ptr %scevgep14.i, align 8, !noalias !82
  %12 = getelementptr i8, ptr %7, i64 16
  %.809.2.i = getelementptr double, ptr %12, i64 %.795.i
  %.810.2.i = load double, ptr %.809.2.i, align 8, !noalias !82
  %13 = add i64 %lsr.iv1927.i, -96
  %.828.2.i = icmp slt i64 %13, 0
  %14 = select i1 %.828.2.i, i64 4352, i64 0
  %scevgep1936.i = getelementptr i8, ptr %arg.waiting.4, i64 %14
  %scevgep11.i = getelementptr i8, ptr %scevgep1936.i, i64 %4
  %scevgep12.i = getelementptr i8, ptr %scevgep11.i, i64 -768
  store double %.810.2.i, ptr %scevgep12.i, align 8, !noalias !82
  %15 = getelementptr i8, ptr %7, i64 24
  %.809.3.i = getelementptr double, ptr %15, i64 %.795.i
  %.810.3.i = load double, ptr %.809.3.i, align 8, !noalias !82
  %16 = add i64 %lsr.iv1927.i, -64
  %.828.3.i = icmp slt i64 %16, 0
  %17 = select i1 %.828.3.i, i64 4352, i64 0
  %scevgep1933.i = getelementptr i8, ptr %arg.waiting.4, i64 %17
  %scevgep9.i = getelementptr i8, ptr %scevgep1933.i, i64 %4
  %scevgep10.i = getelementptr i8, ptr %scevgep9.i, i64 -512
  store double %.810.3.i, ptr %scevgep10.i, align 8, !noalias !82
  %18 = getelementptr i8, ptr %7, i64 32
  %.809.4.i = getelementptr double, ptr %18, i64 %.795.i
  %.810.4.i = load double, ptr %.809.4.i, align 8, !noalias !82
  %19 = add i64 %lsr.iv1927.i, -32
  %.828.4.i = icmp slt i64 %19, 0
  %20 = select i1 %.828.4.i, i64 4352, i64 0
  %scevgep1930.i = getelementptr i8, ptr %arg.waiting.4, i64 %20
  %scevgep2.i = getelementptr i8, ptr %scevgep1930.i, i64 %4
  %scevgep8.i = getelementptr i8, ptr %scevgep2.i, i64 -256
  store double %.810.4.i, ptr %scevgep8.i, align 8, !noalias !82
  %21 = getelementptr i8, ptr %7, i64 40
  %.809.5.i = getelementptr double, ptr %21, i64 %.795.i
  %.810.5.i = load double, ptr %.809.5.i, align 8, !noalias !82
  %.828.5.i = icmp slt i64 %lsr.iv1927.i, 0
  %22 = select i1 %.828.5.i, i64 4352, i64 0
  %scevgep.i = getelementptr i8, ptr %arg.waiting.4, i64 %22
  %scevgep1.i = getelementptr i8, ptr %scevgep.i, i64 %4
  store double %.810.5.i, ptr %scevgep1.i, align 8, !noalias !82
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

B1926.i:                                          ; preds = %B4168.i, %B1910.i
  %.936.sroa.0.01836.i = phi i64 [ 0, %B1910.i ], [ %.936.sroa.0.0.i, %B4168.i ]
  %.94526821835.i = phi i64 [ %.94526821833.i, %B1910.i ], [ %.9452682.i, %B4168.i ]
  %.95227491834.i = phi i64 [ 8, %B1910.i ], [ %.9522749.i, %B4168.i ]
  %26 = getelementptr double, ptr %arg.waiting.4, i64 %.936.sroa.0.01836.i
  %.997.i = getelementptr i8, ptr %26, i64 256
  %.999.i = load <8 x double>, ptr %.997.i, align 8, !noalias !82
  %.1010.i = getelementptr i8, ptr %26, i64 512
  %.1012.i = load <8 x double>, ptr %.1010.i, align 8, !noalias !82
  %.1029.i = getelementptr i8, ptr %26, i64 2560
  %.1031.i = load <8 x double>, ptr %.1029.i, align 8, !noalias !82
  %.1042.i = getelementptr i8, ptr %26, i64 2816
  %.1044.i = load <8 x double>, ptr %.1042.i, align 8, !noalias !82
  %.1056.i = getelementptr i8, ptr %26, i64 3072
  %.1058.i = load <8 x double>, ptr %.1056.i, align 8, !noalias !82
  %.1079.i = getelementptr i8, ptr %26, i64 3328
  %.1081.i = load <8 x double>, ptr %.1079.i, align 8, !noalias !82
  %.1093.i = getelementptr i8, ptr %26, i64 3584
  %.1095.i = load <8 x double>, ptr %.1093.i, align 8, !noalias !82
  %.1113.i = getelementptr i8, ptr %26, i64 3840
  %.1115.i = load <8 x double>, ptr %.1113.i, align 8, !noalias !82
  %.1127.i = getelementptr i8, ptr %26, i64 4096
  %.1129.i = load <8 x double>, ptr %.1127.i, align 8, !noalias !82
  %.8.i1883.i = fsub contract <8 x double> zeroinitializer, %.1031.i
  br label %B2464.i

B2464.i:                                          ; preds = %B4148.i, %B1926.i
  %lsr.iv2.i = phi i64 [ %math.i, %B4148.i ], [ -8, %B1926.i ]
  %.1249.sroa.0.01829.i = phi i64 [ %.1249.sroa.0.0.i, %B4148.i ], [ 0, %B1926.i ]
  %top.3.11826.i = phi <8 x double> [ %top.2.2.i, %B4148.i ], [ zeroinitializer, %B1926.i ]
  %squares.2.11825.i = phi <8 x double> [ %.2892.i, %B4148.i ], [ zeroinitializer, %B1926.i ]
  %firsts.2.11824.i = phi <8 x double> [ %.2862.i, %B4148.i ], [ zeroinitializer, %B1926.i ]
  %factor.2.11823.i = phi <8 x double> [ %.6.i1904.i, %B4148.i ], [ zeroinitializer, %B1926.i ]
  %.1308.i = getelementptr inbounds double, ptr %25, i64 %.1249.sroa.0.01829.i
  %.1309.i = load double, ptr %.1308.i, align 8, !noalias !82
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
  br i1 %32, label %B4144.i, label %B4148.i

B4144.i:                                          ; preds = %B2464.i
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
  br label %B4148.i

B4148.i:                                          ; preds = %B4144.i, %B2464.i
  %beside.3.2.i = phi <8 x double> [ %.2546.i, %B4144.i ], [ %.8.i1879.i, %B2464.i ]
  %.2561.i = icmp eq i64 %.1249.sroa.0.01829.i, 0
  %top.2.2.i = select i1 %.2561.i, <8 x double> %beside.3.2.i, <8 x double> %top.3.11826.i
  %sunkaddr1949.i = shl i64 %.1249.sroa.0.01829.i, 3
  %sunkaddr1950.i = getelementptr i8, ptr %25, i64 %sunkaddr1949.i
  %sunkaddr1951.i = getelementptr i8, ptr %sunkaddr1950.i, i64 64
  %.2582.i = load double, ptr %sunkaddr1951.i, align 8, !noalias !82
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
  br i1 %ov.i, label %B4168.i, label %B2464.i

B4168.i:                                          ; preds = %B4148.i
  %sunkaddr1952.i = shl i64 %.936.sroa.0.01836.i, 3
  %sunkaddr1953.i = getelementptr i8, ptr %arg.waiting.4, i64 %sunkaddr1952.i
  %.2931.i = load <8 x double>, ptr %sunkaddr1953.i, align 8, !noalias !82
  %.8.i1839.i = fmul contract <8 x double> %.2931.i, splat (double 5.000000e-01)
  %.6.i1906.i = fmul contract <8 x double> %.999.i, %.8.i1839.i
  %.6.i1907.i = fadd contract <8 x double> %top.2.2.i, %.6.i1906.i
  %sunkaddr1956.i = getelementptr i8, ptr %sunkaddr1953.i, i64 2304
  store <8 x double> %.6.i1907.i, ptr %sunkaddr1956.i, align 8, !noalias !82
  %.6.i1908.i = fmul contract <8 x double> %.1012.i, %.6.i1904.i
  %sunkaddr1959.i = getelementptr i8, ptr %sunkaddr1953.i, i64 1536
  store <8 x double> %.6.i1908.i, ptr %sunkaddr1959.i, align 8, !noalias !82
  %.6.i1909.i = fmul contract <8 x double> %.1012.i, %.2862.i
  %sunkaddr1962.i = getelementptr i8, ptr %sunkaddr1953.i, i64 1792
  store <8 x double> %.6.i1909.i, ptr %sunkaddr1962.i, align 8, !noalias !82
  %.6.i1910.i = fmul contract <8 x double> %.1012.i, %.2892.i
  %sunkaddr1965.i = getelementptr i8, ptr %sunkaddr1953.i, i64 2048
  store <8 x double> %.6.i1910.i, ptr %sunkaddr1965.i, align 8, !noalias !82
  %.946.i = icmp sgt i64 %.94526821835.i, 0
  %.959.i = add i64 %.95227491834.i, 8
  %.9522749.i = select i1 %.946.i, i64 %.959.i, i64 %.95227491834.i
  %.955.i = sext i1 %.946.i to i64
  %.9452682.i = add nsw i64 %.94526821835.i, %.955.i
  %.936.sroa.0.0.i = select i1 %.946.i, i64 %.95227491834.i, i64 0
  br i1 %.946.i, label %B1926.i, label %_ZN17bnserve_inference15marginal_kernel7_circle9_togetherB4v144B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit

B344.if.lr.ph.i:                                  ; preds = %B210
  %.198.i = getelementptr i8, ptr %arg.arguments.4, i64 72
  %.199.i = load i64, ptr %.198.i, align 8, !noalias !82
  %.574.i = add nsw i64 %.154.i, -1
  %32 = icmp sgt i64 %.154.i, 0
  %33 = inttoptr i64 %.199.i to ptr
  br label %B344.if.i

B344.if.i:                                        ; preds = %B344.if.lr.ph.i, %B1594.i
  %lsr.iv1927.i = phi i64 [ 512, %B344.if.lr.ph.i ], [ %lsr.iv.next1928.i, %B1594.i ]
  br i1 %32, label %B360.i, label %B1594.i

_ZN17bnserve_inference15marginal_kernel7_circle9_togetherB4v144B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit: ; preds = %B4168.i, %B210
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

B362:                                             ; preds = %B322.if.2, %_ZN17bnserve_inference15marginal_kernel7_circle9_togetherB4v144B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit
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

B322.if.preheader:                                ; preds = %_ZN17bnserve_inference15marginal_kernel7_circle9_togetherB4v144B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit
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
  br i1 %prol.iter.cmp.not, label %B322.if.prol.loopexit.loopexit, label %B322.if.prol, !llvm.loop !85

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
declare <8 x double> @llvm.fabs.v8f64(<8 x double>) #2

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
  br i1 %epil.iter.cmp.not, label %B280, label %B230.if.epil, !llvm.loop !86

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
  br i1 %epil.iter98.cmp.not, label %B1420, label %B1002.if.epil, !llvm.loop !87

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

B1426.loopexit:                                   ; preds = %B4236.if, %B1426.if
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
  br i1 %12, label %B1426.loopexit, label %B4236.if.preheader

B4236.if.preheader:                               ; preds = %B1426.if
  %sunkaddr82 = shl i64 %.182913811387, 3
  %sunkaddr83 = getelementptr i8, ptr %arg.waiting.4, i64 %sunkaddr82
  %sunkaddr84 = getelementptr i8, ptr %sunkaddr83, i64 1280
  %sunkaddr87 = getelementptr i8, ptr %sunkaddr83, i64 1792
  %sunkaddr90 = getelementptr i8, ptr %sunkaddr83, i64 2048
  %sunkaddr95 = getelementptr i8, ptr %sunkaddr83, i64 768
  %sunkaddr98 = getelementptr i8, ptr %sunkaddr83, i64 1024
  br label %B4236.if

B4236.if:                                         ; preds = %B4236.if.preheader, %B4236.if
  %imaginary.2.11377 = phi double [ %.2649, %B4236.if ], [ 0.000000e+00, %B4236.if.preheader ]
  %real.2.11376 = phi double [ %.2582, %B4236.if ], [ 1.000000e+00, %B4236.if.preheader ]
  %.196813721374 = phi i64 [ %.1975, %B4236.if ], [ 0, %B4236.if.preheader ]
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
  br i1 %exitcond1395.not, label %B1426.loopexit, label %B4236.if
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
!4 = distinct !{!4, !5, !"_ZN17bnserve_inference15marginal_kernel7_circle11over_circleB3v43B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!5 = distinct !{!5, !"_ZN17bnserve_inference15marginal_kernel7_circle11over_circleB3v43B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!6 = !{!7, !4, !1}
!7 = distinct !{!7, !8, !"_ZN17bnserve_inference15marginal_kernel7_circle10_integrateB3v55B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedEx8UniTupleIdLi3EEd5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!8 = distinct !{!8, !"_ZN17bnserve_inference15marginal_kernel7_circle10_integrateB3v55B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedEx8UniTupleIdLi3EEd5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!9 = !{!10, !7, !4, !1}
!10 = distinct !{!10, !11, !"_ZN17bnserve_inference15marginal_kernel7_circle7_surveyB3v65B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedExx8UniTupleIdLi3EEd5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!11 = distinct !{!11, !"_ZN17bnserve_inference15marginal_kernel7_circle7_surveyB3v65B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedExx8UniTupleIdLi3EEd5ArrayIdLi1E1C7mutable7alignedE"}
!12 = distinct !{!12, !13}
!13 = !{!"llvm.loop.unroll.disable"}
!14 = !{!15, !10, !7, !4, !1}
!15 = distinct !{!15, !16, !"_ZN17bnserve_inference15marginal_kernel7_circle10_at_phasesB3v66B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedExd8UniTupleIdLi3EEdd: %retptr"}
!16 = distinct !{!16, !"_ZN17bnserve_inference15marginal_kernel7_circle10_at_phasesB3v66B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedExd8UniTupleIdLi3EEdd"}
!17 = !{!18, !10, !7, !4, !1}
!18 = distinct !{!18, !19, !"_ZN17bnserve_inference15marginal_kernel7_circle10_at_phasesB3v66B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedExd8UniTupleIdLi3EEdd: %retptr"}
!19 = distinct !{!19, !"_ZN17bnserve_inference15marginal_kernel7_circle10_at_phasesB3v66B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedExd8UniTupleIdLi3EEdd"}
!20 = distinct !{!20, !13}
!21 = !{!22, !7, !4, !1}
!22 = distinct !{!22, !23, !"_ZN17bnserve_inference15marginal_kernel7_circle7_halvedB3v85B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedEdx5ArrayIdLi1E1C7mutable7alignedEx: %retptr"}
!23 = distinct !{!23, !"_ZN17bnserve_inference15marginal_kernel7_circle7_halvedB3v85B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedEdx5ArrayIdLi1E1C7mutable7alignedEx"}
!24 = !{!25, !7, !4, !1}
!25 = distinct !{!25, !26, !"_ZN17bnserve_inference15marginal_kernel7_circle7_finishB4v165B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedEx28Literal_5bbool_5d_28False_29x5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!26 = distinct !{!26, !"_ZN17bnserve_inference15marginal_kernel7_circle7_finishB4v165B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedEx28Literal_5bbool_5d_28False_29x5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!27 = !{!28, !7, !4, !1}
!28 = distinct !{!28, !29, !"_ZN17bnserve_inference15marginal_kernel7_circle7_finishB4v165B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedEx28Literal_5bbool_5d_28False_29x5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!29 = distinct !{!29, !"_ZN17bnserve_inference15marginal_kernel7_circle7_finishB4v165B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedEx28Literal_5bbool_5d_28False_29x5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!30 = distinct !{!30, !13}
!31 = distinct !{!31, !13}
!32 = !{!33, !7, !4, !1}
!33 = distinct !{!33, !34, !"_ZN17bnserve_inference15marginal_kernel7_circle10_at_phasesB3v66B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedExd8UniTupleIdLi3EEdd: %retptr"}
!34 = distinct !{!34, !"_ZN17bnserve_inference15marginal_kernel7_circle10_at_phasesB3v66B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedExd8UniTupleIdLi3EEdd"}
!35 = !{!36, !1}
!36 = distinct !{!36, !37, !"_ZN17bnserve_inference15marginal_kernel7_source8_at_onceB4v171B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!37 = distinct !{!37, !"_ZN17bnserve_inference15marginal_kernel7_source8_at_onceB4v171B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!38 = !{!39, !1}
!39 = distinct !{!39, !40, !"_ZN17bnserve_inference15marginal_kernel7_source12_over_phasesB2v7B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!40 = distinct !{!40, !"_ZN17bnserve_inference15marginal_kernel7_source12_over_phasesB2v7B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!41 = !{!42}
!42 = distinct !{!42, !43, !"_ZN17bnserve_inference15marginal_kernel9_distance8_by_ruleB4v102B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEdddd27Literal_5bbool_5d_28True_295ArrayIdLi1E1C7mutable7alignedE23Literal_5bint_5d_288_295ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!43 = distinct !{!43, !"_ZN17bnserve_inference15marginal_kernel9_distance8_by_ruleB4v102B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEdddd27Literal_5bbool_5d_28True_295ArrayIdLi1E1C7mutable7alignedE23Literal_5bint_5d_288_295ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!44 = !{!45, !42}
!45 = distinct !{!45, !46, !"_ZN17bnserve_inference15marginal_kernel9_distance10_add_tableB4v111B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!46 = distinct !{!46, !"_ZN17bnserve_inference15marginal_kernel9_distance10_add_tableB4v111B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE"}
!47 = !{!48, !42}
!48 = distinct !{!48, !49, !"_ZN17bnserve_inference6kernel5_sums8lane_sumB4v114B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!49 = distinct !{!49, !"_ZN17bnserve_inference6kernel5_sums8lane_sumB4v114B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE"}
!50 = !{!51}
!51 = distinct !{!51, !52, !"_ZN17bnserve_inference15marginal_kernel9_distance8_by_ruleB4v115B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEdddd27Literal_5bbool_5d_28True_295ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!52 = distinct !{!52, !"_ZN17bnserve_inference15marginal_kernel9_distance8_by_ruleB4v115B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEdddd27Literal_5bbool_5d_28True_295ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!53 = !{!54, !51}
!54 = distinct !{!54, !55, !"_ZN17bnserve_inference15marginal_kernel9_distance10_add_tableB4v111B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!55 = distinct !{!55, !"_ZN17bnserve_inference15marginal_kernel9_distance10_add_tableB4v111B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE"}
!56 = !{!57, !51}
!57 = distinct !{!57, !58, !"_ZN17bnserve_inference6kernel5_sums8lane_sumB4v114B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!58 = distinct !{!58, !"_ZN17bnserve_inference6kernel5_sums8lane_sumB4v114B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE"}
!59 = !{!60}
!60 = distinct !{!60, !61, !"_ZN17bnserve_inference15marginal_kernel9_distance8_by_ruleB4v124B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEdddd28Literal_5bbool_5d_28False_295ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!61 = distinct !{!61, !"_ZN17bnserve_inference15marginal_kernel9_distance8_by_ruleB4v124B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEdddd28Literal_5bbool_5d_28False_295ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!62 = !{!63, !60}
!63 = distinct !{!63, !64, !"_ZN17bnserve_inference15marginal_kernel9_distance10_add_tableB4v111B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!64 = distinct !{!64, !"_ZN17bnserve_inference15marginal_kernel9_distance10_add_tableB4v111B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE"}
!65 = distinct !{!65, !13}
!66 = !{!67, !60}
!67 = distinct !{!67, !68, !"_ZN17bnserve_inference6kernel5_sums8lane_sumB4v114B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!68 = distinct !{!68, !"_ZN17bnserve_inference6kernel5_sums8lane_sumB4v114B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE"}
!69 = distinct !{!69, !13}
!70 = distinct !{!70, !13}
!71 = distinct !{!71, !13}
!72 = distinct !{!72, !13}
!73 = !{!74}
!74 = distinct !{!74, !75, !"_ZN17bnserve_inference15marginal_kernel9_distance8_by_ruleB4v133B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEdddd28Literal_5bbool_5d_28False_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2864_295ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!75 = distinct !{!75, !"_ZN17bnserve_inference15marginal_kernel9_distance8_by_ruleB4v133B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEdddd28Literal_5bbool_5d_28False_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2864_295ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!76 = !{!77, !74}
!77 = distinct !{!77, !78, !"_ZN17bnserve_inference15marginal_kernel9_distance10_add_tableB4v111B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!78 = distinct !{!78, !"_ZN17bnserve_inference15marginal_kernel9_distance10_add_tableB4v111B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE"}
!79 = !{!80, !74}
!80 = distinct !{!80, !81, !"_ZN17bnserve_inference6kernel5_sums8lane_sumB4v114B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!81 = distinct !{!81, !"_ZN17bnserve_inference6kernel5_sums8lane_sumB4v114B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE"}
!82 = !{!83}
!83 = distinct !{!83, !84, !"_ZN17bnserve_inference15marginal_kernel7_circle9_togetherB4v144B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!84 = distinct !{!84, !"_ZN17bnserve_inference15marginal_kernel7_circle9_togetherB4v144B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!85 = distinct !{!85, !13}
!86 = distinct !{!86, !13}
!87 = distinct !{!87, !13}
