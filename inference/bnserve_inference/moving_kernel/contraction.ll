; sources: 46fd15deaa19661f4d3ace6c7e825d7d901a04ca649841d9e829533fc08dc33c
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
  %.289.idx.i = mul nsw i64 %.47.i, 200
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
  %.712.i = load i64, ptr %sunkaddr127.i, align 8, !noalias !0
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
  %.256.i.i.i = tail call contract double @llvm.fma.f64(double %.247.i.i.i, double 0x3D2AE7F3E733B81F, double 0xBDA93974A8C07C9D)
  %.257.i.i.i = tail call contract double @llvm.fma.f64(double %.247.i.i.i, double %.256.i.i.i, double 0x3E21EED8EFF8D898)
  %.258.i.i.i = tail call contract double @llvm.fma.f64(double %.247.i.i.i, double %.257.i.i.i, double 0xBE927E4FB7789F5C)
  %.259.i.i.i = tail call contract double @llvm.fma.f64(double %.247.i.i.i, double %.258.i.i.i, double 0x3EFA01A01A01A01A)
  %.260.i.i.i = tail call contract double @llvm.fma.f64(double %.247.i.i.i, double %.259.i.i.i, double 0xBF56C16C16C16C17)
  %.261.i.i.i = tail call contract double @llvm.fma.f64(double %.247.i.i.i, double %.260.i.i.i, double 0x3FA5555555555555)
  %.262.i.i.i = tail call contract double @llvm.fma.f64(double %.247.i.i.i, double %.261.i.i.i, double -5.000000e-01)
  %.263.i.i.i = tail call contract double @llvm.fma.f64(double %.247.i.i.i, double %.262.i.i.i, double 1.000000e+00)
  %.264.i.i.i = bitcast double %.215.i.i.i to i64
  %.265.i.i.i = bitcast double %.255.i.i.i to i64
  %.266.i.i.i = bitcast double %.263.i.i.i to i64
  %.267.i.i.i = xor i64 %.266.i.i.i, %.265.i.i.i
  %.268.i.i.i = and i64 %.264.i.i.i, 1
  %5 = icmp eq i64 %.268.i.i.i, 0
  %.270.i.i.i = select i1 %5, i64 0, i64 %.267.i.i.i
  %.271.i.i.i = shl i64 %.264.i.i.i, 62
  %.272.i.i.i = and i64 %.271.i.i.i, -9223372036854775808
  %.274.i.i.i = add i64 %.271.i.i.i, 4611686018427387904
  %.275.i.i.i = and i64 %.274.i.i.i, -9223372036854775808
  %6 = xor i64 %.272.i.i.i, %.265.i.i.i
  %.277.i.i.i = xor i64 %6, %.270.i.i.i
  %.278.i.i.i = bitcast i64 %.277.i.i.i to double
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
  %.553.i.i.i = fmul contract double %.497.i.i.i, %.278.i.i.i
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
  %sin_h.2.0.i.i.i = phi double [ %.673.i.i.i, %B276.i.i.i ], [ %.278.i.i.i, %B232.if.i.i ]
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
  %exitcond.not.i.i = icmp eq i64 %lsr.iv.next106.i.i, 0
  br i1 %exitcond.not.i.i, label %_ZN17bnserve_inference13moving_kernel7_source6_placeB3v14B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i, label %B232.if.i.i

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
  %.373.i.i = shl i64 %.80.i.i, 1
  %.640.i.i = mul nsw i64 %.50.i.i, %.164.i.i
  %.10071109.not.i.i = icmp slt i64 %.50.i.i, 1
  br i1 %.10071109.not.i.i, label %_ZN17bnserve_inference13moving_kernel8_passing12find_passingB3v40B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIxLi1E1C7mutable7alignedE.exit.i, label %B766.if.lr.ph.i.i

B1206.i.i:                                        ; preds = %B1088.if.i.i, %_ZN17bnserve_inference13moving_kernel8_passing6_turnsB3v55B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedExx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i.i
  br i1 %65, label %B1254.i.i, label %B1238.if.preheader.i.i

B1238.if.preheader.i.i:                           ; preds = %B1206.i.i
  br i1 %80, label %B1238.if.prol.loopexit.i.i, label %B1238.if.prol.i.i

B1238.if.prol.i.i:                                ; preds = %B1238.if.preheader.i.i, %B1238.if.prol.i.i
  %prol.iter.i.i = phi i64 [ %prol.iter.next.i.i, %B1238.if.prol.i.i ], [ 0, %B1238.if.preheader.i.i ]
  %42 = add i64 %prol.iter.i.i, %.80.i.i
  %.1964.prol.i.i = icmp slt i64 %42, 0
  %43 = select i1 %.1964.prol.i.i, i64 %sunkaddr217.i.i, i64 0
  %scevgep200.i.i = getelementptr i8, ptr %lsr.iv198.i.i, i64 %43
  %44 = shl nuw nsw i64 %prol.iter.i.i, 3
  %scevgep24.i.i = getelementptr i8, ptr %scevgep200.i.i, i64 %44
  store double 0.000000e+00, ptr %scevgep24.i.i, align 8, !noalias !9
  %prol.iter.next.i.i = add nuw nsw i64 %prol.iter.i.i, 1
  %prol.iter.cmp.not.i.i = icmp eq i64 %xtraiter.i.i, %prol.iter.next.i.i
  br i1 %prol.iter.cmp.not.i.i, label %B1238.if.prol.loopexit.loopexit.i.i, label %B1238.if.prol.i.i, !llvm.loop !12

B1238.if.prol.loopexit.loopexit.i.i:              ; preds = %B1238.if.prol.i.i
  %45 = sub nsw i64 %..1870.i.i, %prol.iter.next.i.i
  %46 = add i64 %prol.iter.next.i.i, %.80.i.i
  br label %B1238.if.prol.loopexit.i.i

B1238.if.prol.loopexit.i.i:                       ; preds = %B1238.if.prol.loopexit.loopexit.i.i, %B1238.if.preheader.i.i
  %.191210641068.unr.i.i = phi i64 [ %..1870.i.i, %B1238.if.preheader.i.i ], [ %45, %B1238.if.prol.loopexit.loopexit.i.i ]
  %.191910651067.unr.i.i = phi i64 [ %.80.i.i, %B1238.if.preheader.i.i ], [ %46, %B1238.if.prol.loopexit.loopexit.i.i ]
  br i1 %81, label %B1254.i.i, label %B1238.if.preheader179.i.i

B1238.if.preheader179.i.i:                        ; preds = %B1238.if.prol.loopexit.i.i
  %47 = add i64 %.191210641068.unr.i.i, 4
  br label %B1238.if.i.i

B1254.i.i:                                        ; preds = %B1238.if.i.i, %B1238.if.prol.loopexit.i.i, %B1206.i.i
  %scevgep181.i.i = getelementptr i8, ptr %lsr.iv180.i.i, i64 %52
  %scevgep192.i.i = getelementptr i8, ptr %lsr.iv191.i.i, i64 %52
  %lsr.iv.next196.i.i = sub i64 %lsr.iv195.i.i, %.130.1.i.i
  %scevgep199.i.i = getelementptr i8, ptr %lsr.iv198.i.i, i64 %52
  %scevgep205.i.i = getelementptr i8, ptr %lsr.iv204.i.i, i64 %52
  %exitcond1157.not.i.i = icmp eq i64 %.1020.i.i, %.50.i.i
  br i1 %exitcond1157.not.i.i, label %_ZN17bnserve_inference13moving_kernel8_passing12find_passingB3v40B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIxLi1E1C7mutable7alignedE.exit.i, label %B766.if.i.i

B766.if.lr.ph.i.i:                                ; preds = %B288.i.i
  %.548.i.i = load i64, ptr %.547.i1.i, align 8, !noalias !9
  %.460.i.i = load i64, ptr %.459.i.i, align 8, !noalias !9
  %.362.i.i = load i64, ptr %.361.i.i, align 8, !noalias !9
  %.364.i.i = shl i64 %.631.sroa.0.073.i, 4
  %.366.i.i = mul i64 %.364.i.i, %.80.i.i
  %.368.i.i = mul i64 %.366.i.i, %.110.i.i
  %.371.i.i = add nsw i64 %.362.i.i, %.368.i.i
  %.725.i.i = load i64, ptr %.724.i.i, align 8, !noalias !9
  %.637.i.i = load i64, ptr %.636.i.i, align 8, !noalias !9
  %48 = inttoptr i64 %.725.i.i to ptr
  %49 = inttoptr i64 %.637.i.i to ptr
  %50 = inttoptr i64 %.232.i.i to ptr
  %.1129.i.i = getelementptr inbounds double, ptr %50, i64 %.640.i.i
  %.1550.i.i = add i64 %.80.i.i, -1
  %.1870.i.i = sub i64 %.164.i.i, %.80.i.i
  %..1870.i.i = tail call i64 @llvm.smax.i64(i64 %.1870.i.i, i64 0)
  %xtraiter.i.i = and i64 %..1870.i.i, 3
  %scevgep.i2.i = getelementptr i8, ptr %50, i64 8
  %51 = lshr i64 %.122.i.i, 3
  %52 = mul i64 %51, -64
  %53 = shl i64 %51, 6
  %54 = sub i64 8, %53
  %scevgep183.i.i = getelementptr i8, ptr %48, i64 %54
  %55 = shl i64 %.50.i.i, 6
  %56 = mul i64 %55, %51
  %57 = sub i64 8, %56
  %scevgep185.i.i = getelementptr i8, ptr %50, i64 %57
  %scevgep190.i.i = getelementptr i8, ptr %49, i64 8
  %58 = shl i64 %.80.i.i, 3
  %scevgep197.i.i = getelementptr i8, ptr %50, i64 %58
  %sunkaddr217.i.i = shl i64 %.164.i.i, 3
  %59 = shl i64 %.640.i.i, 3
  %60 = inttoptr i64 %.548.i.i to ptr
  %61 = inttoptr i64 %.460.i.i to ptr
  %62 = inttoptr i64 %.371.i.i to ptr
  %.176508.not.i.i.i = icmp slt i64 %.80.i.i, 1
  %.369527.not.i.i.i = icmp slt i64 %.110.i.i, 1
  %.1171.i.i.i = icmp slt i64 %.80.i.i, 2
  %..1133.i.i.i = select i1 %.1171.i.i.i, i64 0, i64 %.1550.i.i
  %.1213538.i.i.i = icmp sgt i64 %..1133.i.i.i, 0
  %.1406.inv.i.i.i = icmp sgt i64 %.80.i.i, 0
  %.1407.i.i.i = select i1 %.1406.inv.i.i.i, i64 0, i64 %.164.i.i
  %63 = getelementptr double, ptr %.1129.i.i, i64 %.1550.i.i
  %.1421.i.i.i = getelementptr double, ptr %63, i64 %.1407.i.i.i
  %64 = icmp slt i64 %.1550.i.i, 1
  %sunkaddr31.i.i = getelementptr inbounds i8, ptr %48, i64 %sunkaddr217.i.i
  %65 = icmp slt i64 %.1870.i.i, 1
  %xtraiter.i.i.i = and i64 %.80.i.i, 3
  %66 = icmp ult i64 %.80.i.i, 4
  %67 = add nsw i64 %.80.i.i, -4
  %68 = lshr i64 %67, 2
  %69 = icmp eq i64 %68, 0
  %70 = add nuw nsw i64 %68, 1
  %71 = and i64 %70, 9223372036854775806
  %72 = and i64 %67, 4
  %lcmp.mod.not9.not.i.i.i = icmp eq i64 %72, 0
  %lcmp.mod.not.i.i.i = icmp eq i64 %xtraiter.i.i.i, 0
  %73 = tail call i64 @llvm.smax.i64(i64 %.80.i.i, i64 1)
  %74 = add nsw i64 %73, -1
  %75 = shl i64 %.80.i.i, 4
  %.375.reass.i.i = mul i64 %75, %.110.i.i
  %76 = add i64 %.375.reass.i.i, 16
  %77 = add i64 %.375.reass.i.i, 24
  %78 = icmp sgt i64 %.80.i.i, 1
  %79 = or disjoint i64 %.375.reass.i.i, 8
  %80 = icmp eq i64 %xtraiter.i.i, 0
  %81 = icmp slt i64 %.1870.i.i, 4
  br label %B766.if.i.i

B766.if.i.i:                                      ; preds = %B766.if.lr.ph.i.i, %B1254.i.i
  %lsr.iv204.i.i = phi ptr [ %50, %B766.if.lr.ph.i.i ], [ %scevgep205.i.i, %B1254.i.i ]
  %lsr.iv198.i.i = phi ptr [ %scevgep197.i.i, %B766.if.lr.ph.i.i ], [ %scevgep199.i.i, %B1254.i.i ]
  %lsr.iv195.i.i = phi i64 [ 1, %B766.if.lr.ph.i.i ], [ %lsr.iv.next196.i.i, %B1254.i.i ]
  %lsr.iv191.i.i = phi ptr [ %scevgep190.i.i, %B766.if.lr.ph.i.i ], [ %scevgep192.i.i, %B1254.i.i ]
  %lsr.iv180.i.i = phi ptr [ %scevgep.i2.i, %B766.if.lr.ph.i.i ], [ %scevgep181.i.i, %B1254.i.i ]
  %.101310761114.i.i = phi i64 [ 0, %B766.if.lr.ph.i.i ], [ %.1020.i.i, %B1254.i.i ]
  %.1020.i.i = add nuw nsw i64 %.101310761114.i.i, 1
  %.1051.i.i = mul nsw i64 %.101310761114.i.i, %.164.i.i
  %.1063.i.i = getelementptr inbounds double, ptr %50, i64 %.1051.i.i
  %.1200.i.i = shl nuw nsw i64 %.101310761114.i.i, 1
  %.1202.i.i = mul nsw i64 %.1200.i.i, %.164.i.i
  %.1214.i.i = getelementptr inbounds double, ptr %60, i64 %.1202.i.i
  %.1268.neg.i.i = xor i64 %.1200.i.i, -1
  %.1270.i.i = mul i64 %.130.1.i.i, %.1268.neg.i.i
  %.1282.i.i = getelementptr inbounds double, ptr %60, i64 %.1270.i.i
  br i1 %.176508.not.i.i.i, label %B60.i.i.i, label %B34.if.preheader.i.i.i

B34.if.preheader.i.i.i:                           ; preds = %B766.if.i.i
  br i1 %66, label %B34.if.epil.preheader.i.i.i, label %B34.if.preheader.new.i.i.i

B34.if.preheader.new.i.i.i:                       ; preds = %B34.if.preheader.i.i.i
  br i1 %69, label %B34.if.epil.preheader1.i.i.i, label %B34.if.i.i.i

B60.loopexit.unr-lcssa.unr-lcssa.i.i.i:           ; preds = %B34.if.i.i.i
  br i1 %lcmp.mod.not9.not.i.i.i, label %B34.if.epil.preheader1.i.i.i, label %B60.loopexit.unr-lcssa.i.i.i

B34.if.epil.preheader1.i.i.i:                     ; preds = %B60.loopexit.unr-lcssa.unr-lcssa.i.i.i, %B34.if.preheader.new.i.i.i
  %.182507509.epil.init5.i.i.i = phi i64 [ 0, %B34.if.preheader.new.i.i.i ], [ %.189.3.1.i.i.i, %B60.loopexit.unr-lcssa.unr-lcssa.i.i.i ]
  %sunkaddr.epil.i.i.i = shl i64 %.182507509.epil.init5.i.i.i, 3
  %sunkaddr50.epil.i.i.i = getelementptr i8, ptr %.1063.i.i, i64 %sunkaddr.epil.i.i.i
  store double 0.000000e+00, ptr %sunkaddr50.epil.i.i.i, align 8, !noalias !14
  %sunkaddr52.epil.i.i.i = getelementptr i8, ptr %.1129.i.i, i64 %sunkaddr.epil.i.i.i
  store double 0.000000e+00, ptr %sunkaddr52.epil.i.i.i, align 8, !noalias !14
  %sunkaddr55.epil.i.i.i = getelementptr i8, ptr %sunkaddr50.epil.i.i.i, i64 8
  store double 0.000000e+00, ptr %sunkaddr55.epil.i.i.i, align 8, !noalias !14
  %sunkaddr58.epil.i.i.i = getelementptr i8, ptr %sunkaddr52.epil.i.i.i, i64 8
  store double 0.000000e+00, ptr %sunkaddr58.epil.i.i.i, align 8, !noalias !14
  %sunkaddr61.epil.i.i.i = getelementptr i8, ptr %sunkaddr50.epil.i.i.i, i64 16
  store double 0.000000e+00, ptr %sunkaddr61.epil.i.i.i, align 8, !noalias !14
  %sunkaddr64.epil.i.i.i = getelementptr i8, ptr %sunkaddr52.epil.i.i.i, i64 16
  store double 0.000000e+00, ptr %sunkaddr64.epil.i.i.i, align 8, !noalias !14
  %.189.3.epil.i.i.i = add nuw nsw i64 %.182507509.epil.init5.i.i.i, 4
  %sunkaddr67.epil.i.i.i = getelementptr i8, ptr %sunkaddr50.epil.i.i.i, i64 24
  store double 0.000000e+00, ptr %sunkaddr67.epil.i.i.i, align 8, !noalias !14
  %sunkaddr70.epil.i.i.i = getelementptr i8, ptr %sunkaddr52.epil.i.i.i, i64 24
  store double 0.000000e+00, ptr %sunkaddr70.epil.i.i.i, align 8, !noalias !14
  br label %B60.loopexit.unr-lcssa.i.i.i

B60.loopexit.unr-lcssa.i.i.i:                     ; preds = %B34.if.epil.preheader1.i.i.i, %B60.loopexit.unr-lcssa.unr-lcssa.i.i.i
  %.189.3.lcssa.i.i.i = phi i64 [ %.189.3.epil.i.i.i, %B34.if.epil.preheader1.i.i.i ], [ %.189.3.1.i.i.i, %B60.loopexit.unr-lcssa.unr-lcssa.i.i.i ]
  br i1 %lcmp.mod.not.i.i.i, label %B60.i.i.i, label %B34.if.epil.preheader.i.i.i

B34.if.epil.preheader.i.i.i:                      ; preds = %B60.loopexit.unr-lcssa.i.i.i, %B34.if.preheader.i.i.i
  %.182507509.epil.init.i.i.i = phi i64 [ 0, %B34.if.preheader.i.i.i ], [ %.189.3.lcssa.i.i.i, %B60.loopexit.unr-lcssa.i.i.i ]
  %82 = shl i64 %.182507509.epil.init.i.i.i, 3
  %scevgep30.i.i.i = getelementptr i8, ptr %.1129.i.i, i64 %82
  %scevgep32.i.i.i = getelementptr i8, ptr %.1063.i.i, i64 %82
  br label %B34.if.epil.i.i.i

B34.if.epil.i.i.i:                                ; preds = %B34.if.epil.i.i.i, %B34.if.epil.preheader.i.i.i
  %epil.iter.i.i.i = phi i64 [ %epil.iter.next.i.i.i, %B34.if.epil.i.i.i ], [ 0, %B34.if.epil.preheader.i.i.i ]
  %83 = shl i64 %epil.iter.i.i.i, 3
  %scevgep42.i.i.i = getelementptr i8, ptr %scevgep32.i.i.i, i64 %83
  store double 0.000000e+00, ptr %scevgep42.i.i.i, align 8, !noalias !14
  %scevgep41.i.i.i = getelementptr i8, ptr %scevgep30.i.i.i, i64 %83
  store double 0.000000e+00, ptr %scevgep41.i.i.i, align 8, !noalias !14
  %epil.iter.next.i.i.i = add i64 %epil.iter.i.i.i, 1
  %epil.iter.cmp.not.i.i.i = icmp eq i64 %xtraiter.i.i.i, %epil.iter.next.i.i.i
  br i1 %epil.iter.cmp.not.i.i.i, label %B60.i.i.i, label %B34.if.epil.i.i.i, !llvm.loop !17

B60.i.i.i:                                        ; preds = %B34.if.epil.i.i.i, %B60.loopexit.unr-lcssa.i.i.i, %B766.if.i.i
  br i1 %.369527.not.i.i.i, label %B682.i.i.i, label %B112.if.i.i.i

B678.i.i.i:                                       ; preds = %B196.if.i.i.i, %B112.if.i.i.i
  %lsr.iv.next8.i.i.i = add i64 %lsr.iv7.i.i.i, %.373.i.i
  %scevgep14.i.i.i = getelementptr i8, ptr %lsr.iv13.i.i.i, i64 %75
  %exitcond544.not.i.i.i = icmp eq i64 %.382.i.i3.i, %.110.i.i
  br i1 %exitcond544.not.i.i.i, label %B682.i.i.i, label %B112.if.i.i.i

B682.i.i.i:                                       ; preds = %B678.i.i.i, %B60.i.i.i
  br i1 %.1213538.i.i.i, label %B718.if.i.i.i, label %_ZN17bnserve_inference13moving_kernel8_passing6_turnsB3v55B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedExx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i.i

B34.if.i.i.i:                                     ; preds = %B34.if.preheader.new.i.i.i, %B34.if.i.i.i
  %lsr.iv23.i.i.i = phi i64 [ %lsr.iv.next24.i.i.i, %B34.if.i.i.i ], [ %71, %B34.if.preheader.new.i.i.i ]
  %.182507509.i.i.i = phi i64 [ %.189.3.1.i.i.i, %B34.if.i.i.i ], [ 0, %B34.if.preheader.new.i.i.i ]
  %sunkaddr64.i.i.i = shl i64 %.182507509.i.i.i, 3
  %sunkaddr65.i.i.i = getelementptr i8, ptr %.1063.i.i, i64 %sunkaddr64.i.i.i
  store double 0.000000e+00, ptr %sunkaddr65.i.i.i, align 8, !noalias !14
  %sunkaddr67.i.i.i = getelementptr i8, ptr %.1129.i.i, i64 %sunkaddr64.i.i.i
  store double 0.000000e+00, ptr %sunkaddr67.i.i.i, align 8, !noalias !14
  %sunkaddr69.i.i.i = getelementptr i8, ptr %sunkaddr65.i.i.i, i64 8
  store double 0.000000e+00, ptr %sunkaddr69.i.i.i, align 8, !noalias !14
  %sunkaddr72.i.i.i = getelementptr i8, ptr %sunkaddr67.i.i.i, i64 8
  store double 0.000000e+00, ptr %sunkaddr72.i.i.i, align 8, !noalias !14
  %sunkaddr75.i.i.i = getelementptr i8, ptr %sunkaddr65.i.i.i, i64 16
  store double 0.000000e+00, ptr %sunkaddr75.i.i.i, align 8, !noalias !14
  %sunkaddr78.i.i.i = getelementptr i8, ptr %sunkaddr67.i.i.i, i64 16
  store double 0.000000e+00, ptr %sunkaddr78.i.i.i, align 8, !noalias !14
  %sunkaddr81.i.i.i = getelementptr i8, ptr %sunkaddr65.i.i.i, i64 24
  store double 0.000000e+00, ptr %sunkaddr81.i.i.i, align 8, !noalias !14
  %sunkaddr84.i.i.i = getelementptr i8, ptr %sunkaddr67.i.i.i, i64 24
  store double 0.000000e+00, ptr %sunkaddr84.i.i.i, align 8, !noalias !14
  %sunkaddr87.i.i.i = getelementptr i8, ptr %sunkaddr65.i.i.i, i64 32
  store double 0.000000e+00, ptr %sunkaddr87.i.i.i, align 8, !noalias !14
  %sunkaddr90.i.i.i = getelementptr i8, ptr %sunkaddr67.i.i.i, i64 32
  store double 0.000000e+00, ptr %sunkaddr90.i.i.i, align 8, !noalias !14
  %sunkaddr93.i.i.i = getelementptr i8, ptr %sunkaddr65.i.i.i, i64 40
  store double 0.000000e+00, ptr %sunkaddr93.i.i.i, align 8, !noalias !14
  %sunkaddr96.i.i.i = getelementptr i8, ptr %sunkaddr67.i.i.i, i64 40
  store double 0.000000e+00, ptr %sunkaddr96.i.i.i, align 8, !noalias !14
  %sunkaddr99.i.i.i = getelementptr i8, ptr %sunkaddr65.i.i.i, i64 48
  store double 0.000000e+00, ptr %sunkaddr99.i.i.i, align 8, !noalias !14
  %sunkaddr102.i.i.i = getelementptr i8, ptr %sunkaddr67.i.i.i, i64 48
  store double 0.000000e+00, ptr %sunkaddr102.i.i.i, align 8, !noalias !14
  %.189.3.1.i.i.i = add i64 %.182507509.i.i.i, 8
  %sunkaddr103.i.i.i = shl i64 %.189.3.1.i.i.i, 3
  %sunkaddr104.i.i.i = getelementptr i8, ptr %.1063.i.i, i64 %sunkaddr103.i.i.i
  %sunkaddr106.i.i.i = getelementptr i8, ptr %sunkaddr104.i.i.i, i64 -8
  store double 0.000000e+00, ptr %sunkaddr106.i.i.i, align 8, !noalias !14
  %sunkaddr108.i.i.i = getelementptr i8, ptr %.1129.i.i, i64 %sunkaddr103.i.i.i
  %sunkaddr109.i.i.i = getelementptr i8, ptr %sunkaddr108.i.i.i, i64 -8
  store double 0.000000e+00, ptr %sunkaddr109.i.i.i, align 8, !noalias !14
  %lsr.iv.next24.i.i.i = add i64 %lsr.iv23.i.i.i, -2
  %niter.ncmp.1.i.i.i = icmp eq i64 %lsr.iv.next24.i.i.i, 0
  br i1 %niter.ncmp.1.i.i.i, label %B60.loopexit.unr-lcssa.unr-lcssa.i.i.i, label %B34.if.i.i.i

B112.if.i.i.i:                                    ; preds = %B60.i.i.i, %B678.i.i.i
  %lsr.iv13.i.i.i = phi ptr [ %scevgep14.i.i.i, %B678.i.i.i ], [ %62, %B60.i.i.i ]
  %lsr.iv7.i.i.i = phi i64 [ %lsr.iv.next8.i.i.i, %B678.i.i.i ], [ 0, %B60.i.i.i ]
  %.375520530.i.i.i = phi i64 [ %.382.i.i3.i, %B678.i.i.i ], [ 0, %B60.i.i.i ]
  %.382.i.i3.i = add nuw nsw i64 %.375520530.i.i.i, 1
  %84 = getelementptr i64, ptr %61, i64 %.375520530.i.i.i
  %.440.i.i.i = load i64, ptr %84, align 8, !noalias !14
  %.442.i.i.i = icmp eq i64 %.440.i.i.i, %.101310761114.i.i
  %or.cond.i.i.i = and i1 %78, %.442.i.i.i
  br i1 %or.cond.i.i.i, label %B196.if.i.i.i, label %B678.i.i.i

