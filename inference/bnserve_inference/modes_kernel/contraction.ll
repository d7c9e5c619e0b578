; sources: 36839d61e4969c1af013b61504b5853647562d2511a066c128be6389b77f7d69
; built by: numba 0.68.1, llvmlite 0.50.0, Python 3.11, x86_64
; ModuleID = '<string>'
source_filename = "<string>"


; Function Attrs: nofree norecurse nosync nounwind memory(readwrite, inaccessiblemem: none, target_mem0: none, target_mem1: none)
define noundef i32 @bnserve_contract_modes(ptr noalias writeonly captures(none) %retptr, ptr noalias readnone captures(none) %excinfo, ptr readonly captures(none) %arg.arguments) local_unnamed_addr #0 {
entry:
  %.47.i = load i64, ptr %arg.arguments, align 8, !noalias !0
  %.76.i = getelementptr i8, ptr %arg.arguments, i64 128
  %.77.i = load i64, ptr %.76.i, align 8, !noalias !0
  %.106.i = getelementptr i8, ptr %arg.arguments, i64 136
  %.107.i = load i64, ptr %.106.i, align 8, !noalias !0
  %.233.i = mul nsw i64 %.47.i, 9
  %.320.i = mul nsw i64 %.47.i, 3
  %.375.i = shl i64 %.77.i, 1
  %.376.i = add i64 %.375.i, 3
  %.378.i = mul i64 %.376.i, %.47.i
  %.413.i = getelementptr i8, ptr %arg.arguments, i64 248
  %.414.i = load i64, ptr %.413.i, align 8, !noalias !0
  %.415.i = inttoptr i64 %.414.i to ptr
  %.547.i = getelementptr inbounds double, ptr %.415.i, i64 %.320.i
  %.625.i = getelementptr inbounds double, ptr %.415.i, i64 %.378.i
  %.711.i = getelementptr i8, ptr %arg.arguments, i64 8
  %.712.i = load i64, ptr %.711.i, align 8, !noalias !0
  %.713.i = sub i64 0, %.712.i
  %.721.1.i = and i64 %.713.i, -8
  %.755.i = sub i64 0, %.721.1.i
  %.787.i = getelementptr i8, ptr %arg.arguments, i64 208
  %.788.i = load i64, ptr %.787.i, align 8, !noalias !0
  %.790.i = mul nsw i64 %.788.i, %.107.i
  %.792.i = add nsw i64 %.107.i, 1
  %.794.i = mul nsw i64 %.792.i, %.107.i
  %.869.i = getelementptr i8, ptr %arg.arguments, i64 240
  %.870.i = load i64, ptr %.869.i, align 8, !noalias !0
  %.871.not.i = icmp eq i64 %.870.i, 0
  %.904.i = mul nsw i64 %.712.i, %.107.i
  %"$phi862.0.2.0.i" = select i1 %.871.not.i, i64 0, i64 %.904.i
  %.950.i = getelementptr i8, ptr %arg.arguments, i64 160
  %.951.i = load i64, ptr %.950.i, align 8, !noalias !0
  %.1268.i = shl i64 %.790.i, 4
  %0 = shl i64 %.794.i, 3
  %.1656.i = and i64 %0, -16
  %.2047.i = shl i64 %"$phi862.0.2.0.i", 4
  %.2457.i = and i64 %.755.i, 504
  %.2460.not.i = icmp ne i64 %.2457.i, 0
  %.24611157.i = lshr i64 %.755.i, 9
  %.2462.i = zext i1 %.2460.not.i to i64
  %.2463.i = add nuw nsw i64 %.24611157.i, %.2462.i
  %.103146.i = icmp sgt i64 %.951.i, 0
  br i1 %.103146.i, label %B930.lr.ph.i, label %_ZN17bnserve_inference12modes_kernel7_source8contractB2v3B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIxLi1E1C7mutable7alignedE.exit

B930.i:                                           ; preds = %B930.lr.ph.i, %B1730.i
  %.1021.sroa.0.052.i = phi i64 [ 0, %B930.lr.ph.i ], [ %.1021.sroa.0.0.i, %B1730.i ]
  %.1030124251.i = phi i64 [ %.1030124249.i, %B930.lr.ph.i ], [ %.10301242.i, %B1730.i ]
  %.1037125450.i = phi i64 [ 1, %B930.lr.ph.i ], [ %.10371254.i, %B1730.i ]
  %.1102.i = load i64, ptr %sunkaddr66.i, align 8, !noalias !0
  %.1105.i = mul nsw i64 %.1021.sroa.0.052.i, 56
  %.1106.i = add nsw i64 %.1102.i, %.1105.i
  %.1107.i = inttoptr i64 %.1106.i to ptr
  %.100.i.i = load double, ptr %15, align 8, !noalias !3
  %.129.i.i = load double, ptr %.128.i.i, align 8, !noalias !3
  %.161.i.i = getelementptr i8, ptr %.1107.i, i64 24
  %.162.i.i = load double, ptr %.161.i.i, align 8, !noalias !3
  %.163.i.i = fmul contract double %.129.i.i, %.162.i.i
  %.164.i.i = fadd contract double %.100.i.i, %.163.i.i
  %.194.i.i = load double, ptr %.1107.i, align 8, !noalias !3
  %.195.i.i = fsub contract double %.164.i.i, %.194.i.i
  %.197.i.i = tail call contract double @llvm.fma.f64(double %.195.i.i, double 0x3FE45F306DC9C883, double 0x4338000000000000)
  %.198.i.i = fadd contract double %.197.i.i, 0xC338000000000000
  %.213.i.i = tail call contract double @llvm.fma.f64(double %.198.i.i, double 0xBFF921FB54442D18, double %.195.i.i)
  %.228.i.i = tail call contract double @llvm.fma.f64(double %.198.i.i, double 0xBC91A62633145C07, double %.213.i.i)
  %.229.i.i = fmul contract double %.228.i.i, %.228.i.i
  %.230.i.i = tail call contract double @llvm.fma.f64(double %.229.i.i, double 0xBD6AE7F3E733B81F, double 0x3DE6124613A86D09)
  %.231.i1.i = tail call contract double @llvm.fma.f64(double %.229.i.i, double %.230.i.i, double 0xBE5AE64567F544E4)
  %.232.i2.i = tail call contract double @llvm.fma.f64(double %.229.i.i, double %.231.i1.i, double 0x3EC71DE3A556C734)
  %.233.i3.i = tail call contract double @llvm.fma.f64(double %.229.i.i, double %.232.i2.i, double 0xBF2A01A01A01A01A)
  %.234.i.i = tail call contract double @llvm.fma.f64(double %.229.i.i, double %.233.i3.i, double 0x3F81111111111111)
  %.235.i.i = tail call contract double @llvm.fma.f64(double %.229.i.i, double %.234.i.i, double 0xBFC5555555555555)
  %.236.i.i = fmul contract double %.228.i.i, %.229.i.i
  %.237.i.i = tail call contract double @llvm.fma.f64(double %.236.i.i, double %.235.i.i, double %.228.i.i)
  %.238.i.i = tail call contract double @llvm.fma.f64(double %.229.i.i, double 0x3D2AE7F3E733B81F, double 0xBDA93974A8C07C9D)
  %.239.i.i = tail call contract double @llvm.fma.f64(double %.229.i.i, double %.238.i.i, double 0x3E21EED8EFF8D898)
  %.240.i.i = tail call contract double @llvm.fma.f64(double %.229.i.i, double %.239.i.i, double 0xBE927E4FB7789F5C)
  %.241.i.i = tail call contract double @llvm.fma.f64(double %.229.i.i, double %.240.i.i, double 0x3EFA01A01A01A01A)
  %.242.i.i = tail call contract double @llvm.fma.f64(double %.229.i.i, double %.241.i.i, double 0xBF56C16C16C16C17)
  %.243.i.i = tail call contract double @llvm.fma.f64(double %.229.i.i, double %.242.i.i, double 0x3FA5555555555555)
  %.244.i.i = tail call contract double @llvm.fma.f64(double %.229.i.i, double %.243.i.i, double -5.000000e-01)
  %.245.i.i = tail call contract double @llvm.fma.f64(double %.229.i.i, double %.244.i.i, double 1.000000e+00)
  %.246.i.i = bitcast double %.197.i.i to i64
  %.247.i.i = bitcast double %.237.i.i to i64
  %.248.i.i = bitcast double %.245.i.i to i64
  %.249.i.i = xor i64 %.248.i.i, %.247.i.i
  %.250.i.i = and i64 %.246.i.i, 1
  %1 = icmp eq i64 %.250.i.i, 0
  %.252.i.i = select i1 %1, i64 0, i64 %.249.i.i
  %.253.i.i = shl i64 %.246.i.i, 62
  %.254.i.i = and i64 %.253.i.i, -9223372036854775808
  %.256.i.i = add i64 %.253.i.i, 4611686018427387904
  %.257.i.i = and i64 %.256.i.i, -9223372036854775808
  %2 = xor i64 %.254.i.i, %.247.i.i
  %.259.i.i = xor i64 %2, %.252.i.i
  %.260.i.i = bitcast i64 %.259.i.i to double
  %3 = xor i64 %.257.i.i, %.248.i.i
  %.262.i4.i = xor i64 %3, %.252.i.i
  %.263.i.i = bitcast i64 %.262.i4.i to double
  %.313.i.i = getelementptr i8, ptr %.1107.i, i64 8
  %.314.i.i = load double, ptr %.313.i.i, align 8, !noalias !3
  %.315.i.i = tail call contract double @llvm.fma.f64(double %.314.i.i, double 0x3FE45F306DC9C883, double 0x4338000000000000)
  %.316.i.i = fadd contract double %.315.i.i, 0xC338000000000000
  %.331.i.i = tail call contract double @llvm.fma.f64(double %.316.i.i, double 0xBFF921FB54442D18, double %.314.i.i)
  %.346.i.i = tail call contract double @llvm.fma.f64(double %.316.i.i, double 0xBC91A62633145C07, double %.331.i.i)
  %.347.i.i = fmul contract double %.346.i.i, %.346.i.i
  %.348.i.i = tail call contract double @llvm.fma.f64(double %.347.i.i, double 0xBD6AE7F3E733B81F, double 0x3DE6124613A86D09)
  %.349.i.i = tail call contract double @llvm.fma.f64(double %.347.i.i, double %.348.i.i, double 0xBE5AE64567F544E4)
  %.350.i.i = tail call contract double @llvm.fma.f64(double %.347.i.i, double %.349.i.i, double 0x3EC71DE3A556C734)
  %.351.i.i = tail call contract double @llvm.fma.f64(double %.347.i.i, double %.350.i.i, double 0xBF2A01A01A01A01A)
  %.352.i.i = tail call contract double @llvm.fma.f64(double %.347.i.i, double %.351.i.i, double 0x3F81111111111111)
  %.353.i.i = tail call contract double @llvm.fma.f64(double %.347.i.i, double %.352.i.i, double 0xBFC5555555555555)
  %.354.i.i = fmul contract double %.346.i.i, %.347.i.i
  %.355.i.i = tail call contract double @llvm.fma.f64(double %.354.i.i, double %.353.i.i, double %.346.i.i)
  %.356.i.i = tail call contract double @llvm.fma.f64(double %.347.i.i, double 0x3D2AE7F3E733B81F, double 0xBDA93974A8C07C9D)
  %.357.i.i = tail call contract double @llvm.fma.f64(double %.347.i.i, double %.356.i.i, double 0x3E21EED8EFF8D898)
  %.358.i.i = tail call contract double @llvm.fma.f64(double %.347.i.i, double %.357.i.i, double 0xBE927E4FB7789F5C)
  %.359.i.i = tail call contract double @llvm.fma.f64(double %.347.i.i, double %.358.i.i, double 0x3EFA01A01A01A01A)
  %.360.i.i = tail call contract double @llvm.fma.f64(double %.347.i.i, double %.359.i.i, double 0xBF56C16C16C16C17)
  %.361.i.i = tail call contract double @llvm.fma.f64(double %.347.i.i, double %.360.i.i, double 0x3FA5555555555555)
  %.362.i.i = tail call contract double @llvm.fma.f64(double %.347.i.i, double %.361.i.i, double -5.000000e-01)
  %.363.i.i = tail call contract double @llvm.fma.f64(double %.347.i.i, double %.362.i.i, double 1.000000e+00)
  %.364.i.i = bitcast double %.315.i.i to i64
  %.365.i.i = bitcast double %.355.i.i to i64
  %.366.i.i = bitcast double %.363.i.i to i64
  %.367.i.i = xor i64 %.366.i.i, %.365.i.i
  %.368.i.i = and i64 %.364.i.i, 1
  %4 = icmp eq i64 %.368.i.i, 0
  %.370.i.i = select i1 %4, i64 0, i64 %.367.i.i
  %.371.i.i = shl i64 %.364.i.i, 62
  %.372.i.i = and i64 %.371.i.i, -9223372036854775808
  %.374.i.i = add i64 %.371.i.i, 4611686018427387904
  %.375.i.i = and i64 %.374.i.i, -9223372036854775808
  %5 = xor i64 %.372.i.i, %.365.i.i
  %.377.i.i = xor i64 %5, %.370.i.i
  %.378.i.i = bitcast i64 %.377.i.i to double
  %6 = xor i64 %.375.i.i, %.366.i.i
  %.380.i.i = xor i64 %6, %.370.i.i
  %.381.i.i = bitcast i64 %.380.i.i to double
  %.434.i.i = getelementptr i8, ptr %.1107.i, i64 16
  %.435.i.i = load double, ptr %.434.i.i, align 8, !noalias !3
  %.436.i.i = tail call contract double @llvm.fma.f64(double %.435.i.i, double 0x3FE45F306DC9C883, double 0x4338000000000000)
  %.437.i.i = fadd contract double %.436.i.i, 0xC338000000000000
  %.452.i.i = tail call contract double @llvm.fma.f64(double %.437.i.i, double 0xBFF921FB54442D18, double %.435.i.i)
  %.467.i.i = tail call contract double @llvm.fma.f64(double %.437.i.i, double 0xBC91A62633145C07, double %.452.i.i)
  %.468.i.i = fmul contract double %.467.i.i, %.467.i.i
  %.469.i.i = tail call contract double @llvm.fma.f64(double %.468.i.i, double 0xBD6AE7F3E733B81F, double 0x3DE6124613A86D09)
  %.470.i.i = tail call contract double @llvm.fma.f64(double %.468.i.i, double %.469.i.i, double 0xBE5AE64567F544E4)
  %.471.i.i = tail call contract double @llvm.fma.f64(double %.468.i.i, double %.470.i.i, double 0x3EC71DE3A556C734)
  %.472.i.i = tail call contract double @llvm.fma.f64(double %.468.i.i, double %.471.i.i, double 0xBF2A01A01A01A01A)
  %.473.i.i = tail call contract double @llvm.fma.f64(double %.468.i.i, double %.472.i.i, double 0x3F81111111111111)
  %.474.i5.i = tail call contract double @llvm.fma.f64(double %.468.i.i, double %.473.i.i, double 0xBFC5555555555555)
  %.475.i.i = fmul contract double %.467.i.i, %.468.i.i
  %.476.i.i = tail call contract double @llvm.fma.f64(double %.475.i.i, double %.474.i5.i, double %.467.i.i)
  %.477.i.i = tail call contract double @llvm.fma.f64(double %.468.i.i, double 0x3D2AE7F3E733B81F, double 0xBDA93974A8C07C9D)
  %.478.i.i = tail call contract double @llvm.fma.f64(double %.468.i.i, double %.477.i.i, double 0x3E21EED8EFF8D898)
  %.479.i.i = tail call contract double @llvm.fma.f64(double %.468.i.i, double %.478.i.i, double 0xBE927E4FB7789F5C)
  %.480.i.i = tail call contract double @llvm.fma.f64(double %.468.i.i, double %.479.i.i, double 0x3EFA01A01A01A01A)
  %.481.i.i = tail call contract double @llvm.fma.f64(double %.468.i.i, double %.480.i.i, double 0xBF56C16C16C16C17)
  %.482.i.i = tail call contract double @llvm.fma.f64(double %.468.i.i, double %.481.i.i, double 0x3FA5555555555555)
  %.483.i.i = tail call contract double @llvm.fma.f64(double %.468.i.i, double %.482.i.i, double -5.000000e-01)
  %.484.i.i = tail call contract double @llvm.fma.f64(double %.468.i.i, double %.483.i.i, double 1.000000e+00)
  %.485.i.i = bitcast double %.436.i.i to i64
  %.486.i.i = bitcast double %.476.i.i to i64
  %.487.i.i = bitcast double %.484.i.i to i64
  %.488.i.i = xor i64 %.487.i.i, %.486.i.i
  %.489.i.i = and i64 %.485.i.i, 1
  %7 = icmp eq i64 %.489.i.i, 0
  %.491.i.i = select i1 %7, i64 0, i64 %.488.i.i
  %.492.i.i = shl i64 %.485.i.i, 62
  %.493.i.i = and i64 %.492.i.i, -9223372036854775808
  %.495.i.i = add i64 %.492.i.i, 4611686018427387904
  %.496.i.i = and i64 %.495.i.i, -9223372036854775808
  %8 = xor i64 %.493.i.i, %.486.i.i
  %.498.i.i = xor i64 %8, %.491.i.i
  %.499.i.i = bitcast i64 %.498.i.i to double
  %9 = xor i64 %.496.i.i, %.487.i.i
  %.501.i.i = xor i64 %9, %.491.i.i
  %.502.i.i = bitcast i64 %.501.i.i to double
  %.523.i.i = fneg contract double %.502.i.i
  %.524.i.i = fmul contract double %.523.i.i, %.260.i.i
  %.525.i.i = fmul contract double %.499.i.i, %.263.i.i
  %.527.i.i = fmul contract double %.525.i.i, %.378.i.i
  %.528.i.i = fsub contract double %.524.i.i, %.527.i.i
  %.534.i.i = fmul contract double %.499.i.i, %.260.i.i
  %.536.i.i = fmul contract double %.534.i.i, %.378.i.i
  %10 = fmul contract double %.502.i.i, %.263.i.i
  %.537.i.i = fsub contract double %.536.i.i, %10
  %.541.i.i = fmul contract double %.381.i.i, %.499.i.i
  %.548.i.i = fmul contract double %10, %.378.i.i
  %.549.i.i = fsub contract double %.534.i.i, %.548.i.i
  %.554.i.i = fmul contract double %.502.i.i, %.260.i.i
  %.556.i.i = fmul contract double %.554.i.i, %.378.i.i
  %.557.i.i = fadd contract double %.525.i.i, %.556.i.i
  %.561.i.i = fmul contract double %.381.i.i, %.502.i.i
  %.565.i.i = fmul contract double %.381.i.i, %.263.i.i
  %.569.i.i = fneg contract double %.381.i.i
  %.570.i.i = fmul contract double %.569.i.i, %.260.i.i
  br i1 %.706618.not.i.i, label %_ZN17bnserve_inference6kernel7_source9_geometryB3v17B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i, label %B502.if.preheader.i.i

B502.if.preheader.i.i:                            ; preds = %B930.i
  %sunkaddr9.i.i = getelementptr i8, ptr %.1107.i, i64 32
  %sunkaddr11.i.i = getelementptr i8, ptr %.1107.i, i64 40
  %sunkaddr13.i.i = getelementptr i8, ptr %.1107.i, i64 48
  br label %B502.if.i.i

