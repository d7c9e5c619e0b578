; sources: 66a5b3292255d403a6a781f81630cf910c4c5053499b3325eff7f6b13a49a61f
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
  %.375.i = shl nsw i64 %.77.i, 1
  %.376.i = add nsw i64 %.375.i, 3
  %.378.i = mul nsw i64 %.376.i, %.47.i
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
  %.1102.i = load i64, ptr %sunkaddr75.i, align 8, !noalias !0
  %.1105.i = mul nsw i64 %.1021.sroa.0.052.i, 56
  %.1106.i = add nsw i64 %.1102.i, %.1105.i
  %.1107.i = inttoptr i64 %.1106.i to ptr
  %.100.i.i = load double, ptr %13, align 8, !noalias !3
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
  %.262.i.i = xor i64 %3, %.252.i.i
  %.263.i.i = bitcast i64 %.262.i.i to double
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
  %.474.i4.i = tail call contract double @llvm.fma.f64(double %.468.i.i, double %.473.i.i, double 0xBFC5555555555555)
  %.475.i.i = fmul contract double %.467.i.i, %.468.i.i
  %.476.i.i = tail call contract double @llvm.fma.f64(double %.475.i.i, double %.474.i4.i, double %.467.i.i)
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
  %lsr.iv.i5.i = phi i64 [ %lsr.iv.next.i.i, %B506.endif.else.endif.endif.i.i ], [ 0, %B502.if.preheader.i.i ]
  %.793.not.i.i = icmp slt i64 %lsr.iv6.i.i, %.233.i
  br i1 %.793.not.i.i, label %B506.else.endif.endif.i.i, label %B506.else.endif.if.i.i, !prof !6

B506.else.endif.if.i.i:                           ; preds = %B502.if.i.i
  br label %B506.else.endif.endif.i.i

B506.else.endif.endif.i.i:                        ; preds = %B506.else.endif.if.i.i, %B502.if.i.i
  %.773.sroa.0.3.i.i = phi i64 [ %.233.i, %B506.else.endif.if.i.i ], [ %lsr.iv6.i.i, %B502.if.i.i ]
  %.886.i.i = getelementptr double, ptr %14, i64 %.773.sroa.0.3.i.i
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
  %.1071.i.i = getelementptr i8, ptr %.886.i.i, i64 32
  %.1072.i.i = load double, ptr %.1071.i.i, align 8, !noalias !3
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
  %.1574.not.i.i = icmp slt i64 %lsr.iv.i5.i, %.320.i
  br i1 %.1574.not.i.i, label %B506.endif.else.endif.endif.i.i, label %B506.endif.else.endif.if.i.i, !prof !6

B506.endif.else.endif.if.i.i:                     ; preds = %B506.else.endif.endif.i.i
  br label %B506.endif.else.endif.endif.i.i

B506.endif.else.endif.endif.i.i:                  ; preds = %B506.endif.else.endif.if.i.i, %B506.else.endif.endif.i.i
  %.1554.sroa.0.3.i.i = phi i64 [ %.320.i, %B506.endif.else.endif.if.i.i ], [ %lsr.iv.i5.i, %B506.else.endif.endif.i.i ]
  %.1667.i.i = getelementptr double, ptr %15, i64 %.1554.sroa.0.3.i.i
  %.1728.i.i = load double, ptr %sunkaddr9.i.i, align 8, !noalias !3
  %.1729.i.i = fmul contract double %.1507.i.i, %.1728.i.i
  %.1759.i.i = load double, ptr %sunkaddr11.i.i, align 8, !noalias !3
  %.1760.i.i = fmul contract double %.1524.i.i, %.1759.i.i
  %.1761.i.i = fadd contract double %.1729.i.i, %.1760.i.i
  %sunkaddr.i.i = shl i64 %lsr.iv.i5.i, 3
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
  %lsr.iv.next.i.i = add nuw i64 %lsr.iv.i5.i, 3
  %lsr.iv.next7.i.i = add nuw i64 %lsr.iv6.i.i, 9
  %lsr.iv.next9.i.i = add nsw i64 %lsr.iv8.i.i, -1
  %exitcond.not.i.i = icmp eq i64 %lsr.iv.next9.i.i, 0
  br i1 %exitcond.not.i.i, label %_ZN17bnserve_inference6kernel7_source9_geometryB3v17B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i, label %B502.if.i.i

_ZN17bnserve_inference6kernel7_source9_geometryB3v17B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i: ; preds = %B506.endif.else.endif.endif.i.i, %B930.i
  %.73.i.i = load i64, ptr %arg.arguments, align 8, !noalias !7
  %.369348.not.i.i = icmp slt i64 %.73.i.i, 1
  br i1 %.369348.not.i.i, label %B930.endif.endif.endif.i, label %B276.if.lr.ph.i.i

B1414.i:                                          ; preds = %.2353.endif.preheader.i, %.1962.if.i
  br i1 %.24841233.not.i, label %B1730.i, label %B1458.if.preheader.i

B1458.if.preheader.i:                             ; preds = %B1414.i
  %.548.i19.i = shl i64 %.1021.sroa.0.052.i, 4
  br label %B1458.if.i

B1458.loopexit.i:                                 ; preds = %_ZN17bnserve_inference12modes_kernel7_source10_add_pairsB3v85B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i, %B1458.if.i
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
  %scevgep259.i = getelementptr i8, ptr %12, i64 24
  %scevgep273.i = getelementptr i8, ptr %.415.i, i64 16
  %13 = inttoptr i64 %.144.i to ptr
  %14 = inttoptr i64 %.231.i to ptr
  %15 = inttoptr i64 %.318.i to ptr
  %sunkaddr75.i = getelementptr i8, ptr %arg.arguments, i64 176
  %.128.i.i = getelementptr i8, ptr %13, i64 8
  %.706618.not.i.i = icmp slt i64 %.47.i, 1
  %16 = icmp slt i64 %.790.i, 1
  %17 = icmp slt i64 %.794.i, 2
  %18 = icmp sgt i64 %"$phi862.0.2.0.i", 0
  %sunkaddr76.i = getelementptr i8, ptr %arg.arguments, i64 256
  %sunkaddr77.i = getelementptr i8, ptr %arg.arguments, i64 264
  %sunkaddr83.i = getelementptr i8, ptr %arg.arguments, i64 224
  %sunkaddr84.i = getelementptr i8, ptr %arg.arguments, i64 232
  %.186.i.i = getelementptr i8, ptr %arg.arguments, i64 168
  %.284.i.i = getelementptr i8, ptr %arg.arguments, i64 152
  %.1070.i.i = getelementptr i8, ptr %arg.arguments, i64 184
  %.260.i16.i = getelementptr i8, ptr %arg.arguments, i64 56
  %.491.i18.i = getelementptr i8, ptr %arg.arguments, i64 216
  %.1195.i.i = getelementptr i8, ptr %arg.arguments, i64 80
  %.1520.i13.i = getelementptr i8, ptr %arg.arguments, i64 192
  %.1637.i.i = getelementptr i8, ptr %arg.arguments, i64 200
  %scevgep.i.i = getelementptr i8, ptr %.625.i, i64 4096
  %.413.i.i = getelementptr i8, ptr %arg.arguments, i64 24
  %.138.i20.i = getelementptr i8, ptr %arg.arguments, i64 16
  %sunkaddr88.i.i = getelementptr i8, ptr %arg.arguments, i64 144
  %sunkaddr89.i.i = getelementptr i8, ptr %arg.arguments, i64 64
  %sunkaddr.i59.i = getelementptr i8, ptr %arg.arguments, i64 72
  br label %B930.i

B276.loopexit.i.loopexit.unr-lcssa.i:             ; preds = %B360.if.i.i
  br i1 %28, label %B276.loopexit.i.i, label %B360.if.i.epil.preheader.i

B360.if.i.epil.preheader.i:                       ; preds = %B360.if.i.preheader.i, %B276.loopexit.i.loopexit.unr-lcssa.i
  %lsr.iv.i.epil.init.i = phi i64 [ 0, %B360.if.i.preheader.i ], [ %lsr.iv.next.i.1.i, %B276.loopexit.i.loopexit.unr-lcssa.i ]
  %scevgep27.i.epil.i = getelementptr i8, ptr %sunkaddr78.i, i64 %lsr.iv.i.epil.init.i
  %.633.i.epil.i = load double, ptr %scevgep27.i.epil.i, align 8, !noalias !7
  %.635.i.epil.i = fmul contract double %.441.i.i, %.633.i.epil.i
  %19 = shl i64 %lsr.iv.i.epil.init.i, 1
  %sunkaddr278.i = getelementptr i8, ptr %20, i64 %19
  %.666.i.epil.i = load double, ptr %sunkaddr278.i, align 8, !noalias !7
  %.668.i.epil.i = fmul contract double %.474.i.i, %.666.i.epil.i
  %.669.i.epil.i = fadd contract double %.635.i.epil.i, %.668.i.epil.i
  %scevgep31.i.epil.i = getelementptr i8, ptr %lsr.iv29.i.i, i64 %19
  %scevgep32.i.epil.i = getelementptr i8, ptr %scevgep31.i.epil.i, i64 -8
  store double %.669.i.epil.i, ptr %scevgep32.i.epil.i, align 8, !noalias !7
  %sunkaddr281.i = getelementptr i8, ptr %sunkaddr278.i, i64 8
  %.731.i.epil.i = load double, ptr %sunkaddr281.i, align 8, !noalias !7
  %.733.i.epil.i = fmul contract double %.474.i.i, %.731.i.epil.i
  store double %.733.i.epil.i, ptr %scevgep31.i.epil.i, align 8, !noalias !7
  br label %B276.loopexit.i.i

B276.loopexit.i.i:                                ; preds = %B276.if.i.i, %B360.if.i.epil.preheader.i, %B276.loopexit.i.loopexit.unr-lcssa.i
  %scevgep30.i.i = getelementptr i8, ptr %lsr.iv29.i.i, i64 %21
  %scevgep260.i = getelementptr i8, ptr %lsr.iv.i, i64 %21
  %exitcond355.not.i.i = icmp eq i64 %.382.i.i, %.73.i.i
  br i1 %exitcond355.not.i.i, label %B930.endif.endif.endif.i, label %B276.if.i.i

B276.if.lr.ph.i.i:                                ; preds = %_ZN17bnserve_inference6kernel7_source9_geometryB3v17B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i
  %.102.i.i = load i64, ptr %.76.i, align 8, !noalias !7
  %.137.i.i = shl i64 %.1021.sroa.0.052.i, 3
  %.138.i.i = mul i64 %.137.i.i, %.102.i.i
  %.135.i.i = load i64, ptr %sunkaddr76.i, align 8, !noalias !7
  %.139.i.i = add nsw i64 %.135.i.i, %.138.i.i
  %.226.i.i = load i64, ptr %sunkaddr77.i, align 8, !noalias !7
  %.231.i.i = shl i64 %.1021.sroa.0.052.i, 4
  %.232.i.i = mul i64 %.231.i.i, %.102.i.i
  %.233.i.i = add nsw i64 %.226.i.i, %.232.i.i
  %20 = inttoptr i64 %.233.i.i to ptr
  %21 = shl i64 %.102.i.i, 4
  %scevgep266.i = getelementptr i8, ptr %20, i64 24
  %22 = lshr i64 %.102.i.i, 1
  %23 = and i64 %22, 4611686018427387903
  %24 = mul nsw i64 %23, -2
  %25 = icmp slt i64 %.102.i.i, 1
  %26 = icmp eq i64 %.102.i.i, 1
  %sunkaddr78.i = inttoptr i64 %.139.i.i to ptr
  %27 = and i64 %.102.i.i, 1
  %28 = icmp eq i64 %27, 0
  br label %B276.if.i.i

B276.if.i.i:                                      ; preds = %B276.if.lr.ph.i.i, %B276.loopexit.i.i
  %lsr.iv.i = phi ptr [ %scevgep259.i, %B276.if.lr.ph.i.i ], [ %scevgep260.i, %B276.loopexit.i.i ]
  %lsr.iv29.i.i = phi ptr [ %scevgep28.i.i, %B276.if.lr.ph.i.i ], [ %scevgep30.i.i, %B276.loopexit.i.i ]
  %.375343349.i.i = phi i64 [ 0, %B276.if.lr.ph.i.i ], [ %.382.i.i, %B276.loopexit.i.i ]
  %.382.i.i = add nuw nsw i64 %.375343349.i.i, 1
  %.idx.i.i = mul i64 %.375343349.i.i, 24
  %29 = getelementptr i8, ptr %.415.i, i64 %.idx.i.i
  %.441.i.i = load double, ptr %29, align 8, !noalias !7
  %30 = getelementptr i8, ptr %29, i64 8
  %.474.i.i = load double, ptr %30, align 8, !noalias !7
  br i1 %25, label %B276.loopexit.i.i, label %B360.if.i.preheader.i

B360.if.i.preheader.i:                            ; preds = %B276.if.i.i
  br i1 %26, label %B360.if.i.epil.preheader.i, label %B360.if.i.i

B360.if.i.i:                                      ; preds = %B360.if.i.preheader.i, %B360.if.i.i
  %lsr.iv66.i = phi i64 [ %lsr.iv.next67.i, %B360.if.i.i ], [ %24, %B360.if.i.preheader.i ]
  %lsr.iv.i.i = phi i64 [ %lsr.iv.next.i.1.i, %B360.if.i.i ], [ 0, %B360.if.i.preheader.i ]
  %sunkaddr79.i = getelementptr i8, ptr %sunkaddr78.i, i64 %lsr.iv.i.i
  %.633.i.i = load double, ptr %sunkaddr79.i, align 8, !noalias !7
  %.635.i.i = fmul contract double %.441.i.i, %.633.i.i
  %31 = shl i64 %lsr.iv.i.i, 1
  %scevgep269.i = getelementptr i8, ptr %scevgep266.i, i64 %31
  %scevgep270.i = getelementptr i8, ptr %scevgep269.i, i64 -16
  %scevgep271.i = getelementptr i8, ptr %scevgep269.i, i64 -24
  %.666.i.i = load double, ptr %scevgep271.i, align 8, !noalias !7
  %.668.i.i = fmul contract double %.474.i.i, %.666.i.i
  %.669.i.i = fadd contract double %.635.i.i, %.668.i.i
  %scevgep70.i = getelementptr i8, ptr %lsr.iv.i, i64 %31
  %scevgep72.i = getelementptr i8, ptr %scevgep70.i, i64 -16
  %scevgep71.i = getelementptr i8, ptr %scevgep70.i, i64 -24
  store double %.669.i.i, ptr %scevgep71.i, align 8, !noalias !7
  %.731.i.i = load double, ptr %scevgep270.i, align 8, !noalias !7
  %.733.i.i = fmul contract double %.474.i.i, %.731.i.i
  store double %.733.i.i, ptr %scevgep72.i, align 8, !noalias !7
  %sunkaddr82.i = getelementptr i8, ptr %sunkaddr79.i, i64 8
  %.633.i.1.i = load double, ptr %sunkaddr82.i, align 8, !noalias !7
  %.635.i.1.i = fmul contract double %.441.i.i, %.633.i.1.i
  %scevgep74.i = getelementptr i8, ptr %scevgep269.i, i64 -8
  %.666.i.1.i = load double, ptr %scevgep74.i, align 8, !noalias !7
  %.668.i.1.i = fmul contract double %.474.i.i, %.666.i.1.i
  %.669.i.1.i = fadd contract double %.635.i.1.i, %.668.i.1.i
  %scevgep69.i = getelementptr i8, ptr %scevgep70.i, i64 -8
  store double %.669.i.1.i, ptr %scevgep69.i, align 8, !noalias !7
  %.731.i.1.i = load double, ptr %scevgep269.i, align 8, !noalias !7
  %.733.i.1.i = fmul contract double %.474.i.i, %.731.i.1.i
  store double %.733.i.1.i, ptr %scevgep70.i, align 8, !noalias !7
  %lsr.iv.next.i.1.i = add i64 %lsr.iv.i.i, 16
  %lsr.iv.next67.i = add i64 %lsr.iv66.i, 2
  %niter.ncmp.1.i = icmp eq i64 %lsr.iv.next67.i, 0
  br i1 %niter.ncmp.1.i, label %B276.loopexit.i.loopexit.unr-lcssa.i, label %B360.if.i.i

