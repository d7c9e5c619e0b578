; sources: cc976eaca1ca9125cd3d9e1c8175b444ce5f1a79d09ea609ff58dffb6f649aea
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
  br i1 %162, label %B2136.else.if.i, label %B2136.else.endif.i, !prof !0

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
  %.892618.not.i.i = icmp slt i64 %.1134.i, 3
  %76 = icmp sgt i64 %..3029.i, 0
  %77 = icmp eq i64 %storemerge3204.i, 0
  %78 = icmp eq i64 %storemerge3206.i, 0
  %.789.i.i = udiv i64 %.1143.i, 3
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
  %.197.i3.i = fmul contract double %.195.i2.i, 0x3FE45F306DC9C883
  %.198.i4.i = fadd contract double %.197.i3.i, 0x4338000000000000
  %.199.i5.i = fadd contract double %.198.i4.i, 0xC338000000000000
  %.217.i6.i = fmul contract double %.199.i5.i, 0x3FF921FA00000000
  %.218.i.i = fsub contract double %.195.i2.i, %.217.i6.i
  %.236.i7.i = fmul contract double %.199.i5.i, 0x3EB5444200000000
  %.237.i8.i = fsub contract double %.218.i.i, %.236.i7.i
  %.255.i.i = fmul contract double %.199.i5.i, 0x3D6A308C00000000
  %.256.i.i = fsub contract double %.237.i8.i, %.255.i.i
  %.274.i.i = fmul contract double %.199.i5.i, 0x3C2313198A2E0370
  %.275.i.i = fsub contract double %.256.i.i, %.274.i.i
  %.276.i.i = fmul contract double %.275.i.i, %.275.i.i
  %.277.i9.i = fmul contract double %.275.i.i, %.276.i.i
  %.278.i10.i = fmul contract double %.276.i.i, 0x3D6AE7F3E733B81F
  %95 = fsub contract double 0x3DE6124613A86D09, %.278.i10.i
  %.280.i11.i = fmul contract double %.276.i.i, %95
  %.281.i.i = fadd contract double %.280.i11.i, 0xBE5AE64567F544E4
  %.282.i.i = fmul contract double %.276.i.i, %.281.i.i
  %.283.i.i = fadd contract double %.282.i.i, 0x3EC71DE3A556C734
  %.284.i12.i = fmul contract double %.276.i.i, %.283.i.i
  %.285.i.i = fadd contract double %.284.i12.i, 0xBF2A01A01A01A01A
  %.286.i13.i = fmul contract double %.276.i.i, %.285.i.i
  %.287.i14.i = fadd contract double %.286.i13.i, 0x3F81111111111111
  %.288.i15.i = fmul contract double %.276.i.i, %.287.i14.i
  %.289.i16.i = fadd contract double %.288.i15.i, 0xBFC5555555555555
  %.290.i.i = fmul contract double %.277.i9.i, %.289.i16.i
  %.291.i17.i = fadd contract double %.275.i.i, %.290.i.i
  %.292.i18.i = fmul contract double %.276.i.i, 0x3D2AE7F3E733B81F
  %.293.i.i = fadd contract double %.292.i18.i, 0xBDA93974A8C07C9D
  %.294.i.i = fmul contract double %.276.i.i, %.293.i.i
  %.295.i.i = fadd contract double %.294.i.i, 0x3E21EED8EFF8D898
  %.296.i.i = fmul contract double %.276.i.i, %.295.i.i
  %.297.i.i = fadd contract double %.296.i.i, 0xBE927E4FB7789F5C
  %.298.i.i = fmul contract double %.276.i.i, %.297.i.i
  %.299.i.i = fadd contract double %.298.i.i, 0x3EFA01A01A01A01A
  %.300.i.i = fmul contract double %.276.i.i, %.299.i.i
  %.301.i.i = fadd contract double %.300.i.i, 0xBF56C16C16C16C17
  %.302.i.i = fmul contract double %.276.i.i, %.301.i.i
  %.303.i.i = fadd contract double %.302.i.i, 0x3FA5555555555555
  %.304.i.i = fmul contract double %.276.i.i, %.303.i.i
  %.305.i.i = fadd contract double %.304.i.i, -5.000000e-01
  %.306.i.i = fmul contract double %.276.i.i, %.305.i.i
  %.307.i.i = fadd contract double %.306.i.i, 1.000000e+00
  %.308.i.i = bitcast double %.198.i4.i to i64
  %.309.i.i = and i64 %.308.i.i, 1
  %.311.i19.i = bitcast double %.291.i17.i to i64
  %.312.i20.i = bitcast double %.307.i.i to i64
  %.313.i.i = xor i64 %.312.i20.i, %.311.i19.i
  %96 = icmp eq i64 %.309.i.i, 0
  %.314.i21.i = select i1 %96, i64 0, i64 %.313.i.i
  %.315.i.i = shl i64 %.308.i.i, 62
  %.316.i.i = and i64 %.315.i.i, -9223372036854775808
  %.318.i.i = add i64 %.315.i.i, 4611686018427387904
  %.319.i22.i = and i64 %.318.i.i, -9223372036854775808
  %97 = xor i64 %.316.i.i, %.311.i19.i
  %.321.i.i = xor i64 %97, %.314.i21.i
  %.322.i.i = bitcast i64 %.321.i.i to double
  %98 = xor i64 %.319.i22.i, %.312.i20.i
  %.324.i23.i = xor i64 %98, %.314.i21.i
  %.325.i.i = bitcast i64 %.324.i23.i to double
  %.375.i24.i = getelementptr i8, ptr %.2950.i, i64 8
  %.376.i25.i = load double, ptr %.375.i24.i, align 8, !noalias !11
  %.377.i26.i = fmul contract double %.376.i25.i, 0x3FE45F306DC9C883
  %.378.i27.i = fadd contract double %.377.i26.i, 0x4338000000000000
  %.379.i28.i = fadd contract double %.378.i27.i, 0xC338000000000000
  %.397.i29.i = fmul contract double %.379.i28.i, 0x3FF921FA00000000
  %.398.i30.i = fsub contract double %.376.i25.i, %.397.i29.i
  %.416.i.i = fmul contract double %.379.i28.i, 0x3EB5444200000000
  %.417.i31.i = fsub contract double %.398.i30.i, %.416.i.i
  %.435.i.i = fmul contract double %.379.i28.i, 0x3D6A308C00000000
  %.436.i.i = fsub contract double %.417.i31.i, %.435.i.i
  %.454.i32.i = fmul contract double %.379.i28.i, 0x3C2313198A2E0370
  %.455.i.i = fsub contract double %.436.i.i, %.454.i32.i
  %.456.i.i = fmul contract double %.455.i.i, %.455.i.i
  %.457.i.i = fmul contract double %.455.i.i, %.456.i.i
  %.458.i.i = fmul contract double %.456.i.i, 0x3D6AE7F3E733B81F
  %99 = fsub contract double 0x3DE6124613A86D09, %.458.i.i
  %.460.i.i = fmul contract double %.456.i.i, %99
  %.461.i.i = fadd contract double %.460.i.i, 0xBE5AE64567F544E4
  %.462.i.i = fmul contract double %.456.i.i, %.461.i.i
  %.463.i.i = fadd contract double %.462.i.i, 0x3EC71DE3A556C734
  %.464.i.i = fmul contract double %.456.i.i, %.463.i.i
  %.465.i.i = fadd contract double %.464.i.i, 0xBF2A01A01A01A01A
  %.466.i.i = fmul contract double %.456.i.i, %.465.i.i
  %.467.i.i = fadd contract double %.466.i.i, 0x3F81111111111111
  %.468.i.i = fmul contract double %.456.i.i, %.467.i.i
  %.469.i.i = fadd contract double %.468.i.i, 0xBFC5555555555555
  %.470.i.i = fmul contract double %.457.i.i, %.469.i.i
  %.471.i.i = fadd contract double %.455.i.i, %.470.i.i
  %.472.i.i = fmul contract double %.456.i.i, 0x3D2AE7F3E733B81F
  %.473.i.i = fadd contract double %.472.i.i, 0xBDA93974A8C07C9D
  %.474.i.i = fmul contract double %.456.i.i, %.473.i.i
  %.475.i.i = fadd contract double %.474.i.i, 0x3E21EED8EFF8D898
  %.476.i.i = fmul contract double %.456.i.i, %.475.i.i
  %.477.i.i = fadd contract double %.476.i.i, 0xBE927E4FB7789F5C
  %.478.i.i = fmul contract double %.456.i.i, %.477.i.i
  %.479.i.i = fadd contract double %.478.i.i, 0x3EFA01A01A01A01A
  %.480.i33.i = fmul contract double %.456.i.i, %.479.i.i
  %.481.i34.i = fadd contract double %.480.i33.i, 0xBF56C16C16C16C17
  %.482.i35.i = fmul contract double %.456.i.i, %.481.i34.i
  %.483.i.i = fadd contract double %.482.i35.i, 0x3FA5555555555555
  %.484.i.i = fmul contract double %.456.i.i, %.483.i.i
  %.485.i.i = fadd contract double %.484.i.i, -5.000000e-01
  %.486.i.i = fmul contract double %.456.i.i, %.485.i.i
  %.487.i36.i = fadd contract double %.486.i.i, 1.000000e+00
  %.488.i.i = bitcast double %.378.i27.i to i64
  %.489.i37.i = and i64 %.488.i.i, 1
  %.491.i.i = bitcast double %.471.i.i to i64
  %.492.i.i = bitcast double %.487.i36.i to i64
  %.493.i.i = xor i64 %.492.i.i, %.491.i.i
  %100 = icmp eq i64 %.489.i37.i, 0
  %.494.i.i = select i1 %100, i64 0, i64 %.493.i.i
  %.495.i.i = shl i64 %.488.i.i, 62
  %.496.i.i = and i64 %.495.i.i, -9223372036854775808
  %.498.i38.i = add i64 %.495.i.i, 4611686018427387904
  %.499.i.i = and i64 %.498.i38.i, -9223372036854775808
  %101 = xor i64 %.496.i.i, %.491.i.i
  %.501.i.i = xor i64 %101, %.494.i.i
  %.502.i.i = bitcast i64 %.501.i.i to double
  %102 = xor i64 %.499.i.i, %.492.i.i
  %.504.i.i = xor i64 %102, %.494.i.i
  %.505.i.i = bitcast i64 %.504.i.i to double
  %.558.i.i = getelementptr i8, ptr %.2950.i, i64 16
  %.559.i.i = load double, ptr %.558.i.i, align 8, !noalias !11
  %.560.i.i = fmul contract double %.559.i.i, 0x3FE45F306DC9C883
  %.561.i.i = fadd contract double %.560.i.i, 0x4338000000000000
  %.562.i.i = fadd contract double %.561.i.i, 0xC338000000000000
  %.580.i.i = fmul contract double %.562.i.i, 0x3FF921FA00000000
  %.581.i.i = fsub contract double %.559.i.i, %.580.i.i
  %.599.i.i = fmul contract double %.562.i.i, 0x3EB5444200000000
  %.600.i.i = fsub contract double %.581.i.i, %.599.i.i
  %.618.i.i = fmul contract double %.562.i.i, 0x3D6A308C00000000
  %.619.i.i = fsub contract double %.600.i.i, %.618.i.i
  %.637.i.i = fmul contract double %.562.i.i, 0x3C2313198A2E0370
  %.638.i.i = fsub contract double %.619.i.i, %.637.i.i
  %.639.i.i = fmul contract double %.638.i.i, %.638.i.i
  %.640.i.i = fmul contract double %.638.i.i, %.639.i.i
  %.641.i.i = fmul contract double %.639.i.i, 0x3D6AE7F3E733B81F
  %103 = fsub contract double 0x3DE6124613A86D09, %.641.i.i
  %.643.i.i = fmul contract double %.639.i.i, %103
  %.644.i.i = fadd contract double %.643.i.i, 0xBE5AE64567F544E4
  %.645.i.i = fmul contract double %.639.i.i, %.644.i.i
  %.646.i.i = fadd contract double %.645.i.i, 0x3EC71DE3A556C734
  %.647.i.i = fmul contract double %.639.i.i, %.646.i.i
  %.648.i.i = fadd contract double %.647.i.i, 0xBF2A01A01A01A01A
  %.649.i.i = fmul contract double %.639.i.i, %.648.i.i
  %.650.i.i = fadd contract double %.649.i.i, 0x3F81111111111111
  %.651.i.i = fmul contract double %.639.i.i, %.650.i.i
  %.652.i.i = fadd contract double %.651.i.i, 0xBFC5555555555555
  %.653.i.i = fmul contract double %.640.i.i, %.652.i.i
  %.654.i.i = fadd contract double %.638.i.i, %.653.i.i
  %.655.i.i = fmul contract double %.639.i.i, 0x3D2AE7F3E733B81F
  %.656.i.i = fadd contract double %.655.i.i, 0xBDA93974A8C07C9D
  %.657.i.i = fmul contract double %.639.i.i, %.656.i.i
  %.658.i.i = fadd contract double %.657.i.i, 0x3E21EED8EFF8D898
  %.659.i.i = fmul contract double %.639.i.i, %.658.i.i
  %.660.i.i = fadd contract double %.659.i.i, 0xBE927E4FB7789F5C
  %.661.i.i = fmul contract double %.639.i.i, %.660.i.i
  %.662.i.i = fadd contract double %.661.i.i, 0x3EFA01A01A01A01A
  %.663.i.i = fmul contract double %.639.i.i, %.662.i.i
  %.664.i.i = fadd contract double %.663.i.i, 0xBF56C16C16C16C17
  %.665.i.i = fmul contract double %.639.i.i, %.664.i.i
  %.666.i.i = fadd contract double %.665.i.i, 0x3FA5555555555555
  %.667.i.i = fmul contract double %.639.i.i, %.666.i.i
  %.668.i39.i = fadd contract double %.667.i.i, -5.000000e-01
  %.669.i40.i = fmul contract double %.639.i.i, %.668.i39.i
  %.670.i.i = fadd contract double %.669.i40.i, 1.000000e+00
  %.671.i.i = bitcast double %.561.i.i to i64
  %.672.i.i = and i64 %.671.i.i, 1
  %.674.i.i = bitcast double %.654.i.i to i64
  %.675.i.i = bitcast double %.670.i.i to i64
  %.676.i.i = xor i64 %.675.i.i, %.674.i.i
  %104 = icmp eq i64 %.672.i.i, 0
  %.677.i.i = select i1 %104, i64 0, i64 %.676.i.i
  %.678.i.i = shl i64 %.671.i.i, 62
  %.679.i.i = and i64 %.678.i.i, -9223372036854775808
  %.681.i.i = add i64 %.678.i.i, 4611686018427387904
  %.682.i.i = and i64 %.681.i.i, -9223372036854775808
  %105 = xor i64 %.679.i.i, %.674.i.i
  %.684.i.i = xor i64 %105, %.677.i.i
  %.685.i.i = bitcast i64 %.684.i.i to double
  %106 = xor i64 %.682.i.i, %.675.i.i
  %.687.i.i = xor i64 %106, %.677.i.i
  %.688.i.i = bitcast i64 %.687.i.i to double
  %.709.i.i = fneg contract double %.688.i.i
  %.710.i.i = fmul contract double %.709.i.i, %.322.i.i
  %.711.i.i = fmul contract double %.685.i.i, %.325.i.i
  %.713.i.i = fmul contract double %.711.i.i, %.502.i.i
  %.714.i.i = fsub contract double %.710.i.i, %.713.i.i
  %.720.i.i = fmul contract double %.685.i.i, %.322.i.i
  %.722.i.i = fmul contract double %.720.i.i, %.502.i.i
  %107 = fmul contract double %.688.i.i, %.325.i.i
  %.723.i.i = fsub contract double %.722.i.i, %107
  %.727.i.i = fmul contract double %.505.i.i, %.685.i.i
  %.734.i.i = fmul contract double %107, %.502.i.i
  %.735.i.i = fsub contract double %.720.i.i, %.734.i.i
  %.740.i.i = fmul contract double %.688.i.i, %.322.i.i
  %.742.i.i = fmul contract double %.740.i.i, %.502.i.i
  %.743.i.i = fadd contract double %.711.i.i, %.742.i.i
  %.747.i.i = fmul contract double %.505.i.i, %.688.i.i
  %.751.i.i = fmul contract double %.505.i.i, %.325.i.i
  %.755.i.i = fneg contract double %.505.i.i
  %.756.i.i = fmul contract double %.755.i.i, %.322.i.i
  br i1 %.892618.not.i.i, label %_ZN17bnserve_inference6kernel7_source9_geometryB2v5B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i, label %B462.if.preheader.i.i

