; sources: 2c3c4ec8c2fc98c881382f269a1086975b8d9e03e127a26d06c76f4bb30e6747
; built by: numba 0.68.1, llvmlite 0.50.0, Python 3.11, x86_64
; ModuleID = '<string>'
source_filename = "<string>"


; Function Attrs: nofree norecurse nosync nounwind memory(readwrite, inaccessiblemem: none, target_mem0: none, target_mem1: none)
define noundef i32 @bnserve_contract(ptr noalias writeonly captures(none) %retptr, ptr noalias readnone captures(none) %excinfo, ptr readonly captures(none) %arg.arguments) local_unnamed_addr #0 {
entry:
  %.47.i = load i64, ptr %arg.arguments, align 8, !noalias !0
  %.199.i = mul nsw i64 %.47.i, 9
  %.285.i = mul nsw i64 %.47.i, 3
  %.370.i = getelementptr i8, ptr %arg.arguments, i64 248
  %.371.i = load i64, ptr %.370.i, align 8, !noalias !0
  %.375.i = inttoptr i64 %.371.i to ptr
  %.501.i = getelementptr double, ptr %.375.i, i64 %.285.i
  %.563.i = getelementptr i8, ptr %.501.i, i64 4096
  %.642.i = getelementptr i8, ptr %.501.i, i64 8192
  %.705.i = getelementptr i8, ptr %.501.i, i64 12288
  %.784.i = getelementptr i8, ptr %.501.i, i64 16384
  %.847.i = getelementptr i8, ptr %.501.i, i64 20480
  %.926.i = getelementptr i8, ptr %.501.i, i64 24576
  %.992.i = getelementptr i8, ptr %.501.i, i64 28672
  %.1376.i = getelementptr i8, ptr %arg.arguments, i64 160
  %.1473.i = load i64, ptr %.1376.i, align 8, !noalias !0
  %.15531084.not.i = icmp slt i64 %.1473.i, 1
  br i1 %.15531084.not.i, label %_ZN17bnserve_inference6kernel7_source8contractB2v3B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIxLi1E1C7mutable7alignedE.exit, label %B574.if.lr.ph.i

B574.if.lr.ph.i:                                  ; preds = %entry
  %.1346.i = getelementptr i8, ptr %arg.arguments, i64 232
  %.1347.i = load i64, ptr %.1346.i, align 8, !noalias !0
  %.283.i = getelementptr i8, ptr %arg.arguments, i64 48
  %.284.i = load i64, ptr %.283.i, align 8, !noalias !0
  %.197.i = getelementptr i8, ptr %arg.arguments, i64 40
  %.198.i = load i64, ptr %.197.i, align 8, !noalias !0
  %.110.i = getelementptr i8, ptr %arg.arguments, i64 32
  %.111.i = load i64, ptr %.110.i, align 8, !noalias !0
  %.76.i = getelementptr i8, ptr %arg.arguments, i64 8
  %.77.i = load i64, ptr %.76.i, align 8, !noalias !0
  %.1744.i = shl i64 %.77.i, 4
  %.1748.i = shl nsw i64 %.77.i, 1
  %0 = inttoptr i64 %.111.i to ptr
  %1 = inttoptr i64 %.198.i to ptr
  %2 = inttoptr i64 %.284.i to ptr
  %sunkaddr37.i = getelementptr i8, ptr %arg.arguments, i64 176
  %.128.i.i = getelementptr i8, ptr %0, i64 8
  %.706618.not.i.i = icmp slt i64 %.47.i, 1
  %sunkaddr.i = getelementptr i8, ptr %arg.arguments, i64 168
  %.496.i2.i = getelementptr i8, ptr %arg.arguments, i64 88
  %.526.i.i = getelementptr i8, ptr %arg.arguments, i64 208
  %.607.i.i = getelementptr i8, ptr %arg.arguments, i64 184
  %.644.i.i = getelementptr i8, ptr %arg.arguments, i64 56
  %.726.i.i = getelementptr i8, ptr %arg.arguments, i64 104
  %.824.i.i = getelementptr i8, ptr %arg.arguments, i64 80
  %.907.i.i = getelementptr i8, ptr %arg.arguments, i64 16
  %.954.i.i = getelementptr i8, ptr %arg.arguments, i64 224
  %.490.i.i = getelementptr i8, ptr %arg.arguments, i64 96
  %.608.i9.i = getelementptr i8, ptr %arg.arguments, i64 112
  %.696.i.i = getelementptr i8, ptr %arg.arguments, i64 120
  %3 = inttoptr i64 %.1347.i to ptr
  %scevgep.i.i.i = getelementptr i8, ptr %.501.i, i64 16440
  %scevgep.i493.i.i = getelementptr i8, ptr %.501.i, i64 20536
  %sunkaddr65.i.i = getelementptr i8, ptr %arg.arguments, i64 216
  %sunkaddr71.i.i = getelementptr i8, ptr %arg.arguments, i64 240
  %sunkaddr64.i.i = getelementptr i8, ptr %arg.arguments, i64 192
  %sunkaddr86.i.i = getelementptr i8, ptr %arg.arguments, i64 200
  %sunkaddr98.i.i = getelementptr i8, ptr %arg.arguments, i64 24
  %sunkaddr100.i.i = getelementptr i8, ptr %arg.arguments, i64 64
  %sunkaddr65.i11.i = getelementptr i8, ptr %arg.arguments, i64 72
  br label %B574.if.i

B574.if.i:                                        ; preds = %_ZN17bnserve_inference6kernel7_source19_contract_quadraticB3v69B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi1E1C7mutable7alignedE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi2EE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi2EE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi2EE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi2EEE.exit.i, %B574.if.lr.ph.i
  %lsr.iv263.i = phi i64 [ 0, %B574.if.lr.ph.i ], [ %lsr.iv.next264.i, %_ZN17bnserve_inference6kernel7_source19_contract_quadraticB3v69B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi1E1C7mutable7alignedE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi2EE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi2EE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi2EE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi2EEE.exit.i ]
  %lsr.iv.i = phi i64 [ 0, %B574.if.lr.ph.i ], [ %lsr.iv.next.i, %_ZN17bnserve_inference6kernel7_source19_contract_quadraticB3v69B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi1E1C7mutable7alignedE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi2EE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi2EE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi2EE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi2EEE.exit.i ]
  %.155910791085.i = phi i64 [ 0, %B574.if.lr.ph.i ], [ %.1566.i, %_ZN17bnserve_inference6kernel7_source19_contract_quadraticB3v69B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi1E1C7mutable7alignedE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi2EE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi2EE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi2EE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi2EEE.exit.i ]
  %.1566.i = add nuw nsw i64 %.155910791085.i, 1
  %.1621.i = load i64, ptr %sunkaddr37.i, align 8, !noalias !0
  %4 = add i64 %.1621.i, %lsr.iv263.i
  %.1625.i = inttoptr i64 %4 to ptr
  %.100.i.i = load double, ptr %0, align 8, !noalias !3
  %.129.i.i = load double, ptr %.128.i.i, align 8, !noalias !3
  %.161.i.i = getelementptr i8, ptr %.1625.i, i64 24
  %.162.i.i = load double, ptr %.161.i.i, align 8, !noalias !3
  %.163.i.i = fmul contract double %.129.i.i, %.162.i.i
  %.164.i.i = fadd contract double %.100.i.i, %.163.i.i
  %.194.i.i = load double, ptr %.1625.i, align 8, !noalias !3
  %.195.i.i = fsub contract double %.164.i.i, %.194.i.i
  %.197.i.i = tail call contract double @llvm.fma.f64(double %.195.i.i, double 0x3FE45F306DC9C883, double 0x4338000000000000)
  %.198.i.i = fadd contract double %.197.i.i, 0xC338000000000000
  %.213.i.i = tail call contract double @llvm.fma.f64(double %.198.i.i, double 0xBFF921FB54442D18, double %.195.i.i)
  %.228.i.i = tail call contract double @llvm.fma.f64(double %.198.i.i, double 0xBC91A62633145C07, double %.213.i.i)
  %.229.i.i = fmul contract double %.228.i.i, %.228.i.i
  %.230.i.i = tail call contract double @llvm.fma.f64(double %.229.i.i, double 0xBD6AE7F3E733B81F, double 0x3DE6124613A86D09)
  %.231.i.i = tail call contract double @llvm.fma.f64(double %.229.i.i, double %.230.i.i, double 0xBE5AE64567F544E4)
  %.232.i.i = tail call contract double @llvm.fma.f64(double %.229.i.i, double %.231.i.i, double 0x3EC71DE3A556C734)
  %.233.i.i = tail call contract double @llvm.fma.f64(double %.229.i.i, double %.232.i.i, double 0xBF2A01A01A01A01A)
  %.234.i.i = tail call contract double @llvm.fma.f64(double %.229.i.i, double %.233.i.i, double 0x3F81111111111111)
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
  %5 = icmp eq i64 %.250.i.i, 0
  %.252.i.i = select i1 %5, i64 0, i64 %.249.i.i
  %.253.i.i = shl i64 %.246.i.i, 62
  %.254.i.i = and i64 %.253.i.i, -9223372036854775808
  %.256.i.i = add i64 %.253.i.i, 4611686018427387904
  %.257.i.i = and i64 %.256.i.i, -9223372036854775808
  %6 = xor i64 %.254.i.i, %.247.i.i
  %.259.i.i = xor i64 %6, %.252.i.i
  %.260.i.i = bitcast i64 %.259.i.i to double
  %7 = xor i64 %.257.i.i, %.248.i.i
  %.262.i.i = xor i64 %7, %.252.i.i
  %.263.i.i = bitcast i64 %.262.i.i to double
  %.313.i.i = getelementptr i8, ptr %.1625.i, i64 8
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
  %8 = icmp eq i64 %.368.i.i, 0
  %.370.i.i = select i1 %8, i64 0, i64 %.367.i.i
  %.371.i.i = shl i64 %.364.i.i, 62
  %.372.i.i = and i64 %.371.i.i, -9223372036854775808
  %.374.i.i = add i64 %.371.i.i, 4611686018427387904
  %.375.i.i = and i64 %.374.i.i, -9223372036854775808
  %9 = xor i64 %.372.i.i, %.365.i.i
  %.377.i.i = xor i64 %9, %.370.i.i
  %.378.i.i = bitcast i64 %.377.i.i to double
  %10 = xor i64 %.375.i.i, %.366.i.i
  %.380.i.i = xor i64 %10, %.370.i.i
  %.381.i.i = bitcast i64 %.380.i.i to double
  %.434.i.i = getelementptr i8, ptr %.1625.i, i64 16
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
  %.474.i.i = tail call contract double @llvm.fma.f64(double %.468.i.i, double %.473.i.i, double 0xBFC5555555555555)
  %.475.i.i = fmul contract double %.467.i.i, %.468.i.i
  %.476.i.i = tail call contract double @llvm.fma.f64(double %.475.i.i, double %.474.i.i, double %.467.i.i)
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
  %11 = icmp eq i64 %.489.i.i, 0
  %.491.i.i = select i1 %11, i64 0, i64 %.488.i.i
  %.492.i.i = shl i64 %.485.i.i, 62
  %.493.i.i = and i64 %.492.i.i, -9223372036854775808
  %.495.i.i = add i64 %.492.i.i, 4611686018427387904
  %.496.i.i = and i64 %.495.i.i, -9223372036854775808
  %12 = xor i64 %.493.i.i, %.486.i.i
  %.498.i.i = xor i64 %12, %.491.i.i
  %.499.i.i = bitcast i64 %.498.i.i to double
  %13 = xor i64 %.496.i.i, %.487.i.i
  %.501.i.i = xor i64 %13, %.491.i.i
  %.502.i.i = bitcast i64 %.501.i.i to double
  %.523.i.i = fneg contract double %.502.i.i
  %.524.i.i = fmul contract double %.523.i.i, %.260.i.i
  %.525.i.i = fmul contract double %.499.i.i, %.263.i.i
  %.527.i.i = fmul contract double %.525.i.i, %.378.i.i
  %.528.i.i = fsub contract double %.524.i.i, %.527.i.i
  %.534.i.i = fmul contract double %.499.i.i, %.260.i.i
  %.536.i.i = fmul contract double %.534.i.i, %.378.i.i
  %14 = fmul contract double %.502.i.i, %.263.i.i
  %.537.i.i = fsub contract double %.536.i.i, %14
  %.541.i.i = fmul contract double %.381.i.i, %.499.i.i
  %.548.i.i = fmul contract double %14, %.378.i.i
  %.549.i.i = fsub contract double %.534.i.i, %.548.i.i
  %.554.i.i = fmul contract double %.502.i.i, %.260.i.i
  %.556.i.i = fmul contract double %.554.i.i, %.378.i.i
  %.557.i.i = fadd contract double %.525.i.i, %.556.i.i
  %.561.i.i = fmul contract double %.381.i.i, %.502.i.i
  %.565.i.i = fmul contract double %.381.i.i, %.263.i.i
  %.569.i.i = fneg contract double %.381.i.i
  %.570.i.i = fmul contract double %.569.i.i, %.260.i.i
  br i1 %.706618.not.i.i, label %_ZN17bnserve_inference6kernel7_source9_geometryB3v22B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i, label %B502.if.preheader.i.i

B502.if.preheader.i.i:                            ; preds = %B574.if.i
  %sunkaddr9.i.i = getelementptr i8, ptr %.1625.i, i64 32
  %sunkaddr11.i.i = getelementptr i8, ptr %.1625.i, i64 40
  %sunkaddr13.i.i = getelementptr i8, ptr %.1625.i, i64 48
  br label %B502.if.i.i

B502.if.i.i:                                      ; preds = %B506.endif.else.endif.endif.i.i, %B502.if.preheader.i.i
  %lsr.iv8.i.i = phi i64 [ %lsr.iv.next9.i.i, %B506.endif.else.endif.endif.i.i ], [ %.47.i, %B502.if.preheader.i.i ]
  %lsr.iv6.i.i = phi i64 [ %lsr.iv.next7.i.i, %B506.endif.else.endif.endif.i.i ], [ 0, %B502.if.preheader.i.i ]
  %lsr.iv.i.i = phi i64 [ %lsr.iv.next.i.i, %B506.endif.else.endif.endif.i.i ], [ 0, %B502.if.preheader.i.i ]
  %.793.not.i.i = icmp slt i64 %lsr.iv6.i.i, %.199.i
  br i1 %.793.not.i.i, label %B506.else.endif.endif.i.i, label %B506.else.endif.if.i.i, !prof !6

B506.else.endif.if.i.i:                           ; preds = %B502.if.i.i
  br label %B506.else.endif.endif.i.i

B506.else.endif.endif.i.i:                        ; preds = %B506.else.endif.if.i.i, %B502.if.i.i
  %.773.sroa.0.3.i.i = phi i64 [ %.199.i, %B506.else.endif.if.i.i ], [ %lsr.iv6.i.i, %B502.if.i.i ]
  %.886.i.i = getelementptr double, ptr %1, i64 %.773.sroa.0.3.i.i
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
  %.1574.not.i.i = icmp slt i64 %lsr.iv.i.i, %.285.i
  br i1 %.1574.not.i.i, label %B506.endif.else.endif.endif.i.i, label %B506.endif.else.endif.if.i.i, !prof !6

B506.endif.else.endif.if.i.i:                     ; preds = %B506.else.endif.endif.i.i
  br label %B506.endif.else.endif.endif.i.i

B506.endif.else.endif.endif.i.i:                  ; preds = %B506.endif.else.endif.if.i.i, %B506.else.endif.endif.i.i
  %.1554.sroa.0.3.i.i = phi i64 [ %.285.i, %B506.endif.else.endif.if.i.i ], [ %lsr.iv.i.i, %B506.else.endif.endif.i.i ]
  %.1667.i.i = getelementptr double, ptr %2, i64 %.1554.sroa.0.3.i.i
  %.1728.i.i = load double, ptr %sunkaddr9.i.i, align 8, !noalias !3
  %.1729.i.i = fmul contract double %.1507.i.i, %.1728.i.i
  %.1759.i.i = load double, ptr %sunkaddr11.i.i, align 8, !noalias !3
  %.1760.i.i = fmul contract double %.1524.i.i, %.1759.i.i
  %.1761.i.i = fadd contract double %.1729.i.i, %.1760.i.i
  %sunkaddr.i.i = shl i64 %lsr.iv.i.i, 3
  %sunkaddr12.i.i = getelementptr i8, ptr %.375.i, i64 %sunkaddr.i.i
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
  %lsr.iv.next.i.i = add nuw i64 %lsr.iv.i.i, 3
  %lsr.iv.next7.i.i = add nuw i64 %lsr.iv6.i.i, 9
  %lsr.iv.next9.i.i = add nsw i64 %lsr.iv8.i.i, -1
  %exitcond.not.i.i = icmp eq i64 %lsr.iv.next9.i.i, 0
  br i1 %exitcond.not.i.i, label %_ZN17bnserve_inference6kernel7_source9_geometryB3v22B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i, label %B502.if.i.i

_ZN17bnserve_inference6kernel7_source9_geometryB3v22B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i: ; preds = %B506.endif.else.endif.endif.i.i, %B574.if.i
  %.1742.i = load i64, ptr %sunkaddr.i, align 8, !noalias !0
  %15 = add i64 %.1742.i, %lsr.iv.i
  %.1749.i = inttoptr i64 %15 to ptr
  %.1826.i = load double, ptr %.161.i.i, align 8, !noalias !0
  %.467.i1.i = load i64, ptr %arg.arguments, align 8, !noalias !7
  %.497.i.i = load i64, ptr %.496.i2.i, align 8, !noalias !7
  %.527.i3.i = load i64, ptr %.526.i.i, align 8, !noalias !7
  %.536.i4.i = sub i64 0, %.497.i.i
  %.544.1.i.i = and i64 %.536.i4.i, -8
  %.578.i.i = sub i64 0, %.544.1.i.i
  %.608.i.i = load i64, ptr %.607.i.i, align 8, !noalias !7
  %.645.i.i = load i64, ptr %.644.i.i, align 8, !noalias !7
  %.727.i.i = load i64, ptr %.726.i.i, align 8, !noalias !7
  %.825.i.i = load i64, ptr %.824.i.i, align 8, !noalias !7
  %.828.i.i = mul nsw i64 %.608.i.i, %.578.i.i
  %.878.i.i = shl nsw i64 %.578.i.i, 1
  %.908.i.i = load i64, ptr %.907.i.i, align 8, !noalias !7
  %.909.i.i = mul nsw i64 %.908.i.i, %.878.i.i
  %.955.i.i = load i64, ptr %.954.i.i, align 8, !noalias !7
  %.956.i.i = shl i64 %.155910791085.i, 4
  %.958.i.i = mul i64 %.956.i.i, %.527.i3.i
  %.959.i.i = add nsw i64 %.955.i.i, %.958.i.i
  %.1202.i5.i = icmp slt i64 %.527.i3.i, 1
  br i1 %.1202.i5.i, label %.1268.if.i.i, label %.1268.endif.preheader.i.i, !prof !10

B590.i.i:                                         ; preds = %B590.preheader.i.i, %B2385.i.i
  %.1385.sroa.0.0254.i.i = phi i64 [ %.1385.sroa.0.0.i.i, %B2385.i.i ], [ 0, %B590.preheader.i.i ]
  %.1342.1253.in.i.i = phi i64 [ %28, %B2385.i.i ], [ %.1374.i.i, %B590.preheader.i.i ]
  %.1339.1252.i.i = phi i64 [ %.1339.1.i.i, %B2385.i.i ], [ 512, %B590.preheader.i.i ]
  %.1438.i.i = sub i64 %.578.i.i, %.1385.sroa.0.0254.i.i
  %.13.i.i.i = tail call i64 @llvm.smin.i64(i64 %.1438.i.i, i64 512)
  %.1472.i.i = sub i64 %.497.i.i, %.1385.sroa.0.0254.i.i
  %.13.i316.i.i = tail call i64 @llvm.smin.i64(i64 %.1472.i.i, i64 %.13.i.i.i)
  %.1987.i.i = icmp slt i64 %.1385.sroa.0.0254.i.i, 0
  %.1988.i.i = select i1 %.1987.i.i, i64 %.497.i.i, i64 0
  %.1989.i.i = add i64 %.1988.i.i, %.1385.sroa.0.0254.i.i
  %.1992.i.i = icmp slt i64 %.1989.i.i, 0
  br i1 %.1992.i.i, label %B590.endif.endif.endif.endif.endif.endif.else.if.i.i, label %B590.endif.endif.endif.endif.endif.endif.else.endif.i.i, !prof !10

B854.i.i:                                         ; preds = %B854.preheader.i.i, %B2247.i.i
  %.2245.sroa.0.0248.i.i = phi i64 [ %.2245.sroa.0.0.i.i, %B2247.i.i ], [ 0, %B854.preheader.i.i ]
  %.2202.1247.in.i.i = phi i64 [ %26, %B2247.i.i ], [ %.467.i1.i, %B854.preheader.i.i ]
  %.2199.1246.i.i = phi i64 [ %.2199.1.i.i, %B2247.i.i ], [ 1, %B854.preheader.i.i ]
  br i1 %34, label %B872.i.i, label %B1264.i.i

B872.i.i:                                         ; preds = %B854.i.i
  %.2779.i.i = add nsw i64 %.2245.sroa.0.0248.i.i, %.2777.i.i
  %.2814.i.i = load i64, ptr %.607.i.i, align 8, !noalias !7
  %.2844.i.i = load i64, ptr %sunkaddr64.i.i, align 8, !noalias !7
  %.2848.i.i = shl i64 %.2779.i.i, 3
  %.2849.i.i = mul i64 %.2814.i.i, %.2848.i.i
  %.2850.i.i = add nsw i64 %.2849.i.i, %.2844.i.i
  br i1 %56, label %B60.if.preheader.i.i.i, label %B76.i.i.i

B1264.i.i:                                        ; preds = %B56.if.i.i.i, %B872.endif.endif.endif.endif.endif.endif.endif.endif.i.i, %B854.i.i
  %strain.2.sroa.88.2.i.i = phi ptr [ %.563.i, %B854.i.i ], [ %.705.i, %B872.endif.endif.endif.endif.endif.endif.endif.endif.i.i ], [ %.705.i, %B56.if.i.i.i ]
  %strain.2.sroa.32.2.i.i = phi ptr [ %.501.i, %B854.i.i ], [ %.642.i, %B872.endif.endif.endif.endif.endif.endif.endif.endif.i.i ], [ %.642.i, %B56.if.i.i.i ]
  %.3326.i.i = icmp slt i64 %.2245.sroa.0.0248.i.i, 0
  %.3327.i.i = select i1 %.3326.i.i, i64 %.285.i, i64 0
  %.idx.i.i = mul i64 %.2245.sroa.0.0248.i.i, 24
  %16 = getelementptr i8, ptr %.375.i, i64 %.idx.i.i
  %.3341.i.i = getelementptr double, ptr %16, i64 %.3327.i.i
  %.3342.i.i = load double, ptr %.3341.i.i, align 8, !noalias !7
  %17 = getelementptr i8, ptr %16, i64 8
  %.3374.i.i = getelementptr double, ptr %17, i64 %.3327.i.i
  %.3375.i.i = load double, ptr %.3374.i.i, align 8, !noalias !7
  %18 = getelementptr i8, ptr %16, i64 16
  %.3411.i.i = getelementptr double, ptr %18, i64 %.3327.i.i
  %.3412.i.i = load double, ptr %.3411.i.i, align 8, !noalias !7
  %.37562200.i.i = load double, ptr %sunkaddr65.i.i, align 8, !noalias !7
  %.3789.i.i = load i64, ptr %.526.i.i, align 8, !noalias !7
  %.38722458.not.i.i = icmp slt i64 %.3789.i.i, 1
  br i1 %.38722458.not.i.i, label %B1766.i.i, label %B1552.if.lr.ph.i.i

B1672.i.i:                                        ; preds = %B1552.if.i.i
  %.104.i468.i.i = fmul contract double %.3920.i.i, 0xC01921FB54442D18
  br i1 %57, label %B1762.i.i, label %B78.if.i.i.i