B930.endif.endif.endif.i:                         ; preds = %B276.loopexit.i.i, %_ZN17bnserve_inference6kernel7_source9_geometryB3v17B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i
  br i1 %16, label %.1574.if.i, label %.1574.endif.preheader.i, !prof !10

.1574.endif.preheader.i:                          ; preds = %B930.endif.endif.endif.i
  %.1266.i = load i64, ptr %sunkaddr83.i, align 8, !noalias !0
  %.1270.i = mul nsw i64 %.1021.sroa.0.052.i, %.1268.i
  %.1271.i = add nsw i64 %.1266.i, %.1270.i
  %.1274.i = inttoptr i64 %.1271.i to ptr
  tail call void @llvm.memset.p0.i64(ptr align 8 %.1274.i, i8 0, i64 %.1268.i, i1 false), !noalias !0
  br label %.1574.if.i

.1574.if.i:                                       ; preds = %.1574.endif.preheader.i, %B930.endif.endif.endif.i
  br i1 %17, label %.1962.if.i, label %.1962.endif.preheader.i, !prof !10

.1962.endif.preheader.i:                          ; preds = %.1574.if.i
  %.1654.i = load i64, ptr %sunkaddr84.i, align 8, !noalias !0
  %.1658.i = mul nsw i64 %.1021.sroa.0.052.i, %.1656.i
  %.1659.i = add nsw i64 %.1654.i, %.1658.i
  %.1662.i = inttoptr i64 %.1659.i to ptr
  tail call void @llvm.memset.p0.i64(ptr align 8 %.1662.i, i8 0, i64 %.1656.i, i1 false), !noalias !0
  br label %.1962.if.i

.1962.if.i:                                       ; preds = %.1962.endif.preheader.i, %.1574.if.i
  br i1 %18, label %.2353.endif.preheader.i, label %B1414.i

.2353.endif.preheader.i:                          ; preds = %.1962.if.i
  %.2045.i = load i64, ptr %.869.i, align 8, !noalias !0
  %.2049.i = mul nsw i64 %.1021.sroa.0.052.i, %.2047.i
  %.2050.i = add nsw i64 %.2045.i, %.2049.i
  %.2053.i = inttoptr i64 %.2050.i to ptr
  tail call void @llvm.memset.p0.i64(ptr align 8 %.2053.i, i8 0, i64 %.2047.i, i1 false), !noalias !0
  br label %B1414.i

B1458.if.i:                                       ; preds = %B1458.loopexit.i, %B1458.if.preheader.i
  %.248312171237.i = phi i64 [ %.2493.i, %B1458.loopexit.i ], [ %.2463.i, %B1458.if.preheader.i ]
  %.249012211236.i = phi i64 [ %.2497.i, %B1458.loopexit.i ], [ 0, %B1458.if.preheader.i ]
  %.2493.i = add nsw i64 %.248312171237.i, -1
  %.2497.i = add i64 %.249012211236.i, 512
  %.2527.i = sub nsw i64 %.755.i, %.249012211236.i
  %.13.i.i = tail call i64 @llvm.smin.i64(i64 %.2527.i, i64 512)
  br i1 %.706618.not.i.i, label %B1458.loopexit.i, label %B1540.if.preheader.i

B1540.if.preheader.i:                             ; preds = %B1458.if.i
  %.104.i.i.i = icmp sgt i64 %.2527.i, 0
  %32 = shl nuw nsw i64 %.13.i.i, 3
  %unroll_iter.i.i.i = and i64 %.13.i.i, 9223372036854775800
  %33 = add nsw i64 %unroll_iter.i.i.i, -2
  %34 = lshr exact i64 %33, 1
  %35 = add nuw i64 %34, 1
  %36 = icmp slt i64 %.2527.i, 1
  %.60.1.i.i.i = ashr exact i64 %.13.i.i, 3
  %37 = shl i64 %.249012211236.i, 3
  %38 = icmp slt i64 %.60.1.i.i.i, 1
  br label %B1540.if.i

B1540.if.i:                                       ; preds = %_ZN17bnserve_inference12modes_kernel7_source10_add_pairsB3v85B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i, %B1540.if.preheader.i
  %lsr.iv274.i = phi ptr [ %scevgep275.i, %_ZN17bnserve_inference12modes_kernel7_source10_add_pairsB3v85B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i ], [ %scevgep273.i, %B1540.if.preheader.i ]
  %.264512101214.i = phi i64 [ %.2652.i, %_ZN17bnserve_inference12modes_kernel7_source10_add_pairsB3v85B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i ], [ 0, %B1540.if.preheader.i ]
  %.2652.i = add nuw nsw i64 %.264512101214.i, 1
  %.87.i.i = load i64, ptr %.76.i, align 8, !noalias !11
  %.117.i.i = load i64, ptr %.106.i, align 8, !noalias !11
  %.147.i.i = load i64, ptr %.711.i, align 8, !noalias !11
  %.187.i.i = load i64, ptr %.186.i.i, align 8, !noalias !11
  %.189.i.i = shl i64 %.87.i.i, 4
  %.191.i.i = mul i64 %.147.i.i, %.189.i.i
  %.193.i.i = mul i64 %.191.i.i, %.1021.sroa.0.052.i
  %.194.i6.i = add nsw i64 %.193.i.i, %.187.i.i
  %.285.i.i = load i64, ptr %.284.i.i, align 8, !noalias !11
  %.343.i.i = shl nsw i64 %.117.i.i, 10
  %.381.inv.i.i = icmp sgt i64 %.117.i.i, 0
  %..343.i.i = select i1 %.381.inv.i.i, i64 %.343.i.i, i64 0
  %.423945.i.i = icmp sgt i64 %..343.i.i, 0
  br i1 %.423945.i.i, label %B328.if.preheader.i.i, label %B344.i.i

B328.if.preheader.i.i:                            ; preds = %B1540.if.i
  %39 = shl nuw i64 %..343.i.i, 3
  tail call void @llvm.memset.p0.i64(ptr nonnull align 8 %.625.i, i8 0, i64 %39, i1 false), !noalias !11
  br label %B344.i.i

B344.i.i:                                         ; preds = %B328.if.preheader.i.i, %B1540.if.i
  %.498.i7.i = sub i64 %.147.i.i, %.249012211236.i
  %.13.i.i.i = tail call i64 @llvm.smin.i64(i64 %.498.i7.i, i64 range(i64 -9223372036854775808, 513) %.13.i.i)
  %.611955.not.i.i = icmp slt i64 %.87.i.i, 1
  br i1 %.611955.not.i.i, label %B578.i.i, label %B412.if.lr.ph.i.i

B578.i.i:                                         ; preds = %B414.endif.endif.endif.i.i, %B344.i.i
  %.1071.i10.i = load i64, ptr %.1070.i.i, align 8, !noalias !11
  %.1076.i.i = icmp sgt i64 %.1071.i10.i, 0
  br i1 %.1076.i.i, label %B628.i.i, label %_ZN17bnserve_inference12modes_kernel7_source7_gatherB3v25B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i

B628.i.i:                                         ; preds = %B578.i.i
  %.1079.i.i = shl nsw i64 %.1071.i10.i, 3
  %.1109.i.i = load i64, ptr %arg.arguments, align 8, !noalias !11
  %.1111.i.i = mul nsw i64 %.1109.i.i, %.1021.sroa.0.052.i
  %.1115.i.i = add nsw i64 %.1111.i.i, %.264512101214.i
  %.1118.i.i = mul nsw i64 %.1115.i.i, %.1079.i.i
  %.1123.i.i = sub i64 0, %.147.i.i
  %.1131.1.i.i = and i64 %.1123.i.i, -8
  %.1165.i.i = sub i64 0, %.1131.1.i.i
  %.1196.i.i = load i64, ptr %.1195.i.i, align 8, !noalias !11
  %.1198.i11.i = mul nsw i64 %.1071.i10.i, %.1165.i.i
  %.idx.i12.i = shl i64 %.117.i.i, 13
  %40 = getelementptr i8, ptr %.625.i, i64 %.idx.i12.i
  %.1335.i.i = getelementptr i8, ptr %40, i64 4096
  %.1521.i.i = load i64, ptr %.1520.i13.i, align 8, !noalias !11
  %.1522.i14.i = add nsw i64 %.1118.i.i, %.1521.i.i
  br i1 %.104.i.i.i, label %B60.if.preheader.i.i.i, label %B128.if.lr.ph.i.i.i

B412.if.lr.ph.i.i:                                ; preds = %B344.i.i
  %.911.i.i = mul nuw nsw i64 %.87.i.i, %.264512101214.i
  %41 = icmp slt i64 %.13.i.i.i, 1
  %42 = inttoptr i64 %.285.i.i to ptr
  %43 = inttoptr i64 %.194.i6.i to ptr
  br label %B412.if.i.i

B412.if.i.i:                                      ; preds = %B414.endif.endif.endif.i.i, %B412.if.lr.ph.i.i
  %lsr.iv273.i.i = phi i64 [ %.249012211236.i, %B412.if.lr.ph.i.i ], [ %lsr.iv.next274.i.i, %B414.endif.endif.endif.i.i ]
  %.617952956.i.i = phi i64 [ 0, %B412.if.lr.ph.i.i ], [ %.624.i.i, %B414.endif.endif.endif.i.i ]
  %.624.i.i = add nuw nsw i64 %.617952956.i.i, 1
  %44 = getelementptr i64, ptr %42, i64 %.617952956.i.i
  %.679.i.i = load i64, ptr %44, align 8, !noalias !11
  %.698.idx.i.i = shl i64 %.679.i.i, 13
  %.698.i.i = getelementptr i8, ptr %.625.i, i64 %.698.idx.i.i
  %.766.i.i = getelementptr i8, ptr %.698.i.i, i64 4096
  %.912.i.i = add nuw nsw i64 %.617952956.i.i, %.911.i.i
  %.idx13.i.i = shl i64 %.912.i.i, 4
  %45 = getelementptr i8, ptr %.547.i, i64 %.idx13.i.i
  %.948.i8.i = load double, ptr %45, align 8, !noalias !11
  %46 = getelementptr i8, ptr %45, i64 8
  %.979.i9.i = load double, ptr %46, align 8, !noalias !11
  br i1 %41, label %B414.endif.endif.endif.i.i, label %B34.if.preheader.i.i.i

B34.if.preheader.i.i.i:                           ; preds = %B412.if.i.i
  %.916.i.i = mul nsw i64 %.617952956.i.i, %.147.i.i
  %.918.i.i = add nsw i64 %.916.i.i, %.249012211236.i
  %47 = shl i64 %.918.i.i, 4
  %48 = getelementptr i8, ptr %43, i64 %47
  %scevgep2.i.i.i = getelementptr i8, ptr %48, i64 8
  br label %B34.if.i.i.i

B34.if.i.i.i:                                     ; preds = %B34.if.i.i.i, %B34.if.preheader.i.i.i
  %lsr.iv.i.i.i = phi ptr [ %scevgep2.i.i.i, %B34.if.preheader.i.i.i ], [ %scevgep3.i.i.i, %B34.if.i.i.i ]
  %.143136138.i.i.i = phi i64 [ 0, %B34.if.preheader.i.i.i ], [ %.150.i.i.i, %B34.if.i.i.i ]
  %.150.i.i.i = add nuw nsw i64 %.143136138.i.i.i, 1
  %49 = add i64 %.143136138.i.i.i, %lsr.iv273.i.i
  %.191.i.i.i = icmp slt i64 %49, 0
  %50 = select i1 %.191.i.i.i, i64 %.191.i.i, i64 0
  %scevgep4.i.i.i = getelementptr i8, ptr %lsr.iv.i.i.i, i64 %50
  %scevgep5.i.i.i = getelementptr i8, ptr %scevgep4.i.i.i, i64 -8
  %.207.i.i.i = load double, ptr %scevgep5.i.i.i, align 8, !noalias !14
  %.241.i.i.i = load double, ptr %scevgep4.i.i.i, align 8, !noalias !14
  %51 = shl i64 %.143136138.i.i.i, 3
  %scevgep271.i.i = getelementptr i8, ptr %.766.i.i, i64 %51
  %scevgep272.i.i = getelementptr i8, ptr %scevgep271.i.i, i64 -4096
  %.271.i.i.i = load double, ptr %scevgep272.i.i, align 8, !noalias !14
  %.273.i.i.i = fmul contract double %.948.i8.i, %.207.i.i.i
  %.275.i.i.i = fmul contract double %.979.i9.i, %.241.i.i.i
  %.276.i.i.i = fsub contract double %.273.i.i.i, %.275.i.i.i
  %.277.i.i.i = fadd contract double %.271.i.i.i, %.276.i.i.i
  store double %.277.i.i.i, ptr %scevgep272.i.i, align 8, !noalias !14
  %.337.i.i.i = load double, ptr %scevgep271.i.i, align 8, !noalias !14
  %.339.i.i.i = fmul contract double %.948.i8.i, %.241.i.i.i
  %.341.i.i.i = fmul contract double %.979.i9.i, %.207.i.i.i
  %.342.i.i.i = fadd contract double %.341.i.i.i, %.339.i.i.i
  %.343.i.i.i = fadd contract double %.342.i.i.i, %.337.i.i.i
  store double %.343.i.i.i, ptr %scevgep271.i.i, align 8, !noalias !14
  %scevgep3.i.i.i = getelementptr i8, ptr %lsr.iv.i.i.i, i64 16
  %exitcond.not.i.i.i = icmp eq i64 %.13.i.i.i, %.150.i.i.i
  br i1 %exitcond.not.i.i.i, label %B414.endif.endif.endif.i.i, label %B34.if.i.i.i

B414.endif.endif.endif.i.i:                       ; preds = %B34.if.i.i.i, %B412.if.i.i
  %lsr.iv.next274.i.i = add i64 %lsr.iv273.i.i, %.147.i.i
  %exitcond983.not.i.i = icmp eq i64 %.624.i.i, %.87.i.i
  br i1 %exitcond983.not.i.i, label %B578.i.i, label %B412.if.i.i

B60.if.preheader.i.i.i:                           ; preds = %B628.i.i
  %.1267.i.i = getelementptr inbounds double, ptr %.625.i, i64 %.343.i.i
  tail call void @llvm.memset.p0.i64(ptr nonnull align 8 %.1267.i.i, i8 0, i64 %32, i1 false), !noalias !17
  br label %B128.if.lr.ph.i.i.i

B128.if.lr.ph.i.i.i:                              ; preds = %B60.if.preheader.i.i.i, %B628.i.i
  %52 = inttoptr i64 %.1196.i.i to ptr
  %scevgep252.i.i = getelementptr i8, ptr %40, i64 24
  %scevgep260.i.i = getelementptr i8, ptr %52, i64 24
  %53 = inttoptr i64 %.1522.i14.i to ptr
  br label %B128.if.i.i.i

B284.i.i.i:                                       ; preds = %B228.if.i.i.i, %B130.else.endif.endif.endif.endif.i.i.i
  %exitcond292.not.i.i.i = icmp eq i64 %.324.i.i.i, %.1071.i10.i
  br i1 %exitcond292.not.i.i.i, label %B628.endif.endif.endif.endif.endif.endif.i.i, label %B128.if.i.i.i