B462.if.preheader.i.i:                            ; preds = %B890.else.endif.endif.i
  %sunkaddr9.i.i = getelementptr i8, ptr %.2950.i, i64 32
  %sunkaddr11.i.i = getelementptr i8, ptr %.2950.i, i64 40
  %sunkaddr13.i.i = getelementptr i8, ptr %.2950.i, i64 48
  br label %B462.if.i.i

B462.if.i.i:                                      ; preds = %B466.endif.else.endif.endif.i.i, %B462.if.preheader.i.i
  %lsr.iv8.i.i = phi i64 [ %lsr.iv.next9.i.i, %B466.endif.else.endif.endif.i.i ], [ %.789.i.i, %B462.if.preheader.i.i ]
  %lsr.iv6.i.i = phi i64 [ %lsr.iv.next7.i.i, %B466.endif.else.endif.endif.i.i ], [ 0, %B462.if.preheader.i.i ]
  %lsr.iv.i41.i = phi i64 [ %lsr.iv.next.i42.i, %B466.endif.else.endif.endif.i.i ], [ 0, %B462.if.preheader.i.i ]
  %.979.not.i.i = icmp slt i64 %lsr.iv6.i.i, %arg.n_responses
  br i1 %.979.not.i.i, label %B466.else.endif.endif.i.i, label %B466.else.endif.if.i.i, !prof !10

B466.else.endif.if.i.i:                           ; preds = %B462.if.i.i
  br label %B466.else.endif.endif.i.i

B466.else.endif.endif.i.i:                        ; preds = %B466.else.endif.if.i.i, %B462.if.i.i
  %.959.sroa.0.3.i.i = phi i64 [ %arg.n_responses, %B466.else.endif.if.i.i ], [ %lsr.iv6.i.i, %B462.if.i.i ]
  %.1072.i.i = getelementptr double, ptr %arg.responses, i64 %.959.sroa.0.3.i.i
  %.1132.i.i = load double, ptr %.1072.i.i, align 8, !noalias !11
  %.1134.i.i = fmul contract double %.714.i.i, %.1132.i.i
  %.1162.i.i = getelementptr i8, ptr %.1072.i.i, i64 8
  %.1163.i.i = load double, ptr %.1162.i.i, align 8, !noalias !11
  %.1165.i.i = fmul contract double %.723.i.i, %.1163.i.i
  %.1166.i.i = fadd contract double %.1134.i.i, %.1165.i.i
  %.1194.i.i = getelementptr i8, ptr %.1072.i.i, i64 16
  %.1195.i.i = load double, ptr %.1194.i.i, align 8, !noalias !11
  %.1197.i.i = fmul contract double %.727.i.i, %.1195.i.i
  %.1198.i.i = fadd contract double %.1166.i.i, %.1197.i.i
  %.1226.i.i = getelementptr i8, ptr %.1072.i.i, i64 24
  %.1227.i.i = load double, ptr %.1226.i.i, align 8, !noalias !11
  %.1229.i.i = fmul contract double %.714.i.i, %.1227.i.i
  %.1257.i.i = getelementptr i8, ptr %.1072.i.i, i64 32
  %.1258.i.i = load double, ptr %.1257.i.i, align 8, !noalias !11
  %.1260.i.i = fmul contract double %.723.i.i, %.1258.i.i
  %.1261.i.i = fadd contract double %.1229.i.i, %.1260.i.i
  %.1289.i.i = getelementptr i8, ptr %.1072.i.i, i64 40
  %.1290.i.i = load double, ptr %.1289.i.i, align 8, !noalias !11
  %.1292.i.i = fmul contract double %.727.i.i, %.1290.i.i
  %.1293.i.i = fadd contract double %.1261.i.i, %.1292.i.i
  %.1321.i.i = getelementptr i8, ptr %.1072.i.i, i64 48
  %.1322.i.i = load double, ptr %.1321.i.i, align 8, !noalias !11
  %.1324.i.i = fmul contract double %.714.i.i, %.1322.i.i
  %.1352.i.i = getelementptr i8, ptr %.1072.i.i, i64 56
  %.1353.i.i = load double, ptr %.1352.i.i, align 8, !noalias !11
  %.1355.i.i = fmul contract double %.723.i.i, %.1353.i.i
  %.1356.i.i = fadd contract double %.1324.i.i, %.1355.i.i
  %.1384.i.i = getelementptr i8, ptr %.1072.i.i, i64 64
  %.1385.i.i = load double, ptr %.1384.i.i, align 8, !noalias !11
  %.1387.i.i = fmul contract double %.727.i.i, %.1385.i.i
  %.1388.i.i = fadd contract double %.1356.i.i, %.1387.i.i
  %.1419.i.i = fmul contract double %.735.i.i, %.1132.i.i
  %.1450.i.i = fmul contract double %.743.i.i, %.1163.i.i
  %.1451.i.i = fadd contract double %.1419.i.i, %.1450.i.i
  %.1482.i.i = fmul contract double %.747.i.i, %.1195.i.i
  %.1483.i.i = fadd contract double %.1451.i.i, %.1482.i.i
  %.1514.i.i = fmul contract double %.735.i.i, %.1227.i.i
  %.1545.i.i = fmul contract double %.743.i.i, %.1258.i.i
  %.1546.i.i = fadd contract double %.1514.i.i, %.1545.i.i
  %.1577.i.i = fmul contract double %.747.i.i, %.1290.i.i
  %.1578.i.i = fadd contract double %.1546.i.i, %.1577.i.i
  %.1609.i.i = fmul contract double %.735.i.i, %.1322.i.i
  %.1640.i.i = fmul contract double %.743.i.i, %.1353.i.i
  %.1641.i.i = fadd contract double %.1609.i.i, %.1640.i.i
  %.1675.i.i = fmul contract double %.747.i.i, %.1385.i.i
  %.1676.i.i = fadd contract double %.1641.i.i, %.1675.i.i
  %.1678.i.i = fmul contract double %.714.i.i, %.1198.i.i
  %.1680.i.i = fmul contract double %.723.i.i, %.1293.i.i
  %.1681.i.i = fadd contract double %.1678.i.i, %.1680.i.i
  %.1683.i.i = fmul contract double %.727.i.i, %.1388.i.i
  %.1684.i.i = fadd contract double %.1681.i.i, %.1683.i.i
  %.1686.i.i = fmul contract double %.735.i.i, %.1483.i.i
  %.1688.i.i = fmul contract double %.743.i.i, %.1578.i.i
  %.1689.i.i = fadd contract double %.1686.i.i, %.1688.i.i
  %.1691.i.i = fmul contract double %.747.i.i, %.1676.i.i
  %.1692.i.i = fadd contract double %.1689.i.i, %.1691.i.i
  %.1693.i.i = fsub contract double %.1684.i.i, %.1692.i.i
  %.1695.i.i = fmul contract double %.714.i.i, %.1483.i.i
  %.1697.i.i = fmul contract double %.723.i.i, %.1578.i.i
  %.1698.i.i = fadd contract double %.1695.i.i, %.1697.i.i
  %.1700.i.i = fmul contract double %.727.i.i, %.1676.i.i
  %.1701.i.i = fadd contract double %.1698.i.i, %.1700.i.i
  %.1703.i.i = fmul contract double %.735.i.i, %.1198.i.i
  %.1705.i.i = fmul contract double %.743.i.i, %.1293.i.i
  %.1706.i.i = fadd contract double %.1703.i.i, %.1705.i.i
  %.1708.i.i = fmul contract double %.747.i.i, %.1388.i.i
  %.1709.i.i = fadd contract double %.1706.i.i, %.1708.i.i
  %.1710.i.i = fadd contract double %.1701.i.i, %.1709.i.i
  %.1760.not.i.i = icmp slt i64 %lsr.iv.i41.i, %arg.n_locations
  br i1 %.1760.not.i.i, label %B466.endif.else.endif.endif.i.i, label %B466.endif.else.endif.if.i.i, !prof !10

