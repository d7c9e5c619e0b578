; sources: b8cddd1d3c2a58cfacc1a065e4524c502cd8637c9e39e529e0af4aef1961cfb0
; built by: numba 0.68.1, llvmlite 0.50.0, Python 3.11, x86_64
; ModuleID = '<string>'
source_filename = "<string>"


; Function Attrs: nofree norecurse nosync nounwind memory(readwrite, inaccessiblemem: none, target_mem0: none, target_mem1: none)
define noundef i32 @bnserve_twist(ptr noalias writeonly captures(none) %retptr, ptr noalias readnone captures(none) %excinfo, ptr readonly captures(none) %arg.arguments) local_unnamed_addr #0 {
entry:
  %.1111.i15.i = alloca ptr, align 8
  %.2357.i17.i = alloca ptr, align 8
  %.2832.i19.i = alloca ptr, align 8
  %.3310.i21.i = alloca ptr, align 8
  %.3609.i23.i = alloca ptr, align 8
  %.1111.i.i = alloca ptr, align 8
  %.2357.i.i = alloca ptr, align 8
  %.2832.i.i = alloca ptr, align 8
  %.3310.i.i = alloca ptr, align 8
  %.3609.i.i = alloca ptr, align 8
  %.47.i = getelementptr i8, ptr %arg.arguments, i64 96
  %.48.i = load i64, ptr %.47.i, align 8, !noalias !0
  %.49.i = inttoptr i64 %.48.i to ptr
  %.171.i = getelementptr inbounds nuw i8, ptr %.49.i, i64 2432
  %.252.i = getelementptr inbounds nuw i8, ptr %.49.i, i64 3072
  %.319.i = getelementptr inbounds nuw i8, ptr %.49.i, i64 7616
  %.390.i = getelementptr i8, ptr %.49.i, i64 28736
  %.476.i = load i64, ptr %arg.arguments, align 8, !noalias !0
  %.512.i = mul nsw i64 %.476.i, 10
  %0 = add nuw i64 %.476.i, 7
  %.712.i = lshr i64 %0, 3
  %.691.inv.i = icmp slt i64 %.476.i, 1
  %.733796.not858.i = icmp eq i64 %.712.i, 0
  %.733796.not.i = select i1 %.691.inv.i, i1 true, i1 %.733796.not858.i
  br i1 %.733796.not.i, label %_ZN17bnserve_surrogate10precession7_source5twistB2v3B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIxLi1E1C7mutable7alignedE.exit, label %B642.if.preheader.i

B642.if.preheader.i:                              ; preds = %entry
  %.596.i = getelementptr i8, ptr %arg.arguments, i64 88
  %.597.i = load i64, ptr %.596.i, align 8, !noalias !0
  %.509.i = getelementptr i8, ptr %arg.arguments, i64 56
  %.510.i = load i64, ptr %.509.i, align 8, !noalias !0
  %scevgep.i = getelementptr i8, ptr %.49.i, i64 29304
  %1 = inttoptr i64 %.597.i to ptr
  %.180.i.i = getelementptr i8, ptr %arg.arguments, i64 64
  %.266.i.i = getelementptr i8, ptr %arg.arguments, i64 72
  %.379.i.i = getelementptr i8, ptr %arg.arguments, i64 80
  %.385.i.i = shl nuw nsw i64 %.476.i, 1
  %.566.i.i = add nsw i64 %.476.i, -1
  %2 = getelementptr i8, ptr %1, i64 16
  %3 = getelementptr i8, ptr %1, i64 32
  %4 = getelementptr i8, ptr %1, i64 48
  %5 = getelementptr i8, ptr %1, i64 64
  %6 = getelementptr i8, ptr %1, i64 80
  %7 = getelementptr i8, ptr %1, i64 96
  %8 = getelementptr i8, ptr %1, i64 112
  %scevgep53.i.i = getelementptr i8, ptr %.49.i, i64 4416
  %sunkaddr57.i.i = getelementptr i8, ptr %.49.i, i64 2440
  %scevgep51.i.i = getelementptr i8, ptr %.49.i, i64 4424
  %sunkaddr60.i.i = getelementptr i8, ptr %.49.i, i64 2448
  %scevgep49.i.i = getelementptr i8, ptr %.49.i, i64 4432
  %sunkaddr63.i.i = getelementptr i8, ptr %.49.i, i64 2456
  %scevgep47.i.i = getelementptr i8, ptr %.49.i, i64 4440
  %sunkaddr66.i.i = getelementptr i8, ptr %.49.i, i64 2464
  %scevgep45.i.i = getelementptr i8, ptr %.49.i, i64 4448
  %sunkaddr69.i.i = getelementptr i8, ptr %.49.i, i64 2472
  %scevgep43.i.i = getelementptr i8, ptr %.49.i, i64 4456
  %sunkaddr72.i.i = getelementptr i8, ptr %.49.i, i64 2480
  %scevgep41.i.i = getelementptr i8, ptr %.49.i, i64 4464
  %sunkaddr75.i.i = getelementptr i8, ptr %.49.i, i64 2488
  %scevgep39.i.i = getelementptr i8, ptr %.49.i, i64 4472
  %sunkaddr78.i.i = getelementptr i8, ptr %.49.i, i64 2496
  %scevgep37.i.i = getelementptr i8, ptr %.49.i, i64 4480
  %sunkaddr81.i.i = getelementptr i8, ptr %.49.i, i64 2504
  %scevgep35.i.i = getelementptr i8, ptr %.49.i, i64 4488
  %sunkaddr54.1.i.i = getelementptr i8, ptr %.49.i, i64 2512
  %scevgep53.1.i.i = getelementptr i8, ptr %.49.i, i64 4496
  %sunkaddr57.1.i.i = getelementptr i8, ptr %.49.i, i64 2520
  %scevgep51.1.i.i = getelementptr i8, ptr %.49.i, i64 4504
  %sunkaddr60.1.i.i = getelementptr i8, ptr %.49.i, i64 2528
  %scevgep49.1.i.i = getelementptr i8, ptr %.49.i, i64 4512
  %sunkaddr63.1.i.i = getelementptr i8, ptr %.49.i, i64 2536
  %scevgep47.1.i.i = getelementptr i8, ptr %.49.i, i64 4520
  %sunkaddr66.1.i.i = getelementptr i8, ptr %.49.i, i64 2544
  %scevgep45.1.i.i = getelementptr i8, ptr %.49.i, i64 4528
  %sunkaddr69.1.i.i = getelementptr i8, ptr %.49.i, i64 2552
  %scevgep43.1.i.i = getelementptr i8, ptr %.49.i, i64 4536
  %sunkaddr72.1.i.i = getelementptr i8, ptr %.49.i, i64 2560
  %scevgep41.1.i.i = getelementptr i8, ptr %.49.i, i64 4544
  %sunkaddr75.1.i.i = getelementptr i8, ptr %.49.i, i64 2568
  %scevgep39.1.i.i = getelementptr i8, ptr %.49.i, i64 4552
  %sunkaddr78.1.i.i = getelementptr i8, ptr %.49.i, i64 2576
  %scevgep37.1.i.i = getelementptr i8, ptr %.49.i, i64 4560
  %sunkaddr81.1.i.i = getelementptr i8, ptr %.49.i, i64 2584
  %scevgep35.1.i.i = getelementptr i8, ptr %.49.i, i64 4568
  %sunkaddr54.2.i.i = getelementptr i8, ptr %.49.i, i64 2592
  %scevgep53.2.i.i = getelementptr i8, ptr %.49.i, i64 4576
  %sunkaddr57.2.i.i = getelementptr i8, ptr %.49.i, i64 2600
  %scevgep51.2.i.i = getelementptr i8, ptr %.49.i, i64 4584
  %sunkaddr60.2.i.i = getelementptr i8, ptr %.49.i, i64 2608
  %scevgep49.2.i.i = getelementptr i8, ptr %.49.i, i64 4592
  %sunkaddr63.2.i.i = getelementptr i8, ptr %.49.i, i64 2616
  %scevgep47.2.i.i = getelementptr i8, ptr %.49.i, i64 4600
  %sunkaddr66.2.i.i = getelementptr i8, ptr %.49.i, i64 2624
  %scevgep45.2.i.i = getelementptr i8, ptr %.49.i, i64 4608
  %sunkaddr69.2.i.i = getelementptr i8, ptr %.49.i, i64 2632
  %scevgep43.2.i.i = getelementptr i8, ptr %.49.i, i64 4616
  %sunkaddr72.2.i.i = getelementptr i8, ptr %.49.i, i64 2640
  %scevgep41.2.i.i = getelementptr i8, ptr %.49.i, i64 4624
  %sunkaddr75.2.i.i = getelementptr i8, ptr %.49.i, i64 2648
  %scevgep39.2.i.i = getelementptr i8, ptr %.49.i, i64 4632
  %sunkaddr78.2.i.i = getelementptr i8, ptr %.49.i, i64 2656
  %scevgep37.2.i.i = getelementptr i8, ptr %.49.i, i64 4640
  %sunkaddr81.2.i.i = getelementptr i8, ptr %.49.i, i64 2664
  %scevgep35.2.i.i = getelementptr i8, ptr %.49.i, i64 4648
  %sunkaddr54.3.i.i = getelementptr i8, ptr %.49.i, i64 2672
  %scevgep53.3.i.i = getelementptr i8, ptr %.49.i, i64 4656
  %sunkaddr57.3.i.i = getelementptr i8, ptr %.49.i, i64 2680
  %scevgep51.3.i.i = getelementptr i8, ptr %.49.i, i64 4664
  %sunkaddr60.3.i.i = getelementptr i8, ptr %.49.i, i64 2688
  %scevgep49.3.i.i = getelementptr i8, ptr %.49.i, i64 4672
  %sunkaddr63.3.i.i = getelementptr i8, ptr %.49.i, i64 2696
  %scevgep47.3.i.i = getelementptr i8, ptr %.49.i, i64 4680
  %sunkaddr66.3.i.i = getelementptr i8, ptr %.49.i, i64 2704
  %scevgep45.3.i.i = getelementptr i8, ptr %.49.i, i64 4688
  %sunkaddr69.3.i.i = getelementptr i8, ptr %.49.i, i64 2712
  %scevgep43.3.i.i = getelementptr i8, ptr %.49.i, i64 4696
  %sunkaddr72.3.i.i = getelementptr i8, ptr %.49.i, i64 2720
  %scevgep41.3.i.i = getelementptr i8, ptr %.49.i, i64 4704
  %sunkaddr75.3.i.i = getelementptr i8, ptr %.49.i, i64 2728
  %scevgep39.3.i.i = getelementptr i8, ptr %.49.i, i64 4712
  %sunkaddr78.3.i.i = getelementptr i8, ptr %.49.i, i64 2736
  %scevgep37.3.i.i = getelementptr i8, ptr %.49.i, i64 4720
  %sunkaddr81.3.i.i = getelementptr i8, ptr %.49.i, i64 2744
  %scevgep35.3.i.i = getelementptr i8, ptr %.49.i, i64 4728
  %sunkaddr54.4.i.i = getelementptr i8, ptr %.49.i, i64 2752
  %scevgep53.4.i.i = getelementptr i8, ptr %.49.i, i64 4736
  %sunkaddr57.4.i.i = getelementptr i8, ptr %.49.i, i64 2760
  %scevgep51.4.i.i = getelementptr i8, ptr %.49.i, i64 4744
  %sunkaddr60.4.i.i = getelementptr i8, ptr %.49.i, i64 2768
  %scevgep49.4.i.i = getelementptr i8, ptr %.49.i, i64 4752
  %sunkaddr63.4.i.i = getelementptr i8, ptr %.49.i, i64 2776
  %scevgep47.4.i.i = getelementptr i8, ptr %.49.i, i64 4760
  %sunkaddr66.4.i.i = getelementptr i8, ptr %.49.i, i64 2784
  %scevgep45.4.i.i = getelementptr i8, ptr %.49.i, i64 4768
  %sunkaddr69.4.i.i = getelementptr i8, ptr %.49.i, i64 2792
  %scevgep43.4.i.i = getelementptr i8, ptr %.49.i, i64 4776
  %sunkaddr72.4.i.i = getelementptr i8, ptr %.49.i, i64 2800
  %scevgep41.4.i.i = getelementptr i8, ptr %.49.i, i64 4784
  %sunkaddr75.4.i.i = getelementptr i8, ptr %.49.i, i64 2808
  %scevgep39.4.i.i = getelementptr i8, ptr %.49.i, i64 4792
  %sunkaddr78.4.i.i = getelementptr i8, ptr %.49.i, i64 2816
  %scevgep37.4.i.i = getelementptr i8, ptr %.49.i, i64 4800
  %sunkaddr81.4.i.i = getelementptr i8, ptr %.49.i, i64 2824
  %scevgep35.4.i.i = getelementptr i8, ptr %.49.i, i64 4808
  %sunkaddr54.5.i.i = getelementptr i8, ptr %.49.i, i64 2832
  %scevgep53.5.i.i = getelementptr i8, ptr %.49.i, i64 4816
  %sunkaddr57.5.i.i = getelementptr i8, ptr %.49.i, i64 2840
  %scevgep51.5.i.i = getelementptr i8, ptr %.49.i, i64 4824
  %sunkaddr60.5.i.i = getelementptr i8, ptr %.49.i, i64 2848
  %scevgep49.5.i.i = getelementptr i8, ptr %.49.i, i64 4832
  %sunkaddr63.5.i.i = getelementptr i8, ptr %.49.i, i64 2856
  %scevgep47.5.i.i = getelementptr i8, ptr %.49.i, i64 4840
  %sunkaddr66.5.i.i = getelementptr i8, ptr %.49.i, i64 2864
  %scevgep45.5.i.i = getelementptr i8, ptr %.49.i, i64 4848
  %sunkaddr69.5.i.i = getelementptr i8, ptr %.49.i, i64 2872
  %scevgep43.5.i.i = getelementptr i8, ptr %.49.i, i64 4856
  %sunkaddr72.5.i.i = getelementptr i8, ptr %.49.i, i64 2880
  %scevgep41.5.i.i = getelementptr i8, ptr %.49.i, i64 4864
  %sunkaddr75.5.i.i = getelementptr i8, ptr %.49.i, i64 2888
  %scevgep39.5.i.i = getelementptr i8, ptr %.49.i, i64 4872
  %sunkaddr78.5.i.i = getelementptr i8, ptr %.49.i, i64 2896
  %scevgep37.5.i.i = getelementptr i8, ptr %.49.i, i64 4880
  %sunkaddr81.5.i.i = getelementptr i8, ptr %.49.i, i64 2904
  %scevgep35.5.i.i = getelementptr i8, ptr %.49.i, i64 4888
  %sunkaddr54.6.i.i = getelementptr i8, ptr %.49.i, i64 2912
  %scevgep53.6.i.i = getelementptr i8, ptr %.49.i, i64 4896
  %sunkaddr57.6.i.i = getelementptr i8, ptr %.49.i, i64 2920
  %scevgep51.6.i.i = getelementptr i8, ptr %.49.i, i64 4904
  %sunkaddr60.6.i.i = getelementptr i8, ptr %.49.i, i64 2928
  %scevgep49.6.i.i = getelementptr i8, ptr %.49.i, i64 4912
  %sunkaddr63.6.i.i = getelementptr i8, ptr %.49.i, i64 2936
  %scevgep47.6.i.i = getelementptr i8, ptr %.49.i, i64 4920
  %sunkaddr66.6.i.i = getelementptr i8, ptr %.49.i, i64 2944
  %scevgep45.6.i.i = getelementptr i8, ptr %.49.i, i64 4928
  %sunkaddr69.6.i.i = getelementptr i8, ptr %.49.i, i64 2952
  %scevgep43.6.i.i = getelementptr i8, ptr %.49.i, i64 4936
  %sunkaddr72.6.i.i = getelementptr i8, ptr %.49.i, i64 2960
  %scevgep41.6.i.i = getelementptr i8, ptr %.49.i, i64 4944
  %sunkaddr75.6.i.i = getelementptr i8, ptr %.49.i, i64 2968
  %scevgep39.6.i.i = getelementptr i8, ptr %.49.i, i64 4952
  %sunkaddr78.6.i.i = getelementptr i8, ptr %.49.i, i64 2976
  %scevgep37.6.i.i = getelementptr i8, ptr %.49.i, i64 4960
  %sunkaddr81.6.i.i = getelementptr i8, ptr %.49.i, i64 2984
  %scevgep35.6.i.i = getelementptr i8, ptr %.49.i, i64 4968
  %sunkaddr54.7.i.i = getelementptr i8, ptr %.49.i, i64 2992
  %scevgep53.7.i.i = getelementptr i8, ptr %.49.i, i64 4976
  %sunkaddr57.7.i.i = getelementptr i8, ptr %.49.i, i64 3000
  %scevgep51.7.i.i = getelementptr i8, ptr %.49.i, i64 4984
  %sunkaddr60.7.i.i = getelementptr i8, ptr %.49.i, i64 3008
  %scevgep49.7.i.i = getelementptr i8, ptr %.49.i, i64 4992
  %sunkaddr63.7.i.i = getelementptr i8, ptr %.49.i, i64 3016
  %scevgep47.7.i.i = getelementptr i8, ptr %.49.i, i64 5000
  %sunkaddr66.7.i.i = getelementptr i8, ptr %.49.i, i64 3024
  %scevgep45.7.i.i = getelementptr i8, ptr %.49.i, i64 5008
  %sunkaddr69.7.i.i = getelementptr i8, ptr %.49.i, i64 3032
  %scevgep43.7.i.i = getelementptr i8, ptr %.49.i, i64 5016
  %sunkaddr72.7.i.i = getelementptr i8, ptr %.49.i, i64 3040
  %scevgep41.7.i.i = getelementptr i8, ptr %.49.i, i64 5024
  %sunkaddr75.7.i.i = getelementptr i8, ptr %.49.i, i64 3048
  %scevgep39.7.i.i = getelementptr i8, ptr %.49.i, i64 5032
  %sunkaddr78.7.i.i = getelementptr i8, ptr %.49.i, i64 3056
  %scevgep37.7.i.i = getelementptr i8, ptr %.49.i, i64 5040
  %sunkaddr81.7.i.i = getelementptr i8, ptr %.49.i, i64 3064
  %scevgep35.7.i.i = getelementptr i8, ptr %.49.i, i64 5048
  %.171.i.i = getelementptr inbounds nuw i8, ptr %.49.i, i64 3520
  %.234.i.i = getelementptr inbounds nuw i8, ptr %.49.i, i64 3968
  %.391.i.i = getelementptr inbounds nuw i8, ptr %.49.i, i64 5056
  %.474.i.i = getelementptr i8, ptr %.49.i, i64 5696
  %.539.i.i = getelementptr i8, ptr %.49.i, i64 6336
  %.1068.i.i = getelementptr inbounds nuw i8, ptr %.49.i, i64 128
  %.801.i.i.i = getelementptr inbounds nuw i8, ptr %.49.i, i64 3136
  %.835.i.i10.i = getelementptr inbounds nuw i8, ptr %.49.i, i64 3200
  %.845.i.i.i = getelementptr inbounds nuw i8, ptr %.49.i, i64 64
  %.879.i.i.i = getelementptr inbounds nuw i8, ptr %.49.i, i64 704
  %.914.i.i.i = getelementptr inbounds nuw i8, ptr %.49.i, i64 192
  %.1443.i.i.i = getelementptr inbounds nuw i8, ptr %.49.i, i64 3264
  %.1453.i.i.i = getelementptr inbounds nuw i8, ptr %.49.i, i64 3328
  %.1464.i.i.i = getelementptr inbounds nuw i8, ptr %.49.i, i64 448
  %.1996.i.i.i = getelementptr inbounds nuw i8, ptr %.49.i, i64 3392
  %.2006.i.i.i = getelementptr inbounds nuw i8, ptr %.49.i, i64 3456
  %.1336.i.i = getelementptr inbounds nuw i8, ptr %.49.i, i64 5440
  %.1336.1.i.i = getelementptr inbounds nuw i8, ptr %.49.i, i64 5504
  %.1336.2.i.i = getelementptr inbounds nuw i8, ptr %.49.i, i64 5568
  %.1336.3.i.i = getelementptr inbounds nuw i8, ptr %.49.i, i64 5632
  %9 = getelementptr i8, ptr %1, i64 8
  %10 = getelementptr i8, ptr %1, i64 24
  %11 = getelementptr i8, ptr %1, i64 40
  %12 = getelementptr i8, ptr %1, i64 56
  %13 = getelementptr i8, ptr %1, i64 72
  %14 = getelementptr i8, ptr %1, i64 88
  %15 = getelementptr i8, ptr %1, i64 104
  %16 = getelementptr i8, ptr %1, i64 120
  %sunkaddr.i12.i = getelementptr inbounds nuw i8, ptr %.49.i, i64 6976
  %sunkaddr24.i.i = getelementptr i8, ptr %.49.i, i64 6984
  %sunkaddr26.i.i = getelementptr i8, ptr %.49.i, i64 6992
  %sunkaddr28.i.i = getelementptr i8, ptr %.49.i, i64 7000
  %sunkaddr30.i.i = getelementptr i8, ptr %.49.i, i64 7008
  %sunkaddr32.i.i = getelementptr i8, ptr %.49.i, i64 7016
  %sunkaddr34.i.i = getelementptr i8, ptr %.49.i, i64 7024
  %sunkaddr36.i.i = getelementptr i8, ptr %.49.i, i64 7032
  %sunkaddr38.i.i = getelementptr inbounds nuw i8, ptr %.49.i, i64 3584
  %sunkaddr39.i.i = getelementptr inbounds nuw i8, ptr %.49.i, i64 3648
  %sunkaddr43.i.i = getelementptr inbounds nuw i8, ptr %.49.i, i64 3712
  %sunkaddr44.i.i = getelementptr inbounds nuw i8, ptr %.49.i, i64 3776
  %sunkaddr46.i.i = getelementptr inbounds nuw i8, ptr %.49.i, i64 3840
  %sunkaddr47.i.i = getelementptr inbounds nuw i8, ptr %.49.i, i64 3904
  %sunkaddr49.i.i = getelementptr inbounds nuw i8, ptr %.49.i, i64 4032
  %sunkaddr50.i.i = getelementptr inbounds nuw i8, ptr %.49.i, i64 4096
  %sunkaddr51.i.i = getelementptr inbounds nuw i8, ptr %.49.i, i64 4160
  %sunkaddr52.i.i = getelementptr inbounds nuw i8, ptr %.49.i, i64 4224
  %sunkaddr53.i.i = getelementptr inbounds nuw i8, ptr %.49.i, i64 4288
  %sunkaddr54.i.i = getelementptr inbounds nuw i8, ptr %.49.i, i64 4352
  %17 = inttoptr i64 %.510.i to ptr
  %.87.i.i = getelementptr i8, ptr %arg.arguments, i64 8
  %.117.i.i = getelementptr i8, ptr %arg.arguments, i64 24
  %.557.i.i = getelementptr i8, ptr %.49.i, i64 16064
  %.641.i.i = getelementptr i8, ptr %.49.i, i64 24512
  %.242.i.i = getelementptr i8, ptr %arg.arguments, i64 32
  %.420.i.i = getelementptr i8, ptr %arg.arguments, i64 112
  %.328.i.i = getelementptr i8, ptr %arg.arguments, i64 104
  %.154.i.i = getelementptr i8, ptr %arg.arguments, i64 16
  %.368.i.i.i = getelementptr i8, ptr %arg.arguments, i64 40
  %.160.i.i.i = getelementptr i8, ptr %arg.arguments, i64 48
  br label %B642.if.i

B1342.i:                                          ; preds = %_ZN17bnserve_surrogate10precession7_source4_rowB4v108B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIxLi1E1C7mutable7alignedEddd5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE.exit.i, %_ZN17bnserve_surrogate10precession9_dynamics6followB3v88B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIxLi1E1C7mutable7alignedE23Literal_5bint_5d_281_295ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx.exit.i
  %.733.i = icmp sgt i64 %.732765800.i, 1
  br i1 %.733.i, label %B642.if.i, label %_ZN17bnserve_surrogate10precession7_source5twistB2v3B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIxLi1E1C7mutable7alignedE.exit

B642.if.i:                                        ; preds = %B1342.i, %B642.if.preheader.i
  %.732765800.i = phi i64 [ %.742.i, %B1342.i ], [ %.712.i, %B642.if.preheader.i ]
  %.739772799.i = phi i64 [ %.746.i, %B1342.i ], [ 0, %B642.if.preheader.i ]
  %.93.i.i = load i64, ptr %.509.i, align 8, !noalias !3
  %.181.i.i = load i64, ptr %.180.i.i, align 8, !noalias !3
  %.267.i.i = load i64, ptr %.266.i.i, align 8, !noalias !3
  %.268.i.i = inttoptr i64 %.267.i.i to ptr
  %.344.i.i = load double, ptr %.268.i.i, align 8, !noalias !3
  %.380.i.i = load i64, ptr %.379.i.i, align 8, !noalias !3
  %18 = inttoptr i64 %.181.i.i to ptr
  %19 = inttoptr i64 %.93.i.i to ptr
  %20 = inttoptr i64 %.380.i.i to ptr
  br label %B348.if.i.i

B348.if.i.i:                                      ; preds = %B348.if.i.i, %B642.if.i
  %lsr.iv149.i.i = phi i64 [ %.739772799.i, %B642.if.i ], [ %lsr.iv.next150.i.i, %B348.if.i.i ]
  %lsr.iv.i1.i = phi i64 [ 0, %B642.if.i ], [ %lsr.iv.next.i2.i, %B348.if.i.i ]
  %back.2.0601.i.i = phi i64 [ 0, %B642.if.i ], [ %.13.i75.i.i, %B348.if.i.i ]
  %ahead.2.0600.i.i = phi i64 [ 0, %B642.if.i ], [ %.13.i74.i.i, %B348.if.i.i ]
  %.13.i.i.i = tail call i64 @llvm.smin.i64(i64 %.566.i.i, i64 %lsr.iv149.i.i)
  %.607.idx.i.i = mul nsw i64 %.13.i.i.i, 80
  %.607.i.i = getelementptr inbounds i8, ptr %19, i64 %.607.idx.i.i
  %.670.idx.i.i = shl nsw i64 %.13.i.i.i, 5
  %.670.i.i = getelementptr inbounds i8, ptr %18, i64 %.670.idx.i.i
  %scevgep148.i.i = getelementptr i8, ptr %.49.i, i64 %lsr.iv.i1.i
  %scevgep147.i.i = getelementptr i8, ptr %.171.i, i64 %lsr.iv.i1.i
  %.81.i.i.i = load double, ptr %.607.i.i, align 8, !noalias !6
  %.82.i.i.i = fadd contract double %.81.i.i.i, 1.000000e+00
  %.86.i.i.i = fdiv contract double %.81.i.i.i, %.82.i.i.i
  %.87.i.i.i = fsub contract double 1.000000e+00, %.86.i.i.i
  %.30.i.i.i.i = fmul contract double %.86.i.i.i, %.87.i.i.i
  %.31.i.i.i.i = fsub contract double %.86.i.i.i, %.87.i.i.i
  %.35.i.i.i.i = fdiv contract double %.30.i.i.i.i, 2.400000e+01
  %.36.i.i.i.i = fsub contract double 1.250000e+00, %.35.i.i.i.i
  %.37.i.i.i.i = fmul contract double %.30.i.i.i.i, %.36.i.i.i.i
  %.38.i.i.i.i = fadd contract double %.37.i.i.i.i, 5.625000e-01
  %.39.i.i.i.i = fmul contract double %.30.i.i.i.i, 6.250000e-01
  %.40.i.i.i.i = fadd contract double %.39.i.i.i.i, -5.625000e-01
  %.44.i.i.i.i = fdiv contract double %.30.i.i.i.i, 4.800000e+01
  %.45.i.i.i.i = fadd contract double %.44.i.i.i.i, 3.281250e+00
  %.46.i.i.i.i = fmul contract double %.30.i.i.i.i, %.45.i.i.i.i
  %.47.i.i.i.i = fsub contract double 1.875000e-01, %.46.i.i.i.i
  %.48.i.i.i.i = fmul contract double %.30.i.i.i.i, %.47.i.i.i.i
  %.49.i.i.i.i = fadd contract double %.48.i.i.i.i, 8.437500e-01
  %.50.i.i.i.i = fmul contract double %.30.i.i.i.i, 1.562500e-01
  %.51.i.i.i.i = fsub contract double 4.875000e+00, %.50.i.i.i.i
  %.52.i.i.i.i = fmul contract double %.30.i.i.i.i, %.51.i.i.i.i
  %.53.i.i.i.i = fadd contract double %.52.i.i.i.i, -8.437500e-01
  %.54.i.i.i.i = fmul contract double %.30.i.i.i.i, 2.000000e+00
  %.55.i.i.i.i = fmul contract double %.87.i.i.i, 1.500000e+00
  %.56.i.i.i.i = fmul contract double %.87.i.i.i, %.55.i.i.i.i
  %.57.i.i.i.i = fadd contract double %.54.i.i.i.i, %.56.i.i.i.i
  %.59.i.i.i.i = fmul contract double %.86.i.i.i, 1.500000e+00
  %.60.i.i.i.i = fmul contract double %.86.i.i.i, %.59.i.i.i.i
  %.61.i.i.i.i = fadd contract double %.60.i.i.i.i, %.54.i.i.i.i
  %.90.i.i.i.i = getelementptr i8, ptr %scevgep148.i.i, i64 192
  store double %.57.i.i.i.i, ptr %.90.i.i.i.i, align 8, !noalias !9
  %.120.i.i.i.i = getelementptr i8, ptr %scevgep148.i.i, i64 448
  store double %.61.i.i.i.i, ptr %.120.i.i.i.i, align 8, !noalias !9
  %.122.i.i.i.i = fmul contract double %.31.i.i.i.i, %.40.i.i.i.i
  %.123.i.i.i.i = fadd contract double %.122.i.i.i.i, %.38.i.i.i.i
  %.152.i.i.i.i = getelementptr i8, ptr %scevgep148.i.i, i64 256
  store double %.123.i.i.i.i, ptr %.152.i.i.i.i, align 8, !noalias !9
  %.155.i.i.i.i = fsub contract double %.38.i.i.i.i, %.122.i.i.i.i
  %.184.i.i.i.i = getelementptr i8, ptr %scevgep148.i.i, i64 512
  store double %.155.i.i.i.i, ptr %.184.i.i.i.i, align 8, !noalias !9
  %.186.i.i.i.i = fmul contract double %.31.i.i.i.i, %.53.i.i.i.i
  %.187.i.i.i.i = fadd contract double %.186.i.i.i.i, %.49.i.i.i.i
  %.216.i.i.i.i = getelementptr i8, ptr %scevgep148.i.i, i64 320
  store double %.187.i.i.i.i, ptr %.216.i.i.i.i, align 8, !noalias !9
  %.219.i.i.i.i = fsub contract double %.49.i.i.i.i, %.186.i.i.i.i
  %.248.i.i.i.i = getelementptr i8, ptr %scevgep148.i.i, i64 576
  store double %.219.i.i.i.i, ptr %.248.i.i.i.i, align 8, !noalias !9
  %.277.i.i.i.i = getelementptr i8, ptr %.607.i.i, i64 8
  %.278.i.i.i.i = load double, ptr %.277.i.i.i.i, align 8, !noalias !9
  %.15.le.i.i.i.i.i = fcmp contract uno double %.278.i.i.i.i, 0.000000e+00
  %.17.le.i.i.i.i.i = fcmp contract oge double %.278.i.i.i.i, 1.000000e+00
  %21 = or i1 %.15.le.i.i.i.i.i, %.17.le.i.i.i.i.i
  %22 = tail call contract double @llvm.log.f64(double %.278.i.i.i.i)
  %.31.le.i.i.i.i.i = select i1 %21, double %22, double 0.000000e+00
  %.5.i.i.i.i.i.i = fmul contract double %.31.le.i.i.i.i.i, 1.230000e-04
  %.6.i.i.i.i.i.i = fadd contract double %.5.i.i.i.i.i.i, -4.210000e-03
  %.7.i.i.i.i.i.i = fmul contract double %.31.le.i.i.i.i.i, %.6.i.i.i.i.i.i
  %.8.i.i.i.i.i.i = fadd contract double %.7.i.i.i.i.i.i, 4.740000e-02
  %.9.i.i.i.i.i.i = fmul contract double %.31.le.i.i.i.i.i, %.8.i.i.i.i.i.i
  %.10.i.i.i.i.i.i = fadd contract double %.9.i.i.i.i.i.i, 9.360000e-02
  %.11.i.i.i.i.i.i = fmul contract double %.31.le.i.i.i.i.i, %.10.i.i.i.i.i.i
  %.12.i.i.i.i.i.i = fadd contract double %.11.i.i.i.i.i.i, 1.940000e-01
  %.62.i.i.i.i.i = fcmp contract ogt double %.278.i.i.i.i, 1.000000e+00
  %.64.i.i.i.i.i = uitofp i1 %.62.i.i.i.i.i to double
  %.65.i.i.i.i.i = fmul contract double %.12.i.i.i.i.i.i, %.64.i.i.i.i.i
  %.73.le.i.i.i.i.i = tail call contract double @llvm.exp.f64(double %.65.i.i.i.i.i)
  %.305.i.i.i.i = fmul contract double %.87.i.i.i, %.73.le.i.i.i.i.i
  %.309.i.i.i.i = fdiv contract double %.305.i.i.i.i, %.86.i.i.i
  %.338.i.i.i.i = getelementptr i8, ptr %scevgep148.i.i, i64 384
  store double %.309.i.i.i.i, ptr %.338.i.i.i.i, align 8, !noalias !9
  %.367.i.i.i.i = getelementptr i8, ptr %.607.i.i, i64 16
  %.368.i.i.i.i = load double, ptr %.367.i.i.i.i, align 8, !noalias !9
  %.15.le.i1.i.i.i.i = fcmp contract uno double %.368.i.i.i.i, 0.000000e+00
  %.17.le.i2.i.i.i.i = fcmp contract oge double %.368.i.i.i.i, 1.000000e+00
  %23 = or i1 %.15.le.i1.i.i.i.i, %.17.le.i2.i.i.i.i
  %24 = tail call contract double @llvm.log.f64(double %.368.i.i.i.i)
  %.31.le.i3.i.i.i.i = select i1 %23, double %24, double 0.000000e+00
  %.5.i.i4.i.i.i.i = fmul contract double %.31.le.i3.i.i.i.i, 1.230000e-04
  %.6.i.i5.i.i.i.i = fadd contract double %.5.i.i4.i.i.i.i, -4.210000e-03
  %.7.i.i6.i.i.i.i = fmul contract double %.31.le.i3.i.i.i.i, %.6.i.i5.i.i.i.i
  %.8.i.i7.i.i.i.i = fadd contract double %.7.i.i6.i.i.i.i, 4.740000e-02
  %.9.i.i8.i.i.i.i = fmul contract double %.31.le.i3.i.i.i.i, %.8.i.i7.i.i.i.i
  %.10.i.i9.i.i.i.i = fadd contract double %.9.i.i8.i.i.i.i, 9.360000e-02
  %.11.i.i10.i.i.i.i = fmul contract double %.31.le.i3.i.i.i.i, %.10.i.i9.i.i.i.i
  %.12.i.i11.i.i.i.i = fadd contract double %.11.i.i10.i.i.i.i, 1.940000e-01
  %.62.i12.i.i.i.i = fcmp contract ogt double %.368.i.i.i.i, 1.000000e+00
  %.64.i13.i.i.i.i = uitofp i1 %.62.i12.i.i.i.i to double
  %.65.i14.i.i.i.i = fmul contract double %.12.i.i11.i.i.i.i, %.64.i13.i.i.i.i
  %.73.le.i15.i.i.i.i = tail call contract double @llvm.exp.f64(double %.65.i14.i.i.i.i)
  %.396.i.i.i.i = fmul contract double %.86.i.i.i, %.73.le.i15.i.i.i.i
  %.400.i.i.i.i = fdiv contract double %.396.i.i.i.i, %.87.i.i.i
  %.429.i.i.i.i = getelementptr i8, ptr %scevgep148.i.i, i64 640
  store double %.400.i.i.i.i, ptr %.429.i.i.i.i, align 8, !noalias !9
  %.431.i.i.i.i = fmul contract double %.30.i.i.i.i, 9.600000e+01
  %.435.i.i.i.i = fdiv contract double 5.000000e+00, %.431.i.i.i.i
  %.464.i.i.i.i = getelementptr i8, ptr %scevgep148.i.i, i64 704
  store double %.435.i.i.i.i, ptr %.464.i.i.i.i, align 8, !noalias !9
  %.47.i1.i.i.i = getelementptr i8, ptr %scevgep148.i.i, i64 768
  store double %.30.i.i.i.i, ptr %.47.i1.i.i.i, align 8, !noalias !12
  %.52.i2.i.i.i = fdiv contract double %.30.i.i.i.i, 6.000000e+00
  %.53.i3.i.i.i = fadd contract double %.52.i2.i.i.i, 1.500000e+00
  %.82.i.i.i.i = getelementptr i8, ptr %scevgep148.i.i, i64 832
  store double %.53.i3.i.i.i, ptr %.82.i.i.i.i, align 8, !noalias !12
  %.88.i.i.i.i = fadd contract double %.35.i.i.i.i, -2.375000e+00
  %.89.i.i.i.i = fmul contract double %.30.i.i.i.i, %.88.i.i.i.i
  %.90.i4.i.i.i = fadd contract double %.89.i.i.i.i, 3.375000e+00
  %.119.i.i.i.i = getelementptr i8, ptr %scevgep148.i.i, i64 896
  store double %.90.i4.i.i.i, ptr %.119.i.i.i.i, align 8, !noalias !12
  %.124.i.i.i.i = fdiv contract double 1.000000e+00, %.86.i.i.i
  %.125.i.i.i.i = fadd contract double %.124.i.i.i.i, 3.000000e+00
  %.126.i.i.i.i = fmul contract double %.125.i.i.i.i, -2.500000e-01
  %.130.i.i.i.i = fdiv contract double 1.000000e+00, %.87.i.i.i
  %.131.i.i.i.i = fadd contract double %.130.i.i.i.i, 3.000000e+00
  %.132.i.i.i.i = fmul contract double %.131.i.i.i.i, -2.500000e-01
  %.161.i.i.i.i = getelementptr i8, ptr %scevgep148.i.i, i64 960
  store double %.126.i.i.i.i, ptr %.161.i.i.i.i, align 8, !noalias !12
  %.191.i.i.i.i = getelementptr i8, ptr %scevgep148.i.i, i64 1024
  store double %.132.i.i.i.i, ptr %.191.i.i.i.i, align 8, !noalias !12
  %.196.i.i.i.i = fdiv contract double 2.700000e+01, %.86.i.i.i
  %.197.i.i.i.i = fadd contract double %.196.i.i.i.i, 1.000000e+00
  %.202.i.i.i.i = fdiv contract double %.197.i.i.i.i, -1.200000e+01
  %.231.i.i.i.i = getelementptr i8, ptr %scevgep148.i.i, i64 1088
  store double %.202.i.i.i.i, ptr %.231.i.i.i.i, align 8, !noalias !12
  %.236.i.i.i.i = fdiv contract double 2.700000e+01, %.87.i.i.i
  %.237.i.i.i.i = fadd contract double %.236.i.i.i.i, 1.000000e+00
  %.242.i.i.i.i = fdiv contract double %.237.i.i.i.i, -1.200000e+01
  %.271.i.i.i.i = getelementptr i8, ptr %scevgep148.i.i, i64 1152
  store double %.242.i.i.i.i, ptr %.271.i.i.i.i, align 8, !noalias !12
  %.146.i.i.i = fmul contract double %.86.i.i.i, %.86.i.i.i
  %.147.i.i.i = fmul contract double %.87.i.i.i, %.87.i.i.i
  %.175.i.i.i = getelementptr i8, ptr %.607.i.i, i64 64
  %.176.i.i.i = load double, ptr %.175.i.i.i, align 8, !noalias !6
  %.177.i.i.i = fmul contract double %.176.i.i.i, 5.000000e-01
  %.185.le.i.i.i = tail call contract double @llvm.sin.f64(double %.177.i.i.i)
  %.197.le.i.i.i = tail call contract double @llvm.cos.f64(double %.177.i.i.i)
  %.229.i.i.i = getelementptr i8, ptr %.670.i.i, i64 8
  %.230.i.i.i = load double, ptr %.229.i.i.i, align 8, !noalias !6
  %.231.i.i.i = fmul contract double %.230.i.i.i, %.197.le.i.i.i
  %.260.i.i.i = load double, ptr %.670.i.i, align 8, !noalias !6
  %.261.i.i.i = fmul contract double %.185.le.i.i.i, %.260.i.i.i
  %.262.i.i.i = fadd contract double %.231.i.i.i, %.261.i.i.i
  %.263.i.i.i = fmul contract double %.146.i.i.i, %.262.i.i.i
  store double %.263.i.i.i, ptr %scevgep147.i.i, align 8, !noalias !6
  %.322.i.i.i = load double, ptr %.229.i.i.i, align 8, !noalias !6
  %.323.i.i.i = fmul contract double %.185.le.i.i.i, %.322.i.i.i
  %.352.i.i.i = load double, ptr %.670.i.i, align 8, !noalias !6
  %.353.i.i.i = fmul contract double %.197.le.i.i.i, %.352.i.i.i
  %.354.i.i.i = fsub contract double %.323.i.i.i, %.353.i.i.i
  %.355.i.i.i = fmul contract double %.146.i.i.i, %.354.i.i.i
  %.384.i.i.i = getelementptr i8, ptr %scevgep147.i.i, i64 64
  store double %.355.i.i.i, ptr %.384.i.i.i, align 8, !noalias !6
  %.413.i.i.i = getelementptr i8, ptr %.607.i.i, i64 24
  %.414.i.i.i = load double, ptr %.413.i.i.i, align 8, !noalias !6
  %.415.i.i.i = fmul contract double %.146.i.i.i, %.414.i.i.i
  %.444.i.i.i = getelementptr i8, ptr %scevgep147.i.i, i64 128
  store double %.415.i.i.i, ptr %.444.i.i.i, align 8, !noalias !6
  %.473.i.i.i = getelementptr i8, ptr %.670.i.i, i64 24
  %.474.i.i.i = load double, ptr %.473.i.i.i, align 8, !noalias !6
  %.475.i.i.i = fmul contract double %.197.le.i.i.i, %.474.i.i.i
  %.503.i.i.i = getelementptr i8, ptr %.670.i.i, i64 16
  %.504.i.i.i = load double, ptr %.503.i.i.i, align 8, !noalias !6
  %.505.i.i.i = fmul contract double %.185.le.i.i.i, %.504.i.i.i
  %.506.i.i.i = fadd contract double %.475.i.i.i, %.505.i.i.i
  %.507.i.i.i = fmul contract double %.147.i.i.i, %.506.i.i.i
  %.536.i.i.i = getelementptr i8, ptr %scevgep147.i.i, i64 192
  store double %.507.i.i.i, ptr %.536.i.i.i, align 8, !noalias !6
  %.566.i.i.i = load double, ptr %.473.i.i.i, align 8, !noalias !6
  %.567.i.i.i = fmul contract double %.185.le.i.i.i, %.566.i.i.i
  %.596.i.i.i = load double, ptr %.503.i.i.i, align 8, !noalias !6
  %.600.i.i.i = fmul contract double %.197.le.i.i.i, %.596.i.i.i
  %.601.i.i.i = fsub contract double %.567.i.i.i, %.600.i.i.i
  %.602.i.i.i = fmul contract double %.147.i.i.i, %.601.i.i.i
  %.631.i.i.i = getelementptr i8, ptr %scevgep147.i.i, i64 256
  store double %.602.i.i.i, ptr %.631.i.i.i, align 8, !noalias !6
  %.660.i.i.i = getelementptr i8, ptr %.607.i.i, i64 32
  %.661.i.i.i = load double, ptr %.660.i.i.i, align 8, !noalias !6
  %.662.i.i.i = fmul contract double %.147.i.i.i, %.661.i.i.i
  %.691.i.i.i = getelementptr i8, ptr %scevgep147.i.i, i64 320
  store double %.662.i.i.i, ptr %.691.i.i.i, align 8, !noalias !6
  %.720.i.i.i = getelementptr i8, ptr %.607.i.i, i64 48
  %.721.i.i.i = load double, ptr %.720.i.i.i, align 8, !noalias !6
  %.722.i.i.i = fmul contract double %.721.i.i.i, 5.000000e-01
  %.730.le.i.i.i = tail call contract double @llvm.cos.f64(double %.722.i.i.i)
  %.763.i.i.i = getelementptr i8, ptr %scevgep147.i.i, i64 384
  store double %.730.le.i.i.i, ptr %.763.i.i.i, align 8, !noalias !6
  %.793.i.i.i = getelementptr i8, ptr %scevgep147.i.i, i64 448
  store double 0.000000e+00, ptr %.793.i.i.i, align 8, !noalias !6
  %.802.le.i.i.i = tail call contract double @llvm.sin.f64(double %.722.i.i.i)
  %.835.i.i.i = getelementptr i8, ptr %scevgep147.i.i, i64 512
  store double %.802.le.i.i.i, ptr %.835.i.i.i, align 8, !noalias !6
  %.865.i.i.i = getelementptr i8, ptr %scevgep147.i.i, i64 576
  store double 0.000000e+00, ptr %.865.i.i.i, align 8, !noalias !6
  %.19.i.i.i.i = fmul contract double %.30.i.i.i.i, 2.750000e+00
  %.20.i.i.i.i = fsub contract double 0xC001B0C30C30C30C, %.19.i.i.i.i
  %.49.i6.i.i.i = getelementptr i8, ptr %scevgep148.i.i, i64 1216
  store double %.20.i.i.i.i, ptr %.49.i6.i.i.i, align 8, !noalias !15
  %.80.i.i.i.i = getelementptr i8, ptr %scevgep148.i.i, i64 1280
  store double 0x402921FB54442D18, ptr %.80.i.i.i.i, align 8, !noalias !15
  %.82.i7.i.i.i = fmul contract double %.30.i.i.i.i, 0x400A38E38E38E38E
  %.83.i.i.i.i = fadd contract double %.82.i7.i.i.i, 0x401B1AEBAEBAEBAF
  %.84.i.i.i.i = fmul contract double %.30.i.i.i.i, %.83.i.i.i.i
  %.85.i.i.i.i = fadd contract double %.84.i.i.i.i, 0x3FFE12BCBA0483D6
  %.114.i.i.i.i = getelementptr i8, ptr %scevgep148.i.i, i64 1344
  store double %.85.i.i.i.i, ptr %.114.i.i.i.i, align 8, !noalias !15
  %.117.i.i.i.i = fmul contract double %.30.i.i.i.i, 2.362500e+01
  %.118.i.i.i.i = fadd contract double %.117.i.i.i.i, 0x4018C18618618618
  %.119.i8.i.i.i = fmul contract double %.118.i.i.i.i, 0xC00921FB54442D18
  %.148.i.i.i.i = getelementptr i8, ptr %scevgep148.i.i, i64 1408
  store double %.119.i8.i.i.i, ptr %.148.i.i.i.i, align 8, !noalias !15
  %.171.i.i.i.i = fmul contract double %.30.i.i.i.i, 0x40014CA4587E6B75
  %.172.i.i.i.i = fsub contract double 0x3FE3524924924925, %.171.i.i.i.i
  %.173.i.i.i.i = fmul contract double %.30.i.i.i.i, %.172.i.i.i.i
  %.174.i.i.i.i = fadd contract double %.173.i.i.i.i, 0xC064AC31836842E2
  %.175.i.i.i.i = fmul contract double %.30.i.i.i.i, %.174.i.i.i.i
  %.176.i.i.i.i = fadd contract double %.175.i.i.i.i, 0x40614B2B93D74CB8
  %.205.i.i.i.i = getelementptr i8, ptr %scevgep148.i.i, i64 1472
  store double %.176.i.i.i.i, ptr %.205.i.i.i.i, align 8, !noalias !15
  %.207.i.i.i.i = fmul contract double %.30.i.i.i.i, 0x404E419BC466F11A
  %.208.i.i.i.i = fadd contract double %.207.i.i.i.i, 0x404DA7015AC056B0
  %.209.i.i.i.i = fmul contract double %.30.i.i.i.i, %.208.i.i.i.i
  %.210.i.i.i.i = fadd contract double %.209.i.i.i.i, 0xBFF1851451451451
  %.211.i.i.i.i = fmul contract double %.210.i.i.i.i, 0x400921FB54442D18
  %.240.i.i.i.i = getelementptr i8, ptr %scevgep148.i.i, i64 1536
  store double %.211.i.i.i.i, ptr %.240.i.i.i.i, align 8, !noalias !15
  %.90.i3.i.i.i = fmul contract double %.86.i.i.i, %.309.i.i.i.i
  %.95.i.i.i.i = fdiv contract double %.90.i3.i.i.i, %.87.i.i.i
  %.128.i.i.i.i = fmul contract double %.87.i.i.i, %.400.i.i.i.i
  %.133.i.i.i.i = fdiv contract double %.128.i.i.i.i, %.86.i.i.i
  %.141.i.i.i.i = fmul contract double %.30.i.i.i.i, 0x4048255555555555
  %.142.i.i.i.i = fsub contract double 0x403F120820820821, %.141.i.i.i.i
  %.144.i.i.i.i = fmul contract double %.30.i.i.i.i, 3.512500e+01
  %.145.i.i.i.i = fsub contract double 0x4023430C30C30C31, %.144.i.i.i.i
  %.153.i.i.i.i = fmul contract double %.30.i.i.i.i, 0x405CF0D097B425ED
  %.154.i.i.i.i = fadd contract double %.153.i.i.i.i, 0xC078AE0208208208
  %.156.i.i.i.i = fmul contract double %.30.i.i.i.i, %.154.i.i.i.i
  %.157.i.i.i.i = fadd contract double %.156.i.i.i.i, 0x40658C66F119BC46
  %.162.i.i.i.i = fmul contract double %.30.i.i.i.i, 0x4056AE0000000000
  %.163.i.i.i.i = fadd contract double %.162.i.i.i.i, 0xC06FDF75D75D75D7
  %.165.i.i.i.i = fmul contract double %.30.i.i.i.i, %.163.i.i.i.i
  %.166.i.i.i.i = fadd contract double %.165.i.i.i.i, 0x405079D844A0BBD3
  %.310.i.i.i.i = fdiv contract double %.86.i.i.i, %.87.i.i.i
  %.300.i.i.i.i = fdiv contract double %.87.i.i.i, %.86.i.i.i
  %.317.i.i.i.i = fmul contract double %.300.i.i.i.i, 6.250000e+00
  %.318.i.i.i.i = fadd contract double %.317.i.i.i.i, 0x4022D55555555555
  %.319.i.i.i.i = fneg contract double %.318.i.i.i.i
  %25 = getelementptr i8, ptr %scevgep148.i.i, i64 1664
  store double %.319.i.i.i.i, ptr %25, align 8, !noalias !18
  %.355.i.i.i.i = fmul contract double %.300.i.i.i.i, %.145.i.i.i.i
  %.357.i.i.i.i = fadd contract double %.142.i.i.i.i, %.355.i.i.i.i
  %.358.i.i.i.i = fneg contract double %.357.i.i.i.i
  %26 = getelementptr i8, ptr %scevgep148.i.i, i64 1728
  store double %.358.i.i.i.i, ptr %26, align 8, !noalias !18
  %.394.i.i.i.i = fmul contract double %.300.i.i.i.i, 0x40392AAAAAAAAAAB
  %.395.i.i.i.i = fadd contract double %.394.i.i.i.i, 3.750000e+01
  %.396.i6.i.i.i = fmul contract double %.395.i.i.i.i, 0xC00921FB54442D18
  %27 = getelementptr i8, ptr %scevgep148.i.i, i64 1792
  store double %.396.i6.i.i.i, ptr %27, align 8, !noalias !18
  %.432.i.i.i.i = fmul contract double %.300.i.i.i.i, %.166.i.i.i.i
  %.434.i.i.i.i = fadd contract double %.157.i.i.i.i, %.432.i.i.i.i
  %.435.i7.i.i.i = fneg contract double %.434.i.i.i.i
  %28 = getelementptr i8, ptr %scevgep148.i.i, i64 1856
  store double %.435.i7.i.i.i, ptr %28, align 8, !noalias !18
  %.317.1.i.i.i.i = fmul contract double %.310.i.i.i.i, 6.250000e+00
  %.318.1.i.i.i.i = fadd contract double %.317.1.i.i.i.i, 0x4022D55555555555
  %.319.1.i.i.i.i = fneg contract double %.318.1.i.i.i.i
  %29 = getelementptr i8, ptr %scevgep148.i.i, i64 1920
  store double %.319.1.i.i.i.i, ptr %29, align 8, !noalias !18
  %.355.1.i.i.i.i = fmul contract double %.310.i.i.i.i, %.145.i.i.i.i
  %.357.1.i.i.i.i = fadd contract double %.142.i.i.i.i, %.355.1.i.i.i.i
  %.358.1.i.i.i.i = fneg contract double %.357.1.i.i.i.i
  %30 = getelementptr i8, ptr %scevgep148.i.i, i64 1984
  store double %.358.1.i.i.i.i, ptr %30, align 8, !noalias !18
  %.394.1.i.i.i.i = fmul contract double %.310.i.i.i.i, 0x40392AAAAAAAAAAB
  %.395.1.i.i.i.i = fadd contract double %.394.1.i.i.i.i, 3.750000e+01
  %.396.1.i.i.i.i = fmul contract double %.395.1.i.i.i.i, 0xC00921FB54442D18
  %31 = getelementptr i8, ptr %scevgep148.i.i, i64 2048
  store double %.396.1.i.i.i.i, ptr %31, align 8, !noalias !18
  %.432.1.i.i.i.i = fmul contract double %.310.i.i.i.i, %.166.i.i.i.i
  %.434.1.i.i.i.i = fadd contract double %.157.i.i.i.i, %.432.1.i.i.i.i
  %.435.1.i.i.i.i = fneg contract double %.434.1.i.i.i.i
  %32 = getelementptr i8, ptr %scevgep148.i.i, i64 2112
  store double %.435.1.i.i.i.i, ptr %32, align 8, !noalias !18
  %.486.i.i.i.i = fmul contract double %.30.i.i.i.i, 4.800000e+01
  %.490.i.i.i.i = fdiv contract double -2.470000e+02, %.486.i.i.i.i
  %.498.i.i.i.i = fdiv contract double 7.210000e+02, %.486.i.i.i.i
  %.528.i.i.i.i = getelementptr i8, ptr %scevgep148.i.i, i64 2176
  store double %.490.i.i.i.i, ptr %.528.i.i.i.i, align 8, !noalias !18
  %.559.i.i.i.i = getelementptr i8, ptr %scevgep148.i.i, i64 2240
  store double %.498.i.i.i.i, ptr %.559.i.i.i.i, align 8, !noalias !18
  %.562.i.i.i.i = fmul contract double %.95.i.i.i.i, 7.500000e+00
  %.563.i.i.i.i = fadd contract double %.562.i.i.i.i, 0xBF85555555555555
  %.570.i.i.i.i = fdiv contract double %.563.i.i.i.i, %.146.i.i.i
  %.600.i.i.i.i = getelementptr i8, ptr %scevgep148.i.i, i64 2304
  store double %.570.i.i.i.i, ptr %.600.i.i.i.i, align 8, !noalias !18
  %.603.i.i.i.i = fmul contract double %.133.i.i.i.i, 7.500000e+00
  %.604.i.i.i.i = fadd contract double %.603.i.i.i.i, 0xBF85555555555555
  %.611.i.i.i.i = fdiv contract double %.604.i.i.i.i, %.147.i.i.i
  %.641.i.i.i.i = getelementptr i8, ptr %scevgep148.i.i, i64 2368
  store double %.611.i.i.i.i, ptr %.641.i.i.i.i, align 8, !noalias !18
  %.147.i65.i.i.i.i = fmul contract double %.662.i.i.i, %.662.i.i.i
  %.147.i53.i.i.i.i = fmul contract double %.602.i.i.i, %.602.i.i.i
  %.147.i41.i.i.i.i = fmul contract double %.507.i.i.i, %.507.i.i.i
  %.147.i29.i.i.i.i = fmul contract double %.415.i.i.i, %.415.i.i.i
  %.147.i17.i.i.i.i = fmul contract double %.355.i.i.i, %.355.i.i.i
  %.147.i.i.i.i.i = fmul contract double %.263.i.i.i, %.263.i.i.i
  %.753.i.i.i.i = fadd contract double %.147.i.i.i.i.i, %.147.i17.i.i.i.i
  %.809.i.i.i.i = fadd contract double %.147.i29.i.i.i.i, %.753.i.i.i.i
  %.920.i.i.i.i = fadd contract double %.147.i41.i.i.i.i, %.147.i53.i.i.i.i
  %.981.i.i.i.i = fadd contract double %.147.i65.i.i.i.i, %.920.i.i.i.i
  %.1014.i.i.i.i = fmul contract double %.95.i.i.i.i, 2.500000e+00
  %.1017.i.i.i.i = fadd contract double %.1014.i.i.i.i, 0xBFB2AAAAAAAAAAAB
  %.1018.i.i.i.i = fmul contract double %.1017.i.i.i.i, %.809.i.i.i.i
  %.1025.i.i.i.i = fdiv contract double %.1018.i.i.i.i, %.146.i.i.i
  %.1026.i.i.i.i = fsub contract double %.85.i.i.i.i, %.1025.i.i.i.i
  %.1089.i.i.i.i = fmul contract double %.133.i.i.i.i, 2.500000e+00
  %.1092.i.i.i.i = fadd contract double %.1089.i.i.i.i, 0xBFB2AAAAAAAAAAAB
  %.1093.i.i.i.i = fmul contract double %.1092.i.i.i.i, %.981.i.i.i.i
  %.1100.i.i.i.i = fdiv contract double %.1093.i.i.i.i, %.147.i.i.i
  %.1101.i.i.i.i = fsub contract double %.1026.i.i.i.i, %.1100.i.i.i.i
  store double %.1101.i.i.i.i, ptr %.114.i.i.i.i, align 8, !noalias !18
  %.1192.i.i.i.i = load double, ptr %.277.i.i.i.i, align 8, !noalias !18
  %.147.i89.1.i.i.i.i = fmul contract double %.147.i.i.i, %.147.i.i.i
  %.147.i77.1.i.i.i.i = fmul contract double %.146.i.i.i, %.146.i.i.i
  %.1158.i.i.i.i = fmul contract double %.86.i.i.i, 1.100000e+01
  %.1161.i.i.i.i = fsub contract double 1.200000e+01, %.1158.i.i.i.i
  %.1162.i.i.i.i = fmul contract double %.1161.i.i.i.i, %.147.i77.1.i.i.i.i
  %.1193.i.i.i.i = fmul contract double %.1162.i.i.i.i, %.1192.i.i.i.i
  %.1220.i.i.i.i = fmul contract double %.87.i.i.i, 1.100000e+01
  %.1223.i.i.i.i = fsub contract double 1.200000e+01, %.1220.i.i.i.i
  %.1224.i.i.i.i = fmul contract double %.1223.i.i.i.i, %.147.i89.1.i.i.i.i
  %.1254.i.i.i.i = load double, ptr %.367.i.i.i.i, align 8, !noalias !18
  %.1260.i.i.i.i = fmul contract double %.1224.i.i.i.i, %.1254.i.i.i.i
  %.1261.i.i.i.i = fadd contract double %.1193.i.i.i.i, %.1260.i.i.i.i
  %.1262.i.i.i.i = fmul contract double %.1261.i.i.i.i, 6.000000e+00
  %.1292.i.i.i.i = getelementptr i8, ptr %scevgep148.i.i, i64 1600
  store double %.1262.i.i.i.i, ptr %.1292.i.i.i.i, align 8, !noalias !18
  %.955.i.i.i = getelementptr i8, ptr %.607.i.i, i64 56
  %.956.i.i.i = load double, ptr %.955.i.i.i, align 8, !noalias !6
  %.5.i.i.i.i = fmul contract double %.81.i.i.i, 1.500000e+00
  %.6.i.i.i.i = fadd contract double %.5.i.i.i.i, 2.000000e+00
  %.7.i.i.i.i = fmul contract double %.6.i.i.i.i, 0x3FAAAAAAAAAAAAAB
  %.11.i.i.i.i = fdiv contract double 5.000000e-01, %.7.i.i.i.i
  %.960.i.i.i = fmul contract double %.956.i.i.i, 0x400921FB54442D18
  %.961.i.i.i = fmul contract double %.960.i.i.i, 0x3ED4A8B4A9ED04E3
  %.962.i.i.i = fmul contract double %.344.i.i, %.961.i.i.i
  %.966.i.i.i = fdiv contract double 1.000000e+00, %.962.i.i.i
  store double %.11.i.i.i.i, ptr %scevgep148.i.i, align 8, !noalias !6
  %.1050.i.i.i = getelementptr i8, ptr %scevgep148.i.i, i64 64
  store double %.966.i.i.i, ptr %.1050.i.i.i, align 8, !noalias !6
  %.1054.i.i.i = fmul contract double %.11.i.i.i.i, 6.400000e+01
  %.1055.i.i.i = fadd contract double %.1054.i.i.i, %.966.i.i.i
  %.1056.i.i.i = fmul contract double %.966.i.i.i, %.1055.i.i.i
  %.1064.i.i.i = tail call contract double @sqrt(double %.1056.i.i.i)
  %.1069.i.i.i = fadd contract double %.1064.i.i.i, %.966.i.i.i
  %.1070.i.i.i = fmul contract double %.11.i.i.i.i, 2.000000e+00
  %.1074.i.i.i = fdiv contract double %.1069.i.i.i, %.1070.i.i.i
  %.1103.i.i.i = getelementptr i8, ptr %scevgep148.i.i, i64 128
  store double %.1074.i.i.i, ptr %.1103.i.i.i, align 8, !noalias !6
  %.911.i.i = icmp slt i64 %.13.i.i.i, 0
  %.912.i.i = select i1 %.911.i.i, i64 %.385.i.i, i64 0
  %.idx.i.i = shl i64 %.13.i.i.i, 4
  %33 = getelementptr i8, ptr %20, i64 %.idx.i.i
  %.926.i.i = getelementptr i64, ptr %33, i64 %.912.i.i
  %.927.i.i = load i64, ptr %.926.i.i, align 8, !noalias !3
  %34 = getelementptr i8, ptr %33, i64 8
  %.958.i.i = getelementptr i64, ptr %34, i64 %.912.i.i
  %.959.i.i = load i64, ptr %.958.i.i, align 8, !noalias !3
  %sunkaddr.i.i = shl nuw i64 %lsr.iv.i1.i, 1
  %sunkaddr4.i.i = getelementptr i8, ptr %1, i64 %sunkaddr.i.i
  store i64 %.927.i.i, ptr %sunkaddr4.i.i, align 8, !noalias !3
  %sunkaddr7.i.i = getelementptr i8, ptr %sunkaddr4.i.i, i64 8
  store i64 %.959.i.i, ptr %sunkaddr7.i.i, align 8, !noalias !3
  %.1053.i.i = load i64, ptr %.926.i.i, align 8, !noalias !3
  %.13.i74.i.i = tail call i64 @llvm.smax.i64(i64 %.1053.i.i, i64 %ahead.2.0600.i.i)
  %.1114.i.i = load i64, ptr %.958.i.i, align 8, !noalias !3
  %.13.i75.i.i = tail call i64 @llvm.smax.i64(i64 %.1114.i.i, i64 %back.2.0601.i.i)
  %lsr.iv.next.i2.i = add nuw nsw i64 %lsr.iv.i1.i, 8
  %lsr.iv.next150.i.i = add nuw i64 %lsr.iv149.i.i, 1
  %exitcond.not.i3.i = icmp eq i64 %lsr.iv.next.i2.i, 64
  br i1 %exitcond.not.i3.i, label %_ZN17bnserve_surrogate10precession7_source8_prepareB3v15B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExx5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i, label %B348.if.i.i

_ZN17bnserve_surrogate10precession7_source8_prepareB3v15B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExx5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i: ; preds = %B348.if.i.i
  %.742.i = add nsw i64 %.732765800.i, -1
  %.746.i = add nuw i64 %.739772799.i, 8
  call void @llvm.lifetime.start.p0(ptr nonnull %.1111.i.i), !noalias !0
  call void @llvm.lifetime.start.p0(ptr nonnull %.2357.i.i), !noalias !0
  call void @llvm.lifetime.start.p0(ptr nonnull %.2832.i.i), !noalias !0
  call void @llvm.lifetime.start.p0(ptr nonnull %.3310.i.i), !noalias !0
  call void @llvm.lifetime.start.p0(ptr nonnull %.3609.i.i), !noalias !0
  store ptr null, ptr %.1111.i.i, align 8, !noalias !21
  store ptr null, ptr %.2357.i.i, align 8, !noalias !21
  store ptr null, ptr %.2832.i.i, align 8, !noalias !21
  store ptr null, ptr %.3310.i.i, align 8, !noalias !21
  store ptr null, ptr %.3609.i.i, align 8, !noalias !21
  %.836.7.i.i = load i64, ptr %8, align 8, !noalias !21
  %.836.6.i.i = load i64, ptr %7, align 8, !noalias !21
  %.836.5.i.i = load i64, ptr %6, align 8, !noalias !21
  %.836.4.i.i = load i64, ptr %5, align 8, !noalias !21
  %.836.3.i.i = load i64, ptr %4, align 8, !noalias !21
  %.836.2.i.i = load i64, ptr %3, align 8, !noalias !21
  %.836.1.i.i = load i64, ptr %2, align 8, !noalias !21
  %.836.i.i = load i64, ptr %1, align 8, !noalias !21
  %.1019.i.i = load double, ptr %.171.i, align 8, !noalias !21
  store double %.1019.i.i, ptr %scevgep53.i.i, align 8, !noalias !21
  %.1019.1.i.i = load double, ptr %sunkaddr57.i.i, align 8, !noalias !21
  store double %.1019.1.i.i, ptr %scevgep51.i.i, align 8, !noalias !21
  %.1019.2.i.i = load double, ptr %sunkaddr60.i.i, align 8, !noalias !21
  store double %.1019.2.i.i, ptr %scevgep49.i.i, align 8, !noalias !21
  %.1019.3.i.i = load double, ptr %sunkaddr63.i.i, align 8, !noalias !21
  store double %.1019.3.i.i, ptr %scevgep47.i.i, align 8, !noalias !21
  %.1019.4.i.i = load double, ptr %sunkaddr66.i.i, align 8, !noalias !21
  store double %.1019.4.i.i, ptr %scevgep45.i.i, align 8, !noalias !21
  %.1019.11.i.i = load double, ptr %sunkaddr69.i.i, align 8, !noalias !21
  store double %.1019.11.i.i, ptr %scevgep43.i.i, align 8, !noalias !21
  %.1019.1.1.i.i = load double, ptr %sunkaddr72.i.i, align 8, !noalias !21
  store double %.1019.1.1.i.i, ptr %scevgep41.i.i, align 8, !noalias !21
  %.1019.2.1.i.i = load double, ptr %sunkaddr75.i.i, align 8, !noalias !21
  store double %.1019.2.1.i.i, ptr %scevgep39.i.i, align 8, !noalias !21
  %.1019.3.1.i.i = load double, ptr %sunkaddr78.i.i, align 8, !noalias !21
  store double %.1019.3.1.i.i, ptr %scevgep37.i.i, align 8, !noalias !21
  %.1019.4.1.i.i = load double, ptr %sunkaddr81.i.i, align 8, !noalias !21
  store double %.1019.4.1.i.i, ptr %scevgep35.i.i, align 8, !noalias !21
  %.1019.12.i.i = load double, ptr %sunkaddr54.1.i.i, align 8, !noalias !21
  store double %.1019.12.i.i, ptr %scevgep53.1.i.i, align 8, !noalias !21
  %.1019.1.13.i.i = load double, ptr %sunkaddr57.1.i.i, align 8, !noalias !21
  store double %.1019.1.13.i.i, ptr %scevgep51.1.i.i, align 8, !noalias !21
  %.1019.2.14.i.i = load double, ptr %sunkaddr60.1.i.i, align 8, !noalias !21
  store double %.1019.2.14.i.i, ptr %scevgep49.1.i.i, align 8, !noalias !21
  %.1019.3.15.i.i = load double, ptr %sunkaddr63.1.i.i, align 8, !noalias !21
  store double %.1019.3.15.i.i, ptr %scevgep47.1.i.i, align 8, !noalias !21
  %.1019.4.16.i.i = load double, ptr %sunkaddr66.1.i.i, align 8, !noalias !21
  store double %.1019.4.16.i.i, ptr %scevgep45.1.i.i, align 8, !noalias !21
  %.1019.11.1.i.i = load double, ptr %sunkaddr69.1.i.i, align 8, !noalias !21
  store double %.1019.11.1.i.i, ptr %scevgep43.1.i.i, align 8, !noalias !21
  %.1019.1.1.1.i.i = load double, ptr %sunkaddr72.1.i.i, align 8, !noalias !21
  store double %.1019.1.1.1.i.i, ptr %scevgep41.1.i.i, align 8, !noalias !21
  %.1019.2.1.1.i.i = load double, ptr %sunkaddr75.1.i.i, align 8, !noalias !21
  store double %.1019.2.1.1.i.i, ptr %scevgep39.1.i.i, align 8, !noalias !21
  %.1019.3.1.1.i.i = load double, ptr %sunkaddr78.1.i.i, align 8, !noalias !21
  store double %.1019.3.1.1.i.i, ptr %scevgep37.1.i.i, align 8, !noalias !21
  %.1019.4.1.1.i.i = load double, ptr %sunkaddr81.1.i.i, align 8, !noalias !21
  store double %.1019.4.1.1.i.i, ptr %scevgep35.1.i.i, align 8, !noalias !21
  %.1019.27.i.i = load double, ptr %sunkaddr54.2.i.i, align 8, !noalias !21
  store double %.1019.27.i.i, ptr %scevgep53.2.i.i, align 8, !noalias !21
  %.1019.1.2.i.i = load double, ptr %sunkaddr57.2.i.i, align 8, !noalias !21
  store double %.1019.1.2.i.i, ptr %scevgep51.2.i.i, align 8, !noalias !21
  %.1019.2.2.i.i = load double, ptr %sunkaddr60.2.i.i, align 8, !noalias !21
  store double %.1019.2.2.i.i, ptr %scevgep49.2.i.i, align 8, !noalias !21
  %.1019.3.2.i.i = load double, ptr %sunkaddr63.2.i.i, align 8, !noalias !21
  store double %.1019.3.2.i.i, ptr %scevgep47.2.i.i, align 8, !noalias !21
  %.1019.4.2.i.i = load double, ptr %sunkaddr66.2.i.i, align 8, !noalias !21
  store double %.1019.4.2.i.i, ptr %scevgep45.2.i.i, align 8, !noalias !21
  %.1019.11.2.i.i = load double, ptr %sunkaddr69.2.i.i, align 8, !noalias !21
  store double %.1019.11.2.i.i, ptr %scevgep43.2.i.i, align 8, !noalias !21
  %.1019.1.1.2.i.i = load double, ptr %sunkaddr72.2.i.i, align 8, !noalias !21
  store double %.1019.1.1.2.i.i, ptr %scevgep41.2.i.i, align 8, !noalias !21
  %.1019.2.1.2.i.i = load double, ptr %sunkaddr75.2.i.i, align 8, !noalias !21
  store double %.1019.2.1.2.i.i, ptr %scevgep39.2.i.i, align 8, !noalias !21
  %.1019.3.1.2.i.i = load double, ptr %sunkaddr78.2.i.i, align 8, !noalias !21
  store double %.1019.3.1.2.i.i, ptr %scevgep37.2.i.i, align 8, !noalias !21
  %.1019.4.1.2.i.i = load double, ptr %sunkaddr81.2.i.i, align 8, !noalias !21
  store double %.1019.4.1.2.i.i, ptr %scevgep35.2.i.i, align 8, !noalias !21
  %.1019.38.i.i = load double, ptr %sunkaddr54.3.i.i, align 8, !noalias !21
  store double %.1019.38.i.i, ptr %scevgep53.3.i.i, align 8, !noalias !21
  %.1019.1.3.i.i = load double, ptr %sunkaddr57.3.i.i, align 8, !noalias !21
  store double %.1019.1.3.i.i, ptr %scevgep51.3.i.i, align 8, !noalias !21
  %.1019.2.3.i.i = load double, ptr %sunkaddr60.3.i.i, align 8, !noalias !21
  store double %.1019.2.3.i.i, ptr %scevgep49.3.i.i, align 8, !noalias !21
  %.1019.3.3.i.i = load double, ptr %sunkaddr63.3.i.i, align 8, !noalias !21
  store double %.1019.3.3.i.i, ptr %scevgep47.3.i.i, align 8, !noalias !21
  %.1019.4.3.i.i = load double, ptr %sunkaddr66.3.i.i, align 8, !noalias !21
  store double %.1019.4.3.i.i, ptr %scevgep45.3.i.i, align 8, !noalias !21
  %.1019.11.3.i.i = load double, ptr %sunkaddr69.3.i.i, align 8, !noalias !21
  store double %.1019.11.3.i.i, ptr %scevgep43.3.i.i, align 8, !noalias !21
  %.1019.1.1.3.i.i = load double, ptr %sunkaddr72.3.i.i, align 8, !noalias !21
  store double %.1019.1.1.3.i.i, ptr %scevgep41.3.i.i, align 8, !noalias !21
  %.1019.2.1.3.i.i = load double, ptr %sunkaddr75.3.i.i, align 8, !noalias !21
  store double %.1019.2.1.3.i.i, ptr %scevgep39.3.i.i, align 8, !noalias !21
  %.1019.3.1.3.i.i = load double, ptr %sunkaddr78.3.i.i, align 8, !noalias !21
  store double %.1019.3.1.3.i.i, ptr %scevgep37.3.i.i, align 8, !noalias !21
  %.1019.4.1.3.i.i = load double, ptr %sunkaddr81.3.i.i, align 8, !noalias !21
  store double %.1019.4.1.3.i.i, ptr %scevgep35.3.i.i, align 8, !noalias !21
  %.1019.49.i.i = load double, ptr %sunkaddr54.4.i.i, align 8, !noalias !21
  store double %.1019.49.i.i, ptr %scevgep53.4.i.i, align 8, !noalias !21
  %.1019.1.4.i.i = load double, ptr %sunkaddr57.4.i.i, align 8, !noalias !21
  store double %.1019.1.4.i.i, ptr %scevgep51.4.i.i, align 8, !noalias !21
  %.1019.2.4.i.i = load double, ptr %sunkaddr60.4.i.i, align 8, !noalias !21
  store double %.1019.2.4.i.i, ptr %scevgep49.4.i.i, align 8, !noalias !21
  %.1019.3.4.i.i = load double, ptr %sunkaddr63.4.i.i, align 8, !noalias !21
  store double %.1019.3.4.i.i, ptr %scevgep47.4.i.i, align 8, !noalias !21
  %.1019.4.4.i.i = load double, ptr %sunkaddr66.4.i.i, align 8, !noalias !21
  store double %.1019.4.4.i.i, ptr %scevgep45.4.i.i, align 8, !noalias !21
  %.1019.11.4.i.i = load double, ptr %sunkaddr69.4.i.i, align 8, !noalias !21
  store double %.1019.11.4.i.i, ptr %scevgep43.4.i.i, align 8, !noalias !21
  %.1019.1.1.4.i.i = load double, ptr %sunkaddr72.4.i.i, align 8, !noalias !21
  store double %.1019.1.1.4.i.i, ptr %scevgep41.4.i.i, align 8, !noalias !21
  %.1019.2.1.4.i.i = load double, ptr %sunkaddr75.4.i.i, align 8, !noalias !21
  store double %.1019.2.1.4.i.i, ptr %scevgep39.4.i.i, align 8, !noalias !21
  %.1019.3.1.4.i.i = load double, ptr %sunkaddr78.4.i.i, align 8, !noalias !21
  store double %.1019.3.1.4.i.i, ptr %scevgep37.4.i.i, align 8, !noalias !21
  %.1019.4.1.4.i.i = load double, ptr %sunkaddr81.4.i.i, align 8, !noalias !21
  store double %.1019.4.1.4.i.i, ptr %scevgep35.4.i.i, align 8, !noalias !21
  %.1019.5.i.i = load double, ptr %sunkaddr54.5.i.i, align 8, !noalias !21
  store double %.1019.5.i.i, ptr %scevgep53.5.i.i, align 8, !noalias !21
  %.1019.1.5.i.i = load double, ptr %sunkaddr57.5.i.i, align 8, !noalias !21
  store double %.1019.1.5.i.i, ptr %scevgep51.5.i.i, align 8, !noalias !21
  %.1019.2.5.i.i = load double, ptr %sunkaddr60.5.i.i, align 8, !noalias !21
  store double %.1019.2.5.i.i, ptr %scevgep49.5.i.i, align 8, !noalias !21
  %.1019.3.5.i.i = load double, ptr %sunkaddr63.5.i.i, align 8, !noalias !21
  store double %.1019.3.5.i.i, ptr %scevgep47.5.i.i, align 8, !noalias !21
  %.1019.4.5.i.i = load double, ptr %sunkaddr66.5.i.i, align 8, !noalias !21
  store double %.1019.4.5.i.i, ptr %scevgep45.5.i.i, align 8, !noalias !21
  %.1019.11.5.i.i = load double, ptr %sunkaddr69.5.i.i, align 8, !noalias !21
  store double %.1019.11.5.i.i, ptr %scevgep43.5.i.i, align 8, !noalias !21
  %.1019.1.1.5.i.i = load double, ptr %sunkaddr72.5.i.i, align 8, !noalias !21
  store double %.1019.1.1.5.i.i, ptr %scevgep41.5.i.i, align 8, !noalias !21
  %.1019.2.1.5.i.i = load double, ptr %sunkaddr75.5.i.i, align 8, !noalias !21
  store double %.1019.2.1.5.i.i, ptr %scevgep39.5.i.i, align 8, !noalias !21
  %.1019.3.1.5.i.i = load double, ptr %sunkaddr78.5.i.i, align 8, !noalias !21
  store double %.1019.3.1.5.i.i, ptr %scevgep37.5.i.i, align 8, !noalias !21
  %.1019.4.1.5.i.i = load double, ptr %sunkaddr81.5.i.i, align 8, !noalias !21
  store double %.1019.4.1.5.i.i, ptr %scevgep35.5.i.i, align 8, !noalias !21
  %.1019.6.i.i = load double, ptr %sunkaddr54.6.i.i, align 8, !noalias !21
  store double %.1019.6.i.i, ptr %scevgep53.6.i.i, align 8, !noalias !21
  %.1019.1.6.i.i = load double, ptr %sunkaddr57.6.i.i, align 8, !noalias !21
  store double %.1019.1.6.i.i, ptr %scevgep51.6.i.i, align 8, !noalias !21
  %.1019.2.6.i.i = load double, ptr %sunkaddr60.6.i.i, align 8, !noalias !21
  store double %.1019.2.6.i.i, ptr %scevgep49.6.i.i, align 8, !noalias !21
  %.1019.3.6.i.i = load double, ptr %sunkaddr63.6.i.i, align 8, !noalias !21
  store double %.1019.3.6.i.i, ptr %scevgep47.6.i.i, align 8, !noalias !21
  %.1019.4.6.i.i = load double, ptr %sunkaddr66.6.i.i, align 8, !noalias !21
  store double %.1019.4.6.i.i, ptr %scevgep45.6.i.i, align 8, !noalias !21
  %.1019.11.6.i.i = load double, ptr %sunkaddr69.6.i.i, align 8, !noalias !21
  store double %.1019.11.6.i.i, ptr %scevgep43.6.i.i, align 8, !noalias !21
  %.1019.1.1.6.i.i = load double, ptr %sunkaddr72.6.i.i, align 8, !noalias !21
  store double %.1019.1.1.6.i.i, ptr %scevgep41.6.i.i, align 8, !noalias !21
  %.1019.2.1.6.i.i = load double, ptr %sunkaddr75.6.i.i, align 8, !noalias !21
  store double %.1019.2.1.6.i.i, ptr %scevgep39.6.i.i, align 8, !noalias !21
  %.1019.3.1.6.i.i = load double, ptr %sunkaddr78.6.i.i, align 8, !noalias !21
  store double %.1019.3.1.6.i.i, ptr %scevgep37.6.i.i, align 8, !noalias !21
  %.1019.4.1.6.i.i = load double, ptr %sunkaddr81.6.i.i, align 8, !noalias !21
  store double %.1019.4.1.6.i.i, ptr %scevgep35.6.i.i, align 8, !noalias !21
  %.1019.7.i.i = load double, ptr %sunkaddr54.7.i.i, align 8, !noalias !21
  store double %.1019.7.i.i, ptr %scevgep53.7.i.i, align 8, !noalias !21
  %.1019.1.7.i.i = load double, ptr %sunkaddr57.7.i.i, align 8, !noalias !21
  store double %.1019.1.7.i.i, ptr %scevgep51.7.i.i, align 8, !noalias !21
  %.1019.2.7.i.i = load double, ptr %sunkaddr60.7.i.i, align 8, !noalias !21
  store double %.1019.2.7.i.i, ptr %scevgep49.7.i.i, align 8, !noalias !21
  %.1019.3.7.i.i = load double, ptr %sunkaddr63.7.i.i, align 8, !noalias !21
  store double %.1019.3.7.i.i, ptr %scevgep47.7.i.i, align 8, !noalias !21
  %.1019.4.7.i.i = load double, ptr %sunkaddr66.7.i.i, align 8, !noalias !21
  store double %.1019.4.7.i.i, ptr %scevgep45.7.i.i, align 8, !noalias !21
  %.1019.11.7.i.i = load double, ptr %sunkaddr69.7.i.i, align 8, !noalias !21
  store double %.1019.11.7.i.i, ptr %scevgep43.7.i.i, align 8, !noalias !21
  %.1019.1.1.7.i.i = load double, ptr %sunkaddr72.7.i.i, align 8, !noalias !21
  store double %.1019.1.1.7.i.i, ptr %scevgep41.7.i.i, align 8, !noalias !21
  %.1019.2.1.7.i.i = load double, ptr %sunkaddr75.7.i.i, align 8, !noalias !21
  store double %.1019.2.1.7.i.i, ptr %scevgep39.7.i.i, align 8, !noalias !21
  %.1019.3.1.7.i.i = load double, ptr %sunkaddr78.7.i.i, align 8, !noalias !21
  store double %.1019.3.1.7.i.i, ptr %scevgep37.7.i.i, align 8, !noalias !21
  %.1019.4.1.7.i.i = load double, ptr %sunkaddr81.7.i.i, align 8, !noalias !21
  store double %.1019.4.1.7.i.i, ptr %scevgep35.7.i.i, align 8, !noalias !21
  %.13.i.i4.i = tail call i64 @llvm.smax.i64(i64 %.836.i.i, i64 %.836.1.i.i)
  %.13.i111.i.i = tail call i64 @llvm.smax.i64(i64 %.13.i.i4.i, i64 %.836.2.i.i)
  %.13.i112.i.i = tail call i64 @llvm.smax.i64(i64 %.13.i111.i.i, i64 %.836.3.i.i)
  %.13.i113.i.i = tail call i64 @llvm.smax.i64(i64 %.13.i112.i.i, i64 %.836.4.i.i)
  %.13.i114.i.i = tail call i64 @llvm.smax.i64(i64 %.13.i113.i.i, i64 %.836.5.i.i)
  %.13.i115.i.i = tail call i64 @llvm.smax.i64(i64 %.13.i114.i.i, i64 %.836.6.i.i)
  %.13.i116.i.i = tail call i64 @llvm.smax.i64(i64 %.13.i115.i.i, i64 %.836.7.i.i)
  %.1070.i.i = load <8 x double>, ptr %.1068.i.i, align 8, !noalias !21
  %.38.i.i.i = load <8 x double>, ptr %.49.i, align 8, !noalias !24
  %.8.i.i.i.i = fadd contract <8 x double> %.1070.i.i, splat (double 1.600000e+01)
  %.8.i1.i.i.i = fdiv contract <8 x double> splat (double 1.000000e+00), %.8.i.i.i.i
  %.6.i.i.i5.i = fmul contract <8 x double> %.1070.i.i, %.38.i.i.i
  %.6.i2.i.i.i = fmul contract <8 x double> %.1070.i.i, %.6.i.i.i5.i
  %.6.i3.i.i.i = fmul contract <8 x double> %.8.i1.i.i.i, %.6.i2.i.i.i
  %.162.i.i.i = bitcast <8 x double> %.6.i3.i.i.i to <8 x i64>
  %.8.i4.i.i.i = ashr <8 x i64> %.162.i.i.i, splat (i64 52)
  %.8.i5.i.i.i = add nsw <8 x i64> %.8.i4.i.i.i, splat (i64 4841369599423283200)
  %35 = bitcast <8 x i64> %.8.i5.i.i.i to <8 x double>
  %.8.i6.i.i.i = fadd contract <8 x double> %35, splat (double 0xC3300000000003FF)
  %.8.i7.i.i.i = and <8 x i64> %.162.i.i.i, splat (i64 4503599627370495)
  %.8.i8.i.i.i = or disjoint <8 x i64> %.8.i7.i.i.i, splat (i64 4607182418800017408)
  %36 = bitcast <8 x i64> %.8.i8.i.i.i to <8 x double>
  %.8.i9.i.i.i = fadd contract <8 x double> %36, splat (double -1.000000e+00)
  %.8.i10.i.i.i = fadd contract <8 x double> %36, splat (double 1.000000e+00)
  %.6.i11.i.i.i = fdiv contract <8 x double> %.8.i9.i.i.i, %.8.i10.i.i.i
  %.6.i12.i.i.i = fmul contract <8 x double> %.6.i11.i.i.i, %.6.i11.i.i.i
  %.385.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i12.i.i.i, <8 x double> splat (double 0x3FB642C8590B2164), <8 x double> splat (double 0x3FB8618618618618))
  %.388.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i12.i.i.i, <8 x double> %.385.i.i.i, <8 x double> splat (double 0x3FBAF286BCA1AF28))
  %.391.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i12.i.i.i, <8 x double> %.388.i.i.i, <8 x double> splat (double 0x3FBE1E1E1E1E1E1E))
  %.394.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i12.i.i.i, <8 x double> %.391.i.i.i, <8 x double> splat (double 0x3FC1111111111111))
  %.397.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i12.i.i.i, <8 x double> %.394.i.i.i, <8 x double> splat (double 0x3FC3B13B13B13B14))
  %.400.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i12.i.i.i, <8 x double> %.397.i.i.i, <8 x double> splat (double 0x3FC745D1745D1746))
  %.403.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i12.i.i.i, <8 x double> %.400.i.i.i, <8 x double> splat (double 0x3FCC71C71C71C71C))
  %.406.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i12.i.i.i, <8 x double> %.403.i.i.i, <8 x double> splat (double 0x3FD2492492492492))
  %.409.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i12.i.i.i, <8 x double> %.406.i.i.i, <8 x double> splat (double 4.000000e-01))
  %.412.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i12.i.i.i, <8 x double> %.409.i.i.i, <8 x double> splat (double 0x3FE5555555555555))
  %.415.i.i6.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i12.i.i.i, <8 x double> %.412.i.i.i, <8 x double> splat (double 2.000000e+00))
  %.6.i13.i.i.i = fmul contract <8 x double> %.6.i11.i.i.i, %.415.i.i6.i
  %.442.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i6.i.i.i, <8 x double> splat (double 0x3FE62E42FEFA39EF), <8 x double> %.6.i13.i.i.i)
  %.8.i15.i.i.i = fadd contract <8 x double> %.1070.i.i, splat (double 3.200000e+01)
  %.6.i16.i.i.i = fmul contract <8 x double> %.8.i15.i.i.i, %.6.i.i.i5.i
  %.6.i17.i.i.i = fmul contract <8 x double> %.8.i1.i.i.i, %.6.i16.i.i.i
  %.6.i18.i.i.i = fmul contract <8 x double> %.8.i1.i.i.i, %.6.i17.i.i.i
  store <8 x double> %.6.i18.i.i.i, ptr %.252.i, align 8, !noalias !24
  %.8.i19.i.i.i = fmul contract <8 x double> %.442.i.i.i, splat (double 0xBFD5555555555555)
  %.604.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i19.i.i.i, <8 x double> splat (double 0x3FF71547652B82FE), <8 x double> splat (double 0x4338000000000000))
  %.8.i20.i.i.i = fadd contract <8 x double> %.604.i.i.i, splat (double 0xC338000000000000)
  %.633.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i20.i.i.i, <8 x double> splat (double 0xBFE62E42FEFA39EF), <8 x double> %.8.i19.i.i.i)
  %.636.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i20.i.i.i, <8 x double> splat (double 0xBC7ABC9E3B39803F), <8 x double> %.633.i.i.i)
  %.641.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.636.i.i.i, <8 x double> splat (double 0x3DE6124613A86D09), <8 x double> splat (double 0x3E21EED8EFF8D898))
  %.644.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.636.i.i.i, <8 x double> %.641.i.i.i, <8 x double> splat (double 0x3E5AE64567F544E4))
  %.647.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.636.i.i.i, <8 x double> %.644.i.i.i, <8 x double> splat (double 0x3E927E4FB7789F5C))
  %.650.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.636.i.i.i, <8 x double> %.647.i.i.i, <8 x double> splat (double 0x3EC71DE3A556C734))
  %.653.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.636.i.i.i, <8 x double> %.650.i.i.i, <8 x double> splat (double 0x3EFA01A01A01A01A))
  %.656.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.636.i.i.i, <8 x double> %.653.i.i.i, <8 x double> splat (double 0x3F2A01A01A01A01A))
  %.659.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.636.i.i.i, <8 x double> %.656.i.i.i, <8 x double> splat (double 0x3F56C16C16C16C17))
  %.662.i.i7.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.636.i.i.i, <8 x double> %.659.i.i.i, <8 x double> splat (double 0x3F81111111111111))
  %.665.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.636.i.i.i, <8 x double> %.662.i.i7.i, <8 x double> splat (double 0x3FA5555555555555))
  %.668.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.636.i.i.i, <8 x double> %.665.i.i.i, <8 x double> splat (double 0x3FC5555555555555))
  %.671.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.636.i.i.i, <8 x double> %.668.i.i.i, <8 x double> splat (double 5.000000e-01))
  %.6.i21.i.i.i = fmul contract <8 x double> %.636.i.i.i, %.636.i.i.i
  %.8.i22.i.i.i = fadd contract <8 x double> %.636.i.i.i, splat (double 1.000000e+00)
  %.720.i.i8.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i21.i.i.i, <8 x double> %.671.i.i.i, <8 x double> %.8.i22.i.i.i)
  %.721.i.i9.i = bitcast <8 x double> %.604.i.i.i to <8 x i64>
  %.8.i23.i.i.i = shl <8 x i64> %.721.i.i9.i, splat (i64 52)
  %.8.i24.i.i.i = add <8 x i64> %.8.i23.i.i.i, splat (i64 4607182418800017408)
  %37 = bitcast <8 x i64> %.8.i24.i.i.i to <8 x double>
  %.6.i25.i.i.i = fmul contract <8 x double> %.720.i.i8.i, %37
  store <8 x double> %.6.i25.i.i.i, ptr %.801.i.i.i, align 8, !noalias !24
  %.8.i26.i.i.i = fsub contract <8 x double> zeroinitializer, %.442.i.i.i
  store <8 x double> %.8.i26.i.i.i, ptr %.835.i.i10.i, align 8, !noalias !24
  %.847.i.i.i = load <8 x double>, ptr %.845.i.i.i, align 8, !noalias !24
  %.6.i27.i.i.i = fsub contract <8 x double> %.847.i.i.i, %.6.i3.i.i.i
  %.881.i.i.i = load <8 x double>, ptr %.879.i.i.i, align 8, !noalias !24
  %.6.i28.i.i.i = fmul contract <8 x double> %.6.i27.i.i.i, %.881.i.i.i
  %.916.i.i.i = load <8 x double>, ptr %.914.i.i.i, align 8, !noalias !24
  %.6.i29.i.i.i = fmul contract <8 x double> %.6.i28.i.i.i, %.916.i.i.i
  %.945.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i29.i.i.i, <8 x double> splat (double 0x3FE45F306DC9C883), <8 x double> splat (double 0x4338000000000000))
  %.8.i30.i.i.i = fadd contract <8 x double> %.945.i.i.i, splat (double 0xC338000000000000)
  %.986.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i30.i.i.i, <8 x double> splat (double 0xBFF921FB54442D18), <8 x double> %.6.i29.i.i.i)
  %.1003.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i30.i.i.i, <8 x double> splat (double 0xBC91A62633145C07), <8 x double> %.986.i.i.i)
  %.6.i31.i.i.i = fmul contract <8 x double> %.1003.i.i.i, %.1003.i.i.i
  %.6.i32.i.i.i = fmul contract <8 x double> %.1003.i.i.i, %.6.i31.i.i.i
  %.1032.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i31.i.i.i, <8 x double> splat (double 0xBD6AE7F3E733B81F), <8 x double> splat (double 0x3DE6124613A86D09))
  %.1035.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i31.i.i.i, <8 x double> %.1032.i.i.i, <8 x double> splat (double 0xBE5AE64567F544E4))
  %.1038.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i31.i.i.i, <8 x double> %.1035.i.i.i, <8 x double> splat (double 0x3EC71DE3A556C734))
  %.1041.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i31.i.i.i, <8 x double> %.1038.i.i.i, <8 x double> splat (double 0xBF2A01A01A01A01A))
  %.1044.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i31.i.i.i, <8 x double> %.1041.i.i.i, <8 x double> splat (double 0x3F81111111111111))
  %.1047.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i31.i.i.i, <8 x double> %.1044.i.i.i, <8 x double> splat (double 0xBFC5555555555555))
  %.1072.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i32.i.i.i, <8 x double> %.1047.i.i.i, <8 x double> %.1003.i.i.i)
  %.1077.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i31.i.i.i, <8 x double> splat (double 0x3D2AE7F3E733B81F), <8 x double> splat (double 0xBDA93974A8C07C9D))
  %.1080.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i31.i.i.i, <8 x double> %.1077.i.i.i, <8 x double> splat (double 0x3E21EED8EFF8D898))
  %.1083.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i31.i.i.i, <8 x double> %.1080.i.i.i, <8 x double> splat (double 0xBE927E4FB7789F5C))
  %.1086.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i31.i.i.i, <8 x double> %.1083.i.i.i, <8 x double> splat (double 0x3EFA01A01A01A01A))
  %.1089.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i31.i.i.i, <8 x double> %.1086.i.i.i, <8 x double> splat (double 0xBF56C16C16C16C17))
  %.1092.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i31.i.i.i, <8 x double> %.1089.i.i.i, <8 x double> splat (double 0x3FA5555555555555))
  %.1095.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i31.i.i.i, <8 x double> %.1092.i.i.i, <8 x double> splat (double -5.000000e-01))
  %.1098.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i31.i.i.i, <8 x double> %.1095.i.i.i, <8 x double> splat (double 1.000000e+00))
  %.1099.i.i.i = bitcast <8 x double> %.945.i.i.i to <8 x i64>
  %.1100.i.i.i = bitcast <8 x double> %.1072.i.i.i to <8 x i64>
  %.1101.i.i.i = bitcast <8 x double> %.1098.i.i.i to <8 x i64>
  %.6.i33.i.i.i = xor <8 x i64> %.1101.i.i.i, %.1100.i.i.i
  %.8.i34.i.i.i = and <8 x i64> %.1099.i.i.i, splat (i64 1)
  %38 = icmp eq <8 x i64> %.8.i34.i.i.i, zeroinitializer
  %.6.i36.i.i.i = select <8 x i1> %38, <8 x i64> zeroinitializer, <8 x i64> %.6.i33.i.i.i
  %.8.i37.i.i.i = shl <8 x i64> %.1099.i.i.i, splat (i64 62)
  %.8.i38.i.i.i = and <8 x i64> %.8.i37.i.i.i, splat (i64 -9223372036854775808)
  %.8.i40.i.i.i = add <8 x i64> %.8.i37.i.i.i, splat (i64 4611686018427387904)
  %.8.i41.i.i.i = and <8 x i64> %.8.i40.i.i.i, splat (i64 -9223372036854775808)
  %39 = xor <8 x i64> %.8.i38.i.i.i, %.1100.i.i.i
  %.6.i43.i.i.i = xor <8 x i64> %39, %.6.i36.i.i.i
  %40 = xor <8 x i64> %.8.i41.i.i.i, %.1101.i.i.i
  %.6.i45.i.i.i = xor <8 x i64> %40, %.6.i36.i.i.i
  store <8 x i64> %.6.i43.i.i.i, ptr %.1443.i.i.i, align 8, !noalias !24
  store <8 x i64> %.6.i45.i.i.i, ptr %.1453.i.i.i, align 8, !noalias !24
  %.1466.i.i.i = load <8 x double>, ptr %.1464.i.i.i, align 8, !noalias !24
  %.6.i46.i.i.i = fmul contract <8 x double> %.6.i28.i.i.i, %.1466.i.i.i
  %.1498.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i46.i.i.i, <8 x double> splat (double 0x3FE45F306DC9C883), <8 x double> splat (double 0x4338000000000000))
  %.8.i47.i.i.i = fadd contract <8 x double> %.1498.i.i.i, splat (double 0xC338000000000000)
  %.1539.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i47.i.i.i, <8 x double> splat (double 0xBFF921FB54442D18), <8 x double> %.6.i46.i.i.i)
  %.1556.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i47.i.i.i, <8 x double> splat (double 0xBC91A62633145C07), <8 x double> %.1539.i.i.i)
  %.6.i48.i.i.i = fmul contract <8 x double> %.1556.i.i.i, %.1556.i.i.i
  %.6.i49.i.i.i = fmul contract <8 x double> %.1556.i.i.i, %.6.i48.i.i.i
  %.1585.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i48.i.i.i, <8 x double> splat (double 0xBD6AE7F3E733B81F), <8 x double> splat (double 0x3DE6124613A86D09))
  %.1588.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i48.i.i.i, <8 x double> %.1585.i.i.i, <8 x double> splat (double 0xBE5AE64567F544E4))
  %.1591.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i48.i.i.i, <8 x double> %.1588.i.i.i, <8 x double> splat (double 0x3EC71DE3A556C734))
  %.1594.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i48.i.i.i, <8 x double> %.1591.i.i.i, <8 x double> splat (double 0xBF2A01A01A01A01A))
  %.1597.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i48.i.i.i, <8 x double> %.1594.i.i.i, <8 x double> splat (double 0x3F81111111111111))
  %.1600.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i48.i.i.i, <8 x double> %.1597.i.i.i, <8 x double> splat (double 0xBFC5555555555555))
  %.1625.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i49.i.i.i, <8 x double> %.1600.i.i.i, <8 x double> %.1556.i.i.i)
  %.1630.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i48.i.i.i, <8 x double> splat (double 0x3D2AE7F3E733B81F), <8 x double> splat (double 0xBDA93974A8C07C9D))
  %.1633.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i48.i.i.i, <8 x double> %.1630.i.i.i, <8 x double> splat (double 0x3E21EED8EFF8D898))
  %.1636.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i48.i.i.i, <8 x double> %.1633.i.i.i, <8 x double> splat (double 0xBE927E4FB7789F5C))
  %.1639.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i48.i.i.i, <8 x double> %.1636.i.i.i, <8 x double> splat (double 0x3EFA01A01A01A01A))
  %.1642.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i48.i.i.i, <8 x double> %.1639.i.i.i, <8 x double> splat (double 0xBF56C16C16C16C17))
  %.1645.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i48.i.i.i, <8 x double> %.1642.i.i.i, <8 x double> splat (double 0x3FA5555555555555))
  %.1648.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i48.i.i.i, <8 x double> %.1645.i.i.i, <8 x double> splat (double -5.000000e-01))
  %.1651.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i48.i.i.i, <8 x double> %.1648.i.i.i, <8 x double> splat (double 1.000000e+00))
  %.1652.i.i.i = bitcast <8 x double> %.1498.i.i.i to <8 x i64>
  %.1653.i.i.i = bitcast <8 x double> %.1625.i.i.i to <8 x i64>
  %.1654.i.i.i = bitcast <8 x double> %.1651.i.i.i to <8 x i64>
  %.6.i50.i.i.i = xor <8 x i64> %.1654.i.i.i, %.1653.i.i.i
  %.8.i51.i.i.i = and <8 x i64> %.1652.i.i.i, splat (i64 1)
  %41 = icmp eq <8 x i64> %.8.i51.i.i.i, zeroinitializer
  %.6.i53.i.i.i = select <8 x i1> %41, <8 x i64> zeroinitializer, <8 x i64> %.6.i50.i.i.i
  %.8.i54.i.i.i = shl <8 x i64> %.1652.i.i.i, splat (i64 62)
  %.8.i55.i.i.i = and <8 x i64> %.8.i54.i.i.i, splat (i64 -9223372036854775808)
  %.8.i57.i.i.i = add <8 x i64> %.8.i54.i.i.i, splat (i64 4611686018427387904)
  %.8.i58.i.i.i = and <8 x i64> %.8.i57.i.i.i, splat (i64 -9223372036854775808)
  %42 = xor <8 x i64> %.8.i55.i.i.i, %.1653.i.i.i
  %.6.i60.i.i.i = xor <8 x i64> %42, %.6.i53.i.i.i
  %43 = xor <8 x i64> %.8.i58.i.i.i, %.1654.i.i.i
  %.6.i62.i.i.i = xor <8 x i64> %43, %.6.i53.i.i.i
  store <8 x i64> %.6.i60.i.i.i, ptr %.1996.i.i.i, align 8, !noalias !24
  store <8 x i64> %.6.i62.i.i.i, ptr %.2006.i.i.i, align 8, !noalias !24
  store ptr null, ptr %.1111.i.i, align 8, !noalias !21
  call fastcc void @inner_0(ptr nonnull %.1111.i.i, ptr nonnull readonly %.49.i, ptr nonnull %.252.i, ptr nonnull %scevgep53.i.i, ptr nonnull %.391.i.i)
  %.idx.i11.i = shl i64 %.13.i74.i.i, 9
  %44 = getelementptr i8, ptr %.390.i, i64 %.idx.i11.i
  %45 = getelementptr i8, ptr %44, i64 256
  %.1314.i.i = load <8 x double>, ptr %scevgep37.4.i.i, align 8, !noalias !21
  store <8 x double> %.1314.i.i, ptr %44, align 8, !noalias !21
  %.1338.i.i = load <8 x double>, ptr %.1336.i.i, align 8, !noalias !21
  store <8 x double> %.1338.i.i, ptr %45, align 8, !noalias !21
  %.1314.1.i.i = load <8 x double>, ptr %scevgep41.5.i.i, align 8, !noalias !21
  %.1322.1.i.i = getelementptr i8, ptr %44, i64 64
  store <8 x double> %.1314.1.i.i, ptr %.1322.1.i.i, align 8, !noalias !21
  %.1338.1.i.i = load <8 x double>, ptr %.1336.1.i.i, align 8, !noalias !21
  %.1346.1.i.i = getelementptr i8, ptr %44, i64 320
  store <8 x double> %.1338.1.i.i, ptr %.1346.1.i.i, align 8, !noalias !21
  %.1314.2.i.i = load <8 x double>, ptr %scevgep45.6.i.i, align 8, !noalias !21
  %.1322.2.i.i = getelementptr i8, ptr %44, i64 128
  store <8 x double> %.1314.2.i.i, ptr %.1322.2.i.i, align 8, !noalias !21
  %.1338.2.i.i = load <8 x double>, ptr %.1336.2.i.i, align 8, !noalias !21
  %.1346.2.i.i = getelementptr i8, ptr %44, i64 384
  store <8 x double> %.1338.2.i.i, ptr %.1346.2.i.i, align 8, !noalias !21
  %.1314.3.i.i = load <8 x double>, ptr %scevgep49.7.i.i, align 8, !noalias !21
  %.1322.3.i.i = getelementptr i8, ptr %44, i64 192
  store <8 x double> %.1314.3.i.i, ptr %.1322.3.i.i, align 8, !noalias !21
  %.1338.3.i.i = load <8 x double>, ptr %.1336.3.i.i, align 8, !noalias !21
  %.1346.3.i.i = getelementptr i8, ptr %44, i64 448
  store <8 x double> %.1338.3.i.i, ptr %.1346.3.i.i, align 8, !noalias !21
  %.145967.not.i.i = icmp slt i64 %.13.i116.i.i, 1
  br i1 %.145967.not.i.i, label %_ZN17bnserve_surrogate10precession9_dynamics6followB3v36B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIxLi1E1C7mutable7alignedE23Literal_5bint_5d_280_295ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx.exit.i, label %B986.if.lr.ph.i.i

B4545.i.i:                                        ; preds = %B4482.if.i.i
  store ptr null, ptr %.2357.i.i, align 8, !noalias !21
  call fastcc void @inner_0(ptr nonnull %.2357.i.i, ptr nonnull readonly %.49.i, ptr nonnull %.171.i.i, ptr nonnull %.474.i.i, ptr nonnull %.391.i.i)
  %.8.i401.i.i = fmul contract <8 x double> %.1716.i.i, splat (double 0x3FD5555555555555)
  br label %B4669.if.i.i

B4919.i.i:                                        ; preds = %B4856.if.i.i
  store ptr null, ptr %.2832.i.i, align 8, !noalias !21
  call fastcc void @inner_0(ptr nonnull %.2832.i.i, ptr nonnull readonly %.49.i, ptr nonnull %.171.i.i, ptr nonnull %.474.i.i, ptr nonnull %.391.i.i)
  br label %B5043.if.i.i

B5293.i.i:                                        ; preds = %B5230.if.i.i
  store ptr null, ptr %.3310.i.i, align 8, !noalias !21
  call fastcc void @inner_0(ptr nonnull %.3310.i.i, ptr nonnull readonly %.49.i, ptr nonnull %.234.i.i, ptr nonnull %.474.i.i, ptr nonnull %.391.i.i)
  br label %B5417.if.i.i

B5516.i.i:                                        ; preds = %B5417.if.i.i
  store ptr null, ptr %.3609.i.i, align 8, !noalias !21
  call fastcc void @inner_0(ptr nonnull %.3609.i.i, ptr nonnull readonly %.49.i, ptr nonnull %.234.i.i, ptr nonnull %scevgep53.i.i, ptr nonnull %.391.i.i)
  %.3647.i.i = xor i64 %.1449.sroa.0.074.i.i, -1
  %.3649.i.i = add nsw i64 %.13.i74.i.i, %.3647.i.i
  %.idx75.i.i = shl i64 %.3649.i.i, 9
  %46 = getelementptr i8, ptr %.390.i, i64 %.idx75.i.i
  %47 = getelementptr i8, ptr %46, i64 256
  %.3814.i.i = load <8 x double>, ptr %scevgep37.4.i.i, align 8, !noalias !21
  store <8 x double> %.3814.i.i, ptr %46, align 8, !noalias !21
  %.3838.i.i = load <8 x double>, ptr %.1336.i.i, align 8, !noalias !21
  store <8 x double> %.3838.i.i, ptr %47, align 8, !noalias !21
  %.3814.1.i.i = load <8 x double>, ptr %scevgep41.5.i.i, align 8, !noalias !21
  %.3822.1.i.i = getelementptr i8, ptr %46, i64 64
  store <8 x double> %.3814.1.i.i, ptr %.3822.1.i.i, align 8, !noalias !21
  %.3838.1.i.i = load <8 x double>, ptr %.1336.1.i.i, align 8, !noalias !21
  %.3846.1.i.i = getelementptr i8, ptr %46, i64 320
  store <8 x double> %.3838.1.i.i, ptr %.3846.1.i.i, align 8, !noalias !21
  %.3814.2.i.i = load <8 x double>, ptr %scevgep45.6.i.i, align 8, !noalias !21
  %.3822.2.i.i = getelementptr i8, ptr %46, i64 128
  store <8 x double> %.3814.2.i.i, ptr %.3822.2.i.i, align 8, !noalias !21
  %.3838.2.i.i = load <8 x double>, ptr %.1336.2.i.i, align 8, !noalias !21
  %.3846.2.i.i = getelementptr i8, ptr %46, i64 384
  store <8 x double> %.3838.2.i.i, ptr %.3846.2.i.i, align 8, !noalias !21
  %.3814.3.i.i = load <8 x double>, ptr %scevgep49.7.i.i, align 8, !noalias !21
  %.3822.3.i.i = getelementptr i8, ptr %46, i64 192
  store <8 x double> %.3814.3.i.i, ptr %.3822.3.i.i, align 8, !noalias !21
  %.3838.3.i.i = load <8 x double>, ptr %.1336.3.i.i, align 8, !noalias !21
  %.3846.3.i.i = getelementptr i8, ptr %46, i64 448
  store <8 x double> %.3838.3.i.i, ptr %.3846.3.i.i, align 8, !noalias !21
  %.1459.i.i = icmp sgt i64 %.1458215673.i.i, 0
  %.1472.i.i = zext i1 %.1459.i.i to i64
  %.14652170.i.i = add i64 %.1465217072.i.i, %.1472.i.i
  %.1468.i.i = sext i1 %.1459.i.i to i64
  %.14582156.i.i = add nsw i64 %.1458215673.i.i, %.1468.i.i
  %.1449.sroa.0.0.i.i = select i1 %.1459.i.i, i64 %.1465217072.i.i, i64 0
  br i1 %.1459.i.i, label %B986.if.i.i, label %_ZN17bnserve_surrogate10precession9_dynamics6followB3v36B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIxLi1E1C7mutable7alignedE23Literal_5bint_5d_280_295ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx.exit.i

B986.if.lr.ph.i.i:                                ; preds = %_ZN17bnserve_surrogate10precession7_source8_prepareB3v15B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExx5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i
  %.1458215670.i.i = add nsw i64 %.13.i116.i.i, -1
  br label %B986.if.i.i

B986.if.i.i:                                      ; preds = %B986.if.lr.ph.i.i, %B5516.i.i
  %.1449.sroa.0.074.i.i = phi i64 [ 0, %B986.if.lr.ph.i.i ], [ %.1449.sroa.0.0.i.i, %B5516.i.i ]
  %.1458215673.i.i = phi i64 [ %.1458215670.i.i, %B986.if.lr.ph.i.i ], [ %.14582156.i.i, %B5516.i.i ]
  %.1465217072.i.i = phi i64 [ 1, %B986.if.lr.ph.i.i ], [ %.14652170.i.i, %B5516.i.i ]
  %step.2.071.i.i = phi <8 x double> [ %.1070.i.i, %B986.if.lr.ph.i.i ], [ %.6.i.i.i, %B5516.i.i ]
  %.1653.i.i = load i64, ptr %1, align 8, !noalias !21
  %.1655.i.i = icmp slt i64 %.1449.sroa.0.074.i.i, %.1653.i.i
  %"$phi988.2.2.2.i.i" = select i1 %.1655.i.i, double -1.000000e+00, double 0.000000e+00
  store double %"$phi988.2.2.2.i.i", ptr %sunkaddr.i12.i, align 8, !noalias !21
  %.1653.1.i.i = load i64, ptr %2, align 8, !noalias !21
  %.1655.1.i.i = icmp slt i64 %.1449.sroa.0.074.i.i, %.1653.1.i.i
  %"$phi988.2.2.2.1.i.i" = select i1 %.1655.1.i.i, double -1.000000e+00, double 0.000000e+00
  store double %"$phi988.2.2.2.1.i.i", ptr %sunkaddr24.i.i, align 8, !noalias !21
  %.1653.2.i.i = load i64, ptr %3, align 8, !noalias !21
  %.1655.2.i.i = icmp slt i64 %.1449.sroa.0.074.i.i, %.1653.2.i.i
  %"$phi988.2.2.2.2.i.i" = select i1 %.1655.2.i.i, double -1.000000e+00, double 0.000000e+00
  store double %"$phi988.2.2.2.2.i.i", ptr %sunkaddr26.i.i, align 8, !noalias !21
  %.1653.3.i.i = load i64, ptr %4, align 8, !noalias !21
  %.1655.3.i.i = icmp slt i64 %.1449.sroa.0.074.i.i, %.1653.3.i.i
  %"$phi988.2.2.2.3.i.i" = select i1 %.1655.3.i.i, double -1.000000e+00, double 0.000000e+00
  store double %"$phi988.2.2.2.3.i.i", ptr %sunkaddr28.i.i, align 8, !noalias !21
  %.1653.4.i.i = load i64, ptr %5, align 8, !noalias !21
  %.1655.4.i.i = icmp slt i64 %.1449.sroa.0.074.i.i, %.1653.4.i.i
  %"$phi988.2.2.2.4.i.i" = select i1 %.1655.4.i.i, double -1.000000e+00, double 0.000000e+00
  store double %"$phi988.2.2.2.4.i.i", ptr %sunkaddr30.i.i, align 8, !noalias !21
  %.1653.5.i.i = load i64, ptr %6, align 8, !noalias !21
  %.1655.5.i.i = icmp slt i64 %.1449.sroa.0.074.i.i, %.1653.5.i.i
  %"$phi988.2.2.2.5.i.i" = select i1 %.1655.5.i.i, double -1.000000e+00, double 0.000000e+00
  store double %"$phi988.2.2.2.5.i.i", ptr %sunkaddr32.i.i, align 8, !noalias !21
  %.1653.6.i.i = load i64, ptr %7, align 8, !noalias !21
  %.1655.6.i.i = icmp slt i64 %.1449.sroa.0.074.i.i, %.1653.6.i.i
  %"$phi988.2.2.2.6.i.i" = select i1 %.1655.6.i.i, double -1.000000e+00, double 0.000000e+00
  store double %"$phi988.2.2.2.6.i.i", ptr %sunkaddr34.i.i, align 8, !noalias !21
  %.1653.7.i.i = load i64, ptr %8, align 8, !noalias !21
  %.1655.7.i.i = icmp slt i64 %.1449.sroa.0.074.i.i, %.1653.7.i.i
  %"$phi988.2.2.2.7.i.i" = select i1 %.1655.7.i.i, double -1.000000e+00, double 0.000000e+00
  store double %"$phi988.2.2.2.7.i.i", ptr %sunkaddr36.i.i, align 8, !noalias !21
  %.1716.i.i = load <8 x double>, ptr %sunkaddr.i12.i, align 8, !noalias !21
  %.1721.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1716.i.i, <8 x double> splat (double 5.000000e-01), <8 x double> %step.2.071.i.i)
  %.38.i118.i.i = load <8 x double>, ptr %.49.i, align 8, !noalias !27
  %.8.i.i119.i.i = fadd contract <8 x double> %.1721.i.i, splat (double 1.600000e+01)
  %.8.i1.i120.i.i = fdiv contract <8 x double> splat (double 1.000000e+00), %.8.i.i119.i.i
  %.6.i.i121.i.i = fmul contract <8 x double> %.1721.i.i, %.38.i118.i.i
  %.6.i2.i122.i.i = fmul contract <8 x double> %.1721.i.i, %.6.i.i121.i.i
  %.6.i3.i123.i.i = fmul contract <8 x double> %.8.i1.i120.i.i, %.6.i2.i122.i.i
  %.162.i124.i.i = bitcast <8 x double> %.6.i3.i123.i.i to <8 x i64>
  %.8.i4.i125.i.i = ashr <8 x i64> %.162.i124.i.i, splat (i64 52)
  %.8.i5.i126.i.i = add nsw <8 x i64> %.8.i4.i125.i.i, splat (i64 4841369599423283200)
  %48 = bitcast <8 x i64> %.8.i5.i126.i.i to <8 x double>
  %.8.i6.i127.i.i = fadd contract <8 x double> %48, splat (double 0xC3300000000003FF)
  %.8.i7.i128.i.i = and <8 x i64> %.162.i124.i.i, splat (i64 4503599627370495)
  %.8.i8.i129.i.i = or disjoint <8 x i64> %.8.i7.i128.i.i, splat (i64 4607182418800017408)
  %49 = bitcast <8 x i64> %.8.i8.i129.i.i to <8 x double>
  %.8.i9.i130.i.i = fadd contract <8 x double> %49, splat (double -1.000000e+00)
  %.8.i10.i131.i.i = fadd contract <8 x double> %49, splat (double 1.000000e+00)
  %.6.i11.i132.i.i = fdiv contract <8 x double> %.8.i9.i130.i.i, %.8.i10.i131.i.i
  %.6.i12.i133.i.i = fmul contract <8 x double> %.6.i11.i132.i.i, %.6.i11.i132.i.i
  %.385.i134.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i12.i133.i.i, <8 x double> splat (double 0x3FB642C8590B2164), <8 x double> splat (double 0x3FB8618618618618))
  %.388.i135.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i12.i133.i.i, <8 x double> %.385.i134.i.i, <8 x double> splat (double 0x3FBAF286BCA1AF28))
  %.391.i136.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i12.i133.i.i, <8 x double> %.388.i135.i.i, <8 x double> splat (double 0x3FBE1E1E1E1E1E1E))
  %.394.i137.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i12.i133.i.i, <8 x double> %.391.i136.i.i, <8 x double> splat (double 0x3FC1111111111111))
  %.397.i138.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i12.i133.i.i, <8 x double> %.394.i137.i.i, <8 x double> splat (double 0x3FC3B13B13B13B14))
  %.400.i139.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i12.i133.i.i, <8 x double> %.397.i138.i.i, <8 x double> splat (double 0x3FC745D1745D1746))
  %.403.i140.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i12.i133.i.i, <8 x double> %.400.i139.i.i, <8 x double> splat (double 0x3FCC71C71C71C71C))
  %.406.i141.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i12.i133.i.i, <8 x double> %.403.i140.i.i, <8 x double> splat (double 0x3FD2492492492492))
  %.409.i142.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i12.i133.i.i, <8 x double> %.406.i141.i.i, <8 x double> splat (double 4.000000e-01))
  %.412.i143.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i12.i133.i.i, <8 x double> %.409.i142.i.i, <8 x double> splat (double 0x3FE5555555555555))
  %.415.i144.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i12.i133.i.i, <8 x double> %.412.i143.i.i, <8 x double> splat (double 2.000000e+00))
  %.6.i13.i145.i.i = fmul contract <8 x double> %.6.i11.i132.i.i, %.415.i144.i.i
  %.442.i146.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i6.i127.i.i, <8 x double> splat (double 0x3FE62E42FEFA39EF), <8 x double> %.6.i13.i145.i.i)
  %.8.i15.i147.i.i = fadd contract <8 x double> %.1721.i.i, splat (double 3.200000e+01)
  %.6.i16.i148.i.i = fmul contract <8 x double> %.8.i15.i147.i.i, %.6.i.i121.i.i
  %.6.i17.i149.i.i = fmul contract <8 x double> %.8.i1.i120.i.i, %.6.i16.i148.i.i
  %.6.i18.i150.i.i = fmul contract <8 x double> %.8.i1.i120.i.i, %.6.i17.i149.i.i
  store <8 x double> %.6.i18.i150.i.i, ptr %.171.i.i, align 8, !noalias !27
  %.8.i19.i151.i.i = fmul contract <8 x double> %.442.i146.i.i, splat (double 0xBFD5555555555555)
  %.604.i152.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i19.i151.i.i, <8 x double> splat (double 0x3FF71547652B82FE), <8 x double> splat (double 0x4338000000000000))
  %.8.i20.i153.i.i = fadd contract <8 x double> %.604.i152.i.i, splat (double 0xC338000000000000)
  %.633.i154.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i20.i153.i.i, <8 x double> splat (double 0xBFE62E42FEFA39EF), <8 x double> %.8.i19.i151.i.i)
  %.636.i155.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i20.i153.i.i, <8 x double> splat (double 0xBC7ABC9E3B39803F), <8 x double> %.633.i154.i.i)
  %.641.i156.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.636.i155.i.i, <8 x double> splat (double 0x3DE6124613A86D09), <8 x double> splat (double 0x3E21EED8EFF8D898))
  %.644.i157.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.636.i155.i.i, <8 x double> %.641.i156.i.i, <8 x double> splat (double 0x3E5AE64567F544E4))
  %.647.i158.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.636.i155.i.i, <8 x double> %.644.i157.i.i, <8 x double> splat (double 0x3E927E4FB7789F5C))
  %.650.i159.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.636.i155.i.i, <8 x double> %.647.i158.i.i, <8 x double> splat (double 0x3EC71DE3A556C734))
  %.653.i160.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.636.i155.i.i, <8 x double> %.650.i159.i.i, <8 x double> splat (double 0x3EFA01A01A01A01A))
  %.656.i161.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.636.i155.i.i, <8 x double> %.653.i160.i.i, <8 x double> splat (double 0x3F2A01A01A01A01A))
  %.659.i162.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.636.i155.i.i, <8 x double> %.656.i161.i.i, <8 x double> splat (double 0x3F56C16C16C16C17))
  %.662.i163.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.636.i155.i.i, <8 x double> %.659.i162.i.i, <8 x double> splat (double 0x3F81111111111111))
  %.665.i164.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.636.i155.i.i, <8 x double> %.662.i163.i.i, <8 x double> splat (double 0x3FA5555555555555))
  %.668.i165.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.636.i155.i.i, <8 x double> %.665.i164.i.i, <8 x double> splat (double 0x3FC5555555555555))
  %.671.i166.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.636.i155.i.i, <8 x double> %.668.i165.i.i, <8 x double> splat (double 5.000000e-01))
  %.6.i21.i167.i.i = fmul contract <8 x double> %.636.i155.i.i, %.636.i155.i.i
  %.8.i22.i168.i.i = fadd contract <8 x double> %.636.i155.i.i, splat (double 1.000000e+00)
  %.720.i169.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i21.i167.i.i, <8 x double> %.671.i166.i.i, <8 x double> %.8.i22.i168.i.i)
  %.721.i170.i.i = bitcast <8 x double> %.604.i152.i.i to <8 x i64>
  %.8.i23.i171.i.i = shl <8 x i64> %.721.i170.i.i, splat (i64 52)
  %.8.i24.i172.i.i = add <8 x i64> %.8.i23.i171.i.i, splat (i64 4607182418800017408)
  %50 = bitcast <8 x i64> %.8.i24.i172.i.i to <8 x double>
  %.6.i25.i173.i.i = fmul contract <8 x double> %.720.i169.i.i, %50
  store <8 x double> %.6.i25.i173.i.i, ptr %sunkaddr38.i.i, align 8, !noalias !27
  %.8.i26.i175.i.i = fsub contract <8 x double> zeroinitializer, %.442.i146.i.i
  store <8 x double> %.8.i26.i175.i.i, ptr %sunkaddr39.i.i, align 8, !noalias !27
  %.847.i178.i.i = load <8 x double>, ptr %.845.i.i.i, align 8, !noalias !27
  %.6.i27.i179.i.i = fsub contract <8 x double> %.847.i178.i.i, %.6.i3.i123.i.i
  %.881.i181.i.i = load <8 x double>, ptr %.879.i.i.i, align 8, !noalias !27
  %.6.i28.i182.i.i = fmul contract <8 x double> %.6.i27.i179.i.i, %.881.i181.i.i
  %.916.i184.i.i = load <8 x double>, ptr %.914.i.i.i, align 8, !noalias !27
  %.6.i29.i185.i.i = fmul contract <8 x double> %.6.i28.i182.i.i, %.916.i184.i.i
  %.945.i186.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i29.i185.i.i, <8 x double> splat (double 0x3FE45F306DC9C883), <8 x double> splat (double 0x4338000000000000))
  %.8.i30.i187.i.i = fadd contract <8 x double> %.945.i186.i.i, splat (double 0xC338000000000000)
  %.986.i188.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i30.i187.i.i, <8 x double> splat (double 0xBFF921FB54442D18), <8 x double> %.6.i29.i185.i.i)
  %.1003.i189.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i30.i187.i.i, <8 x double> splat (double 0xBC91A62633145C07), <8 x double> %.986.i188.i.i)
  %.6.i31.i190.i.i = fmul contract <8 x double> %.1003.i189.i.i, %.1003.i189.i.i
  %.6.i32.i191.i.i = fmul contract <8 x double> %.1003.i189.i.i, %.6.i31.i190.i.i
  %.1032.i192.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i31.i190.i.i, <8 x double> splat (double 0xBD6AE7F3E733B81F), <8 x double> splat (double 0x3DE6124613A86D09))
  %.1035.i193.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i31.i190.i.i, <8 x double> %.1032.i192.i.i, <8 x double> splat (double 0xBE5AE64567F544E4))
  %.1038.i194.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i31.i190.i.i, <8 x double> %.1035.i193.i.i, <8 x double> splat (double 0x3EC71DE3A556C734))
  %.1041.i195.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i31.i190.i.i, <8 x double> %.1038.i194.i.i, <8 x double> splat (double 0xBF2A01A01A01A01A))
  %.1044.i196.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i31.i190.i.i, <8 x double> %.1041.i195.i.i, <8 x double> splat (double 0x3F81111111111111))
  %.1047.i197.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i31.i190.i.i, <8 x double> %.1044.i196.i.i, <8 x double> splat (double 0xBFC5555555555555))
  %.1072.i198.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i32.i191.i.i, <8 x double> %.1047.i197.i.i, <8 x double> %.1003.i189.i.i)
  %.1077.i199.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i31.i190.i.i, <8 x double> splat (double 0x3D2AE7F3E733B81F), <8 x double> splat (double 0xBDA93974A8C07C9D))
  %.1080.i200.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i31.i190.i.i, <8 x double> %.1077.i199.i.i, <8 x double> splat (double 0x3E21EED8EFF8D898))
  %.1083.i201.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i31.i190.i.i, <8 x double> %.1080.i200.i.i, <8 x double> splat (double 0xBE927E4FB7789F5C))
  %.1086.i202.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i31.i190.i.i, <8 x double> %.1083.i201.i.i, <8 x double> splat (double 0x3EFA01A01A01A01A))
  %.1089.i203.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i31.i190.i.i, <8 x double> %.1086.i202.i.i, <8 x double> splat (double 0xBF56C16C16C16C17))
  %.1092.i204.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i31.i190.i.i, <8 x double> %.1089.i203.i.i, <8 x double> splat (double 0x3FA5555555555555))
  %.1095.i205.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i31.i190.i.i, <8 x double> %.1092.i204.i.i, <8 x double> splat (double -5.000000e-01))
  %.1098.i206.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i31.i190.i.i, <8 x double> %.1095.i205.i.i, <8 x double> splat (double 1.000000e+00))
  %.1099.i207.i.i = bitcast <8 x double> %.945.i186.i.i to <8 x i64>
  %.1100.i208.i.i = bitcast <8 x double> %.1072.i198.i.i to <8 x i64>
  %.1101.i209.i.i = bitcast <8 x double> %.1098.i206.i.i to <8 x i64>
  %.6.i33.i210.i.i = xor <8 x i64> %.1101.i209.i.i, %.1100.i208.i.i
  %.8.i34.i211.i.i = and <8 x i64> %.1099.i207.i.i, splat (i64 1)
  %51 = icmp eq <8 x i64> %.8.i34.i211.i.i, zeroinitializer
  %.6.i36.i212.i.i = select <8 x i1> %51, <8 x i64> zeroinitializer, <8 x i64> %.6.i33.i210.i.i
  %.8.i37.i213.i.i = shl <8 x i64> %.1099.i207.i.i, splat (i64 62)
  %.8.i38.i214.i.i = and <8 x i64> %.8.i37.i213.i.i, splat (i64 -9223372036854775808)
  %.8.i40.i215.i.i = add <8 x i64> %.8.i37.i213.i.i, splat (i64 4611686018427387904)
  %.8.i41.i216.i.i = and <8 x i64> %.8.i40.i215.i.i, splat (i64 -9223372036854775808)
  %52 = xor <8 x i64> %.8.i38.i214.i.i, %.1100.i208.i.i
  %.6.i43.i217.i.i = xor <8 x i64> %52, %.6.i36.i212.i.i
  %53 = xor <8 x i64> %.8.i41.i216.i.i, %.1101.i209.i.i
  %.6.i45.i218.i.i = xor <8 x i64> %53, %.6.i36.i212.i.i
  store <8 x i64> %.6.i43.i217.i.i, ptr %sunkaddr43.i.i, align 8, !noalias !27
  store <8 x i64> %.6.i45.i218.i.i, ptr %sunkaddr44.i.i, align 8, !noalias !27
  %.1466.i222.i.i = load <8 x double>, ptr %.1464.i.i.i, align 8, !noalias !27
  %.6.i46.i223.i.i = fmul contract <8 x double> %.6.i28.i182.i.i, %.1466.i222.i.i
  %.1498.i224.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i46.i223.i.i, <8 x double> splat (double 0x3FE45F306DC9C883), <8 x double> splat (double 0x4338000000000000))
  %.8.i47.i225.i.i = fadd contract <8 x double> %.1498.i224.i.i, splat (double 0xC338000000000000)
  %.1539.i226.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i47.i225.i.i, <8 x double> splat (double 0xBFF921FB54442D18), <8 x double> %.6.i46.i223.i.i)
  %.1556.i227.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i47.i225.i.i, <8 x double> splat (double 0xBC91A62633145C07), <8 x double> %.1539.i226.i.i)
  %.6.i48.i228.i.i = fmul contract <8 x double> %.1556.i227.i.i, %.1556.i227.i.i
  %.6.i49.i229.i.i = fmul contract <8 x double> %.1556.i227.i.i, %.6.i48.i228.i.i
  %.1585.i230.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i48.i228.i.i, <8 x double> splat (double 0xBD6AE7F3E733B81F), <8 x double> splat (double 0x3DE6124613A86D09))
  %.1588.i231.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i48.i228.i.i, <8 x double> %.1585.i230.i.i, <8 x double> splat (double 0xBE5AE64567F544E4))
  %.1591.i232.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i48.i228.i.i, <8 x double> %.1588.i231.i.i, <8 x double> splat (double 0x3EC71DE3A556C734))
  %.1594.i233.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i48.i228.i.i, <8 x double> %.1591.i232.i.i, <8 x double> splat (double 0xBF2A01A01A01A01A))
  %.1597.i234.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i48.i228.i.i, <8 x double> %.1594.i233.i.i, <8 x double> splat (double 0x3F81111111111111))
  %.1600.i235.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i48.i228.i.i, <8 x double> %.1597.i234.i.i, <8 x double> splat (double 0xBFC5555555555555))
  %.1625.i236.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i49.i229.i.i, <8 x double> %.1600.i235.i.i, <8 x double> %.1556.i227.i.i)
  %.1630.i237.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i48.i228.i.i, <8 x double> splat (double 0x3D2AE7F3E733B81F), <8 x double> splat (double 0xBDA93974A8C07C9D))
  %.1633.i238.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i48.i228.i.i, <8 x double> %.1630.i237.i.i, <8 x double> splat (double 0x3E21EED8EFF8D898))
  %.1636.i239.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i48.i228.i.i, <8 x double> %.1633.i238.i.i, <8 x double> splat (double 0xBE927E4FB7789F5C))
  %.1639.i240.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i48.i228.i.i, <8 x double> %.1636.i239.i.i, <8 x double> splat (double 0x3EFA01A01A01A01A))
  %.1642.i241.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i48.i228.i.i, <8 x double> %.1639.i240.i.i, <8 x double> splat (double 0xBF56C16C16C16C17))
  %.1645.i242.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i48.i228.i.i, <8 x double> %.1642.i241.i.i, <8 x double> splat (double 0x3FA5555555555555))
  %.1648.i243.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i48.i228.i.i, <8 x double> %.1645.i242.i.i, <8 x double> splat (double -5.000000e-01))
  %.1651.i244.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i48.i228.i.i, <8 x double> %.1648.i243.i.i, <8 x double> splat (double 1.000000e+00))
  %.1652.i245.i.i = bitcast <8 x double> %.1498.i224.i.i to <8 x i64>
  %.1653.i246.i.i = bitcast <8 x double> %.1625.i236.i.i to <8 x i64>
  %.1654.i247.i.i = bitcast <8 x double> %.1651.i244.i.i to <8 x i64>
  %.6.i50.i248.i.i = xor <8 x i64> %.1654.i247.i.i, %.1653.i246.i.i
  %.8.i51.i249.i.i = and <8 x i64> %.1652.i245.i.i, splat (i64 1)
  %54 = icmp eq <8 x i64> %.8.i51.i249.i.i, zeroinitializer
  %.6.i53.i250.i.i = select <8 x i1> %54, <8 x i64> zeroinitializer, <8 x i64> %.6.i50.i248.i.i
  %.8.i54.i251.i.i = shl <8 x i64> %.1652.i245.i.i, splat (i64 62)
  %.8.i55.i252.i.i = and <8 x i64> %.8.i54.i251.i.i, splat (i64 -9223372036854775808)
  %.8.i57.i253.i.i = add <8 x i64> %.8.i54.i251.i.i, splat (i64 4611686018427387904)
  %.8.i58.i254.i.i = and <8 x i64> %.8.i57.i253.i.i, splat (i64 -9223372036854775808)
  %55 = xor <8 x i64> %.8.i55.i252.i.i, %.1653.i246.i.i
  %.6.i60.i255.i.i = xor <8 x i64> %55, %.6.i53.i250.i.i
  %56 = xor <8 x i64> %.8.i58.i254.i.i, %.1654.i247.i.i
  %.6.i62.i256.i.i = xor <8 x i64> %56, %.6.i53.i250.i.i
  store <8 x i64> %.6.i60.i255.i.i, ptr %sunkaddr46.i.i, align 8, !noalias !27
  store <8 x i64> %.6.i62.i256.i.i, ptr %sunkaddr47.i.i, align 8, !noalias !27
  %.6.i.i.i = fadd contract <8 x double> %step.2.071.i.i, %.1716.i.i
  %.8.i.i260.i.i = fadd contract <8 x double> %.6.i.i.i, splat (double 1.600000e+01)
  %.8.i1.i261.i.i = fdiv contract <8 x double> splat (double 1.000000e+00), %.8.i.i260.i.i
  %.6.i.i262.i.i = fmul contract <8 x double> %.6.i.i.i, %.38.i118.i.i
  %.6.i2.i263.i.i = fmul contract <8 x double> %.6.i.i.i, %.6.i.i262.i.i
  %.6.i3.i264.i.i = fmul contract <8 x double> %.8.i1.i261.i.i, %.6.i2.i263.i.i
  %.162.i265.i.i = bitcast <8 x double> %.6.i3.i264.i.i to <8 x i64>
  %.8.i4.i266.i.i = ashr <8 x i64> %.162.i265.i.i, splat (i64 52)
  %.8.i5.i267.i.i = add nsw <8 x i64> %.8.i4.i266.i.i, splat (i64 4841369599423283200)
  %57 = bitcast <8 x i64> %.8.i5.i267.i.i to <8 x double>
  %.8.i6.i268.i.i = fadd contract <8 x double> %57, splat (double 0xC3300000000003FF)
  %.8.i7.i269.i.i = and <8 x i64> %.162.i265.i.i, splat (i64 4503599627370495)
  %.8.i8.i270.i.i = or disjoint <8 x i64> %.8.i7.i269.i.i, splat (i64 4607182418800017408)
  %58 = bitcast <8 x i64> %.8.i8.i270.i.i to <8 x double>
  %.8.i9.i271.i.i = fadd contract <8 x double> %58, splat (double -1.000000e+00)
  %.8.i10.i272.i.i = fadd contract <8 x double> %58, splat (double 1.000000e+00)
  %.6.i11.i273.i.i = fdiv contract <8 x double> %.8.i9.i271.i.i, %.8.i10.i272.i.i
  %.6.i12.i274.i.i = fmul contract <8 x double> %.6.i11.i273.i.i, %.6.i11.i273.i.i
  %.385.i275.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i12.i274.i.i, <8 x double> splat (double 0x3FB642C8590B2164), <8 x double> splat (double 0x3FB8618618618618))
  %.388.i276.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i12.i274.i.i, <8 x double> %.385.i275.i.i, <8 x double> splat (double 0x3FBAF286BCA1AF28))
  %.391.i277.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i12.i274.i.i, <8 x double> %.388.i276.i.i, <8 x double> splat (double 0x3FBE1E1E1E1E1E1E))
  %.394.i278.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i12.i274.i.i, <8 x double> %.391.i277.i.i, <8 x double> splat (double 0x3FC1111111111111))
  %.397.i279.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i12.i274.i.i, <8 x double> %.394.i278.i.i, <8 x double> splat (double 0x3FC3B13B13B13B14))
  %.400.i280.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i12.i274.i.i, <8 x double> %.397.i279.i.i, <8 x double> splat (double 0x3FC745D1745D1746))
  %.403.i281.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i12.i274.i.i, <8 x double> %.400.i280.i.i, <8 x double> splat (double 0x3FCC71C71C71C71C))
  %.406.i282.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i12.i274.i.i, <8 x double> %.403.i281.i.i, <8 x double> splat (double 0x3FD2492492492492))
  %.409.i283.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i12.i274.i.i, <8 x double> %.406.i282.i.i, <8 x double> splat (double 4.000000e-01))
  %.412.i284.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i12.i274.i.i, <8 x double> %.409.i283.i.i, <8 x double> splat (double 0x3FE5555555555555))
  %.415.i285.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i12.i274.i.i, <8 x double> %.412.i284.i.i, <8 x double> splat (double 2.000000e+00))
  %.6.i13.i286.i.i = fmul contract <8 x double> %.6.i11.i273.i.i, %.415.i285.i.i
  %.442.i287.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i6.i268.i.i, <8 x double> splat (double 0x3FE62E42FEFA39EF), <8 x double> %.6.i13.i286.i.i)
  %.8.i15.i288.i.i = fadd contract <8 x double> %.6.i.i.i, splat (double 3.200000e+01)
  %.6.i16.i289.i.i = fmul contract <8 x double> %.8.i15.i288.i.i, %.6.i.i262.i.i
  %.6.i17.i290.i.i = fmul contract <8 x double> %.8.i1.i261.i.i, %.6.i16.i289.i.i
  %.6.i18.i291.i.i = fmul contract <8 x double> %.8.i1.i261.i.i, %.6.i17.i290.i.i
  store <8 x double> %.6.i18.i291.i.i, ptr %.234.i.i, align 8, !noalias !30
  %.8.i19.i292.i.i = fmul contract <8 x double> %.442.i287.i.i, splat (double 0xBFD5555555555555)
  %.604.i293.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i19.i292.i.i, <8 x double> splat (double 0x3FF71547652B82FE), <8 x double> splat (double 0x4338000000000000))
  %.8.i20.i294.i.i = fadd contract <8 x double> %.604.i293.i.i, splat (double 0xC338000000000000)
  %.633.i295.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i20.i294.i.i, <8 x double> splat (double 0xBFE62E42FEFA39EF), <8 x double> %.8.i19.i292.i.i)
  %.636.i296.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i20.i294.i.i, <8 x double> splat (double 0xBC7ABC9E3B39803F), <8 x double> %.633.i295.i.i)
  %.641.i297.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.636.i296.i.i, <8 x double> splat (double 0x3DE6124613A86D09), <8 x double> splat (double 0x3E21EED8EFF8D898))
  %.644.i298.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.636.i296.i.i, <8 x double> %.641.i297.i.i, <8 x double> splat (double 0x3E5AE64567F544E4))
  %.647.i299.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.636.i296.i.i, <8 x double> %.644.i298.i.i, <8 x double> splat (double 0x3E927E4FB7789F5C))
  %.650.i300.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.636.i296.i.i, <8 x double> %.647.i299.i.i, <8 x double> splat (double 0x3EC71DE3A556C734))
  %.653.i301.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.636.i296.i.i, <8 x double> %.650.i300.i.i, <8 x double> splat (double 0x3EFA01A01A01A01A))
  %.656.i302.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.636.i296.i.i, <8 x double> %.653.i301.i.i, <8 x double> splat (double 0x3F2A01A01A01A01A))
  %.659.i303.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.636.i296.i.i, <8 x double> %.656.i302.i.i, <8 x double> splat (double 0x3F56C16C16C16C17))
  %.662.i304.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.636.i296.i.i, <8 x double> %.659.i303.i.i, <8 x double> splat (double 0x3F81111111111111))
  %.665.i305.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.636.i296.i.i, <8 x double> %.662.i304.i.i, <8 x double> splat (double 0x3FA5555555555555))
  %.668.i306.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.636.i296.i.i, <8 x double> %.665.i305.i.i, <8 x double> splat (double 0x3FC5555555555555))
  %.671.i307.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.636.i296.i.i, <8 x double> %.668.i306.i.i, <8 x double> splat (double 5.000000e-01))
  %.6.i21.i308.i.i = fmul contract <8 x double> %.636.i296.i.i, %.636.i296.i.i
  %.8.i22.i309.i.i = fadd contract <8 x double> %.636.i296.i.i, splat (double 1.000000e+00)
  %.720.i310.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i21.i308.i.i, <8 x double> %.671.i307.i.i, <8 x double> %.8.i22.i309.i.i)
  %.721.i311.i.i = bitcast <8 x double> %.604.i293.i.i to <8 x i64>
  %.8.i23.i312.i.i = shl <8 x i64> %.721.i311.i.i, splat (i64 52)
  %.8.i24.i313.i.i = add <8 x i64> %.8.i23.i312.i.i, splat (i64 4607182418800017408)
  %59 = bitcast <8 x i64> %.8.i24.i313.i.i to <8 x double>
  %.6.i25.i314.i.i = fmul contract <8 x double> %.720.i310.i.i, %59
  store <8 x double> %.6.i25.i314.i.i, ptr %sunkaddr49.i.i, align 8, !noalias !30
  %.8.i26.i316.i.i = fsub contract <8 x double> zeroinitializer, %.442.i287.i.i
  store <8 x double> %.8.i26.i316.i.i, ptr %sunkaddr50.i.i, align 8, !noalias !30
  %.6.i27.i320.i.i = fsub contract <8 x double> %.847.i178.i.i, %.6.i3.i264.i.i
  %.6.i28.i323.i.i = fmul contract <8 x double> %.6.i27.i320.i.i, %.881.i181.i.i
  %.6.i29.i326.i.i = fmul contract <8 x double> %.6.i28.i323.i.i, %.916.i184.i.i
  %.945.i327.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i29.i326.i.i, <8 x double> splat (double 0x3FE45F306DC9C883), <8 x double> splat (double 0x4338000000000000))
  %.8.i30.i328.i.i = fadd contract <8 x double> %.945.i327.i.i, splat (double 0xC338000000000000)
  %.986.i329.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i30.i328.i.i, <8 x double> splat (double 0xBFF921FB54442D18), <8 x double> %.6.i29.i326.i.i)
  %.1003.i330.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i30.i328.i.i, <8 x double> splat (double 0xBC91A62633145C07), <8 x double> %.986.i329.i.i)
  %.6.i31.i331.i.i = fmul contract <8 x double> %.1003.i330.i.i, %.1003.i330.i.i
  %.6.i32.i332.i.i = fmul contract <8 x double> %.1003.i330.i.i, %.6.i31.i331.i.i
  %.1032.i333.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i31.i331.i.i, <8 x double> splat (double 0xBD6AE7F3E733B81F), <8 x double> splat (double 0x3DE6124613A86D09))
  %.1035.i334.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i31.i331.i.i, <8 x double> %.1032.i333.i.i, <8 x double> splat (double 0xBE5AE64567F544E4))
  %.1038.i335.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i31.i331.i.i, <8 x double> %.1035.i334.i.i, <8 x double> splat (double 0x3EC71DE3A556C734))
  %.1041.i336.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i31.i331.i.i, <8 x double> %.1038.i335.i.i, <8 x double> splat (double 0xBF2A01A01A01A01A))
  %.1044.i337.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i31.i331.i.i, <8 x double> %.1041.i336.i.i, <8 x double> splat (double 0x3F81111111111111))
  %.1047.i338.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i31.i331.i.i, <8 x double> %.1044.i337.i.i, <8 x double> splat (double 0xBFC5555555555555))
  %.1072.i339.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i32.i332.i.i, <8 x double> %.1047.i338.i.i, <8 x double> %.1003.i330.i.i)
  %.1077.i340.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i31.i331.i.i, <8 x double> splat (double 0x3D2AE7F3E733B81F), <8 x double> splat (double 0xBDA93974A8C07C9D))
  %.1080.i341.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i31.i331.i.i, <8 x double> %.1077.i340.i.i, <8 x double> splat (double 0x3E21EED8EFF8D898))
  %.1083.i342.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i31.i331.i.i, <8 x double> %.1080.i341.i.i, <8 x double> splat (double 0xBE927E4FB7789F5C))
  %.1086.i343.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i31.i331.i.i, <8 x double> %.1083.i342.i.i, <8 x double> splat (double 0x3EFA01A01A01A01A))
  %.1089.i344.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i31.i331.i.i, <8 x double> %.1086.i343.i.i, <8 x double> splat (double 0xBF56C16C16C16C17))
  %.1092.i345.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i31.i331.i.i, <8 x double> %.1089.i344.i.i, <8 x double> splat (double 0x3FA5555555555555))
  %.1095.i346.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i31.i331.i.i, <8 x double> %.1092.i345.i.i, <8 x double> splat (double -5.000000e-01))
  %.1098.i347.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i31.i331.i.i, <8 x double> %.1095.i346.i.i, <8 x double> splat (double 1.000000e+00))
  %.1099.i348.i.i = bitcast <8 x double> %.945.i327.i.i to <8 x i64>
  %.1100.i349.i.i = bitcast <8 x double> %.1072.i339.i.i to <8 x i64>
  %.1101.i350.i.i = bitcast <8 x double> %.1098.i347.i.i to <8 x i64>
  %.6.i33.i351.i.i = xor <8 x i64> %.1101.i350.i.i, %.1100.i349.i.i
  %.8.i34.i352.i.i = and <8 x i64> %.1099.i348.i.i, splat (i64 1)
  %60 = icmp eq <8 x i64> %.8.i34.i352.i.i, zeroinitializer
  %.6.i36.i353.i.i = select <8 x i1> %60, <8 x i64> zeroinitializer, <8 x i64> %.6.i33.i351.i.i
  %.8.i37.i354.i.i = shl <8 x i64> %.1099.i348.i.i, splat (i64 62)
  %.8.i38.i355.i.i = and <8 x i64> %.8.i37.i354.i.i, splat (i64 -9223372036854775808)
  %.8.i40.i356.i.i = add <8 x i64> %.8.i37.i354.i.i, splat (i64 4611686018427387904)
  %.8.i41.i357.i.i = and <8 x i64> %.8.i40.i356.i.i, splat (i64 -9223372036854775808)
  %61 = xor <8 x i64> %.8.i38.i355.i.i, %.1100.i349.i.i
  %.6.i43.i358.i.i = xor <8 x i64> %61, %.6.i36.i353.i.i
  %62 = xor <8 x i64> %.8.i41.i357.i.i, %.1101.i350.i.i
  %.6.i45.i359.i.i = xor <8 x i64> %62, %.6.i36.i353.i.i
  store <8 x i64> %.6.i43.i358.i.i, ptr %sunkaddr51.i.i, align 8, !noalias !30
  store <8 x i64> %.6.i45.i359.i.i, ptr %sunkaddr52.i.i, align 8, !noalias !30
  %.6.i46.i364.i.i = fmul contract <8 x double> %.6.i28.i323.i.i, %.1466.i222.i.i
  %.1498.i365.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i46.i364.i.i, <8 x double> splat (double 0x3FE45F306DC9C883), <8 x double> splat (double 0x4338000000000000))
  %.8.i47.i366.i.i = fadd contract <8 x double> %.1498.i365.i.i, splat (double 0xC338000000000000)
  %.1539.i367.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i47.i366.i.i, <8 x double> splat (double 0xBFF921FB54442D18), <8 x double> %.6.i46.i364.i.i)
  %.1556.i368.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i47.i366.i.i, <8 x double> splat (double 0xBC91A62633145C07), <8 x double> %.1539.i367.i.i)
  %.6.i48.i369.i.i = fmul contract <8 x double> %.1556.i368.i.i, %.1556.i368.i.i
  %.6.i49.i370.i.i = fmul contract <8 x double> %.1556.i368.i.i, %.6.i48.i369.i.i
  %.1585.i371.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i48.i369.i.i, <8 x double> splat (double 0xBD6AE7F3E733B81F), <8 x double> splat (double 0x3DE6124613A86D09))
  %.1588.i372.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i48.i369.i.i, <8 x double> %.1585.i371.i.i, <8 x double> splat (double 0xBE5AE64567F544E4))
  %.1591.i373.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i48.i369.i.i, <8 x double> %.1588.i372.i.i, <8 x double> splat (double 0x3EC71DE3A556C734))
  %.1594.i374.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i48.i369.i.i, <8 x double> %.1591.i373.i.i, <8 x double> splat (double 0xBF2A01A01A01A01A))
  %.1597.i375.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i48.i369.i.i, <8 x double> %.1594.i374.i.i, <8 x double> splat (double 0x3F81111111111111))
  %.1600.i376.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i48.i369.i.i, <8 x double> %.1597.i375.i.i, <8 x double> splat (double 0xBFC5555555555555))
  %.1625.i377.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i49.i370.i.i, <8 x double> %.1600.i376.i.i, <8 x double> %.1556.i368.i.i)
  %.1630.i378.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i48.i369.i.i, <8 x double> splat (double 0x3D2AE7F3E733B81F), <8 x double> splat (double 0xBDA93974A8C07C9D))
  %.1633.i379.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i48.i369.i.i, <8 x double> %.1630.i378.i.i, <8 x double> splat (double 0x3E21EED8EFF8D898))
  %.1636.i380.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i48.i369.i.i, <8 x double> %.1633.i379.i.i, <8 x double> splat (double 0xBE927E4FB7789F5C))
  %.1639.i381.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i48.i369.i.i, <8 x double> %.1636.i380.i.i, <8 x double> splat (double 0x3EFA01A01A01A01A))
  %.1642.i382.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i48.i369.i.i, <8 x double> %.1639.i381.i.i, <8 x double> splat (double 0xBF56C16C16C16C17))
  %.1645.i383.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i48.i369.i.i, <8 x double> %.1642.i382.i.i, <8 x double> splat (double 0x3FA5555555555555))
  %.1648.i384.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i48.i369.i.i, <8 x double> %.1645.i383.i.i, <8 x double> splat (double -5.000000e-01))
  %.1651.i385.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i48.i369.i.i, <8 x double> %.1648.i384.i.i, <8 x double> splat (double 1.000000e+00))
  %.1652.i386.i.i = bitcast <8 x double> %.1498.i365.i.i to <8 x i64>
  %.1653.i387.i.i = bitcast <8 x double> %.1625.i377.i.i to <8 x i64>
  %.1654.i388.i.i = bitcast <8 x double> %.1651.i385.i.i to <8 x i64>
  %.6.i50.i389.i.i = xor <8 x i64> %.1654.i388.i.i, %.1653.i387.i.i
  %.8.i51.i390.i.i = and <8 x i64> %.1652.i386.i.i, splat (i64 1)
  %63 = icmp eq <8 x i64> %.8.i51.i390.i.i, zeroinitializer
  %.6.i53.i391.i.i = select <8 x i1> %63, <8 x i64> zeroinitializer, <8 x i64> %.6.i50.i389.i.i
  %.8.i54.i392.i.i = shl <8 x i64> %.1652.i386.i.i, splat (i64 62)
  %.8.i55.i393.i.i = and <8 x i64> %.8.i54.i392.i.i, splat (i64 -9223372036854775808)
  %.8.i57.i394.i.i = add <8 x i64> %.8.i54.i392.i.i, splat (i64 4611686018427387904)
  %.8.i58.i395.i.i = and <8 x i64> %.8.i57.i394.i.i, splat (i64 -9223372036854775808)
  %64 = xor <8 x i64> %.8.i55.i393.i.i, %.1653.i387.i.i
  %.6.i60.i396.i.i = xor <8 x i64> %64, %.6.i53.i391.i.i
  %65 = xor <8 x i64> %.8.i58.i395.i.i, %.1654.i388.i.i
  %.6.i62.i397.i.i = xor <8 x i64> %65, %.6.i53.i391.i.i
  store <8 x i64> %.6.i60.i396.i.i, ptr %sunkaddr53.i.i, align 8, !noalias !30
  store <8 x i64> %.6.i62.i397.i.i, ptr %sunkaddr54.i.i, align 8, !noalias !30
  %.8.i400.i.i = fmul contract <8 x double> %.1716.i.i, splat (double 0x3FC5555555555555)
  br label %B4295.if.i.i

B4295.if.i.i:                                     ; preds = %B4295.if.i.i, %B986.if.i.i
  %lsr.iv11.i.i = phi i64 [ %lsr.iv.next12.i.i, %B4295.if.i.i ], [ 13, %B986.if.i.i ]
  %lsr.iv511.i.i = phi ptr [ %scevgep.i.i, %B4295.if.i.i ], [ %scevgep53.i.i, %B986.if.i.i ]
  %scevgep513.i.i = getelementptr i8, ptr %lsr.iv511.i.i, i64 640
  %.2101.i.i = load <8 x double>, ptr %scevgep513.i.i, align 8, !noalias !21
  %.2111.i.i = load <8 x double>, ptr %lsr.iv511.i.i, align 8, !noalias !21
  %.2113.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i400.i.i, <8 x double> %.2101.i.i, <8 x double> %.2111.i.i)
  %scevgep512.i.i = getelementptr i8, ptr %lsr.iv511.i.i, i64 1920
  store <8 x double> %.2113.i.i, ptr %scevgep512.i.i, align 8, !noalias !21
  %scevgep.i.i = getelementptr i8, ptr %lsr.iv511.i.i, i64 64
  %lsr.iv.next12.i.i = add nsw i64 %lsr.iv11.i.i, -1
  %.2054.i.i = icmp samesign ugt i64 %lsr.iv11.i.i, 4
  br i1 %.2054.i.i, label %B4295.if.i.i, label %B4482.if.preheader.i.i

B4482.if.preheader.i.i:                           ; preds = %B4295.if.i.i
  %.8.i.i.i = fmul contract <8 x double> %.1716.i.i, splat (double 5.000000e-01)
  br label %B4482.if.i.i

B4482.if.i.i:                                     ; preds = %B4482.if.i.i, %B4482.if.preheader.i.i
  %lsr.iv13.i.i = phi i64 [ %lsr.iv.next14.i.i, %B4482.if.i.i ], [ 13, %B4482.if.preheader.i.i ]
  %lsr.iv516.i.i = phi ptr [ %scevgep517.i.i, %B4482.if.i.i ], [ %.474.i.i, %B4482.if.preheader.i.i ]
  %scevgep519.i.i = getelementptr i8, ptr %lsr.iv516.i.i, i64 -640
  %.2307.i.i = load <8 x double>, ptr %scevgep519.i.i, align 8, !noalias !21
  %scevgep518.i.i = getelementptr i8, ptr %lsr.iv516.i.i, i64 -1280
  %.2317.i.i = load <8 x double>, ptr %scevgep518.i.i, align 8, !noalias !21
  %.2319.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i.i.i, <8 x double> %.2307.i.i, <8 x double> %.2317.i.i)
  store <8 x double> %.2319.i.i, ptr %lsr.iv516.i.i, align 8, !noalias !21
  %scevgep517.i.i = getelementptr i8, ptr %lsr.iv516.i.i, i64 64
  %lsr.iv.next14.i.i = add nsw i64 %lsr.iv13.i.i, -1
  %.2260.i.i = icmp samesign ugt i64 %lsr.iv13.i.i, 4
  br i1 %.2260.i.i, label %B4482.if.i.i, label %B4545.i.i

B4669.if.i.i:                                     ; preds = %B4669.if.i.i, %B4545.i.i
  %lsr.iv.i13.i = phi i64 [ %lsr.iv.next.i14.i, %B4669.if.i.i ], [ 13, %B4545.i.i ]
  %lsr.iv522.i.i = phi ptr [ %scevgep523.i.i, %B4669.if.i.i ], [ %.539.i.i, %B4545.i.i ]
  %scevgep524.i.i = getelementptr i8, ptr %lsr.iv522.i.i, i64 -1280
  %.2574.i.i = load <8 x double>, ptr %scevgep524.i.i, align 8, !noalias !21
  %.2584.i.i = load <8 x double>, ptr %lsr.iv522.i.i, align 8, !noalias !21
  %.2586.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i401.i.i, <8 x double> %.2574.i.i, <8 x double> %.2584.i.i)
  store <8 x double> %.2586.i.i, ptr %lsr.iv522.i.i, align 8, !noalias !21
  %scevgep523.i.i = getelementptr i8, ptr %lsr.iv522.i.i, i64 64
  %lsr.iv.next.i14.i = add nsw i64 %lsr.iv.i13.i, -1
  %.2527.i.i = icmp samesign ugt i64 %lsr.iv.i13.i, 4
  br i1 %.2527.i.i, label %B4669.if.i.i, label %B4856.if.i.i

B4856.if.i.i:                                     ; preds = %B4669.if.i.i, %B4856.if.i.i
  %lsr.iv15.i.i = phi i64 [ %lsr.iv.next16.i.i, %B4856.if.i.i ], [ 13, %B4669.if.i.i ]
  %lsr.iv527.i.i = phi ptr [ %scevgep528.i.i, %B4856.if.i.i ], [ %.474.i.i, %B4669.if.i.i ]
  %scevgep530.i.i = getelementptr i8, ptr %lsr.iv527.i.i, i64 -640
  %.2782.i.i = load <8 x double>, ptr %scevgep530.i.i, align 8, !noalias !21
  %scevgep529.i.i = getelementptr i8, ptr %lsr.iv527.i.i, i64 -1280
  %.2792.i.i = load <8 x double>, ptr %scevgep529.i.i, align 8, !noalias !21
  %.2794.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i.i.i, <8 x double> %.2782.i.i, <8 x double> %.2792.i.i)
  store <8 x double> %.2794.i.i, ptr %lsr.iv527.i.i, align 8, !noalias !21
  %scevgep528.i.i = getelementptr i8, ptr %lsr.iv527.i.i, i64 64
  %lsr.iv.next16.i.i = add nsw i64 %lsr.iv15.i.i, -1
  %.2735.i.i = icmp samesign ugt i64 %lsr.iv15.i.i, 4
  br i1 %.2735.i.i, label %B4856.if.i.i, label %B4919.i.i

B5043.if.i.i:                                     ; preds = %B5043.if.i.i, %B4919.i.i
  %lsr.iv17.i.i = phi i64 [ 13, %B4919.i.i ], [ %lsr.iv.next18.i.i, %B5043.if.i.i ]
  %lsr.iv533.i.i = phi ptr [ %.539.i.i, %B4919.i.i ], [ %scevgep534.i.i, %B5043.if.i.i ]
  %scevgep535.i.i = getelementptr i8, ptr %lsr.iv533.i.i, i64 -1280
  %.3054.i.i = load <8 x double>, ptr %scevgep535.i.i, align 8, !noalias !21
  %.3064.i.i = load <8 x double>, ptr %lsr.iv533.i.i, align 8, !noalias !21
  %.3066.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i401.i.i, <8 x double> %.3054.i.i, <8 x double> %.3064.i.i)
  store <8 x double> %.3066.i.i, ptr %lsr.iv533.i.i, align 8, !noalias !21
  %scevgep534.i.i = getelementptr i8, ptr %lsr.iv533.i.i, i64 64
  %lsr.iv.next18.i.i = add nsw i64 %lsr.iv17.i.i, -1
  %.3007.i.i = icmp samesign ugt i64 %lsr.iv17.i.i, 4
  br i1 %.3007.i.i, label %B5043.if.i.i, label %B5230.if.i.i

B5230.if.i.i:                                     ; preds = %B5043.if.i.i, %B5230.if.i.i
  %lsr.iv19.i.i = phi i64 [ %lsr.iv.next20.i.i, %B5230.if.i.i ], [ 13, %B5043.if.i.i ]
  %lsr.iv538.i.i = phi ptr [ %scevgep539.i.i, %B5230.if.i.i ], [ %.474.i.i, %B5043.if.i.i ]
  %scevgep541.i.i = getelementptr i8, ptr %lsr.iv538.i.i, i64 -640
  %.3260.i.i = load <8 x double>, ptr %scevgep541.i.i, align 8, !noalias !21
  %scevgep540.i.i = getelementptr i8, ptr %lsr.iv538.i.i, i64 -1280
  %.3270.i.i = load <8 x double>, ptr %scevgep540.i.i, align 8, !noalias !21
  %.3272.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1716.i.i, <8 x double> %.3260.i.i, <8 x double> %.3270.i.i)
  store <8 x double> %.3272.i.i, ptr %lsr.iv538.i.i, align 8, !noalias !21
  %scevgep539.i.i = getelementptr i8, ptr %lsr.iv538.i.i, i64 64
  %lsr.iv.next20.i.i = add nsw i64 %lsr.iv19.i.i, -1
  %.3213.i.i = icmp samesign ugt i64 %lsr.iv19.i.i, 4
  br i1 %.3213.i.i, label %B5230.if.i.i, label %B5293.i.i

B5417.if.i.i:                                     ; preds = %B5417.if.i.i, %B5293.i.i
  %lsr.iv21.i.i = phi i64 [ %lsr.iv.next22.i.i, %B5417.if.i.i ], [ 13, %B5293.i.i ]
  %lsr.iv544.i.i = phi ptr [ %scevgep545.i.i, %B5417.if.i.i ], [ %scevgep53.i.i, %B5293.i.i ]
  %scevgep547.i.i = getelementptr i8, ptr %lsr.iv544.i.i, i64 640
  %.3559.i.i = load <8 x double>, ptr %scevgep547.i.i, align 8, !noalias !21
  %scevgep546.i.i = getelementptr i8, ptr %lsr.iv544.i.i, i64 1920
  %.3569.i.i = load <8 x double>, ptr %scevgep546.i.i, align 8, !noalias !21
  %.3571.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i400.i.i, <8 x double> %.3559.i.i, <8 x double> %.3569.i.i)
  store <8 x double> %.3571.i.i, ptr %lsr.iv544.i.i, align 8, !noalias !21
  %scevgep545.i.i = getelementptr i8, ptr %lsr.iv544.i.i, i64 64
  %lsr.iv.next22.i.i = add nsw i64 %lsr.iv21.i.i, -1
  %.3512.i.i = icmp samesign ugt i64 %lsr.iv21.i.i, 4
  br i1 %.3512.i.i, label %B5417.if.i.i, label %B5516.i.i

_ZN17bnserve_surrogate10precession9_dynamics6followB3v36B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIxLi1E1C7mutable7alignedE23Literal_5bint_5d_280_295ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx.exit.i: ; preds = %B5516.i.i, %_ZN17bnserve_surrogate10precession7_source8_prepareB3v15B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExx5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i
  call void @llvm.lifetime.end.p0(ptr nonnull %.1111.i.i), !noalias !0
  call void @llvm.lifetime.end.p0(ptr nonnull %.2357.i.i), !noalias !0
  call void @llvm.lifetime.end.p0(ptr nonnull %.2832.i.i), !noalias !0
  call void @llvm.lifetime.end.p0(ptr nonnull %.3310.i.i), !noalias !0
  call void @llvm.lifetime.end.p0(ptr nonnull %.3609.i.i), !noalias !0
  call void @llvm.lifetime.start.p0(ptr nonnull %.1111.i15.i), !noalias !0
  call void @llvm.lifetime.start.p0(ptr nonnull %.2357.i17.i), !noalias !0
  call void @llvm.lifetime.start.p0(ptr nonnull %.2832.i19.i), !noalias !0
  call void @llvm.lifetime.start.p0(ptr nonnull %.3310.i21.i), !noalias !0
  call void @llvm.lifetime.start.p0(ptr nonnull %.3609.i23.i), !noalias !0
  store ptr null, ptr %.1111.i15.i, align 8, !noalias !33
  store ptr null, ptr %.2357.i17.i, align 8, !noalias !33
  store ptr null, ptr %.2832.i19.i, align 8, !noalias !33
  store ptr null, ptr %.3310.i21.i, align 8, !noalias !33
  store ptr null, ptr %.3609.i23.i, align 8, !noalias !33
  %.836.7.i25.i = load i64, ptr %16, align 8, !noalias !33
  %.836.6.i26.i = load i64, ptr %15, align 8, !noalias !33
  %.836.5.i27.i = load i64, ptr %14, align 8, !noalias !33
  %.836.4.i28.i = load i64, ptr %13, align 8, !noalias !33
  %.836.3.i29.i = load i64, ptr %12, align 8, !noalias !33
  %.836.2.i30.i = load i64, ptr %11, align 8, !noalias !33
  %.836.1.i31.i = load i64, ptr %10, align 8, !noalias !33
  %.836.i32.i = load i64, ptr %9, align 8, !noalias !33
  %.1019.i33.i = load double, ptr %.171.i, align 8, !noalias !33
  store double %.1019.i33.i, ptr %scevgep53.i.i, align 8, !noalias !33
  %.1019.1.i36.i = load double, ptr %sunkaddr57.i.i, align 8, !noalias !33
  store double %.1019.1.i36.i, ptr %scevgep51.i.i, align 8, !noalias !33
  %.1019.2.i39.i = load double, ptr %sunkaddr60.i.i, align 8, !noalias !33
  store double %.1019.2.i39.i, ptr %scevgep49.i.i, align 8, !noalias !33
  %.1019.3.i42.i = load double, ptr %sunkaddr63.i.i, align 8, !noalias !33
  store double %.1019.3.i42.i, ptr %scevgep47.i.i, align 8, !noalias !33
  %.1019.4.i45.i = load double, ptr %sunkaddr66.i.i, align 8, !noalias !33
  store double %.1019.4.i45.i, ptr %scevgep45.i.i, align 8, !noalias !33
  %.1019.11.i48.i = load double, ptr %sunkaddr69.i.i, align 8, !noalias !33
  store double %.1019.11.i48.i, ptr %scevgep43.i.i, align 8, !noalias !33
  %.1019.1.1.i51.i = load double, ptr %sunkaddr72.i.i, align 8, !noalias !33
  store double %.1019.1.1.i51.i, ptr %scevgep41.i.i, align 8, !noalias !33
  %.1019.2.1.i54.i = load double, ptr %sunkaddr75.i.i, align 8, !noalias !33
  store double %.1019.2.1.i54.i, ptr %scevgep39.i.i, align 8, !noalias !33
  %.1019.3.1.i57.i = load double, ptr %sunkaddr78.i.i, align 8, !noalias !33
  store double %.1019.3.1.i57.i, ptr %scevgep37.i.i, align 8, !noalias !33
  %.1019.4.1.i60.i = load double, ptr %sunkaddr81.i.i, align 8, !noalias !33
  store double %.1019.4.1.i60.i, ptr %scevgep35.i.i, align 8, !noalias !33
  %.1019.12.i63.i = load double, ptr %sunkaddr54.1.i.i, align 8, !noalias !33
  store double %.1019.12.i63.i, ptr %scevgep53.1.i.i, align 8, !noalias !33
  %.1019.1.13.i66.i = load double, ptr %sunkaddr57.1.i.i, align 8, !noalias !33
  store double %.1019.1.13.i66.i, ptr %scevgep51.1.i.i, align 8, !noalias !33
  %.1019.2.14.i69.i = load double, ptr %sunkaddr60.1.i.i, align 8, !noalias !33
  store double %.1019.2.14.i69.i, ptr %scevgep49.1.i.i, align 8, !noalias !33
  %.1019.3.15.i72.i = load double, ptr %sunkaddr63.1.i.i, align 8, !noalias !33
  store double %.1019.3.15.i72.i, ptr %scevgep47.1.i.i, align 8, !noalias !33
  %.1019.4.16.i75.i = load double, ptr %sunkaddr66.1.i.i, align 8, !noalias !33
  store double %.1019.4.16.i75.i, ptr %scevgep45.1.i.i, align 8, !noalias !33
  %.1019.11.1.i78.i = load double, ptr %sunkaddr69.1.i.i, align 8, !noalias !33
  store double %.1019.11.1.i78.i, ptr %scevgep43.1.i.i, align 8, !noalias !33
  %.1019.1.1.1.i81.i = load double, ptr %sunkaddr72.1.i.i, align 8, !noalias !33
  store double %.1019.1.1.1.i81.i, ptr %scevgep41.1.i.i, align 8, !noalias !33
  %.1019.2.1.1.i84.i = load double, ptr %sunkaddr75.1.i.i, align 8, !noalias !33
  store double %.1019.2.1.1.i84.i, ptr %scevgep39.1.i.i, align 8, !noalias !33
  %.1019.3.1.1.i87.i = load double, ptr %sunkaddr78.1.i.i, align 8, !noalias !33
  store double %.1019.3.1.1.i87.i, ptr %scevgep37.1.i.i, align 8, !noalias !33
  %.1019.4.1.1.i90.i = load double, ptr %sunkaddr81.1.i.i, align 8, !noalias !33
  store double %.1019.4.1.1.i90.i, ptr %scevgep35.1.i.i, align 8, !noalias !33
  %.1019.27.i93.i = load double, ptr %sunkaddr54.2.i.i, align 8, !noalias !33
  store double %.1019.27.i93.i, ptr %scevgep53.2.i.i, align 8, !noalias !33
  %.1019.1.2.i96.i = load double, ptr %sunkaddr57.2.i.i, align 8, !noalias !33
  store double %.1019.1.2.i96.i, ptr %scevgep51.2.i.i, align 8, !noalias !33
  %.1019.2.2.i99.i = load double, ptr %sunkaddr60.2.i.i, align 8, !noalias !33
  store double %.1019.2.2.i99.i, ptr %scevgep49.2.i.i, align 8, !noalias !33
  %.1019.3.2.i102.i = load double, ptr %sunkaddr63.2.i.i, align 8, !noalias !33
  store double %.1019.3.2.i102.i, ptr %scevgep47.2.i.i, align 8, !noalias !33
  %.1019.4.2.i105.i = load double, ptr %sunkaddr66.2.i.i, align 8, !noalias !33
  store double %.1019.4.2.i105.i, ptr %scevgep45.2.i.i, align 8, !noalias !33
  %.1019.11.2.i108.i = load double, ptr %sunkaddr69.2.i.i, align 8, !noalias !33
  store double %.1019.11.2.i108.i, ptr %scevgep43.2.i.i, align 8, !noalias !33
  %.1019.1.1.2.i111.i = load double, ptr %sunkaddr72.2.i.i, align 8, !noalias !33
  store double %.1019.1.1.2.i111.i, ptr %scevgep41.2.i.i, align 8, !noalias !33
  %.1019.2.1.2.i114.i = load double, ptr %sunkaddr75.2.i.i, align 8, !noalias !33
  store double %.1019.2.1.2.i114.i, ptr %scevgep39.2.i.i, align 8, !noalias !33
  %.1019.3.1.2.i117.i = load double, ptr %sunkaddr78.2.i.i, align 8, !noalias !33
  store double %.1019.3.1.2.i117.i, ptr %scevgep37.2.i.i, align 8, !noalias !33
  %.1019.4.1.2.i120.i = load double, ptr %sunkaddr81.2.i.i, align 8, !noalias !33
  store double %.1019.4.1.2.i120.i, ptr %scevgep35.2.i.i, align 8, !noalias !33
  %.1019.38.i123.i = load double, ptr %sunkaddr54.3.i.i, align 8, !noalias !33
  store double %.1019.38.i123.i, ptr %scevgep53.3.i.i, align 8, !noalias !33
  %.1019.1.3.i126.i = load double, ptr %sunkaddr57.3.i.i, align 8, !noalias !33
  store double %.1019.1.3.i126.i, ptr %scevgep51.3.i.i, align 8, !noalias !33
  %.1019.2.3.i129.i = load double, ptr %sunkaddr60.3.i.i, align 8, !noalias !33
  store double %.1019.2.3.i129.i, ptr %scevgep49.3.i.i, align 8, !noalias !33
  %.1019.3.3.i132.i = load double, ptr %sunkaddr63.3.i.i, align 8, !noalias !33
  store double %.1019.3.3.i132.i, ptr %scevgep47.3.i.i, align 8, !noalias !33
  %.1019.4.3.i135.i = load double, ptr %sunkaddr66.3.i.i, align 8, !noalias !33
  store double %.1019.4.3.i135.i, ptr %scevgep45.3.i.i, align 8, !noalias !33
  %.1019.11.3.i138.i = load double, ptr %sunkaddr69.3.i.i, align 8, !noalias !33
  store double %.1019.11.3.i138.i, ptr %scevgep43.3.i.i, align 8, !noalias !33
  %.1019.1.1.3.i141.i = load double, ptr %sunkaddr72.3.i.i, align 8, !noalias !33
  store double %.1019.1.1.3.i141.i, ptr %scevgep41.3.i.i, align 8, !noalias !33
  %.1019.2.1.3.i144.i = load double, ptr %sunkaddr75.3.i.i, align 8, !noalias !33
  store double %.1019.2.1.3.i144.i, ptr %scevgep39.3.i.i, align 8, !noalias !33
  %.1019.3.1.3.i147.i = load double, ptr %sunkaddr78.3.i.i, align 8, !noalias !33
  store double %.1019.3.1.3.i147.i, ptr %scevgep37.3.i.i, align 8, !noalias !33
  %.1019.4.1.3.i150.i = load double, ptr %sunkaddr81.3.i.i, align 8, !noalias !33
  store double %.1019.4.1.3.i150.i, ptr %scevgep35.3.i.i, align 8, !noalias !33
  %.1019.49.i153.i = load double, ptr %sunkaddr54.4.i.i, align 8, !noalias !33
  store double %.1019.49.i153.i, ptr %scevgep53.4.i.i, align 8, !noalias !33
  %.1019.1.4.i156.i = load double, ptr %sunkaddr57.4.i.i, align 8, !noalias !33
  store double %.1019.1.4.i156.i, ptr %scevgep51.4.i.i, align 8, !noalias !33
  %.1019.2.4.i159.i = load double, ptr %sunkaddr60.4.i.i, align 8, !noalias !33
  store double %.1019.2.4.i159.i, ptr %scevgep49.4.i.i, align 8, !noalias !33
  %.1019.3.4.i162.i = load double, ptr %sunkaddr63.4.i.i, align 8, !noalias !33
  store double %.1019.3.4.i162.i, ptr %scevgep47.4.i.i, align 8, !noalias !33
  %.1019.4.4.i165.i = load double, ptr %sunkaddr66.4.i.i, align 8, !noalias !33
  store double %.1019.4.4.i165.i, ptr %scevgep45.4.i.i, align 8, !noalias !33
  %.1019.11.4.i168.i = load double, ptr %sunkaddr69.4.i.i, align 8, !noalias !33
  store double %.1019.11.4.i168.i, ptr %scevgep43.4.i.i, align 8, !noalias !33
  %.1019.1.1.4.i171.i = load double, ptr %sunkaddr72.4.i.i, align 8, !noalias !33
  store double %.1019.1.1.4.i171.i, ptr %scevgep41.4.i.i, align 8, !noalias !33
  %.1019.2.1.4.i174.i = load double, ptr %sunkaddr75.4.i.i, align 8, !noalias !33
  store double %.1019.2.1.4.i174.i, ptr %scevgep39.4.i.i, align 8, !noalias !33
  %.1019.3.1.4.i177.i = load double, ptr %sunkaddr78.4.i.i, align 8, !noalias !33
  store double %.1019.3.1.4.i177.i, ptr %scevgep37.4.i.i, align 8, !noalias !33
  %.1019.4.1.4.i180.i = load double, ptr %sunkaddr81.4.i.i, align 8, !noalias !33
  store double %.1019.4.1.4.i180.i, ptr %scevgep35.4.i.i, align 8, !noalias !33
  %.1019.5.i183.i = load double, ptr %sunkaddr54.5.i.i, align 8, !noalias !33
  store double %.1019.5.i183.i, ptr %scevgep53.5.i.i, align 8, !noalias !33
  %.1019.1.5.i186.i = load double, ptr %sunkaddr57.5.i.i, align 8, !noalias !33
  store double %.1019.1.5.i186.i, ptr %scevgep51.5.i.i, align 8, !noalias !33
  %.1019.2.5.i189.i = load double, ptr %sunkaddr60.5.i.i, align 8, !noalias !33
  store double %.1019.2.5.i189.i, ptr %scevgep49.5.i.i, align 8, !noalias !33
  %.1019.3.5.i192.i = load double, ptr %sunkaddr63.5.i.i, align 8, !noalias !33
  store double %.1019.3.5.i192.i, ptr %scevgep47.5.i.i, align 8, !noalias !33
  %.1019.4.5.i195.i = load double, ptr %sunkaddr66.5.i.i, align 8, !noalias !33
  store double %.1019.4.5.i195.i, ptr %scevgep45.5.i.i, align 8, !noalias !33
  %.1019.11.5.i198.i = load double, ptr %sunkaddr69.5.i.i, align 8, !noalias !33
  store double %.1019.11.5.i198.i, ptr %scevgep43.5.i.i, align 8, !noalias !33
  %.1019.1.1.5.i201.i = load double, ptr %sunkaddr72.5.i.i, align 8, !noalias !33
  store double %.1019.1.1.5.i201.i, ptr %scevgep41.5.i.i, align 8, !noalias !33
  %.1019.2.1.5.i204.i = load double, ptr %sunkaddr75.5.i.i, align 8, !noalias !33
  store double %.1019.2.1.5.i204.i, ptr %scevgep39.5.i.i, align 8, !noalias !33
  %.1019.3.1.5.i207.i = load double, ptr %sunkaddr78.5.i.i, align 8, !noalias !33
  store double %.1019.3.1.5.i207.i, ptr %scevgep37.5.i.i, align 8, !noalias !33
  %.1019.4.1.5.i210.i = load double, ptr %sunkaddr81.5.i.i, align 8, !noalias !33
  store double %.1019.4.1.5.i210.i, ptr %scevgep35.5.i.i, align 8, !noalias !33
  %.1019.6.i213.i = load double, ptr %sunkaddr54.6.i.i, align 8, !noalias !33
  store double %.1019.6.i213.i, ptr %scevgep53.6.i.i, align 8, !noalias !33
  %.1019.1.6.i216.i = load double, ptr %sunkaddr57.6.i.i, align 8, !noalias !33
  store double %.1019.1.6.i216.i, ptr %scevgep51.6.i.i, align 8, !noalias !33
  %.1019.2.6.i219.i = load double, ptr %sunkaddr60.6.i.i, align 8, !noalias !33
  store double %.1019.2.6.i219.i, ptr %scevgep49.6.i.i, align 8, !noalias !33
  %.1019.3.6.i222.i = load double, ptr %sunkaddr63.6.i.i, align 8, !noalias !33
  store double %.1019.3.6.i222.i, ptr %scevgep47.6.i.i, align 8, !noalias !33
  %.1019.4.6.i225.i = load double, ptr %sunkaddr66.6.i.i, align 8, !noalias !33
  store double %.1019.4.6.i225.i, ptr %scevgep45.6.i.i, align 8, !noalias !33
  %.1019.11.6.i228.i = load double, ptr %sunkaddr69.6.i.i, align 8, !noalias !33
  store double %.1019.11.6.i228.i, ptr %scevgep43.6.i.i, align 8, !noalias !33
  %.1019.1.1.6.i231.i = load double, ptr %sunkaddr72.6.i.i, align 8, !noalias !33
  store double %.1019.1.1.6.i231.i, ptr %scevgep41.6.i.i, align 8, !noalias !33
  %.1019.2.1.6.i234.i = load double, ptr %sunkaddr75.6.i.i, align 8, !noalias !33
  store double %.1019.2.1.6.i234.i, ptr %scevgep39.6.i.i, align 8, !noalias !33
  %.1019.3.1.6.i237.i = load double, ptr %sunkaddr78.6.i.i, align 8, !noalias !33
  store double %.1019.3.1.6.i237.i, ptr %scevgep37.6.i.i, align 8, !noalias !33
  %.1019.4.1.6.i240.i = load double, ptr %sunkaddr81.6.i.i, align 8, !noalias !33
  store double %.1019.4.1.6.i240.i, ptr %scevgep35.6.i.i, align 8, !noalias !33
  %.1019.7.i243.i = load double, ptr %sunkaddr54.7.i.i, align 8, !noalias !33
  store double %.1019.7.i243.i, ptr %scevgep53.7.i.i, align 8, !noalias !33
  %.1019.1.7.i246.i = load double, ptr %sunkaddr57.7.i.i, align 8, !noalias !33
  store double %.1019.1.7.i246.i, ptr %scevgep51.7.i.i, align 8, !noalias !33
  %.1019.2.7.i249.i = load double, ptr %sunkaddr60.7.i.i, align 8, !noalias !33
  store double %.1019.2.7.i249.i, ptr %scevgep49.7.i.i, align 8, !noalias !33
  %.1019.3.7.i252.i = load double, ptr %sunkaddr63.7.i.i, align 8, !noalias !33
  store double %.1019.3.7.i252.i, ptr %scevgep47.7.i.i, align 8, !noalias !33
  %.1019.4.7.i255.i = load double, ptr %sunkaddr66.7.i.i, align 8, !noalias !33
  store double %.1019.4.7.i255.i, ptr %scevgep45.7.i.i, align 8, !noalias !33
  %.1019.11.7.i258.i = load double, ptr %sunkaddr69.7.i.i, align 8, !noalias !33
  store double %.1019.11.7.i258.i, ptr %scevgep43.7.i.i, align 8, !noalias !33
  %.1019.1.1.7.i261.i = load double, ptr %sunkaddr72.7.i.i, align 8, !noalias !33
  store double %.1019.1.1.7.i261.i, ptr %scevgep41.7.i.i, align 8, !noalias !33
  %.1019.2.1.7.i264.i = load double, ptr %sunkaddr75.7.i.i, align 8, !noalias !33
  store double %.1019.2.1.7.i264.i, ptr %scevgep39.7.i.i, align 8, !noalias !33
  %.1019.3.1.7.i267.i = load double, ptr %sunkaddr78.7.i.i, align 8, !noalias !33
  store double %.1019.3.1.7.i267.i, ptr %scevgep37.7.i.i, align 8, !noalias !33
  %.1019.4.1.7.i270.i = load double, ptr %sunkaddr81.7.i.i, align 8, !noalias !33
  store double %.1019.4.1.7.i270.i, ptr %scevgep35.7.i.i, align 8, !noalias !33
  %.13.i.i277.i = tail call i64 @llvm.smax.i64(i64 %.836.i32.i, i64 %.836.1.i31.i)
  %.13.i111.i278.i = tail call i64 @llvm.smax.i64(i64 %.13.i.i277.i, i64 %.836.2.i30.i)
  %.13.i112.i279.i = tail call i64 @llvm.smax.i64(i64 %.13.i111.i278.i, i64 %.836.3.i29.i)
  %.13.i113.i280.i = tail call i64 @llvm.smax.i64(i64 %.13.i112.i279.i, i64 %.836.4.i28.i)
  %.13.i114.i281.i = tail call i64 @llvm.smax.i64(i64 %.13.i113.i280.i, i64 %.836.5.i27.i)
  %.13.i115.i282.i = tail call i64 @llvm.smax.i64(i64 %.13.i114.i281.i, i64 %.836.6.i26.i)
  %.13.i116.i283.i = tail call i64 @llvm.smax.i64(i64 %.13.i115.i282.i, i64 %.836.7.i25.i)
  %.1070.i285.i = load <8 x double>, ptr %.1068.i.i, align 8, !noalias !33
  %.38.i.i286.i = load <8 x double>, ptr %.49.i, align 8, !noalias !36
  %.8.i.i.i287.i = fadd contract <8 x double> %.1070.i285.i, splat (double 1.600000e+01)
  %.8.i1.i.i288.i = fdiv contract <8 x double> splat (double 1.000000e+00), %.8.i.i.i287.i
  %.6.i.i.i289.i = fmul contract <8 x double> %.1070.i285.i, %.38.i.i286.i
  %.6.i2.i.i290.i = fmul contract <8 x double> %.1070.i285.i, %.6.i.i.i289.i
  %.6.i3.i.i291.i = fmul contract <8 x double> %.8.i1.i.i288.i, %.6.i2.i.i290.i
  %.162.i.i292.i = bitcast <8 x double> %.6.i3.i.i291.i to <8 x i64>
  %.8.i4.i.i293.i = ashr <8 x i64> %.162.i.i292.i, splat (i64 52)
  %.8.i5.i.i294.i = add nsw <8 x i64> %.8.i4.i.i293.i, splat (i64 4841369599423283200)
  %66 = bitcast <8 x i64> %.8.i5.i.i294.i to <8 x double>
  %.8.i6.i.i295.i = fadd contract <8 x double> %66, splat (double 0xC3300000000003FF)
  %.8.i7.i.i296.i = and <8 x i64> %.162.i.i292.i, splat (i64 4503599627370495)
  %.8.i8.i.i297.i = or disjoint <8 x i64> %.8.i7.i.i296.i, splat (i64 4607182418800017408)
  %67 = bitcast <8 x i64> %.8.i8.i.i297.i to <8 x double>
  %.8.i9.i.i298.i = fadd contract <8 x double> %67, splat (double -1.000000e+00)
  %.8.i10.i.i299.i = fadd contract <8 x double> %67, splat (double 1.000000e+00)
  %.6.i11.i.i300.i = fdiv contract <8 x double> %.8.i9.i.i298.i, %.8.i10.i.i299.i
  %.6.i12.i.i301.i = fmul contract <8 x double> %.6.i11.i.i300.i, %.6.i11.i.i300.i
  %.385.i.i302.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i12.i.i301.i, <8 x double> splat (double 0x3FB642C8590B2164), <8 x double> splat (double 0x3FB8618618618618))
  %.388.i.i303.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i12.i.i301.i, <8 x double> %.385.i.i302.i, <8 x double> splat (double 0x3FBAF286BCA1AF28))
  %.391.i.i304.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i12.i.i301.i, <8 x double> %.388.i.i303.i, <8 x double> splat (double 0x3FBE1E1E1E1E1E1E))
  %.394.i.i305.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i12.i.i301.i, <8 x double> %.391.i.i304.i, <8 x double> splat (double 0x3FC1111111111111))
  %.397.i.i306.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i12.i.i301.i, <8 x double> %.394.i.i305.i, <8 x double> splat (double 0x3FC3B13B13B13B14))
  %.400.i.i307.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i12.i.i301.i, <8 x double> %.397.i.i306.i, <8 x double> splat (double 0x3FC745D1745D1746))
  %.403.i.i308.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i12.i.i301.i, <8 x double> %.400.i.i307.i, <8 x double> splat (double 0x3FCC71C71C71C71C))
  %.406.i.i309.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i12.i.i301.i, <8 x double> %.403.i.i308.i, <8 x double> splat (double 0x3FD2492492492492))
  %.409.i.i310.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i12.i.i301.i, <8 x double> %.406.i.i309.i, <8 x double> splat (double 4.000000e-01))
  %.412.i.i311.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i12.i.i301.i, <8 x double> %.409.i.i310.i, <8 x double> splat (double 0x3FE5555555555555))
  %.415.i.i312.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i12.i.i301.i, <8 x double> %.412.i.i311.i, <8 x double> splat (double 2.000000e+00))
  %.6.i13.i.i313.i = fmul contract <8 x double> %.6.i11.i.i300.i, %.415.i.i312.i
  %.442.i.i314.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i6.i.i295.i, <8 x double> splat (double 0x3FE62E42FEFA39EF), <8 x double> %.6.i13.i.i313.i)
  %.8.i15.i.i315.i = fadd contract <8 x double> %.1070.i285.i, splat (double 3.200000e+01)
  %.6.i16.i.i316.i = fmul contract <8 x double> %.8.i15.i.i315.i, %.6.i.i.i289.i
  %.6.i17.i.i317.i = fmul contract <8 x double> %.8.i1.i.i288.i, %.6.i16.i.i316.i
  %.6.i18.i.i318.i = fmul contract <8 x double> %.8.i1.i.i288.i, %.6.i17.i.i317.i
  store <8 x double> %.6.i18.i.i318.i, ptr %.252.i, align 8, !noalias !36
  %.8.i19.i.i319.i = fmul contract <8 x double> %.442.i.i314.i, splat (double 0xBFD5555555555555)
  %.604.i.i320.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i19.i.i319.i, <8 x double> splat (double 0x3FF71547652B82FE), <8 x double> splat (double 0x4338000000000000))
  %.8.i20.i.i321.i = fadd contract <8 x double> %.604.i.i320.i, splat (double 0xC338000000000000)
  %.633.i.i322.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i20.i.i321.i, <8 x double> splat (double 0xBFE62E42FEFA39EF), <8 x double> %.8.i19.i.i319.i)
  %.636.i.i323.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i20.i.i321.i, <8 x double> splat (double 0xBC7ABC9E3B39803F), <8 x double> %.633.i.i322.i)
  %.641.i.i324.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.636.i.i323.i, <8 x double> splat (double 0x3DE6124613A86D09), <8 x double> splat (double 0x3E21EED8EFF8D898))
  %.644.i.i325.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.636.i.i323.i, <8 x double> %.641.i.i324.i, <8 x double> splat (double 0x3E5AE64567F544E4))
  %.647.i.i326.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.636.i.i323.i, <8 x double> %.644.i.i325.i, <8 x double> splat (double 0x3E927E4FB7789F5C))
  %.650.i.i327.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.636.i.i323.i, <8 x double> %.647.i.i326.i, <8 x double> splat (double 0x3EC71DE3A556C734))
  %.653.i.i328.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.636.i.i323.i, <8 x double> %.650.i.i327.i, <8 x double> splat (double 0x3EFA01A01A01A01A))
  %.656.i.i329.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.636.i.i323.i, <8 x double> %.653.i.i328.i, <8 x double> splat (double 0x3F2A01A01A01A01A))
  %.659.i.i330.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.636.i.i323.i, <8 x double> %.656.i.i329.i, <8 x double> splat (double 0x3F56C16C16C16C17))
  %.662.i.i331.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.636.i.i323.i, <8 x double> %.659.i.i330.i, <8 x double> splat (double 0x3F81111111111111))
  %.665.i.i332.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.636.i.i323.i, <8 x double> %.662.i.i331.i, <8 x double> splat (double 0x3FA5555555555555))
  %.668.i.i333.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.636.i.i323.i, <8 x double> %.665.i.i332.i, <8 x double> splat (double 0x3FC5555555555555))
  %.671.i.i334.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.636.i.i323.i, <8 x double> %.668.i.i333.i, <8 x double> splat (double 5.000000e-01))
  %.6.i21.i.i335.i = fmul contract <8 x double> %.636.i.i323.i, %.636.i.i323.i
  %.8.i22.i.i336.i = fadd contract <8 x double> %.636.i.i323.i, splat (double 1.000000e+00)
  %.720.i.i337.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i21.i.i335.i, <8 x double> %.671.i.i334.i, <8 x double> %.8.i22.i.i336.i)
  %.721.i.i338.i = bitcast <8 x double> %.604.i.i320.i to <8 x i64>
  %.8.i23.i.i339.i = shl <8 x i64> %.721.i.i338.i, splat (i64 52)
  %.8.i24.i.i340.i = add <8 x i64> %.8.i23.i.i339.i, splat (i64 4607182418800017408)
  %68 = bitcast <8 x i64> %.8.i24.i.i340.i to <8 x double>
  %.6.i25.i.i341.i = fmul contract <8 x double> %.720.i.i337.i, %68
  store <8 x double> %.6.i25.i.i341.i, ptr %.801.i.i.i, align 8, !noalias !36
  %.8.i26.i.i343.i = fsub contract <8 x double> zeroinitializer, %.442.i.i314.i
  store <8 x double> %.8.i26.i.i343.i, ptr %.835.i.i10.i, align 8, !noalias !36
  %.847.i.i346.i = load <8 x double>, ptr %.845.i.i.i, align 8, !noalias !36
  %.6.i27.i.i347.i = fsub contract <8 x double> %.847.i.i346.i, %.6.i3.i.i291.i
  %.881.i.i349.i = load <8 x double>, ptr %.879.i.i.i, align 8, !noalias !36
  %.6.i28.i.i350.i = fmul contract <8 x double> %.6.i27.i.i347.i, %.881.i.i349.i
  %.916.i.i352.i = load <8 x double>, ptr %.914.i.i.i, align 8, !noalias !36
  %.6.i29.i.i353.i = fmul contract <8 x double> %.6.i28.i.i350.i, %.916.i.i352.i
  %.945.i.i354.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i29.i.i353.i, <8 x double> splat (double 0x3FE45F306DC9C883), <8 x double> splat (double 0x4338000000000000))
  %.8.i30.i.i355.i = fadd contract <8 x double> %.945.i.i354.i, splat (double 0xC338000000000000)
  %.986.i.i356.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i30.i.i355.i, <8 x double> splat (double 0xBFF921FB54442D18), <8 x double> %.6.i29.i.i353.i)
  %.1003.i.i357.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i30.i.i355.i, <8 x double> splat (double 0xBC91A62633145C07), <8 x double> %.986.i.i356.i)
  %.6.i31.i.i358.i = fmul contract <8 x double> %.1003.i.i357.i, %.1003.i.i357.i
  %.6.i32.i.i359.i = fmul contract <8 x double> %.1003.i.i357.i, %.6.i31.i.i358.i
  %.1032.i.i360.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i31.i.i358.i, <8 x double> splat (double 0xBD6AE7F3E733B81F), <8 x double> splat (double 0x3DE6124613A86D09))
  %.1035.i.i361.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i31.i.i358.i, <8 x double> %.1032.i.i360.i, <8 x double> splat (double 0xBE5AE64567F544E4))
  %.1038.i.i362.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i31.i.i358.i, <8 x double> %.1035.i.i361.i, <8 x double> splat (double 0x3EC71DE3A556C734))
  %.1041.i.i363.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i31.i.i358.i, <8 x double> %.1038.i.i362.i, <8 x double> splat (double 0xBF2A01A01A01A01A))
  %.1044.i.i364.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i31.i.i358.i, <8 x double> %.1041.i.i363.i, <8 x double> splat (double 0x3F81111111111111))
  %.1047.i.i365.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i31.i.i358.i, <8 x double> %.1044.i.i364.i, <8 x double> splat (double 0xBFC5555555555555))
  %.1072.i.i366.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i32.i.i359.i, <8 x double> %.1047.i.i365.i, <8 x double> %.1003.i.i357.i)
  %.1077.i.i367.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i31.i.i358.i, <8 x double> splat (double 0x3D2AE7F3E733B81F), <8 x double> splat (double 0xBDA93974A8C07C9D))
  %.1080.i.i368.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i31.i.i358.i, <8 x double> %.1077.i.i367.i, <8 x double> splat (double 0x3E21EED8EFF8D898))
  %.1083.i.i369.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i31.i.i358.i, <8 x double> %.1080.i.i368.i, <8 x double> splat (double 0xBE927E4FB7789F5C))
  %.1086.i.i370.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i31.i.i358.i, <8 x double> %.1083.i.i369.i, <8 x double> splat (double 0x3EFA01A01A01A01A))
  %.1089.i.i371.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i31.i.i358.i, <8 x double> %.1086.i.i370.i, <8 x double> splat (double 0xBF56C16C16C16C17))
  %.1092.i.i372.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i31.i.i358.i, <8 x double> %.1089.i.i371.i, <8 x double> splat (double 0x3FA5555555555555))
  %.1095.i.i373.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i31.i.i358.i, <8 x double> %.1092.i.i372.i, <8 x double> splat (double -5.000000e-01))
  %.1098.i.i374.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i31.i.i358.i, <8 x double> %.1095.i.i373.i, <8 x double> splat (double 1.000000e+00))
  %.1099.i.i375.i = bitcast <8 x double> %.945.i.i354.i to <8 x i64>
  %.1100.i.i376.i = bitcast <8 x double> %.1072.i.i366.i to <8 x i64>
  %.1101.i.i377.i = bitcast <8 x double> %.1098.i.i374.i to <8 x i64>
  %.6.i33.i.i378.i = xor <8 x i64> %.1101.i.i377.i, %.1100.i.i376.i
  %.8.i34.i.i379.i = and <8 x i64> %.1099.i.i375.i, splat (i64 1)
  %69 = icmp eq <8 x i64> %.8.i34.i.i379.i, zeroinitializer
  %.6.i36.i.i380.i = select <8 x i1> %69, <8 x i64> zeroinitializer, <8 x i64> %.6.i33.i.i378.i
  %.8.i37.i.i381.i = shl <8 x i64> %.1099.i.i375.i, splat (i64 62)
  %.8.i38.i.i382.i = and <8 x i64> %.8.i37.i.i381.i, splat (i64 -9223372036854775808)
  %.8.i40.i.i383.i = add <8 x i64> %.8.i37.i.i381.i, splat (i64 4611686018427387904)
  %.8.i41.i.i384.i = and <8 x i64> %.8.i40.i.i383.i, splat (i64 -9223372036854775808)
  %70 = xor <8 x i64> %.8.i38.i.i382.i, %.1100.i.i376.i
  %.6.i43.i.i385.i = xor <8 x i64> %70, %.6.i36.i.i380.i
  %71 = xor <8 x i64> %.8.i41.i.i384.i, %.1101.i.i377.i
  %.6.i45.i.i386.i = xor <8 x i64> %71, %.6.i36.i.i380.i
  store <8 x i64> %.6.i43.i.i385.i, ptr %.1443.i.i.i, align 8, !noalias !36
  store <8 x i64> %.6.i45.i.i386.i, ptr %.1453.i.i.i, align 8, !noalias !36
  %.1466.i.i390.i = load <8 x double>, ptr %.1464.i.i.i, align 8, !noalias !36
  %.6.i46.i.i391.i = fmul contract <8 x double> %.6.i28.i.i350.i, %.1466.i.i390.i
  %.1498.i.i392.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i46.i.i391.i, <8 x double> splat (double 0x3FE45F306DC9C883), <8 x double> splat (double 0x4338000000000000))
  %.8.i47.i.i393.i = fadd contract <8 x double> %.1498.i.i392.i, splat (double 0xC338000000000000)
  %.1539.i.i394.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i47.i.i393.i, <8 x double> splat (double 0xBFF921FB54442D18), <8 x double> %.6.i46.i.i391.i)
  %.1556.i.i395.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i47.i.i393.i, <8 x double> splat (double 0xBC91A62633145C07), <8 x double> %.1539.i.i394.i)
  %.6.i48.i.i396.i = fmul contract <8 x double> %.1556.i.i395.i, %.1556.i.i395.i
  %.6.i49.i.i397.i = fmul contract <8 x double> %.1556.i.i395.i, %.6.i48.i.i396.i
  %.1585.i.i398.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i48.i.i396.i, <8 x double> splat (double 0xBD6AE7F3E733B81F), <8 x double> splat (double 0x3DE6124613A86D09))
  %.1588.i.i399.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i48.i.i396.i, <8 x double> %.1585.i.i398.i, <8 x double> splat (double 0xBE5AE64567F544E4))
  %.1591.i.i400.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i48.i.i396.i, <8 x double> %.1588.i.i399.i, <8 x double> splat (double 0x3EC71DE3A556C734))
  %.1594.i.i401.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i48.i.i396.i, <8 x double> %.1591.i.i400.i, <8 x double> splat (double 0xBF2A01A01A01A01A))
  %.1597.i.i402.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i48.i.i396.i, <8 x double> %.1594.i.i401.i, <8 x double> splat (double 0x3F81111111111111))
  %.1600.i.i403.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i48.i.i396.i, <8 x double> %.1597.i.i402.i, <8 x double> splat (double 0xBFC5555555555555))
  %.1625.i.i404.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i49.i.i397.i, <8 x double> %.1600.i.i403.i, <8 x double> %.1556.i.i395.i)
  %.1630.i.i405.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i48.i.i396.i, <8 x double> splat (double 0x3D2AE7F3E733B81F), <8 x double> splat (double 0xBDA93974A8C07C9D))
  %.1633.i.i406.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i48.i.i396.i, <8 x double> %.1630.i.i405.i, <8 x double> splat (double 0x3E21EED8EFF8D898))
  %.1636.i.i407.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i48.i.i396.i, <8 x double> %.1633.i.i406.i, <8 x double> splat (double 0xBE927E4FB7789F5C))
  %.1639.i.i408.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i48.i.i396.i, <8 x double> %.1636.i.i407.i, <8 x double> splat (double 0x3EFA01A01A01A01A))
  %.1642.i.i409.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i48.i.i396.i, <8 x double> %.1639.i.i408.i, <8 x double> splat (double 0xBF56C16C16C16C17))
  %.1645.i.i410.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i48.i.i396.i, <8 x double> %.1642.i.i409.i, <8 x double> splat (double 0x3FA5555555555555))
  %.1648.i.i411.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i48.i.i396.i, <8 x double> %.1645.i.i410.i, <8 x double> splat (double -5.000000e-01))
  %.1651.i.i412.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i48.i.i396.i, <8 x double> %.1648.i.i411.i, <8 x double> splat (double 1.000000e+00))
  %.1652.i.i413.i = bitcast <8 x double> %.1498.i.i392.i to <8 x i64>
  %.1653.i.i414.i = bitcast <8 x double> %.1625.i.i404.i to <8 x i64>
  %.1654.i.i415.i = bitcast <8 x double> %.1651.i.i412.i to <8 x i64>
  %.6.i50.i.i416.i = xor <8 x i64> %.1654.i.i415.i, %.1653.i.i414.i
  %.8.i51.i.i417.i = and <8 x i64> %.1652.i.i413.i, splat (i64 1)
  %72 = icmp eq <8 x i64> %.8.i51.i.i417.i, zeroinitializer
  %.6.i53.i.i418.i = select <8 x i1> %72, <8 x i64> zeroinitializer, <8 x i64> %.6.i50.i.i416.i
  %.8.i54.i.i419.i = shl <8 x i64> %.1652.i.i413.i, splat (i64 62)
  %.8.i55.i.i420.i = and <8 x i64> %.8.i54.i.i419.i, splat (i64 -9223372036854775808)
  %.8.i57.i.i421.i = add <8 x i64> %.8.i54.i.i419.i, splat (i64 4611686018427387904)
  %.8.i58.i.i422.i = and <8 x i64> %.8.i57.i.i421.i, splat (i64 -9223372036854775808)
  %73 = xor <8 x i64> %.8.i55.i.i420.i, %.1653.i.i414.i
  %.6.i60.i.i423.i = xor <8 x i64> %73, %.6.i53.i.i418.i
  %74 = xor <8 x i64> %.8.i58.i.i422.i, %.1654.i.i415.i
  %.6.i62.i.i424.i = xor <8 x i64> %74, %.6.i53.i.i418.i
  store <8 x i64> %.6.i60.i.i423.i, ptr %.1996.i.i.i, align 8, !noalias !36
  store <8 x i64> %.6.i62.i.i424.i, ptr %.2006.i.i.i, align 8, !noalias !36
  store ptr null, ptr %.1111.i15.i, align 8, !noalias !33
  call fastcc void @inner_0(ptr nonnull %.1111.i15.i, ptr nonnull readonly %.49.i, ptr nonnull %.252.i, ptr nonnull %scevgep53.i.i, ptr nonnull %.391.i.i)
  %.1314.i429.i = load <8 x double>, ptr %scevgep37.4.i.i, align 8, !noalias !33
  store <8 x double> %.1314.i429.i, ptr %44, align 8, !noalias !33
  %.1338.i431.i = load <8 x double>, ptr %.1336.i.i, align 8, !noalias !33
  store <8 x double> %.1338.i431.i, ptr %45, align 8, !noalias !33
  %.1314.1.i432.i = load <8 x double>, ptr %scevgep41.5.i.i, align 8, !noalias !33
  store <8 x double> %.1314.1.i432.i, ptr %.1322.1.i.i, align 8, !noalias !33
  %.1338.1.i435.i = load <8 x double>, ptr %.1336.1.i.i, align 8, !noalias !33
  store <8 x double> %.1338.1.i435.i, ptr %.1346.1.i.i, align 8, !noalias !33
  %.1314.2.i437.i = load <8 x double>, ptr %scevgep45.6.i.i, align 8, !noalias !33
  store <8 x double> %.1314.2.i437.i, ptr %.1322.2.i.i, align 8, !noalias !33
  %.1338.2.i440.i = load <8 x double>, ptr %.1336.2.i.i, align 8, !noalias !33
  store <8 x double> %.1338.2.i440.i, ptr %.1346.2.i.i, align 8, !noalias !33
  %.1314.3.i442.i = load <8 x double>, ptr %scevgep49.7.i.i, align 8, !noalias !33
  store <8 x double> %.1314.3.i442.i, ptr %.1322.3.i.i, align 8, !noalias !33
  %.1338.3.i445.i = load <8 x double>, ptr %.1336.3.i.i, align 8, !noalias !33
  store <8 x double> %.1338.3.i445.i, ptr %.1346.3.i.i, align 8, !noalias !33
  %.3643.i.i = add nuw i64 %.13.i74.i.i, 1
  %.145967.not.i447.i = icmp slt i64 %.13.i116.i283.i, 1
  br i1 %.145967.not.i447.i, label %_ZN17bnserve_surrogate10precession9_dynamics6followB3v88B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIxLi1E1C7mutable7alignedE23Literal_5bint_5d_281_295ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx.exit.i, label %B986.if.lr.ph.i448.i

B13869.i.i:                                       ; preds = %B13806.if.i.i
  store ptr null, ptr %.2357.i17.i, align 8, !noalias !33
  call fastcc void @inner_0(ptr nonnull %.2357.i17.i, ptr nonnull readonly %.49.i, ptr nonnull %.171.i.i, ptr nonnull %.474.i.i, ptr nonnull %.391.i.i)
  %.8.i401.i775.i = fmul contract <8 x double> %.1716.i487.i, splat (double 0x3FD5555555555555)
  br label %B13993.if.i.i

B14243.i.i:                                       ; preds = %B14180.if.i.i
  store ptr null, ptr %.2832.i19.i, align 8, !noalias !33
  call fastcc void @inner_0(ptr nonnull %.2832.i19.i, ptr nonnull readonly %.49.i, ptr nonnull %.171.i.i, ptr nonnull %.474.i.i, ptr nonnull %.391.i.i)
  br label %B14367.if.i.i

B14617.i.i:                                       ; preds = %B14554.if.i.i
  store ptr null, ptr %.3310.i21.i, align 8, !noalias !33
  call fastcc void @inner_0(ptr nonnull %.3310.i21.i, ptr nonnull readonly %.49.i, ptr nonnull %.234.i.i, ptr nonnull %.474.i.i, ptr nonnull %.391.i.i)
  br label %B14741.if.i.i

B14840.i.i:                                       ; preds = %B14741.if.i.i
  store ptr null, ptr %.3609.i23.i, align 8, !noalias !33
  call fastcc void @inner_0(ptr nonnull %.3609.i23.i, ptr nonnull readonly %.49.i, ptr nonnull %.234.i.i, ptr nonnull %scevgep53.i.i, ptr nonnull %.391.i.i)
  %.3649.i827.i = add i64 %.3643.i.i, %.1449.sroa.0.074.i459.i
  %.idx75.i828.i = shl i64 %.3649.i827.i, 9
  %75 = getelementptr i8, ptr %.390.i, i64 %.idx75.i828.i
  %76 = getelementptr i8, ptr %75, i64 256
  %.3814.i829.i = load <8 x double>, ptr %scevgep37.4.i.i, align 8, !noalias !33
  store <8 x double> %.3814.i829.i, ptr %75, align 8, !noalias !33
  %.3838.i830.i = load <8 x double>, ptr %.1336.i.i, align 8, !noalias !33
  store <8 x double> %.3838.i830.i, ptr %76, align 8, !noalias !33
  %.3814.1.i831.i = load <8 x double>, ptr %scevgep41.5.i.i, align 8, !noalias !33
  %.3822.1.i832.i = getelementptr i8, ptr %75, i64 64
  store <8 x double> %.3814.1.i831.i, ptr %.3822.1.i832.i, align 8, !noalias !33
  %.3838.1.i833.i = load <8 x double>, ptr %.1336.1.i.i, align 8, !noalias !33
  %.3846.1.i834.i = getelementptr i8, ptr %75, i64 320
  store <8 x double> %.3838.1.i833.i, ptr %.3846.1.i834.i, align 8, !noalias !33
  %.3814.2.i835.i = load <8 x double>, ptr %scevgep45.6.i.i, align 8, !noalias !33
  %.3822.2.i836.i = getelementptr i8, ptr %75, i64 128
  store <8 x double> %.3814.2.i835.i, ptr %.3822.2.i836.i, align 8, !noalias !33
  %.3838.2.i837.i = load <8 x double>, ptr %.1336.2.i.i, align 8, !noalias !33
  %.3846.2.i838.i = getelementptr i8, ptr %75, i64 384
  store <8 x double> %.3838.2.i837.i, ptr %.3846.2.i838.i, align 8, !noalias !33
  %.3814.3.i839.i = load <8 x double>, ptr %scevgep49.7.i.i, align 8, !noalias !33
  %.3822.3.i840.i = getelementptr i8, ptr %75, i64 192
  store <8 x double> %.3814.3.i839.i, ptr %.3822.3.i840.i, align 8, !noalias !33
  %.3838.3.i841.i = load <8 x double>, ptr %.1336.3.i.i, align 8, !noalias !33
  %.3846.3.i842.i = getelementptr i8, ptr %75, i64 448
  store <8 x double> %.3838.3.i841.i, ptr %.3846.3.i842.i, align 8, !noalias !33
  %.1459.i843.i = icmp sgt i64 %.1458215673.i460.i, 0
  %.1472.i844.i = zext i1 %.1459.i843.i to i64
  %.14652170.i845.i = add i64 %.1465217072.i461.i, %.1472.i844.i
  %.1468.i846.i = sext i1 %.1459.i843.i to i64
  %.14582156.i847.i = add nsw i64 %.1458215673.i460.i, %.1468.i846.i
  %.1449.sroa.0.0.i848.i = select i1 %.1459.i843.i, i64 %.1465217072.i461.i, i64 0
  br i1 %.1459.i843.i, label %B986.if.i458.i, label %_ZN17bnserve_surrogate10precession9_dynamics6followB3v88B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIxLi1E1C7mutable7alignedE23Literal_5bint_5d_281_295ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx.exit.i

B986.if.lr.ph.i448.i:                             ; preds = %_ZN17bnserve_surrogate10precession9_dynamics6followB3v36B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIxLi1E1C7mutable7alignedE23Literal_5bint_5d_280_295ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx.exit.i
  %.1458215670.i449.i = add nsw i64 %.13.i116.i283.i, -1
  br label %B986.if.i458.i

B986.if.i458.i:                                   ; preds = %B986.if.lr.ph.i448.i, %B14840.i.i
  %.1449.sroa.0.074.i459.i = phi i64 [ 0, %B986.if.lr.ph.i448.i ], [ %.1449.sroa.0.0.i848.i, %B14840.i.i ]
  %.1458215673.i460.i = phi i64 [ %.1458215670.i449.i, %B986.if.lr.ph.i448.i ], [ %.14582156.i847.i, %B14840.i.i ]
  %.1465217072.i461.i = phi i64 [ 1, %B986.if.lr.ph.i448.i ], [ %.14652170.i845.i, %B14840.i.i ]
  %step.2.071.i462.i = phi <8 x double> [ %.1070.i285.i, %B986.if.lr.ph.i448.i ], [ %.6.i.i620.i, %B14840.i.i ]
  %.1653.i463.i = load i64, ptr %9, align 8, !noalias !33
  %.1655.i464.i = icmp slt i64 %.1449.sroa.0.074.i459.i, %.1653.i463.i
  %"$phi988.2.2.2.i465.i" = select i1 %.1655.i464.i, double 1.000000e+00, double 0.000000e+00
  store double %"$phi988.2.2.2.i465.i", ptr %sunkaddr.i12.i, align 8, !noalias !33
  %.1653.1.i466.i = load i64, ptr %10, align 8, !noalias !33
  %.1655.1.i467.i = icmp slt i64 %.1449.sroa.0.074.i459.i, %.1653.1.i466.i
  %"$phi988.2.2.2.1.i468.i" = select i1 %.1655.1.i467.i, double 1.000000e+00, double 0.000000e+00
  store double %"$phi988.2.2.2.1.i468.i", ptr %sunkaddr24.i.i, align 8, !noalias !33
  %.1653.2.i469.i = load i64, ptr %11, align 8, !noalias !33
  %.1655.2.i470.i = icmp slt i64 %.1449.sroa.0.074.i459.i, %.1653.2.i469.i
  %"$phi988.2.2.2.2.i471.i" = select i1 %.1655.2.i470.i, double 1.000000e+00, double 0.000000e+00
  store double %"$phi988.2.2.2.2.i471.i", ptr %sunkaddr26.i.i, align 8, !noalias !33
  %.1653.3.i472.i = load i64, ptr %12, align 8, !noalias !33
  %.1655.3.i473.i = icmp slt i64 %.1449.sroa.0.074.i459.i, %.1653.3.i472.i
  %"$phi988.2.2.2.3.i474.i" = select i1 %.1655.3.i473.i, double 1.000000e+00, double 0.000000e+00
  store double %"$phi988.2.2.2.3.i474.i", ptr %sunkaddr28.i.i, align 8, !noalias !33
  %.1653.4.i475.i = load i64, ptr %13, align 8, !noalias !33
  %.1655.4.i476.i = icmp slt i64 %.1449.sroa.0.074.i459.i, %.1653.4.i475.i
  %"$phi988.2.2.2.4.i477.i" = select i1 %.1655.4.i476.i, double 1.000000e+00, double 0.000000e+00
  store double %"$phi988.2.2.2.4.i477.i", ptr %sunkaddr30.i.i, align 8, !noalias !33
  %.1653.5.i478.i = load i64, ptr %14, align 8, !noalias !33
  %.1655.5.i479.i = icmp slt i64 %.1449.sroa.0.074.i459.i, %.1653.5.i478.i
  %"$phi988.2.2.2.5.i480.i" = select i1 %.1655.5.i479.i, double 1.000000e+00, double 0.000000e+00
  store double %"$phi988.2.2.2.5.i480.i", ptr %sunkaddr32.i.i, align 8, !noalias !33
  %.1653.6.i481.i = load i64, ptr %15, align 8, !noalias !33
  %.1655.6.i482.i = icmp slt i64 %.1449.sroa.0.074.i459.i, %.1653.6.i481.i
  %"$phi988.2.2.2.6.i483.i" = select i1 %.1655.6.i482.i, double 1.000000e+00, double 0.000000e+00
  store double %"$phi988.2.2.2.6.i483.i", ptr %sunkaddr34.i.i, align 8, !noalias !33
  %.1653.7.i484.i = load i64, ptr %16, align 8, !noalias !33
  %.1655.7.i485.i = icmp slt i64 %.1449.sroa.0.074.i459.i, %.1653.7.i484.i
  %"$phi988.2.2.2.7.i486.i" = select i1 %.1655.7.i485.i, double 1.000000e+00, double 0.000000e+00
  store double %"$phi988.2.2.2.7.i486.i", ptr %sunkaddr36.i.i, align 8, !noalias !33
  %.1716.i487.i = load <8 x double>, ptr %sunkaddr.i12.i, align 8, !noalias !33
  %.1721.i488.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1716.i487.i, <8 x double> splat (double 5.000000e-01), <8 x double> %step.2.071.i462.i)
  %.38.i118.i489.i = load <8 x double>, ptr %.49.i, align 8, !noalias !39
  %.8.i.i119.i490.i = fadd contract <8 x double> %.1721.i488.i, splat (double 1.600000e+01)
  %.8.i1.i120.i491.i = fdiv contract <8 x double> splat (double 1.000000e+00), %.8.i.i119.i490.i
  %.6.i.i121.i492.i = fmul contract <8 x double> %.1721.i488.i, %.38.i118.i489.i
  %.6.i2.i122.i493.i = fmul contract <8 x double> %.1721.i488.i, %.6.i.i121.i492.i
  %.6.i3.i123.i494.i = fmul contract <8 x double> %.8.i1.i120.i491.i, %.6.i2.i122.i493.i
  %.162.i124.i495.i = bitcast <8 x double> %.6.i3.i123.i494.i to <8 x i64>
  %.8.i4.i125.i496.i = ashr <8 x i64> %.162.i124.i495.i, splat (i64 52)
  %.8.i5.i126.i497.i = add nsw <8 x i64> %.8.i4.i125.i496.i, splat (i64 4841369599423283200)
  %77 = bitcast <8 x i64> %.8.i5.i126.i497.i to <8 x double>
  %.8.i6.i127.i498.i = fadd contract <8 x double> %77, splat (double 0xC3300000000003FF)
  %.8.i7.i128.i499.i = and <8 x i64> %.162.i124.i495.i, splat (i64 4503599627370495)
  %.8.i8.i129.i500.i = or disjoint <8 x i64> %.8.i7.i128.i499.i, splat (i64 4607182418800017408)
  %78 = bitcast <8 x i64> %.8.i8.i129.i500.i to <8 x double>
  %.8.i9.i130.i501.i = fadd contract <8 x double> %78, splat (double -1.000000e+00)
  %.8.i10.i131.i502.i = fadd contract <8 x double> %78, splat (double 1.000000e+00)
  %.6.i11.i132.i503.i = fdiv contract <8 x double> %.8.i9.i130.i501.i, %.8.i10.i131.i502.i
  %.6.i12.i133.i504.i = fmul contract <8 x double> %.6.i11.i132.i503.i, %.6.i11.i132.i503.i
  %.385.i134.i505.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i12.i133.i504.i, <8 x double> splat (double 0x3FB642C8590B2164), <8 x double> splat (double 0x3FB8618618618618))
  %.388.i135.i506.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i12.i133.i504.i, <8 x double> %.385.i134.i505.i, <8 x double> splat (double 0x3FBAF286BCA1AF28))
  %.391.i136.i507.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i12.i133.i504.i, <8 x double> %.388.i135.i506.i, <8 x double> splat (double 0x3FBE1E1E1E1E1E1E))
  %.394.i137.i508.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i12.i133.i504.i, <8 x double> %.391.i136.i507.i, <8 x double> splat (double 0x3FC1111111111111))
  %.397.i138.i509.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i12.i133.i504.i, <8 x double> %.394.i137.i508.i, <8 x double> splat (double 0x3FC3B13B13B13B14))
  %.400.i139.i510.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i12.i133.i504.i, <8 x double> %.397.i138.i509.i, <8 x double> splat (double 0x3FC745D1745D1746))
  %.403.i140.i511.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i12.i133.i504.i, <8 x double> %.400.i139.i510.i, <8 x double> splat (double 0x3FCC71C71C71C71C))
  %.406.i141.i512.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i12.i133.i504.i, <8 x double> %.403.i140.i511.i, <8 x double> splat (double 0x3FD2492492492492))
  %.409.i142.i513.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i12.i133.i504.i, <8 x double> %.406.i141.i512.i, <8 x double> splat (double 4.000000e-01))
  %.412.i143.i514.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i12.i133.i504.i, <8 x double> %.409.i142.i513.i, <8 x double> splat (double 0x3FE5555555555555))
  %.415.i144.i515.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i12.i133.i504.i, <8 x double> %.412.i143.i514.i, <8 x double> splat (double 2.000000e+00))
  %.6.i13.i145.i516.i = fmul contract <8 x double> %.6.i11.i132.i503.i, %.415.i144.i515.i
  %.442.i146.i517.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i6.i127.i498.i, <8 x double> splat (double 0x3FE62E42FEFA39EF), <8 x double> %.6.i13.i145.i516.i)
  %.8.i15.i147.i518.i = fadd contract <8 x double> %.1721.i488.i, splat (double 3.200000e+01)
  %.6.i16.i148.i519.i = fmul contract <8 x double> %.8.i15.i147.i518.i, %.6.i.i121.i492.i
  %.6.i17.i149.i520.i = fmul contract <8 x double> %.8.i1.i120.i491.i, %.6.i16.i148.i519.i
  %.6.i18.i150.i521.i = fmul contract <8 x double> %.8.i1.i120.i491.i, %.6.i17.i149.i520.i
  store <8 x double> %.6.i18.i150.i521.i, ptr %.171.i.i, align 8, !noalias !39
  %.8.i19.i151.i522.i = fmul contract <8 x double> %.442.i146.i517.i, splat (double 0xBFD5555555555555)
  %.604.i152.i523.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i19.i151.i522.i, <8 x double> splat (double 0x3FF71547652B82FE), <8 x double> splat (double 0x4338000000000000))
  %.8.i20.i153.i524.i = fadd contract <8 x double> %.604.i152.i523.i, splat (double 0xC338000000000000)
  %.633.i154.i525.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i20.i153.i524.i, <8 x double> splat (double 0xBFE62E42FEFA39EF), <8 x double> %.8.i19.i151.i522.i)
  %.636.i155.i526.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i20.i153.i524.i, <8 x double> splat (double 0xBC7ABC9E3B39803F), <8 x double> %.633.i154.i525.i)
  %.641.i156.i527.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.636.i155.i526.i, <8 x double> splat (double 0x3DE6124613A86D09), <8 x double> splat (double 0x3E21EED8EFF8D898))
  %.644.i157.i528.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.636.i155.i526.i, <8 x double> %.641.i156.i527.i, <8 x double> splat (double 0x3E5AE64567F544E4))
  %.647.i158.i529.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.636.i155.i526.i, <8 x double> %.644.i157.i528.i, <8 x double> splat (double 0x3E927E4FB7789F5C))
  %.650.i159.i530.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.636.i155.i526.i, <8 x double> %.647.i158.i529.i, <8 x double> splat (double 0x3EC71DE3A556C734))
  %.653.i160.i531.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.636.i155.i526.i, <8 x double> %.650.i159.i530.i, <8 x double> splat (double 0x3EFA01A01A01A01A))
  %.656.i161.i532.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.636.i155.i526.i, <8 x double> %.653.i160.i531.i, <8 x double> splat (double 0x3F2A01A01A01A01A))
  %.659.i162.i533.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.636.i155.i526.i, <8 x double> %.656.i161.i532.i, <8 x double> splat (double 0x3F56C16C16C16C17))
  %.662.i163.i534.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.636.i155.i526.i, <8 x double> %.659.i162.i533.i, <8 x double> splat (double 0x3F81111111111111))
  %.665.i164.i535.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.636.i155.i526.i, <8 x double> %.662.i163.i534.i, <8 x double> splat (double 0x3FA5555555555555))
  %.668.i165.i536.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.636.i155.i526.i, <8 x double> %.665.i164.i535.i, <8 x double> splat (double 0x3FC5555555555555))
  %.671.i166.i537.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.636.i155.i526.i, <8 x double> %.668.i165.i536.i, <8 x double> splat (double 5.000000e-01))
  %.6.i21.i167.i538.i = fmul contract <8 x double> %.636.i155.i526.i, %.636.i155.i526.i
  %.8.i22.i168.i539.i = fadd contract <8 x double> %.636.i155.i526.i, splat (double 1.000000e+00)
  %.720.i169.i540.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i21.i167.i538.i, <8 x double> %.671.i166.i537.i, <8 x double> %.8.i22.i168.i539.i)
  %.721.i170.i541.i = bitcast <8 x double> %.604.i152.i523.i to <8 x i64>
  %.8.i23.i171.i542.i = shl <8 x i64> %.721.i170.i541.i, splat (i64 52)
  %.8.i24.i172.i543.i = add <8 x i64> %.8.i23.i171.i542.i, splat (i64 4607182418800017408)
  %79 = bitcast <8 x i64> %.8.i24.i172.i543.i to <8 x double>
  %.6.i25.i173.i544.i = fmul contract <8 x double> %.720.i169.i540.i, %79
  store <8 x double> %.6.i25.i173.i544.i, ptr %sunkaddr38.i.i, align 8, !noalias !39
  %.8.i26.i175.i545.i = fsub contract <8 x double> zeroinitializer, %.442.i146.i517.i
  store <8 x double> %.8.i26.i175.i545.i, ptr %sunkaddr39.i.i, align 8, !noalias !39
  %.847.i178.i546.i = load <8 x double>, ptr %.845.i.i.i, align 8, !noalias !39
  %.6.i27.i179.i547.i = fsub contract <8 x double> %.847.i178.i546.i, %.6.i3.i123.i494.i
  %.881.i181.i548.i = load <8 x double>, ptr %.879.i.i.i, align 8, !noalias !39
  %.6.i28.i182.i549.i = fmul contract <8 x double> %.6.i27.i179.i547.i, %.881.i181.i548.i
  %.916.i184.i550.i = load <8 x double>, ptr %.914.i.i.i, align 8, !noalias !39
  %.6.i29.i185.i551.i = fmul contract <8 x double> %.6.i28.i182.i549.i, %.916.i184.i550.i
  %.945.i186.i552.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i29.i185.i551.i, <8 x double> splat (double 0x3FE45F306DC9C883), <8 x double> splat (double 0x4338000000000000))
  %.8.i30.i187.i553.i = fadd contract <8 x double> %.945.i186.i552.i, splat (double 0xC338000000000000)
  %.986.i188.i554.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i30.i187.i553.i, <8 x double> splat (double 0xBFF921FB54442D18), <8 x double> %.6.i29.i185.i551.i)
  %.1003.i189.i555.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i30.i187.i553.i, <8 x double> splat (double 0xBC91A62633145C07), <8 x double> %.986.i188.i554.i)
  %.6.i31.i190.i556.i = fmul contract <8 x double> %.1003.i189.i555.i, %.1003.i189.i555.i
  %.6.i32.i191.i557.i = fmul contract <8 x double> %.1003.i189.i555.i, %.6.i31.i190.i556.i
  %.1032.i192.i558.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i31.i190.i556.i, <8 x double> splat (double 0xBD6AE7F3E733B81F), <8 x double> splat (double 0x3DE6124613A86D09))
  %.1035.i193.i559.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i31.i190.i556.i, <8 x double> %.1032.i192.i558.i, <8 x double> splat (double 0xBE5AE64567F544E4))
  %.1038.i194.i560.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i31.i190.i556.i, <8 x double> %.1035.i193.i559.i, <8 x double> splat (double 0x3EC71DE3A556C734))
  %.1041.i195.i561.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i31.i190.i556.i, <8 x double> %.1038.i194.i560.i, <8 x double> splat (double 0xBF2A01A01A01A01A))
  %.1044.i196.i562.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i31.i190.i556.i, <8 x double> %.1041.i195.i561.i, <8 x double> splat (double 0x3F81111111111111))
  %.1047.i197.i563.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i31.i190.i556.i, <8 x double> %.1044.i196.i562.i, <8 x double> splat (double 0xBFC5555555555555))
  %.1072.i198.i564.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i32.i191.i557.i, <8 x double> %.1047.i197.i563.i, <8 x double> %.1003.i189.i555.i)
  %.1077.i199.i565.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i31.i190.i556.i, <8 x double> splat (double 0x3D2AE7F3E733B81F), <8 x double> splat (double 0xBDA93974A8C07C9D))
  %.1080.i200.i566.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i31.i190.i556.i, <8 x double> %.1077.i199.i565.i, <8 x double> splat (double 0x3E21EED8EFF8D898))
  %.1083.i201.i567.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i31.i190.i556.i, <8 x double> %.1080.i200.i566.i, <8 x double> splat (double 0xBE927E4FB7789F5C))
  %.1086.i202.i568.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i31.i190.i556.i, <8 x double> %.1083.i201.i567.i, <8 x double> splat (double 0x3EFA01A01A01A01A))
  %.1089.i203.i569.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i31.i190.i556.i, <8 x double> %.1086.i202.i568.i, <8 x double> splat (double 0xBF56C16C16C16C17))
  %.1092.i204.i570.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i31.i190.i556.i, <8 x double> %.1089.i203.i569.i, <8 x double> splat (double 0x3FA5555555555555))
  %.1095.i205.i571.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i31.i190.i556.i, <8 x double> %.1092.i204.i570.i, <8 x double> splat (double -5.000000e-01))
  %.1098.i206.i572.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i31.i190.i556.i, <8 x double> %.1095.i205.i571.i, <8 x double> splat (double 1.000000e+00))
  %.1099.i207.i573.i = bitcast <8 x double> %.945.i186.i552.i to <8 x i64>
  %.1100.i208.i574.i = bitcast <8 x double> %.1072.i198.i564.i to <8 x i64>
  %.1101.i209.i575.i = bitcast <8 x double> %.1098.i206.i572.i to <8 x i64>
  %.6.i33.i210.i576.i = xor <8 x i64> %.1101.i209.i575.i, %.1100.i208.i574.i
  %.8.i34.i211.i577.i = and <8 x i64> %.1099.i207.i573.i, splat (i64 1)
  %80 = icmp eq <8 x i64> %.8.i34.i211.i577.i, zeroinitializer
  %.6.i36.i212.i578.i = select <8 x i1> %80, <8 x i64> zeroinitializer, <8 x i64> %.6.i33.i210.i576.i
  %.8.i37.i213.i579.i = shl <8 x i64> %.1099.i207.i573.i, splat (i64 62)
  %.8.i38.i214.i580.i = and <8 x i64> %.8.i37.i213.i579.i, splat (i64 -9223372036854775808)
  %.8.i40.i215.i581.i = add <8 x i64> %.8.i37.i213.i579.i, splat (i64 4611686018427387904)
  %.8.i41.i216.i582.i = and <8 x i64> %.8.i40.i215.i581.i, splat (i64 -9223372036854775808)
  %81 = xor <8 x i64> %.8.i38.i214.i580.i, %.1100.i208.i574.i
  %.6.i43.i217.i583.i = xor <8 x i64> %81, %.6.i36.i212.i578.i
  %82 = xor <8 x i64> %.8.i41.i216.i582.i, %.1101.i209.i575.i
  %.6.i45.i218.i584.i = xor <8 x i64> %82, %.6.i36.i212.i578.i
  store <8 x i64> %.6.i43.i217.i583.i, ptr %sunkaddr43.i.i, align 8, !noalias !39
  store <8 x i64> %.6.i45.i218.i584.i, ptr %sunkaddr44.i.i, align 8, !noalias !39
  %.1466.i222.i585.i = load <8 x double>, ptr %.1464.i.i.i, align 8, !noalias !39
  %.6.i46.i223.i586.i = fmul contract <8 x double> %.6.i28.i182.i549.i, %.1466.i222.i585.i
  %.1498.i224.i587.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i46.i223.i586.i, <8 x double> splat (double 0x3FE45F306DC9C883), <8 x double> splat (double 0x4338000000000000))
  %.8.i47.i225.i588.i = fadd contract <8 x double> %.1498.i224.i587.i, splat (double 0xC338000000000000)
  %.1539.i226.i589.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i47.i225.i588.i, <8 x double> splat (double 0xBFF921FB54442D18), <8 x double> %.6.i46.i223.i586.i)
  %.1556.i227.i590.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i47.i225.i588.i, <8 x double> splat (double 0xBC91A62633145C07), <8 x double> %.1539.i226.i589.i)
  %.6.i48.i228.i591.i = fmul contract <8 x double> %.1556.i227.i590.i, %.1556.i227.i590.i
  %.6.i49.i229.i592.i = fmul contract <8 x double> %.1556.i227.i590.i, %.6.i48.i228.i591.i
  %.1585.i230.i593.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i48.i228.i591.i, <8 x double> splat (double 0xBD6AE7F3E733B81F), <8 x double> splat (double 0x3DE6124613A86D09))
  %.1588.i231.i594.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i48.i228.i591.i, <8 x double> %.1585.i230.i593.i, <8 x double> splat (double 0xBE5AE64567F544E4))
  %.1591.i232.i595.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i48.i228.i591.i, <8 x double> %.1588.i231.i594.i, <8 x double> splat (double 0x3EC71DE3A556C734))
  %.1594.i233.i596.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i48.i228.i591.i, <8 x double> %.1591.i232.i595.i, <8 x double> splat (double 0xBF2A01A01A01A01A))
  %.1597.i234.i597.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i48.i228.i591.i, <8 x double> %.1594.i233.i596.i, <8 x double> splat (double 0x3F81111111111111))
  %.1600.i235.i598.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i48.i228.i591.i, <8 x double> %.1597.i234.i597.i, <8 x double> splat (double 0xBFC5555555555555))
  %.1625.i236.i599.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i49.i229.i592.i, <8 x double> %.1600.i235.i598.i, <8 x double> %.1556.i227.i590.i)
  %.1630.i237.i600.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i48.i228.i591.i, <8 x double> splat (double 0x3D2AE7F3E733B81F), <8 x double> splat (double 0xBDA93974A8C07C9D))
  %.1633.i238.i601.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i48.i228.i591.i, <8 x double> %.1630.i237.i600.i, <8 x double> splat (double 0x3E21EED8EFF8D898))
  %.1636.i239.i602.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i48.i228.i591.i, <8 x double> %.1633.i238.i601.i, <8 x double> splat (double 0xBE927E4FB7789F5C))
  %.1639.i240.i603.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i48.i228.i591.i, <8 x double> %.1636.i239.i602.i, <8 x double> splat (double 0x3EFA01A01A01A01A))
  %.1642.i241.i604.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i48.i228.i591.i, <8 x double> %.1639.i240.i603.i, <8 x double> splat (double 0xBF56C16C16C16C17))
  %.1645.i242.i605.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i48.i228.i591.i, <8 x double> %.1642.i241.i604.i, <8 x double> splat (double 0x3FA5555555555555))
  %.1648.i243.i606.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i48.i228.i591.i, <8 x double> %.1645.i242.i605.i, <8 x double> splat (double -5.000000e-01))
  %.1651.i244.i607.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i48.i228.i591.i, <8 x double> %.1648.i243.i606.i, <8 x double> splat (double 1.000000e+00))
  %.1652.i245.i608.i = bitcast <8 x double> %.1498.i224.i587.i to <8 x i64>
  %.1653.i246.i609.i = bitcast <8 x double> %.1625.i236.i599.i to <8 x i64>
  %.1654.i247.i610.i = bitcast <8 x double> %.1651.i244.i607.i to <8 x i64>
  %.6.i50.i248.i611.i = xor <8 x i64> %.1654.i247.i610.i, %.1653.i246.i609.i
  %.8.i51.i249.i612.i = and <8 x i64> %.1652.i245.i608.i, splat (i64 1)
  %83 = icmp eq <8 x i64> %.8.i51.i249.i612.i, zeroinitializer
  %.6.i53.i250.i613.i = select <8 x i1> %83, <8 x i64> zeroinitializer, <8 x i64> %.6.i50.i248.i611.i
  %.8.i54.i251.i614.i = shl <8 x i64> %.1652.i245.i608.i, splat (i64 62)
  %.8.i55.i252.i615.i = and <8 x i64> %.8.i54.i251.i614.i, splat (i64 -9223372036854775808)
  %.8.i57.i253.i616.i = add <8 x i64> %.8.i54.i251.i614.i, splat (i64 4611686018427387904)
  %.8.i58.i254.i617.i = and <8 x i64> %.8.i57.i253.i616.i, splat (i64 -9223372036854775808)
  %84 = xor <8 x i64> %.8.i55.i252.i615.i, %.1653.i246.i609.i
  %.6.i60.i255.i618.i = xor <8 x i64> %84, %.6.i53.i250.i613.i
  %85 = xor <8 x i64> %.8.i58.i254.i617.i, %.1654.i247.i610.i
  %.6.i62.i256.i619.i = xor <8 x i64> %85, %.6.i53.i250.i613.i
  store <8 x i64> %.6.i60.i255.i618.i, ptr %sunkaddr46.i.i, align 8, !noalias !39
  store <8 x i64> %.6.i62.i256.i619.i, ptr %sunkaddr47.i.i, align 8, !noalias !39
  %.6.i.i620.i = fadd contract <8 x double> %step.2.071.i462.i, %.1716.i487.i
  %.8.i.i260.i622.i = fadd contract <8 x double> %.6.i.i620.i, splat (double 1.600000e+01)
  %.8.i1.i261.i623.i = fdiv contract <8 x double> splat (double 1.000000e+00), %.8.i.i260.i622.i
  %.6.i.i262.i624.i = fmul contract <8 x double> %.6.i.i620.i, %.38.i118.i489.i
  %.6.i2.i263.i625.i = fmul contract <8 x double> %.6.i.i620.i, %.6.i.i262.i624.i
  %.6.i3.i264.i626.i = fmul contract <8 x double> %.8.i1.i261.i623.i, %.6.i2.i263.i625.i
  %.162.i265.i627.i = bitcast <8 x double> %.6.i3.i264.i626.i to <8 x i64>
  %.8.i4.i266.i628.i = ashr <8 x i64> %.162.i265.i627.i, splat (i64 52)
  %.8.i5.i267.i629.i = add nsw <8 x i64> %.8.i4.i266.i628.i, splat (i64 4841369599423283200)
  %86 = bitcast <8 x i64> %.8.i5.i267.i629.i to <8 x double>
  %.8.i6.i268.i630.i = fadd contract <8 x double> %86, splat (double 0xC3300000000003FF)
  %.8.i7.i269.i631.i = and <8 x i64> %.162.i265.i627.i, splat (i64 4503599627370495)
  %.8.i8.i270.i632.i = or disjoint <8 x i64> %.8.i7.i269.i631.i, splat (i64 4607182418800017408)
  %87 = bitcast <8 x i64> %.8.i8.i270.i632.i to <8 x double>
  %.8.i9.i271.i633.i = fadd contract <8 x double> %87, splat (double -1.000000e+00)
  %.8.i10.i272.i634.i = fadd contract <8 x double> %87, splat (double 1.000000e+00)
  %.6.i11.i273.i635.i = fdiv contract <8 x double> %.8.i9.i271.i633.i, %.8.i10.i272.i634.i
  %.6.i12.i274.i636.i = fmul contract <8 x double> %.6.i11.i273.i635.i, %.6.i11.i273.i635.i
  %.385.i275.i637.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i12.i274.i636.i, <8 x double> splat (double 0x3FB642C8590B2164), <8 x double> splat (double 0x3FB8618618618618))
  %.388.i276.i638.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i12.i274.i636.i, <8 x double> %.385.i275.i637.i, <8 x double> splat (double 0x3FBAF286BCA1AF28))
  %.391.i277.i639.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i12.i274.i636.i, <8 x double> %.388.i276.i638.i, <8 x double> splat (double 0x3FBE1E1E1E1E1E1E))
  %.394.i278.i640.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i12.i274.i636.i, <8 x double> %.391.i277.i639.i, <8 x double> splat (double 0x3FC1111111111111))
  %.397.i279.i641.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i12.i274.i636.i, <8 x double> %.394.i278.i640.i, <8 x double> splat (double 0x3FC3B13B13B13B14))
  %.400.i280.i642.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i12.i274.i636.i, <8 x double> %.397.i279.i641.i, <8 x double> splat (double 0x3FC745D1745D1746))
  %.403.i281.i643.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i12.i274.i636.i, <8 x double> %.400.i280.i642.i, <8 x double> splat (double 0x3FCC71C71C71C71C))
  %.406.i282.i644.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i12.i274.i636.i, <8 x double> %.403.i281.i643.i, <8 x double> splat (double 0x3FD2492492492492))
  %.409.i283.i645.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i12.i274.i636.i, <8 x double> %.406.i282.i644.i, <8 x double> splat (double 4.000000e-01))
  %.412.i284.i646.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i12.i274.i636.i, <8 x double> %.409.i283.i645.i, <8 x double> splat (double 0x3FE5555555555555))
  %.415.i285.i647.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i12.i274.i636.i, <8 x double> %.412.i284.i646.i, <8 x double> splat (double 2.000000e+00))
  %.6.i13.i286.i648.i = fmul contract <8 x double> %.6.i11.i273.i635.i, %.415.i285.i647.i
  %.442.i287.i649.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i6.i268.i630.i, <8 x double> splat (double 0x3FE62E42FEFA39EF), <8 x double> %.6.i13.i286.i648.i)
  %.8.i15.i288.i650.i = fadd contract <8 x double> %.6.i.i620.i, splat (double 3.200000e+01)
  %.6.i16.i289.i651.i = fmul contract <8 x double> %.8.i15.i288.i650.i, %.6.i.i262.i624.i
  %.6.i17.i290.i652.i = fmul contract <8 x double> %.8.i1.i261.i623.i, %.6.i16.i289.i651.i
  %.6.i18.i291.i653.i = fmul contract <8 x double> %.8.i1.i261.i623.i, %.6.i17.i290.i652.i
  store <8 x double> %.6.i18.i291.i653.i, ptr %.234.i.i, align 8, !noalias !42
  %.8.i19.i292.i654.i = fmul contract <8 x double> %.442.i287.i649.i, splat (double 0xBFD5555555555555)
  %.604.i293.i655.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i19.i292.i654.i, <8 x double> splat (double 0x3FF71547652B82FE), <8 x double> splat (double 0x4338000000000000))
  %.8.i20.i294.i656.i = fadd contract <8 x double> %.604.i293.i655.i, splat (double 0xC338000000000000)
  %.633.i295.i657.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i20.i294.i656.i, <8 x double> splat (double 0xBFE62E42FEFA39EF), <8 x double> %.8.i19.i292.i654.i)
  %.636.i296.i658.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i20.i294.i656.i, <8 x double> splat (double 0xBC7ABC9E3B39803F), <8 x double> %.633.i295.i657.i)
  %.641.i297.i659.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.636.i296.i658.i, <8 x double> splat (double 0x3DE6124613A86D09), <8 x double> splat (double 0x3E21EED8EFF8D898))
  %.644.i298.i660.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.636.i296.i658.i, <8 x double> %.641.i297.i659.i, <8 x double> splat (double 0x3E5AE64567F544E4))
  %.647.i299.i661.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.636.i296.i658.i, <8 x double> %.644.i298.i660.i, <8 x double> splat (double 0x3E927E4FB7789F5C))
  %.650.i300.i662.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.636.i296.i658.i, <8 x double> %.647.i299.i661.i, <8 x double> splat (double 0x3EC71DE3A556C734))
  %.653.i301.i663.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.636.i296.i658.i, <8 x double> %.650.i300.i662.i, <8 x double> splat (double 0x3EFA01A01A01A01A))
  %.656.i302.i664.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.636.i296.i658.i, <8 x double> %.653.i301.i663.i, <8 x double> splat (double 0x3F2A01A01A01A01A))
  %.659.i303.i665.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.636.i296.i658.i, <8 x double> %.656.i302.i664.i, <8 x double> splat (double 0x3F56C16C16C16C17))
  %.662.i304.i666.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.636.i296.i658.i, <8 x double> %.659.i303.i665.i, <8 x double> splat (double 0x3F81111111111111))
  %.665.i305.i667.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.636.i296.i658.i, <8 x double> %.662.i304.i666.i, <8 x double> splat (double 0x3FA5555555555555))
  %.668.i306.i668.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.636.i296.i658.i, <8 x double> %.665.i305.i667.i, <8 x double> splat (double 0x3FC5555555555555))
  %.671.i307.i669.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.636.i296.i658.i, <8 x double> %.668.i306.i668.i, <8 x double> splat (double 5.000000e-01))
  %.6.i21.i308.i670.i = fmul contract <8 x double> %.636.i296.i658.i, %.636.i296.i658.i
  %.8.i22.i309.i671.i = fadd contract <8 x double> %.636.i296.i658.i, splat (double 1.000000e+00)
  %.720.i310.i672.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i21.i308.i670.i, <8 x double> %.671.i307.i669.i, <8 x double> %.8.i22.i309.i671.i)
  %.721.i311.i673.i = bitcast <8 x double> %.604.i293.i655.i to <8 x i64>
  %.8.i23.i312.i674.i = shl <8 x i64> %.721.i311.i673.i, splat (i64 52)
  %.8.i24.i313.i675.i = add <8 x i64> %.8.i23.i312.i674.i, splat (i64 4607182418800017408)
  %88 = bitcast <8 x i64> %.8.i24.i313.i675.i to <8 x double>
  %.6.i25.i314.i676.i = fmul contract <8 x double> %.720.i310.i672.i, %88
  store <8 x double> %.6.i25.i314.i676.i, ptr %sunkaddr49.i.i, align 8, !noalias !42
  %.8.i26.i316.i677.i = fsub contract <8 x double> zeroinitializer, %.442.i287.i649.i
  store <8 x double> %.8.i26.i316.i677.i, ptr %sunkaddr50.i.i, align 8, !noalias !42
  %.6.i27.i320.i679.i = fsub contract <8 x double> %.847.i178.i546.i, %.6.i3.i264.i626.i
  %.6.i28.i323.i681.i = fmul contract <8 x double> %.6.i27.i320.i679.i, %.881.i181.i548.i
  %.6.i29.i326.i683.i = fmul contract <8 x double> %.6.i28.i323.i681.i, %.916.i184.i550.i
  %.945.i327.i684.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i29.i326.i683.i, <8 x double> splat (double 0x3FE45F306DC9C883), <8 x double> splat (double 0x4338000000000000))
  %.8.i30.i328.i685.i = fadd contract <8 x double> %.945.i327.i684.i, splat (double 0xC338000000000000)
  %.986.i329.i686.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i30.i328.i685.i, <8 x double> splat (double 0xBFF921FB54442D18), <8 x double> %.6.i29.i326.i683.i)
  %.1003.i330.i687.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i30.i328.i685.i, <8 x double> splat (double 0xBC91A62633145C07), <8 x double> %.986.i329.i686.i)
  %.6.i31.i331.i688.i = fmul contract <8 x double> %.1003.i330.i687.i, %.1003.i330.i687.i
  %.6.i32.i332.i689.i = fmul contract <8 x double> %.1003.i330.i687.i, %.6.i31.i331.i688.i
  %.1032.i333.i690.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i31.i331.i688.i, <8 x double> splat (double 0xBD6AE7F3E733B81F), <8 x double> splat (double 0x3DE6124613A86D09))
  %.1035.i334.i691.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i31.i331.i688.i, <8 x double> %.1032.i333.i690.i, <8 x double> splat (double 0xBE5AE64567F544E4))
  %.1038.i335.i692.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i31.i331.i688.i, <8 x double> %.1035.i334.i691.i, <8 x double> splat (double 0x3EC71DE3A556C734))
  %.1041.i336.i693.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i31.i331.i688.i, <8 x double> %.1038.i335.i692.i, <8 x double> splat (double 0xBF2A01A01A01A01A))
  %.1044.i337.i694.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i31.i331.i688.i, <8 x double> %.1041.i336.i693.i, <8 x double> splat (double 0x3F81111111111111))
  %.1047.i338.i695.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i31.i331.i688.i, <8 x double> %.1044.i337.i694.i, <8 x double> splat (double 0xBFC5555555555555))
  %.1072.i339.i696.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i32.i332.i689.i, <8 x double> %.1047.i338.i695.i, <8 x double> %.1003.i330.i687.i)
  %.1077.i340.i697.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i31.i331.i688.i, <8 x double> splat (double 0x3D2AE7F3E733B81F), <8 x double> splat (double 0xBDA93974A8C07C9D))
  %.1080.i341.i698.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i31.i331.i688.i, <8 x double> %.1077.i340.i697.i, <8 x double> splat (double 0x3E21EED8EFF8D898))
  %.1083.i342.i699.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i31.i331.i688.i, <8 x double> %.1080.i341.i698.i, <8 x double> splat (double 0xBE927E4FB7789F5C))
  %.1086.i343.i700.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i31.i331.i688.i, <8 x double> %.1083.i342.i699.i, <8 x double> splat (double 0x3EFA01A01A01A01A))
  %.1089.i344.i701.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i31.i331.i688.i, <8 x double> %.1086.i343.i700.i, <8 x double> splat (double 0xBF56C16C16C16C17))
  %.1092.i345.i702.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i31.i331.i688.i, <8 x double> %.1089.i344.i701.i, <8 x double> splat (double 0x3FA5555555555555))
  %.1095.i346.i703.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i31.i331.i688.i, <8 x double> %.1092.i345.i702.i, <8 x double> splat (double -5.000000e-01))
  %.1098.i347.i704.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i31.i331.i688.i, <8 x double> %.1095.i346.i703.i, <8 x double> splat (double 1.000000e+00))
  %.1099.i348.i705.i = bitcast <8 x double> %.945.i327.i684.i to <8 x i64>
  %.1100.i349.i706.i = bitcast <8 x double> %.1072.i339.i696.i to <8 x i64>
  %.1101.i350.i707.i = bitcast <8 x double> %.1098.i347.i704.i to <8 x i64>
  %.6.i33.i351.i708.i = xor <8 x i64> %.1101.i350.i707.i, %.1100.i349.i706.i
  %.8.i34.i352.i709.i = and <8 x i64> %.1099.i348.i705.i, splat (i64 1)
  %89 = icmp eq <8 x i64> %.8.i34.i352.i709.i, zeroinitializer
  %.6.i36.i353.i710.i = select <8 x i1> %89, <8 x i64> zeroinitializer, <8 x i64> %.6.i33.i351.i708.i
  %.8.i37.i354.i711.i = shl <8 x i64> %.1099.i348.i705.i, splat (i64 62)
  %.8.i38.i355.i712.i = and <8 x i64> %.8.i37.i354.i711.i, splat (i64 -9223372036854775808)
  %.8.i40.i356.i713.i = add <8 x i64> %.8.i37.i354.i711.i, splat (i64 4611686018427387904)
  %.8.i41.i357.i714.i = and <8 x i64> %.8.i40.i356.i713.i, splat (i64 -9223372036854775808)
  %90 = xor <8 x i64> %.8.i38.i355.i712.i, %.1100.i349.i706.i
  %.6.i43.i358.i715.i = xor <8 x i64> %90, %.6.i36.i353.i710.i
  %91 = xor <8 x i64> %.8.i41.i357.i714.i, %.1101.i350.i707.i
  %.6.i45.i359.i716.i = xor <8 x i64> %91, %.6.i36.i353.i710.i
  store <8 x i64> %.6.i43.i358.i715.i, ptr %sunkaddr51.i.i, align 8, !noalias !42
  store <8 x i64> %.6.i45.i359.i716.i, ptr %sunkaddr52.i.i, align 8, !noalias !42
  %.6.i46.i364.i718.i = fmul contract <8 x double> %.6.i28.i323.i681.i, %.1466.i222.i585.i
  %.1498.i365.i719.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i46.i364.i718.i, <8 x double> splat (double 0x3FE45F306DC9C883), <8 x double> splat (double 0x4338000000000000))
  %.8.i47.i366.i720.i = fadd contract <8 x double> %.1498.i365.i719.i, splat (double 0xC338000000000000)
  %.1539.i367.i721.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i47.i366.i720.i, <8 x double> splat (double 0xBFF921FB54442D18), <8 x double> %.6.i46.i364.i718.i)
  %.1556.i368.i722.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i47.i366.i720.i, <8 x double> splat (double 0xBC91A62633145C07), <8 x double> %.1539.i367.i721.i)
  %.6.i48.i369.i723.i = fmul contract <8 x double> %.1556.i368.i722.i, %.1556.i368.i722.i
  %.6.i49.i370.i724.i = fmul contract <8 x double> %.1556.i368.i722.i, %.6.i48.i369.i723.i
  %.1585.i371.i725.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i48.i369.i723.i, <8 x double> splat (double 0xBD6AE7F3E733B81F), <8 x double> splat (double 0x3DE6124613A86D09))
  %.1588.i372.i726.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i48.i369.i723.i, <8 x double> %.1585.i371.i725.i, <8 x double> splat (double 0xBE5AE64567F544E4))
  %.1591.i373.i727.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i48.i369.i723.i, <8 x double> %.1588.i372.i726.i, <8 x double> splat (double 0x3EC71DE3A556C734))
  %.1594.i374.i728.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i48.i369.i723.i, <8 x double> %.1591.i373.i727.i, <8 x double> splat (double 0xBF2A01A01A01A01A))
  %.1597.i375.i729.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i48.i369.i723.i, <8 x double> %.1594.i374.i728.i, <8 x double> splat (double 0x3F81111111111111))
  %.1600.i376.i730.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i48.i369.i723.i, <8 x double> %.1597.i375.i729.i, <8 x double> splat (double 0xBFC5555555555555))
  %.1625.i377.i731.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i49.i370.i724.i, <8 x double> %.1600.i376.i730.i, <8 x double> %.1556.i368.i722.i)
  %.1630.i378.i732.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i48.i369.i723.i, <8 x double> splat (double 0x3D2AE7F3E733B81F), <8 x double> splat (double 0xBDA93974A8C07C9D))
  %.1633.i379.i733.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i48.i369.i723.i, <8 x double> %.1630.i378.i732.i, <8 x double> splat (double 0x3E21EED8EFF8D898))
  %.1636.i380.i734.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i48.i369.i723.i, <8 x double> %.1633.i379.i733.i, <8 x double> splat (double 0xBE927E4FB7789F5C))
  %.1639.i381.i735.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i48.i369.i723.i, <8 x double> %.1636.i380.i734.i, <8 x double> splat (double 0x3EFA01A01A01A01A))
  %.1642.i382.i736.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i48.i369.i723.i, <8 x double> %.1639.i381.i735.i, <8 x double> splat (double 0xBF56C16C16C16C17))
  %.1645.i383.i737.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i48.i369.i723.i, <8 x double> %.1642.i382.i736.i, <8 x double> splat (double 0x3FA5555555555555))
  %.1648.i384.i738.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i48.i369.i723.i, <8 x double> %.1645.i383.i737.i, <8 x double> splat (double -5.000000e-01))
  %.1651.i385.i739.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i48.i369.i723.i, <8 x double> %.1648.i384.i738.i, <8 x double> splat (double 1.000000e+00))
  %.1652.i386.i740.i = bitcast <8 x double> %.1498.i365.i719.i to <8 x i64>
  %.1653.i387.i741.i = bitcast <8 x double> %.1625.i377.i731.i to <8 x i64>
  %.1654.i388.i742.i = bitcast <8 x double> %.1651.i385.i739.i to <8 x i64>
  %.6.i50.i389.i743.i = xor <8 x i64> %.1654.i388.i742.i, %.1653.i387.i741.i
  %.8.i51.i390.i744.i = and <8 x i64> %.1652.i386.i740.i, splat (i64 1)
  %92 = icmp eq <8 x i64> %.8.i51.i390.i744.i, zeroinitializer
  %.6.i53.i391.i745.i = select <8 x i1> %92, <8 x i64> zeroinitializer, <8 x i64> %.6.i50.i389.i743.i
  %.8.i54.i392.i746.i = shl <8 x i64> %.1652.i386.i740.i, splat (i64 62)
  %.8.i55.i393.i747.i = and <8 x i64> %.8.i54.i392.i746.i, splat (i64 -9223372036854775808)
  %.8.i57.i394.i748.i = add <8 x i64> %.8.i54.i392.i746.i, splat (i64 4611686018427387904)
  %.8.i58.i395.i749.i = and <8 x i64> %.8.i57.i394.i748.i, splat (i64 -9223372036854775808)
  %93 = xor <8 x i64> %.8.i55.i393.i747.i, %.1653.i387.i741.i
  %.6.i60.i396.i750.i = xor <8 x i64> %93, %.6.i53.i391.i745.i
  %94 = xor <8 x i64> %.8.i58.i395.i749.i, %.1654.i388.i742.i
  %.6.i62.i397.i751.i = xor <8 x i64> %94, %.6.i53.i391.i745.i
  store <8 x i64> %.6.i60.i396.i750.i, ptr %sunkaddr53.i.i, align 8, !noalias !42
  store <8 x i64> %.6.i62.i397.i751.i, ptr %sunkaddr54.i.i, align 8, !noalias !42
  %.8.i400.i752.i = fmul contract <8 x double> %.1716.i487.i, splat (double 0x3FC5555555555555)
  br label %B13619.if.i.i

B13619.if.i.i:                                    ; preds = %B13619.if.i.i, %B986.if.i458.i
  %lsr.iv11.i753.i = phi i64 [ %lsr.iv.next12.i761.i, %B13619.if.i.i ], [ 13, %B986.if.i458.i ]
  %lsr.iv511.i754.i = phi ptr [ %scevgep.i760.i, %B13619.if.i.i ], [ %scevgep53.i.i, %B986.if.i458.i ]
  %scevgep513.i755.i = getelementptr i8, ptr %lsr.iv511.i754.i, i64 640
  %.2101.i756.i = load <8 x double>, ptr %scevgep513.i755.i, align 8, !noalias !33
  %.2111.i757.i = load <8 x double>, ptr %lsr.iv511.i754.i, align 8, !noalias !33
  %.2113.i758.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i400.i752.i, <8 x double> %.2101.i756.i, <8 x double> %.2111.i757.i)
  %scevgep512.i759.i = getelementptr i8, ptr %lsr.iv511.i754.i, i64 1920
  store <8 x double> %.2113.i758.i, ptr %scevgep512.i759.i, align 8, !noalias !33
  %scevgep.i760.i = getelementptr i8, ptr %lsr.iv511.i754.i, i64 64
  %lsr.iv.next12.i761.i = add nsw i64 %lsr.iv11.i753.i, -1
  %.2054.i762.i = icmp samesign ugt i64 %lsr.iv11.i753.i, 4
  br i1 %.2054.i762.i, label %B13619.if.i.i, label %B13806.if.preheader.i.i

B13806.if.preheader.i.i:                          ; preds = %B13619.if.i.i
  %.8.i.i763.i = fmul contract <8 x double> %.1716.i487.i, splat (double 5.000000e-01)
  br label %B13806.if.i.i

B13806.if.i.i:                                    ; preds = %B13806.if.i.i, %B13806.if.preheader.i.i
  %lsr.iv13.i764.i = phi i64 [ %lsr.iv.next14.i772.i, %B13806.if.i.i ], [ 13, %B13806.if.preheader.i.i ]
  %lsr.iv516.i765.i = phi ptr [ %scevgep517.i771.i, %B13806.if.i.i ], [ %.474.i.i, %B13806.if.preheader.i.i ]
  %scevgep519.i766.i = getelementptr i8, ptr %lsr.iv516.i765.i, i64 -640
  %.2307.i767.i = load <8 x double>, ptr %scevgep519.i766.i, align 8, !noalias !33
  %scevgep518.i768.i = getelementptr i8, ptr %lsr.iv516.i765.i, i64 -1280
  %.2317.i769.i = load <8 x double>, ptr %scevgep518.i768.i, align 8, !noalias !33
  %.2319.i770.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i.i763.i, <8 x double> %.2307.i767.i, <8 x double> %.2317.i769.i)
  store <8 x double> %.2319.i770.i, ptr %lsr.iv516.i765.i, align 8, !noalias !33
  %scevgep517.i771.i = getelementptr i8, ptr %lsr.iv516.i765.i, i64 64
  %lsr.iv.next14.i772.i = add nsw i64 %lsr.iv13.i764.i, -1
  %.2260.i773.i = icmp samesign ugt i64 %lsr.iv13.i764.i, 4
  br i1 %.2260.i773.i, label %B13806.if.i.i, label %B13869.i.i

B13993.if.i.i:                                    ; preds = %B13993.if.i.i, %B13869.i.i
  %lsr.iv.i776.i = phi i64 [ %lsr.iv.next.i783.i, %B13993.if.i.i ], [ 13, %B13869.i.i ]
  %lsr.iv522.i777.i = phi ptr [ %scevgep523.i782.i, %B13993.if.i.i ], [ %.539.i.i, %B13869.i.i ]
  %scevgep524.i778.i = getelementptr i8, ptr %lsr.iv522.i777.i, i64 -1280
  %.2574.i779.i = load <8 x double>, ptr %scevgep524.i778.i, align 8, !noalias !33
  %.2584.i780.i = load <8 x double>, ptr %lsr.iv522.i777.i, align 8, !noalias !33
  %.2586.i781.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i401.i775.i, <8 x double> %.2574.i779.i, <8 x double> %.2584.i780.i)
  store <8 x double> %.2586.i781.i, ptr %lsr.iv522.i777.i, align 8, !noalias !33
  %scevgep523.i782.i = getelementptr i8, ptr %lsr.iv522.i777.i, i64 64
  %lsr.iv.next.i783.i = add nsw i64 %lsr.iv.i776.i, -1
  %.2527.i784.i = icmp samesign ugt i64 %lsr.iv.i776.i, 4
  br i1 %.2527.i784.i, label %B13993.if.i.i, label %B14180.if.i.i

B14180.if.i.i:                                    ; preds = %B13993.if.i.i, %B14180.if.i.i
  %lsr.iv15.i785.i = phi i64 [ %lsr.iv.next16.i793.i, %B14180.if.i.i ], [ 13, %B13993.if.i.i ]
  %lsr.iv527.i786.i = phi ptr [ %scevgep528.i792.i, %B14180.if.i.i ], [ %.474.i.i, %B13993.if.i.i ]
  %scevgep530.i787.i = getelementptr i8, ptr %lsr.iv527.i786.i, i64 -640
  %.2782.i788.i = load <8 x double>, ptr %scevgep530.i787.i, align 8, !noalias !33
  %scevgep529.i789.i = getelementptr i8, ptr %lsr.iv527.i786.i, i64 -1280
  %.2792.i790.i = load <8 x double>, ptr %scevgep529.i789.i, align 8, !noalias !33
  %.2794.i791.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i.i763.i, <8 x double> %.2782.i788.i, <8 x double> %.2792.i790.i)
  store <8 x double> %.2794.i791.i, ptr %lsr.iv527.i786.i, align 8, !noalias !33
  %scevgep528.i792.i = getelementptr i8, ptr %lsr.iv527.i786.i, i64 64
  %lsr.iv.next16.i793.i = add nsw i64 %lsr.iv15.i785.i, -1
  %.2735.i794.i = icmp samesign ugt i64 %lsr.iv15.i785.i, 4
  br i1 %.2735.i794.i, label %B14180.if.i.i, label %B14243.i.i

B14367.if.i.i:                                    ; preds = %B14367.if.i.i, %B14243.i.i
  %lsr.iv17.i796.i = phi i64 [ 13, %B14243.i.i ], [ %lsr.iv.next18.i803.i, %B14367.if.i.i ]
  %lsr.iv533.i797.i = phi ptr [ %.539.i.i, %B14243.i.i ], [ %scevgep534.i802.i, %B14367.if.i.i ]
  %scevgep535.i798.i = getelementptr i8, ptr %lsr.iv533.i797.i, i64 -1280
  %.3054.i799.i = load <8 x double>, ptr %scevgep535.i798.i, align 8, !noalias !33
  %.3064.i800.i = load <8 x double>, ptr %lsr.iv533.i797.i, align 8, !noalias !33
  %.3066.i801.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i401.i775.i, <8 x double> %.3054.i799.i, <8 x double> %.3064.i800.i)
  store <8 x double> %.3066.i801.i, ptr %lsr.iv533.i797.i, align 8, !noalias !33
  %scevgep534.i802.i = getelementptr i8, ptr %lsr.iv533.i797.i, i64 64
  %lsr.iv.next18.i803.i = add nsw i64 %lsr.iv17.i796.i, -1
  %.3007.i804.i = icmp samesign ugt i64 %lsr.iv17.i796.i, 4
  br i1 %.3007.i804.i, label %B14367.if.i.i, label %B14554.if.i.i

B14554.if.i.i:                                    ; preds = %B14367.if.i.i, %B14554.if.i.i
  %lsr.iv19.i805.i = phi i64 [ %lsr.iv.next20.i813.i, %B14554.if.i.i ], [ 13, %B14367.if.i.i ]
  %lsr.iv538.i806.i = phi ptr [ %scevgep539.i812.i, %B14554.if.i.i ], [ %.474.i.i, %B14367.if.i.i ]
  %scevgep541.i807.i = getelementptr i8, ptr %lsr.iv538.i806.i, i64 -640
  %.3260.i808.i = load <8 x double>, ptr %scevgep541.i807.i, align 8, !noalias !33
  %scevgep540.i809.i = getelementptr i8, ptr %lsr.iv538.i806.i, i64 -1280
  %.3270.i810.i = load <8 x double>, ptr %scevgep540.i809.i, align 8, !noalias !33
  %.3272.i811.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1716.i487.i, <8 x double> %.3260.i808.i, <8 x double> %.3270.i810.i)
  store <8 x double> %.3272.i811.i, ptr %lsr.iv538.i806.i, align 8, !noalias !33
  %scevgep539.i812.i = getelementptr i8, ptr %lsr.iv538.i806.i, i64 64
  %lsr.iv.next20.i813.i = add nsw i64 %lsr.iv19.i805.i, -1
  %.3213.i814.i = icmp samesign ugt i64 %lsr.iv19.i805.i, 4
  br i1 %.3213.i814.i, label %B14554.if.i.i, label %B14617.i.i

B14741.if.i.i:                                    ; preds = %B14741.if.i.i, %B14617.i.i
  %lsr.iv21.i816.i = phi i64 [ %lsr.iv.next22.i824.i, %B14741.if.i.i ], [ 13, %B14617.i.i ]
  %lsr.iv544.i817.i = phi ptr [ %scevgep545.i823.i, %B14741.if.i.i ], [ %scevgep53.i.i, %B14617.i.i ]
  %scevgep547.i818.i = getelementptr i8, ptr %lsr.iv544.i817.i, i64 640
  %.3559.i819.i = load <8 x double>, ptr %scevgep547.i818.i, align 8, !noalias !33
  %scevgep546.i820.i = getelementptr i8, ptr %lsr.iv544.i817.i, i64 1920
  %.3569.i821.i = load <8 x double>, ptr %scevgep546.i820.i, align 8, !noalias !33
  %.3571.i822.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i400.i752.i, <8 x double> %.3559.i819.i, <8 x double> %.3569.i821.i)
  store <8 x double> %.3571.i822.i, ptr %lsr.iv544.i817.i, align 8, !noalias !33
  %scevgep545.i823.i = getelementptr i8, ptr %lsr.iv544.i817.i, i64 64
  %lsr.iv.next22.i824.i = add nsw i64 %lsr.iv21.i816.i, -1
  %.3512.i825.i = icmp samesign ugt i64 %lsr.iv21.i816.i, 4
  br i1 %.3512.i825.i, label %B14741.if.i.i, label %B14840.i.i

_ZN17bnserve_surrogate10precession9_dynamics6followB3v88B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIxLi1E1C7mutable7alignedE23Literal_5bint_5d_281_295ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx.exit.i: ; preds = %B14840.i.i, %_ZN17bnserve_surrogate10precession9_dynamics6followB3v36B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIxLi1E1C7mutable7alignedE23Literal_5bint_5d_280_295ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx.exit.i
  call void @llvm.lifetime.end.p0(ptr nonnull %.1111.i15.i), !noalias !0
  call void @llvm.lifetime.end.p0(ptr nonnull %.2357.i17.i), !noalias !0
  call void @llvm.lifetime.end.p0(ptr nonnull %.2832.i19.i), !noalias !0
  call void @llvm.lifetime.end.p0(ptr nonnull %.3310.i21.i), !noalias !0
  call void @llvm.lifetime.end.p0(ptr nonnull %.3609.i23.i), !noalias !0
  %.908.i = add nuw i64 %.13.i75.i.i, %.13.i74.i.i
  %.idx.i = shl i64 %.908.i, 9
  %95 = getelementptr i8, ptr %.390.i, i64 %.idx.i
  %.922.i = getelementptr i8, ptr %95, i64 512
  %.13.i.i = tail call i64 @llvm.smin.i64(i64 %.476.i, i64 %.746.i)
  %.1047.i = sub i64 %.13.i.i, %.739772799.i
  %.1090761.not.i = icmp slt i64 %.1047.i, 1
  br i1 %.1090761.not.i, label %B1342.i, label %B942.if.preheader.i

B942.if.preheader.i:                              ; preds = %_ZN17bnserve_surrogate10precession9_dynamics6followB3v88B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIxLi1E1C7mutable7alignedE23Literal_5bint_5d_281_295ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx.exit.i
  %scevgep179.i = getelementptr i8, ptr %scevgep.i, i64 %.idx.i
  %scevgep195.i = getelementptr i8, ptr %.49.i, i64 %.idx.i11.i
  %96 = shl i64 %.13.i74.i.i, 6
  br label %B942.if.i

B942.if.i:                                        ; preds = %_ZN17bnserve_surrogate10precession7_source4_rowB4v108B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIxLi1E1C7mutable7alignedEddd5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE.exit.i, %B942.if.preheader.i
  %lsr.iv229.i = phi i64 [ %96, %B942.if.preheader.i ], [ %lsr.iv.next230.i, %_ZN17bnserve_surrogate10precession7_source4_rowB4v108B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIxLi1E1C7mutable7alignedEddd5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE.exit.i ]
  %lsr.iv226.i = phi ptr [ %44, %B942.if.preheader.i ], [ %scevgep227.i, %_ZN17bnserve_surrogate10precession7_source4_rowB4v108B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIxLi1E1C7mutable7alignedEddd5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE.exit.i ]
  %lsr.iv.i = phi i64 [ 0, %B942.if.preheader.i ], [ %lsr.iv.next.i, %_ZN17bnserve_surrogate10precession7_source4_rowB4v108B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIxLi1E1C7mutable7alignedEddd5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE.exit.i ]
  %.1089757763.i = phi i64 [ %.1047.i, %B942.if.preheader.i ], [ %.1099.i, %_ZN17bnserve_surrogate10precession7_source4_rowB4v108B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIxLi1E1C7mutable7alignedEddd5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE.exit.i ]
  %.1096759762.i = phi i64 [ %.739772799.i, %B942.if.preheader.i ], [ %.1103.i, %_ZN17bnserve_surrogate10precession7_source4_rowB4v108B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIxLi1E1C7mutable7alignedEddd5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE.exit.i ]
  %.1099.i = add nsw i64 %.1089757763.i, -1
  %.1103.i = add i64 %.1096759762.i, 1
  %.1129.i = sub nsw i64 %.1096759762.i, %.739772799.i
  %.idx29.i = shl i64 %.1129.i, 4
  %97 = getelementptr i8, ptr %1, i64 %.idx29.i
  %.1160.i = load i64, ptr %97, align 8, !noalias !0
  %98 = getelementptr i8, ptr %97, i64 8
  %.1192.i = load i64, ptr %98, align 8, !noalias !0
  %.1193.i = add i64 %.1160.i, 1
  %.1194.i = add i64 %.1193.i, %.1192.i
  %.120127.not.i.i = icmp slt i64 %.1194.i, 1
  br i1 %.120127.not.i.i, label %B944.endif.i, label %B34.if.preheader.i.i

B34.if.preheader.i.i:                             ; preds = %B942.if.i
  %99 = shl i64 %.1160.i, 9
  %100 = sub i64 %lsr.iv.i, %99
  %101 = mul i64 %.1160.i, -512
  %102 = shl i64 %.1160.i, 6
  %103 = sub i64 %lsr.iv229.i, %102
  %scevgep49.i = getelementptr i8, ptr %scevgep195.i, i64 %100
  %scevgep77.i = getelementptr i8, ptr %lsr.iv226.i, i64 %101
  br label %B34.if.i.i

B34.if.i.i:                                       ; preds = %B34.if.i.i, %B34.if.preheader.i.i
  %lsr.iv231.i = phi i64 [ %lsr.iv.next232.i, %B34.if.i.i ], [ %103, %B34.if.preheader.i.i ]
  %lsr.iv40.i.i = phi i64 [ %lsr.iv.next41.i.i, %B34.if.i.i ], [ %.1194.i, %B34.if.preheader.i.i ]
  %lsr.iv.i.i = phi i64 [ %lsr.iv.next.i.i, %B34.if.i.i ], [ 0, %B34.if.preheader.i.i ]
  %104 = add i64 %lsr.iv.i.i, %103
  %105 = lshr i64 %lsr.iv231.i, 20
  %106 = and i64 %105, 8796093022208
  %scevgep78.i = getelementptr i8, ptr %scevgep77.i, i64 %106
  %107 = shl i64 %lsr.iv.i.i, 3
  %scevgep79.i = getelementptr i8, ptr %scevgep78.i, i64 %107
  %.320.i.i = load double, ptr %scevgep79.i, align 8, !noalias !45
  %scevgep193.i = getelementptr i8, ptr %scevgep179.i, i64 %lsr.iv.i.i
  %scevgep194.i = getelementptr i8, ptr %scevgep193.i, i64 -56
  store double %.320.i.i, ptr %scevgep194.i, align 8, !noalias !45
  %.304.1.i.i = icmp slt i64 %104, -8
  %108 = select i1 %.304.1.i.i, i64 8796093022208, i64 0
  %scevgep74.i = getelementptr i8, ptr %scevgep49.i, i64 %108
  %scevgep75.i = getelementptr i8, ptr %scevgep74.i, i64 %107
  %scevgep76.i = getelementptr i8, ptr %scevgep75.i, i64 28800
  %.320.1.i.i = load double, ptr %scevgep76.i, align 8, !noalias !45
  %scevgep48.i = getelementptr i8, ptr %scevgep193.i, i64 -48
  store double %.320.1.i.i, ptr %scevgep48.i, align 8, !noalias !45
  %.304.2.i.i = icmp slt i64 %104, -16
  %109 = select i1 %.304.2.i.i, i64 8796093022208, i64 0
  %scevgep70.i = getelementptr i8, ptr %scevgep49.i, i64 %109
  %scevgep71.i = getelementptr i8, ptr %scevgep70.i, i64 %107
  %scevgep72.i = getelementptr i8, ptr %scevgep71.i, i64 28864
  %.320.2.i.i = load double, ptr %scevgep72.i, align 8, !noalias !45
  %scevgep46.i = getelementptr i8, ptr %scevgep193.i, i64 -40
  store double %.320.2.i.i, ptr %scevgep46.i, align 8, !noalias !45
  %.304.3.i.i = icmp slt i64 %104, -24
  %110 = select i1 %.304.3.i.i, i64 8796093022208, i64 0
  %scevgep66.i = getelementptr i8, ptr %scevgep49.i, i64 %110
  %scevgep67.i = getelementptr i8, ptr %scevgep66.i, i64 %107
  %scevgep68.i = getelementptr i8, ptr %scevgep67.i, i64 28928
  %.320.3.i.i = load double, ptr %scevgep68.i, align 8, !noalias !45
  %scevgep44.i = getelementptr i8, ptr %scevgep193.i, i64 -32
  store double %.320.3.i.i, ptr %scevgep44.i, align 8, !noalias !45
  %.304.4.i.i = icmp slt i64 %104, -32
  %111 = select i1 %.304.4.i.i, i64 8796093022208, i64 0
  %scevgep62.i = getelementptr i8, ptr %scevgep49.i, i64 %111
  %scevgep63.i = getelementptr i8, ptr %scevgep62.i, i64 %107
  %scevgep64.i = getelementptr i8, ptr %scevgep63.i, i64 28992
  %.320.4.i.i = load double, ptr %scevgep64.i, align 8, !noalias !45
  %scevgep42.i = getelementptr i8, ptr %scevgep193.i, i64 -24
  store double %.320.4.i.i, ptr %scevgep42.i, align 8, !noalias !45
  %.304.5.i.i = icmp slt i64 %104, -40
  %112 = select i1 %.304.5.i.i, i64 8796093022208, i64 0
  %scevgep58.i = getelementptr i8, ptr %scevgep49.i, i64 %112
  %scevgep59.i = getelementptr i8, ptr %scevgep58.i, i64 %107
  %scevgep60.i = getelementptr i8, ptr %scevgep59.i, i64 29056
  %.320.5.i.i = load double, ptr %scevgep60.i, align 8, !noalias !45
  %scevgep40.i = getelementptr i8, ptr %scevgep193.i, i64 -16
  store double %.320.5.i.i, ptr %scevgep40.i, align 8, !noalias !45
  %.304.6.i.i = icmp slt i64 %104, -48
  %113 = select i1 %.304.6.i.i, i64 8796093022208, i64 0
  %scevgep54.i = getelementptr i8, ptr %scevgep49.i, i64 %113
  %scevgep55.i = getelementptr i8, ptr %scevgep54.i, i64 %107
  %scevgep56.i = getelementptr i8, ptr %scevgep55.i, i64 29120
  %.320.6.i.i = load double, ptr %scevgep56.i, align 8, !noalias !45
  %scevgep38.i = getelementptr i8, ptr %scevgep193.i, i64 -8
  store double %.320.6.i.i, ptr %scevgep38.i, align 8, !noalias !45
  %.304.7.i.i = icmp slt i64 %104, -56
  %114 = select i1 %.304.7.i.i, i64 8796093022208, i64 0
  %scevgep50.i = getelementptr i8, ptr %scevgep49.i, i64 %114
  %scevgep51.i = getelementptr i8, ptr %scevgep50.i, i64 %107
  %scevgep52.i = getelementptr i8, ptr %scevgep51.i, i64 29184
  %.320.7.i.i = load double, ptr %scevgep52.i, align 8, !noalias !45
  store double %.320.7.i.i, ptr %scevgep193.i, align 8, !noalias !45
  %lsr.iv.next.i.i = add i64 %lsr.iv.i.i, 64
  %lsr.iv.next41.i.i = add i64 %lsr.iv40.i.i, -1
  %lsr.iv.next232.i = add i64 %lsr.iv231.i, 64
  %exitcond.not.i.i = icmp eq i64 %lsr.iv.next41.i.i, 0
  br i1 %exitcond.not.i.i, label %B944.endif.i, label %B34.if.i.i

B944.endif.i:                                     ; preds = %B34.if.i.i, %B942.if.i
  %.1309.i = icmp slt i64 %.1096759762.i, 0
  %.1310.i = select i1 %.1309.i, i64 %.512.i, i64 0
  %.idx735.i = mul i64 %.1096759762.i, 80
  %115 = getelementptr i8, ptr %17, i64 %.idx735.i
  %116 = getelementptr i8, ptr %115, i64 56
  %.1324.i = getelementptr double, ptr %116, i64 %.1310.i
  %.1325.i = load double, ptr %.1324.i, align 8, !noalias !0
  %.1326.i = fmul contract double %.1325.i, 0x3ED4A8B4A9ED04E3
  %.1329.i = fmul contract double %.1326.i, 0x401921FB54442D18
  %.1333.i = fdiv contract double 1.000000e+00, %.1329.i
  %.88.i.i = load i64, ptr %.87.i.i, align 8, !noalias !48
  %.118.i.i = load i64, ptr %.117.i.i, align 8, !noalias !48
  %117 = add nuw i64 %.88.i.i, 255
  %.757.i.i = lshr i64 %117, 8
  %.736.inv.i.i = icmp slt i64 %.88.i.i, 1
  %.778960.not973.i.i = icmp eq i64 %.757.i.i, 0
  %.778960.not.i.i = select i1 %.736.inv.i.i, i1 true, i1 %.778960.not973.i.i
  br i1 %.778960.not.i.i, label %_ZN17bnserve_surrogate10precession7_source4_rowB4v108B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIxLi1E1C7mutable7alignedEddd5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE.exit.i, label %B606.if.lr.ph.i.i

B606.loopexit.i.i:                                ; preds = %B1054.if.i.i, %B1024.i.i
  %scevgep121.i.i = getelementptr i8, ptr %lsr.iv.i853.i, i64 2048
  %lsr.iv.next.i862.i = add i64 %lsr.iv123.i.i, -256
  %scevgep20.i.i = getelementptr i8, ptr %lsr.iv19.i852.i, i64 4096
  %scevgep27.i.i = getelementptr i8, ptr %lsr.iv26.i.i, i64 4096
  %.778.i.i = icmp sgt i64 %.777930966.i.i, 1
  br i1 %.778.i.i, label %B606.if.i.i, label %_ZN17bnserve_surrogate10precession7_source4_rowB4v108B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIxLi1E1C7mutable7alignedEddd5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE.exit.i

B782.preheader.i.i:                               ; preds = %B606.if.i.i
  %118 = add nsw i64 %.13.i.i854.i, 7
  %.113.inv.i.i.i = icmp slt i64 %.821.i.i, 1
  %.157262.not279.i.i.i = icmp ult i64 %118, 8
  %.157262.not.i.i.i = or i1 %.113.inv.i.i.i, %.157262.not279.i.i.i
  %.487.i.i.i = lshr i64 %118, 3
  %.508303.not308.i.i.i = icmp eq i64 %.487.i.i.i, 0
  %.508303.not.i.i.i = or i1 %.113.inv.i.i.i, %.508303.not308.i.i.i
  %119 = add nuw nsw i64 %.487.i.i.i, 4
  br label %B782.i.i

B782.i.i:                                         ; preds = %_ZN17bnserve_surrogate10precession7_source10_add_modesB4v139B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIxLi1E1C7mutable7alignedExxxx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i.i, %B782.preheader.i.i
  %mode.2.1.i.i = phi i64 [ %last.3.2.i.i, %_ZN17bnserve_surrogate10precession7_source10_add_modesB4v139B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIxLi1E1C7mutable7alignedExxxx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i.i ], [ 0, %B782.preheader.i.i ]
  %.1085.i.i = add nsw i64 %mode.2.1.i.i, 1
  %.1095.i.i = icmp slt i64 %.1085.i.i, %.118.i.i
  br i1 %.1095.i.i, label %B804.i.i, label %B898.i.i

B804.i.i:                                         ; preds = %B782.i.i
  %.1118.i.i = icmp slt i64 %mode.2.1.i.i, -1
  %.1119.i.i = select i1 %.1118.i.i, i64 %.118.i.i, i64 0
  %120 = getelementptr i64, ptr %131, i64 %.1085.i.i
  %.1133.i.i = getelementptr i64, ptr %120, i64 %.1119.i.i
  %.1134.i.i = load i64, ptr %.1133.i.i, align 8, !noalias !48
  %.1151.i.i = icmp slt i64 %mode.2.1.i.i, 0
  %.1152.i.i = select i1 %.1151.i.i, i64 %.118.i.i, i64 0
  %121 = getelementptr i64, ptr %131, i64 %mode.2.1.i.i
  %.1166.i.i = getelementptr i64, ptr %121, i64 %.1152.i.i
  %.1167.i.i = load i64, ptr %.1166.i.i, align 8, !noalias !48
  %.1168.i.i = icmp eq i64 %.1134.i.i, %.1167.i.i
  br i1 %.1168.i.i, label %B840.i.i, label %B898.i.i

B840.i.i:                                         ; preds = %B804.i.i, %B862.i.i
  %last.2.3.i.i = phi i64 [ %.1174.i.i, %B862.i.i ], [ %.1085.i.i, %B804.i.i ]
  %reass.sub.i.i = sub i64 %last.2.3.i.i, %.118.i.i
  %exitcond1006.not.i.i = icmp eq i64 %reass.sub.i.i, -1
  br i1 %exitcond1006.not.i.i, label %B898.i.i, label %B862.i.i

B862.i.i:                                         ; preds = %B840.i.i
  %.1174.i.i = add i64 %last.2.3.i.i, 1
  %.1207.i.i = icmp slt i64 %last.2.3.i.i, -1
  %122 = select i1 %.1207.i.i, i64 %132, i64 0
  %123 = shl i64 %last.2.3.i.i, 3
  %scevgep7.i.i = getelementptr i8, ptr %131, i64 %122
  %scevgep11.i.i = getelementptr i8, ptr %scevgep7.i.i, i64 %123
  %scevgep12.i.i = getelementptr i8, ptr %scevgep11.i.i, i64 8
  %.1223.i.i = load i64, ptr %scevgep12.i.i, align 8, !noalias !48
  %.1257.i.i = icmp eq i64 %.1223.i.i, %.1167.i.i
  br i1 %.1257.i.i, label %B840.i.i, label %B898.i.i

B898.i.i:                                         ; preds = %B862.i.i, %B840.i.i, %B804.i.i, %B782.i.i
  %last.3.2.i.i = phi i64 [ %.1085.i.i, %B804.i.i ], [ %.1085.i.i, %B782.i.i ], [ %.118.i.i, %B840.i.i ], [ %.1174.i.i, %B862.i.i ]
  br i1 %.157262.not.i.i.i, label %B266.i.i.i, label %B48.if.lr.ph.i.i.i

B48.if.lr.ph.i.i.i:                               ; preds = %B898.i.i
  %124 = getelementptr i64, ptr %131, i64 %mode.2.1.i.i
  %.1285.i.i = icmp slt i64 %mode.2.1.i.i, 0
  %.1286.i.i = select i1 %.1285.i.i, i64 %.118.i.i, i64 0
  %.1300.i.i = getelementptr i64, ptr %124, i64 %.1286.i.i
  %.1301.i.i = load i64, ptr %.1300.i.i, align 8, !noalias !48
  %.1303.i.i = sitofp i64 %.1301.i.i to double
  %.1304.i.i = fmul contract double %.1333.i, %.1303.i.i
  %.196.i.i.i = fsub contract double 0.000000e+00, %.1304.i.i
  %.6.i.i.i863.i = insertelement <8 x double> poison, double %.196.i.i.i, i64 0
  %.7.i.i.i864.i = shufflevector <8 x double> %.6.i.i.i863.i, <8 x double> poison, <8 x i32> zeroinitializer
  br label %B48.if.i.i.i

B266.i.i.i:                                       ; preds = %B898.i.i
  br i1 %.113.inv.i.i.i, label %B898.endif.i.i, label %B298.if.i.i.i.preheader

B48.if.i.i.i:                                     ; preds = %B48.if.i.i.i, %B48.if.lr.ph.i.i.i
  %lsr.iv13.i865.i = phi i64 [ %lsr.iv.next14.i869.i, %B48.if.i.i.i ], [ %137, %B48.if.lr.ph.i.i.i ]
  %lsr.iv60.i.i.i = phi i64 [ %lsr.iv.next61.i.i.i, %B48.if.i.i.i ], [ 0, %B48.if.lr.ph.i.i.i ]
  %scevgep122.i.i = getelementptr i8, ptr %lsr.iv.i853.i, i64 %lsr.iv60.i.i.i
  %.206.i.i.i = load <8 x double>, ptr %scevgep122.i.i, align 8, !noalias !51
  %.8.i.i.i866.i = fdiv contract <8 x double> %.7.i.i.i864.i, %.206.i.i.i
  %.234.i.i.i = tail call <8 x double> @llvm.minnum.v8f64(<8 x double> %.8.i.i.i866.i, <8 x double> splat (double -4.000000e+00))
  %.8.i39.i.i.i = fsub contract <8 x double> zeroinitializer, %.234.i.i.i
  %.8.i42.i.i.i = fadd contract <8 x double> %.7.i41.i.i.i, %.8.i39.i.i.i
  %.6.i43.i.i867.i = fmul contract <8 x double> %.8.i39.i.i.i, %.8.i42.i.i.i
  %.310.i.i.i = tail call <8 x double> @llvm.sqrt.v8f64(<8 x double> %.6.i43.i.i867.i)
  %.6.i44.i.i.i = fadd contract <8 x double> %.8.i39.i.i.i, %.310.i.i.i
  %.8.i47.i.i868.i = fmul contract <8 x double> %.7.i46.i.i.i, %.6.i44.i.i.i
  %.8.i50.i.i.i = fsub contract <8 x double> %.8.i47.i.i868.i, %.7.i49.i.i.i
  %scevgep62.i.i.i = getelementptr i8, ptr %.641.i.i, i64 %lsr.iv60.i.i.i
  store <8 x double> %.8.i50.i.i.i, ptr %scevgep62.i.i.i, align 8, !noalias !51
  %lsr.iv.next61.i.i.i = add i64 %lsr.iv60.i.i.i, 64
  %lsr.iv.next14.i869.i = add nsw i64 %lsr.iv13.i865.i, -1
  %.157.i.i.i = icmp sgt i64 %lsr.iv13.i865.i, 5
  br i1 %.157.i.i.i, label %B48.if.i.i.i, label %B298.if.i.i.i.preheader

B298.if.i.i.i.preheader:                          ; preds = %B48.if.i.i.i, %B266.i.i.i
  br label %B298.if.i.i.i

B298.if.i.i.i:                                    ; preds = %B298.if.i.i.i.preheader, %B298.if.i.i.i
  %.504270275.i.i.i = phi i64 [ %.511.i.i.i, %B298.if.i.i.i ], [ 0, %B298.if.i.i.i.preheader ]
  %.511.i.i.i = add nuw nsw i64 %.504270275.i.i.i, 1
  %125 = shl i64 %.504270275.i.i.i, 3
  %scevgep133.i.i = getelementptr i8, ptr %.319.i, i64 %125
  %scevgep134.i.i = getelementptr i8, ptr %scevgep133.i.i, i64 16896
  %.565.i.i.i = load double, ptr %scevgep134.i.i, align 8, !noalias !51
  %.5.i.i.i870.i = fptosi double %.565.i.i.i to i64
  %.13.i.i.i.i = tail call i64 @llvm.smax.i64(i64 %.5.i.i.i870.i, i64 0)
  %.13.i51.i.i.i = tail call i64 @llvm.smin.i64(i64 %.619.i.i.i, i64 %.13.i.i.i.i)
  %.648.i.i.i = sitofp i64 %.13.i51.i.i.i to double
  %.649.i.i.i = fsub contract double %.565.i.i.i, %.648.i.i.i
  %.650.i.i871.i = fsub contract double 1.000000e+00, %.649.i.i.i
  %.660.i.i872.i = fmul contract double %.649.i.i.i, %.649.i.i.i
  %.661.i.i873.i = fmul contract double %.650.i.i871.i, 2.000000e+00
  %.662.i.i874.i = fadd contract double %.661.i.i873.i, 1.000000e+00
  %.663.i.i.i = fmul contract double %.660.i.i872.i, %.662.i.i874.i
  %.665.i.i875.i = fsub contract double 0.000000e+00, %.650.i.i871.i
  %.666.i.i.i = fmul contract double %.660.i.i872.i, %.665.i.i875.i
  %.667.i.i.i = insertelement <8 x double> poison, double %.663.i.i.i, i64 0
  %.668.i.i876.i = insertelement <8 x double> %.667.i.i.i, double %.666.i.i.i, i64 1
  %.669.i.i.i = shufflevector <8 x double> %.668.i.i876.i, <8 x double> poison, <8 x i32> <i32 0, i32 0, i32 0, i32 0, i32 1, i32 1, i32 1, i32 1>
  %.678.idx.i.i.i = shl nsw i64 %.13.i51.i.i.i, 6
  %.678.i.i.i = getelementptr inbounds i8, ptr %.922.i, i64 %.678.idx.i.i.i
  %.680.i.i.i = load <8 x double>, ptr %.678.i.i.i, align 8, !noalias !51
  %.689.i.i.i = getelementptr i8, ptr %.678.i.i.i, i64 64
  %.691.i.i877.i = load <8 x double>, ptr %.689.i.i.i, align 8, !noalias !51
  %.6.i52.i.i.i = fmul contract <8 x double> %.691.i.i877.i, %.669.i.i.i
  %.651.i.i.i = fmul contract double %.649.i.i.i, 2.000000e+00
  %.652.i.i.i = fadd contract double %.651.i.i.i, 1.000000e+00
  %.653.i.i878.i = fmul contract double %.650.i.i871.i, %.650.i.i871.i
  %.654.i.i.i = fmul contract double %.652.i.i.i, %.653.i.i878.i
  %.657.i.i.i = insertelement <8 x double> poison, double %.654.i.i.i, i64 0
  %.656.i.i879.i = fmul contract double %.649.i.i.i, %.653.i.i878.i
  %.658.i.i.i = insertelement <8 x double> %.657.i.i.i, double %.656.i.i879.i, i64 1
  %.659.i.i880.i = shufflevector <8 x double> %.658.i.i.i, <8 x double> poison, <8 x i32> <i32 0, i32 0, i32 0, i32 0, i32 1, i32 1, i32 1, i32 1>
  %.716.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.659.i.i880.i, <8 x double> %.680.i.i.i, <8 x double> %.6.i52.i.i.i)
  %.717.i.i.i = shufflevector <8 x double> %.716.i.i.i, <8 x double> poison, <4 x i32> <i32 0, i32 1, i32 2, i32 3>
  %.718.i.i.i = shufflevector <8 x double> %.716.i.i.i, <8 x double> poison, <4 x i32> <i32 4, i32 5, i32 6, i32 7>
  %.719.i.i.i = fadd contract <4 x double> %.717.i.i.i, %.718.i.i.i
  %.720.i.i881.i = extractelement <4 x double> %.719.i.i.i, i64 0
  %.721.i.i882.i = extractelement <4 x double> %.719.i.i.i, i64 1
  %.722.i.i883.i = extractelement <4 x double> %.719.i.i.i, i64 2
  %.723.i.i.i = extractelement <4 x double> %.719.i.i.i, i64 3
  store double %.720.i.i881.i, ptr %scevgep133.i.i, align 8, !noalias !51
  %scevgep25.i.i = getelementptr i8, ptr %scevgep133.i.i, i64 2112
  store double %.721.i.i882.i, ptr %scevgep25.i.i, align 8, !noalias !51
  %scevgep21.i.i = getelementptr i8, ptr %scevgep133.i.i, i64 4224
  store double %.722.i.i883.i, ptr %scevgep21.i.i, align 8, !noalias !51
  %scevgep18.i.i = getelementptr i8, ptr %scevgep133.i.i, i64 6336
  store double %.723.i.i.i, ptr %scevgep18.i.i, align 8, !noalias !51
  %exitcond.not.i.i.i = icmp eq i64 %smin44.i.i, %.511.i.i.i
  br i1 %exitcond.not.i.i.i, label %B898.endif.i.i, label %B298.if.i.i.i

B1024.i.i:                                        ; preds = %_ZN17bnserve_surrogate10precession7_source10_add_modesB4v139B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIxLi1E1C7mutable7alignedExxxx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i.i, %B606.if.i.i
  %.1489925.not.i.i = icmp slt i64 %.821.i.i, 1
  br i1 %.1489925.not.i.i, label %B606.loopexit.i.i, label %B1054.if.i.i

B606.if.lr.ph.i.i:                                ; preds = %B944.endif.i
  %126 = getelementptr double, ptr %.49.i, i64 %.1129.i
  %127 = getelementptr i8, ptr %126, i64 128
  %.1291.i = load double, ptr %127, align 8, !noalias !0
  %.1292.i = sitofp i64 %.1160.i to double
  %.1293.i = fsub contract double %.1291.i, %.1292.i
  %.1259.i = load double, ptr %126, align 8, !noalias !0
  %.336.i.i = shl i64 %.88.i.i, 4
  %.243.i.i = load i64, ptr %.242.i.i, align 8, !noalias !48
  %.421.i.i = load i64, ptr %.420.i.i, align 8, !noalias !48
  %.331.i.i = shl nsw i64 %.1096759762.i, 4
  %.333.i.i = mul nsw i64 %.88.i.i, %.331.i.i
  %.426.i.i = add nsw i64 %.421.i.i, %.333.i.i
  %.329.i.i = load i64, ptr %.328.i.i, align 8, !noalias !48
  %.334.i.i = add nsw i64 %.329.i.i, %.333.i.i
  %.155.i.i = load i64, ptr %.154.i.i, align 8, !noalias !48
  %128 = inttoptr i64 %.426.i.i to ptr
  %129 = inttoptr i64 %.334.i.i to ptr
  %130 = inttoptr i64 %.155.i.i to ptr
  %.261.i.i849.i = fmul contract double %.1259.i, 6.400000e+01
  %.339.i.i.i = fdiv contract double 5.000000e-01, %.1259.i
  %.6.i40.i.i.i = insertelement <8 x double> poison, double %.261.i.i849.i, i64 0
  %.7.i41.i.i.i = shufflevector <8 x double> %.6.i40.i.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.6.i45.i.i850.i = insertelement <8 x double> poison, double %.339.i.i.i, i64 0
  %.7.i46.i.i.i = shufflevector <8 x double> %.6.i45.i.i850.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.6.i48.i.i851.i = insertelement <8 x double> poison, double %.1293.i, i64 0
  %.7.i49.i.i.i = shufflevector <8 x double> %.6.i48.i.i851.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.619.i.i.i = add nsw i64 %.1194.i, -2
  %131 = inttoptr i64 %.243.i.i to ptr
  %132 = shl i64 %.118.i.i, 3
  %133 = icmp sgt i64 %.118.i.i, 0
  %134 = or disjoint i64 %.336.i.i, 8
  br label %B606.if.i.i

B606.if.i.i:                                      ; preds = %B606.if.lr.ph.i.i, %B606.loopexit.i.i
  %lsr.iv26.i.i = phi ptr [ %128, %B606.if.lr.ph.i.i ], [ %scevgep27.i.i, %B606.loopexit.i.i ]
  %lsr.iv19.i852.i = phi ptr [ %129, %B606.if.lr.ph.i.i ], [ %scevgep20.i.i, %B606.loopexit.i.i ]
  %lsr.iv123.i.i = phi i64 [ %.88.i.i, %B606.if.lr.ph.i.i ], [ %lsr.iv.next.i862.i, %B606.loopexit.i.i ]
  %lsr.iv.i853.i = phi ptr [ %130, %B606.if.lr.ph.i.i ], [ %scevgep121.i.i, %B606.loopexit.i.i ]
  %.777930966.i.i = phi i64 [ %.757.i.i, %B606.if.lr.ph.i.i ], [ %.787.i.i, %B606.loopexit.i.i ]
  %.784934965.i.i = phi i64 [ 0, %B606.if.lr.ph.i.i ], [ %.791.i.i, %B606.loopexit.i.i ]
  %smin44.i.i = tail call i64 @llvm.smin.i64(i64 %lsr.iv123.i.i, i64 256)
  %135 = add nsw i64 %smin44.i.i, 7
  %136 = lshr i64 %135, 3
  %137 = add nuw nsw i64 %136, 4
  tail call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(8448) %.557.i.i, i8 0, i64 8448, i1 false), !noalias !48
  %.787.i.i = add nsw i64 %.777930966.i.i, -1
  %.791.i.i = add nuw i64 %.784934965.i.i, 256
  %.821.i.i = sub nsw i64 %.88.i.i, %.784934965.i.i
  %.13.i.i854.i = tail call i64 @llvm.smin.i64(i64 %.821.i.i, i64 256)
  br i1 %133, label %B782.preheader.i.i, label %B1024.i.i

B898.endif.i.i:                                   ; preds = %B298.if.i.i.i, %B266.i.i.i
  %.99.i.i.i = load i64, ptr %.87.i.i, align 8, !noalias !54
  %.128.i.i.i = load i64, ptr %.117.i.i, align 8, !noalias !54
  %.167.i.i.i = shl i64 %.99.i.i.i, 1
  %.373.i.i.i = shl nsw i64 %.128.i.i.i, 2
  br i1 %.508303.not.i.i.i, label %_ZN17bnserve_surrogate10precession7_source10_add_modesB4v139B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIxLi1E1C7mutable7alignedExxxx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i.i, label %B366.if.preheader.i.i.i

B366.if.preheader.i.i.i:                          ; preds = %B898.endif.i.i
  %.255.i.i.i = load i64, ptr %.242.i.i, align 8, !noalias !54
  %.256.i.i.i = inttoptr i64 %.255.i.i.i to ptr
  %138 = getelementptr i64, ptr %.256.i.i.i, i64 %mode.2.1.i.i
  %.317.i.i.i = icmp slt i64 %mode.2.1.i.i, 0
  %.318.i.i.i = select i1 %.317.i.i.i, i64 %.128.i.i.i, i64 0
  %.332.i.i.i = getelementptr i64, ptr %138, i64 %.318.i.i.i
  %.333.i.i.i = load i64, ptr %.332.i.i.i, align 8, !noalias !54
  %.369.i.i.i = load i64, ptr %.368.i.i.i, align 8, !noalias !54
  %.163.i.i.i = mul i64 %.99.i.i.i, %.331.i.i
  %.165.i.i.i = mul i64 %.163.i.i.i, %.128.i.i.i
  %.161.i.i.i = load i64, ptr %.160.i.i.i, align 8, !noalias !54
  %.166.i.i.i = add nsw i64 %.161.i.i.i, %.165.i.i.i
  %139 = inttoptr i64 %.166.i.i.i to ptr
  %140 = inttoptr i64 %.369.i.i.i to ptr
  %.558.i.i.i.i = sub i64 %last.3.2.i.i, %mode.2.1.i.i
  %.601684.not.i.i.i.i = icmp slt i64 %.558.i.i.i.i, 1
  %.1417.i.i.i.i = icmp eq i64 %.333.i.i.i, 1
  %141 = mul i64 %.99.i.i.i, %mode.2.1.i.i
  %142 = shl i64 %.99.i.i.i, 4
  %.169.reass.i.i.i = mul i64 %142, %.128.i.i.i
  %143 = or disjoint i64 %.169.reass.i.i.i, 8
  %144 = add i64 %.169.reass.i.i.i, 16
  %145 = add i64 %.169.reass.i.i.i, 24
  %.2503.i.i.i.i = icmp eq i64 %.333.i.i.i, 4
  %.2667.i.i.i.i = icmp sgt i64 %.333.i.i.i, 2
  br label %B366.if.i.i.i

B366.if.i.i.i:                                    ; preds = %_ZN17bnserve_surrogate10precession7_points7twistedB4v143B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedExxx5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i.i.i, %B366.if.preheader.i.i.i
  %lsr.iv7.i.i.i = phi i64 [ %lsr.iv.next8.i.i.i, %_ZN17bnserve_surrogate10precession7_points7twistedB4v143B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedExxx5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i.i.i ], [ %119, %B366.if.preheader.i.i.i ]
  %lsr.iv43.i.i.i = phi i64 [ %lsr.iv.next44.i.i.i, %_ZN17bnserve_surrogate10precession7_points7twistedB4v143B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedExxx5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i.i.i ], [ %.13.i.i854.i, %B366.if.preheader.i.i.i ]
  %.514302304.i.i.i = phi i64 [ %.521.i.i.i, %_ZN17bnserve_surrogate10precession7_points7twistedB4v143B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedExxx5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i.i.i ], [ 0, %B366.if.preheader.i.i.i ]
  %146 = add i64 %.514302304.i.i.i, %.784934965.i.i
  %.96.i.i.i.i = getelementptr inbounds double, ptr %.319.i, i64 %.514302304.i.i.i
  %.98.i.i.i.i = load <8 x double>, ptr %.96.i.i.i.i, align 8, !noalias !57
  %.107.i.i.i.i = getelementptr i8, ptr %.96.i.i.i.i, i64 2112
  %.109.i.i.i.i = load <8 x double>, ptr %.107.i.i.i.i, align 8, !noalias !57
  %.8.i.i.i.i.i = fsub contract <8 x double> zeroinitializer, %.109.i.i.i.i
  %.154.i.i.i884.i = getelementptr i8, ptr %.96.i.i.i.i, i64 4224
  %.156.i.i.i885.i = load <8 x double>, ptr %.154.i.i.i884.i, align 8, !noalias !57
  %.166.i.i.i886.i = getelementptr i8, ptr %.96.i.i.i.i, i64 6336
  %.168.i.i.i.i = load <8 x double>, ptr %.166.i.i.i886.i, align 8, !noalias !57
  %.8.i11.i.i.i.i = fsub contract <8 x double> zeroinitializer, %.168.i.i.i.i
  %.6.i12.i.i.i.i = fmul contract <8 x double> %.98.i.i.i.i, %.98.i.i.i.i
  %.6.i13.i.i.i.i = fmul contract <8 x double> %.8.i.i.i.i.i, %.8.i.i.i.i.i
  %.6.i14.i.i.i.i = fadd contract <8 x double> %.6.i12.i.i.i.i, %.6.i13.i.i.i.i
  %.6.i15.i.i.i.i = fmul contract <8 x double> %.156.i.i.i885.i, %.156.i.i.i885.i
  %.6.i16.i.i.i.i = fmul contract <8 x double> %.8.i11.i.i.i.i, %.8.i11.i.i.i.i
  %.6.i17.i.i.i.i = fadd contract <8 x double> %.6.i15.i.i.i.i, %.6.i16.i.i.i.i
  %.6.i18.i.i.i.i = fsub contract <8 x double> %.6.i14.i.i.i.i, %.6.i17.i.i.i.i
  %.8.i19.i.i.i.i = fmul contract <8 x double> %.6.i18.i.i.i.i, zeroinitializer
  br i1 %.601684.not.i.i.i.i, label %B998.i.i.i.i, label %B418.if.lr.ph.i.i.i.i

B462.i.i.i.i:                                     ; preds = %B418.if.i.i.i.i
  %.644.i.i.i.i = mul nsw i64 %.607677687.i.i.i.i, %.99.i.i.i
  %.646.i.i.i.i = add nsw i64 %.644.i.i.i.i, %146
  %.662.idx.i.i.i.i = shl i64 %.646.i.i.i.i, 4
  %.662.i.i.i.i = getelementptr inbounds i8, ptr %139, i64 %.662.idx.i.i.i.i
  br label %B604.i.i.i.i

B496.i.i.i.i:                                     ; preds = %B418.if.i.i.i.i
  br i1 %164, label %B532.if.preheader.i.i.i.i, label %B604.i.i.i.i

B532.if.preheader.i.i.i.i:                        ; preds = %B496.i.i.i.i
  br i1 %165, label %B532.if.epil.preheader.i.i.i.i, label %B532.if.i.i.i.i

B604.loopexit.unr-lcssa.i.i.i.i:                  ; preds = %B532.if.i.i.i.i
  br i1 %167, label %B532.if.epil.preheader.i.i.i.i, label %B604.i.i.i.i

B532.if.epil.preheader.i.i.i.i:                   ; preds = %B604.loopexit.unr-lcssa.i.i.i.i, %B532.if.preheader.i.i.i.i
  %.768671673.epil.init.i.i.i.i = phi i64 [ 0, %B532.if.preheader.i.i.i.i ], [ %.775.1.1.i.i.i.i, %B604.loopexit.unr-lcssa.i.i.i.i ]
  %147 = add i64 %.768671673.epil.init.i.i.i.i, %lsr.iv98.i.i.i.i
  %.816.epil.i.i.i.i = icmp slt i64 %147, 0
  %148 = select i1 %.816.epil.i.i.i.i, i64 %.169.reass.i.i.i, i64 0
  %scevgep96.epil.i.i.i.i = getelementptr i8, ptr %lsr.iv94.i.i.i.i, i64 %148
  %149 = shl i64 %.768671673.epil.init.i.i.i.i, 3
  %scevgep97.epil.i.i.i.i = getelementptr i8, ptr %scevgep96.epil.i.i.i.i, i64 %149
  %.832.epil.i.i.i.i = load double, ptr %scevgep97.epil.i.i.i.i, align 8, !noalias !57
  %sunkaddr111.epil.i.i.i.i = getelementptr i8, ptr %.641.i.i, i64 %149
  store double %.832.epil.i.i.i.i, ptr %sunkaddr111.epil.i.i.i.i, align 8, !noalias !57
  %scevgep87.epil.i.i.i.i = getelementptr i8, ptr %scevgep97.epil.i.i.i.i, i64 8
  %.832.1.epil.i.i.i.i = load double, ptr %scevgep87.epil.i.i.i.i, align 8, !noalias !57
  %sunkaddr114.epil.i.i.i.i = getelementptr i8, ptr %sunkaddr111.epil.i.i.i.i, i64 8
  store double %.832.1.epil.i.i.i.i, ptr %sunkaddr114.epil.i.i.i.i, align 8, !noalias !57
  br label %B604.i.i.i.i

B604.i.i.i.i:                                     ; preds = %B532.if.epil.preheader.i.i.i.i, %B604.loopexit.unr-lcssa.i.i.i.i, %B496.i.i.i.i, %B462.i.i.i.i
  %.880.sink83.in.i.i.i.i = phi ptr [ %.662.i.i.i.i, %B462.i.i.i.i ], [ %.641.i.i, %B532.if.epil.preheader.i.i.i.i ], [ %.641.i.i, %B496.i.i.i.i ], [ %.641.i.i, %B604.loopexit.unr-lcssa.i.i.i.i ]
  %.880.sink83.i.i.i.i = load <16 x double>, ptr %.880.sink83.in.i.i.i.i, align 8, !noalias !57
  %.881.i.i.i.i = shufflevector <16 x double> %.880.sink83.i.i.i.i, <16 x double> poison, <8 x i32> <i32 0, i32 2, i32 4, i32 6, i32 8, i32 10, i32 12, i32 14>
  %.882.i.i.i.i = shufflevector <16 x double> %.880.sink83.i.i.i.i, <16 x double> poison, <8 x i32> <i32 1, i32 3, i32 5, i32 7, i32 9, i32 11, i32 13, i32 15>
  %.910.i.i.i.i = icmp slt i64 %.607677687.i.i.i.i, 0
  %.911.i.i.i.i = select i1 %.910.i.i.i.i, i64 %.373.i.i.i, i64 0
  %.idx.i.i.i.i = shl i64 %.607677687.i.i.i.i, 5
  %150 = getelementptr i8, ptr %140, i64 %.idx.i.i.i.i
  %151 = getelementptr i8, ptr %150, i64 8
  %.925.i.i.i.i = getelementptr double, ptr %151, i64 %.911.i.i.i.i
  %.926.i.i.i.i = load double, ptr %.925.i.i.i.i, align 8, !noalias !57
  %.957.i.i.i.i = getelementptr double, ptr %150, i64 %.911.i.i.i.i
  %.958.i.i.i.i = load double, ptr %.957.i.i.i.i, align 8, !noalias !57
  %.960.i.i.i.i = insertelement <8 x double> poison, double %.926.i.i.i.i, i64 0
  %.961.i.i.i.i = shufflevector <8 x double> %.960.i.i.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.962.i.i.i.i = insertelement <8 x double> poison, double %.958.i.i.i.i, i64 0
  %.963.i.i.i.i = shufflevector <8 x double> %.962.i.i.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.964.i.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i18.i.i.i.i, <8 x double> %.961.i.i.i.i, <8 x double> %.963.i.i.i.i)
  %152 = getelementptr i8, ptr %150, i64 24
  %.996.i.i.i.i = getelementptr double, ptr %152, i64 %.911.i.i.i.i
  %.997.i.i.i.i = load double, ptr %.996.i.i.i.i, align 8, !noalias !57
  %153 = getelementptr i8, ptr %150, i64 16
  %.1031.i.i.i.i = getelementptr double, ptr %153, i64 %.911.i.i.i.i
  %.1032.i.i.i.i = load double, ptr %.1031.i.i.i.i, align 8, !noalias !57
  %.1034.i.i.i.i = insertelement <8 x double> poison, double %.997.i.i.i.i, i64 0
  %.1035.i.i.i.i = shufflevector <8 x double> %.1034.i.i.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1036.i.i.i.i = insertelement <8 x double> poison, double %.1032.i.i.i.i, i64 0
  %.1037.i.i.i.i = shufflevector <8 x double> %.1036.i.i.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1038.i.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i18.i.i.i.i, <8 x double> %.1035.i.i.i.i, <8 x double> %.1037.i.i.i.i)
  %.1043.i.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.964.i.i.i.i, <8 x double> %.881.i.i.i.i, <8 x double> %up.3.sroa.0.0692.i.i.i.i)
  %.1048.i.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.964.i.i.i.i, <8 x double> %.882.i.i.i.i, <8 x double> %up.3.sroa.10.0691.i.i.i.i)
  %.1065.i.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1038.i.i.i.i, <8 x double> %.881.i.i.i.i, <8 x double> %down.3.sroa.0.0690.i.i.i.i)
  %.1074.i.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1038.i.i.i.i, <8 x double> %.882.i.i.i.i, <8 x double> %down.3.sroa.10.0689.i.i.i.i)
  %scevgep95.i.i.i.i = getelementptr i8, ptr %lsr.iv94.i.i.i.i, i64 %142
  %lsr.iv.next99.i.i.i.i = add i64 %lsr.iv98.i.i.i.i, %.167.i.i.i
  %.601.i.i.i.i = icmp sgt i64 %.600676688.i.i.i.i, 1
  br i1 %.601.i.i.i.i, label %B418.if.i.i.i.i, label %B998.i.i.i.i

B998.i.i.i.i:                                     ; preds = %B604.i.i.i.i, %B366.if.i.i.i
  %down.3.sroa.10.0.lcssa.i.i.i.i = phi <8 x double> [ %.8.i19.i.i.i.i, %B366.if.i.i.i ], [ %.1074.i.i.i.i, %B604.i.i.i.i ]
  %down.3.sroa.0.0.lcssa.i.i.i.i = phi <8 x double> [ %.8.i19.i.i.i.i, %B366.if.i.i.i ], [ %.1065.i.i.i.i, %B604.i.i.i.i ]
  %up.3.sroa.10.0.lcssa.i.i.i.i = phi <8 x double> [ %.8.i19.i.i.i.i, %B366.if.i.i.i ], [ %.1048.i.i.i.i, %B604.i.i.i.i ]
  %up.3.sroa.0.0.lcssa.i.i.i.i = phi <8 x double> [ %.8.i19.i.i.i.i, %B366.if.i.i.i ], [ %.1043.i.i.i.i, %B604.i.i.i.i ]
  %.6.i24.i.i.i.i = fsub contract <8 x double> %.6.i12.i.i.i.i, %.6.i13.i.i.i.i
  %.6.i25.i.i.i.i = fmul contract <8 x double> %.98.i.i.i.i, %.8.i.i.i.i.i
  %.1261.i.i.i887.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.98.i.i.i.i, <8 x double> %.8.i.i.i.i.i, <8 x double> %.6.i25.i.i.i.i)
  %.6.i28.i.i.i.i = fsub contract <8 x double> %.6.i15.i.i.i.i, %.6.i16.i.i.i.i
  %.6.i29.i.i.i.i = fmul contract <8 x double> %.156.i.i.i885.i, %.8.i11.i.i.i.i
  %.1389.i.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.156.i.i.i885.i, <8 x double> %.8.i11.i.i.i.i, <8 x double> %.6.i29.i.i.i.i)
  br i1 %.1417.i.i.i.i, label %B16033.i.i.i.i, label %B16225.i.i.i.i

B16033.i.i.i.i:                                   ; preds = %B998.i.i.i.i
  %.6.i6.i.i.i.i = fmul contract <8 x double> %.98.i.i.i.i, %.6.i24.i.i.i.i
  %.6.i30.i.i.i.i = fmul contract <8 x double> %.8.i.i.i.i.i, %.1261.i.i.i887.i
  %.6.i31.i.i.i.i = fsub contract <8 x double> %.6.i6.i.i.i.i, %.6.i30.i.i.i.i
  %.6.i32.i.i.i.i = fmul contract <8 x double> %.98.i.i.i.i, %.1261.i.i.i887.i
  %.1541.i.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i24.i.i.i.i, <8 x double> %.8.i.i.i.i.i, <8 x double> %.6.i32.i.i.i.i)
  %.8.i33.i.i.i.i = fsub contract <8 x double> zeroinitializer, %.8.i11.i.i.i.i
  %.6.i34.i.i.i.i = fmul contract <8 x double> %.156.i.i.i885.i, %.6.i31.i.i.i.i
  %.6.i35.i.i.i.i = fmul contract <8 x double> %.8.i33.i.i.i.i, %.1541.i.i.i.i
  %.6.i36.i.i.i.i = fsub contract <8 x double> %.6.i34.i.i.i.i, %.6.i35.i.i.i.i
  %.6.i37.i.i.i.i = fmul contract <8 x double> %.156.i.i.i885.i, %.1541.i.i.i.i
  %.1702.i.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i31.i.i.i.i, <8 x double> %.8.i33.i.i.i.i, <8 x double> %.6.i37.i.i.i.i)
  %.6.i38.i.i.i.i = fmul contract <8 x double> %.156.i.i.i885.i, %.6.i28.i.i.i.i
  %.6.i39.i.i.i.i = fmul contract <8 x double> %.8.i11.i.i.i.i, %.1389.i.i.i.i
  %.6.i40.i.i.i.i = fsub contract <8 x double> %.6.i38.i.i.i.i, %.6.i39.i.i.i.i
  %.6.i41.i.i.i.i = fmul contract <8 x double> %.156.i.i.i885.i, %.1389.i.i.i.i
  %.1839.i.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i28.i.i.i.i, <8 x double> %.8.i11.i.i.i.i, <8 x double> %.6.i41.i.i.i.i)
  %.8.i42.i.i.i.i = fsub contract <8 x double> zeroinitializer, %.8.i.i.i.i.i
  %.6.i43.i.i.i.i = fmul contract <8 x double> %.98.i.i.i.i, %.6.i40.i.i.i.i
  %.6.i44.i.i.i.i = fmul contract <8 x double> %.8.i42.i.i.i.i, %.1839.i.i.i.i
  %.6.i45.i.i.i.i = fsub contract <8 x double> %.6.i43.i.i.i.i, %.6.i44.i.i.i.i
  %.6.i46.i.i.i.i = fmul contract <8 x double> %.98.i.i.i.i, %.1839.i.i.i.i
  %.2004.i.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i40.i.i.i.i, <8 x double> %.8.i42.i.i.i.i, <8 x double> %.6.i46.i.i.i.i)
  br label %_ZN17bnserve_surrogate10precession7_points7twistedB4v143B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedExxx5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i.i.i

B16225.i.i.i.i:                                   ; preds = %B998.i.i.i.i
  %.6.i7.i.i.i.i = fmul contract <8 x double> %.6.i24.i.i.i.i, %.6.i24.i.i.i.i
  %.6.i47.i.i.i.i = fmul contract <8 x double> %.1261.i.i.i887.i, %.1261.i.i.i887.i
  %.6.i48.i.i.i.i = fsub contract <8 x double> %.6.i7.i.i.i.i, %.6.i47.i.i.i.i
  %.6.i49.i.i.i.i = fmul contract <8 x double> %.1261.i.i.i887.i, %.6.i24.i.i.i.i
  %.2194.i.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i24.i.i.i.i, <8 x double> %.1261.i.i.i887.i, <8 x double> %.6.i49.i.i.i.i)
  %.6.i50.i.i.i.i = fmul contract <8 x double> %.6.i28.i.i.i.i, %.6.i28.i.i.i.i
  %.6.i51.i.i.i.i = fmul contract <8 x double> %.1389.i.i.i.i, %.1389.i.i.i.i
  %.6.i52.i.i.i.i = fsub contract <8 x double> %.6.i50.i.i.i.i, %.6.i51.i.i.i.i
  %.6.i53.i.i.i.i = fmul contract <8 x double> %.1389.i.i.i.i, %.6.i28.i.i.i.i
  %.2326.i.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i28.i.i.i.i, <8 x double> %.1389.i.i.i.i, <8 x double> %.6.i53.i.i.i.i)
  %.6.i54.i.i.i.i = fmul contract <8 x double> %.98.i.i.i.i, %.156.i.i.i885.i
  %.6.i55.i.i.i.i = fmul contract <8 x double> %.8.i.i.i.i.i, %.8.i11.i.i.i.i
  %.6.i56.i.i.i.i = fsub contract <8 x double> %.6.i54.i.i.i.i, %.6.i55.i.i.i.i
  %.6.i57.i.i.i.i = fmul contract <8 x double> %.8.i.i.i.i.i, %.156.i.i.i885.i
  %.2476.i.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.98.i.i.i.i, <8 x double> %.8.i11.i.i.i.i, <8 x double> %.6.i57.i.i.i.i)
  br i1 %.2503.i.i.i.i, label %B16333.i.i.i.i, label %B16365.i.i.i.i

B16333.i.i.i.i:                                   ; preds = %B16225.i.i.i.i
  %.6.i8.i.i.i.i = fmul contract <8 x double> %.6.i56.i.i.i.i, %.6.i56.i.i.i.i
  %.6.i58.i.i.i.i = fmul contract <8 x double> %.2476.i.i.i.i, %.2476.i.i.i.i
  %.6.i59.i.i.i.i = fsub contract <8 x double> %.6.i8.i.i.i.i, %.6.i58.i.i.i.i
  %.6.i60.i.i.i.i = fmul contract <8 x double> %.2476.i.i.i.i, %.6.i56.i.i.i.i
  %.2624.i.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i56.i.i.i.i, <8 x double> %.2476.i.i.i.i, <8 x double> %.6.i60.i.i.i.i)
  br label %B16377.i.i.i.i

B16365.i.i.i.i:                                   ; preds = %B16225.i.i.i.i
  br i1 %.2667.i.i.i.i, label %B16377.i.i.i.i, label %_ZN17bnserve_surrogate10precession7_points7twistedB4v143B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedExxx5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i.i.i

B16377.i.i.i.i:                                   ; preds = %B16365.i.i.i.i, %B16333.i.i.i.i
  %_monomials_v144_both.2.sroa.0.05.i.i.i.i = phi <8 x double> [ %.6.i59.i.i.i.i, %B16333.i.i.i.i ], [ %.6.i56.i.i.i.i, %B16365.i.i.i.i ]
  %_monomials_v144_both.2.sroa.11.04.i.i.i.i = phi <8 x double> [ %.2624.i.i.i.i, %B16333.i.i.i.i ], [ %.2476.i.i.i.i, %B16365.i.i.i.i ]
  %.6.i9.i.i.i.i = fmul contract <8 x double> %.6.i48.i.i.i.i, %_monomials_v144_both.2.sroa.0.05.i.i.i.i
  %.6.i61.i.i.i.i = fmul contract <8 x double> %.2194.i.i.i.i, %_monomials_v144_both.2.sroa.11.04.i.i.i.i
  %.6.i62.i.i.i.i = fsub contract <8 x double> %.6.i9.i.i.i.i, %.6.i61.i.i.i.i
  %.6.i63.i.i.i.i = fmul contract <8 x double> %.2194.i.i.i.i, %_monomials_v144_both.2.sroa.0.05.i.i.i.i
  %.2790.i.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i48.i.i.i.i, <8 x double> %_monomials_v144_both.2.sroa.11.04.i.i.i.i, <8 x double> %.6.i63.i.i.i.i)
  %.6.i64.i.i.i.i = fmul contract <8 x double> %.6.i52.i.i.i.i, %_monomials_v144_both.2.sroa.0.05.i.i.i.i
  %.6.i65.i.i.i.i = fmul contract <8 x double> %.2326.i.i.i.i, %_monomials_v144_both.2.sroa.11.04.i.i.i.i
  %.6.i66.i.i.i.i = fsub contract <8 x double> %.6.i64.i.i.i.i, %.6.i65.i.i.i.i
  %.6.i67.i.i.i.i = fmul contract <8 x double> %.2326.i.i.i.i, %_monomials_v144_both.2.sroa.0.05.i.i.i.i
  %.2926.i.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i52.i.i.i.i, <8 x double> %_monomials_v144_both.2.sroa.11.04.i.i.i.i, <8 x double> %.6.i67.i.i.i.i)
  br label %_ZN17bnserve_surrogate10precession7_points7twistedB4v143B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedExxx5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i.i.i

B418.if.lr.ph.i.i.i.i:                            ; preds = %B366.if.i.i.i
  %154 = tail call i64 @llvm.smax.i64(i64 %lsr.iv43.i.i.i, i64 0)
  %storemerge669.i.i.i.i = shl nuw i64 %154, 1
  %155 = add i64 %146, %141
  %156 = shl i64 %155, 4
  %scevgep.i.i.i.i = getelementptr i8, ptr %139, i64 %156
  %157 = shl i64 %155, 1
  %158 = add i64 %storemerge669.i.i.i.i, -2
  %159 = lshr exact i64 %158, 1
  %160 = add nuw i64 %159, 1
  %161 = lshr i64 %160, 1
  %162 = mul nsw i64 %161, -2
  %163 = icmp sgt i64 %lsr.iv43.i.i.i, 7
  %164 = icmp sgt i64 %storemerge669.i.i.i.i, 0
  %165 = icmp eq i64 %158, 0
  %166 = and i64 %158, 2
  %167 = icmp eq i64 %166, 0
  br label %B418.if.i.i.i.i

B418.if.i.i.i.i:                                  ; preds = %B418.if.lr.ph.i.i.i.i, %B604.i.i.i.i
  %lsr.iv98.i.i.i.i = phi i64 [ %157, %B418.if.lr.ph.i.i.i.i ], [ %lsr.iv.next99.i.i.i.i, %B604.i.i.i.i ]
  %lsr.iv94.i.i.i.i = phi ptr [ %scevgep.i.i.i.i, %B418.if.lr.ph.i.i.i.i ], [ %scevgep95.i.i.i.i, %B604.i.i.i.i ]
  %up.3.sroa.0.0692.i.i.i.i = phi <8 x double> [ %.8.i19.i.i.i.i, %B418.if.lr.ph.i.i.i.i ], [ %.1043.i.i.i.i, %B604.i.i.i.i ]
  %up.3.sroa.10.0691.i.i.i.i = phi <8 x double> [ %.8.i19.i.i.i.i, %B418.if.lr.ph.i.i.i.i ], [ %.1048.i.i.i.i, %B604.i.i.i.i ]
  %down.3.sroa.0.0690.i.i.i.i = phi <8 x double> [ %.8.i19.i.i.i.i, %B418.if.lr.ph.i.i.i.i ], [ %.1065.i.i.i.i, %B604.i.i.i.i ]
  %down.3.sroa.10.0689.i.i.i.i = phi <8 x double> [ %.8.i19.i.i.i.i, %B418.if.lr.ph.i.i.i.i ], [ %.1074.i.i.i.i, %B604.i.i.i.i ]
  %.600676688.i.i.i.i = phi i64 [ %.558.i.i.i.i, %B418.if.lr.ph.i.i.i.i ], [ %.610.i.i.i.i, %B604.i.i.i.i ]
  %.607677687.i.i.i.i = phi i64 [ %mode.2.1.i.i, %B418.if.lr.ph.i.i.i.i ], [ %.614.i.i.i.i, %B604.i.i.i.i ]
  %.610.i.i.i.i = add nsw i64 %.600676688.i.i.i.i, -1
  %.614.i.i.i.i = add i64 %.607677687.i.i.i.i, 1
  br i1 %163, label %B462.i.i.i.i, label %B496.i.i.i.i

B532.if.i.i.i.i:                                  ; preds = %B532.if.preheader.i.i.i.i, %B532.if.i.i.i.i
  %lsr.iv6.i.i.i.i = phi i64 [ %lsr.iv.next7.i.i.i.i, %B532.if.i.i.i.i ], [ %162, %B532.if.preheader.i.i.i.i ]
  %.768671673.i.i.i.i = phi i64 [ %.775.1.1.i.i.i.i, %B532.if.i.i.i.i ], [ 0, %B532.if.preheader.i.i.i.i ]
  %168 = add i64 %.768671673.i.i.i.i, %lsr.iv98.i.i.i.i
  %.816.i.i.i.i = icmp slt i64 %168, 0
  %169 = select i1 %.816.i.i.i.i, i64 %.169.reass.i.i.i, i64 0
  %scevgep96.i.i.i.i = getelementptr i8, ptr %lsr.iv94.i.i.i.i, i64 %169
  %170 = shl i64 %.768671673.i.i.i.i, 3
  %scevgep97.i.i.i.i = getelementptr i8, ptr %scevgep96.i.i.i.i, i64 %170
  %.832.i.i.i.i = load double, ptr %scevgep97.i.i.i.i, align 8, !noalias !57
  %sunkaddr27.i.i.i.i = getelementptr i8, ptr %.641.i.i, i64 %170
  store double %.832.i.i.i.i, ptr %sunkaddr27.i.i.i.i, align 8, !noalias !57
  %171 = select i1 %.816.i.i.i.i, i64 %143, i64 8
  %scevgep17.i.i.i.i = getelementptr i8, ptr %lsr.iv94.i.i.i.i, i64 %171
  %scevgep23.i.i.i.i = getelementptr i8, ptr %scevgep17.i.i.i.i, i64 %170
  %.832.1.i.i.i.i = load double, ptr %scevgep23.i.i.i.i, align 8, !noalias !57
  %sunkaddr30.i.i.i.i = getelementptr i8, ptr %sunkaddr27.i.i.i.i, i64 8
  store double %.832.1.i.i.i.i, ptr %sunkaddr30.i.i.i.i, align 8, !noalias !57
  %172 = add i64 %168, 2
  %.816.12.i.i.i.i = icmp slt i64 %172, 0
  %173 = select i1 %.816.12.i.i.i.i, i64 %144, i64 16
  %scevgep15.i.i.i.i = getelementptr i8, ptr %lsr.iv94.i.i.i.i, i64 %173
  %scevgep22.i.i.i.i = getelementptr i8, ptr %scevgep15.i.i.i.i, i64 %170
  %.832.13.i.i.i.i = load double, ptr %scevgep22.i.i.i.i, align 8, !noalias !57
  %sunkaddr33.i.i.i.i = getelementptr i8, ptr %sunkaddr27.i.i.i.i, i64 16
  store double %.832.13.i.i.i.i, ptr %sunkaddr33.i.i.i.i, align 8, !noalias !57
  %.775.1.1.i.i.i.i = add i64 %.768671673.i.i.i.i, 4
  %174 = select i1 %.816.12.i.i.i.i, i64 %145, i64 24
  %scevgep5.i.i.i.i = getelementptr i8, ptr %lsr.iv94.i.i.i.i, i64 %174
  %scevgep18.i.i.i.i = getelementptr i8, ptr %scevgep5.i.i.i.i, i64 %170
  %.832.1.1.i.i.i.i = load double, ptr %scevgep18.i.i.i.i, align 8, !noalias !57
  %sunkaddr34.i.i.i.i = shl i64 %.775.1.1.i.i.i.i, 3
  %sunkaddr35.i.i.i.i = getelementptr i8, ptr %.641.i.i, i64 %sunkaddr34.i.i.i.i
  %sunkaddr36.i.i.i.i = getelementptr i8, ptr %sunkaddr35.i.i.i.i, i64 -8
  store double %.832.1.1.i.i.i.i, ptr %sunkaddr36.i.i.i.i, align 8, !noalias !57
  %lsr.iv.next7.i.i.i.i = add i64 %lsr.iv6.i.i.i.i, 2
  %niter.ncmp.1.i.i.i.i = icmp eq i64 %lsr.iv.next7.i.i.i.i, 0
  br i1 %niter.ncmp.1.i.i.i.i, label %B604.loopexit.unr-lcssa.i.i.i.i, label %B532.if.i.i.i.i

_ZN17bnserve_surrogate10precession7_points7twistedB4v143B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedExxx5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i.i.i: ; preds = %B16377.i.i.i.i, %B16365.i.i.i.i, %B16033.i.i.i.i
  %"$1020call.5.2.sroa.24.0.i.i.i.i" = phi <8 x double> [ %.2004.i.i.i.i, %B16033.i.i.i.i ], [ %.2926.i.i.i.i, %B16377.i.i.i.i ], [ %.2326.i.i.i.i, %B16365.i.i.i.i ]
  %"$1020call.5.2.sroa.16.0.i.i.i.i" = phi <8 x double> [ %.6.i45.i.i.i.i, %B16033.i.i.i.i ], [ %.6.i66.i.i.i.i, %B16377.i.i.i.i ], [ %.6.i52.i.i.i.i, %B16365.i.i.i.i ]
  %"$1020call.5.2.sroa.8.0.i.i.i.i" = phi <8 x double> [ %.1702.i.i.i.i, %B16033.i.i.i.i ], [ %.2790.i.i.i.i, %B16377.i.i.i.i ], [ %.2194.i.i.i.i, %B16365.i.i.i.i ]
  %"$1020call.5.2.sroa.0.0.i.i.i.i" = phi <8 x double> [ %.6.i36.i.i.i.i, %B16033.i.i.i.i ], [ %.6.i62.i.i.i.i, %B16377.i.i.i.i ], [ %.6.i48.i.i.i.i, %B16365.i.i.i.i ]
  %.6.i10.i.i.i.i = fmul contract <8 x double> %up.3.sroa.0.0.lcssa.i.i.i.i, %"$1020call.5.2.sroa.0.0.i.i.i.i"
  %.6.i68.i.i.i.i = fmul contract <8 x double> %up.3.sroa.10.0.lcssa.i.i.i.i, %"$1020call.5.2.sroa.8.0.i.i.i.i"
  %.6.i69.i.i.i.i = fsub contract <8 x double> %.6.i10.i.i.i.i, %.6.i68.i.i.i.i
  %.6.i70.i.i.i.i = fmul contract <8 x double> %up.3.sroa.0.0.lcssa.i.i.i.i, %"$1020call.5.2.sroa.8.0.i.i.i.i"
  %.3190.i.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %"$1020call.5.2.sroa.0.0.i.i.i.i", <8 x double> %up.3.sroa.10.0.lcssa.i.i.i.i, <8 x double> %.6.i70.i.i.i.i)
  %.6.i71.i.i.i.i = fmul contract <8 x double> %down.3.sroa.0.0.lcssa.i.i.i.i, %"$1020call.5.2.sroa.16.0.i.i.i.i"
  %.6.i72.i.i.i.i = fmul contract <8 x double> %down.3.sroa.10.0.lcssa.i.i.i.i, %"$1020call.5.2.sroa.24.0.i.i.i.i"
  %.6.i73.i.i.i.i = fsub contract <8 x double> %.6.i71.i.i.i.i, %.6.i72.i.i.i.i
  %.6.i74.i.i.i.i = fmul contract <8 x double> %down.3.sroa.0.0.lcssa.i.i.i.i, %"$1020call.5.2.sroa.24.0.i.i.i.i"
  %.3323.i.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %"$1020call.5.2.sroa.16.0.i.i.i.i", <8 x double> %down.3.sroa.10.0.lcssa.i.i.i.i, <8 x double> %.6.i74.i.i.i.i)
  %.3348.i.i.i.i = getelementptr inbounds double, ptr %.557.i.i, i64 %.514302304.i.i.i
  %.3350.i.i.i.i = load <8 x double>, ptr %.3348.i.i.i.i, align 8, !noalias !57
  %.6.i75.i.i.i.i = fadd contract <8 x double> %.6.i73.i.i.i.i, %.6.i69.i.i.i.i
  %.6.i76.i.i.i.i = fadd contract <8 x double> %.3350.i.i.i.i, %.6.i75.i.i.i.i
  store <8 x double> %.6.i76.i.i.i.i, ptr %.3348.i.i.i.i, align 8, !noalias !57
  %sunkaddr.i.i.i.i = shl i64 %.514302304.i.i.i, 3
  %sunkaddr102.i.i.i.i = getelementptr i8, ptr %.557.i.i, i64 %sunkaddr.i.i.i.i
  %sunkaddr103.i.i.i.i = getelementptr i8, ptr %sunkaddr102.i.i.i.i, i64 2112
  %.3425.i.i.i.i = load <8 x double>, ptr %sunkaddr103.i.i.i.i, align 8, !noalias !57
  %.6.i77.i.i.i.i = fadd contract <8 x double> %.3323.i.i.i.i, %.3190.i.i.i.i
  %.6.i78.i.i.i.i = fadd contract <8 x double> %.6.i77.i.i.i.i, %.3425.i.i.i.i
  store <8 x double> %.6.i78.i.i.i.i, ptr %sunkaddr103.i.i.i.i, align 8, !noalias !57
  %sunkaddr106.i.i.i.i = getelementptr i8, ptr %sunkaddr102.i.i.i.i, i64 4224
  %.3501.i.i.i.i = load <8 x double>, ptr %sunkaddr106.i.i.i.i, align 8, !noalias !57
  %.6.i79.i.i.i.i = fsub contract <8 x double> %.3190.i.i.i.i, %.3323.i.i.i.i
  %.6.i80.i.i.i.i = fadd contract <8 x double> %.6.i79.i.i.i.i, %.3501.i.i.i.i
  store <8 x double> %.6.i80.i.i.i.i, ptr %sunkaddr106.i.i.i.i, align 8, !noalias !57
  %sunkaddr109.i.i.i.i = getelementptr i8, ptr %sunkaddr102.i.i.i.i, i64 6336
  %.3579.i.i.i.i = load <8 x double>, ptr %sunkaddr109.i.i.i.i, align 8, !noalias !57
  %.6.i81.i.i.i.i = fsub contract <8 x double> %.6.i69.i.i.i.i, %.6.i73.i.i.i.i
  %.6.i82.i.i.i.i = fsub contract <8 x double> %.3579.i.i.i.i, %.6.i81.i.i.i.i
  store <8 x double> %.6.i82.i.i.i.i, ptr %sunkaddr109.i.i.i.i, align 8, !noalias !57
  %.521.i.i.i = add nuw i64 %.514302304.i.i.i, 8
  %lsr.iv.next44.i.i.i = add i64 %lsr.iv43.i.i.i, -8
  %lsr.iv.next8.i.i.i = add nsw i64 %lsr.iv7.i.i.i, -1
  %.508.i.i.i = icmp sgt i64 %lsr.iv7.i.i.i, 5
  br i1 %.508.i.i.i, label %B366.if.i.i.i, label %_ZN17bnserve_surrogate10precession7_source10_add_modesB4v139B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIxLi1E1C7mutable7alignedExxxx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i.i

_ZN17bnserve_surrogate10precession7_source10_add_modesB4v139B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIxLi1E1C7mutable7alignedExxxx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i.i: ; preds = %_ZN17bnserve_surrogate10precession7_points7twistedB4v143B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedExxx5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i.i.i, %B898.endif.i.i
  %.1393.i.i = icmp slt i64 %last.3.2.i.i, %.118.i.i
  br i1 %.1393.i.i, label %B782.i.i, label %B1024.i.i

B1054.if.i.i:                                     ; preds = %B1024.i.i, %B1054.if.i.i
  %lsr.iv28.i.i = phi ptr [ %scevgep29.i.i, %B1054.if.i.i ], [ %lsr.iv26.i.i, %B1024.i.i ]
  %lsr.iv21.i855.i = phi ptr [ %scevgep22.i.i, %B1054.if.i.i ], [ %lsr.iv19.i852.i, %B1024.i.i ]
  %.1495924926.i.i = phi i64 [ %.1502.i.i, %B1054.if.i.i ], [ 0, %B1024.i.i ]
  %.1502.i.i = add nuw nsw i64 %.1495924926.i.i, 1
  %175 = add i64 %.1495924926.i.i, %.784934965.i.i
  %sunkaddr.i856.i = shl i64 %.1495924926.i.i, 3
  %sunkaddr45.i857.i = getelementptr i8, ptr %.319.i, i64 %sunkaddr.i856.i
  %sunkaddr46.i858.i = getelementptr i8, ptr %sunkaddr45.i857.i, i64 8448
  %.1559.i.i = load double, ptr %sunkaddr46.i858.i, align 8, !noalias !48
  %sunkaddr49.i859.i = getelementptr i8, ptr %sunkaddr45.i857.i, i64 10560
  %.1590.i.i = load double, ptr %sunkaddr49.i859.i, align 8, !noalias !48
  %.1604.i.i = icmp slt i64 %175, 0
  %176 = select i1 %.1604.i.i, i64 %134, i64 8
  %scevgep33.i.i = getelementptr i8, ptr %lsr.iv21.i855.i, i64 %176
  %scevgep34.i.i = getelementptr i8, ptr %scevgep33.i.i, i64 -8
  store double %.1559.i.i, ptr %scevgep34.i.i, align 8, !noalias !48
  store double %.1590.i.i, ptr %scevgep33.i.i, align 8, !noalias !48
  %sunkaddr52.i860.i = getelementptr i8, ptr %sunkaddr45.i857.i, i64 12672
  %.1683.i.i = load double, ptr %sunkaddr52.i860.i, align 8, !noalias !48
  %sunkaddr55.i861.i = getelementptr i8, ptr %sunkaddr45.i857.i, i64 14784
  %.1715.i.i = load double, ptr %sunkaddr55.i861.i, align 8, !noalias !48
  %scevgep28.i.i = getelementptr i8, ptr %lsr.iv28.i.i, i64 %176
  %scevgep31.i.i = getelementptr i8, ptr %scevgep28.i.i, i64 -8
  store double %.1683.i.i, ptr %scevgep31.i.i, align 8, !noalias !48
  store double %.1715.i.i, ptr %scevgep28.i.i, align 8, !noalias !48
  %scevgep22.i.i = getelementptr i8, ptr %lsr.iv21.i855.i, i64 16
  %scevgep29.i.i = getelementptr i8, ptr %lsr.iv28.i.i, i64 16
  %exitcond1007.not.i.i = icmp eq i64 %smin44.i.i, %.1502.i.i
  br i1 %exitcond1007.not.i.i, label %B606.loopexit.i.i, label %B1054.if.i.i

_ZN17bnserve_surrogate10precession7_source4_rowB4v108B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIxLi1E1C7mutable7alignedEddd5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE.exit.i: ; preds = %B606.loopexit.i.i, %B944.endif.i
  %lsr.iv.next.i = add i64 %lsr.iv.i, 8
  %scevgep227.i = getelementptr i8, ptr %lsr.iv226.i, i64 8
  %lsr.iv.next230.i = add i64 %lsr.iv229.i, 1
  %.1090.i = icmp sgt i64 %.1089757763.i, 1
  br i1 %.1090.i, label %B942.if.i, label %B1342.i

_ZN17bnserve_surrogate10precession7_source5twistB2v3B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIxLi1E1C7mutable7alignedE.exit: ; preds = %B1342.i, %entry
  store i64 0, ptr %retptr, align 8
  ret i32 0
}

; Function Attrs: mustprogress nocallback nofree nounwind willreturn memory(argmem: write)
declare void @llvm.memset.p0.i64(ptr writeonly captures(none), i8, i64, i1 immarg) #1

; Function Attrs: mustprogress nocallback nocreateundeforpoison nofree nosync nounwind speculatable willreturn memory(none)
declare i64 @llvm.smin.i64(i64, i64) #2

; Function Attrs: mustprogress nocallback nocreateundeforpoison nofree nosync nounwind speculatable willreturn memory(none)
declare <8 x double> @llvm.minnum.v8f64(<8 x double>, <8 x double>) #2

; Function Attrs: mustprogress nocallback nocreateundeforpoison nofree nosync nounwind speculatable willreturn memory(none)
declare <8 x double> @llvm.sqrt.v8f64(<8 x double>) #2

; Function Attrs: mustprogress nocallback nocreateundeforpoison nofree nosync nounwind speculatable willreturn memory(none)
declare i64 @llvm.smax.i64(i64, i64) #2

; Function Attrs: mustprogress nocallback nocreateundeforpoison nofree nosync nounwind speculatable willreturn memory(none)
declare <8 x double> @llvm.fma.v8f64(<8 x double>, <8 x double>, <8 x double>) #2

; Function Attrs: mustprogress nofree norecurse nosync nounwind willreturn memory(argmem: readwrite)
define internal fastcc void @inner_0(ptr noalias nonnull writeonly captures(none) initializes((0, 8)) %retptr, ptr readonly captures(none) %arg.c.4, ptr readonly captures(none) %arg.place.4, ptr readonly captures(none) %arg.state.4, ptr writeonly captures(none) initializes((0, 640)) %arg.out.4) unnamed_addr #3 {
entry:
  %.59 = getelementptr inbounds nuw i8, ptr %arg.place.4, i64 64
  %.61 = load <8 x double>, ptr %.59, align 8
  %.69 = getelementptr inbounds nuw i8, ptr %arg.place.4, i64 192
  %.71 = load <8 x double>, ptr %.69, align 8
  %.79 = getelementptr inbounds nuw i8, ptr %arg.place.4, i64 256
  %.81 = load <8 x double>, ptr %.79, align 8
  %.89 = getelementptr inbounds nuw i8, ptr %arg.place.4, i64 320
  %.91 = load <8 x double>, ptr %.89, align 8
  %.99 = getelementptr inbounds nuw i8, ptr %arg.place.4, i64 384
  %.101 = load <8 x double>, ptr %.99, align 8
  %.111 = load <8 x double>, ptr %arg.state.4, align 8
  %.119 = getelementptr inbounds nuw i8, ptr %arg.state.4, i64 64
  %.121 = load <8 x double>, ptr %.119, align 8
  %.129 = getelementptr inbounds nuw i8, ptr %arg.state.4, i64 128
  %.131 = load <8 x double>, ptr %.129, align 8
  %.139 = getelementptr inbounds nuw i8, ptr %arg.state.4, i64 192
  %.141 = load <8 x double>, ptr %.139, align 8
  %.149 = getelementptr inbounds nuw i8, ptr %arg.state.4, i64 256
  %.151 = load <8 x double>, ptr %.149, align 8
  %.159 = getelementptr inbounds nuw i8, ptr %arg.state.4, i64 320
  %.161 = load <8 x double>, ptr %.159, align 8
  %.6.i = fmul contract <8 x double> %.81, %.111
  %.6.i1 = fmul contract <8 x double> %.71, %.121
  %.6.i2 = fsub contract <8 x double> %.6.i, %.6.i1
  %.6.i3 = fmul contract <8 x double> %.71, %.111
  %.6.i4 = fmul contract <8 x double> %.81, %.121
  %.6.i5 = fadd contract <8 x double> %.6.i3, %.6.i4
  %.6.i6 = fmul contract <8 x double> %.101, %.141
  %.6.i7 = fmul contract <8 x double> %.91, %.151
  %.6.i8 = fsub contract <8 x double> %.6.i6, %.6.i7
  %.6.i9 = fmul contract <8 x double> %.91, %.141
  %.6.i10 = fmul contract <8 x double> %.101, %.151
  %.6.i11 = fadd contract <8 x double> %.6.i9, %.6.i10
  %.460 = getelementptr inbounds nuw i8, ptr %arg.place.4, i64 128
  %.462 = load <8 x double>, ptr %.460, align 8
  %.6.i12 = fmul contract <8 x double> %.131, %.161
  %.487 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i5, <8 x double> %.6.i11, <8 x double> %.6.i12)
  %.488 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i2, <8 x double> %.6.i8, <8 x double> %.487)
  %.499 = getelementptr inbounds nuw i8, ptr %arg.c.4, i64 2176
  %.501 = load <8 x double>, ptr %.499, align 8
  %.6.i13 = fmul contract <8 x double> %.501, %.488
  %.533 = getelementptr inbounds nuw i8, ptr %arg.c.4, i64 2240
  %.535 = load <8 x double>, ptr %.533, align 8
  %.6.i14 = fmul contract <8 x double> %.131, %.535
  %.568 = getelementptr inbounds nuw i8, ptr %arg.c.4, i64 2304
  %.570 = load <8 x double>, ptr %.568, align 8
  %.6.i15 = fmul contract <8 x double> %.131, %.570
  %.603 = getelementptr inbounds nuw i8, ptr %arg.c.4, i64 2368
  %.605 = load <8 x double>, ptr %.603, align 8
  %.6.i16 = fmul contract <8 x double> %.161, %.605
  %.560 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i14, <8 x double> %.161, <8 x double> %.6.i13)
  %.595 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i15, <8 x double> %.131, <8 x double> %.560)
  %.630 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i16, <8 x double> %.161, <8 x double> %.595)
  %.6.i17 = fmul contract <8 x double> %.61, %.61
  %.6.i18 = fmul contract <8 x double> %.61, %.6.i17
  %.687 = getelementptr inbounds nuw i8, ptr %arg.c.4, i64 1280
  %.689 = load <8 x double>, ptr %.687, align 8
  %.700 = getelementptr inbounds nuw i8, ptr %arg.c.4, i64 1664
  %.702 = load <8 x double>, ptr %.700, align 8
  %.711 = getelementptr inbounds nuw i8, ptr %arg.c.4, i64 1920
  %.713 = load <8 x double>, ptr %.711, align 8
  %.717 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.713, <8 x double> %.161, <8 x double> %.689)
  %.718 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.702, <8 x double> %.131, <8 x double> %.717)
  %.727 = getelementptr inbounds nuw i8, ptr %arg.c.4, i64 1408
  %.729 = load <8 x double>, ptr %.727, align 8
  %.740 = getelementptr inbounds nuw i8, ptr %arg.c.4, i64 1728
  %.742 = load <8 x double>, ptr %.740, align 8
  %.751 = getelementptr inbounds nuw i8, ptr %arg.c.4, i64 1984
  %.753 = load <8 x double>, ptr %.751, align 8
  %.767 = getelementptr inbounds nuw i8, ptr %arg.c.4, i64 1472
  %.769 = load <8 x double>, ptr %.767, align 8
  %.783 = getelementptr inbounds nuw i8, ptr %arg.c.4, i64 1792
  %.785 = load <8 x double>, ptr %.783, align 8
  %.794 = getelementptr inbounds nuw i8, ptr %arg.c.4, i64 2048
  %.796 = load <8 x double>, ptr %.794, align 8
  %.810 = getelementptr inbounds nuw i8, ptr %arg.c.4, i64 1536
  %.812 = load <8 x double>, ptr %.810, align 8
  %.823 = getelementptr inbounds nuw i8, ptr %arg.c.4, i64 1856
  %.825 = load <8 x double>, ptr %.823, align 8
  %.834 = getelementptr inbounds nuw i8, ptr %arg.c.4, i64 2112
  %.836 = load <8 x double>, ptr %.834, align 8
  %.849 = getelementptr inbounds nuw i8, ptr %arg.c.4, i64 1600
  %.851 = load <8 x double>, ptr %.849, align 8
  %.862 = getelementptr inbounds nuw i8, ptr %arg.c.4, i64 1344
  %.864 = load <8 x double>, ptr %.862, align 8
  %.6.i19 = fadd contract <8 x double> %.630, %.864
  %.840 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.836, <8 x double> %.161, <8 x double> %.812)
  %.841 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.825, <8 x double> %.131, <8 x double> %.840)
  %.852 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i18, <8 x double> %.851, <8 x double> %.841)
  %.772 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.462, <8 x double> splat (double 0xC015BD5BD5BD5BD6), <8 x double> %.769)
  %.800 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.796, <8 x double> %.161, <8 x double> %.772)
  %.801 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.785, <8 x double> %.131, <8 x double> %.800)
  %.853 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.61, <8 x double> %.852, <8 x double> %.801)
  %.757 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.753, <8 x double> %.161, <8 x double> %.729)
  %.758 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.742, <8 x double> %.131, <8 x double> %.757)
  %.854 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.61, <8 x double> %.853, <8 x double> %.758)
  %.889 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.61, <8 x double> %.854, <8 x double> %.6.i19)
  %.914 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.61, <8 x double> %.889, <8 x double> %.718)
  %.922 = getelementptr inbounds nuw i8, ptr %arg.c.4, i64 1216
  %.924 = load <8 x double>, ptr %.922, align 8
  %.928 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.61, <8 x double> %.914, <8 x double> %.924)
  %.931 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i17, <8 x double> %.928, <8 x double> splat (double 1.000000e+00))
  %.941 = load <8 x double>, ptr %arg.place.4, align 8
  %.8.i = fsub contract <8 x double> zeroinitializer, %.941
  %.973 = getelementptr inbounds nuw i8, ptr %arg.c.4, i64 704
  %.975 = load <8 x double>, ptr %.973, align 8
  %.6.i21 = fmul contract <8 x double> %.8.i, %.975
  %.6.i22 = fdiv contract <8 x double> %.6.i21, %.931
  %.1060 = getelementptr inbounds nuw i8, ptr %arg.c.4, i64 320
  %.1062 = load <8 x double>, ptr %.1060, align 8
  %.1071 = getelementptr inbounds nuw i8, ptr %arg.c.4, i64 256
  %.1073 = load <8 x double>, ptr %.1071, align 8
  %.1082 = getelementptr inbounds nuw i8, ptr %arg.c.4, i64 192
  %.1084 = load <8 x double>, ptr %.1082, align 8
  %.8.i24 = fmul contract <8 x double> %.61, splat (double -1.500000e+00)
  %.1074 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i17, <8 x double> %.1062, <8 x double> %.1073)
  %.1085 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i17, <8 x double> %.1074, <8 x double> %.1084)
  %.1118 = getelementptr inbounds nuw i8, ptr %arg.c.4, i64 384
  %.1120 = load <8 x double>, ptr %.1118, align 8
  %.1124 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1120, <8 x double> %.131, <8 x double> %.161)
  %.1125 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i24, <8 x double> %.1124, <8 x double> %.1085)
  %.1162 = getelementptr inbounds nuw i8, ptr %arg.c.4, i64 576
  %.1164 = load <8 x double>, ptr %.1162, align 8
  %.1173 = getelementptr inbounds nuw i8, ptr %arg.c.4, i64 512
  %.1175 = load <8 x double>, ptr %.1173, align 8
  %.1184 = getelementptr inbounds nuw i8, ptr %arg.c.4, i64 448
  %.1186 = load <8 x double>, ptr %.1184, align 8
  %.1176 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i17, <8 x double> %.1164, <8 x double> %.1175)
  %.1187 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i17, <8 x double> %.1176, <8 x double> %.1186)
  %.1220 = getelementptr inbounds nuw i8, ptr %arg.c.4, i64 640
  %.1222 = load <8 x double>, ptr %.1220, align 8
  %.1226 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1222, <8 x double> %.161, <8 x double> %.131)
  %.1227 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i24, <8 x double> %.1226, <8 x double> %.1187)
  %.8.i27 = fmul contract <8 x double> %.61, splat (double 5.000000e-01)
  %.6.i28 = fmul contract <8 x double> %.131, %.6.i11
  %.6.i29 = fmul contract <8 x double> %.6.i5, %.161
  %.6.i30 = fsub contract <8 x double> %.6.i28, %.6.i29
  %.6.i31 = fmul contract <8 x double> %.8.i27, %.6.i30
  %.6.i32 = fmul contract <8 x double> %.6.i2, %.161
  %.6.i33 = fmul contract <8 x double> %.131, %.6.i8
  %.6.i34 = fsub contract <8 x double> %.6.i32, %.6.i33
  %.6.i35 = fmul contract <8 x double> %.8.i27, %.6.i34
  %.1475 = getelementptr inbounds nuw i8, ptr %arg.c.4, i64 960
  %.1477 = load <8 x double>, ptr %.1475, align 8
  %.1485 = getelementptr inbounds nuw i8, ptr %arg.c.4, i64 768
  %.1487 = load <8 x double>, ptr %.1485, align 8
  %.8.i37 = fdiv contract <8 x double> splat (double 1.000000e+00), %.1487
  %.1512 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i17, <8 x double> %.1477, <8 x double> %.8.i37)
  %.1544 = getelementptr inbounds nuw i8, ptr %arg.c.4, i64 1024
  %.1546 = load <8 x double>, ptr %.1544, align 8
  %.1581 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i17, <8 x double> %.1546, <8 x double> %.8.i37)
  %.1589 = getelementptr inbounds nuw i8, ptr %arg.c.4, i64 1088
  %.1591 = load <8 x double>, ptr %.1589, align 8
  %.1599 = getelementptr inbounds nuw i8, ptr %arg.c.4, i64 1152
  %.1601 = load <8 x double>, ptr %.1599, align 8
  %.6.i40 = fmul contract <8 x double> %.161, %.1601
  %.1626 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1591, <8 x double> %.131, <8 x double> %.6.i40)
  %.1658 = getelementptr inbounds nuw i8, ptr %arg.c.4, i64 896
  %.1660 = load <8 x double>, ptr %.1658, align 8
  %.1661 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.61, <8 x double> %.1660, <8 x double> %.1626)
  %.1669 = getelementptr inbounds nuw i8, ptr %arg.c.4, i64 832
  %.1671 = load <8 x double>, ptr %.1669, align 8
  %.1672 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.61, <8 x double> %.1661, <8 x double> %.1671)
  %.1675 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i17, <8 x double> %.1672, <8 x double> splat (double 1.000000e+00))
  %.8.i42 = fsub contract <8 x double> zeroinitializer, %.6.i22
  %.6.i43 = fmul contract <8 x double> %.61, %.8.i42
  %.6.i44 = fdiv contract <8 x double> %.6.i43, %.1675
  %.6.i45 = fmul contract <8 x double> %.6.i5, %.1125
  %.6.i46 = fsub contract <8 x double> %.6.i31, %.6.i45
  %.6.i47 = fmul contract <8 x double> %.6.i46, %.1512
  %.6.i48 = fmul contract <8 x double> %.6.i11, %.1227
  %.6.i49 = fadd contract <8 x double> %.6.i31, %.6.i48
  %.8.i50 = fsub contract <8 x double> zeroinitializer, %.6.i49
  %.6.i51 = fmul contract <8 x double> %.1581, %.8.i50
  %.6.i52 = fadd contract <8 x double> %.6.i47, %.6.i51
  %.6.i53 = fmul contract <8 x double> %.6.i52, %.6.i44
  %.6.i54 = fmul contract <8 x double> %.6.i2, %.1125
  %.6.i55 = fadd contract <8 x double> %.6.i35, %.6.i54
  %.6.i56 = fmul contract <8 x double> %.6.i55, %.1512
  %.6.i57 = fmul contract <8 x double> %.6.i8, %.1227
  %.6.i58 = fsub contract <8 x double> %.6.i57, %.6.i35
  %.6.i59 = fmul contract <8 x double> %.6.i58, %.1581
  %.6.i60 = fadd contract <8 x double> %.6.i56, %.6.i59
  %.6.i61 = fmul contract <8 x double> %.6.i60, %.6.i44
  %.6.i62 = fmul contract <8 x double> %.1084, %.931
  %.6.i63 = fsub contract <8 x double> %.1125, %.6.i62
  %.6.i64 = fmul contract <8 x double> %.6.i22, %.6.i63
  %.6.i65 = fmul contract <8 x double> %.6.i31, %.6.i22
  %.6.i66 = fmul contract <8 x double> %.6.i5, %.6.i64
  %.6.i67 = fsub contract <8 x double> %.6.i65, %.6.i66
  %.6.i68 = fmul contract <8 x double> %.131, %.6.i53
  %.6.i69 = fsub contract <8 x double> %.6.i67, %.6.i68
  %.6.i70 = fmul contract <8 x double> %.6.i35, %.6.i22
  %.6.i71 = fmul contract <8 x double> %.6.i2, %.6.i64
  %.6.i72 = fadd contract <8 x double> %.6.i70, %.6.i71
  %.6.i73 = fmul contract <8 x double> %.131, %.6.i61
  %.6.i74 = fsub contract <8 x double> %.6.i72, %.6.i73
  %.6.i75 = fmul contract <8 x double> %.81, %.6.i69
  %.6.i76 = fmul contract <8 x double> %.71, %.6.i74
  %.6.i77 = fadd contract <8 x double> %.6.i75, %.6.i76
  store <8 x double> %.6.i77, ptr %arg.out.4, align 8
  %.6.i78 = fmul contract <8 x double> %.81, %.6.i74
  %.6.i79 = fmul contract <8 x double> %.71, %.6.i69
  %.6.i80 = fsub contract <8 x double> %.6.i78, %.6.i79
  %.2784 = getelementptr inbounds nuw i8, ptr %arg.out.4, i64 64
  store <8 x double> %.6.i80, ptr %.2784, align 8
  %.2802 = load <8 x double>, ptr %.1184, align 8
  %.6.i81 = fmul contract <8 x double> %.931, %.2802
  %.6.i82 = fsub contract <8 x double> %.1227, %.6.i81
  %.6.i83 = fmul contract <8 x double> %.6.i22, %.6.i82
  %.6.i85 = fmul contract <8 x double> %.6.i31, %.8.i42
  %.6.i86 = fmul contract <8 x double> %.6.i11, %.6.i83
  %.6.i87 = fsub contract <8 x double> %.6.i85, %.6.i86
  %.6.i88 = fmul contract <8 x double> %.161, %.6.i53
  %.6.i89 = fsub contract <8 x double> %.6.i87, %.6.i88
  %.6.i90 = fmul contract <8 x double> %.6.i8, %.6.i83
  %.6.i92 = fsub contract <8 x double> %.6.i90, %.6.i70
  %.6.i93 = fmul contract <8 x double> %.161, %.6.i61
  %.6.i94 = fsub contract <8 x double> %.6.i92, %.6.i93
  %.3161 = load <8 x double>, ptr %.89, align 8
  %.3172 = load <8 x double>, ptr %.99, align 8
  %.6.i95 = fmul contract <8 x double> %.3172, %.6.i89
  %.6.i96 = fmul contract <8 x double> %.3161, %.6.i94
  %.6.i97 = fadd contract <8 x double> %.6.i95, %.6.i96
  %.3255 = getelementptr inbounds nuw i8, ptr %arg.out.4, i64 192
  store <8 x double> %.6.i97, ptr %.3255, align 8
  %.6.i98 = fmul contract <8 x double> %.3172, %.6.i94
  %.6.i99 = fmul contract <8 x double> %.3161, %.6.i89
  %.6.i100 = fsub contract <8 x double> %.6.i98, %.6.i99
  %.3338 = getelementptr inbounds nuw i8, ptr %arg.out.4, i64 256
  store <8 x double> %.6.i100, ptr %.3338, align 8
  %.6.i101 = fmul contract <8 x double> %.8.i27, %.6.i22
  %.6.i102 = fmul contract <8 x double> %.6.i5, %.6.i8
  %.6.i103 = fmul contract <8 x double> %.6.i2, %.6.i11
  %.6.i104 = fsub contract <8 x double> %.6.i102, %.6.i103
  %.6.i105 = fmul contract <8 x double> %.6.i104, %.6.i101
  %.6.i106 = fmul contract <8 x double> %.6.i2, %.6.i53
  %.6.i107 = fmul contract <8 x double> %.6.i5, %.6.i61
  %.6.i108 = fadd contract <8 x double> %.6.i106, %.6.i107
  %.6.i109 = fadd contract <8 x double> %.6.i105, %.6.i108
  %.3567 = getelementptr inbounds nuw i8, ptr %arg.out.4, i64 128
  store <8 x double> %.6.i109, ptr %.3567, align 8
  %.6.i110 = fmul contract <8 x double> %.6.i8, %.6.i53
  %.6.i111 = fmul contract <8 x double> %.6.i11, %.6.i61
  %.6.i112 = fadd contract <8 x double> %.6.i110, %.6.i111
  %.6.i113 = fsub contract <8 x double> %.6.i112, %.6.i105
  %.3673 = getelementptr inbounds nuw i8, ptr %arg.out.4, i64 320
  store <8 x double> %.6.i113, ptr %.3673, align 8
  %.8.i114 = fmul contract <8 x double> %.6.i53, splat (double 5.000000e-01)
  %.8.i115 = fmul contract <8 x double> %.6.i61, splat (double 5.000000e-01)
  %.3747 = getelementptr inbounds nuw i8, ptr %arg.state.4, i64 384
  %.3749 = load <8 x double>, ptr %.3747, align 8
  %.3757 = getelementptr inbounds nuw i8, ptr %arg.state.4, i64 448
  %.3759 = load <8 x double>, ptr %.3757, align 8
  %.3767 = getelementptr inbounds nuw i8, ptr %arg.state.4, i64 512
  %.3769 = load <8 x double>, ptr %.3767, align 8
  %.3777 = getelementptr inbounds nuw i8, ptr %arg.state.4, i64 576
  %.3779 = load <8 x double>, ptr %.3777, align 8
  %.6.i116 = fmul contract <8 x double> %.8.i114, %.3769
  %.6.i117 = fmul contract <8 x double> %.8.i115, %.3779
  %.6.i118 = fadd contract <8 x double> %.6.i116, %.6.i117
  %.3862 = getelementptr inbounds nuw i8, ptr %arg.out.4, i64 384
  store <8 x double> %.6.i118, ptr %.3862, align 8
  %.6.i119 = fmul contract <8 x double> %.8.i115, %.3769
  %.6.i120 = fmul contract <8 x double> %.8.i114, %.3779
  %.6.i121 = fsub contract <8 x double> %.6.i119, %.6.i120
  %.3944 = getelementptr inbounds nuw i8, ptr %arg.out.4, i64 448
  store <8 x double> %.6.i121, ptr %.3944, align 8
  %.8.i122 = fsub contract <8 x double> zeroinitializer, %.8.i114
  %.6.i123 = fmul contract <8 x double> %.8.i122, %.3749
  %.6.i124 = fmul contract <8 x double> %.8.i115, %.3759
  %.6.i125 = fsub contract <8 x double> %.6.i123, %.6.i124
  %.4050 = getelementptr inbounds nuw i8, ptr %arg.out.4, i64 512
  store <8 x double> %.6.i125, ptr %.4050, align 8
  %.6.i126 = fmul contract <8 x double> %.8.i114, %.3759
  %.6.i127 = fmul contract <8 x double> %.8.i115, %.3749
  %.6.i128 = fsub contract <8 x double> %.6.i126, %.6.i127
  %.4132 = getelementptr inbounds nuw i8, ptr %arg.out.4, i64 576
  store <8 x double> %.6.i128, ptr %.4132, align 8
  store ptr null, ptr %retptr, align 8
  ret void
}

; Function Attrs: mustprogress nocallback nocreateundeforpoison nofree nosync nounwind speculatable willreturn memory(none)
declare double @llvm.log.f64(double) #2

; Function Attrs: mustprogress nocallback nocreateundeforpoison nofree nosync nounwind speculatable willreturn memory(none)
declare double @llvm.exp.f64(double) #2

; Function Attrs: mustprogress nocallback nocreateundeforpoison nofree nosync nounwind speculatable willreturn memory(none)
declare double @llvm.sin.f64(double) #2

; Function Attrs: mustprogress nocallback nocreateundeforpoison nofree nosync nounwind speculatable willreturn memory(none)
declare double @llvm.cos.f64(double) #2

; Function Attrs: mustprogress nocallback nofree nosync nounwind willreturn memory(none)
declare double @sqrt(double) local_unnamed_addr #4

; Function Attrs: nocallback nofree nosync nounwind willreturn memory(argmem: readwrite)
declare void @llvm.lifetime.start.p0(ptr captures(none)) #5

; Function Attrs: nocallback nofree nosync nounwind willreturn memory(argmem: readwrite)
declare void @llvm.lifetime.end.p0(ptr captures(none)) #5

attributes #0 = { nofree norecurse nosync nounwind memory(readwrite, inaccessiblemem: none, target_mem0: none, target_mem1: none) }
attributes #1 = { mustprogress nocallback nofree nounwind willreturn memory(argmem: write) }
attributes #2 = { mustprogress nocallback nocreateundeforpoison nofree nosync nounwind speculatable willreturn memory(none) }
attributes #3 = { mustprogress nofree norecurse nosync nounwind willreturn memory(argmem: readwrite) }
attributes #4 = { mustprogress nocallback nofree nosync nounwind willreturn memory(none) }
attributes #5 = { nocallback nofree nosync nounwind willreturn memory(argmem: readwrite) }

!0 = !{!1}
!1 = distinct !{!1, !2, !"_ZN17bnserve_surrogate10precession7_source5twistB2v3B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIxLi1E1C7mutable7alignedE: %retptr"}
!2 = distinct !{!2, !"_ZN17bnserve_surrogate10precession7_source5twistB2v3B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIxLi1E1C7mutable7alignedE"}
!3 = !{!4, !1}
!4 = distinct !{!4, !5, !"_ZN17bnserve_surrogate10precession7_source8_prepareB3v15B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExx5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!5 = distinct !{!5, !"_ZN17bnserve_surrogate10precession7_source8_prepareB3v15B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExx5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!6 = !{!7, !4, !1}
!7 = distinct !{!7, !8, !"_ZN17bnserve_surrogate10precession10_equations14fill_constantsB3v25B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEd5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!8 = distinct !{!8, !"_ZN17bnserve_surrogate10precession10_equations14fill_constantsB3v25B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEd5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!9 = !{!10, !7, !4, !1}
!10 = distinct !{!10, !11, !"_ZN17bnserve_surrogate10precession10_equations11_fill_ratesB3v27B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dEdd5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!11 = distinct !{!11, !"_ZN17bnserve_surrogate10precession10_equations11_fill_ratesB3v27B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dEdd5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!12 = !{!13, !7, !4, !1}
!13 = distinct !{!13, !14, !"_ZN17bnserve_surrogate10precession10_equations22_fill_angular_momentumB3v30B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dEdd5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!14 = distinct !{!14, !"_ZN17bnserve_surrogate10precession10_equations22_fill_angular_momentumB3v30B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dEdd5ArrayIdLi1E1C7mutable7alignedE"}
!15 = !{!16, !7, !4, !1}
!16 = distinct !{!16, !17, !"_ZN17bnserve_surrogate10precession10_equations10_fill_fluxB3v31B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dEdd5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!17 = distinct !{!17, !"_ZN17bnserve_surrogate10precession10_equations10_fill_fluxB3v31B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dEdd5ArrayIdLi1E1C7mutable7alignedE"}
!18 = !{!19, !7, !4, !1}
!19 = distinct !{!19, !20, !"_ZN17bnserve_surrogate10precession10_equations15_fill_spin_fluxB3v32B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dEdd5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!20 = distinct !{!20, !"_ZN17bnserve_surrogate10precession10_equations15_fill_spin_fluxB3v32B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dEdd5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!21 = !{!22, !1}
!22 = distinct !{!22, !23, !"_ZN17bnserve_surrogate10precession9_dynamics6followB3v36B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIxLi1E1C7mutable7alignedE23Literal_5bint_5d_280_295ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx: %retptr"}
!23 = distinct !{!23, !"_ZN17bnserve_surrogate10precession9_dynamics6followB3v36B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIxLi1E1C7mutable7alignedE23Literal_5bint_5d_280_295ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx"}
!24 = !{!25, !22, !1}
!25 = distinct !{!25, !26, !"_ZN17bnserve_surrogate10precession9_dynamics11_find_placeB3v55B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE19vector_28float64_295ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!26 = distinct !{!26, !"_ZN17bnserve_surrogate10precession9_dynamics11_find_placeB3v55B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE19vector_28float64_295ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!27 = !{!28, !22, !1}
!28 = distinct !{!28, !29, !"_ZN17bnserve_surrogate10precession9_dynamics11_find_placeB3v55B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE19vector_28float64_295ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!29 = distinct !{!29, !"_ZN17bnserve_surrogate10precession9_dynamics11_find_placeB3v55B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE19vector_28float64_295ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!30 = !{!31, !22, !1}
!31 = distinct !{!31, !32, !"_ZN17bnserve_surrogate10precession9_dynamics11_find_placeB3v55B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE19vector_28float64_295ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!32 = distinct !{!32, !"_ZN17bnserve_surrogate10precession9_dynamics11_find_placeB3v55B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE19vector_28float64_295ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!33 = !{!34, !1}
!34 = distinct !{!34, !35, !"_ZN17bnserve_surrogate10precession9_dynamics6followB3v88B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIxLi1E1C7mutable7alignedE23Literal_5bint_5d_281_295ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx: %retptr"}
!35 = distinct !{!35, !"_ZN17bnserve_surrogate10precession9_dynamics6followB3v88B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIxLi1E1C7mutable7alignedE23Literal_5bint_5d_281_295ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx"}
!36 = !{!37, !34, !1}
!37 = distinct !{!37, !38, !"_ZN17bnserve_surrogate10precession9_dynamics11_find_placeB3v55B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE19vector_28float64_295ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!38 = distinct !{!38, !"_ZN17bnserve_surrogate10precession9_dynamics11_find_placeB3v55B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE19vector_28float64_295ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!39 = !{!40, !34, !1}
!40 = distinct !{!40, !41, !"_ZN17bnserve_surrogate10precession9_dynamics11_find_placeB3v55B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE19vector_28float64_295ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!41 = distinct !{!41, !"_ZN17bnserve_surrogate10precession9_dynamics11_find_placeB3v55B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE19vector_28float64_295ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!42 = !{!43, !34, !1}
!43 = distinct !{!43, !44, !"_ZN17bnserve_surrogate10precession9_dynamics11_find_placeB3v55B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE19vector_28float64_295ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!44 = distinct !{!44, !"_ZN17bnserve_surrogate10precession9_dynamics11_find_placeB3v55B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE19vector_28float64_295ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!45 = !{!46, !1}
!46 = distinct !{!46, !47, !"_ZN17bnserve_surrogate10precession7_source7_gatherB4v107B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedExxx5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!47 = distinct !{!47, !"_ZN17bnserve_surrogate10precession7_source7_gatherB4v107B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedExxx5ArrayIdLi1E1C7mutable7alignedE"}
!48 = !{!49, !1}
!49 = distinct !{!49, !50, !"_ZN17bnserve_surrogate10precession7_source4_rowB4v108B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIxLi1E1C7mutable7alignedEddd5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!50 = distinct !{!50, !"_ZN17bnserve_surrogate10precession7_source4_rowB4v108B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIxLi1E1C7mutable7alignedEddd5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE"}
!51 = !{!52, !49, !1}
!52 = distinct !{!52, !53, !"_ZN17bnserve_surrogate10precession7_points10directionsB4v117B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedExddd5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!53 = distinct !{!53, !"_ZN17bnserve_surrogate10precession7_points10directionsB4v117B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedExddd5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!54 = !{!55, !49, !1}
!55 = distinct !{!55, !56, !"_ZN17bnserve_surrogate10precession7_source10_add_modesB4v139B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIxLi1E1C7mutable7alignedExxxx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!56 = distinct !{!56, !"_ZN17bnserve_surrogate10precession7_source10_add_modesB4v139B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIxLi1E1C7mutable7alignedExxxx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!57 = !{!58, !55, !49, !1}
!58 = distinct !{!58, !59, !"_ZN17bnserve_surrogate10precession7_points7twistedB4v143B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedExxx5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!59 = distinct !{!59, !"_ZN17bnserve_surrogate10precession7_points7twistedB4v143B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedExxx5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