B128.if.i.i.i:                                    ; preds = %B284.i.i.i, %B128.if.lr.ph.i.i.i
  %.317279285.i.i.i = phi i64 [ 0, %B128.if.lr.ph.i.i.i ], [ %.324.i.i.i, %B284.i.i.i ]
  %.324.i.i.i = add nuw nsw i64 %.317279285.i.i.i, 1
  %.350.i.i.i = mul nsw i64 %.317279285.i.i.i, %.1165.i.i
  %.352.i.i.i = add nsw i64 %.350.i.i.i, %.249012211236.i
  %.395.i.i.i = icmp slt i64 %.352.i.i.i, 0
  %.396.i.i.i = select i1 %.395.i.i.i, i64 %.1198.i11.i, i64 0
  %.397.i.i.i = add i64 %.396.i.i.i, %.352.i.i.i
  %.400.i.i.i = icmp slt i64 %.397.i.i.i, 0
  br i1 %.400.i.i.i, label %B130.else.if.i.i.i, label %B130.else.endif.i.i.i, !prof !10

B130.else.if.i.i.i:                               ; preds = %B128.if.i.i.i
  br label %B130.else.endif.i.i.i

B130.else.endif.i.i.i:                            ; preds = %B130.else.if.i.i.i, %B128.if.i.i.i
  %.385.sroa.0.1.i.i.i = phi i64 [ 0, %B130.else.if.i.i.i ], [ %.397.i.i.i, %B128.if.i.i.i ]
  %.405.not.i.i.i = icmp slt i64 %.397.i.i.i, %.1198.i11.i
  br i1 %.405.not.i.i.i, label %B130.else.endif.endif.endif.endif.i.i.i, label %B130.else.endif.if.i.i.i, !prof !6

B130.else.endif.if.i.i.i:                         ; preds = %B130.else.endif.i.i.i
  br label %B130.else.endif.endif.endif.endif.i.i.i

B130.else.endif.endif.endif.endif.i.i.i:          ; preds = %B130.else.endif.if.i.i.i, %B130.else.endif.i.i.i
  %.385.sroa.0.3.i.i.i = phi i64 [ %.1198.i11.i, %B130.else.endif.if.i.i.i ], [ %.385.sroa.0.1.i.i.i, %B130.else.endif.i.i.i ]
  %54 = getelementptr double, ptr %53, i64 %.317279285.i.i.i
  %.565.i.i.i = load double, ptr %54, align 8, !noalias !17
  br i1 %36, label %B284.i.i.i, label %B228.if.preheader.i.i.i

B228.if.preheader.i.i.i:                          ; preds = %B130.else.endif.endif.endif.endif.i.i.i
  %55 = shl i64 %.385.sroa.0.3.i.i.i, 3
  %scevgep261.i.i = getelementptr i8, ptr %scevgep260.i.i, i64 %55
  br label %B228.if.i.i.i

B228.if.i.i.i:                                    ; preds = %B228.if.i.i.i, %B228.if.preheader.i.i.i
  %lsr.iv22.i.i = phi i64 [ %lsr.iv.next23.i.i, %B228.if.i.i.i ], [ %35, %B228.if.preheader.i.i.i ]
  %.655272274.i.i.i = phi i64 [ %.662.1.i.1.i.i, %B228.if.i.i.i ], [ 0, %B228.if.preheader.i.i.i ]
  %56 = shl i64 %.655272274.i.i.i, 3
  %scevgep258.i.i = getelementptr i8, ptr %scevgep252.i.i, i64 %56
  %scevgep259.i.i = getelementptr i8, ptr %scevgep258.i.i, i64 -24
  %.716.i.i.i = load double, ptr %scevgep259.i.i, align 8, !noalias !17
  %scevgep264.i.i = getelementptr i8, ptr %scevgep261.i.i, i64 %56
  %scevgep265.i.i = getelementptr i8, ptr %scevgep264.i.i, i64 -16
  %scevgep27.i.i = getelementptr i8, ptr %scevgep264.i.i, i64 -24
  %.746.i.i.i = load double, ptr %scevgep27.i.i, align 8, !noalias !17
  %.748.i.i.i = fmul contract double %.565.i.i.i, %.746.i.i.i
  %.749.i.i.i = fadd contract double %.716.i.i.i, %.748.i.i.i
  store double %.749.i.i.i, ptr %scevgep259.i.i, align 8, !noalias !17
  %scevgep31.i.i = getelementptr i8, ptr %scevgep258.i.i, i64 -16
  %.716.1.i.i.i = load double, ptr %scevgep31.i.i, align 8, !noalias !17
  %.746.1.i.i.i = load double, ptr %scevgep265.i.i, align 8, !noalias !17
  %.748.1.i.i.i = fmul contract double %.565.i.i.i, %.746.1.i.i.i
  %.749.1.i.i.i = fadd contract double %.716.1.i.i.i, %.748.1.i.i.i
  store double %.749.1.i.i.i, ptr %scevgep31.i.i, align 8, !noalias !17
  %scevgep29.i.i = getelementptr i8, ptr %scevgep258.i.i, i64 -8
  %.716.i.1.i.i = load double, ptr %scevgep29.i.i, align 8, !noalias !17
  %scevgep25.i.i = getelementptr i8, ptr %scevgep264.i.i, i64 -8
  %.746.i.1.i.i = load double, ptr %scevgep25.i.i, align 8, !noalias !17
  %.748.i.1.i.i = fmul contract double %.565.i.i.i, %.746.i.1.i.i
  %.749.i.1.i.i = fadd contract double %.716.i.1.i.i, %.748.i.1.i.i
  store double %.749.i.1.i.i, ptr %scevgep29.i.i, align 8, !noalias !17
  %.662.1.i.1.i.i = add i64 %.655272274.i.i.i, 4
  %.716.1.i.1.i.i = load double, ptr %scevgep258.i.i, align 8, !noalias !17
  %.746.1.i.1.i.i = load double, ptr %scevgep264.i.i, align 8, !noalias !17
  %.748.1.i.1.i.i = fmul contract double %.565.i.i.i, %.746.1.i.1.i.i
  %.749.1.i.1.i.i = fadd contract double %.716.1.i.1.i.i, %.748.1.i.1.i.i
  store double %.749.1.i.1.i.i, ptr %scevgep258.i.i, align 8, !noalias !17
  %lsr.iv.next23.i.i = add i64 %lsr.iv22.i.i, -2
  %niter.ncmp.1.i.i = icmp eq i64 %lsr.iv.next23.i.i, 0
  br i1 %niter.ncmp.1.i.i, label %B284.i.i.i, label %B228.if.i.i.i

B628.endif.endif.endif.endif.endif.endif.i.i:     ; preds = %B284.i.i.i
  %.1638.i.i = load i64, ptr %.1637.i.i, align 8, !noalias !11
  %.1644.i.i = add nsw i64 %.1638.i.i, %.1118.i.i
  br i1 %.104.i.i.i, label %B60.if.preheader.i106.i.i, label %B128.if.lr.ph.i57.i.i

B60.if.preheader.i106.i.i:                        ; preds = %B628.endif.endif.endif.endif.endif.endif.i.i
  tail call void @llvm.memset.p0.i64(ptr align 8 %.1335.i.i, i8 0, i64 %32, i1 false), !noalias !20
  br label %B128.if.lr.ph.i57.i.i

B128.if.lr.ph.i57.i.i:                            ; preds = %B60.if.preheader.i106.i.i, %B628.endif.endif.endif.endif.endif.endif.i.i
  %scevgep235.i.i = getelementptr i8, ptr %40, i64 4120
  %57 = inttoptr i64 %.1644.i.i to ptr
  br label %B128.if.i60.i.i

B284.i103.i.i:                                    ; preds = %B228.if.i80.i.i, %B130.else.endif.endif.endif.endif.i73.i.i
  %exitcond292.not.i104.i.i = icmp eq i64 %.324.i62.i.i, %.1071.i10.i
  br i1 %exitcond292.not.i104.i.i, label %B628.endif.endif.endif.endif.endif.endif.endif.endif.i.i, label %B128.if.i60.i.i

B128.if.i60.i.i:                                  ; preds = %B284.i103.i.i, %B128.if.lr.ph.i57.i.i
  %.317279285.i61.i.i = phi i64 [ 0, %B128.if.lr.ph.i57.i.i ], [ %.324.i62.i.i, %B284.i103.i.i ]
  %.324.i62.i.i = add nuw nsw i64 %.317279285.i61.i.i, 1
  %.350.i63.i.i = mul nsw i64 %.317279285.i61.i.i, %.1165.i.i
  %.352.i64.i.i = add nsw i64 %.350.i63.i.i, %.249012211236.i
  %.395.i65.i.i = icmp slt i64 %.352.i64.i.i, 0
  %.396.i66.i.i = select i1 %.395.i65.i.i, i64 %.1198.i11.i, i64 0
  %.397.i67.i.i = add i64 %.396.i66.i.i, %.352.i64.i.i
  %.400.i68.i.i = icmp slt i64 %.397.i67.i.i, 0
  br i1 %.400.i68.i.i, label %B130.else.if.i105.i.i, label %B130.else.endif.i69.i.i, !prof !10

B130.else.if.i105.i.i:                            ; preds = %B128.if.i60.i.i
  br label %B130.else.endif.i69.i.i

B130.else.endif.i69.i.i:                          ; preds = %B130.else.if.i105.i.i, %B128.if.i60.i.i
  %.385.sroa.0.1.i70.i.i = phi i64 [ 0, %B130.else.if.i105.i.i ], [ %.397.i67.i.i, %B128.if.i60.i.i ]
  %.405.not.i71.i.i = icmp slt i64 %.397.i67.i.i, %.1198.i11.i
  br i1 %.405.not.i71.i.i, label %B130.else.endif.endif.endif.endif.i73.i.i, label %B130.else.endif.if.i72.i.i, !prof !6

B130.else.endif.if.i72.i.i:                       ; preds = %B130.else.endif.i69.i.i
  br label %B130.else.endif.endif.endif.endif.i73.i.i

B130.else.endif.endif.endif.endif.i73.i.i:        ; preds = %B130.else.endif.if.i72.i.i, %B130.else.endif.i69.i.i
  %.385.sroa.0.3.i74.i.i = phi i64 [ %.1198.i11.i, %B130.else.endif.if.i72.i.i ], [ %.385.sroa.0.1.i70.i.i, %B130.else.endif.i69.i.i ]
  %58 = getelementptr double, ptr %57, i64 %.317279285.i61.i.i
  %.565.i76.i.i = load double, ptr %58, align 8, !noalias !20
  br i1 %36, label %B284.i103.i.i, label %B228.if.preheader.i77.i.i

B228.if.preheader.i77.i.i:                        ; preds = %B130.else.endif.endif.endif.endif.i73.i.i
  %59 = shl i64 %.385.sroa.0.3.i74.i.i, 3
  %scevgep244.i.i = getelementptr i8, ptr %scevgep260.i.i, i64 %59
  br label %B228.if.i80.i.i

B228.if.i80.i.i:                                  ; preds = %B228.if.i80.i.i, %B228.if.preheader.i77.i.i
  %lsr.iv5.i.i = phi i64 [ %lsr.iv.next6.i.i, %B228.if.i80.i.i ], [ %35, %B228.if.preheader.i77.i.i ]
  %.655272274.i81.i.i = phi i64 [ %.662.1.i89.1.i.i, %B228.if.i80.i.i ], [ 0, %B228.if.preheader.i77.i.i ]
  %60 = shl i64 %.655272274.i81.i.i, 3
  %scevgep241.i.i = getelementptr i8, ptr %scevgep235.i.i, i64 %60
  %scevgep242.i.i = getelementptr i8, ptr %scevgep241.i.i, i64 -24
  %.716.i83.i.i = load double, ptr %scevgep242.i.i, align 8, !noalias !20
  %scevgep247.i.i = getelementptr i8, ptr %scevgep244.i.i, i64 %60
  %scevgep248.i.i = getelementptr i8, ptr %scevgep247.i.i, i64 -16
  %scevgep14.i.i = getelementptr i8, ptr %scevgep247.i.i, i64 -24
  %.746.i86.i.i = load double, ptr %scevgep14.i.i, align 8, !noalias !20
  %.748.i87.i.i = fmul contract double %.565.i76.i.i, %.746.i86.i.i
  %.749.i88.i.i = fadd contract double %.716.i83.i.i, %.748.i87.i.i
  store double %.749.i88.i.i, ptr %scevgep242.i.i, align 8, !noalias !20
  %scevgep21.i.i = getelementptr i8, ptr %scevgep241.i.i, i64 -16
  %.716.1.i91.i.i = load double, ptr %scevgep21.i.i, align 8, !noalias !20
  %.746.1.i92.i.i = load double, ptr %scevgep248.i.i, align 8, !noalias !20
  %.748.1.i93.i.i = fmul contract double %.565.i76.i.i, %.746.1.i92.i.i
  %.749.1.i94.i.i = fadd contract double %.716.1.i91.i.i, %.748.1.i93.i.i
  store double %.749.1.i94.i.i, ptr %scevgep21.i.i, align 8, !noalias !20
  %scevgep17.i.i = getelementptr i8, ptr %scevgep241.i.i, i64 -8
  %.716.i83.1.i.i = load double, ptr %scevgep17.i.i, align 8, !noalias !20
  %scevgep10.i.i = getelementptr i8, ptr %scevgep247.i.i, i64 -8
  %.746.i86.1.i.i = load double, ptr %scevgep10.i.i, align 8, !noalias !20
  %.748.i87.1.i.i = fmul contract double %.565.i76.i.i, %.746.i86.1.i.i
  %.749.i88.1.i.i = fadd contract double %.716.i83.1.i.i, %.748.i87.1.i.i
  store double %.749.i88.1.i.i, ptr %scevgep17.i.i, align 8, !noalias !20
  %.662.1.i89.1.i.i = add i64 %.655272274.i81.i.i, 4
  %.716.1.i91.1.i.i = load double, ptr %scevgep241.i.i, align 8, !noalias !20
  %.746.1.i92.1.i.i = load double, ptr %scevgep247.i.i, align 8, !noalias !20
  %.748.1.i93.1.i.i = fmul contract double %.565.i76.i.i, %.746.1.i92.1.i.i
  %.749.1.i94.1.i.i = fadd contract double %.716.1.i91.1.i.i, %.748.1.i93.1.i.i
  store double %.749.1.i94.1.i.i, ptr %scevgep241.i.i, align 8, !noalias !20
  %lsr.iv.next6.i.i = add i64 %lsr.iv5.i.i, -2
  %niter229.ncmp.1.i.i = icmp eq i64 %lsr.iv.next6.i.i, 0
  br i1 %niter229.ncmp.1.i.i, label %B284.i103.i.i, label %B228.if.i80.i.i

B628.endif.endif.endif.endif.endif.endif.endif.endif.i.i: ; preds = %B284.i103.i.i
  %.1818966.not.i.i = icmp slt i64 %.117.i.i, 1
  br i1 %.1818966.not.i.i, label %_ZN17bnserve_inference12modes_kernel7_source7_gatherB3v25B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i, label %B1068.if.i.i

B1068.if.i.i:                                     ; preds = %B628.endif.endif.endif.endif.endif.endif.endif.endif.i.i, %B1070.endif.endif.endif.i.i
  %lsr.iv.i15.i = phi ptr [ %scevgep230.i.i, %B1070.endif.endif.endif.i.i ], [ %scevgep.i.i, %B628.endif.endif.endif.endif.endif.endif.endif.endif.i.i ]
  %.1824963967.i.i = phi i64 [ %.1831.i.i, %B1070.endif.endif.endif.i.i ], [ 0, %B628.endif.endif.endif.endif.endif.endif.endif.endif.i.i ]
  %.1831.i.i = add nuw nsw i64 %.1824963967.i.i, 1
  br i1 %36, label %B1070.endif.endif.endif.i.i, label %B56.if.i.i.i

