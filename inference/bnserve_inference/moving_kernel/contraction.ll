; sources: 51c557c913b237311bf48c5b45632f15dd94bc6e4d5c1b3d0f9b3cc6d5609ff1
; built by: numba 0.68.1, llvmlite 0.50.0, Python 3.11, x86_64
; ModuleID = '<string>'
source_filename = "<string>"


; Function Attrs: nofree norecurse nosync nounwind memory(readwrite, inaccessiblemem: none, target_mem0: none, target_mem1: none)
define noundef i32 @bnserve_contract_moving(ptr noalias writeonly captures(none) %retptr, ptr noalias readnone captures(none) %excinfo, ptr readonly captures(none) %arg.arguments) local_unnamed_addr #0 {
entry:
  %.2081.i.i = alloca ptr, align 8
  %.2136.i.i = alloca ptr, align 8
  %.47.i = load i64, ptr %arg.arguments, align 8, !noalias !0
  %.76.i = getelementptr i8, ptr %arg.arguments, i64 136
  %.77.i = load i64, ptr %.76.i, align 8, !noalias !0
  %.106.i = getelementptr i8, ptr %arg.arguments, i64 8
  %.107.i = load i64, ptr %.106.i, align 8, !noalias !0
  %.150.i = getelementptr i8, ptr %arg.arguments, i64 248
  %.151.i = load i64, ptr %.150.i, align 8, !noalias !0
  %.155.i = inttoptr i64 %.151.i to ptr
  %.289.idx.i = mul i64 %.47.i, 200
  %.289.i = getelementptr inbounds i8, ptr %.155.i, i64 %.289.idx.i
  %.348.i = sub i64 0, %.107.i
  %.356.1.i = and i64 %.348.i, -8
  %.390.i = sub i64 0, %.356.1.i
  %.422.i = getelementptr i8, ptr %arg.arguments, i64 208
  %.423.i = load i64, ptr %.422.i, align 8, !noalias !0
  %.425.i = mul nsw i64 %.423.i, %.77.i
  %.427.i = add nsw i64 %.77.i, 1
  %.429.i = mul nsw i64 %.427.i, %.77.i
  %.504.i = getelementptr i8, ptr %arg.arguments, i64 240
  %.505.i = load i64, ptr %.504.i, align 8, !noalias !0
  %.506.not.i = icmp eq i64 %.505.i, 0
  %.510.i = mul nsw i64 %.107.i, %.77.i
  %"$phi500.0.2.0.i" = select i1 %.506.not.i, i64 0, i64 %.510.i
  %.560.i = getelementptr i8, ptr %arg.arguments, i64 160
  %.561.i = load i64, ptr %.560.i, align 8, !noalias !0
  %.910.i = shl i64 %.425.i, 4
  %0 = shl i64 %.429.i, 3
  %.1298.i = and i64 %0, -16
  %.1689.i = shl i64 %"$phi500.0.2.0.i", 4
  %.2099.i = and i64 %.390.i, 504
  %.2102.not.i = icmp ne i64 %.2099.i, 0
  %.21031013.i = lshr i64 %.390.i, 9
  %.2104.i = zext i1 %.2102.not.i to i64
  %.2105.i = add nuw nsw i64 %.21031013.i, %.2104.i
  %.64167.i = icmp sgt i64 %.561.i, 0
  br i1 %.64167.i, label %B568.lr.ph.i, label %_ZN17bnserve_inference13moving_kernel7_source8contractB2v3B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIxLi1E1C7mutable7alignedE.exit

B568.i:                                           ; preds = %B568.lr.ph.i, %B1468.i
  %.631.sroa.0.073.i = phi i64 [ 0, %B568.lr.ph.i ], [ %.631.sroa.0.0.i, %B1468.i ]
  %.640112672.i = phi i64 [ %.640112670.i, %B568.lr.ph.i ], [ %.6401126.i, %B1468.i ]
  %.647114071.i = phi i64 [ 1, %B568.lr.ph.i ], [ %.6471140.i, %B1468.i ]
  %.712.i = load i64, ptr %sunkaddr107.i, align 8, !noalias !0
  %.715.i = mul nsw i64 %.631.sroa.0.073.i, 56
  %.716.i = add nsw i64 %.712.i, %.715.i
  %.717.i = inttoptr i64 %.716.i to ptr
  %.792.i = getelementptr i8, ptr %.717.i, i64 24
  %.793.i = load double, ptr %.792.i, align 8, !noalias !0
  %.237.i.i = load i64, ptr %arg.arguments, align 8, !noalias !3
  %.317385.not.i.i = icmp slt i64 %.237.i.i, 1
  br i1 %.317385.not.i.i, label %_ZN17bnserve_inference13moving_kernel7_source6_placeB3v14B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i, label %B232.if.preheader.i.i

B232.if.preheader.i.i:                            ; preds = %B568.i
  %.153.i.i = load i64, ptr %.152.i.i, align 8, !noalias !3
  %1 = inttoptr i64 %.153.i.i to ptr
  %.145.i.i.i = getelementptr i8, ptr %1, i64 8
  %.345.i.i.i = getelementptr i8, ptr %.717.i, i64 8
  %.2102.i.i.i = getelementptr i8, ptr %.717.i, i64 16
  br label %B232.if.i.i

B232.if.i.i:                                      ; preds = %_ZN17bnserve_inference13moving_kernel9_response12coefficientsB3v21B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i.i, %B232.if.preheader.i.i
  %lsr.iv105.i.i = phi i64 [ %lsr.iv.next106.i.i, %_ZN17bnserve_inference13moving_kernel9_response12coefficientsB3v21B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i.i ], [ %.237.i.i, %B232.if.preheader.i.i ]
  %lsr.iv103.i.i = phi i64 [ %lsr.iv.next104.i.i, %_ZN17bnserve_inference13moving_kernel9_response12coefficientsB3v21B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i.i ], [ 0, %B232.if.preheader.i.i ]
  %lsr.iv101.i.i = phi i64 [ %lsr.iv.next102.i.i, %_ZN17bnserve_inference13moving_kernel9_response12coefficientsB3v21B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i.i ], [ 0, %B232.if.preheader.i.i ]
  %lsr.iv100.i.i = phi i64 [ %lsr.iv.next.i.i, %_ZN17bnserve_inference13moving_kernel9_response12coefficientsB3v21B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i.i ], [ 0, %B232.if.preheader.i.i ]
  %lsr.iv.i.i = phi ptr [ %scevgep.i.i, %_ZN17bnserve_inference13moving_kernel9_response12coefficientsB3v21B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i.i ], [ %.155.i, %B232.if.preheader.i.i ]
  %.385.i.i = load i64, ptr %sunkaddr10.i.i, align 8, !noalias !3
  %2 = add i64 %.385.i.i, %lsr.iv103.i.i
  %.388.i.i = inttoptr i64 %2 to ptr
  %.466.i.i = load i64, ptr %sunkaddr11.i.i, align 8, !noalias !3
  %3 = add i64 %.466.i.i, %lsr.iv101.i.i
  %.469.i.i = inttoptr i64 %3 to ptr
  %.547.i.i = load i64, ptr %sunkaddr.i.i, align 8, !noalias !3
  %4 = add i64 %.547.i.i, %lsr.iv100.i.i
  %.550.i.i = inttoptr i64 %4 to ptr
  %.691.i.i = load i64, ptr %sunkaddr12.i.i, align 8, !noalias !3
  %.116.i.i.i = load double, ptr %1, align 8, !noalias !6
  %.146.i.i.i = load double, ptr %.145.i.i.i, align 8, !noalias !6
  %.176.i.i.i = load double, ptr %.792.i, align 8, !noalias !6
  %.177.i.i.i = fmul contract double %.146.i.i.i, %.176.i.i.i
  %.178.i.i.i = fadd contract double %.116.i.i.i, %.177.i.i.i
  %.208.i.i.i = load double, ptr %.717.i, align 8, !noalias !6
  %.209.i.i.i = fsub contract double %.178.i.i.i, %.208.i.i.i
  %.215.i.i.i = tail call contract double @llvm.fma.f64(double %.209.i.i.i, double 0x3FE45F306DC9C883, double 0x4338000000000000)
  %.216.i.i.i = fadd contract double %.215.i.i.i, 0xC338000000000000
  %.231.i.i.i = tail call contract double @llvm.fma.f64(double %.216.i.i.i, double 0xBFF921FB54442D18, double %.209.i.i.i)
  %.246.i.i.i = tail call contract double @llvm.fma.f64(double %.216.i.i.i, double 0xBC91A62633145C07, double %.231.i.i.i)
  %.247.i.i.i = fmul contract double %.246.i.i.i, %.246.i.i.i
  %.248.i.i.i = tail call contract double @llvm.fma.f64(double %.247.i.i.i, double 0xBD6AE7F3E733B81F, double 0x3DE6124613A86D09)
  %.249.i.i.i = tail call contract double @llvm.fma.f64(double %.247.i.i.i, double %.248.i.i.i, double 0xBE5AE64567F544E4)
  %.250.i.i.i = tail call contract double @llvm.fma.f64(double %.247.i.i.i, double %.249.i.i.i, double 0x3EC71DE3A556C734)
  %.251.i.i.i = tail call contract double @llvm.fma.f64(double %.247.i.i.i, double %.250.i.i.i, double 0xBF2A01A01A01A01A)
  %.252.i.i.i = tail call contract double @llvm.fma.f64(double %.247.i.i.i, double %.251.i.i.i, double 0x3F81111111111111)
  %.253.i.i.i = tail call contract double @llvm.fma.f64(double %.247.i.i.i, double %.252.i.i.i, double 0xBFC5555555555555)
  %.254.i.i.i = fmul contract double %.246.i.i.i, %.247.i.i.i
  %.255.i.i.i = tail call contract double @llvm.fma.f64(double %.254.i.i.i, double %.253.i.i.i, double %.246.i.i.i)
  %.256.i.i1.i = tail call contract double @llvm.fma.f64(double %.247.i.i.i, double 0x3D2AE7F3E733B81F, double 0xBDA93974A8C07C9D)
  %.257.i.i.i = tail call contract double @llvm.fma.f64(double %.247.i.i.i, double %.256.i.i1.i, double 0x3E21EED8EFF8D898)
  %.258.i.i.i = tail call contract double @llvm.fma.f64(double %.247.i.i.i, double %.257.i.i.i, double 0xBE927E4FB7789F5C)
  %.259.i.i.i = tail call contract double @llvm.fma.f64(double %.247.i.i.i, double %.258.i.i.i, double 0x3EFA01A01A01A01A)
  %.260.i.i.i = tail call contract double @llvm.fma.f64(double %.247.i.i.i, double %.259.i.i.i, double 0xBF56C16C16C16C17)
  %.261.i.i.i = tail call contract double @llvm.fma.f64(double %.247.i.i.i, double %.260.i.i.i, double 0x3FA5555555555555)
  %.262.i.i.i = tail call contract double @llvm.fma.f64(double %.247.i.i.i, double %.261.i.i.i, double -5.000000e-01)
  %.263.i.i.i = tail call contract double @llvm.fma.f64(double %.247.i.i.i, double %.262.i.i.i, double 1.000000e+00)
  %.264.i.i.i = bitcast double %.215.i.i.i to i64
  %.265.i.i.i = bitcast double %.255.i.i.i to i64
  %.266.i.i.i = bitcast double %.263.i.i.i to i64
  %.267.i.i2.i = xor i64 %.266.i.i.i, %.265.i.i.i
  %.268.i.i.i = and i64 %.264.i.i.i, 1
  %5 = icmp eq i64 %.268.i.i.i, 0
  %.270.i.i.i = select i1 %5, i64 0, i64 %.267.i.i2.i
  %.271.i.i.i = shl i64 %.264.i.i.i, 62
  %.272.i.i.i = and i64 %.271.i.i.i, -9223372036854775808
  %.274.i.i.i = add i64 %.271.i.i.i, 4611686018427387904
  %.275.i.i.i = and i64 %.274.i.i.i, -9223372036854775808
  %6 = xor i64 %.272.i.i.i, %.265.i.i.i
  %.277.i.i.i = xor i64 %6, %.270.i.i.i
  %.278.i.i3.i = bitcast i64 %.277.i.i.i to double
  %7 = xor i64 %.275.i.i.i, %.266.i.i.i
  %.280.i.i.i = xor i64 %7, %.270.i.i.i
  %.281.i.i.i = bitcast i64 %.280.i.i.i to double
  %.346.i.i.i = load double, ptr %.345.i.i.i, align 8, !noalias !6
  %.347.i.i.i = tail call contract double @llvm.fma.f64(double %.346.i.i.i, double 0x3FE45F306DC9C883, double 0x4338000000000000)
  %.348.i.i.i = fadd contract double %.347.i.i.i, 0xC338000000000000
  %.363.i.i.i = tail call contract double @llvm.fma.f64(double %.348.i.i.i, double 0xBFF921FB54442D18, double %.346.i.i.i)
  %.378.i.i.i = tail call contract double @llvm.fma.f64(double %.348.i.i.i, double 0xBC91A62633145C07, double %.363.i.i.i)
  %.379.i.i.i = fmul contract double %.378.i.i.i, %.378.i.i.i
  %.380.i.i.i = tail call contract double @llvm.fma.f64(double %.379.i.i.i, double 0xBD6AE7F3E733B81F, double 0x3DE6124613A86D09)
  %.381.i.i.i = tail call contract double @llvm.fma.f64(double %.379.i.i.i, double %.380.i.i.i, double 0xBE5AE64567F544E4)
  %.382.i.i.i = tail call contract double @llvm.fma.f64(double %.379.i.i.i, double %.381.i.i.i, double 0x3EC71DE3A556C734)
  %.383.i.i.i = tail call contract double @llvm.fma.f64(double %.379.i.i.i, double %.382.i.i.i, double 0xBF2A01A01A01A01A)
  %.384.i.i.i = tail call contract double @llvm.fma.f64(double %.379.i.i.i, double %.383.i.i.i, double 0x3F81111111111111)
  %.385.i.i.i = tail call contract double @llvm.fma.f64(double %.379.i.i.i, double %.384.i.i.i, double 0xBFC5555555555555)
  %.386.i.i.i = fmul contract double %.378.i.i.i, %.379.i.i.i
  %.387.i.i.i = tail call contract double @llvm.fma.f64(double %.386.i.i.i, double %.385.i.i.i, double %.378.i.i.i)
  %.388.i.i.i = tail call contract double @llvm.fma.f64(double %.379.i.i.i, double 0x3D2AE7F3E733B81F, double 0xBDA93974A8C07C9D)
  %.389.i.i.i = tail call contract double @llvm.fma.f64(double %.379.i.i.i, double %.388.i.i.i, double 0x3E21EED8EFF8D898)
  %.390.i.i.i = tail call contract double @llvm.fma.f64(double %.379.i.i.i, double %.389.i.i.i, double 0xBE927E4FB7789F5C)
  %.391.i.i.i = tail call contract double @llvm.fma.f64(double %.379.i.i.i, double %.390.i.i.i, double 0x3EFA01A01A01A01A)
  %.392.i.i.i = tail call contract double @llvm.fma.f64(double %.379.i.i.i, double %.391.i.i.i, double 0xBF56C16C16C16C17)
  %.393.i.i.i = tail call contract double @llvm.fma.f64(double %.379.i.i.i, double %.392.i.i.i, double 0x3FA5555555555555)
  %.394.i.i.i = tail call contract double @llvm.fma.f64(double %.379.i.i.i, double %.393.i.i.i, double -5.000000e-01)
  %.395.i.i.i = tail call contract double @llvm.fma.f64(double %.379.i.i.i, double %.394.i.i.i, double 1.000000e+00)
  %.396.i.i.i = bitcast double %.347.i.i.i to i64
  %.397.i.i.i = bitcast double %.387.i.i.i to i64
  %.398.i.i.i = bitcast double %.395.i.i.i to i64
  %.399.i.i.i = xor i64 %.398.i.i.i, %.397.i.i.i
  %.400.i.i.i = and i64 %.396.i.i.i, 1
  %8 = icmp eq i64 %.400.i.i.i, 0
  %.402.i.i.i = select i1 %8, i64 0, i64 %.399.i.i.i
  %.403.i.i.i = shl i64 %.396.i.i.i, 62
  %.404.i.i.i = and i64 %.403.i.i.i, -9223372036854775808
  %.406.i.i.i = add i64 %.403.i.i.i, 4611686018427387904
  %.407.i.i.i = and i64 %.406.i.i.i, -9223372036854775808
  %9 = xor i64 %.404.i.i.i, %.397.i.i.i
  %.409.i.i.i = xor i64 %9, %.402.i.i.i
  %.410.i.i.i = bitcast i64 %.409.i.i.i to double
  %10 = xor i64 %.407.i.i.i, %.398.i.i.i
  %.412.i.i.i = xor i64 %10, %.402.i.i.i
  %.413.i.i.i = bitcast i64 %.412.i.i.i to double
  %.468.i.i.i = load double, ptr %.469.i.i, align 8, !noalias !6
  %.496.i.i.i = getelementptr i8, ptr %.469.i.i, i64 8
  %.497.i.i.i = load double, ptr %.496.i.i.i, align 8, !noalias !6
  %.525.i.i.i = getelementptr i8, ptr %.469.i.i, i64 16
  %.526.i.i.i = load double, ptr %.525.i.i.i, align 8, !noalias !6
  %.542.i.i.i = icmp eq i64 %.691.i.i, 1
  br i1 %.542.i.i.i, label %B276.i.i.i, label %_ZN17bnserve_inference13moving_kernel9_response12coefficientsB3v21B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i.i

B276.i.i.i:                                       ; preds = %B232.if.i.i
  %.547.i.i.i = fmul contract double %.468.i.i.i, %.281.i.i.i
  %.553.i.i.i = fmul contract double %.497.i.i.i, %.278.i.i3.i
  %.556.i.i.i = fsub contract double %.547.i.i.i, %.553.i.i.i
  %.558.i.i.i = fmul contract double %.556.i.i.i, %.413.i.i.i
  %.562.i.i.i = fmul contract double %.526.i.i.i, %.410.i.i.i
  %.563.i.i.i = fadd contract double %.562.i.i.i, %.558.i.i.i
  %.568.i.i.i = fdiv contract double %.563.i.i.i, 0x41B1DE784A000000
  %.605.i.i.i = fmul contract double %.146.i.i.i, %.568.i.i.i
  %11 = fsub contract double %.209.i.i.i, %.605.i.i.i
  %.610.i.i.i = tail call contract double @llvm.fma.f64(double %11, double 0x3FE45F306DC9C883, double 0x4338000000000000)
  %.611.i.i.i = fadd contract double %.610.i.i.i, 0xC338000000000000
  %.626.i.i.i = tail call contract double @llvm.fma.f64(double %.611.i.i.i, double 0xBFF921FB54442D18, double %11)
  %.641.i.i.i = tail call contract double @llvm.fma.f64(double %.611.i.i.i, double 0xBC91A62633145C07, double %.626.i.i.i)
  %.642.i.i.i = fmul contract double %.641.i.i.i, %.641.i.i.i
  %.643.i.i.i = tail call contract double @llvm.fma.f64(double %.642.i.i.i, double 0xBD6AE7F3E733B81F, double 0x3DE6124613A86D09)
  %.644.i.i.i = tail call contract double @llvm.fma.f64(double %.642.i.i.i, double %.643.i.i.i, double 0xBE5AE64567F544E4)
  %.645.i.i.i = tail call contract double @llvm.fma.f64(double %.642.i.i.i, double %.644.i.i.i, double 0x3EC71DE3A556C734)
  %.646.i.i.i = tail call contract double @llvm.fma.f64(double %.642.i.i.i, double %.645.i.i.i, double 0xBF2A01A01A01A01A)
  %.647.i.i.i = tail call contract double @llvm.fma.f64(double %.642.i.i.i, double %.646.i.i.i, double 0x3F81111111111111)
  %.648.i.i.i = tail call contract double @llvm.fma.f64(double %.642.i.i.i, double %.647.i.i.i, double 0xBFC5555555555555)
  %.649.i.i.i = fmul contract double %.641.i.i.i, %.642.i.i.i
  %.650.i.i.i = tail call contract double @llvm.fma.f64(double %.649.i.i.i, double %.648.i.i.i, double %.641.i.i.i)
  %.651.i.i.i = tail call contract double @llvm.fma.f64(double %.642.i.i.i, double 0x3D2AE7F3E733B81F, double 0xBDA93974A8C07C9D)
  %.652.i.i.i = tail call contract double @llvm.fma.f64(double %.642.i.i.i, double %.651.i.i.i, double 0x3E21EED8EFF8D898)
  %.653.i.i.i = tail call contract double @llvm.fma.f64(double %.642.i.i.i, double %.652.i.i.i, double 0xBE927E4FB7789F5C)
  %.654.i.i.i = tail call contract double @llvm.fma.f64(double %.642.i.i.i, double %.653.i.i.i, double 0x3EFA01A01A01A01A)
  %.655.i.i.i = tail call contract double @llvm.fma.f64(double %.642.i.i.i, double %.654.i.i.i, double 0xBF56C16C16C16C17)
  %.656.i.i.i = tail call contract double @llvm.fma.f64(double %.642.i.i.i, double %.655.i.i.i, double 0x3FA5555555555555)
  %.657.i.i.i = tail call contract double @llvm.fma.f64(double %.642.i.i.i, double %.656.i.i.i, double -5.000000e-01)
  %.658.i.i.i = tail call contract double @llvm.fma.f64(double %.642.i.i.i, double %.657.i.i.i, double 1.000000e+00)
  %.659.i.i.i = bitcast double %.610.i.i.i to i64
  %.660.i.i.i = bitcast double %.650.i.i.i to i64
  %.661.i.i.i = bitcast double %.658.i.i.i to i64
  %.662.i.i.i = xor i64 %.661.i.i.i, %.660.i.i.i
  %.663.i.i.i = and i64 %.659.i.i.i, 1
  %12 = icmp eq i64 %.663.i.i.i, 0
  %.665.i.i.i = select i1 %12, i64 0, i64 %.662.i.i.i
  %.666.i.i.i = shl i64 %.659.i.i.i, 62
  %.667.i.i.i = and i64 %.666.i.i.i, -9223372036854775808
  %.669.i.i.i = add i64 %.666.i.i.i, 4611686018427387904
  %.670.i.i.i = and i64 %.669.i.i.i, -9223372036854775808
  %13 = xor i64 %.667.i.i.i, %.660.i.i.i
  %.672.i.i.i = xor i64 %13, %.665.i.i.i
  %.673.i.i.i = bitcast i64 %.672.i.i.i to double
  %14 = xor i64 %.670.i.i.i, %.661.i.i.i
  %.675.i.i.i = xor i64 %14, %.665.i.i.i
  %.676.i.i.i = bitcast i64 %.675.i.i.i to double
  br label %_ZN17bnserve_inference13moving_kernel9_response12coefficientsB3v21B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i.i