B466.endif.else.endif.if.i.i:                     ; preds = %B466.else.endif.endif.i.i
  br label %B466.endif.else.endif.endif.i.i

B466.endif.else.endif.endif.i.i:                  ; preds = %B466.endif.else.endif.if.i.i, %B466.else.endif.endif.i.i
  %.1740.sroa.0.3.i.i = phi i64 [ %arg.n_locations, %B466.endif.else.endif.if.i.i ], [ %lsr.iv.i41.i, %B466.else.endif.endif.i.i ]
  %.1853.i.i = getelementptr double, ptr %arg.locations, i64 %.1740.sroa.0.3.i.i
  %.1914.i.i = load double, ptr %sunkaddr9.i.i, align 8, !noalias !11
  %.1915.i.i = fmul contract double %.1693.i.i, %.1914.i.i
  %.1945.i.i = load double, ptr %sunkaddr11.i.i, align 8, !noalias !11
  %.1946.i.i = fmul contract double %.1710.i.i, %.1945.i.i
  %.1947.i.i = fadd contract double %.1915.i.i, %.1946.i.i
  %sunkaddr.i.i = shl i64 %lsr.iv.i41.i, 3
  %sunkaddr12.i.i = getelementptr i8, ptr %.1159.i, i64 %sunkaddr.i.i
  store double %.1947.i.i, ptr %sunkaddr12.i.i, align 8, !noalias !11
  %.2008.i.i = load double, ptr %sunkaddr13.i.i, align 8, !noalias !11
  %.2009.i.i = fmul contract double %.1710.i.i, %.2008.i.i
  %sunkaddr16.i.i = getelementptr i8, ptr %sunkaddr12.i.i, i64 8
  store double %.2009.i.i, ptr %sunkaddr16.i.i, align 8, !noalias !11
  %.2070.i.i = load double, ptr %.1853.i.i, align 8, !noalias !11
  %.2072.i.i = fmul contract double %.751.i.i, %.2070.i.i
  %.2100.i.i = getelementptr i8, ptr %.1853.i.i, i64 8
  %.2101.i.i = load double, ptr %.2100.i.i, align 8, !noalias !11
  %.2103.i.i = fmul contract double %.756.i.i, %.2101.i.i
  %.2104.i.i = fadd contract double %.2072.i.i, %.2103.i.i
  %.2132.i.i = getelementptr i8, ptr %.1853.i.i, i64 16
  %.2133.i.i = load double, ptr %.2132.i.i, align 8, !noalias !11
  %.2138.i.i = fmul contract double %.2133.i.i, %.502.i.i
  %.2139.i.i = fadd contract double %.2104.i.i, %.2138.i.i
  %.2144.i.i = fdiv contract double %.2139.i.i, 0xC1B1DE784A000000
  %sunkaddr19.i.i = getelementptr i8, ptr %sunkaddr12.i.i, i64 16
  store double %.2144.i.i, ptr %sunkaddr19.i.i, align 8, !noalias !11
  %lsr.iv.next.i42.i = add nuw nsw i64 %lsr.iv.i41.i, 3
  %lsr.iv.next7.i.i = add nuw i64 %lsr.iv6.i.i, 9
  %lsr.iv.next9.i.i = add nsw i64 %lsr.iv8.i.i, -1
  %exitcond.not.i43.i = icmp eq i64 %lsr.iv.next9.i.i, 0
  br i1 %exitcond.not.i43.i, label %_ZN17bnserve_inference6kernel7_source9_geometryB2v5B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i, label %B462.if.i.i

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
  %108 = add i64 %.383132763278.i, %.3625.sroa.0.068.i
  %.3878.i = icmp slt i64 %108, 0
  %109 = select i1 %.3878.i, i64 %72, i64 0
  %scevgep385.i = getelementptr i8, ptr %scevgep384.i, i64 %109
  %110 = shl nuw nsw i64 %.383132763278.i, 3
  %scevgep22.i = getelementptr i8, ptr %scevgep385.i, i64 %110
  %.3894.i = load i64, ptr %scevgep22.i, align 8, !noalias !1
  %.3909.i = icmp slt i64 %.3894.i, 0
  %.3910.i = select i1 %.3909.i, i64 %.3500.i, i64 0
  %.idx.i = shl i64 %.3894.i, 4
  %111 = getelementptr i8, ptr %.3516.i, i64 %.idx.i
  %.3924.i = getelementptr double, ptr %111, i64 %.3910.i
  %.3925.i = load double, ptr %.3924.i, align 8, !noalias !1
  %scevgep21.i = getelementptr i8, ptr %.1339.i, i64 %110
  store double %.3925.i, ptr %scevgep21.i, align 8, !noalias !1
  %.3987.i = load i64, ptr %scevgep22.i, align 8, !noalias !1
  %.4003.i = icmp slt i64 %.3987.i, 0
  %.4004.i = select i1 %.4003.i, i64 %.3500.i, i64 0
  %.idx3218.i = shl i64 %.3987.i, 4
  %112 = getelementptr i8, ptr %.3516.i, i64 %.idx3218.i
  %113 = getelementptr i8, ptr %112, i64 8
  %.4018.i = getelementptr double, ptr %113, i64 %.4004.i
  %.4019.i = load double, ptr %.4018.i, align 8, !noalias !1
  %scevgep20.i = getelementptr i8, ptr %.1513.i, i64 %110
  store double %.4019.i, ptr %scevgep20.i, align 8, !noalias !1
  %exitcond3984.not.i = icmp eq i64 %.13.i98.i, %.3838.i
  br i1 %exitcond3984.not.i, label %B1410.i, label %B1306.if.i

B1442.if.i:                                       ; preds = %B1442.if.i, %B1442.if.preheader381.i
  %lsr.iv.i = phi i64 [ %4, %B1442.if.preheader381.i ], [ %lsr.iv.next.i, %B1442.if.i ]
  %.414232833285.i = phi i64 [ %.414232833285.unr.i, %B1442.if.preheader381.i ], [ %120, %B1442.if.i ]
  %.4187.i = icmp slt i64 %.414232833285.i, 0
  %114 = select i1 %.4187.i, i64 %73, i64 0
  %scevgep389.i = getelementptr i8, ptr %.1339.i, i64 %114
  %115 = shl i64 %.414232833285.i, 3
  %scevgep390.i = getelementptr i8, ptr %scevgep389.i, i64 %115
  store double 0.000000e+00, ptr %scevgep390.i, align 8, !noalias !1
  %116 = select i1 %.4187.i, i64 %74, i64 0
  %scevgep387.i = getelementptr i8, ptr %.1513.i, i64 %116
  %scevgep388.i = getelementptr i8, ptr %scevgep387.i, i64 %115
  store double 0.000000e+00, ptr %scevgep388.i, align 8, !noalias !1
  %117 = add i64 %.414232833285.i, 1
  %.4187.1.i = icmp slt i64 %117, 0
  %118 = select i1 %.4187.1.i, i64 %80, i64 8
  %scevgep24.i = getelementptr i8, ptr %.1339.i, i64 %118
  %scevgep25.i = getelementptr i8, ptr %scevgep24.i, i64 %115
  store double 0.000000e+00, ptr %scevgep25.i, align 8, !noalias !1
  %119 = select i1 %.4187.1.i, i64 %81, i64 8
  %scevgep.i = getelementptr i8, ptr %.1513.i, i64 %119
  %scevgep23.i = getelementptr i8, ptr %scevgep.i, i64 %115
  store double 0.000000e+00, ptr %scevgep23.i, align 8, !noalias !1
  %lsr.iv.next.i = add i64 %lsr.iv.i, -2
  %.4136.1.i = icmp sgt i64 %lsr.iv.next.i, 2
  %120 = add i64 %.414232833285.i, 2
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
  %121 = shl nuw i64 %.4669.i, 3
  tail call void @llvm.memset.p0.i64(ptr align 8 %.4685.i, i8 0, i64 %121, i1 false), !noalias !14
  br label %B76.i.i

B76.i.i:                                          ; preds = %B60.if.preheader.i.i, %B1516.endif.else.endif.endif.endif.endif.i
  %.311284.not.i.i = icmp slt i64 %.4488.i, 1
  br i1 %.311284.not.i.i, label %B1516.endif.endif.endif.i, label %B128.if.lr.ph.i.i

B128.if.lr.ph.i.i:                                ; preds = %B76.i.i
  %122 = add nsw i64 %.4669.i, -2
  %123 = lshr i64 %122, 1
  %124 = add nuw i64 %123, 1
  %125 = shl i64 %.4572.sroa.0.3.i, 3
  %scevgep398.i = getelementptr i8, ptr %scevgep397.i, i64 %125
  %126 = lshr i64 %124, 1
  %127 = mul nsw i64 %126, -2
  %128 = icmp eq i64 %.4660.i, 1
  %129 = icmp eq i64 %123, 0
  %130 = and i64 %122, 2
  %131 = icmp eq i64 %130, 0
  %132 = and i64 %.4669.i, 1
  %133 = icmp eq i64 %132, 0
  br label %B128.if.i.i

B284.loopexit.unr-lcssa.i.unr-lcssa.i:            ; preds = %B228.if.i.i
  br i1 %131, label %B228.if.i.epil.preheader.i, label %B284.loopexit.unr-lcssa.i.i

B228.if.i.epil.preheader.i:                       ; preds = %B228.if.preheader2.i.i, %B284.loopexit.unr-lcssa.i.unr-lcssa.i
  %.655272274.i.epil.init.i = phi i64 [ 0, %B228.if.preheader2.i.i ], [ %.662.1.i.1.i, %B284.loopexit.unr-lcssa.i.unr-lcssa.i ]
  %134 = shl i64 %.655272274.i.epil.init.i, 3
  %sunkaddr11.i.epil.i = getelementptr i8, ptr %.4685.i, i64 %134
  %.716.i.epil.i = load double, ptr %sunkaddr11.i.epil.i, align 8, !noalias !14
  %scevgep9.i.epil.i = getelementptr i8, ptr %scevgep7.i.i, i64 %134
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
  br i1 %133, label %B284.i.i, label %B228.if.epil.preheader.i.i