B56.if.i.i.i:                                     ; preds = %B1068.if.i.i, %B56.if.i.i.i
  %.158152154.i.i.i = phi i64 [ %.165.i.i.i, %B56.if.i.i.i ], [ 0, %B1068.if.i.i ]
  %.165.i.i.i = add nuw nsw i64 %.158152154.i.i.i, 1
  %61 = shl i64 %.158152154.i.i.i, 3
  %scevgep3.i118.i.i = getelementptr i8, ptr %.1335.i.i, i64 %61
  %.219.i.i.i = load double, ptr %scevgep3.i118.i.i, align 8, !noalias !23
  %scevgep234.i.i = getelementptr i8, ptr %scevgep3.i118.i.i, i64 -4096
  %.249.i.i.i = load double, ptr %scevgep234.i.i, align 8, !noalias !23
  %.250.i.i.i = fadd contract double %.249.i.i.i, 1.000000e+00
  %.251.i.i.i = fmul contract double %.219.i.i.i, %.219.i.i.i
  %.252.i.i.i = fadd contract double %.251.i.i.i, 4.000000e+00
  %.256.i.i.i = fdiv contract double %.250.i.i.i, %.252.i.i.i
  %.258.i.i.i = fsub contract double 4.000000e+00, %.251.i.i.i
  %.259.i.i.i = fmul contract double %.258.i.i.i, %.256.i.i.i
  %.260.i.i.i = fmul contract double %.219.i.i.i, 4.000000e+00
  %.261.i.i.i = fmul contract double %.260.i.i.i, %.256.i.i.i
  %scevgep1.i.i = getelementptr i8, ptr %lsr.iv.i15.i, i64 %61
  %scevgep4.i.i = getelementptr i8, ptr %scevgep1.i.i, i64 -4096
  %.291.i.i.i = load double, ptr %scevgep4.i.i, align 8, !noalias !23
  %.321.i.i.i = load double, ptr %scevgep1.i.i, align 8, !noalias !23
  %.322.i.i.i = fmul contract double %.291.i.i.i, %.259.i.i.i
  %.323.i.i.i = fmul contract double %.321.i.i.i, %.261.i.i.i
  %.324.i122.i.i = fsub contract double %.322.i.i.i, %.323.i.i.i
  store double %.324.i122.i.i, ptr %scevgep4.i.i, align 8, !noalias !23
  %.355.i.i.i = fmul contract double %.291.i.i.i, %.261.i.i.i
  %.356.i.i.i = fmul contract double %.321.i.i.i, %.259.i.i.i
  %.357.i.i.i = fadd contract double %.355.i.i.i, %.356.i.i.i
  store double %.357.i.i.i, ptr %scevgep1.i.i, align 8, !noalias !23
  %exitcond.not.i123.i.i = icmp eq i64 %.13.i.i, %.165.i.i.i
  br i1 %exitcond.not.i123.i.i, label %B1070.endif.endif.endif.i.i, label %B56.if.i.i.i

B1070.endif.endif.endif.i.i:                      ; preds = %B56.if.i.i.i, %B1068.if.i.i
  %scevgep230.i.i = getelementptr i8, ptr %lsr.iv.i15.i, i64 8192
  %exitcond984.not.i.i = icmp eq i64 %.117.i.i, %.1831.i.i
  br i1 %exitcond984.not.i.i, label %_ZN17bnserve_inference12modes_kernel7_source7_gatherB3v25B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i, label %B1068.if.i.i

_ZN17bnserve_inference12modes_kernel7_source7_gatherB3v25B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i: ; preds = %B1070.endif.endif.endif.i.i, %B628.endif.endif.endif.endif.endif.endif.endif.endif.i.i, %B578.i.i
  %.2744.i = load double, ptr %.161.i.i, align 8, !noalias !0
  %.2776.i = load double, ptr %lsr.iv274.i, align 8, !noalias !0
  %.79.i.i = load i64, ptr %.106.i, align 8, !noalias !26
  %.109.i.i = load i64, ptr %.711.i, align 8, !noalias !26
  %.178.i.i = load i64, ptr %.787.i, align 8, !noalias !26
  %.261.i.i = load i64, ptr %.260.i16.i, align 8, !noalias !26
  %.263.i17.i = inttoptr i64 %.261.i.i to ptr
  %.327.i.i = getelementptr double, ptr %.263.i17.i, i64 %.249012211236.i
  %.4921211.i.i = load double, ptr %.491.i18.i, align 8, !noalias !26
  %.632.idx.i.i = shl i64 %.79.i.i, 13
  %.632.i.i = getelementptr i8, ptr %.625.i, i64 %.632.idx.i.i
  %.944.i.i = getelementptr i8, ptr %.632.i.i, i64 12288
  %.11791351.not.i.i = icmp slt i64 %.178.i.i, 1
  br i1 %.11791351.not.i.i, label %_ZN17bnserve_inference12modes_kernel7_source13_add_productsB3v45B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxx5ArrayIxLi1E1C7mutable7alignedEdd5ArrayIdLi1E1C7mutable7alignedE.exit.i, label %B634.if.lr.ph.i.i

B634.loopexit.i.i:                                ; preds = %B1538.i.i, %B638.endif.i.i
  %exitcond1480.not.i.i = icmp eq i64 %.1192.i.i, %.178.i.i
  br i1 %exitcond1480.not.i.i, label %_ZN17bnserve_inference12modes_kernel7_source13_add_productsB3v45B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxx5ArrayIxLi1E1C7mutable7alignedEdd5ArrayIdLi1E1C7mutable7alignedE.exit.i, label %B634.if.i.i

B934.i.i:                                         ; preds = %B728.if.i.i
  %62 = inttoptr i64 %.1712.i.i to ptr
  %.1785.i.i = getelementptr double, ptr %62, i64 %.249012211236.i
  %.1856.i.i = getelementptr double, ptr %62, i64 %.1839.i.i
  br i1 %36, label %B1136.i.i, label %B56.if.i.i50.i

B1046.i.i:                                        ; preds = %B728.if.i.i
  %.48.i.i.i = load double, ptr %sunkaddr82.i.i, align 8, !noalias !29
  %.49.i.i.i = fsub contract double %.1227.i.i, %.48.i.i.i
  %.78.i.i.i = load double, ptr %sunkaddr84.i.i, align 8, !noalias !29
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
  %.186.i.i.i = fmul contract double %.183.i.i.i, %.185.i.i.i
  %.187.i.i.i = fmul contract double %.183.i.i.i, %.186.i.i.i
  %.191.i.i35.i = fdiv contract double %.187.i.i.i, 1.200000e+02
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
  %.251.i.i36.i = fdiv contract double %.247.i.i.i, 1.200000e+02
  br i1 %36, label %B1136.i.i, label %B642.if.i.preheader.i.i

B642.if.i.preheader.i.i:                          ; preds = %B1046.i.i
  %.265.i.i.i = add i64 %.13.i1.i.i.i, -2
  %63 = inttoptr i64 %.1712.i.i to ptr
  %64 = shl i64 %.13.i1.i.i.i, 7
  %65 = sub i64 -448, %64
  %66 = sub i64 -320, %64
  %67 = sub i64 -192, %64
  %68 = sub nuw nsw i64 -64, %64
  %69 = sub i64 64, %64
  %70 = sub i64 192, %64
  %71 = sub i64 -384, %64
  %72 = sub i64 -256, %64
  %73 = sub nuw nsw i64 -128, %64
  %74 = sub i64 128, %64
  %scevgep10.i37.i = getelementptr i8, ptr %63, i64 %37
  %75 = mul i64 %65, %88
  %scevgep11.i.i = getelementptr i8, ptr %scevgep10.i37.i, i64 %75
  %76 = mul i64 %66, %88
  %scevgep13.i.i = getelementptr i8, ptr %scevgep10.i37.i, i64 %76
  %77 = mul i64 %67, %88
  %scevgep15.i.i = getelementptr i8, ptr %scevgep10.i37.i, i64 %77
  %78 = mul i64 %68, %88
  %scevgep37.i.i = getelementptr i8, ptr %scevgep10.i37.i, i64 %78
  %79 = mul i64 %69, %88
  %scevgep46.i.i = getelementptr i8, ptr %scevgep10.i37.i, i64 %79
  %80 = mul i64 %70, %88
  %scevgep52.i.i = getelementptr i8, ptr %scevgep10.i37.i, i64 %80
  %81 = mul i64 %71, %88
  %scevgep56.i.i = getelementptr i8, ptr %scevgep10.i37.i, i64 %81
  %82 = mul i64 %72, %88
  %scevgep58.i.i = getelementptr i8, ptr %scevgep10.i37.i, i64 %82
  %83 = mul i64 %73, %88
  %scevgep60.i.i = getelementptr i8, ptr %scevgep10.i37.i, i64 %83
  %84 = mul i64 %.13.i1.i.i.i, %89
  %scevgep63.i.i = getelementptr i8, ptr %scevgep10.i37.i, i64 %84
  %85 = mul i64 %74, %88
  %scevgep65.i.i = getelementptr i8, ptr %scevgep10.i37.i, i64 %85
  %86 = mul i64 %.265.i.i.i, %89
  %scevgep67.i.i = getelementptr i8, ptr %scevgep10.i37.i, i64 %86
  br label %B642.if.i.i.i

B1136.i.i:                                        ; preds = %B642.if.i.i.i, %B56.if.i.i50.i, %B1046.i.i, %B934.i.i
  %.2160.i.i = mul nuw nsw i64 %.135212881302.i.i, %.178.i.i
  %.2162.i.i = add nuw nsw i64 %.2160.i.i, %.118513191354.i.i
  %.idx.i39.i = shl i64 %.2162.i.i, 4
  %87 = getelementptr i8, ptr %92, i64 %.idx.i39.i
  %.2193.i.i = load double, ptr %87, align 8, !noalias !26
  br i1 %38, label %B1136.endif.thread.i.i, label %B104.if.i.i.i

B1136.endif.thread.i.i:                           ; preds = %B1136.i.i
  %.22223.i.i = fadd contract double %.2193.i.i, 0.000000e+00
  store double %.22223.i.i, ptr %87, align 8, !noalias !26
  %sunkaddr86.i.i = getelementptr i8, ptr %87, i64 8
  %.22897.i.i = load double, ptr %sunkaddr86.i.i, align 8, !noalias !26
  br label %B1136.endif.endif.i.i

B104.if.i.i.i:                                    ; preds = %B1136.i.i, %B104.if.i.i.i
  %lsr.iv9.i.i.i = phi i64 [ %lsr.iv.next.i.i.i, %B104.if.i.i.i ], [ %.60.1.i.i.i, %B1136.i.i ]
  %lsr.iv.i.i40.i = phi ptr [ %scevgep1.i.i.i, %B104.if.i.i.i ], [ %scevgep.i.i.i, %B1136.i.i ]
  %s7.2.0168.i.i.i = phi double [ %.489.i.i.i, %B104.if.i.i.i ], [ 0.000000e+00, %B1136.i.i ]
  %s6.2.0167.i.i.i = phi double [ %.454.i.i.i, %B104.if.i.i.i ], [ 0.000000e+00, %B1136.i.i ]
  %s5.2.0166.i.i.i = phi double [ %.419.i.i.i, %B104.if.i.i.i ], [ 0.000000e+00, %B1136.i.i ]
  %s4.2.0165.i.i.i = phi double [ %.384.i.i.i, %B104.if.i.i.i ], [ 0.000000e+00, %B1136.i.i ]
  %s3.2.0164.i.i.i = phi double [ %.349.i.i.i, %B104.if.i.i.i ], [ 0.000000e+00, %B1136.i.i ]
  %s2.2.0163.i.i.i = phi double [ %.314.i.i.i, %B104.if.i.i.i ], [ 0.000000e+00, %B1136.i.i ]
  %s1.2.0162.i.i.i = phi double [ %.279.i.i.i, %B104.if.i.i.i ], [ 0.000000e+00, %B1136.i.i ]
  %s0.2.0161.i.i.i = phi double [ %.244.i.i.i, %B104.if.i.i.i ], [ 0.000000e+00, %B1136.i.i ]
  %scevgep2.i.i41.i = getelementptr i8, ptr %lsr.iv.i.i40.i, i64 -56
  %.242.i.i.i = load double, ptr %scevgep2.i.i41.i, align 8, !noalias !32
  %.244.i.i.i = fadd contract double %s0.2.0161.i.i.i, %.242.i.i.i
  %scevgep3.i.i42.i = getelementptr i8, ptr %lsr.iv.i.i40.i, i64 -48
  %.277.i.i43.i = load double, ptr %scevgep3.i.i42.i, align 8, !noalias !32
  %.279.i.i.i = fadd contract double %s1.2.0162.i.i.i, %.277.i.i43.i
  %scevgep4.i.i44.i = getelementptr i8, ptr %lsr.iv.i.i40.i, i64 -40
  %.312.i.i.i = load double, ptr %scevgep4.i.i44.i, align 8, !noalias !32
  %.314.i.i.i = fadd contract double %s2.2.0163.i.i.i, %.312.i.i.i
  %scevgep5.i.i45.i = getelementptr i8, ptr %lsr.iv.i.i40.i, i64 -32
  %.347.i.i.i = load double, ptr %scevgep5.i.i45.i, align 8, !noalias !32
  %.349.i.i.i = fadd contract double %s3.2.0164.i.i.i, %.347.i.i.i
  %scevgep6.i.i46.i = getelementptr i8, ptr %lsr.iv.i.i40.i, i64 -24
  %.382.i.i.i = load double, ptr %scevgep6.i.i46.i, align 8, !noalias !32
  %.384.i.i.i = fadd contract double %s4.2.0165.i.i.i, %.382.i.i.i
  %scevgep7.i.i47.i = getelementptr i8, ptr %lsr.iv.i.i40.i, i64 -16
  %.417.i.i.i = load double, ptr %scevgep7.i.i47.i, align 8, !noalias !32
  %.419.i.i.i = fadd contract double %s5.2.0166.i.i.i, %.417.i.i.i
  %scevgep8.i.i.i = getelementptr i8, ptr %lsr.iv.i.i40.i, i64 -8
  %.452.i.i.i = load double, ptr %scevgep8.i.i.i, align 8, !noalias !32
  %.454.i.i.i = fadd contract double %s6.2.0167.i.i.i, %.452.i.i.i
  %.487.i.i.i = load double, ptr %lsr.iv.i.i40.i, align 8, !noalias !32
  %.489.i.i.i = fadd contract double %s7.2.0168.i.i.i, %.487.i.i.i
  %scevgep1.i.i.i = getelementptr i8, ptr %lsr.iv.i.i40.i, i64 64
  %lsr.iv.next.i.i.i = add nsw i64 %lsr.iv9.i.i.i, -1
  %exitcond.not.i.i48.i = icmp eq i64 %lsr.iv.next.i.i.i, 0
  br i1 %exitcond.not.i.i48.i, label %B104.if.i159.preheader.i.i, label %B104.if.i.i.i

B1312.i.i:                                        ; preds = %B1136.endif.endif.i.i
  %.2383.i.i = load i64, ptr %.869.i, align 8, !noalias !26
  %.2384.not.i.i = icmp eq i64 %.2383.i.i, 0
  %or.cond.i.i = select i1 %.2384.not.i.i, i1 true, i1 %93
  br i1 %or.cond.i.i, label %B1538.i.i, label %B62.if.preheader.i.i.i