B502.if.i.i:                                      ; preds = %B506.endif.else.endif.endif.i.i, %B502.if.preheader.i.i
  %lsr.iv8.i.i = phi i64 [ %lsr.iv.next9.i.i, %B506.endif.else.endif.endif.i.i ], [ %.47.i, %B502.if.preheader.i.i ]
  %lsr.iv6.i.i = phi i64 [ %lsr.iv.next7.i.i, %B506.endif.else.endif.endif.i.i ], [ 0, %B502.if.preheader.i.i ]
  %lsr.iv.i6.i = phi i64 [ %lsr.iv.next.i.i, %B506.endif.else.endif.endif.i.i ], [ 0, %B502.if.preheader.i.i ]
  %.793.not.i.i = icmp slt i64 %lsr.iv6.i.i, %.233.i
  br i1 %.793.not.i.i, label %B506.else.endif.endif.i.i, label %B506.else.endif.if.i.i, !prof !6

B506.else.endif.if.i.i:                           ; preds = %B502.if.i.i
  br label %B506.else.endif.endif.i.i

B506.else.endif.endif.i.i:                        ; preds = %B506.else.endif.if.i.i, %B502.if.i.i
  %.773.sroa.0.3.i.i = phi i64 [ %.233.i, %B506.else.endif.if.i.i ], [ %lsr.iv6.i.i, %B502.if.i.i ]
  %.886.i.i = getelementptr double, ptr %16, i64 %.773.sroa.0.3.i.i
  %.946.i.i = load double, ptr %.886.i.i, align 8, !noalias !3
  %.948.i.i = fmul contract double %.528.i.i, %.946.i.i
  %.976.i.i = getelementptr i8, ptr %.886.i.i, i64 8
  %.977.i.i = load double, ptr %.976.i.i, align 8, !noalias !3
  %.979.i.i = fmul contract double %.537.i.i, %.977.i.i
  %.980.i.i = fadd contract double %.948.i.i, %.979.i.i
  %.1008.i.i = getelementptr i8, ptr %.886.i.i, i64 16
  %.1009.i.i = load double, ptr %.1008.i.i, align 8, !noalias !3
  %.1011.i.i = fmul contract double %.541.i.i, %.1009.i.i
  %.1012.i.i = fadd contract double %.980.i.i, %.1011.i.i
  %.1040.i.i = getelementptr i8, ptr %.886.i.i, i64 24
  %.1041.i.i = load double, ptr %.1040.i.i, align 8, !noalias !3
  %.1043.i.i = fmul contract double %.528.i.i, %.1041.i.i
  %.1071.i7.i = getelementptr i8, ptr %.886.i.i, i64 32
  %.1072.i.i = load double, ptr %.1071.i7.i, align 8, !noalias !3
  %.1074.i.i = fmul contract double %.537.i.i, %.1072.i.i
  %.1075.i.i = fadd contract double %.1043.i.i, %.1074.i.i
  %.1103.i.i = getelementptr i8, ptr %.886.i.i, i64 40
  %.1104.i.i = load double, ptr %.1103.i.i, align 8, !noalias !3
  %.1106.i.i = fmul contract double %.541.i.i, %.1104.i.i
  %.1107.i.i = fadd contract double %.1075.i.i, %.1106.i.i
  %.1135.i.i = getelementptr i8, ptr %.886.i.i, i64 48
  %.1136.i.i = load double, ptr %.1135.i.i, align 8, !noalias !3
  %.1138.i.i = fmul contract double %.528.i.i, %.1136.i.i
  %.1166.i.i = getelementptr i8, ptr %.886.i.i, i64 56
  %.1167.i.i = load double, ptr %.1166.i.i, align 8, !noalias !3
  %.1169.i.i = fmul contract double %.537.i.i, %.1167.i.i
  %.1170.i.i = fadd contract double %.1138.i.i, %.1169.i.i
  %.1198.i.i = getelementptr i8, ptr %.886.i.i, i64 64
  %.1199.i.i = load double, ptr %.1198.i.i, align 8, !noalias !3
  %.1201.i.i = fmul contract double %.541.i.i, %.1199.i.i
  %.1202.i.i = fadd contract double %.1170.i.i, %.1201.i.i
  %.1233.i.i = fmul contract double %.549.i.i, %.946.i.i
  %.1264.i.i = fmul contract double %.557.i.i, %.977.i.i
  %.1265.i.i = fadd contract double %.1233.i.i, %.1264.i.i
  %.1296.i.i = fmul contract double %.561.i.i, %.1009.i.i
  %.1297.i.i = fadd contract double %.1265.i.i, %.1296.i.i
  %.1328.i.i = fmul contract double %.549.i.i, %.1041.i.i
  %.1359.i.i = fmul contract double %.557.i.i, %.1072.i.i
  %.1360.i.i = fadd contract double %.1328.i.i, %.1359.i.i
  %.1391.i.i = fmul contract double %.561.i.i, %.1104.i.i
  %.1392.i.i = fadd contract double %.1360.i.i, %.1391.i.i
  %.1423.i.i = fmul contract double %.549.i.i, %.1136.i.i
  %.1454.i.i = fmul contract double %.557.i.i, %.1167.i.i
  %.1455.i.i = fadd contract double %.1423.i.i, %.1454.i.i
  %.1489.i.i = fmul contract double %.561.i.i, %.1199.i.i
  %.1490.i.i = fadd contract double %.1455.i.i, %.1489.i.i
  %.1492.i.i = fmul contract double %.528.i.i, %.1012.i.i
  %.1494.i.i = fmul contract double %.537.i.i, %.1107.i.i
  %.1495.i.i = fadd contract double %.1492.i.i, %.1494.i.i
  %.1497.i.i = fmul contract double %.541.i.i, %.1202.i.i
  %.1498.i.i = fadd contract double %.1495.i.i, %.1497.i.i
  %.1500.i.i = fmul contract double %.549.i.i, %.1297.i.i
  %.1502.i.i = fmul contract double %.557.i.i, %.1392.i.i
  %.1503.i.i = fadd contract double %.1500.i.i, %.1502.i.i
  %.1505.i.i = fmul contract double %.561.i.i, %.1490.i.i
  %.1506.i.i = fadd contract double %.1503.i.i, %.1505.i.i
  %.1507.i.i = fsub contract double %.1498.i.i, %.1506.i.i
  %.1509.i.i = fmul contract double %.528.i.i, %.1297.i.i
  %.1511.i.i = fmul contract double %.537.i.i, %.1392.i.i
  %.1512.i.i = fadd contract double %.1509.i.i, %.1511.i.i
  %.1514.i.i = fmul contract double %.541.i.i, %.1490.i.i
  %.1515.i.i = fadd contract double %.1512.i.i, %.1514.i.i
  %.1517.i.i = fmul contract double %.549.i.i, %.1012.i.i
  %.1519.i.i = fmul contract double %.557.i.i, %.1107.i.i
  %.1520.i.i = fadd contract double %.1517.i.i, %.1519.i.i
  %.1522.i.i = fmul contract double %.561.i.i, %.1202.i.i
  %.1523.i.i = fadd contract double %.1520.i.i, %.1522.i.i
  %.1524.i.i = fadd contract double %.1515.i.i, %.1523.i.i
  %.1574.not.i.i = icmp slt i64 %lsr.iv.i6.i, %.320.i
  br i1 %.1574.not.i.i, label %B506.endif.else.endif.endif.i.i, label %B506.endif.else.endif.if.i.i, !prof !6

B506.endif.else.endif.if.i.i:                     ; preds = %B506.else.endif.endif.i.i
  br label %B506.endif.else.endif.endif.i.i

B506.endif.else.endif.endif.i.i:                  ; preds = %B506.endif.else.endif.if.i.i, %B506.else.endif.endif.i.i
  %.1554.sroa.0.3.i.i = phi i64 [ %.320.i, %B506.endif.else.endif.if.i.i ], [ %lsr.iv.i6.i, %B506.else.endif.endif.i.i ]
  %.1667.i.i = getelementptr double, ptr %17, i64 %.1554.sroa.0.3.i.i
  %.1728.i.i = load double, ptr %sunkaddr9.i.i, align 8, !noalias !3
  %.1729.i.i = fmul contract double %.1507.i.i, %.1728.i.i
  %.1759.i.i = load double, ptr %sunkaddr11.i.i, align 8, !noalias !3
  %.1760.i.i = fmul contract double %.1524.i.i, %.1759.i.i
  %.1761.i.i = fadd contract double %.1729.i.i, %.1760.i.i
  %sunkaddr.i.i = shl i64 %lsr.iv.i6.i, 3
  %sunkaddr12.i.i = getelementptr i8, ptr %.415.i, i64 %sunkaddr.i.i
  store double %.1761.i.i, ptr %sunkaddr12.i.i, align 8, !noalias !3
  %.1822.i.i = load double, ptr %sunkaddr13.i.i, align 8, !noalias !3
  %.1823.i.i = fmul contract double %.1524.i.i, %.1822.i.i
  %sunkaddr16.i.i = getelementptr i8, ptr %sunkaddr12.i.i, i64 8
  store double %.1823.i.i, ptr %sunkaddr16.i.i, align 8, !noalias !3
  %.1884.i.i = load double, ptr %.1667.i.i, align 8, !noalias !3
  %.1886.i.i = fmul contract double %.565.i.i, %.1884.i.i
  %.1914.i.i = getelementptr i8, ptr %.1667.i.i, i64 8
  %.1915.i.i = load double, ptr %.1914.i.i, align 8, !noalias !3
  %.1917.i.i = fmul contract double %.570.i.i, %.1915.i.i
  %.1918.i.i = fadd contract double %.1886.i.i, %.1917.i.i
  %.1946.i.i = getelementptr i8, ptr %.1667.i.i, i64 16
  %.1947.i.i = load double, ptr %.1946.i.i, align 8, !noalias !3
  %.1952.i.i = fmul contract double %.1947.i.i, %.378.i.i
  %.1953.i.i = fadd contract double %.1918.i.i, %.1952.i.i
  %.1958.i.i = fdiv contract double %.1953.i.i, 0xC1B1DE784A000000
  %sunkaddr19.i.i = getelementptr i8, ptr %sunkaddr12.i.i, i64 16
  store double %.1958.i.i, ptr %sunkaddr19.i.i, align 8, !noalias !3
  %lsr.iv.next.i.i = add nuw i64 %lsr.iv.i6.i, 3
  %lsr.iv.next7.i.i = add nuw i64 %lsr.iv6.i.i, 9
  %lsr.iv.next9.i.i = add nsw i64 %lsr.iv8.i.i, -1
  %exitcond.not.i.i = icmp eq i64 %lsr.iv.next9.i.i, 0
  br i1 %exitcond.not.i.i, label %_ZN17bnserve_inference6kernel7_source9_geometryB3v17B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i, label %B502.if.i.i

_ZN17bnserve_inference6kernel7_source9_geometryB3v17B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i: ; preds = %B506.endif.else.endif.endif.i.i, %B930.i
  %.73.i.i = load i64, ptr %arg.arguments, align 8, !noalias !7
  %.369348.not.i.i = icmp slt i64 %.73.i.i, 1
  br i1 %.369348.not.i.i, label %B930.endif.endif.endif.i, label %B276.if.lr.ph.i.i

B1414.i:                                          ; preds = %.2353.endif.preheader.i, %.1962.if.i
  br i1 %.24841233.not.i, label %B1730.i, label %B1458.if.lr.ph.i

B1458.loopexit.i:                                 ; preds = %B1540.backedge.i, %B1458.if.i
  %lsr.iv.next262.i = add i64 %lsr.iv261.i, -512
  %lsr.iv.next266.i = add i64 %lsr.iv265.i, 4096
  %.2484.i = icmp sgt i64 %.248312171237.i, 1
  br i1 %.2484.i, label %B1458.if.i, label %B1730.i

B1730.i:                                          ; preds = %B1458.loopexit.i, %B1414.i
  %.1031.i = icmp sgt i64 %.1030124251.i, 0
  %.1044.i = zext i1 %.1031.i to i64
  %.10371254.i = add i64 %.1037125450.i, %.1044.i
  %.1040.i = sext i1 %.1031.i to i64
  %.10301242.i = add nsw i64 %.1030124251.i, %.1040.i
  %.1021.sroa.0.0.i = select i1 %.1031.i, i64 %.1037125450.i, i64 0
  br i1 %.1031.i, label %B930.i, label %_ZN17bnserve_inference12modes_kernel7_source8contractB2v3B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIxLi1E1C7mutable7alignedE.exit

B930.lr.ph.i:                                     ; preds = %entry
  %.317.i = getelementptr i8, ptr %arg.arguments, i64 48
  %.318.i = load i64, ptr %.317.i, align 8, !noalias !0
  %.230.i = getelementptr i8, ptr %arg.arguments, i64 40
  %.231.i = load i64, ptr %.230.i, align 8, !noalias !0
  %.143.i = getelementptr i8, ptr %arg.arguments, i64 32
  %.144.i = load i64, ptr %.143.i, align 8, !noalias !0
  %.1030124249.i = add nsw i64 %.951.i, -1
  %scevgep28.i.i = getelementptr i8, ptr %.547.i, i64 8
  %.2442.inv.i = icmp slt i64 %.755.i, 1
  %.24841233.not1419.i = icmp eq i64 %.2463.i, 0
  %.24841233.not.i = select i1 %.2442.inv.i, i1 true, i1 %.24841233.not1419.i
  %11 = mul i64 %.47.i, 24
  %12 = getelementptr i8, ptr %.415.i, i64 %11
  %scevgep247.i = getelementptr i8, ptr %12, i64 24
  %13 = shl i64 %.378.i, 3
  %14 = add i64 %13, 4096
  %15 = inttoptr i64 %.144.i to ptr
  %16 = inttoptr i64 %.231.i to ptr
  %17 = inttoptr i64 %.318.i to ptr
  %sunkaddr66.i = getelementptr i8, ptr %arg.arguments, i64 176
  %.128.i.i = getelementptr i8, ptr %15, i64 8
  %.706618.not.i.i = icmp slt i64 %.47.i, 1
  %18 = icmp slt i64 %.790.i, 1
  %19 = icmp slt i64 %.794.i, 2
  %20 = icmp sgt i64 %"$phi862.0.2.0.i", 0
  %sunkaddr67.i = getelementptr i8, ptr %arg.arguments, i64 256
  %sunkaddr68.i = getelementptr i8, ptr %arg.arguments, i64 264
  %sunkaddr74.i = getelementptr i8, ptr %arg.arguments, i64 224
  %sunkaddr75.i = getelementptr i8, ptr %arg.arguments, i64 232
  %.186.i8.i = getelementptr i8, ptr %arg.arguments, i64 168
  %.284.i.i = getelementptr i8, ptr %arg.arguments, i64 152
  %.1407.i.i = getelementptr i8, ptr %arg.arguments, i64 184
  %.260.i22.i = getelementptr i8, ptr %arg.arguments, i64 56
  %.491.i24.i = getelementptr i8, ptr %arg.arguments, i64 216
  %scevgep341.i.i = getelementptr i8, ptr %.625.i, i64 4096
  %.1532.i.i = getelementptr i8, ptr %arg.arguments, i64 80
  %.1857.i.i = getelementptr i8, ptr %arg.arguments, i64 192
  %.1974.i.i = getelementptr i8, ptr %arg.arguments, i64 200
  %.413.i.i = getelementptr i8, ptr %arg.arguments, i64 24
  %.138.i26.i = getelementptr i8, ptr %arg.arguments, i64 16
  %sunkaddr81.i.i = getelementptr i8, ptr %arg.arguments, i64 144
  %sunkaddr.i32.i = getelementptr i8, ptr %arg.arguments, i64 64
  %sunkaddr83.i = getelementptr i8, ptr %arg.arguments, i64 72
  br label %B930.i

B276.loopexit.i.loopexit.unr-lcssa.i:             ; preds = %B360.if.i.i
  br i1 %30, label %B276.loopexit.i.i, label %B360.if.i.epil.preheader.i

B360.if.i.epil.preheader.i:                       ; preds = %B360.if.i.preheader.i, %B276.loopexit.i.loopexit.unr-lcssa.i
  %lsr.iv.i.epil.init.i = phi i64 [ 0, %B360.if.i.preheader.i ], [ %lsr.iv.next.i.1.i, %B276.loopexit.i.loopexit.unr-lcssa.i ]
  %scevgep27.i.epil.i = getelementptr i8, ptr %sunkaddr69.i, i64 %lsr.iv.i.epil.init.i
  %.633.i.epil.i = load double, ptr %scevgep27.i.epil.i, align 8, !noalias !7
  %.635.i.epil.i = fmul contract double %.441.i.i, %.633.i.epil.i
  %21 = shl i64 %lsr.iv.i.epil.init.i, 1
  %sunkaddr273.i = getelementptr i8, ptr %22, i64 %21
  %.666.i.epil.i = load double, ptr %sunkaddr273.i, align 8, !noalias !7
  %.668.i.epil.i = fmul contract double %.474.i.i, %.666.i.epil.i
  %.669.i.epil.i = fadd contract double %.635.i.epil.i, %.668.i.epil.i
  %scevgep31.i.epil.i = getelementptr i8, ptr %lsr.iv29.i.i, i64 %21
  %scevgep32.i.epil.i = getelementptr i8, ptr %scevgep31.i.epil.i, i64 -8
  store double %.669.i.epil.i, ptr %scevgep32.i.epil.i, align 8, !noalias !7
  %sunkaddr276.i = getelementptr i8, ptr %sunkaddr273.i, i64 8
  %.731.i.epil.i = load double, ptr %sunkaddr276.i, align 8, !noalias !7
  %.733.i.epil.i = fmul contract double %.474.i.i, %.731.i.epil.i
  store double %.733.i.epil.i, ptr %scevgep31.i.epil.i, align 8, !noalias !7
  br label %B276.loopexit.i.i

B276.loopexit.i.i:                                ; preds = %B276.if.i.i, %B360.if.i.epil.preheader.i, %B276.loopexit.i.loopexit.unr-lcssa.i
  %scevgep30.i.i = getelementptr i8, ptr %lsr.iv29.i.i, i64 %23
  %scevgep248.i = getelementptr i8, ptr %lsr.iv.i, i64 %23
  %exitcond355.not.i.i = icmp eq i64 %.382.i.i, %.73.i.i
  br i1 %exitcond355.not.i.i, label %B930.endif.endif.endif.i, label %B276.if.i.i

B276.if.lr.ph.i.i:                                ; preds = %_ZN17bnserve_inference6kernel7_source9_geometryB3v17B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i
  %.102.i.i = load i64, ptr %.76.i, align 8, !noalias !7
  %.137.i.i = shl i64 %.1021.sroa.0.052.i, 3
  %.138.i.i = mul i64 %.137.i.i, %.102.i.i
  %.135.i.i = load i64, ptr %sunkaddr67.i, align 8, !noalias !7
  %.139.i.i = add nsw i64 %.135.i.i, %.138.i.i
  %.226.i.i = load i64, ptr %sunkaddr68.i, align 8, !noalias !7
  %.231.i.i = shl i64 %.1021.sroa.0.052.i, 4
  %.232.i.i = mul i64 %.231.i.i, %.102.i.i
  %.233.i.i = add nsw i64 %.226.i.i, %.232.i.i
  %22 = inttoptr i64 %.233.i.i to ptr
  %23 = shl i64 %.102.i.i, 4
  %scevgep254.i = getelementptr i8, ptr %22, i64 24
  %24 = lshr i64 %.102.i.i, 1
  %25 = and i64 %24, 4611686018427387903
  %26 = mul nsw i64 %25, -2
  %27 = icmp slt i64 %.102.i.i, 1
  %28 = icmp eq i64 %.102.i.i, 1
  %sunkaddr69.i = inttoptr i64 %.139.i.i to ptr
  %29 = and i64 %.102.i.i, 1
  %30 = icmp eq i64 %29, 0
  br label %B276.if.i.i

