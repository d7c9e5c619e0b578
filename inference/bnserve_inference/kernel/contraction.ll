; sources: 96705932f3cbd6dcd4dc90777a61b11b0056491cbee99706acc200f17893272f
; built by: numba 0.68.1, llvmlite 0.50.0, Python 3.11, x86_64
; ModuleID = '<string>'
source_filename = "<string>"


; Function Attrs: nofree norecurse nosync nounwind memory(argmem: readwrite)
define noundef i32 @bnserve_contract(ptr noalias writeonly captures(none) %retptr, ptr noalias readnone captures(none) %excinfo, ptr readonly captures(none) %arg.h, i64 %arg.n_h, i64 %arg.points, ptr readonly captures(none) %arg.sky, i64 %arg.n_sky, ptr readonly captures(none) %arg.sidereal, i64 %arg.n_sidereal, ptr readonly captures(none) %arg.responses, i64 %arg.n_responses, ptr readonly captures(none) %arg.locations, i64 %arg.n_locations, ptr readonly captures(none) %arg.f, i64 %arg.n_f, ptr readonly captures(none) %arg.linear_at, i64 %arg.n_linear, ptr readonly captures(none) %arg.quadratic_at, i64 %arg.n_quadratic, ptr readonly captures(none) %arg.linear, i64 %arg.n_table, ptr readonly captures(none) %arg.quadratic, i64 %arg.n_norm, ptr readonly captures(none) %arg.knots, i64 %arg.n_knots, ptr readonly captures(none) %arg.amplitude, i64 %arg.n_amplitude, ptr readonly captures(none) %arg.phase, i64 %arg.n_phase, ptr readonly captures(none) %arg.linear_spline, i64 %arg.n_ls, ptr readonly captures(none) %arg.quadratic_spline, i64 %arg.n_qs, i64 %arg.times, ptr readonly captures(none) %arg.step, i64 %arg.n_step, ptr captures(none) %arg.products, i64 %arg.n_products, ptr writeonly captures(none) %arg.norms, i64 %arg.n_norms, ptr captures(none) %arg.spectrum, i64 %arg.n_spectrum, ptr %arg.scratch, i64 %arg.n_scratch) local_unnamed_addr #0 {
entry:
  %.684 = load double, ptr %arg.step, align 8
  %.770.i = sdiv i64 %arg.n_responses, 9
  %.771.i = srem i64 %arg.n_responses, 9
  %.771.lobit.i = ashr i64 %.771.i, 63
  %.759.1.i = add nsw i64 %.771.lobit.i, %.770.i
  %.820.i = icmp eq i64 %.759.1.i, 0
  br i1 %.820.i, label %B0.endif.endif.i, label %B0.endif.else.i, !prof !0

B284.i:                                           ; preds = %B0.endif.endif.endif.i
  %.983.i = sdiv i64 %arg.n_ls, %arg.n_f
  %.984.i = srem i64 %arg.n_ls, %arg.n_f
  %.985.lobit.i = ashr i64 %.984.i, 63
  %.972.1.i = add i64 %.985.lobit.i, %.983.i
  br label %B318.i

B318.i:                                           ; preds = %B0.endif.endif.endif.i, %B284.i
  %"$phi318.0.2.0.i" = phi i64 [ 0, %B0.endif.endif.endif.i ], [ %.972.1.i, %B284.i ]
  %.1019.i = mul nsw i64 %.759.1.i, 3
  %.1066.i = icmp slt i64 %arg.n_scratch, 1
  br i1 %.1066.i, label %B318.else.endif.if.i, label %B318.else.endif.endif.i, !prof !0

B890.i:                                           ; preds = %B890.preheader.i, %B3894.i
  %.2755.sroa.0.091.i = phi i64 [ %.2755.sroa.0.0.i, %B3894.i ], [ 0, %B890.preheader.i ]
  %.2709.190.in.i = phi i64 [ %59, %B3894.i ], [ %arg.n_norms, %B890.preheader.i ]
  %.2706.189.i = phi i64 [ %.2706.1.i, %B3894.i ], [ 1, %B890.preheader.i ]
  %.2807.i = mul nsw i64 %.2755.sroa.0.091.i, 7
  %.2809.i = add nsw i64 %.2755.sroa.0.091.i, 1
  %.2847.i = icmp slt i64 %.2755.sroa.0.091.i, 0
  %.2848.i = select i1 %.2847.i, i64 %arg.n_sky, i64 0
  %.2849.i = add i64 %.2848.i, %.2807.i
  %.2852.i = icmp slt i64 %.2849.i, 0
  br i1 %.2852.i, label %B890.else.if.i, label %B890.else.endif.i, !prof !0

B1090.i:                                          ; preds = %B1074.if.preheader.i, %B890.endif.endif.else.endif.endif.endif.endif.i
  %.3371.i = mul nsw i64 %.2755.sroa.0.091.i, %.3369.i
  %.3376.i = mul nsw i64 %.2809.i, %.3369.i
  %.3413.i = icmp slt i64 %.3371.i, 0
  %.3414.i = select i1 %.3413.i, i64 %arg.n_h, i64 0
  %.3415.i = add i64 %.3414.i, %.3371.i
  %.3418.i = icmp slt i64 %.3415.i, 0
  br i1 %.3418.i, label %B1090.else.if.i, label %B1090.else.endif.i, !prof !0

B1184.loopexit.i:                                 ; preds = %B3020.i, %B1468.i
  %.3635.i = icmp sgt i64 %.3634339767.i, 0
  %.3648.i = add i64 %.3641340966.i, 512
  %.36413409.i = select i1 %.3635.i, i64 %.3648.i, i64 %.3641340966.i
  %.3644.i = sext i1 %.3635.i to i64
  %.36343397.i = add nsw i64 %.3634339767.i, %.3644.i
  %.3625.sroa.0.0.i = select i1 %.3635.i, i64 %.3641340966.i, i64 0
  br i1 %.3635.i, label %B1188.i, label %B3028.i

B1188.i:                                          ; preds = %B1090.else.endif.endif.endif.endif.i, %B1184.loopexit.i
  %.3625.sroa.0.068.i = phi i64 [ %.3625.sroa.0.0.i, %B1184.loopexit.i ], [ 0, %B1090.else.endif.endif.endif.endif.i ]
  %.3634339767.i = phi i64 [ %.36343397.i, %B1184.loopexit.i ], [ %.3634339765.i, %B1090.else.endif.endif.endif.endif.i ]
  %.3641340966.i = phi i64 [ %.36413409.i, %B1184.loopexit.i ], [ 512, %B1090.else.endif.endif.endif.endif.i ]
  %.3678.i = sub nsw i64 %arg.n_f, %.3625.sroa.0.068.i
  %.13.i.i = tail call i64 @llvm.smin.i64(i64 %.3678.i, i64 512)
  %.3712.i = sub nsw i64 %arg.n_linear, %.3625.sroa.0.068.i
  %.13.i98.i = tail call i64 @llvm.smin.i64(i64 %.3712.i, i64 %.13.i.i)
  %.3783.i = icmp sgt i64 %.13.i98.i, 0
  br i1 %.3783.i, label %B1306.if.preheader.i, label %B1410.i

B1306.if.preheader.i:                             ; preds = %B1188.i
  %0 = shl i64 %.3625.sroa.0.068.i, 3
  %scevgep384.i = getelementptr i8, ptr %arg.linear_at, i64 %0
  br label %B1306.if.i

B1410.i:                                          ; preds = %B1306.if.i, %B1188.i
  %.4093.i = sub i64 %.13.i.i, %.13.i98.i
  %.41363284.not.i = icmp slt i64 %.4093.i, 1
  br i1 %.41363284.not.i, label %B1468.i, label %B1442.if.preheader.i

B1442.if.preheader.i:                             ; preds = %B1410.i
  %.neg.i = add nsw i64 %.13.i98.i, 1
  %xtraiter.i = and i64 %.4093.i, 1
  %lcmp.mod.not.i = icmp eq i64 %xtraiter.i, 0
  br i1 %lcmp.mod.not.i, label %B1442.if.prol.loopexit.i, label %B1442.if.prol.i

B1442.if.prol.i:                                  ; preds = %B1442.if.preheader.i
  %.4145.prol.i = add nsw i64 %.4093.i, -1
  %.4187.prol.i = icmp slt i64 %.13.i98.i, 0
  %.4188.prol.i = select i1 %.4187.prol.i, i64 %.1323.i, i64 0
  %1 = getelementptr double, ptr %.1339.i, i64 %.13.i98.i
  %.4202.prol.i = getelementptr double, ptr %1, i64 %.4188.prol.i
  store double 0.000000e+00, ptr %.4202.prol.i, align 8, !noalias !1
  %.4218.prol.i = select i1 %.4187.prol.i, i64 %.1497.i, i64 0
  %2 = getelementptr double, ptr %.1513.i, i64 %.13.i98.i
  %.4232.prol.i = getelementptr double, ptr %2, i64 %.4218.prol.i
  store double 0.000000e+00, ptr %.4232.prol.i, align 8, !noalias !1
  br label %B1442.if.prol.loopexit.i

B1442.if.prol.loopexit.i:                         ; preds = %B1442.if.prol.i, %B1442.if.preheader.i
  %.413532823286.unr.i = phi i64 [ %.4093.i, %B1442.if.preheader.i ], [ %.4145.prol.i, %B1442.if.prol.i ]
  %.414232833285.unr.i = phi i64 [ %.13.i98.i, %B1442.if.preheader.i ], [ %.neg.i, %B1442.if.prol.i ]
  %3 = icmp eq i64 %.13.i.i, %.neg.i
  br i1 %3, label %B1468.i, label %B1442.if.preheader381.i

B1442.if.preheader381.i:                          ; preds = %B1442.if.prol.loopexit.i
  %4 = add nuw i64 %.413532823286.unr.i, 2
  br label %B1442.if.i

B1468.i:                                          ; preds = %B1442.if.i, %B1442.if.prol.loopexit.i, %B1410.i
  %.6657.i = icmp slt i64 %.3678.i, 0
  %.6658.i = select i1 %.6657.i, i64 %.1323.i, i64 0
  %.6659.i = add i64 %.6658.i, %.13.i.i
  %.4600.i = select i1 %.6657.i, i64 %.2426.i, i64 0
  %.4601.i = add i64 %.4600.i, %.13.i.i
  %.4985.i = select i1 %.6657.i, i64 %.2601.i, i64 0
  %.4986.i = add i64 %.4985.i, %.13.i.i
  %.8484.i = add nsw i64 %.13.i.i, %.3625.sroa.0.068.i
  %.8522.i = icmp slt i64 %.3625.sroa.0.068.i, 0
  %.8523.i = select i1 %.8522.i, i64 %arg.n_f, i64 0
  %.8524.i = add i64 %.8523.i, %.3625.sroa.0.068.i
  %.8539.i = icmp slt i64 %.8484.i, 0
  %.8540.i = select i1 %.8539.i, i64 %arg.n_f, i64 0
  %.8541.i = add i64 %.8540.i, %.8484.i
  %.8712.i = select i1 %.6657.i, i64 %.2058.i, i64 0
  %.8713.i = add i64 %.8712.i, %.13.i.i
  %.8884.i = select i1 %.6657.i, i64 %.2233.i, i64 0
  %.8885.i = add i64 %.8884.i, %.13.i.i
  %.7611.i = add i64 %.3625.sroa.0.068.i, %arg.n_f
  %.7837.i = select i1 %.8522.i, i64 %.7611.i, i64 %.3625.sroa.0.068.i
  %.9651.i = add nsw i64 %.3625.sroa.0.068.i, %.9649.i
  %.9652.i = shl nsw i64 %.9651.i, 1
  %.9697.i = icmp slt i64 %.9651.i, 0
  %.9698.i = select i1 %.9697.i, i64 %arg.n_spectrum, i64 0
  %.9699.i = add i64 %.9698.i, %.9652.i
  br i1 %79, label %B1502.preheader.i, label %B1184.loopexit.i

B1502.preheader.i:                                ; preds = %B1468.i
  %5 = tail call i64 @llvm.smax.i64(i64 %.13.i98.i, i64 0)
  %6 = shl nuw nsw i64 %5, 4
  %7 = icmp slt i64 %.7611.i, 0
  %8 = icmp slt i64 %.4601.i, 0
  %9 = icmp slt i64 %.4601.i, %.2426.i
  %10 = icmp slt i64 %.4986.i, 0
  %11 = icmp slt i64 %.4986.i, %.2601.i
  %12 = icmp slt i64 %.6659.i, 0
  %13 = icmp slt i64 %.6659.i, %.1323.i
  %14 = icmp slt i64 %.8713.i, 0
  %15 = icmp slt i64 %.8713.i, %.2058.i
  %16 = icmp slt i64 %.8885.i, 0
  %17 = icmp slt i64 %.8885.i, %.2233.i
  %18 = icmp slt i64 %.8524.i, 0
  %19 = icmp slt i64 %.8524.i, %arg.n_f
  %20 = icmp slt i64 %.8541.i, 0
  %21 = icmp slt i64 %.8541.i, %arg.n_f
  %22 = icmp slt i64 %.7837.i, 0
  %23 = icmp slt i64 %.7837.i, %arg.n_f
  %24 = icmp slt i64 %.9699.i, 0
  %25 = icmp slt i64 %.9699.i, %arg.n_spectrum
  %26 = icmp slt i64 %.13.i98.i, 1
  br label %B1502.i

B1502.i:                                          ; preds = %B3020.i, %B1502.preheader.i
  %.4310.sroa.0.061.i = phi i64 [ %.4310.sroa.0.0.i, %B3020.i ], [ 0, %B1502.preheader.i ]
  %.4319331760.i = phi i64 [ %.43193317.i, %B3020.i ], [ %.4319331758.i, %B1502.preheader.i ]
  %.4326332759.i = phi i64 [ %.43263327.i, %B3020.i ], [ 1, %B1502.preheader.i ]
  br i1 %82, label %B1516.i, label %B1868.else.endif.i

B1516.i:                                          ; preds = %B1502.i
  %.4368.i = add nsw i64 %.4310.sroa.0.061.i, %.4366.i
  %.4370.i = mul nsw i64 %.4368.i, %"$phi318.0.2.0.i"
  %.4373.i = add nsw i64 %.4370.i, %"$phi318.0.2.0.i"
  %.4410.i = icmp slt i64 %.4370.i, 0
  %.4411.i = select i1 %.4410.i, i64 %arg.n_amplitude, i64 0
  %.4412.i = add i64 %.4411.i, %.4370.i
  %.4415.i = icmp slt i64 %.4412.i, 0
  br i1 %.4415.i, label %B1516.else.if.i, label %B1516.else.endif.i, !prof !0

B1908.i:                                          ; preds = %B1868.endif.else.endif.endif.i, %B1516.endif.endif.endif.e...endif.15.i
  %si.2.sroa.36.3.i = phi ptr [ %.6540.i, %B1516.endif.endif.endif.e...endif.15.i ], [ %.6915.i, %B1868.endif.else.endif.endif.i ]
  %sr.2.sroa.36.3.i = phi ptr [ %.6368.i, %B1516.endif.endif.endif.e...endif.15.i ], [ %.6743.i, %B1868.endif.else.endif.endif.i ]
  %.6981.i = mul nsw i64 %.4310.sroa.0.061.i, %.6979.i
  %.6987.i = add nsw i64 %.4310.sroa.0.061.i, 1
  %.6988.i = mul nsw i64 %.6987.i, %.6979.i
  %.7025.i = icmp slt i64 %.6981.i, 0
  %.7026.i = select i1 %.7025.i, i64 %arg.n_table, i64 0
  %.7027.i = add i64 %.7026.i, %.6981.i
  %.7030.i = icmp slt i64 %.7027.i, 0
  br i1 %.7030.i, label %B1908.else.if.i, label %B1908.else.endif.i, !prof !0

B2054.i:                                          ; preds = %B2444.endif.endif.endif.endif.i, %B2054.preheader.i
  %.7308.sroa.0.054.i = phi i64 [ %.7308.sroa.0.0.i, %B2444.endif.endif.endif.endif.i ], [ 0, %B2054.preheader.i ]
  %.7317328953.i = phi i64 [ %.73173289.i, %B2444.endif.endif.endif.endif.i ], [ %.7317328951.i, %B2054.preheader.i ]
  %.7324329652.i = phi i64 [ %.73243296.i, %B2444.endif.endif.endif.endif.i ], [ 1, %B2054.preheader.i ]
  %.7388.i = load double, ptr %.161.i.i, align 8, !noalias !1
  %.7391.i = sitofp i64 %.7308.sroa.0.054.i to double
  %.7392.i = fmul contract double %.684, %.7391.i
  %.7393.i = fadd contract double %.7392.i, %.7388.i
  %.7426.i = load double, ptr %sunkaddr101.i, align 8, !noalias !1
  %.7427.i = fadd contract double %.7393.i, %.7426.i
  br i1 %90, label %B2136.i, label %B2300.i

B2136.i:                                          ; preds = %B2054.i
  br i1 %159, label %B2136.else.if.i, label %B2136.else.endif.i, !prof !0

B2300.i:                                          ; preds = %B2054.i
  %.48.i.i = load double, ptr %arg.knots, align 8, !noalias !4
  %.49.i.i = fsub contract double %.7427.i, %.48.i.i
  %.78.i.i = load double, ptr %sunkaddr102.i, align 8, !noalias !4
  %.85.i.i = fdiv contract double %.49.i.i, %.78.i.i
  %.93.le.i.i = tail call contract double @llvm.floor.f64(double %.85.i.i)
  %.5.i.i.i = fptosi double %.93.le.i.i to i64
  %.13.i.i.i = tail call i64 @llvm.smax.i64(i64 %.5.i.i.i, i64 2)
  %.13.i1.i.i = tail call i64 @llvm.smin.i64(i64 %.152.i.i, i64 %.13.i.i.i)
  %.181.i.i = sitofp i64 %.13.i1.i.i to double
  %.182.i.i = fsub contract double %.85.i.i, %.181.i.i
  %.183.i.i = fsub contract double 1.000000e+00, %.182.i.i
  %.184.i.i = fmul contract double %.183.i.i, %.183.i.i
  %.185.i.i = fmul contract double %.183.i.i, %.184.i.i
  %.186.i.i = fmul contract double %.183.i.i, %.185.i.i
  %.187.i.i = fmul contract double %.183.i.i, %.186.i.i
  %.191.i.i = fdiv contract double %.187.i.i, 1.200000e+02
  %.192.i.i = fmul contract double %.182.i.i, 5.000000e+00
  %.193.i.i = fadd contract double %.192.i.i, -2.000000e+01
  %.194.i.i = fmul contract double %.182.i.i, %.193.i.i
  %.195.i.i = fadd contract double %.194.i.i, 2.000000e+01
  %.196.i.i = fmul contract double %.182.i.i, %.195.i.i
  %.197.i.i = fadd contract double %.196.i.i, 2.000000e+01
  %.198.i.i = fmul contract double %.182.i.i, %.197.i.i
  %.199.i.i = fadd contract double %.198.i.i, -5.000000e+01
  %.200.i.i = fmul contract double %.182.i.i, %.199.i.i
  %.201.i.i = fadd contract double %.200.i.i, 2.600000e+01
  %.205.i.i = fdiv contract double %.201.i.i, 1.200000e+02
  %.206.i.i = fmul contract double %.182.i.i, %.182.i.i
  %.208.i.i = fmul contract double %.182.i.i, 1.000000e+01
  %.209.i.i = fsub contract double 3.000000e+01, %.208.i.i
  %.210.i.i = fmul contract double %.206.i.i, %.209.i.i
  %.211.i.i = fadd contract double %.210.i.i, -6.000000e+01
  %.212.i.i = fmul contract double %.206.i.i, %.211.i.i
  %.213.i.i = fadd contract double %.212.i.i, 6.600000e+01
  %.217.i.i = fdiv contract double %.213.i.i, 1.200000e+02
  %.220.i.i = fmul contract double %.183.i.i, 1.000000e+01
  %.221.i.i = fsub contract double 3.000000e+01, %.220.i.i
  %.222.i.i = fmul contract double %.184.i.i, %.221.i.i
  %.223.i.i = fadd contract double %.222.i.i, -6.000000e+01
  %.224.i.i = fmul contract double %.184.i.i, %.223.i.i
  %.225.i.i = fadd contract double %.224.i.i, 6.600000e+01
  %.229.i.i = fdiv contract double %.225.i.i, 1.200000e+02
  %.230.i.i = fmul contract double %.183.i.i, 5.000000e+00
  %.231.i.i = fadd contract double %.230.i.i, -2.000000e+01
  %.232.i.i = fmul contract double %.183.i.i, %.231.i.i
  %.233.i.i = fadd contract double %.232.i.i, 2.000000e+01
  %.234.i.i = fmul contract double %.183.i.i, %.233.i.i
  %.235.i.i = fadd contract double %.234.i.i, 2.000000e+01
  %.236.i.i = fmul contract double %.183.i.i, %.235.i.i
  %.237.i.i = fadd contract double %.236.i.i, -5.000000e+01
  %.238.i.i = fmul contract double %.183.i.i, %.237.i.i
  %.239.i.i = fadd contract double %.238.i.i, 2.600000e+01
  %.243.i.i = fdiv contract double %.239.i.i, 1.200000e+02
  %.245.i.i = fmul contract double %.182.i.i, %.206.i.i
  %.246.i.i = fmul contract double %.182.i.i, %.245.i.i
  %.247.i.i = fmul contract double %.182.i.i, %.246.i.i
  %.251.i.i = fdiv contract double %.247.i.i, 1.200000e+02
  %.265.i.i = add nsw i64 %.13.i1.i.i, -2
  %.266.i.i = mul nsw i64 %.265.i.i, %.904.i
  %.267.i.i = add nsw i64 %.266.i.i, %.3625.sroa.0.068.i
  br i1 %18, label %B2300.endif.else.if.i, label %B2300.endif.else.endif.i, !prof !0

B2658.i:                                          ; preds = %B2444.endif.endif.endif.endif.i, %B1908.else.endif.endif.endif.endif.i
  br i1 %83, label %B2692.i, label %B3020.i

B2692.i:                                          ; preds = %B2658.i
  br i1 %24, label %B2692.else.if.i, label %B2692.else.endif.i, !prof !0

B2818.i:                                          ; preds = %B2692.else.endif.endif.endif.endif.i
  br i1 %26, label %B3020.i, label %B2848.if.preheader.i

B2848.if.preheader.i:                             ; preds = %B2818.thread.i, %B2818.i
  %27 = shl i64 %.9687.sroa.0.3.i, 3
  %scevgep446.i = getelementptr i8, ptr %scevgep445.i, i64 %27
  br label %B2848.if.i

B3020.i:                                          ; preds = %B2848.if.i, %B2818.i, %B2658.i
  %.4320.i = icmp sgt i64 %.4319331760.i, 0
  %.4333.i = zext i1 %.4320.i to i64
  %.43263327.i = add i64 %.4326332759.i, %.4333.i
  %.4329.i = sext i1 %.4320.i to i64
  %.43193317.i = add nsw i64 %.4319331760.i, %.4329.i
  %.4310.sroa.0.0.i = select i1 %.4320.i, i64 %.4326332759.i, i64 0
  br i1 %.4320.i, label %B1502.i, label %B1184.loopexit.i

B3028.i:                                          ; preds = %B1184.loopexit.i, %B1090.else.endif.endif.endif.endif.i
  br i1 %78, label %B3894.i, label %B3080.i

B3076.loopexit.i:                                 ; preds = %B3762.endif.endif.i, %B3366.i
  %norm.2.2.lcssa.i = phi double [ %norm.3.181.i, %B3366.i ], [ %.12533.i, %B3762.endif.endif.i ]
  %.10496.i = icmp sgt i64 %.10495359883.i, 0
  %.10509.i = add i64 %.10502360482.i, 512
  %.105023604.i = select i1 %.10496.i, i64 %.10509.i, i64 %.10502360482.i
  %.10505.i = sext i1 %.10496.i to i64
  %.104953598.i = add nsw i64 %.10495359883.i, %.10505.i
  %.10486.sroa.0.0.i = select i1 %.10496.i, i64 %.10502360482.i, i64 0
  br i1 %.10496.i, label %B3080.i, label %B3894.i

B3080.i:                                          ; preds = %B3028.i, %B3076.loopexit.i
  %.10486.sroa.0.084.i = phi i64 [ %.10486.sroa.0.0.i, %B3076.loopexit.i ], [ 0, %B3028.i ]
  %.10495359883.i = phi i64 [ %.104953598.i, %B3076.loopexit.i ], [ %.10495359880.i, %B3028.i ]
  %.10502360482.i = phi i64 [ %.105023604.i, %B3076.loopexit.i ], [ 512, %B3028.i ]
  %norm.3.181.i = phi double [ %norm.2.2.lcssa.i, %B3076.loopexit.i ], [ 0.000000e+00, %B3028.i ]
  %.10539.i = sub nsw i64 %quot.1.0.i, %.10486.sroa.0.084.i
  %.13.i97.i = tail call i64 @llvm.smin.i64(i64 %.10539.i, i64 512)
  %.10573.i = sub nsw i64 %arg.n_quadratic, %.10486.sroa.0.084.i
  %.13.i229.i = tail call i64 @llvm.smin.i64(i64 %.10573.i, i64 %.13.i97.i)
  %.106863548.not.i = icmp slt i64 %.13.i229.i, 1
  br i1 %.106863548.not.i, label %B3318.i, label %B3198.if.preheader.i

B3198.if.preheader.i:                             ; preds = %B3080.i
  %28 = shl i64 %.10486.sroa.0.084.i, 3
  %scevgep453.i = getelementptr i8, ptr %arg.quadratic_at, i64 %28
  br label %B3198.if.i

B3318.i:                                          ; preds = %B3198.if.i, %B3080.i
  %.10929.i = sub i64 %.13.i97.i, %.13.i229.i
  %.109723555.not.i = icmp slt i64 %.10929.i, 1
  br i1 %.109723555.not.i, label %B3366.i, label %B3350.if.preheader.i

B3350.if.preheader.i:                             ; preds = %B3318.i
  %xtraiter356.i = and i64 %.10929.i, 3
  %lcmp.mod357.not.i = icmp eq i64 %xtraiter356.i, 0
  br i1 %lcmp.mod357.not.i, label %B3350.if.prol.loopexit.i, label %B3350.if.prol.preheader.i

B3350.if.prol.preheader.i:                        ; preds = %B3350.if.preheader.i
  %29 = sub nsw i64 0, %xtraiter356.i
  br label %B3350.if.prol.i

B3350.if.prol.i:                                  ; preds = %B3350.if.prol.i, %B3350.if.prol.preheader.i
  %lsr.iv60.i = phi i64 [ %lsr.iv.next61.i, %B3350.if.prol.i ], [ %29, %B3350.if.prol.preheader.i ]
  %.1097835543556.prol.i = phi i64 [ %.10985.prol.i, %B3350.if.prol.i ], [ %.13.i229.i, %B3350.if.prol.preheader.i ]
  %.10985.prol.i = add nsw i64 %.1097835543556.prol.i, 1
  %.11023.prol.i = icmp slt i64 %.1097835543556.prol.i, 0
  %30 = select i1 %.11023.prol.i, i64 %73, i64 0
  %scevgep456.i = getelementptr i8, ptr %.1339.i, i64 %30
  %31 = shl i64 %.1097835543556.prol.i, 3
  %scevgep457.i = getelementptr i8, ptr %scevgep456.i, i64 %31
  store double 0.000000e+00, ptr %scevgep457.i, align 8, !noalias !1
  %ov.i = icmp eq i64 %lsr.iv60.i, -1
  %lsr.iv.next61.i = add nsw i64 %lsr.iv60.i, 1
  br i1 %ov.i, label %B3350.if.prol.loopexit.loopexit.i, label %B3350.if.prol.i, !llvm.loop !7

B3350.if.prol.loopexit.loopexit.i:                ; preds = %B3350.if.prol.i
  %32 = sub i64 %.13.i97.i, %.10985.prol.i
  br label %B3350.if.prol.loopexit.i

B3350.if.prol.loopexit.i:                         ; preds = %B3350.if.prol.loopexit.loopexit.i, %B3350.if.preheader.i
  %.1097135533557.unr.i = phi i64 [ %.10929.i, %B3350.if.preheader.i ], [ %32, %B3350.if.prol.loopexit.loopexit.i ]
  %.1097835543556.unr.i = phi i64 [ %.13.i229.i, %B3350.if.preheader.i ], [ %.10985.prol.i, %B3350.if.prol.loopexit.loopexit.i ]
  %33 = sub i64 %.13.i229.i, %.13.i97.i
  %34 = icmp ugt i64 %33, -4
  br i1 %34, label %B3366.i, label %B3350.if.preheader380.i

B3350.if.preheader380.i:                          ; preds = %B3350.if.prol.loopexit.i
  %35 = add i64 %.1097135533557.unr.i, 4
  br label %B3350.if.i

B3366.i:                                          ; preds = %B3350.if.i, %B3350.if.prol.loopexit.i, %B3318.i
  %.11599.i = icmp slt i64 %.10539.i, 0
  %.11600.i = select i1 %.11599.i, i64 %.2426.i, i64 0
  %.11601.i = add i64 %.11600.i, %.13.i97.i
  %.12385.i = select i1 %.11599.i, i64 %.2058.i, i64 0
  %.12386.i = add i64 %.12385.i, %.13.i97.i
  br i1 %79, label %B3398.preheader.i, label %B3076.loopexit.i

B3398.preheader.i:                                ; preds = %B3366.i
  %xtraiter358.i = and i64 %.13.i97.i, 3
  %unroll_iter361.i = and i64 %.13.i97.i, 1020
  %unroll_iter374.i = and i64 %.13.i97.i, 1022
  %36 = icmp slt i64 %.12386.i, 0
  %37 = icmp slt i64 %.12386.i, %.2058.i
  %38 = icmp slt i64 %.10539.i, 1
  %39 = icmp slt i64 %.10539.i, 4
  %40 = icmp eq i64 %xtraiter358.i, 0
  %41 = icmp slt i64 %.11601.i, 0
  %42 = icmp slt i64 %.11601.i, %.2426.i
  %43 = icmp eq i64 %.10539.i, 1
  %44 = and i64 %.13.i97.i, 1
  %45 = icmp eq i64 %44, 0
  br label %B3398.i

B3398.i:                                          ; preds = %B3762.endif.endif.i, %B3398.preheader.i
  %.11121.sroa.0.076.i = phi i64 [ %.11121.sroa.0.0.i, %B3762.endif.endif.i ], [ 0, %B3398.preheader.i ]
  %.11130357475.i = phi i64 [ %.111303574.i, %B3762.endif.endif.i ], [ %.4319331758.i, %B3398.preheader.i ]
  %.11137357874.i = phi i64 [ %.111373578.i, %B3762.endif.endif.i ], [ 1, %B3398.preheader.i ]
  %norm.2.273.i = phi double [ %.12533.i, %B3762.endif.endif.i ], [ %norm.3.181.i, %B3398.preheader.i ]
  %.11174.i = mul nsw i64 %.11121.sroa.0.076.i, %quot.1.0.i
  %.11176.i = add nsw i64 %.11174.i, %.10486.sroa.0.084.i
  %.11220.i = icmp slt i64 %.11176.i, 0
  %.11221.i = select i1 %.11220.i, i64 %arg.n_norm, i64 0
  %.11222.i = add i64 %.11221.i, %.11176.i
  %.11225.i = icmp slt i64 %.11222.i, 0
  br i1 %.11225.i, label %B3398.else.if.i, label %B3398.else.endif.i, !prof !0

B3462.i:                                          ; preds = %B3398.else.endif.endif.endif.endif.i
  %.11368.i = add nsw i64 %.11121.sroa.0.076.i, %.4366.i
  %.11370.i = mul nsw i64 %.11368.i, %"$phi318.0.2.0.i"
  %.11373.i = add nsw i64 %.11370.i, %"$phi318.0.2.0.i"
  %.11410.i = icmp slt i64 %.11370.i, 0
  %.11411.i = select i1 %.11410.i, i64 %arg.n_amplitude, i64 0
  %.11412.i = add i64 %.11411.i, %.11370.i
  %.11415.i = icmp slt i64 %.11412.i, 0
  br i1 %.11415.i, label %B3462.else.if.i, label %B3462.else.endif.i, !prof !0

B3684.loopexit.unr-lcssa.i:                       ; preds = %B3590.if.i
  br i1 %45, label %B3762.i, label %B3590.if.epil.preheader.i

B3590.if.epil.preheader.i:                        ; preds = %B3590.if.preheader.i, %B3684.loopexit.unr-lcssa.i
  %.1184235683570.epil.init.i = phi i64 [ 0, %B3590.if.preheader.i ], [ %.11849.1.i, %B3684.loopexit.unr-lcssa.i ]
  %46 = getelementptr double, ptr %.1339.i, i64 %.1184235683570.epil.init.i
  %.11903.epil.i = load double, ptr %46, align 8, !noalias !1
  %47 = getelementptr double, ptr %.11323.i, i64 %.1184235683570.epil.init.i
  %.11933.epil.i = load double, ptr %47, align 8, !noalias !1
  %.11934.epil.i = fmul contract double %.11903.epil.i, %.11933.epil.i
  %48 = getelementptr double, ptr %.2442.i, i64 %.1184235683570.epil.init.i
  %.11964.epil.i = load double, ptr %48, align 8, !noalias !1
  %.11965.epil.i = fadd contract double %.11964.epil.i, 1.000000e+00
  %.11997.epil.i = fmul contract double %.11965.epil.i, %.11965.epil.i
  %.11998.epil.i = fmul contract double %.11934.epil.i, %.11997.epil.i
  %49 = getelementptr double, ptr %.2074.i, i64 %.1184235683570.epil.init.i
  store double %.11998.epil.i, ptr %49, align 8, !noalias !1
  br label %B3762.i

B3686.i:                                          ; preds = %B3398.else.endif.endif.endif.endif.i
  br i1 %38, label %B3762.i, label %B3716.if.preheader.i

B3716.if.preheader.i:                             ; preds = %B3686.i
  br i1 %39, label %B3716.if.epil.preheader.i, label %B3716.if.preheader379.i

B3716.if.preheader379.i:                          ; preds = %B3716.if.preheader.i
  %50 = shl i64 %.11210.sroa.0.3.i, 3
  %scevgep482.i = getelementptr i8, ptr %scevgep481.i, i64 %50
  br label %B3716.if.i

B3762.loopexit.unr-lcssa.i:                       ; preds = %B3716.if.i
  br i1 %40, label %B3762.i, label %B3716.if.epil.preheader.i

B3716.if.epil.preheader.i:                        ; preds = %B3762.loopexit.unr-lcssa.i, %B3716.if.preheader.i
  %.1212635613563.epil.init.i = phi i64 [ 0, %B3716.if.preheader.i ], [ %.12133.3.i, %B3762.loopexit.unr-lcssa.i ]
  %51 = shl nuw nsw i64 %.1212635613563.epil.init.i, 3
  %scevgep499.i = getelementptr i8, ptr %71, i64 %51
  %52 = add i64 %.1212635613563.epil.init.i, %.11210.sroa.0.3.i
  %53 = shl i64 %52, 3
  %scevgep501.i = getelementptr i8, ptr %arg.quadratic, i64 %53
  %scevgep504.i = getelementptr i8, ptr %69, i64 %51
  br label %B3716.if.epil.i

B3716.if.epil.i:                                  ; preds = %B3716.if.epil.i, %B3716.if.epil.preheader.i
  %epil.iter.i = phi i64 [ %epil.iter.next.i, %B3716.if.epil.i ], [ 0, %B3716.if.epil.preheader.i ]
  %54 = shl i64 %epil.iter.i, 3
  %scevgep84.i = getelementptr i8, ptr %scevgep504.i, i64 %54
  %.12187.epil.i = load double, ptr %scevgep84.i, align 8, !noalias !1
  %scevgep83.i = getelementptr i8, ptr %scevgep501.i, i64 %54
  %.12217.epil.i = load double, ptr %scevgep83.i, align 8, !noalias !1
  %.12218.epil.i = fmul contract double %.12187.epil.i, %.12217.epil.i
  %scevgep82.i = getelementptr i8, ptr %scevgep499.i, i64 %54
  store double %.12218.epil.i, ptr %scevgep82.i, align 8, !noalias !1
  %epil.iter.next.i = add i64 %epil.iter.i, 1
  %epil.iter.cmp.not.i = icmp eq i64 %xtraiter358.i, %epil.iter.next.i
  br i1 %epil.iter.cmp.not.i, label %B3762.i, label %B3716.if.epil.i, !llvm.loop !9