B1538.i.i:                                        ; preds = %B62.if.i.i.i, %B1136.endif.endif.i.i, %B1312.i.i
  %scevgep388.i.i = getelementptr i8, ptr %lsr.iv.i33.i, i64 8192
  %exitcond.not.i49.i = icmp eq i64 %.79.i.i, %.1359.i34.i
  br i1 %exitcond.not.i49.i, label %B634.loopexit.i.i, label %B728.if.i.i

B634.if.lr.ph.i.i:                                ; preds = %_ZN17bnserve_inference12modes_kernel7_source7_gatherB3v25B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i
  %.546.i.i = load i64, ptr %sunkaddr83.i, align 8, !noalias !26
  %.550.i.i = mul i64 %.79.i.i, %.548.i19.i
  %.552.i.i = mul i64 %.550.i.i, %.178.i.i
  %.553.i.i = add nsw i64 %.546.i.i, %.552.i.i
  %.414.i.i = load i64, ptr %.413.i.i, align 8, !noalias !26
  %.139.i21.i = load i64, ptr %.138.i20.i, align 8, !noalias !26
  %.181.i.i = sub i64 0, %.109.i.i
  %.189.1.i.i = and i64 %.181.i.i, -8
  %.1669.i.i = mul nsw i64 %.79.i.i, %.264512101214.i
  %.1839.i.i = sub i64 %.249012211236.i, %.189.1.i.i
  %.2350.i.i = add nsw i64 %.178.i.i, -1
  %.2388.i.i = sub i64 %.109.i.i, %.249012211236.i
  %.2450.i.i = mul nsw i64 %.79.i.i, %.1021.sroa.0.052.i
  %.152.i.i.i = add i64 %.139.i21.i, -4
  %scevgep.i.i.i = getelementptr i8, ptr %.632.i.i, i64 56
  %scevgep.i158.i.i = getelementptr i8, ptr %.632.i.i, i64 4152
  %.13.i.i22.i = tail call i64 @llvm.smin.i64(i64 %.2388.i.i, i64 range(i64 -9223372036854775808, 513) %.13.i.i)
  %88 = lshr i64 %.181.i.i, 3
  %89 = mul i64 %88, -128
  %scevgep79.i.i = getelementptr i8, ptr %.632.i.i, i64 4096
  %90 = icmp slt i64 %.79.i.i, 1
  %91 = icmp eq i64 %.139.i21.i, 1
  %92 = inttoptr i64 %.553.i.i to ptr
  %sunkaddr82.i.i = inttoptr i64 %.414.i.i to ptr
  %sunkaddr84.i.i = getelementptr i8, ptr %sunkaddr82.i.i, i64 8
  %93 = icmp slt i64 %.13.i.i22.i, 1
  %factor.op.mul = mul i64 %.189.1.i.i, %.139.i21.i
  %factor.op.mul.i.reass = mul i64 %factor.op.mul, -16
  br label %B634.if.i.i

B634.if.i.i:                                      ; preds = %B634.if.lr.ph.i.i, %B634.loopexit.i.i
  %.118513191354.i.i = phi i64 [ 0, %B634.if.lr.ph.i.i ], [ %.1192.i.i, %B634.loopexit.i.i ]
  %.1192.i.i = add nuw nsw i64 %.118513191354.i.i, 1
  %.1222.i.i = uitofp nneg i64 %.118513191354.i.i to double
  %.1223.i.i = fmul contract double %.4921211.i.i, %.1222.i.i
  %.1225.i.i = fadd contract double %.2744.i, %.1223.i.i
  %.1227.i.i = fadd contract double %.2776.i, %.1225.i.i
  %.48.i107.i.i = fmul contract double %.1227.i.i, 0xC01921FB54442D18
  br i1 %36, label %B638.endif.i.i, label %B78.if.i.i.i

B78.if.i.i.i:                                     ; preds = %B634.if.i.i, %B78.if.i.i.i
  %.150106108.i.i.i = phi i64 [ %.157.i.i.i, %B78.if.i.i.i ], [ 0, %B634.if.i.i ]
  %.157.i.i.i = add nuw nsw i64 %.150106108.i.i.i, 1
  %94 = shl i64 %.150106108.i.i.i, 3
  %scevgep2.i108.i.i = getelementptr i8, ptr %.327.i.i, i64 %94
  %.212.i109.i.i = load double, ptr %scevgep2.i108.i.i, align 8, !noalias !35
  %.214.i.i.i = fmul contract double %.48.i107.i.i, %.212.i109.i.i
  %.215.i.i.i = tail call contract double @llvm.fma.f64(double %.214.i.i.i, double 0x3FE45F306DC9C883, double 0x4338000000000000)
  %.216.i.i.i = fadd contract double %.215.i.i.i, 0xC338000000000000
  %.231.i110.i.i = tail call contract double @llvm.fma.f64(double %.216.i.i.i, double 0xBFF921FB54442D18, double %.214.i.i.i)
  %.246.i111.i.i = tail call contract double @llvm.fma.f64(double %.216.i.i.i, double 0xBC91A62633145C07, double %.231.i110.i.i)
  %.247.i112.i.i = fmul contract double %.246.i111.i.i, %.246.i111.i.i
  %.248.i.i.i = tail call contract double @llvm.fma.f64(double %.247.i112.i.i, double 0xBD6AE7F3E733B81F, double 0x3DE6124613A86D09)
  %.249.i.i23.i = tail call contract double @llvm.fma.f64(double %.247.i112.i.i, double %.248.i.i.i, double 0xBE5AE64567F544E4)
  %.250.i.i24.i = tail call contract double @llvm.fma.f64(double %.247.i112.i.i, double %.249.i.i23.i, double 0x3EC71DE3A556C734)
  %.251.i113.i.i = tail call contract double @llvm.fma.f64(double %.247.i112.i.i, double %.250.i.i24.i, double 0xBF2A01A01A01A01A)
  %.252.i.i25.i = tail call contract double @llvm.fma.f64(double %.247.i112.i.i, double %.251.i113.i.i, double 0x3F81111111111111)
  %.253.i.i.i = tail call contract double @llvm.fma.f64(double %.247.i112.i.i, double %.252.i.i25.i, double 0xBFC5555555555555)
  %.254.i.i.i = fmul contract double %.246.i111.i.i, %.247.i112.i.i
  %.255.i.i.i = tail call contract double @llvm.fma.f64(double %.254.i.i.i, double %.253.i.i.i, double %.246.i111.i.i)
  %.256.i.i26.i = tail call contract double @llvm.fma.f64(double %.247.i112.i.i, double 0x3D2AE7F3E733B81F, double 0xBDA93974A8C07C9D)
  %.257.i.i.i = tail call contract double @llvm.fma.f64(double %.247.i112.i.i, double %.256.i.i26.i, double 0x3E21EED8EFF8D898)
  %.258.i.i27.i = tail call contract double @llvm.fma.f64(double %.247.i112.i.i, double %.257.i.i.i, double 0xBE927E4FB7789F5C)
  %.259.i.i28.i = tail call contract double @llvm.fma.f64(double %.247.i112.i.i, double %.258.i.i27.i, double 0x3EFA01A01A01A01A)
  %.260.i.i29.i = tail call contract double @llvm.fma.f64(double %.247.i112.i.i, double %.259.i.i28.i, double 0xBF56C16C16C16C17)
  %.261.i.i30.i = tail call contract double @llvm.fma.f64(double %.247.i112.i.i, double %.260.i.i29.i, double 0x3FA5555555555555)
  %.262.i.i.i = tail call contract double @llvm.fma.f64(double %.247.i112.i.i, double %.261.i.i30.i, double -5.000000e-01)
  %.263.i.i.i = tail call contract double @llvm.fma.f64(double %.247.i112.i.i, double %.262.i.i.i, double 1.000000e+00)
  %.264.i114.i.i = bitcast double %.215.i.i.i to i64
  %.265.i115.i.i = bitcast double %.255.i.i.i to i64
  %.266.i116.i.i = bitcast double %.263.i.i.i to i64
  %.267.i117.i.i = xor i64 %.266.i116.i.i, %.265.i115.i.i
  %.268.i.i.i = and i64 %.264.i114.i.i, 1
  %95 = icmp eq i64 %.268.i.i.i, 0
  %.270.i.i.i = select i1 %95, i64 0, i64 %.267.i117.i.i
  %.271.i.i31.i = shl i64 %.264.i114.i.i, 62
  %.272.i.i.i = and i64 %.271.i.i31.i, -9223372036854775808
  %.274.i.i.i = add i64 %.271.i.i31.i, 4611686018427387904
  %.275.i.i32.i = and i64 %.274.i.i.i, -9223372036854775808
  %96 = xor i64 %.272.i.i.i, %.265.i115.i.i
  %.277.i118.i.i = xor i64 %96, %.270.i.i.i
  %97 = xor i64 %.275.i.i32.i, %.266.i116.i.i
  %.280.i.i.i = xor i64 %97, %.270.i.i.i
  %scevgep9.i.i = getelementptr i8, ptr %.944.i.i, i64 %94
  store i64 %.277.i118.i.i, ptr %scevgep9.i.i, align 8, !noalias !35
  %scevgep8.i.i = getelementptr i8, ptr %scevgep9.i.i, i64 -4096
  store i64 %.280.i.i.i, ptr %scevgep8.i.i, align 8, !noalias !35
  %exitcond.not.i121.i.i = icmp eq i64 %.13.i.i, %.157.i.i.i
  br i1 %exitcond.not.i121.i.i, label %B638.endif.i.i, label %B78.if.i.i.i

B638.endif.i.i:                                   ; preds = %B78.if.i.i.i, %B634.if.i.i
  br i1 %90, label %B634.loopexit.i.i, label %B728.if.preheader.i.i

B728.if.preheader.i.i:                            ; preds = %B638.endif.i.i
  %98 = icmp eq i64 %.118513191354.i.i, %.2350.i.i
  br label %B728.if.i.i

B728.if.i.i:                                      ; preds = %B728.if.preheader.i.i, %B1538.i.i
  %lsr.iv.i33.i = phi ptr [ %scevgep388.i.i, %B1538.i.i ], [ %scevgep.i.i, %B728.if.preheader.i.i ]
  %.135212881302.i.i = phi i64 [ %.1359.i34.i, %B1538.i.i ], [ 0, %B728.if.preheader.i.i ]
  %.1359.i34.i = add nuw nsw i64 %.135212881302.i.i, 1
  %.1659.i.i = load i64, ptr %sunkaddr88.i.i, align 8, !noalias !26
  %.1660.i.i = icmp eq i64 %.1659.i.i, 1
  %.1671.i.i = add nuw nsw i64 %.135212881302.i.i, %.1669.i.i
  %"$phi838.2.2.2.i.i" = select i1 %.1660.i.i, i64 %.264512101214.i, i64 %.1671.i.i
  %.1708.i.i = load i64, ptr %sunkaddr89.i.i, align 8, !noalias !26
  %.1711.i.i = mul nsw i64 %factor.op.mul.i.reass, %"$phi838.2.2.2.i.i"
  %.1712.i.i = add nsw i64 %.1711.i.i, %.1708.i.i
  br i1 %91, label %B934.i.i, label %B1046.i.i

B56.if.i.i50.i:                                   ; preds = %B934.i.i, %B56.if.i.i50.i
  %.214284286.i.i.i = phi i64 [ %.221.i142.i.i, %B56.if.i.i50.i ], [ 0, %B934.i.i ]
  %.221.i142.i.i = add nuw nsw i64 %.214284286.i.i.i, 1
  %99 = shl i64 %.214284286.i.i.i, 3
  %scevgep402.i.i = getelementptr i8, ptr %lsr.iv.i33.i, i64 %99
  %scevgep403.i.i = getelementptr i8, ptr %scevgep402.i.i, i64 -4096
  %.275.i144.i.i = load double, ptr %scevgep403.i.i, align 8, !noalias !38
  %scevgep397.i.i = getelementptr i8, ptr %.944.i.i, i64 %99
  %scevgep398.i.i = getelementptr i8, ptr %scevgep397.i.i, i64 -4096
  %.305.i.i.i = load double, ptr %scevgep398.i.i, align 8, !noalias !38
  %.306.i.i.i = fmul contract double %.275.i144.i.i, %.305.i.i.i
  %.336.i.i.i = load double, ptr %scevgep402.i.i, align 8, !noalias !38
  %.366.i.i.i = load double, ptr %scevgep397.i.i, align 8, !noalias !38
  %.367.i.i.i = fmul contract double %.336.i.i.i, %.366.i.i.i
  %.368.i.i.i = fsub contract double %.306.i.i.i, %.367.i.i.i
  %.429.i.i.i = fmul contract double %.275.i144.i.i, %.366.i.i.i
  %.490.i.i.i = fmul contract double %.305.i.i.i, %.336.i.i.i
  %.491.i.i.i = fadd contract double %.490.i.i.i, %.429.i.i.i
  %scevgep74.i.i = getelementptr i8, ptr %.1785.i.i, i64 %99
  %.521.i.i.i = load double, ptr %scevgep74.i.i, align 8, !noalias !38
  %.522.i.i.i = fmul contract double %.521.i.i.i, %.368.i.i.i
  %scevgep73.i.i = getelementptr i8, ptr %.1856.i.i, i64 %99
  %.552.i.i.i = load double, ptr %scevgep73.i.i, align 8, !noalias !38
  %.553.i.i.i = fmul contract double %.552.i.i.i, %.491.i.i.i
  %.554.i.i.i = fsub contract double %.522.i.i.i, %.553.i.i.i
  %scevgep78.i.i = getelementptr i8, ptr %scevgep397.i.i, i64 -12288
  store double %.554.i.i.i, ptr %scevgep78.i.i, align 8, !noalias !38
  %.614.i.i.i = load double, ptr %scevgep74.i.i, align 8, !noalias !38
  %.615.i.i.i = fmul contract double %.491.i.i.i, %.614.i.i.i
  %.645.i.i.i = load double, ptr %scevgep73.i.i, align 8, !noalias !38
  %.646.i.i.i = fmul contract double %.368.i.i.i, %.645.i.i.i
  %.647.i.i.i = fadd contract double %.615.i.i.i, %.646.i.i.i
  %scevgep76.i.i = getelementptr i8, ptr %scevgep397.i.i, i64 -8192
  store double %.647.i.i.i, ptr %scevgep76.i.i, align 8, !noalias !38
  %exitcond.not.i152.i.i = icmp eq i64 %.13.i.i, %.221.i142.i.i
  br i1 %exitcond.not.i152.i.i, label %B1136.i.i, label %B56.if.i.i50.i