B228.if.epil.preheader.i.i:                       ; preds = %B228.if.preheader.i.i, %B284.loopexit.unr-lcssa.i.i
  %.655272274.epil.init.i.i = phi i64 [ 0, %B228.if.preheader.i.i ], [ %.662.1.i.lcssa.i, %B284.loopexit.unr-lcssa.i.i ]
  %135 = getelementptr double, ptr %.4685.i, i64 %.655272274.epil.init.i.i
  %.716.epil.i.i = load double, ptr %135, align 8, !noalias !14
  %136 = getelementptr double, ptr %.498.i.i, i64 %.655272274.epil.init.i.i
  %.746.epil.i.i = load double, ptr %136, align 8, !noalias !14
  %.748.epil.i.i = fmul contract double %.565.i.i, %.746.epil.i.i
  %.749.epil.i.i = fadd contract double %.716.epil.i.i, %.748.epil.i.i
  store double %.749.epil.i.i, ptr %135, align 8, !noalias !14
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
  %137 = getelementptr double, ptr %.4513.i, i64 %.317279285.i.i
  %.565.i.i = load double, ptr %137, align 8, !noalias !14
  br i1 %.104.i.not.i, label %B284.i.i, label %B228.if.preheader.i.i

B228.if.preheader.i.i:                            ; preds = %B130.else.endif.endif.endif.endif.i.i
  br i1 %128, label %B228.if.epil.preheader.i.i, label %B228.if.preheader2.i.i

B228.if.preheader2.i.i:                           ; preds = %B228.if.preheader.i.i
  %138 = shl i64 %.385.sroa.0.3.i.i, 3
  %scevgep7.i.i = getelementptr i8, ptr %scevgep6.i.i, i64 %138
  br i1 %129, label %B228.if.i.epil.preheader.i, label %B228.if.i.preheader.i

B228.if.i.preheader.i:                            ; preds = %B228.if.preheader2.i.i
  %scevgep407.i = getelementptr i8, ptr %scevgep406.i, i64 %138
  br label %B228.if.i.i

B228.if.i.i:                                      ; preds = %B228.if.i.i, %B228.if.i.preheader.i
  %lsr.iv26.i = phi i64 [ %lsr.iv.next27.i, %B228.if.i.i ], [ %127, %B228.if.i.preheader.i ]
  %.655272274.i.i = phi i64 [ %.662.1.i.1.i, %B228.if.i.i ], [ 0, %B228.if.i.preheader.i ]
  %139 = shl i64 %.655272274.i.i, 3
  %scevgep404.i = getelementptr i8, ptr %scevgep398.i, i64 %139
  %scevgep405.i = getelementptr i8, ptr %scevgep404.i, i64 -24
  %.716.i.i = load double, ptr %scevgep405.i, align 8, !noalias !14
  %scevgep410.i = getelementptr i8, ptr %scevgep407.i, i64 %139
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
  %140 = shl nuw i64 %.5054.i, 3
  tail call void @llvm.memset.p0.i64(ptr align 8 %.5070.i, i8 0, i64 %140, i1 false), !noalias !17
  br label %B76.i100.i

B76.i100.i:                                       ; preds = %B60.if.preheader.i151.i, %B1516.endif.endif.endif.e...endif.i
  %.311284.not.i101.i = icmp slt i64 %.4873.i, 1
  br i1 %.311284.not.i101.i, label %B1516.endif.endif.endif.endif.endif.endif.i, label %B128.if.lr.ph.i102.i

B128.if.lr.ph.i102.i:                             ; preds = %B76.i100.i
  %141 = add nsw i64 %.5054.i, -2
  %142 = lshr i64 %141, 1
  %143 = add nuw i64 %142, 1
  %144 = shl i64 %.4957.sroa.0.3.i, 3
  %scevgep417.i = getelementptr i8, ptr %scevgep416.i, i64 %144
  %145 = lshr i64 %143, 1
  %146 = mul nsw i64 %145, -2
  %147 = icmp eq i64 %.5045.i, 1
  %148 = icmp eq i64 %142, 0
  %149 = and i64 %141, 2
  %150 = icmp eq i64 %149, 0
  %151 = and i64 %.5054.i, 1
  %152 = icmp eq i64 %151, 0
  br label %B128.if.i105.i

B284.loopexit.unr-lcssa.i141.unr-lcssa.i:         ; preds = %B228.if.i125.i
  br i1 %150, label %B228.if.i125.epil.preheader.i, label %B284.loopexit.unr-lcssa.i141.i

B228.if.i125.epil.preheader.i:                    ; preds = %B228.if.preheader2.i123.i, %B284.loopexit.unr-lcssa.i141.unr-lcssa.i
  %.655272274.i126.epil.init.i = phi i64 [ 0, %B228.if.preheader2.i123.i ], [ %.662.1.i134.1.i, %B284.loopexit.unr-lcssa.i141.unr-lcssa.i ]
  %153 = shl i64 %.655272274.i126.epil.init.i, 3
  %sunkaddr11.i127.epil.i = getelementptr i8, ptr %.5070.i, i64 %153
  %.716.i128.epil.i = load double, ptr %sunkaddr11.i127.epil.i, align 8, !noalias !17
  %scevgep9.i129.epil.i = getelementptr i8, ptr %scevgep7.i124.i, i64 %153
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
  br i1 %152, label %B284.i148.i, label %B228.if.epil.preheader.i142.i

B228.if.epil.preheader.i142.i:                    ; preds = %B228.if.preheader.i122.i, %B284.loopexit.unr-lcssa.i141.i
  %.655272274.epil.init.i143.i = phi i64 [ 0, %B228.if.preheader.i122.i ], [ %.662.1.i134.lcssa.i, %B284.loopexit.unr-lcssa.i141.i ]
  %154 = getelementptr double, ptr %.5070.i, i64 %.655272274.epil.init.i143.i
  %.716.epil.i144.i = load double, ptr %154, align 8, !noalias !17
  %155 = getelementptr double, ptr %.498.i120.i, i64 %.655272274.epil.init.i143.i
  %.746.epil.i145.i = load double, ptr %155, align 8, !noalias !17
  %.748.epil.i146.i = fmul contract double %.565.i121.i, %.746.epil.i145.i
  %.749.epil.i147.i = fadd contract double %.716.epil.i144.i, %.748.epil.i146.i
  store double %.749.epil.i147.i, ptr %154, align 8, !noalias !17
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
  %156 = getelementptr double, ptr %.4898.i, i64 %.317279285.i106.i
  %.565.i121.i = load double, ptr %156, align 8, !noalias !17
  br i1 %.104.i99.not.i, label %B284.i148.i, label %B228.if.preheader.i122.i

B228.if.preheader.i122.i:                         ; preds = %B130.else.endif.endif.endif.endif.i118.i
  br i1 %147, label %B228.if.epil.preheader.i142.i, label %B228.if.preheader2.i123.i

B228.if.preheader2.i123.i:                        ; preds = %B228.if.preheader.i122.i
  %157 = shl i64 %.385.sroa.0.3.i119.i, 3
  %scevgep7.i124.i = getelementptr i8, ptr %scevgep6.i.i, i64 %157
  br i1 %148, label %B228.if.i125.epil.preheader.i, label %B228.if.i125.preheader.i

B228.if.i125.preheader.i:                         ; preds = %B228.if.preheader2.i123.i
  %scevgep426.i = getelementptr i8, ptr %scevgep406.i, i64 %157
  br label %B228.if.i125.i

B228.if.i125.i:                                   ; preds = %B228.if.i125.i, %B228.if.i125.preheader.i
  %lsr.iv36.i = phi i64 [ %lsr.iv.next37.i, %B228.if.i125.i ], [ %146, %B228.if.i125.preheader.i ]
  %.655272274.i126.i = phi i64 [ %.662.1.i134.1.i, %B228.if.i125.i ], [ 0, %B228.if.i125.preheader.i ]
  %158 = shl i64 %.655272274.i126.i, 3
  %scevgep423.i = getelementptr i8, ptr %scevgep417.i, i64 %158
  %scevgep424.i = getelementptr i8, ptr %scevgep423.i, i64 -24
  %.716.i128.i = load double, ptr %scevgep424.i, align 8, !noalias !17
  %scevgep429.i = getelementptr i8, ptr %scevgep426.i, i64 %158
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
  %159 = shl i64 %.186192194.i.i, 3
  %scevgep5.i.i = getelementptr i8, ptr %.5454.i, i64 %159
  %.247.i154.i = load double, ptr %scevgep5.i.i, align 8, !noalias !20
  %scevgep4.i.i = getelementptr i8, ptr %.5282.i, i64 %159
  %.277.i.i = load double, ptr %scevgep4.i.i, align 8, !noalias !20
  %.278.i.i = fadd contract double %.277.i.i, 1.000000e+00
  %.279.i.i = fmul contract double %.247.i154.i, %.247.i154.i
  %.280.i.i = fadd contract double %.279.i.i, 4.000000e+00
  %.284.i.i = fdiv contract double %.278.i.i, %.280.i.i
  %.286.i.i = fsub contract double 4.000000e+00, %.279.i.i
  %.287.i.i = fmul contract double %.286.i.i, %.284.i.i
  %.288.i.i = fmul contract double %.247.i154.i, 4.000000e+00
  %.289.i.i = fmul contract double %.288.i.i, %.284.i.i
  %scevgep49.i = getelementptr i8, ptr %.5626.i, i64 %159
  %.319.i.i = load double, ptr %scevgep49.i, align 8, !noalias !20
  %.320.i.i = fmul contract double %.319.i.i, %.287.i.i
  %scevgep48.i = getelementptr i8, ptr %.5798.i, i64 %159
  %.350.i155.i = load double, ptr %scevgep48.i, align 8, !noalias !20
  %.351.i.i = fmul contract double %.350.i155.i, %.289.i.i
  %.352.i156.i = fsub contract double %.320.i.i, %.351.i.i
  %scevgep47.i = getelementptr i8, ptr %.5970.i, i64 %159
  store double %.352.i156.i, ptr %scevgep47.i, align 8, !noalias !20
  %.412.i.i = load double, ptr %scevgep49.i, align 8, !noalias !20
  %.413.i.i = fmul contract double %.289.i.i, %.412.i.i
  %.443.i.i = load double, ptr %scevgep48.i, align 8, !noalias !20
  %.444.i.i = fmul contract double %.287.i.i, %.443.i.i
  %.445.i.i = fadd contract double %.413.i.i, %.444.i.i
  %scevgep46.i = getelementptr i8, ptr %.6142.i, i64 %159
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
  %160 = getelementptr i8, ptr %.1159.i, i64 %.idx92.i
  %.7196.i = getelementptr double, ptr %160, i64 %.7182.i
  %.7197.i = load double, ptr %.7196.i, align 8, !noalias !1
  %161 = getelementptr i8, ptr %160, i64 8
  %.7229.i = getelementptr double, ptr %161, i64 %.7182.i
  %.7230.i = load double, ptr %.7229.i, align 8, !noalias !1
  %.7475.i = select i1 %.8522.i, i64 %.7112.i, i64 0
  %.7476.i = add i64 %.7475.i, %.3625.sroa.0.068.i
  %.7654.i = select i1 %7, i64 %.7112.i, i64 0
  %.7655.i = add i64 %.7654.i, %.7611.i
  br i1 %60, label %B2054.preheader.i, label %B2658.i

B2054.preheader.i:                                ; preds = %B1908.else.endif.endif.endif.endif.i
  %sunkaddr.i = shl i64 %.7182.i, 3
  %sunkaddr100.i = getelementptr i8, ptr %160, i64 %sunkaddr.i
  %sunkaddr101.i = getelementptr i8, ptr %sunkaddr100.i, i64 16
  %162 = icmp slt i64 %.7476.i, 0
  %163 = icmp slt i64 %.7476.i, %.7112.i
  %164 = icmp slt i64 %.7655.i, 0
  %165 = icmp slt i64 %.7655.i, %.7112.i
  br label %B2054.i