B3762.i:                                          ; preds = %B3716.if.epil.i, %B3462.endif.endif.endif.i, %B3762.loopexit.unr-lcssa.i, %B3686.i, %B3590.if.epil.preheader.i, %B3684.loopexit.unr-lcssa.i
  %.12274.i = icmp slt i64 %.11121.sroa.0.076.i, 0
  %.12275.i = select i1 %.12274.i, i64 %.1143.i, i64 0
  %.idx96.i = mul i64 %.11121.sroa.0.076.i, 24
  %55 = getelementptr i8, ptr %.1159.i, i64 %.idx96.i
  %.12289.i = getelementptr double, ptr %55, i64 %.12275.i
  %.12290.i = load double, ptr %.12289.i, align 8, !noalias !1
  %56 = getelementptr i8, ptr %55, i64 8
  %.12324.i = getelementptr double, ptr %56, i64 %.12275.i
  %.12325.i = load double, ptr %.12324.i, align 8, !noalias !1
  %.12326.i = fmul contract double %.12290.i, %.12290.i
  %.12327.i = fmul contract double %.12325.i, %.12325.i
  %.12328.i = fadd contract double %.12326.i, %.12327.i
  br i1 %91, label %B3762.else.endif.if.i, label %B3762.else.endif.endif.i, !prof !0

B3894.i:                                          ; preds = %B3076.loopexit.i, %B3028.i
  %norm.3.1.lcssa.i = phi double [ 0.000000e+00, %B3028.i ], [ %norm.2.2.lcssa.i, %B3076.loopexit.i ]
  %.12576.i = select i1 %.2847.i, i64 %arg.n_norms, i64 0
  %57 = getelementptr double, ptr %arg.norms, i64 %.2755.sroa.0.091.i
  %.12590.i = getelementptr double, ptr %57, i64 %.12576.i
  store double %norm.3.1.lcssa.i, ptr %.12590.i, align 8, !noalias !1
  %.2765.i = icmp sgt i64 %.2709.190.in.i, 1
  %.2778.i = zext i1 %.2765.i to i64
  %.2706.1.i = add i64 %.2706.189.i, %.2778.i
  %58 = tail call i64 @llvm.smax.i64(i64 %.2709.190.in.i, i64 2)
  %59 = add nsw i64 %58, -1
  %.2755.sroa.0.0.i = select i1 %.2765.i, i64 %.2706.189.i, i64 0
  br i1 %.2765.i, label %B890.i, label %_ZN17bnserve_inference6kernel7_source8contractB2v4B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5TupleI5ArrayIdLi1E1C7mutable7alignedExE5ArrayIdLi1E1C7mutable7alignedE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi3EE5TupleI5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi3EE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi4EE5TupleIxdE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi3EE5ArrayIdLi1E1C7mutable7alignedE.exit

B0.endif.else.i:                                  ; preds = %entry
  %.831.i = icmp ne i64 %arg.n_norm, -9223372036854775808
  %.832.i = icmp ne i64 %.759.1.i, -1
  %.833.not.i = or i1 %.832.i, %.831.i
  br i1 %.833.not.i, label %B0.endif.else.if.i, label %B0.endif.endif.i, !prof !10

B0.endif.endif.i:                                 ; preds = %B0.endif.else.if.i, %B0.endif.else.i, %entry
  %quot.1.0.i = phi i64 [ 0, %entry ], [ %.825.1.i, %B0.endif.else.if.i ], [ 0, %B0.endif.else.i ]
  %.904.i = shl nsw i64 %arg.n_f, 1
  %.906.i = mul nsw i64 %.904.i, %.759.1.i
  %.909.i = icmp eq i64 %.906.i, 0
  br i1 %.909.i, label %B0.endif.endif.endif.i, label %B0.endif.endif.else.i, !prof !0

B0.endif.else.if.i:                               ; preds = %B0.endif.else.i
  %.836.i = sdiv i64 %arg.n_norm, %.759.1.i
  %.837.i = srem i64 %arg.n_norm, %.759.1.i
  %.838.i = xor i64 %.837.i, %.759.1.i
  %.839.i = icmp slt i64 %.838.i, 0
  %.840.i = icmp ne i64 %.837.i, 0
  %.841.i = and i1 %.840.i, %.839.i
  %.846.i = sext i1 %.841.i to i64
  %.825.1.i = add i64 %.836.i, %.846.i
  br label %B0.endif.endif.i

B0.endif.endif.else.i:                            ; preds = %B0.endif.endif.i
  %.925.i = sdiv i64 %arg.n_table, %.906.i
  %.926.i = srem i64 %arg.n_table, %.906.i
  %.927.i = xor i64 %.926.i, %.906.i
  %.928.i = icmp slt i64 %.927.i, 0
  %.929.i = icmp ne i64 %.926.i, 0
  %.930.i = and i1 %.929.i, %.928.i
  %.935.i = sext i1 %.930.i to i64
  %.914.1.i = add i64 %.925.i, %.935.i
  br label %B0.endif.endif.endif.i

B0.endif.endif.endif.i:                           ; preds = %B0.endif.endif.else.i, %B0.endif.endif.i
  %quot.2.0.i = phi i64 [ %.914.1.i, %B0.endif.endif.else.i ], [ 0, %B0.endif.endif.i ]
  %.951.i = icmp sgt i64 %arg.n_f, 0
  br i1 %.951.i, label %B284.i, label %B318.i

B318.else.endif.if.i:                             ; preds = %B318.i
  br label %B318.else.endif.endif.i

B318.else.endif.endif.i:                          ; preds = %B318.else.endif.if.i, %B318.i
  %.1046.sroa.0.3.i = phi i64 [ %arg.n_scratch, %B318.else.endif.if.i ], [ 0, %B318.i ]
  %.1073.i = icmp slt i64 %.759.1.i, 0
  %.1074.i = select i1 %.1073.i, i64 %arg.n_scratch, i64 0
  %.1075.i = add i64 %.1074.i, %.1019.i
  %.1078.i = icmp slt i64 %.1075.i, 0
  br i1 %.1078.i, label %B318.else.endif.endif.if.i, label %B318.else.endif.endif.endif.i, !prof !0

B318.else.endif.endif.if.i:                       ; preds = %B318.else.endif.endif.i
  br label %B318.else.endif.endif.endif.i

B318.else.endif.endif.endif.i:                    ; preds = %B318.else.endif.endif.if.i, %B318.else.endif.endif.i
  %.1046.sroa.13.1.i = phi i64 [ 0, %B318.else.endif.endif.if.i ], [ %.1075.i, %B318.else.endif.endif.i ]
  %.1083.not.i = icmp slt i64 %.1075.i, %arg.n_scratch
  br i1 %.1083.not.i, label %B318.else.endif.endif.endif.endif.i, label %B318.else.endif.endif.endif.if.i, !prof !10

B318.else.endif.endif.endif.if.i:                 ; preds = %B318.else.endif.endif.endif.i
  br label %B318.else.endif.endif.endif.endif.i

B318.else.endif.endif.endif.endif.i:              ; preds = %B318.else.endif.endif.endif.if.i, %B318.else.endif.endif.endif.i
  %.1046.sroa.13.2.i = phi i64 [ %arg.n_scratch, %B318.else.endif.endif.endif.if.i ], [ %.1046.sroa.13.1.i, %B318.else.endif.endif.endif.i ]
  %.1134.i = sub i64 %.1046.sroa.13.2.i, %.1046.sroa.0.3.i
  %.1143.i = tail call i64 @llvm.smax.i64(i64 %.1134.i, i64 0)
  %.1159.i = getelementptr double, ptr %arg.scratch, i64 %.1046.sroa.0.3.i
  %.1199.i = add nsw i64 %.1019.i, 512
  br i1 %.1078.i, label %B318.endif.else.if.i, label %B318.endif.else.endif.i, !prof !0

B318.endif.else.if.i:                             ; preds = %B318.else.endif.endif.endif.endif.i
  br label %B318.endif.else.endif.i

B318.endif.else.endif.i:                          ; preds = %B318.endif.else.if.i, %B318.else.endif.endif.endif.endif.i
  %.1226.sroa.0.1.i = phi i64 [ 0, %B318.endif.else.if.i ], [ %.1075.i, %B318.else.endif.endif.endif.endif.i ]
  br i1 %.1083.not.i, label %B318.endif.else.endif.endif.i, label %B318.endif.else.endif.if.i, !prof !10

B318.endif.else.endif.if.i:                       ; preds = %B318.endif.else.endif.i
  br label %B318.endif.else.endif.endif.i

B318.endif.else.endif.endif.i:                    ; preds = %B318.endif.else.endif.if.i, %B318.endif.else.endif.i
  %.1226.sroa.0.3.i = phi i64 [ %arg.n_scratch, %B318.endif.else.endif.if.i ], [ %.1226.sroa.0.1.i, %B318.endif.else.endif.i ]
  %.1253.i = icmp slt i64 %.759.1.i, -170
  %.1254.i = select i1 %.1253.i, i64 %arg.n_scratch, i64 0
  %.1255.i = add i64 %.1199.i, %.1254.i
  %.1258.i = icmp slt i64 %.1255.i, 0
  br i1 %.1258.i, label %B318.endif.else.endif.endif.if.i, label %B318.endif.else.endif.endif.endif.i, !prof !0

B318.endif.else.endif.endif.if.i:                 ; preds = %B318.endif.else.endif.endif.i
  br label %B318.endif.else.endif.endif.endif.i

B318.endif.else.endif.endif.endif.i:              ; preds = %B318.endif.else.endif.endif.if.i, %B318.endif.else.endif.endif.i
  %.1226.sroa.13.1.i = phi i64 [ 0, %B318.endif.else.endif.endif.if.i ], [ %.1255.i, %B318.endif.else.endif.endif.i ]
  %.1263.not.i = icmp slt i64 %.1255.i, %arg.n_scratch
  br i1 %.1263.not.i, label %B318.endif.else.endif.endif.endif.endif.i, label %B318.endif.else.endif.endif.endif.if.i, !prof !10

B318.endif.else.endif.endif.endif.if.i:           ; preds = %B318.endif.else.endif.endif.endif.i
  br label %B318.endif.else.endif.endif.endif.endif.i

B318.endif.else.endif.endif.endif.endif.i:        ; preds = %B318.endif.else.endif.endif.endif.if.i, %B318.endif.else.endif.endif.endif.i
  %.1226.sroa.13.2.i = phi i64 [ %arg.n_scratch, %B318.endif.else.endif.endif.endif.if.i ], [ %.1226.sroa.13.1.i, %B318.endif.else.endif.endif.endif.i ]
  %.1314.i = sub i64 %.1226.sroa.13.2.i, %.1226.sroa.0.3.i
  %.1323.i = tail call i64 @llvm.smax.i64(i64 %.1314.i, i64 0)
  %.1339.i = getelementptr double, ptr %arg.scratch, i64 %.1226.sroa.0.3.i
  %.1373.i = add nsw i64 %.1019.i, 1024
  br i1 %.1258.i, label %B318.endif.endif.else.if.i, label %B318.endif.endif.else.endif.i, !prof !0

B318.endif.endif.else.if.i:                       ; preds = %B318.endif.else.endif.endif.endif.endif.i
  br label %B318.endif.endif.else.endif.i

B318.endif.endif.else.endif.i:                    ; preds = %B318.endif.endif.else.if.i, %B318.endif.else.endif.endif.endif.endif.i
  %.1400.sroa.0.1.i = phi i64 [ 0, %B318.endif.endif.else.if.i ], [ %.1255.i, %B318.endif.else.endif.endif.endif.endif.i ]
  br i1 %.1263.not.i, label %B318.endif.endif.else.endif.endif.i, label %B318.endif.endif.else.endif.if.i, !prof !10

B318.endif.endif.else.endif.if.i:                 ; preds = %B318.endif.endif.else.endif.i
  br label %B318.endif.endif.else.endif.endif.i

B318.endif.endif.else.endif.endif.i:              ; preds = %B318.endif.endif.else.endif.if.i, %B318.endif.endif.else.endif.i
  %.1400.sroa.0.3.i = phi i64 [ %arg.n_scratch, %B318.endif.endif.else.endif.if.i ], [ %.1400.sroa.0.1.i, %B318.endif.endif.else.endif.i ]
  %.1427.i = icmp slt i64 %.759.1.i, -341
  %.1428.i = select i1 %.1427.i, i64 %arg.n_scratch, i64 0
  %.1429.i = add i64 %.1373.i, %.1428.i
  %.1432.i = icmp slt i64 %.1429.i, 0
  br i1 %.1432.i, label %B318.endif.endif.else.endif.endif.if.i, label %B318.endif.endif.else.endif.endif.endif.i, !prof !0

B318.endif.endif.else.endif.endif.if.i:           ; preds = %B318.endif.endif.else.endif.endif.i
  br label %B318.endif.endif.else.endif.endif.endif.i

B318.endif.endif.else.endif.endif.endif.i:        ; preds = %B318.endif.endif.else.endif.endif.if.i, %B318.endif.endif.else.endif.endif.i
  %.1400.sroa.13.1.i = phi i64 [ 0, %B318.endif.endif.else.endif.endif.if.i ], [ %.1429.i, %B318.endif.endif.else.endif.endif.i ]
  %.1437.not.i = icmp slt i64 %.1429.i, %arg.n_scratch
  br i1 %.1437.not.i, label %B318.endif.endif.else.endif.endif.endif.endif.i, label %B318.endif.endif.else.endif.endif.endif.if.i, !prof !10

B318.endif.endif.else.endif.endif.endif.if.i:     ; preds = %B318.endif.endif.else.endif.endif.endif.i
  br label %B318.endif.endif.else.endif.endif.endif.endif.i

B318.endif.endif.else.endif.endif.endif.endif.i:  ; preds = %B318.endif.endif.else.endif.endif.endif.if.i, %B318.endif.endif.else.endif.endif.endif.i
  %.1400.sroa.13.2.i = phi i64 [ %arg.n_scratch, %B318.endif.endif.else.endif.endif.endif.if.i ], [ %.1400.sroa.13.1.i, %B318.endif.endif.else.endif.endif.endif.i ]
  %.1488.i = sub i64 %.1400.sroa.13.2.i, %.1400.sroa.0.3.i
  %.1497.i = tail call i64 @llvm.smax.i64(i64 %.1488.i, i64 0)
  %.1513.i = getelementptr double, ptr %arg.scratch, i64 %.1400.sroa.0.3.i
  %.1566.i = add nsw i64 %.1019.i, 1536
  br i1 %.1432.i, label %B318.endif.endif.endif.else.if.i, label %B318.endif.endif.endif.else.endif.i, !prof !0

B318.endif.endif.endif.else.if.i:                 ; preds = %B318.endif.endif.else.endif.endif.endif.endif.i
  br label %B318.endif.endif.endif.else.endif.i

B318.endif.endif.endif.else.endif.i:              ; preds = %B318.endif.endif.endif.else.if.i, %B318.endif.endif.else.endif.endif.endif.endif.i
  %.1593.sroa.0.1.i = phi i64 [ 0, %B318.endif.endif.endif.else.if.i ], [ %.1429.i, %B318.endif.endif.else.endif.endif.endif.endif.i ]
  br i1 %.1437.not.i, label %B318.endif.endif.endif.else.endif.endif.i, label %B318.endif.endif.endif.else.endif.if.i, !prof !10

B318.endif.endif.endif.else.endif.if.i:           ; preds = %B318.endif.endif.endif.else.endif.i
  br label %B318.endif.endif.endif.else.endif.endif.i

B318.endif.endif.endif.else.endif.endif.i:        ; preds = %B318.endif.endif.endif.else.endif.if.i, %B318.endif.endif.endif.else.endif.i
  %.1593.sroa.0.3.i = phi i64 [ %arg.n_scratch, %B318.endif.endif.endif.else.endif.if.i ], [ %.1593.sroa.0.1.i, %B318.endif.endif.endif.else.endif.i ]
  %.1620.i = icmp slt i64 %.759.1.i, -512
  %.1621.i = select i1 %.1620.i, i64 %arg.n_scratch, i64 0
  %.1622.i = add i64 %.1566.i, %.1621.i
  %.1625.i = icmp slt i64 %.1622.i, 0
  br i1 %.1625.i, label %B318.endif.endif.endif.else.endif.endif.if.i, label %B318.endif.endif.endif.else.endif.endif.endif.i, !prof !0

B318.endif.endif.endif.else.endif.endif.if.i:     ; preds = %B318.endif.endif.endif.else.endif.endif.i
  br label %B318.endif.endif.endif.else.endif.endif.endif.i

B318.endif.endif.endif.else.endif.endif.endif.i:  ; preds = %B318.endif.endif.endif.else.endif.endif.if.i, %B318.endif.endif.endif.else.endif.endif.i
  %.1593.sroa.13.1.i = phi i64 [ 0, %B318.endif.endif.endif.else.endif.endif.if.i ], [ %.1622.i, %B318.endif.endif.endif.else.endif.endif.i ]
  %.1630.not.i = icmp slt i64 %.1622.i, %arg.n_scratch
  br i1 %.1630.not.i, label %B318.endif.endif.endif.else.endif.endif.endif.endif.i, label %B318.endif.endif.endif.else.endif.endif.endif.if.i, !prof !10

B318.endif.endif.endif.else.endif.endif.endif.if.i: ; preds = %B318.endif.endif.endif.else.endif.endif.endif.i
  br label %B318.endif.endif.endif.else.endif.endif.endif.endif.i

B318.endif.endif.endif.else.endif.endif.endif.endif.i: ; preds = %B318.endif.endif.endif.else.endif.endif.endif.if.i, %B318.endif.endif.endif.else.endif.endif.endif.i
  %.1593.sroa.13.2.i = phi i64 [ %arg.n_scratch, %B318.endif.endif.endif.else.endif.endif.endif.if.i ], [ %.1593.sroa.13.1.i, %B318.endif.endif.endif.else.endif.endif.endif.i ]
  %.1681.i = sub i64 %.1593.sroa.13.2.i, %.1593.sroa.0.3.i
  %.1690.i = tail call i64 @llvm.smax.i64(i64 %.1681.i, i64 0)
  %.1706.i = getelementptr double, ptr %arg.scratch, i64 %.1593.sroa.0.3.i
  %.1741.i = add nsw i64 %.1019.i, 2048
  br i1 %.1625.i, label %B318.endif.endif.endif.endif.else.if.i, label %B318.endif.endif.endif.endif.else.endif.i, !prof !0

B318.endif.endif.endif.endif.else.if.i:           ; preds = %B318.endif.endif.endif.else.endif.endif.endif.endif.i
  br label %B318.endif.endif.endif.endif.else.endif.i

B318.endif.endif.endif.endif.else.endif.i:        ; preds = %B318.endif.endif.endif.endif.else.if.i, %B318.endif.endif.endif.else.endif.endif.endif.endif.i
  %.1768.sroa.0.1.i = phi i64 [ 0, %B318.endif.endif.endif.endif.else.if.i ], [ %.1622.i, %B318.endif.endif.endif.else.endif.endif.endif.endif.i ]
  br i1 %.1630.not.i, label %B318.endif.endif.endif.endif.else.endif.endif.i, label %B318.endif.endif.endif.endif.else.endif.if.i, !prof !10

B318.endif.endif.endif.endif.else.endif.if.i:     ; preds = %B318.endif.endif.endif.endif.else.endif.i
  br label %B318.endif.endif.endif.endif.else.endif.endif.i

B318.endif.endif.endif.endif.else.endif.endif.i:  ; preds = %B318.endif.endif.endif.endif.else.endif.if.i, %B318.endif.endif.endif.endif.else.endif.i
  %.1768.sroa.0.3.i = phi i64 [ %arg.n_scratch, %B318.endif.endif.endif.endif.else.endif.if.i ], [ %.1768.sroa.0.1.i, %B318.endif.endif.endif.endif.else.endif.i ]
  %.1795.i = icmp slt i64 %.759.1.i, -682
  %.1796.i = select i1 %.1795.i, i64 %arg.n_scratch, i64 0
  %.1797.i = add i64 %.1741.i, %.1796.i
  %.1800.i = icmp slt i64 %.1797.i, 0
  br i1 %.1800.i, label %B318.endif.endif.endif.endif.else.endif.endif.if.i, label %B318.endif.endif.endif.endif.else.endif.endif.endif.i, !prof !0

B318.endif.endif.endif.endif.else.endif.endif.if.i: ; preds = %B318.endif.endif.endif.endif.else.endif.endif.i
  br label %B318.endif.endif.endif.endif.else.endif.endif.endif.i

B318.endif.endif.endif.endif.else.endif.endif.endif.i: ; preds = %B318.endif.endif.endif.endif.else.endif.endif.if.i, %B318.endif.endif.endif.endif.else.endif.endif.i
  %.1768.sroa.13.1.i = phi i64 [ 0, %B318.endif.endif.endif.endif.else.endif.endif.if.i ], [ %.1797.i, %B318.endif.endif.endif.endif.else.endif.endif.i ]
  %.1805.not.i = icmp slt i64 %.1797.i, %arg.n_scratch
  br i1 %.1805.not.i, label %B318.endif.endif.endif.en...endif.i, label %B318.endif.endif.endif.en...if.i, !prof !10

B318.endif.endif.endif.en...if.i:                 ; preds = %B318.endif.endif.endif.endif.else.endif.endif.endif.i
  br label %B318.endif.endif.endif.en...endif.i

B318.endif.endif.endif.en...endif.i:              ; preds = %B318.endif.endif.endif.en...if.i, %B318.endif.endif.endif.endif.else.endif.endif.endif.i
  %.1768.sroa.13.2.i = phi i64 [ %arg.n_scratch, %B318.endif.endif.endif.en...if.i ], [ %.1768.sroa.13.1.i, %B318.endif.endif.endif.endif.else.endif.endif.endif.i ]
  %.1856.i = sub i64 %.1768.sroa.13.2.i, %.1768.sroa.0.3.i
  %.1865.i = tail call i64 @llvm.smax.i64(i64 %.1856.i, i64 0)
  %.1881.i = getelementptr double, ptr %arg.scratch, i64 %.1768.sroa.0.3.i
  %.1934.i = add nsw i64 %.1019.i, 2560
  br i1 %.1800.i, label %B318.endif.endif.endif.endif.endif.else.if.i, label %B318.endif.endif.endif.endif.endif.else.endif.i, !prof !0

B318.endif.endif.endif.endif.endif.else.if.i:     ; preds = %B318.endif.endif.endif.en...endif.i
  br label %B318.endif.endif.endif.endif.endif.else.endif.i

B318.endif.endif.endif.endif.endif.else.endif.i:  ; preds = %B318.endif.endif.endif.endif.endif.else.if.i, %B318.endif.endif.endif.en...endif.i
  %.1961.sroa.0.1.i = phi i64 [ 0, %B318.endif.endif.endif.endif.endif.else.if.i ], [ %.1797.i, %B318.endif.endif.endif.en...endif.i ]
  br i1 %.1805.not.i, label %B318.endif.endif.endif.endif.endif.else.endif.endif.i, label %B318.endif.endif.endif.endif.endif.else.endif.if.i, !prof !10

B318.endif.endif.endif.endif.endif.else.endif.if.i: ; preds = %B318.endif.endif.endif.endif.endif.else.endif.i
  br label %B318.endif.endif.endif.endif.endif.else.endif.endif.i

B318.endif.endif.endif.endif.endif.else.endif.endif.i: ; preds = %B318.endif.endif.endif.endif.endif.else.endif.if.i, %B318.endif.endif.endif.endif.endif.else.endif.i
  %.1961.sroa.0.3.i = phi i64 [ %arg.n_scratch, %B318.endif.endif.endif.endif.endif.else.endif.if.i ], [ %.1961.sroa.0.1.i, %B318.endif.endif.endif.endif.endif.else.endif.i ]
  %.1988.i = icmp slt i64 %.759.1.i, -853
  %.1989.i = select i1 %.1988.i, i64 %arg.n_scratch, i64 0
  %.1990.i = add i64 %.1934.i, %.1989.i
  %.1993.i = icmp slt i64 %.1990.i, 0
  br i1 %.1993.i, label %B318.endif.endif.endif.en...if.1.i, label %B318.endif.endif.endif.en...endif.1.i, !prof !0

B318.endif.endif.endif.en...if.1.i:               ; preds = %B318.endif.endif.endif.endif.endif.else.endif.endif.i
  br label %B318.endif.endif.endif.en...endif.1.i

B318.endif.endif.endif.en...endif.1.i:            ; preds = %B318.endif.endif.endif.en...if.1.i, %B318.endif.endif.endif.endif.endif.else.endif.endif.i
  %.1961.sroa.13.1.i = phi i64 [ 0, %B318.endif.endif.endif.en...if.1.i ], [ %.1990.i, %B318.endif.endif.endif.endif.endif.else.endif.endif.i ]
  %.1998.not.i = icmp slt i64 %.1990.i, %arg.n_scratch
  br i1 %.1998.not.i, label %B318.endif.endif.endif.en...endif.1.endif.i, label %B318.endif.endif.endif.en...endif.1.if.i, !prof !10

B318.endif.endif.endif.en...endif.1.if.i:         ; preds = %B318.endif.endif.endif.en...endif.1.i
  br label %B318.endif.endif.endif.en...endif.1.endif.i

B318.endif.endif.endif.en...endif.1.endif.i:      ; preds = %B318.endif.endif.endif.en...endif.1.if.i, %B318.endif.endif.endif.en...endif.1.i
  %.1961.sroa.13.2.i = phi i64 [ %arg.n_scratch, %B318.endif.endif.endif.en...endif.1.if.i ], [ %.1961.sroa.13.1.i, %B318.endif.endif.endif.en...endif.1.i ]
  %.2049.i = sub i64 %.1961.sroa.13.2.i, %.1961.sroa.0.3.i
  %.2058.i = tail call i64 @llvm.smax.i64(i64 %.2049.i, i64 0)
  %.2074.i = getelementptr double, ptr %arg.scratch, i64 %.1961.sroa.0.3.i
  %.2109.i = add nsw i64 %.1019.i, 3072
  br i1 %.1993.i, label %B318.endif.endif.endif.endif.endif.endif.else.if.i, label %B318.endif.endif.endif.endif.endif.endif.else.endif.i, !prof !0

B318.endif.endif.endif.endif.endif.endif.else.if.i: ; preds = %B318.endif.endif.endif.en...endif.1.endif.i
  br label %B318.endif.endif.endif.endif.endif.endif.else.endif.i

B318.endif.endif.endif.endif.endif.endif.else.endif.i: ; preds = %B318.endif.endif.endif.endif.endif.endif.else.if.i, %B318.endif.endif.endif.en...endif.1.endif.i
  %.2136.sroa.0.1.i = phi i64 [ 0, %B318.endif.endif.endif.endif.endif.endif.else.if.i ], [ %.1990.i, %B318.endif.endif.endif.en...endif.1.endif.i ]
  br i1 %.1998.not.i, label %B318.endif.endif.endif.en...endif.3.i, label %B318.endif.endif.endif.en...if.3.i, !prof !10

B318.endif.endif.endif.en...if.3.i:               ; preds = %B318.endif.endif.endif.endif.endif.endif.else.endif.i
  br label %B318.endif.endif.endif.en...endif.3.i

B318.endif.endif.endif.en...endif.3.i:            ; preds = %B318.endif.endif.endif.en...if.3.i, %B318.endif.endif.endif.endif.endif.endif.else.endif.i
  %.2136.sroa.0.3.i = phi i64 [ %arg.n_scratch, %B318.endif.endif.endif.en...if.3.i ], [ %.2136.sroa.0.1.i, %B318.endif.endif.endif.endif.endif.endif.else.endif.i ]
  %.2163.i = icmp slt i64 %.759.1.i, -1024
  %.2164.i = select i1 %.2163.i, i64 %arg.n_scratch, i64 0
  %.2165.i = add i64 %.2109.i, %.2164.i
  %.2168.i = icmp slt i64 %.2165.i, 0
  br i1 %.2168.i, label %B318.endif.endif.endif.en...endif.3.if.i, label %B318.endif.endif.endif.en...endif.3.endif.i, !prof !0

B318.endif.endif.endif.en...endif.3.if.i:         ; preds = %B318.endif.endif.endif.en...endif.3.i
  br label %B318.endif.endif.endif.en...endif.3.endif.i

B318.endif.endif.endif.en...endif.3.endif.i:      ; preds = %B318.endif.endif.endif.en...endif.3.if.i, %B318.endif.endif.endif.en...endif.3.i
  %.2136.sroa.13.1.i = phi i64 [ 0, %B318.endif.endif.endif.en...endif.3.if.i ], [ %.2165.i, %B318.endif.endif.endif.en...endif.3.i ]
  %.2173.not.i = icmp slt i64 %.2165.i, %arg.n_scratch
  br i1 %.2173.not.i, label %B318.endif.endif.endif.en...endif.3.endif.endif.i, label %B318.endif.endif.endif.en...endif.3.endif.if.i, !prof !10

B318.endif.endif.endif.en...endif.3.endif.if.i:   ; preds = %B318.endif.endif.endif.en...endif.3.endif.i
  br label %B318.endif.endif.endif.en...endif.3.endif.endif.i

B318.endif.endif.endif.en...endif.3.endif.endif.i: ; preds = %B318.endif.endif.endif.en...endif.3.endif.if.i, %B318.endif.endif.endif.en...endif.3.endif.i
  %.2136.sroa.13.2.i = phi i64 [ %arg.n_scratch, %B318.endif.endif.endif.en...endif.3.endif.if.i ], [ %.2136.sroa.13.1.i, %B318.endif.endif.endif.en...endif.3.endif.i ]
  %.2224.i = sub i64 %.2136.sroa.13.2.i, %.2136.sroa.0.3.i
  %.2233.i = tail call i64 @llvm.smax.i64(i64 %.2224.i, i64 0)
  %.2249.i = getelementptr double, ptr %arg.scratch, i64 %.2136.sroa.0.3.i
  %.2302.i = add nsw i64 %.1019.i, 3584
  br i1 %.2168.i, label %B318.endif.endif.endif.en...if.5.i, label %B318.endif.endif.endif.en...endif.5.i, !prof !0

B318.endif.endif.endif.en...if.5.i:               ; preds = %B318.endif.endif.endif.en...endif.3.endif.endif.i
  br label %B318.endif.endif.endif.en...endif.5.i

B318.endif.endif.endif.en...endif.5.i:            ; preds = %B318.endif.endif.endif.en...if.5.i, %B318.endif.endif.endif.en...endif.3.endif.endif.i
  %.2329.sroa.0.1.i = phi i64 [ 0, %B318.endif.endif.endif.en...if.5.i ], [ %.2165.i, %B318.endif.endif.endif.en...endif.3.endif.endif.i ]
  br i1 %.2173.not.i, label %B318.endif.endif.endif.en...endif.5.endif.i, label %B318.endif.endif.endif.en...endif.5.if.i, !prof !10

B318.endif.endif.endif.en...endif.5.if.i:         ; preds = %B318.endif.endif.endif.en...endif.5.i
  br label %B318.endif.endif.endif.en...endif.5.endif.i

B318.endif.endif.endif.en...endif.5.endif.i:      ; preds = %B318.endif.endif.endif.en...endif.5.if.i, %B318.endif.endif.endif.en...endif.5.i
  %.2329.sroa.0.3.i = phi i64 [ %arg.n_scratch, %B318.endif.endif.endif.en...endif.5.if.i ], [ %.2329.sroa.0.1.i, %B318.endif.endif.endif.en...endif.5.i ]
  %.2356.i = icmp slt i64 %.759.1.i, -1194
  %.2357.i = select i1 %.2356.i, i64 %arg.n_scratch, i64 0
  %.2358.i = add i64 %.2302.i, %.2357.i
  %.2361.i = icmp slt i64 %.2358.i, 0
  br i1 %.2361.i, label %B318.endif.endif.endif.en...endif.5.endif.if.i, label %B318.endif.endif.endif.en...endif.5.endif.endif.i, !prof !0

B318.endif.endif.endif.en...endif.5.endif.if.i:   ; preds = %B318.endif.endif.endif.en...endif.5.endif.i
  br label %B318.endif.endif.endif.en...endif.5.endif.endif.i

B318.endif.endif.endif.en...endif.5.endif.endif.i: ; preds = %B318.endif.endif.endif.en...endif.5.endif.if.i, %B318.endif.endif.endif.en...endif.5.endif.i
  %.2329.sroa.13.1.i = phi i64 [ 0, %B318.endif.endif.endif.en...endif.5.endif.if.i ], [ %.2358.i, %B318.endif.endif.endif.en...endif.5.endif.i ]
  %.2366.not.i = icmp slt i64 %.2358.i, %arg.n_scratch
  br i1 %.2366.not.i, label %B318.endif.endif.endif.en...endif.5.endif.endif.endif.i, label %B318.endif.endif.endif.en...endif.5.endif.endif.if.i, !prof !10

B318.endif.endif.endif.en...endif.5.endif.endif.if.i: ; preds = %B318.endif.endif.endif.en...endif.5.endif.endif.i
  br label %B318.endif.endif.endif.en...endif.5.endif.endif.endif.i

B318.endif.endif.endif.en...endif.5.endif.endif.endif.i: ; preds = %B318.endif.endif.endif.en...endif.5.endif.endif.if.i, %B318.endif.endif.endif.en...endif.5.endif.endif.i
  %.2329.sroa.13.2.i = phi i64 [ %arg.n_scratch, %B318.endif.endif.endif.en...endif.5.endif.endif.if.i ], [ %.2329.sroa.13.1.i, %B318.endif.endif.endif.en...endif.5.endif.endif.i ]
  %.2417.i = sub i64 %.2329.sroa.13.2.i, %.2329.sroa.0.3.i
  %.2426.i = tail call i64 @llvm.smax.i64(i64 %.2417.i, i64 0)
  %.2442.i = getelementptr double, ptr %arg.scratch, i64 %.2329.sroa.0.3.i
  %.2477.i = add nsw i64 %.1019.i, 4096
  br i1 %.2361.i, label %B318.endif.endif.endif.en...else.if.i, label %B318.endif.endif.endif.en...else.endif.i, !prof !0

B318.endif.endif.endif.en...else.if.i:            ; preds = %B318.endif.endif.endif.en...endif.5.endif.endif.endif.i
  br label %B318.endif.endif.endif.en...else.endif.i

B318.endif.endif.endif.en...else.endif.i:         ; preds = %B318.endif.endif.endif.en...else.if.i, %B318.endif.endif.endif.en...endif.5.endif.endif.endif.i
  %.2504.sroa.0.1.i = phi i64 [ 0, %B318.endif.endif.endif.en...else.if.i ], [ %.2358.i, %B318.endif.endif.endif.en...endif.5.endif.endif.endif.i ]
  br i1 %.2366.not.i, label %B318.endif.endif.endif.en...else.endif.endif.i, label %B318.endif.endif.endif.en...else.endif.if.i, !prof !10

B318.endif.endif.endif.en...else.endif.if.i:      ; preds = %B318.endif.endif.endif.en...else.endif.i
  br label %B318.endif.endif.endif.en...else.endif.endif.i

B318.endif.endif.endif.en...else.endif.endif.i:   ; preds = %B318.endif.endif.endif.en...else.endif.if.i, %B318.endif.endif.endif.en...else.endif.i
  %.2504.sroa.0.3.i = phi i64 [ %arg.n_scratch, %B318.endif.endif.endif.en...else.endif.if.i ], [ %.2504.sroa.0.1.i, %B318.endif.endif.endif.en...else.endif.i ]
  %.2531.i = icmp slt i64 %.759.1.i, -1365
  %.2532.i = select i1 %.2531.i, i64 %arg.n_scratch, i64 0
  %.2533.i = add i64 %.2477.i, %.2532.i
  %.2536.i = icmp slt i64 %.2533.i, 0
  br i1 %.2536.i, label %B318.endif.endif.endif.en...else.endif.endif.if.i, label %B318.endif.endif.endif.en...else.endif.endif.endif.i, !prof !0