_ZN17bnserve_inference13moving_kernel9_response12coefficientsB3v21B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i.i: ; preds = %B276.i.i.i, %B232.if.i.i
  %sin_h.2.0.i.i.i = phi double [ %.673.i.i.i, %B276.i.i.i ], [ %.278.i.i3.i, %B232.if.i.i ]
  %cos_h.2.0.i.i.i = phi double [ %.676.i.i.i, %B276.i.i.i ], [ %.281.i.i.i, %B232.if.i.i ]
  %.775.i.i.i = fmul contract double %.468.i.i.i, %cos_h.2.0.i.i.i
  %15 = fmul contract double %.497.i.i.i, %sin_h.2.0.i.i.i
  %.779.i.i.i = fsub contract double %.775.i.i.i, %15
  %.788.i.i.i = fmul contract double %.526.i.i.i, 0.000000e+00
  %.789.i.i.i = fadd contract double %.788.i.i.i, %.779.i.i.i
  %.791.i.i.i = fmul contract double %.789.i.i.i, %.413.i.i.i
  %.795.i.i.i = fmul contract double %.526.i.i.i, %.410.i.i.i
  %.796.i.i.i = fadd contract double %.795.i.i.i, %.791.i.i.i
  %.801.i.i.i = fdiv contract double %.796.i.i.i, 0xC1B1DE784A000000
  store double %.801.i.i.i, ptr %lsr.iv.i.i, align 8, !noalias !6
  %.863.i.i.i = fdiv contract double %.791.i.i.i, 0x41B1DE784A000000
  %.892.i.i.i = getelementptr i8, ptr %lsr.iv.i.i, i64 88
  store double %.863.i.i.i, ptr %.892.i.i.i, align 8, !noalias !6
  %.910.i.i.i = fmul contract double %.468.i.i.i, %sin_h.2.0.i.i.i
  %.913.i.i.i = fmul contract double %.497.i.i.i, %cos_h.2.0.i.i.i
  %.914.i.i.i = fadd contract double %.910.i.i.i, %.913.i.i.i
  %.924.i.i.i = fadd contract double %.788.i.i.i, %.914.i.i.i
  %.926.i.i.i = fmul contract double %.924.i.i.i, %.413.i.i.i
  %.930.i.i.i = fdiv contract double %.926.i.i.i, 0x41B1DE784A000000
  %.959.i.i.i = getelementptr i8, ptr %lsr.iv.i.i, i64 96
  store double %.930.i.i.i, ptr %.959.i.i.i, align 8, !noalias !6
  %.998.i.i.i = load double, ptr %.388.i.i, align 8, !noalias !6
  %.1000.i.i.i = fmul contract double %cos_h.2.0.i.i.i, %.998.i.i.i
  %.1028.i.i.i = getelementptr i8, ptr %.388.i.i, i64 8
  %.1029.i.i.i = load double, ptr %.1028.i.i.i, align 8, !noalias !6
  %16 = fmul contract double %sin_h.2.0.i.i.i, %.1029.i.i.i
  %.1032.i.i.i = fsub contract double %.1000.i.i.i, %16
  %.1060.i.i.i = getelementptr i8, ptr %.388.i.i, i64 16
  %.1061.i.i.i = load double, ptr %.1060.i.i.i, align 8, !noalias !6
  %.1063.i.i.i = fmul contract double %.1061.i.i.i, 0.000000e+00
  %.1064.i.i.i = fadd contract double %.1032.i.i.i, %.1063.i.i.i
  %.1092.i.i.i = getelementptr i8, ptr %.388.i.i, i64 24
  %.1093.i.i.i = load double, ptr %.1092.i.i.i, align 8, !noalias !6
  %.1095.i.i.i = fmul contract double %cos_h.2.0.i.i.i, %.1093.i.i.i
  %.1123.i.i.i = getelementptr i8, ptr %.388.i.i, i64 32
  %.1124.i.i.i = load double, ptr %.1123.i.i.i, align 8, !noalias !6
  %17 = fmul contract double %sin_h.2.0.i.i.i, %.1124.i.i.i
  %.1127.i.i.i = fsub contract double %.1095.i.i.i, %17
  %.1155.i.i.i = getelementptr i8, ptr %.388.i.i, i64 40
  %.1156.i.i.i = load double, ptr %.1155.i.i.i, align 8, !noalias !6
  %.1158.i.i.i = fmul contract double %.1156.i.i.i, 0.000000e+00
  %.1159.i.i.i = fadd contract double %.1127.i.i.i, %.1158.i.i.i
  %.1187.i.i.i = getelementptr i8, ptr %.388.i.i, i64 48
  %.1188.i.i.i = load double, ptr %.1187.i.i.i, align 8, !noalias !6
  %.1190.i.i.i = fmul contract double %cos_h.2.0.i.i.i, %.1188.i.i.i
  %.1218.i.i.i = getelementptr i8, ptr %.388.i.i, i64 56
  %.1219.i.i.i = load double, ptr %.1218.i.i.i, align 8, !noalias !6
  %18 = fmul contract double %sin_h.2.0.i.i.i, %.1219.i.i.i
  %.1222.i.i.i = fsub contract double %.1190.i.i.i, %18
  %.1250.i.i.i = getelementptr i8, ptr %.388.i.i, i64 64
  %.1251.i.i.i = load double, ptr %.1250.i.i.i, align 8, !noalias !6
  %.1259.i.i.i = fmul contract double %.1251.i.i.i, 0.000000e+00
  %.1260.i.i.i = fadd contract double %.1222.i.i.i, %.1259.i.i.i
  %.1318.i.i.i = fmul contract double %sin_h.2.0.i.i.i, %.998.i.i.i
  %.1349.i.i.i = fmul contract double %cos_h.2.0.i.i.i, %.1029.i.i.i
  %.1350.i.i.i = fadd contract double %.1318.i.i.i, %.1349.i.i.i
  %.1382.i.i.i = fadd contract double %.1350.i.i.i, %.1063.i.i.i
  %.1413.i.i.i = fmul contract double %sin_h.2.0.i.i.i, %.1093.i.i.i
  %.1444.i.i.i = fmul contract double %cos_h.2.0.i.i.i, %.1124.i.i.i
  %.1445.i.i.i = fadd contract double %.1413.i.i.i, %.1444.i.i.i
  %.1477.i.i.i = fadd contract double %.1445.i.i.i, %.1158.i.i.i
  %.1508.i.i.i = fmul contract double %sin_h.2.0.i.i.i, %.1188.i.i.i
  %.1539.i.i.i = fmul contract double %cos_h.2.0.i.i.i, %.1219.i.i.i
  %.1540.i.i.i = fadd contract double %.1508.i.i.i, %.1539.i.i.i
  %.1578.i.i.i = fadd contract double %.1540.i.i.i, %.1259.i.i.i
  %.1643.i.i.i = fmul contract double %.998.i.i.i, 0.000000e+00
  %.1674.i.i.i = fmul contract double %.1029.i.i.i, 0.000000e+00
  %.1675.i.i.i = fadd contract double %.1643.i.i.i, %.1674.i.i.i
  %.1707.i.i.i = fadd contract double %.1061.i.i.i, %.1675.i.i.i
  %.1738.i.i.i = fmul contract double %.1093.i.i.i, 0.000000e+00
  %.1769.i.i.i = fmul contract double %.1124.i.i.i, 0.000000e+00
  %.1770.i.i.i = fadd contract double %.1738.i.i.i, %.1769.i.i.i
  %.1802.i.i.i = fadd contract double %.1156.i.i.i, %.1770.i.i.i
  %.1833.i.i.i = fmul contract double %.1188.i.i.i, 0.000000e+00
  %.1864.i.i.i = fmul contract double %.1219.i.i.i, 0.000000e+00
  %.1865.i.i.i = fadd contract double %.1833.i.i.i, %.1864.i.i.i
  %.1903.i.i.i = fadd contract double %.1251.i.i.i, %.1865.i.i.i
  %.1947.i.i.i = fmul contract double %cos_h.2.0.i.i.i, %.1064.i.i.i
  %19 = fmul contract double %sin_h.2.0.i.i.i, %.1159.i.i.i
  %.1951.i.i.i = fsub contract double %.1947.i.i.i, %19
  %.1960.i.i.i = fmul contract double %.1260.i.i.i, 0.000000e+00
  %.1961.i.i.i = fadd contract double %.1951.i.i.i, %.1960.i.i.i
  %.1972.i.i.i = fmul contract double %cos_h.2.0.i.i.i, %.1382.i.i.i
  %20 = fmul contract double %sin_h.2.0.i.i.i, %.1477.i.i.i
  %.1976.i.i.i = fsub contract double %.1972.i.i.i, %20
  %.1985.i.i.i = fmul contract double %.1578.i.i.i, 0.000000e+00
  %.1986.i.i.i = fadd contract double %.1976.i.i.i, %.1985.i.i.i
  %.2000.i.i.i = fmul contract double %sin_h.2.0.i.i.i, %.1382.i.i.i
  %.2003.i.i.i = fmul contract double %cos_h.2.0.i.i.i, %.1477.i.i.i
  %.2004.i.i.i = fadd contract double %.2000.i.i.i, %.2003.i.i.i
  %.2014.i.i.i = fadd contract double %.2004.i.i.i, %.1985.i.i.i
  %.2025.i.i.i = fmul contract double %cos_h.2.0.i.i.i, %.1707.i.i.i
  %21 = fmul contract double %sin_h.2.0.i.i.i, %.1802.i.i.i
  %.2029.i.i.i = fsub contract double %.2025.i.i.i, %21
  %.2038.i.i.i = fmul contract double %.1903.i.i.i, 0.000000e+00
  %.2039.i.i.i = fadd contract double %.2029.i.i.i, %.2038.i.i.i
  %.2050.i.i.i = fmul contract double %sin_h.2.0.i.i.i, %.1707.i.i.i
  %.2053.i.i.i = fmul contract double %cos_h.2.0.i.i.i, %.1802.i.i.i
  %.2054.i.i.i = fadd contract double %.2050.i.i.i, %.2053.i.i.i
  %.2064.i.i.i = fadd contract double %.2054.i.i.i, %.2038.i.i.i
  %.2069.i.i.i = fadd contract double %.1961.i.i.i, %.2014.i.i.i
  %.2070.i.i.i = fmul contract double %.2069.i.i.i, 5.000000e-01
  %.2071.i.i.i = fsub contract double %.2014.i.i.i, %.1961.i.i.i
  %.2072.i.i.i = fmul contract double %.2071.i.i.i, 5.000000e-01
  %.2103.i.i.i = load double, ptr %.2102.i.i.i, align 8, !noalias !6
  %.2109.i.i.i = fmul contract double %.2103.i.i.i, 2.000000e+00
  %.2110.i.i.i = tail call contract double @llvm.fma.f64(double %.2109.i.i.i, double 0x3FE45F306DC9C883, double 0x4338000000000000)
  %.2111.i.i.i = fadd contract double %.2110.i.i.i, 0xC338000000000000
  %.2126.i.i.i = tail call contract double @llvm.fma.f64(double %.2111.i.i.i, double 0xBFF921FB54442D18, double %.2109.i.i.i)
  %.2141.i.i.i = tail call contract double @llvm.fma.f64(double %.2111.i.i.i, double 0xBC91A62633145C07, double %.2126.i.i.i)
  %.2142.i.i.i = fmul contract double %.2141.i.i.i, %.2141.i.i.i
  %.2143.i.i.i = tail call contract double @llvm.fma.f64(double %.2142.i.i.i, double 0xBD6AE7F3E733B81F, double 0x3DE6124613A86D09)
  %.2144.i.i.i = tail call contract double @llvm.fma.f64(double %.2142.i.i.i, double %.2143.i.i.i, double 0xBE5AE64567F544E4)
  %.2145.i.i.i = tail call contract double @llvm.fma.f64(double %.2142.i.i.i, double %.2144.i.i.i, double 0x3EC71DE3A556C734)
  %.2146.i.i.i = tail call contract double @llvm.fma.f64(double %.2142.i.i.i, double %.2145.i.i.i, double 0xBF2A01A01A01A01A)
  %.2147.i.i.i = tail call contract double @llvm.fma.f64(double %.2142.i.i.i, double %.2146.i.i.i, double 0x3F81111111111111)
  %.2148.i.i.i = tail call contract double @llvm.fma.f64(double %.2142.i.i.i, double %.2147.i.i.i, double 0xBFC5555555555555)
  %.2149.i.i.i = fmul contract double %.2141.i.i.i, %.2142.i.i.i
  %.2150.i.i.i = tail call contract double @llvm.fma.f64(double %.2149.i.i.i, double %.2148.i.i.i, double %.2141.i.i.i)
  %.2151.i.i.i = tail call contract double @llvm.fma.f64(double %.2142.i.i.i, double 0x3D2AE7F3E733B81F, double 0xBDA93974A8C07C9D)
  %.2152.i.i.i = tail call contract double @llvm.fma.f64(double %.2142.i.i.i, double %.2151.i.i.i, double 0x3E21EED8EFF8D898)
  %.2153.i.i.i = tail call contract double @llvm.fma.f64(double %.2142.i.i.i, double %.2152.i.i.i, double 0xBE927E4FB7789F5C)
  %.2154.i.i.i = tail call contract double @llvm.fma.f64(double %.2142.i.i.i, double %.2153.i.i.i, double 0x3EFA01A01A01A01A)
  %.2155.i.i.i = tail call contract double @llvm.fma.f64(double %.2142.i.i.i, double %.2154.i.i.i, double 0xBF56C16C16C16C17)
  %.2156.i.i.i = tail call contract double @llvm.fma.f64(double %.2142.i.i.i, double %.2155.i.i.i, double 0x3FA5555555555555)
  %.2157.i.i.i = tail call contract double @llvm.fma.f64(double %.2142.i.i.i, double %.2156.i.i.i, double -5.000000e-01)
  %.2158.i.i.i = tail call contract double @llvm.fma.f64(double %.2142.i.i.i, double %.2157.i.i.i, double 1.000000e+00)
  %.2159.i.i.i = bitcast double %.2110.i.i.i to i64
  %.2160.i.i.i = bitcast double %.2150.i.i.i to i64
  %.2161.i.i.i = bitcast double %.2158.i.i.i to i64
  %.2162.i.i.i = xor i64 %.2161.i.i.i, %.2160.i.i.i
  %.2163.i.i.i = and i64 %.2159.i.i.i, 1
  %22 = icmp eq i64 %.2163.i.i.i, 0
  %.2165.i.i.i = select i1 %22, i64 0, i64 %.2162.i.i.i
  %.2166.i.i.i = shl i64 %.2159.i.i.i, 62
  %.2167.i.i.i = and i64 %.2166.i.i.i, -9223372036854775808
  %.2169.i.i.i = add i64 %.2166.i.i.i, 4611686018427387904
  %.2170.i.i.i = and i64 %.2169.i.i.i, -9223372036854775808
  %23 = xor i64 %.2167.i.i.i, %.2160.i.i.i
  %.2172.i.i.i = xor i64 %23, %.2165.i.i.i
  %.2173.i.i.i = bitcast i64 %.2172.i.i.i to double
  %24 = xor i64 %.2170.i.i.i, %.2161.i.i.i
  %.2175.i.i.i = xor i64 %24, %.2165.i.i.i
  %.2176.i.i.i = bitcast i64 %.2175.i.i.i to double
  %.2204.i.i.i = fmul contract double %.2070.i.i.i, %.413.i.i.i
  %.2206.i.i.i = fmul contract double %.2204.i.i.i, %.413.i.i.i
  %.2209.i.i.i = fmul contract double %.413.i.i.i, %.413.i.i.i
  %.2210.i.i.i = fmul contract double %.2209.i.i.i, %.1903.i.i.i
  %.2211.i.i.i = fsub contract double %.2206.i.i.i, %.2210.i.i.i
  %.2213.i.i.i = fmul contract double %.410.i.i.i, 2.000000e+00
  %.2215.i.i.i = fmul contract double %.2213.i.i.i, %.413.i.i.i
  %.2216.i.i.i = fmul contract double %.2215.i.i.i, %.2039.i.i.i
  %.2218.i.i.i = fmul contract double %.410.i.i.i, -2.000000e+00
  %.2220.i.i.i = fmul contract double %.2218.i.i.i, %.413.i.i.i
  %.2221.i.i.i = fmul contract double %.2220.i.i.i, %.2064.i.i.i
  %.2224.i.i.i = fmul contract double %.410.i.i.i, %.410.i.i.i
  %.2225.i.i.i = fadd contract double %.2224.i.i.i, 1.000000e+00
  %.2226.i.i.i = fmul contract double %.2225.i.i.i, %.2072.i.i.i
  %.2231.i.i.i = fmul contract double %.2225.i.i.i, %.1986.i.i.i
  %.2251.i.i.i = fmul contract double %.413.i.i.i, -2.000000e+00
  %.2252.i.i.i = fmul contract double %.2251.i.i.i, %.2064.i.i.i
  %.2255.i.i.i = fmul contract double %.2251.i.i.i, %.2039.i.i.i
  %.2258.i.i.i = fmul contract double %.2213.i.i.i, %.1986.i.i.i
  %.2261.i.i.i = fmul contract double %.2218.i.i.i, %.2072.i.i.i
  %.2418.i.i.i = fmul contract double %.2211.i.i.i, %.2176.i.i.i
  %.2438.i.i.i = fmul contract double %.2173.i.i.i, 0.000000e+00
  %.2439.i.i.i = fadd contract double %.2418.i.i.i, %.2438.i.i.i
  %25 = getelementptr i8, ptr %lsr.iv.i.i, i64 8
  store double %.2439.i.i.i, ptr %25, align 8, !noalias !6
  %.2490.i.i.i = fmul contract double %.2176.i.i.i, 0.000000e+00
  %.2510.i.i.i = fmul contract double %.2211.i.i.i, %.2173.i.i.i
  %.2511.i.i.i = fsub contract double %.2490.i.i.i, %.2510.i.i.i
  %26 = getelementptr i8, ptr %lsr.iv.i.i, i64 48
  store double %.2511.i.i.i, ptr %26, align 8, !noalias !6
  %.2418.1.i.i.i = fmul contract double %.2216.i.i.i, %.2176.i.i.i
  %.2438.1.i.i.i = fmul contract double %.2252.i.i.i, %.2173.i.i.i
  %.2439.1.i.i.i = fadd contract double %.2418.1.i.i.i, %.2438.1.i.i.i
  %27 = getelementptr i8, ptr %lsr.iv.i.i, i64 16
  store double %.2439.1.i.i.i, ptr %27, align 8, !noalias !6
  %.2490.1.i.i.i = fmul contract double %.2252.i.i.i, %.2176.i.i.i
  %.2510.1.i.i.i = fmul contract double %.2216.i.i.i, %.2173.i.i.i
  %.2511.1.i.i.i = fsub contract double %.2490.1.i.i.i, %.2510.1.i.i.i
  %28 = getelementptr i8, ptr %lsr.iv.i.i, i64 56
  store double %.2511.1.i.i.i, ptr %28, align 8, !noalias !6
  %.2418.2.i.i.i = fmul contract double %.2221.i.i.i, %.2176.i.i.i
  %.2438.2.i.i.i = fmul contract double %.2255.i.i.i, %.2173.i.i.i
  %.2439.2.i.i.i = fadd contract double %.2418.2.i.i.i, %.2438.2.i.i.i
  %29 = getelementptr i8, ptr %lsr.iv.i.i, i64 24
  store double %.2439.2.i.i.i, ptr %29, align 8, !noalias !6
  %.2490.2.i.i.i = fmul contract double %.2255.i.i.i, %.2176.i.i.i
  %.2510.2.i.i.i = fmul contract double %.2221.i.i.i, %.2173.i.i.i
  %.2511.2.i.i.i = fsub contract double %.2490.2.i.i.i, %.2510.2.i.i.i
  %30 = getelementptr i8, ptr %lsr.iv.i.i, i64 64
  store double %.2511.2.i.i.i, ptr %30, align 8, !noalias !6
  %.2418.3.i.i.i = fmul contract double %.2226.i.i.i, %.2176.i.i.i
  %.2438.3.i.i.i = fmul contract double %.2258.i.i.i, %.2173.i.i.i
  %.2439.3.i.i.i = fadd contract double %.2418.3.i.i.i, %.2438.3.i.i.i
  %31 = getelementptr i8, ptr %lsr.iv.i.i, i64 32
  store double %.2439.3.i.i.i, ptr %31, align 8, !noalias !6
  %.2490.3.i.i.i = fmul contract double %.2258.i.i.i, %.2176.i.i.i
  %.2510.3.i.i.i = fmul contract double %.2226.i.i.i, %.2173.i.i.i
  %.2511.3.i.i.i = fsub contract double %.2490.3.i.i.i, %.2510.3.i.i.i
  %32 = getelementptr i8, ptr %lsr.iv.i.i, i64 72
  store double %.2511.3.i.i.i, ptr %32, align 8, !noalias !6
  %.2418.4.i.i.i = fmul contract double %.2231.i.i.i, %.2176.i.i.i
  %.2438.4.i.i.i = fmul contract double %.2261.i.i.i, %.2173.i.i.i
  %.2439.4.i.i.i = fadd contract double %.2418.4.i.i.i, %.2438.4.i.i.i
  %33 = getelementptr i8, ptr %lsr.iv.i.i, i64 40
  store double %.2439.4.i.i.i, ptr %33, align 8, !noalias !6
  %.2490.4.i.i.i = fmul contract double %.2261.i.i.i, %.2176.i.i.i
  %.2510.4.i.i.i = fmul contract double %.2231.i.i.i, %.2173.i.i.i
  %.2511.4.i.i.i = fsub contract double %.2490.4.i.i.i, %.2510.4.i.i.i
  %34 = getelementptr i8, ptr %lsr.iv.i.i, i64 80
  store double %.2511.4.i.i.i, ptr %34, align 8, !noalias !6
  %.2591.i.i.i = getelementptr i8, ptr %lsr.iv.i.i, i64 104
  store i64 %.2175.i.i.i, ptr %.2591.i.i.i, align 8, !noalias !6
  %.2624.i.i.i = getelementptr i8, ptr %lsr.iv.i.i, i64 112
  store i64 %.2172.i.i.i, ptr %.2624.i.i.i, align 8, !noalias !6
  %.2657.i.i.i = getelementptr i8, ptr %lsr.iv.i.i, i64 120
  store i64 %.412.i.i.i, ptr %.2657.i.i.i, align 8, !noalias !6
  %.2690.i.i.i = getelementptr i8, ptr %lsr.iv.i.i, i64 128
  store i64 %.409.i.i.i, ptr %.2690.i.i.i, align 8, !noalias !6
  %.2841.i.i.i = load double, ptr %.550.i.i, align 8, !noalias !6
  %35 = getelementptr i8, ptr %.550.i.i, i64 8
  %.2873.i.i.i = load double, ptr %35, align 8, !noalias !6
  %36 = getelementptr i8, ptr %.550.i.i, i64 16
  %.2905.i.i.i = load double, ptr %36, align 8, !noalias !6
  %.2929.i.i.i = fmul contract double %.2841.i.i.i, %.2841.i.i.i
  %.2932.i.i.i = fmul contract double %.2873.i.i.i, %.2873.i.i.i
  %.2933.i.i.i = fadd contract double %.2929.i.i.i, %.2932.i.i.i
  %.2942.i.i.i = fmul contract double %.2905.i.i.i, %.2905.i.i.i
  %.2943.i.i.i = fadd contract double %.2933.i.i.i, %.2942.i.i.i
  %.2951.i.i.i = tail call contract double @sqrt(double %.2943.i.i.i)
  %.2951.fr.i.i.i = freeze double %.2951.i.i.i
  %.2975.i.i.i = fcmp contract ogt double %.2951.fr.i.i.i, 0.000000e+00
  %.2981.i.i.i = fdiv contract double 1.000000e+00, %.2951.fr.i.i.i
  %"$phi1856.1.2.1.i.i.i" = select i1 %.2975.i.i.i, double %.2981.i.i.i, double 0.000000e+00
  %.3003.i.i.i = fmul contract double %cos_h.2.0.i.i.i, %.2841.i.i.i
  %37 = fmul contract double %sin_h.2.0.i.i.i, %.2873.i.i.i
  %.3007.i.i.i = fsub contract double %.3003.i.i.i, %37
  %.3016.i.i.i = fmul contract double %.2905.i.i.i, 0.000000e+00
  %.3017.i.i.i = fadd contract double %.3007.i.i.i, %.3016.i.i.i
  %.3018.i.i.i = fmul contract double %.3017.i.i.i, %"$phi1856.1.2.1.i.i.i"
  %.3030.i.i.i = fmul contract double %sin_h.2.0.i.i.i, %.2841.i.i.i
  %.3033.i.i.i = fmul contract double %cos_h.2.0.i.i.i, %.2873.i.i.i
  %.3034.i.i.i = fadd contract double %.3030.i.i.i, %.3033.i.i.i
  %.3044.i.i.i = fadd contract double %.3034.i.i.i, %.3016.i.i.i
  %.3045.i.i.i = fmul contract double %.3044.i.i.i, %"$phi1856.1.2.1.i.i.i"
  %.3075.i.i.i = getelementptr i8, ptr %lsr.iv.i.i, i64 136
  store double %.3018.i.i.i, ptr %.3075.i.i.i, align 8, !noalias !6
  %.3107.i.i.i = getelementptr i8, ptr %lsr.iv.i.i, i64 144
  store double %.3045.i.i.i, ptr %.3107.i.i.i, align 8, !noalias !6
  %.3116.i.i.i = fmul contract double %.2905.i.i.i, %"$phi1856.1.2.1.i.i.i"
  %.3121.i.i.i = fdiv contract double %.2951.fr.i.i.i, 0x41B1DE784A000000
  %.3154.i.i.i = getelementptr i8, ptr %lsr.iv.i.i, i64 152
  store double %.3116.i.i.i, ptr %.3154.i.i.i, align 8, !noalias !6
  %.3188.i.i.i = getelementptr i8, ptr %lsr.iv.i.i, i64 160
  store double %.3121.i.i.i, ptr %.3188.i.i.i, align 8, !noalias !6
  %38 = getelementptr i8, ptr %.550.i.i, i64 24
  %.2841.1.i.i.i = load double, ptr %38, align 8, !noalias !6
  %39 = getelementptr i8, ptr %.550.i.i, i64 32
  %.2873.1.i.i.i = load double, ptr %39, align 8, !noalias !6
  %40 = getelementptr i8, ptr %.550.i.i, i64 40
  %.2905.1.i.i.i = load double, ptr %40, align 8, !noalias !6
  %.2929.1.i.i.i = fmul contract double %.2841.1.i.i.i, %.2841.1.i.i.i
  %.2932.1.i.i.i = fmul contract double %.2873.1.i.i.i, %.2873.1.i.i.i
  %.2933.1.i.i.i = fadd contract double %.2929.1.i.i.i, %.2932.1.i.i.i
  %.2942.1.i.i.i = fmul contract double %.2905.1.i.i.i, %.2905.1.i.i.i
  %.2943.1.i.i.i = fadd contract double %.2933.1.i.i.i, %.2942.1.i.i.i
  %.2951.1.i.i.i = tail call contract double @sqrt(double %.2943.1.i.i.i)
  %.2951.1.fr.i.i.i = freeze double %.2951.1.i.i.i
  %.2975.1.i.i.i = fcmp contract ogt double %.2951.1.fr.i.i.i, 0.000000e+00
  %.2981.1.i.i.i = fdiv contract double 1.000000e+00, %.2951.1.fr.i.i.i
  %"$phi1856.1.2.1.1.i.i.i" = select i1 %.2975.1.i.i.i, double %.2981.1.i.i.i, double 0.000000e+00
  %.3003.1.i.i.i = fmul contract double %cos_h.2.0.i.i.i, %.2841.1.i.i.i
  %41 = fmul contract double %sin_h.2.0.i.i.i, %.2873.1.i.i.i
  %.3007.1.i.i.i = fsub contract double %.3003.1.i.i.i, %41
  %.3016.1.i.i.i = fmul contract double %.2905.1.i.i.i, 0.000000e+00
  %.3017.1.i.i.i = fadd contract double %.3007.1.i.i.i, %.3016.1.i.i.i
  %.3018.1.i.i.i = fmul contract double %.3017.1.i.i.i, %"$phi1856.1.2.1.1.i.i.i"
  %.3030.1.i.i.i = fmul contract double %sin_h.2.0.i.i.i, %.2841.1.i.i.i
  %.3033.1.i.i.i = fmul contract double %cos_h.2.0.i.i.i, %.2873.1.i.i.i
  %.3034.1.i.i.i = fadd contract double %.3030.1.i.i.i, %.3033.1.i.i.i
  %.3044.1.i.i.i = fadd contract double %.3034.1.i.i.i, %.3016.1.i.i.i
  %.3045.1.i.i.i = fmul contract double %.3044.1.i.i.i, %"$phi1856.1.2.1.1.i.i.i"
  %.3075.1.i.i.i = getelementptr i8, ptr %lsr.iv.i.i, i64 168
  store double %.3018.1.i.i.i, ptr %.3075.1.i.i.i, align 8, !noalias !6
  %.3107.1.i.i.i = getelementptr i8, ptr %lsr.iv.i.i, i64 176
  store double %.3045.1.i.i.i, ptr %.3107.1.i.i.i, align 8, !noalias !6
  %.3116.1.i.i.i = fmul contract double %.2905.1.i.i.i, %"$phi1856.1.2.1.1.i.i.i"
  %.3121.1.i.i.i = fdiv contract double %.2951.1.fr.i.i.i, 0x41B1DE784A000000
  %.3154.1.i.i.i = getelementptr i8, ptr %lsr.iv.i.i, i64 184
  store double %.3116.1.i.i.i, ptr %.3154.1.i.i.i, align 8, !noalias !6
  %.3188.1.i.i.i = getelementptr i8, ptr %lsr.iv.i.i, i64 192
  store double %.3121.1.i.i.i, ptr %.3188.1.i.i.i, align 8, !noalias !6
  %scevgep.i.i = getelementptr i8, ptr %lsr.iv.i.i, i64 200
  %lsr.iv.next.i.i = add i64 %lsr.iv100.i.i, 48
  %lsr.iv.next102.i.i = add i64 %lsr.iv101.i.i, 24
  %lsr.iv.next104.i.i = add i64 %lsr.iv103.i.i, 72
  %lsr.iv.next106.i.i = add nsw i64 %lsr.iv105.i.i, -1
  %exitcond.not.i4.i = icmp eq i64 %lsr.iv.next106.i.i, 0
  br i1 %exitcond.not.i4.i, label %_ZN17bnserve_inference13moving_kernel7_source6_placeB3v14B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i, label %B232.if.i.i

_ZN17bnserve_inference13moving_kernel7_source6_placeB3v14B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i: ; preds = %_ZN17bnserve_inference13moving_kernel9_response12coefficientsB3v21B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i.i, %B568.i
  %.50.i.i = load i64, ptr %.76.i, align 8, !noalias !9
  %.80.i.i = load i64, ptr %.106.i, align 8, !noalias !9
  %.110.i.i = load i64, ptr %.109.i.i, align 8, !noalias !9
  %.122.i.i = sub i64 0, %.80.i.i
  %.130.1.i.i = and i64 %.122.i.i, -8
  %.164.i.i = sub i64 0, %.130.1.i.i
  %.194.i.i = load i64, ptr %.193.i.i, align 8, !noalias !9
  %.228.i.i = load i64, ptr %.227.i.i, align 8, !noalias !9
  %.229.i.i = shl i64 %.631.sroa.0.073.i, 3
  %.231.i.i = mul i64 %.194.i.i, %.229.i.i
  %.232.i.i = add nsw i64 %.231.i.i, %.228.i.i
  %.293.i.i = icmp sgt i64 %.194.i.i, 0
  br i1 %.293.i.i, label %_ZN17bnserve_inference13moving_kernel8_passing12find_passingB3v40B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIxLi1E1C7mutable7alignedE.exit.i, label %B288.i.i

B288.i.i:                                         ; preds = %_ZN17bnserve_inference13moving_kernel7_source6_placeB3v14B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i
  %.725.i.i = load i64, ptr %.724.i.i, align 8, !noalias !9
  %.733.i.i = inttoptr i64 %.725.i.i to ptr
  %.858.i.i = getelementptr double, ptr %.733.i.i, i64 %.164.i.i
  %.10071199.not.i.i = icmp slt i64 %.50.i.i, 1
  br i1 %.10071199.not.i.i, label %_ZN17bnserve_inference13moving_kernel8_passing12find_passingB3v40B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIxLi1E1C7mutable7alignedE.exit.i, label %B766.if.lr.ph.i.i

B766.if.lr.ph.i.i:                                ; preds = %B288.i.i
  %.548.i.i = load i64, ptr %.547.i5.i, align 8, !noalias !9
  %.460.i.i = load i64, ptr %.459.i.i, align 8, !noalias !9
  %.362.i.i = load i64, ptr %.361.i.i, align 8, !noalias !9
  %.364.i.i = shl i64 %.631.sroa.0.073.i, 4
  %.366.i.i = mul i64 %.364.i.i, %.80.i.i
  %.368.i.i = mul i64 %.366.i.i, %.110.i.i
  %.371.i.i = add nsw i64 %.362.i.i, %.368.i.i
  %.637.i.i = load i64, ptr %.636.i.i, align 8, !noalias !9
  %42 = inttoptr i64 %.637.i.i to ptr
  %43 = inttoptr i64 %.232.i.i to ptr
  %.640.i.i = mul i64 %.50.i.i, %.164.i.i
  %.1125.i.i = getelementptr double, ptr %43, i64 %.640.i.i
  %44 = tail call i64 @llvm.smax.i64(i64 %.164.i.i, i64 0)
  %storemerge1090.i.i = lshr exact i64 %44, 3
  %45 = lshr i64 %.122.i.i, 3
  %46 = mul i64 %45, -64
  %47 = add nuw nsw i64 %storemerge1090.i.i, 3
  %48 = inttoptr i64 %.548.i.i to ptr
  %49 = inttoptr i64 %.460.i.i to ptr
  %50 = inttoptr i64 %.371.i.i to ptr
  %.146.i.i6.i = icmp slt i64 %.164.i.i, 1
  %51 = sub i64 7, %.130.1.i.i
  %.169.i.i.i = lshr i64 %51, 3
  %.1901286.not2107.i.i.i = icmp eq i64 %.169.i.i.i, 0
  %.1901286.not.i.i.i = or i1 %.146.i.i6.i, %.1901286.not2107.i.i.i
  %.258.i.i7.i = add i64 %.80.i.i, -1
  %.303.i.i.i = and i64 %.258.i.i7.i, -8
  %.3971410.not.i.i.i = icmp slt i64 %.110.i.i, 1
  %sunkaddr10.i8.i = getelementptr i8, ptr %.733.i.i, i64 8
  %sunkaddr11.i9.i = getelementptr i8, ptr %.858.i.i, i64 8
  %sunkaddr12.i10.i = getelementptr i8, ptr %.1125.i.i, i64 8
  %sunkaddr15.i.i = getelementptr i8, ptr %.733.i.i, i64 16
  %sunkaddr16.i.i = getelementptr i8, ptr %.858.i.i, i64 16
  %sunkaddr17.i.i = getelementptr i8, ptr %.1125.i.i, i64 16
  %sunkaddr23.i.i = getelementptr i8, ptr %.733.i.i, i64 24
  %sunkaddr27.i.i = getelementptr i8, ptr %.858.i.i, i64 24
  %sunkaddr31.i.i = getelementptr i8, ptr %.1125.i.i, i64 24
  %sunkaddr39.i.i = getelementptr i8, ptr %.733.i.i, i64 32
  %sunkaddr40.i.i = getelementptr i8, ptr %.858.i.i, i64 32
  %sunkaddr41.i.i = getelementptr i8, ptr %.1125.i.i, i64 32
  %sunkaddr43.i.i = getelementptr i8, ptr %.733.i.i, i64 40
  %sunkaddr44.i.i = getelementptr i8, ptr %.858.i.i, i64 40
  %sunkaddr45.i.i = getelementptr i8, ptr %.1125.i.i, i64 40
  %sunkaddr47.i.i = getelementptr i8, ptr %.733.i.i, i64 48
  %sunkaddr48.i.i = getelementptr i8, ptr %.858.i.i, i64 48
  %sunkaddr49.i.i = getelementptr i8, ptr %.1125.i.i, i64 48
  %sunkaddr51.i.i = getelementptr i8, ptr %.733.i.i, i64 56
  %sunkaddr52.i.i = getelementptr i8, ptr %.858.i.i, i64 56
  %sunkaddr53.i.i = getelementptr i8, ptr %.1125.i.i, i64 56
  %52 = add nsw i64 %.169.i.i.i, -1
  %xtraiter.i.i.i = and i64 %.169.i.i.i, 3
  %53 = icmp ult i64 %52, 3
  %54 = lshr i64 %51, 5
  %55 = mul nsw i64 %54, -4
  %lcmp.mod.not.i.i.i = icmp eq i64 %xtraiter.i.i.i, 0
  %56 = shl nuw nsw i64 %xtraiter.i.i.i, 6
  %.586.i.i.i = icmp slt i64 %.80.i.i, 9
  %.605.i.i11.i = ashr i64 %.258.i.i7.i, 3
  %storemerge785.i.i.i = select i1 %.586.i.i.i, i64 0, i64 %.605.i.i11.i
  %.1255.i.i.i = and i64 %.258.i.i7.i, 7
  %scevgep604.i.i.i = getelementptr i8, ptr %50, i64 16
  %57 = shl i64 %.80.i.i, 4
  %58 = shl i64 %.258.i.i7.i, 4
  %59 = and i64 %58, -128
  %60 = getelementptr i8, ptr %50, i64 %59
  %scevgep614.i.i.i = getelementptr i8, ptr %60, i64 24
  %61 = shl i64 %.164.i.i, 3
  %62 = or disjoint i64 %61, 8
  %63 = add nsw i64 %storemerge785.i.i.i, 4
  %64 = add nuw nsw i64 %.1255.i.i.i, 4
  %65 = icmp sgt i64 %storemerge785.i.i.i, 0
  %66 = icmp eq i64 %.1255.i.i.i, 0
  %67 = add nuw nsw i64 %.169.i.i.i, 4
  %68 = icmp sgt i64 %.164.i.i, 8
  %sunkaddr8.i.i = getelementptr i8, ptr %.733.i.i, i64 %61
  br label %B766.if.i.i

B766.if.i.i:                                      ; preds = %B1398.if.i.i, %B766.if.lr.ph.i.i
  %lsr.iv245.i.i = phi ptr [ %42, %B766.if.lr.ph.i.i ], [ %scevgep246.i.i, %B1398.if.i.i ]
  %lsr.iv242.i.i = phi ptr [ %43, %B766.if.lr.ph.i.i ], [ %scevgep243.i.i, %B1398.if.i.i ]
  %.101311541204.i.i = phi i64 [ 0, %B766.if.lr.ph.i.i ], [ %.1020.i.i, %B1398.if.i.i ]
  %.1020.i.i = add nuw nsw i64 %.101311541204.i.i, 1
  %.1047.i.i = mul nsw i64 %.101311541204.i.i, %.164.i.i
  %.1059.i12.i = getelementptr inbounds double, ptr %43, i64 %.1047.i.i
  %.1266.i.i = shl nuw nsw i64 %.101311541204.i.i, 1
  %.1268.i.i = mul nsw i64 %.1266.i.i, %.164.i.i
  %.1280.i.i = getelementptr inbounds double, ptr %48, i64 %.1268.i.i
  %.1333.neg.i.i = xor i64 %.1266.i.i, -1
  %.1335.i.i = mul i64 %.130.1.i.i, %.1333.neg.i.i
  %.1347.i.i = getelementptr inbounds double, ptr %48, i64 %.1335.i.i
  br i1 %.1901286.not.i.i.i, label %B200.i.i.i, label %B74.if.preheader.i.i.i

B74.if.preheader.i.i.i:                           ; preds = %B766.if.i.i
  br i1 %53, label %B74.if.epil.preheader.i.i.i, label %B74.if.i.i.i

B200.loopexit.unr-lcssa.i.i.i:                    ; preds = %B74.if.i.i.i
  br i1 %lcmp.mod.not.i.i.i, label %B200.i.i.i, label %B74.if.epil.preheader.i.i.i

B74.if.epil.preheader.i.i.i:                      ; preds = %B200.loopexit.unr-lcssa.i.i.i, %B74.if.preheader.i.i.i
  %.19612851287.epil.init.i.i.i = phi i64 [ 0, %B74.if.preheader.i.i.i ], [ %.203.3.i.i.i, %B200.loopexit.unr-lcssa.i.i.i ]
  %69 = shl i64 %.19612851287.epil.init.i.i.i, 3
  %scevgep636.i.i.i = getelementptr i8, ptr %.1125.i.i, i64 %69
  %scevgep640.i.i.i = getelementptr i8, ptr %.1059.i12.i, i64 %69
  br label %B74.if.epil.i.i.i

B74.if.epil.i.i.i:                                ; preds = %B74.if.epil.i.i.i, %B74.if.epil.preheader.i.i.i
  %lsr.iv637.i.i.i = phi i64 [ %lsr.iv.next638.i.i.i, %B74.if.epil.i.i.i ], [ 0, %B74.if.epil.preheader.i.i.i ]
  %scevgep641.i.i.i = getelementptr i8, ptr %scevgep640.i.i.i, i64 %lsr.iv637.i.i.i
  store <8 x double> zeroinitializer, ptr %scevgep641.i.i.i, align 8, !noalias !12
  %scevgep639.i.i.i = getelementptr i8, ptr %scevgep636.i.i.i, i64 %lsr.iv637.i.i.i
  store <8 x double> zeroinitializer, ptr %scevgep639.i.i.i, align 8, !noalias !12
  %lsr.iv.next638.i.i.i = add nuw nsw i64 %lsr.iv637.i.i.i, 64
  %epil.iter.cmp.not.i.i.i = icmp eq i64 %56, %lsr.iv.next638.i.i.i
  br i1 %epil.iter.cmp.not.i.i.i, label %B200.i.i.i, label %B74.if.epil.i.i.i, !llvm.loop !15

B200.i.i.i:                                       ; preds = %B74.if.epil.i.i.i, %B200.loopexit.unr-lcssa.i.i.i, %B766.if.i.i
  br i1 %.3971410.not.i.i.i, label %B1324.i.i.i, label %B298.if.i.i.i

B330.i.i.i:                                       ; preds = %B298.if.i.i.i
  br i1 %65, label %B426.if.i.i.i, label %B912.i.i.i

B912.i.i.i:                                       ; preds = %B426.if.i.i.i, %B330.i.i.i
  br i1 %66, label %B1320.i.i.i, label %B944.if.i.i.i

B1320.i.i.i:                                      ; preds = %B944.if.i.i.i, %B298.if.i.i.i, %B912.i.i.i
  %scevgep606.i.i.i = getelementptr i8, ptr %lsr.iv605.i.i.i, i64 %57
  %scevgep616.i.i.i = getelementptr i8, ptr %lsr.iv615.i.i.i, i64 %57
  %exitcond.not.i.i.i = icmp eq i64 %.410.i.i13.i, %.110.i.i
  br i1 %exitcond.not.i.i.i, label %B1324.i.i.i, label %B298.if.i.i.i

B1324.i.i.i:                                      ; preds = %B1320.i.i.i, %B200.i.i.i
  br i1 %.1901286.not.i.i.i, label %_ZN17bnserve_inference13moving_kernel8_passing6_turnsB3v56B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedExx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i.i, label %B1368.if.i.i.i

B74.if.i.i.i:                                     ; preds = %B74.if.preheader.i.i.i, %B74.if.i.i.i
  %lsr.iv.i.i.i = phi i64 [ %lsr.iv.next.i.i.i, %B74.if.i.i.i ], [ %55, %B74.if.preheader.i.i.i ]
  %.19612851287.i.i.i = phi i64 [ %.203.3.i.i.i, %B74.if.i.i.i ], [ 0, %B74.if.preheader.i.i.i ]
  %sunkaddr41.i.i.i = shl i64 %.19612851287.i.i.i, 3
  %sunkaddr42.i.i.i = getelementptr i8, ptr %.1059.i12.i, i64 %sunkaddr41.i.i.i
  store <8 x double> zeroinitializer, ptr %sunkaddr42.i.i.i, align 8, !noalias !12
  %sunkaddr44.i.i.i = getelementptr i8, ptr %.1125.i.i, i64 %sunkaddr41.i.i.i
  store <8 x double> zeroinitializer, ptr %sunkaddr44.i.i.i, align 8, !noalias !12
  %sunkaddr46.i.i.i = getelementptr i8, ptr %sunkaddr42.i.i.i, i64 64
  store <8 x double> zeroinitializer, ptr %sunkaddr46.i.i.i, align 8, !noalias !12
  %sunkaddr49.i.i.i = getelementptr i8, ptr %sunkaddr44.i.i.i, i64 64
  store <8 x double> zeroinitializer, ptr %sunkaddr49.i.i.i, align 8, !noalias !12
  %sunkaddr52.i.i.i = getelementptr i8, ptr %sunkaddr42.i.i.i, i64 128
  store <8 x double> zeroinitializer, ptr %sunkaddr52.i.i.i, align 8, !noalias !12
  %sunkaddr55.i.i.i = getelementptr i8, ptr %sunkaddr44.i.i.i, i64 128
  store <8 x double> zeroinitializer, ptr %sunkaddr55.i.i.i, align 8, !noalias !12
  %.203.3.i.i.i = add i64 %.19612851287.i.i.i, 32
  %sunkaddr56.i.i.i = shl i64 %.203.3.i.i.i, 3
  %sunkaddr57.i.i.i = getelementptr i8, ptr %.1059.i12.i, i64 %sunkaddr56.i.i.i
  %sunkaddr58.i.i.i = getelementptr i8, ptr %sunkaddr57.i.i.i, i64 -64
  store <8 x double> zeroinitializer, ptr %sunkaddr58.i.i.i, align 8, !noalias !12
  %sunkaddr60.i.i.i = getelementptr i8, ptr %.1125.i.i, i64 %sunkaddr56.i.i.i
  %sunkaddr61.i.i.i = getelementptr i8, ptr %sunkaddr60.i.i.i, i64 -64
  store <8 x double> zeroinitializer, ptr %sunkaddr61.i.i.i, align 8, !noalias !12
  %lsr.iv.next.i.i.i = add i64 %lsr.iv.i.i.i, 4
  %niter.ncmp.3.not.i.i.i = icmp eq i64 %lsr.iv.next.i.i.i, 0
  br i1 %niter.ncmp.3.not.i.i.i, label %B200.loopexit.unr-lcssa.i.i.i, label %B74.if.i.i.i

B298.if.i.i.i:                                    ; preds = %B200.i.i.i, %B1320.i.i.i
  %lsr.iv615.i.i.i = phi ptr [ %scevgep616.i.i.i, %B1320.i.i.i ], [ %scevgep614.i.i.i, %B200.i.i.i ]
  %lsr.iv605.i.i.i = phi ptr [ %scevgep606.i.i.i, %B1320.i.i.i ], [ %scevgep604.i.i.i, %B200.i.i.i ]
  %.40313421415.i.i.i = phi i64 [ %.410.i.i13.i, %B1320.i.i.i ], [ 0, %B200.i.i.i ]
  %.410.i.i13.i = add nuw nsw i64 %.40313421415.i.i.i, 1
  %70 = getelementptr i64, ptr %49, i64 %.40313421415.i.i.i
  %.468.i.i14.i = load i64, ptr %70, align 8, !noalias !12
  %.470.i.i.i = icmp eq i64 %.468.i.i14.i, %.101311541204.i.i
  br i1 %.470.i.i.i, label %B330.i.i.i, label %B1320.i.i.i