B276.if.i.i:                                      ; preds = %B276.if.lr.ph.i.i, %B276.loopexit.i.i
  %lsr.iv.i = phi ptr [ %scevgep247.i, %B276.if.lr.ph.i.i ], [ %scevgep248.i, %B276.loopexit.i.i ]
  %lsr.iv29.i.i = phi ptr [ %scevgep28.i.i, %B276.if.lr.ph.i.i ], [ %scevgep30.i.i, %B276.loopexit.i.i ]
  %.375343349.i.i = phi i64 [ 0, %B276.if.lr.ph.i.i ], [ %.382.i.i, %B276.loopexit.i.i ]
  %.382.i.i = add nuw nsw i64 %.375343349.i.i, 1
  %.idx.i.i = mul i64 %.375343349.i.i, 24
  %31 = getelementptr i8, ptr %.415.i, i64 %.idx.i.i
  %.441.i.i = load double, ptr %31, align 8, !noalias !7
  %32 = getelementptr i8, ptr %31, i64 8
  %.474.i.i = load double, ptr %32, align 8, !noalias !7
  br i1 %27, label %B276.loopexit.i.i, label %B360.if.i.preheader.i

B360.if.i.preheader.i:                            ; preds = %B276.if.i.i
  br i1 %28, label %B360.if.i.epil.preheader.i, label %B360.if.i.i

B360.if.i.i:                                      ; preds = %B360.if.i.preheader.i, %B360.if.i.i
  %lsr.iv42.i = phi i64 [ %lsr.iv.next43.i, %B360.if.i.i ], [ %26, %B360.if.i.preheader.i ]
  %lsr.iv.i.i = phi i64 [ %lsr.iv.next.i.1.i, %B360.if.i.i ], [ 0, %B360.if.i.preheader.i ]
  %sunkaddr70.i = getelementptr i8, ptr %sunkaddr69.i, i64 %lsr.iv.i.i
  %.633.i.i = load double, ptr %sunkaddr70.i, align 8, !noalias !7
  %.635.i.i = fmul contract double %.441.i.i, %.633.i.i
  %33 = shl i64 %lsr.iv.i.i, 1
  %scevgep257.i = getelementptr i8, ptr %scevgep254.i, i64 %33
  %scevgep258.i = getelementptr i8, ptr %scevgep257.i, i64 -16
  %scevgep259.i = getelementptr i8, ptr %scevgep257.i, i64 -24
  %.666.i.i = load double, ptr %scevgep259.i, align 8, !noalias !7
  %.668.i.i = fmul contract double %.474.i.i, %.666.i.i
  %.669.i.i = fadd contract double %.635.i.i, %.668.i.i
  %scevgep46.i = getelementptr i8, ptr %lsr.iv.i, i64 %33
  %scevgep48.i = getelementptr i8, ptr %scevgep46.i, i64 -16
  %scevgep47.i = getelementptr i8, ptr %scevgep46.i, i64 -24
  store double %.669.i.i, ptr %scevgep47.i, align 8, !noalias !7
  %.731.i.i = load double, ptr %scevgep258.i, align 8, !noalias !7
  %.733.i.i = fmul contract double %.474.i.i, %.731.i.i
  store double %.733.i.i, ptr %scevgep48.i, align 8, !noalias !7
  %sunkaddr73.i = getelementptr i8, ptr %sunkaddr70.i, i64 8
  %.633.i.1.i = load double, ptr %sunkaddr73.i, align 8, !noalias !7
  %.635.i.1.i = fmul contract double %.441.i.i, %.633.i.1.i
  %scevgep50.i = getelementptr i8, ptr %scevgep257.i, i64 -8
  %.666.i.1.i = load double, ptr %scevgep50.i, align 8, !noalias !7
  %.668.i.1.i = fmul contract double %.474.i.i, %.666.i.1.i
  %.669.i.1.i = fadd contract double %.635.i.1.i, %.668.i.1.i
  %scevgep45.i = getelementptr i8, ptr %scevgep46.i, i64 -8
  store double %.669.i.1.i, ptr %scevgep45.i, align 8, !noalias !7
  %.731.i.1.i = load double, ptr %scevgep257.i, align 8, !noalias !7
  %.733.i.1.i = fmul contract double %.474.i.i, %.731.i.1.i
  store double %.733.i.1.i, ptr %scevgep46.i, align 8, !noalias !7
  %lsr.iv.next.i.1.i = add i64 %lsr.iv.i.i, 16
  %lsr.iv.next43.i = add i64 %lsr.iv42.i, 2
  %niter.ncmp.1.i = icmp eq i64 %lsr.iv.next43.i, 0
  br i1 %niter.ncmp.1.i, label %B276.loopexit.i.loopexit.unr-lcssa.i, label %B360.if.i.i

B930.endif.endif.endif.i:                         ; preds = %B276.loopexit.i.i, %_ZN17bnserve_inference6kernel7_source9_geometryB3v17B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i
  br i1 %18, label %.1574.if.i, label %.1574.endif.preheader.i, !prof !10

.1574.endif.preheader.i:                          ; preds = %B930.endif.endif.endif.i
  %.1266.i = load i64, ptr %sunkaddr74.i, align 8, !noalias !0
  %.1270.i = mul nsw i64 %.1021.sroa.0.052.i, %.1268.i
  %.1271.i = add nsw i64 %.1266.i, %.1270.i
  %.1274.i = inttoptr i64 %.1271.i to ptr
  tail call void @llvm.memset.p0.i64(ptr align 8 %.1274.i, i8 0, i64 %.1268.i, i1 false), !noalias !0
  br label %.1574.if.i

.1574.if.i:                                       ; preds = %.1574.endif.preheader.i, %B930.endif.endif.endif.i
  br i1 %19, label %.1962.if.i, label %.1962.endif.preheader.i, !prof !10

.1962.endif.preheader.i:                          ; preds = %.1574.if.i
  %.1654.i = load i64, ptr %sunkaddr75.i, align 8, !noalias !0
  %.1658.i = mul nsw i64 %.1021.sroa.0.052.i, %.1656.i
  %.1659.i = add nsw i64 %.1654.i, %.1658.i
  %.1662.i = inttoptr i64 %.1659.i to ptr
  tail call void @llvm.memset.p0.i64(ptr align 8 %.1662.i, i8 0, i64 %.1656.i, i1 false), !noalias !0
  br label %.1962.if.i

.1962.if.i:                                       ; preds = %.1962.endif.preheader.i, %.1574.if.i
  br i1 %20, label %.2353.endif.preheader.i, label %B1414.i

.2353.endif.preheader.i:                          ; preds = %.1962.if.i
  %.2045.i = load i64, ptr %.869.i, align 8, !noalias !0
  %.2049.i = mul nsw i64 %.1021.sroa.0.052.i, %.2047.i
  %.2050.i = add nsw i64 %.2045.i, %.2049.i
  %.2053.i = inttoptr i64 %.2050.i to ptr
  tail call void @llvm.memset.p0.i64(ptr align 8 %.2053.i, i8 0, i64 %.2047.i, i1 false), !noalias !0
  br label %B1414.i

B1458.if.lr.ph.i:                                 ; preds = %B1414.i
  %.264.i.i = shl i64 %.1021.sroa.0.052.i, 4
  br label %B1458.if.i

B1458.if.i:                                       ; preds = %B1458.if.lr.ph.i, %B1458.loopexit.i
  %lsr.iv265.i = phi i64 [ 0, %B1458.if.lr.ph.i ], [ %lsr.iv.next266.i, %B1458.loopexit.i ]
  %lsr.iv261.i = phi i64 [ %.755.i, %B1458.if.lr.ph.i ], [ %lsr.iv.next262.i, %B1458.loopexit.i ]
  %.248312171237.i = phi i64 [ %.2463.i, %B1458.if.lr.ph.i ], [ %.2493.i, %B1458.loopexit.i ]
  %.249012211236.i = phi i64 [ 0, %B1458.if.lr.ph.i ], [ %.2497.i, %B1458.loopexit.i ]
  %smin51.i = tail call i64 @llvm.smin.i64(i64 %lsr.iv261.i, i64 512)
  %34 = lshr exact i64 %smin51.i, 3
  %35 = add nuw nsw i64 %34, 4
  %.2493.i = add nsw i64 %.248312171237.i, -1
  %.2497.i = add i64 %.249012211236.i, 512
  %.2527.i = sub nsw i64 %.755.i, %.249012211236.i
  %.13.i.i = tail call i64 @llvm.smin.i64(i64 %.2527.i, i64 512)
  br i1 %.706618.not.i.i, label %B1458.loopexit.i, label %B1540.if.preheader.i

B1540.if.preheader.i:                             ; preds = %B1458.if.i
  %.137.i.i.i = lshr exact i64 %.13.i.i, 3
  %.114.inv.i.i.i = icmp slt i64 %.2527.i, 1
  %36 = add nuw nsw i64 %.137.i.i.i, 4
  %.104.i.i.i = icmp sgt i64 %.2527.i, 0
  %37 = shl nuw nsw i64 %.13.i.i, 3
  %unroll_iter.i.i.i = and i64 %.13.i.i, 9223372036854775800
  %38 = add nsw i64 %unroll_iter.i.i.i, -2
  %39 = lshr exact i64 %38, 1
  %40 = add nuw i64 %39, 1
  %41 = shl i64 %.249012211236.i, 3
  br label %B1540.if.i

B1540.if.i:                                       ; preds = %B1540.backedge.i, %B1540.if.preheader.i
  %.264512101214.i = phi i64 [ %.2652.i, %B1540.backedge.i ], [ 0, %B1540.if.preheader.i ]
  %.2652.i = add nuw nsw i64 %.264512101214.i, 1
  %.87.i.i = load i64, ptr %.76.i, align 8, !noalias !11
  %.117.i.i = load i64, ptr %.106.i, align 8, !noalias !11
  %.147.i.i = load i64, ptr %.711.i, align 8, !noalias !11
  %.187.i.i = load i64, ptr %.186.i8.i, align 8, !noalias !11
  %.191.i.i = mul i64 %.87.i.i, %.264.i.i
  %.193.i.i = mul i64 %.191.i.i, %.147.i.i
  %.194.i9.i = add nsw i64 %.193.i.i, %.187.i.i
  %.285.i.i = load i64, ptr %.284.i.i, align 8, !noalias !11
  %.343.i.i = shl nsw i64 %.117.i.i, 10
  %.381.inv.i.i = icmp sgt i64 %.117.i.i, 0
  %..343.i.i = select i1 %.381.inv.i.i, i64 %.343.i.i, i64 0
  %.4231066.i.i = icmp sgt i64 %..343.i.i, 0
  br i1 %.4231066.i.i, label %B328.if.preheader.i.i, label %B344.i.i

B328.if.preheader.i.i:                            ; preds = %B1540.if.i
  %42 = shl nuw i64 %..343.i.i, 3
  tail call void @llvm.memset.p0.i64(ptr nonnull align 8 %.625.i, i8 0, i64 %42, i1 false), !noalias !11
  br label %B344.i.i

B344.i.i:                                         ; preds = %B328.if.preheader.i.i, %B1540.if.i
  %.6111084.not.i.i = icmp slt i64 %.87.i.i, 1
  br i1 %.6111084.not.i.i, label %B696.i.i, label %B412.if.lr.ph.i.i

B696.i.i:                                         ; preds = %B414.endif.endif.endif.endif.endif.endif.endif.i.i, %B344.i.i
  %.1408.i.i = load i64, ptr %.1407.i.i, align 8, !noalias !11
  %.1413.i.i = icmp sgt i64 %.1408.i.i, 0
  br i1 %.1413.i.i, label %B746.i.i, label %_ZN17bnserve_inference12modes_kernel7_source7_gatherB3v25B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i

B746.i.i:                                         ; preds = %B696.i.i
  %.1416.i.i = shl nsw i64 %.1408.i.i, 3
  %.1446.i.i = load i64, ptr %arg.arguments, align 8, !noalias !11
  %.1448.i.i = mul nsw i64 %.1446.i.i, %.1021.sroa.0.052.i
  %.1452.i.i = add nsw i64 %.1448.i.i, %.264512101214.i
  %.1455.i13.i = mul nsw i64 %.1452.i.i, %.1416.i.i
  %.1460.i.i = sub i64 0, %.147.i.i
  %.1468.1.i.i = and i64 %.1460.i.i, -8
  %.1502.i14.i = sub i64 0, %.1468.1.i.i
  %.1533.i.i = load i64, ptr %.1532.i.i, align 8, !noalias !11
  %.1535.i.i = mul nsw i64 %.1408.i.i, %.1502.i14.i
  %.idx.i15.i = shl i64 %.117.i.i, 13
  %43 = getelementptr i8, ptr %.625.i, i64 %.idx.i15.i
  %.1672.i.i = getelementptr i8, ptr %43, i64 4096
  %.1858.i.i = load i64, ptr %.1857.i.i, align 8, !noalias !11
  %.1859.i.i = add nsw i64 %.1455.i13.i, %.1858.i.i
  br i1 %.104.i.i.i, label %B60.if.preheader.i.i.i, label %B128.if.lr.ph.i.i.i

B412.if.lr.ph.i.i:                                ; preds = %B344.i.i
  %.498.i10.i = sub nsw i64 %.147.i.i, %.249012211236.i
  %.13.i.i.i = tail call i64 @llvm.smin.i64(i64 %.498.i10.i, i64 range(i64 -9223372036854775799, 513) %.13.i.i)
  %.929.i.i = getelementptr inbounds double, ptr %.625.i, i64 %.343.i.i
  %.idx1039.i.i = shl i64 %.117.i.i, 13
  %44 = getelementptr i8, ptr %.625.i, i64 %.idx1039.i.i
  %.997.i.i = getelementptr i8, ptr %44, i64 4096
  %.1246.i.i = mul nuw nsw i64 %.87.i.i, %.264512101214.i
  %45 = inttoptr i64 %.285.i.i to ptr
  %46 = inttoptr i64 %.194.i9.i to ptr
  %.90.i.i.i = and i64 %.13.i.i.i, -8
  %47 = tail call i64 @llvm.smax.i64(i64 range(i64 -9223372036854775808, 513) %.13.i.i.i, i64 7)
  %storemerge.i.i.i = lshr i64 %47, 3
  %.176243.not.i.i.i = icmp eq i64 %storemerge.i.i.i, 0
  %.264.not.i.i.i = icmp eq i64 %.90.i.i.i, %.13.i.i.i
  %48 = add nuw nsw i64 %storemerge.i.i.i, 4
  %.276.i.i.i = getelementptr inbounds double, ptr %.929.i.i, i64 %.90.i.i.i
  %.289.i.i.i = getelementptr inbounds double, ptr %.997.i.i, i64 %.90.i.i.i
  %.334.i.i.i = and i64 %.13.i.i.i, 7
  %.377249.not.i.i.i = icmp eq i64 %.334.i.i.i, 0
  %.429.i.i.i = icmp slt i64 %.13.i.i.i, 0
  %49 = tail call i64 @llvm.smin.i64(i64 %.13.i.i.i, i64 0)
  %.430.i.i.i = shl i64 %49, 1
  %.idx.i.i.i = shl i64 %.90.i.i.i, 4
  %.460.i.i.i = select i1 %.429.i.i.i, i64 %.13.i.i, i64 0
  %.474.i.i.i = getelementptr double, ptr %.276.i.i.i, i64 %.460.i.i.i
  %.536.i.i.i = getelementptr double, ptr %.289.i.i.i, i64 %.460.i.i.i
  %.377.not.i.i.i = icmp eq i64 %.334.i.i.i, 1
  %.390.i.i.i = or disjoint i64 %.90.i.i.i, 1
  %.idx.1.i.i.i = shl i64 %.390.i.i.i, 4
  %50 = getelementptr double, ptr %.929.i.i, i64 %.390.i.i.i
  %.474.1.i.i.i = getelementptr double, ptr %50, i64 %.460.i.i.i
  %51 = getelementptr double, ptr %.997.i.i, i64 %.390.i.i.i
  %.536.1.i.i.i = getelementptr double, ptr %51, i64 %.460.i.i.i
  %.377.1.i.i.i = icmp samesign ugt i64 %.334.i.i.i, 2
  %.390.1.i.i.i = or disjoint i64 %.90.i.i.i, 2
  %.idx.2.i.i.i = shl i64 %.390.1.i.i.i, 4
  %52 = getelementptr double, ptr %.929.i.i, i64 %.390.1.i.i.i
  %.474.2.i.i.i = getelementptr double, ptr %52, i64 %.460.i.i.i
  %53 = getelementptr double, ptr %.997.i.i, i64 %.390.1.i.i.i
  %.536.2.i.i.i = getelementptr double, ptr %53, i64 %.460.i.i.i
  %.377.2.not.i.i.i = icmp eq i64 %.334.i.i.i, 3
  %.390.2.i.i.i = or disjoint i64 %.90.i.i.i, 3
  %.idx.3.i.i.i = shl i64 %.390.2.i.i.i, 4
  %54 = getelementptr double, ptr %.929.i.i, i64 %.390.2.i.i.i
  %.474.3.i.i.i = getelementptr double, ptr %54, i64 %.460.i.i.i
  %55 = getelementptr double, ptr %.997.i.i, i64 %.390.2.i.i.i
  %.536.3.i.i.i = getelementptr double, ptr %55, i64 %.460.i.i.i
  %.377.3.i.i.i = icmp samesign ugt i64 %.334.i.i.i, 4
  %.390.3.i.i.i = or disjoint i64 %.90.i.i.i, 4
  %.idx.4.i.i.i = shl i64 %.390.3.i.i.i, 4
  %56 = getelementptr double, ptr %.929.i.i, i64 %.390.3.i.i.i
  %.474.4.i.i.i = getelementptr double, ptr %56, i64 %.460.i.i.i
  %57 = getelementptr double, ptr %.997.i.i, i64 %.390.3.i.i.i
  %.536.4.i.i.i = getelementptr double, ptr %57, i64 %.460.i.i.i
  %.377.4.not.i.i.i = icmp eq i64 %.334.i.i.i, 5
  %.390.4.i.i.i = or disjoint i64 %.90.i.i.i, 5
  %.idx.5.i.i.i = shl i64 %.390.4.i.i.i, 4
  %58 = getelementptr double, ptr %.929.i.i, i64 %.390.4.i.i.i
  %.474.5.i.i.i = getelementptr double, ptr %58, i64 %.460.i.i.i
  %59 = getelementptr double, ptr %.997.i.i, i64 %.390.4.i.i.i
  %.536.5.i.i.i = getelementptr double, ptr %59, i64 %.460.i.i.i
  %.377.5.i.i.i = icmp eq i64 %.334.i.i.i, 7
  %.390.5.i.i.i = or disjoint i64 %.90.i.i.i, 6
  %.idx.6.i.i.i = shl i64 %.390.5.i.i.i, 4
  %60 = getelementptr double, ptr %.929.i.i, i64 %.390.5.i.i.i
  %.474.6.i.i.i = getelementptr double, ptr %60, i64 %.460.i.i.i
  %61 = getelementptr double, ptr %.997.i.i, i64 %.390.5.i.i.i
  %.536.6.i.i.i = getelementptr double, ptr %61, i64 %.460.i.i.i
  br label %B412.if.i.i

