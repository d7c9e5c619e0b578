; sources: a2d8ccd0a74e83d89bb395d0c5e8dd73b59165056c7ebda038a31eae21996198
; ModuleID = '<string>'
source_filename = "<string>"

@.const.pickledata.b28008a0f88bad5ff0f0243e84dab90cab19b366 = internal constant [69 x i8] c"\80\04\95:\00\00\00\00\00\00\00\8C\08builtins\94\8C\11ZeroDivisionError\94\93\94\8C\10division by zero\94\85\94N\87\94."
@.const.pickledata.b28008a0f88bad5ff0f0243e84dab90cab19b366.sha1 = internal constant [20 x i8] c"\B2\80\08\A0\F8\8B\AD_\F0\F0$>\84\DA\B9\0C\AB\19\B3f"
@.const.picklebuf.b28008a0f88bad5ff0f0243e84dab90cab19b366 = internal constant { ptr, i32, ptr, ptr, i32 } { ptr @.const.pickledata.b28008a0f88bad5ff0f0243e84dab90cab19b366, i32 69, ptr @.const.pickledata.b28008a0f88bad5ff0f0243e84dab90cab19b366.sha1, ptr null, i32 0 }

; Function Attrs: nofree norecurse nosync nounwind memory(readwrite, inaccessiblemem: none, target_mem0: none, target_mem1: none)
define noundef range(i32 0, 2) i32 @bnserve_evaluate(ptr noalias writeonly captures(none) %retptr, ptr noalias writeonly captures(none) %excinfo, ptr readonly captures(none) %arg.parameters, i64 %arg.n_parameters, ptr readonly captures(none) %arg.f, ptr readonly captures(none) %arg.log_f, ptr readonly captures(none) %arg.cbrt_f, i64 %arg.points, ptr readonly captures(none) %arg.contents, i64 %arg.n_contents, ptr readonly captures(none) %arg.exponents, i64 %arg.n_exponents, ptr readonly captures(none) %arg.weights, i64 %arg.n_weights, i64 %arg.alignment, ptr captures(none) %arg.scratch, i64 %arg.n_scratch, ptr %arg.series, ptr writeonly captures(none) %arg.wide, i64 %arg.n_wide, ptr writeonly captures(none) %arg.narrow, i64 %arg.n_narrow, ptr captures(none) %arg.amplitude, ptr captures(none) %arg.phase, i64 %arg.n_polar, ptr writeonly captures(none) %arg.estimates, i64 %arg.n_estimates) local_unnamed_addr #0 {
entry:
  %.2457.i.i = alloca ptr, align 8
  %.3101.i.i = alloca ptr, align 8
  %.406.i = getelementptr i8, ptr %arg.contents, i64 24
  %.407.i = load i64, ptr %.406.i, align 8, !noalias !0
  %.408.i = add nsw i64 %.407.i, 2378
  %.440.i = getelementptr i8, ptr %arg.contents, i64 48
  %.441.i = load i64, ptr %.440.i, align 8, !noalias !0
  %.470.i = getelementptr i8, ptr %arg.contents, i64 56
  %.471.i = load i64, ptr %.470.i, align 8, !noalias !0
  %.472.i = add nsw i64 %.471.i, %.441.i
  %.473.i = shl nsw i64 %.472.i, 1
  %.475.i = add nsw i64 %.473.i, %.408.i
  %.476.i = add nsw i64 %.475.i, 4
  %.477.i = add nsw i64 %.475.i, 12
  %.518.i = icmp slt i64 %.407.i, -2378
  %.519.i = select i1 %.518.i, i64 %arg.n_scratch, i64 0
  %.520.i = add i64 %.519.i, %.408.i
  %.523.i = icmp slt i64 %.520.i, 0
  br i1 %.523.i, label %B0.else.if.i, label %B0.else.endif.i, !prof !4

B500.i:                                           ; preds = %_ZN17bnserve_surrogate6kernel7_source8_prepareB2v8B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i
  %.1488.i = load i64, ptr %.406.i, align 8, !noalias !0
  %.1503.inv.i = icmp sgt i64 %.1488.i, 0
  %.1504.i = select i1 %.1503.inv.i, i64 0, i64 %arg.n_scratch
  %0 = getelementptr double, ptr %arg.scratch, i64 %.1488.i
  %1 = getelementptr i8, ptr %0, i64 -8
  %.1518.i = getelementptr double, ptr %1, i64 %.1504.i
  %.1519.i = load double, ptr %.1518.i, align 8, !noalias !0
  %.1527.le.i = tail call contract double @llvm.exp.f64(double %.1519.i)
  %2 = getelementptr double, ptr %arg.estimates, i64 %.939.017.i
  store double %.1527.le.i, ptr %2, align 8, !noalias !0
  br label %B586.i

B586.i:                                           ; preds = %_ZN17bnserve_surrogate6kernel7_source8_prepareB2v8B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i, %B500.i
  %.1728.i = mul nsw i64 %.939.017.i, %arg.points
  br i1 %37, label %B1178.i, label %B634.preheader.i

B634.preheader.i:                                 ; preds = %B586.i
  %.209.i3.i = getelementptr i8, ptr %.1183.i, i64 56
  %.3314.i.i = getelementptr i8, ptr %.1183.i, i64 40
  %.3565.i.i = getelementptr i8, ptr %.1183.i, i64 64
  %.3763.i.i = getelementptr i8, ptr %.1183.i, i64 72
  br label %B634.i

B634.i:                                           ; preds = %B1174.i, %B634.preheader.i
  %excinfo.3.1.i = phi ptr [ %excinfo.3.3.i, %B1174.i ], [ %excinfo.3.2.i, %B634.preheader.i ]
  %.1635.sroa.0.015.i = phi i64 [ %.1635.sroa.0.0.i, %B1174.i ], [ 0, %B634.preheader.i ]
  %.1591.114.in.i = phi i64 [ %4, %B1174.i ], [ %6, %B634.preheader.i ]
  %.1588.113.i = phi i64 [ %.1588.1.i, %B1174.i ], [ 1024, %B634.preheader.i ]
  %.1687.i = add nsw i64 %.1635.sroa.0.015.i, 1024
  %.13.i.i = tail call i64 @llvm.smin.i64(i64 %arg.points, i64 %.1687.i)
  %.1722.i = sub nsw i64 %.13.i.i, %.1635.sroa.0.015.i
  %.1730.i = add nsw i64 %.1635.sroa.0.015.i, %.1728.i
  br i1 %54, label %B714.i, label %B792.i

B714.i:                                           ; preds = %B634.i
  %.1743.i = add i64 %.13.i.i, %.1728.i
  %.1780.i = icmp slt i64 %.1730.i, 0
  %.1781.i = select i1 %.1780.i, i64 %arg.n_polar, i64 0
  %.1782.i = add i64 %.1781.i, %.1730.i
  %.1785.i = icmp slt i64 %.1782.i, 0
  br i1 %.1785.i, label %B714.else.if.i, label %B714.else.endif.i, !prof !4

B792.i:                                           ; preds = %B634.i
  %.2127.i = add nsw i64 %.1722.i, %.477.i
  br i1 %.712.i, label %B792.else.if.i, label %B792.else.endif.i, !prof !4

B876.i:                                           ; preds = %B792.endif.else.endif.endif.endif.endif.i, %B714.endif.else.endif.endif.endif.endif.i
  %a.2.sroa.60.2.i = phi i64 [ %.1867.i, %B714.endif.else.endif.endif.endif.endif.i ], [ %.2252.i, %B792.endif.else.endif.endif.endif.endif.i ]
  %a.2.sroa.48.2.i = phi ptr [ %.1883.i, %B714.endif.else.endif.endif.endif.endif.i ], [ %.2268.i, %B792.endif.else.endif.endif.endif.endif.i ]
  %p.2.sroa.60.2.i = phi i64 [ %.2061.i, %B714.endif.else.endif.endif.endif.endif.i ], [ %.2440.i, %B792.endif.else.endif.endif.endif.endif.i ]
  %p.2.sroa.48.2.i = phi ptr [ %.2077.i, %B714.endif.else.endif.endif.endif.endif.i ], [ %.2456.i, %B792.endif.else.endif.endif.endif.endif.i ]
  %.2538.i = icmp slt i64 %.1635.sroa.0.015.i, 0
  %.2539.i = select i1 %.2538.i, i64 %arg.points, i64 0
  %.2540.i = add i64 %.2539.i, %.1635.sroa.0.015.i
  %.2543.i = icmp slt i64 %.2540.i, 0
  br i1 %.2543.i, label %B876.else.if.i, label %B876.else.endif.i, !prof !4

B1028.i:                                          ; preds = %B876.endif.endif.endif.endif.i
  %.3424.i = add i64 %.13.i.i, %.1728.i
  %.3462.i = icmp slt i64 %.1730.i, 0
  %.3463.i = select i1 %.3462.i, i64 %arg.n_wide, i64 0
  %.3464.i = add i64 %.3463.i, %.1730.i
  %.3467.i = icmp slt i64 %.3464.i, 0
  br i1 %.3467.i, label %B1028.else.if.i, label %B1028.else.endif.i, !prof !4

B1084.i:                                          ; preds = %B56.if.i.i, %B1028.else.endif.endif.endif.endif.i, %B876.endif.endif.endif.endif.i
  br i1 %58, label %B1118.i, label %B1174.i

B1118.i:                                          ; preds = %B1084.i
  %.3649.i = add i64 %.13.i.i, %.1728.i
  %.3691.i = icmp slt i64 %.1730.i, 0
  %.3692.i = select i1 %.3691.i, i64 %arg.n_narrow, i64 0
  %.3693.i = add i64 %.3692.i, %.1730.i
  %.3696.i = icmp slt i64 %.3693.i, 0
  br i1 %.3696.i, label %B1118.else.if.i, label %B1118.else.endif.i, !prof !4

B1174.i:                                          ; preds = %B56.if.i19.i, %B1118.else.endif.endif.endif.endif.i, %B1084.i
  %.1645.i = icmp samesign ugt i64 %.1591.114.in.i, 1
  %.1658.i = add i64 %.1588.113.i, 1024
  %.1588.1.i = select i1 %.1645.i, i64 %.1658.i, i64 %.1588.113.i
  %3 = tail call i64 @llvm.smax.i64(i64 %.1591.114.in.i, i64 2)
  %4 = add nsw i64 %3, -1
  %.1635.sroa.0.0.i = select i1 %.1645.i, i64 %.1588.113.i, i64 0
  br i1 %.1645.i, label %B634.i, label %B1178.i

B1178.i:                                          ; preds = %B1174.i, %B586.i
  %excinfo.3.0.i = phi ptr [ %excinfo.3.2.i, %B586.i ], [ %excinfo.3.3.i, %B1174.i ]
  %exitcond.not.i = icmp eq i64 %.1011.i, %.883.1.i
  br i1 %exitcond.not.i, label %B0.endif.endif.endif.endi...endif.2.endif, label %B344.if.i

B0.else.if.i:                                     ; preds = %entry
  br label %B0.else.endif.i

B0.else.endif.i:                                  ; preds = %B0.else.if.i, %entry
  %.508.sroa.0.1.i = phi i64 [ 0, %B0.else.if.i ], [ %.520.i, %entry ]
  %.528.not.i = icmp slt i64 %.520.i, %arg.n_scratch
  br i1 %.528.not.i, label %B0.else.endif.endif.i, label %B0.else.endif.if.i, !prof !5

B0.else.endif.if.i:                               ; preds = %B0.else.endif.i
  br label %B0.else.endif.endif.i

B0.else.endif.endif.i:                            ; preds = %B0.else.endif.if.i, %B0.else.endif.i
  %.508.sroa.0.3.i = phi i64 [ %arg.n_scratch, %B0.else.endif.if.i ], [ %.508.sroa.0.1.i, %B0.else.endif.i ]
  %.535.i = icmp slt i64 %.475.i, -4
  %.536.i = select i1 %.535.i, i64 %arg.n_scratch, i64 0
  %.537.i = add i64 %.476.i, %.536.i
  %.540.i = icmp slt i64 %.537.i, 0
  br i1 %.540.i, label %B0.else.endif.endif.if.i, label %B0.else.endif.endif.endif.i, !prof !4

B0.else.endif.endif.if.i:                         ; preds = %B0.else.endif.endif.i
  br label %B0.else.endif.endif.endif.i

B0.else.endif.endif.endif.i:                      ; preds = %B0.else.endif.endif.if.i, %B0.else.endif.endif.i
  %.508.sroa.13.1.i = phi i64 [ 0, %B0.else.endif.endif.if.i ], [ %.537.i, %B0.else.endif.endif.i ]
  %.545.not.i = icmp slt i64 %.537.i, %arg.n_scratch
  br i1 %.545.not.i, label %B0.else.endif.endif.endif.endif.i, label %B0.else.endif.endif.endif.if.i, !prof !5

B0.else.endif.endif.endif.if.i:                   ; preds = %B0.else.endif.endif.endif.i
  br label %B0.else.endif.endif.endif.endif.i

B0.else.endif.endif.endif.endif.i:                ; preds = %B0.else.endif.endif.endif.if.i, %B0.else.endif.endif.endif.i
  %.508.sroa.13.2.i = phi i64 [ %arg.n_scratch, %B0.else.endif.endif.endif.if.i ], [ %.508.sroa.13.1.i, %B0.else.endif.endif.endif.i ]
  %.596.i = sub i64 %.508.sroa.13.2.i, %.508.sroa.0.3.i
  %.605.i = tail call i64 @llvm.smax.i64(i64 %.596.i, i64 0)
  %.621.i = getelementptr double, ptr %arg.scratch, i64 %.508.sroa.0.3.i
  br i1 %.540.i, label %B0.endif.else.if.i, label %B0.endif.else.endif.i, !prof !4

B0.endif.else.if.i:                               ; preds = %B0.else.endif.endif.endif.endif.i
  br label %B0.endif.else.endif.i

B0.endif.else.endif.i:                            ; preds = %B0.endif.else.if.i, %B0.else.endif.endif.endif.endif.i
  %.680.sroa.0.1.i = phi i64 [ 0, %B0.endif.else.if.i ], [ %.537.i, %B0.else.endif.endif.endif.endif.i ]
  br i1 %.545.not.i, label %B0.endif.else.endif.endif.i, label %B0.endif.else.endif.if.i, !prof !5

B0.endif.else.endif.if.i:                         ; preds = %B0.endif.else.endif.i
  br label %B0.endif.else.endif.endif.i

B0.endif.else.endif.endif.i:                      ; preds = %B0.endif.else.endif.if.i, %B0.endif.else.endif.i
  %.680.sroa.0.3.i = phi i64 [ %arg.n_scratch, %B0.endif.else.endif.if.i ], [ %.680.sroa.0.1.i, %B0.endif.else.endif.i ]
  %.707.i = icmp slt i64 %.475.i, -12
  %.708.i = select i1 %.707.i, i64 %arg.n_scratch, i64 0
  %.709.i = add i64 %.708.i, %.477.i
  %.712.i = icmp slt i64 %.709.i, 0
  %.717.not.i = icmp slt i64 %.709.i, %arg.n_scratch
  %.793.i = getelementptr double, ptr %arg.scratch, i64 %.680.sroa.0.3.i
  %.894.i = sdiv i64 %arg.n_parameters, 10
  %.895.i = srem i64 %arg.n_parameters, 10
  %.895.lobit.i = ashr i64 %.895.i, 63
  %.883.1.i = add nsw i64 %.895.lobit.i, %.894.i
  %.2312.i = add nsw i64 %.475.i, 1036
  %.2353.i = icmp slt i64 %.475.i, -1036
  %.2354.i = select i1 %.2353.i, i64 %arg.n_scratch, i64 0
  %.2355.i = add i64 %.2354.i, %.2312.i
  %.99816.not.i = icmp slt i64 %.883.1.i, 1
  br i1 %.99816.not.i, label %B0.endif.endif.endif.endi...endif.2.endif, label %B344.if.preheader.i

B344.if.preheader.i:                              ; preds = %B0.endif.else.endif.endif.i
  %.1602.inv.i = icmp sgt i64 %arg.points, 0
  %5 = add nuw i64 %arg.points, 1023
  %.1623.i = lshr i64 %5, 10
  %storemerge998.i = select i1 %.1602.inv.i, i64 %.1623.i, i64 0
  %6 = tail call i64 @llvm.smax.i64(i64 %storemerge998.i, i64 1)
  %scevgep98.i = getelementptr i8, ptr %arg.narrow, i64 4
  %7 = icmp slt i64 %arg.n_scratch, 1
  %.537.i.i.i = getelementptr i8, ptr %arg.contents, i64 64
  %.1157.i.i.i = getelementptr i8, ptr %arg.contents, i64 8
  %.1676.i.i.i = getelementptr i8, ptr %arg.contents, i64 32
  %.758.i.i = getelementptr i8, ptr %arg.contents, i64 88
  %.98.i.not.i.i = icmp slt i64 %.596.i, 1
  %.183.i.i.i.i = getelementptr i8, ptr %arg.series, i64 16
  %.308.i.i.i.i = getelementptr i8, ptr %arg.series, i64 24
  %.413.i.i.i.i = getelementptr i8, ptr %arg.series, i64 32
  %.561.i.i.i.i = getelementptr i8, ptr %arg.series, i64 168
  %.686.i.i.i.i = getelementptr i8, ptr %arg.series, i64 48
  %.865.i.i.i.i = getelementptr i8, ptr %arg.series, i64 176
  %.970.i.i.i.i = getelementptr i8, ptr %arg.series, i64 56
  %.1118.i.i.i.i = getelementptr i8, ptr %arg.series, i64 192
  %.1336.i.i.i.i = getelementptr i8, ptr %arg.series, i64 320
  %.1461.i.i.i.i = getelementptr i8, ptr %arg.series, i64 72
  %.1640.i.i.i.i = getelementptr i8, ptr %arg.series, i64 200
  %.1867.i.i.i.i = getelementptr i8, ptr %arg.series, i64 80
  %.2145.i.i.i.i = getelementptr i8, ptr %arg.series, i64 208
  %.2256.i.i.i.i = getelementptr i8, ptr %arg.series, i64 88
  %.2474.i.i.i.i = getelementptr i8, ptr %arg.series, i64 216
  %8 = getelementptr i8, ptr %arg.series, i64 128
  %.211.i.i.i.i = getelementptr i8, ptr %arg.series, i64 96
  %.328.i123.i.i.i = getelementptr i8, ptr %arg.series, i64 104
  %.442.i.i.i.i = getelementptr i8, ptr %arg.series, i64 112
  %.559.i.i.i.i = getelementptr i8, ptr %arg.series, i64 120
  %9 = getelementptr i8, ptr %arg.series, i64 8
  %10 = getelementptr i8, ptr %arg.series, i64 40
  %11 = getelementptr i8, ptr %arg.series, i64 64
  %12 = getelementptr i8, ptr %arg.series, i64 136
  %13 = getelementptr i8, ptr %arg.series, i64 144
  %14 = getelementptr i8, ptr %arg.series, i64 152
  %15 = getelementptr i8, ptr %arg.series, i64 160
  %16 = getelementptr i8, ptr %arg.series, i64 184
  %17 = getelementptr i8, ptr %arg.series, i64 224
  %18 = getelementptr i8, ptr %arg.series, i64 232
  %19 = getelementptr i8, ptr %arg.series, i64 240
  %20 = getelementptr i8, ptr %arg.series, i64 248
  %21 = getelementptr i8, ptr %arg.series, i64 256
  %22 = getelementptr i8, ptr %arg.series, i64 264
  %23 = getelementptr i8, ptr %arg.series, i64 272
  %24 = getelementptr i8, ptr %arg.series, i64 280
  %25 = getelementptr i8, ptr %arg.series, i64 288
  %26 = getelementptr i8, ptr %arg.series, i64 296
  %27 = getelementptr i8, ptr %arg.series, i64 304
  %28 = getelementptr i8, ptr %arg.series, i64 312
  %29 = getelementptr i8, ptr %arg.series, i64 328
  %30 = getelementptr i8, ptr %arg.series, i64 336
  %31 = getelementptr i8, ptr %arg.series, i64 344
  %32 = getelementptr i8, ptr %arg.series, i64 352
  %33 = getelementptr i8, ptr %arg.series, i64 360
  %34 = getelementptr i8, ptr %arg.series, i64 368
  %35 = getelementptr i8, ptr %arg.series, i64 376
  %.138.i.i.i = getelementptr i8, ptr %.793.i, i64 8
  %.169.i.i.i = getelementptr i8, ptr %.793.i, i64 16
  %.203.i.i.i = getelementptr i8, ptr %.793.i, i64 24
  %.236.i.i.i = getelementptr i8, ptr %.793.i, i64 32
  %.427.i.i.i = getelementptr i8, ptr %.793.i, i64 40
  %.548.i.i.i = getelementptr i8, ptr %.793.i, i64 48
  %.948.i.i.i = getelementptr i8, ptr %.793.i, i64 56
  %36 = icmp sgt i64 %arg.n_estimates, 0
  %37 = icmp eq i64 %storemerge998.i, 0
  %.1189.i.i.i = getelementptr i8, ptr %arg.contents, i64 72
  %.1421.i.i.i = getelementptr i8, ptr %arg.contents, i64 16
  %.1709.i.i.i = getelementptr i8, ptr %arg.contents, i64 80
  %sunkaddr104.i.i.i.i = getelementptr i8, ptr %arg.contents, i64 40
  %xtraiter.i.i.i = and i64 %.605.i, 3
  %38 = icmp slt i64 %.596.i, 4
  %39 = add nsw i64 %.605.i, -4
  %40 = lshr i64 %39, 2
  %41 = icmp eq i64 %40, 0
  %42 = add nuw nsw i64 %40, 1
  %43 = and i64 %42, 9223372036854775806
  %44 = and i64 %39, 4
  %lcmp.mod.not.not.i.i = icmp eq i64 %44, 0
  %lcmp.mod.not.i.i.i = icmp eq i64 %xtraiter.i.i.i, 0
  %unroll_iter6.i.i.i = and i64 %.605.i, 9223372036854775806
  %45 = add nsw i64 %unroll_iter6.i.i.i, -2
  %46 = lshr exact i64 %45, 1
  %47 = add nuw i64 %46, 1
  %48 = and i64 %47, -2
  %trunc.i.i = trunc nuw i64 %.605.i to i63
  %49 = icmp eq i64 %45, 0
  %50 = and i64 %45, 2
  %51 = icmp eq i64 %50, 0
  %52 = and i64 %.605.i, 1
  %53 = icmp eq i64 %52, 0
  %54 = icmp sgt i64 %arg.n_polar, 0
  %.243.i.i = getelementptr i8, ptr %arg.contents, i64 112
  %55 = icmp slt i64 %.2355.i, 0
  %56 = icmp slt i64 %.2355.i, %arg.n_scratch
  %.1732.i.i = getelementptr i8, ptr %arg.contents, i64 96
  %.2531.i.i = getelementptr i8, ptr %arg.contents, i64 104
  %.3582.i.i = icmp slt i64 %arg.alignment, 0
  %.idx.i.i = shl i64 %arg.alignment, 4
  %.3682.i.i = icmp eq i64 %arg.alignment, 1
  %57 = icmp sgt i64 %arg.n_wide, 0
  %58 = icmp sgt i64 %arg.n_narrow, 0
  br label %B344.if.i

B344.if.i:                                        ; preds = %B344.if.preheader.i, %B1178.i
  %excinfo.3.2.i = phi ptr [ null, %B344.if.preheader.i ], [ %excinfo.3.0.i, %B1178.i ]
  %.939.017.i = phi i64 [ 0, %B344.if.preheader.i ], [ %.1011.i, %B1178.i ]
  %.1011.i = add nuw nsw i64 %.939.017.i, 1
  %.1040.i = mul nuw nsw i64 %.939.017.i, 10
  %.1090.not.i = icmp slt i64 %.1040.i, %arg.n_parameters
  br i1 %.1090.not.i, label %B346.else.endif.endif.i, label %B346.else.endif.if.i, !prof !5

B346.else.endif.if.i:                             ; preds = %B344.if.i
  br label %B346.else.endif.endif.i

B346.else.endif.endif.i:                          ; preds = %B346.else.endif.if.i, %B344.if.i
  %.1070.sroa.0.3.i = phi i64 [ %arg.n_parameters, %B346.else.endif.if.i ], [ %.1040.i, %B344.if.i ]
  %.1183.i = getelementptr double, ptr %arg.parameters, i64 %.1070.sroa.0.3.i
  br i1 %7, label %B346.endif.else.endif.if.i, label %B346.endif.else.endif.endif.i, !prof !4

B346.endif.else.endif.if.i:                       ; preds = %B346.else.endif.endif.i
  br label %B346.endif.else.endif.endif.i

B346.endif.else.endif.endif.i:                    ; preds = %B346.endif.else.endif.if.i, %B346.else.endif.endif.i
  %.1249.sroa.0.3.i = phi i64 [ %arg.n_scratch, %B346.endif.else.endif.if.i ], [ 0, %B346.else.endif.endif.i ]
  br i1 %.523.i, label %B346.endif.else.endif.endif.if.i, label %B346.endif.else.endif.endif.endif.i, !prof !4

B346.endif.else.endif.endif.if.i:                 ; preds = %B346.endif.else.endif.endif.i
  br label %B346.endif.else.endif.endif.endif.i

B346.endif.else.endif.endif.endif.i:              ; preds = %B346.endif.else.endif.endif.if.i, %B346.endif.else.endif.endif.i
  %.1249.sroa.13.1.i = phi i64 [ 0, %B346.endif.else.endif.endif.if.i ], [ %.520.i, %B346.endif.else.endif.endif.i ]
  br i1 %.528.not.i, label %B346.endif.else.endif.endif.endif.endif.i, label %B346.endif.else.endif.endif.endif.if.i, !prof !5

B346.endif.else.endif.endif.endif.if.i:           ; preds = %B346.endif.else.endif.endif.endif.i
  br label %B346.endif.else.endif.endif.endif.endif.i

B346.endif.else.endif.endif.endif.endif.i:        ; preds = %B346.endif.else.endif.endif.endif.if.i, %B346.endif.else.endif.endif.endif.i
  %.1249.sroa.13.2.i = phi i64 [ %arg.n_scratch, %B346.endif.else.endif.endif.endif.if.i ], [ %.1249.sroa.13.1.i, %B346.endif.else.endif.endif.endif.i ]
  %.1337.i = sub i64 %.1249.sroa.13.2.i, %.1249.sroa.0.3.i
  %.1346.i = tail call i64 @llvm.smax.i64(i64 %.1337.i, i64 0)
  %.1362.i = getelementptr double, ptr %arg.scratch, i64 %.1249.sroa.0.3.i
  %.136.i.i = load double, ptr %.1183.i, align 8, !noalias !6
  %.164.i.i = getelementptr i8, ptr %.1183.i, i64 24
  %.165.i.i = load double, ptr %.164.i.i, align 8, !noalias !6
  %.193.i.i = getelementptr i8, ptr %.1183.i, i64 32
  %.194.i.i = load double, ptr %.193.i.i, align 8, !noalias !6
  %.222.i.i = getelementptr i8, ptr %.1183.i, i64 8
  %.223.i.i = load double, ptr %.222.i.i, align 8, !noalias !6
  %.251.i.i = getelementptr i8, ptr %.1183.i, i64 16
  %.252.i.i = load double, ptr %.251.i.i, align 8, !noalias !6
  %.314.i2.i = load i64, ptr %.406.i, align 8, !noalias !6
  %.367.i.i = icmp slt i64 %.314.i2.i, 0
  %.368.i.i = select i1 %.367.i.i, i64 %.1346.i, i64 0
  %.369.i.i = add i64 %.368.i.i, %.314.i2.i
  %.372.i.i = icmp slt i64 %.369.i.i, 0
  br i1 %.372.i.i, label %B0.else.endif.endif.if.i.i, label %B0.else.endif.endif.endif.i.i, !prof !4

B0.else.endif.endif.if.i.i:                       ; preds = %B346.endif.else.endif.endif.endif.endif.i
  br label %B0.else.endif.endif.endif.i.i

B0.else.endif.endif.endif.i.i:                    ; preds = %B0.else.endif.endif.if.i.i, %B346.endif.else.endif.endif.endif.endif.i
  %.340.sroa.13.1.i.i = phi i64 [ 0, %B0.else.endif.endif.if.i.i ], [ %.369.i.i, %B346.endif.else.endif.endif.endif.endif.i ]
  %.377.not.i.i = icmp slt i64 %.369.i.i, %.1346.i
  br i1 %.377.not.i.i, label %B0.else.endif.endif.endif.endif.i.i, label %B0.else.endif.endif.endif.if.i.i, !prof !5

B0.else.endif.endif.endif.if.i.i:                 ; preds = %B0.else.endif.endif.endif.i.i
  br label %B0.else.endif.endif.endif.endif.i.i

B0.else.endif.endif.endif.endif.i.i:              ; preds = %B0.else.endif.endif.endif.if.i.i, %B0.else.endif.endif.endif.i.i
  %.340.sroa.13.2.i.i = phi i64 [ %.1346.i, %B0.else.endif.endif.endif.if.i.i ], [ %.340.sroa.13.1.i.i, %B0.else.endif.endif.endif.i.i ]
  br i1 %.372.i.i, label %B0.endif.else.if.i.i, label %B0.endif.else.endif.i.i, !prof !4

B0.endif.else.if.i.i:                             ; preds = %B0.else.endif.endif.endif.endif.i.i
  br label %B0.endif.else.endif.i.i

B0.endif.else.endif.i.i:                          ; preds = %B0.endif.else.if.i.i, %B0.else.endif.endif.endif.endif.i.i
  %.539.sroa.0.1.i.i = phi i64 [ 0, %B0.endif.else.if.i.i ], [ %.369.i.i, %B0.else.endif.endif.endif.endif.i.i ]
  br i1 %.377.not.i.i, label %B0.endif.else.endif.endif.i.i, label %B0.endif.else.endif.if.i.i, !prof !5

B0.endif.else.endif.if.i.i:                       ; preds = %B0.endif.else.endif.i.i
  br label %B0.endif.else.endif.endif.i.i

B0.endif.else.endif.endif.i.i:                    ; preds = %B0.endif.else.endif.if.i.i, %B0.endif.else.endif.i.i
  %.539.sroa.0.3.i.i = phi i64 [ %.1346.i, %B0.endif.else.endif.if.i.i ], [ %.539.sroa.0.1.i.i, %B0.endif.else.endif.i.i ]
  %.627.i.i = sub nsw i64 %.1346.i, %.539.sroa.0.3.i.i
  %.636.i.i = tail call i64 @llvm.smax.i64(i64 %.627.i.i, i64 0)
  %.652.i.i = getelementptr double, ptr %.1362.i, i64 %.539.sroa.0.3.i.i
  %.295.i.i.i = load i64, ptr %arg.contents, align 8, !noalias !9
  %.296.not.i.i.i = icmp eq i64 %.295.i.i.i, 0
  br i1 %.296.not.i.i.i, label %B100.i.i.i, label %B58.i.i.i

B58.i.i.i:                                        ; preds = %B0.endif.else.endif.endif.i.i
  %.38.le.i.i.i.i = tail call contract double @llvm.log.f64(double %.136.i.i)
  %.21.i.i.i.i = fadd contract double %.136.i.i, 1.000000e+00
  %.30.i.i.i.i = fdiv contract double 1.000000e+00, %.21.i.i.i.i
  %.25.i.i.i.i = fdiv contract double %.136.i.i, %.21.i.i.i.i
  store double %.38.le.i.i.i.i, ptr %.652.i.i, align 8, !noalias !12
  %.72.i.i.i.i = tail call contract double @llvm.pow.f64(double %.223.i.i, double 4.000000e-01)
  %.73.i.i.i.i = fmul contract double %.25.i.i.i.i, %.72.i.i.i.i
  %.101.i.i.i.i = getelementptr i8, ptr %.652.i.i, i64 8
  store double %.73.i.i.i.i, ptr %.101.i.i.i.i, align 8, !noalias !12
  %.103.i.i.i.i = tail call contract double @llvm.pow.f64(double %.252.i.i, double 4.000000e-01)
  %.104.i.i.i.i = fmul contract double %.30.i.i.i.i, %.103.i.i.i.i
  %.132.i.i.i.i = getelementptr i8, ptr %.652.i.i, i64 16
  store double %.104.i.i.i.i, ptr %.132.i.i.i.i, align 8, !noalias !12
  %.134.i.i.i.i = fmul contract double %.165.i.i, %.25.i.i.i.i
  %.135.i.i.i.i = fmul contract double %.30.i.i.i.i, %.194.i.i
  %.136.i.i.i.i = fadd contract double %.134.i.i.i.i, %.135.i.i.i.i
  %.137.i.i.i.i = fmul contract double %.25.i.i.i.i, 0x3FD585A9E9585A9F
  %.138.i.i.i.i = fmul contract double %.30.i.i.i.i, %.137.i.i.i.i
  %.139.i.i.i.i = fadd contract double %.165.i.i, %.194.i.i
  %.140.i.i.i.i = fmul contract double %.139.i.i.i.i, %.138.i.i.i.i
  %.141.i.i.i.i = fsub contract double %.136.i.i.i.i, %.140.i.i.i.i
  %.169.i.i.i.i = getelementptr i8, ptr %.652.i.i, i64 24
  store double %.141.i.i.i.i, ptr %.169.i.i.i.i, align 8, !noalias !12
  %.171.i.i.i.i = fsub contract double %.165.i.i, %.194.i.i
  %.172.i.i.i.i = fmul contract double %.171.i.i.i.i, 5.000000e-01
  br label %B150.i.i.i

B100.i.i.i:                                       ; preds = %B0.endif.else.endif.endif.i.i
  store double %.136.i.i, ptr %.652.i.i, align 8, !noalias !9
  %.405.i.i.i = getelementptr i8, ptr %.652.i.i, i64 8
  store double %.165.i.i, ptr %.405.i.i.i, align 8, !noalias !9
  %.438.i.i.i = getelementptr i8, ptr %.652.i.i, i64 16
  store double %.194.i.i, ptr %.438.i.i.i, align 8, !noalias !9
  %.471.i.i.i = getelementptr i8, ptr %.652.i.i, i64 24
  store double %.223.i.i, ptr %.471.i.i.i, align 8, !noalias !9
  br label %B150.i.i.i

B150.i.i.i:                                       ; preds = %B100.i.i.i, %B58.i.i.i
  %.172.i.sink.i.i.i = phi double [ %.172.i.i.i.i, %B58.i.i.i ], [ %.252.i.i, %B100.i.i.i ]
  %.200.i.i.i.i = getelementptr i8, ptr %.652.i.i, i64 32
  store double %.172.i.sink.i.i.i, ptr %.200.i.i.i.i, align 8, !noalias !9
  %.538.i.i.i = load i64, ptr %.537.i.i.i, align 8, !noalias !9
  %.575.i.i.i = icmp slt i64 %.538.i.i.i, 0
  %.576.i.i.i = select i1 %.575.i.i.i, i64 %arg.n_weights, i64 0
  %.577.i.i.i = add i64 %.576.i.i.i, %.538.i.i.i
  %.580.i.i.i = icmp slt i64 %.577.i.i.i, 0
  br i1 %.580.i.i.i, label %B150.else.if.i.i.i, label %B150.else.endif.i.i.i, !prof !4

B360.i.i.i:                                       ; preds = %B344.if.preheader.i.i.i, %B150.else.endif.endif.i.i.i
  %.1158.i.i.i = load i64, ptr %.1157.i.i.i, align 8, !noalias !9
  %.1159.i.i.i = icmp sgt i64 %.1158.i.i.i, 0
  br i1 %.1159.i.i.i, label %B394.i.i.i, label %B538.i.i.i

B394.i.i.i:                                       ; preds = %B360.i.i.i
  %.1190.i.i.i = load i64, ptr %.1189.i.i.i, align 8, !noalias !9
  %.1227.i.i.i = icmp slt i64 %.1190.i.i.i, 0
  %.1228.i.i.i = select i1 %.1227.i.i.i, i64 %arg.n_weights, i64 0
  %.1229.i.i.i = add i64 %.1228.i.i.i, %.1190.i.i.i
  %.1232.i.i.i = icmp slt i64 %.1229.i.i.i, 0
  br i1 %.1232.i.i.i, label %B394.else.if.i.i.i, label %B394.else.endif.i.i.i, !prof !4

B538.i.i.i:                                       ; preds = %B540.i.i.i.i, %B360.i.i.i
  %.1677.i.i.i = load i64, ptr %.1676.i.i.i, align 8, !noalias !9
  %.1678.i.i.i = icmp sgt i64 %.1677.i.i.i, 0
  br i1 %.1678.i.i.i, label %B572.i.i.i, label %_ZN17bnserve_surrogate6kernel11_regression7regressB2v9B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dEddddd5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i.i

B572.i.i.i:                                       ; preds = %B538.i.i.i
  %.1710.i.i.i = load i64, ptr %.1709.i.i.i, align 8, !noalias !9
  %.1747.i.i.i = icmp slt i64 %.1710.i.i.i, 0
  %.1748.i.i.i = select i1 %.1747.i.i.i, i64 %arg.n_weights, i64 0
  %.1749.i.i.i = add i64 %.1748.i.i.i, %.1710.i.i.i
  %.1752.i.i.i = icmp slt i64 %.1749.i.i.i, 0
  br i1 %.1752.i.i.i, label %B572.else.if.i.i.i, label %B572.else.endif.i.i.i, !prof !4

B150.else.if.i.i.i:                               ; preds = %B150.i.i.i
  br label %B150.else.endif.i.i.i

B150.else.endif.i.i.i:                            ; preds = %B150.else.if.i.i.i, %B150.i.i.i
  %.565.sroa.0.1.i.i.i = phi i64 [ 0, %B150.else.if.i.i.i ], [ %.577.i.i.i, %B150.i.i.i ]
  %.585.not.i.i.i = icmp slt i64 %.577.i.i.i, %arg.n_weights
  br i1 %.585.not.i.i.i, label %B150.else.endif.endif.i.i.i, label %B150.else.endif.if.i.i.i, !prof !5

B150.else.endif.if.i.i.i:                         ; preds = %B150.else.endif.i.i.i
  br label %B150.else.endif.endif.i.i.i

B150.else.endif.endif.i.i.i:                      ; preds = %B150.else.endif.if.i.i.i, %B150.else.endif.i.i.i
  %.565.sroa.0.3.i.i.i = phi i64 [ %arg.n_weights, %B150.else.endif.if.i.i.i ], [ %.565.sroa.0.1.i.i.i, %B150.else.endif.i.i.i ]
  %.678.i.i.i = getelementptr double, ptr %arg.weights, i64 %.565.sroa.0.3.i.i.i
  %.862.i.i.i = load double, ptr %.652.i.i, align 8, !noalias !9
  %.892.i.i.i = load double, ptr %.678.i.i.i, align 8, !noalias !9
  %.893.i.i.i = fsub contract double %.862.i.i.i, %.892.i.i.i
  %59 = getelementptr i8, ptr %.678.i.i.i, i64 40
  %.924.i.i.i = load double, ptr %59, align 8, !noalias !9
  %.925.i.i.i = fmul contract double %.893.i.i.i, %.924.i.i.i
  store double %.925.i.i.i, ptr %.652.i.i, align 8, !noalias !9
  %60 = getelementptr i8, ptr %.652.i.i, i64 8
  %.862.1.i.i.i = load double, ptr %60, align 8, !noalias !9
  %61 = getelementptr i8, ptr %.678.i.i.i, i64 8
  %.892.1.i.i.i = load double, ptr %61, align 8, !noalias !9
  %.893.1.i.i.i = fsub contract double %.862.1.i.i.i, %.892.1.i.i.i
  %62 = getelementptr i8, ptr %.678.i.i.i, i64 48
  %.924.1.i.i.i = load double, ptr %62, align 8, !noalias !9
  %.925.1.i.i.i = fmul contract double %.893.1.i.i.i, %.924.1.i.i.i
  store double %.925.1.i.i.i, ptr %60, align 8, !noalias !9
  %63 = getelementptr i8, ptr %.652.i.i, i64 16
  %.862.2.i.i.i = load double, ptr %63, align 8, !noalias !9
  %64 = getelementptr i8, ptr %.678.i.i.i, i64 16
  %.892.2.i.i.i = load double, ptr %64, align 8, !noalias !9
  %.893.2.i.i.i = fsub contract double %.862.2.i.i.i, %.892.2.i.i.i
  %65 = getelementptr i8, ptr %.678.i.i.i, i64 56
  %.924.2.i.i.i = load double, ptr %65, align 8, !noalias !9
  %.925.2.i.i.i = fmul contract double %.893.2.i.i.i, %.924.2.i.i.i
  store double %.925.2.i.i.i, ptr %63, align 8, !noalias !9
  %66 = getelementptr i8, ptr %.652.i.i, i64 24
  %.862.3.i.i.i = load double, ptr %66, align 8, !noalias !9
  %67 = getelementptr i8, ptr %.678.i.i.i, i64 24
  %.892.3.i.i.i = load double, ptr %67, align 8, !noalias !9
  %.893.3.i.i.i = fsub contract double %.862.3.i.i.i, %.892.3.i.i.i
  %68 = getelementptr i8, ptr %.678.i.i.i, i64 64
  %.924.3.i.i.i = load double, ptr %68, align 8, !noalias !9
  %.925.3.i.i.i = fmul contract double %.893.3.i.i.i, %.924.3.i.i.i
  store double %.925.3.i.i.i, ptr %66, align 8, !noalias !9
  %69 = getelementptr i8, ptr %.678.i.i.i, i64 32
  %.892.4.i.i.i = load double, ptr %69, align 8, !noalias !9
  %.893.4.i.i.i = fsub contract double %.172.i.sink.i.i.i, %.892.4.i.i.i
  %70 = getelementptr i8, ptr %.678.i.i.i, i64 72
  %.924.4.i.i.i = load double, ptr %70, align 8, !noalias !9
  %.925.4.i.i.i = fmul contract double %.893.4.i.i.i, %.924.4.i.i.i
  store double %.925.4.i.i.i, ptr %.200.i.i.i.i, align 8, !noalias !9
  %.1056673.not.i.i.i = icmp eq i64 %.340.sroa.13.2.i.i, 0
  br i1 %.1056673.not.i.i.i, label %B360.i.i.i, label %B344.if.preheader.i.i.i

B344.if.preheader.i.i.i:                          ; preds = %B150.else.endif.endif.i.i.i
  %71 = shl nuw i64 %.340.sroa.13.2.i.i, 3
  tail call void @llvm.memset.p0.i64(ptr align 8 %.1362.i, i8 0, i64 %71, i1 false), !noalias !9
  br label %B360.i.i.i

B394.else.if.i.i.i:                               ; preds = %B394.i.i.i
  br label %B394.else.endif.i.i.i

B394.else.endif.i.i.i:                            ; preds = %B394.else.if.i.i.i, %B394.i.i.i
  %.1217.sroa.0.1.i.i.i = phi i64 [ 0, %B394.else.if.i.i.i ], [ %.1229.i.i.i, %B394.i.i.i ]
  %.1237.not.i.i.i = icmp slt i64 %.1229.i.i.i, %arg.n_weights
  br i1 %.1237.not.i.i.i, label %B394.else.endif.endif.i.i.i, label %B394.else.endif.if.i.i.i, !prof !5

B394.else.endif.if.i.i.i:                         ; preds = %B394.else.endif.i.i.i
  br label %B394.else.endif.endif.i.i.i

B394.else.endif.endif.i.i.i:                      ; preds = %B394.else.endif.if.i.i.i, %B394.else.endif.i.i.i
  %.1217.sroa.0.3.i.i.i = phi i64 [ %arg.n_weights, %B394.else.endif.if.i.i.i ], [ %.1217.sroa.0.1.i.i.i, %B394.else.endif.i.i.i ]
  %.1305.i.i.i = sub i64 %arg.n_weights, %.1217.sroa.0.3.i.i.i
  %.1314.i.i.i = tail call i64 @llvm.smax.i64(i64 %.1305.i.i.i, i64 0)
  %.1330.i.i.i = getelementptr double, ptr %arg.weights, i64 %.1217.sroa.0.3.i.i.i
  %.1422.i.i.i = load i64, ptr %.1421.i.i.i, align 8, !noalias !9
  %.1469.i.i.i = icmp slt i64 %.627.i.i, 6
  br i1 %.1469.i.i.i, label %B394.endif.else.endif.if.i.i.i, label %B394.endif.else.endif.endif.i.i.i, !prof !4

B394.endif.else.endif.if.i.i.i:                   ; preds = %B394.else.endif.endif.i.i.i
  br label %B394.endif.else.endif.endif.i.i.i

B394.endif.else.endif.endif.i.i.i:                ; preds = %B394.endif.else.endif.if.i.i.i, %B394.else.endif.endif.i.i.i
  %.1449.sroa.0.3.i.i.i = phi i64 [ %.636.i.i, %B394.endif.else.endif.if.i.i.i ], [ 5, %B394.else.endif.endif.i.i.i ]
  %.1537.i.i.i = sub nsw i64 %.636.i.i, %.1449.sroa.0.3.i.i.i
  %.1546.i.i.i = tail call i64 @llvm.smax.i64(i64 %.1537.i.i.i, i64 0)
  %.1562.i.i.i = getelementptr double, ptr %.652.i.i, i64 %.1449.sroa.0.3.i.i.i
  %.81.i.i.i.i = add nsw i64 %.1422.i.i.i, 1
  %.518.i.i.i.i = add i64 %.1422.i.i.i, -1
  %..518.i.i.i.i = tail call i64 @llvm.smax.i64(i64 %.518.i.i.i.i, i64 0)
  %72 = and i64 %..518.i.i.i.i, 9223372036854775806
  %73 = icmp sgt i64 %.1422.i.i.i, 0
  %74 = icmp slt i64 %.518.i.i.i.i, 1
  %75 = icmp eq i64 %.518.i.i.i.i, 1
  %76 = and i64 %..518.i.i.i.i, 1
  %77 = icmp eq i64 %76, 0
  br label %B44.if.i.i.i.i

B112.i.i.i.i:                                     ; preds = %B46.else.endif.endif.i.i.i.i
  %.478.i.i.i.i = getelementptr i8, ptr %.378.i.i.i.i, i64 8
  store double %.233.i.i.i.i, ptr %.478.i.i.i.i, align 8, !noalias !15
  br label %B122.i.i.i.i

B122.i.i.i.i:                                     ; preds = %B46.else.endif.endif.i.i.i.i, %B112.i.i.i.i
  br i1 %74, label %B224.i.i.i.i, label %B154.if.lr.ph.i.i.i.i

B154.if.lr.ph.i.i.i.i:                            ; preds = %B122.i.i.i.i
  %.600.i.i.i.i = fmul contract double %.233.i.i.i.i, 2.000000e+00
  br i1 %75, label %.thread16.i.i.i.i, label %B154.if.preheader.i.i.i.i

B154.if.preheader.i.i.i.i:                        ; preds = %B154.if.lr.ph.i.i.i.i
  %78 = shl i64 %.362.i.i.i.i, 3
  br label %B154.if.i.i.i.i

.thread16.i.i.i.i:                                ; preds = %B154.if.lr.ph.i.i.i.i
  %79 = getelementptr i8, ptr %.378.i.i.i.i, i64 8
  %.631.epil10.i.i.i.i = load double, ptr %79, align 8, !noalias !15
  %.632.epil11.i.i.i.i = fmul contract double %.600.i.i.i.i, %.631.epil10.i.i.i.i
  %.663.epil20.i.i.i.i = load double, ptr %.378.i.i.i.i, align 8, !noalias !15
  %.664.epil21.i.i.i.i = fsub contract double %.632.epil11.i.i.i.i, %.663.epil20.i.i.i.i
  br label %84

B224.loopexit.unr-lcssa.i.i.i.i:                  ; preds = %B154.if.i.i.i.i
  br i1 %77, label %B224.i.i.i.i, label %B154.if.epil.preheader.i.i.i.i

B154.if.epil.preheader.i.i.i.i:                   ; preds = %B224.loopexit.unr-lcssa.i.i.i.i
  %80 = add i64 %lsr.iv57.i.i.i.i, 1
  %.615.inv.epil.i.i.i.i = icmp ult i64 %lsr.iv57.i.i.i.i, 9223372036854775807
  %81 = select i1 %.615.inv.epil.i.i.i.i, i64 0, i64 %78
  %scevgep65.i.i.i.i = getelementptr i8, ptr %.378.i.i.i.i, i64 %81
  %82 = shl i64 %lsr.iv.next58.i.i.i.i, 3
  %scevgep66.i.i.i.i = getelementptr i8, ptr %scevgep65.i.i.i.i, i64 %82
  %scevgep67.i.i.i.i = getelementptr i8, ptr %scevgep66.i.i.i.i, i64 -16
  %.631.epil.i.i.i.i = load double, ptr %scevgep67.i.i.i.i, align 8, !noalias !15
  %.632.epil.i.i.i.i = fmul contract double %.600.i.i.i.i, %.631.epil.i.i.i.i
  %.647.epil.i.i.i.i = icmp slt i64 %80, 2
  %83 = select i1 %.647.epil.i.i.i.i, i64 %78, i64 0
  %scevgep59.i.i.i.i = getelementptr i8, ptr %.378.i.i.i.i, i64 %83
  %scevgep20.i.i.i.i = getelementptr i8, ptr %scevgep59.i.i.i.i, i64 %82
  %scevgep21.i.i.i.i = getelementptr i8, ptr %scevgep20.i.i.i.i, i64 -24
  %.663.epil.i.i.i.i = load double, ptr %scevgep21.i.i.i.i, align 8, !noalias !15
  %.664.epil.i.i.i.i = fsub contract double %.632.epil.i.i.i.i, %.663.epil.i.i.i.i
  %.678.epil.i.i.i.i = icmp slt i64 %80, 0
  %spec.select25.i.i.i.i = select i1 %.678.epil.i.i.i.i, i64 %.362.i.i.i.i, i64 0
  br label %84

84:                                               ; preds = %B154.if.epil.preheader.i.i.i.i, %.thread16.i.i.i.i
  %.664.epil24.i.i.i.i = phi double [ %.664.epil21.i.i.i.i, %.thread16.i.i.i.i ], [ %.664.epil.i.i.i.i, %B154.if.epil.preheader.i.i.i.i ]
  %85 = phi i64 [ 16, %.thread16.i.i.i.i ], [ %lsr.iv.next.i.i.i.i, %B154.if.epil.preheader.i.i.i.i ]
  %86 = phi i64 [ 0, %.thread16.i.i.i.i ], [ %spec.select25.i.i.i.i, %B154.if.epil.preheader.i.i.i.i ]
  %87 = getelementptr i8, ptr %.378.i.i.i.i, i64 %85
  %.693.epil.i.i.i.i = getelementptr double, ptr %87, i64 %86
  store double %.664.epil24.i.i.i.i, ptr %.693.epil.i.i.i.i, align 8, !noalias !15
  br label %B224.i.i.i.i

B224.i.i.i.i:                                     ; preds = %84, %B224.loopexit.unr-lcssa.i.i.i.i, %B122.i.i.i.i
  %exitcond545.not.i.i.i.i = icmp eq i64 %.179.i.i.i.i, 5
  br i1 %exitcond545.not.i.i.i.i, label %B282.if.lr.ph.i.i.i.i, label %B44.if.i.i.i.i

B282.if.lr.ph.i.i.i.i:                            ; preds = %B224.i.i.i.i
  %.1039.1.i.i.i.i = shl nsw i64 %.81.i.i.i.i, 1
  %.1039.2.i.i.i.i = mul nsw i64 %.81.i.i.i.i, 3
  %.1039.3.i.i.i.i = shl nsw i64 %.81.i.i.i.i, 2
  %unroll_iter5.i.i.i.i = and i64 %.340.sroa.13.2.i.i, 9223372036854775806
  %scevgep11.i.i.i.i = getelementptr i8, ptr %.1330.i.i.i, i64 8
  %88 = add nsw i64 %unroll_iter5.i.i.i.i, -2
  %89 = lshr exact i64 %88, 1
  %90 = add nuw i64 %89, 1
  %scevgep49.i.i.i.i = getelementptr i8, ptr %.1330.i.i.i, i64 24
  %91 = lshr i64 %90, 1
  %92 = mul nsw i64 %91, -2
  %trunc.i.i.i.i = trunc nuw i64 %.340.sroa.13.2.i.i to i63
  %93 = icmp eq i64 %88, 0
  %94 = and i64 %88, 2
  %95 = icmp eq i64 %94, 0
  %96 = and i64 %.340.sroa.13.2.i.i, 1
  %97 = icmp eq i64 %96, 0
  br label %B282.if.i.i.i.i

B540.loopexit.unr-lcssa.unr-lcssa.i.i.i.i:        ; preds = %B484.if.i.i.i.i
  br i1 %95, label %B484.if.epil.preheader27.i.i.i.i, label %B540.loopexit.unr-lcssa.i.i.i.i

B484.if.epil.preheader27.i.i.i.i:                 ; preds = %B484.if.preheader7.i.i.i.i, %B540.loopexit.unr-lcssa.unr-lcssa.i.i.i.i
  %.1385520522.epil.init32.i.i.i.i = phi i64 [ 0, %B484.if.preheader7.i.i.i.i ], [ %.1392.1.1.i.i.i.i, %B540.loopexit.unr-lcssa.unr-lcssa.i.i.i.i ]
  %98 = shl i64 %.1385520522.epil.init32.i.i.i.i, 3
  %sunkaddr33.epil.i.i.i.i = getelementptr i8, ptr %.1362.i, i64 %98
  %.1446.epil28.i.i.i.i = load double, ptr %sunkaddr33.epil.i.i.i.i, align 8, !noalias !15
  %scevgep14.epil.i.i.i.i = getelementptr i8, ptr %scevgep12.i.i.i.i, i64 %98
  %scevgep15.epil.i.i.i.i = getelementptr i8, ptr %scevgep14.epil.i.i.i.i, i64 -8
  %.1476.epil29.i.i.i.i = load double, ptr %scevgep15.epil.i.i.i.i, align 8, !noalias !15
  %.1478.epil30.i.i.i.i = fmul contract double %.1105.3.i.i.i.i, %.1476.epil29.i.i.i.i
  %.1479.epil31.i.i.i.i = fadd contract double %.1446.epil28.i.i.i.i, %.1478.epil30.i.i.i.i
  store double %.1479.epil31.i.i.i.i, ptr %sunkaddr33.epil.i.i.i.i, align 8, !noalias !15
  %.1392.1.epil.i.i.i.i = add nuw i64 %.1385520522.epil.init32.i.i.i.i, 2
  %sunkaddr36.epil.i.i.i.i = getelementptr i8, ptr %sunkaddr33.epil.i.i.i.i, i64 8
  %.1446.1.epil.i.i.i.i = load double, ptr %sunkaddr36.epil.i.i.i.i, align 8, !noalias !15
  %.1476.1.epil.i.i.i.i = load double, ptr %scevgep14.epil.i.i.i.i, align 8, !noalias !15
  %.1478.1.epil.i.i.i.i = fmul contract double %.1105.3.i.i.i.i, %.1476.1.epil.i.i.i.i
  %.1479.1.epil.i.i.i.i = fadd contract double %.1446.1.epil.i.i.i.i, %.1478.1.epil.i.i.i.i
  store double %.1479.1.epil.i.i.i.i, ptr %sunkaddr36.epil.i.i.i.i, align 8, !noalias !15
  br label %B540.loopexit.unr-lcssa.i.i.i.i

B540.loopexit.unr-lcssa.i.i.i.i:                  ; preds = %B484.if.epil.preheader27.i.i.i.i, %B540.loopexit.unr-lcssa.unr-lcssa.i.i.i.i
  %.1392.1.lcssa.i.i.i.i = phi i64 [ %.1392.1.epil.i.i.i.i, %B484.if.epil.preheader27.i.i.i.i ], [ %.1392.1.1.i.i.i.i, %B540.loopexit.unr-lcssa.unr-lcssa.i.i.i.i ]
  br i1 %97, label %B540.i.i.i.i, label %B484.if.epil.preheader.i.i.i.i

B484.if.epil.preheader.i.i.i.i:                   ; preds = %B416.else.endif.endif.endif.endif.i.i.i.i, %B540.loopexit.unr-lcssa.i.i.i.i
  %.1385520522.epil.init.i.i.i.i = phi i64 [ 0, %B416.else.endif.endif.endif.endif.i.i.i.i ], [ %.1392.1.lcssa.i.i.i.i, %B540.loopexit.unr-lcssa.i.i.i.i ]
  %99 = getelementptr double, ptr %.1362.i, i64 %.1385520522.epil.init.i.i.i.i
  %.1446.epil.i.i.i.i = load double, ptr %99, align 8, !noalias !15
  %100 = getelementptr double, ptr %.1261.i.i.i.i, i64 %.1385520522.epil.init.i.i.i.i
  %.1476.epil.i.i.i.i = load double, ptr %100, align 8, !noalias !15
  %.1478.epil.i.i.i.i = fmul contract double %.1105.3.i.i.i.i, %.1476.epil.i.i.i.i
  %.1479.epil.i.i.i.i = fadd contract double %.1446.epil.i.i.i.i, %.1478.epil.i.i.i.i
  store double %.1479.epil.i.i.i.i, ptr %99, align 8, !noalias !15
  br label %B540.i.i.i.i

B540.i.i.i.i:                                     ; preds = %B416.else.endif.endif.endif.endif.i.i.i.i, %B484.if.epil.preheader.i.i.i.i, %B540.loopexit.unr-lcssa.i.i.i.i
  %exitcond548.not.i.i.i.i = icmp eq i64 %.828.i.i.i.i, %.1158.i.i.i
  br i1 %exitcond548.not.i.i.i.i, label %B538.i.i.i, label %B282.if.i.i.i.i

B44.if.i.i.i.i:                                   ; preds = %B224.i.i.i.i, %B394.endif.else.endif.endif.i.i.i
  %.172498504.i.i.i.i = phi i64 [ 0, %B394.endif.else.endif.endif.i.i.i ], [ %.179.i.i.i.i, %B224.i.i.i.i ]
  %.179.i.i.i.i = add nuw nsw i64 %.172498504.i.i.i.i, 1
  %101 = getelementptr double, ptr %.652.i.i, i64 %.172498504.i.i.i.i
  %.233.i.i.i.i = load double, ptr %101, align 8, !noalias !15
  %.238.i.i.i.i = mul nsw i64 %.172498504.i.i.i.i, %.81.i.i.i.i
  %.275.i.i.i.i = icmp slt i64 %.238.i.i.i.i, 0
  %.276.i.i.i.i = select i1 %.275.i.i.i.i, i64 %.1546.i.i.i, i64 0
  %.277.i.i.i.i = add i64 %.276.i.i.i.i, %.238.i.i.i.i
  %.280.i.i.i.i = icmp slt i64 %.277.i.i.i.i, 0
  br i1 %.280.i.i.i.i, label %B46.else.if.i.i.i.i, label %B46.else.endif.i.i.i.i, !prof !4

B46.else.if.i.i.i.i:                              ; preds = %B44.if.i.i.i.i
  br label %B46.else.endif.i.i.i.i

B46.else.endif.i.i.i.i:                           ; preds = %B46.else.if.i.i.i.i, %B44.if.i.i.i.i
  %.265.sroa.0.1.i.i.i.i = phi i64 [ 0, %B46.else.if.i.i.i.i ], [ %.277.i.i.i.i, %B44.if.i.i.i.i ]
  %.285.not.i.i.i.i = icmp slt i64 %.277.i.i.i.i, %.1546.i.i.i
  br i1 %.285.not.i.i.i.i, label %B46.else.endif.endif.i.i.i.i, label %B46.else.endif.if.i.i.i.i, !prof !5

B46.else.endif.if.i.i.i.i:                        ; preds = %B46.else.endif.i.i.i.i
  br label %B46.else.endif.endif.i.i.i.i

B46.else.endif.endif.i.i.i.i:                     ; preds = %B46.else.endif.if.i.i.i.i, %B46.else.endif.i.i.i.i
  %.265.sroa.0.3.i.i.i.i = phi i64 [ %.1546.i.i.i, %B46.else.endif.if.i.i.i.i ], [ %.265.sroa.0.1.i.i.i.i, %B46.else.endif.i.i.i.i ]
  %.353.i.i.i.i = sub nsw i64 %.1546.i.i.i, %.265.sroa.0.3.i.i.i.i
  %.362.i.i.i.i = tail call i64 @llvm.smax.i64(i64 %.353.i.i.i.i, i64 0)
  %.378.i.i.i.i = getelementptr double, ptr %.1562.i.i.i, i64 %.265.sroa.0.3.i.i.i.i
  store double 1.000000e+00, ptr %.378.i.i.i.i, align 8, !noalias !15
  br i1 %73, label %B112.i.i.i.i, label %B122.i.i.i.i

B154.if.i.i.i.i:                                  ; preds = %B154.if.i.i.i.i, %B154.if.preheader.i.i.i.i
  %lsr.iv.i.i.i.i = phi i64 [ %lsr.iv.next.i.i.i.i, %B154.if.i.i.i.i ], [ 16, %B154.if.preheader.i.i.i.i ]
  %lsr.iv57.i.i.i.i = phi i64 [ %lsr.iv.next58.i.i.i.i, %B154.if.i.i.i.i ], [ 3, %B154.if.preheader.i.i.i.i ]
  %.615.inv.i.i.i.i = icmp sgt i64 %lsr.iv57.i.i.i.i, 1
  %102 = select i1 %.615.inv.i.i.i.i, i64 0, i64 %78
  %scevgep30.i.i.i.i = getelementptr i8, ptr %.378.i.i.i.i, i64 %102
  %103 = shl i64 %lsr.iv57.i.i.i.i, 3
  %scevgep76.i.i.i.i = getelementptr i8, ptr %scevgep30.i.i.i.i, i64 %103
  %scevgep77.i.i.i.i = getelementptr i8, ptr %scevgep76.i.i.i.i, i64 -16
  %.631.i.i.i.i = load double, ptr %scevgep77.i.i.i.i, align 8, !noalias !15
  %.632.i.i.i.i = fmul contract double %.600.i.i.i.i, %.631.i.i.i.i
  %104 = add i64 %lsr.iv57.i.i.i.i, 9223372036854775807
  %.647.i.i.i.i = icmp ult i64 %104, -9223372036854775806
  %105 = select i1 %.647.i.i.i.i, i64 %78, i64 0
  %scevgep28.i.i.i.i = getelementptr i8, ptr %.378.i.i.i.i, i64 %105
  %scevgep27.i.i.i.i = getelementptr i8, ptr %scevgep28.i.i.i.i, i64 %103
  %scevgep29.i.i.i.i = getelementptr i8, ptr %scevgep27.i.i.i.i, i64 -24
  %.663.i.i.i.i = load double, ptr %scevgep29.i.i.i.i, align 8, !noalias !15
  %.664.i.i.i.i = fsub contract double %.632.i.i.i.i, %.663.i.i.i.i
  %.678.inv.i.i.i.i = icmp sgt i64 %lsr.iv57.i.i.i.i, 0
  %106 = select i1 %.678.inv.i.i.i.i, i64 0, i64 %78
  %scevgep25.i.i.i.i = getelementptr i8, ptr %.378.i.i.i.i, i64 %106
  %scevgep24.i.i.i.i = getelementptr i8, ptr %scevgep25.i.i.i.i, i64 %103
  %scevgep26.i.i.i.i = getelementptr i8, ptr %scevgep24.i.i.i.i, i64 -8
  store double %.664.i.i.i.i, ptr %scevgep26.i.i.i.i, align 8, !noalias !15
  %.632.1.i.i.i.i = fmul contract double %.600.i.i.i.i, %.664.i.i.i.i
  %.647.1.i.i.i.i = icmp slt i64 %lsr.iv57.i.i.i.i, 2
  %107 = select i1 %.647.1.i.i.i.i, i64 %78, i64 0
  %scevgep19.i.i.i.i = getelementptr i8, ptr %.378.i.i.i.i, i64 %107
  %scevgep22.i.i.i.i = getelementptr i8, ptr %scevgep19.i.i.i.i, i64 %103
  %scevgep23.i.i.i.i = getelementptr i8, ptr %scevgep22.i.i.i.i, i64 -16
  %.663.1.i.i.i.i = load double, ptr %scevgep23.i.i.i.i, align 8, !noalias !15
  %.664.1.i.i.i.i = fsub contract double %.632.1.i.i.i.i, %.663.1.i.i.i.i
  store double %.664.1.i.i.i.i, ptr %scevgep24.i.i.i.i, align 8, !noalias !15
  %lsr.iv.next58.i.i.i.i = add i64 %lsr.iv57.i.i.i.i, 2
  %lsr.iv.next.i.i.i.i = add i64 %lsr.iv.i.i.i.i, 16
  %108 = sub i64 %lsr.iv.next58.i.i.i.i, %72
  %niter.ncmp.1.i.i.i.i = icmp eq i64 %108, 3
  br i1 %niter.ncmp.1.i.i.i.i, label %B224.loopexit.unr-lcssa.i.i.i.i, label %B154.if.i.i.i.i

B282.if.i.i.i.i:                                  ; preds = %B540.i.i.i.i, %B282.if.lr.ph.i.i.i.i
  %.821527537.i.i.i.i = phi i64 [ 0, %B282.if.lr.ph.i.i.i.i ], [ %.828.i.i.i.i, %B540.i.i.i.i ]
  %.828.i.i.i.i = add nuw nsw i64 %.821527537.i.i.i.i, 1
  %.idx.i.i.i.i = mul i64 %.821527537.i.i.i.i, 40
  %109 = getelementptr i8, ptr %arg.exponents, i64 %.idx.i.i.i.i
  %.887.i.i.i.i = load i64, ptr %109, align 8, !noalias !15
  %.901.i.i.i.i = icmp slt i64 %.887.i.i.i.i, 0
  %.902.i.i.i.i = select i1 %.901.i.i.i.i, i64 %.1546.i.i.i, i64 0
  %110 = getelementptr double, ptr %.1562.i.i.i, i64 %.887.i.i.i.i
  %.916.i.i.i.i = getelementptr double, ptr %110, i64 %.902.i.i.i.i
  %.917.i.i.i.i = load double, ptr %.916.i.i.i.i, align 8, !noalias !15
  %111 = getelementptr i8, ptr %109, i64 8
  %.1072.i.i.i.i = load i64, ptr %111, align 8, !noalias !15
  %.1073.i.i.i.i = add nsw i64 %.1072.i.i.i.i, %.81.i.i.i.i
  %.1087.i.i.i.i = icmp slt i64 %.1073.i.i.i.i, 0
  %.1088.i.i.i.i = select i1 %.1087.i.i.i.i, i64 %.1546.i.i.i, i64 0
  %112 = getelementptr double, ptr %.1562.i.i.i, i64 %.1073.i.i.i.i
  %.1102.i.i.i.i = getelementptr double, ptr %112, i64 %.1088.i.i.i.i
  %.1103.i.i.i.i = load double, ptr %.1102.i.i.i.i, align 8, !noalias !15
  %.1105.i.i.i.i = fmul contract double %.917.i.i.i.i, %.1103.i.i.i.i
  %113 = getelementptr i8, ptr %109, i64 16
  %.1072.1.i.i.i.i = load i64, ptr %113, align 8, !noalias !15
  %.1073.1.i.i.i.i = add nsw i64 %.1072.1.i.i.i.i, %.1039.1.i.i.i.i
  %.1087.1.i.i.i.i = icmp slt i64 %.1073.1.i.i.i.i, 0
  %.1088.1.i.i.i.i = select i1 %.1087.1.i.i.i.i, i64 %.1546.i.i.i, i64 0
  %114 = getelementptr double, ptr %.1562.i.i.i, i64 %.1073.1.i.i.i.i
  %.1102.1.i.i.i.i = getelementptr double, ptr %114, i64 %.1088.1.i.i.i.i
  %.1103.1.i.i.i.i = load double, ptr %.1102.1.i.i.i.i, align 8, !noalias !15
  %.1105.1.i.i.i.i = fmul contract double %.1105.i.i.i.i, %.1103.1.i.i.i.i
  %115 = getelementptr i8, ptr %109, i64 24
  %.1072.2.i.i.i.i = load i64, ptr %115, align 8, !noalias !15
  %.1073.2.i.i.i.i = add nsw i64 %.1072.2.i.i.i.i, %.1039.2.i.i.i.i
  %.1087.2.i.i.i.i = icmp slt i64 %.1073.2.i.i.i.i, 0
  %.1088.2.i.i.i.i = select i1 %.1087.2.i.i.i.i, i64 %.1546.i.i.i, i64 0
  %116 = getelementptr double, ptr %.1562.i.i.i, i64 %.1073.2.i.i.i.i
  %.1102.2.i.i.i.i = getelementptr double, ptr %116, i64 %.1088.2.i.i.i.i
  %.1103.2.i.i.i.i = load double, ptr %.1102.2.i.i.i.i, align 8, !noalias !15
  %.1105.2.i.i.i.i = fmul contract double %.1105.1.i.i.i.i, %.1103.2.i.i.i.i
  %117 = getelementptr i8, ptr %109, i64 32
  %.1072.3.i.i.i.i = load i64, ptr %117, align 8, !noalias !15
  %.1073.3.i.i.i.i = add nsw i64 %.1072.3.i.i.i.i, %.1039.3.i.i.i.i
  %.1087.3.i.i.i.i = icmp slt i64 %.1073.3.i.i.i.i, 0
  %.1088.3.i.i.i.i = select i1 %.1087.3.i.i.i.i, i64 %.1546.i.i.i, i64 0
  %118 = getelementptr double, ptr %.1562.i.i.i, i64 %.1073.3.i.i.i.i
  %.1102.3.i.i.i.i = getelementptr double, ptr %118, i64 %.1088.3.i.i.i.i
  %.1103.3.i.i.i.i = load double, ptr %.1102.3.i.i.i.i, align 8, !noalias !15
  %.1105.3.i.i.i.i = fmul contract double %.1105.2.i.i.i.i, %.1103.3.i.i.i.i
  %.1115.i.i.i.i = mul nuw nsw i64 %.821527537.i.i.i.i, %.340.sroa.13.2.i.i
  %.1168.not.i.i.i.i = icmp sgt i64 %.1305.i.i.i, %.1115.i.i.i.i
  br i1 %.1168.not.i.i.i.i, label %B416.else.endif.endif.endif.endif.i.i.i.i, label %B416.else.endif.if.i.i.i.i, !prof !5

B416.else.endif.if.i.i.i.i:                       ; preds = %B282.if.i.i.i.i
  br label %B416.else.endif.endif.endif.endif.i.i.i.i

B416.else.endif.endif.endif.endif.i.i.i.i:        ; preds = %B416.else.endif.if.i.i.i.i, %B282.if.i.i.i.i
  %.1148.sroa.0.3.i.i.i.i = phi i64 [ %.1314.i.i.i, %B416.else.endif.if.i.i.i.i ], [ %.1115.i.i.i.i, %B282.if.i.i.i.i ]
  %.1261.i.i.i.i = getelementptr double, ptr %.1330.i.i.i, i64 %.1148.sroa.0.3.i.i.i.i
  switch i63 %trunc.i.i.i.i, label %B484.if.preheader7.i.i.i.i [
    i63 0, label %B540.i.i.i.i
    i63 1, label %B484.if.epil.preheader.i.i.i.i
  ]

B484.if.preheader7.i.i.i.i:                       ; preds = %B416.else.endif.endif.endif.endif.i.i.i.i
  %119 = shl i64 %.1148.sroa.0.3.i.i.i.i, 3
  %scevgep12.i.i.i.i = getelementptr i8, ptr %scevgep11.i.i.i.i, i64 %119
  br i1 %93, label %B484.if.epil.preheader27.i.i.i.i, label %B484.if.preheader41.i.i.i.i

B484.if.preheader41.i.i.i.i:                      ; preds = %B484.if.preheader7.i.i.i.i
  %scevgep50.i.i.i.i = getelementptr i8, ptr %scevgep49.i.i.i.i, i64 %119
  br label %B484.if.i.i.i.i

B484.if.i.i.i.i:                                  ; preds = %B484.if.i.i.i.i, %B484.if.preheader41.i.i.i.i
  %lsr.iv1.i.i.i.i = phi i64 [ %lsr.iv.next2.i.i.i.i, %B484.if.i.i.i.i ], [ %92, %B484.if.preheader41.i.i.i.i ]
  %.1385520522.i.i.i.i = phi i64 [ %.1392.1.1.i.i.i.i, %B484.if.i.i.i.i ], [ 0, %B484.if.preheader41.i.i.i.i ]
  %120 = shl i64 %.1385520522.i.i.i.i, 3
  %sunkaddr31.i.i.i.i = getelementptr i8, ptr %.1362.i, i64 %120
  %.1446.i.i.i.i = load double, ptr %sunkaddr31.i.i.i.i, align 8, !noalias !15
  %scevgep53.i.i.i.i = getelementptr i8, ptr %scevgep50.i.i.i.i, i64 %120
  %scevgep18.i.i.i.i = getelementptr i8, ptr %scevgep53.i.i.i.i, i64 -16
  %scevgep15.i.i.i.i = getelementptr i8, ptr %scevgep53.i.i.i.i, i64 -24
  %.1476.i.i.i.i = load double, ptr %scevgep15.i.i.i.i, align 8, !noalias !15
  %.1478.i.i.i.i = fmul contract double %.1105.3.i.i.i.i, %.1476.i.i.i.i
  %.1479.i.i.i.i = fadd contract double %.1446.i.i.i.i, %.1478.i.i.i.i
  store double %.1479.i.i.i.i, ptr %sunkaddr31.i.i.i.i, align 8, !noalias !15
  %sunkaddr34.i.i.i.i = getelementptr i8, ptr %sunkaddr31.i.i.i.i, i64 8
  %.1446.1.i.i.i.i = load double, ptr %sunkaddr34.i.i.i.i, align 8, !noalias !15
  %.1476.1.i.i.i.i = load double, ptr %scevgep18.i.i.i.i, align 8, !noalias !15
  %.1478.1.i.i.i.i = fmul contract double %.1105.3.i.i.i.i, %.1476.1.i.i.i.i
  %.1479.1.i.i.i.i = fadd contract double %.1446.1.i.i.i.i, %.1478.1.i.i.i.i
  store double %.1479.1.i.i.i.i, ptr %sunkaddr34.i.i.i.i, align 8, !noalias !15
  %sunkaddr37.i.i.i.i = getelementptr i8, ptr %sunkaddr31.i.i.i.i, i64 16
  %.1446.137.i.i.i.i = load double, ptr %sunkaddr37.i.i.i.i, align 8, !noalias !15
  %scevgep13.i.i.i.i = getelementptr i8, ptr %scevgep53.i.i.i.i, i64 -8
  %.1476.138.i.i.i.i = load double, ptr %scevgep13.i.i.i.i, align 8, !noalias !15
  %.1478.139.i.i.i.i = fmul contract double %.1105.3.i.i.i.i, %.1476.138.i.i.i.i
  %.1479.140.i.i.i.i = fadd contract double %.1446.137.i.i.i.i, %.1478.139.i.i.i.i
  store double %.1479.140.i.i.i.i, ptr %sunkaddr37.i.i.i.i, align 8, !noalias !15
  %.1392.1.1.i.i.i.i = add i64 %.1385520522.i.i.i.i, 4
  %sunkaddr38.i.i.i.i = shl i64 %.1392.1.1.i.i.i.i, 3
  %sunkaddr39.i.i.i.i = getelementptr i8, ptr %.1362.i, i64 %sunkaddr38.i.i.i.i
  %sunkaddr40.i.i.i.i = getelementptr i8, ptr %sunkaddr39.i.i.i.i, i64 -8
  %.1446.1.1.i.i.i.i = load double, ptr %sunkaddr40.i.i.i.i, align 8, !noalias !15
  %.1476.1.1.i.i.i.i = load double, ptr %scevgep53.i.i.i.i, align 8, !noalias !15
  %.1478.1.1.i.i.i.i = fmul contract double %.1105.3.i.i.i.i, %.1476.1.1.i.i.i.i
  %.1479.1.1.i.i.i.i = fadd contract double %.1446.1.1.i.i.i.i, %.1478.1.1.i.i.i.i
  store double %.1479.1.1.i.i.i.i, ptr %sunkaddr40.i.i.i.i, align 8, !noalias !15
  %lsr.iv.next2.i.i.i.i = add i64 %lsr.iv1.i.i.i.i, 2
  %niter36.ncmp.1.i.i.i.i = icmp eq i64 %lsr.iv.next2.i.i.i.i, 0
  br i1 %niter36.ncmp.1.i.i.i.i, label %B540.loopexit.unr-lcssa.unr-lcssa.i.i.i.i, label %B484.if.i.i.i.i

B572.else.if.i.i.i:                               ; preds = %B572.i.i.i
  br label %B572.else.endif.i.i.i

B572.else.endif.i.i.i:                            ; preds = %B572.else.if.i.i.i, %B572.i.i.i
  %.1737.sroa.0.1.i.i.i = phi i64 [ 0, %B572.else.if.i.i.i ], [ %.1749.i.i.i, %B572.i.i.i ]
  %.1757.not.i.i.i = icmp slt i64 %.1749.i.i.i, %arg.n_weights
  br i1 %.1757.not.i.i.i, label %B572.else.endif.endif.i.i.i, label %B572.else.endif.if.i.i.i, !prof !5

B572.else.endif.if.i.i.i:                         ; preds = %B572.else.endif.i.i.i
  br label %B572.else.endif.endif.i.i.i

B572.else.endif.endif.i.i.i:                      ; preds = %B572.else.endif.if.i.i.i, %B572.else.endif.i.i.i
  %.1737.sroa.0.3.i.i.i = phi i64 [ %arg.n_weights, %B572.else.endif.if.i.i.i ], [ %.1737.sroa.0.1.i.i.i, %B572.else.endif.i.i.i ]
  %.1825.i.i.i = sub i64 %arg.n_weights, %.1737.sroa.0.3.i.i.i
  %.1834.i.i.i = tail call i64 @llvm.smax.i64(i64 %.1825.i.i.i, i64 0)
  %.1850.i.i.i = getelementptr double, ptr %arg.weights, i64 %.1737.sroa.0.3.i.i.i
  %.1933.i.i.i = icmp slt i64 %.627.i.i, 6
  br i1 %.1933.i.i.i, label %B572.endif.else.endif.if.i.i.i, label %B572.endif.else.endif.endif.i.i.i, !prof !4

B572.endif.else.endif.if.i.i.i:                   ; preds = %B572.else.endif.endif.i.i.i
  br label %B572.endif.else.endif.endif.i.i.i

B572.endif.else.endif.endif.i.i.i:                ; preds = %B572.endif.else.endif.if.i.i.i, %B572.else.endif.endif.i.i.i
  %.1913.sroa.0.3.i.i.i = phi i64 [ %.636.i.i, %B572.endif.else.endif.if.i.i.i ], [ 5, %B572.else.endif.endif.i.i.i ]
  %.2026.i.i.i = getelementptr double, ptr %.652.i.i, i64 %.1913.sroa.0.3.i.i.i
  %.576.i.i.i.i = load double, ptr %.652.i.i, align 8, !noalias !18
  store double %.576.i.i.i.i, ptr %.2026.i.i.i, align 8, !noalias !18
  %.576.1.i.i.i.i = load double, ptr %60, align 8, !noalias !18
  %121 = getelementptr i8, ptr %.2026.i.i.i, i64 8
  store double %.576.1.i.i.i.i, ptr %121, align 8, !noalias !18
  %.576.2.i.i.i.i = load double, ptr %63, align 8, !noalias !18
  %122 = getelementptr i8, ptr %.2026.i.i.i, i64 16
  store double %.576.2.i.i.i.i, ptr %122, align 8, !noalias !18
  %.576.3.i.i.i.i = load double, ptr %66, align 8, !noalias !18
  %123 = getelementptr i8, ptr %.2026.i.i.i, i64 24
  store double %.576.3.i.i.i.i, ptr %123, align 8, !noalias !18
  %.576.4.i.i.i.i = load double, ptr %.200.i.i.i.i, align 8, !noalias !18
  %124 = getelementptr i8, ptr %.2026.i.i.i, i64 32
  store double %.576.4.i.i.i.i, ptr %124, align 8, !noalias !18
  %.679.i.i.i.i = load i64, ptr %.1676.i.i.i, align 8, !noalias !18
  %.680.i.i.i.i = add nsw i64 %.679.i.i.i.i, -1
  %.765771.not.i.i.i.i = icmp slt i64 %.679.i.i.i.i, 1
  br i1 %.765771.not.i.i.i.i, label %B696.i.i.i.i, label %B210.if.lr.ph.i.i.i.i

B210.if.lr.ph.i.i.i.i:                            ; preds = %B572.endif.else.endif.endif.i.i.i
  %.2001.i.i.i = sub nsw i64 %.636.i.i, %.1913.sroa.0.3.i.i.i
  %.2010.i.i.i = tail call i64 @llvm.smax.i64(i64 %.2001.i.i.i, i64 0)
  %.274.sroa.0.39.i.i.i.i = tail call i64 @llvm.smin.i64(i64 range(i64 0, -9223372036854775808) %.2010.i.i.i, i64 1024)
  %.387.i.i.i.i = getelementptr double, ptr %.2026.i.i.i, i64 %.274.sroa.0.39.i.i.i.i
  %scevgep49.i1.i.i.i = getelementptr i8, ptr %.1850.i.i.i, i64 24
  %scevgep74.i.i.i.i = getelementptr i8, ptr %.1850.i.i.i, i64 8
  %scevgep54.i.i.i.i = getelementptr i8, ptr %.1850.i.i.i, i64 56
  br label %B210.if.i.i.i.i

B374.loopexit.unr-lcssa.unr-lcssa.i.i.i.i:        ; preds = %B346.if.i.i.i.i
  %125 = and i64 %154, 4
  %lcmp.mod.not28.not.i.i.i.i = icmp eq i64 %125, 0
  br i1 %lcmp.mod.not28.not.i.i.i.i, label %B346.if.epil.preheader1.i.i.i.i, label %B374.loopexit.unr-lcssa.i.i.i.i

B346.if.epil.preheader1.i.i.i.i:                  ; preds = %B346.if.preheader.new.i.i.i.i, %B374.loopexit.unr-lcssa.unr-lcssa.i.i.i.i
  %.1083.0.epil.init6.i.i.i.i = phi i64 [ 0, %B346.if.preheader.new.i.i.i.i ], [ %.1152.3.1.i.i.i.i, %B374.loopexit.unr-lcssa.unr-lcssa.i.i.i.i ]
  %126 = shl i64 %.1083.0.epil.init6.i.i.i.i, 3
  %scevgep56.epil.i.i.i.i = getelementptr i8, ptr %scevgep50.i2.i.i.i, i64 %126
  %scevgep57.epil.i.i.i.i = getelementptr i8, ptr %scevgep56.epil.i.i.i.i, i64 -24
  %.1206.epil4.i.i.i.i = load double, ptr %scevgep57.epil.i.i.i.i, align 8, !noalias !18
  %sunkaddr81.epil.i.i.i.i = getelementptr i8, ptr %following.2.sroa.52.0775.i.i.i.i, i64 %126
  store double %.1206.epil4.i.i.i.i, ptr %sunkaddr81.epil.i.i.i.i, align 8, !noalias !18
  %scevgep55.epil.i.i.i.i = getelementptr i8, ptr %scevgep56.epil.i.i.i.i, i64 -16
  %.1206.1.epil.i.i.i.i = load double, ptr %scevgep55.epil.i.i.i.i, align 8, !noalias !18
  %sunkaddr84.epil.i.i.i.i = getelementptr i8, ptr %sunkaddr81.epil.i.i.i.i, i64 8
  store double %.1206.1.epil.i.i.i.i, ptr %sunkaddr84.epil.i.i.i.i, align 8, !noalias !18
  %scevgep53.epil.i.i.i.i = getelementptr i8, ptr %scevgep56.epil.i.i.i.i, i64 -8
  %.1206.2.epil.i.i.i.i = load double, ptr %scevgep53.epil.i.i.i.i, align 8, !noalias !18
  %sunkaddr87.epil.i.i.i.i = getelementptr i8, ptr %sunkaddr81.epil.i.i.i.i, i64 16
  store double %.1206.2.epil.i.i.i.i, ptr %sunkaddr87.epil.i.i.i.i, align 8, !noalias !18
  %.1152.3.epil.i.i.i.i = add nuw nsw i64 %.1083.0.epil.init6.i.i.i.i, 4
  %.1206.3.epil.i.i.i.i = load double, ptr %scevgep56.epil.i.i.i.i, align 8, !noalias !18
  %sunkaddr90.epil.i.i.i.i = getelementptr i8, ptr %sunkaddr81.epil.i.i.i.i, i64 24
  store double %.1206.3.epil.i.i.i.i, ptr %sunkaddr90.epil.i.i.i.i, align 8, !noalias !18
  br label %B374.loopexit.unr-lcssa.i.i.i.i

B374.loopexit.unr-lcssa.i.i.i.i:                  ; preds = %B346.if.epil.preheader1.i.i.i.i, %B374.loopexit.unr-lcssa.unr-lcssa.i.i.i.i
  %.1152.3.lcssa.i.i.i.i = phi i64 [ %.1152.3.epil.i.i.i.i, %B346.if.epil.preheader1.i.i.i.i ], [ %.1152.3.1.i.i.i.i, %B374.loopexit.unr-lcssa.unr-lcssa.i.i.i.i ]
  %lcmp.mod.not.i.i.i.i = icmp eq i64 %xtraiter.i.i.i.i, 0
  br i1 %lcmp.mod.not.i.i.i.i, label %B374.i.i.i.i, label %B346.if.epil.preheader.i.i.i.i

B346.if.epil.preheader.i.i.i.i:                   ; preds = %B346.if.preheader.i.i.i.i, %B374.loopexit.unr-lcssa.i.i.i.i
  %.1083.0.epil.init.i.i.i.i = phi i64 [ 0, %B346.if.preheader.i.i.i.i ], [ %.1152.3.lcssa.i.i.i.i, %B374.loopexit.unr-lcssa.i.i.i.i ]
  %127 = shl i64 %.1083.0.epil.init.i.i.i.i, 3
  %scevgep66.i7.i.i.i = getelementptr i8, ptr %following.2.sroa.52.0775.i.i.i.i, i64 %127
  %128 = add i64 %.1083.0.epil.init.i.i.i.i, %.908.sroa.0.3.i.i.i.i
  %129 = shl i64 %128, 3
  %scevgep68.i.i.i.i = getelementptr i8, ptr %.1850.i.i.i, i64 %129
  br label %B346.if.epil.i.i.i.i

B346.if.epil.i.i.i.i:                             ; preds = %B346.if.epil.i.i.i.i, %B346.if.epil.preheader.i.i.i.i
  %epil.iter.i.i.i.i = phi i64 [ %epil.iter.next.i.i.i.i, %B346.if.epil.i.i.i.i ], [ 0, %B346.if.epil.preheader.i.i.i.i ]
  %130 = shl i64 %epil.iter.i.i.i.i, 3
  %scevgep98.i.i.i.i = getelementptr i8, ptr %scevgep68.i.i.i.i, i64 %130
  %.1206.epil.i.i.i.i = load double, ptr %scevgep98.i.i.i.i, align 8, !noalias !18
  %scevgep97.i.i.i.i = getelementptr i8, ptr %scevgep66.i7.i.i.i, i64 %130
  store double %.1206.epil.i.i.i.i, ptr %scevgep97.i.i.i.i, align 8, !noalias !18
  %epil.iter.next.i.i.i.i = add i64 %epil.iter.i.i.i.i, 1
  %epil.iter.cmp.not.i.i.i.i = icmp eq i64 %xtraiter.i.i.i.i, %epil.iter.next.i.i.i.i
  br i1 %epil.iter.cmp.not.i.i.i.i, label %B374.i.i.i.i, label %B346.if.epil.i.i.i.i, !llvm.loop !21

B374.i.i.i.i:                                     ; preds = %B346.if.epil.i.i.i.i, %B212.else.endif.endif.i.i.i.i, %B374.loopexit.unr-lcssa.i.i.i.i
  %.1327765.not.i.i.i.i = icmp slt i64 %.837.i.i.i.i, 1
  br i1 %.1327765.not.i.i.i.i, label %B544.i.i.i.i, label %B404.if.lr.ph.i.i.i.i

B404.if.lr.ph.i.i.i.i:                            ; preds = %B374.i.i.i.i
  %unroll_iter21.i.i.i.i = and i64 %.870.i.i.i.i, 9223372036854775806
  %131 = add nsw i64 %unroll_iter21.i.i.i.i, -2
  %132 = lshr exact i64 %131, 1
  %133 = add nuw i64 %132, 1
  %134 = lshr i64 %133, 1
  %135 = mul nsw i64 %134, -2
  %136 = icmp slt i64 %.870.i.i.i.i, 1
  %137 = icmp eq i64 %.870.i.i.i.i, 1
  %138 = icmp eq i64 %131, 0
  %139 = and i64 %131, 2
  %140 = icmp eq i64 %139, 0
  %141 = and i64 %.870.i.i.i.i, 1
  %142 = icmp eq i64 %141, 0
  br label %B404.if.i.i.i.i

B542.loopexit.unr-lcssa.unr-lcssa.i.i.i.i:        ; preds = %B486.if.i.i.i.i
  br i1 %140, label %B486.if.epil.preheader11.i.i.i.i, label %B542.loopexit.unr-lcssa.i.i.i.i

B486.if.epil.preheader11.i.i.i.i:                 ; preds = %B486.if.preheader29.i.i.i.i, %B542.loopexit.unr-lcssa.unr-lcssa.i.i.i.i
  %.1603.0.epil.init18.i.i.i.i = phi i64 [ 0, %B486.if.preheader29.i.i.i.i ], [ %.1672.1.1.i.i.i.i, %B542.loopexit.unr-lcssa.unr-lcssa.i.i.i.i ]
  %143 = shl i64 %.1603.0.epil.init18.i.i.i.i, 3
  %sunkaddr92.epil.i.i.i.i = getelementptr i8, ptr %following.2.sroa.52.0775.i.i.i.i, i64 %143
  %.1726.epil13.i.i.i.i = load double, ptr %sunkaddr92.epil.i.i.i.i, align 8, !noalias !18
  %scevgep77.epil.i.i.i.i = getelementptr i8, ptr %scevgep75.i.i.i.i, i64 %143
  %scevgep78.epil.i.i.i.i = getelementptr i8, ptr %scevgep77.epil.i.i.i.i, i64 -8
  %.1756.epil14.i.i.i.i = load double, ptr %scevgep78.epil.i.i.i.i, align 8, !noalias !18
  %.1758.epil15.i.i.i.i = fmul contract double %.1575.i.i.i.i, %.1756.epil14.i.i.i.i
  %.1759.epil16.i.i.i.i = fadd contract double %.1726.epil13.i.i.i.i, %.1758.epil15.i.i.i.i
  store double %.1759.epil16.i.i.i.i, ptr %sunkaddr92.epil.i.i.i.i, align 8, !noalias !18
  %.1672.1.epil.i.i.i.i = add nuw i64 %.1603.0.epil.init18.i.i.i.i, 2
  %sunkaddr95.epil.i.i.i.i = getelementptr i8, ptr %sunkaddr92.epil.i.i.i.i, i64 8
  %.1726.1.epil.i.i.i.i = load double, ptr %sunkaddr95.epil.i.i.i.i, align 8, !noalias !18
  %.1756.1.epil.i.i.i.i = load double, ptr %scevgep77.epil.i.i.i.i, align 8, !noalias !18
  %.1758.1.epil.i.i.i.i = fmul contract double %.1575.i.i.i.i, %.1756.1.epil.i.i.i.i
  %.1759.1.epil.i.i.i.i = fadd contract double %.1726.1.epil.i.i.i.i, %.1758.1.epil.i.i.i.i
  store double %.1759.1.epil.i.i.i.i, ptr %sunkaddr95.epil.i.i.i.i, align 8, !noalias !18
  br label %B542.loopexit.unr-lcssa.i.i.i.i

B542.loopexit.unr-lcssa.i.i.i.i:                  ; preds = %B486.if.epil.preheader11.i.i.i.i, %B542.loopexit.unr-lcssa.unr-lcssa.i.i.i.i
  %.1672.1.lcssa.i.i.i.i = phi i64 [ %.1672.1.epil.i.i.i.i, %B486.if.epil.preheader11.i.i.i.i ], [ %.1672.1.1.i.i.i.i, %B542.loopexit.unr-lcssa.unr-lcssa.i.i.i.i ]
  br i1 %142, label %B542.i.i.i.i, label %B486.if.epil.preheader.i.i.i.i

B486.if.epil.preheader.i.i.i.i:                   ; preds = %B486.if.preheader.i.i.i.i, %B542.loopexit.unr-lcssa.i.i.i.i
  %.1603.0.epil.init.i.i.i.i = phi i64 [ 0, %B486.if.preheader.i.i.i.i ], [ %.1672.1.lcssa.i.i.i.i, %B542.loopexit.unr-lcssa.i.i.i.i ]
  %144 = getelementptr double, ptr %following.2.sroa.52.0775.i.i.i.i, i64 %.1603.0.epil.init.i.i.i.i
  %.1726.epil.i.i.i.i = load double, ptr %144, align 8, !noalias !18
  %145 = getelementptr double, ptr %.1508.i.i.i.i, i64 %.1603.0.epil.init.i.i.i.i
  %.1756.epil.i.i.i.i = load double, ptr %145, align 8, !noalias !18
  %.1758.epil.i.i.i.i = fmul contract double %.1575.i.i.i.i, %.1756.epil.i.i.i.i
  %.1759.epil.i.i.i.i = fadd contract double %.1726.epil.i.i.i.i, %.1758.epil.i.i.i.i
  store double %.1759.epil.i.i.i.i, ptr %144, align 8, !noalias !18
  br label %B542.i.i.i.i

B542.i.i.i.i:                                     ; preds = %B406.else.endif.endif.i.i.i.i, %B486.if.epil.preheader.i.i.i.i, %B542.loopexit.unr-lcssa.i.i.i.i
  %exitcond12.not.i.i.i.i = icmp eq i64 %.1340.i.i.i.i, %.837.i.i.i.i
  br i1 %exitcond12.not.i.i.i.i, label %B544.i.i.i.i, label %B404.if.i.i.i.i

B544.i.i.i.i:                                     ; preds = %B542.i.i.i.i, %B374.i.i.i.i
  %.1809.i.i.i.i = icmp sge i64 %.709.0.i.i.i.i, %.680.i.i.i.i
  %.1893768.not.i.i.i.i = icmp slt i64 %.870.i.i.i.i, 1
  %or.cond.i.i.i.i = or i1 %.1809.i.i.i.i, %.1893768.not.i.i.i.i
  br i1 %or.cond.i.i.i.i, label %B664.i.i.i.i, label %B586.if.i.i.i.i

B664.i.i.i.i:                                     ; preds = %B588.endif.i.i.i.i, %B544.i.i.i.i
  %.2052.i.i.i.i = add nsw i64 %.837.i.i.i.i, 1
  %.2056.i.i.i.i = mul nsw i64 %.2052.i.i.i.i, %.870.i.i.i.i
  %.2060.i.i.i.i = add nsw i64 %.2056.i.i.i.i, %at.2.0776.i.i.i.i
  %exitcond14.not.i.i.i.i = icmp eq i64 %.778.i.i.i.i, %.679.i.i.i.i
  br i1 %exitcond14.not.i.i.i.i, label %B696.i.i.i.i, label %B210.if.i.i.i.i

B696.i.i.i.i:                                     ; preds = %B664.i.i.i.i, %B572.endif.else.endif.endif.i.i.i
  %current.2.sroa.40.0.lcssa.i.i.i.i = phi ptr [ %.2026.i.i.i, %B572.endif.else.endif.endif.i.i.i ], [ %following.2.sroa.52.0775.i.i.i.i, %B664.i.i.i.i ]
  br i1 %.1056673.not.i.i.i, label %_ZN17bnserve_surrogate6kernel11_regression7regressB2v9B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dEddddd5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i.i, label %B748.if.preheader.i.i.i.i

B748.if.preheader.i.i.i.i:                        ; preds = %B696.i.i.i.i
  %xtraiter23.i.i.i.i = and i64 %.340.sroa.13.2.i.i, 3
  %146 = icmp samesign ult i64 %.340.sroa.13.2.i.i, 4
  br i1 %146, label %B748.if.epil.preheader.i.i.i.i, label %B748.if.preheader.new.i.i.i.i

B748.if.preheader.new.i.i.i.i:                    ; preds = %B748.if.preheader.i.i.i.i
  %unroll_iter27.i.i.i.i = and i64 %.340.sroa.13.2.i.i, 9223372036854775804
  br label %B748.if.i.i.i.i

B798.loopexit.unr-lcssa.i.i.i.i:                  ; preds = %B748.if.i.i.i.i
  %lcmp.mod25.not.i.i.i.i = icmp eq i64 %xtraiter23.i.i.i.i, 0
  br i1 %lcmp.mod25.not.i.i.i.i, label %_ZN17bnserve_surrogate6kernel11_regression7regressB2v9B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dEddddd5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i.i, label %B748.if.epil.preheader.i.i.i.i

B748.if.epil.preheader.i.i.i.i:                   ; preds = %B798.loopexit.unr-lcssa.i.i.i.i, %B748.if.preheader.i.i.i.i
  %.2219781783.epil.init.i.i.i.i = phi i64 [ 0, %B748.if.preheader.i.i.i.i ], [ %.2226.3.i.i.i.i, %B798.loopexit.unr-lcssa.i.i.i.i ]
  %147 = shl i64 %.2219781783.epil.init.i.i.i.i, 3
  %scevgep.i.i.i.i = getelementptr i8, ptr %current.2.sroa.40.0.lcssa.i.i.i.i, i64 %147
  %scevgep31.i.i.i.i = getelementptr i8, ptr %.1362.i, i64 %147
  br label %B748.if.epil.i.i.i.i

B748.if.epil.i.i.i.i:                             ; preds = %B748.if.epil.i.i.i.i, %B748.if.epil.preheader.i.i.i.i
  %epil.iter24.i.i.i.i = phi i64 [ %epil.iter24.next.i.i.i.i, %B748.if.epil.i.i.i.i ], [ 0, %B748.if.epil.preheader.i.i.i.i ]
  %148 = shl i64 %epil.iter24.i.i.i.i, 3
  %scevgep34.i.i.i.i = getelementptr i8, ptr %scevgep31.i.i.i.i, i64 %148
  %.2280.epil.i.i.i.i = load double, ptr %scevgep34.i.i.i.i, align 8, !noalias !18
  %scevgep33.i.i.i.i = getelementptr i8, ptr %scevgep.i.i.i.i, i64 %148
  %.2310.epil.i.i.i.i = load double, ptr %scevgep33.i.i.i.i, align 8, !noalias !18
  %.2311.epil.i.i.i.i = fadd contract double %.2280.epil.i.i.i.i, %.2310.epil.i.i.i.i
  store double %.2311.epil.i.i.i.i, ptr %scevgep34.i.i.i.i, align 8, !noalias !18
  %epil.iter24.next.i.i.i.i = add i64 %epil.iter24.i.i.i.i, 1
  %epil.iter24.cmp.not.i.i.i.i = icmp eq i64 %xtraiter23.i.i.i.i, %epil.iter24.next.i.i.i.i
  br i1 %epil.iter24.cmp.not.i.i.i.i, label %_ZN17bnserve_surrogate6kernel11_regression7regressB2v9B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dEddddd5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i.i, label %B748.if.epil.i.i.i.i, !llvm.loop !23

B210.if.i.i.i.i:                                  ; preds = %B664.i.i.i.i, %B210.if.lr.ph.i.i.i.i
  %.709.0.i.i.i.i = phi i64 [ 0, %B210.if.lr.ph.i.i.i.i ], [ %.778.i.i.i.i, %B664.i.i.i.i ]
  %at.2.0776.i.i.i.i = phi i64 [ 0, %B210.if.lr.ph.i.i.i.i ], [ %.2060.i.i.i.i, %B664.i.i.i.i ]
  %following.2.sroa.52.0775.i.i.i.i = phi ptr [ %.387.i.i.i.i, %B210.if.lr.ph.i.i.i.i ], [ %current.2.sroa.40.0773.i.i.i.i, %B664.i.i.i.i ]
  %current.2.sroa.40.0773.i.i.i.i = phi ptr [ %.2026.i.i.i, %B210.if.lr.ph.i.i.i.i ], [ %following.2.sroa.52.0775.i.i.i.i, %B664.i.i.i.i ]
  %.778.i.i.i.i = add nuw nsw i64 %.709.0.i.i.i.i, 1
  %149 = getelementptr i64, ptr %arg.contents, i64 %.709.0.i.i.i.i
  %150 = getelementptr i8, ptr %149, i64 120
  %.837.i.i.i.i = load i64, ptr %150, align 8, !noalias !18
  %151 = getelementptr i8, ptr %149, i64 128
  %.870.i.i.i.i = load i64, ptr %151, align 8, !noalias !18
  %.879.i.i.i.i = mul nsw i64 %.870.i.i.i.i, %.837.i.i.i.i
  %.881.i.i.i.i = add nsw i64 %.879.i.i.i.i, %at.2.0776.i.i.i.i
  %.918.i.i.i.i = icmp slt i64 %.881.i.i.i.i, 0
  %.919.i.i.i.i = select i1 %.918.i.i.i.i, i64 %.1834.i.i.i, i64 0
  %.920.i.i.i.i = add i64 %.919.i.i.i.i, %.881.i.i.i.i
  %.923.i.i.i.i = icmp slt i64 %.920.i.i.i.i, 0
  br i1 %.923.i.i.i.i, label %B212.else.if.i.i.i.i, label %B212.else.endif.i.i.i.i, !prof !4

B212.else.if.i.i.i.i:                             ; preds = %B210.if.i.i.i.i
  br label %B212.else.endif.i.i.i.i

B212.else.endif.i.i.i.i:                          ; preds = %B212.else.if.i.i.i.i, %B210.if.i.i.i.i
  %.908.sroa.0.1.i.i.i.i = phi i64 [ 0, %B212.else.if.i.i.i.i ], [ %.920.i.i.i.i, %B210.if.i.i.i.i ]
  %.928.not.i.i.i.i = icmp slt i64 %.920.i.i.i.i, %.1834.i.i.i
  br i1 %.928.not.i.i.i.i, label %B212.else.endif.endif.i.i.i.i, label %B212.else.endif.if.i.i.i.i, !prof !5

B212.else.endif.if.i.i.i.i:                       ; preds = %B212.else.endif.i.i.i.i
  br label %B212.else.endif.endif.i.i.i.i

B212.else.endif.endif.i.i.i.i:                    ; preds = %B212.else.endif.if.i.i.i.i, %B212.else.endif.i.i.i.i
  %.908.sroa.0.3.i.i.i.i = phi i64 [ %.1834.i.i.i, %B212.else.endif.if.i.i.i.i ], [ %.908.sroa.0.1.i.i.i.i, %B212.else.endif.i.i.i.i ]
  %.1097.i.i.i.i = icmp sgt i64 %.870.i.i.i.i, 0
  br i1 %.1097.i.i.i.i, label %B346.if.preheader.i.i.i.i, label %B374.i.i.i.i

B346.if.preheader.i.i.i.i:                        ; preds = %B212.else.endif.endif.i.i.i.i
  %xtraiter.i.i.i.i = and i64 %.870.i.i.i.i, 3
  %152 = icmp ult i64 %.870.i.i.i.i, 4
  br i1 %152, label %B346.if.epil.preheader.i.i.i.i, label %B346.if.preheader.new.i.i.i.i

B346.if.preheader.new.i.i.i.i:                    ; preds = %B346.if.preheader.i.i.i.i
  %153 = shl i64 %.908.sroa.0.3.i.i.i.i, 3
  %scevgep50.i2.i.i.i = getelementptr i8, ptr %scevgep49.i1.i.i.i, i64 %153
  %154 = add nsw i64 %.870.i.i.i.i, -4
  %155 = lshr i64 %154, 2
  %156 = icmp eq i64 %155, 0
  br i1 %156, label %B346.if.epil.preheader1.i.i.i.i, label %B346.if.preheader.new.new.i.i.i.i

B346.if.preheader.new.new.i.i.i.i:                ; preds = %B346.if.preheader.new.i.i.i.i
  %157 = add nuw nsw i64 %155, 1
  %scevgep58.i.i.i.i = getelementptr i8, ptr %scevgep54.i.i.i.i, i64 %153
  %158 = lshr i64 %157, 1
  %159 = mul nsw i64 %158, -2
  br label %B346.if.i.i.i.i

B346.if.i.i.i.i:                                  ; preds = %B346.if.i.i.i.i, %B346.if.preheader.new.new.i.i.i.i
  %lsr.iv.i3.i.i.i = phi i64 [ %lsr.iv.next.i5.i.i.i, %B346.if.i.i.i.i ], [ %159, %B346.if.preheader.new.new.i.i.i.i ]
  %.1083.0.i.i.i.i = phi i64 [ %.1152.3.1.i.i.i.i, %B346.if.i.i.i.i ], [ 0, %B346.if.preheader.new.new.i.i.i.i ]
  %160 = shl i64 %.1083.0.i.i.i.i, 3
  %scevgep65.i4.i.i.i = getelementptr i8, ptr %scevgep58.i.i.i.i, i64 %160
  %scevgep70.i.i.i.i = getelementptr i8, ptr %scevgep65.i4.i.i.i, i64 -32
  %scevgep80.i.i.i.i = getelementptr i8, ptr %scevgep65.i4.i.i.i, i64 -56
  %.1206.i.i.i.i = load double, ptr %scevgep80.i.i.i.i, align 8, !noalias !18
  %sunkaddr71.i.i.i.i = getelementptr i8, ptr %following.2.sroa.52.0775.i.i.i.i, i64 %160
  store double %.1206.i.i.i.i, ptr %sunkaddr71.i.i.i.i, align 8, !noalias !18
  %scevgep48.i.i.i.i = getelementptr i8, ptr %scevgep65.i4.i.i.i, i64 -48
  %.1206.1.i.i.i.i = load double, ptr %scevgep48.i.i.i.i, align 8, !noalias !18
  %sunkaddr74.i.i.i.i = getelementptr i8, ptr %sunkaddr71.i.i.i.i, i64 8
  store double %.1206.1.i.i.i.i, ptr %sunkaddr74.i.i.i.i, align 8, !noalias !18
  %scevgep45.i.i.i.i = getelementptr i8, ptr %scevgep65.i4.i.i.i, i64 -40
  %.1206.2.i.i.i.i = load double, ptr %scevgep45.i.i.i.i, align 8, !noalias !18
  %sunkaddr77.i.i.i.i = getelementptr i8, ptr %sunkaddr71.i.i.i.i, i64 16
  store double %.1206.2.i.i.i.i, ptr %sunkaddr77.i.i.i.i, align 8, !noalias !18
  %.1206.3.i.i.i.i = load double, ptr %scevgep70.i.i.i.i, align 8, !noalias !18
  %sunkaddr80.i.i.i.i = getelementptr i8, ptr %sunkaddr71.i.i.i.i, i64 24
  store double %.1206.3.i.i.i.i, ptr %sunkaddr80.i.i.i.i, align 8, !noalias !18
  %scevgep42.i.i.i.i = getelementptr i8, ptr %scevgep65.i4.i.i.i, i64 -24
  %.1206.110.i.i.i.i = load double, ptr %scevgep42.i.i.i.i, align 8, !noalias !18
  %sunkaddr83.i.i.i.i = getelementptr i8, ptr %sunkaddr71.i.i.i.i, i64 32
  store double %.1206.110.i.i.i.i, ptr %sunkaddr83.i.i.i.i, align 8, !noalias !18
  %scevgep40.i.i.i.i = getelementptr i8, ptr %scevgep65.i4.i.i.i, i64 -16
  %.1206.1.1.i.i.i.i = load double, ptr %scevgep40.i.i.i.i, align 8, !noalias !18
  %sunkaddr86.i.i.i.i = getelementptr i8, ptr %sunkaddr71.i.i.i.i, i64 40
  store double %.1206.1.1.i.i.i.i, ptr %sunkaddr86.i.i.i.i, align 8, !noalias !18
  %scevgep38.i.i.i.i = getelementptr i8, ptr %scevgep65.i4.i.i.i, i64 -8
  %.1206.2.1.i.i.i.i = load double, ptr %scevgep38.i.i.i.i, align 8, !noalias !18
  %sunkaddr89.i.i.i.i = getelementptr i8, ptr %sunkaddr71.i.i.i.i, i64 48
  store double %.1206.2.1.i.i.i.i, ptr %sunkaddr89.i.i.i.i, align 8, !noalias !18
  %.1152.3.1.i.i.i.i = add i64 %.1083.0.i.i.i.i, 8
  %.1206.3.1.i.i.i.i = load double, ptr %scevgep65.i4.i.i.i, align 8, !noalias !18
  %sunkaddr90.i.i.i.i = shl i64 %.1152.3.1.i.i.i.i, 3
  %sunkaddr91.i.i.i.i = getelementptr i8, ptr %following.2.sroa.52.0775.i.i.i.i, i64 %sunkaddr90.i.i.i.i
  %sunkaddr92.i.i.i.i = getelementptr i8, ptr %sunkaddr91.i.i.i.i, i64 -8
  store double %.1206.3.1.i.i.i.i, ptr %sunkaddr92.i.i.i.i, align 8, !noalias !18
  %lsr.iv.next.i5.i.i.i = add i64 %lsr.iv.i3.i.i.i, 2
  %niter.ncmp.1.i6.i.i.i = icmp eq i64 %lsr.iv.next.i5.i.i.i, 0
  br i1 %niter.ncmp.1.i6.i.i.i, label %B374.loopexit.unr-lcssa.unr-lcssa.i.i.i.i, label %B346.if.i.i.i.i

B404.if.i.i.i.i:                                  ; preds = %B542.i.i.i.i, %B404.if.lr.ph.i.i.i.i
  %.1271.0.i.i.i.i = phi i64 [ 0, %B404.if.lr.ph.i.i.i.i ], [ %.1340.i.i.i.i, %B542.i.i.i.i ]
  %.1340.i.i.i.i = add nuw nsw i64 %.1271.0.i.i.i.i, 1
  %.1366.i.i.i.i = mul nsw i64 %.1271.0.i.i.i.i, %.870.i.i.i.i
  %.1368.i.i.i.i = add nsw i64 %.1366.i.i.i.i, %at.2.0776.i.i.i.i
  %.1405.i.i.i.i = icmp slt i64 %.1368.i.i.i.i, 0
  %.1406.i.i.i.i = select i1 %.1405.i.i.i.i, i64 %.1834.i.i.i, i64 0
  %.1407.i.i.i.i = add i64 %.1406.i.i.i.i, %.1368.i.i.i.i
  %.1410.i.i.i.i = icmp slt i64 %.1407.i.i.i.i, 0
  br i1 %.1410.i.i.i.i, label %B406.else.if.i.i.i.i, label %B406.else.endif.i.i.i.i, !prof !4

B406.else.if.i.i.i.i:                             ; preds = %B404.if.i.i.i.i
  br label %B406.else.endif.i.i.i.i

B406.else.endif.i.i.i.i:                          ; preds = %B406.else.if.i.i.i.i, %B404.if.i.i.i.i
  %.1395.sroa.0.1.i.i.i.i = phi i64 [ 0, %B406.else.if.i.i.i.i ], [ %.1407.i.i.i.i, %B404.if.i.i.i.i ]
  %.1415.not.i.i.i.i = icmp slt i64 %.1407.i.i.i.i, %.1834.i.i.i
  br i1 %.1415.not.i.i.i.i, label %B406.else.endif.endif.i.i.i.i, label %B406.else.endif.if.i.i.i.i, !prof !5

B406.else.endif.if.i.i.i.i:                       ; preds = %B406.else.endif.i.i.i.i
  br label %B406.else.endif.endif.i.i.i.i

B406.else.endif.endif.i.i.i.i:                    ; preds = %B406.else.endif.if.i.i.i.i, %B406.else.endif.i.i.i.i
  %.1395.sroa.0.3.i.i.i.i = phi i64 [ %.1834.i.i.i, %B406.else.endif.if.i.i.i.i ], [ %.1395.sroa.0.1.i.i.i.i, %B406.else.endif.i.i.i.i ]
  %.1508.i.i.i.i = getelementptr double, ptr %.1850.i.i.i, i64 %.1395.sroa.0.3.i.i.i.i
  %161 = getelementptr double, ptr %current.2.sroa.40.0773.i.i.i.i, i64 %.1271.0.i.i.i.i
  %.1575.i.i.i.i = load double, ptr %161, align 8, !noalias !18
  br i1 %136, label %B542.i.i.i.i, label %B486.if.preheader.i.i.i.i

B486.if.preheader.i.i.i.i:                        ; preds = %B406.else.endif.endif.i.i.i.i
  br i1 %137, label %B486.if.epil.preheader.i.i.i.i, label %B486.if.preheader29.i.i.i.i

B486.if.preheader29.i.i.i.i:                      ; preds = %B486.if.preheader.i.i.i.i
  %162 = shl i64 %.1395.sroa.0.3.i.i.i.i, 3
  %scevgep75.i.i.i.i = getelementptr i8, ptr %scevgep74.i.i.i.i, i64 %162
  br i1 %138, label %B486.if.epil.preheader11.i.i.i.i, label %B486.if.preheader30.i.i.i.i

B486.if.preheader30.i.i.i.i:                      ; preds = %B486.if.preheader29.i.i.i.i
  %scevgep108.i.i.i.i = getelementptr i8, ptr %scevgep49.i1.i.i.i, i64 %162
  br label %B486.if.i.i.i.i

B486.if.i.i.i.i:                                  ; preds = %B486.if.i.i.i.i, %B486.if.preheader30.i.i.i.i
  %lsr.iv49.i.i.i.i = phi i64 [ %lsr.iv.next50.i.i.i.i, %B486.if.i.i.i.i ], [ %135, %B486.if.preheader30.i.i.i.i ]
  %.1603.0.i.i.i.i = phi i64 [ %.1672.1.1.i.i.i.i, %B486.if.i.i.i.i ], [ 0, %B486.if.preheader30.i.i.i.i ]
  %163 = shl i64 %.1603.0.i.i.i.i, 3
  %sunkaddr94.i.i.i.i = getelementptr i8, ptr %following.2.sroa.52.0775.i.i.i.i, i64 %163
  %.1726.i.i.i.i = load double, ptr %sunkaddr94.i.i.i.i, align 8, !noalias !18
  %scevgep111.i.i.i.i = getelementptr i8, ptr %scevgep108.i.i.i.i, i64 %163
  %scevgep69.i.i.i.i = getelementptr i8, ptr %scevgep111.i.i.i.i, i64 -16
  %scevgep64.i.i.i.i = getelementptr i8, ptr %scevgep111.i.i.i.i, i64 -24
  %.1756.i.i.i.i = load double, ptr %scevgep64.i.i.i.i, align 8, !noalias !18
  %.1758.i.i.i.i = fmul contract double %.1575.i.i.i.i, %.1756.i.i.i.i
  %.1759.i.i.i.i = fadd contract double %.1726.i.i.i.i, %.1758.i.i.i.i
  store double %.1759.i.i.i.i, ptr %sunkaddr94.i.i.i.i, align 8, !noalias !18
  %sunkaddr97.i.i.i.i = getelementptr i8, ptr %sunkaddr94.i.i.i.i, i64 8
  %.1726.1.i.i.i.i = load double, ptr %sunkaddr97.i.i.i.i, align 8, !noalias !18
  %.1756.1.i.i.i.i = load double, ptr %scevgep69.i.i.i.i, align 8, !noalias !18
  %.1758.1.i.i.i.i = fmul contract double %.1575.i.i.i.i, %.1756.1.i.i.i.i
  %.1759.1.i.i.i.i = fadd contract double %.1726.1.i.i.i.i, %.1758.1.i.i.i.i
  store double %.1759.1.i.i.i.i, ptr %sunkaddr97.i.i.i.i, align 8, !noalias !18
  %sunkaddr100.i.i.i.i = getelementptr i8, ptr %sunkaddr94.i.i.i.i, i64 16
  %.1726.124.i.i.i.i = load double, ptr %sunkaddr100.i.i.i.i, align 8, !noalias !18
  %scevgep62.i.i.i.i = getelementptr i8, ptr %scevgep111.i.i.i.i, i64 -8
  %.1756.125.i.i.i.i = load double, ptr %scevgep62.i.i.i.i, align 8, !noalias !18
  %.1758.126.i.i.i.i = fmul contract double %.1575.i.i.i.i, %.1756.125.i.i.i.i
  %.1759.127.i.i.i.i = fadd contract double %.1726.124.i.i.i.i, %.1758.126.i.i.i.i
  store double %.1759.127.i.i.i.i, ptr %sunkaddr100.i.i.i.i, align 8, !noalias !18
  %.1672.1.1.i.i.i.i = add i64 %.1603.0.i.i.i.i, 4
  %sunkaddr101.i.i.i.i = shl i64 %.1672.1.1.i.i.i.i, 3
  %sunkaddr102.i.i.i.i = getelementptr i8, ptr %following.2.sroa.52.0775.i.i.i.i, i64 %sunkaddr101.i.i.i.i
  %sunkaddr103.i.i.i.i = getelementptr i8, ptr %sunkaddr102.i.i.i.i, i64 -8
  %.1726.1.1.i.i.i.i = load double, ptr %sunkaddr103.i.i.i.i, align 8, !noalias !18
  %.1756.1.1.i.i.i.i = load double, ptr %scevgep111.i.i.i.i, align 8, !noalias !18
  %.1758.1.1.i.i.i.i = fmul contract double %.1575.i.i.i.i, %.1756.1.1.i.i.i.i
  %.1759.1.1.i.i.i.i = fadd contract double %.1726.1.1.i.i.i.i, %.1758.1.1.i.i.i.i
  store double %.1759.1.1.i.i.i.i, ptr %sunkaddr103.i.i.i.i, align 8, !noalias !18
  %lsr.iv.next50.i.i.i.i = add i64 %lsr.iv49.i.i.i.i, 2
  %niter23.ncmp.1.i.i.i.i = icmp eq i64 %lsr.iv.next50.i.i.i.i, 0
  br i1 %niter23.ncmp.1.i.i.i.i, label %B542.loopexit.unr-lcssa.unr-lcssa.i.i.i.i, label %B486.if.i.i.i.i

B586.if.i.i.i.i:                                  ; preds = %B544.i.i.i.i, %B588.endif.i.i.i.i
  %.1837.0.i.i.i.i = phi i64 [ %.1906.i.i.i.i, %B588.endif.i.i.i.i ], [ 0, %B544.i.i.i.i ]
  %164 = shl i64 %.1837.0.i.i.i.i, 3
  %scevgep79.i.i.i.i = getelementptr i8, ptr %following.2.sroa.52.0775.i.i.i.i, i64 %164
  %.1961.i.i.i.i = load double, ptr %scevgep79.i.i.i.i, align 8, !noalias !18
  %.1991.i.i.i.i = load i64, ptr %sunkaddr104.i.i.i.i, align 8, !noalias !18
  switch i64 %.1991.i.i.i.i, label %B120.i.i.i.i.i [
    i64 0, label %for.cond.preheader.i.i.i.i.i
    i64 1, label %B88.i.i.i.i.i
  ]

for.cond.preheader.i.i.i.i.i:                     ; preds = %B586.if.i.i.i.i
  %.23.i.i.i.i.i = tail call contract double @tanh(double %.1961.i.i.i.i)
  br label %B588.endif.i.i.i.i

B88.i.i.i.i.i:                                    ; preds = %B586.if.i.i.i.i
  %.12.i.i.i.i.i.i = fcmp contract olt double %.1961.i.i.i.i, 0.000000e+00
  %.13.i.i.i.i.i.i = select i1 %.12.i.i.i.i.i.i, double 0.000000e+00, double %.1961.i.i.i.i
  br label %B588.endif.i.i.i.i

B120.i.i.i.i.i:                                   ; preds = %B586.if.i.i.i.i
  %.73.i.i.i.i.i = fneg contract double %.1961.i.i.i.i
  %.83.le.i.i.i.i.i = tail call contract double @llvm.exp.f64(double %.73.i.i.i.i.i)
  %.88.i.i.i.i.i = fadd contract double %.83.le.i.i.i.i.i, 1.000000e+00
  %.92.i.i.i.i.i = fdiv contract double 1.000000e+00, %.88.i.i.i.i.i
  br label %B588.endif.i.i.i.i

B588.endif.i.i.i.i:                               ; preds = %B120.i.i.i.i.i, %B88.i.i.i.i.i, %for.cond.preheader.i.i.i.i.i
  %.92.sink.i.i.i.i.i = phi double [ %.92.i.i.i.i.i, %B120.i.i.i.i.i ], [ %.13.i.i.i.i.i.i, %B88.i.i.i.i.i ], [ %.23.i.i.i.i.i, %for.cond.preheader.i.i.i.i.i ]
  %.1906.i.i.i.i = add nuw nsw i64 %.1837.0.i.i.i.i, 1
  store double %.92.sink.i.i.i.i.i, ptr %scevgep79.i.i.i.i, align 8, !noalias !18
  %exitcond13.not.i.i.i.i = icmp eq i64 %.870.i.i.i.i, %.1906.i.i.i.i
  br i1 %exitcond13.not.i.i.i.i, label %B664.i.i.i.i, label %B586.if.i.i.i.i

B748.if.i.i.i.i:                                  ; preds = %B748.if.i.i.i.i, %B748.if.preheader.new.i.i.i.i
  %.2219781783.i.i.i.i = phi i64 [ 0, %B748.if.preheader.new.i.i.i.i ], [ %.2226.3.i.i.i.i, %B748.if.i.i.i.i ]
  %sunkaddr107.i.i.i.i = shl i64 %.2219781783.i.i.i.i, 3
  %sunkaddr108.i.i.i.i = getelementptr i8, ptr %.1362.i, i64 %sunkaddr107.i.i.i.i
  %.2280.i.i.i.i = load double, ptr %sunkaddr108.i.i.i.i, align 8, !noalias !18
  %sunkaddr110.i.i.i.i = getelementptr i8, ptr %current.2.sroa.40.0.lcssa.i.i.i.i, i64 %sunkaddr107.i.i.i.i
  %.2310.i.i.i.i = load double, ptr %sunkaddr110.i.i.i.i, align 8, !noalias !18
  %.2311.i.i.i.i = fadd contract double %.2280.i.i.i.i, %.2310.i.i.i.i
  store double %.2311.i.i.i.i, ptr %sunkaddr108.i.i.i.i, align 8, !noalias !18
  %sunkaddr113.i.i.i.i = getelementptr i8, ptr %sunkaddr108.i.i.i.i, i64 8
  %.2280.1.i.i.i.i = load double, ptr %sunkaddr113.i.i.i.i, align 8, !noalias !18
  %sunkaddr116.i.i.i.i = getelementptr i8, ptr %sunkaddr110.i.i.i.i, i64 8
  %.2310.1.i.i.i.i = load double, ptr %sunkaddr116.i.i.i.i, align 8, !noalias !18
  %.2311.1.i.i.i.i = fadd contract double %.2280.1.i.i.i.i, %.2310.1.i.i.i.i
  store double %.2311.1.i.i.i.i, ptr %sunkaddr113.i.i.i.i, align 8, !noalias !18
  %sunkaddr119.i.i.i.i = getelementptr i8, ptr %sunkaddr108.i.i.i.i, i64 16
  %.2280.2.i.i.i.i = load double, ptr %sunkaddr119.i.i.i.i, align 8, !noalias !18
  %sunkaddr122.i.i.i.i = getelementptr i8, ptr %sunkaddr110.i.i.i.i, i64 16
  %.2310.2.i.i.i.i = load double, ptr %sunkaddr122.i.i.i.i, align 8, !noalias !18
  %.2311.2.i.i.i.i = fadd contract double %.2280.2.i.i.i.i, %.2310.2.i.i.i.i
  store double %.2311.2.i.i.i.i, ptr %sunkaddr119.i.i.i.i, align 8, !noalias !18
  %.2226.3.i.i.i.i = add nuw nsw i64 %.2219781783.i.i.i.i, 4
  %sunkaddr125.i.i.i.i = getelementptr i8, ptr %sunkaddr108.i.i.i.i, i64 24
  %.2280.3.i.i.i.i = load double, ptr %sunkaddr125.i.i.i.i, align 8, !noalias !18
  %sunkaddr128.i.i.i.i = getelementptr i8, ptr %sunkaddr110.i.i.i.i, i64 24
  %.2310.3.i.i.i.i = load double, ptr %sunkaddr128.i.i.i.i, align 8, !noalias !18
  %.2311.3.i.i.i.i = fadd contract double %.2280.3.i.i.i.i, %.2310.3.i.i.i.i
  store double %.2311.3.i.i.i.i, ptr %sunkaddr125.i.i.i.i, align 8, !noalias !18
  %niter28.ncmp.3.i.i.i.i = icmp eq i64 %unroll_iter27.i.i.i.i, %.2226.3.i.i.i.i
  br i1 %niter28.ncmp.3.i.i.i.i, label %B798.loopexit.unr-lcssa.i.i.i.i, label %B748.if.i.i.i.i

_ZN17bnserve_surrogate6kernel11_regression7regressB2v9B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dEddddd5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i.i: ; preds = %B748.if.epil.i.i.i.i, %B798.loopexit.unr-lcssa.i.i.i.i, %B696.i.i.i.i, %B538.i.i.i
  %.759.i.i = load i64, ptr %.758.i.i, align 8, !noalias !6
  %.798.i.i = icmp slt i64 %.759.i.i, 0
  %.799.i.i = select i1 %.798.i.i, i64 %arg.n_weights, i64 0
  %.800.i.i = add i64 %.799.i.i, %.759.i.i
  %.803.i.i = icmp slt i64 %.800.i.i, 0
  br i1 %.803.i.i, label %B0.endif.endif.endif.else.if.i.i, label %B0.endif.endif.endif.else.endif.i.i, !prof !4

B0.endif.endif.endif.else.if.i.i:                 ; preds = %_ZN17bnserve_surrogate6kernel11_regression7regressB2v9B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dEddddd5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i.i
  br label %B0.endif.endif.endif.else.endif.i.i

B0.endif.endif.endif.else.endif.i.i:              ; preds = %B0.endif.endif.endif.else.if.i.i, %_ZN17bnserve_surrogate6kernel11_regression7regressB2v9B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dEddddd5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i.i
  %.788.sroa.0.1.i.i = phi i64 [ 0, %B0.endif.endif.endif.else.if.i.i ], [ %.800.i.i, %_ZN17bnserve_surrogate6kernel11_regression7regressB2v9B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dEddddd5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i.i ]
  %.808.not.i.i = icmp slt i64 %.800.i.i, %arg.n_weights
  br i1 %.808.not.i.i, label %B0.endif.endif.endif.else.endif.endif.i.i, label %B0.endif.endif.endif.else.endif.if.i.i, !prof !5

B0.endif.endif.endif.else.endif.if.i.i:           ; preds = %B0.endif.endif.endif.else.endif.i.i
  br label %B0.endif.endif.endif.else.endif.endif.i.i

B0.endif.endif.endif.else.endif.endif.i.i:        ; preds = %B0.endif.endif.endif.else.endif.if.i.i, %B0.endif.endif.endif.else.endif.i.i
  %.788.sroa.0.3.i.i = phi i64 [ %arg.n_weights, %B0.endif.endif.endif.else.endif.if.i.i ], [ %.788.sroa.0.1.i.i, %B0.endif.endif.endif.else.endif.i.i ]
  %.876.i.i = sub i64 %arg.n_weights, %.788.sroa.0.3.i.i
  %.885.i.i = tail call i64 @llvm.smax.i64(i64 %.876.i.i, i64 0)
  %.901.i.i = getelementptr double, ptr %arg.weights, i64 %.788.sroa.0.3.i.i
  br i1 %.98.i.not.i.i, label %B88.i.i.i, label %B60.if.preheader.i.i.i

B60.if.preheader.i.i.i:                           ; preds = %B0.endif.endif.endif.else.endif.endif.i.i
  br i1 %38, label %B60.if.epil.preheader.i.i.i, label %B60.if.preheader.new.i.i.i

B60.if.preheader.new.i.i.i:                       ; preds = %B60.if.preheader.i.i.i
  br i1 %41, label %B60.if.i.epil.preheader.i.i, label %B60.if.preheader.new.i.new.i.i

B60.if.preheader.new.i.new.i.i:                   ; preds = %B60.if.preheader.new.i.i.i
  %165 = shl i64 %.788.sroa.0.3.i.i, 3
  %166 = getelementptr i8, ptr %arg.weights, i64 %165
  %scevgep28.i.i = getelementptr i8, ptr %166, i64 56
  br label %B60.if.i.i.i

B88.loopexit.unr-lcssa.i.unr-lcssa.i.i:           ; preds = %B60.if.i.i.i
  br i1 %lcmp.mod.not.not.i.i, label %B60.if.i.epil.preheader.i.i, label %B88.loopexit.unr-lcssa.i.i.i

B60.if.i.epil.preheader.i.i:                      ; preds = %B88.loopexit.unr-lcssa.i.unr-lcssa.i.i, %B60.if.preheader.new.i.i.i
  %.148276278.i.epil.init.i.i = phi i64 [ 0, %B60.if.preheader.new.i.i.i ], [ %.155.3.i.1.i.i, %B88.loopexit.unr-lcssa.i.unr-lcssa.i.i ]
  %sunkaddr.i.epil.i.i = shl i64 %.148276278.i.epil.init.i.i, 3
  %sunkaddr38.i.epil.i.i = getelementptr i8, ptr %.901.i.i, i64 %sunkaddr.i.epil.i.i
  %.209.i.epil.i.i = load double, ptr %sunkaddr38.i.epil.i.i, align 8, !noalias !24
  %sunkaddr40.i.epil.i.i = getelementptr i8, ptr %.621.i, i64 %sunkaddr.i.epil.i.i
  store double %.209.i.epil.i.i, ptr %sunkaddr40.i.epil.i.i, align 8, !noalias !24
  %sunkaddr43.i.epil.i.i = getelementptr i8, ptr %sunkaddr38.i.epil.i.i, i64 8
  %.209.1.i.epil.i.i = load double, ptr %sunkaddr43.i.epil.i.i, align 8, !noalias !24
  %sunkaddr46.i.epil.i.i = getelementptr i8, ptr %sunkaddr40.i.epil.i.i, i64 8
  store double %.209.1.i.epil.i.i, ptr %sunkaddr46.i.epil.i.i, align 8, !noalias !24
  %sunkaddr49.i.epil.i.i = getelementptr i8, ptr %sunkaddr38.i.epil.i.i, i64 16
  %.209.2.i.epil.i.i = load double, ptr %sunkaddr49.i.epil.i.i, align 8, !noalias !24
  %sunkaddr52.i.epil.i.i = getelementptr i8, ptr %sunkaddr40.i.epil.i.i, i64 16
  store double %.209.2.i.epil.i.i, ptr %sunkaddr52.i.epil.i.i, align 8, !noalias !24
  %.155.3.i.epil.i.i = add nuw nsw i64 %.148276278.i.epil.init.i.i, 4
  %sunkaddr55.i.epil.i.i = getelementptr i8, ptr %sunkaddr38.i.epil.i.i, i64 24
  %.209.3.i.epil.i.i = load double, ptr %sunkaddr55.i.epil.i.i, align 8, !noalias !24
  %sunkaddr58.i.epil.i.i = getelementptr i8, ptr %sunkaddr40.i.epil.i.i, i64 24
  store double %.209.3.i.epil.i.i, ptr %sunkaddr58.i.epil.i.i, align 8, !noalias !24
  br label %B88.loopexit.unr-lcssa.i.i.i

B88.loopexit.unr-lcssa.i.i.i:                     ; preds = %B60.if.i.epil.preheader.i.i, %B88.loopexit.unr-lcssa.i.unr-lcssa.i.i
  %.155.3.i.lcssa.i.i = phi i64 [ %.155.3.i.epil.i.i, %B60.if.i.epil.preheader.i.i ], [ %.155.3.i.1.i.i, %B88.loopexit.unr-lcssa.i.unr-lcssa.i.i ]
  br i1 %lcmp.mod.not.i.i.i, label %B88.i.i.i, label %B60.if.epil.preheader.i.i.i

B60.if.epil.preheader.i.i.i:                      ; preds = %B88.loopexit.unr-lcssa.i.i.i, %B60.if.preheader.i.i.i
  %.148276278.epil.init.i.i.i = phi i64 [ 0, %B60.if.preheader.i.i.i ], [ %.155.3.i.lcssa.i.i, %B88.loopexit.unr-lcssa.i.i.i ]
  %167 = shl i64 %.148276278.epil.init.i.i.i, 3
  %scevgep17.i.i.i = getelementptr i8, ptr %.621.i, i64 %167
  %168 = add i64 %.148276278.epil.init.i.i.i, %.788.sroa.0.3.i.i
  %169 = shl i64 %168, 3
  %scevgep26.i.i = getelementptr i8, ptr %arg.weights, i64 %169
  br label %B60.if.epil.i.i.i

B60.if.epil.i.i.i:                                ; preds = %B60.if.epil.i.i.i, %B60.if.epil.preheader.i.i.i
  %epil.iter.i.i.i = phi i64 [ %epil.iter.next.i.i.i, %B60.if.epil.i.i.i ], [ 0, %B60.if.epil.preheader.i.i.i ]
  %170 = shl i64 %epil.iter.i.i.i, 3
  %scevgep27.i.i = getelementptr i8, ptr %scevgep26.i.i, i64 %170
  %.209.epil.i.i.i = load double, ptr %scevgep27.i.i, align 8, !noalias !24
  %scevgep25.i.i = getelementptr i8, ptr %scevgep17.i.i.i, i64 %170
  store double %.209.epil.i.i.i, ptr %scevgep25.i.i, align 8, !noalias !24
  %epil.iter.next.i.i.i = add i64 %epil.iter.i.i.i, 1
  %epil.iter.cmp.not.i.i.i = icmp eq i64 %xtraiter.i.i.i, %epil.iter.next.i.i.i
  br i1 %epil.iter.cmp.not.i.i.i, label %B88.i.i.i, label %B60.if.epil.i.i.i, !llvm.loop !27

B88.i.i.i:                                        ; preds = %B60.if.epil.i.i.i, %B88.loopexit.unr-lcssa.i.i.i, %B0.endif.endif.endif.else.endif.endif.i.i
  %.335294.not.i.i.i = icmp slt i64 %.340.sroa.13.2.i.i, 1
  br i1 %.335294.not.i.i.i, label %_ZN17bnserve_surrogate6kernel7_source8_prepareB2v8B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i, label %B140.if.lr.ph.i.i.i

B140.if.lr.ph.i.i.i:                              ; preds = %B88.i.i.i
  %scevgep12.i.i.i = getelementptr i8, ptr %.901.i.i, i64 8
  %171 = shl i64 %.788.sroa.0.3.i.i, 3
  %172 = getelementptr i8, ptr %arg.weights, i64 %171
  %scevgep17.i.i = getelementptr i8, ptr %172, i64 24
  br label %B140.if.i.i.i

B290.loopexit.unr-lcssa.i.unr-lcssa.i.i:          ; preds = %B234.if.i.i.i
  br i1 %51, label %B234.if.i.epil.preheader.i.i, label %B290.loopexit.unr-lcssa.i.i.i

B234.if.i.epil.preheader.i.i:                     ; preds = %B234.if.preheader8.i.i.i, %B290.loopexit.unr-lcssa.i.unr-lcssa.i.i
  %.675282284.i.epil.init.i.i = phi i64 [ 0, %B234.if.preheader8.i.i.i ], [ %.682.1.i.1.i.i, %B290.loopexit.unr-lcssa.i.unr-lcssa.i.i ]
  %173 = shl i64 %.675282284.i.epil.init.i.i, 3
  %sunkaddr60.i.epil.i.i = getelementptr i8, ptr %.621.i, i64 %173
  %.736.i.epil.i.i = load double, ptr %sunkaddr60.i.epil.i.i, align 8, !noalias !24
  %scevgep15.i.epil.i.i = getelementptr i8, ptr %scevgep13.i.i.i, i64 %173
  %scevgep16.i.epil.i.i = getelementptr i8, ptr %scevgep15.i.epil.i.i, i64 -8
  %.766.i.epil.i.i = load double, ptr %scevgep16.i.epil.i.i, align 8, !noalias !24
  %.768.i.epil.i.i = fmul contract double %.585.i.i.i, %.766.i.epil.i.i
  %.769.i.epil.i.i = fadd contract double %.736.i.epil.i.i, %.768.i.epil.i.i
  store double %.769.i.epil.i.i, ptr %sunkaddr60.i.epil.i.i, align 8, !noalias !24
  %.682.1.i.epil.i.i = add nuw i64 %.675282284.i.epil.init.i.i, 2
  %sunkaddr63.i.epil.i.i = getelementptr i8, ptr %sunkaddr60.i.epil.i.i, i64 8
  %.736.1.i.epil.i.i = load double, ptr %sunkaddr63.i.epil.i.i, align 8, !noalias !24
  %.766.1.i.epil.i.i = load double, ptr %scevgep15.i.epil.i.i, align 8, !noalias !24
  %.768.1.i.epil.i.i = fmul contract double %.585.i.i.i, %.766.1.i.epil.i.i
  %.769.1.i.epil.i.i = fadd contract double %.736.1.i.epil.i.i, %.768.1.i.epil.i.i
  store double %.769.1.i.epil.i.i, ptr %sunkaddr63.i.epil.i.i, align 8, !noalias !24
  br label %B290.loopexit.unr-lcssa.i.i.i

B290.loopexit.unr-lcssa.i.i.i:                    ; preds = %B234.if.i.epil.preheader.i.i, %B290.loopexit.unr-lcssa.i.unr-lcssa.i.i
  %.682.1.i.lcssa.i.i = phi i64 [ %.682.1.i.epil.i.i, %B234.if.i.epil.preheader.i.i ], [ %.682.1.i.1.i.i, %B290.loopexit.unr-lcssa.i.unr-lcssa.i.i ]
  br i1 %53, label %B290.i.i.i, label %B234.if.epil.preheader.i.i.i

B234.if.epil.preheader.i.i.i:                     ; preds = %B142.else.endif.endif.endif.endif.i.i.i, %B290.loopexit.unr-lcssa.i.i.i
  %.675282284.epil.init.i.i.i = phi i64 [ 0, %B142.else.endif.endif.endif.endif.i.i.i ], [ %.682.1.i.lcssa.i.i, %B290.loopexit.unr-lcssa.i.i.i ]
  %174 = getelementptr double, ptr %.621.i, i64 %.675282284.epil.init.i.i.i
  %.736.epil.i.i.i = load double, ptr %174, align 8, !noalias !24
  %175 = getelementptr double, ptr %.518.i.i.i, i64 %.675282284.epil.init.i.i.i
  %.766.epil.i.i.i = load double, ptr %175, align 8, !noalias !24
  %.768.epil.i.i.i = fmul contract double %.585.i.i.i, %.766.epil.i.i.i
  %.769.epil.i.i.i = fadd contract double %.736.epil.i.i.i, %.768.epil.i.i.i
  store double %.769.epil.i.i.i, ptr %174, align 8, !noalias !24
  br label %B290.i.i.i

B290.i.i.i:                                       ; preds = %B142.else.endif.endif.endif.endif.i.i.i, %B234.if.epil.preheader.i.i.i, %B290.loopexit.unr-lcssa.i.i.i
  %exitcond302.not.i.i.i = icmp eq i64 %.340.sroa.13.2.i.i, %.348.i.i.i
  br i1 %exitcond302.not.i.i.i, label %_ZN17bnserve_surrogate6kernel7_source8_prepareB2v8B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i, label %B140.if.i.i.i

B60.if.i.i.i:                                     ; preds = %B60.if.i.i.i, %B60.if.preheader.new.i.new.i.i
  %lsr.iv24.i.i = phi i64 [ %lsr.iv.next25.i.i, %B60.if.i.i.i ], [ %43, %B60.if.preheader.new.i.new.i.i ]
  %.148276278.i.i.i = phi i64 [ %.155.3.i.1.i.i, %B60.if.i.i.i ], [ 0, %B60.if.preheader.new.i.new.i.i ]
  %sunkaddr.i.i.i = shl i64 %.148276278.i.i.i, 3
  %scevgep42.i.i = getelementptr i8, ptr %scevgep28.i.i, i64 %sunkaddr.i.i.i
  %scevgep43.i.i = getelementptr i8, ptr %scevgep42.i.i, i64 -56
  %.209.i.i.i = load double, ptr %scevgep43.i.i, align 8, !noalias !24
  %sunkaddr66.i.i = getelementptr i8, ptr %.621.i, i64 %sunkaddr.i.i.i
  store double %.209.i.i.i, ptr %sunkaddr66.i.i, align 8, !noalias !24
  %scevgep64.i.i = getelementptr i8, ptr %scevgep42.i.i, i64 -48
  %.209.1.i.i.i = load double, ptr %scevgep64.i.i, align 8, !noalias !24
  %sunkaddr69.i.i = getelementptr i8, ptr %sunkaddr66.i.i, i64 8
  store double %.209.1.i.i.i, ptr %sunkaddr69.i.i, align 8, !noalias !24
  %scevgep62.i.i = getelementptr i8, ptr %scevgep42.i.i, i64 -40
  %.209.2.i.i.i = load double, ptr %scevgep62.i.i, align 8, !noalias !24
  %sunkaddr72.i.i = getelementptr i8, ptr %sunkaddr66.i.i, i64 16
  store double %.209.2.i.i.i, ptr %sunkaddr72.i.i, align 8, !noalias !24
  %scevgep60.i.i = getelementptr i8, ptr %scevgep42.i.i, i64 -32
  %.209.3.i.i.i = load double, ptr %scevgep60.i.i, align 8, !noalias !24
  %sunkaddr75.i.i = getelementptr i8, ptr %sunkaddr66.i.i, i64 24
  store double %.209.3.i.i.i, ptr %sunkaddr75.i.i, align 8, !noalias !24
  %scevgep56.i.i = getelementptr i8, ptr %scevgep42.i.i, i64 -24
  %.209.i.1.i.i = load double, ptr %scevgep56.i.i, align 8, !noalias !24
  %sunkaddr78.i.i = getelementptr i8, ptr %sunkaddr66.i.i, i64 32
  store double %.209.i.1.i.i, ptr %sunkaddr78.i.i, align 8, !noalias !24
  %scevgep52.i.i = getelementptr i8, ptr %scevgep42.i.i, i64 -16
  %.209.1.i.1.i.i = load double, ptr %scevgep52.i.i, align 8, !noalias !24
  %sunkaddr81.i.i = getelementptr i8, ptr %sunkaddr66.i.i, i64 40
  store double %.209.1.i.1.i.i, ptr %sunkaddr81.i.i, align 8, !noalias !24
  %scevgep48.i.i = getelementptr i8, ptr %scevgep42.i.i, i64 -8
  %.209.2.i.1.i.i = load double, ptr %scevgep48.i.i, align 8, !noalias !24
  %sunkaddr84.i.i = getelementptr i8, ptr %sunkaddr66.i.i, i64 48
  store double %.209.2.i.1.i.i, ptr %sunkaddr84.i.i, align 8, !noalias !24
  %.155.3.i.1.i.i = add i64 %.148276278.i.i.i, 8
  %.209.3.i.1.i.i = load double, ptr %scevgep42.i.i, align 8, !noalias !24
  %sunkaddr85.i.i = shl i64 %.155.3.i.1.i.i, 3
  %sunkaddr86.i.i = getelementptr i8, ptr %.621.i, i64 %sunkaddr85.i.i
  %sunkaddr87.i.i = getelementptr i8, ptr %sunkaddr86.i.i, i64 -8
  store double %.209.3.i.1.i.i, ptr %sunkaddr87.i.i, align 8, !noalias !24
  %lsr.iv.next25.i.i = add i64 %lsr.iv24.i.i, -2
  %niter.ncmp.1.i.i = icmp eq i64 %lsr.iv.next25.i.i, 0
  br i1 %niter.ncmp.1.i.i, label %B88.loopexit.unr-lcssa.i.unr-lcssa.i.i, label %B60.if.i.i.i

B140.if.i.i.i:                                    ; preds = %B290.i.i.i, %B140.if.lr.ph.i.i.i
  %.341289295.i.i.i = phi i64 [ 0, %B140.if.lr.ph.i.i.i ], [ %.348.i.i.i, %B290.i.i.i ]
  %.348.i.i.i = add nuw nsw i64 %.341289295.i.i.i, 1
  %.375.i.i.i = mul nuw nsw i64 %.348.i.i.i, %.605.i
  %.425.not.i.i.i = icmp sgt i64 %.876.i.i, %.375.i.i.i
  br i1 %.425.not.i.i.i, label %B142.else.endif.endif.endif.endif.i.i.i, label %B142.else.endif.if.i.i.i, !prof !5

B142.else.endif.if.i.i.i:                         ; preds = %B140.if.i.i.i
  br label %B142.else.endif.endif.endif.endif.i.i.i

B142.else.endif.endif.endif.endif.i.i.i:          ; preds = %B142.else.endif.if.i.i.i, %B140.if.i.i.i
  %.405.sroa.0.3.i.i.i = phi i64 [ %.885.i.i, %B142.else.endif.if.i.i.i ], [ %.375.i.i.i, %B140.if.i.i.i ]
  %.518.i.i.i = getelementptr double, ptr %.901.i.i, i64 %.405.sroa.0.3.i.i.i
  %176 = getelementptr double, ptr %.1362.i, i64 %.341289295.i.i.i
  %.585.i.i.i = load double, ptr %176, align 8, !noalias !24
  switch i63 %trunc.i.i, label %B234.if.preheader8.i.i.i [
    i63 0, label %B290.i.i.i
    i63 1, label %B234.if.epil.preheader.i.i.i
  ]

B234.if.preheader8.i.i.i:                         ; preds = %B142.else.endif.endif.endif.endif.i.i.i
  %177 = shl i64 %.405.sroa.0.3.i.i.i, 3
  %scevgep13.i.i.i = getelementptr i8, ptr %scevgep12.i.i.i, i64 %177
  br i1 %49, label %B234.if.i.epil.preheader.i.i, label %B234.if.i.preheader.i.i

B234.if.i.preheader.i.i:                          ; preds = %B234.if.preheader8.i.i.i
  %scevgep18.i.i = getelementptr i8, ptr %scevgep17.i.i, i64 %177
  br label %B234.if.i.i.i

B234.if.i.i.i:                                    ; preds = %B234.if.i.i.i, %B234.if.i.preheader.i.i
  %lsr.iv3.i.i = phi i64 [ %lsr.iv.next4.i.i, %B234.if.i.i.i ], [ %48, %B234.if.i.preheader.i.i ]
  %.675282284.i.i.i = phi i64 [ %.682.1.i.1.i.i, %B234.if.i.i.i ], [ 0, %B234.if.i.preheader.i.i ]
  %178 = shl i64 %.675282284.i.i.i, 3
  %sunkaddr89.i.i = getelementptr i8, ptr %.621.i, i64 %178
  %.736.i.i.i = load double, ptr %sunkaddr89.i.i, align 8, !noalias !24
  %scevgep21.i.i = getelementptr i8, ptr %scevgep18.i.i, i64 %178
  %scevgep23.i.i = getelementptr i8, ptr %scevgep21.i.i, i64 -16
  %scevgep20.i.i = getelementptr i8, ptr %scevgep21.i.i, i64 -24
  %.766.i.i.i = load double, ptr %scevgep20.i.i, align 8, !noalias !24
  %.768.i.i.i = fmul contract double %.585.i.i.i, %.766.i.i.i
  %.769.i.i.i = fadd contract double %.736.i.i.i, %.768.i.i.i
  store double %.769.i.i.i, ptr %sunkaddr89.i.i, align 8, !noalias !24
  %sunkaddr92.i.i = getelementptr i8, ptr %sunkaddr89.i.i, i64 8
  %.736.1.i.i.i = load double, ptr %sunkaddr92.i.i, align 8, !noalias !24
  %.766.1.i.i.i = load double, ptr %scevgep23.i.i, align 8, !noalias !24
  %.768.1.i.i.i = fmul contract double %.585.i.i.i, %.766.1.i.i.i
  %.769.1.i.i.i = fadd contract double %.736.1.i.i.i, %.768.1.i.i.i
  store double %.769.1.i.i.i, ptr %sunkaddr92.i.i, align 8, !noalias !24
  %sunkaddr95.i.i = getelementptr i8, ptr %sunkaddr89.i.i, i64 16
  %.736.i.1.i.i = load double, ptr %sunkaddr95.i.i, align 8, !noalias !24
  %scevgep15.i.i = getelementptr i8, ptr %scevgep21.i.i, i64 -8
  %.766.i.1.i.i = load double, ptr %scevgep15.i.i, align 8, !noalias !24
  %.768.i.1.i.i = fmul contract double %.585.i.i.i, %.766.i.1.i.i
  %.769.i.1.i.i = fadd contract double %.736.i.1.i.i, %.768.i.1.i.i
  store double %.769.i.1.i.i, ptr %sunkaddr95.i.i, align 8, !noalias !24
  %.682.1.i.1.i.i = add i64 %.675282284.i.i.i, 4
  %sunkaddr96.i.i = shl i64 %.682.1.i.1.i.i, 3
  %sunkaddr97.i.i = getelementptr i8, ptr %.621.i, i64 %sunkaddr96.i.i
  %sunkaddr98.i.i = getelementptr i8, ptr %sunkaddr97.i.i, i64 -8
  %.736.1.i.1.i.i = load double, ptr %sunkaddr98.i.i, align 8, !noalias !24
  %.766.1.i.1.i.i = load double, ptr %scevgep21.i.i, align 8, !noalias !24
  %.768.1.i.1.i.i = fmul contract double %.585.i.i.i, %.766.1.i.1.i.i
  %.769.1.i.1.i.i = fadd contract double %.736.1.i.1.i.i, %.768.1.i.1.i.i
  store double %.769.1.i.1.i.i, ptr %sunkaddr98.i.i, align 8, !noalias !24
  %lsr.iv.next4.i.i = add i64 %lsr.iv3.i.i, -2
  %niter9.ncmp.1.i.i = icmp eq i64 %lsr.iv.next4.i.i, 0
  br i1 %niter9.ncmp.1.i.i, label %B290.loopexit.unr-lcssa.i.unr-lcssa.i.i, label %B234.if.i.i.i

_ZN17bnserve_surrogate6kernel7_source8_prepareB2v8B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i: ; preds = %B290.i.i.i, %B88.i.i.i
  tail call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(384) %arg.series, i8 0, i64 384, i1 false), !noalias !28
  %.29.i.i.i = fadd contract double %.136.i.i, 1.000000e+00
  %.33.i.i.i = fdiv contract double %.136.i.i, %.29.i.i.i
  %.38.i.i.i = fdiv contract double 1.000000e+00, %.29.i.i.i
  %.39.i2.i.i = fmul contract double %.33.i.i.i, %.38.i.i.i
  store double 1.000000e+00, ptr %arg.series, align 8, !noalias !31
  %.203.i.i.i.i = fmul contract double %.39.i2.i.i, 0x401871C71C71C71C
  %.204.i.i.i.i = fadd contract double %.203.i.i.i.i, 0x4013A7F529FD4A7F
  store double %.204.i.i.i.i, ptr %.183.i.i.i.i, align 8, !noalias !31
  %.309.i.i.i.i = load double, ptr %.308.i.i.i.i, align 8, !noalias !31
  %.310.i.i.i.i = fadd contract double %.309.i.i.i.i, 0xC04921FB54442D18
  store double %.310.i.i.i.i, ptr %.308.i.i.i.i, align 8, !noalias !31
  %.414.i.i.i.i = load double, ptr %.413.i.i.i.i, align 8, !noalias !31
  %.454.i2.i.i.i = fmul contract double %.39.i2.i.i, 0x40456C71C71C71C7
  %.455.i3.i.i.i = fadd contract double %.454.i2.i.i.i, 0x404AEDF7DF7DF7DF
  %.456.i4.i.i.i = fmul contract double %.39.i2.i.i, %.455.i3.i.i.i
  %.457.i.i.i.i = fadd contract double %.456.i4.i.i.i, 0x403E1A683B5702A5
  %.458.i.i.i.i = fadd contract double %.457.i.i.i.i, %.414.i.i.i.i
  store double %.458.i.i.i.i, ptr %.413.i.i.i.i, align 8, !noalias !31
  %.562.i.i.i.i = load double, ptr %.561.i.i.i.i, align 8, !noalias !31
  %.581.i.i.i.i = fmul contract double %.39.i2.i.i, 0x40510457810E2933
  %179 = fsub contract double 0x407E1C5F0E074C89, %.581.i.i.i.i
  %.583.i.i.i.i = fadd contract double %179, %.562.i.i.i.i
  store double %.583.i.i.i.i, ptr %.561.i.i.i.i, align 8, !noalias !31
  %.687.i.i.i.i = load double, ptr %.686.i.i.i.i, align 8, !noalias !31
  %.756.i.i.i.i = fmul contract double %.39.i2.i.i, 0x4058A8587E6B74F0
  %180 = fsub contract double 0x404601B425ED097B, %.756.i.i.i.i
  %.758.i.i.i.i = fmul contract double %.39.i2.i.i, %180
  %.759.i.i.i.i = fadd contract double %.758.i.i.i.i, 0xC0A9D8A41ED3317E
  %.760.i.i.i.i = fmul contract double %.39.i2.i.i, %.759.i.i.i.i
  %.761.i.i.i.i = fadd contract double %.760.i.i.i.i, 0xC071640B49E85C3E
  %.762.i.i.i.i = fadd contract double %.761.i.i.i.i, %.687.i.i.i.i
  store double %.762.i.i.i.i, ptr %.686.i.i.i.i, align 8, !noalias !31
  %.866.i.i.i.i = load double, ptr %.865.i.i.i.i, align 8, !noalias !31
  %.867.i.i.i.i = fadd contract double %.866.i.i.i.i, 0xC074618618618618
  store double %.867.i.i.i.i, ptr %.865.i.i.i.i, align 8, !noalias !31
  %.971.i.i.i.i = load double, ptr %.970.i.i.i.i, align 8, !noalias !31
  %.1011.i.i.i.i = fmul contract double %.39.i2.i.i, 0x40733B288412FE12
  %181 = fsub contract double 0x408893BEE8443B83, %.1011.i.i.i.i
  %.1013.i.i.i.i = fmul contract double %.39.i2.i.i, %181
  %.1014.i.i.i.i = fadd contract double %.1013.i.i.i.i, 0x408DCC10DD757C0B
  %.1015.i.i.i.i = fadd contract double %.1014.i.i.i.i, %.971.i.i.i.i
  store double %.1015.i.i.i.i, ptr %.970.i.i.i.i, align 8, !noalias !31
  %.1119.i.i.i.i = load double, ptr %.1118.i.i.i.i, align 8, !noalias !31
  %.1225.i.i.i.i = fmul contract double %.39.i2.i.i, 0x40514C5F3B7242FB
  %.1226.i.i.i.i = fadd contract double %.1225.i.i.i.i, 0xC05D2FBB067D39F9
  %.1227.i.i.i.i = fmul contract double %.39.i2.i.i, %.1226.i.i.i.i
  %.1228.i.i.i.i = fadd contract double %.1227.i.i.i.i, 0xC091A4640F04B974
  %.1229.i.i.i.i = fmul contract double %.39.i2.i.i, %.1228.i.i.i.i
  %.1230.i.i.i.i = fadd contract double %.1229.i.i.i.i, 0x40CE3F8117DB38CA
  %.1231.i.i.i.i = fmul contract double %.39.i2.i.i, %.1230.i.i.i.i
  %.1232.i.i.i.i = fadd contract double %.1231.i.i.i.i, 0xC0A8D75E6BF57F9D
  %.1233.i.i.i.i = fadd contract double %.1232.i.i.i.i, %.1119.i.i.i.i
  store double %.1233.i.i.i.i, ptr %.1118.i.i.i.i, align 8, !noalias !31
  %.1337.i.i.i.i = load double, ptr %.1336.i.i.i.i, align 8, !noalias !31
  %.1356.i.i.i.i = fmul contract double %.39.i2.i.i, 0x409F6EC11CD4D97E
  %.1357.i.i.i.i = fadd contract double %.1356.i.i.i.i, 0x4072428A28A28A29
  %.1358.i.i.i.i = fadd contract double %.1357.i.i.i.i, %.1337.i.i.i.i
  store double %.1358.i.i.i.i, ptr %.1336.i.i.i.i, align 8, !noalias !31
  %.1462.i.i.i.i = load double, ptr %.1461.i.i.i.i, align 8, !noalias !31
  %.1531.i.i.i.i = fmul contract double %.39.i2.i.i, 0x40645019F9E83A77
  %.1532.i.i.i.i = fadd contract double %.1531.i.i.i.i, 0x40918164C0B5D6FD
  %.1533.i.i.i.i = fmul contract double %.39.i2.i.i, %.1532.i.i.i.i
  %.1534.i.i.i.i = fadd contract double %.1533.i.i.i.i, 0xC0D6C519D7F78519
  %.1535.i.i.i.i = fmul contract double %.39.i2.i.i, %.1534.i.i.i.i
  %.1536.i.i.i.i = fadd contract double %.1535.i.i.i.i, 0x40BB4B9C657BC796
  %.1537.i.i.i.i = fadd contract double %.1536.i.i.i.i, %.1462.i.i.i.i
  store double %.1537.i.i.i.i, ptr %.1461.i.i.i.i, align 8, !noalias !31
  %.1641.i.i.i.i = load double, ptr %.1640.i.i.i.i, align 8, !noalias !31
  %.1642.i.i.i.i = fadd contract double %.1641.i.i.i.i, 0xC0A001D567F49087
  store double %.1642.i.i.i.i, ptr %.1640.i.i.i.i, align 8, !noalias !31
  %.1810.i.i.i.i = fmul contract double %.39.i2.i.i, 0x40A619E547AE6DA3
  %.1811.i.i.i.i = fadd contract double %.1810.i.i.i.i, 0xC0D25E7665446D0F
  %.1812.i.i.i.i = fmul contract double %.39.i2.i.i, %.1811.i.i.i.i
  %.1813.i.i.i.i = fadd contract double %.1812.i.i.i.i, 0x40E19BDA5330D73F
  %.1814.i.i.i.i = fmul contract double %.39.i2.i.i, %.1813.i.i.i.i
  %.1815.i.i.i.i = fadd contract double %.1814.i.i.i.i, 0xC0E154650FD9ACF1
  %.1868.i.i.i.i = load double, ptr %.1867.i.i.i.i, align 8, !noalias !31
  %.1956.i.i.i.i = fmul contract double %.39.i2.i.i, %.1815.i.i.i.i
  %.1957.i.i.i.i = fadd contract double %.1956.i.i.i.i, 0xC0F5A16228D9F21A
  %.1958.i.i.i.i = fmul contract double %.39.i2.i.i, %.1957.i.i.i.i
  %.1959.i.i.i.i = fadd contract double %.1958.i.i.i.i, 0x40ECE30547C08F3B
  %.1960.i.i.i.i = fmul contract double %.39.i2.i.i, %.1959.i.i.i.i
  %.1961.i.i3.i.i = fadd contract double %.1960.i.i.i.i, 0xC0C172813AB99F84
  %.1962.i.i.i.i = fmul contract double %.39.i2.i.i, 3.000000e+00
  %.1963.i.i.i.i = fsub contract double 1.000000e+00, %.1962.i.i.i.i
  %.1967.i.i.i.i = fdiv contract double %.1961.i.i3.i.i, %.1963.i.i.i.i
  %.1968.i.i.i.i = fadd contract double %.1967.i.i.i.i, %.1868.i.i.i.i
  store double %.1968.i.i.i.i, ptr %.1867.i.i.i.i, align 8, !noalias !31
  %.2088.i.i.i.i = fmul contract double %.39.i2.i.i, 0x40C0712C540DB5CD
  %.2089.i.i.i.i = fadd contract double %.2088.i.i.i.i, 0x40A79A477BF30A91
  %.2090.i.i.i.i = fmul contract double %.39.i2.i.i, %.2089.i.i.i.i
  %.2091.i.i.i.i = fadd contract double %.2090.i.i.i.i, 0xC0A4B055B758E414
  %.2092.i.i.i.i = fmul contract double %.39.i2.i.i, %.2091.i.i.i.i
  %.2093.i.i.i.i = fadd contract double %.2092.i.i.i.i, 0x406D67FD70A13797
  %.2146.i.i.i.i = load double, ptr %.2145.i.i.i.i, align 8, !noalias !31
  %.2152.i.i.i.i = fdiv contract double %.2093.i.i.i.i, %.1963.i.i.i.i
  %.2153.i.i.i.i = fadd contract double %.2152.i.i.i.i, %.2146.i.i.i.i
  store double %.2153.i.i.i.i, ptr %.2145.i.i.i.i, align 8, !noalias !31
  %.2257.i.i.i.i = load double, ptr %.2256.i.i.i.i, align 8, !noalias !31
  %.2363.i.i.i.i = fmul contract double %.39.i2.i.i, 0x402CA90C106318D7
  %.2364.i.i.i.i = fadd contract double %.2363.i.i.i.i, 0xC06030460C29F3DF
  %.2365.i.i.i.i = fmul contract double %.39.i2.i.i, %.2364.i.i.i.i
  %.2366.i.i.i.i = fadd contract double %.2365.i.i.i.i, 0x40D015D04F4BC5D2
  %.2367.i.i.i.i = fmul contract double %.39.i2.i.i, %.2366.i.i.i.i
  %.2368.i.i.i.i = fadd contract double %.2367.i.i.i.i, 0xC0E536054A2E10AB
  %.2369.i.i.i.i = fmul contract double %.39.i2.i.i, %.2368.i.i.i.i
  %.2370.i.i.i.i = fadd contract double %.2369.i.i.i.i, 0x40C95DBCC2240A74
  %.2371.i.i.i.i = fadd contract double %.2370.i.i.i.i, %.2257.i.i.i.i
  store double %.2371.i.i.i.i, ptr %.2256.i.i.i.i, align 8, !noalias !31
  %.2475.i.i.i.i = load double, ptr %.2474.i.i.i.i, align 8, !noalias !31
  %.2494.i.i.i.i = fmul contract double %.39.i2.i.i, 0x40BD257CD0AE1310
  %182 = fsub contract double 0xC09600901EF7C9A4, %.2494.i.i.i.i
  %.2496.i.i.i.i = fadd contract double %182, %.2475.i.i.i.i
  store double %.2496.i.i.i.i, ptr %.2474.i.i.i.i, align 8, !noalias !31
  %.24.i.i.i.i = fsub contract double 1.000000e+00, %.33.i.i.i
  %.25.i.i4.i.i = fmul contract double %.33.i.i.i, %.24.i.i.i.i
  %.26.i.i.i.i = fmul contract double %.165.i.i, %.33.i.i.i
  %.80.i.i.i.i = fmul contract double %.33.i.i.i, 0x4029555555555555
  %.81.i.i5.i.i = fadd contract double %.80.i.i.i.i, 2.500000e+01
  %.82.i.i.i.i = fmul contract double %.26.i.i.i.i, %.81.i.i5.i.i
  %.83.i.i.i.i = fadd contract double %.82.i.i.i.i, %.310.i.i.i.i
  store double %.83.i.i.i.i, ptr %.308.i.i.i.i, align 8, !noalias !34
  %.188.i.i.i.i = fmul contract double %.26.i.i.i.i, 3.000000e+00
  %.189.i.i.i.i = fmul contract double %.25.i.i4.i.i, 0x400AAAAAAAAAAAAB
  %.190.i.i.i.i = fsub contract double 0x4064B4F3CF3CF3CF, %.189.i.i.i.i
  %.191.i.i.i.i = fmul contract double %.25.i.i4.i.i, 0x4032E38E38E38E39
  %.192.i.i.i.i = fadd contract double %.191.i.i.i.i, 0x4063B0FCD6E9E065
  %.193.i.i.i.i = fmul contract double %.33.i.i.i, %.192.i.i.i.i
  %.194.i.i.i.i = fadd contract double %.190.i.i.i.i, %.193.i.i.i.i
  %.195.i.i.i.i = fmul contract double %.188.i.i.i.i, %.194.i.i.i.i
  %183 = fsub contract double %.583.i.i.i.i, %.195.i.i.i.i
  store double %183, ptr %.561.i.i.i.i, align 8, !noalias !34
  %.301.i.i.i.i = fmul contract double %.26.i.i.i.i, 0x400921FB54442D18
  %.302.i.i.i.i = fmul contract double %.33.i.i.i, 2.600000e+02
  %.303.i.i.i.i = fadd contract double %.302.i.i.i.i, 0x407F0AAAAAAAAAAB
  %.304.i.i.i.i = fmul contract double %.303.i.i.i.i, %.301.i.i.i.i
  %.305.i.i.i.i = fadd contract double %.304.i.i.i.i, %.762.i.i.i.i
  store double %.305.i.i.i.i, ptr %.686.i.i.i.i, align 8, !noalias !34
  %.357.i.i.i.i = fmul contract double %.25.i.i4.i.i, 0x4020F1C71C71C71C
  %.358.i.i.i.i = fsub contract double 0x40C10436B015AC05, %.357.i.i.i.i
  %.359.i.i.i.i = fmul contract double %.25.i.i4.i.i, %.358.i.i.i.i
  %.360.i.i.i.i = fadd contract double %.359.i.i.i.i, 0xC0C7044BD0923320
  %.361.i.i.i.i = fmul contract double %.25.i.i4.i.i, 0x404070E38E38E38E
  %.362.i.i6.i.i = fadd contract double %.361.i.i.i.i, 0x40B0B864F3CF3CF4
  %.363.i.i.i.i = fmul contract double %.25.i.i4.i.i, %.362.i.i6.i.i
  %.364.i.i.i.i = fsub contract double 0x40AB9B8B602B580B, %.363.i.i.i.i
  %.418.i.i.i.i = fmul contract double %.33.i.i.i, %.360.i.i.i.i
  %.419.i.i.i.i = fmul contract double %.33.i.i.i, 2.000000e+00
  %.420.i.i.i.i = fadd contract double %.419.i.i.i.i, -1.000000e+00
  %.421.i.i.i.i = fmul contract double %.420.i.i.i.i, %.364.i.i.i.i
  %.422.i.i.i.i = fadd contract double %.418.i.i.i.i, %.421.i.i.i.i
  %.423.i.i.i.i = fmul contract double %.26.i.i.i.i, %.422.i.i.i.i
  %.424.i.i.i.i = fadd contract double %.423.i.i.i.i, %.1015.i.i.i.i
  store double %.424.i.i.i.i, ptr %.970.i.i.i.i, align 8, !noalias !34
  %.24.i7.i.i.i = fsub contract double 1.000000e+00, %.38.i.i.i
  %.25.i8.i.i.i = fmul contract double %.38.i.i.i, %.24.i7.i.i.i
  %.26.i9.i.i.i = fmul contract double %.38.i.i.i, %.194.i.i
  %.80.i12.i.i.i = fmul contract double %.38.i.i.i, 0x4029555555555555
  %.81.i13.i.i.i = fadd contract double %.80.i12.i.i.i, 2.500000e+01
  %.82.i14.i.i.i = fmul contract double %.26.i9.i.i.i, %.81.i13.i.i.i
  %.83.i15.i.i.i = fadd contract double %.82.i14.i.i.i, %.83.i.i.i.i
  store double %.83.i15.i.i.i, ptr %.308.i.i.i.i, align 8, !noalias !37
  %.188.i18.i.i.i = fmul contract double %.26.i9.i.i.i, 3.000000e+00
  %.189.i19.i.i.i = fmul contract double %.25.i8.i.i.i, 0x400AAAAAAAAAAAAB
  %.190.i20.i.i.i = fsub contract double 0x4064B4F3CF3CF3CF, %.189.i19.i.i.i
  %.191.i21.i.i.i = fmul contract double %.25.i8.i.i.i, 0x4032E38E38E38E39
  %.192.i22.i.i.i = fadd contract double %.191.i21.i.i.i, 0x4063B0FCD6E9E065
  %.193.i23.i.i.i = fmul contract double %.38.i.i.i, %.192.i22.i.i.i
  %.194.i24.i.i.i = fadd contract double %.190.i20.i.i.i, %.193.i23.i.i.i
  %.195.i25.i.i.i = fmul contract double %.188.i18.i.i.i, %.194.i24.i.i.i
  %184 = fsub contract double %183, %.195.i25.i.i.i
  store double %184, ptr %.561.i.i.i.i, align 8, !noalias !37
  %.301.i28.i.i.i = fmul contract double %.26.i9.i.i.i, 0x400921FB54442D18
  %.302.i29.i.i.i = fmul contract double %.38.i.i.i, 2.600000e+02
  %.303.i30.i.i.i = fadd contract double %.302.i29.i.i.i, 0x407F0AAAAAAAAAAB
  %.304.i31.i.i.i = fmul contract double %.303.i30.i.i.i, %.301.i28.i.i.i
  %.305.i32.i.i.i = fadd contract double %.304.i31.i.i.i, %.305.i.i.i.i
  store double %.305.i32.i.i.i, ptr %.686.i.i.i.i, align 8, !noalias !37
  %.357.i33.i.i.i = fmul contract double %.25.i8.i.i.i, 0x4020F1C71C71C71C
  %.358.i34.i.i.i = fsub contract double 0x40C10436B015AC05, %.357.i33.i.i.i
  %.359.i35.i.i.i = fmul contract double %.25.i8.i.i.i, %.358.i34.i.i.i
  %.360.i36.i.i.i = fadd contract double %.359.i35.i.i.i, 0xC0C7044BD0923320
  %.361.i37.i.i.i = fmul contract double %.25.i8.i.i.i, 0x404070E38E38E38E
  %.362.i38.i.i.i = fadd contract double %.361.i37.i.i.i, 0x40B0B864F3CF3CF4
  %.363.i39.i.i.i = fmul contract double %.25.i8.i.i.i, %.362.i38.i.i.i
  %.364.i40.i.i.i = fsub contract double 0x40AB9B8B602B580B, %.363.i39.i.i.i
  %.418.i43.i.i.i = fmul contract double %.38.i.i.i, %.360.i36.i.i.i
  %.419.i44.i.i.i = fmul contract double %.38.i.i.i, 2.000000e+00
  %.420.i45.i.i.i = fadd contract double %.419.i44.i.i.i, -1.000000e+00
  %.421.i46.i.i.i = fmul contract double %.420.i45.i.i.i, %.364.i40.i.i.i
  %.422.i47.i.i.i = fadd contract double %.418.i43.i.i.i, %.421.i46.i.i.i
  %.423.i48.i.i.i = fmul contract double %.26.i9.i.i.i, %.422.i47.i.i.i
  %.424.i49.i.i.i = fadd contract double %.423.i48.i.i.i, %.424.i.i.i.i
  store double %.424.i49.i.i.i, ptr %.970.i.i.i.i, align 8, !noalias !37
  %.15.le.i.i.i.i = fcmp contract uno double %.223.i.i, 0.000000e+00
  %.17.le.i.i.i.i = fcmp contract oge double %.223.i.i, 1.000000e+00
  %185 = or i1 %.15.le.i.i.i.i, %.17.le.i.i.i.i
  %186 = tail call contract double @llvm.log.f64(double %.223.i.i)
  %.31.le.i.i.i.i = select i1 %185, double %186, double 0.000000e+00
  %.36.i.i.i.i = fmul contract double %.31.le.i.i.i.i, 1.230000e-04
  %.37.i.i.i.i = fadd contract double %.36.i.i.i.i, -4.210000e-03
  %.38.i.i.i.i = fmul contract double %.31.le.i.i.i.i, %.37.i.i.i.i
  %.39.i.i.i.i = fadd contract double %.38.i.i.i.i, 4.740000e-02
  %.40.i.i.i.i = fmul contract double %.31.le.i.i.i.i, %.39.i.i.i.i
  %.41.i.i.i.i = fadd contract double %.40.i.i.i.i, 9.360000e-02
  %.42.i.i.i.i = fmul contract double %.31.le.i.i.i.i, %.41.i.i.i.i
  %.43.i.i.i.i = fadd contract double %.42.i.i.i.i, 1.940000e-01
  %.44.i.i.i.i = fcmp contract ogt double %.223.i.i, 1.000000e+00
  %.46.i.i.i.i = uitofp i1 %.44.i.i.i.i to double
  %.47.i.i.i.i = fmul contract double %.43.i.i.i.i, %.46.i.i.i.i
  %.55.le.i.i.i.i = tail call contract double @llvm.exp.f64(double %.47.i.i.i.i)
  %.147.i.i.i7.i.i = fmul contract double %.26.i.i.i.i, %.26.i.i.i.i
  %.106.i.i.i.i = fmul contract double %.55.le.i.i.i.i, 5.000000e+01
  %.107.i.i.i.i = fadd contract double %.106.i.i.i.i, 6.250000e-01
  %187 = fmul contract double %.147.i.i.i7.i.i, %.107.i.i.i.i
  %.109.i.i.i.i = fsub contract double %.458.i.i.i.i, %187
  store double %.109.i.i.i.i, ptr %.413.i.i.i.i, align 8, !noalias !40
  %.214.i.i.i.i = fmul contract double %.33.i.i.i, 1.200000e+02
  %.215.i.i.i.i = fsub contract double 0x407E92AAAAAAAAAB, %.214.i.i.i.i
  %.216.i.i.i.i = fmul contract double %.33.i.i.i, %.215.i.i.i.i
  %.217.i.i.i.i = fadd contract double %.216.i.i.i.i, 0x40817F8618618618
  %.218.i.i.i.i = fmul contract double %.217.i.i.i.i, %.55.le.i.i.i.i
  %.219.i.i.i.i = fmul contract double %.33.i.i.i, 0x40416E38E38E38E4
  %.220.i.i.i.i = fsub contract double 0x40569AAAAAAAAAAB, %.219.i.i.i.i
  %.221.i.i.i.i = fmul contract double %.33.i.i.i, %.220.i.i.i.i
  %.222.i.i.i.i = fadd contract double %.221.i.i.i.i, 0x40831AC618618618
  %.223.i.i.i.i = fsub contract double %.218.i.i.i.i, %.222.i.i.i.i
  %.224.i.i.i.i = fmul contract double %.147.i.i.i7.i.i, %.223.i.i.i.i
  %.225.i.i.i.i = fadd contract double %.224.i.i.i.i, %.305.i32.i.i.i
  store double %.225.i.i.i.i, ptr %.686.i.i.i.i, align 8, !noalias !40
  %.331.i.i.i.i = fmul contract double %.147.i.i.i7.i.i, 0x4093A28C59D5433B
  %.332.i.i.i.i = fmul contract double %.331.i.i.i.i, %.55.le.i.i.i.i
  %188 = fsub contract double %.424.i49.i.i.i, %.332.i.i.i.i
  store double %188, ptr %.970.i.i.i.i, align 8, !noalias !40
  %.15.le.i51.i.i.i = fcmp contract uno double %.252.i.i, 0.000000e+00
  %.17.le.i52.i.i.i = fcmp contract oge double %.252.i.i, 1.000000e+00
  %189 = or i1 %.15.le.i51.i.i.i, %.17.le.i52.i.i.i
  %190 = tail call contract double @llvm.log.f64(double %.252.i.i)
  %.31.le.i53.i.i.i = select i1 %189, double %190, double 0.000000e+00
  %.36.i54.i.i.i = fmul contract double %.31.le.i53.i.i.i, 1.230000e-04
  %.37.i55.i.i.i = fadd contract double %.36.i54.i.i.i, -4.210000e-03
  %.38.i56.i.i.i = fmul contract double %.31.le.i53.i.i.i, %.37.i55.i.i.i
  %.39.i57.i.i.i = fadd contract double %.38.i56.i.i.i, 4.740000e-02
  %.40.i58.i.i.i = fmul contract double %.31.le.i53.i.i.i, %.39.i57.i.i.i
  %.41.i59.i.i.i = fadd contract double %.40.i58.i.i.i, 9.360000e-02
  %.42.i60.i.i.i = fmul contract double %.31.le.i53.i.i.i, %.41.i59.i.i.i
  %.43.i61.i.i.i = fadd contract double %.42.i60.i.i.i, 1.940000e-01
  %.44.i62.i.i.i = fcmp contract ogt double %.252.i.i, 1.000000e+00
  %.46.i63.i.i.i = uitofp i1 %.44.i62.i.i.i to double
  %.47.i64.i.i.i = fmul contract double %.43.i61.i.i.i, %.46.i63.i.i.i
  %.55.le.i65.i.i.i = tail call contract double @llvm.exp.f64(double %.47.i64.i.i.i)
  %.147.i.i67.i.i.i = fmul contract double %.26.i9.i.i.i, %.26.i9.i.i.i
  %.106.i70.i.i.i = fmul contract double %.55.le.i65.i.i.i, 5.000000e+01
  %.107.i71.i.i.i = fadd contract double %.106.i70.i.i.i, 6.250000e-01
  %191 = fmul contract double %.147.i.i67.i.i.i, %.107.i71.i.i.i
  %.109.i72.i.i.i = fsub contract double %.109.i.i.i.i, %191
  store double %.109.i72.i.i.i, ptr %.413.i.i.i.i, align 8, !noalias !43
  %.214.i75.i.i.i = fmul contract double %.38.i.i.i, 1.200000e+02
  %.215.i76.i.i.i = fsub contract double 0x407E92AAAAAAAAAB, %.214.i75.i.i.i
  %.216.i77.i.i.i = fmul contract double %.38.i.i.i, %.215.i76.i.i.i
  %.217.i78.i.i.i = fadd contract double %.216.i77.i.i.i, 0x40817F8618618618
  %.218.i79.i.i.i = fmul contract double %.217.i78.i.i.i, %.55.le.i65.i.i.i
  %.219.i80.i.i.i = fmul contract double %.38.i.i.i, 0x40416E38E38E38E4
  %.220.i81.i.i.i = fsub contract double 0x40569AAAAAAAAAAB, %.219.i80.i.i.i
  %.221.i82.i.i.i = fmul contract double %.38.i.i.i, %.220.i81.i.i.i
  %.222.i83.i.i.i = fadd contract double %.221.i82.i.i.i, 0x40831AC618618618
  %.223.i84.i.i.i = fsub contract double %.218.i79.i.i.i, %.222.i83.i.i.i
  %.224.i85.i.i.i = fmul contract double %.147.i.i67.i.i.i, %.223.i84.i.i.i
  %.225.i86.i.i.i = fadd contract double %.224.i85.i.i.i, %.225.i.i.i.i
  store double %.225.i86.i.i.i, ptr %.686.i.i.i.i, align 8, !noalias !43
  %.331.i89.i.i.i = fmul contract double %.147.i.i67.i.i.i, 0x4093A28C59D5433B
  %.332.i90.i.i.i = fmul contract double %.331.i89.i.i.i, %.55.le.i65.i.i.i
  %192 = fsub contract double %188, %.332.i90.i.i.i
  store double %192, ptr %.970.i.i.i.i, align 8, !noalias !43
  %.27.i.i.i.i = fmul contract double %.165.i.i, %.25.i.i4.i.i
  %.28.i.i.i.i = fmul contract double %.194.i.i, %.27.i.i.i.i
  %.82.i95.i.i.i = fmul contract double %.28.i.i.i.i, 9.875000e+01
  %193 = fsub contract double %.109.i72.i.i.i, %.82.i95.i.i.i
  store double %193, ptr %.413.i.i.i.i, align 8, !noalias !46
  %.188.i98.i.i.i = fmul contract double %.25.i.i4.i.i, 0x40735B8E38E38E39
  %.189.i99.i.i.i = fadd contract double %.188.i98.i.i.i, 0x40723BDB6DB6DB6E
  %.190.i100.i.i.i = fmul contract double %.28.i.i.i.i, %.189.i99.i.i.i
  %.191.i101.i.i.i = fadd contract double %.190.i100.i.i.i, %.225.i86.i.i.i
  store double %.191.i101.i.i.i, ptr %.686.i.i.i.i, align 8, !noalias !46
  %.245.i.i.i.i = fmul contract double %.194.i.i, %.24.i.i.i.i
  %.246.i.i.i.i = fsub contract double %.26.i.i.i.i, %.245.i.i.i.i
  %.147.i.i103.i.i.i = fmul contract double %.246.i.i.i.i, %.246.i.i.i.i
  %.301.i104.i.i.i = fmul contract double %.28.i.i.i.i, 8.000000e+02
  %.328.i105.i.i.i = fmul contract double %.147.i.i103.i.i.i, 7.500000e+00
  %.329.i106.i.i.i = fadd contract double %.301.i104.i.i.i, %.328.i105.i.i.i
  %.330.i.i.i.i = fmul contract double %.329.i106.i.i.i, 0x400921FB54442D18
  %194 = fsub contract double %192, %.330.i.i.i.i
  store double %194, ptr %.970.i.i.i.i, align 8, !noalias !46
  %.147.i.i107.i.i.i = fmul contract double %.33.i.i.i, %.33.i.i.i
  %.147.i.1.i.i.i.i = fmul contract double %.147.i.i107.i.i.i, %.147.i.i107.i.i.i
  %.50.i.i.i.i = fmul contract double %.147.i.1.i.i.i.i, -2.400000e+01
  %.51.i.i.i.i = fmul contract double %.223.i.i, %.50.i.i.i.i
  %.105.i.i.i.i = fmul contract double %.33.i.i.i, 1.100000e+01
  %.106.i110.i.i.i = fsub contract double 1.200000e+01, %.105.i.i.i.i
  %.107.i111.i.i.i = fmul contract double %.106.i110.i.i.i, %.51.i.i.i.i
  %.108.i.i.i.i = fadd contract double %.107.i111.i.i.i, %.1968.i.i.i.i
  store double %.108.i.i.i.i, ptr %.1867.i.i.i.i, align 8, !noalias !49
  %.212.i112.i.i.i = load double, ptr %.211.i.i.i.i, align 8, !noalias !49
  %.213.i113.i.i.i = fmul contract double %.51.i.i.i.i, 5.000000e+00
  %.217.i114.i.i.i = fdiv contract double %.213.i113.i.i.i, 6.720000e+02
  %.219.i116.i.i.i = fsub contract double 2.286000e+03, %.302.i.i.i.i
  %.220.i117.i.i.i = fmul contract double %.33.i.i.i, %.219.i116.i.i.i
  %.221.i118.i.i.i = fadd contract double %.220.i117.i.i.i, 9.190000e+02
  %.222.i119.i.i.i = fmul contract double %.33.i.i.i, %.221.i118.i.i.i
  %.223.i120.i.i.i = fsub contract double 3.179000e+03, %.222.i119.i.i.i
  %.224.i121.i.i.i = fmul contract double %.223.i120.i.i.i, %.217.i114.i.i.i
  %.225.i122.i.i.i = fadd contract double %.224.i121.i.i.i, %.212.i112.i.i.i
  store double %.225.i122.i.i.i, ptr %.211.i.i.i.i, align 8, !noalias !49
  %.329.i124.i.i.i = load double, ptr %.328.i123.i.i.i, align 8, !noalias !49
  %.331.i125.i.i.i = fmul contract double %.51.i.i.i.i, 0xC00921FB54442D18
  %.334.i.i.i.i = fmul contract double %.106.i110.i.i.i, %.331.i125.i.i.i
  %.335.i.i.i.i = fadd contract double %.334.i.i.i.i, %.329.i124.i.i.i
  store double %.335.i.i.i.i, ptr %.328.i123.i.i.i, align 8, !noalias !49
  %.387.i.i8.i.i = fmul contract double %.33.i.i.i, 0x4151712000000000
  %.388.i.i.i.i = fsub contract double 0x41737B1700000000, %.387.i.i8.i.i
  %.389.i.i.i.i = fmul contract double %.33.i.i.i, %.388.i.i.i.i
  %.390.i.i.i.i = fsub contract double 0x41A2E151D8000000, %.389.i.i.i.i
  %.443.i.i.i.i = load double, ptr %.442.i.i.i.i, align 8, !noalias !49
  %.448.i.i.i.i = fdiv contract double %.213.i113.i.i.i, 0x417A29B000000000
  %.449.i.i.i.i = fmul contract double %.33.i.i.i, %.390.i.i.i.i
  %.450.i.i.i.i = fadd contract double %.449.i.i.i.i, 0x41A4DB86E0000000
  %.451.i.i.i.i = fmul contract double %.33.i.i.i, %.450.i.i.i.i
  %.452.i.i.i.i = fadd contract double %.451.i.i.i.i, 0x41849F27B8000000
  %.453.i.i.i.i = fmul contract double %.33.i.i.i, %.452.i.i.i.i
  %.454.i.i.i.i = fsub contract double 0x41B72002EE000000, %.453.i.i.i.i
  %.455.i.i.i.i = fmul contract double %.448.i.i.i.i, %.454.i.i.i.i
  %.456.i.i.i.i = fadd contract double %.455.i.i.i.i, %.443.i.i.i.i
  store double %.456.i.i.i.i, ptr %.442.i.i.i.i, align 8, !noalias !49
  %.560.i.i.i.i = load double, ptr %.559.i.i.i.i, align 8, !noalias !49
  %.566.i.i.i.i = fdiv contract double %.331.i125.i.i.i, 6.720000e+02
  %.567.i.i.i.i = fmul contract double %.33.i.i.i, 1.052000e+04
  %.568.i.i.i.i = fsub contract double 7.598000e+03, %.567.i.i.i.i
  %.569.i.i.i.i = fmul contract double %.33.i.i.i, %.568.i.i.i.i
  %.570.i.i.i.i = fsub contract double 2.241500e+04, %.569.i.i.i.i
  %.571.i.i.i.i = fmul contract double %.33.i.i.i, %.570.i.i.i.i
  %.572.i.i.i.i = fsub contract double 2.771900e+04, %.571.i.i.i.i
  %.573.i.i.i.i = fmul contract double %.572.i.i.i.i, %.566.i.i.i.i
  %.574.i.i.i.i = fadd contract double %.573.i.i.i.i, %.560.i.i.i.i
  store double %.574.i.i.i.i, ptr %.559.i.i.i.i, align 8, !noalias !49
  %.147.i.i126.i.i.i = fmul contract double %.38.i.i.i, %.38.i.i.i
  %.147.i.1.i127.i.i.i = fmul contract double %.147.i.i126.i.i.i, %.147.i.i126.i.i.i
  %.50.i128.i.i.i = fmul contract double %.147.i.1.i127.i.i.i, -2.400000e+01
  %.51.i129.i.i.i = fmul contract double %.252.i.i, %.50.i128.i.i.i
  %.105.i132.i.i.i = fmul contract double %.38.i.i.i, 1.100000e+01
  %.106.i133.i.i.i = fsub contract double 1.200000e+01, %.105.i132.i.i.i
  %.107.i134.i.i.i = fmul contract double %.106.i133.i.i.i, %.51.i129.i.i.i
  %.108.i135.i.i.i = fadd contract double %.107.i134.i.i.i, %.108.i.i.i.i
  store double %.108.i135.i.i.i, ptr %.1867.i.i.i.i, align 8, !noalias !52
  %.213.i138.i.i.i = fmul contract double %.51.i129.i.i.i, 5.000000e+00
  %.217.i139.i.i.i = fdiv contract double %.213.i138.i.i.i, 6.720000e+02
  %.219.i141.i.i.i = fsub contract double 2.286000e+03, %.302.i29.i.i.i
  %.220.i142.i.i.i = fmul contract double %.38.i.i.i, %.219.i141.i.i.i
  %.221.i143.i.i.i = fadd contract double %.220.i142.i.i.i, 9.190000e+02
  %.222.i144.i.i.i = fmul contract double %.38.i.i.i, %.221.i143.i.i.i
  %.223.i145.i.i.i = fsub contract double 3.179000e+03, %.222.i144.i.i.i
  %.224.i146.i.i.i = fmul contract double %.223.i145.i.i.i, %.217.i139.i.i.i
  %.225.i147.i.i.i = fadd contract double %.224.i146.i.i.i, %.225.i122.i.i.i
  store double %.225.i147.i.i.i, ptr %.211.i.i.i.i, align 8, !noalias !52
  %.331.i150.i.i.i = fmul contract double %.51.i129.i.i.i, 0xC00921FB54442D18
  %.334.i151.i.i.i = fmul contract double %.106.i133.i.i.i, %.331.i150.i.i.i
  %.335.i152.i.i.i = fadd contract double %.334.i151.i.i.i, %.335.i.i.i.i
  store double %.335.i152.i.i.i, ptr %.328.i123.i.i.i, align 8, !noalias !52
  %.387.i153.i.i.i = fmul contract double %.38.i.i.i, 0x4151712000000000
  %.388.i154.i.i.i = fsub contract double 0x41737B1700000000, %.387.i153.i.i.i
  %.389.i155.i.i.i = fmul contract double %.38.i.i.i, %.388.i154.i.i.i
  %.390.i156.i.i.i = fsub contract double 0x41A2E151D8000000, %.389.i155.i.i.i
  %.448.i159.i.i.i = fdiv contract double %.213.i138.i.i.i, 0x417A29B000000000
  %.449.i160.i.i.i = fmul contract double %.38.i.i.i, %.390.i156.i.i.i
  %.450.i161.i.i.i = fadd contract double %.449.i160.i.i.i, 0x41A4DB86E0000000
  %.451.i162.i.i.i = fmul contract double %.38.i.i.i, %.450.i161.i.i.i
  %.452.i163.i.i.i = fadd contract double %.451.i162.i.i.i, 0x41849F27B8000000
  %.453.i164.i.i.i = fmul contract double %.38.i.i.i, %.452.i163.i.i.i
  %.454.i165.i.i.i = fsub contract double 0x41B72002EE000000, %.453.i164.i.i.i
  %.455.i166.i.i.i = fmul contract double %.448.i159.i.i.i, %.454.i165.i.i.i
  %.456.i167.i.i.i = fadd contract double %.455.i166.i.i.i, %.456.i.i.i.i
  store double %.456.i167.i.i.i, ptr %.442.i.i.i.i, align 8, !noalias !52
  %.566.i170.i.i.i = fdiv contract double %.331.i150.i.i.i, 6.720000e+02
  %.567.i171.i.i.i = fmul contract double %.38.i.i.i, 1.052000e+04
  %.568.i172.i.i.i = fsub contract double 7.598000e+03, %.567.i171.i.i.i
  %.569.i173.i.i.i = fmul contract double %.38.i.i.i, %.568.i172.i.i.i
  %.570.i174.i.i.i = fsub contract double 2.241500e+04, %.569.i173.i.i.i
  %.571.i175.i.i.i = fmul contract double %.38.i.i.i, %.570.i174.i.i.i
  %.572.i176.i.i.i = fsub contract double 2.771900e+04, %.571.i175.i.i.i
  %.573.i177.i.i.i = fmul contract double %.572.i176.i.i.i, %.566.i170.i.i.i
  %.574.i178.i.i.i = fadd contract double %.573.i177.i.i.i, %.574.i.i.i.i
  store double %.574.i178.i.i.i, ptr %.559.i.i.i.i, align 8, !noalias !52
  %.671.i.i.i = fmul contract double %.39.i2.i.i, 1.280000e+02
  %.675.i.i.i = fdiv contract double 3.000000e+00, %.671.i.i.i
  store double %.675.i.i.i, ptr %arg.series, align 8, !noalias !28
  %.968.1.i.i.i = load double, ptr %9, align 8, !noalias !28
  %.970.1.i.i.i = fmul contract double %.675.i.i.i, %.968.1.i.i.i
  store double %.970.1.i.i.i, ptr %9, align 8, !noalias !28
  %.970.2.i.i.i = fmul contract double %.675.i.i.i, %.204.i.i.i.i
  store double %.970.2.i.i.i, ptr %.183.i.i.i.i, align 8, !noalias !28
  %.970.3.i.i.i = fmul contract double %.675.i.i.i, %.83.i15.i.i.i
  store double %.970.3.i.i.i, ptr %.308.i.i.i.i, align 8, !noalias !28
  %.970.4.i.i.i = fmul contract double %.675.i.i.i, %193
  store double %.970.4.i.i.i, ptr %.413.i.i.i.i, align 8, !noalias !28
  %.968.5.i.i.i = load double, ptr %10, align 8, !noalias !28
  %.970.5.i.i.i = fmul contract double %.675.i.i.i, %.968.5.i.i.i
  store double %.970.5.i.i.i, ptr %10, align 8, !noalias !28
  %.970.6.i.i.i = fmul contract double %.675.i.i.i, %.191.i101.i.i.i
  store double %.970.6.i.i.i, ptr %.686.i.i.i.i, align 8, !noalias !28
  %.970.7.i.i.i = fmul contract double %.675.i.i.i, %194
  store double %.970.7.i.i.i, ptr %.970.i.i.i.i, align 8, !noalias !28
  %.968.8.i.i.i = load double, ptr %11, align 8, !noalias !28
  %.970.8.i.i.i = fmul contract double %.675.i.i.i, %.968.8.i.i.i
  store double %.970.8.i.i.i, ptr %11, align 8, !noalias !28
  %.970.9.i.i.i = fmul contract double %.675.i.i.i, %.1537.i.i.i.i
  store double %.970.9.i.i.i, ptr %.1461.i.i.i.i, align 8, !noalias !28
  %.970.10.i.i.i = fmul contract double %.675.i.i.i, %.108.i135.i.i.i
  store double %.970.10.i.i.i, ptr %.1867.i.i.i.i, align 8, !noalias !28
  %.970.11.i.i.i = fmul contract double %.675.i.i.i, %.2371.i.i.i.i
  store double %.970.11.i.i.i, ptr %.2256.i.i.i.i, align 8, !noalias !28
  %.970.12.i.i.i = fmul contract double %.675.i.i.i, %.225.i147.i.i.i
  store double %.970.12.i.i.i, ptr %.211.i.i.i.i, align 8, !noalias !28
  %.970.13.i.i.i = fmul contract double %.675.i.i.i, %.335.i152.i.i.i
  store double %.970.13.i.i.i, ptr %.328.i123.i.i.i, align 8, !noalias !28
  %.970.14.i.i.i = fmul contract double %.675.i.i.i, %.456.i167.i.i.i
  store double %.970.14.i.i.i, ptr %.442.i.i.i.i, align 8, !noalias !28
  %.970.15.i.i.i = fmul contract double %.675.i.i.i, %.574.i178.i.i.i
  store double %.970.15.i.i.i, ptr %.559.i.i.i.i, align 8, !noalias !28
  %.968.1276.i.i.i = load double, ptr %8, align 8, !noalias !28
  %.970.1277.i.i.i = fmul contract double %.675.i.i.i, %.968.1276.i.i.i
  store double %.970.1277.i.i.i, ptr %8, align 8, !noalias !28
  %.968.1.1.i.i.i = load double, ptr %12, align 8, !noalias !28
  %.970.1.1.i.i.i = fmul contract double %.675.i.i.i, %.968.1.1.i.i.i
  store double %.970.1.1.i.i.i, ptr %12, align 8, !noalias !28
  %.968.2.1.i.i.i = load double, ptr %13, align 8, !noalias !28
  %.970.2.1.i.i.i = fmul contract double %.675.i.i.i, %.968.2.1.i.i.i
  store double %.970.2.1.i.i.i, ptr %13, align 8, !noalias !28
  %.968.3.1.i.i.i = load double, ptr %14, align 8, !noalias !28
  %.970.3.1.i.i.i = fmul contract double %.675.i.i.i, %.968.3.1.i.i.i
  store double %.970.3.1.i.i.i, ptr %14, align 8, !noalias !28
  %.968.4.1.i.i.i = load double, ptr %15, align 8, !noalias !28
  %.970.4.1.i.i.i = fmul contract double %.675.i.i.i, %.968.4.1.i.i.i
  store double %.970.4.1.i.i.i, ptr %15, align 8, !noalias !28
  %.970.5.1.i.i.i = fmul contract double %.675.i.i.i, %184
  store double %.970.5.1.i.i.i, ptr %.561.i.i.i.i, align 8, !noalias !28
  %.970.6.1.i.i.i = fmul contract double %.675.i.i.i, %.867.i.i.i.i
  store double %.970.6.1.i.i.i, ptr %.865.i.i.i.i, align 8, !noalias !28
  %.968.7.1.i.i.i = load double, ptr %16, align 8, !noalias !28
  %.970.7.1.i.i.i = fmul contract double %.675.i.i.i, %.968.7.1.i.i.i
  store double %.970.7.1.i.i.i, ptr %16, align 8, !noalias !28
  %.970.8.1.i.i.i = fmul contract double %.675.i.i.i, %.1233.i.i.i.i
  store double %.970.8.1.i.i.i, ptr %.1118.i.i.i.i, align 8, !noalias !28
  %.970.9.1.i.i.i = fmul contract double %.675.i.i.i, %.1642.i.i.i.i
  store double %.970.9.1.i.i.i, ptr %.1640.i.i.i.i, align 8, !noalias !28
  %.970.10.1.i.i.i = fmul contract double %.675.i.i.i, %.2153.i.i.i.i
  store double %.970.10.1.i.i.i, ptr %.2145.i.i.i.i, align 8, !noalias !28
  %.970.11.1.i.i.i = fmul contract double %.675.i.i.i, %.2496.i.i.i.i
  store double %.970.11.1.i.i.i, ptr %.2474.i.i.i.i, align 8, !noalias !28
  %.968.12.1.i.i.i = load double, ptr %17, align 8, !noalias !28
  %.970.12.1.i.i.i = fmul contract double %.675.i.i.i, %.968.12.1.i.i.i
  store double %.970.12.1.i.i.i, ptr %17, align 8, !noalias !28
  %.968.13.1.i.i.i = load double, ptr %18, align 8, !noalias !28
  %.970.13.1.i.i.i = fmul contract double %.675.i.i.i, %.968.13.1.i.i.i
  store double %.970.13.1.i.i.i, ptr %18, align 8, !noalias !28
  %.968.14.1.i.i.i = load double, ptr %19, align 8, !noalias !28
  %.970.14.1.i.i.i = fmul contract double %.675.i.i.i, %.968.14.1.i.i.i
  store double %.970.14.1.i.i.i, ptr %19, align 8, !noalias !28
  %.968.15.1.i.i.i = load double, ptr %20, align 8, !noalias !28
  %.970.15.1.i.i.i = fmul contract double %.675.i.i.i, %.968.15.1.i.i.i
  store double %.970.15.1.i.i.i, ptr %20, align 8, !noalias !28
  %.968.2278.i.i.i = load double, ptr %21, align 8, !noalias !28
  %.970.2279.i.i.i = fmul contract double %.675.i.i.i, %.968.2278.i.i.i
  store double %.970.2279.i.i.i, ptr %21, align 8, !noalias !28
  %.968.1.2.i.i.i = load double, ptr %22, align 8, !noalias !28
  %.970.1.2.i.i.i = fmul contract double %.675.i.i.i, %.968.1.2.i.i.i
  store double %.970.1.2.i.i.i, ptr %22, align 8, !noalias !28
  %.968.2.2.i.i.i = load double, ptr %23, align 8, !noalias !28
  %.970.2.2.i.i.i = fmul contract double %.675.i.i.i, %.968.2.2.i.i.i
  store double %.970.2.2.i.i.i, ptr %23, align 8, !noalias !28
  %.968.3.2.i.i.i = load double, ptr %24, align 8, !noalias !28
  %.970.3.2.i.i.i = fmul contract double %.675.i.i.i, %.968.3.2.i.i.i
  store double %.970.3.2.i.i.i, ptr %24, align 8, !noalias !28
  %.968.4.2.i.i.i = load double, ptr %25, align 8, !noalias !28
  %.970.4.2.i.i.i = fmul contract double %.675.i.i.i, %.968.4.2.i.i.i
  store double %.970.4.2.i.i.i, ptr %25, align 8, !noalias !28
  %.968.5.2.i.i.i = load double, ptr %26, align 8, !noalias !28
  %.970.5.2.i.i.i = fmul contract double %.675.i.i.i, %.968.5.2.i.i.i
  store double %.970.5.2.i.i.i, ptr %26, align 8, !noalias !28
  %.968.6.2.i.i.i = load double, ptr %27, align 8, !noalias !28
  %.970.6.2.i.i.i = fmul contract double %.675.i.i.i, %.968.6.2.i.i.i
  store double %.970.6.2.i.i.i, ptr %27, align 8, !noalias !28
  %.968.7.2.i.i.i = load double, ptr %28, align 8, !noalias !28
  %.970.7.2.i.i.i = fmul contract double %.675.i.i.i, %.968.7.2.i.i.i
  store double %.970.7.2.i.i.i, ptr %28, align 8, !noalias !28
  %.970.8.2.i.i.i = fmul contract double %.675.i.i.i, %.1358.i.i.i.i
  store double %.970.8.2.i.i.i, ptr %.1336.i.i.i.i, align 8, !noalias !28
  %.968.9.2.i.i.i = load double, ptr %29, align 8, !noalias !28
  %.970.9.2.i.i.i = fmul contract double %.675.i.i.i, %.968.9.2.i.i.i
  store double %.970.9.2.i.i.i, ptr %29, align 8, !noalias !28
  %.968.10.2.i.i.i = load double, ptr %30, align 8, !noalias !28
  %.970.10.2.i.i.i = fmul contract double %.675.i.i.i, %.968.10.2.i.i.i
  store double %.970.10.2.i.i.i, ptr %30, align 8, !noalias !28
  %.968.11.2.i.i.i = load double, ptr %31, align 8, !noalias !28
  %.970.11.2.i.i.i = fmul contract double %.675.i.i.i, %.968.11.2.i.i.i
  store double %.970.11.2.i.i.i, ptr %31, align 8, !noalias !28
  %.968.12.2.i.i.i = load double, ptr %32, align 8, !noalias !28
  %.970.12.2.i.i.i = fmul contract double %.675.i.i.i, %.968.12.2.i.i.i
  store double %.970.12.2.i.i.i, ptr %32, align 8, !noalias !28
  %.968.13.2.i.i.i = load double, ptr %33, align 8, !noalias !28
  %.970.13.2.i.i.i = fmul contract double %.675.i.i.i, %.968.13.2.i.i.i
  store double %.970.13.2.i.i.i, ptr %33, align 8, !noalias !28
  %.968.14.2.i.i.i = load double, ptr %34, align 8, !noalias !28
  %.970.14.2.i.i.i = fmul contract double %.675.i.i.i, %.968.14.2.i.i.i
  store double %.970.14.2.i.i.i, ptr %34, align 8, !noalias !28
  %.968.15.2.i.i.i = load double, ptr %35, align 8, !noalias !28
  %.970.15.2.i.i.i = fmul contract double %.675.i.i.i, %.968.15.2.i.i.i
  store double %.970.15.2.i.i.i, ptr %35, align 8, !noalias !28
  %.54.i.i.i = fsub contract double %.165.i.i, %.194.i.i
  %.147.i.i.i.i = fmul contract double %.54.i.i.i, %.54.i.i.i
  %.147.i.i.i10.i.i = fmul contract double %.29.i.i.i, %.29.i.i.i
  %.35.i.i11.i.i = fdiv contract double %.136.i.i, %.147.i.i.i10.i.i
  %.45.i.i.i = fadd contract double %.136.i.i, -1.000000e+00
  %.50.i.i.i = fdiv contract double %.45.i.i.i, %.29.i.i.i
  %.51.i.i.i = fadd contract double %.165.i.i, %.194.i.i
  %.52.i.i.i = fmul contract double %.51.i.i.i, 5.000000e-01
  %.53.i.i.i = fmul contract double %.50.i.i.i, 5.000000e-01
  %.55.i.i.i = fmul contract double %.53.i.i.i, %.54.i.i.i
  %.81.i.i.i = fmul contract double %.147.i.i.i.i, 2.500000e-01
  store double 1.000000e+00, ptr %.793.i, align 8, !noalias !55
  store double 0.000000e+00, ptr %.138.i.i.i, align 8, !noalias !55
  %.140.i.i.i = fmul contract double %.35.i.i11.i.i, 0x400579E79E79E79E
  %.141.i.i.i = fadd contract double %.140.i.i.i, 0xBFF7124924924925
  store double %.141.i.i.i, ptr %.169.i.i.i, align 8, !noalias !55
  %.171.i.i.i = fmul contract double %.55.i.i.i, 3.375000e+00
  %.172.i.i.i = fmul contract double %.35.i.i11.i.i, 0x3FFD555555555555
  %.173.i.i.i = fsub contract double 3.375000e+00, %.172.i.i.i
  %.174.i.i.i = fmul contract double %.52.i.i.i, %.173.i.i.i
  %.175.i.i.i = fadd contract double %.171.i.i.i, %.174.i.i.i
  store double %.175.i.i.i, ptr %.203.i.i.i, align 8, !noalias !55
  %.205.i.i.i = fmul contract double %.35.i.i11.i.i, 0x401167EA53FA94FF
  %.206.i.i.i = fadd contract double %.205.i.i.i, 0xC0175371959340D3
  %.207.i.i.i = fmul contract double %.35.i.i11.i.i, %.206.i.i.i
  %.208.i.i.i = fadd contract double %.207.i.i.i, 0xC00AE15A0AB4FC95
  %.267.i.i.i = fmul contract double %.35.i.i11.i.i, 6.000000e+00
  %.268.i.i.i = fadd contract double %.267.i.i.i, -1.531250e+00
  %.269.i.i.i = fmul contract double %.268.i.i.i, %.81.i.i.i
  %.270.i.i.i = fmul contract double %.55.i.i.i, 3.062500e+00
  %.271.i.i.i = fmul contract double %.52.i.i.i, %.270.i.i.i
  %.272.i.i.i = fsub contract double %.269.i.i.i, %.271.i.i.i
  %.273.i.i.i = fadd contract double %.208.i.i.i, %.272.i.i.i
  %.147.i15.i.i.i = fmul contract double %.52.i.i.i, %.52.i.i.i
  %.335.i.i.i = fmul contract double %.35.i.i11.i.i, 1.250000e-01
  %.336.i.i.i = fadd contract double %.335.i.i.i, -1.531250e+00
  %.361.i.i.i = fmul contract double %.336.i.i.i, %.147.i15.i.i.i
  %.362.i.i.i = fadd contract double %.361.i.i.i, %.273.i.i.i
  store double %.362.i.i.i, ptr %.236.i.i.i, align 8, !noalias !55
  %.393.i.i.i = fmul contract double %.35.i.i11.i.i, 4.000000e+00
  %.394.i.i.i = fsub contract double 1.000000e+00, %.393.i.i.i
  %.395.i.i.i = fmul contract double %.394.i.i.i, 0x4010B090E5F545F2
  %.396.i.i.i = fmul contract double %.35.i.i11.i.i, 0x3FD9104104104104
  %.397.i.i.i = fsub contract double 0x4031AEEFBEFBEFBF, %.396.i.i.i
  %.398.i.i.i = fmul contract double %.55.i.i.i, %.397.i.i.i
  %195 = fsub contract double %.398.i.i.i, %.395.i.i.i
  %.458.i.i.i = fmul contract double %.35.i.i11.i.i, 0x4001ACB2CB2CB2CB
  %.459.i.i.i = fadd contract double %.458.i.i.i, 0x4036CB0C30C30C31
  %.460.i.i.i = fmul contract double %.35.i.i11.i.i, %.459.i.i.i
  %.461.i.i.i = fsub contract double 0x4031AEEFBEFBEFBF, %.460.i.i.i
  %.462.i.i.i = fmul contract double %.52.i.i.i, %.461.i.i.i
  %.463.i.i.i = fadd contract double %195, %.462.i.i.i
  store double %.463.i.i.i, ptr %.427.i.i.i, align 8, !noalias !55
  %.519.i.i.i = fmul contract double %.35.i.i11.i.i, 0x4050B13F2FF5EE90
  %.520.i.i.i = fadd contract double %.519.i.i.i, 0xC034AE5A84540D99
  %.147.i39.i.i.i = fmul contract double %.35.i.i11.i.i, %.35.i.i11.i.i
  %.603.i.i.i = fmul contract double %.35.i.i11.i.i, 0x401597306EFC97DE
  %.604.i.i.i = fadd contract double %.603.i.i.i, 0xC0322AE304374842
  %.605.i.i.i = fmul contract double %.147.i39.i.i.i, %.604.i.i.i
  %.606.i.i.i = fadd contract double %.520.i.i.i, %.605.i.i.i
  %.665.i.i.i = fmul contract double %.55.i.i.i, 0x4004AAAAAAAAAAAB
  %.666.i.i.i = fmul contract double %.35.i.i11.i.i, 0x4002AAAAAAAAAAAB
  %.667.i.i.i = fsub contract double 0x4004AAAAAAAAAAAB, %.666.i.i.i
  %.668.i.i.i = fmul contract double %.52.i.i.i, %.667.i.i.i
  %.669.i.i.i = fadd contract double %.665.i.i.i, %.668.i.i.i
  %.670.i.i.i = fmul contract double %.669.i.i.i, 0x400921FB54442D18
  %.671.i12.i.i = fadd contract double %.606.i.i.i, %.670.i.i.i
  %.730.i.i.i = fmul contract double %.35.i.i11.i.i, 0x4017618618618618
  %.731.i.i.i = fadd contract double %.730.i.i.i, 0x404C130E38E38E39
  %.732.i.i.i = fmul contract double %.35.i.i11.i.i, %.731.i.i.i
  %.733.i.i.i = fadd contract double %.732.i.i.i, 0xC02B20D145145145
  %.734.i.i.i = fmul contract double %.81.i.i.i, %.733.i.i.i
  %.735.i.i.i = fadd contract double %.734.i.i.i, %.671.i12.i.i
  %.794.i.i.i = fmul contract double %.35.i.i11.i.i, 0x4043F51861861862
  %.795.i.i.i = fadd contract double %.794.i.i.i, 0xC03B20D145145145
  %.796.i.i.i = fmul contract double %.55.i.i.i, %.795.i.i.i
  %.797.i.i.i = fmul contract double %.52.i.i.i, %.796.i.i.i
  %.798.i.i.i = fadd contract double %.797.i.i.i, %.735.i.i.i
  %.857.i.i.i = fmul contract double %.35.i.i11.i.i, 0x402975F7DF7DF7DF
  %.858.i.i.i = fsub contract double 0x404302DB6DB6DB6E, %.857.i.i.i
  %.859.i.i.i = fmul contract double %.35.i.i11.i.i, %.858.i.i.i
  %.860.i.i.i = fadd contract double %.859.i.i.i, 0xC02B20D145145145
  %.885.i.i.i = fmul contract double %.147.i15.i.i.i, %.860.i.i.i
  %.886.i.i.i = fadd contract double %.885.i.i.i, %.798.i.i.i
  store double %.886.i.i.i, ptr %.548.i.i.i, align 8, !noalias !55
  %.916.i.i.i = fmul contract double %.35.i.i11.i.i, 0x402001CC877321DD
  %.917.i.i.i = fsub contract double 0x403044E0D8B8362E, %.916.i.i.i
  %.918.i.i.i = fmul contract double %.35.i.i11.i.i, %.917.i.i.i
  %.919.i.i.i = fsub contract double 0x400A4763546E2A71, %.918.i.i.i
  %.920.i.i.i = fmul contract double %.919.i.i.i, 0x400921FB54442D18
  store double %.920.i.i.i, ptr %.948.i.i.i, align 8, !noalias !55
  %.39.i.i.i = fdiv contract double 0x3FE4F1A6C638D03F, %.35.i.i11.i.i
  %.47.i.i.i = tail call contract double @sqrt(double %.39.i.i.i)
  store double %.47.i.i.i, ptr %.793.i, align 8, !noalias !6
  %.1210.1.i.i = fmul contract double %.47.i.i.i, 0.000000e+00
  store double %.1210.1.i.i, ptr %.138.i.i.i, align 8, !noalias !6
  %.1210.2.i.i = fmul contract double %.141.i.i.i, %.47.i.i.i
  store double %.1210.2.i.i, ptr %.169.i.i.i, align 8, !noalias !6
  %.1210.3.i.i = fmul contract double %.175.i.i.i, %.47.i.i.i
  store double %.1210.3.i.i, ptr %.203.i.i.i, align 8, !noalias !6
  %.1210.4.i.i = fmul contract double %.362.i.i.i, %.47.i.i.i
  store double %.1210.4.i.i, ptr %.236.i.i.i, align 8, !noalias !6
  %.1210.5.i.i = fmul contract double %.463.i.i.i, %.47.i.i.i
  store double %.1210.5.i.i, ptr %.427.i.i.i, align 8, !noalias !6
  %.1210.6.i.i = fmul contract double %.886.i.i.i, %.47.i.i.i
  store double %.1210.6.i.i, ptr %.548.i.i.i, align 8, !noalias !6
  %.1210.7.i.i = fmul contract double %.920.i.i.i, %.47.i.i.i
  store double %.1210.7.i.i, ptr %.948.i.i.i, align 8, !noalias !6
  br i1 %36, label %B500.i, label %B586.i

B714.else.if.i:                                   ; preds = %B714.i
  br label %B714.else.endif.i

B714.else.endif.i:                                ; preds = %B714.else.if.i, %B714.i
  %.1770.sroa.0.1.i = phi i64 [ 0, %B714.else.if.i ], [ %.1782.i, %B714.i ]
  %.1790.not.i = icmp slt i64 %.1782.i, %arg.n_polar
  br i1 %.1790.not.i, label %B714.else.endif.endif.i, label %B714.else.endif.if.i, !prof !5

B714.else.endif.if.i:                             ; preds = %B714.else.endif.i
  br label %B714.else.endif.endif.i

B714.else.endif.endif.i:                          ; preds = %B714.else.endif.if.i, %B714.else.endif.i
  %.1770.sroa.0.3.i = phi i64 [ %arg.n_polar, %B714.else.endif.if.i ], [ %.1770.sroa.0.1.i, %B714.else.endif.i ]
  %.1797.i = icmp slt i64 %.1743.i, 0
  %.1798.i = select i1 %.1797.i, i64 %arg.n_polar, i64 0
  %.1799.i = add i64 %.1798.i, %.1743.i
  %.1802.i = icmp slt i64 %.1799.i, 0
  br i1 %.1802.i, label %B714.else.endif.endif.if.i, label %B714.else.endif.endif.endif.i, !prof !4

B714.else.endif.endif.if.i:                       ; preds = %B714.else.endif.endif.i
  br label %B714.else.endif.endif.endif.i

B714.else.endif.endif.endif.i:                    ; preds = %B714.else.endif.endif.if.i, %B714.else.endif.endif.i
  %.1770.sroa.13.1.i = phi i64 [ 0, %B714.else.endif.endif.if.i ], [ %.1799.i, %B714.else.endif.endif.i ]
  %.1807.not.i = icmp slt i64 %.1799.i, %arg.n_polar
  br i1 %.1807.not.i, label %B714.else.endif.endif.endif.endif.i, label %B714.else.endif.endif.endif.if.i, !prof !5

B714.else.endif.endif.endif.if.i:                 ; preds = %B714.else.endif.endif.endif.i
  br label %B714.else.endif.endif.endif.endif.i

B714.else.endif.endif.endif.endif.i:              ; preds = %B714.else.endif.endif.endif.if.i, %B714.else.endif.endif.endif.i
  %.1770.sroa.13.2.i = phi i64 [ %arg.n_polar, %B714.else.endif.endif.endif.if.i ], [ %.1770.sroa.13.1.i, %B714.else.endif.endif.endif.i ]
  %.1858.i = sub nsw i64 %.1770.sroa.13.2.i, %.1770.sroa.0.3.i
  %.1867.i = tail call i64 @llvm.smax.i64(i64 %.1858.i, i64 0)
  %.1883.i = getelementptr double, ptr %arg.amplitude, i64 %.1770.sroa.0.3.i
  br i1 %.1785.i, label %B714.endif.else.if.i, label %B714.endif.else.endif.i, !prof !4

B714.endif.else.if.i:                             ; preds = %B714.else.endif.endif.endif.endif.i
  br label %B714.endif.else.endif.i

B714.endif.else.endif.i:                          ; preds = %B714.endif.else.if.i, %B714.else.endif.endif.endif.endif.i
  %.1964.sroa.0.1.i = phi i64 [ 0, %B714.endif.else.if.i ], [ %.1782.i, %B714.else.endif.endif.endif.endif.i ]
  br i1 %.1790.not.i, label %B714.endif.else.endif.endif.i, label %B714.endif.else.endif.if.i, !prof !5

B714.endif.else.endif.if.i:                       ; preds = %B714.endif.else.endif.i
  br label %B714.endif.else.endif.endif.i

B714.endif.else.endif.endif.i:                    ; preds = %B714.endif.else.endif.if.i, %B714.endif.else.endif.i
  %.1964.sroa.0.3.i = phi i64 [ %arg.n_polar, %B714.endif.else.endif.if.i ], [ %.1964.sroa.0.1.i, %B714.endif.else.endif.i ]
  br i1 %.1802.i, label %B714.endif.else.endif.endif.if.i, label %B714.endif.else.endif.endif.endif.i, !prof !4

B714.endif.else.endif.endif.if.i:                 ; preds = %B714.endif.else.endif.endif.i
  br label %B714.endif.else.endif.endif.endif.i

B714.endif.else.endif.endif.endif.i:              ; preds = %B714.endif.else.endif.endif.if.i, %B714.endif.else.endif.endif.i
  %.1964.sroa.13.1.i = phi i64 [ 0, %B714.endif.else.endif.endif.if.i ], [ %.1799.i, %B714.endif.else.endif.endif.i ]
  br i1 %.1807.not.i, label %B714.endif.else.endif.endif.endif.endif.i, label %B714.endif.else.endif.endif.endif.if.i, !prof !5

B714.endif.else.endif.endif.endif.if.i:           ; preds = %B714.endif.else.endif.endif.endif.i
  br label %B714.endif.else.endif.endif.endif.endif.i

B714.endif.else.endif.endif.endif.endif.i:        ; preds = %B714.endif.else.endif.endif.endif.if.i, %B714.endif.else.endif.endif.endif.i
  %.1964.sroa.13.2.i = phi i64 [ %arg.n_polar, %B714.endif.else.endif.endif.endif.if.i ], [ %.1964.sroa.13.1.i, %B714.endif.else.endif.endif.endif.i ]
  %.2052.i = sub nsw i64 %.1964.sroa.13.2.i, %.1964.sroa.0.3.i
  %.2061.i = tail call i64 @llvm.smax.i64(i64 %.2052.i, i64 0)
  %.2077.i = getelementptr double, ptr %arg.phase, i64 %.1964.sroa.0.3.i
  br label %B876.i

B792.else.if.i:                                   ; preds = %B792.i
  br label %B792.else.endif.i

B792.else.endif.i:                                ; preds = %B792.else.if.i, %B792.i
  %.2155.sroa.0.1.i = phi i64 [ 0, %B792.else.if.i ], [ %.709.i, %B792.i ]
  br i1 %.717.not.i, label %B792.else.endif.endif.i, label %B792.else.endif.if.i, !prof !5

B792.else.endif.if.i:                             ; preds = %B792.else.endif.i
  br label %B792.else.endif.endif.i

B792.else.endif.endif.i:                          ; preds = %B792.else.endif.if.i, %B792.else.endif.i
  %.2155.sroa.0.3.i = phi i64 [ %arg.n_scratch, %B792.else.endif.if.i ], [ %.2155.sroa.0.1.i, %B792.else.endif.i ]
  %.2182.i = icmp slt i64 %.2127.i, 0
  %.2183.i = select i1 %.2182.i, i64 %arg.n_scratch, i64 0
  %.2184.i = add i64 %.2183.i, %.2127.i
  %.2187.i = icmp slt i64 %.2184.i, 0
  br i1 %.2187.i, label %B792.else.endif.endif.if.i, label %B792.else.endif.endif.endif.i, !prof !4

B792.else.endif.endif.if.i:                       ; preds = %B792.else.endif.endif.i
  br label %B792.else.endif.endif.endif.i

B792.else.endif.endif.endif.i:                    ; preds = %B792.else.endif.endif.if.i, %B792.else.endif.endif.i
  %.2155.sroa.13.1.i = phi i64 [ 0, %B792.else.endif.endif.if.i ], [ %.2184.i, %B792.else.endif.endif.i ]
  %.2192.not.i = icmp slt i64 %.2184.i, %arg.n_scratch
  br i1 %.2192.not.i, label %B792.else.endif.endif.endif.endif.i, label %B792.else.endif.endif.endif.if.i, !prof !5

B792.else.endif.endif.endif.if.i:                 ; preds = %B792.else.endif.endif.endif.i
  br label %B792.else.endif.endif.endif.endif.i

B792.else.endif.endif.endif.endif.i:              ; preds = %B792.else.endif.endif.endif.if.i, %B792.else.endif.endif.endif.i
  %.2155.sroa.13.2.i = phi i64 [ %arg.n_scratch, %B792.else.endif.endif.endif.if.i ], [ %.2155.sroa.13.1.i, %B792.else.endif.endif.endif.i ]
  %.2243.i = sub i64 %.2155.sroa.13.2.i, %.2155.sroa.0.3.i
  %.2252.i = tail call i64 @llvm.smax.i64(i64 %.2243.i, i64 0)
  %.2268.i = getelementptr double, ptr %arg.scratch, i64 %.2155.sroa.0.3.i
  %.2316.i = add nsw i64 %.1722.i, %.2312.i
  br i1 %55, label %B792.endif.else.if.i, label %B792.endif.else.endif.i, !prof !4

B792.endif.else.if.i:                             ; preds = %B792.else.endif.endif.endif.endif.i
  br label %B792.endif.else.endif.i

B792.endif.else.endif.i:                          ; preds = %B792.endif.else.if.i, %B792.else.endif.endif.endif.endif.i
  %.2343.sroa.0.1.i = phi i64 [ 0, %B792.endif.else.if.i ], [ %.2355.i, %B792.else.endif.endif.endif.endif.i ]
  br i1 %56, label %B792.endif.else.endif.endif.i, label %B792.endif.else.endif.if.i, !prof !5

B792.endif.else.endif.if.i:                       ; preds = %B792.endif.else.endif.i
  br label %B792.endif.else.endif.endif.i

B792.endif.else.endif.endif.i:                    ; preds = %B792.endif.else.endif.if.i, %B792.endif.else.endif.i
  %.2343.sroa.0.3.i = phi i64 [ %arg.n_scratch, %B792.endif.else.endif.if.i ], [ %.2343.sroa.0.1.i, %B792.endif.else.endif.i ]
  %.2370.i = icmp slt i64 %.2316.i, 0
  %.2371.i = select i1 %.2370.i, i64 %arg.n_scratch, i64 0
  %.2372.i = add i64 %.2371.i, %.2316.i
  %.2375.i = icmp slt i64 %.2372.i, 0
  br i1 %.2375.i, label %B792.endif.else.endif.endif.if.i, label %B792.endif.else.endif.endif.endif.i, !prof !4

B792.endif.else.endif.endif.if.i:                 ; preds = %B792.endif.else.endif.endif.i
  br label %B792.endif.else.endif.endif.endif.i

B792.endif.else.endif.endif.endif.i:              ; preds = %B792.endif.else.endif.endif.if.i, %B792.endif.else.endif.endif.i
  %.2343.sroa.13.1.i = phi i64 [ 0, %B792.endif.else.endif.endif.if.i ], [ %.2372.i, %B792.endif.else.endif.endif.i ]
  %.2380.not.i = icmp slt i64 %.2372.i, %arg.n_scratch
  br i1 %.2380.not.i, label %B792.endif.else.endif.endif.endif.endif.i, label %B792.endif.else.endif.endif.endif.if.i, !prof !5

B792.endif.else.endif.endif.endif.if.i:           ; preds = %B792.endif.else.endif.endif.endif.i
  br label %B792.endif.else.endif.endif.endif.endif.i

B792.endif.else.endif.endif.endif.endif.i:        ; preds = %B792.endif.else.endif.endif.endif.if.i, %B792.endif.else.endif.endif.endif.i
  %.2343.sroa.13.2.i = phi i64 [ %arg.n_scratch, %B792.endif.else.endif.endif.endif.if.i ], [ %.2343.sroa.13.1.i, %B792.endif.else.endif.endif.endif.i ]
  %.2431.i = sub i64 %.2343.sroa.13.2.i, %.2343.sroa.0.3.i
  %.2440.i = tail call i64 @llvm.smax.i64(i64 %.2431.i, i64 0)
  %.2456.i = getelementptr double, ptr %arg.scratch, i64 %.2343.sroa.0.3.i
  br label %B876.i

B876.else.if.i:                                   ; preds = %B876.i
  br label %B876.else.endif.i

B876.else.endif.i:                                ; preds = %B876.else.if.i, %B876.i
  %.2528.sroa.0.1.i = phi i64 [ 0, %B876.else.if.i ], [ %.2540.i, %B876.i ]
  %.2548.not.i = icmp slt i64 %.2540.i, %arg.points
  br i1 %.2548.not.i, label %B876.else.endif.endif.i, label %B876.else.endif.if.i, !prof !5

B876.else.endif.if.i:                             ; preds = %B876.else.endif.i
  br label %B876.else.endif.endif.i

B876.else.endif.endif.i:                          ; preds = %B876.else.endif.if.i, %B876.else.endif.i
  %.2528.sroa.0.3.i = phi i64 [ %arg.points, %B876.else.endif.if.i ], [ %.2528.sroa.0.1.i, %B876.else.endif.i ]
  %.2555.i = icmp slt i64 %.13.i.i, 0
  %.2556.i = select i1 %.2555.i, i64 %arg.points, i64 0
  %.2557.i = add i64 %.2556.i, %.13.i.i
  %.2560.i = icmp slt i64 %.2557.i, 0
  br i1 %.2560.i, label %B876.else.endif.endif.if.i, label %B876.else.endif.endif.endif.i, !prof !4

B876.else.endif.endif.if.i:                       ; preds = %B876.else.endif.endif.i
  br label %B876.else.endif.endif.endif.i

B876.else.endif.endif.endif.i:                    ; preds = %B876.else.endif.endif.if.i, %B876.else.endif.endif.i
  %.2528.sroa.13.1.i = phi i64 [ 0, %B876.else.endif.endif.if.i ], [ %.2557.i, %B876.else.endif.endif.i ]
  %.2565.not.i = icmp slt i64 %.2557.i, %arg.points
  br i1 %.2565.not.i, label %B876.else.endif.endif.endif.endif.i, label %B876.else.endif.endif.endif.if.i, !prof !5

B876.else.endif.endif.endif.if.i:                 ; preds = %B876.else.endif.endif.endif.i
  br label %B876.else.endif.endif.endif.endif.i

B876.else.endif.endif.endif.endif.i:              ; preds = %B876.else.endif.endif.endif.if.i, %B876.else.endif.endif.endif.i
  %.2528.sroa.13.2.i = phi i64 [ %arg.points, %B876.else.endif.endif.endif.if.i ], [ %.2528.sroa.13.1.i, %B876.else.endif.endif.endif.i ]
  %.2616.i = sub i64 %.2528.sroa.13.2.i, %.2528.sroa.0.3.i
  %.2625.i = tail call i64 @llvm.smax.i64(i64 %.2616.i, i64 0)
  %.2641.i = getelementptr double, ptr %arg.f, i64 %.2528.sroa.0.3.i
  br i1 %.2543.i, label %B876.endif.else.if.i, label %B876.endif.else.endif.i, !prof !4

B876.endif.else.if.i:                             ; preds = %B876.else.endif.endif.endif.endif.i
  br label %B876.endif.else.endif.i

B876.endif.else.endif.i:                          ; preds = %B876.endif.else.if.i, %B876.else.endif.endif.endif.endif.i
  %.2701.sroa.0.1.i = phi i64 [ 0, %B876.endif.else.if.i ], [ %.2540.i, %B876.else.endif.endif.endif.endif.i ]
  br i1 %.2548.not.i, label %B876.endif.else.endif.endif.i, label %B876.endif.else.endif.if.i, !prof !5

B876.endif.else.endif.if.i:                       ; preds = %B876.endif.else.endif.i
  br label %B876.endif.else.endif.endif.i

B876.endif.else.endif.endif.i:                    ; preds = %B876.endif.else.endif.if.i, %B876.endif.else.endif.i
  %.2701.sroa.0.3.i = phi i64 [ %arg.points, %B876.endif.else.endif.if.i ], [ %.2701.sroa.0.1.i, %B876.endif.else.endif.i ]
  br i1 %.2560.i, label %B876.endif.else.endif.endif.if.i, label %B876.endif.else.endif.endif.endif.i, !prof !4

B876.endif.else.endif.endif.if.i:                 ; preds = %B876.endif.else.endif.endif.i
  br label %B876.endif.else.endif.endif.endif.i

B876.endif.else.endif.endif.endif.i:              ; preds = %B876.endif.else.endif.endif.if.i, %B876.endif.else.endif.endif.i
  %.2701.sroa.13.1.i = phi i64 [ 0, %B876.endif.else.endif.endif.if.i ], [ %.2557.i, %B876.endif.else.endif.endif.i ]
  br i1 %.2565.not.i, label %B876.endif.else.endif.endif.endif.endif.i, label %B876.endif.else.endif.endif.endif.if.i, !prof !5

B876.endif.else.endif.endif.endif.if.i:           ; preds = %B876.endif.else.endif.endif.endif.i
  br label %B876.endif.else.endif.endif.endif.endif.i

B876.endif.else.endif.endif.endif.endif.i:        ; preds = %B876.endif.else.endif.endif.endif.if.i, %B876.endif.else.endif.endif.endif.i
  %.2701.sroa.13.2.i = phi i64 [ %arg.points, %B876.endif.else.endif.endif.endif.if.i ], [ %.2701.sroa.13.1.i, %B876.endif.else.endif.endif.endif.i ]
  %.2789.i = sub i64 %.2701.sroa.13.2.i, %.2701.sroa.0.3.i
  %.2798.i = tail call i64 @llvm.smax.i64(i64 %.2789.i, i64 0)
  %.2814.i = getelementptr double, ptr %arg.log_f, i64 %.2701.sroa.0.3.i
  br i1 %.2543.i, label %B876.endif.endif.else.if.i, label %B876.endif.endif.else.endif.i, !prof !4

B876.endif.endif.else.if.i:                       ; preds = %B876.endif.else.endif.endif.endif.endif.i
  br label %B876.endif.endif.else.endif.i

B876.endif.endif.else.endif.i:                    ; preds = %B876.endif.endif.else.if.i, %B876.endif.else.endif.endif.endif.endif.i
  %.2878.sroa.0.1.i = phi i64 [ 0, %B876.endif.endif.else.if.i ], [ %.2540.i, %B876.endif.else.endif.endif.endif.endif.i ]
  br i1 %.2548.not.i, label %B876.endif.endif.else.endif.endif.i, label %B876.endif.endif.else.endif.if.i, !prof !5

B876.endif.endif.else.endif.if.i:                 ; preds = %B876.endif.endif.else.endif.i
  br label %B876.endif.endif.else.endif.endif.i

B876.endif.endif.else.endif.endif.i:              ; preds = %B876.endif.endif.else.endif.if.i, %B876.endif.endif.else.endif.i
  %.2878.sroa.0.3.i = phi i64 [ %arg.points, %B876.endif.endif.else.endif.if.i ], [ %.2878.sroa.0.1.i, %B876.endif.endif.else.endif.i ]
  br i1 %.2560.i, label %B876.endif.endif.else.endif.endif.if.i, label %B876.endif.endif.else.endif.endif.endif.i, !prof !4

B876.endif.endif.else.endif.endif.if.i:           ; preds = %B876.endif.endif.else.endif.endif.i
  br label %B876.endif.endif.else.endif.endif.endif.i

B876.endif.endif.else.endif.endif.endif.i:        ; preds = %B876.endif.endif.else.endif.endif.if.i, %B876.endif.endif.else.endif.endif.i
  %.2878.sroa.13.1.i = phi i64 [ 0, %B876.endif.endif.else.endif.endif.if.i ], [ %.2557.i, %B876.endif.endif.else.endif.endif.i ]
  br i1 %.2565.not.i, label %B876.endif.endif.else.endif.endif.endif.endif.i, label %B876.endif.endif.else.endif.endif.endif.if.i, !prof !5

B876.endif.endif.else.endif.endif.endif.if.i:     ; preds = %B876.endif.endif.else.endif.endif.endif.i
  br label %B876.endif.endif.else.endif.endif.endif.endif.i

B876.endif.endif.else.endif.endif.endif.endif.i:  ; preds = %B876.endif.endif.else.endif.endif.endif.if.i, %B876.endif.endif.else.endif.endif.endif.i
  %.2878.sroa.13.2.i = phi i64 [ %arg.points, %B876.endif.endif.else.endif.endif.endif.if.i ], [ %.2878.sroa.13.1.i, %B876.endif.endif.else.endif.endif.endif.i ]
  %.2966.i = sub i64 %.2878.sroa.13.2.i, %.2878.sroa.0.3.i
  %.2975.i = tail call i64 @llvm.smax.i64(i64 %.2966.i, i64 0)
  %.2991.i = getelementptr double, ptr %arg.cbrt_f, i64 %.2878.sroa.0.3.i
  call void @llvm.lifetime.start.p0(ptr nonnull %.2457.i.i), !noalias !0
  call void @llvm.lifetime.start.p0(ptr nonnull %.3101.i.i), !noalias !0
  store ptr null, ptr %.2457.i.i, align 8, !noalias !58
  store ptr null, ptr %.3101.i.i, align 8, !noalias !58
  %.210.i.i = load double, ptr %.209.i3.i, align 8, !noalias !58
  %.211.i.i = fmul contract double %.210.i.i, 0x3ED4A8B4A9ED04E3
  %.244.i.i = load i64, ptr %.243.i.i, align 8, !noalias !58
  %.258.i.i = icmp slt i64 %.244.i.i, 0
  %.259.i.i = select i1 %.258.i.i, i64 %arg.n_weights, i64 0
  %196 = getelementptr double, ptr %arg.weights, i64 %.244.i.i
  %.273.i.i = getelementptr double, ptr %196, i64 %.259.i.i
  %.274.i.i = load double, ptr %.273.i.i, align 8, !noalias !58
  %.319.i4.i = icmp slt i64 %.244.i.i, -1
  %.320.i.i = select i1 %.319.i4.i, i64 %arg.n_weights, i64 0
  %197 = getelementptr i8, ptr %196, i64 8
  %.334.i5.i = getelementptr double, ptr %197, i64 %.320.i.i
  %.335.i6.i = load double, ptr %.334.i5.i, align 8, !noalias !58
  %.342.i.i = fmul contract double %.274.i.i, 0x3FEFFFFFFF768FA1
  %.347.i.i = fdiv contract double %.342.i.i, %.211.i.i
  %.44.i.not.i.i = icmp slt i64 %.2616.i, 1
  br i1 %.44.i.not.i.i, label %B118.i.i.i, label %B28.i.i.i

B28.i.i.i:                                        ; preds = %B876.endif.endif.else.endif.endif.endif.endif.i
  %.94.i.i.i = load double, ptr %.2641.i, align 8, !noalias !62
  %.98.i.i.i = fcmp contract ugt double %.94.i.i.i, %.347.i.i
  br i1 %.98.i.i.i, label %B118.i.i.i, label %B52.i.i.i

B52.i.i.i:                                        ; preds = %B28.i.i.i, %B94.i.i.i
  %step.2.1.i.i.i = phi i64 [ %.123.i.i.i, %B94.i.i.i ], [ 1, %B28.i.i.i ]
  %high.4.1.i.i.i = phi i64 [ %.113.i.i.i, %B94.i.i.i ], [ 0, %B28.i.i.i ]
  %.113.i.i.i = add nuw nsw i64 %high.4.1.i.i.i, %step.2.1.i.i.i
  %.131.i.i.i = icmp slt i64 %.113.i.i.i, %.2625.i
  br i1 %.131.i.i.i, label %B94.i.i.i, label %B118.loopexit.i.i.i

B94.i.i.i:                                        ; preds = %B52.i.i.i
  %.123.i.i.i = shl nsw i64 %step.2.1.i.i.i, 1
  %.178.i.i.i = getelementptr double, ptr %.2641.i, i64 %.113.i.i.i
  %.179.i.i.i = load double, ptr %.178.i.i.i, align 8, !noalias !62
  %.183.i.i.i = fcmp contract ugt double %.179.i.i.i, %.347.i.i
  br i1 %.183.i.i.i, label %B118.loopexit.i.i.i, label %B52.i.i.i

B118.loopexit.i.i.i:                              ; preds = %B94.i.i.i, %B52.i.i.i
  %.104.le.i.i.i = add nuw nsw i64 %high.4.1.i.i.i, 1
  %198 = tail call i64 @llvm.smin.i64(i64 %.113.i.i.i, i64 range(i64 0, -9223372036854775808) %.2625.i)
  br label %B118.i.i.i

B118.i.i.i:                                       ; preds = %B118.loopexit.i.i.i, %B28.i.i.i, %B876.endif.endif.else.endif.endif.endif.endif.i
  %low.3.0.i.i.i = phi i64 [ 0, %B28.i.i.i ], [ 0, %B876.endif.endif.else.endif.endif.endif.endif.i ], [ %.104.le.i.i.i, %B118.loopexit.i.i.i ]
  %high.5.0.i.i.i = phi i64 [ 0, %B28.i.i.i ], [ 0, %B876.endif.endif.else.endif.endif.endif.endif.i ], [ %198, %B118.loopexit.i.i.i ]
  %.238.i.i.i = icmp slt i64 %low.3.0.i.i.i, %high.5.0.i.i.i
  br i1 %.238.i.i.i, label %B146.i.i.i, label %B0.endif.endif.i.i

B146.i.i.i:                                       ; preds = %B118.i.i.i, %B146.i.i.i
  %low.4.0.i.i.i = phi i64 [ %low.5.1.i.i.i, %B146.i.i.i ], [ %low.3.0.i.i.i, %B118.i.i.i ]
  %high.7.0.i.i.i = phi i64 [ %high.8.1.i.i.i, %B146.i.i.i ], [ %high.5.0.i.i.i, %B118.i.i.i ]
  %.251.i.i.i = add nsw i64 %high.7.0.i.i.i, %low.4.0.i.i.i
  %.259.1.i.i.i = ashr i64 %.251.i.i.i, 1
  %.309.i.i.i = icmp slt i64 %.259.1.i.i.i, 0
  %.310.i.i.i = select i1 %.309.i.i.i, i64 %.2625.i, i64 0
  %199 = getelementptr double, ptr %.2641.i, i64 %.259.1.i.i.i
  %.324.i.i.i = getelementptr double, ptr %199, i64 %.310.i.i.i
  %.325.i.i.i = load double, ptr %.324.i.i.i, align 8, !noalias !62
  %.327.i.i.i = fcmp contract ole double %.325.i.i.i, %.347.i.i
  %.338.i.i.i = add nsw i64 %.259.1.i.i.i, 1
  %high.8.1.i.i.i = select i1 %.327.i.i.i, i64 %high.7.0.i.i.i, i64 %.259.1.i.i.i
  %low.5.1.i.i.i = select i1 %.327.i.i.i, i64 %.338.i.i.i, i64 %low.4.0.i.i.i
  %.369.i.i.i = icmp slt i64 %low.5.1.i.i.i, %high.8.1.i.i.i
  br i1 %.369.i.i.i, label %B146.i.i.i, label %B0.endif.endif.i.i

B554.i.i:                                         ; preds = %B154.i.i.i, %B416.else.endif.endif.endif.endif.i.i, %B0.endif.endif.endif.endif.endif.else.endif.endif.i.i
  %.1516.i.i = icmp slt i64 %low.6.1.i.i.i, %low.6.1.i9.i.i
  br i1 %.1516.i.i, label %B566.i.i, label %B960.i.i

B566.i.i:                                         ; preds = %B554.i.i
  %.1556.i.i = icmp slt i64 %low.6.1.i.i.i, 0
  %.1557.i.i = select i1 %.1556.i.i, i64 %.2798.i, i64 0
  %.1558.i.i = add i64 %.1557.i.i, %low.6.1.i.i.i
  %.1561.i.i = icmp slt i64 %.1558.i.i, 0
  br i1 %.1561.i.i, label %B566.else.if.i.i, label %B566.else.endif.i.i, !prof !4

B960.i.i:                                         ; preds = %for.end.endif.endif.endif...endif.4.endif.endif.endif.i.i, %B554.i.i
  %.3198.i.i = load double, ptr %.1183.i, align 8, !noalias !58
  %.5.i.i.i = fadd contract double %.3198.i.i, 1.000000e+00
  %.147.i.i.i7.i = fmul contract double %.5.i.i.i, %.5.i.i.i
  %.35.i.i.i = fdiv contract double %.3198.i.i, %.147.i.i.i7.i
  %.3223.i.i = fmul contract double %.35.i.i.i, 0x3AD23C9F83511538
  %.3253.i.i = load double, ptr %.209.i3.i, align 8, !noalias !58
  %.3284.i.i = fmul contract double %.3253.i.i, %.3253.i.i
  %.3285.i.i = fmul contract double %.3284.i.i, %.3223.i.i
  %.3315.i.i = load double, ptr %.3314.i.i, align 8, !noalias !58
  %.3319.i.i = fdiv contract double %.3285.i.i, %.3315.i.i
  %.3375.i.i = icmp slt i64 %low.6.1.i9.i.i, 0
  %.3376.i.i = select i1 %.3375.i.i, i64 %a.2.sroa.60.2.i, i64 0
  %.3377.i.i = add i64 %.3376.i.i, %low.6.1.i9.i.i
  %.3380.i.i = icmp slt i64 %.3377.i.i, 0
  br i1 %.3380.i.i, label %B960.endif.endif.else.endif.endif.if.i.i, label %B960.endif.endif.else.endif.endif.endif.i.i, !prof !4

B1286.i.i:                                        ; preds = %_ZN17bnserve_surrogate6kernel7_source16_scale_amplitudeB3v36B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEd5ArrayIdLi1E1C7mutable7alignedEd5ArrayIdLi1E1C7mutable7alignedE.exit.i.i
  %.25.i.i.i = fmul contract double %.3672.i.i, 0x400921FB54442D18
  %.26.i.i.i = tail call contract double @llvm.pow.f64(double %.25.i.i.i, double 0x3FD5555555555555)
  %.147.i.i2.i.i = fmul contract double %.26.i.i.i, %.26.i.i.i
  %.147.i.1.i.i.i = fmul contract double %.147.i.i2.i.i, %.147.i.i2.i.i
  %.127.i.2.i.i.i = fmul contract double %.26.i.i.i, %.147.i.1.i.i.i
  %.38.le.i.i.i = tail call contract double @llvm.log.f64(double %.26.i.i.i)
  %.168.i.i.i.i = fcmp une double %.127.i.2.i.i.i, 0.000000e+00
  br i1 %.168.i.i.i.i, label %B124.if.lr.ph.i.i.i, label %_ZN17bnserve_surrogate6kernel7_source9_legendreB3v40B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dEd5ArrayIdLi2E1C7mutable7alignedE.exit.i.i, !prof !65

B124.if.lr.ph.i.i.i:                              ; preds = %B1286.i.i
  %.175.i.i.i.i = fdiv contract double 1.000000e+00, %.127.i.2.i.i.i
  %.423.i.i.i = fmul contract double %.38.le.i.i.i, 2.000000e+00
  br label %B124.if.i.i.i

B124.if.i.i.i:                                    ; preds = %B124.if.i.i.i, %B124.if.lr.ph.i.i.i
  %lsr.iv3.i.i.i = phi i64 [ -5, %B124.if.lr.ph.i.i.i ], [ %lsr.iv.next.i.i.i, %B124.if.i.i.i ]
  %power.2.0146.i.i.i = phi double [ %.175.i.i.i.i, %B124.if.lr.ph.i.i.i ], [ %.493.i.i.i, %B124.if.i.i.i ]
  %result.2.0145.i.i.i = phi double [ 0.000000e+00, %B124.if.lr.ph.i.i.i ], [ %.488.i.i.i, %B124.if.i.i.i ]
  %200 = shl nsw i64 %lsr.iv3.i.i.i, 3
  %scevgep20.i28.i = getelementptr i8, ptr %arg.series, i64 %200
  %scevgep21.i29.i = getelementptr i8, ptr %scevgep20.i28.i, i64 40
  %.249.i.i.i = load double, ptr %scevgep21.i29.i, align 8, !noalias !66
  %scevgep19.i.i = getelementptr i8, ptr %scevgep20.i28.i, i64 168
  %.303.i.i.i = load double, ptr %scevgep19.i.i, align 8, !noalias !66
  %scevgep6.i.i = getelementptr i8, ptr %scevgep20.i28.i, i64 296
  %.357.i.i.i = load double, ptr %scevgep6.i.i, align 8, !noalias !66
  %.359.i.i.i = fmul contract double %.38.le.i.i.i, %.357.i.i.i
  %.360.i.i.i = fadd contract double %.303.i.i.i, %.359.i.i.i
  %.362.i.i30.i = fmul contract double %.38.le.i.i.i, %.360.i.i.i
  %.363.i.i.i = fadd contract double %.249.i.i.i, %.362.i.i30.i
  %.365.i.i.i = sitofp i64 %lsr.iv3.i.i.i to double
  %.366.i.i.i = fmul contract double %.363.i.i.i, %.365.i.i.i
  %.421.i.i.i = fadd contract double %.303.i.i.i, %.366.i.i.i
  %.478.i.i.i = fmul contract double %.423.i.i.i, %.357.i.i.i
  %.479.i.i.i = fadd contract double %.478.i.i.i, %.421.i.i.i
  %.483.i.i.i = fdiv contract double %.479.i.i.i, 3.000000e+00
  %.484.i.i.i = fsub contract double %.363.i.i.i, %.483.i.i.i
  %.486.i.i.i = fmul contract double %power.2.0146.i.i.i, %.484.i.i.i
  %.488.i.i.i = fadd contract double %result.2.0145.i.i.i, %.486.i.i.i
  %.493.i.i.i = fmul contract double %.26.i.i.i, %power.2.0146.i.i.i
  %lsr.iv.next.i.i.i = add nsw i64 %lsr.iv3.i.i.i, 1
  %exitcond.not.i.i.i = icmp eq i64 %lsr.iv.next.i.i.i, 11
  br i1 %exitcond.not.i.i.i, label %_ZN17bnserve_surrogate6kernel7_source9_legendreB3v40B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dEd5ArrayIdLi2E1C7mutable7alignedE.exit.i.i, label %B124.if.i.i.i

_ZN17bnserve_surrogate6kernel7_source9_legendreB3v40B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dEd5ArrayIdLi2E1C7mutable7alignedE.exit.i.i: ; preds = %B124.if.i.i.i, %B1286.i.i
  %.3693.0.i.i = phi double [ 0.000000e+00, %B1286.i.i ], [ %.488.i.i.i, %B124.if.i.i.i ]
  %excinfo.8.0.i.i = phi ptr [ @.const.picklebuf.b28008a0f88bad5ff0f0243e84dab90cab19b366, %B1286.i.i ], [ null, %B124.if.i.i.i ]
  br i1 %.168.i.i.i.i, label %B1286.endif.i.i, label %_ZN17bnserve_surrogate6kernel7_source6_blockB3v28B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i, !prof !65

B1324.i.i:                                        ; preds = %B1286.endif.i.i, %_ZN17bnserve_surrogate6kernel7_source16_scale_amplitudeB3v36B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEd5ArrayIdLi1E1C7mutable7alignedEd5ArrayIdLi1E1C7mutable7alignedE.exit.i.i
  %constant.2.0.i.i = phi double [ %.3724.i.i, %B1286.endif.i.i ], [ %.3599.i.i, %_ZN17bnserve_surrogate6kernel7_source16_scale_amplitudeB3v36B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEd5ArrayIdLi1E1C7mutable7alignedEd5ArrayIdLi1E1C7mutable7alignedE.exit.i.i ]
  %.3764.i.i = load double, ptr %.3763.i.i, align 8, !noalias !58
  %.3770.i.i = fmul contract double %.3764.i.i, 0x401921FB54442D18
  %201 = getelementptr i8, ptr %230, i64 8
  %.3804.i.i = getelementptr double, ptr %201, i64 %.3583.i.i
  %.3805.i.i = load double, ptr %.3804.i.i, align 8, !noalias !58
  %.3812.i.i = fmul contract double %.211.i.i, %.3805.i.i
  %.3813.i.i = fsub contract double %.3770.i.i, %.3812.i.i
  %.3870.i.i = select i1 %.3375.i.i, i64 %p.2.sroa.60.2.i, i64 0
  %.3871.i.i = add i64 %.3870.i.i, %low.6.1.i9.i.i
  %.3874.i.i = icmp slt i64 %.3871.i.i, 0
  br i1 %.3874.i.i, label %B1324.else.endif.endif.if.i.i, label %B1324.else.endif.endif.endif.i.i, !prof !4

B0.endif.endif.i.i:                               ; preds = %B146.i.i.i, %B118.i.i.i
  %low.6.1.i.i.i = phi i64 [ %low.3.0.i.i.i, %B118.i.i.i ], [ %low.5.1.i.i.i, %B146.i.i.i ]
  %.383.i.i = fmul contract double %.335.i6.i, 0x3FF000000044B830
  %.388.i.i = fdiv contract double %.383.i.i, %.211.i.i
  %.44.i3.i.i = icmp slt i64 %low.6.1.i.i.i, %.2625.i
  br i1 %.44.i3.i.i, label %B28.i24.i.i, label %B118.i4.i.i

B28.i24.i.i:                                      ; preds = %B0.endif.endif.i.i
  %.78.i.i.i = icmp slt i64 %low.6.1.i.i.i, 0
  %.79.i.i.i = select i1 %.78.i.i.i, i64 %.2625.i, i64 0
  %202 = getelementptr double, ptr %.2641.i, i64 %low.6.1.i.i.i
  %.93.i.i.i = getelementptr double, ptr %202, i64 %.79.i.i.i
  %.94.i25.i.i = load double, ptr %.93.i.i.i, align 8, !noalias !70
  %.98.i26.i.i = fcmp contract ugt double %.94.i25.i.i, %.388.i.i
  br i1 %.98.i26.i.i, label %B118.i4.i.i, label %B52.i27.i.i

B52.i27.i.i:                                      ; preds = %B28.i24.i.i, %B94.i34.i.i
  %step.2.1.i28.i.i = phi i64 [ %.123.i35.i.i, %B94.i34.i.i ], [ 1, %B28.i24.i.i ]
  %high.4.1.i29.i.i = phi i64 [ %.113.i30.i.i, %B94.i34.i.i ], [ %low.6.1.i.i.i, %B28.i24.i.i ]
  %.113.i30.i.i = add nsw i64 %high.4.1.i29.i.i, %step.2.1.i28.i.i
  %.131.i31.i.i = icmp slt i64 %.113.i30.i.i, %.2625.i
  br i1 %.131.i31.i.i, label %B94.i34.i.i, label %B118.loopexit.i32.i.i

B94.i34.i.i:                                      ; preds = %B52.i27.i.i
  %.123.i35.i.i = shl nsw i64 %step.2.1.i28.i.i, 1
  %.163.i.i.i = icmp slt i64 %.113.i30.i.i, 0
  %.164.i.i.i = select i1 %.163.i.i.i, i64 %.2625.i, i64 0
  %203 = getelementptr double, ptr %.2641.i, i64 %.113.i30.i.i
  %.178.i36.i.i = getelementptr double, ptr %203, i64 %.164.i.i.i
  %.179.i37.i.i = load double, ptr %.178.i36.i.i, align 8, !noalias !70
  %.183.i38.i.i = fcmp contract ugt double %.179.i37.i.i, %.388.i.i
  br i1 %.183.i38.i.i, label %B118.loopexit.i32.i.i, label %B52.i27.i.i

B118.loopexit.i32.i.i:                            ; preds = %B94.i34.i.i, %B52.i27.i.i
  %.104.le.i33.i.i = add nsw i64 %high.4.1.i29.i.i, 1
  br label %B118.i4.i.i

B118.i4.i.i:                                      ; preds = %B118.loopexit.i32.i.i, %B28.i24.i.i, %B0.endif.endif.i.i
  %low.3.0.i5.i.i = phi i64 [ %low.6.1.i.i.i, %B28.i24.i.i ], [ %low.6.1.i.i.i, %B0.endif.endif.i.i ], [ %.104.le.i33.i.i, %B118.loopexit.i32.i.i ]
  %high.5.0.i6.i.i = phi i64 [ %low.6.1.i.i.i, %B28.i24.i.i ], [ %low.6.1.i.i.i, %B0.endif.endif.i.i ], [ %.113.i30.i.i, %B118.loopexit.i32.i.i ]
  %spec.select.i7.i.i = tail call i64 @llvm.smin.i64(i64 %high.5.0.i6.i.i, i64 range(i64 0, -9223372036854775808) %.2625.i)
  %.238.i8.i.i = icmp slt i64 %low.3.0.i5.i.i, %spec.select.i7.i.i
  br i1 %.238.i8.i.i, label %B146.i10.i.i, label %B0.endif.endif.endif.endif.i.i

B146.i10.i.i:                                     ; preds = %B118.i4.i.i, %B146.i10.i.i
  %low.4.0.i11.i.i = phi i64 [ %low.5.1.i22.i.i, %B146.i10.i.i ], [ %low.3.0.i5.i.i, %B118.i4.i.i ]
  %high.7.0.i12.i.i = phi i64 [ %high.8.1.i21.i.i, %B146.i10.i.i ], [ %spec.select.i7.i.i, %B118.i4.i.i ]
  %.251.i13.i.i = add nsw i64 %high.7.0.i12.i.i, %low.4.0.i11.i.i
  %.259.1.i14.i.i = ashr i64 %.251.i13.i.i, 1
  %.309.i15.i.i = icmp slt i64 %.259.1.i14.i.i, 0
  %.310.i16.i.i = select i1 %.309.i15.i.i, i64 %.2625.i, i64 0
  %204 = getelementptr double, ptr %.2641.i, i64 %.259.1.i14.i.i
  %.324.i17.i.i = getelementptr double, ptr %204, i64 %.310.i16.i.i
  %.325.i18.i.i = load double, ptr %.324.i17.i.i, align 8, !noalias !70
  %.327.i19.i.i = fcmp contract ole double %.325.i18.i.i, %.388.i.i
  %.338.i20.i.i = add nsw i64 %.259.1.i14.i.i, 1
  %high.8.1.i21.i.i = select i1 %.327.i19.i.i, i64 %high.7.0.i12.i.i, i64 %.259.1.i14.i.i
  %low.5.1.i22.i.i = select i1 %.327.i19.i.i, i64 %.338.i20.i.i, i64 %low.4.0.i11.i.i
  %.369.i23.i.i = icmp slt i64 %low.5.1.i22.i.i, %high.8.1.i21.i.i
  br i1 %.369.i23.i.i, label %B146.i10.i.i, label %B0.endif.endif.endif.endif.i.i

B0.endif.endif.endif.endif.i.i:                   ; preds = %B146.i10.i.i, %B118.i4.i.i
  %low.6.1.i9.i.i = phi i64 [ %low.3.0.i5.i.i, %B118.i4.i.i ], [ %low.5.1.i22.i.i, %B146.i10.i.i ]
  %.450.i.i = load i64, ptr %.440.i, align 8, !noalias !58
  %.480.i.i = load i64, ptr %.470.i, align 8, !noalias !58
  %.489.i.i = add nsw i64 %.480.i.i, %.450.i.i
  %.490.i.i = shl nsw i64 %.489.i.i, 1
  %.527.i.i = icmp slt i64 %.489.i.i, 0
  %.528.i.i = select i1 %.527.i.i, i64 %.605.i, i64 0
  %.529.i.i = add i64 %.528.i.i, %.490.i.i
  %.532.i.i = icmp slt i64 %.529.i.i, 0
  br i1 %.532.i.i, label %B0.endif.endif.endif.endif.else.if.i.i, label %B0.endif.endif.endif.endif.else.endif.i.i, !prof !4

B0.endif.endif.endif.endif.else.if.i.i:           ; preds = %B0.endif.endif.endif.endif.i.i
  br label %B0.endif.endif.endif.endif.else.endif.i.i

B0.endif.endif.endif.endif.else.endif.i.i:        ; preds = %B0.endif.endif.endif.endif.else.if.i.i, %B0.endif.endif.endif.endif.i.i
  %.517.sroa.0.1.i.i = phi i64 [ 0, %B0.endif.endif.endif.endif.else.if.i.i ], [ %.529.i.i, %B0.endif.endif.endif.endif.i.i ]
  %.537.not.i.i = icmp slt i64 %.529.i.i, %.605.i
  br i1 %.537.not.i.i, label %B0.endif.endif.endif.endif.else.endif.endif.i.i, label %B0.endif.endif.endif.endif.else.endif.if.i.i, !prof !5

B0.endif.endif.endif.endif.else.endif.if.i.i:     ; preds = %B0.endif.endif.endif.endif.else.endif.i.i
  br label %B0.endif.endif.endif.endif.else.endif.endif.i.i

B0.endif.endif.endif.endif.else.endif.endif.i.i:  ; preds = %B0.endif.endif.endif.endif.else.endif.if.i.i, %B0.endif.endif.endif.endif.else.endif.i.i
  %.517.sroa.0.3.i.i = phi i64 [ %.605.i, %B0.endif.endif.endif.endif.else.endif.if.i.i ], [ %.517.sroa.0.1.i.i, %B0.endif.endif.endif.endif.else.endif.i.i ]
  %.605.i.i = sub nsw i64 %.605.i, %.517.sroa.0.3.i.i
  %.614.i.i = tail call i64 @llvm.smax.i64(i64 %.605.i.i, i64 0)
  %.630.i.i = getelementptr double, ptr %.621.i, i64 %.517.sroa.0.3.i.i
  %.669.i.i = shl nsw i64 %.450.i.i, 1
  %.673.i.i = add nsw i64 %.669.i.i, %.480.i.i
  %.710.i.i = icmp slt i64 %.450.i.i, 0
  %.711.i.i = select i1 %.710.i.i, i64 %.605.i, i64 0
  %.712.i.i = add i64 %.711.i.i, %.669.i.i
  %.715.i.i = icmp slt i64 %.712.i.i, 0
  br i1 %.715.i.i, label %B0.endif.endif.endif.endif.endif.else.if.i.i, label %B0.endif.endif.endif.endif.endif.else.endif.i.i, !prof !4

B0.endif.endif.endif.endif.endif.else.if.i.i:     ; preds = %B0.endif.endif.endif.endif.else.endif.endif.i.i
  br label %B0.endif.endif.endif.endif.endif.else.endif.i.i

B0.endif.endif.endif.endif.endif.else.endif.i.i:  ; preds = %B0.endif.endif.endif.endif.endif.else.if.i.i, %B0.endif.endif.endif.endif.else.endif.endif.i.i
  %.700.sroa.0.1.i.i = phi i64 [ 0, %B0.endif.endif.endif.endif.endif.else.if.i.i ], [ %.712.i.i, %B0.endif.endif.endif.endif.else.endif.endif.i.i ]
  %.720.not.i.i = icmp slt i64 %.712.i.i, %.605.i
  br i1 %.720.not.i.i, label %B0.endif.endif.endif.endif.endif.else.endif.endif.i.i, label %B0.endif.endif.endif.endif.endif.else.endif.if.i.i, !prof !5

B0.endif.endif.endif.endif.endif.else.endif.if.i.i: ; preds = %B0.endif.endif.endif.endif.endif.else.endif.i.i
  br label %B0.endif.endif.endif.endif.endif.else.endif.endif.i.i

B0.endif.endif.endif.endif.endif.else.endif.endif.i.i: ; preds = %B0.endif.endif.endif.endif.endif.else.endif.if.i.i, %B0.endif.endif.endif.endif.endif.else.endif.i.i
  %.700.sroa.0.3.i.i = phi i64 [ %.605.i, %B0.endif.endif.endif.endif.endif.else.endif.if.i.i ], [ %.700.sroa.0.1.i.i, %B0.endif.endif.endif.endif.endif.else.endif.i.i ]
  %.727.i.i = icmp slt i64 %.673.i.i, 0
  %.728.i.i = select i1 %.727.i.i, i64 %.605.i, i64 0
  %.729.i.i = add i64 %.728.i.i, %.673.i.i
  %.732.i.i = icmp slt i64 %.729.i.i, 0
  %.737.not.i.i = icmp slt i64 %.729.i.i, %.605.i
  %.813.i.i = getelementptr double, ptr %.621.i, i64 %.700.sroa.0.3.i.i
  %.852.i.i = icmp sgt i64 %low.6.1.i.i.i, 0
  br i1 %.852.i.i, label %B416.else.endif.i.i, label %B554.i.i

B416.else.endif.i.i:                              ; preds = %B0.endif.endif.endif.endif.endif.else.endif.endif.i.i
  %.918.not.i.i = icmp slt i64 %low.6.1.i.i.i, %a.2.sroa.60.2.i
  br i1 %.918.not.i.i, label %B416.else.endif.endif.endif.endif.i.i, label %B416.else.endif.endif.endif.if.i.i, !prof !5

B416.else.endif.endif.endif.if.i.i:               ; preds = %B416.else.endif.i.i
  br label %B416.else.endif.endif.endif.endif.i.i

B416.else.endif.endif.endif.endif.i.i:            ; preds = %B416.else.endif.endif.endif.if.i.i, %B416.else.endif.i.i
  %.881.sroa.13.2.i.i = phi i64 [ %a.2.sroa.60.2.i, %B416.else.endif.endif.endif.if.i.i ], [ %low.6.1.i.i.i, %B416.else.endif.i.i ]
  %.1406.i.i = load double, ptr %.621.i, align 8, !noalias !58
  %.1436.i.i = load double, ptr %.813.i.i, align 8, !noalias !58
  %.1465.i.i = getelementptr i8, ptr %.630.i.i, i64 8
  %.1466.i.i = load double, ptr %.1465.i.i, align 8, !noalias !58
  %.153112.not.i.i.i = icmp slt i64 %.881.sroa.13.2.i.i, 1
  br i1 %.153112.not.i.i.i, label %B554.i.i, label %B56.if.i.i.i

B116.i.i.i:                                       ; preds = %B56.if.i.i.i
  %.6.i.i.i.i = fmul contract double %.237.i.i.i, 0x400921FB54442D18
  %.7.i.i.i.i = fmul contract double %.6.i.i.i.i, 0x3FE45F306DC9C883
  %.8.i.i.i.i = fadd contract double %.7.i.i.i.i, 0x4338000000000000
  %.9.i.i.i.i = fadd contract double %.8.i.i.i.i, 0xC338000000000000
  %.27.i.i.i37.i = fmul contract double %.9.i.i.i.i, 0x3FF921FA00000000
  %.28.i.i.i38.i = fsub contract double %.6.i.i.i.i, %.27.i.i.i37.i
  %.46.i.i.i39.i = fmul contract double %.9.i.i.i.i, 0x3EB5444200000000
  %.47.i.i.i40.i = fsub contract double %.28.i.i.i38.i, %.46.i.i.i39.i
  %.65.i.i.i.i = fmul contract double %.9.i.i.i.i, 0x3D6A308C00000000
  %.66.i.i.i.i = fsub contract double %.47.i.i.i40.i, %.65.i.i.i.i
  %.84.i.i.i.i = fmul contract double %.9.i.i.i.i, 0x3C2313198A2E0370
  %.85.i.i.i.i = fsub contract double %.66.i.i.i.i, %.84.i.i.i.i
  %.86.i.i.i.i = fmul contract double %.85.i.i.i.i, %.85.i.i.i.i
  %.87.i.i.i.i = fmul contract double %.85.i.i.i.i, %.86.i.i.i.i
  %.88.i.i.i.i = fmul contract double %.86.i.i.i.i, 0x3D6AE7F3E733B81F
  %205 = fsub contract double 0x3DE6124613A86D09, %.88.i.i.i.i
  %.90.i.i.i.i = fmul contract double %.86.i.i.i.i, %205
  %.91.i.i.i.i = fadd contract double %.90.i.i.i.i, 0xBE5AE64567F544E4
  %.92.i.i.i.i = fmul contract double %.86.i.i.i.i, %.91.i.i.i.i
  %.93.i.i.i.i = fadd contract double %.92.i.i.i.i, 0x3EC71DE3A556C734
  %.94.i.i.i.i = fmul contract double %.86.i.i.i.i, %.93.i.i.i.i
  %.95.i.i.i.i = fadd contract double %.94.i.i.i.i, 0xBF2A01A01A01A01A
  %.96.i.i.i.i = fmul contract double %.86.i.i.i.i, %.95.i.i.i.i
  %.97.i.i.i.i = fadd contract double %.96.i.i.i.i, 0x3F81111111111111
  %.98.i.i.i.i = fmul contract double %.86.i.i.i.i, %.97.i.i.i.i
  %.99.i.i.i.i = fadd contract double %.98.i.i.i.i, 0xBFC5555555555555
  %.100.i.i.i.i = fmul contract double %.87.i.i.i.i, %.99.i.i.i.i
  %.101.i.i.i41.i = fadd contract double %.85.i.i.i.i, %.100.i.i.i.i
  %.102.i.i.i.i = fmul contract double %.86.i.i.i.i, 0x3D2AE7F3E733B81F
  %.103.i.i.i42.i = fadd contract double %.102.i.i.i.i, 0xBDA93974A8C07C9D
  %.104.i.i.i43.i = fmul contract double %.86.i.i.i.i, %.103.i.i.i42.i
  %.105.i.i.i44.i = fadd contract double %.104.i.i.i43.i, 0x3E21EED8EFF8D898
  %.106.i.i.i45.i = fmul contract double %.86.i.i.i.i, %.105.i.i.i44.i
  %.107.i.i.i46.i = fadd contract double %.106.i.i.i45.i, 0xBE927E4FB7789F5C
  %.108.i.i.i47.i = fmul contract double %.86.i.i.i.i, %.107.i.i.i46.i
  %.109.i.i.i48.i = fadd contract double %.108.i.i.i47.i, 0x3EFA01A01A01A01A
  %.110.i.i.i.i = fmul contract double %.86.i.i.i.i, %.109.i.i.i48.i
  %.111.i.i.i.i = fadd contract double %.110.i.i.i.i, 0xBF56C16C16C16C17
  %.112.i.i.i.i = fmul contract double %.86.i.i.i.i, %.111.i.i.i.i
  %.113.i.i.i.i = fadd contract double %.112.i.i.i.i, 0x3FA5555555555555
  %.114.i.i.i.i = fmul contract double %.86.i.i.i.i, %.113.i.i.i.i
  %.115.i.i.i.i = fadd contract double %.114.i.i.i.i, -5.000000e-01
  %.116.i.i.i.i = fmul contract double %.86.i.i.i.i, %.115.i.i.i.i
  %.117.i.i.i.i = fadd contract double %.116.i.i.i.i, 1.000000e+00
  %.118.i.i.i.i = bitcast double %.8.i.i.i.i to i64
  %.119.i.i.i.i = and i64 %.118.i.i.i.i, 1
  %206 = icmp eq i64 %.119.i.i.i.i, 0
  %.127.i.i.i.i = shl i64 %.118.i.i.i.i, 62
  %.128.i.i.i.i = add i64 %.127.i.i.i.i, 4611686018427387904
  %.129.i.i.i.i = and i64 %.128.i.i.i.i, -9223372036854775808
  %.133.v.i.i.i.i = select i1 %206, double %.117.i.i.i.i, double %.101.i.i.i41.i
  %.133.i.i.i.i = bitcast double %.133.v.i.i.i.i to i64
  %.134.i.i.i49.i = xor i64 %.129.i.i.i.i, %.133.i.i.i.i
  %.135.i.i.i50.i = bitcast i64 %.134.i.i.i49.i to double
  %.151.i.i.i.i = fsub contract double 1.000000e+00, %.135.i.i.i50.i
  %.152.i.i.i.i = fmul contract double %.151.i.i.i.i, 5.000000e-01
  %.273.i.i51.i = fmul contract double %.1406.i.i, %.152.i.i.i.i
  br label %B154.i.i.i

B154.i.i.i:                                       ; preds = %B56.if.i.i.i, %B116.i.i.i
  %"$phi154.1.2.1.i.i.i" = phi double [ %.273.i.i51.i, %B116.i.i.i ], [ 0.000000e+00, %B56.if.i.i.i ]
  %scevgep22.i.i = getelementptr i8, ptr %a.2.sroa.48.2.i, i64 %208
  store double %"$phi154.1.2.1.i.i.i", ptr %scevgep22.i.i, align 8, !noalias !73
  %.319.i.i.i = fsub contract double %.226.i.i.i, %.274.i.i
  %207 = fmul contract double %.1466.i.i, %.319.i.i.i
  %.325.i40.i.i = fsub contract double %.1436.i.i, %207
  %scevgep.i36.i = getelementptr i8, ptr %p.2.sroa.48.2.i, i64 %208
  store double %.325.i40.i.i, ptr %scevgep.i36.i, align 8, !noalias !73
  %exitcond.not.i42.i.i = icmp eq i64 %.881.sroa.13.2.i.i, %.166.i.i.i
  br i1 %exitcond.not.i42.i.i, label %B554.i.i, label %B56.if.i.i.i

B56.if.i.i.i:                                     ; preds = %B416.else.endif.endif.endif.endif.i.i, %B154.i.i.i
  %.159111113.i.i.i = phi i64 [ %.166.i.i.i, %B154.i.i.i ], [ 0, %B416.else.endif.endif.endif.endif.i.i ]
  %.166.i.i.i = add nuw nsw i64 %.159111113.i.i.i, 1
  %208 = shl i64 %.159111113.i.i.i, 3
  %scevgep2.i39.i.i = getelementptr i8, ptr %.2641.i, i64 %208
  %.224.i.i.i = load double, ptr %scevgep2.i39.i.i, align 8, !noalias !73
  %.226.i.i.i = fmul contract double %.211.i.i, %.224.i.i.i
  %.231.i.i.i = fmul contract double %.226.i.i.i, 2.000000e+00
  %.236.i.i35.i = fdiv contract double %.231.i.i.i, %.274.i.i
  %.237.i.i.i = fadd contract double %.236.i.i35.i, -1.000000e+00
  %.242.i.i.i = fcmp contract ogt double %.237.i.i.i, 0.000000e+00
  br i1 %.242.i.i.i, label %B116.i.i.i, label %B154.i.i.i

B566.else.if.i.i:                                 ; preds = %B566.i.i
  br label %B566.else.endif.i.i

B566.else.endif.i.i:                              ; preds = %B566.else.if.i.i, %B566.i.i
  %.1546.sroa.0.1.i.i = phi i64 [ 0, %B566.else.if.i.i ], [ %.1558.i.i, %B566.i.i ]
  %.1566.not.i.i = icmp slt i64 %.1558.i.i, %.2798.i
  br i1 %.1566.not.i.i, label %B566.else.endif.endif.i.i, label %B566.else.endif.if.i.i, !prof !5

B566.else.endif.if.i.i:                           ; preds = %B566.else.endif.i.i
  br label %B566.else.endif.endif.i.i

B566.else.endif.endif.i.i:                        ; preds = %B566.else.endif.if.i.i, %B566.else.endif.i.i
  %.1546.sroa.0.3.i.i = phi i64 [ %.2798.i, %B566.else.endif.if.i.i ], [ %.1546.sroa.0.1.i.i, %B566.else.endif.i.i ]
  %.1573.i.i = icmp slt i64 %low.6.1.i9.i.i, 0
  %.1574.i.i = select i1 %.1573.i.i, i64 %.2798.i, i64 0
  %.1575.i.i = add i64 %.1574.i.i, %low.6.1.i9.i.i
  %.1578.i.i = icmp slt i64 %.1575.i.i, 0
  br i1 %.1578.i.i, label %B566.else.endif.endif.if.i.i, label %B566.else.endif.endif.endif.i.i, !prof !4

B566.else.endif.endif.if.i.i:                     ; preds = %B566.else.endif.endif.i.i
  br label %B566.else.endif.endif.endif.i.i

B566.else.endif.endif.endif.i.i:                  ; preds = %B566.else.endif.endif.if.i.i, %B566.else.endif.endif.i.i
  %.1546.sroa.13.1.i.i = phi i64 [ 0, %B566.else.endif.endif.if.i.i ], [ %.1575.i.i, %B566.else.endif.endif.i.i ]
  %.1583.not.i.i = icmp slt i64 %.1575.i.i, %.2798.i
  br i1 %.1583.not.i.i, label %B566.else.endif.endif.endif.endif.i.i, label %B566.else.endif.endif.endif.if.i.i, !prof !5

B566.else.endif.endif.endif.if.i.i:               ; preds = %B566.else.endif.endif.endif.i.i
  br label %B566.else.endif.endif.endif.endif.i.i

B566.else.endif.endif.endif.endif.i.i:            ; preds = %B566.else.endif.endif.endif.if.i.i, %B566.else.endif.endif.endif.i.i
  %.1546.sroa.13.2.i.i = phi i64 [ %.2798.i, %B566.else.endif.endif.endif.if.i.i ], [ %.1546.sroa.13.1.i.i, %B566.else.endif.endif.endif.i.i ]
  %.1634.i.i = sub nsw i64 %.1546.sroa.13.2.i.i, %.1546.sroa.0.3.i.i
  %.1643.i.i = tail call i64 @llvm.smax.i64(i64 %.1634.i.i, i64 0)
  %.1659.i.i = getelementptr double, ptr %.2814.i, i64 %.1546.sroa.0.3.i.i
  %.1699.le.i.i = tail call contract double @llvm.log.f64(double %.211.i.i)
  %.1733.i.i = load i64, ptr %.1732.i.i, align 8, !noalias !58
  %.1765.i.i = add nsw i64 %.1733.i.i, %.450.i.i
  %.1802.i.i = icmp slt i64 %.1733.i.i, 0
  %.1803.i.i = select i1 %.1802.i.i, i64 %arg.n_weights, i64 0
  %.1804.i.i = add i64 %.1803.i.i, %.1733.i.i
  %.1807.i.i = icmp slt i64 %.1804.i.i, 0
  br i1 %.1807.i.i, label %for.end.else.if.i.i, label %for.end.else.endif.i.i, !prof !4

for.end.else.if.i.i:                              ; preds = %B566.else.endif.endif.endif.endif.i.i
  br label %for.end.else.endif.i.i

for.end.else.endif.i.i:                           ; preds = %for.end.else.if.i.i, %B566.else.endif.endif.endif.endif.i.i
  %.1792.sroa.0.1.i.i = phi i64 [ 0, %for.end.else.if.i.i ], [ %.1804.i.i, %B566.else.endif.endif.endif.endif.i.i ]
  %.1812.not.i.i = icmp slt i64 %.1804.i.i, %arg.n_weights
  br i1 %.1812.not.i.i, label %for.end.else.endif.endif.i.i, label %for.end.else.endif.if.i.i, !prof !5

for.end.else.endif.if.i.i:                        ; preds = %for.end.else.endif.i.i
  br label %for.end.else.endif.endif.i.i

for.end.else.endif.endif.i.i:                     ; preds = %for.end.else.endif.if.i.i, %for.end.else.endif.i.i
  %.1792.sroa.0.3.i.i = phi i64 [ %arg.n_weights, %for.end.else.endif.if.i.i ], [ %.1792.sroa.0.1.i.i, %for.end.else.endif.i.i ]
  %.1819.i.i = icmp slt i64 %.1765.i.i, 0
  %.1820.i.i = select i1 %.1819.i.i, i64 %arg.n_weights, i64 0
  %.1821.i.i = add i64 %.1820.i.i, %.1765.i.i
  %.1824.i.i = icmp slt i64 %.1821.i.i, 0
  br i1 %.1824.i.i, label %for.end.else.endif.endif.if.i.i, label %for.end.else.endif.endif.endif.i.i, !prof !4

for.end.else.endif.endif.if.i.i:                  ; preds = %for.end.else.endif.endif.i.i
  br label %for.end.else.endif.endif.endif.i.i

for.end.else.endif.endif.endif.i.i:               ; preds = %for.end.else.endif.endif.if.i.i, %for.end.else.endif.endif.i.i
  %.1792.sroa.13.1.i.i = phi i64 [ 0, %for.end.else.endif.endif.if.i.i ], [ %.1821.i.i, %for.end.else.endif.endif.i.i ]
  %.1829.not.i.i = icmp slt i64 %.1821.i.i, %arg.n_weights
  br i1 %.1829.not.i.i, label %for.end.else.endif.endif.endif.endif.i.i, label %for.end.else.endif.endif.endif.if.i.i, !prof !5

for.end.else.endif.endif.endif.if.i.i:            ; preds = %for.end.else.endif.endif.endif.i.i
  br label %for.end.else.endif.endif.endif.endif.i.i

for.end.else.endif.endif.endif.endif.i.i:         ; preds = %for.end.else.endif.endif.endif.if.i.i, %for.end.else.endif.endif.endif.i.i
  %.1792.sroa.13.2.i.i = phi i64 [ %arg.n_weights, %for.end.else.endif.endif.endif.if.i.i ], [ %.1792.sroa.13.1.i.i, %for.end.else.endif.endif.endif.i.i ]
  %.1880.i.i = sub i64 %.1792.sroa.13.2.i.i, %.1792.sroa.0.3.i.i
  %.1889.i.i = tail call i64 @llvm.smax.i64(i64 %.1880.i.i, i64 0)
  %.1905.i.i = getelementptr double, ptr %arg.weights, i64 %.1792.sroa.0.3.i.i
  %.1994.i.i = add i64 %.711.i.i, %.450.i.i
  %.1997.i.i = icmp slt i64 %.1994.i.i, 0
  %.2002.not.i.i = icmp slt i64 %.1994.i.i, %.605.i
  br i1 %.1997.i.i, label %for.end.endif.endif.else.if.i.i, label %for.end.endif.endif.else.endif.i.i, !prof !4

for.end.endif.endif.else.if.i.i:                  ; preds = %for.end.else.endif.endif.endif.endif.i.i
  br label %for.end.endif.endif.else.endif.i.i

for.end.endif.endif.else.endif.i.i:               ; preds = %for.end.endif.endif.else.if.i.i, %for.end.else.endif.endif.endif.endif.i.i
  %.2139.sroa.0.1.i.i = phi i64 [ 0, %for.end.endif.endif.else.if.i.i ], [ %.1994.i.i, %for.end.else.endif.endif.endif.endif.i.i ]
  br i1 %.2002.not.i.i, label %for.end.endif.endif.else.endif.endif.i.i, label %for.end.endif.endif.else.endif.if.i.i, !prof !5

for.end.endif.endif.else.endif.if.i.i:            ; preds = %for.end.endif.endif.else.endif.i.i
  br label %for.end.endif.endif.else.endif.endif.i.i

for.end.endif.endif.else.endif.endif.i.i:         ; preds = %for.end.endif.endif.else.endif.if.i.i, %for.end.endif.endif.else.endif.i.i
  %.2139.sroa.0.3.i.i = phi i64 [ %.605.i, %for.end.endif.endif.else.endif.if.i.i ], [ %.2139.sroa.0.1.i.i, %for.end.endif.endif.else.endif.i.i ]
  %.2252.i.i = getelementptr double, ptr %.621.i, i64 %.2139.sroa.0.3.i.i
  %.2323.i.i = select i1 %.1556.i.i, i64 %a.2.sroa.60.2.i, i64 0
  %.2324.i.i = add i64 %.2323.i.i, %low.6.1.i.i.i
  %.2327.i.i = icmp slt i64 %.2324.i.i, 0
  br i1 %.2327.i.i, label %for.end.endif.endif.endif.else.if.i.i, label %for.end.endif.endif.endif.else.endif.i.i, !prof !4

for.end.endif.endif.endif.else.if.i.i:            ; preds = %for.end.endif.endif.else.endif.endif.i.i
  br label %for.end.endif.endif.endif.else.endif.i.i

for.end.endif.endif.endif.else.endif.i.i:         ; preds = %for.end.endif.endif.endif.else.if.i.i, %for.end.endif.endif.else.endif.endif.i.i
  %.2312.sroa.0.1.i.i = phi i64 [ 0, %for.end.endif.endif.endif.else.if.i.i ], [ %.2324.i.i, %for.end.endif.endif.else.endif.endif.i.i ]
  %.2332.not.i.i = icmp slt i64 %.2324.i.i, %a.2.sroa.60.2.i
  br i1 %.2332.not.i.i, label %for.end.endif.endif.endif.else.endif.endif.i.i, label %for.end.endif.endif.endif.else.endif.if.i.i, !prof !5

for.end.endif.endif.endif.else.endif.if.i.i:      ; preds = %for.end.endif.endif.endif.else.endif.i.i
  br label %for.end.endif.endif.endif.else.endif.endif.i.i

for.end.endif.endif.endif.else.endif.endif.i.i:   ; preds = %for.end.endif.endif.endif.else.endif.if.i.i, %for.end.endif.endif.endif.else.endif.i.i
  %.2312.sroa.0.3.i.i = phi i64 [ %a.2.sroa.60.2.i, %for.end.endif.endif.endif.else.endif.if.i.i ], [ %.2312.sroa.0.1.i.i, %for.end.endif.endif.endif.else.endif.i.i ]
  %.2340.i.i = select i1 %.1573.i.i, i64 %a.2.sroa.60.2.i, i64 0
  %.2341.i.i = add i64 %.2340.i.i, %low.6.1.i9.i.i
  %.2344.i.i = icmp slt i64 %.2341.i.i, 0
  br i1 %.2344.i.i, label %for.end.endif.endif.endif.else.endif.endif.if.i.i, label %for.end.endif.endif.endif.else.endif.endif.endif.i.i, !prof !4

for.end.endif.endif.endif.else.endif.endif.if.i.i: ; preds = %for.end.endif.endif.endif.else.endif.endif.i.i
  br label %for.end.endif.endif.endif.else.endif.endif.endif.i.i

for.end.endif.endif.endif.else.endif.endif.endif.i.i: ; preds = %for.end.endif.endif.endif.else.endif.endif.if.i.i, %for.end.endif.endif.endif.else.endif.endif.i.i
  %.2312.sroa.13.1.i.i = phi i64 [ 0, %for.end.endif.endif.endif.else.endif.endif.if.i.i ], [ %.2341.i.i, %for.end.endif.endif.endif.else.endif.endif.i.i ]
  %.2349.not.i.i = icmp slt i64 %.2341.i.i, %a.2.sroa.60.2.i
  br i1 %.2349.not.i.i, label %for.end.endif.endif.endif.else.endif.endif.endif.endif.i.i, label %for.end.endif.endif.endif.else.endif.endif.endif.if.i.i, !prof !5

for.end.endif.endif.endif.else.endif.endif.endif.if.i.i: ; preds = %for.end.endif.endif.endif.else.endif.endif.endif.i.i
  br label %for.end.endif.endif.endif.else.endif.endif.endif.endif.i.i

for.end.endif.endif.endif.else.endif.endif.endif.endif.i.i: ; preds = %for.end.endif.endif.endif.else.endif.endif.endif.if.i.i, %for.end.endif.endif.endif.else.endif.endif.endif.i.i
  %.2312.sroa.13.2.i.i = phi i64 [ %a.2.sroa.60.2.i, %for.end.endif.endif.endif.else.endif.endif.endif.if.i.i ], [ %.2312.sroa.13.1.i.i, %for.end.endif.endif.endif.else.endif.endif.endif.i.i ]
  %.2400.i.i = sub nsw i64 %.2312.sroa.13.2.i.i, %.2312.sroa.0.3.i.i
  %.2409.i.i = tail call i64 @llvm.smax.i64(i64 %.2400.i.i, i64 0)
  %.2425.i.i = getelementptr double, ptr %a.2.sroa.48.2.i, i64 %.2312.sroa.0.3.i.i
  store ptr null, ptr %.2457.i.i, align 8, !noalias !58
  call fastcc void @inner_0(ptr nonnull %.2457.i.i, ptr readonly %.1659.i.i, i64 %.1643.i.i, double %.1699.le.i.i, ptr readonly %.1905.i.i, i64 %.1889.i.i, ptr readonly %.621.i, ptr readonly %.2252.i.i, ptr %.2425.i.i, i64 %.2409.i.i)
  %.2532.i.i = load i64, ptr %.2531.i.i, align 8, !noalias !58
  %.2564.i.i = add nsw i64 %.2532.i.i, %.480.i.i
  %.2601.i.i = icmp slt i64 %.2532.i.i, 0
  %.2602.i.i = select i1 %.2601.i.i, i64 %arg.n_weights, i64 0
  %.2603.i.i = add i64 %.2602.i.i, %.2532.i.i
  %.2606.i.i = icmp slt i64 %.2603.i.i, 0
  br i1 %.2606.i.i, label %for.end.endif.endif.endif.endif.endif.else.if.i.i, label %for.end.endif.endif.endif.endif.endif.else.endif.i.i, !prof !4

for.end.endif.endif.endif.endif.endif.else.if.i.i: ; preds = %for.end.endif.endif.endif.else.endif.endif.endif.endif.i.i
  br label %for.end.endif.endif.endif.endif.endif.else.endif.i.i

for.end.endif.endif.endif.endif.endif.else.endif.i.i: ; preds = %for.end.endif.endif.endif.endif.endif.else.if.i.i, %for.end.endif.endif.endif.else.endif.endif.endif.endif.i.i
  %.2591.sroa.0.1.i.i = phi i64 [ 0, %for.end.endif.endif.endif.endif.endif.else.if.i.i ], [ %.2603.i.i, %for.end.endif.endif.endif.else.endif.endif.endif.endif.i.i ]
  %.2611.not.i.i = icmp slt i64 %.2603.i.i, %arg.n_weights
  br i1 %.2611.not.i.i, label %for.end.endif.endif.endif.endif.endif.else.endif.endif.i.i, label %for.end.endif.endif.endif.endif.endif.else.endif.if.i.i, !prof !5

for.end.endif.endif.endif.endif.endif.else.endif.if.i.i: ; preds = %for.end.endif.endif.endif.endif.endif.else.endif.i.i
  br label %for.end.endif.endif.endif.endif.endif.else.endif.endif.i.i

for.end.endif.endif.endif.endif.endif.else.endif.endif.i.i: ; preds = %for.end.endif.endif.endif.endif.endif.else.endif.if.i.i, %for.end.endif.endif.endif.endif.endif.else.endif.i.i
  %.2591.sroa.0.3.i.i = phi i64 [ %arg.n_weights, %for.end.endif.endif.endif.endif.endif.else.endif.if.i.i ], [ %.2591.sroa.0.1.i.i, %for.end.endif.endif.endif.endif.endif.else.endif.i.i ]
  %.2618.i.i = icmp slt i64 %.2564.i.i, 0
  %.2619.i.i = select i1 %.2618.i.i, i64 %arg.n_weights, i64 0
  %.2620.i.i = add i64 %.2619.i.i, %.2564.i.i
  %.2623.i.i = icmp slt i64 %.2620.i.i, 0
  br i1 %.2623.i.i, label %for.end.endif.endif.endif...if.i.i, label %for.end.endif.endif.endif...endif.i.i, !prof !4

for.end.endif.endif.endif...if.i.i:               ; preds = %for.end.endif.endif.endif.endif.endif.else.endif.endif.i.i
  br label %for.end.endif.endif.endif...endif.i.i

for.end.endif.endif.endif...endif.i.i:            ; preds = %for.end.endif.endif.endif...if.i.i, %for.end.endif.endif.endif.endif.endif.else.endif.endif.i.i
  %.2591.sroa.13.1.i.i = phi i64 [ 0, %for.end.endif.endif.endif...if.i.i ], [ %.2620.i.i, %for.end.endif.endif.endif.endif.endif.else.endif.endif.i.i ]
  %.2628.not.i.i = icmp slt i64 %.2620.i.i, %arg.n_weights
  br i1 %.2628.not.i.i, label %for.end.endif.endif.endif...endif.endif.i.i, label %for.end.endif.endif.endif...endif.if.i.i, !prof !5

for.end.endif.endif.endif...endif.if.i.i:         ; preds = %for.end.endif.endif.endif...endif.i.i
  br label %for.end.endif.endif.endif...endif.endif.i.i

for.end.endif.endif.endif...endif.endif.i.i:      ; preds = %for.end.endif.endif.endif...endif.if.i.i, %for.end.endif.endif.endif...endif.i.i
  %.2591.sroa.13.2.i.i = phi i64 [ %arg.n_weights, %for.end.endif.endif.endif...endif.if.i.i ], [ %.2591.sroa.13.1.i.i, %for.end.endif.endif.endif...endif.i.i ]
  %.2679.i.i = sub i64 %.2591.sroa.13.2.i.i, %.2591.sroa.0.3.i.i
  %.2688.i.i = tail call i64 @llvm.smax.i64(i64 %.2679.i.i, i64 0)
  %.2704.i.i = getelementptr double, ptr %arg.weights, i64 %.2591.sroa.0.3.i.i
  br i1 %.732.i.i, label %for.end.endif.endif.endif.endif.endif.endif.else.if.i.i, label %for.end.endif.endif.endif.endif.endif.endif.else.endif.i.i, !prof !4

for.end.endif.endif.endif.endif.endif.endif.else.if.i.i: ; preds = %for.end.endif.endif.endif...endif.endif.i.i
  br label %for.end.endif.endif.endif.endif.endif.endif.else.endif.i.i

for.end.endif.endif.endif.endif.endif.endif.else.endif.i.i: ; preds = %for.end.endif.endif.endif.endif.endif.endif.else.if.i.i, %for.end.endif.endif.endif...endif.endif.i.i
  %.2774.sroa.0.1.i.i = phi i64 [ 0, %for.end.endif.endif.endif.endif.endif.endif.else.if.i.i ], [ %.729.i.i, %for.end.endif.endif.endif...endif.endif.i.i ]
  br i1 %.737.not.i.i, label %for.end.endif.endif.endif...endif.2.i.i, label %for.end.endif.endif.endif...if.2.i.i, !prof !5

for.end.endif.endif.endif...if.2.i.i:             ; preds = %for.end.endif.endif.endif.endif.endif.endif.else.endif.i.i
  br label %for.end.endif.endif.endif...endif.2.i.i

for.end.endif.endif.endif...endif.2.i.i:          ; preds = %for.end.endif.endif.endif...if.2.i.i, %for.end.endif.endif.endif.endif.endif.endif.else.endif.i.i
  %.2774.sroa.0.3.i.i = phi i64 [ %.605.i, %for.end.endif.endif.endif...if.2.i.i ], [ %.2774.sroa.0.1.i.i, %for.end.endif.endif.endif.endif.endif.endif.else.endif.i.i ]
  %.2887.i.i = getelementptr double, ptr %.621.i, i64 %.2774.sroa.0.3.i.i
  %.2966.i.i = select i1 %.1556.i.i, i64 %p.2.sroa.60.2.i, i64 0
  %.2967.i.i = add i64 %.2966.i.i, %low.6.1.i.i.i
  %.2970.i.i = icmp slt i64 %.2967.i.i, 0
  br i1 %.2970.i.i, label %for.end.endif.endif.endif...if.4.i.i, label %for.end.endif.endif.endif...endif.4.i.i, !prof !4

for.end.endif.endif.endif...if.4.i.i:             ; preds = %for.end.endif.endif.endif...endif.2.i.i
  br label %for.end.endif.endif.endif...endif.4.i.i

for.end.endif.endif.endif...endif.4.i.i:          ; preds = %for.end.endif.endif.endif...if.4.i.i, %for.end.endif.endif.endif...endif.2.i.i
  %.2955.sroa.0.1.i.i = phi i64 [ 0, %for.end.endif.endif.endif...if.4.i.i ], [ %.2967.i.i, %for.end.endif.endif.endif...endif.2.i.i ]
  %.2975.not.i.i = icmp slt i64 %.2967.i.i, %p.2.sroa.60.2.i
  br i1 %.2975.not.i.i, label %for.end.endif.endif.endif...endif.4.endif.i.i, label %for.end.endif.endif.endif...endif.4.if.i.i, !prof !5

for.end.endif.endif.endif...endif.4.if.i.i:       ; preds = %for.end.endif.endif.endif...endif.4.i.i
  br label %for.end.endif.endif.endif...endif.4.endif.i.i

for.end.endif.endif.endif...endif.4.endif.i.i:    ; preds = %for.end.endif.endif.endif...endif.4.if.i.i, %for.end.endif.endif.endif...endif.4.i.i
  %.2955.sroa.0.3.i.i = phi i64 [ %p.2.sroa.60.2.i, %for.end.endif.endif.endif...endif.4.if.i.i ], [ %.2955.sroa.0.1.i.i, %for.end.endif.endif.endif...endif.4.i.i ]
  %.2983.i.i = select i1 %.1573.i.i, i64 %p.2.sroa.60.2.i, i64 0
  %.2984.i.i = add i64 %.2983.i.i, %low.6.1.i9.i.i
  %.2987.i.i = icmp slt i64 %.2984.i.i, 0
  br i1 %.2987.i.i, label %for.end.endif.endif.endif...endif.4.endif.if.i.i, label %for.end.endif.endif.endif...endif.4.endif.endif.i.i, !prof !4

for.end.endif.endif.endif...endif.4.endif.if.i.i: ; preds = %for.end.endif.endif.endif...endif.4.endif.i.i
  br label %for.end.endif.endif.endif...endif.4.endif.endif.i.i

for.end.endif.endif.endif...endif.4.endif.endif.i.i: ; preds = %for.end.endif.endif.endif...endif.4.endif.if.i.i, %for.end.endif.endif.endif...endif.4.endif.i.i
  %.2955.sroa.13.1.i.i = phi i64 [ 0, %for.end.endif.endif.endif...endif.4.endif.if.i.i ], [ %.2984.i.i, %for.end.endif.endif.endif...endif.4.endif.i.i ]
  %.2992.not.i.i = icmp slt i64 %.2984.i.i, %p.2.sroa.60.2.i
  br i1 %.2992.not.i.i, label %for.end.endif.endif.endif...endif.4.endif.endif.endif.i.i, label %for.end.endif.endif.endif...endif.4.endif.endif.if.i.i, !prof !5

for.end.endif.endif.endif...endif.4.endif.endif.if.i.i: ; preds = %for.end.endif.endif.endif...endif.4.endif.endif.i.i
  br label %for.end.endif.endif.endif...endif.4.endif.endif.endif.i.i

for.end.endif.endif.endif...endif.4.endif.endif.endif.i.i: ; preds = %for.end.endif.endif.endif...endif.4.endif.endif.if.i.i, %for.end.endif.endif.endif...endif.4.endif.endif.i.i
  %.2955.sroa.13.2.i.i = phi i64 [ %p.2.sroa.60.2.i, %for.end.endif.endif.endif...endif.4.endif.endif.if.i.i ], [ %.2955.sroa.13.1.i.i, %for.end.endif.endif.endif...endif.4.endif.endif.i.i ]
  %.3043.i.i = sub nsw i64 %.2955.sroa.13.2.i.i, %.2955.sroa.0.3.i.i
  %.3052.i.i = tail call i64 @llvm.smax.i64(i64 %.3043.i.i, i64 0)
  %.3068.i.i = getelementptr double, ptr %p.2.sroa.48.2.i, i64 %.2955.sroa.0.3.i.i
  store ptr null, ptr %.3101.i.i, align 8, !noalias !58
  call fastcc void @inner_0(ptr nonnull %.3101.i.i, ptr readonly %.1659.i.i, i64 %.1643.i.i, double %.1699.le.i.i, ptr readonly %.2704.i.i, i64 %.2688.i.i, ptr readonly %.813.i.i, ptr readonly %.2887.i.i, ptr %.3068.i.i, i64 %.3052.i.i)
  br label %B960.i.i

B960.endif.endif.else.endif.endif.if.i.i:         ; preds = %B960.i.i
  br label %B960.endif.endif.else.endif.endif.endif.i.i

B960.endif.endif.else.endif.endif.endif.i.i:      ; preds = %B960.endif.endif.else.endif.endif.if.i.i, %B960.i.i
  %.3348.sroa.13.1.i.i = phi i64 [ 0, %B960.endif.endif.else.endif.endif.if.i.i ], [ %.3377.i.i, %B960.i.i ]
  %.3385.not.i.i = icmp slt i64 %.3377.i.i, %a.2.sroa.60.2.i
  br i1 %.3385.not.i.i, label %B960.endif.endif.else.endif.endif.endif.endif.i.i, label %B960.endif.endif.else.endif.endif.endif.if.i.i, !prof !5

B960.endif.endif.else.endif.endif.endif.if.i.i:   ; preds = %B960.endif.endif.else.endif.endif.endif.i.i
  br label %B960.endif.endif.else.endif.endif.endif.endif.i.i

B960.endif.endif.else.endif.endif.endif.endif.i.i: ; preds = %B960.endif.endif.else.endif.endif.endif.if.i.i, %B960.endif.endif.else.endif.endif.endif.i.i
  %.3348.sroa.13.2.i.i = phi i64 [ %a.2.sroa.60.2.i, %B960.endif.endif.else.endif.endif.endif.if.i.i ], [ %.3348.sroa.13.1.i.i, %B960.endif.endif.else.endif.endif.endif.i.i ]
  %.63.i.i.i = fmul contract double %.211.i.i, 0x400921FB54442D18
  %.64.i.i.i = tail call contract double @llvm.pow.f64(double %.63.i.i.i, double 0x3FD5555555555555)
  %.87.i.i.i = fdiv contract double 1.000000e-02, %.211.i.i
  %.44.i.not.i.i.i = icmp eq i64 %.3348.sroa.13.2.i.i, 0
  br i1 %.44.i.not.i.i.i, label %B118.i.i.i.i, label %B28.i.i.i.i

B28.i.i.i.i:                                      ; preds = %B960.endif.endif.else.endif.endif.endif.endif.i.i
  %.94.i.i1.i.i = load double, ptr %.2641.i, align 8, !noalias !76
  %.98.i.i2.i.i = fcmp contract ugt double %.94.i.i1.i.i, %.87.i.i.i
  br i1 %.98.i.i2.i.i, label %B118.i.i.i.i, label %B52.i.i.i.i

B52.i.i.i.i:                                      ; preds = %B28.i.i.i.i, %B94.i.i.i.i
  %step.2.1.i.i.i.i = phi i64 [ %.123.i.i.i.i, %B94.i.i.i.i ], [ 1, %B28.i.i.i.i ]
  %high.4.1.i.i.i.i = phi i64 [ %.113.i.i3.i.i, %B94.i.i.i.i ], [ 0, %B28.i.i.i.i ]
  %.113.i.i3.i.i = add nuw nsw i64 %high.4.1.i.i.i.i, %step.2.1.i.i.i.i
  %.131.i.i.i.i = icmp slt i64 %.113.i.i3.i.i, %.3348.sroa.13.2.i.i
  br i1 %.131.i.i.i.i, label %B94.i.i.i.i, label %B118.loopexit.i.i.i.i

B94.i.i.i.i:                                      ; preds = %B52.i.i.i.i
  %.123.i.i.i.i = shl nsw i64 %step.2.1.i.i.i.i, 1
  %.178.i.i.i.i = getelementptr double, ptr %.2641.i, i64 %.113.i.i3.i.i
  %.179.i.i.i33.i = load double, ptr %.178.i.i.i.i, align 8, !noalias !76
  %.183.i.i.i34.i = fcmp contract ugt double %.179.i.i.i33.i, %.87.i.i.i
  br i1 %.183.i.i.i34.i, label %B118.loopexit.i.i.i.i, label %B52.i.i.i.i

B118.loopexit.i.i.i.i:                            ; preds = %B94.i.i.i.i, %B52.i.i.i.i
  %.104.le.i.i.i.i = add nuw nsw i64 %high.4.1.i.i.i.i, 1
  %209 = tail call i64 @llvm.smin.i64(i64 %.113.i.i3.i.i, i64 range(i64 0, -9223372036854775808) %.3348.sroa.13.2.i.i)
  br label %B118.i.i.i.i

B118.i.i.i.i:                                     ; preds = %B118.loopexit.i.i.i.i, %B28.i.i.i.i, %B960.endif.endif.else.endif.endif.endif.endif.i.i
  %low.3.0.i.i.i.i = phi i64 [ 0, %B28.i.i.i.i ], [ 0, %B960.endif.endif.else.endif.endif.endif.endif.i.i ], [ %.104.le.i.i.i.i, %B118.loopexit.i.i.i.i ]
  %high.5.0.i.i.i.i = phi i64 [ 0, %B28.i.i.i.i ], [ 0, %B960.endif.endif.else.endif.endif.endif.endif.i.i ], [ %209, %B118.loopexit.i.i.i.i ]
  %.238.i.i.i8.i = icmp slt i64 %low.3.0.i.i.i.i, %high.5.0.i.i.i.i
  br i1 %.238.i.i.i8.i, label %B146.i.i.i.i, label %B0.endif.endif.i.i.i

B146.i.i.i.i:                                     ; preds = %B118.i.i.i.i, %B146.i.i.i.i
  %low.4.0.i.i.i.i = phi i64 [ %low.5.1.i.i.i.i, %B146.i.i.i.i ], [ %low.3.0.i.i.i.i, %B118.i.i.i.i ]
  %high.7.0.i.i.i.i = phi i64 [ %high.8.1.i.i.i.i, %B146.i.i.i.i ], [ %high.5.0.i.i.i.i, %B118.i.i.i.i ]
  %.251.i.i.i.i = add nsw i64 %high.7.0.i.i.i.i, %low.4.0.i.i.i.i
  %.259.1.i.i.i.i = ashr i64 %.251.i.i.i.i, 1
  %.309.i.i.i31.i = icmp slt i64 %.259.1.i.i.i.i, 0
  %.310.i.i.i32.i = select i1 %.309.i.i.i31.i, i64 %.2625.i, i64 0
  %210 = getelementptr double, ptr %.2641.i, i64 %.259.1.i.i.i.i
  %.324.i.i.i.i = getelementptr double, ptr %210, i64 %.310.i.i.i32.i
  %.325.i.i.i.i = load double, ptr %.324.i.i.i.i, align 8, !noalias !76
  %.327.i.i.i.i = fcmp contract ole double %.325.i.i.i.i, %.87.i.i.i
  %.338.i.i.i.i = add nsw i64 %.259.1.i.i.i.i, 1
  %high.8.1.i.i.i.i = select i1 %.327.i.i.i.i, i64 %high.7.0.i.i.i.i, i64 %.259.1.i.i.i.i
  %low.5.1.i.i.i.i = select i1 %.327.i.i.i.i, i64 %.338.i.i.i.i, i64 %low.4.0.i.i.i.i
  %.369.i.i.i.i = icmp slt i64 %low.5.1.i.i.i.i, %high.8.1.i.i.i.i
  br i1 %.369.i.i.i.i, label %B146.i.i.i.i, label %B0.endif.endif.i.i.i

B648.i.i.i:                                       ; preds = %B408.if.i.i.i, %B0.endif.endif.endif.endif.i.i.i
  %.815.i.i.i = sub i64 %low.6.1.i8.i.i.i, %low.6.1.i.i.i.i
  %.858404.not.i.i.i = icmp slt i64 %.815.i.i.i, 1
  br i1 %.858404.not.i.i.i, label %B1038.i.i.i, label %B680.if.preheader.i.i.i

B680.if.preheader.i.i.i:                          ; preds = %B648.i.i.i
  %211 = add nuw i64 %.815.i.i.i, 1
  %212 = shl i64 %.2975.i, 3
  %213 = shl i64 %.2625.i, 3
  %214 = shl i64 %.3348.sroa.13.2.i.i, 3
  br label %B680.if.i.i.i

B1038.i.i.i:                                      ; preds = %B680.if.i.i.i, %B648.i.i.i
  %.1214.i.i.i = sub i64 %.3348.sroa.13.2.i.i, %low.6.1.i8.i.i.i
  %.1257411.not.i.i.i = icmp slt i64 %.1214.i.i.i, 1
  br i1 %.1257411.not.i.i.i, label %_ZN17bnserve_surrogate6kernel7_source16_scale_amplitudeB3v36B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEd5ArrayIdLi1E1C7mutable7alignedEd5ArrayIdLi1E1C7mutable7alignedE.exit.i.i, label %B1070.if.preheader.i.i.i

B1070.if.preheader.i.i.i:                         ; preds = %B1038.i.i.i
  %215 = add nuw i64 %.3348.sroa.13.2.i.i, 1
  %216 = sub i64 %215, %low.6.1.i8.i.i.i
  %217 = shl i64 %.3348.sroa.13.2.i.i, 3
  br label %B1070.if.i.i.i

B0.endif.endif.i.i.i:                             ; preds = %B146.i.i.i.i, %B118.i.i.i.i
  %low.6.1.i.i.i.i = phi i64 [ %low.3.0.i.i.i.i, %B118.i.i.i.i ], [ %low.5.1.i.i.i.i, %B146.i.i.i.i ]
  %.126.i.i.i = fdiv contract double 2.000000e-02, %.211.i.i
  %.44.i2.i.i.i = icmp slt i64 %low.6.1.i.i.i.i, %.3348.sroa.13.2.i.i
  br i1 %.44.i2.i.i.i, label %B28.i23.i.i.i, label %B118.i3.i.i.i

B28.i23.i.i.i:                                    ; preds = %B0.endif.endif.i.i.i
  %.78.i.i.i.i = icmp slt i64 %low.6.1.i.i.i.i, 0
  %.79.i.i.i.i = select i1 %.78.i.i.i.i, i64 %.2625.i, i64 0
  %218 = getelementptr double, ptr %.2641.i, i64 %low.6.1.i.i.i.i
  %.93.i.i56.i.i = getelementptr double, ptr %218, i64 %.79.i.i.i.i
  %.94.i24.i.i.i = load double, ptr %.93.i.i56.i.i, align 8, !noalias !81
  %.98.i25.i.i.i = fcmp contract ugt double %.94.i24.i.i.i, %.126.i.i.i
  br i1 %.98.i25.i.i.i, label %B118.i3.i.i.i, label %B52.i26.i.i.i

B52.i26.i.i.i:                                    ; preds = %B28.i23.i.i.i, %B94.i33.i.i.i
  %step.2.1.i27.i.i.i = phi i64 [ %.123.i34.i.i.i, %B94.i33.i.i.i ], [ 1, %B28.i23.i.i.i ]
  %high.4.1.i28.i.i.i = phi i64 [ %.113.i29.i.i.i, %B94.i33.i.i.i ], [ %low.6.1.i.i.i.i, %B28.i23.i.i.i ]
  %.113.i29.i.i.i = add nsw i64 %high.4.1.i28.i.i.i, %step.2.1.i27.i.i.i
  %.131.i30.i.i.i = icmp slt i64 %.113.i29.i.i.i, %.3348.sroa.13.2.i.i
  br i1 %.131.i30.i.i.i, label %B94.i33.i.i.i, label %B118.loopexit.i31.i.i.i

B94.i33.i.i.i:                                    ; preds = %B52.i26.i.i.i
  %.123.i34.i.i.i = shl nsw i64 %step.2.1.i27.i.i.i, 1
  %.163.i.i.i.i = icmp slt i64 %.113.i29.i.i.i, 0
  %.164.i.i.i.i = select i1 %.163.i.i.i.i, i64 %.2625.i, i64 0
  %219 = getelementptr double, ptr %.2641.i, i64 %.113.i29.i.i.i
  %.178.i35.i.i.i = getelementptr double, ptr %219, i64 %.164.i.i.i.i
  %.179.i36.i.i.i = load double, ptr %.178.i35.i.i.i, align 8, !noalias !81
  %.183.i37.i.i.i = fcmp contract ugt double %.179.i36.i.i.i, %.126.i.i.i
  br i1 %.183.i37.i.i.i, label %B118.loopexit.i31.i.i.i, label %B52.i26.i.i.i

B118.loopexit.i31.i.i.i:                          ; preds = %B94.i33.i.i.i, %B52.i26.i.i.i
  %.104.le.i32.i.i.i = add nsw i64 %high.4.1.i28.i.i.i, 1
  br label %B118.i3.i.i.i

B118.i3.i.i.i:                                    ; preds = %B118.loopexit.i31.i.i.i, %B28.i23.i.i.i, %B0.endif.endif.i.i.i
  %low.3.0.i4.i.i.i = phi i64 [ %low.6.1.i.i.i.i, %B28.i23.i.i.i ], [ %low.6.1.i.i.i.i, %B0.endif.endif.i.i.i ], [ %.104.le.i32.i.i.i, %B118.loopexit.i31.i.i.i ]
  %high.5.0.i5.i.i.i = phi i64 [ %low.6.1.i.i.i.i, %B28.i23.i.i.i ], [ %low.6.1.i.i.i.i, %B0.endif.endif.i.i.i ], [ %.113.i29.i.i.i, %B118.loopexit.i31.i.i.i ]
  %spec.select.i6.i.i.i = tail call i64 @llvm.smin.i64(i64 %high.5.0.i5.i.i.i, i64 range(i64 0, -9223372036854775808) %.3348.sroa.13.2.i.i)
  %.238.i7.i.i.i = icmp slt i64 %low.3.0.i4.i.i.i, %spec.select.i6.i.i.i
  br i1 %.238.i7.i.i.i, label %B146.i9.i.i.i, label %B0.endif.endif.endif.endif.i.i.i

B146.i9.i.i.i:                                    ; preds = %B118.i3.i.i.i, %B146.i9.i.i.i
  %low.4.0.i10.i.i.i = phi i64 [ %low.5.1.i21.i.i.i, %B146.i9.i.i.i ], [ %low.3.0.i4.i.i.i, %B118.i3.i.i.i ]
  %high.7.0.i11.i.i.i = phi i64 [ %high.8.1.i20.i.i.i, %B146.i9.i.i.i ], [ %spec.select.i6.i.i.i, %B118.i3.i.i.i ]
  %.251.i12.i.i.i = add nsw i64 %high.7.0.i11.i.i.i, %low.4.0.i10.i.i.i
  %.259.1.i13.i.i.i = ashr i64 %.251.i12.i.i.i, 1
  %.309.i14.i.i.i = icmp slt i64 %.259.1.i13.i.i.i, 0
  %.310.i15.i.i.i = select i1 %.309.i14.i.i.i, i64 %.2625.i, i64 0
  %220 = getelementptr double, ptr %.2641.i, i64 %.259.1.i13.i.i.i
  %.324.i16.i.i.i = getelementptr double, ptr %220, i64 %.310.i15.i.i.i
  %.325.i17.i.i.i = load double, ptr %.324.i16.i.i.i, align 8, !noalias !81
  %.327.i18.i.i.i = fcmp contract ole double %.325.i17.i.i.i, %.126.i.i.i
  %.338.i19.i.i.i = add nsw i64 %.259.1.i13.i.i.i, 1
  %high.8.1.i20.i.i.i = select i1 %.327.i18.i.i.i, i64 %high.7.0.i11.i.i.i, i64 %.259.1.i13.i.i.i
  %low.5.1.i21.i.i.i = select i1 %.327.i18.i.i.i, i64 %.338.i19.i.i.i, i64 %low.4.0.i10.i.i.i
  %.369.i22.i.i.i = icmp slt i64 %low.5.1.i21.i.i.i, %high.8.1.i20.i.i.i
  br i1 %.369.i22.i.i.i, label %B146.i9.i.i.i, label %B0.endif.endif.endif.endif.i.i.i

B0.endif.endif.endif.endif.i.i.i:                 ; preds = %B146.i9.i.i.i, %B118.i3.i.i.i
  %low.6.1.i8.i.i.i = phi i64 [ %low.3.0.i4.i.i.i, %B118.i3.i.i.i ], [ %low.5.1.i21.i.i.i, %B146.i9.i.i.i ]
  %.187.i.i.i = load double, ptr %.793.i, align 8, !noalias !84
  %.188.i.i.i = fmul contract double %.3319.i.i, %.187.i.i.i
  %.217.i.i.i = load double, ptr %.138.i.i.i, align 8, !noalias !84
  %.218.i.i.i = fmul contract double %.3319.i.i, %.217.i.i.i
  %.247.i.i.i = load double, ptr %.169.i.i.i, align 8, !noalias !84
  %.248.i.i.i = fmul contract double %.3319.i.i, %.247.i.i.i
  %.277.i.i.i = load double, ptr %.203.i.i.i, align 8, !noalias !84
  %.278.i.i.i = fmul contract double %.3319.i.i, %.277.i.i.i
  %.343.i.i.i = load double, ptr %.236.i.i.i, align 8, !noalias !84
  %.344.i.i.i = fmul contract double %.3319.i.i, %.343.i.i.i
  %.373.i.i.i = load double, ptr %.427.i.i.i, align 8, !noalias !84
  %.374.i.i.i = fmul contract double %.3319.i.i, %.373.i.i.i
  %.403.i.i.i = load double, ptr %.548.i.i.i, align 8, !noalias !84
  %.404.i.i.i = fmul contract double %.3319.i.i, %.403.i.i.i
  %.433.i.i.i = load double, ptr %.948.i.i.i, align 8, !noalias !84
  %.437.i.i.i = fmul contract double %.3319.i.i, %.433.i.i.i
  %.474.i.i.i = fmul contract double %.3319.i.i, 2.000000e+01
  %.558398.not.i.i.i = icmp slt i64 %low.6.1.i.i.i.i, 1
  br i1 %.558398.not.i.i.i, label %B648.i.i.i, label %B408.if.i.i.i

B408.if.i.i.i:                                    ; preds = %B0.endif.endif.endif.endif.i.i.i, %B408.if.i.i.i
  %.564397399.i.i.i = phi i64 [ %.571.i.i.i, %B408.if.i.i.i ], [ 0, %B0.endif.endif.endif.endif.i.i.i ]
  %.571.i.i.i = add nuw nsw i64 %.564397399.i.i.i, 1
  %221 = shl i64 %.564397399.i.i.i, 3
  %scevgep52.i.i.i = getelementptr i8, ptr %.2991.i, i64 %221
  %.625.i.i.i = load double, ptr %scevgep52.i.i.i, align 8, !noalias !84
  %.627.i.i.i = fmul contract double %.64.i.i.i, %.625.i.i.i
  %.631.i.i.i = fdiv contract double 1.000000e+00, %.627.i.i.i
  %.633.i.i.i = fmul contract double %.437.i.i.i, %.627.i.i.i
  %.635.i.i.i = fadd contract double %.404.i.i.i, %.633.i.i.i
  %.636.i.i.i = fmul contract double %.627.i.i.i, %.635.i.i.i
  %.638.i.i.i = fadd contract double %.374.i.i.i, %.636.i.i.i
  %.639.i.i.i = fmul contract double %.627.i.i.i, %.638.i.i.i
  %.641.i.i.i = fadd contract double %.344.i.i.i, %.639.i.i.i
  %.642.i.i.i = fmul contract double %.627.i.i.i, %.641.i.i.i
  %.644.i.i.i = fadd contract double %.278.i.i.i, %.642.i.i.i
  %.645.i.i.i = fmul contract double %.627.i.i.i, %.644.i.i.i
  %.647.i.i.i = fadd contract double %.248.i.i.i, %.645.i.i.i
  %.648.i.i.i = fmul contract double %.627.i.i.i, %.647.i.i.i
  %.650.i.i.i = fadd contract double %.218.i.i.i, %.648.i.i.i
  %.651.i.i.i = fmul contract double %.627.i.i.i, %.650.i.i.i
  %.653.i.i.i = fadd contract double %.188.i.i.i, %.651.i.i.i
  %scevgep2.i.i.i = getelementptr i8, ptr %a.2.sroa.48.2.i, i64 %221
  %.684.i.i.i = load double, ptr %scevgep2.i.i.i, align 8, !noalias !84
  %.685.i.i.i = fmul contract double %.684.i.i.i, 0x3FF71547652B82FE
  %.686.i.i.i = fadd contract double %.685.i.i.i, 0x4338000000000000
  %.687.i.i.i = fadd contract double %.686.i.i.i, 0xC338000000000000
  %.688.i.i.i = fmul contract double %.687.i.i.i, 0x3FE62E42FEE00000
  %.689.i.i.i = fsub contract double %.684.i.i.i, %.688.i.i.i
  %.690.i.i.i = fmul contract double %.687.i.i.i, 0x3DEA39EF35793C76
  %.691.i.i.i = fsub contract double %.689.i.i.i, %.690.i.i.i
  %.692.i.i.i = fmul contract double %.691.i.i.i, 0x3DE6124613A86D09
  %.693.i.i.i = fadd contract double %.692.i.i.i, 0x3E21EED8EFF8D898
  %.694.i.i.i = fmul contract double %.691.i.i.i, %.693.i.i.i
  %.695.i.i.i = fadd contract double %.694.i.i.i, 0x3E5AE64567F544E4
  %.696.i.i.i = fmul contract double %.691.i.i.i, %.695.i.i.i
  %.697.i.i.i = fadd contract double %.696.i.i.i, 0x3E927E4FB7789F5C
  %.698.i.i.i = fmul contract double %.691.i.i.i, %.697.i.i.i
  %.699.i.i.i = fadd contract double %.698.i.i.i, 0x3EC71DE3A556C734
  %.700.i.i.i = fmul contract double %.691.i.i.i, %.699.i.i.i
  %.701.i.i.i = fadd contract double %.700.i.i.i, 0x3EFA01A01A01A01A
  %.702.i.i.i = fmul contract double %.691.i.i.i, %.701.i.i.i
  %.703.i.i.i = fadd contract double %.702.i.i.i, 0x3F2A01A01A01A01A
  %.704.i.i.i = fmul contract double %.691.i.i.i, %.703.i.i.i
  %.705.i.i.i = fadd contract double %.704.i.i.i, 0x3F56C16C16C16C17
  %.706.i.i.i = fmul contract double %.691.i.i.i, %.705.i.i.i
  %.707.i.i.i = fadd contract double %.706.i.i.i, 0x3F81111111111111
  %.708.i.i.i = fmul contract double %.691.i.i.i, %.707.i.i.i
  %.709.i.i.i = fadd contract double %.708.i.i.i, 0x3FA5555555555555
  %.710.i.i.i = fmul contract double %.691.i.i.i, %.709.i.i.i
  %.711.i.i.i = fadd contract double %.710.i.i.i, 0x3FC5555555555555
  %.712.i.i.i = fmul contract double %.691.i.i.i, %.711.i.i.i
  %.713.i.i.i = fadd contract double %.712.i.i.i, 5.000000e-01
  %.714.i.i.i = fmul contract double %.691.i.i.i, %.691.i.i.i
  %.715.i.i.i = fmul contract double %.714.i.i.i, %.713.i.i.i
  %.716.i.i.i = fadd contract double %.691.i.i.i, %.715.i.i.i
  %.717.i.i.i = fadd contract double %.716.i.i.i, 1.000000e+00
  %.718.i.i.i = bitcast double %.686.i.i.i to i64
  %.719.i.i.i = shl i64 %.718.i.i.i, 52
  %.720.i.i.i = add i64 %.719.i.i.i, 4607182418800017408
  %.721.i.i.i = bitcast i64 %.720.i.i.i to double
  %.722.i.i.i = fmul contract double %.717.i.i.i, %.721.i.i.i
  %.723.i.i.i = fmul contract double %.631.i.i.i, %.631.i.i.i
  %.724.i.i.i = fmul contract double %.631.i.i.i, %.723.i.i.i
  %.732.i.i9.i = tail call contract double @sqrt(double %.631.i.i.i)
  %.737.i.i.i = fmul contract double %.732.i.i9.i, %.724.i.i.i
  %.738.i.i.i = fmul contract double %.737.i.i.i, %.653.i.i.i
  %.739.i.i.i = fmul contract double %.738.i.i.i, %.722.i.i.i
  store double %.739.i.i.i, ptr %scevgep2.i.i.i, align 8, !noalias !84
  %exitcond.not.i4.i.i = icmp eq i64 %low.6.1.i.i.i.i, %.571.i.i.i
  br i1 %exitcond.not.i4.i.i, label %B648.i.i.i, label %B408.if.i.i.i

B680.if.i.i.i:                                    ; preds = %B680.if.i.i.i, %B680.if.preheader.i.i.i
  %lsr.iv43.i.i.i = phi i64 [ %211, %B680.if.preheader.i.i.i ], [ %lsr.iv.next44.i.i.i, %B680.if.i.i.i ]
  %.864403405.i.i.i = phi i64 [ %low.6.1.i.i.i.i, %B680.if.preheader.i.i.i ], [ %.871.i.i.i, %B680.if.i.i.i ]
  %.909.i.i.i = icmp slt i64 %.864403405.i.i.i, 0
  %222 = select i1 %.909.i.i.i, i64 %212, i64 0
  %scevgep49.i.i.i = getelementptr i8, ptr %.2991.i, i64 %222
  %223 = shl i64 %.864403405.i.i.i, 3
  %scevgep50.i.i.i = getelementptr i8, ptr %scevgep49.i.i.i, i64 %223
  %.925.i.i10.i = load double, ptr %scevgep50.i.i.i, align 8, !noalias !84
  %224 = select i1 %.909.i.i.i, i64 %213, i64 0
  %scevgep47.i.i.i = getelementptr i8, ptr %.2641.i, i64 %224
  %scevgep48.i.i.i = getelementptr i8, ptr %scevgep47.i.i.i, i64 %223
  %.1000.i.i.i = load double, ptr %scevgep48.i.i.i, align 8, !noalias !84
  %.1002.i.i.i = fmul contract double %.211.i.i, %.1000.i.i.i
  %.1003.i.i.i = fadd contract double %.1002.i.i.i, -1.000000e-02
  %.1008.i.i.i = fdiv contract double %.1003.i.i.i, 1.000000e-02
  %.6.i.i5.i.i = fmul contract double %.1008.i.i.i, 0x400921FB54442D18
  %.7.i.i6.i.i = fmul contract double %.6.i.i5.i.i, 0x3FE45F306DC9C883
  %.8.i.i7.i.i = fadd contract double %.7.i.i6.i.i, 0x4338000000000000
  %.9.i.i8.i.i = fadd contract double %.8.i.i7.i.i, 0xC338000000000000
  %.27.i.i9.i.i = fmul contract double %.9.i.i8.i.i, 0x3FF921FA00000000
  %.28.i.i10.i.i = fsub contract double %.6.i.i5.i.i, %.27.i.i9.i.i
  %.46.i.i11.i.i = fmul contract double %.9.i.i8.i.i, 0x3EB5444200000000
  %.47.i.i12.i.i = fsub contract double %.28.i.i10.i.i, %.46.i.i11.i.i
  %.65.i.i13.i.i = fmul contract double %.9.i.i8.i.i, 0x3D6A308C00000000
  %.66.i.i14.i.i = fsub contract double %.47.i.i12.i.i, %.65.i.i13.i.i
  %.84.i.i15.i.i = fmul contract double %.9.i.i8.i.i, 0x3C2313198A2E0370
  %.85.i.i16.i.i = fsub contract double %.66.i.i14.i.i, %.84.i.i15.i.i
  %.86.i.i17.i.i = fmul contract double %.85.i.i16.i.i, %.85.i.i16.i.i
  %.87.i.i18.i.i = fmul contract double %.85.i.i16.i.i, %.86.i.i17.i.i
  %.88.i.i19.i.i = fmul contract double %.86.i.i17.i.i, 0x3D6AE7F3E733B81F
  %225 = fsub contract double 0x3DE6124613A86D09, %.88.i.i19.i.i
  %.90.i.i20.i.i = fmul contract double %.86.i.i17.i.i, %225
  %.91.i.i21.i.i = fadd contract double %.90.i.i20.i.i, 0xBE5AE64567F544E4
  %.92.i.i22.i.i = fmul contract double %.86.i.i17.i.i, %.91.i.i21.i.i
  %.93.i38.i.i.i = fadd contract double %.92.i.i22.i.i, 0x3EC71DE3A556C734
  %.94.i39.i.i.i = fmul contract double %.86.i.i17.i.i, %.93.i38.i.i.i
  %.95.i.i23.i.i = fadd contract double %.94.i39.i.i.i, 0xBF2A01A01A01A01A
  %.96.i.i24.i.i = fmul contract double %.86.i.i17.i.i, %.95.i.i23.i.i
  %.97.i.i25.i.i = fadd contract double %.96.i.i24.i.i, 0x3F81111111111111
  %.98.i40.i.i.i = fmul contract double %.86.i.i17.i.i, %.97.i.i25.i.i
  %.99.i.i26.i.i = fadd contract double %.98.i40.i.i.i, 0xBFC5555555555555
  %.100.i.i27.i.i = fmul contract double %.87.i.i18.i.i, %.99.i.i26.i.i
  %.101.i.i28.i.i = fadd contract double %.85.i.i16.i.i, %.100.i.i27.i.i
  %.102.i.i29.i.i = fmul contract double %.86.i.i17.i.i, 0x3D2AE7F3E733B81F
  %.103.i.i30.i.i = fadd contract double %.102.i.i29.i.i, 0xBDA93974A8C07C9D
  %.104.i.i31.i.i = fmul contract double %.86.i.i17.i.i, %.103.i.i30.i.i
  %.105.i.i32.i.i = fadd contract double %.104.i.i31.i.i, 0x3E21EED8EFF8D898
  %.106.i.i33.i.i = fmul contract double %.86.i.i17.i.i, %.105.i.i32.i.i
  %.107.i.i34.i.i = fadd contract double %.106.i.i33.i.i, 0xBE927E4FB7789F5C
  %.108.i.i35.i.i = fmul contract double %.86.i.i17.i.i, %.107.i.i34.i.i
  %.109.i.i36.i.i = fadd contract double %.108.i.i35.i.i, 0x3EFA01A01A01A01A
  %.110.i.i37.i.i = fmul contract double %.86.i.i17.i.i, %.109.i.i36.i.i
  %.111.i.i38.i.i = fadd contract double %.110.i.i37.i.i, 0xBF56C16C16C16C17
  %.112.i.i39.i.i = fmul contract double %.86.i.i17.i.i, %.111.i.i38.i.i
  %.113.i41.i.i.i = fadd contract double %.112.i.i39.i.i, 0x3FA5555555555555
  %.114.i.i40.i.i = fmul contract double %.86.i.i17.i.i, %.113.i41.i.i.i
  %.115.i.i41.i.i = fadd contract double %.114.i.i40.i.i, -5.000000e-01
  %.116.i.i42.i.i = fmul contract double %.86.i.i17.i.i, %.115.i.i41.i.i
  %.117.i.i43.i.i = fadd contract double %.116.i.i42.i.i, 1.000000e+00
  %.118.i.i44.i.i = bitcast double %.8.i.i7.i.i to i64
  %.119.i.i45.i.i = and i64 %.118.i.i44.i.i, 1
  %226 = icmp eq i64 %.119.i.i45.i.i, 0
  %.127.i.i46.i.i = shl i64 %.118.i.i44.i.i, 62
  %.128.i.i47.i.i = add i64 %.127.i.i46.i.i, 4611686018427387904
  %.129.i.i48.i.i = and i64 %.128.i.i47.i.i, -9223372036854775808
  %.133.v.i.i49.i.i = select i1 %226, double %.117.i.i43.i.i, double %.101.i.i28.i.i
  %.133.i.i50.i.i = bitcast double %.133.v.i.i49.i.i to i64
  %.134.i.i51.i.i = xor i64 %.129.i.i48.i.i, %.133.i.i50.i.i
  %.135.i.i52.i.i = bitcast i64 %.134.i.i51.i.i to double
  %.151.i.i53.i.i = fsub contract double 1.000000e+00, %.135.i.i52.i.i
  %.152.i.i54.i.i = fmul contract double %.151.i.i53.i.i, 5.000000e-01
  %.927.i.i.i = fmul contract double %.64.i.i.i, %.925.i.i10.i
  %.931.i.i.i = fdiv contract double 1.000000e+00, %.927.i.i.i
  %.963.i.i.i = tail call contract double @sqrt(double %.931.i.i.i)
  %.954.i.i.i = fmul contract double %.931.i.i.i, %.931.i.i.i
  %.955.i.i.i = fmul contract double %.931.i.i.i, %.954.i.i.i
  %.933.i.i.i = fmul contract double %.437.i.i.i, %.927.i.i.i
  %.935.i.i.i = fadd contract double %.404.i.i.i, %.933.i.i.i
  %.936.i.i.i = fmul contract double %.927.i.i.i, %.935.i.i.i
  %.938.i.i.i = fadd contract double %.374.i.i.i, %.936.i.i.i
  %.939.i.i.i = fmul contract double %.927.i.i.i, %.938.i.i.i
  %.941.i.i.i = fadd contract double %.344.i.i.i, %.939.i.i.i
  %.942.i.i.i = fmul contract double %.927.i.i.i, %.941.i.i.i
  %.944.i.i.i = fadd contract double %.278.i.i.i, %.942.i.i.i
  %.945.i.i.i = fmul contract double %.927.i.i.i, %.944.i.i.i
  %.947.i.i.i = fadd contract double %.248.i.i.i, %.945.i.i.i
  %.948.i.i11.i = fmul contract double %.927.i.i.i, %.947.i.i.i
  %.950.i.i.i = fadd contract double %.218.i.i.i, %.948.i.i11.i
  %.951.i.i.i = fmul contract double %.927.i.i.i, %.950.i.i.i
  %.953.i.i.i = fadd contract double %.188.i.i.i, %.951.i.i.i
  %.871.i.i.i = add i64 %.864403405.i.i.i, 1
  %.968.i.i.i = fmul contract double %.963.i.i.i, %.955.i.i.i
  %.969.i.i.i = fmul contract double %.968.i.i.i, %.953.i.i.i
  %227 = select i1 %.909.i.i.i, i64 %214, i64 0
  %scevgep45.i.i.i = getelementptr i8, ptr %a.2.sroa.48.2.i, i64 %227
  %scevgep1.i.i.i = getelementptr i8, ptr %scevgep45.i.i.i, i64 %223
  %.1063.i.i.i = load double, ptr %scevgep1.i.i.i, align 8, !noalias !84
  %.1064.i.i.i = fmul contract double %.1063.i.i.i, 0x3FF71547652B82FE
  %.1065.i.i.i = fadd contract double %.1064.i.i.i, 0x4338000000000000
  %.1066.i.i.i = fadd contract double %.1065.i.i.i, 0xC338000000000000
  %.1067.i.i.i = fmul contract double %.1066.i.i.i, 0x3FE62E42FEE00000
  %.1068.i.i.i = fsub contract double %.1063.i.i.i, %.1067.i.i.i
  %.1069.i.i.i = fmul contract double %.1066.i.i.i, 0x3DEA39EF35793C76
  %.1070.i.i.i = fsub contract double %.1068.i.i.i, %.1069.i.i.i
  %.1071.i.i.i = fmul contract double %.1070.i.i.i, 0x3DE6124613A86D09
  %.1072.i.i.i = fadd contract double %.1071.i.i.i, 0x3E21EED8EFF8D898
  %.1073.i.i.i = fmul contract double %.1070.i.i.i, %.1072.i.i.i
  %.1074.i.i.i = fadd contract double %.1073.i.i.i, 0x3E5AE64567F544E4
  %.1075.i.i.i = fmul contract double %.1070.i.i.i, %.1074.i.i.i
  %.1076.i.i.i = fadd contract double %.1075.i.i.i, 0x3E927E4FB7789F5C
  %.1077.i.i.i = fmul contract double %.1070.i.i.i, %.1076.i.i.i
  %.1078.i.i.i = fadd contract double %.1077.i.i.i, 0x3EC71DE3A556C734
  %.1079.i.i.i = fmul contract double %.1070.i.i.i, %.1078.i.i.i
  %.1080.i.i.i = fadd contract double %.1079.i.i.i, 0x3EFA01A01A01A01A
  %.1081.i.i.i = fmul contract double %.1070.i.i.i, %.1080.i.i.i
  %.1082.i.i.i = fadd contract double %.1081.i.i.i, 0x3F2A01A01A01A01A
  %.1083.i.i.i = fmul contract double %.1070.i.i.i, %.1082.i.i.i
  %.1084.i.i.i = fadd contract double %.1083.i.i.i, 0x3F56C16C16C16C17
  %.1085.i.i.i = fmul contract double %.1070.i.i.i, %.1084.i.i.i
  %.1086.i.i.i = fadd contract double %.1085.i.i.i, 0x3F81111111111111
  %.1087.i.i.i = fmul contract double %.1070.i.i.i, %.1086.i.i.i
  %.1088.i.i.i = fadd contract double %.1087.i.i.i, 0x3FA5555555555555
  %.1089.i.i.i = fmul contract double %.1070.i.i.i, %.1088.i.i.i
  %.1090.i.i.i = fadd contract double %.1089.i.i.i, 0x3FC5555555555555
  %.1091.i.i.i = fmul contract double %.1070.i.i.i, %.1090.i.i.i
  %.1092.i.i.i = fadd contract double %.1091.i.i.i, 5.000000e-01
  %.1093.i.i.i = fmul contract double %.1070.i.i.i, %.1070.i.i.i
  %.1094.i.i.i = fmul contract double %.1093.i.i.i, %.1092.i.i.i
  %.1095.i.i.i = fadd contract double %.1070.i.i.i, %.1094.i.i.i
  %.1096.i.i.i = fadd contract double %.1095.i.i.i, 1.000000e+00
  %.1097.i.i.i = bitcast double %.1065.i.i.i to i64
  %.1098.i.i.i = shl i64 %.1097.i.i.i, 52
  %.1099.i.i.i = add i64 %.1098.i.i.i, 4607182418800017408
  %.1100.i.i.i = bitcast i64 %.1099.i.i.i to double
  %.1101.i.i.i = fmul contract double %.1096.i.i.i, %.1100.i.i.i
  %.1103.i.i.i = fsub contract double %.474.i.i.i, %.969.i.i.i
  %.1104.i.i.i = fmul contract double %.1103.i.i.i, %.152.i.i54.i.i
  %.1105.i.i.i = fadd contract double %.969.i.i.i, %.1104.i.i.i
  %.1106.i.i.i = fmul contract double %.1101.i.i.i, %.1105.i.i.i
  store double %.1106.i.i.i, ptr %scevgep1.i.i.i, align 8, !noalias !84
  %lsr.iv.next44.i.i.i = add i64 %lsr.iv43.i.i.i, -1
  %.858.i.i12.i = icmp sgt i64 %lsr.iv.next44.i.i.i, 1
  br i1 %.858.i.i12.i, label %B680.if.i.i.i, label %B1038.i.i.i

B1070.if.i.i.i:                                   ; preds = %B1070.if.i.i.i, %B1070.if.preheader.i.i.i
  %lsr.iv.i.i.i = phi i64 [ %216, %B1070.if.preheader.i.i.i ], [ %lsr.iv.next.i55.i.i, %B1070.if.i.i.i ]
  %.1263410412.i.i.i = phi i64 [ %low.6.1.i8.i.i.i, %B1070.if.preheader.i.i.i ], [ %.1270.i.i.i, %B1070.if.i.i.i ]
  %.1270.i.i.i = add i64 %.1263410412.i.i.i, 1
  %.1309.i.i.i = icmp slt i64 %.1263410412.i.i.i, 0
  %228 = select i1 %.1309.i.i.i, i64 %217, i64 0
  %scevgep.i.i.i = getelementptr i8, ptr %a.2.sroa.48.2.i, i64 %228
  %229 = shl i64 %.1263410412.i.i.i, 3
  %scevgep42.i.i.i = getelementptr i8, ptr %scevgep.i.i.i, i64 %229
  %.1325.i.i.i = load double, ptr %scevgep42.i.i.i, align 8, !noalias !84
  %.1326.i.i.i = fmul contract double %.1325.i.i.i, 0x3FF71547652B82FE
  %.1327.i.i.i = fadd contract double %.1326.i.i.i, 0x4338000000000000
  %.1328.i.i.i = fadd contract double %.1327.i.i.i, 0xC338000000000000
  %.1329.i.i.i = fmul contract double %.1328.i.i.i, 0x3FE62E42FEE00000
  %.1330.i.i13.i = fsub contract double %.1325.i.i.i, %.1329.i.i.i
  %.1331.i.i.i = fmul contract double %.1328.i.i.i, 0x3DEA39EF35793C76
  %.1332.i.i.i = fsub contract double %.1330.i.i13.i, %.1331.i.i.i
  %.1333.i.i.i = fmul contract double %.1332.i.i.i, 0x3DE6124613A86D09
  %.1334.i.i.i = fadd contract double %.1333.i.i.i, 0x3E21EED8EFF8D898
  %.1335.i.i.i = fmul contract double %.1332.i.i.i, %.1334.i.i.i
  %.1336.i.i.i = fadd contract double %.1335.i.i.i, 0x3E5AE64567F544E4
  %.1337.i.i.i = fmul contract double %.1332.i.i.i, %.1336.i.i.i
  %.1338.i.i.i = fadd contract double %.1337.i.i.i, 0x3E927E4FB7789F5C
  %.1339.i.i.i = fmul contract double %.1332.i.i.i, %.1338.i.i.i
  %.1340.i.i.i = fadd contract double %.1339.i.i.i, 0x3EC71DE3A556C734
  %.1341.i.i.i = fmul contract double %.1332.i.i.i, %.1340.i.i.i
  %.1342.i.i.i = fadd contract double %.1341.i.i.i, 0x3EFA01A01A01A01A
  %.1343.i.i.i = fmul contract double %.1332.i.i.i, %.1342.i.i.i
  %.1344.i.i.i = fadd contract double %.1343.i.i.i, 0x3F2A01A01A01A01A
  %.1345.i.i.i = fmul contract double %.1332.i.i.i, %.1344.i.i.i
  %.1346.i.i.i = fadd contract double %.1345.i.i.i, 0x3F56C16C16C16C17
  %.1347.i.i.i = fmul contract double %.1332.i.i.i, %.1346.i.i.i
  %.1348.i.i.i = fadd contract double %.1347.i.i.i, 0x3F81111111111111
  %.1349.i.i.i = fmul contract double %.1332.i.i.i, %.1348.i.i.i
  %.1350.i.i.i = fadd contract double %.1349.i.i.i, 0x3FA5555555555555
  %.1351.i.i.i = fmul contract double %.1332.i.i.i, %.1350.i.i.i
  %.1352.i.i.i = fadd contract double %.1351.i.i.i, 0x3FC5555555555555
  %.1353.i.i.i = fmul contract double %.1332.i.i.i, %.1352.i.i.i
  %.1354.i.i.i = fadd contract double %.1353.i.i.i, 5.000000e-01
  %.1355.i.i.i = fmul contract double %.1332.i.i.i, %.1332.i.i.i
  %.1356.i.i.i = fmul contract double %.1355.i.i.i, %.1354.i.i.i
  %.1357.i.i.i = fadd contract double %.1332.i.i.i, %.1356.i.i.i
  %.1358.i.i.i = fadd contract double %.1357.i.i.i, 1.000000e+00
  %.1359.i.i.i = bitcast double %.1327.i.i.i to i64
  %.1360.i.i.i = shl i64 %.1359.i.i.i, 52
  %.1361.i.i.i = add i64 %.1360.i.i.i, 4607182418800017408
  %.1362.i.i.i = bitcast i64 %.1361.i.i.i to double
  %.1363.i.i.i = fmul contract double %.1358.i.i.i, %.1362.i.i.i
  %.1365.i.i.i = fmul contract double %.474.i.i.i, %.1363.i.i.i
  store double %.1365.i.i.i, ptr %scevgep42.i.i.i, align 8, !noalias !84
  %lsr.iv.next.i55.i.i = add i64 %lsr.iv.i.i.i, -1
  %.1257.i.i.i = icmp sgt i64 %lsr.iv.next.i55.i.i, 1
  br i1 %.1257.i.i.i, label %B1070.if.i.i.i, label %_ZN17bnserve_surrogate6kernel7_source16_scale_amplitudeB3v36B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEd5ArrayIdLi1E1C7mutable7alignedEd5ArrayIdLi1E1C7mutable7alignedE.exit.i.i

_ZN17bnserve_surrogate6kernel7_source16_scale_amplitudeB3v36B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEd5ArrayIdLi1E1C7mutable7alignedEd5ArrayIdLi1E1C7mutable7alignedE.exit.i.i: ; preds = %B1070.if.i.i.i, %B1038.i.i.i
  %.3566.i.i = load double, ptr %.3565.i.i, align 8, !noalias !58
  %.3583.i.i = select i1 %.3582.i.i, i64 %.614.i.i, i64 0
  %230 = getelementptr i8, ptr %.630.i.i, i64 %.idx.i.i
  %.3597.i.i = getelementptr double, ptr %230, i64 %.3583.i.i
  %.3598.i.i = load double, ptr %.3597.i.i, align 8, !noalias !58
  %.3599.i.i = fsub contract double %.3566.i.i, %.3598.i.i
  %.3636.i.i = load i64, ptr %.243.i.i, align 8, !noalias !58
  %.3656.i.i = icmp slt i64 %.3636.i.i, -2
  %.3657.i.i = select i1 %.3656.i.i, i64 %arg.n_weights, i64 0
  %231 = getelementptr double, ptr %arg.weights, i64 %.3636.i.i
  %232 = getelementptr i8, ptr %231, i64 16
  %.3671.i.i = getelementptr double, ptr %232, i64 %.3657.i.i
  %.3672.i.i = load double, ptr %.3671.i.i, align 8, !noalias !58
  %.3688.i.i = fcmp contract ogt double %.3672.i.i, 0.000000e+00
  %or.cond.i.i = select i1 %.3682.i.i, i1 %.3688.i.i, i1 false
  br i1 %or.cond.i.i, label %B1286.i.i, label %B1324.i.i

B1286.endif.i.i:                                  ; preds = %_ZN17bnserve_surrogate6kernel7_source9_legendreB3v40B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dEd5ArrayIdLi2E1C7mutable7alignedE.exit.i.i
  %.3724.i.i = fadd contract double %.3599.i.i, %.3693.0.i.i
  br label %B1324.i.i

B1324.else.endif.endif.if.i.i:                    ; preds = %B1324.i.i
  br label %B1324.else.endif.endif.endif.i.i

B1324.else.endif.endif.endif.i.i:                 ; preds = %B1324.else.endif.endif.if.i.i, %B1324.i.i
  %.3842.sroa.13.1.i.i = phi i64 [ 0, %B1324.else.endif.endif.if.i.i ], [ %.3871.i.i, %B1324.i.i ]
  %.3879.not.i.i = icmp slt i64 %.3871.i.i, %p.2.sroa.60.2.i
  br i1 %.3879.not.i.i, label %B1324.else.endif.endif.endif.endif.i.i, label %B1324.else.endif.endif.endif.if.i.i, !prof !5

B1324.else.endif.endif.endif.if.i.i:              ; preds = %B1324.else.endif.endif.endif.i.i
  br label %B1324.else.endif.endif.endif.endif.i.i

B1324.else.endif.endif.endif.endif.i.i:           ; preds = %B1324.else.endif.endif.endif.if.i.i, %B1324.else.endif.endif.endif.i.i
  %.3842.sroa.13.2.i.i = phi i64 [ %p.2.sroa.60.2.i, %B1324.else.endif.endif.endif.if.i.i ], [ %.3842.sroa.13.1.i.i, %B1324.else.endif.endif.endif.i.i ]
  %.97.le.i.i.i = tail call contract double @llvm.log.f64(double %.211.i.i)
  %.105.i.i.i = fdiv contract double %.97.le.i.i.i, 3.000000e+00
  %.106.i.i.i = fadd contract double %.105.i.i.i, 0x3FD86BC06134D7A7
  %.164.i57.i.i = load double, ptr %arg.series, align 8, !noalias !85
  %.219.i.i.i = load double, ptr %9, align 8, !noalias !85
  %.272.i.i15.i = load double, ptr %.183.i.i.i.i, align 8, !noalias !85
  %.325.i60.i.i = load double, ptr %.308.i.i.i.i, align 8, !noalias !85
  %.414.i.i.i = load double, ptr %.413.i.i.i.i, align 8, !noalias !85
  %.467.i.i.i = load double, ptr %10, align 8, !noalias !85
  %.520.i.i17.i = load double, ptr %.686.i.i.i.i, align 8, !noalias !85
  %.573.i.i.i = load double, ptr %.970.i.i.i.i, align 8, !noalias !85
  %.662.i.i.i = load double, ptr %11, align 8, !noalias !85
  %.715.i62.i.i = load double, ptr %.1461.i.i.i.i, align 8, !noalias !85
  %.768.i.i18.i = load double, ptr %.1867.i.i.i.i, align 8, !noalias !85
  %.821.i.i.i = load double, ptr %.2256.i.i.i.i, align 8, !noalias !85
  %.910.i.i.i = load double, ptr %.211.i.i.i.i, align 8, !noalias !85
  %.963.i64.i.i = load double, ptr %.328.i123.i.i.i, align 8, !noalias !85
  %.1016.i.i.i = load double, ptr %.442.i.i.i.i, align 8, !noalias !85
  %.1069.i66.i.i = load double, ptr %.559.i.i.i.i, align 8, !noalias !85
  %.1158.i.i20.i = load double, ptr %.561.i.i.i.i, align 8, !noalias !85
  %.1211.i.i.i = load double, ptr %.865.i.i.i.i, align 8, !noalias !85
  %.1264.i.i.i = load double, ptr %16, align 8, !noalias !85
  %.1317.i.i.i = load double, ptr %.1118.i.i.i.i, align 8, !noalias !85
  %.1406.i.i.i = load double, ptr %.1640.i.i.i.i, align 8, !noalias !85
  %.1459.i.i.i = load double, ptr %.2145.i.i.i.i, align 8, !noalias !85
  %.1512.i.i.i = load double, ptr %.2474.i.i.i.i, align 8, !noalias !85
  %.1574.i.i.i = load double, ptr %.1336.i.i.i.i, align 8, !noalias !85
  %.1675660.not.i.i.i = icmp eq i64 %.3842.sroa.13.2.i.i, 0
  br i1 %.1675660.not.i.i.i, label %_ZN17bnserve_surrogate6kernel7_source13_finish_phaseB3v41B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEd5ArrayIdLi2E1C7mutable7alignedEdd5ArrayIdLi1E1C7mutable7alignedE.exit.i.i, label %B568.if.i.i.i

B568.if.i.i.i:                                    ; preds = %B1324.else.endif.endif.endif.endif.i.i, %B568.if.i.i.i
  %.1681659661.i.i.i = phi i64 [ %.1688.i.i.i, %B568.if.i.i.i ], [ 0, %B1324.else.endif.endif.endif.endif.i.i ]
  %.1688.i.i.i = add nuw nsw i64 %.1681659661.i.i.i, 1
  %233 = shl i64 %.1681659661.i.i.i, 3
  %scevgep3.i.i.i = getelementptr i8, ptr %.2991.i, i64 %233
  %.1742.i.i.i = load double, ptr %scevgep3.i.i.i, align 8, !noalias !85
  %.1744.i.i.i = fmul contract double %.64.i.i.i, %.1742.i.i.i
  %scevgep2.i67.i.i = getelementptr i8, ptr %.2814.i, i64 %233
  %.1774.i.i.i = load double, ptr %scevgep2.i67.i.i, align 8, !noalias !85
  %.1775.i.i.i = fmul contract double %.1774.i.i.i, 0x3FD5555555555555
  %.1777.i.i.i = fadd contract double %.106.i.i.i, %.1775.i.i.i
  %.1779.i.i.i = fmul contract double %.1069.i66.i.i, %.1744.i.i.i
  %.1781.i.i.i = fadd contract double %.1016.i.i.i, %.1779.i.i.i
  %.1782.i.i.i = fmul contract double %.1744.i.i.i, %.1781.i.i.i
  %.1784.i.i.i = fadd contract double %.963.i64.i.i, %.1782.i.i.i
  %.1785.i.i.i = fmul contract double %.1744.i.i.i, %.1784.i.i.i
  %.1787.i.i.i = fadd contract double %.910.i.i.i, %.1785.i.i.i
  %.1788.i.i.i = fmul contract double %.1744.i.i.i, %.1787.i.i.i
  %.1790.i.i.i = fadd contract double %.821.i.i.i, %.1788.i.i.i
  %.1791.i.i.i = fmul contract double %.1744.i.i.i, %.1790.i.i.i
  %.1793.i.i.i = fadd contract double %.768.i.i18.i, %.1791.i.i.i
  %.1794.i.i.i = fmul contract double %.1744.i.i.i, %.1793.i.i.i
  %.1796.i.i.i = fadd contract double %.715.i62.i.i, %.1794.i.i.i
  %.1797.i.i.i = fmul contract double %.1744.i.i.i, %.1796.i.i.i
  %.1799.i.i.i = fadd contract double %.662.i.i.i, %.1797.i.i.i
  %.1801.i.i.i = fmul contract double %.573.i.i.i, %.1744.i.i.i
  %.1803.i.i.i = fadd contract double %.520.i.i17.i, %.1801.i.i.i
  %.1804.i.i.i = fmul contract double %.1744.i.i.i, %.1803.i.i.i
  %.1806.i.i.i = fadd contract double %.467.i.i.i, %.1804.i.i.i
  %.1807.i.i.i = fmul contract double %.1744.i.i.i, %.1806.i.i.i
  %.1809.i.i.i = fadd contract double %.414.i.i.i, %.1807.i.i.i
  %.1810.i.i.i = fmul contract double %.1744.i.i.i, %.1809.i.i.i
  %.1812.i.i.i = fadd contract double %.325.i60.i.i, %.1810.i.i.i
  %.1813.i.i.i = fmul contract double %.1744.i.i.i, %.1812.i.i.i
  %.1815.i.i.i = fadd contract double %.272.i.i15.i, %.1813.i.i.i
  %.1816.i.i.i = fmul contract double %.1744.i.i.i, %.1815.i.i.i
  %.1818.i.i.i = fadd contract double %.219.i.i.i, %.1816.i.i.i
  %.1819.i.i.i = fmul contract double %.1744.i.i.i, %.1818.i.i.i
  %.1821.i.i.i = fadd contract double %.164.i57.i.i, %.1819.i.i.i
  %.1823.i.i.i = fmul contract double %.1512.i.i.i, %.1744.i.i.i
  %.1825.i.i21.i = fadd contract double %.1459.i.i.i, %.1823.i.i.i
  %.1826.i.i.i = fmul contract double %.1744.i.i.i, %.1825.i.i21.i
  %.1828.i.i.i = fadd contract double %.1406.i.i.i, %.1826.i.i.i
  %.1829.i.i.i = fmul contract double %.1744.i.i.i, %.1828.i.i.i
  %.1831.i.i.i = fadd contract double %.1317.i.i.i, %.1829.i.i.i
  %.1832.i.i.i = fmul contract double %.1744.i.i.i, %.1831.i.i.i
  %.1834.i.i22.i = fadd contract double %.1264.i.i.i, %.1832.i.i.i
  %.1835.i.i.i = fmul contract double %.1744.i.i.i, %.1834.i.i22.i
  %.1837.i.i.i = fadd contract double %.1211.i.i.i, %.1835.i.i.i
  %.1838.i.i.i = fmul contract double %.1744.i.i.i, %.1837.i.i.i
  %.1840.i.i.i = fadd contract double %.1158.i.i20.i, %.1838.i.i.i
  %.1841.i.i.i = fmul contract double %.1744.i.i.i, %.1744.i.i.i
  %.1842.i.i.i = fmul contract double %.1744.i.i.i, %.1841.i.i.i
  %.1846.i.i.i = fdiv contract double 1.000000e+00, %.1744.i.i.i
  %.1847.i.i.i = fmul contract double %.1846.i.i.i, %.1846.i.i.i
  %.1848.i.i.i = fmul contract double %.1847.i.i.i, %.1847.i.i.i
  %.1849.i.i.i = fmul contract double %.1846.i.i.i, %.1848.i.i.i
  %.1850.i.i23.i = fmul contract double %.1849.i.i.i, %.1821.i.i.i
  %.1851.i.i.i = fmul contract double %.1842.i.i.i, %.1799.i.i.i
  %.1852.i.i.i = fadd contract double %.1850.i.i23.i, %.1851.i.i.i
  %.1854.i.i.i = fmul contract double %.1574.i.i.i, %.1842.i.i.i
  %.1855.i.i.i = fmul contract double %.1777.i.i.i, %.1854.i.i.i
  %.1856.i.i.i = fadd contract double %.1855.i.i.i, %.1840.i.i.i
  %.1857.i.i.i = fmul contract double %.1777.i.i.i, %.1856.i.i.i
  %.1858.i.i.i = fadd contract double %.1857.i.i.i, %.1852.i.i.i
  %scevgep5.i.i.i = getelementptr i8, ptr %.2641.i, i64 %233
  %.1888.i.i.i = load double, ptr %scevgep5.i.i.i, align 8, !noalias !85
  %.1890.i.i.i = fmul contract double %.3813.i.i, %.1888.i.i.i
  %.1892.i.i.i = fadd contract double %constant.2.0.i.i, %.1890.i.i.i
  %scevgep4.i.i.i = getelementptr i8, ptr %p.2.sroa.48.2.i, i64 %233
  %.1922.i.i.i = load double, ptr %scevgep4.i.i.i, align 8, !noalias !85
  %.1923.i.i.i = fadd contract double %.1922.i.i.i, %.1858.i.i.i
  %.1924.i.i.i = fsub contract double %.1892.i.i.i, %.1923.i.i.i
  store double %.1924.i.i.i, ptr %scevgep4.i.i.i, align 8, !noalias !85
  %exitcond.not.i68.i.i = icmp eq i64 %.3842.sroa.13.2.i.i, %.1688.i.i.i
  br i1 %exitcond.not.i68.i.i, label %_ZN17bnserve_surrogate6kernel7_source13_finish_phaseB3v41B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEd5ArrayIdLi2E1C7mutable7alignedEdd5ArrayIdLi1E1C7mutable7alignedE.exit.i.i, label %B568.if.i.i.i

_ZN17bnserve_surrogate6kernel7_source13_finish_phaseB3v41B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEd5ArrayIdLi2E1C7mutable7alignedEdd5ArrayIdLi1E1C7mutable7alignedE.exit.i.i: ; preds = %B568.if.i.i.i, %B1324.else.endif.endif.endif.endif.i.i
  %.4100.i.i = sub i64 %.2625.i, %low.6.1.i9.i.i
  %.41431105.not.i.i = icmp slt i64 %.4100.i.i, 1
  br i1 %.41431105.not.i.i, label %_ZN17bnserve_surrogate6kernel7_source6_blockB3v28B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i, label %B1510.if.preheader.i.i

B1510.if.preheader.i.i:                           ; preds = %_ZN17bnserve_surrogate6kernel7_source13_finish_phaseB3v41B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEd5ArrayIdLi2E1C7mutable7alignedEdd5ArrayIdLi1E1C7mutable7alignedE.exit.i.i
  %.neg.i.i = add i64 %low.6.1.i9.i.i, 1
  %xtraiter.i.i = and i64 %.4100.i.i, 1
  %lcmp.mod.not.i.i = icmp eq i64 %xtraiter.i.i, 0
  br i1 %lcmp.mod.not.i.i, label %B1510.if.prol.loopexit.i.i, label %B1510.if.prol.i.i

B1510.if.prol.i.i:                                ; preds = %B1510.if.preheader.i.i
  %.4152.prol.i.i = add nsw i64 %.4100.i.i, -1
  %234 = getelementptr double, ptr %a.2.sroa.48.2.i, i64 %low.6.1.i9.i.i
  %.4209.prol.i.i = getelementptr double, ptr %234, i64 %.3376.i.i
  store double 0.000000e+00, ptr %.4209.prol.i.i, align 8, !noalias !58
  %235 = getelementptr double, ptr %p.2.sroa.48.2.i, i64 %low.6.1.i9.i.i
  %.4239.prol.i.i = getelementptr double, ptr %235, i64 %.3870.i.i
  store double 0.000000e+00, ptr %.4239.prol.i.i, align 8, !noalias !58
  br label %B1510.if.prol.loopexit.i.i

B1510.if.prol.loopexit.i.i:                       ; preds = %B1510.if.prol.i.i, %B1510.if.preheader.i.i
  %.414211031107.unr.i.i = phi i64 [ %.4100.i.i, %B1510.if.preheader.i.i ], [ %.4152.prol.i.i, %B1510.if.prol.i.i ]
  %.414911041106.unr.i.i = phi i64 [ %low.6.1.i9.i.i, %B1510.if.preheader.i.i ], [ %.neg.i.i, %B1510.if.prol.i.i ]
  %236 = icmp eq i64 %.2625.i, %.neg.i.i
  br i1 %236, label %_ZN17bnserve_surrogate6kernel7_source6_blockB3v28B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i, label %B1510.if.preheader43.i.i

B1510.if.preheader43.i.i:                         ; preds = %B1510.if.prol.loopexit.i.i
  %237 = add nuw i64 %.414211031107.unr.i.i, 2
  %238 = shl i64 %a.2.sroa.60.2.i, 3
  %239 = shl i64 %p.2.sroa.60.2.i, 3
  %240 = shl i64 %.414911041106.unr.i.i, 3
  %scevgep1.i24.i = getelementptr i8, ptr %p.2.sroa.48.2.i, i64 %240
  %scevgep5.i25.i = getelementptr i8, ptr %a.2.sroa.48.2.i, i64 %240
  %241 = add i64 %238, 8
  %242 = add i64 %239, 8
  br label %B1510.if.i.i

B1510.if.i.i:                                     ; preds = %B1510.if.i.i, %B1510.if.preheader43.i.i
  %lsr.iv6.i.i = phi ptr [ %scevgep7.i.i, %B1510.if.i.i ], [ %scevgep5.i25.i, %B1510.if.preheader43.i.i ]
  %lsr.iv2.i.i = phi ptr [ %scevgep3.i.i, %B1510.if.i.i ], [ %scevgep1.i24.i, %B1510.if.preheader43.i.i ]
  %lsr.iv.i26.i = phi i64 [ %lsr.iv.next.i.i, %B1510.if.i.i ], [ %237, %B1510.if.preheader43.i.i ]
  %.414911041106.i.i = phi i64 [ %248, %B1510.if.i.i ], [ %.414911041106.unr.i.i, %B1510.if.preheader43.i.i ]
  %.4194.i.i = icmp slt i64 %.414911041106.i.i, 0
  %243 = select i1 %.4194.i.i, i64 %238, i64 0
  %scevgep10.i.i = getelementptr i8, ptr %lsr.iv6.i.i, i64 %243
  store double 0.000000e+00, ptr %scevgep10.i.i, align 8, !noalias !58
  %244 = select i1 %.4194.i.i, i64 %239, i64 0
  %scevgep9.i.i = getelementptr i8, ptr %lsr.iv2.i.i, i64 %244
  store double 0.000000e+00, ptr %scevgep9.i.i, align 8, !noalias !58
  %245 = add i64 %.414911041106.i.i, 1
  %.4194.1.i.i = icmp slt i64 %245, 0
  %246 = select i1 %.4194.1.i.i, i64 %241, i64 8
  %scevgep8.i.i = getelementptr i8, ptr %lsr.iv6.i.i, i64 %246
  store double 0.000000e+00, ptr %scevgep8.i.i, align 8, !noalias !58
  %247 = select i1 %.4194.1.i.i, i64 %242, i64 8
  %scevgep4.i27.i = getelementptr i8, ptr %lsr.iv2.i.i, i64 %247
  store double 0.000000e+00, ptr %scevgep4.i27.i, align 8, !noalias !58
  %lsr.iv.next.i.i = add i64 %lsr.iv.i26.i, -2
  %scevgep3.i.i = getelementptr i8, ptr %lsr.iv2.i.i, i64 16
  %scevgep7.i.i = getelementptr i8, ptr %lsr.iv6.i.i, i64 16
  %.4143.1.i.i = icmp sgt i64 %lsr.iv.next.i.i, 2
  %248 = add i64 %.414911041106.i.i, 2
  br i1 %.4143.1.i.i, label %B1510.if.i.i, label %_ZN17bnserve_surrogate6kernel7_source6_blockB3v28B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i

_ZN17bnserve_surrogate6kernel7_source6_blockB3v28B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i: ; preds = %B1510.if.i.i, %B1510.if.prol.loopexit.i.i, %_ZN17bnserve_surrogate6kernel7_source13_finish_phaseB3v41B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEd5ArrayIdLi2E1C7mutable7alignedEdd5ArrayIdLi1E1C7mutable7alignedE.exit.i.i, %_ZN17bnserve_surrogate6kernel7_source9_legendreB3v40B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dEd5ArrayIdLi2E1C7mutable7alignedE.exit.i.i
  %excinfo.3.3.i = phi ptr [ %excinfo.3.1.i, %_ZN17bnserve_surrogate6kernel7_source13_finish_phaseB3v41B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEd5ArrayIdLi2E1C7mutable7alignedEdd5ArrayIdLi1E1C7mutable7alignedE.exit.i.i ], [ %excinfo.8.0.i.i, %_ZN17bnserve_surrogate6kernel7_source9_legendreB3v40B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dEd5ArrayIdLi2E1C7mutable7alignedE.exit.i.i ], [ %excinfo.3.1.i, %B1510.if.prol.loopexit.i.i ], [ %excinfo.3.1.i, %B1510.if.i.i ]
  %cond.i = phi i1 [ true, %_ZN17bnserve_surrogate6kernel7_source13_finish_phaseB3v41B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEd5ArrayIdLi2E1C7mutable7alignedEdd5ArrayIdLi1E1C7mutable7alignedE.exit.i.i ], [ false, %_ZN17bnserve_surrogate6kernel7_source9_legendreB3v40B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dEd5ArrayIdLi2E1C7mutable7alignedE.exit.i.i ], [ true, %B1510.if.prol.loopexit.i.i ], [ true, %B1510.if.i.i ]
  call void @llvm.lifetime.end.p0(ptr nonnull %.2457.i.i), !noalias !0
  call void @llvm.lifetime.end.p0(ptr nonnull %.3101.i.i), !noalias !0
  br i1 %cond.i, label %B876.endif.endif.endif.endif.i, label %B0.endif.endif.endif.endi...endif.2.if, !prof !65

B876.endif.endif.endif.endif.i:                   ; preds = %_ZN17bnserve_surrogate6kernel7_source6_blockB3v28B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i
  br i1 %57, label %B1028.i, label %B1084.i

B1028.else.if.i:                                  ; preds = %B1028.i
  br label %B1028.else.endif.i

B1028.else.endif.i:                               ; preds = %B1028.else.if.i, %B1028.i
  %.3452.sroa.0.1.i = phi i64 [ 0, %B1028.else.if.i ], [ %.3464.i, %B1028.i ]
  %.3472.not.i = icmp slt i64 %.3464.i, %arg.n_wide
  br i1 %.3472.not.i, label %B1028.else.endif.endif.i, label %B1028.else.endif.if.i, !prof !5

B1028.else.endif.if.i:                            ; preds = %B1028.else.endif.i
  br label %B1028.else.endif.endif.i

B1028.else.endif.endif.i:                         ; preds = %B1028.else.endif.if.i, %B1028.else.endif.i
  %.3452.sroa.0.3.i = phi i64 [ %arg.n_wide, %B1028.else.endif.if.i ], [ %.3452.sroa.0.1.i, %B1028.else.endif.i ]
  %.3479.i = icmp slt i64 %.3424.i, 0
  %.3480.i = select i1 %.3479.i, i64 %arg.n_wide, i64 0
  %.3481.i = add i64 %.3480.i, %.3424.i
  %.3484.i = icmp slt i64 %.3481.i, 0
  br i1 %.3484.i, label %B1028.else.endif.endif.if.i, label %B1028.else.endif.endif.endif.i, !prof !4

B1028.else.endif.endif.if.i:                      ; preds = %B1028.else.endif.endif.i
  br label %B1028.else.endif.endif.endif.i

B1028.else.endif.endif.endif.i:                   ; preds = %B1028.else.endif.endif.if.i, %B1028.else.endif.endif.i
  %.3452.sroa.13.1.i = phi i64 [ 0, %B1028.else.endif.endif.if.i ], [ %.3481.i, %B1028.else.endif.endif.i ]
  %.3489.not.i = icmp slt i64 %.3481.i, %arg.n_wide
  br i1 %.3489.not.i, label %B1028.else.endif.endif.endif.endif.i, label %B1028.else.endif.endif.endif.if.i, !prof !5

B1028.else.endif.endif.endif.if.i:                ; preds = %B1028.else.endif.endif.endif.i
  br label %B1028.else.endif.endif.endif.endif.i

B1028.else.endif.endif.endif.endif.i:             ; preds = %B1028.else.endif.endif.endif.if.i, %B1028.else.endif.endif.endif.i
  %.3452.sroa.13.2.i = phi i64 [ %arg.n_wide, %B1028.else.endif.endif.endif.if.i ], [ %.3452.sroa.13.1.i, %B1028.else.endif.endif.endif.i ]
  %.3540.i = sub nsw i64 %.3452.sroa.13.2.i, %.3452.sroa.0.3.i
  %.138124.not.i.i = icmp slt i64 %.3540.i, 1
  br i1 %.138124.not.i.i, label %B1084.i, label %B56.if.preheader.i.i

B56.if.preheader.i.i:                             ; preds = %B1028.else.endif.endif.endif.endif.i
  %.3565.i = getelementptr { double, double }, ptr %arg.wide, i64 %.3452.sroa.0.3.i
  %scevgep.i.i = getelementptr i8, ptr %.3565.i, i64 8
  br label %B56.if.i.i

B56.if.i.i:                                       ; preds = %B56.if.i.i, %B56.if.preheader.i.i
  %lsr.iv.i.i = phi ptr [ %scevgep.i.i, %B56.if.preheader.i.i ], [ %scevgep1.i.i, %B56.if.i.i ]
  %.144123125.i.i = phi i64 [ 0, %B56.if.preheader.i.i ], [ %.151.i.i, %B56.if.i.i ]
  %.151.i.i = add nuw nsw i64 %.144123125.i.i, 1
  %249 = shl i64 %.144123125.i.i, 3
  %scevgep4.i.i = getelementptr i8, ptr %p.2.sroa.48.2.i, i64 %249
  %.206.i.i = load double, ptr %scevgep4.i.i, align 8, !noalias !88
  %.207.i.i = fmul contract double %.206.i.i, 0x3FE45F306DC9C883
  %.208.i.i = fadd contract double %.207.i.i, 0x4338000000000000
  %.209.i.i = fadd contract double %.208.i.i, 0xC338000000000000
  %.227.i.i = fmul contract double %.209.i.i, 0x3FF921FA00000000
  %.228.i.i = fsub contract double %.206.i.i, %.227.i.i
  %.246.i.i = fmul contract double %.209.i.i, 0x3EB5444200000000
  %.247.i.i = fsub contract double %.228.i.i, %.246.i.i
  %.265.i.i = fmul contract double %.209.i.i, 0x3D6A308C00000000
  %.266.i.i = fsub contract double %.247.i.i, %.265.i.i
  %.284.i.i = fmul contract double %.209.i.i, 0x3C2313198A2E0370
  %.285.i.i = fsub contract double %.266.i.i, %.284.i.i
  %.286.i.i = fmul contract double %.285.i.i, %.285.i.i
  %.287.i.i = fmul contract double %.285.i.i, %.286.i.i
  %.288.i.i = fmul contract double %.286.i.i, 0x3D6AE7F3E733B81F
  %250 = fsub contract double 0x3DE6124613A86D09, %.288.i.i
  %.290.i.i = fmul contract double %.286.i.i, %250
  %.291.i.i = fadd contract double %.290.i.i, 0xBE5AE64567F544E4
  %.292.i.i = fmul contract double %.286.i.i, %.291.i.i
  %.293.i.i = fadd contract double %.292.i.i, 0x3EC71DE3A556C734
  %.294.i.i = fmul contract double %.286.i.i, %.293.i.i
  %.295.i.i = fadd contract double %.294.i.i, 0xBF2A01A01A01A01A
  %.296.i.i = fmul contract double %.286.i.i, %.295.i.i
  %.297.i.i = fadd contract double %.296.i.i, 0x3F81111111111111
  %.298.i.i = fmul contract double %.286.i.i, %.297.i.i
  %.299.i.i = fadd contract double %.298.i.i, 0xBFC5555555555555
  %.300.i.i = fmul contract double %.287.i.i, %.299.i.i
  %.301.i.i = fadd contract double %.285.i.i, %.300.i.i
  %.302.i.i = fmul contract double %.286.i.i, 0x3D2AE7F3E733B81F
  %.303.i.i = fadd contract double %.302.i.i, 0xBDA93974A8C07C9D
  %.304.i.i = fmul contract double %.286.i.i, %.303.i.i
  %.305.i.i = fadd contract double %.304.i.i, 0x3E21EED8EFF8D898
  %.306.i.i = fmul contract double %.286.i.i, %.305.i.i
  %.307.i.i = fadd contract double %.306.i.i, 0xBE927E4FB7789F5C
  %.308.i.i = fmul contract double %.286.i.i, %.307.i.i
  %.309.i.i = fadd contract double %.308.i.i, 0x3EFA01A01A01A01A
  %.310.i.i = fmul contract double %.286.i.i, %.309.i.i
  %.311.i.i = fadd contract double %.310.i.i, 0xBF56C16C16C16C17
  %.312.i.i = fmul contract double %.286.i.i, %.311.i.i
  %.313.i.i = fadd contract double %.312.i.i, 0x3FA5555555555555
  %.314.i.i = fmul contract double %.286.i.i, %.313.i.i
  %.315.i.i = fadd contract double %.314.i.i, -5.000000e-01
  %.316.i.i = fmul contract double %.286.i.i, %.315.i.i
  %.317.i.i = fadd contract double %.316.i.i, 1.000000e+00
  %.318.i.i = bitcast double %.208.i.i to i64
  %.319.i.i = and i64 %.318.i.i, 1
  %.321.i.i = bitcast double %.301.i.i to i64
  %.322.i.i = bitcast double %.317.i.i to i64
  %.323.i.i = xor i64 %.322.i.i, %.321.i.i
  %251 = icmp eq i64 %.319.i.i, 0
  %.324.i.i = select i1 %251, i64 0, i64 %.323.i.i
  %.325.i.i = shl i64 %.318.i.i, 62
  %.326.i.i = and i64 %.325.i.i, -9223372036854775808
  %.328.i.i = add i64 %.325.i.i, 4611686018427387904
  %.329.i.i = and i64 %.328.i.i, -9223372036854775808
  %252 = xor i64 %.326.i.i, %.321.i.i
  %.331.i.i = xor i64 %252, %.324.i.i
  %.332.i.i = bitcast i64 %.331.i.i to double
  %253 = xor i64 %.329.i.i, %.322.i.i
  %.334.i.i = xor i64 %253, %.324.i.i
  %.335.i.i = bitcast i64 %.334.i.i to double
  %scevgep19.i = getelementptr i8, ptr %a.2.sroa.48.2.i, i64 %249
  %.385.i.i = load double, ptr %scevgep19.i, align 8, !noalias !88
  %.386.i.i = fmul contract double %.385.i.i, %.335.i.i
  %.417.i.i = fmul contract double %.385.i.i, %.332.i.i
  %scevgep2.i.i = getelementptr i8, ptr %lsr.iv.i.i, i64 -8
  store double %.386.i.i, ptr %scevgep2.i.i, align 8, !noalias !88
  store double %.417.i.i, ptr %lsr.iv.i.i, align 8, !noalias !88
  %scevgep1.i.i = getelementptr i8, ptr %lsr.iv.i.i, i64 16
  %exitcond.not.i.i = icmp eq i64 %.3540.i, %.151.i.i
  br i1 %exitcond.not.i.i, label %B1084.i, label %B56.if.i.i

B1118.else.if.i:                                  ; preds = %B1118.i
  br label %B1118.else.endif.i

B1118.else.endif.i:                               ; preds = %B1118.else.if.i, %B1118.i
  %.3681.sroa.0.1.i = phi i64 [ 0, %B1118.else.if.i ], [ %.3693.i, %B1118.i ]
  %.3701.not.i = icmp slt i64 %.3693.i, %arg.n_narrow
  br i1 %.3701.not.i, label %B1118.else.endif.endif.i, label %B1118.else.endif.if.i, !prof !5

B1118.else.endif.if.i:                            ; preds = %B1118.else.endif.i
  br label %B1118.else.endif.endif.i

B1118.else.endif.endif.i:                         ; preds = %B1118.else.endif.if.i, %B1118.else.endif.i
  %.3681.sroa.0.3.i = phi i64 [ %arg.n_narrow, %B1118.else.endif.if.i ], [ %.3681.sroa.0.1.i, %B1118.else.endif.i ]
  %.3708.i = icmp slt i64 %.3649.i, 0
  %.3709.i = select i1 %.3708.i, i64 %arg.n_narrow, i64 0
  %.3710.i = add i64 %.3709.i, %.3649.i
  %.3713.i = icmp slt i64 %.3710.i, 0
  br i1 %.3713.i, label %B1118.else.endif.endif.if.i, label %B1118.else.endif.endif.endif.i, !prof !4

B1118.else.endif.endif.if.i:                      ; preds = %B1118.else.endif.endif.i
  br label %B1118.else.endif.endif.endif.i

B1118.else.endif.endif.endif.i:                   ; preds = %B1118.else.endif.endif.if.i, %B1118.else.endif.endif.i
  %.3681.sroa.13.1.i = phi i64 [ 0, %B1118.else.endif.endif.if.i ], [ %.3710.i, %B1118.else.endif.endif.i ]
  %.3718.not.i = icmp slt i64 %.3710.i, %arg.n_narrow
  br i1 %.3718.not.i, label %B1118.else.endif.endif.endif.endif.i, label %B1118.else.endif.endif.endif.if.i, !prof !5

B1118.else.endif.endif.endif.if.i:                ; preds = %B1118.else.endif.endif.endif.i
  br label %B1118.else.endif.endif.endif.endif.i

B1118.else.endif.endif.endif.endif.i:             ; preds = %B1118.else.endif.endif.endif.if.i, %B1118.else.endif.endif.endif.i
  %.3681.sroa.13.2.i = phi i64 [ %arg.n_narrow, %B1118.else.endif.endif.endif.if.i ], [ %.3681.sroa.13.1.i, %B1118.else.endif.endif.endif.i ]
  %.3769.i = sub nsw i64 %.3681.sroa.13.2.i, %.3681.sroa.0.3.i
  %.138128.not.i.i = icmp slt i64 %.3769.i, 1
  br i1 %.138128.not.i.i, label %B1174.i, label %B56.if.i19.preheader.i

B56.if.i19.preheader.i:                           ; preds = %B1118.else.endif.endif.endif.endif.i
  %254 = shl i64 %.3681.sroa.0.3.i, 3
  %scevgep99.i = getelementptr i8, ptr %scevgep98.i, i64 %254
  br label %B56.if.i19.i

B56.if.i19.i:                                     ; preds = %B56.if.i19.i, %B56.if.i19.preheader.i
  %.144127129.i.i = phi i64 [ %.151.i20.i, %B56.if.i19.i ], [ 0, %B56.if.i19.preheader.i ]
  %.151.i20.i = add nuw nsw i64 %.144127129.i.i, 1
  %255 = shl i64 %.144127129.i.i, 3
  %scevgep5.i.i = getelementptr i8, ptr %p.2.sroa.48.2.i, i64 %255
  %.206.i21.i = load double, ptr %scevgep5.i.i, align 8, !noalias !91
  %.207.i22.i = fmul contract double %.206.i21.i, 0x3FE45F306DC9C883
  %.208.i23.i = fadd contract double %.207.i22.i, 0x4338000000000000
  %.209.i24.i = fadd contract double %.208.i23.i, 0xC338000000000000
  %.227.i25.i = fmul contract double %.209.i24.i, 0x3FF921FA00000000
  %.228.i26.i = fsub contract double %.206.i21.i, %.227.i25.i
  %.246.i27.i = fmul contract double %.209.i24.i, 0x3EB5444200000000
  %.247.i28.i = fsub contract double %.228.i26.i, %.246.i27.i
  %.265.i29.i = fmul contract double %.209.i24.i, 0x3D6A308C00000000
  %.266.i30.i = fsub contract double %.247.i28.i, %.265.i29.i
  %.284.i31.i = fmul contract double %.209.i24.i, 0x3C2313198A2E0370
  %.285.i32.i = fsub contract double %.266.i30.i, %.284.i31.i
  %.286.i33.i = fmul contract double %.285.i32.i, %.285.i32.i
  %.287.i34.i = fmul contract double %.285.i32.i, %.286.i33.i
  %.288.i35.i = fmul contract double %.286.i33.i, 0x3D6AE7F3E733B81F
  %256 = fsub contract double 0x3DE6124613A86D09, %.288.i35.i
  %.290.i36.i = fmul contract double %.286.i33.i, %256
  %.291.i37.i = fadd contract double %.290.i36.i, 0xBE5AE64567F544E4
  %.292.i38.i = fmul contract double %.286.i33.i, %.291.i37.i
  %.293.i39.i = fadd contract double %.292.i38.i, 0x3EC71DE3A556C734
  %.294.i40.i = fmul contract double %.286.i33.i, %.293.i39.i
  %.295.i41.i = fadd contract double %.294.i40.i, 0xBF2A01A01A01A01A
  %.296.i42.i = fmul contract double %.286.i33.i, %.295.i41.i
  %.297.i43.i = fadd contract double %.296.i42.i, 0x3F81111111111111
  %.298.i44.i = fmul contract double %.286.i33.i, %.297.i43.i
  %.299.i45.i = fadd contract double %.298.i44.i, 0xBFC5555555555555
  %.300.i46.i = fmul contract double %.287.i34.i, %.299.i45.i
  %.301.i47.i = fadd contract double %.285.i32.i, %.300.i46.i
  %.302.i48.i = fmul contract double %.286.i33.i, 0x3D2AE7F3E733B81F
  %.303.i49.i = fadd contract double %.302.i48.i, 0xBDA93974A8C07C9D
  %.304.i50.i = fmul contract double %.286.i33.i, %.303.i49.i
  %.305.i51.i = fadd contract double %.304.i50.i, 0x3E21EED8EFF8D898
  %.306.i52.i = fmul contract double %.286.i33.i, %.305.i51.i
  %.307.i53.i = fadd contract double %.306.i52.i, 0xBE927E4FB7789F5C
  %.308.i54.i = fmul contract double %.286.i33.i, %.307.i53.i
  %.309.i55.i = fadd contract double %.308.i54.i, 0x3EFA01A01A01A01A
  %.310.i56.i = fmul contract double %.286.i33.i, %.309.i55.i
  %.311.i57.i = fadd contract double %.310.i56.i, 0xBF56C16C16C16C17
  %.312.i58.i = fmul contract double %.286.i33.i, %.311.i57.i
  %.313.i59.i = fadd contract double %.312.i58.i, 0x3FA5555555555555
  %.314.i60.i = fmul contract double %.286.i33.i, %.313.i59.i
  %.315.i61.i = fadd contract double %.314.i60.i, -5.000000e-01
  %.316.i62.i = fmul contract double %.286.i33.i, %.315.i61.i
  %.317.i63.i = fadd contract double %.316.i62.i, 1.000000e+00
  %.318.i64.i = bitcast double %.208.i23.i to i64
  %.319.i65.i = and i64 %.318.i64.i, 1
  %.321.i66.i = bitcast double %.301.i47.i to i64
  %.322.i67.i = bitcast double %.317.i63.i to i64
  %.323.i68.i = xor i64 %.322.i67.i, %.321.i66.i
  %257 = icmp eq i64 %.319.i65.i, 0
  %.324.i69.i = select i1 %257, i64 0, i64 %.323.i68.i
  %.325.i70.i = shl i64 %.318.i64.i, 62
  %.326.i71.i = and i64 %.325.i70.i, -9223372036854775808
  %.328.i72.i = add i64 %.325.i70.i, 4611686018427387904
  %.329.i73.i = and i64 %.328.i72.i, -9223372036854775808
  %258 = xor i64 %.326.i71.i, %.321.i66.i
  %.331.i74.i = xor i64 %258, %.324.i69.i
  %.332.i75.i = bitcast i64 %.331.i74.i to double
  %259 = xor i64 %.329.i73.i, %.322.i67.i
  %.334.i76.i = xor i64 %259, %.324.i69.i
  %.335.i77.i = bitcast i64 %.334.i76.i to double
  %scevgep21.i = getelementptr i8, ptr %a.2.sroa.48.2.i, i64 %255
  %.385.i79.i = load double, ptr %scevgep21.i, align 8, !noalias !91
  %.386.i80.i = fmul contract double %.385.i79.i, %.335.i77.i
  %.417.i81.i = fmul contract double %.385.i79.i, %.332.i75.i
  %.464.i.i = fptrunc double %.386.i80.i to float
  %.469.i.i = fptrunc double %.417.i81.i to float
  %scevgep.i = getelementptr i8, ptr %scevgep99.i, i64 %255
  %scevgep20.i = getelementptr i8, ptr %scevgep.i, i64 -4
  store float %.464.i.i, ptr %scevgep20.i, align 4, !noalias !91
  store float %.469.i.i, ptr %scevgep.i, align 4, !noalias !91
  %exitcond.not.i82.i = icmp eq i64 %.3769.i, %.151.i20.i
  br i1 %exitcond.not.i82.i, label %B1174.i, label %B56.if.i19.i

common.ret:                                       ; preds = %B0.endif.endif.endif.endi...endif.2.endif, %B0.endif.endif.endif.endi...endif.2.if
  %common.ret.op = phi i32 [ 1, %B0.endif.endif.endif.endi...endif.2.if ], [ 0, %B0.endif.endif.endif.endi...endif.2.endif ]
  ret i32 %common.ret.op

B0.endif.endif.endif.endi...endif.2.if:           ; preds = %_ZN17bnserve_surrogate6kernel7_source6_blockB3v28B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i
  store ptr %excinfo.3.3.i, ptr %excinfo, align 8
  br label %common.ret

B0.endif.endif.endif.endi...endif.2.endif:        ; preds = %B1178.i, %B0.endif.else.endif.endif.i
  store ptr null, ptr %retptr, align 8
  br label %common.ret
}

; Function Attrs: mustprogress nocallback nofree nounwind willreturn memory(argmem: write)
declare void @llvm.memset.p0.i64(ptr writeonly captures(none), i8, i64, i1 immarg) #1

; Function Attrs: mustprogress nocallback nocreateundeforpoison nofree nosync nounwind speculatable willreturn memory(none)
declare double @llvm.exp.f64(double) #2

; Function Attrs: mustprogress nocallback nocreateundeforpoison nofree nosync nounwind speculatable willreturn memory(none)
declare i64 @llvm.smin.i64(i64, i64) #2

; Function Attrs: mustprogress nocallback nocreateundeforpoison nofree nosync nounwind speculatable willreturn memory(none)
declare i64 @llvm.smax.i64(i64, i64) #2

; Function Attrs: mustprogress nocallback nocreateundeforpoison nofree nosync nounwind speculatable willreturn memory(none)
declare double @llvm.pow.f64(double, double) #2

; Function Attrs: mustprogress nocallback nocreateundeforpoison nofree nosync nounwind speculatable willreturn memory(none)
declare double @llvm.log.f64(double) #2

; Function Attrs: nofree norecurse nosync nounwind memory(argmem: readwrite)
define internal fastcc void @inner_0(ptr noalias nonnull writeonly captures(none) %retptr, ptr readonly captures(none) %arg.log_f.4, i64 range(i64 0, -9223372036854775808) %arg.log_f.5.0, double %arg.shift, ptr readonly captures(none) %arg.knots.4, i64 range(i64 0, -9223372036854775808) %arg.knots.5.0, ptr readonly captures(none) %arg.values.4, ptr readonly captures(none) %arg.curvatures.4, ptr writeonly captures(none) %arg.out.4, i64 range(i64 0, -9223372036854775808) %arg.out.5.0) unnamed_addr #3 {
entry:
  %.192550 = icmp samesign ugt i64 %arg.knots.5.0, 1
  br i1 %.192550, label %B98.if.lr.ph, label %common.ret

B98.if.lr.ph:                                     ; preds = %entry
  %.277 = add nsw i64 %arg.knots.5.0, -2
  %scevgep = getelementptr i8, ptr %arg.log_f.4, i64 8
  %scevgep6 = getelementptr i8, ptr %arg.out.4, i64 8
  br label %B98.if

common.ret:                                       ; preds = %B98.if, %B675, %entry
  store ptr null, ptr %retptr, align 8
  ret void

B120:                                             ; preds = %B98.if
  %.279 = icmp slt i64 %.198538553, %.277
  br i1 %.279, label %B138, label %B254

B138:                                             ; preds = %B120
  %.295 = icmp slt i64 %start.2.0555, 0
  %.296 = select i1 %.295, i64 %arg.log_f.5.0, i64 0
  %0 = getelementptr double, ptr %arg.log_f.4, i64 %start.2.0555
  %.310 = getelementptr double, ptr %0, i64 %.296
  %.311 = load double, ptr %.310, align 8
  %1 = getelementptr double, ptr %arg.knots.4, i64 %.198538553
  %2 = getelementptr i8, ptr %1, i64 8
  %.343 = load double, ptr %2, align 8
  %.345 = fsub contract double %.343, %arg.shift
  %.346 = fcmp contract ogt double %.311, %.345
  br i1 %.346, label %B675, label %B188

B188:                                             ; preds = %B138
  %.44.i = icmp sge i64 %start.2.0555, %arg.log_f.5.0
  %.98.i = fcmp contract ugt double %.311, %.345
  %or.cond = or i1 %.44.i, %.98.i
  br i1 %or.cond, label %B118.i, label %B52.i

B52.i:                                            ; preds = %B188, %B94.i
  %step.2.1.i = phi i64 [ %.123.i, %B94.i ], [ 1, %B188 ]
  %high.4.1.i = phi i64 [ %.113.i, %B94.i ], [ %start.2.0555, %B188 ]
  %.113.i = add nsw i64 %high.4.1.i, %step.2.1.i
  %.131.i = icmp slt i64 %.113.i, %arg.log_f.5.0
  br i1 %.131.i, label %B94.i, label %B118.loopexit.i

B94.i:                                            ; preds = %B52.i
  %.123.i = shl nsw i64 %step.2.1.i, 1
  %.163.i = icmp slt i64 %.113.i, 0
  %.164.i = select i1 %.163.i, i64 %arg.log_f.5.0, i64 0
  %3 = getelementptr double, ptr %arg.log_f.4, i64 %.113.i
  %.178.i = getelementptr double, ptr %3, i64 %.164.i
  %.179.i = load double, ptr %.178.i, align 8, !noalias !94
  %.183.i = fcmp contract ugt double %.179.i, %.345
  br i1 %.183.i, label %B118.loopexit.i, label %B52.i

B118.loopexit.i:                                  ; preds = %B94.i, %B52.i
  %.104.le.i = add nsw i64 %high.4.1.i, 1
  br label %B118.i

B118.i:                                           ; preds = %B118.loopexit.i, %B188
  %low.3.0.i = phi i64 [ %.104.le.i, %B118.loopexit.i ], [ %start.2.0555, %B188 ]
  %high.5.0.i = phi i64 [ %.113.i, %B118.loopexit.i ], [ %start.2.0555, %B188 ]
  %spec.select.i = tail call i64 @llvm.smin.i64(i64 %high.5.0.i, i64 %arg.log_f.5.0)
  %.238.i = icmp slt i64 %low.3.0.i, %spec.select.i
  br i1 %.238.i, label %B146.i, label %B254

B146.i:                                           ; preds = %B118.i, %B146.i
  %low.4.0.i = phi i64 [ %low.5.1.i, %B146.i ], [ %low.3.0.i, %B118.i ]
  %high.7.0.i = phi i64 [ %high.8.1.i, %B146.i ], [ %spec.select.i, %B118.i ]
  %.251.i = add nsw i64 %high.7.0.i, %low.4.0.i
  %.259.1.i = ashr i64 %.251.i, 1
  %.309.i = icmp slt i64 %.259.1.i, 0
  %.310.i = select i1 %.309.i, i64 %arg.log_f.5.0, i64 0
  %4 = getelementptr double, ptr %arg.log_f.4, i64 %.259.1.i
  %.324.i = getelementptr double, ptr %4, i64 %.310.i
  %.325.i = load double, ptr %.324.i, align 8, !noalias !94
  %.327.i = fcmp contract ole double %.325.i, %.345
  %.338.i = add nsw i64 %.259.1.i, 1
  %high.8.1.i = select i1 %.327.i, i64 %high.7.0.i, i64 %.259.1.i
  %low.5.1.i = select i1 %.327.i, i64 %.338.i, i64 %low.4.0.i
  %.369.i = icmp slt i64 %low.5.1.i, %high.8.1.i
  br i1 %.369.i, label %B146.i, label %B254

B254:                                             ; preds = %B146.i, %B118.i, %B120
  %end.2.2 = phi i64 [ %arg.log_f.5.0, %B120 ], [ %low.3.0.i, %B118.i ], [ %low.5.1.i, %B146.i ]
  %5 = getelementptr double, ptr %arg.knots.4, i64 %.205
  %.460 = load double, ptr %5, align 8
  %6 = getelementptr double, ptr %arg.knots.4, i64 %.198538553
  %.491 = load double, ptr %6, align 8
  %.492 = fsub contract double %.460, %.491
  %7 = getelementptr double, ptr %arg.values.4, i64 %.198538553
  %.523 = load double, ptr %7, align 8
  %8 = getelementptr double, ptr %arg.values.4, i64 %.205
  %.558 = load double, ptr %8, align 8
  %.560 = fsub contract double %.558, %.523
  %.564 = fdiv contract double %.560, %.492
  %9 = getelementptr double, ptr %arg.curvatures.4, i64 %.198538553
  %.595 = load double, ptr %9, align 8
  %.596 = fmul contract double %.595, 2.000000e+00
  %10 = getelementptr double, ptr %arg.curvatures.4, i64 %.205
  %.628 = load double, ptr %10, align 8
  %.629 = fadd contract double %.596, %.628
  %.630 = fmul contract double %.492, %.629
  %.634 = fdiv contract double %.630, 6.000000e+00
  %.635 = fsub contract double %.564, %.634
  %.670 = fmul contract double %.595, 5.000000e-01
  %.737 = fsub contract double %.628, %.595
  %.738 = fmul contract double %.492, 6.000000e+00
  %.742 = fdiv contract double %.737, %.738
  %.780 = fsub contract double %arg.shift, %.491
  %.822 = icmp slt i64 %start.2.0555, 0
  %.823 = select i1 %.822, i64 %arg.log_f.5.0, i64 0
  %.824 = add i64 %.823, %start.2.0555
  %.827 = icmp slt i64 %.824, 0
  br i1 %.827, label %B254.endif.endif.endif.else.if, label %B254.endif.endif.endif.else.endif, !prof !4

B675.loopexit.unr-lcssa:                          ; preds = %B592.if
  %11 = and i64 %.1081, 1
  %lcmp.mod.not = icmp eq i64 %11, 0
  br i1 %lcmp.mod.not, label %B675, label %B592.if.epil.preheader

B592.if.epil.preheader:                           ; preds = %B592.if.preheader, %B675.loopexit.unr-lcssa
  %.1240531533.epil.init = phi i64 [ 0, %B592.if.preheader ], [ %.1247.1, %B675.loopexit.unr-lcssa ]
  %12 = getelementptr double, ptr %.925, i64 %.1240531533.epil.init
  %.1301.epil = load double, ptr %12, align 8
  %.1303.epil = fadd contract double %.780, %.1301.epil
  %.1305.epil = fmul contract double %.742, %.1303.epil
  %.1307.epil = fadd contract double %.670, %.1305.epil
  %.1308.epil = fmul contract double %.1303.epil, %.1307.epil
  %.1310.epil = fadd contract double %.635, %.1308.epil
  %.1311.epil = fmul contract double %.1303.epil, %.1310.epil
  %.1313.epil = fadd contract double %.523, %.1311.epil
  %13 = getelementptr double, ptr %.1106, i64 %.1240531533.epil.init
  store double %.1313.epil, ptr %13, align 8
  br label %B675

B675:                                             ; preds = %B254.endif.endif.endif.en...endif, %B592.if.epil.preheader, %B675.loopexit.unr-lcssa, %B138
  %start.3.1 = phi i64 [ %start.2.0555, %B138 ], [ %end.2.2, %B254.endif.endif.endif.en...endif ], [ %end.2.2, %B675.loopexit.unr-lcssa ], [ %end.2.2, %B592.if.epil.preheader ]
  %exitcond564.not = icmp eq i64 %.198538553, %.277
  br i1 %exitcond564.not, label %common.ret, label %B98.if

B98.if:                                           ; preds = %B675, %B98.if.lr.ph
  %start.2.0555 = phi i64 [ 0, %B98.if.lr.ph ], [ %start.3.1, %B675 ]
  %.198538553 = phi i64 [ 0, %B98.if.lr.ph ], [ %.205, %B675 ]
  %.205 = add nuw nsw i64 %.198538553, 1
  %.235 = icmp eq i64 %start.2.0555, %arg.log_f.5.0
  br i1 %.235, label %common.ret, label %B120

B254.endif.endif.endif.else.if:                   ; preds = %B254
  br label %B254.endif.endif.endif.else.endif

B254.endif.endif.endif.else.endif:                ; preds = %B254.endif.endif.endif.else.if, %B254
  %.812.sroa.0.1 = phi i64 [ 0, %B254.endif.endif.endif.else.if ], [ %.824, %B254 ]
  %.832.not = icmp slt i64 %.824, %arg.log_f.5.0
  br i1 %.832.not, label %B254.endif.endif.endif.else.endif.endif.endif.endif, label %B254.endif.endif.endif.else.endif.if, !prof !5

B254.endif.endif.endif.else.endif.if:             ; preds = %B254.endif.endif.endif.else.endif
  br label %B254.endif.endif.endif.else.endif.endif.endif.endif

B254.endif.endif.endif.else.endif.endif.endif.endif: ; preds = %B254.endif.endif.endif.else.endif.if, %B254.endif.endif.endif.else.endif
  %.812.sroa.0.3 = phi i64 [ %arg.log_f.5.0, %B254.endif.endif.endif.else.endif.if ], [ %.812.sroa.0.1, %B254.endif.endif.endif.else.endif ]
  %.925 = getelementptr double, ptr %arg.log_f.4, i64 %.812.sroa.0.3
  %.1004 = select i1 %.822, i64 %arg.out.5.0, i64 0
  %.1005 = add i64 %.1004, %start.2.0555
  %.1008 = icmp slt i64 %.1005, 0
  br i1 %.1008, label %B254.endif.endif.endif.endif.else.if, label %B254.endif.endif.endif.endif.else.endif, !prof !4

B254.endif.endif.endif.endif.else.if:             ; preds = %B254.endif.endif.endif.else.endif.endif.endif.endif
  br label %B254.endif.endif.endif.endif.else.endif

B254.endif.endif.endif.endif.else.endif:          ; preds = %B254.endif.endif.endif.endif.else.if, %B254.endif.endif.endif.else.endif.endif.endif.endif
  %.993.sroa.0.1 = phi i64 [ 0, %B254.endif.endif.endif.endif.else.if ], [ %.1005, %B254.endif.endif.endif.else.endif.endif.endif.endif ]
  %.1013.not = icmp slt i64 %.1005, %arg.out.5.0
  br i1 %.1013.not, label %B254.endif.endif.endif.endif.else.endif.endif, label %B254.endif.endif.endif.endif.else.endif.if, !prof !5

B254.endif.endif.endif.endif.else.endif.if:       ; preds = %B254.endif.endif.endif.endif.else.endif
  br label %B254.endif.endif.endif.endif.else.endif.endif

B254.endif.endif.endif.endif.else.endif.endif:    ; preds = %B254.endif.endif.endif.endif.else.endif.if, %B254.endif.endif.endif.endif.else.endif
  %.993.sroa.0.3 = phi i64 [ %arg.out.5.0, %B254.endif.endif.endif.endif.else.endif.if ], [ %.993.sroa.0.1, %B254.endif.endif.endif.endif.else.endif ]
  %.1020 = icmp slt i64 %end.2.2, 0
  %.1021 = select i1 %.1020, i64 %arg.out.5.0, i64 0
  %.1022 = add i64 %.1021, %end.2.2
  %.1025 = icmp slt i64 %.1022, 0
  br i1 %.1025, label %B254.endif.endif.endif.endif.else.endif.endif.if, label %B254.endif.endif.endif.endif.else.endif.endif.endif, !prof !4

B254.endif.endif.endif.endif.else.endif.endif.if: ; preds = %B254.endif.endif.endif.endif.else.endif.endif
  br label %B254.endif.endif.endif.endif.else.endif.endif.endif

B254.endif.endif.endif.endif.else.endif.endif.endif: ; preds = %B254.endif.endif.endif.endif.else.endif.endif.if, %B254.endif.endif.endif.endif.else.endif.endif
  %.993.sroa.13.1 = phi i64 [ 0, %B254.endif.endif.endif.endif.else.endif.endif.if ], [ %.1022, %B254.endif.endif.endif.endif.else.endif.endif ]
  %.1030.not = icmp slt i64 %.1022, %arg.out.5.0
  br i1 %.1030.not, label %B254.endif.endif.endif.en...endif, label %B254.endif.endif.endif.en...if, !prof !5

B254.endif.endif.endif.en...if:                   ; preds = %B254.endif.endif.endif.endif.else.endif.endif.endif
  br label %B254.endif.endif.endif.en...endif

B254.endif.endif.endif.en...endif:                ; preds = %B254.endif.endif.endif.en...if, %B254.endif.endif.endif.endif.else.endif.endif.endif
  %.993.sroa.13.2 = phi i64 [ %arg.out.5.0, %B254.endif.endif.endif.en...if ], [ %.993.sroa.13.1, %B254.endif.endif.endif.endif.else.endif.endif.endif ]
  %.1081 = sub nsw i64 %.993.sroa.13.2, %.993.sroa.0.3
  %.1106 = getelementptr double, ptr %arg.out.4, i64 %.993.sroa.0.3
  %.1234532.not = icmp slt i64 %.1081, 1
  br i1 %.1234532.not, label %B675, label %B592.if.preheader

B592.if.preheader:                                ; preds = %B254.endif.endif.endif.en...endif
  %.neg = add nuw i64 %.993.sroa.0.3, 1
  %14 = icmp eq i64 %.993.sroa.13.2, %.neg
  br i1 %14, label %B592.if.epil.preheader, label %B592.if.preheader.new

B592.if.preheader.new:                            ; preds = %B592.if.preheader
  %unroll_iter = and i64 %.1081, 9223372036854775806
  %15 = shl i64 %.812.sroa.0.3, 3
  %scevgep2 = getelementptr i8, ptr %scevgep, i64 %15
  %16 = shl i64 %.993.sroa.0.3, 3
  %scevgep7 = getelementptr i8, ptr %scevgep6, i64 %16
  br label %B592.if

B592.if:                                          ; preds = %B592.if, %B592.if.preheader.new
  %.1240531533 = phi i64 [ 0, %B592.if.preheader.new ], [ %.1247.1, %B592.if ]
  %17 = shl i64 %.1240531533, 3
  %scevgep4 = getelementptr i8, ptr %scevgep2, i64 %17
  %scevgep5 = getelementptr i8, ptr %scevgep4, i64 -8
  %.1301 = load double, ptr %scevgep5, align 8
  %.1303 = fadd contract double %.780, %.1301
  %.1305 = fmul contract double %.742, %.1303
  %.1307 = fadd contract double %.670, %.1305
  %.1308 = fmul contract double %.1303, %.1307
  %.1310 = fadd contract double %.635, %.1308
  %.1311 = fmul contract double %.1303, %.1310
  %.1313 = fadd contract double %.523, %.1311
  %scevgep1 = getelementptr i8, ptr %scevgep7, i64 %17
  %scevgep3 = getelementptr i8, ptr %scevgep1, i64 -8
  store double %.1313, ptr %scevgep3, align 8
  %.1247.1 = add nuw i64 %.1240531533, 2
  %.1301.1 = load double, ptr %scevgep4, align 8
  %.1303.1 = fadd contract double %.780, %.1301.1
  %.1305.1 = fmul contract double %.742, %.1303.1
  %.1307.1 = fadd contract double %.670, %.1305.1
  %.1308.1 = fmul contract double %.1303.1, %.1307.1
  %.1310.1 = fadd contract double %.635, %.1308.1
  %.1311.1 = fmul contract double %.1303.1, %.1310.1
  %.1313.1 = fadd contract double %.523, %.1311.1
  store double %.1313.1, ptr %scevgep1, align 8
  %niter.ncmp.1 = icmp eq i64 %unroll_iter, %.1247.1
  br i1 %niter.ncmp.1, label %B675.loopexit.unr-lcssa, label %B592.if
}

; Function Attrs: mustprogress nocallback nofree nosync nounwind willreturn memory(none)
declare double @sqrt(double) local_unnamed_addr #4

; Function Attrs: mustprogress nocallback nofree nosync nounwind willreturn memory(none)
declare double @tanh(double) local_unnamed_addr #4

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

!0 = !{!1, !3}
!1 = distinct !{!1, !2, !"_ZN17bnserve_surrogate6kernel7_source8evaluateB2v7B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi3EE5TupleI5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayI10complex128Li1E1C7mutable7alignedE5ArrayI9complex64Li1E1C7mutable7alignedE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi2EE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!2 = distinct !{!2, !"_ZN17bnserve_surrogate6kernel7_source8evaluateB2v7B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi3EE5TupleI5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayI10complex128Li1E1C7mutable7alignedE5ArrayI9complex64Li1E1C7mutable7alignedE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi2EE5ArrayIdLi1E1C7mutable7alignedE"}
!3 = distinct !{!3, !2, !"_ZN17bnserve_surrogate6kernel7_source8evaluateB2v7B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi3EE5TupleI5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayI10complex128Li1E1C7mutable7alignedE5ArrayI9complex64Li1E1C7mutable7alignedE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi2EE5ArrayIdLi1E1C7mutable7alignedE: %excinfo"}
!4 = !{!"branch_weights", i32 1, i32 99}
!5 = !{!"branch_weights", i32 99, i32 1}
!6 = !{!7, !1, !3}
!7 = distinct !{!7, !8, !"_ZN17bnserve_surrogate6kernel7_source8_prepareB2v8B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!8 = distinct !{!8, !"_ZN17bnserve_surrogate6kernel7_source8_prepareB2v8B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!9 = !{!10, !7, !1, !3}
!10 = distinct !{!10, !11, !"_ZN17bnserve_surrogate6kernel11_regression7regressB2v9B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dEddddd5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!11 = distinct !{!11, !"_ZN17bnserve_surrogate6kernel11_regression7regressB2v9B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dEddddd5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!12 = !{!13, !10, !7, !1, !3}
!13 = distinct !{!13, !14, !"_ZN17bnserve_surrogate12_coordinates18transform_physicalB3v10B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDAxYh_2bqJnA4AOzNAE_3dEddddd5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!14 = distinct !{!14, !"_ZN17bnserve_surrogate12_coordinates18transform_physicalB3v10B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDAxYh_2bqJnA4AOzNAE_3dEddddd5ArrayIdLi1E1C7mutable7alignedE"}
!15 = !{!16, !10, !7, !1, !3}
!16 = distinct !{!16, !17, !"_ZN17bnserve_surrogate6kernel11_regression15_add_polynomialB3v11B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedExx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!17 = distinct !{!17, !"_ZN17bnserve_surrogate6kernel11_regression15_add_polynomialB3v11B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedExx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!18 = !{!19, !10, !7, !1, !3}
!19 = distinct !{!19, !20, !"_ZN17bnserve_surrogate6kernel11_regression12_add_networkB3v12B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!20 = distinct !{!20, !"_ZN17bnserve_surrogate6kernel11_regression12_add_networkB3v12B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!21 = distinct !{!21, !22}
!22 = !{!"llvm.loop.unroll.disable"}
!23 = distinct !{!23, !22}
!24 = !{!25, !7, !1, !3}
!25 = distinct !{!25, !26, !"_ZN17bnserve_surrogate6kernel7_source11_synthesizeB3v15B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!26 = distinct !{!26, !"_ZN17bnserve_surrogate6kernel7_source11_synthesizeB3v15B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!27 = distinct !{!27, !22}
!28 = !{!29, !7, !1, !3}
!29 = distinct !{!29, !30, !"_ZN17bnserve_surrogate8baseline6_phase18phase_coefficientsB3v16B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDAxYh_2bqJnA4AOzNAE_3dEddddd5ArrayIdLi2E1C7mutable7alignedE: %retptr"}
!30 = distinct !{!30, !"_ZN17bnserve_surrogate8baseline6_phase18phase_coefficientsB3v16B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDAxYh_2bqJnA4AOzNAE_3dEddddd5ArrayIdLi2E1C7mutable7alignedE"}
!31 = !{!32, !29, !7, !1, !3}
!32 = distinct !{!32, !33, !"_ZN17bnserve_surrogate8baseline11_point_mass20add_point_mass_phaseB3v17B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDAxYh_2bqJnA4AOzNAE_3dEd5ArrayIdLi2E1C7mutable7alignedE: %retptr"}
!33 = distinct !{!33, !"_ZN17bnserve_surrogate8baseline11_point_mass20add_point_mass_phaseB3v17B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDAxYh_2bqJnA4AOzNAE_3dEd5ArrayIdLi2E1C7mutable7alignedE"}
!34 = !{!35, !29, !7, !1, !3}
!35 = distinct !{!35, !36, !"_ZN17bnserve_surrogate8baseline6_spins20add_spin_orbit_phaseB3v18B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDAxYh_2bqJnA4AOzNAE_3dEdd5ArrayIdLi2E1C7mutable7alignedE: %retptr"}
!36 = distinct !{!36, !"_ZN17bnserve_surrogate8baseline6_spins20add_spin_orbit_phaseB3v18B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDAxYh_2bqJnA4AOzNAE_3dEdd5ArrayIdLi2E1C7mutable7alignedE"}
!37 = !{!38, !29, !7, !1, !3}
!38 = distinct !{!38, !39, !"_ZN17bnserve_surrogate8baseline6_spins20add_spin_orbit_phaseB3v18B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDAxYh_2bqJnA4AOzNAE_3dEdd5ArrayIdLi2E1C7mutable7alignedE: %retptr"}
!39 = distinct !{!39, !"_ZN17bnserve_surrogate8baseline6_spins20add_spin_orbit_phaseB3v18B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDAxYh_2bqJnA4AOzNAE_3dEdd5ArrayIdLi2E1C7mutable7alignedE"}
!40 = !{!41, !29, !7, !1, !3}
!41 = distinct !{!41, !42, !"_ZN17bnserve_surrogate8baseline6_spins19add_self_spin_phaseB3v20B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDAxYh_2bqJnA4AOzNAE_3dEddd5ArrayIdLi2E1C7mutable7alignedE: %retptr"}
!42 = distinct !{!42, !"_ZN17bnserve_surrogate8baseline6_spins19add_self_spin_phaseB3v20B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDAxYh_2bqJnA4AOzNAE_3dEddd5ArrayIdLi2E1C7mutable7alignedE"}
!43 = !{!44, !29, !7, !1, !3}
!44 = distinct !{!44, !45, !"_ZN17bnserve_surrogate8baseline6_spins19add_self_spin_phaseB3v20B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDAxYh_2bqJnA4AOzNAE_3dEddd5ArrayIdLi2E1C7mutable7alignedE: %retptr"}
!45 = distinct !{!45, !"_ZN17bnserve_surrogate8baseline6_spins19add_self_spin_phaseB3v20B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDAxYh_2bqJnA4AOzNAE_3dEddd5ArrayIdLi2E1C7mutable7alignedE"}
!46 = !{!47, !29, !7, !1, !3}
!47 = distinct !{!47, !48, !"_ZN17bnserve_surrogate8baseline6_spins19add_spin_spin_phaseB3v22B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDAxYh_2bqJnA4AOzNAE_3dEddd5ArrayIdLi2E1C7mutable7alignedE: %retptr"}
!48 = distinct !{!48, !"_ZN17bnserve_surrogate8baseline6_spins19add_spin_spin_phaseB3v22B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDAxYh_2bqJnA4AOzNAE_3dEddd5ArrayIdLi2E1C7mutable7alignedE"}
!49 = !{!50, !29, !7, !1, !3}
!50 = distinct !{!50, !51, !"_ZN17bnserve_surrogate8baseline6_tides15add_tidal_phaseB3v23B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDAxYh_2bqJnA4AOzNAE_3dEdd5ArrayIdLi2E1C7mutable7alignedE: %retptr"}
!51 = distinct !{!51, !"_ZN17bnserve_surrogate8baseline6_tides15add_tidal_phaseB3v23B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDAxYh_2bqJnA4AOzNAE_3dEdd5ArrayIdLi2E1C7mutable7alignedE"}
!52 = !{!53, !29, !7, !1, !3}
!53 = distinct !{!53, !54, !"_ZN17bnserve_surrogate8baseline6_tides15add_tidal_phaseB3v23B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDAxYh_2bqJnA4AOzNAE_3dEdd5ArrayIdLi2E1C7mutable7alignedE: %retptr"}
!54 = distinct !{!54, !"_ZN17bnserve_surrogate8baseline6_tides15add_tidal_phaseB3v23B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDAxYh_2bqJnA4AOzNAE_3dEdd5ArrayIdLi2E1C7mutable7alignedE"}
!55 = !{!56, !7, !1, !3}
!56 = distinct !{!56, !57, !"_ZN17bnserve_surrogate8baseline10_amplitude22amplitude_coefficientsB3v24B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDAxYh_2bqJnA4AOzNAE_3dEddd5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!57 = distinct !{!57, !"_ZN17bnserve_surrogate8baseline10_amplitude22amplitude_coefficientsB3v24B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDAxYh_2bqJnA4AOzNAE_3dEddd5ArrayIdLi1E1C7mutable7alignedE"}
!58 = !{!59, !61, !1, !3}
!59 = distinct !{!59, !60, !"_ZN17bnserve_surrogate6kernel7_source6_blockB3v28B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!60 = distinct !{!60, !"_ZN17bnserve_surrogate6kernel7_source6_blockB3v28B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!61 = distinct !{!61, !60, !"_ZN17bnserve_surrogate6kernel7_source6_blockB3v28B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %excinfo"}
!62 = !{!63, !59, !61, !1, !3}
!63 = distinct !{!63, !64, !"_ZN17bnserve_surrogate6kernel7_source11first_aboveB3v29B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE23Literal_5bint_5d_280_29xd: %retptr"}
!64 = distinct !{!64, !"_ZN17bnserve_surrogate6kernel7_source11first_aboveB3v29B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE23Literal_5bint_5d_280_29xd"}
!65 = !{!"branch_weights", i32 49, i32 1}
!66 = !{!67, !69, !59, !61, !1, !3}
!67 = distinct !{!67, !68, !"_ZN17bnserve_surrogate6kernel7_source9_legendreB3v40B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dEd5ArrayIdLi2E1C7mutable7alignedE: %retptr"}
!68 = distinct !{!68, !"_ZN17bnserve_surrogate6kernel7_source9_legendreB3v40B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dEd5ArrayIdLi2E1C7mutable7alignedE"}
!69 = distinct !{!69, !68, !"_ZN17bnserve_surrogate6kernel7_source9_legendreB3v40B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dEd5ArrayIdLi2E1C7mutable7alignedE: %excinfo"}
!70 = !{!71, !59, !61, !1, !3}
!71 = distinct !{!71, !72, !"_ZN17bnserve_surrogate6kernel7_source11first_aboveB3v30B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedExxd: %retptr"}
!72 = distinct !{!72, !"_ZN17bnserve_surrogate6kernel7_source11first_aboveB3v30B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedExxd"}
!73 = !{!74, !59, !61, !1, !3}
!74 = distinct !{!74, !75, !"_ZN17bnserve_surrogate6kernel7_source13_extend_belowB3v31B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedEddddd5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!75 = distinct !{!75, !"_ZN17bnserve_surrogate6kernel7_source13_extend_belowB3v31B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedEddddd5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!76 = !{!77, !79, !59, !61, !1, !3}
!77 = distinct !{!77, !78, !"_ZN17bnserve_surrogate6kernel7_source11first_aboveB3v29B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE23Literal_5bint_5d_280_29xd: %retptr"}
!78 = distinct !{!78, !"_ZN17bnserve_surrogate6kernel7_source11first_aboveB3v29B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE23Literal_5bint_5d_280_29xd"}
!79 = distinct !{!79, !80, !"_ZN17bnserve_surrogate6kernel7_source16_scale_amplitudeB3v36B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEd5ArrayIdLi1E1C7mutable7alignedEd5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!80 = distinct !{!80, !"_ZN17bnserve_surrogate6kernel7_source16_scale_amplitudeB3v36B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEd5ArrayIdLi1E1C7mutable7alignedEd5ArrayIdLi1E1C7mutable7alignedE"}
!81 = !{!82, !79, !59, !61, !1, !3}
!82 = distinct !{!82, !83, !"_ZN17bnserve_surrogate6kernel7_source11first_aboveB3v30B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedExxd: %retptr"}
!83 = distinct !{!83, !"_ZN17bnserve_surrogate6kernel7_source11first_aboveB3v30B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedExxd"}
!84 = !{!79, !59, !61, !1, !3}
!85 = !{!86, !59, !61, !1, !3}
!86 = distinct !{!86, !87, !"_ZN17bnserve_surrogate6kernel7_source13_finish_phaseB3v41B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEd5ArrayIdLi2E1C7mutable7alignedEdd5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!87 = distinct !{!87, !"_ZN17bnserve_surrogate6kernel7_source13_finish_phaseB3v41B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEd5ArrayIdLi2E1C7mutable7alignedEdd5ArrayIdLi1E1C7mutable7alignedE"}
!88 = !{!89, !1, !3}
!89 = distinct !{!89, !90, !"_ZN17bnserve_surrogate6kernel7_source13_to_cartesianB3v42B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayI10complex128Li1E1C7mutable7alignedE: %retptr"}
!90 = distinct !{!90, !"_ZN17bnserve_surrogate6kernel7_source13_to_cartesianB3v42B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayI10complex128Li1E1C7mutable7alignedE"}
!91 = !{!92, !1, !3}
!92 = distinct !{!92, !93, !"_ZN17bnserve_surrogate6kernel7_source13_to_cartesianB3v44B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayI9complex64Li1E1C7mutable7alignedE: %retptr"}
!93 = distinct !{!93, !"_ZN17bnserve_surrogate6kernel7_source13_to_cartesianB3v44B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayI9complex64Li1E1C7mutable7alignedE"}
!94 = !{!95}
!95 = distinct !{!95, !96, !"_ZN17bnserve_surrogate6kernel7_source11first_aboveB3v30B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedExxd: %retptr"}
!96 = distinct !{!96, !"_ZN17bnserve_surrogate6kernel7_source11first_aboveB3v30B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedExxd"}