B1758.i.i:                                        ; preds = %B1552.if.i.i
  %.48.i.i.i = load double, ptr %sunkaddr67.i.i, align 8, !noalias !11
  %.49.i.i.i = fsub contract double %.3920.i.i, %.48.i.i.i
  %.78.i.i.i = load double, ptr %sunkaddr69.i.i, align 8, !noalias !11
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
  %.191.i.i.i = fdiv contract double %.187.i.i.i, 1.200000e+02
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
  %.266.i.i.i = mul nsw i64 %.265.i.i.i, %.878.i.i
  %.267.i.i.i = add nsw i64 %.266.i.i.i, %.1385.sroa.0.0254.i.i
  %.215.i.i.i = icmp slt i64 %.267.i.i.i, 0
  %.216.i.i.i = select i1 %.215.i.i.i, i64 %.909.i.i, i64 0
  %.217.i1.i.i = add i64 %.216.i.i.i, %.267.i.i.i
  %.220.i2.i.i = icmp slt i64 %.217.i1.i.i, 0
  br i1 %.220.i2.i.i, label %B0.else.if.i.i.i, label %B0.else.endif.i.i.i, !prof !10

B0.else.if.i.i.i:                                 ; preds = %B1758.i.i
  br label %B0.else.endif.i.i.i

B0.else.endif.i.i.i:                              ; preds = %B0.else.if.i.i.i, %B1758.i.i
  %.205.sroa.0.1.i.i.i = phi i64 [ 0, %B0.else.if.i.i.i ], [ %.217.i1.i.i, %B1758.i.i ]
  %.225.not.i.i.i = icmp slt i64 %.217.i1.i.i, %.909.i.i
  br i1 %.225.not.i.i.i, label %B0.else.endif.endif.endif.endif.i.i.i, label %B0.else.endif.if.i.i.i, !prof !6

B0.else.endif.if.i.i.i:                           ; preds = %B0.else.endif.i.i.i
  br label %B0.else.endif.endif.endif.endif.i.i.i

B0.else.endif.endif.endif.endif.i.i.i:            ; preds = %B0.else.endif.if.i.i.i, %B0.else.endif.i.i.i
  %.205.sroa.0.3.i.i.i = phi i64 [ %.909.i.i, %B0.else.endif.if.i.i.i ], [ %.205.sroa.0.1.i.i.i, %B0.else.endif.i.i.i ]
  %.318.i3.i.i = getelementptr double, ptr %80, i64 %.205.sroa.0.3.i.i.i
  %.350.i4.i.i = sub i64 %.267.i.i.i, %.544.1.i.i
  %.388.i5.i.i = icmp slt i64 %.350.i4.i.i, 0
  %.389.i.i.i = select i1 %.388.i5.i.i, i64 %.909.i.i, i64 0
  %.390.i.i.i = add i64 %.389.i.i.i, %.350.i4.i.i
  %.393.i.i.i = icmp slt i64 %.390.i.i.i, 0
  br i1 %.393.i.i.i, label %B0.endif.else.if.i.i.i, label %B0.endif.else.endif.i.i.i, !prof !10

B0.endif.else.if.i.i.i:                           ; preds = %B0.else.endif.endif.endif.endif.i.i.i
  br label %B0.endif.else.endif.i.i.i

B0.endif.else.endif.i.i.i:                        ; preds = %B0.endif.else.if.i.i.i, %B0.else.endif.endif.endif.endif.i.i.i
  %.378.sroa.0.1.i.i.i = phi i64 [ 0, %B0.endif.else.if.i.i.i ], [ %.390.i.i.i, %B0.else.endif.endif.endif.endif.i.i.i ]
  %.398.not.i.i.i = icmp slt i64 %.390.i.i.i, %.909.i.i
  br i1 %.398.not.i.i.i, label %B0.endif.else.endif.endif.endif.endif.i.i.i, label %B0.endif.else.endif.if.i.i.i, !prof !6

B0.endif.else.endif.if.i.i.i:                     ; preds = %B0.endif.else.endif.i.i.i
  br label %B0.endif.else.endif.endif.endif.endif.i.i.i

B0.endif.else.endif.endif.endif.endif.i.i.i:      ; preds = %B0.endif.else.endif.if.i.i.i, %B0.endif.else.endif.i.i.i
  %.378.sroa.0.3.i.i.i = phi i64 [ %.909.i.i, %B0.endif.else.endif.if.i.i.i ], [ %.378.sroa.0.1.i.i.i, %B0.endif.else.endif.i.i.i ]
  %.491.i.i.i = getelementptr double, ptr %80, i64 %.378.sroa.0.3.i.i.i
  %.541.i.i.i = add nsw i64 %.267.i.i.i, %.878.i.i
  %.578.i.i.i = icmp slt i64 %.541.i.i.i, 0
  %.579.i.i.i = select i1 %.578.i.i.i, i64 %.909.i.i, i64 0
  %.580.i.i.i = add i64 %.579.i.i.i, %.541.i.i.i
  %.583.i.i.i = icmp slt i64 %.580.i.i.i, 0
  br i1 %.583.i.i.i, label %B0.endif.endif.else.if.i.i.i, label %B0.endif.endif.else.endif.i.i.i, !prof !10

B0.endif.endif.else.if.i.i.i:                     ; preds = %B0.endif.else.endif.endif.endif.endif.i.i.i
  br label %B0.endif.endif.else.endif.i.i.i

B0.endif.endif.else.endif.i.i.i:                  ; preds = %B0.endif.endif.else.if.i.i.i, %B0.endif.else.endif.endif.endif.endif.i.i.i
  %.568.sroa.0.1.i.i.i = phi i64 [ 0, %B0.endif.endif.else.if.i.i.i ], [ %.580.i.i.i, %B0.endif.else.endif.endif.endif.endif.i.i.i ]
  %.588.not.i.i.i = icmp slt i64 %.580.i.i.i, %.909.i.i
  br i1 %.588.not.i.i.i, label %B0.endif.endif.else.endif.endif.endif.endif.i.i.i, label %B0.endif.endif.else.endif.if.i.i.i, !prof !6

B0.endif.endif.else.endif.if.i.i.i:               ; preds = %B0.endif.endif.else.endif.i.i.i
  br label %B0.endif.endif.else.endif.endif.endif.endif.i.i.i

B0.endif.endif.else.endif.endif.endif.endif.i.i.i: ; preds = %B0.endif.endif.else.endif.if.i.i.i, %B0.endif.endif.else.endif.i.i.i
  %.568.sroa.0.3.i.i.i = phi i64 [ %.909.i.i, %B0.endif.endif.else.endif.if.i.i.i ], [ %.568.sroa.0.1.i.i.i, %B0.endif.endif.else.endif.i.i.i ]
  %.681.i.i.i = getelementptr double, ptr %80, i64 %.568.sroa.0.3.i.i.i
  %.713.i.i.i = sub i64 %.541.i.i.i, %.544.1.i.i
  %.751.i.i.i = icmp slt i64 %.713.i.i.i, 0
  %.752.i.i.i = select i1 %.751.i.i.i, i64 %.909.i.i, i64 0
  %.753.i.i.i = add i64 %.752.i.i.i, %.713.i.i.i
  %.756.i.i.i = icmp slt i64 %.753.i.i.i, 0
  br i1 %.756.i.i.i, label %B0.endif.endif.endif.else.if.i.i.i, label %B0.endif.endif.endif.else.endif.i.i.i, !prof !10

B0.endif.endif.endif.else.if.i.i.i:               ; preds = %B0.endif.endif.else.endif.endif.endif.endif.i.i.i
  br label %B0.endif.endif.endif.else.endif.i.i.i

B0.endif.endif.endif.else.endif.i.i.i:            ; preds = %B0.endif.endif.endif.else.if.i.i.i, %B0.endif.endif.else.endif.endif.endif.endif.i.i.i
  %.741.sroa.0.1.i.i.i = phi i64 [ 0, %B0.endif.endif.endif.else.if.i.i.i ], [ %.753.i.i.i, %B0.endif.endif.else.endif.endif.endif.endif.i.i.i ]
  %.761.not.i.i.i = icmp slt i64 %.753.i.i.i, %.909.i.i
  br i1 %.761.not.i.i.i, label %B0.endif.endif.endif.else.endif.endif.endif.endif.i.i.i, label %B0.endif.endif.endif.else.endif.if.i.i.i, !prof !6

B0.endif.endif.endif.else.endif.if.i.i.i:         ; preds = %B0.endif.endif.endif.else.endif.i.i.i
  br label %B0.endif.endif.endif.else.endif.endif.endif.endif.i.i.i

B0.endif.endif.endif.else.endif.endif.endif.endif.i.i.i: ; preds = %B0.endif.endif.endif.else.endif.if.i.i.i, %B0.endif.endif.endif.else.endif.i.i.i
  %.741.sroa.0.3.i.i.i = phi i64 [ %.909.i.i, %B0.endif.endif.endif.else.endif.if.i.i.i ], [ %.741.sroa.0.1.i.i.i, %B0.endif.endif.endif.else.endif.i.i.i ]
  %.854.i.i.i = getelementptr double, ptr %80, i64 %.741.sroa.0.3.i.i.i
  %.904.i.i.i = add nsw i64 %.541.i.i.i, %.878.i.i
  %.941.i.i.i = icmp slt i64 %.904.i.i.i, 0
  %.942.i.i.i = select i1 %.941.i.i.i, i64 %.909.i.i, i64 0
  %.943.i.i.i = add i64 %.942.i.i.i, %.904.i.i.i
  %.946.i.i.i = icmp slt i64 %.943.i.i.i, 0
  br i1 %.946.i.i.i, label %B0.endif.endif.endif.endif.else.if.i.i.i, label %B0.endif.endif.endif.endif.else.endif.i.i.i, !prof !10

B0.endif.endif.endif.endif.else.if.i.i.i:         ; preds = %B0.endif.endif.endif.else.endif.endif.endif.endif.i.i.i
  br label %B0.endif.endif.endif.endif.else.endif.i.i.i

B0.endif.endif.endif.endif.else.endif.i.i.i:      ; preds = %B0.endif.endif.endif.endif.else.if.i.i.i, %B0.endif.endif.endif.else.endif.endif.endif.endif.i.i.i
  %.931.sroa.0.1.i.i.i = phi i64 [ 0, %B0.endif.endif.endif.endif.else.if.i.i.i ], [ %.943.i.i.i, %B0.endif.endif.endif.else.endif.endif.endif.endif.i.i.i ]
  %.951.not.i.i.i = icmp slt i64 %.943.i.i.i, %.909.i.i
  br i1 %.951.not.i.i.i, label %B0.endif.endif.endif.endif.else.endif.endif.endif.endif.i.i.i, label %B0.endif.endif.endif.endif.else.endif.if.i.i.i, !prof !6

B0.endif.endif.endif.endif.else.endif.if.i.i.i:   ; preds = %B0.endif.endif.endif.endif.else.endif.i.i.i
  br label %B0.endif.endif.endif.endif.else.endif.endif.endif.endif.i.i.i

B0.endif.endif.endif.endif.else.endif.endif.endif.endif.i.i.i: ; preds = %B0.endif.endif.endif.endif.else.endif.if.i.i.i, %B0.endif.endif.endif.endif.else.endif.i.i.i
  %.931.sroa.0.3.i.i.i = phi i64 [ %.909.i.i, %B0.endif.endif.endif.endif.else.endif.if.i.i.i ], [ %.931.sroa.0.1.i.i.i, %B0.endif.endif.endif.endif.else.endif.i.i.i ]
  %.1044.i.i.i = getelementptr double, ptr %80, i64 %.931.sroa.0.3.i.i.i
  %.1076.i.i.i = sub i64 %.904.i.i.i, %.544.1.i.i
  %.1114.i.i.i = icmp slt i64 %.1076.i.i.i, 0
  %.1115.i.i.i = select i1 %.1114.i.i.i, i64 %.909.i.i, i64 0
  %.1116.i.i.i = add i64 %.1115.i.i.i, %.1076.i.i.i
  %.1119.i.i.i = icmp slt i64 %.1116.i.i.i, 0
  br i1 %.1119.i.i.i, label %B0.endif.endif.endif.endif.endif.else.if.i.i.i, label %B0.endif.endif.endif.endif.endif.else.endif.i.i.i, !prof !10

B0.endif.endif.endif.endif.endif.else.if.i.i.i:   ; preds = %B0.endif.endif.endif.endif.else.endif.endif.endif.endif.i.i.i
  br label %B0.endif.endif.endif.endif.endif.else.endif.i.i.i

B0.endif.endif.endif.endif.endif.else.endif.i.i.i: ; preds = %B0.endif.endif.endif.endif.endif.else.if.i.i.i, %B0.endif.endif.endif.endif.else.endif.endif.endif.endif.i.i.i
  %.1104.sroa.0.1.i.i.i = phi i64 [ 0, %B0.endif.endif.endif.endif.endif.else.if.i.i.i ], [ %.1116.i.i.i, %B0.endif.endif.endif.endif.else.endif.endif.endif.endif.i.i.i ]
  %.1124.not.i.i.i = icmp slt i64 %.1116.i.i.i, %.909.i.i
  br i1 %.1124.not.i.i.i, label %B0.endif.endif.endif.endi...endif.i.i.i, label %B0.endif.endif.endif.endif.endif.else.endif.if.i.i.i, !prof !6

B0.endif.endif.endif.endif.endif.else.endif.if.i.i.i: ; preds = %B0.endif.endif.endif.endif.endif.else.endif.i.i.i
  br label %B0.endif.endif.endif.endi...endif.i.i.i

B0.endif.endif.endif.endi...endif.i.i.i:          ; preds = %B0.endif.endif.endif.endif.endif.else.endif.if.i.i.i, %B0.endif.endif.endif.endif.endif.else.endif.i.i.i
  %.1104.sroa.0.3.i.i.i = phi i64 [ %.909.i.i, %B0.endif.endif.endif.endif.endif.else.endif.if.i.i.i ], [ %.1104.sroa.0.1.i.i.i, %B0.endif.endif.endif.endif.endif.else.endif.i.i.i ]
  %.1217.i.i.i = getelementptr double, ptr %80, i64 %.1104.sroa.0.3.i.i.i
  %.1267.i.i.i = add nsw i64 %.904.i.i.i, %.878.i.i
  %.1304.i.i.i = icmp slt i64 %.1267.i.i.i, 0
  %.1305.i.i.i = select i1 %.1304.i.i.i, i64 %.909.i.i, i64 0
  %.1306.i.i.i = add i64 %.1305.i.i.i, %.1267.i.i.i
  %.1309.i.i.i = icmp slt i64 %.1306.i.i.i, 0
  br i1 %.1309.i.i.i, label %B0.endif.endif.endif.endif.endif.endif.else.if.i.i.i, label %B0.endif.endif.endif.endif.endif.endif.else.endif.i.i.i, !prof !10

B0.endif.endif.endif.endif.endif.endif.else.if.i.i.i: ; preds = %B0.endif.endif.endif.endi...endif.i.i.i
  br label %B0.endif.endif.endif.endif.endif.endif.else.endif.i.i.i

B0.endif.endif.endif.endif.endif.endif.else.endif.i.i.i: ; preds = %B0.endif.endif.endif.endif.endif.endif.else.if.i.i.i, %B0.endif.endif.endif.endi...endif.i.i.i
  %.1294.sroa.0.1.i.i.i = phi i64 [ 0, %B0.endif.endif.endif.endif.endif.endif.else.if.i.i.i ], [ %.1306.i.i.i, %B0.endif.endif.endif.endi...endif.i.i.i ]
  %.1314.not.i.i.i = icmp slt i64 %.1306.i.i.i, %.909.i.i
  br i1 %.1314.not.i.i.i, label %B0.endif.endif.endif.endi...endif.2.endif.i.i.i, label %B0.endif.endif.endif.endif.endif.endif.else.endif.if.i.i.i, !prof !6

B0.endif.endif.endif.endif.endif.endif.else.endif.if.i.i.i: ; preds = %B0.endif.endif.endif.endif.endif.endif.else.endif.i.i.i
  br label %B0.endif.endif.endif.endi...endif.2.endif.i.i.i

B0.endif.endif.endif.endi...endif.2.endif.i.i.i:  ; preds = %B0.endif.endif.endif.endif.endif.endif.else.endif.if.i.i.i, %B0.endif.endif.endif.endif.endif.endif.else.endif.i.i.i
  %.1294.sroa.0.3.i.i.i = phi i64 [ %.909.i.i, %B0.endif.endif.endif.endif.endif.endif.else.endif.if.i.i.i ], [ %.1294.sroa.0.1.i.i.i, %B0.endif.endif.endif.endif.endif.endif.else.endif.i.i.i ]
  %.1407.i.i.i = getelementptr double, ptr %80, i64 %.1294.sroa.0.3.i.i.i
  %.1439.i.i.i = sub i64 %.1267.i.i.i, %.544.1.i.i
  %.1477.i.i.i = icmp slt i64 %.1439.i.i.i, 0
  %.1478.i.i.i = select i1 %.1477.i.i.i, i64 %.909.i.i, i64 0
  %.1479.i.i.i = add i64 %.1478.i.i.i, %.1439.i.i.i
  %.1482.i.i.i = icmp slt i64 %.1479.i.i.i, 0
  br i1 %.1482.i.i.i, label %B0.endif.endif.endif.endif.endif.endif.endif.else.if.i.i.i, label %B0.endif.endif.endif.endif.endif.endif.endif.else.endif.i.i.i, !prof !10

B0.endif.endif.endif.endif.endif.endif.endif.else.if.i.i.i: ; preds = %B0.endif.endif.endif.endi...endif.2.endif.i.i.i
  br label %B0.endif.endif.endif.endif.endif.endif.endif.else.endif.i.i.i

B0.endif.endif.endif.endif.endif.endif.endif.else.endif.i.i.i: ; preds = %B0.endif.endif.endif.endif.endif.endif.endif.else.if.i.i.i, %B0.endif.endif.endif.endi...endif.2.endif.i.i.i
  %.1467.sroa.0.1.i.i.i = phi i64 [ 0, %B0.endif.endif.endif.endif.endif.endif.endif.else.if.i.i.i ], [ %.1479.i.i.i, %B0.endif.endif.endif.endi...endif.2.endif.i.i.i ]
  %.1487.not.i.i.i = icmp slt i64 %.1479.i.i.i, %.909.i.i
  br i1 %.1487.not.i.i.i, label %B0.endif.endif.endif.endi...endif.4.endif.endif.i.i.i, label %B0.endif.endif.endif.endi...if.4.i.i.i, !prof !6

B0.endif.endif.endif.endi...if.4.i.i.i:           ; preds = %B0.endif.endif.endif.endif.endif.endif.endif.else.endif.i.i.i
  br label %B0.endif.endif.endif.endi...endif.4.endif.endif.i.i.i

B0.endif.endif.endif.endi...endif.4.endif.endif.i.i.i: ; preds = %B0.endif.endif.endif.endi...if.4.i.i.i, %B0.endif.endif.endif.endif.endif.endif.endif.else.endif.i.i.i
  %.1467.sroa.0.3.i.i.i = phi i64 [ %.909.i.i, %B0.endif.endif.endif.endi...if.4.i.i.i ], [ %.1467.sroa.0.1.i.i.i, %B0.endif.endif.endif.endif.endif.endif.endif.else.endif.i.i.i ]
  %.1580.i.i.i = getelementptr double, ptr %80, i64 %.1467.sroa.0.3.i.i.i
  %.1630.i.i.i = add nsw i64 %.1267.i.i.i, %.878.i.i
  %.1667.i.i.i = icmp slt i64 %.1630.i.i.i, 0
  %.1668.i.i.i = select i1 %.1667.i.i.i, i64 %.909.i.i, i64 0
  %.1669.i.i.i = add i64 %.1668.i.i.i, %.1630.i.i.i
  %.1672.i.i.i = icmp slt i64 %.1669.i.i.i, 0
  br i1 %.1672.i.i.i, label %B0.endif.endif.endif.endi...if.6.i.i.i, label %B0.endif.endif.endif.endi...endif.6.i.i.i, !prof !10

B0.endif.endif.endif.endi...if.6.i.i.i:           ; preds = %B0.endif.endif.endif.endi...endif.4.endif.endif.i.i.i
  br label %B0.endif.endif.endif.endi...endif.6.i.i.i

B0.endif.endif.endif.endi...endif.6.i.i.i:        ; preds = %B0.endif.endif.endif.endi...if.6.i.i.i, %B0.endif.endif.endif.endi...endif.4.endif.endif.i.i.i
  %.1657.sroa.0.1.i.i.i = phi i64 [ 0, %B0.endif.endif.endif.endi...if.6.i.i.i ], [ %.1669.i.i.i, %B0.endif.endif.endif.endi...endif.4.endif.endif.i.i.i ]
  %.1677.not.i.i.i = icmp slt i64 %.1669.i.i.i, %.909.i.i
  br i1 %.1677.not.i.i.i, label %B0.endif.endif.endif.endi...endif.6.endif.endif.endif.i.i.i, label %B0.endif.endif.endif.endi...endif.6.if.i.i.i, !prof !6

B0.endif.endif.endif.endi...endif.6.if.i.i.i:     ; preds = %B0.endif.endif.endif.endi...endif.6.i.i.i
  br label %B0.endif.endif.endif.endi...endif.6.endif.endif.endif.i.i.i

B0.endif.endif.endif.endi...endif.6.endif.endif.endif.i.i.i: ; preds = %B0.endif.endif.endif.endi...endif.6.if.i.i.i, %B0.endif.endif.endif.endi...endif.6.i.i.i
  %.1657.sroa.0.3.i.i.i = phi i64 [ %.909.i.i, %B0.endif.endif.endif.endi...endif.6.if.i.i.i ], [ %.1657.sroa.0.1.i.i.i, %B0.endif.endif.endif.endi...endif.6.i.i.i ]
  %.1770.i.i.i = getelementptr double, ptr %80, i64 %.1657.sroa.0.3.i.i.i
  %.1802.i.i.i = sub i64 %.1630.i.i.i, %.544.1.i.i
  %.1840.i.i.i = icmp slt i64 %.1802.i.i.i, 0
  %.1841.i.i.i = select i1 %.1840.i.i.i, i64 %.909.i.i, i64 0
  %.1842.i.i.i = add i64 %.1841.i.i.i, %.1802.i.i.i
  %.1845.i.i.i = icmp slt i64 %.1842.i.i.i, 0
  br i1 %.1845.i.i.i, label %B0.endif.endif.endif.endi...else.if.i.i.i, label %B0.endif.endif.endif.endi...else.endif.i.i.i, !prof !10

B0.endif.endif.endif.endi...else.if.i.i.i:        ; preds = %B0.endif.endif.endif.endi...endif.6.endif.endif.endif.i.i.i
  br label %B0.endif.endif.endif.endi...else.endif.i.i.i

B0.endif.endif.endif.endi...else.endif.i.i.i:     ; preds = %B0.endif.endif.endif.endi...else.if.i.i.i, %B0.endif.endif.endif.endi...endif.6.endif.endif.endif.i.i.i
  %.1830.sroa.0.1.i.i.i = phi i64 [ 0, %B0.endif.endif.endif.endi...else.if.i.i.i ], [ %.1842.i.i.i, %B0.endif.endif.endif.endi...endif.6.endif.endif.endif.i.i.i ]
  %.1850.not.i.i.i = icmp slt i64 %.1842.i.i.i, %.909.i.i
  br i1 %.1850.not.i.i.i, label %B0.endif.endif.endif.endi...else.endif.endif.endif.endif.i.i.i, label %B0.endif.endif.endif.endi...else.endif.if.i.i.i, !prof !6

B0.endif.endif.endif.endi...else.endif.if.i.i.i:  ; preds = %B0.endif.endif.endif.endi...else.endif.i.i.i
  br label %B0.endif.endif.endif.endi...else.endif.endif.endif.endif.i.i.i