B2136.else.if.i:                                  ; preds = %B2136.i
  br label %B2136.else.endif.i

B2136.else.endif.i:                               ; preds = %B2136.else.if.i, %B2136.i
  %.7464.sroa.0.1.i = phi i64 [ 0, %B2136.else.if.i ], [ %.7476.i, %B2136.i ]
  br i1 %163, label %B2136.else.endif.endif.i, label %B2136.else.endif.if.i, !prof !10

B2136.else.endif.if.i:                            ; preds = %B2136.else.endif.i
  br label %B2136.else.endif.endif.i

B2136.else.endif.endif.i:                         ; preds = %B2136.else.endif.if.i, %B2136.else.endif.i
  %.7464.sroa.0.3.i = phi i64 [ %.7112.i, %B2136.else.endif.if.i ], [ %.7464.sroa.0.1.i, %B2136.else.endif.i ]
  %.7577.i = getelementptr double, ptr %.7128.i, i64 %.7464.sroa.0.3.i
  br i1 %164, label %B2136.endif.else.if.i, label %B2136.endif.else.endif.i, !prof !0

B2136.endif.else.if.i:                            ; preds = %B2136.else.endif.endif.i
  br label %B2136.endif.else.endif.i

B2136.endif.else.endif.i:                         ; preds = %B2136.endif.else.if.i, %B2136.else.endif.endif.i
  %.7643.sroa.0.1.i = phi i64 [ 0, %B2136.endif.else.if.i ], [ %.7655.i, %B2136.else.endif.endif.i ]
  br i1 %165, label %B2136.endif.else.endif.endif.i, label %B2136.endif.else.endif.if.i, !prof !10

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
  %166 = shl i64 %.206238240.i.i, 3
  %scevgep6.i159.i = getelementptr i8, ptr %.7938.i, i64 %166
  %.268.i.i = load double, ptr %scevgep6.i159.i, align 8, !noalias !23
  %.270.i.i = fmul contract double %.104.i157.i, %.268.i.i
  %.271.i.i = fmul contract double %.270.i.i, 0x3FE45F306DC9C883
  %.272.i.i = fadd contract double %.271.i.i, 0x4338000000000000
  %.273.i.i = fadd contract double %.272.i.i, 0xC338000000000000
  %.291.i.i = fmul contract double %.273.i.i, 0x3FF921FA00000000
  %.292.i.i = fsub contract double %.270.i.i, %.291.i.i
  %.310.i.i = fmul contract double %.273.i.i, 0x3EB5444200000000
  %.311.i.i = fsub contract double %.292.i.i, %.310.i.i
  %.329.i.i = fmul contract double %.273.i.i, 0x3D6A308C00000000
  %.330.i.i = fsub contract double %.311.i.i, %.329.i.i
  %.348.i.i = fmul contract double %.273.i.i, 0x3C2313198A2E0370
  %.349.i.i = fsub contract double %.330.i.i, %.348.i.i
  %.350.i160.i = fmul contract double %.349.i.i, %.349.i.i
  %.351.i161.i = fmul contract double %.349.i.i, %.350.i160.i
  %.352.i162.i = fmul contract double %.350.i160.i, 0x3D6AE7F3E733B81F
  %167 = fsub contract double 0x3DE6124613A86D09, %.352.i162.i
  %.354.i.i = fmul contract double %.350.i160.i, %167
  %.355.i.i = fadd contract double %.354.i.i, 0xBE5AE64567F544E4
  %.356.i.i = fmul contract double %.350.i160.i, %.355.i.i
  %.357.i.i = fadd contract double %.356.i.i, 0x3EC71DE3A556C734
  %.358.i.i = fmul contract double %.350.i160.i, %.357.i.i
  %.359.i.i = fadd contract double %.358.i.i, 0xBF2A01A01A01A01A
  %.360.i.i = fmul contract double %.350.i160.i, %.359.i.i
  %.361.i.i = fadd contract double %.360.i.i, 0x3F81111111111111
  %.362.i.i = fmul contract double %.350.i160.i, %.361.i.i
  %.363.i.i = fadd contract double %.362.i.i, 0xBFC5555555555555
  %.364.i.i = fmul contract double %.351.i161.i, %.363.i.i
  %.365.i.i = fadd contract double %.349.i.i, %.364.i.i
  %.366.i.i = fmul contract double %.350.i160.i, 0x3D2AE7F3E733B81F
  %.367.i.i = fadd contract double %.366.i.i, 0xBDA93974A8C07C9D
  %.368.i.i = fmul contract double %.350.i160.i, %.367.i.i
  %.369.i.i = fadd contract double %.368.i.i, 0x3E21EED8EFF8D898
  %.370.i.i = fmul contract double %.350.i160.i, %.369.i.i
  %.371.i.i = fadd contract double %.370.i.i, 0xBE927E4FB7789F5C
  %.372.i.i = fmul contract double %.350.i160.i, %.371.i.i
  %.373.i.i = fadd contract double %.372.i.i, 0x3EFA01A01A01A01A
  %.374.i.i = fmul contract double %.350.i160.i, %.373.i.i
  %.375.i.i = fadd contract double %.374.i.i, 0xBF56C16C16C16C17
  %.376.i.i = fmul contract double %.350.i160.i, %.375.i.i
  %.377.i.i = fadd contract double %.376.i.i, 0x3FA5555555555555
  %.378.i.i = fmul contract double %.350.i160.i, %.377.i.i
  %.379.i.i = fadd contract double %.378.i.i, -5.000000e-01
  %.380.i.i = fmul contract double %.350.i160.i, %.379.i.i
  %.381.i.i = fadd contract double %.380.i.i, 1.000000e+00
  %.382.i.i = bitcast double %.272.i.i to i64
  %.383.i.i = and i64 %.382.i.i, 1
  %.385.i.i = bitcast double %.365.i.i to i64
  %.386.i.i = bitcast double %.381.i.i to i64
  %.387.i.i = xor i64 %.386.i.i, %.385.i.i
  %168 = icmp eq i64 %.383.i.i, 0
  %.388.i.i = select i1 %168, i64 0, i64 %.387.i.i
  %.389.i.i = shl i64 %.382.i.i, 62
  %.390.i.i = and i64 %.389.i.i, -9223372036854775808
  %.392.i.i = add i64 %.389.i.i, 4611686018427387904
  %.393.i.i = and i64 %.392.i.i, -9223372036854775808
  %169 = xor i64 %.390.i.i, %.385.i.i
  %.395.i163.i = xor i64 %169, %.388.i.i
  %.396.i164.i = bitcast i64 %.395.i163.i to double
  %170 = xor i64 %.393.i.i, %.386.i.i
  %.398.i.i = xor i64 %170, %.388.i.i
  %.399.i.i = bitcast i64 %.398.i.i to double
  %scevgep55.i = getelementptr i8, ptr %sr.2.sroa.36.3.i, i64 %166
  %.449.i.i = load double, ptr %scevgep55.i, align 8, !noalias !23
  %.450.i.i = fmul contract double %.449.i.i, %.399.i.i
  %scevgep54.i = getelementptr i8, ptr %si.2.sroa.36.3.i, i64 %166
  %.480.i.i = load double, ptr %scevgep54.i, align 8, !noalias !23
  %.481.i.i = fmul contract double %.480.i.i, %.396.i164.i
  %.482.i.i = fsub contract double %.450.i.i, %.481.i.i
  %.513.i.i = fmul contract double %.449.i.i, %.396.i164.i
  %.544.i.i = fmul contract double %.480.i.i, %.399.i.i
  %.545.i.i = fadd contract double %.513.i.i, %.544.i.i
  %scevgep53.i = getelementptr i8, ptr %.7577.i, i64 %166
  %.575.i.i = load double, ptr %scevgep53.i, align 8, !noalias !23
  %.576.i.i = fmul contract double %.575.i.i, %.482.i.i
  %scevgep52.i = getelementptr i8, ptr %.7756.i, i64 %166
  %.606.i.i = load double, ptr %scevgep52.i, align 8, !noalias !23
  %.607.i.i = fmul contract double %.606.i.i, %.545.i.i
  %.608.i.i = fsub contract double %.576.i.i, %.607.i.i
  %scevgep51.i = getelementptr i8, ptr %.8110.i, i64 %166
  store double %.608.i.i, ptr %scevgep51.i, align 8, !noalias !23
  %.668.i.i = load double, ptr %scevgep53.i, align 8, !noalias !23
  %.669.i.i = fmul contract double %.668.i.i, %.545.i.i
  %.699.i.i = load double, ptr %scevgep52.i, align 8, !noalias !23
  %.700.i.i = fmul contract double %.699.i.i, %.482.i.i
  %.701.i.i = fadd contract double %.669.i.i, %.700.i.i
  %scevgep50.i = getelementptr i8, ptr %.8282.i, i64 %166
  store double %.701.i.i, ptr %scevgep50.i, align 8, !noalias !23
  %exitcond.not.i171.i = icmp eq i64 %.7913.i, %.213.i158.i
  br i1 %exitcond.not.i171.i, label %B2444.else.endif.i, label %B78.if.i.i

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
  %.217.i44.i = add i64 %.216.i.i, %.267.i.i
  %.220.i45.i = icmp slt i64 %.217.i44.i, 0
  br i1 %.220.i45.i, label %B0.else.if.i.i, label %B0.else.endif.i.i, !prof !0

B0.else.if.i.i:                                   ; preds = %B2300.endif.endif.endif.else.endif.endif.i
  br label %B0.else.endif.i.i

B0.else.endif.i.i:                                ; preds = %B0.else.if.i.i, %B2300.endif.endif.endif.else.endif.endif.i
  %.205.sroa.0.1.i.i = phi i64 [ 0, %B0.else.if.i.i ], [ %.217.i44.i, %B2300.endif.endif.endif.else.endif.endif.i ]
  %.225.not.i.i = icmp slt i64 %.217.i44.i, %.7112.i
  br i1 %.225.not.i.i, label %B0.else.endif.endif.endif.endif.i.i, label %B0.else.endif.if.i.i, !prof !10

B0.else.endif.if.i.i:                             ; preds = %B0.else.endif.i.i
  br label %B0.else.endif.endif.endif.endif.i.i

B0.else.endif.endif.endif.endif.i.i:              ; preds = %B0.else.endif.if.i.i, %B0.else.endif.i.i
  %.205.sroa.0.3.i.i = phi i64 [ %.7112.i, %B0.else.endif.if.i.i ], [ %.205.sroa.0.1.i.i, %B0.else.endif.i.i ]
  %.318.i46.i = getelementptr double, ptr %.7128.i, i64 %.205.sroa.0.3.i.i
  %.350.i47.i = add nsw i64 %.267.i.i, %arg.n_f
  %.388.i48.i = icmp slt i64 %.350.i47.i, 0
  %.389.i49.i = select i1 %.388.i48.i, i64 %.7112.i, i64 0
  %.390.i50.i = add i64 %.389.i49.i, %.350.i47.i
  %.393.i51.i = icmp slt i64 %.390.i50.i, 0
  br i1 %.393.i51.i, label %B0.endif.else.if.i.i, label %B0.endif.else.endif.i.i, !prof !0

B0.endif.else.if.i.i:                             ; preds = %B0.else.endif.endif.endif.endif.i.i
  br label %B0.endif.else.endif.i.i