B426.if.i.i.i:                                    ; preds = %B330.i.i.i, %B426.if.i.i.i
  %lsr.iv3.i.i.i = phi i64 [ %lsr.iv.next4.i.i.i, %B426.if.i.i.i ], [ %63, %B330.i.i.i ]
  %lsr.iv595.i.i.i = phi i64 [ %lsr.iv.next596.i.i.i, %B426.if.i.i.i ], [ 0, %B330.i.i.i ]
  %sunkaddr62.i.i.i = getelementptr i8, ptr %.1280.i.i, i64 %lsr.iv595.i.i.i
  %.675.i.i21.i = load <8 x double>, ptr %sunkaddr62.i.i.i, align 8, !noalias !12
  %sunkaddr63.i.i.i = getelementptr i8, ptr %.1347.i.i, i64 %lsr.iv595.i.i.i
  %.685.i.i22.i = load <8 x double>, ptr %sunkaddr63.i.i.i, align 8, !noalias !12
  %sunkaddr65.i.i.i = getelementptr i8, ptr %sunkaddr62.i.i.i, i64 8
  %.696.i.i23.i = load <8 x double>, ptr %sunkaddr65.i.i.i, align 8, !noalias !12
  %sunkaddr67.i.i.i = getelementptr i8, ptr %sunkaddr63.i.i.i, i64 8
  %.707.i.i24.i = load <8 x double>, ptr %sunkaddr67.i.i.i, align 8, !noalias !12
  %71 = shl i64 %lsr.iv595.i.i.i, 1
  %scevgep607.i.i.i = getelementptr i8, ptr %lsr.iv605.i.i.i, i64 %71
  %.744.i.i.i = load <16 x double>, ptr %scevgep607.i.i.i, align 8, !noalias !12
  %.745.i.i.i = shufflevector <16 x double> %.744.i.i.i, <16 x double> poison, <8 x i32> <i32 0, i32 2, i32 4, i32 6, i32 8, i32 10, i32 12, i32 14>
  %.746.i.i.i = shufflevector <16 x double> %.744.i.i.i, <16 x double> poison, <8 x i32> <i32 1, i32 3, i32 5, i32 7, i32 9, i32 11, i32 13, i32 15>
  %scevgep609.i.i.i = getelementptr i8, ptr %scevgep607.i.i.i, i64 -16
  %.759.i.i.i = load <16 x double>, ptr %scevgep609.i.i.i, align 8, !noalias !12
  %.760.i.i.i = shufflevector <16 x double> %.759.i.i.i, <16 x double> poison, <8 x i32> <i32 0, i32 2, i32 4, i32 6, i32 8, i32 10, i32 12, i32 14>
  %.761.i.i.i = shufflevector <16 x double> %.759.i.i.i, <16 x double> poison, <8 x i32> <i32 1, i32 3, i32 5, i32 7, i32 9, i32 11, i32 13, i32 15>
  %.8.i.i.i25.i = fsub contract <8 x double> zeroinitializer, %.761.i.i.i
  %.6.i.i.i26.i = fmul contract <8 x double> %.746.i.i.i, %.8.i.i.i25.i
  %.8.i540.i.i.i = fsub contract <8 x double> zeroinitializer, %.6.i.i.i26.i
  %.853.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.745.i.i.i, <8 x double> %.760.i.i.i, <8 x double> %.8.i540.i.i.i)
  %.6.i541.i.i.i = fmul contract <8 x double> %.746.i.i.i, %.760.i.i.i
  %.878.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.745.i.i.i, <8 x double> %.8.i.i.i25.i, <8 x double> %.6.i541.i.i.i)
  %.8.i542.i.i.i = fsub contract <8 x double> zeroinitializer, %.707.i.i24.i
  %.6.i543.i.i.i = fmul contract <8 x double> %.685.i.i22.i, %.8.i542.i.i.i
  %.8.i544.i.i.i = fsub contract <8 x double> zeroinitializer, %.6.i543.i.i.i
  %.972.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.675.i.i21.i, <8 x double> %.696.i.i23.i, <8 x double> %.8.i544.i.i.i)
  %.6.i545.i.i.i = fmul contract <8 x double> %.685.i.i22.i, %.696.i.i23.i
  %.997.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.675.i.i21.i, <8 x double> %.8.i542.i.i.i, <8 x double> %.6.i545.i.i.i)
  %.6.i546.i.i.i = fmul contract <8 x double> %.997.i.i.i, %.878.i.i.i
  %.8.i547.i.i.i = fsub contract <8 x double> zeroinitializer, %.6.i546.i.i.i
  %.1067.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.853.i.i.i, <8 x double> %.972.i.i.i, <8 x double> %.8.i547.i.i.i)
  %.6.i548.i.i.i = fmul contract <8 x double> %.972.i.i.i, %.878.i.i.i
  %.1092.i.i27.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.853.i.i.i, <8 x double> %.997.i.i.i, <8 x double> %.6.i548.i.i.i)
  %.8.i549.i.i.i = fsub contract <8 x double> zeroinitializer, %.1092.i.i27.i
  %scevgep611.i.i.i = getelementptr i8, ptr %.1059.i12.i, i64 %lsr.iv595.i.i.i
  %.1154.i.i.i = load <8 x double>, ptr %scevgep611.i.i.i, align 8, !noalias !12
  %.1155.i.i28.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i549.i.i.i, <8 x double> %.1092.i.i27.i, <8 x double> %.1154.i.i.i)
  %.1156.i.i29.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1067.i.i.i, <8 x double> %.1067.i.i.i, <8 x double> %.1155.i.i28.i)
  store <8 x double> %.1156.i.i29.i, ptr %scevgep611.i.i.i, align 8, !noalias !12
  %.8.i550.i.i.i = fmul contract <8 x double> %.1067.i.i.i, splat (double 2.000000e+00)
  %scevgep610.i.i.i = getelementptr i8, ptr %.1125.i.i, i64 %lsr.iv595.i.i.i
  %.1200.i.i.i = load <8 x double>, ptr %scevgep610.i.i.i, align 8, !noalias !12
  %.1201.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i550.i.i.i, <8 x double> %.1092.i.i27.i, <8 x double> %.1200.i.i.i)
  store <8 x double> %.1201.i.i.i, ptr %scevgep610.i.i.i, align 8, !noalias !12
  %lsr.iv.next596.i.i.i = add nuw i64 %lsr.iv595.i.i.i, 64
  %lsr.iv.next4.i.i.i = add nsw i64 %lsr.iv3.i.i.i, -1
  %.628.i.i.i = icmp sgt i64 %lsr.iv3.i.i.i, 5
  br i1 %.628.i.i.i, label %B426.if.i.i.i, label %B912.i.i.i

B944.if.i.i.i:                                    ; preds = %B912.i.i.i, %B944.if.i.i.i
  %lsr.iv13.i.i.i = phi i64 [ %lsr.iv.next14.i.i.i, %B944.if.i.i.i ], [ %64, %B912.i.i.i ]
  %lsr.iv617.i.i.i = phi ptr [ %scevgep618.i.i.i, %B944.if.i.i.i ], [ %lsr.iv615.i.i.i, %B912.i.i.i ]
  %.130413221324.i.i.i = phi i64 [ %.1311.i.i.i, %B944.if.i.i.i ], [ %.303.i.i.i, %B912.i.i.i ]
  %.1311.i.i.i = add nuw nsw i64 %.130413221324.i.i.i, 1
  %scevgep620.i.i.i = getelementptr i8, ptr %lsr.iv617.i.i.i, i64 -24
  %scevgep619.i.i.i = getelementptr i8, ptr %lsr.iv617.i.i.i, i64 -8
  %.1346.i.i.i = load double, ptr %scevgep619.i.i.i, align 8, !noalias !12
  %.1357.i.i.i = load double, ptr %lsr.iv617.i.i.i, align 8, !noalias !12
  %.1371.i.i.i = load double, ptr %scevgep620.i.i.i, align 8, !noalias !12
  %scevgep621.i.i.i = getelementptr i8, ptr %lsr.iv617.i.i.i, i64 -16
  %.1382.i.i20.i = load double, ptr %scevgep621.i.i.i, align 8, !noalias !12
  %.1405.i.i.i = icmp slt i64 %.130413221324.i.i.i, 0
  %72 = select i1 %.1405.i.i.i, i64 %61, i64 0
  %scevgep628.i.i.i = getelementptr i8, ptr %.1280.i.i, i64 %72
  %73 = shl i64 %.130413221324.i.i.i, 3
  %scevgep629.i.i.i = getelementptr i8, ptr %scevgep628.i.i.i, i64 %73
  %.1421.i.i.i = load double, ptr %scevgep629.i.i.i, align 8, !noalias !12
  %scevgep626.i.i.i = getelementptr i8, ptr %.1347.i.i, i64 %72
  %scevgep627.i.i.i = getelementptr i8, ptr %scevgep626.i.i.i, i64 %73
  %.1451.i.i.i = load double, ptr %scevgep627.i.i.i, align 8, !noalias !12
  %.1466.i.i.i = icmp slt i64 %.130413221324.i.i.i, -1
  %74 = select i1 %.1466.i.i.i, i64 %62, i64 8
  %scevgep17.i.i.i = getelementptr i8, ptr %.1280.i.i, i64 %74
  %scevgep24.i.i.i = getelementptr i8, ptr %scevgep17.i.i.i, i64 %73
  %.1482.i.i.i = load double, ptr %scevgep24.i.i.i, align 8, !noalias !12
  %scevgep15.i.i.i = getelementptr i8, ptr %.1347.i.i, i64 %74
  %scevgep19.i.i.i = getelementptr i8, ptr %scevgep15.i.i.i, i64 %73
  %.1513.i.i.i = load double, ptr %scevgep19.i.i.i, align 8, !noalias !12
  %.1531.i.i.i = fsub contract double 0.000000e+00, %.1382.i.i20.i
  %.1532.i.i.i = fmul contract double %.1357.i.i.i, %.1531.i.i.i
  %.1533.i.i.i = fsub contract double 0.000000e+00, %.1532.i.i.i
  %.1534.i.i.i = tail call contract double @llvm.fma.f64(double %.1346.i.i.i, double %.1371.i.i.i, double %.1533.i.i.i)
  %.1535.i.i.i = fmul contract double %.1357.i.i.i, %.1371.i.i.i
  %.1536.i.i.i = tail call contract double @llvm.fma.f64(double %.1346.i.i.i, double %.1531.i.i.i, double %.1535.i.i.i)
  %.1558.i.i.i = fsub contract double 0.000000e+00, %.1513.i.i.i
  %.1559.i.i.i = fmul contract double %.1451.i.i.i, %.1558.i.i.i
  %.1560.i.i.i = fsub contract double 0.000000e+00, %.1559.i.i.i
  %.1561.i.i.i = tail call contract double @llvm.fma.f64(double %.1421.i.i.i, double %.1482.i.i.i, double %.1560.i.i.i)
  %.1562.i.i.i = fmul contract double %.1451.i.i.i, %.1482.i.i.i
  %.1563.i.i.i = tail call contract double @llvm.fma.f64(double %.1421.i.i.i, double %.1558.i.i.i, double %.1562.i.i.i)
  %.1585.i.i.i = fmul contract double %.1536.i.i.i, %.1563.i.i.i
  %.1586.i.i.i = fsub contract double 0.000000e+00, %.1585.i.i.i
  %.1587.i.i.i = tail call contract double @llvm.fma.f64(double %.1534.i.i.i, double %.1561.i.i.i, double %.1586.i.i.i)
  %.1588.i.i.i = fmul contract double %.1536.i.i.i, %.1561.i.i.i
  %.1589.i.i.i = tail call contract double @llvm.fma.f64(double %.1534.i.i.i, double %.1563.i.i.i, double %.1588.i.i.i)
  %scevgep624.i.i.i = getelementptr i8, ptr %.1059.i12.i, i64 %72
  %scevgep18.i.i.i = getelementptr i8, ptr %scevgep624.i.i.i, i64 %73
  %.1647.i.i.i = load double, ptr %scevgep18.i.i.i, align 8, !noalias !12
  %.1648.i.i.i = fmul contract double %.1587.i.i.i, %.1587.i.i.i
  %.1649.i.i.i = fmul contract double %.1589.i.i.i, %.1589.i.i.i
  %.1650.i.i.i = fsub contract double %.1648.i.i.i, %.1649.i.i.i
  %.1651.i.i.i = fadd contract double %.1647.i.i.i, %.1650.i.i.i
  store double %.1651.i.i.i, ptr %scevgep18.i.i.i, align 8, !noalias !12
  %scevgep622.i.i.i = getelementptr i8, ptr %.1125.i.i, i64 %72
  %scevgep16.i.i.i = getelementptr i8, ptr %scevgep622.i.i.i, i64 %73
  %.1711.i.i.i = load double, ptr %scevgep16.i.i.i, align 8, !noalias !12
  %.1712.i.i.i = fmul contract double %.1587.i.i.i, 2.000000e+00
  %.1713.i.i.i = fmul contract double %.1712.i.i.i, %.1589.i.i.i
  %.1714.i.i.i = fadd contract double %.1711.i.i.i, %.1713.i.i.i
  store double %.1714.i.i.i, ptr %scevgep16.i.i.i, align 8, !noalias !12
  %scevgep618.i.i.i = getelementptr i8, ptr %lsr.iv617.i.i.i, i64 16
  %lsr.iv.next14.i.i.i = add nsw i64 %lsr.iv13.i.i.i, -1
  %.1298.i.i.i = icmp sgt i64 %lsr.iv13.i.i.i, 5
  br i1 %.1298.i.i.i, label %B944.if.i.i.i, label %B1320.i.i.i

B1368.if.i.i.i:                                   ; preds = %B1324.i.i.i, %B1368.if.i.i.i
  %lsr.iv1.i.i.i = phi i64 [ %lsr.iv.next2.i.i.i, %B1368.if.i.i.i ], [ %67, %B1324.i.i.i ]
  %lsr.iv589.i.i.i = phi i64 [ %lsr.iv.next590.i.i.i, %B1368.if.i.i.i ], [ 0, %B1324.i.i.i ]
  %scevgep591.i.i.i = getelementptr i8, ptr %.1059.i12.i, i64 %lsr.iv589.i.i.i
  %.1920.i.i.i = load <8 x double>, ptr %scevgep591.i.i.i, align 8, !noalias !12
  %scevgep.i.i.i = getelementptr i8, ptr %.1125.i.i, i64 %lsr.iv589.i.i.i
  %.1930.i.i.i = load <8 x double>, ptr %scevgep.i.i.i, align 8, !noalias !12
  %.6.i551.i.i.i = fmul contract <8 x double> %.1920.i.i.i, %.1920.i.i.i
  %.6.i552.i.i.i = fmul contract <8 x double> %.1930.i.i.i, %.1930.i.i.i
  %.6.i553.i.i.i = fadd contract <8 x double> %.6.i551.i.i.i, %.6.i552.i.i.i
  %.2003.i.i15.i = tail call <8 x double> @llvm.sqrt.v8f64(<8 x double> %.6.i553.i.i.i)
  %.6.i554.i.i.i = fadd contract <8 x double> %.1920.i.i.i, %.2003.i.i15.i
  %.8.i555.i.i.i = fadd contract <8 x double> %.6.i554.i.i.i, splat (double 1.000000e-300)
  %.6.i556.i.i.i = fdiv contract <8 x double> %.1930.i.i.i, %.8.i555.i.i.i
  %.6.i557.i.i.i = fmul contract <8 x double> %.6.i556.i.i.i, %.6.i556.i.i.i
  %.8.i558.i.i.i = fadd contract <8 x double> %.6.i557.i.i.i, splat (double 1.000000e+00)
  %.2124.i.i.i = tail call <8 x double> @llvm.sqrt.v8f64(<8 x double> %.8.i558.i.i.i)
  %.8.i559.i.i.i = fadd contract <8 x double> %.2124.i.i.i, splat (double 1.000000e+00)
  %.6.i560.i.i.i = fdiv contract <8 x double> %.6.i556.i.i.i, %.8.i559.i.i.i
  %.6.i561.i.i.i = fmul contract <8 x double> %.6.i560.i.i.i, %.6.i560.i.i.i
  %.8.i562.i.i.i = fmul contract <8 x double> %.6.i561.i.i.i, splat (double 0x3F677AE9349F5F7A)
  %.8.i563.i.i.i = fadd contract <8 x double> %.8.i562.i.i.i, splat (double 0xBF908DC039C4DC63)
  %.6.i564.i.i.i = fmul contract <8 x double> %.6.i561.i.i.i, %.8.i563.i.i.i
  %.8.i565.i.i.i = fadd contract <8 x double> %.6.i564.i.i.i, splat (double 0x3FA5F83FB7E8F47D)
  %.6.i566.i.i.i = fmul contract <8 x double> %.6.i561.i.i.i, %.8.i565.i.i.i
  %.8.i567.i.i.i = fadd contract <8 x double> %.6.i566.i.i.i, splat (double 0xBFB3462E8D8711AD)
  %.6.i568.i.i.i = fmul contract <8 x double> %.6.i561.i.i.i, %.8.i567.i.i.i
  %.8.i569.i.i.i = fadd contract <8 x double> %.6.i568.i.i.i, splat (double 0x3FBB47B06AC4D989)
  %.6.i570.i.i.i = fmul contract <8 x double> %.6.i561.i.i.i, %.8.i569.i.i.i
  %.8.i571.i.i.i = fadd contract <8 x double> %.6.i570.i.i.i, splat (double 0xBFC22FF8E008E644)
  %.6.i572.i.i.i = fmul contract <8 x double> %.6.i561.i.i.i, %.8.i571.i.i.i
  %.8.i573.i.i.i = fadd contract <8 x double> %.6.i572.i.i.i, splat (double 0x3FC9977C9B288755)
  %.6.i574.i.i.i = fmul contract <8 x double> %.6.i561.i.i.i, %.8.i573.i.i.i
  %.8.i575.i.i.i = fadd contract <8 x double> %.6.i574.i.i.i, splat (double 0xBFD5554D72204448)
  %.6.i576.i.i.i = fmul contract <8 x double> %.6.i561.i.i.i, %.8.i575.i.i.i
  %.8.i577.i.i.i = fadd contract <8 x double> %.6.i576.i.i.i, splat (double 1.000000e+00)
  %.8.i578.i.i.i = fmul contract <8 x double> %.6.i560.i.i.i, splat (double 2.000000e+00)
  %.6.i579.i.i.i = fmul contract <8 x double> %.8.i578.i.i.i, %.8.i577.i.i.i
  store <8 x double> %.6.i579.i.i.i, ptr %scevgep.i.i.i, align 8, !noalias !12
  %lsr.iv.next590.i.i.i = add i64 %lsr.iv589.i.i.i, 64
  %lsr.iv.next2.i.i.i = add nsw i64 %lsr.iv1.i.i.i, -1
  %.1872.i.i.i = icmp sgt i64 %lsr.iv1.i.i.i, 5
  br i1 %.1872.i.i.i, label %B1368.if.i.i.i, label %_ZN17bnserve_inference13moving_kernel8_passing6_turnsB3v56B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedExx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i.i

_ZN17bnserve_inference13moving_kernel8_passing6_turnsB3v56B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedExx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i.i: ; preds = %B1368.if.i.i.i, %B1324.i.i.i
  br i1 %.146.i.i6.i, label %B1398.if.i.i, label %B1160.peel.i.i

B1160.peel.i.i:                                   ; preds = %_ZN17bnserve_inference13moving_kernel8_passing6_turnsB3v56B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedExx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i.i
  %.1610.peel.i.i = load <8 x double>, ptr %.733.i.i, align 8, !noalias !9
  %.1621.peel.i.i = load <8 x double>, ptr %sunkaddr8.i.i, align 8, !noalias !9
  %.1632.peel.i.i = load <8 x double>, ptr %.1125.i.i, align 8, !noalias !9
  %.6.i.i.i = fmul contract <8 x double> %.1621.peel.i.i, %.1632.peel.i.i
  %.1657.peel.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1610.peel.i.i, <8 x double> zeroinitializer, <8 x double> %.6.i.i.i)
  %sunkaddr253.i.i = shl i64 %.1047.i.i, 3
  %sunkaddr254.i.i = getelementptr inbounds i8, ptr %42, i64 %sunkaddr253.i.i
  %.1668.peel.i.i = load <8 x double>, ptr %sunkaddr254.i.i, align 8, !noalias !9
  %.6.i118.i.i = fsub contract <8 x double> %.1668.peel.i.i, %.1657.peel.i.i
  store <8 x double> %.6.i118.i.i, ptr %.1059.i12.i, align 8, !noalias !9
  br i1 %68, label %B1078.if.i.i, label %B1398.if.i.i

B1078.if.i.i:                                     ; preds = %B1160.peel.i.i, %B1078.if.i.i
  %lsr.iv.i17.i = phi i64 [ %lsr.iv.next.i19.i, %B1078.if.i.i ], [ %47, %B1160.peel.i.i ]
  %lsr.iv239.i.i = phi i64 [ %lsr.iv.next240.i.i, %B1078.if.i.i ], [ 64, %B1160.peel.i.i ]
  %scevgep.i18.i = getelementptr i8, ptr %.1125.i.i, i64 %lsr.iv239.i.i
  %scevgep241.i.i = getelementptr i8, ptr %scevgep.i18.i, i64 -8
  %.1587.i.i = load <8 x double>, ptr %scevgep241.i.i, align 8, !noalias !9
  %scevgep249.i.i = getelementptr i8, ptr %.733.i.i, i64 %lsr.iv239.i.i
  %.1610.i.i = load <8 x double>, ptr %scevgep249.i.i, align 8, !noalias !9
  %scevgep248.i.i = getelementptr i8, ptr %.858.i.i, i64 %lsr.iv239.i.i
  %.1621.i.i = load <8 x double>, ptr %scevgep248.i.i, align 8, !noalias !9
  %.1632.i.i = load <8 x double>, ptr %scevgep.i18.i, align 8, !noalias !9
  %.6.i119.i.i = fmul contract <8 x double> %.1621.i.i, %.1632.i.i
  %.1657.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1610.i.i, <8 x double> %.1587.i.i, <8 x double> %.6.i119.i.i)
  %scevgep247.i.i = getelementptr i8, ptr %lsr.iv245.i.i, i64 %lsr.iv239.i.i
  %.1668.i.i = load <8 x double>, ptr %scevgep247.i.i, align 8, !noalias !9
  %.6.i120.i.i = fsub contract <8 x double> %.1668.i.i, %.1657.i.i
  %scevgep244.i.i = getelementptr i8, ptr %lsr.iv242.i.i, i64 %lsr.iv239.i.i
  store <8 x double> %.6.i120.i.i, ptr %scevgep244.i.i, align 8, !noalias !9
  %lsr.iv.next240.i.i = add nuw i64 %lsr.iv239.i.i, 64
  %lsr.iv.next.i19.i = add nsw i64 %lsr.iv.i17.i, -1
  %.1532.i.i = icmp sgt i64 %lsr.iv.i17.i, 5
  br i1 %.1532.i.i, label %B1078.if.i.i, label %B1398.if.i.i, !llvm.loop !17

B1398.if.i.i:                                     ; preds = %B1078.if.i.i, %B1160.peel.i.i, %_ZN17bnserve_inference13moving_kernel8_passing6_turnsB3v56B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedExx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i.i
  %sunkaddr256.i.i = shl i64 %.1047.i.i, 3
  %sunkaddr257.i.i = getelementptr i8, ptr %42, i64 %sunkaddr256.i.i
  %sunkaddr258.i.i = getelementptr i8, ptr %sunkaddr257.i.i, i64 8
  %.1857.i.i = load double, ptr %sunkaddr258.i.i, align 8, !noalias !9
  %.1887.i.i = load double, ptr %sunkaddr10.i8.i, align 8, !noalias !9
  %.1918.i.i = load double, ptr %.1125.i.i, align 8, !noalias !9
  %.1919.i.i = fmul contract double %.1887.i.i, %.1918.i.i
  %.1949.i.i = load double, ptr %sunkaddr11.i9.i, align 8, !noalias !9
  %.1979.i.i = load double, ptr %sunkaddr12.i10.i, align 8, !noalias !9
  %.1980.i.i = fmul contract double %.1949.i.i, %.1979.i.i
  %.1981.i.i = fadd contract double %.1919.i.i, %.1980.i.i
  %.1982.i.i = fsub contract double %.1857.i.i, %.1981.i.i
  %75 = getelementptr i8, ptr %.1059.i12.i, i64 8
  store double %.1982.i.i, ptr %75, align 8, !noalias !9
  %sunkaddr266.i.i = getelementptr i8, ptr %sunkaddr257.i.i, i64 16
  %.1857.1.i.i = load double, ptr %sunkaddr266.i.i, align 8, !noalias !9
  %.1887.1.i.i = load double, ptr %sunkaddr15.i.i, align 8, !noalias !9
  %.1918.1.i.i = load double, ptr %sunkaddr12.i10.i, align 8, !noalias !9
  %.1919.1.i.i = fmul contract double %.1887.1.i.i, %.1918.1.i.i
  %.1949.1.i.i = load double, ptr %sunkaddr16.i.i, align 8, !noalias !9
  %.1979.1.i.i = load double, ptr %sunkaddr17.i.i, align 8, !noalias !9
  %.1980.1.i.i = fmul contract double %.1949.1.i.i, %.1979.1.i.i
  %.1981.1.i.i = fadd contract double %.1919.1.i.i, %.1980.1.i.i
  %.1982.1.i.i = fsub contract double %.1857.1.i.i, %.1981.1.i.i
  %76 = getelementptr i8, ptr %.1059.i12.i, i64 16
  store double %.1982.1.i.i, ptr %76, align 8, !noalias !9
  %sunkaddr274.i.i = getelementptr i8, ptr %sunkaddr257.i.i, i64 24
  %.1857.2.i.i = load double, ptr %sunkaddr274.i.i, align 8, !noalias !9
  %.1887.2.i.i = load double, ptr %sunkaddr23.i.i, align 8, !noalias !9
  %.1918.2.i.i = load double, ptr %sunkaddr17.i.i, align 8, !noalias !9
  %.1919.2.i.i = fmul contract double %.1887.2.i.i, %.1918.2.i.i
  %.1949.2.i.i = load double, ptr %sunkaddr27.i.i, align 8, !noalias !9
  %.1979.2.i.i = load double, ptr %sunkaddr31.i.i, align 8, !noalias !9
  %.1980.2.i.i = fmul contract double %.1949.2.i.i, %.1979.2.i.i
  %.1981.2.i.i = fadd contract double %.1919.2.i.i, %.1980.2.i.i
  %.1982.2.i.i = fsub contract double %.1857.2.i.i, %.1981.2.i.i
  %77 = getelementptr i8, ptr %.1059.i12.i, i64 24
  store double %.1982.2.i.i, ptr %77, align 8, !noalias !9
  %sunkaddr282.i.i = getelementptr i8, ptr %sunkaddr257.i.i, i64 32
  %.1857.3.i.i = load double, ptr %sunkaddr282.i.i, align 8, !noalias !9
  %.1887.3.i.i = load double, ptr %sunkaddr39.i.i, align 8, !noalias !9
  %.1918.3.i.i = load double, ptr %sunkaddr31.i.i, align 8, !noalias !9
  %.1919.3.i.i = fmul contract double %.1887.3.i.i, %.1918.3.i.i
  %.1949.3.i.i = load double, ptr %sunkaddr40.i.i, align 8, !noalias !9
  %.1979.3.i.i = load double, ptr %sunkaddr41.i.i, align 8, !noalias !9
  %.1980.3.i.i = fmul contract double %.1949.3.i.i, %.1979.3.i.i
  %.1981.3.i.i = fadd contract double %.1919.3.i.i, %.1980.3.i.i
  %.1982.3.i.i = fsub contract double %.1857.3.i.i, %.1981.3.i.i
  %78 = getelementptr i8, ptr %.1059.i12.i, i64 32
  store double %.1982.3.i.i, ptr %78, align 8, !noalias !9
  %sunkaddr290.i.i = getelementptr i8, ptr %sunkaddr257.i.i, i64 40
  %.1857.4.i.i = load double, ptr %sunkaddr290.i.i, align 8, !noalias !9
  %.1887.4.i.i = load double, ptr %sunkaddr43.i.i, align 8, !noalias !9
  %.1918.4.i.i = load double, ptr %sunkaddr41.i.i, align 8, !noalias !9
  %.1919.4.i.i = fmul contract double %.1887.4.i.i, %.1918.4.i.i
  %.1949.4.i.i = load double, ptr %sunkaddr44.i.i, align 8, !noalias !9
  %.1979.4.i.i = load double, ptr %sunkaddr45.i.i, align 8, !noalias !9
  %.1980.4.i.i = fmul contract double %.1949.4.i.i, %.1979.4.i.i
  %.1981.4.i.i = fadd contract double %.1919.4.i.i, %.1980.4.i.i
  %.1982.4.i.i = fsub contract double %.1857.4.i.i, %.1981.4.i.i
  %79 = getelementptr i8, ptr %.1059.i12.i, i64 40
  store double %.1982.4.i.i, ptr %79, align 8, !noalias !9
  %sunkaddr298.i.i = getelementptr i8, ptr %sunkaddr257.i.i, i64 48
  %.1857.5.i.i = load double, ptr %sunkaddr298.i.i, align 8, !noalias !9
  %.1887.5.i.i = load double, ptr %sunkaddr47.i.i, align 8, !noalias !9
  %.1918.5.i.i = load double, ptr %sunkaddr45.i.i, align 8, !noalias !9
  %.1919.5.i.i = fmul contract double %.1887.5.i.i, %.1918.5.i.i
  %.1949.5.i.i = load double, ptr %sunkaddr48.i.i, align 8, !noalias !9
  %.1979.5.i.i = load double, ptr %sunkaddr49.i.i, align 8, !noalias !9
  %.1980.5.i.i = fmul contract double %.1949.5.i.i, %.1979.5.i.i
  %.1981.5.i.i = fadd contract double %.1919.5.i.i, %.1980.5.i.i
  %.1982.5.i.i = fsub contract double %.1857.5.i.i, %.1981.5.i.i
  %80 = getelementptr i8, ptr %.1059.i12.i, i64 48
  store double %.1982.5.i.i, ptr %80, align 8, !noalias !9
  %sunkaddr306.i.i = getelementptr i8, ptr %sunkaddr257.i.i, i64 56
  %.1857.6.i.i = load double, ptr %sunkaddr306.i.i, align 8, !noalias !9
  %.1887.6.i.i = load double, ptr %sunkaddr51.i.i, align 8, !noalias !9
  %.1918.6.i.i = load double, ptr %sunkaddr49.i.i, align 8, !noalias !9
  %.1919.6.i.i = fmul contract double %.1887.6.i.i, %.1918.6.i.i
  %.1949.6.i.i = load double, ptr %sunkaddr52.i.i, align 8, !noalias !9
  %.1979.6.i.i = load double, ptr %sunkaddr53.i.i, align 8, !noalias !9
  %.1980.6.i.i = fmul contract double %.1949.6.i.i, %.1979.6.i.i
  %.1981.6.i.i = fadd contract double %.1919.6.i.i, %.1980.6.i.i
  %.1982.6.i.i = fsub contract double %.1857.6.i.i, %.1981.6.i.i
  %81 = getelementptr i8, ptr %.1059.i12.i, i64 56
  store double %.1982.6.i.i, ptr %81, align 8, !noalias !9
  %scevgep243.i.i = getelementptr i8, ptr %lsr.iv242.i.i, i64 %46
  %scevgep246.i.i = getelementptr i8, ptr %lsr.iv245.i.i, i64 %46
  %exitcond.not.i16.i = icmp eq i64 %.1020.i.i, %.50.i.i
  br i1 %exitcond.not.i16.i, label %_ZN17bnserve_inference13moving_kernel8_passing12find_passingB3v40B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIxLi1E1C7mutable7alignedE.exit.i, label %B766.if.i.i

_ZN17bnserve_inference13moving_kernel8_passing12find_passingB3v40B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIxLi1E1C7mutable7alignedE.exit.i: ; preds = %B1398.if.i.i, %B288.i.i, %_ZN17bnserve_inference13moving_kernel7_source6_placeB3v14B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i
  %.835.sroa.12.1.i = inttoptr i64 %.232.i.i to ptr
  br i1 %83, label %.1216.if.i, label %.1216.endif.preheader.i, !prof !19

B1076.i:                                          ; preds = %.1995.endif.preheader.i, %.1604.if.i
  br i1 %.21261117.not.i, label %B1468.i, label %B1120.if.preheader.i

B1120.if.preheader.i:                             ; preds = %B1076.i
  %.264.i.i = shl i64 %.631.sroa.0.073.i, 4
  br label %B1120.if.i

B1120.loopexit.i:                                 ; preds = %B1242.backedge.i, %_ZN17bnserve_inference13moving_kernel7_source9_polariseB3v77B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i
  %lsr.iv.next.i = add i64 %lsr.iv.i, -512
  %lsr.iv.next260.i = add i64 %lsr.iv259.i, 4096
  %.2126.i = icmp sgt i64 %.212510941121.i, 1
  br i1 %.2126.i, label %B1120.if.i, label %B1468.i

B1468.i:                                          ; preds = %B1120.loopexit.i, %B1076.i
  %.641.i = icmp sgt i64 %.640112672.i, 0
  %.654.i = zext i1 %.641.i to i64
  %.6471140.i = add i64 %.647114071.i, %.654.i
  %.650.i = sext i1 %.641.i to i64
  %.6401126.i = add nsw i64 %.640112672.i, %.650.i
  %.631.sroa.0.0.i = select i1 %.641.i, i64 %.647114071.i, i64 0
  br i1 %.641.i, label %B568.i, label %_ZN17bnserve_inference13moving_kernel7_source8contractB2v3B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIxLi1E1C7mutable7alignedE.exit

B568.lr.ph.i:                                     ; preds = %entry
  %.640112670.i = add nsw i64 %.561.i, -1
  %.2084.inv.i = icmp slt i64 %.390.i, 1
  %.21261117.not1354.i = icmp eq i64 %.2105.i, 0
  %.21261117.not.i = select i1 %.2084.inv.i, i1 true, i1 %.21261117.not1354.i
  %82 = add i64 %.289.idx.i, 4096
  %sunkaddr107.i = getelementptr i8, ptr %arg.arguments, i64 176
  %.109.i.i = getelementptr i8, ptr %arg.arguments, i64 128
  %.193.i.i = getelementptr i8, ptr %arg.arguments, i64 312
  %.227.i.i = getelementptr i8, ptr %arg.arguments, i64 320
  %83 = icmp slt i64 %.425.i, 1
  %84 = icmp slt i64 %.429.i, 2
  %85 = icmp sgt i64 %"$phi500.0.2.0.i", 0
  %.152.i.i = getelementptr i8, ptr %arg.arguments, i64 32
  %sunkaddr10.i.i = getelementptr i8, ptr %arg.arguments, i64 40
  %sunkaddr11.i.i = getelementptr i8, ptr %arg.arguments, i64 48
  %sunkaddr.i.i = getelementptr i8, ptr %arg.arguments, i64 272
  %sunkaddr12.i.i = getelementptr i8, ptr %arg.arguments, i64 304
  %.724.i.i = getelementptr i8, ptr %arg.arguments, i64 296
  %.547.i5.i = getelementptr i8, ptr %arg.arguments, i64 280
  %.459.i.i = getelementptr i8, ptr %arg.arguments, i64 152
  %.361.i.i = getelementptr i8, ptr %arg.arguments, i64 168
  %.636.i.i = getelementptr i8, ptr %arg.arguments, i64 288
  %sunkaddr113.i = getelementptr i8, ptr %arg.arguments, i64 224
  %sunkaddr114.i = getelementptr i8, ptr %arg.arguments, i64 232
  %.319.i.i = getelementptr i8, ptr %arg.arguments, i64 256
  %.408.i.i = getelementptr i8, ptr %arg.arguments, i64 264
  %86 = icmp slt i64 %.47.i, 1
  %.198.i.i = getelementptr i8, ptr %arg.arguments, i64 56
  %scevgep465.i.i = getelementptr i8, ptr %.289.i, i64 4096
  %.2380.i.i = getelementptr i8, ptr %arg.arguments, i64 184
  %.2458.i.i = getelementptr i8, ptr %arg.arguments, i64 80
  %.2784.i.i = getelementptr i8, ptr %arg.arguments, i64 192
  %.2902.i.i = getelementptr i8, ptr %arg.arguments, i64 200
  %.491.i.i = getelementptr i8, ptr %arg.arguments, i64 216
  %.413.i114.i = getelementptr i8, ptr %arg.arguments, i64 24
  %.138.i.i = getelementptr i8, ptr %arg.arguments, i64 16
  %sunkaddr81.i.i = getelementptr i8, ptr %arg.arguments, i64 144
  %sunkaddr.i119.i = getelementptr i8, ptr %arg.arguments, i64 64
  %sunkaddr120.i = getelementptr i8, ptr %arg.arguments, i64 72
  br label %B568.i

.1216.endif.preheader.i:                          ; preds = %_ZN17bnserve_inference13moving_kernel8_passing12find_passingB3v40B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIxLi1E1C7mutable7alignedE.exit.i
  %.908.i = load i64, ptr %sunkaddr113.i, align 8, !noalias !0
  %.912.i = mul nsw i64 %.631.sroa.0.073.i, %.910.i
  %.913.i = add nsw i64 %.908.i, %.912.i
  %.916.i = inttoptr i64 %.913.i to ptr
  tail call void @llvm.memset.p0.i64(ptr align 8 %.916.i, i8 0, i64 %.910.i, i1 false), !noalias !0
  br label %.1216.if.i

.1216.if.i:                                       ; preds = %.1216.endif.preheader.i, %_ZN17bnserve_inference13moving_kernel8_passing12find_passingB3v40B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIxLi1E1C7mutable7alignedE.exit.i
  br i1 %84, label %.1604.if.i, label %.1604.endif.preheader.i, !prof !19

.1604.endif.preheader.i:                          ; preds = %.1216.if.i
  %.1296.i = load i64, ptr %sunkaddr114.i, align 8, !noalias !0
  %.1300.i = mul nsw i64 %.631.sroa.0.073.i, %.1298.i
  %.1301.i = add nsw i64 %.1296.i, %.1300.i
  %.1304.i = inttoptr i64 %.1301.i to ptr
  tail call void @llvm.memset.p0.i64(ptr align 8 %.1304.i, i8 0, i64 %.1298.i, i1 false), !noalias !0
  br label %.1604.if.i

.1604.if.i:                                       ; preds = %.1604.endif.preheader.i, %.1216.if.i
  br i1 %85, label %.1995.endif.preheader.i, label %B1076.i

.1995.endif.preheader.i:                          ; preds = %.1604.if.i
  %.1687.i = load i64, ptr %.504.i, align 8, !noalias !0
  %.1691.i = mul nsw i64 %.631.sroa.0.073.i, %.1689.i
  %.1692.i = add nsw i64 %.1687.i, %.1691.i
  %.1695.i = inttoptr i64 %.1692.i to ptr
  tail call void @llvm.memset.p0.i64(ptr align 8 %.1695.i, i8 0, i64 %.1689.i, i1 false), !noalias !0
  br label %B1076.i