B0.endif.endif.endif.endi...else.endif.endif.endif.endif.i.i.i: ; preds = %B0.endif.endif.endif.endi...else.endif.if.i.i.i, %B0.endif.endif.endif.endi...else.endif.i.i.i
  %.1830.sroa.0.3.i.i.i = phi i64 [ %.909.i.i, %B0.endif.endif.endif.endi...else.endif.if.i.i.i ], [ %.1830.sroa.0.1.i.i.i, %B0.endif.endif.endif.endi...else.endif.i.i.i ]
  %.1943.i.i.i = getelementptr double, ptr %80, i64 %.1830.sroa.0.3.i.i.i
  %.1993.i.i.i = add nsw i64 %.1630.i.i.i, %.878.i.i
  %.2030.i.i.i = icmp slt i64 %.1993.i.i.i, 0
  %.2031.i.i.i = select i1 %.2030.i.i.i, i64 %.909.i.i, i64 0
  %.2032.i.i.i = add i64 %.2031.i.i.i, %.1993.i.i.i
  %.2035.i.i.i = icmp slt i64 %.2032.i.i.i, 0
  br i1 %.2035.i.i.i, label %B0.endif.endif.endif.endi...endif.8.else.if.i.i.i, label %B0.endif.endif.endif.endi...endif.8.else.endif.i.i.i, !prof !10

B0.endif.endif.endif.endi...endif.8.else.if.i.i.i: ; preds = %B0.endif.endif.endif.endi...else.endif.endif.endif.endif.i.i.i
  br label %B0.endif.endif.endif.endi...endif.8.else.endif.i.i.i

B0.endif.endif.endif.endi...endif.8.else.endif.i.i.i: ; preds = %B0.endif.endif.endif.endi...endif.8.else.if.i.i.i, %B0.endif.endif.endif.endi...else.endif.endif.endif.endif.i.i.i
  %.2020.sroa.0.1.i.i.i = phi i64 [ 0, %B0.endif.endif.endif.endi...endif.8.else.if.i.i.i ], [ %.2032.i.i.i, %B0.endif.endif.endif.endi...else.endif.endif.endif.endif.i.i.i ]
  %.2040.not.i.i.i = icmp slt i64 %.2032.i.i.i, %.909.i.i
  br i1 %.2040.not.i.i.i, label %B0.endif.endif.endif.endi...endif.9.endif.i.i.i, label %B0.endif.endif.endif.endi...endif.8.else.endif.if.i.i.i, !prof !6

B0.endif.endif.endif.endi...endif.8.else.endif.if.i.i.i: ; preds = %B0.endif.endif.endif.endi...endif.8.else.endif.i.i.i
  br label %B0.endif.endif.endif.endi...endif.9.endif.i.i.i

B0.endif.endif.endif.endi...endif.9.endif.i.i.i:  ; preds = %B0.endif.endif.endif.endi...endif.8.else.endif.if.i.i.i, %B0.endif.endif.endif.endi...endif.8.else.endif.i.i.i
  %.2020.sroa.0.3.i.i.i = phi i64 [ %.909.i.i, %B0.endif.endif.endif.endi...endif.8.else.endif.if.i.i.i ], [ %.2020.sroa.0.1.i.i.i, %B0.endif.endif.endif.endi...endif.8.else.endif.i.i.i ]
  %.2133.i.i.i = getelementptr double, ptr %80, i64 %.2020.sroa.0.3.i.i.i
  %.2165.i.i.i = sub i64 %.1993.i.i.i, %.544.1.i.i
  %.2203.i.i.i = icmp slt i64 %.2165.i.i.i, 0
  %.2204.i.i.i = select i1 %.2203.i.i.i, i64 %.909.i.i, i64 0
  %.2205.i.i.i = add i64 %.2204.i.i.i, %.2165.i.i.i
  %.2208.i.i.i = icmp slt i64 %.2205.i.i.i, 0
  br i1 %.2208.i.i.i, label %B0.endif.endif.endif.endi...endif.8.endif.else.if.i.i.i, label %B0.endif.endif.endif.endi...endif.8.endif.else.endif.i.i.i, !prof !10

B0.endif.endif.endif.endi...endif.8.endif.else.if.i.i.i: ; preds = %B0.endif.endif.endif.endi...endif.9.endif.i.i.i
  br label %B0.endif.endif.endif.endi...endif.8.endif.else.endif.i.i.i

B0.endif.endif.endif.endi...endif.8.endif.else.endif.i.i.i: ; preds = %B0.endif.endif.endif.endi...endif.8.endif.else.if.i.i.i, %B0.endif.endif.endif.endi...endif.9.endif.i.i.i
  %.2193.sroa.0.1.i.i.i = phi i64 [ 0, %B0.endif.endif.endif.endi...endif.8.endif.else.if.i.i.i ], [ %.2205.i.i.i, %B0.endif.endif.endif.endi...endif.9.endif.i.i.i ]
  %.2213.not.i.i.i = icmp slt i64 %.2205.i.i.i, %.909.i.i
  br i1 %.2213.not.i.i.i, label %B0.endif.endif.endif.endi...endif.11.endif.endif.i.i.i, label %B0.endif.endif.endif.endi...if.11.i.i.i, !prof !6

B0.endif.endif.endif.endi...if.11.i.i.i:          ; preds = %B0.endif.endif.endif.endi...endif.8.endif.else.endif.i.i.i
  br label %B0.endif.endif.endif.endi...endif.11.endif.endif.i.i.i

B0.endif.endif.endif.endi...endif.11.endif.endif.i.i.i: ; preds = %B0.endif.endif.endif.endi...if.11.i.i.i, %B0.endif.endif.endif.endi...endif.8.endif.else.endif.i.i.i
  %.2193.sroa.0.3.i.i.i = phi i64 [ %.909.i.i, %B0.endif.endif.endif.endi...if.11.i.i.i ], [ %.2193.sroa.0.1.i.i.i, %B0.endif.endif.endif.endi...endif.8.endif.else.endif.i.i.i ]
  %.2306.i.i.i = getelementptr double, ptr %80, i64 %.2193.sroa.0.3.i.i.i
  %.2360.i.i.i = fmul contract double %.3920.i.i, 0xC01921FB54442D18
  br i1 %57, label %B1762.i.i, label %B546.if.i.i.i

B546.if.i.i.i:                                    ; preds = %B0.endif.endif.endif.endi...endif.11.endif.endif.i.i.i, %B546.if.i.i.i
  %.2451885887.i.i.i = phi i64 [ %.2458.i.i.i, %B546.if.i.i.i ], [ 0, %B0.endif.endif.endif.endi...endif.11.endif.endif.i.i.i ]
  %.2458.i.i.i = add nuw nsw i64 %.2451885887.i.i.i, 1
  %19 = shl i64 %.2451885887.i.i.i, 3
  %scevgep16.i.i.i = getelementptr i8, ptr %.3435.i.i, i64 %19
  %.2513.i.i.i = load double, ptr %scevgep16.i.i.i, align 8, !noalias !14
  %.2515.i.i.i = fmul contract double %.2360.i.i.i, %.2513.i.i.i
  %.2516.i.i.i = tail call contract double @llvm.fma.f64(double %.2515.i.i.i, double 0x3FE45F306DC9C883, double 0x4338000000000000)
  %.2517.i.i.i = fadd contract double %.2516.i.i.i, 0xC338000000000000
  %.2532.i.i.i = tail call contract double @llvm.fma.f64(double %.2517.i.i.i, double 0xBFF921FB54442D18, double %.2515.i.i.i)
  %.2547.i.i.i = tail call contract double @llvm.fma.f64(double %.2517.i.i.i, double 0xBC91A62633145C07, double %.2532.i.i.i)
  %.2548.i.i.i = fmul contract double %.2547.i.i.i, %.2547.i.i.i
  %.2549.i.i.i = tail call contract double @llvm.fma.f64(double %.2548.i.i.i, double 0xBD6AE7F3E733B81F, double 0x3DE6124613A86D09)
  %.2550.i.i.i = tail call contract double @llvm.fma.f64(double %.2548.i.i.i, double %.2549.i.i.i, double 0xBE5AE64567F544E4)
  %.2551.i.i.i = tail call contract double @llvm.fma.f64(double %.2548.i.i.i, double %.2550.i.i.i, double 0x3EC71DE3A556C734)
  %.2552.i.i.i = tail call contract double @llvm.fma.f64(double %.2548.i.i.i, double %.2551.i.i.i, double 0xBF2A01A01A01A01A)
  %.2553.i.i.i = tail call contract double @llvm.fma.f64(double %.2548.i.i.i, double %.2552.i.i.i, double 0x3F81111111111111)
  %.2554.i.i.i = tail call contract double @llvm.fma.f64(double %.2548.i.i.i, double %.2553.i.i.i, double 0xBFC5555555555555)
  %.2555.i.i.i = fmul contract double %.2547.i.i.i, %.2548.i.i.i
  %.2556.i.i.i = tail call contract double @llvm.fma.f64(double %.2555.i.i.i, double %.2554.i.i.i, double %.2547.i.i.i)
  %.2557.i.i.i = tail call contract double @llvm.fma.f64(double %.2548.i.i.i, double 0x3D2AE7F3E733B81F, double 0xBDA93974A8C07C9D)
  %.2558.i.i.i = tail call contract double @llvm.fma.f64(double %.2548.i.i.i, double %.2557.i.i.i, double 0x3E21EED8EFF8D898)
  %.2559.i.i.i = tail call contract double @llvm.fma.f64(double %.2548.i.i.i, double %.2558.i.i.i, double 0xBE927E4FB7789F5C)
  %.2560.i.i.i = tail call contract double @llvm.fma.f64(double %.2548.i.i.i, double %.2559.i.i.i, double 0x3EFA01A01A01A01A)
  %.2561.i.i.i = tail call contract double @llvm.fma.f64(double %.2548.i.i.i, double %.2560.i.i.i, double 0xBF56C16C16C16C17)
  %.2562.i.i.i = tail call contract double @llvm.fma.f64(double %.2548.i.i.i, double %.2561.i.i.i, double 0x3FA5555555555555)
  %.2563.i.i.i = tail call contract double @llvm.fma.f64(double %.2548.i.i.i, double %.2562.i.i.i, double -5.000000e-01)
  %.2564.i.i.i = tail call contract double @llvm.fma.f64(double %.2548.i.i.i, double %.2563.i.i.i, double 1.000000e+00)
  %.2565.i.i.i = bitcast double %.2516.i.i.i to i64
  %.2566.i.i.i = bitcast double %.2556.i.i.i to i64
  %.2567.i.i.i = bitcast double %.2564.i.i.i to i64
  %.2568.i.i.i = xor i64 %.2567.i.i.i, %.2566.i.i.i
  %.2569.i.i.i = and i64 %.2565.i.i.i, 1
  %20 = icmp eq i64 %.2569.i.i.i, 0
  %.2571.i.i.i = select i1 %20, i64 0, i64 %.2568.i.i.i
  %.2572.i.i.i = shl i64 %.2565.i.i.i, 62
  %.2573.i.i.i = and i64 %.2572.i.i.i, -9223372036854775808
  %.2575.i.i.i = add i64 %.2572.i.i.i, 4611686018427387904
  %.2576.i.i.i = and i64 %.2575.i.i.i, -9223372036854775808
  %21 = xor i64 %.2573.i.i.i, %.2566.i.i.i
  %.2578.i.i.i = xor i64 %21, %.2571.i.i.i
  %.2579.i.i.i = bitcast i64 %.2578.i.i.i to double
  %22 = xor i64 %.2576.i.i.i, %.2567.i.i.i
  %.2581.i.i.i = xor i64 %22, %.2571.i.i.i
  %.2582.i.i.i = bitcast i64 %.2581.i.i.i to double
  %scevgep32.i.i.i = getelementptr i8, ptr %strain.2.sroa.32.2.i.i, i64 %19
  %.2632.i.i.i = load double, ptr %scevgep32.i.i.i, align 8, !noalias !14
  %.2633.i.i.i = fmul contract double %.2632.i.i.i, %.2582.i.i.i
  %scevgep31.i.i.i = getelementptr i8, ptr %strain.2.sroa.88.2.i.i, i64 %19
  %.2663.i.i.i = load double, ptr %scevgep31.i.i.i, align 8, !noalias !14
  %.2664.i.i.i = fmul contract double %.2663.i.i.i, %.2579.i.i.i
  %.2665.i.i.i = fsub contract double %.2633.i.i.i, %.2664.i.i.i
  %.2696.i.i.i = fmul contract double %.2632.i.i.i, %.2579.i.i.i
  %.2727.i.i.i = fmul contract double %.2663.i.i.i, %.2582.i.i.i
  %.2728.i.i.i = fadd contract double %.2696.i.i.i, %.2727.i.i.i
  %scevgep30.i.i.i = getelementptr i8, ptr %.318.i3.i.i, i64 %19
  %.2758.i.i.i = load double, ptr %scevgep30.i.i.i, align 8, !noalias !14
  %.2760.i.i.i = fmul contract double %.191.i.i.i, %.2758.i.i.i
  %scevgep29.i.i.i = getelementptr i8, ptr %.681.i.i.i, i64 %19
  %.2790.i.i.i = load double, ptr %scevgep29.i.i.i, align 8, !noalias !14
  %.2792.i.i.i = fmul contract double %.205.i.i.i, %.2790.i.i.i
  %.2793.i.i.i = fadd contract double %.2760.i.i.i, %.2792.i.i.i
  %scevgep28.i.i.i = getelementptr i8, ptr %.1044.i.i.i, i64 %19
  %.2823.i.i.i = load double, ptr %scevgep28.i.i.i, align 8, !noalias !14
  %.2825.i.i.i = fmul contract double %.217.i.i.i, %.2823.i.i.i
  %.2826.i.i.i = fadd contract double %.2793.i.i.i, %.2825.i.i.i
  %scevgep27.i.i.i = getelementptr i8, ptr %.1407.i.i.i, i64 %19
  %.2856.i.i.i = load double, ptr %scevgep27.i.i.i, align 8, !noalias !14
  %.2858.i.i.i = fmul contract double %.229.i.i.i, %.2856.i.i.i
  %.2859.i.i.i = fadd contract double %.2826.i.i.i, %.2858.i.i.i
  %scevgep26.i.i.i = getelementptr i8, ptr %.1770.i.i.i, i64 %19
  %.2889.i.i.i = load double, ptr %scevgep26.i.i.i, align 8, !noalias !14
  %.2891.i.i.i = fmul contract double %.243.i.i.i, %.2889.i.i.i
  %.2892.i.i.i = fadd contract double %.2859.i.i.i, %.2891.i.i.i
  %scevgep25.i.i.i = getelementptr i8, ptr %.2133.i.i.i, i64 %19
  %.2922.i.i.i = load double, ptr %scevgep25.i.i.i, align 8, !noalias !14
  %.2924.i.i.i = fmul contract double %.251.i.i.i, %.2922.i.i.i
  %.2925.i.i.i = fadd contract double %.2892.i.i.i, %.2924.i.i.i
  %scevgep24.i.i.i = getelementptr i8, ptr %.491.i.i.i, i64 %19
  %.2955.i.i.i = load double, ptr %scevgep24.i.i.i, align 8, !noalias !14
  %.2957.i.i.i = fmul contract double %.191.i.i.i, %.2955.i.i.i
  %scevgep23.i.i.i = getelementptr i8, ptr %.854.i.i.i, i64 %19
  %.2987.i.i.i = load double, ptr %scevgep23.i.i.i, align 8, !noalias !14
  %.2989.i.i.i = fmul contract double %.205.i.i.i, %.2987.i.i.i
  %.2990.i.i.i = fadd contract double %.2957.i.i.i, %.2989.i.i.i
  %scevgep22.i.i.i = getelementptr i8, ptr %.1217.i.i.i, i64 %19
  %.3020.i.i.i = load double, ptr %scevgep22.i.i.i, align 8, !noalias !14
  %.3022.i.i.i = fmul contract double %.217.i.i.i, %.3020.i.i.i
  %.3023.i.i.i = fadd contract double %.2990.i.i.i, %.3022.i.i.i
  %scevgep21.i.i.i = getelementptr i8, ptr %.1580.i.i.i, i64 %19
  %.3053.i.i.i = load double, ptr %scevgep21.i.i.i, align 8, !noalias !14
  %.3055.i.i.i = fmul contract double %.229.i.i.i, %.3053.i.i.i
  %.3056.i.i.i = fadd contract double %.3023.i.i.i, %.3055.i.i.i
  %scevgep20.i.i.i = getelementptr i8, ptr %.1943.i.i.i, i64 %19
  %.3086.i.i.i = load double, ptr %scevgep20.i.i.i, align 8, !noalias !14
  %.3088.i.i.i = fmul contract double %.243.i.i.i, %.3086.i.i.i
  %.3089.i.i.i = fadd contract double %.3056.i.i.i, %.3088.i.i.i
  %scevgep19.i.i.i = getelementptr i8, ptr %.2306.i.i.i, i64 %19
  %.3119.i.i.i = load double, ptr %scevgep19.i.i.i, align 8, !noalias !14
  %.3121.i.i.i = fmul contract double %.251.i.i.i, %.3119.i.i.i
  %.3122.i.i.i = fadd contract double %.3089.i.i.i, %.3121.i.i.i
  %.3123.i.i.i = fmul contract double %.2925.i.i.i, %.2665.i.i.i
  %.3124.i.i.i = fmul contract double %.3122.i.i.i, %.2728.i.i.i
  %.3125.i.i.i = fsub contract double %.3123.i.i.i, %.3124.i.i.i
  %scevgep18.i.i.i = getelementptr i8, ptr %.784.i, i64 %19
  store double %.3125.i.i.i, ptr %scevgep18.i.i.i, align 8, !noalias !14
  %.3156.i.i.i = fmul contract double %.2925.i.i.i, %.2728.i.i.i
  %.3157.i.i.i = fmul contract double %.3122.i.i.i, %.2665.i.i.i
  %.3158.i.i.i = fadd contract double %.3156.i.i.i, %.3157.i.i.i
  %scevgep17.i.i.i = getelementptr i8, ptr %.847.i, i64 %19
  store double %.3158.i.i.i, ptr %scevgep17.i.i.i, align 8, !noalias !14
  %exitcond.not.i6.i.i = icmp eq i64 %.13.i.i.i, %.2458.i.i.i
  br i1 %exitcond.not.i6.i.i, label %B1762.i.i, label %B546.if.i.i.i

B1762.i.i:                                        ; preds = %B546.if.i.i.i, %B78.if.i.i.i, %B0.endif.endif.endif.endi...endif.11.endif.endif.i.i.i, %B1672.i.i
  br i1 %64, label %_ZN17bnserve_inference6kernel5_sums8lane_sumB3v67B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE.exit533.i.i, label %B104.if.i.i.i

B104.if.i.i.i:                                    ; preds = %B1762.i.i, %B104.if.i.i.i
  %lsr.iv9.i.i.i = phi i64 [ %lsr.iv.next.i.i.i, %B104.if.i.i.i ], [ %.60.1.i.i.i, %B1762.i.i ]
  %lsr.iv.i.i.i = phi ptr [ %scevgep1.i.i.i, %B104.if.i.i.i ], [ %scevgep.i.i.i, %B1762.i.i ]
  %s7.2.0168.i.i.i = phi double [ %.489.i.i.i, %B104.if.i.i.i ], [ 0.000000e+00, %B1762.i.i ]
  %s6.2.0167.i.i.i = phi double [ %.454.i.i.i, %B104.if.i.i.i ], [ 0.000000e+00, %B1762.i.i ]
  %s5.2.0166.i.i.i = phi double [ %.419.i.i.i, %B104.if.i.i.i ], [ 0.000000e+00, %B1762.i.i ]
  %s4.2.0165.i.i.i = phi double [ %.384.i.i.i, %B104.if.i.i.i ], [ 0.000000e+00, %B1762.i.i ]
  %s3.2.0164.i.i.i = phi double [ %.349.i.i.i, %B104.if.i.i.i ], [ 0.000000e+00, %B1762.i.i ]
  %s2.2.0163.i.i.i = phi double [ %.314.i.i.i, %B104.if.i.i.i ], [ 0.000000e+00, %B1762.i.i ]
  %s1.2.0162.i.i.i = phi double [ %.279.i.i.i, %B104.if.i.i.i ], [ 0.000000e+00, %B1762.i.i ]
  %s0.2.0161.i.i.i = phi double [ %.244.i.i.i, %B104.if.i.i.i ], [ 0.000000e+00, %B1762.i.i ]
  %scevgep2.i.i.i = getelementptr i8, ptr %lsr.iv.i.i.i, i64 -56
  %.242.i.i.i = load double, ptr %scevgep2.i.i.i, align 8, !noalias !17
  %.244.i.i.i = fadd contract double %s0.2.0161.i.i.i, %.242.i.i.i
  %scevgep3.i.i.i = getelementptr i8, ptr %lsr.iv.i.i.i, i64 -48
  %.277.i.i.i = load double, ptr %scevgep3.i.i.i, align 8, !noalias !17
  %.279.i.i.i = fadd contract double %s1.2.0162.i.i.i, %.277.i.i.i
  %scevgep4.i.i.i = getelementptr i8, ptr %lsr.iv.i.i.i, i64 -40
  %.312.i.i.i = load double, ptr %scevgep4.i.i.i, align 8, !noalias !17
  %.314.i.i.i = fadd contract double %s2.2.0163.i.i.i, %.312.i.i.i
  %scevgep5.i.i.i = getelementptr i8, ptr %lsr.iv.i.i.i, i64 -32
  %.347.i.i.i = load double, ptr %scevgep5.i.i.i, align 8, !noalias !17
  %.349.i.i.i = fadd contract double %s3.2.0164.i.i.i, %.347.i.i.i
  %scevgep6.i.i.i = getelementptr i8, ptr %lsr.iv.i.i.i, i64 -24
  %.382.i.i.i = load double, ptr %scevgep6.i.i.i, align 8, !noalias !17
  %.384.i.i.i = fadd contract double %s4.2.0165.i.i.i, %.382.i.i.i
  %scevgep7.i.i.i = getelementptr i8, ptr %lsr.iv.i.i.i, i64 -16
  %.417.i.i.i = load double, ptr %scevgep7.i.i.i, align 8, !noalias !17
  %.419.i.i.i = fadd contract double %s5.2.0166.i.i.i, %.417.i.i.i
  %scevgep8.i.i.i = getelementptr i8, ptr %lsr.iv.i.i.i, i64 -8
  %.452.i.i.i = load double, ptr %scevgep8.i.i.i, align 8, !noalias !17
  %.454.i.i.i = fadd contract double %s6.2.0167.i.i.i, %.452.i.i.i
  %.487.i.i.i = load double, ptr %lsr.iv.i.i.i, align 8, !noalias !17
  %.489.i.i.i = fadd contract double %s7.2.0168.i.i.i, %.487.i.i.i
  %scevgep1.i.i.i = getelementptr i8, ptr %lsr.iv.i.i.i, i64 64
  %lsr.iv.next.i.i.i = add nsw i64 %lsr.iv9.i.i.i, -1
  %exitcond.not.i.i.i = icmp eq i64 %lsr.iv.next.i.i.i, 0
  br i1 %exitcond.not.i.i.i, label %B104.if.i494.i.i, label %B104.if.i.i.i

B1766.i.i:                                        ; preds = %_ZN17bnserve_inference6kernel5_sums8lane_sumB3v67B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE.exit533.i.i, %B1264.i.i
  %.4651.i.i = load i64, ptr %sunkaddr71.i.i, align 8, !noalias !7
  %.4652.not.i.i = icmp eq i64 %.4651.i.i, 0
  br i1 %.4652.not.i.i, label %B2247.i.i, label %B2039.i.i

B2039.i.i:                                        ; preds = %B1766.i.i
  %.4691.i.i = add nsw i64 %.4651.i.i, %.4690.i.i
  %.4749.i.i = icmp ne i64 %.2245.sroa.0.0248.i.i, 0
  %or.cond.i.i = or i1 %.145217.not.i.i.i, %.4749.i.i
  br i1 %or.cond.i.i, label %B2079.i.i, label %B2079.thread.i.i, !prof !20

B2079.i.i:                                        ; preds = %B2039.i.i
  br i1 %.145217.not.i.i.i, label %B2247.i.i, label %B62.if.preheader.i.i.i