B196.if.i.i.i:                                    ; preds = %B112.if.i.i.i, %B196.if.i.i.i
  %lsr.iv3.i.i.i = phi i64 [ %lsr.iv.next4.i.i.i, %B196.if.i.i.i ], [ 0, %B112.if.i.i.i ]
  %lsr.iv.i.i.i = phi i64 [ %lsr.iv.next.i.i.i, %B196.if.i.i.i ], [ %74, %B112.if.i.i.i ]
  %sunkaddr110.i.i.i = shl i64 %lsr.iv3.i.i.i, 2
  %sunkaddr111.i.i.i = getelementptr i8, ptr %.1214.i.i, i64 %sunkaddr110.i.i.i
  %sunkaddr112.i.i.i = getelementptr i8, ptr %sunkaddr111.i.i.i, i64 8
  %.602.i.i.i = load double, ptr %sunkaddr112.i.i.i, align 8, !noalias !14
  %.632.i.i.i = load double, ptr %sunkaddr111.i.i.i, align 8, !noalias !14
  %.633.i.i.i = fmul contract double %.602.i.i.i, %.632.i.i.i
  %sunkaddr116.i.i.i = getelementptr i8, ptr %.1282.i.i, i64 %sunkaddr110.i.i.i
  %sunkaddr117.i.i.i = getelementptr i8, ptr %sunkaddr116.i.i.i, i64 8
  %.664.i.i.i = load double, ptr %sunkaddr117.i.i.i, align 8, !noalias !14
  %.694.i.i.i = load double, ptr %sunkaddr116.i.i.i, align 8, !noalias !14
  %.695.i.i.i = fmul contract double %.664.i.i.i, %.694.i.i.i
  %.696.i.i.i = fadd contract double %.633.i.i.i, %.695.i.i.i
  %.758.i.i.i = fmul contract double %.602.i.i.i, %.694.i.i.i
  %.820.i.i.i = fmul contract double %.632.i.i.i, %.664.i.i.i
  %.821.i.i.i = fsub contract double %.758.i.i.i, %.820.i.i.i
  %85 = add i64 %lsr.iv3.i.i.i, %lsr.iv7.i.i.i
  %.839.i.i.i = icmp slt i64 %85, -2
  %86 = shl i64 %lsr.iv3.i.i.i, 3
  %87 = select i1 %.839.i.i.i, i64 %76, i64 16
  %scevgep39.i.i.i = getelementptr i8, ptr %lsr.iv13.i.i.i, i64 %87
  %scevgep40.i.i.i = getelementptr i8, ptr %scevgep39.i.i.i, i64 %86
  %.855.i.i.i = load double, ptr %scevgep40.i.i.i, align 8, !noalias !14
  %.873.i.i.i = icmp slt i64 %85, -3
  %88 = select i1 %.873.i.i.i, i64 %77, i64 24
  %scevgep37.i.i.i = getelementptr i8, ptr %lsr.iv13.i.i.i, i64 %88
  %scevgep22.i.i.i = getelementptr i8, ptr %scevgep37.i.i.i, i64 %86
  %.889.i.i.i = load double, ptr %scevgep22.i.i.i, align 8, !noalias !14
  %.906.i.i.i = icmp slt i64 %85, 0
  %89 = select i1 %.906.i.i.i, i64 %79, i64 8
  %scevgep19.i.i.i = getelementptr i8, ptr %lsr.iv13.i.i.i, i64 %89
  %scevgep20.i.i.i = getelementptr i8, ptr %scevgep19.i.i.i, i64 %86
  %scevgep21.i.i.i = getelementptr i8, ptr %scevgep20.i.i.i, i64 -8
  %.922.i.i.i = load double, ptr %scevgep21.i.i.i, align 8, !noalias !14
  %.956.i.i.i = load double, ptr %scevgep20.i.i.i, align 8, !noalias !14
  %.957.i.i.i = fmul contract double %.855.i.i.i, %.922.i.i.i
  %.958.i.i.i = fmul contract double %.889.i.i.i, %.956.i.i.i
  %.959.i.i7.i = fadd contract double %.957.i.i.i, %.958.i.i.i
  %.960.i.i.i = fmul contract double %.889.i.i.i, %.922.i.i.i
  %.961.i.i.i = fmul contract double %.855.i.i.i, %.956.i.i.i
  %.962.i.i.i = fsub contract double %.960.i.i.i, %.961.i.i.i
  %.963.i.i.i = fmul contract double %.696.i.i.i, %.959.i.i7.i
  %.964.i.i.i = fmul contract double %.821.i.i.i, %.962.i.i.i
  %.965.i.i.i = fsub contract double %.963.i.i.i, %.964.i.i.i
  %.966.i.i.i = fmul contract double %.821.i.i.i, %.959.i.i7.i
  %.967.i.i.i = fmul contract double %.696.i.i.i, %.962.i.i.i
  %.968.i.i.i = fadd contract double %.966.i.i.i, %.967.i.i.i
  %scevgep5.i.i.i = getelementptr i8, ptr %.1063.i.i, i64 %sunkaddr110.i.i.i
  %.998.i.i8.i = load double, ptr %scevgep5.i.i.i, align 8, !noalias !14
  %.999.i.i.i = fmul contract double %.965.i.i.i, %.965.i.i.i
  %.1000.i.i9.i = fmul contract double %.968.i.i.i, %.968.i.i.i
  %.1001.i.i.i = fsub contract double %.999.i.i.i, %.1000.i.i9.i
  %.1002.i.i.i = fadd contract double %.998.i.i8.i, %.1001.i.i.i
  store double %.1002.i.i.i, ptr %scevgep5.i.i.i, align 8, !noalias !14
  %scevgep4.i.i.i = getelementptr i8, ptr %.1129.i.i, i64 %sunkaddr110.i.i.i
  %.1062.i.i.i = load double, ptr %scevgep4.i.i.i, align 8, !noalias !14
  %.1063.i.i10.i = fmul contract double %.965.i.i.i, 2.000000e+00
  %.1064.i.i11.i = fmul contract double %.968.i.i.i, %.1063.i.i10.i
  %.1065.i.i.i = fadd contract double %.1062.i.i.i, %.1064.i.i11.i
  store double %.1065.i.i.i, ptr %scevgep4.i.i.i, align 8, !noalias !14
  %lsr.iv.next.i.i.i = add nsw i64 %lsr.iv.i.i.i, -1
  %lsr.iv.next4.i.i.i = add nuw i64 %lsr.iv3.i.i.i, 2
  %exitcond543.not.i.i.i = icmp eq i64 %lsr.iv.next.i.i.i, 0
  br i1 %exitcond543.not.i.i.i, label %B678.i.i.i, label %B196.if.i.i.i

B718.if.i.i.i:                                    ; preds = %B682.i.i.i, %B718.if.i.i.i
  %.1219537539.i.i.i = phi i64 [ %.1226.i.i.i, %B718.if.i.i.i ], [ 0, %B682.i.i.i ]
  %.1226.i.i.i = add nuw nsw i64 %.1219537539.i.i.i, 1
  %90 = shl i64 %.1219537539.i.i.i, 3
  %scevgep2.i.i.i = getelementptr i8, ptr %.1063.i.i, i64 %90
  %.1281.i.i.i = load double, ptr %scevgep2.i.i.i, align 8, !noalias !14
  %scevgep.i.i.i = getelementptr i8, ptr %.1129.i.i, i64 %90
  %.1311.i.i.i = load double, ptr %scevgep.i.i.i, align 8, !noalias !14
  %.1312.i.i.i = fmul contract double %.1281.i.i.i, %.1281.i.i.i
  %.1313.i.i.i = fmul contract double %.1311.i.i.i, %.1311.i.i.i
  %.1314.i.i.i = fadd contract double %.1312.i.i.i, %.1313.i.i.i
  %.1315.i.i.i = tail call contract double @llvm.sqrt.f64(double %.1314.i.i.i)
  %.1316.i.i.i = fadd contract double %.1281.i.i.i, %.1315.i.i.i
  %.1317.i.i.i = fadd contract double %.1316.i.i.i, 1.000000e-300
  %.1321.i.i.i = fdiv contract double %.1311.i.i.i, %.1317.i.i.i
  %.1322.i.i.i = fmul contract double %.1321.i.i.i, %.1321.i.i.i
  %.1323.i.i.i = fadd contract double %.1322.i.i.i, 1.000000e+00
  %.1324.i.i.i = tail call contract double @llvm.sqrt.f64(double %.1323.i.i.i)
  %.1325.i.i.i = fadd contract double %.1324.i.i.i, 1.000000e+00
  %.1329.i.i.i = fdiv contract double %.1321.i.i.i, %.1325.i.i.i
  %.1330.i.i.i = fmul contract double %.1329.i.i.i, %.1329.i.i.i
  %.1331.i.i.i = fmul contract double %.1330.i.i.i, 0x3F677AE9349F5F7A
  %.1332.i.i.i = fadd contract double %.1331.i.i.i, 0xBF908DC039C4DC63
  %.1333.i.i.i = fmul contract double %.1330.i.i.i, %.1332.i.i.i
  %.1334.i.i.i = fadd contract double %.1333.i.i.i, 0x3FA5F83FB7E8F47D
  %.1335.i.i.i = fmul contract double %.1330.i.i.i, %.1334.i.i.i
  %.1336.i.i.i = fadd contract double %.1335.i.i.i, 0xBFB3462E8D8711AD
  %.1337.i.i.i = fmul contract double %.1330.i.i.i, %.1336.i.i.i
  %.1338.i.i.i = fadd contract double %.1337.i.i.i, 0x3FBB47B06AC4D989
  %.1339.i.i.i = fmul contract double %.1330.i.i.i, %.1338.i.i.i
  %.1340.i.i.i = fadd contract double %.1339.i.i.i, 0xBFC22FF8E008E644
  %.1341.i.i.i = fmul contract double %.1330.i.i.i, %.1340.i.i.i
  %.1342.i.i.i = fadd contract double %.1341.i.i.i, 0x3FC9977C9B288755
  %.1343.i.i.i = fmul contract double %.1330.i.i.i, %.1342.i.i.i
  %.1344.i.i.i = fadd contract double %.1343.i.i.i, 0xBFD5554D72204448
  %.1345.i.i.i = fmul contract double %.1330.i.i.i, %.1344.i.i.i
  %.1346.i.i.i = fadd contract double %.1345.i.i.i, 1.000000e+00
  %.1347.i.i.i = fmul contract double %.1329.i.i.i, 2.000000e+00
  %.1348.i.i.i = fmul contract double %.1347.i.i.i, %.1346.i.i.i
  store double %.1348.i.i.i, ptr %scevgep.i.i.i, align 8, !noalias !14
  %exitcond545.not.i.i.i = icmp eq i64 %..1133.i.i.i, %.1226.i.i.i
  br i1 %exitcond545.not.i.i.i, label %_ZN17bnserve_inference13moving_kernel8_passing6_turnsB3v55B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedExx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i.i, label %B718.if.i.i.i

_ZN17bnserve_inference13moving_kernel8_passing6_turnsB3v55B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedExx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i.i: ; preds = %B718.if.i.i.i, %B682.i.i.i
  store double 0.000000e+00, ptr %.1421.i.i.i, align 8, !noalias !14
  %.1404.i.i = icmp slt i64 %.1051.i.i, 0
  %.1405.i.i = select i1 %.1404.i.i, i64 %.640.i.i, i64 0
  %91 = getelementptr double, ptr %49, i64 %.1051.i.i
  %.1419.i.i = getelementptr double, ptr %91, i64 %.1405.i.i
  %.1420.i.i = load double, ptr %.1419.i.i, align 8, !noalias !9
  %.1450.i.i = load double, ptr %sunkaddr31.i.i, align 8, !noalias !9
  %.1480.i.i = load double, ptr %.1129.i.i, align 8, !noalias !9
  %.1481.i.i = fmul contract double %.1450.i.i, %.1480.i.i
  %.1482.i.i = fsub contract double %.1420.i.i, %.1481.i.i
  store double %.1482.i.i, ptr %.1063.i.i, align 8, !noalias !9
  br i1 %64, label %B1206.i.i, label %B1088.if.i.i

B1088.if.i.i:                                     ; preds = %_ZN17bnserve_inference13moving_kernel8_passing6_turnsB3v55B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedExx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i.i, %B1088.if.i.i
  %lsr.iv.i4.i = phi i64 [ %lsr.iv.next.i5.i, %B1088.if.i.i ], [ 0, %_ZN17bnserve_inference13moving_kernel8_passing6_turnsB3v55B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedExx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i.i ]
  %92 = add i64 %lsr.iv.i4.i, %lsr.iv195.i.i
  %.1648.i.i = icmp slt i64 %92, 0
  %93 = select i1 %.1648.i.i, i64 %59, i64 0
  %scevgep193.i.i = getelementptr i8, ptr %lsr.iv191.i.i, i64 %93
  %94 = shl i64 %lsr.iv.i4.i, 3
  %scevgep194.i.i = getelementptr i8, ptr %scevgep193.i.i, i64 %94
  %.1664.i.i = load double, ptr %scevgep194.i.i, align 8, !noalias !9
  %sunkaddr32.i.i = getelementptr i8, ptr %48, i64 %94
  %sunkaddr33.i.i = getelementptr i8, ptr %sunkaddr32.i.i, i64 8
  %.1694.i.i = load double, ptr %sunkaddr33.i.i, align 8, !noalias !9
  %scevgep20.i.i = getelementptr i8, ptr %scevgep185.i.i, i64 %94
  %scevgep21.i.i = getelementptr i8, ptr %scevgep20.i.i, i64 -8
  %.1725.i.i = load double, ptr %scevgep21.i.i, align 8, !noalias !9
  %.1726.i.i = fmul contract double %.1694.i.i, %.1725.i.i
  %scevgep12.i.i = getelementptr i8, ptr %scevgep183.i.i, i64 %94
  %.1756.i.i = load double, ptr %scevgep12.i.i, align 8, !noalias !9
  %.1786.i.i = load double, ptr %scevgep20.i.i, align 8, !noalias !9
  %.1787.i.i = fmul contract double %.1756.i.i, %.1786.i.i
  %.1788.i.i = fadd contract double %.1726.i.i, %.1787.i.i
  %.1789.i.i = fsub contract double %.1664.i.i, %.1788.i.i
  %scevgep11.i.i = getelementptr i8, ptr %lsr.iv180.i.i, i64 %94
  store double %.1789.i.i, ptr %scevgep11.i.i, align 8, !noalias !9
  %lsr.iv.next.i5.i = add nuw nsw i64 %lsr.iv.i4.i, 1
  %exitcond.not.i6.i = icmp eq i64 %.1550.i.i, %lsr.iv.next.i5.i
  br i1 %exitcond.not.i6.i, label %B1206.i.i, label %B1088.if.i.i

B1238.if.i.i:                                     ; preds = %B1238.if.i.i, %B1238.if.preheader179.i.i
  %lsr.iv202.i.i = phi i64 [ %47, %B1238.if.preheader179.i.i ], [ %lsr.iv.next203.i.i, %B1238.if.i.i ]
  %.191910651067.i.i = phi i64 [ %.191910651067.unr.i.i, %B1238.if.preheader179.i.i ], [ %103, %B1238.if.i.i ]
  %.1964.i.i = icmp slt i64 %.191910651067.i.i, 0
  %95 = select i1 %.1964.i.i, i64 %sunkaddr217.i.i, i64 0
  %scevgep212.i.i = getelementptr i8, ptr %lsr.iv204.i.i, i64 %95
  %96 = shl i64 %.191910651067.i.i, 3
  %scevgep213.i.i = getelementptr i8, ptr %scevgep212.i.i, i64 %96
  store double 0.000000e+00, ptr %scevgep213.i.i, align 8, !noalias !9
  %97 = add i64 %.191910651067.i.i, 1
  %.1964.1.i.i = icmp slt i64 %97, 0
  %98 = select i1 %.1964.1.i.i, i64 %sunkaddr217.i.i, i64 0
  %scevgep214.i.i = getelementptr i8, ptr %lsr.iv204.i.i, i64 %98
  %scevgep29.i.i = getelementptr i8, ptr %scevgep214.i.i, i64 %96
  %scevgep30.i.i = getelementptr i8, ptr %scevgep29.i.i, i64 8
  store double 0.000000e+00, ptr %scevgep30.i.i, align 8, !noalias !9
  %99 = add i64 %.191910651067.i.i, 2
  %.1964.2.i.i = icmp slt i64 %99, 0
  %100 = select i1 %.1964.2.i.i, i64 %sunkaddr217.i.i, i64 0
  %scevgep209.i.i = getelementptr i8, ptr %lsr.iv204.i.i, i64 %100
  %scevgep27.i.i = getelementptr i8, ptr %scevgep209.i.i, i64 %96
  %scevgep28.i.i = getelementptr i8, ptr %scevgep27.i.i, i64 16
  store double 0.000000e+00, ptr %scevgep28.i.i, align 8, !noalias !9
  %101 = add i64 %.191910651067.i.i, 3
  %.1964.3.i.i = icmp slt i64 %101, 0
  %102 = select i1 %.1964.3.i.i, i64 %sunkaddr217.i.i, i64 0
  %scevgep206.i.i = getelementptr i8, ptr %lsr.iv204.i.i, i64 %102
  %scevgep25.i.i = getelementptr i8, ptr %scevgep206.i.i, i64 %96
  %scevgep26.i.i = getelementptr i8, ptr %scevgep25.i.i, i64 24
  store double 0.000000e+00, ptr %scevgep26.i.i, align 8, !noalias !9
  %lsr.iv.next203.i.i = add i64 %lsr.iv202.i.i, -4
  %.1913.3.i.i = icmp sgt i64 %lsr.iv.next203.i.i, 4
  %103 = add i64 %.191910651067.i.i, 4
  br i1 %.1913.3.i.i, label %B1238.if.i.i, label %B1254.i.i

_ZN17bnserve_inference13moving_kernel8_passing12find_passingB3v40B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIxLi1E1C7mutable7alignedE.exit.i: ; preds = %B1254.i.i, %B288.i.i, %_ZN17bnserve_inference13moving_kernel7_source6_placeB3v14B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i
  %.835.sroa.12.1.i = inttoptr i64 %.232.i.i to ptr
  br i1 %104, label %.1216.if.i, label %.1216.endif.preheader.i, !prof !18

B1076.i:                                          ; preds = %.1995.endif.preheader.i, %.1604.if.i
  br i1 %.21261117.not.i, label %B1468.i, label %B1120.if.preheader.i

B1120.if.preheader.i:                             ; preds = %B1076.i
  %.548.i123.i = shl i64 %.631.sroa.0.073.i, 4
  br label %B1120.if.i

B1120.loopexit.i:                                 ; preds = %_ZN17bnserve_inference12modes_kernel7_source10_add_pairsB4v169B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i, %_ZN17bnserve_inference13moving_kernel7_source9_polariseB3v58B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i
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
  %sunkaddr127.i = getelementptr i8, ptr %arg.arguments, i64 176
  %.109.i.i = getelementptr i8, ptr %arg.arguments, i64 128
  %.193.i.i = getelementptr i8, ptr %arg.arguments, i64 312
  %.227.i.i = getelementptr i8, ptr %arg.arguments, i64 320
  %104 = icmp slt i64 %.425.i, 1
  %105 = icmp slt i64 %.429.i, 2
  %106 = icmp sgt i64 %"$phi500.0.2.0.i", 0
  %.152.i.i = getelementptr i8, ptr %arg.arguments, i64 32
  %sunkaddr10.i.i = getelementptr i8, ptr %arg.arguments, i64 40
  %sunkaddr11.i.i = getelementptr i8, ptr %arg.arguments, i64 48
  %sunkaddr.i.i = getelementptr i8, ptr %arg.arguments, i64 272
  %sunkaddr12.i.i = getelementptr i8, ptr %arg.arguments, i64 304
  %.547.i1.i = getelementptr i8, ptr %arg.arguments, i64 280
  %.459.i.i = getelementptr i8, ptr %arg.arguments, i64 152
  %.361.i.i = getelementptr i8, ptr %arg.arguments, i64 168
  %.724.i.i = getelementptr i8, ptr %arg.arguments, i64 296
  %.636.i.i = getelementptr i8, ptr %arg.arguments, i64 288
  %sunkaddr133.i = getelementptr i8, ptr %arg.arguments, i64 224
  %sunkaddr134.i = getelementptr i8, ptr %arg.arguments, i64 232
  %.319.i.i = getelementptr i8, ptr %arg.arguments, i64 256
  %.408.i.i = getelementptr i8, ptr %arg.arguments, i64 264
  %107 = icmp slt i64 %.47.i, 1
  %.198.i.i = getelementptr i8, ptr %arg.arguments, i64 56
  %scevgep440.i.i = getelementptr i8, ptr %.289.i, i64 4096
  %.2380.i.i = getelementptr i8, ptr %arg.arguments, i64 184
  %.2458.i.i = getelementptr i8, ptr %arg.arguments, i64 80
  %.2784.i.i = getelementptr i8, ptr %arg.arguments, i64 192
  %.2902.i.i = getelementptr i8, ptr %arg.arguments, i64 200
  %.491.i.i = getelementptr i8, ptr %arg.arguments, i64 216
  %.413.i125.i = getelementptr i8, ptr %arg.arguments, i64 24
  %.138.i.i = getelementptr i8, ptr %arg.arguments, i64 16
  %sunkaddr88.i.i = getelementptr i8, ptr %arg.arguments, i64 144
  %sunkaddr89.i.i = getelementptr i8, ptr %arg.arguments, i64 64
  %sunkaddr.i213.i = getelementptr i8, ptr %arg.arguments, i64 72
  br label %B568.i

.1216.endif.preheader.i:                          ; preds = %_ZN17bnserve_inference13moving_kernel8_passing12find_passingB3v40B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIxLi1E1C7mutable7alignedE.exit.i
  %.908.i = load i64, ptr %sunkaddr133.i, align 8, !noalias !0
  %.912.i = mul nsw i64 %.631.sroa.0.073.i, %.910.i
  %.913.i = add nsw i64 %.908.i, %.912.i
  %.916.i = inttoptr i64 %.913.i to ptr
  tail call void @llvm.memset.p0.i64(ptr align 8 %.916.i, i8 0, i64 %.910.i, i1 false), !noalias !0
  br label %.1216.if.i

.1216.if.i:                                       ; preds = %.1216.endif.preheader.i, %_ZN17bnserve_inference13moving_kernel8_passing12find_passingB3v40B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIxLi1E1C7mutable7alignedE.exit.i
  br i1 %105, label %.1604.if.i, label %.1604.endif.preheader.i, !prof !18

.1604.endif.preheader.i:                          ; preds = %.1216.if.i
  %.1296.i = load i64, ptr %sunkaddr134.i, align 8, !noalias !0
  %.1300.i = mul nsw i64 %.631.sroa.0.073.i, %.1298.i
  %.1301.i = add nsw i64 %.1296.i, %.1300.i
  %.1304.i = inttoptr i64 %.1301.i to ptr
  tail call void @llvm.memset.p0.i64(ptr align 8 %.1304.i, i8 0, i64 %.1298.i, i1 false), !noalias !0
  br label %.1604.if.i

.1604.if.i:                                       ; preds = %.1604.endif.preheader.i, %.1216.if.i
  br i1 %106, label %.1995.endif.preheader.i, label %B1076.i

.1995.endif.preheader.i:                          ; preds = %.1604.if.i
  %.1687.i = load i64, ptr %.504.i, align 8, !noalias !0
  %.1691.i = mul nsw i64 %.631.sroa.0.073.i, %.1689.i
  %.1692.i = add nsw i64 %.1687.i, %.1691.i
  %.1695.i = inttoptr i64 %.1692.i to ptr
  tail call void @llvm.memset.p0.i64(ptr align 8 %.1695.i, i8 0, i64 %.1689.i, i1 false), !noalias !0
  br label %B1076.i

B1120.if.i:                                       ; preds = %B1120.loopexit.i, %B1120.if.preheader.i
  %.212510941121.i = phi i64 [ %.2135.i, %B1120.loopexit.i ], [ %.2105.i, %B1120.if.preheader.i ]
  %.213211001120.i = phi i64 [ %.2139.i, %B1120.loopexit.i ], [ 0, %B1120.if.preheader.i ]
  %.2135.i = add nsw i64 %.212510941121.i, -1
  %.2139.i = add i64 %.213211001120.i, 512
  %.2169.i = sub nsw i64 %.390.i, %.213211001120.i
  %.13.i.i = tail call i64 @llvm.smin.i64(i64 %.2169.i, i64 512)
  %.79.i12.i = load i64, ptr %.109.i.i, align 8, !noalias !19
  %.108.i.i = load i64, ptr %.76.i, align 8, !noalias !19
  %.137.i.i = load i64, ptr %.106.i, align 8, !noalias !19
  %.149.i.i = sub i64 0, %.137.i.i
  %.157.1.i.i = and i64 %.149.i.i, -8
  %.224.i.i = load i64, ptr %.361.i.i, align 8, !noalias !19
  %.226.i.i = shl i64 %.79.i12.i, 4
  %.228.i13.i = mul i64 %.226.i.i, %.631.sroa.0.073.i
  %.229.i14.i = mul i64 %.228.i13.i, %.137.i.i
  %.230.i.i = add nsw i64 %.229.i14.i, %.224.i.i
  %.320.i.i = load i64, ptr %.319.i.i, align 8, !noalias !19
  %.323.i.i = mul i64 %.79.i12.i, %.229.i.i
  %.324.i.i = add nsw i64 %.320.i.i, %.323.i.i
  %.409.i.i = load i64, ptr %.408.i.i, align 8, !noalias !19
  %.413.i.i = add nsw i64 %.409.i.i, %.228.i13.i
  %.499.i.i = load i64, ptr %.459.i.i, align 8, !noalias !19
  %.584.i.i = load i64, ptr %.152.i.i, align 8, !noalias !19
  %.588.i.i = inttoptr i64 %.584.i.i to ptr
  %.663.i.i = getelementptr i8, ptr %.588.i.i, i64 8
  %.664.i.i = load double, ptr %.663.i.i, align 8, !noalias !19
  %.673.i.i = sub i64 %.137.i.i, %.213211001120.i
  %.13.i.i.i = tail call i64 @llvm.smin.i64(i64 %.673.i.i, i64 range(i64 -9223372036854775808, 513) %.13.i.i)
  %.827.i.i = add i64 %.108.i.i, 2
  %.78650.i.i = icmp sgt i64 %.108.i.i, 0
  br i1 %.78650.i.i, label %B622.lr.ph.i.i, label %B980.i.i

B622.i.i:                                         ; preds = %.2478.endif.endif.endif.endif.i.i, %B622.lr.ph.i.i
  %.776.sroa.0.056.i.i = phi i64 [ 0, %B622.lr.ph.i.i ], [ %.776.sroa.0.0.i.i, %.2478.endif.endif.endif.endif.i.i ]
  %.785135755.i.i = phi i64 [ %.785135753.i.i, %B622.lr.ph.i.i ], [ %.7851357.i.i, %.2478.endif.endif.endif.endif.i.i ]
  %.792136754.i.i = phi i64 [ 1, %B622.lr.ph.i.i ], [ %.7921367.i.i, %.2478.endif.endif.endif.endif.i.i ]
  br i1 %117, label %.2478.endif.endif.endif.endif.i.i, label %B56.if.i.preheader.i.i, !prof !18

B980.i.i:                                         ; preds = %.2478.endif.endif.endif.endif.i.i, %B1120.if.i
  %.29671389.not.i.i = icmp slt i64 %.79.i12.i, 1
  br i1 %.29671389.not.i.i, label %_ZN17bnserve_inference13moving_kernel7_source9_polariseB3v58B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i, label %B1010.if.preheader.i.i

B1010.if.preheader.i.i:                           ; preds = %B980.i.i
  %108 = mul i64 %.137.i.i, %.226.i.i
  %109 = shl i64 %.108.i.i, 13
  %110 = getelementptr i8, ptr %.289.i, i64 %109
  %scevgep.i15.i = getelementptr i8, ptr %110, i64 20480
  %scevgep7.i.i = getelementptr i8, ptr %110, i64 28672
  %111 = icmp slt i64 %.13.i.i.i, 1
  %112 = inttoptr i64 %.324.i.i to ptr
  %113 = inttoptr i64 %.499.i.i to ptr
  %114 = inttoptr i64 %.230.i.i to ptr
  %115 = inttoptr i64 %.413.i.i to ptr
  br label %B1010.if.i.i

B622.lr.ph.i.i:                                   ; preds = %B1120.if.i
  %.785135753.i.i = add nsw i64 %.108.i.i, -1
  %116 = shl i64 %.13.i.i, 3
  %117 = icmp slt i64 %.2169.i, 1
  br label %B622.i.i