B1120.if.i:                                       ; preds = %B1120.loopexit.i, %B1120.if.preheader.i
  %lsr.iv259.i = phi i64 [ 0, %B1120.if.preheader.i ], [ %lsr.iv.next260.i, %B1120.loopexit.i ]
  %lsr.iv.i = phi i64 [ %.390.i, %B1120.if.preheader.i ], [ %lsr.iv.next.i, %B1120.loopexit.i ]
  %.212510941121.i = phi i64 [ %.2105.i, %B1120.if.preheader.i ], [ %.2135.i, %B1120.loopexit.i ]
  %.213211001120.i = phi i64 [ 0, %B1120.if.preheader.i ], [ %.2139.i, %B1120.loopexit.i ]
  %smin91.i = tail call i64 @llvm.smin.i64(i64 %lsr.iv.i, i64 512)
  %87 = lshr exact i64 %smin91.i, 3
  %88 = add nuw nsw i64 %87, 4
  %.2135.i = add nsw i64 %.212510941121.i, -1
  %.2139.i = add i64 %.213211001120.i, 512
  %.2169.i = sub nsw i64 %.390.i, %.213211001120.i
  %.13.i.i = tail call i64 @llvm.smin.i64(i64 %.2169.i, i64 512)
  %.79.i30.i = load i64, ptr %.109.i.i, align 8, !noalias !20
  %.108.i.i = load i64, ptr %.76.i, align 8, !noalias !20
  %.137.i.i = load i64, ptr %.106.i, align 8, !noalias !20
  %.149.i.i = sub i64 0, %.137.i.i
  %.157.1.i.i = and i64 %.149.i.i, -8
  %.224.i.i = load i64, ptr %.361.i.i, align 8, !noalias !20
  %.226.i.i = shl nsw i64 %.79.i30.i, 4
  %.228.i31.i = mul i64 %.226.i.i, %.631.sroa.0.073.i
  %.229.i32.i = mul i64 %.228.i31.i, %.137.i.i
  %.230.i.i = add nsw i64 %.229.i32.i, %.224.i.i
  %.320.i.i = load i64, ptr %.319.i.i, align 8, !noalias !20
  %.323.i.i = mul i64 %.79.i30.i, %.229.i.i
  %.324.i.i = add nsw i64 %.320.i.i, %.323.i.i
  %.409.i.i = load i64, ptr %.408.i.i, align 8, !noalias !20
  %.413.i.i = add nsw i64 %.409.i.i, %.228.i31.i
  %.499.i.i = load i64, ptr %.459.i.i, align 8, !noalias !20
  %.673.i.i = sub nsw i64 %.137.i.i, %.213211001120.i
  %.13.i.i.i = tail call i64 @llvm.smin.i64(i64 %.673.i.i, i64 range(i64 -9223372036854775799, 513) %.13.i.i)
  %.827.i.i = add i64 %.108.i.i, 2
  %.78684.i.i = icmp sgt i64 %.108.i.i, 0
  br i1 %.78684.i.i, label %B622.lr.ph.i.i, label %B980.i.i

B622.i.i:                                         ; preds = %.2478.endif.endif.endif.endif.i.i, %B622.lr.ph.i.i
  %.776.sroa.0.090.i.i = phi i64 [ 0, %B622.lr.ph.i.i ], [ %.776.sroa.0.0.i.i, %.2478.endif.endif.endif.endif.i.i ]
  %.785148389.i.i = phi i64 [ %.785148387.i.i, %B622.lr.ph.i.i ], [ %.7851483.i.i, %.2478.endif.endif.endif.endif.i.i ]
  %.792149388.i.i = phi i64 [ 1, %B622.lr.ph.i.i ], [ %.7921493.i.i, %.2478.endif.endif.endif.endif.i.i ]
  br i1 %.1505.i.i, label %.2478.endif.endif.endif.endif.i.i, label %.2175.endif.preheader.i.i, !prof !19

B980.i.i:                                         ; preds = %.2478.endif.endif.endif.endif.i.i, %B1120.if.i
  %.29671523.not.i.i = icmp slt i64 %.79.i30.i, 1
  br i1 %.29671523.not.i.i, label %_ZN17bnserve_inference13moving_kernel7_source9_polariseB3v77B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i, label %B1010.if.lr.ph.i.i

B1010.if.lr.ph.i.i:                               ; preds = %B980.i.i
  %.3556.idx.i.i = shl i64 %.108.i.i, 13
  %.3556.i.i = getelementptr i8, ptr %.289.i, i64 %.3556.idx.i.i
  %.3624.i.i = getelementptr i8, ptr %.3556.i.i, i64 4096
  %.137.i.i.i = lshr exact i64 %.13.i.i, 3
  %.114.inv.i.i.i = icmp slt i64 %.2169.i, 1
  %89 = add nuw nsw i64 %.137.i.i.i, 4
  %90 = inttoptr i64 %.499.i.i to ptr
  %91 = inttoptr i64 %.230.i.i to ptr
  %.90.i.i.i = and i64 %.13.i.i.i, -8
  %92 = tail call i64 @llvm.smax.i64(i64 range(i64 -9223372036854775808, 513) %.13.i.i.i, i64 7)
  %storemerge.i.i.i = lshr i64 %92, 3
  %.176243.not.i.i.i = icmp eq i64 %storemerge.i.i.i, 0
  %.264.not.i.i.i = icmp eq i64 %.90.i.i.i, %.13.i.i.i
  %93 = add nuw nsw i64 %storemerge.i.i.i, 4
  %.276.i.i.i = getelementptr inbounds double, ptr %.3556.i.i, i64 %.90.i.i.i
  %.289.i.i.i = getelementptr inbounds double, ptr %.3624.i.i, i64 %.90.i.i.i
  %.334.i.i.i = and i64 %.13.i.i.i, 7
  %.377249.not.i.i.i = icmp eq i64 %.334.i.i.i, 0
  %.429.i.i.i = icmp slt i64 %.13.i.i.i, 0
  %94 = tail call i64 @llvm.smin.i64(i64 %.13.i.i.i, i64 0)
  %.430.i.i.i = shl i64 %94, 1
  %.idx.i.i.i = shl i64 %.90.i.i.i, 4
  %.460.i.i.i = select i1 %.429.i.i.i, i64 %.13.i.i, i64 0
  %.474.i.i.i = getelementptr double, ptr %.276.i.i.i, i64 %.460.i.i.i
  %.536.i.i.i = getelementptr double, ptr %.289.i.i.i, i64 %.460.i.i.i
  %.377.not.i.i.i = icmp eq i64 %.334.i.i.i, 1
  %.390.i.i33.i = or disjoint i64 %.90.i.i.i, 1
  %.idx.1.i.i.i = shl i64 %.390.i.i33.i, 4
  %95 = getelementptr double, ptr %.3556.i.i, i64 %.390.i.i33.i
  %.474.1.i.i.i = getelementptr double, ptr %95, i64 %.460.i.i.i
  %96 = getelementptr double, ptr %.3624.i.i, i64 %.390.i.i33.i
  %.536.1.i.i.i = getelementptr double, ptr %96, i64 %.460.i.i.i
  %.377.1.i.i.i = icmp samesign ugt i64 %.334.i.i.i, 2
  %.390.1.i.i.i = or disjoint i64 %.90.i.i.i, 2
  %.idx.2.i.i.i = shl i64 %.390.1.i.i.i, 4
  %97 = getelementptr double, ptr %.3556.i.i, i64 %.390.1.i.i.i
  %.474.2.i.i.i = getelementptr double, ptr %97, i64 %.460.i.i.i
  %98 = getelementptr double, ptr %.3624.i.i, i64 %.390.1.i.i.i
  %.536.2.i.i.i = getelementptr double, ptr %98, i64 %.460.i.i.i
  %.377.2.not.i.i.i = icmp eq i64 %.334.i.i.i, 3
  %.390.2.i.i.i = or disjoint i64 %.90.i.i.i, 3
  %.idx.3.i.i.i = shl i64 %.390.2.i.i.i, 4
  %99 = getelementptr double, ptr %.3556.i.i, i64 %.390.2.i.i.i
  %.474.3.i.i.i = getelementptr double, ptr %99, i64 %.460.i.i.i
  %100 = getelementptr double, ptr %.3624.i.i, i64 %.390.2.i.i.i
  %.536.3.i.i.i = getelementptr double, ptr %100, i64 %.460.i.i.i
  %.377.3.i.i.i = icmp samesign ugt i64 %.334.i.i.i, 4
  %.390.3.i.i.i = or disjoint i64 %.90.i.i.i, 4
  %.idx.4.i.i.i = shl i64 %.390.3.i.i.i, 4
  %101 = getelementptr double, ptr %.3556.i.i, i64 %.390.3.i.i.i
  %.474.4.i.i.i = getelementptr double, ptr %101, i64 %.460.i.i.i
  %102 = getelementptr double, ptr %.3624.i.i, i64 %.390.3.i.i.i
  %.536.4.i.i.i = getelementptr double, ptr %102, i64 %.460.i.i.i
  %.377.4.not.i.i.i = icmp eq i64 %.334.i.i.i, 5
  %.390.4.i.i.i = or disjoint i64 %.90.i.i.i, 5
  %.idx.5.i.i.i = shl i64 %.390.4.i.i.i, 4
  %103 = getelementptr double, ptr %.3556.i.i, i64 %.390.4.i.i.i
  %.474.5.i.i.i = getelementptr double, ptr %103, i64 %.460.i.i.i
  %104 = getelementptr double, ptr %.3624.i.i, i64 %.390.4.i.i.i
  %.536.5.i.i.i = getelementptr double, ptr %104, i64 %.460.i.i.i
  %.377.5.i.i.i = icmp eq i64 %.334.i.i.i, 7
  %.390.5.i.i.i = or disjoint i64 %.90.i.i.i, 6
  %.idx.6.i.i.i = shl i64 %.390.5.i.i.i, 4
  %105 = getelementptr double, ptr %.3556.i.i, i64 %.390.5.i.i.i
  %.474.6.i.i.i = getelementptr double, ptr %105, i64 %.460.i.i.i
  %106 = getelementptr double, ptr %.3624.i.i, i64 %.390.5.i.i.i
  %.536.6.i.i.i = getelementptr double, ptr %106, i64 %.460.i.i.i
  %107 = inttoptr i64 %.324.i.i to ptr
  %108 = inttoptr i64 %.413.i.i to ptr
  br label %B1010.if.i.i

B622.lr.ph.i.i:                                   ; preds = %B1120.if.i
  %.584.i.i = load i64, ptr %.152.i.i, align 8, !noalias !20
  %.588.i.i = inttoptr i64 %.584.i.i to ptr
  %.663.i.i = getelementptr i8, ptr %.588.i.i, i64 8
  %.664.i.i = load double, ptr %.663.i.i, align 8, !noalias !20
  %.785148387.i.i = add nsw i64 %.108.i.i, -1
  %.1505.i.i = icmp slt i64 %.2169.i, 1
  %109 = shl i64 %.13.i.i, 3
  %.120.i.i.i = lshr exact i64 %.13.i.i, 3
  %.6.i.i.i50.i = insertelement <8 x double> poison, double %.664.i.i, i64 0
  %.7.i.i.i.i = shufflevector <8 x double> %.6.i.i.i50.i, <8 x double> poison, <8 x i32> zeroinitializer
  %110 = add nuw nsw i64 %.120.i.i.i, 4
  %111 = shl i64 %.108.i.i, 13
  %112 = getelementptr i8, ptr %.289.i, i64 %111
  %scevgep19.i.i = getelementptr i8, ptr %112, i64 36864
  br label %B622.i.i

.2175.endif.preheader.i.i:                        ; preds = %B622.i.i
  %.828.i.i = mul i64 %.776.sroa.0.090.i.i, 3
  %.829.i.i = add i64 %.827.i.i, %.828.i.i
  %.848.idx.i.i = shl i64 %.829.i.i, 13
  %.848.i.i = getelementptr i8, ptr %.289.i, i64 %.848.idx.i.i
  %.1152.i.i = getelementptr i8, ptr %.848.i.i, i64 12288
  %.1084.i.i = getelementptr i8, ptr %.848.i.i, i64 8192
  %.916.i.i = getelementptr i8, ptr %.848.i.i, i64 4096
  tail call void @llvm.memset.p0.i64(ptr align 8 %.848.i.i, i8 0, i64 %109, i1 false), !noalias !20
  tail call void @llvm.memset.p0.i64(ptr align 8 %.916.i.i, i8 0, i64 %109, i1 false), !noalias !20
  tail call void @llvm.memset.p0.i64(ptr align 8 %.1084.i.i, i8 0, i64 %109, i1 false), !noalias !20
  tail call void @llvm.memset.p0.i64(ptr align 8 %.1152.i.i, i8 0, i64 %109, i1 false), !noalias !20
  %113 = mul i64 %.776.sroa.0.090.i.i, %.157.1.i.i
  %.2768.i.i = sub i64 %.213211001120.i, %113
  %.2780.i.i = getelementptr double, ptr %.835.sroa.12.1.i, i64 %.2768.i.i
  %114 = mul i64 %.776.sroa.0.090.i.i, 24576
  %scevgep20.i.i = getelementptr i8, ptr %scevgep19.i.i, i64 %114
  br label %B70.if.i.i.i

B70.if.i.i.i:                                     ; preds = %B70.if.i.i.i, %.2175.endif.preheader.i.i
  %lsr.iv18.i.i = phi i64 [ %110, %.2175.endif.preheader.i.i ], [ %lsr.iv.next.i57.i, %B70.if.i.i.i ]
  %lsr.iv170.i.i.i = phi i64 [ 0, %.2175.endif.preheader.i.i ], [ %lsr.iv.next171.i.i.i, %B70.if.i.i.i ]
  %scevgep173.i.i.i = getelementptr i8, ptr %.2780.i.i, i64 %lsr.iv170.i.i.i
  %.189.i.i.i = load <8 x double>, ptr %scevgep173.i.i.i, align 8, !noalias !23
  %.8.i.i.i51.i = fmul contract <8 x double> %.7.i.i.i.i, %.189.i.i.i
  %.219.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i.i.i51.i, <8 x double> splat (double 0x3FE45F306DC9C883), <8 x double> splat (double 0x4338000000000000))
  %.8.i154.i.i.i = fadd contract <8 x double> %.219.i.i.i, splat (double 0xC338000000000000)
  %.260.i.i52.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i154.i.i.i, <8 x double> splat (double 0xBFF921FB54442D18), <8 x double> %.8.i.i.i51.i)
  %.277.i.i53.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i154.i.i.i, <8 x double> splat (double 0xBC91A62633145C07), <8 x double> %.260.i.i52.i)
  %.6.i155.i.i.i = fmul contract <8 x double> %.277.i.i53.i, %.277.i.i53.i
  %.6.i156.i.i.i = fmul contract <8 x double> %.277.i.i53.i, %.6.i155.i.i.i
  %.306.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i155.i.i.i, <8 x double> splat (double 0xBD6AE7F3E733B81F), <8 x double> splat (double 0x3DE6124613A86D09))
  %.309.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i155.i.i.i, <8 x double> %.306.i.i.i, <8 x double> splat (double 0xBE5AE64567F544E4))
  %.312.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i155.i.i.i, <8 x double> %.309.i.i.i, <8 x double> splat (double 0x3EC71DE3A556C734))
  %.315.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i155.i.i.i, <8 x double> %.312.i.i.i, <8 x double> splat (double 0xBF2A01A01A01A01A))
  %.318.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i155.i.i.i, <8 x double> %.315.i.i.i, <8 x double> splat (double 0x3F81111111111111))
  %.321.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i155.i.i.i, <8 x double> %.318.i.i.i, <8 x double> splat (double 0xBFC5555555555555))
  %.346.i.i54.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i156.i.i.i, <8 x double> %.321.i.i.i, <8 x double> %.277.i.i53.i)
  %.351.i.i55.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i155.i.i.i, <8 x double> splat (double 0x3D2AE7F3E733B81F), <8 x double> splat (double 0xBDA93974A8C07C9D))
  %.354.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i155.i.i.i, <8 x double> %.351.i.i55.i, <8 x double> splat (double 0x3E21EED8EFF8D898))
  %.357.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i155.i.i.i, <8 x double> %.354.i.i.i, <8 x double> splat (double 0xBE927E4FB7789F5C))
  %.360.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i155.i.i.i, <8 x double> %.357.i.i.i, <8 x double> splat (double 0x3EFA01A01A01A01A))
  %.363.i.i56.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i155.i.i.i, <8 x double> %.360.i.i.i, <8 x double> splat (double 0xBF56C16C16C16C17))
  %.366.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i155.i.i.i, <8 x double> %.363.i.i56.i, <8 x double> splat (double 0x3FA5555555555555))
  %.369.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i155.i.i.i, <8 x double> %.366.i.i.i, <8 x double> splat (double -5.000000e-01))
  %.372.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i155.i.i.i, <8 x double> %.369.i.i.i, <8 x double> splat (double 1.000000e+00))
  %.373.i.i.i = bitcast <8 x double> %.219.i.i.i to <8 x i64>
  %.374.i.i.i = bitcast <8 x double> %.346.i.i54.i to <8 x i64>
  %.375.i.i.i = bitcast <8 x double> %.372.i.i.i to <8 x i64>
  %.6.i157.i.i.i = xor <8 x i64> %.375.i.i.i, %.374.i.i.i
  %.8.i158.i.i.i = and <8 x i64> %.373.i.i.i, splat (i64 1)
  %115 = icmp eq <8 x i64> %.8.i158.i.i.i, zeroinitializer
  %.6.i160.i.i.i = select <8 x i1> %115, <8 x i64> zeroinitializer, <8 x i64> %.6.i157.i.i.i
  %.8.i161.i.i.i = shl <8 x i64> %.373.i.i.i, splat (i64 62)
  %.8.i162.i.i.i = and <8 x i64> %.8.i161.i.i.i, splat (i64 -9223372036854775808)
  %.8.i164.i.i.i = add <8 x i64> %.8.i161.i.i.i, splat (i64 4611686018427387904)
  %.8.i165.i.i.i = and <8 x i64> %.8.i164.i.i.i, splat (i64 -9223372036854775808)
  %116 = xor <8 x i64> %.8.i162.i.i.i, %.374.i.i.i
  %.6.i167.i.i.i = xor <8 x i64> %116, %.6.i160.i.i.i
  %117 = xor <8 x i64> %.8.i165.i.i.i, %.375.i.i.i
  %.6.i169.i.i.i = xor <8 x i64> %117, %.6.i160.i.i.i
  %scevgep22.i.i = getelementptr i8, ptr %scevgep20.i.i, i64 %lsr.iv170.i.i.i
  %scevgep23.i.i = getelementptr i8, ptr %scevgep22.i.i, i64 -4096
  store <8 x i64> %.6.i169.i.i.i, ptr %scevgep23.i.i, align 8, !noalias !23
  store <8 x i64> %.6.i167.i.i.i, ptr %scevgep22.i.i, align 8, !noalias !23
  %lsr.iv.next171.i.i.i = add i64 %lsr.iv170.i.i.i, 64
  %lsr.iv.next.i57.i = add nsw i64 %lsr.iv18.i.i, -1
  %.141.i.i.i = icmp sgt i64 %lsr.iv18.i.i, 5
  br i1 %.141.i.i.i, label %B70.if.i.i.i, label %.2478.endif.endif.endif.endif.i.i

.2478.endif.endif.endif.endif.i.i:                ; preds = %B70.if.i.i.i, %B622.i.i
  %.786.i.i = icmp sgt i64 %.785148389.i.i, 0
  %.799.i.i = zext i1 %.786.i.i to i64
  %.7921493.i.i = add i64 %.792149388.i.i, %.799.i.i
  %.795.i.i = sext i1 %.786.i.i to i64
  %.7851483.i.i = add nsw i64 %.785148389.i.i, %.795.i.i
  %.776.sroa.0.0.i.i = select i1 %.786.i.i, i64 %.792149388.i.i, i64 0
  br i1 %.786.i.i, label %B622.i.i, label %B980.i.i

B1010.if.i.i:                                     ; preds = %B1012.endif.endif.endif.e...endif.endif.i.i, %B1010.if.lr.ph.i.i
  %.297315131524.i.i = phi i64 [ 0, %B1010.if.lr.ph.i.i ], [ %.2980.i.i, %B1012.endif.endif.endif.e...endif.endif.i.i ]
  %.2980.i.i = add nuw nsw i64 %.297315131524.i.i, 1
  %118 = getelementptr i64, ptr %90, i64 %.297315131524.i.i
  %.3036.i.i = load i64, ptr %118, align 8, !noalias !20
  %.3770.i.i = mul nsw i64 %.297315131524.i.i, %.137.i.i
  %.3772.i.i = add nsw i64 %.3770.i.i, %.213211001120.i
  %.3786.idx.i.i = shl nsw i64 %.3772.i.i, 4
  %.3786.i.i = getelementptr inbounds i8, ptr %91, i64 %.3786.idx.i.i
  br i1 %.176243.not.i.i.i, label %B196.i.i.i, label %B84.if.i.i.i

B196.i.i.i:                                       ; preds = %B84.if.i.i.i, %B1010.if.i.i
  br i1 %.264.not.i.i.i, label %_ZN17bnserve_surrogate7adjoint5_sums5splitB4v118B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i.i, label %B208.i.i.i

B208.i.i.i:                                       ; preds = %B196.i.i.i
  store <8 x double> zeroinitializer, ptr %.276.i.i.i, align 8, !noalias !26
  store <8 x double> zeroinitializer, ptr %.289.i.i.i, align 8, !noalias !26
  br i1 %.377249.not.i.i.i, label %_ZN17bnserve_surrogate7adjoint5_sums5splitB4v118B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i.i, label %B360.if.i.i.i

B84.if.i.i.i:                                     ; preds = %B1010.if.i.i, %B84.if.i.i.i
  %lsr.iv2.i.i.i = phi i64 [ %lsr.iv.next3.i.i.i, %B84.if.i.i.i ], [ %93, %B1010.if.i.i ]
  %lsr.iv1.i.i34.i = phi i64 [ %lsr.iv.next2.i.i36.i, %B84.if.i.i.i ], [ 0, %B1010.if.i.i ]
  %119 = shl nuw i64 %lsr.iv1.i.i34.i, 1
  %scevgep.i.i35.i = getelementptr i8, ptr %.3786.i.i, i64 %119
  %.224.i.i.i = load <16 x double>, ptr %scevgep.i.i35.i, align 8, !noalias !26
  %.225.i.i.i = shufflevector <16 x double> %.224.i.i.i, <16 x double> poison, <8 x i32> <i32 0, i32 2, i32 4, i32 6, i32 8, i32 10, i32 12, i32 14>
  %.226.i.i.i = shufflevector <16 x double> %.224.i.i.i, <16 x double> poison, <8 x i32> <i32 1, i32 3, i32 5, i32 7, i32 9, i32 11, i32 13, i32 15>
  %scevgep4.i.i.i = getelementptr i8, ptr %.3556.i.i, i64 %lsr.iv1.i.i34.i
  store <8 x double> %.225.i.i.i, ptr %scevgep4.i.i.i, align 8, !noalias !26
  %scevgep3.i.i.i = getelementptr i8, ptr %.3624.i.i, i64 %lsr.iv1.i.i34.i
  store <8 x double> %.226.i.i.i, ptr %scevgep3.i.i.i, align 8, !noalias !26
  %lsr.iv.next2.i.i36.i = add nuw nsw i64 %lsr.iv1.i.i34.i, 64
  %lsr.iv.next3.i.i.i = add nsw i64 %lsr.iv2.i.i.i, -1
  %.176.i.i37.i = icmp sgt i64 %lsr.iv2.i.i.i, 5
  br i1 %.176.i.i37.i, label %B84.if.i.i.i, label %B196.i.i.i

B360.if.i.i.i:                                    ; preds = %B208.i.i.i
  %120 = getelementptr i8, ptr %.3786.i.i, i64 %.idx.i.i.i
  %.444.i.i.i = getelementptr double, ptr %120, i64 %.430.i.i.i
  %.445.i.i.i = load double, ptr %.444.i.i.i, align 8, !noalias !26
  store double %.445.i.i.i, ptr %.474.i.i.i, align 8, !noalias !26
  %121 = getelementptr i8, ptr %120, i64 8
  %.506.i.i.i = getelementptr double, ptr %121, i64 %.430.i.i.i
  %.507.i.i.i = load double, ptr %.506.i.i.i, align 8, !noalias !26
  store double %.507.i.i.i, ptr %.536.i.i.i, align 8, !noalias !26
  br i1 %.377.not.i.i.i, label %_ZN17bnserve_surrogate7adjoint5_sums5splitB4v118B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i.i, label %B360.if.1.i.i.i

B360.if.1.i.i.i:                                  ; preds = %B360.if.i.i.i
  %122 = getelementptr i8, ptr %.3786.i.i, i64 %.idx.1.i.i.i
  %.444.1.i.i.i = getelementptr double, ptr %122, i64 %.430.i.i.i
  %.445.1.i.i.i = load double, ptr %.444.1.i.i.i, align 8, !noalias !26
  store double %.445.1.i.i.i, ptr %.474.1.i.i.i, align 8, !noalias !26
  %123 = getelementptr i8, ptr %122, i64 8
  %.506.1.i.i.i = getelementptr double, ptr %123, i64 %.430.i.i.i
  %.507.1.i.i.i = load double, ptr %.506.1.i.i.i, align 8, !noalias !26
  store double %.507.1.i.i.i, ptr %.536.1.i.i.i, align 8, !noalias !26
  br i1 %.377.1.i.i.i, label %B360.if.2.i.i.i, label %_ZN17bnserve_surrogate7adjoint5_sums5splitB4v118B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i.i

B360.if.2.i.i.i:                                  ; preds = %B360.if.1.i.i.i
  %124 = getelementptr i8, ptr %.3786.i.i, i64 %.idx.2.i.i.i
  %.444.2.i.i.i = getelementptr double, ptr %124, i64 %.430.i.i.i
  %.445.2.i.i.i = load double, ptr %.444.2.i.i.i, align 8, !noalias !26
  store double %.445.2.i.i.i, ptr %.474.2.i.i.i, align 8, !noalias !26
  %125 = getelementptr i8, ptr %124, i64 8
  %.506.2.i.i.i = getelementptr double, ptr %125, i64 %.430.i.i.i
  %.507.2.i.i.i = load double, ptr %.506.2.i.i.i, align 8, !noalias !26
  store double %.507.2.i.i.i, ptr %.536.2.i.i.i, align 8, !noalias !26
  br i1 %.377.2.not.i.i.i, label %_ZN17bnserve_surrogate7adjoint5_sums5splitB4v118B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i.i, label %B360.if.3.i.i.i

B360.if.3.i.i.i:                                  ; preds = %B360.if.2.i.i.i
  %126 = getelementptr i8, ptr %.3786.i.i, i64 %.idx.3.i.i.i
  %.444.3.i.i.i = getelementptr double, ptr %126, i64 %.430.i.i.i
  %.445.3.i.i.i = load double, ptr %.444.3.i.i.i, align 8, !noalias !26
  store double %.445.3.i.i.i, ptr %.474.3.i.i.i, align 8, !noalias !26
  %127 = getelementptr i8, ptr %126, i64 8
  %.506.3.i.i.i = getelementptr double, ptr %127, i64 %.430.i.i.i
  %.507.3.i.i.i = load double, ptr %.506.3.i.i.i, align 8, !noalias !26
  store double %.507.3.i.i.i, ptr %.536.3.i.i.i, align 8, !noalias !26
  br i1 %.377.3.i.i.i, label %B360.if.4.i.i.i, label %_ZN17bnserve_surrogate7adjoint5_sums5splitB4v118B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i.i

B360.if.4.i.i.i:                                  ; preds = %B360.if.3.i.i.i
  %128 = getelementptr i8, ptr %.3786.i.i, i64 %.idx.4.i.i.i
  %.444.4.i.i.i = getelementptr double, ptr %128, i64 %.430.i.i.i
  %.445.4.i.i.i = load double, ptr %.444.4.i.i.i, align 8, !noalias !26
  store double %.445.4.i.i.i, ptr %.474.4.i.i.i, align 8, !noalias !26
  %129 = getelementptr i8, ptr %128, i64 8
  %.506.4.i.i.i = getelementptr double, ptr %129, i64 %.430.i.i.i
  %.507.4.i.i.i = load double, ptr %.506.4.i.i.i, align 8, !noalias !26
  store double %.507.4.i.i.i, ptr %.536.4.i.i.i, align 8, !noalias !26
  br i1 %.377.4.not.i.i.i, label %_ZN17bnserve_surrogate7adjoint5_sums5splitB4v118B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i.i, label %B360.if.5.i.i.i

B360.if.5.i.i.i:                                  ; preds = %B360.if.4.i.i.i
  %130 = getelementptr i8, ptr %.3786.i.i, i64 %.idx.5.i.i.i
  %.444.5.i.i.i = getelementptr double, ptr %130, i64 %.430.i.i.i
  %.445.5.i.i.i = load double, ptr %.444.5.i.i.i, align 8, !noalias !26
  store double %.445.5.i.i.i, ptr %.474.5.i.i.i, align 8, !noalias !26
  %131 = getelementptr i8, ptr %130, i64 8
  %.506.5.i.i.i = getelementptr double, ptr %131, i64 %.430.i.i.i
  %.507.5.i.i.i = load double, ptr %.506.5.i.i.i, align 8, !noalias !26
  store double %.507.5.i.i.i, ptr %.536.5.i.i.i, align 8, !noalias !26
  br i1 %.377.5.i.i.i, label %B360.if.6.i.i.i, label %_ZN17bnserve_surrogate7adjoint5_sums5splitB4v118B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i.i

B360.if.6.i.i.i:                                  ; preds = %B360.if.5.i.i.i
  %132 = getelementptr i8, ptr %.3786.i.i, i64 %.idx.6.i.i.i
  %.444.6.i.i.i = getelementptr double, ptr %132, i64 %.430.i.i.i
  %.445.6.i.i.i = load double, ptr %.444.6.i.i.i, align 8, !noalias !26
  store double %.445.6.i.i.i, ptr %.474.6.i.i.i, align 8, !noalias !26
  %133 = getelementptr i8, ptr %132, i64 8
  %.506.6.i.i.i = getelementptr double, ptr %133, i64 %.430.i.i.i
  %.507.6.i.i.i = load double, ptr %.506.6.i.i.i, align 8, !noalias !26
  store double %.507.6.i.i.i, ptr %.536.6.i.i.i, align 8, !noalias !26
  br label %_ZN17bnserve_surrogate7adjoint5_sums5splitB4v118B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i.i

_ZN17bnserve_surrogate7adjoint5_sums5splitB4v118B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i.i: ; preds = %B360.if.6.i.i.i, %B360.if.5.i.i.i, %B360.if.4.i.i.i, %B360.if.3.i.i.i, %B360.if.2.i.i.i, %B360.if.1.i.i.i, %B360.if.i.i.i, %B208.i.i.i, %B196.i.i.i
  br i1 %.114.inv.i.i.i, label %B1012.endif.endif.endif.e...endif.endif.i.i, label %B70.if.lr.ph.i.i.i

B70.if.lr.ph.i.i.i:                               ; preds = %_ZN17bnserve_surrogate7adjoint5_sums5splitB4v118B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i.i
  %134 = getelementptr double, ptr %107, i64 %.297315131524.i.i
  %.3901.i.i = load double, ptr %134, align 8, !noalias !20
  %.232.i.i.i = insertelement <8 x double> poison, double %.3901.i.i, i64 0
  %.233.i.i.i = shufflevector <8 x double> %.232.i.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %135 = mul i64 %.3036.i.i, 24576
  br label %B70.if.i189.i.i

B70.if.i189.i.i:                                  ; preds = %B70.if.i189.i.i, %B70.if.lr.ph.i.i.i
  %lsr.iv8.i.i = phi i64 [ %lsr.iv.next9.i.i, %B70.if.i189.i.i ], [ %89, %B70.if.lr.ph.i.i.i ]
  %lsr.iv.i38.i = phi ptr [ %scevgep.i44.i, %B70.if.i189.i.i ], [ %.3556.i.i, %B70.if.lr.ph.i.i.i ]
  %.205.i.i.i = load <8 x double>, ptr %lsr.iv.i38.i, align 8, !noalias !29
  %scevgep391.i.i = getelementptr i8, ptr %lsr.iv.i38.i, i64 4096
  %.215.i.i39.i = load <8 x double>, ptr %scevgep391.i.i, align 8, !noalias !29
  %sunkaddr.i40.i = getelementptr i8, ptr %lsr.iv.i38.i, i64 %135
  %sunkaddr24.i.i = getelementptr i8, ptr %sunkaddr.i40.i, i64 16384
  %.227.i.i.i = load <8 x double>, ptr %sunkaddr24.i.i, align 8, !noalias !29
  %.230.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.215.i.i39.i, <8 x double> splat (double -0.000000e+00), <8 x double> %.227.i.i.i)
  %.234.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.205.i.i.i, <8 x double> %.233.i.i.i, <8 x double> %.230.i.i.i)
  store <8 x double> %.234.i.i.i, ptr %sunkaddr24.i.i, align 8, !noalias !29
  %sunkaddr26.i.i = getelementptr i8, ptr %sunkaddr.i40.i, i64 20480
  %.254.i.i41.i = load <8 x double>, ptr %sunkaddr26.i.i, align 8, !noalias !29
  %.258.i.i42.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.205.i.i.i, <8 x double> zeroinitializer, <8 x double> %.254.i.i41.i)
  %.262.i.i43.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.215.i.i39.i, <8 x double> %.233.i.i.i, <8 x double> %.258.i.i42.i)
  store <8 x double> %.262.i.i43.i, ptr %sunkaddr26.i.i, align 8, !noalias !29
  %scevgep.i44.i = getelementptr i8, ptr %lsr.iv.i38.i, i64 64
  %lsr.iv.next9.i.i = add nsw i64 %lsr.iv8.i.i, -1
  %.158.i.i.i = icmp sgt i64 %lsr.iv8.i.i, 5
  br i1 %.158.i.i.i, label %B70.if.i189.i.i, label %B1012.endif.endif.endif.e...endif.i.i

B1012.endif.endif.endif.e...endif.i.i:            ; preds = %B70.if.i189.i.i
  %.idx.i45.i = shl i64 %.297315131524.i.i, 4
  %136 = getelementptr i8, ptr %108, i64 %.idx.i45.i
  %137 = getelementptr i8, ptr %136, i64 8
  %.4003.i.i = load double, ptr %137, align 8, !noalias !20
  %.3971.i.i = load double, ptr %136, align 8, !noalias !20
  %.217.i.i.i = fneg contract double %.4003.i.i
  %.228.i.i.i = insertelement <8 x double> poison, double %.217.i.i.i, i64 0
  %.229.i.i.i = shufflevector <8 x double> %.228.i.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.232.i198.i.i = insertelement <8 x double> poison, double %.3971.i.i, i64 0
  %.233.i199.i.i = shufflevector <8 x double> %.232.i198.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.256.i.i46.i = insertelement <8 x double> poison, double %.4003.i.i, i64 0
  %.257.i.i47.i = shufflevector <8 x double> %.256.i.i46.i, <8 x double> poison, <8 x i32> zeroinitializer
  br label %B70.if.i200.i.i

B70.if.i200.i.i:                                  ; preds = %B70.if.i200.i.i, %B1012.endif.endif.endif.e...endif.i.i
  %lsr.iv13.i.i = phi i64 [ %lsr.iv.next14.i.i, %B70.if.i200.i.i ], [ %89, %B1012.endif.endif.endif.e...endif.i.i ]
  %lsr.iv393.i.i = phi ptr [ %scevgep394.i.i, %B70.if.i200.i.i ], [ %.3556.i.i, %B1012.endif.endif.endif.e...endif.i.i ]
  %.205.i204.i.i = load <8 x double>, ptr %lsr.iv393.i.i, align 8, !noalias !32
  %scevgep398.i.i = getelementptr i8, ptr %lsr.iv393.i.i, i64 4096
  %.215.i206.i.i = load <8 x double>, ptr %scevgep398.i.i, align 8, !noalias !32
  %sunkaddr27.i48.i = getelementptr i8, ptr %lsr.iv393.i.i, i64 %135
  %sunkaddr28.i.i = getelementptr i8, ptr %sunkaddr27.i48.i, i64 24576
  %.227.i208.i.i = load <8 x double>, ptr %sunkaddr28.i.i, align 8, !noalias !32
  %.230.i209.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.215.i206.i.i, <8 x double> %.229.i.i.i, <8 x double> %.227.i208.i.i)
  %.234.i210.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.205.i204.i.i, <8 x double> %.233.i199.i.i, <8 x double> %.230.i209.i.i)
  store <8 x double> %.234.i210.i.i, ptr %sunkaddr28.i.i, align 8, !noalias !32
  %sunkaddr30.i.i = getelementptr i8, ptr %sunkaddr27.i48.i, i64 28672
  %.254.i212.i.i = load <8 x double>, ptr %sunkaddr30.i.i, align 8, !noalias !32
  %.258.i213.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.205.i204.i.i, <8 x double> %.257.i.i47.i, <8 x double> %.254.i212.i.i)
  %.262.i214.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.215.i206.i.i, <8 x double> %.233.i199.i.i, <8 x double> %.258.i213.i.i)
  store <8 x double> %.262.i214.i.i, ptr %sunkaddr30.i.i, align 8, !noalias !32
  %scevgep394.i.i = getelementptr i8, ptr %lsr.iv393.i.i, i64 64
  %lsr.iv.next14.i.i = add nsw i64 %lsr.iv13.i.i, -1
  %.158.i217.i.i = icmp sgt i64 %lsr.iv13.i.i, 5
  br i1 %.158.i217.i.i, label %B70.if.i200.i.i, label %B1012.endif.endif.endif.e...endif.endif.i.i