B62.if.preheader.i.i.i:                           ; preds = %B2079.thread.i.i, %B2079.i.i
  %23 = inttoptr i64 %.4691.i.i to ptr
  %scevgep.i292.i.i = getelementptr i8, ptr %23, i64 8
  br label %B62.if.i.i.i

B62.if.i.i.i:                                     ; preds = %B62.if.i.i.i, %B62.if.preheader.i.i.i
  %lsr.iv.i293.i.i = phi ptr [ %scevgep.i292.i.i, %B62.if.preheader.i.i.i ], [ %scevgep1.i299.i.i, %B62.if.i.i.i ]
  %.190171173.i.i.i = phi i64 [ 0, %B62.if.preheader.i.i.i ], [ %.197.i294.i.i, %B62.if.i.i.i ]
  %.197.i294.i.i = add nuw nsw i64 %.190171173.i.i.i, 1
  %scevgep2.i295.i.i = getelementptr i8, ptr %lsr.iv.i293.i.i, i64 -8
  %.252.i.i.i = load double, ptr %scevgep2.i295.i.i, align 8, !noalias !21
  %24 = shl i64 %.190171173.i.i.i, 3
  %scevgep50.i.i = getelementptr i8, ptr %.784.i, i64 %24
  %.282.i.i.i = load double, ptr %scevgep50.i.i, align 8, !noalias !21
  %.284.i.i.i = fmul contract double %.3342.i.i, %.282.i.i.i
  %scevgep49.i.i = getelementptr i8, ptr %.847.i, i64 %24
  %.314.i298.i.i = load double, ptr %scevgep49.i.i, align 8, !noalias !21
  %.316.i.i.i = fmul contract double %.3375.i.i, %.314.i298.i.i
  %.317.i.i.i = fsub contract double %.284.i.i.i, %.316.i.i.i
  %.318.i.i.i = fadd contract double %.252.i.i.i, %.317.i.i.i
  store double %.318.i.i.i, ptr %scevgep2.i295.i.i, align 8, !noalias !21
  %.380.i.i.i = load double, ptr %lsr.iv.i293.i.i, align 8, !noalias !21
  %.410.i.i.i = load double, ptr %scevgep49.i.i, align 8, !noalias !21
  %.412.i.i.i = fmul contract double %.3342.i.i, %.410.i.i.i
  %.442.i.i.i = load double, ptr %scevgep50.i.i, align 8, !noalias !21
  %.444.i.i.i = fmul contract double %.3375.i.i, %.442.i.i.i
  %.445.i.i.i = fadd contract double %.412.i.i.i, %.444.i.i.i
  %.446.i.i.i = fadd contract double %.380.i.i.i, %.445.i.i.i
  store double %.446.i.i.i, ptr %lsr.iv.i293.i.i, align 8, !noalias !21
  %scevgep1.i299.i.i = getelementptr i8, ptr %lsr.iv.i293.i.i, i64 16
  %exitcond.not.i300.i.i = icmp eq i64 %.13.i316.i.i, %.197.i294.i.i
  br i1 %exitcond.not.i300.i.i, label %B2247.i.i, label %B62.if.i.i.i

B2247.i.i:                                        ; preds = %B62.if.i.i.i, %B2079.i.i, %B1766.i.i
  %.2255.i.i = icmp sgt i64 %.2202.1247.in.i.i, 1
  %.2268.i.i = zext i1 %.2255.i.i to i64
  %.2199.1.i.i = add i64 %.2199.1246.i.i, %.2268.i.i
  %25 = tail call i64 @llvm.smax.i64(i64 %.2202.1247.in.i.i, i64 2)
  %26 = add nsw i64 %25, -1
  %.2245.sroa.0.0.i.i = select i1 %.2255.i.i, i64 %.2199.1246.i.i, i64 0
  br i1 %.2255.i.i, label %B854.i.i, label %B2385.i.i

B2385.i.i:                                        ; preds = %B2247.i.i, %B590.endif.endif.endif.endif.endif.endif.endif.endif.i.i
  %.1395.i.i = icmp samesign ugt i64 %.1342.1253.in.i.i, 1
  %.1408.i.i = add i64 %.1339.1252.i.i, 512
  %.1339.1.i.i = select i1 %.1395.i.i, i64 %.1408.i.i, i64 %.1339.1252.i.i
  %27 = tail call i64 @llvm.smax.i64(i64 %.1342.1253.in.i.i, i64 2)
  %28 = add nsw i64 %27, -1
  %.1385.sroa.0.0.i.i = select i1 %.1395.i.i, i64 %.1339.1252.i.i, i64 0
  br i1 %.1395.i.i, label %B590.i.i, label %_ZN17bnserve_inference6kernel7_source16_contract_linearB3v26B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIxLi1E1C7mutable7alignedEd5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi1E1C7mutable7alignedE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi2EE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi2EE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi2EE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi2EEE.exit.i

.1268.endif.preheader.i.i:                        ; preds = %_ZN17bnserve_inference6kernel7_source9_geometryB3v22B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i
  %29 = inttoptr i64 %.959.i.i to ptr
  %.960.i.i = shl i64 %.527.i3.i, 4
  tail call void @llvm.memset.p0.i64(ptr align 8 %29, i8 0, i64 %.960.i.i, i1 false), !noalias !7
  br label %.1268.if.i.i

.1268.if.i.i:                                     ; preds = %.1268.endif.preheader.i.i, %_ZN17bnserve_inference6kernel7_source9_geometryB3v22B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i
  %.1353.i.i = icmp slt i64 %.578.i.i, 1
  br i1 %.1353.i.i, label %_ZN17bnserve_inference6kernel7_source16_contract_linearB3v26B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIxLi1E1C7mutable7alignedEd5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi1E1C7mutable7alignedE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi2EE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi2EE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi2EE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi2EEE.exit.i, label %.1269.endif.endif.i.i

.1269.endif.endif.i.i:                            ; preds = %.1268.if.i.i
  %.1368.i.i = and i64 %.578.i.i, 504
  %.1371.not.i.i = icmp ne i64 %.1368.i.i, 0
  %.13722198.i.i = lshr i64 %.578.i.i, 9
  %.1373.i.i = zext i1 %.1371.not.i.i to i64
  %.1374.i.i = add nuw nsw i64 %.13722198.i.i, %.1373.i.i
  %.2777.i.i = mul nsw i64 %.467.i1.i, %.155910791085.i
  %.3258.i.i = shl nsw i64 %.909.i.i, 3
  %.4687.i.i = mul nsw i64 %.497.i.i, %.155910791085.i
  %.1395249.not.i.i = icmp eq i64 %.1374.i.i, 0
  br i1 %.1395249.not.i.i, label %_ZN17bnserve_inference6kernel7_source16_contract_linearB3v26B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIxLi1E1C7mutable7alignedEd5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi1E1C7mutable7alignedE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi2EE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi2EE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi2EE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi2EEE.exit.i, label %B590.preheader.i.i

B590.preheader.i.i:                               ; preds = %.1269.endif.endif.i.i
  %30 = inttoptr i64 %.825.i.i to ptr
  %scevgep6.i371.i.i = getelementptr i8, ptr %30, i64 8
  %scevgep748.i.i = getelementptr i8, ptr %30, i64 24
  %31 = inttoptr i64 %.727.i.i to ptr
  %32 = icmp sgt i64 %.467.i1.i, 0
  %33 = inttoptr i64 %.645.i.i to ptr
  %34 = icmp sgt i64 %.608.i.i, 0
  %35 = inttoptr i64 %.959.i.i to ptr
  br label %B590.i.i

B590.endif.endif.endif.endif.endif.endif.else.if.i.i: ; preds = %B590.i.i
  br label %B590.endif.endif.endif.endif.endif.endif.else.endif.i.i

B590.endif.endif.endif.endif.endif.endif.else.endif.i.i: ; preds = %B590.endif.endif.endif.endif.endif.endif.else.if.i.i, %B590.i.i
  %.1977.sroa.0.1.i.i = phi i64 [ 0, %B590.endif.endif.endif.endif.endif.endif.else.if.i.i ], [ %.1989.i.i, %B590.i.i ]
  %.1997.not.i.i = icmp slt i64 %.1989.i.i, %.497.i.i
  br i1 %.1997.not.i.i, label %B590.endif.endif.endif.en...endif.i.i, label %B590.endif.endif.endif.en...if.i.i, !prof !6

B590.endif.endif.endif.en...if.i.i:               ; preds = %B590.endif.endif.endif.endif.endif.endif.else.endif.i.i
  br label %B590.endif.endif.endif.en...endif.i.i

B590.endif.endif.endif.en...endif.i.i:            ; preds = %B590.endif.endif.endif.en...if.i.i, %B590.endif.endif.endif.endif.endif.endif.else.endif.i.i
  %.1977.sroa.0.3.i.i = phi i64 [ %.497.i.i, %B590.endif.endif.endif.en...if.i.i ], [ %.1977.sroa.0.1.i.i, %B590.endif.endif.endif.endif.endif.endif.else.endif.i.i ]
  %.2090.i.i = getelementptr i64, ptr %31, i64 %.1977.sroa.0.3.i.i
  %.145217.not.i.i.i = icmp slt i64 %.13.i316.i.i, 1
  br i1 %.145217.not.i.i.i, label %B126.i.i.i, label %B34.if.i.i.i

B126.i.i.i:                                       ; preds = %B34.if.i.i.i, %B590.endif.endif.endif.en...endif.i.i
  %.431.i.i.i = sub i64 %.13.i.i.i, %.13.i316.i.i
  %.474223.not.i.i.i = icmp slt i64 %.431.i.i.i, 1
  br i1 %.474223.not.i.i.i, label %B590.endif.endif.endif.endif.endif.endif.endif.endif.i.i, label %B180.if.preheader.i.i.i

B180.if.preheader.i.i.i:                          ; preds = %B126.i.i.i
  %.neg.i.i.i = add nsw i64 %.13.i316.i.i, 1
  %xtraiter.i.i.i = and i64 %.431.i.i.i, 1
  %lcmp.mod.not.i.i.i = icmp eq i64 %xtraiter.i.i.i, 0
  br i1 %lcmp.mod.not.i.i.i, label %B180.if.prol.loopexit.i.i.i, label %B180.if.prol.i.i.i

B180.if.prol.i.i.i:                               ; preds = %B180.if.preheader.i.i.i
  %.483.prol.i.i.i = add nsw i64 %.431.i.i.i, -1
  %.525.prol.i.i.i = icmp slt i64 %.13.i316.i.i, 0
  %.526.prol.i.i.i = select i1 %.525.prol.i.i.i, i64 %.13.i.i.i, i64 0
  %36 = getelementptr double, ptr %.501.i, i64 %.13.i316.i.i
  %.540.prol.i.i.i = getelementptr double, ptr %36, i64 %.526.prol.i.i.i
  store double 0.000000e+00, ptr %.540.prol.i.i.i, align 8, !noalias !24
  %37 = getelementptr double, ptr %.563.i, i64 %.13.i316.i.i
  %.570.prol.i.i.i = getelementptr double, ptr %37, i64 %.526.prol.i.i.i
  store double 0.000000e+00, ptr %.570.prol.i.i.i, align 8, !noalias !24
  br label %B180.if.prol.loopexit.i.i.i

B180.if.prol.loopexit.i.i.i:                      ; preds = %B180.if.prol.i.i.i, %B180.if.preheader.i.i.i
  %.473221225.unr.i.i.i = phi i64 [ %.431.i.i.i, %B180.if.preheader.i.i.i ], [ %.483.prol.i.i.i, %B180.if.prol.i.i.i ]
  %.480222224.unr.i.i.i = phi i64 [ %.13.i316.i.i, %B180.if.preheader.i.i.i ], [ %.neg.i.i.i, %B180.if.prol.i.i.i ]
  %38 = icmp eq i64 %.13.i.i.i, %.neg.i.i.i
  br i1 %38, label %B590.endif.endif.endif.endif.endif.endif.endif.endif.i.i, label %B180.if.preheader1.i.i.i

B180.if.preheader1.i.i.i:                         ; preds = %B180.if.prol.loopexit.i.i.i
  %39 = add nuw i64 %.473221225.unr.i.i.i, 2
  %40 = shl i64 %.13.i.i.i, 3
  %41 = shl i64 %.480222224.unr.i.i.i, 3
  %scevgep731.i.i = getelementptr i8, ptr %.563.i, i64 %41
  %scevgep734.i.i = getelementptr i8, ptr %.501.i, i64 %41
  %42 = add i64 %40, 8
  br label %B180.if.i.i.i

B34.if.i.i.i:                                     ; preds = %B590.endif.endif.endif.en...endif.i.i, %B34.if.i.i.i
  %.151216218.i.i.i = phi i64 [ %.158.i.i.i, %B34.if.i.i.i ], [ 0, %B590.endif.endif.endif.en...endif.i.i ]
  %.158.i.i.i = add nuw nsw i64 %.151216218.i.i.i, 1
  %43 = shl nuw nsw i64 %.151216218.i.i.i, 3
  %scevgep3.i.i = getelementptr i8, ptr %.2090.i.i, i64 %43
  %.212.i337.i.i = load i64, ptr %scevgep3.i.i, align 8, !noalias !24
  %.227.i.i.i = icmp slt i64 %.212.i337.i.i, 0
  %.228.i.i.i = select i1 %.227.i.i.i, i64 %.1748.i, i64 0
  %.idx.i.i.i = shl i64 %.212.i337.i.i, 4
  %44 = getelementptr i8, ptr %.1749.i, i64 %.idx.i.i.i
  %.242.i338.i.i = getelementptr double, ptr %44, i64 %.228.i.i.i
  %.243.i339.i.i = load double, ptr %.242.i338.i.i, align 8, !noalias !24
  %scevgep2.i.i = getelementptr i8, ptr %.501.i, i64 %43
  store double %.243.i339.i.i, ptr %scevgep2.i.i, align 8, !noalias !24
  %.303.i.i.i = load i64, ptr %scevgep3.i.i, align 8, !noalias !24
  %.319.i.i.i = icmp slt i64 %.303.i.i.i, 0
  %.320.i.i.i = select i1 %.319.i.i.i, i64 %.1748.i, i64 0
  %.idx214.i.i.i = shl i64 %.303.i.i.i, 4
  %45 = getelementptr i8, ptr %.1749.i, i64 %.idx214.i.i.i
  %46 = getelementptr i8, ptr %45, i64 8
  %.334.i.i.i = getelementptr double, ptr %46, i64 %.320.i.i.i
  %.335.i.i.i = load double, ptr %.334.i.i.i, align 8, !noalias !24
  %scevgep1.i.i = getelementptr i8, ptr %.563.i, i64 %43
  store double %.335.i.i.i, ptr %scevgep1.i.i, align 8, !noalias !24
  %exitcond.not.i340.i.i = icmp eq i64 %.13.i316.i.i, %.158.i.i.i
  br i1 %exitcond.not.i340.i.i, label %B126.i.i.i, label %B34.if.i.i.i

B180.if.i.i.i:                                    ; preds = %B180.if.i.i.i, %B180.if.preheader1.i.i.i
  %lsr.iv735.i.i = phi ptr [ %scevgep736.i.i, %B180.if.i.i.i ], [ %scevgep734.i.i, %B180.if.preheader1.i.i.i ]
  %lsr.iv.i6.i = phi ptr [ %scevgep732.i.i, %B180.if.i.i.i ], [ %scevgep731.i.i, %B180.if.preheader1.i.i.i ]
  %lsr.iv.i341.i.i = phi i64 [ %lsr.iv.next.i350.i.i, %B180.if.i.i.i ], [ %39, %B180.if.preheader1.i.i.i ]
  %.480222224.i.i.i = phi i64 [ %50, %B180.if.i.i.i ], [ %.480222224.unr.i.i.i, %B180.if.preheader1.i.i.i ]
  %.525.i.i.i = icmp slt i64 %.480222224.i.i.i, 0
  %47 = select i1 %.525.i.i.i, i64 %40, i64 0
  %scevgep739.i.i = getelementptr i8, ptr %lsr.iv735.i.i, i64 %47
  store double 0.000000e+00, ptr %scevgep739.i.i, align 8, !noalias !24
  %scevgep738.i.i = getelementptr i8, ptr %lsr.iv.i6.i, i64 %47
  store double 0.000000e+00, ptr %scevgep738.i.i, align 8, !noalias !24
  %48 = add i64 %.480222224.i.i.i, 1
  %.525.1.i.i.i = icmp slt i64 %48, 0
  %49 = select i1 %.525.1.i.i.i, i64 %42, i64 8
  %scevgep.i.i = getelementptr i8, ptr %lsr.iv735.i.i, i64 %49
  store double 0.000000e+00, ptr %scevgep.i.i, align 8, !noalias !24
  %scevgep7.i.i = getelementptr i8, ptr %lsr.iv.i6.i, i64 %49
  store double 0.000000e+00, ptr %scevgep7.i.i, align 8, !noalias !24
  %lsr.iv.next.i350.i.i = add i64 %lsr.iv.i341.i.i, -2
  %scevgep732.i.i = getelementptr i8, ptr %lsr.iv.i6.i, i64 16
  %scevgep736.i.i = getelementptr i8, ptr %lsr.iv735.i.i, i64 16
  %.474.1.i.i.i = icmp sgt i64 %lsr.iv.next.i350.i.i, 2
  %50 = add i64 %.480222224.i.i.i, 2
  br i1 %.474.1.i.i.i, label %B180.if.i.i.i, label %B590.endif.endif.endif.endif.endif.endif.endif.endif.i.i

B590.endif.endif.endif.endif.endif.endif.endif.endif.i.i: ; preds = %B180.if.i.i.i, %B180.if.prol.loopexit.i.i.i, %B126.i.i.i
  %.3435.i.i = getelementptr double, ptr %33, i64 %.1385.sroa.0.0254.i.i
  %.3994.i.i = sub i64 %.1385.sroa.0.0254.i.i, %.544.1.i.i
  %.4689.i.i = add nsw i64 %.1385.sroa.0.0254.i.i, %.4687.i.i
  %.4690.i.i = shl nsw i64 %.4689.i.i, 4
  %.4693.i.i = shl i64 %.13.i316.i.i, 4
  br i1 %32, label %B854.preheader.i.i, label %B2385.i.i

B854.preheader.i.i:                               ; preds = %B590.endif.endif.endif.endif.endif.endif.endif.endif.i.i
  %51 = shl nuw nsw i64 %.13.i.i.i, 3
  %unroll_iter.i.i.i = and i64 %.13.i.i.i, 9223372036854775806
  %.60.1.i.i.i = ashr i64 %.13.i.i.i, 3
  %52 = add nsw i64 %unroll_iter.i.i.i, -2
  %53 = lshr exact i64 %52, 1
  %54 = add nuw i64 %53, 1
  %55 = and i64 %54, -2
  %56 = icmp sgt i64 %.1438.i.i, 0
  %57 = icmp slt i64 %.1438.i.i, 1
  %58 = icmp eq i64 %.1438.i.i, 1
  %59 = icmp eq i64 %52, 0
  %60 = and i64 %52, 2
  %61 = icmp eq i64 %60, 0
  %62 = and i64 %.13.i.i.i, 1
  %63 = icmp eq i64 %62, 0
  %64 = icmp slt i64 %.60.1.i.i.i, 1
  br label %B854.i.i

B60.if.preheader.i.i.i:                           ; preds = %B872.i.i
  tail call void @llvm.memset.p0.i64(ptr align 8 %.926.i, i8 0, i64 %51, i1 false), !noalias !27
  br label %B76.i.i.i

B76.i.i.i:                                        ; preds = %B60.if.preheader.i.i.i, %B872.i.i
  %.311284.not.i.i.i = icmp slt i64 %.2814.i.i, 1
  br i1 %.311284.not.i.i.i, label %B872.endif.endif.endif.endif.endif.endif.i.i, label %B128.if.i.preheader.i.i

B128.if.i.preheader.i.i:                          ; preds = %B76.i.i.i
  %65 = inttoptr i64 %.2850.i.i to ptr
  br label %B128.if.i.i.i

B284.loopexit.unr-lcssa.i.unr-lcssa.i.i:          ; preds = %B228.if.i.i.i
  br i1 %61, label %B228.if.i.epil.preheader.i.i, label %B284.loopexit.unr-lcssa.i.i.i

B228.if.i.epil.preheader.i.i:                     ; preds = %B228.if.preheader2.i.i.i, %B284.loopexit.unr-lcssa.i.unr-lcssa.i.i
  %.655272274.i.epil.init.i.i = phi i64 [ 0, %B228.if.preheader2.i.i.i ], [ %.662.1.i.1.i.i, %B284.loopexit.unr-lcssa.i.unr-lcssa.i.i ]
  %66 = shl i64 %.655272274.i.epil.init.i.i, 3
  %sunkaddr11.i.epil.i.i = getelementptr i8, ptr %.926.i, i64 %66
  %.716.i.epil.i.i = load double, ptr %sunkaddr11.i.epil.i.i, align 8, !noalias !27
  %scevgep9.i373.epil.i.i = getelementptr i8, ptr %scevgep7.i372.i.i, i64 %66
  %scevgep10.i374.epil.i.i = getelementptr i8, ptr %scevgep9.i373.epil.i.i, i64 -8
  %.746.i.epil.i.i = load double, ptr %scevgep10.i374.epil.i.i, align 8, !noalias !27
  %.748.i.epil.i.i = fmul contract double %.565.i.i.i, %.746.i.epil.i.i
  %.749.i.epil.i.i = fadd contract double %.716.i.epil.i.i, %.748.i.epil.i.i
  store double %.749.i.epil.i.i, ptr %sunkaddr11.i.epil.i.i, align 8, !noalias !27
  %.662.1.i.epil.i.i = add nuw i64 %.655272274.i.epil.init.i.i, 2
  %sunkaddr14.i.epil.i.i = getelementptr i8, ptr %sunkaddr11.i.epil.i.i, i64 8
  %.716.1.i.epil.i.i = load double, ptr %sunkaddr14.i.epil.i.i, align 8, !noalias !27
  %.746.1.i.epil.i.i = load double, ptr %scevgep9.i373.epil.i.i, align 8, !noalias !27
  %.748.1.i.epil.i.i = fmul contract double %.565.i.i.i, %.746.1.i.epil.i.i
  %.749.1.i.epil.i.i = fadd contract double %.716.1.i.epil.i.i, %.748.1.i.epil.i.i
  store double %.749.1.i.epil.i.i, ptr %sunkaddr14.i.epil.i.i, align 8, !noalias !27
  br label %B284.loopexit.unr-lcssa.i.i.i

B284.loopexit.unr-lcssa.i.i.i:                    ; preds = %B228.if.i.epil.preheader.i.i, %B284.loopexit.unr-lcssa.i.unr-lcssa.i.i
  %.662.1.i.lcssa.i.i = phi i64 [ %.662.1.i.epil.i.i, %B228.if.i.epil.preheader.i.i ], [ %.662.1.i.1.i.i, %B284.loopexit.unr-lcssa.i.unr-lcssa.i.i ]
  br i1 %63, label %B284.i.i.i, label %B228.if.epil.preheader.i.i.i

B228.if.epil.preheader.i.i.i:                     ; preds = %B228.if.preheader.i.i.i, %B284.loopexit.unr-lcssa.i.i.i
  %.655272274.epil.init.i.i.i = phi i64 [ 0, %B228.if.preheader.i.i.i ], [ %.662.1.i.lcssa.i.i, %B284.loopexit.unr-lcssa.i.i.i ]
  %67 = getelementptr double, ptr %.926.i, i64 %.655272274.epil.init.i.i.i
  %.716.epil.i.i.i = load double, ptr %67, align 8, !noalias !27
  %68 = getelementptr double, ptr %.498.i.i.i, i64 %.655272274.epil.init.i.i.i
  %.746.epil.i.i.i = load double, ptr %68, align 8, !noalias !27
  %.748.epil.i.i.i = fmul contract double %.565.i.i.i, %.746.epil.i.i.i
  %.749.epil.i.i.i = fadd contract double %.716.epil.i.i.i, %.748.epil.i.i.i
  store double %.749.epil.i.i.i, ptr %67, align 8, !noalias !27
  br label %B284.i.i.i