B0.endif.else.endif.i.i:                          ; preds = %B0.endif.else.if.i.i, %B0.else.endif.endif.endif.endif.i.i
  %.378.sroa.0.1.i.i = phi i64 [ 0, %B0.endif.else.if.i.i ], [ %.390.i50.i, %B0.else.endif.endif.endif.endif.i.i ]
  %.398.not.i.i = icmp slt i64 %.390.i50.i, %.7112.i
  br i1 %.398.not.i.i, label %B0.endif.else.endif.endif.endif.endif.i.i, label %B0.endif.else.endif.if.i.i, !prof !10

B0.endif.else.endif.if.i.i:                       ; preds = %B0.endif.else.endif.i.i
  br label %B0.endif.else.endif.endif.endif.endif.i.i

B0.endif.else.endif.endif.endif.endif.i.i:        ; preds = %B0.endif.else.endif.if.i.i, %B0.endif.else.endif.i.i
  %.378.sroa.0.3.i.i = phi i64 [ %.7112.i, %B0.endif.else.endif.if.i.i ], [ %.378.sroa.0.1.i.i, %B0.endif.else.endif.i.i ]
  %.491.i52.i = getelementptr double, ptr %.7128.i, i64 %.378.sroa.0.3.i.i
  %.541.i.i = add nsw i64 %.267.i.i, %.904.i
  %.578.i.i = icmp slt i64 %.541.i.i, 0
  %.579.i.i = select i1 %.578.i.i, i64 %.7112.i, i64 0
  %.580.i53.i = add i64 %.579.i.i, %.541.i.i
  %.583.i.i = icmp slt i64 %.580.i53.i, 0
  br i1 %.583.i.i, label %B0.endif.endif.else.if.i.i, label %B0.endif.endif.else.endif.i.i, !prof !0

B0.endif.endif.else.if.i.i:                       ; preds = %B0.endif.else.endif.endif.endif.endif.i.i
  br label %B0.endif.endif.else.endif.i.i

B0.endif.endif.else.endif.i.i:                    ; preds = %B0.endif.endif.else.if.i.i, %B0.endif.else.endif.endif.endif.endif.i.i
  %.568.sroa.0.1.i.i = phi i64 [ 0, %B0.endif.endif.else.if.i.i ], [ %.580.i53.i, %B0.endif.else.endif.endif.endif.endif.i.i ]
  %.588.not.i.i = icmp slt i64 %.580.i53.i, %.7112.i
  br i1 %.588.not.i.i, label %B0.endif.endif.else.endif.endif.endif.endif.i.i, label %B0.endif.endif.else.endif.if.i.i, !prof !10

B0.endif.endif.else.endif.if.i.i:                 ; preds = %B0.endif.endif.else.endif.i.i
  br label %B0.endif.endif.else.endif.endif.endif.endif.i.i

B0.endif.endif.else.endif.endif.endif.endif.i.i:  ; preds = %B0.endif.endif.else.endif.if.i.i, %B0.endif.endif.else.endif.i.i
  %.568.sroa.0.3.i.i = phi i64 [ %.7112.i, %B0.endif.endif.else.endif.if.i.i ], [ %.568.sroa.0.1.i.i, %B0.endif.endif.else.endif.i.i ]
  %.681.i54.i = getelementptr double, ptr %.7128.i, i64 %.568.sroa.0.3.i.i
  %.713.i55.i = add nsw i64 %.541.i.i, %arg.n_f
  %.751.i56.i = icmp slt i64 %.713.i55.i, 0
  %.752.i.i = select i1 %.751.i56.i, i64 %.7112.i, i64 0
  %.753.i.i = add i64 %.752.i.i, %.713.i55.i
  %.756.i57.i = icmp slt i64 %.753.i.i, 0
  br i1 %.756.i57.i, label %B0.endif.endif.endif.else.if.i.i, label %B0.endif.endif.endif.else.endif.i.i, !prof !0

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
  %.904.i.i = add nsw i64 %.541.i.i, %.904.i
  %.941.i.i = icmp slt i64 %.904.i.i, 0
  %.942.i.i = select i1 %.941.i.i, i64 %.7112.i, i64 0
  %.943.i.i = add i64 %.942.i.i, %.904.i.i
  %.946.i.i = icmp slt i64 %.943.i.i, 0
  br i1 %.946.i.i, label %B0.endif.endif.endif.endif.else.if.i.i, label %B0.endif.endif.endif.endif.else.endif.i.i, !prof !0

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
  %.1482.i58.i = icmp slt i64 %.1479.i.i, 0
  br i1 %.1482.i58.i, label %B0.endif.endif.endif.endif.endif.endif.endif.else.if.i.i, label %B0.endif.endif.endif.endif.endif.endif.endif.else.endif.i.i, !prof !0

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
  %.1667.i.i = icmp slt i64 %.1630.i.i, 0
  %.1668.i.i = select i1 %.1667.i.i, i64 %.7112.i, i64 0
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
  %.2133.i59.i = getelementptr double, ptr %.7128.i, i64 %.2020.sroa.0.3.i.i
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
  %171 = shl i64 %.2451885887.i.i, 3
  %scevgep16.i.i = getelementptr i8, ptr %.8625.i, i64 %171
  %.2513.i.i = load double, ptr %scevgep16.i.i, align 8, !noalias !26
  %.2515.i.i = fmul contract double %.2360.i.i, %.2513.i.i
  %.2516.i.i = fmul contract double %.2515.i.i, 0x3FE45F306DC9C883
  %.2517.i.i = fadd contract double %.2516.i.i, 0x4338000000000000
  %.2518.i.i = fadd contract double %.2517.i.i, 0xC338000000000000
  %.2536.i.i = fmul contract double %.2518.i.i, 0x3FF921FA00000000
  %.2537.i.i = fsub contract double %.2515.i.i, %.2536.i.i
  %.2555.i.i = fmul contract double %.2518.i.i, 0x3EB5444200000000
  %.2556.i.i = fsub contract double %.2537.i.i, %.2555.i.i
  %.2574.i.i = fmul contract double %.2518.i.i, 0x3D6A308C00000000
  %.2575.i.i = fsub contract double %.2556.i.i, %.2574.i.i
  %.2593.i.i = fmul contract double %.2518.i.i, 0x3C2313198A2E0370
  %.2594.i.i = fsub contract double %.2575.i.i, %.2593.i.i
  %.2595.i.i = fmul contract double %.2594.i.i, %.2594.i.i
  %.2596.i.i = fmul contract double %.2594.i.i, %.2595.i.i
  %.2597.i.i = fmul contract double %.2595.i.i, 0x3D6AE7F3E733B81F
  %172 = fsub contract double 0x3DE6124613A86D09, %.2597.i.i
  %.2599.i.i = fmul contract double %.2595.i.i, %172
  %.2600.i.i = fadd contract double %.2599.i.i, 0xBE5AE64567F544E4
  %.2601.i.i = fmul contract double %.2595.i.i, %.2600.i.i
  %.2602.i.i = fadd contract double %.2601.i.i, 0x3EC71DE3A556C734
  %.2603.i.i = fmul contract double %.2595.i.i, %.2602.i.i
  %.2604.i.i = fadd contract double %.2603.i.i, 0xBF2A01A01A01A01A
  %.2605.i.i = fmul contract double %.2595.i.i, %.2604.i.i
  %.2606.i.i = fadd contract double %.2605.i.i, 0x3F81111111111111
  %.2607.i.i = fmul contract double %.2595.i.i, %.2606.i.i
  %.2608.i.i = fadd contract double %.2607.i.i, 0xBFC5555555555555
  %.2609.i.i = fmul contract double %.2596.i.i, %.2608.i.i
  %.2610.i.i = fadd contract double %.2594.i.i, %.2609.i.i
  %.2611.i.i = fmul contract double %.2595.i.i, 0x3D2AE7F3E733B81F
  %.2612.i.i = fadd contract double %.2611.i.i, 0xBDA93974A8C07C9D
  %.2613.i.i = fmul contract double %.2595.i.i, %.2612.i.i
  %.2614.i.i = fadd contract double %.2613.i.i, 0x3E21EED8EFF8D898
  %.2615.i.i = fmul contract double %.2595.i.i, %.2614.i.i
  %.2616.i.i = fadd contract double %.2615.i.i, 0xBE927E4FB7789F5C
  %.2617.i.i = fmul contract double %.2595.i.i, %.2616.i.i
  %.2618.i.i = fadd contract double %.2617.i.i, 0x3EFA01A01A01A01A
  %.2619.i.i = fmul contract double %.2595.i.i, %.2618.i.i
  %.2620.i.i = fadd contract double %.2619.i.i, 0xBF56C16C16C16C17
  %.2621.i.i = fmul contract double %.2595.i.i, %.2620.i.i
  %.2622.i.i = fadd contract double %.2621.i.i, 0x3FA5555555555555
  %.2623.i.i = fmul contract double %.2595.i.i, %.2622.i.i
  %.2624.i.i = fadd contract double %.2623.i.i, -5.000000e-01
  %.2625.i.i = fmul contract double %.2595.i.i, %.2624.i.i
  %.2626.i.i = fadd contract double %.2625.i.i, 1.000000e+00
  %.2627.i.i = bitcast double %.2517.i.i to i64
  %.2628.i.i = and i64 %.2627.i.i, 1
  %.2630.i.i = bitcast double %.2610.i.i to i64
  %.2631.i.i = bitcast double %.2626.i.i to i64
  %.2632.i.i = xor i64 %.2631.i.i, %.2630.i.i
  %173 = icmp eq i64 %.2628.i.i, 0
  %.2633.i.i = select i1 %173, i64 0, i64 %.2632.i.i
  %.2634.i.i = shl i64 %.2627.i.i, 62
  %.2635.i.i = and i64 %.2634.i.i, -9223372036854775808
  %.2637.i.i = add i64 %.2634.i.i, 4611686018427387904
  %.2638.i.i = and i64 %.2637.i.i, -9223372036854775808
  %174 = xor i64 %.2635.i.i, %.2630.i.i
  %.2640.i.i = xor i64 %174, %.2633.i.i
  %.2641.i.i = bitcast i64 %.2640.i.i to double
  %175 = xor i64 %.2638.i.i, %.2631.i.i
  %.2643.i.i = xor i64 %175, %.2633.i.i
  %.2644.i.i = bitcast i64 %.2643.i.i to double
  %scevgep15.i.i = getelementptr i8, ptr %sr.2.sroa.36.3.i, i64 %171
  %.2694.i.i = load double, ptr %scevgep15.i.i, align 8, !noalias !26
  %.2695.i.i = fmul contract double %.2694.i.i, %.2644.i.i
  %scevgep14.i.i = getelementptr i8, ptr %si.2.sroa.36.3.i, i64 %171
  %.2725.i.i = load double, ptr %scevgep14.i.i, align 8, !noalias !26
  %.2726.i.i = fmul contract double %.2725.i.i, %.2641.i.i
  %.2727.i.i = fsub contract double %.2695.i.i, %.2726.i.i
  %.2758.i.i = fmul contract double %.2694.i.i, %.2641.i.i
  %.2789.i.i = fmul contract double %.2725.i.i, %.2644.i.i
  %.2790.i.i = fadd contract double %.2758.i.i, %.2789.i.i
  %scevgep13.i.i = getelementptr i8, ptr %.318.i46.i, i64 %171
  %.2820.i.i = load double, ptr %scevgep13.i.i, align 8, !noalias !26
  %.2822.i.i = fmul contract double %.191.i.i, %.2820.i.i
  %scevgep12.i.i = getelementptr i8, ptr %.681.i54.i, i64 %171
  %.2852.i.i = load double, ptr %scevgep12.i.i, align 8, !noalias !26
  %.2854.i.i = fmul contract double %.205.i.i, %.2852.i.i
  %.2855.i.i = fadd contract double %.2822.i.i, %.2854.i.i
  %scevgep11.i.i = getelementptr i8, ptr %.1044.i.i, i64 %171
  %.2885.i.i = load double, ptr %scevgep11.i.i, align 8, !noalias !26
  %.2887.i.i = fmul contract double %.217.i.i, %.2885.i.i
  %.2888.i.i = fadd contract double %.2855.i.i, %.2887.i.i
  %scevgep10.i.i = getelementptr i8, ptr %.1407.i.i, i64 %171
  %.2918.i.i = load double, ptr %scevgep10.i.i, align 8, !noalias !26
  %.2920.i.i = fmul contract double %.229.i.i, %.2918.i.i
  %.2921.i.i = fadd contract double %.2888.i.i, %.2920.i.i
  %scevgep9.i.i = getelementptr i8, ptr %.1770.i.i, i64 %171
  %.2951.i.i = load double, ptr %scevgep9.i.i, align 8, !noalias !26
  %.2953.i.i = fmul contract double %.243.i.i, %.2951.i.i
  %.2954.i.i = fadd contract double %.2921.i.i, %.2953.i.i
  %scevgep8.i60.i = getelementptr i8, ptr %.2133.i59.i, i64 %171
  %.2984.i.i = load double, ptr %scevgep8.i60.i, align 8, !noalias !26
  %.2986.i.i = fmul contract double %.251.i.i, %.2984.i.i
  %.2987.i.i = fadd contract double %.2954.i.i, %.2986.i.i
  %scevgep7.i61.i = getelementptr i8, ptr %.491.i52.i, i64 %171
  %.3017.i.i = load double, ptr %scevgep7.i61.i, align 8, !noalias !26
  %.3019.i.i = fmul contract double %.191.i.i, %.3017.i.i
  %scevgep6.i62.i = getelementptr i8, ptr %.854.i.i, i64 %171
  %.3049.i.i = load double, ptr %scevgep6.i62.i, align 8, !noalias !26
  %.3051.i.i = fmul contract double %.205.i.i, %.3049.i.i
  %.3052.i.i = fadd contract double %.3019.i.i, %.3051.i.i
  %scevgep5.i63.i = getelementptr i8, ptr %.1217.i.i, i64 %171
  %.3082.i.i = load double, ptr %scevgep5.i63.i, align 8, !noalias !26
  %.3084.i.i = fmul contract double %.217.i.i, %.3082.i.i
  %.3085.i.i = fadd contract double %.3052.i.i, %.3084.i.i
  %scevgep4.i64.i = getelementptr i8, ptr %.1580.i.i, i64 %171
  %.3115.i.i = load double, ptr %scevgep4.i64.i, align 8, !noalias !26
  %.3117.i.i = fmul contract double %.229.i.i, %.3115.i.i
  %.3118.i.i = fadd contract double %.3085.i.i, %.3117.i.i
  %scevgep3.i.i = getelementptr i8, ptr %.1943.i.i, i64 %171
  %.3148.i.i = load double, ptr %scevgep3.i.i, align 8, !noalias !26
  %.3150.i.i = fmul contract double %.243.i.i, %.3148.i.i
  %.3151.i.i = fadd contract double %.3118.i.i, %.3150.i.i
  %scevgep2.i.i = getelementptr i8, ptr %.2306.i.i, i64 %171
  %.3181.i.i = load double, ptr %scevgep2.i.i, align 8, !noalias !26
  %.3183.i.i = fmul contract double %.251.i.i, %.3181.i.i
  %.3184.i.i = fadd contract double %.3151.i.i, %.3183.i.i
  %.3185.i.i = fmul contract double %.2987.i.i, %.2727.i.i
  %.3186.i.i = fmul contract double %.3184.i.i, %.2790.i.i
  %.3187.i.i = fsub contract double %.3185.i.i, %.3186.i.i
  %scevgep1.i.i = getelementptr i8, ptr %.8797.i, i64 %171
  store double %.3187.i.i, ptr %scevgep1.i.i, align 8, !noalias !26
  %.3218.i.i = fmul contract double %.2987.i.i, %.2790.i.i
  %.3219.i.i = fmul contract double %.3184.i.i, %.2727.i.i
  %.3220.i.i = fadd contract double %.3218.i.i, %.3219.i.i
  %scevgep.i.i = getelementptr i8, ptr %.8969.i, i64 %171
  store double %.3220.i.i, ptr %scevgep.i.i, align 8, !noalias !26
  %exitcond.not.i65.i = icmp eq i64 %.8600.i, %.2458.i.i
  br i1 %exitcond.not.i65.i, label %B2444.else.endif.i, label %B546.if.i.i

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
  %scevgep.i172.i = getelementptr i8, ptr %.9212.i, i64 56
  br label %B104.if.i.i