B56.if.i.preheader.i.i:                           ; preds = %B622.i.i
  %.828.i.i = mul i64 %.776.sroa.0.056.i.i, 3
  %.829.i.i = add i64 %.827.i.i, %.828.i.i
  %.848.idx.i.i = shl i64 %.829.i.i, 13
  %.848.i.i = getelementptr i8, ptr %.289.i, i64 %.848.idx.i.i
  %.1152.i.i = getelementptr i8, ptr %.848.i.i, i64 12288
  %.1084.i.i = getelementptr i8, ptr %.848.i.i, i64 8192
  %.916.i.i = getelementptr i8, ptr %.848.i.i, i64 4096
  tail call void @llvm.memset.p0.i64(ptr align 8 %.848.i.i, i8 0, i64 %116, i1 false), !noalias !19
  tail call void @llvm.memset.p0.i64(ptr align 8 %.916.i.i, i8 0, i64 %116, i1 false), !noalias !19
  tail call void @llvm.memset.p0.i64(ptr align 8 %.1084.i.i, i8 0, i64 %116, i1 false), !noalias !19
  tail call void @llvm.memset.p0.i64(ptr align 8 %.1152.i.i, i8 0, i64 %116, i1 false), !noalias !19
  %.2620.i.i = getelementptr i8, ptr %.848.i.i, i64 20480
  %118 = mul i64 %.776.sroa.0.056.i.i, %.157.1.i.i
  %.2768.i.i = sub i64 %.213211001120.i, %118
  %.2780.i.i = getelementptr double, ptr %.835.sroa.12.1.i, i64 %.2768.i.i
  br label %B56.if.i.i.i

B56.if.i.i.i:                                     ; preds = %B56.if.i.i.i, %B56.if.i.preheader.i.i
  %.147106108.i.i.i = phi i64 [ %.154.i.i.i, %B56.if.i.i.i ], [ 0, %B56.if.i.preheader.i.i ]
  %.154.i.i.i = add nuw nsw i64 %.147106108.i.i.i, 1
  %119 = shl i64 %.147106108.i.i.i, 3
  %scevgep2.i.i28.i = getelementptr i8, ptr %.2780.i.i, i64 %119
  %.209.i.i29.i = load double, ptr %scevgep2.i.i28.i, align 8, !noalias !22
  %.211.i.i.i = fmul contract double %.664.i.i, %.209.i.i29.i
  %.212.i.i.i = tail call contract double @llvm.fma.f64(double %.211.i.i.i, double 0x3FE45F306DC9C883, double 0x4338000000000000)
  %.213.i.i.i = fadd contract double %.212.i.i.i, 0xC338000000000000
  %.228.i.i.i = tail call contract double @llvm.fma.f64(double %.213.i.i.i, double 0xBFF921FB54442D18, double %.211.i.i.i)
  %.243.i.i.i = tail call contract double @llvm.fma.f64(double %.213.i.i.i, double 0xBC91A62633145C07, double %.228.i.i.i)
  %.244.i.i.i = fmul contract double %.243.i.i.i, %.243.i.i.i
  %.245.i.i.i = tail call contract double @llvm.fma.f64(double %.244.i.i.i, double 0xBD6AE7F3E733B81F, double 0x3DE6124613A86D09)
  %.246.i.i30.i = tail call contract double @llvm.fma.f64(double %.244.i.i.i, double %.245.i.i.i, double 0xBE5AE64567F544E4)
  %.247.i.i31.i = tail call contract double @llvm.fma.f64(double %.244.i.i.i, double %.246.i.i30.i, double 0x3EC71DE3A556C734)
  %.248.i.i32.i = tail call contract double @llvm.fma.f64(double %.244.i.i.i, double %.247.i.i31.i, double 0xBF2A01A01A01A01A)
  %.249.i.i33.i = tail call contract double @llvm.fma.f64(double %.244.i.i.i, double %.248.i.i32.i, double 0x3F81111111111111)
  %.250.i.i34.i = tail call contract double @llvm.fma.f64(double %.244.i.i.i, double %.249.i.i33.i, double 0xBFC5555555555555)
  %.251.i.i35.i = fmul contract double %.243.i.i.i, %.244.i.i.i
  %.252.i.i36.i = tail call contract double @llvm.fma.f64(double %.251.i.i35.i, double %.250.i.i34.i, double %.243.i.i.i)
  %.253.i.i37.i = tail call contract double @llvm.fma.f64(double %.244.i.i.i, double 0x3D2AE7F3E733B81F, double 0xBDA93974A8C07C9D)
  %.254.i.i38.i = tail call contract double @llvm.fma.f64(double %.244.i.i.i, double %.253.i.i37.i, double 0x3E21EED8EFF8D898)
  %.255.i.i39.i = tail call contract double @llvm.fma.f64(double %.244.i.i.i, double %.254.i.i38.i, double 0xBE927E4FB7789F5C)
  %.256.i.i40.i = tail call contract double @llvm.fma.f64(double %.244.i.i.i, double %.255.i.i39.i, double 0x3EFA01A01A01A01A)
  %.257.i.i41.i = tail call contract double @llvm.fma.f64(double %.244.i.i.i, double %.256.i.i40.i, double 0xBF56C16C16C16C17)
  %.258.i.i42.i = tail call contract double @llvm.fma.f64(double %.244.i.i.i, double %.257.i.i41.i, double 0x3FA5555555555555)
  %.259.i.i43.i = tail call contract double @llvm.fma.f64(double %.244.i.i.i, double %.258.i.i42.i, double -5.000000e-01)
  %.260.i.i44.i = tail call contract double @llvm.fma.f64(double %.244.i.i.i, double %.259.i.i43.i, double 1.000000e+00)
  %.261.i.i45.i = bitcast double %.212.i.i.i to i64
  %.262.i.i46.i = bitcast double %.252.i.i36.i to i64
  %.263.i.i47.i = bitcast double %.260.i.i44.i to i64
  %.264.i.i48.i = xor i64 %.263.i.i47.i, %.262.i.i46.i
  %.265.i.i49.i = and i64 %.261.i.i45.i, 1
  %120 = icmp eq i64 %.265.i.i49.i, 0
  %.267.i.i50.i = select i1 %120, i64 0, i64 %.264.i.i48.i
  %.268.i.i51.i = shl i64 %.261.i.i45.i, 62
  %.269.i.i.i = and i64 %.268.i.i51.i, -9223372036854775808
  %.271.i.i52.i = add i64 %.268.i.i51.i, 4611686018427387904
  %.272.i.i53.i = and i64 %.271.i.i52.i, -9223372036854775808
  %121 = xor i64 %.269.i.i.i, %.262.i.i46.i
  %.274.i.i54.i = xor i64 %121, %.267.i.i50.i
  %122 = xor i64 %.272.i.i53.i, %.263.i.i47.i
  %.277.i.i55.i = xor i64 %122, %.267.i.i50.i
  %scevgep14.i.i = getelementptr i8, ptr %.2620.i.i, i64 %119
  store i64 %.274.i.i54.i, ptr %scevgep14.i.i, align 8, !noalias !22
  %scevgep13.i.i = getelementptr i8, ptr %scevgep14.i.i, i64 -4096
  store i64 %.277.i.i55.i, ptr %scevgep13.i.i, align 8, !noalias !22
  %exitcond.not.i.i.i = icmp eq i64 %.13.i.i, %.154.i.i.i
  br i1 %exitcond.not.i.i.i, label %.2478.endif.endif.endif.endif.i.i, label %B56.if.i.i.i

.2478.endif.endif.endif.endif.i.i:                ; preds = %B56.if.i.i.i, %B622.i.i
  %.786.i.i = icmp sgt i64 %.785135755.i.i, 0
  %.799.i.i = zext i1 %.786.i.i to i64
  %.7921367.i.i = add i64 %.792136754.i.i, %.799.i.i
  %.795.i.i = sext i1 %.786.i.i to i64
  %.7851357.i.i = add nsw i64 %.785135755.i.i, %.795.i.i
  %.776.sroa.0.0.i.i = select i1 %.786.i.i, i64 %.792136754.i.i, i64 0
  br i1 %.786.i.i, label %B622.i.i, label %B980.i.i

B1010.if.i.i:                                     ; preds = %B1012.endif.endif.endif.endif.endif.endif.i.i, %B1010.if.preheader.i.i
  %lsr.iv.i16.i = phi i64 [ %.213211001120.i, %B1010.if.preheader.i.i ], [ %lsr.iv.next.i26.i, %B1012.endif.endif.endif.endif.endif.endif.i.i ]
  %.297313831390.i.i = phi i64 [ 0, %B1010.if.preheader.i.i ], [ %.2980.i.i, %B1012.endif.endif.endif.endif.endif.endif.i.i ]
  %.2980.i.i = add nuw nsw i64 %.297313831390.i.i, 1
  %123 = getelementptr double, ptr %112, i64 %.297313831390.i.i
  %.3570.i.i = load double, ptr %123, align 8, !noalias !19
  br i1 %111, label %B1012.endif.endif.endif.endif.endif.endif.i.i, label %B34.if.preheader.i.i17.i

B34.if.preheader.i.i17.i:                         ; preds = %B1010.if.i.i
  %124 = getelementptr i64, ptr %113, i64 %.297313831390.i.i
  %.3036.i.i = load i64, ptr %124, align 8, !noalias !19
  %.3538.i.i = mul nsw i64 %.297313831390.i.i, %.137.i.i
  %.3540.i.i = add nsw i64 %.3538.i.i, %.213211001120.i
  %125 = shl i64 %.3540.i.i, 4
  %126 = getelementptr i8, ptr %114, i64 %125
  %scevgep2.i140.i.i = getelementptr i8, ptr %126, i64 8
  %127 = mul i64 %.3036.i.i, 24576
  %scevgep1.i.i = getelementptr i8, ptr %scevgep.i15.i, i64 %127
  br label %B34.if.i.i18.i

B34.if.i.i18.i:                                   ; preds = %B34.if.i.i18.i, %B34.if.preheader.i.i17.i
  %lsr.iv.i.i19.i = phi ptr [ %scevgep2.i140.i.i, %B34.if.preheader.i.i17.i ], [ %scevgep3.i.i.i, %B34.if.i.i18.i ]
  %.143136138.i.i.i = phi i64 [ 0, %B34.if.preheader.i.i17.i ], [ %.150.i.i.i, %B34.if.i.i18.i ]
  %.150.i.i.i = add nuw nsw i64 %.143136138.i.i.i, 1
  %128 = add i64 %.143136138.i.i.i, %lsr.iv.i16.i
  %.191.i.i.i = icmp slt i64 %128, 0
  %129 = select i1 %.191.i.i.i, i64 %108, i64 0
  %scevgep4.i.i20.i = getelementptr i8, ptr %lsr.iv.i.i19.i, i64 %129
  %scevgep5.i.i21.i = getelementptr i8, ptr %scevgep4.i.i20.i, i64 -8
  %.207.i.i.i = load double, ptr %scevgep5.i.i21.i, align 8, !noalias !25
  %.241.i.i.i = load double, ptr %scevgep4.i.i20.i, align 8, !noalias !25
  %sunkaddr.i22.i = shl i64 %.143136138.i.i.i, 3
  %scevgep3.i.i = getelementptr i8, ptr %scevgep1.i.i, i64 %sunkaddr.i22.i
  %scevgep6.i.i = getelementptr i8, ptr %scevgep3.i.i, i64 -4096
  %.271.i142.i.i = load double, ptr %scevgep6.i.i, align 8, !noalias !25
  %.273.i.i.i = fmul contract double %.3570.i.i, %.207.i.i.i
  %.275.i.i23.i = fmul contract double %.241.i.i.i, 0.000000e+00
  %.276.i.i.i = fsub contract double %.273.i.i.i, %.275.i.i23.i
  %.277.i143.i.i = fadd contract double %.271.i142.i.i, %.276.i.i.i
  store double %.277.i143.i.i, ptr %scevgep6.i.i, align 8, !noalias !25
  %.337.i.i.i = load double, ptr %scevgep3.i.i, align 8, !noalias !25
  %.339.i.i.i = fmul contract double %.3570.i.i, %.241.i.i.i
  %.341.i.i.i = fmul contract double %.207.i.i.i, 0.000000e+00
  %.342.i.i.i = fadd contract double %.341.i.i.i, %.339.i.i.i
  %.343.i.i.i = fadd contract double %.342.i.i.i, %.337.i.i.i
  store double %.343.i.i.i, ptr %scevgep3.i.i, align 8, !noalias !25
  %scevgep3.i.i.i = getelementptr i8, ptr %lsr.iv.i.i19.i, i64 16
  %exitcond.not.i145.i.i = icmp eq i64 %.13.i.i.i, %.150.i.i.i
  br i1 %exitcond.not.i145.i.i, label %B1012.endif.endif.endif.endif.endif.i.i, label %B34.if.i.i18.i

B1012.endif.endif.endif.endif.endif.i.i:          ; preds = %B34.if.i.i18.i
  %.idx.i.i = shl i64 %.297313831390.i.i, 4
  %130 = getelementptr i8, ptr %115, i64 %.idx.i.i
  %.3644.i.i = load double, ptr %130, align 8, !noalias !19
  %131 = getelementptr i8, ptr %130, i64 8
  %.3676.i.i = load double, ptr %131, align 8, !noalias !19
  %scevgep8.i.i = getelementptr i8, ptr %scevgep7.i.i, i64 %127
  br label %B34.if.i149.i.i

B34.if.i149.i.i:                                  ; preds = %B34.if.i149.i.i, %B1012.endif.endif.endif.endif.endif.i.i
  %lsr.iv.i150.i.i = phi ptr [ %scevgep2.i140.i.i, %B1012.endif.endif.endif.endif.endif.i.i ], [ %scevgep3.i170.i.i, %B34.if.i149.i.i ]
  %.143136138.i151.i.i = phi i64 [ 0, %B1012.endif.endif.endif.endif.endif.i.i ], [ %.150.i152.i.i, %B34.if.i149.i.i ]
  %.150.i152.i.i = add nuw nsw i64 %.143136138.i151.i.i, 1
  %132 = add i64 %.143136138.i151.i.i, %lsr.iv.i16.i
  %.191.i153.i.i = icmp slt i64 %132, 0
  %133 = select i1 %.191.i153.i.i, i64 %108, i64 0
  %scevgep4.i154.i.i = getelementptr i8, ptr %lsr.iv.i150.i.i, i64 %133
  %scevgep5.i155.i.i = getelementptr i8, ptr %scevgep4.i154.i.i, i64 -8
  %.207.i156.i.i = load double, ptr %scevgep5.i155.i.i, align 8, !noalias !28
  %.241.i157.i.i = load double, ptr %scevgep4.i154.i.i, align 8, !noalias !28
  %sunkaddr10.i24.i = shl i64 %.143136138.i151.i.i, 3
  %scevgep10.i.i = getelementptr i8, ptr %scevgep8.i.i, i64 %sunkaddr10.i24.i
  %scevgep11.i25.i = getelementptr i8, ptr %scevgep10.i.i, i64 -4096
  %.271.i159.i.i = load double, ptr %scevgep11.i25.i, align 8, !noalias !28
  %.273.i160.i.i = fmul contract double %.3644.i.i, %.207.i156.i.i
  %.275.i161.i.i = fmul contract double %.3676.i.i, %.241.i157.i.i
  %.276.i162.i.i = fsub contract double %.273.i160.i.i, %.275.i161.i.i
  %.277.i163.i.i = fadd contract double %.271.i159.i.i, %.276.i162.i.i
  store double %.277.i163.i.i, ptr %scevgep11.i25.i, align 8, !noalias !28
  %.337.i165.i.i = load double, ptr %scevgep10.i.i, align 8, !noalias !28
  %.339.i166.i.i = fmul contract double %.3644.i.i, %.241.i157.i.i
  %.341.i167.i.i = fmul contract double %.3676.i.i, %.207.i156.i.i
  %.342.i168.i.i = fadd contract double %.341.i167.i.i, %.339.i166.i.i
  %.343.i169.i.i = fadd contract double %.342.i168.i.i, %.337.i165.i.i
  store double %.343.i169.i.i, ptr %scevgep10.i.i, align 8, !noalias !28
  %scevgep3.i170.i.i = getelementptr i8, ptr %lsr.iv.i150.i.i, i64 16
  %exitcond.not.i171.i.i = icmp eq i64 %.13.i.i.i, %.150.i152.i.i
  br i1 %exitcond.not.i171.i.i, label %B1012.endif.endif.endif.endif.endif.endif.i.i, label %B34.if.i149.i.i

B1012.endif.endif.endif.endif.endif.endif.i.i:    ; preds = %B34.if.i149.i.i, %B1010.if.i.i
  %lsr.iv.next.i26.i = add i64 %lsr.iv.i16.i, %.137.i.i
  %exitcond.not.i27.i = icmp eq i64 %.2980.i.i, %.79.i12.i
  br i1 %exitcond.not.i27.i, label %_ZN17bnserve_inference13moving_kernel7_source9_polariseB3v58B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i, label %B1010.if.i.i

_ZN17bnserve_inference13moving_kernel7_source9_polariseB3v58B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i: ; preds = %B1012.endif.endif.endif.endif.endif.endif.i.i, %B980.i.i
  br i1 %107, label %B1120.loopexit.i, label %B1242.if.preheader.i

B1242.if.preheader.i:                             ; preds = %_ZN17bnserve_inference13moving_kernel7_source9_polariseB3v58B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i
  %134 = shl i64 %.13.i.i, 3
  %135 = icmp slt i64 %.2169.i, 1
  %.104.i.i.i = icmp sgt i64 %.2169.i, 0
  %unroll_iter.i.i.i = and i64 %.13.i.i, 9223372036854775800
  %136 = add nsw i64 %unroll_iter.i.i.i, -2
  %137 = lshr exact i64 %136, 1
  %138 = add nuw i64 %137, 1
  %.60.1.i.i.i = ashr exact i64 %.13.i.i, 3
  %139 = shl i64 %.213211001120.i, 3
  %140 = icmp slt i64 %.60.1.i.i.i, 1
  br label %B1242.if.i

B1242.if.i:                                       ; preds = %_ZN17bnserve_inference12modes_kernel7_source10_add_pairsB4v169B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i, %B1242.if.preheader.i
  %lsr.iv.i = phi ptr [ %scevgep.i, %_ZN17bnserve_inference12modes_kernel7_source10_add_pairsB4v169B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i ], [ %.155.i, %B1242.if.preheader.i ]
  %.232410861091.i = phi i64 [ %.2331.i, %_ZN17bnserve_inference12modes_kernel7_source10_add_pairsB4v169B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i ], [ 0, %B1242.if.preheader.i ]
  %.2331.i = add nuw nsw i64 %.232410861091.i, 1
  call void @llvm.lifetime.start.p0(ptr nonnull %.2081.i.i), !noalias !0
  call void @llvm.lifetime.start.p0(ptr nonnull %.2136.i.i), !noalias !0
  store ptr null, ptr %.2081.i.i, align 8, !noalias !31
  store ptr null, ptr %.2136.i.i, align 8, !noalias !31
  %.87.i.i = load i64, ptr %.76.i, align 8, !noalias !31
  %.118.i.i = load i64, ptr %.106.i, align 8, !noalias !31
  %.119.i.i = sub i64 0, %.118.i.i
  %.127.1.i.i = and i64 %.119.i.i, -8
  %.161.i.i = sub i64 0, %.127.1.i.i
  %.199.i.i = load i64, ptr %.198.i.i, align 8, !noalias !31
  %.201.i.i = inttoptr i64 %.199.i.i to ptr
  %.265.i.i = getelementptr double, ptr %.201.i.i, i64 %.213211001120.i
  %.360.i.i = icmp sgt i64 %.87.i.i, 0
  br i1 %.360.i.i, label %B226.if.lr.ph.i.i, label %B812.i.i

B546.i.i:                                         ; preds = %B226.if.i.i
  br i1 %135, label %B768.endif.critedge.i.i, label %.1723.endif.preheader.i.i, !prof !18

B722.i.i:                                         ; preds = %B226.if.i.i
  %.156.i.i.i = load double, ptr %sunkaddr35.i.i, align 8, !noalias !34
  %.186.i.i.i = load double, ptr %sunkaddr36.i.i, align 8, !noalias !34
  %.216.i.i83.i = load double, ptr %sunkaddr.i79.i, align 8, !noalias !34
  %.255.i.i84.i = load double, ptr %sunkaddr37.i.i, align 8, !noalias !34
  %.285.i.i.i = load double, ptr %sunkaddr38.i.i, align 8, !noalias !34
  %.320.i.i.i = load double, ptr %sunkaddr39.i.i, align 8, !noalias !34
  %.350.i.i.i = load double, ptr %sunkaddr40.i.i, align 8, !noalias !34
  %.380.i.i85.i = load double, ptr %sunkaddr41.i.i, align 8, !noalias !34
  %.419.i.i.i = load double, ptr %sunkaddr42.i.i, align 8, !noalias !34
  %.449.i.i.i = load double, ptr %sunkaddr43.i.i, align 8, !noalias !34
  br i1 %135, label %B768.endif.i.i, label %B464.if.i.i.i

B464.if.i.i.i:                                    ; preds = %B722.i.i, %B464.if.i.i.i
  %.557359361.i.i.i = phi i64 [ %.564.i.i.i, %B464.if.i.i.i ], [ 0, %B722.i.i ]
  %.564.i.i.i = add nuw nsw i64 %.557359361.i.i.i, 1
  %141 = shl i64 %.557359361.i.i.i, 3
  %scevgep458.i.i = getelementptr i8, ptr %lsr.iv447.i.i, i64 %141
  %scevgep459.i.i = getelementptr i8, ptr %scevgep458.i.i, i64 -4096
  %.618.i.i.i = load double, ptr %scevgep459.i.i, align 8, !noalias !34
  %.648.i.i86.i = load double, ptr %scevgep458.i.i, align 8, !noalias !34
  %.649.i.i87.i = fmul contract double %.618.i.i.i, %.618.i.i.i
  %.650.i.i88.i = fmul contract double %.648.i.i86.i, %.648.i.i86.i
  %.651.i.i89.i = fsub contract double %.649.i.i87.i, %.650.i.i88.i
  %.652.i.i90.i = fmul contract double %.618.i.i.i, 2.000000e+00
  %.653.i.i91.i = fmul contract double %.652.i.i90.i, %.648.i.i86.i
  %.655.i.i92.i = fmul contract double %.186.i.i.i, %.618.i.i.i
  %.657.i.i93.i = fadd contract double %.156.i.i.i, %.655.i.i92.i
  %.659.i.i94.i = fmul contract double %.216.i.i83.i, %.648.i.i86.i
  %.660.i.i95.i = fadd contract double %.657.i.i93.i, %.659.i.i94.i
  %.662.i.i96.i = fmul contract double %.255.i.i84.i, %.651.i.i89.i
  %.663.i.i97.i = fadd contract double %.660.i.i95.i, %.662.i.i96.i
  %.665.i.i98.i = fmul contract double %.285.i.i.i, %.653.i.i91.i
  %.666.i.i99.i = fadd contract double %.665.i.i98.i, %.663.i.i97.i
  %.668.i.i.i = fmul contract double %.350.i.i.i, %.618.i.i.i
  %.670.i.i100.i = fadd contract double %.320.i.i.i, %.668.i.i.i
  %.672.i.i101.i = fmul contract double %.380.i.i85.i, %.648.i.i86.i
  %.673.i.i102.i = fadd contract double %.670.i.i100.i, %.672.i.i101.i
  %.675.i.i103.i = fmul contract double %.419.i.i.i, %.651.i.i89.i
  %.676.i.i104.i = fadd contract double %.673.i.i102.i, %.675.i.i103.i
  %.678.i.i.i = fmul contract double %.449.i.i.i, %.653.i.i91.i
  %.679.i.i.i = fadd contract double %.678.i.i.i, %.676.i.i104.i
  %scevgep32.i.i = getelementptr i8, ptr %scevgep458.i.i, i64 -20480
  %.709.i.i.i = load double, ptr %scevgep32.i.i, align 8, !noalias !34
  %.710.i.i.i = fmul contract double %.709.i.i.i, %.666.i.i99.i
  %scevgep30.i105.i = getelementptr i8, ptr %scevgep458.i.i, i64 -12288
  %.740.i.i.i = load double, ptr %scevgep30.i105.i, align 8, !noalias !34
  %.741.i.i.i = fmul contract double %.740.i.i.i, %.679.i.i.i
  %.742.i.i.i = fadd contract double %.710.i.i.i, %.741.i.i.i
  %scevgep23.i.i = getelementptr i8, ptr %lsr.iv441.i.i, i64 %141
  %scevgep24.i106.i = getelementptr i8, ptr %scevgep23.i.i, i64 -4096
  store double %.742.i.i.i, ptr %scevgep24.i106.i, align 8, !noalias !34
  %scevgep28.i107.i = getelementptr i8, ptr %scevgep458.i.i, i64 -16384
  %.802.i.i.i = load double, ptr %scevgep28.i107.i, align 8, !noalias !34
  %.803.i.i.i = fmul contract double %.802.i.i.i, %.666.i.i99.i
  %scevgep26.i108.i = getelementptr i8, ptr %scevgep458.i.i, i64 -8192
  %.833.i.i.i = load double, ptr %scevgep26.i108.i, align 8, !noalias !34
  %.834.i.i.i = fmul contract double %.679.i.i.i, %.833.i.i.i
  %.835.i.i.i = fadd contract double %.803.i.i.i, %.834.i.i.i
  store double %.835.i.i.i, ptr %scevgep23.i.i, align 8, !noalias !34
  %exitcond.not.i.i109.i = icmp eq i64 %.13.i.i, %.564.i.i.i
  br i1 %exitcond.not.i.i109.i, label %B164.if.i.preheader.i.i, label %B464.if.i.i.i

B164.if.i.preheader.i.i:                          ; preds = %B464.if.i.i.i, %.1723.endif.preheader.i.i
  %.116.i15.in.i.i = load double, ptr %sunkaddr44.i.i, align 8, !noalias !37
  %.116.i15.i.i = fmul contract double %.116.i15.in.i.i, 0xC01921FB54442D18
  %.150.i16.in.i.i = load double, ptr %sunkaddr45.i.i, align 8, !noalias !37
  %.150.i16.i.i = fmul contract double %.150.i16.in.i.i, 0x401921FB54442D18
  br label %B164.if.i.i.i