B284.i.i.i:                                       ; preds = %B130.else.endif.endif.endif.endif.i.i.i, %B228.if.epil.preheader.i.i.i, %B284.loopexit.unr-lcssa.i.i.i
  %exitcond292.not.i.i.i = icmp eq i64 %.324.i.i.i, %.2814.i.i
  br i1 %exitcond292.not.i.i.i, label %B872.endif.endif.endif.endif.endif.endif.i.i, label %B128.if.i.i.i

B128.if.i.i.i:                                    ; preds = %B284.i.i.i, %B128.if.i.preheader.i.i
  %.317279285.i.i.i = phi i64 [ %.324.i.i.i, %B284.i.i.i ], [ 0, %B128.if.i.preheader.i.i ]
  %.324.i.i.i = add nuw nsw i64 %.317279285.i.i.i, 1
  %.350.i.i.i = mul nuw nsw i64 %.317279285.i.i.i, %.578.i.i
  %.352.i.i.i = add nsw i64 %.350.i.i.i, %.1385.sroa.0.0254.i.i
  %.395.i.i.i = icmp slt i64 %.352.i.i.i, 0
  %.396.i.i.i = select i1 %.395.i.i.i, i64 %.828.i.i, i64 0
  %.397.i.i.i = add i64 %.396.i.i.i, %.352.i.i.i
  %.400.i.i.i = icmp slt i64 %.397.i.i.i, 0
  br i1 %.400.i.i.i, label %B130.else.if.i.i.i, label %B130.else.endif.i.i.i, !prof !10

B130.else.if.i.i.i:                               ; preds = %B128.if.i.i.i
  br label %B130.else.endif.i.i.i

B130.else.endif.i.i.i:                            ; preds = %B130.else.if.i.i.i, %B128.if.i.i.i
  %.385.sroa.0.1.i.i.i = phi i64 [ 0, %B130.else.if.i.i.i ], [ %.397.i.i.i, %B128.if.i.i.i ]
  %.405.not.i.i.i = icmp slt i64 %.397.i.i.i, %.828.i.i
  br i1 %.405.not.i.i.i, label %B130.else.endif.endif.endif.endif.i.i.i, label %B130.else.endif.if.i.i.i, !prof !6

B130.else.endif.if.i.i.i:                         ; preds = %B130.else.endif.i.i.i
  br label %B130.else.endif.endif.endif.endif.i.i.i

B130.else.endif.endif.endif.endif.i.i.i:          ; preds = %B130.else.endif.if.i.i.i, %B130.else.endif.i.i.i
  %.385.sroa.0.3.i.i.i = phi i64 [ %.828.i.i, %B130.else.endif.if.i.i.i ], [ %.385.sroa.0.1.i.i.i, %B130.else.endif.i.i.i ]
  %.498.i.i.i = getelementptr double, ptr %30, i64 %.385.sroa.0.3.i.i.i
  %69 = getelementptr double, ptr %65, i64 %.317279285.i.i.i
  %.565.i.i.i = load double, ptr %69, align 8, !noalias !27
  br i1 %57, label %B284.i.i.i, label %B228.if.preheader.i.i.i

B228.if.preheader.i.i.i:                          ; preds = %B130.else.endif.endif.endif.endif.i.i.i
  br i1 %58, label %B228.if.epil.preheader.i.i.i, label %B228.if.preheader2.i.i.i

B228.if.preheader2.i.i.i:                         ; preds = %B228.if.preheader.i.i.i
  %70 = shl i64 %.385.sroa.0.3.i.i.i, 3
  %scevgep7.i372.i.i = getelementptr i8, ptr %scevgep6.i371.i.i, i64 %70
  br i1 %59, label %B228.if.i.epil.preheader.i.i, label %B228.if.i.preheader.i.i

B228.if.i.preheader.i.i:                          ; preds = %B228.if.preheader2.i.i.i
  %scevgep749.i.i = getelementptr i8, ptr %scevgep748.i.i, i64 %70
  br label %B228.if.i.i.i

B228.if.i.i.i:                                    ; preds = %B228.if.i.i.i, %B228.if.i.preheader.i.i
  %lsr.iv4.i.i = phi i64 [ %lsr.iv.next5.i.i, %B228.if.i.i.i ], [ %55, %B228.if.i.preheader.i.i ]
  %.655272274.i.i.i = phi i64 [ %.662.1.i.1.i.i, %B228.if.i.i.i ], [ 0, %B228.if.i.preheader.i.i ]
  %71 = shl i64 %.655272274.i.i.i, 3
  %sunkaddr73.i.i = getelementptr i8, ptr %.926.i, i64 %71
  %.716.i.i.i = load double, ptr %sunkaddr73.i.i, align 8, !noalias !27
  %scevgep752.i.i = getelementptr i8, ptr %scevgep749.i.i, i64 %71
  %scevgep22.i.i = getelementptr i8, ptr %scevgep752.i.i, i64 -16
  %scevgep18.i.i = getelementptr i8, ptr %scevgep752.i.i, i64 -24
  %.746.i.i.i = load double, ptr %scevgep18.i.i, align 8, !noalias !27
  %.748.i.i.i = fmul contract double %.565.i.i.i, %.746.i.i.i
  %.749.i.i.i = fadd contract double %.716.i.i.i, %.748.i.i.i
  store double %.749.i.i.i, ptr %sunkaddr73.i.i, align 8, !noalias !27
  %sunkaddr76.i.i = getelementptr i8, ptr %sunkaddr73.i.i, i64 8
  %.716.1.i.i.i = load double, ptr %sunkaddr76.i.i, align 8, !noalias !27
  %.746.1.i.i.i = load double, ptr %scevgep22.i.i, align 8, !noalias !27
  %.748.1.i.i.i = fmul contract double %.565.i.i.i, %.746.1.i.i.i
  %.749.1.i.i.i = fadd contract double %.716.1.i.i.i, %.748.1.i.i.i
  store double %.749.1.i.i.i, ptr %sunkaddr76.i.i, align 8, !noalias !27
  %sunkaddr79.i.i = getelementptr i8, ptr %sunkaddr73.i.i, i64 16
  %.716.i.1.i.i = load double, ptr %sunkaddr79.i.i, align 8, !noalias !27
  %scevgep16.i.i = getelementptr i8, ptr %scevgep752.i.i, i64 -8
  %.746.i.1.i.i = load double, ptr %scevgep16.i.i, align 8, !noalias !27
  %.748.i.1.i.i = fmul contract double %.565.i.i.i, %.746.i.1.i.i
  %.749.i.1.i.i = fadd contract double %.716.i.1.i.i, %.748.i.1.i.i
  store double %.749.i.1.i.i, ptr %sunkaddr79.i.i, align 8, !noalias !27
  %.662.1.i.1.i.i = add i64 %.655272274.i.i.i, 4
  %sunkaddr80.i.i = shl i64 %.662.1.i.1.i.i, 3
  %sunkaddr81.i.i = getelementptr i8, ptr %.926.i, i64 %sunkaddr80.i.i
  %sunkaddr83.i.i = getelementptr i8, ptr %sunkaddr81.i.i, i64 -8
  %.716.1.i.1.i.i = load double, ptr %sunkaddr83.i.i, align 8, !noalias !27
  %.746.1.i.1.i.i = load double, ptr %scevgep752.i.i, align 8, !noalias !27
  %.748.1.i.1.i.i = fmul contract double %.565.i.i.i, %.746.1.i.1.i.i
  %.749.1.i.1.i.i = fadd contract double %.716.1.i.1.i.i, %.748.1.i.1.i.i
  store double %.749.1.i.1.i.i, ptr %sunkaddr83.i.i, align 8, !noalias !27
  %lsr.iv.next5.i.i = add i64 %lsr.iv4.i.i, -2
  %niter.ncmp.1.i.i = icmp eq i64 %lsr.iv.next5.i.i, 0
  br i1 %niter.ncmp.1.i.i, label %B284.loopexit.unr-lcssa.i.unr-lcssa.i.i, label %B228.if.i.i.i

B872.endif.endif.endif.endif.endif.endif.i.i:     ; preds = %B284.i.i.i, %B76.i.i.i
  %.2988.i.i = load i64, ptr %.607.i.i, align 8, !noalias !7
  %.3018.i.i = load i64, ptr %sunkaddr86.i.i, align 8, !noalias !7
  %.3023.i.i = mul i64 %.2988.i.i, %.2848.i.i
  %.3024.i.i = add nsw i64 %.3023.i.i, %.3018.i.i
  br i1 %56, label %B60.if.preheader.i432.i.i, label %B76.i381.i.i

B60.if.preheader.i432.i.i:                        ; preds = %B872.endif.endif.endif.endif.endif.endif.i.i
  tail call void @llvm.memset.p0.i64(ptr align 8 %.992.i, i8 0, i64 %51, i1 false), !noalias !30
  br label %B76.i381.i.i

B76.i381.i.i:                                     ; preds = %B60.if.preheader.i432.i.i, %B872.endif.endif.endif.endif.endif.endif.i.i
  %.311284.not.i382.i.i = icmp slt i64 %.2988.i.i, 1
  br i1 %.311284.not.i382.i.i, label %B872.endif.endif.endif.endif.endif.endif.endif.endif.i.i, label %B128.if.i386.preheader.i.i

B128.if.i386.preheader.i.i:                       ; preds = %B76.i381.i.i
  %72 = inttoptr i64 %.3024.i.i to ptr
  br label %B128.if.i386.i.i

B284.loopexit.unr-lcssa.i422.unr-lcssa.i.i:       ; preds = %B228.if.i406.i.i
  br i1 %61, label %B228.if.i406.epil.preheader.i.i, label %B284.loopexit.unr-lcssa.i422.i.i

B228.if.i406.epil.preheader.i.i:                  ; preds = %B228.if.preheader2.i404.i.i, %B284.loopexit.unr-lcssa.i422.unr-lcssa.i.i
  %.655272274.i407.epil.init.i.i = phi i64 [ 0, %B228.if.preheader2.i404.i.i ], [ %.662.1.i415.1.i.i, %B284.loopexit.unr-lcssa.i422.unr-lcssa.i.i ]
  %73 = shl i64 %.655272274.i407.epil.init.i.i, 3
  %sunkaddr11.i408.epil.i.i = getelementptr i8, ptr %.992.i, i64 %73
  %.716.i409.epil.i.i = load double, ptr %sunkaddr11.i408.epil.i.i, align 8, !noalias !30
  %scevgep9.i410.epil.i.i = getelementptr i8, ptr %scevgep7.i405.i.i, i64 %73
  %scevgep10.i411.epil.i.i = getelementptr i8, ptr %scevgep9.i410.epil.i.i, i64 -8
  %.746.i412.epil.i.i = load double, ptr %scevgep10.i411.epil.i.i, align 8, !noalias !30
  %.748.i413.epil.i.i = fmul contract double %.565.i402.i.i, %.746.i412.epil.i.i
  %.749.i414.epil.i.i = fadd contract double %.716.i409.epil.i.i, %.748.i413.epil.i.i
  store double %.749.i414.epil.i.i, ptr %sunkaddr11.i408.epil.i.i, align 8, !noalias !30
  %.662.1.i415.epil.i.i = add nuw i64 %.655272274.i407.epil.init.i.i, 2
  %sunkaddr14.i416.epil.i.i = getelementptr i8, ptr %sunkaddr11.i408.epil.i.i, i64 8
  %.716.1.i417.epil.i.i = load double, ptr %sunkaddr14.i416.epil.i.i, align 8, !noalias !30
  %.746.1.i418.epil.i.i = load double, ptr %scevgep9.i410.epil.i.i, align 8, !noalias !30
  %.748.1.i419.epil.i.i = fmul contract double %.565.i402.i.i, %.746.1.i418.epil.i.i
  %.749.1.i420.epil.i.i = fadd contract double %.716.1.i417.epil.i.i, %.748.1.i419.epil.i.i
  store double %.749.1.i420.epil.i.i, ptr %sunkaddr14.i416.epil.i.i, align 8, !noalias !30
  br label %B284.loopexit.unr-lcssa.i422.i.i

B284.loopexit.unr-lcssa.i422.i.i:                 ; preds = %B228.if.i406.epil.preheader.i.i, %B284.loopexit.unr-lcssa.i422.unr-lcssa.i.i
  %.662.1.i415.lcssa.i.i = phi i64 [ %.662.1.i415.epil.i.i, %B228.if.i406.epil.preheader.i.i ], [ %.662.1.i415.1.i.i, %B284.loopexit.unr-lcssa.i422.unr-lcssa.i.i ]
  br i1 %63, label %B284.i429.i.i, label %B228.if.epil.preheader.i423.i.i

B228.if.epil.preheader.i423.i.i:                  ; preds = %B228.if.preheader.i403.i.i, %B284.loopexit.unr-lcssa.i422.i.i
  %.655272274.epil.init.i424.i.i = phi i64 [ 0, %B228.if.preheader.i403.i.i ], [ %.662.1.i415.lcssa.i.i, %B284.loopexit.unr-lcssa.i422.i.i ]
  %74 = getelementptr double, ptr %.992.i, i64 %.655272274.epil.init.i424.i.i
  %.716.epil.i425.i.i = load double, ptr %74, align 8, !noalias !30
  %75 = getelementptr double, ptr %.498.i401.i.i, i64 %.655272274.epil.init.i424.i.i
  %.746.epil.i426.i.i = load double, ptr %75, align 8, !noalias !30
  %.748.epil.i427.i.i = fmul contract double %.565.i402.i.i, %.746.epil.i426.i.i
  %.749.epil.i428.i.i = fadd contract double %.716.epil.i425.i.i, %.748.epil.i427.i.i
  store double %.749.epil.i428.i.i, ptr %74, align 8, !noalias !30
  br label %B284.i429.i.i

B284.i429.i.i:                                    ; preds = %B130.else.endif.endif.endif.endif.i399.i.i, %B228.if.epil.preheader.i423.i.i, %B284.loopexit.unr-lcssa.i422.i.i
  %exitcond292.not.i430.i.i = icmp eq i64 %.324.i388.i.i, %.2988.i.i
  br i1 %exitcond292.not.i430.i.i, label %B872.endif.endif.endif.endif.endif.endif.endif.endif.i.i, label %B128.if.i386.i.i

B128.if.i386.i.i:                                 ; preds = %B284.i429.i.i, %B128.if.i386.preheader.i.i
  %.317279285.i387.i.i = phi i64 [ %.324.i388.i.i, %B284.i429.i.i ], [ 0, %B128.if.i386.preheader.i.i ]
  %.324.i388.i.i = add nuw nsw i64 %.317279285.i387.i.i, 1
  %.350.i389.i.i = mul nuw nsw i64 %.317279285.i387.i.i, %.578.i.i
  %.352.i390.i.i = add nsw i64 %.350.i389.i.i, %.1385.sroa.0.0254.i.i
  %.395.i391.i.i = icmp slt i64 %.352.i390.i.i, 0
  %.396.i392.i.i = select i1 %.395.i391.i.i, i64 %.828.i.i, i64 0
  %.397.i393.i.i = add i64 %.396.i392.i.i, %.352.i390.i.i
  %.400.i394.i.i = icmp slt i64 %.397.i393.i.i, 0
  br i1 %.400.i394.i.i, label %B130.else.if.i431.i.i, label %B130.else.endif.i395.i.i, !prof !10

B130.else.if.i431.i.i:                            ; preds = %B128.if.i386.i.i
  br label %B130.else.endif.i395.i.i

B130.else.endif.i395.i.i:                         ; preds = %B130.else.if.i431.i.i, %B128.if.i386.i.i
  %.385.sroa.0.1.i396.i.i = phi i64 [ 0, %B130.else.if.i431.i.i ], [ %.397.i393.i.i, %B128.if.i386.i.i ]
  %.405.not.i397.i.i = icmp slt i64 %.397.i393.i.i, %.828.i.i
  br i1 %.405.not.i397.i.i, label %B130.else.endif.endif.endif.endif.i399.i.i, label %B130.else.endif.if.i398.i.i, !prof !6

B130.else.endif.if.i398.i.i:                      ; preds = %B130.else.endif.i395.i.i
  br label %B130.else.endif.endif.endif.endif.i399.i.i

B130.else.endif.endif.endif.endif.i399.i.i:       ; preds = %B130.else.endif.if.i398.i.i, %B130.else.endif.i395.i.i
  %.385.sroa.0.3.i400.i.i = phi i64 [ %.828.i.i, %B130.else.endif.if.i398.i.i ], [ %.385.sroa.0.1.i396.i.i, %B130.else.endif.i395.i.i ]
  %.498.i401.i.i = getelementptr double, ptr %30, i64 %.385.sroa.0.3.i400.i.i
  %76 = getelementptr double, ptr %72, i64 %.317279285.i387.i.i
  %.565.i402.i.i = load double, ptr %76, align 8, !noalias !30
  br i1 %57, label %B284.i429.i.i, label %B228.if.preheader.i403.i.i

B228.if.preheader.i403.i.i:                       ; preds = %B130.else.endif.endif.endif.endif.i399.i.i
  br i1 %58, label %B228.if.epil.preheader.i423.i.i, label %B228.if.preheader2.i404.i.i

B228.if.preheader2.i404.i.i:                      ; preds = %B228.if.preheader.i403.i.i
  %77 = shl i64 %.385.sroa.0.3.i400.i.i, 3
  %scevgep7.i405.i.i = getelementptr i8, ptr %scevgep6.i371.i.i, i64 %77
  br i1 %59, label %B228.if.i406.epil.preheader.i.i, label %B228.if.i406.preheader.i.i

B228.if.i406.preheader.i.i:                       ; preds = %B228.if.preheader2.i404.i.i
  %scevgep766.i.i = getelementptr i8, ptr %scevgep748.i.i, i64 %77
  br label %B228.if.i406.i.i

B228.if.i406.i.i:                                 ; preds = %B228.if.i406.i.i, %B228.if.i406.preheader.i.i
  %lsr.iv23.i.i = phi i64 [ %lsr.iv.next24.i.i, %B228.if.i406.i.i ], [ %55, %B228.if.i406.preheader.i.i ]
  %.655272274.i407.i.i = phi i64 [ %.662.1.i415.1.i.i, %B228.if.i406.i.i ], [ 0, %B228.if.i406.preheader.i.i ]
  %78 = shl i64 %.655272274.i407.i.i, 3
  %sunkaddr88.i.i = getelementptr i8, ptr %.992.i, i64 %78
  %.716.i409.i.i = load double, ptr %sunkaddr88.i.i, align 8, !noalias !30
  %scevgep769.i.i = getelementptr i8, ptr %scevgep766.i.i, i64 %78
  %scevgep53.i.i = getelementptr i8, ptr %scevgep769.i.i, i64 -16
  %scevgep51.i.i = getelementptr i8, ptr %scevgep769.i.i, i64 -24
  %.746.i412.i.i = load double, ptr %scevgep51.i.i, align 8, !noalias !30
  %.748.i413.i.i = fmul contract double %.565.i402.i.i, %.746.i412.i.i
  %.749.i414.i.i = fadd contract double %.716.i409.i.i, %.748.i413.i.i
  store double %.749.i414.i.i, ptr %sunkaddr88.i.i, align 8, !noalias !30
  %sunkaddr91.i.i = getelementptr i8, ptr %sunkaddr88.i.i, i64 8
  %.716.1.i417.i.i = load double, ptr %sunkaddr91.i.i, align 8, !noalias !30
  %.746.1.i418.i.i = load double, ptr %scevgep53.i.i, align 8, !noalias !30
  %.748.1.i419.i.i = fmul contract double %.565.i402.i.i, %.746.1.i418.i.i
  %.749.1.i420.i.i = fadd contract double %.716.1.i417.i.i, %.748.1.i419.i.i
  store double %.749.1.i420.i.i, ptr %sunkaddr91.i.i, align 8, !noalias !30
  %sunkaddr94.i.i = getelementptr i8, ptr %sunkaddr88.i.i, i64 16
  %.716.i409.1.i.i = load double, ptr %sunkaddr94.i.i, align 8, !noalias !30
  %scevgep35.i.i = getelementptr i8, ptr %scevgep769.i.i, i64 -8
  %.746.i412.1.i.i = load double, ptr %scevgep35.i.i, align 8, !noalias !30
  %.748.i413.1.i.i = fmul contract double %.565.i402.i.i, %.746.i412.1.i.i
  %.749.i414.1.i.i = fadd contract double %.716.i409.1.i.i, %.748.i413.1.i.i
  store double %.749.i414.1.i.i, ptr %sunkaddr94.i.i, align 8, !noalias !30
  %.662.1.i415.1.i.i = add i64 %.655272274.i407.i.i, 4
  %sunkaddr95.i.i = shl i64 %.662.1.i415.1.i.i, 3
  %sunkaddr96.i.i = getelementptr i8, ptr %.992.i, i64 %sunkaddr95.i.i
  %sunkaddr97.i.i = getelementptr i8, ptr %sunkaddr96.i.i, i64 -8
  %.716.1.i417.1.i.i = load double, ptr %sunkaddr97.i.i, align 8, !noalias !30
  %.746.1.i418.1.i.i = load double, ptr %scevgep769.i.i, align 8, !noalias !30
  %.748.1.i419.1.i.i = fmul contract double %.565.i402.i.i, %.746.1.i418.1.i.i
  %.749.1.i420.1.i.i = fadd contract double %.716.1.i417.1.i.i, %.748.1.i419.1.i.i
  store double %.749.1.i420.1.i.i, ptr %sunkaddr97.i.i, align 8, !noalias !30
  %lsr.iv.next24.i.i = add i64 %lsr.iv23.i.i, -2
  %niter728.ncmp.1.i.i = icmp eq i64 %lsr.iv.next24.i.i, 0
  br i1 %niter728.ncmp.1.i.i, label %B284.loopexit.unr-lcssa.i422.unr-lcssa.i.i, label %B228.if.i406.i.i

B872.endif.endif.endif.endif.endif.endif.endif.endif.i.i: ; preds = %B284.i429.i.i, %B76.i381.i.i
  br i1 %57, label %B1264.i.i, label %B56.if.i.i.i

B56.if.i.i.i:                                     ; preds = %B872.endif.endif.endif.endif.endif.endif.endif.endif.i.i, %B56.if.i.i.i
  %.186192194.i.i.i = phi i64 [ %.193.i434.i.i, %B56.if.i.i.i ], [ 0, %B872.endif.endif.endif.endif.endif.endif.endif.endif.i.i ]
  %.193.i434.i.i = add nuw nsw i64 %.186192194.i.i.i, 1
  %79 = shl i64 %.186192194.i.i.i, 3
  %scevgep5.i435.i.i = getelementptr i8, ptr %.992.i, i64 %79
  %.247.i436.i.i = load double, ptr %scevgep5.i435.i.i, align 8, !noalias !33
  %scevgep4.i437.i.i = getelementptr i8, ptr %.926.i, i64 %79
  %.277.i438.i.i = load double, ptr %scevgep4.i437.i.i, align 8, !noalias !33
  %.278.i.i.i = fadd contract double %.277.i438.i.i, 1.000000e+00
  %.279.i439.i.i = fmul contract double %.247.i436.i.i, %.247.i436.i.i
  %.280.i.i.i = fadd contract double %.279.i439.i.i, 4.000000e+00
  %.284.i440.i.i = fdiv contract double %.278.i.i.i, %.280.i.i.i
  %.286.i.i.i = fsub contract double 4.000000e+00, %.279.i439.i.i
  %.287.i.i.i = fmul contract double %.286.i.i.i, %.284.i440.i.i
  %.288.i.i.i = fmul contract double %.247.i436.i.i, 4.000000e+00
  %.289.i.i.i = fmul contract double %.288.i.i.i, %.284.i440.i.i
  %scevgep57.i.i = getelementptr i8, ptr %.501.i, i64 %79
  %.319.i442.i.i = load double, ptr %scevgep57.i.i, align 8, !noalias !33
  %.320.i443.i.i = fmul contract double %.319.i442.i.i, %.287.i.i.i
  %scevgep56.i.i = getelementptr i8, ptr %.563.i, i64 %79
  %.350.i445.i.i = load double, ptr %scevgep56.i.i, align 8, !noalias !33
  %.351.i.i.i = fmul contract double %.350.i445.i.i, %.289.i.i.i
  %.352.i446.i.i = fsub contract double %.320.i443.i.i, %.351.i.i.i
  %scevgep55.i.i = getelementptr i8, ptr %.642.i, i64 %79
  store double %.352.i446.i.i, ptr %scevgep55.i.i, align 8, !noalias !33
  %.413.i.i.i = fmul contract double %.319.i442.i.i, %.289.i.i.i
  %.444.i449.i.i = fmul contract double %.350.i445.i.i, %.287.i.i.i
  %.445.i450.i.i = fadd contract double %.413.i.i.i, %.444.i449.i.i
  %scevgep54.i.i = getelementptr i8, ptr %.705.i, i64 %79
  store double %.445.i450.i.i, ptr %scevgep54.i.i, align 8, !noalias !33
  %exitcond.not.i452.i.i = icmp eq i64 %.13.i.i.i, %.193.i434.i.i
  br i1 %exitcond.not.i452.i.i, label %B1264.i.i, label %B56.if.i.i.i