B318.endif.endif.endif.en...else.endif.endif.if.i: ; preds = %B318.endif.endif.endif.en...else.endif.endif.i
  br label %B318.endif.endif.endif.en...else.endif.endif.endif.i

B318.endif.endif.endif.en...else.endif.endif.endif.i: ; preds = %B318.endif.endif.endif.en...else.endif.endif.if.i, %B318.endif.endif.endif.en...else.endif.endif.i
  %.2504.sroa.13.1.i = phi i64 [ 0, %B318.endif.endif.endif.en...else.endif.endif.if.i ], [ %.2533.i, %B318.endif.endif.endif.en...else.endif.endif.i ]
  %.2541.not.i = icmp slt i64 %.2533.i, %arg.n_scratch
  br i1 %.2541.not.i, label %B318.endif.endif.endif.en...else.endif.endif.endif.endif.i, label %B318.endif.endif.endif.en...else.endif.endif.endif.if.i, !prof !10

B318.endif.endif.endif.en...else.endif.endif.endif.if.i: ; preds = %B318.endif.endif.endif.en...else.endif.endif.endif.i
  br label %B318.endif.endif.endif.en...else.endif.endif.endif.endif.i

B318.endif.endif.endif.en...else.endif.endif.endif.endif.i: ; preds = %B318.endif.endif.endif.en...else.endif.endif.endif.if.i, %B318.endif.endif.endif.en...else.endif.endif.endif.i
  %.2504.sroa.13.2.i = phi i64 [ %arg.n_scratch, %B318.endif.endif.endif.en...else.endif.endif.endif.if.i ], [ %.2504.sroa.13.1.i, %B318.endif.endif.endif.en...else.endif.endif.endif.i ]
  %.2592.i = sub i64 %.2504.sroa.13.2.i, %.2504.sroa.0.3.i
  %.2601.i = tail call i64 @llvm.smax.i64(i64 %.2592.i, i64 0)
  %.2617.i = getelementptr double, ptr %arg.scratch, i64 %.2504.sroa.0.3.i
  %.3029.i = shl nsw i64 %arg.times, 1
  %.3369.i = shl nsw i64 %arg.points, 1
  %.6979.i = mul nsw i64 %quot.2.0.i, %.904.i
  %.276586.i = icmp sgt i64 %arg.n_norms, 0
  br i1 %.276586.i, label %B890.preheader.i, label %_ZN17bnserve_inference6kernel7_source8contractB2v4B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5TupleI5ArrayIdLi1E1C7mutable7alignedExE5ArrayIdLi1E1C7mutable7alignedE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi3EE5TupleI5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi3EE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi4EE5TupleIxdE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi3EE5ArrayIdLi1E1C7mutable7alignedE.exit

B890.preheader.i:                                 ; preds = %B318.endif.endif.endif.en...else.endif.endif.endif.endif.i
  %60 = icmp sgt i64 %arg.times, 0
  %..3029.i = select i1 %60, i64 %.3029.i, i64 0
  %.10453.inv.i = icmp sgt i64 %quot.1.0.i, 0
  %61 = add nuw i64 %quot.1.0.i, 511
  %.10474.i = lshr i64 %61, 9
  %storemerge3206.i = select i1 %.10453.inv.i, i64 %.10474.i, i64 0
  %.arg.times.0.i = tail call i64 @llvm.smax.i64(i64 %arg.times, i64 0)
  %..759.1.i = tail call i64 @llvm.smax.i64(i64 %.759.1.i, i64 0)
  %62 = add nuw i64 %arg.n_f, 511
  %.3613.i = lshr i64 %62, 9
  %storemerge3204.i = select i1 %.951.i, i64 %.3613.i, i64 0
  %.3634339765.i = add nsw i64 %storemerge3204.i, -1
  %.4319331758.i = add nsw i64 %..759.1.i, -1
  %scevgep6.i.i = getelementptr i8, ptr %arg.linear_spline, i64 8
  %.7317328951.i = add nsw i64 %.arg.times.0.i, -1
  %.152.i.i = add nsw i64 %quot.2.0.i, -4
  %.10495359880.i = add nsw i64 %storemerge3206.i, -1
  %scevgep6.i235.i = getelementptr i8, ptr %arg.quadratic_spline, i64 8
  %63 = shl nuw i64 %..3029.i, 3
  %64 = shl i64 %.2329.sroa.0.3.i, 3
  %65 = getelementptr i8, ptr %arg.scratch, i64 %64
  %scevgep397.i = getelementptr i8, ptr %65, i64 24
  %scevgep406.i = getelementptr i8, ptr %arg.linear_spline, i64 24
  %66 = shl i64 %.2504.sroa.0.3.i, 3
  %67 = getelementptr i8, ptr %arg.scratch, i64 %66
  %scevgep416.i = getelementptr i8, ptr %67, i64 24
  %scevgep445.i = getelementptr i8, ptr %arg.spectrum, i64 8
  %68 = shl i64 %.1226.sroa.0.3.i, 3
  %69 = getelementptr i8, ptr %arg.scratch, i64 %68
  %scevgep473.i = getelementptr i8, ptr %69, i64 24
  %scevgep481.i = getelementptr i8, ptr %arg.quadratic, i64 24
  %70 = shl i64 %.1961.sroa.0.3.i, 3
  %71 = getelementptr i8, ptr %arg.scratch, i64 %70
  %scevgep490.i = getelementptr i8, ptr %71, i64 24
  %scevgep515.i = getelementptr i8, ptr %arg.quadratic_spline, i64 24
  %scevgep529.i = getelementptr i8, ptr %arg.quadratic, i64 8
  %72 = shl i64 %arg.n_linear, 3
  %73 = shl i64 %.1323.i, 3
  %74 = shl i64 %.1497.i, 3
  %75 = shl i64 %arg.n_quadratic, 3
  %.128.i.i = getelementptr i8, ptr %arg.sidereal, i64 8
  %.706618.not.i.i = icmp slt i64 %.1134.i, 3
  %76 = icmp sgt i64 %..3029.i, 0
  %77 = icmp eq i64 %storemerge3204.i, 0
  %78 = icmp eq i64 %storemerge3206.i, 0
  %.603.i.i = udiv i64 %.1143.i, 3
  %79 = icmp sgt i64 %.759.1.i, 0
  %80 = add i64 %73, 8
  %81 = add i64 %74, 8
  %82 = icmp sgt i64 %"$phi318.0.2.0.i", 0
  %83 = icmp sgt i64 %arg.n_spectrum, 0
  %84 = icmp slt i64 %.1314.i, 1
  %85 = icmp slt i64 %.1488.i, 1
  %86 = icmp slt i64 %.2417.i, 1
  %87 = icmp slt i64 %.2592.i, 1
  %88 = icmp slt i64 %.1681.i, 1
  %89 = icmp slt i64 %.1856.i, 1
  %90 = icmp eq i64 %quot.2.0.i, 1
  %91 = icmp slt i64 %.2049.i, 1
  %92 = icmp slt i64 %.2224.i, 1
  %sunkaddr102.i = getelementptr i8, ptr %arg.knots, i64 8
  %93 = add i64 %73, 16
  %94 = add i64 %73, 24
  br label %B890.i

B890.else.if.i:                                   ; preds = %B890.i
  br label %B890.else.endif.i

B890.else.endif.i:                                ; preds = %B890.else.if.i, %B890.i
  %.2837.sroa.0.1.i = phi i64 [ 0, %B890.else.if.i ], [ %.2849.i, %B890.i ]
  %.2857.not.i = icmp slt i64 %.2849.i, %arg.n_sky
  br i1 %.2857.not.i, label %B890.else.endif.endif.i, label %B890.else.endif.if.i, !prof !10

B890.else.endif.if.i:                             ; preds = %B890.else.endif.i
  br label %B890.else.endif.endif.i

B890.else.endif.endif.i:                          ; preds = %B890.else.endif.if.i, %B890.else.endif.i
  %.2837.sroa.0.3.i = phi i64 [ %arg.n_sky, %B890.else.endif.if.i ], [ %.2837.sroa.0.1.i, %B890.else.endif.i ]
  %.2950.i = getelementptr double, ptr %arg.sky, i64 %.2837.sroa.0.3.i
  %.100.i.i = load double, ptr %arg.sidereal, align 8, !noalias !11
  %.129.i.i = load double, ptr %.128.i.i, align 8, !noalias !11
  %.161.i.i = getelementptr i8, ptr %.2950.i, i64 24
  %.162.i.i = load double, ptr %.161.i.i, align 8, !noalias !11
  %.163.i.i = fmul contract double %.129.i.i, %.162.i.i
  %.164.i.i = fadd contract double %.100.i.i, %.163.i.i
  %.194.i1.i = load double, ptr %.2950.i, align 8, !noalias !11
  %.195.i2.i = fsub contract double %.164.i.i, %.194.i1.i
  %.197.i3.i = tail call contract double @llvm.fma.f64(double %.195.i2.i, double 0x3FE45F306DC9C883, double 0x4338000000000000)
  %.198.i4.i = fadd contract double %.197.i3.i, 0xC338000000000000
  %.213.i5.i = tail call contract double @llvm.fma.f64(double %.198.i4.i, double 0xBFF921FB54442D18, double %.195.i2.i)
  %.228.i.i = tail call contract double @llvm.fma.f64(double %.198.i4.i, double 0xBC91A62633145C07, double %.213.i5.i)
  %.229.i6.i = fmul contract double %.228.i.i, %.228.i.i
  %.230.i7.i = tail call contract double @llvm.fma.f64(double %.229.i6.i, double 0xBD6AE7F3E733B81F, double 0x3DE6124613A86D09)
  %.231.i8.i = tail call contract double @llvm.fma.f64(double %.229.i6.i, double %.230.i7.i, double 0xBE5AE64567F544E4)
  %.232.i9.i = tail call contract double @llvm.fma.f64(double %.229.i6.i, double %.231.i8.i, double 0x3EC71DE3A556C734)
  %.233.i10.i = tail call contract double @llvm.fma.f64(double %.229.i6.i, double %.232.i9.i, double 0xBF2A01A01A01A01A)
  %.234.i11.i = tail call contract double @llvm.fma.f64(double %.229.i6.i, double %.233.i10.i, double 0x3F81111111111111)
  %.235.i12.i = tail call contract double @llvm.fma.f64(double %.229.i6.i, double %.234.i11.i, double 0xBFC5555555555555)
  %.236.i13.i = fmul contract double %.228.i.i, %.229.i6.i
  %.237.i14.i = tail call contract double @llvm.fma.f64(double %.236.i13.i, double %.235.i12.i, double %.228.i.i)
  %.238.i15.i = tail call contract double @llvm.fma.f64(double %.229.i6.i, double 0x3D2AE7F3E733B81F, double 0xBDA93974A8C07C9D)
  %.239.i16.i = tail call contract double @llvm.fma.f64(double %.229.i6.i, double %.238.i15.i, double 0x3E21EED8EFF8D898)
  %.240.i.i = tail call contract double @llvm.fma.f64(double %.229.i6.i, double %.239.i16.i, double 0xBE927E4FB7789F5C)
  %.241.i.i = tail call contract double @llvm.fma.f64(double %.229.i6.i, double %.240.i.i, double 0x3EFA01A01A01A01A)
  %.242.i17.i = tail call contract double @llvm.fma.f64(double %.229.i6.i, double %.241.i.i, double 0xBF56C16C16C16C17)
  %.243.i18.i = tail call contract double @llvm.fma.f64(double %.229.i6.i, double %.242.i17.i, double 0x3FA5555555555555)
  %.244.i19.i = tail call contract double @llvm.fma.f64(double %.229.i6.i, double %.243.i18.i, double -5.000000e-01)
  %.245.i20.i = tail call contract double @llvm.fma.f64(double %.229.i6.i, double %.244.i19.i, double 1.000000e+00)
  %.246.i21.i = bitcast double %.197.i3.i to i64
  %.247.i22.i = bitcast double %.237.i14.i to i64
  %.248.i.i = bitcast double %.245.i20.i to i64
  %.249.i.i = xor i64 %.248.i.i, %.247.i22.i
  %.250.i.i = and i64 %.246.i21.i, 1
  %95 = icmp eq i64 %.250.i.i, 0
  %.252.i.i = select i1 %95, i64 0, i64 %.249.i.i
  %.253.i.i = shl i64 %.246.i21.i, 62
  %.254.i.i = and i64 %.253.i.i, -9223372036854775808
  %.256.i.i = add i64 %.253.i.i, 4611686018427387904
  %.257.i.i = and i64 %.256.i.i, -9223372036854775808
  %96 = xor i64 %.254.i.i, %.247.i22.i
  %.259.i.i = xor i64 %96, %.252.i.i
  %.260.i.i = bitcast i64 %.259.i.i to double
  %97 = xor i64 %.257.i.i, %.248.i.i
  %.262.i.i = xor i64 %97, %.252.i.i
  %.263.i.i = bitcast i64 %.262.i.i to double
  %.313.i23.i = getelementptr i8, ptr %.2950.i, i64 8
  %.314.i24.i = load double, ptr %.313.i23.i, align 8, !noalias !11
  %.315.i25.i = tail call contract double @llvm.fma.f64(double %.314.i24.i, double 0x3FE45F306DC9C883, double 0x4338000000000000)
  %.316.i26.i = fadd contract double %.315.i25.i, 0xC338000000000000
  %.331.i27.i = tail call contract double @llvm.fma.f64(double %.316.i26.i, double 0xBFF921FB54442D18, double %.314.i24.i)
  %.346.i.i = tail call contract double @llvm.fma.f64(double %.316.i26.i, double 0xBC91A62633145C07, double %.331.i27.i)
  %.347.i28.i = fmul contract double %.346.i.i, %.346.i.i
  %.348.i.i = tail call contract double @llvm.fma.f64(double %.347.i28.i, double 0xBD6AE7F3E733B81F, double 0x3DE6124613A86D09)
  %.349.i29.i = tail call contract double @llvm.fma.f64(double %.347.i28.i, double %.348.i.i, double 0xBE5AE64567F544E4)
  %.350.i30.i = tail call contract double @llvm.fma.f64(double %.347.i28.i, double %.349.i29.i, double 0x3EC71DE3A556C734)
  %.351.i31.i = tail call contract double @llvm.fma.f64(double %.347.i28.i, double %.350.i30.i, double 0xBF2A01A01A01A01A)
  %.352.i32.i = tail call contract double @llvm.fma.f64(double %.347.i28.i, double %.351.i31.i, double 0x3F81111111111111)
  %.353.i.i = tail call contract double @llvm.fma.f64(double %.347.i28.i, double %.352.i32.i, double 0xBFC5555555555555)
  %.354.i.i = fmul contract double %.346.i.i, %.347.i28.i
  %.355.i.i = tail call contract double @llvm.fma.f64(double %.354.i.i, double %.353.i.i, double %.346.i.i)
  %.356.i.i = tail call contract double @llvm.fma.f64(double %.347.i28.i, double 0x3D2AE7F3E733B81F, double 0xBDA93974A8C07C9D)
  %.357.i.i = tail call contract double @llvm.fma.f64(double %.347.i28.i, double %.356.i.i, double 0x3E21EED8EFF8D898)
  %.358.i.i = tail call contract double @llvm.fma.f64(double %.347.i28.i, double %.357.i.i, double 0xBE927E4FB7789F5C)
  %.359.i.i = tail call contract double @llvm.fma.f64(double %.347.i28.i, double %.358.i.i, double 0x3EFA01A01A01A01A)
  %.360.i.i = tail call contract double @llvm.fma.f64(double %.347.i28.i, double %.359.i.i, double 0xBF56C16C16C16C17)
  %.361.i.i = tail call contract double @llvm.fma.f64(double %.347.i28.i, double %.360.i.i, double 0x3FA5555555555555)
  %.362.i.i = tail call contract double @llvm.fma.f64(double %.347.i28.i, double %.361.i.i, double -5.000000e-01)
  %.363.i.i = tail call contract double @llvm.fma.f64(double %.347.i28.i, double %.362.i.i, double 1.000000e+00)
  %.364.i.i = bitcast double %.315.i25.i to i64
  %.365.i.i = bitcast double %.355.i.i to i64
  %.366.i.i = bitcast double %.363.i.i to i64
  %.367.i.i = xor i64 %.366.i.i, %.365.i.i
  %.368.i.i = and i64 %.364.i.i, 1
  %98 = icmp eq i64 %.368.i.i, 0
  %.370.i.i = select i1 %98, i64 0, i64 %.367.i.i
  %.371.i.i = shl i64 %.364.i.i, 62
  %.372.i.i = and i64 %.371.i.i, -9223372036854775808
  %.374.i.i = add i64 %.371.i.i, 4611686018427387904
  %.375.i.i = and i64 %.374.i.i, -9223372036854775808
  %99 = xor i64 %.372.i.i, %.365.i.i
  %.377.i.i = xor i64 %99, %.370.i.i
  %.378.i.i = bitcast i64 %.377.i.i to double
  %100 = xor i64 %.375.i.i, %.366.i.i
  %.380.i.i = xor i64 %100, %.370.i.i
  %.381.i.i = bitcast i64 %.380.i.i to double
  %.434.i.i = getelementptr i8, ptr %.2950.i, i64 16
  %.435.i.i = load double, ptr %.434.i.i, align 8, !noalias !11
  %.436.i.i = tail call contract double @llvm.fma.f64(double %.435.i.i, double 0x3FE45F306DC9C883, double 0x4338000000000000)
  %.437.i.i = fadd contract double %.436.i.i, 0xC338000000000000
  %.452.i33.i = tail call contract double @llvm.fma.f64(double %.437.i.i, double 0xBFF921FB54442D18, double %.435.i.i)
  %.467.i.i = tail call contract double @llvm.fma.f64(double %.437.i.i, double 0xBC91A62633145C07, double %.452.i33.i)
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
  %.482.i34.i = tail call contract double @llvm.fma.f64(double %.468.i.i, double %.481.i.i, double 0x3FA5555555555555)
  %.483.i35.i = tail call contract double @llvm.fma.f64(double %.468.i.i, double %.482.i34.i, double -5.000000e-01)
  %.484.i.i = tail call contract double @llvm.fma.f64(double %.468.i.i, double %.483.i35.i, double 1.000000e+00)
  %.485.i.i = bitcast double %.436.i.i to i64
  %.486.i.i = bitcast double %.476.i.i to i64
  %.487.i36.i = bitcast double %.484.i.i to i64
  %.488.i.i = xor i64 %.487.i36.i, %.486.i.i
  %.489.i37.i = and i64 %.485.i.i, 1
  %101 = icmp eq i64 %.489.i37.i, 0
  %.491.i.i = select i1 %101, i64 0, i64 %.488.i.i
  %.492.i.i = shl i64 %.485.i.i, 62
  %.493.i.i = and i64 %.492.i.i, -9223372036854775808
  %.495.i.i = add i64 %.492.i.i, 4611686018427387904
  %.496.i.i = and i64 %.495.i.i, -9223372036854775808
  %102 = xor i64 %.493.i.i, %.486.i.i
  %.498.i38.i = xor i64 %102, %.491.i.i
  %.499.i.i = bitcast i64 %.498.i38.i to double
  %103 = xor i64 %.496.i.i, %.487.i36.i
  %.501.i.i = xor i64 %103, %.491.i.i
  %.502.i.i = bitcast i64 %.501.i.i to double
  %.523.i.i = fneg contract double %.502.i.i
  %.524.i.i = fmul contract double %.523.i.i, %.260.i.i
  %.525.i.i = fmul contract double %.499.i.i, %.263.i.i
  %.527.i.i = fmul contract double %.525.i.i, %.378.i.i
  %.528.i.i = fsub contract double %.524.i.i, %.527.i.i
  %.534.i.i = fmul contract double %.499.i.i, %.260.i.i
  %.536.i.i = fmul contract double %.534.i.i, %.378.i.i
  %104 = fmul contract double %.502.i.i, %.263.i.i
  %.537.i.i = fsub contract double %.536.i.i, %104
  %.541.i.i = fmul contract double %.381.i.i, %.499.i.i
  %.548.i.i = fmul contract double %104, %.378.i.i
  %.549.i.i = fsub contract double %.534.i.i, %.548.i.i
  %.554.i.i = fmul contract double %.502.i.i, %.260.i.i
  %.556.i.i = fmul contract double %.554.i.i, %.378.i.i
  %.557.i.i = fadd contract double %.525.i.i, %.556.i.i
  %.561.i.i = fmul contract double %.381.i.i, %.502.i.i
  %.565.i39.i = fmul contract double %.381.i.i, %.263.i.i
  %.569.i.i = fneg contract double %.381.i.i
  %.570.i.i = fmul contract double %.569.i.i, %.260.i.i
  br i1 %.706618.not.i.i, label %_ZN17bnserve_inference6kernel7_source9_geometryB2v5B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i, label %B462.if.preheader.i.i

B462.if.preheader.i.i:                            ; preds = %B890.else.endif.endif.i
  %sunkaddr9.i.i = getelementptr i8, ptr %.2950.i, i64 32
  %sunkaddr11.i.i = getelementptr i8, ptr %.2950.i, i64 40
  %sunkaddr13.i.i = getelementptr i8, ptr %.2950.i, i64 48
  br label %B462.if.i.i

B462.if.i.i:                                      ; preds = %B466.endif.else.endif.endif.i.i, %B462.if.preheader.i.i
  %lsr.iv8.i.i = phi i64 [ %lsr.iv.next9.i.i, %B466.endif.else.endif.endif.i.i ], [ %.603.i.i, %B462.if.preheader.i.i ]
  %lsr.iv6.i.i = phi i64 [ %lsr.iv.next7.i.i, %B466.endif.else.endif.endif.i.i ], [ 0, %B462.if.preheader.i.i ]
  %lsr.iv.i40.i = phi i64 [ %lsr.iv.next.i41.i, %B466.endif.else.endif.endif.i.i ], [ 0, %B462.if.preheader.i.i ]
  %.793.not.i.i = icmp slt i64 %lsr.iv6.i.i, %arg.n_responses
  br i1 %.793.not.i.i, label %B466.else.endif.endif.i.i, label %B466.else.endif.if.i.i, !prof !10

B466.else.endif.if.i.i:                           ; preds = %B462.if.i.i
  br label %B466.else.endif.endif.i.i

B466.else.endif.endif.i.i:                        ; preds = %B466.else.endif.if.i.i, %B462.if.i.i
  %.773.sroa.0.3.i.i = phi i64 [ %arg.n_responses, %B466.else.endif.if.i.i ], [ %lsr.iv6.i.i, %B462.if.i.i ]
  %.886.i.i = getelementptr double, ptr %arg.responses, i64 %.773.sroa.0.3.i.i
  %.946.i.i = load double, ptr %.886.i.i, align 8, !noalias !11
  %.948.i.i = fmul contract double %.528.i.i, %.946.i.i
  %.976.i.i = getelementptr i8, ptr %.886.i.i, i64 8
  %.977.i.i = load double, ptr %.976.i.i, align 8, !noalias !11
  %.979.i.i = fmul contract double %.537.i.i, %.977.i.i
  %.980.i.i = fadd contract double %.948.i.i, %.979.i.i
  %.1008.i.i = getelementptr i8, ptr %.886.i.i, i64 16
  %.1009.i.i = load double, ptr %.1008.i.i, align 8, !noalias !11
  %.1011.i.i = fmul contract double %.541.i.i, %.1009.i.i
  %.1012.i.i = fadd contract double %.980.i.i, %.1011.i.i
  %.1040.i.i = getelementptr i8, ptr %.886.i.i, i64 24
  %.1041.i.i = load double, ptr %.1040.i.i, align 8, !noalias !11
  %.1043.i.i = fmul contract double %.528.i.i, %.1041.i.i
  %.1071.i.i = getelementptr i8, ptr %.886.i.i, i64 32
  %.1072.i.i = load double, ptr %.1071.i.i, align 8, !noalias !11
  %.1074.i.i = fmul contract double %.537.i.i, %.1072.i.i
  %.1075.i.i = fadd contract double %.1043.i.i, %.1074.i.i
  %.1103.i.i = getelementptr i8, ptr %.886.i.i, i64 40
  %.1104.i.i = load double, ptr %.1103.i.i, align 8, !noalias !11
  %.1106.i.i = fmul contract double %.541.i.i, %.1104.i.i
  %.1107.i.i = fadd contract double %.1075.i.i, %.1106.i.i
  %.1135.i.i = getelementptr i8, ptr %.886.i.i, i64 48
  %.1136.i.i = load double, ptr %.1135.i.i, align 8, !noalias !11
  %.1138.i.i = fmul contract double %.528.i.i, %.1136.i.i
  %.1166.i.i = getelementptr i8, ptr %.886.i.i, i64 56
  %.1167.i.i = load double, ptr %.1166.i.i, align 8, !noalias !11
  %.1169.i.i = fmul contract double %.537.i.i, %.1167.i.i
  %.1170.i.i = fadd contract double %.1138.i.i, %.1169.i.i
  %.1198.i.i = getelementptr i8, ptr %.886.i.i, i64 64
  %.1199.i.i = load double, ptr %.1198.i.i, align 8, !noalias !11
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
  %.1574.not.i.i = icmp slt i64 %lsr.iv.i40.i, %arg.n_locations
  br i1 %.1574.not.i.i, label %B466.endif.else.endif.endif.i.i, label %B466.endif.else.endif.if.i.i, !prof !10

B466.endif.else.endif.if.i.i:                     ; preds = %B466.else.endif.endif.i.i
  br label %B466.endif.else.endif.endif.i.i

B466.endif.else.endif.endif.i.i:                  ; preds = %B466.endif.else.endif.if.i.i, %B466.else.endif.endif.i.i
  %.1554.sroa.0.3.i.i = phi i64 [ %arg.n_locations, %B466.endif.else.endif.if.i.i ], [ %lsr.iv.i40.i, %B466.else.endif.endif.i.i ]
  %.1667.i.i = getelementptr double, ptr %arg.locations, i64 %.1554.sroa.0.3.i.i
  %.1728.i.i = load double, ptr %sunkaddr9.i.i, align 8, !noalias !11
  %.1729.i.i = fmul contract double %.1507.i.i, %.1728.i.i
  %.1759.i.i = load double, ptr %sunkaddr11.i.i, align 8, !noalias !11
  %.1760.i.i = fmul contract double %.1524.i.i, %.1759.i.i
  %.1761.i.i = fadd contract double %.1729.i.i, %.1760.i.i
  %sunkaddr.i.i = shl i64 %lsr.iv.i40.i, 3
  %sunkaddr12.i.i = getelementptr i8, ptr %.1159.i, i64 %sunkaddr.i.i
  store double %.1761.i.i, ptr %sunkaddr12.i.i, align 8, !noalias !11
  %.1822.i.i = load double, ptr %sunkaddr13.i.i, align 8, !noalias !11
  %.1823.i.i = fmul contract double %.1524.i.i, %.1822.i.i
  %sunkaddr16.i.i = getelementptr i8, ptr %sunkaddr12.i.i, i64 8
  store double %.1823.i.i, ptr %sunkaddr16.i.i, align 8, !noalias !11
  %.1884.i.i = load double, ptr %.1667.i.i, align 8, !noalias !11
  %.1886.i.i = fmul contract double %.565.i39.i, %.1884.i.i
  %.1914.i.i = getelementptr i8, ptr %.1667.i.i, i64 8
  %.1915.i.i = load double, ptr %.1914.i.i, align 8, !noalias !11
  %.1917.i.i = fmul contract double %.570.i.i, %.1915.i.i
  %.1918.i.i = fadd contract double %.1886.i.i, %.1917.i.i
  %.1946.i.i = getelementptr i8, ptr %.1667.i.i, i64 16
  %.1947.i.i = load double, ptr %.1946.i.i, align 8, !noalias !11
  %.1952.i.i = fmul contract double %.1947.i.i, %.378.i.i
  %.1953.i.i = fadd contract double %.1918.i.i, %.1952.i.i
  %.1958.i.i = fdiv contract double %.1953.i.i, 0xC1B1DE784A000000
  %sunkaddr19.i.i = getelementptr i8, ptr %sunkaddr12.i.i, i64 16
  store double %.1958.i.i, ptr %sunkaddr19.i.i, align 8, !noalias !11
  %lsr.iv.next.i41.i = add nuw nsw i64 %lsr.iv.i40.i, 3
  %lsr.iv.next7.i.i = add nuw i64 %lsr.iv6.i.i, 9
  %lsr.iv.next9.i.i = add nsw i64 %lsr.iv8.i.i, -1
  %exitcond.not.i42.i = icmp eq i64 %lsr.iv.next9.i.i, 0
  br i1 %exitcond.not.i42.i, label %_ZN17bnserve_inference6kernel7_source9_geometryB2v5B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i, label %B462.if.i.i

_ZN17bnserve_inference6kernel7_source9_geometryB2v5B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i: ; preds = %B466.endif.else.endif.endif.i.i, %B890.else.endif.endif.i
  %.3031.i = mul nsw i64 %.2755.sroa.0.091.i, %.3029.i
  %.3036.i = mul nsw i64 %.2809.i, %.3029.i
  %.3073.i = icmp slt i64 %.3031.i, 0
  %.3074.i = select i1 %.3073.i, i64 %arg.n_products, i64 0
  %.3075.i = add i64 %.3074.i, %.3031.i
  %.3078.i = icmp slt i64 %.3075.i, 0
  br i1 %.3078.i, label %B890.endif.endif.else.if.i, label %B890.endif.endif.else.endif.i, !prof !0

B890.endif.endif.else.if.i:                       ; preds = %_ZN17bnserve_inference6kernel7_source9_geometryB2v5B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i
  br label %B890.endif.endif.else.endif.i

B890.endif.endif.else.endif.i:                    ; preds = %B890.endif.endif.else.if.i, %_ZN17bnserve_inference6kernel7_source9_geometryB2v5B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i
  %.3063.sroa.0.1.i = phi i64 [ 0, %B890.endif.endif.else.if.i ], [ %.3075.i, %_ZN17bnserve_inference6kernel7_source9_geometryB2v5B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i ]
  %.3083.not.i = icmp slt i64 %.3075.i, %arg.n_products
  br i1 %.3083.not.i, label %B890.endif.endif.else.endif.endif.i, label %B890.endif.endif.else.endif.if.i, !prof !10

B890.endif.endif.else.endif.if.i:                 ; preds = %B890.endif.endif.else.endif.i
  br label %B890.endif.endif.else.endif.endif.i

B890.endif.endif.else.endif.endif.i:              ; preds = %B890.endif.endif.else.endif.if.i, %B890.endif.endif.else.endif.i
  %.3063.sroa.0.3.i = phi i64 [ %arg.n_products, %B890.endif.endif.else.endif.if.i ], [ %.3063.sroa.0.1.i, %B890.endif.endif.else.endif.i ]
  %.3090.i = icmp slt i64 %.3036.i, 0
  %.3091.i = select i1 %.3090.i, i64 %arg.n_products, i64 0
  %.3092.i = add i64 %.3091.i, %.3036.i
  %.3095.i = icmp slt i64 %.3092.i, 0
  br i1 %.3095.i, label %B890.endif.endif.else.endif.endif.if.i, label %B890.endif.endif.else.endif.endif.endif.i, !prof !0

B890.endif.endif.else.endif.endif.if.i:           ; preds = %B890.endif.endif.else.endif.endif.i
  br label %B890.endif.endif.else.endif.endif.endif.i

B890.endif.endif.else.endif.endif.endif.i:        ; preds = %B890.endif.endif.else.endif.endif.if.i, %B890.endif.endif.else.endif.endif.i
  %.3063.sroa.13.1.i = phi i64 [ 0, %B890.endif.endif.else.endif.endif.if.i ], [ %.3092.i, %B890.endif.endif.else.endif.endif.i ]
  %.3100.not.i = icmp slt i64 %.3092.i, %arg.n_products
  br i1 %.3100.not.i, label %B890.endif.endif.else.endif.endif.endif.endif.i, label %B890.endif.endif.else.endif.endif.endif.if.i, !prof !10

B890.endif.endif.else.endif.endif.endif.if.i:     ; preds = %B890.endif.endif.else.endif.endif.endif.i
  br label %B890.endif.endif.else.endif.endif.endif.endif.i

B890.endif.endif.else.endif.endif.endif.endif.i:  ; preds = %B890.endif.endif.else.endif.endif.endif.if.i, %B890.endif.endif.else.endif.endif.endif.i
  %.3063.sroa.13.2.i = phi i64 [ %arg.n_products, %B890.endif.endif.else.endif.endif.endif.if.i ], [ %.3063.sroa.13.1.i, %B890.endif.endif.else.endif.endif.endif.i ]
  %.3151.i = sub i64 %.3063.sroa.13.2.i, %.3063.sroa.0.3.i
  %.3160.i = tail call i64 @llvm.smax.i64(i64 %.3151.i, i64 0)
  %.3176.i = getelementptr double, ptr %arg.products, i64 %.3063.sroa.0.3.i
  br i1 %76, label %B1074.if.preheader.i, label %B1090.i

B1074.if.preheader.i:                             ; preds = %B890.endif.endif.else.endif.endif.endif.endif.i
  tail call void @llvm.memset.p0.i64(ptr align 8 %.3176.i, i8 0, i64 %63, i1 false), !noalias !1
  br label %B1090.i

B1090.else.if.i:                                  ; preds = %B1090.i
  br label %B1090.else.endif.i

B1090.else.endif.i:                               ; preds = %B1090.else.if.i, %B1090.i
  %.3403.sroa.0.1.i = phi i64 [ 0, %B1090.else.if.i ], [ %.3415.i, %B1090.i ]
  %.3423.not.i = icmp slt i64 %.3415.i, %arg.n_h
  br i1 %.3423.not.i, label %B1090.else.endif.endif.i, label %B1090.else.endif.if.i, !prof !10

B1090.else.endif.if.i:                            ; preds = %B1090.else.endif.i
  br label %B1090.else.endif.endif.i

B1090.else.endif.endif.i:                         ; preds = %B1090.else.endif.if.i, %B1090.else.endif.i
  %.3403.sroa.0.3.i = phi i64 [ %arg.n_h, %B1090.else.endif.if.i ], [ %.3403.sroa.0.1.i, %B1090.else.endif.i ]
  %.3430.i = icmp slt i64 %.3376.i, 0
  %.3431.i = select i1 %.3430.i, i64 %arg.n_h, i64 0
  %.3432.i = add i64 %.3431.i, %.3376.i
  %.3435.i = icmp slt i64 %.3432.i, 0
  br i1 %.3435.i, label %B1090.else.endif.endif.if.i, label %B1090.else.endif.endif.endif.i, !prof !0

B1090.else.endif.endif.if.i:                      ; preds = %B1090.else.endif.endif.i
  br label %B1090.else.endif.endif.endif.i

B1090.else.endif.endif.endif.i:                   ; preds = %B1090.else.endif.endif.if.i, %B1090.else.endif.endif.i
  %.3403.sroa.13.1.i = phi i64 [ 0, %B1090.else.endif.endif.if.i ], [ %.3432.i, %B1090.else.endif.endif.i ]
  %.3440.not.i = icmp slt i64 %.3432.i, %arg.n_h
  br i1 %.3440.not.i, label %B1090.else.endif.endif.endif.endif.i, label %B1090.else.endif.endif.endif.if.i, !prof !10

B1090.else.endif.endif.endif.if.i:                ; preds = %B1090.else.endif.endif.endif.i
  br label %B1090.else.endif.endif.endif.endif.i

B1090.else.endif.endif.endif.endif.i:             ; preds = %B1090.else.endif.endif.endif.if.i, %B1090.else.endif.endif.endif.i
  %.3403.sroa.13.2.i = phi i64 [ %arg.n_h, %B1090.else.endif.endif.endif.if.i ], [ %.3403.sroa.13.1.i, %B1090.else.endif.endif.endif.i ]
  %.3491.i = sub i64 %.3403.sroa.13.2.i, %.3403.sroa.0.3.i
  %.3500.i = tail call i64 @llvm.smax.i64(i64 %.3491.i, i64 0)
  %.3516.i = getelementptr double, ptr %arg.h, i64 %.3403.sroa.0.3.i
  %.4366.i = mul nsw i64 %.2755.sroa.0.091.i, %.759.1.i
  %.9649.i = mul nsw i64 %.2755.sroa.0.091.i, %arg.n_linear
  br i1 %77, label %B3028.i, label %B1188.i