B412.if.i.i:                                      ; preds = %B414.endif.endif.endif.endif.endif.endif.endif.i.i, %B412.if.lr.ph.i.i
  %.61710771085.i.i = phi i64 [ 0, %B412.if.lr.ph.i.i ], [ %.624.i.i, %B414.endif.endif.endif.endif.endif.endif.endif.i.i ]
  %.624.i.i = add nuw nsw i64 %.61710771085.i.i, 1
  %62 = getelementptr i64, ptr %45, i64 %.61710771085.i.i
  %.679.i.i = load i64, ptr %62, align 8, !noalias !11
  %.698.idx.i.i = shl i64 %.679.i.i, 13
  %.1143.i.i = mul nsw i64 %.61710771085.i.i, %.147.i.i
  %.1145.i.i = add nsw i64 %.1143.i.i, %.249012211236.i
  %.1159.idx.i.i = shl nsw i64 %.1145.i.i, 4
  %.1159.i.i = getelementptr inbounds i8, ptr %46, i64 %.1159.idx.i.i
  br i1 %.176243.not.i.i.i, label %B196.i.i.i, label %B84.if.i.i.i

B196.i.i.i:                                       ; preds = %B84.if.i.i.i, %B412.if.i.i
  br i1 %.264.not.i.i.i, label %_ZN17bnserve_surrogate7adjoint5_sums5splitB3v46B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i.i, label %B208.i.i.i

B208.i.i.i:                                       ; preds = %B196.i.i.i
  store <8 x double> zeroinitializer, ptr %.276.i.i.i, align 8, !noalias !14
  store <8 x double> zeroinitializer, ptr %.289.i.i.i, align 8, !noalias !14
  br i1 %.377249.not.i.i.i, label %_ZN17bnserve_surrogate7adjoint5_sums5splitB3v46B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i.i, label %B360.if.i.i.i

B84.if.i.i.i:                                     ; preds = %B412.if.i.i, %B84.if.i.i.i
  %lsr.iv2.i.i.i = phi i64 [ %lsr.iv.next3.i.i.i, %B84.if.i.i.i ], [ %48, %B412.if.i.i ]
  %lsr.iv1.i.i.i = phi i64 [ %lsr.iv.next2.i.i.i, %B84.if.i.i.i ], [ 0, %B412.if.i.i ]
  %63 = shl nuw i64 %lsr.iv1.i.i.i, 1
  %scevgep.i.i.i = getelementptr i8, ptr %.1159.i.i, i64 %63
  %.224.i.i.i = load <16 x double>, ptr %scevgep.i.i.i, align 8, !noalias !14
  %.225.i.i.i = shufflevector <16 x double> %.224.i.i.i, <16 x double> poison, <8 x i32> <i32 0, i32 2, i32 4, i32 6, i32 8, i32 10, i32 12, i32 14>
  %.226.i.i.i = shufflevector <16 x double> %.224.i.i.i, <16 x double> poison, <8 x i32> <i32 1, i32 3, i32 5, i32 7, i32 9, i32 11, i32 13, i32 15>
  %scevgep4.i.i.i = getelementptr i8, ptr %.929.i.i, i64 %lsr.iv1.i.i.i
  store <8 x double> %.225.i.i.i, ptr %scevgep4.i.i.i, align 8, !noalias !14
  %scevgep3.i.i.i = getelementptr i8, ptr %.997.i.i, i64 %lsr.iv1.i.i.i
  store <8 x double> %.226.i.i.i, ptr %scevgep3.i.i.i, align 8, !noalias !14
  %lsr.iv.next2.i.i.i = add nuw nsw i64 %lsr.iv1.i.i.i, 64
  %lsr.iv.next3.i.i.i = add nsw i64 %lsr.iv2.i.i.i, -1
  %.176.i.i.i = icmp sgt i64 %lsr.iv2.i.i.i, 5
  br i1 %.176.i.i.i, label %B84.if.i.i.i, label %B196.i.i.i

B360.if.i.i.i:                                    ; preds = %B208.i.i.i
  %64 = getelementptr i8, ptr %.1159.i.i, i64 %.idx.i.i.i
  %.444.i.i.i = getelementptr double, ptr %64, i64 %.430.i.i.i
  %.445.i.i.i = load double, ptr %.444.i.i.i, align 8, !noalias !14
  store double %.445.i.i.i, ptr %.474.i.i.i, align 8, !noalias !14
  %65 = getelementptr i8, ptr %64, i64 8
  %.506.i.i.i = getelementptr double, ptr %65, i64 %.430.i.i.i
  %.507.i.i.i = load double, ptr %.506.i.i.i, align 8, !noalias !14
  store double %.507.i.i.i, ptr %.536.i.i.i, align 8, !noalias !14
  br i1 %.377.not.i.i.i, label %_ZN17bnserve_surrogate7adjoint5_sums5splitB3v46B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i.i, label %B360.if.1.i.i.i

B360.if.1.i.i.i:                                  ; preds = %B360.if.i.i.i
  %66 = getelementptr i8, ptr %.1159.i.i, i64 %.idx.1.i.i.i
  %.444.1.i.i.i = getelementptr double, ptr %66, i64 %.430.i.i.i
  %.445.1.i.i.i = load double, ptr %.444.1.i.i.i, align 8, !noalias !14
  store double %.445.1.i.i.i, ptr %.474.1.i.i.i, align 8, !noalias !14
  %67 = getelementptr i8, ptr %66, i64 8
  %.506.1.i.i.i = getelementptr double, ptr %67, i64 %.430.i.i.i
  %.507.1.i.i.i = load double, ptr %.506.1.i.i.i, align 8, !noalias !14
  store double %.507.1.i.i.i, ptr %.536.1.i.i.i, align 8, !noalias !14
  br i1 %.377.1.i.i.i, label %B360.if.2.i.i.i, label %_ZN17bnserve_surrogate7adjoint5_sums5splitB3v46B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i.i

B360.if.2.i.i.i:                                  ; preds = %B360.if.1.i.i.i
  %68 = getelementptr i8, ptr %.1159.i.i, i64 %.idx.2.i.i.i
  %.444.2.i.i.i = getelementptr double, ptr %68, i64 %.430.i.i.i
  %.445.2.i.i.i = load double, ptr %.444.2.i.i.i, align 8, !noalias !14
  store double %.445.2.i.i.i, ptr %.474.2.i.i.i, align 8, !noalias !14
  %69 = getelementptr i8, ptr %68, i64 8
  %.506.2.i.i.i = getelementptr double, ptr %69, i64 %.430.i.i.i
  %.507.2.i.i.i = load double, ptr %.506.2.i.i.i, align 8, !noalias !14
  store double %.507.2.i.i.i, ptr %.536.2.i.i.i, align 8, !noalias !14
  br i1 %.377.2.not.i.i.i, label %_ZN17bnserve_surrogate7adjoint5_sums5splitB3v46B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i.i, label %B360.if.3.i.i.i

B360.if.3.i.i.i:                                  ; preds = %B360.if.2.i.i.i
  %70 = getelementptr i8, ptr %.1159.i.i, i64 %.idx.3.i.i.i
  %.444.3.i.i.i = getelementptr double, ptr %70, i64 %.430.i.i.i
  %.445.3.i.i.i = load double, ptr %.444.3.i.i.i, align 8, !noalias !14
  store double %.445.3.i.i.i, ptr %.474.3.i.i.i, align 8, !noalias !14
  %71 = getelementptr i8, ptr %70, i64 8
  %.506.3.i.i.i = getelementptr double, ptr %71, i64 %.430.i.i.i
  %.507.3.i.i.i = load double, ptr %.506.3.i.i.i, align 8, !noalias !14
  store double %.507.3.i.i.i, ptr %.536.3.i.i.i, align 8, !noalias !14
  br i1 %.377.3.i.i.i, label %B360.if.4.i.i.i, label %_ZN17bnserve_surrogate7adjoint5_sums5splitB3v46B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i.i

B360.if.4.i.i.i:                                  ; preds = %B360.if.3.i.i.i
  %72 = getelementptr i8, ptr %.1159.i.i, i64 %.idx.4.i.i.i
  %.444.4.i.i.i = getelementptr double, ptr %72, i64 %.430.i.i.i
  %.445.4.i.i.i = load double, ptr %.444.4.i.i.i, align 8, !noalias !14
  store double %.445.4.i.i.i, ptr %.474.4.i.i.i, align 8, !noalias !14
  %73 = getelementptr i8, ptr %72, i64 8
  %.506.4.i.i.i = getelementptr double, ptr %73, i64 %.430.i.i.i
  %.507.4.i.i.i = load double, ptr %.506.4.i.i.i, align 8, !noalias !14
  store double %.507.4.i.i.i, ptr %.536.4.i.i.i, align 8, !noalias !14
  br i1 %.377.4.not.i.i.i, label %_ZN17bnserve_surrogate7adjoint5_sums5splitB3v46B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i.i, label %B360.if.5.i.i.i

B360.if.5.i.i.i:                                  ; preds = %B360.if.4.i.i.i
  %74 = getelementptr i8, ptr %.1159.i.i, i64 %.idx.5.i.i.i
  %.444.5.i.i.i = getelementptr double, ptr %74, i64 %.430.i.i.i
  %.445.5.i.i.i = load double, ptr %.444.5.i.i.i, align 8, !noalias !14
  store double %.445.5.i.i.i, ptr %.474.5.i.i.i, align 8, !noalias !14
  %75 = getelementptr i8, ptr %74, i64 8
  %.506.5.i.i.i = getelementptr double, ptr %75, i64 %.430.i.i.i
  %.507.5.i.i.i = load double, ptr %.506.5.i.i.i, align 8, !noalias !14
  store double %.507.5.i.i.i, ptr %.536.5.i.i.i, align 8, !noalias !14
  br i1 %.377.5.i.i.i, label %B360.if.6.i.i.i, label %_ZN17bnserve_surrogate7adjoint5_sums5splitB3v46B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i.i

B360.if.6.i.i.i:                                  ; preds = %B360.if.5.i.i.i
  %76 = getelementptr i8, ptr %.1159.i.i, i64 %.idx.6.i.i.i
  %.444.6.i.i.i = getelementptr double, ptr %76, i64 %.430.i.i.i
  %.445.6.i.i.i = load double, ptr %.444.6.i.i.i, align 8, !noalias !14
  store double %.445.6.i.i.i, ptr %.474.6.i.i.i, align 8, !noalias !14
  %77 = getelementptr i8, ptr %76, i64 8
  %.506.6.i.i.i = getelementptr double, ptr %77, i64 %.430.i.i.i
  %.507.6.i.i.i = load double, ptr %.506.6.i.i.i, align 8, !noalias !14
  store double %.507.6.i.i.i, ptr %.536.6.i.i.i, align 8, !noalias !14
  br label %_ZN17bnserve_surrogate7adjoint5_sums5splitB3v46B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i.i

_ZN17bnserve_surrogate7adjoint5_sums5splitB3v46B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i.i: ; preds = %B360.if.6.i.i.i, %B360.if.5.i.i.i, %B360.if.4.i.i.i, %B360.if.3.i.i.i, %B360.if.2.i.i.i, %B360.if.1.i.i.i, %B360.if.i.i.i, %B208.i.i.i, %B196.i.i.i
  br i1 %.114.inv.i.i.i, label %B414.endif.endif.endif.endif.endif.endif.endif.i.i, label %B70.if.lr.ph.i.i.i

B70.if.lr.ph.i.i.i:                               ; preds = %_ZN17bnserve_surrogate7adjoint5_sums5splitB3v46B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i.i
  %.1247.i.i = add nuw nsw i64 %.61710771085.i.i, %.1246.i.i
  %.idx35.i.i = shl i64 %.1247.i.i, 4
  %78 = getelementptr i8, ptr %.547.i, i64 %.idx35.i.i
  %79 = getelementptr i8, ptr %78, i64 8
  %.1310.i.i = load double, ptr %79, align 8, !noalias !11
  %.1279.i.i = load double, ptr %78, align 8, !noalias !11
  %.217.i.i.i = fneg contract double %.1310.i.i
  %.228.i.i.i = insertelement <8 x double> poison, double %.217.i.i.i, i64 0
  %.229.i.i.i = shufflevector <8 x double> %.228.i.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.232.i.i.i = insertelement <8 x double> poison, double %.1279.i.i, i64 0
  %.233.i.i.i = shufflevector <8 x double> %.232.i.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.256.i.i12.i = insertelement <8 x double> poison, double %.1310.i.i, i64 0
  %.257.i.i.i = shufflevector <8 x double> %.256.i.i12.i, <8 x double> poison, <8 x i32> zeroinitializer
  br label %B70.if.i.i.i

B70.if.i.i.i:                                     ; preds = %B70.if.i.i.i, %B70.if.lr.ph.i.i.i
  %lsr.iv38.i.i = phi i64 [ %lsr.iv.next39.i.i, %B70.if.i.i.i ], [ %36, %B70.if.lr.ph.i.i.i ]
  %lsr.iv342.i.i = phi ptr [ %scevgep343.i.i, %B70.if.i.i.i ], [ %scevgep341.i.i, %B70.if.lr.ph.i.i.i ]
  %scevgep348.i.i = getelementptr i8, ptr %lsr.iv342.i.i, i64 %.idx1039.i.i
  %scevgep349.i.i = getelementptr i8, ptr %scevgep348.i.i, i64 -4096
  %.205.i.i.i = load <8 x double>, ptr %scevgep349.i.i, align 8, !noalias !17
  %.215.i.i.i = load <8 x double>, ptr %scevgep348.i.i, align 8, !noalias !17
  %scevgep345.i.i = getelementptr i8, ptr %lsr.iv342.i.i, i64 %.698.idx.i.i
  %scevgep346.i.i = getelementptr i8, ptr %scevgep345.i.i, i64 -4096
  %.227.i.i.i = load <8 x double>, ptr %scevgep346.i.i, align 8, !noalias !17
  %.230.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.215.i.i.i, <8 x double> %.229.i.i.i, <8 x double> %.227.i.i.i)
  %.234.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.205.i.i.i, <8 x double> %.233.i.i.i, <8 x double> %.230.i.i.i)
  store <8 x double> %.234.i.i.i, ptr %scevgep346.i.i, align 8, !noalias !17
  %.254.i.i.i = load <8 x double>, ptr %scevgep345.i.i, align 8, !noalias !17
  %.258.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.205.i.i.i, <8 x double> %.257.i.i.i, <8 x double> %.254.i.i.i)
  %.262.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.215.i.i.i, <8 x double> %.233.i.i.i, <8 x double> %.258.i.i.i)
  store <8 x double> %.262.i.i.i, ptr %scevgep345.i.i, align 8, !noalias !17
  %scevgep343.i.i = getelementptr i8, ptr %lsr.iv342.i.i, i64 64
  %lsr.iv.next39.i.i = add nsw i64 %lsr.iv38.i.i, -1
  %.158.i.i.i = icmp sgt i64 %lsr.iv38.i.i, 5
  br i1 %.158.i.i.i, label %B70.if.i.i.i, label %B414.endif.endif.endif.endif.endif.endif.endif.i.i

B414.endif.endif.endif.endif.endif.endif.endif.i.i: ; preds = %B70.if.i.i.i, %_ZN17bnserve_surrogate7adjoint5_sums5splitB3v46B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i.i
  %exitcond1134.not.i.i = icmp eq i64 %.624.i.i, %.87.i.i
  br i1 %exitcond1134.not.i.i, label %B696.i.i, label %B412.if.i.i

B60.if.preheader.i.i.i:                           ; preds = %B746.i.i
  %.1604.i.i = getelementptr inbounds double, ptr %.625.i, i64 %.343.i.i
  tail call void @llvm.memset.p0.i64(ptr nonnull align 8 %.1604.i.i, i8 0, i64 %37, i1 false), !noalias !20
  br label %B128.if.lr.ph.i.i.i

B128.if.lr.ph.i.i.i:                              ; preds = %B60.if.preheader.i.i.i, %B746.i.i
  %80 = inttoptr i64 %.1533.i.i to ptr
  %scevgep323.i.i = getelementptr i8, ptr %43, i64 24
  %scevgep331.i.i = getelementptr i8, ptr %80, i64 24
  %81 = inttoptr i64 %.1859.i.i to ptr
  br label %B128.if.i.i.i

B284.i.i.i:                                       ; preds = %B228.if.i.i.i, %B130.else.endif.endif.endif.endif.i.i.i
  %exitcond292.not.i.i.i = icmp eq i64 %.324.i.i.i, %.1408.i.i
  br i1 %exitcond292.not.i.i.i, label %B746.endif.endif.endif.endif.endif.endif.i.i, label %B128.if.i.i.i

B128.if.i.i.i:                                    ; preds = %B284.i.i.i, %B128.if.lr.ph.i.i.i
  %.317279285.i.i.i = phi i64 [ 0, %B128.if.lr.ph.i.i.i ], [ %.324.i.i.i, %B284.i.i.i ]
  %.324.i.i.i = add nuw nsw i64 %.317279285.i.i.i, 1
  %.350.i.i.i = mul nsw i64 %.317279285.i.i.i, %.1502.i14.i
  %.352.i.i.i = add nsw i64 %.350.i.i.i, %.249012211236.i
  %.395.i.i.i = icmp slt i64 %.352.i.i.i, 0
  %.396.i.i.i = select i1 %.395.i.i.i, i64 %.1535.i.i, i64 0
  %.397.i.i.i = add i64 %.396.i.i.i, %.352.i.i.i
  %.400.i.i.i = icmp slt i64 %.397.i.i.i, 0
  br i1 %.400.i.i.i, label %B130.else.if.i.i.i, label %B130.else.endif.i.i.i, !prof !10

B130.else.if.i.i.i:                               ; preds = %B128.if.i.i.i
  br label %B130.else.endif.i.i.i

B130.else.endif.i.i.i:                            ; preds = %B130.else.if.i.i.i, %B128.if.i.i.i
  %.385.sroa.0.1.i.i.i = phi i64 [ 0, %B130.else.if.i.i.i ], [ %.397.i.i.i, %B128.if.i.i.i ]
  %.405.not.i.i.i = icmp slt i64 %.397.i.i.i, %.1535.i.i
  br i1 %.405.not.i.i.i, label %B130.else.endif.endif.endif.endif.i.i.i, label %B130.else.endif.if.i.i.i, !prof !6

B130.else.endif.if.i.i.i:                         ; preds = %B130.else.endif.i.i.i
  br label %B130.else.endif.endif.endif.endif.i.i.i

B130.else.endif.endif.endif.endif.i.i.i:          ; preds = %B130.else.endif.if.i.i.i, %B130.else.endif.i.i.i
  %.385.sroa.0.3.i.i.i = phi i64 [ %.1535.i.i, %B130.else.endif.if.i.i.i ], [ %.385.sroa.0.1.i.i.i, %B130.else.endif.i.i.i ]
  %82 = getelementptr double, ptr %81, i64 %.317279285.i.i.i
  %.565.i.i.i = load double, ptr %82, align 8, !noalias !20
  br i1 %.114.inv.i.i.i, label %B284.i.i.i, label %B228.if.preheader.i.i.i