B348.loopexit.i.i:                                ; preds = %B104.if.i.i
  %176 = fadd contract double %.244.i.i, %.279.i176.i
  %177 = fadd contract double %.314.i.i, %.349.i179.i
  %178 = fadd contract double %176, %177
  %179 = fadd contract double %.384.i.i, %.419.i.i
  %180 = fadd contract double %.454.i.i, %.489.i.i
  %181 = fadd contract double %179, %180
  %182 = fadd contract double %178, %181
  br label %B2444.endif.endif.i

B104.if.i.i:                                      ; preds = %B104.if.i.i, %B104.if.preheader.i.i
  %lsr.iv9.i.i = phi i64 [ %.60.1.i.i, %B104.if.preheader.i.i ], [ %lsr.iv.next.i.i, %B104.if.i.i ]
  %lsr.iv.i.i = phi ptr [ %scevgep.i172.i, %B104.if.preheader.i.i ], [ %scevgep1.i183.i, %B104.if.i.i ]
  %s7.2.0168.i.i = phi double [ 0.000000e+00, %B104.if.preheader.i.i ], [ %.489.i.i, %B104.if.i.i ]
  %s6.2.0167.i.i = phi double [ 0.000000e+00, %B104.if.preheader.i.i ], [ %.454.i.i, %B104.if.i.i ]
  %s5.2.0166.i.i = phi double [ 0.000000e+00, %B104.if.preheader.i.i ], [ %.419.i.i, %B104.if.i.i ]
  %s4.2.0165.i.i = phi double [ 0.000000e+00, %B104.if.preheader.i.i ], [ %.384.i.i, %B104.if.i.i ]
  %s3.2.0164.i.i = phi double [ 0.000000e+00, %B104.if.preheader.i.i ], [ %.349.i179.i, %B104.if.i.i ]
  %s2.2.0163.i.i = phi double [ 0.000000e+00, %B104.if.preheader.i.i ], [ %.314.i.i, %B104.if.i.i ]
  %s1.2.0162.i.i = phi double [ 0.000000e+00, %B104.if.preheader.i.i ], [ %.279.i176.i, %B104.if.i.i ]
  %s0.2.0161.i.i = phi double [ 0.000000e+00, %B104.if.preheader.i.i ], [ %.244.i.i, %B104.if.i.i ]
  %scevgep2.i173.i = getelementptr i8, ptr %lsr.iv.i.i, i64 -56
  %.242.i.i = load double, ptr %scevgep2.i173.i, align 8, !noalias !29
  %.244.i.i = fadd contract double %s0.2.0161.i.i, %.242.i.i
  %scevgep3.i174.i = getelementptr i8, ptr %lsr.iv.i.i, i64 -48
  %.277.i175.i = load double, ptr %scevgep3.i174.i, align 8, !noalias !29
  %.279.i176.i = fadd contract double %s1.2.0162.i.i, %.277.i175.i
  %scevgep4.i177.i = getelementptr i8, ptr %lsr.iv.i.i, i64 -40
  %.312.i.i = load double, ptr %scevgep4.i177.i, align 8, !noalias !29
  %.314.i.i = fadd contract double %s2.2.0163.i.i, %.312.i.i
  %scevgep5.i178.i = getelementptr i8, ptr %lsr.iv.i.i, i64 -32
  %.347.i.i = load double, ptr %scevgep5.i178.i, align 8, !noalias !29
  %.349.i179.i = fadd contract double %s3.2.0164.i.i, %.347.i.i
  %scevgep6.i180.i = getelementptr i8, ptr %lsr.iv.i.i, i64 -24
  %.382.i181.i = load double, ptr %scevgep6.i180.i, align 8, !noalias !29
  %.384.i.i = fadd contract double %s4.2.0165.i.i, %.382.i181.i
  %scevgep7.i182.i = getelementptr i8, ptr %lsr.iv.i.i, i64 -16
  %.417.i.i = load double, ptr %scevgep7.i182.i, align 8, !noalias !29
  %.419.i.i = fadd contract double %s5.2.0166.i.i, %.417.i.i
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
  %s0.2.0.lcssa.i.i = phi double [ 0.000000e+00, %B2444.else.endif.endif.endif.endif.i ], [ %182, %B348.loopexit.i.i ]
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
  %183 = fadd contract double %.244.i202.i, %.279.i205.i
  %184 = fadd contract double %.314.i208.i, %.349.i211.i
  %185 = fadd contract double %183, %184
  %186 = fadd contract double %.384.i214.i, %.419.i217.i
  %187 = fadd contract double %.454.i220.i, %.489.i222.i
  %188 = fadd contract double %186, %187
  %189 = fadd contract double %185, %188
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
  %s0.2.0.lcssa.i227.i = phi double [ 0.000000e+00, %B2444.endif.endif.else.endif.endif.endif.endif.i ], [ %189, %B348.loopexit.i226.i ]
  %.9490.i = icmp slt i64 %.7308.sroa.0.054.i, 0
  %.9491.i = select i1 %.9490.i, i64 %.3160.i, i64 0
  %.idx93.i = shl i64 %.7308.sroa.0.054.i, 4
  %190 = getelementptr i8, ptr %.3176.i, i64 %.idx93.i
  %.9505.i = getelementptr double, ptr %190, i64 %.9491.i
  %.9506.i = load double, ptr %.9505.i, align 8, !noalias !1
  %.9508.i = fmul contract double %.7197.i, %s0.2.0.lcssa.i.i
  %.9510.i = fmul contract double %.7230.i, %s0.2.0.lcssa.i227.i
  %.9511.i = fsub contract double %.9508.i, %.9510.i
  %.9512.i = fadd contract double %.9506.i, %.9511.i
  store double %.9512.i, ptr %.9505.i, align 8, !noalias !1
  %191 = getelementptr i8, ptr %190, i64 8
  %.9576.i = getelementptr double, ptr %191, i64 %.9491.i
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
  %192 = shl i64 %.1008333113313.i, 3
  %scevgep57.i = getelementptr i8, ptr %.2074.i, i64 %192
  %.10175.i = load double, ptr %scevgep57.i, align 8, !noalias !1
  %.10177.i = fmul contract double %.7197.i, %.10175.i
  %scevgep56.i = getelementptr i8, ptr %.2249.i, i64 %192
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
  %193 = add i64 %.1069235473549.i, %.10486.sroa.0.084.i
  %.10739.i = icmp slt i64 %193, 0
  %194 = select i1 %.10739.i, i64 %75, i64 0
  %scevgep454.i = getelementptr i8, ptr %scevgep453.i, i64 %194
  %195 = shl nuw nsw i64 %.1069235473549.i, 3
  %scevgep59.i = getelementptr i8, ptr %scevgep454.i, i64 %195
  %.10755.i = load i64, ptr %scevgep59.i, align 8, !noalias !1
  %.10770.i = icmp slt i64 %.10755.i, 0
  %.10771.i = select i1 %.10770.i, i64 %.3500.i, i64 0
  %.idx95.i = shl i64 %.10755.i, 4
  %196 = getelementptr i8, ptr %.3516.i, i64 %.idx95.i
  %.10785.i = getelementptr double, ptr %196, i64 %.10771.i
  %.10786.i = load double, ptr %.10785.i, align 8, !noalias !1
  %197 = getelementptr i8, ptr %196, i64 8
  %.10849.i = getelementptr double, ptr %197, i64 %.10771.i
  %.10850.i = load double, ptr %.10849.i, align 8, !noalias !1
  %.10851.i = fmul contract double %.10786.i, %.10786.i
  %.10852.i = fmul contract double %.10850.i, %.10850.i
  %.10853.i = fadd contract double %.10851.i, %.10852.i
  %scevgep58.i = getelementptr i8, ptr %.1339.i, i64 %195
  store double %.10853.i, ptr %scevgep58.i, align 8, !noalias !1
  %exitcond3987.not.i = icmp eq i64 %.13.i229.i, %.10699.i
  br i1 %exitcond3987.not.i, label %B3318.i, label %B3198.if.i