B164.if.i.i.i:                                    ; preds = %B164.if.i.i.i, %B164.if.i.preheader.i.i
  %.255197199.i.i.i = phi i64 [ %.262.i.i110.i, %B164.if.i.i.i ], [ 0, %B164.if.i.preheader.i.i ]
  %.262.i.i110.i = add nuw nsw i64 %.255197199.i.i.i, 1
  %142 = shl i64 %.255197199.i.i.i, 3
  %scevgep4.i81.i.i = getelementptr i8, ptr %.265.i.i, i64 %142
  %.317.i.i.i = load double, ptr %scevgep4.i81.i.i, align 8, !noalias !37
  %scevgep464.i.i = getelementptr i8, ptr %lsr.iv447.i.i, i64 %142
  %scevgep465.i.i = getelementptr i8, ptr %scevgep464.i.i, i64 -4096
  %.347.i.i111.i = load double, ptr %scevgep465.i.i, align 8, !noalias !37
  %.348.i.i112.i = fsub contract double 1.000000e+00, %.347.i.i111.i
  %.350.i83.i.i = fmul contract double %.116.i15.i.i, %.348.i.i112.i
  %.380.i85.i.i = load double, ptr %scevgep464.i.i, align 8, !noalias !37
  %.382.i.i113.i = fmul contract double %.150.i16.i.i, %.380.i85.i.i
  %143 = fsub contract double %.350.i83.i.i, %.382.i.i113.i
  %.384.i.i114.i = fmul contract double %.317.i.i.i, %143
  %.385.i.i115.i = tail call contract double @llvm.fma.f64(double %.384.i.i114.i, double 0x3FE45F306DC9C883, double 0x4338000000000000)
  %.386.i.i116.i = fadd contract double %.385.i.i115.i, 0xC338000000000000
  %.401.i.i.i = tail call contract double @llvm.fma.f64(double %.386.i.i116.i, double 0xBFF921FB54442D18, double %.384.i.i114.i)
  %.416.i.i.i = tail call contract double @llvm.fma.f64(double %.386.i.i116.i, double 0xBC91A62633145C07, double %.401.i.i.i)
  %.417.i.i.i = fmul contract double %.416.i.i.i, %.416.i.i.i
  %.418.i86.i.i = tail call contract double @llvm.fma.f64(double %.417.i.i.i, double 0xBD6AE7F3E733B81F, double 0x3DE6124613A86D09)
  %.419.i87.i.i = tail call contract double @llvm.fma.f64(double %.417.i.i.i, double %.418.i86.i.i, double 0xBE5AE64567F544E4)
  %.420.i.i.i = tail call contract double @llvm.fma.f64(double %.417.i.i.i, double %.419.i87.i.i, double 0x3EC71DE3A556C734)
  %.421.i.i.i = tail call contract double @llvm.fma.f64(double %.417.i.i.i, double %.420.i.i.i, double 0xBF2A01A01A01A01A)
  %.422.i.i.i = tail call contract double @llvm.fma.f64(double %.417.i.i.i, double %.421.i.i.i, double 0x3F81111111111111)
  %.423.i.i.i = tail call contract double @llvm.fma.f64(double %.417.i.i.i, double %.422.i.i.i, double 0xBFC5555555555555)
  %.424.i.i.i = fmul contract double %.416.i.i.i, %.417.i.i.i
  %.425.i.i.i = tail call contract double @llvm.fma.f64(double %.424.i.i.i, double %.423.i.i.i, double %.416.i.i.i)
  %.426.i.i.i = tail call contract double @llvm.fma.f64(double %.417.i.i.i, double 0x3D2AE7F3E733B81F, double 0xBDA93974A8C07C9D)
  %.427.i.i.i = tail call contract double @llvm.fma.f64(double %.417.i.i.i, double %.426.i.i.i, double 0x3E21EED8EFF8D898)
  %.428.i.i.i = tail call contract double @llvm.fma.f64(double %.417.i.i.i, double %.427.i.i.i, double 0xBE927E4FB7789F5C)
  %.429.i.i.i = tail call contract double @llvm.fma.f64(double %.417.i.i.i, double %.428.i.i.i, double 0x3EFA01A01A01A01A)
  %.430.i.i.i = tail call contract double @llvm.fma.f64(double %.417.i.i.i, double %.429.i.i.i, double 0xBF56C16C16C16C17)
  %.431.i.i.i = tail call contract double @llvm.fma.f64(double %.417.i.i.i, double %.430.i.i.i, double 0x3FA5555555555555)
  %.432.i.i.i = tail call contract double @llvm.fma.f64(double %.417.i.i.i, double %.431.i.i.i, double -5.000000e-01)
  %.433.i.i.i = tail call contract double @llvm.fma.f64(double %.417.i.i.i, double %.432.i.i.i, double 1.000000e+00)
  %.434.i.i.i = bitcast double %.385.i.i115.i to i64
  %.435.i.i.i = bitcast double %.425.i.i.i to i64
  %.436.i.i.i = bitcast double %.433.i.i.i to i64
  %.437.i.i.i = xor i64 %.436.i.i.i, %.435.i.i.i
  %.438.i.i.i = and i64 %.434.i.i.i, 1
  %144 = icmp eq i64 %.438.i.i.i, 0
  %.440.i.i117.i = select i1 %144, i64 0, i64 %.437.i.i.i
  %.441.i.i.i = shl i64 %.434.i.i.i, 62
  %.442.i.i118.i = and i64 %.441.i.i.i, -9223372036854775808
  %.444.i.i.i = add i64 %.441.i.i.i, 4611686018427387904
  %.445.i.i.i = and i64 %.444.i.i.i, -9223372036854775808
  %145 = xor i64 %.442.i.i118.i, %.435.i.i.i
  %.447.i.i.i = xor i64 %145, %.440.i.i117.i
  %.448.i88.i.i = bitcast i64 %.447.i.i.i to double
  %146 = xor i64 %.445.i.i.i, %.436.i.i.i
  %.450.i.i.i = xor i64 %146, %.440.i.i117.i
  %.451.i.i.i = bitcast i64 %.450.i.i.i to double
  %scevgep33.i.i = getelementptr i8, ptr %lsr.iv441.i.i, i64 %142
  %scevgep34.i.i = getelementptr i8, ptr %scevgep33.i.i, i64 -4096
  %.501.i.i.i = load double, ptr %scevgep34.i.i, align 8, !noalias !37
  %.531.i.i.i = load double, ptr %scevgep33.i.i, align 8, !noalias !37
  %.532.i.i.i = fmul contract double %.501.i.i.i, %.451.i.i.i
  %.533.i.i.i = fmul contract double %.531.i.i.i, %.448.i88.i.i
  %.534.i.i.i = fsub contract double %.532.i.i.i, %.533.i.i.i
  store double %.534.i.i.i, ptr %scevgep34.i.i, align 8, !noalias !37
  %.565.i.i.i = fmul contract double %.501.i.i.i, %.448.i88.i.i
  %.566.i.i.i = fmul contract double %.531.i.i.i, %.451.i.i.i
  %.567.i.i.i = fadd contract double %.565.i.i.i, %.566.i.i.i
  store double %.567.i.i.i, ptr %scevgep33.i.i, align 8, !noalias !37
  %exitcond.not.i91.i.i = icmp eq i64 %.13.i.i, %.262.i.i110.i
  br i1 %exitcond.not.i91.i.i, label %B768.endif.i.i, label %B164.if.i.i.i

B812.i.i:                                         ; preds = %B768.endif.i.i, %B1242.if.i
  %.2381.i.i = load i64, ptr %.2380.i.i, align 8, !noalias !31
  %.2386.i.i = icmp sgt i64 %.2381.i.i, 0
  br i1 %.2386.i.i, label %B860.i.i, label %_ZN17bnserve_inference13moving_kernel7_source8_respondB3v89B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i

B860.i.i:                                         ; preds = %B812.i.i
  %.2389.i.i = shl nsw i64 %.2381.i.i, 3
  %.2419.i.i = load i64, ptr %arg.arguments, align 8, !noalias !31
  %.2421.i.i = mul nsw i64 %.2419.i.i, %.631.sroa.0.073.i
  %.2425.i.i = add nsw i64 %.2421.i.i, %.232410861091.i
  %.2428.i.i = mul nsw i64 %.2425.i.i, %.2389.i.i
  %.2459.i.i = load i64, ptr %.2458.i.i, align 8, !noalias !31
  %.2462.i.i = mul nsw i64 %.2381.i.i, %.161.i.i
  %.2531.idx.i.i = shl i64 %.87.i.i, 13
  %.2531.i.i = getelementptr i8, ptr %.289.i, i64 %.2531.idx.i.i
  %.2599.i.i = getelementptr i8, ptr %.2531.i.i, i64 4096
  %.2785.i.i = load i64, ptr %.2784.i.i, align 8, !noalias !31
  %.2786.i.i = add nsw i64 %.2428.i.i, %.2785.i.i
  br i1 %.104.i.i.i, label %B60.if.preheader.i.i.i, label %B128.if.lr.ph.i.i.i

B226.if.lr.ph.i.i:                                ; preds = %B1242.if.i
  %.685.i.i = add nuw nsw i64 %.87.i.i, 2
  %147 = shl i64 %.87.i.i, 13
  %148 = getelementptr i8, ptr %.289.i, i64 %147
  %scevgep446.i.i = getelementptr i8, ptr %148, i64 36864
  %sunkaddr46.i.i = getelementptr i8, ptr %lsr.iv.i, i64 160
  %sunkaddr35.i.i = getelementptr i8, ptr %lsr.iv.i, i64 8
  %sunkaddr36.i.i = getelementptr i8, ptr %lsr.iv.i, i64 16
  %sunkaddr.i79.i = getelementptr i8, ptr %lsr.iv.i, i64 24
  %sunkaddr37.i.i = getelementptr i8, ptr %lsr.iv.i, i64 32
  %sunkaddr38.i.i = getelementptr i8, ptr %lsr.iv.i, i64 40
  %sunkaddr39.i.i = getelementptr i8, ptr %lsr.iv.i, i64 48
  %sunkaddr40.i.i = getelementptr i8, ptr %lsr.iv.i, i64 56
  %sunkaddr41.i.i = getelementptr i8, ptr %lsr.iv.i, i64 64
  %sunkaddr42.i.i = getelementptr i8, ptr %lsr.iv.i, i64 72
  %sunkaddr43.i.i = getelementptr i8, ptr %lsr.iv.i, i64 80
  %sunkaddr44.i.i = getelementptr i8, ptr %lsr.iv.i, i64 88
  %sunkaddr45.i.i = getelementptr i8, ptr %lsr.iv.i, i64 96
  br label %B226.if.i.i

B226.if.i.i:                                      ; preds = %B768.endif.i.i, %B226.if.lr.ph.i.i
  %lsr.iv447.i.i = phi ptr [ %scevgep446.i.i, %B226.if.lr.ph.i.i ], [ %scevgep448.i.i, %B768.endif.i.i ]
  %lsr.iv441.i.i = phi ptr [ %scevgep440.i.i, %B226.if.lr.ph.i.i ], [ %scevgep442.i.i, %B768.endif.i.i ]
  %.346.0.i.i = phi i64 [ 0, %B226.if.lr.ph.i.i ], [ %.415.i.i, %B768.endif.i.i ]
  %.415.i.i = add nuw nsw i64 %.346.0.i.i, 1
  %.459.idx.i.i = shl i64 %.346.0.i.i, 13
  %.459.i80.i = getelementptr i8, ptr %.289.i, i64 %.459.idx.i.i
  %.527.i.i = getelementptr i8, ptr %.459.i80.i, i64 4096
  %.686.i.i = mul nuw nsw i64 %.346.0.i.i, 3
  %.687.i.i = add nuw nsw i64 %.685.i.i, %.686.i.i
  %.706.idx.i.i = shl i64 %.687.i.i, 13
  %.706.i.i = getelementptr i8, ptr %.289.i, i64 %.706.idx.i.i
  %.774.i.i = getelementptr i8, ptr %.706.i.i, i64 4096
  %.954.i.i = getelementptr i8, ptr %.706.i.i, i64 8192
  %.1022.i.i = getelementptr i8, ptr %.706.i.i, i64 12288
  %.1202.i81.i = getelementptr i8, ptr %.706.i.i, i64 16384
  %.1270.i82.i = getelementptr i8, ptr %.706.i.i, i64 20480
  %.1455.i.i = load double, ptr %sunkaddr46.i.i, align 8, !noalias !31
  %.1456.i.i = fcmp contract ogt double %.1455.i.i, 0.000000e+00
  br i1 %.1456.i.i, label %B546.i.i, label %B722.i.i

.1723.endif.preheader.i.i:                        ; preds = %B546.i.i
  tail call void @llvm.memset.p0.i64(ptr align 8 %.459.i80.i, i8 0, i64 %134, i1 false), !noalias !31
  tail call void @llvm.memset.p0.i64(ptr align 8 %.527.i.i, i8 0, i64 %134, i1 false), !noalias !31
  store ptr null, ptr %.2081.i.i, align 8, !noalias !31
  call fastcc void @inner_0(ptr nonnull %.2081.i.i, ptr readonly %lsr.iv.i, i64 17, double 1.000000e+00, ptr %.265.i.i, ptr %.1202.i81.i, i64 range(i64 -9223372036854775808, 513) %.13.i.i, ptr %.1270.i82.i, ptr %.706.i.i, ptr %.774.i.i, ptr %.954.i.i, ptr %.1022.i.i, ptr %.459.i80.i, ptr %.527.i.i)
  store ptr null, ptr %.2136.i.i, align 8, !noalias !31
  call fastcc void @inner_0(ptr nonnull %.2136.i.i, ptr readonly %lsr.iv.i, i64 21, double -1.000000e+00, ptr %.265.i.i, ptr %.1202.i81.i, i64 range(i64 -9223372036854775808, 513) %.13.i.i, ptr %.1270.i82.i, ptr %.706.i.i, ptr %.774.i.i, ptr %.954.i.i, ptr %.1022.i.i, ptr %.459.i80.i, ptr %.527.i.i)
  br label %B164.if.i.preheader.i.i

B768.endif.critedge.i.i:                          ; preds = %B546.i.i
  store ptr null, ptr %.2081.i.i, align 8, !noalias !31
  call fastcc void @inner_0(ptr nonnull %.2081.i.i, ptr readonly %lsr.iv.i, i64 17, double 1.000000e+00, ptr %.265.i.i, ptr %.1202.i81.i, i64 range(i64 -9223372036854775808, 513) %.13.i.i, ptr %.1270.i82.i, ptr %.706.i.i, ptr %.774.i.i, ptr %.954.i.i, ptr %.1022.i.i, ptr %.459.i80.i, ptr %.527.i.i)
  store ptr null, ptr %.2136.i.i, align 8, !noalias !31
  call fastcc void @inner_0(ptr nonnull %.2136.i.i, ptr readonly %lsr.iv.i, i64 21, double -1.000000e+00, ptr %.265.i.i, ptr %.1202.i81.i, i64 range(i64 -9223372036854775808, 513) %.13.i.i, ptr %.1270.i82.i, ptr %.706.i.i, ptr %.774.i.i, ptr %.954.i.i, ptr %.1022.i.i, ptr %.459.i80.i, ptr %.527.i.i)
  br label %B768.endif.i.i

B768.endif.i.i:                                   ; preds = %B164.if.i.i.i, %B768.endif.critedge.i.i, %B722.i.i
  %scevgep442.i.i = getelementptr i8, ptr %lsr.iv441.i.i, i64 8192
  %scevgep448.i.i = getelementptr i8, ptr %lsr.iv447.i.i, i64 24576
  %exitcond.not390.i.i = icmp eq i64 %.415.i.i, %.87.i.i
  br i1 %exitcond.not390.i.i, label %B812.i.i, label %B226.if.i.i

B60.if.preheader.i.i.i:                           ; preds = %B860.i.i
  tail call void @llvm.memset.p0.i64(ptr align 8 %.2531.i.i, i8 0, i64 %134, i1 false), !noalias !40
  br label %B128.if.lr.ph.i.i.i

B128.if.lr.ph.i.i.i:                              ; preds = %B60.if.preheader.i.i.i, %B860.i.i
  %149 = inttoptr i64 %.2459.i.i to ptr
  %scevgep422.i.i = getelementptr i8, ptr %.2531.i.i, i64 24
  %scevgep430.i.i = getelementptr i8, ptr %149, i64 24
  %150 = inttoptr i64 %.2786.i.i to ptr
  br label %B128.if.i.i.i

B284.i.i.i:                                       ; preds = %B228.if.i.i.i, %B130.else.endif.endif.endif.endif.i.i.i
  %exitcond292.not.i.i.i = icmp eq i64 %.324.i.i.i, %.2381.i.i
  br i1 %exitcond292.not.i.i.i, label %B860.endif.endif.endif.endif.endif.i.i, label %B128.if.i.i.i

B128.if.i.i.i:                                    ; preds = %B284.i.i.i, %B128.if.lr.ph.i.i.i
  %.317279285.i.i.i = phi i64 [ 0, %B128.if.lr.ph.i.i.i ], [ %.324.i.i.i, %B284.i.i.i ]
  %.324.i.i.i = add nuw nsw i64 %.317279285.i.i.i, 1
  %.350.i158.i.i = mul nsw i64 %.317279285.i.i.i, %.161.i.i
  %.352.i.i.i = add nsw i64 %.350.i158.i.i, %.213211001120.i
  %.395.i.i56.i = icmp slt i64 %.352.i.i.i, 0
  %.396.i.i57.i = select i1 %.395.i.i56.i, i64 %.2462.i.i, i64 0
  %.397.i.i58.i = add i64 %.396.i.i57.i, %.352.i.i.i
  %.400.i.i59.i = icmp slt i64 %.397.i.i58.i, 0
  br i1 %.400.i.i59.i, label %B130.else.if.i.i.i, label %B130.else.endif.i.i.i, !prof !18

B130.else.if.i.i.i:                               ; preds = %B128.if.i.i.i
  br label %B130.else.endif.i.i.i

B130.else.endif.i.i.i:                            ; preds = %B130.else.if.i.i.i, %B128.if.i.i.i
  %.385.sroa.0.1.i.i.i = phi i64 [ 0, %B130.else.if.i.i.i ], [ %.397.i.i58.i, %B128.if.i.i.i ]
  %.405.not.i.i.i = icmp slt i64 %.397.i.i58.i, %.2462.i.i
  br i1 %.405.not.i.i.i, label %B130.else.endif.endif.endif.endif.i.i.i, label %B130.else.endif.if.i.i.i, !prof !43

B130.else.endif.if.i.i.i:                         ; preds = %B130.else.endif.i.i.i
  br label %B130.else.endif.endif.endif.endif.i.i.i

B130.else.endif.endif.endif.endif.i.i.i:          ; preds = %B130.else.endif.if.i.i.i, %B130.else.endif.i.i.i
  %.385.sroa.0.3.i.i.i = phi i64 [ %.2462.i.i, %B130.else.endif.if.i.i.i ], [ %.385.sroa.0.1.i.i.i, %B130.else.endif.i.i.i ]
  %151 = getelementptr double, ptr %150, i64 %.317279285.i.i.i
  %.565.i159.i.i = load double, ptr %151, align 8, !noalias !40
  br i1 %135, label %B284.i.i.i, label %B228.if.preheader.i.i.i

B228.if.preheader.i.i.i:                          ; preds = %B130.else.endif.endif.endif.endif.i.i.i
  %152 = shl i64 %.385.sroa.0.3.i.i.i, 3
  %scevgep431.i.i = getelementptr i8, ptr %scevgep430.i.i, i64 %152
  br label %B228.if.i.i.i

B228.if.i.i.i:                                    ; preds = %B228.if.i.i.i, %B228.if.preheader.i.i.i
  %lsr.iv13.i.i = phi i64 [ %lsr.iv.next14.i.i, %B228.if.i.i.i ], [ %138, %B228.if.preheader.i.i.i ]
  %.655272274.i.i.i = phi i64 [ %.662.1.i.1.i.i, %B228.if.i.i.i ], [ 0, %B228.if.preheader.i.i.i ]
  %153 = shl i64 %.655272274.i.i.i, 3
  %scevgep428.i.i = getelementptr i8, ptr %scevgep422.i.i, i64 %153
  %scevgep429.i.i = getelementptr i8, ptr %scevgep428.i.i, i64 -24
  %.716.i.i.i = load double, ptr %scevgep429.i.i, align 8, !noalias !40
  %scevgep434.i.i = getelementptr i8, ptr %scevgep431.i.i, i64 %153
  %scevgep435.i.i = getelementptr i8, ptr %scevgep434.i.i, i64 -16
  %scevgep18.i.i = getelementptr i8, ptr %scevgep434.i.i, i64 -24
  %.746.i.i.i = load double, ptr %scevgep18.i.i, align 8, !noalias !40
  %.748.i.i.i = fmul contract double %.565.i159.i.i, %.746.i.i.i
  %.749.i.i.i = fadd contract double %.716.i.i.i, %.748.i.i.i
  store double %.749.i.i.i, ptr %scevgep429.i.i, align 8, !noalias !40
  %scevgep22.i.i = getelementptr i8, ptr %scevgep428.i.i, i64 -16
  %.716.1.i.i.i = load double, ptr %scevgep22.i.i, align 8, !noalias !40
  %.746.1.i.i.i = load double, ptr %scevgep435.i.i, align 8, !noalias !40
  %.748.1.i.i.i = fmul contract double %.565.i159.i.i, %.746.1.i.i.i
  %.749.1.i.i.i = fadd contract double %.716.1.i.i.i, %.748.1.i.i.i
  store double %.749.1.i.i.i, ptr %scevgep22.i.i, align 8, !noalias !40
  %scevgep20.i60.i = getelementptr i8, ptr %scevgep428.i.i, i64 -8
  %.716.i.1.i.i = load double, ptr %scevgep20.i60.i, align 8, !noalias !40
  %scevgep16.i.i = getelementptr i8, ptr %scevgep434.i.i, i64 -8
  %.746.i.1.i.i = load double, ptr %scevgep16.i.i, align 8, !noalias !40
  %.748.i.1.i.i = fmul contract double %.565.i159.i.i, %.746.i.1.i.i
  %.749.i.1.i.i = fadd contract double %.716.i.1.i.i, %.748.i.1.i.i
  store double %.749.i.1.i.i, ptr %scevgep20.i60.i, align 8, !noalias !40
  %.662.1.i.1.i.i = add i64 %.655272274.i.i.i, 4
  %.716.1.i.1.i.i = load double, ptr %scevgep428.i.i, align 8, !noalias !40
  %.746.1.i.1.i.i = load double, ptr %scevgep434.i.i, align 8, !noalias !40
  %.748.1.i.1.i.i = fmul contract double %.565.i159.i.i, %.746.1.i.1.i.i
  %.749.1.i.1.i.i = fadd contract double %.716.1.i.1.i.i, %.748.1.i.1.i.i
  store double %.749.1.i.1.i.i, ptr %scevgep428.i.i, align 8, !noalias !40
  %lsr.iv.next14.i.i = add i64 %lsr.iv13.i.i, -2
  %niter.ncmp.1.i.i = icmp eq i64 %lsr.iv.next14.i.i, 0
  br i1 %niter.ncmp.1.i.i, label %B284.i.i.i, label %B228.if.i.i.i

B860.endif.endif.endif.endif.endif.i.i:           ; preds = %B284.i.i.i
  %.2903.i.i = load i64, ptr %.2902.i.i, align 8, !noalias !31
  %.2909.i.i = add nsw i64 %.2903.i.i, %.2428.i.i
  br i1 %.104.i.i.i, label %B60.if.preheader.i218.i.i, label %B128.if.lr.ph.i169.i.i

B60.if.preheader.i218.i.i:                        ; preds = %B860.endif.endif.endif.endif.endif.i.i
  tail call void @llvm.memset.p0.i64(ptr align 8 %.2599.i.i, i8 0, i64 %134, i1 false), !noalias !44
  br label %B128.if.lr.ph.i169.i.i

B128.if.lr.ph.i169.i.i:                           ; preds = %B60.if.preheader.i218.i.i, %B860.endif.endif.endif.endif.endif.i.i
  %scevgep405.i.i = getelementptr i8, ptr %.2531.i.i, i64 4120
  %154 = inttoptr i64 %.2909.i.i to ptr
  br label %B128.if.i172.i.i

B284.i215.i.i:                                    ; preds = %B228.if.i192.i.i, %B130.else.endif.endif.endif.endif.i185.i.i
  %exitcond292.not.i216.i.i = icmp eq i64 %.324.i174.i.i, %.2381.i.i
  br i1 %exitcond292.not.i216.i.i, label %B860.endif.endif.endif.endif.endif.endif.endif.i.i, label %B128.if.i172.i.i

B128.if.i172.i.i:                                 ; preds = %B284.i215.i.i, %B128.if.lr.ph.i169.i.i
  %.317279285.i173.i.i = phi i64 [ 0, %B128.if.lr.ph.i169.i.i ], [ %.324.i174.i.i, %B284.i215.i.i ]
  %.324.i174.i.i = add nuw nsw i64 %.317279285.i173.i.i, 1
  %.350.i175.i.i = mul nsw i64 %.317279285.i173.i.i, %.161.i.i
  %.352.i176.i.i = add nsw i64 %.350.i175.i.i, %.213211001120.i
  %.395.i177.i.i = icmp slt i64 %.352.i176.i.i, 0
  %.396.i178.i.i = select i1 %.395.i177.i.i, i64 %.2462.i.i, i64 0
  %.397.i179.i.i = add i64 %.396.i178.i.i, %.352.i176.i.i
  %.400.i180.i.i = icmp slt i64 %.397.i179.i.i, 0
  br i1 %.400.i180.i.i, label %B130.else.if.i217.i.i, label %B130.else.endif.i181.i.i, !prof !18

B130.else.if.i217.i.i:                            ; preds = %B128.if.i172.i.i
  br label %B130.else.endif.i181.i.i

B130.else.endif.i181.i.i:                         ; preds = %B130.else.if.i217.i.i, %B128.if.i172.i.i
  %.385.sroa.0.1.i182.i.i = phi i64 [ 0, %B130.else.if.i217.i.i ], [ %.397.i179.i.i, %B128.if.i172.i.i ]
  %.405.not.i183.i.i = icmp slt i64 %.397.i179.i.i, %.2462.i.i
  br i1 %.405.not.i183.i.i, label %B130.else.endif.endif.endif.endif.i185.i.i, label %B130.else.endif.if.i184.i.i, !prof !43

B130.else.endif.if.i184.i.i:                      ; preds = %B130.else.endif.i181.i.i
  br label %B130.else.endif.endif.endif.endif.i185.i.i

B130.else.endif.endif.endif.endif.i185.i.i:       ; preds = %B130.else.endif.if.i184.i.i, %B130.else.endif.i181.i.i
  %.385.sroa.0.3.i186.i.i = phi i64 [ %.2462.i.i, %B130.else.endif.if.i184.i.i ], [ %.385.sroa.0.1.i182.i.i, %B130.else.endif.i181.i.i ]
  %155 = getelementptr double, ptr %154, i64 %.317279285.i173.i.i
  %.565.i188.i.i = load double, ptr %155, align 8, !noalias !44
  br i1 %135, label %B284.i215.i.i, label %B228.if.preheader.i189.i.i

B228.if.preheader.i189.i.i:                       ; preds = %B130.else.endif.endif.endif.endif.i185.i.i
  %156 = shl i64 %.385.sroa.0.3.i186.i.i, 3
  %scevgep414.i.i = getelementptr i8, ptr %scevgep430.i.i, i64 %156
  br label %B228.if.i192.i.i

B228.if.i192.i.i:                                 ; preds = %B228.if.i192.i.i, %B228.if.preheader.i189.i.i
  %lsr.iv3.i.i = phi i64 [ %lsr.iv.next4.i.i, %B228.if.i192.i.i ], [ %138, %B228.if.preheader.i189.i.i ]
  %.655272274.i193.i.i = phi i64 [ %.662.1.i201.1.i.i, %B228.if.i192.i.i ], [ 0, %B228.if.preheader.i189.i.i ]
  %157 = shl i64 %.655272274.i193.i.i, 3
  %scevgep411.i.i = getelementptr i8, ptr %scevgep405.i.i, i64 %157
  %scevgep412.i.i = getelementptr i8, ptr %scevgep411.i.i, i64 -24
  %.716.i195.i.i = load double, ptr %scevgep412.i.i, align 8, !noalias !44
  %scevgep417.i.i = getelementptr i8, ptr %scevgep414.i.i, i64 %157
  %scevgep418.i.i = getelementptr i8, ptr %scevgep417.i.i, i64 -16
  %scevgep8.i61.i = getelementptr i8, ptr %scevgep417.i.i, i64 -24
  %.746.i198.i.i = load double, ptr %scevgep8.i61.i, align 8, !noalias !44
  %.748.i199.i.i = fmul contract double %.565.i188.i.i, %.746.i198.i.i
  %.749.i200.i.i = fadd contract double %.716.i195.i.i, %.748.i199.i.i
  store double %.749.i200.i.i, ptr %scevgep412.i.i, align 8, !noalias !44
  %scevgep12.i62.i = getelementptr i8, ptr %scevgep411.i.i, i64 -16
  %.716.1.i203.i.i = load double, ptr %scevgep12.i62.i, align 8, !noalias !44
  %.746.1.i204.i.i = load double, ptr %scevgep418.i.i, align 8, !noalias !44
  %.748.1.i205.i.i = fmul contract double %.565.i188.i.i, %.746.1.i204.i.i
  %.749.1.i206.i.i = fadd contract double %.716.1.i203.i.i, %.748.1.i205.i.i
  store double %.749.1.i206.i.i, ptr %scevgep12.i62.i, align 8, !noalias !44
  %scevgep10.i63.i = getelementptr i8, ptr %scevgep411.i.i, i64 -8
  %.716.i195.1.i.i = load double, ptr %scevgep10.i63.i, align 8, !noalias !44
  %scevgep6.i64.i = getelementptr i8, ptr %scevgep417.i.i, i64 -8
  %.746.i198.1.i.i = load double, ptr %scevgep6.i64.i, align 8, !noalias !44
  %.748.i199.1.i.i = fmul contract double %.565.i188.i.i, %.746.i198.1.i.i
  %.749.i200.1.i.i = fadd contract double %.716.i195.1.i.i, %.748.i199.1.i.i
  store double %.749.i200.1.i.i, ptr %scevgep10.i63.i, align 8, !noalias !44
  %.662.1.i201.1.i.i = add i64 %.655272274.i193.i.i, 4
  %.716.1.i203.1.i.i = load double, ptr %scevgep411.i.i, align 8, !noalias !44
  %.746.1.i204.1.i.i = load double, ptr %scevgep417.i.i, align 8, !noalias !44
  %.748.1.i205.1.i.i = fmul contract double %.565.i188.i.i, %.746.1.i204.1.i.i
  %.749.1.i206.1.i.i = fadd contract double %.716.1.i203.1.i.i, %.748.1.i205.1.i.i
  store double %.749.1.i206.1.i.i, ptr %scevgep411.i.i, align 8, !noalias !44
  %lsr.iv.next4.i.i = add i64 %lsr.iv3.i.i, -2
  %niter399.ncmp.1.i.i = icmp eq i64 %lsr.iv.next4.i.i, 0
  br i1 %niter399.ncmp.1.i.i, label %B284.i215.i.i, label %B228.if.i192.i.i