B1306.if.i:                                       ; preds = %B1306.if.i, %B1306.if.preheader.i
  %.383132763278.i = phi i64 [ %.3838.i, %B1306.if.i ], [ 0, %B1306.if.preheader.i ]
  %.3838.i = add nuw nsw i64 %.383132763278.i, 1
  %105 = add i64 %.383132763278.i, %.3625.sroa.0.068.i
  %.3878.i = icmp slt i64 %105, 0
  %106 = select i1 %.3878.i, i64 %72, i64 0
  %scevgep385.i = getelementptr i8, ptr %scevgep384.i, i64 %106
  %107 = shl nuw nsw i64 %.383132763278.i, 3
  %scevgep22.i = getelementptr i8, ptr %scevgep385.i, i64 %107
  %.3894.i = load i64, ptr %scevgep22.i, align 8, !noalias !1
  %.3909.i = icmp slt i64 %.3894.i, 0
  %.3910.i = select i1 %.3909.i, i64 %.3500.i, i64 0
  %.idx.i = shl i64 %.3894.i, 4
  %108 = getelementptr i8, ptr %.3516.i, i64 %.idx.i
  %.3924.i = getelementptr double, ptr %108, i64 %.3910.i
  %.3925.i = load double, ptr %.3924.i, align 8, !noalias !1
  %scevgep21.i = getelementptr i8, ptr %.1339.i, i64 %107
  store double %.3925.i, ptr %scevgep21.i, align 8, !noalias !1
  %.3987.i = load i64, ptr %scevgep22.i, align 8, !noalias !1
  %.4003.i = icmp slt i64 %.3987.i, 0
  %.4004.i = select i1 %.4003.i, i64 %.3500.i, i64 0
  %.idx3218.i = shl i64 %.3987.i, 4
  %109 = getelementptr i8, ptr %.3516.i, i64 %.idx3218.i
  %110 = getelementptr i8, ptr %109, i64 8
  %.4018.i = getelementptr double, ptr %110, i64 %.4004.i
  %.4019.i = load double, ptr %.4018.i, align 8, !noalias !1
  %scevgep20.i = getelementptr i8, ptr %.1513.i, i64 %107
  store double %.4019.i, ptr %scevgep20.i, align 8, !noalias !1
  %exitcond3984.not.i = icmp eq i64 %.13.i98.i, %.3838.i
  br i1 %exitcond3984.not.i, label %B1410.i, label %B1306.if.i

B1442.if.i:                                       ; preds = %B1442.if.i, %B1442.if.preheader381.i
  %lsr.iv.i = phi i64 [ %4, %B1442.if.preheader381.i ], [ %lsr.iv.next.i, %B1442.if.i ]
  %.414232833285.i = phi i64 [ %.414232833285.unr.i, %B1442.if.preheader381.i ], [ %117, %B1442.if.i ]
  %.4187.i = icmp slt i64 %.414232833285.i, 0
  %111 = select i1 %.4187.i, i64 %73, i64 0
  %scevgep389.i = getelementptr i8, ptr %.1339.i, i64 %111
  %112 = shl i64 %.414232833285.i, 3
  %scevgep390.i = getelementptr i8, ptr %scevgep389.i, i64 %112
  store double 0.000000e+00, ptr %scevgep390.i, align 8, !noalias !1
  %113 = select i1 %.4187.i, i64 %74, i64 0
  %scevgep387.i = getelementptr i8, ptr %.1513.i, i64 %113
  %scevgep388.i = getelementptr i8, ptr %scevgep387.i, i64 %112
  store double 0.000000e+00, ptr %scevgep388.i, align 8, !noalias !1
  %114 = add i64 %.414232833285.i, 1
  %.4187.1.i = icmp slt i64 %114, 0
  %115 = select i1 %.4187.1.i, i64 %80, i64 8
  %scevgep24.i = getelementptr i8, ptr %.1339.i, i64 %115
  %scevgep25.i = getelementptr i8, ptr %scevgep24.i, i64 %112
  store double 0.000000e+00, ptr %scevgep25.i, align 8, !noalias !1
  %116 = select i1 %.4187.1.i, i64 %81, i64 8
  %scevgep.i = getelementptr i8, ptr %.1513.i, i64 %116
  %scevgep23.i = getelementptr i8, ptr %scevgep.i, i64 %112
  store double 0.000000e+00, ptr %scevgep23.i, align 8, !noalias !1
  %lsr.iv.next.i = add i64 %lsr.iv.i, -2
  %.4136.1.i = icmp sgt i64 %lsr.iv.next.i, 2
  %117 = add i64 %.414232833285.i, 2
  br i1 %.4136.1.i, label %B1442.if.i, label %B1468.i

B1516.else.if.i:                                  ; preds = %B1516.i
  br label %B1516.else.endif.i

B1516.else.endif.i:                               ; preds = %B1516.else.if.i, %B1516.i
  %.4400.sroa.0.1.i = phi i64 [ 0, %B1516.else.if.i ], [ %.4412.i, %B1516.i ]
  %.4420.not.i = icmp slt i64 %.4412.i, %arg.n_amplitude
  br i1 %.4420.not.i, label %B1516.else.endif.endif.i, label %B1516.else.endif.if.i, !prof !10

B1516.else.endif.if.i:                            ; preds = %B1516.else.endif.i
  br label %B1516.else.endif.endif.i

B1516.else.endif.endif.i:                         ; preds = %B1516.else.endif.if.i, %B1516.else.endif.i
  %.4400.sroa.0.3.i = phi i64 [ %arg.n_amplitude, %B1516.else.endif.if.i ], [ %.4400.sroa.0.1.i, %B1516.else.endif.i ]
  %.4427.i = icmp slt i64 %.4373.i, 0
  %.4428.i = select i1 %.4427.i, i64 %arg.n_amplitude, i64 0
  %.4429.i = add i64 %.4428.i, %.4373.i
  %.4432.i = icmp slt i64 %.4429.i, 0
  br i1 %.4432.i, label %B1516.else.endif.endif.if.i, label %B1516.else.endif.endif.endif.i, !prof !0

B1516.else.endif.endif.if.i:                      ; preds = %B1516.else.endif.endif.i
  br label %B1516.else.endif.endif.endif.i

B1516.else.endif.endif.endif.i:                   ; preds = %B1516.else.endif.endif.if.i, %B1516.else.endif.endif.i
  %.4400.sroa.13.1.i = phi i64 [ 0, %B1516.else.endif.endif.if.i ], [ %.4429.i, %B1516.else.endif.endif.i ]
  %.4437.not.i = icmp slt i64 %.4429.i, %arg.n_amplitude
  br i1 %.4437.not.i, label %B1516.else.endif.endif.endif.endif.i, label %B1516.else.endif.endif.endif.if.i, !prof !10

B1516.else.endif.endif.endif.if.i:                ; preds = %B1516.else.endif.endif.endif.i
  br label %B1516.else.endif.endif.endif.endif.i

B1516.else.endif.endif.endif.endif.i:             ; preds = %B1516.else.endif.endif.endif.if.i, %B1516.else.endif.endif.endif.i
  %.4400.sroa.13.2.i = phi i64 [ %arg.n_amplitude, %B1516.else.endif.endif.endif.if.i ], [ %.4400.sroa.13.1.i, %B1516.else.endif.endif.endif.i ]
  %.4488.i = sub i64 %.4400.sroa.13.2.i, %.4400.sroa.0.3.i
  %.4513.i = getelementptr double, ptr %arg.amplitude, i64 %.4400.sroa.0.3.i
  br i1 %86, label %B1516.endif.else.endif.if.i, label %B1516.endif.else.endif.endif.i, !prof !0

B1516.endif.else.endif.if.i:                      ; preds = %B1516.else.endif.endif.endif.endif.i
  br label %B1516.endif.else.endif.endif.i

B1516.endif.else.endif.endif.i:                   ; preds = %B1516.endif.else.endif.if.i, %B1516.else.endif.endif.endif.endif.i
  %.4572.sroa.0.3.i = phi i64 [ %.2426.i, %B1516.endif.else.endif.if.i ], [ 0, %B1516.else.endif.endif.endif.endif.i ]
  br i1 %8, label %B1516.endif.else.endif.endif.if.i, label %B1516.endif.else.endif.endif.endif.i, !prof !0

B1516.endif.else.endif.endif.if.i:                ; preds = %B1516.endif.else.endif.endif.i
  br label %B1516.endif.else.endif.endif.endif.i

B1516.endif.else.endif.endif.endif.i:             ; preds = %B1516.endif.else.endif.endif.if.i, %B1516.endif.else.endif.endif.i
  %.4572.sroa.13.1.i = phi i64 [ 0, %B1516.endif.else.endif.endif.if.i ], [ %.4601.i, %B1516.endif.else.endif.endif.i ]
  br i1 %9, label %B1516.endif.else.endif.endif.endif.endif.i, label %B1516.endif.else.endif.endif.endif.if.i, !prof !10

B1516.endif.else.endif.endif.endif.if.i:          ; preds = %B1516.endif.else.endif.endif.endif.i
  br label %B1516.endif.else.endif.endif.endif.endif.i

B1516.endif.else.endif.endif.endif.endif.i:       ; preds = %B1516.endif.else.endif.endif.endif.if.i, %B1516.endif.else.endif.endif.endif.i
  %.4572.sroa.13.2.i = phi i64 [ %.2426.i, %B1516.endif.else.endif.endif.endif.if.i ], [ %.4572.sroa.13.1.i, %B1516.endif.else.endif.endif.endif.i ]
  %.4660.i = sub nsw i64 %.4572.sroa.13.2.i, %.4572.sroa.0.3.i
  %.4669.i = tail call i64 @llvm.smax.i64(i64 %.4660.i, i64 0)
  %.4685.i = getelementptr double, ptr %.2442.i, i64 %.4572.sroa.0.3.i
  %.104.i.not.i = icmp slt i64 %.4660.i, 1
  br i1 %.104.i.not.i, label %B76.i.i, label %B60.if.preheader.i.i

B60.if.preheader.i.i:                             ; preds = %B1516.endif.else.endif.endif.endif.endif.i
  %118 = shl nuw i64 %.4669.i, 3
  tail call void @llvm.memset.p0.i64(ptr align 8 %.4685.i, i8 0, i64 %118, i1 false), !noalias !14
  br label %B76.i.i

B76.i.i:                                          ; preds = %B60.if.preheader.i.i, %B1516.endif.else.endif.endif.endif.endif.i
  %.311284.not.i.i = icmp slt i64 %.4488.i, 1
  br i1 %.311284.not.i.i, label %B1516.endif.endif.endif.i, label %B128.if.lr.ph.i.i

B128.if.lr.ph.i.i:                                ; preds = %B76.i.i
  %119 = add nsw i64 %.4669.i, -2
  %120 = lshr i64 %119, 1
  %121 = add nuw i64 %120, 1
  %122 = shl i64 %.4572.sroa.0.3.i, 3
  %scevgep398.i = getelementptr i8, ptr %scevgep397.i, i64 %122
  %123 = lshr i64 %121, 1
  %124 = mul nsw i64 %123, -2
  %125 = icmp eq i64 %.4660.i, 1
  %126 = icmp eq i64 %120, 0
  %127 = and i64 %119, 2
  %128 = icmp eq i64 %127, 0
  %129 = and i64 %.4669.i, 1
  %130 = icmp eq i64 %129, 0
  br label %B128.if.i.i

B284.loopexit.unr-lcssa.i.unr-lcssa.i:            ; preds = %B228.if.i.i
  br i1 %128, label %B228.if.i.epil.preheader.i, label %B284.loopexit.unr-lcssa.i.i

B228.if.i.epil.preheader.i:                       ; preds = %B228.if.preheader2.i.i, %B284.loopexit.unr-lcssa.i.unr-lcssa.i
  %.655272274.i.epil.init.i = phi i64 [ 0, %B228.if.preheader2.i.i ], [ %.662.1.i.1.i, %B284.loopexit.unr-lcssa.i.unr-lcssa.i ]
  %131 = shl i64 %.655272274.i.epil.init.i, 3
  %sunkaddr11.i.epil.i = getelementptr i8, ptr %.4685.i, i64 %131
  %.716.i.epil.i = load double, ptr %sunkaddr11.i.epil.i, align 8, !noalias !14
  %scevgep9.i.epil.i = getelementptr i8, ptr %scevgep7.i.i, i64 %131
  %scevgep10.i.epil.i = getelementptr i8, ptr %scevgep9.i.epil.i, i64 -8
  %.746.i.epil.i = load double, ptr %scevgep10.i.epil.i, align 8, !noalias !14
  %.748.i.epil.i = fmul contract double %.565.i.i, %.746.i.epil.i
  %.749.i.epil.i = fadd contract double %.716.i.epil.i, %.748.i.epil.i
  store double %.749.i.epil.i, ptr %sunkaddr11.i.epil.i, align 8, !noalias !14
  %.662.1.i.epil.i = add nuw i64 %.655272274.i.epil.init.i, 2
  %sunkaddr14.i.epil.i = getelementptr i8, ptr %sunkaddr11.i.epil.i, i64 8
  %.716.1.i.epil.i = load double, ptr %sunkaddr14.i.epil.i, align 8, !noalias !14
  %.746.1.i.epil.i = load double, ptr %scevgep9.i.epil.i, align 8, !noalias !14
  %.748.1.i.epil.i = fmul contract double %.565.i.i, %.746.1.i.epil.i
  %.749.1.i.epil.i = fadd contract double %.716.1.i.epil.i, %.748.1.i.epil.i
  store double %.749.1.i.epil.i, ptr %sunkaddr14.i.epil.i, align 8, !noalias !14
  br label %B284.loopexit.unr-lcssa.i.i

B284.loopexit.unr-lcssa.i.i:                      ; preds = %B228.if.i.epil.preheader.i, %B284.loopexit.unr-lcssa.i.unr-lcssa.i
  %.662.1.i.lcssa.i = phi i64 [ %.662.1.i.epil.i, %B228.if.i.epil.preheader.i ], [ %.662.1.i.1.i, %B284.loopexit.unr-lcssa.i.unr-lcssa.i ]
  br i1 %130, label %B284.i.i, label %B228.if.epil.preheader.i.i

B228.if.epil.preheader.i.i:                       ; preds = %B228.if.preheader.i.i, %B284.loopexit.unr-lcssa.i.i
  %.655272274.epil.init.i.i = phi i64 [ 0, %B228.if.preheader.i.i ], [ %.662.1.i.lcssa.i, %B284.loopexit.unr-lcssa.i.i ]
  %132 = getelementptr double, ptr %.4685.i, i64 %.655272274.epil.init.i.i
  %.716.epil.i.i = load double, ptr %132, align 8, !noalias !14
  %133 = getelementptr double, ptr %.498.i.i, i64 %.655272274.epil.init.i.i
  %.746.epil.i.i = load double, ptr %133, align 8, !noalias !14
  %.748.epil.i.i = fmul contract double %.565.i.i, %.746.epil.i.i
  %.749.epil.i.i = fadd contract double %.716.epil.i.i, %.748.epil.i.i
  store double %.749.epil.i.i, ptr %132, align 8, !noalias !14
  br label %B284.i.i

B284.i.i:                                         ; preds = %B130.else.endif.endif.endif.endif.i.i, %B228.if.epil.preheader.i.i, %B284.loopexit.unr-lcssa.i.i
  %exitcond292.not.i.i = icmp eq i64 %.4488.i, %.324.i.i
  br i1 %exitcond292.not.i.i, label %B1516.endif.endif.endif.i, label %B128.if.i.i

B128.if.i.i:                                      ; preds = %B284.i.i, %B128.if.lr.ph.i.i
  %.317279285.i.i = phi i64 [ 0, %B128.if.lr.ph.i.i ], [ %.324.i.i, %B284.i.i ]
  %.324.i.i = add nuw nsw i64 %.317279285.i.i, 1
  %.350.i.i = mul nsw i64 %.317279285.i.i, %arg.n_f
  %.352.i.i = add nsw i64 %.350.i.i, %.3625.sroa.0.068.i
  %.395.i.i = icmp slt i64 %.352.i.i, 0
  %.396.i.i = select i1 %.395.i.i, i64 %arg.n_ls, i64 0
  %.397.i.i = add i64 %.396.i.i, %.352.i.i
  %.400.i.i = icmp slt i64 %.397.i.i, 0
  br i1 %.400.i.i, label %B130.else.if.i.i, label %B130.else.endif.i.i, !prof !0

B130.else.if.i.i:                                 ; preds = %B128.if.i.i
  br label %B130.else.endif.i.i

B130.else.endif.i.i:                              ; preds = %B130.else.if.i.i, %B128.if.i.i
  %.385.sroa.0.1.i.i = phi i64 [ 0, %B130.else.if.i.i ], [ %.397.i.i, %B128.if.i.i ]
  %.405.not.i.i = icmp slt i64 %.397.i.i, %arg.n_ls
  br i1 %.405.not.i.i, label %B130.else.endif.endif.endif.endif.i.i, label %B130.else.endif.if.i.i, !prof !10

B130.else.endif.if.i.i:                           ; preds = %B130.else.endif.i.i
  br label %B130.else.endif.endif.endif.endif.i.i

B130.else.endif.endif.endif.endif.i.i:            ; preds = %B130.else.endif.if.i.i, %B130.else.endif.i.i
  %.385.sroa.0.3.i.i = phi i64 [ %arg.n_ls, %B130.else.endif.if.i.i ], [ %.385.sroa.0.1.i.i, %B130.else.endif.i.i ]
  %.498.i.i = getelementptr double, ptr %arg.linear_spline, i64 %.385.sroa.0.3.i.i
  %134 = getelementptr double, ptr %.4513.i, i64 %.317279285.i.i
  %.565.i.i = load double, ptr %134, align 8, !noalias !14
  br i1 %.104.i.not.i, label %B284.i.i, label %B228.if.preheader.i.i

B228.if.preheader.i.i:                            ; preds = %B130.else.endif.endif.endif.endif.i.i
  br i1 %125, label %B228.if.epil.preheader.i.i, label %B228.if.preheader2.i.i

B228.if.preheader2.i.i:                           ; preds = %B228.if.preheader.i.i
  %135 = shl i64 %.385.sroa.0.3.i.i, 3
  %scevgep7.i.i = getelementptr i8, ptr %scevgep6.i.i, i64 %135
  br i1 %126, label %B228.if.i.epil.preheader.i, label %B228.if.i.preheader.i

B228.if.i.preheader.i:                            ; preds = %B228.if.preheader2.i.i
  %scevgep407.i = getelementptr i8, ptr %scevgep406.i, i64 %135
  br label %B228.if.i.i

B228.if.i.i:                                      ; preds = %B228.if.i.i, %B228.if.i.preheader.i
  %lsr.iv26.i = phi i64 [ %lsr.iv.next27.i, %B228.if.i.i ], [ %124, %B228.if.i.preheader.i ]
  %.655272274.i.i = phi i64 [ %.662.1.i.1.i, %B228.if.i.i ], [ 0, %B228.if.i.preheader.i ]
  %136 = shl i64 %.655272274.i.i, 3
  %scevgep404.i = getelementptr i8, ptr %scevgep398.i, i64 %136
  %scevgep405.i = getelementptr i8, ptr %scevgep404.i, i64 -24
  %.716.i.i = load double, ptr %scevgep405.i, align 8, !noalias !14
  %scevgep410.i = getelementptr i8, ptr %scevgep407.i, i64 %136
  %scevgep411.i = getelementptr i8, ptr %scevgep410.i, i64 -16
  %scevgep31.i = getelementptr i8, ptr %scevgep410.i, i64 -24
  %.746.i.i = load double, ptr %scevgep31.i, align 8, !noalias !14
  %.748.i.i = fmul contract double %.565.i.i, %.746.i.i
  %.749.i.i = fadd contract double %.716.i.i, %.748.i.i
  store double %.749.i.i, ptr %scevgep405.i, align 8, !noalias !14
  %scevgep35.i = getelementptr i8, ptr %scevgep404.i, i64 -16
  %.716.1.i.i = load double, ptr %scevgep35.i, align 8, !noalias !14
  %.746.1.i.i = load double, ptr %scevgep411.i, align 8, !noalias !14
  %.748.1.i.i = fmul contract double %.565.i.i, %.746.1.i.i
  %.749.1.i.i = fadd contract double %.716.1.i.i, %.748.1.i.i
  store double %.749.1.i.i, ptr %scevgep35.i, align 8, !noalias !14
  %scevgep33.i = getelementptr i8, ptr %scevgep404.i, i64 -8
  %.716.i.1.i = load double, ptr %scevgep33.i, align 8, !noalias !14
  %scevgep29.i = getelementptr i8, ptr %scevgep410.i, i64 -8
  %.746.i.1.i = load double, ptr %scevgep29.i, align 8, !noalias !14
  %.748.i.1.i = fmul contract double %.565.i.i, %.746.i.1.i
  %.749.i.1.i = fadd contract double %.716.i.1.i, %.748.i.1.i
  store double %.749.i.1.i, ptr %scevgep33.i, align 8, !noalias !14
  %.662.1.i.1.i = add i64 %.655272274.i.i, 4
  %.716.1.i.1.i = load double, ptr %scevgep404.i, align 8, !noalias !14
  %.746.1.i.1.i = load double, ptr %scevgep410.i, align 8, !noalias !14
  %.748.1.i.1.i = fmul contract double %.565.i.i, %.746.1.i.1.i
  %.749.1.i.1.i = fadd contract double %.716.1.i.1.i, %.748.1.i.1.i
  store double %.749.1.i.1.i, ptr %scevgep404.i, align 8, !noalias !14
  %lsr.iv.next27.i = add i64 %lsr.iv26.i, 2
  %niter.ncmp.1.i = icmp eq i64 %lsr.iv.next27.i, 0
  br i1 %niter.ncmp.1.i, label %B284.loopexit.unr-lcssa.i.unr-lcssa.i, label %B228.if.i.i

B1516.endif.endif.endif.i:                        ; preds = %B284.i.i, %B76.i.i
  %.4796.i = select i1 %.4410.i, i64 %arg.n_phase, i64 0
  %.4797.i = add i64 %.4796.i, %.4370.i
  %.4800.i = icmp slt i64 %.4797.i, 0
  br i1 %.4800.i, label %B1516.endif.endif.endif.else.if.i, label %B1516.endif.endif.endif.else.endif.i, !prof !0

B1516.endif.endif.endif.else.if.i:                ; preds = %B1516.endif.endif.endif.i
  br label %B1516.endif.endif.endif.else.endif.i

B1516.endif.endif.endif.else.endif.i:             ; preds = %B1516.endif.endif.endif.else.if.i, %B1516.endif.endif.endif.i
  %.4785.sroa.0.1.i = phi i64 [ 0, %B1516.endif.endif.endif.else.if.i ], [ %.4797.i, %B1516.endif.endif.endif.i ]
  %.4805.not.i = icmp slt i64 %.4797.i, %arg.n_phase
  br i1 %.4805.not.i, label %B1516.endif.endif.endif.else.endif.endif.i, label %B1516.endif.endif.endif.else.endif.if.i, !prof !10

B1516.endif.endif.endif.else.endif.if.i:          ; preds = %B1516.endif.endif.endif.else.endif.i
  br label %B1516.endif.endif.endif.else.endif.endif.i

B1516.endif.endif.endif.else.endif.endif.i:       ; preds = %B1516.endif.endif.endif.else.endif.if.i, %B1516.endif.endif.endif.else.endif.i
  %.4785.sroa.0.3.i = phi i64 [ %arg.n_phase, %B1516.endif.endif.endif.else.endif.if.i ], [ %.4785.sroa.0.1.i, %B1516.endif.endif.endif.else.endif.i ]
  %.4813.i = select i1 %.4427.i, i64 %arg.n_phase, i64 0
  %.4814.i = add i64 %.4813.i, %.4373.i
  %.4817.i = icmp slt i64 %.4814.i, 0
  br i1 %.4817.i, label %B1516.endif.endif.endif.else.endif.endif.if.i, label %B1516.endif.endif.endif.else.endif.endif.endif.i, !prof !0

B1516.endif.endif.endif.else.endif.endif.if.i:    ; preds = %B1516.endif.endif.endif.else.endif.endif.i
  br label %B1516.endif.endif.endif.else.endif.endif.endif.i

B1516.endif.endif.endif.else.endif.endif.endif.i: ; preds = %B1516.endif.endif.endif.else.endif.endif.if.i, %B1516.endif.endif.endif.else.endif.endif.i
  %.4785.sroa.13.1.i = phi i64 [ 0, %B1516.endif.endif.endif.else.endif.endif.if.i ], [ %.4814.i, %B1516.endif.endif.endif.else.endif.endif.i ]
  %.4822.not.i = icmp slt i64 %.4814.i, %arg.n_phase
  br i1 %.4822.not.i, label %B1516.endif.endif.endif.else.endif.endif.endif.endif.i, label %B1516.endif.endif.endif.else.endif.endif.endif.if.i, !prof !10

B1516.endif.endif.endif.else.endif.endif.endif.if.i: ; preds = %B1516.endif.endif.endif.else.endif.endif.endif.i
  br label %B1516.endif.endif.endif.else.endif.endif.endif.endif.i

B1516.endif.endif.endif.else.endif.endif.endif.endif.i: ; preds = %B1516.endif.endif.endif.else.endif.endif.endif.if.i, %B1516.endif.endif.endif.else.endif.endif.endif.i
  %.4785.sroa.13.2.i = phi i64 [ %arg.n_phase, %B1516.endif.endif.endif.else.endif.endif.endif.if.i ], [ %.4785.sroa.13.1.i, %B1516.endif.endif.endif.else.endif.endif.endif.i ]
  %.4873.i = sub i64 %.4785.sroa.13.2.i, %.4785.sroa.0.3.i
  %.4898.i = getelementptr double, ptr %arg.phase, i64 %.4785.sroa.0.3.i
  br i1 %87, label %B1516.endif.endif.endif.endif.else.endif.if.i, label %B1516.endif.endif.endif.endif.else.endif.endif.i, !prof !0

B1516.endif.endif.endif.endif.else.endif.if.i:    ; preds = %B1516.endif.endif.endif.else.endif.endif.endif.endif.i
  br label %B1516.endif.endif.endif.endif.else.endif.endif.i

B1516.endif.endif.endif.endif.else.endif.endif.i: ; preds = %B1516.endif.endif.endif.endif.else.endif.if.i, %B1516.endif.endif.endif.else.endif.endif.endif.endif.i
  %.4957.sroa.0.3.i = phi i64 [ %.2601.i, %B1516.endif.endif.endif.endif.else.endif.if.i ], [ 0, %B1516.endif.endif.endif.else.endif.endif.endif.endif.i ]
  br i1 %10, label %B1516.endif.endif.endif.endif.else.endif.endif.if.i, label %B1516.endif.endif.endif.endif.else.endif.endif.endif.i, !prof !0

B1516.endif.endif.endif.endif.else.endif.endif.if.i: ; preds = %B1516.endif.endif.endif.endif.else.endif.endif.i
  br label %B1516.endif.endif.endif.endif.else.endif.endif.endif.i

B1516.endif.endif.endif.endif.else.endif.endif.endif.i: ; preds = %B1516.endif.endif.endif.endif.else.endif.endif.if.i, %B1516.endif.endif.endif.endif.else.endif.endif.i
  %.4957.sroa.13.1.i = phi i64 [ 0, %B1516.endif.endif.endif.endif.else.endif.endif.if.i ], [ %.4986.i, %B1516.endif.endif.endif.endif.else.endif.endif.i ]
  br i1 %11, label %B1516.endif.endif.endif.e...endif.i, label %B1516.endif.endif.endif.e...if.i, !prof !10

B1516.endif.endif.endif.e...if.i:                 ; preds = %B1516.endif.endif.endif.endif.else.endif.endif.endif.i
  br label %B1516.endif.endif.endif.e...endif.i

B1516.endif.endif.endif.e...endif.i:              ; preds = %B1516.endif.endif.endif.e...if.i, %B1516.endif.endif.endif.endif.else.endif.endif.endif.i
  %.4957.sroa.13.2.i = phi i64 [ %.2601.i, %B1516.endif.endif.endif.e...if.i ], [ %.4957.sroa.13.1.i, %B1516.endif.endif.endif.endif.else.endif.endif.endif.i ]
  %.5045.i = sub nsw i64 %.4957.sroa.13.2.i, %.4957.sroa.0.3.i
  %.5054.i = tail call i64 @llvm.smax.i64(i64 %.5045.i, i64 0)
  %.5070.i = getelementptr double, ptr %.2617.i, i64 %.4957.sroa.0.3.i
  %.104.i99.not.i = icmp slt i64 %.5045.i, 1
  br i1 %.104.i99.not.i, label %B76.i100.i, label %B60.if.preheader.i151.i

B60.if.preheader.i151.i:                          ; preds = %B1516.endif.endif.endif.e...endif.i
  %137 = shl nuw i64 %.5054.i, 3
  tail call void @llvm.memset.p0.i64(ptr align 8 %.5070.i, i8 0, i64 %137, i1 false), !noalias !17
  br label %B76.i100.i

B76.i100.i:                                       ; preds = %B60.if.preheader.i151.i, %B1516.endif.endif.endif.e...endif.i
  %.311284.not.i101.i = icmp slt i64 %.4873.i, 1
  br i1 %.311284.not.i101.i, label %B1516.endif.endif.endif.endif.endif.endif.i, label %B128.if.lr.ph.i102.i

B128.if.lr.ph.i102.i:                             ; preds = %B76.i100.i
  %138 = add nsw i64 %.5054.i, -2
  %139 = lshr i64 %138, 1
  %140 = add nuw i64 %139, 1
  %141 = shl i64 %.4957.sroa.0.3.i, 3
  %scevgep417.i = getelementptr i8, ptr %scevgep416.i, i64 %141
  %142 = lshr i64 %140, 1
  %143 = mul nsw i64 %142, -2
  %144 = icmp eq i64 %.5045.i, 1
  %145 = icmp eq i64 %139, 0
  %146 = and i64 %138, 2
  %147 = icmp eq i64 %146, 0
  %148 = and i64 %.5054.i, 1
  %149 = icmp eq i64 %148, 0
  br label %B128.if.i105.i

B284.loopexit.unr-lcssa.i141.unr-lcssa.i:         ; preds = %B228.if.i125.i
  br i1 %147, label %B228.if.i125.epil.preheader.i, label %B284.loopexit.unr-lcssa.i141.i

B228.if.i125.epil.preheader.i:                    ; preds = %B228.if.preheader2.i123.i, %B284.loopexit.unr-lcssa.i141.unr-lcssa.i
  %.655272274.i126.epil.init.i = phi i64 [ 0, %B228.if.preheader2.i123.i ], [ %.662.1.i134.1.i, %B284.loopexit.unr-lcssa.i141.unr-lcssa.i ]
  %150 = shl i64 %.655272274.i126.epil.init.i, 3
  %sunkaddr11.i127.epil.i = getelementptr i8, ptr %.5070.i, i64 %150
  %.716.i128.epil.i = load double, ptr %sunkaddr11.i127.epil.i, align 8, !noalias !17
  %scevgep9.i129.epil.i = getelementptr i8, ptr %scevgep7.i124.i, i64 %150
  %scevgep10.i130.epil.i = getelementptr i8, ptr %scevgep9.i129.epil.i, i64 -8
  %.746.i131.epil.i = load double, ptr %scevgep10.i130.epil.i, align 8, !noalias !17
  %.748.i132.epil.i = fmul contract double %.565.i121.i, %.746.i131.epil.i
  %.749.i133.epil.i = fadd contract double %.716.i128.epil.i, %.748.i132.epil.i
  store double %.749.i133.epil.i, ptr %sunkaddr11.i127.epil.i, align 8, !noalias !17
  %.662.1.i134.epil.i = add nuw i64 %.655272274.i126.epil.init.i, 2
  %sunkaddr14.i135.epil.i = getelementptr i8, ptr %sunkaddr11.i127.epil.i, i64 8
  %.716.1.i136.epil.i = load double, ptr %sunkaddr14.i135.epil.i, align 8, !noalias !17
  %.746.1.i137.epil.i = load double, ptr %scevgep9.i129.epil.i, align 8, !noalias !17
  %.748.1.i138.epil.i = fmul contract double %.565.i121.i, %.746.1.i137.epil.i
  %.749.1.i139.epil.i = fadd contract double %.716.1.i136.epil.i, %.748.1.i138.epil.i
  store double %.749.1.i139.epil.i, ptr %sunkaddr14.i135.epil.i, align 8, !noalias !17
  br label %B284.loopexit.unr-lcssa.i141.i

B284.loopexit.unr-lcssa.i141.i:                   ; preds = %B228.if.i125.epil.preheader.i, %B284.loopexit.unr-lcssa.i141.unr-lcssa.i
  %.662.1.i134.lcssa.i = phi i64 [ %.662.1.i134.epil.i, %B228.if.i125.epil.preheader.i ], [ %.662.1.i134.1.i, %B284.loopexit.unr-lcssa.i141.unr-lcssa.i ]
  br i1 %149, label %B284.i148.i, label %B228.if.epil.preheader.i142.i

B228.if.epil.preheader.i142.i:                    ; preds = %B228.if.preheader.i122.i, %B284.loopexit.unr-lcssa.i141.i
  %.655272274.epil.init.i143.i = phi i64 [ 0, %B228.if.preheader.i122.i ], [ %.662.1.i134.lcssa.i, %B284.loopexit.unr-lcssa.i141.i ]
  %151 = getelementptr double, ptr %.5070.i, i64 %.655272274.epil.init.i143.i
  %.716.epil.i144.i = load double, ptr %151, align 8, !noalias !17
  %152 = getelementptr double, ptr %.498.i120.i, i64 %.655272274.epil.init.i143.i
  %.746.epil.i145.i = load double, ptr %152, align 8, !noalias !17
  %.748.epil.i146.i = fmul contract double %.565.i121.i, %.746.epil.i145.i
  %.749.epil.i147.i = fadd contract double %.716.epil.i144.i, %.748.epil.i146.i
  store double %.749.epil.i147.i, ptr %151, align 8, !noalias !17
  br label %B284.i148.i

B284.i148.i:                                      ; preds = %B130.else.endif.endif.endif.endif.i118.i, %B228.if.epil.preheader.i142.i, %B284.loopexit.unr-lcssa.i141.i
  %exitcond292.not.i149.i = icmp eq i64 %.4873.i, %.324.i107.i
  br i1 %exitcond292.not.i149.i, label %B1516.endif.endif.endif.endif.endif.endif.i, label %B128.if.i105.i

B128.if.i105.i:                                   ; preds = %B284.i148.i, %B128.if.lr.ph.i102.i
  %.317279285.i106.i = phi i64 [ 0, %B128.if.lr.ph.i102.i ], [ %.324.i107.i, %B284.i148.i ]
  %.324.i107.i = add nuw nsw i64 %.317279285.i106.i, 1
  %.350.i108.i = mul nsw i64 %.317279285.i106.i, %arg.n_f
  %.352.i109.i = add nsw i64 %.350.i108.i, %.3625.sroa.0.068.i
  %.395.i110.i = icmp slt i64 %.352.i109.i, 0
  %.396.i111.i = select i1 %.395.i110.i, i64 %arg.n_ls, i64 0
  %.397.i112.i = add i64 %.396.i111.i, %.352.i109.i
  %.400.i113.i = icmp slt i64 %.397.i112.i, 0
  br i1 %.400.i113.i, label %B130.else.if.i150.i, label %B130.else.endif.i114.i, !prof !0

B130.else.if.i150.i:                              ; preds = %B128.if.i105.i
  br label %B130.else.endif.i114.i

B130.else.endif.i114.i:                           ; preds = %B130.else.if.i150.i, %B128.if.i105.i
  %.385.sroa.0.1.i115.i = phi i64 [ 0, %B130.else.if.i150.i ], [ %.397.i112.i, %B128.if.i105.i ]
  %.405.not.i116.i = icmp slt i64 %.397.i112.i, %arg.n_ls
  br i1 %.405.not.i116.i, label %B130.else.endif.endif.endif.endif.i118.i, label %B130.else.endif.if.i117.i, !prof !10