B228.if.preheader.i.i.i:                          ; preds = %B130.else.endif.endif.endif.endif.i.i.i
  %83 = shl i64 %.385.sroa.0.3.i.i.i, 3
  %scevgep332.i.i = getelementptr i8, ptr %scevgep331.i.i, i64 %83
  br label %B228.if.i.i.i

B228.if.i.i.i:                                    ; preds = %B228.if.i.i.i, %B228.if.preheader.i.i.i
  %lsr.iv25.i.i = phi i64 [ %lsr.iv.next26.i.i, %B228.if.i.i.i ], [ %40, %B228.if.preheader.i.i.i ]
  %.655272274.i.i.i = phi i64 [ %.662.1.i.1.i.i, %B228.if.i.i.i ], [ 0, %B228.if.preheader.i.i.i ]
  %84 = shl i64 %.655272274.i.i.i, 3
  %scevgep329.i.i = getelementptr i8, ptr %scevgep323.i.i, i64 %84
  %scevgep330.i.i = getelementptr i8, ptr %scevgep329.i.i, i64 -24
  %.716.i.i.i = load double, ptr %scevgep330.i.i, align 8, !noalias !20
  %scevgep335.i.i = getelementptr i8, ptr %scevgep332.i.i, i64 %84
  %scevgep336.i.i = getelementptr i8, ptr %scevgep335.i.i, i64 -16
  %scevgep33.i.i = getelementptr i8, ptr %scevgep335.i.i, i64 -24
  %.746.i.i.i = load double, ptr %scevgep33.i.i, align 8, !noalias !20
  %.748.i.i.i = fmul contract double %.565.i.i.i, %.746.i.i.i
  %.749.i.i.i = fadd contract double %.716.i.i.i, %.748.i.i.i
  store double %.749.i.i.i, ptr %scevgep330.i.i, align 8, !noalias !20
  %scevgep37.i.i = getelementptr i8, ptr %scevgep329.i.i, i64 -16
  %.716.1.i.i.i = load double, ptr %scevgep37.i.i, align 8, !noalias !20
  %.746.1.i.i.i = load double, ptr %scevgep336.i.i, align 8, !noalias !20
  %.748.1.i.i.i = fmul contract double %.565.i.i.i, %.746.1.i.i.i
  %.749.1.i.i.i = fadd contract double %.716.1.i.i.i, %.748.1.i.i.i
  store double %.749.1.i.i.i, ptr %scevgep37.i.i, align 8, !noalias !20
  %scevgep35.i.i = getelementptr i8, ptr %scevgep329.i.i, i64 -8
  %.716.i.1.i.i = load double, ptr %scevgep35.i.i, align 8, !noalias !20
  %scevgep30.i16.i = getelementptr i8, ptr %scevgep335.i.i, i64 -8
  %.746.i.1.i.i = load double, ptr %scevgep30.i16.i, align 8, !noalias !20
  %.748.i.1.i.i = fmul contract double %.565.i.i.i, %.746.i.1.i.i
  %.749.i.1.i.i = fadd contract double %.716.i.1.i.i, %.748.i.1.i.i
  store double %.749.i.1.i.i, ptr %scevgep35.i.i, align 8, !noalias !20
  %.662.1.i.1.i.i = add i64 %.655272274.i.i.i, 4
  %.716.1.i.1.i.i = load double, ptr %scevgep329.i.i, align 8, !noalias !20
  %.746.1.i.1.i.i = load double, ptr %scevgep335.i.i, align 8, !noalias !20
  %.748.1.i.1.i.i = fmul contract double %.565.i.i.i, %.746.1.i.1.i.i
  %.749.1.i.1.i.i = fadd contract double %.716.1.i.1.i.i, %.748.1.i.1.i.i
  store double %.749.1.i.1.i.i, ptr %scevgep329.i.i, align 8, !noalias !20
  %lsr.iv.next26.i.i = add i64 %lsr.iv25.i.i, -2
  %niter.ncmp.1.i.i = icmp eq i64 %lsr.iv.next26.i.i, 0
  br i1 %niter.ncmp.1.i.i, label %B284.i.i.i, label %B228.if.i.i.i

B746.endif.endif.endif.endif.endif.endif.i.i:     ; preds = %B284.i.i.i
  %.1975.i.i = load i64, ptr %.1974.i.i, align 8, !noalias !11
  %.1981.i.i = add nsw i64 %.1975.i.i, %.1455.i13.i
  br i1 %.104.i.i.i, label %B60.if.preheader.i143.i.i, label %B128.if.lr.ph.i94.i.i

B60.if.preheader.i143.i.i:                        ; preds = %B746.endif.endif.endif.endif.endif.endif.i.i
  tail call void @llvm.memset.p0.i64(ptr align 8 %.1672.i.i, i8 0, i64 %37, i1 false), !noalias !23
  br label %B128.if.lr.ph.i94.i.i

B128.if.lr.ph.i94.i.i:                            ; preds = %B60.if.preheader.i143.i.i, %B746.endif.endif.endif.endif.endif.endif.i.i
  %scevgep305.i.i = getelementptr i8, ptr %43, i64 4120
  %85 = inttoptr i64 %.1981.i.i to ptr
  br label %B128.if.i97.i.i

B284.i140.i.i:                                    ; preds = %B228.if.i117.i.i, %B130.else.endif.endif.endif.endif.i110.i.i
  %exitcond292.not.i141.i.i = icmp eq i64 %.324.i99.i.i, %.1408.i.i
  br i1 %exitcond292.not.i141.i.i, label %B746.endif.endif.endif.endif.endif.endif.endif.endif.i.i, label %B128.if.i97.i.i

B128.if.i97.i.i:                                  ; preds = %B284.i140.i.i, %B128.if.lr.ph.i94.i.i
  %.317279285.i98.i.i = phi i64 [ 0, %B128.if.lr.ph.i94.i.i ], [ %.324.i99.i.i, %B284.i140.i.i ]
  %.324.i99.i.i = add nuw nsw i64 %.317279285.i98.i.i, 1
  %.350.i100.i.i = mul nsw i64 %.317279285.i98.i.i, %.1502.i14.i
  %.352.i101.i.i = add nsw i64 %.350.i100.i.i, %.249012211236.i
  %.395.i102.i.i = icmp slt i64 %.352.i101.i.i, 0
  %.396.i103.i.i = select i1 %.395.i102.i.i, i64 %.1535.i.i, i64 0
  %.397.i104.i.i = add i64 %.396.i103.i.i, %.352.i101.i.i
  %.400.i105.i.i = icmp slt i64 %.397.i104.i.i, 0
  br i1 %.400.i105.i.i, label %B130.else.if.i142.i.i, label %B130.else.endif.i106.i.i, !prof !10

B130.else.if.i142.i.i:                            ; preds = %B128.if.i97.i.i
  br label %B130.else.endif.i106.i.i

B130.else.endif.i106.i.i:                         ; preds = %B130.else.if.i142.i.i, %B128.if.i97.i.i
  %.385.sroa.0.1.i107.i.i = phi i64 [ 0, %B130.else.if.i142.i.i ], [ %.397.i104.i.i, %B128.if.i97.i.i ]
  %.405.not.i108.i.i = icmp slt i64 %.397.i104.i.i, %.1535.i.i
  br i1 %.405.not.i108.i.i, label %B130.else.endif.endif.endif.endif.i110.i.i, label %B130.else.endif.if.i109.i.i, !prof !6

B130.else.endif.if.i109.i.i:                      ; preds = %B130.else.endif.i106.i.i
  br label %B130.else.endif.endif.endif.endif.i110.i.i

B130.else.endif.endif.endif.endif.i110.i.i:       ; preds = %B130.else.endif.if.i109.i.i, %B130.else.endif.i106.i.i
  %.385.sroa.0.3.i111.i.i = phi i64 [ %.1535.i.i, %B130.else.endif.if.i109.i.i ], [ %.385.sroa.0.1.i107.i.i, %B130.else.endif.i106.i.i ]
  %86 = getelementptr double, ptr %85, i64 %.317279285.i98.i.i
  %.565.i113.i.i = load double, ptr %86, align 8, !noalias !23
  br i1 %.114.inv.i.i.i, label %B284.i140.i.i, label %B228.if.preheader.i114.i.i

B228.if.preheader.i114.i.i:                       ; preds = %B130.else.endif.endif.endif.endif.i110.i.i
  %87 = shl i64 %.385.sroa.0.3.i111.i.i, 3
  %scevgep314.i.i = getelementptr i8, ptr %scevgep331.i.i, i64 %87
  br label %B228.if.i117.i.i

B228.if.i117.i.i:                                 ; preds = %B228.if.i117.i.i, %B228.if.preheader.i114.i.i
  %lsr.iv11.i.i = phi i64 [ %lsr.iv.next12.i.i, %B228.if.i117.i.i ], [ %40, %B228.if.preheader.i114.i.i ]
  %.655272274.i118.i.i = phi i64 [ %.662.1.i126.1.i.i, %B228.if.i117.i.i ], [ 0, %B228.if.preheader.i114.i.i ]
  %88 = shl i64 %.655272274.i118.i.i, 3
  %scevgep311.i.i = getelementptr i8, ptr %scevgep305.i.i, i64 %88
  %scevgep312.i.i = getelementptr i8, ptr %scevgep311.i.i, i64 -24
  %.716.i120.i.i = load double, ptr %scevgep312.i.i, align 8, !noalias !23
  %scevgep317.i.i = getelementptr i8, ptr %scevgep314.i.i, i64 %88
  %scevgep318.i.i = getelementptr i8, ptr %scevgep317.i.i, i64 -16
  %scevgep18.i.i = getelementptr i8, ptr %scevgep317.i.i, i64 -24
  %.746.i123.i.i = load double, ptr %scevgep18.i.i, align 8, !noalias !23
  %.748.i124.i.i = fmul contract double %.565.i113.i.i, %.746.i123.i.i
  %.749.i125.i.i = fadd contract double %.716.i120.i.i, %.748.i124.i.i
  store double %.749.i125.i.i, ptr %scevgep312.i.i, align 8, !noalias !23
  %scevgep24.i.i = getelementptr i8, ptr %scevgep311.i.i, i64 -16
  %.716.1.i128.i.i = load double, ptr %scevgep24.i.i, align 8, !noalias !23
  %.746.1.i129.i.i = load double, ptr %scevgep318.i.i, align 8, !noalias !23
  %.748.1.i130.i.i = fmul contract double %.565.i113.i.i, %.746.1.i129.i.i
  %.749.1.i131.i.i = fadd contract double %.716.1.i128.i.i, %.748.1.i130.i.i
  store double %.749.1.i131.i.i, ptr %scevgep24.i.i, align 8, !noalias !23
  %scevgep22.i.i = getelementptr i8, ptr %scevgep311.i.i, i64 -8
  %.716.i120.1.i.i = load double, ptr %scevgep22.i.i, align 8, !noalias !23
  %scevgep14.i.i = getelementptr i8, ptr %scevgep317.i.i, i64 -8
  %.746.i123.1.i.i = load double, ptr %scevgep14.i.i, align 8, !noalias !23
  %.748.i124.1.i.i = fmul contract double %.565.i113.i.i, %.746.i123.1.i.i
  %.749.i125.1.i.i = fadd contract double %.716.i120.1.i.i, %.748.i124.1.i.i
  store double %.749.i125.1.i.i, ptr %scevgep22.i.i, align 8, !noalias !23
  %.662.1.i126.1.i.i = add i64 %.655272274.i118.i.i, 4
  %.716.1.i128.1.i.i = load double, ptr %scevgep311.i.i, align 8, !noalias !23
  %.746.1.i129.1.i.i = load double, ptr %scevgep317.i.i, align 8, !noalias !23
  %.748.1.i130.1.i.i = fmul contract double %.565.i113.i.i, %.746.1.i129.1.i.i
  %.749.1.i131.1.i.i = fadd contract double %.716.1.i128.1.i.i, %.748.1.i130.1.i.i
  store double %.749.1.i131.1.i.i, ptr %scevgep311.i.i, align 8, !noalias !23
  %lsr.iv.next12.i.i = add i64 %lsr.iv11.i.i, -2
  %niter294.ncmp.1.i.i = icmp eq i64 %lsr.iv.next12.i.i, 0
  br i1 %niter294.ncmp.1.i.i, label %B284.i140.i.i, label %B228.if.i117.i.i

B746.endif.endif.endif.endif.endif.endif.endif.endif.i.i: ; preds = %B284.i140.i.i
  %.21551095.not.i.i = icmp slt i64 %.117.i.i, 1
  br i1 %.21551095.not.i.i, label %_ZN17bnserve_inference12modes_kernel7_source7_gatherB3v25B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i, label %B1186.if.i.i

B1186.if.i.i:                                     ; preds = %B746.endif.endif.endif.endif.endif.endif.endif.endif.i.i, %B1188.endif.endif.endif.i.i
  %lsr.iv.i17.i = phi i64 [ %lsr.iv.next.i21.i, %B1188.endif.endif.endif.i.i ], [ 4096, %B746.endif.endif.endif.endif.endif.endif.endif.endif.i.i ]
  %.216110921096.i.i = phi i64 [ %.2168.i.i, %B1188.endif.endif.endif.i.i ], [ 0, %B746.endif.endif.endif.endif.endif.endif.endif.endif.i.i ]
  %.2168.i.i = add nuw nsw i64 %.216110921096.i.i, 1
  br i1 %.114.inv.i.i.i, label %B1188.endif.endif.endif.i.i, label %B70.if.i155.i.i

B70.if.i155.i.i:                                  ; preds = %B1186.if.i.i, %B70.if.i155.i.i
  %lsr.iv7.i.i = phi i64 [ %lsr.iv.next8.i.i, %B70.if.i155.i.i ], [ %36, %B1186.if.i.i ]
  %lsr.iv296.i.i = phi ptr [ %scevgep.i.i, %B70.if.i155.i.i ], [ %.625.i, %B1186.if.i.i ]
  %sunkaddr.i18.i = getelementptr i8, ptr %lsr.iv296.i.i, i64 %.idx.i15.i
  %sunkaddr40.i.i = getelementptr i8, ptr %sunkaddr.i18.i, i64 4096
  %.199.i.i.i = load <8 x double>, ptr %sunkaddr40.i.i, align 8, !noalias !26
  %.209.i.i.i = load <8 x double>, ptr %sunkaddr.i18.i, align 8, !noalias !26
  %.8.i.i.i19.i = fadd contract <8 x double> %.209.i.i.i, splat (double 1.000000e+00)
  %.236.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.199.i.i.i, <8 x double> %.199.i.i.i, <8 x double> splat (double 4.000000e+00))
  %.6.i.i.i20.i = fdiv contract <8 x double> %.8.i.i.i19.i, %.236.i.i.i
  %scevgep298.i.i = getelementptr i8, ptr %lsr.iv296.i.i, i64 %lsr.iv.i17.i
  %scevgep299.i.i = getelementptr i8, ptr %scevgep298.i.i, i64 -4096
  %.271.i.i.i = load <8 x double>, ptr %scevgep299.i.i, align 8, !noalias !26
  %.281.i.i.i = load <8 x double>, ptr %scevgep298.i.i, align 8, !noalias !26
  %.6.i56.i.i.i = fmul contract <8 x double> %.199.i.i.i, %.199.i.i.i
  %.8.i57.i.i.i = fsub contract <8 x double> splat (double 4.000000e+00), %.6.i56.i.i.i
  %.6.i58.i.i.i = fmul contract <8 x double> %.8.i57.i.i.i, %.6.i.i.i20.i
  %.8.i59.i.i.i = fmul contract <8 x double> %.199.i.i.i, splat (double 4.000000e+00)
  %.6.i60.i.i.i = fmul contract <8 x double> %.8.i59.i.i.i, %.6.i.i.i20.i
  %.6.i61.i.i.i = fmul contract <8 x double> %.281.i.i.i, %.6.i60.i.i.i
  %.8.i62.i.i.i = fsub contract <8 x double> zeroinitializer, %.6.i61.i.i.i
  %.6.i63.i.i.i = fmul contract <8 x double> %.281.i.i.i, %.6.i58.i.i.i
  %.450.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.271.i.i.i, <8 x double> %.6.i58.i.i.i, <8 x double> %.8.i62.i.i.i)
  %.475.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.271.i.i.i, <8 x double> %.6.i60.i.i.i, <8 x double> %.6.i63.i.i.i)
  store <8 x double> %.450.i.i.i, ptr %scevgep299.i.i, align 8, !noalias !26
  store <8 x double> %.475.i.i.i, ptr %scevgep298.i.i, align 8, !noalias !26
  %scevgep.i.i = getelementptr i8, ptr %lsr.iv296.i.i, i64 64
  %lsr.iv.next8.i.i = add nsw i64 %lsr.iv7.i.i, -1
  %.152.i.i.i = icmp sgt i64 %lsr.iv7.i.i, 5
  br i1 %.152.i.i.i, label %B70.if.i155.i.i, label %B1188.endif.endif.endif.i.i

B1188.endif.endif.endif.i.i:                      ; preds = %B70.if.i155.i.i, %B1186.if.i.i
  %lsr.iv.next.i21.i = add i64 %lsr.iv.i17.i, 8192
  %exitcond1135.not.i.i = icmp eq i64 %.117.i.i, %.2168.i.i
  br i1 %exitcond1135.not.i.i, label %_ZN17bnserve_inference12modes_kernel7_source7_gatherB3v25B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i, label %B1186.if.i.i

_ZN17bnserve_inference12modes_kernel7_source7_gatherB3v25B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i: ; preds = %B1188.endif.endif.endif.i.i, %B746.endif.endif.endif.endif.endif.endif.endif.endif.i.i, %B696.i.i
  %.2744.i = load double, ptr %.161.i.i, align 8, !noalias !0
  %.idx.i = mul i64 %.264512101214.i, 24
  %89 = getelementptr i8, ptr %.415.i, i64 %.idx.i
  %90 = getelementptr i8, ptr %89, i64 16
  %.2776.i = load double, ptr %90, align 8, !noalias !0
  %.79.i.i = load i64, ptr %.106.i, align 8, !noalias !29
  %.109.i.i = load i64, ptr %.711.i, align 8, !noalias !29
  %.178.i.i = load i64, ptr %.787.i, align 8, !noalias !29
  %.261.i.i = load i64, ptr %.260.i22.i, align 8, !noalias !29
  %.263.i23.i = inttoptr i64 %.261.i.i to ptr
  %.327.i.i = getelementptr double, ptr %.263.i23.i, i64 %.249012211236.i
  %.4921209.i.i = load double, ptr %.491.i24.i, align 8, !noalias !29
  %.632.idx.i.i = shl i64 %.79.i.i, 13
  %.632.i.i = getelementptr i8, ptr %.625.i, i64 %.632.idx.i.i
  %.944.i.i = getelementptr i8, ptr %.632.i.i, i64 12288
  %.11791324.not.i.i = icmp slt i64 %.178.i.i, 1
  br i1 %.11791324.not.i.i, label %_ZN17bnserve_inference12modes_kernel7_source13_add_productsB3v56B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxx5ArrayIxLi1E1C7mutable7alignedEdd5ArrayIdLi1E1C7mutable7alignedE.exit.i, label %B634.if.lr.ph.i.i