B860.endif.endif.endif.endif.endif.endif.endif.i.i: ; preds = %B284.i215.i.i
  %.30861548.not.i.i = icmp slt i64 %.87.i.i, 1
  br i1 %.30861548.not.i.i, label %_ZN17bnserve_inference13moving_kernel7_source8_respondB3v89B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i, label %B1270.if.i.i

B1270.if.i.i:                                     ; preds = %B860.endif.endif.endif.endif.endif.endif.endif.i.i, %B1272.endif.endif.endif.i.i
  %lsr.iv.i66.i = phi ptr [ %scevgep400.i.i, %B1272.endif.endif.endif.i.i ], [ %scevgep440.i.i, %B860.endif.endif.endif.endif.endif.endif.endif.i.i ]
  %.309215451549.i.i = phi i64 [ %.3099.i.i, %B1272.endif.endif.endif.i.i ], [ 0, %B860.endif.endif.endif.endif.endif.endif.endif.i.i ]
  %.3099.i.i = add nuw nsw i64 %.309215451549.i.i, 1
  br i1 %135, label %B1272.endif.endif.endif.i.i, label %B56.if.i.i67.i

B56.if.i.i67.i:                                   ; preds = %B1270.if.i.i, %B56.if.i.i67.i
  %.158152154.i.i.i = phi i64 [ %.165.i.i.i, %B56.if.i.i67.i ], [ 0, %B1270.if.i.i ]
  %.165.i.i.i = add nuw nsw i64 %.158152154.i.i.i, 1
  %158 = shl i64 %.158152154.i.i.i, 3
  %scevgep3.i230.i.i = getelementptr i8, ptr %.2599.i.i, i64 %158
  %.219.i.i.i = load double, ptr %scevgep3.i230.i.i, align 8, !noalias !47
  %scevgep404.i.i = getelementptr i8, ptr %scevgep3.i230.i.i, i64 -4096
  %.249.i.i68.i = load double, ptr %scevgep404.i.i, align 8, !noalias !47
  %.250.i.i69.i = fadd contract double %.249.i.i68.i, 1.000000e+00
  %.251.i.i70.i = fmul contract double %.219.i.i.i, %.219.i.i.i
  %.252.i.i71.i = fadd contract double %.251.i.i70.i, 4.000000e+00
  %.256.i.i72.i = fdiv contract double %.250.i.i69.i, %.252.i.i71.i
  %.258.i.i73.i = fsub contract double 4.000000e+00, %.251.i.i70.i
  %.259.i.i74.i = fmul contract double %.258.i.i73.i, %.256.i.i72.i
  %.260.i.i75.i = fmul contract double %.219.i.i.i, 4.000000e+00
  %.261.i.i76.i = fmul contract double %.260.i.i75.i, %.256.i.i72.i
  %scevgep1.i77.i = getelementptr i8, ptr %lsr.iv.i66.i, i64 %158
  %scevgep2.i.i = getelementptr i8, ptr %scevgep1.i77.i, i64 -4096
  %.291.i.i.i = load double, ptr %scevgep2.i.i, align 8, !noalias !47
  %.321.i.i.i = load double, ptr %scevgep1.i77.i, align 8, !noalias !47
  %.322.i.i.i = fmul contract double %.291.i.i.i, %.259.i.i74.i
  %.323.i.i.i = fmul contract double %.321.i.i.i, %.261.i.i76.i
  %.324.i234.i.i = fsub contract double %.322.i.i.i, %.323.i.i.i
  store double %.324.i234.i.i, ptr %scevgep2.i.i, align 8, !noalias !47
  %.355.i.i.i = fmul contract double %.291.i.i.i, %.261.i.i76.i
  %.356.i.i.i = fmul contract double %.321.i.i.i, %.259.i.i74.i
  %.357.i.i.i = fadd contract double %.355.i.i.i, %.356.i.i.i
  store double %.357.i.i.i, ptr %scevgep1.i77.i, align 8, !noalias !47
  %exitcond.not.i235.i.i = icmp eq i64 %.13.i.i, %.165.i.i.i
  br i1 %exitcond.not.i235.i.i, label %B1272.endif.endif.endif.i.i, label %B56.if.i.i67.i

B1272.endif.endif.endif.i.i:                      ; preds = %B56.if.i.i67.i, %B1270.if.i.i
  %scevgep400.i.i = getelementptr i8, ptr %lsr.iv.i66.i, i64 8192
  %exitcond.not.i78.i = icmp eq i64 %.87.i.i, %.3099.i.i
  br i1 %exitcond.not.i78.i, label %_ZN17bnserve_inference13moving_kernel7_source8_respondB3v89B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i, label %B1270.if.i.i

_ZN17bnserve_inference13moving_kernel7_source8_respondB3v89B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i: ; preds = %B1272.endif.endif.endif.i.i, %B860.endif.endif.endif.endif.endif.endif.endif.i.i, %B812.i.i
  call void @llvm.lifetime.end.p0(ptr nonnull %.2081.i.i), !noalias !0
  call void @llvm.lifetime.end.p0(ptr nonnull %.2136.i.i), !noalias !0
  %.2484.i = load double, ptr %lsr.iv.i, align 8, !noalias !0
  %.79.i120.i = load i64, ptr %.76.i, align 8, !noalias !50
  %.109.i122.i = load i64, ptr %.106.i, align 8, !noalias !50
  %.178.i.i = load i64, ptr %.422.i, align 8, !noalias !50
  %.261.i.i = load i64, ptr %.198.i.i, align 8, !noalias !50
  %.263.i.i = inttoptr i64 %.261.i.i to ptr
  %.327.i.i = getelementptr double, ptr %.263.i.i, i64 %.213211001120.i
  %.4921211.i.i = load double, ptr %.491.i.i, align 8, !noalias !50
  %.632.idx.i.i = shl i64 %.79.i120.i, 13
  %.632.i.i = getelementptr i8, ptr %.289.i, i64 %.632.idx.i.i
  %.944.i.i = getelementptr i8, ptr %.632.i.i, i64 12288
  %.11791351.not.i.i = icmp slt i64 %.178.i.i, 1
  br i1 %.11791351.not.i.i, label %_ZN17bnserve_inference12modes_kernel7_source13_add_productsB4v129B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxx5ArrayIxLi1E1C7mutable7alignedEdd5ArrayIdLi1E1C7mutable7alignedE.exit.i, label %B634.if.lr.ph.i.i

B634.loopexit.i.i:                                ; preds = %B1538.i.i, %B638.endif.i.i
  %exitcond1480.not.i.i = icmp eq i64 %.1192.i.i, %.178.i.i
  br i1 %exitcond1480.not.i.i, label %_ZN17bnserve_inference12modes_kernel7_source13_add_productsB4v129B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxx5ArrayIxLi1E1C7mutable7alignedEdd5ArrayIdLi1E1C7mutable7alignedE.exit.i, label %B634.if.i.i

B934.i.i:                                         ; preds = %B728.if.i.i
  %159 = inttoptr i64 %.1712.i.i to ptr
  %.1785.i.i = getelementptr double, ptr %159, i64 %.213211001120.i
  %.1856.i.i = getelementptr double, ptr %159, i64 %.1839.i.i
  br i1 %135, label %B1136.i.i, label %B56.if.i.i200.i

B1046.i.i:                                        ; preds = %B728.if.i.i
  %.48.i.i.i = load double, ptr %sunkaddr82.i.i, align 8, !noalias !53
  %.49.i.i.i = fsub contract double %.1227.i.i, %.48.i.i.i
  %.78.i.i.i = load double, ptr %sunkaddr84.i.i, align 8, !noalias !53
  %.85.i.i.i = fdiv contract double %.49.i.i.i, %.78.i.i.i
  %.93.le.i.i.i = tail call contract double @llvm.floor.f64(double %.85.i.i.i)
  %.5.i.i.i.i = fptosi double %.93.le.i.i.i to i64
  %.13.i.i.i.i = tail call i64 @llvm.smax.i64(i64 %.5.i.i.i.i, i64 2)
  %.13.i1.i.i.i = tail call i64 @llvm.smin.i64(i64 %.152.i.i.i, i64 %.13.i.i.i.i)
  %.181.i.i.i = sitofp i64 %.13.i1.i.i.i to double
  %.182.i.i.i = fsub contract double %.85.i.i.i, %.181.i.i.i
  %.183.i.i.i = fsub contract double 1.000000e+00, %.182.i.i.i
  %.184.i.i.i = fmul contract double %.183.i.i.i, %.183.i.i.i
  %.185.i.i.i = fmul contract double %.183.i.i.i, %.184.i.i.i
  %.186.i.i155.i = fmul contract double %.183.i.i.i, %.185.i.i.i
  %.187.i.i.i = fmul contract double %.183.i.i.i, %.186.i.i155.i
  %.191.i.i156.i = fdiv contract double %.187.i.i.i, 1.200000e+02
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
  %.208.i.i157.i = fmul contract double %.182.i.i.i, 1.000000e+01
  %.209.i.i158.i = fsub contract double 3.000000e+01, %.208.i.i157.i
  %.210.i.i.i = fmul contract double %.206.i.i.i, %.209.i.i158.i
  %.211.i.i159.i = fadd contract double %.210.i.i.i, -6.000000e+01
  %.212.i.i160.i = fmul contract double %.206.i.i.i, %.211.i.i159.i
  %.213.i.i161.i = fadd contract double %.212.i.i160.i, 6.600000e+01
  %.217.i.i.i = fdiv contract double %.213.i.i161.i, 1.200000e+02
  %.220.i.i.i = fmul contract double %.183.i.i.i, 1.000000e+01
  %.221.i.i.i = fsub contract double 3.000000e+01, %.220.i.i.i
  %.222.i.i.i = fmul contract double %.184.i.i.i, %.221.i.i.i
  %.223.i.i.i = fadd contract double %.222.i.i.i, -6.000000e+01
  %.224.i.i.i = fmul contract double %.184.i.i.i, %.223.i.i.i
  %.225.i.i.i = fadd contract double %.224.i.i.i, 6.600000e+01
  %.229.i.i.i = fdiv contract double %.225.i.i.i, 1.200000e+02
  %.230.i.i.i = fmul contract double %.183.i.i.i, 5.000000e+00
  %.231.i.i162.i = fadd contract double %.230.i.i.i, -2.000000e+01
  %.232.i.i.i = fmul contract double %.183.i.i.i, %.231.i.i162.i
  %.233.i.i.i = fadd contract double %.232.i.i.i, 2.000000e+01
  %.234.i.i.i = fmul contract double %.183.i.i.i, %.233.i.i.i
  %.235.i.i.i = fadd contract double %.234.i.i.i, 2.000000e+01
  %.236.i.i.i = fmul contract double %.183.i.i.i, %.235.i.i.i
  %.237.i.i.i = fadd contract double %.236.i.i.i, -5.000000e+01
  %.238.i.i.i = fmul contract double %.183.i.i.i, %.237.i.i.i
  %.239.i.i.i = fadd contract double %.238.i.i.i, 2.600000e+01
  %.243.i.i163.i = fdiv contract double %.239.i.i.i, 1.200000e+02
  %.245.i.i164.i = fmul contract double %.182.i.i.i, %.206.i.i.i
  %.246.i.i165.i = fmul contract double %.182.i.i.i, %.245.i.i164.i
  %.247.i.i166.i = fmul contract double %.182.i.i.i, %.246.i.i165.i
  %.251.i.i167.i = fdiv contract double %.247.i.i166.i, 1.200000e+02
  br i1 %135, label %B1136.i.i, label %B642.if.i.preheader.i.i

B642.if.i.preheader.i.i:                          ; preds = %B1046.i.i
  %.265.i.i168.i = add i64 %.13.i1.i.i.i, -2
  %160 = inttoptr i64 %.1712.i.i to ptr
  %161 = shl i64 %.13.i1.i.i.i, 7
  %162 = sub i64 -448, %161
  %163 = sub i64 -320, %161
  %164 = sub i64 -192, %161
  %165 = sub nuw nsw i64 -64, %161
  %166 = sub i64 64, %161
  %167 = sub i64 192, %161
  %168 = sub i64 -384, %161
  %169 = sub i64 -256, %161
  %170 = sub nuw nsw i64 -128, %161
  %171 = sub i64 128, %161
  %scevgep10.i169.i = getelementptr i8, ptr %160, i64 %139
  %172 = mul i64 %162, %185
  %scevgep11.i170.i = getelementptr i8, ptr %scevgep10.i169.i, i64 %172
  %173 = mul i64 %163, %185
  %scevgep13.i171.i = getelementptr i8, ptr %scevgep10.i169.i, i64 %173
  %174 = mul i64 %164, %185
  %scevgep15.i.i = getelementptr i8, ptr %scevgep10.i169.i, i64 %174
  %175 = mul i64 %165, %185
  %scevgep37.i.i = getelementptr i8, ptr %scevgep10.i169.i, i64 %175
  %176 = mul i64 %166, %185
  %scevgep46.i.i = getelementptr i8, ptr %scevgep10.i169.i, i64 %176
  %177 = mul i64 %167, %185
  %scevgep52.i.i = getelementptr i8, ptr %scevgep10.i169.i, i64 %177
  %178 = mul i64 %168, %185
  %scevgep56.i.i = getelementptr i8, ptr %scevgep10.i169.i, i64 %178
  %179 = mul i64 %169, %185
  %scevgep58.i.i = getelementptr i8, ptr %scevgep10.i169.i, i64 %179
  %180 = mul i64 %170, %185
  %scevgep60.i.i = getelementptr i8, ptr %scevgep10.i169.i, i64 %180
  %181 = mul i64 %.13.i1.i.i.i, %186
  %scevgep63.i.i = getelementptr i8, ptr %scevgep10.i169.i, i64 %181
  %182 = mul i64 %171, %185
  %scevgep65.i.i = getelementptr i8, ptr %scevgep10.i169.i, i64 %182
  %183 = mul i64 %.265.i.i168.i, %186
  %scevgep67.i.i = getelementptr i8, ptr %scevgep10.i169.i, i64 %183
  br label %B642.if.i.i.i

B1136.i.i:                                        ; preds = %B642.if.i.i.i, %B56.if.i.i200.i, %B1046.i.i, %B934.i.i
  %.2160.i175.i = mul nuw nsw i64 %.135212881302.i.i, %.178.i.i
  %.2162.i.i = add nuw nsw i64 %.2160.i175.i, %.118513191354.i.i
  %.idx.i176.i = shl i64 %.2162.i.i, 4
  %184 = getelementptr i8, ptr %189, i64 %.idx.i176.i
  %.2193.i.i = load double, ptr %184, align 8, !noalias !50
  br i1 %140, label %B1136.endif.thread.i.i, label %B104.if.i.i.i

B1136.endif.thread.i.i:                           ; preds = %B1136.i.i
  %.22223.i.i = fadd contract double %.2193.i.i, 0.000000e+00
  store double %.22223.i.i, ptr %184, align 8, !noalias !50
  %sunkaddr86.i.i = getelementptr i8, ptr %184, i64 8
  %.22897.i.i = load double, ptr %sunkaddr86.i.i, align 8, !noalias !50
  br label %B1136.endif.endif.i.i

B104.if.i.i.i:                                    ; preds = %B1136.i.i, %B104.if.i.i.i
  %lsr.iv9.i.i.i = phi i64 [ %lsr.iv.next.i.i189.i, %B104.if.i.i.i ], [ %.60.1.i.i.i, %B1136.i.i ]
  %lsr.iv.i.i177.i = phi ptr [ %scevgep1.i.i.i, %B104.if.i.i.i ], [ %scevgep.i.i126.i, %B1136.i.i ]
  %s7.2.0168.i.i.i = phi double [ %.489.i.i.i, %B104.if.i.i.i ], [ 0.000000e+00, %B1136.i.i ]
  %s6.2.0167.i.i.i = phi double [ %.454.i.i.i, %B104.if.i.i.i ], [ 0.000000e+00, %B1136.i.i ]
  %s5.2.0166.i.i.i = phi double [ %.419.i.i188.i, %B104.if.i.i.i ], [ 0.000000e+00, %B1136.i.i ]
  %s4.2.0165.i.i.i = phi double [ %.384.i.i186.i, %B104.if.i.i.i ], [ 0.000000e+00, %B1136.i.i ]
  %s3.2.0164.i.i.i = phi double [ %.349.i.i.i, %B104.if.i.i.i ], [ 0.000000e+00, %B1136.i.i ]
  %s2.2.0163.i.i.i = phi double [ %.314.i.i.i, %B104.if.i.i.i ], [ 0.000000e+00, %B1136.i.i ]
  %s1.2.0162.i.i.i = phi double [ %.279.i.i.i, %B104.if.i.i.i ], [ 0.000000e+00, %B1136.i.i ]
  %s0.2.0161.i.i.i = phi double [ %.244.i.i179.i, %B104.if.i.i.i ], [ 0.000000e+00, %B1136.i.i ]
  %scevgep2.i.i178.i = getelementptr i8, ptr %lsr.iv.i.i177.i, i64 -56
  %.242.i.i.i = load double, ptr %scevgep2.i.i178.i, align 8, !noalias !56
  %.244.i.i179.i = fadd contract double %s0.2.0161.i.i.i, %.242.i.i.i
  %scevgep3.i.i180.i = getelementptr i8, ptr %lsr.iv.i.i177.i, i64 -48
  %.277.i.i181.i = load double, ptr %scevgep3.i.i180.i, align 8, !noalias !56
  %.279.i.i.i = fadd contract double %s1.2.0162.i.i.i, %.277.i.i181.i
  %scevgep4.i.i182.i = getelementptr i8, ptr %lsr.iv.i.i177.i, i64 -40
  %.312.i.i.i = load double, ptr %scevgep4.i.i182.i, align 8, !noalias !56
  %.314.i.i.i = fadd contract double %s2.2.0163.i.i.i, %.312.i.i.i
  %scevgep5.i.i183.i = getelementptr i8, ptr %lsr.iv.i.i177.i, i64 -32
  %.347.i.i184.i = load double, ptr %scevgep5.i.i183.i, align 8, !noalias !56
  %.349.i.i.i = fadd contract double %s3.2.0164.i.i.i, %.347.i.i184.i
  %scevgep6.i.i.i = getelementptr i8, ptr %lsr.iv.i.i177.i, i64 -24
  %.382.i.i185.i = load double, ptr %scevgep6.i.i.i, align 8, !noalias !56
  %.384.i.i186.i = fadd contract double %s4.2.0165.i.i.i, %.382.i.i185.i
  %scevgep7.i.i.i = getelementptr i8, ptr %lsr.iv.i.i177.i, i64 -16
  %.417.i.i187.i = load double, ptr %scevgep7.i.i.i, align 8, !noalias !56
  %.419.i.i188.i = fadd contract double %s5.2.0166.i.i.i, %.417.i.i187.i
  %scevgep8.i.i.i = getelementptr i8, ptr %lsr.iv.i.i177.i, i64 -8
  %.452.i.i.i = load double, ptr %scevgep8.i.i.i, align 8, !noalias !56
  %.454.i.i.i = fadd contract double %s6.2.0167.i.i.i, %.452.i.i.i
  %.487.i.i.i = load double, ptr %lsr.iv.i.i177.i, align 8, !noalias !56
  %.489.i.i.i = fadd contract double %s7.2.0168.i.i.i, %.487.i.i.i
  %scevgep1.i.i.i = getelementptr i8, ptr %lsr.iv.i.i177.i, i64 64
  %lsr.iv.next.i.i189.i = add nsw i64 %lsr.iv9.i.i.i, -1
  %exitcond.not.i.i190.i = icmp eq i64 %lsr.iv.next.i.i189.i, 0
  br i1 %exitcond.not.i.i190.i, label %B104.if.i159.preheader.i.i, label %B104.if.i.i.i

B1312.i.i:                                        ; preds = %B1136.endif.endif.i.i
  %.2383.i.i = load i64, ptr %.504.i, align 8, !noalias !50
  %.2384.not.i.i = icmp eq i64 %.2383.i.i, 0
  %or.cond.i.i = select i1 %.2384.not.i.i, i1 true, i1 %190
  br i1 %or.cond.i.i, label %B1538.i.i, label %B62.if.preheader.i.i.i

B1538.i.i:                                        ; preds = %B62.if.i.i.i, %B1136.endif.endif.i.i, %B1312.i.i
  %scevgep388.i.i = getelementptr i8, ptr %lsr.iv.i154.i, i64 8192
  %exitcond.not.i191.i = icmp eq i64 %.79.i120.i, %.1359.i.i
  br i1 %exitcond.not.i191.i, label %B634.loopexit.i.i, label %B728.if.i.i

B634.if.lr.ph.i.i:                                ; preds = %_ZN17bnserve_inference13moving_kernel7_source8_respondB3v89B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i
  %.546.i.i = load i64, ptr %sunkaddr133.i, align 8, !noalias !50
  %.550.i124.i = mul i64 %.79.i120.i, %.548.i123.i
  %.552.i.i = mul i64 %.550.i124.i, %.178.i.i
  %.553.i.i = add nsw i64 %.546.i.i, %.552.i.i
  %.414.i.i = load i64, ptr %.413.i125.i, align 8, !noalias !50
  %.139.i.i = load i64, ptr %.138.i.i, align 8, !noalias !50
  %.181.i.i = sub i64 0, %.109.i122.i
  %.189.1.i.i = and i64 %.181.i.i, -8
  %.1669.i.i = mul nsw i64 %.79.i120.i, %.232410861091.i
  %.1839.i.i = sub i64 %.213211001120.i, %.189.1.i.i
  %.2350.i.i = add nsw i64 %.178.i.i, -1
  %.2388.i.i = sub i64 %.109.i122.i, %.213211001120.i
  %.2450.i.i = mul nsw i64 %.79.i120.i, %.631.sroa.0.073.i
  %.152.i.i.i = add i64 %.139.i.i, -4
  %scevgep.i.i126.i = getelementptr i8, ptr %.632.i.i, i64 56
  %scevgep.i158.i.i = getelementptr i8, ptr %.632.i.i, i64 4152
  %.13.i.i127.i = tail call i64 @llvm.smin.i64(i64 %.2388.i.i, i64 range(i64 -9223372036854775808, 513) %.13.i.i)
  %185 = lshr i64 %.181.i.i, 3
  %186 = mul i64 %185, -128
  %scevgep79.i.i = getelementptr i8, ptr %.632.i.i, i64 4096
  %187 = icmp slt i64 %.79.i120.i, 1
  %188 = icmp eq i64 %.139.i.i, 1
  %189 = inttoptr i64 %.553.i.i to ptr
  %sunkaddr82.i.i = inttoptr i64 %.414.i.i to ptr
  %sunkaddr84.i.i = getelementptr i8, ptr %sunkaddr82.i.i, i64 8
  %190 = icmp slt i64 %.13.i.i127.i, 1
  %factor.op.mul = mul i64 %.189.1.i.i, %.139.i.i
  %factor.op.mul.i.reass = mul i64 %factor.op.mul, -16
  br label %B634.if.i.i

B634.if.i.i:                                      ; preds = %B634.if.lr.ph.i.i, %B634.loopexit.i.i
  %.118513191354.i.i = phi i64 [ 0, %B634.if.lr.ph.i.i ], [ %.1192.i.i, %B634.loopexit.i.i ]
  %.1192.i.i = add nuw nsw i64 %.118513191354.i.i, 1
  %.1222.i.i = uitofp nneg i64 %.118513191354.i.i to double
  %.1223.i.i = fmul contract double %.4921211.i.i, %.1222.i.i
  %.1225.i.i = fadd contract double %.793.i, %.1223.i.i
  %.1227.i.i = fadd contract double %.2484.i, %.1225.i.i
  %.48.i107.i.i = fmul contract double %.1227.i.i, 0xC01921FB54442D18
  br i1 %135, label %B638.endif.i.i, label %B78.if.i.i.i

B78.if.i.i.i:                                     ; preds = %B634.if.i.i, %B78.if.i.i.i
  %.150106108.i.i.i = phi i64 [ %.157.i.i.i, %B78.if.i.i.i ], [ 0, %B634.if.i.i ]
  %.157.i.i.i = add nuw nsw i64 %.150106108.i.i.i, 1
  %191 = shl i64 %.150106108.i.i.i, 3
  %scevgep2.i108.i.i = getelementptr i8, ptr %.327.i.i, i64 %191
  %.212.i109.i.i = load double, ptr %scevgep2.i108.i.i, align 8, !noalias !59
  %.214.i.i.i = fmul contract double %.48.i107.i.i, %.212.i109.i.i
  %.215.i.i129.i = tail call contract double @llvm.fma.f64(double %.214.i.i.i, double 0x3FE45F306DC9C883, double 0x4338000000000000)
  %.216.i.i130.i = fadd contract double %.215.i.i129.i, 0xC338000000000000
  %.231.i110.i.i = tail call contract double @llvm.fma.f64(double %.216.i.i130.i, double 0xBFF921FB54442D18, double %.214.i.i.i)
  %.246.i111.i.i = tail call contract double @llvm.fma.f64(double %.216.i.i130.i, double 0xBC91A62633145C07, double %.231.i110.i.i)
  %.247.i112.i.i = fmul contract double %.246.i111.i.i, %.246.i111.i.i
  %.248.i.i131.i = tail call contract double @llvm.fma.f64(double %.247.i112.i.i, double 0xBD6AE7F3E733B81F, double 0x3DE6124613A86D09)
  %.249.i.i132.i = tail call contract double @llvm.fma.f64(double %.247.i112.i.i, double %.248.i.i131.i, double 0xBE5AE64567F544E4)
  %.250.i.i133.i = tail call contract double @llvm.fma.f64(double %.247.i112.i.i, double %.249.i.i132.i, double 0x3EC71DE3A556C734)
  %.251.i113.i.i = tail call contract double @llvm.fma.f64(double %.247.i112.i.i, double %.250.i.i133.i, double 0xBF2A01A01A01A01A)
  %.252.i.i134.i = tail call contract double @llvm.fma.f64(double %.247.i112.i.i, double %.251.i113.i.i, double 0x3F81111111111111)
  %.253.i.i135.i = tail call contract double @llvm.fma.f64(double %.247.i112.i.i, double %.252.i.i134.i, double 0xBFC5555555555555)
  %.254.i.i136.i = fmul contract double %.246.i111.i.i, %.247.i112.i.i
  %.255.i.i137.i = tail call contract double @llvm.fma.f64(double %.254.i.i136.i, double %.253.i.i135.i, double %.246.i111.i.i)
  %.256.i.i138.i = tail call contract double @llvm.fma.f64(double %.247.i112.i.i, double 0x3D2AE7F3E733B81F, double 0xBDA93974A8C07C9D)
  %.257.i.i139.i = tail call contract double @llvm.fma.f64(double %.247.i112.i.i, double %.256.i.i138.i, double 0x3E21EED8EFF8D898)
  %.258.i.i140.i = tail call contract double @llvm.fma.f64(double %.247.i112.i.i, double %.257.i.i139.i, double 0xBE927E4FB7789F5C)
  %.259.i.i141.i = tail call contract double @llvm.fma.f64(double %.247.i112.i.i, double %.258.i.i140.i, double 0x3EFA01A01A01A01A)
  %.260.i.i142.i = tail call contract double @llvm.fma.f64(double %.247.i112.i.i, double %.259.i.i141.i, double 0xBF56C16C16C16C17)
  %.261.i.i143.i = tail call contract double @llvm.fma.f64(double %.247.i112.i.i, double %.260.i.i142.i, double 0x3FA5555555555555)
  %.262.i.i144.i = tail call contract double @llvm.fma.f64(double %.247.i112.i.i, double %.261.i.i143.i, double -5.000000e-01)
  %.263.i.i145.i = tail call contract double @llvm.fma.f64(double %.247.i112.i.i, double %.262.i.i144.i, double 1.000000e+00)
  %.264.i114.i.i = bitcast double %.215.i.i129.i to i64
  %.265.i115.i.i = bitcast double %.255.i.i137.i to i64
  %.266.i116.i.i = bitcast double %.263.i.i145.i to i64
  %.267.i117.i.i = xor i64 %.266.i116.i.i, %.265.i115.i.i
  %.268.i.i146.i = and i64 %.264.i114.i.i, 1
  %192 = icmp eq i64 %.268.i.i146.i, 0
  %.270.i.i147.i = select i1 %192, i64 0, i64 %.267.i117.i.i
  %.271.i.i148.i = shl i64 %.264.i114.i.i, 62
  %.272.i.i149.i = and i64 %.271.i.i148.i, -9223372036854775808
  %.274.i.i150.i = add i64 %.271.i.i148.i, 4611686018427387904
  %.275.i.i151.i = and i64 %.274.i.i150.i, -9223372036854775808
  %193 = xor i64 %.272.i.i149.i, %.265.i115.i.i
  %.277.i118.i.i = xor i64 %193, %.270.i.i147.i
  %194 = xor i64 %.275.i.i151.i, %.266.i116.i.i
  %.280.i.i152.i = xor i64 %194, %.270.i.i147.i
  %scevgep9.i.i = getelementptr i8, ptr %.944.i.i, i64 %191
  store i64 %.277.i118.i.i, ptr %scevgep9.i.i, align 8, !noalias !59
  %scevgep8.i153.i = getelementptr i8, ptr %scevgep9.i.i, i64 -4096
  store i64 %.280.i.i152.i, ptr %scevgep8.i153.i, align 8, !noalias !59
  %exitcond.not.i121.i.i = icmp eq i64 %.13.i.i, %.157.i.i.i
  br i1 %exitcond.not.i121.i.i, label %B638.endif.i.i, label %B78.if.i.i.i