B130.else.endif.if.i117.i:                        ; preds = %B130.else.endif.i114.i
  br label %B130.else.endif.endif.endif.endif.i118.i

B130.else.endif.endif.endif.endif.i118.i:         ; preds = %B130.else.endif.if.i117.i, %B130.else.endif.i114.i
  %.385.sroa.0.3.i119.i = phi i64 [ %arg.n_ls, %B130.else.endif.if.i117.i ], [ %.385.sroa.0.1.i115.i, %B130.else.endif.i114.i ]
  %.498.i120.i = getelementptr double, ptr %arg.linear_spline, i64 %.385.sroa.0.3.i119.i
  %153 = getelementptr double, ptr %.4898.i, i64 %.317279285.i106.i
  %.565.i121.i = load double, ptr %153, align 8, !noalias !17
  br i1 %.104.i99.not.i, label %B284.i148.i, label %B228.if.preheader.i122.i

B228.if.preheader.i122.i:                         ; preds = %B130.else.endif.endif.endif.endif.i118.i
  br i1 %144, label %B228.if.epil.preheader.i142.i, label %B228.if.preheader2.i123.i

B228.if.preheader2.i123.i:                        ; preds = %B228.if.preheader.i122.i
  %154 = shl i64 %.385.sroa.0.3.i119.i, 3
  %scevgep7.i124.i = getelementptr i8, ptr %scevgep6.i.i, i64 %154
  br i1 %145, label %B228.if.i125.epil.preheader.i, label %B228.if.i125.preheader.i

B228.if.i125.preheader.i:                         ; preds = %B228.if.preheader2.i123.i
  %scevgep426.i = getelementptr i8, ptr %scevgep406.i, i64 %154
  br label %B228.if.i125.i

B228.if.i125.i:                                   ; preds = %B228.if.i125.i, %B228.if.i125.preheader.i
  %lsr.iv36.i = phi i64 [ %lsr.iv.next37.i, %B228.if.i125.i ], [ %143, %B228.if.i125.preheader.i ]
  %.655272274.i126.i = phi i64 [ %.662.1.i134.1.i, %B228.if.i125.i ], [ 0, %B228.if.i125.preheader.i ]
  %155 = shl i64 %.655272274.i126.i, 3
  %scevgep423.i = getelementptr i8, ptr %scevgep417.i, i64 %155
  %scevgep424.i = getelementptr i8, ptr %scevgep423.i, i64 -24
  %.716.i128.i = load double, ptr %scevgep424.i, align 8, !noalias !17
  %scevgep429.i = getelementptr i8, ptr %scevgep426.i, i64 %155
  %scevgep430.i = getelementptr i8, ptr %scevgep429.i, i64 -16
  %scevgep41.i = getelementptr i8, ptr %scevgep429.i, i64 -24
  %.746.i131.i = load double, ptr %scevgep41.i, align 8, !noalias !17
  %.748.i132.i = fmul contract double %.565.i121.i, %.746.i131.i
  %.749.i133.i = fadd contract double %.716.i128.i, %.748.i132.i
  store double %.749.i133.i, ptr %scevgep424.i, align 8, !noalias !17
  %scevgep45.i = getelementptr i8, ptr %scevgep423.i, i64 -16
  %.716.1.i136.i = load double, ptr %scevgep45.i, align 8, !noalias !17
  %.746.1.i137.i = load double, ptr %scevgep430.i, align 8, !noalias !17
  %.748.1.i138.i = fmul contract double %.565.i121.i, %.746.1.i137.i
  %.749.1.i139.i = fadd contract double %.716.1.i136.i, %.748.1.i138.i
  store double %.749.1.i139.i, ptr %scevgep45.i, align 8, !noalias !17
  %scevgep43.i = getelementptr i8, ptr %scevgep423.i, i64 -8
  %.716.i128.1.i = load double, ptr %scevgep43.i, align 8, !noalias !17
  %scevgep39.i = getelementptr i8, ptr %scevgep429.i, i64 -8
  %.746.i131.1.i = load double, ptr %scevgep39.i, align 8, !noalias !17
  %.748.i132.1.i = fmul contract double %.565.i121.i, %.746.i131.1.i
  %.749.i133.1.i = fadd contract double %.716.i128.1.i, %.748.i132.1.i
  store double %.749.i133.1.i, ptr %scevgep43.i, align 8, !noalias !17
  %.662.1.i134.1.i = add i64 %.655272274.i126.i, 4
  %.716.1.i136.1.i = load double, ptr %scevgep423.i, align 8, !noalias !17
  %.746.1.i137.1.i = load double, ptr %scevgep429.i, align 8, !noalias !17
  %.748.1.i138.1.i = fmul contract double %.565.i121.i, %.746.1.i137.1.i
  %.749.1.i139.1.i = fadd contract double %.716.1.i136.1.i, %.748.1.i138.1.i
  store double %.749.1.i139.1.i, ptr %scevgep423.i, align 8, !noalias !17
  %lsr.iv.next37.i = add i64 %lsr.iv36.i, 2
  %niter355.ncmp.1.i = icmp eq i64 %lsr.iv.next37.i, 0
  br i1 %niter355.ncmp.1.i, label %B284.loopexit.unr-lcssa.i141.unr-lcssa.i, label %B228.if.i125.i

B1516.endif.endif.endif.endif.endif.endif.i:      ; preds = %B284.i148.i, %B76.i100.i
  br i1 %86, label %B1516.endif.endif.endif.e...if.1.i, label %B1516.endif.endif.endif.e...endif.1.i, !prof !0

B1516.endif.endif.endif.e...if.1.i:               ; preds = %B1516.endif.endif.endif.endif.endif.endif.i
  br label %B1516.endif.endif.endif.e...endif.1.i

B1516.endif.endif.endif.e...endif.1.i:            ; preds = %B1516.endif.endif.endif.e...if.1.i, %B1516.endif.endif.endif.endif.endif.endif.i
  %.5169.sroa.0.3.i = phi i64 [ %.2426.i, %B1516.endif.endif.endif.e...if.1.i ], [ 0, %B1516.endif.endif.endif.endif.endif.endif.i ]
  %.5282.i = getelementptr double, ptr %.2442.i, i64 %.5169.sroa.0.3.i
  br i1 %87, label %B1516.endif.endif.endif.e...endif.3.if.i, label %B1516.endif.endif.endif.e...endif.3.endif.i, !prof !0

B1516.endif.endif.endif.e...endif.3.if.i:         ; preds = %B1516.endif.endif.endif.e...endif.1.i
  br label %B1516.endif.endif.endif.e...endif.3.endif.i

B1516.endif.endif.endif.e...endif.3.endif.i:      ; preds = %B1516.endif.endif.endif.e...endif.3.if.i, %B1516.endif.endif.endif.e...endif.1.i
  %.5341.sroa.0.3.i = phi i64 [ %.2601.i, %B1516.endif.endif.endif.e...endif.3.if.i ], [ 0, %B1516.endif.endif.endif.e...endif.1.i ]
  %.5454.i = getelementptr double, ptr %.2617.i, i64 %.5341.sroa.0.3.i
  br i1 %84, label %B1516.endif.endif.endif.e...else.endif.if.i, label %B1516.endif.endif.endif.e...else.endif.endif.i, !prof !0

B1516.endif.endif.endif.e...else.endif.if.i:      ; preds = %B1516.endif.endif.endif.e...endif.3.endif.i
  br label %B1516.endif.endif.endif.e...else.endif.endif.i

B1516.endif.endif.endif.e...else.endif.endif.i:   ; preds = %B1516.endif.endif.endif.e...else.endif.if.i, %B1516.endif.endif.endif.e...endif.3.endif.i
  %.5513.sroa.0.3.i = phi i64 [ %.1323.i, %B1516.endif.endif.endif.e...else.endif.if.i ], [ 0, %B1516.endif.endif.endif.e...endif.3.endif.i ]
  br i1 %12, label %B1516.endif.endif.endif.e...else.endif.endif.if.i, label %B1516.endif.endif.endif.e...else.endif.endif.endif.i, !prof !0

B1516.endif.endif.endif.e...else.endif.endif.if.i: ; preds = %B1516.endif.endif.endif.e...else.endif.endif.i
  br label %B1516.endif.endif.endif.e...else.endif.endif.endif.i

B1516.endif.endif.endif.e...else.endif.endif.endif.i: ; preds = %B1516.endif.endif.endif.e...else.endif.endif.if.i, %B1516.endif.endif.endif.e...else.endif.endif.i
  %.5513.sroa.13.1.i = phi i64 [ 0, %B1516.endif.endif.endif.e...else.endif.endif.if.i ], [ %.6659.i, %B1516.endif.endif.endif.e...else.endif.endif.i ]
  br i1 %13, label %B1516.endif.endif.endif.e...else.endif.endif.endif.endif.i, label %B1516.endif.endif.endif.e...else.endif.endif.endif.if.i, !prof !10

B1516.endif.endif.endif.e...else.endif.endif.endif.if.i: ; preds = %B1516.endif.endif.endif.e...else.endif.endif.endif.i
  br label %B1516.endif.endif.endif.e...else.endif.endif.endif.endif.i

B1516.endif.endif.endif.e...else.endif.endif.endif.endif.i: ; preds = %B1516.endif.endif.endif.e...else.endif.endif.endif.if.i, %B1516.endif.endif.endif.e...else.endif.endif.endif.i
  %.5513.sroa.13.2.i = phi i64 [ %.1323.i, %B1516.endif.endif.endif.e...else.endif.endif.endif.if.i ], [ %.5513.sroa.13.1.i, %B1516.endif.endif.endif.e...else.endif.endif.endif.i ]
  %.5601.i = sub nsw i64 %.5513.sroa.13.2.i, %.5513.sroa.0.3.i
  %.5626.i = getelementptr double, ptr %.1339.i, i64 %.5513.sroa.0.3.i
  br i1 %85, label %B1516.endif.endif.endif.e...endif.5.else.endif.if.i, label %B1516.endif.endif.endif.e...endif.5.else.endif.endif.i, !prof !0

B1516.endif.endif.endif.e...endif.5.else.endif.if.i: ; preds = %B1516.endif.endif.endif.e...else.endif.endif.endif.endif.i
  br label %B1516.endif.endif.endif.e...endif.5.else.endif.endif.i

B1516.endif.endif.endif.e...endif.5.else.endif.endif.i: ; preds = %B1516.endif.endif.endif.e...endif.5.else.endif.if.i, %B1516.endif.endif.endif.e...else.endif.endif.endif.endif.i
  %.5685.sroa.0.3.i = phi i64 [ %.1497.i, %B1516.endif.endif.endif.e...endif.5.else.endif.if.i ], [ 0, %B1516.endif.endif.endif.e...else.endif.endif.endif.endif.i ]
  %.5798.i = getelementptr double, ptr %.1513.i, i64 %.5685.sroa.0.3.i
  br i1 %88, label %B1516.endif.endif.endif.e...if.8.i, label %B1516.endif.endif.endif.e...endif.8.i, !prof !0

B1516.endif.endif.endif.e...if.8.i:               ; preds = %B1516.endif.endif.endif.e...endif.5.else.endif.endif.i
  br label %B1516.endif.endif.endif.e...endif.8.i

B1516.endif.endif.endif.e...endif.8.i:            ; preds = %B1516.endif.endif.endif.e...if.8.i, %B1516.endif.endif.endif.e...endif.5.else.endif.endif.i
  %.5857.sroa.0.3.i = phi i64 [ %.1690.i, %B1516.endif.endif.endif.e...if.8.i ], [ 0, %B1516.endif.endif.endif.e...endif.5.else.endif.endif.i ]
  %.5970.i = getelementptr double, ptr %.1706.i, i64 %.5857.sroa.0.3.i
  br i1 %89, label %B1516.endif.endif.endif.e...endif.10.if.i, label %B1516.endif.endif.endif.e...endif.10.endif.i, !prof !0

B1516.endif.endif.endif.e...endif.10.if.i:        ; preds = %B1516.endif.endif.endif.e...endif.8.i
  br label %B1516.endif.endif.endif.e...endif.10.endif.i

B1516.endif.endif.endif.e...endif.10.endif.i:     ; preds = %B1516.endif.endif.endif.e...endif.10.if.i, %B1516.endif.endif.endif.e...endif.8.i
  %.6029.sroa.0.3.i = phi i64 [ %.1865.i, %B1516.endif.endif.endif.e...endif.10.if.i ], [ 0, %B1516.endif.endif.endif.e...endif.8.i ]
  %.6142.i = getelementptr double, ptr %.1881.i, i64 %.6029.sroa.0.3.i
  %.180193.not.i.i = icmp slt i64 %.5601.i, 1
  br i1 %.180193.not.i.i, label %B1516.endif.endif.endif.e...endif.12.i, label %B56.if.i.i

B56.if.i.i:                                       ; preds = %B1516.endif.endif.endif.e...endif.10.endif.i, %B56.if.i.i
  %.186192194.i.i = phi i64 [ %.193.i153.i, %B56.if.i.i ], [ 0, %B1516.endif.endif.endif.e...endif.10.endif.i ]
  %.193.i153.i = add nuw nsw i64 %.186192194.i.i, 1
  %156 = shl i64 %.186192194.i.i, 3
  %scevgep5.i.i = getelementptr i8, ptr %.5454.i, i64 %156
  %.247.i154.i = load double, ptr %scevgep5.i.i, align 8, !noalias !20
  %scevgep4.i.i = getelementptr i8, ptr %.5282.i, i64 %156
  %.277.i.i = load double, ptr %scevgep4.i.i, align 8, !noalias !20
  %.278.i.i = fadd contract double %.277.i.i, 1.000000e+00
  %.279.i.i = fmul contract double %.247.i154.i, %.247.i154.i
  %.280.i.i = fadd contract double %.279.i.i, 4.000000e+00
  %.284.i.i = fdiv contract double %.278.i.i, %.280.i.i
  %.286.i.i = fsub contract double 4.000000e+00, %.279.i.i
  %.287.i.i = fmul contract double %.286.i.i, %.284.i.i
  %.288.i.i = fmul contract double %.247.i154.i, 4.000000e+00
  %.289.i.i = fmul contract double %.288.i.i, %.284.i.i
  %scevgep49.i = getelementptr i8, ptr %.5626.i, i64 %156
  %.319.i.i = load double, ptr %scevgep49.i, align 8, !noalias !20
  %.320.i.i = fmul contract double %.319.i.i, %.287.i.i
  %scevgep48.i = getelementptr i8, ptr %.5798.i, i64 %156
  %.350.i155.i = load double, ptr %scevgep48.i, align 8, !noalias !20
  %.351.i.i = fmul contract double %.350.i155.i, %.289.i.i
  %.352.i156.i = fsub contract double %.320.i.i, %.351.i.i
  %scevgep47.i = getelementptr i8, ptr %.5970.i, i64 %156
  store double %.352.i156.i, ptr %scevgep47.i, align 8, !noalias !20
  %.412.i.i = load double, ptr %scevgep49.i, align 8, !noalias !20
  %.413.i.i = fmul contract double %.289.i.i, %.412.i.i
  %.443.i.i = load double, ptr %scevgep48.i, align 8, !noalias !20
  %.444.i.i = fmul contract double %.287.i.i, %.443.i.i
  %.445.i.i = fadd contract double %.413.i.i, %.444.i.i
  %scevgep46.i = getelementptr i8, ptr %.6142.i, i64 %156
  store double %.445.i.i, ptr %scevgep46.i, align 8, !noalias !20
  %exitcond.not.i.i = icmp eq i64 %.5601.i, %.193.i153.i
  br i1 %exitcond.not.i.i, label %B1516.endif.endif.endif.e...endif.12.i, label %B56.if.i.i

B1516.endif.endif.endif.e...endif.12.i:           ; preds = %B56.if.i.i, %B1516.endif.endif.endif.e...endif.10.endif.i
  br i1 %88, label %B1516.endif.endif.endif.e...endif.12.else.endif.if.i, label %B1516.endif.endif.endif.e...endif.12.else.endif.endif.i, !prof !0

B1516.endif.endif.endif.e...endif.12.else.endif.if.i: ; preds = %B1516.endif.endif.endif.e...endif.12.i
  br label %B1516.endif.endif.endif.e...endif.12.else.endif.endif.i

B1516.endif.endif.endif.e...endif.12.else.endif.endif.i: ; preds = %B1516.endif.endif.endif.e...endif.12.else.endif.if.i, %B1516.endif.endif.endif.e...endif.12.i
  %.6255.sroa.0.3.i = phi i64 [ %.1690.i, %B1516.endif.endif.endif.e...endif.12.else.endif.if.i ], [ 0, %B1516.endif.endif.endif.e...endif.12.i ]
  %.6368.i = getelementptr double, ptr %.1706.i, i64 %.6255.sroa.0.3.i
  br i1 %89, label %B1516.endif.endif.endif.e...if.15.i, label %B1516.endif.endif.endif.e...endif.15.i, !prof !0

B1516.endif.endif.endif.e...if.15.i:              ; preds = %B1516.endif.endif.endif.e...endif.12.else.endif.endif.i
  br label %B1516.endif.endif.endif.e...endif.15.i

B1516.endif.endif.endif.e...endif.15.i:           ; preds = %B1516.endif.endif.endif.e...if.15.i, %B1516.endif.endif.endif.e...endif.12.else.endif.endif.i
  %.6427.sroa.0.3.i = phi i64 [ %.1865.i, %B1516.endif.endif.endif.e...if.15.i ], [ 0, %B1516.endif.endif.endif.e...endif.12.else.endif.endif.i ]
  %.6540.i = getelementptr double, ptr %.1881.i, i64 %.6427.sroa.0.3.i
  br label %B1908.i

B1868.else.endif.i:                               ; preds = %B1502.i
  br i1 %84, label %B1868.else.endif.if.i, label %B1868.else.endif.endif.i, !prof !0

B1868.else.endif.if.i:                            ; preds = %B1868.else.endif.i
  br label %B1868.else.endif.endif.i

B1868.else.endif.endif.i:                         ; preds = %B1868.else.endif.if.i, %B1868.else.endif.i
  %.6630.sroa.0.3.i = phi i64 [ %.1323.i, %B1868.else.endif.if.i ], [ 0, %B1868.else.endif.i ]
  %.6743.i = getelementptr double, ptr %.1339.i, i64 %.6630.sroa.0.3.i
  br i1 %85, label %B1868.endif.else.endif.if.i, label %B1868.endif.else.endif.endif.i, !prof !0

B1868.endif.else.endif.if.i:                      ; preds = %B1868.else.endif.endif.i
  br label %B1868.endif.else.endif.endif.i

B1868.endif.else.endif.endif.i:                   ; preds = %B1868.endif.else.endif.if.i, %B1868.else.endif.endif.i
  %.6802.sroa.0.3.i = phi i64 [ %.1497.i, %B1868.endif.else.endif.if.i ], [ 0, %B1868.else.endif.endif.i ]
  %.6915.i = getelementptr double, ptr %.1513.i, i64 %.6802.sroa.0.3.i
  br label %B1908.i

B1908.else.if.i:                                  ; preds = %B1908.i
  br label %B1908.else.endif.i

B1908.else.endif.i:                               ; preds = %B1908.else.if.i, %B1908.i
  %.7015.sroa.0.1.i = phi i64 [ 0, %B1908.else.if.i ], [ %.7027.i, %B1908.i ]
  %.7035.not.i = icmp slt i64 %.7027.i, %arg.n_table
  br i1 %.7035.not.i, label %B1908.else.endif.endif.i, label %B1908.else.endif.if.i, !prof !10

B1908.else.endif.if.i:                            ; preds = %B1908.else.endif.i
  br label %B1908.else.endif.endif.i

B1908.else.endif.endif.i:                         ; preds = %B1908.else.endif.if.i, %B1908.else.endif.i
  %.7015.sroa.0.3.i = phi i64 [ %arg.n_table, %B1908.else.endif.if.i ], [ %.7015.sroa.0.1.i, %B1908.else.endif.i ]
  %.7042.i = icmp slt i64 %.6988.i, 0
  %.7043.i = select i1 %.7042.i, i64 %arg.n_table, i64 0
  %.7044.i = add i64 %.7043.i, %.6988.i
  %.7047.i = icmp slt i64 %.7044.i, 0
  br i1 %.7047.i, label %B1908.else.endif.endif.if.i, label %B1908.else.endif.endif.endif.i, !prof !0

B1908.else.endif.endif.if.i:                      ; preds = %B1908.else.endif.endif.i
  br label %B1908.else.endif.endif.endif.i

B1908.else.endif.endif.endif.i:                   ; preds = %B1908.else.endif.endif.if.i, %B1908.else.endif.endif.i
  %.7015.sroa.13.1.i = phi i64 [ 0, %B1908.else.endif.endif.if.i ], [ %.7044.i, %B1908.else.endif.endif.i ]
  %.7052.not.i = icmp slt i64 %.7044.i, %arg.n_table
  br i1 %.7052.not.i, label %B1908.else.endif.endif.endif.endif.i, label %B1908.else.endif.endif.endif.if.i, !prof !10

B1908.else.endif.endif.endif.if.i:                ; preds = %B1908.else.endif.endif.endif.i
  br label %B1908.else.endif.endif.endif.endif.i

B1908.else.endif.endif.endif.endif.i:             ; preds = %B1908.else.endif.endif.endif.if.i, %B1908.else.endif.endif.endif.i
  %.7015.sroa.13.2.i = phi i64 [ %arg.n_table, %B1908.else.endif.endif.endif.if.i ], [ %.7015.sroa.13.1.i, %B1908.else.endif.endif.endif.i ]
  %.7103.i = sub i64 %.7015.sroa.13.2.i, %.7015.sroa.0.3.i
  %.7112.i = tail call i64 @llvm.smax.i64(i64 %.7103.i, i64 0)
  %.7128.i = getelementptr double, ptr %arg.linear, i64 %.7015.sroa.0.3.i
  %.7181.i = icmp slt i64 %.4310.sroa.0.061.i, 0
  %.7182.i = select i1 %.7181.i, i64 %.1143.i, i64 0
  %.idx92.i = mul i64 %.4310.sroa.0.061.i, 24
  %157 = getelementptr i8, ptr %.1159.i, i64 %.idx92.i
  %.7196.i = getelementptr double, ptr %157, i64 %.7182.i
  %.7197.i = load double, ptr %.7196.i, align 8, !noalias !1
  %158 = getelementptr i8, ptr %157, i64 8
  %.7229.i = getelementptr double, ptr %158, i64 %.7182.i
  %.7230.i = load double, ptr %.7229.i, align 8, !noalias !1
  %.7475.i = select i1 %.8522.i, i64 %.7112.i, i64 0
  %.7476.i = add i64 %.7475.i, %.3625.sroa.0.068.i
  %.7654.i = select i1 %7, i64 %.7112.i, i64 0
  %.7655.i = add i64 %.7654.i, %.7611.i
  br i1 %60, label %B2054.preheader.i, label %B2658.i

B2054.preheader.i:                                ; preds = %B1908.else.endif.endif.endif.endif.i
  %sunkaddr.i = shl i64 %.7182.i, 3
  %sunkaddr100.i = getelementptr i8, ptr %157, i64 %sunkaddr.i
  %sunkaddr101.i = getelementptr i8, ptr %sunkaddr100.i, i64 16
  %159 = icmp slt i64 %.7476.i, 0
  %160 = icmp slt i64 %.7476.i, %.7112.i
  %161 = icmp slt i64 %.7655.i, 0
  %162 = icmp slt i64 %.7655.i, %.7112.i
  br label %B2054.i

B2136.else.if.i:                                  ; preds = %B2136.i
  br label %B2136.else.endif.i

B2136.else.endif.i:                               ; preds = %B2136.else.if.i, %B2136.i
  %.7464.sroa.0.1.i = phi i64 [ 0, %B2136.else.if.i ], [ %.7476.i, %B2136.i ]
  br i1 %160, label %B2136.else.endif.endif.i, label %B2136.else.endif.if.i, !prof !10

B2136.else.endif.if.i:                            ; preds = %B2136.else.endif.i
  br label %B2136.else.endif.endif.i

B2136.else.endif.endif.i:                         ; preds = %B2136.else.endif.if.i, %B2136.else.endif.i
  %.7464.sroa.0.3.i = phi i64 [ %.7112.i, %B2136.else.endif.if.i ], [ %.7464.sroa.0.1.i, %B2136.else.endif.i ]
  %.7577.i = getelementptr double, ptr %.7128.i, i64 %.7464.sroa.0.3.i
  br i1 %161, label %B2136.endif.else.if.i, label %B2136.endif.else.endif.i, !prof !0

B2136.endif.else.if.i:                            ; preds = %B2136.else.endif.endif.i
  br label %B2136.endif.else.endif.i

B2136.endif.else.endif.i:                         ; preds = %B2136.endif.else.if.i, %B2136.else.endif.endif.i
  %.7643.sroa.0.1.i = phi i64 [ 0, %B2136.endif.else.if.i ], [ %.7655.i, %B2136.else.endif.endif.i ]
  br i1 %162, label %B2136.endif.else.endif.endif.i, label %B2136.endif.else.endif.if.i, !prof !10

B2136.endif.else.endif.if.i:                      ; preds = %B2136.endif.else.endif.i
  br label %B2136.endif.else.endif.endif.i

B2136.endif.else.endif.endif.i:                   ; preds = %B2136.endif.else.endif.if.i, %B2136.endif.else.endif.i
  %.7643.sroa.0.3.i = phi i64 [ %.7112.i, %B2136.endif.else.endif.if.i ], [ %.7643.sroa.0.1.i, %B2136.endif.else.endif.i ]
  %.7756.i = getelementptr double, ptr %.7128.i, i64 %.7643.sroa.0.3.i
  br i1 %22, label %B2136.endif.endif.else.if.i, label %B2136.endif.endif.else.endif.i, !prof !0

B2136.endif.endif.else.if.i:                      ; preds = %B2136.endif.else.endif.endif.i
  br label %B2136.endif.endif.else.endif.i

B2136.endif.endif.else.endif.i:                   ; preds = %B2136.endif.endif.else.if.i, %B2136.endif.else.endif.endif.i
  %.7825.sroa.0.1.i = phi i64 [ 0, %B2136.endif.endif.else.if.i ], [ %.7837.i, %B2136.endif.else.endif.endif.i ]
  br i1 %23, label %B2136.endif.endif.else.endif.endif.i, label %B2136.endif.endif.else.endif.if.i, !prof !10

B2136.endif.endif.else.endif.if.i:                ; preds = %B2136.endif.endif.else.endif.i
  br label %B2136.endif.endif.else.endif.endif.i

B2136.endif.endif.else.endif.endif.i:             ; preds = %B2136.endif.endif.else.endif.if.i, %B2136.endif.endif.else.endif.i
  %.7825.sroa.0.3.i = phi i64 [ %arg.n_f, %B2136.endif.endif.else.endif.if.i ], [ %.7825.sroa.0.1.i, %B2136.endif.endif.else.endif.i ]
  br i1 %20, label %B2136.endif.endif.else.endif.endif.if.i, label %B2136.endif.endif.else.endif.endif.endif.i, !prof !0

B2136.endif.endif.else.endif.endif.if.i:          ; preds = %B2136.endif.endif.else.endif.endif.i
  br label %B2136.endif.endif.else.endif.endif.endif.i

B2136.endif.endif.else.endif.endif.endif.i:       ; preds = %B2136.endif.endif.else.endif.endif.if.i, %B2136.endif.endif.else.endif.endif.i
  %.7825.sroa.13.1.i = phi i64 [ 0, %B2136.endif.endif.else.endif.endif.if.i ], [ %.8541.i, %B2136.endif.endif.else.endif.endif.i ]
  br i1 %21, label %B2136.endif.endif.else.endif.endif.endif.endif.i, label %B2136.endif.endif.else.endif.endif.endif.if.i, !prof !10

B2136.endif.endif.else.endif.endif.endif.if.i:    ; preds = %B2136.endif.endif.else.endif.endif.endif.i
  br label %B2136.endif.endif.else.endif.endif.endif.endif.i

B2136.endif.endif.else.endif.endif.endif.endif.i: ; preds = %B2136.endif.endif.else.endif.endif.endif.if.i, %B2136.endif.endif.else.endif.endif.endif.i
  %.7825.sroa.13.2.i = phi i64 [ %arg.n_f, %B2136.endif.endif.else.endif.endif.endif.if.i ], [ %.7825.sroa.13.1.i, %B2136.endif.endif.else.endif.endif.endif.i ]
  %.7913.i = sub i64 %.7825.sroa.13.2.i, %.7825.sroa.0.3.i
  %.7938.i = getelementptr double, ptr %arg.f, i64 %.7825.sroa.0.3.i
  br i1 %91, label %B2136.endif.endif.endif.else.endif.if.i, label %B2136.endif.endif.endif.else.endif.endif.i, !prof !0

B2136.endif.endif.endif.else.endif.if.i:          ; preds = %B2136.endif.endif.else.endif.endif.endif.endif.i
  br label %B2136.endif.endif.endif.else.endif.endif.i

B2136.endif.endif.endif.else.endif.endif.i:       ; preds = %B2136.endif.endif.endif.else.endif.if.i, %B2136.endif.endif.else.endif.endif.endif.endif.i
  %.7997.sroa.0.3.i = phi i64 [ %.2058.i, %B2136.endif.endif.endif.else.endif.if.i ], [ 0, %B2136.endif.endif.else.endif.endif.endif.endif.i ]
  %.8110.i = getelementptr double, ptr %.2074.i, i64 %.7997.sroa.0.3.i
  br i1 %92, label %B2136.endif.endif.endif.endif.else.endif.if.i, label %B2136.endif.endif.endif.endif.else.endif.endif.i, !prof !0

B2136.endif.endif.endif.endif.else.endif.if.i:    ; preds = %B2136.endif.endif.endif.else.endif.endif.i
  br label %B2136.endif.endif.endif.endif.else.endif.endif.i

B2136.endif.endif.endif.endif.else.endif.endif.i: ; preds = %B2136.endif.endif.endif.endif.else.endif.if.i, %B2136.endif.endif.endif.else.endif.endif.i
  %.8169.sroa.0.3.i = phi i64 [ %.2233.i, %B2136.endif.endif.endif.endif.else.endif.if.i ], [ 0, %B2136.endif.endif.endif.else.endif.endif.i ]
  %.8282.i = getelementptr double, ptr %.2249.i, i64 %.8169.sroa.0.3.i
  %.104.i157.i = fmul contract double %.7427.i, 0xC01921FB54442D18
  %.200239.not.i.i = icmp slt i64 %.7913.i, 1
  br i1 %.200239.not.i.i, label %B2444.else.endif.i, label %B78.if.i.i

B78.if.i.i:                                       ; preds = %B2136.endif.endif.endif.endif.else.endif.endif.i, %B78.if.i.i
  %.206238240.i.i = phi i64 [ %.213.i158.i, %B78.if.i.i ], [ 0, %B2136.endif.endif.endif.endif.else.endif.endif.i ]
  %.213.i158.i = add nuw nsw i64 %.206238240.i.i, 1
  %163 = shl i64 %.206238240.i.i, 3
  %scevgep6.i159.i = getelementptr i8, ptr %.7938.i, i64 %163
  %.268.i.i = load double, ptr %scevgep6.i159.i, align 8, !noalias !23
  %.270.i.i = fmul contract double %.104.i157.i, %.268.i.i
  %.271.i.i = tail call contract double @llvm.fma.f64(double %.270.i.i, double 0x3FE45F306DC9C883, double 0x4338000000000000)
  %.272.i.i = fadd contract double %.271.i.i, 0xC338000000000000
  %.287.i160.i = tail call contract double @llvm.fma.f64(double %.272.i.i, double 0xBFF921FB54442D18, double %.270.i.i)
  %.302.i.i = tail call contract double @llvm.fma.f64(double %.272.i.i, double 0xBC91A62633145C07, double %.287.i160.i)
  %.303.i.i = fmul contract double %.302.i.i, %.302.i.i
  %.304.i.i = tail call contract double @llvm.fma.f64(double %.303.i.i, double 0xBD6AE7F3E733B81F, double 0x3DE6124613A86D09)
  %.305.i.i = tail call contract double @llvm.fma.f64(double %.303.i.i, double %.304.i.i, double 0xBE5AE64567F544E4)
  %.306.i.i = tail call contract double @llvm.fma.f64(double %.303.i.i, double %.305.i.i, double 0x3EC71DE3A556C734)
  %.307.i.i = tail call contract double @llvm.fma.f64(double %.303.i.i, double %.306.i.i, double 0xBF2A01A01A01A01A)
  %.308.i.i = tail call contract double @llvm.fma.f64(double %.303.i.i, double %.307.i.i, double 0x3F81111111111111)
  %.309.i.i = tail call contract double @llvm.fma.f64(double %.303.i.i, double %.308.i.i, double 0xBFC5555555555555)
  %.310.i.i = fmul contract double %.302.i.i, %.303.i.i
  %.311.i.i = tail call contract double @llvm.fma.f64(double %.310.i.i, double %.309.i.i, double %.302.i.i)
  %.312.i.i = tail call contract double @llvm.fma.f64(double %.303.i.i, double 0x3D2AE7F3E733B81F, double 0xBDA93974A8C07C9D)
  %.313.i.i = tail call contract double @llvm.fma.f64(double %.303.i.i, double %.312.i.i, double 0x3E21EED8EFF8D898)
  %.314.i.i = tail call contract double @llvm.fma.f64(double %.303.i.i, double %.313.i.i, double 0xBE927E4FB7789F5C)
  %.315.i.i = tail call contract double @llvm.fma.f64(double %.303.i.i, double %.314.i.i, double 0x3EFA01A01A01A01A)
  %.316.i.i = tail call contract double @llvm.fma.f64(double %.303.i.i, double %.315.i.i, double 0xBF56C16C16C16C17)
  %.317.i.i = tail call contract double @llvm.fma.f64(double %.303.i.i, double %.316.i.i, double 0x3FA5555555555555)
  %.318.i.i = tail call contract double @llvm.fma.f64(double %.303.i.i, double %.317.i.i, double -5.000000e-01)
  %.319.i161.i = tail call contract double @llvm.fma.f64(double %.303.i.i, double %.318.i.i, double 1.000000e+00)
  %.320.i162.i = bitcast double %.271.i.i to i64
  %.321.i.i = bitcast double %.311.i.i to i64
  %.322.i.i = bitcast double %.319.i161.i to i64
  %.323.i.i = xor i64 %.322.i.i, %.321.i.i
  %.324.i163.i = and i64 %.320.i162.i, 1
  %164 = icmp eq i64 %.324.i163.i, 0
  %.326.i.i = select i1 %164, i64 0, i64 %.323.i.i
  %.327.i.i = shl i64 %.320.i162.i, 62
  %.328.i.i = and i64 %.327.i.i, -9223372036854775808
  %.330.i.i = add i64 %.327.i.i, 4611686018427387904
  %.331.i.i = and i64 %.330.i.i, -9223372036854775808
  %165 = xor i64 %.328.i.i, %.321.i.i
  %.333.i.i = xor i64 %165, %.326.i.i
  %.334.i.i = bitcast i64 %.333.i.i to double
  %166 = xor i64 %.331.i.i, %.322.i.i
  %.336.i.i = xor i64 %166, %.326.i.i
  %.337.i.i = bitcast i64 %.336.i.i to double
  %scevgep55.i = getelementptr i8, ptr %sr.2.sroa.36.3.i, i64 %163
  %.387.i.i = load double, ptr %scevgep55.i, align 8, !noalias !23
  %.388.i.i = fmul contract double %.387.i.i, %.337.i.i
  %scevgep54.i = getelementptr i8, ptr %si.2.sroa.36.3.i, i64 %163
  %.418.i.i = load double, ptr %scevgep54.i, align 8, !noalias !23
  %.419.i.i = fmul contract double %.418.i.i, %.334.i.i
  %.420.i.i = fsub contract double %.388.i.i, %.419.i.i
  %.451.i.i = fmul contract double %.387.i.i, %.334.i.i
  %.482.i.i = fmul contract double %.418.i.i, %.337.i.i
  %.483.i.i = fadd contract double %.451.i.i, %.482.i.i
  %scevgep53.i = getelementptr i8, ptr %.7577.i, i64 %163
  %.513.i.i = load double, ptr %scevgep53.i, align 8, !noalias !23
  %.514.i.i = fmul contract double %.513.i.i, %.420.i.i
  %scevgep52.i = getelementptr i8, ptr %.7756.i, i64 %163
  %.544.i.i = load double, ptr %scevgep52.i, align 8, !noalias !23
  %.545.i.i = fmul contract double %.544.i.i, %.483.i.i
  %.546.i.i = fsub contract double %.514.i.i, %.545.i.i
  %scevgep51.i = getelementptr i8, ptr %.8110.i, i64 %163
  store double %.546.i.i, ptr %scevgep51.i, align 8, !noalias !23
  %.606.i.i = load double, ptr %scevgep53.i, align 8, !noalias !23
  %.607.i.i = fmul contract double %.606.i.i, %.483.i.i
  %.637.i.i = load double, ptr %scevgep52.i, align 8, !noalias !23
  %.638.i.i = fmul contract double %.637.i.i, %.420.i.i
  %.639.i.i = fadd contract double %.607.i.i, %.638.i.i
  %scevgep50.i = getelementptr i8, ptr %.8282.i, i64 %163
  store double %.639.i.i, ptr %scevgep50.i, align 8, !noalias !23
  %exitcond.not.i170.i = icmp eq i64 %.7913.i, %.213.i158.i
  br i1 %exitcond.not.i170.i, label %B2444.else.endif.i, label %B78.if.i.i