B634.loopexit.i.i:                                ; preds = %B1530.i.i, %B638.endif.i.i
  %exitcond1428.not.i.i = icmp eq i64 %.1192.i.i, %.178.i.i
  br i1 %exitcond1428.not.i.i, label %_ZN17bnserve_inference12modes_kernel7_source13_add_productsB3v56B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxx5ArrayIxLi1E1C7mutable7alignedEdd5ArrayIdLi1E1C7mutable7alignedE.exit.i, label %B634.if.i.i

B934.i.i:                                         ; preds = %B728.if.i.i
  %91 = inttoptr i64 %.1712.i.i to ptr
  %.1784.i.i = getelementptr double, ptr %91, i64 %.249012211236.i
  %.1855.i.i = getelementptr double, ptr %91, i64 %.1838.i.i
  br i1 %.114.inv.i.i.i, label %B1180.i.i, label %B130.if.i.i71.i

B1084.i.i:                                        ; preds = %B728.if.i.i
  br i1 %.114.inv.i.i.i, label %B1180.i.i, label %B142.if.lr.ph.i.i.i

B1180.i.i:                                        ; preds = %B142.if.i.i.i, %B130.if.i.i71.i, %B1084.i.i, %B934.i.i
  %real.2.0.lcssa.i133.sink14.i.i = phi <8 x double> [ %.6.i42.i.i.i, %B130.if.i.i71.i ], [ zeroinitializer, %B934.i.i ], [ zeroinitializer, %B1084.i.i ], [ %.6.i66.i.i.i, %B142.if.i.i.i ]
  %imaginary.2.0.lcssa.i132.sink7.i.i = phi <8 x double> [ %.6.i43.i.i78.i, %B130.if.i.i71.i ], [ zeroinitializer, %B934.i.i ], [ zeroinitializer, %B1084.i.i ], [ %.6.i67.i.i.i, %B142.if.i.i.i ]
  %.917.i.i.i = extractelement <8 x double> %real.2.0.lcssa.i133.sink14.i.i, i64 0
  %.918.i.i.i = extractelement <8 x double> %real.2.0.lcssa.i133.sink14.i.i, i64 1
  %.919.i.i.i = extractelement <8 x double> %real.2.0.lcssa.i133.sink14.i.i, i64 2
  %.920.i.i.i = extractelement <8 x double> %real.2.0.lcssa.i133.sink14.i.i, i64 3
  %.921.i.i.i = extractelement <8 x double> %real.2.0.lcssa.i133.sink14.i.i, i64 4
  %.922.i.i.i = extractelement <8 x double> %real.2.0.lcssa.i133.sink14.i.i, i64 5
  %.923.i.i.i = extractelement <8 x double> %real.2.0.lcssa.i133.sink14.i.i, i64 6
  %.924.i.i.i = extractelement <8 x double> %real.2.0.lcssa.i133.sink14.i.i, i64 7
  %.925.i.i.i = fadd contract double %.917.i.i.i, %.918.i.i.i
  %.926.i.i.i = fadd contract double %.919.i.i.i, %.920.i.i.i
  %.927.i.i.i = fadd contract double %.921.i.i.i, %.922.i.i.i
  %.928.i.i.i = fadd contract double %.923.i.i.i, %.924.i.i.i
  %.929.i.i.i = fadd contract double %.925.i.i.i, %.926.i.i.i
  %.930.i.i.i = fadd contract double %.927.i.i.i, %.928.i.i.i
  %.931.i.i.i = fadd contract double %.929.i.i.i, %.930.i.i.i
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
  %.idx.i67.i = shl i64 %.2220.i.i, 4
  %92 = getelementptr i8, ptr %98, i64 %.idx.i67.i
  %.2251.i.i = load double, ptr %92, align 8, !noalias !29
  %.2253.i.i = fadd contract double %.2251.i.i, %.931.i.i.i
  store double %.2253.i.i, ptr %92, align 8, !noalias !29
  %93 = getelementptr i8, ptr %92, i64 8
  %.2322.i.i = load double, ptr %93, align 8, !noalias !29
  %.2324.i.i = fadd contract double %.2322.i.i, %.949.i.i.i
  store double %.2324.i.i, ptr %93, align 8, !noalias !29
  br i1 %104, label %B1304.i.i, label %B1530.i.i

B1304.i.i:                                        ; preds = %B1180.i.i
  %.2391.i.i = load i64, ptr %.869.i, align 8, !noalias !29
  %.2392.not.i.i = icmp eq i64 %.2391.i.i, 0
  %or.cond.i.i = select i1 %.2392.not.i.i, i1 true, i1 %100
  br i1 %or.cond.i.i, label %B1530.i.i, label %B62.if.preheader.i.i.i

B1530.i.i:                                        ; preds = %B62.if.i.i.i, %B1304.i.i, %B1180.i.i
  %scevgep320.i.i = getelementptr i8, ptr %lsr.iv319.i.i, i64 8192
  %exitcond.not.i68.i = icmp eq i64 %.79.i.i, %.1359.i40.i
  br i1 %exitcond.not.i68.i, label %B634.loopexit.i.i, label %B728.if.i.i

B634.if.lr.ph.i.i:                                ; preds = %_ZN17bnserve_inference12modes_kernel7_source7_gatherB3v25B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i
  %.546.i.i = load i64, ptr %sunkaddr74.i, align 8, !noalias !29
  %.550.i.i = mul i64 %.79.i.i, %.264.i.i
  %.552.i.i = mul i64 %.550.i.i, %.178.i.i
  %.553.i.i = add nsw i64 %.546.i.i, %.552.i.i
  %.414.i.i = load i64, ptr %.413.i.i, align 8, !noalias !29
  %.139.i27.i = load i64, ptr %.138.i26.i, align 8, !noalias !29
  %.181.i28.i = sub i64 0, %.109.i.i
  %.189.1.i.i = and i64 %.181.i28.i, -8
  %.1669.i.i = mul nsw i64 %.79.i.i, %.264512101214.i
  %.1838.i.i = sub i64 %.249012211236.i, %.189.1.i.i
  %.2358.i.i = add nsw i64 %.178.i.i, -1
  %.2396.i.i = sub i64 %.109.i.i, %.249012211236.i
  %.2458.i.i = mul nsw i64 %.79.i.i, %.1021.sroa.0.052.i
  %.152.i.i29.i = add i64 %.139.i27.i, -4
  %.13.i.i30.i = tail call i64 @llvm.smin.i64(i64 %.2396.i.i, i64 range(i64 -9223372036854775799, 513) %.13.i.i)
  %94 = lshr i64 %.181.i28.i, 3
  %95 = mul i64 %94, -128
  %scevgep77.i.i = getelementptr i8, ptr %.632.i.i, i64 4096
  %96 = icmp slt i64 %.79.i.i, 1
  %97 = icmp eq i64 %.139.i27.i, 1
  %98 = inttoptr i64 %.553.i.i to ptr
  %99 = inttoptr i64 %.414.i.i to ptr
  %sunkaddr83.i.i = getelementptr i8, ptr %99, i64 8
  %100 = icmp slt i64 %.13.i.i30.i, 1
  %factor.op.mul = mul i64 %.189.1.i.i, %.139.i27.i
  %factor.op.mul.i.reass = mul i64 %factor.op.mul, -16
  br label %B634.if.i.i

B634.if.i.i:                                      ; preds = %B634.if.lr.ph.i.i, %B634.loopexit.i.i
  %.118512961327.i.i = phi i64 [ 0, %B634.if.lr.ph.i.i ], [ %.1192.i.i, %B634.loopexit.i.i ]
  %.1192.i.i = add nuw nsw i64 %.118512961327.i.i, 1
  %.1222.i.i = uitofp nneg i64 %.118512961327.i.i to double
  %.1223.i.i = fmul contract double %.4921209.i.i, %.1222.i.i
  %.1225.i.i = fadd contract double %.2744.i, %.1223.i.i
  %.1227.i.i = fadd contract double %.2776.i, %.1225.i.i
  br i1 %.114.inv.i.i.i, label %B638.endif.i.i, label %B92.if.preheader.i.i.i

B92.if.preheader.i.i.i:                           ; preds = %B634.if.i.i
  %.48.i90.i.i = fmul contract double %.1227.i.i, 0xC01921FB54442D18
  %.6.i.i.i33.i = insertelement <8 x double> poison, double %.48.i90.i.i, i64 0
  %.7.i.i.i.i = shufflevector <8 x double> %.6.i.i.i33.i, <8 x double> poison, <8 x i32> zeroinitializer
  br label %B92.if.i.i.i

B92.if.i.i.i:                                     ; preds = %B92.if.i.i.i, %B92.if.preheader.i.i.i
  %lsr.iv8.i34.i = phi i64 [ %lsr.iv.next9.i39.i, %B92.if.i.i.i ], [ %36, %B92.if.preheader.i.i.i ]
  %lsr.iv170.i.i.i = phi i64 [ %lsr.iv.next171.i.i.i, %B92.if.i.i.i ], [ 0, %B92.if.preheader.i.i.i ]
  %scevgep173.i.i.i = getelementptr i8, ptr %.327.i.i, i64 %lsr.iv170.i.i.i
  %.192.i91.i.i = load <8 x double>, ptr %scevgep173.i.i.i, align 8, !noalias !32
  %.8.i.i.i35.i = fmul contract <8 x double> %.7.i.i.i.i, %.192.i91.i.i
  %.222.i92.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i.i.i35.i, <8 x double> splat (double 0x3FE45F306DC9C883), <8 x double> splat (double 0x4338000000000000))
  %.8.i154.i.i.i = fadd contract <8 x double> %.222.i92.i.i, splat (double 0xC338000000000000)
  %.263.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i154.i.i.i, <8 x double> splat (double 0xBFF921FB54442D18), <8 x double> %.8.i.i.i35.i)
  %.280.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i154.i.i.i, <8 x double> splat (double 0xBC91A62633145C07), <8 x double> %.263.i.i.i)
  %.6.i155.i.i.i = fmul contract <8 x double> %.280.i.i.i, %.280.i.i.i
  %.6.i156.i.i.i = fmul contract <8 x double> %.280.i.i.i, %.6.i155.i.i.i
  %.309.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i155.i.i.i, <8 x double> splat (double 0xBD6AE7F3E733B81F), <8 x double> splat (double 0x3DE6124613A86D09))
  %.312.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i155.i.i.i, <8 x double> %.309.i.i.i, <8 x double> splat (double 0xBE5AE64567F544E4))
  %.315.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i155.i.i.i, <8 x double> %.312.i.i.i, <8 x double> splat (double 0x3EC71DE3A556C734))
  %.318.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i155.i.i.i, <8 x double> %.315.i.i.i, <8 x double> splat (double 0xBF2A01A01A01A01A))
  %.321.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i155.i.i.i, <8 x double> %.318.i.i.i, <8 x double> splat (double 0x3F81111111111111))
  %.324.i.i36.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i155.i.i.i, <8 x double> %.321.i.i.i, <8 x double> splat (double 0xBFC5555555555555))
  %.349.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i156.i.i.i, <8 x double> %.324.i.i36.i, <8 x double> %.280.i.i.i)
  %.354.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i155.i.i.i, <8 x double> splat (double 0x3D2AE7F3E733B81F), <8 x double> splat (double 0xBDA93974A8C07C9D))
  %.357.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i155.i.i.i, <8 x double> %.354.i.i.i, <8 x double> splat (double 0x3E21EED8EFF8D898))
  %.360.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i155.i.i.i, <8 x double> %.357.i.i.i, <8 x double> splat (double 0xBE927E4FB7789F5C))
  %.363.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i155.i.i.i, <8 x double> %.360.i.i.i, <8 x double> splat (double 0x3EFA01A01A01A01A))
  %.366.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i155.i.i.i, <8 x double> %.363.i.i.i, <8 x double> splat (double 0xBF56C16C16C16C17))
  %.369.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i155.i.i.i, <8 x double> %.366.i.i.i, <8 x double> splat (double 0x3FA5555555555555))
  %.372.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i155.i.i.i, <8 x double> %.369.i.i.i, <8 x double> splat (double -5.000000e-01))
  %.375.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i155.i.i.i, <8 x double> %.372.i.i.i, <8 x double> splat (double 1.000000e+00))
  %.376.i.i37.i = bitcast <8 x double> %.222.i92.i.i to <8 x i64>
  %.377.i.i.i = bitcast <8 x double> %.349.i.i.i to <8 x i64>
  %.378.i.i.i = bitcast <8 x double> %.375.i.i.i to <8 x i64>
  %.6.i157.i.i.i = xor <8 x i64> %.378.i.i.i, %.377.i.i.i
  %.8.i158.i.i.i = and <8 x i64> %.376.i.i37.i, splat (i64 1)
  %101 = icmp eq <8 x i64> %.8.i158.i.i.i, zeroinitializer
  %.6.i160.i.i.i = select <8 x i1> %101, <8 x i64> zeroinitializer, <8 x i64> %.6.i157.i.i.i
  %.8.i161.i.i.i = shl <8 x i64> %.376.i.i37.i, splat (i64 62)
  %.8.i162.i.i.i = and <8 x i64> %.8.i161.i.i.i, splat (i64 -9223372036854775808)
  %.8.i164.i.i.i = add <8 x i64> %.8.i161.i.i.i, splat (i64 4611686018427387904)
  %.8.i165.i.i.i = and <8 x i64> %.8.i164.i.i.i, splat (i64 -9223372036854775808)
  %102 = xor <8 x i64> %.8.i162.i.i.i, %.377.i.i.i
  %.6.i167.i.i.i = xor <8 x i64> %102, %.6.i160.i.i.i
  %103 = xor <8 x i64> %.8.i165.i.i.i, %.378.i.i.i
  %.6.i169.i.i.i = xor <8 x i64> %103, %.6.i160.i.i.i
  %scevgep.i38.i = getelementptr i8, ptr %.944.i.i, i64 %lsr.iv170.i.i.i
  %scevgep281.i.i = getelementptr i8, ptr %scevgep.i38.i, i64 -4096
  store <8 x i64> %.6.i169.i.i.i, ptr %scevgep281.i.i, align 8, !noalias !32
  store <8 x i64> %.6.i167.i.i.i, ptr %scevgep.i38.i, align 8, !noalias !32
  %lsr.iv.next171.i.i.i = add i64 %lsr.iv170.i.i.i, 64
  %lsr.iv.next9.i39.i = add nsw i64 %lsr.iv8.i34.i, -1
  %.144.i.i.i = icmp sgt i64 %lsr.iv8.i34.i, 5
  br i1 %.144.i.i.i, label %B92.if.i.i.i, label %B638.endif.i.i

B638.endif.i.i:                                   ; preds = %B92.if.i.i.i, %B634.if.i.i
  br i1 %96, label %B634.loopexit.i.i, label %B728.if.preheader.i.i

B728.if.preheader.i.i:                            ; preds = %B638.endif.i.i
  %104 = icmp eq i64 %.118512961327.i.i, %.2358.i.i
  br label %B728.if.i.i

B728.if.i.i:                                      ; preds = %B728.if.preheader.i.i, %B1530.i.i
  %lsr.iv319.i.i = phi ptr [ %scevgep320.i.i, %B1530.i.i ], [ %scevgep341.i.i, %B728.if.preheader.i.i ]
  %.135212691281.i.i = phi i64 [ %.1359.i40.i, %B1530.i.i ], [ 0, %B728.if.preheader.i.i ]
  %.1359.i40.i = add nuw nsw i64 %.135212691281.i.i, 1
  %.1659.i.i = load i64, ptr %sunkaddr81.i.i, align 8, !noalias !29
  %.1660.i.i = icmp eq i64 %.1659.i.i, 1
  %.1671.i.i = add nuw nsw i64 %.135212691281.i.i, %.1669.i.i
  %"$phi838.2.2.2.i.i" = select i1 %.1660.i.i, i64 %.264512101214.i, i64 %.1671.i.i
  %.1708.i.i = load i64, ptr %sunkaddr.i32.i, align 8, !noalias !29
  %.1711.i.i = mul nsw i64 %factor.op.mul.i.reass, %"$phi838.2.2.2.i.i"
  %.1712.i.i = add nsw i64 %.1711.i.i, %.1708.i.i
  br i1 %97, label %B934.i.i, label %B1084.i.i

B130.if.i.i71.i:                                  ; preds = %B934.i.i, %B130.if.i.i71.i
  %lsr.iv.i72.i = phi i64 [ %lsr.iv.next.i79.i, %B130.if.i.i71.i ], [ %36, %B934.i.i ]
  %lsr.iv44.i.i.i = phi i64 [ %lsr.iv.next45.i.i.i, %B130.if.i.i71.i ], [ 0, %B934.i.i ]
  %real.2.0272.i.i.i = phi <8 x double> [ %.6.i42.i.i.i, %B130.if.i.i71.i ], [ zeroinitializer, %B934.i.i ]
  %imaginary.2.0271.i.i.i = phi <8 x double> [ %.6.i43.i.i78.i, %B130.if.i.i71.i ], [ zeroinitializer, %B934.i.i ]
  %scevgep333.i.i = getelementptr i8, ptr %lsr.iv319.i.i, i64 %lsr.iv44.i.i.i
  %scevgep334.i.i = getelementptr i8, ptr %scevgep333.i.i, i64 -4096
  %.266.i115.i.i = load <8 x double>, ptr %scevgep334.i.i, align 8, !noalias !35
  %.276.i.i73.i = load <8 x double>, ptr %scevgep333.i.i, align 8, !noalias !35
  %scevgep330.i74.i = getelementptr i8, ptr %.944.i.i, i64 %lsr.iv44.i.i.i
  %scevgep331.i75.i = getelementptr i8, ptr %scevgep330.i74.i, i64 -4096
  %.286.i.i.i = load <8 x double>, ptr %scevgep331.i75.i, align 8, !noalias !35
  %.296.i.i.i = load <8 x double>, ptr %scevgep330.i74.i, align 8, !noalias !35
  %.6.i.i116.i.i = fmul contract <8 x double> %.276.i.i73.i, %.296.i.i.i
  %.8.i.i117.i.i = fsub contract <8 x double> zeroinitializer, %.6.i.i116.i.i
  %.345.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.266.i115.i.i, <8 x double> %.286.i.i.i, <8 x double> %.8.i.i117.i.i)
  %.6.i38.i.i.i = fmul contract <8 x double> %.276.i.i73.i, %.286.i.i.i
  %.370.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.266.i115.i.i, <8 x double> %.296.i.i.i, <8 x double> %.6.i38.i.i.i)
  %scevgep48.i.i.i = getelementptr i8, ptr %.1784.i.i, i64 %lsr.iv44.i.i.i
  %.401.i.i.i = load <8 x double>, ptr %scevgep48.i.i.i, align 8, !noalias !35
  %scevgep47.i.i.i = getelementptr i8, ptr %.1855.i.i, i64 %lsr.iv44.i.i.i
  %.411.i.i.i = load <8 x double>, ptr %scevgep47.i.i.i, align 8, !noalias !35
  %.6.i39.i.i.i = fmul contract <8 x double> %.370.i.i.i, %.411.i.i.i
  %.8.i40.i.i.i = fsub contract <8 x double> zeroinitializer, %.6.i39.i.i.i
  %.6.i41.i.i76.i = fmul contract <8 x double> %.411.i.i.i, %.345.i.i.i
  %.460.i.i77.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.401.i.i.i, <8 x double> %.345.i.i.i, <8 x double> %.8.i40.i.i.i)
  %.485.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.401.i.i.i, <8 x double> %.370.i.i.i, <8 x double> %.6.i41.i.i76.i)
  %scevgep76.i.i = getelementptr i8, ptr %scevgep330.i74.i, i64 -12288
  store <8 x double> %.460.i.i77.i, ptr %scevgep76.i.i, align 8, !noalias !35
  %scevgep74.i.i = getelementptr i8, ptr %scevgep330.i74.i, i64 -8192
  store <8 x double> %.485.i.i.i, ptr %scevgep74.i.i, align 8, !noalias !35
  %.6.i42.i.i.i = fadd contract <8 x double> %real.2.0272.i.i.i, %.460.i.i77.i
  %.6.i43.i.i78.i = fadd contract <8 x double> %imaginary.2.0271.i.i.i, %.485.i.i.i
  %lsr.iv.next45.i.i.i = add i64 %lsr.iv44.i.i.i, 64
  %lsr.iv.next.i79.i = add nsw i64 %lsr.iv.i72.i, -1
  %.218.i.i.i = icmp sgt i64 %lsr.iv.i72.i, 5
  br i1 %.218.i.i.i, label %B130.if.i.i71.i, label %B1180.i.i