B638.endif.i.i:                                   ; preds = %B78.if.i.i.i, %B634.if.i.i
  br i1 %187, label %B634.loopexit.i.i, label %B728.if.preheader.i.i

B728.if.preheader.i.i:                            ; preds = %B638.endif.i.i
  %195 = icmp eq i64 %.118513191354.i.i, %.2350.i.i
  br label %B728.if.i.i

B728.if.i.i:                                      ; preds = %B728.if.preheader.i.i, %B1538.i.i
  %lsr.iv.i154.i = phi ptr [ %scevgep388.i.i, %B1538.i.i ], [ %scevgep440.i.i, %B728.if.preheader.i.i ]
  %.135212881302.i.i = phi i64 [ %.1359.i.i, %B1538.i.i ], [ 0, %B728.if.preheader.i.i ]
  %.1359.i.i = add nuw nsw i64 %.135212881302.i.i, 1
  %.1659.i.i = load i64, ptr %sunkaddr88.i.i, align 8, !noalias !50
  %.1660.i.i = icmp eq i64 %.1659.i.i, 1
  %.1671.i.i = add nuw nsw i64 %.135212881302.i.i, %.1669.i.i
  %"$phi838.2.2.2.i.i" = select i1 %.1660.i.i, i64 %.232410861091.i, i64 %.1671.i.i
  %.1708.i.i = load i64, ptr %sunkaddr89.i.i, align 8, !noalias !50
  %.1711.i.i = mul nsw i64 %factor.op.mul.i.reass, %"$phi838.2.2.2.i.i"
  %.1712.i.i = add nsw i64 %.1711.i.i, %.1708.i.i
  br i1 %188, label %B934.i.i, label %B1046.i.i

B56.if.i.i200.i:                                  ; preds = %B934.i.i, %B56.if.i.i200.i
  %.214284286.i.i.i = phi i64 [ %.221.i142.i.i, %B56.if.i.i200.i ], [ 0, %B934.i.i ]
  %.221.i142.i.i = add nuw nsw i64 %.214284286.i.i.i, 1
  %196 = shl i64 %.214284286.i.i.i, 3
  %scevgep402.i.i = getelementptr i8, ptr %lsr.iv.i154.i, i64 %196
  %scevgep403.i.i = getelementptr i8, ptr %scevgep402.i.i, i64 -4096
  %.275.i144.i.i = load double, ptr %scevgep403.i.i, align 8, !noalias !62
  %scevgep397.i.i = getelementptr i8, ptr %.944.i.i, i64 %196
  %scevgep398.i.i = getelementptr i8, ptr %scevgep397.i.i, i64 -4096
  %.305.i.i.i = load double, ptr %scevgep398.i.i, align 8, !noalias !62
  %.306.i.i.i = fmul contract double %.275.i144.i.i, %.305.i.i.i
  %.336.i.i.i = load double, ptr %scevgep402.i.i, align 8, !noalias !62
  %.366.i.i.i = load double, ptr %scevgep397.i.i, align 8, !noalias !62
  %.367.i.i.i = fmul contract double %.336.i.i.i, %.366.i.i.i
  %.368.i.i.i = fsub contract double %.306.i.i.i, %.367.i.i.i
  %.429.i.i201.i = fmul contract double %.275.i144.i.i, %.366.i.i.i
  %.490.i.i.i = fmul contract double %.305.i.i.i, %.336.i.i.i
  %.491.i.i.i = fadd contract double %.490.i.i.i, %.429.i.i201.i
  %scevgep74.i.i = getelementptr i8, ptr %.1785.i.i, i64 %196
  %.521.i.i.i = load double, ptr %scevgep74.i.i, align 8, !noalias !62
  %.522.i.i.i = fmul contract double %.521.i.i.i, %.368.i.i.i
  %scevgep73.i.i = getelementptr i8, ptr %.1856.i.i, i64 %196
  %.552.i.i.i = load double, ptr %scevgep73.i.i, align 8, !noalias !62
  %.553.i.i202.i = fmul contract double %.552.i.i.i, %.491.i.i.i
  %.554.i.i.i = fsub contract double %.522.i.i.i, %.553.i.i202.i
  %scevgep78.i.i = getelementptr i8, ptr %scevgep397.i.i, i64 -12288
  store double %.554.i.i.i, ptr %scevgep78.i.i, align 8, !noalias !62
  %.614.i.i.i = load double, ptr %scevgep74.i.i, align 8, !noalias !62
  %.615.i.i.i = fmul contract double %.491.i.i.i, %.614.i.i.i
  %.645.i.i203.i = load double, ptr %scevgep73.i.i, align 8, !noalias !62
  %.646.i.i204.i = fmul contract double %.368.i.i.i, %.645.i.i203.i
  %.647.i.i205.i = fadd contract double %.615.i.i.i, %.646.i.i204.i
  %scevgep76.i.i = getelementptr i8, ptr %scevgep397.i.i, i64 -8192
  store double %.647.i.i205.i, ptr %scevgep76.i.i, align 8, !noalias !62
  %exitcond.not.i152.i.i = icmp eq i64 %.13.i.i, %.221.i142.i.i
  br i1 %exitcond.not.i152.i.i, label %B1136.i.i, label %B56.if.i.i200.i

B642.if.i.i.i:                                    ; preds = %B642.if.i.i.i, %B642.if.i.preheader.i.i
  %.114610431045.i.i.i = phi i64 [ %.1153.i.i.i, %B642.if.i.i.i ], [ 0, %B642.if.i.preheader.i.i ]
  %.1153.i.i.i = add nuw nsw i64 %.114610431045.i.i.i, 1
  %197 = shl i64 %.114610431045.i.i.i, 3
  %scevgep390.i.i = getelementptr i8, ptr %lsr.iv.i154.i, i64 %197
  %scevgep391.i.i = getelementptr i8, ptr %scevgep390.i.i, i64 -4096
  %.1207.i.i.i = load double, ptr %scevgep391.i.i, align 8, !noalias !65
  %scevgep355.i.i = getelementptr i8, ptr %.944.i.i, i64 %197
  %scevgep356.i.i = getelementptr i8, ptr %scevgep355.i.i, i64 -4096
  %.1237.i.i.i = load double, ptr %scevgep356.i.i, align 8, !noalias !65
  %.1238.i.i.i = fmul contract double %.1207.i.i.i, %.1237.i.i.i
  %.1268.i.i.i = load double, ptr %scevgep390.i.i, align 8, !noalias !65
  %.1298.i.i.i = load double, ptr %scevgep355.i.i, align 8, !noalias !65
  %.1299.i.i.i = fmul contract double %.1268.i.i.i, %.1298.i.i.i
  %.1300.i.i.i = fsub contract double %.1238.i.i.i, %.1299.i.i.i
  %.1361.i.i.i = fmul contract double %.1207.i.i.i, %.1298.i.i.i
  %.1422.i.i.i = fmul contract double %.1237.i.i.i, %.1268.i.i.i
  %.1423.i.i.i = fadd contract double %.1422.i.i.i, %.1361.i.i.i
  %scevgep68.i.i = getelementptr i8, ptr %scevgep67.i.i, i64 %197
  %.1453.i.i.i = load double, ptr %scevgep68.i.i, align 8, !noalias !65
  %.1455.i.i.i = fmul contract double %.191.i.i156.i, %.1453.i.i.i
  %scevgep66.i.i = getelementptr i8, ptr %scevgep65.i.i, i64 %197
  %.1485.i.i.i = load double, ptr %scevgep66.i.i, align 8, !noalias !65
  %.1487.i.i.i = fmul contract double %.205.i.i.i, %.1485.i.i.i
  %.1488.i.i.i = fadd contract double %.1455.i.i.i, %.1487.i.i.i
  %scevgep64.i.i = getelementptr i8, ptr %scevgep63.i.i, i64 %197
  %.1518.i.i.i = load double, ptr %scevgep64.i.i, align 8, !noalias !65
  %.1520.i.i.i = fmul contract double %.217.i.i.i, %.1518.i.i.i
  %.1521.i.i.i = fadd contract double %.1488.i.i.i, %.1520.i.i.i
  %scevgep61.i.i = getelementptr i8, ptr %scevgep60.i.i, i64 %197
  %.1551.i.i.i = load double, ptr %scevgep61.i.i, align 8, !noalias !65
  %.1553.i.i.i = fmul contract double %.229.i.i.i, %.1551.i.i.i
  %.1554.i.i.i = fadd contract double %.1521.i.i.i, %.1553.i.i.i
  %scevgep59.i.i = getelementptr i8, ptr %scevgep58.i.i, i64 %197
  %.1584.i.i.i = load double, ptr %scevgep59.i.i, align 8, !noalias !65
  %.1586.i.i.i = fmul contract double %.243.i.i163.i, %.1584.i.i.i
  %.1587.i.i.i = fadd contract double %.1554.i.i.i, %.1586.i.i.i
  %scevgep57.i.i = getelementptr i8, ptr %scevgep56.i.i, i64 %197
  %.1617.i.i.i = load double, ptr %scevgep57.i.i, align 8, !noalias !65
  %.1619.i.i.i = fmul contract double %.251.i.i167.i, %.1617.i.i.i
  %.1620.i.i.i = fadd contract double %.1587.i.i.i, %.1619.i.i.i
  %scevgep54.i.i = getelementptr i8, ptr %scevgep52.i.i, i64 %197
  %.1650.i.i.i = load double, ptr %scevgep54.i.i, align 8, !noalias !65
  %.1652.i.i.i = fmul contract double %.191.i.i156.i, %.1650.i.i.i
  %scevgep50.i.i = getelementptr i8, ptr %scevgep46.i.i, i64 %197
  %.1682.i.i.i = load double, ptr %scevgep50.i.i, align 8, !noalias !65
  %.1684.i.i.i = fmul contract double %.205.i.i.i, %.1682.i.i.i
  %.1685.i.i.i = fadd contract double %.1652.i.i.i, %.1684.i.i.i
  %scevgep44.i.i = getelementptr i8, ptr %scevgep37.i.i, i64 %197
  %.1715.i.i.i = load double, ptr %scevgep44.i.i, align 8, !noalias !50
  %.1717.i.i.i = fmul contract double %.217.i.i.i, %.1715.i.i.i
  %.1718.i.i.i = fadd contract double %.1685.i.i.i, %.1717.i.i.i
  %scevgep23.i172.i = getelementptr i8, ptr %scevgep15.i.i, i64 %197
  %.1748.i.i.i = load double, ptr %scevgep23.i172.i, align 8, !noalias !50
  %.1750.i.i.i = fmul contract double %.229.i.i.i, %.1748.i.i.i
  %.1751.i.i.i = fadd contract double %.1718.i.i.i, %.1750.i.i.i
  %scevgep14.i173.i = getelementptr i8, ptr %scevgep13.i171.i, i64 %197
  %.1781.i.i.i = load double, ptr %scevgep14.i173.i, align 8, !noalias !50
  %.1783.i.i.i = fmul contract double %.243.i.i163.i, %.1781.i.i.i
  %.1784.i.i.i = fadd contract double %.1751.i.i.i, %.1783.i.i.i
  %scevgep12.i174.i = getelementptr i8, ptr %scevgep11.i170.i, i64 %197
  %.1814.i.i.i = load double, ptr %scevgep12.i174.i, align 8, !noalias !50
  %.1816.i.i.i = fmul contract double %.251.i.i167.i, %.1814.i.i.i
  %.1817.i.i.i = fadd contract double %.1784.i.i.i, %.1816.i.i.i
  %.1818.i.i.i = fmul contract double %.1300.i.i.i, %.1620.i.i.i
  %.1819.i.i.i = fmul contract double %.1423.i.i.i, %.1817.i.i.i
  %.1820.i.i.i = fsub contract double %.1818.i.i.i, %.1819.i.i.i
  %scevgep72.i.i = getelementptr i8, ptr %scevgep355.i.i, i64 -12288
  store double %.1820.i.i.i, ptr %scevgep72.i.i, align 8, !noalias !65
  %.1851.i.i.i = fmul contract double %.1423.i.i.i, %.1620.i.i.i
  %.1852.i.i.i = fmul contract double %.1300.i.i.i, %.1817.i.i.i
  %.1853.i.i.i = fadd contract double %.1851.i.i.i, %.1852.i.i.i
  %scevgep70.i.i = getelementptr i8, ptr %scevgep355.i.i, i64 -8192
  store double %.1853.i.i.i, ptr %scevgep70.i.i, align 8, !noalias !65
  %exitcond.not.i154.i.i = icmp eq i64 %.13.i.i, %.1153.i.i.i
  br i1 %exitcond.not.i154.i.i, label %B1136.i.i, label %B642.if.i.i.i

B104.if.i159.preheader.i.i:                       ; preds = %B104.if.i.i.i
  %198 = fadd contract double %.244.i.i179.i, %.279.i.i.i
  %199 = fadd contract double %.314.i.i.i, %.349.i.i.i
  %200 = fadd contract double %198, %199
  %201 = fadd contract double %.384.i.i186.i, %.419.i.i188.i
  %202 = fadd contract double %.454.i.i.i, %.489.i.i.i
  %203 = fadd contract double %201, %202
  %204 = fadd contract double %200, %203
  %.2222.i.i = fadd contract double %.2193.i.i, %204
  store double %.2222.i.i, ptr %184, align 8, !noalias !50
  %sunkaddr94.i.i = getelementptr i8, ptr %184, i64 8
  %.2289.i.i = load double, ptr %sunkaddr94.i.i, align 8, !noalias !50
  br label %B104.if.i159.i.i

B348.loopexit.i196.i.i:                           ; preds = %B104.if.i159.i.i
  %205 = fadd contract double %.244.i172.i.i, %.279.i175.i.i
  %206 = fadd contract double %.314.i178.i.i, %.349.i181.i.i
  %207 = fadd contract double %205, %206
  %208 = fadd contract double %.384.i184.i.i, %.419.i187.i.i
  %209 = fadd contract double %.454.i190.i.i, %.489.i192.i.i
  %210 = fadd contract double %208, %209
  %211 = fadd contract double %207, %210
  br label %B1136.endif.endif.i.i

B104.if.i159.i.i:                                 ; preds = %B104.if.i159.i.i, %B104.if.i159.preheader.i.i
  %lsr.iv9.i160.i.i = phi i64 [ %lsr.iv.next.i194.i.i, %B104.if.i159.i.i ], [ %.60.1.i.i.i, %B104.if.i159.preheader.i.i ]
  %lsr.iv.i161.i.i = phi ptr [ %scevgep1.i193.i.i, %B104.if.i159.i.i ], [ %scevgep.i158.i.i, %B104.if.i159.preheader.i.i ]
  %s7.2.0168.i162.i.i = phi double [ %.489.i192.i.i, %B104.if.i159.i.i ], [ 0.000000e+00, %B104.if.i159.preheader.i.i ]
  %s6.2.0167.i163.i.i = phi double [ %.454.i190.i.i, %B104.if.i159.i.i ], [ 0.000000e+00, %B104.if.i159.preheader.i.i ]
  %s5.2.0166.i164.i.i = phi double [ %.419.i187.i.i, %B104.if.i159.i.i ], [ 0.000000e+00, %B104.if.i159.preheader.i.i ]
  %s4.2.0165.i165.i.i = phi double [ %.384.i184.i.i, %B104.if.i159.i.i ], [ 0.000000e+00, %B104.if.i159.preheader.i.i ]
  %s3.2.0164.i166.i.i = phi double [ %.349.i181.i.i, %B104.if.i159.i.i ], [ 0.000000e+00, %B104.if.i159.preheader.i.i ]
  %s2.2.0163.i167.i.i = phi double [ %.314.i178.i.i, %B104.if.i159.i.i ], [ 0.000000e+00, %B104.if.i159.preheader.i.i ]
  %s1.2.0162.i168.i.i = phi double [ %.279.i175.i.i, %B104.if.i159.i.i ], [ 0.000000e+00, %B104.if.i159.preheader.i.i ]
  %s0.2.0161.i169.i.i = phi double [ %.244.i172.i.i, %B104.if.i159.i.i ], [ 0.000000e+00, %B104.if.i159.preheader.i.i ]
  %scevgep2.i170.i.i = getelementptr i8, ptr %lsr.iv.i161.i.i, i64 -56
  %.242.i171.i.i = load double, ptr %scevgep2.i170.i.i, align 8, !noalias !68
  %.244.i172.i.i = fadd contract double %s0.2.0161.i169.i.i, %.242.i171.i.i
  %scevgep3.i173.i.i = getelementptr i8, ptr %lsr.iv.i161.i.i, i64 -48
  %.277.i174.i.i = load double, ptr %scevgep3.i173.i.i, align 8, !noalias !68
  %.279.i175.i.i = fadd contract double %s1.2.0162.i168.i.i, %.277.i174.i.i
  %scevgep4.i176.i.i = getelementptr i8, ptr %lsr.iv.i161.i.i, i64 -40
  %.312.i177.i.i = load double, ptr %scevgep4.i176.i.i, align 8, !noalias !68
  %.314.i178.i.i = fadd contract double %s2.2.0163.i167.i.i, %.312.i177.i.i
  %scevgep5.i179.i.i = getelementptr i8, ptr %lsr.iv.i161.i.i, i64 -32
  %.347.i180.i.i = load double, ptr %scevgep5.i179.i.i, align 8, !noalias !68
  %.349.i181.i.i = fadd contract double %s3.2.0164.i166.i.i, %.347.i180.i.i
  %scevgep6.i182.i.i = getelementptr i8, ptr %lsr.iv.i161.i.i, i64 -24
  %.382.i183.i.i = load double, ptr %scevgep6.i182.i.i, align 8, !noalias !68
  %.384.i184.i.i = fadd contract double %s4.2.0165.i165.i.i, %.382.i183.i.i
  %scevgep7.i185.i.i = getelementptr i8, ptr %lsr.iv.i161.i.i, i64 -16
  %.417.i186.i.i = load double, ptr %scevgep7.i185.i.i, align 8, !noalias !68
  %.419.i187.i.i = fadd contract double %s5.2.0166.i164.i.i, %.417.i186.i.i
  %scevgep8.i188.i.i = getelementptr i8, ptr %lsr.iv.i161.i.i, i64 -8
  %.452.i189.i.i = load double, ptr %scevgep8.i188.i.i, align 8, !noalias !68
  %.454.i190.i.i = fadd contract double %s6.2.0167.i163.i.i, %.452.i189.i.i
  %.487.i191.i.i = load double, ptr %lsr.iv.i161.i.i, align 8, !noalias !68
  %.489.i192.i.i = fadd contract double %s7.2.0168.i162.i.i, %.487.i191.i.i
  %scevgep1.i193.i.i = getelementptr i8, ptr %lsr.iv.i161.i.i, i64 64
  %lsr.iv.next.i194.i.i = add nsw i64 %lsr.iv9.i160.i.i, -1
  %exitcond.not.i195.i.i = icmp eq i64 %lsr.iv.next.i194.i.i, 0
  br i1 %exitcond.not.i195.i.i, label %B348.loopexit.i196.i.i, label %B104.if.i159.i.i

B1136.endif.endif.i.i:                            ; preds = %B348.loopexit.i196.i.i, %B1136.endif.thread.i.i
  %.22898.i.i = phi double [ %.22897.i.i, %B1136.endif.thread.i.i ], [ %.2289.i.i, %B348.loopexit.i196.i.i ]
  %s0.2.0.lcssa.i197.i.i = phi double [ 0.000000e+00, %B1136.endif.thread.i.i ], [ %211, %B348.loopexit.i196.i.i ]
  %.2318.i.i = fadd contract double %.22898.i.i, %s0.2.0.lcssa.i197.i.i
  %sunkaddr97.i.i = getelementptr i8, ptr %184, i64 8
  store double %.2318.i.i, ptr %sunkaddr97.i.i, align 8, !noalias !50
  br i1 %195, label %B1312.i.i, label %B1538.i.i

B62.if.preheader.i.i.i:                           ; preds = %B1312.i.i
  %.2452.i.i = add nsw i64 %.135212881302.i.i, %.2450.i.i
  %.2456.i.i = mul nsw i64 %.2452.i.i, %.109.i122.i
  %.2458.i192.i = add nsw i64 %.2456.i.i, %.213211001120.i
  %.2459.i193.i = shl nsw i64 %.2458.i192.i, 4
  %.2460.i.i = add nsw i64 %.2383.i.i, %.2459.i193.i
  %.2464.i.i = inttoptr i64 %.2460.i.i to ptr
  %scevgep.i204.i.i = getelementptr i8, ptr %.2464.i.i, i64 8
  br label %B62.if.i.i.i

B62.if.i.i.i:                                     ; preds = %B62.if.i.i.i, %B62.if.preheader.i.i.i
  %lsr.iv.i205.i.i = phi ptr [ %scevgep.i204.i.i, %B62.if.preheader.i.i.i ], [ %scevgep1.i212.i.i, %B62.if.i.i.i ]
  %.190171173.i.i.i = phi i64 [ 0, %B62.if.preheader.i.i.i ], [ %.197.i206.i.i, %B62.if.i.i.i ]
  %.197.i206.i.i = add nuw nsw i64 %.190171173.i.i.i, 1
  %scevgep2.i207.i.i = getelementptr i8, ptr %lsr.iv.i205.i.i, i64 -8
  %.252.i208.i.i = load double, ptr %scevgep2.i207.i.i, align 8, !noalias !71
  %sunkaddr72.i.i = shl i64 %.190171173.i.i.i, 3
  %scevgep80.i.i = getelementptr i8, ptr %scevgep79.i.i, i64 %sunkaddr72.i.i
  %scevgep81.i.i = getelementptr i8, ptr %scevgep80.i.i, i64 -4096
  %.282.i.i.i = load double, ptr %scevgep81.i.i, align 8, !noalias !71
  %.314.i211.i.i = load double, ptr %scevgep80.i.i, align 8, !noalias !71
  %.316.i.i.i = fmul contract double %.314.i211.i.i, 0.000000e+00
  %.317.i.i194.i = fsub contract double %.282.i.i.i, %.316.i.i.i
  %.318.i.i.i = fadd contract double %.252.i208.i.i, %.317.i.i194.i
  store double %.318.i.i.i, ptr %scevgep2.i207.i.i, align 8, !noalias !71
  %.380.i.i195.i = load double, ptr %lsr.iv.i205.i.i, align 8, !noalias !71
  %.410.i.i196.i = load double, ptr %scevgep80.i.i, align 8, !noalias !71
  %.442.i.i197.i = load double, ptr %scevgep81.i.i, align 8, !noalias !71
  %.444.i.i198.i = fmul contract double %.442.i.i197.i, 0.000000e+00
  %.445.i.i199.i = fadd contract double %.410.i.i196.i, %.444.i.i198.i
  %.446.i.i.i = fadd contract double %.380.i.i195.i, %.445.i.i199.i
  store double %.446.i.i.i, ptr %lsr.iv.i205.i.i, align 8, !noalias !71
  %scevgep1.i212.i.i = getelementptr i8, ptr %lsr.iv.i205.i.i, i64 16
  %exitcond.not.i213.i.i = icmp eq i64 %.13.i.i127.i, %.197.i206.i.i
  br i1 %exitcond.not.i213.i.i, label %B1538.i.i, label %B62.if.i.i.i

_ZN17bnserve_inference12modes_kernel7_source13_add_productsB4v129B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxx5ArrayIxLi1E1C7mutable7alignedEdd5ArrayIdLi1E1C7mutable7alignedE.exit.i: ; preds = %B634.loopexit.i.i, %_ZN17bnserve_inference13moving_kernel7_source8_respondB3v89B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i
  %.71.i.i = load i64, ptr %.76.i, align 8, !noalias !74
  %.186.i.i = add nsw i64 %.71.i.i, 1
  %.188.i.i = mul nsw i64 %.186.i.i, %.71.i.i
  %.268.i.i = and i64 %.188.i.i, -2
  %.345.idx.i.i = shl i64 %.71.i.i, 13
  %.345.i.i = getelementptr i8, ptr %.289.i, i64 %.345.idx.i.i
  %.413.i206.i = getelementptr i8, ptr %.345.i.i, i64 4096
  %.651938.not.i.i = icmp slt i64 %.71.i.i, 1
  br i1 %.651938.not.i.i, label %_ZN17bnserve_inference12modes_kernel7_source10_add_pairsB4v169B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i, label %B324.if.lr.ph.i.i

B860.i261.i:                                      ; preds = %B606.endif.endif.endif.endif.endif.i.i
  %.660.i.i = add nsw i64 %.650895942.i.i, -1
  %.664.i262.i = add nuw nsw i64 %.657905941.i.i, 1
  %exitcond1049.not.i.i = icmp eq i64 %.664.i262.i, %.71.i.i
  br i1 %exitcond1049.not.i.i, label %_ZN17bnserve_inference12modes_kernel7_source10_add_pairsB4v169B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i, label %B324.if.i.i