B1012.endif.endif.endif.e...endif.endif.i.i:      ; preds = %B70.if.i200.i.i, %_ZN17bnserve_surrogate7adjoint5_sums5splitB4v118B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i.i
  %exitcond.not.i49.i = icmp eq i64 %.2980.i.i, %.79.i30.i
  br i1 %exitcond.not.i49.i, label %_ZN17bnserve_inference13moving_kernel7_source9_polariseB3v77B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i, label %B1010.if.i.i

_ZN17bnserve_inference13moving_kernel7_source9_polariseB3v77B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i: ; preds = %B1012.endif.endif.endif.e...endif.endif.i.i, %B980.i.i
  br i1 %86, label %B1120.loopexit.i, label %B1242.if.preheader.i

B1242.if.preheader.i:                             ; preds = %_ZN17bnserve_inference13moving_kernel7_source9_polariseB3v77B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i
  %.201.i.i.i = lshr exact i64 %.13.i.i, 3
  %.178.inv.i.i.i = icmp slt i64 %.2169.i, 1
  %138 = shl i64 %.13.i.i, 3
  %139 = add nuw nsw i64 %.201.i.i.i, 4
  %.104.i.i.i = icmp sgt i64 %.2169.i, 0
  %unroll_iter.i.i.i = and i64 %.13.i.i, 9223372036854775800
  %140 = add nsw i64 %unroll_iter.i.i.i, -2
  %141 = lshr exact i64 %140, 1
  %142 = add nuw i64 %141, 1
  %143 = shl i64 %.213211001120.i, 3
  br label %B1242.if.i

B1242.if.i:                                       ; preds = %B1242.backedge.i, %B1242.if.preheader.i
  %.232410861091.i = phi i64 [ %.2331.i, %B1242.backedge.i ], [ 0, %B1242.if.preheader.i ]
  %.2331.i = add nuw nsw i64 %.232410861091.i, 1
  %.2368.idx.i = mul nuw nsw i64 %.232410861091.i, 200
  %.2368.i = getelementptr inbounds nuw i8, ptr %.155.i, i64 %.2368.idx.i
  call void @llvm.lifetime.start.p0(ptr nonnull %.2081.i.i), !noalias !0
  call void @llvm.lifetime.start.p0(ptr nonnull %.2136.i.i), !noalias !0
  store ptr null, ptr %.2081.i.i, align 8, !noalias !35
  store ptr null, ptr %.2136.i.i, align 8, !noalias !35
  %.87.i.i = load i64, ptr %.76.i, align 8, !noalias !35
  %.118.i.i = load i64, ptr %.106.i, align 8, !noalias !35
  %.119.i.i = sub i64 0, %.118.i.i
  %.127.1.i.i = and i64 %.119.i.i, -8
  %.161.i.i = sub i64 0, %.127.1.i.i
  %.199.i.i = load i64, ptr %.198.i.i, align 8, !noalias !35
  %.201.i.i = inttoptr i64 %.199.i.i to ptr
  %.265.i58.i = getelementptr double, ptr %.201.i.i, i64 %.213211001120.i
  %.360.i.i = icmp sgt i64 %.87.i.i, 0
  br i1 %.360.i.i, label %B226.if.lr.ph.i.i, label %B812.i.i

B546.i.i:                                         ; preds = %B226.if.i.i
  br i1 %.178.inv.i.i.i, label %B768.endif.i.critedge238.i, label %.1723.endif.preheader.i.i, !prof !19

B722.i.i:                                         ; preds = %B226.if.i.i
  br i1 %.178.inv.i.i.i, label %B768.endif.i.i, label %B70.if.i.i76.i

B70.if.i.i76.i:                                   ; preds = %B722.i.i, %B70.if.i.i76.i
  %lsr.iv35.i.i = phi i64 [ %lsr.iv.next36.i.i, %B70.if.i.i76.i ], [ %139, %B722.i.i ]
  %lsr.iv445.i.i = phi ptr [ %scevgep446.i.i, %B70.if.i.i76.i ], [ %.289.i, %B722.i.i ]
  %scevgep461.i.i = getelementptr i8, ptr %lsr.iv445.i.i, i64 %lsr.iv450.i.i
  %scevgep462.i.i = getelementptr i8, ptr %scevgep461.i.i, i64 -4096
  %.269.i.i.i = load <8 x double>, ptr %scevgep462.i.i, align 8, !noalias !38
  %.279.i.i.i = load <8 x double>, ptr %scevgep461.i.i, align 8, !noalias !38
  %.6.i.i.i77.i = fmul contract <8 x double> %.279.i.i.i, %.279.i.i.i
  %.8.i.i.i78.i = fsub contract <8 x double> zeroinitializer, %.6.i.i.i77.i
  %.328.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.269.i.i.i, <8 x double> %.269.i.i.i, <8 x double> %.8.i.i.i78.i)
  %.8.i22.i.i.i = fmul contract <8 x double> %.269.i.i.i, splat (double 2.000000e+00)
  %.6.i23.i.i.i = fmul contract <8 x double> %.8.i22.i.i.i, %.279.i.i.i
  %.411.i.i.i = load double, ptr %sunkaddr50.i.i, align 8, !noalias !38
  %.441.i.i.i = load double, ptr %sunkaddr51.i71.i, align 8, !noalias !38
  %.471.i.i.i = load double, ptr %sunkaddr.i72.i, align 8, !noalias !38
  %.501.i.i.i = load double, ptr %sunkaddr52.i73.i, align 8, !noalias !38
  %.530.i.i79.i = load double, ptr %sunkaddr53.i74.i, align 8, !noalias !38
  %.534.i.i.i = insertelement <8 x double> poison, double %.501.i.i.i, i64 0
  %.535.i.i.i = shufflevector <8 x double> %.534.i.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.536.i.i80.i = insertelement <8 x double> poison, double %.530.i.i79.i, i64 0
  %.537.i.i.i = shufflevector <8 x double> %.536.i.i80.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.538.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i23.i.i.i, <8 x double> %.535.i.i.i, <8 x double> %.537.i.i.i)
  %.539.i.i.i = insertelement <8 x double> poison, double %.471.i.i.i, i64 0
  %.540.i.i.i = shufflevector <8 x double> %.539.i.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.541.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.328.i.i.i, <8 x double> %.540.i.i.i, <8 x double> %.538.i.i.i)
  %.542.i.i81.i = insertelement <8 x double> poison, double %.441.i.i.i, i64 0
  %.543.i.i.i = shufflevector <8 x double> %.542.i.i81.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.544.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.279.i.i.i, <8 x double> %.543.i.i.i, <8 x double> %.541.i.i.i)
  %.545.i.i.i = insertelement <8 x double> poison, double %.411.i.i.i, i64 0
  %.546.i.i.i = shufflevector <8 x double> %.545.i.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.547.i.i82.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.269.i.i.i, <8 x double> %.546.i.i.i, <8 x double> %.544.i.i.i)
  %.582.i.i.i = load double, ptr %sunkaddr54.i.i, align 8, !noalias !38
  %.612.i.i.i = load double, ptr %sunkaddr55.i.i, align 8, !noalias !38
  %.642.i.i83.i = load double, ptr %sunkaddr56.i.i, align 8, !noalias !38
  %.672.i.i84.i = load double, ptr %sunkaddr57.i.i, align 8, !noalias !38
  %.701.i.i85.i = load double, ptr %sunkaddr58.i.i, align 8, !noalias !38
  %.705.i.i86.i = insertelement <8 x double> poison, double %.672.i.i84.i, i64 0
  %.706.i.i87.i = shufflevector <8 x double> %.705.i.i86.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.707.i.i88.i = insertelement <8 x double> poison, double %.701.i.i85.i, i64 0
  %.708.i.i89.i = shufflevector <8 x double> %.707.i.i88.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.709.i.i90.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i23.i.i.i, <8 x double> %.706.i.i87.i, <8 x double> %.708.i.i89.i)
  %.710.i.i91.i = insertelement <8 x double> poison, double %.642.i.i83.i, i64 0
  %.711.i.i92.i = shufflevector <8 x double> %.710.i.i91.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.712.i.i93.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.328.i.i.i, <8 x double> %.711.i.i92.i, <8 x double> %.709.i.i90.i)
  %.713.i.i94.i = insertelement <8 x double> poison, double %.612.i.i.i, i64 0
  %.714.i.i95.i = shufflevector <8 x double> %.713.i.i94.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.715.i.i96.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.279.i.i.i, <8 x double> %.714.i.i95.i, <8 x double> %.712.i.i93.i)
  %.716.i.i.i = insertelement <8 x double> poison, double %.582.i.i.i, i64 0
  %.717.i.i.i = shufflevector <8 x double> %.716.i.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.718.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.269.i.i.i, <8 x double> %.717.i.i.i, <8 x double> %.715.i.i96.i)
  %scevgep44.i.i = getelementptr i8, ptr %scevgep461.i.i, i64 -20480
  %.728.i.i.i = load <8 x double>, ptr %scevgep44.i.i, align 8, !noalias !38
  %scevgep42.i.i = getelementptr i8, ptr %scevgep461.i.i, i64 -12288
  %.738.i.i.i = load <8 x double>, ptr %scevgep42.i.i, align 8, !noalias !38
  %.6.i24.i.i.i = fmul contract <8 x double> %.738.i.i.i, %.718.i.i.i
  %.763.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.547.i.i82.i, <8 x double> %.728.i.i.i, <8 x double> %.6.i24.i.i.i)
  %scevgep448.i.i = getelementptr i8, ptr %lsr.iv445.i.i, i64 %lsr.iv443.i.i
  %scevgep449.i.i = getelementptr i8, ptr %scevgep448.i.i, i64 -4096
  store <8 x double> %.763.i.i.i, ptr %scevgep449.i.i, align 8, !noalias !38
  %scevgep40.i.i = getelementptr i8, ptr %scevgep461.i.i, i64 -16384
  %.783.i.i.i = load <8 x double>, ptr %scevgep40.i.i, align 8, !noalias !38
  %scevgep38.i.i = getelementptr i8, ptr %scevgep461.i.i, i64 -8192
  %.793.i.i.i = load <8 x double>, ptr %scevgep38.i.i, align 8, !noalias !38
  %.6.i25.i.i.i = fmul contract <8 x double> %.793.i.i.i, %.718.i.i.i
  %.818.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.547.i.i82.i, <8 x double> %.783.i.i.i, <8 x double> %.6.i25.i.i.i)
  store <8 x double> %.818.i.i.i, ptr %scevgep448.i.i, align 8, !noalias !38
  %scevgep446.i.i = getelementptr i8, ptr %lsr.iv445.i.i, i64 64
  %lsr.iv.next36.i.i = add nsw i64 %lsr.iv35.i.i, -1
  %.222.i.i.i = icmp sgt i64 %lsr.iv35.i.i, 5
  br i1 %.222.i.i.i, label %B70.if.i.i76.i, label %B178.if.lr.ph.i.i.i

B178.if.lr.ph.i.i.i:                              ; preds = %B70.if.i.i76.i, %.1723.endif.preheader.i.i
  %.115.i.i.i = load double, ptr %sunkaddr59.i.i, align 8, !noalias !41
  %.116.i.i97.i = fmul contract double %.115.i.i.i, 0xC01921FB54442D18
  %.146.i.i98.i = load double, ptr %sunkaddr60.i.i, align 8, !noalias !41
  %.150.i.i.i = fmul contract double %.146.i.i98.i, 0xC01921FB54442D18
  %.368.i.i.i = insertelement <8 x double> poison, double %.150.i.i.i, i64 0
  %.369.i.i99.i = shufflevector <8 x double> %.368.i.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.6.i.i81.i.i = insertelement <8 x double> poison, double %.116.i.i97.i, i64 0
  %.7.i.i.i100.i = shufflevector <8 x double> %.6.i.i81.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  br label %B178.if.i.i.i

B178.if.i.i.i:                                    ; preds = %B178.if.i.i.i, %B178.if.lr.ph.i.i.i
  %lsr.iv45.i.i = phi i64 [ %lsr.iv.next46.i.i, %B178.if.i.i.i ], [ %139, %B178.if.lr.ph.i.i.i ]
  %lsr.iv275.i.i.i = phi i64 [ %lsr.iv.next276.i.i.i, %B178.if.i.i.i ], [ 0, %B178.if.lr.ph.i.i.i ]
  %scevgep280.i.i.i = getelementptr i8, ptr %.265.i58.i, i64 %lsr.iv275.i.i.i
  %.297.i.i.i = load <8 x double>, ptr %scevgep280.i.i.i, align 8, !noalias !41
  %scevgep476.i.i = getelementptr i8, ptr %lsr.iv472.i.i, i64 %lsr.iv275.i.i.i
  %.307.i.i.i = load <8 x double>, ptr %scevgep476.i.i, align 8, !noalias !41
  %scevgep475.i.i = getelementptr i8, ptr %scevgep476.i.i, i64 -4096
  %.317.i.i.i = load <8 x double>, ptr %scevgep475.i.i, align 8, !noalias !41
  %.8.i.i83.i.i = fsub contract <8 x double> splat (double 1.000000e+00), %.317.i.i.i
  %.8.i254.i.i.i = fmul contract <8 x double> %.7.i.i.i100.i, %.8.i.i83.i.i
  %.370.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.307.i.i.i, <8 x double> %.369.i.i99.i, <8 x double> %.8.i254.i.i.i)
  %.6.i255.i.i.i = fmul contract <8 x double> %.297.i.i.i, %.370.i.i.i
  %.399.i.i101.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i255.i.i.i, <8 x double> splat (double 0x3FE45F306DC9C883), <8 x double> splat (double 0x4338000000000000))
  %.8.i256.i.i.i = fadd contract <8 x double> %.399.i.i101.i, splat (double 0xC338000000000000)
  %.440.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i256.i.i.i, <8 x double> splat (double 0xBFF921FB54442D18), <8 x double> %.6.i255.i.i.i)
  %.457.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i256.i.i.i, <8 x double> splat (double 0xBC91A62633145C07), <8 x double> %.440.i.i.i)
  %.6.i257.i.i.i = fmul contract <8 x double> %.457.i.i.i, %.457.i.i.i
  %.6.i258.i.i.i = fmul contract <8 x double> %.457.i.i.i, %.6.i257.i.i.i
  %.486.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i257.i.i.i, <8 x double> splat (double 0xBD6AE7F3E733B81F), <8 x double> splat (double 0x3DE6124613A86D09))
  %.489.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i257.i.i.i, <8 x double> %.486.i.i.i, <8 x double> splat (double 0xBE5AE64567F544E4))
  %.492.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i257.i.i.i, <8 x double> %.489.i.i.i, <8 x double> splat (double 0x3EC71DE3A556C734))
  %.495.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i257.i.i.i, <8 x double> %.492.i.i.i, <8 x double> splat (double 0xBF2A01A01A01A01A))
  %.498.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i257.i.i.i, <8 x double> %.495.i.i.i, <8 x double> splat (double 0x3F81111111111111))
  %.501.i84.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i257.i.i.i, <8 x double> %.498.i.i.i, <8 x double> splat (double 0xBFC5555555555555))
  %.526.i.i102.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i258.i.i.i, <8 x double> %.501.i84.i.i, <8 x double> %.457.i.i.i)
  %.531.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i257.i.i.i, <8 x double> splat (double 0x3D2AE7F3E733B81F), <8 x double> splat (double 0xBDA93974A8C07C9D))
  %.534.i85.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i257.i.i.i, <8 x double> %.531.i.i.i, <8 x double> splat (double 0x3E21EED8EFF8D898))
  %.537.i86.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i257.i.i.i, <8 x double> %.534.i85.i.i, <8 x double> splat (double 0xBE927E4FB7789F5C))
  %.540.i87.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i257.i.i.i, <8 x double> %.537.i86.i.i, <8 x double> splat (double 0x3EFA01A01A01A01A))
  %.543.i88.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i257.i.i.i, <8 x double> %.540.i87.i.i, <8 x double> splat (double 0xBF56C16C16C16C17))
  %.546.i89.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i257.i.i.i, <8 x double> %.543.i88.i.i, <8 x double> splat (double 0x3FA5555555555555))
  %.549.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i257.i.i.i, <8 x double> %.546.i89.i.i, <8 x double> splat (double -5.000000e-01))
  %.552.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i257.i.i.i, <8 x double> %.549.i.i.i, <8 x double> splat (double 1.000000e+00))
  %.553.i.i103.i = bitcast <8 x double> %.399.i.i101.i to <8 x i64>
  %.554.i.i.i = bitcast <8 x double> %.526.i.i102.i to <8 x i64>
  %.555.i.i104.i = bitcast <8 x double> %.552.i.i.i to <8 x i64>
  %.6.i259.i.i.i = xor <8 x i64> %.555.i.i104.i, %.554.i.i.i
  %.8.i260.i.i.i = and <8 x i64> %.553.i.i103.i, splat (i64 1)
  %144 = icmp eq <8 x i64> %.8.i260.i.i.i, zeroinitializer
  %.6.i262.i.i.i = select <8 x i1> %144, <8 x i64> zeroinitializer, <8 x i64> %.6.i259.i.i.i
  %.8.i263.i.i.i = shl <8 x i64> %.553.i.i103.i, splat (i64 62)
  %.8.i264.i.i.i = and <8 x i64> %.8.i263.i.i.i, splat (i64 -9223372036854775808)
  %.8.i266.i.i.i = add <8 x i64> %.8.i263.i.i.i, splat (i64 4611686018427387904)
  %.8.i267.i.i.i = and <8 x i64> %.8.i266.i.i.i, splat (i64 -9223372036854775808)
  %145 = xor <8 x i64> %.8.i264.i.i.i, %.554.i.i.i
  %.6.i269.i.i.i = xor <8 x i64> %145, %.6.i262.i.i.i
  %146 = bitcast <8 x i64> %.6.i269.i.i.i to <8 x double>
  %147 = xor <8 x i64> %.8.i267.i.i.i, %.555.i.i104.i
  %.6.i271.i.i.i = xor <8 x i64> %147, %.6.i262.i.i.i
  %148 = bitcast <8 x i64> %.6.i271.i.i.i to <8 x double>
  %scevgep469.i.i = getelementptr i8, ptr %lsr.iv466.i.i, i64 %lsr.iv275.i.i.i
  %scevgep470.i.i = getelementptr i8, ptr %scevgep469.i.i, i64 -4096
  %.900.i.i.i = load <8 x double>, ptr %scevgep470.i.i, align 8, !noalias !41
  %.910.i.i105.i = load <8 x double>, ptr %scevgep469.i.i, align 8, !noalias !41
  %.6.i272.i.i.i = fmul contract <8 x double> %.910.i.i105.i, %146
  %.8.i273.i.i.i = fsub contract <8 x double> zeroinitializer, %.6.i272.i.i.i
  %.6.i274.i.i.i = fmul contract <8 x double> %.910.i.i105.i, %148
  %.959.i.i106.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.900.i.i.i, <8 x double> %148, <8 x double> %.8.i273.i.i.i)
  %.984.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.900.i.i.i, <8 x double> %146, <8 x double> %.6.i274.i.i.i)
  store <8 x double> %.959.i.i106.i, ptr %scevgep470.i.i, align 8, !noalias !41
  store <8 x double> %.984.i.i.i, ptr %scevgep469.i.i, align 8, !noalias !41
  %lsr.iv.next276.i.i.i = add i64 %lsr.iv275.i.i.i, 64
  %lsr.iv.next46.i.i = add nsw i64 %lsr.iv45.i.i, -1
  %.249.i.i107.i = icmp sgt i64 %lsr.iv45.i.i, 5
  br i1 %.249.i.i107.i, label %B178.if.i.i.i, label %B768.endif.i.i

B812.i.i:                                         ; preds = %B768.endif.i.i, %B1242.if.i
  %.2381.i.i = load i64, ptr %.2380.i.i, align 8, !noalias !35
  %.2386.i.i = icmp sgt i64 %.2381.i.i, 0
  br i1 %.2386.i.i, label %B860.i.i, label %_ZN17bnserve_inference13moving_kernel7_source8_respondB4v120B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i

B860.i.i:                                         ; preds = %B812.i.i
  %.2389.i.i = shl nsw i64 %.2381.i.i, 3
  %.2419.i.i = load i64, ptr %arg.arguments, align 8, !noalias !35
  %.2421.i.i = mul nsw i64 %.2419.i.i, %.631.sroa.0.073.i
  %.2425.i.i = add nsw i64 %.2421.i.i, %.232410861091.i
  %.2428.i.i = mul nsw i64 %.2425.i.i, %.2389.i.i
  %.2459.i.i = load i64, ptr %.2458.i.i, align 8, !noalias !35
  %.2462.i.i = mul nsw i64 %.2381.i.i, %.161.i.i
  %.2531.idx.i.i = shl i64 %.87.i.i, 13
  %.2531.i.i = getelementptr i8, ptr %.289.i, i64 %.2531.idx.i.i
  %.2599.i.i = getelementptr i8, ptr %.2531.i.i, i64 4096
  %.2785.i.i = load i64, ptr %.2784.i.i, align 8, !noalias !35
  %.2786.i.i = add nsw i64 %.2428.i.i, %.2785.i.i
  br i1 %.104.i.i.i, label %B60.if.preheader.i.i.i, label %B128.if.lr.ph.i.i.i

B226.if.lr.ph.i.i:                                ; preds = %B1242.if.i
  %.685.i.i = add nuw nsw i64 %.87.i.i, 2
  %149 = shl i64 %.87.i.i, 13
  %150 = add i64 %149, 36864
  %scevgep471.i.i = getelementptr i8, ptr %.289.i, i64 %150
  %sunkaddr61.i.i = getelementptr i8, ptr %.2368.i, i64 160
  %sunkaddr50.i.i = getelementptr i8, ptr %.2368.i, i64 16
  %sunkaddr51.i71.i = getelementptr i8, ptr %.2368.i, i64 24
  %sunkaddr.i72.i = getelementptr i8, ptr %.2368.i, i64 32
  %sunkaddr52.i73.i = getelementptr i8, ptr %.2368.i, i64 40
  %sunkaddr53.i74.i = getelementptr i8, ptr %.2368.i, i64 8
  %sunkaddr54.i.i = getelementptr i8, ptr %.2368.i, i64 56
  %sunkaddr55.i.i = getelementptr i8, ptr %.2368.i, i64 64
  %sunkaddr56.i.i = getelementptr i8, ptr %.2368.i, i64 72
  %sunkaddr57.i.i = getelementptr i8, ptr %.2368.i, i64 80
  %sunkaddr58.i.i = getelementptr i8, ptr %.2368.i, i64 48
  %sunkaddr59.i.i = getelementptr i8, ptr %.2368.i, i64 88
  %sunkaddr60.i.i = getelementptr i8, ptr %.2368.i, i64 96
  br label %B226.if.i.i

B226.if.i.i:                                      ; preds = %B768.endif.i.i, %B226.if.lr.ph.i.i
  %lsr.iv472.i.i = phi ptr [ %scevgep471.i.i, %B226.if.lr.ph.i.i ], [ %scevgep473.i.i, %B768.endif.i.i ]
  %lsr.iv466.i.i = phi ptr [ %scevgep465.i.i, %B226.if.lr.ph.i.i ], [ %scevgep467.i.i, %B768.endif.i.i ]
  %lsr.iv450.i.i = phi i64 [ %150, %B226.if.lr.ph.i.i ], [ %lsr.iv.next451.i.i, %B768.endif.i.i ]
  %lsr.iv443.i.i = phi i64 [ 4096, %B226.if.lr.ph.i.i ], [ %lsr.iv.next444.i.i, %B768.endif.i.i ]
  %.346.0.i.i = phi i64 [ 0, %B226.if.lr.ph.i.i ], [ %.415.i.i, %B768.endif.i.i ]
  %.415.i.i = add nuw nsw i64 %.346.0.i.i, 1
  %.459.idx.i.i = shl i64 %.346.0.i.i, 13
  %.459.i75.i = getelementptr i8, ptr %.289.i, i64 %.459.idx.i.i
  %.527.i.i = getelementptr i8, ptr %.459.i75.i, i64 4096
  %.686.i.i = mul nuw nsw i64 %.346.0.i.i, 3
  %.687.i.i = add nuw nsw i64 %.685.i.i, %.686.i.i
  %.706.idx.i.i = shl i64 %.687.i.i, 13
  %.706.i.i = getelementptr i8, ptr %.289.i, i64 %.706.idx.i.i
  %.774.i.i = getelementptr i8, ptr %.706.i.i, i64 4096
  %.954.i.i = getelementptr i8, ptr %.706.i.i, i64 8192
  %.1022.i.i = getelementptr i8, ptr %.706.i.i, i64 12288
  %.1202.i.i = getelementptr i8, ptr %.706.i.i, i64 16384
  %.1270.i.i = getelementptr i8, ptr %.706.i.i, i64 20480
  %.1455.i.i = load double, ptr %sunkaddr61.i.i, align 8, !noalias !35
  %.1456.i.i = fcmp contract ogt double %.1455.i.i, 0.000000e+00
  br i1 %.1456.i.i, label %B546.i.i, label %B722.i.i

.1723.endif.preheader.i.i:                        ; preds = %B546.i.i
  tail call void @llvm.memset.p0.i64(ptr align 8 %.459.i75.i, i8 0, i64 %138, i1 false), !noalias !35
  tail call void @llvm.memset.p0.i64(ptr align 8 %.527.i.i, i8 0, i64 %138, i1 false), !noalias !35
  store ptr null, ptr %.2081.i.i, align 8, !noalias !35
  call fastcc void @inner_0(ptr nonnull %.2081.i.i, ptr readonly %.2368.i, i64 17, double 1.000000e+00, ptr %.265.i58.i, ptr %.1202.i.i, i64 range(i64 -9223372036854775799, 513) %.13.i.i, ptr %.1270.i.i, ptr %.706.i.i, ptr %.774.i.i, ptr %.954.i.i, ptr %.1022.i.i, ptr %.459.i75.i, ptr %.527.i.i)
  store ptr null, ptr %.2136.i.i, align 8, !noalias !35
  call fastcc void @inner_0(ptr nonnull %.2136.i.i, ptr readonly %.2368.i, i64 21, double -1.000000e+00, ptr %.265.i58.i, ptr %.1202.i.i, i64 range(i64 -9223372036854775799, 513) %.13.i.i, ptr %.1270.i.i, ptr %.706.i.i, ptr %.774.i.i, ptr %.954.i.i, ptr %.1022.i.i, ptr %.459.i75.i, ptr %.527.i.i)
  br label %B178.if.lr.ph.i.i.i

B768.endif.i.critedge238.i:                       ; preds = %B546.i.i
  store ptr null, ptr %.2081.i.i, align 8, !noalias !35
  call fastcc void @inner_0(ptr nonnull %.2081.i.i, ptr readonly %.2368.i, i64 17, double 1.000000e+00, ptr %.265.i58.i, ptr %.1202.i.i, i64 range(i64 -9223372036854775799, 513) %.13.i.i, ptr %.1270.i.i, ptr %.706.i.i, ptr %.774.i.i, ptr %.954.i.i, ptr %.1022.i.i, ptr %.459.i75.i, ptr %.527.i.i)
  store ptr null, ptr %.2136.i.i, align 8, !noalias !35
  call fastcc void @inner_0(ptr nonnull %.2136.i.i, ptr readonly %.2368.i, i64 21, double -1.000000e+00, ptr %.265.i58.i, ptr %.1202.i.i, i64 range(i64 -9223372036854775799, 513) %.13.i.i, ptr %.1270.i.i, ptr %.706.i.i, ptr %.774.i.i, ptr %.954.i.i, ptr %.1022.i.i, ptr %.459.i75.i, ptr %.527.i.i)
  br label %B768.endif.i.i

B768.endif.i.i:                                   ; preds = %B178.if.i.i.i, %B768.endif.i.critedge238.i, %B722.i.i
  %lsr.iv.next444.i.i = add i64 %lsr.iv443.i.i, 8192
  %lsr.iv.next451.i.i = add i64 %lsr.iv450.i.i, 24576
  %scevgep467.i.i = getelementptr i8, ptr %lsr.iv466.i.i, i64 8192
  %scevgep473.i.i = getelementptr i8, ptr %lsr.iv472.i.i, i64 24576
  %exitcond.not388.i.i = icmp eq i64 %.415.i.i, %.87.i.i
  br i1 %exitcond.not388.i.i, label %B812.i.i, label %B226.if.i.i

B60.if.preheader.i.i.i:                           ; preds = %B860.i.i
  tail call void @llvm.memset.p0.i64(ptr align 8 %.2531.i.i, i8 0, i64 %138, i1 false), !noalias !44
  br label %B128.if.lr.ph.i.i.i

B128.if.lr.ph.i.i.i:                              ; preds = %B60.if.preheader.i.i.i, %B860.i.i
  %151 = inttoptr i64 %.2459.i.i to ptr
  %scevgep425.i.i = getelementptr i8, ptr %.2531.i.i, i64 24
  %scevgep433.i.i = getelementptr i8, ptr %151, i64 24
  %152 = inttoptr i64 %.2786.i.i to ptr
  br label %B128.if.i.i.i

B284.i.i.i:                                       ; preds = %B228.if.i.i.i, %B130.else.endif.endif.endif.endif.i.i.i
  %exitcond292.not.i.i.i = icmp eq i64 %.324.i.i.i, %.2381.i.i
  br i1 %exitcond292.not.i.i.i, label %B860.endif.endif.endif.endif.endif.i.i, label %B128.if.i.i.i

B128.if.i.i.i:                                    ; preds = %B284.i.i.i, %B128.if.lr.ph.i.i.i
  %.317279285.i.i.i = phi i64 [ 0, %B128.if.lr.ph.i.i.i ], [ %.324.i.i.i, %B284.i.i.i ]
  %.324.i.i.i = add nuw nsw i64 %.317279285.i.i.i, 1
  %.350.i.i.i = mul nsw i64 %.317279285.i.i.i, %.161.i.i
  %.352.i.i.i = add nsw i64 %.350.i.i.i, %.213211001120.i
  %.395.i.i59.i = icmp slt i64 %.352.i.i.i, 0
  %.396.i.i60.i = select i1 %.395.i.i59.i, i64 %.2462.i.i, i64 0
  %.397.i.i61.i = add i64 %.396.i.i60.i, %.352.i.i.i
  %.400.i.i62.i = icmp slt i64 %.397.i.i61.i, 0
  br i1 %.400.i.i62.i, label %B130.else.if.i.i.i, label %B130.else.endif.i.i.i, !prof !19

B130.else.if.i.i.i:                               ; preds = %B128.if.i.i.i
  br label %B130.else.endif.i.i.i

B130.else.endif.i.i.i:                            ; preds = %B130.else.if.i.i.i, %B128.if.i.i.i
  %.385.sroa.0.1.i.i.i = phi i64 [ 0, %B130.else.if.i.i.i ], [ %.397.i.i61.i, %B128.if.i.i.i ]
  %.405.not.i.i.i = icmp slt i64 %.397.i.i61.i, %.2462.i.i
  br i1 %.405.not.i.i.i, label %B130.else.endif.endif.endif.endif.i.i.i, label %B130.else.endif.if.i.i.i, !prof !47

B130.else.endif.if.i.i.i:                         ; preds = %B130.else.endif.i.i.i
  br label %B130.else.endif.endif.endif.endif.i.i.i

B130.else.endif.endif.endif.endif.i.i.i:          ; preds = %B130.else.endif.if.i.i.i, %B130.else.endif.i.i.i
  %.385.sroa.0.3.i.i.i = phi i64 [ %.2462.i.i, %B130.else.endif.if.i.i.i ], [ %.385.sroa.0.1.i.i.i, %B130.else.endif.i.i.i ]
  %153 = getelementptr double, ptr %152, i64 %.317279285.i.i.i
  %.565.i.i.i = load double, ptr %153, align 8, !noalias !44
  br i1 %.178.inv.i.i.i, label %B284.i.i.i, label %B228.if.preheader.i.i.i

B228.if.preheader.i.i.i:                          ; preds = %B130.else.endif.endif.endif.endif.i.i.i
  %154 = shl i64 %.385.sroa.0.3.i.i.i, 3
  %scevgep434.i.i = getelementptr i8, ptr %scevgep433.i.i, i64 %154
  br label %B228.if.i.i.i

B228.if.i.i.i:                                    ; preds = %B228.if.i.i.i, %B228.if.preheader.i.i.i
  %lsr.iv19.i.i = phi i64 [ %lsr.iv.next20.i.i, %B228.if.i.i.i ], [ %142, %B228.if.preheader.i.i.i ]
  %.655272274.i.i.i = phi i64 [ %.662.1.i.1.i.i, %B228.if.i.i.i ], [ 0, %B228.if.preheader.i.i.i ]
  %155 = shl i64 %.655272274.i.i.i, 3
  %scevgep431.i.i = getelementptr i8, ptr %scevgep425.i.i, i64 %155
  %scevgep432.i.i = getelementptr i8, ptr %scevgep431.i.i, i64 -24
  %.716.i158.i.i = load double, ptr %scevgep432.i.i, align 8, !noalias !44
  %scevgep437.i.i = getelementptr i8, ptr %scevgep434.i.i, i64 %155
  %scevgep438.i.i = getelementptr i8, ptr %scevgep437.i.i, i64 -16
  %scevgep27.i.i = getelementptr i8, ptr %scevgep437.i.i, i64 -24
  %.746.i.i63.i = load double, ptr %scevgep27.i.i, align 8, !noalias !44
  %.748.i.i.i = fmul contract double %.565.i.i.i, %.746.i.i63.i
  %.749.i.i.i = fadd contract double %.716.i158.i.i, %.748.i.i.i
  store double %.749.i.i.i, ptr %scevgep432.i.i, align 8, !noalias !44
  %scevgep34.i.i = getelementptr i8, ptr %scevgep431.i.i, i64 -16
  %.716.1.i.i.i = load double, ptr %scevgep34.i.i, align 8, !noalias !44
  %.746.1.i.i.i = load double, ptr %scevgep438.i.i, align 8, !noalias !44
  %.748.1.i.i.i = fmul contract double %.565.i.i.i, %.746.1.i.i.i
  %.749.1.i.i.i = fadd contract double %.716.1.i.i.i, %.748.1.i.i.i
  store double %.749.1.i.i.i, ptr %scevgep34.i.i, align 8, !noalias !44
  %scevgep30.i.i = getelementptr i8, ptr %scevgep431.i.i, i64 -8
  %.716.i158.1.i.i = load double, ptr %scevgep30.i.i, align 8, !noalias !44
  %scevgep24.i.i = getelementptr i8, ptr %scevgep437.i.i, i64 -8
  %.746.i.1.i.i = load double, ptr %scevgep24.i.i, align 8, !noalias !44
  %.748.i.1.i.i = fmul contract double %.565.i.i.i, %.746.i.1.i.i
  %.749.i.1.i.i = fadd contract double %.716.i158.1.i.i, %.748.i.1.i.i
  store double %.749.i.1.i.i, ptr %scevgep30.i.i, align 8, !noalias !44
  %.662.1.i.1.i.i = add i64 %.655272274.i.i.i, 4
  %.716.1.i.1.i.i = load double, ptr %scevgep431.i.i, align 8, !noalias !44
  %.746.1.i.1.i.i = load double, ptr %scevgep437.i.i, align 8, !noalias !44
  %.748.1.i.1.i.i = fmul contract double %.565.i.i.i, %.746.1.i.1.i.i
  %.749.1.i.1.i.i = fadd contract double %.716.1.i.1.i.i, %.748.1.i.1.i.i
  store double %.749.1.i.1.i.i, ptr %scevgep431.i.i, align 8, !noalias !44
  %lsr.iv.next20.i.i = add i64 %lsr.iv19.i.i, -2
  %niter.ncmp.1.i.i = icmp eq i64 %lsr.iv.next20.i.i, 0
  br i1 %niter.ncmp.1.i.i, label %B284.i.i.i, label %B228.if.i.i.i

B860.endif.endif.endif.endif.endif.i.i:           ; preds = %B284.i.i.i
  %.2903.i.i = load i64, ptr %.2902.i.i, align 8, !noalias !35
  %.2909.i.i = add nsw i64 %.2903.i.i, %.2428.i.i
  br i1 %.104.i.i.i, label %B60.if.preheader.i216.i.i, label %B128.if.lr.ph.i167.i.i