B142.if.lr.ph.i.i.i:                              ; preds = %B1084.i.i
  %105 = inttoptr i64 %.1712.i.i to ptr
  %.48.i.i.i = load double, ptr %99, align 8, !noalias !38
  %.49.i.i.i = fsub contract double %.1227.i.i, %.48.i.i.i
  %.78.i.i.i = load double, ptr %sunkaddr83.i.i, align 8, !noalias !38
  %.85.i.i.i = fdiv contract double %.49.i.i.i, %.78.i.i.i
  %.93.le.i.i.i = tail call contract double @llvm.floor.f64(double %.85.i.i.i)
  %.5.i.i.i.i = fptosi double %.93.le.i.i.i to i64
  %.13.i.i.i.i = tail call i64 @llvm.smax.i64(i64 %.5.i.i.i.i, i64 2)
  %.13.i1.i.i.i = tail call i64 @llvm.smin.i64(i64 %.152.i.i29.i, i64 %.13.i.i.i.i)
  %.265.i.i.i = add i64 %.13.i1.i.i.i, -2
  %.181.i.i.i = sitofp i64 %.13.i1.i.i.i to double
  %.182.i.i.i = fsub contract double %.85.i.i.i, %.181.i.i.i
  %.206.i.i.i = fmul contract double %.182.i.i.i, %.182.i.i.i
  %.245.i.i41.i = fmul contract double %.182.i.i.i, %.206.i.i.i
  %.246.i.i.i = fmul contract double %.182.i.i.i, %.245.i.i41.i
  %.247.i.i.i = fmul contract double %.182.i.i.i, %.246.i.i.i
  %.251.i.i.i = fdiv contract double %.247.i.i.i, 1.200000e+02
  %.183.i.i.i = fsub contract double 1.000000e+00, %.182.i.i.i
  %.230.i.i42.i = fmul contract double %.183.i.i.i, 5.000000e+00
  %.231.i.i.i = fadd contract double %.230.i.i42.i, -2.000000e+01
  %.232.i.i43.i = fmul contract double %.183.i.i.i, %.231.i.i.i
  %.233.i.i44.i = fadd contract double %.232.i.i43.i, 2.000000e+01
  %.234.i.i45.i = fmul contract double %.183.i.i.i, %.233.i.i44.i
  %.235.i.i.i = fadd contract double %.234.i.i45.i, 2.000000e+01
  %.236.i.i46.i = fmul contract double %.183.i.i.i, %.235.i.i.i
  %.237.i.i.i = fadd contract double %.236.i.i46.i, -5.000000e+01
  %.238.i.i.i = fmul contract double %.183.i.i.i, %.237.i.i.i
  %.239.i.i.i = fadd contract double %.238.i.i.i, 2.600000e+01
  %.243.i.i.i = fdiv contract double %.239.i.i.i, 1.200000e+02
  %.184.i.i.i = fmul contract double %.183.i.i.i, %.183.i.i.i
  %.220.i.i.i = fmul contract double %.183.i.i.i, 1.000000e+01
  %.221.i.i.i = fsub contract double 3.000000e+01, %.220.i.i.i
  %.222.i.i.i = fmul contract double %.184.i.i.i, %.221.i.i.i
  %.223.i.i.i = fadd contract double %.222.i.i.i, -6.000000e+01
  %.224.i.i47.i = fmul contract double %.184.i.i.i, %.223.i.i.i
  %.225.i.i48.i = fadd contract double %.224.i.i47.i, 6.600000e+01
  %.229.i.i49.i = fdiv contract double %.225.i.i48.i, 1.200000e+02
  %.208.i.i.i = fmul contract double %.182.i.i.i, 1.000000e+01
  %.209.i.i50.i = fsub contract double 3.000000e+01, %.208.i.i.i
  %.210.i.i.i = fmul contract double %.206.i.i.i, %.209.i.i50.i
  %.211.i.i.i = fadd contract double %.210.i.i.i, -6.000000e+01
  %.212.i.i.i = fmul contract double %.206.i.i.i, %.211.i.i.i
  %.213.i.i.i = fadd contract double %.212.i.i.i, 6.600000e+01
  %.217.i.i51.i = fdiv contract double %.213.i.i.i, 1.200000e+02
  %.192.i.i.i = fmul contract double %.182.i.i.i, 5.000000e+00
  %.193.i.i52.i = fadd contract double %.192.i.i.i, -2.000000e+01
  %.194.i.i.i = fmul contract double %.182.i.i.i, %.193.i.i52.i
  %.195.i.i.i = fadd contract double %.194.i.i.i, 2.000000e+01
  %.196.i.i.i = fmul contract double %.182.i.i.i, %.195.i.i.i
  %.197.i.i.i = fadd contract double %.196.i.i.i, 2.000000e+01
  %.198.i.i.i = fmul contract double %.182.i.i.i, %.197.i.i.i
  %.199.i.i53.i = fadd contract double %.198.i.i.i, -5.000000e+01
  %.200.i.i.i = fmul contract double %.182.i.i.i, %.199.i.i53.i
  %.201.i.i.i = fadd contract double %.200.i.i.i, 2.600000e+01
  %.205.i.i54.i = fdiv contract double %.201.i.i.i, 1.200000e+02
  %.185.i.i.i = fmul contract double %.183.i.i.i, %.184.i.i.i
  %.186.i.i.i = fmul contract double %.183.i.i.i, %.185.i.i.i
  %.187.i.i.i = fmul contract double %.183.i.i.i, %.186.i.i.i
  %.191.i.i.i = fdiv contract double %.187.i.i.i, 1.200000e+02
  %.488.i.i.i = insertelement <8 x double> poison, double %.205.i.i54.i, i64 0
  %.489.i.i.i = shufflevector <8 x double> %.488.i.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.515.i.i.i = insertelement <8 x double> poison, double %.217.i.i51.i, i64 0
  %.516.i.i.i = shufflevector <8 x double> %.515.i.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.518.i.i.i = insertelement <8 x double> poison, double %.229.i.i49.i, i64 0
  %.519.i.i.i = shufflevector <8 x double> %.518.i.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.554.i.i.i = insertelement <8 x double> poison, double %.243.i.i.i, i64 0
  %.555.i.i55.i = shufflevector <8 x double> %.554.i.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.557.i.i.i = insertelement <8 x double> poison, double %.251.i.i.i, i64 0
  %.558.i.i.i = shufflevector <8 x double> %.557.i.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.6.i58.i.i56.i = insertelement <8 x double> poison, double %.191.i.i.i, i64 0
  %.7.i.i121.i.i = shufflevector <8 x double> %.6.i58.i.i56.i, <8 x double> poison, <8 x i32> zeroinitializer
  %106 = shl i64 %.13.i1.i.i.i, 7
  %107 = sub i64 -320, %106
  %108 = sub i64 -448, %106
  %109 = sub nuw nsw i64 -64, %106
  %110 = sub i64 -192, %106
  %111 = shl i64 %.13.i1.i.i.i, 4
  %112 = sub i64 24, %111
  %113 = sub i64 64, %106
  %114 = sub i64 -256, %106
  %115 = sub i64 -384, %106
  %116 = sub nuw nsw i64 -128, %106
  %117 = sub i64 128, %106
  %scevgep12.i.i = getelementptr i8, ptr %105, i64 %41
  %118 = mul i64 %107, %94
  %scevgep13.i.i = getelementptr i8, ptr %scevgep12.i.i, i64 %118
  %119 = mul i64 %108, %94
  %scevgep15.i.i = getelementptr i8, ptr %scevgep12.i.i, i64 %119
  %120 = mul i64 %109, %94
  %scevgep17.i.i = getelementptr i8, ptr %scevgep12.i.i, i64 %120
  %121 = mul i64 %110, %94
  %scevgep33.i57.i = getelementptr i8, ptr %scevgep12.i.i, i64 %121
  %122 = mul i64 %112, %.189.1.i.i
  %scevgep47.i.i = getelementptr i8, ptr %scevgep12.i.i, i64 %122
  %123 = mul i64 %113, %94
  %scevgep51.i.i = getelementptr i8, ptr %scevgep12.i.i, i64 %123
  %124 = mul i64 %114, %94
  %scevgep55.i.i = getelementptr i8, ptr %scevgep12.i.i, i64 %124
  %125 = mul i64 %115, %94
  %scevgep58.i.i = getelementptr i8, ptr %scevgep12.i.i, i64 %125
  %126 = mul i64 %.13.i1.i.i.i, %95
  %scevgep60.i.i = getelementptr i8, ptr %scevgep12.i.i, i64 %126
  %127 = mul i64 %116, %94
  %scevgep63.i.i = getelementptr i8, ptr %scevgep12.i.i, i64 %127
  %128 = mul i64 %.265.i.i.i, %95
  %scevgep65.i.i = getelementptr i8, ptr %scevgep12.i.i, i64 %128
  %129 = mul i64 %117, %94
  %scevgep67.i.i = getelementptr i8, ptr %scevgep12.i.i, i64 %129
  br label %B142.if.i.i.i

B142.if.i.i.i:                                    ; preds = %B142.if.i.i.i, %B142.if.lr.ph.i.i.i
  %lsr.iv10.i.i = phi i64 [ %lsr.iv.next11.i.i, %B142.if.i.i.i ], [ %36, %B142.if.lr.ph.i.i.i ]
  %lsr.iv68.i.i.i = phi i64 [ %lsr.iv.next69.i.i.i, %B142.if.i.i.i ], [ 0, %B142.if.lr.ph.i.i.i ]
  %real.2.0448.i.i.i = phi <8 x double> [ %.6.i66.i.i.i, %B142.if.i.i.i ], [ zeroinitializer, %B142.if.lr.ph.i.i.i ]
  %imaginary.2.0447.i.i.i = phi <8 x double> [ %.6.i67.i.i.i, %B142.if.i.i.i ], [ zeroinitializer, %B142.if.lr.ph.i.i.i ]
  %scevgep322.i.i = getelementptr i8, ptr %lsr.iv319.i.i, i64 %lsr.iv68.i.i.i
  %scevgep323.i58.i = getelementptr i8, ptr %scevgep322.i.i, i64 -4096
  %.302.i.i.i = load <8 x double>, ptr %scevgep323.i58.i, align 8, !noalias !41
  %.312.i123.i.i = load <8 x double>, ptr %scevgep322.i.i, align 8, !noalias !41
  %scevgep286.i.i = getelementptr i8, ptr %.944.i.i, i64 %lsr.iv68.i.i.i
  %scevgep287.i.i = getelementptr i8, ptr %scevgep286.i.i, i64 -4096
  %.322.i.i.i = load <8 x double>, ptr %scevgep287.i.i, align 8, !noalias !41
  %.332.i.i.i = load <8 x double>, ptr %scevgep286.i.i, align 8, !noalias !41
  %.6.i.i124.i.i = fmul contract <8 x double> %.312.i123.i.i, %.332.i.i.i
  %.8.i.i125.i.i = fsub contract <8 x double> zeroinitializer, %.6.i.i124.i.i
  %.381.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.302.i.i.i, <8 x double> %.322.i.i.i, <8 x double> %.8.i.i125.i.i)
  %.6.i57.i.i.i = fmul contract <8 x double> %.312.i123.i.i, %.322.i.i.i
  %.406.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.302.i.i.i, <8 x double> %.332.i.i.i, <8 x double> %.6.i57.i.i.i)
  %scevgep68.i.i = getelementptr i8, ptr %scevgep67.i.i, i64 %lsr.iv68.i.i.i
  %.452.i.i.i = load <8 x double>, ptr %scevgep68.i.i, align 8, !noalias !41
  %scevgep66.i.i = getelementptr i8, ptr %scevgep65.i.i, i64 %lsr.iv68.i.i.i
  %.462.i.i.i = load <8 x double>, ptr %scevgep66.i.i, align 8, !noalias !41
  %.8.i59.i.i59.i = fmul contract <8 x double> %.7.i.i121.i.i, %.462.i.i.i
  %.490.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.452.i.i.i, <8 x double> %.489.i.i.i, <8 x double> %.8.i59.i.i59.i)
  %scevgep64.i.i = getelementptr i8, ptr %scevgep63.i.i, i64 %lsr.iv68.i.i.i
  %.501.i.i.i = load <8 x double>, ptr %scevgep64.i.i, align 8, !noalias !41
  %scevgep61.i.i = getelementptr i8, ptr %scevgep60.i.i, i64 %lsr.iv68.i.i.i
  %.513.i.i.i = load <8 x double>, ptr %scevgep61.i.i, align 8, !noalias !41
  %.517.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.513.i.i.i, <8 x double> %.516.i.i.i, <8 x double> %.490.i.i.i)
  %.520.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.501.i.i.i, <8 x double> %.519.i.i.i, <8 x double> %.517.i.i.i)
  %scevgep59.i.i = getelementptr i8, ptr %scevgep58.i.i, i64 %lsr.iv68.i.i.i
  %.531.i.i.i = load <8 x double>, ptr %scevgep59.i.i, align 8, !noalias !41
  %scevgep57.i.i = getelementptr i8, ptr %scevgep55.i.i, i64 %lsr.iv68.i.i.i
  %.543.i.i.i = load <8 x double>, ptr %scevgep57.i.i, align 8, !noalias !41
  %.556.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.543.i.i.i, <8 x double> %.555.i.i55.i, <8 x double> %.520.i.i.i)
  %.559.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.531.i.i.i, <8 x double> %.558.i.i.i, <8 x double> %.556.i.i.i)
  %scevgep52.i.i = getelementptr i8, ptr %scevgep51.i.i, i64 %lsr.iv68.i.i.i
  %.586.i.i.i = load <8 x double>, ptr %scevgep52.i.i, align 8, !noalias !41
  %scevgep49.i.i = getelementptr i8, ptr %scevgep47.i.i, i64 %lsr.iv68.i.i.i
  %.596.i.i.i = load <8 x double>, ptr %scevgep49.i.i, align 8, !noalias !41
  %.8.i62.i.i60.i = fmul contract <8 x double> %.7.i.i121.i.i, %.596.i.i.i
  %.624.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.586.i.i.i, <8 x double> %.489.i.i.i, <8 x double> %.8.i62.i.i60.i)
  %scevgep40.i.i = getelementptr i8, ptr %scevgep33.i57.i, i64 %lsr.iv68.i.i.i
  %.635.i126.i.i = load <8 x double>, ptr %scevgep40.i.i, align 8, !noalias !41
  %scevgep18.i61.i = getelementptr i8, ptr %scevgep17.i.i, i64 %lsr.iv68.i.i.i
  %.647.i127.i.i = load <8 x double>, ptr %scevgep18.i61.i, align 8, !noalias !41
  %.651.i128.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.647.i127.i.i, <8 x double> %.516.i.i.i, <8 x double> %.624.i.i.i)
  %.654.i129.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.635.i126.i.i, <8 x double> %.519.i.i.i, <8 x double> %.651.i128.i.i)
  %scevgep16.i.i = getelementptr i8, ptr %scevgep15.i.i, i64 %lsr.iv68.i.i.i
  %.665.i.i.i = load <8 x double>, ptr %scevgep16.i.i, align 8, !noalias !41
  %scevgep14.i62.i = getelementptr i8, ptr %scevgep13.i.i, i64 %lsr.iv68.i.i.i
  %.677.i.i.i = load <8 x double>, ptr %scevgep14.i62.i, align 8, !noalias !41
  %.690.i.i63.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.677.i.i.i, <8 x double> %.555.i.i55.i, <8 x double> %.654.i129.i.i)
  %.693.i.i64.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.665.i.i.i, <8 x double> %.558.i.i.i, <8 x double> %.690.i.i63.i)
  %.6.i63.i.i65.i = fmul contract <8 x double> %.406.i.i.i, %.693.i.i64.i
  %.8.i64.i.i.i = fsub contract <8 x double> zeroinitializer, %.6.i63.i.i65.i
  %.6.i65.i.i.i = fmul contract <8 x double> %.381.i.i.i, %.693.i.i64.i
  %.742.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.559.i.i.i, <8 x double> %.381.i.i.i, <8 x double> %.8.i64.i.i.i)
  %.767.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.559.i.i.i, <8 x double> %.406.i.i.i, <8 x double> %.6.i65.i.i.i)
  %scevgep72.i.i = getelementptr i8, ptr %scevgep286.i.i, i64 -12288
  store <8 x double> %.742.i.i.i, ptr %scevgep72.i.i, align 8, !noalias !41
  %scevgep70.i.i = getelementptr i8, ptr %scevgep286.i.i, i64 -8192
  store <8 x double> %.767.i.i.i, ptr %scevgep70.i.i, align 8, !noalias !41
  %.6.i66.i.i.i = fadd contract <8 x double> %real.2.0448.i.i.i, %.742.i.i.i
  %.6.i67.i.i.i = fadd contract <8 x double> %imaginary.2.0447.i.i.i, %.767.i.i.i
  %lsr.iv.next69.i.i.i = add i64 %lsr.iv68.i.i.i, 64
  %lsr.iv.next11.i.i = add nsw i64 %lsr.iv10.i.i, -1
  %.254.i.i66.i = icmp sgt i64 %lsr.iv10.i.i, 5
  br i1 %.254.i.i66.i, label %B142.if.i.i.i, label %B1180.i.i