B642.if.i.i.i:                                    ; preds = %B642.if.i.i.i, %B642.if.i.preheader.i.i
  %.114610431045.i.i.i = phi i64 [ %.1153.i.i.i, %B642.if.i.i.i ], [ 0, %B642.if.i.preheader.i.i ]
  %.1153.i.i.i = add nuw nsw i64 %.114610431045.i.i.i, 1
  %100 = shl i64 %.114610431045.i.i.i, 3
  %scevgep390.i.i = getelementptr i8, ptr %lsr.iv.i33.i, i64 %100
  %scevgep391.i.i = getelementptr i8, ptr %scevgep390.i.i, i64 -4096
  %.1207.i.i.i = load double, ptr %scevgep391.i.i, align 8, !noalias !41
  %scevgep355.i.i = getelementptr i8, ptr %.944.i.i, i64 %100
  %scevgep356.i.i = getelementptr i8, ptr %scevgep355.i.i, i64 -4096
  %.1237.i.i.i = load double, ptr %scevgep356.i.i, align 8, !noalias !41
  %.1238.i.i.i = fmul contract double %.1207.i.i.i, %.1237.i.i.i
  %.1268.i.i.i = load double, ptr %scevgep390.i.i, align 8, !noalias !41
  %.1298.i.i.i = load double, ptr %scevgep355.i.i, align 8, !noalias !41
  %.1299.i.i.i = fmul contract double %.1268.i.i.i, %.1298.i.i.i
  %.1300.i.i.i = fsub contract double %.1238.i.i.i, %.1299.i.i.i
  %.1361.i.i.i = fmul contract double %.1207.i.i.i, %.1298.i.i.i
  %.1422.i.i.i = fmul contract double %.1237.i.i.i, %.1268.i.i.i
  %.1423.i.i.i = fadd contract double %.1422.i.i.i, %.1361.i.i.i
  %scevgep68.i.i = getelementptr i8, ptr %scevgep67.i.i, i64 %100
  %.1453.i.i.i = load double, ptr %scevgep68.i.i, align 8, !noalias !41
  %.1455.i.i.i = fmul contract double %.191.i.i35.i, %.1453.i.i.i
  %scevgep66.i.i = getelementptr i8, ptr %scevgep65.i.i, i64 %100
  %.1485.i.i.i = load double, ptr %scevgep66.i.i, align 8, !noalias !41
  %.1487.i.i.i = fmul contract double %.205.i.i.i, %.1485.i.i.i
  %.1488.i.i.i = fadd contract double %.1455.i.i.i, %.1487.i.i.i
  %scevgep64.i.i = getelementptr i8, ptr %scevgep63.i.i, i64 %100
  %.1518.i.i.i = load double, ptr %scevgep64.i.i, align 8, !noalias !41
  %.1520.i.i.i = fmul contract double %.217.i.i.i, %.1518.i.i.i
  %.1521.i.i.i = fadd contract double %.1488.i.i.i, %.1520.i.i.i
  %scevgep61.i.i = getelementptr i8, ptr %scevgep60.i.i, i64 %100
  %.1551.i.i.i = load double, ptr %scevgep61.i.i, align 8, !noalias !41
  %.1553.i.i.i = fmul contract double %.229.i.i.i, %.1551.i.i.i
  %.1554.i.i.i = fadd contract double %.1521.i.i.i, %.1553.i.i.i
  %scevgep59.i.i = getelementptr i8, ptr %scevgep58.i.i, i64 %100
  %.1584.i.i.i = load double, ptr %scevgep59.i.i, align 8, !noalias !41
  %.1586.i.i.i = fmul contract double %.243.i.i.i, %.1584.i.i.i
  %.1587.i.i.i = fadd contract double %.1554.i.i.i, %.1586.i.i.i
  %scevgep57.i.i = getelementptr i8, ptr %scevgep56.i.i, i64 %100
  %.1617.i.i.i = load double, ptr %scevgep57.i.i, align 8, !noalias !41
  %.1619.i.i.i = fmul contract double %.251.i.i36.i, %.1617.i.i.i
  %.1620.i.i.i = fadd contract double %.1587.i.i.i, %.1619.i.i.i
  %scevgep54.i.i = getelementptr i8, ptr %scevgep52.i.i, i64 %100
  %.1650.i.i.i = load double, ptr %scevgep54.i.i, align 8, !noalias !41
  %.1652.i.i.i = fmul contract double %.191.i.i35.i, %.1650.i.i.i
  %scevgep50.i.i = getelementptr i8, ptr %scevgep46.i.i, i64 %100
  %.1682.i.i.i = load double, ptr %scevgep50.i.i, align 8, !noalias !41
  %.1684.i.i.i = fmul contract double %.205.i.i.i, %.1682.i.i.i
  %.1685.i.i.i = fadd contract double %.1652.i.i.i, %.1684.i.i.i
  %scevgep44.i.i = getelementptr i8, ptr %scevgep37.i.i, i64 %100
  %.1715.i.i.i = load double, ptr %scevgep44.i.i, align 8, !noalias !26
  %.1717.i.i.i = fmul contract double %.217.i.i.i, %.1715.i.i.i
  %.1718.i.i.i = fadd contract double %.1685.i.i.i, %.1717.i.i.i
  %scevgep23.i.i = getelementptr i8, ptr %scevgep15.i.i, i64 %100
  %.1748.i.i.i = load double, ptr %scevgep23.i.i, align 8, !noalias !26
  %.1750.i.i.i = fmul contract double %.229.i.i.i, %.1748.i.i.i
  %.1751.i.i.i = fadd contract double %.1718.i.i.i, %.1750.i.i.i
  %scevgep14.i38.i = getelementptr i8, ptr %scevgep13.i.i, i64 %100
  %.1781.i.i.i = load double, ptr %scevgep14.i38.i, align 8, !noalias !26
  %.1783.i.i.i = fmul contract double %.243.i.i.i, %.1781.i.i.i
  %.1784.i.i.i = fadd contract double %.1751.i.i.i, %.1783.i.i.i
  %scevgep12.i.i = getelementptr i8, ptr %scevgep11.i.i, i64 %100
  %.1814.i.i.i = load double, ptr %scevgep12.i.i, align 8, !noalias !26
  %.1816.i.i.i = fmul contract double %.251.i.i36.i, %.1814.i.i.i
  %.1817.i.i.i = fadd contract double %.1784.i.i.i, %.1816.i.i.i
  %.1818.i.i.i = fmul contract double %.1300.i.i.i, %.1620.i.i.i
  %.1819.i.i.i = fmul contract double %.1423.i.i.i, %.1817.i.i.i
  %.1820.i.i.i = fsub contract double %.1818.i.i.i, %.1819.i.i.i
  %scevgep72.i.i = getelementptr i8, ptr %scevgep355.i.i, i64 -12288
  store double %.1820.i.i.i, ptr %scevgep72.i.i, align 8, !noalias !41
  %.1851.i.i.i = fmul contract double %.1423.i.i.i, %.1620.i.i.i
  %.1852.i.i.i = fmul contract double %.1300.i.i.i, %.1817.i.i.i
  %.1853.i.i.i = fadd contract double %.1851.i.i.i, %.1852.i.i.i
  %scevgep70.i.i = getelementptr i8, ptr %scevgep355.i.i, i64 -8192
  store double %.1853.i.i.i, ptr %scevgep70.i.i, align 8, !noalias !41
  %exitcond.not.i154.i.i = icmp eq i64 %.13.i.i, %.1153.i.i.i
  br i1 %exitcond.not.i154.i.i, label %B1136.i.i, label %B642.if.i.i.i

B104.if.i159.preheader.i.i:                       ; preds = %B104.if.i.i.i
  %101 = fadd contract double %.244.i.i.i, %.279.i.i.i
  %102 = fadd contract double %.314.i.i.i, %.349.i.i.i
  %103 = fadd contract double %101, %102
  %104 = fadd contract double %.384.i.i.i, %.419.i.i.i
  %105 = fadd contract double %.454.i.i.i, %.489.i.i.i
  %106 = fadd contract double %104, %105
  %107 = fadd contract double %103, %106
  %.2222.i.i = fadd contract double %.2193.i.i, %107
  store double %.2222.i.i, ptr %87, align 8, !noalias !26
  %sunkaddr94.i.i = getelementptr i8, ptr %87, i64 8
  %.2289.i.i = load double, ptr %sunkaddr94.i.i, align 8, !noalias !26
  br label %B104.if.i159.i.i

B348.loopexit.i196.i.i:                           ; preds = %B104.if.i159.i.i
  %108 = fadd contract double %.244.i172.i.i, %.279.i175.i.i
  %109 = fadd contract double %.314.i178.i.i, %.349.i181.i.i
  %110 = fadd contract double %108, %109
  %111 = fadd contract double %.384.i184.i.i, %.419.i187.i.i
  %112 = fadd contract double %.454.i190.i.i, %.489.i192.i.i
  %113 = fadd contract double %111, %112
  %114 = fadd contract double %110, %113
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
  %.242.i171.i.i = load double, ptr %scevgep2.i170.i.i, align 8, !noalias !44
  %.244.i172.i.i = fadd contract double %s0.2.0161.i169.i.i, %.242.i171.i.i
  %scevgep3.i173.i.i = getelementptr i8, ptr %lsr.iv.i161.i.i, i64 -48
  %.277.i174.i.i = load double, ptr %scevgep3.i173.i.i, align 8, !noalias !44
  %.279.i175.i.i = fadd contract double %s1.2.0162.i168.i.i, %.277.i174.i.i
  %scevgep4.i176.i.i = getelementptr i8, ptr %lsr.iv.i161.i.i, i64 -40
  %.312.i177.i.i = load double, ptr %scevgep4.i176.i.i, align 8, !noalias !44
  %.314.i178.i.i = fadd contract double %s2.2.0163.i167.i.i, %.312.i177.i.i
  %scevgep5.i179.i.i = getelementptr i8, ptr %lsr.iv.i161.i.i, i64 -32
  %.347.i180.i.i = load double, ptr %scevgep5.i179.i.i, align 8, !noalias !44
  %.349.i181.i.i = fadd contract double %s3.2.0164.i166.i.i, %.347.i180.i.i
  %scevgep6.i182.i.i = getelementptr i8, ptr %lsr.iv.i161.i.i, i64 -24
  %.382.i183.i.i = load double, ptr %scevgep6.i182.i.i, align 8, !noalias !44
  %.384.i184.i.i = fadd contract double %s4.2.0165.i165.i.i, %.382.i183.i.i
  %scevgep7.i185.i.i = getelementptr i8, ptr %lsr.iv.i161.i.i, i64 -16
  %.417.i186.i.i = load double, ptr %scevgep7.i185.i.i, align 8, !noalias !44
  %.419.i187.i.i = fadd contract double %s5.2.0166.i164.i.i, %.417.i186.i.i
  %scevgep8.i188.i.i = getelementptr i8, ptr %lsr.iv.i161.i.i, i64 -8
  %.452.i189.i.i = load double, ptr %scevgep8.i188.i.i, align 8, !noalias !44
  %.454.i190.i.i = fadd contract double %s6.2.0167.i163.i.i, %.452.i189.i.i
  %.487.i191.i.i = load double, ptr %lsr.iv.i161.i.i, align 8, !noalias !44
  %.489.i192.i.i = fadd contract double %s7.2.0168.i162.i.i, %.487.i191.i.i
  %scevgep1.i193.i.i = getelementptr i8, ptr %lsr.iv.i161.i.i, i64 64
  %lsr.iv.next.i194.i.i = add nsw i64 %lsr.iv9.i160.i.i, -1
  %exitcond.not.i195.i.i = icmp eq i64 %lsr.iv.next.i194.i.i, 0
  br i1 %exitcond.not.i195.i.i, label %B348.loopexit.i196.i.i, label %B104.if.i159.i.i

B1136.endif.endif.i.i:                            ; preds = %B348.loopexit.i196.i.i, %B1136.endif.thread.i.i
  %.22898.i.i = phi double [ %.22897.i.i, %B1136.endif.thread.i.i ], [ %.2289.i.i, %B348.loopexit.i196.i.i ]
  %s0.2.0.lcssa.i197.i.i = phi double [ 0.000000e+00, %B1136.endif.thread.i.i ], [ %114, %B348.loopexit.i196.i.i ]
  %.2318.i.i = fadd contract double %.22898.i.i, %s0.2.0.lcssa.i197.i.i
  %sunkaddr97.i.i = getelementptr i8, ptr %87, i64 8
  store double %.2318.i.i, ptr %sunkaddr97.i.i, align 8, !noalias !26
  br i1 %98, label %B1312.i.i, label %B1538.i.i

B62.if.preheader.i.i.i:                           ; preds = %B1312.i.i
  %.2452.i.i = add nsw i64 %.135212881302.i.i, %.2450.i.i
  %.2456.i.i = mul nsw i64 %.2452.i.i, %.109.i.i
  %.2458.i.i = add nsw i64 %.2456.i.i, %.249012211236.i
  %.2459.i.i = shl nsw i64 %.2458.i.i, 4
  %.2460.i.i = add nsw i64 %.2383.i.i, %.2459.i.i
  %.2464.i.i = inttoptr i64 %.2460.i.i to ptr
  %scevgep.i204.i.i = getelementptr i8, ptr %.2464.i.i, i64 8
  br label %B62.if.i.i.i

B62.if.i.i.i:                                     ; preds = %B62.if.i.i.i, %B62.if.preheader.i.i.i
  %lsr.iv.i205.i.i = phi ptr [ %scevgep.i204.i.i, %B62.if.preheader.i.i.i ], [ %scevgep1.i212.i.i, %B62.if.i.i.i ]
  %.190171173.i.i.i = phi i64 [ 0, %B62.if.preheader.i.i.i ], [ %.197.i206.i.i, %B62.if.i.i.i ]
  %.197.i206.i.i = add nuw nsw i64 %.190171173.i.i.i, 1
  %scevgep2.i207.i.i = getelementptr i8, ptr %lsr.iv.i205.i.i, i64 -8
  %.252.i208.i.i = load double, ptr %scevgep2.i207.i.i, align 8, !noalias !47
  %sunkaddr72.i.i = shl i64 %.190171173.i.i.i, 3
  %scevgep80.i.i = getelementptr i8, ptr %scevgep79.i.i, i64 %sunkaddr72.i.i
  %scevgep81.i.i = getelementptr i8, ptr %scevgep80.i.i, i64 -4096
  %.282.i.i.i = load double, ptr %scevgep81.i.i, align 8, !noalias !47
  %.314.i211.i.i = load double, ptr %scevgep80.i.i, align 8, !noalias !47
  %.316.i.i.i = fmul contract double %.314.i211.i.i, 0.000000e+00
  %.317.i.i.i = fsub contract double %.282.i.i.i, %.316.i.i.i
  %.318.i.i.i = fadd contract double %.252.i208.i.i, %.317.i.i.i
  store double %.318.i.i.i, ptr %scevgep2.i207.i.i, align 8, !noalias !47
  %.380.i.i.i = load double, ptr %lsr.iv.i205.i.i, align 8, !noalias !47
  %.410.i.i.i = load double, ptr %scevgep80.i.i, align 8, !noalias !47
  %.442.i.i.i = load double, ptr %scevgep81.i.i, align 8, !noalias !47
  %.444.i.i.i = fmul contract double %.442.i.i.i, 0.000000e+00
  %.445.i.i.i = fadd contract double %.410.i.i.i, %.444.i.i.i
  %.446.i.i.i = fadd contract double %.380.i.i.i, %.445.i.i.i
  store double %.446.i.i.i, ptr %lsr.iv.i205.i.i, align 8, !noalias !47
  %scevgep1.i212.i.i = getelementptr i8, ptr %lsr.iv.i205.i.i, i64 16
  %exitcond.not.i213.i.i = icmp eq i64 %.13.i.i22.i, %.197.i206.i.i
  br i1 %exitcond.not.i213.i.i, label %B1538.i.i, label %B62.if.i.i.i

_ZN17bnserve_inference12modes_kernel7_source13_add_productsB3v45B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxx5ArrayIxLi1E1C7mutable7alignedEdd5ArrayIdLi1E1C7mutable7alignedE.exit.i: ; preds = %B634.loopexit.i.i, %_ZN17bnserve_inference12modes_kernel7_source7_gatherB3v25B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i
  %.71.i.i = load i64, ptr %.106.i, align 8, !noalias !50
  %.186.i51.i = add nsw i64 %.71.i.i, 1
  %.188.i.i = mul nsw i64 %.186.i51.i, %.71.i.i
  %.268.i.i = and i64 %.188.i.i, -2
  %.345.idx.i.i = shl i64 %.71.i.i, 13
  %.345.i.i = getelementptr i8, ptr %.625.i, i64 %.345.idx.i.i
  %.413.i52.i = getelementptr i8, ptr %.345.i.i, i64 4096
  %.651938.not.i.i = icmp slt i64 %.71.i.i, 1
  br i1 %.651938.not.i.i, label %_ZN17bnserve_inference12modes_kernel7_source10_add_pairsB3v85B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i, label %B324.if.lr.ph.i.i