B2300.endif.else.if.i:                            ; preds = %B2300.i
  br label %B2300.endif.else.endif.i

B2300.endif.else.endif.i:                         ; preds = %B2300.endif.else.if.i, %B2300.i
  %.8512.sroa.0.1.i = phi i64 [ 0, %B2300.endif.else.if.i ], [ %.8524.i, %B2300.i ]
  br i1 %19, label %B2300.endif.else.endif.endif.i, label %B2300.endif.else.endif.if.i, !prof !10

B2300.endif.else.endif.if.i:                      ; preds = %B2300.endif.else.endif.i
  br label %B2300.endif.else.endif.endif.i

B2300.endif.else.endif.endif.i:                   ; preds = %B2300.endif.else.endif.if.i, %B2300.endif.else.endif.i
  %.8512.sroa.0.3.i = phi i64 [ %arg.n_f, %B2300.endif.else.endif.if.i ], [ %.8512.sroa.0.1.i, %B2300.endif.else.endif.i ]
  br i1 %20, label %B2300.endif.else.endif.endif.if.i, label %B2300.endif.else.endif.endif.endif.i, !prof !0

B2300.endif.else.endif.endif.if.i:                ; preds = %B2300.endif.else.endif.endif.i
  br label %B2300.endif.else.endif.endif.endif.i

B2300.endif.else.endif.endif.endif.i:             ; preds = %B2300.endif.else.endif.endif.if.i, %B2300.endif.else.endif.endif.i
  %.8512.sroa.13.1.i = phi i64 [ 0, %B2300.endif.else.endif.endif.if.i ], [ %.8541.i, %B2300.endif.else.endif.endif.i ]
  br i1 %21, label %B2300.endif.else.endif.endif.endif.endif.i, label %B2300.endif.else.endif.endif.endif.if.i, !prof !10

B2300.endif.else.endif.endif.endif.if.i:          ; preds = %B2300.endif.else.endif.endif.endif.i
  br label %B2300.endif.else.endif.endif.endif.endif.i

B2300.endif.else.endif.endif.endif.endif.i:       ; preds = %B2300.endif.else.endif.endif.endif.if.i, %B2300.endif.else.endif.endif.endif.i
  %.8512.sroa.13.2.i = phi i64 [ %arg.n_f, %B2300.endif.else.endif.endif.endif.if.i ], [ %.8512.sroa.13.1.i, %B2300.endif.else.endif.endif.endif.i ]
  %.8600.i = sub i64 %.8512.sroa.13.2.i, %.8512.sroa.0.3.i
  %.8625.i = getelementptr double, ptr %arg.f, i64 %.8512.sroa.0.3.i
  br i1 %91, label %B2300.endif.endif.else.endif.if.i, label %B2300.endif.endif.else.endif.endif.i, !prof !0

B2300.endif.endif.else.endif.if.i:                ; preds = %B2300.endif.else.endif.endif.endif.endif.i
  br label %B2300.endif.endif.else.endif.endif.i

B2300.endif.endif.else.endif.endif.i:             ; preds = %B2300.endif.endif.else.endif.if.i, %B2300.endif.else.endif.endif.endif.endif.i
  %.8684.sroa.0.3.i = phi i64 [ %.2058.i, %B2300.endif.endif.else.endif.if.i ], [ 0, %B2300.endif.else.endif.endif.endif.endif.i ]
  %.8797.i = getelementptr double, ptr %.2074.i, i64 %.8684.sroa.0.3.i
  br i1 %92, label %B2300.endif.endif.endif.else.endif.if.i, label %B2300.endif.endif.endif.else.endif.endif.i, !prof !0

B2300.endif.endif.endif.else.endif.if.i:          ; preds = %B2300.endif.endif.else.endif.endif.i
  br label %B2300.endif.endif.endif.else.endif.endif.i

B2300.endif.endif.endif.else.endif.endif.i:       ; preds = %B2300.endif.endif.endif.else.endif.if.i, %B2300.endif.endif.else.endif.endif.i
  %.8856.sroa.0.3.i = phi i64 [ %.2233.i, %B2300.endif.endif.endif.else.endif.if.i ], [ 0, %B2300.endif.endif.else.endif.endif.i ]
  %.8969.i = getelementptr double, ptr %.2249.i, i64 %.8856.sroa.0.3.i
  %.215.i.i = icmp slt i64 %.267.i.i, 0
  %.216.i.i = select i1 %.215.i.i, i64 %.7112.i, i64 0
  %.217.i43.i = add i64 %.216.i.i, %.267.i.i
  %.220.i44.i = icmp slt i64 %.217.i43.i, 0
  br i1 %.220.i44.i, label %B0.else.if.i.i, label %B0.else.endif.i.i, !prof !0

B0.else.if.i.i:                                   ; preds = %B2300.endif.endif.endif.else.endif.endif.i
  br label %B0.else.endif.i.i

B0.else.endif.i.i:                                ; preds = %B0.else.if.i.i, %B2300.endif.endif.endif.else.endif.endif.i
  %.205.sroa.0.1.i.i = phi i64 [ 0, %B0.else.if.i.i ], [ %.217.i43.i, %B2300.endif.endif.endif.else.endif.endif.i ]
  %.225.not.i.i = icmp slt i64 %.217.i43.i, %.7112.i
  br i1 %.225.not.i.i, label %B0.else.endif.endif.endif.endif.i.i, label %B0.else.endif.if.i.i, !prof !10

B0.else.endif.if.i.i:                             ; preds = %B0.else.endif.i.i
  br label %B0.else.endif.endif.endif.endif.i.i

B0.else.endif.endif.endif.endif.i.i:              ; preds = %B0.else.endif.if.i.i, %B0.else.endif.i.i
  %.205.sroa.0.3.i.i = phi i64 [ %.7112.i, %B0.else.endif.if.i.i ], [ %.205.sroa.0.1.i.i, %B0.else.endif.i.i ]
  %.318.i45.i = getelementptr double, ptr %.7128.i, i64 %.205.sroa.0.3.i.i
  %.350.i46.i = add nsw i64 %.267.i.i, %arg.n_f
  %.388.i47.i = icmp slt i64 %.350.i46.i, 0
  %.389.i.i = select i1 %.388.i47.i, i64 %.7112.i, i64 0
  %.390.i.i = add i64 %.389.i.i, %.350.i46.i
  %.393.i.i = icmp slt i64 %.390.i.i, 0
  br i1 %.393.i.i, label %B0.endif.else.if.i.i, label %B0.endif.else.endif.i.i, !prof !0

B0.endif.else.if.i.i:                             ; preds = %B0.else.endif.endif.endif.endif.i.i
  br label %B0.endif.else.endif.i.i

B0.endif.else.endif.i.i:                          ; preds = %B0.endif.else.if.i.i, %B0.else.endif.endif.endif.endif.i.i
  %.378.sroa.0.1.i.i = phi i64 [ 0, %B0.endif.else.if.i.i ], [ %.390.i.i, %B0.else.endif.endif.endif.endif.i.i ]
  %.398.not.i.i = icmp slt i64 %.390.i.i, %.7112.i
  br i1 %.398.not.i.i, label %B0.endif.else.endif.endif.endif.endif.i.i, label %B0.endif.else.endif.if.i.i, !prof !10

B0.endif.else.endif.if.i.i:                       ; preds = %B0.endif.else.endif.i.i
  br label %B0.endif.else.endif.endif.endif.endif.i.i

B0.endif.else.endif.endif.endif.endif.i.i:        ; preds = %B0.endif.else.endif.if.i.i, %B0.endif.else.endif.i.i
  %.378.sroa.0.3.i.i = phi i64 [ %.7112.i, %B0.endif.else.endif.if.i.i ], [ %.378.sroa.0.1.i.i, %B0.endif.else.endif.i.i ]
  %.491.i48.i = getelementptr double, ptr %.7128.i, i64 %.378.sroa.0.3.i.i
  %.541.i49.i = add nsw i64 %.267.i.i, %.904.i
  %.578.i.i = icmp slt i64 %.541.i49.i, 0
  %.579.i.i = select i1 %.578.i.i, i64 %.7112.i, i64 0
  %.580.i.i = add i64 %.579.i.i, %.541.i49.i
  %.583.i.i = icmp slt i64 %.580.i.i, 0
  br i1 %.583.i.i, label %B0.endif.endif.else.if.i.i, label %B0.endif.endif.else.endif.i.i, !prof !0

B0.endif.endif.else.if.i.i:                       ; preds = %B0.endif.else.endif.endif.endif.endif.i.i
  br label %B0.endif.endif.else.endif.i.i

B0.endif.endif.else.endif.i.i:                    ; preds = %B0.endif.endif.else.if.i.i, %B0.endif.else.endif.endif.endif.endif.i.i
  %.568.sroa.0.1.i.i = phi i64 [ 0, %B0.endif.endif.else.if.i.i ], [ %.580.i.i, %B0.endif.else.endif.endif.endif.endif.i.i ]
  %.588.not.i.i = icmp slt i64 %.580.i.i, %.7112.i
  br i1 %.588.not.i.i, label %B0.endif.endif.else.endif.endif.endif.endif.i.i, label %B0.endif.endif.else.endif.if.i.i, !prof !10

B0.endif.endif.else.endif.if.i.i:                 ; preds = %B0.endif.endif.else.endif.i.i
  br label %B0.endif.endif.else.endif.endif.endif.endif.i.i

B0.endif.endif.else.endif.endif.endif.endif.i.i:  ; preds = %B0.endif.endif.else.endif.if.i.i, %B0.endif.endif.else.endif.i.i
  %.568.sroa.0.3.i.i = phi i64 [ %.7112.i, %B0.endif.endif.else.endif.if.i.i ], [ %.568.sroa.0.1.i.i, %B0.endif.endif.else.endif.i.i ]
  %.681.i.i = getelementptr double, ptr %.7128.i, i64 %.568.sroa.0.3.i.i
  %.713.i.i = add nsw i64 %.541.i49.i, %arg.n_f
  %.751.i.i = icmp slt i64 %.713.i.i, 0
  %.752.i.i = select i1 %.751.i.i, i64 %.7112.i, i64 0
  %.753.i.i = add i64 %.752.i.i, %.713.i.i
  %.756.i.i = icmp slt i64 %.753.i.i, 0
  br i1 %.756.i.i, label %B0.endif.endif.endif.else.if.i.i, label %B0.endif.endif.endif.else.endif.i.i, !prof !0

B0.endif.endif.endif.else.if.i.i:                 ; preds = %B0.endif.endif.else.endif.endif.endif.endif.i.i
  br label %B0.endif.endif.endif.else.endif.i.i

B0.endif.endif.endif.else.endif.i.i:              ; preds = %B0.endif.endif.endif.else.if.i.i, %B0.endif.endif.else.endif.endif.endif.endif.i.i
  %.741.sroa.0.1.i.i = phi i64 [ 0, %B0.endif.endif.endif.else.if.i.i ], [ %.753.i.i, %B0.endif.endif.else.endif.endif.endif.endif.i.i ]
  %.761.not.i.i = icmp slt i64 %.753.i.i, %.7112.i
  br i1 %.761.not.i.i, label %B0.endif.endif.endif.else.endif.endif.endif.endif.i.i, label %B0.endif.endif.endif.else.endif.if.i.i, !prof !10

B0.endif.endif.endif.else.endif.if.i.i:           ; preds = %B0.endif.endif.endif.else.endif.i.i
  br label %B0.endif.endif.endif.else.endif.endif.endif.endif.i.i

B0.endif.endif.endif.else.endif.endif.endif.endif.i.i: ; preds = %B0.endif.endif.endif.else.endif.if.i.i, %B0.endif.endif.endif.else.endif.i.i
  %.741.sroa.0.3.i.i = phi i64 [ %.7112.i, %B0.endif.endif.endif.else.endif.if.i.i ], [ %.741.sroa.0.1.i.i, %B0.endif.endif.endif.else.endif.i.i ]
  %.854.i.i = getelementptr double, ptr %.7128.i, i64 %.741.sroa.0.3.i.i
  %.904.i.i = add nsw i64 %.541.i49.i, %.904.i
  %.941.i.i = icmp slt i64 %.904.i.i, 0
  %.942.i.i = select i1 %.941.i.i, i64 %.7112.i, i64 0
  %.943.i.i = add i64 %.942.i.i, %.904.i.i
  %.946.i50.i = icmp slt i64 %.943.i.i, 0
  br i1 %.946.i50.i, label %B0.endif.endif.endif.endif.else.if.i.i, label %B0.endif.endif.endif.endif.else.endif.i.i, !prof !0

B0.endif.endif.endif.endif.else.if.i.i:           ; preds = %B0.endif.endif.endif.else.endif.endif.endif.endif.i.i
  br label %B0.endif.endif.endif.endif.else.endif.i.i

B0.endif.endif.endif.endif.else.endif.i.i:        ; preds = %B0.endif.endif.endif.endif.else.if.i.i, %B0.endif.endif.endif.else.endif.endif.endif.endif.i.i
  %.931.sroa.0.1.i.i = phi i64 [ 0, %B0.endif.endif.endif.endif.else.if.i.i ], [ %.943.i.i, %B0.endif.endif.endif.else.endif.endif.endif.endif.i.i ]
  %.951.not.i.i = icmp slt i64 %.943.i.i, %.7112.i
  br i1 %.951.not.i.i, label %B0.endif.endif.endif.endif.else.endif.endif.endif.endif.i.i, label %B0.endif.endif.endif.endif.else.endif.if.i.i, !prof !10

B0.endif.endif.endif.endif.else.endif.if.i.i:     ; preds = %B0.endif.endif.endif.endif.else.endif.i.i
  br label %B0.endif.endif.endif.endif.else.endif.endif.endif.endif.i.i

B0.endif.endif.endif.endif.else.endif.endif.endif.endif.i.i: ; preds = %B0.endif.endif.endif.endif.else.endif.if.i.i, %B0.endif.endif.endif.endif.else.endif.i.i
  %.931.sroa.0.3.i.i = phi i64 [ %.7112.i, %B0.endif.endif.endif.endif.else.endif.if.i.i ], [ %.931.sroa.0.1.i.i, %B0.endif.endif.endif.endif.else.endif.i.i ]
  %.1044.i.i = getelementptr double, ptr %.7128.i, i64 %.931.sroa.0.3.i.i
  %.1076.i.i = add nsw i64 %.904.i.i, %arg.n_f
  %.1114.i.i = icmp slt i64 %.1076.i.i, 0
  %.1115.i.i = select i1 %.1114.i.i, i64 %.7112.i, i64 0
  %.1116.i.i = add i64 %.1115.i.i, %.1076.i.i
  %.1119.i.i = icmp slt i64 %.1116.i.i, 0
  br i1 %.1119.i.i, label %B0.endif.endif.endif.endif.endif.else.if.i.i, label %B0.endif.endif.endif.endif.endif.else.endif.i.i, !prof !0

B0.endif.endif.endif.endif.endif.else.if.i.i:     ; preds = %B0.endif.endif.endif.endif.else.endif.endif.endif.endif.i.i
  br label %B0.endif.endif.endif.endif.endif.else.endif.i.i

B0.endif.endif.endif.endif.endif.else.endif.i.i:  ; preds = %B0.endif.endif.endif.endif.endif.else.if.i.i, %B0.endif.endif.endif.endif.else.endif.endif.endif.endif.i.i
  %.1104.sroa.0.1.i.i = phi i64 [ 0, %B0.endif.endif.endif.endif.endif.else.if.i.i ], [ %.1116.i.i, %B0.endif.endif.endif.endif.else.endif.endif.endif.endif.i.i ]
  %.1124.not.i.i = icmp slt i64 %.1116.i.i, %.7112.i
  br i1 %.1124.not.i.i, label %B0.endif.endif.endif.endi...endif.i.i, label %B0.endif.endif.endif.endif.endif.else.endif.if.i.i, !prof !10

B0.endif.endif.endif.endif.endif.else.endif.if.i.i: ; preds = %B0.endif.endif.endif.endif.endif.else.endif.i.i
  br label %B0.endif.endif.endif.endi...endif.i.i

B0.endif.endif.endif.endi...endif.i.i:            ; preds = %B0.endif.endif.endif.endif.endif.else.endif.if.i.i, %B0.endif.endif.endif.endif.endif.else.endif.i.i
  %.1104.sroa.0.3.i.i = phi i64 [ %.7112.i, %B0.endif.endif.endif.endif.endif.else.endif.if.i.i ], [ %.1104.sroa.0.1.i.i, %B0.endif.endif.endif.endif.endif.else.endif.i.i ]
  %.1217.i.i = getelementptr double, ptr %.7128.i, i64 %.1104.sroa.0.3.i.i
  %.1267.i.i = add nsw i64 %.904.i.i, %.904.i
  %.1304.i.i = icmp slt i64 %.1267.i.i, 0
  %.1305.i.i = select i1 %.1304.i.i, i64 %.7112.i, i64 0
  %.1306.i.i = add i64 %.1305.i.i, %.1267.i.i
  %.1309.i.i = icmp slt i64 %.1306.i.i, 0
  br i1 %.1309.i.i, label %B0.endif.endif.endif.endif.endif.endif.else.if.i.i, label %B0.endif.endif.endif.endif.endif.endif.else.endif.i.i, !prof !0

B0.endif.endif.endif.endif.endif.endif.else.if.i.i: ; preds = %B0.endif.endif.endif.endi...endif.i.i
  br label %B0.endif.endif.endif.endif.endif.endif.else.endif.i.i

B0.endif.endif.endif.endif.endif.endif.else.endif.i.i: ; preds = %B0.endif.endif.endif.endif.endif.endif.else.if.i.i, %B0.endif.endif.endif.endi...endif.i.i
  %.1294.sroa.0.1.i.i = phi i64 [ 0, %B0.endif.endif.endif.endif.endif.endif.else.if.i.i ], [ %.1306.i.i, %B0.endif.endif.endif.endi...endif.i.i ]
  %.1314.not.i.i = icmp slt i64 %.1306.i.i, %.7112.i
  br i1 %.1314.not.i.i, label %B0.endif.endif.endif.endi...endif.2.endif.i.i, label %B0.endif.endif.endif.endif.endif.endif.else.endif.if.i.i, !prof !10

B0.endif.endif.endif.endif.endif.endif.else.endif.if.i.i: ; preds = %B0.endif.endif.endif.endif.endif.endif.else.endif.i.i
  br label %B0.endif.endif.endif.endi...endif.2.endif.i.i

B0.endif.endif.endif.endi...endif.2.endif.i.i:    ; preds = %B0.endif.endif.endif.endif.endif.endif.else.endif.if.i.i, %B0.endif.endif.endif.endif.endif.endif.else.endif.i.i
  %.1294.sroa.0.3.i.i = phi i64 [ %.7112.i, %B0.endif.endif.endif.endif.endif.endif.else.endif.if.i.i ], [ %.1294.sroa.0.1.i.i, %B0.endif.endif.endif.endif.endif.endif.else.endif.i.i ]
  %.1407.i.i = getelementptr double, ptr %.7128.i, i64 %.1294.sroa.0.3.i.i
  %.1439.i.i = add nsw i64 %.1267.i.i, %arg.n_f
  %.1477.i.i = icmp slt i64 %.1439.i.i, 0
  %.1478.i.i = select i1 %.1477.i.i, i64 %.7112.i, i64 0
  %.1479.i.i = add i64 %.1478.i.i, %.1439.i.i
  %.1482.i.i = icmp slt i64 %.1479.i.i, 0
  br i1 %.1482.i.i, label %B0.endif.endif.endif.endif.endif.endif.endif.else.if.i.i, label %B0.endif.endif.endif.endif.endif.endif.endif.else.endif.i.i, !prof !0

B0.endif.endif.endif.endif.endif.endif.endif.else.if.i.i: ; preds = %B0.endif.endif.endif.endi...endif.2.endif.i.i
  br label %B0.endif.endif.endif.endif.endif.endif.endif.else.endif.i.i

B0.endif.endif.endif.endif.endif.endif.endif.else.endif.i.i: ; preds = %B0.endif.endif.endif.endif.endif.endif.endif.else.if.i.i, %B0.endif.endif.endif.endi...endif.2.endif.i.i
  %.1467.sroa.0.1.i.i = phi i64 [ 0, %B0.endif.endif.endif.endif.endif.endif.endif.else.if.i.i ], [ %.1479.i.i, %B0.endif.endif.endif.endi...endif.2.endif.i.i ]
  %.1487.not.i.i = icmp slt i64 %.1479.i.i, %.7112.i
  br i1 %.1487.not.i.i, label %B0.endif.endif.endif.endi...endif.4.endif.endif.i.i, label %B0.endif.endif.endif.endi...if.4.i.i, !prof !10

B0.endif.endif.endif.endi...if.4.i.i:             ; preds = %B0.endif.endif.endif.endif.endif.endif.endif.else.endif.i.i
  br label %B0.endif.endif.endif.endi...endif.4.endif.endif.i.i

B0.endif.endif.endif.endi...endif.4.endif.endif.i.i: ; preds = %B0.endif.endif.endif.endi...if.4.i.i, %B0.endif.endif.endif.endif.endif.endif.endif.else.endif.i.i
  %.1467.sroa.0.3.i.i = phi i64 [ %.7112.i, %B0.endif.endif.endif.endi...if.4.i.i ], [ %.1467.sroa.0.1.i.i, %B0.endif.endif.endif.endif.endif.endif.endif.else.endif.i.i ]
  %.1580.i.i = getelementptr double, ptr %.7128.i, i64 %.1467.sroa.0.3.i.i
  %.1630.i.i = add nsw i64 %.1267.i.i, %.904.i
  %.1667.i51.i = icmp slt i64 %.1630.i.i, 0
  %.1668.i.i = select i1 %.1667.i51.i, i64 %.7112.i, i64 0
  %.1669.i.i = add i64 %.1668.i.i, %.1630.i.i
  %.1672.i.i = icmp slt i64 %.1669.i.i, 0
  br i1 %.1672.i.i, label %B0.endif.endif.endif.endi...if.6.i.i, label %B0.endif.endif.endif.endi...endif.6.i.i, !prof !0

B0.endif.endif.endif.endi...if.6.i.i:             ; preds = %B0.endif.endif.endif.endi...endif.4.endif.endif.i.i
  br label %B0.endif.endif.endif.endi...endif.6.i.i

B0.endif.endif.endif.endi...endif.6.i.i:          ; preds = %B0.endif.endif.endif.endi...if.6.i.i, %B0.endif.endif.endif.endi...endif.4.endif.endif.i.i
  %.1657.sroa.0.1.i.i = phi i64 [ 0, %B0.endif.endif.endif.endi...if.6.i.i ], [ %.1669.i.i, %B0.endif.endif.endif.endi...endif.4.endif.endif.i.i ]
  %.1677.not.i.i = icmp slt i64 %.1669.i.i, %.7112.i
  br i1 %.1677.not.i.i, label %B0.endif.endif.endif.endi...endif.6.endif.endif.endif.i.i, label %B0.endif.endif.endif.endi...endif.6.if.i.i, !prof !10

B0.endif.endif.endif.endi...endif.6.if.i.i:       ; preds = %B0.endif.endif.endif.endi...endif.6.i.i
  br label %B0.endif.endif.endif.endi...endif.6.endif.endif.endif.i.i

B0.endif.endif.endif.endi...endif.6.endif.endif.endif.i.i: ; preds = %B0.endif.endif.endif.endi...endif.6.if.i.i, %B0.endif.endif.endif.endi...endif.6.i.i
  %.1657.sroa.0.3.i.i = phi i64 [ %.7112.i, %B0.endif.endif.endif.endi...endif.6.if.i.i ], [ %.1657.sroa.0.1.i.i, %B0.endif.endif.endif.endi...endif.6.i.i ]
  %.1770.i.i = getelementptr double, ptr %.7128.i, i64 %.1657.sroa.0.3.i.i
  %.1802.i.i = add nsw i64 %.1630.i.i, %arg.n_f
  %.1840.i.i = icmp slt i64 %.1802.i.i, 0
  %.1841.i.i = select i1 %.1840.i.i, i64 %.7112.i, i64 0
  %.1842.i.i = add i64 %.1841.i.i, %.1802.i.i
  %.1845.i.i = icmp slt i64 %.1842.i.i, 0
  br i1 %.1845.i.i, label %B0.endif.endif.endif.endi...else.if.i.i, label %B0.endif.endif.endif.endi...else.endif.i.i, !prof !0

B0.endif.endif.endif.endi...else.if.i.i:          ; preds = %B0.endif.endif.endif.endi...endif.6.endif.endif.endif.i.i
  br label %B0.endif.endif.endif.endi...else.endif.i.i

B0.endif.endif.endif.endi...else.endif.i.i:       ; preds = %B0.endif.endif.endif.endi...else.if.i.i, %B0.endif.endif.endif.endi...endif.6.endif.endif.endif.i.i
  %.1830.sroa.0.1.i.i = phi i64 [ 0, %B0.endif.endif.endif.endi...else.if.i.i ], [ %.1842.i.i, %B0.endif.endif.endif.endi...endif.6.endif.endif.endif.i.i ]
  %.1850.not.i.i = icmp slt i64 %.1842.i.i, %.7112.i
  br i1 %.1850.not.i.i, label %B0.endif.endif.endif.endi...else.endif.endif.endif.endif.i.i, label %B0.endif.endif.endif.endi...else.endif.if.i.i, !prof !10

B0.endif.endif.endif.endi...else.endif.if.i.i:    ; preds = %B0.endif.endif.endif.endi...else.endif.i.i
  br label %B0.endif.endif.endif.endi...else.endif.endif.endif.endif.i.i

B0.endif.endif.endif.endi...else.endif.endif.endif.endif.i.i: ; preds = %B0.endif.endif.endif.endi...else.endif.if.i.i, %B0.endif.endif.endif.endi...else.endif.i.i
  %.1830.sroa.0.3.i.i = phi i64 [ %.7112.i, %B0.endif.endif.endif.endi...else.endif.if.i.i ], [ %.1830.sroa.0.1.i.i, %B0.endif.endif.endif.endi...else.endif.i.i ]
  %.1943.i.i = getelementptr double, ptr %.7128.i, i64 %.1830.sroa.0.3.i.i
  %.1993.i.i = add nsw i64 %.1630.i.i, %.904.i
  %.2030.i.i = icmp slt i64 %.1993.i.i, 0
  %.2031.i.i = select i1 %.2030.i.i, i64 %.7112.i, i64 0
  %.2032.i.i = add i64 %.2031.i.i, %.1993.i.i
  %.2035.i.i = icmp slt i64 %.2032.i.i, 0
  br i1 %.2035.i.i, label %B0.endif.endif.endif.endi...endif.8.else.if.i.i, label %B0.endif.endif.endif.endi...endif.8.else.endif.i.i, !prof !0

B0.endif.endif.endif.endi...endif.8.else.if.i.i:  ; preds = %B0.endif.endif.endif.endi...else.endif.endif.endif.endif.i.i
  br label %B0.endif.endif.endif.endi...endif.8.else.endif.i.i

B0.endif.endif.endif.endi...endif.8.else.endif.i.i: ; preds = %B0.endif.endif.endif.endi...endif.8.else.if.i.i, %B0.endif.endif.endif.endi...else.endif.endif.endif.endif.i.i
  %.2020.sroa.0.1.i.i = phi i64 [ 0, %B0.endif.endif.endif.endi...endif.8.else.if.i.i ], [ %.2032.i.i, %B0.endif.endif.endif.endi...else.endif.endif.endif.endif.i.i ]
  %.2040.not.i.i = icmp slt i64 %.2032.i.i, %.7112.i
  br i1 %.2040.not.i.i, label %B0.endif.endif.endif.endi...endif.9.endif.i.i, label %B0.endif.endif.endif.endi...endif.8.else.endif.if.i.i, !prof !10

B0.endif.endif.endif.endi...endif.8.else.endif.if.i.i: ; preds = %B0.endif.endif.endif.endi...endif.8.else.endif.i.i
  br label %B0.endif.endif.endif.endi...endif.9.endif.i.i

B0.endif.endif.endif.endi...endif.9.endif.i.i:    ; preds = %B0.endif.endif.endif.endi...endif.8.else.endif.if.i.i, %B0.endif.endif.endif.endi...endif.8.else.endif.i.i
  %.2020.sroa.0.3.i.i = phi i64 [ %.7112.i, %B0.endif.endif.endif.endi...endif.8.else.endif.if.i.i ], [ %.2020.sroa.0.1.i.i, %B0.endif.endif.endif.endi...endif.8.else.endif.i.i ]
  %.2133.i.i = getelementptr double, ptr %.7128.i, i64 %.2020.sroa.0.3.i.i
  %.2165.i.i = add nsw i64 %.1993.i.i, %arg.n_f
  %.2203.i.i = icmp slt i64 %.2165.i.i, 0
  %.2204.i.i = select i1 %.2203.i.i, i64 %.7112.i, i64 0
  %.2205.i.i = add i64 %.2204.i.i, %.2165.i.i
  %.2208.i.i = icmp slt i64 %.2205.i.i, 0
  br i1 %.2208.i.i, label %B0.endif.endif.endif.endi...endif.8.endif.else.if.i.i, label %B0.endif.endif.endif.endi...endif.8.endif.else.endif.i.i, !prof !0

B0.endif.endif.endif.endi...endif.8.endif.else.if.i.i: ; preds = %B0.endif.endif.endif.endi...endif.9.endif.i.i
  br label %B0.endif.endif.endif.endi...endif.8.endif.else.endif.i.i

B0.endif.endif.endif.endi...endif.8.endif.else.endif.i.i: ; preds = %B0.endif.endif.endif.endi...endif.8.endif.else.if.i.i, %B0.endif.endif.endif.endi...endif.9.endif.i.i
  %.2193.sroa.0.1.i.i = phi i64 [ 0, %B0.endif.endif.endif.endi...endif.8.endif.else.if.i.i ], [ %.2205.i.i, %B0.endif.endif.endif.endi...endif.9.endif.i.i ]
  %.2213.not.i.i = icmp slt i64 %.2205.i.i, %.7112.i
  br i1 %.2213.not.i.i, label %B0.endif.endif.endif.endi...endif.11.endif.endif.i.i, label %B0.endif.endif.endif.endi...if.11.i.i, !prof !10

B0.endif.endif.endif.endi...if.11.i.i:            ; preds = %B0.endif.endif.endif.endi...endif.8.endif.else.endif.i.i
  br label %B0.endif.endif.endif.endi...endif.11.endif.endif.i.i

B0.endif.endif.endif.endi...endif.11.endif.endif.i.i: ; preds = %B0.endif.endif.endif.endi...if.11.i.i, %B0.endif.endif.endif.endi...endif.8.endif.else.endif.i.i
  %.2193.sroa.0.3.i.i = phi i64 [ %.7112.i, %B0.endif.endif.endif.endi...if.11.i.i ], [ %.2193.sroa.0.1.i.i, %B0.endif.endif.endif.endi...endif.8.endif.else.endif.i.i ]
  %.2306.i.i = getelementptr double, ptr %.7128.i, i64 %.2193.sroa.0.3.i.i
  %.2360.i.i = fmul contract double %.7427.i, 0xC01921FB54442D18
  %.2445886.not.i.i = icmp slt i64 %.8600.i, 1
  br i1 %.2445886.not.i.i, label %B2444.else.endif.i, label %B546.if.i.i