B62.if.preheader.i.i.i:                           ; preds = %B1304.i.i
  %.2460.i.i = add nsw i64 %.135212691281.i.i, %.2458.i.i
  %.2464.i.i = mul nsw i64 %.2460.i.i, %.109.i.i
  %.2466.i.i = add nsw i64 %.2464.i.i, %.249012211236.i
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
  %.252.i.i.i = load double, ptr %scevgep2.i.i.i, align 8, !noalias !44
  %sunkaddr63.i.i = shl i64 %.190171173.i.i.i, 3
  %scevgep78.i.i = getelementptr i8, ptr %scevgep77.i.i, i64 %sunkaddr63.i.i
  %scevgep79.i.i = getelementptr i8, ptr %scevgep78.i.i, i64 -4096
  %.282.i.i.i = load double, ptr %scevgep79.i.i, align 8, !noalias !44
  %.314.i.i.i = load double, ptr %scevgep78.i.i, align 8, !noalias !44
  %.316.i.i.i = fmul contract double %.314.i.i.i, 0.000000e+00
  %.317.i.i.i = fsub contract double %.282.i.i.i, %.316.i.i.i
  %.318.i142.i.i = fadd contract double %.252.i.i.i, %.317.i.i.i
  store double %.318.i142.i.i, ptr %scevgep2.i.i.i, align 8, !noalias !44
  %.380.i.i.i = load double, ptr %lsr.iv.i140.i.i, align 8, !noalias !44
  %.410.i.i.i = load double, ptr %scevgep78.i.i, align 8, !noalias !44
  %.442.i.i.i = load double, ptr %scevgep79.i.i, align 8, !noalias !44
  %.444.i.i69.i = fmul contract double %.442.i.i.i, 0.000000e+00
  %.445.i.i70.i = fadd contract double %.410.i.i.i, %.444.i.i69.i
  %.446.i.i.i = fadd contract double %.380.i.i.i, %.445.i.i70.i
  store double %.446.i.i.i, ptr %lsr.iv.i140.i.i, align 8, !noalias !44
  %scevgep1.i.i.i = getelementptr i8, ptr %lsr.iv.i140.i.i, i64 16
  %exitcond.not.i.i.i = icmp eq i64 %.13.i.i30.i, %.197.i141.i.i
  br i1 %exitcond.not.i.i.i, label %B1530.i.i, label %B62.if.i.i.i

_ZN17bnserve_inference12modes_kernel7_source13_add_productsB3v56B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxx5ArrayIxLi1E1C7mutable7alignedEdd5ArrayIdLi1E1C7mutable7alignedE.exit.i: ; preds = %B634.loopexit.i.i, %_ZN17bnserve_inference12modes_kernel7_source7_gatherB3v25B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i
  %.71.i.i = load i64, ptr %.106.i, align 8, !noalias !47
  %.186.i.i = add nsw i64 %.71.i.i, 1
  %.188.i.i = mul nsw i64 %.186.i.i, %.71.i.i
  %.268.i.i = and i64 %.188.i.i, -2
  %.408785.not.i.i = icmp slt i64 %.71.i.i, 1
  br i1 %.408785.not.i.i, label %B1540.backedge.i, label %B282.if.lr.ph.i.i

B774.i.i:                                         ; preds = %_ZN17bnserve_inference12modes_kernel7_source5_pairB4v110B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx.exit.i.i
  %.417.i.i = add nsw i64 %.407750789.i.i, -1
  %.421.i.i = add nuw nsw i64 %.414758788.i.i, 1
  %lsr.iv.next56.i = add i64 %lsr.iv55.i, 8192
  %exitcond867.not.i.i = icmp eq i64 %.421.i.i, %.71.i.i
  br i1 %exitcond867.not.i.i, label %B1540.backedge.i, label %B282.if.i.i

B282.if.lr.ph.i.i:                                ; preds = %_ZN17bnserve_inference12modes_kernel7_source13_add_productsB3v56B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxx5ArrayIxLi1E1C7mutable7alignedEdd5ArrayIdLi1E1C7mutable7alignedE.exit.i
  %.196.1.i.i = lshr i64 %.188.i.i, 1
  %.265.i.i = mul i64 %.196.1.i.i, %.264.i.i
  %.262.i.i = load i64, ptr %sunkaddr75.i, align 8, !noalias !47
  %.266.i.i = add nsw i64 %.262.i.i, %.265.i.i
  %.181.i.i = load i64, ptr %sunkaddr81.i.i, align 8, !noalias !47
  %.102.i110.i = load i64, ptr %.711.i, align 8, !noalias !47
  %.103.i.i = sub i64 0, %.102.i110.i
  %.111.1.i.i = and i64 %.103.i.i, -8
  %.145.i.i = sub i64 0, %.111.1.i.i
  %.1055.i.i = icmp eq i64 %.181.i.i, 1
  %.1065.i.i = shl nsw i64 %.145.i.i, 1
  %.1068.i.i = mul nuw nsw i64 %.196.1.i.i, %.264512101214.i
  %.1059.i.i = mul nsw i64 %.264512101214.i, %.145.i.i
  %130 = mul i64 %.111.1.i.i, -8
  %131 = select i1 %.1055.i.i, i64 0, i64 %130
  %132 = inttoptr i64 %.266.i.i to ptr
  br label %B282.if.i.i

B282.if.i.i:                                      ; preds = %B282.if.lr.ph.i.i, %B774.i.i
  %lsr.iv55.i = phi i64 [ %14, %B282.if.lr.ph.i.i ], [ %lsr.iv.next56.i, %B774.i.i ]
  %at.3.0790.i.i = phi i64 [ 0, %B282.if.lr.ph.i.i ], [ %.1516.i.i, %B774.i.i ]
  %.407750789.i.i = phi i64 [ %.71.i.i, %B282.if.lr.ph.i.i ], [ %.417.i.i, %B774.i.i ]
  %.414758788.i.i = phi i64 [ 0, %B282.if.lr.ph.i.i ], [ %.421.i.i, %B774.i.i ]
  %smax.i.i = tail call i64 @llvm.smax.i64(i64 %.407750789.i.i, i64 0)
  %133 = add i64 %smax.i.i, %at.3.0790.i.i
  br label %B360.if.i113.i

B360.if.i113.i:                                   ; preds = %_ZN17bnserve_inference12modes_kernel7_source5_pairB4v110B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx.exit.i.i, %B282.if.i.i
  %lsr.iv61.i = phi i64 [ %lsr.iv.next62.i, %_ZN17bnserve_inference12modes_kernel7_source5_pairB4v110B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx.exit.i.i ], [ %lsr.iv55.i, %B282.if.i.i ]
  %at.2.1747.i.i = phi i64 [ %.1516.i.i, %_ZN17bnserve_inference12modes_kernel7_source5_pairB4v110B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx.exit.i.i ], [ %at.3.0790.i.i, %B282.if.i.i ]
  br i1 %.114.inv.i.i.i, label %_ZN17bnserve_inference12modes_kernel7_source5_pairB4v110B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx.exit.i.i, label %B130.if.i.i.preheader.i

B130.if.i.i.preheader.i:                          ; preds = %B360.if.i113.i
  %.1070.i.i = add nsw i64 %at.2.1747.i.i, %.1068.i.i
  %.1071.i.i = mul nsw i64 %.1065.i.i, %.1070.i.i
  %"$phi454.2.2.2.i.i" = select i1 %.1055.i.i, i64 %.1059.i.i, i64 %.1071.i.i
  %.1109.i.i = shl nsw i64 %"$phi454.2.2.2.i.i", 3
  %.1108.i.i = load i64, ptr %sunkaddr83.i, align 8, !noalias !47
  %.1110.i.i = add nsw i64 %.1108.i.i, %.1109.i.i
  %134 = inttoptr i64 %.1110.i.i to ptr
  %scevgep267.i = getelementptr i8, ptr %134, i64 %lsr.iv265.i
  br label %B130.if.i.i.i

B306.i.i.i:                                       ; preds = %B130.if.i.i.i
  %.419.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.416.i.i.i, <8 x double> %.351.i.i.i, <8 x double> %real.3.0302.i.i.i)
  %.439.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.416.i.i.i, <8 x double> %.376.i.i.i, <8 x double> %imaginary.3.0301.i.i.i)
  br label %B552.i.i.i

B432.i.i.i:                                       ; preds = %B130.if.i.i.i
  %scevgep65.i = getelementptr i8, ptr %lsr.iv53.i, i64 %131
  %.473.i.i.i = load <8 x double>, ptr %scevgep65.i, align 8, !noalias !50
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
  %lsr.iv.next.i = add nsw i64 %lsr.iv52.i, -1
  %scevgep54.i = getelementptr i8, ptr %lsr.iv53.i, i64 64
  %scevgep58.i = getelementptr i8, ptr %lsr.iv57.i, i64 64
  %.193.i.i.i = icmp sgt i64 %lsr.iv52.i, 5
  br i1 %.193.i.i.i, label %B130.if.i.i.i, label %_ZN17bnserve_inference12modes_kernel7_source5_pairB4v110B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx.exit.i.i

B130.if.i.i.i:                                    ; preds = %B552.i.i.i, %B130.if.i.i.preheader.i
  %lsr.iv57.i = phi ptr [ %scevgep58.i, %B552.i.i.i ], [ %.415.i, %B130.if.i.i.preheader.i ]
  %lsr.iv53.i = phi ptr [ %scevgep54.i, %B552.i.i.i ], [ %scevgep267.i, %B130.if.i.i.preheader.i ]
  %lsr.iv52.i = phi i64 [ %lsr.iv.next.i, %B552.i.i.i ], [ %35, %B130.if.i.i.preheader.i ]
  %real.3.0302.i.i.i = phi <8 x double> [ %real.4.1.i.i.i, %B552.i.i.i ], [ zeroinitializer, %B130.if.i.i.preheader.i ]
  %imaginary.3.0301.i.i.i = phi <8 x double> [ %imaginary.4.1.i.i.i, %B552.i.i.i ], [ zeroinitializer, %B130.if.i.i.preheader.i ]
  %scevgep63.i = getelementptr i8, ptr %lsr.iv57.i, i64 %lsr.iv61.i
  %scevgep64.i = getelementptr i8, ptr %scevgep63.i, i64 -4096
  %.245.i.i.i = load <8 x double>, ptr %scevgep64.i, align 8, !noalias !50
  %.256.i.i.i = load <8 x double>, ptr %scevgep63.i, align 8, !noalias !50
  %scevgep59.i = getelementptr i8, ptr %lsr.iv57.i, i64 %lsr.iv55.i
  %scevgep60.i = getelementptr i8, ptr %scevgep59.i, i64 -4096
  %.267.i.i.i = load <8 x double>, ptr %scevgep60.i, align 8, !noalias !50
  %.278.i.i.i = load <8 x double>, ptr %scevgep59.i, align 8, !noalias !50
  %.8.i.i.i.i = fsub contract <8 x double> zeroinitializer, %.278.i.i.i
  %.6.i41.i.i.i = fmul contract <8 x double> %.256.i.i.i, %.8.i.i.i.i
  %.8.i42.i.i.i = fsub contract <8 x double> zeroinitializer, %.6.i41.i.i.i
  %.351.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.245.i.i.i, <8 x double> %.267.i.i.i, <8 x double> %.8.i42.i.i.i)
  %.6.i43.i.i.i = fmul contract <8 x double> %.256.i.i.i, %.267.i.i.i
  %.376.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.245.i.i.i, <8 x double> %.8.i.i.i.i, <8 x double> %.6.i43.i.i.i)
  %.416.i.i.i = load <8 x double>, ptr %lsr.iv53.i, align 8, !noalias !50
  br i1 %.1055.i.i, label %B306.i.i.i, label %B432.i.i.i

_ZN17bnserve_inference12modes_kernel7_source5_pairB4v110B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx.exit.i.i: ; preds = %B552.i.i.i, %B360.if.i113.i
  %imaginary.3.0.lcssa.i.i.i = phi <8 x double> [ zeroinitializer, %B360.if.i113.i ], [ %imaginary.4.1.i.i.i, %B552.i.i.i ]
  %real.3.0.lcssa.i.i.i = phi <8 x double> [ zeroinitializer, %B360.if.i113.i ], [ %real.4.1.i.i.i, %B552.i.i.i ]
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
  %.idx.i115.i = shl i64 %at.2.1747.i.i, 4
  %135 = getelementptr i8, ptr %132, i64 %.idx.i115.i
  %.1418.i.i = getelementptr double, ptr %135, i64 %.1404.i.i
  %.1419.i.i = load double, ptr %.1418.i.i, align 8, !noalias !47
  %.1420.i.i = fadd contract double %.1419.i.i, %.697.i.i.i
  store double %.1420.i.i, ptr %.1418.i.i, align 8, !noalias !47
  %136 = getelementptr i8, ptr %135, i64 8
  %.1482.i.i = getelementptr double, ptr %136, i64 %.1404.i.i
  %.1483.i.i = load double, ptr %.1482.i.i, align 8, !noalias !47
  %.1484.i.i = fadd contract double %.715.i.i.i, %.1483.i.i
  store double %.1484.i.i, ptr %.1482.i.i, align 8, !noalias !47
  %.1516.i.i = add i64 %at.2.1747.i.i, 1
  %lsr.iv.next62.i = add i64 %lsr.iv61.i, 8192
  %exitcond.not.i116.i = icmp eq i64 %.1516.i.i, %133
  br i1 %exitcond.not.i116.i, label %B774.i.i, label %B360.if.i113.i

B1540.backedge.i:                                 ; preds = %B774.i.i, %_ZN17bnserve_inference12modes_kernel7_source13_add_productsB3v56B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxx5ArrayIxLi1E1C7mutable7alignedEdd5ArrayIdLi1E1C7mutable7alignedE.exit.i
  %exitcond.not.i = icmp eq i64 %.47.i, %.2652.i
  br i1 %exitcond.not.i, label %B1458.loopexit.i, label %B1540.if.i

_ZN17bnserve_inference12modes_kernel7_source8contractB2v3B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIxLi1E1C7mutable7alignedE.exit: ; preds = %B1730.i, %entry
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

; Function Attrs: mustprogress nocallback nocreateundeforpoison nofree nosync nounwind speculatable willreturn memory(none)
declare double @llvm.fma.f64(double, double, double) #2

attributes #0 = { nofree norecurse nosync nounwind memory(readwrite, inaccessiblemem: none, target_mem0: none, target_mem1: none) }
attributes #1 = { mustprogress nocallback nofree nounwind willreturn memory(argmem: write) }
attributes #2 = { mustprogress nocallback nocreateundeforpoison nofree nosync nounwind speculatable willreturn memory(none) }

!0 = !{!1}
!1 = distinct !{!1, !2, !"_ZN17bnserve_inference12modes_kernel7_source8contractB2v3B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIxLi1E1C7mutable7alignedE: %retptr"}
!2 = distinct !{!2, !"_ZN17bnserve_inference12modes_kernel7_source8contractB2v3B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIxLi1E1C7mutable7alignedE"}
!3 = !{!4, !1}
!4 = distinct !{!4, !5, !"_ZN17bnserve_inference6kernel7_source9_geometryB3v17B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!5 = distinct !{!5, !"_ZN17bnserve_inference6kernel7_source9_geometryB3v17B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!6 = !{!"branch_weights", i32 99, i32 1}
!7 = !{!8, !1}
!8 = distinct !{!8, !9, !"_ZN17bnserve_inference12modes_kernel7_source8_factorsB3v21B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!9 = distinct !{!9, !"_ZN17bnserve_inference12modes_kernel7_source8_factorsB3v21B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!10 = !{!"branch_weights", i32 1, i32 99}
!11 = !{!12, !1}
!12 = distinct !{!12, !13, !"_ZN17bnserve_inference12modes_kernel7_source7_gatherB3v25B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!13 = distinct !{!13, !"_ZN17bnserve_inference12modes_kernel7_source7_gatherB3v25B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!14 = !{!15, !12, !1}
!15 = distinct !{!15, !16, !"_ZN17bnserve_surrogate7adjoint5_sums5splitB3v46B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!16 = distinct !{!16, !"_ZN17bnserve_surrogate7adjoint5_sums5splitB3v46B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!17 = !{!18, !12, !1}
!18 = distinct !{!18, !19, !"_ZN17bnserve_inference12modes_kernel7_source8add_modeB3v47B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dEdd5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!19 = distinct !{!19, !"_ZN17bnserve_inference12modes_kernel7_source8add_modeB3v47B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dEdd5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!20 = !{!21, !12, !1}
!21 = distinct !{!21, !22, !"_ZN17bnserve_inference6kernel5_sums9errors_atB3v48B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedExx5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!22 = distinct !{!22, !"_ZN17bnserve_inference6kernel5_sums9errors_atB3v48B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedExx5ArrayIdLi1E1C7mutable7alignedE"}
!23 = !{!24, !12, !1}
!24 = distinct !{!24, !25, !"_ZN17bnserve_inference6kernel5_sums9errors_atB3v48B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedExx5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!25 = distinct !{!25, !"_ZN17bnserve_inference6kernel5_sums9errors_atB3v48B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedExx5ArrayIdLi1E1C7mutable7alignedE"}
!26 = !{!27, !12, !1}
!27 = distinct !{!27, !28, !"_ZN17bnserve_inference12modes_kernel7_source9calibrateB3v49B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!28 = distinct !{!28, !"_ZN17bnserve_inference12modes_kernel7_source9calibrateB3v49B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!29 = !{!30, !1}
!30 = distinct !{!30, !31, !"_ZN17bnserve_inference12modes_kernel7_source13_add_productsB3v56B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxx5ArrayIxLi1E1C7mutable7alignedEdd5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!31 = distinct !{!31, !"_ZN17bnserve_inference12modes_kernel7_source13_add_productsB3v56B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxx5ArrayIxLi1E1C7mutable7alignedEdd5ArrayIdLi1E1C7mutable7alignedE"}
!32 = !{!33, !30, !1}
!33 = distinct !{!33, !34, !"_ZN17bnserve_inference12modes_kernel7_source6_turnsB3v75B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedEd5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!34 = distinct !{!34, !"_ZN17bnserve_inference12modes_kernel7_source6_turnsB3v75B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedEd5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!35 = !{!36, !30, !1}
!36 = distinct !{!36, !37, !"_ZN17bnserve_inference12modes_kernel7_source6_fixedB3v85B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!37 = distinct !{!37, !"_ZN17bnserve_inference12modes_kernel7_source6_fixedB3v85B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!38 = !{!39, !30, !1}
!39 = distinct !{!39, !40, !"_ZN17bnserve_inference6kernel5_sums9spline_atB3v89B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dEd5ArrayIdLi1E1C7mutable7alignedExxx: %retptr"}
!40 = distinct !{!40, !"_ZN17bnserve_inference6kernel5_sums9spline_atB3v89B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dEd5ArrayIdLi1E1C7mutable7alignedExxx"}
!41 = !{!42, !30, !1}
!42 = distinct !{!42, !43, !"_ZN17bnserve_inference12modes_kernel7_source8_splinedB3v92B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE8UniTupleIxLi3EE8UniTupleIdLi6EE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!43 = distinct !{!43, !"_ZN17bnserve_inference12modes_kernel7_source8_splinedB3v92B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE8UniTupleIxLi3EE8UniTupleIdLi6EE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!44 = !{!45, !30, !1}
!45 = distinct !{!45, !46, !"_ZN17bnserve_inference6kernel5_sums9add_termsB3v97B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEdd5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!46 = distinct !{!46, !"_ZN17bnserve_inference6kernel5_sums9add_termsB3v97B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEdd5ArrayIdLi1E1C7mutable7alignedE"}
!47 = !{!48, !1}
!48 = distinct !{!48, !49, !"_ZN17bnserve_inference12modes_kernel7_source10_add_pairsB3v98B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!49 = distinct !{!49, !"_ZN17bnserve_inference12modes_kernel7_source10_add_pairsB3v98B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!50 = !{!51, !48, !1}
!51 = distinct !{!51, !52, !"_ZN17bnserve_inference12modes_kernel7_source5_pairB4v110B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx: %retptr"}
!52 = distinct !{!52, !"_ZN17bnserve_inference12modes_kernel7_source5_pairB4v110B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx"}