B860.i.i:                                         ; preds = %B606.endif.endif.endif.endif.endif.i.i
  %.660.i.i = add nsw i64 %.650895942.i.i, -1
  %.664.i.i = add nuw nsw i64 %.657905941.i.i, 1
  %exitcond1049.not.i.i = icmp eq i64 %.664.i.i, %.71.i.i
  br i1 %exitcond1049.not.i.i, label %_ZN17bnserve_inference12modes_kernel7_source10_add_pairsB3v85B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i, label %B324.if.i.i

B324.if.lr.ph.i.i:                                ; preds = %_ZN17bnserve_inference12modes_kernel7_source13_add_productsB3v45B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxx5ArrayIxLi1E1C7mutable7alignedEdd5ArrayIdLi1E1C7mutable7alignedE.exit.i
  %.181.i53.i = load i64, ptr %sunkaddr88.i.i, align 8, !noalias !50
  %.196.1.i.i = lshr i64 %.188.i.i, 1
  %.265.i.i = mul i64 %.196.1.i.i, %.548.i19.i
  %.262.i55.i = load i64, ptr %sunkaddr84.i, align 8, !noalias !50
  %.266.i.i = add nsw i64 %.262.i55.i, %.265.i.i
  %.102.i56.i = load i64, ptr %.711.i, align 8, !noalias !50
  %.103.i.i = sub i64 0, %.102.i56.i
  %.111.1.i.i = and i64 %.103.i.i, -8
  %.145.i.i = sub i64 0, %.111.1.i.i
  %.1298.i.i = icmp eq i64 %.181.i53.i, 1
  %.1308.i.i = shl nsw i64 %.145.i.i, 1
  %.1311.i.i = mul nuw nsw i64 %.196.1.i.i, %.264512101214.i
  %.1302.i.i = mul nsw i64 %.264512101214.i, %.145.i.i
  %.1420.i.i = select i1 %.1298.i.i, i64 0, i64 %.111.1.i.i
  %"$phi606.2.2.2.i.i" = sub i64 %.249012211236.i, %.1420.i.i
  %scevgep.i.i58.i = getelementptr i8, ptr %.345.i.i, i64 56
  %scevgep.i104.i.i = getelementptr i8, ptr %.345.i.i, i64 4152
  %115 = inttoptr i64 %.266.i.i to ptr
  br label %B324.if.i.i

B324.if.i.i:                                      ; preds = %B324.if.lr.ph.i.i, %B860.i.i
  %at.3.0943.i.i = phi i64 [ 0, %B324.if.lr.ph.i.i ], [ %.1807.i.i, %B860.i.i ]
  %.650895942.i.i = phi i64 [ %.71.i.i, %B324.if.lr.ph.i.i ], [ %.660.i.i, %B860.i.i ]
  %.657905941.i.i = phi i64 [ 0, %B324.if.lr.ph.i.i ], [ %.664.i.i, %B860.i.i ]
  %smax.i.i = tail call i64 @llvm.smax.i64(i64 %.650895942.i.i, i64 0)
  %.714.idx.i.i = shl i64 %.657905941.i.i, 13
  %.714.i.i = getelementptr i8, ptr %.625.i, i64 %.714.idx.i.i
  %.782.i.i = getelementptr i8, ptr %.714.i.i, i64 4096
  %116 = add i64 %smax.i.i, %at.3.0943.i.i
  br label %B404.if.i.i

B404.if.i.i:                                      ; preds = %B606.endif.endif.endif.endif.endif.i.i, %B324.if.i.i
  %at.2.1892.i.i = phi i64 [ %.1807.i.i, %B606.endif.endif.endif.endif.endif.i.i ], [ %at.3.0943.i.i, %B324.if.i.i ]
  %.1023881890.i.i = phi i64 [ %.1030.i.i, %B606.endif.endif.endif.endif.endif.i.i ], [ %.657905941.i.i, %B324.if.i.i ]
  %.1030.i.i = add nuw i64 %.1023881890.i.i, 1
  %.1074.idx.i.i = shl i64 %.1023881890.i.i, 13
  %.1074.i60.i = getelementptr i8, ptr %.625.i, i64 %.1074.idx.i.i
  %.1142.i.i = getelementptr i8, ptr %.1074.i60.i, i64 4096
  %.1313.i.i = add nsw i64 %at.2.1892.i.i, %.1311.i.i
  %.1314.i.i = mul nsw i64 %.1308.i.i, %.1313.i.i
  %"$phi498.2.2.2.i.i" = select i1 %.1298.i.i, i64 %.1302.i.i, i64 %.1314.i.i
  %.1351.i.i = load i64, ptr %sunkaddr.i59.i, align 8, !noalias !50
  %.1352.i.i = shl nsw i64 %"$phi498.2.2.2.i.i", 3
  %.1353.i.i = add nsw i64 %.1352.i.i, %.1351.i.i
  %.1356.i.i = inttoptr i64 %.1353.i.i to ptr
  %.1441.i.i = getelementptr inbounds double, ptr %.1356.i.i, i64 %.249012211236.i
  %.1509.i61.i = getelementptr inbounds double, ptr %.1356.i.i, i64 %"$phi606.2.2.2.i.i"
  br i1 %.1298.i.i, label %B16.i.i.i, label %B266.i.i.i

B16.i.i.i:                                        ; preds = %B404.if.i.i
  br i1 %36, label %_ZN17bnserve_inference12modes_kernel7_source5_pairB4v100B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i.i, label %B68.if.i.i.i

B266.i.i.i:                                       ; preds = %B404.if.i.i
  br i1 %36, label %_ZN17bnserve_inference12modes_kernel7_source5_pairB4v100B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i.i, label %B318.if.i.i.i

B68.if.i.i.i:                                     ; preds = %B16.i.i.i, %B68.if.i.i.i
  %.222581583.i.i.i = phi i64 [ %.229.i.i102.i, %B68.if.i.i.i ], [ 0, %B16.i.i.i ]
  %.229.i.i102.i = add nuw nsw i64 %.222581583.i.i.i, 1
  %117 = shl i64 %.222581583.i.i.i, 3
  %scevgep6.i2.i.i = getelementptr i8, ptr %.1441.i.i, i64 %117
  %.283.i.i.i = load double, ptr %scevgep6.i2.i.i, align 8, !noalias !53
  %scevgep5.i3.i.i = getelementptr i8, ptr %.714.i.i, i64 %117
  %.313.i.i.i = load double, ptr %scevgep5.i3.i.i, align 8, !noalias !53
  %scevgep4.i4.i.i = getelementptr i8, ptr %.1074.i60.i, i64 %117
  %.343.i.i103.i = load double, ptr %scevgep4.i4.i.i, align 8, !noalias !53
  %.344.i.i.i = fmul contract double %.313.i.i.i, %.343.i.i103.i
  %scevgep18.i.i.i = getelementptr i8, ptr %.782.i.i, i64 %117
  %.374.i.i.i = load double, ptr %scevgep18.i.i.i, align 8, !noalias !53
  %scevgep17.i.i.i = getelementptr i8, ptr %.1142.i.i, i64 %117
  %.404.i.i.i = load double, ptr %scevgep17.i.i.i, align 8, !noalias !53
  %.405.i.i.i = fmul contract double %.374.i.i.i, %.404.i.i.i
  %.406.i.i.i = fadd contract double %.344.i.i.i, %.405.i.i.i
  %.407.i.i.i = fmul contract double %.283.i.i.i, %.406.i.i.i
  %scevgep16.i.i.i = getelementptr i8, ptr %.345.i.i, i64 %117
  store double %.407.i.i.i, ptr %scevgep16.i.i.i, align 8, !noalias !53
  %.467.i.i.i = load double, ptr %scevgep6.i2.i.i, align 8, !noalias !53
  %.497.i.i.i = load double, ptr %scevgep5.i3.i.i, align 8, !noalias !53
  %.528.i.i.i = fmul contract double %.404.i.i.i, %.497.i.i.i
  %.588.i.i.i = load double, ptr %scevgep4.i4.i.i, align 8, !noalias !53
  %.589.i.i.i = fmul contract double %.374.i.i.i, %.588.i.i.i
  %.590.i.i.i = fsub contract double %.528.i.i.i, %.589.i.i.i
  %.591.i.i.i = fmul contract double %.467.i.i.i, %.590.i.i.i
  %scevgep.i5.i.i = getelementptr i8, ptr %.413.i52.i, i64 %117
  store double %.591.i.i.i, ptr %scevgep.i5.i.i, align 8, !noalias !53
  %exitcond587.not.i.i.i = icmp eq i64 %.13.i.i, %.229.i.i102.i
  br i1 %exitcond587.not.i.i.i, label %_ZN17bnserve_inference12modes_kernel7_source5_pairB4v100B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i.i, label %B68.if.i.i.i

B318.if.i.i.i:                                    ; preds = %B266.i.i.i, %B318.if.i.i.i
  %.760575577.i.i.i = phi i64 [ %.767.i.i.i, %B318.if.i.i.i ], [ 0, %B266.i.i.i ]
  %.767.i.i.i = add nuw nsw i64 %.760575577.i.i.i, 1
  %118 = shl i64 %.760575577.i.i.i, 3
  %scevgep14.i.i.i = getelementptr i8, ptr %.714.i.i, i64 %118
  %.821.i.i.i = load double, ptr %scevgep14.i.i.i, align 8, !noalias !53
  %scevgep13.i.i.i = getelementptr i8, ptr %.1074.i60.i, i64 %118
  %.851.i.i.i = load double, ptr %scevgep13.i.i.i, align 8, !noalias !53
  %.852.i.i.i = fmul contract double %.821.i.i.i, %.851.i.i.i
  %scevgep24.i.i.i = getelementptr i8, ptr %.782.i.i, i64 %118
  %.882.i.i.i = load double, ptr %scevgep24.i.i.i, align 8, !noalias !53
  %scevgep23.i.i.i = getelementptr i8, ptr %.1142.i.i, i64 %118
  %.912.i.i.i = load double, ptr %scevgep23.i.i.i, align 8, !noalias !53
  %.913.i.i.i = fmul contract double %.882.i.i.i, %.912.i.i.i
  %.914.i.i.i = fadd contract double %.852.i.i.i, %.913.i.i.i
  %.975.i.i.i = fmul contract double %.821.i.i.i, %.912.i.i.i
  %.1036.i.i.i = fmul contract double %.851.i.i.i, %.882.i.i.i
  %.1037.i.i.i = fsub contract double %.975.i.i.i, %.1036.i.i.i
  %scevgep22.i.i.i = getelementptr i8, ptr %.1441.i.i, i64 %118
  %.1067.i.i.i = load double, ptr %scevgep22.i.i.i, align 8, !noalias !53
  %.1068.i.i.i = fmul contract double %.1067.i.i.i, %.914.i.i.i
  %scevgep21.i.i.i = getelementptr i8, ptr %.1509.i61.i, i64 %118
  %.1098.i.i.i = load double, ptr %scevgep21.i.i.i, align 8, !noalias !53
  %.1099.i.i.i = fmul contract double %.1098.i.i.i, %.1037.i.i.i
  %.1100.i.i.i = fsub contract double %.1068.i.i.i, %.1099.i.i.i
  %scevgep20.i.i.i = getelementptr i8, ptr %.345.i.i, i64 %118
  store double %.1100.i.i.i, ptr %scevgep20.i.i.i, align 8, !noalias !53
  %.1160.i.i.i = load double, ptr %scevgep22.i.i.i, align 8, !noalias !53
  %.1161.i.i.i = fmul contract double %.1037.i.i.i, %.1160.i.i.i
  %.1191.i.i.i = load double, ptr %scevgep21.i.i.i, align 8, !noalias !53
  %.1192.i.i.i = fmul contract double %.914.i.i.i, %.1191.i.i.i
  %.1193.i.i.i = fadd contract double %.1161.i.i.i, %.1192.i.i.i
  %scevgep19.i.i.i = getelementptr i8, ptr %.413.i52.i, i64 %118
  store double %.1193.i.i.i, ptr %scevgep19.i.i.i, align 8, !noalias !53
  %exitcond.not.i1.i.i = icmp eq i64 %.13.i.i, %.767.i.i.i
  br i1 %exitcond.not.i1.i.i, label %_ZN17bnserve_inference12modes_kernel7_source5_pairB4v100B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i.i, label %B318.if.i.i.i

_ZN17bnserve_inference12modes_kernel7_source5_pairB4v100B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i.i: ; preds = %B318.if.i.i.i, %B68.if.i.i.i, %B266.i.i.i, %B16.i.i.i
  %.1638.i62.i = icmp slt i64 %at.2.1892.i.i, 0
  %.1639.i.i = select i1 %.1638.i62.i, i64 %.268.i.i, i64 0
  %.idx.i63.i = shl i64 %at.2.1892.i.i, 4
  %119 = getelementptr i8, ptr %115, i64 %.idx.i63.i
  %.1653.i.i = getelementptr double, ptr %119, i64 %.1639.i.i
  %.1654.i.i = load double, ptr %.1653.i.i, align 8, !noalias !50
  br i1 %38, label %B606.endif.endif.endif.endif.thread.i.i, label %B104.if.i.i64.i

B606.endif.endif.endif.endif.thread.i.i:          ; preds = %_ZN17bnserve_inference12modes_kernel7_source5_pairB4v100B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i.i
  %.16833.i.i = fadd contract double %.1654.i.i, 0.000000e+00
  %sunkaddr2384.i.i = shl i64 %.1639.i.i, 3
  %sunkaddr2395.i.i = getelementptr i8, ptr %119, i64 %sunkaddr2384.i.i
  store double %.16833.i.i, ptr %sunkaddr2395.i.i, align 8, !noalias !50
  %120 = getelementptr i8, ptr %119, i64 8
  %.17456.i.i = getelementptr double, ptr %120, i64 %.1639.i.i
  %.17467.i.i = load double, ptr %.17456.i.i, align 8, !noalias !50
  br label %B606.endif.endif.endif.endif.endif.i.i