B1552.if.lr.ph.i.i:                               ; preds = %B1264.i.i
  %.3673.i.i = load i64, ptr %sunkaddr98.i.i, align 8, !noalias !7
  %.3626.i.i = load i64, ptr %.907.i.i, align 8, !noalias !7
  %.3256.i.i = load i64, ptr %sunkaddr100.i.i, align 8, !noalias !7
  %.3260.i.i = mul nsw i64 %.3258.i.i, %.2245.sroa.0.0248.i.i
  %.3261.i.i = add nsw i64 %.3256.i.i, %.3260.i.i
  %80 = inttoptr i64 %.3261.i.i to ptr
  %.3940.i.i = getelementptr double, ptr %80, i64 %.1385.sroa.0.0254.i.i
  %.4006.i.i = getelementptr double, ptr %80, i64 %.3994.i.i
  %.152.i.i.i = add nsw i64 %.3626.i.i, -4
  %81 = icmp eq i64 %.3626.i.i, 1
  %sunkaddr67.i.i = inttoptr i64 %.3673.i.i to ptr
  %sunkaddr69.i.i = getelementptr i8, ptr %sunkaddr67.i.i, i64 8
  br label %B1552.if.i.i

B1552.if.i.i:                                     ; preds = %_ZN17bnserve_inference6kernel5_sums8lane_sumB3v67B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE.exit533.i.i, %B1552.if.lr.ph.i.i
  %.387824512459.i.i = phi i64 [ 0, %B1552.if.lr.ph.i.i ], [ %.3885.i.i, %_ZN17bnserve_inference6kernel5_sums8lane_sumB3v67B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE.exit533.i.i ]
  %.3885.i.i = add nuw nsw i64 %.387824512459.i.i, 1
  %.3915.i.i = uitofp nneg i64 %.387824512459.i.i to double
  %.3916.i.i = fmul contract double %.37562200.i.i, %.3915.i.i
  %.3918.i.i = fadd contract double %.1826.i, %.3916.i.i
  %.3920.i.i = fadd contract double %.3412.i.i, %.3918.i.i
  br i1 %81, label %B1672.i.i, label %B1758.i.i

B78.if.i.i.i:                                     ; preds = %B1672.i.i, %B78.if.i.i.i
  %.206238240.i.i.i = phi i64 [ %.213.i469.i.i, %B78.if.i.i.i ], [ 0, %B1672.i.i ]
  %.213.i469.i.i = add nuw nsw i64 %.206238240.i.i.i, 1
  %82 = shl i64 %.206238240.i.i.i, 3
  %scevgep6.i470.i.i = getelementptr i8, ptr %.3435.i.i, i64 %82
  %.268.i.i.i = load double, ptr %scevgep6.i470.i.i, align 8, !noalias !36
  %.270.i.i.i = fmul contract double %.104.i468.i.i, %.268.i.i.i
  %.271.i.i.i = tail call contract double @llvm.fma.f64(double %.270.i.i.i, double 0x3FE45F306DC9C883, double 0x4338000000000000)
  %.272.i.i.i = fadd contract double %.271.i.i.i, 0xC338000000000000
  %.287.i471.i.i = tail call contract double @llvm.fma.f64(double %.272.i.i.i, double 0xBFF921FB54442D18, double %.270.i.i.i)
  %.302.i.i.i = tail call contract double @llvm.fma.f64(double %.272.i.i.i, double 0xBC91A62633145C07, double %.287.i471.i.i)
  %.303.i472.i.i = fmul contract double %.302.i.i.i, %.302.i.i.i
  %.304.i.i.i = tail call contract double @llvm.fma.f64(double %.303.i472.i.i, double 0xBD6AE7F3E733B81F, double 0x3DE6124613A86D09)
  %.305.i.i.i = tail call contract double @llvm.fma.f64(double %.303.i472.i.i, double %.304.i.i.i, double 0xBE5AE64567F544E4)
  %.306.i.i.i = tail call contract double @llvm.fma.f64(double %.303.i472.i.i, double %.305.i.i.i, double 0x3EC71DE3A556C734)
  %.307.i.i.i = tail call contract double @llvm.fma.f64(double %.303.i472.i.i, double %.306.i.i.i, double 0xBF2A01A01A01A01A)
  %.308.i.i.i = tail call contract double @llvm.fma.f64(double %.303.i472.i.i, double %.307.i.i.i, double 0x3F81111111111111)
  %.309.i.i.i = tail call contract double @llvm.fma.f64(double %.303.i472.i.i, double %.308.i.i.i, double 0xBFC5555555555555)
  %.310.i.i.i = fmul contract double %.302.i.i.i, %.303.i472.i.i
  %.311.i.i.i = tail call contract double @llvm.fma.f64(double %.310.i.i.i, double %.309.i.i.i, double %.302.i.i.i)
  %.312.i473.i.i = tail call contract double @llvm.fma.f64(double %.303.i472.i.i, double 0x3D2AE7F3E733B81F, double 0xBDA93974A8C07C9D)
  %.313.i.i.i = tail call contract double @llvm.fma.f64(double %.303.i472.i.i, double %.312.i473.i.i, double 0x3E21EED8EFF8D898)
  %.314.i474.i.i = tail call contract double @llvm.fma.f64(double %.303.i472.i.i, double %.313.i.i.i, double 0xBE927E4FB7789F5C)
  %.315.i.i.i = tail call contract double @llvm.fma.f64(double %.303.i472.i.i, double %.314.i474.i.i, double 0x3EFA01A01A01A01A)
  %.316.i475.i.i = tail call contract double @llvm.fma.f64(double %.303.i472.i.i, double %.315.i.i.i, double 0xBF56C16C16C16C17)
  %.317.i476.i.i = tail call contract double @llvm.fma.f64(double %.303.i472.i.i, double %.316.i475.i.i, double 0x3FA5555555555555)
  %.318.i477.i.i = tail call contract double @llvm.fma.f64(double %.303.i472.i.i, double %.317.i476.i.i, double -5.000000e-01)
  %.319.i478.i.i = tail call contract double @llvm.fma.f64(double %.303.i472.i.i, double %.318.i477.i.i, double 1.000000e+00)
  %.320.i479.i.i = bitcast double %.271.i.i.i to i64
  %.321.i.i.i = bitcast double %.311.i.i.i to i64
  %.322.i.i.i = bitcast double %.319.i478.i.i to i64
  %.323.i.i.i = xor i64 %.322.i.i.i, %.321.i.i.i
  %.324.i480.i.i = and i64 %.320.i479.i.i, 1
  %83 = icmp eq i64 %.324.i480.i.i, 0
  %.326.i.i.i = select i1 %83, i64 0, i64 %.323.i.i.i
  %.327.i.i.i = shl i64 %.320.i479.i.i, 62
  %.328.i.i.i = and i64 %.327.i.i.i, -9223372036854775808
  %.330.i.i.i = add i64 %.327.i.i.i, 4611686018427387904
  %.331.i.i.i = and i64 %.330.i.i.i, -9223372036854775808
  %84 = xor i64 %.328.i.i.i, %.321.i.i.i
  %.333.i.i.i = xor i64 %84, %.326.i.i.i
  %.334.i481.i.i = bitcast i64 %.333.i.i.i to double
  %85 = xor i64 %.331.i.i.i, %.322.i.i.i
  %.336.i.i.i = xor i64 %85, %.326.i.i.i
  %.337.i.i.i = bitcast i64 %.336.i.i.i to double
  %scevgep63.i.i = getelementptr i8, ptr %strain.2.sroa.32.2.i.i, i64 %82
  %.387.i.i.i = load double, ptr %scevgep63.i.i, align 8, !noalias !36
  %.388.i.i.i = fmul contract double %.387.i.i.i, %.337.i.i.i
  %scevgep62.i.i = getelementptr i8, ptr %strain.2.sroa.88.2.i.i, i64 %82
  %.418.i.i.i = load double, ptr %scevgep62.i.i, align 8, !noalias !36
  %.419.i484.i.i = fmul contract double %.418.i.i.i, %.334.i481.i.i
  %.420.i.i.i = fsub contract double %.388.i.i.i, %.419.i484.i.i
  %.451.i.i.i = fmul contract double %.387.i.i.i, %.334.i481.i.i
  %.482.i.i.i = fmul contract double %.418.i.i.i, %.337.i.i.i
  %.483.i.i.i = fadd contract double %.451.i.i.i, %.482.i.i.i
  %scevgep61.i.i = getelementptr i8, ptr %.3940.i.i, i64 %82
  %.513.i.i.i = load double, ptr %scevgep61.i.i, align 8, !noalias !36
  %.514.i.i.i = fmul contract double %.513.i.i.i, %.420.i.i.i
  %scevgep60.i.i = getelementptr i8, ptr %.4006.i.i, i64 %82
  %.544.i.i.i = load double, ptr %scevgep60.i.i, align 8, !noalias !36
  %.545.i.i.i = fmul contract double %.544.i.i.i, %.483.i.i.i
  %.546.i.i.i = fsub contract double %.514.i.i.i, %.545.i.i.i
  %scevgep59.i.i = getelementptr i8, ptr %.784.i, i64 %82
  store double %.546.i.i.i, ptr %scevgep59.i.i, align 8, !noalias !36
  %.606.i.i.i = load double, ptr %scevgep61.i.i, align 8, !noalias !36
  %.607.i.i.i = fmul contract double %.606.i.i.i, %.483.i.i.i
  %.637.i.i.i = load double, ptr %scevgep60.i.i, align 8, !noalias !36
  %.638.i.i.i = fmul contract double %.637.i.i.i, %.420.i.i.i
  %.639.i.i.i = fadd contract double %.607.i.i.i, %.638.i.i.i
  %scevgep58.i.i = getelementptr i8, ptr %.847.i, i64 %82
  store double %.639.i.i.i, ptr %scevgep58.i.i, align 8, !noalias !36
  %exitcond.not.i489.i.i = icmp eq i64 %.13.i.i.i, %.213.i469.i.i
  br i1 %exitcond.not.i489.i.i, label %B1762.i.i, label %B78.if.i.i.i

B348.loopexit.i531.i.i:                           ; preds = %B104.if.i494.i.i
  %86 = fadd contract double %.244.i.i.i, %.279.i.i.i
  %87 = fadd contract double %.314.i.i.i, %.349.i.i.i
  %88 = fadd contract double %86, %87
  %89 = fadd contract double %.384.i.i.i, %.419.i.i.i
  %90 = fadd contract double %.454.i.i.i, %.489.i.i.i
  %91 = fadd contract double %89, %90
  %92 = fadd contract double %88, %91
  %93 = fadd contract double %.244.i507.i.i, %.279.i510.i.i
  %94 = fadd contract double %.314.i513.i.i, %.349.i516.i.i
  %95 = fadd contract double %93, %94
  %96 = fadd contract double %.384.i519.i.i, %.419.i522.i.i
  %97 = fadd contract double %.454.i525.i.i, %.489.i527.i.i
  %98 = fadd contract double %96, %97
  %99 = fadd contract double %95, %98
  br label %_ZN17bnserve_inference6kernel5_sums8lane_sumB3v67B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE.exit533.i.i

B104.if.i494.i.i:                                 ; preds = %B104.if.i.i.i, %B104.if.i494.i.i
  %lsr.iv9.i495.i.i = phi i64 [ %lsr.iv.next.i529.i.i, %B104.if.i494.i.i ], [ %.60.1.i.i.i, %B104.if.i.i.i ]
  %lsr.iv.i496.i.i = phi ptr [ %scevgep1.i528.i.i, %B104.if.i494.i.i ], [ %scevgep.i493.i.i, %B104.if.i.i.i ]
  %s7.2.0168.i497.i.i = phi double [ %.489.i527.i.i, %B104.if.i494.i.i ], [ 0.000000e+00, %B104.if.i.i.i ]
  %s6.2.0167.i498.i.i = phi double [ %.454.i525.i.i, %B104.if.i494.i.i ], [ 0.000000e+00, %B104.if.i.i.i ]
  %s5.2.0166.i499.i.i = phi double [ %.419.i522.i.i, %B104.if.i494.i.i ], [ 0.000000e+00, %B104.if.i.i.i ]
  %s4.2.0165.i500.i.i = phi double [ %.384.i519.i.i, %B104.if.i494.i.i ], [ 0.000000e+00, %B104.if.i.i.i ]
  %s3.2.0164.i501.i.i = phi double [ %.349.i516.i.i, %B104.if.i494.i.i ], [ 0.000000e+00, %B104.if.i.i.i ]
  %s2.2.0163.i502.i.i = phi double [ %.314.i513.i.i, %B104.if.i494.i.i ], [ 0.000000e+00, %B104.if.i.i.i ]
  %s1.2.0162.i503.i.i = phi double [ %.279.i510.i.i, %B104.if.i494.i.i ], [ 0.000000e+00, %B104.if.i.i.i ]
  %s0.2.0161.i504.i.i = phi double [ %.244.i507.i.i, %B104.if.i494.i.i ], [ 0.000000e+00, %B104.if.i.i.i ]
  %scevgep2.i505.i.i = getelementptr i8, ptr %lsr.iv.i496.i.i, i64 -56
  %.242.i506.i.i = load double, ptr %scevgep2.i505.i.i, align 8, !noalias !39
  %.244.i507.i.i = fadd contract double %s0.2.0161.i504.i.i, %.242.i506.i.i
  %scevgep3.i508.i.i = getelementptr i8, ptr %lsr.iv.i496.i.i, i64 -48
  %.277.i509.i.i = load double, ptr %scevgep3.i508.i.i, align 8, !noalias !39
  %.279.i510.i.i = fadd contract double %s1.2.0162.i503.i.i, %.277.i509.i.i
  %scevgep4.i511.i.i = getelementptr i8, ptr %lsr.iv.i496.i.i, i64 -40
  %.312.i512.i.i = load double, ptr %scevgep4.i511.i.i, align 8, !noalias !39
  %.314.i513.i.i = fadd contract double %s2.2.0163.i502.i.i, %.312.i512.i.i
  %scevgep5.i514.i.i = getelementptr i8, ptr %lsr.iv.i496.i.i, i64 -32
  %.347.i515.i.i = load double, ptr %scevgep5.i514.i.i, align 8, !noalias !39
  %.349.i516.i.i = fadd contract double %s3.2.0164.i501.i.i, %.347.i515.i.i
  %scevgep6.i517.i.i = getelementptr i8, ptr %lsr.iv.i496.i.i, i64 -24
  %.382.i518.i.i = load double, ptr %scevgep6.i517.i.i, align 8, !noalias !39
  %.384.i519.i.i = fadd contract double %s4.2.0165.i500.i.i, %.382.i518.i.i
  %scevgep7.i520.i.i = getelementptr i8, ptr %lsr.iv.i496.i.i, i64 -16
  %.417.i521.i.i = load double, ptr %scevgep7.i520.i.i, align 8, !noalias !39
  %.419.i522.i.i = fadd contract double %s5.2.0166.i499.i.i, %.417.i521.i.i
  %scevgep8.i523.i.i = getelementptr i8, ptr %lsr.iv.i496.i.i, i64 -8
  %.452.i524.i.i = load double, ptr %scevgep8.i523.i.i, align 8, !noalias !39
  %.454.i525.i.i = fadd contract double %s6.2.0167.i498.i.i, %.452.i524.i.i
  %.487.i526.i.i = load double, ptr %lsr.iv.i496.i.i, align 8, !noalias !39
  %.489.i527.i.i = fadd contract double %s7.2.0168.i497.i.i, %.487.i526.i.i
  %scevgep1.i528.i.i = getelementptr i8, ptr %lsr.iv.i496.i.i, i64 64
  %lsr.iv.next.i529.i.i = add nsw i64 %lsr.iv9.i495.i.i, -1
  %exitcond.not.i530.i.i = icmp eq i64 %lsr.iv.next.i529.i.i, 0
  br i1 %exitcond.not.i530.i.i, label %B348.loopexit.i531.i.i, label %B104.if.i494.i.i

_ZN17bnserve_inference6kernel5_sums8lane_sumB3v67B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE.exit533.i.i: ; preds = %B348.loopexit.i531.i.i, %B1762.i.i
  %s0.2.0.lcssa.i3.i.i = phi double [ %92, %B348.loopexit.i531.i.i ], [ 0.000000e+00, %B1762.i.i ]
  %s0.2.0.lcssa.i532.i.i = phi double [ %99, %B348.loopexit.i531.i.i ], [ 0.000000e+00, %B1762.i.i ]
  %.idx271.i.i = shl i64 %.387824512459.i.i, 4
  %100 = getelementptr i8, ptr %35, i64 %.idx271.i.i
  %.4447.i.i = load double, ptr %100, align 8, !noalias !7
  %.4450.i.i = fmul contract double %.3342.i.i, %s0.2.0.lcssa.i3.i.i
  %.4453.i.i = fmul contract double %.3375.i.i, %s0.2.0.lcssa.i532.i.i
  %.4454.i.i = fsub contract double %.4450.i.i, %.4453.i.i
  %.4455.i.i = fadd contract double %.4447.i.i, %.4454.i.i
  store double %.4455.i.i, ptr %100, align 8, !noalias !7
  %101 = getelementptr i8, ptr %100, i64 8
  %.4520.i.i = load double, ptr %101, align 8, !noalias !7
  %.4523.i.i = fmul contract double %.3342.i.i, %s0.2.0.lcssa.i532.i.i
  %.4526.i.i = fmul contract double %.3375.i.i, %s0.2.0.lcssa.i3.i.i
  %.4527.i.i = fadd contract double %.4526.i.i, %.4523.i.i
  %.4528.i.i = fadd contract double %.4527.i.i, %.4520.i.i
  store double %.4528.i.i, ptr %101, align 8, !noalias !7
  %exitcond.not.i7.i = icmp eq i64 %.3885.i.i, %.3789.i.i
  br i1 %exitcond.not.i7.i, label %B1766.i.i, label %B1552.if.i.i

B2079.thread.i.i:                                 ; preds = %B2039.i.i
  %102 = inttoptr i64 %.4691.i.i to ptr
  tail call void @llvm.memset.p0.i64(ptr align 8 %102, i8 0, i64 %.4693.i.i, i1 false), !noalias !7
  br label %B62.if.preheader.i.i.i

_ZN17bnserve_inference6kernel7_source16_contract_linearB3v26B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIxLi1E1C7mutable7alignedEd5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi1E1C7mutable7alignedE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi2EE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi2EE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi2EE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi2EEE.exit.i: ; preds = %B2385.i.i, %.1269.endif.endif.i.i, %.1268.if.i.i
  %.461.i.i = load i64, ptr %arg.arguments, align 8, !noalias !42
  %.491.i8.i = load i64, ptr %.490.i.i, align 8, !noalias !42
  %.500.i.i = sub i64 0, %.491.i8.i
  %.508.1.i.i = and i64 %.500.i.i, -8
  %.542.i.i = sub i64 0, %.508.1.i.i
  %.572.i.i = load i64, ptr %.607.i.i, align 8, !noalias !42
  %.609.i.i = load i64, ptr %.608.i9.i, align 8, !noalias !42
  %.697.i.i = load i64, ptr %.696.i.i, align 8, !noalias !42
  %.700.i.i = mul nsw i64 %.572.i.i, %.542.i.i
  %.796.i.i = icmp slt i64 %.542.i.i, 1
  br i1 %.796.i.i, label %_ZN17bnserve_inference6kernel7_source19_contract_quadraticB3v69B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi1E1C7mutable7alignedE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi2EE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi2EE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi2EE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi2EEE.exit.i, label %B0.endif.endif.endif.endif.endif.i.i

B344.i.i:                                         ; preds = %B344.preheader.i.i, %B1268.i.i
  %.828.sroa.0.085.i.i = phi i64 [ %.828.sroa.0.0.i.i, %B1268.i.i ], [ 0, %B344.preheader.i.i ]
  %.785.184.in.i.i = phi i64 [ %122, %B1268.i.i ], [ %.817.i.i, %B344.preheader.i.i ]
  %.782.183.i.i = phi i64 [ %.782.1.i.i, %B1268.i.i ], [ 512, %B344.preheader.i.i ]
  %norm.3.082.i.i = phi double [ %norm.2.1.lcssa.i.i, %B1268.i.i ], [ 0.000000e+00, %B344.preheader.i.i ]
  %.881.i.i = sub i64 %.542.i.i, %.828.sroa.0.085.i.i
  %.13.i.i13.i = tail call i64 @llvm.smin.i64(i64 %.881.i.i, i64 512)
  %.1683.i.i = sub nsw i64 %.491.i8.i, %.828.sroa.0.085.i.i
  %.13.i135.i.i = tail call i64 @llvm.smin.i64(i64 %.1683.i.i, i64 %.13.i.i13.i)
  %.17961340.not.i.i = icmp slt i64 %.13.i135.i.i, 1
  br i1 %.17961340.not.i.i, label %B698.i.i, label %B578.if.preheader.i.i

B578.if.preheader.i.i:                            ; preds = %B344.i.i
  %103 = shl i64 %.828.sroa.0.085.i.i, 3
  %scevgep244.i.i = getelementptr i8, ptr %126, i64 %103
  br label %B578.if.i.i

B698.i.i:                                         ; preds = %B578.if.i.i, %B344.i.i
  %.2185.i.i = icmp slt i64 %.13.i135.i.i, 0
  %.2186.i.i = select i1 %.2185.i.i, i64 %.13.i.i13.i, i64 0
  %.2187.i.i = add i64 %.2186.i.i, %.13.i135.i.i
  %.2190.i.i = icmp slt i64 %.2187.i.i, 0
  br i1 %.2190.i.i, label %B698.endif.else.if.i.i, label %B698.endif.else.endif.i.i, !prof !10

B848.i.i:                                         ; preds = %B742.if.i.i
  %.2530.i.i = add nuw nsw i64 %.239413641397.i.i, %.2528.i.i
  %.2563.i.i = load i64, ptr %.607.i.i, align 8, !noalias !42
  %.2593.i.i = load i64, ptr %sunkaddr64.i.i, align 8, !noalias !42
  %.2597.i.i = shl i64 %.2530.i.i, 3
  %.2598.i.i = mul i64 %.2597.i.i, %.2563.i.i
  %.2599.i.i = add nsw i64 %.2598.i.i, %.2593.i.i
  br i1 %146, label %B60.if.preheader.i.i135.i, label %B76.i.i61.i

B1076.loopexit.unr-lcssa.i.i:                     ; preds = %B982.if.i.i
  br i1 %152, label %B1154.i.i, label %B982.if.epil.preheader.i.i