B324.if.lr.ph.i.i:                                ; preds = %_ZN17bnserve_inference12modes_kernel7_source13_add_productsB4v129B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxx5ArrayIxLi1E1C7mutable7alignedEdd5ArrayIdLi1E1C7mutable7alignedE.exit.i
  %.181.i207.i = load i64, ptr %sunkaddr88.i.i, align 8, !noalias !74
  %.196.1.i.i = lshr i64 %.188.i.i, 1
  %.265.i208.i = mul i64 %.196.1.i.i, %.548.i123.i
  %.262.i.i = load i64, ptr %sunkaddr134.i, align 8, !noalias !74
  %.266.i.i = add nsw i64 %.262.i.i, %.265.i208.i
  %.102.i.i = load i64, ptr %.106.i, align 8, !noalias !74
  %.103.i.i = sub i64 0, %.102.i.i
  %.111.1.i.i = and i64 %.103.i.i, -8
  %.145.i.i = sub i64 0, %.111.1.i.i
  %.1298.i.i = icmp eq i64 %.181.i207.i, 1
  %.1308.i.i = shl nsw i64 %.145.i.i, 1
  %.1311.i.i = mul nuw nsw i64 %.196.1.i.i, %.232410861091.i
  %.1302.i.i = mul nsw i64 %.232410861091.i, %.145.i.i
  %.1420.i210.i = select i1 %.1298.i.i, i64 0, i64 %.111.1.i.i
  %"$phi606.2.2.2.i.i" = sub i64 %.213211001120.i, %.1420.i210.i
  %scevgep.i.i212.i = getelementptr i8, ptr %.345.i.i, i64 56
  %scevgep.i104.i.i = getelementptr i8, ptr %.345.i.i, i64 4152
  %212 = inttoptr i64 %.266.i.i to ptr
  br label %B324.if.i.i

B324.if.i.i:                                      ; preds = %B324.if.lr.ph.i.i, %B860.i261.i
  %at.3.0943.i.i = phi i64 [ 0, %B324.if.lr.ph.i.i ], [ %.1807.i.i, %B860.i261.i ]
  %.650895942.i.i = phi i64 [ %.71.i.i, %B324.if.lr.ph.i.i ], [ %.660.i.i, %B860.i261.i ]
  %.657905941.i.i = phi i64 [ 0, %B324.if.lr.ph.i.i ], [ %.664.i262.i, %B860.i261.i ]
  %smax.i.i = tail call i64 @llvm.smax.i64(i64 %.650895942.i.i, i64 0)
  %.714.idx.i.i = shl i64 %.657905941.i.i, 13
  %.714.i.i = getelementptr i8, ptr %.289.i, i64 %.714.idx.i.i
  %.782.i.i = getelementptr i8, ptr %.714.i.i, i64 4096
  %213 = add i64 %smax.i.i, %at.3.0943.i.i
  br label %B404.if.i.i

B404.if.i.i:                                      ; preds = %B606.endif.endif.endif.endif.endif.i.i, %B324.if.i.i
  %at.2.1892.i.i = phi i64 [ %.1807.i.i, %B606.endif.endif.endif.endif.endif.i.i ], [ %at.3.0943.i.i, %B324.if.i.i ]
  %.1023881890.i.i = phi i64 [ %.1030.i.i, %B606.endif.endif.endif.endif.endif.i.i ], [ %.657905941.i.i, %B324.if.i.i ]
  %.1030.i.i = add nuw i64 %.1023881890.i.i, 1
  %.1074.idx.i.i = shl i64 %.1023881890.i.i, 13
  %.1074.i.i = getelementptr i8, ptr %.289.i, i64 %.1074.idx.i.i
  %.1142.i.i = getelementptr i8, ptr %.1074.i.i, i64 4096
  %.1313.i.i = add nsw i64 %at.2.1892.i.i, %.1311.i.i
  %.1314.i.i = mul nsw i64 %.1308.i.i, %.1313.i.i
  %"$phi498.2.2.2.i.i" = select i1 %.1298.i.i, i64 %.1302.i.i, i64 %.1314.i.i
  %.1351.i.i = load i64, ptr %sunkaddr.i213.i, align 8, !noalias !74
  %.1352.i.i = shl nsw i64 %"$phi498.2.2.2.i.i", 3
  %.1353.i.i = add nsw i64 %.1352.i.i, %.1351.i.i
  %.1356.i.i = inttoptr i64 %.1353.i.i to ptr
  %.1441.i.i = getelementptr inbounds double, ptr %.1356.i.i, i64 %.213211001120.i
  %.1509.i.i = getelementptr inbounds double, ptr %.1356.i.i, i64 %"$phi606.2.2.2.i.i"
  br i1 %.1298.i.i, label %B16.i.i.i, label %B266.i.i.i

B16.i.i.i:                                        ; preds = %B404.if.i.i
  br i1 %135, label %_ZN17bnserve_inference12modes_kernel7_source5_pairB4v184B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i.i, label %B68.if.i.i.i

B266.i.i.i:                                       ; preds = %B404.if.i.i
  br i1 %135, label %_ZN17bnserve_inference12modes_kernel7_source5_pairB4v184B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i.i, label %B318.if.i.i.i

B68.if.i.i.i:                                     ; preds = %B16.i.i.i, %B68.if.i.i.i
  %.222581583.i.i.i = phi i64 [ %.229.i.i263.i, %B68.if.i.i.i ], [ 0, %B16.i.i.i ]
  %.229.i.i263.i = add nuw nsw i64 %.222581583.i.i.i, 1
  %214 = shl i64 %.222581583.i.i.i, 3
  %scevgep6.i2.i.i = getelementptr i8, ptr %.1441.i.i, i64 %214
  %.283.i.i.i = load double, ptr %scevgep6.i2.i.i, align 8, !noalias !77
  %scevgep5.i3.i.i = getelementptr i8, ptr %.714.i.i, i64 %214
  %.313.i.i.i = load double, ptr %scevgep5.i3.i.i, align 8, !noalias !77
  %scevgep4.i4.i.i = getelementptr i8, ptr %.1074.i.i, i64 %214
  %.343.i.i264.i = load double, ptr %scevgep4.i4.i.i, align 8, !noalias !77
  %.344.i.i.i = fmul contract double %.313.i.i.i, %.343.i.i264.i
  %scevgep18.i.i.i = getelementptr i8, ptr %.782.i.i, i64 %214
  %.374.i.i.i = load double, ptr %scevgep18.i.i.i, align 8, !noalias !77
  %scevgep17.i.i.i = getelementptr i8, ptr %.1142.i.i, i64 %214
  %.404.i.i265.i = load double, ptr %scevgep17.i.i.i, align 8, !noalias !77
  %.405.i.i.i = fmul contract double %.374.i.i.i, %.404.i.i265.i
  %.406.i.i266.i = fadd contract double %.344.i.i.i, %.405.i.i.i
  %.407.i.i267.i = fmul contract double %.283.i.i.i, %.406.i.i266.i
  %scevgep16.i.i.i = getelementptr i8, ptr %.345.i.i, i64 %214
  store double %.407.i.i267.i, ptr %scevgep16.i.i.i, align 8, !noalias !77
  %.467.i.i.i = load double, ptr %scevgep6.i2.i.i, align 8, !noalias !77
  %.497.i.i268.i = load double, ptr %scevgep5.i3.i.i, align 8, !noalias !77
  %.528.i.i.i = fmul contract double %.404.i.i265.i, %.497.i.i268.i
  %.588.i.i.i = load double, ptr %scevgep4.i4.i.i, align 8, !noalias !77
  %.589.i.i.i = fmul contract double %.374.i.i.i, %.588.i.i.i
  %.590.i.i.i = fsub contract double %.528.i.i.i, %.589.i.i.i
  %.591.i.i.i = fmul contract double %.467.i.i.i, %.590.i.i.i
  %scevgep.i5.i.i = getelementptr i8, ptr %.413.i206.i, i64 %214
  store double %.591.i.i.i, ptr %scevgep.i5.i.i, align 8, !noalias !77
  %exitcond587.not.i.i.i = icmp eq i64 %.13.i.i, %.229.i.i263.i
  br i1 %exitcond587.not.i.i.i, label %_ZN17bnserve_inference12modes_kernel7_source5_pairB4v184B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i.i, label %B68.if.i.i.i

B318.if.i.i.i:                                    ; preds = %B266.i.i.i, %B318.if.i.i.i
  %.760575577.i.i.i = phi i64 [ %.767.i.i.i, %B318.if.i.i.i ], [ 0, %B266.i.i.i ]
  %.767.i.i.i = add nuw nsw i64 %.760575577.i.i.i, 1
  %215 = shl i64 %.760575577.i.i.i, 3
  %scevgep14.i.i214.i = getelementptr i8, ptr %.714.i.i, i64 %215
  %.821.i.i215.i = load double, ptr %scevgep14.i.i214.i, align 8, !noalias !77
  %scevgep13.i.i.i = getelementptr i8, ptr %.1074.i.i, i64 %215
  %.851.i.i.i = load double, ptr %scevgep13.i.i.i, align 8, !noalias !77
  %.852.i.i.i = fmul contract double %.821.i.i215.i, %.851.i.i.i
  %scevgep24.i.i.i = getelementptr i8, ptr %.782.i.i, i64 %215
  %.882.i.i.i = load double, ptr %scevgep24.i.i.i, align 8, !noalias !77
  %scevgep23.i.i.i = getelementptr i8, ptr %.1142.i.i, i64 %215
  %.912.i.i.i = load double, ptr %scevgep23.i.i.i, align 8, !noalias !77
  %.913.i.i216.i = fmul contract double %.882.i.i.i, %.912.i.i.i
  %.914.i.i217.i = fadd contract double %.852.i.i.i, %.913.i.i216.i
  %.975.i.i.i = fmul contract double %.821.i.i215.i, %.912.i.i.i
  %.1036.i.i.i = fmul contract double %.851.i.i.i, %.882.i.i.i
  %.1037.i.i.i = fsub contract double %.975.i.i.i, %.1036.i.i.i
  %scevgep22.i.i218.i = getelementptr i8, ptr %.1441.i.i, i64 %215
  %.1067.i.i.i = load double, ptr %scevgep22.i.i218.i, align 8, !noalias !77
  %.1068.i.i.i = fmul contract double %.1067.i.i.i, %.914.i.i217.i
  %scevgep21.i.i219.i = getelementptr i8, ptr %.1509.i.i, i64 %215
  %.1098.i.i.i = load double, ptr %scevgep21.i.i219.i, align 8, !noalias !77
  %.1099.i.i.i = fmul contract double %.1098.i.i.i, %.1037.i.i.i
  %.1100.i.i.i = fsub contract double %.1068.i.i.i, %.1099.i.i.i
  %scevgep20.i.i220.i = getelementptr i8, ptr %.345.i.i, i64 %215
  store double %.1100.i.i.i, ptr %scevgep20.i.i220.i, align 8, !noalias !77
  %.1160.i.i.i = load double, ptr %scevgep22.i.i218.i, align 8, !noalias !77
  %.1161.i.i.i = fmul contract double %.1037.i.i.i, %.1160.i.i.i
  %.1191.i.i.i = load double, ptr %scevgep21.i.i219.i, align 8, !noalias !77
  %.1192.i.i.i = fmul contract double %.914.i.i217.i, %.1191.i.i.i
  %.1193.i.i.i = fadd contract double %.1161.i.i.i, %.1192.i.i.i
  %scevgep19.i.i221.i = getelementptr i8, ptr %.413.i206.i, i64 %215
  store double %.1193.i.i.i, ptr %scevgep19.i.i221.i, align 8, !noalias !77
  %exitcond.not.i1.i.i = icmp eq i64 %.13.i.i, %.767.i.i.i
  br i1 %exitcond.not.i1.i.i, label %_ZN17bnserve_inference12modes_kernel7_source5_pairB4v184B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i.i, label %B318.if.i.i.i

_ZN17bnserve_inference12modes_kernel7_source5_pairB4v184B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i.i: ; preds = %B318.if.i.i.i, %B68.if.i.i.i, %B266.i.i.i, %B16.i.i.i
  %.1638.i.i = icmp slt i64 %at.2.1892.i.i, 0
  %.1639.i.i = select i1 %.1638.i.i, i64 %.268.i.i, i64 0
  %.idx.i222.i = shl i64 %at.2.1892.i.i, 4
  %216 = getelementptr i8, ptr %212, i64 %.idx.i222.i
  %.1653.i.i = getelementptr double, ptr %216, i64 %.1639.i.i
  %.1654.i.i = load double, ptr %.1653.i.i, align 8, !noalias !74
  br i1 %140, label %B606.endif.endif.endif.endif.thread.i.i, label %B104.if.i.i223.i

B606.endif.endif.endif.endif.thread.i.i:          ; preds = %_ZN17bnserve_inference12modes_kernel7_source5_pairB4v184B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i.i
  %.16833.i.i = fadd contract double %.1654.i.i, 0.000000e+00
  %sunkaddr2384.i.i = shl i64 %.1639.i.i, 3
  %sunkaddr2395.i.i = getelementptr i8, ptr %216, i64 %sunkaddr2384.i.i
  store double %.16833.i.i, ptr %sunkaddr2395.i.i, align 8, !noalias !74
  %217 = getelementptr i8, ptr %216, i64 8
  %.17456.i.i = getelementptr double, ptr %217, i64 %.1639.i.i
  %.17467.i.i = load double, ptr %.17456.i.i, align 8, !noalias !74
  br label %B606.endif.endif.endif.endif.endif.i.i

B104.if.i.i223.i:                                 ; preds = %_ZN17bnserve_inference12modes_kernel7_source5_pairB4v184B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i.i, %B104.if.i.i223.i
  %lsr.iv9.i.i224.i = phi i64 [ %lsr.iv.next.i.i258.i, %B104.if.i.i223.i ], [ %.60.1.i.i.i, %_ZN17bnserve_inference12modes_kernel7_source5_pairB4v184B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i.i ]
  %lsr.iv.i.i225.i = phi ptr [ %scevgep1.i.i257.i, %B104.if.i.i223.i ], [ %scevgep.i.i212.i, %_ZN17bnserve_inference12modes_kernel7_source5_pairB4v184B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i.i ]
  %s7.2.0168.i.i226.i = phi double [ %.489.i.i256.i, %B104.if.i.i223.i ], [ 0.000000e+00, %_ZN17bnserve_inference12modes_kernel7_source5_pairB4v184B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i.i ]
  %s6.2.0167.i.i227.i = phi double [ %.454.i.i254.i, %B104.if.i.i223.i ], [ 0.000000e+00, %_ZN17bnserve_inference12modes_kernel7_source5_pairB4v184B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i.i ]
  %s5.2.0166.i.i228.i = phi double [ %.419.i.i251.i, %B104.if.i.i223.i ], [ 0.000000e+00, %_ZN17bnserve_inference12modes_kernel7_source5_pairB4v184B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i.i ]
  %s4.2.0165.i.i229.i = phi double [ %.384.i.i248.i, %B104.if.i.i223.i ], [ 0.000000e+00, %_ZN17bnserve_inference12modes_kernel7_source5_pairB4v184B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i.i ]
  %s3.2.0164.i.i230.i = phi double [ %.349.i.i245.i, %B104.if.i.i223.i ], [ 0.000000e+00, %_ZN17bnserve_inference12modes_kernel7_source5_pairB4v184B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i.i ]
  %s2.2.0163.i.i231.i = phi double [ %.314.i.i242.i, %B104.if.i.i223.i ], [ 0.000000e+00, %_ZN17bnserve_inference12modes_kernel7_source5_pairB4v184B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i.i ]
  %s1.2.0162.i.i232.i = phi double [ %.279.i.i239.i, %B104.if.i.i223.i ], [ 0.000000e+00, %_ZN17bnserve_inference12modes_kernel7_source5_pairB4v184B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i.i ]
  %s0.2.0161.i.i233.i = phi double [ %.244.i.i236.i, %B104.if.i.i223.i ], [ 0.000000e+00, %_ZN17bnserve_inference12modes_kernel7_source5_pairB4v184B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i.i ]
  %scevgep2.i.i234.i = getelementptr i8, ptr %lsr.iv.i.i225.i, i64 -56
  %.242.i.i235.i = load double, ptr %scevgep2.i.i234.i, align 8, !noalias !80
  %.244.i.i236.i = fadd contract double %s0.2.0161.i.i233.i, %.242.i.i235.i
  %scevgep3.i.i237.i = getelementptr i8, ptr %lsr.iv.i.i225.i, i64 -48
  %.277.i.i238.i = load double, ptr %scevgep3.i.i237.i, align 8, !noalias !80
  %.279.i.i239.i = fadd contract double %s1.2.0162.i.i232.i, %.277.i.i238.i
  %scevgep4.i.i240.i = getelementptr i8, ptr %lsr.iv.i.i225.i, i64 -40
  %.312.i.i241.i = load double, ptr %scevgep4.i.i240.i, align 8, !noalias !80
  %.314.i.i242.i = fadd contract double %s2.2.0163.i.i231.i, %.312.i.i241.i
  %scevgep5.i.i243.i = getelementptr i8, ptr %lsr.iv.i.i225.i, i64 -32
  %.347.i.i244.i = load double, ptr %scevgep5.i.i243.i, align 8, !noalias !80
  %.349.i.i245.i = fadd contract double %s3.2.0164.i.i230.i, %.347.i.i244.i
  %scevgep6.i.i246.i = getelementptr i8, ptr %lsr.iv.i.i225.i, i64 -24
  %.382.i.i247.i = load double, ptr %scevgep6.i.i246.i, align 8, !noalias !80
  %.384.i.i248.i = fadd contract double %s4.2.0165.i.i229.i, %.382.i.i247.i
  %scevgep7.i.i249.i = getelementptr i8, ptr %lsr.iv.i.i225.i, i64 -16
  %.417.i.i250.i = load double, ptr %scevgep7.i.i249.i, align 8, !noalias !80
  %.419.i.i251.i = fadd contract double %s5.2.0166.i.i228.i, %.417.i.i250.i
  %scevgep8.i.i252.i = getelementptr i8, ptr %lsr.iv.i.i225.i, i64 -8
  %.452.i.i253.i = load double, ptr %scevgep8.i.i252.i, align 8, !noalias !80
  %.454.i.i254.i = fadd contract double %s6.2.0167.i.i227.i, %.452.i.i253.i
  %.487.i.i255.i = load double, ptr %lsr.iv.i.i225.i, align 8, !noalias !80
  %.489.i.i256.i = fadd contract double %s7.2.0168.i.i226.i, %.487.i.i255.i
  %scevgep1.i.i257.i = getelementptr i8, ptr %lsr.iv.i.i225.i, i64 64
  %lsr.iv.next.i.i258.i = add nsw i64 %lsr.iv9.i.i224.i, -1
  %exitcond.not.i.i259.i = icmp eq i64 %lsr.iv.next.i.i258.i, 0
  br i1 %exitcond.not.i.i259.i, label %B104.if.i105.preheader.i.i, label %B104.if.i.i223.i

B104.if.i105.preheader.i.i:                       ; preds = %B104.if.i.i223.i
  %218 = fadd contract double %.244.i.i236.i, %.279.i.i239.i
  %219 = fadd contract double %.314.i.i242.i, %.349.i.i245.i
  %220 = fadd contract double %218, %219
  %221 = fadd contract double %.384.i.i248.i, %.419.i.i251.i
  %222 = fadd contract double %.454.i.i254.i, %.489.i.i256.i
  %223 = fadd contract double %221, %222
  %224 = fadd contract double %220, %223
  %.1683.i.i = fadd contract double %.1654.i.i, %224
  %sunkaddr238.i.i = shl i64 %.1639.i.i, 3
  %sunkaddr239.i.i = getelementptr i8, ptr %216, i64 %sunkaddr238.i.i
  store double %.1683.i.i, ptr %sunkaddr239.i.i, align 8, !noalias !74
  %225 = getelementptr i8, ptr %216, i64 8
  %.1745.i.i = getelementptr double, ptr %225, i64 %.1639.i.i
  %.1746.i.i = load double, ptr %.1745.i.i, align 8, !noalias !74
  br label %B104.if.i105.i.i

B348.loopexit.i142.i.i:                           ; preds = %B104.if.i105.i.i
  %226 = fadd contract double %.244.i118.i.i, %.279.i121.i.i
  %227 = fadd contract double %.314.i124.i.i, %.349.i127.i.i
  %228 = fadd contract double %226, %227
  %229 = fadd contract double %.384.i130.i.i, %.419.i133.i.i
  %230 = fadd contract double %.454.i136.i.i, %.489.i138.i.i
  %231 = fadd contract double %229, %230
  %232 = fadd contract double %228, %231
  br label %B606.endif.endif.endif.endif.endif.i.i

B104.if.i105.i.i:                                 ; preds = %B104.if.i105.i.i, %B104.if.i105.preheader.i.i
  %lsr.iv9.i106.i.i = phi i64 [ %lsr.iv.next.i140.i.i, %B104.if.i105.i.i ], [ %.60.1.i.i.i, %B104.if.i105.preheader.i.i ]
  %lsr.iv.i107.i.i = phi ptr [ %scevgep1.i139.i.i, %B104.if.i105.i.i ], [ %scevgep.i104.i.i, %B104.if.i105.preheader.i.i ]
  %s7.2.0168.i108.i.i = phi double [ %.489.i138.i.i, %B104.if.i105.i.i ], [ 0.000000e+00, %B104.if.i105.preheader.i.i ]
  %s6.2.0167.i109.i.i = phi double [ %.454.i136.i.i, %B104.if.i105.i.i ], [ 0.000000e+00, %B104.if.i105.preheader.i.i ]
  %s5.2.0166.i110.i.i = phi double [ %.419.i133.i.i, %B104.if.i105.i.i ], [ 0.000000e+00, %B104.if.i105.preheader.i.i ]
  %s4.2.0165.i111.i.i = phi double [ %.384.i130.i.i, %B104.if.i105.i.i ], [ 0.000000e+00, %B104.if.i105.preheader.i.i ]
  %s3.2.0164.i112.i.i = phi double [ %.349.i127.i.i, %B104.if.i105.i.i ], [ 0.000000e+00, %B104.if.i105.preheader.i.i ]
  %s2.2.0163.i113.i.i = phi double [ %.314.i124.i.i, %B104.if.i105.i.i ], [ 0.000000e+00, %B104.if.i105.preheader.i.i ]
  %s1.2.0162.i114.i.i = phi double [ %.279.i121.i.i, %B104.if.i105.i.i ], [ 0.000000e+00, %B104.if.i105.preheader.i.i ]
  %s0.2.0161.i115.i.i = phi double [ %.244.i118.i.i, %B104.if.i105.i.i ], [ 0.000000e+00, %B104.if.i105.preheader.i.i ]
  %scevgep2.i116.i.i = getelementptr i8, ptr %lsr.iv.i107.i.i, i64 -56
  %.242.i117.i.i = load double, ptr %scevgep2.i116.i.i, align 8, !noalias !83
  %.244.i118.i.i = fadd contract double %s0.2.0161.i115.i.i, %.242.i117.i.i
  %scevgep3.i119.i.i = getelementptr i8, ptr %lsr.iv.i107.i.i, i64 -48
  %.277.i120.i.i = load double, ptr %scevgep3.i119.i.i, align 8, !noalias !83
  %.279.i121.i.i = fadd contract double %s1.2.0162.i114.i.i, %.277.i120.i.i
  %scevgep4.i122.i.i = getelementptr i8, ptr %lsr.iv.i107.i.i, i64 -40
  %.312.i123.i.i = load double, ptr %scevgep4.i122.i.i, align 8, !noalias !83
  %.314.i124.i.i = fadd contract double %s2.2.0163.i113.i.i, %.312.i123.i.i
  %scevgep5.i125.i.i = getelementptr i8, ptr %lsr.iv.i107.i.i, i64 -32
  %.347.i126.i.i = load double, ptr %scevgep5.i125.i.i, align 8, !noalias !83
  %.349.i127.i.i = fadd contract double %s3.2.0164.i112.i.i, %.347.i126.i.i
  %scevgep6.i128.i.i = getelementptr i8, ptr %lsr.iv.i107.i.i, i64 -24
  %.382.i129.i.i = load double, ptr %scevgep6.i128.i.i, align 8, !noalias !83
  %.384.i130.i.i = fadd contract double %s4.2.0165.i111.i.i, %.382.i129.i.i
  %scevgep7.i131.i.i = getelementptr i8, ptr %lsr.iv.i107.i.i, i64 -16
  %.417.i132.i.i = load double, ptr %scevgep7.i131.i.i, align 8, !noalias !83
  %.419.i133.i.i = fadd contract double %s5.2.0166.i110.i.i, %.417.i132.i.i
  %scevgep8.i134.i.i = getelementptr i8, ptr %lsr.iv.i107.i.i, i64 -8
  %.452.i135.i.i = load double, ptr %scevgep8.i134.i.i, align 8, !noalias !83
  %.454.i136.i.i = fadd contract double %s6.2.0167.i109.i.i, %.452.i135.i.i
  %.487.i137.i.i = load double, ptr %lsr.iv.i107.i.i, align 8, !noalias !83
  %.489.i138.i.i = fadd contract double %s7.2.0168.i108.i.i, %.487.i137.i.i
  %scevgep1.i139.i.i = getelementptr i8, ptr %lsr.iv.i107.i.i, i64 64
  %lsr.iv.next.i140.i.i = add nsw i64 %lsr.iv9.i106.i.i, -1
  %exitcond.not.i141.i.i = icmp eq i64 %lsr.iv.next.i140.i.i, 0
  br i1 %exitcond.not.i141.i.i, label %B348.loopexit.i142.i.i, label %B104.if.i105.i.i

B606.endif.endif.endif.endif.endif.i.i:           ; preds = %B348.loopexit.i142.i.i, %B606.endif.endif.endif.endif.thread.i.i
  %.17468.i.i = phi double [ %.17467.i.i, %B606.endif.endif.endif.endif.thread.i.i ], [ %.1746.i.i, %B348.loopexit.i142.i.i ]
  %s0.2.0.lcssa.i143.i.i = phi double [ 0.000000e+00, %B606.endif.endif.endif.endif.thread.i.i ], [ %232, %B348.loopexit.i142.i.i ]
  %.1775.i.i = fadd contract double %.17468.i.i, %s0.2.0.lcssa.i143.i.i
  %sunkaddr240.i.i = shl i64 %.1639.i.i, 3
  %sunkaddr241.i.i = getelementptr i8, ptr %216, i64 %sunkaddr240.i.i
  %sunkaddr242.i.i = getelementptr i8, ptr %sunkaddr241.i.i, i64 8
  store double %.1775.i.i, ptr %sunkaddr242.i.i, align 8, !noalias !74
  %.1807.i.i = add i64 %at.2.1892.i.i, 1
  %exitcond.not.i260.i = icmp eq i64 %.1807.i.i, %213
  br i1 %exitcond.not.i260.i, label %B860.i261.i, label %B404.if.i.i

_ZN17bnserve_inference12modes_kernel7_source10_add_pairsB4v169B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i: ; preds = %B860.i261.i, %_ZN17bnserve_inference12modes_kernel7_source13_add_productsB4v129B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxx5ArrayIxLi1E1C7mutable7alignedEdd5ArrayIdLi1E1C7mutable7alignedE.exit.i
  %scevgep.i = getelementptr i8, ptr %lsr.iv.i, i64 200
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
declare double @llvm.floor.f64(double) #2

; Function Attrs: mustprogress nocallback nocreateundeforpoison nofree nosync nounwind speculatable willreturn memory(none)
declare double @llvm.fma.f64(double, double, double) #2

; Function Attrs: nofree norecurse nosync nounwind memory(argmem: readwrite)
define internal fastcc void @inner_0(ptr noalias nonnull writeonly captures(none) %retptr, ptr readonly captures(none) %arg.k.4, i64 range(i64 17, 22) %arg.first, double %arg.sign, ptr readonly captures(none) %arg.f.4, ptr readonly captures(none) %arg.c.4, i64 range(i64 -9223372036854775808, 513) %arg.c.5.0, ptr readonly captures(none) %arg.s.4, ptr readonly captures(none) %arg.pr.4, ptr readonly captures(none) %arg.pi.4, ptr readonly captures(none) %arg.xr.4, ptr readonly captures(none) %arg.xi.4, ptr captures(none) %arg.hr.4, ptr captures(none) %arg.hi.4) unnamed_addr #3 {
entry:
  %0 = getelementptr double, ptr %arg.k.4, i64 %arg.first
  %.174 = load double, ptr %0, align 8
  %1 = getelementptr i8, ptr %0, i64 8
  %.204 = load double, ptr %1, align 8
  %2 = getelementptr i8, ptr %0, i64 24
  %.264 = load double, ptr %2, align 8
  %.328 = getelementptr i8, ptr %arg.k.4, i64 104
  %.329 = load double, ptr %.328, align 8
  %.357 = getelementptr i8, ptr %arg.k.4, i64 112
  %.358 = load double, ptr %.357, align 8
  %.392 = getelementptr i8, ptr %arg.k.4, i64 120
  %.393 = load double, ptr %.392, align 8
  %.421 = getelementptr i8, ptr %arg.k.4, i64 128
  %.422 = load double, ptr %.421, align 8
  %.524416.not = icmp slt i64 %arg.c.5.0, 1
  br i1 %.524416.not, label %B2487, label %B288.if.lr.ph