B3350.if.i:                                       ; preds = %B3350.if.i, %B3350.if.preheader380.i
  %lsr.iv460.i = phi i64 [ %35, %B3350.if.preheader380.i ], [ %lsr.iv.next461.i, %B3350.if.i ]
  %.1097835543556.i = phi i64 [ %.1097835543556.unr.i, %B3350.if.preheader380.i ], [ %206, %B3350.if.i ]
  %.11023.i = icmp slt i64 %.1097835543556.i, 0
  %198 = select i1 %.11023.i, i64 %73, i64 0
  %scevgep468.i = getelementptr i8, ptr %.1339.i, i64 %198
  %199 = shl i64 %.1097835543556.i, 3
  %scevgep469.i = getelementptr i8, ptr %scevgep468.i, i64 %199
  store double 0.000000e+00, ptr %scevgep469.i, align 8, !noalias !1
  %200 = add i64 %.1097835543556.i, 1
  %.11023.1.i = icmp slt i64 %200, 0
  %201 = select i1 %.11023.1.i, i64 %80, i64 8
  %scevgep66.i = getelementptr i8, ptr %.1339.i, i64 %201
  %scevgep67.i = getelementptr i8, ptr %scevgep66.i, i64 %199
  store double 0.000000e+00, ptr %scevgep67.i, align 8, !noalias !1
  %202 = add i64 %.1097835543556.i, 2
  %.11023.2.i = icmp slt i64 %202, 0
  %203 = select i1 %.11023.2.i, i64 %93, i64 16
  %scevgep64.i = getelementptr i8, ptr %.1339.i, i64 %203
  %scevgep65.i = getelementptr i8, ptr %scevgep64.i, i64 %199
  store double 0.000000e+00, ptr %scevgep65.i, align 8, !noalias !1
  %204 = add i64 %.1097835543556.i, 3
  %.11023.3.i = icmp slt i64 %204, 0
  %205 = select i1 %.11023.3.i, i64 %94, i64 24
  %scevgep62.i = getelementptr i8, ptr %.1339.i, i64 %205
  %scevgep63.i = getelementptr i8, ptr %scevgep62.i, i64 %199
  store double 0.000000e+00, ptr %scevgep63.i, align 8, !noalias !1
  %lsr.iv.next461.i = add i64 %lsr.iv460.i, -4
  %.10972.3.i = icmp sgt i64 %lsr.iv.next461.i, 4
  %206 = add i64 %.1097835543556.i, 4
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
  %207 = shl nuw i64 %.11669.i, 3
  tail call void @llvm.memset.p0.i64(ptr align 8 %.11685.i, i8 0, i64 %207, i1 false), !noalias !35
  br label %B76.i231.i

B76.i231.i:                                       ; preds = %B60.if.preheader.i282.i, %B3462.endif.else.endif.endif.endif.endif.i
  %.311284.not.i232.i = icmp slt i64 %.11488.i, 1
  br i1 %.311284.not.i232.i, label %B3462.endif.endif.endif.i, label %B128.if.lr.ph.i233.i

B128.if.lr.ph.i233.i:                             ; preds = %B76.i231.i
  %208 = add nsw i64 %.11669.i, -2
  %209 = lshr i64 %208, 1
  %210 = add nuw i64 %209, 1
  %211 = shl i64 %.11572.sroa.0.3.i, 3
  %scevgep507.i = getelementptr i8, ptr %scevgep397.i, i64 %211
  %212 = lshr i64 %210, 1
  %213 = mul nsw i64 %212, -2
  %214 = icmp eq i64 %.11660.i, 1
  %215 = icmp eq i64 %209, 0
  %216 = and i64 %208, 2
  %217 = icmp eq i64 %216, 0
  %218 = and i64 %.11669.i, 1
  %219 = icmp eq i64 %218, 0
  br label %B128.if.i236.i

B284.loopexit.unr-lcssa.i272.unr-lcssa.i:         ; preds = %B228.if.i256.i
  br i1 %217, label %B228.if.i256.epil.preheader.i, label %B284.loopexit.unr-lcssa.i272.i

B228.if.i256.epil.preheader.i:                    ; preds = %B228.if.preheader2.i254.i, %B284.loopexit.unr-lcssa.i272.unr-lcssa.i
  %.655272274.i257.epil.init.i = phi i64 [ 0, %B228.if.preheader2.i254.i ], [ %.662.1.i265.1.i, %B284.loopexit.unr-lcssa.i272.unr-lcssa.i ]
  %220 = shl i64 %.655272274.i257.epil.init.i, 3
  %sunkaddr11.i258.epil.i = getelementptr i8, ptr %.11685.i, i64 %220
  %.716.i259.epil.i = load double, ptr %sunkaddr11.i258.epil.i, align 8, !noalias !35
  %scevgep9.i260.epil.i = getelementptr i8, ptr %scevgep7.i255.i, i64 %220
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
  br i1 %219, label %B284.i279.i, label %B228.if.epil.preheader.i273.i

B228.if.epil.preheader.i273.i:                    ; preds = %B228.if.preheader.i253.i, %B284.loopexit.unr-lcssa.i272.i
  %.655272274.epil.init.i274.i = phi i64 [ 0, %B228.if.preheader.i253.i ], [ %.662.1.i265.lcssa.i, %B284.loopexit.unr-lcssa.i272.i ]
  %221 = getelementptr double, ptr %.11685.i, i64 %.655272274.epil.init.i274.i
  %.716.epil.i275.i = load double, ptr %221, align 8, !noalias !35
  %222 = getelementptr double, ptr %.498.i251.i, i64 %.655272274.epil.init.i274.i
  %.746.epil.i276.i = load double, ptr %222, align 8, !noalias !35
  %.748.epil.i277.i = fmul contract double %.565.i252.i, %.746.epil.i276.i
  %.749.epil.i278.i = fadd contract double %.716.epil.i275.i, %.748.epil.i277.i
  store double %.749.epil.i278.i, ptr %221, align 8, !noalias !35
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
  %223 = getelementptr double, ptr %.11513.i, i64 %.317279285.i237.i
  %.565.i252.i = load double, ptr %223, align 8, !noalias !35
  br i1 %.104.i230.not.i, label %B284.i279.i, label %B228.if.preheader.i253.i

B228.if.preheader.i253.i:                         ; preds = %B130.else.endif.endif.endif.endif.i249.i
  br i1 %214, label %B228.if.epil.preheader.i273.i, label %B228.if.preheader2.i254.i

B228.if.preheader2.i254.i:                        ; preds = %B228.if.preheader.i253.i
  %224 = shl i64 %.385.sroa.0.3.i250.i, 3
  %scevgep7.i255.i = getelementptr i8, ptr %scevgep6.i235.i, i64 %224
  br i1 %215, label %B228.if.i256.epil.preheader.i, label %B228.if.i256.preheader.i

B228.if.i256.preheader.i:                         ; preds = %B228.if.preheader2.i254.i
  %scevgep516.i = getelementptr i8, ptr %scevgep515.i, i64 %224
  br label %B228.if.i256.i

B228.if.i256.i:                                   ; preds = %B228.if.i256.i, %B228.if.i256.preheader.i
  %lsr.iv85.i = phi i64 [ %lsr.iv.next86.i, %B228.if.i256.i ], [ %213, %B228.if.i256.preheader.i ]
  %.655272274.i257.i = phi i64 [ %.662.1.i265.1.i, %B228.if.i256.i ], [ 0, %B228.if.i256.preheader.i ]
  %225 = shl i64 %.655272274.i257.i, 3
  %scevgep513.i = getelementptr i8, ptr %scevgep507.i, i64 %225
  %scevgep514.i = getelementptr i8, ptr %scevgep513.i, i64 -24
  %.716.i259.i = load double, ptr %scevgep514.i, align 8, !noalias !35
  %scevgep519.i = getelementptr i8, ptr %scevgep516.i, i64 %225
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
  %226 = shl i64 %.11210.sroa.0.3.i, 3
  %scevgep530.i = getelementptr i8, ptr %scevgep529.i, i64 %226
  br label %B3590.if.i

B3590.if.i:                                       ; preds = %B3590.if.i, %B3590.if.preheader378.i
  %.1184235683570.i = phi i64 [ %.11849.1.i, %B3590.if.i ], [ 0, %B3590.if.preheader378.i ]
  %227 = shl i64 %.1184235683570.i, 3
  %sunkaddr106.i = getelementptr i8, ptr %69, i64 %227
  %.11903.i = load double, ptr %sunkaddr106.i, align 8, !noalias !1
  %scevgep532.i = getelementptr i8, ptr %scevgep530.i, i64 %227
  %scevgep533.i = getelementptr i8, ptr %scevgep532.i, i64 -8
  %.11933.i = load double, ptr %scevgep533.i, align 8, !noalias !1
  %.11934.i = fmul contract double %.11903.i, %.11933.i
  %sunkaddr108.i = getelementptr i8, ptr %65, i64 %227
  %.11964.i = load double, ptr %sunkaddr108.i, align 8, !noalias !1
  %.11965.i = fadd contract double %.11964.i, 1.000000e+00
  %.11997.i = fmul contract double %.11965.i, %.11965.i
  %.11998.i = fmul contract double %.11934.i, %.11997.i
  %sunkaddr110.i = getelementptr i8, ptr %71, i64 %227
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
  %228 = shl i64 %.1212635613563.i, 3
  %scevgep479.i = getelementptr i8, ptr %scevgep473.i, i64 %228
  %scevgep480.i = getelementptr i8, ptr %scevgep479.i, i64 -24
  %.12187.i = load double, ptr %scevgep480.i, align 8, !noalias !1
  %scevgep488.i = getelementptr i8, ptr %scevgep482.i, i64 %228
  %scevgep489.i = getelementptr i8, ptr %scevgep488.i, i64 -24
  %.12217.i = load double, ptr %scevgep489.i, align 8, !noalias !1
  %.12218.i = fmul contract double %.12187.i, %.12217.i
  %scevgep68.i = getelementptr i8, ptr %scevgep490.i, i64 %228
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
  %229 = fadd contract double %.244.i301.i, %.279.i304.i
  %230 = fadd contract double %.314.i307.i, %.349.i310.i
  %231 = fadd contract double %229, %230
  %232 = fadd contract double %.384.i313.i, %.419.i316.i
  %233 = fadd contract double %.454.i319.i, %.489.i321.i
  %234 = fadd contract double %232, %233
  %235 = fadd contract double %231, %234
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
  %s0.2.0.lcssa.i326.i = phi double [ 0.000000e+00, %B3762.else.endif.endif.endif.endif.i ], [ %235, %B348.loopexit.i325.i ]
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