B104.if.i.i64.i:                                  ; preds = %_ZN17bnserve_inference12modes_kernel7_source5_pairB4v100B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i.i, %B104.if.i.i64.i
  %lsr.iv9.i.i65.i = phi i64 [ %lsr.iv.next.i.i99.i, %B104.if.i.i64.i ], [ %.60.1.i.i.i, %_ZN17bnserve_inference12modes_kernel7_source5_pairB4v100B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i.i ]
  %lsr.iv.i.i66.i = phi ptr [ %scevgep1.i.i98.i, %B104.if.i.i64.i ], [ %scevgep.i.i58.i, %_ZN17bnserve_inference12modes_kernel7_source5_pairB4v100B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i.i ]
  %s7.2.0168.i.i67.i = phi double [ %.489.i.i97.i, %B104.if.i.i64.i ], [ 0.000000e+00, %_ZN17bnserve_inference12modes_kernel7_source5_pairB4v100B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i.i ]
  %s6.2.0167.i.i68.i = phi double [ %.454.i.i95.i, %B104.if.i.i64.i ], [ 0.000000e+00, %_ZN17bnserve_inference12modes_kernel7_source5_pairB4v100B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i.i ]
  %s5.2.0166.i.i69.i = phi double [ %.419.i.i92.i, %B104.if.i.i64.i ], [ 0.000000e+00, %_ZN17bnserve_inference12modes_kernel7_source5_pairB4v100B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i.i ]
  %s4.2.0165.i.i70.i = phi double [ %.384.i.i89.i, %B104.if.i.i64.i ], [ 0.000000e+00, %_ZN17bnserve_inference12modes_kernel7_source5_pairB4v100B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i.i ]
  %s3.2.0164.i.i71.i = phi double [ %.349.i.i86.i, %B104.if.i.i64.i ], [ 0.000000e+00, %_ZN17bnserve_inference12modes_kernel7_source5_pairB4v100B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i.i ]
  %s2.2.0163.i.i72.i = phi double [ %.314.i.i83.i, %B104.if.i.i64.i ], [ 0.000000e+00, %_ZN17bnserve_inference12modes_kernel7_source5_pairB4v100B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i.i ]
  %s1.2.0162.i.i73.i = phi double [ %.279.i.i80.i, %B104.if.i.i64.i ], [ 0.000000e+00, %_ZN17bnserve_inference12modes_kernel7_source5_pairB4v100B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i.i ]
  %s0.2.0161.i.i74.i = phi double [ %.244.i.i77.i, %B104.if.i.i64.i ], [ 0.000000e+00, %_ZN17bnserve_inference12modes_kernel7_source5_pairB4v100B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i.i ]
  %scevgep2.i.i75.i = getelementptr i8, ptr %lsr.iv.i.i66.i, i64 -56
  %.242.i.i76.i = load double, ptr %scevgep2.i.i75.i, align 8, !noalias !56
  %.244.i.i77.i = fadd contract double %s0.2.0161.i.i74.i, %.242.i.i76.i
  %scevgep3.i.i78.i = getelementptr i8, ptr %lsr.iv.i.i66.i, i64 -48
  %.277.i.i79.i = load double, ptr %scevgep3.i.i78.i, align 8, !noalias !56
  %.279.i.i80.i = fadd contract double %s1.2.0162.i.i73.i, %.277.i.i79.i
  %scevgep4.i.i81.i = getelementptr i8, ptr %lsr.iv.i.i66.i, i64 -40
  %.312.i.i82.i = load double, ptr %scevgep4.i.i81.i, align 8, !noalias !56
  %.314.i.i83.i = fadd contract double %s2.2.0163.i.i72.i, %.312.i.i82.i
  %scevgep5.i.i84.i = getelementptr i8, ptr %lsr.iv.i.i66.i, i64 -32
  %.347.i.i85.i = load double, ptr %scevgep5.i.i84.i, align 8, !noalias !56
  %.349.i.i86.i = fadd contract double %s3.2.0164.i.i71.i, %.347.i.i85.i
  %scevgep6.i.i87.i = getelementptr i8, ptr %lsr.iv.i.i66.i, i64 -24
  %.382.i.i88.i = load double, ptr %scevgep6.i.i87.i, align 8, !noalias !56
  %.384.i.i89.i = fadd contract double %s4.2.0165.i.i70.i, %.382.i.i88.i
  %scevgep7.i.i90.i = getelementptr i8, ptr %lsr.iv.i.i66.i, i64 -16
  %.417.i.i91.i = load double, ptr %scevgep7.i.i90.i, align 8, !noalias !56
  %.419.i.i92.i = fadd contract double %s5.2.0166.i.i69.i, %.417.i.i91.i
  %scevgep8.i.i93.i = getelementptr i8, ptr %lsr.iv.i.i66.i, i64 -8
  %.452.i.i94.i = load double, ptr %scevgep8.i.i93.i, align 8, !noalias !56
  %.454.i.i95.i = fadd contract double %s6.2.0167.i.i68.i, %.452.i.i94.i
  %.487.i.i96.i = load double, ptr %lsr.iv.i.i66.i, align 8, !noalias !56
  %.489.i.i97.i = fadd contract double %s7.2.0168.i.i67.i, %.487.i.i96.i
  %scevgep1.i.i98.i = getelementptr i8, ptr %lsr.iv.i.i66.i, i64 64
  %lsr.iv.next.i.i99.i = add nsw i64 %lsr.iv9.i.i65.i, -1
  %exitcond.not.i.i100.i = icmp eq i64 %lsr.iv.next.i.i99.i, 0
  br i1 %exitcond.not.i.i100.i, label %B104.if.i105.preheader.i.i, label %B104.if.i.i64.i

B104.if.i105.preheader.i.i:                       ; preds = %B104.if.i.i64.i
  %121 = fadd contract double %.244.i.i77.i, %.279.i.i80.i
  %122 = fadd contract double %.314.i.i83.i, %.349.i.i86.i
  %123 = fadd contract double %121, %122
  %124 = fadd contract double %.384.i.i89.i, %.419.i.i92.i
  %125 = fadd contract double %.454.i.i95.i, %.489.i.i97.i
  %126 = fadd contract double %124, %125
  %127 = fadd contract double %123, %126
  %.1683.i.i = fadd contract double %.1654.i.i, %127
  %sunkaddr238.i.i = shl i64 %.1639.i.i, 3
  %sunkaddr239.i.i = getelementptr i8, ptr %119, i64 %sunkaddr238.i.i
  store double %.1683.i.i, ptr %sunkaddr239.i.i, align 8, !noalias !50
  %128 = getelementptr i8, ptr %119, i64 8
  %.1745.i.i = getelementptr double, ptr %128, i64 %.1639.i.i
  %.1746.i.i = load double, ptr %.1745.i.i, align 8, !noalias !50
  br label %B104.if.i105.i.i

B348.loopexit.i142.i.i:                           ; preds = %B104.if.i105.i.i
  %129 = fadd contract double %.244.i118.i.i, %.279.i121.i.i
  %130 = fadd contract double %.314.i124.i.i, %.349.i127.i.i
  %131 = fadd contract double %129, %130
  %132 = fadd contract double %.384.i130.i.i, %.419.i133.i.i
  %133 = fadd contract double %.454.i136.i.i, %.489.i138.i.i
  %134 = fadd contract double %132, %133
  %135 = fadd contract double %131, %134
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
  %.242.i117.i.i = load double, ptr %scevgep2.i116.i.i, align 8, !noalias !59
  %.244.i118.i.i = fadd contract double %s0.2.0161.i115.i.i, %.242.i117.i.i
  %scevgep3.i119.i.i = getelementptr i8, ptr %lsr.iv.i107.i.i, i64 -48
  %.277.i120.i.i = load double, ptr %scevgep3.i119.i.i, align 8, !noalias !59
  %.279.i121.i.i = fadd contract double %s1.2.0162.i114.i.i, %.277.i120.i.i
  %scevgep4.i122.i.i = getelementptr i8, ptr %lsr.iv.i107.i.i, i64 -40
  %.312.i123.i.i = load double, ptr %scevgep4.i122.i.i, align 8, !noalias !59
  %.314.i124.i.i = fadd contract double %s2.2.0163.i113.i.i, %.312.i123.i.i
  %scevgep5.i125.i.i = getelementptr i8, ptr %lsr.iv.i107.i.i, i64 -32
  %.347.i126.i.i = load double, ptr %scevgep5.i125.i.i, align 8, !noalias !59
  %.349.i127.i.i = fadd contract double %s3.2.0164.i112.i.i, %.347.i126.i.i
  %scevgep6.i128.i.i = getelementptr i8, ptr %lsr.iv.i107.i.i, i64 -24
  %.382.i129.i.i = load double, ptr %scevgep6.i128.i.i, align 8, !noalias !59
  %.384.i130.i.i = fadd contract double %s4.2.0165.i111.i.i, %.382.i129.i.i
  %scevgep7.i131.i.i = getelementptr i8, ptr %lsr.iv.i107.i.i, i64 -16
  %.417.i132.i.i = load double, ptr %scevgep7.i131.i.i, align 8, !noalias !59
  %.419.i133.i.i = fadd contract double %s5.2.0166.i110.i.i, %.417.i132.i.i
  %scevgep8.i134.i.i = getelementptr i8, ptr %lsr.iv.i107.i.i, i64 -8
  %.452.i135.i.i = load double, ptr %scevgep8.i134.i.i, align 8, !noalias !59
  %.454.i136.i.i = fadd contract double %s6.2.0167.i109.i.i, %.452.i135.i.i
  %.487.i137.i.i = load double, ptr %lsr.iv.i107.i.i, align 8, !noalias !59
  %.489.i138.i.i = fadd contract double %s7.2.0168.i108.i.i, %.487.i137.i.i
  %scevgep1.i139.i.i = getelementptr i8, ptr %lsr.iv.i107.i.i, i64 64
  %lsr.iv.next.i140.i.i = add nsw i64 %lsr.iv9.i106.i.i, -1
  %exitcond.not.i141.i.i = icmp eq i64 %lsr.iv.next.i140.i.i, 0
  br i1 %exitcond.not.i141.i.i, label %B348.loopexit.i142.i.i, label %B104.if.i105.i.i

B606.endif.endif.endif.endif.endif.i.i:           ; preds = %B348.loopexit.i142.i.i, %B606.endif.endif.endif.endif.thread.i.i
  %.17468.i.i = phi double [ %.17467.i.i, %B606.endif.endif.endif.endif.thread.i.i ], [ %.1746.i.i, %B348.loopexit.i142.i.i ]
  %s0.2.0.lcssa.i143.i.i = phi double [ 0.000000e+00, %B606.endif.endif.endif.endif.thread.i.i ], [ %135, %B348.loopexit.i142.i.i ]
  %.1775.i.i = fadd contract double %.17468.i.i, %s0.2.0.lcssa.i143.i.i
  %sunkaddr240.i.i = shl i64 %.1639.i.i, 3
  %sunkaddr241.i.i = getelementptr i8, ptr %119, i64 %sunkaddr240.i.i
  %sunkaddr242.i.i = getelementptr i8, ptr %sunkaddr241.i.i, i64 8
  store double %.1775.i.i, ptr %sunkaddr242.i.i, align 8, !noalias !50
  %.1807.i.i = add i64 %at.2.1892.i.i, 1
  %exitcond.not.i101.i = icmp eq i64 %.1807.i.i, %116
  br i1 %exitcond.not.i101.i, label %B860.i.i, label %B404.if.i.i

_ZN17bnserve_inference12modes_kernel7_source10_add_pairsB3v85B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i: ; preds = %B860.i.i, %_ZN17bnserve_inference12modes_kernel7_source13_add_productsB3v45B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxx5ArrayIxLi1E1C7mutable7alignedEdd5ArrayIdLi1E1C7mutable7alignedE.exit.i
  %scevgep275.i = getelementptr i8, ptr %lsr.iv274.i, i64 24
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
!15 = distinct !{!15, !16, !"_ZN17bnserve_inference12modes_kernel7_source9_add_modeB3v42B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedExxdd5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!16 = distinct !{!16, !"_ZN17bnserve_inference12modes_kernel7_source9_add_modeB3v42B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedExxdd5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!17 = !{!18, !12, !1}
!18 = distinct !{!18, !19, !"_ZN17bnserve_inference6kernel5_sums9errors_atB3v43B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedExx5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!19 = distinct !{!19, !"_ZN17bnserve_inference6kernel5_sums9errors_atB3v43B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedExx5ArrayIdLi1E1C7mutable7alignedE"}
!20 = !{!21, !12, !1}
!21 = distinct !{!21, !22, !"_ZN17bnserve_inference6kernel5_sums9errors_atB3v43B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedExx5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!22 = distinct !{!22, !"_ZN17bnserve_inference6kernel5_sums9errors_atB3v43B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedExx5ArrayIdLi1E1C7mutable7alignedE"}
!23 = !{!24, !12, !1}
!24 = distinct !{!24, !25, !"_ZN17bnserve_inference12modes_kernel7_source10_calibrateB3v44B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!25 = distinct !{!25, !"_ZN17bnserve_inference12modes_kernel7_source10_calibrateB3v44B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!26 = !{!27, !1}
!27 = distinct !{!27, !28, !"_ZN17bnserve_inference12modes_kernel7_source13_add_productsB3v45B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxx5ArrayIxLi1E1C7mutable7alignedEdd5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!28 = distinct !{!28, !"_ZN17bnserve_inference12modes_kernel7_source13_add_productsB3v45B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxx5ArrayIxLi1E1C7mutable7alignedEdd5ArrayIdLi1E1C7mutable7alignedE"}
!29 = !{!30, !27, !1}
!30 = distinct !{!30, !31, !"_ZN17bnserve_inference6kernel5_sums9spline_atB3v67B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dEd5ArrayIdLi1E1C7mutable7alignedExxx: %retptr"}
!31 = distinct !{!31, !"_ZN17bnserve_inference6kernel5_sums9spline_atB3v67B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dEd5ArrayIdLi1E1C7mutable7alignedExxx"}
!32 = !{!33, !27, !1}
!33 = distinct !{!33, !34, !"_ZN17bnserve_inference6kernel5_sums8lane_sumB3v83B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!34 = distinct !{!34, !"_ZN17bnserve_inference6kernel5_sums8lane_sumB3v83B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE"}
!35 = !{!36, !27, !1}
!36 = distinct !{!36, !37, !"_ZN17bnserve_inference12modes_kernel7_source6_turnsB3v64B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedEd5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!37 = distinct !{!37, !"_ZN17bnserve_inference12modes_kernel7_source6_turnsB3v64B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedEd5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!38 = !{!39, !27, !1}
!39 = distinct !{!39, !40, !"_ZN17bnserve_inference12modes_kernel7_source6_fixedB3v66B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!40 = distinct !{!40, !"_ZN17bnserve_inference12modes_kernel7_source6_fixedB3v66B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!41 = !{!42, !27, !1}
!42 = distinct !{!42, !43, !"_ZN17bnserve_inference12modes_kernel7_source8_splinedB3v70B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE8UniTupleIxLi3EE8UniTupleIdLi6EE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!43 = distinct !{!43, !"_ZN17bnserve_inference12modes_kernel7_source8_splinedB3v70B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE8UniTupleIxLi3EE8UniTupleIdLi6EE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!44 = !{!45, !27, !1}
!45 = distinct !{!45, !46, !"_ZN17bnserve_inference6kernel5_sums8lane_sumB3v83B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!46 = distinct !{!46, !"_ZN17bnserve_inference6kernel5_sums8lane_sumB3v83B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE"}
!47 = !{!48, !27, !1}
!48 = distinct !{!48, !49, !"_ZN17bnserve_inference6kernel5_sums9add_termsB3v84B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEdd5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!49 = distinct !{!49, !"_ZN17bnserve_inference6kernel5_sums9add_termsB3v84B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEdd5ArrayIdLi1E1C7mutable7alignedE"}
!50 = !{!51, !1}
!51 = distinct !{!51, !52, !"_ZN17bnserve_inference12modes_kernel7_source10_add_pairsB3v85B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!52 = distinct !{!52, !"_ZN17bnserve_inference12modes_kernel7_source10_add_pairsB3v85B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!53 = !{!54, !51, !1}
!54 = distinct !{!54, !55, !"_ZN17bnserve_inference12modes_kernel7_source5_pairB4v100B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!55 = distinct !{!55, !"_ZN17bnserve_inference12modes_kernel7_source5_pairB4v100B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!56 = !{!57, !51, !1}
!57 = distinct !{!57, !58, !"_ZN17bnserve_inference6kernel5_sums8lane_sumB3v83B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!58 = distinct !{!58, !"_ZN17bnserve_inference6kernel5_sums8lane_sumB3v83B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE"}
!59 = !{!60, !51, !1}
!60 = distinct !{!60, !61, !"_ZN17bnserve_inference6kernel5_sums8lane_sumB3v83B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!61 = distinct !{!61, !"_ZN17bnserve_inference6kernel5_sums8lane_sumB3v83B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE"}
