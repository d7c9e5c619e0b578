; sources: 1b1b0a9a9f144198ff8ac4cd57b2dce5335e617bdfa4ee58ec13eaeb55fdeecb
; built by: numba 0.68.1, llvmlite 0.50.0, Python 3.11, x86_64
; ModuleID = '<string>'
source_filename = "<string>"


; Function Attrs: nofree norecurse nosync nounwind memory(readwrite, inaccessiblemem: none, target_mem0: none, target_mem1: none)
define noundef i32 @bnserve_factorise(ptr noalias writeonly captures(none) %retptr, ptr noalias readnone captures(none) %excinfo, ptr readonly captures(none) %arg.arguments) local_unnamed_addr #0 {
entry:
  %.1352.i.i.i = alloca ptr, align 8
  %.460.i.i.i.i = alloca ptr, align 8
  %.1330.i.i = alloca ptr, align 8
  %.2277.i.i = alloca ptr, align 8
  %.50.i = getelementptr i8, ptr %arg.arguments, i64 264
  %.51.i = load i64, ptr %.50.i, align 8, !noalias !0
  %.79.i = getelementptr i8, ptr %arg.arguments, i64 32
  %.80.i = load i64, ptr %.79.i, align 8, !noalias !0
  %.109.i = getelementptr i8, ptr %arg.arguments, i64 272
  %.110.i = load i64, ptr %.109.i, align 8, !noalias !0
  %.114.i = inttoptr i64 %.110.i to ptr
  %.249.i.idx = mul i64 %.51.i, 832
  %.249.i = getelementptr i8, ptr %.114.i, i64 %.249.i.idx
  %.311.i = getelementptr i8, ptr %.249.i, i64 2048
  %.375.i = getelementptr i8, ptr %.249.i, i64 2432
  %.437.i = getelementptr i8, ptr %.249.i, i64 2816
  %.499.i = getelementptr i8, ptr %.249.i, i64 3776
  %.561.idx.i = shl i64 %.80.i, 6
  %.561.i = getelementptr i8, ptr %.499.i, i64 %.561.idx.i
  %.628.i = getelementptr i8, ptr %.561.i, i64 256
  %.965.i = getelementptr i8, ptr %arg.arguments, i64 152
  %.1050.i = load i64, ptr %.965.i, align 8, !noalias !0
  %.1130636.not.i = icmp slt i64 %.1050.i, 1
  br i1 %.1130636.not.i, label %_ZN17bnserve_inference13fisher_kernel7_source9factoriseB2v3B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIxLi1E1C7mutable7alignedE.exit, label %B192.if.preheader.i

B192.if.preheader.i:                              ; preds = %entry
  %.935.i = getelementptr i8, ptr %arg.arguments, i64 200
  %.936.i = load i64, ptr %.935.i, align 8, !noalias !0
  %0 = inttoptr i64 %.936.i to ptr
  %.80.i.i = getelementptr i8, ptr %arg.arguments, i64 240
  %.466.i.i = getelementptr i8, ptr %arg.arguments, i64 168
  %.500.i.i = getelementptr i8, ptr %arg.arguments, i64 232
  %.164.i.i = getelementptr i8, ptr %arg.arguments, i64 192
  %.660.i.i = getelementptr i8, ptr %arg.arguments, i64 24
  %sunkaddr20.i.i = getelementptr i8, ptr %arg.arguments, i64 136
  %sunkaddr11.i.i = getelementptr i8, ptr %arg.arguments, i64 128
  %sunkaddr13.i.i = getelementptr i8, ptr %arg.arguments, i64 72
  %sunkaddr.i.i = getelementptr i8, ptr %arg.arguments, i64 8
  %.218.i.i.i = getelementptr i8, ptr %arg.arguments, i64 104
  %.318.i1.i.i = getelementptr i8, ptr %arg.arguments, i64 112
  %.416.i.i.i = getelementptr i8, ptr %arg.arguments, i64 48
  %.895.i.i.i = getelementptr i8, ptr %arg.arguments, i64 40
  %.1376.i.i.i = getelementptr i8, ptr %arg.arguments, i64 96
  %.125.i.i.i.i = getelementptr i8, ptr %arg.arguments, i64 16
  %.162.i.i.i.i = getelementptr i8, ptr %arg.arguments, i64 120
  %.252.i.i.i.i = getelementptr i8, ptr %arg.arguments, i64 80
  %.338.i1.i.i.i = getelementptr i8, ptr %arg.arguments, i64 88
  %sunkaddr.i.i.i.i = getelementptr i8, ptr %arg.arguments, i64 184
  %sunkaddr9.i.i.i.i = getelementptr i8, ptr %arg.arguments, i64 160
  %sunkaddr15.i.i.i.i = getelementptr i8, ptr %.561.i, i64 64
  %sunkaddr22.i.i.i.i = getelementptr i8, ptr %.561.i, i64 8
  %sunkaddr26.i.i.i.i = getelementptr i8, ptr %.561.i, i64 72
  %sunkaddr33.i.i.i.i = getelementptr i8, ptr %.561.i, i64 16
  %sunkaddr34.i.i.i.i = getelementptr i8, ptr %.561.i, i64 80
  %sunkaddr41.i.i.i.i = getelementptr i8, ptr %.561.i, i64 24
  %sunkaddr43.i.i.i.i = getelementptr i8, ptr %.561.i, i64 88
  %sunkaddr52.i.i.i.i = getelementptr i8, ptr %.561.i, i64 32
  %sunkaddr53.i.i.i.i = getelementptr i8, ptr %.561.i, i64 96
  %sunkaddr62.i.i.i.i = getelementptr i8, ptr %.561.i, i64 40
  %sunkaddr63.i.i.i.i = getelementptr i8, ptr %.561.i, i64 104
  %sunkaddr69.i.i.i.i = getelementptr i8, ptr %.561.i, i64 48
  %sunkaddr72.i.i.i.i = getelementptr i8, ptr %.561.i, i64 112
  %sunkaddr77.i.i.i.i = getelementptr i8, ptr %.561.i, i64 56
  %sunkaddr78.i.i.i.i = getelementptr i8, ptr %.561.i, i64 120
  %sunkaddr79.i.i.i.i = getelementptr inbounds nuw i8, ptr %.249.i, i64 64
  %sunkaddr80.i.i.i.i = getelementptr inbounds nuw i8, ptr %.249.i, i64 128
  %sunkaddr81.i.i.i.i = getelementptr inbounds nuw i8, ptr %.249.i, i64 192
  %sunkaddr82.i.i.i.i = getelementptr inbounds nuw i8, ptr %.249.i, i64 256
  %sunkaddr83.i.i.i.i = getelementptr inbounds nuw i8, ptr %.249.i, i64 320
  %sunkaddr84.i.i.i.i = getelementptr inbounds nuw i8, ptr %.249.i, i64 384
  %sunkaddr85.i.i.i.i = getelementptr inbounds nuw i8, ptr %.249.i, i64 448
  %.3521.i.i.i.i = getelementptr i8, ptr %arg.arguments, i64 176
  %1 = getelementptr i8, ptr %.249.i, i64 2056
  %2 = getelementptr i8, ptr %.249.i, i64 2064
  %3 = getelementptr i8, ptr %.249.i, i64 2072
  %4 = getelementptr i8, ptr %.249.i, i64 2080
  %5 = getelementptr i8, ptr %.249.i, i64 2088
  %6 = getelementptr i8, ptr %.249.i, i64 2096
  %7 = getelementptr i8, ptr %.249.i, i64 2104
  %sunkaddr36.i.i.i = getelementptr i8, ptr %arg.arguments, i64 144
  %sunkaddr.i.i.i = getelementptr i8, ptr %.249.i, i64 2368
  %sunkaddr52.i.i.i = getelementptr i8, ptr %arg.arguments, i64 56
  %sunkaddr53.i.i.i = getelementptr i8, ptr %arg.arguments, i64 64
  %scevgep.i21.i.i.i = getelementptr i8, ptr %.249.i, i64 3008
  %.1169.i.i.i.i = getelementptr i8, ptr %.249.i, i64 3584
  %.1205.i.i.i.i = getelementptr i8, ptr %.249.i, i64 3648
  %.1229.i.i.i.i = getelementptr i8, ptr %.249.i, i64 3712
  %.161.i.i.i.i = getelementptr i8, ptr %.249.i, i64 2880
  %.346.i.i.i.i = getelementptr i8, ptr %.249.i, i64 2944
  %.734.i.i.i.i = getelementptr i8, ptr %.249.i, i64 3072
  %.745.i.i.i.i = getelementptr i8, ptr %.249.i, i64 3136
  %.928.i.i.i.i = getelementptr i8, ptr %.249.i, i64 3200
  %.939.i.i.i.i = getelementptr i8, ptr %.249.i, i64 3264
  %.4293.i.i.i.i = getelementptr i8, ptr %.249.i, i64 3328
  %.4304.i.i.i.i = getelementptr i8, ptr %.249.i, i64 3392
  %.4487.i.i.i.i = getelementptr i8, ptr %.249.i, i64 3456
  %.4498.i.i.i.i = getelementptr i8, ptr %.249.i, i64 3520
  %sunkaddr44.i.i = getelementptr i8, ptr %arg.arguments, i64 248
  %sunkaddr17.i.i = getelementptr i8, ptr %arg.arguments, i64 256
  %.164.i9.i.i = getelementptr i8, ptr %arg.arguments, i64 208
  %.256.i.i.i = getelementptr i8, ptr %arg.arguments, i64 216
  %.290.i.i.i = getelementptr i8, ptr %arg.arguments, i64 224
  %scevgep69.i.i.i = getelementptr i8, ptr %.561.i, i64 272
  %scevgep106.i.i.i = getelementptr i8, ptr %.114.i, i64 128
  br label %B192.if.i

B220.i:                                           ; preds = %B192.if.i
  call void @llvm.lifetime.start.p0(ptr nonnull %.1330.i.i), !noalias !0
  call void @llvm.lifetime.start.p0(ptr nonnull %.2277.i.i), !noalias !0
  store ptr null, ptr %.1330.i.i, align 8, !noalias !3
  store ptr null, ptr %.2277.i.i, align 8, !noalias !3
  %.165.i.i = load i64, ptr %.164.i.i, align 8, !noalias !3
  %.255.i.i = load i64, ptr %.79.i, align 8, !noalias !3
  %.285.i.i = load i64, ptr %.466.i.i, align 8, !noalias !3
  tail call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(1352) %.628.i, i8 0, i64 1352, i1 false), !noalias !3
  %.168.i.i = mul nuw nsw i64 %.1136634637.i, 48
  %.169.i.i = add nsw i64 %.165.i.i, %.168.i.i
  %.454.i.i = shl nsw i64 %.255.i.i, 3
  %.492.inv.i.i = icmp sgt i64 %.255.i.i, 0
  %..454.i.i = select i1 %.492.inv.i.i, i64 %.454.i.i, i64 0
  %.5341612.i.i = icmp sgt i64 %..454.i.i, 0
  br i1 %.5341612.i.i, label %B314.if.preheader.i.i, label %B340.i.i

B314.if.preheader.i.i:                            ; preds = %B220.i
  %8 = shl nuw i64 %..454.i.i, 3
  tail call void @llvm.memset.p0.i64(ptr align 8 %.499.i, i8 0, i64 %8, i1 false), !noalias !3
  br label %B340.i.i

B340.i.i:                                         ; preds = %B314.if.preheader.i.i, %B220.i
  %.661.i.i = load i64, ptr %.660.i.i, align 8, !noalias !3
  %.7411631.not.i.i = icmp slt i64 %.661.i.i, 1
  br i1 %.7411631.not.i.i, label %B1140.i.i, label %B412.if.preheader.i.i

B412.if.preheader.i.i:                            ; preds = %B340.i.i
  %9 = inttoptr i64 %.169.i.i to ptr
  %.560.i.i.i = getelementptr i8, ptr %9, i64 24
  %.627.i.i.i = getelementptr i8, ptr %9, i64 8
  %.737.i.i.i = getelementptr i8, ptr %9, i64 16
  %.861.i.i.i = getelementptr i8, ptr %9, i64 32
  %sunkaddr35.i.i.i = getelementptr i8, ptr %9, i64 40
  %10 = icmp eq i64 %.285.i.i, 0
  br label %B412.if.i.i

B550.i.i:                                         ; preds = %B412.if.i.i
  %.940.i.i = load i64, ptr %sunkaddr.i.i, align 8, !noalias !3
  %11 = shl nsw i64 %.940.i.i, 1
  br label %B774.i.i

B774.i.i:                                         ; preds = %B412.if.i.i, %B550.i.i
  %_rows_of_v20__vphi136_0.2.1.i.i = phi i64 [ %11, %B550.i.i ], [ 2, %B412.if.i.i ]
  %.1003.i.i = load i64, ptr %.79.i, align 8, !noalias !3
  %.1034.i.i = load i64, ptr %sunkaddr11.i.i, align 8, !noalias !3
  %.1036.i.i = inttoptr i64 %.1034.i.i to ptr
  %12 = getelementptr i64, ptr %.1036.i.i, i64 %.74716241632.i.i
  %.1112.i.i = load i64, ptr %12, align 8, !noalias !3
  %.1145.i.i = load i64, ptr %sunkaddr13.i.i, align 8, !noalias !3
  %.1004.i.i = shl i64 %.1003.i.i, 3
  %.1149.i.i = add i64 %.1004.i.i, 8
  %.1150.i.i = mul nsw i64 %.1149.i.i, %.1112.i.i
  %.1151.i.i = add nsw i64 %.1145.i.i, %.1150.i.i
  %.1152.i.i = inttoptr i64 %.1151.i.i to ptr
  %.1240.i.i = load i64, ptr %.1152.i.i, align 8, !noalias !3
  %.1244.i.i = mul nsw i64 %.1240.i.i, %_rows_of_v20__vphi136_0.2.1.i.i
  %.1250.i.i = add nsw i64 %.1244.i.i, %used.3.01634.i.i
  %.1280.i.i = load i64, ptr %.50.i, align 8, !noalias !3
  %.1281.i.i = icmp sgt i64 %.1250.i.i, %.1280.i.i
  br i1 %.1281.i.i, label %B814.i.i, label %B828.i.i

B814.i.i:                                         ; preds = %B774.i.i
  store ptr null, ptr %.1330.i.i, align 8, !noalias !3
  call fastcc void @inner_0(ptr nonnull %.1330.i.i, ptr %.114.i, i64 %.1280.i.i, i64 %used.3.01634.i.i, ptr nonnull %.628.i, ptr %.561.i)
  br label %B828.i.i

B828.i.i:                                         ; preds = %B814.i.i, %B774.i.i
  %used.5.1.i.i = phi i64 [ 0, %B814.i.i ], [ %used.3.01634.i.i, %B774.i.i ]
  %.184.i.i.i = load i64, ptr %.50.i, align 8, !noalias !6
  %.185.i.i.i = shl nsw i64 %.184.i.i.i, 3
  %.219.i.i.i = load i64, ptr %.218.i.i.i, align 8, !noalias !6
  %.222.i.i.i = shl nsw i64 %.74716241632.i.i, 6
  %.223.i.i.i = add nsw i64 %.219.i.i.i, %.222.i.i.i
  %.224.i.i.i = inttoptr i64 %.223.i.i.i to ptr
  %.282.i.i.i = load <8 x double>, ptr %.224.i.i.i, align 8, !noalias !6
  %.319.i2.i.i = load i64, ptr %.318.i1.i.i, align 8, !noalias !6
  %.323.i.i.i = add nsw i64 %.319.i2.i.i, %.222.i.i.i
  %.324.i.i.i = inttoptr i64 %.323.i.i.i to ptr
  %.380.i.i.i = load <8 x double>, ptr %.324.i.i.i, align 8, !noalias !6
  %.417.i.i.i = load i64, ptr %.416.i.i.i, align 8, !noalias !6
  %.418.i.i.i = inttoptr i64 %.417.i.i.i to ptr
  %.501.i.i.i = load double, ptr %.418.i.i.i, align 8, !noalias !6
  %.530.i.i.i = getelementptr i8, ptr %.418.i.i.i, i64 8
  %.531.i.i.i = load double, ptr %.530.i.i.i, align 8, !noalias !6
  %.561.i.i.i = load double, ptr %.560.i.i.i, align 8, !noalias !6
  %.562.i.i.i = fmul contract double %.531.i.i.i, %.561.i.i.i
  %.563.i.i.i = fadd contract double %.501.i.i.i, %.562.i.i.i
  %.593.i.i.i = load double, ptr %9, align 8, !noalias !6
  %.594.i.i.i = fsub contract double %.563.i.i.i, %.593.i.i.i
  %.628.i.i.i = load double, ptr %.627.i.i.i, align 8, !noalias !6
  %.629.i.i.i = tail call contract double @llvm.fma.f64(double %.628.i.i.i, double 0x3FE45F306DC9C883, double 0x4338000000000000)
  %.630.i.i.i = fadd contract double %.629.i.i.i, 0xC338000000000000
  %.645.i.i.i = tail call contract double @llvm.fma.f64(double %.630.i.i.i, double 0xBFF921FB54442D18, double %.628.i.i.i)
  %.660.i.i.i = tail call contract double @llvm.fma.f64(double %.630.i.i.i, double 0xBC91A62633145C07, double %.645.i.i.i)
  %.661.i.i.i = fmul contract double %.660.i.i.i, %.660.i.i.i
  %.662.i.i.i = tail call contract double @llvm.fma.f64(double %.661.i.i.i, double 0xBD6AE7F3E733B81F, double 0x3DE6124613A86D09)
  %.663.i.i.i = tail call contract double @llvm.fma.f64(double %.661.i.i.i, double %.662.i.i.i, double 0xBE5AE64567F544E4)
  %.664.i.i.i = tail call contract double @llvm.fma.f64(double %.661.i.i.i, double %.663.i.i.i, double 0x3EC71DE3A556C734)
  %.665.i.i.i = tail call contract double @llvm.fma.f64(double %.661.i.i.i, double %.664.i.i.i, double 0xBF2A01A01A01A01A)
  %.666.i.i.i = tail call contract double @llvm.fma.f64(double %.661.i.i.i, double %.665.i.i.i, double 0x3F81111111111111)
  %.667.i.i.i = tail call contract double @llvm.fma.f64(double %.661.i.i.i, double %.666.i.i.i, double 0xBFC5555555555555)
  %.668.i.i.i = fmul contract double %.660.i.i.i, %.661.i.i.i
  %.669.i.i.i = tail call contract double @llvm.fma.f64(double %.668.i.i.i, double %.667.i.i.i, double %.660.i.i.i)
  %.670.i.i.i = tail call contract double @llvm.fma.f64(double %.661.i.i.i, double 0x3D2AE7F3E733B81F, double 0xBDA93974A8C07C9D)
  %.671.i.i.i = tail call contract double @llvm.fma.f64(double %.661.i.i.i, double %.670.i.i.i, double 0x3E21EED8EFF8D898)
  %.672.i.i.i = tail call contract double @llvm.fma.f64(double %.661.i.i.i, double %.671.i.i.i, double 0xBE927E4FB7789F5C)
  %.673.i.i.i = tail call contract double @llvm.fma.f64(double %.661.i.i.i, double %.672.i.i.i, double 0x3EFA01A01A01A01A)
  %.674.i.i.i = tail call contract double @llvm.fma.f64(double %.661.i.i.i, double %.673.i.i.i, double 0xBF56C16C16C16C17)
  %.675.i.i.i = tail call contract double @llvm.fma.f64(double %.661.i.i.i, double %.674.i.i.i, double 0x3FA5555555555555)
  %.676.i.i.i = tail call contract double @llvm.fma.f64(double %.661.i.i.i, double %.675.i.i.i, double -5.000000e-01)
  %.677.i.i.i = tail call contract double @llvm.fma.f64(double %.661.i.i.i, double %.676.i.i.i, double 1.000000e+00)
  %.678.i.i.i = bitcast double %.629.i.i.i to i64
  %.679.i.i.i = bitcast double %.669.i.i.i to i64
  %.680.i.i.i = bitcast double %.677.i.i.i to i64
  %.681.i.i.i = xor i64 %.680.i.i.i, %.679.i.i.i
  %.682.i.i.i = and i64 %.678.i.i.i, 1
  %13 = icmp eq i64 %.682.i.i.i, 0
  %.684.i.i.i = select i1 %13, i64 0, i64 %.681.i.i.i
  %.685.i.i.i = shl i64 %.678.i.i.i, 62
  %.686.i.i.i = and i64 %.685.i.i.i, -9223372036854775808
  %.688.i.i.i = add i64 %.685.i.i.i, 4611686018427387904
  %.689.i.i.i = and i64 %.688.i.i.i, -9223372036854775808
  %14 = xor i64 %.686.i.i.i, %.679.i.i.i
  %.691.i.i.i = xor i64 %14, %.684.i.i.i
  %.692.i.i.i = bitcast i64 %.691.i.i.i to double
  %15 = xor i64 %.689.i.i.i, %.680.i.i.i
  %.694.i.i.i = xor i64 %15, %.684.i.i.i
  %.695.i.i.i = bitcast i64 %.694.i.i.i to double
  %.738.i.i.i = load double, ptr %.737.i.i.i, align 8, !noalias !6
  %.739.i.i.i = fmul contract double %.738.i.i.i, 2.000000e+00
  %.740.i.i.i = tail call contract double @llvm.fma.f64(double %.739.i.i.i, double 0x3FE45F306DC9C883, double 0x4338000000000000)
  %.741.i.i.i = fadd contract double %.740.i.i.i, 0xC338000000000000
  %.756.i.i.i = tail call contract double @llvm.fma.f64(double %.741.i.i.i, double 0xBFF921FB54442D18, double %.739.i.i.i)
  %.771.i.i.i = tail call contract double @llvm.fma.f64(double %.741.i.i.i, double 0xBC91A62633145C07, double %.756.i.i.i)
  %.772.i.i.i = fmul contract double %.771.i.i.i, %.771.i.i.i
  %.773.i.i.i = tail call contract double @llvm.fma.f64(double %.772.i.i.i, double 0xBD6AE7F3E733B81F, double 0x3DE6124613A86D09)
  %.774.i.i.i = tail call contract double @llvm.fma.f64(double %.772.i.i.i, double %.773.i.i.i, double 0xBE5AE64567F544E4)
  %.775.i.i.i = tail call contract double @llvm.fma.f64(double %.772.i.i.i, double %.774.i.i.i, double 0x3EC71DE3A556C734)
  %.776.i.i.i = tail call contract double @llvm.fma.f64(double %.772.i.i.i, double %.775.i.i.i, double 0xBF2A01A01A01A01A)
  %.777.i.i.i = tail call contract double @llvm.fma.f64(double %.772.i.i.i, double %.776.i.i.i, double 0x3F81111111111111)
  %.778.i.i.i = tail call contract double @llvm.fma.f64(double %.772.i.i.i, double %.777.i.i.i, double 0xBFC5555555555555)
  %.779.i.i.i = fmul contract double %.771.i.i.i, %.772.i.i.i
  %.780.i.i.i = tail call contract double @llvm.fma.f64(double %.779.i.i.i, double %.778.i.i.i, double %.771.i.i.i)
  %.781.i.i.i = tail call contract double @llvm.fma.f64(double %.772.i.i.i, double 0x3D2AE7F3E733B81F, double 0xBDA93974A8C07C9D)
  %.782.i.i.i = tail call contract double @llvm.fma.f64(double %.772.i.i.i, double %.781.i.i.i, double 0x3E21EED8EFF8D898)
  %.783.i.i.i = tail call contract double @llvm.fma.f64(double %.772.i.i.i, double %.782.i.i.i, double 0xBE927E4FB7789F5C)
  %.784.i.i.i = tail call contract double @llvm.fma.f64(double %.772.i.i.i, double %.783.i.i.i, double 0x3EFA01A01A01A01A)
  %.785.i.i.i = tail call contract double @llvm.fma.f64(double %.772.i.i.i, double %.784.i.i.i, double 0xBF56C16C16C16C17)
  %.786.i.i.i = tail call contract double @llvm.fma.f64(double %.772.i.i.i, double %.785.i.i.i, double 0x3FA5555555555555)
  %.787.i.i.i = tail call contract double @llvm.fma.f64(double %.772.i.i.i, double %.786.i.i.i, double -5.000000e-01)
  %.788.i.i.i = tail call contract double @llvm.fma.f64(double %.772.i.i.i, double %.787.i.i.i, double 1.000000e+00)
  %.789.i.i.i = bitcast double %.740.i.i.i to i64
  %.790.i.i.i = bitcast double %.780.i.i.i to i64
  %.791.i.i.i = bitcast double %.788.i.i.i to i64
  %.792.i.i.i = xor i64 %.791.i.i.i, %.790.i.i.i
  %.793.i.i.i = and i64 %.789.i.i.i, 1
  %16 = icmp eq i64 %.793.i.i.i, 0
  %.795.i.i.i = select i1 %16, i64 0, i64 %.792.i.i.i
  %.796.i.i.i = shl i64 %.789.i.i.i, 62
  %.797.i.i.i = and i64 %.796.i.i.i, -9223372036854775808
  %.799.i.i.i = add i64 %.796.i.i.i, 4611686018427387904
  %.800.i.i.i = and i64 %.799.i.i.i, -9223372036854775808
  %17 = xor i64 %.797.i.i.i, %.790.i.i.i
  %.802.i.i.i = xor i64 %17, %.795.i.i.i
  %.803.i.i.i = bitcast i64 %.802.i.i.i to double
  %18 = xor i64 %.800.i.i.i, %.791.i.i.i
  %.805.i.i.i = xor i64 %18, %.795.i.i.i
  %.862.i.i.i = load double, ptr %.861.i.i.i, align 8, !noalias !6
  %.896.i.i.i = load i64, ptr %.895.i.i.i, align 8, !noalias !6
  %.938.i.i.i = load i64, ptr %.79.i, align 8, !noalias !6
  %.969.i.i.i = load i64, ptr %sunkaddr11.i.i, align 8, !noalias !6
  %.971.i.i.i = inttoptr i64 %.969.i.i.i to ptr
  %19 = getelementptr i64, ptr %.971.i.i.i, i64 %.74716241632.i.i
  %.1047.i.i.i = load i64, ptr %19, align 8, !noalias !6
  %.1080.i.i.i = load i64, ptr %sunkaddr13.i.i, align 8, !noalias !6
  %.939.i.i.i = shl i64 %.938.i.i.i, 3
  %.1084.i.i.i = add i64 %.939.i.i.i, 8
  %.1085.i.i.i = mul nsw i64 %.1084.i.i.i, %.1047.i.i.i
  %.1086.i.i.i = add nsw i64 %.1080.i.i.i, %.1085.i.i.i
  %.1195.i.i.i = load i64, ptr %sunkaddr20.i.i, align 8, !noalias !6
  %.1197.i.i.i = inttoptr i64 %.1195.i.i.i to ptr
  %20 = getelementptr i64, ptr %.1197.i.i.i, i64 %.74716241632.i.i
  %.1273.i.i.i = load i64, ptr %20, align 8, !noalias !6
  %.1277.i.i.i = icmp eq i64 %.1273.i.i.i, 1
  br i1 %.1277.i.i.i, label %B928.i.i.i, label %B1040.i.i.i

B928.i.i.i:                                       ; preds = %B828.i.i
  %.1308.i.i.i = load i64, ptr %sunkaddr.i.i, align 8, !noalias !6
  br label %B1040.i.i.i

B1040.i.i.i:                                      ; preds = %B928.i.i.i, %B828.i.i
  %_rows_of_v244__vphi136_0.2.0.i.i.i = phi i64 [ %.1308.i.i.i, %B928.i.i.i ], [ 1, %B828.i.i ]
  %.not.i.i.i = icmp eq i64 %.896.i.i.i, 1
  %.1407.i.i.i = load i64, ptr %sunkaddr.i.i, align 8, !noalias !6
  %.1674.i.i.i = insertelement <8 x double> poison, double %.594.i.i.i, i64 0
  %.1675.i.i.i = shufflevector <8 x double> %.1674.i.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %21 = shl i64 %used.5.1.i.i, 3
  %.1571890.i.i.i = icmp sgt i64 %.1407.i.i.i, 0
  br i1 %.1571890.i.i.i, label %B1244.lr.ph.i.i.i, label %_ZN17bnserve_inference13fisher_kernel7_source11_fill_panelB4v231B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxx5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE52_Room_28array_28float64_2c_201d_2c_20C_29_20x_208_29.exit.i.i

B1156.loopexit.i.i.i:                             ; preds = %B8131.i.i.i, %B1298.i.i.i
  %.1571.i.i.i = icmp sgt i64 %.15702592895.i.i.i, 0
  %.1584.i.i.i = zext i1 %.1571.i.i.i to i64
  %.15772639.i.i.i = add i64 %.15772639894.i.i.i, %.1584.i.i.i
  %.1580.i.i.i = sext i1 %.1571.i.i.i to i64
  %.15702592.i.i.i = add nsw i64 %.15702592895.i.i.i, %.1580.i.i.i
  %.1561.sroa.0.0.i.i.i = select i1 %.1571.i.i.i, i64 %.15772639894.i.i.i, i64 0
  br i1 %.1571.i.i.i, label %B1244.i.i.i, label %_ZN17bnserve_inference13fisher_kernel7_source11_fill_panelB4v231B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxx5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE52_Room_28array_28float64_2c_201d_2c_20C_29_20x_208_29.exit.i.i

B1244.i.i.i:                                      ; preds = %B1244.lr.ph.i.i.i, %B1156.loopexit.i.i.i
  %.1561.sroa.0.0896.i.i.i = phi i64 [ 0, %B1244.lr.ph.i.i.i ], [ %.1561.sroa.0.0.i.i.i, %B1156.loopexit.i.i.i ]
  %.15702592895.i.i.i = phi i64 [ %.15702592893.i.i.i, %B1244.lr.ph.i.i.i ], [ %.15702592.i.i.i, %B1156.loopexit.i.i.i ]
  %.15772639894.i.i.i = phi i64 [ 1, %B1244.lr.ph.i.i.i ], [ %.15772639.i.i.i, %B1156.loopexit.i.i.i ]
  %.96.i.i.i.i = load i64, ptr %arg.arguments, align 8, !noalias !9
  %.126.i.i.i.i = load i64, ptr %.125.i.i.i.i, align 8, !noalias !9
  %.163.i.i.i.i = load i64, ptr %.162.i.i.i.i, align 8, !noalias !9
  %.253.i.i.i.i = load i64, ptr %.252.i.i.i.i, align 8, !noalias !9
  %.339.i.i.i.i = load i64, ptr %.338.i1.i.i.i, align 8, !noalias !9
  %.342.i.i.i.i = inttoptr i64 %.339.i.i.i.i to ptr
  %22 = tail call i64 @llvm.smin.i64(i64 %.1561.sroa.0.0896.i.i.i, i64 -1)
  %23 = getelementptr i64, ptr %.342.i.i.i.i, i64 %.1561.sroa.0.0896.i.i.i
  %24 = getelementptr i64, ptr %23, i64 %22
  %.418.i.i.i.i = getelementptr i8, ptr %24, i64 8
  %.419.i.i.i.i = load i64, ptr %.418.i.i.i.i, align 8, !noalias !9
  %.455.i.i.i.i = load i64, ptr %.466.i.i, align 8, !noalias !9
  %.456.i.i.i.i = icmp eq i64 %.455.i.i.i.i, 0
  %25 = select i1 %.456.i.i.i.i, i64 256, i64 2048
  tail call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(256) %.249.i, i8 0, i64 %25, i1 false), !noalias !9
  %.770.i.i.i.i = mul nsw i64 %.96.i.i.i.i, %.1136634637.i
  %.897.i.i.i.i = shl i64 %.126.i.i.i.i, 4
  %.693571.i.i.i.i = icmp sgt i64 %.96.i.i.i.i, 0
  br i1 %.693571.i.i.i.i, label %B538.preheader.i.i.i.i, label %B1650.i.i.i.i

B538.preheader.i.i.i.i:                           ; preds = %B1244.i.i.i
  %26 = mul i64 %.126.i.i.i.i, 96
  %27 = inttoptr i64 %.253.i.i.i.i to ptr
  %sunkaddr10.i.i.i.i = inttoptr i64 %.163.i.i.i.i to ptr
  %sunkaddr14.i.i.i.i = getelementptr i8, ptr %sunkaddr10.i.i.i.i, i64 %.222.i.i.i
  %sunkaddr21.i.i.i.i = getelementptr i8, ptr %sunkaddr14.i.i.i.i, i64 8
  %sunkaddr29.i.i.i.i = getelementptr i8, ptr %sunkaddr14.i.i.i.i, i64 16
  %sunkaddr40.i.i.i.i = getelementptr i8, ptr %sunkaddr14.i.i.i.i, i64 24
  %sunkaddr48.i.i.i.i = getelementptr i8, ptr %sunkaddr14.i.i.i.i, i64 32
  %sunkaddr59.i.i.i.i = getelementptr i8, ptr %sunkaddr14.i.i.i.i, i64 40
  %sunkaddr68.i.i.i.i = getelementptr i8, ptr %sunkaddr14.i.i.i.i, i64 48
  %sunkaddr76.i.i.i.i = getelementptr i8, ptr %sunkaddr14.i.i.i.i, i64 56
  br label %B538.i.i.i.i

B538.i.i.i.i:                                     ; preds = %B1646.i.i.i.i, %B538.preheader.i.i.i.i
  %.683.sroa.0.0576.i.i.i.i = phi i64 [ %.683.sroa.0.0.i.i.i.i, %B1646.i.i.i.i ], [ 0, %B538.preheader.i.i.i.i ]
  %.640.1575.in.i.i.i.i = phi i64 [ %72, %B1646.i.i.i.i ], [ %.96.i.i.i.i, %B538.preheader.i.i.i.i ]
  %.637.1574.i.i.i.i = phi i64 [ %.637.1.i.i.i.i, %B1646.i.i.i.i ], [ 1, %B538.preheader.i.i.i.i ]
  %.748.i.i.i.i = icmp slt i64 %.683.sroa.0.0576.i.i.i.i, 0
  %.749.i.i.i.i = select i1 %.748.i.i.i.i, i64 %.96.i.i.i.i, i64 0
  %28 = getelementptr i64, ptr %27, i64 %.683.sroa.0.0576.i.i.i.i
  %.763.i.i.i.i = getelementptr i64, ptr %28, i64 %.749.i.i.i.i
  %.764.i.i.i.i = load i64, ptr %.763.i.i.i.i, align 8, !noalias !9
  %.766.i.i.i.i = icmp eq i64 %.764.i.i.i.i, %.1561.sroa.0.0896.i.i.i
  br i1 %.766.i.i.i.i, label %B566.i.i.i.i, label %B1646.i.i.i.i

B566.i.i.i.i:                                     ; preds = %B538.i.i.i.i
  %.772.i.i.i.i = add nsw i64 %.683.sroa.0.0576.i.i.i.i, %.770.i.i.i.i
  %.806.i.i.i.i = load i64, ptr %sunkaddr.i.i.i.i, align 8, !noalias !9
  %.809.i.i.i.i = mul nsw i64 %.772.i.i.i.i, 48
  %.810.i.i.i.i = add nsw i64 %.806.i.i.i.i, %.809.i.i.i.i
  %.811.i.i.i.i = inttoptr i64 %.810.i.i.i.i to ptr
  %.895.i.i.i.i = load i64, ptr %sunkaddr9.i.i.i.i, align 8, !noalias !9
  %.899.i.i.i.i = mul nsw i64 %.772.i.i.i.i, %.897.i.i.i.i
  %.900.i.i.i.i = add nsw i64 %.895.i.i.i.i, %.899.i.i.i.i
  %.922.i.i.i.i = inttoptr i64 %.900.i.i.i.i to ptr
  %.1122.i.i.i.i = load i64, ptr %sunkaddr14.i.i.i.i, align 8, !noalias !9
  %29 = lshr i64 %.1122.i.i.i.i, 33
  %.1138.i.i.i.i = and i64 %29, 1073741824
  %.idx2167.i.i.i.i = shl i64 %.1122.i.i.i.i, 4
  %30 = getelementptr i8, ptr %.922.i.i.i.i, i64 %.idx2167.i.i.i.i
  %.1152.i.i.i.i = getelementptr double, ptr %30, i64 %.1138.i.i.i.i
  %.1153.i.i.i.i = load double, ptr %.1152.i.i.i.i, align 8, !noalias !9
  store double %.1153.i.i.i.i, ptr %.561.i, align 8, !noalias !9
  %.1213.i.i.i.i = load i64, ptr %sunkaddr14.i.i.i.i, align 8, !noalias !9
  %31 = lshr i64 %.1213.i.i.i.i, 33
  %.1230.i.i.i.i = and i64 %31, 1073741824
  %.idx2168.i.i.i.i = shl i64 %.1213.i.i.i.i, 4
  %32 = getelementptr i8, ptr %.922.i.i.i.i, i64 %.idx2168.i.i.i.i
  %33 = getelementptr i8, ptr %32, i64 8
  %.1244.i.i.i.i = getelementptr double, ptr %33, i64 %.1230.i.i.i.i
  %.1245.i.i.i.i = load double, ptr %.1244.i.i.i.i, align 8, !noalias !9
  store double %.1245.i.i.i.i, ptr %sunkaddr15.i.i.i.i, align 8, !noalias !9
  %.1122.1.i.i.i.i = load i64, ptr %sunkaddr21.i.i.i.i, align 8, !noalias !9
  %34 = lshr i64 %.1122.1.i.i.i.i, 33
  %.1138.1.i.i.i.i = and i64 %34, 1073741824
  %.idx2167.1.i.i.i.i = shl i64 %.1122.1.i.i.i.i, 4
  %35 = getelementptr i8, ptr %.922.i.i.i.i, i64 %.idx2167.1.i.i.i.i
  %.1152.1.i.i.i.i = getelementptr double, ptr %35, i64 %.1138.1.i.i.i.i
  %.1153.1.i.i.i.i = load double, ptr %.1152.1.i.i.i.i, align 8, !noalias !9
  store double %.1153.1.i.i.i.i, ptr %sunkaddr22.i.i.i.i, align 8, !noalias !9
  %.1213.1.i.i.i.i = load i64, ptr %sunkaddr21.i.i.i.i, align 8, !noalias !9
  %36 = lshr i64 %.1213.1.i.i.i.i, 33
  %.1230.1.i.i.i.i = and i64 %36, 1073741824
  %.idx2168.1.i.i.i.i = shl i64 %.1213.1.i.i.i.i, 4
  %37 = getelementptr i8, ptr %.922.i.i.i.i, i64 %.idx2168.1.i.i.i.i
  %38 = getelementptr i8, ptr %37, i64 8
  %.1244.1.i.i.i.i = getelementptr double, ptr %38, i64 %.1230.1.i.i.i.i
  %.1245.1.i.i.i.i = load double, ptr %.1244.1.i.i.i.i, align 8, !noalias !9
  store double %.1245.1.i.i.i.i, ptr %sunkaddr26.i.i.i.i, align 8, !noalias !9
  %.1122.2.i.i.i.i = load i64, ptr %sunkaddr29.i.i.i.i, align 8, !noalias !9
  %39 = lshr i64 %.1122.2.i.i.i.i, 33
  %.1138.2.i.i.i.i = and i64 %39, 1073741824
  %.idx2167.2.i.i.i.i = shl i64 %.1122.2.i.i.i.i, 4
  %40 = getelementptr i8, ptr %.922.i.i.i.i, i64 %.idx2167.2.i.i.i.i
  %.1152.2.i.i.i.i = getelementptr double, ptr %40, i64 %.1138.2.i.i.i.i
  %.1153.2.i.i.i.i = load double, ptr %.1152.2.i.i.i.i, align 8, !noalias !9
  store double %.1153.2.i.i.i.i, ptr %sunkaddr33.i.i.i.i, align 8, !noalias !9
  %.1213.2.i.i.i.i = load i64, ptr %sunkaddr29.i.i.i.i, align 8, !noalias !9
  %41 = lshr i64 %.1213.2.i.i.i.i, 33
  %.1230.2.i.i.i.i = and i64 %41, 1073741824
  %.idx2168.2.i.i.i.i = shl i64 %.1213.2.i.i.i.i, 4
  %42 = getelementptr i8, ptr %.922.i.i.i.i, i64 %.idx2168.2.i.i.i.i
  %43 = getelementptr i8, ptr %42, i64 8
  %.1244.2.i.i.i.i = getelementptr double, ptr %43, i64 %.1230.2.i.i.i.i
  %.1245.2.i.i.i.i = load double, ptr %.1244.2.i.i.i.i, align 8, !noalias !9
  store double %.1245.2.i.i.i.i, ptr %sunkaddr34.i.i.i.i, align 8, !noalias !9
  %.1122.3.i.i.i.i = load i64, ptr %sunkaddr40.i.i.i.i, align 8, !noalias !9
  %44 = lshr i64 %.1122.3.i.i.i.i, 33
  %.1138.3.i.i.i.i = and i64 %44, 1073741824
  %.idx2167.3.i.i.i.i = shl i64 %.1122.3.i.i.i.i, 4
  %45 = getelementptr i8, ptr %.922.i.i.i.i, i64 %.idx2167.3.i.i.i.i
  %.1152.3.i.i.i.i = getelementptr double, ptr %45, i64 %.1138.3.i.i.i.i
  %.1153.3.i.i.i.i = load double, ptr %.1152.3.i.i.i.i, align 8, !noalias !9
  store double %.1153.3.i.i.i.i, ptr %sunkaddr41.i.i.i.i, align 8, !noalias !9
  %.1213.3.i.i.i.i = load i64, ptr %sunkaddr40.i.i.i.i, align 8, !noalias !9
  %46 = lshr i64 %.1213.3.i.i.i.i, 33
  %.1230.3.i.i.i.i = and i64 %46, 1073741824
  %.idx2168.3.i.i.i.i = shl i64 %.1213.3.i.i.i.i, 4
  %47 = getelementptr i8, ptr %.922.i.i.i.i, i64 %.idx2168.3.i.i.i.i
  %48 = getelementptr i8, ptr %47, i64 8
  %.1244.3.i.i.i.i = getelementptr double, ptr %48, i64 %.1230.3.i.i.i.i
  %.1245.3.i.i.i.i = load double, ptr %.1244.3.i.i.i.i, align 8, !noalias !9
  store double %.1245.3.i.i.i.i, ptr %sunkaddr43.i.i.i.i, align 8, !noalias !9
  %.1122.4.i.i.i.i = load i64, ptr %sunkaddr48.i.i.i.i, align 8, !noalias !9
  %49 = lshr i64 %.1122.4.i.i.i.i, 33
  %.1138.4.i.i.i.i = and i64 %49, 1073741824
  %.idx2167.4.i.i.i.i = shl i64 %.1122.4.i.i.i.i, 4
  %50 = getelementptr i8, ptr %.922.i.i.i.i, i64 %.idx2167.4.i.i.i.i
  %.1152.4.i.i.i.i = getelementptr double, ptr %50, i64 %.1138.4.i.i.i.i
  %.1153.4.i.i.i.i = load double, ptr %.1152.4.i.i.i.i, align 8, !noalias !9
  store double %.1153.4.i.i.i.i, ptr %sunkaddr52.i.i.i.i, align 8, !noalias !9
  %.1213.4.i.i.i.i = load i64, ptr %sunkaddr48.i.i.i.i, align 8, !noalias !9
  %51 = lshr i64 %.1213.4.i.i.i.i, 33
  %.1230.4.i.i.i.i = and i64 %51, 1073741824
  %.idx2168.4.i.i.i.i = shl i64 %.1213.4.i.i.i.i, 4
  %52 = getelementptr i8, ptr %.922.i.i.i.i, i64 %.idx2168.4.i.i.i.i
  %53 = getelementptr i8, ptr %52, i64 8
  %.1244.4.i.i.i.i = getelementptr double, ptr %53, i64 %.1230.4.i.i.i.i
  %.1245.4.i.i.i.i = load double, ptr %.1244.4.i.i.i.i, align 8, !noalias !9
  store double %.1245.4.i.i.i.i, ptr %sunkaddr53.i.i.i.i, align 8, !noalias !9
  %.1122.5.i.i.i.i = load i64, ptr %sunkaddr59.i.i.i.i, align 8, !noalias !9
  %54 = lshr i64 %.1122.5.i.i.i.i, 33
  %.1138.5.i.i.i.i = and i64 %54, 1073741824
  %.idx2167.5.i.i.i.i = shl i64 %.1122.5.i.i.i.i, 4
  %55 = getelementptr i8, ptr %.922.i.i.i.i, i64 %.idx2167.5.i.i.i.i
  %.1152.5.i.i.i.i = getelementptr double, ptr %55, i64 %.1138.5.i.i.i.i
  %.1153.5.i.i.i.i = load double, ptr %.1152.5.i.i.i.i, align 8, !noalias !9
  store double %.1153.5.i.i.i.i, ptr %sunkaddr62.i.i.i.i, align 8, !noalias !9
  %.1213.5.i.i.i.i = load i64, ptr %sunkaddr59.i.i.i.i, align 8, !noalias !9
  %56 = lshr i64 %.1213.5.i.i.i.i, 33
  %.1230.5.i.i.i.i = and i64 %56, 1073741824
  %.idx2168.5.i.i.i.i = shl i64 %.1213.5.i.i.i.i, 4
  %57 = getelementptr i8, ptr %.922.i.i.i.i, i64 %.idx2168.5.i.i.i.i
  %58 = getelementptr i8, ptr %57, i64 8
  %.1244.5.i.i.i.i = getelementptr double, ptr %58, i64 %.1230.5.i.i.i.i
  %.1245.5.i.i.i.i = load double, ptr %.1244.5.i.i.i.i, align 8, !noalias !9
  store double %.1245.5.i.i.i.i, ptr %sunkaddr63.i.i.i.i, align 8, !noalias !9
  %.1122.6.i.i.i.i = load i64, ptr %sunkaddr68.i.i.i.i, align 8, !noalias !9
  %59 = lshr i64 %.1122.6.i.i.i.i, 33
  %.1138.6.i.i.i.i = and i64 %59, 1073741824
  %.idx2167.6.i.i.i.i = shl i64 %.1122.6.i.i.i.i, 4
  %60 = getelementptr i8, ptr %.922.i.i.i.i, i64 %.idx2167.6.i.i.i.i
  %.1152.6.i.i.i.i = getelementptr double, ptr %60, i64 %.1138.6.i.i.i.i
  %.1153.6.i.i.i.i = load double, ptr %.1152.6.i.i.i.i, align 8, !noalias !9
  store double %.1153.6.i.i.i.i, ptr %sunkaddr69.i.i.i.i, align 8, !noalias !9
  %.1213.6.i.i.i.i = load i64, ptr %sunkaddr68.i.i.i.i, align 8, !noalias !9
  %61 = lshr i64 %.1213.6.i.i.i.i, 33
  %.1230.6.i.i.i.i = and i64 %61, 1073741824
  %.idx2168.6.i.i.i.i = shl i64 %.1213.6.i.i.i.i, 4
  %62 = getelementptr i8, ptr %.922.i.i.i.i, i64 %.idx2168.6.i.i.i.i
  %63 = getelementptr i8, ptr %62, i64 8
  %.1244.6.i.i.i.i = getelementptr double, ptr %63, i64 %.1230.6.i.i.i.i
  %.1245.6.i.i.i.i = load double, ptr %.1244.6.i.i.i.i, align 8, !noalias !9
  store double %.1245.6.i.i.i.i, ptr %sunkaddr72.i.i.i.i, align 8, !noalias !9
  %.1122.7.i.i.i.i = load i64, ptr %sunkaddr76.i.i.i.i, align 8, !noalias !9
  %64 = lshr i64 %.1122.7.i.i.i.i, 33
  %.1138.7.i.i.i.i = and i64 %64, 1073741824
  %.idx2167.7.i.i.i.i = shl i64 %.1122.7.i.i.i.i, 4
  %65 = getelementptr i8, ptr %.922.i.i.i.i, i64 %.idx2167.7.i.i.i.i
  %.1152.7.i.i.i.i = getelementptr double, ptr %65, i64 %.1138.7.i.i.i.i
  %.1153.7.i.i.i.i = load double, ptr %.1152.7.i.i.i.i, align 8, !noalias !9
  store double %.1153.7.i.i.i.i, ptr %sunkaddr77.i.i.i.i, align 8, !noalias !9
  %.1213.7.i.i.i.i = load i64, ptr %sunkaddr76.i.i.i.i, align 8, !noalias !9
  %66 = lshr i64 %.1213.7.i.i.i.i, 33
  %.1230.7.i.i.i.i = and i64 %66, 1073741824
  %.idx2168.7.i.i.i.i = shl i64 %.1213.7.i.i.i.i, 4
  %67 = getelementptr i8, ptr %.922.i.i.i.i, i64 %.idx2168.7.i.i.i.i
  %68 = getelementptr i8, ptr %67, i64 8
  %.1244.7.i.i.i.i = getelementptr double, ptr %68, i64 %.1230.7.i.i.i.i
  %.1245.7.i.i.i.i = load double, ptr %.1244.7.i.i.i.i, align 8, !noalias !9
  store double %.1245.7.i.i.i.i, ptr %sunkaddr78.i.i.i.i, align 8, !noalias !9
  %.1301.i.i.i.i = load <8 x double>, ptr %.561.i, align 8, !noalias !9
  %.1311.i.i.i.i = load <8 x double>, ptr %sunkaddr15.i.i.i.i, align 8, !noalias !9
  %.1373.i.i.i.i = load double, ptr %.811.i.i.i.i, align 8, !noalias !9
  %.1402.i.i.i.i = getelementptr i8, ptr %.811.i.i.i.i, i64 8
  %.1403.i.i.i.i = load double, ptr %.1402.i.i.i.i, align 8, !noalias !9
  %.1432.i.i.i.i = getelementptr i8, ptr %.811.i.i.i.i, i64 16
  %.1433.i.i.i.i = load double, ptr %.1432.i.i.i.i, align 8, !noalias !9
  %.6.i603.i.i.i.i = insertelement <8 x double> poison, double %.1373.i.i.i.i, i64 0
  %.7.i604.i.i.i.i = shufflevector <8 x double> %.6.i603.i.i.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.8.i605.i.i.i.i = fmul contract <8 x double> %.1301.i.i.i.i, %.7.i604.i.i.i.i
  %.1487.i.i.i.i = load <8 x double>, ptr %.249.i, align 8, !noalias !9
  %.6.i606.i.i.i.i = fadd contract <8 x double> %.8.i605.i.i.i.i, %.1487.i.i.i.i
  store <8 x double> %.6.i606.i.i.i.i, ptr %.249.i, align 8, !noalias !9
  %.8.i609.i.i.i.i = fmul contract <8 x double> %.1311.i.i.i.i, %.7.i604.i.i.i.i
  %.1564.i.i.i.i = load <8 x double>, ptr %sunkaddr79.i.i.i.i, align 8, !noalias !9
  %.6.i610.i.i.i.i = fadd contract <8 x double> %.8.i609.i.i.i.i, %.1564.i.i.i.i
  store <8 x double> %.6.i610.i.i.i.i, ptr %sunkaddr79.i.i.i.i, align 8, !noalias !9
  %.1606.i.i.i.i = fneg contract double %.1433.i.i.i.i
  %.6.i611.i.i.i.i = insertelement <8 x double> poison, double %.1606.i.i.i.i, i64 0
  %.7.i612.i.i.i.i = shufflevector <8 x double> %.6.i611.i.i.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.8.i613.i.i.i.i = fmul contract <8 x double> %.1311.i.i.i.i, %.7.i612.i.i.i.i
  %.1631.i.i.i.i = insertelement <8 x double> poison, double %.1403.i.i.i.i, i64 0
  %.1632.i.i.i.i = shufflevector <8 x double> %.1631.i.i.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1633.i.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1301.i.i.i.i, <8 x double> %.1632.i.i.i.i, <8 x double> %.8.i613.i.i.i.i)
  %.1647.i.i.i.i = load <8 x double>, ptr %sunkaddr80.i.i.i.i, align 8, !noalias !9
  %.6.i614.i.i.i.i = fadd contract <8 x double> %.1633.i.i.i.i, %.1647.i.i.i.i
  store <8 x double> %.6.i614.i.i.i.i, ptr %sunkaddr80.i.i.i.i, align 8, !noalias !9
  %.8.i617.i.i.i.i = fmul contract <8 x double> %.1311.i.i.i.i, %.1632.i.i.i.i
  %.1715.i.i.i.i = insertelement <8 x double> poison, double %.1433.i.i.i.i, i64 0
  %.1716.i.i.i.i = shufflevector <8 x double> %.1715.i.i.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1717.i.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1301.i.i.i.i, <8 x double> %.1716.i.i.i.i, <8 x double> %.8.i617.i.i.i.i)
  %.1734.i.i.i.i = load <8 x double>, ptr %sunkaddr81.i.i.i.i, align 8, !noalias !9
  %.6.i618.i.i.i.i = fadd contract <8 x double> %.1717.i.i.i.i, %.1734.i.i.i.i
  store <8 x double> %.6.i618.i.i.i.i, ptr %sunkaddr81.i.i.i.i, align 8, !noalias !9
  br i1 %.456.i.i.i.i, label %B1646.i.i.i.i, label %B1312.i.i.i.i

B1312.i.i.i.i:                                    ; preds = %B566.i.i.i.i
  %sunkaddr767.i.i.i.i = inttoptr i64 %.806.i.i.i.i to ptr
  %sunkaddr768.i.i.i.i = getelementptr i8, ptr %sunkaddr767.i.i.i.i, i64 %.809.i.i.i.i
  %sunkaddr769.i.i.i.i = getelementptr i8, ptr %sunkaddr768.i.i.i.i, i64 24
  %.1803.i.i.i.i = load double, ptr %sunkaddr769.i.i.i.i, align 8, !noalias !9
  %sunkaddr772.i.i.i.i = getelementptr i8, ptr %sunkaddr768.i.i.i.i, i64 32
  %.1833.i.i.i.i = load double, ptr %sunkaddr772.i.i.i.i, align 8, !noalias !9
  %sunkaddr775.i.i.i.i = getelementptr i8, ptr %sunkaddr768.i.i.i.i, i64 40
  %.1863.i.i.i.i = load double, ptr %sunkaddr775.i.i.i.i, align 8, !noalias !9
  %.6.i.i2.i.i.i = insertelement <8 x double> poison, double %.1803.i.i.i.i, i64 0
  %.7.i.i3.i.i.i = shufflevector <8 x double> %.6.i.i2.i.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.8.i.i4.i.i.i = fmul contract <8 x double> %.1301.i.i.i.i, %.7.i.i3.i.i.i
  %.1917.i.i.i.i = load <8 x double>, ptr %sunkaddr82.i.i.i.i, align 8, !noalias !9
  %.6.i619.i.i.i.i = fadd contract <8 x double> %.8.i.i4.i.i.i, %.1917.i.i.i.i
  store <8 x double> %.6.i619.i.i.i.i, ptr %sunkaddr82.i.i.i.i, align 8, !noalias !9
  %.8.i622.i.i.i.i = fmul contract <8 x double> %.1311.i.i.i.i, %.7.i.i3.i.i.i
  %.1994.i.i.i.i = load <8 x double>, ptr %sunkaddr83.i.i.i.i, align 8, !noalias !9
  %.6.i623.i.i.i.i = fadd contract <8 x double> %.8.i622.i.i.i.i, %.1994.i.i.i.i
  store <8 x double> %.6.i623.i.i.i.i, ptr %sunkaddr83.i.i.i.i, align 8, !noalias !9
  %.2036.i.i.i.i = fneg contract double %.1863.i.i.i.i
  %.6.i624.i.i.i.i = insertelement <8 x double> poison, double %.2036.i.i.i.i, i64 0
  %.7.i625.i.i.i.i = shufflevector <8 x double> %.6.i624.i.i.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.8.i626.i.i.i.i = fmul contract <8 x double> %.1311.i.i.i.i, %.7.i625.i.i.i.i
  %.2061.i.i.i.i = insertelement <8 x double> poison, double %.1833.i.i.i.i, i64 0
  %.2062.i.i.i.i = shufflevector <8 x double> %.2061.i.i.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.2063.i.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1301.i.i.i.i, <8 x double> %.2062.i.i.i.i, <8 x double> %.8.i626.i.i.i.i)
  %.2077.i.i.i.i = load <8 x double>, ptr %sunkaddr84.i.i.i.i, align 8, !noalias !9
  %.6.i627.i.i.i.i = fadd contract <8 x double> %.2063.i.i.i.i, %.2077.i.i.i.i
  store <8 x double> %.6.i627.i.i.i.i, ptr %sunkaddr84.i.i.i.i, align 8, !noalias !9
  %.8.i630.i.i.i.i = fmul contract <8 x double> %.1311.i.i.i.i, %.2062.i.i.i.i
  %.2145.i.i.i.i = insertelement <8 x double> poison, double %.1863.i.i.i.i, i64 0
  %.2146.i.i.i.i = shufflevector <8 x double> %.2145.i.i.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.2147.i.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1301.i.i.i.i, <8 x double> %.2146.i.i.i.i, <8 x double> %.8.i630.i.i.i.i)
  %.2164.i.i.i.i = load <8 x double>, ptr %sunkaddr85.i.i.i.i, align 8, !noalias !9
  %.6.i631.i.i.i.i = fadd contract <8 x double> %.2147.i.i.i.i, %.2164.i.i.i.i
  store <8 x double> %.6.i631.i.i.i.i, ptr %sunkaddr85.i.i.i.i, align 8, !noalias !9
  %.6.i632.i.i.i.i = fmul contract <8 x double> %.1311.i.i.i.i, %.1311.i.i.i.i
  %.2231.i.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1301.i.i.i.i, <8 x double> %.1301.i.i.i.i, <8 x double> %.6.i632.i.i.i.i)
  %.8.i633.i.i.i.i = fadd contract <8 x double> %.2231.i.i.i.i, splat (double 1.000000e-300)
  %.6.i634.i.i.i.i = fdiv contract <8 x double> splat (double 1.000000e+00), %.8.i633.i.i.i.i
  %69 = mul i64 %26, %.772.i.i.i.i
  %70 = icmp eq i64 %.683.sroa.0.0576.i.i.i.i, %.419.i.i.i.i
  %sunkaddr131.i.i.i.i = getelementptr i8, ptr %sunkaddr768.i.i.i.i, i64 8
  %sunkaddr134.i.i.i.i = getelementptr i8, ptr %sunkaddr768.i.i.i.i, i64 16
  br label %B1386.if.i.i.i.i

B1606.i.i.i.i:                                    ; preds = %B1386.if.i.i.i.i
  %.6.i582.i.i.i.i = fmul contract <8 x double> %.1301.i.i.i.i, %.2852.i.i.i.i
  %.6.i656.i.i.i.i = fmul contract <8 x double> %.1311.i.i.i.i, %.2842.i.i.i.i
  %.6.i657.i.i.i.i = fsub contract <8 x double> %.6.i582.i.i.i.i, %.6.i656.i.i.i.i
  %.6.i658.i.i.i.i = fmul contract <8 x double> %.6.i634.i.i.i.i, %.6.i657.i.i.i.i
  %scevgep.i8.i.i.i = getelementptr i8, ptr %.311.i, i64 %lsr.iv.i5.i.i.i
  store <8 x double> %.6.i658.i.i.i.i, ptr %scevgep.i8.i.i.i, align 8, !noalias !9
  br label %B1608.i.i.i.i

B1608.i.i.i.i:                                    ; preds = %B1386.if.i.i.i.i, %B1606.i.i.i.i
  %lsr.iv.next.i6.i.i.i = add nuw nsw i64 %lsr.iv.i5.i.i.i, 64
  %lsr.iv.next724.i.i.i.i = add i64 %lsr.iv723.i.i.i.i, %.897.i.i.i.i
  %exitcond.not.i7.i.i.i = icmp eq i64 %lsr.iv.next.i6.i.i.i, 384
  br i1 %exitcond.not.i7.i.i.i, label %B1646.i.i.i.i, label %B1386.if.i.i.i.i

B1646.i.i.i.i:                                    ; preds = %B1608.i.i.i.i, %B566.i.i.i.i, %B538.i.i.i.i
  %.693.i.i.i.i = icmp sgt i64 %.640.1575.in.i.i.i.i, 1
  %.706.i.i.i.i = zext i1 %.693.i.i.i.i to i64
  %.637.1.i.i.i.i = add i64 %.637.1574.i.i.i.i, %.706.i.i.i.i
  %71 = tail call i64 @llvm.smax.i64(i64 %.640.1575.in.i.i.i.i, i64 2)
  %72 = add nsw i64 %71, -1
  %.683.sroa.0.0.i.i.i.i = select i1 %.693.i.i.i.i, i64 %.637.1574.i.i.i.i, i64 0
  br i1 %.693.i.i.i.i, label %B538.i.i.i.i, label %B1650.i.i.i.i

B1650.i.i.i.i:                                    ; preds = %B1646.i.i.i.i, %B1244.i.i.i
  br i1 %.456.i.i.i.i, label %B1654.i.i.i.i, label %_ZN17bnserve_inference13fisher_kernel9_tangents8polariseB3v59B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i.i.i

B1654.i.i.i.i:                                    ; preds = %B1650.i.i.i.i
  %.3522.i.i.i.i = load i64, ptr %.3521.i.i.i.i, align 8, !noalias !9
  %.3523.not.i.i.i.i = icmp eq i64 %.3522.i.i.i.i, 0
  br i1 %.3523.not.i.i.i.i, label %_ZN17bnserve_inference13fisher_kernel9_tangents8polariseB3v59B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i.i.i, label %B3572.i.i.i.i

B3572.i.i.i.i:                                    ; preds = %B1654.i.i.i.i
  %.3557.i.i.i.i = shl nsw i64 %.126.i.i.i.i, 3
  %.3587.i.i.i.i = load i64, ptr %sunkaddr.i.i, align 8, !noalias !9
  %.3594.i.i.i.i = mul nsw i64 %.3587.i.i.i.i, %.1136634637.i
  %.3598.i.i.i.i = add nsw i64 %.3594.i.i.i.i, %.1561.sroa.0.0896.i.i.i
  %.3601.i.i.i.i = mul nsw i64 %.3557.i.i.i.i, %.3598.i.i.i.i
  %.3602.i.i.i.i = add nsw i64 %.3601.i.i.i.i, %.3522.i.i.i.i
  %.3606.i.i.i.i = inttoptr i64 %.3602.i.i.i.i to ptr
  %sunkaddr780.i.i.i.i = inttoptr i64 %.163.i.i.i.i to ptr
  %sunkaddr781.i.i.i.i = getelementptr i8, ptr %sunkaddr780.i.i.i.i, i64 %.222.i.i.i
  %.3806.i.i.i.i = load i64, ptr %sunkaddr781.i.i.i.i, align 8, !noalias !9
  %.3820.i.i.i.i = icmp slt i64 %.3806.i.i.i.i, 0
  %.3821.i.i.i.i = select i1 %.3820.i.i.i.i, i64 %.126.i.i.i.i, i64 0
  %73 = getelementptr double, ptr %.3606.i.i.i.i, i64 %.3806.i.i.i.i
  %.3835.i.i.i.i = getelementptr double, ptr %73, i64 %.3821.i.i.i.i
  %.3836.i.i.i.i = load double, ptr %.3835.i.i.i.i, align 8, !noalias !9
  store double %.3836.i.i.i.i, ptr %.311.i, align 8, !noalias !9
  %sunkaddr784.i.i.i.i = getelementptr i8, ptr %sunkaddr781.i.i.i.i, i64 8
  %.3806.1.i.i.i.i = load i64, ptr %sunkaddr784.i.i.i.i, align 8, !noalias !9
  %.3820.1.i.i.i.i = icmp slt i64 %.3806.1.i.i.i.i, 0
  %.3821.1.i.i.i.i = select i1 %.3820.1.i.i.i.i, i64 %.126.i.i.i.i, i64 0
  %74 = getelementptr double, ptr %.3606.i.i.i.i, i64 %.3806.1.i.i.i.i
  %.3835.1.i.i.i.i = getelementptr double, ptr %74, i64 %.3821.1.i.i.i.i
  %.3836.1.i.i.i.i = load double, ptr %.3835.1.i.i.i.i, align 8, !noalias !9
  store double %.3836.1.i.i.i.i, ptr %1, align 8, !noalias !9
  %sunkaddr787.i.i.i.i = getelementptr i8, ptr %sunkaddr781.i.i.i.i, i64 16
  %.3806.2.i.i.i.i = load i64, ptr %sunkaddr787.i.i.i.i, align 8, !noalias !9
  %.3820.2.i.i.i.i = icmp slt i64 %.3806.2.i.i.i.i, 0
  %.3821.2.i.i.i.i = select i1 %.3820.2.i.i.i.i, i64 %.126.i.i.i.i, i64 0
  %75 = getelementptr double, ptr %.3606.i.i.i.i, i64 %.3806.2.i.i.i.i
  %.3835.2.i.i.i.i = getelementptr double, ptr %75, i64 %.3821.2.i.i.i.i
  %.3836.2.i.i.i.i = load double, ptr %.3835.2.i.i.i.i, align 8, !noalias !9
  store double %.3836.2.i.i.i.i, ptr %2, align 8, !noalias !9
  %sunkaddr790.i.i.i.i = getelementptr i8, ptr %sunkaddr781.i.i.i.i, i64 24
  %.3806.3.i.i.i.i = load i64, ptr %sunkaddr790.i.i.i.i, align 8, !noalias !9
  %.3820.3.i.i.i.i = icmp slt i64 %.3806.3.i.i.i.i, 0
  %.3821.3.i.i.i.i = select i1 %.3820.3.i.i.i.i, i64 %.126.i.i.i.i, i64 0
  %76 = getelementptr double, ptr %.3606.i.i.i.i, i64 %.3806.3.i.i.i.i
  %.3835.3.i.i.i.i = getelementptr double, ptr %76, i64 %.3821.3.i.i.i.i
  %.3836.3.i.i.i.i = load double, ptr %.3835.3.i.i.i.i, align 8, !noalias !9
  store double %.3836.3.i.i.i.i, ptr %3, align 8, !noalias !9
  %sunkaddr793.i.i.i.i = getelementptr i8, ptr %sunkaddr781.i.i.i.i, i64 32
  %.3806.4.i.i.i.i = load i64, ptr %sunkaddr793.i.i.i.i, align 8, !noalias !9
  %.3820.4.i.i.i.i = icmp slt i64 %.3806.4.i.i.i.i, 0
  %.3821.4.i.i.i.i = select i1 %.3820.4.i.i.i.i, i64 %.126.i.i.i.i, i64 0
  %77 = getelementptr double, ptr %.3606.i.i.i.i, i64 %.3806.4.i.i.i.i
  %.3835.4.i.i.i.i = getelementptr double, ptr %77, i64 %.3821.4.i.i.i.i
  %.3836.4.i.i.i.i = load double, ptr %.3835.4.i.i.i.i, align 8, !noalias !9
  store double %.3836.4.i.i.i.i, ptr %4, align 8, !noalias !9
  %sunkaddr796.i.i.i.i = getelementptr i8, ptr %sunkaddr781.i.i.i.i, i64 40
  %.3806.5.i.i.i.i = load i64, ptr %sunkaddr796.i.i.i.i, align 8, !noalias !9
  %.3820.5.i.i.i.i = icmp slt i64 %.3806.5.i.i.i.i, 0
  %.3821.5.i.i.i.i = select i1 %.3820.5.i.i.i.i, i64 %.126.i.i.i.i, i64 0
  %78 = getelementptr double, ptr %.3606.i.i.i.i, i64 %.3806.5.i.i.i.i
  %.3835.5.i.i.i.i = getelementptr double, ptr %78, i64 %.3821.5.i.i.i.i
  %.3836.5.i.i.i.i = load double, ptr %.3835.5.i.i.i.i, align 8, !noalias !9
  store double %.3836.5.i.i.i.i, ptr %5, align 8, !noalias !9
  %sunkaddr799.i.i.i.i = getelementptr i8, ptr %sunkaddr781.i.i.i.i, i64 48
  %.3806.6.i.i.i.i = load i64, ptr %sunkaddr799.i.i.i.i, align 8, !noalias !9
  %.3820.6.i.i.i.i = icmp slt i64 %.3806.6.i.i.i.i, 0
  %.3821.6.i.i.i.i = select i1 %.3820.6.i.i.i.i, i64 %.126.i.i.i.i, i64 0
  %79 = getelementptr double, ptr %.3606.i.i.i.i, i64 %.3806.6.i.i.i.i
  %.3835.6.i.i.i.i = getelementptr double, ptr %79, i64 %.3821.6.i.i.i.i
  %.3836.6.i.i.i.i = load double, ptr %.3835.6.i.i.i.i, align 8, !noalias !9
  store double %.3836.6.i.i.i.i, ptr %6, align 8, !noalias !9
  %sunkaddr802.i.i.i.i = getelementptr i8, ptr %sunkaddr781.i.i.i.i, i64 56
  %.3806.7.i.i.i.i = load i64, ptr %sunkaddr802.i.i.i.i, align 8, !noalias !9
  %.3820.7.i.i.i.i = icmp slt i64 %.3806.7.i.i.i.i, 0
  %.3821.7.i.i.i.i = select i1 %.3820.7.i.i.i.i, i64 %.126.i.i.i.i, i64 0
  %80 = getelementptr double, ptr %.3606.i.i.i.i, i64 %.3806.7.i.i.i.i
  %.3835.7.i.i.i.i = getelementptr double, ptr %80, i64 %.3821.7.i.i.i.i
  %.3836.7.i.i.i.i = load double, ptr %.3835.7.i.i.i.i, align 8, !noalias !9
  store double %.3836.7.i.i.i.i, ptr %7, align 8, !noalias !9
  br label %_ZN17bnserve_inference13fisher_kernel9_tangents8polariseB3v59B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i.i.i

B1386.if.i.i.i.i:                                 ; preds = %B1608.i.i.i.i, %B1312.i.i.i.i
  %lsr.iv723.i.i.i.i = phi i64 [ %69, %B1312.i.i.i.i ], [ %lsr.iv.next724.i.i.i.i, %B1608.i.i.i.i ]
  %lsr.iv.i5.i.i.i = phi i64 [ 0, %B1312.i.i.i.i ], [ %lsr.iv.next.i6.i.i.i, %B1608.i.i.i.i ]
  %.2432.i.i.i.i = load i64, ptr %.466.i.i, align 8, !noalias !9
  %81 = add i64 %.2432.i.i.i.i, %lsr.iv723.i.i.i.i
  %.2463.i.i.i.i = inttoptr i64 %81 to ptr
  %.2663.i.i.i.i = load i64, ptr %sunkaddr14.i.i.i.i, align 8, !noalias !9
  %82 = lshr i64 %.2663.i.i.i.i, 33
  %.2679.i.i.i.i = and i64 %82, 1073741824
  %.idx2165.i.i.i.i = shl i64 %.2663.i.i.i.i, 4
  %83 = getelementptr i8, ptr %.2463.i.i.i.i, i64 %.idx2165.i.i.i.i
  %.2693.i.i.i.i = getelementptr double, ptr %83, i64 %.2679.i.i.i.i
  %.2694.i.i.i.i = load double, ptr %.2693.i.i.i.i, align 8, !noalias !9
  store double %.2694.i.i.i.i, ptr %.561.i, align 8, !noalias !9
  %.2754.i.i.i.i = load i64, ptr %sunkaddr14.i.i.i.i, align 8, !noalias !9
  %84 = lshr i64 %.2754.i.i.i.i, 33
  %.2771.i.i.i.i = and i64 %84, 1073741824
  %.idx2166.i.i.i.i = shl i64 %.2754.i.i.i.i, 4
  %85 = getelementptr i8, ptr %.2463.i.i.i.i, i64 %.idx2166.i.i.i.i
  %86 = getelementptr i8, ptr %85, i64 8
  %.2785.i.i.i.i = getelementptr double, ptr %86, i64 %.2771.i.i.i.i
  %.2786.i.i.i.i = load double, ptr %.2785.i.i.i.i, align 8, !noalias !9
  store double %.2786.i.i.i.i, ptr %sunkaddr15.i.i.i.i, align 8, !noalias !9
  %.2663.1.i.i.i.i = load i64, ptr %sunkaddr21.i.i.i.i, align 8, !noalias !9
  %87 = lshr i64 %.2663.1.i.i.i.i, 33
  %.2679.1.i.i.i.i = and i64 %87, 1073741824
  %.idx2165.1.i.i.i.i = shl i64 %.2663.1.i.i.i.i, 4
  %88 = getelementptr i8, ptr %.2463.i.i.i.i, i64 %.idx2165.1.i.i.i.i
  %.2693.1.i.i.i.i = getelementptr double, ptr %88, i64 %.2679.1.i.i.i.i
  %.2694.1.i.i.i.i = load double, ptr %.2693.1.i.i.i.i, align 8, !noalias !9
  store double %.2694.1.i.i.i.i, ptr %sunkaddr22.i.i.i.i, align 8, !noalias !9
  %.2754.1.i.i.i.i = load i64, ptr %sunkaddr21.i.i.i.i, align 8, !noalias !9
  %89 = lshr i64 %.2754.1.i.i.i.i, 33
  %.2771.1.i.i.i.i = and i64 %89, 1073741824
  %.idx2166.1.i.i.i.i = shl i64 %.2754.1.i.i.i.i, 4
  %90 = getelementptr i8, ptr %.2463.i.i.i.i, i64 %.idx2166.1.i.i.i.i
  %91 = getelementptr i8, ptr %90, i64 8
  %.2785.1.i.i.i.i = getelementptr double, ptr %91, i64 %.2771.1.i.i.i.i
  %.2786.1.i.i.i.i = load double, ptr %.2785.1.i.i.i.i, align 8, !noalias !9
  store double %.2786.1.i.i.i.i, ptr %sunkaddr26.i.i.i.i, align 8, !noalias !9
  %.2663.2.i.i.i.i = load i64, ptr %sunkaddr29.i.i.i.i, align 8, !noalias !9
  %92 = lshr i64 %.2663.2.i.i.i.i, 33
  %.2679.2.i.i.i.i = and i64 %92, 1073741824
  %.idx2165.2.i.i.i.i = shl i64 %.2663.2.i.i.i.i, 4
  %93 = getelementptr i8, ptr %.2463.i.i.i.i, i64 %.idx2165.2.i.i.i.i
  %.2693.2.i.i.i.i = getelementptr double, ptr %93, i64 %.2679.2.i.i.i.i
  %.2694.2.i.i.i.i = load double, ptr %.2693.2.i.i.i.i, align 8, !noalias !9
  store double %.2694.2.i.i.i.i, ptr %sunkaddr33.i.i.i.i, align 8, !noalias !9
  %.2754.2.i.i.i.i = load i64, ptr %sunkaddr29.i.i.i.i, align 8, !noalias !9
  %94 = lshr i64 %.2754.2.i.i.i.i, 33
  %.2771.2.i.i.i.i = and i64 %94, 1073741824
  %.idx2166.2.i.i.i.i = shl i64 %.2754.2.i.i.i.i, 4
  %95 = getelementptr i8, ptr %.2463.i.i.i.i, i64 %.idx2166.2.i.i.i.i
  %96 = getelementptr i8, ptr %95, i64 8
  %.2785.2.i.i.i.i = getelementptr double, ptr %96, i64 %.2771.2.i.i.i.i
  %.2786.2.i.i.i.i = load double, ptr %.2785.2.i.i.i.i, align 8, !noalias !9
  store double %.2786.2.i.i.i.i, ptr %sunkaddr34.i.i.i.i, align 8, !noalias !9
  %.2663.3.i.i.i.i = load i64, ptr %sunkaddr40.i.i.i.i, align 8, !noalias !9
  %97 = lshr i64 %.2663.3.i.i.i.i, 33
  %.2679.3.i.i.i.i = and i64 %97, 1073741824
  %.idx2165.3.i.i.i.i = shl i64 %.2663.3.i.i.i.i, 4
  %98 = getelementptr i8, ptr %.2463.i.i.i.i, i64 %.idx2165.3.i.i.i.i
  %.2693.3.i.i.i.i = getelementptr double, ptr %98, i64 %.2679.3.i.i.i.i
  %.2694.3.i.i.i.i = load double, ptr %.2693.3.i.i.i.i, align 8, !noalias !9
  store double %.2694.3.i.i.i.i, ptr %sunkaddr41.i.i.i.i, align 8, !noalias !9
  %.2754.3.i.i.i.i = load i64, ptr %sunkaddr40.i.i.i.i, align 8, !noalias !9
  %99 = lshr i64 %.2754.3.i.i.i.i, 33
  %.2771.3.i.i.i.i = and i64 %99, 1073741824
  %.idx2166.3.i.i.i.i = shl i64 %.2754.3.i.i.i.i, 4
  %100 = getelementptr i8, ptr %.2463.i.i.i.i, i64 %.idx2166.3.i.i.i.i
  %101 = getelementptr i8, ptr %100, i64 8
  %.2785.3.i.i.i.i = getelementptr double, ptr %101, i64 %.2771.3.i.i.i.i
  %.2786.3.i.i.i.i = load double, ptr %.2785.3.i.i.i.i, align 8, !noalias !9
  store double %.2786.3.i.i.i.i, ptr %sunkaddr43.i.i.i.i, align 8, !noalias !9
  %.2663.4.i.i.i.i = load i64, ptr %sunkaddr48.i.i.i.i, align 8, !noalias !9
  %102 = lshr i64 %.2663.4.i.i.i.i, 33
  %.2679.4.i.i.i.i = and i64 %102, 1073741824
  %.idx2165.4.i.i.i.i = shl i64 %.2663.4.i.i.i.i, 4
  %103 = getelementptr i8, ptr %.2463.i.i.i.i, i64 %.idx2165.4.i.i.i.i
  %.2693.4.i.i.i.i = getelementptr double, ptr %103, i64 %.2679.4.i.i.i.i
  %.2694.4.i.i.i.i = load double, ptr %.2693.4.i.i.i.i, align 8, !noalias !9
  store double %.2694.4.i.i.i.i, ptr %sunkaddr52.i.i.i.i, align 8, !noalias !9
  %.2754.4.i.i.i.i = load i64, ptr %sunkaddr48.i.i.i.i, align 8, !noalias !9
  %104 = lshr i64 %.2754.4.i.i.i.i, 33
  %.2771.4.i.i.i.i = and i64 %104, 1073741824
  %.idx2166.4.i.i.i.i = shl i64 %.2754.4.i.i.i.i, 4
  %105 = getelementptr i8, ptr %.2463.i.i.i.i, i64 %.idx2166.4.i.i.i.i
  %106 = getelementptr i8, ptr %105, i64 8
  %.2785.4.i.i.i.i = getelementptr double, ptr %106, i64 %.2771.4.i.i.i.i
  %.2786.4.i.i.i.i = load double, ptr %.2785.4.i.i.i.i, align 8, !noalias !9
  store double %.2786.4.i.i.i.i, ptr %sunkaddr53.i.i.i.i, align 8, !noalias !9
  %.2663.5.i.i.i.i = load i64, ptr %sunkaddr59.i.i.i.i, align 8, !noalias !9
  %107 = lshr i64 %.2663.5.i.i.i.i, 33
  %.2679.5.i.i.i.i = and i64 %107, 1073741824
  %.idx2165.5.i.i.i.i = shl i64 %.2663.5.i.i.i.i, 4
  %108 = getelementptr i8, ptr %.2463.i.i.i.i, i64 %.idx2165.5.i.i.i.i
  %.2693.5.i.i.i.i = getelementptr double, ptr %108, i64 %.2679.5.i.i.i.i
  %.2694.5.i.i.i.i = load double, ptr %.2693.5.i.i.i.i, align 8, !noalias !9
  store double %.2694.5.i.i.i.i, ptr %sunkaddr62.i.i.i.i, align 8, !noalias !9
  %.2754.5.i.i.i.i = load i64, ptr %sunkaddr59.i.i.i.i, align 8, !noalias !9
  %109 = lshr i64 %.2754.5.i.i.i.i, 33
  %.2771.5.i.i.i.i = and i64 %109, 1073741824
  %.idx2166.5.i.i.i.i = shl i64 %.2754.5.i.i.i.i, 4
  %110 = getelementptr i8, ptr %.2463.i.i.i.i, i64 %.idx2166.5.i.i.i.i
  %111 = getelementptr i8, ptr %110, i64 8
  %.2785.5.i.i.i.i = getelementptr double, ptr %111, i64 %.2771.5.i.i.i.i
  %.2786.5.i.i.i.i = load double, ptr %.2785.5.i.i.i.i, align 8, !noalias !9
  store double %.2786.5.i.i.i.i, ptr %sunkaddr63.i.i.i.i, align 8, !noalias !9
  %.2663.6.i.i.i.i = load i64, ptr %sunkaddr68.i.i.i.i, align 8, !noalias !9
  %112 = lshr i64 %.2663.6.i.i.i.i, 33
  %.2679.6.i.i.i.i = and i64 %112, 1073741824
  %.idx2165.6.i.i.i.i = shl i64 %.2663.6.i.i.i.i, 4
  %113 = getelementptr i8, ptr %.2463.i.i.i.i, i64 %.idx2165.6.i.i.i.i
  %.2693.6.i.i.i.i = getelementptr double, ptr %113, i64 %.2679.6.i.i.i.i
  %.2694.6.i.i.i.i = load double, ptr %.2693.6.i.i.i.i, align 8, !noalias !9
  store double %.2694.6.i.i.i.i, ptr %sunkaddr69.i.i.i.i, align 8, !noalias !9
  %.2754.6.i.i.i.i = load i64, ptr %sunkaddr68.i.i.i.i, align 8, !noalias !9
  %114 = lshr i64 %.2754.6.i.i.i.i, 33
  %.2771.6.i.i.i.i = and i64 %114, 1073741824
  %.idx2166.6.i.i.i.i = shl i64 %.2754.6.i.i.i.i, 4
  %115 = getelementptr i8, ptr %.2463.i.i.i.i, i64 %.idx2166.6.i.i.i.i
  %116 = getelementptr i8, ptr %115, i64 8
  %.2785.6.i.i.i.i = getelementptr double, ptr %116, i64 %.2771.6.i.i.i.i
  %.2786.6.i.i.i.i = load double, ptr %.2785.6.i.i.i.i, align 8, !noalias !9
  store double %.2786.6.i.i.i.i, ptr %sunkaddr72.i.i.i.i, align 8, !noalias !9
  %.2663.7.i.i.i.i = load i64, ptr %sunkaddr76.i.i.i.i, align 8, !noalias !9
  %117 = lshr i64 %.2663.7.i.i.i.i, 33
  %.2679.7.i.i.i.i = and i64 %117, 1073741824
  %.idx2165.7.i.i.i.i = shl i64 %.2663.7.i.i.i.i, 4
  %118 = getelementptr i8, ptr %.2463.i.i.i.i, i64 %.idx2165.7.i.i.i.i
  %.2693.7.i.i.i.i = getelementptr double, ptr %118, i64 %.2679.7.i.i.i.i
  %.2694.7.i.i.i.i = load double, ptr %.2693.7.i.i.i.i, align 8, !noalias !9
  store double %.2694.7.i.i.i.i, ptr %sunkaddr77.i.i.i.i, align 8, !noalias !9
  %.2754.7.i.i.i.i = load i64, ptr %sunkaddr76.i.i.i.i, align 8, !noalias !9
  %119 = lshr i64 %.2754.7.i.i.i.i, 33
  %.2771.7.i.i.i.i = and i64 %119, 1073741824
  %.idx2166.7.i.i.i.i = shl i64 %.2754.7.i.i.i.i, 4
  %120 = getelementptr i8, ptr %.2463.i.i.i.i, i64 %.idx2166.7.i.i.i.i
  %121 = getelementptr i8, ptr %120, i64 8
  %.2785.7.i.i.i.i = getelementptr double, ptr %121, i64 %.2771.7.i.i.i.i
  %.2786.7.i.i.i.i = load double, ptr %.2785.7.i.i.i.i, align 8, !noalias !9
  store double %.2786.7.i.i.i.i, ptr %sunkaddr78.i.i.i.i, align 8, !noalias !9
  %.2842.i.i.i.i = load <8 x double>, ptr %.561.i, align 8, !noalias !9
  %.2852.i.i.i.i = load <8 x double>, ptr %sunkaddr15.i.i.i.i, align 8, !noalias !9
  %.2917.i.i.i.i = load double, ptr %sunkaddr768.i.i.i.i, align 8, !noalias !9
  %.2947.i.i.i.i = load double, ptr %sunkaddr131.i.i.i.i, align 8, !noalias !9
  %.2977.i.i.i.i = load double, ptr %sunkaddr134.i.i.i.i, align 8, !noalias !9
  %.6.i640.i.i.i.i = insertelement <8 x double> poison, double %.2917.i.i.i.i, i64 0
  %.7.i641.i.i.i.i = shufflevector <8 x double> %.6.i640.i.i.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.8.i642.i.i.i.i = fmul contract <8 x double> %.2842.i.i.i.i, %.7.i641.i.i.i.i
  %sunkaddr135.i.i.i.i = shl i64 %lsr.iv.i5.i.i.i, 2
  %sunkaddr136.i.i.i.i = getelementptr i8, ptr %.249.i, i64 %sunkaddr135.i.i.i.i
  %sunkaddr137.i.i.i.i = getelementptr i8, ptr %sunkaddr136.i.i.i.i, i64 512
  %.3031.i.i.i.i = load <8 x double>, ptr %sunkaddr137.i.i.i.i, align 8, !noalias !9
  %.6.i643.i.i.i.i = fadd contract <8 x double> %.8.i642.i.i.i.i, %.3031.i.i.i.i
  store <8 x double> %.6.i643.i.i.i.i, ptr %sunkaddr137.i.i.i.i, align 8, !noalias !9
  %.8.i646.i.i.i.i = fmul contract <8 x double> %.2852.i.i.i.i, %.7.i641.i.i.i.i
  %sunkaddr140.i.i.i.i = getelementptr i8, ptr %sunkaddr136.i.i.i.i, i64 576
  %.3108.i.i.i.i = load <8 x double>, ptr %sunkaddr140.i.i.i.i, align 8, !noalias !9
  %.6.i647.i.i.i.i = fadd contract <8 x double> %.8.i646.i.i.i.i, %.3108.i.i.i.i
  store <8 x double> %.6.i647.i.i.i.i, ptr %sunkaddr140.i.i.i.i, align 8, !noalias !9
  %.3150.i.i.i.i = fneg contract double %.2977.i.i.i.i
  %.6.i648.i.i.i.i = insertelement <8 x double> poison, double %.3150.i.i.i.i, i64 0
  %.7.i649.i.i.i.i = shufflevector <8 x double> %.6.i648.i.i.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.8.i650.i.i.i.i = fmul contract <8 x double> %.2852.i.i.i.i, %.7.i649.i.i.i.i
  %.3175.i.i.i.i = insertelement <8 x double> poison, double %.2947.i.i.i.i, i64 0
  %.3176.i.i.i.i = shufflevector <8 x double> %.3175.i.i.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.3177.i.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.2842.i.i.i.i, <8 x double> %.3176.i.i.i.i, <8 x double> %.8.i650.i.i.i.i)
  %sunkaddr143.i.i.i.i = getelementptr i8, ptr %sunkaddr136.i.i.i.i, i64 640
  %.3191.i.i.i.i = load <8 x double>, ptr %sunkaddr143.i.i.i.i, align 8, !noalias !9
  %.6.i651.i.i.i.i = fadd contract <8 x double> %.3177.i.i.i.i, %.3191.i.i.i.i
  store <8 x double> %.6.i651.i.i.i.i, ptr %sunkaddr143.i.i.i.i, align 8, !noalias !9
  %.8.i654.i.i.i.i = fmul contract <8 x double> %.2852.i.i.i.i, %.3176.i.i.i.i
  %.3259.i.i.i.i = insertelement <8 x double> poison, double %.2977.i.i.i.i, i64 0
  %.3260.i.i.i.i = shufflevector <8 x double> %.3259.i.i.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.3261.i.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.2842.i.i.i.i, <8 x double> %.3260.i.i.i.i, <8 x double> %.8.i654.i.i.i.i)
  %sunkaddr146.i.i.i.i = getelementptr i8, ptr %sunkaddr136.i.i.i.i, i64 704
  %.3278.i.i.i.i = load <8 x double>, ptr %sunkaddr146.i.i.i.i, align 8, !noalias !9
  %.6.i655.i.i.i.i = fadd contract <8 x double> %.3261.i.i.i.i, %.3278.i.i.i.i
  store <8 x double> %.6.i655.i.i.i.i, ptr %sunkaddr146.i.i.i.i, align 8, !noalias !9
  br i1 %70, label %B1606.i.i.i.i, label %B1608.i.i.i.i

_ZN17bnserve_inference13fisher_kernel9_tangents8polariseB3v59B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i.i.i: ; preds = %B3572.i.i.i.i, %B1654.i.i.i.i, %B1650.i.i.i.i
  br i1 %.not.i.i.i, label %B1254.i.i.i, label %B1298.i.i.i

B1254.i.i.i:                                      ; preds = %_ZN17bnserve_inference13fisher_kernel9_tangents8polariseB3v59B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i.i.i
  %.1715.i.i.i = load double, ptr %sunkaddr35.i.i.i, align 8, !noalias !6
  %.80.i.i.i.i = load i64, ptr %sunkaddr36.i.i.i, align 8, !noalias !12
  %.84.i.i.i.i = add nsw i64 %.80.i.i.i.i, %.83.i.i.i.i
  %.170.i.i.i.i = load i64, ptr %.466.i.i, align 8, !noalias !12
  %.174.i.i.i.i = icmp eq i64 %.170.i.i.i.i, 0
  %122 = inttoptr i64 %.84.i.i.i.i to ptr
  br i1 %.174.i.i.i.i, label %B214.if.i.i.i.i, label %B394.if.i.i.i.i

B4180.i.i.i.i:                                    ; preds = %B4009.if.i.i.i.i
  %.478.i.i.i.i = add nuw nsw i64 %.471486496.i.i.i.i, 1
  %.791.idx.i.i.i.i = shl nsw i64 %.471486496.i.i.i.i, 6
  %.791.i.i.i.i = getelementptr inbounds nuw i8, ptr %.375.i, i64 %.791.idx.i.i.i.i
  store <8 x double> %.762.i.i.i.i, ptr %.791.i.i.i.i, align 8, !noalias !12
  %scevgep26.i.i.i.i = getelementptr i8, ptr %lsr.iv25.i.i.i.i, i64 64
  %exitcond514.not.i.i.i.i = icmp eq i64 %.478.i.i.i.i, 6
  br i1 %exitcond514.not.i.i.i.i, label %B4182.i.i.i.i, label %B394.if.i.i.i.i

B4182.i.i.i.i:                                    ; preds = %B4180.i.i.i.i
  %.823.i.i.i.i = load <8 x double>, ptr %sunkaddr.i.i.i, align 8, !noalias !12
  %.836.i.i.i.i = fdiv contract double %.1715.i.i.i, 0xC01921FB54442D18
  %.837.i.i.i.i = insertelement <8 x double> poison, double %.836.i.i.i.i, i64 0
  %.838.i.i.i.i = shufflevector <8 x double> %.837.i.i.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.6.i.i.i.i.i = fdiv contract <8 x double> %.838.i.i.i.i, %.282.i.i.i
  %.6.i7.i.i.i.i = fmul contract <8 x double> %.6.i.i.i.i.i, %.823.i.i.i.i
  br label %B1254.endif.i.i.i

B214.if.i.i.i.i:                                  ; preds = %B1254.i.i.i, %B214.if.i.i.i.i
  %lsr.iv.i.i.i.i = phi i64 [ %lsr.iv.next.i.i.i.i, %B214.if.i.i.i.i ], [ 0, %B1254.i.i.i ]
  %_slope_v92_total.2.0507.i.i.i.i = phi <8 x double> [ %.382.i.i.i.i, %B214.if.i.i.i.i ], [ zeroinitializer, %B1254.i.i.i ]
  %123 = shl nuw nsw i64 %lsr.iv.i.i.i.i, 3
  %scevgep31.i8.i.i = getelementptr i8, ptr %122, i64 %123
  %.348.i.i.i.i = load <8 x double>, ptr %scevgep31.i8.i.i, align 8, !noalias !12
  %scevgep.i.i.i.i = getelementptr i8, ptr %.311.i, i64 %lsr.iv.i.i.i.i
  %.378.i.i.i.i = load double, ptr %scevgep.i.i.i.i, align 8, !noalias !12
  %.380.i.i.i.i = insertelement <8 x double> poison, double %.378.i.i.i.i, i64 0
  %.381.i.i.i.i = shufflevector <8 x double> %.380.i.i.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.382.i.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.348.i.i.i.i, <8 x double> %.381.i.i.i.i, <8 x double> %_slope_v92_total.2.0507.i.i.i.i)
  %lsr.iv.next.i.i.i.i = add nuw nsw i64 %lsr.iv.i.i.i.i, 8
  %exitcond515.not.i.i.i.i = icmp eq i64 %lsr.iv.next.i.i.i.i, 64
  br i1 %exitcond515.not.i.i.i.i, label %B1254.endif.i.i.i, label %B214.if.i.i.i.i

B394.if.i.i.i.i:                                  ; preds = %B1254.i.i.i, %B4180.i.i.i.i
  %lsr.iv25.i.i.i.i = phi ptr [ %scevgep26.i.i.i.i, %B4180.i.i.i.i ], [ %.311.i, %B1254.i.i.i ]
  %.471486496.i.i.i.i = phi i64 [ %.478.i.i.i.i, %B4180.i.i.i.i ], [ 0, %B1254.i.i.i ]
  br label %B4009.if.i.i.i.i

B4009.if.i.i.i.i:                                 ; preds = %B4009.if.i.i.i.i, %B394.if.i.i.i.i
  %lsr.iv27.i.i.i.i = phi i64 [ 0, %B394.if.i.i.i.i ], [ %lsr.iv.next28.i.i.i.i, %B4009.if.i.i.i.i ]
  %_slope_v91_total.2.1482.i.i.i.i = phi <8 x double> [ zeroinitializer, %B394.if.i.i.i.i ], [ %.762.i.i.i.i, %B4009.if.i.i.i.i ]
  %124 = shl nuw nsw i64 %lsr.iv27.i.i.i.i, 3
  %scevgep.i6.i.i = getelementptr i8, ptr %122, i64 %124
  %.728.i.i.i.i = load <8 x double>, ptr %scevgep.i6.i.i, align 8, !noalias !12
  %scevgep29.i.i.i.i = getelementptr i8, ptr %lsr.iv25.i.i.i.i, i64 %lsr.iv27.i.i.i.i
  %.758.i.i.i.i = load double, ptr %scevgep29.i.i.i.i, align 8, !noalias !12
  %.760.i.i.i.i = insertelement <8 x double> poison, double %.758.i.i.i.i, i64 0
  %.761.i.i.i.i = shufflevector <8 x double> %.760.i.i.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.762.i.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.728.i.i.i.i, <8 x double> %.761.i.i.i.i, <8 x double> %_slope_v91_total.2.1482.i.i.i.i)
  %lsr.iv.next28.i.i.i.i = add nuw nsw i64 %lsr.iv27.i.i.i.i, 8
  %exitcond.not.i.i.i.i = icmp eq i64 %lsr.iv.next28.i.i.i.i, 64
  br i1 %exitcond.not.i.i.i.i, label %B4180.i.i.i.i, label %B4009.if.i.i.i.i

B1298.i.i.i:                                      ; preds = %B1254.endif.i.i.i, %_ZN17bnserve_inference13fisher_kernel9_tangents8polariseB3v59B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i.i.i
  %turned.2.1.i.i.i = phi <8 x double> [ %.1675.i.i.i, %_ZN17bnserve_inference13fisher_kernel9_tangents8polariseB3v59B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i.i.i ], [ %.6.i930.i.i.i, %B1254.endif.i.i.i ]
  %.1859.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %turned.2.1.i.i.i, <8 x double> splat (double 0x3FE45F306DC9C883), <8 x double> splat (double 0x4338000000000000))
  %.8.i.i.i.i = fadd contract <8 x double> %.1859.i.i.i, splat (double 0xC338000000000000)
  %.1900.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i.i.i.i, <8 x double> splat (double 0xBFF921FB54442D18), <8 x double> %turned.2.1.i.i.i)
  %.1917.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i.i.i.i, <8 x double> splat (double 0xBC91A62633145C07), <8 x double> %.1900.i.i.i)
  %.6.i931.i.i.i = fmul contract <8 x double> %.1917.i.i.i, %.1917.i.i.i
  %.6.i932.i.i.i = fmul contract <8 x double> %.1917.i.i.i, %.6.i931.i.i.i
  %.1946.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i931.i.i.i, <8 x double> splat (double 0xBD6AE7F3E733B81F), <8 x double> splat (double 0x3DE6124613A86D09))
  %.1949.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i931.i.i.i, <8 x double> %.1946.i.i.i, <8 x double> splat (double 0xBE5AE64567F544E4))
  %.1952.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i931.i.i.i, <8 x double> %.1949.i.i.i, <8 x double> splat (double 0x3EC71DE3A556C734))
  %.1955.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i931.i.i.i, <8 x double> %.1952.i.i.i, <8 x double> splat (double 0xBF2A01A01A01A01A))
  %.1958.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i931.i.i.i, <8 x double> %.1955.i.i.i, <8 x double> splat (double 0x3F81111111111111))
  %.1961.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i931.i.i.i, <8 x double> %.1958.i.i.i, <8 x double> splat (double 0xBFC5555555555555))
  %.1986.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i932.i.i.i, <8 x double> %.1961.i.i.i, <8 x double> %.1917.i.i.i)
  %.1991.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i931.i.i.i, <8 x double> splat (double 0x3D2AE7F3E733B81F), <8 x double> splat (double 0xBDA93974A8C07C9D))
  %.1994.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i931.i.i.i, <8 x double> %.1991.i.i.i, <8 x double> splat (double 0x3E21EED8EFF8D898))
  %.1997.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i931.i.i.i, <8 x double> %.1994.i.i.i, <8 x double> splat (double 0xBE927E4FB7789F5C))
  %.2000.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i931.i.i.i, <8 x double> %.1997.i.i.i, <8 x double> splat (double 0x3EFA01A01A01A01A))
  %.2003.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i931.i.i.i, <8 x double> %.2000.i.i.i, <8 x double> splat (double 0xBF56C16C16C16C17))
  %.2006.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i931.i.i.i, <8 x double> %.2003.i.i.i, <8 x double> splat (double 0x3FA5555555555555))
  %.2009.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i931.i.i.i, <8 x double> %.2006.i.i.i, <8 x double> splat (double -5.000000e-01))
  %.2012.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i931.i.i.i, <8 x double> %.2009.i.i.i, <8 x double> splat (double 1.000000e+00))
  %.2013.i.i.i = bitcast <8 x double> %.1859.i.i.i to <8 x i64>
  %.2014.i.i.i = bitcast <8 x double> %.1986.i.i.i to <8 x i64>
  %.2015.i.i.i = bitcast <8 x double> %.2012.i.i.i to <8 x i64>
  %.6.i933.i.i.i = xor <8 x i64> %.2015.i.i.i, %.2014.i.i.i
  %.8.i934.i.i.i = and <8 x i64> %.2013.i.i.i, splat (i64 1)
  %125 = icmp eq <8 x i64> %.8.i934.i.i.i, zeroinitializer
  %.6.i936.i.i.i = select <8 x i1> %125, <8 x i64> zeroinitializer, <8 x i64> %.6.i933.i.i.i
  %.8.i937.i.i.i = shl <8 x i64> %.2013.i.i.i, splat (i64 62)
  %.8.i938.i.i.i = and <8 x i64> %.8.i937.i.i.i, splat (i64 -9223372036854775808)
  %.8.i940.i.i.i = add <8 x i64> %.8.i937.i.i.i, splat (i64 4611686018427387904)
  %.8.i941.i.i.i = and <8 x i64> %.8.i940.i.i.i, splat (i64 -9223372036854775808)
  %126 = xor <8 x i64> %.8.i938.i.i.i, %.2014.i.i.i
  %.6.i943.i.i.i = xor <8 x i64> %126, %.6.i936.i.i.i
  %127 = bitcast <8 x i64> %.6.i943.i.i.i to <8 x double>
  %128 = xor <8 x i64> %.8.i941.i.i.i, %.2015.i.i.i
  %.6.i945.i.i.i = xor <8 x i64> %128, %.6.i936.i.i.i
  %129 = bitcast <8 x i64> %.6.i945.i.i.i to <8 x double>
  %.2478.i.i.i = load i64, ptr %136, align 8, !noalias !6
  %.25582588.not.i.i.i = icmp slt i64 %.2478.i.i.i, 1
  br i1 %.25582588.not.i.i.i, label %B1156.loopexit.i.i.i, label %B1784.if.lr.ph.i.i.i

B2024.i.i.i:                                      ; preds = %_ZN17bnserve_inference13fisher_kernel9_response7respondB4v101B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE8UniTupleIdLi2EE8UniTupleIdLi2EE19vector_28float64_2919vector_28float64_2919vector_28float64_295ArrayIdLi1E1C7mutable7alignedE.exit.i.i.i
  %.8.i.i.i.i.i = fmul contract <8 x double> %.7.i.i.i.i.i, %.6.i7.i903.i.i.i
  %.8.i12.i.i.i.i = fmul contract <8 x double> %.7.i.i.i.i.i, %.6.i8.i.i.i.i
  %.6.i13.i.i.i.i = fmul contract <8 x double> %.6.i975.i.i.i, %.8.i12.i.i.i.i
  %.6.i14.i.i.i.i = fsub contract <8 x double> zeroinitializer, %.6.i13.i.i.i.i
  %.672.i.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i.i.i.i.i, <8 x double> %.6.i974.i.i.i, <8 x double> %.6.i14.i.i.i.i)
  %.6.i15.i.i.i.i = fmul contract <8 x double> %.6.i974.i.i.i, %.8.i12.i.i.i.i
  %.705.i.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i.i.i.i.i, <8 x double> %.6.i975.i.i.i, <8 x double> %.6.i15.i.i.i.i)
  br i1 %"$phi1254.1.2.1.not.i.i.i", label %_ZN17bnserve_inference13fisher_kernel9_tangents7observeB4v133B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEd8UniTupleI19vector_28float64_29Li2EE5ArrayIdLi1E1C7mutable7alignedExxb.exit.i.i.i, label %B4458.i.i.i.i

B4458.i.i.i.i:                                    ; preds = %B2024.i.i.i
  %130 = shl i64 %lsr.iv.i3.i.i, 3
  %scevgep1083.i.i.i = getelementptr i8, ptr %scevgep1078.i.i.i, i64 %130
  %scevgep1084.i.i.i = getelementptr i8, ptr %scevgep1083.i.i.i, i64 -64
  %.756.i.i.i.i = load <8 x double>, ptr %scevgep1084.i.i.i, align 8, !noalias !15
  %.6.i1.i.i.i.i = fadd contract <8 x double> %.672.i.i.i.i, %.756.i.i.i.i
  %.795.i.i.i.i = load <8 x double>, ptr %scevgep1083.i.i.i, align 8, !noalias !15
  %.6.i16.i.i.i.i = fadd contract <8 x double> %.705.i.i.i.i, %.795.i.i.i.i
  br label %_ZN17bnserve_inference13fisher_kernel9_tangents7observeB4v133B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEd8UniTupleI19vector_28float64_29Li2EE5ArrayIdLi1E1C7mutable7alignedExxb.exit.i.i.i

_ZN17bnserve_inference13fisher_kernel9_tangents7observeB4v133B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEd8UniTupleI19vector_28float64_29Li2EE5ArrayIdLi1E1C7mutable7alignedExxb.exit.i.i.i: ; preds = %B4458.i.i.i.i, %B2024.i.i.i
  %_put_v141_real.2.0.i.i.i.i = phi <8 x double> [ %.672.i.i.i.i, %B2024.i.i.i ], [ %.6.i1.i.i.i.i, %B4458.i.i.i.i ]
  %_put_v141_imaginary.2.0.i.i.i.i = phi <8 x double> [ %.705.i.i.i.i, %B2024.i.i.i ], [ %.6.i16.i.i.i.i, %B4458.i.i.i.i ]
  %131 = shl i64 %lsr.iv.i3.i.i, 3
  %scevgep1080.i.i.i = getelementptr i8, ptr %scevgep1078.i.i.i, i64 %131
  %scevgep1081.i.i.i = getelementptr i8, ptr %scevgep1080.i.i.i, i64 -64
  store <8 x double> %_put_v141_real.2.0.i.i.i.i, ptr %scevgep1081.i.i.i, align 8, !noalias !15
  store <8 x double> %_put_v141_imaginary.2.0.i.i.i.i, ptr %scevgep1080.i.i.i, align 8, !noalias !15
  br label %B8131.i.i.i

B2025.i.i.i:                                      ; preds = %_ZN17bnserve_inference13fisher_kernel9_response7respondB4v101B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE8UniTupleIdLi2EE8UniTupleIdLi2EE19vector_28float64_2919vector_28float64_2919vector_28float64_295ArrayIdLi1E1C7mutable7alignedE.exit.i.i.i
  %.6.i127.i.i.i.i = fmul contract <8 x double> %.8.i126.i.i.i.i, %.6.i8.i.i.i.i
  %.6.i128.i.i.i.i = fsub contract <8 x double> zeroinitializer, %.6.i127.i.i.i.i
  %.6.i129.i.i.i.i = fmul contract <8 x double> %.8.i126.i.i.i.i, %.6.i7.i903.i.i.i
  %.736.i.i.i.i = load <8 x double>, ptr %.734.i.i.i.i, align 8, !noalias !18
  %.747.i.i.i.i = load <8 x double>, ptr %.745.i.i.i.i, align 8, !noalias !18
  %.6.i130.i.i.i.i = fmul contract <8 x double> %.138.i.i.i.i, %.747.i.i.i.i
  %.6.i131.i.i.i.i = fsub contract <8 x double> zeroinitializer, %.6.i130.i.i.i.i
  %.866.i.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.736.i.i.i.i, <8 x double> %.127.i.i.i.i, <8 x double> %.6.i131.i.i.i.i)
  %.6.i132.i.i.i.i = fmul contract <8 x double> %.127.i.i.i.i, %.747.i.i.i.i
  %.899.i12.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.736.i.i.i.i, <8 x double> %.138.i.i.i.i, <8 x double> %.6.i132.i.i.i.i)
  %.930.i.i.i.i = load <8 x double>, ptr %.928.i.i.i.i, align 8, !noalias !18
  %.941.i.i.i.i = load <8 x double>, ptr %.939.i.i.i.i, align 8, !noalias !18
  %.6.i133.i.i.i.i = fmul contract <8 x double> %.338.i.i.i.i, %.941.i.i.i.i
  %.6.i134.i.i.i.i = fsub contract <8 x double> zeroinitializer, %.6.i133.i.i.i.i
  %.6.i135.i.i.i.i = fmul contract <8 x double> %.327.i.i.i.i, %.941.i.i.i.i
  %.1064.i.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.930.i.i.i.i, <8 x double> %.327.i.i.i.i, <8 x double> %.6.i134.i.i.i.i)
  %.6.i136.i.i.i.i = fadd contract <8 x double> %.866.i.i.i.i, %.1064.i.i.i.i
  %.1097.i.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.930.i.i.i.i, <8 x double> %.338.i.i.i.i, <8 x double> %.6.i135.i.i.i.i)
  %.6.i137.i.i.i.i = fadd contract <8 x double> %.899.i12.i.i.i, %.1097.i.i.i.i
  %.1192.i.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i31.i.i.i.i, <8 x double> %.6.i128.i.i.i.i, <8 x double> %.6.i136.i.i.i.i)
  %.1198.i.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i31.i.i.i.i, <8 x double> %.6.i129.i.i.i.i, <8 x double> %.6.i137.i.i.i.i)
  br label %B450.if.i.i.i.i

B536.i.i.i.i:                                     ; preds = %B450.if.i.i.i.i
  %scevgep10.i.i.i.i = getelementptr i8, ptr %.375.i, i64 %lsr.iv1.i.i.i.i
  %scevgep11.i.i.i.i = getelementptr i8, ptr %scevgep10.i.i.i.i, i64 -176
  %.1822.i.i.i.i = load <8 x double>, ptr %scevgep11.i.i.i.i, align 8, !noalias !18
  %.8.i.i15.i.i.i = fmul contract <8 x double> %.7.i.i13.i.i.i, %.1822.i.i.i.i
  %.1852.i.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i.i15.i.i.i, <8 x double> %.1192.i.i.i.i, <8 x double> %.6.i144.i.i.i.i)
  %.1861.i.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i.i15.i.i.i, <8 x double> %.1198.i.i.i.i, <8 x double> %.6.i145.i.i.i.i)
  br label %B706.i.i.i.i

B706.i.i.i.i:                                     ; preds = %B450.if.i.i.i.i, %B536.i.i.i.i
  %own.2.sroa.8.1.i.i.i.i = phi <8 x double> [ %.1861.i.i.i.i, %B536.i.i.i.i ], [ %.6.i145.i.i.i.i, %B450.if.i.i.i.i ]
  %own.2.sroa.0.1.i.i.i.i = phi <8 x double> [ %.1852.i.i.i.i, %B536.i.i.i.i ], [ %.6.i144.i.i.i.i, %B450.if.i.i.i.i ]
  %.1880.i.i.i.i = icmp eq i64 %lsr.iv1.i.i.i.i, 496
  %..1277.sroa.0.0.i.i.i.i = select i1 %.1880.i.i.i.i, i64 7, i64 %.129316641679.i.i.i.i
  %.6.i99.i.i.i.i = fmul contract <8 x double> %.6.i975.i.i.i, %own.2.sroa.8.1.i.i.i.i
  %.6.i146.i.i.i.i = fsub contract <8 x double> zeroinitializer, %.6.i99.i.i.i.i
  %.1985.i.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %own.2.sroa.0.1.i.i.i.i, <8 x double> %.6.i974.i.i.i, <8 x double> %.6.i146.i.i.i.i)
  %.6.i147.i.i.i.i = fmul contract <8 x double> %.6.i974.i.i.i, %own.2.sroa.8.1.i.i.i.i
  %.2018.i.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %own.2.sroa.0.1.i.i.i.i, <8 x double> %.6.i975.i.i.i, <8 x double> %.6.i147.i.i.i.i)
  %.2053.i.i.i.i = mul nsw i64 %.185.i.i.i, %..1277.sroa.0.0.i.i.i.i
  %.2054.i.i.i.i = add nsw i64 %.2053.i.i.i.i, %lsr.iv.i3.i.i
  br i1 %"$phi1254.1.2.1.not.i.i.i", label %B4639.i.i.i.i, label %B826.i.i.i.i

B826.i.i.i.i:                                     ; preds = %B706.i.i.i.i
  %.2067.i.i.i.i = getelementptr inbounds double, ptr %.114.i, i64 %.2054.i.i.i.i
  %.2069.i.i.i.i = load <8 x double>, ptr %.2067.i.i.i.i, align 8, !noalias !18
  %.6.i100.i.i.i.i = fadd contract <8 x double> %.1985.i.i.i.i, %.2069.i.i.i.i
  %.2106.i.i.i.i = getelementptr i8, ptr %.2067.i.i.i.i, i64 64
  %.2108.i.i.i.i = load <8 x double>, ptr %.2106.i.i.i.i, align 8, !noalias !18
  %.6.i148.i.i.i.i = fadd contract <8 x double> %.2018.i.i.i.i, %.2108.i.i.i.i
  br label %B4639.i.i.i.i

B4639.i.i.i.i:                                    ; preds = %B826.i.i.i.i, %B706.i.i.i.i
  %_put_v178_real.2.1.i.i.i.i = phi <8 x double> [ %.1985.i.i.i.i, %B706.i.i.i.i ], [ %.6.i100.i.i.i.i, %B826.i.i.i.i ]
  %_put_v178_imaginary.2.1.i.i.i.i = phi <8 x double> [ %.2018.i.i.i.i, %B706.i.i.i.i ], [ %.6.i148.i.i.i.i, %B826.i.i.i.i ]
  %.2154.i.i.i.i = getelementptr inbounds double, ptr %.114.i, i64 %.2054.i.i.i.i
  store <8 x double> %_put_v178_real.2.1.i.i.i.i, ptr %.2154.i.i.i.i, align 8, !noalias !18
  %.2171.i.i.i.i = getelementptr i8, ptr %.2154.i.i.i.i, i64 64
  store <8 x double> %_put_v178_imaginary.2.1.i.i.i.i, ptr %.2171.i.i.i.i, align 8, !noalias !18
  %.1300.i.i.i.i = add nuw nsw i64 %.129316641679.i.i.i.i, 1
  %lsr.iv.next2.i.i.i.i = add nuw nsw i64 %lsr.iv1.i.i.i.i, 64
  %exitcond.not.i16.i.i.i = icmp eq i64 %lsr.iv.next2.i.i.i.i, 560
  br i1 %exitcond.not.i16.i.i.i, label %B4731.i.i.i.i, label %B450.if.i.i.i.i

B4731.i.i.i.i:                                    ; preds = %B4639.i.i.i.i
  %.2217.i.i.i.i = load <8 x double>, ptr %.437.i, align 8, !noalias !18
  %.2228.i.i.i.i = load <8 x double>, ptr %.161.i.i.i.i, align 8, !noalias !18
  %.2258.i.i.i.i = load <8 x double>, ptr %sunkaddr82.i.i.i.i, align 8, !noalias !18
  %.2269.i.i.i.i = load <8 x double>, ptr %sunkaddr83.i.i.i.i, align 8, !noalias !18
  %.6.i101.i.i.i.i = fmul contract <8 x double> %.2228.i.i.i.i, %.2269.i.i.i.i
  %.6.i149.i.i.i.i = fsub contract <8 x double> zeroinitializer, %.6.i101.i.i.i.i
  %.2347.i.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.2217.i.i.i.i, <8 x double> %.2258.i.i.i.i, <8 x double> %.6.i149.i.i.i.i)
  %.6.i150.i.i.i.i = fmul contract <8 x double> %.2228.i.i.i.i, %.2258.i.i.i.i
  %.2380.i.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.2217.i.i.i.i, <8 x double> %.2269.i.i.i.i, <8 x double> %.6.i150.i.i.i.i)
  %.2411.i.i.i.i = load <8 x double>, ptr %.346.i.i.i.i, align 8, !noalias !18
  %.2422.i.i.i.i = load <8 x double>, ptr %scevgep.i21.i.i.i, align 8, !noalias !18
  %.2456.i.i.i.i = load <8 x double>, ptr %sunkaddr84.i.i.i.i, align 8, !noalias !18
  %.2467.i.i.i.i = load <8 x double>, ptr %sunkaddr85.i.i.i.i, align 8, !noalias !18
  %.6.i151.i.i.i.i = fmul contract <8 x double> %.2422.i.i.i.i, %.2467.i.i.i.i
  %.6.i152.i.i.i.i = fsub contract <8 x double> zeroinitializer, %.6.i151.i.i.i.i
  %.6.i153.i.i.i.i = fmul contract <8 x double> %.2422.i.i.i.i, %.2456.i.i.i.i
  %.2545.i.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.2411.i.i.i.i, <8 x double> %.2456.i.i.i.i, <8 x double> %.6.i152.i.i.i.i)
  %.6.i154.i.i.i.i = fadd contract <8 x double> %.2347.i.i.i.i, %.2545.i.i.i.i
  %.2578.i.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.2411.i.i.i.i, <8 x double> %.2467.i.i.i.i, <8 x double> %.6.i153.i.i.i.i)
  %.6.i155.i.i.i.i = fadd contract <8 x double> %.2380.i.i.i.i, %.2578.i.i.i.i
  %.6.i156.i.i.i.i = fmul contract <8 x double> %.6.i975.i.i.i, %.6.i155.i.i.i.i
  %.6.i157.i.i.i.i = fsub contract <8 x double> zeroinitializer, %.6.i156.i.i.i.i
  %.2742.i.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i154.i.i.i.i, <8 x double> %.6.i974.i.i.i, <8 x double> %.6.i157.i.i.i.i)
  %.6.i158.i.i.i.i = fmul contract <8 x double> %.6.i974.i.i.i, %.6.i155.i.i.i.i
  %.2775.i.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i154.i.i.i.i, <8 x double> %.6.i975.i.i.i, <8 x double> %.6.i158.i.i.i.i)
  %.2811.i.i.i.i = add nsw i64 %lsr.iv.i3.i.i, %.2810.i.i.i.i
  br i1 %"$phi1254.1.2.1.not.i.i.i", label %B4891.i.i.i.i, label %B4799.i.i.i.i

B4799.i.i.i.i:                                    ; preds = %B4731.i.i.i.i
  %.2824.i.i.i.i = getelementptr inbounds double, ptr %.114.i, i64 %.2811.i.i.i.i
  %.2826.i.i.i.i = load <8 x double>, ptr %.2824.i.i.i.i, align 8, !noalias !18
  %.6.i102.i.i.i.i = fadd contract <8 x double> %.2742.i.i.i.i, %.2826.i.i.i.i
  %.2863.i.i.i.i = getelementptr i8, ptr %.2824.i.i.i.i, i64 64
  %.2865.i.i.i.i = load <8 x double>, ptr %.2863.i.i.i.i, align 8, !noalias !18
  %.6.i159.i.i.i.i = fadd contract <8 x double> %.2775.i.i.i.i, %.2865.i.i.i.i
  br label %B4891.i.i.i.i

B4891.i.i.i.i:                                    ; preds = %B4799.i.i.i.i, %B4731.i.i.i.i
  %_put_v151_real.2.0.i.i.i.i = phi <8 x double> [ %.2742.i.i.i.i, %B4731.i.i.i.i ], [ %.6.i102.i.i.i.i, %B4799.i.i.i.i ]
  %_put_v151_imaginary.2.0.i.i.i.i = phi <8 x double> [ %.2775.i.i.i.i, %B4731.i.i.i.i ], [ %.6.i159.i.i.i.i, %B4799.i.i.i.i ]
  %.2911.i.i.i.i = getelementptr inbounds double, ptr %.114.i, i64 %.2811.i.i.i.i
  store <8 x double> %_put_v151_real.2.0.i.i.i.i, ptr %.2911.i.i.i.i, align 8, !noalias !18
  %.2928.i.i.i.i = getelementptr i8, ptr %.2911.i.i.i.i, i64 64
  store <8 x double> %_put_v151_imaginary.2.0.i.i.i.i, ptr %.2928.i.i.i.i, align 8, !noalias !18
  %.8.i105.i.i.i.i = fmul contract <8 x double> %.7.i.i.i.i.i, %.6.i7.i903.i.i.i
  %.8.i162.i.i.i.i = fmul contract <8 x double> %.7.i.i.i.i.i, %.6.i8.i.i.i.i
  %.6.i163.i.i.i.i = fmul contract <8 x double> %.6.i975.i.i.i, %.8.i162.i.i.i.i
  %.6.i164.i.i.i.i = fsub contract <8 x double> zeroinitializer, %.6.i163.i.i.i.i
  %.3084.i.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i105.i.i.i.i, <8 x double> %.6.i974.i.i.i, <8 x double> %.6.i164.i.i.i.i)
  %.6.i165.i.i.i.i = fmul contract <8 x double> %.6.i974.i.i.i, %.8.i162.i.i.i.i
  %.3117.i.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i105.i.i.i.i, <8 x double> %.6.i975.i.i.i, <8 x double> %.6.i165.i.i.i.i)
  %.3153.i.i.i.i = add nsw i64 %lsr.iv.i3.i.i, %.3152.i.i.i.i
  br i1 %"$phi1254.1.2.1.not.i.i.i", label %B5051.i.i.i.i, label %B4959.i.i.i.i

B4959.i.i.i.i:                                    ; preds = %B4891.i.i.i.i
  %.3166.i.i.i.i = getelementptr inbounds double, ptr %.114.i, i64 %.3153.i.i.i.i
  %.3168.i.i.i.i = load <8 x double>, ptr %.3166.i.i.i.i, align 8, !noalias !18
  %.6.i106.i.i.i.i = fadd contract <8 x double> %.3084.i.i.i.i, %.3168.i.i.i.i
  %.3205.i.i.i.i = getelementptr i8, ptr %.3166.i.i.i.i, i64 64
  %.3207.i.i.i.i = load <8 x double>, ptr %.3205.i.i.i.i, align 8, !noalias !18
  %.6.i166.i.i.i.i = fadd contract <8 x double> %.3117.i.i.i.i, %.3207.i.i.i.i
  br label %B5051.i.i.i.i

B5051.i.i.i.i:                                    ; preds = %B4959.i.i.i.i, %B4891.i.i.i.i
  %_put_v153_real.2.0.i.i.i.i = phi <8 x double> [ %.3084.i.i.i.i, %B4891.i.i.i.i ], [ %.6.i106.i.i.i.i, %B4959.i.i.i.i ]
  %_put_v153_imaginary.2.0.i.i.i.i = phi <8 x double> [ %.3117.i.i.i.i, %B4891.i.i.i.i ], [ %.6.i166.i.i.i.i, %B4959.i.i.i.i ]
  %.3253.i.i.i.i = getelementptr inbounds double, ptr %.114.i, i64 %.3153.i.i.i.i
  store <8 x double> %_put_v153_real.2.0.i.i.i.i, ptr %.3253.i.i.i.i, align 8, !noalias !18
  %.3270.i.i.i.i = getelementptr i8, ptr %.3253.i.i.i.i, i64 64
  store <8 x double> %_put_v153_imaginary.2.0.i.i.i.i, ptr %.3270.i.i.i.i, align 8, !noalias !18
  %.8.i109.i.i.i.i = fmul contract <8 x double> %.7.i108.i.i.i.i, %.6.i8.i.i.i.i
  %.8.i169.i.i.i.i = fmul contract <8 x double> %.7.i168.i.i.i.i, %.6.i7.i903.i.i.i
  %.6.i170.i.i.i.i = fmul contract <8 x double> %.6.i975.i.i.i, %.8.i169.i.i.i.i
  %.6.i171.i.i.i.i = fsub contract <8 x double> zeroinitializer, %.6.i170.i.i.i.i
  %.3429.i.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i109.i.i.i.i, <8 x double> %.6.i974.i.i.i, <8 x double> %.6.i171.i.i.i.i)
  %.6.i172.i.i.i.i = fmul contract <8 x double> %.6.i974.i.i.i, %.8.i169.i.i.i.i
  %.3462.i.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i109.i.i.i.i, <8 x double> %.6.i975.i.i.i, <8 x double> %.6.i172.i.i.i.i)
  %.3498.i.i.i.i = add nsw i64 %lsr.iv.i3.i.i, %.3497.i.i.i.i
  br i1 %"$phi1254.1.2.1.not.i.i.i", label %B5211.i.i.i.i, label %B5119.i.i.i.i

B5119.i.i.i.i:                                    ; preds = %B5051.i.i.i.i
  %.3511.i.i.i.i = getelementptr inbounds double, ptr %.114.i, i64 %.3498.i.i.i.i
  %.3513.i.i.i.i = load <8 x double>, ptr %.3511.i.i.i.i, align 8, !noalias !18
  %.6.i110.i.i.i.i = fadd contract <8 x double> %.3429.i.i.i.i, %.3513.i.i.i.i
  %.3550.i.i.i.i = getelementptr i8, ptr %.3511.i.i.i.i, i64 64
  %.3552.i.i.i.i = load <8 x double>, ptr %.3550.i.i.i.i, align 8, !noalias !18
  %.6.i173.i.i.i.i = fadd contract <8 x double> %.3462.i.i.i.i, %.3552.i.i.i.i
  br label %B5211.i.i.i.i

B5211.i.i.i.i:                                    ; preds = %B5119.i.i.i.i, %B5051.i.i.i.i
  %_put_v155_real.2.0.i.i.i.i = phi <8 x double> [ %.3429.i.i.i.i, %B5051.i.i.i.i ], [ %.6.i110.i.i.i.i, %B5119.i.i.i.i ]
  %_put_v155_imaginary.2.0.i.i.i.i = phi <8 x double> [ %.3462.i.i.i.i, %B5051.i.i.i.i ], [ %.6.i173.i.i.i.i, %B5119.i.i.i.i ]
  %.3598.i17.i.i.i = getelementptr inbounds double, ptr %.114.i, i64 %.3498.i.i.i.i
  store <8 x double> %_put_v155_real.2.0.i.i.i.i, ptr %.3598.i17.i.i.i, align 8, !noalias !18
  %.3615.i.i.i.i = getelementptr i8, ptr %.3598.i17.i.i.i, i64 64
  store <8 x double> %_put_v155_imaginary.2.0.i.i.i.i, ptr %.3615.i.i.i.i, align 8, !noalias !18
  %.3632.i.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1192.i.i.i.i, <8 x double> %.7.i.i13.i.i.i, <8 x double> %.6.i128.i.i.i.i)
  %.3640.i.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1198.i.i.i.i, <8 x double> %.7.i.i13.i.i.i, <8 x double> %.6.i129.i.i.i.i)
  %.6.i111.i.i.i.i = fmul contract <8 x double> %.6.i975.i.i.i, %.3640.i.i.i.i
  %.6.i174.i.i.i.i = fsub contract <8 x double> zeroinitializer, %.6.i111.i.i.i.i
  %.3731.i.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.3632.i.i.i.i, <8 x double> %.6.i974.i.i.i, <8 x double> %.6.i174.i.i.i.i)
  %.6.i175.i.i.i.i = fmul contract <8 x double> %.6.i974.i.i.i, %.3640.i.i.i.i
  %.3764.i.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.3632.i.i.i.i, <8 x double> %.6.i975.i.i.i, <8 x double> %.6.i175.i.i.i.i)
  %.3800.i.i.i.i = add nsw i64 %lsr.iv.i3.i.i, %.3799.i.i.i.i
  br i1 %"$phi1254.1.2.1.not.i.i.i", label %B5371.i.i.i.i, label %B5279.i.i.i.i

B5279.i.i.i.i:                                    ; preds = %B5211.i.i.i.i
  %.3813.i.i.i.i = getelementptr inbounds double, ptr %.114.i, i64 %.3800.i.i.i.i
  %.3815.i.i.i.i = load <8 x double>, ptr %.3813.i.i.i.i, align 8, !noalias !18
  %.6.i112.i.i.i.i = fadd contract <8 x double> %.3731.i.i.i.i, %.3815.i.i.i.i
  %.3852.i.i.i.i = getelementptr i8, ptr %.3813.i.i.i.i, i64 64
  %.3854.i.i.i.i = load <8 x double>, ptr %.3852.i.i.i.i, align 8, !noalias !18
  %.6.i176.i.i.i.i = fadd contract <8 x double> %.3764.i.i.i.i, %.3854.i.i.i.i
  br label %B5371.i.i.i.i

B5371.i.i.i.i:                                    ; preds = %B5279.i.i.i.i, %B5211.i.i.i.i
  %_put_v157_real.2.0.i.i.i.i = phi <8 x double> [ %.3731.i.i.i.i, %B5211.i.i.i.i ], [ %.6.i112.i.i.i.i, %B5279.i.i.i.i ]
  %_put_v157_imaginary.2.0.i.i.i.i = phi <8 x double> [ %.3764.i.i.i.i, %B5211.i.i.i.i ], [ %.6.i176.i.i.i.i, %B5279.i.i.i.i ]
  %.3900.i.i.i.i = getelementptr inbounds double, ptr %.114.i, i64 %.3800.i.i.i.i
  store <8 x double> %_put_v157_real.2.0.i.i.i.i, ptr %.3900.i.i.i.i, align 8, !noalias !18
  %.3917.i.i.i.i = getelementptr i8, ptr %.3900.i.i.i.i, i64 64
  store <8 x double> %_put_v157_imaginary.2.0.i.i.i.i, ptr %.3917.i.i.i.i, align 8, !noalias !18
  %.6.i113.i.i.i.i = fsub contract <8 x double> zeroinitializer, %.1192.i.i.i.i
  %.6.i177.i.i.i.i = fsub contract <8 x double> zeroinitializer, %.1198.i.i.i.i
  %.6.i178.i.i.i.i = fmul contract <8 x double> %.6.i975.i.i.i, %.6.i177.i.i.i.i
  %.6.i179.i.i.i.i = fsub contract <8 x double> zeroinitializer, %.6.i178.i.i.i.i
  %.4076.i.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i113.i.i.i.i, <8 x double> %.6.i974.i.i.i, <8 x double> %.6.i179.i.i.i.i)
  %.6.i180.i.i.i.i = fmul contract <8 x double> %.6.i974.i.i.i, %.6.i177.i.i.i.i
  %.4109.i.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i113.i.i.i.i, <8 x double> %.6.i975.i.i.i, <8 x double> %.6.i180.i.i.i.i)
  %.4145.i.i.i.i = add nsw i64 %lsr.iv.i3.i.i, %.4144.i.i.i.i
  br i1 %"$phi1254.1.2.1.not.i.i.i", label %B5552.i.i.i.i, label %B5460.i.i.i.i

B5460.i.i.i.i:                                    ; preds = %B5371.i.i.i.i
  %.4158.i.i.i.i = getelementptr inbounds double, ptr %.114.i, i64 %.4145.i.i.i.i
  %.4160.i.i.i.i = load <8 x double>, ptr %.4158.i.i.i.i, align 8, !noalias !18
  %.6.i114.i.i.i.i = fadd contract <8 x double> %.4076.i.i.i.i, %.4160.i.i.i.i
  %.4197.i.i.i.i = getelementptr i8, ptr %.4158.i.i.i.i, i64 64
  %.4199.i.i.i.i = load <8 x double>, ptr %.4197.i.i.i.i, align 8, !noalias !18
  %.6.i181.i.i.i.i = fadd contract <8 x double> %.4109.i.i.i.i, %.4199.i.i.i.i
  br label %B5552.i.i.i.i

B5552.i.i.i.i:                                    ; preds = %B5460.i.i.i.i, %B5371.i.i.i.i
  %_put_v159_real.2.0.i.i.i.i = phi <8 x double> [ %.4076.i.i.i.i, %B5371.i.i.i.i ], [ %.6.i114.i.i.i.i, %B5460.i.i.i.i ]
  %_put_v159_imaginary.2.0.i.i.i.i = phi <8 x double> [ %.4109.i.i.i.i, %B5371.i.i.i.i ], [ %.6.i181.i.i.i.i, %B5460.i.i.i.i ]
  %.4245.i.i.i.i = getelementptr inbounds double, ptr %.114.i, i64 %.4145.i.i.i.i
  store <8 x double> %_put_v159_real.2.0.i.i.i.i, ptr %.4245.i.i.i.i, align 8, !noalias !18
  %.4262.i.i.i.i = getelementptr i8, ptr %.4245.i.i.i.i, i64 64
  store <8 x double> %_put_v159_imaginary.2.0.i.i.i.i, ptr %.4262.i.i.i.i, align 8, !noalias !18
  %.4295.i.i.i.i = load <8 x double>, ptr %.4293.i.i.i.i, align 8, !noalias !18
  %.4306.i.i.i.i = load <8 x double>, ptr %.4304.i.i.i.i, align 8, !noalias !18
  %.4336.i.i.i.i = load <8 x double>, ptr %.249.i, align 8, !noalias !18
  %.4347.i.i.i.i = load <8 x double>, ptr %sunkaddr79.i.i.i.i, align 8, !noalias !18
  %.6.i115.i.i.i.i = fmul contract <8 x double> %.4306.i.i.i.i, %.4347.i.i.i.i
  %.6.i182.i.i.i.i = fsub contract <8 x double> zeroinitializer, %.6.i115.i.i.i.i
  %.4425.i.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.4295.i.i.i.i, <8 x double> %.4336.i.i.i.i, <8 x double> %.6.i182.i.i.i.i)
  %.6.i183.i.i.i.i = fmul contract <8 x double> %.4306.i.i.i.i, %.4336.i.i.i.i
  %.4458.i.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.4295.i.i.i.i, <8 x double> %.4347.i.i.i.i, <8 x double> %.6.i183.i.i.i.i)
  %.4489.i.i.i.i = load <8 x double>, ptr %.4487.i.i.i.i, align 8, !noalias !18
  %.4500.i.i.i.i = load <8 x double>, ptr %.4498.i.i.i.i, align 8, !noalias !18
  %.4534.i.i.i.i = load <8 x double>, ptr %sunkaddr80.i.i.i.i, align 8, !noalias !18
  %.4545.i.i.i.i = load <8 x double>, ptr %sunkaddr81.i.i.i.i, align 8, !noalias !18
  %.6.i184.i.i.i.i = fmul contract <8 x double> %.4500.i.i.i.i, %.4545.i.i.i.i
  %.6.i185.i.i.i.i = fsub contract <8 x double> zeroinitializer, %.6.i184.i.i.i.i
  %.6.i186.i.i.i.i = fmul contract <8 x double> %.4500.i.i.i.i, %.4534.i.i.i.i
  %.4623.i.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.4489.i.i.i.i, <8 x double> %.4534.i.i.i.i, <8 x double> %.6.i185.i.i.i.i)
  %.6.i187.i.i.i.i = fadd contract <8 x double> %.4425.i.i.i.i, %.4623.i.i.i.i
  %.4656.i.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.4489.i.i.i.i, <8 x double> %.4545.i.i.i.i, <8 x double> %.6.i186.i.i.i.i)
  %.6.i188.i.i.i.i = fadd contract <8 x double> %.4458.i.i.i.i, %.4656.i.i.i.i
  %.4747.i.i.i.i = load <8 x double>, ptr %.1229.i.i.i.i, align 8, !noalias !18
  %.4753.i.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.4747.i.i.i.i, <8 x double> %.6.i128.i.i.i.i, <8 x double> %.6.i187.i.i.i.i)
  %.4763.i.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.4747.i.i.i.i, <8 x double> %.6.i129.i.i.i.i, <8 x double> %.6.i188.i.i.i.i)
  %.6.i189.i.i.i.i = fmul contract <8 x double> %.6.i975.i.i.i, %.4763.i.i.i.i
  %.6.i190.i.i.i.i = fsub contract <8 x double> zeroinitializer, %.6.i189.i.i.i.i
  %.4851.i.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.4753.i.i.i.i, <8 x double> %.6.i974.i.i.i, <8 x double> %.6.i190.i.i.i.i)
  %.6.i191.i.i.i.i = fmul contract <8 x double> %.6.i974.i.i.i, %.4763.i.i.i.i
  %.4884.i.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.4753.i.i.i.i, <8 x double> %.6.i975.i.i.i, <8 x double> %.6.i191.i.i.i.i)
  %.4920.i.i.i.i = add nsw i64 %lsr.iv.i3.i.i, %.4919.i.i.i.i
  br i1 %"$phi1254.1.2.1.not.i.i.i", label %B5730.i.i.i.i, label %B5638.i.i.i.i

B5638.i.i.i.i:                                    ; preds = %B5552.i.i.i.i
  %.4933.i.i.i.i = getelementptr inbounds double, ptr %.114.i, i64 %.4920.i.i.i.i
  %.4935.i.i.i.i = load <8 x double>, ptr %.4933.i.i.i.i, align 8, !noalias !18
  %.6.i116.i.i.i.i = fadd contract <8 x double> %.4851.i.i.i.i, %.4935.i.i.i.i
  %.4972.i.i.i.i = getelementptr i8, ptr %.4933.i.i.i.i, i64 64
  %.4974.i.i.i.i = load <8 x double>, ptr %.4972.i.i.i.i, align 8, !noalias !18
  %.6.i192.i.i.i.i = fadd contract <8 x double> %.4884.i.i.i.i, %.4974.i.i.i.i
  br label %B5730.i.i.i.i

B5730.i.i.i.i:                                    ; preds = %B5638.i.i.i.i, %B5552.i.i.i.i
  %_put_v168_real.2.0.i.i.i.i = phi <8 x double> [ %.4851.i.i.i.i, %B5552.i.i.i.i ], [ %.6.i116.i.i.i.i, %B5638.i.i.i.i ]
  %_put_v168_imaginary.2.0.i.i.i.i = phi <8 x double> [ %.4884.i.i.i.i, %B5552.i.i.i.i ], [ %.6.i192.i.i.i.i, %B5638.i.i.i.i ]
  %.5020.i.i.i.i = getelementptr inbounds double, ptr %.114.i, i64 %.4920.i.i.i.i
  store <8 x double> %_put_v168_real.2.0.i.i.i.i, ptr %.5020.i.i.i.i, align 8, !noalias !18
  %.5037.i.i.i.i = getelementptr i8, ptr %.5020.i.i.i.i, i64 64
  store <8 x double> %_put_v168_imaginary.2.0.i.i.i.i, ptr %.5037.i.i.i.i, align 8, !noalias !18
  %.5062.i.i.i.i = load <8 x double>, ptr %.346.i.i.i.i, align 8, !noalias !18
  %.5073.i.i.i.i = load <8 x double>, ptr %scevgep.i21.i.i.i, align 8, !noalias !18
  %.5103.i.i.i.i = load <8 x double>, ptr %.249.i, align 8, !noalias !18
  %.5114.i.i.i.i = load <8 x double>, ptr %sunkaddr79.i.i.i.i, align 8, !noalias !18
  %.6.i117.i.i.i.i = fmul contract <8 x double> %.5073.i.i.i.i, %.5114.i.i.i.i
  %.6.i193.i.i.i.i = fsub contract <8 x double> zeroinitializer, %.6.i117.i.i.i.i
  %.5192.i.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.5062.i.i.i.i, <8 x double> %.5103.i.i.i.i, <8 x double> %.6.i193.i.i.i.i)
  %.6.i194.i.i.i.i = fmul contract <8 x double> %.5073.i.i.i.i, %.5103.i.i.i.i
  %.5225.i.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.5062.i.i.i.i, <8 x double> %.5114.i.i.i.i, <8 x double> %.6.i194.i.i.i.i)
  %.5258.i.i.i.i = load <8 x double>, ptr %.437.i, align 8, !noalias !18
  %.5269.i.i.i.i = load <8 x double>, ptr %.161.i.i.i.i, align 8, !noalias !18
  %.5304.i.i.i.i = load <8 x double>, ptr %sunkaddr80.i.i.i.i, align 8, !noalias !18
  %.5315.i.i.i.i = load <8 x double>, ptr %sunkaddr81.i.i.i.i, align 8, !noalias !18
  %.6.i195.i.i.i.i = fmul contract <8 x double> %.5269.i.i.i.i, %.5315.i.i.i.i
  %.6.i196.i.i.i.i = fsub contract <8 x double> zeroinitializer, %.6.i195.i.i.i.i
  %.6.i197.i.i.i.i = fmul contract <8 x double> %.5269.i.i.i.i, %.5304.i.i.i.i
  %.5393.i.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.5258.i.i.i.i, <8 x double> %.5304.i.i.i.i, <8 x double> %.6.i196.i.i.i.i)
  %.5426.i.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.5258.i.i.i.i, <8 x double> %.5315.i.i.i.i, <8 x double> %.6.i197.i.i.i.i)
  %.6.i198.i.i.i.i = fsub contract <8 x double> %.5192.i.i.i.i, %.5393.i.i.i.i
  %.8.i199.i.i.i.i = fmul contract <8 x double> %.6.i198.i.i.i.i, splat (double 2.000000e+00)
  %.6.i200.i.i.i.i = fsub contract <8 x double> %.5225.i.i.i.i, %.5426.i.i.i.i
  %.8.i201.i.i.i.i = fmul contract <8 x double> %.6.i200.i.i.i.i, splat (double 2.000000e+00)
  %.6.i202.i.i.i.i = fmul contract <8 x double> %.6.i975.i.i.i, %.8.i201.i.i.i.i
  %.6.i203.i.i.i.i = fsub contract <8 x double> zeroinitializer, %.6.i202.i.i.i.i
  %.5647.i.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i199.i.i.i.i, <8 x double> %.6.i974.i.i.i, <8 x double> %.6.i203.i.i.i.i)
  %.6.i204.i.i.i.i = fmul contract <8 x double> %.6.i974.i.i.i, %.8.i201.i.i.i.i
  %.5680.i.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i199.i.i.i.i, <8 x double> %.6.i975.i.i.i, <8 x double> %.6.i204.i.i.i.i)
  %.5716.i.i.i.i = add nsw i64 %lsr.iv.i3.i.i, %.5715.i.i.i.i
  br i1 %"$phi1254.1.2.1.not.i.i.i", label %_ZN17bnserve_inference13fisher_kernel9_tangents13differentiateB4v143B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE8UniTupleIdLi3EE19vector_28float64_298UniTupleI19vector_28float64_29Li2EEb5ArrayIdLi1E1C7mutable7alignedExxb.exit.i.i.i, label %B5798.i.i.i.i

B5798.i.i.i.i:                                    ; preds = %B5730.i.i.i.i
  %.5729.i.i.i.i = getelementptr inbounds double, ptr %.114.i, i64 %.5716.i.i.i.i
  %.5731.i.i.i.i = load <8 x double>, ptr %.5729.i.i.i.i, align 8, !noalias !18
  %.6.i118.i.i.i.i = fadd contract <8 x double> %.5647.i.i.i.i, %.5731.i.i.i.i
  %.5768.i.i.i.i = getelementptr i8, ptr %.5729.i.i.i.i, i64 64
  %.5770.i.i.i.i = load <8 x double>, ptr %.5768.i.i.i.i, align 8, !noalias !18
  %.6.i205.i.i.i.i = fadd contract <8 x double> %.5680.i.i.i.i, %.5770.i.i.i.i
  br label %_ZN17bnserve_inference13fisher_kernel9_tangents13differentiateB4v143B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE8UniTupleIdLi3EE19vector_28float64_298UniTupleI19vector_28float64_29Li2EEb5ArrayIdLi1E1C7mutable7alignedExxb.exit.i.i.i

B450.if.i.i.i.i:                                  ; preds = %B4639.i.i.i.i, %B2025.i.i.i
  %lsr.iv1.i.i.i.i = phi i64 [ %lsr.iv.next2.i.i.i.i, %B4639.i.i.i.i ], [ 176, %B2025.i.i.i ]
  %.129316641679.i.i.i.i = phi i64 [ %.1300.i.i.i.i, %B4639.i.i.i.i ], [ 0, %B2025.i.i.i ]
  %.1354.i.i.i.i = load <8 x double>, ptr %.437.i, align 8, !noalias !18
  %.1365.i.i.i.i = load <8 x double>, ptr %.161.i.i.i.i, align 8, !noalias !18
  %132 = shl nuw nsw i64 %lsr.iv1.i.i.i.i, 2
  %scevgep12.i.i.i.i = getelementptr i8, ptr %.249.i, i64 %132
  %scevgep7.i.i.i.i = getelementptr i8, ptr %scevgep12.i.i.i.i, i64 -192
  %.1395.i.i.i.i = load <8 x double>, ptr %scevgep7.i.i.i.i, align 8, !noalias !18
  %scevgep4.i.i.i.i = getelementptr i8, ptr %scevgep12.i.i.i.i, i64 -128
  %.1406.i.i.i.i = load <8 x double>, ptr %scevgep4.i.i.i.i, align 8, !noalias !18
  %.6.i138.i.i.i.i = fmul contract <8 x double> %.1365.i.i.i.i, %.1406.i.i.i.i
  %.6.i139.i.i.i.i = fsub contract <8 x double> zeroinitializer, %.6.i138.i.i.i.i
  %.1484.i.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1354.i.i.i.i, <8 x double> %.1395.i.i.i.i, <8 x double> %.6.i139.i.i.i.i)
  %.6.i140.i.i.i.i = fmul contract <8 x double> %.1365.i.i.i.i, %.1395.i.i.i.i
  %.1517.i.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1354.i.i.i.i, <8 x double> %.1406.i.i.i.i, <8 x double> %.6.i140.i.i.i.i)
  %.1548.i.i.i.i = load <8 x double>, ptr %.346.i.i.i.i, align 8, !noalias !18
  %.1559.i.i.i.i = load <8 x double>, ptr %scevgep.i21.i.i.i, align 8, !noalias !18
  %scevgep1.i.i.i.i = getelementptr i8, ptr %scevgep12.i.i.i.i, i64 -64
  %.1593.i.i.i.i = load <8 x double>, ptr %scevgep1.i.i.i.i, align 8, !noalias !18
  %.1604.i.i.i.i = load <8 x double>, ptr %scevgep12.i.i.i.i, align 8, !noalias !18
  %.6.i141.i.i.i.i = fmul contract <8 x double> %.1559.i.i.i.i, %.1604.i.i.i.i
  %.6.i142.i.i.i.i = fsub contract <8 x double> zeroinitializer, %.6.i141.i.i.i.i
  %.6.i143.i.i.i.i = fmul contract <8 x double> %.1559.i.i.i.i, %.1593.i.i.i.i
  %.1682.i.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1548.i.i.i.i, <8 x double> %.1593.i.i.i.i, <8 x double> %.6.i142.i.i.i.i)
  %.6.i144.i.i.i.i = fadd contract <8 x double> %.1484.i.i.i.i, %.1682.i.i.i.i
  %.1715.i14.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1548.i.i.i.i, <8 x double> %.1604.i.i.i.i, <8 x double> %.6.i143.i.i.i.i)
  %.6.i145.i.i.i.i = fadd contract <8 x double> %.1517.i.i.i.i, %.1715.i14.i.i.i
  br i1 %.not.i.i.i, label %B536.i.i.i.i, label %B706.i.i.i.i

_ZN17bnserve_inference13fisher_kernel9_tangents13differentiateB4v143B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE8UniTupleIdLi3EE19vector_28float64_298UniTupleI19vector_28float64_29Li2EEb5ArrayIdLi1E1C7mutable7alignedExxb.exit.i.i.i: ; preds = %B5798.i.i.i.i, %B5730.i.i.i.i
  %_put_v176_real.2.0.i.i.i.i = phi <8 x double> [ %.5647.i.i.i.i, %B5730.i.i.i.i ], [ %.6.i118.i.i.i.i, %B5798.i.i.i.i ]
  %_put_v176_imaginary.2.0.i.i.i.i = phi <8 x double> [ %.5680.i.i.i.i, %B5730.i.i.i.i ], [ %.6.i205.i.i.i.i, %B5798.i.i.i.i ]
  %.5816.i.i.i.i = getelementptr inbounds double, ptr %.114.i, i64 %.5716.i.i.i.i
  store <8 x double> %_put_v176_real.2.0.i.i.i.i, ptr %.5816.i.i.i.i, align 8, !noalias !18
  %.5833.i.i.i.i = getelementptr i8, ptr %.5816.i.i.i.i, i64 64
  store <8 x double> %_put_v176_imaginary.2.0.i.i.i.i, ptr %.5833.i.i.i.i, align 8, !noalias !18
  br label %B8131.i.i.i

B8131.i.i.i:                                      ; preds = %_ZN17bnserve_inference13fisher_kernel9_tangents13differentiateB4v143B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE8UniTupleIdLi3EE19vector_28float64_298UniTupleI19vector_28float64_29Li2EEb5ArrayIdLi1E1C7mutable7alignedExxb.exit.i.i.i, %_ZN17bnserve_inference13fisher_kernel9_tangents7observeB4v133B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEd8UniTupleI19vector_28float64_29Li2EE5ArrayIdLi1E1C7mutable7alignedExxb.exit.i.i.i
  %lsr.iv.next.i4.i.i = add i64 %lsr.iv.i3.i.i, %135
  %exitcond.not.i5.i.i = icmp eq i64 %.2478.i.i.i, %.2571.i.i.i
  br i1 %exitcond.not.i5.i.i, label %B1156.loopexit.i.i.i, label %B1784.if.i.i.i

B1244.lr.ph.i.i.i:                                ; preds = %B1040.i.i.i
  %.1377.i.i.i = load i64, ptr %.1376.i.i.i, align 8, !noalias !6
  %.15702592893.i.i.i = add nsw i64 %.1407.i.i.i, -1
  %.83.i.i.i.i = shl nsw i64 %.74716241632.i.i, 9
  %.532.i.i.i.i = fdiv contract double -1.000000e+00, %.862.i.i.i
  %.6.i9.i.i.i.i = insertelement <8 x double> poison, double %.532.i.i.i.i, i64 0
  %.7.i.i.i.i.i = shufflevector <8 x double> %.6.i9.i.i.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %133 = mul i64 %.184.i.i.i, 320
  %134 = getelementptr i8, ptr %.114.i, i64 %133
  %scevgep1078.i.i.i = getelementptr i8, ptr %134, i64 64
  %135 = shl i64 %_rows_of_v244__vphi136_0.2.0.i.i.i, 4
  %136 = inttoptr i64 %.1086.i.i.i to ptr
  %137 = inttoptr i64 %.1377.i.i.i to ptr
  %138 = icmp ne i64 %_rows_of_v244__vphi136_0.2.0.i.i.i, 1
  %139 = icmp sgt i64 %_rows_of_v244__vphi136_0.2.0.i.i.i, 1
  %140 = insertelement <8 x i64> poison, i64 %.805.i.i.i, i64 0
  %.791.i18.i.i.i = bitcast <8 x i64> %140 to <8 x double>
  %.792.i.i.i.i = shufflevector <8 x double> %.791.i18.i.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.807.i.i.i.i = fneg contract double %.803.i.i.i
  %.6.i2.i19.i.i.i = insertelement <8 x double> poison, double %.803.i.i.i, i64 0
  %.7.i3.i.i.i.i = shufflevector <8 x double> %.6.i2.i19.i.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.6.i5.i20.i.i.i = insertelement <8 x double> poison, double %.807.i.i.i.i, i64 0
  %.7.i6.i.i.i.i = shufflevector <8 x double> %.6.i5.i20.i.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.6.i25.i.i.i.i = insertelement <8 x double> poison, double %.695.i.i.i, i64 0
  %.7.i26.i.i.i.i = shufflevector <8 x double> %.6.i25.i.i.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1109.i.i.i.i = fneg contract double %.692.i.i.i
  %.1210.i.i.i.i = fneg contract double %.695.i.i.i
  %.1217.i.i.i.i = insertelement <8 x double> poison, double %.692.i.i.i, i64 0
  %.1218.i.i.i.i = shufflevector <8 x double> %.1217.i.i.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.8.i126.i.i.i.i = fmul contract <8 x double> %.282.i.i.i, splat (double 0xC01921FB54442D18)
  %.2810.i.i.i.i = mul nsw i64 %.184.i.i.i, 48
  %.3152.i.i.i.i = mul nsw i64 %.184.i.i.i, 40
  %.3497.i.i.i.i = shl nsw i64 %.184.i.i.i, 6
  %.3799.i.i.i.i = mul nsw i64 %.184.i.i.i, 72
  %.4144.i.i.i.i = mul nsw i64 %.184.i.i.i, 80
  %.4919.i.i.i.i = mul nsw i64 %.184.i.i.i, 88
  %.5715.i.i.i.i = mul nsw i64 %.184.i.i.i, 96
  br label %B1244.i.i.i

B1254.endif.i.i.i:                                ; preds = %B214.if.i.i.i.i, %B4182.i.i.i.i
  %storemerge.i.i.i.i = phi <8 x double> [ %.6.i7.i.i.i.i, %B4182.i.i.i.i ], [ %.382.i.i.i.i, %B214.if.i.i.i.i ]
  %.1794.i.i.i = load double, ptr %.530.i.i.i, align 8, !noalias !6
  %.6.i.i7.i.i = insertelement <8 x double> poison, double %.1794.i.i.i, i64 0
  %.7.i.i.i.i = shufflevector <8 x double> %.6.i.i7.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.8.i929.i.i.i = fmul contract <8 x double> %storemerge.i.i.i.i, %.7.i.i.i.i
  %.6.i930.i.i.i = fadd contract <8 x double> %.1675.i.i.i, %.8.i929.i.i.i
  br label %B1298.i.i.i

B1784.if.lr.ph.i.i.i:                             ; preds = %B1298.i.i.i
  %.2418.i.i.i = load double, ptr %.530.i.i.i, align 8, !noalias !6
  %141 = getelementptr i64, ptr %137, i64 %.1561.sroa.0.0896.i.i.i
  %.2370.i.i.i = icmp slt i64 %.1561.sroa.0.0896.i.i.i, 0
  %.2371.i.i.i = select i1 %.2370.i.i.i, i64 %.1407.i.i.i, i64 0
  %.2385.i.i.i = getelementptr i64, ptr %141, i64 %.2371.i.i.i
  %.2386.i.i.i = load i64, ptr %.2385.i.i.i, align 8, !noalias !6
  %.2387.i.i.i = sitofp i64 %.2386.i.i.i to double
  %.2388.i.i.i = fmul contract double %.2387.i.i.i, 5.000000e-01
  %.2439.i.i.i = icmp slt i64 %.1561.sroa.0.0896.i.i.i, 1
  %"$phi1254.1.2.1.not.i.i.i" = or i1 %138, %.2439.i.i.i
  %142 = shl i64 %.1561.sroa.0.0896.i.i.i, 4
  %143 = select i1 %139, i64 %142, i64 0
  %144 = add i64 %143, %21
  %.6.i98.i.i.i.i = insertelement <8 x double> poison, double %.2418.i.i.i, i64 0
  %.7.i.i13.i.i.i = shufflevector <8 x double> %.6.i98.i.i.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.3284.i.i.i.i = fneg contract double %.2388.i.i.i
  %.6.i107.i.i.i.i = insertelement <8 x double> poison, double %.3284.i.i.i.i, i64 0
  %.7.i108.i.i.i.i = shufflevector <8 x double> %.6.i107.i.i.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.6.i167.i.i.i.i = insertelement <8 x double> poison, double %.2388.i.i.i, i64 0
  %.7.i168.i.i.i.i = shufflevector <8 x double> %.6.i167.i.i.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  br label %B1784.if.i.i.i

B1784.if.i.i.i:                                   ; preds = %B1784.if.lr.ph.i.i.i, %B8131.i.i.i
  %lsr.iv.i3.i.i = phi i64 [ %144, %B1784.if.lr.ph.i.i.i ], [ %lsr.iv.next.i4.i.i, %B8131.i.i.i ]
  %.256425632589.i.i.i = phi i64 [ 0, %B1784.if.lr.ph.i.i.i ], [ %.2571.i.i.i, %B8131.i.i.i ]
  %.2571.i.i.i = add nuw nsw i64 %.256425632589.i.i.i, 1
  %sunkaddr49.i.i.i = shl i64 %.256425632589.i.i.i, 3
  %sunkaddr50.i.i.i = getelementptr i8, ptr %136, i64 %sunkaddr49.i.i.i
  %sunkaddr51.i.i.i = getelementptr i8, ptr %sunkaddr50.i.i.i, i64 8
  %.2626.i.i.i = load i64, ptr %sunkaddr51.i.i.i, align 8, !noalias !6
  %.2657.i.i.i = load i64, ptr %sunkaddr52.i.i.i, align 8, !noalias !6
  %.2660.i.i.i = mul nsw i64 %.2626.i.i.i, 120
  %.2661.i.i.i = add nsw i64 %.2657.i.i.i, %.2660.i.i.i
  %.2663.i.i.i = inttoptr i64 %.2661.i.i.i to ptr
  %.2741.i.i.i = load i64, ptr %sunkaddr53.i.i.i, align 8, !noalias !6
  %.2742.i.i.i = mul nsw i64 %.2626.i.i.i, 24
  %.2743.i.i.i = add nsw i64 %.2741.i.i.i, %.2742.i.i.i
  %.2744.i.i.i = inttoptr i64 %.2743.i.i.i to ptr
  call void @llvm.lifetime.start.p0(ptr nonnull %.460.i.i.i.i), !noalias !6
  store ptr null, ptr %.460.i.i.i.i, align 8, !noalias !21
  tail call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(768) %.437.i, i8 0, i64 768, i1 false), !noalias !21
  %145 = getelementptr i8, ptr %.2663.i.i.i, i64 24
  %.384.i.i.i.i = load double, ptr %145, align 8, !noalias !21
  %.385.i.i.i.i = fcmp contract une double %.384.i.i.i.i, 0.000000e+00
  br i1 %.385.i.i.i.i, label %B246.i.i.i.i, label %B344.i.i.i.i

B246.i.i.i.i:                                     ; preds = %B1784.if.i.i.i
  store ptr null, ptr %.460.i.i.i.i, align 8, !noalias !21
  call fastcc void @inner_1(ptr nonnull %.460.i.i.i.i, ptr readonly %.2663.i.i.i, double %.692.i.i.i, double %.695.i.i.i, <8 x double> %.282.i.i.i, <8 x double> %127, <8 x double> %129, ptr nonnull %.437.i)
  br label %B344.i.i.i.i

B344.i.i.i.i:                                     ; preds = %B246.i.i.i.i, %B1784.if.i.i.i
  %146 = getelementptr i8, ptr %.2663.i.i.i, i64 64
  %.384.1.i.i.i.i = load double, ptr %146, align 8, !noalias !21
  %.385.1.i.i.i.i = fcmp contract une double %.384.1.i.i.i.i, 0.000000e+00
  br i1 %.385.1.i.i.i.i, label %B246.1.i.i.i.i, label %B344.1.i.i.i.i

B246.1.i.i.i.i:                                   ; preds = %B344.i.i.i.i
  %147 = getelementptr i8, ptr %.2663.i.i.i, i64 40
  store ptr null, ptr %.460.i.i.i.i, align 8, !noalias !21
  call fastcc void @inner_1(ptr nonnull %.460.i.i.i.i, ptr readonly %147, double %.692.i.i.i, double %.695.i.i.i, <8 x double> %.282.i.i.i, <8 x double> %127, <8 x double> %129, ptr nonnull %.437.i)
  br label %B344.1.i.i.i.i

B344.1.i.i.i.i:                                   ; preds = %B246.1.i.i.i.i, %B344.i.i.i.i
  %148 = getelementptr i8, ptr %.2663.i.i.i, i64 104
  %.384.2.i.i.i.i = load double, ptr %148, align 8, !noalias !21
  %.385.2.i.i.i.i = fcmp contract une double %.384.2.i.i.i.i, 0.000000e+00
  br i1 %.385.2.i.i.i.i, label %B246.2.i.i.i.i, label %B400.if.i.i.i.i.preheader

B246.2.i.i.i.i:                                   ; preds = %B344.1.i.i.i.i
  %149 = getelementptr i8, ptr %.2663.i.i.i, i64 80
  store ptr null, ptr %.460.i.i.i.i, align 8, !noalias !21
  call fastcc void @inner_1(ptr nonnull %.460.i.i.i.i, ptr readonly %149, double %.692.i.i.i, double %.695.i.i.i, <8 x double> %.282.i.i.i, <8 x double> %127, <8 x double> %129, ptr nonnull %.437.i)
  br label %B400.if.i.i.i.i.preheader

B400.if.i.i.i.i.preheader:                        ; preds = %B246.2.i.i.i.i, %B344.1.i.i.i.i
  br label %B400.if.i.i.i.i

B400.if.i.i.i.i:                                  ; preds = %B400.if.i.i.i.i.preheader, %B400.if.i.i.i.i
  %lsr.iv.i22.i.i.i = phi i64 [ %lsr.iv.next.i24.i.i.i, %B400.if.i.i.i.i ], [ 8, %B400.if.i.i.i.i.preheader ]
  %lsr.iv43.i.i.i.i = phi ptr [ %scevgep44.i.i.i.i, %B400.if.i.i.i.i ], [ %scevgep.i21.i.i.i, %B400.if.i.i.i.i.preheader ]
  %scevgep47.i.i.i.i = getelementptr i8, ptr %lsr.iv43.i.i.i.i, i64 -192
  %.751.i.i.i.i = load <8 x double>, ptr %scevgep47.i.i.i.i, align 8, !noalias !21
  %scevgep46.i.i.i.i = getelementptr i8, ptr %lsr.iv43.i.i.i.i, i64 -64
  %.763.i23.i.i.i = load <8 x double>, ptr %scevgep46.i.i.i.i, align 8, !noalias !21
  %.8.i4.i.i.i.i = fmul contract <8 x double> %.7.i3.i.i.i.i, %.763.i23.i.i.i
  %.793.i.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.751.i.i.i.i, <8 x double> %.792.i.i.i.i, <8 x double> %.8.i4.i.i.i.i)
  store <8 x double> %.793.i.i.i.i, ptr %scevgep47.i.i.i.i, align 8, !noalias !21
  %.8.i7.i.i.i.i = fmul contract <8 x double> %.7.i6.i.i.i.i, %.751.i.i.i.i
  %.835.i.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.763.i23.i.i.i, <8 x double> %.792.i.i.i.i, <8 x double> %.8.i7.i.i.i.i)
  store <8 x double> %.835.i.i.i.i, ptr %scevgep46.i.i.i.i, align 8, !noalias !21
  %scevgep45.i.i.i.i = getelementptr i8, ptr %lsr.iv43.i.i.i.i, i64 -128
  %.751.1.i.i.i.i = load <8 x double>, ptr %scevgep45.i.i.i.i, align 8, !noalias !21
  %.763.1.i.i.i.i = load <8 x double>, ptr %lsr.iv43.i.i.i.i, align 8, !noalias !21
  %.8.i10.i.i.i.i = fmul contract <8 x double> %.7.i3.i.i.i.i, %.763.1.i.i.i.i
  %.793.1.i.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.751.1.i.i.i.i, <8 x double> %.792.i.i.i.i, <8 x double> %.8.i10.i.i.i.i)
  store <8 x double> %.793.1.i.i.i.i, ptr %scevgep45.i.i.i.i, align 8, !noalias !21
  %.8.i13.i.i.i.i = fmul contract <8 x double> %.7.i6.i.i.i.i, %.751.1.i.i.i.i
  %.835.1.i.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.763.1.i.i.i.i, <8 x double> %.792.i.i.i.i, <8 x double> %.8.i13.i.i.i.i)
  store <8 x double> %.835.1.i.i.i.i, ptr %lsr.iv43.i.i.i.i, align 8, !noalias !21
  %scevgep44.i.i.i.i = getelementptr i8, ptr %lsr.iv43.i.i.i.i, i64 256
  %lsr.iv.next.i24.i.i.i = add nsw i64 %lsr.iv.i22.i.i.i, -1
  %.585.i.i.i.i = icmp samesign ugt i64 %lsr.iv.i22.i.i.i, 6
  br i1 %.585.i.i.i.i, label %B400.if.i.i.i.i, label %_ZN17bnserve_inference13fisher_kernel9_response7respondB4v101B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE8UniTupleIdLi2EE8UniTupleIdLi2EE19vector_28float64_2919vector_28float64_2919vector_28float64_295ArrayIdLi1E1C7mutable7alignedE.exit.i.i.i

_ZN17bnserve_inference13fisher_kernel9_response7respondB4v101B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE8UniTupleIdLi2EE8UniTupleIdLi2EE19vector_28float64_2919vector_28float64_2919vector_28float64_295ArrayIdLi1E1C7mutable7alignedE.exit.i.i.i: ; preds = %B400.if.i.i.i.i
  %.889.i.i.i.i = load double, ptr %.2744.i.i.i, align 8, !noalias !21
  %.918.i.i.i.i = getelementptr i8, ptr %.2744.i.i.i, i64 8
  %.919.i.i.i.i = load double, ptr %.918.i.i.i.i, align 8, !noalias !21
  %.948.i.i.i.i = getelementptr i8, ptr %.2744.i.i.i, i64 16
  %.949.i.i.i.i = load double, ptr %.948.i.i.i.i, align 8, !noalias !21
  %.6.i.i25.i.i.i = insertelement <8 x double> poison, double %.889.i.i.i.i, i64 0
  %.7.i.i26.i.i.i = shufflevector <8 x double> %.6.i.i25.i.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.8.i.i27.i.i.i = fmul contract <8 x double> %.7.i.i26.i.i.i, %129
  %.6.i14.i28.i.i.i = insertelement <8 x double> poison, double %.919.i.i.i.i, i64 0
  %.7.i15.i.i.i.i = shufflevector <8 x double> %.6.i14.i28.i.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.8.i16.i.i.i.i = fmul contract <8 x double> %.7.i15.i.i.i.i, %127
  %.6.i17.i.i.i.i = fsub contract <8 x double> %.8.i.i27.i.i.i, %.8.i16.i.i.i.i
  %.8.i20.i.i.i.i = fmul contract <8 x double> %.7.i.i26.i.i.i, %127
  %.8.i23.i.i.i.i = fmul contract <8 x double> %.7.i15.i.i.i.i, %129
  %.6.i24.i.i.i.i = fadd contract <8 x double> %.8.i20.i.i.i.i, %.8.i23.i.i.i.i
  %.8.i27.i.i.i.i = fmul contract <8 x double> %.7.i26.i.i.i.i, %.6.i17.i.i.i.i
  %.1110.i.i.i.i = fmul contract double %.949.i.i.i.i, %.1109.i.i.i.i
  %.1111.i.i.i.i = insertelement <8 x double> poison, double %.1110.i.i.i.i, i64 0
  %.1112.i.i.i.i = shufflevector <8 x double> %.1111.i.i.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.6.i28.i.i.i.i = fsub contract <8 x double> %.1112.i.i.i.i, %.8.i27.i.i.i.i
  store <8 x double> %.6.i28.i.i.i.i, ptr %.1169.i.i.i.i, align 8, !noalias !21
  %.8.i31.i.i.i.i = fmul contract <8 x double> %.7.i26.i.i.i.i, %.6.i24.i.i.i.i
  store <8 x double> %.8.i31.i.i.i.i, ptr %.1205.i.i.i.i, align 8, !noalias !21
  %.1213.i29.i.i.i = fmul contract double %.949.i.i.i.i, %.1210.i.i.i.i
  %.1214.i.i.i.i = insertelement <8 x double> poison, double %.1213.i29.i.i.i, i64 0
  %.1215.i.i.i.i = shufflevector <8 x double> %.1214.i.i.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1219.i.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i17.i.i.i.i, <8 x double> %.1218.i.i.i.i, <8 x double> %.1215.i.i.i.i)
  store <8 x double> %.1219.i.i.i.i, ptr %.1229.i.i.i.i, align 8, !noalias !21
  call void @llvm.lifetime.end.p0(ptr nonnull %.460.i.i.i.i), !noalias !6
  %.6.i956.i.i.i = fmul contract <8 x double> %.282.i.i.i, %.6.i28.i.i.i.i
  %.8.i957.i.i.i = fmul contract <8 x double> %.6.i956.i.i.i, splat (double 0xC01921FB54442D18)
  %.2919.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i957.i.i.i, <8 x double> splat (double 0x3FE45F306DC9C883), <8 x double> splat (double 0x4338000000000000))
  %.8.i958.i.i.i = fadd contract <8 x double> %.2919.i.i.i, splat (double 0xC338000000000000)
  %.2960.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i958.i.i.i, <8 x double> splat (double 0xBFF921FB54442D18), <8 x double> %.8.i957.i.i.i)
  %.2977.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i958.i.i.i, <8 x double> splat (double 0xBC91A62633145C07), <8 x double> %.2960.i.i.i)
  %.6.i959.i.i.i = fmul contract <8 x double> %.2977.i.i.i, %.2977.i.i.i
  %.6.i960.i.i.i = fmul contract <8 x double> %.2977.i.i.i, %.6.i959.i.i.i
  %.3006.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i959.i.i.i, <8 x double> splat (double 0xBD6AE7F3E733B81F), <8 x double> splat (double 0x3DE6124613A86D09))
  %.3009.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i959.i.i.i, <8 x double> %.3006.i.i.i, <8 x double> splat (double 0xBE5AE64567F544E4))
  %.3012.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i959.i.i.i, <8 x double> %.3009.i.i.i, <8 x double> splat (double 0x3EC71DE3A556C734))
  %.3015.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i959.i.i.i, <8 x double> %.3012.i.i.i, <8 x double> splat (double 0xBF2A01A01A01A01A))
  %.3018.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i959.i.i.i, <8 x double> %.3015.i.i.i, <8 x double> splat (double 0x3F81111111111111))
  %.3021.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i959.i.i.i, <8 x double> %.3018.i.i.i, <8 x double> splat (double 0xBFC5555555555555))
  %.3046.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i960.i.i.i, <8 x double> %.3021.i.i.i, <8 x double> %.2977.i.i.i)
  %.3051.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i959.i.i.i, <8 x double> splat (double 0x3D2AE7F3E733B81F), <8 x double> splat (double 0xBDA93974A8C07C9D))
  %.3054.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i959.i.i.i, <8 x double> %.3051.i.i.i, <8 x double> splat (double 0x3E21EED8EFF8D898))
  %.3057.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i959.i.i.i, <8 x double> %.3054.i.i.i, <8 x double> splat (double 0xBE927E4FB7789F5C))
  %.3060.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i959.i.i.i, <8 x double> %.3057.i.i.i, <8 x double> splat (double 0x3EFA01A01A01A01A))
  %.3063.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i959.i.i.i, <8 x double> %.3060.i.i.i, <8 x double> splat (double 0xBF56C16C16C16C17))
  %.3066.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i959.i.i.i, <8 x double> %.3063.i.i.i, <8 x double> splat (double 0x3FA5555555555555))
  %.3069.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i959.i.i.i, <8 x double> %.3066.i.i.i, <8 x double> splat (double -5.000000e-01))
  %.3072.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i959.i.i.i, <8 x double> %.3069.i.i.i, <8 x double> splat (double 1.000000e+00))
  %.3073.i.i.i = bitcast <8 x double> %.2919.i.i.i to <8 x i64>
  %.3074.i.i.i = bitcast <8 x double> %.3046.i.i.i to <8 x i64>
  %.3075.i.i.i = bitcast <8 x double> %.3072.i.i.i to <8 x i64>
  %.6.i961.i.i.i = xor <8 x i64> %.3075.i.i.i, %.3074.i.i.i
  %.8.i962.i.i.i = and <8 x i64> %.3073.i.i.i, splat (i64 1)
  %150 = icmp eq <8 x i64> %.8.i962.i.i.i, zeroinitializer
  %.6.i964.i.i.i = select <8 x i1> %150, <8 x i64> zeroinitializer, <8 x i64> %.6.i961.i.i.i
  %.8.i965.i.i.i = shl <8 x i64> %.3073.i.i.i, splat (i64 62)
  %.8.i966.i.i.i = and <8 x i64> %.8.i965.i.i.i, splat (i64 -9223372036854775808)
  %.8.i968.i.i.i = add <8 x i64> %.8.i965.i.i.i, splat (i64 4611686018427387904)
  %.8.i969.i.i.i = and <8 x i64> %.8.i968.i.i.i, splat (i64 -9223372036854775808)
  %151 = xor <8 x i64> %.8.i966.i.i.i, %.3074.i.i.i
  %.6.i971.i.i.i = xor <8 x i64> %151, %.6.i964.i.i.i
  %152 = bitcast <8 x i64> %.6.i971.i.i.i to <8 x double>
  %153 = xor <8 x i64> %.8.i969.i.i.i, %.3075.i.i.i
  %.6.i973.i.i.i = xor <8 x i64> %153, %.6.i964.i.i.i
  %154 = bitcast <8 x i64> %.6.i973.i.i.i to <8 x double>
  %.6.i974.i.i.i = fmul contract <8 x double> %.380.i.i.i, %154
  %.6.i975.i.i.i = fmul contract <8 x double> %.380.i.i.i, %152
  %.3546.i.i.i = load i64, ptr %.466.i.i, align 8, !noalias !6
  %.3547.i.i.i = icmp eq i64 %.3546.i.i.i, 0
  %.86.i.i.i.i = load <8 x double>, ptr %.437.i, align 8, !noalias !6
  %.97.i.i.i.i = load <8 x double>, ptr %.161.i.i.i.i, align 8, !noalias !6
  %.127.i.i.i.i = load <8 x double>, ptr %.249.i, align 8, !noalias !6
  %.138.i.i.i.i = load <8 x double>, ptr %sunkaddr79.i.i.i.i, align 8, !noalias !6
  %.6.i.i902.i.i.i = fmul contract <8 x double> %.97.i.i.i.i, %.138.i.i.i.i
  %.6.i2.i.i.i.i = fsub contract <8 x double> zeroinitializer, %.6.i.i902.i.i.i
  %.218.i.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.86.i.i.i.i, <8 x double> %.127.i.i.i.i, <8 x double> %.6.i2.i.i.i.i)
  %.6.i3.i.i.i.i = fmul contract <8 x double> %.97.i.i.i.i, %.127.i.i.i.i
  %.251.i.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.86.i.i.i.i, <8 x double> %.138.i.i.i.i, <8 x double> %.6.i3.i.i.i.i)
  %.282.i.i.i.i = load <8 x double>, ptr %.346.i.i.i.i, align 8, !noalias !6
  %.293.i.i.i.i = load <8 x double>, ptr %scevgep.i21.i.i.i, align 8, !noalias !6
  %.327.i.i.i.i = load <8 x double>, ptr %sunkaddr80.i.i.i.i, align 8, !noalias !6
  %.338.i.i.i.i = load <8 x double>, ptr %sunkaddr81.i.i.i.i, align 8, !noalias !6
  %.6.i4.i.i.i.i = fmul contract <8 x double> %.293.i.i.i.i, %.338.i.i.i.i
  %.6.i5.i.i.i.i = fsub contract <8 x double> zeroinitializer, %.6.i4.i.i.i.i
  %.6.i6.i.i.i.i = fmul contract <8 x double> %.293.i.i.i.i, %.327.i.i.i.i
  %.416.i.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.282.i.i.i.i, <8 x double> %.327.i.i.i.i, <8 x double> %.6.i5.i.i.i.i)
  %.6.i7.i903.i.i.i = fadd contract <8 x double> %.218.i.i.i.i, %.416.i.i.i.i
  %.449.i.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.282.i.i.i.i, <8 x double> %.338.i.i.i.i, <8 x double> %.6.i6.i.i.i.i)
  %.6.i8.i.i.i.i = fadd contract <8 x double> %.251.i.i.i.i, %.449.i.i.i.i
  br i1 %.3547.i.i.i, label %B2024.i.i.i, label %B2025.i.i.i

_ZN17bnserve_inference13fisher_kernel7_source11_fill_panelB4v231B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxx5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE52_Room_28array_28float64_2c_201d_2c_20C_29_20x_208_29.exit.i.i: ; preds = %B1156.loopexit.i.i.i, %B1040.i.i.i
  %.169.i.i.i = load i64, ptr %.79.i, align 8, !noalias !24
  %.200.i44.i.i = load i64, ptr %sunkaddr11.i.i, align 8, !noalias !24
  %.202.i45.i.i = inttoptr i64 %.200.i44.i.i to ptr
  %155 = getelementptr i64, ptr %.202.i45.i.i, i64 %.74716241632.i.i
  %.280.i.i.i = load i64, ptr %155, align 8, !noalias !24
  %.313.i.i.i = load i64, ptr %sunkaddr13.i.i, align 8, !noalias !24
  %.170.i.i.i = shl i64 %.169.i.i.i, 3
  %.317.i.i.i = add i64 %.170.i.i.i, 8
  %.318.i.i.i = mul nsw i64 %.317.i.i.i, %.280.i.i.i
  %.319.i.i.i = add nsw i64 %.313.i.i.i, %.318.i.i.i
  %.427.i.i.i = load i64, ptr %sunkaddr20.i.i, align 8, !noalias !24
  %.429.i.i.i = inttoptr i64 %.427.i.i.i to ptr
  %156 = getelementptr i64, ptr %.429.i.i.i, i64 %.74716241632.i.i
  %.505.i.i.i = load i64, ptr %156, align 8, !noalias !24
  %.509.i.i.i = icmp eq i64 %.505.i.i.i, 1
  br i1 %.509.i.i.i, label %B228.i.i.i, label %B268.i.i.i

B278.if.preheader.i.i.i:                          ; preds = %B828.endif.endif.i.i
  %.164.i.i.i = load i64, ptr %sunkaddr17.i.i, align 8, !noalias !27
  %.200.i.i.i = mul nsw i64 %.164.i.i.i, %.1136634637.i
  %.201.i.i.i = add nsw i64 %.200.i.i.i, %done.2.01635.i.i
  %.202.i.i.i = mul nsw i64 %.201.i.i.i, 832
  %.236.i.i.i = add nsw i64 %.202.i.i.i, %.1521.i.i
  %157 = inttoptr i64 %.236.i.i.i to ptr
  %.193.i.i.i = load i64, ptr %.50.i, align 8, !noalias !27
  %gep.1.idx.i.i.i = shl i64 %.193.i.i.i, 6
  %scevgep.i.i.i = getelementptr i8, ptr %157, i64 768
  %158 = shl i64 %used.5.1.i.i, 6
  %scevgep22.i.i.i = getelementptr i8, ptr %.114.i, i64 %158
  br label %B278.if.i.i.i

B278.if.i.i.i:                                    ; preds = %B278.if.i.i.i, %B278.if.preheader.i.i.i
  %lsr.iv25.i.i.i = phi i64 [ %.1244.i.i, %B278.if.preheader.i.i.i ], [ %lsr.iv.next.i.i.i, %B278.if.i.i.i ]
  %lsr.iv23.i.i.i = phi ptr [ %scevgep22.i.i.i, %B278.if.preheader.i.i.i ], [ %scevgep24.i.i.i, %B278.if.i.i.i ]
  %lsr.iv.i.i.i = phi ptr [ %scevgep.i.i.i, %B278.if.preheader.i.i.i ], [ %scevgep9.i.i.i, %B278.if.i.i.i ]
  %.556.i.i.i = load <8 x double>, ptr %lsr.iv23.i.i.i, align 8, !noalias !27
  %scevgep21.i.i.i = getelementptr i8, ptr %lsr.iv.i.i.i, i64 -768
  store <8 x double> %.556.i.i.i, ptr %scevgep21.i.i.i, align 8, !noalias !27
  %scevgep26.i.i.i = getelementptr i8, ptr %lsr.iv23.i.i.i, i64 %gep.1.idx.i.i.i
  %.556.1.i.i.i = load <8 x double>, ptr %scevgep26.i.i.i, align 8, !noalias !27
  %scevgep20.i.i.i = getelementptr i8, ptr %lsr.iv.i.i.i, i64 -704
  store <8 x double> %.556.1.i.i.i, ptr %scevgep20.i.i.i, align 8, !noalias !27
  %scevgep27.i.i.i = getelementptr i8, ptr %scevgep26.i.i.i, i64 %gep.1.idx.i.i.i
  %.556.2.i.i.i = load <8 x double>, ptr %scevgep27.i.i.i, align 8, !noalias !27
  %scevgep19.i.i.i = getelementptr i8, ptr %lsr.iv.i.i.i, i64 -640
  store <8 x double> %.556.2.i.i.i, ptr %scevgep19.i.i.i, align 8, !noalias !27
  %scevgep28.i.i.i = getelementptr i8, ptr %scevgep27.i.i.i, i64 %gep.1.idx.i.i.i
  %.556.3.i.i.i = load <8 x double>, ptr %scevgep28.i.i.i, align 8, !noalias !27
  %scevgep18.i.i.i = getelementptr i8, ptr %lsr.iv.i.i.i, i64 -576
  store <8 x double> %.556.3.i.i.i, ptr %scevgep18.i.i.i, align 8, !noalias !27
  %scevgep29.i.i.i = getelementptr i8, ptr %scevgep28.i.i.i, i64 %gep.1.idx.i.i.i
  %.556.4.i.i.i = load <8 x double>, ptr %scevgep29.i.i.i, align 8, !noalias !27
  %scevgep17.i.i.i = getelementptr i8, ptr %lsr.iv.i.i.i, i64 -512
  store <8 x double> %.556.4.i.i.i, ptr %scevgep17.i.i.i, align 8, !noalias !27
  %scevgep30.i.i.i = getelementptr i8, ptr %scevgep29.i.i.i, i64 %gep.1.idx.i.i.i
  %.556.5.i.i.i = load <8 x double>, ptr %scevgep30.i.i.i, align 8, !noalias !27
  %scevgep16.i.i.i = getelementptr i8, ptr %lsr.iv.i.i.i, i64 -448
  store <8 x double> %.556.5.i.i.i, ptr %scevgep16.i.i.i, align 8, !noalias !27
  %scevgep31.i.i.i = getelementptr i8, ptr %scevgep30.i.i.i, i64 %gep.1.idx.i.i.i
  %.556.6.i.i.i = load <8 x double>, ptr %scevgep31.i.i.i, align 8, !noalias !27
  %scevgep15.i.i.i = getelementptr i8, ptr %lsr.iv.i.i.i, i64 -384
  store <8 x double> %.556.6.i.i.i, ptr %scevgep15.i.i.i, align 8, !noalias !27
  %scevgep32.i.i.i = getelementptr i8, ptr %scevgep31.i.i.i, i64 %gep.1.idx.i.i.i
  %.556.7.i.i.i = load <8 x double>, ptr %scevgep32.i.i.i, align 8, !noalias !27
  %scevgep14.i.i.i = getelementptr i8, ptr %lsr.iv.i.i.i, i64 -320
  store <8 x double> %.556.7.i.i.i, ptr %scevgep14.i.i.i, align 8, !noalias !27
  %scevgep33.i.i.i = getelementptr i8, ptr %scevgep32.i.i.i, i64 %gep.1.idx.i.i.i
  %.556.8.i.i.i = load <8 x double>, ptr %scevgep33.i.i.i, align 8, !noalias !27
  %scevgep13.i.i.i = getelementptr i8, ptr %lsr.iv.i.i.i, i64 -256
  store <8 x double> %.556.8.i.i.i, ptr %scevgep13.i.i.i, align 8, !noalias !27
  %scevgep34.i.i.i = getelementptr i8, ptr %scevgep33.i.i.i, i64 %gep.1.idx.i.i.i
  %.556.9.i.i.i = load <8 x double>, ptr %scevgep34.i.i.i, align 8, !noalias !27
  %scevgep12.i.i.i = getelementptr i8, ptr %lsr.iv.i.i.i, i64 -192
  store <8 x double> %.556.9.i.i.i, ptr %scevgep12.i.i.i, align 8, !noalias !27
  %scevgep35.i.i.i = getelementptr i8, ptr %scevgep34.i.i.i, i64 %gep.1.idx.i.i.i
  %.556.10.i.i.i = load <8 x double>, ptr %scevgep35.i.i.i, align 8, !noalias !27
  %scevgep11.i.i.i = getelementptr i8, ptr %lsr.iv.i.i.i, i64 -128
  store <8 x double> %.556.10.i.i.i, ptr %scevgep11.i.i.i, align 8, !noalias !27
  %scevgep36.i.i.i = getelementptr i8, ptr %scevgep35.i.i.i, i64 %gep.1.idx.i.i.i
  %.556.11.i.i.i = load <8 x double>, ptr %scevgep36.i.i.i, align 8
  %scevgep10.i.i.i = getelementptr i8, ptr %lsr.iv.i.i.i, i64 -64
  store <8 x double> %.556.11.i.i.i, ptr %scevgep10.i.i.i, align 8, !noalias !27
  %scevgep37.i.i.i = getelementptr i8, ptr %scevgep36.i.i.i, i64 %gep.1.idx.i.i.i
  %.556.12.i.i.i = load <8 x double>, ptr %scevgep37.i.i.i, align 8
  store <8 x double> %.556.12.i.i.i, ptr %lsr.iv.i.i.i, align 8, !noalias !27
  %scevgep9.i.i.i = getelementptr i8, ptr %lsr.iv.i.i.i, i64 832
  %scevgep24.i.i.i = getelementptr i8, ptr %lsr.iv23.i.i.i, i64 64
  %lsr.iv.next.i.i.i = add i64 %lsr.iv25.i.i.i, -1
  %exitcond.not.i.i.i = icmp eq i64 %lsr.iv.next.i.i.i, 0
  br i1 %exitcond.not.i.i.i, label %B840.i.i, label %B278.if.i.i.i

B840.i.i:                                         ; preds = %B278.if.i.i.i, %B828.endif.endif.i.i
  %.1588.i.i = add nsw i64 %.1244.i.i, %done.2.01635.i.i
  %.1598.i.i = select i1 %10, i64 0, i64 %.1244.i.i
  %spec.select.i.i = add nsw i64 %used.5.1.i.i, %.1598.i.i
  %exitcond1670.not.i.i = icmp eq i64 %.754.i.i, %.661.i.i
  br i1 %exitcond1670.not.i.i, label %B1140.i.i, label %B412.if.i.i

B1140.i.i:                                        ; preds = %B840.i.i, %B340.i.i
  %used.3.0.lcssa.i.i = phi i64 [ 0, %B340.i.i ], [ %spec.select.i.i, %B840.i.i ]
  %.18001641.not.i.i = icmp slt i64 %.255.i.i, 1
  br i1 %.18001641.not.i.i, label %B1390.i.i, label %B1144.if.preheader.i.i

B1144.if.preheader.i.i:                           ; preds = %B1140.i.i
  %.1657.i.i = load i64, ptr %.80.i.i, align 8, !noalias !3
  %.1661.i.i = mul nuw nsw i64 %.454.i.i, %.1136634637.i
  %.1662.i.i = add nsw i64 %.1657.i.i, %.1661.i.i
  %159 = inttoptr i64 %.1662.i.i to ptr
  %sunkaddr52.i.i = inttoptr i64 %.169.i.i to ptr
  %sunkaddr53.i.i = getelementptr i8, ptr %sunkaddr52.i.i, i64 32
  br label %B1144.if.i.i

B1390.i.i:                                        ; preds = %B1144.if.i.i, %B1140.i.i
  %160 = icmp eq i64 %.285.i.i, 0
  br i1 %160, label %_ZN17bnserve_inference13fisher_kernel7_source4_rowB3v17B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIxLi1E1C7mutable7alignedE52_Room_28array_28float64_2c_201d_2c_20C_29_20x_208_29.exit.i, label %B1426.i.i

B1426.i.i:                                        ; preds = %B1390.i.i
  %.2265.i.i = load i64, ptr %.50.i, align 8, !noalias !3
  store ptr null, ptr %.2277.i.i, align 8, !noalias !3
  call fastcc void @inner_0(ptr nonnull %.2277.i.i, ptr %.114.i, i64 %.2265.i.i, i64 %used.3.0.lcssa.i.i, ptr nonnull %.628.i, ptr %.561.i)
  call void @llvm.lifetime.start.p0(ptr nonnull %.1352.i.i.i), !noalias !3
  store ptr null, ptr %.1352.i.i.i, align 8, !noalias !30
  %.165.i.i.i = load i64, ptr %.164.i9.i.i, align 8, !noalias !30
  %.169.i10.i.i = mul nuw nsw i64 %.1136634637.i, 1352
  %.170.i11.i.i = add nsw i64 %.165.i.i.i, %.169.i10.i.i
  %.172.i.i.i = inttoptr i64 %.170.i11.i.i to ptr
  %.257.i.i.i = load i64, ptr %.256.i.i.i, align 8, !noalias !30
  %.291.i.i.i = load i64, ptr %.290.i.i.i, align 8, !noalias !30
  %.295.i.i.i = inttoptr i64 %.291.i.i.i to ptr
  %xtraiter54.i.i.i = and i64 %.257.i.i.i, 3
  %unroll_iter.i.i.i = and i64 %.257.i.i.i, 9223372036854775804
  %161 = shl i64 %.257.i.i.i, 6
  %162 = shl nuw nsw i64 %xtraiter54.i.i.i, 6
  %163 = add nsw i64 %unroll_iter.i.i.i, -4
  %164 = lshr exact i64 %163, 2
  %165 = add nuw nsw i64 %164, 1
  %166 = and i64 %165, 9223372036854775806
  %167 = icmp slt i64 %.257.i.i.i, 1
  %168 = icmp ult i64 %.257.i.i.i, 4
  %169 = icmp eq i64 %163, 0
  %170 = and i64 %163, 4
  %171 = icmp eq i64 %170, 0
  %172 = icmp eq i64 %xtraiter54.i.i.i, 0
  br label %B310.if.i.i.i

B652.i.i.i:                                       ; preds = %B552.if.i.i.i, %B552.if.prol.loopexit.i.i.i, %B480.if.i.i.i
  %total.3.2.i.i.i = phi double [ 0.000000e+00, %B480.if.i.i.i ], [ %.917.lcssa.unr.i.i.i, %B552.if.prol.loopexit.i.i.i ], [ %.917.3.i.i.i, %B552.if.i.i.i ]
  %173 = getelementptr double, ptr %.523.i.i.i, i64 %.66610311041.i.i.i
  store double %total.3.2.i.i.i, ptr %173, align 8, !noalias !30
  %indvars.iv.next.i.i.i = add nsw i64 %indvars.iv.i.i.i, -1
  %scevgep74.i.i.i = getelementptr i8, ptr %lsr.iv73.i.i.i, i64 104
  %scevgep78.i.i.i = getelementptr i8, ptr %lsr.iv77.i.i.i, i64 112
  %scevgep71.i.i.i = getelementptr i8, ptr %lsr.iv70.i.i.i, i64 112
  %exitcond1111.not.i.i.i = icmp eq i64 %.673.i14.i.i, 16
  br i1 %exitcond1111.not.i.i.i, label %B664.i.i.i, label %B480.if.i.i.i

B664.i.i.i:                                       ; preds = %B652.i.i.i
  %.441.i.i.i = add nuw nsw i64 %.43410561080.i.i.i, 1
  br i1 %167, label %B812.i.i.i, label %B694.if.lr.ph.i.i.i

B694.if.lr.ph.i.i.i:                              ; preds = %B664.i.i.i
  br i1 %168, label %B694.if.epil.preheader.i.i.i, label %B694.if.preheader.i.i.i

B694.if.preheader.i.i.i:                          ; preds = %B694.if.lr.ph.i.i.i
  %174 = mul i64 %.504.i.i.i, %lsr.iv114.i.i.i
  %scevgep116.i.i.i = getelementptr i8, ptr %.114.i, i64 %174
  br i1 %169, label %B694.if.epil.preheader7.i.i.i, label %B694.if.i.i.i

B812.loopexit.unr-lcssa.unr-lcssa.i.i.i:          ; preds = %B694.if.i.i.i
  %175 = add i64 %lsr.iv68.i.i.i, 256
  br i1 %171, label %B694.if.epil.preheader7.i.i.i, label %B812.loopexit.unr-lcssa.i.i.i

B694.if.epil.preheader7.i.i.i:                    ; preds = %B812.loopexit.unr-lcssa.unr-lcssa.i.i.i, %B694.if.preheader.i.i.i
  %lsr.iv105.epil.init.i.i.i = phi i64 [ 192, %B694.if.preheader.i.i.i ], [ %175, %B812.loopexit.unr-lcssa.unr-lcssa.i.i.i ]
  %scevgep112.epil.i.i.i = getelementptr i8, ptr %lsr.iv103.i.i.i, i64 %lsr.iv105.epil.init.i.i.i
  %scevgep113.epil.i.i.i = getelementptr i8, ptr %scevgep112.epil.i.i.i, i64 -192
  %.1104.epil10.i.i.i = load <8 x double>, ptr %scevgep113.epil.i.i.i, align 8, !noalias !30
  %scevgep122.epil.i.i.i = getelementptr i8, ptr %scevgep116.i.i.i, i64 %lsr.iv105.epil.init.i.i.i
  %scevgep123.epil.i.i.i = getelementptr i8, ptr %scevgep122.epil.i.i.i, i64 -64
  store <8 x double> %.1104.epil10.i.i.i, ptr %scevgep123.epil.i.i.i, align 8, !noalias !30
  %scevgep111.epil.i.i.i = getelementptr i8, ptr %scevgep112.epil.i.i.i, i64 -128
  %.1104.1.epil.i.i.i = load <8 x double>, ptr %scevgep111.epil.i.i.i, align 8, !noalias !30
  store <8 x double> %.1104.1.epil.i.i.i, ptr %scevgep122.epil.i.i.i, align 8, !noalias !30
  %scevgep109.epil.i.i.i = getelementptr i8, ptr %scevgep112.epil.i.i.i, i64 -64
  %.1104.2.epil.i.i.i = load <8 x double>, ptr %scevgep109.epil.i.i.i, align 8, !noalias !30
  %scevgep120.epil.i.i.i = getelementptr i8, ptr %scevgep122.epil.i.i.i, i64 64
  store <8 x double> %.1104.2.epil.i.i.i, ptr %scevgep120.epil.i.i.i, align 8, !noalias !30
  %.1104.3.epil.i.i.i = load <8 x double>, ptr %scevgep112.epil.i.i.i, align 8, !noalias !30
  %scevgep118.epil.i.i.i = getelementptr i8, ptr %scevgep122.epil.i.i.i, i64 128
  store <8 x double> %.1104.3.epil.i.i.i, ptr %scevgep118.epil.i.i.i, align 8, !noalias !30
  br label %B812.loopexit.unr-lcssa.i.i.i

B812.loopexit.unr-lcssa.i.i.i:                    ; preds = %B694.if.epil.preheader7.i.i.i, %B812.loopexit.unr-lcssa.unr-lcssa.i.i.i
  br i1 %172, label %B812.i.i.i, label %B694.if.epil.preheader.i.i.i

B694.if.epil.preheader.i.i.i:                     ; preds = %B812.loopexit.unr-lcssa.i.i.i, %B694.if.lr.ph.i.i.i
  %.105610491051.epil.init.i.i.i = phi i64 [ 0, %B694.if.lr.ph.i.i.i ], [ %unroll_iter.i.i.i, %B812.loopexit.unr-lcssa.i.i.i ]
  %176 = mul i64 %.504.i.i.i, %lsr.iv114.i.i.i
  %177 = shl i64 %.105610491051.epil.init.i.i.i, 6
  %scevgep129.i.i.i = getelementptr i8, ptr %lsr.iv103.i.i.i, i64 %177
  %178 = getelementptr i8, ptr %scevgep106.i.i.i, i64 %176
  %scevgep107.i.i.i = getelementptr i8, ptr %178, i64 %177
  br label %B694.if.epil.i.i.i

B694.if.epil.i.i.i:                               ; preds = %B694.if.epil.i.i.i, %B694.if.epil.preheader.i.i.i
  %lsr.iv126.i.i.i = phi i64 [ %lsr.iv.next127.i.i.i, %B694.if.epil.i.i.i ], [ 0, %B694.if.epil.preheader.i.i.i ]
  %scevgep130.i.i.i = getelementptr i8, ptr %scevgep129.i.i.i, i64 %lsr.iv126.i.i.i
  %.1104.epil.i.i.i = load <8 x double>, ptr %scevgep130.i.i.i, align 8, !noalias !30
  %scevgep108.i.i.i = getelementptr i8, ptr %scevgep107.i.i.i, i64 %lsr.iv126.i.i.i
  store <8 x double> %.1104.epil.i.i.i, ptr %scevgep108.i.i.i, align 8, !noalias !30
  %lsr.iv.next127.i.i.i = add nuw nsw i64 %lsr.iv126.i.i.i, 64
  %epil.iter.cmp.not.i.i.i = icmp eq i64 %162, %lsr.iv.next127.i.i.i
  br i1 %epil.iter.cmp.not.i.i.i, label %B812.i.i.i, label %B694.if.epil.i.i.i, !llvm.loop !33

B812.i.i.i:                                       ; preds = %B694.if.epil.i.i.i, %B812.loopexit.unr-lcssa.i.i.i, %B664.i.i.i
  %scevgep72.i.i.i = getelementptr i8, ptr %lsr.iv71.i.i.i, i64 8
  %scevgep104.i.i.i = getelementptr i8, ptr %lsr.iv103.i.i.i, i64 %161
  %lsr.iv.next115.i.i.i = add nuw nsw i64 %lsr.iv114.i.i.i, 64
  %exitcond1114.not.i.i.i = icmp eq i64 %.441.i.i.i, 13
  br i1 %exitcond1114.not.i.i.i, label %B814.i.i.i, label %B310.if.i.i.i

B814.i.i.i:                                       ; preds = %B812.i.i.i
  tail call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(1352) %.628.i, i8 0, i64 1352, i1 false), !noalias !30
  %.1337.i.i.i = load i64, ptr %.50.i, align 8, !noalias !30
  %.1339.i.i.i = add nsw i64 %.257.i.i.i, 2
  store ptr null, ptr %.1352.i.i.i, align 8, !noalias !30
  call fastcc void @inner_0(ptr nonnull %.1352.i.i.i, ptr %.114.i, i64 %.1337.i.i.i, i64 %.1339.i.i.i, ptr nonnull %.628.i, ptr %.561.i)
  %.1421.i.i.i = load i64, ptr %.500.i.i, align 8, !noalias !30
  %.1433.i.i.i = add nsw i64 %.1421.i.i.i, %.169.i10.i.i
  %179 = inttoptr i64 %.1433.i.i.i to ptr
  %.16403.i.i.i = load double, ptr %.628.i, align 8, !noalias !30
  store double %.16403.i.i.i, ptr %179, align 8, !noalias !30
  br label %B1192.if.1.i.i.i

B310.if.i.i.i:                                    ; preds = %B812.i.i.i, %B1426.i.i
  %lsr.iv114.i.i.i = phi i64 [ %lsr.iv.next115.i.i.i, %B812.i.i.i ], [ 0, %B1426.i.i ]
  %lsr.iv103.i.i.i = phi ptr [ %scevgep104.i.i.i, %B812.i.i.i ], [ %.295.i.i.i, %B1426.i.i ]
  %lsr.iv71.i.i.i = phi ptr [ %scevgep72.i.i.i, %B812.i.i.i ], [ %.172.i.i.i, %B1426.i.i ]
  %.43410561080.i.i.i = phi i64 [ %.441.i.i.i, %B812.i.i.i ], [ 0, %B1426.i.i ]
  %.504.i.i.i = load i64, ptr %.50.i, align 8, !noalias !30
  %.505.i13.i.i = shl i64 %.43410561080.i.i.i, 3
  %.507.i.i.i = mul i64 %.505.i13.i.i, %.504.i.i.i
  %.523.i.i.i = getelementptr inbounds double, ptr %.114.i, i64 %.507.i.i.i
  br label %B480.if.i.i.i

B480.if.i.i.i:                                    ; preds = %B310.if.i.i.i, %B652.i.i.i
  %lsr.iv70.i.i.i = phi ptr [ %scevgep69.i.i.i, %B310.if.i.i.i ], [ %scevgep71.i.i.i, %B652.i.i.i ]
  %lsr.iv77.i.i.i = phi ptr [ %.628.i, %B310.if.i.i.i ], [ %scevgep78.i.i.i, %B652.i.i.i ]
  %lsr.iv73.i.i.i = phi ptr [ %lsr.iv71.i.i.i, %B310.if.i.i.i ], [ %scevgep74.i.i.i, %B652.i.i.i ]
  %indvars.iv.i.i.i = phi i64 [ 13, %B310.if.i.i.i ], [ %indvars.iv.next.i.i.i, %B652.i.i.i ]
  %.66610311041.i.i.i = phi i64 [ 0, %B310.if.i.i.i ], [ %.673.i14.i.i, %B652.i.i.i ]
  %smax54.i.i.i = tail call i64 @llvm.smax.i64(i64 %indvars.iv.i.i.i, i64 0)
  %180 = and i64 %smax54.i.i.i, 3
  %181 = shl nuw nsw i64 %180, 3
  %scevgep55.i.i.i = getelementptr i8, ptr %lsr.iv70.i.i.i, i64 %181
  %182 = add nuw i64 %180, %.66610311041.i.i.i
  %183 = mul nuw nsw i64 %182, 104
  %scevgep62.i.i.i = getelementptr i8, ptr %lsr.iv71.i.i.i, i64 %183
  %184 = and i64 %smax54.i.i.i, 9223372036854775804
  %185 = add nsw i64 %smax54.i.i.i, -1
  %.673.i14.i.i = add nuw nsw i64 %.66610311041.i.i.i, 1
  %.709.i.i.i = icmp samesign ult i64 %.66610311041.i.i.i, 13
  br i1 %.709.i.i.i, label %B552.if.preheader.i.i.i, label %B652.i.i.i

B552.if.preheader.i.i.i:                          ; preds = %B480.if.i.i.i
  %lcmp.mod.not.i.i.i = icmp eq i64 %180, 0
  br i1 %lcmp.mod.not.i.i.i, label %B552.if.prol.loopexit.i.i.i, label %B552.if.prol.i.i.i

B552.if.prol.i.i.i:                               ; preds = %B552.if.preheader.i.i.i, %B552.if.prol.i.i.i
  %lsr.iv75.i.i.i = phi ptr [ %scevgep76.i.i.i, %B552.if.prol.i.i.i ], [ %lsr.iv73.i.i.i, %B552.if.preheader.i.i.i ]
  %total.2.31027.prol.i.i.i = phi double [ %.917.prol.i.i.i, %B552.if.prol.i.i.i ], [ 0.000000e+00, %B552.if.preheader.i.i.i ]
  %prol.iter.i.i.i = phi i64 [ %prol.iter.next.i.i.i, %B552.if.prol.i.i.i ], [ 0, %B552.if.preheader.i.i.i ]
  %186 = shl nuw nsw i64 %prol.iter.i.i.i, 3
  %scevgep.i26.i.i = getelementptr i8, ptr %lsr.iv77.i.i.i, i64 %186
  %.878.prol.i.i.i = load double, ptr %scevgep.i26.i.i, align 8, !noalias !30
  %.914.prol.i.i.i = load double, ptr %lsr.iv75.i.i.i, align 8, !noalias !30
  %.915.prol.i.i.i = fmul contract double %.878.prol.i.i.i, %.914.prol.i.i.i
  %.917.prol.i.i.i = fadd contract double %total.2.31027.prol.i.i.i, %.915.prol.i.i.i
  %prol.iter.next.i.i.i = add nuw nsw i64 %prol.iter.i.i.i, 1
  %scevgep76.i.i.i = getelementptr i8, ptr %lsr.iv75.i.i.i, i64 104
  %prol.iter.cmp.not.i.i.i = icmp eq i64 %180, %prol.iter.next.i.i.i
  br i1 %prol.iter.cmp.not.i.i.i, label %B552.if.prol.loopexit.i.i.i, label %B552.if.prol.i.i.i, !llvm.loop !35

B552.if.prol.loopexit.i.i.i:                      ; preds = %B552.if.prol.i.i.i, %B552.if.preheader.i.i.i
  %.917.lcssa.unr.i.i.i = phi double [ poison, %B552.if.preheader.i.i.i ], [ %.917.prol.i.i.i, %B552.if.prol.i.i.i ]
  %total.2.31027.unr.i.i.i = phi double [ 0.000000e+00, %B552.if.preheader.i.i.i ], [ %.917.prol.i.i.i, %B552.if.prol.i.i.i ]
  %187 = icmp ult i64 %185, 3
  br i1 %187, label %B652.i.i.i, label %B552.if.i.i.i

B552.if.i.i.i:                                    ; preds = %B552.if.prol.loopexit.i.i.i, %B552.if.i.i.i
  %lsr.iv63.i.i.i = phi ptr [ %scevgep64.i.i.i, %B552.if.i.i.i ], [ %scevgep62.i.i.i, %B552.if.prol.loopexit.i.i.i ]
  %lsr.iv54.i.i.i = phi i64 [ %lsr.iv.next.i27.i.i, %B552.if.i.i.i ], [ 0, %B552.if.prol.loopexit.i.i.i ]
  %total.2.31027.i.i.i = phi double [ %.917.3.i.i.i, %B552.if.i.i.i ], [ %total.2.31027.unr.i.i.i, %B552.if.prol.loopexit.i.i.i ]
  %scevgep66.i.i.i = getelementptr i8, ptr %lsr.iv63.i.i.i, i64 208
  %188 = shl i64 %lsr.iv54.i.i.i, 3
  %scevgep56.i.i.i = getelementptr i8, ptr %scevgep55.i.i.i, i64 %188
  %scevgep58.i.i.i = getelementptr i8, ptr %scevgep56.i.i.i, i64 8
  %scevgep57.i.i.i = getelementptr i8, ptr %scevgep56.i.i.i, i64 -16
  %.878.i.i.i = load double, ptr %scevgep57.i.i.i, align 8, !noalias !30
  %.914.i.i.i = load double, ptr %lsr.iv63.i.i.i, align 8, !noalias !30
  %.915.i.i.i = fmul contract double %.878.i.i.i, %.914.i.i.i
  %.917.i.i.i = fadd contract double %total.2.31027.i.i.i, %.915.i.i.i
  %scevgep60.i.i.i = getelementptr i8, ptr %scevgep56.i.i.i, i64 -8
  %.878.1.i.i.i = load double, ptr %scevgep60.i.i.i, align 8, !noalias !30
  %scevgep67.i.i.i = getelementptr i8, ptr %lsr.iv63.i.i.i, i64 104
  %.914.1.i.i.i = load double, ptr %scevgep67.i.i.i, align 8, !noalias !30
  %.915.1.i.i.i = fmul contract double %.878.1.i.i.i, %.914.1.i.i.i
  %.917.1.i.i.i = fadd contract double %.917.i.i.i, %.915.1.i.i.i
  %.878.2.i.i.i = load double, ptr %scevgep56.i.i.i, align 8, !noalias !30
  %.914.2.i.i.i = load double, ptr %scevgep66.i.i.i, align 8, !noalias !30
  %.915.2.i.i.i = fmul contract double %.878.2.i.i.i, %.914.2.i.i.i
  %.917.2.i.i.i = fadd contract double %.917.1.i.i.i, %.915.2.i.i.i
  %.878.3.i.i.i = load double, ptr %scevgep58.i.i.i, align 8, !noalias !30
  %scevgep65.i.i.i = getelementptr i8, ptr %lsr.iv63.i.i.i, i64 312
  %.914.3.i.i.i = load double, ptr %scevgep65.i.i.i, align 8, !noalias !30
  %.915.3.i.i.i = fmul contract double %.878.3.i.i.i, %.914.3.i.i.i
  %.917.3.i.i.i = fadd contract double %.917.2.i.i.i, %.915.3.i.i.i
  %lsr.iv.next.i27.i.i = add i64 %lsr.iv54.i.i.i, 4
  %scevgep64.i.i.i = getelementptr i8, ptr %lsr.iv63.i.i.i, i64 416
  %exitcond.not.3.i.i.i = icmp eq i64 %184, %lsr.iv.next.i27.i.i
  br i1 %exitcond.not.3.i.i.i, label %B652.i.i.i, label %B552.if.i.i.i

B694.if.i.i.i:                                    ; preds = %B694.if.preheader.i.i.i, %B694.if.i.i.i
  %lsr.iv69.i.i.i = phi i64 [ %lsr.iv.next70.i.i.i, %B694.if.i.i.i ], [ %166, %B694.if.preheader.i.i.i ]
  %lsr.iv68.i.i.i = phi i64 [ %lsr.iv.next69.i.i.i, %B694.if.i.i.i ], [ 448, %B694.if.preheader.i.i.i ]
  %scevgep97.i.i.i = getelementptr i8, ptr %lsr.iv103.i.i.i, i64 %lsr.iv68.i.i.i
  %scevgep98.i.i.i = getelementptr i8, ptr %scevgep97.i.i.i, i64 -256
  %scevgep103.i.i.i = getelementptr i8, ptr %scevgep97.i.i.i, i64 -448
  %.1104.i.i.i = load <8 x double>, ptr %scevgep103.i.i.i, align 8, !noalias !30
  %scevgep87.i.i.i = getelementptr i8, ptr %scevgep116.i.i.i, i64 %lsr.iv68.i.i.i
  %scevgep89.i.i.i = getelementptr i8, ptr %scevgep87.i.i.i, i64 -256
  %scevgep88.i.i.i = getelementptr i8, ptr %scevgep87.i.i.i, i64 -320
  store <8 x double> %.1104.i.i.i, ptr %scevgep88.i.i.i, align 8, !noalias !30
  %scevgep105.i.i.i = getelementptr i8, ptr %scevgep97.i.i.i, i64 -384
  %.1104.1.i.i.i = load <8 x double>, ptr %scevgep105.i.i.i, align 8, !noalias !30
  store <8 x double> %.1104.1.i.i.i, ptr %scevgep89.i.i.i, align 8, !noalias !30
  %scevgep101.i.i.i = getelementptr i8, ptr %scevgep97.i.i.i, i64 -320
  %.1104.2.i.i.i = load <8 x double>, ptr %scevgep101.i.i.i, align 8, !noalias !30
  %scevgep86.i.i.i = getelementptr i8, ptr %scevgep87.i.i.i, i64 -192
  store <8 x double> %.1104.2.i.i.i, ptr %scevgep86.i.i.i, align 8, !noalias !30
  %.1104.3.i.i.i = load <8 x double>, ptr %scevgep98.i.i.i, align 8, !noalias !30
  %scevgep84.i.i.i = getelementptr i8, ptr %scevgep87.i.i.i, i64 -128
  store <8 x double> %.1104.3.i.i.i, ptr %scevgep84.i.i.i, align 8, !noalias !30
  %scevgep99.i.i.i = getelementptr i8, ptr %scevgep97.i.i.i, i64 -192
  %.1104.114.i.i.i = load <8 x double>, ptr %scevgep99.i.i.i, align 8, !noalias !30
  %scevgep82.i.i.i = getelementptr i8, ptr %scevgep87.i.i.i, i64 -64
  store <8 x double> %.1104.114.i.i.i, ptr %scevgep82.i.i.i, align 8, !noalias !30
  %scevgep95.i.i.i = getelementptr i8, ptr %scevgep97.i.i.i, i64 -128
  %.1104.1.1.i.i.i = load <8 x double>, ptr %scevgep95.i.i.i, align 8, !noalias !30
  store <8 x double> %.1104.1.1.i.i.i, ptr %scevgep87.i.i.i, align 8, !noalias !30
  %scevgep92.i.i.i = getelementptr i8, ptr %scevgep97.i.i.i, i64 -64
  %.1104.2.1.i.i.i = load <8 x double>, ptr %scevgep92.i.i.i, align 8, !noalias !30
  %scevgep80.i.i.i = getelementptr i8, ptr %scevgep87.i.i.i, i64 64
  store <8 x double> %.1104.2.1.i.i.i, ptr %scevgep80.i.i.i, align 8, !noalias !30
  %.1104.3.1.i.i.i = load <8 x double>, ptr %scevgep97.i.i.i, align 8, !noalias !30
  %scevgep77.i.i.i = getelementptr i8, ptr %scevgep87.i.i.i, i64 128
  store <8 x double> %.1104.3.1.i.i.i, ptr %scevgep77.i.i.i, align 8, !noalias !30
  %lsr.iv.next69.i.i.i = add i64 %lsr.iv68.i.i.i, 512
  %lsr.iv.next70.i.i.i = add i64 %lsr.iv69.i.i.i, -2
  %niter.ncmp.1.i.i.i = icmp eq i64 %lsr.iv.next70.i.i.i, 0
  br i1 %niter.ncmp.1.i.i.i, label %B812.loopexit.unr-lcssa.unr-lcssa.i.i.i, label %B694.if.i.i.i

B1192.if.1.i.i.i:                                 ; preds = %B1192.if.1.i.i.i, %B814.i.i.i
  %lsr.iv.i15.i.i = phi i64 [ %lsr.iv.next18.i.i.i, %B1192.if.1.i.i.i ], [ 8, %B814.i.i.i ]
  %189 = shl nuw nsw i64 %lsr.iv.i15.i.i, 3
  %scevgep52.i16.i.i = getelementptr i8, ptr %.628.i, i64 %189
  %scevgep51.i.i.i = getelementptr i8, ptr %scevgep52.i16.i.i, i64 -40
  %scevgep48.i.i.i = getelementptr i8, ptr %scevgep52.i16.i.i, i64 -56
  %.1640.1.i.i.i = load double, ptr %scevgep48.i.i.i, align 8, !noalias !30
  %scevgep32.i17.i.i = getelementptr i8, ptr %179, i64 %189
  %scevgep30.i18.i.i = getelementptr i8, ptr %scevgep32.i17.i.i, i64 -40
  %scevgep28.i19.i.i = getelementptr i8, ptr %scevgep32.i17.i.i, i64 -56
  store double %.1640.1.i.i.i, ptr %scevgep28.i19.i.i, align 8, !noalias !30
  %scevgep45.i.i.i = getelementptr i8, ptr %scevgep52.i16.i.i, i64 -48
  %.1640.2.i.i.i = load double, ptr %scevgep45.i.i.i, align 8, !noalias !30
  %scevgep25.i.i.i = getelementptr i8, ptr %scevgep32.i17.i.i, i64 -48
  store double %.1640.2.i.i.i, ptr %scevgep25.i.i.i, align 8, !noalias !30
  %.1640.3.i.i.i = load double, ptr %scevgep51.i.i.i, align 8, !noalias !30
  store double %.1640.3.i.i.i, ptr %scevgep30.i18.i.i, align 8, !noalias !30
  %scevgep43.i.i.i = getelementptr i8, ptr %scevgep52.i16.i.i, i64 -32
  %.1640.i.i.i = load double, ptr %scevgep43.i.i.i, align 8, !noalias !30
  %scevgep22.i20.i.i = getelementptr i8, ptr %scevgep32.i17.i.i, i64 -32
  store double %.1640.i.i.i, ptr %scevgep22.i20.i.i, align 8, !noalias !30
  %scevgep40.i.i.i = getelementptr i8, ptr %scevgep52.i16.i.i, i64 -8
  %scevgep37.i21.i.i = getelementptr i8, ptr %scevgep52.i16.i.i, i64 -24
  %.1640.1.1.i.i.i = load double, ptr %scevgep37.i21.i.i, align 8, !noalias !30
  %scevgep20.i22.i.i = getelementptr i8, ptr %scevgep32.i17.i.i, i64 -8
  %scevgep17.i23.i.i = getelementptr i8, ptr %scevgep32.i17.i.i, i64 -24
  store double %.1640.1.1.i.i.i, ptr %scevgep17.i23.i.i, align 8, !noalias !30
  %scevgep35.i24.i.i = getelementptr i8, ptr %scevgep52.i16.i.i, i64 -16
  %.1640.2.1.i.i.i = load double, ptr %scevgep35.i24.i.i, align 8, !noalias !30
  %scevgep13.i25.i.i = getelementptr i8, ptr %scevgep32.i17.i.i, i64 -16
  store double %.1640.2.1.i.i.i, ptr %scevgep13.i25.i.i, align 8, !noalias !30
  %.1640.3.1.i.i.i = load double, ptr %scevgep40.i.i.i, align 8, !noalias !30
  store double %.1640.3.1.i.i.i, ptr %scevgep20.i22.i.i, align 8, !noalias !30
  %.1640.115.i.i.i = load double, ptr %scevgep52.i16.i.i, align 8, !noalias !30
  store double %.1640.115.i.i.i, ptr %scevgep32.i17.i.i, align 8, !noalias !30
  %lsr.iv.next18.i.i.i = add nuw nsw i64 %lsr.iv.i15.i.i, 8
  %exitcond1116.not.1.i.i.i = icmp eq i64 %lsr.iv.next18.i.i.i, 176
  br i1 %exitcond1116.not.1.i.i.i, label %_ZN17bnserve_inference13fisher_kernel7_source7_finishB4v211B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIxLi1E1C7mutable7alignedE52_Room_28array_28float64_2c_201d_2c_20C_29_20x_208_29.exit.i.i, label %B1192.if.1.i.i.i

_ZN17bnserve_inference13fisher_kernel7_source7_finishB4v211B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIxLi1E1C7mutable7alignedE52_Room_28array_28float64_2c_201d_2c_20C_29_20x_208_29.exit.i.i: ; preds = %B1192.if.1.i.i.i
  call void @llvm.lifetime.end.p0(ptr nonnull %.1352.i.i.i), !noalias !3
  br label %_ZN17bnserve_inference13fisher_kernel7_source4_rowB3v17B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIxLi1E1C7mutable7alignedE52_Room_28array_28float64_2c_201d_2c_20C_29_20x_208_29.exit.i

B412.if.i.i:                                      ; preds = %B840.i.i, %B412.if.preheader.i.i
  %done.2.01635.i.i = phi i64 [ %.1588.i.i, %B840.i.i ], [ 0, %B412.if.preheader.i.i ]
  %used.3.01634.i.i = phi i64 [ %spec.select.i.i, %B840.i.i ], [ 0, %B412.if.preheader.i.i ]
  %.74716241632.i.i = phi i64 [ %.754.i.i, %B840.i.i ], [ 0, %B412.if.preheader.i.i ]
  %.754.i.i = add nuw nsw i64 %.74716241632.i.i, 1
  %.827.i.i = load i64, ptr %sunkaddr20.i.i, align 8, !noalias !3
  %.829.i.i = inttoptr i64 %.827.i.i to ptr
  %190 = getelementptr i64, ptr %.829.i.i, i64 %.74716241632.i.i
  %.905.i.i = load i64, ptr %190, align 8, !noalias !3
  %.909.i.i = icmp eq i64 %.905.i.i, 1
  br i1 %.909.i.i, label %B550.i.i, label %B774.i.i

B228.i.i.i:                                       ; preds = %_ZN17bnserve_inference13fisher_kernel7_source11_fill_panelB4v231B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxx5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE52_Room_28array_28float64_2c_201d_2c_20C_29_20x_208_29.exit.i.i
  %.540.i.i.i = load i64, ptr %sunkaddr.i.i, align 8, !noalias !24
  %191 = shl nsw i64 %.540.i.i.i, 1
  br label %B268.i.i.i

B268.i.i.i:                                       ; preds = %B228.i.i.i, %_ZN17bnserve_inference13fisher_kernel7_source11_fill_panelB4v231B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxx5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE52_Room_28array_28float64_2c_201d_2c_20C_29_20x_208_29.exit.i.i
  %_rows_of_v252__vphi136_0.2.0.i.i.i = phi i64 [ %191, %B228.i.i.i ], [ 2, %_ZN17bnserve_inference13fisher_kernel7_source11_fill_panelB4v231B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxx5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE52_Room_28array_28float64_2c_201d_2c_20C_29_20x_208_29.exit.i.i ]
  %192 = inttoptr i64 %.319.i.i.i to ptr
  %.720.i.i.i = load i64, ptr %192, align 8, !noalias !24
  %.800602.not.i.i.i = icmp slt i64 %.720.i.i.i, 1
  br i1 %.800602.not.i.i.i, label %B828.endif.endif.i.i, label %B270.if.lr.ph.i.i.i

B270.loopexit.i.i.i:                              ; preds = %B416.if.i.i.i, %B270.if.i.i.i
  %scevgep52.i.i.i = getelementptr i8, ptr %lsr.iv.i47.i.i, i64 %195
  %exitcond616.not.i.i.i = icmp eq i64 %.813.i.i.i, %.720.i.i.i
  br i1 %exitcond616.not.i.i.i, label %B828.endif.endif.i.i, label %B270.if.i.i.i

B270.if.lr.ph.i.i.i:                              ; preds = %B268.i.i.i
  %.614.i.i.i = load i64, ptr %.50.i, align 8, !noalias !24
  %.634.idx.i.i.i = mul i64 %.614.i.i.i, 320
  %193 = shl i64 %used.5.1.i.i, 6
  %194 = getelementptr i8, ptr %.114.i, i64 %.634.idx.i.i.i
  %scevgep.i46.i.i = getelementptr i8, ptr %194, i64 %193
  %195 = shl i64 %_rows_of_v252__vphi136_0.2.0.i.i.i, 6
  %196 = icmp slt i64 %_rows_of_v252__vphi136_0.2.0.i.i.i, 1
  br label %B270.if.i.i.i

B270.if.i.i.i:                                    ; preds = %B270.if.lr.ph.i.i.i, %B270.loopexit.i.i.i
  %lsr.iv.i47.i.i = phi ptr [ %scevgep.i46.i.i, %B270.if.lr.ph.i.i.i ], [ %scevgep52.i.i.i, %B270.loopexit.i.i.i ]
  %.806595603.i.i.i = phi i64 [ 0, %B270.if.lr.ph.i.i.i ], [ %.813.i.i.i, %B270.loopexit.i.i.i ]
  %.813.i.i.i = add nuw nsw i64 %.806595603.i.i.i, 1
  br i1 %196, label %B270.loopexit.i.i.i, label %B416.if.i.preheader.i.i

B416.if.i.preheader.i.i:                          ; preds = %B270.if.i.i.i
  %sunkaddr41.i.i = shl i64 %.806595603.i.i.i, 3
  %sunkaddr42.i.i = getelementptr i8, ptr %192, i64 %sunkaddr41.i.i
  %sunkaddr43.i.i = getelementptr i8, ptr %sunkaddr42.i.i, i64 8
  br label %B416.if.i.i.i

B416.if.i.i.i:                                    ; preds = %B416.if.i.i.i, %B416.if.i.preheader.i.i
  %lsr.iv55.i.i.i = phi i64 [ %lsr.iv.next.i48.i.i, %B416.if.i.i.i ], [ %_rows_of_v252__vphi136_0.2.0.i.i.i, %B416.if.i.preheader.i.i ]
  %lsr.iv53.i.i.i = phi ptr [ %scevgep54.i.i.i, %B416.if.i.i.i ], [ %lsr.iv.i47.i.i, %B416.if.i.preheader.i.i ]
  %.977.i.i.i = load <8 x double>, ptr %lsr.iv53.i.i.i, align 8, !noalias !24
  %.1015.i.i.i = load i64, ptr %sunkaddr43.i.i, align 8, !noalias !24
  %.6.i.i.i.i = fmul contract <8 x double> %.977.i.i.i, %.977.i.i.i
  %.1054.idx.i.i.i = shl nsw i64 %.1015.i.i.i, 6
  %.1054.i.i.i = getelementptr inbounds i8, ptr %.499.i, i64 %.1054.idx.i.i.i
  %.1056.i.i.i = load <8 x double>, ptr %.1054.i.i.i, align 8, !noalias !24
  %.6.i19.i.i.i = fadd contract <8 x double> %.6.i.i.i.i, %.1056.i.i.i
  store <8 x double> %.6.i19.i.i.i, ptr %.1054.i.i.i, align 8, !noalias !24
  %scevgep54.i.i.i = getelementptr i8, ptr %lsr.iv53.i.i.i, i64 64
  %lsr.iv.next.i48.i.i = add i64 %lsr.iv55.i.i.i, -1
  %exitcond.not.i49.i.i = icmp eq i64 %lsr.iv.next.i48.i.i, 0
  br i1 %exitcond.not.i49.i.i, label %B270.loopexit.i.i.i, label %B416.if.i.i.i

B828.endif.endif.i.i:                             ; preds = %B270.loopexit.i.i.i, %B268.i.i.i
  %.1521.i.i = load i64, ptr %sunkaddr44.i.i, align 8, !noalias !3
  %.1522.not.i.i = icmp eq i64 %.1521.i.i, 0
  %.374275.not.i.i.i = icmp slt i64 %.1244.i.i, 1
  %or.cond.i.i = or i1 %.374275.not.i.i.i, %.1522.not.i.i
  br i1 %or.cond.i.i, label %B840.i.i, label %B278.if.preheader.i.i.i

B1144.if.i.i:                                     ; preds = %B1144.if.i.i, %B1144.if.preheader.i.i
  %lsr.iv.i.i = phi ptr [ %scevgep96.i.i, %B1144.if.i.i ], [ %.499.i, %B1144.if.preheader.i.i ]
  %.180616401642.i.i = phi i64 [ %.1813.i.i, %B1144.if.i.i ], [ 0, %B1144.if.preheader.i.i ]
  %.1813.i.i = add nuw nsw i64 %.180616401642.i.i, 1
  %.1853.i.i = load <8 x double>, ptr %lsr.iv.i.i, align 8, !noalias !3
  store <8 x double> %.1853.i.i, ptr %.561.i, align 8, !noalias !3
  %.1905.i.i = load double, ptr %.561.i, align 8, !noalias !3
  %.1934.i.i = load double, ptr %sunkaddr22.i.i.i.i, align 8, !noalias !3
  %.1935.i.i = fadd contract double %.1905.i.i, %.1934.i.i
  %.1964.i.i = load double, ptr %sunkaddr33.i.i.i.i, align 8, !noalias !3
  %.1993.i.i = load double, ptr %sunkaddr41.i.i.i.i, align 8, !noalias !3
  %.1994.i.i = fadd contract double %.1964.i.i, %.1993.i.i
  %.1995.i.i = fadd contract double %.1935.i.i, %.1994.i.i
  %.2024.i.i = load double, ptr %sunkaddr52.i.i.i.i, align 8, !noalias !3
  %.2053.i.i = load double, ptr %sunkaddr62.i.i.i.i, align 8, !noalias !3
  %.2054.i.i = fadd contract double %.2024.i.i, %.2053.i.i
  %.2083.i.i = load double, ptr %sunkaddr69.i.i.i.i, align 8, !noalias !3
  %.2112.i.i = load double, ptr %sunkaddr77.i.i.i.i, align 8, !noalias !3
  %.2116.i.i = fadd contract double %.2083.i.i, %.2112.i.i
  %.2117.i.i = fadd contract double %.2054.i.i, %.2116.i.i
  %.2118.i.i = fadd contract double %.1995.i.i, %.2117.i.i
  %.2148.i.i = load double, ptr %sunkaddr53.i.i, align 8, !noalias !3
  %.2149.i.i = fmul contract double %.2148.i.i, %.2118.i.i
  %.2180.i.i = fmul contract double %.2148.i.i, %.2149.i.i
  %197 = shl i64 %.180616401642.i.i, 3
  %scevgep.i.i = getelementptr i8, ptr %159, i64 %197
  store double %.2180.i.i, ptr %scevgep.i.i, align 8, !noalias !3
  %scevgep96.i.i = getelementptr i8, ptr %lsr.iv.i.i, i64 64
  %exitcond1671.not.i.i = icmp eq i64 %.255.i.i, %.1813.i.i
  br i1 %exitcond1671.not.i.i, label %B1390.i.i, label %B1144.if.i.i

_ZN17bnserve_inference13fisher_kernel7_source4_rowB3v17B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIxLi1E1C7mutable7alignedE52_Room_28array_28float64_2c_201d_2c_20C_29_20x_208_29.exit.i: ; preds = %_ZN17bnserve_inference13fisher_kernel7_source7_finishB4v211B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIxLi1E1C7mutable7alignedE52_Room_28array_28float64_2c_201d_2c_20C_29_20x_208_29.exit.i.i, %B1390.i.i
  call void @llvm.lifetime.end.p0(ptr nonnull %.1330.i.i), !noalias !0
  call void @llvm.lifetime.end.p0(ptr nonnull %.2277.i.i), !noalias !0
  br label %B290.i

B256.i:                                           ; preds = %B192.if.i
  %.50.i.i = load i64, ptr %.79.i, align 8, !noalias !36
  %.81.i.i = load i64, ptr %.80.i.i, align 8, !noalias !36
  %.82.i.i = shl i64 %.1136634637.i, 3
  %.84.i.i = mul i64 %.82.i.i, %.50.i.i
  %.85.i.i = add nsw i64 %.84.i.i, %.81.i.i
  %.322.i.i = icmp slt i64 %.50.i.i, 1
  br i1 %.322.i.i, label %.388.if.i.i, label %.388.endif.preheader.i.i, !prof !39

.388.endif.preheader.i.i:                         ; preds = %B256.i
  %xtraiter.i.i = and i64 %.50.i.i, 7
  %198 = icmp ult i64 %.50.i.i, 8
  br i1 %198, label %.388.endif.epil.preheader.i.i, label %.388.endif.preheader.new.i.i, !prof !40

.388.endif.preheader.new.i.i:                     ; preds = %.388.endif.preheader.i.i
  %199 = add nsw i64 %.50.i.i, -8
  %200 = lshr i64 %199, 3
  %201 = icmp eq i64 %200, 0
  br i1 %201, label %.388.endif.epil.preheader4.i.i, label %.388.endif.preheader.new.new.i.i, !prof !41

.388.endif.preheader.new.new.i.i:                 ; preds = %.388.endif.preheader.new.i.i
  %202 = add nuw nsw i64 %200, 1
  %203 = inttoptr i64 %.85.i.i to ptr
  %scevgep65.i.i = getelementptr i8, ptr %203, i64 120
  %204 = lshr i64 %202, 1
  %205 = mul nsw i64 %204, -2
  br label %.388.endif.i.i

B196.i.i:                                         ; preds = %.388.if.i.i
  %.501.i.i = load i64, ptr %.500.i.i, align 8, !noalias !36
  %.509.i.i = mul nuw nsw i64 %.1136634637.i, 1352
  %.512.i.i = add nsw i64 %.501.i.i, %.509.i.i
  %206 = inttoptr i64 %.512.i.i to ptr
  store double 0x7FF8000000000000, ptr %206, align 8, !noalias !36
  %scevgep152.i.i = getelementptr i8, ptr %206, i64 56
  %scevgep273.i.i = getelementptr i8, ptr %206, i64 8
  store double 0x7FF8000000000000, ptr %scevgep273.i.i, align 8, !noalias !36
  %scevgep254.i.i = getelementptr i8, ptr %206, i64 16
  store double 0x7FF8000000000000, ptr %scevgep254.i.i, align 8, !noalias !36
  %scevgep235.i.i = getelementptr i8, ptr %206, i64 24
  store double 0x7FF8000000000000, ptr %scevgep235.i.i, align 8, !noalias !36
  %scevgep216.i.i = getelementptr i8, ptr %206, i64 32
  store double 0x7FF8000000000000, ptr %scevgep216.i.i, align 8, !noalias !36
  %scevgep197.i.i = getelementptr i8, ptr %206, i64 40
  store double 0x7FF8000000000000, ptr %scevgep197.i.i, align 8, !noalias !36
  %scevgep178.i.i = getelementptr i8, ptr %206, i64 48
  store double 0x7FF8000000000000, ptr %scevgep178.i.i, align 8, !noalias !36
  store double 0x7FF8000000000000, ptr %scevgep152.i.i, align 8, !noalias !36
  %scevgep639.i.i = getelementptr i8, ptr %206, i64 64
  store double 0x7FF8000000000000, ptr %scevgep639.i.i, align 8, !noalias !36
  %scevgep141.i.i = getelementptr i8, ptr %206, i64 128
  %scevgep31.i.i = getelementptr i8, ptr %206, i64 120
  %scevgep61.i.i = getelementptr i8, ptr %206, i64 72
  store double 0x7FF8000000000000, ptr %scevgep61.i.i, align 8, !noalias !36
  %scevgep59.i.i = getelementptr i8, ptr %206, i64 80
  store double 0x7FF8000000000000, ptr %scevgep59.i.i, align 8, !noalias !36
  %scevgep53.i.i = getelementptr i8, ptr %206, i64 88
  store double 0x7FF8000000000000, ptr %scevgep53.i.i, align 8, !noalias !36
  %scevgep49.i.i = getelementptr i8, ptr %206, i64 96
  store double 0x7FF8000000000000, ptr %scevgep49.i.i, align 8, !noalias !36
  %scevgep45.i.i = getelementptr i8, ptr %206, i64 104
  store double 0x7FF8000000000000, ptr %scevgep45.i.i, align 8, !noalias !36
  %scevgep35.i.i = getelementptr i8, ptr %206, i64 112
  store double 0x7FF8000000000000, ptr %scevgep35.i.i, align 8, !noalias !36
  store double 0x7FF8000000000000, ptr %scevgep31.i.i, align 8, !noalias !36
  store double 0x7FF8000000000000, ptr %scevgep141.i.i, align 8, !noalias !36
  %scevgep14.i.i = getelementptr i8, ptr %206, i64 256
  %scevgep15.i.i = getelementptr i8, ptr %206, i64 184
  %scevgep27.i.i = getelementptr i8, ptr %206, i64 136
  store double 0x7FF8000000000000, ptr %scevgep27.i.i, align 8, !noalias !36
  %scevgep25.i.i = getelementptr i8, ptr %206, i64 144
  store double 0x7FF8000000000000, ptr %scevgep25.i.i, align 8, !noalias !36
  %scevgep23.i.i = getelementptr i8, ptr %206, i64 152
  store double 0x7FF8000000000000, ptr %scevgep23.i.i, align 8, !noalias !36
  %scevgep21.i.i = getelementptr i8, ptr %206, i64 160
  store double 0x7FF8000000000000, ptr %scevgep21.i.i, align 8, !noalias !36
  %scevgep19.i.i = getelementptr i8, ptr %206, i64 168
  store double 0x7FF8000000000000, ptr %scevgep19.i.i, align 8, !noalias !36
  %scevgep17.i.i = getelementptr i8, ptr %206, i64 176
  store double 0x7FF8000000000000, ptr %scevgep17.i.i, align 8, !noalias !36
  store double 0x7FF8000000000000, ptr %scevgep15.i.i, align 8, !noalias !36
  %scevgep63.i.i = getelementptr i8, ptr %206, i64 192
  store double 0x7FF8000000000000, ptr %scevgep63.i.i, align 8, !noalias !36
  %scevgep31.1.i.i = getelementptr i8, ptr %206, i64 248
  %scevgep61.1.i.i = getelementptr i8, ptr %206, i64 200
  store double 0x7FF8000000000000, ptr %scevgep61.1.i.i, align 8, !noalias !36
  %scevgep59.1.i.i = getelementptr i8, ptr %206, i64 208
  store double 0x7FF8000000000000, ptr %scevgep59.1.i.i, align 8, !noalias !36
  %scevgep53.1.i.i = getelementptr i8, ptr %206, i64 216
  store double 0x7FF8000000000000, ptr %scevgep53.1.i.i, align 8, !noalias !36
  %scevgep49.1.i.i = getelementptr i8, ptr %206, i64 224
  store double 0x7FF8000000000000, ptr %scevgep49.1.i.i, align 8, !noalias !36
  %scevgep45.1.i.i = getelementptr i8, ptr %206, i64 232
  store double 0x7FF8000000000000, ptr %scevgep45.1.i.i, align 8, !noalias !36
  %scevgep35.1.i.i = getelementptr i8, ptr %206, i64 240
  store double 0x7FF8000000000000, ptr %scevgep35.1.i.i, align 8, !noalias !36
  store double 0x7FF8000000000000, ptr %scevgep31.1.i.i, align 8, !noalias !36
  store double 0x7FF8000000000000, ptr %scevgep14.i.i, align 8, !noalias !36
  %scevgep14.1.i.i = getelementptr i8, ptr %206, i64 384
  %scevgep15.1.i.i = getelementptr i8, ptr %206, i64 312
  %scevgep27.1.i.i = getelementptr i8, ptr %206, i64 264
  store double 0x7FF8000000000000, ptr %scevgep27.1.i.i, align 8, !noalias !36
  %scevgep25.1.i.i = getelementptr i8, ptr %206, i64 272
  store double 0x7FF8000000000000, ptr %scevgep25.1.i.i, align 8, !noalias !36
  %scevgep23.1.i.i = getelementptr i8, ptr %206, i64 280
  store double 0x7FF8000000000000, ptr %scevgep23.1.i.i, align 8, !noalias !36
  %scevgep21.1.i.i = getelementptr i8, ptr %206, i64 288
  store double 0x7FF8000000000000, ptr %scevgep21.1.i.i, align 8, !noalias !36
  %scevgep19.1.i.i = getelementptr i8, ptr %206, i64 296
  store double 0x7FF8000000000000, ptr %scevgep19.1.i.i, align 8, !noalias !36
  %scevgep17.1.i.i = getelementptr i8, ptr %206, i64 304
  store double 0x7FF8000000000000, ptr %scevgep17.1.i.i, align 8, !noalias !36
  store double 0x7FF8000000000000, ptr %scevgep15.1.i.i, align 8, !noalias !36
  %scevgep63.1.i.i = getelementptr i8, ptr %206, i64 320
  store double 0x7FF8000000000000, ptr %scevgep63.1.i.i, align 8, !noalias !36
  %scevgep31.2.i.i = getelementptr i8, ptr %206, i64 376
  %scevgep61.2.i.i = getelementptr i8, ptr %206, i64 328
  store double 0x7FF8000000000000, ptr %scevgep61.2.i.i, align 8, !noalias !36
  %scevgep59.2.i.i = getelementptr i8, ptr %206, i64 336
  store double 0x7FF8000000000000, ptr %scevgep59.2.i.i, align 8, !noalias !36
  %scevgep53.2.i.i = getelementptr i8, ptr %206, i64 344
  store double 0x7FF8000000000000, ptr %scevgep53.2.i.i, align 8, !noalias !36
  %scevgep49.2.i.i = getelementptr i8, ptr %206, i64 352
  store double 0x7FF8000000000000, ptr %scevgep49.2.i.i, align 8, !noalias !36
  %scevgep45.2.i.i = getelementptr i8, ptr %206, i64 360
  store double 0x7FF8000000000000, ptr %scevgep45.2.i.i, align 8, !noalias !36
  %scevgep35.2.i.i = getelementptr i8, ptr %206, i64 368
  store double 0x7FF8000000000000, ptr %scevgep35.2.i.i, align 8, !noalias !36
  store double 0x7FF8000000000000, ptr %scevgep31.2.i.i, align 8, !noalias !36
  store double 0x7FF8000000000000, ptr %scevgep14.1.i.i, align 8, !noalias !36
  %scevgep14.2.i.i = getelementptr i8, ptr %206, i64 512
  %scevgep15.2.i.i = getelementptr i8, ptr %206, i64 440
  %scevgep27.2.i.i = getelementptr i8, ptr %206, i64 392
  store double 0x7FF8000000000000, ptr %scevgep27.2.i.i, align 8, !noalias !36
  %scevgep25.2.i.i = getelementptr i8, ptr %206, i64 400
  store double 0x7FF8000000000000, ptr %scevgep25.2.i.i, align 8, !noalias !36
  %scevgep23.2.i.i = getelementptr i8, ptr %206, i64 408
  store double 0x7FF8000000000000, ptr %scevgep23.2.i.i, align 8, !noalias !36
  %scevgep21.2.i.i = getelementptr i8, ptr %206, i64 416
  store double 0x7FF8000000000000, ptr %scevgep21.2.i.i, align 8, !noalias !36
  %scevgep19.2.i.i = getelementptr i8, ptr %206, i64 424
  store double 0x7FF8000000000000, ptr %scevgep19.2.i.i, align 8, !noalias !36
  %scevgep17.2.i.i = getelementptr i8, ptr %206, i64 432
  store double 0x7FF8000000000000, ptr %scevgep17.2.i.i, align 8, !noalias !36
  store double 0x7FF8000000000000, ptr %scevgep15.2.i.i, align 8, !noalias !36
  %scevgep63.2.i.i = getelementptr i8, ptr %206, i64 448
  store double 0x7FF8000000000000, ptr %scevgep63.2.i.i, align 8, !noalias !36
  %scevgep31.3.i.i = getelementptr i8, ptr %206, i64 504
  %scevgep61.3.i.i = getelementptr i8, ptr %206, i64 456
  store double 0x7FF8000000000000, ptr %scevgep61.3.i.i, align 8, !noalias !36
  %scevgep59.3.i.i = getelementptr i8, ptr %206, i64 464
  store double 0x7FF8000000000000, ptr %scevgep59.3.i.i, align 8, !noalias !36
  %scevgep53.3.i.i = getelementptr i8, ptr %206, i64 472
  store double 0x7FF8000000000000, ptr %scevgep53.3.i.i, align 8, !noalias !36
  %scevgep49.3.i.i = getelementptr i8, ptr %206, i64 480
  store double 0x7FF8000000000000, ptr %scevgep49.3.i.i, align 8, !noalias !36
  %scevgep45.3.i.i = getelementptr i8, ptr %206, i64 488
  store double 0x7FF8000000000000, ptr %scevgep45.3.i.i, align 8, !noalias !36
  %scevgep35.3.i.i = getelementptr i8, ptr %206, i64 496
  store double 0x7FF8000000000000, ptr %scevgep35.3.i.i, align 8, !noalias !36
  store double 0x7FF8000000000000, ptr %scevgep31.3.i.i, align 8, !noalias !36
  store double 0x7FF8000000000000, ptr %scevgep14.2.i.i, align 8, !noalias !36
  %scevgep14.3.i.i = getelementptr i8, ptr %206, i64 640
  %scevgep15.3.i.i = getelementptr i8, ptr %206, i64 568
  %scevgep27.3.i.i = getelementptr i8, ptr %206, i64 520
  store double 0x7FF8000000000000, ptr %scevgep27.3.i.i, align 8, !noalias !36
  %scevgep25.3.i.i = getelementptr i8, ptr %206, i64 528
  store double 0x7FF8000000000000, ptr %scevgep25.3.i.i, align 8, !noalias !36
  %scevgep23.3.i.i = getelementptr i8, ptr %206, i64 536
  store double 0x7FF8000000000000, ptr %scevgep23.3.i.i, align 8, !noalias !36
  %scevgep21.3.i.i = getelementptr i8, ptr %206, i64 544
  store double 0x7FF8000000000000, ptr %scevgep21.3.i.i, align 8, !noalias !36
  %scevgep19.3.i.i = getelementptr i8, ptr %206, i64 552
  store double 0x7FF8000000000000, ptr %scevgep19.3.i.i, align 8, !noalias !36
  %scevgep17.3.i.i = getelementptr i8, ptr %206, i64 560
  store double 0x7FF8000000000000, ptr %scevgep17.3.i.i, align 8, !noalias !36
  store double 0x7FF8000000000000, ptr %scevgep15.3.i.i, align 8, !noalias !36
  %scevgep63.3.i.i = getelementptr i8, ptr %206, i64 576
  store double 0x7FF8000000000000, ptr %scevgep63.3.i.i, align 8, !noalias !36
  %scevgep31.4.i.i = getelementptr i8, ptr %206, i64 632
  %scevgep61.4.i.i = getelementptr i8, ptr %206, i64 584
  store double 0x7FF8000000000000, ptr %scevgep61.4.i.i, align 8, !noalias !36
  %scevgep59.4.i.i = getelementptr i8, ptr %206, i64 592
  store double 0x7FF8000000000000, ptr %scevgep59.4.i.i, align 8, !noalias !36
  %scevgep53.4.i.i = getelementptr i8, ptr %206, i64 600
  store double 0x7FF8000000000000, ptr %scevgep53.4.i.i, align 8, !noalias !36
  %scevgep49.4.i.i = getelementptr i8, ptr %206, i64 608
  store double 0x7FF8000000000000, ptr %scevgep49.4.i.i, align 8, !noalias !36
  %scevgep45.4.i.i = getelementptr i8, ptr %206, i64 616
  store double 0x7FF8000000000000, ptr %scevgep45.4.i.i, align 8, !noalias !36
  %scevgep35.4.i.i = getelementptr i8, ptr %206, i64 624
  store double 0x7FF8000000000000, ptr %scevgep35.4.i.i, align 8, !noalias !36
  store double 0x7FF8000000000000, ptr %scevgep31.4.i.i, align 8, !noalias !36
  store double 0x7FF8000000000000, ptr %scevgep14.3.i.i, align 8, !noalias !36
  %scevgep14.4.i.i = getelementptr i8, ptr %206, i64 768
  %scevgep15.4.i.i = getelementptr i8, ptr %206, i64 696
  %scevgep27.4.i.i = getelementptr i8, ptr %206, i64 648
  store double 0x7FF8000000000000, ptr %scevgep27.4.i.i, align 8, !noalias !36
  %scevgep25.4.i.i = getelementptr i8, ptr %206, i64 656
  store double 0x7FF8000000000000, ptr %scevgep25.4.i.i, align 8, !noalias !36
  %scevgep23.4.i.i = getelementptr i8, ptr %206, i64 664
  store double 0x7FF8000000000000, ptr %scevgep23.4.i.i, align 8, !noalias !36
  %scevgep21.4.i.i = getelementptr i8, ptr %206, i64 672
  store double 0x7FF8000000000000, ptr %scevgep21.4.i.i, align 8, !noalias !36
  %scevgep19.4.i.i = getelementptr i8, ptr %206, i64 680
  store double 0x7FF8000000000000, ptr %scevgep19.4.i.i, align 8, !noalias !36
  %scevgep17.4.i.i = getelementptr i8, ptr %206, i64 688
  store double 0x7FF8000000000000, ptr %scevgep17.4.i.i, align 8, !noalias !36
  store double 0x7FF8000000000000, ptr %scevgep15.4.i.i, align 8, !noalias !36
  %scevgep63.4.i.i = getelementptr i8, ptr %206, i64 704
  store double 0x7FF8000000000000, ptr %scevgep63.4.i.i, align 8, !noalias !36
  %scevgep31.5.i.i = getelementptr i8, ptr %206, i64 760
  %scevgep61.5.i.i = getelementptr i8, ptr %206, i64 712
  store double 0x7FF8000000000000, ptr %scevgep61.5.i.i, align 8, !noalias !36
  %scevgep59.5.i.i = getelementptr i8, ptr %206, i64 720
  store double 0x7FF8000000000000, ptr %scevgep59.5.i.i, align 8, !noalias !36
  %scevgep53.5.i.i = getelementptr i8, ptr %206, i64 728
  store double 0x7FF8000000000000, ptr %scevgep53.5.i.i, align 8, !noalias !36
  %scevgep49.5.i.i = getelementptr i8, ptr %206, i64 736
  store double 0x7FF8000000000000, ptr %scevgep49.5.i.i, align 8, !noalias !36
  %scevgep45.5.i.i = getelementptr i8, ptr %206, i64 744
  store double 0x7FF8000000000000, ptr %scevgep45.5.i.i, align 8, !noalias !36
  %scevgep35.5.i.i = getelementptr i8, ptr %206, i64 752
  store double 0x7FF8000000000000, ptr %scevgep35.5.i.i, align 8, !noalias !36
  store double 0x7FF8000000000000, ptr %scevgep31.5.i.i, align 8, !noalias !36
  store double 0x7FF8000000000000, ptr %scevgep14.4.i.i, align 8, !noalias !36
  %scevgep14.5.i.i = getelementptr i8, ptr %206, i64 896
  %scevgep15.5.i.i = getelementptr i8, ptr %206, i64 824
  %scevgep27.5.i.i = getelementptr i8, ptr %206, i64 776
  store double 0x7FF8000000000000, ptr %scevgep27.5.i.i, align 8, !noalias !36
  %scevgep25.5.i.i = getelementptr i8, ptr %206, i64 784
  store double 0x7FF8000000000000, ptr %scevgep25.5.i.i, align 8, !noalias !36
  %scevgep23.5.i.i = getelementptr i8, ptr %206, i64 792
  store double 0x7FF8000000000000, ptr %scevgep23.5.i.i, align 8, !noalias !36
  %scevgep21.5.i.i = getelementptr i8, ptr %206, i64 800
  store double 0x7FF8000000000000, ptr %scevgep21.5.i.i, align 8, !noalias !36
  %scevgep19.5.i.i = getelementptr i8, ptr %206, i64 808
  store double 0x7FF8000000000000, ptr %scevgep19.5.i.i, align 8, !noalias !36
  %scevgep17.5.i.i = getelementptr i8, ptr %206, i64 816
  store double 0x7FF8000000000000, ptr %scevgep17.5.i.i, align 8, !noalias !36
  store double 0x7FF8000000000000, ptr %scevgep15.5.i.i, align 8, !noalias !36
  %scevgep63.5.i.i = getelementptr i8, ptr %206, i64 832
  store double 0x7FF8000000000000, ptr %scevgep63.5.i.i, align 8, !noalias !36
  %scevgep31.6.i.i = getelementptr i8, ptr %206, i64 888
  %scevgep61.6.i.i = getelementptr i8, ptr %206, i64 840
  store double 0x7FF8000000000000, ptr %scevgep61.6.i.i, align 8, !noalias !36
  %scevgep59.6.i.i = getelementptr i8, ptr %206, i64 848
  store double 0x7FF8000000000000, ptr %scevgep59.6.i.i, align 8, !noalias !36
  %scevgep53.6.i.i = getelementptr i8, ptr %206, i64 856
  store double 0x7FF8000000000000, ptr %scevgep53.6.i.i, align 8, !noalias !36
  %scevgep49.6.i.i = getelementptr i8, ptr %206, i64 864
  store double 0x7FF8000000000000, ptr %scevgep49.6.i.i, align 8, !noalias !36
  %scevgep45.6.i.i = getelementptr i8, ptr %206, i64 872
  store double 0x7FF8000000000000, ptr %scevgep45.6.i.i, align 8, !noalias !36
  %scevgep35.6.i.i = getelementptr i8, ptr %206, i64 880
  store double 0x7FF8000000000000, ptr %scevgep35.6.i.i, align 8, !noalias !36
  store double 0x7FF8000000000000, ptr %scevgep31.6.i.i, align 8, !noalias !36
  store double 0x7FF8000000000000, ptr %scevgep14.5.i.i, align 8, !noalias !36
  %scevgep14.6.i.i = getelementptr i8, ptr %206, i64 1024
  %scevgep15.6.i.i = getelementptr i8, ptr %206, i64 952
  %scevgep27.6.i.i = getelementptr i8, ptr %206, i64 904
  store double 0x7FF8000000000000, ptr %scevgep27.6.i.i, align 8, !noalias !36
  %scevgep25.6.i.i = getelementptr i8, ptr %206, i64 912
  store double 0x7FF8000000000000, ptr %scevgep25.6.i.i, align 8, !noalias !36
  %scevgep23.6.i.i = getelementptr i8, ptr %206, i64 920
  store double 0x7FF8000000000000, ptr %scevgep23.6.i.i, align 8, !noalias !36
  %scevgep21.6.i.i = getelementptr i8, ptr %206, i64 928
  store double 0x7FF8000000000000, ptr %scevgep21.6.i.i, align 8, !noalias !36
  %scevgep19.6.i.i = getelementptr i8, ptr %206, i64 936
  store double 0x7FF8000000000000, ptr %scevgep19.6.i.i, align 8, !noalias !36
  %scevgep17.6.i.i = getelementptr i8, ptr %206, i64 944
  store double 0x7FF8000000000000, ptr %scevgep17.6.i.i, align 8, !noalias !36
  store double 0x7FF8000000000000, ptr %scevgep15.6.i.i, align 8, !noalias !36
  %scevgep63.6.i.i = getelementptr i8, ptr %206, i64 960
  store double 0x7FF8000000000000, ptr %scevgep63.6.i.i, align 8, !noalias !36
  %scevgep31.7.i.i = getelementptr i8, ptr %206, i64 1016
  %scevgep61.7.i.i = getelementptr i8, ptr %206, i64 968
  store double 0x7FF8000000000000, ptr %scevgep61.7.i.i, align 8, !noalias !36
  %scevgep59.7.i.i = getelementptr i8, ptr %206, i64 976
  store double 0x7FF8000000000000, ptr %scevgep59.7.i.i, align 8, !noalias !36
  %scevgep53.7.i.i = getelementptr i8, ptr %206, i64 984
  store double 0x7FF8000000000000, ptr %scevgep53.7.i.i, align 8, !noalias !36
  %scevgep49.7.i.i = getelementptr i8, ptr %206, i64 992
  store double 0x7FF8000000000000, ptr %scevgep49.7.i.i, align 8, !noalias !36
  %scevgep45.7.i.i = getelementptr i8, ptr %206, i64 1000
  store double 0x7FF8000000000000, ptr %scevgep45.7.i.i, align 8, !noalias !36
  %scevgep35.7.i.i = getelementptr i8, ptr %206, i64 1008
  store double 0x7FF8000000000000, ptr %scevgep35.7.i.i, align 8, !noalias !36
  store double 0x7FF8000000000000, ptr %scevgep31.7.i.i, align 8, !noalias !36
  store double 0x7FF8000000000000, ptr %scevgep14.6.i.i, align 8, !noalias !36
  %scevgep14.7.i.i = getelementptr i8, ptr %206, i64 1152
  %scevgep15.7.i.i = getelementptr i8, ptr %206, i64 1080
  %scevgep27.7.i.i = getelementptr i8, ptr %206, i64 1032
  store double 0x7FF8000000000000, ptr %scevgep27.7.i.i, align 8, !noalias !36
  %scevgep25.7.i.i = getelementptr i8, ptr %206, i64 1040
  store double 0x7FF8000000000000, ptr %scevgep25.7.i.i, align 8, !noalias !36
  %scevgep23.7.i.i = getelementptr i8, ptr %206, i64 1048
  store double 0x7FF8000000000000, ptr %scevgep23.7.i.i, align 8, !noalias !36
  %scevgep21.7.i.i = getelementptr i8, ptr %206, i64 1056
  store double 0x7FF8000000000000, ptr %scevgep21.7.i.i, align 8, !noalias !36
  %scevgep19.7.i.i = getelementptr i8, ptr %206, i64 1064
  store double 0x7FF8000000000000, ptr %scevgep19.7.i.i, align 8, !noalias !36
  %scevgep17.7.i.i = getelementptr i8, ptr %206, i64 1072
  store double 0x7FF8000000000000, ptr %scevgep17.7.i.i, align 8, !noalias !36
  store double 0x7FF8000000000000, ptr %scevgep15.7.i.i, align 8, !noalias !36
  %scevgep63.7.i.i = getelementptr i8, ptr %206, i64 1088
  store double 0x7FF8000000000000, ptr %scevgep63.7.i.i, align 8, !noalias !36
  %scevgep31.8.i.i = getelementptr i8, ptr %206, i64 1144
  %scevgep61.8.i.i = getelementptr i8, ptr %206, i64 1096
  store double 0x7FF8000000000000, ptr %scevgep61.8.i.i, align 8, !noalias !36
  %scevgep59.8.i.i = getelementptr i8, ptr %206, i64 1104
  store double 0x7FF8000000000000, ptr %scevgep59.8.i.i, align 8, !noalias !36
  %scevgep53.8.i.i = getelementptr i8, ptr %206, i64 1112
  store double 0x7FF8000000000000, ptr %scevgep53.8.i.i, align 8, !noalias !36
  %scevgep49.8.i.i = getelementptr i8, ptr %206, i64 1120
  store double 0x7FF8000000000000, ptr %scevgep49.8.i.i, align 8, !noalias !36
  %scevgep45.8.i.i = getelementptr i8, ptr %206, i64 1128
  store double 0x7FF8000000000000, ptr %scevgep45.8.i.i, align 8, !noalias !36
  %scevgep35.8.i.i = getelementptr i8, ptr %206, i64 1136
  store double 0x7FF8000000000000, ptr %scevgep35.8.i.i, align 8, !noalias !36
  store double 0x7FF8000000000000, ptr %scevgep31.8.i.i, align 8, !noalias !36
  store double 0x7FF8000000000000, ptr %scevgep14.7.i.i, align 8, !noalias !36
  %scevgep14.8.i.i = getelementptr i8, ptr %206, i64 1280
  %scevgep15.8.i.i = getelementptr i8, ptr %206, i64 1208
  %scevgep27.8.i.i = getelementptr i8, ptr %206, i64 1160
  store double 0x7FF8000000000000, ptr %scevgep27.8.i.i, align 8, !noalias !36
  %scevgep25.8.i.i = getelementptr i8, ptr %206, i64 1168
  store double 0x7FF8000000000000, ptr %scevgep25.8.i.i, align 8, !noalias !36
  %scevgep23.8.i.i = getelementptr i8, ptr %206, i64 1176
  store double 0x7FF8000000000000, ptr %scevgep23.8.i.i, align 8, !noalias !36
  %scevgep21.8.i.i = getelementptr i8, ptr %206, i64 1184
  store double 0x7FF8000000000000, ptr %scevgep21.8.i.i, align 8, !noalias !36
  %scevgep19.8.i.i = getelementptr i8, ptr %206, i64 1192
  store double 0x7FF8000000000000, ptr %scevgep19.8.i.i, align 8, !noalias !36
  %scevgep17.8.i.i = getelementptr i8, ptr %206, i64 1200
  store double 0x7FF8000000000000, ptr %scevgep17.8.i.i, align 8, !noalias !36
  store double 0x7FF8000000000000, ptr %scevgep15.8.i.i, align 8, !noalias !36
  %scevgep63.8.i.i = getelementptr i8, ptr %206, i64 1216
  store double 0x7FF8000000000000, ptr %scevgep63.8.i.i, align 8, !noalias !36
  %scevgep31.9.i.i = getelementptr i8, ptr %206, i64 1272
  %scevgep61.9.i.i = getelementptr i8, ptr %206, i64 1224
  store double 0x7FF8000000000000, ptr %scevgep61.9.i.i, align 8, !noalias !36
  %scevgep59.9.i.i = getelementptr i8, ptr %206, i64 1232
  store double 0x7FF8000000000000, ptr %scevgep59.9.i.i, align 8, !noalias !36
  %scevgep53.9.i.i = getelementptr i8, ptr %206, i64 1240
  store double 0x7FF8000000000000, ptr %scevgep53.9.i.i, align 8, !noalias !36
  %scevgep49.9.i.i = getelementptr i8, ptr %206, i64 1248
  store double 0x7FF8000000000000, ptr %scevgep49.9.i.i, align 8, !noalias !36
  %scevgep45.9.i.i = getelementptr i8, ptr %206, i64 1256
  store double 0x7FF8000000000000, ptr %scevgep45.9.i.i, align 8, !noalias !36
  %scevgep35.9.i.i = getelementptr i8, ptr %206, i64 1264
  store double 0x7FF8000000000000, ptr %scevgep35.9.i.i, align 8, !noalias !36
  store double 0x7FF8000000000000, ptr %scevgep31.9.i.i, align 8, !noalias !36
  store double 0x7FF8000000000000, ptr %scevgep14.8.i.i, align 8, !noalias !36
  %scevgep15.9.i.i = getelementptr i8, ptr %206, i64 1336
  %scevgep27.9.i.i = getelementptr i8, ptr %206, i64 1288
  store double 0x7FF8000000000000, ptr %scevgep27.9.i.i, align 8, !noalias !36
  %scevgep25.9.i.i = getelementptr i8, ptr %206, i64 1296
  store double 0x7FF8000000000000, ptr %scevgep25.9.i.i, align 8, !noalias !36
  %scevgep23.9.i.i = getelementptr i8, ptr %206, i64 1304
  store double 0x7FF8000000000000, ptr %scevgep23.9.i.i, align 8, !noalias !36
  %scevgep21.9.i.i = getelementptr i8, ptr %206, i64 1312
  store double 0x7FF8000000000000, ptr %scevgep21.9.i.i, align 8, !noalias !36
  %scevgep19.9.i.i = getelementptr i8, ptr %206, i64 1320
  store double 0x7FF8000000000000, ptr %scevgep19.9.i.i, align 8, !noalias !36
  %scevgep17.9.i.i = getelementptr i8, ptr %206, i64 1328
  store double 0x7FF8000000000000, ptr %scevgep17.9.i.i, align 8, !noalias !36
  store double 0x7FF8000000000000, ptr %scevgep15.9.i.i, align 8, !noalias !36
  %scevgep63.9.i.i = getelementptr i8, ptr %206, i64 1344
  store double 0x7FF8000000000000, ptr %scevgep63.9.i.i, align 8, !noalias !36
  br label %B290.i

.388.if.loopexit.unr-lcssa.unr-lcssa.i.i:         ; preds = %.388.endif.i.i
  %207 = and i64 %199, 8
  %lcmp.mod.not12.not.i.i = icmp eq i64 %207, 0
  br i1 %lcmp.mod.not12.not.i.i, label %.388.endif.epil.preheader4.i.i, label %.388.if.loopexit.unr-lcssa.i.i, !prof !42

.388.endif.epil.preheader4.i.i:                   ; preds = %.388.if.loopexit.unr-lcssa.unr-lcssa.i.i, %.388.endif.preheader.new.i.i
  %.384.0267.epil.init8.i.i = phi i64 [ 0, %.388.endif.preheader.new.i.i ], [ %.429.7.1.i.i, %.388.if.loopexit.unr-lcssa.unr-lcssa.i.i ]
  %sunkaddr.i2.i = inttoptr i64 %.85.i.i to ptr
  %sunkaddr97.i.i = shl i64 %.384.0267.epil.init8.i.i, 3
  %sunkaddr98.i.i = getelementptr i8, ptr %sunkaddr.i2.i, i64 %sunkaddr97.i.i
  store double 0x7FF8000000000000, ptr %sunkaddr98.i.i, align 8, !noalias !36
  %sunkaddr102.i.i = getelementptr i8, ptr %sunkaddr98.i.i, i64 8
  store double 0x7FF8000000000000, ptr %sunkaddr102.i.i, align 8, !noalias !36
  %sunkaddr106.i.i = getelementptr i8, ptr %sunkaddr98.i.i, i64 16
  store double 0x7FF8000000000000, ptr %sunkaddr106.i.i, align 8, !noalias !36
  %sunkaddr110.i.i = getelementptr i8, ptr %sunkaddr98.i.i, i64 24
  store double 0x7FF8000000000000, ptr %sunkaddr110.i.i, align 8, !noalias !36
  %sunkaddr114.i.i = getelementptr i8, ptr %sunkaddr98.i.i, i64 32
  store double 0x7FF8000000000000, ptr %sunkaddr114.i.i, align 8, !noalias !36
  %sunkaddr118.i.i = getelementptr i8, ptr %sunkaddr98.i.i, i64 40
  store double 0x7FF8000000000000, ptr %sunkaddr118.i.i, align 8, !noalias !36
  %sunkaddr122.i.i = getelementptr i8, ptr %sunkaddr98.i.i, i64 48
  store double 0x7FF8000000000000, ptr %sunkaddr122.i.i, align 8, !noalias !36
  %sunkaddr126.i.i = getelementptr i8, ptr %sunkaddr98.i.i, i64 56
  store double 0x7FF8000000000000, ptr %sunkaddr126.i.i, align 8, !noalias !36
  %.429.7.epil.i.i = add nuw nsw i64 %.384.0267.epil.init8.i.i, 8
  br label %.388.if.loopexit.unr-lcssa.i.i

.388.if.loopexit.unr-lcssa.i.i:                   ; preds = %.388.endif.epil.preheader4.i.i, %.388.if.loopexit.unr-lcssa.unr-lcssa.i.i
  %.429.7.lcssa.i.i = phi i64 [ %.429.7.epil.i.i, %.388.endif.epil.preheader4.i.i ], [ %.429.7.1.i.i, %.388.if.loopexit.unr-lcssa.unr-lcssa.i.i ]
  %lcmp.mod.not.i.i = icmp eq i64 %xtraiter.i.i, 0
  br i1 %lcmp.mod.not.i.i, label %.388.if.i.i, label %.388.endif.epil.preheader.i.i, !prof !43

.388.endif.epil.preheader.i.i:                    ; preds = %.388.if.loopexit.unr-lcssa.i.i, %.388.endif.preheader.i.i
  %.384.0267.epil.init.i.i = phi i64 [ 0, %.388.endif.preheader.i.i ], [ %.429.7.lcssa.i.i, %.388.if.loopexit.unr-lcssa.i.i ]
  %208 = inttoptr i64 %.85.i.i to ptr
  %209 = shl i64 %.384.0267.epil.init.i.i, 3
  %scevgep41.i.i = getelementptr i8, ptr %208, i64 %209
  br label %.388.endif.epil.i.i

.388.endif.epil.i.i:                              ; preds = %.388.endif.epil.i.i, %.388.endif.epil.preheader.i.i
  %epil.iter.i.i = phi i64 [ %epil.iter.next.i.i, %.388.endif.epil.i.i ], [ 0, %.388.endif.epil.preheader.i.i ]
  %210 = shl i64 %epil.iter.i.i, 3
  %scevgep64.i.i = getelementptr i8, ptr %scevgep41.i.i, i64 %210
  store double 0x7FF8000000000000, ptr %scevgep64.i.i, align 8, !noalias !36
  %epil.iter.next.i.i = add i64 %epil.iter.i.i, 1
  %epil.iter.cmp.not.i.i = icmp eq i64 %xtraiter.i.i, %epil.iter.next.i.i
  br i1 %epil.iter.cmp.not.i.i, label %.388.if.i.i, label %.388.endif.epil.i.i, !prof !44, !llvm.loop !45

.388.if.i.i:                                      ; preds = %.388.endif.epil.i.i, %.388.if.loopexit.unr-lcssa.i.i, %B256.i
  %.467.i.i = load i64, ptr %.466.i.i, align 8, !noalias !36
  %.468.not.i.i = icmp eq i64 %.467.i.i, 0
  br i1 %.468.not.i.i, label %B290.i, label %B196.i.i

.388.endif.i.i:                                   ; preds = %.388.endif.i.i, %.388.endif.preheader.new.new.i.i
  %lsr.iv.i1.i = phi i64 [ %lsr.iv.next12.i.i, %.388.endif.i.i ], [ %205, %.388.endif.preheader.new.new.i.i ]
  %.384.0267.i.i = phi i64 [ %.429.7.1.i.i, %.388.endif.i.i ], [ 0, %.388.endif.preheader.new.new.i.i ]
  %211 = shl i64 %.384.0267.i.i, 3
  %scevgep81.i.i = getelementptr i8, ptr %scevgep65.i.i, i64 %211
  %scevgep82.i.i = getelementptr i8, ptr %scevgep81.i.i, i64 -64
  %scevgep95.i.i = getelementptr i8, ptr %scevgep81.i.i, i64 -120
  store double 0x7FF8000000000000, ptr %scevgep95.i.i, align 8, !noalias !36
  %scevgep94.i.i = getelementptr i8, ptr %scevgep81.i.i, i64 -112
  store double 0x7FF8000000000000, ptr %scevgep94.i.i, align 8, !noalias !36
  %scevgep47.i.i = getelementptr i8, ptr %scevgep81.i.i, i64 -104
  store double 0x7FF8000000000000, ptr %scevgep47.i.i, align 8, !noalias !36
  %scevgep44.i.i = getelementptr i8, ptr %scevgep81.i.i, i64 -96
  store double 0x7FF8000000000000, ptr %scevgep44.i.i, align 8, !noalias !36
  %scevgep42.i.i = getelementptr i8, ptr %scevgep81.i.i, i64 -88
  store double 0x7FF8000000000000, ptr %scevgep42.i.i, align 8, !noalias !36
  %scevgep39.i.i = getelementptr i8, ptr %scevgep81.i.i, i64 -80
  store double 0x7FF8000000000000, ptr %scevgep39.i.i, align 8, !noalias !36
  %scevgep37.i.i = getelementptr i8, ptr %scevgep81.i.i, i64 -72
  store double 0x7FF8000000000000, ptr %scevgep37.i.i, align 8, !noalias !36
  store double 0x7FF8000000000000, ptr %scevgep82.i.i, align 8, !noalias !36
  %scevgep34.i.i = getelementptr i8, ptr %scevgep81.i.i, i64 -56
  store double 0x7FF8000000000000, ptr %scevgep34.i.i, align 8, !noalias !36
  %scevgep32.i.i = getelementptr i8, ptr %scevgep81.i.i, i64 -48
  store double 0x7FF8000000000000, ptr %scevgep32.i.i, align 8, !noalias !36
  %scevgep29.i.i = getelementptr i8, ptr %scevgep81.i.i, i64 -40
  store double 0x7FF8000000000000, ptr %scevgep29.i.i, align 8, !noalias !36
  %scevgep26.i.i = getelementptr i8, ptr %scevgep81.i.i, i64 -32
  store double 0x7FF8000000000000, ptr %scevgep26.i.i, align 8, !noalias !36
  %scevgep22.i.i = getelementptr i8, ptr %scevgep81.i.i, i64 -24
  store double 0x7FF8000000000000, ptr %scevgep22.i.i, align 8, !noalias !36
  %scevgep18.i.i = getelementptr i8, ptr %scevgep81.i.i, i64 -16
  store double 0x7FF8000000000000, ptr %scevgep18.i.i, align 8, !noalias !36
  %scevgep13.i.i = getelementptr i8, ptr %scevgep81.i.i, i64 -8
  store double 0x7FF8000000000000, ptr %scevgep13.i.i, align 8, !noalias !36
  store double 0x7FF8000000000000, ptr %scevgep81.i.i, align 8, !noalias !36
  %.429.7.1.i.i = add i64 %.384.0267.i.i, 16
  %lsr.iv.next12.i.i = add i64 %lsr.iv.i1.i, 2
  %niter.ncmp.1.i.i = icmp eq i64 %lsr.iv.next12.i.i, 0
  br i1 %niter.ncmp.1.i.i, label %.388.if.loopexit.unr-lcssa.unr-lcssa.i.i, label %.388.endif.i.i, !prof !47, !llvm.loop !48

B290.i:                                           ; preds = %.388.if.i.i, %B196.i.i, %_ZN17bnserve_inference13fisher_kernel7_source4_rowB3v17B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIxLi1E1C7mutable7alignedE52_Room_28array_28float64_2c_201d_2c_20C_29_20x_208_29.exit.i
  %exitcond.not.i = icmp eq i64 %.1050.i, %.1143.i
  br i1 %exitcond.not.i, label %_ZN17bnserve_inference13fisher_kernel7_source9factoriseB2v3B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIxLi1E1C7mutable7alignedE.exit, label %B192.if.i

B192.if.i:                                        ; preds = %B290.i, %B192.if.preheader.i
  %.1136634637.i = phi i64 [ %.1143.i, %B290.i ], [ 0, %B192.if.preheader.i ]
  %.1143.i = add nuw nsw i64 %.1136634637.i, 1
  %212 = getelementptr i8, ptr %0, i64 %.1136634637.i
  %.1201.i = load i8, ptr %212, align 1, !noalias !0
  %.1203.i = icmp eq i8 %.1201.i, 0
  br i1 %.1203.i, label %B220.i, label %B256.i

_ZN17bnserve_inference13fisher_kernel7_source9factoriseB2v3B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIxLi1E1C7mutable7alignedE.exit: ; preds = %B290.i, %entry
  store i64 0, ptr %retptr, align 8
  ret i32 0
}

; Function Attrs: mustprogress nocallback nofree nounwind willreturn memory(argmem: write)
declare void @llvm.memset.p0.i64(ptr writeonly captures(none), i8, i64, i1 immarg) #1

; Function Attrs: nofree norecurse nosync nounwind memory(argmem: readwrite)
define internal fastcc void @inner_0(ptr noalias nonnull writeonly captures(none) %retptr, ptr captures(none) %arg.block.4, i64 %arg.capacity, i64 %arg.vectors, ptr captures(none) %arg.root.4, ptr captures(none) %arg.room.4) unnamed_addr #2 {
entry:
  %.51 = shl nsw i64 %arg.vectors, 3
  %.52 = shl nsw i64 %arg.capacity, 3
  %.262 = add nsw i64 %.51, -8
  %.301 = icmp slt i64 %arg.vectors, 2
  %0 = and i64 %.262, -9223372036854775800
  %.319 = icmp sgt i64 %0, 0
  %.320 = sdiv i64 %.262, 16
  %.321 = zext i1 %.319 to i64
  %.322 = add nsw i64 %.320, %.321
  %.arg.vectors2340 = tail call i64 @llvm.smax.i64(i64 %arg.vectors, i64 0)
  %spec.select = select i1 %.301, i64 0, i64 %.322
  %scevgep = getelementptr i8, ptr %arg.block.4, i64 64
  %1 = shl i64 %arg.capacity, 6
  %2 = add nuw i64 %.arg.vectors2340, 1
  %sunkaddr = shl i64 %arg.vectors, 6
  %invariant.gep = getelementptr i8, ptr %arg.block.4, i64 %sunkaddr
  %3 = add nsw i64 %spec.select, 4
  %4 = icmp sgt i64 %spec.select, 0
  %5 = and i64 %arg.vectors, 1
  %6 = icmp eq i64 %5, 0
  %sunkaddr3 = getelementptr i8, ptr %arg.room.4, i64 8
  %sunkaddr4 = getelementptr i8, ptr %arg.room.4, i64 16
  %sunkaddr5 = getelementptr i8, ptr %arg.room.4, i64 24
  %sunkaddr6 = getelementptr i8, ptr %arg.room.4, i64 32
  %sunkaddr7 = getelementptr i8, ptr %arg.room.4, i64 40
  %sunkaddr8 = getelementptr i8, ptr %arg.room.4, i64 48
  %sunkaddr9 = getelementptr i8, ptr %arg.room.4, i64 56
  %7 = icmp sgt i64 %arg.vectors, 0
  %8 = icmp slt i64 %arg.vectors, 1
  %9 = icmp sgt i64 %arg.vectors, 0
  %10 = icmp slt i64 %arg.vectors, 1
  br label %B84.if

B402:                                             ; preds = %B384.else
  %gep = getelementptr double, ptr %invariant.gep, i64 %.184
  %sunkaddr137 = getelementptr i8, ptr %gep, i64 -64
  %.473 = load <8 x double>, ptr %sunkaddr137, align 8
  %.475 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.473, <8 x double> %.473, <8 x double> %even.3.1.lcssa)
  br label %B484

B484:                                             ; preds = %B384.else, %B402
  %even.4.1 = phi <8 x double> [ %.475, %B402 ], [ %even.3.1.lcssa, %B384.else ]
  %.6.i = fadd contract <8 x double> %odd.2.1.lcssa, %even.4.1
  store <8 x double> %.6.i, ptr %arg.room.4, align 8
  %.555 = load double, ptr %arg.room.4, align 8
  %.584 = load double, ptr %sunkaddr3, align 8
  %.585 = fadd contract double %.555, %.584
  %.614 = load double, ptr %sunkaddr4, align 8
  %.643 = load double, ptr %sunkaddr5, align 8
  %.644 = fadd contract double %.614, %.643
  %.645 = fadd contract double %.585, %.644
  %.674 = load double, ptr %sunkaddr6, align 8
  %.703 = load double, ptr %sunkaddr7, align 8
  %.704 = fadd contract double %.674, %.703
  %.733 = load double, ptr %sunkaddr8, align 8
  %.762 = load double, ptr %sunkaddr9, align 8
  %.766 = fadd contract double %.733, %.762
  %.767 = fadd contract double %.704, %.766
  %.768 = fadd contract double %.645, %.767
  %.773 = fcmp contract olt double %.768, 0x5CD0B15A491EB84
  br i1 %.773, label %B7471, label %B546

B546:                                             ; preds = %B484
  %.idx = mul nuw nsw i64 %.82.0, 112
  %11 = getelementptr i8, ptr %arg.root.4, i64 %.idx
  %.808 = load double, ptr %11, align 8
  %.809 = fmul contract double %.808, %.808
  %.811 = fadd contract double %.768, %.809
  %.819 = tail call contract double @sqrt(double %.811)
  %.825 = fneg contract double %.768
  %.828 = fadd contract double %.808, %.819
  %.832 = fdiv contract double %.825, %.828
  %.837 = fmul contract double %.819, %.832
  %.841 = fdiv contract double -1.000000e+00, %.837
  store double %.819, ptr %11, align 8
  %.884 = icmp samesign ult i64 %.82.0, 12
  br i1 %.884, label %B734.preheader, label %B7471

B734:                                             ; preds = %B734.preheader, %B7469
  %column.3.1 = phi i64 [ %column.4.2, %B7469 ], [ %.153, %B734.preheader ]
  %.1034 = add nsw i64 %column.3.1, 4
  %.1035 = icmp slt i64 %column.3.1, 10
  br i1 %.1035, label %B858, label %B6305

B858:                                             ; preds = %B734
  %.1039 = add nsw i64 %column.3.1, 1
  %.1106 = add nsw i64 %column.3.1, 2
  %.1173 = add nsw i64 %column.3.1, 3
  br i1 %9, label %B1092.if.preheader, label %B1166

B1092.if.preheader:                               ; preds = %B858
  %12 = mul i64 %.1173, %1
  %13 = mul i64 %.1106, %1
  %14 = mul i64 %.1039, %1
  %15 = mul i64 %column.3.1, %1
  br label %B1092.if

B1166:                                            ; preds = %B1092.if, %B858
  %_reflect_four_v222_s0.2.2.lcssa = phi <8 x double> [ zeroinitializer, %B858 ], [ %.1580, %B1092.if ]
  %_reflect_four_v222_s1.2.2.lcssa = phi <8 x double> [ zeroinitializer, %B858 ], [ %.1599, %B1092.if ]
  %_reflect_four_v222_s2.2.2.lcssa = phi <8 x double> [ zeroinitializer, %B858 ], [ %.1622, %B1092.if ]
  %_reflect_four_v222_s3.2.2.lcssa = phi <8 x double> [ zeroinitializer, %B858 ], [ %.1641, %B1092.if ]
  %sunkaddr145 = shl i64 %column.3.1, 3
  %sunkaddr146 = getelementptr inbounds i8, ptr %22, i64 %sunkaddr145
  %.1680 = load double, ptr %sunkaddr146, align 8
  %.1682 = fmul contract double %.832, %.1680
  store <8 x double> %_reflect_four_v222_s0.2.2.lcssa, ptr %arg.room.4, align 8
  %.1728 = load double, ptr %arg.room.4, align 8
  %.1757 = load double, ptr %sunkaddr3, align 8
  %.1758 = fadd contract double %.1728, %.1757
  %.1787 = load double, ptr %sunkaddr4, align 8
  %.1816 = load double, ptr %sunkaddr5, align 8
  %.1817 = fadd contract double %.1787, %.1816
  %.1818 = fadd contract double %.1758, %.1817
  %.1847 = load double, ptr %sunkaddr6, align 8
  %.1876 = load double, ptr %sunkaddr7, align 8
  %.1877 = fadd contract double %.1847, %.1876
  %.1906 = load double, ptr %sunkaddr8, align 8
  %.1935 = load double, ptr %sunkaddr9, align 8
  %.1939 = fadd contract double %.1906, %.1935
  %.1940 = fadd contract double %.1877, %.1939
  %.1941 = fadd contract double %.1818, %.1940
  %.1942 = fadd contract double %.1682, %.1941
  %.1944 = fmul contract double %.841, %.1942
  %sunkaddr156 = getelementptr i8, ptr %sunkaddr146, i64 8
  %.1974 = load double, ptr %sunkaddr156, align 8
  %.1976 = fmul contract double %.832, %.1974
  store <8 x double> %_reflect_four_v222_s1.2.2.lcssa, ptr %arg.room.4, align 8
  %.2022 = load double, ptr %arg.room.4, align 8
  %.2051 = load double, ptr %sunkaddr3, align 8
  %.2052 = fadd contract double %.2022, %.2051
  %.2081 = load double, ptr %sunkaddr4, align 8
  %.2110 = load double, ptr %sunkaddr5, align 8
  %.2111 = fadd contract double %.2081, %.2110
  %.2112 = fadd contract double %.2052, %.2111
  %.2141 = load double, ptr %sunkaddr6, align 8
  %.2170 = load double, ptr %sunkaddr7, align 8
  %.2171 = fadd contract double %.2141, %.2170
  %.2200 = load double, ptr %sunkaddr8, align 8
  %.2229 = load double, ptr %sunkaddr9, align 8
  %.2233 = fadd contract double %.2200, %.2229
  %.2234 = fadd contract double %.2171, %.2233
  %.2235 = fadd contract double %.2112, %.2234
  %.2236 = fadd contract double %.1976, %.2235
  %.2238 = fmul contract double %.841, %.2236
  %sunkaddr159 = getelementptr i8, ptr %sunkaddr146, i64 16
  %.2274 = load double, ptr %sunkaddr159, align 8
  %.2276 = fmul contract double %.832, %.2274
  store <8 x double> %_reflect_four_v222_s2.2.2.lcssa, ptr %arg.room.4, align 8
  %.2322 = load double, ptr %arg.room.4, align 8
  %.2351 = load double, ptr %sunkaddr3, align 8
  %.2352 = fadd contract double %.2322, %.2351
  %.2381 = load double, ptr %sunkaddr4, align 8
  %.2410 = load double, ptr %sunkaddr5, align 8
  %.2411 = fadd contract double %.2381, %.2410
  %.2412 = fadd contract double %.2352, %.2411
  %.2441 = load double, ptr %sunkaddr6, align 8
  %.2470 = load double, ptr %sunkaddr7, align 8
  %.2471 = fadd contract double %.2441, %.2470
  %.2500 = load double, ptr %sunkaddr8, align 8
  %.2529 = load double, ptr %sunkaddr9, align 8
  %.2533 = fadd contract double %.2500, %.2529
  %.2534 = fadd contract double %.2471, %.2533
  %.2535 = fadd contract double %.2412, %.2534
  %.2536 = fadd contract double %.2276, %.2535
  %.2538 = fmul contract double %.841, %.2536
  %sunkaddr162 = getelementptr i8, ptr %sunkaddr146, i64 24
  %.2568 = load double, ptr %sunkaddr162, align 8
  %.2570 = fmul contract double %.832, %.2568
  store <8 x double> %_reflect_four_v222_s3.2.2.lcssa, ptr %arg.room.4, align 8
  %.2621 = load double, ptr %arg.room.4, align 8
  %.2650 = load double, ptr %sunkaddr3, align 8
  %.2651 = fadd contract double %.2621, %.2650
  %.2680 = load double, ptr %sunkaddr4, align 8
  %.2709 = load double, ptr %sunkaddr5, align 8
  %.2710 = fadd contract double %.2680, %.2709
  %.2711 = fadd contract double %.2651, %.2710
  %.2740 = load double, ptr %sunkaddr6, align 8
  %.2769 = load double, ptr %sunkaddr7, align 8
  %.2770 = fadd contract double %.2740, %.2769
  %.2799 = load double, ptr %sunkaddr8, align 8
  %.2828 = load double, ptr %sunkaddr9, align 8
  %.2832 = fadd contract double %.2799, %.2828
  %.2833 = fadd contract double %.2770, %.2832
  %.2834 = fadd contract double %.2711, %.2833
  %.2835 = fadd contract double %.2570, %.2834
  %.2837 = fmul contract double %.841, %.2835
  %.2875 = load double, ptr %sunkaddr146, align 8
  %.2878 = fmul contract double %.832, %.1944
  %.2879 = fsub contract double %.2875, %.2878
  store double %.2879, ptr %sunkaddr146, align 8
  %.2939 = load double, ptr %sunkaddr156, align 8
  %.2942 = fmul contract double %.832, %.2238
  %.2943 = fsub contract double %.2939, %.2942
  store double %.2943, ptr %sunkaddr156, align 8
  %.3003 = load double, ptr %sunkaddr159, align 8
  %.3006 = fmul contract double %.832, %.2538
  %.3007 = fsub contract double %.3003, %.3006
  store double %.3007, ptr %sunkaddr159, align 8
  %.3067 = load double, ptr %sunkaddr162, align 8
  %.3070 = fmul contract double %.832, %.2837
  %.3073 = fsub contract double %.3067, %.3070
  store double %.3073, ptr %sunkaddr162, align 8
  br i1 %10, label %B7469, label %B1170.if.lr.ph

B1170.if.lr.ph:                                   ; preds = %B1166
  %.3245 = fneg contract double %.1944
  %.3263 = insertelement <8 x double> poison, double %.3245, i64 0
  %.3264 = shufflevector <8 x double> %.3263, <8 x double> poison, <8 x i32> zeroinitializer
  %.3284 = fneg contract double %.2238
  %.3302 = insertelement <8 x double> poison, double %.3284, i64 0
  %.3303 = shufflevector <8 x double> %.3302, <8 x double> poison, <8 x i32> zeroinitializer
  %.3323 = fneg contract double %.2538
  %.3341 = insertelement <8 x double> poison, double %.3323, i64 0
  %.3342 = shufflevector <8 x double> %.3341, <8 x double> poison, <8 x i32> zeroinitializer
  %.3362 = fneg contract double %.2837
  %.3380 = insertelement <8 x double> poison, double %.3362, i64 0
  %.3381 = shufflevector <8 x double> %.3380, <8 x double> poison, <8 x i32> zeroinitializer
  %16 = mul i64 %.1173, %1
  %17 = mul i64 %.1106, %1
  %18 = mul i64 %.1039, %1
  %19 = mul i64 %column.3.1, %1
  br label %B1170.if

B6305:                                            ; preds = %B734
  br i1 %7, label %B6449.if.preheader, label %B6577

B6449.if.preheader:                               ; preds = %B6305
  %20 = mul i64 %column.3.1, %1
  br label %B6449.if

B6577:                                            ; preds = %B6449.if, %B6305
  %_reflect_v217_total.2.3.lcssa = phi <8 x double> [ zeroinitializer, %B6305 ], [ %.3646, %B6449.if ]
  %sunkaddr163 = shl i64 %column.3.1, 3
  %sunkaddr164 = getelementptr i8, ptr %22, i64 %sunkaddr163
  %.3683 = load double, ptr %sunkaddr164, align 8
  %.3685 = fmul contract double %.832, %.3683
  store <8 x double> %_reflect_v217_total.2.3.lcssa, ptr %arg.room.4, align 8
  %.3736 = load double, ptr %arg.room.4, align 8
  %.3765 = load double, ptr %sunkaddr3, align 8
  %.3766 = fadd contract double %.3736, %.3765
  %.3795 = load double, ptr %sunkaddr4, align 8
  %.3824 = load double, ptr %sunkaddr5, align 8
  %.3825 = fadd contract double %.3795, %.3824
  %.3826 = fadd contract double %.3766, %.3825
  %.3855 = load double, ptr %sunkaddr6, align 8
  %.3884 = load double, ptr %sunkaddr7, align 8
  %.3885 = fadd contract double %.3855, %.3884
  %.3914 = load double, ptr %sunkaddr8, align 8
  %.3943 = load double, ptr %sunkaddr9, align 8
  %.3947 = fadd contract double %.3914, %.3943
  %.3948 = fadd contract double %.3885, %.3947
  %.3949 = fadd contract double %.3826, %.3948
  %.3950 = fadd contract double %.3685, %.3949
  %.3952 = fmul contract double %.841, %.3950
  %.3987 = load double, ptr %sunkaddr164, align 8
  %.3990 = fmul contract double %.832, %.3952
  %.3993 = fsub contract double %.3987, %.3990
  store double %.3993, ptr %sunkaddr164, align 8
  br i1 %8, label %B7025, label %B6691.if.lr.ph

B6691.if.lr.ph:                                   ; preds = %B6577
  %.4160 = fneg contract double %.3952
  %.4171 = insertelement <8 x double> poison, double %.4160, i64 0
  %.4172 = shufflevector <8 x double> %.4171, <8 x double> poison, <8 x i32> zeroinitializer
  %21 = mul i64 %column.3.1, %1
  br label %B6691.if

B7025:                                            ; preds = %B6691.if, %B6577
  %.4202 = add nuw nsw i64 %column.3.1, 1
  br label %B7469

B7469:                                            ; preds = %B1170.if, %B7025, %B1166
  %column.4.2 = phi i64 [ %.4202, %B7025 ], [ %.1034, %B1166 ], [ %.1034, %B1170.if ]
  %.4212 = icmp slt i64 %column.4.2, 13
  br i1 %.4212, label %B734, label %B7471

B7471:                                            ; preds = %B7469, %B546, %B484
  %scevgep100 = getelementptr i8, ptr %lsr.iv99, i64 %1
  %lsr.iv.next110 = add i64 %lsr.iv109, %1
  %exitcond.not = icmp eq i64 %.153, 13
  br i1 %exitcond.not, label %B7979, label %B84.if

B7979:                                            ; preds = %B7471
  store ptr null, ptr %retptr, align 8
  ret void

B84.if:                                           ; preds = %B7471, %entry
  %lsr.iv109 = phi i64 [ 0, %entry ], [ %lsr.iv.next110, %B7471 ]
  %lsr.iv99 = phi ptr [ %scevgep, %entry ], [ %scevgep100, %B7471 ]
  %.82.0 = phi i64 [ 0, %entry ], [ %.153, %B7471 ]
  %.153 = add nuw nsw i64 %.82.0, 1
  %.184 = mul nsw i64 %.52, %.82.0
  br i1 %4, label %B230.if, label %B384.else

B230.if:                                          ; preds = %B84.if, %B230.if
  %lsr.iv1 = phi i64 [ %lsr.iv.next2, %B230.if ], [ %3, %B84.if ]
  %lsr.iv101 = phi ptr [ %scevgep102, %B230.if ], [ %lsr.iv99, %B84.if ]
  %odd.2.12372 = phi <8 x double> [ %.405, %B230.if ], [ zeroinitializer, %B84.if ]
  %even.3.12371 = phi <8 x double> [ %.403, %B230.if ], [ zeroinitializer, %B84.if ]
  %scevgep103 = getelementptr i8, ptr %lsr.iv101, i64 -64
  %.390 = load <8 x double>, ptr %scevgep103, align 8
  %.401 = load <8 x double>, ptr %lsr.iv101, align 8
  %.403 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.390, <8 x double> %.390, <8 x double> %even.3.12371)
  %.405 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.401, <8 x double> %.401, <8 x double> %odd.2.12372)
  %scevgep102 = getelementptr i8, ptr %lsr.iv101, i64 128
  %lsr.iv.next2 = add nsw i64 %lsr.iv1, -1
  %.343 = icmp sgt i64 %lsr.iv1, 5
  br i1 %.343, label %B230.if, label %B384.else

B384.else:                                        ; preds = %B230.if, %B84.if
  %even.3.1.lcssa = phi <8 x double> [ zeroinitializer, %B84.if ], [ %.403, %B230.if ]
  %odd.2.1.lcssa = phi <8 x double> [ zeroinitializer, %B84.if ], [ %.405, %B230.if ]
  br i1 %6, label %B484, label %B402

B734.preheader:                                   ; preds = %B546
  %.idx2335 = mul nuw nsw i64 %.82.0, 104
  %22 = getelementptr i8, ptr %arg.root.4, i64 %.idx2335
  br label %B734

B1092.if:                                         ; preds = %B1092.if, %B1092.if.preheader
  %lsr.iv120 = phi ptr [ %arg.block.4, %B1092.if.preheader ], [ %scevgep121, %B1092.if ]
  %lsr.iv118 = phi i64 [ %2, %B1092.if.preheader ], [ %lsr.iv.next119, %B1092.if ]
  %_reflect_four_v222_s3.2.22400 = phi <8 x double> [ zeroinitializer, %B1092.if.preheader ], [ %.1641, %B1092.if ]
  %_reflect_four_v222_s2.2.22399 = phi <8 x double> [ zeroinitializer, %B1092.if.preheader ], [ %.1622, %B1092.if ]
  %_reflect_four_v222_s1.2.22398 = phi <8 x double> [ zeroinitializer, %B1092.if.preheader ], [ %.1599, %B1092.if ]
  %_reflect_four_v222_s0.2.22397 = phi <8 x double> [ zeroinitializer, %B1092.if.preheader ], [ %.1580, %B1092.if ]
  %scevgep126 = getelementptr i8, ptr %lsr.iv120, i64 %lsr.iv109
  %.1561 = load <8 x double>, ptr %scevgep126, align 8
  %scevgep125 = getelementptr i8, ptr %lsr.iv120, i64 %15
  %.1575 = load <8 x double>, ptr %scevgep125, align 8
  %.1580 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1561, <8 x double> %.1575, <8 x double> %_reflect_four_v222_s0.2.22397)
  %scevgep124 = getelementptr i8, ptr %lsr.iv120, i64 %14
  %.1594 = load <8 x double>, ptr %scevgep124, align 8
  %.1599 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1561, <8 x double> %.1594, <8 x double> %_reflect_four_v222_s1.2.22398)
  %scevgep123 = getelementptr i8, ptr %lsr.iv120, i64 %13
  %.1617 = load <8 x double>, ptr %scevgep123, align 8
  %.1622 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1561, <8 x double> %.1617, <8 x double> %_reflect_four_v222_s2.2.22399)
  %scevgep122 = getelementptr i8, ptr %lsr.iv120, i64 %12
  %.1636 = load <8 x double>, ptr %scevgep122, align 8
  %.1641 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1561, <8 x double> %.1636, <8 x double> %_reflect_four_v222_s3.2.22400)
  %lsr.iv.next119 = add i64 %lsr.iv118, -1
  %scevgep121 = getelementptr i8, ptr %lsr.iv120, i64 64
  %.1514 = icmp sgt i64 %lsr.iv.next119, 1
  br i1 %.1514, label %B1092.if, label %B1166

B1170.if:                                         ; preds = %B1170.if, %B1170.if.lr.ph
  %lsr.iv129 = phi ptr [ %arg.block.4, %B1170.if.lr.ph ], [ %scevgep130, %B1170.if ]
  %lsr.iv127 = phi i64 [ %2, %B1170.if.lr.ph ], [ %lsr.iv.next128, %B1170.if ]
  %scevgep135 = getelementptr i8, ptr %lsr.iv129, i64 %lsr.iv109
  %.3238 = load <8 x double>, ptr %scevgep135, align 8
  %scevgep134 = getelementptr i8, ptr %lsr.iv129, i64 %19
  %.3259 = load <8 x double>, ptr %scevgep134, align 8
  %.3265 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.3238, <8 x double> %.3264, <8 x double> %.3259)
  store <8 x double> %.3265, ptr %scevgep134, align 8
  %scevgep133 = getelementptr i8, ptr %lsr.iv129, i64 %18
  %.3298 = load <8 x double>, ptr %scevgep133, align 8
  %.3304 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.3238, <8 x double> %.3303, <8 x double> %.3298)
  store <8 x double> %.3304, ptr %scevgep133, align 8
  %scevgep132 = getelementptr i8, ptr %lsr.iv129, i64 %17
  %.3337 = load <8 x double>, ptr %scevgep132, align 8
  %.3343 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.3238, <8 x double> %.3342, <8 x double> %.3337)
  store <8 x double> %.3343, ptr %scevgep132, align 8
  %scevgep131 = getelementptr i8, ptr %lsr.iv129, i64 %16
  %.3376 = load <8 x double>, ptr %scevgep131, align 8
  %.3382 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.3238, <8 x double> %.3381, <8 x double> %.3376)
  store <8 x double> %.3382, ptr %scevgep131, align 8
  %lsr.iv.next128 = add i64 %lsr.iv127, -1
  %scevgep130 = getelementptr i8, ptr %lsr.iv129, i64 64
  %.3191 = icmp sgt i64 %lsr.iv.next128, 1
  br i1 %.3191, label %B1170.if, label %B7469

B6449.if:                                         ; preds = %B6449.if, %B6449.if.preheader
  %lsr.iv106 = phi ptr [ %arg.block.4, %B6449.if.preheader ], [ %scevgep107, %B6449.if ]
  %lsr.iv104 = phi i64 [ %2, %B6449.if.preheader ], [ %lsr.iv.next105, %B6449.if ]
  %_reflect_v217_total.2.32381 = phi <8 x double> [ zeroinitializer, %B6449.if.preheader ], [ %.3646, %B6449.if ]
  %scevgep111 = getelementptr i8, ptr %lsr.iv106, i64 %lsr.iv109
  %.3634 = load <8 x double>, ptr %scevgep111, align 8
  %scevgep108 = getelementptr i8, ptr %lsr.iv106, i64 %20
  %.3644 = load <8 x double>, ptr %scevgep108, align 8
  %.3646 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.3634, <8 x double> %.3644, <8 x double> %_reflect_v217_total.2.32381)
  %lsr.iv.next105 = add i64 %lsr.iv104, -1
  %scevgep107 = getelementptr i8, ptr %lsr.iv106, i64 64
  %.3587 = icmp sgt i64 %lsr.iv.next105, 1
  br i1 %.3587, label %B6449.if, label %B6577

B6691.if:                                         ; preds = %B6691.if, %B6691.if.lr.ph
  %lsr.iv114 = phi ptr [ %arg.block.4, %B6691.if.lr.ph ], [ %scevgep115, %B6691.if ]
  %lsr.iv112 = phi i64 [ %2, %B6691.if.lr.ph ], [ %lsr.iv.next113, %B6691.if ]
  %scevgep117 = getelementptr i8, ptr %lsr.iv114, i64 %lsr.iv109
  %.4158 = load <8 x double>, ptr %scevgep117, align 8
  %scevgep116 = getelementptr i8, ptr %lsr.iv114, i64 %21
  %.4170 = load <8 x double>, ptr %scevgep116, align 8
  %.4173 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.4158, <8 x double> %.4172, <8 x double> %.4170)
  store <8 x double> %.4173, ptr %scevgep116, align 8
  %lsr.iv.next113 = add i64 %lsr.iv112, -1
  %scevgep115 = getelementptr i8, ptr %lsr.iv114, i64 64
  %.4111 = icmp sgt i64 %lsr.iv.next113, 1
  br i1 %.4111, label %B6691.if, label %B7025
}

; Function Attrs: mustprogress nocallback nocreateundeforpoison nofree nosync nounwind speculatable willreturn memory(none)
declare i64 @llvm.smax.i64(i64, i64) #3

; Function Attrs: mustprogress nocallback nocreateundeforpoison nofree nosync nounwind speculatable willreturn memory(none)
declare double @llvm.fma.f64(double, double, double) #3

; Function Attrs: mustprogress nocallback nocreateundeforpoison nofree nosync nounwind speculatable willreturn memory(none)
declare i64 @llvm.smin.i64(i64, i64) #3

; Function Attrs: mustprogress nocallback nocreateundeforpoison nofree nosync nounwind speculatable willreturn memory(none)
declare <8 x double> @llvm.fma.v8f64(<8 x double>, <8 x double>, <8 x double>) #3

; Function Attrs: mustprogress nofree norecurse nosync nounwind willreturn memory(argmem: readwrite)
define internal fastcc void @inner_1(ptr noalias nonnull writeonly captures(none) initializes((0, 8)) %retptr, ptr readonly captures(none) %arg.arm.4, double %arg.sin_d, double %arg.cos_d, <8 x double> %arg.f, <8 x double> %arg.sin_h, <8 x double> %arg.cos_h, ptr captures(none) %arg.out.4) unnamed_addr #4 {
entry:
  %.67 = load double, ptr %arg.arm.4, align 8
  %.95 = getelementptr i8, ptr %arg.arm.4, i64 8
  %.96 = load double, ptr %.95, align 8
  %.124 = getelementptr i8, ptr %arg.arm.4, i64 16
  %.125 = load double, ptr %.124, align 8
  %.153 = getelementptr i8, ptr %arg.arm.4, i64 24
  %.154 = load double, ptr %.153, align 8
  %.182 = getelementptr i8, ptr %arg.arm.4, i64 32
  %.183 = load double, ptr %.182, align 8
  %.6.i = insertelement <8 x double> poison, double %.67, i64 0
  %.7.i = shufflevector <8 x double> %.6.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.8.i = fmul contract <8 x double> %arg.cos_h, %.7.i
  %.6.i5 = insertelement <8 x double> poison, double %.96, i64 0
  %.7.i6 = shufflevector <8 x double> %.6.i5, <8 x double> poison, <8 x i32> zeroinitializer
  %.8.i7 = fmul contract <8 x double> %arg.sin_h, %.7.i6
  %.6.i8 = fsub contract <8 x double> %.8.i, %.8.i7
  %.8.i11 = fmul contract <8 x double> %arg.sin_h, %.7.i
  %.8.i14 = fmul contract <8 x double> %arg.cos_h, %.7.i6
  %.6.i15 = fadd contract <8 x double> %.8.i11, %.8.i14
  %.6.i16 = fsub contract <8 x double> zeroinitializer, %.6.i15
  %.6.i17 = insertelement <8 x double> poison, double %arg.sin_d, i64 0
  %.7.i18 = shufflevector <8 x double> %.6.i17, <8 x double> poison, <8 x i32> zeroinitializer
  %.8.i19 = fmul contract <8 x double> %.7.i18, %.6.i8
  %.397 = fmul contract double %arg.cos_d, %.125
  %.398 = insertelement <8 x double> poison, double %.397, i64 0
  %.399 = shufflevector <8 x double> %.398, <8 x double> poison, <8 x i32> zeroinitializer
  %.6.i20 = fsub contract <8 x double> %.399, %.8.i19
  %.6.i21 = insertelement <8 x double> poison, double %arg.cos_d, i64 0
  %.7.i22 = shufflevector <8 x double> %.6.i21, <8 x double> poison, <8 x i32> zeroinitializer
  %.8.i23 = fmul contract <8 x double> %.7.i22, %.6.i8
  %.451 = fneg contract double %arg.sin_d
  %.452 = fmul contract double %.125, %.451
  %.453 = insertelement <8 x double> poison, double %.452, i64 0
  %.454 = shufflevector <8 x double> %.453, <8 x double> poison, <8 x i32> zeroinitializer
  %.6.i24 = fsub contract <8 x double> %.454, %.8.i23
  %.6.i25 = fsub contract <8 x double> zeroinitializer, %.6.i8
  %.8.i28 = fmul contract <8 x double> %.7.i18, %.6.i15
  %.558 = fmul contract double %.154, 2.000000e+00
  %.6.i29 = fmul contract <8 x double> %.6.i16, %.6.i16
  %.6.i30 = fmul contract <8 x double> %.6.i20, %.6.i20
  %.6.i31 = fsub contract <8 x double> %.6.i29, %.6.i30
  %.6.i32 = insertelement <8 x double> poison, double %.154, i64 0
  %.7.i33 = shufflevector <8 x double> %.6.i32, <8 x double> poison, <8 x i32> zeroinitializer
  %.8.i34 = fmul contract <8 x double> %.7.i33, %.6.i31
  %.6.i35 = fmul contract <8 x double> %.6.i16, %.6.i20
  %.6.i36 = insertelement <8 x double> poison, double %.558, i64 0
  %.7.i37 = shufflevector <8 x double> %.6.i36, <8 x double> poison, <8 x i32> zeroinitializer
  %.8.i38 = fmul contract <8 x double> %.7.i37, %.6.i35
  %.6.i39 = fmul contract <8 x double> %.6.i16, %.6.i25
  %.6.i40 = fmul contract <8 x double> %.8.i28, %.6.i20
  %.6.i41 = fsub contract <8 x double> %.6.i39, %.6.i40
  %.8.i44 = fmul contract <8 x double> %.7.i37, %.6.i41
  %.6.i45 = fmul contract <8 x double> %.6.i25, %.6.i20
  %.6.i46 = fmul contract <8 x double> %.6.i16, %.8.i28
  %.6.i47 = fadd contract <8 x double> %.6.i46, %.6.i45
  %.8.i50 = fmul contract <8 x double> %.7.i37, %.6.i47
  %.6.i51 = fmul contract <8 x double> %.6.i20, %.6.i24
  %.938 = fneg contract double %.558
  %.6.i52 = insertelement <8 x double> poison, double %.938, i64 0
  %.7.i53 = shufflevector <8 x double> %.6.i52, <8 x double> poison, <8 x i32> zeroinitializer
  %.8.i54 = fmul contract <8 x double> %.7.i53, %.6.i51
  %.6.i55 = fmul contract <8 x double> %.6.i16, %.6.i24
  %.8.i58 = fmul contract <8 x double> %.7.i37, %.6.i55
  %.1019 = fcmp contract ogt double %.183, 0.000000e+00
  br i1 %.1019, label %B470, label %B974

B470:                                             ; preds = %entry
  %.1023 = fmul contract double %.183, 0x400921FB54442D18
  %.6.i1 = insertelement <8 x double> poison, double %.1023, i64 0
  %.7.i2 = shufflevector <8 x double> %.6.i1, <8 x double> poison, <8 x i32> zeroinitializer
  %.8.i3 = fmul contract <8 x double> %arg.f, %.7.i2
  %.6.i59 = fadd contract <8 x double> %.6.i24, splat (double 1.000000e+00)
  %.6.i60 = fmul contract <8 x double> %.8.i3, %.6.i59
  %.6.i61 = fsub contract <8 x double> splat (double 1.000000e+00), %.6.i24
  %.6.i62 = fmul contract <8 x double> %.8.i3, %.6.i61
  %.8.i63 = fadd contract <8 x double> %.6.i60, splat (double 0x16687E92154EF7AC)
  %.1186 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i63, <8 x double> splat (double 0x3FE45F306DC9C883), <8 x double> splat (double 0x4338000000000000))
  %.8.i64 = fadd contract <8 x double> %.1186, splat (double 0xC338000000000000)
  %.1227 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i64, <8 x double> splat (double 0xBFF921FB54442D18), <8 x double> %.8.i63)
  %.1244 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i64, <8 x double> splat (double 0xBC91A62633145C07), <8 x double> %.1227)
  %.6.i65 = fmul contract <8 x double> %.1244, %.1244
  %.6.i66 = fmul contract <8 x double> %.1244, %.6.i65
  %.1273 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i65, <8 x double> splat (double 0xBD6AE7F3E733B81F), <8 x double> splat (double 0x3DE6124613A86D09))
  %.1276 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i65, <8 x double> %.1273, <8 x double> splat (double 0xBE5AE64567F544E4))
  %.1279 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i65, <8 x double> %.1276, <8 x double> splat (double 0x3EC71DE3A556C734))
  %.1282 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i65, <8 x double> %.1279, <8 x double> splat (double 0xBF2A01A01A01A01A))
  %.1285 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i65, <8 x double> %.1282, <8 x double> splat (double 0x3F81111111111111))
  %.1288 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i65, <8 x double> %.1285, <8 x double> splat (double 0xBFC5555555555555))
  %.1313 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i66, <8 x double> %.1288, <8 x double> %.1244)
  %.1318 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i65, <8 x double> splat (double 0x3D2AE7F3E733B81F), <8 x double> splat (double 0xBDA93974A8C07C9D))
  %.1321 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i65, <8 x double> %.1318, <8 x double> splat (double 0x3E21EED8EFF8D898))
  %.1324 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i65, <8 x double> %.1321, <8 x double> splat (double 0xBE927E4FB7789F5C))
  %.1327 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i65, <8 x double> %.1324, <8 x double> splat (double 0x3EFA01A01A01A01A))
  %.1330 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i65, <8 x double> %.1327, <8 x double> splat (double 0xBF56C16C16C16C17))
  %.1333 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i65, <8 x double> %.1330, <8 x double> splat (double 0x3FA5555555555555))
  %.1336 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i65, <8 x double> %.1333, <8 x double> splat (double -5.000000e-01))
  %.1339 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i65, <8 x double> %.1336, <8 x double> splat (double 1.000000e+00))
  %.1340 = bitcast <8 x double> %.1186 to <8 x i64>
  %.1341 = bitcast <8 x double> %.1313 to <8 x i64>
  %.1342 = bitcast <8 x double> %.1339 to <8 x i64>
  %.6.i67 = xor <8 x i64> %.1342, %.1341
  %.8.i68 = and <8 x i64> %.1340, splat (i64 1)
  %0 = icmp eq <8 x i64> %.8.i68, zeroinitializer
  %.6.i70 = select <8 x i1> %0, <8 x i64> zeroinitializer, <8 x i64> %.6.i67
  %.8.i71 = shl <8 x i64> %.1340, splat (i64 62)
  %.8.i72 = and <8 x i64> %.8.i71, splat (i64 -9223372036854775808)
  %.8.i74 = add <8 x i64> %.8.i71, splat (i64 4611686018427387904)
  %.8.i75 = and <8 x i64> %.8.i74, splat (i64 -9223372036854775808)
  %1 = xor <8 x i64> %.8.i72, %.1341
  %.6.i77 = xor <8 x i64> %1, %.6.i70
  %2 = bitcast <8 x i64> %.6.i77 to <8 x double>
  %3 = xor <8 x i64> %.8.i75, %.1342
  %.6.i79 = xor <8 x i64> %3, %.6.i70
  %4 = bitcast <8 x i64> %.6.i79 to <8 x double>
  %.6.i80 = fdiv contract <8 x double> splat (double 1.000000e+00), %.8.i63
  %.6.i81 = fmul contract <8 x double> %.6.i80, %2
  %.6.i82 = fsub contract <8 x double> %4, %.6.i81
  %.6.i83 = fmul contract <8 x double> %.6.i80, %.6.i82
  %.8.i84 = fadd contract <8 x double> %.6.i62, splat (double 0x16687E92154EF7AC)
  %.1845 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i84, <8 x double> splat (double 0x3FE45F306DC9C883), <8 x double> splat (double 0x4338000000000000))
  %.8.i85 = fadd contract <8 x double> %.1845, splat (double 0xC338000000000000)
  %.1886 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i85, <8 x double> splat (double 0xBFF921FB54442D18), <8 x double> %.8.i84)
  %.1903 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i85, <8 x double> splat (double 0xBC91A62633145C07), <8 x double> %.1886)
  %.6.i86 = fmul contract <8 x double> %.1903, %.1903
  %.6.i87 = fmul contract <8 x double> %.1903, %.6.i86
  %.1932 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i86, <8 x double> splat (double 0xBD6AE7F3E733B81F), <8 x double> splat (double 0x3DE6124613A86D09))
  %.1935 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i86, <8 x double> %.1932, <8 x double> splat (double 0xBE5AE64567F544E4))
  %.1938 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i86, <8 x double> %.1935, <8 x double> splat (double 0x3EC71DE3A556C734))
  %.1941 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i86, <8 x double> %.1938, <8 x double> splat (double 0xBF2A01A01A01A01A))
  %.1944 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i86, <8 x double> %.1941, <8 x double> splat (double 0x3F81111111111111))
  %.1947 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i86, <8 x double> %.1944, <8 x double> splat (double 0xBFC5555555555555))
  %.1972 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i87, <8 x double> %.1947, <8 x double> %.1903)
  %.1977 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i86, <8 x double> splat (double 0x3D2AE7F3E733B81F), <8 x double> splat (double 0xBDA93974A8C07C9D))
  %.1980 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i86, <8 x double> %.1977, <8 x double> splat (double 0x3E21EED8EFF8D898))
  %.1983 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i86, <8 x double> %.1980, <8 x double> splat (double 0xBE927E4FB7789F5C))
  %.1986 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i86, <8 x double> %.1983, <8 x double> splat (double 0x3EFA01A01A01A01A))
  %.1989 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i86, <8 x double> %.1986, <8 x double> splat (double 0xBF56C16C16C16C17))
  %.1992 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i86, <8 x double> %.1989, <8 x double> splat (double 0x3FA5555555555555))
  %.1995 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i86, <8 x double> %.1992, <8 x double> splat (double -5.000000e-01))
  %.1998 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i86, <8 x double> %.1995, <8 x double> splat (double 1.000000e+00))
  %.1999 = bitcast <8 x double> %.1845 to <8 x i64>
  %.2000 = bitcast <8 x double> %.1972 to <8 x i64>
  %.2001 = bitcast <8 x double> %.1998 to <8 x i64>
  %.6.i88 = xor <8 x i64> %.2001, %.2000
  %.8.i89 = and <8 x i64> %.1999, splat (i64 1)
  %5 = icmp eq <8 x i64> %.8.i89, zeroinitializer
  %.6.i91 = select <8 x i1> %5, <8 x i64> zeroinitializer, <8 x i64> %.6.i88
  %.8.i92 = shl <8 x i64> %.1999, splat (i64 62)
  %.8.i93 = and <8 x i64> %.8.i92, splat (i64 -9223372036854775808)
  %.8.i95 = add <8 x i64> %.8.i92, splat (i64 4611686018427387904)
  %.8.i96 = and <8 x i64> %.8.i95, splat (i64 -9223372036854775808)
  %6 = xor <8 x i64> %.8.i93, %.2000
  %.6.i98 = xor <8 x i64> %6, %.6.i91
  %7 = bitcast <8 x i64> %.6.i98 to <8 x double>
  %8 = xor <8 x i64> %.8.i96, %.2001
  %.6.i100 = xor <8 x i64> %8, %.6.i91
  %9 = bitcast <8 x i64> %.6.i100 to <8 x double>
  %.6.i101 = fdiv contract <8 x double> splat (double 1.000000e+00), %.8.i84
  %.6.i102 = fmul contract <8 x double> %.6.i101, %7
  %.6.i103 = fsub contract <8 x double> %9, %.6.i102
  %.6.i104 = fmul contract <8 x double> %.6.i101, %.6.i103
  %.6.i105 = fmul contract <8 x double> %.6.i81, %9
  %.6.i106 = fmul contract <8 x double> %.6.i102, %4
  %.6.i107 = fadd contract <8 x double> %.6.i105, %.6.i106
  %.8.i108 = fmul contract <8 x double> %.6.i107, splat (double 5.000000e-01)
  %.6.i109 = fmul contract <8 x double> %.6.i81, %7
  %.6.i110 = fmul contract <8 x double> %.6.i102, %2
  %.6.i111 = fsub contract <8 x double> %.6.i109, %.6.i110
  %.8.i112 = fmul contract <8 x double> %.6.i111, splat (double 5.000000e-01)
  %.8.i113 = fmul contract <8 x double> %.8.i3, splat (double 5.000000e-01)
  %.6.i114 = fmul contract <8 x double> %.6.i83, %9
  %.6.i116 = fadd contract <8 x double> %.6.i109, %.6.i114
  %.6.i117 = fmul contract <8 x double> %.6.i104, %4
  %.6.i118 = fsub contract <8 x double> %.6.i116, %.6.i117
  %.6.i120 = fsub contract <8 x double> %.6.i118, %.6.i110
  %.6.i121 = fmul contract <8 x double> %.8.i113, %.6.i120
  %.6.i122 = fmul contract <8 x double> %.6.i83, %7
  %.6.i124 = fsub contract <8 x double> %.6.i122, %.6.i105
  %.6.i125 = fmul contract <8 x double> %.6.i104, %2
  %.6.i126 = fadd contract <8 x double> %.6.i125, %.6.i124
  %.6.i128 = fsub contract <8 x double> %.6.i126, %.6.i106
  %.6.i129 = fmul contract <8 x double> %.8.i113, %.6.i128
  %.8.i132 = fmul contract <8 x double> %.7.i22, %.6.i15
  %.6.i133 = fsub contract <8 x double> zeroinitializer, %.6.i20
  %.6.i134 = fmul contract <8 x double> %.8.i34, zeroinitializer
  %.6.i135 = fmul contract <8 x double> %.6.i134, %.6.i121
  %.3235 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i108, <8 x double> %.8.i34, <8 x double> %.6.i135)
  %.3249 = load <8 x double>, ptr %arg.out.4, align 8
  %.6.i136 = fadd contract <8 x double> %.3235, %.3249
  store <8 x double> %.6.i136, ptr %arg.out.4, align 8
  %.6.i137 = fmul contract <8 x double> %.6.i134, %.6.i129
  %.3312 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i112, <8 x double> %.8.i34, <8 x double> %.6.i137)
  %.3327 = getelementptr inbounds nuw i8, ptr %arg.out.4, i64 64
  %.3329 = load <8 x double>, ptr %.3327, align 8
  %.6.i138 = fadd contract <8 x double> %.3312, %.3329
  store <8 x double> %.6.i138, ptr %.3327, align 8
  %.6.i139 = fmul contract <8 x double> %.8.i38, zeroinitializer
  %.6.i140 = fmul contract <8 x double> %.6.i139, %.6.i121
  %.3442 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i108, <8 x double> %.8.i38, <8 x double> %.6.i140)
  %.3454 = getelementptr inbounds nuw i8, ptr %arg.out.4, i64 128
  %.3456 = load <8 x double>, ptr %.3454, align 8
  %.6.i141 = fadd contract <8 x double> %.3442, %.3456
  store <8 x double> %.6.i141, ptr %.3454, align 8
  %.6.i142 = fmul contract <8 x double> %.6.i139, %.6.i129
  %.3519 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i112, <8 x double> %.8.i38, <8 x double> %.6.i142)
  %.3534 = getelementptr inbounds nuw i8, ptr %arg.out.4, i64 192
  %.3536 = load <8 x double>, ptr %.3534, align 8
  %.6.i143 = fadd contract <8 x double> %.3519, %.3536
  store <8 x double> %.6.i143, ptr %.3534, align 8
  %.6.i144 = fmul contract <8 x double> %.8.i132, %.8.i34
  %.6.i145 = fmul contract <8 x double> %.6.i144, %.6.i121
  %.3651 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i108, <8 x double> %.8.i44, <8 x double> %.6.i145)
  %.3663 = getelementptr inbounds nuw i8, ptr %arg.out.4, i64 256
  %.3665 = load <8 x double>, ptr %.3663, align 8
  %.6.i146 = fadd contract <8 x double> %.3651, %.3665
  store <8 x double> %.6.i146, ptr %.3663, align 8
  %.6.i147 = fmul contract <8 x double> %.6.i144, %.6.i129
  %.3728 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i112, <8 x double> %.8.i44, <8 x double> %.6.i147)
  %.3743 = getelementptr inbounds nuw i8, ptr %arg.out.4, i64 320
  %.3745 = load <8 x double>, ptr %.3743, align 8
  %.6.i148 = fadd contract <8 x double> %.3728, %.3745
  store <8 x double> %.6.i148, ptr %.3743, align 8
  %.6.i149 = fmul contract <8 x double> %.8.i132, %.8.i38
  %.6.i150 = fmul contract <8 x double> %.6.i149, %.6.i121
  %.3860 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i108, <8 x double> %.8.i50, <8 x double> %.6.i150)
  %.3872 = getelementptr inbounds nuw i8, ptr %arg.out.4, i64 384
  %.3874 = load <8 x double>, ptr %.3872, align 8
  %.6.i151 = fadd contract <8 x double> %.3860, %.3874
  store <8 x double> %.6.i151, ptr %.3872, align 8
  %.6.i152 = fmul contract <8 x double> %.6.i149, %.6.i129
  %.3937 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i112, <8 x double> %.8.i50, <8 x double> %.6.i152)
  %.3952 = getelementptr inbounds nuw i8, ptr %arg.out.4, i64 448
  %.3954 = load <8 x double>, ptr %.3952, align 8
  %.6.i153 = fadd contract <8 x double> %.3937, %.3954
  store <8 x double> %.6.i153, ptr %.3952, align 8
  %.6.i154 = fmul contract <8 x double> %.6.i133, %.8.i34
  %.6.i155 = fmul contract <8 x double> %.6.i154, %.6.i121
  %.4071 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i108, <8 x double> %.8.i54, <8 x double> %.6.i155)
  %.4083 = getelementptr inbounds nuw i8, ptr %arg.out.4, i64 512
  %.4085 = load <8 x double>, ptr %.4083, align 8
  %.6.i156 = fadd contract <8 x double> %.4071, %.4085
  store <8 x double> %.6.i156, ptr %.4083, align 8
  %.6.i157 = fmul contract <8 x double> %.6.i154, %.6.i129
  %.4148 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i112, <8 x double> %.8.i54, <8 x double> %.6.i157)
  %.4163 = getelementptr inbounds nuw i8, ptr %arg.out.4, i64 576
  %.4165 = load <8 x double>, ptr %.4163, align 8
  %.6.i158 = fadd contract <8 x double> %.4148, %.4165
  store <8 x double> %.6.i158, ptr %.4163, align 8
  %.6.i159 = fmul contract <8 x double> %.6.i133, %.8.i38
  %.6.i160 = fmul contract <8 x double> %.6.i159, %.6.i121
  %.4291 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i108, <8 x double> %.8.i58, <8 x double> %.6.i160)
  %.4303 = getelementptr inbounds nuw i8, ptr %arg.out.4, i64 640
  %.4305 = load <8 x double>, ptr %.4303, align 8
  %.6.i161 = fadd contract <8 x double> %.4291, %.4305
  store <8 x double> %.6.i161, ptr %.4303, align 8
  %.6.i162 = fmul contract <8 x double> %.6.i159, %.6.i129
  %.4368 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i112, <8 x double> %.8.i58, <8 x double> %.6.i162)
  br label %common.ret

B974:                                             ; preds = %entry
  %.4454 = load <8 x double>, ptr %arg.out.4, align 8
  %.6.i4 = fadd contract <8 x double> %.8.i34, %.4454
  store <8 x double> %.6.i4, ptr %arg.out.4, align 8
  %.4507 = getelementptr inbounds nuw i8, ptr %arg.out.4, i64 128
  %.4509 = load <8 x double>, ptr %.4507, align 8
  %.6.i164 = fadd contract <8 x double> %.8.i38, %.4509
  store <8 x double> %.6.i164, ptr %.4507, align 8
  %.4562 = getelementptr inbounds nuw i8, ptr %arg.out.4, i64 256
  %.4564 = load <8 x double>, ptr %.4562, align 8
  %.6.i165 = fadd contract <8 x double> %.8.i44, %.4564
  store <8 x double> %.6.i165, ptr %.4562, align 8
  %.4617 = getelementptr inbounds nuw i8, ptr %arg.out.4, i64 384
  %.4619 = load <8 x double>, ptr %.4617, align 8
  %.6.i166 = fadd contract <8 x double> %.8.i50, %.4619
  store <8 x double> %.6.i166, ptr %.4617, align 8
  %.4672 = getelementptr inbounds nuw i8, ptr %arg.out.4, i64 512
  %.4674 = load <8 x double>, ptr %.4672, align 8
  %.6.i167 = fadd contract <8 x double> %.8.i54, %.4674
  store <8 x double> %.6.i167, ptr %.4672, align 8
  br label %common.ret

common.ret:                                       ; preds = %B974, %B470
  %.sink = phi i64 [ 640, %B974 ], [ 704, %B470 ]
  %.8.i58.sink = phi <8 x double> [ %.8.i58, %B974 ], [ %.4368, %B470 ]
  %.4732 = getelementptr inbounds nuw i8, ptr %arg.out.4, i64 %.sink
  %.4734 = load <8 x double>, ptr %.4732, align 8
  %.6.i168 = fadd contract <8 x double> %.8.i58.sink, %.4734
  store <8 x double> %.6.i168, ptr %.4732, align 8
  store ptr null, ptr %retptr, align 8
  ret void
}

; Function Attrs: mustprogress nocallback nofree nosync nounwind willreturn memory(none)
declare double @sqrt(double) local_unnamed_addr #5

; Function Attrs: nocallback nofree nosync nounwind willreturn memory(argmem: readwrite)
declare void @llvm.lifetime.start.p0(ptr captures(none)) #6

; Function Attrs: nocallback nofree nosync nounwind willreturn memory(argmem: readwrite)
declare void @llvm.lifetime.end.p0(ptr captures(none)) #6

attributes #0 = { nofree norecurse nosync nounwind memory(readwrite, inaccessiblemem: none, target_mem0: none, target_mem1: none) }
attributes #1 = { mustprogress nocallback nofree nounwind willreturn memory(argmem: write) }
attributes #2 = { nofree norecurse nosync nounwind memory(argmem: readwrite) }
attributes #3 = { mustprogress nocallback nocreateundeforpoison nofree nosync nounwind speculatable willreturn memory(none) }
attributes #4 = { mustprogress nofree norecurse nosync nounwind willreturn memory(argmem: readwrite) }
attributes #5 = { mustprogress nocallback nofree nosync nounwind willreturn memory(none) }
attributes #6 = { nocallback nofree nosync nounwind willreturn memory(argmem: readwrite) }

!0 = !{!1}
!1 = distinct !{!1, !2, !"_ZN17bnserve_inference13fisher_kernel7_source9factoriseB2v3B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIxLi1E1C7mutable7alignedE: %retptr"}
!2 = distinct !{!2, !"_ZN17bnserve_inference13fisher_kernel7_source9factoriseB2v3B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIxLi1E1C7mutable7alignedE"}
!3 = !{!4, !1}
!4 = distinct !{!4, !5, !"_ZN17bnserve_inference13fisher_kernel7_source4_rowB3v17B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIxLi1E1C7mutable7alignedE52_Room_28array_28float64_2c_201d_2c_20C_29_20x_208_29: %retptr"}
!5 = distinct !{!5, !"_ZN17bnserve_inference13fisher_kernel7_source4_rowB3v17B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIxLi1E1C7mutable7alignedE52_Room_28array_28float64_2c_201d_2c_20C_29_20x_208_29"}
!6 = !{!7, !4, !1}
!7 = distinct !{!7, !8, !"_ZN17bnserve_inference13fisher_kernel7_source11_fill_panelB4v231B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxx5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE52_Room_28array_28float64_2c_201d_2c_20C_29_20x_208_29: %retptr"}
!8 = distinct !{!8, !"_ZN17bnserve_inference13fisher_kernel7_source11_fill_panelB4v231B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxx5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE52_Room_28array_28float64_2c_201d_2c_20C_29_20x_208_29"}
!9 = !{!10, !7, !4, !1}
!10 = distinct !{!10, !11, !"_ZN17bnserve_inference13fisher_kernel9_tangents8polariseB3v59B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!11 = distinct !{!11, !"_ZN17bnserve_inference13fisher_kernel9_tangents8polariseB3v59B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!12 = !{!13, !7, !4, !1}
!13 = distinct !{!13, !14, !"_ZN17bnserve_inference13fisher_kernel9_tangents10pass_nodesB3v89B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExd19vector_28float64_295ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!14 = distinct !{!14, !"_ZN17bnserve_inference13fisher_kernel9_tangents10pass_nodesB3v89B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExd19vector_28float64_295ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!15 = !{!16, !7, !4, !1}
!16 = distinct !{!16, !17, !"_ZN17bnserve_inference13fisher_kernel9_tangents7observeB4v133B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEd8UniTupleI19vector_28float64_29Li2EE5ArrayIdLi1E1C7mutable7alignedExxb: %retptr"}
!17 = distinct !{!17, !"_ZN17bnserve_inference13fisher_kernel9_tangents7observeB4v133B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEd8UniTupleI19vector_28float64_29Li2EE5ArrayIdLi1E1C7mutable7alignedExxb"}
!18 = !{!19, !7, !4, !1}
!19 = distinct !{!19, !20, !"_ZN17bnserve_inference13fisher_kernel9_tangents13differentiateB4v143B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE8UniTupleIdLi3EE19vector_28float64_298UniTupleI19vector_28float64_29Li2EEb5ArrayIdLi1E1C7mutable7alignedExxb: %retptr"}
!20 = distinct !{!20, !"_ZN17bnserve_inference13fisher_kernel9_tangents13differentiateB4v143B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE8UniTupleIdLi3EE19vector_28float64_298UniTupleI19vector_28float64_29Li2EEb5ArrayIdLi1E1C7mutable7alignedExxb"}
!21 = !{!22, !7, !4, !1}
!22 = distinct !{!22, !23, !"_ZN17bnserve_inference13fisher_kernel9_response7respondB4v101B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE8UniTupleIdLi2EE8UniTupleIdLi2EE19vector_28float64_2919vector_28float64_2919vector_28float64_295ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!23 = distinct !{!23, !"_ZN17bnserve_inference13fisher_kernel9_response7respondB4v101B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE8UniTupleIdLi2EE8UniTupleIdLi2EE19vector_28float64_2919vector_28float64_2919vector_28float64_295ArrayIdLi1E1C7mutable7alignedE"}
!24 = !{!25, !4, !1}
!25 = distinct !{!25, !26, !"_ZN17bnserve_inference13fisher_kernel7_source12_add_squaresB4v247B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExx5ArrayIxLi1E1C7mutable7alignedE52_Room_28array_28float64_2c_201d_2c_20C_29_20x_208_29: %retptr"}
!26 = distinct !{!26, !"_ZN17bnserve_inference13fisher_kernel7_source12_add_squaresB4v247B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExx5ArrayIxLi1E1C7mutable7alignedE52_Room_28array_28float64_2c_201d_2c_20C_29_20x_208_29"}
!27 = !{!28, !4, !1}
!28 = distinct !{!28, !29, !"_ZN17bnserve_inference13fisher_kernel7_source5_copyB4v255B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxx5ArrayIxLi1E1C7mutable7alignedE52_Room_28array_28float64_2c_201d_2c_20C_29_20x_208_29: %retptr"}
!29 = distinct !{!29, !"_ZN17bnserve_inference13fisher_kernel7_source5_copyB4v255B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxx5ArrayIxLi1E1C7mutable7alignedE52_Room_28array_28float64_2c_201d_2c_20C_29_20x_208_29"}
!30 = !{!31, !4, !1}
!31 = distinct !{!31, !32, !"_ZN17bnserve_inference13fisher_kernel7_source7_finishB4v211B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIxLi1E1C7mutable7alignedE52_Room_28array_28float64_2c_201d_2c_20C_29_20x_208_29: %retptr"}
!32 = distinct !{!32, !"_ZN17bnserve_inference13fisher_kernel7_source7_finishB4v211B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIxLi1E1C7mutable7alignedE52_Room_28array_28float64_2c_201d_2c_20C_29_20x_208_29"}
!33 = distinct !{!33, !34}
!34 = !{!"llvm.loop.unroll.disable"}
!35 = distinct !{!35, !34}
!36 = !{!37, !1}
!37 = distinct !{!37, !38, !"_ZN17bnserve_inference13fisher_kernel7_source7_refuseB4v257B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIxLi1E1C7mutable7alignedE: %retptr"}
!38 = distinct !{!38, !"_ZN17bnserve_inference13fisher_kernel7_source7_refuseB4v257B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIxLi1E1C7mutable7alignedE"}
!39 = !{!"branch_weights", i32 1, i32 99}
!40 = !{!"branch_weights", i32 146201250, i32 2001282398}
!41 = !{!"branch_weights", i32 166258294, i32 1981225354}
!42 = !{!"branch_weights", i32 1030503492, i32 1116980156}
!43 = !{!"branch_weights", i32 277993707, i32 1869489941}
!44 = !{!"branch_weights", i32 542333185, i32 1605150463}
!45 = distinct !{!45, !46, !34}
!46 = !{!"llvm.loop.estimated_trip_count", i32 4}
!47 = !{!"branch_weights", i32 319644862, i32 1827838786}
!48 = distinct !{!48, !49}
!49 = !{!"llvm.loop.estimated_trip_count", i32 6}