B982.if.epil.preheader.i.i:                       ; preds = %B982.if.preheader.i.i, %B1076.loopexit.unr-lcssa.i.i
  %.278413541356.epil.init.i.i = phi i64 [ 0, %B982.if.preheader.i.i ], [ %.2791.1.i.i, %B1076.loopexit.unr-lcssa.i.i ]
  %104 = inttoptr i64 %.2466.i.i to ptr
  %105 = getelementptr double, ptr %.501.i, i64 %.278413541356.epil.init.i.i
  %.2845.epil.i.i = load double, ptr %105, align 8, !noalias !42
  %106 = getelementptr double, ptr %104, i64 %.278413541356.epil.init.i.i
  %.2875.epil.i.i = load double, ptr %106, align 8, !noalias !42
  %.2876.epil.i.i = fmul contract double %.2845.epil.i.i, %.2875.epil.i.i
  %107 = getelementptr double, ptr %.926.i, i64 %.278413541356.epil.init.i.i
  %.2906.epil.i.i = load double, ptr %107, align 8, !noalias !42
  %.2907.epil.i.i = fadd contract double %.2906.epil.i.i, 1.000000e+00
  %.2939.epil.i.i = fmul contract double %.2907.epil.i.i, %.2907.epil.i.i
  %.2940.epil.i.i = fmul contract double %.2876.epil.i.i, %.2939.epil.i.i
  %108 = getelementptr double, ptr %.784.i, i64 %.278413541356.epil.init.i.i
  store double %.2940.epil.i.i, ptr %108, align 8, !noalias !42
  br label %B1154.i.i

B1078.i.i:                                        ; preds = %B742.if.i.i
  br i1 %143, label %B1154.i.i, label %B1108.if.preheader.i.i

B1108.if.preheader.i.i:                           ; preds = %B1078.i.i
  br i1 %144, label %B1108.if.epil.preheader.i.i, label %B1108.if.preheader242.i.i

B1108.if.preheader242.i.i:                        ; preds = %B1108.if.preheader.i.i
  %109 = inttoptr i64 %.2466.i.i to ptr
  %scevgep255.i.i = getelementptr i8, ptr %109, i64 24
  br label %B1108.if.i.i

B1154.loopexit.unr-lcssa.i.i:                     ; preds = %B1108.if.i.i
  br i1 %145, label %B1154.i.i, label %B1108.if.epil.preheader.i.i

B1108.if.epil.preheader.i.i:                      ; preds = %B1154.loopexit.unr-lcssa.i.i, %B1108.if.preheader.i.i
  %.306813471349.epil.init.i.i = phi i64 [ 0, %B1108.if.preheader.i.i ], [ %.3075.3.i.i, %B1154.loopexit.unr-lcssa.i.i ]
  %110 = inttoptr i64 %.2466.i.i to ptr
  %111 = shl nuw nsw i64 %.306813471349.epil.init.i.i, 3
  %scevgep271.i.i = getelementptr i8, ptr %.784.i, i64 %111
  %scevgep273.i.i = getelementptr i8, ptr %110, i64 %111
  %scevgep275.i.i = getelementptr i8, ptr %.501.i, i64 %111
  br label %B1108.if.epil.i.i

B1108.if.epil.i.i:                                ; preds = %B1108.if.epil.i.i, %B1108.if.epil.preheader.i.i
  %lsr.iv.i22.i = phi i64 [ %lsr.iv.next.i23.i, %B1108.if.epil.i.i ], [ 0, %B1108.if.epil.preheader.i.i ]
  %scevgep276.i.i = getelementptr i8, ptr %scevgep275.i.i, i64 %lsr.iv.i22.i
  %.3129.epil.i.i = load double, ptr %scevgep276.i.i, align 8, !noalias !42
  %scevgep274.i.i = getelementptr i8, ptr %scevgep273.i.i, i64 %lsr.iv.i22.i
  %.3159.epil.i.i = load double, ptr %scevgep274.i.i, align 8, !noalias !42
  %.3160.epil.i.i = fmul contract double %.3129.epil.i.i, %.3159.epil.i.i
  %scevgep272.i.i = getelementptr i8, ptr %scevgep271.i.i, i64 %lsr.iv.i22.i
  store double %.3160.epil.i.i, ptr %scevgep272.i.i, align 8, !noalias !42
  %lsr.iv.next.i23.i = add nuw nsw i64 %lsr.iv.i22.i, 8
  %epil.iter.cmp.not.i.i = icmp eq i64 %140, %lsr.iv.next.i23.i
  br i1 %epil.iter.cmp.not.i.i, label %B1154.i.i, label %B1108.if.epil.i.i, !llvm.loop !45

B1154.i.i:                                        ; preds = %B1108.if.epil.i.i, %B848.endif.endif.i.i, %B1154.loopexit.unr-lcssa.i.i, %B1078.i.i, %B982.if.epil.preheader.i.i, %B1076.loopexit.unr-lcssa.i.i
  %.idx94.i.i = mul i64 %.239413641397.i.i, 24
  %112 = getelementptr i8, ptr %.375.i, i64 %.idx94.i.i
  %.3232.i.i = load double, ptr %112, align 8, !noalias !42
  %113 = getelementptr i8, ptr %112, i64 8
  %.3267.i.i = load double, ptr %113, align 8, !noalias !42
  br i1 %142, label %B1154.endif.i.i, label %B104.if.i.i24.i

B348.loopexit.i.i.i:                              ; preds = %B104.if.i.i24.i
  %114 = fadd contract double %.244.i.i37.i, %.279.i.i40.i
  %115 = fadd contract double %.314.i.i43.i, %.349.i.i46.i
  %116 = fadd contract double %114, %115
  %117 = fadd contract double %.384.i.i49.i, %.419.i.i52.i
  %118 = fadd contract double %.454.i.i55.i, %.489.i.i57.i
  %119 = fadd contract double %117, %118
  %120 = fadd contract double %116, %119
  br label %B1154.endif.i.i

B104.if.i.i24.i:                                  ; preds = %B1154.i.i, %B104.if.i.i24.i
  %lsr.iv9.i.i25.i = phi i64 [ %lsr.iv.next.i.i59.i, %B104.if.i.i24.i ], [ %.60.1.i.i19.i, %B1154.i.i ]
  %lsr.iv.i.i26.i = phi ptr [ %scevgep1.i.i58.i, %B104.if.i.i24.i ], [ %scevgep.i.i.i, %B1154.i.i ]
  %s7.2.0168.i.i27.i = phi double [ %.489.i.i57.i, %B104.if.i.i24.i ], [ 0.000000e+00, %B1154.i.i ]
  %s6.2.0167.i.i28.i = phi double [ %.454.i.i55.i, %B104.if.i.i24.i ], [ 0.000000e+00, %B1154.i.i ]
  %s5.2.0166.i.i29.i = phi double [ %.419.i.i52.i, %B104.if.i.i24.i ], [ 0.000000e+00, %B1154.i.i ]
  %s4.2.0165.i.i30.i = phi double [ %.384.i.i49.i, %B104.if.i.i24.i ], [ 0.000000e+00, %B1154.i.i ]
  %s3.2.0164.i.i31.i = phi double [ %.349.i.i46.i, %B104.if.i.i24.i ], [ 0.000000e+00, %B1154.i.i ]
  %s2.2.0163.i.i32.i = phi double [ %.314.i.i43.i, %B104.if.i.i24.i ], [ 0.000000e+00, %B1154.i.i ]
  %s1.2.0162.i.i33.i = phi double [ %.279.i.i40.i, %B104.if.i.i24.i ], [ 0.000000e+00, %B1154.i.i ]
  %s0.2.0161.i.i34.i = phi double [ %.244.i.i37.i, %B104.if.i.i24.i ], [ 0.000000e+00, %B1154.i.i ]
  %scevgep2.i.i35.i = getelementptr i8, ptr %lsr.iv.i.i26.i, i64 -56
  %.242.i.i36.i = load double, ptr %scevgep2.i.i35.i, align 8, !noalias !47
  %.244.i.i37.i = fadd contract double %s0.2.0161.i.i34.i, %.242.i.i36.i
  %scevgep3.i.i38.i = getelementptr i8, ptr %lsr.iv.i.i26.i, i64 -48
  %.277.i.i39.i = load double, ptr %scevgep3.i.i38.i, align 8, !noalias !47
  %.279.i.i40.i = fadd contract double %s1.2.0162.i.i33.i, %.277.i.i39.i
  %scevgep4.i.i41.i = getelementptr i8, ptr %lsr.iv.i.i26.i, i64 -40
  %.312.i.i42.i = load double, ptr %scevgep4.i.i41.i, align 8, !noalias !47
  %.314.i.i43.i = fadd contract double %s2.2.0163.i.i32.i, %.312.i.i42.i
  %scevgep5.i.i44.i = getelementptr i8, ptr %lsr.iv.i.i26.i, i64 -32
  %.347.i.i45.i = load double, ptr %scevgep5.i.i44.i, align 8, !noalias !47
  %.349.i.i46.i = fadd contract double %s3.2.0164.i.i31.i, %.347.i.i45.i
  %scevgep6.i.i47.i = getelementptr i8, ptr %lsr.iv.i.i26.i, i64 -24
  %.382.i.i48.i = load double, ptr %scevgep6.i.i47.i, align 8, !noalias !47
  %.384.i.i49.i = fadd contract double %s4.2.0165.i.i30.i, %.382.i.i48.i
  %scevgep7.i.i50.i = getelementptr i8, ptr %lsr.iv.i.i26.i, i64 -16
  %.417.i.i51.i = load double, ptr %scevgep7.i.i50.i, align 8, !noalias !47
  %.419.i.i52.i = fadd contract double %s5.2.0166.i.i29.i, %.417.i.i51.i
  %scevgep8.i.i53.i = getelementptr i8, ptr %lsr.iv.i.i26.i, i64 -8
  %.452.i.i54.i = load double, ptr %scevgep8.i.i53.i, align 8, !noalias !47
  %.454.i.i55.i = fadd contract double %s6.2.0167.i.i28.i, %.452.i.i54.i
  %.487.i.i56.i = load double, ptr %lsr.iv.i.i26.i, align 8, !noalias !47
  %.489.i.i57.i = fadd contract double %s7.2.0168.i.i27.i, %.487.i.i56.i
  %scevgep1.i.i58.i = getelementptr i8, ptr %lsr.iv.i.i26.i, i64 64
  %lsr.iv.next.i.i59.i = add nsw i64 %lsr.iv9.i.i25.i, -1
  %exitcond.not.i.i60.i = icmp eq i64 %lsr.iv.next.i.i59.i, 0
  br i1 %exitcond.not.i.i60.i, label %B348.loopexit.i.i.i, label %B104.if.i.i24.i

B1268.i.i:                                        ; preds = %B1154.endif.i.i, %.2261.if.i.i
  %norm.2.1.lcssa.i.i = phi double [ %norm.3.082.i.i, %.2261.if.i.i ], [ %.3301.i.i, %B1154.endif.i.i ]
  %.838.i.i = icmp samesign ugt i64 %.785.184.in.i.i, 1
  %.851.i.i = add i64 %.782.183.i.i, 512
  %.782.1.i.i = select i1 %.838.i.i, i64 %.851.i.i, i64 %.782.183.i.i
  %121 = tail call i64 @llvm.smax.i64(i64 %.785.184.in.i.i, i64 2)
  %122 = add nsw i64 %121, -1
  %.828.sroa.0.0.i.i = select i1 %.838.i.i, i64 %.782.183.i.i, i64 0
  br i1 %.838.i.i, label %B344.i.i, label %_ZN17bnserve_inference6kernel7_source19_contract_quadraticB3v69B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi1E1C7mutable7alignedE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi2EE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi2EE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi2EE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi2EEE.exit.i

B0.endif.endif.endif.endif.endif.i.i:             ; preds = %_ZN17bnserve_inference6kernel7_source16_contract_linearB3v26B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIxLi1E1C7mutable7alignedEd5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi1E1C7mutable7alignedE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi2EE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi2EE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi2EE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi2EEE.exit.i
  %.811.i.i = and i64 %.542.i.i, 504
  %.814.not.i.i = icmp ne i64 %.811.i.i, 0
  %.8151252.i.i = lshr i64 %.542.i.i, 9
  %.816.i.i = zext i1 %.814.not.i.i to i64
  %.817.i.i = add nuw nsw i64 %.8151252.i.i, %.816.i.i
  %.2528.i.i = mul nsw i64 %.461.i.i, %.155910791085.i
  %.83879.not.i.i = icmp eq i64 %.817.i.i, 0
  br i1 %.83879.not.i.i, label %_ZN17bnserve_inference6kernel7_source19_contract_quadraticB3v69B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi1E1C7mutable7alignedE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi2EE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi2EE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi2EE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi2EEE.exit.i, label %B344.preheader.i.i

B344.preheader.i.i:                               ; preds = %B0.endif.endif.endif.endif.endif.i.i
  %123 = inttoptr i64 %.697.i.i to ptr
  %scevgep6.i141.i.i = getelementptr i8, ptr %123, i64 8
  %scevgep285.i.i = getelementptr i8, ptr %123, i64 24
  %124 = shl i64 %.491.i8.i, 3
  %125 = icmp slt i64 %.461.i.i, 1
  %126 = inttoptr i64 %.609.i.i to ptr
  %127 = icmp sgt i64 %.572.i.i, 0
  br label %B344.i.i

B578.if.i.i:                                      ; preds = %B578.if.i.i, %B578.if.preheader.i.i
  %.180213391341.i.i = phi i64 [ %.1809.i.i, %B578.if.i.i ], [ 0, %B578.if.preheader.i.i ]
  %.1809.i.i = add nuw nsw i64 %.180213391341.i.i, 1
  %128 = add i64 %.180213391341.i.i, %.828.sroa.0.085.i.i
  %.1849.i.i = icmp slt i64 %128, 0
  %129 = select i1 %.1849.i.i, i64 %124, i64 0
  %scevgep245.i.i = getelementptr i8, ptr %scevgep244.i.i, i64 %129
  %130 = shl nuw nsw i64 %.180213391341.i.i, 3
  %scevgep4.i.i = getelementptr i8, ptr %scevgep245.i.i, i64 %130
  %.1865.i.i = load i64, ptr %scevgep4.i.i, align 8, !noalias !42
  %.1880.i.i = icmp slt i64 %.1865.i.i, 0
  %.1881.i.i = select i1 %.1880.i.i, i64 %.1748.i, i64 0
  %.idx.i14.i = shl i64 %.1865.i.i, 4
  %131 = getelementptr i8, ptr %.1749.i, i64 %.idx.i14.i
  %.1895.i.i = getelementptr double, ptr %131, i64 %.1881.i.i
  %.1896.i.i = load double, ptr %.1895.i.i, align 8, !noalias !42
  %132 = getelementptr i8, ptr %131, i64 8
  %.1959.i.i = getelementptr double, ptr %132, i64 %.1881.i.i
  %.1960.i.i = load double, ptr %.1959.i.i, align 8, !noalias !42
  %.1961.i.i = fmul contract double %.1896.i.i, %.1896.i.i
  %.1962.i.i = fmul contract double %.1960.i.i, %.1960.i.i
  %.1963.i.i = fadd contract double %.1961.i.i, %.1962.i.i
  %scevgep3.i15.i = getelementptr i8, ptr %.501.i, i64 %130
  store double %.1963.i.i, ptr %scevgep3.i15.i, align 8, !noalias !42
  %exitcond.not.i16.i = icmp eq i64 %.13.i135.i.i, %.1809.i.i
  br i1 %exitcond.not.i16.i, label %B698.i.i, label %B578.if.i.i

B698.endif.else.if.i.i:                           ; preds = %B698.i.i
  br label %B698.endif.else.endif.i.i

B698.endif.else.endif.i.i:                        ; preds = %B698.endif.else.if.i.i, %B698.i.i
  %.2170.sroa.0.1.i.i = phi i64 [ 0, %B698.endif.else.if.i.i ], [ %.2187.i.i, %B698.i.i ]
  %.2195.not.i.i = icmp slt i64 %.2187.i.i, %.13.i.i13.i
  %.2291.not1344.i.i = icmp sgt i64 %.13.i.i13.i, %.2170.sroa.0.1.i.i
  %or.cond.i17.i = and i1 %.2195.not.i.i, %.2291.not1344.i.i
  br i1 %or.cond.i17.i, label %.2261.endif.preheader.i.i, label %.2261.if.i.i, !prof !50

.2261.endif.preheader.i.i:                        ; preds = %B698.endif.else.endif.i.i
  %133 = shl nuw nsw i64 %.2170.sroa.0.1.i.i, 3
  %scevgep.i136.i = getelementptr i8, ptr %.501.i, i64 %133
  %134 = sub nsw i64 %.13.i.i13.i, %.2170.sroa.0.1.i.i
  %135 = shl nsw i64 %134, 3
  tail call void @llvm.memset.p0.i64(ptr align 8 %scevgep.i136.i, i8 0, i64 %135, i1 false), !noalias !42
  br label %.2261.if.i.i

.2261.if.i.i:                                     ; preds = %.2261.endif.preheader.i.i, %B698.endif.else.endif.i.i
  br i1 %125, label %B1268.i.i, label %B742.if.lr.ph.i.i

B742.if.lr.ph.i.i:                                ; preds = %.2261.if.i.i
  %136 = shl nuw nsw i64 %.13.i.i13.i, 3
  %unroll_iter.i.i18.i = and i64 %.13.i.i13.i, 9223372036854775806
  %.60.1.i.i19.i = ashr i64 %.13.i.i13.i, 3
  %137 = add nsw i64 %unroll_iter.i.i18.i, -2
  %138 = lshr exact i64 %137, 1
  %139 = add nuw i64 %138, 1
  %xtraiter.i.i = and i64 %.13.i.i13.i, 3
  %unroll_iter.i.i = and i64 %.13.i.i13.i, 1020
  %unroll_iter239.i.i = and i64 %.13.i.i13.i, 1022
  %140 = shl nuw nsw i64 %xtraiter.i.i, 3
  %141 = and i64 %139, -2
  %142 = icmp slt i64 %.60.1.i.i19.i, 1
  %143 = icmp slt i64 %.881.i.i, 1
  %144 = icmp slt i64 %.881.i.i, 4
  %145 = icmp eq i64 %xtraiter.i.i, 0
  %146 = icmp sgt i64 %.881.i.i, 0
  %147 = icmp eq i64 %.881.i.i, 1
  %148 = icmp eq i64 %137, 0
  %149 = and i64 %137, 2
  %150 = icmp eq i64 %149, 0
  %151 = and i64 %.13.i.i13.i, 1
  %152 = icmp eq i64 %151, 0
  br label %B742.if.i.i

B742.if.i.i:                                      ; preds = %B1154.endif.i.i, %B742.if.lr.ph.i.i
  %norm.2.11399.i.i = phi double [ %norm.3.082.i.i, %B742.if.lr.ph.i.i ], [ %.3301.i.i, %B1154.endif.i.i ]
  %.239413641397.i.i = phi i64 [ 0, %B742.if.lr.ph.i.i ], [ %.2401.i.i, %B1154.endif.i.i ]
  %.2401.i.i = add nuw nsw i64 %.239413641397.i.i, 1
  %.2459.i.i = load i64, ptr %sunkaddr65.i11.i, align 8, !noalias !42
  %.2462.i.i = mul nuw nsw i64 %.239413641397.i.i, %.542.i.i
  %.2464.i.i = add nsw i64 %.2462.i.i, %.828.sroa.0.085.i.i
  %.2465.i.i = shl nsw i64 %.2464.i.i, 3
  %.2466.i.i = add nsw i64 %.2465.i.i, %.2459.i.i
  br i1 %127, label %B848.i.i, label %B1078.i.i

B60.if.preheader.i.i135.i:                        ; preds = %B848.i.i
  tail call void @llvm.memset.p0.i64(ptr align 8 %.926.i, i8 0, i64 %136, i1 false), !noalias !51
  br label %B76.i.i61.i

B76.i.i61.i:                                      ; preds = %B60.if.preheader.i.i135.i, %B848.i.i
  %.311284.not.i.i62.i = icmp slt i64 %.2563.i.i, 1
  br i1 %.311284.not.i.i62.i, label %B848.endif.endif.i.i, label %B128.if.i.preheader.i63.i

B128.if.i.preheader.i63.i:                        ; preds = %B76.i.i61.i
  %153 = inttoptr i64 %.2599.i.i to ptr
  br label %B128.if.i.i64.i

B284.loopexit.unr-lcssa.i.unr-lcssa.i106.i:       ; preds = %B228.if.i.i84.i
  br i1 %150, label %B228.if.i.epil.preheader.i121.i, label %B284.loopexit.unr-lcssa.i.i107.i

B228.if.i.epil.preheader.i121.i:                  ; preds = %B228.if.preheader2.i.i82.i, %B284.loopexit.unr-lcssa.i.unr-lcssa.i106.i
  %.655272274.i.epil.init.i122.i = phi i64 [ 0, %B228.if.preheader2.i.i82.i ], [ %.662.1.i.1.i100.i, %B284.loopexit.unr-lcssa.i.unr-lcssa.i106.i ]
  %154 = shl i64 %.655272274.i.epil.init.i122.i, 3
  %sunkaddr11.i.epil.i123.i = getelementptr i8, ptr %.926.i, i64 %154
  %.716.i.epil.i124.i = load double, ptr %sunkaddr11.i.epil.i123.i, align 8, !noalias !51
  %scevgep9.i.epil.i.i = getelementptr i8, ptr %scevgep7.i142.i.i, i64 %154
  %scevgep10.i.epil.i.i = getelementptr i8, ptr %scevgep9.i.epil.i.i, i64 -8
  %.746.i.epil.i125.i = load double, ptr %scevgep10.i.epil.i.i, align 8, !noalias !51
  %.748.i.epil.i126.i = fmul contract double %.565.i.i80.i, %.746.i.epil.i125.i
  %.749.i.epil.i127.i = fadd contract double %.716.i.epil.i124.i, %.748.i.epil.i126.i
  store double %.749.i.epil.i127.i, ptr %sunkaddr11.i.epil.i123.i, align 8, !noalias !51
  %.662.1.i.epil.i128.i = add nuw i64 %.655272274.i.epil.init.i122.i, 2
  %sunkaddr14.i.epil.i129.i = getelementptr i8, ptr %sunkaddr11.i.epil.i123.i, i64 8
  %.716.1.i.epil.i130.i = load double, ptr %sunkaddr14.i.epil.i129.i, align 8, !noalias !51
  %.746.1.i.epil.i131.i = load double, ptr %scevgep9.i.epil.i.i, align 8, !noalias !51
  %.748.1.i.epil.i132.i = fmul contract double %.565.i.i80.i, %.746.1.i.epil.i131.i
  %.749.1.i.epil.i133.i = fadd contract double %.716.1.i.epil.i130.i, %.748.1.i.epil.i132.i
  store double %.749.1.i.epil.i133.i, ptr %sunkaddr14.i.epil.i129.i, align 8, !noalias !51
  br label %B284.loopexit.unr-lcssa.i.i107.i

B284.loopexit.unr-lcssa.i.i107.i:                 ; preds = %B228.if.i.epil.preheader.i121.i, %B284.loopexit.unr-lcssa.i.unr-lcssa.i106.i
  %.662.1.i.lcssa.i108.i = phi i64 [ %.662.1.i.epil.i128.i, %B228.if.i.epil.preheader.i121.i ], [ %.662.1.i.1.i100.i, %B284.loopexit.unr-lcssa.i.unr-lcssa.i106.i ]
  br i1 %152, label %B284.i.i115.i, label %B228.if.epil.preheader.i.i109.i

B228.if.epil.preheader.i.i109.i:                  ; preds = %B228.if.preheader.i.i81.i, %B284.loopexit.unr-lcssa.i.i107.i
  %.655272274.epil.init.i.i110.i = phi i64 [ 0, %B228.if.preheader.i.i81.i ], [ %.662.1.i.lcssa.i108.i, %B284.loopexit.unr-lcssa.i.i107.i ]
  %155 = getelementptr double, ptr %.926.i, i64 %.655272274.epil.init.i.i110.i
  %.716.epil.i.i111.i = load double, ptr %155, align 8, !noalias !51
  %156 = getelementptr double, ptr %.498.i.i79.i, i64 %.655272274.epil.init.i.i110.i
  %.746.epil.i.i112.i = load double, ptr %156, align 8, !noalias !51
  %.748.epil.i.i113.i = fmul contract double %.565.i.i80.i, %.746.epil.i.i112.i
  %.749.epil.i.i114.i = fadd contract double %.716.epil.i.i111.i, %.748.epil.i.i113.i
  store double %.749.epil.i.i114.i, ptr %155, align 8, !noalias !51
  br label %B284.i.i115.i