B60.if.preheader.i216.i.i:                        ; preds = %B860.endif.endif.endif.endif.endif.i.i
  tail call void @llvm.memset.p0.i64(ptr align 8 %.2599.i.i, i8 0, i64 %138, i1 false), !noalias !48
  br label %B128.if.lr.ph.i167.i.i

B128.if.lr.ph.i167.i.i:                           ; preds = %B60.if.preheader.i216.i.i, %B860.endif.endif.endif.endif.endif.i.i
  %scevgep407.i.i = getelementptr i8, ptr %.2531.i.i, i64 4120
  %156 = inttoptr i64 %.2909.i.i to ptr
  br label %B128.if.i170.i.i

B284.i213.i.i:                                    ; preds = %B228.if.i190.i.i, %B130.else.endif.endif.endif.endif.i183.i.i
  %exitcond292.not.i214.i.i = icmp eq i64 %.324.i172.i.i, %.2381.i.i
  br i1 %exitcond292.not.i214.i.i, label %B860.endif.endif.endif.endif.endif.endif.endif.i.i, label %B128.if.i170.i.i

B128.if.i170.i.i:                                 ; preds = %B284.i213.i.i, %B128.if.lr.ph.i167.i.i
  %.317279285.i171.i.i = phi i64 [ 0, %B128.if.lr.ph.i167.i.i ], [ %.324.i172.i.i, %B284.i213.i.i ]
  %.324.i172.i.i = add nuw nsw i64 %.317279285.i171.i.i, 1
  %.350.i173.i.i = mul nsw i64 %.317279285.i171.i.i, %.161.i.i
  %.352.i174.i.i = add nsw i64 %.350.i173.i.i, %.213211001120.i
  %.395.i175.i.i = icmp slt i64 %.352.i174.i.i, 0
  %.396.i176.i.i = select i1 %.395.i175.i.i, i64 %.2462.i.i, i64 0
  %.397.i177.i.i = add i64 %.396.i176.i.i, %.352.i174.i.i
  %.400.i178.i.i = icmp slt i64 %.397.i177.i.i, 0
  br i1 %.400.i178.i.i, label %B130.else.if.i215.i.i, label %B130.else.endif.i179.i.i, !prof !19

B130.else.if.i215.i.i:                            ; preds = %B128.if.i170.i.i
  br label %B130.else.endif.i179.i.i

B130.else.endif.i179.i.i:                         ; preds = %B130.else.if.i215.i.i, %B128.if.i170.i.i
  %.385.sroa.0.1.i180.i.i = phi i64 [ 0, %B130.else.if.i215.i.i ], [ %.397.i177.i.i, %B128.if.i170.i.i ]
  %.405.not.i181.i.i = icmp slt i64 %.397.i177.i.i, %.2462.i.i
  br i1 %.405.not.i181.i.i, label %B130.else.endif.endif.endif.endif.i183.i.i, label %B130.else.endif.if.i182.i.i, !prof !47

B130.else.endif.if.i182.i.i:                      ; preds = %B130.else.endif.i179.i.i
  br label %B130.else.endif.endif.endif.endif.i183.i.i

B130.else.endif.endif.endif.endif.i183.i.i:       ; preds = %B130.else.endif.if.i182.i.i, %B130.else.endif.i179.i.i
  %.385.sroa.0.3.i184.i.i = phi i64 [ %.2462.i.i, %B130.else.endif.if.i182.i.i ], [ %.385.sroa.0.1.i180.i.i, %B130.else.endif.i179.i.i ]
  %157 = getelementptr double, ptr %156, i64 %.317279285.i171.i.i
  %.565.i186.i.i = load double, ptr %157, align 8, !noalias !48
  br i1 %.178.inv.i.i.i, label %B284.i213.i.i, label %B228.if.preheader.i187.i.i

B228.if.preheader.i187.i.i:                       ; preds = %B130.else.endif.endif.endif.endif.i183.i.i
  %158 = shl i64 %.385.sroa.0.3.i184.i.i, 3
  %scevgep416.i.i = getelementptr i8, ptr %scevgep433.i.i, i64 %158
  br label %B228.if.i190.i.i

B228.if.i190.i.i:                                 ; preds = %B228.if.i190.i.i, %B228.if.preheader.i187.i.i
  %lsr.iv5.i.i = phi i64 [ %lsr.iv.next6.i.i, %B228.if.i190.i.i ], [ %142, %B228.if.preheader.i187.i.i ]
  %.655272274.i191.i.i = phi i64 [ %.662.1.i199.1.i.i, %B228.if.i190.i.i ], [ 0, %B228.if.preheader.i187.i.i ]
  %159 = shl i64 %.655272274.i191.i.i, 3
  %scevgep413.i.i = getelementptr i8, ptr %scevgep407.i.i, i64 %159
  %scevgep414.i.i = getelementptr i8, ptr %scevgep413.i.i, i64 -24
  %.716.i193.i.i = load double, ptr %scevgep414.i.i, align 8, !noalias !48
  %scevgep419.i.i = getelementptr i8, ptr %scevgep416.i.i, i64 %159
  %scevgep420.i.i = getelementptr i8, ptr %scevgep419.i.i, i64 -16
  %scevgep12.i.i = getelementptr i8, ptr %scevgep419.i.i, i64 -24
  %.746.i196.i.i = load double, ptr %scevgep12.i.i, align 8, !noalias !48
  %.748.i197.i.i = fmul contract double %.565.i186.i.i, %.746.i196.i.i
  %.749.i198.i.i = fadd contract double %.716.i193.i.i, %.748.i197.i.i
  store double %.749.i198.i.i, ptr %scevgep414.i.i, align 8, !noalias !48
  %scevgep18.i.i = getelementptr i8, ptr %scevgep413.i.i, i64 -16
  %.716.1.i201.i.i = load double, ptr %scevgep18.i.i, align 8, !noalias !48
  %.746.1.i202.i.i = load double, ptr %scevgep420.i.i, align 8, !noalias !48
  %.748.1.i203.i.i = fmul contract double %.565.i186.i.i, %.746.1.i202.i.i
  %.749.1.i204.i.i = fadd contract double %.716.1.i201.i.i, %.748.1.i203.i.i
  store double %.749.1.i204.i.i, ptr %scevgep18.i.i, align 8, !noalias !48
  %scevgep16.i.i = getelementptr i8, ptr %scevgep413.i.i, i64 -8
  %.716.i193.1.i.i = load double, ptr %scevgep16.i.i, align 8, !noalias !48
  %scevgep8.i.i = getelementptr i8, ptr %scevgep419.i.i, i64 -8
  %.746.i196.1.i.i = load double, ptr %scevgep8.i.i, align 8, !noalias !48
  %.748.i197.1.i.i = fmul contract double %.565.i186.i.i, %.746.i196.1.i.i
  %.749.i198.1.i.i = fadd contract double %.716.i193.1.i.i, %.748.i197.1.i.i
  store double %.749.i198.1.i.i, ptr %scevgep16.i.i, align 8, !noalias !48
  %.662.1.i199.1.i.i = add i64 %.655272274.i191.i.i, 4
  %.716.1.i201.1.i.i = load double, ptr %scevgep413.i.i, align 8, !noalias !48
  %.746.1.i202.1.i.i = load double, ptr %scevgep419.i.i, align 8, !noalias !48
  %.748.1.i203.1.i.i = fmul contract double %.565.i186.i.i, %.746.1.i202.1.i.i
  %.749.1.i204.1.i.i = fadd contract double %.716.1.i201.1.i.i, %.748.1.i203.1.i.i
  store double %.749.1.i204.1.i.i, ptr %scevgep413.i.i, align 8, !noalias !48
  %lsr.iv.next6.i.i = add i64 %lsr.iv5.i.i, -2
  %niter397.ncmp.1.i.i = icmp eq i64 %lsr.iv.next6.i.i, 0
  br i1 %niter397.ncmp.1.i.i, label %B284.i213.i.i, label %B228.if.i190.i.i

B860.endif.endif.endif.endif.endif.endif.endif.i.i: ; preds = %B284.i213.i.i
  %.30861548.not.i.i = icmp slt i64 %.87.i.i, 1
  br i1 %.30861548.not.i.i, label %_ZN17bnserve_inference13moving_kernel7_source8_respondB4v120B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i, label %B1270.if.i.i

B1270.if.i.i:                                     ; preds = %B860.endif.endif.endif.endif.endif.endif.endif.i.i, %B1272.endif.endif.endif.i.i
  %lsr.iv.i64.i = phi i64 [ %lsr.iv.next.i69.i, %B1272.endif.endif.endif.i.i ], [ 4096, %B860.endif.endif.endif.endif.endif.endif.endif.i.i ]
  %.309215451549.i.i = phi i64 [ %.3099.i.i, %B1272.endif.endif.endif.i.i ], [ 0, %B860.endif.endif.endif.endif.endif.endif.endif.i.i ]
  %.3099.i.i = add nuw nsw i64 %.309215451549.i.i, 1
  br i1 %.178.inv.i.i.i, label %B1272.endif.endif.endif.i.i, label %B70.if.i228.i.i

B70.if.i228.i.i:                                  ; preds = %B1270.if.i.i, %B70.if.i228.i.i
  %lsr.iv1.i.i = phi i64 [ %lsr.iv.next2.i.i, %B70.if.i228.i.i ], [ %139, %B1270.if.i.i ]
  %lsr.iv398.i.i = phi ptr [ %scevgep.i68.i, %B70.if.i228.i.i ], [ %.289.i, %B1270.if.i.i ]
  %sunkaddr62.i.i = getelementptr i8, ptr %lsr.iv398.i.i, i64 %.2531.idx.i.i
  %sunkaddr63.i.i = getelementptr i8, ptr %sunkaddr62.i.i, i64 4096
  %.199.i.i.i = load <8 x double>, ptr %sunkaddr63.i.i, align 8, !noalias !51
  %.209.i.i65.i = load <8 x double>, ptr %sunkaddr62.i.i, align 8, !noalias !51
  %.8.i.i230.i.i = fadd contract <8 x double> %.209.i.i65.i, splat (double 1.000000e+00)
  %.236.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.199.i.i.i, <8 x double> %.199.i.i.i, <8 x double> splat (double 4.000000e+00))
  %.6.i.i231.i.i = fdiv contract <8 x double> %.8.i.i230.i.i, %.236.i.i.i
  %scevgep400.i.i = getelementptr i8, ptr %lsr.iv398.i.i, i64 %lsr.iv.i64.i
  %scevgep401.i.i = getelementptr i8, ptr %scevgep400.i.i, i64 -4096
  %.271.i.i66.i = load <8 x double>, ptr %scevgep401.i.i, align 8, !noalias !51
  %.281.i.i67.i = load <8 x double>, ptr %scevgep400.i.i, align 8, !noalias !51
  %.6.i56.i.i.i = fmul contract <8 x double> %.199.i.i.i, %.199.i.i.i
  %.8.i57.i.i.i = fsub contract <8 x double> splat (double 4.000000e+00), %.6.i56.i.i.i
  %.6.i58.i.i.i = fmul contract <8 x double> %.8.i57.i.i.i, %.6.i.i231.i.i
  %.8.i59.i.i.i = fmul contract <8 x double> %.199.i.i.i, splat (double 4.000000e+00)
  %.6.i60.i.i.i = fmul contract <8 x double> %.8.i59.i.i.i, %.6.i.i231.i.i
  %.6.i61.i.i.i = fmul contract <8 x double> %.281.i.i67.i, %.6.i60.i.i.i
  %.8.i62.i.i.i = fsub contract <8 x double> zeroinitializer, %.6.i61.i.i.i
  %.6.i63.i.i.i = fmul contract <8 x double> %.281.i.i67.i, %.6.i58.i.i.i
  %.450.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.271.i.i66.i, <8 x double> %.6.i58.i.i.i, <8 x double> %.8.i62.i.i.i)
  %.475.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.271.i.i66.i, <8 x double> %.6.i60.i.i.i, <8 x double> %.6.i63.i.i.i)
  store <8 x double> %.450.i.i.i, ptr %scevgep401.i.i, align 8, !noalias !51
  store <8 x double> %.475.i.i.i, ptr %scevgep400.i.i, align 8, !noalias !51
  %scevgep.i68.i = getelementptr i8, ptr %lsr.iv398.i.i, i64 64
  %lsr.iv.next2.i.i = add nsw i64 %lsr.iv1.i.i, -1
  %.152.i.i.i = icmp sgt i64 %lsr.iv1.i.i, 5
  br i1 %.152.i.i.i, label %B70.if.i228.i.i, label %B1272.endif.endif.endif.i.i

B1272.endif.endif.endif.i.i:                      ; preds = %B70.if.i228.i.i, %B1270.if.i.i
  %lsr.iv.next.i69.i = add i64 %lsr.iv.i64.i, 8192
  %exitcond.not.i70.i = icmp eq i64 %.87.i.i, %.3099.i.i
  br i1 %exitcond.not.i70.i, label %_ZN17bnserve_inference13moving_kernel7_source8_respondB4v120B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i, label %B1270.if.i.i

_ZN17bnserve_inference13moving_kernel7_source8_respondB4v120B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i: ; preds = %B1272.endif.endif.endif.i.i, %B860.endif.endif.endif.endif.endif.endif.endif.i.i, %B812.i.i
  call void @llvm.lifetime.end.p0(ptr nonnull %.2081.i.i), !noalias !0
  call void @llvm.lifetime.end.p0(ptr nonnull %.2136.i.i), !noalias !0
  %.2484.i = load double, ptr %.2368.i, align 8, !noalias !0
  %.79.i109.i = load i64, ptr %.76.i, align 8, !noalias !54
  %.109.i111.i = load i64, ptr %.106.i, align 8, !noalias !54
  %.178.i.i = load i64, ptr %.422.i, align 8, !noalias !54
  %.261.i.i = load i64, ptr %.198.i.i, align 8, !noalias !54
  %.263.i.i = inttoptr i64 %.261.i.i to ptr
  %.327.i.i = getelementptr double, ptr %.263.i.i, i64 %.213211001120.i
  %.4921209.i.i = load double, ptr %.491.i.i, align 8, !noalias !54
  %.632.idx.i.i = shl i64 %.79.i109.i, 13
  %.632.i.i = getelementptr i8, ptr %.289.i, i64 %.632.idx.i.i
  %.944.i.i = getelementptr i8, ptr %.632.i.i, i64 12288
  %.11791324.not.i.i = icmp slt i64 %.178.i.i, 1
  br i1 %.11791324.not.i.i, label %_ZN17bnserve_inference12modes_kernel7_source13_add_productsB4v170B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxx5ArrayIxLi1E1C7mutable7alignedEdd5ArrayIdLi1E1C7mutable7alignedE.exit.i, label %B634.if.lr.ph.i.i

B634.loopexit.i.i:                                ; preds = %B1530.i.i, %B638.endif.i.i
  %exitcond1428.not.i.i = icmp eq i64 %.1192.i.i, %.178.i.i
  br i1 %exitcond1428.not.i.i, label %_ZN17bnserve_inference12modes_kernel7_source13_add_productsB4v170B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxx5ArrayIxLi1E1C7mutable7alignedEdd5ArrayIdLi1E1C7mutable7alignedE.exit.i, label %B634.if.i.i

B934.i.i:                                         ; preds = %B728.if.i.i
  %160 = inttoptr i64 %.1712.i.i to ptr
  %.1784.i.i = getelementptr double, ptr %160, i64 %.213211001120.i
  %.1855.i.i = getelementptr double, ptr %160, i64 %.1838.i.i
  br i1 %.178.inv.i.i.i, label %B1180.i.i, label %B130.if.i.i217.i

B1084.i.i:                                        ; preds = %B728.if.i.i
  br i1 %.178.inv.i.i.i, label %B1180.i.i, label %B142.if.lr.ph.i.i.i

B1180.i.i:                                        ; preds = %B142.if.i.i.i, %B130.if.i.i217.i, %B1084.i.i, %B934.i.i
  %real.2.0.lcssa.i133.sink14.i.i = phi <8 x double> [ %.6.i42.i.i.i, %B130.if.i.i217.i ], [ zeroinitializer, %B934.i.i ], [ zeroinitializer, %B1084.i.i ], [ %.6.i66.i.i.i, %B142.if.i.i.i ]
  %imaginary.2.0.lcssa.i132.sink7.i.i = phi <8 x double> [ %.6.i43.i.i225.i, %B130.if.i.i217.i ], [ zeroinitializer, %B934.i.i ], [ zeroinitializer, %B1084.i.i ], [ %.6.i67.i.i.i, %B142.if.i.i.i ]
  %.917.i.i.i = extractelement <8 x double> %real.2.0.lcssa.i133.sink14.i.i, i64 0
  %.918.i.i.i = extractelement <8 x double> %real.2.0.lcssa.i133.sink14.i.i, i64 1
  %.919.i.i.i = extractelement <8 x double> %real.2.0.lcssa.i133.sink14.i.i, i64 2
  %.920.i.i.i = extractelement <8 x double> %real.2.0.lcssa.i133.sink14.i.i, i64 3
  %.921.i.i.i = extractelement <8 x double> %real.2.0.lcssa.i133.sink14.i.i, i64 4
  %.922.i.i.i = extractelement <8 x double> %real.2.0.lcssa.i133.sink14.i.i, i64 5
  %.923.i.i.i = extractelement <8 x double> %real.2.0.lcssa.i133.sink14.i.i, i64 6
  %.924.i.i204.i = extractelement <8 x double> %real.2.0.lcssa.i133.sink14.i.i, i64 7
  %.925.i.i.i = fadd contract double %.917.i.i.i, %.918.i.i.i
  %.926.i.i205.i = fadd contract double %.919.i.i.i, %.920.i.i.i
  %.927.i.i.i = fadd contract double %.921.i.i.i, %.922.i.i.i
  %.928.i.i.i = fadd contract double %.923.i.i.i, %.924.i.i204.i
  %.929.i.i.i = fadd contract double %.925.i.i.i, %.926.i.i205.i
  %.930.i.i206.i = fadd contract double %.927.i.i.i, %.928.i.i.i
  %.931.i.i.i = fadd contract double %.929.i.i.i, %.930.i.i206.i
  %.935.i.i.i = extractelement <8 x double> %imaginary.2.0.lcssa.i132.sink7.i.i, i64 0
  %.936.i.i.i = extractelement <8 x double> %imaginary.2.0.lcssa.i132.sink7.i.i, i64 1
  %.937.i.i.i = extractelement <8 x double> %imaginary.2.0.lcssa.i132.sink7.i.i, i64 2
  %.938.i.i.i = extractelement <8 x double> %imaginary.2.0.lcssa.i132.sink7.i.i, i64 3
  %.939.i.i.i = extractelement <8 x double> %imaginary.2.0.lcssa.i132.sink7.i.i, i64 4
  %.940.i.i.i = extractelement <8 x double> %imaginary.2.0.lcssa.i132.sink7.i.i, i64 5
  %.941.i.i.i = extractelement <8 x double> %imaginary.2.0.lcssa.i132.sink7.i.i, i64 6
  %.942.i.i.i = extractelement <8 x double> %imaginary.2.0.lcssa.i132.sink7.i.i, i64 7
  %.943.i.i.i = fadd contract double %.935.i.i.i, %.936.i.i.i
  %.944.i.i.i = fadd contract double %.937.i.i.i, %.938.i.i.i
  %.945.i.i.i = fadd contract double %.939.i.i.i, %.940.i.i.i
  %.946.i.i.i = fadd contract double %.941.i.i.i, %.942.i.i.i
  %.947.i.i.i = fadd contract double %.943.i.i.i, %.944.i.i.i
  %.948.i.i.i = fadd contract double %.945.i.i.i, %.946.i.i.i
  %.949.i.i.i = fadd contract double %.947.i.i.i, %.948.i.i.i
  %.2218.i.i = mul nuw nsw i64 %.135212691281.i.i, %.178.i.i
  %.2220.i.i = add nuw nsw i64 %.2218.i.i, %.118512961327.i.i
  %.idx.i207.i = shl i64 %.2220.i.i, 4
  %161 = getelementptr i8, ptr %167, i64 %.idx.i207.i
  %.2251.i.i = load double, ptr %161, align 8, !noalias !54
  %.2253.i.i = fadd contract double %.2251.i.i, %.931.i.i.i
  store double %.2253.i.i, ptr %161, align 8, !noalias !54
  %162 = getelementptr i8, ptr %161, i64 8
  %.2322.i.i = load double, ptr %162, align 8, !noalias !54
  %.2324.i.i = fadd contract double %.2322.i.i, %.949.i.i.i
  store double %.2324.i.i, ptr %162, align 8, !noalias !54
  br i1 %173, label %B1304.i.i, label %B1530.i.i

B1304.i.i:                                        ; preds = %B1180.i.i
  %.2391.i.i = load i64, ptr %.504.i, align 8, !noalias !54
  %.2392.not.i.i = icmp eq i64 %.2391.i.i, 0
  %or.cond.i.i = select i1 %.2392.not.i.i, i1 true, i1 %169
  br i1 %or.cond.i.i, label %B1530.i.i, label %B62.if.preheader.i.i.i

B1530.i.i:                                        ; preds = %B62.if.i.i.i, %B1304.i.i, %B1180.i.i
  %scevgep320.i.i = getelementptr i8, ptr %lsr.iv319.i.i, i64 8192
  %exitcond.not.i208.i = icmp eq i64 %.79.i109.i, %.1359.i.i
  br i1 %exitcond.not.i208.i, label %B634.loopexit.i.i, label %B728.if.i.i

B634.if.lr.ph.i.i:                                ; preds = %_ZN17bnserve_inference13moving_kernel7_source8_respondB4v120B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i
  %.546.i.i = load i64, ptr %sunkaddr113.i, align 8, !noalias !54
  %.550.i113.i = mul i64 %.79.i109.i, %.264.i.i
  %.552.i.i = mul i64 %.550.i113.i, %.178.i.i
  %.553.i.i = add nsw i64 %.546.i.i, %.552.i.i
  %.414.i.i = load i64, ptr %.413.i114.i, align 8, !noalias !54
  %.139.i.i = load i64, ptr %.138.i.i, align 8, !noalias !54
  %.181.i115.i = sub i64 0, %.109.i111.i
  %.189.1.i.i = and i64 %.181.i115.i, -8
  %.1669.i.i = mul nsw i64 %.79.i109.i, %.232410861091.i
  %.1838.i.i = sub i64 %.213211001120.i, %.189.1.i.i
  %.2358.i.i = add nsw i64 %.178.i.i, -1
  %.2396.i.i = sub i64 %.109.i111.i, %.213211001120.i
  %.2458.i116.i = mul nsw i64 %.79.i109.i, %.631.sroa.0.073.i
  %.152.i.i117.i = add i64 %.139.i.i, -4
  %.13.i.i118.i = tail call i64 @llvm.smin.i64(i64 %.2396.i.i, i64 range(i64 -9223372036854775799, 513) %.13.i.i)
  %163 = lshr i64 %.181.i115.i, 3
  %164 = mul i64 %163, -128
  %scevgep77.i.i = getelementptr i8, ptr %.632.i.i, i64 4096
  %165 = icmp slt i64 %.79.i109.i, 1
  %166 = icmp eq i64 %.139.i.i, 1
  %167 = inttoptr i64 %.553.i.i to ptr
  %168 = inttoptr i64 %.414.i.i to ptr
  %sunkaddr83.i.i = getelementptr i8, ptr %168, i64 8
  %169 = icmp slt i64 %.13.i.i118.i, 1
  %factor.op.mul = mul i64 %.189.1.i.i, %.139.i.i
  %factor.op.mul.i.reass = mul i64 %factor.op.mul, -16
  br label %B634.if.i.i

B634.if.i.i:                                      ; preds = %B634.if.lr.ph.i.i, %B634.loopexit.i.i
  %.118512961327.i.i = phi i64 [ 0, %B634.if.lr.ph.i.i ], [ %.1192.i.i, %B634.loopexit.i.i ]
  %.1192.i.i = add nuw nsw i64 %.118512961327.i.i, 1
  %.1222.i.i = uitofp nneg i64 %.118512961327.i.i to double
  %.1223.i.i = fmul contract double %.4921209.i.i, %.1222.i.i
  %.1225.i.i = fadd contract double %.793.i, %.1223.i.i
  %.1227.i.i = fadd contract double %.2484.i, %.1225.i.i
  br i1 %.178.inv.i.i.i, label %B638.endif.i.i, label %B92.if.preheader.i.i.i

B92.if.preheader.i.i.i:                           ; preds = %B634.if.i.i
  %.48.i90.i.i = fmul contract double %.1227.i.i, 0xC01921FB54442D18
  %.6.i.i.i120.i = insertelement <8 x double> poison, double %.48.i90.i.i, i64 0
  %.7.i.i.i121.i = shufflevector <8 x double> %.6.i.i.i120.i, <8 x double> poison, <8 x i32> zeroinitializer
  br label %B92.if.i.i.i

B92.if.i.i.i:                                     ; preds = %B92.if.i.i.i, %B92.if.preheader.i.i.i
  %lsr.iv8.i122.i = phi i64 [ %lsr.iv.next9.i158.i, %B92.if.i.i.i ], [ %139, %B92.if.preheader.i.i.i ]
  %lsr.iv170.i.i123.i = phi i64 [ %lsr.iv.next171.i.i157.i, %B92.if.i.i.i ], [ 0, %B92.if.preheader.i.i.i ]
  %scevgep173.i.i124.i = getelementptr i8, ptr %.327.i.i, i64 %lsr.iv170.i.i123.i
  %.192.i91.i.i = load <8 x double>, ptr %scevgep173.i.i124.i, align 8, !noalias !57
  %.8.i.i.i125.i = fmul contract <8 x double> %.7.i.i.i121.i, %.192.i91.i.i
  %.222.i92.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i.i.i125.i, <8 x double> splat (double 0x3FE45F306DC9C883), <8 x double> splat (double 0x4338000000000000))
  %.8.i154.i.i126.i = fadd contract <8 x double> %.222.i92.i.i, splat (double 0xC338000000000000)
  %.263.i.i127.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i154.i.i126.i, <8 x double> splat (double 0xBFF921FB54442D18), <8 x double> %.8.i.i.i125.i)
  %.280.i.i128.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i154.i.i126.i, <8 x double> splat (double 0xBC91A62633145C07), <8 x double> %.263.i.i127.i)
  %.6.i155.i.i129.i = fmul contract <8 x double> %.280.i.i128.i, %.280.i.i128.i
  %.6.i156.i.i130.i = fmul contract <8 x double> %.280.i.i128.i, %.6.i155.i.i129.i
  %.309.i.i131.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i155.i.i129.i, <8 x double> splat (double 0xBD6AE7F3E733B81F), <8 x double> splat (double 0x3DE6124613A86D09))
  %.312.i.i132.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i155.i.i129.i, <8 x double> %.309.i.i131.i, <8 x double> splat (double 0xBE5AE64567F544E4))
  %.315.i.i133.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i155.i.i129.i, <8 x double> %.312.i.i132.i, <8 x double> splat (double 0x3EC71DE3A556C734))
  %.318.i.i134.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i155.i.i129.i, <8 x double> %.315.i.i133.i, <8 x double> splat (double 0xBF2A01A01A01A01A))
  %.321.i.i135.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i155.i.i129.i, <8 x double> %.318.i.i134.i, <8 x double> splat (double 0x3F81111111111111))
  %.324.i.i136.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i155.i.i129.i, <8 x double> %.321.i.i135.i, <8 x double> splat (double 0xBFC5555555555555))
  %.349.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i156.i.i130.i, <8 x double> %.324.i.i136.i, <8 x double> %.280.i.i128.i)
  %.354.i.i137.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i155.i.i129.i, <8 x double> splat (double 0x3D2AE7F3E733B81F), <8 x double> splat (double 0xBDA93974A8C07C9D))
  %.357.i.i138.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i155.i.i129.i, <8 x double> %.354.i.i137.i, <8 x double> splat (double 0x3E21EED8EFF8D898))
  %.360.i.i139.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i155.i.i129.i, <8 x double> %.357.i.i138.i, <8 x double> splat (double 0xBE927E4FB7789F5C))
  %.363.i.i140.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i155.i.i129.i, <8 x double> %.360.i.i139.i, <8 x double> splat (double 0x3EFA01A01A01A01A))
  %.366.i.i141.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i155.i.i129.i, <8 x double> %.363.i.i140.i, <8 x double> splat (double 0xBF56C16C16C16C17))
  %.369.i.i142.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i155.i.i129.i, <8 x double> %.366.i.i141.i, <8 x double> splat (double 0x3FA5555555555555))
  %.372.i.i143.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i155.i.i129.i, <8 x double> %.369.i.i142.i, <8 x double> splat (double -5.000000e-01))
  %.375.i.i144.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i155.i.i129.i, <8 x double> %.372.i.i143.i, <8 x double> splat (double 1.000000e+00))
  %.376.i.i145.i = bitcast <8 x double> %.222.i92.i.i to <8 x i64>
  %.377.i.i.i = bitcast <8 x double> %.349.i.i.i to <8 x i64>
  %.378.i.i146.i = bitcast <8 x double> %.375.i.i144.i to <8 x i64>
  %.6.i157.i.i147.i = xor <8 x i64> %.378.i.i146.i, %.377.i.i.i
  %.8.i158.i.i148.i = and <8 x i64> %.376.i.i145.i, splat (i64 1)
  %170 = icmp eq <8 x i64> %.8.i158.i.i148.i, zeroinitializer
  %.6.i160.i.i149.i = select <8 x i1> %170, <8 x i64> zeroinitializer, <8 x i64> %.6.i157.i.i147.i
  %.8.i161.i.i150.i = shl <8 x i64> %.376.i.i145.i, splat (i64 62)
  %.8.i162.i.i151.i = and <8 x i64> %.8.i161.i.i150.i, splat (i64 -9223372036854775808)
  %.8.i164.i.i152.i = add <8 x i64> %.8.i161.i.i150.i, splat (i64 4611686018427387904)
  %.8.i165.i.i153.i = and <8 x i64> %.8.i164.i.i152.i, splat (i64 -9223372036854775808)
  %171 = xor <8 x i64> %.8.i162.i.i151.i, %.377.i.i.i
  %.6.i167.i.i154.i = xor <8 x i64> %171, %.6.i160.i.i149.i
  %172 = xor <8 x i64> %.8.i165.i.i153.i, %.378.i.i146.i
  %.6.i169.i.i155.i = xor <8 x i64> %172, %.6.i160.i.i149.i
  %scevgep.i156.i = getelementptr i8, ptr %.944.i.i, i64 %lsr.iv170.i.i123.i
  %scevgep281.i.i = getelementptr i8, ptr %scevgep.i156.i, i64 -4096
  store <8 x i64> %.6.i169.i.i155.i, ptr %scevgep281.i.i, align 8, !noalias !57
  store <8 x i64> %.6.i167.i.i154.i, ptr %scevgep.i156.i, align 8, !noalias !57
  %lsr.iv.next171.i.i157.i = add i64 %lsr.iv170.i.i123.i, 64
  %lsr.iv.next9.i158.i = add nsw i64 %lsr.iv8.i122.i, -1
  %.144.i.i.i = icmp sgt i64 %lsr.iv8.i122.i, 5
  br i1 %.144.i.i.i, label %B92.if.i.i.i, label %B638.endif.i.i

B638.endif.i.i:                                   ; preds = %B92.if.i.i.i, %B634.if.i.i
  br i1 %165, label %B634.loopexit.i.i, label %B728.if.preheader.i.i

B728.if.preheader.i.i:                            ; preds = %B638.endif.i.i
  %173 = icmp eq i64 %.118512961327.i.i, %.2358.i.i
  br label %B728.if.i.i

B728.if.i.i:                                      ; preds = %B728.if.preheader.i.i, %B1530.i.i
  %lsr.iv319.i.i = phi ptr [ %scevgep320.i.i, %B1530.i.i ], [ %scevgep465.i.i, %B728.if.preheader.i.i ]
  %.135212691281.i.i = phi i64 [ %.1359.i.i, %B1530.i.i ], [ 0, %B728.if.preheader.i.i ]
  %.1359.i.i = add nuw nsw i64 %.135212691281.i.i, 1
  %.1659.i.i = load i64, ptr %sunkaddr81.i.i, align 8, !noalias !54
  %.1660.i.i = icmp eq i64 %.1659.i.i, 1
  %.1671.i.i = add nuw nsw i64 %.135212691281.i.i, %.1669.i.i
  %"$phi838.2.2.2.i.i" = select i1 %.1660.i.i, i64 %.232410861091.i, i64 %.1671.i.i
  %.1708.i.i = load i64, ptr %sunkaddr.i119.i, align 8, !noalias !54
  %.1711.i.i = mul nsw i64 %factor.op.mul.i.reass, %"$phi838.2.2.2.i.i"
  %.1712.i.i = add nsw i64 %.1711.i.i, %.1708.i.i
  br i1 %166, label %B934.i.i, label %B1084.i.i

B130.if.i.i217.i:                                 ; preds = %B934.i.i, %B130.if.i.i217.i
  %lsr.iv.i218.i = phi i64 [ %lsr.iv.next.i226.i, %B130.if.i.i217.i ], [ %139, %B934.i.i ]
  %lsr.iv44.i.i.i = phi i64 [ %lsr.iv.next45.i.i.i, %B130.if.i.i217.i ], [ 0, %B934.i.i ]
  %real.2.0272.i.i.i = phi <8 x double> [ %.6.i42.i.i.i, %B130.if.i.i217.i ], [ zeroinitializer, %B934.i.i ]
  %imaginary.2.0271.i.i.i = phi <8 x double> [ %.6.i43.i.i225.i, %B130.if.i.i217.i ], [ zeroinitializer, %B934.i.i ]
  %scevgep333.i.i = getelementptr i8, ptr %lsr.iv319.i.i, i64 %lsr.iv44.i.i.i
  %scevgep334.i.i = getelementptr i8, ptr %scevgep333.i.i, i64 -4096
  %.266.i115.i.i = load <8 x double>, ptr %scevgep334.i.i, align 8, !noalias !60
  %.276.i.i219.i = load <8 x double>, ptr %scevgep333.i.i, align 8, !noalias !60
  %scevgep330.i.i = getelementptr i8, ptr %.944.i.i, i64 %lsr.iv44.i.i.i
  %scevgep331.i.i = getelementptr i8, ptr %scevgep330.i.i, i64 -4096
  %.286.i.i.i = load <8 x double>, ptr %scevgep331.i.i, align 8, !noalias !60
  %.296.i.i.i = load <8 x double>, ptr %scevgep330.i.i, align 8, !noalias !60
  %.6.i.i116.i.i = fmul contract <8 x double> %.276.i.i219.i, %.296.i.i.i
  %.8.i.i117.i.i = fsub contract <8 x double> zeroinitializer, %.6.i.i116.i.i
  %.345.i.i220.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.266.i115.i.i, <8 x double> %.286.i.i.i, <8 x double> %.8.i.i117.i.i)
  %.6.i38.i.i.i = fmul contract <8 x double> %.276.i.i219.i, %.286.i.i.i
  %.370.i.i221.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.266.i115.i.i, <8 x double> %.296.i.i.i, <8 x double> %.6.i38.i.i.i)
  %scevgep48.i.i.i = getelementptr i8, ptr %.1784.i.i, i64 %lsr.iv44.i.i.i
  %.401.i.i.i = load <8 x double>, ptr %scevgep48.i.i.i, align 8, !noalias !60
  %scevgep47.i.i.i = getelementptr i8, ptr %.1855.i.i, i64 %lsr.iv44.i.i.i
  %.411.i.i222.i = load <8 x double>, ptr %scevgep47.i.i.i, align 8, !noalias !60
  %.6.i39.i.i.i = fmul contract <8 x double> %.370.i.i221.i, %.411.i.i222.i
  %.8.i40.i.i.i = fsub contract <8 x double> zeroinitializer, %.6.i39.i.i.i
  %.6.i41.i.i223.i = fmul contract <8 x double> %.411.i.i222.i, %.345.i.i220.i
  %.460.i.i224.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.401.i.i.i, <8 x double> %.345.i.i220.i, <8 x double> %.8.i40.i.i.i)
  %.485.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.401.i.i.i, <8 x double> %.370.i.i221.i, <8 x double> %.6.i41.i.i223.i)
  %scevgep76.i.i = getelementptr i8, ptr %scevgep330.i.i, i64 -12288
  store <8 x double> %.460.i.i224.i, ptr %scevgep76.i.i, align 8, !noalias !60
  %scevgep74.i.i = getelementptr i8, ptr %scevgep330.i.i, i64 -8192
  store <8 x double> %.485.i.i.i, ptr %scevgep74.i.i, align 8, !noalias !60
  %.6.i42.i.i.i = fadd contract <8 x double> %real.2.0272.i.i.i, %.460.i.i224.i
  %.6.i43.i.i225.i = fadd contract <8 x double> %imaginary.2.0271.i.i.i, %.485.i.i.i
  %lsr.iv.next45.i.i.i = add i64 %lsr.iv44.i.i.i, 64
  %lsr.iv.next.i226.i = add nsw i64 %lsr.iv.i218.i, -1
  %.218.i.i.i = icmp sgt i64 %lsr.iv.i218.i, 5
  br i1 %.218.i.i.i, label %B130.if.i.i217.i, label %B1180.i.i