B546.if.i.i:                                      ; preds = %B0.endif.endif.endif.endi...endif.11.endif.endif.i.i, %B546.if.i.i
  %.2451885887.i.i = phi i64 [ %.2458.i.i, %B546.if.i.i ], [ 0, %B0.endif.endif.endif.endi...endif.11.endif.endif.i.i ]
  %.2458.i.i = add nuw nsw i64 %.2451885887.i.i, 1
  %167 = shl i64 %.2451885887.i.i, 3
  %scevgep16.i.i = getelementptr i8, ptr %.8625.i, i64 %167
  %.2513.i.i = load double, ptr %scevgep16.i.i, align 8, !noalias !26
  %.2515.i.i = fmul contract double %.2360.i.i, %.2513.i.i
  %.2516.i.i = tail call contract double @llvm.fma.f64(double %.2515.i.i, double 0x3FE45F306DC9C883, double 0x4338000000000000)
  %.2517.i.i = fadd contract double %.2516.i.i, 0xC338000000000000
  %.2532.i.i = tail call contract double @llvm.fma.f64(double %.2517.i.i, double 0xBFF921FB54442D18, double %.2515.i.i)
  %.2547.i.i = tail call contract double @llvm.fma.f64(double %.2517.i.i, double 0xBC91A62633145C07, double %.2532.i.i)
  %.2548.i.i = fmul contract double %.2547.i.i, %.2547.i.i
  %.2549.i.i = tail call contract double @llvm.fma.f64(double %.2548.i.i, double 0xBD6AE7F3E733B81F, double 0x3DE6124613A86D09)
  %.2550.i.i = tail call contract double @llvm.fma.f64(double %.2548.i.i, double %.2549.i.i, double 0xBE5AE64567F544E4)
  %.2551.i.i = tail call contract double @llvm.fma.f64(double %.2548.i.i, double %.2550.i.i, double 0x3EC71DE3A556C734)
  %.2552.i.i = tail call contract double @llvm.fma.f64(double %.2548.i.i, double %.2551.i.i, double 0xBF2A01A01A01A01A)
  %.2553.i.i = tail call contract double @llvm.fma.f64(double %.2548.i.i, double %.2552.i.i, double 0x3F81111111111111)
  %.2554.i.i = tail call contract double @llvm.fma.f64(double %.2548.i.i, double %.2553.i.i, double 0xBFC5555555555555)
  %.2555.i.i = fmul contract double %.2547.i.i, %.2548.i.i
  %.2556.i.i = tail call contract double @llvm.fma.f64(double %.2555.i.i, double %.2554.i.i, double %.2547.i.i)
  %.2557.i.i = tail call contract double @llvm.fma.f64(double %.2548.i.i, double 0x3D2AE7F3E733B81F, double 0xBDA93974A8C07C9D)
  %.2558.i.i = tail call contract double @llvm.fma.f64(double %.2548.i.i, double %.2557.i.i, double 0x3E21EED8EFF8D898)
  %.2559.i.i = tail call contract double @llvm.fma.f64(double %.2548.i.i, double %.2558.i.i, double 0xBE927E4FB7789F5C)
  %.2560.i.i = tail call contract double @llvm.fma.f64(double %.2548.i.i, double %.2559.i.i, double 0x3EFA01A01A01A01A)
  %.2561.i.i = tail call contract double @llvm.fma.f64(double %.2548.i.i, double %.2560.i.i, double 0xBF56C16C16C16C17)
  %.2562.i.i = tail call contract double @llvm.fma.f64(double %.2548.i.i, double %.2561.i.i, double 0x3FA5555555555555)
  %.2563.i.i = tail call contract double @llvm.fma.f64(double %.2548.i.i, double %.2562.i.i, double -5.000000e-01)
  %.2564.i.i = tail call contract double @llvm.fma.f64(double %.2548.i.i, double %.2563.i.i, double 1.000000e+00)
  %.2565.i.i = bitcast double %.2516.i.i to i64
  %.2566.i.i = bitcast double %.2556.i.i to i64
  %.2567.i.i = bitcast double %.2564.i.i to i64
  %.2568.i.i = xor i64 %.2567.i.i, %.2566.i.i
  %.2569.i.i = and i64 %.2565.i.i, 1
  %168 = icmp eq i64 %.2569.i.i, 0
  %.2571.i.i = select i1 %168, i64 0, i64 %.2568.i.i
  %.2572.i.i = shl i64 %.2565.i.i, 62
  %.2573.i.i = and i64 %.2572.i.i, -9223372036854775808
  %.2575.i.i = add i64 %.2572.i.i, 4611686018427387904
  %.2576.i.i = and i64 %.2575.i.i, -9223372036854775808
  %169 = xor i64 %.2573.i.i, %.2566.i.i
  %.2578.i.i = xor i64 %169, %.2571.i.i
  %.2579.i.i = bitcast i64 %.2578.i.i to double
  %170 = xor i64 %.2576.i.i, %.2567.i.i
  %.2581.i.i = xor i64 %170, %.2571.i.i
  %.2582.i.i = bitcast i64 %.2581.i.i to double
  %scevgep15.i.i = getelementptr i8, ptr %sr.2.sroa.36.3.i, i64 %167
  %.2632.i.i = load double, ptr %scevgep15.i.i, align 8, !noalias !26
  %.2633.i.i = fmul contract double %.2632.i.i, %.2582.i.i
  %scevgep14.i.i = getelementptr i8, ptr %si.2.sroa.36.3.i, i64 %167
  %.2663.i.i = load double, ptr %scevgep14.i.i, align 8, !noalias !26
  %.2664.i.i = fmul contract double %.2663.i.i, %.2579.i.i
  %.2665.i.i = fsub contract double %.2633.i.i, %.2664.i.i
  %.2696.i.i = fmul contract double %.2632.i.i, %.2579.i.i
  %.2727.i.i = fmul contract double %.2663.i.i, %.2582.i.i
  %.2728.i.i = fadd contract double %.2696.i.i, %.2727.i.i
  %scevgep13.i.i = getelementptr i8, ptr %.318.i45.i, i64 %167
  %.2758.i.i = load double, ptr %scevgep13.i.i, align 8, !noalias !26
  %.2760.i.i = fmul contract double %.191.i.i, %.2758.i.i
  %scevgep12.i.i = getelementptr i8, ptr %.681.i.i, i64 %167
  %.2790.i.i = load double, ptr %scevgep12.i.i, align 8, !noalias !26
  %.2792.i.i = fmul contract double %.205.i.i, %.2790.i.i
  %.2793.i.i = fadd contract double %.2760.i.i, %.2792.i.i
  %scevgep11.i.i = getelementptr i8, ptr %.1044.i.i, i64 %167
  %.2823.i.i = load double, ptr %scevgep11.i.i, align 8, !noalias !26
  %.2825.i.i = fmul contract double %.217.i.i, %.2823.i.i
  %.2826.i.i = fadd contract double %.2793.i.i, %.2825.i.i
  %scevgep10.i.i = getelementptr i8, ptr %.1407.i.i, i64 %167
  %.2856.i.i = load double, ptr %scevgep10.i.i, align 8, !noalias !26
  %.2858.i.i = fmul contract double %.229.i.i, %.2856.i.i
  %.2859.i.i = fadd contract double %.2826.i.i, %.2858.i.i
  %scevgep9.i.i = getelementptr i8, ptr %.1770.i.i, i64 %167
  %.2889.i.i = load double, ptr %scevgep9.i.i, align 8, !noalias !26
  %.2891.i.i = fmul contract double %.243.i.i, %.2889.i.i
  %.2892.i.i = fadd contract double %.2859.i.i, %.2891.i.i
  %scevgep8.i52.i = getelementptr i8, ptr %.2133.i.i, i64 %167
  %.2922.i.i = load double, ptr %scevgep8.i52.i, align 8, !noalias !26
  %.2924.i.i = fmul contract double %.251.i.i, %.2922.i.i
  %.2925.i.i = fadd contract double %.2892.i.i, %.2924.i.i
  %scevgep7.i53.i = getelementptr i8, ptr %.491.i48.i, i64 %167
  %.2955.i.i = load double, ptr %scevgep7.i53.i, align 8, !noalias !26
  %.2957.i.i = fmul contract double %.191.i.i, %.2955.i.i
  %scevgep6.i54.i = getelementptr i8, ptr %.854.i.i, i64 %167
  %.2987.i.i = load double, ptr %scevgep6.i54.i, align 8, !noalias !26
  %.2989.i.i = fmul contract double %.205.i.i, %.2987.i.i
  %.2990.i.i = fadd contract double %.2957.i.i, %.2989.i.i
  %scevgep5.i55.i = getelementptr i8, ptr %.1217.i.i, i64 %167
  %.3020.i.i = load double, ptr %scevgep5.i55.i, align 8, !noalias !26
  %.3022.i.i = fmul contract double %.217.i.i, %.3020.i.i
  %.3023.i.i = fadd contract double %.2990.i.i, %.3022.i.i
  %scevgep4.i56.i = getelementptr i8, ptr %.1580.i.i, i64 %167
  %.3053.i.i = load double, ptr %scevgep4.i56.i, align 8, !noalias !26
  %.3055.i.i = fmul contract double %.229.i.i, %.3053.i.i
  %.3056.i.i = fadd contract double %.3023.i.i, %.3055.i.i
  %scevgep3.i.i = getelementptr i8, ptr %.1943.i.i, i64 %167
  %.3086.i.i = load double, ptr %scevgep3.i.i, align 8, !noalias !26
  %.3088.i.i = fmul contract double %.243.i.i, %.3086.i.i
  %.3089.i.i = fadd contract double %.3056.i.i, %.3088.i.i
  %scevgep2.i.i = getelementptr i8, ptr %.2306.i.i, i64 %167
  %.3119.i.i = load double, ptr %scevgep2.i.i, align 8, !noalias !26
  %.3121.i.i = fmul contract double %.251.i.i, %.3119.i.i
  %.3122.i.i = fadd contract double %.3089.i.i, %.3121.i.i
  %.3123.i.i = fmul contract double %.2925.i.i, %.2665.i.i
  %.3124.i.i = fmul contract double %.3122.i.i, %.2728.i.i
  %.3125.i.i = fsub contract double %.3123.i.i, %.3124.i.i
  %scevgep1.i.i = getelementptr i8, ptr %.8797.i, i64 %167
  store double %.3125.i.i, ptr %scevgep1.i.i, align 8, !noalias !26
  %.3156.i.i = fmul contract double %.2925.i.i, %.2728.i.i
  %.3157.i.i = fmul contract double %.3122.i.i, %.2665.i.i
  %.3158.i.i = fadd contract double %.3156.i.i, %.3157.i.i
  %scevgep.i.i = getelementptr i8, ptr %.8969.i, i64 %167
  store double %.3158.i.i, ptr %scevgep.i.i, align 8, !noalias !26
  %exitcond.not.i57.i = icmp eq i64 %.8600.i, %.2458.i.i
  br i1 %exitcond.not.i57.i, label %B2444.else.endif.i, label %B546.if.i.i

B2444.else.endif.i:                               ; preds = %B546.if.i.i, %B78.if.i.i, %B0.endif.endif.endif.endi...endif.11.endif.endif.i.i, %B2136.endif.endif.endif.endif.else.endif.endif.i
  br i1 %91, label %B2444.else.endif.if.i, label %B2444.else.endif.endif.i, !prof !0

B2444.else.endif.if.i:                            ; preds = %B2444.else.endif.i
  br label %B2444.else.endif.endif.i

B2444.else.endif.endif.i:                         ; preds = %B2444.else.endif.if.i, %B2444.else.endif.i
  %.9099.sroa.0.3.i = phi i64 [ %.2058.i, %B2444.else.endif.if.i ], [ 0, %B2444.else.endif.i ]
  br i1 %14, label %B2444.else.endif.endif.if.i, label %B2444.else.endif.endif.endif.i, !prof !0

B2444.else.endif.endif.if.i:                      ; preds = %B2444.else.endif.endif.i
  br label %B2444.else.endif.endif.endif.i

B2444.else.endif.endif.endif.i:                   ; preds = %B2444.else.endif.endif.if.i, %B2444.else.endif.endif.i
  %.9099.sroa.13.1.i = phi i64 [ 0, %B2444.else.endif.endif.if.i ], [ %.8713.i, %B2444.else.endif.endif.i ]
  br i1 %15, label %B2444.else.endif.endif.endif.endif.i, label %B2444.else.endif.endif.endif.if.i, !prof !10

B2444.else.endif.endif.endif.if.i:                ; preds = %B2444.else.endif.endif.endif.i
  br label %B2444.else.endif.endif.endif.endif.i

B2444.else.endif.endif.endif.endif.i:             ; preds = %B2444.else.endif.endif.endif.if.i, %B2444.else.endif.endif.endif.i
  %.9099.sroa.13.2.i = phi i64 [ %.2058.i, %B2444.else.endif.endif.endif.if.i ], [ %.9099.sroa.13.1.i, %B2444.else.endif.endif.endif.i ]
  %.9187.i = sub nsw i64 %.9099.sroa.13.2.i, %.9099.sroa.0.3.i
  %.9196.i = tail call i64 @llvm.smax.i64(i64 %.9187.i, i64 0)
  %.60.1.i.i = lshr i64 %.9196.i, 3
  %.174158.not.i.i = icmp eq i64 %.60.1.i.i, 0
  br i1 %.174158.not.i.i, label %B2444.endif.endif.i, label %B104.if.preheader.i.i

B104.if.preheader.i.i:                            ; preds = %B2444.else.endif.endif.endif.endif.i
  %.9212.i = getelementptr double, ptr %.2074.i, i64 %.9099.sroa.0.3.i
  %scevgep.i171.i = getelementptr i8, ptr %.9212.i, i64 56
  br label %B104.if.i.i

B348.loopexit.i.i:                                ; preds = %B104.if.i.i
  %171 = fadd contract double %.244.i.i, %.279.i175.i
  %172 = fadd contract double %.314.i178.i, %.349.i.i
  %173 = fadd contract double %171, %172
  %174 = fadd contract double %.384.i.i, %.419.i182.i
  %175 = fadd contract double %.454.i.i, %.489.i.i
  %176 = fadd contract double %174, %175
  %177 = fadd contract double %173, %176
  br label %B2444.endif.endif.i

B104.if.i.i:                                      ; preds = %B104.if.i.i, %B104.if.preheader.i.i
  %lsr.iv9.i.i = phi i64 [ %.60.1.i.i, %B104.if.preheader.i.i ], [ %lsr.iv.next.i.i, %B104.if.i.i ]
  %lsr.iv.i.i = phi ptr [ %scevgep.i171.i, %B104.if.preheader.i.i ], [ %scevgep1.i183.i, %B104.if.i.i ]
  %s7.2.0168.i.i = phi double [ 0.000000e+00, %B104.if.preheader.i.i ], [ %.489.i.i, %B104.if.i.i ]
  %s6.2.0167.i.i = phi double [ 0.000000e+00, %B104.if.preheader.i.i ], [ %.454.i.i, %B104.if.i.i ]
  %s5.2.0166.i.i = phi double [ 0.000000e+00, %B104.if.preheader.i.i ], [ %.419.i182.i, %B104.if.i.i ]
  %s4.2.0165.i.i = phi double [ 0.000000e+00, %B104.if.preheader.i.i ], [ %.384.i.i, %B104.if.i.i ]
  %s3.2.0164.i.i = phi double [ 0.000000e+00, %B104.if.preheader.i.i ], [ %.349.i.i, %B104.if.i.i ]
  %s2.2.0163.i.i = phi double [ 0.000000e+00, %B104.if.preheader.i.i ], [ %.314.i178.i, %B104.if.i.i ]
  %s1.2.0162.i.i = phi double [ 0.000000e+00, %B104.if.preheader.i.i ], [ %.279.i175.i, %B104.if.i.i ]
  %s0.2.0161.i.i = phi double [ 0.000000e+00, %B104.if.preheader.i.i ], [ %.244.i.i, %B104.if.i.i ]
  %scevgep2.i172.i = getelementptr i8, ptr %lsr.iv.i.i, i64 -56
  %.242.i.i = load double, ptr %scevgep2.i172.i, align 8, !noalias !29
  %.244.i.i = fadd contract double %s0.2.0161.i.i, %.242.i.i
  %scevgep3.i173.i = getelementptr i8, ptr %lsr.iv.i.i, i64 -48
  %.277.i174.i = load double, ptr %scevgep3.i173.i, align 8, !noalias !29
  %.279.i175.i = fadd contract double %s1.2.0162.i.i, %.277.i174.i
  %scevgep4.i176.i = getelementptr i8, ptr %lsr.iv.i.i, i64 -40
  %.312.i177.i = load double, ptr %scevgep4.i176.i, align 8, !noalias !29
  %.314.i178.i = fadd contract double %s2.2.0163.i.i, %.312.i177.i
  %scevgep5.i179.i = getelementptr i8, ptr %lsr.iv.i.i, i64 -32
  %.347.i.i = load double, ptr %scevgep5.i179.i, align 8, !noalias !29
  %.349.i.i = fadd contract double %s3.2.0164.i.i, %.347.i.i
  %scevgep6.i180.i = getelementptr i8, ptr %lsr.iv.i.i, i64 -24
  %.382.i.i = load double, ptr %scevgep6.i180.i, align 8, !noalias !29
  %.384.i.i = fadd contract double %s4.2.0165.i.i, %.382.i.i
  %scevgep7.i181.i = getelementptr i8, ptr %lsr.iv.i.i, i64 -16
  %.417.i.i = load double, ptr %scevgep7.i181.i, align 8, !noalias !29
  %.419.i182.i = fadd contract double %s5.2.0166.i.i, %.417.i.i
  %scevgep8.i.i = getelementptr i8, ptr %lsr.iv.i.i, i64 -8
  %.452.i.i = load double, ptr %scevgep8.i.i, align 8, !noalias !29
  %.454.i.i = fadd contract double %s6.2.0167.i.i, %.452.i.i
  %.487.i.i = load double, ptr %lsr.iv.i.i, align 8, !noalias !29
  %.489.i.i = fadd contract double %s7.2.0168.i.i, %.487.i.i
  %scevgep1.i183.i = getelementptr i8, ptr %lsr.iv.i.i, i64 64
  %lsr.iv.next.i.i = add nsw i64 %lsr.iv9.i.i, -1
  %exitcond.not.i184.i = icmp eq i64 %lsr.iv.next.i.i, 0
  br i1 %exitcond.not.i184.i, label %B348.loopexit.i.i, label %B104.if.i.i

B2444.endif.endif.i:                              ; preds = %B348.loopexit.i.i, %B2444.else.endif.endif.endif.endif.i
  %s0.2.0.lcssa.i.i = phi double [ 0.000000e+00, %B2444.else.endif.endif.endif.endif.i ], [ %177, %B348.loopexit.i.i ]
  br i1 %92, label %B2444.endif.endif.else.endif.if.i, label %B2444.endif.endif.else.endif.endif.i, !prof !0

B2444.endif.endif.else.endif.if.i:                ; preds = %B2444.endif.endif.i
  br label %B2444.endif.endif.else.endif.endif.i

B2444.endif.endif.else.endif.endif.i:             ; preds = %B2444.endif.endif.else.endif.if.i, %B2444.endif.endif.i
  %.9301.sroa.0.3.i = phi i64 [ %.2233.i, %B2444.endif.endif.else.endif.if.i ], [ 0, %B2444.endif.endif.i ]
  br i1 %16, label %B2444.endif.endif.else.endif.endif.if.i, label %B2444.endif.endif.else.endif.endif.endif.i, !prof !0

B2444.endif.endif.else.endif.endif.if.i:          ; preds = %B2444.endif.endif.else.endif.endif.i
  br label %B2444.endif.endif.else.endif.endif.endif.i

B2444.endif.endif.else.endif.endif.endif.i:       ; preds = %B2444.endif.endif.else.endif.endif.if.i, %B2444.endif.endif.else.endif.endif.i
  %.9301.sroa.13.1.i = phi i64 [ 0, %B2444.endif.endif.else.endif.endif.if.i ], [ %.8885.i, %B2444.endif.endif.else.endif.endif.i ]
  br i1 %17, label %B2444.endif.endif.else.endif.endif.endif.endif.i, label %B2444.endif.endif.else.endif.endif.endif.if.i, !prof !10

B2444.endif.endif.else.endif.endif.endif.if.i:    ; preds = %B2444.endif.endif.else.endif.endif.endif.i
  br label %B2444.endif.endif.else.endif.endif.endif.endif.i

B2444.endif.endif.else.endif.endif.endif.endif.i: ; preds = %B2444.endif.endif.else.endif.endif.endif.if.i, %B2444.endif.endif.else.endif.endif.endif.i
  %.9301.sroa.13.2.i = phi i64 [ %.2233.i, %B2444.endif.endif.else.endif.endif.endif.if.i ], [ %.9301.sroa.13.1.i, %B2444.endif.endif.else.endif.endif.endif.i ]
  %.9389.i = sub nsw i64 %.9301.sroa.13.2.i, %.9301.sroa.0.3.i
  %.9398.i = tail call i64 @llvm.smax.i64(i64 %.9389.i, i64 0)
  %.60.1.i185.i = lshr i64 %.9398.i, 3
  %.174158.not.i186.i = icmp eq i64 %.60.1.i185.i, 0
  br i1 %.174158.not.i186.i, label %B2444.endif.endif.endif.endif.i, label %B104.if.preheader.i187.i

B104.if.preheader.i187.i:                         ; preds = %B2444.endif.endif.else.endif.endif.endif.endif.i
  %.9414.i = getelementptr double, ptr %.2249.i, i64 %.9301.sroa.0.3.i
  %scevgep.i188.i = getelementptr i8, ptr %.9414.i, i64 56
  br label %B104.if.i189.i

B348.loopexit.i226.i:                             ; preds = %B104.if.i189.i
  %178 = fadd contract double %.244.i202.i, %.279.i205.i
  %179 = fadd contract double %.314.i208.i, %.349.i211.i
  %180 = fadd contract double %178, %179
  %181 = fadd contract double %.384.i214.i, %.419.i217.i
  %182 = fadd contract double %.454.i220.i, %.489.i222.i
  %183 = fadd contract double %181, %182
  %184 = fadd contract double %180, %183
  br label %B2444.endif.endif.endif.endif.i

B104.if.i189.i:                                   ; preds = %B104.if.i189.i, %B104.if.preheader.i187.i
  %lsr.iv9.i190.i = phi i64 [ %.60.1.i185.i, %B104.if.preheader.i187.i ], [ %lsr.iv.next.i224.i, %B104.if.i189.i ]
  %lsr.iv.i191.i = phi ptr [ %scevgep.i188.i, %B104.if.preheader.i187.i ], [ %scevgep1.i223.i, %B104.if.i189.i ]
  %s7.2.0168.i192.i = phi double [ 0.000000e+00, %B104.if.preheader.i187.i ], [ %.489.i222.i, %B104.if.i189.i ]
  %s6.2.0167.i193.i = phi double [ 0.000000e+00, %B104.if.preheader.i187.i ], [ %.454.i220.i, %B104.if.i189.i ]
  %s5.2.0166.i194.i = phi double [ 0.000000e+00, %B104.if.preheader.i187.i ], [ %.419.i217.i, %B104.if.i189.i ]
  %s4.2.0165.i195.i = phi double [ 0.000000e+00, %B104.if.preheader.i187.i ], [ %.384.i214.i, %B104.if.i189.i ]
  %s3.2.0164.i196.i = phi double [ 0.000000e+00, %B104.if.preheader.i187.i ], [ %.349.i211.i, %B104.if.i189.i ]
  %s2.2.0163.i197.i = phi double [ 0.000000e+00, %B104.if.preheader.i187.i ], [ %.314.i208.i, %B104.if.i189.i ]
  %s1.2.0162.i198.i = phi double [ 0.000000e+00, %B104.if.preheader.i187.i ], [ %.279.i205.i, %B104.if.i189.i ]
  %s0.2.0161.i199.i = phi double [ 0.000000e+00, %B104.if.preheader.i187.i ], [ %.244.i202.i, %B104.if.i189.i ]
  %scevgep2.i200.i = getelementptr i8, ptr %lsr.iv.i191.i, i64 -56
  %.242.i201.i = load double, ptr %scevgep2.i200.i, align 8, !noalias !32
  %.244.i202.i = fadd contract double %s0.2.0161.i199.i, %.242.i201.i
  %scevgep3.i203.i = getelementptr i8, ptr %lsr.iv.i191.i, i64 -48
  %.277.i204.i = load double, ptr %scevgep3.i203.i, align 8, !noalias !32
  %.279.i205.i = fadd contract double %s1.2.0162.i198.i, %.277.i204.i
  %scevgep4.i206.i = getelementptr i8, ptr %lsr.iv.i191.i, i64 -40
  %.312.i207.i = load double, ptr %scevgep4.i206.i, align 8, !noalias !32
  %.314.i208.i = fadd contract double %s2.2.0163.i197.i, %.312.i207.i
  %scevgep5.i209.i = getelementptr i8, ptr %lsr.iv.i191.i, i64 -32
  %.347.i210.i = load double, ptr %scevgep5.i209.i, align 8, !noalias !32
  %.349.i211.i = fadd contract double %s3.2.0164.i196.i, %.347.i210.i
  %scevgep6.i212.i = getelementptr i8, ptr %lsr.iv.i191.i, i64 -24
  %.382.i213.i = load double, ptr %scevgep6.i212.i, align 8, !noalias !32
  %.384.i214.i = fadd contract double %s4.2.0165.i195.i, %.382.i213.i
  %scevgep7.i215.i = getelementptr i8, ptr %lsr.iv.i191.i, i64 -16
  %.417.i216.i = load double, ptr %scevgep7.i215.i, align 8, !noalias !32
  %.419.i217.i = fadd contract double %s5.2.0166.i194.i, %.417.i216.i
  %scevgep8.i218.i = getelementptr i8, ptr %lsr.iv.i191.i, i64 -8
  %.452.i219.i = load double, ptr %scevgep8.i218.i, align 8, !noalias !32
  %.454.i220.i = fadd contract double %s6.2.0167.i193.i, %.452.i219.i
  %.487.i221.i = load double, ptr %lsr.iv.i191.i, align 8, !noalias !32
  %.489.i222.i = fadd contract double %s7.2.0168.i192.i, %.487.i221.i
  %scevgep1.i223.i = getelementptr i8, ptr %lsr.iv.i191.i, i64 64
  %lsr.iv.next.i224.i = add nsw i64 %lsr.iv9.i190.i, -1
  %exitcond.not.i225.i = icmp eq i64 %lsr.iv.next.i224.i, 0
  br i1 %exitcond.not.i225.i, label %B348.loopexit.i226.i, label %B104.if.i189.i

B2444.endif.endif.endif.endif.i:                  ; preds = %B348.loopexit.i226.i, %B2444.endif.endif.else.endif.endif.endif.endif.i
  %s0.2.0.lcssa.i227.i = phi double [ 0.000000e+00, %B2444.endif.endif.else.endif.endif.endif.endif.i ], [ %184, %B348.loopexit.i226.i ]
  %.9490.i = icmp slt i64 %.7308.sroa.0.054.i, 0
  %.9491.i = select i1 %.9490.i, i64 %.3160.i, i64 0
  %.idx93.i = shl i64 %.7308.sroa.0.054.i, 4
  %185 = getelementptr i8, ptr %.3176.i, i64 %.idx93.i
  %.9505.i = getelementptr double, ptr %185, i64 %.9491.i
  %.9506.i = load double, ptr %.9505.i, align 8, !noalias !1
  %.9508.i = fmul contract double %.7197.i, %s0.2.0.lcssa.i.i
  %.9510.i = fmul contract double %.7230.i, %s0.2.0.lcssa.i227.i
  %.9511.i = fsub contract double %.9508.i, %.9510.i
  %.9512.i = fadd contract double %.9506.i, %.9511.i
  store double %.9512.i, ptr %.9505.i, align 8, !noalias !1
  %186 = getelementptr i8, ptr %185, i64 8
  %.9576.i = getelementptr double, ptr %186, i64 %.9491.i
  %.9577.i = load double, ptr %.9576.i, align 8, !noalias !1
  %.9579.i = fmul contract double %.7197.i, %s0.2.0.lcssa.i227.i
  %.9581.i = fmul contract double %.7230.i, %s0.2.0.lcssa.i.i
  %.9582.i = fadd contract double %.9581.i, %.9579.i
  %.9583.i = fadd contract double %.9582.i, %.9577.i
  store double %.9583.i, ptr %.9576.i, align 8, !noalias !1
  %.7318.i = icmp sgt i64 %.7317328953.i, 0
  %.7331.i = zext i1 %.7318.i to i64
  %.73243296.i = add i64 %.7324329652.i, %.7331.i
  %.7327.i = sext i1 %.7318.i to i64
  %.73173289.i = add nsw i64 %.7317328953.i, %.7327.i
  %.7308.sroa.0.0.i = select i1 %.7318.i, i64 %.7324329652.i, i64 0
  br i1 %.7318.i, label %B2054.i, label %B2658.i

B2692.else.if.i:                                  ; preds = %B2692.i
  br label %B2692.else.endif.i

B2692.else.endif.i:                               ; preds = %B2692.else.if.i, %B2692.i
  %.9687.sroa.0.1.i = phi i64 [ 0, %B2692.else.if.i ], [ %.9699.i, %B2692.i ]
  br i1 %25, label %B2692.else.endif.endif.endif.endif.i, label %B2692.else.endif.if.i, !prof !10

B2692.else.endif.if.i:                            ; preds = %B2692.else.endif.i
  br label %B2692.else.endif.endif.endif.endif.i

B2692.else.endif.endif.endif.endif.i:             ; preds = %B2692.else.endif.if.i, %B2692.else.endif.i
  %.9687.sroa.0.3.i = phi i64 [ %arg.n_spectrum, %B2692.else.endif.if.i ], [ %.9687.sroa.0.1.i, %B2692.else.endif.i ]
  %.9839.i = icmp ne i64 %.4310.sroa.0.061.i, 0
  %brmerge.i = or i1 %26, %.9839.i
  br i1 %brmerge.i, label %B2818.i, label %B2818.thread.i

B2818.thread.i:                                   ; preds = %B2692.else.endif.endif.endif.endif.i
  %.9800.i = getelementptr double, ptr %arg.spectrum, i64 %.9687.sroa.0.3.i
  tail call void @llvm.memset.p0.i64(ptr align 8 %.9800.i, i8 0, i64 %6, i1 false), !noalias !1
  br label %B2848.if.preheader.i

B2848.if.i:                                       ; preds = %B2848.if.i, %B2848.if.preheader.i
  %lsr.iv447.i = phi ptr [ %scevgep446.i, %B2848.if.preheader.i ], [ %scevgep448.i, %B2848.if.i ]
  %.1008333113313.i = phi i64 [ 0, %B2848.if.preheader.i ], [ %.10090.i, %B2848.if.i ]
  %.10090.i = add nuw nsw i64 %.1008333113313.i, 1
  %scevgep449.i = getelementptr i8, ptr %lsr.iv447.i, i64 -8
  %.10145.i = load double, ptr %scevgep449.i, align 8, !noalias !1
  %187 = shl i64 %.1008333113313.i, 3
  %scevgep57.i = getelementptr i8, ptr %.2074.i, i64 %187
  %.10175.i = load double, ptr %scevgep57.i, align 8, !noalias !1
  %.10177.i = fmul contract double %.7197.i, %.10175.i
  %scevgep56.i = getelementptr i8, ptr %.2249.i, i64 %187
  %.10207.i = load double, ptr %scevgep56.i, align 8, !noalias !1
  %.10209.i = fmul contract double %.7230.i, %.10207.i
  %.10210.i = fsub contract double %.10177.i, %.10209.i
  %.10211.i = fadd contract double %.10145.i, %.10210.i
  store double %.10211.i, ptr %scevgep449.i, align 8, !noalias !1
  %.10273.i = load double, ptr %lsr.iv447.i, align 8, !noalias !1
  %.10303.i = load double, ptr %scevgep56.i, align 8, !noalias !1
  %.10305.i = fmul contract double %.7197.i, %.10303.i
  %.10335.i = load double, ptr %scevgep57.i, align 8, !noalias !1
  %.10337.i = fmul contract double %.7230.i, %.10335.i
  %.10338.i = fadd contract double %.10305.i, %.10337.i
  %.10339.i = fadd contract double %.10273.i, %.10338.i
  store double %.10339.i, ptr %lsr.iv447.i, align 8, !noalias !1
  %scevgep448.i = getelementptr i8, ptr %lsr.iv447.i, i64 16
  %exitcond3986.not.i = icmp eq i64 %.13.i98.i, %.10090.i
  br i1 %exitcond3986.not.i, label %B3020.i, label %B2848.if.i

B3198.if.i:                                       ; preds = %B3198.if.i, %B3198.if.preheader.i
  %.1069235473549.i = phi i64 [ %.10699.i, %B3198.if.i ], [ 0, %B3198.if.preheader.i ]
  %.10699.i = add nuw nsw i64 %.1069235473549.i, 1
  %188 = add i64 %.1069235473549.i, %.10486.sroa.0.084.i
  %.10739.i = icmp slt i64 %188, 0
  %189 = select i1 %.10739.i, i64 %75, i64 0
  %scevgep454.i = getelementptr i8, ptr %scevgep453.i, i64 %189
  %190 = shl nuw nsw i64 %.1069235473549.i, 3
  %scevgep59.i = getelementptr i8, ptr %scevgep454.i, i64 %190
  %.10755.i = load i64, ptr %scevgep59.i, align 8, !noalias !1
  %.10770.i = icmp slt i64 %.10755.i, 0
  %.10771.i = select i1 %.10770.i, i64 %.3500.i, i64 0
  %.idx95.i = shl i64 %.10755.i, 4
  %191 = getelementptr i8, ptr %.3516.i, i64 %.idx95.i
  %.10785.i = getelementptr double, ptr %191, i64 %.10771.i
  %.10786.i = load double, ptr %.10785.i, align 8, !noalias !1
  %192 = getelementptr i8, ptr %191, i64 8
  %.10849.i = getelementptr double, ptr %192, i64 %.10771.i
  %.10850.i = load double, ptr %.10849.i, align 8, !noalias !1
  %.10851.i = fmul contract double %.10786.i, %.10786.i
  %.10852.i = fmul contract double %.10850.i, %.10850.i
  %.10853.i = fadd contract double %.10851.i, %.10852.i
  %scevgep58.i = getelementptr i8, ptr %.1339.i, i64 %190
  store double %.10853.i, ptr %scevgep58.i, align 8, !noalias !1
  %exitcond3987.not.i = icmp eq i64 %.13.i229.i, %.10699.i
  br i1 %exitcond3987.not.i, label %B3318.i, label %B3198.if.i

B3350.if.i:                                       ; preds = %B3350.if.i, %B3350.if.preheader380.i
  %lsr.iv460.i = phi i64 [ %35, %B3350.if.preheader380.i ], [ %lsr.iv.next461.i, %B3350.if.i ]
  %.1097835543556.i = phi i64 [ %.1097835543556.unr.i, %B3350.if.preheader380.i ], [ %201, %B3350.if.i ]
  %.11023.i = icmp slt i64 %.1097835543556.i, 0
  %193 = select i1 %.11023.i, i64 %73, i64 0
  %scevgep468.i = getelementptr i8, ptr %.1339.i, i64 %193
  %194 = shl i64 %.1097835543556.i, 3
  %scevgep469.i = getelementptr i8, ptr %scevgep468.i, i64 %194
  store double 0.000000e+00, ptr %scevgep469.i, align 8, !noalias !1
  %195 = add i64 %.1097835543556.i, 1
  %.11023.1.i = icmp slt i64 %195, 0
  %196 = select i1 %.11023.1.i, i64 %80, i64 8
  %scevgep66.i = getelementptr i8, ptr %.1339.i, i64 %196
  %scevgep67.i = getelementptr i8, ptr %scevgep66.i, i64 %194
  store double 0.000000e+00, ptr %scevgep67.i, align 8, !noalias !1
  %197 = add i64 %.1097835543556.i, 2
  %.11023.2.i = icmp slt i64 %197, 0
  %198 = select i1 %.11023.2.i, i64 %93, i64 16
  %scevgep64.i = getelementptr i8, ptr %.1339.i, i64 %198
  %scevgep65.i = getelementptr i8, ptr %scevgep64.i, i64 %194
  store double 0.000000e+00, ptr %scevgep65.i, align 8, !noalias !1
  %199 = add i64 %.1097835543556.i, 3
  %.11023.3.i = icmp slt i64 %199, 0
  %200 = select i1 %.11023.3.i, i64 %94, i64 24
  %scevgep62.i = getelementptr i8, ptr %.1339.i, i64 %200
  %scevgep63.i = getelementptr i8, ptr %scevgep62.i, i64 %194
  store double 0.000000e+00, ptr %scevgep63.i, align 8, !noalias !1
  %lsr.iv.next461.i = add i64 %lsr.iv460.i, -4
  %.10972.3.i = icmp sgt i64 %lsr.iv.next461.i, 4
  %201 = add i64 %.1097835543556.i, 4
  br i1 %.10972.3.i, label %B3350.if.i, label %B3366.i

B3398.else.if.i:                                  ; preds = %B3398.i
  br label %B3398.else.endif.i

B3398.else.endif.i:                               ; preds = %B3398.else.if.i, %B3398.i
  %.11210.sroa.0.1.i = phi i64 [ 0, %B3398.else.if.i ], [ %.11222.i, %B3398.i ]
  %.11230.not.i = icmp slt i64 %.11222.i, %arg.n_norm
  br i1 %.11230.not.i, label %B3398.else.endif.endif.endif.endif.i, label %B3398.else.endif.if.i, !prof !10

B3398.else.endif.if.i:                            ; preds = %B3398.else.endif.i
  br label %B3398.else.endif.endif.endif.endif.i

B3398.else.endif.endif.endif.endif.i:             ; preds = %B3398.else.endif.if.i, %B3398.else.endif.i
  %.11210.sroa.0.3.i = phi i64 [ %arg.n_norm, %B3398.else.endif.if.i ], [ %.11210.sroa.0.1.i, %B3398.else.endif.i ]
  %.11323.i = getelementptr double, ptr %arg.quadratic, i64 %.11210.sroa.0.3.i
  br i1 %82, label %B3462.i, label %B3686.i

B3462.else.if.i:                                  ; preds = %B3462.i
  br label %B3462.else.endif.i

B3462.else.endif.i:                               ; preds = %B3462.else.if.i, %B3462.i
  %.11400.sroa.0.1.i = phi i64 [ 0, %B3462.else.if.i ], [ %.11412.i, %B3462.i ]
  %.11420.not.i = icmp slt i64 %.11412.i, %arg.n_amplitude
  br i1 %.11420.not.i, label %B3462.else.endif.endif.i, label %B3462.else.endif.if.i, !prof !10

B3462.else.endif.if.i:                            ; preds = %B3462.else.endif.i
  br label %B3462.else.endif.endif.i

B3462.else.endif.endif.i:                         ; preds = %B3462.else.endif.if.i, %B3462.else.endif.i
  %.11400.sroa.0.3.i = phi i64 [ %arg.n_amplitude, %B3462.else.endif.if.i ], [ %.11400.sroa.0.1.i, %B3462.else.endif.i ]
  %.11427.i = icmp slt i64 %.11373.i, 0
  %.11428.i = select i1 %.11427.i, i64 %arg.n_amplitude, i64 0
  %.11429.i = add i64 %.11428.i, %.11373.i
  %.11432.i = icmp slt i64 %.11429.i, 0
  br i1 %.11432.i, label %B3462.else.endif.endif.if.i, label %B3462.else.endif.endif.endif.i, !prof !0