B288.if.lr.ph:                                    ; preds = %entry
  %3 = getelementptr i8, ptr %0, i64 16
  %.234 = load double, ptr %3, align 8
  %.702 = fmul contract double %.393, %.234
  %.707 = fmul contract double %arg.sign, 5.000000e-01
  %.735 = fmul contract double %.422, %.234
  br label %B288.if

B2361:                                            ; preds = %B288.if
  %.795 = tail call contract double @llvm.fma.f64(double %.783.fr, double 0x3FE45F306DC9C883, double 0x4338000000000000)
  %.844 = bitcast double %.795 to i64
  %.851 = shl i64 %.844, 62
  %.852 = and i64 %.851, -9223372036854775808
  %.848 = and i64 %.844, 1
  %4 = icmp eq i64 %.848, 0
  %.796 = fadd contract double %.795, 0xC338000000000000
  %.811 = tail call contract double @llvm.fma.f64(double %.796, double 0xBFF921FB54442D18, double %.783.fr)
  %.826 = tail call contract double @llvm.fma.f64(double %.796, double 0xBC91A62633145C07, double %.811)
  %.827 = fmul contract double %.826, %.826
  br i1 %4, label %select.true.sink, label %select.false.sink

select.true.sink:                                 ; preds = %B2361
  %.828 = tail call contract double @llvm.fma.f64(double %.827, double 0xBD6AE7F3E733B81F, double 0x3DE6124613A86D09)
  %.829 = tail call contract double @llvm.fma.f64(double %.827, double %.828, double 0xBE5AE64567F544E4)
  %.830 = tail call contract double @llvm.fma.f64(double %.827, double %.829, double 0x3EC71DE3A556C734)
  %.831 = tail call contract double @llvm.fma.f64(double %.827, double %.830, double 0xBF2A01A01A01A01A)
  %.832 = tail call contract double @llvm.fma.f64(double %.827, double %.831, double 0x3F81111111111111)
  %.833 = tail call contract double @llvm.fma.f64(double %.827, double %.832, double 0xBFC5555555555555)
  %.834 = fmul contract double %.826, %.827
  %.835 = tail call contract double @llvm.fma.f64(double %.834, double %.833, double %.826)
  br label %select.end

select.false.sink:                                ; preds = %B2361
  %.836 = tail call contract double @llvm.fma.f64(double %.827, double 0x3D2AE7F3E733B81F, double 0xBDA93974A8C07C9D)
  %.837 = tail call contract double @llvm.fma.f64(double %.827, double %.836, double 0x3E21EED8EFF8D898)
  %.838 = tail call contract double @llvm.fma.f64(double %.827, double %.837, double 0xBE927E4FB7789F5C)
  %.839 = tail call contract double @llvm.fma.f64(double %.827, double %.838, double 0x3EFA01A01A01A01A)
  %.840 = tail call contract double @llvm.fma.f64(double %.827, double %.839, double 0xBF56C16C16C16C17)
  %.841 = tail call contract double @llvm.fma.f64(double %.827, double %.840, double 0x3FA5555555555555)
  %.842 = tail call contract double @llvm.fma.f64(double %.827, double %.841, double -5.000000e-01)
  %.843 = tail call contract double @llvm.fma.f64(double %.827, double %.842, double 1.000000e+00)
  br label %select.end

select.end:                                       ; preds = %select.false.sink, %select.true.sink
  %.856.v = phi double [ %.835, %select.true.sink ], [ %.843, %select.false.sink ]
  %.856 = bitcast double %.856.v to i64
  %.857 = xor i64 %.852, %.856
  %.858 = bitcast i64 %.857 to double
  %.911 = fdiv contract double %.858, %.783.fr
  br label %B2377

B2377:                                            ; preds = %B1024.endif, %select.end
  %_sinc_v118__vphi96_0.2.1 = phi double [ %.899, %B1024.endif ], [ %.911, %select.end ]
  %.927 = fadd contract double %.736, 1.000000e+00
  %.929 = fmul contract double %.775, %.927
  %.929.fr = freeze double %.929
  %.935 = fmul contract double %.929.fr, %.929.fr
  %.1032 = fcmp contract olt double %.935, 0x3EB0C6F7A0B5ED8D
  br i1 %.1032, label %B2385.endif, label %B2463

B2463:                                            ; preds = %B2377
  %.941 = tail call contract double @llvm.fma.f64(double %.929.fr, double 0x3FE45F306DC9C883, double 0x4338000000000000)
  %.990 = bitcast double %.941 to i64
  %.997 = shl i64 %.990, 62
  %.998 = and i64 %.997, -9223372036854775808
  %.994 = and i64 %.990, 1
  %5 = icmp eq i64 %.994, 0
  %.942 = fadd contract double %.941, 0xC338000000000000
  %.957 = tail call contract double @llvm.fma.f64(double %.942, double 0xBFF921FB54442D18, double %.929.fr)
  %.972 = tail call contract double @llvm.fma.f64(double %.942, double 0xBC91A62633145C07, double %.957)
  %.973 = fmul contract double %.972, %.972
  br i1 %5, label %select.true.sink11, label %select.false.sink12

select.true.sink11:                               ; preds = %B2463
  %.974 = tail call contract double @llvm.fma.f64(double %.973, double 0xBD6AE7F3E733B81F, double 0x3DE6124613A86D09)
  %.975 = tail call contract double @llvm.fma.f64(double %.973, double %.974, double 0xBE5AE64567F544E4)
  %.976 = tail call contract double @llvm.fma.f64(double %.973, double %.975, double 0x3EC71DE3A556C734)
  %.977 = tail call contract double @llvm.fma.f64(double %.973, double %.976, double 0xBF2A01A01A01A01A)
  %.978 = tail call contract double @llvm.fma.f64(double %.973, double %.977, double 0x3F81111111111111)
  %.979 = tail call contract double @llvm.fma.f64(double %.973, double %.978, double 0xBFC5555555555555)
  %.980 = fmul contract double %.972, %.973
  %.981 = tail call contract double @llvm.fma.f64(double %.980, double %.979, double %.972)
  br label %select.end10

select.false.sink12:                              ; preds = %B2463
  %.982 = tail call contract double @llvm.fma.f64(double %.973, double 0x3D2AE7F3E733B81F, double 0xBDA93974A8C07C9D)
  %.983 = tail call contract double @llvm.fma.f64(double %.973, double %.982, double 0x3E21EED8EFF8D898)
  %.984 = tail call contract double @llvm.fma.f64(double %.973, double %.983, double 0xBE927E4FB7789F5C)
  %.985 = tail call contract double @llvm.fma.f64(double %.973, double %.984, double 0x3EFA01A01A01A01A)
  %.986 = tail call contract double @llvm.fma.f64(double %.973, double %.985, double 0xBF56C16C16C16C17)
  %.987 = tail call contract double @llvm.fma.f64(double %.973, double %.986, double 0x3FA5555555555555)
  %.988 = tail call contract double @llvm.fma.f64(double %.973, double %.987, double -5.000000e-01)
  %.989 = tail call contract double @llvm.fma.f64(double %.973, double %.988, double 1.000000e+00)
  br label %select.end10

select.end10:                                     ; preds = %select.false.sink12, %select.true.sink11
  %.1002.v = phi double [ %.981, %select.true.sink11 ], [ %.989, %select.false.sink12 ]
  %.1002 = bitcast double %.1002.v to i64
  %.1003 = xor i64 %.998, %.1002
  %.1004 = bitcast i64 %.1003 to double
  %.1057 = fdiv contract double %.1004, %.929.fr
  br label %B2479

B2479:                                            ; preds = %B2385.endif, %select.end10
  %_sinc_v120__vphi96_0.2.1 = phi double [ %.1045, %B2385.endif ], [ %.1057, %select.end10 ]
  %.1073 = tail call contract double @llvm.fma.f64(double %.775, double 0x3FE45F306DC9C883, double 0x4338000000000000)
  %.1074 = fadd contract double %.1073, 0xC338000000000000
  %.1089 = tail call contract double @llvm.fma.f64(double %.1074, double 0xBFF921FB54442D18, double %.775)
  %.1104 = tail call contract double @llvm.fma.f64(double %.1074, double 0xBC91A62633145C07, double %.1089)
  %.1105 = fmul contract double %.1104, %.1104
  %.1106 = tail call contract double @llvm.fma.f64(double %.1105, double 0xBD6AE7F3E733B81F, double 0x3DE6124613A86D09)
  %.1107 = tail call contract double @llvm.fma.f64(double %.1105, double %.1106, double 0xBE5AE64567F544E4)
  %.1108 = tail call contract double @llvm.fma.f64(double %.1105, double %.1107, double 0x3EC71DE3A556C734)
  %.1109 = tail call contract double @llvm.fma.f64(double %.1105, double %.1108, double 0xBF2A01A01A01A01A)
  %.1110 = tail call contract double @llvm.fma.f64(double %.1105, double %.1109, double 0x3F81111111111111)
  %.1111 = tail call contract double @llvm.fma.f64(double %.1105, double %.1110, double 0xBFC5555555555555)
  %.1112 = fmul contract double %.1104, %.1105
  %.1113 = tail call contract double @llvm.fma.f64(double %.1112, double %.1111, double %.1104)
  %.1114 = tail call contract double @llvm.fma.f64(double %.1105, double 0x3D2AE7F3E733B81F, double 0xBDA93974A8C07C9D)
  %.1115 = tail call contract double @llvm.fma.f64(double %.1105, double %.1114, double 0x3E21EED8EFF8D898)
  %.1116 = tail call contract double @llvm.fma.f64(double %.1105, double %.1115, double 0xBE927E4FB7789F5C)
  %.1117 = tail call contract double @llvm.fma.f64(double %.1105, double %.1116, double 0x3EFA01A01A01A01A)
  %.1118 = tail call contract double @llvm.fma.f64(double %.1105, double %.1117, double 0xBF56C16C16C16C17)
  %.1119 = tail call contract double @llvm.fma.f64(double %.1105, double %.1118, double 0x3FA5555555555555)
  %.1120 = tail call contract double @llvm.fma.f64(double %.1105, double %.1119, double -5.000000e-01)
  %.1121 = tail call contract double @llvm.fma.f64(double %.1105, double %.1120, double 1.000000e+00)
  %.1122 = bitcast double %.1073 to i64
  %.1123 = bitcast double %.1113 to i64
  %.1124 = bitcast double %.1121 to i64
  %.1125 = xor i64 %.1124, %.1123
  %.1126 = and i64 %.1122, 1
  %6 = icmp eq i64 %.1126, 0
  %.1128 = select i1 %6, i64 0, i64 %.1125
  %.1129 = shl i64 %.1122, 62
  %.1130 = and i64 %.1129, -9223372036854775808
  %.1132 = add i64 %.1129, 4611686018427387904
  %.1133 = and i64 %.1132, -9223372036854775808
  %7 = xor i64 %.1130, %.1123
  %.1135 = xor i64 %7, %.1128
  %.1136 = bitcast i64 %.1135 to double
  %8 = xor i64 %.1133, %.1124
  %.1138 = xor i64 %8, %.1128
  %.1139 = bitcast i64 %.1138 to double
  %.1160 = fmul contract double %.1139, 5.000000e-01
  %.1161 = fadd contract double %_sinc_v118__vphi96_0.2.1, %_sinc_v120__vphi96_0.2.1
  %.1162 = fmul contract double %.1160, %.1161
  %.1163 = fmul contract double %.1136, 5.000000e-01
  %.1164 = fsub contract double %_sinc_v118__vphi96_0.2.1, %_sinc_v120__vphi96_0.2.1
  %.1165 = fmul contract double %.1163, %.1164
  %.1172 = fmul contract double %.775, %.736
  %.1175 = tail call contract double @llvm.fma.f64(double %.1172, double 0x3FE45F306DC9C883, double 0x4338000000000000)
  %.1176 = fadd contract double %.1175, 0xC338000000000000
  %.1191 = tail call contract double @llvm.fma.f64(double %.1176, double 0xBFF921FB54442D18, double %.1172)
  %.1206 = tail call contract double @llvm.fma.f64(double %.1176, double 0xBC91A62633145C07, double %.1191)
  %.1207 = fmul contract double %.1206, %.1206
  %.1208 = tail call contract double @llvm.fma.f64(double %.1207, double 0xBD6AE7F3E733B81F, double 0x3DE6124613A86D09)
  %.1209 = tail call contract double @llvm.fma.f64(double %.1207, double %.1208, double 0xBE5AE64567F544E4)
  %.1210 = tail call contract double @llvm.fma.f64(double %.1207, double %.1209, double 0x3EC71DE3A556C734)
  %.1211 = tail call contract double @llvm.fma.f64(double %.1207, double %.1210, double 0xBF2A01A01A01A01A)
  %.1212 = tail call contract double @llvm.fma.f64(double %.1207, double %.1211, double 0x3F81111111111111)
  %.1213 = tail call contract double @llvm.fma.f64(double %.1207, double %.1212, double 0xBFC5555555555555)
  %.1214 = fmul contract double %.1206, %.1207
  %.1215 = tail call contract double @llvm.fma.f64(double %.1214, double %.1213, double %.1206)
  %.1216 = tail call contract double @llvm.fma.f64(double %.1207, double 0x3D2AE7F3E733B81F, double 0xBDA93974A8C07C9D)
  %.1217 = tail call contract double @llvm.fma.f64(double %.1207, double %.1216, double 0x3E21EED8EFF8D898)
  %.1218 = tail call contract double @llvm.fma.f64(double %.1207, double %.1217, double 0xBE927E4FB7789F5C)
  %.1219 = tail call contract double @llvm.fma.f64(double %.1207, double %.1218, double 0x3EFA01A01A01A01A)
  %.1220 = tail call contract double @llvm.fma.f64(double %.1207, double %.1219, double 0xBF56C16C16C16C17)
  %.1221 = tail call contract double @llvm.fma.f64(double %.1207, double %.1220, double 0x3FA5555555555555)
  %.1222 = tail call contract double @llvm.fma.f64(double %.1207, double %.1221, double -5.000000e-01)
  %.1223 = tail call contract double @llvm.fma.f64(double %.1207, double %.1222, double 1.000000e+00)
  %.1224 = bitcast double %.1175 to i64
  %.1225 = bitcast double %.1215 to i64
  %.1226 = bitcast double %.1223 to i64
  %.1227 = xor i64 %.1226, %.1225
  %.1228 = and i64 %.1224, 1
  %9 = icmp eq i64 %.1228, 0
  %.1230 = select i1 %9, i64 0, i64 %.1227
  %.1231 = shl i64 %.1224, 62
  %.1232 = and i64 %.1231, -9223372036854775808
  %.1234 = add i64 %.1231, 4611686018427387904
  %.1235 = and i64 %.1234, -9223372036854775808
  %10 = xor i64 %.1232, %.1225
  %.1237 = xor i64 %10, %.1230
  %.1238 = bitcast i64 %.1237 to double
  %11 = xor i64 %.1235, %.1226
  %.1240 = xor i64 %11, %.1230
  %.1241 = bitcast i64 %.1240 to double
  %.1262 = fmul contract double %.1162, %.1241
  %.1263 = fmul contract double %.1165, %.1238
  %.1264 = fsub contract double %.1262, %.1263
  %.1265 = fmul contract double %.1162, %.1238
  %.1266 = fmul contract double %.1165, %.1241
  %.1267 = fadd contract double %.1265, %.1266
  %scevgep14 = getelementptr i8, ptr %arg.pr.4, i64 %12
  %.1298 = load double, ptr %scevgep14, align 8
  %.1300 = fmul contract double %.719, %.1298
  %scevgep13 = getelementptr i8, ptr %arg.xr.4, i64 %12
  %.1331 = load double, ptr %scevgep13, align 8
  %.1333 = fmul contract double %.724, %.1331
  %.1334 = fadd contract double %.1300, %.1333
  %scevgep12 = getelementptr i8, ptr %arg.pi.4, i64 %12
  %.1365 = load double, ptr %scevgep12, align 8
  %.1367 = fmul contract double %.719, %.1365
  %scevgep11 = getelementptr i8, ptr %arg.xi.4, i64 %12
  %.1400 = load double, ptr %scevgep11, align 8
  %.1402 = fmul contract double %.724, %.1400
  %.1405 = fadd contract double %.1367, %.1402
  %scevgep10 = getelementptr i8, ptr %arg.hr.4, i64 %12
  %.1436 = load double, ptr %scevgep10, align 8
  %.1437 = fmul contract double %.1264, %.1334
  %.1438 = fmul contract double %.1267, %.1405
  %.1439 = fsub contract double %.1437, %.1438
  %.1440 = fadd contract double %.1436, %.1439
  store double %.1440, ptr %scevgep10, align 8
  %scevgep9 = getelementptr i8, ptr %arg.hi.4, i64 %12
  %.1502 = load double, ptr %scevgep9, align 8
  %.1503 = fmul contract double %.1264, %.1405
  %.1504 = fmul contract double %.1267, %.1334
  %.1505 = fadd contract double %.1504, %.1503
  %.1506 = fadd contract double %.1502, %.1505
  store double %.1506, ptr %scevgep9, align 8
  %exitcond.not = icmp eq i64 %arg.c.5.0, %.537
  br i1 %exitcond.not, label %B2487, label %B288.if

B2487:                                            ; preds = %B2479, %entry
  store ptr null, ptr %retptr, align 8
  ret void

B288.if:                                          ; preds = %B2479, %B288.if.lr.ph
  %.530415417 = phi i64 [ 0, %B288.if.lr.ph ], [ %.537, %B2479 ]
  %.537 = add nuw nsw i64 %.530415417, 1
  %12 = shl i64 %.530415417, 3
  %scevgep8 = getelementptr i8, ptr %arg.c.4, i64 %12
  %.595 = load double, ptr %scevgep8, align 8
  %.597 = fmul contract double %.174, %.595
  %scevgep7 = getelementptr i8, ptr %arg.s.4, i64 %12
  %.628 = load double, ptr %scevgep7, align 8
  %.630 = fmul contract double %.204, %.628
  %.631 = fsub contract double %.597, %.630
  %.664 = fmul contract double %.204, %.595
  %.697 = fmul contract double %.174, %.628
  %.698 = fadd contract double %.664, %.697
  %.699 = fneg contract double %.698
  %.704 = fmul contract double %.422, %.631
  %.705 = fsub contract double %.702, %.704
  %.708 = fmul contract double %.698, %.698
  %.709 = fmul contract double %.705, %.705
  %.710 = fsub contract double %.708, %.709
  %.711 = fmul contract double %.707, %.710
  %.713 = fmul contract double %arg.sign, %.699
  %.714 = fmul contract double %.713, %.705
  %.716 = fmul contract double %.329, %.711
  %.718 = fmul contract double %.358, %.714
  %.719 = fadd contract double %.718, %.716
  %.721 = fmul contract double %.329, %.714
  %.723 = fmul contract double %.358, %.711
  %.724 = fsub contract double %.721, %.723
  %.732 = fmul contract double %.393, %.631
  %.736 = fadd contract double %.735, %.732
  %scevgep15 = getelementptr i8, ptr %arg.f.4, i64 %12
  %.772 = load double, ptr %scevgep15, align 8
  %.773 = fmul contract double %.772, 0x400921FB54442D18
  %.775 = fmul contract double %.264, %.773
  %.781 = fsub contract double 1.000000e+00, %.736
  %.783 = fmul contract double %.775, %.781
  %.783.fr = freeze double %.783
  %.789 = fmul contract double %.783.fr, %.783.fr
  %.886 = fcmp contract olt double %.789, 0x3EB0C6F7A0B5ED8D
  br i1 %.886, label %B1024.endif, label %B2361

B1024.endif:                                      ; preds = %B288.if
  %.896 = fdiv contract double %.789, 6.000000e+00
  %.899 = fsub contract double 1.000000e+00, %.896
  br label %B2377

B2385.endif:                                      ; preds = %B2377
  %.1042 = fdiv contract double %.935, 6.000000e+00
  %.1045 = fsub contract double 1.000000e+00, %.1042
  br label %B2479
}

; Function Attrs: mustprogress nocallback nocreateundeforpoison nofree nosync nounwind speculatable willreturn memory(none)
declare double @llvm.sqrt.f64(double) #2

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
!12 = distinct !{!12, !13}
!13 = !{!"llvm.loop.unroll.disable"}
!14 = !{!15, !10, !1}
!15 = distinct !{!15, !16, !"_ZN17bnserve_inference13moving_kernel8_passing6_turnsB3v55B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedExx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!16 = distinct !{!16, !"_ZN17bnserve_inference13moving_kernel8_passing6_turnsB3v55B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedExx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!17 = distinct !{!17, !13}
!18 = !{!"branch_weights", i32 1, i32 99}
!19 = !{!20, !1}
!20 = distinct !{!20, !21, !"_ZN17bnserve_inference13moving_kernel7_source9_polariseB3v58B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!21 = distinct !{!21, !"_ZN17bnserve_inference13moving_kernel7_source9_polariseB3v58B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!22 = !{!23, !20, !1}
!23 = distinct !{!23, !24, !"_ZN17bnserve_inference13moving_kernel7_source5_turnB3v86B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedEd5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!24 = distinct !{!24, !"_ZN17bnserve_inference13moving_kernel7_source5_turnB3v86B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedEd5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!25 = !{!26, !20, !1}
!26 = distinct !{!26, !27, !"_ZN17bnserve_inference12modes_kernel7_source9_add_modeB3v88B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedExxdd5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!27 = distinct !{!27, !"_ZN17bnserve_inference12modes_kernel7_source9_add_modeB3v88B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedExxdd5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!28 = !{!29, !20, !1}
!29 = distinct !{!29, !30, !"_ZN17bnserve_inference12modes_kernel7_source9_add_modeB3v88B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedExxdd5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!30 = distinct !{!30, !"_ZN17bnserve_inference12modes_kernel7_source9_add_modeB3v88B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedExxdd5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!31 = !{!32, !1}
!32 = distinct !{!32, !33, !"_ZN17bnserve_inference13moving_kernel7_source8_respondB3v89B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!33 = distinct !{!33, !"_ZN17bnserve_inference13moving_kernel7_source8_respondB3v89B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!34 = !{!35, !32, !1}
!35 = distinct !{!35, !36, !"_ZN17bnserve_inference13moving_kernel9_response10short_armsB4v124B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!36 = distinct !{!36, !"_ZN17bnserve_inference13moving_kernel9_response10short_armsB4v124B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!37 = !{!38, !32, !1}
!38 = distinct !{!38, !39, !"_ZN17bnserve_inference13moving_kernel9_response5delayB4v125B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!39 = distinct !{!39, !"_ZN17bnserve_inference13moving_kernel9_response5delayB4v125B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!40 = !{!41, !32, !1}
!41 = distinct !{!41, !42, !"_ZN17bnserve_inference6kernel5_sums9errors_atB4v127B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedExx5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!42 = distinct !{!42, !"_ZN17bnserve_inference6kernel5_sums9errors_atB4v127B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedExx5ArrayIdLi1E1C7mutable7alignedE"}
!43 = !{!"branch_weights", i32 99, i32 1}
!44 = !{!45, !32, !1}
!45 = distinct !{!45, !46, !"_ZN17bnserve_inference6kernel5_sums9errors_atB4v127B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedExx5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!46 = distinct !{!46, !"_ZN17bnserve_inference6kernel5_sums9errors_atB4v127B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedExx5ArrayIdLi1E1C7mutable7alignedE"}
!47 = !{!48, !32, !1}
!48 = distinct !{!48, !49, !"_ZN17bnserve_inference12modes_kernel7_source10_calibrateB4v128B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!49 = distinct !{!49, !"_ZN17bnserve_inference12modes_kernel7_source10_calibrateB4v128B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!50 = !{!51, !1}
!51 = distinct !{!51, !52, !"_ZN17bnserve_inference12modes_kernel7_source13_add_productsB4v129B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxx5ArrayIxLi1E1C7mutable7alignedEdd5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!52 = distinct !{!52, !"_ZN17bnserve_inference12modes_kernel7_source13_add_productsB4v129B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxx5ArrayIxLi1E1C7mutable7alignedEdd5ArrayIdLi1E1C7mutable7alignedE"}
!53 = !{!54, !51, !1}
!54 = distinct !{!54, !55, !"_ZN17bnserve_inference6kernel5_sums9spline_atB4v151B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dEd5ArrayIdLi1E1C7mutable7alignedExxx: %retptr"}
!55 = distinct !{!55, !"_ZN17bnserve_inference6kernel5_sums9spline_atB4v151B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dEd5ArrayIdLi1E1C7mutable7alignedExxx"}
!56 = !{!57, !51, !1}
!57 = distinct !{!57, !58, !"_ZN17bnserve_inference6kernel5_sums8lane_sumB4v167B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!58 = distinct !{!58, !"_ZN17bnserve_inference6kernel5_sums8lane_sumB4v167B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE"}
!59 = !{!60, !51, !1}
!60 = distinct !{!60, !61, !"_ZN17bnserve_inference12modes_kernel7_source6_turnsB4v148B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedEd5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!61 = distinct !{!61, !"_ZN17bnserve_inference12modes_kernel7_source6_turnsB4v148B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedEd5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!62 = !{!63, !51, !1}
!63 = distinct !{!63, !64, !"_ZN17bnserve_inference12modes_kernel7_source6_fixedB4v150B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!64 = distinct !{!64, !"_ZN17bnserve_inference12modes_kernel7_source6_fixedB4v150B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!65 = !{!66, !51, !1}
!66 = distinct !{!66, !67, !"_ZN17bnserve_inference12modes_kernel7_source8_splinedB4v154B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE8UniTupleIxLi3EE8UniTupleIdLi6EE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!67 = distinct !{!67, !"_ZN17bnserve_inference12modes_kernel7_source8_splinedB4v154B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE8UniTupleIxLi3EE8UniTupleIdLi6EE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!68 = !{!69, !51, !1}
!69 = distinct !{!69, !70, !"_ZN17bnserve_inference6kernel5_sums8lane_sumB4v167B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!70 = distinct !{!70, !"_ZN17bnserve_inference6kernel5_sums8lane_sumB4v167B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE"}
!71 = !{!72, !51, !1}
!72 = distinct !{!72, !73, !"_ZN17bnserve_inference6kernel5_sums9add_termsB4v168B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEdd5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!73 = distinct !{!73, !"_ZN17bnserve_inference6kernel5_sums9add_termsB4v168B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEdd5ArrayIdLi1E1C7mutable7alignedE"}
!74 = !{!75, !1}
!75 = distinct !{!75, !76, !"_ZN17bnserve_inference12modes_kernel7_source10_add_pairsB4v169B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!76 = distinct !{!76, !"_ZN17bnserve_inference12modes_kernel7_source10_add_pairsB4v169B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!77 = !{!78, !75, !1}
!78 = distinct !{!78, !79, !"_ZN17bnserve_inference12modes_kernel7_source5_pairB4v184B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!79 = distinct !{!79, !"_ZN17bnserve_inference12modes_kernel7_source5_pairB4v184B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!80 = !{!81, !75, !1}
!81 = distinct !{!81, !82, !"_ZN17bnserve_inference6kernel5_sums8lane_sumB4v167B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!82 = distinct !{!82, !"_ZN17bnserve_inference6kernel5_sums8lane_sumB4v167B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE"}
!83 = !{!84, !75, !1}
!84 = distinct !{!84, !85, !"_ZN17bnserve_inference6kernel5_sums8lane_sumB4v167B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!85 = distinct !{!85, !"_ZN17bnserve_inference6kernel5_sums8lane_sumB4v167B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE"}