B142.if.lr.ph.i.i.i:                              ; preds = %B1084.i.i
  %174 = inttoptr i64 %.1712.i.i to ptr
  %.48.i.i.i = load double, ptr %168, align 8, !noalias !63
  %.49.i.i.i = fsub contract double %.1227.i.i, %.48.i.i.i
  %.78.i.i.i = load double, ptr %sunkaddr83.i.i, align 8, !noalias !63
  %.85.i.i.i = fdiv contract double %.49.i.i.i, %.78.i.i.i
  %.93.le.i.i.i = tail call contract double @llvm.floor.f64(double %.85.i.i.i)
  %.5.i.i.i.i = fptosi double %.93.le.i.i.i to i64
  %.13.i.i.i.i = tail call i64 @llvm.smax.i64(i64 %.5.i.i.i.i, i64 2)
  %.13.i1.i.i.i = tail call i64 @llvm.smin.i64(i64 %.152.i.i117.i, i64 %.13.i.i.i.i)
  %.265.i.i159.i = add i64 %.13.i1.i.i.i, -2
  %.181.i.i.i = sitofp i64 %.13.i1.i.i.i to double
  %.182.i.i.i = fsub contract double %.85.i.i.i, %.181.i.i.i
  %.206.i.i.i = fmul contract double %.182.i.i.i, %.182.i.i.i
  %.245.i.i160.i = fmul contract double %.182.i.i.i, %.206.i.i.i
  %.246.i.i161.i = fmul contract double %.182.i.i.i, %.245.i.i160.i
  %.247.i.i162.i = fmul contract double %.182.i.i.i, %.246.i.i161.i
  %.251.i.i163.i = fdiv contract double %.247.i.i162.i, 1.200000e+02
  %.183.i.i.i = fsub contract double 1.000000e+00, %.182.i.i.i
  %.230.i.i164.i = fmul contract double %.183.i.i.i, 5.000000e+00
  %.231.i.i165.i = fadd contract double %.230.i.i164.i, -2.000000e+01
  %.232.i.i166.i = fmul contract double %.183.i.i.i, %.231.i.i165.i
  %.233.i.i167.i = fadd contract double %.232.i.i166.i, 2.000000e+01
  %.234.i.i168.i = fmul contract double %.183.i.i.i, %.233.i.i167.i
  %.235.i.i.i = fadd contract double %.234.i.i168.i, 2.000000e+01
  %.236.i.i169.i = fmul contract double %.183.i.i.i, %.235.i.i.i
  %.237.i.i.i = fadd contract double %.236.i.i169.i, -5.000000e+01
  %.238.i.i.i = fmul contract double %.183.i.i.i, %.237.i.i.i
  %.239.i.i.i = fadd contract double %.238.i.i.i, 2.600000e+01
  %.243.i.i.i = fdiv contract double %.239.i.i.i, 1.200000e+02
  %.184.i.i.i = fmul contract double %.183.i.i.i, %.183.i.i.i
  %.220.i.i.i = fmul contract double %.183.i.i.i, 1.000000e+01
  %.221.i.i.i = fsub contract double 3.000000e+01, %.220.i.i.i
  %.222.i.i170.i = fmul contract double %.184.i.i.i, %.221.i.i.i
  %.223.i.i.i = fadd contract double %.222.i.i170.i, -6.000000e+01
  %.224.i.i171.i = fmul contract double %.184.i.i.i, %.223.i.i.i
  %.225.i.i172.i = fadd contract double %.224.i.i171.i, 6.600000e+01
  %.229.i.i173.i = fdiv contract double %.225.i.i172.i, 1.200000e+02
  %.208.i.i174.i = fmul contract double %.182.i.i.i, 1.000000e+01
  %.209.i.i175.i = fsub contract double 3.000000e+01, %.208.i.i174.i
  %.210.i.i.i = fmul contract double %.206.i.i.i, %.209.i.i175.i
  %.211.i.i.i = fadd contract double %.210.i.i.i, -6.000000e+01
  %.212.i.i.i = fmul contract double %.206.i.i.i, %.211.i.i.i
  %.213.i.i.i = fadd contract double %.212.i.i.i, 6.600000e+01
  %.217.i.i176.i = fdiv contract double %.213.i.i.i, 1.200000e+02
  %.192.i.i.i = fmul contract double %.182.i.i.i, 5.000000e+00
  %.193.i.i177.i = fadd contract double %.192.i.i.i, -2.000000e+01
  %.194.i.i.i = fmul contract double %.182.i.i.i, %.193.i.i177.i
  %.195.i.i.i = fadd contract double %.194.i.i.i, 2.000000e+01
  %.196.i.i.i = fmul contract double %.182.i.i.i, %.195.i.i.i
  %.197.i.i.i = fadd contract double %.196.i.i.i, 2.000000e+01
  %.198.i.i.i = fmul contract double %.182.i.i.i, %.197.i.i.i
  %.199.i.i178.i = fadd contract double %.198.i.i.i, -5.000000e+01
  %.200.i.i.i = fmul contract double %.182.i.i.i, %.199.i.i178.i
  %.201.i.i179.i = fadd contract double %.200.i.i.i, 2.600000e+01
  %.205.i.i180.i = fdiv contract double %.201.i.i179.i, 1.200000e+02
  %.185.i.i.i = fmul contract double %.183.i.i.i, %.184.i.i.i
  %.186.i.i.i = fmul contract double %.183.i.i.i, %.185.i.i.i
  %.187.i.i.i = fmul contract double %.183.i.i.i, %.186.i.i.i
  %.191.i.i.i = fdiv contract double %.187.i.i.i, 1.200000e+02
  %.488.i.i.i = insertelement <8 x double> poison, double %.205.i.i180.i, i64 0
  %.489.i.i181.i = shufflevector <8 x double> %.488.i.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.515.i.i.i = insertelement <8 x double> poison, double %.217.i.i176.i, i64 0
  %.516.i.i.i = shufflevector <8 x double> %.515.i.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.518.i.i.i = insertelement <8 x double> poison, double %.229.i.i173.i, i64 0
  %.519.i.i.i = shufflevector <8 x double> %.518.i.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.554.i.i182.i = insertelement <8 x double> poison, double %.243.i.i.i, i64 0
  %.555.i.i183.i = shufflevector <8 x double> %.554.i.i182.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.557.i.i.i = insertelement <8 x double> poison, double %.251.i.i163.i, i64 0
  %.558.i.i184.i = shufflevector <8 x double> %.557.i.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.6.i58.i.i185.i = insertelement <8 x double> poison, double %.191.i.i.i, i64 0
  %.7.i.i121.i.i = shufflevector <8 x double> %.6.i58.i.i185.i, <8 x double> poison, <8 x i32> zeroinitializer
  %175 = shl i64 %.13.i1.i.i.i, 7
  %176 = sub i64 -320, %175
  %177 = sub i64 -448, %175
  %178 = sub nuw nsw i64 -64, %175
  %179 = sub i64 -192, %175
  %180 = shl i64 %.13.i1.i.i.i, 4
  %181 = sub i64 24, %180
  %182 = sub i64 64, %175
  %183 = sub i64 -256, %175
  %184 = sub i64 -384, %175
  %185 = sub nuw nsw i64 -128, %175
  %186 = sub i64 128, %175
  %scevgep12.i186.i = getelementptr i8, ptr %174, i64 %143
  %187 = mul i64 %176, %163
  %scevgep13.i.i = getelementptr i8, ptr %scevgep12.i186.i, i64 %187
  %188 = mul i64 %177, %163
  %scevgep15.i.i = getelementptr i8, ptr %scevgep12.i186.i, i64 %188
  %189 = mul i64 %178, %163
  %scevgep17.i.i = getelementptr i8, ptr %scevgep12.i186.i, i64 %189
  %190 = mul i64 %179, %163
  %scevgep33.i.i = getelementptr i8, ptr %scevgep12.i186.i, i64 %190
  %191 = mul i64 %181, %.189.1.i.i
  %scevgep47.i.i = getelementptr i8, ptr %scevgep12.i186.i, i64 %191
  %192 = mul i64 %182, %163
  %scevgep51.i.i = getelementptr i8, ptr %scevgep12.i186.i, i64 %192
  %193 = mul i64 %183, %163
  %scevgep55.i.i = getelementptr i8, ptr %scevgep12.i186.i, i64 %193
  %194 = mul i64 %184, %163
  %scevgep58.i.i = getelementptr i8, ptr %scevgep12.i186.i, i64 %194
  %195 = mul i64 %.13.i1.i.i.i, %164
  %scevgep60.i.i = getelementptr i8, ptr %scevgep12.i186.i, i64 %195
  %196 = mul i64 %185, %163
  %scevgep63.i.i = getelementptr i8, ptr %scevgep12.i186.i, i64 %196
  %197 = mul i64 %.265.i.i159.i, %164
  %scevgep65.i.i = getelementptr i8, ptr %scevgep12.i186.i, i64 %197
  %198 = mul i64 %186, %163
  %scevgep67.i.i = getelementptr i8, ptr %scevgep12.i186.i, i64 %198
  br label %B142.if.i.i.i

B142.if.i.i.i:                                    ; preds = %B142.if.i.i.i, %B142.if.lr.ph.i.i.i
  %lsr.iv10.i.i = phi i64 [ %lsr.iv.next11.i.i, %B142.if.i.i.i ], [ %139, %B142.if.lr.ph.i.i.i ]
  %lsr.iv68.i.i.i = phi i64 [ %lsr.iv.next69.i.i.i, %B142.if.i.i.i ], [ 0, %B142.if.lr.ph.i.i.i ]
  %real.2.0448.i.i.i = phi <8 x double> [ %.6.i66.i.i.i, %B142.if.i.i.i ], [ zeroinitializer, %B142.if.lr.ph.i.i.i ]
  %imaginary.2.0447.i.i.i = phi <8 x double> [ %.6.i67.i.i.i, %B142.if.i.i.i ], [ zeroinitializer, %B142.if.lr.ph.i.i.i ]
  %scevgep322.i.i = getelementptr i8, ptr %lsr.iv319.i.i, i64 %lsr.iv68.i.i.i
  %scevgep323.i.i = getelementptr i8, ptr %scevgep322.i.i, i64 -4096
  %.302.i.i.i = load <8 x double>, ptr %scevgep323.i.i, align 8, !noalias !66
  %.312.i123.i.i = load <8 x double>, ptr %scevgep322.i.i, align 8, !noalias !66
  %scevgep286.i.i = getelementptr i8, ptr %.944.i.i, i64 %lsr.iv68.i.i.i
  %scevgep287.i.i = getelementptr i8, ptr %scevgep286.i.i, i64 -4096
  %.322.i.i.i = load <8 x double>, ptr %scevgep287.i.i, align 8, !noalias !66
  %.332.i.i.i = load <8 x double>, ptr %scevgep286.i.i, align 8, !noalias !66
  %.6.i.i124.i.i = fmul contract <8 x double> %.312.i123.i.i, %.332.i.i.i
  %.8.i.i125.i.i = fsub contract <8 x double> zeroinitializer, %.6.i.i124.i.i
  %.381.i.i187.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.302.i.i.i, <8 x double> %.322.i.i.i, <8 x double> %.8.i.i125.i.i)
  %.6.i57.i.i.i = fmul contract <8 x double> %.312.i123.i.i, %.322.i.i.i
  %.406.i.i188.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.302.i.i.i, <8 x double> %.332.i.i.i, <8 x double> %.6.i57.i.i.i)
  %scevgep68.i.i = getelementptr i8, ptr %scevgep67.i.i, i64 %lsr.iv68.i.i.i
  %.452.i.i.i = load <8 x double>, ptr %scevgep68.i.i, align 8, !noalias !66
  %scevgep66.i.i = getelementptr i8, ptr %scevgep65.i.i, i64 %lsr.iv68.i.i.i
  %.462.i.i.i = load <8 x double>, ptr %scevgep66.i.i, align 8, !noalias !66
  %.8.i59.i.i189.i = fmul contract <8 x double> %.7.i.i121.i.i, %.462.i.i.i
  %.490.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.452.i.i.i, <8 x double> %.489.i.i181.i, <8 x double> %.8.i59.i.i189.i)
  %scevgep64.i.i = getelementptr i8, ptr %scevgep63.i.i, i64 %lsr.iv68.i.i.i
  %.501.i.i190.i = load <8 x double>, ptr %scevgep64.i.i, align 8, !noalias !66
  %scevgep61.i.i = getelementptr i8, ptr %scevgep60.i.i, i64 %lsr.iv68.i.i.i
  %.513.i.i.i = load <8 x double>, ptr %scevgep61.i.i, align 8, !noalias !66
  %.517.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.513.i.i.i, <8 x double> %.516.i.i.i, <8 x double> %.490.i.i.i)
  %.520.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.501.i.i190.i, <8 x double> %.519.i.i.i, <8 x double> %.517.i.i.i)
  %scevgep59.i.i = getelementptr i8, ptr %scevgep58.i.i, i64 %lsr.iv68.i.i.i
  %.531.i.i191.i = load <8 x double>, ptr %scevgep59.i.i, align 8, !noalias !66
  %scevgep57.i.i = getelementptr i8, ptr %scevgep55.i.i, i64 %lsr.iv68.i.i.i
  %.543.i.i192.i = load <8 x double>, ptr %scevgep57.i.i, align 8, !noalias !66
  %.556.i.i193.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.543.i.i192.i, <8 x double> %.555.i.i183.i, <8 x double> %.520.i.i.i)
  %.559.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.531.i.i191.i, <8 x double> %.558.i.i184.i, <8 x double> %.556.i.i193.i)
  %scevgep52.i.i = getelementptr i8, ptr %scevgep51.i.i, i64 %lsr.iv68.i.i.i
  %.586.i.i194.i = load <8 x double>, ptr %scevgep52.i.i, align 8, !noalias !66
  %scevgep49.i.i = getelementptr i8, ptr %scevgep47.i.i, i64 %lsr.iv68.i.i.i
  %.596.i.i.i = load <8 x double>, ptr %scevgep49.i.i, align 8, !noalias !66
  %.8.i62.i.i195.i = fmul contract <8 x double> %.7.i.i121.i.i, %.596.i.i.i
  %.624.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.586.i.i194.i, <8 x double> %.489.i.i181.i, <8 x double> %.8.i62.i.i195.i)
  %scevgep40.i196.i = getelementptr i8, ptr %scevgep33.i.i, i64 %lsr.iv68.i.i.i
  %.635.i126.i.i = load <8 x double>, ptr %scevgep40.i196.i, align 8, !noalias !66
  %scevgep18.i197.i = getelementptr i8, ptr %scevgep17.i.i, i64 %lsr.iv68.i.i.i
  %.647.i127.i.i = load <8 x double>, ptr %scevgep18.i197.i, align 8, !noalias !66
  %.651.i128.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.647.i127.i.i, <8 x double> %.516.i.i.i, <8 x double> %.624.i.i.i)
  %.654.i129.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.635.i126.i.i, <8 x double> %.519.i.i.i, <8 x double> %.651.i128.i.i)
  %scevgep16.i198.i = getelementptr i8, ptr %scevgep15.i.i, i64 %lsr.iv68.i.i.i
  %.665.i.i199.i = load <8 x double>, ptr %scevgep16.i198.i, align 8, !noalias !66
  %scevgep14.i.i = getelementptr i8, ptr %scevgep13.i.i, i64 %lsr.iv68.i.i.i
  %.677.i.i.i = load <8 x double>, ptr %scevgep14.i.i, align 8, !noalias !66
  %.690.i.i200.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.677.i.i.i, <8 x double> %.555.i.i183.i, <8 x double> %.654.i129.i.i)
  %.693.i.i201.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.665.i.i199.i, <8 x double> %.558.i.i184.i, <8 x double> %.690.i.i200.i)
  %.6.i63.i.i202.i = fmul contract <8 x double> %.406.i.i188.i, %.693.i.i201.i
  %.8.i64.i.i.i = fsub contract <8 x double> zeroinitializer, %.6.i63.i.i202.i
  %.6.i65.i.i.i = fmul contract <8 x double> %.381.i.i187.i, %.693.i.i201.i
  %.742.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.559.i.i.i, <8 x double> %.381.i.i187.i, <8 x double> %.8.i64.i.i.i)
  %.767.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.559.i.i.i, <8 x double> %.406.i.i188.i, <8 x double> %.6.i65.i.i.i)
  %scevgep72.i.i = getelementptr i8, ptr %scevgep286.i.i, i64 -12288
  store <8 x double> %.742.i.i.i, ptr %scevgep72.i.i, align 8, !noalias !66
  %scevgep70.i.i = getelementptr i8, ptr %scevgep286.i.i, i64 -8192
  store <8 x double> %.767.i.i.i, ptr %scevgep70.i.i, align 8, !noalias !66
  %.6.i66.i.i.i = fadd contract <8 x double> %real.2.0448.i.i.i, %.742.i.i.i
  %.6.i67.i.i.i = fadd contract <8 x double> %imaginary.2.0447.i.i.i, %.767.i.i.i
  %lsr.iv.next69.i.i.i = add i64 %lsr.iv68.i.i.i, 64
  %lsr.iv.next11.i.i = add nsw i64 %lsr.iv10.i.i, -1
  %.254.i.i203.i = icmp sgt i64 %lsr.iv10.i.i, 5
  br i1 %.254.i.i203.i, label %B142.if.i.i.i, label %B1180.i.i

B62.if.preheader.i.i.i:                           ; preds = %B1304.i.i
  %.2460.i.i = add nsw i64 %.135212691281.i.i, %.2458.i116.i
  %.2464.i.i = mul nsw i64 %.2460.i.i, %.109.i111.i
  %.2466.i.i = add nsw i64 %.2464.i.i, %.213211001120.i
  %.2467.i.i = shl nsw i64 %.2466.i.i, 4
  %.2468.i.i = add nsw i64 %.2391.i.i, %.2467.i.i
  %.2472.i.i = inttoptr i64 %.2468.i.i to ptr
  %scevgep.i139.i.i = getelementptr i8, ptr %.2472.i.i, i64 8
  br label %B62.if.i.i.i

B62.if.i.i.i:                                     ; preds = %B62.if.i.i.i, %B62.if.preheader.i.i.i
  %lsr.iv.i140.i.i = phi ptr [ %scevgep.i139.i.i, %B62.if.preheader.i.i.i ], [ %scevgep1.i.i.i, %B62.if.i.i.i ]
  %.190171173.i.i.i = phi i64 [ 0, %B62.if.preheader.i.i.i ], [ %.197.i141.i.i, %B62.if.i.i.i ]
  %.197.i141.i.i = add nuw nsw i64 %.190171173.i.i.i, 1
  %scevgep2.i.i.i = getelementptr i8, ptr %lsr.iv.i140.i.i, i64 -8
  %.252.i.i209.i = load double, ptr %scevgep2.i.i.i, align 8, !noalias !69
  %sunkaddr63.i210.i = shl i64 %.190171173.i.i.i, 3
  %scevgep78.i.i = getelementptr i8, ptr %scevgep77.i.i, i64 %sunkaddr63.i210.i
  %scevgep79.i.i = getelementptr i8, ptr %scevgep78.i.i, i64 -4096
  %.282.i.i.i = load double, ptr %scevgep79.i.i, align 8, !noalias !69
  %.314.i.i.i = load double, ptr %scevgep78.i.i, align 8, !noalias !69
  %.316.i.i.i = fmul contract double %.314.i.i.i, 0.000000e+00
  %.317.i.i211.i = fsub contract double %.282.i.i.i, %.316.i.i.i
  %.318.i142.i.i = fadd contract double %.252.i.i209.i, %.317.i.i211.i
  store double %.318.i142.i.i, ptr %scevgep2.i.i.i, align 8, !noalias !69
  %.380.i.i212.i = load double, ptr %lsr.iv.i140.i.i, align 8, !noalias !69
  %.410.i.i213.i = load double, ptr %scevgep78.i.i, align 8, !noalias !69
  %.442.i.i.i = load double, ptr %scevgep79.i.i, align 8, !noalias !69
  %.444.i.i214.i = fmul contract double %.442.i.i.i, 0.000000e+00
  %.445.i.i215.i = fadd contract double %.410.i.i213.i, %.444.i.i214.i
  %.446.i.i.i = fadd contract double %.380.i.i212.i, %.445.i.i215.i
  store double %.446.i.i.i, ptr %lsr.iv.i140.i.i, align 8, !noalias !69
  %scevgep1.i.i.i = getelementptr i8, ptr %lsr.iv.i140.i.i, i64 16
  %exitcond.not.i.i216.i = icmp eq i64 %.13.i.i118.i, %.197.i141.i.i
  br i1 %exitcond.not.i.i216.i, label %B1530.i.i, label %B62.if.i.i.i

_ZN17bnserve_inference12modes_kernel7_source13_add_productsB4v170B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxx5ArrayIxLi1E1C7mutable7alignedEdd5ArrayIdLi1E1C7mutable7alignedE.exit.i: ; preds = %B634.loopexit.i.i, %_ZN17bnserve_inference13moving_kernel7_source8_respondB4v120B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i
  %.71.i.i = load i64, ptr %.76.i, align 8, !noalias !72
  %.186.i.i = add nsw i64 %.71.i.i, 1
  %.188.i.i = mul nsw i64 %.186.i.i, %.71.i.i
  %.268.i.i = and i64 %.188.i.i, -2
  %.408785.not.i.i = icmp slt i64 %.71.i.i, 1
  br i1 %.408785.not.i.i, label %B1242.backedge.i, label %B282.if.lr.ph.i.i

B774.i.i:                                         ; preds = %_ZN17bnserve_inference12modes_kernel7_source5_pairB4v215B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx.exit.i.i
  %.417.i.i = add nsw i64 %.407750789.i.i, -1
  %.421.i.i = add nuw nsw i64 %.414758788.i.i, 1
  %lsr.iv.next97.i = add i64 %lsr.iv96.i, 8192
  %exitcond867.not.i.i = icmp eq i64 %.421.i.i, %.71.i.i
  br i1 %exitcond867.not.i.i, label %B1242.backedge.i, label %B282.if.i.i

B282.if.lr.ph.i.i:                                ; preds = %_ZN17bnserve_inference12modes_kernel7_source13_add_productsB4v170B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxx5ArrayIxLi1E1C7mutable7alignedEdd5ArrayIdLi1E1C7mutable7alignedE.exit.i
  %.196.1.i.i = lshr i64 %.188.i.i, 1
  %.265.i.i = mul i64 %.196.1.i.i, %.264.i.i
  %.262.i.i = load i64, ptr %sunkaddr114.i, align 8, !noalias !72
  %.266.i.i = add nsw i64 %.262.i.i, %.265.i.i
  %.181.i.i = load i64, ptr %sunkaddr81.i.i, align 8, !noalias !72
  %.102.i.i = load i64, ptr %.106.i, align 8, !noalias !72
  %.103.i.i = sub i64 0, %.102.i.i
  %.111.1.i.i = and i64 %.103.i.i, -8
  %.145.i.i = sub i64 0, %.111.1.i.i
  %.1055.i.i = icmp eq i64 %.181.i.i, 1
  %.1065.i.i = shl nsw i64 %.145.i.i, 1
  %.1068.i.i = mul nuw nsw i64 %.196.1.i.i, %.232410861091.i
  %.1059.i.i = mul nsw i64 %.232410861091.i, %.145.i.i
  %199 = mul i64 %.111.1.i.i, -8
  %200 = select i1 %.1055.i.i, i64 0, i64 %199
  %201 = inttoptr i64 %.266.i.i to ptr
  br label %B282.if.i.i

B282.if.i.i:                                      ; preds = %B282.if.lr.ph.i.i, %B774.i.i
  %lsr.iv96.i = phi i64 [ %82, %B282.if.lr.ph.i.i ], [ %lsr.iv.next97.i, %B774.i.i ]
  %at.3.0790.i.i = phi i64 [ 0, %B282.if.lr.ph.i.i ], [ %.1516.i.i, %B774.i.i ]
  %.407750789.i.i = phi i64 [ %.71.i.i, %B282.if.lr.ph.i.i ], [ %.417.i.i, %B774.i.i ]
  %.414758788.i.i = phi i64 [ 0, %B282.if.lr.ph.i.i ], [ %.421.i.i, %B774.i.i ]
  %smax.i.i = tail call i64 @llvm.smax.i64(i64 %.407750789.i.i, i64 0)
  %202 = add i64 %smax.i.i, %at.3.0790.i.i
  br label %B360.if.i.i

B360.if.i.i:                                      ; preds = %_ZN17bnserve_inference12modes_kernel7_source5_pairB4v215B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx.exit.i.i, %B282.if.i.i
  %lsr.iv102.i = phi i64 [ %lsr.iv.next103.i, %_ZN17bnserve_inference12modes_kernel7_source5_pairB4v215B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx.exit.i.i ], [ %lsr.iv96.i, %B282.if.i.i ]
  %at.2.1747.i.i = phi i64 [ %.1516.i.i, %_ZN17bnserve_inference12modes_kernel7_source5_pairB4v215B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx.exit.i.i ], [ %at.3.0790.i.i, %B282.if.i.i ]
  br i1 %.178.inv.i.i.i, label %_ZN17bnserve_inference12modes_kernel7_source5_pairB4v215B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx.exit.i.i, label %B130.if.i.i.preheader.i

B130.if.i.i.preheader.i:                          ; preds = %B360.if.i.i
  %.1070.i.i = add nsw i64 %at.2.1747.i.i, %.1068.i.i
  %.1071.i.i = mul nsw i64 %.1065.i.i, %.1070.i.i
  %"$phi454.2.2.2.i.i" = select i1 %.1055.i.i, i64 %.1059.i.i, i64 %.1071.i.i
  %.1109.i.i = shl nsw i64 %"$phi454.2.2.2.i.i", 3
  %.1108.i.i = load i64, ptr %sunkaddr120.i, align 8, !noalias !72
  %.1110.i.i = add nsw i64 %.1108.i.i, %.1109.i.i
  %203 = inttoptr i64 %.1110.i.i to ptr
  %scevgep.i = getelementptr i8, ptr %203, i64 %lsr.iv259.i
  br label %B130.if.i.i.i

B306.i.i.i:                                       ; preds = %B130.if.i.i.i
  %.419.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.416.i.i.i, <8 x double> %.351.i.i.i, <8 x double> %real.3.0302.i.i.i)
  %.439.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.416.i.i.i, <8 x double> %.376.i.i.i, <8 x double> %imaginary.3.0301.i.i.i)
  br label %B552.i.i.i

B432.i.i.i:                                       ; preds = %B130.if.i.i.i
  %scevgep106.i = getelementptr i8, ptr %lsr.iv94.i, i64 %200
  %.473.i.i.i = load <8 x double>, ptr %scevgep106.i, align 8, !noalias !75
  %.6.i.i.i.i = fmul contract <8 x double> %.376.i.i.i, %.473.i.i.i
  %.8.i44.i.i.i = fsub contract <8 x double> zeroinitializer, %.6.i.i.i.i
  %.6.i45.i.i.i = fmul contract <8 x double> %.351.i.i.i, %.473.i.i.i
  %.530.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.416.i.i.i, <8 x double> %.351.i.i.i, <8 x double> %.8.i44.i.i.i)
  %.6.i46.i.i.i = fadd contract <8 x double> %real.3.0302.i.i.i, %.530.i.i.i
  %.555.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.416.i.i.i, <8 x double> %.376.i.i.i, <8 x double> %.6.i45.i.i.i)
  %.6.i47.i.i.i = fadd contract <8 x double> %imaginary.3.0301.i.i.i, %.555.i.i.i
  br label %B552.i.i.i

B552.i.i.i:                                       ; preds = %B432.i.i.i, %B306.i.i.i
  %imaginary.4.1.i.i.i = phi <8 x double> [ %.439.i.i.i, %B306.i.i.i ], [ %.6.i47.i.i.i, %B432.i.i.i ]
  %real.4.1.i.i.i = phi <8 x double> [ %.419.i.i.i, %B306.i.i.i ], [ %.6.i46.i.i.i, %B432.i.i.i ]
  %lsr.iv.next93.i = add nsw i64 %lsr.iv92.i, -1
  %scevgep95.i = getelementptr i8, ptr %lsr.iv94.i, i64 64
  %scevgep99.i = getelementptr i8, ptr %lsr.iv98.i, i64 64
  %.193.i.i.i = icmp sgt i64 %lsr.iv92.i, 5
  br i1 %.193.i.i.i, label %B130.if.i.i.i, label %_ZN17bnserve_inference12modes_kernel7_source5_pairB4v215B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx.exit.i.i

B130.if.i.i.i:                                    ; preds = %B552.i.i.i, %B130.if.i.i.preheader.i
  %lsr.iv98.i = phi ptr [ %scevgep99.i, %B552.i.i.i ], [ %.155.i, %B130.if.i.i.preheader.i ]
  %lsr.iv94.i = phi ptr [ %scevgep95.i, %B552.i.i.i ], [ %scevgep.i, %B130.if.i.i.preheader.i ]
  %lsr.iv92.i = phi i64 [ %lsr.iv.next93.i, %B552.i.i.i ], [ %88, %B130.if.i.i.preheader.i ]
  %real.3.0302.i.i.i = phi <8 x double> [ %real.4.1.i.i.i, %B552.i.i.i ], [ zeroinitializer, %B130.if.i.i.preheader.i ]
  %imaginary.3.0301.i.i.i = phi <8 x double> [ %imaginary.4.1.i.i.i, %B552.i.i.i ], [ zeroinitializer, %B130.if.i.i.preheader.i ]
  %scevgep104.i = getelementptr i8, ptr %lsr.iv98.i, i64 %lsr.iv102.i
  %scevgep105.i = getelementptr i8, ptr %scevgep104.i, i64 -4096
  %.245.i.i.i = load <8 x double>, ptr %scevgep105.i, align 8, !noalias !75
  %.256.i.i.i = load <8 x double>, ptr %scevgep104.i, align 8, !noalias !75
  %scevgep100.i = getelementptr i8, ptr %lsr.iv98.i, i64 %lsr.iv96.i
  %scevgep101.i = getelementptr i8, ptr %scevgep100.i, i64 -4096
  %.267.i.i.i = load <8 x double>, ptr %scevgep101.i, align 8, !noalias !75
  %.278.i.i.i = load <8 x double>, ptr %scevgep100.i, align 8, !noalias !75
  %.8.i.i.i.i = fsub contract <8 x double> zeroinitializer, %.278.i.i.i
  %.6.i41.i.i.i = fmul contract <8 x double> %.256.i.i.i, %.8.i.i.i.i
  %.8.i42.i.i.i = fsub contract <8 x double> zeroinitializer, %.6.i41.i.i.i
  %.351.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.245.i.i.i, <8 x double> %.267.i.i.i, <8 x double> %.8.i42.i.i.i)
  %.6.i43.i.i.i = fmul contract <8 x double> %.256.i.i.i, %.267.i.i.i
  %.376.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.245.i.i.i, <8 x double> %.8.i.i.i.i, <8 x double> %.6.i43.i.i.i)
  %.416.i.i.i = load <8 x double>, ptr %lsr.iv94.i, align 8, !noalias !75
  br i1 %.1055.i.i, label %B306.i.i.i, label %B432.i.i.i

_ZN17bnserve_inference12modes_kernel7_source5_pairB4v215B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx.exit.i.i: ; preds = %B552.i.i.i, %B360.if.i.i
  %imaginary.3.0.lcssa.i.i.i = phi <8 x double> [ zeroinitializer, %B360.if.i.i ], [ %imaginary.4.1.i.i.i, %B552.i.i.i ]
  %real.3.0.lcssa.i.i.i = phi <8 x double> [ zeroinitializer, %B360.if.i.i ], [ %real.4.1.i.i.i, %B552.i.i.i ]
  %.683.i.i.i = extractelement <8 x double> %real.3.0.lcssa.i.i.i, i64 0
  %.684.i.i.i = extractelement <8 x double> %real.3.0.lcssa.i.i.i, i64 1
  %.685.i.i.i = extractelement <8 x double> %real.3.0.lcssa.i.i.i, i64 2
  %.686.i.i.i = extractelement <8 x double> %real.3.0.lcssa.i.i.i, i64 3
  %.687.i.i.i = extractelement <8 x double> %real.3.0.lcssa.i.i.i, i64 4
  %.688.i.i.i = extractelement <8 x double> %real.3.0.lcssa.i.i.i, i64 5
  %.689.i.i.i = extractelement <8 x double> %real.3.0.lcssa.i.i.i, i64 6
  %.690.i.i.i = extractelement <8 x double> %real.3.0.lcssa.i.i.i, i64 7
  %.691.i.i.i = fadd contract double %.683.i.i.i, %.684.i.i.i
  %.692.i.i.i = fadd contract double %.685.i.i.i, %.686.i.i.i
  %.693.i.i.i = fadd contract double %.687.i.i.i, %.688.i.i.i
  %.694.i.i.i = fadd contract double %.689.i.i.i, %.690.i.i.i
  %.695.i.i.i = fadd contract double %.691.i.i.i, %.692.i.i.i
  %.696.i.i.i = fadd contract double %.693.i.i.i, %.694.i.i.i
  %.697.i.i.i = fadd contract double %.695.i.i.i, %.696.i.i.i
  %.701.i.i.i = extractelement <8 x double> %imaginary.3.0.lcssa.i.i.i, i64 0
  %.702.i.i.i = extractelement <8 x double> %imaginary.3.0.lcssa.i.i.i, i64 1
  %.703.i.i.i = extractelement <8 x double> %imaginary.3.0.lcssa.i.i.i, i64 2
  %.704.i.i.i = extractelement <8 x double> %imaginary.3.0.lcssa.i.i.i, i64 3
  %.705.i.i.i = extractelement <8 x double> %imaginary.3.0.lcssa.i.i.i, i64 4
  %.706.i.i.i = extractelement <8 x double> %imaginary.3.0.lcssa.i.i.i, i64 5
  %.707.i.i.i = extractelement <8 x double> %imaginary.3.0.lcssa.i.i.i, i64 6
  %.708.i.i.i = extractelement <8 x double> %imaginary.3.0.lcssa.i.i.i, i64 7
  %.709.i.i.i = fadd contract double %.701.i.i.i, %.702.i.i.i
  %.710.i.i.i = fadd contract double %.703.i.i.i, %.704.i.i.i
  %.711.i.i.i = fadd contract double %.705.i.i.i, %.706.i.i.i
  %.712.i.i.i = fadd contract double %.707.i.i.i, %.708.i.i.i
  %.713.i.i.i = fadd contract double %.709.i.i.i, %.710.i.i.i
  %.714.i.i.i = fadd contract double %.711.i.i.i, %.712.i.i.i
  %.715.i.i.i = fadd contract double %.713.i.i.i, %.714.i.i.i
  %.1403.i.i = icmp slt i64 %at.2.1747.i.i, 0
  %.1404.i.i = select i1 %.1403.i.i, i64 %.268.i.i, i64 0
  %.idx.i.i = shl i64 %at.2.1747.i.i, 4
  %204 = getelementptr i8, ptr %201, i64 %.idx.i.i
  %.1418.i.i = getelementptr double, ptr %204, i64 %.1404.i.i
  %.1419.i.i = load double, ptr %.1418.i.i, align 8, !noalias !72
  %.1420.i.i = fadd contract double %.1419.i.i, %.697.i.i.i
  store double %.1420.i.i, ptr %.1418.i.i, align 8, !noalias !72
  %205 = getelementptr i8, ptr %204, i64 8
  %.1482.i.i = getelementptr double, ptr %205, i64 %.1404.i.i
  %.1483.i.i = load double, ptr %.1482.i.i, align 8, !noalias !72
  %.1484.i.i = fadd contract double %.715.i.i.i, %.1483.i.i
  store double %.1484.i.i, ptr %.1482.i.i, align 8, !noalias !72
  %.1516.i.i = add i64 %at.2.1747.i.i, 1
  %lsr.iv.next103.i = add i64 %lsr.iv102.i, 8192
  %exitcond.not.i.i = icmp eq i64 %.1516.i.i, %202
  br i1 %exitcond.not.i.i, label %B774.i.i, label %B360.if.i.i

B1242.backedge.i:                                 ; preds = %B774.i.i, %_ZN17bnserve_inference12modes_kernel7_source13_add_productsB4v170B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxx5ArrayIxLi1E1C7mutable7alignedEdd5ArrayIdLi1E1C7mutable7alignedE.exit.i
  %exitcond.not.i = icmp eq i64 %.47.i, %.2331.i
  br i1 %exitcond.not.i, label %B1120.loopexit.i, label %B1242.if.i