B3462.else.endif.endif.if.i:                      ; preds = %B3462.else.endif.endif.i
  br label %B3462.else.endif.endif.endif.i

B3462.else.endif.endif.endif.i:                   ; preds = %B3462.else.endif.endif.if.i, %B3462.else.endif.endif.i
  %.11400.sroa.13.1.i = phi i64 [ 0, %B3462.else.endif.endif.if.i ], [ %.11429.i, %B3462.else.endif.endif.i ]
  %.11437.not.i = icmp slt i64 %.11429.i, %arg.n_amplitude
  br i1 %.11437.not.i, label %B3462.else.endif.endif.endif.endif.i, label %B3462.else.endif.endif.endif.if.i, !prof !10

B3462.else.endif.endif.endif.if.i:                ; preds = %B3462.else.endif.endif.endif.i
  br label %B3462.else.endif.endif.endif.endif.i

B3462.else.endif.endif.endif.endif.i:             ; preds = %B3462.else.endif.endif.endif.if.i, %B3462.else.endif.endif.endif.i
  %.11400.sroa.13.2.i = phi i64 [ %arg.n_amplitude, %B3462.else.endif.endif.endif.if.i ], [ %.11400.sroa.13.1.i, %B3462.else.endif.endif.endif.i ]
  %.11488.i = sub i64 %.11400.sroa.13.2.i, %.11400.sroa.0.3.i
  %.11513.i = getelementptr double, ptr %arg.amplitude, i64 %.11400.sroa.0.3.i
  br i1 %86, label %B3462.endif.else.endif.if.i, label %B3462.endif.else.endif.endif.i, !prof !0

B3462.endif.else.endif.if.i:                      ; preds = %B3462.else.endif.endif.endif.endif.i
  br label %B3462.endif.else.endif.endif.i

B3462.endif.else.endif.endif.i:                   ; preds = %B3462.endif.else.endif.if.i, %B3462.else.endif.endif.endif.endif.i
  %.11572.sroa.0.3.i = phi i64 [ %.2426.i, %B3462.endif.else.endif.if.i ], [ 0, %B3462.else.endif.endif.endif.endif.i ]
  br i1 %41, label %B3462.endif.else.endif.endif.if.i, label %B3462.endif.else.endif.endif.endif.i, !prof !0

B3462.endif.else.endif.endif.if.i:                ; preds = %B3462.endif.else.endif.endif.i
  br label %B3462.endif.else.endif.endif.endif.i

B3462.endif.else.endif.endif.endif.i:             ; preds = %B3462.endif.else.endif.endif.if.i, %B3462.endif.else.endif.endif.i
  %.11572.sroa.13.1.i = phi i64 [ 0, %B3462.endif.else.endif.endif.if.i ], [ %.11601.i, %B3462.endif.else.endif.endif.i ]
  br i1 %42, label %B3462.endif.else.endif.endif.endif.endif.i, label %B3462.endif.else.endif.endif.endif.if.i, !prof !10

B3462.endif.else.endif.endif.endif.if.i:          ; preds = %B3462.endif.else.endif.endif.endif.i
  br label %B3462.endif.else.endif.endif.endif.endif.i

B3462.endif.else.endif.endif.endif.endif.i:       ; preds = %B3462.endif.else.endif.endif.endif.if.i, %B3462.endif.else.endif.endif.endif.i
  %.11572.sroa.13.2.i = phi i64 [ %.2426.i, %B3462.endif.else.endif.endif.endif.if.i ], [ %.11572.sroa.13.1.i, %B3462.endif.else.endif.endif.endif.i ]
  %.11660.i = sub nsw i64 %.11572.sroa.13.2.i, %.11572.sroa.0.3.i
  %.11669.i = tail call i64 @llvm.smax.i64(i64 %.11660.i, i64 0)
  %.11685.i = getelementptr double, ptr %.2442.i, i64 %.11572.sroa.0.3.i
  %.104.i230.not.i = icmp slt i64 %.11660.i, 1
  br i1 %.104.i230.not.i, label %B76.i231.i, label %B60.if.preheader.i282.i

B60.if.preheader.i282.i:                          ; preds = %B3462.endif.else.endif.endif.endif.endif.i
  %202 = shl nuw i64 %.11669.i, 3
  tail call void @llvm.memset.p0.i64(ptr align 8 %.11685.i, i8 0, i64 %202, i1 false), !noalias !35
  br label %B76.i231.i

B76.i231.i:                                       ; preds = %B60.if.preheader.i282.i, %B3462.endif.else.endif.endif.endif.endif.i
  %.311284.not.i232.i = icmp slt i64 %.11488.i, 1
  br i1 %.311284.not.i232.i, label %B3462.endif.endif.endif.i, label %B128.if.lr.ph.i233.i

B128.if.lr.ph.i233.i:                             ; preds = %B76.i231.i
  %203 = add nsw i64 %.11669.i, -2
  %204 = lshr i64 %203, 1
  %205 = add nuw i64 %204, 1
  %206 = shl i64 %.11572.sroa.0.3.i, 3
  %scevgep507.i = getelementptr i8, ptr %scevgep397.i, i64 %206
  %207 = lshr i64 %205, 1
  %208 = mul nsw i64 %207, -2
  %209 = icmp eq i64 %.11660.i, 1
  %210 = icmp eq i64 %204, 0
  %211 = and i64 %203, 2
  %212 = icmp eq i64 %211, 0
  %213 = and i64 %.11669.i, 1
  %214 = icmp eq i64 %213, 0
  br label %B128.if.i236.i

B284.loopexit.unr-lcssa.i272.unr-lcssa.i:         ; preds = %B228.if.i256.i
  br i1 %212, label %B228.if.i256.epil.preheader.i, label %B284.loopexit.unr-lcssa.i272.i

B228.if.i256.epil.preheader.i:                    ; preds = %B228.if.preheader2.i254.i, %B284.loopexit.unr-lcssa.i272.unr-lcssa.i
  %.655272274.i257.epil.init.i = phi i64 [ 0, %B228.if.preheader2.i254.i ], [ %.662.1.i265.1.i, %B284.loopexit.unr-lcssa.i272.unr-lcssa.i ]
  %215 = shl i64 %.655272274.i257.epil.init.i, 3
  %sunkaddr11.i258.epil.i = getelementptr i8, ptr %.11685.i, i64 %215
  %.716.i259.epil.i = load double, ptr %sunkaddr11.i258.epil.i, align 8, !noalias !35
  %scevgep9.i260.epil.i = getelementptr i8, ptr %scevgep7.i255.i, i64 %215
  %scevgep10.i261.epil.i = getelementptr i8, ptr %scevgep9.i260.epil.i, i64 -8
  %.746.i262.epil.i = load double, ptr %scevgep10.i261.epil.i, align 8, !noalias !35
  %.748.i263.epil.i = fmul contract double %.565.i252.i, %.746.i262.epil.i
  %.749.i264.epil.i = fadd contract double %.716.i259.epil.i, %.748.i263.epil.i
  store double %.749.i264.epil.i, ptr %sunkaddr11.i258.epil.i, align 8, !noalias !35
  %.662.1.i265.epil.i = add nuw i64 %.655272274.i257.epil.init.i, 2
  %sunkaddr14.i266.epil.i = getelementptr i8, ptr %sunkaddr11.i258.epil.i, i64 8
  %.716.1.i267.epil.i = load double, ptr %sunkaddr14.i266.epil.i, align 8, !noalias !35
  %.746.1.i268.epil.i = load double, ptr %scevgep9.i260.epil.i, align 8, !noalias !35
  %.748.1.i269.epil.i = fmul contract double %.565.i252.i, %.746.1.i268.epil.i
  %.749.1.i270.epil.i = fadd contract double %.716.1.i267.epil.i, %.748.1.i269.epil.i
  store double %.749.1.i270.epil.i, ptr %sunkaddr14.i266.epil.i, align 8, !noalias !35
  br label %B284.loopexit.unr-lcssa.i272.i

B284.loopexit.unr-lcssa.i272.i:                   ; preds = %B228.if.i256.epil.preheader.i, %B284.loopexit.unr-lcssa.i272.unr-lcssa.i
  %.662.1.i265.lcssa.i = phi i64 [ %.662.1.i265.epil.i, %B228.if.i256.epil.preheader.i ], [ %.662.1.i265.1.i, %B284.loopexit.unr-lcssa.i272.unr-lcssa.i ]
  br i1 %214, label %B284.i279.i, label %B228.if.epil.preheader.i273.i

B228.if.epil.preheader.i273.i:                    ; preds = %B228.if.preheader.i253.i, %B284.loopexit.unr-lcssa.i272.i
  %.655272274.epil.init.i274.i = phi i64 [ 0, %B228.if.preheader.i253.i ], [ %.662.1.i265.lcssa.i, %B284.loopexit.unr-lcssa.i272.i ]
  %216 = getelementptr double, ptr %.11685.i, i64 %.655272274.epil.init.i274.i
  %.716.epil.i275.i = load double, ptr %216, align 8, !noalias !35
  %217 = getelementptr double, ptr %.498.i251.i, i64 %.655272274.epil.init.i274.i
  %.746.epil.i276.i = load double, ptr %217, align 8, !noalias !35
  %.748.epil.i277.i = fmul contract double %.565.i252.i, %.746.epil.i276.i
  %.749.epil.i278.i = fadd contract double %.716.epil.i275.i, %.748.epil.i277.i
  store double %.749.epil.i278.i, ptr %216, align 8, !noalias !35
  br label %B284.i279.i

B284.i279.i:                                      ; preds = %B130.else.endif.endif.endif.endif.i249.i, %B228.if.epil.preheader.i273.i, %B284.loopexit.unr-lcssa.i272.i
  %exitcond292.not.i280.i = icmp eq i64 %.11488.i, %.324.i238.i
  br i1 %exitcond292.not.i280.i, label %B3462.endif.endif.endif.i, label %B128.if.i236.i

B128.if.i236.i:                                   ; preds = %B284.i279.i, %B128.if.lr.ph.i233.i
  %.317279285.i237.i = phi i64 [ 0, %B128.if.lr.ph.i233.i ], [ %.324.i238.i, %B284.i279.i ]
  %.324.i238.i = add nuw nsw i64 %.317279285.i237.i, 1
  %.350.i239.i = mul nsw i64 %.317279285.i237.i, %quot.1.0.i
  %.352.i240.i = add nsw i64 %.350.i239.i, %.10486.sroa.0.084.i
  %.395.i241.i = icmp slt i64 %.352.i240.i, 0
  %.396.i242.i = select i1 %.395.i241.i, i64 %arg.n_qs, i64 0
  %.397.i243.i = add i64 %.396.i242.i, %.352.i240.i
  %.400.i244.i = icmp slt i64 %.397.i243.i, 0
  br i1 %.400.i244.i, label %B130.else.if.i281.i, label %B130.else.endif.i245.i, !prof !0

B130.else.if.i281.i:                              ; preds = %B128.if.i236.i
  br label %B130.else.endif.i245.i

B130.else.endif.i245.i:                           ; preds = %B130.else.if.i281.i, %B128.if.i236.i
  %.385.sroa.0.1.i246.i = phi i64 [ 0, %B130.else.if.i281.i ], [ %.397.i243.i, %B128.if.i236.i ]
  %.405.not.i247.i = icmp slt i64 %.397.i243.i, %arg.n_qs
  br i1 %.405.not.i247.i, label %B130.else.endif.endif.endif.endif.i249.i, label %B130.else.endif.if.i248.i, !prof !10

B130.else.endif.if.i248.i:                        ; preds = %B130.else.endif.i245.i
  br label %B130.else.endif.endif.endif.endif.i249.i

B130.else.endif.endif.endif.endif.i249.i:         ; preds = %B130.else.endif.if.i248.i, %B130.else.endif.i245.i
  %.385.sroa.0.3.i250.i = phi i64 [ %arg.n_qs, %B130.else.endif.if.i248.i ], [ %.385.sroa.0.1.i246.i, %B130.else.endif.i245.i ]
  %.498.i251.i = getelementptr double, ptr %arg.quadratic_spline, i64 %.385.sroa.0.3.i250.i
  %218 = getelementptr double, ptr %.11513.i, i64 %.317279285.i237.i
  %.565.i252.i = load double, ptr %218, align 8, !noalias !35
  br i1 %.104.i230.not.i, label %B284.i279.i, label %B228.if.preheader.i253.i

B228.if.preheader.i253.i:                         ; preds = %B130.else.endif.endif.endif.endif.i249.i
  br i1 %209, label %B228.if.epil.preheader.i273.i, label %B228.if.preheader2.i254.i

B228.if.preheader2.i254.i:                        ; preds = %B228.if.preheader.i253.i
  %219 = shl i64 %.385.sroa.0.3.i250.i, 3
  %scevgep7.i255.i = getelementptr i8, ptr %scevgep6.i235.i, i64 %219
  br i1 %210, label %B228.if.i256.epil.preheader.i, label %B228.if.i256.preheader.i

B228.if.i256.preheader.i:                         ; preds = %B228.if.preheader2.i254.i
  %scevgep516.i = getelementptr i8, ptr %scevgep515.i, i64 %219
  br label %B228.if.i256.i

B228.if.i256.i:                                   ; preds = %B228.if.i256.i, %B228.if.i256.preheader.i
  %lsr.iv85.i = phi i64 [ %lsr.iv.next86.i, %B228.if.i256.i ], [ %208, %B228.if.i256.preheader.i ]
  %.655272274.i257.i = phi i64 [ %.662.1.i265.1.i, %B228.if.i256.i ], [ 0, %B228.if.i256.preheader.i ]
  %220 = shl i64 %.655272274.i257.i, 3
  %scevgep513.i = getelementptr i8, ptr %scevgep507.i, i64 %220
  %scevgep514.i = getelementptr i8, ptr %scevgep513.i, i64 -24
  %.716.i259.i = load double, ptr %scevgep514.i, align 8, !noalias !35
  %scevgep519.i = getelementptr i8, ptr %scevgep516.i, i64 %220
  %scevgep520.i = getelementptr i8, ptr %scevgep519.i, i64 -16
  %scevgep90.i = getelementptr i8, ptr %scevgep519.i, i64 -24
  %.746.i262.i = load double, ptr %scevgep90.i, align 8, !noalias !35
  %.748.i263.i = fmul contract double %.565.i252.i, %.746.i262.i
  %.749.i264.i = fadd contract double %.716.i259.i, %.748.i263.i
  store double %.749.i264.i, ptr %scevgep514.i, align 8, !noalias !35
  %scevgep94.i = getelementptr i8, ptr %scevgep513.i, i64 -16
  %.716.1.i267.i = load double, ptr %scevgep94.i, align 8, !noalias !35
  %.746.1.i268.i = load double, ptr %scevgep520.i, align 8, !noalias !35
  %.748.1.i269.i = fmul contract double %.565.i252.i, %.746.1.i268.i
  %.749.1.i270.i = fadd contract double %.716.1.i267.i, %.748.1.i269.i
  store double %.749.1.i270.i, ptr %scevgep94.i, align 8, !noalias !35
  %scevgep92.i = getelementptr i8, ptr %scevgep513.i, i64 -8
  %.716.i259.1.i = load double, ptr %scevgep92.i, align 8, !noalias !35
  %scevgep88.i = getelementptr i8, ptr %scevgep519.i, i64 -8
  %.746.i262.1.i = load double, ptr %scevgep88.i, align 8, !noalias !35
  %.748.i263.1.i = fmul contract double %.565.i252.i, %.746.i262.1.i
  %.749.i264.1.i = fadd contract double %.716.i259.1.i, %.748.i263.1.i
  store double %.749.i264.1.i, ptr %scevgep92.i, align 8, !noalias !35
  %.662.1.i265.1.i = add i64 %.655272274.i257.i, 4
  %.716.1.i267.1.i = load double, ptr %scevgep513.i, align 8, !noalias !35
  %.746.1.i268.1.i = load double, ptr %scevgep519.i, align 8, !noalias !35
  %.748.1.i269.1.i = fmul contract double %.565.i252.i, %.746.1.i268.1.i
  %.749.1.i270.1.i = fadd contract double %.716.1.i267.1.i, %.748.1.i269.1.i
  store double %.749.1.i270.1.i, ptr %scevgep513.i, align 8, !noalias !35
  %lsr.iv.next86.i = add i64 %lsr.iv85.i, 2
  %niter369.ncmp.1.i = icmp eq i64 %lsr.iv.next86.i, 0
  br i1 %niter369.ncmp.1.i, label %B284.loopexit.unr-lcssa.i272.unr-lcssa.i, label %B228.if.i256.i

B3462.endif.endif.endif.i:                        ; preds = %B284.i279.i, %B76.i231.i
  br i1 %38, label %B3762.i, label %B3590.if.preheader.i

B3590.if.preheader.i:                             ; preds = %B3462.endif.endif.endif.i
  br i1 %43, label %B3590.if.epil.preheader.i, label %B3590.if.preheader378.i

B3590.if.preheader378.i:                          ; preds = %B3590.if.preheader.i
  %221 = shl i64 %.11210.sroa.0.3.i, 3
  %scevgep530.i = getelementptr i8, ptr %scevgep529.i, i64 %221
  br label %B3590.if.i

B3590.if.i:                                       ; preds = %B3590.if.i, %B3590.if.preheader378.i
  %.1184235683570.i = phi i64 [ %.11849.1.i, %B3590.if.i ], [ 0, %B3590.if.preheader378.i ]
  %222 = shl i64 %.1184235683570.i, 3
  %sunkaddr106.i = getelementptr i8, ptr %69, i64 %222
  %.11903.i = load double, ptr %sunkaddr106.i, align 8, !noalias !1
  %scevgep532.i = getelementptr i8, ptr %scevgep530.i, i64 %222
  %scevgep533.i = getelementptr i8, ptr %scevgep532.i, i64 -8
  %.11933.i = load double, ptr %scevgep533.i, align 8, !noalias !1
  %.11934.i = fmul contract double %.11903.i, %.11933.i
  %sunkaddr108.i = getelementptr i8, ptr %65, i64 %222
  %.11964.i = load double, ptr %sunkaddr108.i, align 8, !noalias !1
  %.11965.i = fadd contract double %.11964.i, 1.000000e+00
  %.11997.i = fmul contract double %.11965.i, %.11965.i
  %.11998.i = fmul contract double %.11934.i, %.11997.i
  %sunkaddr110.i = getelementptr i8, ptr %71, i64 %222
  store double %.11998.i, ptr %sunkaddr110.i, align 8, !noalias !1
  %.11849.1.i = add nuw i64 %.1184235683570.i, 2
  %sunkaddr113.i = getelementptr i8, ptr %sunkaddr106.i, i64 8
  %.11903.1.i = load double, ptr %sunkaddr113.i, align 8, !noalias !1
  %.11933.1.i = load double, ptr %scevgep532.i, align 8, !noalias !1
  %.11934.1.i = fmul contract double %.11903.1.i, %.11933.1.i
  %sunkaddr116.i = getelementptr i8, ptr %sunkaddr108.i, i64 8
  %.11964.1.i = load double, ptr %sunkaddr116.i, align 8, !noalias !1
  %.11965.1.i = fadd contract double %.11964.1.i, 1.000000e+00
  %.11997.1.i = fmul contract double %.11965.1.i, %.11965.1.i
  %.11998.1.i = fmul contract double %.11934.1.i, %.11997.1.i
  %sunkaddr119.i = getelementptr i8, ptr %sunkaddr110.i, i64 8
  store double %.11998.1.i, ptr %sunkaddr119.i, align 8, !noalias !1
  %niter375.ncmp.1.i = icmp eq i64 %unroll_iter374.i, %.11849.1.i
  br i1 %niter375.ncmp.1.i, label %B3684.loopexit.unr-lcssa.i, label %B3590.if.i

B3716.if.i:                                       ; preds = %B3716.if.i, %B3716.if.preheader379.i
  %.1212635613563.i = phi i64 [ %.12133.3.i, %B3716.if.i ], [ 0, %B3716.if.preheader379.i ]
  %223 = shl i64 %.1212635613563.i, 3
  %scevgep479.i = getelementptr i8, ptr %scevgep473.i, i64 %223
  %scevgep480.i = getelementptr i8, ptr %scevgep479.i, i64 -24
  %.12187.i = load double, ptr %scevgep480.i, align 8, !noalias !1
  %scevgep488.i = getelementptr i8, ptr %scevgep482.i, i64 %223
  %scevgep489.i = getelementptr i8, ptr %scevgep488.i, i64 -24
  %.12217.i = load double, ptr %scevgep489.i, align 8, !noalias !1
  %.12218.i = fmul contract double %.12187.i, %.12217.i
  %scevgep68.i = getelementptr i8, ptr %scevgep490.i, i64 %223
  %scevgep73.i = getelementptr i8, ptr %scevgep68.i, i64 -24
  store double %.12218.i, ptr %scevgep73.i, align 8, !noalias !1
  %scevgep81.i = getelementptr i8, ptr %scevgep479.i, i64 -16
  %.12187.1.i = load double, ptr %scevgep81.i, align 8, !noalias !1
  %scevgep77.i = getelementptr i8, ptr %scevgep488.i, i64 -16
  %.12217.1.i = load double, ptr %scevgep77.i, align 8, !noalias !1
  %.12218.1.i = fmul contract double %.12187.1.i, %.12217.1.i
  %scevgep72.i = getelementptr i8, ptr %scevgep68.i, i64 -16
  store double %.12218.1.i, ptr %scevgep72.i, align 8, !noalias !1
  %scevgep79.i = getelementptr i8, ptr %scevgep479.i, i64 -8
  %.12187.2.i = load double, ptr %scevgep79.i, align 8, !noalias !1
  %scevgep75.i = getelementptr i8, ptr %scevgep488.i, i64 -8
  %.12217.2.i = load double, ptr %scevgep75.i, align 8, !noalias !1
  %.12218.2.i = fmul contract double %.12187.2.i, %.12217.2.i
  %scevgep70.i = getelementptr i8, ptr %scevgep68.i, i64 -8
  store double %.12218.2.i, ptr %scevgep70.i, align 8, !noalias !1
  %.12133.3.i = add nuw i64 %.1212635613563.i, 4
  %.12187.3.i = load double, ptr %scevgep479.i, align 8, !noalias !1
  %.12217.3.i = load double, ptr %scevgep488.i, align 8, !noalias !1
  %.12218.3.i = fmul contract double %.12187.3.i, %.12217.3.i
  store double %.12218.3.i, ptr %scevgep68.i, align 8, !noalias !1
  %niter362.ncmp.3.i = icmp eq i64 %unroll_iter361.i, %.12133.3.i
  br i1 %niter362.ncmp.3.i, label %B3762.loopexit.unr-lcssa.i, label %B3716.if.i

B3762.else.endif.if.i:                            ; preds = %B3762.i
  br label %B3762.else.endif.endif.i

B3762.else.endif.endif.i:                         ; preds = %B3762.else.endif.if.i, %B3762.i
  %.12357.sroa.0.3.i = phi i64 [ %.2058.i, %B3762.else.endif.if.i ], [ 0, %B3762.i ]
  br i1 %36, label %B3762.else.endif.endif.if.i, label %B3762.else.endif.endif.endif.i, !prof !0

B3762.else.endif.endif.if.i:                      ; preds = %B3762.else.endif.endif.i
  br label %B3762.else.endif.endif.endif.i

B3762.else.endif.endif.endif.i:                   ; preds = %B3762.else.endif.endif.if.i, %B3762.else.endif.endif.i
  %.12357.sroa.13.1.i = phi i64 [ 0, %B3762.else.endif.endif.if.i ], [ %.12386.i, %B3762.else.endif.endif.i ]
  br i1 %37, label %B3762.else.endif.endif.endif.endif.i, label %B3762.else.endif.endif.endif.if.i, !prof !10

B3762.else.endif.endif.endif.if.i:                ; preds = %B3762.else.endif.endif.endif.i
  br label %B3762.else.endif.endif.endif.endif.i

B3762.else.endif.endif.endif.endif.i:             ; preds = %B3762.else.endif.endif.endif.if.i, %B3762.else.endif.endif.endif.i
  %.12357.sroa.13.2.i = phi i64 [ %.2058.i, %B3762.else.endif.endif.endif.if.i ], [ %.12357.sroa.13.1.i, %B3762.else.endif.endif.endif.i ]
  %.12445.i = sub nsw i64 %.12357.sroa.13.2.i, %.12357.sroa.0.3.i
  %.12454.i = tail call i64 @llvm.smax.i64(i64 %.12445.i, i64 0)
  %.60.1.i284.i = lshr i64 %.12454.i, 3
  %.174158.not.i285.i = icmp eq i64 %.60.1.i284.i, 0
  br i1 %.174158.not.i285.i, label %B3762.endif.endif.i, label %B104.if.preheader.i286.i

B104.if.preheader.i286.i:                         ; preds = %B3762.else.endif.endif.endif.endif.i
  %.12470.i = getelementptr double, ptr %.2074.i, i64 %.12357.sroa.0.3.i
  %scevgep.i287.i = getelementptr i8, ptr %.12470.i, i64 56
  br label %B104.if.i288.i

B348.loopexit.i325.i:                             ; preds = %B104.if.i288.i
  %224 = fadd contract double %.244.i301.i, %.279.i304.i
  %225 = fadd contract double %.314.i307.i, %.349.i310.i
  %226 = fadd contract double %224, %225
  %227 = fadd contract double %.384.i313.i, %.419.i316.i
  %228 = fadd contract double %.454.i319.i, %.489.i321.i
  %229 = fadd contract double %227, %228
  %230 = fadd contract double %226, %229
  br label %B3762.endif.endif.i

B104.if.i288.i:                                   ; preds = %B104.if.i288.i, %B104.if.preheader.i286.i
  %lsr.iv9.i289.i = phi i64 [ %.60.1.i284.i, %B104.if.preheader.i286.i ], [ %lsr.iv.next.i323.i, %B104.if.i288.i ]
  %lsr.iv.i290.i = phi ptr [ %scevgep.i287.i, %B104.if.preheader.i286.i ], [ %scevgep1.i322.i, %B104.if.i288.i ]
  %s7.2.0168.i291.i = phi double [ 0.000000e+00, %B104.if.preheader.i286.i ], [ %.489.i321.i, %B104.if.i288.i ]
  %s6.2.0167.i292.i = phi double [ 0.000000e+00, %B104.if.preheader.i286.i ], [ %.454.i319.i, %B104.if.i288.i ]
  %s5.2.0166.i293.i = phi double [ 0.000000e+00, %B104.if.preheader.i286.i ], [ %.419.i316.i, %B104.if.i288.i ]
  %s4.2.0165.i294.i = phi double [ 0.000000e+00, %B104.if.preheader.i286.i ], [ %.384.i313.i, %B104.if.i288.i ]
  %s3.2.0164.i295.i = phi double [ 0.000000e+00, %B104.if.preheader.i286.i ], [ %.349.i310.i, %B104.if.i288.i ]
  %s2.2.0163.i296.i = phi double [ 0.000000e+00, %B104.if.preheader.i286.i ], [ %.314.i307.i, %B104.if.i288.i ]
  %s1.2.0162.i297.i = phi double [ 0.000000e+00, %B104.if.preheader.i286.i ], [ %.279.i304.i, %B104.if.i288.i ]
  %s0.2.0161.i298.i = phi double [ 0.000000e+00, %B104.if.preheader.i286.i ], [ %.244.i301.i, %B104.if.i288.i ]
  %scevgep2.i299.i = getelementptr i8, ptr %lsr.iv.i290.i, i64 -56
  %.242.i300.i = load double, ptr %scevgep2.i299.i, align 8, !noalias !38
  %.244.i301.i = fadd contract double %s0.2.0161.i298.i, %.242.i300.i
  %scevgep3.i302.i = getelementptr i8, ptr %lsr.iv.i290.i, i64 -48
  %.277.i303.i = load double, ptr %scevgep3.i302.i, align 8, !noalias !38
  %.279.i304.i = fadd contract double %s1.2.0162.i297.i, %.277.i303.i
  %scevgep4.i305.i = getelementptr i8, ptr %lsr.iv.i290.i, i64 -40
  %.312.i306.i = load double, ptr %scevgep4.i305.i, align 8, !noalias !38
  %.314.i307.i = fadd contract double %s2.2.0163.i296.i, %.312.i306.i
  %scevgep5.i308.i = getelementptr i8, ptr %lsr.iv.i290.i, i64 -32
  %.347.i309.i = load double, ptr %scevgep5.i308.i, align 8, !noalias !38
  %.349.i310.i = fadd contract double %s3.2.0164.i295.i, %.347.i309.i
  %scevgep6.i311.i = getelementptr i8, ptr %lsr.iv.i290.i, i64 -24
  %.382.i312.i = load double, ptr %scevgep6.i311.i, align 8, !noalias !38
  %.384.i313.i = fadd contract double %s4.2.0165.i294.i, %.382.i312.i
  %scevgep7.i314.i = getelementptr i8, ptr %lsr.iv.i290.i, i64 -16
  %.417.i315.i = load double, ptr %scevgep7.i314.i, align 8, !noalias !38
  %.419.i316.i = fadd contract double %s5.2.0166.i293.i, %.417.i315.i
  %scevgep8.i317.i = getelementptr i8, ptr %lsr.iv.i290.i, i64 -8
  %.452.i318.i = load double, ptr %scevgep8.i317.i, align 8, !noalias !38
  %.454.i319.i = fadd contract double %s6.2.0167.i292.i, %.452.i318.i
  %.487.i320.i = load double, ptr %lsr.iv.i290.i, align 8, !noalias !38
  %.489.i321.i = fadd contract double %s7.2.0168.i291.i, %.487.i320.i
  %scevgep1.i322.i = getelementptr i8, ptr %lsr.iv.i290.i, i64 64
  %lsr.iv.next.i323.i = add nsw i64 %lsr.iv9.i289.i, -1
  %exitcond.not.i324.i = icmp eq i64 %lsr.iv.next.i323.i, 0
  br i1 %exitcond.not.i324.i, label %B348.loopexit.i325.i, label %B104.if.i288.i

B3762.endif.endif.i:                              ; preds = %B348.loopexit.i325.i, %B3762.else.endif.endif.endif.endif.i
  %s0.2.0.lcssa.i326.i = phi double [ 0.000000e+00, %B3762.else.endif.endif.endif.endif.i ], [ %230, %B348.loopexit.i325.i ]
  %.12531.i = fmul contract double %.12328.i, %s0.2.0.lcssa.i326.i
  %.12533.i = fadd contract double %norm.2.273.i, %.12531.i
  %.11131.i = icmp sgt i64 %.11130357475.i, 0
  %.11144.i = zext i1 %.11131.i to i64
  %.111373578.i = add i64 %.11137357874.i, %.11144.i
  %.11140.i = sext i1 %.11131.i to i64
  %.111303574.i = add nsw i64 %.11130357475.i, %.11140.i
  %.11121.sroa.0.0.i = select i1 %.11131.i, i64 %.11137357874.i, i64 0
  br i1 %.11131.i, label %B3398.i, label %B3076.loopexit.i

_ZN17bnserve_inference6kernel7_source8contractB2v4B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5TupleI5ArrayIdLi1E1C7mutable7alignedExE5ArrayIdLi1E1C7mutable7alignedE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi3EE5TupleI5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi3EE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi4EE5TupleIxdE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi3EE5ArrayIdLi1E1C7mutable7alignedE.exit: ; preds = %B3894.i, %B318.endif.endif.endif.en...else.endif.endif.endif.endif.i
  store ptr null, ptr %retptr, align 8
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

attributes #0 = { nofree norecurse nosync nounwind memory(argmem: readwrite) }
attributes #1 = { mustprogress nocallback nofree nounwind willreturn memory(argmem: write) }
attributes #2 = { mustprogress nocallback nocreateundeforpoison nofree nosync nounwind speculatable willreturn memory(none) }

!0 = !{!"branch_weights", i32 1, i32 99}
!1 = !{!2}
!2 = distinct !{!2, !3, !"_ZN17bnserve_inference6kernel7_source8contractB2v4B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5TupleI5ArrayIdLi1E1C7mutable7alignedExE5ArrayIdLi1E1C7mutable7alignedE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi3EE5TupleI5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi3EE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi4EE5TupleIxdE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi3EE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!3 = distinct !{!3, !"_ZN17bnserve_inference6kernel7_source8contractB2v4B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5TupleI5ArrayIdLi1E1C7mutable7alignedExE5ArrayIdLi1E1C7mutable7alignedE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi3EE5TupleI5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi3EE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi4EE5TupleIxdE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi3EE5ArrayIdLi1E1C7mutable7alignedE"}
!4 = !{!5, !2}
!5 = distinct !{!5, !6, !"_ZN17bnserve_inference6kernel7_source6_knotsB3v14B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dEd5ArrayIdLi1E1C7mutable7alignedExxx: %retptr"}
!6 = distinct !{!6, !"_ZN17bnserve_inference6kernel7_source6_knotsB3v14B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dEd5ArrayIdLi1E1C7mutable7alignedExxx"}
!7 = distinct !{!7, !8}
!8 = !{!"llvm.loop.unroll.disable"}
!9 = distinct !{!9, !8}
!10 = !{!"branch_weights", i32 99, i32 1}
!11 = !{!12, !2}
!12 = distinct !{!12, !13, !"_ZN17bnserve_inference6kernel7_source9_geometryB2v5B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!13 = distinct !{!13, !"_ZN17bnserve_inference6kernel7_source9_geometryB2v5B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!14 = !{!15, !2}
!15 = distinct !{!15, !16, !"_ZN17bnserve_inference6kernel7_source10_errors_atB3v10B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedExx5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!16 = distinct !{!16, !"_ZN17bnserve_inference6kernel7_source10_errors_atB3v10B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedExx5ArrayIdLi1E1C7mutable7alignedE"}
!17 = !{!18, !2}
!18 = distinct !{!18, !19, !"_ZN17bnserve_inference6kernel7_source10_errors_atB3v10B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedExx5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!19 = distinct !{!19, !"_ZN17bnserve_inference6kernel7_source10_errors_atB3v10B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedExx5ArrayIdLi1E1C7mutable7alignedE"}
!20 = !{!21, !2}
!21 = distinct !{!21, !22, !"_ZN17bnserve_inference6kernel7_source10_calibrateB3v11B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!22 = distinct !{!22, !"_ZN17bnserve_inference6kernel7_source10_calibrateB3v11B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!23 = !{!24, !2}
!24 = distinct !{!24, !25, !"_ZN17bnserve_inference6kernel7_source15_fixed_productsB3v12B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedEd5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!25 = distinct !{!25, !"_ZN17bnserve_inference6kernel7_source15_fixed_productsB3v12B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedEd5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!26 = !{!27, !2}
!27 = distinct !{!27, !28, !"_ZN17bnserve_inference6kernel7_source9_productsB3v17B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedEd5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE8UniTupleIxLi3EE8UniTupleIdLi6EE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!28 = distinct !{!28, !"_ZN17bnserve_inference6kernel7_source9_productsB3v17B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedEd5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE8UniTupleIxLi3EE8UniTupleIdLi6EE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!29 = !{!30, !2}
!30 = distinct !{!30, !31, !"_ZN17bnserve_inference6kernel7_source9_lane_sumB3v19B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!31 = distinct !{!31, !"_ZN17bnserve_inference6kernel7_source9_lane_sumB3v19B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE"}
!32 = !{!33, !2}
!33 = distinct !{!33, !34, !"_ZN17bnserve_inference6kernel7_source9_lane_sumB3v19B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!34 = distinct !{!34, !"_ZN17bnserve_inference6kernel7_source9_lane_sumB3v19B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE"}
!35 = !{!36, !2}
!36 = distinct !{!36, !37, !"_ZN17bnserve_inference6kernel7_source10_errors_atB3v10B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedExx5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!37 = distinct !{!37, !"_ZN17bnserve_inference6kernel7_source10_errors_atB3v10B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedExx5ArrayIdLi1E1C7mutable7alignedE"}
!38 = !{!39, !2}
!39 = distinct !{!39, !40, !"_ZN17bnserve_inference6kernel7_source9_lane_sumB3v19B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!40 = distinct !{!40, !"_ZN17bnserve_inference6kernel7_source9_lane_sumB3v19B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE"}