B284.i.i115.i:                                    ; preds = %B130.else.endif.endif.endif.endif.i.i77.i, %B228.if.epil.preheader.i.i109.i, %B284.loopexit.unr-lcssa.i.i107.i
  %exitcond292.not.i.i116.i = icmp eq i64 %.324.i.i66.i, %.2563.i.i
  br i1 %exitcond292.not.i.i116.i, label %B848.endif.endif.i.i, label %B128.if.i.i64.i

B128.if.i.i64.i:                                  ; preds = %B284.i.i115.i, %B128.if.i.preheader.i63.i
  %.317279285.i.i65.i = phi i64 [ %.324.i.i66.i, %B284.i.i115.i ], [ 0, %B128.if.i.preheader.i63.i ]
  %.324.i.i66.i = add nuw nsw i64 %.317279285.i.i65.i, 1
  %.350.i.i67.i = mul nuw nsw i64 %.317279285.i.i65.i, %.542.i.i
  %.352.i.i68.i = add nsw i64 %.350.i.i67.i, %.828.sroa.0.085.i.i
  %.395.i.i69.i = icmp slt i64 %.352.i.i68.i, 0
  %.396.i.i70.i = select i1 %.395.i.i69.i, i64 %.700.i.i, i64 0
  %.397.i.i71.i = add i64 %.396.i.i70.i, %.352.i.i68.i
  %.400.i.i72.i = icmp slt i64 %.397.i.i71.i, 0
  br i1 %.400.i.i72.i, label %B130.else.if.i.i134.i, label %B130.else.endif.i.i73.i, !prof !10

B130.else.if.i.i134.i:                            ; preds = %B128.if.i.i64.i
  br label %B130.else.endif.i.i73.i

B130.else.endif.i.i73.i:                          ; preds = %B130.else.if.i.i134.i, %B128.if.i.i64.i
  %.385.sroa.0.1.i.i74.i = phi i64 [ 0, %B130.else.if.i.i134.i ], [ %.397.i.i71.i, %B128.if.i.i64.i ]
  %.405.not.i.i75.i = icmp slt i64 %.397.i.i71.i, %.700.i.i
  br i1 %.405.not.i.i75.i, label %B130.else.endif.endif.endif.endif.i.i77.i, label %B130.else.endif.if.i.i76.i, !prof !6

B130.else.endif.if.i.i76.i:                       ; preds = %B130.else.endif.i.i73.i
  br label %B130.else.endif.endif.endif.endif.i.i77.i

B130.else.endif.endif.endif.endif.i.i77.i:        ; preds = %B130.else.endif.if.i.i76.i, %B130.else.endif.i.i73.i
  %.385.sroa.0.3.i.i78.i = phi i64 [ %.700.i.i, %B130.else.endif.if.i.i76.i ], [ %.385.sroa.0.1.i.i74.i, %B130.else.endif.i.i73.i ]
  %.498.i.i79.i = getelementptr double, ptr %123, i64 %.385.sroa.0.3.i.i78.i
  %157 = getelementptr double, ptr %153, i64 %.317279285.i.i65.i
  %.565.i.i80.i = load double, ptr %157, align 8, !noalias !51
  br i1 %143, label %B284.i.i115.i, label %B228.if.preheader.i.i81.i

B228.if.preheader.i.i81.i:                        ; preds = %B130.else.endif.endif.endif.endif.i.i77.i
  br i1 %147, label %B228.if.epil.preheader.i.i109.i, label %B228.if.preheader2.i.i82.i

B228.if.preheader2.i.i82.i:                       ; preds = %B228.if.preheader.i.i81.i
  %158 = shl i64 %.385.sroa.0.3.i.i78.i, 3
  %scevgep7.i142.i.i = getelementptr i8, ptr %scevgep6.i141.i.i, i64 %158
  br i1 %148, label %B228.if.i.epil.preheader.i121.i, label %B228.if.i.preheader.i83.i

B228.if.i.preheader.i83.i:                        ; preds = %B228.if.preheader2.i.i82.i
  %scevgep286.i.i = getelementptr i8, ptr %scevgep285.i.i, i64 %158
  br label %B228.if.i.i84.i

B228.if.i.i84.i:                                  ; preds = %B228.if.i.i84.i, %B228.if.i.preheader.i83.i
  %lsr.iv30.i.i = phi i64 [ %lsr.iv.next31.i.i, %B228.if.i.i84.i ], [ %141, %B228.if.i.preheader.i83.i ]
  %.655272274.i.i85.i = phi i64 [ %.662.1.i.1.i100.i, %B228.if.i.i84.i ], [ 0, %B228.if.i.preheader.i83.i ]
  %159 = shl i64 %.655272274.i.i85.i, 3
  %sunkaddr67.i86.i = getelementptr i8, ptr %.926.i, i64 %159
  %.716.i.i87.i = load double, ptr %sunkaddr67.i86.i, align 8, !noalias !51
  %scevgep289.i.i = getelementptr i8, ptr %scevgep286.i.i, i64 %159
  %scevgep48.i.i = getelementptr i8, ptr %scevgep289.i.i, i64 -16
  %scevgep46.i.i = getelementptr i8, ptr %scevgep289.i.i, i64 -24
  %.746.i.i88.i = load double, ptr %scevgep46.i.i, align 8, !noalias !51
  %.748.i.i89.i = fmul contract double %.565.i.i80.i, %.746.i.i88.i
  %.749.i.i90.i = fadd contract double %.716.i.i87.i, %.748.i.i89.i
  store double %.749.i.i90.i, ptr %sunkaddr67.i86.i, align 8, !noalias !51
  %sunkaddr70.i.i = getelementptr i8, ptr %sunkaddr67.i86.i, i64 8
  %.716.1.i.i91.i = load double, ptr %sunkaddr70.i.i, align 8, !noalias !51
  %.746.1.i.i92.i = load double, ptr %scevgep48.i.i, align 8, !noalias !51
  %.748.1.i.i93.i = fmul contract double %.565.i.i80.i, %.746.1.i.i92.i
  %.749.1.i.i94.i = fadd contract double %.716.1.i.i91.i, %.748.1.i.i93.i
  store double %.749.1.i.i94.i, ptr %sunkaddr70.i.i, align 8, !noalias !51
  %sunkaddr73.i95.i = getelementptr i8, ptr %sunkaddr67.i86.i, i64 16
  %.716.i.1.i96.i = load double, ptr %sunkaddr73.i95.i, align 8, !noalias !51
  %scevgep44.i.i = getelementptr i8, ptr %scevgep289.i.i, i64 -8
  %.746.i.1.i97.i = load double, ptr %scevgep44.i.i, align 8, !noalias !51
  %.748.i.1.i98.i = fmul contract double %.565.i.i80.i, %.746.i.1.i97.i
  %.749.i.1.i99.i = fadd contract double %.716.i.1.i96.i, %.748.i.1.i98.i
  store double %.749.i.1.i99.i, ptr %sunkaddr73.i95.i, align 8, !noalias !51
  %.662.1.i.1.i100.i = add i64 %.655272274.i.i85.i, 4
  %sunkaddr74.i.i = shl i64 %.662.1.i.1.i100.i, 3
  %sunkaddr75.i.i = getelementptr i8, ptr %.926.i, i64 %sunkaddr74.i.i
  %sunkaddr76.i101.i = getelementptr i8, ptr %sunkaddr75.i.i, i64 -8
  %.716.1.i.1.i102.i = load double, ptr %sunkaddr76.i101.i, align 8, !noalias !51
  %.746.1.i.1.i103.i = load double, ptr %scevgep289.i.i, align 8, !noalias !51
  %.748.1.i.1.i104.i = fmul contract double %.565.i.i80.i, %.746.1.i.1.i103.i
  %.749.1.i.1.i105.i = fadd contract double %.716.1.i.1.i102.i, %.748.1.i.1.i104.i
  store double %.749.1.i.1.i105.i, ptr %sunkaddr76.i101.i, align 8, !noalias !51
  %lsr.iv.next31.i.i = add i64 %lsr.iv30.i.i, -2
  %niter234.ncmp.1.i.i = icmp eq i64 %lsr.iv.next31.i.i, 0
  br i1 %niter234.ncmp.1.i.i, label %B284.loopexit.unr-lcssa.i.unr-lcssa.i106.i, label %B228.if.i.i84.i

B848.endif.endif.i.i:                             ; preds = %B284.i.i115.i, %B76.i.i61.i
  br i1 %143, label %B1154.i.i, label %B982.if.preheader.i.i

B982.if.preheader.i.i:                            ; preds = %B848.endif.endif.i.i
  br i1 %147, label %B982.if.epil.preheader.i.i, label %B982.if.preheader241.i.i

B982.if.preheader241.i.i:                         ; preds = %B982.if.preheader.i.i
  %160 = inttoptr i64 %.2466.i.i to ptr
  %scevgep299.i.i = getelementptr i8, ptr %160, i64 8
  br label %B982.if.i.i

B982.if.i.i:                                      ; preds = %B982.if.i.i, %B982.if.preheader241.i.i
  %.278413541356.i.i = phi i64 [ %.2791.1.i.i, %B982.if.i.i ], [ 0, %B982.if.preheader241.i.i ]
  %161 = shl i64 %.278413541356.i.i, 3
  %sunkaddr78.i.i = getelementptr i8, ptr %.501.i, i64 %161
  %.2845.i.i = load double, ptr %sunkaddr78.i.i, align 8, !noalias !42
  %scevgep301.i.i = getelementptr i8, ptr %scevgep299.i.i, i64 %161
  %scevgep63.i117.i = getelementptr i8, ptr %scevgep301.i.i, i64 -8
  %.2875.i.i = load double, ptr %scevgep63.i117.i, align 8, !noalias !42
  %.2876.i.i = fmul contract double %.2845.i.i, %.2875.i.i
  %sunkaddr80.i118.i = getelementptr i8, ptr %.926.i, i64 %161
  %.2906.i.i = load double, ptr %sunkaddr80.i118.i, align 8, !noalias !42
  %.2907.i.i = fadd contract double %.2906.i.i, 1.000000e+00
  %.2939.i.i = fmul contract double %.2907.i.i, %.2907.i.i
  %.2940.i.i = fmul contract double %.2876.i.i, %.2939.i.i
  %sunkaddr82.i.i = getelementptr i8, ptr %.784.i, i64 %161
  store double %.2940.i.i, ptr %sunkaddr82.i.i, align 8, !noalias !42
  %.2791.1.i.i = add nuw i64 %.278413541356.i.i, 2
  %sunkaddr85.i.i = getelementptr i8, ptr %sunkaddr78.i.i, i64 8
  %.2845.1.i.i = load double, ptr %sunkaddr85.i.i, align 8, !noalias !42
  %.2875.1.i.i = load double, ptr %scevgep301.i.i, align 8, !noalias !42
  %.2876.1.i.i = fmul contract double %.2845.1.i.i, %.2875.1.i.i
  %sunkaddr88.i119.i = getelementptr i8, ptr %sunkaddr80.i118.i, i64 8
  %.2906.1.i.i = load double, ptr %sunkaddr88.i119.i, align 8, !noalias !42
  %.2907.1.i.i = fadd contract double %.2906.1.i.i, 1.000000e+00
  %.2939.1.i.i = fmul contract double %.2907.1.i.i, %.2907.1.i.i
  %.2940.1.i.i = fmul contract double %.2876.1.i.i, %.2939.1.i.i
  %sunkaddr91.i120.i = getelementptr i8, ptr %sunkaddr82.i.i, i64 8
  store double %.2940.1.i.i, ptr %sunkaddr91.i120.i, align 8, !noalias !42
  %niter240.ncmp.1.i.i = icmp eq i64 %unroll_iter239.i.i, %.2791.1.i.i
  br i1 %niter240.ncmp.1.i.i, label %B1076.loopexit.unr-lcssa.i.i, label %B982.if.i.i

B1108.if.i.i:                                     ; preds = %B1108.if.i.i, %B1108.if.preheader242.i.i
  %.306813471349.i.i = phi i64 [ %.3075.3.i.i, %B1108.if.i.i ], [ 0, %B1108.if.preheader242.i.i ]
  %162 = shl i64 %.306813471349.i.i, 3
  %sunkaddr93.i.i = getelementptr i8, ptr %.501.i, i64 %162
  %.3129.i.i = load double, ptr %sunkaddr93.i.i, align 8, !noalias !42
  %scevgep261.i.i = getelementptr i8, ptr %scevgep255.i.i, i64 %162
  %scevgep29.i.i = getelementptr i8, ptr %scevgep261.i.i, i64 -24
  %.3159.i.i = load double, ptr %scevgep29.i.i, align 8, !noalias !42
  %.3160.i.i = fmul contract double %.3129.i.i, %.3159.i.i
  %sunkaddr95.i20.i = getelementptr i8, ptr %.784.i, i64 %162
  store double %.3160.i.i, ptr %sunkaddr95.i20.i, align 8, !noalias !42
  %sunkaddr98.i21.i = getelementptr i8, ptr %sunkaddr93.i.i, i64 8
  %.3129.1.i.i = load double, ptr %sunkaddr98.i21.i, align 8, !noalias !42
  %scevgep27.i.i = getelementptr i8, ptr %scevgep261.i.i, i64 -16
  %.3159.1.i.i = load double, ptr %scevgep27.i.i, align 8, !noalias !42
  %.3160.1.i.i = fmul contract double %.3129.1.i.i, %.3159.1.i.i
  %sunkaddr101.i.i = getelementptr i8, ptr %sunkaddr95.i20.i, i64 8
  store double %.3160.1.i.i, ptr %sunkaddr101.i.i, align 8, !noalias !42
  %sunkaddr104.i.i = getelementptr i8, ptr %sunkaddr93.i.i, i64 16
  %.3129.2.i.i = load double, ptr %sunkaddr104.i.i, align 8, !noalias !42
  %scevgep25.i.i = getelementptr i8, ptr %scevgep261.i.i, i64 -8
  %.3159.2.i.i = load double, ptr %scevgep25.i.i, align 8, !noalias !42
  %.3160.2.i.i = fmul contract double %.3129.2.i.i, %.3159.2.i.i
  %sunkaddr107.i.i = getelementptr i8, ptr %sunkaddr95.i20.i, i64 16
  store double %.3160.2.i.i, ptr %sunkaddr107.i.i, align 8, !noalias !42
  %.3075.3.i.i = add nuw i64 %.306813471349.i.i, 4
  %sunkaddr110.i.i = getelementptr i8, ptr %sunkaddr93.i.i, i64 24
  %.3129.3.i.i = load double, ptr %sunkaddr110.i.i, align 8, !noalias !42
  %.3159.3.i.i = load double, ptr %scevgep261.i.i, align 8, !noalias !42
  %.3160.3.i.i = fmul contract double %.3129.3.i.i, %.3159.3.i.i
  %sunkaddr113.i.i = getelementptr i8, ptr %sunkaddr95.i20.i, i64 24
  store double %.3160.3.i.i, ptr %sunkaddr113.i.i, align 8, !noalias !42
  %niter.ncmp.3.i.i = icmp eq i64 %unroll_iter.i.i, %.3075.3.i.i
  br i1 %niter.ncmp.3.i.i, label %B1154.loopexit.unr-lcssa.i.i, label %B1108.if.i.i

B1154.endif.i.i:                                  ; preds = %B348.loopexit.i.i.i, %B1154.i.i
  %s0.2.0.lcssa.i.i.i = phi double [ 0.000000e+00, %B1154.i.i ], [ %120, %B348.loopexit.i.i.i ]
  %.3268.i.i = fmul contract double %.3232.i.i, %.3232.i.i
  %.3269.i.i = fmul contract double %.3267.i.i, %.3267.i.i
  %.3270.i.i = fadd contract double %.3268.i.i, %.3269.i.i
  %.3299.i.i = fmul contract double %.3270.i.i, %s0.2.0.lcssa.i.i.i
  %.3301.i.i = fadd contract double %norm.2.11399.i.i, %.3299.i.i
  %exitcond1507.not.i.i = icmp eq i64 %.461.i.i, %.2401.i.i
  br i1 %exitcond1507.not.i.i, label %B1268.i.i, label %B742.if.i.i

_ZN17bnserve_inference6kernel7_source19_contract_quadraticB3v69B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi1E1C7mutable7alignedE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi2EE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi2EE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi2EE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi2EEE.exit.i: ; preds = %B1268.i.i, %B0.endif.endif.endif.endif.endif.i.i, %_ZN17bnserve_inference6kernel7_source16_contract_linearB3v26B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIxLi1E1C7mutable7alignedEd5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi1E1C7mutable7alignedE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi2EE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi2EE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi2EE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi2EEE.exit.i
  %norm.3.0.lcssa.i.i = phi double [ 0.000000e+00, %B0.endif.endif.endif.endif.endif.i.i ], [ 0.000000e+00, %_ZN17bnserve_inference6kernel7_source16_contract_linearB3v26B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIxLi1E1C7mutable7alignedEd5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi1E1C7mutable7alignedE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi2EE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi2EE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi2EE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi2EEE.exit.i ], [ %norm.2.1.lcssa.i.i, %B1268.i.i ]
  %163 = shl i64 %.155910791085.i, 3
  %scevgep.i = getelementptr i8, ptr %3, i64 %163
  store double %norm.3.0.lcssa.i.i, ptr %scevgep.i, align 8, !noalias !0
  %lsr.iv.next.i = add i64 %lsr.iv.i, %.1744.i
  %lsr.iv.next264.i = add i64 %lsr.iv263.i, 56
  %exitcond.not.i = icmp eq i64 %.1473.i, %.1566.i
  br i1 %exitcond.not.i, label %_ZN17bnserve_inference6kernel7_source8contractB2v3B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIxLi1E1C7mutable7alignedE.exit, label %B574.if.i

_ZN17bnserve_inference6kernel7_source8contractB2v3B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIxLi1E1C7mutable7alignedE.exit: ; preds = %_ZN17bnserve_inference6kernel7_source19_contract_quadraticB3v69B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi1E1C7mutable7alignedE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi2EE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi2EE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi2EE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi2EEE.exit.i, %entry
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
!1 = distinct !{!1, !2, !"_ZN17bnserve_inference6kernel7_source8contractB2v3B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIxLi1E1C7mutable7alignedE: %retptr"}
!2 = distinct !{!2, !"_ZN17bnserve_inference6kernel7_source8contractB2v3B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIxLi1E1C7mutable7alignedE"}
!3 = !{!4, !1}
!4 = distinct !{!4, !5, !"_ZN17bnserve_inference6kernel7_source9_geometryB3v22B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!5 = distinct !{!5, !"_ZN17bnserve_inference6kernel7_source9_geometryB3v22B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!6 = !{!"branch_weights", i32 99, i32 1}
!7 = !{!8, !1}
!8 = distinct !{!8, !9, !"_ZN17bnserve_inference6kernel7_source16_contract_linearB3v26B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIxLi1E1C7mutable7alignedEd5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi1E1C7mutable7alignedE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi2EE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi2EE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi2EE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi2EEE: %retptr"}
!9 = distinct !{!9, !"_ZN17bnserve_inference6kernel7_source16_contract_linearB3v26B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIxLi1E1C7mutable7alignedEd5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi1E1C7mutable7alignedE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi2EE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi2EE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi2EE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi2EEE"}
!10 = !{!"branch_weights", i32 1, i32 99}
!11 = !{!12, !8, !1}
!12 = distinct !{!12, !13, !"_ZN17bnserve_inference6kernel5_sums9spline_atB3v62B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dEd5ArrayIdLi1E1C7mutable7alignedExxx: %retptr"}
!13 = distinct !{!13, !"_ZN17bnserve_inference6kernel5_sums9spline_atB3v62B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dEd5ArrayIdLi1E1C7mutable7alignedExxx"}
!14 = !{!15, !8, !1}
!15 = distinct !{!15, !16, !"_ZN17bnserve_inference6kernel5_sums11products_atB3v65B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedEd5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE8UniTupleIxLi3EE8UniTupleIdLi6EE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!16 = distinct !{!16, !"_ZN17bnserve_inference6kernel5_sums11products_atB3v65B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedEd5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE8UniTupleIxLi3EE8UniTupleIdLi6EE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!17 = !{!18, !8, !1}
!18 = distinct !{!18, !19, !"_ZN17bnserve_inference6kernel5_sums8lane_sumB3v67B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!19 = distinct !{!19, !"_ZN17bnserve_inference6kernel5_sums8lane_sumB3v67B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE"}
!20 = !{!"branch_weights", i32 101, i32 99}
!21 = !{!22, !8, !1}
!22 = distinct !{!22, !23, !"_ZN17bnserve_inference6kernel5_sums9add_termsB3v68B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEdd5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!23 = distinct !{!23, !"_ZN17bnserve_inference6kernel5_sums9add_termsB3v68B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEdd5ArrayIdLi1E1C7mutable7alignedE"}
!24 = !{!25, !8, !1}
!25 = distinct !{!25, !26, !"_ZN17bnserve_inference6kernel5_sums6gatherB3v57B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!26 = distinct !{!26, !"_ZN17bnserve_inference6kernel5_sums6gatherB3v57B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!27 = !{!28, !8, !1}
!28 = distinct !{!28, !29, !"_ZN17bnserve_inference6kernel5_sums9errors_atB3v58B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedExx5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!29 = distinct !{!29, !"_ZN17bnserve_inference6kernel5_sums9errors_atB3v58B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedExx5ArrayIdLi1E1C7mutable7alignedE"}
!30 = !{!31, !8, !1}
!31 = distinct !{!31, !32, !"_ZN17bnserve_inference6kernel5_sums9errors_atB3v58B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedExx5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!32 = distinct !{!32, !"_ZN17bnserve_inference6kernel5_sums9errors_atB3v58B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedExx5ArrayIdLi1E1C7mutable7alignedE"}
!33 = !{!34, !8, !1}
!34 = distinct !{!34, !35, !"_ZN17bnserve_inference6kernel5_sums9calibrateB3v59B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!35 = distinct !{!35, !"_ZN17bnserve_inference6kernel5_sums9calibrateB3v59B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!36 = !{!37, !8, !1}
!37 = distinct !{!37, !38, !"_ZN17bnserve_inference6kernel5_sums14fixed_productsB3v60B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedEd5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!38 = distinct !{!38, !"_ZN17bnserve_inference6kernel5_sums14fixed_productsB3v60B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedEd5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!39 = !{!40, !8, !1}
!40 = distinct !{!40, !41, !"_ZN17bnserve_inference6kernel5_sums8lane_sumB3v67B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!41 = distinct !{!41, !"_ZN17bnserve_inference6kernel5_sums8lane_sumB3v67B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE"}
!42 = !{!43, !1}
!43 = distinct !{!43, !44, !"_ZN17bnserve_inference6kernel7_source19_contract_quadraticB3v69B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi1E1C7mutable7alignedE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi2EE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi2EE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi2EE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi2EEE: %retptr"}
!44 = distinct !{!44, !"_ZN17bnserve_inference6kernel7_source19_contract_quadraticB3v69B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi1E1C7mutable7alignedE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi2EE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi2EE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi2EE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi2EEE"}
!45 = distinct !{!45, !46}
!46 = !{!"llvm.loop.unroll.disable"}
!47 = !{!48, !43, !1}
!48 = distinct !{!48, !49, !"_ZN17bnserve_inference6kernel5_sums8lane_sumB3v67B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!49 = distinct !{!49, !"_ZN17bnserve_inference6kernel5_sums8lane_sumB3v67B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE"}
!50 = !{!"branch_weights", i32 -973078528, i32 33554432}
!51 = !{!52, !43, !1}
!52 = distinct !{!52, !53, !"_ZN17bnserve_inference6kernel5_sums9errors_atB3v58B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedExx5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!53 = distinct !{!53, !"_ZN17bnserve_inference6kernel5_sums9errors_atB3v58B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedExx5ArrayIdLi1E1C7mutable7alignedE"}