_ZN17bnserve_inference13moving_kernel7_source8contractB2v3B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIxLi1E1C7mutable7alignedE.exit: ; preds = %B1468.i, %entry
  store i64 0, ptr %retptr, align 8
  ret i32 0
}

; Function Attrs: mustprogress nocallback nofree nounwind willreturn memory(argmem: write)
declare void @llvm.memset.p0.i64(ptr writeonly captures(none), i8, i64, i1 immarg) #1

; Function Attrs: mustprogress nocallback nocreateundeforpoison nofree nosync nounwind speculatable willreturn memory(none)
declare i64 @llvm.smin.i64(i64, i64) #2

; Function Attrs: mustprogress nocallback nocreateundeforpoison nofree nosync nounwind speculatable willreturn memory(none)
declare i64 @llvm.smax.i64(i64, i64) #2

; Function Attrs: mustprogress nocallback nocreateundeforpoison nofree nosync nounwind speculatable willreturn memory(none)
declare <8 x double> @llvm.fma.v8f64(<8 x double>, <8 x double>, <8 x double>) #2

; Function Attrs: mustprogress nocallback nocreateundeforpoison nofree nosync nounwind speculatable willreturn memory(none)
declare double @llvm.floor.f64(double) #2

; Function Attrs: nofree norecurse nosync nounwind memory(argmem: readwrite)
define internal fastcc void @inner_0(ptr noalias nonnull writeonly captures(none) %retptr, ptr readonly captures(none) %arg.k.4, i64 range(i64 17, 22) %arg.first, double %arg.sign, ptr readonly captures(none) %arg.f.4, ptr readonly captures(none) %arg.c.4, i64 range(i64 -9223372036854775799, 513) %arg.c.5.0, ptr readonly captures(none) %arg.s.4, ptr readonly captures(none) %arg.pr.4, ptr readonly captures(none) %arg.pi.4, ptr readonly captures(none) %arg.xr.4, ptr readonly captures(none) %arg.xi.4, ptr captures(none) %arg.hr.4, ptr captures(none) %arg.hi.4) unnamed_addr #3 {
entry:
  %0 = getelementptr double, ptr %arg.k.4, i64 %arg.first
  %.174 = load double, ptr %0, align 8
  %1 = getelementptr i8, ptr %0, i64 8
  %.204 = load double, ptr %1, align 8
  %.328 = getelementptr i8, ptr %arg.k.4, i64 104
  %.329 = load double, ptr %.328, align 8
  %2 = add nuw nsw i64 %arg.c.5.0, 7
  %.503 = lshr i64 %2, 3
  %.480.inv = icmp slt i64 %arg.c.5.0, 1
  %.609 = insertelement <8 x double> poison, double %.174, i64 0
  %.610 = shufflevector <8 x double> %.609, <8 x double> poison, <8 x i32> zeroinitializer
  %.638 = insertelement <8 x double> poison, double %.204, i64 0
  %.639 = shufflevector <8 x double> %.638, <8 x double> poison, <8 x i32> zeroinitializer
  %.867 = insertelement <8 x double> poison, double %.329, i64 0
  %.868 = shufflevector <8 x double> %.867, <8 x double> poison, <8 x i32> zeroinitializer
  %.5245887.not5893 = icmp eq i64 %.503, 0
  %.5245887.not = select i1 %.480.inv, i1 true, i1 %.5245887.not5893
  br i1 %.5245887.not, label %B1354, label %B306.lr.ph

B306.lr.ph:                                       ; preds = %entry
  %3 = getelementptr i8, ptr %0, i64 24
  %.264 = load double, ptr %3, align 8
  %.955 = fmul contract double %.264, 0x400921FB54442D18
  %4 = getelementptr i8, ptr %0, i64 16
  %.234 = load double, ptr %4, align 8
  %.421 = getelementptr i8, ptr %arg.k.4, i64 128
  %.422 = load double, ptr %.421, align 8
  %.901 = fneg contract double %.422
  %.903 = fmul contract double %.234, %.901
  %.357 = getelementptr i8, ptr %arg.k.4, i64 112
  %.358 = load double, ptr %.357, align 8
  %.871 = fneg contract double %.358
  %.718 = fmul contract double %arg.sign, 5.000000e-01
  %.392 = getelementptr i8, ptr %arg.k.4, i64 120
  %.393 = load double, ptr %.392, align 8
  %.667 = fmul contract double %.234, %.393
  %.583 = fneg contract double %.204
  %5 = tail call i64 @llvm.smax.i64(i64 %.503, i64 1)
  %.6.i = insertelement <8 x double> poison, double %.583, i64 0
  %.7.i = shufflevector <8 x double> %.6.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.6.i5898 = insertelement <8 x double> poison, double %.422, i64 0
  %.7.i5899 = shufflevector <8 x double> %.6.i5898, <8 x double> poison, <8 x i32> zeroinitializer
  %.6.i5901 = insertelement <8 x double> poison, double %.667, i64 0
  %.7.i5902 = shufflevector <8 x double> %.6.i5901, <8 x double> poison, <8 x i32> zeroinitializer
  %.6.i5906 = insertelement <8 x double> poison, double %.718, i64 0
  %.7.i5907 = shufflevector <8 x double> %.6.i5906, <8 x double> poison, <8 x i32> zeroinitializer
  %.6.i5909 = insertelement <8 x double> poison, double %arg.sign, i64 0
  %.7.i5910 = shufflevector <8 x double> %.6.i5909, <8 x double> poison, <8 x i32> zeroinitializer
  %.6.i5913 = insertelement <8 x double> poison, double %.358, i64 0
  %.7.i5914 = shufflevector <8 x double> %.6.i5913, <8 x double> poison, <8 x i32> zeroinitializer
  %.6.i5916 = insertelement <8 x double> poison, double %.871, i64 0
  %.7.i5917 = shufflevector <8 x double> %.6.i5916, <8 x double> poison, <8 x i32> zeroinitializer
  %.6.i5919 = insertelement <8 x double> poison, double %.393, i64 0
  %.7.i5920 = shufflevector <8 x double> %.6.i5919, <8 x double> poison, <8 x i32> zeroinitializer
  %.6.i5922 = insertelement <8 x double> poison, double %.903, i64 0
  %.7.i5923 = shufflevector <8 x double> %.6.i5922, <8 x double> poison, <8 x i32> zeroinitializer
  %.6.i5925 = insertelement <8 x double> poison, double %.955, i64 0
  %.7.i5926 = shufflevector <8 x double> %.6.i5925, <8 x double> poison, <8 x i32> zeroinitializer
  br label %B306

B306:                                             ; preds = %B306, %B306.lr.ph
  %.514.sroa.0.05892 = phi i64 [ 0, %B306.lr.ph ], [ %.514.sroa.0.0, %B306 ]
  %.469.15891.in = phi i64 [ %5, %B306.lr.ph ], [ %23, %B306 ]
  %.466.15890 = phi i64 [ 8, %B306.lr.ph ], [ %.466.1, %B306 ]
  %.569 = getelementptr inbounds double, ptr %arg.c.4, i64 %.514.sroa.0.05892
  %.571 = load <8 x double>, ptr %.569, align 8
  %.579 = getelementptr inbounds double, ptr %arg.s.4, i64 %.514.sroa.0.05892
  %.581 = load <8 x double>, ptr %.579, align 8
  %.8.i = fmul contract <8 x double> %.7.i, %.581
  %.611 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.571, <8 x double> %.610, <8 x double> %.8.i)
  %.8.i5896 = fmul contract <8 x double> %.610, %.581
  %.640 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.571, <8 x double> %.639, <8 x double> %.8.i5896)
  %.8.i5897 = fsub contract <8 x double> zeroinitializer, %.640
  %.8.i5900 = fmul contract <8 x double> %.7.i5899, %.611
  %.8.i5903 = fsub contract <8 x double> %.7.i5902, %.8.i5900
  %.6.i5904 = fmul contract <8 x double> %.8.i5903, %.8.i5903
  %.8.i5905 = fsub contract <8 x double> zeroinitializer, %.6.i5904
  %.767 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i5897, <8 x double> %.8.i5897, <8 x double> %.8.i5905)
  %.8.i5908 = fmul contract <8 x double> %.7.i5907, %.767
  %.8.i5911 = fmul contract <8 x double> %.7.i5910, %.8.i5897
  %.6.i5912 = fmul contract <8 x double> %.8.i5911, %.8.i5903
  %.8.i5915 = fmul contract <8 x double> %.7.i5914, %.6.i5912
  %.869 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i5908, <8 x double> %.868, <8 x double> %.8.i5915)
  %.8.i5918 = fmul contract <8 x double> %.7.i5917, %.8.i5908
  %.899 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i5912, <8 x double> %.868, <8 x double> %.8.i5918)
  %.8.i5921 = fmul contract <8 x double> %.7.i5920, %.611
  %.8.i5924 = fsub contract <8 x double> %.7.i5923, %.8.i5921
  %.963 = getelementptr inbounds double, ptr %arg.f.4, i64 %.514.sroa.0.05892
  %.965 = load <8 x double>, ptr %.963, align 8
  %.8.i5927 = fmul contract <8 x double> %.7.i5926, %.965
  %.8.i5928 = fadd contract <8 x double> %.8.i5924, splat (double 1.000000e+00)
  %.6.i5929 = fmul contract <8 x double> %.8.i5927, %.8.i5928
  %6 = tail call <8 x double> @llvm.fabs.v8f64(<8 x double> %.6.i5929)
  %.8.i5931 = fsub contract <8 x double> zeroinitializer, %6
  %.1094 = tail call <8 x double> @llvm.minnum.v8f64(<8 x double> %.8.i5931, <8 x double> splat (double -1.000000e-09))
  %.8.i5932 = fsub contract <8 x double> zeroinitializer, %.1094
  %.1124 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i5932, <8 x double> splat (double 0x3FE45F306DC9C883), <8 x double> splat (double 0x4338000000000000))
  %.8.i5933 = fadd contract <8 x double> %.1124, splat (double 0xC338000000000000)
  %.1165 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i5933, <8 x double> splat (double 0xBFF921FB54442D18), <8 x double> %.8.i5932)
  %.1182 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i5933, <8 x double> splat (double 0xBC91A62633145C07), <8 x double> %.1165)
  %.6.i5934 = fmul contract <8 x double> %.1182, %.1182
  %.6.i5935 = fmul contract <8 x double> %.1182, %.6.i5934
  %.1211 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i5934, <8 x double> splat (double 0xBD6AE7F3E733B81F), <8 x double> splat (double 0x3DE6124613A86D09))
  %.1214 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i5934, <8 x double> %.1211, <8 x double> splat (double 0xBE5AE64567F544E4))
  %.1217 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i5934, <8 x double> %.1214, <8 x double> splat (double 0x3EC71DE3A556C734))
  %.1220 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i5934, <8 x double> %.1217, <8 x double> splat (double 0xBF2A01A01A01A01A))
  %.1223 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i5934, <8 x double> %.1220, <8 x double> splat (double 0x3F81111111111111))
  %.1226 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i5934, <8 x double> %.1223, <8 x double> splat (double 0xBFC5555555555555))
  %.1251 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i5935, <8 x double> %.1226, <8 x double> %.1182)
  %.1256 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i5934, <8 x double> splat (double 0x3D2AE7F3E733B81F), <8 x double> splat (double 0xBDA93974A8C07C9D))
  %.1259 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i5934, <8 x double> %.1256, <8 x double> splat (double 0x3E21EED8EFF8D898))
  %.1262 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i5934, <8 x double> %.1259, <8 x double> splat (double 0xBE927E4FB7789F5C))
  %.1265 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i5934, <8 x double> %.1262, <8 x double> splat (double 0x3EFA01A01A01A01A))
  %.1268 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i5934, <8 x double> %.1265, <8 x double> splat (double 0xBF56C16C16C16C17))
  %.1271 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i5934, <8 x double> %.1268, <8 x double> splat (double 0x3FA5555555555555))
  %.1274 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i5934, <8 x double> %.1271, <8 x double> splat (double -5.000000e-01))
  %.1277 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i5934, <8 x double> %.1274, <8 x double> splat (double 1.000000e+00))
  %.1278 = bitcast <8 x double> %.1124 to <8 x i64>
  %.8.i5937 = and <8 x i64> %.1278, splat (i64 1)
  %7 = icmp eq <8 x i64> %.8.i5937, zeroinitializer
  %.8.i5940 = shl <8 x i64> %.1278, splat (i64 62)
  %.8.i5941 = and <8 x i64> %.8.i5940, splat (i64 -9223372036854775808)
  %.6.i5945.v = select <8 x i1> %7, <8 x double> %.1251, <8 x double> %.1277
  %.6.i5945 = bitcast <8 x double> %.6.i5945.v to <8 x i64>
  %.6.i5946 = xor <8 x i64> %.8.i5941, %.6.i5945
  %8 = bitcast <8 x i64> %.6.i5946 to <8 x double>
  %.6.i5949 = fdiv contract <8 x double> %8, %.8.i5932
  %.8.i5950 = fsub contract <8 x double> splat (double 1.000000e+00), %.8.i5924
  %.6.i5951 = fmul contract <8 x double> %.8.i5927, %.8.i5950
  %9 = tail call <8 x double> @llvm.fabs.v8f64(<8 x double> %.6.i5951)
  %.8.i5953 = fsub contract <8 x double> zeroinitializer, %9
  %.1743 = tail call <8 x double> @llvm.minnum.v8f64(<8 x double> %.8.i5953, <8 x double> splat (double -1.000000e-09))
  %.8.i5954 = fsub contract <8 x double> zeroinitializer, %.1743
  %.1773 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i5954, <8 x double> splat (double 0x3FE45F306DC9C883), <8 x double> splat (double 0x4338000000000000))
  %.8.i5955 = fadd contract <8 x double> %.1773, splat (double 0xC338000000000000)
  %.1814 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i5955, <8 x double> splat (double 0xBFF921FB54442D18), <8 x double> %.8.i5954)
  %.1831 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i5955, <8 x double> splat (double 0xBC91A62633145C07), <8 x double> %.1814)
  %.6.i5956 = fmul contract <8 x double> %.1831, %.1831
  %.6.i5957 = fmul contract <8 x double> %.1831, %.6.i5956
  %.1860 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i5956, <8 x double> splat (double 0xBD6AE7F3E733B81F), <8 x double> splat (double 0x3DE6124613A86D09))
  %.1863 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i5956, <8 x double> %.1860, <8 x double> splat (double 0xBE5AE64567F544E4))
  %.1866 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i5956, <8 x double> %.1863, <8 x double> splat (double 0x3EC71DE3A556C734))
  %.1869 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i5956, <8 x double> %.1866, <8 x double> splat (double 0xBF2A01A01A01A01A))
  %.1872 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i5956, <8 x double> %.1869, <8 x double> splat (double 0x3F81111111111111))
  %.1875 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i5956, <8 x double> %.1872, <8 x double> splat (double 0xBFC5555555555555))
  %.1900 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i5957, <8 x double> %.1875, <8 x double> %.1831)
  %.1905 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i5956, <8 x double> splat (double 0x3D2AE7F3E733B81F), <8 x double> splat (double 0xBDA93974A8C07C9D))
  %.1908 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i5956, <8 x double> %.1905, <8 x double> splat (double 0x3E21EED8EFF8D898))
  %.1911 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i5956, <8 x double> %.1908, <8 x double> splat (double 0xBE927E4FB7789F5C))
  %.1914 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i5956, <8 x double> %.1911, <8 x double> splat (double 0x3EFA01A01A01A01A))
  %.1917 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i5956, <8 x double> %.1914, <8 x double> splat (double 0xBF56C16C16C16C17))
  %.1920 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i5956, <8 x double> %.1917, <8 x double> splat (double 0x3FA5555555555555))
  %.1923 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i5956, <8 x double> %.1920, <8 x double> splat (double -5.000000e-01))
  %.1926 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i5956, <8 x double> %.1923, <8 x double> splat (double 1.000000e+00))
  %.1927 = bitcast <8 x double> %.1773 to <8 x i64>
  %.8.i5959 = and <8 x i64> %.1927, splat (i64 1)
  %10 = icmp eq <8 x i64> %.8.i5959, zeroinitializer
  %.8.i5962 = shl <8 x i64> %.1927, splat (i64 62)
  %.8.i5963 = and <8 x i64> %.8.i5962, splat (i64 -9223372036854775808)
  %.6.i5967.v = select <8 x i1> %10, <8 x double> %.1900, <8 x double> %.1926
  %.6.i5967 = bitcast <8 x double> %.6.i5967.v to <8 x i64>
  %.6.i5968 = xor <8 x i64> %.8.i5963, %.6.i5967
  %11 = bitcast <8 x i64> %.6.i5968 to <8 x double>
  %.6.i5971 = fdiv contract <8 x double> %11, %.8.i5954
  %.2293 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i5927, <8 x double> splat (double 0x3FE45F306DC9C883), <8 x double> splat (double 0x4338000000000000))
  %.8.i5972 = fadd contract <8 x double> %.2293, splat (double 0xC338000000000000)
  %.2334 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i5972, <8 x double> splat (double 0xBFF921FB54442D18), <8 x double> %.8.i5927)
  %.2351 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i5972, <8 x double> splat (double 0xBC91A62633145C07), <8 x double> %.2334)
  %.6.i5973 = fmul contract <8 x double> %.2351, %.2351
  %.6.i5974 = fmul contract <8 x double> %.2351, %.6.i5973
  %.2380 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i5973, <8 x double> splat (double 0xBD6AE7F3E733B81F), <8 x double> splat (double 0x3DE6124613A86D09))
  %.2383 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i5973, <8 x double> %.2380, <8 x double> splat (double 0xBE5AE64567F544E4))
  %.2386 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i5973, <8 x double> %.2383, <8 x double> splat (double 0x3EC71DE3A556C734))
  %.2389 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i5973, <8 x double> %.2386, <8 x double> splat (double 0xBF2A01A01A01A01A))
  %.2392 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i5973, <8 x double> %.2389, <8 x double> splat (double 0x3F81111111111111))
  %.2395 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i5973, <8 x double> %.2392, <8 x double> splat (double 0xBFC5555555555555))
  %.2420 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i5974, <8 x double> %.2395, <8 x double> %.2351)
  %.2425 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i5973, <8 x double> splat (double 0x3D2AE7F3E733B81F), <8 x double> splat (double 0xBDA93974A8C07C9D))
  %.2428 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i5973, <8 x double> %.2425, <8 x double> splat (double 0x3E21EED8EFF8D898))
  %.2431 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i5973, <8 x double> %.2428, <8 x double> splat (double 0xBE927E4FB7789F5C))
  %.2434 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i5973, <8 x double> %.2431, <8 x double> splat (double 0x3EFA01A01A01A01A))
  %.2437 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i5973, <8 x double> %.2434, <8 x double> splat (double 0xBF56C16C16C16C17))
  %.2440 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i5973, <8 x double> %.2437, <8 x double> splat (double 0x3FA5555555555555))
  %.2443 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i5973, <8 x double> %.2440, <8 x double> splat (double -5.000000e-01))
  %.2446 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i5973, <8 x double> %.2443, <8 x double> splat (double 1.000000e+00))
  %.2447 = bitcast <8 x double> %.2293 to <8 x i64>
  %.2448 = bitcast <8 x double> %.2420 to <8 x i64>
  %.2449 = bitcast <8 x double> %.2446 to <8 x i64>
  %.6.i5975 = xor <8 x i64> %.2449, %.2448
  %.8.i5976 = and <8 x i64> %.2447, splat (i64 1)
  %12 = icmp eq <8 x i64> %.8.i5976, zeroinitializer
  %.6.i5978 = select <8 x i1> %12, <8 x i64> zeroinitializer, <8 x i64> %.6.i5975
  %.8.i5979 = shl <8 x i64> %.2447, splat (i64 62)
  %.8.i5980 = and <8 x i64> %.8.i5979, splat (i64 -9223372036854775808)
  %.8.i5982 = add <8 x i64> %.8.i5979, splat (i64 4611686018427387904)
  %.8.i5983 = and <8 x i64> %.8.i5982, splat (i64 -9223372036854775808)
  %13 = xor <8 x i64> %.8.i5980, %.2448
  %.6.i5985 = xor <8 x i64> %13, %.6.i5978
  %14 = bitcast <8 x i64> %.6.i5985 to <8 x double>
  %15 = xor <8 x i64> %.8.i5983, %.2449
  %.6.i5987 = xor <8 x i64> %15, %.6.i5978
  %16 = bitcast <8 x i64> %.6.i5987 to <8 x double>
  %.8.i5988 = fmul contract <8 x double> %16, splat (double 5.000000e-01)
  %.6.i5989 = fadd contract <8 x double> %.6.i5949, %.6.i5971
  %.6.i5990 = fmul contract <8 x double> %.8.i5988, %.6.i5989
  %.8.i5991 = fmul contract <8 x double> %14, splat (double 5.000000e-01)
  %.6.i5992 = fsub contract <8 x double> %.6.i5949, %.6.i5971
  %.6.i5993 = fmul contract <8 x double> %.8.i5991, %.6.i5992
  %.6.i5994 = fmul contract <8 x double> %.8.i5927, %.8.i5924
  %.8.i5995 = fsub contract <8 x double> zeroinitializer, %.6.i5994
  %.2981 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i5995, <8 x double> splat (double 0x3FE45F306DC9C883), <8 x double> splat (double 0x4338000000000000))
  %.8.i5996 = fadd contract <8 x double> %.2981, splat (double 0xC338000000000000)
  %.3022 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i5996, <8 x double> splat (double 0xBFF921FB54442D18), <8 x double> %.8.i5995)
  %.3039 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i5996, <8 x double> splat (double 0xBC91A62633145C07), <8 x double> %.3022)
  %.6.i5997 = fmul contract <8 x double> %.3039, %.3039
  %.6.i5998 = fmul contract <8 x double> %.3039, %.6.i5997
  %.3068 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i5997, <8 x double> splat (double 0xBD6AE7F3E733B81F), <8 x double> splat (double 0x3DE6124613A86D09))
  %.3071 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i5997, <8 x double> %.3068, <8 x double> splat (double 0xBE5AE64567F544E4))
  %.3074 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i5997, <8 x double> %.3071, <8 x double> splat (double 0x3EC71DE3A556C734))
  %.3077 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i5997, <8 x double> %.3074, <8 x double> splat (double 0xBF2A01A01A01A01A))
  %.3080 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i5997, <8 x double> %.3077, <8 x double> splat (double 0x3F81111111111111))
  %.3083 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i5997, <8 x double> %.3080, <8 x double> splat (double 0xBFC5555555555555))
  %.3108 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i5998, <8 x double> %.3083, <8 x double> %.3039)
  %.3113 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i5997, <8 x double> splat (double 0x3D2AE7F3E733B81F), <8 x double> splat (double 0xBDA93974A8C07C9D))
  %.3116 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i5997, <8 x double> %.3113, <8 x double> splat (double 0x3E21EED8EFF8D898))
  %.3119 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i5997, <8 x double> %.3116, <8 x double> splat (double 0xBE927E4FB7789F5C))
  %.3122 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i5997, <8 x double> %.3119, <8 x double> splat (double 0x3EFA01A01A01A01A))
  %.3125 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i5997, <8 x double> %.3122, <8 x double> splat (double 0xBF56C16C16C16C17))
  %.3128 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i5997, <8 x double> %.3125, <8 x double> splat (double 0x3FA5555555555555))
  %.3131 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i5997, <8 x double> %.3128, <8 x double> splat (double -5.000000e-01))
  %.3134 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i5997, <8 x double> %.3131, <8 x double> splat (double 1.000000e+00))
  %.3135 = bitcast <8 x double> %.2981 to <8 x i64>
  %.3136 = bitcast <8 x double> %.3108 to <8 x i64>
  %.3137 = bitcast <8 x double> %.3134 to <8 x i64>
  %.6.i5999 = xor <8 x i64> %.3137, %.3136
  %.8.i6000 = and <8 x i64> %.3135, splat (i64 1)
  %17 = icmp eq <8 x i64> %.8.i6000, zeroinitializer
  %.6.i6002 = select <8 x i1> %17, <8 x i64> zeroinitializer, <8 x i64> %.6.i5999
  %.8.i6003 = shl <8 x i64> %.3135, splat (i64 62)
  %.8.i6004 = and <8 x i64> %.8.i6003, splat (i64 -9223372036854775808)
  %.8.i6006 = add <8 x i64> %.8.i6003, splat (i64 4611686018427387904)
  %.8.i6007 = and <8 x i64> %.8.i6006, splat (i64 -9223372036854775808)
  %18 = xor <8 x i64> %.8.i6004, %.3136
  %.6.i6009 = xor <8 x i64> %18, %.6.i6002
  %19 = bitcast <8 x i64> %.6.i6009 to <8 x double>
  %20 = xor <8 x i64> %.8.i6007, %.3137
  %.6.i6011 = xor <8 x i64> %20, %.6.i6002
  %21 = bitcast <8 x i64> %.6.i6011 to <8 x double>
  %.6.i6012 = fmul contract <8 x double> %.6.i5993, %19
  %.8.i6013 = fsub contract <8 x double> zeroinitializer, %.6.i6012
  %.3521 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i5990, <8 x double> %21, <8 x double> %.8.i6013)
  %.6.i6014 = fmul contract <8 x double> %.6.i5993, %21
  %.3546 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i5990, <8 x double> %19, <8 x double> %.6.i6014)
  %.3574 = getelementptr inbounds double, ptr %arg.pr.4, i64 %.514.sroa.0.05892
  %.3576 = load <8 x double>, ptr %.3574, align 8
  %.3584 = getelementptr inbounds double, ptr %arg.xr.4, i64 %.514.sroa.0.05892
  %.3586 = load <8 x double>, ptr %.3584, align 8
  %.6.i6015 = fmul contract <8 x double> %.3586, %.899
  %.3611 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.869, <8 x double> %.3576, <8 x double> %.6.i6015)
  %.3619 = getelementptr inbounds double, ptr %arg.pi.4, i64 %.514.sroa.0.05892
  %.3621 = load <8 x double>, ptr %.3619, align 8
  %.3629 = getelementptr inbounds double, ptr %arg.xi.4, i64 %.514.sroa.0.05892
  %.3631 = load <8 x double>, ptr %.3629, align 8
  %.6.i6016 = fmul contract <8 x double> %.3631, %.899
  %.3656 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.869, <8 x double> %.3621, <8 x double> %.6.i6016)
  %.6.i6017 = fmul contract <8 x double> %.3656, %.3546
  %.8.i6018 = fsub contract <8 x double> zeroinitializer, %.6.i6017
  %.6.i6019 = fmul contract <8 x double> %.3611, %.3546
  %.3706 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.3521, <8 x double> %.3611, <8 x double> %.8.i6018)
  %.3759 = getelementptr inbounds double, ptr %arg.hr.4, i64 %.514.sroa.0.05892
  %.3761 = load <8 x double>, ptr %.3759, align 8
  %.6.i6020 = fadd contract <8 x double> %.3761, %.3706
  %.3731 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.3521, <8 x double> %.3656, <8 x double> %.6.i6019)
  store <8 x double> %.6.i6020, ptr %.3759, align 8
  %.3803 = getelementptr inbounds double, ptr %arg.hi.4, i64 %.514.sroa.0.05892
  %.3805 = load <8 x double>, ptr %.3803, align 8
  %.6.i6021 = fadd contract <8 x double> %.3805, %.3731
  store <8 x double> %.6.i6021, ptr %.3803, align 8
  %.524 = icmp samesign ugt i64 %.469.15891.in, 1
  %.537 = add i64 %.466.15890, 8
  %.466.1 = select i1 %.524, i64 %.537, i64 %.466.15890
  %22 = tail call i64 @llvm.smax.i64(i64 %.469.15891.in, i64 2)
  %23 = add nsw i64 %22, -1
  %.514.sroa.0.0 = select i1 %.524, i64 %.466.15890, i64 0
  br i1 %.524, label %B306, label %B1354

B1354:                                            ; preds = %B306, %entry
  store ptr null, ptr %retptr, align 8
  ret void
}

; Function Attrs: mustprogress nocallback nocreateundeforpoison nofree nosync nounwind speculatable willreturn memory(none)
declare <8 x double> @llvm.fabs.v8f64(<8 x double>) #2

; Function Attrs: mustprogress nocallback nocreateundeforpoison nofree nosync nounwind speculatable willreturn memory(none)
declare <8 x double> @llvm.minnum.v8f64(<8 x double>, <8 x double>) #2

; Function Attrs: mustprogress nocallback nocreateundeforpoison nofree nosync nounwind speculatable willreturn memory(none)
declare double @llvm.fma.f64(double, double, double) #2

; Function Attrs: mustprogress nocallback nocreateundeforpoison nofree nosync nounwind speculatable willreturn memory(none)
declare <8 x double> @llvm.sqrt.v8f64(<8 x double>) #2

; Function Attrs: mustprogress nocallback nofree nosync nounwind willreturn memory(none)
declare double @sqrt(double) local_unnamed_addr #4

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
!1 = distinct !{!1, !2, !"_ZN17bnserve_inference13moving_kernel7_source8contractB2v3B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIxLi1E1C7mutable7alignedE: %retptr"}
!2 = distinct !{!2, !"_ZN17bnserve_inference13moving_kernel7_source8contractB2v3B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIxLi1E1C7mutable7alignedE"}
!3 = !{!4, !1}
!4 = distinct !{!4, !5, !"_ZN17bnserve_inference13moving_kernel7_source6_placeB3v14B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!5 = distinct !{!5, !"_ZN17bnserve_inference13moving_kernel7_source6_placeB3v14B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!6 = !{!7, !4, !1}
!7 = distinct !{!7, !8, !"_ZN17bnserve_inference13moving_kernel9_response12coefficientsB3v21B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!8 = distinct !{!8, !"_ZN17bnserve_inference13moving_kernel9_response12coefficientsB3v21B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!9 = !{!10, !1}
!10 = distinct !{!10, !11, !"_ZN17bnserve_inference13moving_kernel8_passing12find_passingB3v40B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIxLi1E1C7mutable7alignedE: %retptr"}
!11 = distinct !{!11, !"_ZN17bnserve_inference13moving_kernel8_passing12find_passingB3v40B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIxLi1E1C7mutable7alignedE"}
!12 = !{!13, !10, !1}
!13 = distinct !{!13, !14, !"_ZN17bnserve_inference13moving_kernel8_passing6_turnsB3v56B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedExx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!14 = distinct !{!14, !"_ZN17bnserve_inference13moving_kernel8_passing6_turnsB3v56B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedExx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!15 = distinct !{!15, !16}
!16 = !{!"llvm.loop.unroll.disable"}
!17 = distinct !{!17, !18}
!18 = !{!"llvm.loop.peeled.count", i32 1}
!19 = !{!"branch_weights", i32 1, i32 99}
!20 = !{!21, !1}
!21 = distinct !{!21, !22, !"_ZN17bnserve_inference13moving_kernel7_source9_polariseB3v77B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!22 = distinct !{!22, !"_ZN17bnserve_inference13moving_kernel7_source9_polariseB3v77B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!23 = !{!24, !21, !1}
!24 = distinct !{!24, !25, !"_ZN17bnserve_inference13moving_kernel7_source5_turnB4v109B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedEd5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!25 = distinct !{!25, !"_ZN17bnserve_inference13moving_kernel7_source5_turnB4v109B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedEd5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!26 = !{!27, !21, !1}
!27 = distinct !{!27, !28, !"_ZN17bnserve_surrogate7adjoint5_sums5splitB4v118B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!28 = distinct !{!28, !"_ZN17bnserve_surrogate7adjoint5_sums5splitB4v118B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!29 = !{!30, !21, !1}
!30 = distinct !{!30, !31, !"_ZN17bnserve_inference12modes_kernel7_source8add_modeB4v119B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dEdd5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!31 = distinct !{!31, !"_ZN17bnserve_inference12modes_kernel7_source8add_modeB4v119B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dEdd5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!32 = !{!33, !21, !1}
!33 = distinct !{!33, !34, !"_ZN17bnserve_inference12modes_kernel7_source8add_modeB4v119B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dEdd5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!34 = distinct !{!34, !"_ZN17bnserve_inference12modes_kernel7_source8add_modeB4v119B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dEdd5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!35 = !{!36, !1}
!36 = distinct !{!36, !37, !"_ZN17bnserve_inference13moving_kernel7_source8_respondB4v120B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!37 = distinct !{!37, !"_ZN17bnserve_inference13moving_kernel7_source8_respondB4v120B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!38 = !{!39, !36, !1}
!39 = distinct !{!39, !40, !"_ZN17bnserve_inference13moving_kernel9_response10short_armsB4v161B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!40 = distinct !{!40, !"_ZN17bnserve_inference13moving_kernel9_response10short_armsB4v161B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!41 = !{!42, !36, !1}
!42 = distinct !{!42, !43, !"_ZN17bnserve_inference13moving_kernel9_response5delayB4v164B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!43 = distinct !{!43, !"_ZN17bnserve_inference13moving_kernel9_response5delayB4v164B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!44 = !{!45, !36, !1}
!45 = distinct !{!45, !46, !"_ZN17bnserve_inference6kernel5_sums9errors_atB4v167B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedExx5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!46 = distinct !{!46, !"_ZN17bnserve_inference6kernel5_sums9errors_atB4v167B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedExx5ArrayIdLi1E1C7mutable7alignedE"}
!47 = !{!"branch_weights", i32 99, i32 1}
!48 = !{!49, !36, !1}
!49 = distinct !{!49, !50, !"_ZN17bnserve_inference6kernel5_sums9errors_atB4v167B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedExx5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!50 = distinct !{!50, !"_ZN17bnserve_inference6kernel5_sums9errors_atB4v167B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedExx5ArrayIdLi1E1C7mutable7alignedE"}
!51 = !{!52, !36, !1}
!52 = distinct !{!52, !53, !"_ZN17bnserve_inference12modes_kernel7_source9calibrateB4v168B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!53 = distinct !{!53, !"_ZN17bnserve_inference12modes_kernel7_source9calibrateB4v168B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!54 = !{!55, !1}
!55 = distinct !{!55, !56, !"_ZN17bnserve_inference12modes_kernel7_source13_add_productsB4v170B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxx5ArrayIxLi1E1C7mutable7alignedEdd5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!56 = distinct !{!56, !"_ZN17bnserve_inference12modes_kernel7_source13_add_productsB4v170B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxx5ArrayIxLi1E1C7mutable7alignedEdd5ArrayIdLi1E1C7mutable7alignedE"}
!57 = !{!58, !55, !1}
!58 = distinct !{!58, !59, !"_ZN17bnserve_inference12modes_kernel7_source6_turnsB4v189B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedEd5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!59 = distinct !{!59, !"_ZN17bnserve_inference12modes_kernel7_source6_turnsB4v189B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedEd5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!60 = !{!61, !55, !1}
!61 = distinct !{!61, !62, !"_ZN17bnserve_inference12modes_kernel7_source6_fixedB4v191B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!62 = distinct !{!62, !"_ZN17bnserve_inference12modes_kernel7_source6_fixedB4v191B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!63 = !{!64, !55, !1}
!64 = distinct !{!64, !65, !"_ZN17bnserve_inference6kernel5_sums9spline_atB4v194B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dEd5ArrayIdLi1E1C7mutable7alignedExxx: %retptr"}
!65 = distinct !{!65, !"_ZN17bnserve_inference6kernel5_sums9spline_atB4v194B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dEd5ArrayIdLi1E1C7mutable7alignedExxx"}
!66 = !{!67, !55, !1}
!67 = distinct !{!67, !68, !"_ZN17bnserve_inference12modes_kernel7_source8_splinedB4v197B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE8UniTupleIxLi3EE8UniTupleIdLi6EE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!68 = distinct !{!68, !"_ZN17bnserve_inference12modes_kernel7_source8_splinedB4v197B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE8UniTupleIxLi3EE8UniTupleIdLi6EE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!69 = !{!70, !55, !1}
!70 = distinct !{!70, !71, !"_ZN17bnserve_inference6kernel5_sums9add_termsB4v202B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEdd5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!71 = distinct !{!71, !"_ZN17bnserve_inference6kernel5_sums9add_termsB4v202B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEdd5ArrayIdLi1E1C7mutable7alignedE"}
!72 = !{!73, !1}
!73 = distinct !{!73, !74, !"_ZN17bnserve_inference12modes_kernel7_source10_add_pairsB4v203B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!74 = distinct !{!74, !"_ZN17bnserve_inference12modes_kernel7_source10_add_pairsB4v203B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!75 = !{!76, !73, !1}
!76 = distinct !{!76, !77, !"_ZN17bnserve_inference12modes_kernel7_source5_pairB4v215B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx: %retptr"}
!77 = distinct !{!77, !"_ZN17bnserve_inference12modes_kernel7_source5_pairB4v215B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx"}
