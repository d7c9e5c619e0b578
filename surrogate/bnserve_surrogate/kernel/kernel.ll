; sources: 803963890cf2c8a4e199bd46221b64a3f340cdbd20991c19187df34e68743c9e
; built by: numba 0.68.1, llvmlite 0.50.0, Python 3.11, x86_64
; ModuleID = '<string>'
source_filename = "<string>"


; Function Attrs: nofree norecurse nounwind
define noundef range(i32 0, 2) i32 @bnserve_evaluate(ptr noalias writeonly captures(none) %retptr, ptr noalias writeonly captures(none) %excinfo, ptr readonly captures(none) %arg.arguments) local_unnamed_addr #0 {
entry:
  %.43 = alloca i64, align 8
  store i64 0, ptr %.43, align 8
  %excinfo.2 = alloca ptr, align 8
  store ptr null, ptr %excinfo.2, align 8
  store i64 0, ptr %.43, align 8
  %.49 = call fastcc i32 @inner_0(ptr nonnull %.43, ptr nonnull %excinfo.2, ptr %arg.arguments)
  %cond = icmp eq i32 %.49, 0
  br i1 %cond, label %B0.endif.endif, label %B0.endif.if, !prof !0

common.ret:                                       ; preds = %B0.endif.endif, %B0.endif.if
  %common.ret.op = phi i32 [ 1, %B0.endif.if ], [ 0, %B0.endif.endif ]
  ret i32 %common.ret.op

B0.endif.if:                                      ; preds = %entry
  %.50 = load ptr, ptr %excinfo.2, align 8
  store ptr %.50, ptr %excinfo, align 8
  br label %common.ret

B0.endif.endif:                                   ; preds = %entry
  %.59 = load i64, ptr %.43, align 8
  store i64 %.59, ptr %retptr, align 8
  br label %common.ret
}

; Function Attrs: mustprogress nocallback nofree nounwind willreturn memory(argmem: write)
declare void @llvm.memset.p0.i64(ptr writeonly captures(none), i8, i64, i1 immarg) #1

; Function Attrs: nofree noinline norecurse nounwind
define internal fastcc noundef range(i32 0, 2) i32 @inner_0(ptr noalias nonnull writeonly captures(none) %retptr, ptr noalias nonnull writeonly captures(none) %excinfo, ptr readonly captures(none) %arg.arguments.4) unnamed_addr #2 {
entry:
  %.2032 = alloca i64, align 8
  store i64 0, ptr %.2032, align 8
  %.2686 = alloca ptr, align 8
  store ptr null, ptr %.2686, align 8
  %excinfo.13 = alloca ptr, align 8
  store ptr null, ptr %excinfo.13, align 8
  %.2735 = alloca ptr, align 8
  store ptr null, ptr %.2735, align 8
  %excinfo.14 = alloca ptr, align 8
  store ptr null, ptr %excinfo.14, align 8
  %.46 = getelementptr i8, ptr %arg.arguments.4, i64 16
  %.47 = load i64, ptr %.46, align 8
  %.76 = getelementptr i8, ptr %arg.arguments.4, i64 32
  %.77 = load i64, ptr %.76, align 8
  %.110 = getelementptr i8, ptr %arg.arguments.4, i64 24
  %.111 = load i64, ptr %.110, align 8
  %.197 = getelementptr i8, ptr %arg.arguments.4, i64 56
  %.198 = load i64, ptr %.197, align 8
  %.199.not = icmp eq i64 %.198, 0
  br i1 %.199.not, label %B344, label %B190

B190:                                             ; preds = %entry
  %..47 = tail call i64 @llvm.smax.i64(i64 %.47, i64 0)
  %0 = inttoptr i64 %.111 to ptr
  %1 = inttoptr i64 %.198 to ptr
  br label %B284

B284:                                             ; preds = %B284.if, %B190
  %.3731275 = phi i64 [ %.380, %B284.if ], [ 0, %B190 ]
  %exitcond.not = icmp eq i64 %..47, %.3731275
  br i1 %exitcond.not, label %B344, label %B284.if

common.ret:                                       ; preds = %B1946.if, %B1902.if, %B1995, %B1758, %B324
  %common.ret.op = phi i32 [ 0, %B324 ], [ 0, %B1758 ], [ 0, %B1995 ], [ %.2753, %B1946.if ], [ %.2700, %B1902.if ]
  ret i32 %common.ret.op

B324:                                             ; preds = %B284.if
  store i64 -1, ptr %retptr, align 8
  br label %common.ret

B344:                                             ; preds = %B284, %entry
  %.527 = getelementptr i8, ptr %arg.arguments.4, i64 64
  %.528 = load i64, ptr %.527, align 8
  %.612 = getelementptr i8, ptr %arg.arguments.4, i64 80
  %.613 = load i64, ptr %.612, align 8
  %.697 = load i64, ptr %arg.arguments.4, align 8
  %.730 = getelementptr i8, ptr %arg.arguments.4, i64 8
  %.731 = load i64, ptr %.730, align 8
  %.733 = mul nsw i64 %.697, 10
  %.817 = getelementptr i8, ptr %arg.arguments.4, i64 152
  %.818 = load i64, ptr %.817, align 8
  %.903 = getelementptr i8, ptr %arg.arguments.4, i64 136
  %.904 = load i64, ptr %.903, align 8
  %.983 = getelementptr i8, ptr %arg.arguments.4, i64 144
  %.984 = load i64, ptr %.983, align 8
  %.986 = shl nsw i64 %.697, 1
  %.1091 = getelementptr i8, ptr %arg.arguments.4, i64 168
  %.1092 = load i64, ptr %.1091, align 8
  %.1093.not = icmp eq i64 %.1092, 0
  br i1 %.1093.not, label %B976, label %B858

B858:                                             ; preds = %B344
  %.1126 = inttoptr i64 %.1092 to ptr
  %.1201 = getelementptr i8, ptr %.1126, i64 40
  %.1202 = load i64, ptr %.1201, align 8
  %.1206 = sitofp i64 %.1202 to double
  %.1210 = fmul contract double %.1206, 5.000000e-01
  %.1212 = fmul contract double %.1210, 1.000000e-09
  br label %B976

B976:                                             ; preds = %B858, %B344
  %least.2.0 = phi double [ %.1212, %B858 ], [ 1.000000e-09, %B344 ]
  %.13067 = icmp sgt i64 %.697, 0
  br i1 %.13067, label %B1010.lr.ph, label %B1995

B1010.lr.ph:                                      ; preds = %B976
  %2 = inttoptr i64 %.111 to ptr
  %3 = getelementptr double, ptr %2, i64 %.47
  %4 = getelementptr i8, ptr %3, i64 -8
  %.1983.inv = icmp sgt i64 %.47, 0
  %.1305127810 = add nsw i64 %.697, -1
  %5 = mul i64 %.77, 40
  %sunkaddr156 = select i1 %.1983.inv, i64 0, i64 %5
  %6 = inttoptr i64 %.613 to ptr
  %7 = inttoptr i64 %.731 to ptr
  %sunkaddr24 = inttoptr i64 %.528 to ptr
  %sunkaddr25 = getelementptr i8, ptr %sunkaddr24, i64 136
  %sunkaddr27 = getelementptr i8, ptr %sunkaddr24, i64 128
  %sunkaddr28 = getelementptr inbounds i8, ptr %4, i64 %sunkaddr156
  %sunkaddr29 = getelementptr i8, ptr %arg.arguments.4, i64 96
  %8 = inttoptr i64 %.818 to ptr
  %9 = inttoptr i64 %.904 to ptr
  %10 = inttoptr i64 %.984 to ptr
  br label %B1010

B1010:                                            ; preds = %B1634, %B1010.lr.ph
  %.1296.sroa.0.014 = phi i64 [ 0, %B1010.lr.ph ], [ %.1296.sroa.0.0, %B1634 ]
  %.1305127813 = phi i64 [ %.1305127810, %B1010.lr.ph ], [ %.13051278, %B1634 ]
  %.1312128212 = phi i64 [ 1, %B1010.lr.ph ], [ %.13121282, %B1634 ]
  %bad.2.011 = phi i64 [ 0, %B1010.lr.ph ], [ %.2396, %B1634 ]
  %.1348 = mul nsw i64 %.1296.sroa.0.014, 10
  %.1388 = icmp slt i64 %.1296.sroa.0.014, 0
  %.1389 = select i1 %.1388, i64 %.733, i64 0
  %.1390 = add i64 %.1389, %.1348
  %.1393 = icmp slt i64 %.1390, 0
  br i1 %.1393, label %B1010.else.if, label %B1010.else.endif, !prof !1

B1320:                                            ; preds = %B1010.else.endif.endif
  %.2135 = getelementptr i8, ptr %.1491, i64 48
  %.2136 = load double, ptr %.2135, align 8
  %.2144.le = tail call contract double @llvm.cos.f64(double %.2136)
  br label %B1414

B1414:                                            ; preds = %B1010.else.endif.endif, %B1320
  %"$phi1414.1.2.1" = phi double [ 0x7FF8000000000000, %B1010.else.endif.endif ], [ %.2144.le, %B1320 ]
  %.2191 = load i64, ptr %.1091, align 8
  %.2192.not = icmp eq i64 %.2191, 0
  br i1 %.2192.not, label %B1566, label %B1460

B1460:                                            ; preds = %B1414
  %.55.i = inttoptr i64 %.2191 to ptr
  %.140.i = load i64, ptr %.55.i, align 8, !noalias !2
  %.486511.not.i = icmp slt i64 %.140.i, 1
  br i1 %.486511.not.i, label %B1634, label %B366.if.lr.ph.i

B366.if.lr.ph.i:                                  ; preds = %B1460
  %.2223 = getelementptr i8, ptr %.1491, i64 48
  %.2224 = load double, ptr %.2223, align 8
  %.336.i = load i64, ptr %.983, align 8, !noalias !2
  %.258.i = load i64, ptr %.903, align 8, !noalias !2
  %.173.i = getelementptr i8, ptr %.55.i, i64 16
  %.174.i = load i64, ptr %.173.i, align 8, !noalias !2
  %11 = inttoptr i64 %.174.i to ptr
  %.609.i = mul nsw i64 %.140.i, %.1296.sroa.0.014
  %.755.i = fmul contract double %"$phi1414.1.2.1", %"$phi1414.1.2.1"
  %.1048.i = fcmp contract ord double %"$phi1414.1.2.1", 0.000000e+00
  %"$phi646.1.2.1.i" = select i1 %.1048.i, double 0.000000e+00, double 0x7FF8000000000000
  %scevgep.i = getelementptr i8, ptr %11, i64 32
  %scevgep83.i = getelementptr i8, ptr %.55.i, i64 56
  %.2237.le = tail call contract double @llvm.sin.f64(double %.2224)
  %12 = inttoptr i64 %.336.i to ptr
  %13 = inttoptr i64 %.258.i to ptr
  br label %B366.if.i

B366.if.i:                                        ; preds = %B366.if.i, %B366.if.lr.ph.i
  %lsr.iv87.i = phi i64 [ %.140.i, %B366.if.lr.ph.i ], [ %lsr.iv.next.i, %B366.if.i ]
  %lsr.iv84.i = phi ptr [ %scevgep83.i, %B366.if.lr.ph.i ], [ %scevgep85.i, %B366.if.i ]
  %lsr.iv.i = phi ptr [ %scevgep.i, %B366.if.lr.ph.i ], [ %scevgep78.i, %B366.if.i ]
  %scevgep86.i = getelementptr i8, ptr %lsr.iv84.i, i64 -8
  %.638.i = load i64, ptr %lsr.iv84.i, align 8, !noalias !2
  %.639.i = add nsw i64 %.638.i, %.609.i
  %.735.i = load i64, ptr %scevgep86.i, align 8, !noalias !2
  %.735.i.fr = freeze i64 %.735.i
  %.771.i = and i64 %.735.i.fr, 1
  %.772.not.i = icmp eq i64 %.771.i, 0
  %_factors_v21__vphi34_0.2.1.i = select i1 %.772.not.i, double 1.000000e+00, double %.2237.le
  %sunkaddr160 = getelementptr i8, ptr %lsr.iv.i, i64 -32
  %.818.i = load double, ptr %sunkaddr160, align 8, !noalias !2
  %scevgep80.i = getelementptr i8, ptr %lsr.iv.i, i64 -16
  %.848.i = load double, ptr %scevgep80.i, align 8, !noalias !2
  %.878.i = load double, ptr %lsr.iv.i, align 8, !noalias !2
  %.880.i = fmul contract double %.755.i, %.878.i
  %.881.i = fadd contract double %.848.i, %.880.i
  %.883.i = fmul contract double %.755.i, %.881.i
  %.884.i = fadd contract double %.818.i, %.883.i
  %scevgep81.i = getelementptr i8, ptr %lsr.iv.i, i64 -24
  %.914.i = load double, ptr %scevgep81.i, align 8, !noalias !2
  %scevgep82.i = getelementptr i8, ptr %lsr.iv.i, i64 -8
  %.944.i = load double, ptr %scevgep82.i, align 8, !noalias !2
  %.951.i = fmul contract double %.755.i, %.944.i
  %.954.i = fadd contract double %.914.i, %.951.i
  %.956.i = fmul contract double %"$phi1414.1.2.1", %.954.i
  %.959.i = fmul contract double %_factors_v21__vphi34_0.2.1.i, %.884.i
  %.960.i = fmul contract double %_factors_v21__vphi34_0.2.1.i, %.956.i
  %.961.i = fsub contract double 0.000000e+00, %.960.i
  %14 = lshr i64 %.639.i, 33
  %.997.i = and i64 %14, 1073741824
  %15 = getelementptr double, ptr %13, i64 %.639.i
  %.1011.i = getelementptr double, ptr %15, i64 %.997.i
  store double %.959.i, ptr %.1011.i, align 8, !noalias !2
  %.idx4.i = shl i64 %.639.i, 4
  %16 = getelementptr i8, ptr %12, i64 %.idx4.i
  %17 = getelementptr i8, ptr %16, i64 8
  %.1044.i = getelementptr double, ptr %17, i64 %.997.i
  store double %.961.i, ptr %.1044.i, align 8, !noalias !2
  %.1090.i = getelementptr double, ptr %16, i64 %.997.i
  store double %"$phi646.1.2.1.i", ptr %.1090.i, align 8, !noalias !2
  %scevgep78.i = getelementptr i8, ptr %lsr.iv.i, i64 40
  %scevgep85.i = getelementptr i8, ptr %lsr.iv84.i, i64 72
  %lsr.iv.next.i = add i64 %lsr.iv87.i, -1
  %exitcond.not.i = icmp eq i64 %lsr.iv.next.i, 0
  br i1 %exitcond.not.i, label %B1634, label %B366.if.i

B1566:                                            ; preds = %B1414
  %.2283 = fmul contract double %"$phi1414.1.2.1", %"$phi1414.1.2.1"
  %.2284 = fadd contract double %.2283, 1.000000e+00
  %.2285 = fmul contract double %.2284, 5.000000e-01
  %18 = getelementptr double, ptr %9, i64 %.1296.sroa.0.014
  %.2315 = getelementptr double, ptr %18, i64 %.2087
  store double %.2285, ptr %.2315, align 8
  %.2333 = select i1 %.1388, i64 %.986, i64 0
  %.idx = shl i64 %.1296.sroa.0.014, 4
  %19 = getelementptr i8, ptr %10, i64 %.idx
  %.2347 = getelementptr double, ptr %19, i64 %.2333
  store double 0.000000e+00, ptr %.2347, align 8
  %.2350 = fneg contract double %"$phi1414.1.2.1"
  %20 = getelementptr i8, ptr %19, i64 8
  %.2386 = getelementptr double, ptr %20, i64 %.2333
  store double %.2350, ptr %.2386, align 8
  br label %B1634

B1634:                                            ; preds = %B366.if.i, %B1566, %B1460
  %.2390 = icmp ne i64 %.2052, 0
  %.2395 = zext i1 %.2390 to i64
  %.2396 = add nuw nsw i64 %bad.2.011, %.2395
  %.1306 = icmp sgt i64 %.1305127813, 0
  %.1319 = zext i1 %.1306 to i64
  %.13121282 = add i64 %.1312128212, %.1319
  %.1315 = sext i1 %.1306 to i64
  %.13051278 = add nsw i64 %.1305127813, %.1315
  %.1296.sroa.0.0 = select i1 %.1306, i64 %.1312128212, i64 0
  br i1 %.1306, label %B1010, label %B1676

B1676:                                            ; preds = %B1634
  %.2414.not = icmp eq i64 %.2396, 0
  br i1 %.2414.not, label %B1762, label %B1688

B1688:                                            ; preds = %B1676
  %sunkaddr29.le = getelementptr i8, ptr %arg.arguments.4, i64 96
  %.2445 = load i64, ptr %sunkaddr29.le, align 8
  %.2446 = and i64 %.2445, 4
  %.2447.not = icmp eq i64 %.2446, 0
  br i1 %.2447.not, label %B1762, label %B1758

B1758:                                            ; preds = %B1688
  store i64 %.2396, ptr %retptr, align 8
  br label %common.ret

B1762:                                            ; preds = %B1688, %B1676
  %21 = add nuw i64 %.697, 7
  %.2550 = lshr i64 %21, 3
  %22 = add nuw nsw i64 %.2550, 2
  %23 = inttoptr i64 %.904 to ptr
  %24 = inttoptr i64 %.984 to ptr
  br label %B1806.if

B1902:                                            ; preds = %B1806.if
  store ptr null, ptr %.2686, align 8
  %.2700 = call fastcc i32 @inner_1(ptr nonnull %.2686, ptr nonnull %excinfo.13, i64 %31, i64 %.13.i, ptr nonnull %arg.arguments.4, ptr %sunkaddr24, ptr %6, ptr %7, ptr %8, i64 %.697)
  %cond = icmp eq i32 %.2700, 0
  br i1 %cond, label %B1994, label %B1902.if, !prof !0

B1946:                                            ; preds = %B1806.if
  store ptr null, ptr %.2735, align 8
  %.2753 = call fastcc i32 @inner_2(ptr nonnull %.2735, ptr nonnull %excinfo.14, i64 %31, i64 %.13.i, ptr nonnull %arg.arguments.4, ptr %sunkaddr24, ptr %6, ptr %7, ptr %8, i64 %.697, ptr %23, i64 %.697, ptr %24, i64 %.986)
  %cond1 = icmp eq i32 %.2753, 0
  br i1 %cond1, label %B1994, label %B1946.if, !prof !0

B1994:                                            ; preds = %B1946, %B1902
  %lsr.iv.next19 = add nsw i64 %lsr.iv18, -1
  %lsr.iv.next21 = add i64 %lsr.iv20, 8
  %.2571 = icmp sgt i64 %lsr.iv18, 3
  br i1 %.2571, label %B1806.if, label %B1995

B1995:                                            ; preds = %B1994, %B976
  %bad.2.0.lcssa1723 = phi i64 [ 0, %B976 ], [ %.2396, %B1994 ]
  fence seq_cst
  store i64 %bad.2.0.lcssa1723, ptr %retptr, align 8
  br label %common.ret

B284.if:                                          ; preds = %B284
  %.380 = add nuw i64 %.3731275, 1
  %25 = shl i64 %.3731275, 3
  %scevgep = getelementptr i8, ptr %1, i64 %25
  %.434 = load double, ptr %scevgep, align 8
  %scevgep147 = getelementptr i8, ptr %0, i64 %25
  %.464 = load double, ptr %scevgep147, align 8
  %.465 = fcmp contract une double %.434, %.464
  br i1 %.465, label %B324, label %B284

B1010.else.if:                                    ; preds = %B1010
  br label %B1010.else.endif

B1010.else.endif:                                 ; preds = %B1010.else.if, %B1010
  %.1378.sroa.0.1 = phi i64 [ 0, %B1010.else.if ], [ %.1390, %B1010 ]
  %.1398.not = icmp slt i64 %.1390, %.733
  br i1 %.1398.not, label %B1010.else.endif.endif, label %B1010.else.endif.if, !prof !5

B1010.else.endif.if:                              ; preds = %B1010.else.endif
  br label %B1010.else.endif.endif

B1010.else.endif.endif:                           ; preds = %B1010.else.endif.if, %B1010.else.endif
  %.1378.sroa.0.3 = phi i64 [ %.733, %B1010.else.endif.if ], [ %.1378.sroa.0.1, %B1010.else.endif ]
  %.1491 = getelementptr double, ptr %7, i64 %.1378.sroa.0.3
  %.1558 = load i64, ptr %sunkaddr25, align 8
  %26 = lshr i64 %.1558, 33
  %.1596 = and i64 %26, 1073741824
  %.1597 = add i64 %.1596, %.1558
  %27 = tail call i64 @llvm.smax.i64(i64 %.1597, i64 0)
  %.1585.sroa.0.3 = tail call i64 @llvm.smin.i64(i64 %27, i64 1073741824)
  %.1698 = getelementptr double, ptr %6, i64 %.1585.sroa.0.3
  %.1759 = load i64, ptr %sunkaddr27, align 8
  %28 = lshr i64 %.1759, 33
  %.1797 = and i64 %28, 1073741824
  %.1798 = add i64 %.1797, %.1759
  %29 = tail call i64 @llvm.smax.i64(i64 %.1798, i64 0)
  %.1786.sroa.0.3 = tail call i64 @llvm.smin.i64(i64 %29, i64 1073741824)
  %.1899 = getelementptr double, ptr %6, i64 %.1786.sroa.0.3
  %.1967 = load double, ptr %2, align 8
  %.1999 = load double, ptr %sunkaddr28, align 8
  %.2029 = load i64, ptr %sunkaddr29, align 8
  store i64 0, ptr %.2032, align 8
  call fastcc void @inner_3(ptr nonnull %.2032, ptr %.1491, double %.1967, double %.1999, ptr %.1698, ptr %.1899, i64 %.2029, double %least.2.0)
  %.2052 = load i64, ptr %.2032, align 8
  %.2087 = select i1 %.1388, i64 %.697, i64 0
  %30 = getelementptr i8, ptr %8, i64 %.1296.sroa.0.014
  %.2101 = getelementptr i8, ptr %30, i64 %.2087
  %.2102 = trunc i64 %.2052 to i8
  store i8 %.2102, ptr %.2101, align 1
  %.2105 = icmp eq i64 %.2052, 0
  br i1 %.2105, label %B1320, label %B1414

B1806.if:                                         ; preds = %B1994, %B1762
  %lsr.iv20 = phi i64 [ %lsr.iv.next21, %B1994 ], [ 8, %B1762 ]
  %lsr.iv18 = phi i64 [ %lsr.iv.next19, %B1994 ], [ %22, %B1762 ]
  %31 = add i64 %lsr.iv20, -8
  %.13.i = tail call i64 @llvm.smin.i64(i64 %.697, i64 %lsr.iv20)
  %.2675 = load i64, ptr %.1091, align 8
  %.2676.not = icmp eq i64 %.2675, 0
  br i1 %.2676.not, label %B1946, label %B1902

B1902.if:                                         ; preds = %B1902
  %.2701 = load ptr, ptr %excinfo.13, align 8
  store ptr %.2701, ptr %excinfo, align 8
  br label %common.ret

B1946.if:                                         ; preds = %B1946
  %.2754 = load ptr, ptr %excinfo.14, align 8
  store ptr %.2754, ptr %excinfo, align 8
  br label %common.ret
}

; Function Attrs: mustprogress nocallback nocreateundeforpoison nofree nosync nounwind speculatable willreturn memory(none)
declare i64 @llvm.smax.i64(i64, i64) #3

; Function Attrs: mustprogress nocallback nocreateundeforpoison nofree nosync nounwind speculatable willreturn memory(none)
declare double @llvm.cos.f64(double) #3

; Function Attrs: mustprogress nocallback nocreateundeforpoison nofree nosync nounwind speculatable willreturn memory(none)
declare double @llvm.sin.f64(double) #3

; Function Attrs: nofree noinline norecurse nosync nounwind memory(readwrite, inaccessiblemem: none, target_mem0: none, target_mem1: none)
define internal fastcc noundef range(i32 0, 2) i32 @inner_1(ptr noalias nonnull writeonly captures(none) %retptr, ptr noalias nonnull writeonly captures(none) %excinfo, i64 %arg.start, i64 %arg.stop, ptr readonly captures(none) %arg.arguments.4, ptr readonly captures(none) %arg.contents.4, ptr readonly captures(none) %arg.weights.4, ptr readonly captures(none) %arg.parameters.4, ptr readonly captures(none) %arg.status.4, i64 range(i64 1, -9223372036854775808) %arg.status.5.0) unnamed_addr #4 {
entry:
  %.1085 = alloca ptr, align 8
  store ptr null, ptr %.1085, align 8
  %.1597 = alloca ptr, align 8
  store ptr null, ptr %.1597, align 8
  %.1938 = alloca ptr, align 8
  store ptr null, ptr %.1938, align 8
  %excinfo.16 = alloca ptr, align 8
  store ptr null, ptr %excinfo.16, align 8
  %.1988 = alloca ptr, align 8
  store ptr null, ptr %.1988, align 8
  %.109 = getelementptr i8, ptr %arg.arguments.4, i64 104
  %.110 = load i64, ptr %.109, align 8
  %0 = inttoptr i64 %.110 to ptr
  %.499 = add nsw i64 %arg.stop, -1
  %.13.i = tail call i64 @llvm.smin.i64(i64 %.499, i64 %arg.start)
  %.539.idx = mul nsw i64 %.13.i, 80
  %.539 = getelementptr inbounds i8, ptr %arg.parameters.4, i64 %.539.idx
  %.618 = load double, ptr %.539, align 8
  %.646 = getelementptr i8, ptr %.539, i64 24
  %.647 = load double, ptr %.646, align 8
  %scevgep178 = getelementptr i8, ptr %0, i64 32
  store double %.618, ptr %0, align 8
  %scevgep180 = getelementptr i8, ptr %0, i64 8
  store double %.647, ptr %scevgep180, align 8
  %.738 = getelementptr i8, ptr %.539, i64 32
  %.739 = load double, ptr %.738, align 8
  %.767 = getelementptr i8, ptr %.539, i64 8
  %.768 = load double, ptr %.767, align 8
  %scevgep182 = getelementptr i8, ptr %0, i64 16
  store double %.739, ptr %scevgep182, align 8
  %scevgep183 = getelementptr i8, ptr %0, i64 24
  store double %.768, ptr %scevgep183, align 8
  %.860 = getelementptr i8, ptr %.539, i64 16
  %.861 = load double, ptr %.860, align 8
  store double %.861, ptr %scevgep178, align 8
  %lsr.iv.next186 = add i64 %arg.start, 1
  %.13.i.1 = tail call i64 @llvm.smin.i64(i64 %.499, i64 %lsr.iv.next186)
  %.539.idx.1 = mul nsw i64 %.13.i.1, 80
  %.539.1 = getelementptr inbounds i8, ptr %arg.parameters.4, i64 %.539.idx.1
  %.618.1 = load double, ptr %.539.1, align 8
  %.646.1 = getelementptr i8, ptr %.539.1, i64 24
  %.647.1 = load double, ptr %.646.1, align 8
  %scevgep178.1 = getelementptr i8, ptr %0, i64 72
  %scevgep179.1 = getelementptr i8, ptr %0, i64 40
  store double %.618.1, ptr %scevgep179.1, align 8
  %scevgep180.1 = getelementptr i8, ptr %0, i64 48
  store double %.647.1, ptr %scevgep180.1, align 8
  %.738.1 = getelementptr i8, ptr %.539.1, i64 32
  %.739.1 = load double, ptr %.738.1, align 8
  %.767.1 = getelementptr i8, ptr %.539.1, i64 8
  %.768.1 = load double, ptr %.767.1, align 8
  %scevgep182.1 = getelementptr i8, ptr %0, i64 56
  store double %.739.1, ptr %scevgep182.1, align 8
  %scevgep183.1 = getelementptr i8, ptr %0, i64 64
  store double %.768.1, ptr %scevgep183.1, align 8
  %.860.1 = getelementptr i8, ptr %.539.1, i64 16
  %.861.1 = load double, ptr %.860.1, align 8
  store double %.861.1, ptr %scevgep178.1, align 8
  %lsr.iv.next186.1 = add i64 %arg.start, 2
  %.13.i.2 = tail call i64 @llvm.smin.i64(i64 %.499, i64 %lsr.iv.next186.1)
  %.539.idx.2 = mul nsw i64 %.13.i.2, 80
  %.539.2 = getelementptr inbounds i8, ptr %arg.parameters.4, i64 %.539.idx.2
  %.618.2 = load double, ptr %.539.2, align 8
  %.646.2 = getelementptr i8, ptr %.539.2, i64 24
  %.647.2 = load double, ptr %.646.2, align 8
  %scevgep178.2 = getelementptr i8, ptr %0, i64 112
  %scevgep179.2 = getelementptr i8, ptr %0, i64 80
  store double %.618.2, ptr %scevgep179.2, align 8
  %scevgep180.2 = getelementptr i8, ptr %0, i64 88
  store double %.647.2, ptr %scevgep180.2, align 8
  %.738.2 = getelementptr i8, ptr %.539.2, i64 32
  %.739.2 = load double, ptr %.738.2, align 8
  %.767.2 = getelementptr i8, ptr %.539.2, i64 8
  %.768.2 = load double, ptr %.767.2, align 8
  %scevgep182.2 = getelementptr i8, ptr %0, i64 96
  store double %.739.2, ptr %scevgep182.2, align 8
  %scevgep183.2 = getelementptr i8, ptr %0, i64 104
  store double %.768.2, ptr %scevgep183.2, align 8
  %.860.2 = getelementptr i8, ptr %.539.2, i64 16
  %.861.2 = load double, ptr %.860.2, align 8
  store double %.861.2, ptr %scevgep178.2, align 8
  %lsr.iv.next186.2 = add i64 %arg.start, 3
  %.13.i.3 = tail call i64 @llvm.smin.i64(i64 %.499, i64 %lsr.iv.next186.2)
  %.539.idx.3 = mul nsw i64 %.13.i.3, 80
  %.539.3 = getelementptr inbounds i8, ptr %arg.parameters.4, i64 %.539.idx.3
  %.618.3 = load double, ptr %.539.3, align 8
  %.646.3 = getelementptr i8, ptr %.539.3, i64 24
  %.647.3 = load double, ptr %.646.3, align 8
  %scevgep178.3 = getelementptr i8, ptr %0, i64 152
  %scevgep179.3 = getelementptr i8, ptr %0, i64 120
  store double %.618.3, ptr %scevgep179.3, align 8
  %scevgep180.3 = getelementptr i8, ptr %0, i64 128
  store double %.647.3, ptr %scevgep180.3, align 8
  %.738.3 = getelementptr i8, ptr %.539.3, i64 32
  %.739.3 = load double, ptr %.738.3, align 8
  %.767.3 = getelementptr i8, ptr %.539.3, i64 8
  %.768.3 = load double, ptr %.767.3, align 8
  %scevgep182.3 = getelementptr i8, ptr %0, i64 136
  store double %.739.3, ptr %scevgep182.3, align 8
  %scevgep183.3 = getelementptr i8, ptr %0, i64 144
  store double %.768.3, ptr %scevgep183.3, align 8
  %.860.3 = getelementptr i8, ptr %.539.3, i64 16
  %.861.3 = load double, ptr %.860.3, align 8
  store double %.861.3, ptr %scevgep178.3, align 8
  %lsr.iv.next186.3 = add i64 %arg.start, 4
  %.13.i.4 = tail call i64 @llvm.smin.i64(i64 %.499, i64 %lsr.iv.next186.3)
  %.539.idx.4 = mul nsw i64 %.13.i.4, 80
  %.539.4 = getelementptr inbounds i8, ptr %arg.parameters.4, i64 %.539.idx.4
  %.618.4 = load double, ptr %.539.4, align 8
  %.646.4 = getelementptr i8, ptr %.539.4, i64 24
  %.647.4 = load double, ptr %.646.4, align 8
  %scevgep178.4 = getelementptr i8, ptr %0, i64 192
  %scevgep179.4 = getelementptr i8, ptr %0, i64 160
  store double %.618.4, ptr %scevgep179.4, align 8
  %scevgep180.4 = getelementptr i8, ptr %0, i64 168
  store double %.647.4, ptr %scevgep180.4, align 8
  %.738.4 = getelementptr i8, ptr %.539.4, i64 32
  %.739.4 = load double, ptr %.738.4, align 8
  %.767.4 = getelementptr i8, ptr %.539.4, i64 8
  %.768.4 = load double, ptr %.767.4, align 8
  %scevgep182.4 = getelementptr i8, ptr %0, i64 176
  store double %.739.4, ptr %scevgep182.4, align 8
  %scevgep183.4 = getelementptr i8, ptr %0, i64 184
  store double %.768.4, ptr %scevgep183.4, align 8
  %.860.4 = getelementptr i8, ptr %.539.4, i64 16
  %.861.4 = load double, ptr %.860.4, align 8
  store double %.861.4, ptr %scevgep178.4, align 8
  %lsr.iv.next186.4 = add i64 %arg.start, 5
  %.13.i.5 = tail call i64 @llvm.smin.i64(i64 %.499, i64 %lsr.iv.next186.4)
  %.539.idx.5 = mul nsw i64 %.13.i.5, 80
  %.539.5 = getelementptr inbounds i8, ptr %arg.parameters.4, i64 %.539.idx.5
  %.618.5 = load double, ptr %.539.5, align 8
  %.646.5 = getelementptr i8, ptr %.539.5, i64 24
  %.647.5 = load double, ptr %.646.5, align 8
  %scevgep178.5 = getelementptr i8, ptr %0, i64 232
  %scevgep179.5 = getelementptr i8, ptr %0, i64 200
  store double %.618.5, ptr %scevgep179.5, align 8
  %scevgep180.5 = getelementptr i8, ptr %0, i64 208
  store double %.647.5, ptr %scevgep180.5, align 8
  %.738.5 = getelementptr i8, ptr %.539.5, i64 32
  %.739.5 = load double, ptr %.738.5, align 8
  %.767.5 = getelementptr i8, ptr %.539.5, i64 8
  %.768.5 = load double, ptr %.767.5, align 8
  %scevgep182.5 = getelementptr i8, ptr %0, i64 216
  store double %.739.5, ptr %scevgep182.5, align 8
  %scevgep183.5 = getelementptr i8, ptr %0, i64 224
  store double %.768.5, ptr %scevgep183.5, align 8
  %.860.5 = getelementptr i8, ptr %.539.5, i64 16
  %.861.5 = load double, ptr %.860.5, align 8
  store double %.861.5, ptr %scevgep178.5, align 8
  %lsr.iv.next186.5 = add i64 %arg.start, 6
  %.13.i.6 = tail call i64 @llvm.smin.i64(i64 %.499, i64 %lsr.iv.next186.5)
  %.539.idx.6 = mul nsw i64 %.13.i.6, 80
  %.539.6 = getelementptr inbounds i8, ptr %arg.parameters.4, i64 %.539.idx.6
  %.618.6 = load double, ptr %.539.6, align 8
  %.646.6 = getelementptr i8, ptr %.539.6, i64 24
  %.647.6 = load double, ptr %.646.6, align 8
  %scevgep178.6 = getelementptr i8, ptr %0, i64 272
  %scevgep179.6 = getelementptr i8, ptr %0, i64 240
  store double %.618.6, ptr %scevgep179.6, align 8
  %scevgep180.6 = getelementptr i8, ptr %0, i64 248
  store double %.647.6, ptr %scevgep180.6, align 8
  %.738.6 = getelementptr i8, ptr %.539.6, i64 32
  %.739.6 = load double, ptr %.738.6, align 8
  %.767.6 = getelementptr i8, ptr %.539.6, i64 8
  %.768.6 = load double, ptr %.767.6, align 8
  %scevgep182.6 = getelementptr i8, ptr %0, i64 256
  store double %.739.6, ptr %scevgep182.6, align 8
  %scevgep183.6 = getelementptr i8, ptr %0, i64 264
  store double %.768.6, ptr %scevgep183.6, align 8
  %.860.6 = getelementptr i8, ptr %.539.6, i64 16
  %.861.6 = load double, ptr %.860.6, align 8
  store double %.861.6, ptr %scevgep178.6, align 8
  %lsr.iv.next186.6 = add i64 %arg.start, 7
  %.13.i.7 = tail call i64 @llvm.smin.i64(i64 %.499, i64 %lsr.iv.next186.6)
  %.539.idx.7 = mul nsw i64 %.13.i.7, 80
  %.539.7 = getelementptr inbounds i8, ptr %arg.parameters.4, i64 %.539.idx.7
  %.618.7 = load double, ptr %.539.7, align 8
  %.646.7 = getelementptr i8, ptr %.539.7, i64 24
  %.647.7 = load double, ptr %.646.7, align 8
  %scevgep178.7 = getelementptr i8, ptr %0, i64 312
  %scevgep179.7 = getelementptr i8, ptr %0, i64 280
  store double %.618.7, ptr %scevgep179.7, align 8
  %scevgep180.7 = getelementptr i8, ptr %0, i64 288
  store double %.647.7, ptr %scevgep180.7, align 8
  %.738.7 = getelementptr i8, ptr %.539.7, i64 32
  %.739.7 = load double, ptr %.738.7, align 8
  %.767.7 = getelementptr i8, ptr %.539.7, i64 8
  %.768.7 = load double, ptr %.767.7, align 8
  %scevgep182.7 = getelementptr i8, ptr %0, i64 296
  store double %.739.7, ptr %scevgep182.7, align 8
  %scevgep183.7 = getelementptr i8, ptr %0, i64 304
  store double %.768.7, ptr %scevgep183.7, align 8
  %.860.7 = getelementptr i8, ptr %.539.7, i64 16
  %.861.7 = load double, ptr %.860.7, align 8
  store double %.861.7, ptr %scevgep178.7, align 8
  %.280 = getelementptr inbounds nuw i8, ptr %0, i64 320
  %.945 = getelementptr i8, ptr %arg.contents.4, i64 80
  %.946 = load i64, ptr %.945, align 8
  %.962 = getelementptr inbounds double, ptr %arg.weights.4, i64 %.946
  %.1031 = getelementptr i8, ptr %0, i64 640
  store ptr null, ptr %.1085, align 8
  call fastcc void @inner_4(ptr nonnull %.1085, ptr %0, ptr %arg.contents.4, ptr %.962, ptr nonnull %.1031, ptr nonnull %.280)
  %.1179 = getelementptr i8, ptr %arg.arguments.4, i64 168
  %.1180 = load i64, ptr %.1179, align 8
  %.1181 = inttoptr i64 %.1180 to ptr
  %.1258 = getelementptr i8, ptr %arg.contents.4, i64 64
  %.1259 = load i64, ptr %.1258, align 8
  %.neg = mul i64 %.1259, -4
  %1 = and i64 %.neg, -32
  %.1304 = sub i64 8, %1
  %2 = shl i64 %1, 3
  %.1382 = sub i64 144, %2
  %.1410 = getelementptr i8, ptr %.1181, i64 24
  %.1411 = load i64, ptr %.1410, align 8
  %.1422 = getelementptr double, ptr %0, i64 %.1382
  %.1531 = getelementptr double, ptr %.1422, i64 %.1411
  store ptr null, ptr %.1597, align 8
  call fastcc void @inner_5(ptr nonnull %.1597, i64 %arg.start, i64 %arg.stop, ptr %arg.arguments.4, ptr %arg.contents.4, ptr %arg.weights.4, ptr nonnull %.280, ptr nonnull %.1031, ptr %.1422, ptr %.1531)
  %.1678 = sub i64 %arg.stop, %arg.start
  %.17211219.not = icmp slt i64 %.1678, 1
  br i1 %.17211219.not, label %B5043, label %B820.if.preheader

B855:                                             ; preds = %B820.if
  store ptr null, ptr %.1938, align 8
  %.1956 = call fastcc i32 @inner_6(ptr nonnull %.1938, ptr nonnull %excinfo.16, i64 %8, i64 %lsr.iv171, ptr %lsr.iv167, ptr nonnull %lsr.iv174, i64 %.1304, ptr %.1422, ptr %arg.arguments.4, ptr %arg.contents.4, ptr %arg.weights.4, ptr %.1531)
  %cond = icmp eq i32 %.1956, 0
  br i1 %cond, label %B4671, label %B855.endif.endif.if, !prof !0

B4669:                                            ; preds = %B820.if
  store ptr null, ptr %.1988, align 8
  call fastcc void @inner_7(ptr nonnull %.1988, i64 %8, ptr %arg.arguments.4)
  br label %B4671

B4671:                                            ; preds = %B855, %B4669
  %scevgep168 = getelementptr i8, ptr %lsr.iv167, i64 80
  %lsr.iv.next172 = add nuw nsw i64 %lsr.iv171, 1
  %scevgep175 = getelementptr i8, ptr %lsr.iv174, i64 %6
  %3 = xor i64 %lsr.iv171, %7
  %exitcond.not = icmp eq i64 %3, -1
  br i1 %exitcond.not, label %B5043, label %B820.if

common.ret:                                       ; preds = %B855.endif.endif.if, %B5043
  %common.ret.op = phi i32 [ 0, %B5043 ], [ %.1956, %B855.endif.endif.if ]
  ret i32 %common.ret.op

B5043:                                            ; preds = %B4671, %entry
  store ptr null, ptr %retptr, align 8
  br label %common.ret

B820.if.preheader:                                ; preds = %entry
  %4 = mul i64 %arg.start, 80
  %scevgep = getelementptr i8, ptr %arg.parameters.4, i64 %4
  %scevgep169 = getelementptr i8, ptr %arg.status.4, i64 %arg.start
  %.neg1 = mul i64 %.1259, -32
  %5 = and i64 %.neg1, -256
  %6 = sub i64 64, %5
  %7 = sub i64 %arg.start, %arg.stop
  br label %B820.if

B820.if:                                          ; preds = %B820.if.preheader, %B4671
  %lsr.iv174 = phi ptr [ %.1031, %B820.if.preheader ], [ %scevgep175, %B4671 ]
  %lsr.iv171 = phi i64 [ 0, %B820.if.preheader ], [ %lsr.iv.next172, %B4671 ]
  %lsr.iv167 = phi ptr [ %scevgep, %B820.if.preheader ], [ %scevgep168, %B4671 ]
  %8 = add i64 %lsr.iv171, %arg.start
  %.1776 = icmp slt i64 %8, 0
  %.1777 = select i1 %.1776, i64 %arg.status.5.0, i64 0
  %scevgep170 = getelementptr i8, ptr %scevgep169, i64 %.1777
  %scevgep173 = getelementptr i8, ptr %scevgep170, i64 %lsr.iv171
  %.1792 = load i8, ptr %scevgep173, align 1
  %.1794 = icmp eq i8 %.1792, 0
  br i1 %.1794, label %B855, label %B4669

B855.endif.endif.if:                              ; preds = %B855
  %.1957 = load ptr, ptr %excinfo.16, align 8
  store ptr %.1957, ptr %excinfo, align 8
  br label %common.ret
}

; Function Attrs: nofree noinline norecurse nosync nounwind memory(readwrite, inaccessiblemem: none, target_mem0: none, target_mem1: none)
define internal fastcc noundef range(i32 0, 2) i32 @inner_2(ptr noalias nonnull writeonly captures(none) %retptr, ptr noalias nonnull writeonly captures(none) %excinfo, i64 %arg.start, i64 %arg.stop, ptr readonly captures(none) %arg.arguments.4, ptr readonly captures(none) %arg.contents.4, ptr readonly captures(none) %arg.weights.4, ptr readonly captures(none) %arg.parameters.4, ptr readonly captures(none) %arg.status.4, i64 range(i64 1, -9223372036854775808) %arg.status.5.0, ptr readonly captures(none) %arg.plus.4, i64 range(i64 1, -9223372036854775808) %arg.plus.5.0, ptr readonly captures(none) %arg.cross.4, i64 range(i64 -9223372036854775808, 9223372036854775807) %arg.cross.5.0) unnamed_addr #4 {
entry:
  %.1113 = alloca ptr, align 8
  store ptr null, ptr %.1113, align 8
  %.1567 = alloca { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, align 8
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(56) %.1567, i8 0, i64 56, i1 false)
  %.2427 = alloca ptr, align 8
  store ptr null, ptr %.2427, align 8
  %excinfo.16 = alloca ptr, align 8
  store ptr null, ptr %excinfo.16, align 8
  %.2475 = alloca ptr, align 8
  store ptr null, ptr %.2475, align 8
  %.137 = getelementptr i8, ptr %arg.arguments.4, i64 104
  %.138 = load i64, ptr %.137, align 8
  %0 = inttoptr i64 %.138 to ptr
  %.527 = add nsw i64 %arg.stop, -1
  %.13.i = tail call i64 @llvm.smin.i64(i64 %.527, i64 %arg.start)
  %.567.idx = mul nsw i64 %.13.i, 80
  %.567 = getelementptr inbounds i8, ptr %arg.parameters.4, i64 %.567.idx
  %.646 = load double, ptr %.567, align 8
  %.674 = getelementptr i8, ptr %.567, i64 24
  %.675 = load double, ptr %.674, align 8
  %scevgep188 = getelementptr i8, ptr %0, i64 32
  store double %.646, ptr %0, align 8
  %scevgep190 = getelementptr i8, ptr %0, i64 8
  store double %.675, ptr %scevgep190, align 8
  %.766 = getelementptr i8, ptr %.567, i64 32
  %.767 = load double, ptr %.766, align 8
  %.795 = getelementptr i8, ptr %.567, i64 8
  %.796 = load double, ptr %.795, align 8
  %scevgep192 = getelementptr i8, ptr %0, i64 16
  store double %.767, ptr %scevgep192, align 8
  %scevgep193 = getelementptr i8, ptr %0, i64 24
  store double %.796, ptr %scevgep193, align 8
  %.888 = getelementptr i8, ptr %.567, i64 16
  %.889 = load double, ptr %.888, align 8
  store double %.889, ptr %scevgep188, align 8
  %lsr.iv.next196 = add i64 %arg.start, 1
  %.13.i.1 = tail call i64 @llvm.smin.i64(i64 %.527, i64 %lsr.iv.next196)
  %.567.idx.1 = mul nsw i64 %.13.i.1, 80
  %.567.1 = getelementptr inbounds i8, ptr %arg.parameters.4, i64 %.567.idx.1
  %.646.1 = load double, ptr %.567.1, align 8
  %.674.1 = getelementptr i8, ptr %.567.1, i64 24
  %.675.1 = load double, ptr %.674.1, align 8
  %scevgep188.1 = getelementptr i8, ptr %0, i64 72
  %scevgep189.1 = getelementptr i8, ptr %0, i64 40
  store double %.646.1, ptr %scevgep189.1, align 8
  %scevgep190.1 = getelementptr i8, ptr %0, i64 48
  store double %.675.1, ptr %scevgep190.1, align 8
  %.766.1 = getelementptr i8, ptr %.567.1, i64 32
  %.767.1 = load double, ptr %.766.1, align 8
  %.795.1 = getelementptr i8, ptr %.567.1, i64 8
  %.796.1 = load double, ptr %.795.1, align 8
  %scevgep192.1 = getelementptr i8, ptr %0, i64 56
  store double %.767.1, ptr %scevgep192.1, align 8
  %scevgep193.1 = getelementptr i8, ptr %0, i64 64
  store double %.796.1, ptr %scevgep193.1, align 8
  %.888.1 = getelementptr i8, ptr %.567.1, i64 16
  %.889.1 = load double, ptr %.888.1, align 8
  store double %.889.1, ptr %scevgep188.1, align 8
  %lsr.iv.next196.1 = add i64 %arg.start, 2
  %.13.i.2 = tail call i64 @llvm.smin.i64(i64 %.527, i64 %lsr.iv.next196.1)
  %.567.idx.2 = mul nsw i64 %.13.i.2, 80
  %.567.2 = getelementptr inbounds i8, ptr %arg.parameters.4, i64 %.567.idx.2
  %.646.2 = load double, ptr %.567.2, align 8
  %.674.2 = getelementptr i8, ptr %.567.2, i64 24
  %.675.2 = load double, ptr %.674.2, align 8
  %scevgep188.2 = getelementptr i8, ptr %0, i64 112
  %scevgep189.2 = getelementptr i8, ptr %0, i64 80
  store double %.646.2, ptr %scevgep189.2, align 8
  %scevgep190.2 = getelementptr i8, ptr %0, i64 88
  store double %.675.2, ptr %scevgep190.2, align 8
  %.766.2 = getelementptr i8, ptr %.567.2, i64 32
  %.767.2 = load double, ptr %.766.2, align 8
  %.795.2 = getelementptr i8, ptr %.567.2, i64 8
  %.796.2 = load double, ptr %.795.2, align 8
  %scevgep192.2 = getelementptr i8, ptr %0, i64 96
  store double %.767.2, ptr %scevgep192.2, align 8
  %scevgep193.2 = getelementptr i8, ptr %0, i64 104
  store double %.796.2, ptr %scevgep193.2, align 8
  %.888.2 = getelementptr i8, ptr %.567.2, i64 16
  %.889.2 = load double, ptr %.888.2, align 8
  store double %.889.2, ptr %scevgep188.2, align 8
  %lsr.iv.next196.2 = add i64 %arg.start, 3
  %.13.i.3 = tail call i64 @llvm.smin.i64(i64 %.527, i64 %lsr.iv.next196.2)
  %.567.idx.3 = mul nsw i64 %.13.i.3, 80
  %.567.3 = getelementptr inbounds i8, ptr %arg.parameters.4, i64 %.567.idx.3
  %.646.3 = load double, ptr %.567.3, align 8
  %.674.3 = getelementptr i8, ptr %.567.3, i64 24
  %.675.3 = load double, ptr %.674.3, align 8
  %scevgep188.3 = getelementptr i8, ptr %0, i64 152
  %scevgep189.3 = getelementptr i8, ptr %0, i64 120
  store double %.646.3, ptr %scevgep189.3, align 8
  %scevgep190.3 = getelementptr i8, ptr %0, i64 128
  store double %.675.3, ptr %scevgep190.3, align 8
  %.766.3 = getelementptr i8, ptr %.567.3, i64 32
  %.767.3 = load double, ptr %.766.3, align 8
  %.795.3 = getelementptr i8, ptr %.567.3, i64 8
  %.796.3 = load double, ptr %.795.3, align 8
  %scevgep192.3 = getelementptr i8, ptr %0, i64 136
  store double %.767.3, ptr %scevgep192.3, align 8
  %scevgep193.3 = getelementptr i8, ptr %0, i64 144
  store double %.796.3, ptr %scevgep193.3, align 8
  %.888.3 = getelementptr i8, ptr %.567.3, i64 16
  %.889.3 = load double, ptr %.888.3, align 8
  store double %.889.3, ptr %scevgep188.3, align 8
  %lsr.iv.next196.3 = add i64 %arg.start, 4
  %.13.i.4 = tail call i64 @llvm.smin.i64(i64 %.527, i64 %lsr.iv.next196.3)
  %.567.idx.4 = mul nsw i64 %.13.i.4, 80
  %.567.4 = getelementptr inbounds i8, ptr %arg.parameters.4, i64 %.567.idx.4
  %.646.4 = load double, ptr %.567.4, align 8
  %.674.4 = getelementptr i8, ptr %.567.4, i64 24
  %.675.4 = load double, ptr %.674.4, align 8
  %scevgep188.4 = getelementptr i8, ptr %0, i64 192
  %scevgep189.4 = getelementptr i8, ptr %0, i64 160
  store double %.646.4, ptr %scevgep189.4, align 8
  %scevgep190.4 = getelementptr i8, ptr %0, i64 168
  store double %.675.4, ptr %scevgep190.4, align 8
  %.766.4 = getelementptr i8, ptr %.567.4, i64 32
  %.767.4 = load double, ptr %.766.4, align 8
  %.795.4 = getelementptr i8, ptr %.567.4, i64 8
  %.796.4 = load double, ptr %.795.4, align 8
  %scevgep192.4 = getelementptr i8, ptr %0, i64 176
  store double %.767.4, ptr %scevgep192.4, align 8
  %scevgep193.4 = getelementptr i8, ptr %0, i64 184
  store double %.796.4, ptr %scevgep193.4, align 8
  %.888.4 = getelementptr i8, ptr %.567.4, i64 16
  %.889.4 = load double, ptr %.888.4, align 8
  store double %.889.4, ptr %scevgep188.4, align 8
  %lsr.iv.next196.4 = add i64 %arg.start, 5
  %.13.i.5 = tail call i64 @llvm.smin.i64(i64 %.527, i64 %lsr.iv.next196.4)
  %.567.idx.5 = mul nsw i64 %.13.i.5, 80
  %.567.5 = getelementptr inbounds i8, ptr %arg.parameters.4, i64 %.567.idx.5
  %.646.5 = load double, ptr %.567.5, align 8
  %.674.5 = getelementptr i8, ptr %.567.5, i64 24
  %.675.5 = load double, ptr %.674.5, align 8
  %scevgep188.5 = getelementptr i8, ptr %0, i64 232
  %scevgep189.5 = getelementptr i8, ptr %0, i64 200
  store double %.646.5, ptr %scevgep189.5, align 8
  %scevgep190.5 = getelementptr i8, ptr %0, i64 208
  store double %.675.5, ptr %scevgep190.5, align 8
  %.766.5 = getelementptr i8, ptr %.567.5, i64 32
  %.767.5 = load double, ptr %.766.5, align 8
  %.795.5 = getelementptr i8, ptr %.567.5, i64 8
  %.796.5 = load double, ptr %.795.5, align 8
  %scevgep192.5 = getelementptr i8, ptr %0, i64 216
  store double %.767.5, ptr %scevgep192.5, align 8
  %scevgep193.5 = getelementptr i8, ptr %0, i64 224
  store double %.796.5, ptr %scevgep193.5, align 8
  %.888.5 = getelementptr i8, ptr %.567.5, i64 16
  %.889.5 = load double, ptr %.888.5, align 8
  store double %.889.5, ptr %scevgep188.5, align 8
  %lsr.iv.next196.5 = add i64 %arg.start, 6
  %.13.i.6 = tail call i64 @llvm.smin.i64(i64 %.527, i64 %lsr.iv.next196.5)
  %.567.idx.6 = mul nsw i64 %.13.i.6, 80
  %.567.6 = getelementptr inbounds i8, ptr %arg.parameters.4, i64 %.567.idx.6
  %.646.6 = load double, ptr %.567.6, align 8
  %.674.6 = getelementptr i8, ptr %.567.6, i64 24
  %.675.6 = load double, ptr %.674.6, align 8
  %scevgep188.6 = getelementptr i8, ptr %0, i64 272
  %scevgep189.6 = getelementptr i8, ptr %0, i64 240
  store double %.646.6, ptr %scevgep189.6, align 8
  %scevgep190.6 = getelementptr i8, ptr %0, i64 248
  store double %.675.6, ptr %scevgep190.6, align 8
  %.766.6 = getelementptr i8, ptr %.567.6, i64 32
  %.767.6 = load double, ptr %.766.6, align 8
  %.795.6 = getelementptr i8, ptr %.567.6, i64 8
  %.796.6 = load double, ptr %.795.6, align 8
  %scevgep192.6 = getelementptr i8, ptr %0, i64 256
  store double %.767.6, ptr %scevgep192.6, align 8
  %scevgep193.6 = getelementptr i8, ptr %0, i64 264
  store double %.796.6, ptr %scevgep193.6, align 8
  %.888.6 = getelementptr i8, ptr %.567.6, i64 16
  %.889.6 = load double, ptr %.888.6, align 8
  store double %.889.6, ptr %scevgep188.6, align 8
  %lsr.iv.next196.6 = add i64 %arg.start, 7
  %.13.i.7 = tail call i64 @llvm.smin.i64(i64 %.527, i64 %lsr.iv.next196.6)
  %.567.idx.7 = mul nsw i64 %.13.i.7, 80
  %.567.7 = getelementptr inbounds i8, ptr %arg.parameters.4, i64 %.567.idx.7
  %.646.7 = load double, ptr %.567.7, align 8
  %.674.7 = getelementptr i8, ptr %.567.7, i64 24
  %.675.7 = load double, ptr %.674.7, align 8
  %scevgep188.7 = getelementptr i8, ptr %0, i64 312
  %scevgep189.7 = getelementptr i8, ptr %0, i64 280
  store double %.646.7, ptr %scevgep189.7, align 8
  %scevgep190.7 = getelementptr i8, ptr %0, i64 288
  store double %.675.7, ptr %scevgep190.7, align 8
  %.766.7 = getelementptr i8, ptr %.567.7, i64 32
  %.767.7 = load double, ptr %.766.7, align 8
  %.795.7 = getelementptr i8, ptr %.567.7, i64 8
  %.796.7 = load double, ptr %.795.7, align 8
  %scevgep192.7 = getelementptr i8, ptr %0, i64 296
  store double %.767.7, ptr %scevgep192.7, align 8
  %scevgep193.7 = getelementptr i8, ptr %0, i64 304
  store double %.796.7, ptr %scevgep193.7, align 8
  %.888.7 = getelementptr i8, ptr %.567.7, i64 16
  %.889.7 = load double, ptr %.888.7, align 8
  store double %.889.7, ptr %scevgep188.7, align 8
  %.308 = getelementptr inbounds nuw i8, ptr %0, i64 320
  %.973 = getelementptr i8, ptr %arg.contents.4, i64 80
  %.974 = load i64, ptr %.973, align 8
  %.990 = getelementptr inbounds double, ptr %arg.weights.4, i64 %.974
  %.1059 = getelementptr i8, ptr %0, i64 640
  store ptr null, ptr %.1113, align 8
  call fastcc void @inner_4(ptr nonnull %.1113, ptr %0, ptr %arg.contents.4, ptr %.990, ptr nonnull %.1059, ptr nonnull %.308)
  %.fca.4.gep367 = getelementptr inbounds nuw i8, ptr %.1567, i64 32
  %.1207 = getelementptr i8, ptr %arg.contents.4, i64 56
  %.1208 = load i64, ptr %.1207, align 8
  %.1209 = sub i64 0, %.1208
  %.1217.1 = and i64 %.1209, 9223372036854775800
  %.1281 = getelementptr i8, ptr %arg.contents.4, i64 64
  %.1282 = load i64, ptr %.1281, align 8
  %.1283 = sub i64 0, %.1282
  %.1291.1 = and i64 %.1283, 9223372036854775800
  %1 = add nuw i64 %.1291.1, %.1217.1
  %.neg = mul i64 %1, -2
  %.1328 = or disjoint i64 %.neg, 8
  %2 = shl i64 %1, 4
  %.1406 = sub i64 144, %2
  %.1422 = getelementptr inbounds double, ptr %0, i64 %.1406
  %.1508 = getelementptr i8, ptr %arg.arguments.4, i64 72
  %.1509 = load i64, ptr %.1508, align 8
  %.1510 = inttoptr i64 %.1509 to ptr
  %.1561 = sub i64 %arg.stop, %arg.start
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(56) %.1567, i8 0, i64 56, i1 false)
  call fastcc void @inner_8(ptr nonnull %.1567, ptr nonnull %.308, i64 %.1561, ptr %arg.contents.4, ptr %.1510, ptr %arg.weights.4, i64 %.1328, ptr nonnull %.1059, ptr nonnull %.1422)
  %.1593.fca.4.load = load ptr, ptr %.fca.4.gep367, align 8
  %sunkaddr = getelementptr inbounds nuw i8, ptr %.1567, i64 40
  %.1593.fca.5.0.load = load i64, ptr %sunkaddr, align 8
  %.1655 = getelementptr i8, ptr %arg.contents.4, i64 24
  %.1656 = load i64, ptr %.1655, align 8
  %.1657 = sub i64 0, %.1656
  %.1665.1 = and i64 %.1657, -8
  %.1732 = getelementptr i8, ptr %arg.arguments.4, i64 160
  %.1733 = load i64, ptr %.1732, align 8
  %.1734.not = icmp eq i64 %.1733, 0
  %.21501450.not = icmp slt i64 %.1561, 1
  br i1 %.1734.not, label %B956, label %B876

B876:                                             ; preds = %entry
  br i1 %.21501450.not, label %B634423, label %B908.if.preheader

B908.if.preheader:                                ; preds = %B876
  %3 = add nuw i64 %.1561, 1
  %4 = shl i64 %arg.stop, 3
  %5 = inttoptr i64 %.1733 to ptr
  br label %B908.if

B956:                                             ; preds = %entry
  br i1 %.21501450.not, label %B634423, label %B1146.if.preheader

B1146.if.preheader:                               ; preds = %B908.if, %B956
  %6 = add i64 %.1561, 1
  %7 = shl i64 %arg.start, 4
  %8 = getelementptr i8, ptr %arg.cross.4, i64 %7
  %scevgep = getelementptr i8, ptr %8, i64 8
  %9 = mul i64 %arg.start, 80
  %scevgep173 = getelementptr i8, ptr %arg.parameters.4, i64 %9
  %10 = shl i64 %.1283, 1
  %11 = and i64 %10, 2305843009213693936
  %12 = shl i64 %.1209, 1
  %13 = and i64 %12, 2305843009213693936
  %14 = add nuw nsw i64 %11, %13
  %15 = shl i64 %14, 3
  %16 = sub i64 64, %15
  %17 = shl i64 %arg.plus.5.0, 3
  %18 = shl i64 %arg.cross.5.0, 3
  br label %B1146.if

B1181:                                            ; preds = %B1146.if
  %19 = select i1 %.2205, i64 %17, i64 0
  %scevgep171 = getelementptr i8, ptr %arg.plus.4, i64 %19
  %20 = shl i64 %.215614461451, 3
  %scevgep172 = getelementptr i8, ptr %scevgep171, i64 %20
  %.2388 = load double, ptr %scevgep172, align 8
  %21 = select i1 %.2205, i64 %18, i64 0
  %scevgep170 = getelementptr i8, ptr %lsr.iv168, i64 %21
  %.2421 = load double, ptr %scevgep170, align 8
  store ptr null, ptr %.2427, align 8
  %.2443 = call fastcc i32 @inner_9(ptr nonnull %.2427, ptr nonnull %excinfo.16, i64 %.215614461451, ptr %lsr.iv174, ptr nonnull %lsr.iv178, i64 %.1328, ptr %arg.arguments.4, ptr %arg.contents.4, ptr %arg.weights.4, ptr nonnull %.1422, double %.2388, double %.2421)
  %cond = icmp eq i32 %.2443, 0
  br i1 %cond, label %B634051, label %B1181.endif.endif.if, !prof !0

B634049:                                          ; preds = %B1146.if
  store ptr null, ptr %.2475, align 8
  call fastcc void @inner_7(ptr nonnull %.2475, i64 %.215614461451, ptr %arg.arguments.4)
  br label %B634051

B634051:                                          ; preds = %B1181, %B634049
  %lsr.iv.next = add i64 %lsr.iv, -1
  %scevgep169 = getelementptr i8, ptr %lsr.iv168, i64 16
  %scevgep175 = getelementptr i8, ptr %lsr.iv174, i64 80
  %scevgep179 = getelementptr i8, ptr %lsr.iv178, i64 %16
  %.2163 = add i64 %.215614461451, 1
  %.2150 = icmp sgt i64 %lsr.iv.next, 1
  br i1 %.2150, label %B1146.if, label %B634423

common.ret:                                       ; preds = %B1181.endif.endif.if, %B634423
  %common.ret.op = phi i32 [ 0, %B634423 ], [ %.2443, %B1181.endif.endif.if ]
  ret i32 %common.ret.op

B634423:                                          ; preds = %B634051, %B876, %B956
  store ptr null, ptr %retptr, align 8
  br label %common.ret

B908.if:                                          ; preds = %B908.if, %B908.if.preheader
  %lsr.iv184 = phi i64 [ 7, %B908.if.preheader ], [ %lsr.iv.next185, %B908.if ]
  %lsr.iv180 = phi i64 [ %3, %B908.if.preheader ], [ %lsr.iv.next181, %B908.if ]
  %.190914361438 = phi i64 [ %arg.start, %B908.if.preheader ], [ %.1916, %B908.if ]
  %.1916 = add i64 %.190914361438, 1
  %.1976 = load i64, ptr %.1655, align 8
  %22 = add i64 %.1976, %lsr.iv184
  %.1991 = icmp slt i64 %22, 0
  %.1992 = select i1 %.1991, i64 %.1593.fca.5.0.load, i64 0
  %23 = getelementptr double, ptr %.1593.fca.4.load, i64 %22
  %.2006 = getelementptr double, ptr %23, i64 %.1992
  %.2007 = load double, ptr %.2006, align 8
  %.2015.le = tail call contract double @llvm.exp.f64(double %.2007)
  %.2033 = icmp slt i64 %.190914361438, 0
  %24 = select i1 %.2033, i64 %4, i64 0
  %scevgep182 = getelementptr i8, ptr %5, i64 %24
  %25 = shl i64 %.190914361438, 3
  %scevgep183 = getelementptr i8, ptr %scevgep182, i64 %25
  store double %.2015.le, ptr %scevgep183, align 8
  %lsr.iv.next181 = add i64 %lsr.iv180, -1
  %reass.sub1 = sub i64 %lsr.iv184, %.1665.1
  %lsr.iv.next185 = add i64 %reass.sub1, 8
  %.1903 = icmp sgt i64 %lsr.iv.next181, 1
  br i1 %.1903, label %B908.if, label %B1146.if.preheader

B1146.if:                                         ; preds = %B634051, %B1146.if.preheader
  %lsr.iv178 = phi ptr [ %.1059, %B1146.if.preheader ], [ %scevgep179, %B634051 ]
  %lsr.iv174 = phi ptr [ %scevgep173, %B1146.if.preheader ], [ %scevgep175, %B634051 ]
  %lsr.iv168 = phi ptr [ %scevgep, %B1146.if.preheader ], [ %scevgep169, %B634051 ]
  %lsr.iv = phi i64 [ %6, %B1146.if.preheader ], [ %lsr.iv.next, %B634051 ]
  %.215614461451 = phi i64 [ %arg.start, %B1146.if.preheader ], [ %.2163, %B634051 ]
  %.2205 = icmp slt i64 %.215614461451, 0
  %.2206 = select i1 %.2205, i64 %arg.status.5.0, i64 0
  %scevgep176 = getelementptr i8, ptr %arg.status.4, i64 %.2206
  %scevgep177 = getelementptr i8, ptr %scevgep176, i64 %.215614461451
  %.2221 = load i8, ptr %scevgep177, align 1
  %.2223 = icmp eq i8 %.2221, 0
  br i1 %.2223, label %B1181, label %B634049

B1181.endif.endif.if:                             ; preds = %B1181
  %.2444 = load ptr, ptr %excinfo.16, align 8
  store ptr %.2444, ptr %excinfo, align 8
  br label %common.ret
}

; Function Attrs: mustprogress nofree noinline norecurse nosync nounwind willreturn memory(argmem: readwrite)
define internal fastcc void @inner_3(ptr noalias nonnull writeonly captures(none) initializes((0, 8)) %retptr, ptr readonly captures(none) %arg.row.4, double %arg.first, double %arg.last, ptr readonly captures(none) %arg.limits.4, ptr readonly captures(none) %arg.band.4, i64 %arg.policy, double %arg.least) unnamed_addr #5 {
entry:
  %.213 = load double, ptr %arg.row.4, align 8
  %.221.le = fsub contract double %.213, %.213
  %.222.le = fcmp contract ord double %.221.le, 0.000000e+00
  br i1 %.222.le, label %B132, label %common.ret

common.ret:                                       ; preds = %B230, %entry, %B132, %B132.1, %B132.2, %B132.3, %B132.4, %B132.5, %B132.6, %B132.7, %B132.8, %B758
  %..sink = phi i64 [ %., %B758 ], [ 1, %entry ], [ 1, %B132.8 ], [ 1, %B132.7 ], [ 1, %B132.6 ], [ 1, %B132.5 ], [ 1, %B132.4 ], [ 1, %B132.3 ], [ 1, %B132.2 ], [ 1, %B132.1 ], [ 1, %B132 ], [ 2, %B230 ]
  store i64 %..sink, ptr %retptr, align 8
  ret void

B132:                                             ; preds = %entry
  %0 = getelementptr i8, ptr %arg.row.4, i64 8
  %.213.1 = load double, ptr %0, align 8
  %.221.le.1 = fsub contract double %.213.1, %.213.1
  %.222.le.1 = fcmp contract ord double %.221.le.1, 0.000000e+00
  br i1 %.222.le.1, label %B132.1, label %common.ret

B132.1:                                           ; preds = %B132
  %1 = getelementptr i8, ptr %arg.row.4, i64 16
  %.213.2 = load double, ptr %1, align 8
  %.221.le.2 = fsub contract double %.213.2, %.213.2
  %.222.le.2 = fcmp contract ord double %.221.le.2, 0.000000e+00
  br i1 %.222.le.2, label %B132.2, label %common.ret

B132.2:                                           ; preds = %B132.1
  %2 = getelementptr i8, ptr %arg.row.4, i64 24
  %.213.3 = load double, ptr %2, align 8
  %.221.le.3 = fsub contract double %.213.3, %.213.3
  %.222.le.3 = fcmp contract ord double %.221.le.3, 0.000000e+00
  br i1 %.222.le.3, label %B132.3, label %common.ret

B132.3:                                           ; preds = %B132.2
  %3 = getelementptr i8, ptr %arg.row.4, i64 32
  %.213.4 = load double, ptr %3, align 8
  %.221.le.4 = fsub contract double %.213.4, %.213.4
  %.222.le.4 = fcmp contract ord double %.221.le.4, 0.000000e+00
  br i1 %.222.le.4, label %B132.4, label %common.ret

B132.4:                                           ; preds = %B132.3
  %4 = getelementptr i8, ptr %arg.row.4, i64 40
  %.213.5 = load double, ptr %4, align 8
  %.221.le.5 = fsub contract double %.213.5, %.213.5
  %.222.le.5 = fcmp contract ord double %.221.le.5, 0.000000e+00
  br i1 %.222.le.5, label %B132.5, label %common.ret

B132.5:                                           ; preds = %B132.4
  %5 = getelementptr i8, ptr %arg.row.4, i64 48
  %.213.6 = load double, ptr %5, align 8
  %.221.le.6 = fsub contract double %.213.6, %.213.6
  %.222.le.6 = fcmp contract ord double %.221.le.6, 0.000000e+00
  br i1 %.222.le.6, label %B132.6, label %common.ret

B132.6:                                           ; preds = %B132.5
  %6 = getelementptr i8, ptr %arg.row.4, i64 56
  %.213.7 = load double, ptr %6, align 8
  %.221.le.7 = fsub contract double %.213.7, %.213.7
  %.222.le.7 = fcmp contract ord double %.221.le.7, 0.000000e+00
  br i1 %.222.le.7, label %B132.7, label %common.ret

B132.7:                                           ; preds = %B132.6
  %7 = getelementptr i8, ptr %arg.row.4, i64 64
  %.213.8 = load double, ptr %7, align 8
  %.221.le.8 = fsub contract double %.213.8, %.213.8
  %.222.le.8 = fcmp contract ord double %.221.le.8, 0.000000e+00
  br i1 %.222.le.8, label %B132.8, label %common.ret

B132.8:                                           ; preds = %B132.7
  %8 = getelementptr i8, ptr %arg.row.4, i64 72
  %.213.9 = load double, ptr %8, align 8
  %.221.le.9 = fsub contract double %.213.9, %.213.9
  %.222.le.9 = fcmp contract ord double %.221.le.9, 0.000000e+00
  br i1 %.222.le.9, label %B230, label %common.ret

B230:                                             ; preds = %B132.8
  %.329 = load double, ptr %arg.limits.4, align 8
  %.330 = fcmp contract oge double %.213, %.329
  %9 = getelementptr i8, ptr %arg.limits.4, i64 80
  %.395 = load double, ptr %9, align 8
  %.396 = fcmp contract ole double %.213, %.395
  %.397 = and i1 %.330, %.396
  %10 = getelementptr i8, ptr %arg.limits.4, i64 8
  %.329.1 = load double, ptr %10, align 8
  %.330.1 = fcmp contract oge double %.213.1, %.329.1
  %11 = getelementptr i8, ptr %arg.limits.4, i64 88
  %.395.1 = load double, ptr %11, align 8
  %.396.1 = fcmp contract ole double %.213.1, %.395.1
  %.397.1 = and i1 %.330.1, %.396.1
  %.399.1 = and i1 %.397, %.397.1
  %12 = getelementptr i8, ptr %arg.limits.4, i64 16
  %.329.2 = load double, ptr %12, align 8
  %.330.2 = fcmp contract oge double %.213.2, %.329.2
  %13 = getelementptr i8, ptr %arg.limits.4, i64 96
  %.395.2 = load double, ptr %13, align 8
  %.396.2 = fcmp contract ole double %.213.2, %.395.2
  %.397.2 = and i1 %.330.2, %.396.2
  %.399.2 = and i1 %.399.1, %.397.2
  %14 = getelementptr i8, ptr %arg.limits.4, i64 24
  %.329.3 = load double, ptr %14, align 8
  %.330.3 = fcmp contract oge double %.213.3, %.329.3
  %15 = getelementptr i8, ptr %arg.limits.4, i64 104
  %.395.3 = load double, ptr %15, align 8
  %.396.3 = fcmp contract ole double %.213.3, %.395.3
  %.397.3 = and i1 %.330.3, %.396.3
  %.399.3 = and i1 %.399.2, %.397.3
  %16 = getelementptr i8, ptr %arg.limits.4, i64 32
  %.329.4 = load double, ptr %16, align 8
  %.330.4 = fcmp contract oge double %.213.4, %.329.4
  %17 = getelementptr i8, ptr %arg.limits.4, i64 112
  %.395.4 = load double, ptr %17, align 8
  %.396.4 = fcmp contract ole double %.213.4, %.395.4
  %.397.4 = and i1 %.330.4, %.396.4
  %.399.4 = and i1 %.399.3, %.397.4
  %18 = getelementptr i8, ptr %arg.limits.4, i64 40
  %.329.5 = load double, ptr %18, align 8
  %.330.5 = fcmp contract oge double %.213.5, %.329.5
  %19 = getelementptr i8, ptr %arg.limits.4, i64 120
  %.395.5 = load double, ptr %19, align 8
  %.396.5 = fcmp contract ole double %.213.5, %.395.5
  %.397.5 = and i1 %.330.5, %.396.5
  %.399.5 = and i1 %.399.4, %.397.5
  %20 = getelementptr i8, ptr %arg.limits.4, i64 48
  %.329.6 = load double, ptr %20, align 8
  %.330.6 = fcmp contract oge double %.213.6, %.329.6
  %21 = getelementptr i8, ptr %arg.limits.4, i64 128
  %.395.6 = load double, ptr %21, align 8
  %.396.6 = fcmp contract ole double %.213.6, %.395.6
  %.397.6 = and i1 %.330.6, %.396.6
  %.399.6 = and i1 %.399.5, %.397.6
  %22 = getelementptr i8, ptr %arg.limits.4, i64 56
  %.329.7 = load double, ptr %22, align 8
  %.330.7 = fcmp contract oge double %.213.7, %.329.7
  %23 = getelementptr i8, ptr %arg.limits.4, i64 136
  %.395.7 = load double, ptr %23, align 8
  %.396.7 = fcmp contract ole double %.213.7, %.395.7
  %.397.7 = and i1 %.330.7, %.396.7
  %.399.7 = and i1 %.399.6, %.397.7
  %24 = getelementptr i8, ptr %arg.limits.4, i64 64
  %.329.8 = load double, ptr %24, align 8
  %.330.8 = fcmp contract oge double %.213.8, %.329.8
  %25 = getelementptr i8, ptr %arg.limits.4, i64 144
  %.395.8 = load double, ptr %25, align 8
  %.396.8 = fcmp contract ole double %.213.8, %.395.8
  %.397.8 = and i1 %.330.8, %.396.8
  %.399.8 = and i1 %.399.7, %.397.8
  %26 = getelementptr i8, ptr %arg.limits.4, i64 72
  %.329.9 = load double, ptr %26, align 8
  %.330.9 = fcmp contract oge double %.213.9, %.329.9
  %27 = getelementptr i8, ptr %arg.limits.4, i64 152
  %.395.9 = load double, ptr %27, align 8
  %.396.9 = fcmp contract ole double %.213.9, %.395.9
  %.397.9 = and i1 %.330.9, %.396.9
  %.399.9 = and i1 %.399.8, %.397.9
  %.442 = fcmp contract ogt double %.213.5, 0.000000e+00
  %.477 = tail call contract double @llvm.fabs.f64(double %.213.8)
  %.480 = fmul contract double %arg.last, 0x401921FB54442D18
  %.511 = tail call contract double @llvm.fabs.f64(double %.213.9)
  %.512 = fmul contract double %.480, %.511
  %.513 = fadd contract double %.477, %.512
  %.514 = fcmp contract ole double %.513, 1.000000e+14
  %28 = and i1 %.442, %.514
  %.515 = and i1 %28, %.399.9
  br i1 %.515, label %B496, label %common.ret

B496:                                             ; preds = %B230
  %.572 = fmul contract double %.213.7, 0x3ED4A8B4A9ED04E3
  %.578 = fmul contract double %arg.first, %.572
  %.580 = fcmp olt double %.578, %arg.least
  %.591 = and i64 %arg.policy, 2
  %.592.not = icmp eq i64 %.591, 0
  br i1 %.592.not, label %B662, label %B604

B604:                                             ; preds = %B496
  %.596 = fmul contract double %arg.last, %.572
  %.627 = getelementptr i8, ptr %arg.band.4, i64 8
  %.628 = load double, ptr %.627, align 8
  %.630 = fmul contract double %.628, 0x3FF000000044B830
  %.631 = fcmp contract ogt double %.596, %.630
  %.633 = or i1 %.580, %.631
  br label %B662

B662:                                             ; preds = %B604, %B496
  %outside.3.0 = phi i1 [ %.633, %B604 ], [ %.580, %B496 ]
  %.648 = and i64 %arg.policy, 1
  %.651.not = icmp eq i64 %.648, 0
  br i1 %.651.not, label %B758, label %B700

B700:                                             ; preds = %B662
  %.688 = getelementptr i8, ptr %arg.band.4, i64 24
  %.689 = load double, ptr %.688, align 8
  %.696 = fmul contract double %.689, 0x3FEFFFFFFF768FA1
  %.697 = fcmp contract olt double %.578, %.696
  %.699 = or i1 %outside.3.0, %.697
  br label %B758

B758:                                             ; preds = %B700, %B662
  %outside.4.0 = phi i1 [ %.699, %B700 ], [ %outside.3.0, %B662 ]
  %. = select i1 %outside.4.0, i64 3, i64 0
  br label %common.ret
}

; Function Attrs: mustprogress nocallback nocreateundeforpoison nofree nosync nounwind speculatable willreturn memory(none)
declare i64 @llvm.smin.i64(i64, i64) #3

; Function Attrs: mustprogress nocallback nocreateundeforpoison nofree nosync nounwind speculatable willreturn memory(none)
declare double @llvm.fabs.f64(double) #3

; Function Attrs: nofree noinline norecurse nosync nounwind memory(argmem: readwrite)
define internal fastcc void @inner_4(ptr noalias nonnull writeonly captures(none) %retptr, ptr readonly captures(none) %arg.parameters.4, ptr readonly captures(none) %arg.contents.4, ptr readonly captures(none) %arg.scaling.4, ptr captures(none) initializes((0, 40)) %arg.scratch.4, ptr writeonly captures(none) %arg.out.4) unnamed_addr #6 {
entry:
  %.271 = load i64, ptr %arg.contents.4, align 8
  %.303 = getelementptr i8, ptr %arg.scaling.4, i64 80
  %.304 = load double, ptr %.303, align 8
  %scevgep = getelementptr i8, ptr %arg.out.4, i64 256
  %sunkaddr48 = getelementptr i8, ptr %arg.scaling.4, i64 40
  %sunkaddr51 = getelementptr i8, ptr %arg.scratch.4, i64 8
  %sunkaddr52 = getelementptr i8, ptr %arg.scaling.4, i64 8
  %sunkaddr53 = getelementptr i8, ptr %arg.scaling.4, i64 48
  %sunkaddr56 = getelementptr i8, ptr %arg.scratch.4, i64 16
  %sunkaddr57 = getelementptr i8, ptr %arg.scaling.4, i64 16
  %sunkaddr58 = getelementptr i8, ptr %arg.scaling.4, i64 56
  %sunkaddr61 = getelementptr i8, ptr %arg.scratch.4, i64 24
  %sunkaddr62 = getelementptr i8, ptr %arg.scaling.4, i64 24
  %sunkaddr63 = getelementptr i8, ptr %arg.scaling.4, i64 64
  %sunkaddr66 = getelementptr i8, ptr %arg.scratch.4, i64 32
  %sunkaddr67 = getelementptr i8, ptr %arg.scaling.4, i64 32
  %sunkaddr68 = getelementptr i8, ptr %arg.scaling.4, i64 72
  %sunkaddr21 = getelementptr i8, ptr %arg.scratch.4, i64 8
  %sunkaddr24 = getelementptr i8, ptr %arg.scratch.4, i64 16
  %sunkaddr29 = getelementptr i8, ptr %arg.scratch.4, i64 24
  %sunkaddr32 = getelementptr i8, ptr %arg.scratch.4, i64 32
  %sunkaddr7 = getelementptr i8, ptr %arg.scratch.4, i64 8
  %sunkaddr10 = getelementptr i8, ptr %arg.scratch.4, i64 16
  %sunkaddr13 = getelementptr i8, ptr %arg.scratch.4, i64 24
  %sunkaddr16 = getelementptr i8, ptr %arg.scratch.4, i64 32
  %sunkaddr37 = getelementptr i8, ptr %arg.scratch.4, i64 8
  %sunkaddr40 = getelementptr i8, ptr %arg.scratch.4, i64 16
  %sunkaddr43 = getelementptr i8, ptr %arg.scratch.4, i64 24
  %sunkaddr46 = getelementptr i8, ptr %arg.scratch.4, i64 32
  br label %B118.if

B270:                                             ; preds = %B118.if
  %.38.le.i = tail call contract double @llvm.log.f64(double %.1045)
  %.21.i = fadd contract double %.1045, 1.000000e+00
  %.30.i = fdiv contract double 1.000000e+00, %.21.i
  %.25.i = fdiv contract double %.1045, %.21.i
  store double %.38.le.i, ptr %arg.scratch.4, align 8, !noalias !6
  %.72.i = tail call contract double @llvm.pow.f64(double %.13.i, double 4.000000e-01)
  %.73.i = fmul contract double %.72.i, %.25.i
  store double %.73.i, ptr %sunkaddr7, align 8, !noalias !6
  %.103.i = tail call contract double @llvm.pow.f64(double %.13.i13, double 4.000000e-01)
  %.104.i = fmul contract double %.103.i, %.30.i
  store double %.104.i, ptr %sunkaddr10, align 8, !noalias !6
  %.134.i = fmul contract double %.1075, %.25.i
  %.135.i = fmul contract double %.30.i, %.1105
  %.136.i = fadd contract double %.134.i, %.135.i
  %.137.i = fmul contract double %.25.i, 0x3FD585A9E9585A9F
  %.138.i = fmul contract double %.30.i, %.137.i
  %.139.i = fadd contract double %.1075, %.1105
  %.140.i = fmul contract double %.139.i, %.138.i
  %.141.i = fsub contract double %.136.i, %.140.i
  store double %.141.i, ptr %sunkaddr13, align 8, !noalias !6
  %.171.i = fsub contract double %.1075, %.1105
  %.172.i = fmul contract double %.171.i, 5.000000e-01
  store double %.172.i, ptr %sunkaddr16, align 8, !noalias !6
  br label %B570.if

B370:                                             ; preds = %B118.if
  %.38.le.i.i = tail call contract double @llvm.log.f64(double %.1045)
  %.21.i.i = fadd contract double %.1045, 1.000000e+00
  %.30.i.i = fdiv contract double 1.000000e+00, %.21.i.i
  %.25.i.i = fdiv contract double %.1045, %.21.i.i
  store double %.38.le.i.i, ptr %arg.scratch.4, align 8, !noalias !9
  %.72.i.i = tail call contract double @llvm.pow.f64(double %.13.i, double 4.000000e-01)
  %.73.i.i = fmul contract double %.72.i.i, %.25.i.i
  store double %.73.i.i, ptr %sunkaddr21, align 8, !noalias !9
  %.103.i.i = tail call contract double @llvm.pow.f64(double %.13.i13, double 4.000000e-01)
  %.104.i.i = fmul contract double %.103.i.i, %.30.i.i
  store double %.104.i.i, ptr %sunkaddr24, align 8, !noalias !9
  %.134.i.i = fmul contract double %.1075, %.25.i.i
  %.135.i.i = fmul contract double %.30.i.i, %.1105
  %.136.i.i = fadd contract double %.134.i.i, %.135.i.i
  %.137.i.i = fmul contract double %.25.i.i, 0x3FD585A9E9585A9F
  %.138.i.i = fmul contract double %.30.i.i, %.137.i.i
  %.139.i.i = fadd contract double %.1075, %.1105
  %.140.i.i = fmul contract double %.139.i.i, %.138.i.i
  %.141.i.i = fsub contract double %.136.i.i, %.140.i.i
  store double %.141.i.i, ptr %sunkaddr29, align 8, !noalias !9
  %.171.i.i = fsub contract double %.1075, %.1105
  %.172.i.i = fmul contract double %.171.i.i, 5.000000e-01
  store double %.172.i.i, ptr %sunkaddr32, align 8, !noalias !9
  %.107.i = fsub contract double %.73.i.i, %.104.i.i
  %.166.i = fadd contract double %.73.i.i, %.104.i.i
  store double %.107.i, ptr %sunkaddr21, align 8, !noalias !14
  store double %.166.i, ptr %sunkaddr24, align 8, !noalias !14
  br label %B570.if

B448:                                             ; preds = %B118.if
  store double %.1045, ptr %arg.scratch.4, align 8
  store double %.1075, ptr %sunkaddr37, align 8
  store double %.1105, ptr %sunkaddr40, align 8
  store double %.13.i, ptr %sunkaddr43, align 8
  store double %.13.i13, ptr %sunkaddr46, align 8
  br label %B570.if

B666:                                             ; preds = %B570.if
  store ptr null, ptr %retptr, align 8
  ret void

B118.if:                                          ; preds = %B570.if, %entry
  %lsr.iv19 = phi i64 [ 0, %entry ], [ %lsr.iv.next, %B570.if ]
  %lsr.iv = phi ptr [ %scevgep, %entry ], [ %scevgep14, %B570.if ]
  %.590 = getelementptr double, ptr %arg.parameters.4, i64 %lsr.iv19
  %.656 = getelementptr i8, ptr %.590, i64 24
  %.657 = load double, ptr %.656, align 8
  %.12.i = fcmp contract ogt double %.304, %.657
  %.13.i = select i1 %.12.i, double %.304, double %.657
  %.715 = getelementptr i8, ptr %.590, i64 32
  %.716 = load double, ptr %.715, align 8
  %.12.i12 = fcmp contract ogt double %.304, %.716
  %.13.i13 = select i1 %.12.i12, double %.304, double %.716
  %.1045 = load double, ptr %.590, align 8
  %.1074 = getelementptr i8, ptr %.590, i64 8
  %.1075 = load double, ptr %.1074, align 8
  %.1104 = getelementptr i8, ptr %.590, i64 16
  %.1105 = load double, ptr %.1104, align 8
  switch i64 %.271, label %B448 [
    i64 1, label %B270
    i64 2, label %B370
  ]

B570.if:                                          ; preds = %B448, %B370, %B270
  %.1444 = load double, ptr %arg.scratch.4, align 8
  %.1474 = load double, ptr %arg.scaling.4, align 8
  %.1475 = fsub contract double %.1444, %.1474
  %.1506 = load double, ptr %sunkaddr48, align 8
  %.1507 = fmul contract double %.1475, %.1506
  %scevgep18 = getelementptr i8, ptr %lsr.iv, i64 -256
  store double %.1507, ptr %scevgep18, align 8
  %.1444.1 = load double, ptr %sunkaddr51, align 8
  %.1474.1 = load double, ptr %sunkaddr52, align 8
  %.1475.1 = fsub contract double %.1444.1, %.1474.1
  %.1506.1 = load double, ptr %sunkaddr53, align 8
  %.1507.1 = fmul contract double %.1475.1, %.1506.1
  %scevgep17 = getelementptr i8, ptr %lsr.iv, i64 -192
  store double %.1507.1, ptr %scevgep17, align 8
  %.1444.2 = load double, ptr %sunkaddr56, align 8
  %.1474.2 = load double, ptr %sunkaddr57, align 8
  %.1475.2 = fsub contract double %.1444.2, %.1474.2
  %.1506.2 = load double, ptr %sunkaddr58, align 8
  %.1507.2 = fmul contract double %.1475.2, %.1506.2
  %scevgep16 = getelementptr i8, ptr %lsr.iv, i64 -128
  store double %.1507.2, ptr %scevgep16, align 8
  %.1444.3 = load double, ptr %sunkaddr61, align 8
  %.1474.3 = load double, ptr %sunkaddr62, align 8
  %.1475.3 = fsub contract double %.1444.3, %.1474.3
  %.1506.3 = load double, ptr %sunkaddr63, align 8
  %.1507.3 = fmul contract double %.1475.3, %.1506.3
  %scevgep15 = getelementptr i8, ptr %lsr.iv, i64 -64
  store double %.1507.3, ptr %scevgep15, align 8
  %.1444.4 = load double, ptr %sunkaddr66, align 8
  %.1474.4 = load double, ptr %sunkaddr67, align 8
  %.1475.4 = fsub contract double %.1444.4, %.1474.4
  %.1506.4 = load double, ptr %sunkaddr68, align 8
  %.1507.4 = fmul contract double %.1475.4, %.1506.4
  store double %.1507.4, ptr %lsr.iv, align 8
  %scevgep14 = getelementptr i8, ptr %lsr.iv, i64 8
  %lsr.iv.next = add nuw nsw i64 %lsr.iv19, 5
  %exitcond.not = icmp eq i64 %lsr.iv.next, 40
  br i1 %exitcond.not, label %B666, label %B118.if
}

; Function Attrs: nofree noinline norecurse nosync nounwind memory(readwrite, inaccessiblemem: none, target_mem0: none, target_mem1: none)
define internal fastcc noundef range(i32 0, 2) i32 @inner_9(ptr noalias nonnull writeonly captures(none) %retptr, ptr noalias nonnull writeonly captures(none) %excinfo, i64 %arg.i, ptr readonly captures(none) %arg.row.4, ptr readonly captures(none) %arg.linear.4, i64 range(i64 8, 0) %arg.linear.5.0, ptr readonly captures(none) %arg.arguments.4, ptr readonly captures(none) %arg.contents.4, ptr readonly captures(none) %arg.weights.4, ptr %arg.scratch.4, double %arg.plus, double %arg.cross) unnamed_addr #4 {
entry:
  %.3844 = alloca i64, align 8
  store i64 0, ptr %.3844, align 8
  %.3999 = alloca i64, align 8
  store i64 0, ptr %.3999, align 8
  %.4120 = alloca i64, align 8
  store i64 0, ptr %.4120, align 8
  %.4279 = alloca i64, align 8
  store i64 0, ptr %.4279, align 8
  %.4970 = alloca ptr, align 8
  store ptr null, ptr %.4970, align 8
  %excinfo.34 = alloca ptr, align 8
  store ptr null, ptr %excinfo.34, align 8
  %.5198 = alloca double, align 8
  store double 0.000000e+00, ptr %.5198, align 8
  %excinfo.36 = alloca ptr, align 8
  store ptr null, ptr %excinfo.36, align 8
  %.7481 = alloca ptr, align 8
  store ptr null, ptr %.7481, align 8
  %.8479 = alloca ptr, align 8
  store ptr null, ptr %.8479, align 8
  %.125 = getelementptr i8, ptr %arg.arguments.4, i64 16
  %.126 = load i64, ptr %.125, align 8
  %.155 = getelementptr i8, ptr %arg.arguments.4, i64 32
  %.156 = load i64, ptr %.155, align 8
  %.185 = getelementptr i8, ptr %arg.arguments.4, i64 88
  %.186 = load i64, ptr %.185, align 8
  %.295 = getelementptr i8, ptr %arg.arguments.4, i64 40
  %.296 = load i64, ptr %.295, align 8
  %.332 = getelementptr i8, ptr %arg.arguments.4, i64 24
  %.333 = load i64, ptr %.332, align 8
  %.335 = inttoptr i64 %.333 to ptr
  %.402 = getelementptr double, ptr %.335, i64 %.156
  %.460 = icmp sgt i64 %.296, 0
  br i1 %.460, label %B900, label %B984

B900:                                             ; preds = %entry
  %0 = getelementptr double, ptr %.402, i64 %.126
  %.471 = getelementptr i8, ptr %0, i64 -8
  %.472 = load double, ptr %.471, align 8
  %.481 = load double, ptr %.402, align 8
  %.482 = fsub contract double %.472, %.481
  %.484 = uitofp nneg i64 %.296 to double
  %.488 = fdiv contract double %.484, %.482
  br label %B984

B984:                                             ; preds = %B900, %entry
  %prepared_grid_v501__vphi308_0.2.0 = phi double [ %.488, %B900 ], [ 0.000000e+00, %entry ]
  %.528 = getelementptr i8, ptr %arg.arguments.4, i64 48
  %.529 = load i64, ptr %.528, align 8
  %.770 = getelementptr i8, ptr %arg.contents.4, i64 56
  %.771 = load i64, ptr %.770, align 8
  %.772 = sub i64 0, %.771
  %.780.1 = and i64 %.772, -8
  %.814 = sub i64 0, %.780.1
  %.844 = getelementptr i8, ptr %arg.contents.4, i64 64
  %.845 = load i64, ptr %.844, align 8
  %.846 = sub i64 0, %.845
  %.854.1 = and i64 %.846, -8
  %.888 = sub i64 0, %.854.1
  %.929 = getelementptr i8, ptr %arg.contents.4, i64 144
  %.930 = load i64, ptr %.929, align 8
  %.931 = sub i64 0, %.930
  %.939.1 = and i64 %.931, -8
  %.973 = sub i64 0, %.939.1
  %.1002 = getelementptr i8, ptr %arg.contents.4, i64 72
  %.1003 = load i64, ptr %.1002, align 8
  %1 = add i64 %.780.1, %.854.1
  %.1019 = sub i64 0, %1
  %.1031.idx = shl nsw i64 %.1019, 4
  %.1031 = getelementptr inbounds i8, ptr %arg.linear.4, i64 %.1031.idx
  %.1111 = load double, ptr %arg.linear.4, align 8
  %.1113 = shl nsw i64 %.814, 1
  %.1127 = icmp slt i64 %.814, 0
  %.1128 = select i1 %.1127, i64 %arg.linear.5.0, i64 0
  %2 = getelementptr double, ptr %arg.linear.4, i64 %.1113
  %.1142 = getelementptr double, ptr %2, i64 %.1128
  %.1143 = load double, ptr %.1142, align 8
  %.1181 = shl nsw i64 %.1019, 2
  %.1182 = add nsw i64 %.1181, 40
  %.1183 = sub i64 %.1182, %.780.1
  %.1184 = sub i64 %.1183, %.854.1
  %.1188 = add nsw i64 %.1184, 4144
  %.1189 = sub i64 %.1188, %.939.1
  %.1262 = getelementptr i8, ptr %arg.scratch.4, i64 320
  %.idx2 = shl i64 %.814, 5
  %3 = getelementptr i8, ptr %arg.scratch.4, i64 %.idx2
  %.1326 = getelementptr i8, ptr %3, i64 320
  %.1403 = getelementptr inbounds double, ptr %arg.scratch.4, i64 %.1182
  %.1466 = getelementptr inbounds double, ptr %arg.scratch.4, i64 %.1183
  %.1529 = getelementptr inbounds double, ptr %arg.scratch.4, i64 %.1188
  %.1615 = getelementptr double, ptr %arg.scratch.4, i64 %.1184
  %.1740 = getelementptr i8, ptr %.1615, i64 16512
  %.1803 = getelementptr i8, ptr %.1615, i64 24768
  %.1897 = getelementptr i8, ptr %.1615, i64 33024
  %.1959 = getelementptr double, ptr %arg.scratch.4, i64 %.1189
  %.2023.idx = shl i64 %.973, 6
  %.2023 = getelementptr i8, ptr %.1959, i64 %.2023.idx
  %.2106.idx = shl i64 %.973, 7
  %.2106 = getelementptr i8, ptr %.1959, i64 %.2106.idx
  %.2996 = getelementptr i8, ptr %arg.contents.4, i64 112
  %.2997 = load i64, ptr %.2996, align 8
  %.3007 = getelementptr double, ptr %arg.weights.4, i64 %.2997
  %.3086 = getelementptr i8, ptr %arg.contents.4, i64 120
  %.3087 = load i64, ptr %.3086, align 8
  %.3100 = getelementptr double, ptr %arg.weights.4, i64 %.3087
  %.99.i = select i1 %.1127, i64 1073741824, i64 0
  %.100.i = sub i64 %.99.i, %.780.1
  %4 = tail call i64 @llvm.smax.i64(i64 %.100.i, i64 0)
  %.88.sroa.0.3.i = tail call i64 @llvm.smin.i64(i64 %4, i64 1073741824)
  %.201.i399 = getelementptr double, ptr %.3007, i64 %.88.sroa.0.3.i
  %.272.i = add i64 %.99.i, %.1113
  %5 = tail call i64 @llvm.smax.i64(i64 %.272.i, i64 0)
  %.260.sroa.0.3.i = tail call i64 @llvm.smin.i64(i64 %5, i64 1073741824)
  %.373.i = getelementptr double, ptr %.3007, i64 %.260.sroa.0.3.i
  %6 = add i64 %.771, 6
  %.486.i = lshr i64 %6, 3
  %.463.inv.i = icmp slt i64 %.771, 2
  %.507321.not325.i = icmp eq i64 %.486.i, 0
  %.507321.not.i = or i1 %.463.inv.i, %.507321.not325.i
  br i1 %.507321.not.i, label %B984.endif.endif.endif.en...endif.3.endif.endif, label %B94.if.lr.ph.i

B1246:                                            ; preds = %_ZN17bnserve_surrogate6kernel7_points10fill_cellsB4v158B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedExx5ArrayIdLi1E1C7mutable7alignedE.exit479
  %.4496 = getelementptr i8, ptr %arg.arguments.4, i64 112
  %.4497 = load i64, ptr %.4496, align 8
  %.4498.not = icmp eq i64 %.4497, 4
  %.4537 = getelementptr i8, ptr %arg.contents.4, i64 152
  %.4538 = load i64, ptr %.4537, align 8
  %.4549 = getelementptr inbounds double, ptr %arg.weights.4, i64 %.4538
  br i1 %.4498.not, label %B1390, label %B1258

B1258:                                            ; preds = %B1246
  store ptr null, ptr %.4970, align 8
  %.4996 = call fastcc i32 @inner_10(ptr nonnull %.4970, ptr nonnull %excinfo.34, ptr %arg.row.4, ptr nonnull %arg.linear.4, ptr %arg.contents.4, ptr %arg.weights.4, i64 %.186, ptr nonnull %.1262, ptr %.1326, i64 %.814, ptr %arg.scratch.4, ptr %.2106, ptr %.1959, ptr %.2023, i64 0, i64 %.4457)
  %cond = icmp eq i32 %.4996, 0
  br i1 %cond, label %B1258.endif, label %B1258.if, !prof !0

B1390:                                            ; preds = %B1246, %B1246.thread, %_ZN17bnserve_surrogate6kernel7_places9find_endsB4v532B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5TupleI5ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedExdE5ArrayIdLi1E1C7mutable7alignedExdx5ArrayIxLi1E1C7mutable7alignedE.exit
  %.454917 = phi ptr [ %.4549, %_ZN17bnserve_surrogate6kernel7_places9find_endsB4v532B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5TupleI5ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedExdE5ArrayIdLi1E1C7mutable7alignedExdx5ArrayIxLi1E1C7mutable7alignedE.exit ], [ %.454912, %B1246.thread ], [ %.4549, %B1246 ]
  %"$phi984.0.3.014" = phi i1 [ true, %_ZN17bnserve_surrogate6kernel7_places9find_endsB4v532B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5TupleI5ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedExdE5ArrayIdLi1E1C7mutable7alignedExdx5ArrayIxLi1E1C7mutable7alignedE.exit ], [ false, %B1246.thread ], [ false, %B1246 ]
  store double 0.000000e+00, ptr %.5198, align 8
  %.5212 = call fastcc i32 @inner_11(ptr nonnull %.5198, ptr nonnull %excinfo.36, ptr %arg.row.4, double %.3595, ptr nonnull %.3653, ptr nonnull %.1031, i64 %.186, ptr %.1615, ptr %arg.scratch.4)
  %.5222 = load double, ptr %.5198, align 8
  %cond1 = icmp eq i32 %.5212, 0
  br i1 %cond1, label %B1390.endif, label %B1390.if, !prof !0

B1448:                                            ; preds = %_ZN17bnserve_surrogate6kernel7_places9find_endsB4v532B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5TupleI5ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedExdE5ArrayIdLi1E1C7mutable7alignedExdx5ArrayIxLi1E1C7mutable7alignedE.exit541
  %.5634 = load i64, ptr %.770, align 8
  %.135.i542 = load double, ptr %.402, align 8, !noalias !15
  %.143.i543 = add nsw i64 %.5634, -2
  %.181.i544 = icmp slt i64 %.5634, 3
  %..143.i545 = select i1 %.181.i544, i64 0, i64 %.143.i543
  %.225207.i546 = icmp sgt i64 %..143.i545, 0
  br i1 %.225207.i546, label %B92.if.preheader.i550, label %_ZN17bnserve_surrogate6kernel7_places9find_endsB4v532B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5TupleI5ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedExdE5ArrayIdLi1E1C7mutable7alignedExdx5ArrayIxLi1E1C7mutable7alignedE.exit585

B1636:                                            ; preds = %_ZN17bnserve_surrogate6kernel7_places9find_endsB4v532B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5TupleI5ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedExdE5ArrayIdLi1E1C7mutable7alignedExdx5ArrayIxLi1E1C7mutable7alignedE.exit541, %_ZN17bnserve_surrogate6kernel7_places9find_endsB4v532B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5TupleI5ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedExdE5ArrayIdLi1E1C7mutable7alignedExdx5ArrayIxLi1E1C7mutable7alignedE.exit585, %_ZN17bnserve_surrogate6kernel7_places9find_endsB4v532B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5TupleI5ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedExdE5ArrayIdLi1E1C7mutable7alignedExdx5ArrayIxLi1E1C7mutable7alignedE.exit
  %.454916 = phi ptr [ %.4549, %_ZN17bnserve_surrogate6kernel7_places9find_endsB4v532B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5TupleI5ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedExdE5ArrayIdLi1E1C7mutable7alignedExdx5ArrayIxLi1E1C7mutable7alignedE.exit ], [ %.454917, %_ZN17bnserve_surrogate6kernel7_places9find_endsB4v532B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5TupleI5ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedExdE5ArrayIdLi1E1C7mutable7alignedExdx5ArrayIxLi1E1C7mutable7alignedE.exit585 ], [ %.454917, %_ZN17bnserve_surrogate6kernel7_places9find_endsB4v532B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5TupleI5ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedExdE5ArrayIdLi1E1C7mutable7alignedExdx5ArrayIxLi1E1C7mutable7alignedE.exit541 ]
  %"$phi984.0.3.013" = phi i1 [ true, %_ZN17bnserve_surrogate6kernel7_places9find_endsB4v532B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5TupleI5ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedExdE5ArrayIdLi1E1C7mutable7alignedExdx5ArrayIxLi1E1C7mutable7alignedE.exit ], [ %"$phi984.0.3.014", %_ZN17bnserve_surrogate6kernel7_places9find_endsB4v532B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5TupleI5ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedExdE5ArrayIdLi1E1C7mutable7alignedExdx5ArrayIxLi1E1C7mutable7alignedE.exit585 ], [ %"$phi984.0.3.014", %_ZN17bnserve_surrogate6kernel7_places9find_endsB4v532B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5TupleI5ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedExdE5ArrayIdLi1E1C7mutable7alignedExdx5ArrayIxLi1E1C7mutable7alignedE.exit541 ]
  %constant.2.1 = phi double [ 0.000000e+00, %_ZN17bnserve_surrogate6kernel7_places9find_endsB4v532B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5TupleI5ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedExdE5ArrayIdLi1E1C7mutable7alignedExdx5ArrayIxLi1E1C7mutable7alignedE.exit ], [ %.5222, %_ZN17bnserve_surrogate6kernel7_places9find_endsB4v532B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5TupleI5ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedExdE5ArrayIdLi1E1C7mutable7alignedExdx5ArrayIxLi1E1C7mutable7alignedE.exit585 ], [ %.5222, %_ZN17bnserve_surrogate6kernel7_places9find_endsB4v532B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5TupleI5ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedExdE5ArrayIdLi1E1C7mutable7alignedExdx5ArrayIxLi1E1C7mutable7alignedE.exit541 ]
  %7 = add nuw i64 %.126, 1023
  %.5849 = lshr i64 %7, 10
  %.5828.inv = icmp slt i64 %.126, 1
  %.idx = shl i64 %.156, 4
  %8 = getelementptr i8, ptr %.335, i64 %.idx
  %.idx3756 = mul i64 %.156, 24
  %.idx3757 = shl i64 %.156, 5
  %9 = getelementptr i8, ptr %.335, i64 %.idx3757
  %.7900 = getelementptr inbounds double, ptr %.454916, i64 %.973
  %.7965.idx = shl nsw i64 %.973, 4
  %.7965 = getelementptr inbounds i8, ptr %.454916, i64 %.7965.idx
  %.5870238.not246 = icmp eq i64 %.5849, 0
  %.5870238.not = select i1 %.5828.inv, i1 true, i1 %.5870238.not246
  br i1 %.5870238.not, label %B635602, label %B1644.lr.ph

B1644.lr.ph:                                      ; preds = %B1636
  %10 = tail call i64 @llvm.smax.i64(i64 %.5849, i64 1)
  %.277.i = mul i64 %.780.1, -3
  %11 = getelementptr double, ptr %.1262, i64 %.814
  %.idx.i = shl i64 %.814, 4
  %12 = getelementptr i8, ptr %.1262, i64 %.idx.i
  %.idx221.i = mul i64 %.780.1, -24
  %13 = getelementptr i8, ptr %.1262, i64 %.idx221.i
  %14 = getelementptr double, ptr %.1326, i64 %.888
  %.idx.i607 = shl i64 %.888, 4
  %15 = getelementptr i8, ptr %.1326, i64 %.idx.i607
  %.idx221.i608 = mul i64 %.854.1, -24
  %16 = getelementptr i8, ptr %.1326, i64 %.idx221.i608
  %17 = lshr i64 %.846, 3
  %18 = lshr i64 %.772, 3
  %19 = add nuw nsw i64 %17, %18
  %.neg = mul i64 %19, -320
  %20 = getelementptr i8, ptr %arg.scratch.4, i64 %.neg
  %scevgep = getelementptr i8, ptr %20, i64 8576
  %21 = shl i64 %17, 8
  %.neg3 = mul i64 %18, -320
  %reass.sub = sub i64 %.neg3, %21
  %22 = getelementptr i8, ptr %arg.scratch.4, i64 %reass.sub
  %scevgep1139 = getelementptr i8, ptr %22, i64 328
  %23 = shl i64 %19, 8
  %24 = sub i64 328, %23
  %scevgep1146 = getelementptr i8, ptr %arg.scratch.4, i64 %24
  %scevgep1148 = getelementptr i8, ptr %20, i64 320
  %25 = mul i64 %19, 320
  %26 = sub i64 25088, %25
  %scevgep1160 = getelementptr i8, ptr %arg.scratch.4, i64 %26
  %27 = sub i64 33480, %25
  %scevgep1171 = getelementptr i8, ptr %arg.scratch.4, i64 %27
  %sunkaddr39 = getelementptr i8, ptr %.1031, i64 8
  %28 = icmp eq i64 %.1003, 0
  %sunkaddr76 = getelementptr i8, ptr %arg.scratch.4, i64 264
  %sunkaddr77 = getelementptr i8, ptr %arg.scratch.4, i64 256
  %sunkaddr78 = getelementptr i8, ptr %arg.scratch.4, i64 248
  %sunkaddr79 = getelementptr i8, ptr %arg.scratch.4, i64 240
  %sunkaddr80 = getelementptr i8, ptr %arg.scratch.4, i64 232
  %sunkaddr81 = getelementptr i8, ptr %arg.scratch.4, i64 224
  %sunkaddr82 = getelementptr i8, ptr %arg.scratch.4, i64 216
  %sunkaddr83 = getelementptr i8, ptr %arg.scratch.4, i64 208
  %sunkaddr84 = getelementptr i8, ptr %arg.scratch.4, i64 200
  %sunkaddr85 = getelementptr inbounds nuw i8, ptr %arg.scratch.4, i64 192
  %sunkaddr86 = getelementptr i8, ptr %arg.scratch.4, i64 184
  %sunkaddr87 = getelementptr i8, ptr %arg.scratch.4, i64 176
  %sunkaddr88 = getelementptr i8, ptr %arg.scratch.4, i64 168
  %sunkaddr89 = getelementptr i8, ptr %arg.scratch.4, i64 160
  %sunkaddr90 = getelementptr i8, ptr %arg.scratch.4, i64 152
  %sunkaddr91 = getelementptr i8, ptr %arg.scratch.4, i64 144
  %sunkaddr92 = getelementptr i8, ptr %arg.scratch.4, i64 136
  %sunkaddr93 = getelementptr i8, ptr %arg.scratch.4, i64 128
  %sunkaddr94 = getelementptr i8, ptr %arg.scratch.4, i64 120
  %sunkaddr95 = getelementptr i8, ptr %arg.scratch.4, i64 112
  %sunkaddr96 = getelementptr i8, ptr %arg.scratch.4, i64 104
  %sunkaddr97 = getelementptr i8, ptr %arg.scratch.4, i64 96
  %sunkaddr98 = getelementptr i8, ptr %arg.scratch.4, i64 88
  %sunkaddr99 = getelementptr i8, ptr %arg.scratch.4, i64 80
  %sunkaddr100 = getelementptr i8, ptr %arg.scratch.4, i64 72
  %sunkaddr101 = getelementptr inbounds nuw i8, ptr %arg.scratch.4, i64 64
  %sunkaddr102 = shl i64 %.156, 3
  br label %B1644

B1644:                                            ; preds = %B635600, %B1644.lr.ph
  %.5860.sroa.0.0245 = phi i64 [ 0, %B1644.lr.ph ], [ %.5860.sroa.0.0, %B635600 ]
  %.5817.1244.in = phi i64 [ %10, %B1644.lr.ph ], [ %41, %B635600 ]
  %.5814.1243 = phi i64 [ 1024, %B1644.lr.ph ], [ %.5814.1, %B635600 ]
  %cells.3.sroa.0.0242 = phi i64 [ 0, %B1644.lr.ph ], [ %cells.4.sroa.0.1, %B635600 ]
  %cells.3.sroa.13.0241 = phi i64 [ 0, %B1644.lr.ph ], [ %cells.4.sroa.8.1, %B635600 ]
  %.5916 = add nsw i64 %.5860.sroa.0.0245, 1024
  %.13.i = tail call i64 @llvm.smin.i64(i64 %.126, i64 %.5916)
  %.13.i586 = tail call i64 @llvm.smax.i64(i64 %.5860.sroa.0.0245, i64 %.4017)
  %.13.i587 = tail call i64 @llvm.smin.i64(i64 %.13.i, i64 %.13.i586)
  %.13.i588 = tail call i64 @llvm.smax.i64(i64 %.5860.sroa.0.0245, i64 %.3862)
  %.13.i589 = tail call i64 @llvm.smin.i64(i64 %.13.i587, i64 %.13.i588)
  %.6098 = icmp sgt i64 %.13.i589, %.5860.sroa.0.0245
  br i1 %.6098, label %B1646, label %B1666

B1646:                                            ; preds = %B1644
  %.6113 = getelementptr double, ptr %.335, i64 %.5860.sroa.0.0245
  %.6166 = sub nsw i64 %.13.i589, %.5860.sroa.0.0245
  %.6196 = load double, ptr %.3653, align 8
  %.6226 = load double, ptr %sunkaddr39, align 8
  %.145103.not.i = icmp slt i64 %.6166, 1
  br i1 %.145103.not.i, label %B1666, label %B34.if.i

B1666:                                            ; preds = %B144.i, %B1646, %B1644
  br i1 %"$phi984.0.3.013", label %B634618, label %B1718

B1718:                                            ; preds = %B1666
  %29 = icmp slt i64 %.13.i588, %.13.i587
  br i1 %28, label %B1972, label %B1722

B1722:                                            ; preds = %B1718
  br i1 %29, label %B22.preheader.i, label %B634618

B22.preheader.i:                                  ; preds = %B1722
  %30 = mul i64 %.5860.sroa.0.0245, -8
  %scevgep1142 = getelementptr i8, ptr %scevgep, i64 %30
  br label %B22.i

B22.i:                                            ; preds = %B926.i, %B22.preheader.i
  %cell.2.0.i = phi i64 [ %cell.3.2.i, %B926.i ], [ %cells.3.sroa.13.0241, %B22.preheader.i ]
  %start.2.0.i = phi i64 [ %.13.i.i, %B926.i ], [ %.13.i589, %B22.preheader.i ]
  %.149.i = getelementptr inbounds i64, ptr %.1466, i64 %cell.2.0.i
  %.150.i = load i64, ptr %.149.i, align 8, !noalias !18
  %.154.not.i = icmp sgt i64 %.150.i, %start.2.0.i
  br i1 %.154.not.i, label %B112.i, label %B62.i

B62.i:                                            ; preds = %B22.i, %B62.i
  %cell.4.1.i = phi i64 [ %.157.i, %B62.i ], [ %cell.2.0.i, %B22.i ]
  %.157.i = add i64 %cell.4.1.i, 1
  %sunkaddr.i = shl i64 %cell.4.1.i, 3
  %scevgep1140 = getelementptr i8, ptr %scevgep1139, i64 %sunkaddr.i
  %.170.i = load i64, ptr %scevgep1140, align 8, !noalias !18
  %.172.not.i = icmp sgt i64 %.170.i, %start.2.0.i
  br i1 %.172.not.i, label %B112.i, label %B62.i

B112.i:                                           ; preds = %B62.i, %B22.i
  %cell.3.2.i = phi i64 [ %cell.2.0.i, %B22.i ], [ %.157.i, %B62.i ]
  %.184.i = getelementptr inbounds i64, ptr %.1466, i64 %cell.3.2.i
  %.185.i = load i64, ptr %.184.i, align 8, !noalias !18
  %.13.i.i = tail call i64 @llvm.smin.i64(i64 %.13.i587, i64 %.185.i)
  %.395.i = sub i64 %.13.i.i, %start.2.0.i
  %31 = add i64 %.395.i, 7
  %.417.i = lshr i64 %31, 3
  %.396.inv.i = icmp slt i64 %.395.i, 1
  %.438305.not326.i = icmp eq i64 %.417.i, 0
  %.438305.not.i = or i1 %.396.inv.i, %.438305.not326.i
  br i1 %.438305.not.i, label %B926.i, label %B570.if.lr.ph.i

B926.i:                                           ; preds = %B570.if.i, %B112.i
  %.602.i = icmp slt i64 %.185.i, %.13.i587
  br i1 %.602.i, label %B22.i, label %B634618

B570.if.lr.ph.i:                                  ; preds = %B112.i
  %.228.i = getelementptr inbounds double, ptr %.3100, i64 %cell.3.2.i
  %.229.i = load double, ptr %.228.i, align 8, !noalias !18
  %.231.i = fsub contract double %.3607.le, %.229.i
  %.279.i = add nsw i64 %cell.3.2.i, %.277.i
  %.347.i = getelementptr inbounds double, ptr %.1326, i64 %.279.i
  %.348.i = load double, ptr %.347.i, align 8, !noalias !18
  %.266.i = add nsw i64 %cell.3.2.i, %.1113
  %.334.i = getelementptr inbounds double, ptr %.1326, i64 %.266.i
  %.335.i = load double, ptr %.334.i, align 8, !noalias !18
  %.247.i = sub i64 %cell.3.2.i, %.780.1
  %.315.i = getelementptr inbounds double, ptr %.1326, i64 %.247.i
  %.316.i = load double, ptr %.315.i, align 8, !noalias !18
  %.303.i = getelementptr inbounds double, ptr %.1326, i64 %cell.3.2.i
  %.304.i = load double, ptr %.303.i, align 8, !noalias !18
  %.287.i = getelementptr inbounds double, ptr %.1262, i64 %.279.i
  %.288.i = load double, ptr %.287.i, align 8, !noalias !18
  %.274.i = getelementptr inbounds double, ptr %.1262, i64 %.266.i
  %.275.i = load double, ptr %.274.i, align 8, !noalias !18
  %.255.i = getelementptr inbounds double, ptr %.1262, i64 %.247.i
  %.256.i = load double, ptr %.255.i, align 8, !noalias !18
  %.243.i = getelementptr inbounds double, ptr %.1262, i64 %cell.3.2.i
  %.244.i = load double, ptr %.243.i, align 8, !noalias !18
  %.514.i = insertelement <8 x double> poison, double %.288.i, i64 0
  %.515.i = shufflevector <8 x double> %.514.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.517.i = insertelement <8 x double> poison, double %.275.i, i64 0
  %.518.i = shufflevector <8 x double> %.517.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.521.i = insertelement <8 x double> poison, double %.256.i, i64 0
  %.522.i = shufflevector <8 x double> %.521.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.525.i = insertelement <8 x double> poison, double %.244.i, i64 0
  %.526.i = shufflevector <8 x double> %.525.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.541.i = insertelement <8 x double> poison, double %.348.i, i64 0
  %.542.i = shufflevector <8 x double> %.541.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.544.i = insertelement <8 x double> poison, double %.335.i, i64 0
  %.545.i = shufflevector <8 x double> %.544.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.548.i = insertelement <8 x double> poison, double %.316.i, i64 0
  %.549.i = shufflevector <8 x double> %.548.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.552.i = insertelement <8 x double> poison, double %.304.i, i64 0
  %.553.i = shufflevector <8 x double> %.552.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.6.i.i = insertelement <8 x double> poison, double %.231.i, i64 0
  %.7.i.i = shufflevector <8 x double> %.6.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %32 = shl i64 %start.2.0.i, 3
  %33 = add nuw nsw i64 %.417.i, 5
  br label %B570.if.i

B570.if.i:                                        ; preds = %B570.if.i, %B570.if.lr.ph.i
  %lsr.iv22 = phi i64 [ %lsr.iv.next23, %B570.if.i ], [ %33, %B570.if.lr.ph.i ]
  %lsr.iv8.i = phi i64 [ %lsr.iv.next9.i, %B570.if.i ], [ %32, %B570.if.lr.ph.i ]
  %scevgep13.i = getelementptr i8, ptr %.402, i64 %lsr.iv8.i
  %.485.i = load <8 x double>, ptr %scevgep13.i, align 8, !noalias !18
  %.8.i.i = fadd contract <8 x double> %.7.i.i, %.485.i
  %.519.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i.i, <8 x double> %.515.i, <8 x double> %.518.i)
  %.523.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i.i, <8 x double> %.519.i, <8 x double> %.522.i)
  %.527.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i.i, <8 x double> %.523.i, <8 x double> %.526.i)
  %scevgep1144 = getelementptr i8, ptr %scevgep1142, i64 %lsr.iv8.i
  %scevgep1145 = getelementptr i8, ptr %scevgep1144, i64 -8256
  store <8 x double> %.527.i, ptr %scevgep1145, align 8, !noalias !18
  %.546.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i.i, <8 x double> %.542.i, <8 x double> %.545.i)
  %.550.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i.i, <8 x double> %.546.i, <8 x double> %.549.i)
  %.554.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i.i, <8 x double> %.550.i, <8 x double> %.553.i)
  store <8 x double> %.554.i, ptr %scevgep1144, align 8, !noalias !18
  %lsr.iv.next9.i = add i64 %lsr.iv8.i, 64
  %lsr.iv.next23 = add nsw i64 %lsr.iv22, -1
  %.438.i = icmp sgt i64 %lsr.iv22, 6
  br i1 %.438.i, label %B570.if.i, label %B926.i

B1972:                                            ; preds = %B1718
  br i1 %29, label %B22.preheader.i273, label %B1972.endif

B22.preheader.i273:                               ; preds = %B1972
  %34 = mul i64 %.5860.sroa.0.0245, -8
  %scevgep1149 = getelementptr i8, ptr %scevgep1148, i64 %34
  br label %B22.i275

B22.i275:                                         ; preds = %B612.i, %B22.preheader.i273
  %cell.2.0.i276 = phi i64 [ %cell.3.2.i282, %B612.i ], [ %cells.3.sroa.0.0242, %B22.preheader.i273 ]
  %start.2.0.i277 = phi i64 [ %.13.i.i284, %B612.i ], [ %.13.i589, %B22.preheader.i273 ]
  %.121.i = getelementptr inbounds i64, ptr %.1403, i64 %cell.2.0.i276
  %.122.i = load i64, ptr %.121.i, align 8, !noalias !21
  %.126.not.i = icmp sgt i64 %.122.i, %start.2.0.i277
  br i1 %.126.not.i, label %B112.i281, label %B62.i278

B62.i278:                                         ; preds = %B22.i275, %B62.i278
  %cell.4.1.i279 = phi i64 [ %.129.i, %B62.i278 ], [ %cell.2.0.i276, %B22.i275 ]
  %.129.i = add i64 %cell.4.1.i279, 1
  %sunkaddr.i280 = shl i64 %cell.4.1.i279, 3
  %scevgep1147 = getelementptr i8, ptr %scevgep1146, i64 %sunkaddr.i280
  %.142.i = load i64, ptr %scevgep1147, align 8, !noalias !21
  %.144.not.i = icmp sgt i64 %.142.i, %start.2.0.i277
  br i1 %.144.not.i, label %B112.i281, label %B62.i278

B112.i281:                                        ; preds = %B62.i278, %B22.i275
  %cell.3.2.i282 = phi i64 [ %cell.2.0.i276, %B22.i275 ], [ %.129.i, %B62.i278 ]
  %.156.i = getelementptr inbounds i64, ptr %.1403, i64 %cell.3.2.i282
  %.157.i283 = load i64, ptr %.156.i, align 8, !noalias !21
  %.13.i.i284 = tail call i64 @llvm.smin.i64(i64 %.13.i587, i64 %.157.i283)
  %.307.i = sub i64 %.13.i.i284, %start.2.0.i277
  %35 = add i64 %.307.i, 7
  %.329.i = lshr i64 %35, 3
  %.308.inv.i = icmp slt i64 %.307.i, 1
  %.350229.not250.i = icmp eq i64 %.329.i, 0
  %.350229.not.i = or i1 %.308.inv.i, %.350229.not250.i
  br i1 %.350229.not.i, label %B612.i, label %B412.if.lr.ph.i

B612.i:                                           ; preds = %B412.if.i, %B112.i281
  %.479.i = icmp slt i64 %.157.i283, %.13.i587
  br i1 %.479.i, label %B22.i275, label %B1972.endif

B412.if.lr.ph.i:                                  ; preds = %B112.i281
  %.200.i = getelementptr inbounds double, ptr %.3007, i64 %cell.3.2.i282
  %.201.i = load double, ptr %.200.i, align 8, !noalias !21
  %.203.i = fsub contract double %.3607.le, %.201.i
  %.259.i = getelementptr double, ptr %13, i64 %cell.3.2.i282
  %.260.i = load double, ptr %.259.i, align 8, !noalias !21
  %.246.i = getelementptr double, ptr %12, i64 %cell.3.2.i282
  %.247.i285 = load double, ptr %.246.i, align 8, !noalias !21
  %.227.i = getelementptr double, ptr %11, i64 %cell.3.2.i282
  %.228.i286 = load double, ptr %.227.i, align 8, !noalias !21
  %.215.i = getelementptr inbounds double, ptr %.1262, i64 %cell.3.2.i282
  %.216.i = load double, ptr %.215.i, align 8, !noalias !21
  %.426.i = insertelement <8 x double> poison, double %.260.i, i64 0
  %.427.i = shufflevector <8 x double> %.426.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.429.i = insertelement <8 x double> poison, double %.247.i285, i64 0
  %.430.i = shufflevector <8 x double> %.429.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.433.i = insertelement <8 x double> poison, double %.228.i286, i64 0
  %.434.i = shufflevector <8 x double> %.433.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.437.i = insertelement <8 x double> poison, double %.216.i, i64 0
  %.438.i287 = shufflevector <8 x double> %.437.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.6.i.i288 = insertelement <8 x double> poison, double %.203.i, i64 0
  %.7.i.i289 = shufflevector <8 x double> %.6.i.i288, <8 x double> poison, <8 x i32> zeroinitializer
  %36 = shl i64 %start.2.0.i277, 3
  %37 = add nuw nsw i64 %.329.i, 5
  br label %B412.if.i

B412.if.i:                                        ; preds = %B412.if.i, %B412.if.lr.ph.i
  %lsr.iv24 = phi i64 [ %lsr.iv.next25, %B412.if.i ], [ %37, %B412.if.lr.ph.i ]
  %lsr.iv8.i290 = phi i64 [ %lsr.iv.next9.i296, %B412.if.i ], [ %36, %B412.if.lr.ph.i ]
  %scevgep11.i292 = getelementptr i8, ptr %.402, i64 %lsr.iv8.i290
  %.397.i = load <8 x double>, ptr %scevgep11.i292, align 8, !noalias !21
  %.8.i.i293 = fadd contract <8 x double> %.7.i.i289, %.397.i
  %.431.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i.i293, <8 x double> %.427.i, <8 x double> %.430.i)
  %.435.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i.i293, <8 x double> %.431.i, <8 x double> %.434.i)
  %.439.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i.i293, <8 x double> %.435.i, <8 x double> %.438.i287)
  %scevgep1150 = getelementptr i8, ptr %scevgep1149, i64 %lsr.iv8.i290
  store <8 x double> %.439.i, ptr %scevgep1150, align 8, !noalias !21
  %lsr.iv.next9.i296 = add i64 %lsr.iv8.i290, 64
  %lsr.iv.next25 = add nsw i64 %lsr.iv24, -1
  %.350.i = icmp sgt i64 %lsr.iv24, 6
  br i1 %.350.i, label %B412.if.i, label %B612.i

B634618:                                          ; preds = %B926.i, %B612.i669, %B1972.endif, %B1722, %B1666
  %.6047..5991 = phi i64 [ %.13.i589, %B1666 ], [ %.13.i587, %B612.i669 ], [ %.13.i587, %B1722 ], [ %.13.i587, %B1972.endif ], [ %.13.i587, %B926.i ]
  %cells.5.sroa.13.1 = phi i64 [ %cells.3.sroa.13.0241, %B1666 ], [ %cell.3.2.i625, %B612.i669 ], [ %cells.3.sroa.13.0241, %B1722 ], [ %cells.3.sroa.13.0241, %B1972.endif ], [ %cell.3.2.i, %B926.i ]
  %cells.5.sroa.0.1 = phi i64 [ %cells.3.sroa.0.0242, %B1666 ], [ %cell.5.1.i272, %B612.i669 ], [ %cells.3.sroa.0.0242, %B1722 ], [ %cell.5.1.i272, %B1972.endif ], [ %cells.3.sroa.0.0242, %B926.i ]
  %.6991 = sub nsw i64 %.6047..5991, %.5860.sroa.0.0245
  %.6998 = icmp sgt i64 %.6991, 0
  br i1 %.6998, label %B635279, label %B635280

B635279:                                          ; preds = %B634618
  %.7036 = sub nsw i64 %.13.i485, %.5860.sroa.0.0245
  %.13.i297 = tail call i64 @llvm.smax.i64(i64 %.7036, i64 0)
  %.13.i672 = tail call i64 @llvm.smin.i64(i64 %.6991, i64 %.13.i297)
  %.7096 = sub nsw i64 %.13.i486, %.5860.sroa.0.0245
  %.13.i673 = tail call i64 @llvm.smax.i64(i64 %.7096, i64 0)
  %.13.i674 = tail call i64 @llvm.smin.i64(i64 %.6991, i64 %.13.i673)
  %.7169 = getelementptr double, ptr %.335, i64 %.5860.sroa.0.0245
  %.7300 = getelementptr double, ptr %8, i64 %.5860.sroa.0.0245
  %.7429 = getelementptr double, ptr %9, i64 %.5860.sroa.0.0245
  store ptr null, ptr %.7481, align 8
  call fastcc void @inner_12(ptr nonnull %.7481, ptr %.7169, ptr %.7300, ptr %.7429, i64 %.13.i672, i64 %.13.i674, i64 %.6991, double %.3595, ptr %arg.scratch.4, double %constant.2.1, ptr %.1615, ptr %.1740)
  %38 = add nuw i64 %.6991, 7
  %.1167.i = lshr i64 %38, 3
  %.1013.i = load double, ptr %sunkaddr76, align 8, !noalias !24
  %.984.i = load double, ptr %sunkaddr77, align 8, !noalias !24
  %.955.i = load double, ptr %sunkaddr78, align 8, !noalias !24
  %.926.i = load double, ptr %sunkaddr79, align 8, !noalias !24
  %.897.i = load double, ptr %sunkaddr80, align 8, !noalias !24
  %.868.i = load double, ptr %sunkaddr81, align 8, !noalias !24
  %.839.i = load double, ptr %sunkaddr82, align 8, !noalias !24
  %.810.i = load double, ptr %sunkaddr83, align 8, !noalias !24
  %.781.i = load double, ptr %sunkaddr84, align 8, !noalias !24
  %.752.i = load double, ptr %sunkaddr85, align 8, !noalias !24
  %.648.i = load double, ptr %sunkaddr86, align 8, !noalias !24
  %.619.i = load double, ptr %sunkaddr87, align 8, !noalias !24
  %.590.i = load double, ptr %sunkaddr88, align 8, !noalias !24
  %.561.i = load double, ptr %sunkaddr89, align 8, !noalias !24
  %.532.i = load double, ptr %sunkaddr90, align 8, !noalias !24
  %.503.i = load double, ptr %sunkaddr91, align 8, !noalias !24
  %.474.i = load double, ptr %sunkaddr92, align 8, !noalias !24
  %.445.i = load double, ptr %sunkaddr93, align 8, !noalias !24
  %.344.i = load double, ptr %sunkaddr94, align 8, !noalias !24
  %.315.i711 = load double, ptr %sunkaddr95, align 8, !noalias !24
  %.286.i = load double, ptr %sunkaddr96, align 8, !noalias !24
  %.257.i = load double, ptr %sunkaddr97, align 8, !noalias !24
  %.228.i714 = load double, ptr %sunkaddr98, align 8, !noalias !24
  %.199.i = load double, ptr %sunkaddr99, align 8, !noalias !24
  %.170.i715 = load double, ptr %sunkaddr100, align 8, !noalias !24
  %.141.i = load double, ptr %sunkaddr101, align 8, !noalias !24
  %.1282.i = insertelement <8 x double> poison, double %.619.i, i64 0
  %.1283.i = shufflevector <8 x double> %.1282.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1285.i = insertelement <8 x double> poison, double %.561.i, i64 0
  %.1286.i = shufflevector <8 x double> %.1285.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1289.i = insertelement <8 x double> poison, double %.503.i, i64 0
  %.1290.i = shufflevector <8 x double> %.1289.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1293.i = insertelement <8 x double> poison, double %.445.i, i64 0
  %.1294.i = shufflevector <8 x double> %.1293.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1297.i = insertelement <8 x double> poison, double %.648.i, i64 0
  %.1298.i = shufflevector <8 x double> %.1297.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1300.i = insertelement <8 x double> poison, double %.590.i, i64 0
  %.1301.i = shufflevector <8 x double> %.1300.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1304.i = insertelement <8 x double> poison, double %.532.i, i64 0
  %.1305.i = shufflevector <8 x double> %.1304.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1308.i = insertelement <8 x double> poison, double %.474.i, i64 0
  %.1309.i = shufflevector <8 x double> %.1308.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1312.i = insertelement <8 x double> poison, double %.315.i711, i64 0
  %.1313.i = shufflevector <8 x double> %.1312.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1315.i = insertelement <8 x double> poison, double %.257.i, i64 0
  %.1316.i = shufflevector <8 x double> %.1315.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1319.i = insertelement <8 x double> poison, double %.199.i, i64 0
  %.1320.i = shufflevector <8 x double> %.1319.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1323.i = insertelement <8 x double> poison, double %.141.i, i64 0
  %.1324.i = shufflevector <8 x double> %.1323.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1327.i = insertelement <8 x double> poison, double %.344.i, i64 0
  %.1328.i = shufflevector <8 x double> %.1327.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1330.i = insertelement <8 x double> poison, double %.286.i, i64 0
  %.1331.i = shufflevector <8 x double> %.1330.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1334.i = insertelement <8 x double> poison, double %.228.i714, i64 0
  %.1335.i = shufflevector <8 x double> %.1334.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1338.i = insertelement <8 x double> poison, double %.170.i715, i64 0
  %.1339.i = shufflevector <8 x double> %.1338.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1342.i = insertelement <8 x double> poison, double %.926.i, i64 0
  %.1343.i = shufflevector <8 x double> %.1342.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1345.i = insertelement <8 x double> poison, double %.868.i, i64 0
  %.1346.i = shufflevector <8 x double> %.1345.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1349.i = insertelement <8 x double> poison, double %.810.i, i64 0
  %.1350.i = shufflevector <8 x double> %.1349.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1353.i = insertelement <8 x double> poison, double %.752.i, i64 0
  %.1354.i = shufflevector <8 x double> %.1353.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1357.i = insertelement <8 x double> poison, double %.897.i, i64 0
  %.1358.i = shufflevector <8 x double> %.1357.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1360.i = insertelement <8 x double> poison, double %.839.i, i64 0
  %.1361.i = shufflevector <8 x double> %.1360.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1364.i = insertelement <8 x double> poison, double %.781.i, i64 0
  %.1365.i = shufflevector <8 x double> %.1364.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1428.i = insertelement <8 x double> poison, double %.955.i, i64 0
  %.1429.i = shufflevector <8 x double> %.1428.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1446.i = insertelement <8 x double> poison, double %.1013.i, i64 0
  %.1447.i = shufflevector <8 x double> %.1446.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1448.i = insertelement <8 x double> poison, double %.984.i, i64 0
  %.1449.i = shufflevector <8 x double> %.1448.i, <8 x double> poison, <8 x i32> zeroinitializer
  %39 = add nuw nsw i64 %.1167.i, 5
  br label %B484.if.i

B635280:                                          ; preds = %B484.if.i, %B634618
  br i1 %"$phi984.0.3.013", label %B635522, label %B635600

B635522:                                          ; preds = %B635280
  %.137.i = icmp slt i64 %.13.i588, %.13.i587
  br i1 %.137.i, label %B22.preheader.i736, label %B635600

B635600:                                          ; preds = %B1344.i, %B635522, %B635280
  %cells.4.sroa.8.1 = phi i64 [ %cells.5.sroa.13.1, %B635280 ], [ %cells.5.sroa.13.1, %B635522 ], [ %cell.3.2.i746, %B1344.i ]
  %cells.4.sroa.0.1 = phi i64 [ %cells.5.sroa.0.1, %B635280 ], [ 0, %B635522 ], [ 0, %B1344.i ]
  store ptr null, ptr %.8479, align 8
  call fastcc void @inner_13(ptr nonnull %.8479, i64 %arg.i, i64 %.5860.sroa.0.0245, i64 %.13.i587, i64 %.13.i, ptr %arg.arguments.4, ptr %.1740, ptr %.1803, double %arg.plus, double %arg.cross, ptr %.1897)
  %.5870 = icmp samesign ugt i64 %.5817.1244.in, 1
  %.5883 = add i64 %.5814.1243, 1024
  %.5814.1 = select i1 %.5870, i64 %.5883, i64 %.5814.1243
  %40 = tail call i64 @llvm.smax.i64(i64 %.5817.1244.in, i64 2)
  %41 = add nsw i64 %40, -1
  %.5860.sroa.0.0 = select i1 %.5870, i64 %.5814.1243, i64 0
  br i1 %.5870, label %B1644, label %B635602

common.ret:                                       ; preds = %B1390.if, %B1258.if, %B635602
  %common.ret.op = phi i32 [ 0, %B635602 ], [ 1, %B1390.if ], [ 1, %B1258.if ]
  ret i32 %common.ret.op

B635602:                                          ; preds = %B635600, %B1636
  store ptr null, ptr %retptr, align 8
  br label %common.ret

B94.if.lr.ph.i:                                   ; preds = %B984
  %42 = getelementptr double, ptr %.1262, i64 %.814
  %43 = getelementptr double, ptr %.1262, i64 %.1113
  %.idx.i401 = mul i64 %.780.1, -24
  %44 = getelementptr i8, ptr %.1262, i64 %.idx.i401
  %45 = shl i64 %.772, 3
  %46 = and i64 %45, -64
  %47 = sub i64 8, %46
  %scevgep1196 = getelementptr i8, ptr %arg.linear.4, i64 %47
  %48 = add nuw nsw i64 %.486.i, 5
  br label %B94.if.i

B94.if.i:                                         ; preds = %B94.if.i, %B94.if.lr.ph.i
  %lsr.iv32 = phi i64 [ %lsr.iv.next33, %B94.if.i ], [ %48, %B94.if.lr.ph.i ]
  %lsr.iv53.i = phi i64 [ %lsr.iv.next54.i, %B94.if.i ], [ 0, %B94.if.lr.ph.i ]
  %sunkaddr40 = getelementptr i8, ptr %arg.linear.4, i64 %lsr.iv53.i
  %.554.i404 = load <8 x double>, ptr %sunkaddr40, align 8, !noalias !27
  %sunkaddr42 = getelementptr i8, ptr %sunkaddr40, i64 8
  %.565.i = load <8 x double>, ptr %sunkaddr42, align 8, !noalias !27
  %scevgep1198 = getelementptr i8, ptr %scevgep1196, i64 %lsr.iv53.i
  %scevgep1199 = getelementptr i8, ptr %scevgep1198, i64 -8
  %.575.i = load <8 x double>, ptr %scevgep1199, align 8, !noalias !27
  %.586.i = load <8 x double>, ptr %scevgep1198, align 8, !noalias !27
  %scevgep67.i = getelementptr i8, ptr %.201.i399, i64 %lsr.iv53.i
  %.596.i = load <8 x double>, ptr %scevgep67.i, align 8, !noalias !27
  %scevgep66.i = getelementptr i8, ptr %.373.i, i64 %lsr.iv53.i
  %.606.i = load <8 x double>, ptr %scevgep66.i, align 8, !noalias !27
  %.6.i.i405 = fsub contract <8 x double> %.565.i, %.554.i404
  %.6.i46.i = fmul contract <8 x double> %.6.i.i405, %.606.i
  %scevgep65.i = getelementptr i8, ptr %.1262, i64 %lsr.iv53.i
  store <8 x double> %.554.i404, ptr %scevgep65.i, align 8, !noalias !27
  %.669.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.575.i, <8 x double> splat (double 2.000000e+00), <8 x double> %.586.i)
  %.8.i.i406 = fmul contract <8 x double> %.669.i, splat (double 0x3FC5555555555555)
  %.6.i47.i = fmul contract <8 x double> %.596.i, %.8.i.i406
  %.6.i48.i = fsub contract <8 x double> %.6.i46.i, %.6.i47.i
  %scevgep64.i = getelementptr i8, ptr %42, i64 %lsr.iv53.i
  store <8 x double> %.6.i48.i, ptr %scevgep64.i, align 8, !noalias !27
  %.8.i49.i = fmul contract <8 x double> %.575.i, splat (double 5.000000e-01)
  %scevgep63.i = getelementptr i8, ptr %43, i64 %lsr.iv53.i
  store <8 x double> %.8.i49.i, ptr %scevgep63.i, align 8, !noalias !27
  %.6.i50.i = fsub contract <8 x double> %.586.i, %.575.i
  %.6.i51.i = fmul contract <8 x double> %.6.i50.i, %.606.i
  %.8.i52.i = fmul contract <8 x double> %.6.i51.i, splat (double 0x3FC5555555555555)
  %scevgep62.i = getelementptr i8, ptr %44, i64 %lsr.iv53.i
  store <8 x double> %.8.i52.i, ptr %scevgep62.i, align 8, !noalias !27
  %lsr.iv.next54.i = add i64 %lsr.iv53.i, 64
  %lsr.iv.next33 = add nsw i64 %lsr.iv32, -1
  %.507.i = icmp sgt i64 %lsr.iv32, 6
  br i1 %.507.i, label %B94.if.i, label %B984.endif.endif.endif.en...endif.3.endif.endif

B984.endif.endif.endif.en...endif.3.endif.endif:  ; preds = %B94.if.i, %B984
  %.3448 = load i64, ptr %.844, align 8
  %49 = add i64 %.3448, 6
  %.486.i439 = lshr i64 %49, 3
  %.463.inv.i440 = icmp slt i64 %.3448, 2
  %.507321.not325.i441 = icmp eq i64 %.486.i439, 0
  %.507321.not.i442 = or i1 %.463.inv.i440, %.507321.not325.i441
  br i1 %.507321.not.i442, label %_ZN17bnserve_surrogate6kernel7_points10fill_cellsB4v158B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedExx5ArrayIdLi1E1C7mutable7alignedE.exit479, label %B94.if.lr.ph.i443

B94.if.lr.ph.i443:                                ; preds = %B984.endif.endif.endif.en...endif.3.endif.endif
  %50 = lshr i64 %.888, 33
  %.99.i419 = and i64 %50, 1073741824
  %.234.i429 = shl i64 %.888, 1
  %.272.i430 = add i64 %.99.i419, %.234.i429
  %51 = tail call i64 @llvm.smax.i64(i64 %.272.i430, i64 0)
  %.100.i420 = sub i64 %.99.i419, %.854.1
  %52 = tail call i64 @llvm.smax.i64(i64 %.100.i420, i64 0)
  %.88.sroa.0.3.i427 = tail call i64 @llvm.smin.i64(i64 %52, i64 1073741824)
  %53 = getelementptr double, ptr %.1326, i64 %.888
  %54 = getelementptr double, ptr %.1326, i64 %.234.i429
  %.idx.i444 = mul i64 %.854.1, -24
  %55 = getelementptr i8, ptr %.1326, i64 %.idx.i444
  %56 = shl i64 %.846, 3
  %57 = and i64 %56, -64
  %58 = shl i64 %.772, 4
  %59 = and i64 %58, -128
  %60 = add i64 %59, %57
  %61 = sub i64 8, %60
  %scevgep1186 = getelementptr i8, ptr %arg.linear.4, i64 %61
  %62 = sub i64 8, %59
  %scevgep1190 = getelementptr i8, ptr %arg.linear.4, i64 %62
  %smin = tail call i64 @llvm.smin.i64(i64 %51, i64 1073741824)
  %63 = add i64 %.3087, %smin
  %64 = shl i64 %63, 3
  %scevgep55 = getelementptr i8, ptr %arg.weights.4, i64 %64
  %65 = add i64 %.3087, %.88.sroa.0.3.i427
  %66 = shl i64 %65, 3
  %scevgep57 = getelementptr i8, ptr %arg.weights.4, i64 %66
  %67 = add nuw nsw i64 %.486.i439, 5
  br label %B94.if.i445

B94.if.i445:                                      ; preds = %B94.if.i445, %B94.if.lr.ph.i443
  %lsr.iv30 = phi i64 [ %lsr.iv.next31, %B94.if.i445 ], [ %67, %B94.if.lr.ph.i443 ]
  %lsr.iv53.i446 = phi i64 [ %lsr.iv.next54.i475, %B94.if.i445 ], [ 0, %B94.if.lr.ph.i443 ]
  %scevgep1192 = getelementptr i8, ptr %scevgep1190, i64 %lsr.iv53.i446
  %scevgep1193 = getelementptr i8, ptr %scevgep1192, i64 -8
  %.554.i449 = load <8 x double>, ptr %scevgep1193, align 8, !noalias !30
  %.565.i451 = load <8 x double>, ptr %scevgep1192, align 8, !noalias !30
  %scevgep1188 = getelementptr i8, ptr %scevgep1186, i64 %lsr.iv53.i446
  %scevgep1189 = getelementptr i8, ptr %scevgep1188, i64 -8
  %.575.i453 = load <8 x double>, ptr %scevgep1189, align 8, !noalias !30
  %.586.i455 = load <8 x double>, ptr %scevgep1188, align 8, !noalias !30
  %scevgep58 = getelementptr i8, ptr %scevgep57, i64 %lsr.iv53.i446
  %.596.i457 = load <8 x double>, ptr %scevgep58, align 8, !noalias !30
  %scevgep56 = getelementptr i8, ptr %scevgep55, i64 %lsr.iv53.i446
  %.606.i459 = load <8 x double>, ptr %scevgep56, align 8, !noalias !30
  %.6.i.i460 = fsub contract <8 x double> %.565.i451, %.554.i449
  %.6.i46.i461 = fmul contract <8 x double> %.6.i.i460, %.606.i459
  %scevgep65.i462 = getelementptr i8, ptr %.1326, i64 %lsr.iv53.i446
  store <8 x double> %.554.i449, ptr %scevgep65.i462, align 8, !noalias !30
  %.669.i463 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.575.i453, <8 x double> splat (double 2.000000e+00), <8 x double> %.586.i455)
  %.8.i.i464 = fmul contract <8 x double> %.669.i463, splat (double 0x3FC5555555555555)
  %.6.i47.i465 = fmul contract <8 x double> %.596.i457, %.8.i.i464
  %.6.i48.i466 = fsub contract <8 x double> %.6.i46.i461, %.6.i47.i465
  %scevgep64.i467 = getelementptr i8, ptr %53, i64 %lsr.iv53.i446
  store <8 x double> %.6.i48.i466, ptr %scevgep64.i467, align 8, !noalias !30
  %.8.i49.i468 = fmul contract <8 x double> %.575.i453, splat (double 5.000000e-01)
  %scevgep63.i469 = getelementptr i8, ptr %54, i64 %lsr.iv53.i446
  store <8 x double> %.8.i49.i468, ptr %scevgep63.i469, align 8, !noalias !30
  %.6.i50.i470 = fsub contract <8 x double> %.586.i455, %.575.i453
  %.6.i51.i471 = fmul contract <8 x double> %.6.i50.i470, %.606.i459
  %.8.i52.i472 = fmul contract <8 x double> %.6.i51.i471, splat (double 0x3FC5555555555555)
  %scevgep62.i473 = getelementptr i8, ptr %55, i64 %lsr.iv53.i446
  store <8 x double> %.8.i52.i472, ptr %scevgep62.i473, align 8, !noalias !30
  %lsr.iv.next54.i475 = add i64 %lsr.iv53.i446, 64
  %lsr.iv.next31 = add nsw i64 %lsr.iv30, -1
  %.507.i476 = icmp sgt i64 %lsr.iv30, 6
  br i1 %.507.i476, label %B94.if.i445, label %_ZN17bnserve_surrogate6kernel7_points10fill_cellsB4v158B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedExx5ArrayIdLi1E1C7mutable7alignedE.exit479

_ZN17bnserve_surrogate6kernel7_points10fill_cellsB4v158B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedExx5ArrayIdLi1E1C7mutable7alignedE.exit479: ; preds = %B94.if.i445, %B984.endif.endif.endif.en...endif.3.endif.endif
  %68 = inttoptr i64 %.529 to ptr
  %.3593 = getelementptr i8, ptr %arg.row.4, i64 56
  %.3594 = load double, ptr %.3593, align 8
  %.3595 = fmul contract double %.3594, 0x3ED4A8B4A9ED04E3
  %.3607.le = tail call contract double @llvm.log.f64(double %.3595)
  %.3641 = getelementptr i8, ptr %arg.contents.4, i64 128
  %.3642 = load i64, ptr %.3641, align 8
  %.3653 = getelementptr inbounds double, ptr %arg.weights.4, i64 %.3642
  %.3783 = load double, ptr %.3653, align 8
  %.3785 = fmul contract double %.3783, 0x3FEFFFFFFF768FA1
  %.3793.le = tail call contract double @llvm.log.f64(double %.3785)
  %.3798 = fsub contract double %.3793.le, %.3607.le
  store i64 0, ptr %.3844, align 8
  call fastcc void @inner_14(ptr nonnull %.3844, ptr %.402, i64 %.126, ptr %68, i64 %.296, double %prepared_grid_v501__vphi308_0.2.0, double %.3798)
  %.3862 = load i64, ptr %.3844, align 8
  %.3934 = getelementptr i8, ptr %.3653, i64 8
  %.3935 = load double, ptr %.3934, align 8
  %.3940 = fmul contract double %.3935, 0x3FF000000044B830
  %.3948.le = tail call contract double @llvm.log.f64(double %.3940)
  %.3953 = fsub contract double %.3948.le, %.3607.le
  store i64 0, ptr %.3999, align 8
  call fastcc void @inner_14(ptr nonnull %.3999, ptr %.402, i64 %.126, ptr %68, i64 %.296, double %prepared_grid_v501__vphi308_0.2.0, double %.3953)
  %.4017 = load i64, ptr %.3999, align 8
  %.4074 = fsub contract double 0xC0126BB1BBB55515, %.3607.le
  store i64 0, ptr %.4120, align 8
  call fastcc void @inner_14(ptr nonnull %.4120, ptr %.402, i64 %.126, ptr %68, i64 %.296, double %prepared_grid_v501__vphi308_0.2.0, double %.4074)
  %.4138 = load i64, ptr %.4120, align 8
  %.13.i485 = tail call i64 @llvm.smin.i64(i64 %.4017, i64 %.4138)
  %.4233 = fsub contract double 0xC00F4BD2B7AC1BAF, %.3607.le
  store i64 0, ptr %.4279, align 8
  call fastcc void @inner_14(ptr nonnull %.4279, ptr %.402, i64 %.126, ptr %68, i64 %.296, double %prepared_grid_v501__vphi308_0.2.0, double %.4233)
  %.4297 = load i64, ptr %.4279, align 8
  %.13.i486 = tail call i64 @llvm.smin.i64(i64 %.4017, i64 %.4297)
  %.4457 = load i64, ptr %.929, align 8
  %.4458 = icmp sgt i64 %.4457, 0
  %.4464 = icmp sgt i64 %.126, 2047
  %or.cond = select i1 %.4458, i1 %.4464, i1 false
  br i1 %or.cond, label %B1246, label %B1246.thread

B1246.thread:                                     ; preds = %_ZN17bnserve_surrogate6kernel7_points10fill_cellsB4v158B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedExx5ArrayIdLi1E1C7mutable7alignedE.exit479
  %.453710 = getelementptr i8, ptr %arg.contents.4, i64 152
  %.453811 = load i64, ptr %.453710, align 8
  %.454912 = getelementptr inbounds double, ptr %arg.weights.4, i64 %.453811
  br label %B1390

B1258.if:                                         ; preds = %B1258
  %.4997 = load ptr, ptr %excinfo.34, align 8
  store ptr %.4997, ptr %excinfo, align 8
  br label %common.ret

B1258.endif:                                      ; preds = %B1258
  %.5078 = load i64, ptr %.929, align 8
  %.135.i = load double, ptr %.402, align 8, !noalias !33
  %.143.i = add nsw i64 %.5078, -1
  %.181.i = icmp slt i64 %.5078, 2
  %..143.i = select i1 %.181.i, i64 0, i64 %.143.i
  %.225207.i = icmp sgt i64 %..143.i, 0
  br i1 %.225207.i, label %B92.if.preheader.i, label %_ZN17bnserve_surrogate6kernel7_places9find_endsB4v532B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5TupleI5ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedExdE5ArrayIdLi1E1C7mutable7alignedExdx5ArrayIxLi1E1C7mutable7alignedE.exit

B92.if.preheader.i:                               ; preds = %B1258.endif
  %69 = add i64 %.4017, -1
  %70 = shl i64 %.156, 3
  %71 = getelementptr i8, ptr %.335, i64 %70
  %scevgep1184 = getelementptr i8, ptr %71, i64 8
  br label %B92.if.i

B146.i:                                           ; preds = %B92.if.i
  %.291.i = fsub contract double %.281.i, %.135.i
  %.293.i = fmul contract double %prepared_grid_v501__vphi308_0.2.0, %.291.i
  %.5.i.i = fptosi double %.293.i to i64
  %.13.i5.i = tail call i64 @llvm.smin.i64(i64 %.296, i64 %.5.i.i)
  %.354.i = getelementptr inbounds i64, ptr %68, i64 %.13.i5.i
  %.355.i = load i64, ptr %.354.i, align 8, !noalias !33
  %.13.i6.i = tail call i64 @llvm.smax.i64(i64 %.355.i, i64 %end.3.0210.i)
  %.395.i489 = icmp slt i64 %.13.i6.i, %.4017
  br i1 %.395.i489, label %B284.i, label %B386.i

B284.i:                                           ; preds = %B146.i
  %.412.i = getelementptr inbounds nuw double, ptr %.402, i64 %.13.i6.i
  %.413.i = load double, ptr %.412.i, align 8, !noalias !33
  %.417.i491 = fcmp contract ugt double %.413.i, %.281.i
  br i1 %.417.i491, label %B386.i, label %B324.i

B324.i:                                           ; preds = %B284.i, %B346.i
  %end.5.2.i = phi i64 [ %.423.i, %B346.i ], [ %.13.i6.i, %B284.i ]
  %exitcond.not.i = icmp eq i64 %69, %end.5.2.i
  br i1 %exitcond.not.i, label %B386.i, label %B346.i

B346.i:                                           ; preds = %B324.i
  %.423.i = add i64 %end.5.2.i, 1
  %72 = shl i64 %end.5.2.i, 3
  %scevgep1185 = getelementptr i8, ptr %scevgep1184, i64 %72
  %.451.i = load double, ptr %scevgep1185, align 8, !noalias !33
  %.455.i = fcmp contract ugt double %.451.i, %.281.i
  br i1 %.455.i, label %B386.i, label %B324.i

B386.i:                                           ; preds = %B346.i, %B324.i, %B92.if.i, %B284.i, %B146.i
  %end.4.1.i = phi i64 [ %.13.i6.i, %B146.i ], [ %end.3.0210.i, %B92.if.i ], [ %.13.i6.i, %B284.i ], [ %.4017, %B324.i ], [ %.423.i, %B346.i ]
  %.13.i.i490 = tail call i64 @llvm.smin.i64(i64 %.4017, i64 %end.4.1.i)
  %73 = getelementptr i64, ptr %.1529, i64 %.231203208.i
  store i64 %.13.i.i490, ptr %73, align 8, !noalias !33
  %exitcond216.not.i = icmp eq i64 %.238.i, %..143.i
  br i1 %exitcond216.not.i, label %_ZN17bnserve_surrogate6kernel7_places9find_endsB4v532B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5TupleI5ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedExdE5ArrayIdLi1E1C7mutable7alignedExdx5ArrayIxLi1E1C7mutable7alignedE.exit, label %B92.if.i

B92.if.i:                                         ; preds = %B386.i, %B92.if.preheader.i
  %end.3.0210.i = phi i64 [ %end.4.1.i, %B386.i ], [ 0, %B92.if.preheader.i ]
  %.231203208.i = phi i64 [ %.238.i, %B386.i ], [ 0, %B92.if.preheader.i ]
  %.238.i = add nuw nsw i64 %.231203208.i, 1
  %.278.i = getelementptr inbounds nuw double, ptr %.4549, i64 %.231203208.i
  %.279.i487 = load double, ptr %.278.i, align 8, !noalias !33
  %.281.i = fsub contract double %.279.i487, %.3607.le
  %.287.i488 = fcmp contract ult double %.281.i, %.135.i
  br i1 %.287.i488, label %B386.i, label %B146.i

_ZN17bnserve_surrogate6kernel7_places9find_endsB4v532B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5TupleI5ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedExdE5ArrayIdLi1E1C7mutable7alignedExdx5ArrayIxLi1E1C7mutable7alignedE.exit: ; preds = %B386.i, %B1258.endif
  %.586.inv.i = icmp sgt i64 %.5078, 0
  %.587.i = select i1 %.586.inv.i, i64 0, i64 %.973
  %74 = getelementptr i64, ptr %.1529, i64 %.143.i
  %.601.i = getelementptr i64, ptr %74, i64 %.587.i
  store i64 %.4017, ptr %.601.i, align 8, !noalias !33
  %.5184 = icmp sgt i64 %.3862, 0
  br i1 %.5184, label %B1390, label %B1636

B1390.if:                                         ; preds = %B1390
  %.5213 = load ptr, ptr %excinfo.36, align 8
  store ptr %.5213, ptr %excinfo, align 8
  br label %common.ret

B1390.endif:                                      ; preds = %B1390
  %.5439 = load i64, ptr %.844, align 8
  %.135.i498 = load double, ptr %.402, align 8, !noalias !36
  %.143.i499 = add nsw i64 %.5439, -2
  %.181.i500 = icmp slt i64 %.5439, 3
  %..143.i501 = select i1 %.181.i500, i64 0, i64 %.143.i499
  %.225207.i502 = icmp sgt i64 %..143.i501, 0
  br i1 %.225207.i502, label %B92.if.preheader.i506, label %_ZN17bnserve_surrogate6kernel7_places9find_endsB4v532B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5TupleI5ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedExdE5ArrayIdLi1E1C7mutable7alignedExdx5ArrayIxLi1E1C7mutable7alignedE.exit541

B92.if.preheader.i506:                            ; preds = %B1390.endif
  %75 = add i64 %.4017, -1
  %76 = shl i64 %.156, 3
  %77 = getelementptr i8, ptr %.335, i64 %76
  %scevgep1182 = getelementptr i8, ptr %77, i64 8
  br label %B92.if.i507

B146.i515:                                        ; preds = %B92.if.i507
  %.291.i516 = fsub contract double %.281.i513, %.135.i498
  %.293.i517 = fmul contract double %prepared_grid_v501__vphi308_0.2.0, %.291.i516
  %.5.i.i518 = fptosi double %.293.i517 to i64
  %.13.i5.i519 = tail call i64 @llvm.smin.i64(i64 %.296, i64 %.5.i.i518)
  %.354.i520 = getelementptr inbounds i64, ptr %68, i64 %.13.i5.i519
  %.355.i521 = load i64, ptr %.354.i520, align 8, !noalias !36
  %.13.i6.i522 = tail call i64 @llvm.smax.i64(i64 %.355.i521, i64 %end.3.0210.i508)
  %.395.i523 = icmp slt i64 %.13.i6.i522, %.4017
  br i1 %.395.i523, label %B284.i528, label %B386.i524

B284.i528:                                        ; preds = %B146.i515
  %.412.i529 = getelementptr inbounds nuw double, ptr %.402, i64 %.13.i6.i522
  %.413.i530 = load double, ptr %.412.i529, align 8, !noalias !36
  %.417.i531 = fcmp contract ugt double %.413.i530, %.281.i513
  br i1 %.417.i531, label %B386.i524, label %B324.i532

B324.i532:                                        ; preds = %B284.i528, %B346.i535
  %end.5.2.i533 = phi i64 [ %.423.i536, %B346.i535 ], [ %.13.i6.i522, %B284.i528 ]
  %exitcond.not.i534 = icmp eq i64 %75, %end.5.2.i533
  br i1 %exitcond.not.i534, label %B386.i524, label %B346.i535

B346.i535:                                        ; preds = %B324.i532
  %.423.i536 = add i64 %end.5.2.i533, 1
  %78 = shl i64 %end.5.2.i533, 3
  %scevgep1183 = getelementptr i8, ptr %scevgep1182, i64 %78
  %.451.i539 = load double, ptr %scevgep1183, align 8, !noalias !36
  %.455.i540 = fcmp contract ugt double %.451.i539, %.281.i513
  br i1 %.455.i540, label %B386.i524, label %B324.i532

B386.i524:                                        ; preds = %B346.i535, %B324.i532, %B92.if.i507, %B284.i528, %B146.i515
  %end.4.1.i525 = phi i64 [ %.13.i6.i522, %B146.i515 ], [ %end.3.0210.i508, %B92.if.i507 ], [ %.13.i6.i522, %B284.i528 ], [ %.4017, %B324.i532 ], [ %.423.i536, %B346.i535 ]
  %.13.i.i526 = tail call i64 @llvm.smin.i64(i64 %.4017, i64 %end.4.1.i525)
  %79 = getelementptr i64, ptr %.1466, i64 %.231203208.i509
  store i64 %.13.i.i526, ptr %79, align 8, !noalias !36
  %exitcond216.not.i527 = icmp eq i64 %.238.i510, %..143.i501
  br i1 %exitcond216.not.i527, label %_ZN17bnserve_surrogate6kernel7_places9find_endsB4v532B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5TupleI5ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedExdE5ArrayIdLi1E1C7mutable7alignedExdx5ArrayIxLi1E1C7mutable7alignedE.exit541, label %B92.if.i507

B92.if.i507:                                      ; preds = %B386.i524, %B92.if.preheader.i506
  %end.3.0210.i508 = phi i64 [ %end.4.1.i525, %B386.i524 ], [ 0, %B92.if.preheader.i506 ]
  %.231203208.i509 = phi i64 [ %.238.i510, %B386.i524 ], [ 0, %B92.if.preheader.i506 ]
  %.238.i510 = add nuw nsw i64 %.231203208.i509, 1
  %sunkaddr1215 = shl i64 %.231203208.i509, 3
  %sunkaddr1216 = getelementptr inbounds i8, ptr %.3100, i64 %sunkaddr1215
  %sunkaddr1217 = getelementptr inbounds nuw i8, ptr %sunkaddr1216, i64 8
  %.279.i512 = load double, ptr %sunkaddr1217, align 8, !noalias !36
  %.281.i513 = fsub contract double %.279.i512, %.3607.le
  %.287.i514 = fcmp contract ult double %.281.i513, %.135.i498
  br i1 %.287.i514, label %B386.i524, label %B146.i515

_ZN17bnserve_surrogate6kernel7_places9find_endsB4v532B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5TupleI5ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedExdE5ArrayIdLi1E1C7mutable7alignedExdx5ArrayIxLi1E1C7mutable7alignedE.exit541: ; preds = %B386.i524, %B1390.endif
  %.586.inv.i503 = icmp sgt i64 %.5439, 1
  %.587.i504 = select i1 %.586.inv.i503, i64 0, i64 %.888
  %80 = getelementptr i64, ptr %.1466, i64 %.143.i499
  %.601.i505 = getelementptr i64, ptr %80, i64 %.587.i504
  store i64 %.4017, ptr %.601.i505, align 8, !noalias !36
  %.5516 = load i64, ptr %.1002, align 8
  %.5517 = icmp eq i64 %.5516, 0
  br i1 %.5517, label %B1448, label %B1636

B92.if.preheader.i550:                            ; preds = %B1448
  %81 = add i64 %.4017, -1
  %82 = shl i64 %.156, 3
  %83 = getelementptr i8, ptr %.335, i64 %82
  %scevgep1180 = getelementptr i8, ptr %83, i64 8
  br label %B92.if.i551

B146.i559:                                        ; preds = %B92.if.i551
  %.291.i560 = fsub contract double %.281.i557, %.135.i542
  %.293.i561 = fmul contract double %prepared_grid_v501__vphi308_0.2.0, %.291.i560
  %.5.i.i562 = fptosi double %.293.i561 to i64
  %.13.i5.i563 = tail call i64 @llvm.smin.i64(i64 %.296, i64 %.5.i.i562)
  %.354.i564 = getelementptr inbounds i64, ptr %68, i64 %.13.i5.i563
  %.355.i565 = load i64, ptr %.354.i564, align 8, !noalias !15
  %.13.i6.i566 = tail call i64 @llvm.smax.i64(i64 %.355.i565, i64 %end.3.0210.i552)
  %.395.i567 = icmp slt i64 %.13.i6.i566, %.4017
  br i1 %.395.i567, label %B284.i572, label %B386.i568

B284.i572:                                        ; preds = %B146.i559
  %.412.i573 = getelementptr inbounds nuw double, ptr %.402, i64 %.13.i6.i566
  %.413.i574 = load double, ptr %.412.i573, align 8, !noalias !15
  %.417.i575 = fcmp contract ugt double %.413.i574, %.281.i557
  br i1 %.417.i575, label %B386.i568, label %B324.i576

B324.i576:                                        ; preds = %B284.i572, %B346.i579
  %end.5.2.i577 = phi i64 [ %.423.i580, %B346.i579 ], [ %.13.i6.i566, %B284.i572 ]
  %exitcond.not.i578 = icmp eq i64 %81, %end.5.2.i577
  br i1 %exitcond.not.i578, label %B386.i568, label %B346.i579

B346.i579:                                        ; preds = %B324.i576
  %.423.i580 = add i64 %end.5.2.i577, 1
  %84 = shl i64 %end.5.2.i577, 3
  %scevgep1181 = getelementptr i8, ptr %scevgep1180, i64 %84
  %.451.i583 = load double, ptr %scevgep1181, align 8, !noalias !15
  %.455.i584 = fcmp contract ugt double %.451.i583, %.281.i557
  br i1 %.455.i584, label %B386.i568, label %B324.i576

B386.i568:                                        ; preds = %B346.i579, %B324.i576, %B92.if.i551, %B284.i572, %B146.i559
  %end.4.1.i569 = phi i64 [ %.13.i6.i566, %B146.i559 ], [ %end.3.0210.i552, %B92.if.i551 ], [ %.13.i6.i566, %B284.i572 ], [ %.4017, %B324.i576 ], [ %.423.i580, %B346.i579 ]
  %.13.i.i570 = tail call i64 @llvm.smin.i64(i64 %.4017, i64 %end.4.1.i569)
  %85 = getelementptr i64, ptr %.1403, i64 %.231203208.i553
  store i64 %.13.i.i570, ptr %85, align 8, !noalias !15
  %exitcond216.not.i571 = icmp eq i64 %.238.i554, %..143.i545
  br i1 %exitcond216.not.i571, label %_ZN17bnserve_surrogate6kernel7_places9find_endsB4v532B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5TupleI5ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedExdE5ArrayIdLi1E1C7mutable7alignedExdx5ArrayIxLi1E1C7mutable7alignedE.exit585, label %B92.if.i551

B92.if.i551:                                      ; preds = %B386.i568, %B92.if.preheader.i550
  %end.3.0210.i552 = phi i64 [ %end.4.1.i569, %B386.i568 ], [ 0, %B92.if.preheader.i550 ]
  %.231203208.i553 = phi i64 [ %.238.i554, %B386.i568 ], [ 0, %B92.if.preheader.i550 ]
  %.238.i554 = add nuw nsw i64 %.231203208.i553, 1
  %sunkaddr1219 = shl i64 %.231203208.i553, 3
  %sunkaddr1220 = getelementptr inbounds i8, ptr %.3007, i64 %sunkaddr1219
  %sunkaddr1221 = getelementptr inbounds nuw i8, ptr %sunkaddr1220, i64 8
  %.279.i556 = load double, ptr %sunkaddr1221, align 8, !noalias !15
  %.281.i557 = fsub contract double %.279.i556, %.3607.le
  %.287.i558 = fcmp contract ult double %.281.i557, %.135.i542
  br i1 %.287.i558, label %B386.i568, label %B146.i559

_ZN17bnserve_surrogate6kernel7_places9find_endsB4v532B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5TupleI5ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedExdE5ArrayIdLi1E1C7mutable7alignedExdx5ArrayIxLi1E1C7mutable7alignedE.exit585: ; preds = %B386.i568, %B1448
  %.586.inv.i547 = icmp sgt i64 %.5634, 1
  %.587.i548 = select i1 %.586.inv.i547, i64 0, i64 %.814
  %86 = getelementptr i64, ptr %.1403, i64 %.143.i543
  %.601.i549 = getelementptr i64, ptr %86, i64 %.587.i548
  store i64 %.4017, ptr %.601.i549, align 8, !noalias !15
  br label %B1636

B94.i:                                            ; preds = %B34.if.i
  %.6.i.i595 = fmul contract double %.229.i592, 0x400921FB54442D18
  %.7.i.i596 = tail call contract double @llvm.fma.f64(double %.6.i.i595, double 0x3FE45F306DC9C883, double 0x4338000000000000)
  %.8.i.i597 = fadd contract double %.7.i.i596, 0xC338000000000000
  %.23.i.i = tail call contract double @llvm.fma.f64(double %.8.i.i597, double 0xBFF921FB54442D18, double %.6.i.i595)
  %.38.i.i = tail call contract double @llvm.fma.f64(double %.8.i.i597, double 0xBC91A62633145C07, double %.23.i.i)
  %.39.i.i = fmul contract double %.38.i.i, %.38.i.i
  %.56.i.i = bitcast double %.7.i.i596 to i64
  %.60.i.i = and i64 %.56.i.i, 1
  %87 = icmp eq i64 %.60.i.i, 0
  br i1 %87, label %select.true.sink.i.i, label %select.false.sink.i.i

select.true.sink.i.i:                             ; preds = %B94.i
  %.48.i.i = tail call contract double @llvm.fma.f64(double %.39.i.i, double 0x3D2AE7F3E733B81F, double 0xBDA93974A8C07C9D)
  %.49.i.i = tail call contract double @llvm.fma.f64(double %.39.i.i, double %.48.i.i, double 0x3E21EED8EFF8D898)
  %.50.i.i = tail call contract double @llvm.fma.f64(double %.39.i.i, double %.49.i.i, double 0xBE927E4FB7789F5C)
  %.51.i.i = tail call contract double @llvm.fma.f64(double %.39.i.i, double %.50.i.i, double 0x3EFA01A01A01A01A)
  %.52.i.i = tail call contract double @llvm.fma.f64(double %.39.i.i, double %.51.i.i, double 0xBF56C16C16C16C17)
  %.53.i.i = tail call contract double @llvm.fma.f64(double %.39.i.i, double %.52.i.i, double 0x3FA5555555555555)
  %.54.i.i = tail call contract double @llvm.fma.f64(double %.39.i.i, double %.53.i.i, double -5.000000e-01)
  %.55.i.i = tail call contract double @llvm.fma.f64(double %.39.i.i, double %.54.i.i, double 1.000000e+00)
  br label %_ZN17bnserve_surrogate6kernel7_points4stepB4v362B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEd.exit.i

select.false.sink.i.i:                            ; preds = %B94.i
  %.46.i.i = fmul contract double %.38.i.i, %.39.i.i
  %.40.i.i = tail call contract double @llvm.fma.f64(double %.39.i.i, double 0xBD6AE7F3E733B81F, double 0x3DE6124613A86D09)
  %.41.i.i = tail call contract double @llvm.fma.f64(double %.39.i.i, double %.40.i.i, double 0xBE5AE64567F544E4)
  %.42.i.i = tail call contract double @llvm.fma.f64(double %.39.i.i, double %.41.i.i, double 0x3EC71DE3A556C734)
  %.43.i.i = tail call contract double @llvm.fma.f64(double %.39.i.i, double %.42.i.i, double 0xBF2A01A01A01A01A)
  %.44.i.i = tail call contract double @llvm.fma.f64(double %.39.i.i, double %.43.i.i, double 0x3F81111111111111)
  %.45.i.i = tail call contract double @llvm.fma.f64(double %.39.i.i, double %.44.i.i, double 0xBFC5555555555555)
  %.47.i.i = tail call contract double @llvm.fma.f64(double %.46.i.i, double %.45.i.i, double %.38.i.i)
  br label %_ZN17bnserve_surrogate6kernel7_points4stepB4v362B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEd.exit.i

_ZN17bnserve_surrogate6kernel7_points4stepB4v362B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEd.exit.i: ; preds = %select.false.sink.i.i, %select.true.sink.i.i
  %.71.v.i.i = phi double [ %.55.i.i, %select.true.sink.i.i ], [ %.47.i.i, %select.false.sink.i.i ]
  %.65.i.i = shl i64 %.56.i.i, 62
  %.66.i.i = add i64 %.65.i.i, 4611686018427387904
  %.67.i.i = and i64 %.66.i.i, -9223372036854775808
  %.71.i.i = bitcast double %.71.v.i.i to i64
  %.72.i.i = xor i64 %.67.i.i, %.71.i.i
  %.73.i.i = bitcast i64 %.72.i.i to double
  %.89.i.i = tail call contract double @llvm.fma.f64(double %.73.i.i, double -5.000000e-01, double 5.000000e-01)
  %.266.i598 = fmul contract double %.1111, %.89.i.i
  br label %B144.i

B144.i:                                           ; preds = %B34.if.i, %_ZN17bnserve_surrogate6kernel7_points4stepB4v362B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEd.exit.i
  %"$phi144.1.2.1.i" = phi double [ %.266.i598, %_ZN17bnserve_surrogate6kernel7_points4stepB4v362B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEd.exit.i ], [ 0.000000e+00, %B34.if.i ]
  %scevgep19 = getelementptr i8, ptr %scevgep, i64 %89
  %scevgep20 = getelementptr i8, ptr %scevgep19, i64 -8256
  store double %"$phi144.1.2.1.i", ptr %scevgep20, align 8, !noalias !39
  %.314.i = fsub contract double %.218.i, %.6196
  %88 = fmul contract double %.6226, %.314.i
  %.319.i = fsub contract double %.1143, %88
  store double %.319.i, ptr %scevgep19, align 8, !noalias !39
  %exitcond.not.i594 = icmp eq i64 %.6166, %.158.i
  br i1 %exitcond.not.i594, label %B1666, label %B34.if.i

B34.if.i:                                         ; preds = %B1646, %B144.i
  %.151102104.i = phi i64 [ %.158.i, %B144.i ], [ 0, %B1646 ]
  %.158.i = add nuw nsw i64 %.151102104.i, 1
  %89 = shl i64 %.151102104.i, 3
  %scevgep2.i = getelementptr i8, ptr %.6113, i64 %89
  %.216.i590 = load double, ptr %scevgep2.i, align 8, !noalias !39
  %.218.i = fmul contract double %.3595, %.216.i590
  %.223.i = fmul contract double %.218.i, 2.000000e+00
  %.228.i591 = fdiv contract double %.223.i, %.6196
  %.228.fr.i = freeze double %.228.i591
  %.229.i592 = fadd contract double %.228.fr.i, -1.000000e+00
  %.234.i593 = fcmp contract ogt double %.229.i592, 0.000000e+00
  br i1 %.234.i593, label %B94.i, label %B144.i

B1972.endif:                                      ; preds = %B612.i, %B1972
  %cell.5.1.i272 = phi i64 [ %cells.3.sroa.0.0242, %B1972 ], [ %cell.3.2.i282, %B612.i ]
  br i1 %29, label %B22.preheader.i606, label %B634618

B22.preheader.i606:                               ; preds = %B1972.endif
  %90 = mul i64 %.5860.sroa.0.0245, -8
  %scevgep1156 = getelementptr i8, ptr %scevgep, i64 %90
  br label %B22.i610

B22.i610:                                         ; preds = %B612.i669, %B22.preheader.i606
  %cell.2.0.i611 = phi i64 [ %cell.3.2.i625, %B612.i669 ], [ %cells.3.sroa.13.0241, %B22.preheader.i606 ]
  %start.2.0.i612 = phi i64 [ %.13.i.i628, %B612.i669 ], [ %.13.i589, %B22.preheader.i606 ]
  %.121.i613 = getelementptr inbounds i64, ptr %.1466, i64 %cell.2.0.i611
  %.122.i614 = load i64, ptr %.121.i613, align 8, !noalias !42
  %.126.not.i615 = icmp sgt i64 %.122.i614, %start.2.0.i612
  br i1 %.126.not.i615, label %B112.i624, label %B62.i616

B62.i616:                                         ; preds = %B22.i610, %B62.i616
  %cell.4.1.i617 = phi i64 [ %.129.i618, %B62.i616 ], [ %cell.2.0.i611, %B22.i610 ]
  %.129.i618 = add i64 %cell.4.1.i617, 1
  %sunkaddr.i619 = shl i64 %cell.4.1.i617, 3
  %scevgep1154 = getelementptr i8, ptr %scevgep1139, i64 %sunkaddr.i619
  %.142.i622 = load i64, ptr %scevgep1154, align 8, !noalias !42
  %.144.not.i623 = icmp sgt i64 %.142.i622, %start.2.0.i612
  br i1 %.144.not.i623, label %B112.i624, label %B62.i616

B112.i624:                                        ; preds = %B62.i616, %B22.i610
  %cell.3.2.i625 = phi i64 [ %cell.2.0.i611, %B22.i610 ], [ %.129.i618, %B62.i616 ]
  %.156.i626 = getelementptr inbounds i64, ptr %.1466, i64 %cell.3.2.i625
  %.157.i627 = load i64, ptr %.156.i626, align 8, !noalias !42
  %.13.i.i628 = tail call i64 @llvm.smin.i64(i64 %.13.i587, i64 %.157.i627)
  %.307.i629 = sub i64 %.13.i.i628, %start.2.0.i612
  %91 = add i64 %.307.i629, 7
  %.329.i630 = lshr i64 %91, 3
  %.308.inv.i631 = icmp slt i64 %.307.i629, 1
  %.350229.not250.i632 = icmp eq i64 %.329.i630, 0
  %.350229.not.i633 = or i1 %.308.inv.i631, %.350229.not250.i632
  br i1 %.350229.not.i633, label %B612.i669, label %B412.if.lr.ph.i634

B612.i669:                                        ; preds = %B412.if.i656, %B112.i624
  %.479.i670 = icmp slt i64 %.157.i627, %.13.i587
  br i1 %.479.i670, label %B22.i610, label %B634618

B412.if.lr.ph.i634:                               ; preds = %B112.i624
  %.200.i635 = getelementptr inbounds double, ptr %.3100, i64 %cell.3.2.i625
  %.201.i636 = load double, ptr %.200.i635, align 8, !noalias !42
  %.203.i637 = fsub contract double %.3607.le, %.201.i636
  %.259.i638 = getelementptr double, ptr %16, i64 %cell.3.2.i625
  %.260.i639 = load double, ptr %.259.i638, align 8, !noalias !42
  %.246.i640 = getelementptr double, ptr %15, i64 %cell.3.2.i625
  %.247.i641 = load double, ptr %.246.i640, align 8, !noalias !42
  %.227.i642 = getelementptr double, ptr %14, i64 %cell.3.2.i625
  %.228.i643 = load double, ptr %.227.i642, align 8, !noalias !42
  %.215.i644 = getelementptr inbounds double, ptr %.1326, i64 %cell.3.2.i625
  %.216.i645 = load double, ptr %.215.i644, align 8, !noalias !42
  %.426.i646 = insertelement <8 x double> poison, double %.260.i639, i64 0
  %.427.i647 = shufflevector <8 x double> %.426.i646, <8 x double> poison, <8 x i32> zeroinitializer
  %.429.i648 = insertelement <8 x double> poison, double %.247.i641, i64 0
  %.430.i649 = shufflevector <8 x double> %.429.i648, <8 x double> poison, <8 x i32> zeroinitializer
  %.433.i650 = insertelement <8 x double> poison, double %.228.i643, i64 0
  %.434.i651 = shufflevector <8 x double> %.433.i650, <8 x double> poison, <8 x i32> zeroinitializer
  %.437.i652 = insertelement <8 x double> poison, double %.216.i645, i64 0
  %.438.i653 = shufflevector <8 x double> %.437.i652, <8 x double> poison, <8 x i32> zeroinitializer
  %.6.i.i654 = insertelement <8 x double> poison, double %.203.i637, i64 0
  %.7.i.i655 = shufflevector <8 x double> %.6.i.i654, <8 x double> poison, <8 x i32> zeroinitializer
  %92 = shl i64 %start.2.0.i612, 3
  %93 = add nuw nsw i64 %.329.i630, 5
  br label %B412.if.i656

B412.if.i656:                                     ; preds = %B412.if.i656, %B412.if.lr.ph.i634
  %lsr.iv26 = phi i64 [ %lsr.iv.next27, %B412.if.i656 ], [ %93, %B412.if.lr.ph.i634 ]
  %lsr.iv8.i657 = phi i64 [ %lsr.iv.next9.i667, %B412.if.i656 ], [ %92, %B412.if.lr.ph.i634 ]
  %scevgep11.i659 = getelementptr i8, ptr %.402, i64 %lsr.iv8.i657
  %.397.i660 = load <8 x double>, ptr %scevgep11.i659, align 8, !noalias !42
  %.8.i.i661 = fadd contract <8 x double> %.7.i.i655, %.397.i660
  %.431.i662 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i.i661, <8 x double> %.427.i647, <8 x double> %.430.i649)
  %.435.i663 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i.i661, <8 x double> %.431.i662, <8 x double> %.434.i651)
  %.439.i664 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i.i661, <8 x double> %.435.i663, <8 x double> %.438.i653)
  %scevgep1157 = getelementptr i8, ptr %scevgep1156, i64 %lsr.iv8.i657
  store <8 x double> %.439.i664, ptr %scevgep1157, align 8, !noalias !42
  %lsr.iv.next9.i667 = add i64 %lsr.iv8.i657, 64
  %lsr.iv.next27 = add nsw i64 %lsr.iv26, -1
  %.350.i668 = icmp sgt i64 %lsr.iv26, 6
  br i1 %.350.i668, label %B412.if.i656, label %B612.i669

B484.if.i:                                        ; preds = %B484.if.i, %B635279
  %lsr.iv = phi i64 [ %lsr.iv.next, %B484.if.i ], [ %39, %B635279 ]
  %lsr.iv1164 = phi ptr [ %scevgep1165, %B484.if.i ], [ %.7169, %B635279 ]
  %lsr.iv1161 = phi ptr [ %scevgep1162, %B484.if.i ], [ %scevgep1160, %B635279 ]
  %scevgep1168 = getelementptr i8, ptr %lsr.iv1164, i64 %.idx
  %.1236.i = load <8 x double>, ptr %scevgep1168, align 8, !noalias !24
  %.1246.i = load <8 x double>, ptr %lsr.iv1164, align 8, !noalias !24
  %sunkaddr103 = getelementptr i8, ptr %lsr.iv1164, i64 %sunkaddr102
  %.1256.i = load <8 x double>, ptr %sunkaddr103, align 8, !noalias !24
  %.6.i.i717 = fmul contract <8 x double> %.1236.i, %.1236.i
  %.1287.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i717, <8 x double> %.1283.i, <8 x double> %.1286.i)
  %.1291.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i717, <8 x double> %.1287.i, <8 x double> %.1290.i)
  %.1295.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i717, <8 x double> %.1291.i, <8 x double> %.1294.i)
  %.1302.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i717, <8 x double> %.1298.i, <8 x double> %.1301.i)
  %.1306.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i717, <8 x double> %.1302.i, <8 x double> %.1305.i)
  %.1310.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i717, <8 x double> %.1306.i, <8 x double> %.1309.i)
  %.1317.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i717, <8 x double> %.1313.i, <8 x double> %.1316.i)
  %.1321.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i717, <8 x double> %.1317.i, <8 x double> %.1320.i)
  %.1325.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i717, <8 x double> %.1321.i, <8 x double> %.1324.i)
  %.1332.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i717, <8 x double> %.1328.i, <8 x double> %.1331.i)
  %.1336.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i717, <8 x double> %.1332.i, <8 x double> %.1335.i)
  %.1340.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i717, <8 x double> %.1336.i, <8 x double> %.1339.i)
  %.1347.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i717, <8 x double> %.1343.i, <8 x double> %.1346.i)
  %.1351.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i717, <8 x double> %.1347.i, <8 x double> %.1350.i)
  %.1355.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i717, <8 x double> %.1351.i, <8 x double> %.1354.i)
  %.1362.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i717, <8 x double> %.1358.i, <8 x double> %.1361.i)
  %.1366.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i717, <8 x double> %.1362.i, <8 x double> %.1365.i)
  %.1367.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1236.i, <8 x double> %.1340.i, <8 x double> %.1325.i)
  %scevgep1166 = getelementptr i8, ptr %lsr.iv1164, i64 %.idx3756
  %.1377.i = load <8 x double>, ptr %scevgep1166, align 8, !noalias !24
  %.6.i16.i = fmul contract <8 x double> %.1377.i, %.1367.i
  %.6.i17.i = fmul contract <8 x double> %.1246.i, %.1256.i
  %.1426.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1236.i, <8 x double> %.1366.i, <8 x double> %.1355.i)
  %.1430.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i17.i, <8 x double> %.1429.i, <8 x double> %.1426.i)
  %.1431.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1236.i, <8 x double> %.1310.i, <8 x double> %.1295.i)
  %scevgep1163 = getelementptr i8, ptr %lsr.iv1161, i64 -16512
  %.1441.i = load <8 x double>, ptr %scevgep1163, align 8, !noalias !24
  %.1442.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1246.i, <8 x double> %.1431.i, <8 x double> %.1441.i)
  %.1443.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1256.i, <8 x double> %.1430.i, <8 x double> %.1442.i)
  %.6.i18.i = fadd contract <8 x double> %.6.i16.i, %.1443.i
  %.1450.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1246.i, <8 x double> %.1447.i, <8 x double> %.1449.i)
  %.6.i19.i = fsub contract <8 x double> %.1450.i, %.6.i18.i
  store <8 x double> %.6.i19.i, ptr %lsr.iv1161, align 8, !noalias !24
  %scevgep1162 = getelementptr i8, ptr %lsr.iv1161, i64 64
  %scevgep1165 = getelementptr i8, ptr %lsr.iv1164, i64 64
  %lsr.iv.next = add nsw i64 %lsr.iv, -1
  %.1189.i = icmp sgt i64 %lsr.iv, 6
  br i1 %.1189.i, label %B484.if.i, label %B635280

B22.preheader.i736:                               ; preds = %B635522
  %94 = mul i64 %.5860.sroa.0.0245, -8
  %scevgep1174 = getelementptr i8, ptr %scevgep1160, i64 %94
  br label %B22.i737

B22.i737:                                         ; preds = %B1344.i, %B22.preheader.i736
  %cell.2.0.i738 = phi i64 [ %cell.3.2.i746, %B1344.i ], [ %cells.5.sroa.13.1, %B22.preheader.i736 ]
  %start.2.0.i739 = phi i64 [ %.13.i.i747, %B1344.i ], [ %.13.i589, %B22.preheader.i736 ]
  %.160.i = getelementptr inbounds i64, ptr %.1529, i64 %cell.2.0.i738
  %.161.i = load i64, ptr %.160.i, align 8, !noalias !45
  %.165.not.i = icmp sgt i64 %.161.i, %start.2.0.i739
  br i1 %.165.not.i, label %B112.i745, label %B62.i740

B62.i740:                                         ; preds = %B22.i737, %B62.i740
  %cell.4.1.i741 = phi i64 [ %.168.i, %B62.i740 ], [ %cell.2.0.i738, %B22.i737 ]
  %.168.i = add i64 %cell.4.1.i741, 1
  %sunkaddr.i742 = shl i64 %cell.4.1.i741, 3
  %scevgep1172 = getelementptr i8, ptr %scevgep1171, i64 %sunkaddr.i742
  %.181.i744 = load i64, ptr %scevgep1172, align 8, !noalias !45
  %.183.not.i = icmp sgt i64 %.181.i744, %start.2.0.i739
  br i1 %.183.not.i, label %B112.i745, label %B62.i740

B112.i745:                                        ; preds = %B62.i740, %B22.i737
  %cell.3.2.i746 = phi i64 [ %cell.2.0.i738, %B22.i737 ], [ %.168.i, %B62.i740 ]
  %.195.i = getelementptr inbounds i64, ptr %.1529, i64 %cell.3.2.i746
  %.196.i = load i64, ptr %.195.i, align 8, !noalias !45
  %.13.i.i747 = tail call i64 @llvm.smin.i64(i64 %.13.i587, i64 %.196.i)
  %.529.i = sub i64 %.13.i.i747, %start.2.0.i739
  %95 = add i64 %.529.i, 7
  %.551.i = lshr i64 %95, 3
  %.530.inv.i = icmp slt i64 %.529.i, 1
  %.573363.not375.i = icmp eq i64 %.551.i, 0
  %.573363.not.i = or i1 %.530.inv.i, %.573363.not375.i
  br i1 %.573363.not.i, label %B1344.i, label %B808.if.lr.ph.i

B1344.i:                                          ; preds = %B808.if.i, %B112.i745
  %.751.i = icmp slt i64 %.196.i, %.13.i587
  br i1 %.751.i, label %B22.i737, label %B635600

B808.if.lr.ph.i:                                  ; preds = %B112.i745
  %.261.i = shl nsw i64 %cell.3.2.i746, 3
  %96 = getelementptr double, ptr %.2023, i64 %.261.i
  %.478.i = getelementptr i8, ptr %96, i64 48
  %.479.i748 = load double, ptr %.478.i, align 8, !noalias !45
  %.311.i = or disjoint i64 %.261.i, 5
  %.468.i = getelementptr inbounds double, ptr %.2023, i64 %.311.i
  %.469.i = load double, ptr %.468.i, align 8, !noalias !45
  %.301.i = or disjoint i64 %.261.i, 4
  %.458.i = getelementptr inbounds double, ptr %.2023, i64 %.301.i
  %.459.i = load double, ptr %.458.i, align 8, !noalias !45
  %.291.i749 = or disjoint i64 %.261.i, 3
  %.412.i750 = getelementptr inbounds double, ptr %.2023, i64 %.291.i749
  %.413.i751 = load double, ptr %.412.i750, align 8, !noalias !45
  %.281.i752 = or disjoint i64 %.261.i, 2
  %.402.i = getelementptr inbounds double, ptr %.2023, i64 %.281.i752
  %.403.i = load double, ptr %.402.i, align 8, !noalias !45
  %.271.i = or disjoint i64 %.261.i, 1
  %.392.i = getelementptr inbounds double, ptr %.2023, i64 %.271.i
  %.393.i = load double, ptr %.392.i, align 8, !noalias !45
  %.383.i = load double, ptr %96, align 8, !noalias !45
  %.319.i753 = getelementptr inbounds double, ptr %.1959, i64 %.311.i
  %.320.i = load double, ptr %.319.i753, align 8, !noalias !45
  %.309.i = getelementptr inbounds double, ptr %.1959, i64 %.301.i
  %.310.i = load double, ptr %.309.i, align 8, !noalias !45
  %.299.i = getelementptr inbounds double, ptr %.1959, i64 %.291.i749
  %.300.i = load double, ptr %.299.i, align 8, !noalias !45
  %.289.i = getelementptr inbounds double, ptr %.1959, i64 %.281.i752
  %.290.i = load double, ptr %.289.i, align 8, !noalias !45
  %.279.i754 = getelementptr inbounds double, ptr %.1959, i64 %.271.i
  %.280.i = load double, ptr %.279.i754, align 8, !noalias !45
  %.269.i = getelementptr inbounds double, ptr %.1959, i64 %.261.i
  %.270.i = load double, ptr %.269.i, align 8, !noalias !45
  %.251.i = getelementptr inbounds double, ptr %.7965, i64 %cell.3.2.i746
  %.252.i = load double, ptr %.251.i, align 8, !noalias !45
  %.253.i = fsub contract double 0.000000e+00, %.252.i
  %.239.i = getelementptr inbounds double, ptr %.7900, i64 %cell.3.2.i746
  %.240.i = load double, ptr %.239.i, align 8, !noalias !45
  %.242.i = fmul contract double %.3595, %.240.i
  %.623.i = insertelement <8 x double> poison, double %.242.i, i64 0
  %.624.i = shufflevector <8 x double> %.623.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.625.i = insertelement <8 x double> poison, double %.253.i, i64 0
  %.626.i = shufflevector <8 x double> %.625.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.631.i = insertelement <8 x double> poison, double %.320.i, i64 0
  %.632.i = shufflevector <8 x double> %.631.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.634.i = insertelement <8 x double> poison, double %.310.i, i64 0
  %.635.i = shufflevector <8 x double> %.634.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.638.i = insertelement <8 x double> poison, double %.300.i, i64 0
  %.639.i = shufflevector <8 x double> %.638.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.642.i = insertelement <8 x double> poison, double %.290.i, i64 0
  %.643.i = shufflevector <8 x double> %.642.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.646.i = insertelement <8 x double> poison, double %.280.i, i64 0
  %.647.i755 = shufflevector <8 x double> %.646.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.650.i = insertelement <8 x double> poison, double %.270.i, i64 0
  %.651.i = shufflevector <8 x double> %.650.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.664.i = insertelement <8 x double> poison, double %.479.i748, i64 0
  %.665.i = shufflevector <8 x double> %.664.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.667.i = insertelement <8 x double> poison, double %.469.i, i64 0
  %.668.i = shufflevector <8 x double> %.667.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.671.i = insertelement <8 x double> poison, double %.459.i, i64 0
  %.672.i = shufflevector <8 x double> %.671.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.675.i = insertelement <8 x double> poison, double %.413.i751, i64 0
  %.676.i = shufflevector <8 x double> %.675.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.681.i = insertelement <8 x double> poison, double %.403.i, i64 0
  %.682.i = shufflevector <8 x double> %.681.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.685.i = insertelement <8 x double> poison, double %.393.i, i64 0
  %.686.i = shufflevector <8 x double> %.685.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.689.i = insertelement <8 x double> poison, double %.383.i, i64 0
  %.690.i = shufflevector <8 x double> %.689.i, <8 x double> poison, <8 x i32> zeroinitializer
  %97 = shl i64 %start.2.0.i739, 3
  %98 = add nuw nsw i64 %.551.i, 5
  br label %B808.if.i

B808.if.i:                                        ; preds = %B808.if.i, %B808.if.lr.ph.i
  %lsr.iv28 = phi i64 [ %lsr.iv.next29, %B808.if.i ], [ %98, %B808.if.lr.ph.i ]
  %lsr.iv5.i = phi i64 [ %lsr.iv.next6.i, %B808.if.i ], [ %97, %B808.if.lr.ph.i ]
  %scevgep10.i757 = getelementptr i8, ptr %.335, i64 %lsr.iv5.i
  %.620.i = load <8 x double>, ptr %scevgep10.i757, align 8, !noalias !45
  %.627.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.620.i, <8 x double> %.624.i, <8 x double> %.626.i)
  %.636.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.627.i, <8 x double> %.632.i, <8 x double> %.635.i)
  %.640.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.627.i, <8 x double> %.636.i, <8 x double> %.639.i)
  %.644.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.627.i, <8 x double> %.640.i, <8 x double> %.643.i)
  %.648.i758 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.627.i, <8 x double> %.644.i, <8 x double> %.647.i755)
  %.652.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.627.i, <8 x double> %.648.i758, <8 x double> %.651.i)
  %scevgep1176 = getelementptr i8, ptr %scevgep1174, i64 %lsr.iv5.i
  %scevgep1177 = getelementptr i8, ptr %scevgep1176, i64 -8256
  store <8 x double> %.652.i, ptr %scevgep1177, align 8, !noalias !45
  %.669.i759 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.627.i, <8 x double> %.665.i, <8 x double> %.668.i)
  %.673.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.627.i, <8 x double> %.669.i759, <8 x double> %.672.i)
  %.677.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.627.i, <8 x double> %.673.i, <8 x double> %.676.i)
  %.683.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.627.i, <8 x double> %.677.i, <8 x double> %.682.i)
  %.687.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.627.i, <8 x double> %.683.i, <8 x double> %.686.i)
  %.691.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.627.i, <8 x double> %.687.i, <8 x double> %.690.i)
  store <8 x double> %.691.i, ptr %scevgep1176, align 8, !noalias !45
  %lsr.iv.next6.i = add i64 %lsr.iv5.i, 64
  %lsr.iv.next29 = add nsw i64 %lsr.iv28, -1
  %.573.i = icmp sgt i64 %lsr.iv28, 6
  br i1 %.573.i, label %B808.if.i, label %B1344.i
}

; Function Attrs: nofree noinline norecurse nosync nounwind memory(readwrite, inaccessiblemem: none, target_mem0: none, target_mem1: none)
define internal fastcc void @inner_7(ptr noalias nonnull writeonly captures(none) %retptr, i64 %arg.i, ptr readonly captures(none) %arg.arguments.4) unnamed_addr #4 {
entry:
  %.49 = getelementptr i8, ptr %arg.arguments.4, i64 16
  %.50 = load i64, ptr %.49, align 8
  %.79 = getelementptr i8, ptr %arg.arguments.4, i64 112
  %.80 = load i64, ptr %.79, align 8
  %.119 = getelementptr i8, ptr %arg.arguments.4, i64 168
  %.120 = load i64, ptr %.119, align 8
  %.121.not = icmp eq i64 %.120, 0
  %or.cond.i = icmp ugt i64 %.80, 1
  %or.cond = select i1 %.121.not, i1 true, i1 %or.cond.i
  br i1 %or.cond, label %B254, label %B172

B172:                                             ; preds = %entry
  %.202 = inttoptr i64 %.120 to ptr
  %.278 = load i64, ptr %.202, align 8
  %.283 = mul nsw i64 %.278, %.50
  br label %B254

B254:                                             ; preds = %B172, %entry
  %points.2.0 = phi i64 [ %.283, %B172 ], [ %.50, %entry ]
  %.319 = getelementptr i8, ptr %arg.arguments.4, i64 160
  %.320 = load i64, ptr %.319, align 8
  %.321.not = icmp eq i64 %.320, 0
  br i1 %.321.not, label %B394, label %B298

B298:                                             ; preds = %B254
  %.356 = inttoptr i64 %.320 to ptr
  %0 = tail call i64 @llvm.smin.i64(i64 %arg.i, i64 -1)
  %1 = getelementptr double, ptr %.356, i64 %arg.i
  %2 = getelementptr double, ptr %1, i64 %0
  %.432 = getelementptr i8, ptr %2, i64 8
  store double 0x7FF8000000000000, ptr %.432, align 8
  br label %B394

B394:                                             ; preds = %B298, %B254
  %.439 = icmp ne i64 %.80, 4
  %.449 = zext i1 %.439 to i64
  %"$phi438.0.2.0" = shl nsw i64 %points.2.0, %.449
  %.489 = getelementptr i8, ptr %arg.arguments.4, i64 120
  %.490 = load i64, ptr %.489, align 8
  %.519 = getelementptr i8, ptr %arg.arguments.4, i64 128
  %.520 = load i64, ptr %.519, align 8
  %factor.op.mul470 = mul i64 %"$phi438.0.2.0", %arg.i
  %.661.reass = shl i64 %factor.op.mul470, 2
  %.1023.reass = shl i64 %factor.op.mul470, 3
  %3 = and i64 %.80, -3
  %.614.not = icmp eq i64 %.490, 0
  br i1 %.614.not, label %B744, label %B528

B528:                                             ; preds = %B394
  %4 = icmp eq i64 %3, 1
  %5 = icmp slt i64 %points.2.0, 1
  br i1 %4, label %B580, label %B662

B580:                                             ; preds = %B528
  %.665 = add nsw i64 %.490, %.661.reass
  br i1 %5, label %B744, label %.970.endif.preheader, !prof !1

.970.endif.preheader:                             ; preds = %B580
  %xtraiter66 = and i64 %"$phi438.0.2.0", 7
  %6 = icmp ult i64 %"$phi438.0.2.0", 8
  br i1 %6, label %.970.endif.epil.preheader, label %.970.endif.preheader.new, !prof !48

.970.endif.preheader.new:                         ; preds = %.970.endif.preheader
  %7 = add nsw i64 %"$phi438.0.2.0", -8
  %8 = lshr i64 %7, 3
  %9 = icmp eq i64 %8, 0
  br i1 %9, label %.970.endif.epil.preheader21, label %.970.endif.preheader.new.new, !prof !49

.970.endif.preheader.new.new:                     ; preds = %.970.endif.preheader.new
  %10 = add nuw nsw i64 %8, 1
  %11 = inttoptr i64 %.665 to ptr
  %scevgep147 = getelementptr i8, ptr %11, i64 60
  %12 = and i64 %10, 4611686018427387902
  br label %.970.endif

B662:                                             ; preds = %B528
  %.1027 = add nsw i64 %.490, %.1023.reass
  br i1 %5, label %B744, label %.1331.endif.preheader, !prof !1

.1331.endif.preheader:                            ; preds = %B662
  %xtraiter = and i64 %"$phi438.0.2.0", 7
  %13 = icmp ult i64 %"$phi438.0.2.0", 8
  br i1 %13, label %.1331.endif.epil.preheader, label %.1331.endif.preheader.new, !prof !48

.1331.endif.preheader.new:                        ; preds = %.1331.endif.preheader
  %14 = add nsw i64 %"$phi438.0.2.0", -8
  %15 = lshr i64 %14, 3
  %16 = icmp eq i64 %15, 0
  br i1 %16, label %.1331.endif.epil.preheader11, label %.1331.endif.preheader.new.new, !prof !49

.1331.endif.preheader.new.new:                    ; preds = %.1331.endif.preheader.new
  %17 = add nuw nsw i64 %15, 1
  %18 = inttoptr i64 %.1027 to ptr
  %scevgep189 = getelementptr i8, ptr %18, i64 120
  %19 = and i64 %17, 4611686018427387902
  br label %.1331.endif

B744.sink.split.loopexit.unr-lcssa.unr-lcssa:     ; preds = %.970.endif
  %20 = and i64 %7, 8
  %lcmp.mod26.not.not = icmp eq i64 %20, 0
  br i1 %lcmp.mod26.not.not, label %.970.endif.epil.preheader21, label %B744.sink.split.loopexit.unr-lcssa, !prof !50

.970.endif.epil.preheader21:                      ; preds = %B744.sink.split.loopexit.unr-lcssa.unr-lcssa, %.970.endif.preheader.new
  %.966.0467.epil.init25 = phi i64 [ 0, %.970.endif.preheader.new ], [ %.1011.7.1, %B744.sink.split.loopexit.unr-lcssa.unr-lcssa ]
  %sunkaddr = inttoptr i64 %.665 to ptr
  %sunkaddr222 = shl i64 %.966.0467.epil.init25, 2
  %sunkaddr223 = getelementptr i8, ptr %sunkaddr, i64 %sunkaddr222
  store float 0x7FF8000000000000, ptr %sunkaddr223, align 4
  %sunkaddr227 = getelementptr i8, ptr %sunkaddr223, i64 4
  store float 0x7FF8000000000000, ptr %sunkaddr227, align 4
  %sunkaddr231 = getelementptr i8, ptr %sunkaddr223, i64 8
  store float 0x7FF8000000000000, ptr %sunkaddr231, align 4
  %sunkaddr235 = getelementptr i8, ptr %sunkaddr223, i64 12
  store float 0x7FF8000000000000, ptr %sunkaddr235, align 4
  %sunkaddr239 = getelementptr i8, ptr %sunkaddr223, i64 16
  store float 0x7FF8000000000000, ptr %sunkaddr239, align 4
  %sunkaddr243 = getelementptr i8, ptr %sunkaddr223, i64 20
  store float 0x7FF8000000000000, ptr %sunkaddr243, align 4
  %sunkaddr247 = getelementptr i8, ptr %sunkaddr223, i64 24
  store float 0x7FF8000000000000, ptr %sunkaddr247, align 4
  %sunkaddr251 = getelementptr i8, ptr %sunkaddr223, i64 28
  store float 0x7FF8000000000000, ptr %sunkaddr251, align 4
  %.1011.7.epil = add nuw i64 %.966.0467.epil.init25, 8
  br label %B744.sink.split.loopexit.unr-lcssa

B744.sink.split.loopexit.unr-lcssa:               ; preds = %.970.endif.epil.preheader21, %B744.sink.split.loopexit.unr-lcssa.unr-lcssa
  %.1011.7.lcssa = phi i64 [ %.1011.7.epil, %.970.endif.epil.preheader21 ], [ %.1011.7.1, %B744.sink.split.loopexit.unr-lcssa.unr-lcssa ]
  %lcmp.mod68.not = icmp eq i64 %xtraiter66, 0
  br i1 %lcmp.mod68.not, label %B744, label %.970.endif.epil.preheader, !prof !51

.970.endif.epil.preheader:                        ; preds = %B744.sink.split.loopexit.unr-lcssa, %.970.endif.preheader
  %.966.0467.epil.init = phi i64 [ 0, %.970.endif.preheader ], [ %.1011.7.lcssa, %B744.sink.split.loopexit.unr-lcssa ]
  %21 = inttoptr i64 %.665 to ptr
  %22 = shl i64 %.966.0467.epil.init, 2
  %scevgep126 = getelementptr i8, ptr %21, i64 %22
  br label %.970.endif.epil

.970.endif.epil:                                  ; preds = %.970.endif.epil, %.970.endif.epil.preheader
  %epil.iter67 = phi i64 [ %epil.iter67.next, %.970.endif.epil ], [ 0, %.970.endif.epil.preheader ]
  %23 = shl i64 %epil.iter67, 2
  %scevgep140 = getelementptr i8, ptr %scevgep126, i64 %23
  store float 0x7FF8000000000000, ptr %scevgep140, align 4
  %epil.iter67.next = add i64 %epil.iter67, 1
  %epil.iter67.cmp.not = icmp eq i64 %xtraiter66, %epil.iter67.next
  br i1 %epil.iter67.cmp.not, label %B744, label %.970.endif.epil, !prof !52, !llvm.loop !53

B744.sink.split.loopexit59.unr-lcssa.unr-lcssa:   ; preds = %.1331.endif
  %24 = and i64 %14, 8
  %lcmp.mod.not53.not = icmp eq i64 %24, 0
  br i1 %lcmp.mod.not53.not, label %.1331.endif.epil.preheader11, label %B744.sink.split.loopexit59.unr-lcssa, !prof !50

.1331.endif.epil.preheader11:                     ; preds = %B744.sink.split.loopexit59.unr-lcssa.unr-lcssa, %.1331.endif.preheader.new
  %.1327.0469.epil.init15 = phi i64 [ 0, %.1331.endif.preheader.new ], [ %.1372.7.1, %B744.sink.split.loopexit59.unr-lcssa.unr-lcssa ]
  %sunkaddr252 = inttoptr i64 %.1027 to ptr
  %sunkaddr253 = shl i64 %.1327.0469.epil.init15, 3
  %sunkaddr254 = getelementptr i8, ptr %sunkaddr252, i64 %sunkaddr253
  store double 0x7FF8000000000000, ptr %sunkaddr254, align 8
  %sunkaddr258 = getelementptr i8, ptr %sunkaddr254, i64 8
  store double 0x7FF8000000000000, ptr %sunkaddr258, align 8
  %sunkaddr262 = getelementptr i8, ptr %sunkaddr254, i64 16
  store double 0x7FF8000000000000, ptr %sunkaddr262, align 8
  %sunkaddr266 = getelementptr i8, ptr %sunkaddr254, i64 24
  store double 0x7FF8000000000000, ptr %sunkaddr266, align 8
  %sunkaddr270 = getelementptr i8, ptr %sunkaddr254, i64 32
  store double 0x7FF8000000000000, ptr %sunkaddr270, align 8
  %sunkaddr274 = getelementptr i8, ptr %sunkaddr254, i64 40
  store double 0x7FF8000000000000, ptr %sunkaddr274, align 8
  %sunkaddr278 = getelementptr i8, ptr %sunkaddr254, i64 48
  store double 0x7FF8000000000000, ptr %sunkaddr278, align 8
  %sunkaddr282 = getelementptr i8, ptr %sunkaddr254, i64 56
  store double 0x7FF8000000000000, ptr %sunkaddr282, align 8
  %.1372.7.epil = add nuw i64 %.1327.0469.epil.init15, 8
  br label %B744.sink.split.loopexit59.unr-lcssa

B744.sink.split.loopexit59.unr-lcssa:             ; preds = %.1331.endif.epil.preheader11, %B744.sink.split.loopexit59.unr-lcssa.unr-lcssa
  %.1372.7.lcssa = phi i64 [ %.1372.7.epil, %.1331.endif.epil.preheader11 ], [ %.1372.7.1, %B744.sink.split.loopexit59.unr-lcssa.unr-lcssa ]
  %lcmp.mod.not = icmp eq i64 %xtraiter, 0
  br i1 %lcmp.mod.not, label %B744, label %.1331.endif.epil.preheader, !prof !51

.1331.endif.epil.preheader:                       ; preds = %B744.sink.split.loopexit59.unr-lcssa, %.1331.endif.preheader
  %.1327.0469.epil.init = phi i64 [ 0, %.1331.endif.preheader ], [ %.1372.7.lcssa, %B744.sink.split.loopexit59.unr-lcssa ]
  %25 = inttoptr i64 %.1027 to ptr
  %26 = shl i64 %.1327.0469.epil.init, 3
  %scevgep144 = getelementptr i8, ptr %25, i64 %26
  br label %.1331.endif.epil

.1331.endif.epil:                                 ; preds = %.1331.endif.epil, %.1331.endif.epil.preheader
  %epil.iter = phi i64 [ %epil.iter.next, %.1331.endif.epil ], [ 0, %.1331.endif.epil.preheader ]
  %27 = shl i64 %epil.iter, 3
  %scevgep188 = getelementptr i8, ptr %scevgep144, i64 %27
  store double 0x7FF8000000000000, ptr %scevgep188, align 8
  %epil.iter.next = add i64 %epil.iter, 1
  %epil.iter.cmp.not = icmp eq i64 %xtraiter, %epil.iter.next
  br i1 %epil.iter.cmp.not, label %B744, label %.1331.endif.epil, !prof !52, !llvm.loop !56

B744:                                             ; preds = %.1331.endif.epil, %.970.endif.epil, %B744.sink.split.loopexit59.unr-lcssa, %B744.sink.split.loopexit.unr-lcssa, %B662, %B580, %B394
  %.614.not.1 = icmp eq i64 %.520, 0
  br i1 %.614.not.1, label %B744.1, label %B528.1

B528.1:                                           ; preds = %B744
  %28 = icmp eq i64 %3, 1
  %29 = icmp slt i64 %points.2.0, 1
  br i1 %28, label %B580.1, label %B662.1

B662.1:                                           ; preds = %B528.1
  %.1027.1 = add nsw i64 %.520, %.1023.reass
  br i1 %29, label %B744.1, label %.1331.endif.1.preheader, !prof !1

.1331.endif.1.preheader:                          ; preds = %B662.1
  %xtraiter77 = and i64 %"$phi438.0.2.0", 7
  %30 = icmp ult i64 %"$phi438.0.2.0", 8
  br i1 %30, label %.1331.endif.1.epil.preheader, label %.1331.endif.1.preheader.new, !prof !48

.1331.endif.1.preheader.new:                      ; preds = %.1331.endif.1.preheader
  %31 = add nsw i64 %"$phi438.0.2.0", -8
  %32 = lshr i64 %31, 3
  %33 = icmp eq i64 %32, 0
  br i1 %33, label %.1331.endif.1.epil.preheader33, label %.1331.endif.1.preheader.new.new, !prof !49

.1331.endif.1.preheader.new.new:                  ; preds = %.1331.endif.1.preheader.new
  %34 = add nuw nsw i64 %32, 1
  %35 = inttoptr i64 %.1027.1 to ptr
  %scevgep89 = getelementptr i8, ptr %35, i64 120
  %36 = and i64 %34, 4611686018427387902
  br label %.1331.endif.1

.1331.endif.1:                                    ; preds = %.1331.endif.1, %.1331.endif.1.preheader.new.new
  %lsr.iv72 = phi i64 [ %lsr.iv.next73, %.1331.endif.1 ], [ %36, %.1331.endif.1.preheader.new.new ]
  %.1327.0469.1 = phi i64 [ %.1372.1.7.1, %.1331.endif.1 ], [ 0, %.1331.endif.1.preheader.new.new ]
  %37 = shl i64 %.1327.0469.1, 3
  %scevgep106 = getelementptr i8, ptr %scevgep89, i64 %37
  %scevgep107 = getelementptr i8, ptr %scevgep106, i64 -64
  %scevgep136 = getelementptr i8, ptr %scevgep106, i64 -120
  store double 0x7FF8000000000000, ptr %scevgep136, align 8
  %scevgep134 = getelementptr i8, ptr %scevgep106, i64 -112
  store double 0x7FF8000000000000, ptr %scevgep134, align 8
  %scevgep127 = getelementptr i8, ptr %scevgep106, i64 -104
  store double 0x7FF8000000000000, ptr %scevgep127, align 8
  %scevgep122 = getelementptr i8, ptr %scevgep106, i64 -96
  store double 0x7FF8000000000000, ptr %scevgep122, align 8
  %scevgep118 = getelementptr i8, ptr %scevgep106, i64 -88
  store double 0x7FF8000000000000, ptr %scevgep118, align 8
  %scevgep114 = getelementptr i8, ptr %scevgep106, i64 -80
  store double 0x7FF8000000000000, ptr %scevgep114, align 8
  %scevgep110 = getelementptr i8, ptr %scevgep106, i64 -72
  store double 0x7FF8000000000000, ptr %scevgep110, align 8
  store double 0x7FF8000000000000, ptr %scevgep107, align 8
  %scevgep104 = getelementptr i8, ptr %scevgep106, i64 -56
  store double 0x7FF8000000000000, ptr %scevgep104, align 8
  %scevgep101 = getelementptr i8, ptr %scevgep106, i64 -48
  store double 0x7FF8000000000000, ptr %scevgep101, align 8
  %scevgep97 = getelementptr i8, ptr %scevgep106, i64 -40
  store double 0x7FF8000000000000, ptr %scevgep97, align 8
  %scevgep93 = getelementptr i8, ptr %scevgep106, i64 -32
  store double 0x7FF8000000000000, ptr %scevgep93, align 8
  %scevgep85 = getelementptr i8, ptr %scevgep106, i64 -24
  store double 0x7FF8000000000000, ptr %scevgep85, align 8
  %scevgep81 = getelementptr i8, ptr %scevgep106, i64 -16
  store double 0x7FF8000000000000, ptr %scevgep81, align 8
  %scevgep77 = getelementptr i8, ptr %scevgep106, i64 -8
  store double 0x7FF8000000000000, ptr %scevgep77, align 8
  store double 0x7FF8000000000000, ptr %scevgep106, align 8
  %.1372.1.7.1 = add i64 %.1327.0469.1, 16
  %lsr.iv.next73 = add i64 %lsr.iv72, -2
  %niter42.ncmp.1 = icmp eq i64 %lsr.iv.next73, 0
  br i1 %niter42.ncmp.1, label %B744.1.sink.split.loopexit58.unr-lcssa.unr-lcssa, label %.1331.endif.1, !prof !57, !llvm.loop !58

B580.1:                                           ; preds = %B528.1
  %.665.1 = add nsw i64 %.520, %.661.reass
  br i1 %29, label %B744.1, label %.970.endif.1.preheader, !prof !1

.970.endif.1.preheader:                           ; preds = %B580.1
  %xtraiter83 = and i64 %"$phi438.0.2.0", 7
  %38 = icmp ult i64 %"$phi438.0.2.0", 8
  br i1 %38, label %.970.endif.1.epil.preheader, label %.970.endif.1.preheader.new, !prof !48

.970.endif.1.preheader.new:                       ; preds = %.970.endif.1.preheader
  %39 = add nsw i64 %"$phi438.0.2.0", -8
  %40 = lshr i64 %39, 3
  %41 = icmp eq i64 %40, 0
  br i1 %41, label %.970.endif.1.epil.preheader43, label %.970.endif.1.preheader.new.new, !prof !49

.970.endif.1.preheader.new.new:                   ; preds = %.970.endif.1.preheader.new
  %42 = add nuw nsw i64 %40, 1
  %43 = inttoptr i64 %.665.1 to ptr
  %scevgep57 = getelementptr i8, ptr %43, i64 60
  %44 = and i64 %42, 4611686018427387902
  br label %.970.endif.1

.970.endif.1:                                     ; preds = %.970.endif.1, %.970.endif.1.preheader.new.new
  %lsr.iv20 = phi i64 [ %lsr.iv.next21, %.970.endif.1 ], [ %44, %.970.endif.1.preheader.new.new ]
  %.966.0467.1 = phi i64 [ %.1011.1.7.1, %.970.endif.1 ], [ 0, %.970.endif.1.preheader.new.new ]
  %45 = shl i64 %.966.0467.1, 2
  %scevgep73 = getelementptr i8, ptr %scevgep57, i64 %45
  %scevgep74 = getelementptr i8, ptr %scevgep73, i64 -32
  %scevgep87 = getelementptr i8, ptr %scevgep73, i64 -60
  store float 0x7FF8000000000000, ptr %scevgep87, align 4
  %scevgep86 = getelementptr i8, ptr %scevgep73, i64 -56
  store float 0x7FF8000000000000, ptr %scevgep86, align 4
  %scevgep71 = getelementptr i8, ptr %scevgep73, i64 -52
  store float 0x7FF8000000000000, ptr %scevgep71, align 4
  %scevgep67 = getelementptr i8, ptr %scevgep73, i64 -48
  store float 0x7FF8000000000000, ptr %scevgep67, align 4
  %scevgep63 = getelementptr i8, ptr %scevgep73, i64 -44
  store float 0x7FF8000000000000, ptr %scevgep63, align 4
  %scevgep59 = getelementptr i8, ptr %scevgep73, i64 -40
  store float 0x7FF8000000000000, ptr %scevgep59, align 4
  %scevgep53 = getelementptr i8, ptr %scevgep73, i64 -36
  store float 0x7FF8000000000000, ptr %scevgep53, align 4
  store float 0x7FF8000000000000, ptr %scevgep74, align 4
  %scevgep49 = getelementptr i8, ptr %scevgep73, i64 -28
  store float 0x7FF8000000000000, ptr %scevgep49, align 4
  %scevgep45 = getelementptr i8, ptr %scevgep73, i64 -24
  store float 0x7FF8000000000000, ptr %scevgep45, align 4
  %scevgep41 = getelementptr i8, ptr %scevgep73, i64 -20
  store float 0x7FF8000000000000, ptr %scevgep41, align 4
  %scevgep37 = getelementptr i8, ptr %scevgep73, i64 -16
  store float 0x7FF8000000000000, ptr %scevgep37, align 4
  %scevgep33 = getelementptr i8, ptr %scevgep73, i64 -12
  store float 0x7FF8000000000000, ptr %scevgep33, align 4
  %scevgep29 = getelementptr i8, ptr %scevgep73, i64 -8
  store float 0x7FF8000000000000, ptr %scevgep29, align 4
  %scevgep25 = getelementptr i8, ptr %scevgep73, i64 -4
  store float 0x7FF8000000000000, ptr %scevgep25, align 4
  store float 0x7FF8000000000000, ptr %scevgep73, align 4
  %.1011.1.7.1 = add i64 %.966.0467.1, 16
  %lsr.iv.next21 = add i64 %lsr.iv20, -2
  %niter52.ncmp.1 = icmp eq i64 %lsr.iv.next21, 0
  br i1 %niter52.ncmp.1, label %B744.1.sink.split.loopexit.unr-lcssa.unr-lcssa, label %.970.endif.1, !prof !57, !llvm.loop !60

B744.1.sink.split.loopexit.unr-lcssa.unr-lcssa:   ; preds = %.970.endif.1
  %46 = and i64 %39, 8
  %lcmp.mod48.not.not = icmp eq i64 %46, 0
  br i1 %lcmp.mod48.not.not, label %.970.endif.1.epil.preheader43, label %B744.1.sink.split.loopexit.unr-lcssa, !prof !50

.970.endif.1.epil.preheader43:                    ; preds = %B744.1.sink.split.loopexit.unr-lcssa.unr-lcssa, %.970.endif.1.preheader.new
  %.966.0467.1.epil.init47 = phi i64 [ 0, %.970.endif.1.preheader.new ], [ %.1011.1.7.1, %B744.1.sink.split.loopexit.unr-lcssa.unr-lcssa ]
  %sunkaddr283 = inttoptr i64 %.665.1 to ptr
  %sunkaddr284 = shl i64 %.966.0467.1.epil.init47, 2
  %sunkaddr285 = getelementptr i8, ptr %sunkaddr283, i64 %sunkaddr284
  store float 0x7FF8000000000000, ptr %sunkaddr285, align 4
  %sunkaddr289 = getelementptr i8, ptr %sunkaddr285, i64 4
  store float 0x7FF8000000000000, ptr %sunkaddr289, align 4
  %sunkaddr293 = getelementptr i8, ptr %sunkaddr285, i64 8
  store float 0x7FF8000000000000, ptr %sunkaddr293, align 4
  %sunkaddr297 = getelementptr i8, ptr %sunkaddr285, i64 12
  store float 0x7FF8000000000000, ptr %sunkaddr297, align 4
  %sunkaddr301 = getelementptr i8, ptr %sunkaddr285, i64 16
  store float 0x7FF8000000000000, ptr %sunkaddr301, align 4
  %sunkaddr305 = getelementptr i8, ptr %sunkaddr285, i64 20
  store float 0x7FF8000000000000, ptr %sunkaddr305, align 4
  %sunkaddr309 = getelementptr i8, ptr %sunkaddr285, i64 24
  store float 0x7FF8000000000000, ptr %sunkaddr309, align 4
  %sunkaddr313 = getelementptr i8, ptr %sunkaddr285, i64 28
  store float 0x7FF8000000000000, ptr %sunkaddr313, align 4
  %.1011.1.7.epil = add nuw i64 %.966.0467.1.epil.init47, 8
  br label %B744.1.sink.split.loopexit.unr-lcssa

B744.1.sink.split.loopexit.unr-lcssa:             ; preds = %.970.endif.1.epil.preheader43, %B744.1.sink.split.loopexit.unr-lcssa.unr-lcssa
  %.1011.1.7.lcssa = phi i64 [ %.1011.1.7.epil, %.970.endif.1.epil.preheader43 ], [ %.1011.1.7.1, %B744.1.sink.split.loopexit.unr-lcssa.unr-lcssa ]
  %lcmp.mod85.not = icmp eq i64 %xtraiter83, 0
  br i1 %lcmp.mod85.not, label %B744.1, label %.970.endif.1.epil.preheader, !prof !51

.970.endif.1.epil.preheader:                      ; preds = %B744.1.sink.split.loopexit.unr-lcssa, %.970.endif.1.preheader
  %.966.0467.1.epil.init = phi i64 [ 0, %.970.endif.1.preheader ], [ %.1011.1.7.lcssa, %B744.1.sink.split.loopexit.unr-lcssa ]
  %47 = inttoptr i64 %.665.1 to ptr
  %48 = shl i64 %.966.0467.1.epil.init, 2
  %scevgep = getelementptr i8, ptr %47, i64 %48
  br label %.970.endif.1.epil

.970.endif.1.epil:                                ; preds = %.970.endif.1.epil, %.970.endif.1.epil.preheader
  %epil.iter84 = phi i64 [ %epil.iter84.next, %.970.endif.1.epil ], [ 0, %.970.endif.1.epil.preheader ]
  %49 = shl i64 %epil.iter84, 2
  %scevgep56 = getelementptr i8, ptr %scevgep, i64 %49
  store float 0x7FF8000000000000, ptr %scevgep56, align 4
  %epil.iter84.next = add i64 %epil.iter84, 1
  %epil.iter84.cmp.not = icmp eq i64 %xtraiter83, %epil.iter84.next
  br i1 %epil.iter84.cmp.not, label %B744.1, label %.970.endif.1.epil, !prof !52, !llvm.loop !61

B744.1.sink.split.loopexit58.unr-lcssa.unr-lcssa: ; preds = %.1331.endif.1
  %50 = and i64 %31, 8
  %lcmp.mod38.not.not = icmp eq i64 %50, 0
  br i1 %lcmp.mod38.not.not, label %.1331.endif.1.epil.preheader33, label %B744.1.sink.split.loopexit58.unr-lcssa, !prof !50

.1331.endif.1.epil.preheader33:                   ; preds = %B744.1.sink.split.loopexit58.unr-lcssa.unr-lcssa, %.1331.endif.1.preheader.new
  %.1327.0469.1.epil.init37 = phi i64 [ 0, %.1331.endif.1.preheader.new ], [ %.1372.1.7.1, %B744.1.sink.split.loopexit58.unr-lcssa.unr-lcssa ]
  %sunkaddr314 = inttoptr i64 %.1027.1 to ptr
  %sunkaddr315 = shl i64 %.1327.0469.1.epil.init37, 3
  %sunkaddr316 = getelementptr i8, ptr %sunkaddr314, i64 %sunkaddr315
  store double 0x7FF8000000000000, ptr %sunkaddr316, align 8
  %sunkaddr320 = getelementptr i8, ptr %sunkaddr316, i64 8
  store double 0x7FF8000000000000, ptr %sunkaddr320, align 8
  %sunkaddr324 = getelementptr i8, ptr %sunkaddr316, i64 16
  store double 0x7FF8000000000000, ptr %sunkaddr324, align 8
  %sunkaddr328 = getelementptr i8, ptr %sunkaddr316, i64 24
  store double 0x7FF8000000000000, ptr %sunkaddr328, align 8
  %sunkaddr332 = getelementptr i8, ptr %sunkaddr316, i64 32
  store double 0x7FF8000000000000, ptr %sunkaddr332, align 8
  %sunkaddr336 = getelementptr i8, ptr %sunkaddr316, i64 40
  store double 0x7FF8000000000000, ptr %sunkaddr336, align 8
  %sunkaddr340 = getelementptr i8, ptr %sunkaddr316, i64 48
  store double 0x7FF8000000000000, ptr %sunkaddr340, align 8
  %sunkaddr344 = getelementptr i8, ptr %sunkaddr316, i64 56
  store double 0x7FF8000000000000, ptr %sunkaddr344, align 8
  %.1372.1.7.epil = add nuw i64 %.1327.0469.1.epil.init37, 8
  br label %B744.1.sink.split.loopexit58.unr-lcssa

B744.1.sink.split.loopexit58.unr-lcssa:           ; preds = %.1331.endif.1.epil.preheader33, %B744.1.sink.split.loopexit58.unr-lcssa.unr-lcssa
  %.1372.1.7.lcssa = phi i64 [ %.1372.1.7.epil, %.1331.endif.1.epil.preheader33 ], [ %.1372.1.7.1, %B744.1.sink.split.loopexit58.unr-lcssa.unr-lcssa ]
  %lcmp.mod79.not = icmp eq i64 %xtraiter77, 0
  br i1 %lcmp.mod79.not, label %B744.1, label %.1331.endif.1.epil.preheader, !prof !51

.1331.endif.1.epil.preheader:                     ; preds = %B744.1.sink.split.loopexit58.unr-lcssa, %.1331.endif.1.preheader
  %.1327.0469.1.epil.init = phi i64 [ 0, %.1331.endif.1.preheader ], [ %.1372.1.7.lcssa, %B744.1.sink.split.loopexit58.unr-lcssa ]
  %51 = inttoptr i64 %.1027.1 to ptr
  %52 = shl i64 %.1327.0469.1.epil.init, 3
  %scevgep108 = getelementptr i8, ptr %51, i64 %52
  br label %.1331.endif.1.epil

.1331.endif.1.epil:                               ; preds = %.1331.endif.1.epil, %.1331.endif.1.epil.preheader
  %epil.iter78 = phi i64 [ %epil.iter78.next, %.1331.endif.1.epil ], [ 0, %.1331.endif.1.epil.preheader ]
  %53 = shl i64 %epil.iter78, 3
  %scevgep88 = getelementptr i8, ptr %scevgep108, i64 %53
  store double 0x7FF8000000000000, ptr %scevgep88, align 8
  %epil.iter78.next = add i64 %epil.iter78, 1
  %epil.iter78.cmp.not = icmp eq i64 %xtraiter77, %epil.iter78.next
  br i1 %epil.iter78.cmp.not, label %B744.1, label %.1331.endif.1.epil, !prof !52, !llvm.loop !62

B744.1:                                           ; preds = %.1331.endif.1.epil, %.970.endif.1.epil, %B744.1.sink.split.loopexit58.unr-lcssa, %B744.1.sink.split.loopexit.unr-lcssa, %B580.1, %B662.1, %B744
  store ptr null, ptr %retptr, align 8
  ret void

.970.endif:                                       ; preds = %.970.endif, %.970.endif.preheader.new.new
  %lsr.iv = phi i64 [ %lsr.iv.next, %.970.endif ], [ %12, %.970.endif.preheader.new.new ]
  %.966.0467 = phi i64 [ %.1011.7.1, %.970.endif ], [ 0, %.970.endif.preheader.new.new ]
  %54 = shl i64 %.966.0467, 2
  %scevgep171 = getelementptr i8, ptr %scevgep147, i64 %54
  %scevgep172 = getelementptr i8, ptr %scevgep171, i64 -32
  %scevgep185 = getelementptr i8, ptr %scevgep171, i64 -60
  store float 0x7FF8000000000000, ptr %scevgep185, align 4
  %scevgep184 = getelementptr i8, ptr %scevgep171, i64 -56
  store float 0x7FF8000000000000, ptr %scevgep184, align 4
  %scevgep159 = getelementptr i8, ptr %scevgep171, i64 -52
  store float 0x7FF8000000000000, ptr %scevgep159, align 4
  %scevgep157 = getelementptr i8, ptr %scevgep171, i64 -48
  store float 0x7FF8000000000000, ptr %scevgep157, align 4
  %scevgep155 = getelementptr i8, ptr %scevgep171, i64 -44
  store float 0x7FF8000000000000, ptr %scevgep155, align 4
  %scevgep153 = getelementptr i8, ptr %scevgep171, i64 -40
  store float 0x7FF8000000000000, ptr %scevgep153, align 4
  %scevgep151 = getelementptr i8, ptr %scevgep171, i64 -36
  store float 0x7FF8000000000000, ptr %scevgep151, align 4
  store float 0x7FF8000000000000, ptr %scevgep172, align 4
  %scevgep149 = getelementptr i8, ptr %scevgep171, i64 -28
  store float 0x7FF8000000000000, ptr %scevgep149, align 4
  %scevgep146 = getelementptr i8, ptr %scevgep171, i64 -24
  store float 0x7FF8000000000000, ptr %scevgep146, align 4
  %scevgep143 = getelementptr i8, ptr %scevgep171, i64 -20
  store float 0x7FF8000000000000, ptr %scevgep143, align 4
  %scevgep141 = getelementptr i8, ptr %scevgep171, i64 -16
  store float 0x7FF8000000000000, ptr %scevgep141, align 4
  %scevgep138 = getelementptr i8, ptr %scevgep171, i64 -12
  store float 0x7FF8000000000000, ptr %scevgep138, align 4
  %scevgep135 = getelementptr i8, ptr %scevgep171, i64 -8
  store float 0x7FF8000000000000, ptr %scevgep135, align 4
  %scevgep131 = getelementptr i8, ptr %scevgep171, i64 -4
  store float 0x7FF8000000000000, ptr %scevgep131, align 4
  store float 0x7FF8000000000000, ptr %scevgep171, align 4
  %.1011.7.1 = add i64 %.966.0467, 16
  %lsr.iv.next = add i64 %lsr.iv, -2
  %niter30.ncmp.1 = icmp eq i64 %lsr.iv.next, 0
  br i1 %niter30.ncmp.1, label %B744.sink.split.loopexit.unr-lcssa.unr-lcssa, label %.970.endif, !prof !57, !llvm.loop !63

.1331.endif:                                      ; preds = %.1331.endif, %.1331.endif.preheader.new.new
  %lsr.iv160 = phi i64 [ %lsr.iv.next161, %.1331.endif ], [ %19, %.1331.endif.preheader.new.new ]
  %.1327.0469 = phi i64 [ %.1372.7.1, %.1331.endif ], [ 0, %.1331.endif.preheader.new.new ]
  %55 = shl i64 %.1327.0469, 3
  %scevgep205 = getelementptr i8, ptr %scevgep189, i64 %55
  %scevgep206 = getelementptr i8, ptr %scevgep205, i64 -64
  %scevgep219 = getelementptr i8, ptr %scevgep205, i64 -120
  store double 0x7FF8000000000000, ptr %scevgep219, align 8
  %scevgep218 = getelementptr i8, ptr %scevgep205, i64 -112
  store double 0x7FF8000000000000, ptr %scevgep218, align 8
  %scevgep191 = getelementptr i8, ptr %scevgep205, i64 -104
  store double 0x7FF8000000000000, ptr %scevgep191, align 8
  %scevgep187 = getelementptr i8, ptr %scevgep205, i64 -96
  store double 0x7FF8000000000000, ptr %scevgep187, align 8
  %scevgep183 = getelementptr i8, ptr %scevgep205, i64 -88
  store double 0x7FF8000000000000, ptr %scevgep183, align 8
  %scevgep181 = getelementptr i8, ptr %scevgep205, i64 -80
  store double 0x7FF8000000000000, ptr %scevgep181, align 8
  %scevgep179 = getelementptr i8, ptr %scevgep205, i64 -72
  store double 0x7FF8000000000000, ptr %scevgep179, align 8
  store double 0x7FF8000000000000, ptr %scevgep206, align 8
  %scevgep177 = getelementptr i8, ptr %scevgep205, i64 -56
  store double 0x7FF8000000000000, ptr %scevgep177, align 8
  %scevgep175 = getelementptr i8, ptr %scevgep205, i64 -48
  store double 0x7FF8000000000000, ptr %scevgep175, align 8
  %scevgep173 = getelementptr i8, ptr %scevgep205, i64 -40
  store double 0x7FF8000000000000, ptr %scevgep173, align 8
  %scevgep169 = getelementptr i8, ptr %scevgep205, i64 -32
  store double 0x7FF8000000000000, ptr %scevgep169, align 8
  %scevgep167 = getelementptr i8, ptr %scevgep205, i64 -24
  store double 0x7FF8000000000000, ptr %scevgep167, align 8
  %scevgep165 = getelementptr i8, ptr %scevgep205, i64 -16
  store double 0x7FF8000000000000, ptr %scevgep165, align 8
  %scevgep163 = getelementptr i8, ptr %scevgep205, i64 -8
  store double 0x7FF8000000000000, ptr %scevgep163, align 8
  store double 0x7FF8000000000000, ptr %scevgep205, align 8
  %.1372.7.1 = add i64 %.1327.0469, 16
  %lsr.iv.next161 = add i64 %lsr.iv160, -2
  %niter.ncmp.1 = icmp eq i64 %lsr.iv.next161, 0
  br i1 %niter.ncmp.1, label %B744.sink.split.loopexit59.unr-lcssa.unr-lcssa, label %.1331.endif, !prof !57, !llvm.loop !64
}

; Function Attrs: nofree noinline norecurse nosync nounwind memory(readwrite, inaccessiblemem: none, target_mem0: none, target_mem1: none)
define internal fastcc void @inner_8(ptr noalias nonnull writeonly captures(none) %retptr, ptr readonly captures(none) %arg.coordinates.4, i64 %arg.rows, ptr readonly captures(none) %arg.contents.4, ptr readonly captures(none) %arg.exponents.4, ptr readonly captures(none) %arg.weights.4, i64 %arg.width, ptr writeonly captures(none) %arg.linear.4, ptr initializes((56, 64)) %arg.scratch.4) unnamed_addr #4 {
entry:
  %.86 = alloca { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, align 8
  %.fca.1.gep233 = getelementptr inbounds nuw i8, ptr %.86, i64 8
  %.fca.2.gep234 = getelementptr inbounds nuw i8, ptr %.86, i64 16
  %.fca.3.gep235 = getelementptr inbounds nuw i8, ptr %.86, i64 24
  %.fca.4.gep236 = getelementptr inbounds nuw i8, ptr %.86, i64 32
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(56) %.86, i8 0, i64 56, i1 false)
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(56) %.86, i8 0, i64 56, i1 false)
  call fastcc void @inner_15(ptr nonnull %.86, ptr %arg.coordinates.4, i64 %arg.rows, ptr %arg.contents.4, ptr %arg.exponents.4, ptr %arg.weights.4, ptr %arg.scratch.4)
  %.110.fca.0.load = load ptr, ptr %.86, align 8
  %.110.fca.1.load = load ptr, ptr %.fca.1.gep233, align 8
  %.110.fca.2.load = load i64, ptr %.fca.2.gep234, align 8
  %.110.fca.3.load = load i64, ptr %.fca.3.gep235, align 8
  %.110.fca.4.load = load ptr, ptr %.fca.4.gep236, align 8
  %.fca.6.0.gep238 = getelementptr inbounds nuw i8, ptr %.86, i64 48
  %.fca.5.0.gep237 = getelementptr inbounds nuw i8, ptr %.86, i64 40
  %.110.fca.5.0.load = load i64, ptr %.fca.5.0.gep237, align 8
  %.110.fca.6.0.load = load i64, ptr %.fca.6.0.gep238, align 8
  %.177 = getelementptr i8, ptr %arg.contents.4, i64 24
  %.255 = getelementptr i8, ptr %arg.contents.4, i64 104
  %.256 = load i64, ptr %.255, align 8
  %.269 = getelementptr double, ptr %arg.weights.4, i64 %.256
  %0 = add nuw i64 %arg.rows, 3
  %.384 = lshr i64 %0, 2
  %.363.inv = icmp slt i64 %arg.rows, 1
  %.405319.not329 = icmp eq i64 %.384, 0
  %.405319.not = select i1 %.363.inv, i1 true, i1 %.405319.not329
  br i1 %.405319.not, label %B452, label %B242.if.preheader

B452:                                             ; preds = %B244.endif.endif.endif, %entry
  store ptr %.110.fca.0.load, ptr %retptr, align 8
  %retptr.repack298 = getelementptr inbounds nuw i8, ptr %retptr, i64 8
  store ptr %.110.fca.1.load, ptr %retptr.repack298, align 8
  %retptr.repack300 = getelementptr inbounds nuw i8, ptr %retptr, i64 16
  store i64 %.110.fca.2.load, ptr %retptr.repack300, align 8
  %retptr.repack302 = getelementptr inbounds nuw i8, ptr %retptr, i64 24
  store i64 %.110.fca.3.load, ptr %retptr.repack302, align 8
  %retptr.repack304 = getelementptr inbounds nuw i8, ptr %retptr, i64 32
  store ptr %.110.fca.4.load, ptr %retptr.repack304, align 8
  %retptr.repack306 = getelementptr inbounds nuw i8, ptr %retptr, i64 40
  store i64 %.110.fca.5.0.load, ptr %retptr.repack306, align 8
  %retptr.repack308 = getelementptr inbounds nuw i8, ptr %retptr, i64 48
  store i64 %.110.fca.6.0.load, ptr %retptr.repack308, align 8
  ret void

B242.if.preheader:                                ; preds = %entry
  %.178 = load i64, ptr %.177, align 8
  %.179 = sub i64 0, %.178
  %1 = tail call i64 @llvm.smax.i64(i64 %arg.width, i64 31)
  %storemerge.i = lshr i64 %1, 5
  %.1046.i = and i64 %arg.width, -32
  %.1086.i = and i64 %arg.width, 31
  %.1087.not.i = icmp eq i64 %.1086.i, 0
  %.880.idx.i = shl i64 %arg.width, 4
  %.950.idx.i = mul i64 %arg.width, 24
  %scevgep17.i = getelementptr i8, ptr %.269, i64 192
  %2 = and i64 %1, 9223372036854775776
  %.1102.i = and i64 %arg.width, 7
  %.1105.not.i = icmp ne i64 %.1102.i, 0
  %.1106806.i = lshr i64 %.1086.i, 3
  %.1107.i = zext i1 %.1105.not.i to i64
  %.1108.i = add nuw nsw i64 %.1106806.i, %.1107.i
  %.1129898.not.i = icmp eq i64 %.1108.i, 0
  %brmerge = select i1 %.1087.not.i, i1 true, i1 %.1129898.not.i
  %3 = lshr i64 %.179, 3
  %.neg = mul i64 %3, -192
  %4 = getelementptr i8, ptr %.110.fca.4.load, i64 %.neg
  %scevgep = getelementptr i8, ptr %4, i64 248
  %5 = shl i64 %3, 8
  %6 = sub i64 256, %5
  %7 = shl i64 %3, 7
  %8 = sub i64 184, %7
  %scevgep48 = getelementptr i8, ptr %.110.fca.4.load, i64 %8
  %9 = shl i64 %3, 6
  %10 = sub i64 120, %9
  %scevgep53 = getelementptr i8, ptr %.110.fca.4.load, i64 %10
  %11 = icmp eq i64 %storemerge.i, 0
  br label %B242.if

B242.if:                                          ; preds = %B244.endif.endif.endif, %B242.if.preheader
  %lsr.iv58 = phi ptr [ %.110.fca.4.load, %B242.if.preheader ], [ %scevgep59, %B244.endif.endif.endif ]
  %lsr.iv54 = phi ptr [ %scevgep53, %B242.if.preheader ], [ %scevgep55, %B244.endif.endif.endif ]
  %lsr.iv49 = phi ptr [ %scevgep48, %B242.if.preheader ], [ %scevgep50, %B244.endif.endif.endif ]
  %lsr.iv44 = phi ptr [ %scevgep, %B242.if.preheader ], [ %scevgep45, %B244.endif.endif.endif ]
  %.404313321 = phi i64 [ %.384, %B242.if.preheader ], [ %.414, %B244.endif.endif.endif ]
  %.411316320 = phi i64 [ 0, %B242.if.preheader ], [ %.418, %B244.endif.endif.endif ]
  %.414 = add nsw i64 %.404313321, -1
  %.418 = add nuw i64 %.411316320, 4
  %.511 = mul nsw i64 %.411316320, %arg.width
  %.522 = getelementptr inbounds double, ptr %arg.linear.4, i64 %.511
  %.603 = load i64, ptr %.177, align 8
  %.604 = add i64 %.603, 1
  br i1 %11, label %B354.else.i, label %B84.if.lr.ph.i

B84.if.lr.ph.i:                                   ; preds = %B242.if
  %12 = shl i64 %.604, 8
  %13 = icmp slt i64 %.603, 0
  br label %B84.if.i

B280.i:                                           ; preds = %B200.if.i, %B84.if.i
  %_multiply_wide_v86_a00.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B84.if.i ], [ %.577.i, %B200.if.i ]
  %_multiply_wide_v86_a01.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B84.if.i ], [ %.581.i, %B200.if.i ]
  %_multiply_wide_v86_a02.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B84.if.i ], [ %.589.i, %B200.if.i ]
  %_multiply_wide_v86_a03.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B84.if.i ], [ %.593.i, %B200.if.i ]
  %_multiply_wide_v86_a10.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B84.if.i ], [ %.614.i, %B200.if.i ]
  %_multiply_wide_v86_a11.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B84.if.i ], [ %.618.i, %B200.if.i ]
  %_multiply_wide_v86_a12.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B84.if.i ], [ %.626.i, %B200.if.i ]
  %_multiply_wide_v86_a13.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B84.if.i ], [ %.630.i, %B200.if.i ]
  %_multiply_wide_v86_a20.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B84.if.i ], [ %.652.i, %B200.if.i ]
  %_multiply_wide_v86_a21.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B84.if.i ], [ %.656.i, %B200.if.i ]
  %_multiply_wide_v86_a22.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B84.if.i ], [ %.664.i, %B200.if.i ]
  %_multiply_wide_v86_a23.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B84.if.i ], [ %.668.i, %B200.if.i ]
  %_multiply_wide_v86_a30.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B84.if.i ], [ %.690.i, %B200.if.i ]
  %_multiply_wide_v86_a31.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B84.if.i ], [ %.694.i, %B200.if.i ]
  %_multiply_wide_v86_a32.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B84.if.i ], [ %.702.i, %B200.if.i ]
  %_multiply_wide_v86_a33.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B84.if.i ], [ %.706.i, %B200.if.i ]
  store <8 x double> %_multiply_wide_v86_a00.2.1.lcssa.i, ptr %.237.i, align 8, !noalias !65
  %.765.i = getelementptr inbounds nuw i8, ptr %.237.i, i64 64
  store <8 x double> %_multiply_wide_v86_a01.2.1.lcssa.i, ptr %.765.i, align 8, !noalias !65
  %.776.i = getelementptr inbounds nuw i8, ptr %.237.i, i64 128
  store <8 x double> %_multiply_wide_v86_a02.2.1.lcssa.i, ptr %.776.i, align 8, !noalias !65
  %.787.i = getelementptr inbounds nuw i8, ptr %.237.i, i64 192
  store <8 x double> %_multiply_wide_v86_a03.2.1.lcssa.i, ptr %.787.i, align 8, !noalias !65
  %.817.i = getelementptr inbounds double, ptr %.237.i, i64 %arg.width
  store <8 x double> %_multiply_wide_v86_a10.2.1.lcssa.i, ptr %.817.i, align 8, !noalias !65
  %.827.i = getelementptr i8, ptr %.817.i, i64 64
  store <8 x double> %_multiply_wide_v86_a11.2.1.lcssa.i, ptr %.827.i, align 8, !noalias !65
  %.838.i = getelementptr i8, ptr %.817.i, i64 128
  store <8 x double> %_multiply_wide_v86_a12.2.1.lcssa.i, ptr %.838.i, align 8, !noalias !65
  %.849.i = getelementptr i8, ptr %.817.i, i64 192
  store <8 x double> %_multiply_wide_v86_a13.2.1.lcssa.i, ptr %.849.i, align 8, !noalias !65
  %.880.i = getelementptr inbounds i8, ptr %.237.i, i64 %.880.idx.i
  store <8 x double> %_multiply_wide_v86_a20.2.1.lcssa.i, ptr %.880.i, align 8, !noalias !65
  %.890.i = getelementptr i8, ptr %.880.i, i64 64
  store <8 x double> %_multiply_wide_v86_a21.2.1.lcssa.i, ptr %.890.i, align 8, !noalias !65
  %.901.i = getelementptr i8, ptr %.880.i, i64 128
  store <8 x double> %_multiply_wide_v86_a22.2.1.lcssa.i, ptr %.901.i, align 8, !noalias !65
  %.912.i = getelementptr i8, ptr %.880.i, i64 192
  store <8 x double> %_multiply_wide_v86_a23.2.1.lcssa.i, ptr %.912.i, align 8, !noalias !65
  %.950.i = getelementptr inbounds i8, ptr %.237.i, i64 %.950.idx.i
  store <8 x double> %_multiply_wide_v86_a30.2.1.lcssa.i, ptr %.950.i, align 8, !noalias !65
  %.960.i = getelementptr i8, ptr %.950.i, i64 64
  store <8 x double> %_multiply_wide_v86_a31.2.1.lcssa.i, ptr %.960.i, align 8, !noalias !65
  %.971.i = getelementptr i8, ptr %.950.i, i64 128
  store <8 x double> %_multiply_wide_v86_a32.2.1.lcssa.i, ptr %.971.i, align 8, !noalias !65
  %.982.i = getelementptr i8, ptr %.950.i, i64 192
  store <8 x double> %_multiply_wide_v86_a33.2.1.lcssa.i, ptr %.982.i, align 8, !noalias !65
  %scevgep19.i = getelementptr i8, ptr %lsr.iv18.i, i64 %12
  %.187.i = icmp sgt i64 %.186856868.i, 1
  br i1 %.187.i, label %B84.if.i, label %B354.else.loopexit.i

B6509.loopexit.i:                                 ; preds = %B884.if.i
  %14 = add i64 %position.5.0901.i, %20
  br label %B6509.i

B6509.i:                                          ; preds = %B356.if.i, %B6509.loopexit.i
  %position.4.1.lcssa.i = phi i64 [ %position.5.0901.i, %B356.if.i ], [ %14, %B6509.loopexit.i ]
  %b0.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B356.if.i ], [ %.1337.i, %B6509.loopexit.i ]
  %b1.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B356.if.i ], [ %.1356.i, %B6509.loopexit.i ]
  %b2.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B356.if.i ], [ %.1376.i, %B6509.loopexit.i ]
  %b3.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B356.if.i ], [ %.1396.i, %B6509.loopexit.i ]
  %.1418.i = getelementptr inbounds double, ptr %.522, i64 %.1135893899.i
  store <8 x double> %b0.2.1.lcssa.i, ptr %.1418.i, align 8, !noalias !65
  %.1434.i = getelementptr double, ptr %17, i64 %.1135893899.i
  store <8 x double> %b1.2.1.lcssa.i, ptr %.1434.i, align 8, !noalias !65
  %.1451.i = getelementptr double, ptr %18, i64 %.1135893899.i
  store <8 x double> %b2.2.1.lcssa.i, ptr %.1451.i, align 8, !noalias !65
  %.1470.i = getelementptr double, ptr %19, i64 %.1135893899.i
  store <8 x double> %b3.2.1.lcssa.i, ptr %.1470.i, align 8, !noalias !65
  %.1129.i = icmp sgt i64 %.1128892900.i, 1
  br i1 %.1129.i, label %B356.if.i, label %B244.endif.endif.endif

B84.if.i:                                         ; preds = %B280.i, %B84.if.lr.ph.i
  %lsr.iv18.i = phi ptr [ %scevgep17.i, %B84.if.lr.ph.i ], [ %scevgep19.i, %B280.i ]
  %.186856868.i = phi i64 [ %storemerge.i, %B84.if.lr.ph.i ], [ %.196.i, %B280.i ]
  %.193857867.i = phi i64 [ 0, %B84.if.lr.ph.i ], [ %.200.i, %B280.i ]
  %.196.i = add nsw i64 %.186856868.i, -1
  %.200.i = add nuw nsw i64 %.193857867.i, 32
  %.237.i = getelementptr inbounds nuw double, ptr %.522, i64 %.193857867.i
  br i1 %13, label %B280.i, label %B200.if.i

B200.if.i:                                        ; preds = %B84.if.i, %B200.if.i
  %lsr.iv = phi i64 [ %lsr.iv.next, %B200.if.i ], [ -1, %B84.if.i ]
  %lsr.iv20.i = phi ptr [ %scevgep21.i, %B200.if.i ], [ %lsr.iv18.i, %B84.if.i ]
  %_multiply_wide_v86_a33.2.1838.i = phi <8 x double> [ %.706.i, %B200.if.i ], [ zeroinitializer, %B84.if.i ]
  %_multiply_wide_v86_a32.2.1837.i = phi <8 x double> [ %.702.i, %B200.if.i ], [ zeroinitializer, %B84.if.i ]
  %_multiply_wide_v86_a31.2.1836.i = phi <8 x double> [ %.694.i, %B200.if.i ], [ zeroinitializer, %B84.if.i ]
  %_multiply_wide_v86_a30.2.1835.i = phi <8 x double> [ %.690.i, %B200.if.i ], [ zeroinitializer, %B84.if.i ]
  %_multiply_wide_v86_a23.2.1834.i = phi <8 x double> [ %.668.i, %B200.if.i ], [ zeroinitializer, %B84.if.i ]
  %_multiply_wide_v86_a22.2.1833.i = phi <8 x double> [ %.664.i, %B200.if.i ], [ zeroinitializer, %B84.if.i ]
  %_multiply_wide_v86_a21.2.1832.i = phi <8 x double> [ %.656.i, %B200.if.i ], [ zeroinitializer, %B84.if.i ]
  %_multiply_wide_v86_a20.2.1831.i = phi <8 x double> [ %.652.i, %B200.if.i ], [ zeroinitializer, %B84.if.i ]
  %_multiply_wide_v86_a13.2.1830.i = phi <8 x double> [ %.630.i, %B200.if.i ], [ zeroinitializer, %B84.if.i ]
  %_multiply_wide_v86_a12.2.1829.i = phi <8 x double> [ %.626.i, %B200.if.i ], [ zeroinitializer, %B84.if.i ]
  %_multiply_wide_v86_a11.2.1828.i = phi <8 x double> [ %.618.i, %B200.if.i ], [ zeroinitializer, %B84.if.i ]
  %_multiply_wide_v86_a10.2.1827.i = phi <8 x double> [ %.614.i, %B200.if.i ], [ zeroinitializer, %B84.if.i ]
  %_multiply_wide_v86_a03.2.1826.i = phi <8 x double> [ %.593.i, %B200.if.i ], [ zeroinitializer, %B84.if.i ]
  %_multiply_wide_v86_a02.2.1825.i = phi <8 x double> [ %.589.i, %B200.if.i ], [ zeroinitializer, %B84.if.i ]
  %_multiply_wide_v86_a01.2.1824.i = phi <8 x double> [ %.581.i, %B200.if.i ], [ zeroinitializer, %B84.if.i ]
  %_multiply_wide_v86_a00.2.1823.i = phi <8 x double> [ %.577.i, %B200.if.i ], [ zeroinitializer, %B84.if.i ]
  %scevgep24.i = getelementptr i8, ptr %lsr.iv20.i, i64 -192
  %.520.i = load <8 x double>, ptr %scevgep24.i, align 8, !noalias !65
  %scevgep23.i = getelementptr i8, ptr %lsr.iv20.i, i64 -128
  %.532.i = load <8 x double>, ptr %scevgep23.i, align 8, !noalias !65
  %scevgep22.i = getelementptr i8, ptr %lsr.iv20.i, i64 -64
  %.545.i = load <8 x double>, ptr %scevgep22.i, align 8, !noalias !65
  %.558.i = load <8 x double>, ptr %lsr.iv20.i, align 8, !noalias !65
  %15 = shl i64 %lsr.iv, 3
  %scevgep60 = getelementptr i8, ptr %lsr.iv58, i64 %15
  %scevgep61 = getelementptr i8, ptr %scevgep60, i64 64
  %.573.i = load double, ptr %scevgep61, align 8, !noalias !65
  %.575.i = insertelement <8 x double> poison, double %.573.i, i64 0
  %.576.i = shufflevector <8 x double> %.575.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.577.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.520.i, <8 x double> %.576.i, <8 x double> %_multiply_wide_v86_a00.2.1823.i)
  %.581.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.532.i, <8 x double> %.576.i, <8 x double> %_multiply_wide_v86_a01.2.1824.i)
  %.589.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.545.i, <8 x double> %.576.i, <8 x double> %_multiply_wide_v86_a02.2.1825.i)
  %.593.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.558.i, <8 x double> %.576.i, <8 x double> %_multiply_wide_v86_a03.2.1826.i)
  %scevgep20 = getelementptr i8, ptr %lsr.iv54, i64 %15
  %scevgep21 = getelementptr i8, ptr %scevgep20, i64 8
  %.610.i = load double, ptr %scevgep21, align 8, !noalias !65
  %.612.i = insertelement <8 x double> poison, double %.610.i, i64 0
  %.613.i = shufflevector <8 x double> %.612.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.614.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.520.i, <8 x double> %.613.i, <8 x double> %_multiply_wide_v86_a10.2.1827.i)
  %.618.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.532.i, <8 x double> %.613.i, <8 x double> %_multiply_wide_v86_a11.2.1828.i)
  %.626.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.545.i, <8 x double> %.613.i, <8 x double> %_multiply_wide_v86_a12.2.1829.i)
  %.630.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.558.i, <8 x double> %.613.i, <8 x double> %_multiply_wide_v86_a13.2.1830.i)
  %scevgep17 = getelementptr i8, ptr %lsr.iv49, i64 %15
  %scevgep19 = getelementptr i8, ptr %scevgep17, i64 8
  %.648.i = load double, ptr %scevgep19, align 8, !noalias !65
  %.650.i = insertelement <8 x double> poison, double %.648.i, i64 0
  %.651.i = shufflevector <8 x double> %.650.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.652.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.520.i, <8 x double> %.651.i, <8 x double> %_multiply_wide_v86_a20.2.1831.i)
  %.656.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.532.i, <8 x double> %.651.i, <8 x double> %_multiply_wide_v86_a21.2.1832.i)
  %.664.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.545.i, <8 x double> %.651.i, <8 x double> %_multiply_wide_v86_a22.2.1833.i)
  %.668.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.558.i, <8 x double> %.651.i, <8 x double> %_multiply_wide_v86_a23.2.1834.i)
  %scevgep7 = getelementptr i8, ptr %lsr.iv44, i64 %15
  %scevgep8 = getelementptr i8, ptr %scevgep7, i64 8
  %.686.i = load double, ptr %scevgep8, align 8, !noalias !65
  %.688.i = insertelement <8 x double> poison, double %.686.i, i64 0
  %.689.i = shufflevector <8 x double> %.688.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.690.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.520.i, <8 x double> %.689.i, <8 x double> %_multiply_wide_v86_a30.2.1835.i)
  %.694.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.532.i, <8 x double> %.689.i, <8 x double> %_multiply_wide_v86_a31.2.1836.i)
  %.702.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.545.i, <8 x double> %.689.i, <8 x double> %_multiply_wide_v86_a32.2.1837.i)
  %.706.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.558.i, <8 x double> %.689.i, <8 x double> %_multiply_wide_v86_a33.2.1838.i)
  %scevgep21.i = getelementptr i8, ptr %lsr.iv20.i, i64 256
  %lsr.iv.next = add nsw i64 %lsr.iv, 1
  %exitcond.not.i = icmp eq i64 %.603, %lsr.iv.next
  br i1 %exitcond.not.i, label %B280.i, label %B200.if.i

B354.else.loopexit.i:                             ; preds = %B280.i
  %16 = mul i64 %.604, %2
  br label %B354.else.i

B354.else.i:                                      ; preds = %B354.else.loopexit.i, %B242.if
  %position.3.0.lcssa.i = phi i64 [ 0, %B242.if ], [ %16, %B354.else.loopexit.i ]
  br i1 %brmerge, label %B244.endif.endif.endif, label %B356.if.lr.ph.i

B356.if.lr.ph.i:                                  ; preds = %B354.else.i
  %.arg.count815.i = tail call i64 @llvm.smax.i64(i64 %.604, i64 0)
  %17 = getelementptr double, ptr %.522, i64 %arg.width
  %18 = getelementptr i8, ptr %.522, i64 %.880.idx.i
  %19 = getelementptr i8, ptr %.522, i64 %.950.idx.i
  %20 = shl i64 %.arg.count815.i, 3
  %21 = icmp slt i64 %.603, 0
  br label %B356.if.i

B356.if.i:                                        ; preds = %B356.if.lr.ph.i, %B6509.i
  %position.5.0901.i = phi i64 [ %position.3.0.lcssa.i, %B356.if.lr.ph.i ], [ %position.4.1.lcssa.i, %B6509.i ]
  %.1128892900.i = phi i64 [ %.1108.i, %B356.if.lr.ph.i ], [ %.1138.i, %B6509.i ]
  %.1135893899.i = phi i64 [ %.1046.i, %B356.if.lr.ph.i ], [ %.1142.i, %B6509.i ]
  %.1138.i = add nsw i64 %.1128892900.i, -1
  %.1142.i = add i64 %.1135893899.i, 8
  br i1 %21, label %B6509.i, label %B884.if.preheader.i

B884.if.preheader.i:                              ; preds = %B356.if.i
  %22 = shl i64 %position.5.0901.i, 3
  %scevgep.i = getelementptr i8, ptr %.269, i64 %22
  br label %B884.if.i

B884.if.i:                                        ; preds = %B884.if.i, %B884.if.preheader.i
  %lsr.iv25 = phi i64 [ %lsr.iv.next26, %B884.if.i ], [ %.604, %B884.if.preheader.i ]
  %lsr.iv22 = phi i64 [ %lsr.iv.next23, %B884.if.i ], [ 0, %B884.if.preheader.i ]
  %b3.2.1884.i = phi <8 x double> [ %.1396.i, %B884.if.i ], [ zeroinitializer, %B884.if.preheader.i ]
  %b2.2.1883.i = phi <8 x double> [ %.1376.i, %B884.if.i ], [ zeroinitializer, %B884.if.preheader.i ]
  %b1.2.1882.i = phi <8 x double> [ %.1356.i, %B884.if.i ], [ zeroinitializer, %B884.if.preheader.i ]
  %b0.2.1881.i = phi <8 x double> [ %.1337.i, %B884.if.i ], [ zeroinitializer, %B884.if.preheader.i ]
  %23 = shl i64 %lsr.iv22, 3
  %scevgep24 = getelementptr i8, ptr %scevgep.i, i64 %23
  %.1318.i = load <8 x double>, ptr %scevgep24, align 8, !noalias !65
  %scevgep30 = getelementptr i8, ptr %lsr.iv58, i64 %lsr.iv22
  %scevgep31 = getelementptr i8, ptr %scevgep30, i64 56
  %.1333.i = load double, ptr %scevgep31, align 8, !noalias !65
  %.1335.i = insertelement <8 x double> poison, double %.1333.i, i64 0
  %.1336.i = shufflevector <8 x double> %.1335.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1337.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1318.i, <8 x double> %.1336.i, <8 x double> %b0.2.1881.i)
  %scevgep29 = getelementptr i8, ptr %lsr.iv54, i64 %lsr.iv22
  %.1352.i = load double, ptr %scevgep29, align 8, !noalias !65
  %.1354.i = insertelement <8 x double> poison, double %.1352.i, i64 0
  %.1355.i = shufflevector <8 x double> %.1354.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1356.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1318.i, <8 x double> %.1355.i, <8 x double> %b1.2.1882.i)
  %scevgep28 = getelementptr i8, ptr %lsr.iv49, i64 %lsr.iv22
  %.1372.i = load double, ptr %scevgep28, align 8, !noalias !65
  %.1374.i = insertelement <8 x double> poison, double %.1372.i, i64 0
  %.1375.i = shufflevector <8 x double> %.1374.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1376.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1318.i, <8 x double> %.1375.i, <8 x double> %b2.2.1883.i)
  %scevgep27 = getelementptr i8, ptr %lsr.iv44, i64 %lsr.iv22
  %.1392.i = load double, ptr %scevgep27, align 8, !noalias !65
  %.1394.i = insertelement <8 x double> poison, double %.1392.i, i64 0
  %.1395.i = shufflevector <8 x double> %.1394.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1396.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1318.i, <8 x double> %.1395.i, <8 x double> %b3.2.1884.i)
  %lsr.iv.next23 = add i64 %lsr.iv22, 8
  %lsr.iv.next26 = add i64 %lsr.iv25, -1
  %exitcond909.not.i = icmp eq i64 %lsr.iv.next26, 0
  br i1 %exitcond909.not.i, label %B6509.loopexit.i, label %B884.if.i

B244.endif.endif.endif:                           ; preds = %B6509.i, %B354.else.i
  %scevgep45 = getelementptr i8, ptr %lsr.iv44, i64 %6
  %scevgep50 = getelementptr i8, ptr %lsr.iv49, i64 %6
  %scevgep55 = getelementptr i8, ptr %lsr.iv54, i64 %6
  %scevgep59 = getelementptr i8, ptr %lsr.iv58, i64 %6
  %.405 = icmp sgt i64 %.404313321, 1
  br i1 %.405, label %B242.if, label %B452
}

; Function Attrs: mustprogress nocallback nocreateundeforpoison nofree nosync nounwind speculatable willreturn memory(none)
declare double @llvm.exp.f64(double) #3

; Function Attrs: nofree noinline norecurse nosync nounwind memory(readwrite, inaccessiblemem: none, target_mem0: none, target_mem1: none)
define internal fastcc void @inner_15(ptr noalias nonnull writeonly captures(none) %retptr, ptr readonly captures(none) %arg.coordinates.4, i64 %arg.rows, ptr readonly captures(none) %arg.contents.4, ptr readonly captures(none) %arg.exponents.4, ptr readonly captures(none) %arg.weights.4, ptr initializes((56, 64)) %arg.scratch.4) unnamed_addr #4 {
entry:
  %.2159 = alloca ptr, align 8
  store ptr null, ptr %.2159, align 8
  %.104 = getelementptr i8, ptr %arg.contents.4, i64 24
  %.105 = load i64, ptr %.104, align 8
  %.106 = sub i64 0, %.105
  %.114.1 = and i64 %.106, -8
  %.148 = sub i64 0, %.114.1
  %.153 = sub i64 8, %.114.1
  %.158 = shl nsw i64 %.153, 3
  %.211 = icmp slt i64 %.153, 0
  %.212 = select i1 %.211, i64 1073741824, i64 0
  %.213 = add i64 %.212, %.158
  %.216 = icmp slt i64 %.213, 0
  br i1 %.216, label %B0.endif.else.endif.endif.if, label %B0.endif.else.endif.endif.endif, !prof !1

B348:                                             ; preds = %B260.if
  %.925 = getelementptr i8, ptr %arg.contents.4, i64 16
  %.926 = load i64, ptr %.925, align 8
  %.53.i = add nsw i64 %.926, 1
  %.54.i = shl nsw i64 %.53.i, 3
  %.59.i = mul nsw i64 %.53.i, 40
  %.96.i = icmp slt i64 %.926, -1
  %.97.i = select i1 %.96.i, i64 %.453, i64 0
  %.98.i = add i64 %.97.i, %.59.i
  %.101.i = icmp slt i64 %.98.i, 0
  br i1 %.101.i, label %B0.else.if.i, label %B0.else.endif.i, !prof !1

B414.i:                                           ; preds = %B282.if.i, %B88.else.endif.endif.i
  %exitcond473.not.i = icmp eq i64 %.331.i, 5
  br i1 %exitcond473.not.i, label %B416.i, label %B86.if.i

B416.i:                                           ; preds = %B414.i
  %.199.i = getelementptr double, ptr %.469, i64 %.86.sroa.0.3.i
  %.idx.i = shl i64 %.53.i, 7
  %0 = getelementptr i8, ptr %.469, i64 %.idx.i
  %.idx411.i = mul i64 %.53.i, 192
  %1 = getelementptr i8, ptr %.469, i64 %.idx411.i
  %.idx412.i = shl i64 %.53.i, 8
  %2 = getelementptr i8, ptr %.469, i64 %.idx412.i
  %scevgep.i = getelementptr i8, ptr %arg.exponents.4, i64 32
  br label %B448.if.i

B0.else.if.i:                                     ; preds = %B348
  br label %B0.else.endif.i

B0.else.endif.i:                                  ; preds = %B0.else.if.i, %B348
  %.86.sroa.0.1.i = phi i64 [ 0, %B0.else.if.i ], [ %.98.i, %B348 ]
  %.106.not.i = icmp slt i64 %.98.i, %.453
  br i1 %.106.not.i, label %B0.else.endif.endif.i, label %B0.else.endif.if.i, !prof !5

B0.else.endif.if.i:                               ; preds = %B0.else.endif.i
  br label %B0.else.endif.endif.i

B0.else.endif.endif.i:                            ; preds = %B0.else.endif.if.i, %B0.else.endif.i
  %.86.sroa.0.3.i = phi i64 [ %.453, %B0.else.endif.if.i ], [ %.86.sroa.0.1.i, %B0.else.endif.i ]
  %storemerge413.i = tail call i64 @llvm.smax.i64(i64 %.926, i64 0)
  %scevgep29.i = getelementptr i8, ptr %.469, i64 64
  %3 = icmp slt i64 %.926, 1
  br label %B86.if.i

B86.if.i:                                         ; preds = %B0.else.endif.endif.i, %B414.i
  %.324433441.i = phi i64 [ 0, %B0.else.endif.endif.i ], [ %.331.i, %B414.i ]
  %.331.i = add nuw nsw i64 %.324433441.i, 1
  %.364.idx.i = shl nsw i64 %.324433441.i, 6
  %.364.i = getelementptr inbounds nuw i8, ptr %arg.coordinates.4, i64 %.364.idx.i
  %.366.i = load <8 x double>, ptr %.364.i, align 8, !noalias !68
  %.371.i = mul nsw i64 %.324433441.i, %.54.i
  %.411.i = icmp slt i64 %.371.i, 0
  %.412.i = select i1 %.411.i, i64 %.453, i64 0
  %.413.i = add i64 %.412.i, %.371.i
  %.416.i = icmp slt i64 %.413.i, 0
  br i1 %.416.i, label %B88.else.if.i, label %B88.else.endif.i, !prof !1

B88.else.if.i:                                    ; preds = %B86.if.i
  br label %B88.else.endif.i

B88.else.endif.i:                                 ; preds = %B88.else.if.i, %B86.if.i
  %.401.sroa.0.1.i = phi i64 [ 0, %B88.else.if.i ], [ %.413.i, %B86.if.i ]
  %.421.not.i = icmp slt i64 %.413.i, %.453
  br i1 %.421.not.i, label %B88.else.endif.endif.i, label %B88.else.endif.if.i, !prof !5

B88.else.endif.if.i:                              ; preds = %B88.else.endif.i
  br label %B88.else.endif.endif.i

B88.else.endif.endif.i:                           ; preds = %B88.else.endif.if.i, %B88.else.endif.i
  %.401.sroa.0.3.i = phi i64 [ %.453, %B88.else.endif.if.i ], [ %.401.sroa.0.1.i, %B88.else.endif.i ]
  %.514.i = getelementptr double, ptr %.469, i64 %.401.sroa.0.3.i
  store <8 x double> splat (double 1.000000e+00), ptr %.514.i, align 8, !noalias !68
  br i1 %3, label %B414.i, label %B282.if.preheader.i

B282.if.preheader.i:                              ; preds = %B88.else.endif.endif.i
  %.6.i.i = fadd contract <8 x double> %.366.i, %.366.i
  %4 = shl i64 %.401.sroa.0.3.i, 3
  %scevgep30.i = getelementptr i8, ptr %scevgep29.i, i64 %4
  br label %B282.if.i

B282.if.i:                                        ; preds = %B282.if.i, %B282.if.preheader.i
  %lsr.iv31.i = phi ptr [ %scevgep30.i, %B282.if.preheader.i ], [ %scevgep32.i, %B282.if.i ]
  %lsr.iv27.i = phi i64 [ %storemerge413.i, %B282.if.preheader.i ], [ %lsr.iv.next28.i, %B282.if.i ]
  %before.2.1429.i = phi <8 x double> [ splat (double 1.000000e+00), %B282.if.preheader.i ], [ %current.2.1428.i, %B282.if.i ]
  %current.2.1428.i = phi <8 x double> [ %.366.i, %B282.if.preheader.i ], [ %.757.i, %B282.if.i ]
  store <8 x double> %current.2.1428.i, ptr %lsr.iv31.i, align 8, !noalias !68
  %.6.i14.i = fsub contract <8 x double> zeroinitializer, %before.2.1429.i
  %.757.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i, <8 x double> %current.2.1428.i, <8 x double> %.6.i14.i)
  %lsr.iv.next28.i = add nsw i64 %lsr.iv27.i, -1
  %scevgep32.i = getelementptr i8, ptr %lsr.iv31.i, i64 64
  %exitcond.not.i = icmp eq i64 %lsr.iv.next28.i, 0
  br i1 %exitcond.not.i, label %B414.i, label %B282.if.i

B448.if.i:                                        ; preds = %B448.if.i, %B416.i
  %lsr.iv26.i = phi i64 [ %.863, %B416.i ], [ %lsr.iv.next.i, %B448.if.i ]
  %lsr.iv24.i = phi ptr [ %.199.i, %B416.i ], [ %scevgep25.i, %B448.if.i ]
  %lsr.iv.i = phi ptr [ %scevgep.i, %B416.i ], [ %scevgep19.i, %B448.if.i ]
  %scevgep20.i = getelementptr i8, ptr %lsr.iv.i, i64 -32
  %.920.i = load i64, ptr %scevgep20.i, align 8, !noalias !68
  %.929.idx.i = shl nsw i64 %.920.i, 6
  %.929.i = getelementptr inbounds i8, ptr %.469, i64 %.929.idx.i
  %.931.i = load <8 x double>, ptr %.929.i, align 8, !noalias !68
  %scevgep21.i = getelementptr i8, ptr %lsr.iv.i, i64 -24
  %.942.i = load i64, ptr %scevgep21.i, align 8, !noalias !68
  %.54410.i = add i64 %.942.i, %.53.i
  %.953.idx.i = shl i64 %.54410.i, 6
  %.953.i = getelementptr inbounds i8, ptr %.469, i64 %.953.idx.i
  %.955.i = load <8 x double>, ptr %.953.i, align 8, !noalias !68
  %scevgep22.i = getelementptr i8, ptr %lsr.iv.i, i64 -16
  %.968.i = load i64, ptr %scevgep22.i, align 8, !noalias !68
  %.978.idx.i = shl i64 %.968.i, 6
  %.978.i = getelementptr i8, ptr %0, i64 %.978.idx.i
  %.980.i = load <8 x double>, ptr %.978.i, align 8, !noalias !68
  %scevgep23.i = getelementptr i8, ptr %lsr.iv.i, i64 -8
  %.993.i = load i64, ptr %scevgep23.i, align 8, !noalias !68
  %.1003.idx.i = shl i64 %.993.i, 6
  %.1003.i = getelementptr i8, ptr %1, i64 %.1003.idx.i
  %.1005.i = load <8 x double>, ptr %.1003.i, align 8, !noalias !68
  %.1018.i = load i64, ptr %lsr.iv.i, align 8, !noalias !68
  %.1028.idx.i = shl i64 %.1018.i, 6
  %.1028.i = getelementptr i8, ptr %2, i64 %.1028.idx.i
  %.1030.i = load <8 x double>, ptr %.1028.i, align 8, !noalias !68
  %.6.i15.i = fmul contract <8 x double> %.931.i, %.955.i
  %.6.i16.i = fmul contract <8 x double> %.980.i, %.1005.i
  %.6.i17.i = fmul contract <8 x double> %.6.i15.i, %.6.i16.i
  %.6.i18.i = fmul contract <8 x double> %.6.i17.i, %.1030.i
  store <8 x double> %.6.i18.i, ptr %lsr.iv24.i, align 8, !noalias !68
  %scevgep19.i = getelementptr i8, ptr %lsr.iv.i, i64 40
  %scevgep25.i = getelementptr i8, ptr %lsr.iv24.i, i64 64
  %lsr.iv.next.i = add i64 %lsr.iv26.i, -1
  %exitcond474.not.i = icmp eq i64 %lsr.iv.next.i, 0
  br i1 %exitcond474.not.i, label %_ZN17bnserve_surrogate6kernel11_regression9_productsB3v70B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedExx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit, label %B448.if.i

_ZN17bnserve_surrogate6kernel11_regression9_productsB3v70B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedExx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit: ; preds = %B448.if.i
  %.174.i = sub nsw i64 %.453, %.86.sroa.0.3.i
  %.183.i = tail call i64 @llvm.smax.i64(i64 %.174.i, i64 0)
  %.1010 = getelementptr i8, ptr %arg.contents.4, i64 88
  %.1011 = load i64, ptr %.1010, align 8
  %5 = lshr i64 %.1011, 33
  %.1049 = and i64 %5, 1073741824
  %.1050 = add i64 %.1049, %.1011
  %.1053 = icmp slt i64 %.1050, 0
  br i1 %.1053, label %B348.endif.else.if, label %B348.endif.else.endif, !prof !1

B696:                                             ; preds = %B548.endif.endif.endif, %B348.endif.else.endif.endif, %B260.if
  %.1772 = getelementptr i8, ptr %arg.contents.4, i64 32
  %.1773 = load i64, ptr %.1772, align 8
  %.1774 = icmp sgt i64 %.1773, 0
  br i1 %.1774, label %B740, label %B856

B740:                                             ; preds = %B696
  %.1805 = getelementptr i8, ptr %arg.contents.4, i64 96
  %.1806 = load i64, ptr %.1805, align 8
  %6 = lshr i64 %.1806, 33
  %.1844 = and i64 %6, 1073741824
  %.1845 = add i64 %.1844, %.1806
  %.1848 = icmp slt i64 %.1845, 0
  br i1 %.1848, label %B740.else.if, label %B740.else.endif, !prof !1

B856:                                             ; preds = %B740.endif.else.endif.endif, %B696
  %retptr.repack822 = getelementptr inbounds nuw i8, ptr %retptr, i64 16
  tail call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(16) %retptr, i8 0, i64 16, i1 false)
  store i64 %.184.sroa.13.2, ptr %retptr.repack822, align 8
  %retptr.repack824 = getelementptr inbounds nuw i8, ptr %retptr, i64 24
  store i64 8, ptr %retptr.repack824, align 8
  %retptr.repack826 = getelementptr inbounds nuw i8, ptr %retptr, i64 32
  store ptr %arg.scratch.4, ptr %retptr.repack826, align 8
  %retptr.repack828 = getelementptr inbounds nuw i8, ptr %retptr, i64 40
  store i64 %.184.sroa.13.2, ptr %retptr.repack828, align 8
  %retptr.repack830 = getelementptr inbounds nuw i8, ptr %retptr, i64 48
  store i64 8, ptr %retptr.repack830, align 8
  ret void

B0.endif.else.endif.endif.if:                     ; preds = %entry
  br label %B0.endif.else.endif.endif.endif

B0.endif.else.endif.endif.endif:                  ; preds = %B0.endif.else.endif.endif.if, %entry
  %.184.sroa.13.1 = phi i64 [ 0, %B0.endif.else.endif.endif.if ], [ %.213, %entry ]
  %.221.not = icmp slt i64 %.213, 1073741824
  br i1 %.221.not, label %B0.endif.else.endif.endif.endif.endif, label %B0.endif.else.endif.endif.endif.if, !prof !5

B0.endif.else.endif.endif.endif.if:               ; preds = %B0.endif.else.endif.endif.endif
  br label %B0.endif.else.endif.endif.endif.endif

B0.endif.else.endif.endif.endif.endif:            ; preds = %B0.endif.else.endif.endif.endif.if, %B0.endif.else.endif.endif.endif
  %.184.sroa.13.2 = phi i64 [ 1073741824, %B0.endif.else.endif.endif.endif.if ], [ %.184.sroa.13.1, %B0.endif.else.endif.endif.endif ]
  br i1 %.216, label %B0.endif.endif.else.if, label %B0.endif.endif.else.endif, !prof !1

B0.endif.endif.else.if:                           ; preds = %B0.endif.else.endif.endif.endif.endif
  br label %B0.endif.endif.else.endif

B0.endif.endif.else.endif:                        ; preds = %B0.endif.endif.else.if, %B0.endif.else.endif.endif.endif.endif
  %.356.sroa.0.1 = phi i64 [ 0, %B0.endif.endif.else.if ], [ %.213, %B0.endif.else.endif.endif.endif.endif ]
  br i1 %.221.not, label %B0.endif.endif.else.endif.endif, label %B0.endif.endif.else.endif.if, !prof !5

B0.endif.endif.else.endif.if:                     ; preds = %B0.endif.endif.else.endif
  br label %B0.endif.endif.else.endif.endif

B0.endif.endif.else.endif.endif:                  ; preds = %B0.endif.endif.else.endif.if, %B0.endif.endif.else.endif
  %.356.sroa.0.3 = phi i64 [ 1073741824, %B0.endif.endif.else.endif.if ], [ %.356.sroa.0.1, %B0.endif.endif.else.endif ]
  %.444 = sub nsw i64 1073741824, %.356.sroa.0.3
  %.453 = tail call i64 @llvm.smax.i64(i64 %.444, i64 0)
  %.469 = getelementptr double, ptr %arg.scratch.4, i64 %.356.sroa.0.3
  %.561.inv = icmp sgt i64 %.153, 0
  %..158 = select i1 %.561.inv, i64 %.158, i64 0
  %.605834 = icmp sgt i64 %..158, 0
  br i1 %.605834, label %B204.if.preheader, label %B260.if

B204.if.preheader:                                ; preds = %B0.endif.endif.else.endif.endif
  %7 = shl nuw i64 %..158, 3
  tail call void @llvm.memset.p0.i64(ptr align 8 %arg.scratch.4, i8 0, i64 %7, i1 false)
  br label %B260.if

B260.if:                                          ; preds = %B204.if.preheader, %B0.endif.endif.else.endif.endif
  %8 = getelementptr i8, ptr %arg.scratch.4, i64 56
  store double 1.000000e+00, ptr %8, align 8
  %.813.1 = select i1 %.211, i64 %.184.sroa.13.2, i64 0
  %9 = getelementptr double, ptr %arg.scratch.4, i64 %.153
  %10 = getelementptr i8, ptr %9, i64 56
  %.827.1 = getelementptr double, ptr %10, i64 %.813.1
  store double 1.000000e+00, ptr %.827.1, align 8
  %.idx = shl i64 %.153, 4
  %11 = getelementptr i8, ptr %arg.scratch.4, i64 %.idx
  %12 = getelementptr i8, ptr %11, i64 56
  %.827.2 = getelementptr double, ptr %12, i64 %.813.1
  store double 1.000000e+00, ptr %.827.2, align 8
  %.idx854 = mul i64 %.153, 24
  %13 = getelementptr i8, ptr %arg.scratch.4, i64 %.idx854
  %14 = getelementptr i8, ptr %13, i64 56
  %.827.3 = getelementptr double, ptr %14, i64 %.813.1
  store double 1.000000e+00, ptr %.827.3, align 8
  %.idx855 = shl i64 %.153, 5
  %15 = getelementptr i8, ptr %arg.scratch.4, i64 %.idx855
  %16 = getelementptr i8, ptr %15, i64 56
  %.827.4 = getelementptr double, ptr %16, i64 %.813.1
  store double 1.000000e+00, ptr %.827.4, align 8
  %.idx856 = mul i64 %.153, 40
  %17 = getelementptr i8, ptr %arg.scratch.4, i64 %.idx856
  %18 = getelementptr i8, ptr %17, i64 56
  %.827.5 = getelementptr double, ptr %18, i64 %.813.1
  store double 1.000000e+00, ptr %.827.5, align 8
  %.idx857 = mul i64 %.153, 48
  %19 = getelementptr i8, ptr %arg.scratch.4, i64 %.idx857
  %20 = getelementptr i8, ptr %19, i64 56
  %.827.6 = getelementptr double, ptr %20, i64 %.813.1
  store double 1.000000e+00, ptr %.827.6, align 8
  %.idx858 = mul i64 %.153, 56
  %21 = getelementptr i8, ptr %arg.scratch.4, i64 %.idx858
  %22 = getelementptr i8, ptr %21, i64 56
  %.827.7 = getelementptr double, ptr %22, i64 %.813.1
  store double 1.000000e+00, ptr %.827.7, align 8
  %.862 = getelementptr i8, ptr %arg.contents.4, i64 8
  %.863 = load i64, ptr %.862, align 8
  %.864 = icmp sgt i64 %.863, 0
  br i1 %.864, label %B348, label %B696

B348.endif.else.if:                               ; preds = %_ZN17bnserve_surrogate6kernel11_regression9_productsB3v70B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedExx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit
  br label %B348.endif.else.endif

B348.endif.else.endif:                            ; preds = %B348.endif.else.if, %_ZN17bnserve_surrogate6kernel11_regression9_productsB3v70B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedExx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit
  %.1038.sroa.0.1 = phi i64 [ 0, %B348.endif.else.if ], [ %.1050, %_ZN17bnserve_surrogate6kernel11_regression9_productsB3v70B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedExx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit ]
  %.1058.not = icmp slt i64 %.1050, 1073741824
  br i1 %.1058.not, label %B348.endif.else.endif.endif, label %B348.endif.else.endif.if, !prof !5

B348.endif.else.endif.if:                         ; preds = %B348.endif.else.endif
  br label %B348.endif.else.endif.endif

B348.endif.else.endif.endif:                      ; preds = %B348.endif.else.endif.if, %B348.endif.else.endif
  %.1038.sroa.0.3 = phi i64 [ 1073741824, %B348.endif.else.endif.if ], [ %.1038.sroa.0.1, %B348.endif.else.endif ]
  %.1151 = getelementptr double, ptr %arg.weights.4, i64 %.1038.sroa.0.3
  %23 = add nuw i64 %arg.rows, 3
  %.1248 = lshr i64 %23, 2
  %.1227.inv = icmp slt i64 %arg.rows, 1
  %.1269847.not859 = icmp eq i64 %.1248, 0
  %.1269847.not = select i1 %.1227.inv, i1 true, i1 %.1269847.not859
  br i1 %.1269847.not, label %B696, label %B546.if.preheader

B546.if.preheader:                                ; preds = %B348.endif.else.endif.endif
  %24 = tail call i64 @llvm.smax.i64(i64 %.148, i64 31)
  %storemerge.i = lshr i64 %24, 5
  %.1086.i = and i64 %.148, 24
  %scevgep23.i2 = getelementptr i8, ptr %.1151, i64 192
  %25 = and i64 %24, 9223372036854775776
  %.1046.i = and i64 %.148, -32
  %.1106806.i = lshr exact i64 %.1086.i, 3
  %26 = add nuw i64 %.86.sroa.0.3.i, %.356.sroa.0.3
  %27 = shl i64 %26, 3
  %28 = getelementptr i8, ptr %arg.scratch.4, i64 %27
  %scevgep = getelementptr i8, ptr %28, i64 24
  %29 = icmp eq i64 %storemerge.i, 0
  %30 = icmp eq i64 %.1086.i, 0
  br label %B546.if

B546.if:                                          ; preds = %B548.endif.endif.endif, %B546.if.preheader
  %.1268845849 = phi i64 [ %.1278, %B548.endif.endif.endif ], [ %.1248, %B546.if.preheader ]
  %.1275846848 = phi i64 [ %.1282, %B548.endif.endif.endif ], [ 0, %B546.if.preheader ]
  %.1278 = add nsw i64 %.1268845849, -1
  %.1282 = add nuw i64 %.1275846848, 4
  %.1308 = mul nsw i64 %.1275846848, %.153
  %.1309 = or disjoint i64 %.1308, 8
  %.1346 = icmp slt i64 %.1308, -8
  %.1347 = select i1 %.1346, i64 %.184.sroa.13.2, i64 0
  %.1348 = add i64 %.1347, %.1309
  %.1351 = icmp slt i64 %.1348, 0
  br i1 %.1351, label %B548.else.if, label %B548.else.endif, !prof !1

B548.else.if:                                     ; preds = %B546.if
  br label %B548.else.endif

B548.else.endif:                                  ; preds = %B548.else.if, %B546.if
  %.1336.sroa.0.1 = phi i64 [ 0, %B548.else.if ], [ %.1348, %B546.if ]
  %.1356.not = icmp slt i64 %.1348, %.184.sroa.13.2
  br i1 %.1356.not, label %B548.else.endif.endif, label %B548.else.endif.if, !prof !5

B548.else.endif.if:                               ; preds = %B548.else.endif
  br label %B548.else.endif.endif

B548.else.endif.endif:                            ; preds = %B548.else.endif.if, %B548.else.endif
  %.1336.sroa.0.3 = phi i64 [ %.184.sroa.13.2, %B548.else.endif.if ], [ %.1336.sroa.0.1, %B548.else.endif ]
  %.1449 = getelementptr double, ptr %arg.scratch.4, i64 %.1336.sroa.0.3
  %.1511 = load i64, ptr %.862, align 8
  %.1548 = icmp slt i64 %.1275846848, 0
  %.1549 = select i1 %.1548, i64 %.183.i, i64 0
  %.1550 = add i64 %.1549, %.1275846848
  %.1553 = icmp slt i64 %.1550, 0
  br i1 %.1553, label %B548.endif.else.if, label %B548.endif.else.endif, !prof !1

B548.endif.else.if:                               ; preds = %B548.else.endif.endif
  br label %B548.endif.else.endif

B548.endif.else.endif:                            ; preds = %B548.endif.else.if, %B548.else.endif.endif
  %.1538.sroa.0.1 = phi i64 [ 0, %B548.endif.else.if ], [ %.1550, %B548.else.endif.endif ]
  %.1558.not = icmp slt i64 %.1550, %.183.i
  br i1 %.1558.not, label %B548.endif.else.endif.endif, label %B548.endif.else.endif.if, !prof !5

B548.endif.else.endif.if:                         ; preds = %B548.endif.else.endif
  br label %B548.endif.else.endif.endif

B548.endif.else.endif.endif:                      ; preds = %B548.endif.else.endif.if, %B548.endif.else.endif
  %.1538.sroa.0.3 = phi i64 [ %.183.i, %B548.endif.else.endif.if ], [ %.1538.sroa.0.1, %B548.endif.else.endif ]
  br i1 %29, label %B354.else.i, label %B84.if.lr.ph.i

B84.if.lr.ph.i:                                   ; preds = %B548.endif.else.endif.endif
  %31 = shl i64 %.1511, 8
  %32 = shl i64 %.1538.sroa.0.3, 3
  %scevgep20 = getelementptr i8, ptr %scevgep, i64 %32
  %33 = icmp slt i64 %.1511, 1
  br label %B84.if.i

B280.i:                                           ; preds = %B200.if.i, %B84.if.i
  %_multiply_wide_v76_a00.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B84.if.i ], [ %.577.i, %B200.if.i ]
  %_multiply_wide_v76_a01.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B84.if.i ], [ %.581.i, %B200.if.i ]
  %_multiply_wide_v76_a02.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B84.if.i ], [ %.589.i, %B200.if.i ]
  %_multiply_wide_v76_a03.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B84.if.i ], [ %.593.i, %B200.if.i ]
  %_multiply_wide_v76_a10.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B84.if.i ], [ %.614.i, %B200.if.i ]
  %_multiply_wide_v76_a11.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B84.if.i ], [ %.618.i, %B200.if.i ]
  %_multiply_wide_v76_a12.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B84.if.i ], [ %.626.i, %B200.if.i ]
  %_multiply_wide_v76_a13.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B84.if.i ], [ %.630.i, %B200.if.i ]
  %_multiply_wide_v76_a20.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B84.if.i ], [ %.652.i, %B200.if.i ]
  %_multiply_wide_v76_a21.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B84.if.i ], [ %.656.i, %B200.if.i ]
  %_multiply_wide_v76_a22.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B84.if.i ], [ %.664.i, %B200.if.i ]
  %_multiply_wide_v76_a23.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B84.if.i ], [ %.668.i, %B200.if.i ]
  %_multiply_wide_v76_a30.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B84.if.i ], [ %.690.i, %B200.if.i ]
  %_multiply_wide_v76_a31.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B84.if.i ], [ %.694.i, %B200.if.i ]
  %_multiply_wide_v76_a32.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B84.if.i ], [ %.702.i, %B200.if.i ]
  %_multiply_wide_v76_a33.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B84.if.i ], [ %.706.i, %B200.if.i ]
  store <8 x double> %_multiply_wide_v76_a00.2.1.lcssa.i, ptr %.237.i, align 8, !noalias !71
  %.765.i = getelementptr inbounds nuw i8, ptr %.237.i, i64 64
  store <8 x double> %_multiply_wide_v76_a01.2.1.lcssa.i, ptr %.765.i, align 8, !noalias !71
  %.776.i = getelementptr inbounds nuw i8, ptr %.237.i, i64 128
  store <8 x double> %_multiply_wide_v76_a02.2.1.lcssa.i, ptr %.776.i, align 8, !noalias !71
  %.787.i = getelementptr inbounds nuw i8, ptr %.237.i, i64 192
  store <8 x double> %_multiply_wide_v76_a03.2.1.lcssa.i, ptr %.787.i, align 8, !noalias !71
  %.817.i = getelementptr inbounds double, ptr %.237.i, i64 %.153
  store <8 x double> %_multiply_wide_v76_a10.2.1.lcssa.i, ptr %.817.i, align 8, !noalias !71
  %.827.i = getelementptr i8, ptr %.817.i, i64 64
  store <8 x double> %_multiply_wide_v76_a11.2.1.lcssa.i, ptr %.827.i, align 8, !noalias !71
  %.838.i = getelementptr i8, ptr %.817.i, i64 128
  store <8 x double> %_multiply_wide_v76_a12.2.1.lcssa.i, ptr %.838.i, align 8, !noalias !71
  %.849.i = getelementptr i8, ptr %.817.i, i64 192
  store <8 x double> %_multiply_wide_v76_a13.2.1.lcssa.i, ptr %.849.i, align 8, !noalias !71
  %.880.i = getelementptr inbounds i8, ptr %.237.i, i64 %.idx
  store <8 x double> %_multiply_wide_v76_a20.2.1.lcssa.i, ptr %.880.i, align 8, !noalias !71
  %.890.i = getelementptr i8, ptr %.880.i, i64 64
  store <8 x double> %_multiply_wide_v76_a21.2.1.lcssa.i, ptr %.890.i, align 8, !noalias !71
  %.901.i = getelementptr i8, ptr %.880.i, i64 128
  store <8 x double> %_multiply_wide_v76_a22.2.1.lcssa.i, ptr %.901.i, align 8, !noalias !71
  %.912.i = getelementptr i8, ptr %.880.i, i64 192
  store <8 x double> %_multiply_wide_v76_a23.2.1.lcssa.i, ptr %.912.i, align 8, !noalias !71
  %.950.i = getelementptr inbounds i8, ptr %.237.i, i64 %.idx854
  store <8 x double> %_multiply_wide_v76_a30.2.1.lcssa.i, ptr %.950.i, align 8, !noalias !71
  %.960.i = getelementptr i8, ptr %.950.i, i64 64
  store <8 x double> %_multiply_wide_v76_a31.2.1.lcssa.i, ptr %.960.i, align 8, !noalias !71
  %.971.i = getelementptr i8, ptr %.950.i, i64 128
  store <8 x double> %_multiply_wide_v76_a32.2.1.lcssa.i, ptr %.971.i, align 8, !noalias !71
  %.982.i = getelementptr i8, ptr %.950.i, i64 192
  store <8 x double> %_multiply_wide_v76_a33.2.1.lcssa.i, ptr %.982.i, align 8, !noalias !71
  %scevgep25.i8 = getelementptr i8, ptr %lsr.iv24.i3, i64 %31
  %.187.i = icmp sgt i64 %.186852864.i, 1
  br i1 %.187.i, label %B84.if.i, label %B354.else.loopexit.i

B5339.loopexit.i:                                 ; preds = %B884.if.i
  %34 = add i64 %position.5.0897.i, %40
  br label %B5339.i

B5339.i:                                          ; preds = %B356.if.i, %B5339.loopexit.i
  %position.4.1.lcssa.i = phi i64 [ %position.5.0897.i, %B356.if.i ], [ %34, %B5339.loopexit.i ]
  %b0.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B356.if.i ], [ %.1337.i, %B5339.loopexit.i ]
  %b1.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B356.if.i ], [ %.1356.i, %B5339.loopexit.i ]
  %b2.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B356.if.i ], [ %.1376.i, %B5339.loopexit.i ]
  %b3.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B356.if.i ], [ %.1396.i, %B5339.loopexit.i ]
  %.1418.i = getelementptr inbounds double, ptr %.1449, i64 %.1135889895.i
  store <8 x double> %b0.2.1.lcssa.i, ptr %.1418.i, align 8, !noalias !71
  %.1434.i = getelementptr double, ptr %37, i64 %.1135889895.i
  store <8 x double> %b1.2.1.lcssa.i, ptr %.1434.i, align 8, !noalias !71
  %.1451.i = getelementptr double, ptr %38, i64 %.1135889895.i
  store <8 x double> %b2.2.1.lcssa.i, ptr %.1451.i, align 8, !noalias !71
  %.1470.i = getelementptr double, ptr %39, i64 %.1135889895.i
  store <8 x double> %b3.2.1.lcssa.i, ptr %.1470.i, align 8, !noalias !71
  %.1129.i = icmp sgt i64 %.1128888896.i, 1
  br i1 %.1129.i, label %B356.if.i, label %B548.endif.endif.endif

B84.if.i:                                         ; preds = %B280.i, %B84.if.lr.ph.i
  %lsr.iv24.i3 = phi ptr [ %scevgep23.i2, %B84.if.lr.ph.i ], [ %scevgep25.i8, %B280.i ]
  %.186852864.i = phi i64 [ %storemerge.i, %B84.if.lr.ph.i ], [ %.196.i, %B280.i ]
  %.193853863.i = phi i64 [ 0, %B84.if.lr.ph.i ], [ %.200.i, %B280.i ]
  %.196.i = add nsw i64 %.186852864.i, -1
  %.200.i = add nuw nsw i64 %.193853863.i, 32
  %.237.i = getelementptr inbounds nuw double, ptr %.1449, i64 %.193853863.i
  br i1 %33, label %B280.i, label %B200.if.i

B200.if.i:                                        ; preds = %B84.if.i, %B200.if.i
  %lsr.iv43.i = phi i64 [ %lsr.iv.next44.i, %B200.if.i ], [ %.1511, %B84.if.i ]
  %lsr.iv26.i4 = phi i64 [ %lsr.iv.next27.i, %B200.if.i ], [ 0, %B84.if.i ]
  %_multiply_wide_v76_a33.2.1834.i = phi <8 x double> [ %.706.i, %B200.if.i ], [ zeroinitializer, %B84.if.i ]
  %_multiply_wide_v76_a32.2.1833.i = phi <8 x double> [ %.702.i, %B200.if.i ], [ zeroinitializer, %B84.if.i ]
  %_multiply_wide_v76_a31.2.1832.i = phi <8 x double> [ %.694.i, %B200.if.i ], [ zeroinitializer, %B84.if.i ]
  %_multiply_wide_v76_a30.2.1831.i = phi <8 x double> [ %.690.i, %B200.if.i ], [ zeroinitializer, %B84.if.i ]
  %_multiply_wide_v76_a23.2.1830.i = phi <8 x double> [ %.668.i, %B200.if.i ], [ zeroinitializer, %B84.if.i ]
  %_multiply_wide_v76_a22.2.1829.i = phi <8 x double> [ %.664.i, %B200.if.i ], [ zeroinitializer, %B84.if.i ]
  %_multiply_wide_v76_a21.2.1828.i = phi <8 x double> [ %.656.i, %B200.if.i ], [ zeroinitializer, %B84.if.i ]
  %_multiply_wide_v76_a20.2.1827.i = phi <8 x double> [ %.652.i, %B200.if.i ], [ zeroinitializer, %B84.if.i ]
  %_multiply_wide_v76_a13.2.1826.i = phi <8 x double> [ %.630.i, %B200.if.i ], [ zeroinitializer, %B84.if.i ]
  %_multiply_wide_v76_a12.2.1825.i = phi <8 x double> [ %.626.i, %B200.if.i ], [ zeroinitializer, %B84.if.i ]
  %_multiply_wide_v76_a11.2.1824.i = phi <8 x double> [ %.618.i, %B200.if.i ], [ zeroinitializer, %B84.if.i ]
  %_multiply_wide_v76_a10.2.1823.i = phi <8 x double> [ %.614.i, %B200.if.i ], [ zeroinitializer, %B84.if.i ]
  %_multiply_wide_v76_a03.2.1822.i = phi <8 x double> [ %.593.i, %B200.if.i ], [ zeroinitializer, %B84.if.i ]
  %_multiply_wide_v76_a02.2.1821.i = phi <8 x double> [ %.589.i, %B200.if.i ], [ zeroinitializer, %B84.if.i ]
  %_multiply_wide_v76_a01.2.1820.i = phi <8 x double> [ %.581.i, %B200.if.i ], [ zeroinitializer, %B84.if.i ]
  %_multiply_wide_v76_a00.2.1819.i = phi <8 x double> [ %.577.i, %B200.if.i ], [ zeroinitializer, %B84.if.i ]
  %35 = shl i64 %lsr.iv26.i4, 2
  %scevgep33.i = getelementptr i8, ptr %lsr.iv24.i3, i64 %35
  %scevgep34.i = getelementptr i8, ptr %scevgep33.i, i64 -192
  %.520.i = load <8 x double>, ptr %scevgep34.i, align 8, !noalias !71
  %scevgep32.i5 = getelementptr i8, ptr %scevgep33.i, i64 -128
  %.532.i = load <8 x double>, ptr %scevgep32.i5, align 8, !noalias !71
  %scevgep8 = getelementptr i8, ptr %scevgep33.i, i64 -64
  %.545.i = load <8 x double>, ptr %scevgep8, align 8, !noalias !71
  %.558.i = load <8 x double>, ptr %scevgep33.i, align 8, !noalias !71
  %scevgep26 = getelementptr i8, ptr %scevgep20, i64 %lsr.iv26.i4
  %scevgep27 = getelementptr i8, ptr %scevgep26, i64 -24
  %.573.i = load double, ptr %scevgep27, align 8, !noalias !71
  %.575.i = insertelement <8 x double> poison, double %.573.i, i64 0
  %.576.i = shufflevector <8 x double> %.575.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.577.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.520.i, <8 x double> %.576.i, <8 x double> %_multiply_wide_v76_a00.2.1819.i)
  %.581.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.532.i, <8 x double> %.576.i, <8 x double> %_multiply_wide_v76_a01.2.1820.i)
  %.589.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.545.i, <8 x double> %.576.i, <8 x double> %_multiply_wide_v76_a02.2.1821.i)
  %.593.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.558.i, <8 x double> %.576.i, <8 x double> %_multiply_wide_v76_a03.2.1822.i)
  %scevgep5 = getelementptr i8, ptr %scevgep26, i64 -16
  %.610.i = load double, ptr %scevgep5, align 8, !noalias !71
  %.612.i = insertelement <8 x double> poison, double %.610.i, i64 0
  %.613.i = shufflevector <8 x double> %.612.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.614.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.520.i, <8 x double> %.613.i, <8 x double> %_multiply_wide_v76_a10.2.1823.i)
  %.618.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.532.i, <8 x double> %.613.i, <8 x double> %_multiply_wide_v76_a11.2.1824.i)
  %.626.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.545.i, <8 x double> %.613.i, <8 x double> %_multiply_wide_v76_a12.2.1825.i)
  %.630.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.558.i, <8 x double> %.613.i, <8 x double> %_multiply_wide_v76_a13.2.1826.i)
  %scevgep2 = getelementptr i8, ptr %scevgep26, i64 -8
  %.648.i = load double, ptr %scevgep2, align 8, !noalias !71
  %.650.i = insertelement <8 x double> poison, double %.648.i, i64 0
  %.651.i = shufflevector <8 x double> %.650.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.652.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.520.i, <8 x double> %.651.i, <8 x double> %_multiply_wide_v76_a20.2.1827.i)
  %.656.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.532.i, <8 x double> %.651.i, <8 x double> %_multiply_wide_v76_a21.2.1828.i)
  %.664.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.545.i, <8 x double> %.651.i, <8 x double> %_multiply_wide_v76_a22.2.1829.i)
  %.668.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.558.i, <8 x double> %.651.i, <8 x double> %_multiply_wide_v76_a23.2.1830.i)
  %.686.i = load double, ptr %scevgep26, align 8, !noalias !71
  %.688.i = insertelement <8 x double> poison, double %.686.i, i64 0
  %.689.i = shufflevector <8 x double> %.688.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.690.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.520.i, <8 x double> %.689.i, <8 x double> %_multiply_wide_v76_a30.2.1831.i)
  %.694.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.532.i, <8 x double> %.689.i, <8 x double> %_multiply_wide_v76_a31.2.1832.i)
  %.702.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.545.i, <8 x double> %.689.i, <8 x double> %_multiply_wide_v76_a32.2.1833.i)
  %.706.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.558.i, <8 x double> %.689.i, <8 x double> %_multiply_wide_v76_a33.2.1834.i)
  %lsr.iv.next27.i = add nuw i64 %lsr.iv26.i4, 64
  %lsr.iv.next44.i = add i64 %lsr.iv43.i, -1
  %exitcond.not.i7 = icmp eq i64 %lsr.iv.next44.i, 0
  br i1 %exitcond.not.i7, label %B280.i, label %B200.if.i

B354.else.loopexit.i:                             ; preds = %B280.i
  %36 = mul i64 %.1511, %25
  br label %B354.else.i

B354.else.i:                                      ; preds = %B354.else.loopexit.i, %B548.endif.else.endif.endif
  %position.3.0.lcssa.i = phi i64 [ 0, %B548.endif.else.endif.endif ], [ %36, %B354.else.loopexit.i ]
  br i1 %30, label %B548.endif.endif.endif, label %B354.endif.endif.endif.i

B354.endif.endif.endif.i:                         ; preds = %B354.else.i
  %.arg.count811.i = tail call i64 @llvm.smax.i64(i64 %.1511, i64 0)
  %37 = getelementptr double, ptr %.1449, i64 %.153
  %38 = getelementptr i8, ptr %.1449, i64 %.idx
  %39 = getelementptr i8, ptr %.1449, i64 %.idx854
  %40 = shl i64 %.arg.count811.i, 3
  %41 = shl i64 %.1538.sroa.0.3, 3
  %scevgep31 = getelementptr i8, ptr %scevgep, i64 %41
  %42 = icmp slt i64 %.1511, 1
  br label %B356.if.i

B356.if.i:                                        ; preds = %B354.endif.endif.endif.i, %B5339.i
  %position.5.0897.i = phi i64 [ %position.3.0.lcssa.i, %B354.endif.endif.endif.i ], [ %position.4.1.lcssa.i, %B5339.i ]
  %.1128888896.i = phi i64 [ %.1106806.i, %B354.endif.endif.endif.i ], [ %.1138.i, %B5339.i ]
  %.1135889895.i = phi i64 [ %.1046.i, %B354.endif.endif.endif.i ], [ %.1142.i, %B5339.i ]
  %.1138.i = add nsw i64 %.1128888896.i, -1
  %.1142.i = add nuw nsw i64 %.1135889895.i, 8
  br i1 %42, label %B5339.i, label %B884.if.preheader.i

B884.if.preheader.i:                              ; preds = %B356.if.i
  %43 = shl i64 %position.5.0897.i, 3
  %scevgep.i10 = getelementptr i8, ptr %.1151, i64 %43
  br label %B884.if.i

B884.if.i:                                        ; preds = %B884.if.i, %B884.if.preheader.i
  %lsr.iv21.i = phi i64 [ %.1511, %B884.if.preheader.i ], [ %lsr.iv.next22.i, %B884.if.i ]
  %lsr.iv.i11 = phi i64 [ 0, %B884.if.preheader.i ], [ %lsr.iv.next.i12, %B884.if.i ]
  %b3.2.1880.i = phi <8 x double> [ zeroinitializer, %B884.if.preheader.i ], [ %.1396.i, %B884.if.i ]
  %b2.2.1879.i = phi <8 x double> [ zeroinitializer, %B884.if.preheader.i ], [ %.1376.i, %B884.if.i ]
  %b1.2.1878.i = phi <8 x double> [ zeroinitializer, %B884.if.preheader.i ], [ %.1356.i, %B884.if.i ]
  %b0.2.1877.i = phi <8 x double> [ zeroinitializer, %B884.if.preheader.i ], [ %.1337.i, %B884.if.i ]
  %scevgep12.i = getelementptr i8, ptr %scevgep.i10, i64 %lsr.iv.i11
  %.1318.i = load <8 x double>, ptr %scevgep12.i, align 8, !noalias !71
  %scevgep37 = getelementptr i8, ptr %scevgep31, i64 %lsr.iv.i11
  %scevgep38 = getelementptr i8, ptr %scevgep37, i64 -24
  %.1333.i = load double, ptr %scevgep38, align 8, !noalias !71
  %.1335.i = insertelement <8 x double> poison, double %.1333.i, i64 0
  %.1336.i = shufflevector <8 x double> %.1335.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1337.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1318.i, <8 x double> %.1336.i, <8 x double> %b0.2.1877.i)
  %scevgep12 = getelementptr i8, ptr %scevgep37, i64 -16
  %.1352.i = load double, ptr %scevgep12, align 8, !noalias !71
  %.1354.i = insertelement <8 x double> poison, double %.1352.i, i64 0
  %.1355.i = shufflevector <8 x double> %.1354.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1356.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1318.i, <8 x double> %.1355.i, <8 x double> %b1.2.1878.i)
  %scevgep10 = getelementptr i8, ptr %scevgep37, i64 -8
  %.1372.i = load double, ptr %scevgep10, align 8, !noalias !71
  %.1374.i = insertelement <8 x double> poison, double %.1372.i, i64 0
  %.1375.i = shufflevector <8 x double> %.1374.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1376.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1318.i, <8 x double> %.1375.i, <8 x double> %b2.2.1879.i)
  %.1392.i = load double, ptr %scevgep37, align 8, !noalias !71
  %.1394.i = insertelement <8 x double> poison, double %.1392.i, i64 0
  %.1395.i = shufflevector <8 x double> %.1394.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1396.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1318.i, <8 x double> %.1395.i, <8 x double> %b3.2.1880.i)
  %lsr.iv.next.i12 = add nuw i64 %lsr.iv.i11, 64
  %lsr.iv.next22.i = add i64 %lsr.iv21.i, -1
  %exitcond905.not.i = icmp eq i64 %lsr.iv.next22.i, 0
  br i1 %exitcond905.not.i, label %B5339.loopexit.i, label %B884.if.i

B548.endif.endif.endif:                           ; preds = %B5339.i, %B354.else.i
  %.1269 = icmp sgt i64 %.1268845849, 1
  br i1 %.1269, label %B546.if, label %B696

B740.else.if:                                     ; preds = %B740
  br label %B740.else.endif

B740.else.endif:                                  ; preds = %B740.else.if, %B740
  %.1833.sroa.0.1 = phi i64 [ 0, %B740.else.if ], [ %.1845, %B740 ]
  %.1853.not = icmp slt i64 %.1845, 1073741824
  br i1 %.1853.not, label %B740.else.endif.endif, label %B740.else.endif.if, !prof !5

B740.else.endif.if:                               ; preds = %B740.else.endif
  br label %B740.else.endif.endif

B740.else.endif.endif:                            ; preds = %B740.else.endif.if, %B740.else.endif
  %.1833.sroa.0.3 = phi i64 [ 1073741824, %B740.else.endif.if ], [ %.1833.sroa.0.1, %B740.else.endif ]
  %.1921 = sub nsw i64 1073741824, %.1833.sroa.0.3
  %.1930 = tail call i64 @llvm.smax.i64(i64 %.1921, i64 0)
  %.1946 = getelementptr double, ptr %arg.weights.4, i64 %.1833.sroa.0.3
  %.2029 = icmp slt i64 %.184.sroa.13.2, 9
  br i1 %.2029, label %B740.endif.else.endif.if, label %B740.endif.else.endif.endif, !prof !1

B740.endif.else.endif.if:                         ; preds = %B740.else.endif.endif
  br label %B740.endif.else.endif.endif

B740.endif.else.endif.endif:                      ; preds = %B740.endif.else.endif.if, %B740.else.endif.endif
  %.2009.sroa.0.3 = phi i64 [ %.184.sroa.13.2, %B740.endif.else.endif.if ], [ 8, %B740.else.endif.endif ]
  %.2122 = getelementptr double, ptr %arg.scratch.4, i64 %.2009.sroa.0.3
  store ptr null, ptr %.2159, align 8
  call fastcc void @inner_16(ptr nonnull %.2159, ptr %arg.coordinates.4, i64 %arg.rows, ptr %arg.contents.4, ptr %.1946, i64 %.1930, ptr %.469, i64 %.453, ptr %.2122, i64 %.153)
  br label %B856
}

; Function Attrs: mustprogress nocallback nocreateundeforpoison nofree nosync nounwind speculatable willreturn memory(none)
declare <8 x double> @llvm.fma.v8f64(<8 x double>, <8 x double>, <8 x double>) #3

; Function Attrs: nofree noinline norecurse nosync nounwind memory(argmem: readwrite)
define internal fastcc void @inner_16(ptr noalias nonnull writeonly captures(none) %retptr, ptr readonly captures(none) %arg.coordinates.4, i64 %arg.rows, ptr readonly captures(none) %arg.contents.4, ptr readonly captures(none) %arg.layers.4, i64 range(i64 0, 1073741825) %arg.layers.5.0, ptr %arg.scratch.4, i64 range(i64 0, 1073741825) %arg.scratch.5.0, ptr captures(none) %arg.out.4, i64 range(i64 16, 9) %arg.out_row) unnamed_addr #6 {
entry:
  %.107 = getelementptr i8, ptr %arg.contents.4, i64 40
  %.108 = load i64, ptr %.107, align 8
  %.109 = sub i64 0, %.108
  %.117.1 = and i64 %.109, -8
  %.152 = sub i64 8, %.117.1
  %.157 = shl i64 %.152, 3
  %.210 = icmp slt i64 %.152, 0
  %.211 = select i1 %.210, i64 %arg.scratch.5.0, i64 0
  %.212 = add i64 %.211, %.157
  %.215 = icmp slt i64 %.212, 0
  br i1 %.215, label %B0.endif.else.endif.endif.if, label %B0.endif.else.endif.endif.endif, !prof !1

B406:                                             ; preds = %B216.if
  %.979 = getelementptr i8, ptr %arg.contents.4, i64 32
  %.980 = load i64, ptr %.979, align 8
  %.981 = add nsw i64 %.980, -1
  %.1069813.not = icmp slt i64 %.980, 1
  br i1 %.1069813.not, label %B1114, label %B488.if.lr.ph

B488.if.lr.ph:                                    ; preds = %B406
  %.471 = getelementptr double, ptr %arg.scratch.4, i64 %.358.sroa.0.3
  %0 = add nuw i64 %arg.rows, 3
  %.1287 = lshr i64 %0, 2
  %.1266.inv = icmp sgt i64 %arg.rows, 0
  %storemerge762 = select i1 %.1266.inv, i64 %.1287, i64 0
  %.idx814.i = mul i64 %.152, 24
  %1 = icmp eq i64 %storemerge762, 0
  %2 = icmp slt i64 %arg.rows, 1
  %sunkaddr76 = getelementptr i8, ptr %arg.contents.4, i64 48
  br label %B488.if

B816:                                             ; preds = %B662.endif.endif.endif.endif, %B488.if
  %.1924 = mul nsw i64 %.1144, %.1224
  %.1928 = add nsw i64 %.1924, %position.2.0818
  %.1936 = icmp sge i64 %.1013.0, %.981
  %or.cond = select i1 %.1936, i1 true, i1 %2
  br i1 %or.cond, label %B1102, label %B874.if.lr.ph

B874.if.lr.ph:                                    ; preds = %B816
  %smax = tail call i64 @llvm.smax.i64(i64 %.1190.1, i64 0)
  %scevgep46 = getelementptr i8, ptr %following.2.sroa.44.0815, i64 64
  %reass.sub = sub nsw i64 %smax, %.1190.1
  %3 = add nsw i64 %reass.sub, 7
  %4 = icmp slt i64 %.1190.1, 0
  br label %B874.if

B874.loopexit:                                    ; preds = %B974.endif, %B874.if
  %scevgep48 = getelementptr i8, ptr %lsr.iv47, i64 %.157
  %exitcond854.not = icmp eq i64 %arg.rows, %.2033
  br i1 %exitcond854.not, label %B1102, label %B874.if

B1102:                                            ; preds = %B874.loopexit, %B816
  %exitcond.not16 = icmp eq i64 %.1082, %.980
  br i1 %exitcond.not16, label %B1114, label %B488.if

B1114:                                            ; preds = %B1102, %B406
  %current.2.sroa.40.0.lcssa = phi ptr [ %arg.scratch.4, %B406 ], [ %following.2.sroa.44.0815, %B1102 ]
  %columns.1.0.lcssa = phi i64 [ 0, %B406 ], [ %.1224, %B1102 ]
  %.2420835.not = icmp slt i64 %arg.rows, 1
  br i1 %.2420835.not, label %B1340, label %B1144.if.lr.ph

B1144.if.lr.ph:                                   ; preds = %B1114
  %5 = tail call i64 @llvm.smax.i64(i64 %columns.1.0.lcssa, i64 0)
  %storemerge760 = lshr i64 %5, 3
  %scevgep = getelementptr i8, ptr %current.2.sroa.40.0.lcssa, i64 64
  %6 = shl i64 %.109, 3
  %7 = and i64 %6, -64
  %8 = sub i64 64, %7
  %9 = shl i64 %arg.out_row, 3
  %10 = add nuw nsw i64 %storemerge760, 7
  %11 = icmp slt i64 %columns.1.0.lcssa, 1
  br label %B1144.if

B1144.loopexit:                                   ; preds = %B1192.if, %B1144.if
  %scevgep18 = getelementptr i8, ptr %lsr.iv17, i64 %8
  %scevgep23 = getelementptr i8, ptr %lsr.iv22, i64 %9
  %exitcond856.not = icmp eq i64 %.2433, %arg.rows
  br i1 %exitcond856.not, label %B1340, label %B1144.if

B1340:                                            ; preds = %B1144.loopexit, %B1114
  store ptr null, ptr %retptr, align 8
  ret void

B0.endif.else.endif.endif.if:                     ; preds = %entry
  br label %B0.endif.else.endif.endif.endif

B0.endif.else.endif.endif.endif:                  ; preds = %B0.endif.else.endif.endif.if, %entry
  %.183.sroa.13.1 = phi i64 [ 0, %B0.endif.else.endif.endif.if ], [ %.212, %entry ]
  %.220.not = icmp slt i64 %.212, %arg.scratch.5.0
  br i1 %.220.not, label %B0.endif.else.endif.endif.endif.endif, label %B0.endif.else.endif.endif.endif.if, !prof !5

B0.endif.else.endif.endif.endif.if:               ; preds = %B0.endif.else.endif.endif.endif
  br label %B0.endif.else.endif.endif.endif.endif

B0.endif.else.endif.endif.endif.endif:            ; preds = %B0.endif.else.endif.endif.endif.if, %B0.endif.else.endif.endif.endif
  %.183.sroa.13.2 = phi i64 [ %arg.scratch.5.0, %B0.endif.else.endif.endif.endif.if ], [ %.183.sroa.13.1, %B0.endif.else.endif.endif.endif ]
  %.332 = shl i64 %.152, 4
  br i1 %.215, label %B0.endif.endif.else.if, label %B0.endif.endif.else.endif, !prof !1

B0.endif.endif.else.if:                           ; preds = %B0.endif.else.endif.endif.endif.endif
  br label %B0.endif.endif.else.endif

B0.endif.endif.else.endif:                        ; preds = %B0.endif.endif.else.if, %B0.endif.else.endif.endif.endif.endif
  %.358.sroa.0.1 = phi i64 [ 0, %B0.endif.endif.else.if ], [ %.212, %B0.endif.else.endif.endif.endif.endif ]
  br i1 %.220.not, label %B0.endif.endif.else.endif.endif, label %B0.endif.endif.else.endif.if, !prof !5

B0.endif.endif.else.endif.if:                     ; preds = %B0.endif.endif.else.endif
  br label %B0.endif.endif.else.endif.endif

B0.endif.endif.else.endif.endif:                  ; preds = %B0.endif.endif.else.endif.if, %B0.endif.endif.else.endif
  %.358.sroa.0.3 = phi i64 [ %arg.scratch.5.0, %B0.endif.endif.else.endif.if ], [ %.358.sroa.0.1, %B0.endif.endif.else.endif ]
  %.387 = add i64 %.211, %.332
  %.390 = icmp slt i64 %.387, 0
  br i1 %.390, label %B0.endif.endif.else.endif.endif.if, label %B0.endif.endif.else.endif.endif.endif, !prof !1

B0.endif.endif.else.endif.endif.if:               ; preds = %B0.endif.endif.else.endif.endif
  br label %B0.endif.endif.else.endif.endif.endif

B0.endif.endif.else.endif.endif.endif:            ; preds = %B0.endif.endif.else.endif.endif.if, %B0.endif.endif.else.endif.endif
  %.358.sroa.13.1 = phi i64 [ 0, %B0.endif.endif.else.endif.endif.if ], [ %.387, %B0.endif.endif.else.endif.endif ]
  %.395.not = icmp slt i64 %.387, %arg.scratch.5.0
  br i1 %.395.not, label %B0.endif.endif.else.endif.endif.endif.endif, label %B0.endif.endif.else.endif.endif.endif.if, !prof !5

B0.endif.endif.else.endif.endif.endif.if:         ; preds = %B0.endif.endif.else.endif.endif.endif
  br label %B0.endif.endif.else.endif.endif.endif.endif

B0.endif.endif.else.endif.endif.endif.endif:      ; preds = %B0.endif.endif.else.endif.endif.endif.if, %B0.endif.endif.else.endif.endif.endif
  %.358.sroa.13.2 = phi i64 [ %arg.scratch.5.0, %B0.endif.endif.else.endif.endif.endif.if ], [ %.358.sroa.13.1, %B0.endif.endif.else.endif.endif.endif ]
  %.446 = sub nsw i64 %.358.sroa.13.2, %.358.sroa.0.3
  %.455 = tail call i64 @llvm.smax.i64(i64 %.446, i64 0)
  %12 = shl i64 %.358.sroa.0.3, 3
  %13 = shl i64 %.183.sroa.13.2, 3
  %14 = shl i64 %.455, 3
  %15 = add i64 %13, 56
  %16 = add i64 %13, 64
  %17 = add i64 %13, 72
  %18 = add i64 %13, 80
  %19 = add i64 %13, 88
  %20 = add i64 %13, 96
  br label %B216.if

B216.if:                                          ; preds = %B216.if, %B0.endif.endif.else.endif.endif.endif.endif
  %lsr.iv = phi ptr [ %scevgep45, %B216.if ], [ %arg.scratch.4, %B0.endif.endif.else.endif.endif.endif.endif ]
  %lsr.iv54 = phi i64 [ %lsr.iv.next55, %B216.if ], [ -64, %B0.endif.endif.else.endif.endif.endif.endif ]
  %lsr.iv63 = phi i64 [ %lsr.iv.next64, %B216.if ], [ 0, %B0.endif.endif.else.endif.endif.endif.endif ]
  %.664 = icmp slt i64 %lsr.iv63, 0
  %21 = select i1 %.664, i64 %15, i64 56
  %scevgep56 = getelementptr i8, ptr %lsr.iv, i64 %21
  store double 1.000000e+00, ptr %scevgep56, align 8
  %22 = select i1 %.664, i64 %14, i64 0
  %23 = getelementptr i8, ptr %lsr.iv, i64 %12
  %24 = getelementptr i8, ptr %23, i64 56
  %scevgep49 = getelementptr i8, ptr %24, i64 %22
  store double 1.000000e+00, ptr %scevgep49, align 8
  %sunkaddr = getelementptr i8, ptr %arg.coordinates.4, i64 %lsr.iv54
  %sunkaddr67 = getelementptr i8, ptr %sunkaddr, i64 64
  %.865 = load double, ptr %sunkaddr67, align 8
  %.884 = icmp slt i64 %lsr.iv63, -8
  %25 = select i1 %.884, i64 %16, i64 64
  %scevgep55 = getelementptr i8, ptr %lsr.iv, i64 %25
  store double %.865, ptr %scevgep55, align 8
  %sunkaddr69 = getelementptr i8, ptr %sunkaddr, i64 128
  %.865.1 = load double, ptr %sunkaddr69, align 8
  %.884.1 = icmp slt i64 %lsr.iv63, -9
  %26 = select i1 %.884.1, i64 %17, i64 72
  %scevgep54 = getelementptr i8, ptr %lsr.iv, i64 %26
  store double %.865.1, ptr %scevgep54, align 8
  %sunkaddr71 = getelementptr i8, ptr %sunkaddr, i64 192
  %.865.2 = load double, ptr %sunkaddr71, align 8
  %.884.2 = icmp slt i64 %lsr.iv63, -10
  %27 = select i1 %.884.2, i64 %18, i64 80
  %scevgep53 = getelementptr i8, ptr %lsr.iv, i64 %27
  store double %.865.2, ptr %scevgep53, align 8
  %sunkaddr73 = getelementptr i8, ptr %sunkaddr, i64 256
  %.865.3 = load double, ptr %sunkaddr73, align 8
  %.884.3 = icmp slt i64 %lsr.iv63, -11
  %28 = select i1 %.884.3, i64 %19, i64 88
  %scevgep52 = getelementptr i8, ptr %lsr.iv, i64 %28
  store double %.865.3, ptr %scevgep52, align 8
  %sunkaddr75 = getelementptr i8, ptr %sunkaddr, i64 320
  %.865.4 = load double, ptr %sunkaddr75, align 8
  %.884.4 = icmp slt i64 %lsr.iv63, -12
  %29 = select i1 %.884.4, i64 %20, i64 96
  %scevgep51 = getelementptr i8, ptr %lsr.iv, i64 %29
  store double %.865.4, ptr %scevgep51, align 8
  %lsr.iv.next64 = add i64 %lsr.iv63, %.152
  %lsr.iv.next55 = add nsw i64 %lsr.iv54, 8
  %scevgep45 = getelementptr i8, ptr %lsr.iv, i64 %.157
  %ov = icmp eq i64 %lsr.iv.next55, 0
  br i1 %ov, label %B406, label %B216.if

B488.if:                                          ; preds = %B1102, %B488.if.lr.ph
  %.1013.0 = phi i64 [ 0, %B488.if.lr.ph ], [ %.1082, %B1102 ]
  %position.2.0818 = phi i64 [ 0, %B488.if.lr.ph ], [ %.1928, %B1102 ]
  %current.2.sroa.40.0817 = phi ptr [ %arg.scratch.4, %B488.if.lr.ph ], [ %following.2.sroa.44.0815, %B1102 ]
  %current.2.sroa.50.0816 = phi i64 [ %.183.sroa.13.2, %B488.if.lr.ph ], [ %following.2.sroa.55.0814, %B1102 ]
  %following.2.sroa.44.0815 = phi ptr [ %.471, %B488.if.lr.ph ], [ %current.2.sroa.40.0817, %B1102 ]
  %following.2.sroa.55.0814 = phi i64 [ %.455, %B488.if.lr.ph ], [ %current.2.sroa.50.0816, %B1102 ]
  %.1082 = add nuw nsw i64 %.1013.0, 1
  %30 = getelementptr i64, ptr %arg.contents.4, i64 %.1013.0
  %31 = getelementptr i8, ptr %30, i64 168
  %.1143 = load i64, ptr %31, align 8
  %.1144 = add i64 %.1143, 1
  %32 = getelementptr i8, ptr %30, i64 176
  %.1181 = load i64, ptr %32, align 8
  %.1182 = sub i64 0, %.1181
  %.1190.1 = ashr i64 %.1182, 3
  %33 = and i64 %.1182, -8
  %.1224 = sub i64 0, %33
  br i1 %1, label %B816, label %B660.if.lr.ph

B660.if.lr.ph:                                    ; preds = %B488.if
  %.1739 = icmp slt i64 %position.2.0818, 0
  %.1740 = select i1 %.1739, i64 %arg.layers.5.0, i64 0
  %.1741 = add i64 %.1740, %position.2.0818
  %34 = tail call i64 @llvm.smax.i64(i64 %.1224, i64 31)
  %storemerge.i = lshr i64 %34, 5
  %.1086.i = and i64 %.1224, 24
  %35 = shl i64 %.1144, 8
  %factor.op.mul = shl i64 %.1144, 5
  %.reass = mul i64 %factor.op.mul, %storemerge.i
  %.1046.i = and i64 %.1224, -32
  %.1106806.i = lshr exact i64 %.1086.i, 3
  %.arg.count815.i = tail call i64 @llvm.smax.i64(i64 %.1144, i64 0)
  %36 = shl i64 %.arg.count815.i, 3
  %37 = icmp slt i64 %.1741, 0
  %38 = icmp slt i64 %.1741, %arg.layers.5.0
  %39 = icmp eq i64 %storemerge.i, 0
  %40 = icmp eq i64 %.1086.i, 0
  %41 = icmp slt i64 %.1143, 0
  %42 = icmp slt i64 %.1143, 0
  br label %B660.if

B660.if:                                          ; preds = %B662.endif.endif.endif.endif, %B660.if.lr.ph
  %.1252.0 = phi i64 [ 0, %B660.if.lr.ph ], [ %.1321, %B662.endif.endif.endif.endif ]
  %.1307791 = phi i64 [ %storemerge762, %B660.if.lr.ph ], [ %.1317, %B662.endif.endif.endif.endif ]
  %.1317 = add nsw i64 %.1307791, -1
  %.1321 = add nuw i64 %.1252.0, 4
  %.1347 = mul nsw i64 %.1252.0, %.152
  %.1348 = or disjoint i64 %.1347, 8
  %.1349 = or disjoint i64 %.1347, 7
  %.1386 = icmp slt i64 %.1347, 0
  %.1387 = select i1 %.1386, i64 %current.2.sroa.50.0816, i64 0
  %.1388 = add i64 %.1387, %.1349
  %.1391 = icmp slt i64 %.1388, 0
  br i1 %.1391, label %B662.else.if, label %B662.else.endif, !prof !1

B662.else.if:                                     ; preds = %B660.if
  br label %B662.else.endif

B662.else.endif:                                  ; preds = %B662.else.if, %B660.if
  %.1376.sroa.0.1 = phi i64 [ 0, %B662.else.if ], [ %.1388, %B660.if ]
  %.1396.not = icmp slt i64 %.1388, %current.2.sroa.50.0816
  br i1 %.1396.not, label %B662.else.endif.endif, label %B662.else.endif.if, !prof !5

B662.else.endif.if:                               ; preds = %B662.else.endif
  br label %B662.else.endif.endif

B662.else.endif.endif:                            ; preds = %B662.else.endif.if, %B662.else.endif
  %.1376.sroa.0.3 = phi i64 [ %current.2.sroa.50.0816, %B662.else.endif.if ], [ %.1376.sroa.0.1, %B662.else.endif ]
  %.1489 = getelementptr double, ptr %current.2.sroa.40.0817, i64 %.1376.sroa.0.3
  %.1560 = icmp slt i64 %.1347, -8
  %.1561 = select i1 %.1560, i64 %following.2.sroa.55.0814, i64 0
  %.1562 = add i64 %.1561, %.1348
  %.1565 = icmp slt i64 %.1562, 0
  br i1 %.1565, label %B662.endif.else.if, label %B662.endif.else.endif, !prof !1

B662.endif.else.if:                               ; preds = %B662.else.endif.endif
  br label %B662.endif.else.endif

B662.endif.else.endif:                            ; preds = %B662.endif.else.if, %B662.else.endif.endif
  %.1550.sroa.0.1 = phi i64 [ 0, %B662.endif.else.if ], [ %.1562, %B662.else.endif.endif ]
  %.1570.not = icmp slt i64 %.1562, %following.2.sroa.55.0814
  br i1 %.1570.not, label %B662.endif.else.endif.endif, label %B662.endif.else.endif.if, !prof !5

B662.endif.else.endif.if:                         ; preds = %B662.endif.else.endif
  br label %B662.endif.else.endif.endif

B662.endif.else.endif.endif:                      ; preds = %B662.endif.else.endif.if, %B662.endif.else.endif
  %.1550.sroa.0.3 = phi i64 [ %following.2.sroa.55.0814, %B662.endif.else.endif.if ], [ %.1550.sroa.0.1, %B662.endif.else.endif ]
  %.1663 = getelementptr double, ptr %following.2.sroa.44.0815, i64 %.1550.sroa.0.3
  br i1 %37, label %B662.endif.endif.else.if, label %B662.endif.endif.else.endif, !prof !1

B662.endif.endif.else.if:                         ; preds = %B662.endif.else.endif.endif
  br label %B662.endif.endif.else.endif

B662.endif.endif.else.endif:                      ; preds = %B662.endif.endif.else.if, %B662.endif.else.endif.endif
  %.1729.sroa.0.1 = phi i64 [ 0, %B662.endif.endif.else.if ], [ %.1741, %B662.endif.else.endif.endif ]
  br i1 %38, label %B662.endif.endif.else.endif.endif, label %B662.endif.endif.else.endif.if, !prof !5

B662.endif.endif.else.endif.if:                   ; preds = %B662.endif.endif.else.endif
  br label %B662.endif.endif.else.endif.endif

B662.endif.endif.else.endif.endif:                ; preds = %B662.endif.endif.else.endif.if, %B662.endif.endif.else.endif
  %.1729.sroa.0.3 = phi i64 [ %arg.layers.5.0, %B662.endif.endif.else.endif.if ], [ %.1729.sroa.0.1, %B662.endif.endif.else.endif ]
  %.1842 = getelementptr double, ptr %arg.layers.4, i64 %.1729.sroa.0.3
  br i1 %39, label %B354.else.i, label %B84.if.lr.ph.i

B84.if.lr.ph.i:                                   ; preds = %B662.endif.endif.else.endif.endif
  %43 = getelementptr double, ptr %.1489, i64 %.152
  %44 = getelementptr i8, ptr %.1489, i64 %.332
  %45 = getelementptr i8, ptr %.1489, i64 %.idx814.i
  %scevgep17.i = getelementptr i8, ptr %.1842, i64 192
  br label %B84.if.i

B280.i:                                           ; preds = %B200.if.i, %B84.if.i
  %_multiply_wide_v86_a00.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B84.if.i ], [ %.577.i, %B200.if.i ]
  %_multiply_wide_v86_a01.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B84.if.i ], [ %.581.i, %B200.if.i ]
  %_multiply_wide_v86_a02.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B84.if.i ], [ %.589.i, %B200.if.i ]
  %_multiply_wide_v86_a03.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B84.if.i ], [ %.593.i, %B200.if.i ]
  %_multiply_wide_v86_a10.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B84.if.i ], [ %.614.i, %B200.if.i ]
  %_multiply_wide_v86_a11.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B84.if.i ], [ %.618.i, %B200.if.i ]
  %_multiply_wide_v86_a12.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B84.if.i ], [ %.626.i, %B200.if.i ]
  %_multiply_wide_v86_a13.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B84.if.i ], [ %.630.i, %B200.if.i ]
  %_multiply_wide_v86_a20.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B84.if.i ], [ %.652.i, %B200.if.i ]
  %_multiply_wide_v86_a21.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B84.if.i ], [ %.656.i, %B200.if.i ]
  %_multiply_wide_v86_a22.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B84.if.i ], [ %.664.i, %B200.if.i ]
  %_multiply_wide_v86_a23.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B84.if.i ], [ %.668.i, %B200.if.i ]
  %_multiply_wide_v86_a30.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B84.if.i ], [ %.690.i, %B200.if.i ]
  %_multiply_wide_v86_a31.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B84.if.i ], [ %.694.i, %B200.if.i ]
  %_multiply_wide_v86_a32.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B84.if.i ], [ %.702.i, %B200.if.i ]
  %_multiply_wide_v86_a33.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B84.if.i ], [ %.706.i, %B200.if.i ]
  store <8 x double> %_multiply_wide_v86_a00.2.1.lcssa.i, ptr %.237.i, align 8, !noalias !74
  %.765.i = getelementptr inbounds nuw i8, ptr %.237.i, i64 64
  store <8 x double> %_multiply_wide_v86_a01.2.1.lcssa.i, ptr %.765.i, align 8, !noalias !74
  %.776.i = getelementptr inbounds nuw i8, ptr %.237.i, i64 128
  store <8 x double> %_multiply_wide_v86_a02.2.1.lcssa.i, ptr %.776.i, align 8, !noalias !74
  %.787.i = getelementptr inbounds nuw i8, ptr %.237.i, i64 192
  store <8 x double> %_multiply_wide_v86_a03.2.1.lcssa.i, ptr %.787.i, align 8, !noalias !74
  %.817.i = getelementptr inbounds double, ptr %.237.i, i64 %.152
  store <8 x double> %_multiply_wide_v86_a10.2.1.lcssa.i, ptr %.817.i, align 8, !noalias !74
  %.827.i = getelementptr i8, ptr %.817.i, i64 64
  store <8 x double> %_multiply_wide_v86_a11.2.1.lcssa.i, ptr %.827.i, align 8, !noalias !74
  %.838.i = getelementptr i8, ptr %.817.i, i64 128
  store <8 x double> %_multiply_wide_v86_a12.2.1.lcssa.i, ptr %.838.i, align 8, !noalias !74
  %.849.i = getelementptr i8, ptr %.817.i, i64 192
  store <8 x double> %_multiply_wide_v86_a13.2.1.lcssa.i, ptr %.849.i, align 8, !noalias !74
  %.880.i = getelementptr inbounds i8, ptr %.237.i, i64 %.332
  store <8 x double> %_multiply_wide_v86_a20.2.1.lcssa.i, ptr %.880.i, align 8, !noalias !74
  %.890.i = getelementptr i8, ptr %.880.i, i64 64
  store <8 x double> %_multiply_wide_v86_a21.2.1.lcssa.i, ptr %.890.i, align 8, !noalias !74
  %.901.i = getelementptr i8, ptr %.880.i, i64 128
  store <8 x double> %_multiply_wide_v86_a22.2.1.lcssa.i, ptr %.901.i, align 8, !noalias !74
  %.912.i = getelementptr i8, ptr %.880.i, i64 192
  store <8 x double> %_multiply_wide_v86_a23.2.1.lcssa.i, ptr %.912.i, align 8, !noalias !74
  %.950.i = getelementptr inbounds i8, ptr %.237.i, i64 %.idx814.i
  store <8 x double> %_multiply_wide_v86_a30.2.1.lcssa.i, ptr %.950.i, align 8, !noalias !74
  %.960.i = getelementptr i8, ptr %.950.i, i64 64
  store <8 x double> %_multiply_wide_v86_a31.2.1.lcssa.i, ptr %.960.i, align 8, !noalias !74
  %.971.i = getelementptr i8, ptr %.950.i, i64 128
  store <8 x double> %_multiply_wide_v86_a32.2.1.lcssa.i, ptr %.971.i, align 8, !noalias !74
  %.982.i = getelementptr i8, ptr %.950.i, i64 192
  store <8 x double> %_multiply_wide_v86_a33.2.1.lcssa.i, ptr %.982.i, align 8, !noalias !74
  %scevgep19.i = getelementptr i8, ptr %lsr.iv18.i, i64 %35
  %.187.i = icmp sgt i64 %.186856868.i, 1
  br i1 %.187.i, label %B84.if.i, label %B354.else.i

B6509.loopexit.i:                                 ; preds = %B884.if.i
  %46 = add i64 %position.5.0901.i, %36
  br label %B6509.i

B6509.i:                                          ; preds = %B356.if.i, %B6509.loopexit.i
  %position.4.1.lcssa.i = phi i64 [ %position.5.0901.i, %B356.if.i ], [ %46, %B6509.loopexit.i ]
  %b0.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B356.if.i ], [ %.1337.i, %B6509.loopexit.i ]
  %b1.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B356.if.i ], [ %.1356.i, %B6509.loopexit.i ]
  %b2.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B356.if.i ], [ %.1376.i, %B6509.loopexit.i ]
  %b3.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B356.if.i ], [ %.1396.i, %B6509.loopexit.i ]
  %.1418.i = getelementptr inbounds double, ptr %.1663, i64 %.1135893899.i
  store <8 x double> %b0.2.1.lcssa.i, ptr %.1418.i, align 8, !noalias !74
  %.1434.i = getelementptr double, ptr %51, i64 %.1135893899.i
  store <8 x double> %b1.2.1.lcssa.i, ptr %.1434.i, align 8, !noalias !74
  %.1451.i = getelementptr double, ptr %52, i64 %.1135893899.i
  store <8 x double> %b2.2.1.lcssa.i, ptr %.1451.i, align 8, !noalias !74
  %.1470.i = getelementptr double, ptr %53, i64 %.1135893899.i
  store <8 x double> %b3.2.1.lcssa.i, ptr %.1470.i, align 8, !noalias !74
  %.1129.i = icmp sgt i64 %.1128892900.i, 1
  br i1 %.1129.i, label %B356.if.i, label %B662.endif.endif.endif.endif

B84.if.i:                                         ; preds = %B280.i, %B84.if.lr.ph.i
  %lsr.iv18.i = phi ptr [ %scevgep17.i, %B84.if.lr.ph.i ], [ %scevgep19.i, %B280.i ]
  %.186856868.i = phi i64 [ %storemerge.i, %B84.if.lr.ph.i ], [ %.196.i, %B280.i ]
  %.193857867.i = phi i64 [ 0, %B84.if.lr.ph.i ], [ %.200.i, %B280.i ]
  %.196.i = add nsw i64 %.186856868.i, -1
  %.200.i = add nuw nsw i64 %.193857867.i, 32
  %.237.i = getelementptr inbounds nuw double, ptr %.1663, i64 %.193857867.i
  br i1 %41, label %B280.i, label %B200.if.i

B200.if.i:                                        ; preds = %B84.if.i, %B200.if.i
  %lsr.iv25 = phi i64 [ %lsr.iv.next26, %B200.if.i ], [ -1, %B84.if.i ]
  %lsr.iv20.i = phi ptr [ %scevgep21.i, %B200.if.i ], [ %lsr.iv18.i, %B84.if.i ]
  %_multiply_wide_v86_a33.2.1838.i = phi <8 x double> [ %.706.i, %B200.if.i ], [ zeroinitializer, %B84.if.i ]
  %_multiply_wide_v86_a32.2.1837.i = phi <8 x double> [ %.702.i, %B200.if.i ], [ zeroinitializer, %B84.if.i ]
  %_multiply_wide_v86_a31.2.1836.i = phi <8 x double> [ %.694.i, %B200.if.i ], [ zeroinitializer, %B84.if.i ]
  %_multiply_wide_v86_a30.2.1835.i = phi <8 x double> [ %.690.i, %B200.if.i ], [ zeroinitializer, %B84.if.i ]
  %_multiply_wide_v86_a23.2.1834.i = phi <8 x double> [ %.668.i, %B200.if.i ], [ zeroinitializer, %B84.if.i ]
  %_multiply_wide_v86_a22.2.1833.i = phi <8 x double> [ %.664.i, %B200.if.i ], [ zeroinitializer, %B84.if.i ]
  %_multiply_wide_v86_a21.2.1832.i = phi <8 x double> [ %.656.i, %B200.if.i ], [ zeroinitializer, %B84.if.i ]
  %_multiply_wide_v86_a20.2.1831.i = phi <8 x double> [ %.652.i, %B200.if.i ], [ zeroinitializer, %B84.if.i ]
  %_multiply_wide_v86_a13.2.1830.i = phi <8 x double> [ %.630.i, %B200.if.i ], [ zeroinitializer, %B84.if.i ]
  %_multiply_wide_v86_a12.2.1829.i = phi <8 x double> [ %.626.i, %B200.if.i ], [ zeroinitializer, %B84.if.i ]
  %_multiply_wide_v86_a11.2.1828.i = phi <8 x double> [ %.618.i, %B200.if.i ], [ zeroinitializer, %B84.if.i ]
  %_multiply_wide_v86_a10.2.1827.i = phi <8 x double> [ %.614.i, %B200.if.i ], [ zeroinitializer, %B84.if.i ]
  %_multiply_wide_v86_a03.2.1826.i = phi <8 x double> [ %.593.i, %B200.if.i ], [ zeroinitializer, %B84.if.i ]
  %_multiply_wide_v86_a02.2.1825.i = phi <8 x double> [ %.589.i, %B200.if.i ], [ zeroinitializer, %B84.if.i ]
  %_multiply_wide_v86_a01.2.1824.i = phi <8 x double> [ %.581.i, %B200.if.i ], [ zeroinitializer, %B84.if.i ]
  %_multiply_wide_v86_a00.2.1823.i = phi <8 x double> [ %.577.i, %B200.if.i ], [ zeroinitializer, %B84.if.i ]
  %scevgep24.i = getelementptr i8, ptr %lsr.iv20.i, i64 -192
  %.520.i = load <8 x double>, ptr %scevgep24.i, align 8, !noalias !74
  %scevgep23.i = getelementptr i8, ptr %lsr.iv20.i, i64 -128
  %.532.i = load <8 x double>, ptr %scevgep23.i, align 8, !noalias !74
  %scevgep22.i = getelementptr i8, ptr %lsr.iv20.i, i64 -64
  %.545.i = load <8 x double>, ptr %scevgep22.i, align 8, !noalias !74
  %.558.i = load <8 x double>, ptr %lsr.iv20.i, align 8, !noalias !74
  %47 = shl i64 %lsr.iv25, 3
  %scevgep33 = getelementptr i8, ptr %.1489, i64 %47
  %scevgep34 = getelementptr i8, ptr %scevgep33, i64 8
  %.573.i = load double, ptr %scevgep34, align 8, !noalias !74
  %.575.i = insertelement <8 x double> poison, double %.573.i, i64 0
  %.576.i = shufflevector <8 x double> %.575.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.577.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.520.i, <8 x double> %.576.i, <8 x double> %_multiply_wide_v86_a00.2.1823.i)
  %.581.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.532.i, <8 x double> %.576.i, <8 x double> %_multiply_wide_v86_a01.2.1824.i)
  %.589.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.545.i, <8 x double> %.576.i, <8 x double> %_multiply_wide_v86_a02.2.1825.i)
  %.593.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.558.i, <8 x double> %.576.i, <8 x double> %_multiply_wide_v86_a03.2.1826.i)
  %scevgep35 = getelementptr i8, ptr %43, i64 %47
  %scevgep36 = getelementptr i8, ptr %scevgep35, i64 8
  %.610.i = load double, ptr %scevgep36, align 8, !noalias !74
  %.612.i = insertelement <8 x double> poison, double %.610.i, i64 0
  %.613.i = shufflevector <8 x double> %.612.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.614.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.520.i, <8 x double> %.613.i, <8 x double> %_multiply_wide_v86_a10.2.1827.i)
  %.618.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.532.i, <8 x double> %.613.i, <8 x double> %_multiply_wide_v86_a11.2.1828.i)
  %.626.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.545.i, <8 x double> %.613.i, <8 x double> %_multiply_wide_v86_a12.2.1829.i)
  %.630.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.558.i, <8 x double> %.613.i, <8 x double> %_multiply_wide_v86_a13.2.1830.i)
  %scevgep31 = getelementptr i8, ptr %44, i64 %47
  %scevgep32 = getelementptr i8, ptr %scevgep31, i64 8
  %.648.i = load double, ptr %scevgep32, align 8, !noalias !74
  %.650.i = insertelement <8 x double> poison, double %.648.i, i64 0
  %.651.i = shufflevector <8 x double> %.650.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.652.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.520.i, <8 x double> %.651.i, <8 x double> %_multiply_wide_v86_a20.2.1831.i)
  %.656.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.532.i, <8 x double> %.651.i, <8 x double> %_multiply_wide_v86_a21.2.1832.i)
  %.664.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.545.i, <8 x double> %.651.i, <8 x double> %_multiply_wide_v86_a22.2.1833.i)
  %.668.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.558.i, <8 x double> %.651.i, <8 x double> %_multiply_wide_v86_a23.2.1834.i)
  %scevgep9 = getelementptr i8, ptr %45, i64 %47
  %scevgep20 = getelementptr i8, ptr %scevgep9, i64 8
  %.686.i = load double, ptr %scevgep20, align 8, !noalias !74
  %.688.i = insertelement <8 x double> poison, double %.686.i, i64 0
  %.689.i = shufflevector <8 x double> %.688.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.690.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.520.i, <8 x double> %.689.i, <8 x double> %_multiply_wide_v86_a30.2.1835.i)
  %.694.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.532.i, <8 x double> %.689.i, <8 x double> %_multiply_wide_v86_a31.2.1836.i)
  %.702.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.545.i, <8 x double> %.689.i, <8 x double> %_multiply_wide_v86_a32.2.1837.i)
  %.706.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.558.i, <8 x double> %.689.i, <8 x double> %_multiply_wide_v86_a33.2.1838.i)
  %scevgep21.i = getelementptr i8, ptr %lsr.iv20.i, i64 256
  %lsr.iv.next26 = add nsw i64 %lsr.iv25, 1
  %exitcond.not.i = icmp eq i64 %.1143, %lsr.iv.next26
  br i1 %exitcond.not.i, label %B280.i, label %B200.if.i

B354.else.i:                                      ; preds = %B280.i, %B662.endif.endif.else.endif.endif
  %position.3.0.lcssa.i = phi i64 [ 0, %B662.endif.endif.else.endif.endif ], [ %.reass, %B280.i ]
  br i1 %40, label %B662.endif.endif.endif.endif, label %B354.endif.endif.endif.i

B354.endif.endif.endif.i:                         ; preds = %B354.else.i
  %48 = getelementptr double, ptr %.1489, i64 %.152
  %49 = getelementptr i8, ptr %.1489, i64 %.332
  %50 = getelementptr i8, ptr %.1489, i64 %.idx814.i
  %51 = getelementptr double, ptr %.1663, i64 %.152
  %52 = getelementptr i8, ptr %.1663, i64 %.332
  %53 = getelementptr i8, ptr %.1663, i64 %.idx814.i
  br label %B356.if.i

B356.if.i:                                        ; preds = %B354.endif.endif.endif.i, %B6509.i
  %position.5.0901.i = phi i64 [ %position.3.0.lcssa.i, %B354.endif.endif.endif.i ], [ %position.4.1.lcssa.i, %B6509.i ]
  %.1128892900.i = phi i64 [ %.1106806.i, %B354.endif.endif.endif.i ], [ %.1138.i, %B6509.i ]
  %.1135893899.i = phi i64 [ %.1046.i, %B354.endif.endif.endif.i ], [ %.1142.i, %B6509.i ]
  %.1138.i = add nsw i64 %.1128892900.i, -1
  %.1142.i = add nuw nsw i64 %.1135893899.i, 8
  br i1 %42, label %B6509.i, label %B884.if.preheader.i

B884.if.preheader.i:                              ; preds = %B356.if.i
  %54 = shl i64 %position.5.0901.i, 3
  %scevgep.i = getelementptr i8, ptr %.1842, i64 %54
  br label %B884.if.i

B884.if.i:                                        ; preds = %B884.if.i, %B884.if.preheader.i
  %lsr.iv40 = phi i64 [ %lsr.iv.next41, %B884.if.i ], [ %.1144, %B884.if.preheader.i ]
  %lsr.iv37 = phi i64 [ %lsr.iv.next38, %B884.if.i ], [ 0, %B884.if.preheader.i ]
  %b3.2.1884.i = phi <8 x double> [ %.1396.i, %B884.if.i ], [ zeroinitializer, %B884.if.preheader.i ]
  %b2.2.1883.i = phi <8 x double> [ %.1376.i, %B884.if.i ], [ zeroinitializer, %B884.if.preheader.i ]
  %b1.2.1882.i = phi <8 x double> [ %.1356.i, %B884.if.i ], [ zeroinitializer, %B884.if.preheader.i ]
  %b0.2.1881.i = phi <8 x double> [ %.1337.i, %B884.if.i ], [ zeroinitializer, %B884.if.preheader.i ]
  %55 = shl i64 %lsr.iv37, 3
  %scevgep39 = getelementptr i8, ptr %scevgep.i, i64 %55
  %.1318.i = load <8 x double>, ptr %scevgep39, align 8, !noalias !74
  %scevgep47 = getelementptr i8, ptr %.1489, i64 %lsr.iv37
  %.1333.i = load double, ptr %scevgep47, align 8, !noalias !74
  %.1335.i = insertelement <8 x double> poison, double %.1333.i, i64 0
  %.1336.i = shufflevector <8 x double> %.1335.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1337.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1318.i, <8 x double> %.1336.i, <8 x double> %b0.2.1881.i)
  %scevgep44 = getelementptr i8, ptr %48, i64 %lsr.iv37
  %.1352.i = load double, ptr %scevgep44, align 8, !noalias !74
  %.1354.i = insertelement <8 x double> poison, double %.1352.i, i64 0
  %.1355.i = shufflevector <8 x double> %.1354.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1356.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1318.i, <8 x double> %.1355.i, <8 x double> %b1.2.1882.i)
  %scevgep43 = getelementptr i8, ptr %49, i64 %lsr.iv37
  %.1372.i = load double, ptr %scevgep43, align 8, !noalias !74
  %.1374.i = insertelement <8 x double> poison, double %.1372.i, i64 0
  %.1375.i = shufflevector <8 x double> %.1374.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1376.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1318.i, <8 x double> %.1375.i, <8 x double> %b2.2.1883.i)
  %scevgep42 = getelementptr i8, ptr %50, i64 %lsr.iv37
  %.1392.i = load double, ptr %scevgep42, align 8, !noalias !74
  %.1394.i = insertelement <8 x double> poison, double %.1392.i, i64 0
  %.1395.i = shufflevector <8 x double> %.1394.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1396.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1318.i, <8 x double> %.1395.i, <8 x double> %b3.2.1884.i)
  %lsr.iv.next38 = add i64 %lsr.iv37, 8
  %lsr.iv.next41 = add i64 %lsr.iv40, -1
  %exitcond909.not.i = icmp eq i64 %lsr.iv.next41, 0
  br i1 %exitcond909.not.i, label %B6509.loopexit.i, label %B884.if.i

B662.endif.endif.endif.endif:                     ; preds = %B6509.i, %B354.else.i
  %.1308 = icmp sgt i64 %.1307791, 1
  br i1 %.1308, label %B660.if, label %B816

B874.if:                                          ; preds = %B874.loopexit, %B874.if.lr.ph
  %lsr.iv47 = phi ptr [ %scevgep46, %B874.if.lr.ph ], [ %scevgep48, %B874.loopexit ]
  %.2026800806 = phi i64 [ 0, %B874.if.lr.ph ], [ %.2033, %B874.loopexit ]
  %.2033 = add nuw nsw i64 %.2026800806, 1
  br i1 %4, label %B972.if, label %B874.loopexit

B972.if:                                          ; preds = %B874.if, %B974.endif
  %lsr.iv48 = phi i64 [ %lsr.iv.next, %B974.endif ], [ %3, %B874.if ]
  %lsr.iv49 = phi ptr [ %scevgep50, %B974.endif ], [ %lsr.iv47, %B874.if ]
  %.2193 = load <8 x double>, ptr %lsr.iv49, align 8
  %.2223 = load i64, ptr %sunkaddr76, align 8
  %.11.i = bitcast <8 x double> %.2193 to <8 x i64>
  %56 = tail call <8 x double> @llvm.fabs.v8f64(<8 x double> %.2193)
  %.8.i.i = bitcast <8 x double> %56 to <8 x i64>
  %.43.i = icmp eq i64 %.2223, 1
  br i1 %.43.i, label %B98.i, label %B114.i

B98.i:                                            ; preds = %B972.if
  %.6.i.i = fadd contract <8 x double> %.2193, %56
  %.8.i3.i = fmul contract <8 x double> %.6.i.i, splat (double 5.000000e-01)
  br label %B974.endif

B114.i:                                           ; preds = %B972.if
  %.106.i = tail call <8 x double> @llvm.minnum.v8f64(<8 x double> %56, <8 x double> splat (double 3.500000e+02))
  %.111.i = icmp eq i64 %.2223, 0
  br i1 %.111.i, label %B168.i, label %B372.i

B168.i:                                           ; preds = %B114.i
  %.8.i1.i = fmul contract <8 x double> %.106.i, splat (double -2.000000e+00)
  %.147.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i1.i, <8 x double> splat (double 0x3FF71547652B82FE), <8 x double> splat (double 0x4338000000000000))
  %.8.i4.i = fadd contract <8 x double> %.147.i, splat (double 0xC338000000000000)
  %.176.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i4.i, <8 x double> splat (double 0xBFE62E42FEFA39EF), <8 x double> %.8.i1.i)
  %.179.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i4.i, <8 x double> splat (double 0xBC7ABC9E3B39803F), <8 x double> %.176.i)
  %.184.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.179.i, <8 x double> splat (double 0x3DE6124613A86D09), <8 x double> splat (double 0x3E21EED8EFF8D898))
  %.187.i10 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.179.i, <8 x double> %.184.i, <8 x double> splat (double 0x3E5AE64567F544E4))
  %.190.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.179.i, <8 x double> %.187.i10, <8 x double> splat (double 0x3E927E4FB7789F5C))
  %.193.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.179.i, <8 x double> %.190.i, <8 x double> splat (double 0x3EC71DE3A556C734))
  %.196.i11 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.179.i, <8 x double> %.193.i, <8 x double> splat (double 0x3EFA01A01A01A01A))
  %.199.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.179.i, <8 x double> %.196.i11, <8 x double> splat (double 0x3F2A01A01A01A01A))
  %.202.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.179.i, <8 x double> %.199.i, <8 x double> splat (double 0x3F56C16C16C16C17))
  %.205.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.179.i, <8 x double> %.202.i, <8 x double> splat (double 0x3F81111111111111))
  %.208.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.179.i, <8 x double> %.205.i, <8 x double> splat (double 0x3FA5555555555555))
  %.211.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.179.i, <8 x double> %.208.i, <8 x double> splat (double 0x3FC5555555555555))
  %.214.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.179.i, <8 x double> %.211.i, <8 x double> splat (double 5.000000e-01))
  %.6.i5.i = fmul contract <8 x double> %.179.i, %.179.i
  %.8.i6.i = fadd contract <8 x double> %.179.i, splat (double 1.000000e+00)
  %.263.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i5.i, <8 x double> %.214.i, <8 x double> %.8.i6.i)
  %.264.i = bitcast <8 x double> %.147.i to <8 x i64>
  %.8.i7.i = shl <8 x i64> %.264.i, splat (i64 52)
  %.8.i8.i = add <8 x i64> %.8.i7.i, splat (i64 4607182418800017408)
  %57 = bitcast <8 x i64> %.8.i8.i to <8 x double>
  %.6.i9.i = fmul contract <8 x double> %.263.i, %57
  %.6.i10.i = fsub contract <8 x double> splat (double 1.000000e+00), %.6.i9.i
  %.8.i11.i = fadd contract <8 x double> %.6.i9.i, splat (double 1.000000e+00)
  %.6.i12.i = fdiv contract <8 x double> %.6.i10.i, %.8.i11.i
  %58 = bitcast <8 x double> %.6.i12.i to <8 x i64>
  %59 = xor <8 x i64> %.8.i.i, %58
  %.6.i14.i = xor <8 x i64> %59, %.11.i
  %60 = bitcast <8 x i64> %.6.i14.i to <8 x double>
  br label %B974.endif

B372.i:                                           ; preds = %B114.i
  %.6.i2.i = fsub contract <8 x double> zeroinitializer, %.106.i
  %.508.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i2.i, <8 x double> splat (double 0x3FF71547652B82FE), <8 x double> splat (double 0x4338000000000000))
  %.8.i15.i = fadd contract <8 x double> %.508.i, splat (double 0xC338000000000000)
  %.537.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i15.i, <8 x double> splat (double 0xBFE62E42FEFA39EF), <8 x double> %.6.i2.i)
  %.540.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i15.i, <8 x double> splat (double 0xBC7ABC9E3B39803F), <8 x double> %.537.i)
  %.545.i8 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.540.i, <8 x double> splat (double 0x3DE6124613A86D09), <8 x double> splat (double 0x3E21EED8EFF8D898))
  %.548.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.540.i, <8 x double> %.545.i8, <8 x double> splat (double 0x3E5AE64567F544E4))
  %.551.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.540.i, <8 x double> %.548.i, <8 x double> splat (double 0x3E927E4FB7789F5C))
  %.554.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.540.i, <8 x double> %.551.i, <8 x double> splat (double 0x3EC71DE3A556C734))
  %.557.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.540.i, <8 x double> %.554.i, <8 x double> splat (double 0x3EFA01A01A01A01A))
  %.560.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.540.i, <8 x double> %.557.i, <8 x double> splat (double 0x3F2A01A01A01A01A))
  %.563.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.540.i, <8 x double> %.560.i, <8 x double> splat (double 0x3F56C16C16C16C17))
  %.566.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.540.i, <8 x double> %.563.i, <8 x double> splat (double 0x3F81111111111111))
  %.569.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.540.i, <8 x double> %.566.i, <8 x double> splat (double 0x3FA5555555555555))
  %.572.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.540.i, <8 x double> %.569.i, <8 x double> splat (double 0x3FC5555555555555))
  %.575.i9 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.540.i, <8 x double> %.572.i, <8 x double> splat (double 5.000000e-01))
  %.6.i16.i = fmul contract <8 x double> %.540.i, %.540.i
  %.8.i17.i = fadd contract <8 x double> %.540.i, splat (double 1.000000e+00)
  %.624.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i16.i, <8 x double> %.575.i9, <8 x double> %.8.i17.i)
  %.625.i = bitcast <8 x double> %.508.i to <8 x i64>
  %.8.i18.i = shl <8 x i64> %.625.i, splat (i64 52)
  %.8.i19.i = add <8 x i64> %.8.i18.i, splat (i64 4607182418800017408)
  %61 = bitcast <8 x i64> %.8.i19.i to <8 x double>
  %.6.i20.i = fmul contract <8 x double> %.624.i, %61
  %.8.i21.i = fadd contract <8 x double> %.6.i20.i, splat (double 1.000000e+00)
  %isneg.i = icmp slt <8 x i64> %.11.i, zeroinitializer
  %.6.i31.v.v.i = select <8 x i1> %isneg.i, <8 x double> %.6.i20.i, <8 x double> splat (double 1.000000e+00)
  %.6.i31.v.i = fdiv contract <8 x double> %.6.i31.v.v.i, %.8.i21.i
  br label %B974.endif

B974.endif:                                       ; preds = %B372.i, %B168.i, %B98.i
  %.2224.sroa.0.5 = phi <8 x double> [ %.8.i3.i, %B98.i ], [ %60, %B168.i ], [ %.6.i31.v.i, %B372.i ]
  store <8 x double> %.2224.sroa.0.5, ptr %lsr.iv49, align 8
  %scevgep50 = getelementptr i8, ptr %lsr.iv49, i64 64
  %lsr.iv.next = add nsw i64 %lsr.iv48, -1
  %.2145 = icmp sgt i64 %lsr.iv48, 8
  br i1 %.2145, label %B972.if, label %B874.loopexit

B1144.if:                                         ; preds = %B1144.loopexit, %B1144.if.lr.ph
  %lsr.iv22 = phi ptr [ %arg.out.4, %B1144.if.lr.ph ], [ %scevgep23, %B1144.loopexit ]
  %lsr.iv17 = phi ptr [ %scevgep, %B1144.if.lr.ph ], [ %scevgep18, %B1144.loopexit ]
  %.2426830836 = phi i64 [ 0, %B1144.if.lr.ph ], [ %.2433, %B1144.loopexit ]
  %.2433 = add nuw nsw i64 %.2426830836, 1
  br i1 %11, label %B1144.loopexit, label %B1192.if

B1192.if:                                         ; preds = %B1144.if, %B1192.if
  %lsr.iv2 = phi i64 [ %lsr.iv.next3, %B1192.if ], [ %10, %B1144.if ]
  %lsr.iv19 = phi i64 [ %lsr.iv.next20, %B1192.if ], [ 0, %B1144.if ]
  %scevgep24 = getelementptr i8, ptr %lsr.iv22, i64 %lsr.iv19
  %.2592 = load <8 x double>, ptr %scevgep24, align 8
  %scevgep21 = getelementptr i8, ptr %lsr.iv17, i64 %lsr.iv19
  %.2607 = load <8 x double>, ptr %scevgep21, align 8
  %.6.i = fadd contract <8 x double> %.2592, %.2607
  store <8 x double> %.6.i, ptr %scevgep24, align 8
  %lsr.iv.next20 = add i64 %lsr.iv19, 64
  %lsr.iv.next3 = add nsw i64 %lsr.iv2, -1
  %.2541 = icmp sgt i64 %lsr.iv2, 8
  br i1 %.2541, label %B1192.if, label %B1144.loopexit
}

; Function Attrs: mustprogress nocallback nocreateundeforpoison nofree nosync nounwind speculatable willreturn memory(none)
declare <8 x double> @llvm.fabs.v8f64(<8 x double>) #3

; Function Attrs: mustprogress nocallback nocreateundeforpoison nofree nosync nounwind speculatable willreturn memory(none)
declare <8 x double> @llvm.minnum.v8f64(<8 x double>, <8 x double>) #3

; Function Attrs: nofree noinline norecurse nosync nounwind memory(readwrite, inaccessiblemem: none, target_mem0: none, target_mem1: none)
define internal fastcc noundef range(i32 0, 2) i32 @inner_10(ptr noalias nonnull writeonly captures(none) %retptr, ptr noalias nonnull writeonly captures(none) %excinfo, ptr readonly captures(none) %arg.row.4, ptr readonly captures(none) %arg.linear.4, ptr readonly captures(none) %arg.contents.4, ptr readonly captures(none) %arg.weights.4, i64 %arg.alignment, ptr readonly captures(none) %arg.cubics.0.4, ptr readonly captures(none) %arg.cubics.1.4, i64 range(i64 8, 1) %arg.stride, ptr captures(none) initializes((0, 64)) %arg.series.4, ptr initializes((0, 384)) %arg.work.4, ptr writeonly captures(none) %arg.polynomials_a.4, ptr writeonly captures(none) %arg.polynomials_p.4, i64 %arg.first, i64 %arg.last) unnamed_addr #4 {
entry:
  %.1175 = alloca double, align 8
  store double 0.000000e+00, ptr %.1175, align 8
  %excinfo.11 = alloca ptr, align 8
  store ptr null, ptr %excinfo.11, align 8
  %.1386 = alloca ptr, align 8
  store ptr null, ptr %.1386, align 8
  %.132 = sub i64 %arg.last, %arg.first
  %.161 = getelementptr i8, ptr %arg.contents.4, i64 144
  %.162 = load i64, ptr %.161, align 8
  %.163 = sub i64 0, %.162
  %.171.1 = and i64 %.163, -8
  %.236 = shl nsw i64 %arg.first, 3
  %.237 = shl nsw i64 %.132, 3
  %.266 = getelementptr i8, ptr %arg.contents.4, i64 152
  %.267 = load i64, ptr %.266, align 8
  %.277 = getelementptr double, ptr %arg.weights.4, i64 %.267
  %.357 = getelementptr i8, ptr %arg.contents.4, i64 160
  %.358 = load i64, ptr %.357, align 8
  %.359 = add nsw i64 %.358, %arg.first
  %0 = lshr i64 %.359, 47
  %.396 = and i64 %0, 65536
  %.397 = add i64 %.396, %.359
  %.400 = icmp slt i64 %.397, 0
  br i1 %.400, label %B0.endif.endif.else.if, label %B0.endif.endif.else.endif, !prof !1

common.ret:                                       ; preds = %B0.endif.endif.endif.endi...endif.5.endif.endif, %B0.endif.endif.endif.endi...endif.1.endif.endif.if
  %common.ret.op = phi i32 [ 1, %B0.endif.endif.endif.endi...endif.1.endif.endif.if ], [ 0, %B0.endif.endif.endif.endi...endif.5.endif.endif ]
  ret i32 %common.ret.op

B0.endif.endif.else.if:                           ; preds = %entry
  br label %B0.endif.endif.else.endif

B0.endif.endif.else.endif:                        ; preds = %B0.endif.endif.else.if, %entry
  %.385.sroa.0.1 = phi i64 [ 0, %B0.endif.endif.else.if ], [ %.397, %entry ]
  %.405.not = icmp slt i64 %.397, 65536
  br i1 %.405.not, label %B0.endif.endif.else.endif.endif, label %B0.endif.endif.else.endif.if, !prof !5

B0.endif.endif.else.endif.if:                     ; preds = %B0.endif.endif.else.endif
  br label %B0.endif.endif.else.endif.endif

B0.endif.endif.else.endif.endif:                  ; preds = %B0.endif.endif.else.endif.if, %B0.endif.endif.else.endif
  %.385.sroa.0.3 = phi i64 [ 65536, %B0.endif.endif.else.endif.if ], [ %.385.sroa.0.1, %B0.endif.endif.else.endif ]
  %.498 = getelementptr i64, ptr %arg.contents.4, i64 %.385.sroa.0.3
  %.543.idx = mul i64 %.171.1, -24
  %.543 = getelementptr i8, ptr %.277, i64 %.543.idx
  %1 = getelementptr i8, ptr %.543, i64 1024
  %.612 = getelementptr double, ptr %1, i64 %.236
  %.735.idx = shl i64 %.162, 7
  %.735 = getelementptr inbounds i8, ptr %.612, i64 %.735.idx
  %.866.idx = mul i64 %.171.1, -64
  %.866 = getelementptr i8, ptr %arg.work.4, i64 %.866.idx
  %.951 = getelementptr i8, ptr %arg.contents.4, i64 120
  %.952 = load i64, ptr %.951, align 8
  %.962 = getelementptr inbounds double, ptr %arg.weights.4, i64 %.952
  %.1027.idx = shl nsw i64 %arg.stride, 5
  %.1027 = getelementptr inbounds i8, ptr %arg.linear.4, i64 %.1027.idx
  %.1106 = getelementptr i8, ptr %arg.contents.4, i64 128
  %.1107 = load i64, ptr %.1106, align 8
  %.1123 = getelementptr inbounds double, ptr %arg.weights.4, i64 %.1107
  store double 0.000000e+00, ptr %.1175, align 8
  %.1189 = call fastcc i32 @inner_11(ptr nonnull %.1175, ptr nonnull %excinfo.11, ptr %arg.row.4, double 1.000000e+00, ptr %.1123, ptr %.1027, i64 %arg.alignment, ptr %arg.work.4, ptr %arg.series.4)
  %.1199 = load double, ptr %.1175, align 8
  %cond = icmp eq i32 %.1189, 0
  br i1 %cond, label %B0.endif.endif.endif.endi...endif.1.endif.endif.endif, label %B0.endif.endif.endif.endi...endif.1.endif.endif.if, !prof !0

B0.endif.endif.endif.endi...endif.1.endif.endif.if: ; preds = %B0.endif.endif.else.endif.endif
  %.1190 = load ptr, ptr %excinfo.11, align 8
  store ptr %.1190, ptr %excinfo, align 8
  br label %common.ret

B0.endif.endif.endif.endi...endif.1.endif.endif.endif: ; preds = %B0.endif.endif.else.endif.endif
  %.31.i = icmp sgt i64 %.132, 0
  br i1 %.31.i, label %B24.i, label %B0.endif.endif.endif.endi...endif.2.endif.endif

B24.i:                                            ; preds = %B0.endif.endif.endif.endi...endif.1.endif.endif.endif, %B24.i
  %high.2.0.i = phi i64 [ %high.3.1.i, %B24.i ], [ %.237, %B0.endif.endif.endif.endi...endif.1.endif.endif.endif ]
  %low.2.0.i = phi i64 [ %low.3.1.i, %B24.i ], [ 0, %B0.endif.endif.endif.endi...endif.1.endif.endif.endif ]
  %.40.i = add nuw nsw i64 %low.2.0.i, %high.2.0.i
  %.41.i = lshr i64 %.40.i, 1
  %.53.i = getelementptr inbounds nuw double, ptr %.612, i64 %.41.i
  %.54.i = load double, ptr %.53.i, align 8, !noalias !77
  %.56.i = fcmp contract olt double %.54.i, 1.000000e-02
  %.67.i = add nuw nsw i64 %.41.i, 1
  %high.3.1.i = select i1 %.56.i, i64 %high.2.0.i, i64 %.41.i
  %low.3.1.i = select i1 %.56.i, i64 %.67.i, i64 %low.2.0.i
  %.98.i = icmp slt i64 %low.3.1.i, %high.3.1.i
  br i1 %.98.i, label %B24.i, label %B24.i48

B24.i48:                                          ; preds = %B24.i, %B24.i48
  %high.2.0.i49 = phi i64 [ %high.3.1.i57, %B24.i48 ], [ %.237, %B24.i ]
  %low.2.0.i50 = phi i64 [ %low.3.1.i58, %B24.i48 ], [ 0, %B24.i ]
  %.40.i51 = add nuw nsw i64 %low.2.0.i50, %high.2.0.i49
  %.41.i52 = lshr i64 %.40.i51, 1
  %.53.i53 = getelementptr inbounds nuw double, ptr %.612, i64 %.41.i52
  %.54.i54 = load double, ptr %.53.i53, align 8, !noalias !80
  %.56.i55 = fcmp contract olt double %.54.i54, 2.000000e-02
  %.67.i56 = add nuw nsw i64 %.41.i52, 1
  %high.3.1.i57 = select i1 %.56.i55, i64 %high.2.0.i49, i64 %.41.i52
  %low.3.1.i58 = select i1 %.56.i55, i64 %.67.i56, i64 %low.2.0.i50
  %.98.i59 = icmp slt i64 %low.3.1.i58, %high.3.1.i57
  br i1 %.98.i59, label %B24.i48, label %B34.if.lr.ph.i

B34.if.lr.ph.i:                                   ; preds = %B24.i48
  %2 = getelementptr double, ptr %arg.cubics.0.4, i64 %arg.stride
  %.idx.i = shl i64 %arg.stride, 4
  %3 = getelementptr i8, ptr %arg.cubics.0.4, i64 %.idx.i
  %.idx161.i = mul i64 %arg.stride, 24
  %4 = getelementptr i8, ptr %arg.cubics.0.4, i64 %.idx161.i
  %.673.idx1 = add i64 %.162, %arg.first
  %5 = shl i64 %.673.idx1, 6
  %6 = shl i64 %.267, 3
  %7 = lshr i64 %.163, 3
  %.neg2 = mul i64 %7, -192
  %8 = getelementptr i8, ptr %arg.weights.4, i64 %.neg2
  %9 = getelementptr i8, ptr %8, i64 %5
  %10 = getelementptr i8, ptr %9, i64 %6
  %scevgep362 = getelementptr i8, ptr %10, i64 1024
  %11 = sub i64 %arg.first, %arg.last
  br label %B34.if.i

B34.if.i:                                         ; preds = %B34.if.i, %B34.if.lr.ph.i
  %lsr.iv = phi i64 [ %lsr.iv.next, %B34.if.i ], [ %11, %B34.if.lr.ph.i ]
  %lsr.iv.i = phi i64 [ %lsr.iv.next.i, %B34.if.i ], [ 0, %B34.if.lr.ph.i ]
  %scevgep3.i = getelementptr i8, ptr %.498, i64 %lsr.iv.i
  %.205.i = load i64, ptr %scevgep3.i, align 8, !noalias !83
  %12 = shl i64 %lsr.iv.i, 3
  %scevgep363 = getelementptr i8, ptr %scevgep362, i64 %12
  %.216.i = load <8 x double>, ptr %scevgep363, align 8, !noalias !83
  %.224.i = getelementptr inbounds double, ptr %.962, i64 %.205.i
  %.225.i = load double, ptr %.224.i, align 8, !noalias !83
  %.6.i.i = insertelement <8 x double> poison, double %.225.i, i64 0
  %.7.i.i = shufflevector <8 x double> %.6.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.8.i.i = fsub contract <8 x double> %.216.i, %.7.i.i
  %.257.i = getelementptr inbounds double, ptr %arg.cubics.0.4, i64 %.205.i
  %.258.i = load double, ptr %.257.i, align 8, !noalias !83
  %.268.i = getelementptr double, ptr %2, i64 %.205.i
  %.269.i = load double, ptr %.268.i, align 8, !noalias !83
  %.280.i = getelementptr double, ptr %3, i64 %.205.i
  %.281.i = load double, ptr %.280.i, align 8, !noalias !83
  %.292.i = getelementptr double, ptr %4, i64 %.205.i
  %.293.i = load double, ptr %.292.i, align 8, !noalias !83
  %.295.i = insertelement <8 x double> poison, double %.293.i, i64 0
  %.296.i = shufflevector <8 x double> %.295.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.297.i = insertelement <8 x double> poison, double %.281.i, i64 0
  %.298.i = shufflevector <8 x double> %.297.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.299.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i.i, <8 x double> %.296.i, <8 x double> %.298.i)
  %.300.i = insertelement <8 x double> poison, double %.269.i, i64 0
  %.301.i = shufflevector <8 x double> %.300.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.302.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i.i, <8 x double> %.299.i, <8 x double> %.301.i)
  %.303.i = insertelement <8 x double> poison, double %.258.i, i64 0
  %.304.i = shufflevector <8 x double> %.303.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.305.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i.i, <8 x double> %.302.i, <8 x double> %.304.i)
  %scevgep15 = getelementptr i8, ptr %arg.work.4, i64 %12
  store <8 x double> %.305.i, ptr %scevgep15, align 8, !noalias !83
  %lsr.iv.next.i = add nuw i64 %lsr.iv.i, 8
  %ov21 = icmp eq i64 %lsr.iv, -1
  %lsr.iv.next = add i64 %lsr.iv, 1
  br i1 %ov21, label %B0.endif.endif.endif.endi...endif.2.endif.endif, label %B34.if.i

B0.endif.endif.endif.endi...endif.2.endif.endif:  ; preds = %B34.if.i, %B0.endif.endif.endif.endi...endif.1.endif.endif.endif
  %low.4.1.i4714 = phi i64 [ 0, %B0.endif.endif.endif.endi...endif.1.endif.endif.endif ], [ %low.3.1.i58, %B34.if.i ]
  %low.4.1.i813 = phi i64 [ 0, %B0.endif.endif.endif.endi...endif.1.endif.endif.endif ], [ %low.3.1.i, %B34.if.i ]
  %.1335.idx = shl nsw i64 %.162, 8
  %.1335 = getelementptr inbounds i8, ptr %.612, i64 %.1335.idx
  store ptr null, ptr %.1386, align 8
  call fastcc void @inner_12(ptr nonnull %.1386, ptr %.612, ptr %.735, ptr %.1335, i64 %low.4.1.i813, i64 %low.4.1.i4714, i64 %.237, double 1.000000e+00, ptr %arg.series.4, double %.1199, ptr %arg.work.4, ptr %.866)
  %13 = icmp slt i64 %.132, 1
  %.1508 = getelementptr inbounds double, ptr %arg.polynomials_a.4, i64 %.236
  br i1 %13, label %_ZN17bnserve_surrogate6kernel7_points15spline_at_nodesB4v236B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE.exit119, label %B64.if.i.preheader

B64.if.i.preheader:                               ; preds = %B0.endif.endif.endif.endi...endif.2.endif.endif
  %14 = shl i64 %.267, 3
  %15 = lshr i64 %.163, 3
  %.neg3 = mul i64 %15, -192
  %16 = getelementptr i8, ptr %arg.weights.4, i64 %.neg3
  %17 = getelementptr i8, ptr %16, i64 %14
  %scevgep353 = getelementptr i8, ptr %17, i64 576
  br label %B64.if.i

B424.i:                                           ; preds = %B172.if.i
  %.138.i = add nsw i64 %.128167175.i, -1
  %.142.i = add i64 %.135168174.i, 8
  %.6.i.i78 = fadd contract <8 x double> %.322.i, %.352.i
  %.398.i = getelementptr inbounds double, ptr %.1508, i64 %.135168174.i
  store <8 x double> %.6.i.i78, ptr %.398.i, align 8, !noalias !86
  %scevgep.i79 = getelementptr i8, ptr %lsr.iv2.i, i64 64
  %.129.i = icmp sgt i64 %.128167175.i, 1
  br i1 %.129.i, label %B64.if.i, label %B34.if.lr.ph.i81

B64.if.i:                                         ; preds = %B424.i, %B64.if.i.preheader
  %lsr.iv2.i = phi ptr [ %scevgep.i79, %B424.i ], [ %.866, %B64.if.i.preheader ]
  %.128167175.i = phi i64 [ %.138.i, %B424.i ], [ %.132, %B64.if.i.preheader ]
  %.135168174.i = phi i64 [ %.142.i, %B424.i ], [ 0, %B64.if.i.preheader ]
  br label %B172.if.i

B172.if.i:                                        ; preds = %B172.if.i, %B64.if.i
  %lsr.iv10 = phi i64 [ %lsr.iv.next11, %B172.if.i ], [ 10, %B64.if.i ]
  %lsr.iv349 = phi i64 [ %lsr.iv.next350, %B172.if.i ], [ 0, %B64.if.i ]
  %even.2.1163.i = phi <8 x double> [ %.322.i, %B172.if.i ], [ zeroinitializer, %B64.if.i ]
  %odd.2.1162.i = phi <8 x double> [ %.352.i, %B172.if.i ], [ zeroinitializer, %B64.if.i ]
  %18 = shl nuw nsw i64 %lsr.iv349, 3
  %scevgep14 = getelementptr i8, ptr %scevgep353, i64 %18
  %scevgep13 = getelementptr i8, ptr %scevgep14, i64 -64
  %.307.i = load <8 x double>, ptr %scevgep13, align 8, !noalias !86
  %scevgep351 = getelementptr i8, ptr %lsr.iv2.i, i64 %lsr.iv349
  %scevgep352 = getelementptr i8, ptr %scevgep351, i64 8
  %.318.i = load double, ptr %scevgep351, align 8, !noalias !86
  %.320.i = insertelement <8 x double> poison, double %.318.i, i64 0
  %.321.i = shufflevector <8 x double> %.320.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.322.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.307.i, <8 x double> %.321.i, <8 x double> %even.2.1163.i)
  %.336.i = load <8 x double>, ptr %scevgep14, align 8, !noalias !86
  %.348.i = load double, ptr %scevgep352, align 8, !noalias !86
  %.350.i = insertelement <8 x double> poison, double %.348.i, i64 0
  %.351.i = shufflevector <8 x double> %.350.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.352.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.336.i, <8 x double> %.351.i, <8 x double> %odd.2.1162.i)
  %lsr.iv.next350 = add nuw nsw i64 %lsr.iv349, 16
  %lsr.iv.next11 = add nsw i64 %lsr.iv10, -1
  %.259.i = icmp samesign ugt i64 %lsr.iv10, 7
  br i1 %.259.i, label %B172.if.i, label %B424.i

B34.if.lr.ph.i81:                                 ; preds = %B424.i
  %19 = getelementptr double, ptr %arg.cubics.1.4, i64 %arg.stride
  %.idx.i82 = shl i64 %arg.stride, 4
  %20 = getelementptr i8, ptr %arg.cubics.1.4, i64 %.idx.i82
  %.idx161.i83 = mul i64 %arg.stride, 24
  %21 = getelementptr i8, ptr %arg.cubics.1.4, i64 %.idx161.i83
  %.673.idx4 = add i64 %.162, %arg.first
  %22 = shl i64 %.673.idx4, 6
  %23 = getelementptr i8, ptr %16, i64 %22
  %24 = getelementptr i8, ptr %23, i64 %14
  %scevgep347 = getelementptr i8, ptr %24, i64 1024
  %25 = sub i64 %arg.first, %arg.last
  br label %B34.if.i84

B34.if.i84:                                       ; preds = %B34.if.i84, %B34.if.lr.ph.i81
  %lsr.iv7 = phi i64 [ %lsr.iv.next8, %B34.if.i84 ], [ %25, %B34.if.lr.ph.i81 ]
  %lsr.iv.i86 = phi i64 [ %lsr.iv.next.i116, %B34.if.i84 ], [ 0, %B34.if.lr.ph.i81 ]
  %scevgep3.i87 = getelementptr i8, ptr %.498, i64 %lsr.iv.i86
  %.205.i88 = load i64, ptr %scevgep3.i87, align 8, !noalias !89
  %26 = shl i64 %lsr.iv.i86, 3
  %scevgep348 = getelementptr i8, ptr %scevgep347, i64 %26
  %.216.i90 = load <8 x double>, ptr %scevgep348, align 8, !noalias !89
  %.224.i91 = getelementptr inbounds double, ptr %.962, i64 %.205.i88
  %.225.i92 = load double, ptr %.224.i91, align 8, !noalias !89
  %.6.i.i93 = insertelement <8 x double> poison, double %.225.i92, i64 0
  %.7.i.i94 = shufflevector <8 x double> %.6.i.i93, <8 x double> poison, <8 x i32> zeroinitializer
  %.8.i.i95 = fsub contract <8 x double> %.216.i90, %.7.i.i94
  %.257.i96 = getelementptr inbounds double, ptr %arg.cubics.1.4, i64 %.205.i88
  %.258.i97 = load double, ptr %.257.i96, align 8, !noalias !89
  %.268.i98 = getelementptr double, ptr %19, i64 %.205.i88
  %.269.i99 = load double, ptr %.268.i98, align 8, !noalias !89
  %.280.i100 = getelementptr double, ptr %20, i64 %.205.i88
  %.281.i101 = load double, ptr %.280.i100, align 8, !noalias !89
  %.292.i102 = getelementptr double, ptr %21, i64 %.205.i88
  %.293.i103 = load double, ptr %.292.i102, align 8, !noalias !89
  %.295.i104 = insertelement <8 x double> poison, double %.293.i103, i64 0
  %.296.i105 = shufflevector <8 x double> %.295.i104, <8 x double> poison, <8 x i32> zeroinitializer
  %.297.i106 = insertelement <8 x double> poison, double %.281.i101, i64 0
  %.298.i107 = shufflevector <8 x double> %.297.i106, <8 x double> poison, <8 x i32> zeroinitializer
  %.299.i108 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i.i95, <8 x double> %.296.i105, <8 x double> %.298.i107)
  %.300.i109 = insertelement <8 x double> poison, double %.269.i99, i64 0
  %.301.i110 = shufflevector <8 x double> %.300.i109, <8 x double> poison, <8 x i32> zeroinitializer
  %.302.i111 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i.i95, <8 x double> %.299.i108, <8 x double> %.301.i110)
  %.303.i112 = insertelement <8 x double> poison, double %.258.i97, i64 0
  %.304.i113 = shufflevector <8 x double> %.303.i112, <8 x double> poison, <8 x i32> zeroinitializer
  %.305.i114 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i.i95, <8 x double> %.302.i111, <8 x double> %.304.i113)
  %scevgep9 = getelementptr i8, ptr %arg.work.4, i64 %26
  store <8 x double> %.305.i114, ptr %scevgep9, align 8, !noalias !89
  %lsr.iv.next.i116 = add nuw i64 %lsr.iv.i86, 8
  %ov = icmp eq i64 %lsr.iv7, -1
  %lsr.iv.next8 = add i64 %lsr.iv7, 1
  br i1 %ov, label %_ZN17bnserve_surrogate6kernel7_points15spline_at_nodesB4v236B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE.exit119, label %B34.if.i84

_ZN17bnserve_surrogate6kernel7_points15spline_at_nodesB4v236B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE.exit119: ; preds = %B34.if.i84, %B0.endif.endif.endif.endi...endif.2.endif.endif
  %.1167.i = and i64 %.132, 2305843009213693951
  %.1189570.not574.i = icmp eq i64 %.1167.i, 0
  %.1189570.not.i = or i1 %13, %.1189570.not574.i
  br i1 %.1189570.not.i, label %B0.endif.endif.endif.endi...endif.5, label %B484.if.lr.ph.i

B484.if.lr.ph.i:                                  ; preds = %_ZN17bnserve_surrogate6kernel7_points15spline_at_nodesB4v236B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE.exit119
  %.1794.idx = mul i64 %.162, 192
  %.1725 = getelementptr inbounds nuw i8, ptr %arg.series.4, i64 192
  %.1661 = getelementptr inbounds nuw i8, ptr %arg.series.4, i64 64
  %.1012.i = getelementptr i8, ptr %arg.series.4, i64 264
  %.1013.i = load double, ptr %.1012.i, align 8, !noalias !92
  %.983.i = getelementptr i8, ptr %arg.series.4, i64 256
  %.984.i = load double, ptr %.983.i, align 8, !noalias !92
  %.954.i = getelementptr i8, ptr %arg.series.4, i64 248
  %.955.i = load double, ptr %.954.i, align 8, !noalias !92
  %.925.i = getelementptr i8, ptr %arg.series.4, i64 240
  %.926.i = load double, ptr %.925.i, align 8, !noalias !92
  %.896.i = getelementptr i8, ptr %arg.series.4, i64 232
  %.897.i = load double, ptr %.896.i, align 8, !noalias !92
  %.867.i = getelementptr i8, ptr %arg.series.4, i64 224
  %.868.i = load double, ptr %.867.i, align 8, !noalias !92
  %.838.i = getelementptr i8, ptr %arg.series.4, i64 216
  %.839.i = load double, ptr %.838.i, align 8, !noalias !92
  %.809.i = getelementptr i8, ptr %arg.series.4, i64 208
  %.810.i = load double, ptr %.809.i, align 8, !noalias !92
  %.780.i = getelementptr i8, ptr %arg.series.4, i64 200
  %.781.i = load double, ptr %.780.i, align 8, !noalias !92
  %.752.i = load double, ptr %.1725, align 8, !noalias !92
  %.647.i = getelementptr i8, ptr %arg.series.4, i64 184
  %.648.i = load double, ptr %.647.i, align 8, !noalias !92
  %.618.i = getelementptr i8, ptr %arg.series.4, i64 176
  %.619.i = load double, ptr %.618.i, align 8, !noalias !92
  %.589.i = getelementptr i8, ptr %arg.series.4, i64 168
  %.590.i = load double, ptr %.589.i, align 8, !noalias !92
  %.560.i = getelementptr i8, ptr %arg.series.4, i64 160
  %.561.i = load double, ptr %.560.i, align 8, !noalias !92
  %.531.i = getelementptr i8, ptr %arg.series.4, i64 152
  %.532.i = load double, ptr %.531.i, align 8, !noalias !92
  %.502.i = getelementptr i8, ptr %arg.series.4, i64 144
  %.503.i = load double, ptr %.502.i, align 8, !noalias !92
  %.473.i = getelementptr i8, ptr %arg.series.4, i64 136
  %.474.i = load double, ptr %.473.i, align 8, !noalias !92
  %.444.i = getelementptr i8, ptr %arg.series.4, i64 128
  %.445.i = load double, ptr %.444.i, align 8, !noalias !92
  %.343.i = getelementptr i8, ptr %arg.series.4, i64 120
  %.344.i = load double, ptr %.343.i, align 8, !noalias !92
  %.314.i = getelementptr i8, ptr %arg.series.4, i64 112
  %.315.i = load double, ptr %.314.i, align 8, !noalias !92
  %.285.i = getelementptr i8, ptr %arg.series.4, i64 104
  %.286.i = load double, ptr %.285.i, align 8, !noalias !92
  %.256.i = getelementptr i8, ptr %arg.series.4, i64 96
  %.257.i135 = load double, ptr %.256.i, align 8, !noalias !92
  %.227.i = getelementptr i8, ptr %arg.series.4, i64 88
  %.228.i = load double, ptr %.227.i, align 8, !noalias !92
  %.198.i = getelementptr i8, ptr %arg.series.4, i64 80
  %.199.i = load double, ptr %.198.i, align 8, !noalias !92
  %.169.i = getelementptr i8, ptr %arg.series.4, i64 72
  %.170.i = load double, ptr %.169.i, align 8, !noalias !92
  %.141.i = load double, ptr %.1661, align 8, !noalias !92
  %.1282.i = insertelement <8 x double> poison, double %.619.i, i64 0
  %.1283.i = shufflevector <8 x double> %.1282.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1285.i = insertelement <8 x double> poison, double %.561.i, i64 0
  %.1286.i = shufflevector <8 x double> %.1285.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1289.i = insertelement <8 x double> poison, double %.503.i, i64 0
  %.1290.i = shufflevector <8 x double> %.1289.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1293.i = insertelement <8 x double> poison, double %.445.i, i64 0
  %.1294.i = shufflevector <8 x double> %.1293.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1297.i = insertelement <8 x double> poison, double %.648.i, i64 0
  %.1298.i = shufflevector <8 x double> %.1297.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1300.i = insertelement <8 x double> poison, double %.590.i, i64 0
  %.1301.i = shufflevector <8 x double> %.1300.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1304.i = insertelement <8 x double> poison, double %.532.i, i64 0
  %.1305.i = shufflevector <8 x double> %.1304.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1308.i = insertelement <8 x double> poison, double %.474.i, i64 0
  %.1309.i = shufflevector <8 x double> %.1308.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1312.i = insertelement <8 x double> poison, double %.315.i, i64 0
  %.1313.i = shufflevector <8 x double> %.1312.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1315.i = insertelement <8 x double> poison, double %.257.i135, i64 0
  %.1316.i = shufflevector <8 x double> %.1315.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1319.i = insertelement <8 x double> poison, double %.199.i, i64 0
  %.1320.i = shufflevector <8 x double> %.1319.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1323.i = insertelement <8 x double> poison, double %.141.i, i64 0
  %.1324.i = shufflevector <8 x double> %.1323.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1327.i = insertelement <8 x double> poison, double %.344.i, i64 0
  %.1328.i = shufflevector <8 x double> %.1327.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1330.i = insertelement <8 x double> poison, double %.286.i, i64 0
  %.1331.i = shufflevector <8 x double> %.1330.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1334.i = insertelement <8 x double> poison, double %.228.i, i64 0
  %.1335.i = shufflevector <8 x double> %.1334.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1338.i = insertelement <8 x double> poison, double %.170.i, i64 0
  %.1339.i = shufflevector <8 x double> %.1338.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1342.i = insertelement <8 x double> poison, double %.926.i, i64 0
  %.1343.i = shufflevector <8 x double> %.1342.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1345.i = insertelement <8 x double> poison, double %.868.i, i64 0
  %.1346.i = shufflevector <8 x double> %.1345.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1349.i = insertelement <8 x double> poison, double %.810.i, i64 0
  %.1350.i = shufflevector <8 x double> %.1349.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1353.i = insertelement <8 x double> poison, double %.752.i, i64 0
  %.1354.i = shufflevector <8 x double> %.1353.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1357.i = insertelement <8 x double> poison, double %.897.i, i64 0
  %.1358.i = shufflevector <8 x double> %.1357.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1360.i = insertelement <8 x double> poison, double %.839.i, i64 0
  %.1361.i = shufflevector <8 x double> %.1360.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1364.i = insertelement <8 x double> poison, double %.781.i, i64 0
  %.1365.i = shufflevector <8 x double> %.1364.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1428.i = insertelement <8 x double> poison, double %.955.i, i64 0
  %.1429.i = shufflevector <8 x double> %.1428.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1446.i = insertelement <8 x double> poison, double %.1013.i, i64 0
  %.1447.i = shufflevector <8 x double> %.1446.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1448.i = insertelement <8 x double> poison, double %.984.i, i64 0
  %.1449.i = shufflevector <8 x double> %.1448.i, <8 x double> poison, <8 x i32> zeroinitializer
  %27 = shl i64 %arg.first, 6
  %28 = shl i64 %.267, 3
  %29 = lshr i64 %.163, 3
  %.neg17 = mul i64 %29, -192
  %30 = getelementptr i8, ptr %arg.weights.4, i64 %28
  %31 = getelementptr i8, ptr %30, i64 1024
  %32 = getelementptr i8, ptr %31, i64 %27
  %33 = getelementptr i8, ptr %32, i64 %.1794.idx
  %scevgep334 = getelementptr i8, ptr %33, i64 %.neg17
  %.673.idx6 = add i64 %.162, %arg.first
  %34 = shl i64 %.673.idx6, 6
  %35 = getelementptr i8, ptr %31, i64 %34
  %scevgep336 = getelementptr i8, ptr %35, i64 %.neg17
  %scevgep338 = getelementptr i8, ptr %32, i64 %.neg17
  %36 = getelementptr i8, ptr %arg.weights.4, i64 %27
  %37 = getelementptr i8, ptr %36, i64 1024
  %38 = getelementptr i8, ptr %37, i64 %.735.idx
  %39 = getelementptr i8, ptr %38, i64 %28
  %scevgep340 = getelementptr i8, ptr %39, i64 %.neg17
  %40 = add nuw nsw i64 %.1167.i, 6
  br label %B484.if.i

B484.if.i:                                        ; preds = %B484.if.i, %B484.if.lr.ph.i
  %lsr.iv5 = phi i64 [ %lsr.iv.next6, %B484.if.i ], [ %40, %B484.if.lr.ph.i ]
  %lsr.iv20.i = phi i64 [ %lsr.iv.next21.i, %B484.if.i ], [ 0, %B484.if.lr.ph.i ]
  %scevgep341 = getelementptr i8, ptr %scevgep340, i64 %lsr.iv20.i
  %.1236.i = load <8 x double>, ptr %scevgep341, align 8, !noalias !92
  %scevgep339 = getelementptr i8, ptr %scevgep338, i64 %lsr.iv20.i
  %.1246.i = load <8 x double>, ptr %scevgep339, align 8, !noalias !92
  %scevgep337 = getelementptr i8, ptr %scevgep336, i64 %lsr.iv20.i
  %.1256.i = load <8 x double>, ptr %scevgep337, align 8, !noalias !92
  %.6.i.i137 = fmul contract <8 x double> %.1236.i, %.1236.i
  %.1287.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i137, <8 x double> %.1283.i, <8 x double> %.1286.i)
  %.1291.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i137, <8 x double> %.1287.i, <8 x double> %.1290.i)
  %.1295.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i137, <8 x double> %.1291.i, <8 x double> %.1294.i)
  %.1302.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i137, <8 x double> %.1298.i, <8 x double> %.1301.i)
  %.1306.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i137, <8 x double> %.1302.i, <8 x double> %.1305.i)
  %.1310.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i137, <8 x double> %.1306.i, <8 x double> %.1309.i)
  %.1317.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i137, <8 x double> %.1313.i, <8 x double> %.1316.i)
  %.1321.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i137, <8 x double> %.1317.i, <8 x double> %.1320.i)
  %.1325.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i137, <8 x double> %.1321.i, <8 x double> %.1324.i)
  %.1332.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i137, <8 x double> %.1328.i, <8 x double> %.1331.i)
  %.1336.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i137, <8 x double> %.1332.i, <8 x double> %.1335.i)
  %.1340.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i137, <8 x double> %.1336.i, <8 x double> %.1339.i)
  %.1347.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i137, <8 x double> %.1343.i, <8 x double> %.1346.i)
  %.1351.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i137, <8 x double> %.1347.i, <8 x double> %.1350.i)
  %.1355.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i137, <8 x double> %.1351.i, <8 x double> %.1354.i)
  %.1362.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i137, <8 x double> %.1358.i, <8 x double> %.1361.i)
  %.1366.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i137, <8 x double> %.1362.i, <8 x double> %.1365.i)
  %.1367.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1236.i, <8 x double> %.1340.i, <8 x double> %.1325.i)
  %scevgep335 = getelementptr i8, ptr %scevgep334, i64 %lsr.iv20.i
  %.1377.i = load <8 x double>, ptr %scevgep335, align 8, !noalias !92
  %.6.i16.i = fmul contract <8 x double> %.1377.i, %.1367.i
  %.6.i17.i = fmul contract <8 x double> %.1246.i, %.1256.i
  %.1426.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1236.i, <8 x double> %.1366.i, <8 x double> %.1355.i)
  %.1430.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i17.i, <8 x double> %.1429.i, <8 x double> %.1426.i)
  %.1431.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1236.i, <8 x double> %.1310.i, <8 x double> %.1295.i)
  %scevgep22.i = getelementptr i8, ptr %arg.work.4, i64 %lsr.iv20.i
  %.1441.i = load <8 x double>, ptr %scevgep22.i, align 8, !noalias !92
  %.1442.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1246.i, <8 x double> %.1431.i, <8 x double> %.1441.i)
  %.1443.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1256.i, <8 x double> %.1430.i, <8 x double> %.1442.i)
  %.6.i18.i = fadd contract <8 x double> %.6.i16.i, %.1443.i
  %.1450.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1246.i, <8 x double> %.1447.i, <8 x double> %.1449.i)
  %.6.i19.i = fsub contract <8 x double> %.1450.i, %.6.i18.i
  %scevgep.i138 = getelementptr i8, ptr %.866, i64 %lsr.iv20.i
  store <8 x double> %.6.i19.i, ptr %scevgep.i138, align 8, !noalias !92
  %lsr.iv.next21.i = add i64 %lsr.iv20.i, 64
  %lsr.iv.next6 = add nsw i64 %lsr.iv5, -1
  %.1189.i = icmp sgt i64 %lsr.iv5, 7
  br i1 %.1189.i, label %B484.if.i, label %B64.if.i146.preheader

B0.endif.endif.endif.endi...endif.5:              ; preds = %_ZN17bnserve_surrogate6kernel7_points15spline_at_nodesB4v236B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE.exit119
  br i1 %13, label %B0.endif.endif.endif.endi...endif.5.endif.endif, label %B64.if.i146.preheader

B64.if.i146.preheader:                            ; preds = %B484.if.i, %B0.endif.endif.endif.endi...endif.5
  %.192016 = getelementptr inbounds double, ptr %arg.polynomials_p.4, i64 %.236
  br label %B64.if.i146

B424.i172:                                        ; preds = %B172.if.i150
  %.138.i173 = add nsw i64 %.128167175.i148, -1
  %.142.i174 = add i64 %.135168174.i149, 8
  %.6.i.i175 = fadd contract <8 x double> %.322.i163, %.352.i168
  %.398.i176 = getelementptr inbounds double, ptr %.192016, i64 %.135168174.i149
  store <8 x double> %.6.i.i175, ptr %.398.i176, align 8, !noalias !95
  %scevgep.i177 = getelementptr i8, ptr %lsr.iv2.i147, i64 64
  %.129.i178 = icmp sgt i64 %.128167175.i148, 1
  br i1 %.129.i178, label %B64.if.i146, label %B0.endif.endif.endif.endi...endif.5.endif.endif

B64.if.i146:                                      ; preds = %B424.i172, %B64.if.i146.preheader
  %lsr.iv2.i147 = phi ptr [ %scevgep.i177, %B424.i172 ], [ %.866, %B64.if.i146.preheader ]
  %.128167175.i148 = phi i64 [ %.138.i173, %B424.i172 ], [ %.132, %B64.if.i146.preheader ]
  %.135168174.i149 = phi i64 [ %.142.i174, %B424.i172 ], [ 0, %B64.if.i146.preheader ]
  br label %B172.if.i150

B172.if.i150:                                     ; preds = %B172.if.i150, %B64.if.i146
  %lsr.iv1 = phi i64 [ %lsr.iv.next2, %B172.if.i150 ], [ 10, %B64.if.i146 ]
  %lsr.iv3.i151 = phi i64 [ %lsr.iv.next4.i170, %B172.if.i150 ], [ 8, %B64.if.i146 ]
  %even.2.1163.i153 = phi <8 x double> [ %.322.i163, %B172.if.i150 ], [ zeroinitializer, %B64.if.i146 ]
  %odd.2.1162.i154 = phi <8 x double> [ %.352.i168, %B172.if.i150 ], [ zeroinitializer, %B64.if.i146 ]
  %41 = shl nuw nsw i64 %lsr.iv3.i151, 3
  %scevgep4 = getelementptr i8, ptr %.543, i64 %41
  %scevgep3 = getelementptr i8, ptr %scevgep4, i64 -64
  %.307.i157 = load <8 x double>, ptr %scevgep3, align 8, !noalias !95
  %scevgep6.i158 = getelementptr i8, ptr %lsr.iv2.i147, i64 %lsr.iv3.i151
  %scevgep7.i159 = getelementptr i8, ptr %scevgep6.i158, i64 -8
  %.318.i160 = load double, ptr %scevgep7.i159, align 8, !noalias !95
  %.320.i161 = insertelement <8 x double> poison, double %.318.i160, i64 0
  %.321.i162 = shufflevector <8 x double> %.320.i161, <8 x double> poison, <8 x i32> zeroinitializer
  %.322.i163 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.307.i157, <8 x double> %.321.i162, <8 x double> %even.2.1163.i153)
  %.336.i164 = load <8 x double>, ptr %scevgep4, align 8, !noalias !95
  %.348.i165 = load double, ptr %scevgep6.i158, align 8, !noalias !95
  %.350.i166 = insertelement <8 x double> poison, double %.348.i165, i64 0
  %.351.i167 = shufflevector <8 x double> %.350.i166, <8 x double> poison, <8 x i32> zeroinitializer
  %.352.i168 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.336.i164, <8 x double> %.351.i167, <8 x double> %odd.2.1162.i154)
  %lsr.iv.next4.i170 = add nuw nsw i64 %lsr.iv3.i151, 16
  %lsr.iv.next2 = add nsw i64 %lsr.iv1, -1
  %.259.i171 = icmp samesign ugt i64 %lsr.iv1, 7
  br i1 %.259.i171, label %B172.if.i150, label %B424.i172

B0.endif.endif.endif.endi...endif.5.endif.endif:  ; preds = %B424.i172, %B0.endif.endif.endif.endi...endif.5
  store ptr null, ptr %retptr, align 8
  br label %common.ret
}

; Function Attrs: nofree noinline norecurse nosync nounwind memory(argmem: readwrite)
define internal fastcc noundef range(i32 0, 2) i32 @inner_11(ptr noalias nonnull writeonly captures(none) %retptr, ptr noalias nonnull writeonly captures(none) %excinfo, ptr readonly captures(none) %arg.row.4, double %arg.unit, ptr readonly captures(none) %arg.band.4, ptr readonly captures(none) %arg.gauge.4, i64 %arg.alignment, ptr initializes((0, 384)) %arg.room.4, ptr writeonly captures(none) initializes((0, 64)) %arg.out.4) unnamed_addr #6 {
entry:
  %.107 = load double, ptr %arg.row.4, align 8
  %.136 = getelementptr i8, ptr %arg.row.4, i64 24
  %.137 = load double, ptr %.136, align 8
  %.166 = getelementptr i8, ptr %arg.row.4, i64 32
  %.167 = load double, ptr %.166, align 8
  %.205 = getelementptr i8, ptr %arg.row.4, i64 56
  %.206 = load double, ptr %.205, align 8
  %.305 = fmul contract double %arg.unit, 0x400921FB54442D18
  %.306 = tail call contract double @llvm.pow.f64(double %.305, double 0x3FD5555555555555)
  %.5.i = fadd contract double %.107, 1.000000e+00
  %.147.i.i4 = fmul contract double %.5.i, %.5.i
  %.35.i = fdiv contract double %.107, %.147.i.i4
  %.335 = fmul contract double %.35.i, 0x3AD23C9F83511538
  %.338 = fmul contract double %.206, %.206
  %.339 = fmul contract double %.338, %.335
  %.368 = getelementptr i8, ptr %arg.row.4, i64 40
  %.369 = load double, ptr %.368, align 8
  %.373 = fdiv contract double %.339, %.369
  %.54.i = fsub contract double %.137, %.167
  %.147.i.i1 = fmul contract double %.54.i, %.54.i
  %.45.i = fadd contract double %.107, -1.000000e+00
  %.50.i = fdiv contract double %.45.i, %.5.i
  %.51.i = fadd contract double %.137, %.167
  %.52.i = fmul contract double %.51.i, 5.000000e-01
  %.53.i = fmul contract double %.50.i, 5.000000e-01
  %.55.i = fmul contract double %.53.i, %.54.i
  %.81.i = fmul contract double %.147.i.i1, 2.500000e-01
  store double 1.000000e+00, ptr %arg.out.4, align 8, !noalias !98
  %.138.i = getelementptr i8, ptr %arg.out.4, i64 8
  store double 0.000000e+00, ptr %.138.i, align 8, !noalias !98
  %.140.i = fmul contract double %.35.i, 0x400579E79E79E79E
  %.141.i = fadd contract double %.140.i, 0xBFF7124924924925
  %.169.i = getelementptr i8, ptr %arg.out.4, i64 16
  store double %.141.i, ptr %.169.i, align 8, !noalias !98
  %.171.i = fmul contract double %.55.i, 3.375000e+00
  %.172.i = fmul contract double %.35.i, 0x3FFD555555555555
  %.173.i = fsub contract double 3.375000e+00, %.172.i
  %.174.i = fmul contract double %.52.i, %.173.i
  %.175.i = fadd contract double %.171.i, %.174.i
  %.203.i = getelementptr i8, ptr %arg.out.4, i64 24
  store double %.175.i, ptr %.203.i, align 8, !noalias !98
  %.205.i = fmul contract double %.35.i, 0x401167EA53FA94FF
  %.206.i = fadd contract double %.205.i, 0xC0175371959340D3
  %.207.i = fmul contract double %.35.i, %.206.i
  %.208.i = fadd contract double %.207.i, 0xC00AE15A0AB4FC95
  %.236.i = getelementptr i8, ptr %arg.out.4, i64 32
  %.267.i = fmul contract double %.35.i, 6.000000e+00
  %.268.i = fadd contract double %.267.i, -1.531250e+00
  %.269.i2 = fmul contract double %.268.i, %.81.i
  %.270.i = fmul contract double %.55.i, 3.062500e+00
  %.271.i = fmul contract double %.52.i, %.270.i
  %.272.i = fsub contract double %.269.i2, %.271.i
  %.273.i = fadd contract double %.208.i, %.272.i
  %.147.i15.i = fmul contract double %.52.i, %.52.i
  %.335.i = fmul contract double %.35.i, 1.250000e-01
  %.336.i = fadd contract double %.335.i, -1.531250e+00
  %.361.i = fmul contract double %.336.i, %.147.i15.i
  %.362.i3 = fadd contract double %.361.i, %.273.i
  store double %.362.i3, ptr %.236.i, align 8, !noalias !98
  %.393.i = fmul contract double %.35.i, 4.000000e+00
  %.394.i = fsub contract double 1.000000e+00, %.393.i
  %.395.i = fmul contract double %.394.i, 0x4010B090E5F545F2
  %.396.i = fmul contract double %.35.i, 0x3FD9104104104104
  %.397.i = fsub contract double 0x4031AEEFBEFBEFBF, %.396.i
  %.398.i = fmul contract double %.55.i, %.397.i
  %0 = fsub contract double %.398.i, %.395.i
  %.427.i = getelementptr i8, ptr %arg.out.4, i64 40
  %.458.i = fmul contract double %.35.i, 0x4001ACB2CB2CB2CB
  %.459.i = fadd contract double %.458.i, 0x4036CB0C30C30C31
  %.460.i = fmul contract double %.35.i, %.459.i
  %.461.i = fsub contract double 0x4031AEEFBEFBEFBF, %.460.i
  %.462.i = fmul contract double %.52.i, %.461.i
  %.463.i = fadd contract double %0, %.462.i
  store double %.463.i, ptr %.427.i, align 8, !noalias !98
  %.519.i = fmul contract double %.35.i, 0x4050B13F2FF5EE90
  %.520.i = fadd contract double %.519.i, 0xC034AE5A84540D99
  %.548.i4 = getelementptr i8, ptr %arg.out.4, i64 48
  %.147.i39.i = fmul contract double %.35.i, %.35.i
  %.603.i = fmul contract double %.35.i, 0x401597306EFC97DE
  %.604.i = fadd contract double %.603.i, 0xC0322AE304374842
  %.605.i = fmul contract double %.147.i39.i, %.604.i
  %.606.i = fadd contract double %.520.i, %.605.i
  %.665.i = fmul contract double %.55.i, 0x4004AAAAAAAAAAAB
  %.666.i = fmul contract double %.35.i, 0x4002AAAAAAAAAAAB
  %.667.i = fsub contract double 0x4004AAAAAAAAAAAB, %.666.i
  %.668.i = fmul contract double %.52.i, %.667.i
  %.669.i = fadd contract double %.665.i, %.668.i
  %.670.i = fmul contract double %.669.i, 0x400921FB54442D18
  %.671.i5 = fadd contract double %.606.i, %.670.i
  %.730.i = fmul contract double %.35.i, 0x4017618618618618
  %.731.i = fadd contract double %.730.i, 0x404C130E38E38E39
  %.732.i = fmul contract double %.35.i, %.731.i
  %.733.i = fadd contract double %.732.i, 0xC02B20D145145145
  %.734.i = fmul contract double %.81.i, %.733.i
  %.735.i = fadd contract double %.734.i, %.671.i5
  %.794.i = fmul contract double %.35.i, 0x4043F51861861862
  %.795.i = fadd contract double %.794.i, 0xC03B20D145145145
  %.796.i = fmul contract double %.55.i, %.795.i
  %.797.i = fmul contract double %.52.i, %.796.i
  %.798.i = fadd contract double %.797.i, %.735.i
  %.857.i = fmul contract double %.35.i, 0x402975F7DF7DF7DF
  %.858.i = fsub contract double 0x404302DB6DB6DB6E, %.857.i
  %.859.i = fmul contract double %.35.i, %.858.i
  %.860.i = fadd contract double %.859.i, 0xC02B20D145145145
  %.885.i = fmul contract double %.147.i15.i, %.860.i
  %.886.i = fadd contract double %.885.i, %.798.i
  store double %.886.i, ptr %.548.i4, align 8, !noalias !98
  %.916.i = fmul contract double %.35.i, 0x402001CC877321DD
  %.917.i = fsub contract double 0x403044E0D8B8362E, %.916.i
  %.918.i = fmul contract double %.35.i, %.917.i
  %.919.i = fsub contract double 0x400A4763546E2A71, %.918.i
  %.920.i = fmul contract double %.919.i, 0x400921FB54442D18
  %.948.i = getelementptr i8, ptr %arg.out.4, i64 56
  store double %.920.i, ptr %.948.i, align 8, !noalias !98
  %.39.i = fdiv contract double 0x3FE4F1A6C638D03F, %.35.i
  %.47.i = tail call contract double @sqrt(double %.39.i)
  %.433 = fmul contract double %.373, %.47.i
  %.436 = fmul contract double %.306, %.306
  %.438 = fmul contract double %.306, %.436
  %.447 = tail call contract double @sqrt(double %.306)
  %.452 = fmul contract double %.438, %.447
  %.456 = fdiv contract double %.433, %.452
  store double %.456, ptr %arg.out.4, align 8
  %.641 = fmul contract double %.306, %.456
  %.608.1 = fmul contract double %.641, 0.000000e+00
  store double %.608.1, ptr %.138.i, align 8
  %.641.1 = fmul contract double %.306, %.641
  %.608.2 = fmul contract double %.141.i, %.641.1
  store double %.608.2, ptr %.169.i, align 8
  %.641.2 = fmul contract double %.306, %.641.1
  %.608.3 = fmul contract double %.175.i, %.641.2
  store double %.608.3, ptr %.203.i, align 8
  %.641.3 = fmul contract double %.306, %.641.2
  %.608.4 = fmul contract double %.362.i3, %.641.3
  store double %.608.4, ptr %.236.i, align 8
  %.641.4 = fmul contract double %.306, %.641.3
  %.608.5 = fmul contract double %.463.i, %.641.4
  store double %.608.5, ptr %.427.i, align 8
  %.641.5 = fmul contract double %.306, %.641.4
  %.608.6 = fmul contract double %.886.i, %.641.5
  store double %.608.6, ptr %.548.i4, align 8
  %.641.6 = fmul contract double %.306, %.641.5
  %.608.7 = fmul contract double %.920.i, %.641.6
  store double %.608.7, ptr %.948.i, align 8
  %.681 = getelementptr i8, ptr %arg.row.4, i64 8
  %.682 = load double, ptr %.681, align 8
  %.711 = getelementptr i8, ptr %arg.row.4, i64 16
  %.712 = load double, ptr %.711, align 8
  tail call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(384) %arg.room.4, i8 0, i64 384, i1 false), !noalias !101
  %.33.i = fdiv contract double %.107, %.5.i
  %.38.i = fdiv contract double 1.000000e+00, %.5.i
  %.39.i6 = fmul contract double %.33.i, %.38.i
  store double 1.000000e+00, ptr %arg.room.4, align 8, !noalias !104
  %.183.i.i = getelementptr i8, ptr %arg.room.4, i64 16
  %.203.i.i = fmul contract double %.39.i6, 0x401871C71C71C71C
  %.204.i.i = fadd contract double %.203.i.i, 0x4013A7F529FD4A7F
  store double %.204.i.i, ptr %.183.i.i, align 8, !noalias !104
  %.308.i.i = getelementptr i8, ptr %arg.room.4, i64 24
  %.309.i.i = load double, ptr %.308.i.i, align 8, !noalias !104
  %.310.i2.i = fadd contract double %.309.i.i, 0xC04921FB54442D18
  store double %.310.i2.i, ptr %.308.i.i, align 8, !noalias !104
  %.413.i.i = getelementptr i8, ptr %arg.room.4, i64 32
  %.414.i.i = load double, ptr %.413.i.i, align 8, !noalias !104
  %.454.i.i = fmul contract double %.39.i6, 0x40456C71C71C71C7
  %.455.i.i = fadd contract double %.454.i.i, 0x404AEDF7DF7DF7DF
  %.456.i.i = fmul contract double %.39.i6, %.455.i.i
  %.457.i.i = fadd contract double %.456.i.i, 0x403E1A683B5702A5
  %.458.i.i = fadd contract double %.457.i.i, %.414.i.i
  store double %.458.i.i, ptr %.413.i.i, align 8, !noalias !104
  %.561.i.i = getelementptr i8, ptr %arg.room.4, i64 168
  %.562.i.i = load double, ptr %.561.i.i, align 8, !noalias !104
  %.581.i.i = fmul contract double %.39.i6, 0x40510457810E2933
  %1 = fsub contract double 0x407E1C5F0E074C89, %.581.i.i
  %.583.i.i = fadd contract double %1, %.562.i.i
  store double %.583.i.i, ptr %.561.i.i, align 8, !noalias !104
  %.686.i.i = getelementptr i8, ptr %arg.room.4, i64 48
  %.687.i.i = load double, ptr %.686.i.i, align 8, !noalias !104
  %.756.i.i = fmul contract double %.39.i6, 0x4058A8587E6B74F0
  %2 = fsub contract double 0x404601B425ED097B, %.756.i.i
  %.758.i.i = fmul contract double %.39.i6, %2
  %.759.i.i = fadd contract double %.758.i.i, 0xC0A9D8A41ED3317E
  %.760.i.i = fmul contract double %.39.i6, %.759.i.i
  %.761.i.i = fadd contract double %.760.i.i, 0xC071640B49E85C3E
  %.762.i.i = fadd contract double %.761.i.i, %.687.i.i
  store double %.762.i.i, ptr %.686.i.i, align 8, !noalias !104
  %.865.i.i = getelementptr i8, ptr %arg.room.4, i64 176
  %.866.i.i = load double, ptr %.865.i.i, align 8, !noalias !104
  %.867.i.i = fadd contract double %.866.i.i, 0xC074618618618618
  store double %.867.i.i, ptr %.865.i.i, align 8, !noalias !104
  %.970.i.i = getelementptr i8, ptr %arg.room.4, i64 56
  %.971.i.i = load double, ptr %.970.i.i, align 8, !noalias !104
  %.1011.i.i = fmul contract double %.39.i6, 0x40733B288412FE12
  %3 = fsub contract double 0x408893BEE8443B83, %.1011.i.i
  %.1013.i.i = fmul contract double %.39.i6, %3
  %.1014.i.i = fadd contract double %.1013.i.i, 0x408DCC10DD757C0B
  %.1015.i.i = fadd contract double %.1014.i.i, %.971.i.i
  store double %.1015.i.i, ptr %.970.i.i, align 8, !noalias !104
  %.1118.i.i = getelementptr i8, ptr %arg.room.4, i64 192
  %.1119.i.i = load double, ptr %.1118.i.i, align 8, !noalias !104
  %.1225.i.i = fmul contract double %.39.i6, 0x40514C5F3B7242FB
  %.1226.i.i = fadd contract double %.1225.i.i, 0xC05D2FBB067D39F9
  %.1227.i.i = fmul contract double %.39.i6, %.1226.i.i
  %.1228.i.i = fadd contract double %.1227.i.i, 0xC091A4640F04B974
  %.1229.i.i = fmul contract double %.39.i6, %.1228.i.i
  %.1230.i.i = fadd contract double %.1229.i.i, 0x40CE3F8117DB38CA
  %.1231.i.i = fmul contract double %.39.i6, %.1230.i.i
  %.1232.i.i = fadd contract double %.1231.i.i, 0xC0A8D75E6BF57F9D
  %.1233.i.i = fadd contract double %.1232.i.i, %.1119.i.i
  store double %.1233.i.i, ptr %.1118.i.i, align 8, !noalias !104
  %.1336.i.i = getelementptr i8, ptr %arg.room.4, i64 320
  %.1337.i.i = load double, ptr %.1336.i.i, align 8, !noalias !104
  %.1356.i.i = fmul contract double %.39.i6, 0x409F6EC11CD4D97E
  %.1357.i.i = fadd contract double %.1356.i.i, 0x4072428A28A28A29
  %.1358.i.i = fadd contract double %.1357.i.i, %.1337.i.i
  store double %.1358.i.i, ptr %.1336.i.i, align 8, !noalias !104
  %.1461.i.i = getelementptr i8, ptr %arg.room.4, i64 72
  %.1462.i.i = load double, ptr %.1461.i.i, align 8, !noalias !104
  %.1531.i.i = fmul contract double %.39.i6, 0x40645019F9E83A77
  %.1532.i.i = fadd contract double %.1531.i.i, 0x40918164C0B5D6FD
  %.1533.i.i = fmul contract double %.39.i6, %.1532.i.i
  %.1534.i.i = fadd contract double %.1533.i.i, 0xC0D6C519D7F78519
  %.1535.i.i = fmul contract double %.39.i6, %.1534.i.i
  %.1536.i.i = fadd contract double %.1535.i.i, 0x40BB4B9C657BC796
  %.1537.i.i = fadd contract double %.1536.i.i, %.1462.i.i
  store double %.1537.i.i, ptr %.1461.i.i, align 8, !noalias !104
  %.1640.i.i = getelementptr i8, ptr %arg.room.4, i64 200
  %.1641.i.i = load double, ptr %.1640.i.i, align 8, !noalias !104
  %.1642.i.i = fadd contract double %.1641.i.i, 0xC0A001D567F49087
  store double %.1642.i.i, ptr %.1640.i.i, align 8, !noalias !104
  %.1810.i.i = fmul contract double %.39.i6, 0x40A619E547AE6DA3
  %.1811.i.i = fadd contract double %.1810.i.i, 0xC0D25E7665446D0F
  %.1812.i.i = fmul contract double %.39.i6, %.1811.i.i
  %.1813.i.i = fadd contract double %.1812.i.i, 0x40E19BDA5330D73F
  %.1814.i.i = fmul contract double %.39.i6, %.1813.i.i
  %.1815.i.i = fadd contract double %.1814.i.i, 0xC0E154650FD9ACF1
  %.1867.i.i = getelementptr i8, ptr %arg.room.4, i64 80
  %.1868.i.i = load double, ptr %.1867.i.i, align 8, !noalias !104
  %.1956.i.i = fmul contract double %.39.i6, %.1815.i.i
  %.1957.i.i = fadd contract double %.1956.i.i, 0xC0F5A16228D9F21A
  %.1958.i.i = fmul contract double %.39.i6, %.1957.i.i
  %.1959.i.i = fadd contract double %.1958.i.i, 0x40ECE30547C08F3B
  %.1960.i.i = fmul contract double %.39.i6, %.1959.i.i
  %.1961.i.i = fadd contract double %.1960.i.i, 0xC0C172813AB99F84
  %.1962.i.i = fmul contract double %.39.i6, 3.000000e+00
  %.1963.i.i = fsub contract double 1.000000e+00, %.1962.i.i
  %.1967.i.i = fdiv contract double %.1961.i.i, %.1963.i.i
  %.1968.i.i = fadd contract double %.1967.i.i, %.1868.i.i
  store double %.1968.i.i, ptr %.1867.i.i, align 8, !noalias !104
  %.2088.i.i = fmul contract double %.39.i6, 0x40C0712C540DB5CD
  %.2089.i.i = fadd contract double %.2088.i.i, 0x40A79A477BF30A91
  %.2090.i.i = fmul contract double %.39.i6, %.2089.i.i
  %.2091.i.i = fadd contract double %.2090.i.i, 0xC0A4B055B758E414
  %.2092.i.i = fmul contract double %.39.i6, %.2091.i.i
  %.2093.i.i = fadd contract double %.2092.i.i, 0x406D67FD70A13797
  %.2145.i.i = getelementptr i8, ptr %arg.room.4, i64 208
  %.2146.i.i = load double, ptr %.2145.i.i, align 8, !noalias !104
  %.2152.i.i = fdiv contract double %.2093.i.i, %.1963.i.i
  %.2153.i.i = fadd contract double %.2152.i.i, %.2146.i.i
  store double %.2153.i.i, ptr %.2145.i.i, align 8, !noalias !104
  %.2256.i.i = getelementptr i8, ptr %arg.room.4, i64 88
  %.2257.i.i = load double, ptr %.2256.i.i, align 8, !noalias !104
  %.2363.i.i = fmul contract double %.39.i6, 0x402CA90C106318D7
  %.2364.i.i = fadd contract double %.2363.i.i, 0xC06030460C29F3DF
  %.2365.i.i = fmul contract double %.39.i6, %.2364.i.i
  %.2366.i.i = fadd contract double %.2365.i.i, 0x40D015D04F4BC5D2
  %.2367.i.i = fmul contract double %.39.i6, %.2366.i.i
  %.2368.i.i = fadd contract double %.2367.i.i, 0xC0E536054A2E10AB
  %.2369.i.i = fmul contract double %.39.i6, %.2368.i.i
  %.2370.i.i = fadd contract double %.2369.i.i, 0x40C95DBCC2240A74
  %.2371.i.i = fadd contract double %.2370.i.i, %.2257.i.i
  store double %.2371.i.i, ptr %.2256.i.i, align 8, !noalias !104
  %.2474.i.i = getelementptr i8, ptr %arg.room.4, i64 216
  %.2475.i.i = load double, ptr %.2474.i.i, align 8, !noalias !104
  %.2494.i.i = fmul contract double %.39.i6, 0x40BD257CD0AE1310
  %4 = fsub contract double 0xC09600901EF7C9A4, %.2494.i.i
  %.2496.i.i = fadd contract double %4, %.2475.i.i
  store double %.2496.i.i, ptr %.2474.i.i, align 8, !noalias !104
  %.24.i.i = fsub contract double 1.000000e+00, %.33.i
  %.25.i.i = fmul contract double %.33.i, %.24.i.i
  %.26.i.i = fmul contract double %.137, %.33.i
  %.80.i.i = fmul contract double %.33.i, 0x4029555555555555
  %.81.i.i = fadd contract double %.80.i.i, 2.500000e+01
  %.82.i.i = fmul contract double %.26.i.i, %.81.i.i
  %.83.i.i = fadd contract double %.82.i.i, %.310.i2.i
  store double %.83.i.i, ptr %.308.i.i, align 8, !noalias !107
  %5 = getelementptr i8, ptr %arg.room.4, i64 128
  %.188.i.i = fmul contract double %.26.i.i, 3.000000e+00
  %.189.i.i = fmul contract double %.25.i.i, 0x400AAAAAAAAAAAAB
  %.190.i.i = fsub contract double 0x4064B4F3CF3CF3CF, %.189.i.i
  %.191.i.i = fmul contract double %.25.i.i, 0x4032E38E38E38E39
  %.192.i.i = fadd contract double %.191.i.i, 0x4063B0FCD6E9E065
  %.193.i.i = fmul contract double %.33.i, %.192.i.i
  %.194.i.i = fadd contract double %.190.i.i, %.193.i.i
  %.195.i.i = fmul contract double %.188.i.i, %.194.i.i
  %6 = fsub contract double %.583.i.i, %.195.i.i
  store double %6, ptr %.561.i.i, align 8, !noalias !107
  %.301.i.i = fmul contract double %.26.i.i, 0x400921FB54442D18
  %.302.i.i = fmul contract double %.33.i, 2.600000e+02
  %.303.i.i = fadd contract double %.302.i.i, 0x407F0AAAAAAAAAAB
  %.304.i.i = fmul contract double %.303.i.i, %.301.i.i
  %.305.i.i = fadd contract double %.304.i.i, %.762.i.i
  store double %.305.i.i, ptr %.686.i.i, align 8, !noalias !107
  %.357.i.i = fmul contract double %.25.i.i, 0x4020F1C71C71C71C
  %.358.i.i = fsub contract double 0x40C10436B015AC05, %.357.i.i
  %.359.i.i = fmul contract double %.25.i.i, %.358.i.i
  %.360.i.i = fadd contract double %.359.i.i, 0xC0C7044BD0923320
  %.361.i.i = fmul contract double %.25.i.i, 0x404070E38E38E38E
  %.362.i.i = fadd contract double %.361.i.i, 0x40B0B864F3CF3CF4
  %.363.i.i = fmul contract double %.25.i.i, %.362.i.i
  %.364.i.i = fsub contract double 0x40AB9B8B602B580B, %.363.i.i
  %.418.i.i = fmul contract double %.33.i, %.360.i.i
  %.419.i.i = fmul contract double %.33.i, 2.000000e+00
  %.420.i.i = fadd contract double %.419.i.i, -1.000000e+00
  %.421.i.i = fmul contract double %.420.i.i, %.364.i.i
  %.422.i.i = fadd contract double %.418.i.i, %.421.i.i
  %.423.i.i = fmul contract double %.26.i.i, %.422.i.i
  %.424.i.i = fadd contract double %.423.i.i, %.1015.i.i
  store double %.424.i.i, ptr %.970.i.i, align 8, !noalias !107
  %.24.i5.i = fsub contract double 1.000000e+00, %.38.i
  %.25.i6.i = fmul contract double %.38.i, %.24.i5.i
  %.26.i7.i = fmul contract double %.38.i, %.167
  %.80.i10.i = fmul contract double %.38.i, 0x4029555555555555
  %.81.i11.i = fadd contract double %.80.i10.i, 2.500000e+01
  %.82.i12.i = fmul contract double %.26.i7.i, %.81.i11.i
  %.83.i13.i = fadd contract double %.82.i12.i, %.83.i.i
  store double %.83.i13.i, ptr %.308.i.i, align 8, !noalias !110
  %.188.i16.i = fmul contract double %.26.i7.i, 3.000000e+00
  %.189.i17.i = fmul contract double %.25.i6.i, 0x400AAAAAAAAAAAAB
  %.190.i18.i = fsub contract double 0x4064B4F3CF3CF3CF, %.189.i17.i
  %.191.i19.i = fmul contract double %.25.i6.i, 0x4032E38E38E38E39
  %.192.i20.i = fadd contract double %.191.i19.i, 0x4063B0FCD6E9E065
  %.193.i21.i = fmul contract double %.38.i, %.192.i20.i
  %.194.i22.i = fadd contract double %.190.i18.i, %.193.i21.i
  %.195.i23.i = fmul contract double %.188.i16.i, %.194.i22.i
  %7 = fsub contract double %6, %.195.i23.i
  store double %7, ptr %.561.i.i, align 8, !noalias !110
  %.301.i26.i = fmul contract double %.26.i7.i, 0x400921FB54442D18
  %.302.i27.i = fmul contract double %.38.i, 2.600000e+02
  %.303.i28.i = fadd contract double %.302.i27.i, 0x407F0AAAAAAAAAAB
  %.304.i29.i = fmul contract double %.303.i28.i, %.301.i26.i
  %.305.i30.i = fadd contract double %.304.i29.i, %.305.i.i
  store double %.305.i30.i, ptr %.686.i.i, align 8, !noalias !110
  %.357.i31.i = fmul contract double %.25.i6.i, 0x4020F1C71C71C71C
  %.358.i32.i = fsub contract double 0x40C10436B015AC05, %.357.i31.i
  %.359.i33.i = fmul contract double %.25.i6.i, %.358.i32.i
  %.360.i34.i = fadd contract double %.359.i33.i, 0xC0C7044BD0923320
  %.361.i35.i = fmul contract double %.25.i6.i, 0x404070E38E38E38E
  %.362.i36.i = fadd contract double %.361.i35.i, 0x40B0B864F3CF3CF4
  %.363.i37.i = fmul contract double %.25.i6.i, %.362.i36.i
  %.364.i38.i = fsub contract double 0x40AB9B8B602B580B, %.363.i37.i
  %.418.i41.i = fmul contract double %.38.i, %.360.i34.i
  %.419.i42.i = fmul contract double %.38.i, 2.000000e+00
  %.420.i43.i = fadd contract double %.419.i42.i, -1.000000e+00
  %.421.i44.i = fmul contract double %.420.i43.i, %.364.i38.i
  %.422.i45.i = fadd contract double %.418.i41.i, %.421.i44.i
  %.423.i46.i = fmul contract double %.26.i7.i, %.422.i45.i
  %.424.i47.i = fadd contract double %.423.i46.i, %.424.i.i
  store double %.424.i47.i, ptr %.970.i.i, align 8, !noalias !110
  %.15.le.i.i = fcmp contract uno double %.682, 0.000000e+00
  %.17.le.i.i = fcmp contract oge double %.682, 1.000000e+00
  %8 = or i1 %.15.le.i.i, %.17.le.i.i
  %9 = tail call contract double @llvm.log.f64(double %.682)
  %.31.le.i.i = select i1 %8, double %9, double 0.000000e+00
  %.5.i.i.i = fmul contract double %.31.le.i.i, 1.230000e-04
  %.6.i.i.i = fadd contract double %.5.i.i.i, -4.210000e-03
  %.7.i.i.i = fmul contract double %.31.le.i.i, %.6.i.i.i
  %.8.i.i.i = fadd contract double %.7.i.i.i, 4.740000e-02
  %.9.i.i.i = fmul contract double %.31.le.i.i, %.8.i.i.i
  %.10.i.i.i = fadd contract double %.9.i.i.i, 9.360000e-02
  %.11.i.i.i = fmul contract double %.31.le.i.i, %.10.i.i.i
  %.12.i.i.i = fadd contract double %.11.i.i.i, 1.940000e-01
  %.62.i.i = fcmp contract ogt double %.682, 1.000000e+00
  %.64.i.i = uitofp i1 %.62.i.i to double
  %.65.i.i = fmul contract double %.12.i.i.i, %.64.i.i
  %.73.le.i.i = tail call contract double @llvm.exp.f64(double %.65.i.i)
  %.147.i.i.i7 = fmul contract double %.26.i.i, %.26.i.i
  %.106.i.i = fmul contract double %.73.le.i.i, 5.000000e+01
  %.107.i.i = fadd contract double %.106.i.i, 6.250000e-01
  %10 = fmul contract double %.147.i.i.i7, %.107.i.i
  %.109.i.i = fsub contract double %.458.i.i, %10
  store double %.109.i.i, ptr %.413.i.i, align 8, !noalias !113
  %.214.i.i = fmul contract double %.33.i, 1.200000e+02
  %.215.i.i = fsub contract double 0x407E92AAAAAAAAAB, %.214.i.i
  %.216.i.i = fmul contract double %.33.i, %.215.i.i
  %.217.i.i = fadd contract double %.216.i.i, 0x40817F8618618618
  %.218.i.i = fmul contract double %.217.i.i, %.73.le.i.i
  %.219.i.i = fmul contract double %.33.i, 0x40416E38E38E38E4
  %.220.i.i = fsub contract double 0x40569AAAAAAAAAAB, %.219.i.i
  %.221.i.i = fmul contract double %.33.i, %.220.i.i
  %.222.i.i = fadd contract double %.221.i.i, 0x40831AC618618618
  %.223.i.i = fsub contract double %.218.i.i, %.222.i.i
  %.224.i.i = fmul contract double %.147.i.i.i7, %.223.i.i
  %.225.i.i = fadd contract double %.305.i30.i, %.224.i.i
  store double %.225.i.i, ptr %.686.i.i, align 8, !noalias !113
  %.331.i.i = fmul contract double %.147.i.i.i7, 0x4093A28C59D5433B
  %.332.i.i = fmul contract double %.331.i.i, %.73.le.i.i
  %11 = fsub contract double %.424.i47.i, %.332.i.i
  store double %11, ptr %.970.i.i, align 8, !noalias !113
  %.15.le.i49.i = fcmp contract uno double %.712, 0.000000e+00
  %.17.le.i50.i = fcmp contract oge double %.712, 1.000000e+00
  %12 = or i1 %.15.le.i49.i, %.17.le.i50.i
  %13 = tail call contract double @llvm.log.f64(double %.712)
  %.31.le.i51.i = select i1 %12, double %13, double 0.000000e+00
  %.5.i.i52.i = fmul contract double %.31.le.i51.i, 1.230000e-04
  %.6.i.i53.i = fadd contract double %.5.i.i52.i, -4.210000e-03
  %.7.i.i54.i = fmul contract double %.31.le.i51.i, %.6.i.i53.i
  %.8.i.i55.i = fadd contract double %.7.i.i54.i, 4.740000e-02
  %.9.i.i56.i = fmul contract double %.31.le.i51.i, %.8.i.i55.i
  %.10.i.i57.i = fadd contract double %.9.i.i56.i, 9.360000e-02
  %.11.i.i58.i = fmul contract double %.31.le.i51.i, %.10.i.i57.i
  %.12.i.i59.i = fadd contract double %.11.i.i58.i, 1.940000e-01
  %.62.i60.i = fcmp contract ogt double %.712, 1.000000e+00
  %.64.i61.i = uitofp i1 %.62.i60.i to double
  %.65.i62.i = fmul contract double %.12.i.i59.i, %.64.i61.i
  %.73.le.i63.i = tail call contract double @llvm.exp.f64(double %.65.i62.i)
  %.147.i.i65.i = fmul contract double %.26.i7.i, %.26.i7.i
  %.106.i68.i = fmul contract double %.73.le.i63.i, 5.000000e+01
  %.107.i69.i = fadd contract double %.106.i68.i, 6.250000e-01
  %14 = fmul contract double %.147.i.i65.i, %.107.i69.i
  %.109.i70.i = fsub contract double %.109.i.i, %14
  store double %.109.i70.i, ptr %.413.i.i, align 8, !noalias !116
  %.214.i73.i = fmul contract double %.38.i, 1.200000e+02
  %.215.i74.i = fsub contract double 0x407E92AAAAAAAAAB, %.214.i73.i
  %.216.i75.i = fmul contract double %.38.i, %.215.i74.i
  %.217.i76.i = fadd contract double %.216.i75.i, 0x40817F8618618618
  %.218.i77.i = fmul contract double %.217.i76.i, %.73.le.i63.i
  %.219.i78.i = fmul contract double %.38.i, 0x40416E38E38E38E4
  %.220.i79.i = fsub contract double 0x40569AAAAAAAAAAB, %.219.i78.i
  %.221.i80.i = fmul contract double %.38.i, %.220.i79.i
  %.222.i81.i = fadd contract double %.221.i80.i, 0x40831AC618618618
  %.223.i82.i = fsub contract double %.218.i77.i, %.222.i81.i
  %.224.i83.i = fmul contract double %.147.i.i65.i, %.223.i82.i
  %.225.i84.i = fadd contract double %.224.i83.i, %.225.i.i
  store double %.225.i84.i, ptr %.686.i.i, align 8, !noalias !116
  %.331.i87.i = fmul contract double %.147.i.i65.i, 0x4093A28C59D5433B
  %.332.i88.i = fmul contract double %.331.i87.i, %.73.le.i63.i
  %15 = fsub contract double %11, %.332.i88.i
  store double %15, ptr %.970.i.i, align 8, !noalias !116
  %.27.i.i = fmul contract double %.137, %.25.i.i
  %.28.i.i = fmul contract double %.167, %.27.i.i
  %.82.i93.i = fmul contract double %.28.i.i, 9.875000e+01
  %16 = fsub contract double %.109.i70.i, %.82.i93.i
  store double %16, ptr %.413.i.i, align 8, !noalias !119
  %.188.i96.i = fmul contract double %.25.i.i, 0x40735B8E38E38E39
  %.189.i97.i = fadd contract double %.188.i96.i, 0x40723BDB6DB6DB6E
  %.190.i98.i = fmul contract double %.28.i.i, %.189.i97.i
  %.191.i99.i = fadd contract double %.190.i98.i, %.225.i84.i
  store double %.191.i99.i, ptr %.686.i.i, align 8, !noalias !119
  %.245.i.i = fmul contract double %.167, %.24.i.i
  %.246.i.i = fsub contract double %.26.i.i, %.245.i.i
  %.147.i.i101.i = fmul contract double %.246.i.i, %.246.i.i
  %.301.i102.i = fmul contract double %.28.i.i, 8.000000e+02
  %.328.i103.i = fmul contract double %.147.i.i101.i, 7.500000e+00
  %.329.i104.i = fadd contract double %.301.i102.i, %.328.i103.i
  %.330.i.i = fmul contract double %.329.i104.i, 0x400921FB54442D18
  %17 = fsub contract double %15, %.330.i.i
  store double %17, ptr %.970.i.i, align 8, !noalias !119
  %.24.i105.i = fmul contract double %.33.i, %.33.i
  %.25.i106.i = fmul contract double %.24.i105.i, %.24.i105.i
  %.26.i107.i = fmul contract double %.25.i106.i, -2.400000e+01
  %.27.i108.i = fmul contract double %.26.i107.i, %.682
  %.81.i111.i = fmul contract double %.33.i, 1.100000e+01
  %.82.i112.i = fsub contract double 1.200000e+01, %.81.i111.i
  %.83.i113.i = fmul contract double %.82.i112.i, %.27.i108.i
  %.84.i.i = fadd contract double %.83.i113.i, %.1968.i.i
  store double %.84.i.i, ptr %.1867.i.i, align 8, !noalias !122
  %.187.i114.i = getelementptr i8, ptr %arg.room.4, i64 96
  %.188.i115.i = load double, ptr %.187.i114.i, align 8, !noalias !122
  %.189.i116.i = fmul contract double %.27.i108.i, 5.000000e+00
  %.193.i117.i = fdiv contract double %.189.i116.i, 6.720000e+02
  %.195.i119.i = fsub contract double 2.286000e+03, %.302.i.i
  %.196.i.i = fmul contract double %.33.i, %.195.i119.i
  %.197.i.i = fadd contract double %.196.i.i, 9.190000e+02
  %.198.i.i = fmul contract double %.33.i, %.197.i.i
  %.199.i.i = fsub contract double 3.179000e+03, %.198.i.i
  %.200.i.i = fmul contract double %.199.i.i, %.193.i117.i
  %.201.i.i = fadd contract double %.200.i.i, %.188.i115.i
  store double %.201.i.i, ptr %.187.i114.i, align 8, !noalias !122
  %.304.i120.i = getelementptr i8, ptr %arg.room.4, i64 104
  %.305.i121.i = load double, ptr %.304.i120.i, align 8, !noalias !122
  %.307.i.i = fmul contract double %.27.i108.i, 0xC00921FB54442D18
  %.310.i.i = fmul contract double %.82.i112.i, %.307.i.i
  %.311.i.i = fadd contract double %.310.i.i, %.305.i121.i
  store double %.311.i.i, ptr %.304.i120.i, align 8, !noalias !122
  %.363.i122.i = fmul contract double %.33.i, 0x4151712000000000
  %.364.i123.i = fsub contract double 0x41737B1700000000, %.363.i122.i
  %.365.i.i = fmul contract double %.33.i, %.364.i123.i
  %.366.i.i = fsub contract double 0x41A2E151D8000000, %.365.i.i
  %.418.i124.i = getelementptr i8, ptr %arg.room.4, i64 112
  %.419.i125.i = load double, ptr %.418.i124.i, align 8, !noalias !122
  %.424.i126.i = fdiv contract double %.189.i116.i, 0x417A29B000000000
  %.425.i.i = fmul contract double %.33.i, %.366.i.i
  %.426.i.i = fadd contract double %.425.i.i, 0x41A4DB86E0000000
  %.427.i.i = fmul contract double %.33.i, %.426.i.i
  %.428.i.i = fadd contract double %.427.i.i, 0x41849F27B8000000
  %.429.i.i = fmul contract double %.33.i, %.428.i.i
  %.430.i.i = fsub contract double 0x41B72002EE000000, %.429.i.i
  %.431.i.i = fmul contract double %.430.i.i, %.424.i126.i
  %.432.i.i = fadd contract double %.431.i.i, %.419.i125.i
  store double %.432.i.i, ptr %.418.i124.i, align 8, !noalias !122
  %.535.i.i = getelementptr i8, ptr %arg.room.4, i64 120
  %.536.i.i = load double, ptr %.535.i.i, align 8, !noalias !122
  %.542.i.i = fdiv contract double %.307.i.i, 6.720000e+02
  %.543.i.i = fmul contract double %.33.i, 1.052000e+04
  %.544.i.i = fsub contract double 7.598000e+03, %.543.i.i
  %.545.i.i = fmul contract double %.33.i, %.544.i.i
  %.546.i.i = fsub contract double 2.241500e+04, %.545.i.i
  %.547.i.i = fmul contract double %.33.i, %.546.i.i
  %.548.i.i = fsub contract double 2.771900e+04, %.547.i.i
  %.549.i.i = fmul contract double %.548.i.i, %.542.i.i
  %.550.i.i = fadd contract double %.549.i.i, %.536.i.i
  store double %.550.i.i, ptr %.535.i.i, align 8, !noalias !122
  %.24.i127.i = fmul contract double %.38.i, %.38.i
  %.25.i128.i = fmul contract double %.24.i127.i, %.24.i127.i
  %.26.i129.i = fmul contract double %.25.i128.i, -2.400000e+01
  %.27.i130.i = fmul contract double %.26.i129.i, %.712
  %.81.i133.i = fmul contract double %.38.i, 1.100000e+01
  %.82.i134.i = fsub contract double 1.200000e+01, %.81.i133.i
  %.83.i135.i = fmul contract double %.82.i134.i, %.27.i130.i
  %.84.i136.i = fadd contract double %.83.i135.i, %.84.i.i
  store double %.84.i136.i, ptr %.1867.i.i, align 8, !noalias !125
  %.189.i139.i = fmul contract double %.27.i130.i, 5.000000e+00
  %.193.i140.i = fdiv contract double %.189.i139.i, 6.720000e+02
  %.195.i142.i = fsub contract double 2.286000e+03, %.302.i27.i
  %.196.i143.i = fmul contract double %.38.i, %.195.i142.i
  %.197.i144.i = fadd contract double %.196.i143.i, 9.190000e+02
  %.198.i145.i = fmul contract double %.38.i, %.197.i144.i
  %.199.i146.i = fsub contract double 3.179000e+03, %.198.i145.i
  %.200.i147.i = fmul contract double %.199.i146.i, %.193.i140.i
  %.201.i148.i = fadd contract double %.200.i147.i, %.201.i.i
  store double %.201.i148.i, ptr %.187.i114.i, align 8, !noalias !125
  %.307.i151.i = fmul contract double %.27.i130.i, 0xC00921FB54442D18
  %.310.i152.i = fmul contract double %.82.i134.i, %.307.i151.i
  %.311.i153.i = fadd contract double %.310.i152.i, %.311.i.i
  store double %.311.i153.i, ptr %.304.i120.i, align 8, !noalias !125
  %.363.i154.i = fmul contract double %.38.i, 0x4151712000000000
  %.364.i155.i = fsub contract double 0x41737B1700000000, %.363.i154.i
  %.365.i156.i = fmul contract double %.38.i, %.364.i155.i
  %.366.i157.i = fsub contract double 0x41A2E151D8000000, %.365.i156.i
  %.424.i160.i = fdiv contract double %.189.i139.i, 0x417A29B000000000
  %.425.i161.i = fmul contract double %.38.i, %.366.i157.i
  %.426.i162.i = fadd contract double %.425.i161.i, 0x41A4DB86E0000000
  %.427.i163.i = fmul contract double %.38.i, %.426.i162.i
  %.428.i164.i = fadd contract double %.427.i163.i, 0x41849F27B8000000
  %.429.i165.i = fmul contract double %.38.i, %.428.i164.i
  %.430.i166.i = fsub contract double 0x41B72002EE000000, %.429.i165.i
  %.431.i167.i = fmul contract double %.430.i166.i, %.424.i160.i
  %.432.i168.i = fadd contract double %.431.i167.i, %.432.i.i
  store double %.432.i168.i, ptr %.418.i124.i, align 8, !noalias !125
  %.542.i171.i = fdiv contract double %.307.i151.i, 6.720000e+02
  %.543.i172.i = fmul contract double %.38.i, 1.052000e+04
  %.544.i173.i = fsub contract double 7.598000e+03, %.543.i172.i
  %.545.i174.i = fmul contract double %.38.i, %.544.i173.i
  %.546.i175.i = fsub contract double 2.241500e+04, %.545.i174.i
  %.547.i176.i = fmul contract double %.38.i, %.546.i175.i
  %.548.i177.i = fsub contract double 2.771900e+04, %.547.i176.i
  %.549.i178.i = fmul contract double %.548.i177.i, %.542.i171.i
  %.550.i179.i = fadd contract double %.549.i178.i, %.550.i.i
  store double %.550.i179.i, ptr %.535.i.i, align 8, !noalias !125
  %.671.i8 = fmul contract double %.39.i6, 1.280000e+02
  %.675.i = fdiv contract double 3.000000e+00, %.671.i8
  store double %.675.i, ptr %arg.room.4, align 8, !noalias !101
  %18 = getelementptr i8, ptr %arg.room.4, i64 8
  %.968.1.i = load double, ptr %18, align 8, !noalias !101
  %.970.1.i = fmul contract double %.675.i, %.968.1.i
  store double %.970.1.i, ptr %18, align 8, !noalias !101
  %.970.2.i = fmul contract double %.675.i, %.204.i.i
  store double %.970.2.i, ptr %.183.i.i, align 8, !noalias !101
  %.970.3.i = fmul contract double %.675.i, %.83.i13.i
  store double %.970.3.i, ptr %.308.i.i, align 8, !noalias !101
  %.970.4.i = fmul contract double %.675.i, %16
  store double %.970.4.i, ptr %.413.i.i, align 8, !noalias !101
  %19 = getelementptr i8, ptr %arg.room.4, i64 40
  %.968.5.i = load double, ptr %19, align 8, !noalias !101
  %.970.5.i = fmul contract double %.675.i, %.968.5.i
  store double %.970.5.i, ptr %19, align 8, !noalias !101
  %.970.6.i = fmul contract double %.675.i, %.191.i99.i
  store double %.970.6.i, ptr %.686.i.i, align 8, !noalias !101
  %.970.7.i = fmul contract double %.675.i, %17
  store double %.970.7.i, ptr %.970.i.i, align 8, !noalias !101
  %20 = getelementptr i8, ptr %arg.room.4, i64 64
  %.968.8.i = load double, ptr %20, align 8, !noalias !101
  %.970.8.i = fmul contract double %.675.i, %.968.8.i
  store double %.970.8.i, ptr %20, align 8, !noalias !101
  %.970.9.i = fmul contract double %.675.i, %.1537.i.i
  store double %.970.9.i, ptr %.1461.i.i, align 8, !noalias !101
  %.970.10.i = fmul contract double %.675.i, %.84.i136.i
  store double %.970.10.i, ptr %.1867.i.i, align 8, !noalias !101
  %.970.11.i = fmul contract double %.675.i, %.2371.i.i
  store double %.970.11.i, ptr %.2256.i.i, align 8, !noalias !101
  %.970.12.i = fmul contract double %.675.i, %.201.i148.i
  store double %.970.12.i, ptr %.187.i114.i, align 8, !noalias !101
  %.970.13.i = fmul contract double %.675.i, %.311.i153.i
  store double %.970.13.i, ptr %.304.i120.i, align 8, !noalias !101
  %.970.14.i = fmul contract double %.675.i, %.432.i168.i
  store double %.970.14.i, ptr %.418.i124.i, align 8, !noalias !101
  %.970.15.i = fmul contract double %.675.i, %.550.i179.i
  store double %.970.15.i, ptr %.535.i.i, align 8, !noalias !101
  %.968.1276.i = load double, ptr %5, align 8, !noalias !101
  %.970.1277.i = fmul contract double %.675.i, %.968.1276.i
  store double %.970.1277.i, ptr %5, align 8, !noalias !101
  %21 = getelementptr i8, ptr %arg.room.4, i64 136
  %.968.1.1.i = load double, ptr %21, align 8, !noalias !101
  %.970.1.1.i = fmul contract double %.675.i, %.968.1.1.i
  store double %.970.1.1.i, ptr %21, align 8, !noalias !101
  %22 = getelementptr i8, ptr %arg.room.4, i64 144
  %.968.2.1.i = load double, ptr %22, align 8, !noalias !101
  %.970.2.1.i = fmul contract double %.675.i, %.968.2.1.i
  store double %.970.2.1.i, ptr %22, align 8, !noalias !101
  %23 = getelementptr i8, ptr %arg.room.4, i64 152
  %.968.3.1.i = load double, ptr %23, align 8, !noalias !101
  %.970.3.1.i = fmul contract double %.675.i, %.968.3.1.i
  store double %.970.3.1.i, ptr %23, align 8, !noalias !101
  %24 = getelementptr i8, ptr %arg.room.4, i64 160
  %.968.4.1.i = load double, ptr %24, align 8, !noalias !101
  %.970.4.1.i = fmul contract double %.675.i, %.968.4.1.i
  store double %.970.4.1.i, ptr %24, align 8, !noalias !101
  %.970.5.1.i = fmul contract double %.675.i, %7
  store double %.970.5.1.i, ptr %.561.i.i, align 8, !noalias !101
  %.970.6.1.i = fmul contract double %.675.i, %.867.i.i
  store double %.970.6.1.i, ptr %.865.i.i, align 8, !noalias !101
  %25 = getelementptr i8, ptr %arg.room.4, i64 184
  %.968.7.1.i = load double, ptr %25, align 8, !noalias !101
  %.970.7.1.i = fmul contract double %.675.i, %.968.7.1.i
  store double %.970.7.1.i, ptr %25, align 8, !noalias !101
  %.970.8.1.i = fmul contract double %.675.i, %.1233.i.i
  store double %.970.8.1.i, ptr %.1118.i.i, align 8, !noalias !101
  %.970.9.1.i = fmul contract double %.675.i, %.1642.i.i
  store double %.970.9.1.i, ptr %.1640.i.i, align 8, !noalias !101
  %.970.10.1.i = fmul contract double %.675.i, %.2153.i.i
  store double %.970.10.1.i, ptr %.2145.i.i, align 8, !noalias !101
  %.970.11.1.i = fmul contract double %.675.i, %.2496.i.i
  store double %.970.11.1.i, ptr %.2474.i.i, align 8, !noalias !101
  %26 = getelementptr i8, ptr %arg.room.4, i64 224
  %.968.12.1.i = load double, ptr %26, align 8, !noalias !101
  %.970.12.1.i = fmul contract double %.675.i, %.968.12.1.i
  store double %.970.12.1.i, ptr %26, align 8, !noalias !101
  %27 = getelementptr i8, ptr %arg.room.4, i64 232
  %.968.13.1.i = load double, ptr %27, align 8, !noalias !101
  %.970.13.1.i = fmul contract double %.675.i, %.968.13.1.i
  store double %.970.13.1.i, ptr %27, align 8, !noalias !101
  %28 = getelementptr i8, ptr %arg.room.4, i64 240
  %.968.14.1.i = load double, ptr %28, align 8, !noalias !101
  %.970.14.1.i = fmul contract double %.675.i, %.968.14.1.i
  store double %.970.14.1.i, ptr %28, align 8, !noalias !101
  %29 = getelementptr i8, ptr %arg.room.4, i64 248
  %.968.15.1.i = load double, ptr %29, align 8, !noalias !101
  %.970.15.1.i = fmul contract double %.675.i, %.968.15.1.i
  store double %.970.15.1.i, ptr %29, align 8, !noalias !101
  %30 = getelementptr i8, ptr %arg.room.4, i64 256
  %.968.2278.i = load double, ptr %30, align 8, !noalias !101
  %.970.2279.i = fmul contract double %.675.i, %.968.2278.i
  store double %.970.2279.i, ptr %30, align 8, !noalias !101
  %31 = getelementptr i8, ptr %arg.room.4, i64 264
  %.968.1.2.i = load double, ptr %31, align 8, !noalias !101
  %.970.1.2.i = fmul contract double %.675.i, %.968.1.2.i
  store double %.970.1.2.i, ptr %31, align 8, !noalias !101
  %32 = getelementptr i8, ptr %arg.room.4, i64 272
  %.968.2.2.i = load double, ptr %32, align 8, !noalias !101
  %.970.2.2.i = fmul contract double %.675.i, %.968.2.2.i
  store double %.970.2.2.i, ptr %32, align 8, !noalias !101
  %33 = getelementptr i8, ptr %arg.room.4, i64 280
  %.968.3.2.i = load double, ptr %33, align 8, !noalias !101
  %.970.3.2.i = fmul contract double %.675.i, %.968.3.2.i
  store double %.970.3.2.i, ptr %33, align 8, !noalias !101
  %34 = getelementptr i8, ptr %arg.room.4, i64 288
  %.968.4.2.i = load double, ptr %34, align 8, !noalias !101
  %.970.4.2.i = fmul contract double %.675.i, %.968.4.2.i
  store double %.970.4.2.i, ptr %34, align 8, !noalias !101
  %35 = getelementptr i8, ptr %arg.room.4, i64 296
  %.968.5.2.i = load double, ptr %35, align 8, !noalias !101
  %.970.5.2.i = fmul contract double %.675.i, %.968.5.2.i
  store double %.970.5.2.i, ptr %35, align 8, !noalias !101
  %36 = getelementptr i8, ptr %arg.room.4, i64 304
  %.968.6.2.i = load double, ptr %36, align 8, !noalias !101
  %.970.6.2.i = fmul contract double %.675.i, %.968.6.2.i
  store double %.970.6.2.i, ptr %36, align 8, !noalias !101
  %37 = getelementptr i8, ptr %arg.room.4, i64 312
  %.968.7.2.i = load double, ptr %37, align 8, !noalias !101
  %.970.7.2.i = fmul contract double %.675.i, %.968.7.2.i
  store double %.970.7.2.i, ptr %37, align 8, !noalias !101
  %.970.8.2.i = fmul contract double %.675.i, %.1358.i.i
  store double %.970.8.2.i, ptr %.1336.i.i, align 8, !noalias !101
  %38 = getelementptr i8, ptr %arg.room.4, i64 328
  %.968.9.2.i = load double, ptr %38, align 8, !noalias !101
  %.970.9.2.i = fmul contract double %.675.i, %.968.9.2.i
  store double %.970.9.2.i, ptr %38, align 8, !noalias !101
  %39 = getelementptr i8, ptr %arg.room.4, i64 336
  %.968.10.2.i = load double, ptr %39, align 8, !noalias !101
  %.970.10.2.i = fmul contract double %.675.i, %.968.10.2.i
  store double %.970.10.2.i, ptr %39, align 8, !noalias !101
  %40 = getelementptr i8, ptr %arg.room.4, i64 344
  %.968.11.2.i = load double, ptr %40, align 8, !noalias !101
  %.970.11.2.i = fmul contract double %.675.i, %.968.11.2.i
  store double %.970.11.2.i, ptr %40, align 8, !noalias !101
  %41 = getelementptr i8, ptr %arg.room.4, i64 352
  %.968.12.2.i = load double, ptr %41, align 8, !noalias !101
  %.970.12.2.i = fmul contract double %.675.i, %.968.12.2.i
  store double %.970.12.2.i, ptr %41, align 8, !noalias !101
  %42 = getelementptr i8, ptr %arg.room.4, i64 360
  %.968.13.2.i = load double, ptr %42, align 8, !noalias !101
  %.970.13.2.i = fmul contract double %.675.i, %.968.13.2.i
  store double %.970.13.2.i, ptr %42, align 8, !noalias !101
  %43 = getelementptr i8, ptr %arg.room.4, i64 368
  %.968.14.2.i = load double, ptr %43, align 8, !noalias !101
  %.970.14.2.i = fmul contract double %.675.i, %.968.14.2.i
  store double %.970.14.2.i, ptr %43, align 8, !noalias !101
  %44 = getelementptr i8, ptr %arg.room.4, i64 376
  %.968.15.2.i = load double, ptr %44, align 8, !noalias !101
  %.970.15.2.i = fmul contract double %.675.i, %.968.15.2.i
  store double %.970.15.2.i, ptr %44, align 8, !noalias !101
  %.1069 = getelementptr i8, ptr %arg.out.4, i64 64
  %.69.le.i = tail call contract double @llvm.log.f64(double %.306)
  %.83.i = fmul contract double %.306, %.438
  %.85.i = fmul contract double %.306, %.83.i
  %.89.i = fdiv contract double 1.000000e+00, %.85.i
  %.493.i5 = fmul contract double %.69.le.i, 2.000000e+00
  %scevgep9 = getelementptr i8, ptr %arg.out.4, i64 152
  br label %B154.if.i

B848:                                             ; preds = %_ZN17bnserve_surrogate6kernel7_series17fill_phase_powersB4v195B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dEd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit
  %.1268 = getelementptr i8, ptr %arg.band.4, i64 16
  %.1269 = load double, ptr %.1268, align 8
  %.1270 = fcmp contract ogt double %.1269, 0.000000e+00
  br i1 %.1270, label %B872, label %B944

B872:                                             ; preds = %B848
  %.25.i = fmul contract double %.1269, 0x400921FB54442D18
  %.26.i = tail call contract double @llvm.pow.f64(double %.25.i, double 0x3FD5555555555555)
  %.147.i.i = fmul contract double %.26.i, %.26.i
  %.147.i.1.i = fmul contract double %.147.i.i, %.147.i.i
  %.127.i.2.i = fmul contract double %.26.i, %.147.i.1.i
  %.38.le.i = tail call contract double @llvm.log.f64(double %.26.i)
  %.168.i.i = fcmp une double %.127.i.2.i, 0.000000e+00
  br i1 %.168.i.i, label %B134.if.lr.ph.i, label %_ZN17bnserve_surrogate6kernel7_series8legendreB4v196B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dEd5ArrayIdLi2E1C7mutable7alignedE.exit, !prof !0

B134.if.lr.ph.i:                                  ; preds = %B872
  %.175.i.i = fdiv contract double 1.000000e+00, %.127.i.2.i
  %.423.i = fmul contract double %.38.le.i, 2.000000e+00
  br label %B134.if.i

B134.if.i:                                        ; preds = %B134.if.i, %B134.if.lr.ph.i
  %lsr.iv1 = phi i64 [ %lsr.iv.next2, %B134.if.i ], [ -16, %B134.if.lr.ph.i ]
  %power.2.0146.i = phi double [ %.493.i, %B134.if.i ], [ %.175.i.i, %B134.if.lr.ph.i ]
  %result.2.0145.i = phi double [ %.488.i, %B134.if.i ], [ 0.000000e+00, %B134.if.lr.ph.i ]
  %45 = add nsw i64 %lsr.iv1, 11
  %sunkaddr = shl i64 %lsr.iv1, 3
  %sunkaddr18 = getelementptr i8, ptr %arg.room.4, i64 %sunkaddr
  %sunkaddr19 = getelementptr i8, ptr %sunkaddr18, i64 128
  %.249.i = load double, ptr %sunkaddr19, align 8, !noalias !128
  %sunkaddr22 = getelementptr i8, ptr %sunkaddr18, i64 256
  %.303.i = load double, ptr %sunkaddr22, align 8, !noalias !128
  %sunkaddr25 = getelementptr i8, ptr %sunkaddr18, i64 384
  %.357.i = load double, ptr %sunkaddr25, align 8, !noalias !128
  %.359.i = fmul contract double %.38.le.i, %.357.i
  %.360.i = fadd contract double %.303.i, %.359.i
  %.362.i = fmul contract double %.38.le.i, %.360.i
  %.363.i = fadd contract double %.249.i, %.362.i
  %.365.i = sitofp i64 %45 to double
  %.366.i = fmul contract double %.363.i, %.365.i
  %.421.i = fadd contract double %.303.i, %.366.i
  %.478.i = fmul contract double %.423.i, %.357.i
  %.479.i = fadd contract double %.478.i, %.421.i
  %.483.i = fdiv contract double %.479.i, 3.000000e+00
  %.484.i = fsub contract double %.363.i, %.483.i
  %.486.i = fmul contract double %power.2.0146.i, %.484.i
  %.488.i = fadd contract double %result.2.0145.i, %.486.i
  %.493.i = fmul contract double %.26.i, %power.2.0146.i
  %ov = icmp eq i64 %lsr.iv1, -1
  %lsr.iv.next2 = add nsw i64 %lsr.iv1, 1
  br i1 %ov, label %_ZN17bnserve_surrogate6kernel7_series8legendreB4v196B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dEd5ArrayIdLi2E1C7mutable7alignedE.exit, label %B134.if.i

_ZN17bnserve_surrogate6kernel7_series8legendreB4v196B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dEd5ArrayIdLi2E1C7mutable7alignedE.exit: ; preds = %B134.if.i, %B872
  %.1339.0 = phi double [ 0.000000e+00, %B872 ], [ %.488.i, %B134.if.i ]
  %excinfo.7.0 = phi ptr [ null, %B872 ], [ null, %B134.if.i ]
  br i1 %.168.i.i, label %B872.endif, label %B872.if, !prof !0

B944:                                             ; preds = %B872.endif, %_ZN17bnserve_surrogate6kernel7_series17fill_phase_powersB4v195B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dEd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit, %B848
  %.1447 = getelementptr i8, ptr %arg.row.4, i64 72
  %.1448 = load double, ptr %.1447, align 8
  %.1454 = fmul contract double %.1448, 0x401921FB54442D18
  %.1456 = fmul contract double %.206, 0x3ED4A8B4A9ED04E3
  %.1463 = fdiv contract double %arg.unit, %.1456
  %.1464 = fmul contract double %.1463, %.1454
  %46 = getelementptr i8, ptr %49, i64 8
  %.1498 = getelementptr double, ptr %46, i64 %.1190
  %.1499 = load double, ptr %.1498, align 8
  %.1506 = fmul contract double %arg.unit, %.1499
  %.1509 = fsub contract double %.1464, %.1506
  %sunkaddr27 = getelementptr i8, ptr %arg.out.4, i64 264
  store double %.1509, ptr %sunkaddr27, align 8
  %.1546 = fmul contract double %.373, 2.000000e+01
  store double %.1546, ptr %retptr, align 8
  br label %common.ret

common.ret:                                       ; preds = %B872.if, %B944
  %common.ret.op = phi i32 [ 0, %B944 ], [ 1, %B872.if ]
  ret i32 %common.ret.op

B278.i:                                           ; preds = %B154.if.i
  %.491.i = load double, ptr %sunkaddr38, align 8, !noalias !132
  %.548.i = load double, ptr %sunkaddr41, align 8, !noalias !132
  %.549.i = fmul contract double %.493.i5, %.548.i
  %.550.i = fadd contract double %.491.i, %.549.i
  %.552.i = fmul contract double %power.2.0232.i, %.550.i
  %.556.i = fdiv contract double %.552.i, 3.000000e+00
  %scevgep10 = getelementptr i8, ptr %scevgep9, i64 %sunkaddr34
  store double %.556.i, ptr %scevgep10, align 8, !noalias !132
  br label %B356.i

B356.i:                                           ; preds = %B154.if.i, %B278.i
  %.596.i = fmul contract double %.306, %power.2.0232.i
  %lsr.iv.next = add nuw nsw i64 %lsr.iv, 1
  %exitcond.not.i10 = icmp eq i64 %lsr.iv.next, 16
  br i1 %exitcond.not.i10, label %_ZN17bnserve_surrogate6kernel7_series17fill_phase_powersB4v195B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dEd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit, label %B154.if.i

B154.if.i:                                        ; preds = %B356.i, %entry
  %lsr.iv = phi i64 [ %lsr.iv.next, %B356.i ], [ 0, %entry ]
  %power.2.0232.i = phi double [ %.596.i, %B356.i ], [ %.89.i, %entry ]
  %47 = add nsw i64 %lsr.iv, -5
  %sunkaddr34 = shl i64 %lsr.iv, 3
  %sunkaddr35 = getelementptr i8, ptr %arg.room.4, i64 %sunkaddr34
  %.269.i = load double, ptr %sunkaddr35, align 8, !noalias !132
  %sunkaddr38 = getelementptr i8, ptr %sunkaddr35, i64 128
  %.324.i = load double, ptr %sunkaddr38, align 8, !noalias !132
  %sunkaddr41 = getelementptr i8, ptr %sunkaddr35, i64 256
  %.379.i = load double, ptr %sunkaddr41, align 8, !noalias !132
  %.381.i = fmul contract double %.69.le.i, %.379.i
  %.382.i = fadd contract double %.324.i, %.381.i
  %.384.i = fmul contract double %.69.le.i, %.382.i
  %.385.i = fadd contract double %.269.i, %.384.i
  %.387.i = fmul contract double %power.2.0232.i, %.385.i
  %scevgep11 = getelementptr i8, ptr %.1069, i64 %sunkaddr34
  store double %.387.i, ptr %scevgep11, align 8, !noalias !132
  %or.cond.i = icmp ult i64 %47, 7
  br i1 %or.cond.i, label %B278.i, label %B356.i

_ZN17bnserve_surrogate6kernel7_series17fill_phase_powersB4v195B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dEd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit: ; preds = %B356.i
  %.672.i = load double, ptr %.1336.i.i, align 8, !noalias !132
  %.680.i = fmul contract double %.305, %.672.i
  %.684.i = fdiv contract double %.680.i, 9.000000e+00
  %sunkaddr43 = getelementptr i8, ptr %arg.out.4, i64 248
  store double %.684.i, ptr %sunkaddr43, align 8, !noalias !132
  %.1172 = getelementptr i8, ptr %arg.row.4, i64 64
  %.1173 = load double, ptr %.1172, align 8
  %48 = lshr i64 %arg.alignment, 61
  %.1190 = and i64 %48, 4
  %.idx = shl i64 %arg.alignment, 4
  %49 = getelementptr i8, ptr %arg.gauge.4, i64 %.idx
  %.1204 = getelementptr double, ptr %49, i64 %.1190
  %.1205 = load double, ptr %.1204, align 8
  %.1206 = fsub contract double %.1173, %.1205
  %sunkaddr45 = getelementptr i8, ptr %arg.out.4, i64 256
  store double %.1206, ptr %sunkaddr45, align 8
  %.1238 = icmp eq i64 %arg.alignment, 1
  br i1 %.1238, label %B848, label %B944

B872.if:                                          ; preds = %_ZN17bnserve_surrogate6kernel7_series8legendreB4v196B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dEd5ArrayIdLi2E1C7mutable7alignedE.exit
  store ptr %excinfo.7.0, ptr %excinfo, align 8
  br label %common.ret

B872.endif:                                       ; preds = %_ZN17bnserve_surrogate6kernel7_series8legendreB4v196B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dEd5ArrayIdLi2E1C7mutable7alignedE.exit
  %.1374 = fadd contract double %.1206, %.1339.0
  store double %.1374, ptr %sunkaddr45, align 8
  br label %B944
}

; Function Attrs: nofree noinline norecurse nosync nounwind memory(argmem: readwrite)
define internal fastcc void @inner_12(ptr noalias nonnull writeonly captures(none) %retptr, ptr readonly captures(none) %arg.f.4, ptr readonly captures(none) %arg.cbrt_f.4, ptr readonly captures(none) %arg.power.4, i64 range(i64 0, -9223372036854775808) %arg.segments.0, i64 range(i64 0, -9223372036854775808) %arg.segments.1, i64 %arg.segments.2, double %arg.mass, ptr readonly captures(none) %arg.c.4, double %arg.constant, ptr readonly captures(none) %arg.residuals.4, ptr writeonly captures(none) %arg.out.4) unnamed_addr #6 {
entry:
  %.129 = load double, ptr %arg.c.4, align 8
  %.157 = getelementptr i8, ptr %arg.c.4, i64 8
  %.158 = load double, ptr %.157, align 8
  %.186 = getelementptr i8, ptr %arg.c.4, i64 16
  %.187 = load double, ptr %.186, align 8
  %.215 = getelementptr i8, ptr %arg.c.4, i64 24
  %.216 = load double, ptr %.215, align 8
  %.244 = getelementptr i8, ptr %arg.c.4, i64 32
  %.245 = load double, ptr %.244, align 8
  %.273 = getelementptr i8, ptr %arg.c.4, i64 40
  %.274 = load double, ptr %.273, align 8
  %.302 = getelementptr i8, ptr %arg.c.4, i64 48
  %.303 = load double, ptr %.302, align 8
  %.331 = getelementptr i8, ptr %arg.c.4, i64 56
  %.332 = load double, ptr %.331, align 8
  %0 = add nuw i64 %arg.segments.0, 7
  %.490 = lshr i64 %0, 3
  %.511530.not578 = icmp eq i64 %.490, 0
  br i1 %.511530.not578, label %B604, label %B194.if.lr.ph

B194.if.lr.ph:                                    ; preds = %entry
  %.560 = insertelement <8 x double> poison, double %.332, i64 0
  %.561 = shufflevector <8 x double> %.560, <8 x double> poison, <8 x i32> zeroinitializer
  %.563 = insertelement <8 x double> poison, double %.303, i64 0
  %.564 = shufflevector <8 x double> %.563, <8 x double> poison, <8 x i32> zeroinitializer
  %.567 = insertelement <8 x double> poison, double %.274, i64 0
  %.568 = shufflevector <8 x double> %.567, <8 x double> poison, <8 x i32> zeroinitializer
  %.571 = insertelement <8 x double> poison, double %.245, i64 0
  %.572 = shufflevector <8 x double> %.571, <8 x double> poison, <8 x i32> zeroinitializer
  %.575 = insertelement <8 x double> poison, double %.216, i64 0
  %.576 = shufflevector <8 x double> %.575, <8 x double> poison, <8 x i32> zeroinitializer
  %.579 = insertelement <8 x double> poison, double %.187, i64 0
  %.580 = shufflevector <8 x double> %.579, <8 x double> poison, <8 x i32> zeroinitializer
  %.583 = insertelement <8 x double> poison, double %.158, i64 0
  %.584 = shufflevector <8 x double> %.583, <8 x double> poison, <8 x i32> zeroinitializer
  %.587 = insertelement <8 x double> poison, double %.129, i64 0
  %.588 = shufflevector <8 x double> %.587, <8 x double> poison, <8 x i32> zeroinitializer
  %1 = add nuw nsw i64 %.490, 6
  br label %B194.if

B604:                                             ; preds = %B194.if, %entry
  %.909 = sub nsw i64 %arg.segments.1, %arg.segments.0
  %2 = add i64 %.909, 7
  %.931 = lshr i64 %2, 3
  %.910.inv = icmp slt i64 %.909, 1
  %.952554.not579 = icmp eq i64 %.931, 0
  %.952554.not = or i1 %.910.inv, %.952554.not579
  br i1 %.952554.not, label %B1288, label %B648.if.lr.ph

B648.if.lr.ph:                                    ; preds = %B604
  %.1001 = insertelement <8 x double> poison, double %.332, i64 0
  %.1002 = shufflevector <8 x double> %.1001, <8 x double> poison, <8 x i32> zeroinitializer
  %.1004 = insertelement <8 x double> poison, double %.303, i64 0
  %.1005 = shufflevector <8 x double> %.1004, <8 x double> poison, <8 x i32> zeroinitializer
  %.1008 = insertelement <8 x double> poison, double %.274, i64 0
  %.1009 = shufflevector <8 x double> %.1008, <8 x double> poison, <8 x i32> zeroinitializer
  %.1012 = insertelement <8 x double> poison, double %.245, i64 0
  %.1013 = shufflevector <8 x double> %.1012, <8 x double> poison, <8 x i32> zeroinitializer
  %.1016 = insertelement <8 x double> poison, double %.216, i64 0
  %.1017 = shufflevector <8 x double> %.1016, <8 x double> poison, <8 x i32> zeroinitializer
  %.1020 = insertelement <8 x double> poison, double %.187, i64 0
  %.1021 = shufflevector <8 x double> %.1020, <8 x double> poison, <8 x i32> zeroinitializer
  %.1024 = insertelement <8 x double> poison, double %.158, i64 0
  %.1025 = shufflevector <8 x double> %.1024, <8 x double> poison, <8 x i32> zeroinitializer
  %.1028 = insertelement <8 x double> poison, double %.129, i64 0
  %.1029 = shufflevector <8 x double> %.1028, <8 x double> poison, <8 x i32> zeroinitializer
  %.1080 = fdiv contract double %arg.mass, 1.000000e-02
  %.1087 = insertelement <8 x double> poison, double %.1080, i64 0
  %.1088 = shufflevector <8 x double> %.1087, <8 x double> poison, <8 x i32> zeroinitializer
  %.1324 = insertelement <8 x double> poison, double %arg.constant, i64 0
  %.1325 = shufflevector <8 x double> %.1324, <8 x double> poison, <8 x i32> zeroinitializer
  %3 = shl i64 %arg.segments.0, 3
  %4 = add nuw nsw i64 %.931, 6
  br label %B648.if

B1288:                                            ; preds = %B648.if, %B604
  %.1465 = sub i64 %arg.segments.2, %arg.segments.1
  %5 = add i64 %.1465, 7
  %.1487 = lshr i64 %5, 3
  %.1466.inv = icmp slt i64 %.1465, 1
  %.1508573.not699 = icmp eq i64 %.1487, 0
  %.1508573.not = or i1 %.1466.inv, %.1508573.not699
  br i1 %.1508573.not, label %B1432, label %B1332.if.preheader

B1332.if.preheader:                               ; preds = %B1288
  %.6.i141 = insertelement <8 x double> poison, double %arg.constant, i64 0
  %.7.i = shufflevector <8 x double> %.6.i141, <8 x double> poison, <8 x i32> zeroinitializer
  %6 = shl i64 %arg.segments.1, 3
  %7 = add nuw nsw i64 %.1487, 6
  br label %B1332.if

B1432:                                            ; preds = %B1332.if, %B1288
  store ptr null, ptr %retptr, align 8
  ret void

B194.if:                                          ; preds = %B194.if, %B194.if.lr.ph
  %lsr.iv4 = phi i64 [ %lsr.iv.next5, %B194.if ], [ %1, %B194.if.lr.ph ]
  %lsr.iv157 = phi i64 [ %lsr.iv.next158, %B194.if ], [ 0, %B194.if.lr.ph ]
  %scevgep162 = getelementptr i8, ptr %arg.cbrt_f.4, i64 %lsr.iv157
  %.558 = load <8 x double>, ptr %scevgep162, align 8
  %.565 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.558, <8 x double> %.561, <8 x double> %.564)
  %.569 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.558, <8 x double> %.565, <8 x double> %.568)
  %.573 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.558, <8 x double> %.569, <8 x double> %.572)
  %.577 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.558, <8 x double> %.573, <8 x double> %.576)
  %.581 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.558, <8 x double> %.577, <8 x double> %.580)
  %.585 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.558, <8 x double> %.581, <8 x double> %.584)
  %.589 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.558, <8 x double> %.585, <8 x double> %.588)
  %scevgep161 = getelementptr i8, ptr %arg.power.4, i64 %lsr.iv157
  %.599 = load <8 x double>, ptr %scevgep161, align 8
  %.6.i = fmul contract <8 x double> %.599, %.589
  %scevgep160 = getelementptr i8, ptr %arg.residuals.4, i64 %lsr.iv157
  %.634 = load <8 x double>, ptr %scevgep160, align 8
  %.639 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.634, <8 x double> splat (double 0x3FF71547652B82FE), <8 x double> splat (double 0x4338000000000000))
  %.8.i = fadd contract <8 x double> %.639, splat (double 0xC338000000000000)
  %.668 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i, <8 x double> splat (double 0xBFE62E42FEFA39EF), <8 x double> %.634)
  %.671 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i, <8 x double> splat (double 0xBC7ABC9E3B39803F), <8 x double> %.668)
  %.676 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.671, <8 x double> splat (double 0x3DE6124613A86D09), <8 x double> splat (double 0x3E21EED8EFF8D898))
  %.679 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.671, <8 x double> %.676, <8 x double> splat (double 0x3E5AE64567F544E4))
  %.682 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.671, <8 x double> %.679, <8 x double> splat (double 0x3E927E4FB7789F5C))
  %.685 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.671, <8 x double> %.682, <8 x double> splat (double 0x3EC71DE3A556C734))
  %.688 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.671, <8 x double> %.685, <8 x double> splat (double 0x3EFA01A01A01A01A))
  %.691 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.671, <8 x double> %.688, <8 x double> splat (double 0x3F2A01A01A01A01A))
  %.694 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.671, <8 x double> %.691, <8 x double> splat (double 0x3F56C16C16C16C17))
  %.697 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.671, <8 x double> %.694, <8 x double> splat (double 0x3F81111111111111))
  %.700 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.671, <8 x double> %.697, <8 x double> splat (double 0x3FA5555555555555))
  %.703 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.671, <8 x double> %.700, <8 x double> splat (double 0x3FC5555555555555))
  %.706 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.671, <8 x double> %.703, <8 x double> splat (double 5.000000e-01))
  %.6.i120 = fmul contract <8 x double> %.671, %.671
  %.8.i121 = fadd contract <8 x double> %.671, splat (double 1.000000e+00)
  %.755 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i120, <8 x double> %.706, <8 x double> %.8.i121)
  %.756 = bitcast <8 x double> %.639 to <8 x i64>
  %.8.i122 = shl <8 x i64> %.756, splat (i64 52)
  %.8.i123 = add <8 x i64> %.8.i122, splat (i64 4607182418800017408)
  %8 = bitcast <8 x i64> %.8.i123 to <8 x double>
  %.6.i124 = fmul contract <8 x double> %.755, %8
  %.6.i125 = fmul contract <8 x double> %.6.i, %.6.i124
  %scevgep159 = getelementptr i8, ptr %arg.out.4, i64 %lsr.iv157
  store <8 x double> %.6.i125, ptr %scevgep159, align 8
  %lsr.iv.next158 = add i64 %lsr.iv157, 64
  %lsr.iv.next5 = add nsw i64 %lsr.iv4, -1
  %.511 = icmp sgt i64 %lsr.iv4, 7
  br i1 %.511, label %B194.if, label %B604

B648.if:                                          ; preds = %B648.if, %B648.if.lr.ph
  %lsr.iv = phi i64 [ %lsr.iv.next, %B648.if ], [ %4, %B648.if.lr.ph ]
  %lsr.iv148 = phi i64 [ %lsr.iv.next149, %B648.if ], [ %3, %B648.if.lr.ph ]
  %scevgep154 = getelementptr i8, ptr %arg.cbrt_f.4, i64 %lsr.iv148
  %.999 = load <8 x double>, ptr %scevgep154, align 8
  %.1006 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.999, <8 x double> %.1002, <8 x double> %.1005)
  %.1010 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.999, <8 x double> %.1006, <8 x double> %.1009)
  %.1014 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.999, <8 x double> %.1010, <8 x double> %.1013)
  %.1018 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.999, <8 x double> %.1014, <8 x double> %.1017)
  %.1022 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.999, <8 x double> %.1018, <8 x double> %.1021)
  %.1026 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.999, <8 x double> %.1022, <8 x double> %.1025)
  %.1030 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.999, <8 x double> %.1026, <8 x double> %.1029)
  %scevgep153 = getelementptr i8, ptr %arg.power.4, i64 %lsr.iv148
  %.1040 = load <8 x double>, ptr %scevgep153, align 8
  %.6.i126 = fmul contract <8 x double> %.1040, %.1030
  %scevgep152 = getelementptr i8, ptr %arg.f.4, i64 %lsr.iv148
  %.1074 = load <8 x double>, ptr %scevgep152, align 8
  %.1091 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1074, <8 x double> %.1088, <8 x double> splat (double -1.000000e+00))
  %scevgep151 = getelementptr i8, ptr %arg.residuals.4, i64 %lsr.iv148
  %.1102 = load <8 x double>, ptr %scevgep151, align 8
  %.1107 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1102, <8 x double> splat (double 0x3FF71547652B82FE), <8 x double> splat (double 0x4338000000000000))
  %.8.i127 = fadd contract <8 x double> %.1107, splat (double 0xC338000000000000)
  %.1136 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i127, <8 x double> splat (double 0xBFE62E42FEFA39EF), <8 x double> %.1102)
  %.1139 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i127, <8 x double> splat (double 0xBC7ABC9E3B39803F), <8 x double> %.1136)
  %.1144 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1139, <8 x double> splat (double 0x3DE6124613A86D09), <8 x double> splat (double 0x3E21EED8EFF8D898))
  %.1147 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1139, <8 x double> %.1144, <8 x double> splat (double 0x3E5AE64567F544E4))
  %.1150 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1139, <8 x double> %.1147, <8 x double> splat (double 0x3E927E4FB7789F5C))
  %.1153 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1139, <8 x double> %.1150, <8 x double> splat (double 0x3EC71DE3A556C734))
  %.1156 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1139, <8 x double> %.1153, <8 x double> splat (double 0x3EFA01A01A01A01A))
  %.1159 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1139, <8 x double> %.1156, <8 x double> splat (double 0x3F2A01A01A01A01A))
  %.1162 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1139, <8 x double> %.1159, <8 x double> splat (double 0x3F56C16C16C16C17))
  %.1165 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1139, <8 x double> %.1162, <8 x double> splat (double 0x3F81111111111111))
  %.1168 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1139, <8 x double> %.1165, <8 x double> splat (double 0x3FA5555555555555))
  %.1171 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1139, <8 x double> %.1168, <8 x double> splat (double 0x3FC5555555555555))
  %.1174 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1139, <8 x double> %.1171, <8 x double> splat (double 5.000000e-01))
  %.6.i128 = fmul contract <8 x double> %.1139, %.1139
  %.8.i129 = fadd contract <8 x double> %.1139, splat (double 1.000000e+00)
  %.1223 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i128, <8 x double> %.1174, <8 x double> %.8.i129)
  %.1224 = bitcast <8 x double> %.1107 to <8 x i64>
  %.8.i130 = shl <8 x i64> %.1224, splat (i64 52)
  %.8.i131 = add <8 x i64> %.8.i130, splat (i64 4607182418800017408)
  %9 = bitcast <8 x i64> %.8.i131 to <8 x double>
  %.6.i132 = fmul contract <8 x double> %.1223, %9
  %.8.i.i = fmul contract <8 x double> %.1091, splat (double 0x400921FB54442D18)
  %.36.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i.i, <8 x double> splat (double 0x3FE45F306DC9C883), <8 x double> splat (double 0x4338000000000000))
  %.8.i1.i = fadd contract <8 x double> %.36.i, splat (double 0xC338000000000000)
  %.77.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i1.i, <8 x double> splat (double 0xBFF921FB54442D18), <8 x double> %.8.i.i)
  %.94.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i1.i, <8 x double> splat (double 0xBC91A62633145C07), <8 x double> %.77.i)
  %.6.i.i = fmul contract <8 x double> %.94.i, %.94.i
  %.6.i2.i = fmul contract <8 x double> %.94.i, %.6.i.i
  %.123.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i, <8 x double> splat (double 0xBD6AE7F3E733B81F), <8 x double> splat (double 0x3DE6124613A86D09))
  %.126.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i, <8 x double> %.123.i, <8 x double> splat (double 0xBE5AE64567F544E4))
  %.129.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i, <8 x double> %.126.i, <8 x double> splat (double 0x3EC71DE3A556C734))
  %.132.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i, <8 x double> %.129.i, <8 x double> splat (double 0xBF2A01A01A01A01A))
  %.135.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i, <8 x double> %.132.i, <8 x double> splat (double 0x3F81111111111111))
  %.138.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i, <8 x double> %.135.i, <8 x double> splat (double 0xBFC5555555555555))
  %.163.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i2.i, <8 x double> %.138.i, <8 x double> %.94.i)
  %.168.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i, <8 x double> splat (double 0x3D2AE7F3E733B81F), <8 x double> splat (double 0xBDA93974A8C07C9D))
  %.171.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i, <8 x double> %.168.i, <8 x double> splat (double 0x3E21EED8EFF8D898))
  %.174.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i, <8 x double> %.171.i, <8 x double> splat (double 0xBE927E4FB7789F5C))
  %.177.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i, <8 x double> %.174.i, <8 x double> splat (double 0x3EFA01A01A01A01A))
  %.180.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i, <8 x double> %.177.i, <8 x double> splat (double 0xBF56C16C16C16C17))
  %.183.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i, <8 x double> %.180.i, <8 x double> splat (double 0x3FA5555555555555))
  %.186.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i, <8 x double> %.183.i, <8 x double> splat (double -5.000000e-01))
  %.189.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i, <8 x double> %.186.i, <8 x double> splat (double 1.000000e+00))
  %.190.i = bitcast <8 x double> %.36.i to <8 x i64>
  %.8.i4.i = and <8 x i64> %.190.i, splat (i64 1)
  %10 = icmp eq <8 x i64> %.8.i4.i, zeroinitializer
  %.8.i9.i = shl <8 x i64> %.190.i, splat (i64 62)
  %.8.i10.i = add <8 x i64> %.8.i9.i, splat (i64 4611686018427387904)
  %.8.i11.i = and <8 x i64> %.8.i10.i, splat (i64 -9223372036854775808)
  %.6.i14.v.i = select <8 x i1> %10, <8 x double> %.189.i, <8 x double> %.163.i
  %.6.i14.i = bitcast <8 x double> %.6.i14.v.i to <8 x i64>
  %.6.i15.i = xor <8 x i64> %.8.i11.i, %.6.i14.i
  %11 = bitcast <8 x i64> %.6.i15.i to <8 x double>
  %.526.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %11, <8 x double> splat (double -5.000000e-01), <8 x double> splat (double 5.000000e-01))
  %.6.i133 = fsub contract <8 x double> %.1325, %.6.i126
  %.1350 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.526.i, <8 x double> %.6.i133, <8 x double> %.6.i126)
  %.6.i134 = fmul contract <8 x double> %.6.i132, %.1350
  %scevgep150 = getelementptr i8, ptr %arg.out.4, i64 %lsr.iv148
  store <8 x double> %.6.i134, ptr %scevgep150, align 8
  %lsr.iv.next149 = add i64 %lsr.iv148, 64
  %lsr.iv.next = add nsw i64 %lsr.iv, -1
  %.952 = icmp sgt i64 %lsr.iv, 7
  br i1 %.952, label %B648.if, label %B1288

B1332.if:                                         ; preds = %B1332.if, %B1332.if.preheader
  %lsr.iv2 = phi i64 [ %lsr.iv.next3, %B1332.if ], [ %7, %B1332.if.preheader ]
  %lsr.iv143 = phi i64 [ %lsr.iv.next144, %B1332.if ], [ %6, %B1332.if.preheader ]
  %scevgep145 = getelementptr i8, ptr %arg.residuals.4, i64 %lsr.iv143
  %.1556 = load <8 x double>, ptr %scevgep145, align 8
  %.1561 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1556, <8 x double> splat (double 0x3FF71547652B82FE), <8 x double> splat (double 0x4338000000000000))
  %.8.i135 = fadd contract <8 x double> %.1561, splat (double 0xC338000000000000)
  %.1590 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i135, <8 x double> splat (double 0xBFE62E42FEFA39EF), <8 x double> %.1556)
  %.1593 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i135, <8 x double> splat (double 0xBC7ABC9E3B39803F), <8 x double> %.1590)
  %.1598 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1593, <8 x double> splat (double 0x3DE6124613A86D09), <8 x double> splat (double 0x3E21EED8EFF8D898))
  %.1601 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1593, <8 x double> %.1598, <8 x double> splat (double 0x3E5AE64567F544E4))
  %.1604 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1593, <8 x double> %.1601, <8 x double> splat (double 0x3E927E4FB7789F5C))
  %.1607 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1593, <8 x double> %.1604, <8 x double> splat (double 0x3EC71DE3A556C734))
  %.1610 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1593, <8 x double> %.1607, <8 x double> splat (double 0x3EFA01A01A01A01A))
  %.1613 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1593, <8 x double> %.1610, <8 x double> splat (double 0x3F2A01A01A01A01A))
  %.1616 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1593, <8 x double> %.1613, <8 x double> splat (double 0x3F56C16C16C16C17))
  %.1619 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1593, <8 x double> %.1616, <8 x double> splat (double 0x3F81111111111111))
  %.1622 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1593, <8 x double> %.1619, <8 x double> splat (double 0x3FA5555555555555))
  %.1625 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1593, <8 x double> %.1622, <8 x double> splat (double 0x3FC5555555555555))
  %.1628 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1593, <8 x double> %.1625, <8 x double> splat (double 5.000000e-01))
  %.6.i136 = fmul contract <8 x double> %.1593, %.1593
  %.8.i137 = fadd contract <8 x double> %.1593, splat (double 1.000000e+00)
  %.1677 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i136, <8 x double> %.1628, <8 x double> %.8.i137)
  %.1678 = bitcast <8 x double> %.1561 to <8 x i64>
  %.8.i138 = shl <8 x i64> %.1678, splat (i64 52)
  %.8.i139 = add <8 x i64> %.8.i138, splat (i64 4607182418800017408)
  %12 = bitcast <8 x i64> %.8.i139 to <8 x double>
  %.6.i140 = fmul contract <8 x double> %.1677, %12
  %.8.i142 = fmul contract <8 x double> %.7.i, %.6.i140
  %scevgep = getelementptr i8, ptr %arg.out.4, i64 %lsr.iv143
  store <8 x double> %.8.i142, ptr %scevgep, align 8
  %lsr.iv.next144 = add i64 %lsr.iv143, 64
  %lsr.iv.next3 = add nsw i64 %lsr.iv2, -1
  %.1508 = icmp sgt i64 %lsr.iv2, 7
  br i1 %.1508, label %B1332.if, label %B1432
}

; Function Attrs: nofree noinline norecurse nosync nounwind memory(readwrite, inaccessiblemem: none, target_mem0: none, target_mem1: none)
define internal fastcc void @inner_13(ptr noalias nonnull writeonly captures(none) %retptr, i64 %arg.i, i64 %arg.start, i64 %arg.inside, i64 range(i64 -9223372036854774784, -9223372036854775808) %arg.stop, ptr readonly captures(none) %arg.arguments.4, ptr readonly captures(none) %arg.amplitude.4, ptr readonly captures(none) %arg.phase.4, double %arg.factors.0, double %arg.factors.1, ptr captures(none) %arg.tail.4) unnamed_addr #4 {
entry:
  %.1158 = alloca ptr, align 8
  store ptr null, ptr %.1158, align 8
  %.1221 = alloca ptr, align 8
  store ptr null, ptr %.1221, align 8
  %.1475 = alloca ptr, align 8
  store ptr null, ptr %.1475, align 8
  %.1540 = alloca ptr, align 8
  store ptr null, ptr %.1540, align 8
  %.106 = getelementptr i8, ptr %arg.arguments.4, i64 112
  %.107 = load i64, ptr %.106, align 8
  %.136 = getelementptr i8, ptr %arg.arguments.4, i64 120
  %.137 = load i64, ptr %.136, align 8
  %.166 = getelementptr i8, ptr %arg.arguments.4, i64 128
  %.167 = load i64, ptr %.166, align 8
  %.205 = getelementptr i8, ptr %arg.arguments.4, i64 16
  %.206 = load i64, ptr %.205, align 8
  %.207 = mul nsw i64 %.206, %arg.i
  %.209 = add nsw i64 %.207, %arg.start
  switch i64 %.107, label %B882 [
    i64 4, label %B192
    i64 3, label %B504
    i64 1, label %B504
  ]

B192:                                             ; preds = %entry
  %.234 = shl nsw i64 %.209, 3
  %.236 = add nsw i64 %.234, %.137
  %.241 = sub nsw i64 %arg.stop, %arg.start
  %.298 = add nsw i64 %.234, %.167
  %.372 = sub nsw i64 %arg.inside, %arg.start
  %.452814.not = icmp slt i64 %.372, 1
  br i1 %.452814.not, label %B378, label %B328.if.preheader

B328.if.preheader:                                ; preds = %B192
  %.neg = add i64 %arg.start, 1
  %0 = icmp eq i64 %arg.inside, %.neg
  br i1 %0, label %B328.if.epil.preheader, label %B328.if.preheader.new

B328.if.preheader.new:                            ; preds = %B328.if.preheader
  %1 = add nsw i64 %.372, -2
  %2 = lshr i64 %1, 1
  %3 = icmp eq i64 %2, 0
  br i1 %3, label %B328.if.epil.preheader1, label %B328.if.preheader.new.new

B328.if.preheader.new.new:                        ; preds = %B328.if.preheader.new
  %4 = add nuw i64 %2, 1
  %5 = inttoptr i64 %.236 to ptr
  %6 = inttoptr i64 %.298 to ptr
  %scevgep29 = getelementptr i8, ptr %5, i64 24
  %scevgep44 = getelementptr i8, ptr %6, i64 24
  %7 = lshr i64 %4, 1
  %8 = mul nsw i64 %7, -2
  br label %B328.if

B378.loopexit.unr-lcssa.unr-lcssa:                ; preds = %B328.if
  %9 = and i64 %1, 2
  %lcmp.mod.not11.not = icmp eq i64 %9, 0
  br i1 %lcmp.mod.not11.not, label %B328.if.epil.preheader1, label %B378.loopexit.unr-lcssa

B328.if.epil.preheader1:                          ; preds = %B378.loopexit.unr-lcssa.unr-lcssa, %B328.if.preheader.new
  %.458813815.epil.init4 = phi i64 [ 0, %B328.if.preheader.new ], [ %.465.1.1, %B378.loopexit.unr-lcssa.unr-lcssa ]
  %10 = shl i64 %.458813815.epil.init4, 3
  %sunkaddr141.epil = getelementptr i8, ptr %arg.amplitude.4, i64 %10
  %.519.epil2 = load double, ptr %sunkaddr141.epil, align 8
  %sunkaddr = inttoptr i64 %.236 to ptr
  %sunkaddr53 = getelementptr i8, ptr %sunkaddr, i64 %10
  store double %.519.epil2, ptr %sunkaddr53, align 8
  %sunkaddr143.epil = getelementptr i8, ptr %arg.phase.4, i64 %10
  %.579.epil3 = load double, ptr %sunkaddr143.epil, align 8
  %sunkaddr54 = inttoptr i64 %.298 to ptr
  %sunkaddr56 = getelementptr i8, ptr %sunkaddr54, i64 %10
  store double %.579.epil3, ptr %sunkaddr56, align 8
  %.465.1.epil = add nuw i64 %.458813815.epil.init4, 2
  %sunkaddr146.epil = getelementptr i8, ptr %sunkaddr141.epil, i64 8
  %.519.1.epil = load double, ptr %sunkaddr146.epil, align 8
  %sunkaddr60 = getelementptr i8, ptr %sunkaddr53, i64 8
  store double %.519.1.epil, ptr %sunkaddr60, align 8
  %sunkaddr149.epil = getelementptr i8, ptr %sunkaddr143.epil, i64 8
  %.579.1.epil = load double, ptr %sunkaddr149.epil, align 8
  %sunkaddr64 = getelementptr i8, ptr %sunkaddr56, i64 8
  store double %.579.1.epil, ptr %sunkaddr64, align 8
  br label %B378.loopexit.unr-lcssa

B378.loopexit.unr-lcssa:                          ; preds = %B328.if.epil.preheader1, %B378.loopexit.unr-lcssa.unr-lcssa
  %.465.1.lcssa = phi i64 [ %.465.1.epil, %B328.if.epil.preheader1 ], [ %.465.1.1, %B378.loopexit.unr-lcssa.unr-lcssa ]
  %11 = and i64 %.372, 1
  %lcmp.mod.not = icmp eq i64 %11, 0
  br i1 %lcmp.mod.not, label %B378, label %B328.if.epil.preheader

B328.if.epil.preheader:                           ; preds = %B378.loopexit.unr-lcssa, %B328.if.preheader
  %.458813815.epil.init = phi i64 [ 0, %B328.if.preheader ], [ %.465.1.lcssa, %B378.loopexit.unr-lcssa ]
  %12 = inttoptr i64 %.298 to ptr
  %13 = inttoptr i64 %.236 to ptr
  %14 = getelementptr double, ptr %arg.amplitude.4, i64 %.458813815.epil.init
  %.519.epil = load double, ptr %14, align 8
  %15 = getelementptr double, ptr %13, i64 %.458813815.epil.init
  store double %.519.epil, ptr %15, align 8
  %16 = getelementptr double, ptr %arg.phase.4, i64 %.458813815.epil.init
  %.579.epil = load double, ptr %16, align 8
  %17 = getelementptr double, ptr %12, i64 %.458813815.epil.init
  store double %.579.epil, ptr %17, align 8
  br label %B378

B378:                                             ; preds = %B328.if.epil.preheader, %B378.loopexit.unr-lcssa, %B192
  %.673 = sub i64 %.241, %.372
  %.716820.not = icmp slt i64 %.673, 1
  br i1 %.716820.not, label %common.ret, label %B422.if.preheader

B422.if.preheader:                                ; preds = %B378
  %.neg114 = add i64 %arg.inside, 1
  %xtraiter112 = and i64 %.673, 1
  %lcmp.mod113.not = icmp eq i64 %xtraiter112, 0
  br i1 %lcmp.mod113.not, label %B422.if.prol.loopexit, label %B422.if.prol

B422.if.prol:                                     ; preds = %B422.if.preheader
  %18 = inttoptr i64 %.298 to ptr
  %19 = inttoptr i64 %.236 to ptr
  %.725.prol = add nsw i64 %.673, -1
  %.729.prol = add i64 %.372, 1
  %.767.prol = icmp slt i64 %.372, 0
  %.768.prol = select i1 %.767.prol, i64 %.241, i64 0
  %20 = getelementptr double, ptr %19, i64 %.372
  %.782.prol = getelementptr double, ptr %20, i64 %.768.prol
  store double 0.000000e+00, ptr %.782.prol, align 8
  %21 = getelementptr double, ptr %18, i64 %.372
  %.812.prol = getelementptr double, ptr %21, i64 %.768.prol
  store double 0.000000e+00, ptr %.812.prol, align 8
  br label %B422.if.prol.loopexit

B422.if.prol.loopexit:                            ; preds = %B422.if.prol, %B422.if.preheader
  %.715818822.unr = phi i64 [ %.673, %B422.if.preheader ], [ %.725.prol, %B422.if.prol ]
  %.722819821.unr = phi i64 [ %.372, %B422.if.preheader ], [ %.729.prol, %B422.if.prol ]
  %22 = icmp eq i64 %arg.stop, %.neg114
  br i1 %22, label %common.ret, label %B422.if.preheader115

B422.if.preheader115:                             ; preds = %B422.if.prol.loopexit
  %23 = add nuw i64 %.715818822.unr, 2
  %24 = inttoptr i64 %.298 to ptr
  %25 = inttoptr i64 %.236 to ptr
  %26 = shl i64 %.241, 3
  %27 = shl i64 %.722819821.unr, 3
  %scevgep12 = getelementptr i8, ptr %24, i64 %27
  %scevgep16 = getelementptr i8, ptr %25, i64 %27
  %28 = add i64 %26, 8
  br label %B422.if

common.ret:                                       ; preds = %B422.if, %B378, %B422.if.prol.loopexit, %B504, %B882
  store ptr null, ptr %retptr, align 8
  ret void

B504:                                             ; preds = %entry, %entry
  %.96.1.i.not = icmp eq i64 %.107, 3
  %.876 = sub nsw i64 %arg.stop, %arg.start
  %.879 = shl nsw i64 %.876, 1
  %.885 = shl nsw i64 %.209, 3
  %.887 = add nsw i64 %.885, %.137
  %.889 = inttoptr i64 %.887 to ptr
  %.947 = add nsw i64 %.885, %.167
  %"$phi628.3.2.0" = select i1 %.96.1.i.not, i64 %.879, i64 0
  %.974 = inttoptr i64 %.947 to ptr
  %.1047 = icmp sgt i64 %"$phi628.3.2.0", 0
  %.65.i = load i64, ptr %arg.arguments.4, align 8, !noalias !135
  %.98.i = shl i64 %.206, 3
  %.100.i = mul i64 %.98.i, %.65.i
  %29 = zext i1 %.1047 to i64
  %.115.i = shl i64 %.100.i, %29
  %.120.i = icmp slt i64 %.115.i, 4194304
  %.134.i = sub nsw i64 %.137, %.167
  %.147.1.i = and i64 %.134.i, 63
  %.177.i = icmp ne i64 %.147.1.i, 0
  %"$phi152.0.2.0.i" = select i1 %.1047, i1 %.177.i, i1 false
  %brmerge.i = select i1 %.120.i, i1 true, i1 %"$phi152.0.2.0.i"
  %.209.1.i = and i64 %.137, 7
  %.239.not.i = icmp ne i64 %.209.1.i, 0
  %or.cond.not.i = select i1 %brmerge.i, i1 true, i1 %.239.not.i
  %.250.i = sub i64 0, %.887
  %.263.1.i = lshr exact i64 %.250.i, 3
  %.312.i = and i64 %.263.1.i, 7
  %storemerge.i = select i1 %or.cond.not.i, i64 -1, i64 %.312.i
  %.1084 = sub nsw i64 %arg.inside, %arg.start
  store ptr null, ptr %.1158, align 8
  call fastcc void @inner_17(ptr nonnull %.1158, ptr %arg.amplitude.4, ptr %arg.phase.4, i64 %.1084, double %arg.factors.0, double %arg.factors.1, i64 %storemerge.i, ptr %.889, i64 %.879, ptr %.974, i64 %"$phi628.3.2.0", ptr %arg.tail.4)
  %.1219 = shl nsw i64 %.1084, 1
  store ptr null, ptr %.1221, align 8
  call fastcc void @inner_18(ptr nonnull %.1221, ptr %.889, i64 %.879, ptr %.974, i64 %"$phi628.3.2.0", i64 %.1219)
  br label %common.ret

B882:                                             ; preds = %entry
  %.1261 = sub nsw i64 %arg.stop, %arg.start
  %.1264 = shl nsw i64 %.1261, 1
  %.1270 = shl nsw i64 %.209, 4
  %.1272 = add nsw i64 %.1270, %.137
  %.1274 = inttoptr i64 %.1272 to ptr
  %.1332 = add nsw i64 %.1270, %.167
  %.1334 = icmp eq i64 %.107, 2
  %"$phi1006.3.2.0" = select i1 %.1334, i64 %.1264, i64 0
  %.1359 = inttoptr i64 %.1332 to ptr
  %.1432 = icmp sgt i64 %"$phi1006.3.2.0", 0
  %.65.i31 = load i64, ptr %arg.arguments.4, align 8, !noalias !138
  %.98.i34 = shl i64 %.206, 4
  %.100.i35 = mul i64 %.98.i34, %.65.i31
  %30 = zext i1 %.1432 to i64
  %.115.i36 = shl i64 %.100.i35, %30
  %.120.i37 = icmp slt i64 %.115.i36, 4194304
  %.134.i38 = sub nsw i64 %.137, %.167
  %.147.1.i39 = and i64 %.134.i38, 63
  %.177.i40 = icmp ne i64 %.147.1.i39, 0
  %"$phi152.0.2.0.i41" = select i1 %.1432, i1 %.177.i40, i1 false
  %brmerge.i42 = select i1 %.120.i37, i1 true, i1 %"$phi152.0.2.0.i41"
  %.209.1.i43 = and i64 %.137, 15
  %.239.not.i44 = icmp ne i64 %.209.1.i43, 0
  %or.cond.not.i45 = select i1 %brmerge.i42, i1 true, i1 %.239.not.i44
  %.250.i46 = sub i64 0, %.1272
  %.263.1.i47 = lshr exact i64 %.250.i46, 4
  %.312.i48 = and i64 %.263.1.i47, 3
  %storemerge.i49 = select i1 %or.cond.not.i45, i64 -1, i64 %.312.i48
  %.1469 = sub nsw i64 %arg.inside, %arg.start
  store ptr null, ptr %.1475, align 8
  call fastcc void @inner_19(ptr nonnull %.1475, ptr %arg.amplitude.4, ptr %arg.phase.4, i64 %.1469, double %arg.factors.0, double %arg.factors.1, i64 %storemerge.i49, ptr %.1274, i64 %.1264, ptr %.1359, i64 %"$phi1006.3.2.0", ptr %arg.tail.4)
  %.1538 = shl nsw i64 %.1469, 1
  store ptr null, ptr %.1540, align 8
  call fastcc void @inner_20(ptr nonnull %.1540, ptr %.1274, i64 %.1264, ptr %.1359, i64 %"$phi1006.3.2.0", i64 %.1538)
  br label %common.ret

B328.if:                                          ; preds = %B328.if, %B328.if.preheader.new.new
  %lsr.iv2 = phi i64 [ %lsr.iv.next3, %B328.if ], [ %8, %B328.if.preheader.new.new ]
  %.458813815 = phi i64 [ %.465.1.1, %B328.if ], [ 0, %B328.if.preheader.new.new ]
  %31 = shl i64 %.458813815, 3
  %sunkaddr50 = getelementptr i8, ptr %arg.amplitude.4, i64 %31
  %.519 = load double, ptr %sunkaddr50, align 8
  %scevgep32 = getelementptr i8, ptr %scevgep29, i64 %31
  %scevgep48 = getelementptr i8, ptr %scevgep32, i64 -16
  %scevgep43 = getelementptr i8, ptr %scevgep32, i64 -24
  store double %.519, ptr %scevgep43, align 8
  %sunkaddr52 = getelementptr i8, ptr %arg.phase.4, i64 %31
  %.579 = load double, ptr %sunkaddr52, align 8
  %scevgep38 = getelementptr i8, ptr %scevgep44, i64 %31
  %scevgep37 = getelementptr i8, ptr %scevgep38, i64 -16
  %scevgep33 = getelementptr i8, ptr %scevgep38, i64 -24
  store double %.579, ptr %scevgep33, align 8
  %sunkaddr58 = getelementptr i8, ptr %sunkaddr50, i64 8
  %.519.1 = load double, ptr %sunkaddr58, align 8
  store double %.519.1, ptr %scevgep48, align 8
  %sunkaddr62 = getelementptr i8, ptr %sunkaddr52, i64 8
  %.579.1 = load double, ptr %sunkaddr62, align 8
  store double %.579.1, ptr %scevgep37, align 8
  %sunkaddr66 = getelementptr i8, ptr %sunkaddr50, i64 16
  %.519.18 = load double, ptr %sunkaddr66, align 8
  %scevgep41 = getelementptr i8, ptr %scevgep32, i64 -8
  store double %.519.18, ptr %scevgep41, align 8
  %sunkaddr69 = getelementptr i8, ptr %sunkaddr52, i64 16
  %.579.19 = load double, ptr %sunkaddr69, align 8
  %scevgep28 = getelementptr i8, ptr %scevgep38, i64 -8
  store double %.579.19, ptr %scevgep28, align 8
  %.465.1.1 = add i64 %.458813815, 4
  %sunkaddr70 = shl i64 %.465.1.1, 3
  %sunkaddr71 = getelementptr i8, ptr %arg.amplitude.4, i64 %sunkaddr70
  %sunkaddr72 = getelementptr i8, ptr %sunkaddr71, i64 -8
  %.519.1.1 = load double, ptr %sunkaddr72, align 8
  store double %.519.1.1, ptr %scevgep32, align 8
  %sunkaddr74 = getelementptr i8, ptr %arg.phase.4, i64 %sunkaddr70
  %sunkaddr75 = getelementptr i8, ptr %sunkaddr74, i64 -8
  %.579.1.1 = load double, ptr %sunkaddr75, align 8
  store double %.579.1.1, ptr %scevgep38, align 8
  %lsr.iv.next3 = add i64 %lsr.iv2, 2
  %niter.ncmp.110 = icmp eq i64 %lsr.iv.next3, 0
  br i1 %niter.ncmp.110, label %B378.loopexit.unr-lcssa.unr-lcssa, label %B328.if

B422.if:                                          ; preds = %B422.if, %B422.if.preheader115
  %lsr.iv17 = phi ptr [ %scevgep18, %B422.if ], [ %scevgep16, %B422.if.preheader115 ]
  %lsr.iv13 = phi ptr [ %scevgep14, %B422.if ], [ %scevgep12, %B422.if.preheader115 ]
  %lsr.iv = phi i64 [ %lsr.iv.next, %B422.if ], [ %23, %B422.if.preheader115 ]
  %.722819821 = phi i64 [ %35, %B422.if ], [ %.722819821.unr, %B422.if.preheader115 ]
  %.767 = icmp slt i64 %.722819821, 0
  %32 = select i1 %.767, i64 %26, i64 0
  %scevgep21 = getelementptr i8, ptr %lsr.iv17, i64 %32
  store double 0.000000e+00, ptr %scevgep21, align 8
  %scevgep20 = getelementptr i8, ptr %lsr.iv13, i64 %32
  store double 0.000000e+00, ptr %scevgep20, align 8
  %33 = add i64 %.722819821, 1
  %.767.1 = icmp slt i64 %33, 0
  %34 = select i1 %.767.1, i64 %28, i64 8
  %scevgep = getelementptr i8, ptr %lsr.iv17, i64 %34
  store double 0.000000e+00, ptr %scevgep, align 8
  %scevgep1 = getelementptr i8, ptr %lsr.iv13, i64 %34
  store double 0.000000e+00, ptr %scevgep1, align 8
  %lsr.iv.next = add i64 %lsr.iv, -2
  %scevgep14 = getelementptr i8, ptr %lsr.iv13, i64 16
  %scevgep18 = getelementptr i8, ptr %lsr.iv17, i64 16
  %.716.1 = icmp sgt i64 %lsr.iv.next, 2
  %35 = add i64 %.722819821, 2
  br i1 %.716.1, label %B422.if, label %common.ret
}

; Function Attrs: mustprogress nocallback nocreateundeforpoison nofree nosync nounwind speculatable willreturn memory(none)
declare double @llvm.log.f64(double) #3

; Function Attrs: nofree noinline norecurse nosync nounwind memory(argmem: readwrite)
define internal fastcc void @inner_14(ptr noalias nonnull writeonly captures(none) %retptr, ptr readonly captures(none) %arg.log_f.4, i64 %arg.points, ptr readonly captures(none) %arg.table.4, i64 %arg.bins, double %arg.density, double %arg.bound) unnamed_addr #6 {
entry:
  %.52 = load double, ptr %arg.log_f.4, align 8
  %.54 = fcmp contract olt double %arg.bound, %.52
  br i1 %.54, label %common.ret, label %B48

common.ret:                                       ; preds = %B552, %entry, %B48, %B540
  %low.7.1.sink = phi i64 [ %low.4.1, %B540 ], [ %arg.points, %B48 ], [ 0, %entry ], [ %low.6.1, %B552 ]
  store i64 %low.7.1.sink, ptr %retptr, align 8
  ret void

B48:                                              ; preds = %entry
  %0 = getelementptr double, ptr %arg.log_f.4, i64 %arg.points
  %.85 = getelementptr i8, ptr %0, i64 -8
  %.86 = load double, ptr %.85, align 8
  %.88 = fcmp contract ult double %arg.bound, %.86
  br i1 %.88, label %B98, label %common.ret

B98:                                              ; preds = %B48
  %.121 = fsub contract double %arg.bound, %.52
  %.123 = fmul contract double %arg.density, %.121
  %.5.i = fptosi double %.123 to i64
  %.13.i = tail call i64 @llvm.smax.i64(i64 %.5.i, i64 0)
  %.181 = add nsw i64 %arg.bins, -1
  %.13.i1 = tail call i64 @llvm.smin.i64(i64 %.181, i64 %.13.i)
  %.219 = getelementptr inbounds i64, ptr %arg.table.4, i64 %.13.i1
  %.220 = load i64, ptr %.219, align 8
  %.229 = getelementptr i8, ptr %.219, i64 8
  %.230 = load i64, ptr %.229, align 8
  %.247 = icmp sgt i64 %.220, 0
  br i1 %.247, label %B312, label %B426

B312:                                             ; preds = %B98
  %1 = getelementptr double, ptr %arg.log_f.4, i64 %.220
  %.267 = getelementptr i8, ptr %1, i64 -8
  %.268 = load double, ptr %.267, align 8
  %.270 = fcmp contract ogt double %.268, %arg.bound
  br i1 %.270, label %B358, label %B426

B358:                                             ; preds = %B312, %B380
  %low.3.0 = phi i64 [ %.276, %B380 ], [ %.220, %B312 ]
  %.286 = icmp sgt i64 %low.3.0, 1
  br i1 %.286, label %B380, label %B426

B380:                                             ; preds = %B358
  %.276 = add nsw i64 %low.3.0, -1
  %sunkaddr = shl i64 %.276, 3
  %sunkaddr4 = getelementptr i8, ptr %arg.log_f.4, i64 %sunkaddr
  %sunkaddr5 = getelementptr i8, ptr %sunkaddr4, i64 -8
  %.306 = load double, ptr %sunkaddr5, align 8
  %.308 = fcmp contract ogt double %.306, %arg.bound
  br i1 %.308, label %B358, label %B426

B426:                                             ; preds = %B380, %B358, %B312, %B98
  %low.4.1 = phi i64 [ %.220, %B312 ], [ %.220, %B98 ], [ 0, %B358 ], [ %.276, %B380 ]
  %.327 = icmp slt i64 %.230, %arg.points
  br i1 %.327, label %B438, label %B540

B438:                                             ; preds = %B426
  %.344 = getelementptr inbounds double, ptr %arg.log_f.4, i64 %.230
  %.345 = load double, ptr %.344, align 8
  %.349 = fcmp contract ugt double %.345, %arg.bound
  br i1 %.349, label %B540, label %B478.preheader

B478.preheader:                                   ; preds = %B438
  %2 = add i64 %arg.points, -1
  br label %B478

B478:                                             ; preds = %B500, %B478.preheader
  %high.3.1 = phi i64 [ %.355, %B500 ], [ %.230, %B478.preheader ]
  %exitcond.not = icmp eq i64 %2, %high.3.1
  br i1 %exitcond.not, label %B540, label %B500

B500:                                             ; preds = %B478
  %.355 = add i64 %high.3.1, 1
  %sunkaddr6 = shl i64 %.355, 3
  %sunkaddr7 = getelementptr i8, ptr %arg.log_f.4, i64 %sunkaddr6
  %.383 = load double, ptr %sunkaddr7, align 8
  %.387 = fcmp contract ugt double %.383, %arg.bound
  br i1 %.387, label %B540, label %B478

B540:                                             ; preds = %B500, %B478, %B438, %B426
  %high.4.0 = phi i64 [ %.230, %B438 ], [ %.230, %B426 ], [ %arg.points, %B478 ], [ %.355, %B500 ]
  %.416 = icmp slt i64 %low.4.1, %high.4.0
  br i1 %.416, label %B552, label %common.ret

B552:                                             ; preds = %B540, %B552
  %high.5.0 = phi i64 [ %high.6.1, %B552 ], [ %high.4.0, %B540 ]
  %low.5.0 = phi i64 [ %low.6.1, %B552 ], [ %low.4.1, %B540 ]
  %.429 = add nsw i64 %low.5.0, %high.5.0
  %.430 = ashr i64 %.429, 1
  %.442 = getelementptr inbounds double, ptr %arg.log_f.4, i64 %.430
  %.443 = load double, ptr %.442, align 8
  %.445 = fcmp contract ole double %.443, %arg.bound
  %.456 = add nsw i64 %.430, 1
  %high.6.1 = select i1 %.445, i64 %high.5.0, i64 %.430
  %low.6.1 = select i1 %.445, i64 %.456, i64 %low.5.0
  %.487 = icmp slt i64 %low.6.1, %high.6.1
  br i1 %.487, label %B552, label %common.ret
}

; Function Attrs: mustprogress nocallback nocreateundeforpoison nofree nosync nounwind speculatable willreturn memory(none)
declare double @llvm.fma.f64(double, double, double) #3

; Function Attrs: nofree noinline norecurse nosync nounwind memory(argmem: readwrite)
define internal fastcc void @inner_17(ptr noalias nonnull writeonly captures(none) %retptr, ptr readonly captures(none) %arg.amplitude.4, ptr readonly captures(none) %arg.phase.4, i64 %arg.stop, double %arg.factors.0, double %arg.factors.1, i64 range(i64 -1, 8) %arg.streamed, ptr writeonly captures(none) %arg.first.4, i64 range(i64 -9223372036854775808, 9223372036854775807) %arg.first.5.0, ptr writeonly captures(none) %arg.second.4, i64 range(i64 -9223372036854775808, 9223372036854775807) %arg.second.5.0, ptr captures(none) %arg.tail.4) unnamed_addr #6 {
entry:
  %.126 = icmp sgt i64 %arg.stop, 0
  br i1 %.126, label %B150.preheader, label %common.ret

B150.preheader:                                   ; preds = %entry
  %0 = icmp sgt i64 %arg.second.5.0, 0
  %.88 = fptrunc double %arg.factors.0 to float
  %.89 = fpext float %.88 to double
  %plus.2.0 = select i1 %0, double %.89, double 1.000000e+00
  %.94 = fptrunc double %arg.factors.1 to float
  %.95 = fpext float %.94 to double
  %.1182 = fsub contract double 0.000000e+00, %.95
  %.6.i295 = insertelement <8 x double> poison, double %plus.2.0, i64 0
  %.7.i296 = shufflevector <8 x double> %.6.i295, <8 x double> poison, <8 x i32> zeroinitializer
  %.6.i = insertelement <8 x double> poison, double %.1182, i64 0
  %.7.i = shufflevector <8 x double> %.6.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.6.i301 = insertelement <8 x double> poison, double %.95, i64 0
  %.7.i302 = shufflevector <8 x double> %.6.i301, <8 x double> poison, <8 x i32> zeroinitializer
  %1 = shl i64 %arg.first.5.0, 2
  %2 = shl i64 %arg.second.5.0, 2
  %3 = icmp sgt i64 %arg.streamed, -1
  %sunkaddr4 = getelementptr i8, ptr %arg.tail.4, i64 4
  %sunkaddr17 = getelementptr i8, ptr %arg.tail.4, i64 8
  %sunkaddr18 = getelementptr i8, ptr %arg.tail.4, i64 12
  %sunkaddr = getelementptr i8, ptr %arg.tail.4, i64 16
  %sunkaddr19 = getelementptr i8, ptr %arg.tail.4, i64 20
  %sunkaddr20 = getelementptr i8, ptr %arg.tail.4, i64 24
  %sunkaddr21 = getelementptr i8, ptr %arg.tail.4, i64 28
  %sunkaddr22 = getelementptr i8, ptr %arg.tail.4, i64 32
  %sunkaddr23 = getelementptr i8, ptr %arg.tail.4, i64 36
  %sunkaddr24 = getelementptr i8, ptr %arg.tail.4, i64 40
  %sunkaddr25 = getelementptr i8, ptr %arg.tail.4, i64 44
  %sunkaddr26 = getelementptr i8, ptr %arg.tail.4, i64 48
  %sunkaddr27 = getelementptr i8, ptr %arg.tail.4, i64 52
  %4 = icmp sgt i64 %arg.streamed, -1
  %sunkaddr12 = getelementptr i8, ptr %arg.tail.4, i64 4
  %sunkaddr28 = getelementptr i8, ptr %arg.tail.4, i64 8
  %sunkaddr29 = getelementptr i8, ptr %arg.tail.4, i64 12
  %sunkaddr30 = getelementptr i8, ptr %arg.tail.4, i64 16
  %sunkaddr31 = getelementptr i8, ptr %arg.tail.4, i64 20
  %sunkaddr32 = getelementptr i8, ptr %arg.tail.4, i64 24
  %sunkaddr33 = getelementptr i8, ptr %arg.tail.4, i64 28
  %sunkaddr34 = getelementptr i8, ptr %arg.tail.4, i64 32
  %sunkaddr35 = getelementptr i8, ptr %arg.tail.4, i64 36
  %sunkaddr36 = getelementptr i8, ptr %arg.tail.4, i64 40
  %sunkaddr37 = getelementptr i8, ptr %arg.tail.4, i64 44
  %sunkaddr38 = getelementptr i8, ptr %arg.tail.4, i64 48
  %sunkaddr39 = getelementptr i8, ptr %arg.tail.4, i64 52
  br label %B150

B150:                                             ; preds = %B636061, %B150.preheader
  %j.2.0 = phi i64 [ %.1580, %B636061 ], [ 0, %B150.preheader ]
  %.133 = sub nsw i64 %arg.stop, %j.2.0
  %.13.i = tail call i64 @llvm.smin.i64(i64 %.133, i64 8)
  %.173 = icmp slt i64 %j.2.0, %arg.streamed
  %.13.i276 = tail call i64 @llvm.smin.i64(i64 %arg.streamed, i64 %.13.i)
  %count.2.1 = select i1 %.173, i64 %.13.i276, i64 %.13.i
  %.221 = getelementptr inbounds double, ptr %arg.phase.4, i64 %j.2.0
  %.223 = load <8 x double>, ptr %.221, align 8
  %.228 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.223, <8 x double> splat (double 0x3FE45F306DC9C883), <8 x double> splat (double 0x4338000000000000))
  %.8.i = fadd contract <8 x double> %.228, splat (double 0xC338000000000000)
  %.269 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i, <8 x double> splat (double 0xBFF921FB54442D18), <8 x double> %.223)
  %.286 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i, <8 x double> splat (double 0xBC91A62633145C07), <8 x double> %.269)
  %.6.i278 = fmul contract <8 x double> %.286, %.286
  %.6.i279 = fmul contract <8 x double> %.286, %.6.i278
  %.315 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i278, <8 x double> splat (double 0xBD6AE7F3E733B81F), <8 x double> splat (double 0x3DE6124613A86D09))
  %.318 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i278, <8 x double> %.315, <8 x double> splat (double 0xBE5AE64567F544E4))
  %.321 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i278, <8 x double> %.318, <8 x double> splat (double 0x3EC71DE3A556C734))
  %.324 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i278, <8 x double> %.321, <8 x double> splat (double 0xBF2A01A01A01A01A))
  %.327 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i278, <8 x double> %.324, <8 x double> splat (double 0x3F81111111111111))
  %.330 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i278, <8 x double> %.327, <8 x double> splat (double 0xBFC5555555555555))
  %.355 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i279, <8 x double> %.330, <8 x double> %.286)
  %.360 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i278, <8 x double> splat (double 0x3D2AE7F3E733B81F), <8 x double> splat (double 0xBDA93974A8C07C9D))
  %.363 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i278, <8 x double> %.360, <8 x double> splat (double 0x3E21EED8EFF8D898))
  %.366 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i278, <8 x double> %.363, <8 x double> splat (double 0xBE927E4FB7789F5C))
  %.369 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i278, <8 x double> %.366, <8 x double> splat (double 0x3EFA01A01A01A01A))
  %.372 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i278, <8 x double> %.369, <8 x double> splat (double 0xBF56C16C16C16C17))
  %.375 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i278, <8 x double> %.372, <8 x double> splat (double 0x3FA5555555555555))
  %.378 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i278, <8 x double> %.375, <8 x double> splat (double -5.000000e-01))
  %.381 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i278, <8 x double> %.378, <8 x double> splat (double 1.000000e+00))
  %.382 = bitcast <8 x double> %.228 to <8 x i64>
  %.383 = bitcast <8 x double> %.355 to <8 x i64>
  %.384 = bitcast <8 x double> %.381 to <8 x i64>
  %.6.i280 = xor <8 x i64> %.384, %.383
  %.8.i281 = and <8 x i64> %.382, splat (i64 1)
  %5 = icmp eq <8 x i64> %.8.i281, zeroinitializer
  %.6.i283 = select <8 x i1> %5, <8 x i64> zeroinitializer, <8 x i64> %.6.i280
  %.8.i284 = shl <8 x i64> %.382, splat (i64 62)
  %.8.i285 = and <8 x i64> %.8.i284, splat (i64 -9223372036854775808)
  %.8.i287 = add <8 x i64> %.8.i284, splat (i64 4611686018427387904)
  %.8.i288 = and <8 x i64> %.8.i287, splat (i64 -9223372036854775808)
  %6 = xor <8 x i64> %.8.i285, %.383
  %.6.i290 = xor <8 x i64> %6, %.6.i283
  %7 = bitcast <8 x i64> %.6.i290 to <8 x double>
  %8 = xor <8 x i64> %.8.i288, %.384
  %.6.i292 = xor <8 x i64> %8, %.6.i283
  %9 = bitcast <8 x i64> %.6.i292 to <8 x double>
  %.727 = getelementptr inbounds double, ptr %arg.amplitude.4, i64 %j.2.0
  %.729 = load <8 x double>, ptr %.727, align 8
  %.6.i293 = fmul contract <8 x double> %.729, %9
  %.755 = fptrunc <8 x double> %.6.i293 to <8 x float>
  %.756 = fpext <8 x float> %.755 to <8 x double>
  %.6.i294 = fmul contract <8 x double> %.729, %7
  %.782 = fptrunc <8 x double> %.6.i294 to <8 x float>
  %.783 = fpext <8 x float> %.782 to <8 x double>
  %.8.i297 = fmul contract <8 x double> %.7.i296, %.756
  %.8.i300 = fmul contract <8 x double> %.7.i296, %.783
  %.882 = icmp slt i64 %count.2.1, 8
  %10 = shufflevector <8 x double> %.8.i297, <8 x double> %.8.i300, <16 x i32> <i32 0, i32 8, i32 1, i32 9, i32 2, i32 10, i32 3, i32 11, i32 4, i32 12, i32 5, i32 13, i32 6, i32 14, i32 7, i32 15>
  %.899 = fptrunc <16 x double> %10 to <16 x float>
  br i1 %.882, label %B472, label %B635733

B472:                                             ; preds = %B150
  store <16 x float> %.899, ptr %arg.tail.4, align 4
  %.989841.not = icmp slt i64 %count.2.1, 1
  br i1 %.989841.not, label %B635845, label %B532.if.lr.ph

B532.if.lr.ph:                                    ; preds = %B472
  %.1058 = shl nsw i64 %j.2.0, 1
  %11 = shl i64 %j.2.0, 3
  %scevgep307 = getelementptr i8, ptr %arg.first.4, i64 %11
  %.1056 = load float, ptr %arg.tail.4, align 4
  %.1073 = icmp slt i64 %j.2.0, 0
  %12 = select i1 %.1073, i64 %1, i64 0
  %scevgep311 = getelementptr i8, ptr %scevgep307, i64 %12
  store float %.1056, ptr %scevgep311, align 4
  %.1056.1 = load float, ptr %sunkaddr4, align 4
  %scevgep310 = getelementptr i8, ptr %scevgep311, i64 4
  store float %.1056.1, ptr %scevgep310, align 4
  %exitcond.not.1 = icmp eq i64 %count.2.1, 1
  br i1 %exitcond.not.1, label %B635845, label %B532.if.1

B635733:                                          ; preds = %B150
  %sunkaddr5 = shl i64 %j.2.0, 3
  %sunkaddr6 = getelementptr i8, ptr %arg.first.4, i64 %sunkaddr5
  br i1 %3, label %B635805, label %B635807

B635805:                                          ; preds = %B635733
  store <16 x float> %.899, ptr %sunkaddr6, align 64, !nontemporal !141
  br label %B635845

B635807:                                          ; preds = %B635733
  store <16 x float> %.899, ptr %sunkaddr6, align 4
  br label %B635845

B635845:                                          ; preds = %B472, %B532.if.lr.ph, %B532.if.1, %B532.if.2, %B532.if.3, %B532.if.4, %B532.if.5, %B532.if.6, %B635807, %B635805
  br i1 %0, label %B635849, label %B636061

B635849:                                          ; preds = %B635845
  %.8.i277 = fmul contract <8 x double> %.7.i, %.783
  %.8.i303 = fmul contract <8 x double> %.7.i302, %.756
  %13 = shufflevector <8 x double> %.8.i277, <8 x double> %.8.i303, <16 x i32> <i32 0, i32 8, i32 1, i32 9, i32 2, i32 10, i32 3, i32 11, i32 4, i32 12, i32 5, i32 13, i32 6, i32 14, i32 7, i32 15>
  %.1294 = fptrunc <16 x double> %13 to <16 x float>
  br i1 %.882, label %B635861, label %B636005

B635861:                                          ; preds = %B635849
  store <16 x float> %.1294, ptr %arg.tail.4, align 4
  %.1384847.not = icmp slt i64 %count.2.1, 1
  br i1 %.1384847.not, label %B636061, label %B635901.if.lr.ph

B635901.if.lr.ph:                                 ; preds = %B635861
  %.1453 = shl nsw i64 %j.2.0, 1
  %14 = shl i64 %j.2.0, 3
  %scevgep316 = getelementptr i8, ptr %arg.second.4, i64 %14
  %.1451 = load float, ptr %arg.tail.4, align 4
  %.1468 = icmp slt i64 %j.2.0, 0
  %15 = select i1 %.1468, i64 %2, i64 0
  %scevgep320 = getelementptr i8, ptr %scevgep316, i64 %15
  store float %.1451, ptr %scevgep320, align 4
  %.1451.1 = load float, ptr %sunkaddr12, align 4
  %scevgep319 = getelementptr i8, ptr %scevgep320, i64 4
  store float %.1451.1, ptr %scevgep319, align 4
  %exitcond1331.not.1 = icmp eq i64 %count.2.1, 1
  br i1 %exitcond1331.not.1, label %B636061, label %B635901.if.1

B636005:                                          ; preds = %B635849
  %sunkaddr13 = shl i64 %j.2.0, 3
  %sunkaddr14 = getelementptr i8, ptr %arg.second.4, i64 %sunkaddr13
  br i1 %4, label %B636007, label %B636045

B636007:                                          ; preds = %B636005
  store <16 x float> %.1294, ptr %sunkaddr14, align 64, !nontemporal !141
  br label %B636061

B636045:                                          ; preds = %B636005
  store <16 x float> %.1294, ptr %sunkaddr14, align 4
  br label %B636061

B636061:                                          ; preds = %B636007, %B636045, %B635901.if.6, %B635901.if.5, %B635901.if.4, %B635901.if.3, %B635901.if.2, %B635901.if.1, %B635901.if.lr.ph, %B635861, %B635845
  %.1580 = add nsw i64 %count.2.1, %j.2.0
  %.1586 = icmp slt i64 %.1580, %arg.stop
  br i1 %.1586, label %B150, label %common.ret

common.ret:                                       ; preds = %B636061, %entry
  store ptr null, ptr %retptr, align 8
  ret void

B532.if.1:                                        ; preds = %B532.if.lr.ph
  %.1056.11 = load float, ptr %sunkaddr17, align 4
  %16 = add i64 %.1058, 2
  %.1073.1 = icmp slt i64 %16, 0
  %17 = select i1 %.1073.1, i64 %1, i64 0
  %scevgep311.1 = getelementptr i8, ptr %scevgep307, i64 %17
  %scevgep312.1 = getelementptr i8, ptr %scevgep311.1, i64 8
  store float %.1056.11, ptr %scevgep312.1, align 4
  %.1056.1.1 = load float, ptr %sunkaddr18, align 4
  %scevgep310.1 = getelementptr i8, ptr %scevgep311.1, i64 12
  store float %.1056.1.1, ptr %scevgep310.1, align 4
  %exitcond.not.1.1 = icmp eq i64 %count.2.1, 2
  br i1 %exitcond.not.1.1, label %B635845, label %B532.if.2

B532.if.2:                                        ; preds = %B532.if.1
  %.1056.2 = load float, ptr %sunkaddr, align 4
  %18 = add i64 %.1058, 4
  %.1073.2 = icmp slt i64 %18, 0
  %19 = select i1 %.1073.2, i64 %1, i64 0
  %scevgep311.2 = getelementptr i8, ptr %scevgep307, i64 %19
  %scevgep312.2 = getelementptr i8, ptr %scevgep311.2, i64 16
  store float %.1056.2, ptr %scevgep312.2, align 4
  %.1056.1.2 = load float, ptr %sunkaddr19, align 4
  %scevgep310.2 = getelementptr i8, ptr %scevgep311.2, i64 20
  store float %.1056.1.2, ptr %scevgep310.2, align 4
  %exitcond.not.1.2 = icmp eq i64 %count.2.1, 3
  br i1 %exitcond.not.1.2, label %B635845, label %B532.if.3

B532.if.3:                                        ; preds = %B532.if.2
  %.1056.3 = load float, ptr %sunkaddr20, align 4
  %20 = add i64 %.1058, 6
  %.1073.3 = icmp slt i64 %20, 0
  %21 = select i1 %.1073.3, i64 %1, i64 0
  %scevgep311.3 = getelementptr i8, ptr %scevgep307, i64 %21
  %scevgep312.3 = getelementptr i8, ptr %scevgep311.3, i64 24
  store float %.1056.3, ptr %scevgep312.3, align 4
  %.1056.1.3 = load float, ptr %sunkaddr21, align 4
  %scevgep310.3 = getelementptr i8, ptr %scevgep311.3, i64 28
  store float %.1056.1.3, ptr %scevgep310.3, align 4
  %exitcond.not.1.3 = icmp eq i64 %count.2.1, 4
  br i1 %exitcond.not.1.3, label %B635845, label %B532.if.4

B532.if.4:                                        ; preds = %B532.if.3
  %.1056.4 = load float, ptr %sunkaddr22, align 4
  %22 = add i64 %.1058, 8
  %.1073.4 = icmp slt i64 %22, 0
  %23 = select i1 %.1073.4, i64 %1, i64 0
  %scevgep311.4 = getelementptr i8, ptr %scevgep307, i64 %23
  %scevgep312.4 = getelementptr i8, ptr %scevgep311.4, i64 32
  store float %.1056.4, ptr %scevgep312.4, align 4
  %.1056.1.4 = load float, ptr %sunkaddr23, align 4
  %scevgep310.4 = getelementptr i8, ptr %scevgep311.4, i64 36
  store float %.1056.1.4, ptr %scevgep310.4, align 4
  %exitcond.not.1.4 = icmp eq i64 %count.2.1, 5
  br i1 %exitcond.not.1.4, label %B635845, label %B532.if.5

B532.if.5:                                        ; preds = %B532.if.4
  %.1056.5 = load float, ptr %sunkaddr24, align 4
  %24 = add i64 %.1058, 10
  %.1073.5 = icmp slt i64 %24, 0
  %25 = select i1 %.1073.5, i64 %1, i64 0
  %scevgep311.5 = getelementptr i8, ptr %scevgep307, i64 %25
  %scevgep312.5 = getelementptr i8, ptr %scevgep311.5, i64 40
  store float %.1056.5, ptr %scevgep312.5, align 4
  %.1056.1.5 = load float, ptr %sunkaddr25, align 4
  %scevgep310.5 = getelementptr i8, ptr %scevgep311.5, i64 44
  store float %.1056.1.5, ptr %scevgep310.5, align 4
  %exitcond.not.1.5 = icmp eq i64 %count.2.1, 6
  br i1 %exitcond.not.1.5, label %B635845, label %B532.if.6

B532.if.6:                                        ; preds = %B532.if.5
  %.1056.6 = load float, ptr %sunkaddr26, align 4
  %26 = add i64 %.1058, 12
  %.1073.6 = icmp slt i64 %26, 0
  %27 = select i1 %.1073.6, i64 %1, i64 0
  %scevgep311.6 = getelementptr i8, ptr %scevgep307, i64 %27
  %scevgep312.6 = getelementptr i8, ptr %scevgep311.6, i64 48
  store float %.1056.6, ptr %scevgep312.6, align 4
  %.1056.1.6 = load float, ptr %sunkaddr27, align 4
  %scevgep310.6 = getelementptr i8, ptr %scevgep311.6, i64 52
  store float %.1056.1.6, ptr %scevgep310.6, align 4
  br label %B635845

B635901.if.1:                                     ; preds = %B635901.if.lr.ph
  %.1451.12 = load float, ptr %sunkaddr28, align 4
  %28 = add i64 %.1453, 2
  %.1468.1 = icmp slt i64 %28, 0
  %29 = select i1 %.1468.1, i64 %2, i64 0
  %scevgep320.1 = getelementptr i8, ptr %scevgep316, i64 %29
  %scevgep321.1 = getelementptr i8, ptr %scevgep320.1, i64 8
  store float %.1451.12, ptr %scevgep321.1, align 4
  %.1451.1.1 = load float, ptr %sunkaddr29, align 4
  %scevgep319.1 = getelementptr i8, ptr %scevgep320.1, i64 12
  store float %.1451.1.1, ptr %scevgep319.1, align 4
  %exitcond1331.not.1.1 = icmp eq i64 %count.2.1, 2
  br i1 %exitcond1331.not.1.1, label %B636061, label %B635901.if.2

B635901.if.2:                                     ; preds = %B635901.if.1
  %.1451.2 = load float, ptr %sunkaddr30, align 4
  %30 = add i64 %.1453, 4
  %.1468.2 = icmp slt i64 %30, 0
  %31 = select i1 %.1468.2, i64 %2, i64 0
  %scevgep320.2 = getelementptr i8, ptr %scevgep316, i64 %31
  %scevgep321.2 = getelementptr i8, ptr %scevgep320.2, i64 16
  store float %.1451.2, ptr %scevgep321.2, align 4
  %.1451.1.2 = load float, ptr %sunkaddr31, align 4
  %scevgep319.2 = getelementptr i8, ptr %scevgep320.2, i64 20
  store float %.1451.1.2, ptr %scevgep319.2, align 4
  %exitcond1331.not.1.2 = icmp eq i64 %count.2.1, 3
  br i1 %exitcond1331.not.1.2, label %B636061, label %B635901.if.3

B635901.if.3:                                     ; preds = %B635901.if.2
  %.1451.3 = load float, ptr %sunkaddr32, align 4
  %32 = add i64 %.1453, 6
  %.1468.3 = icmp slt i64 %32, 0
  %33 = select i1 %.1468.3, i64 %2, i64 0
  %scevgep320.3 = getelementptr i8, ptr %scevgep316, i64 %33
  %scevgep321.3 = getelementptr i8, ptr %scevgep320.3, i64 24
  store float %.1451.3, ptr %scevgep321.3, align 4
  %.1451.1.3 = load float, ptr %sunkaddr33, align 4
  %scevgep319.3 = getelementptr i8, ptr %scevgep320.3, i64 28
  store float %.1451.1.3, ptr %scevgep319.3, align 4
  %exitcond1331.not.1.3 = icmp eq i64 %count.2.1, 4
  br i1 %exitcond1331.not.1.3, label %B636061, label %B635901.if.4

B635901.if.4:                                     ; preds = %B635901.if.3
  %.1451.4 = load float, ptr %sunkaddr34, align 4
  %34 = add i64 %.1453, 8
  %.1468.4 = icmp slt i64 %34, 0
  %35 = select i1 %.1468.4, i64 %2, i64 0
  %scevgep320.4 = getelementptr i8, ptr %scevgep316, i64 %35
  %scevgep321.4 = getelementptr i8, ptr %scevgep320.4, i64 32
  store float %.1451.4, ptr %scevgep321.4, align 4
  %.1451.1.4 = load float, ptr %sunkaddr35, align 4
  %scevgep319.4 = getelementptr i8, ptr %scevgep320.4, i64 36
  store float %.1451.1.4, ptr %scevgep319.4, align 4
  %exitcond1331.not.1.4 = icmp eq i64 %count.2.1, 5
  br i1 %exitcond1331.not.1.4, label %B636061, label %B635901.if.5

B635901.if.5:                                     ; preds = %B635901.if.4
  %.1451.5 = load float, ptr %sunkaddr36, align 4
  %36 = add i64 %.1453, 10
  %.1468.5 = icmp slt i64 %36, 0
  %37 = select i1 %.1468.5, i64 %2, i64 0
  %scevgep320.5 = getelementptr i8, ptr %scevgep316, i64 %37
  %scevgep321.5 = getelementptr i8, ptr %scevgep320.5, i64 40
  store float %.1451.5, ptr %scevgep321.5, align 4
  %.1451.1.5 = load float, ptr %sunkaddr37, align 4
  %scevgep319.5 = getelementptr i8, ptr %scevgep320.5, i64 44
  store float %.1451.1.5, ptr %scevgep319.5, align 4
  %exitcond1331.not.1.5 = icmp eq i64 %count.2.1, 6
  br i1 %exitcond1331.not.1.5, label %B636061, label %B635901.if.6

B635901.if.6:                                     ; preds = %B635901.if.5
  %.1451.6 = load float, ptr %sunkaddr38, align 4
  %38 = add i64 %.1453, 12
  %.1468.6 = icmp slt i64 %38, 0
  %39 = select i1 %.1468.6, i64 %2, i64 0
  %scevgep320.6 = getelementptr i8, ptr %scevgep316, i64 %39
  %scevgep321.6 = getelementptr i8, ptr %scevgep320.6, i64 48
  store float %.1451.6, ptr %scevgep321.6, align 4
  %.1451.1.6 = load float, ptr %sunkaddr39, align 4
  %scevgep319.6 = getelementptr i8, ptr %scevgep320.6, i64 52
  store float %.1451.1.6, ptr %scevgep319.6, align 4
  br label %B636061
}

; Function Attrs: nofree noinline norecurse nosync nounwind memory(argmem: readwrite)
define internal fastcc void @inner_19(ptr noalias nonnull writeonly captures(none) %retptr, ptr readonly captures(none) %arg.amplitude.4, ptr readonly captures(none) %arg.phase.4, i64 %arg.stop, double %arg.factors.0, double %arg.factors.1, i64 range(i64 -1, 4) %arg.streamed, ptr writeonly captures(none) %arg.first.4, i64 range(i64 -9223372036854775808, 9223372036854775807) %arg.first.5.0, ptr writeonly captures(none) %arg.second.4, i64 range(i64 -9223372036854775808, 9223372036854775807) %arg.second.5.0, ptr captures(none) %arg.tail.4) unnamed_addr #6 {
entry:
  %.122 = icmp sgt i64 %arg.stop, 0
  br i1 %.122, label %B150.preheader, label %common.ret

B150.preheader:                                   ; preds = %entry
  %0 = icmp sgt i64 %arg.second.5.0, 0
  %plus.2.0 = select i1 %0, double %arg.factors.0, double 1.000000e+00
  %.1168 = fsub contract double 0.000000e+00, %arg.factors.1
  %.6.i295 = insertelement <8 x double> poison, double %plus.2.0, i64 0
  %.7.i296 = shufflevector <8 x double> %.6.i295, <8 x double> poison, <8 x i32> zeroinitializer
  %.6.i = insertelement <8 x double> poison, double %.1168, i64 0
  %.7.i = shufflevector <8 x double> %.6.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.6.i301 = insertelement <8 x double> poison, double %arg.factors.1, i64 0
  %.7.i302 = shufflevector <8 x double> %.6.i301, <8 x double> poison, <8 x i32> zeroinitializer
  %1 = shl i64 %arg.first.5.0, 3
  %2 = shl i64 %arg.second.5.0, 3
  %3 = icmp sgt i64 %arg.streamed, -1
  %sunkaddr3 = getelementptr i8, ptr %arg.tail.4, i64 8
  %sunkaddr34 = getelementptr i8, ptr %arg.tail.4, i64 16
  %sunkaddr35 = getelementptr i8, ptr %arg.tail.4, i64 24
  %sunkaddr = getelementptr i8, ptr %arg.tail.4, i64 32
  %sunkaddr36 = getelementptr i8, ptr %arg.tail.4, i64 40
  %sunkaddr37 = getelementptr i8, ptr %arg.tail.4, i64 48
  %sunkaddr38 = getelementptr i8, ptr %arg.tail.4, i64 56
  %sunkaddr39 = getelementptr i8, ptr %arg.tail.4, i64 64
  %sunkaddr40 = getelementptr i8, ptr %arg.tail.4, i64 72
  %sunkaddr41 = getelementptr i8, ptr %arg.tail.4, i64 80
  %sunkaddr42 = getelementptr i8, ptr %arg.tail.4, i64 88
  %sunkaddr43 = getelementptr i8, ptr %arg.tail.4, i64 96
  %sunkaddr44 = getelementptr i8, ptr %arg.tail.4, i64 104
  %4 = icmp sgt i64 %arg.streamed, -1
  %sunkaddr31 = getelementptr i8, ptr %arg.tail.4, i64 8
  %sunkaddr45 = getelementptr i8, ptr %arg.tail.4, i64 16
  %sunkaddr46 = getelementptr i8, ptr %arg.tail.4, i64 24
  %sunkaddr47 = getelementptr i8, ptr %arg.tail.4, i64 32
  %sunkaddr48 = getelementptr i8, ptr %arg.tail.4, i64 40
  %sunkaddr49 = getelementptr i8, ptr %arg.tail.4, i64 48
  %sunkaddr50 = getelementptr i8, ptr %arg.tail.4, i64 56
  %sunkaddr51 = getelementptr i8, ptr %arg.tail.4, i64 64
  %sunkaddr52 = getelementptr i8, ptr %arg.tail.4, i64 72
  %sunkaddr53 = getelementptr i8, ptr %arg.tail.4, i64 80
  %sunkaddr54 = getelementptr i8, ptr %arg.tail.4, i64 88
  %sunkaddr55 = getelementptr i8, ptr %arg.tail.4, i64 96
  %sunkaddr56 = getelementptr i8, ptr %arg.tail.4, i64 104
  br label %B150

B150:                                             ; preds = %B636458, %B150.preheader
  %j.2.0 = phi i64 [ %.1560, %B636458 ], [ 0, %B150.preheader ]
  %.129 = sub nsw i64 %arg.stop, %j.2.0
  %.13.i = tail call i64 @llvm.smin.i64(i64 %.129, i64 8)
  %.169 = icmp slt i64 %j.2.0, %arg.streamed
  %.13.i276 = tail call i64 @llvm.smin.i64(i64 %arg.streamed, i64 %.13.i)
  %count.2.1 = select i1 %.169, i64 %.13.i276, i64 %.13.i
  %.217 = getelementptr inbounds double, ptr %arg.phase.4, i64 %j.2.0
  %.219 = load <8 x double>, ptr %.217, align 8
  %.224 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.219, <8 x double> splat (double 0x3FE45F306DC9C883), <8 x double> splat (double 0x4338000000000000))
  %.8.i = fadd contract <8 x double> %.224, splat (double 0xC338000000000000)
  %.265 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i, <8 x double> splat (double 0xBFF921FB54442D18), <8 x double> %.219)
  %.282 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i, <8 x double> splat (double 0xBC91A62633145C07), <8 x double> %.265)
  %.6.i278 = fmul contract <8 x double> %.282, %.282
  %.6.i279 = fmul contract <8 x double> %.282, %.6.i278
  %.311 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i278, <8 x double> splat (double 0xBD6AE7F3E733B81F), <8 x double> splat (double 0x3DE6124613A86D09))
  %.314 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i278, <8 x double> %.311, <8 x double> splat (double 0xBE5AE64567F544E4))
  %.317 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i278, <8 x double> %.314, <8 x double> splat (double 0x3EC71DE3A556C734))
  %.320 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i278, <8 x double> %.317, <8 x double> splat (double 0xBF2A01A01A01A01A))
  %.323 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i278, <8 x double> %.320, <8 x double> splat (double 0x3F81111111111111))
  %.326 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i278, <8 x double> %.323, <8 x double> splat (double 0xBFC5555555555555))
  %.351 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i279, <8 x double> %.326, <8 x double> %.282)
  %.356 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i278, <8 x double> splat (double 0x3D2AE7F3E733B81F), <8 x double> splat (double 0xBDA93974A8C07C9D))
  %.359 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i278, <8 x double> %.356, <8 x double> splat (double 0x3E21EED8EFF8D898))
  %.362 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i278, <8 x double> %.359, <8 x double> splat (double 0xBE927E4FB7789F5C))
  %.365 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i278, <8 x double> %.362, <8 x double> splat (double 0x3EFA01A01A01A01A))
  %.368 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i278, <8 x double> %.365, <8 x double> splat (double 0xBF56C16C16C16C17))
  %.371 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i278, <8 x double> %.368, <8 x double> splat (double 0x3FA5555555555555))
  %.374 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i278, <8 x double> %.371, <8 x double> splat (double -5.000000e-01))
  %.377 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i278, <8 x double> %.374, <8 x double> splat (double 1.000000e+00))
  %.378 = bitcast <8 x double> %.224 to <8 x i64>
  %.379 = bitcast <8 x double> %.351 to <8 x i64>
  %.380 = bitcast <8 x double> %.377 to <8 x i64>
  %.6.i280 = xor <8 x i64> %.380, %.379
  %.8.i281 = and <8 x i64> %.378, splat (i64 1)
  %5 = icmp eq <8 x i64> %.8.i281, zeroinitializer
  %.6.i283 = select <8 x i1> %5, <8 x i64> zeroinitializer, <8 x i64> %.6.i280
  %.8.i284 = shl <8 x i64> %.378, splat (i64 62)
  %.8.i285 = and <8 x i64> %.8.i284, splat (i64 -9223372036854775808)
  %.8.i287 = add <8 x i64> %.8.i284, splat (i64 4611686018427387904)
  %.8.i288 = and <8 x i64> %.8.i287, splat (i64 -9223372036854775808)
  %6 = xor <8 x i64> %.8.i285, %.379
  %.6.i290 = xor <8 x i64> %6, %.6.i283
  %7 = bitcast <8 x i64> %.6.i290 to <8 x double>
  %8 = xor <8 x i64> %.8.i288, %.380
  %.6.i292 = xor <8 x i64> %8, %.6.i283
  %9 = bitcast <8 x i64> %.6.i292 to <8 x double>
  %.723 = getelementptr inbounds double, ptr %arg.amplitude.4, i64 %j.2.0
  %.725 = load <8 x double>, ptr %.723, align 8
  %.6.i293 = fmul contract <8 x double> %.725, %9
  %.6.i294 = fmul contract <8 x double> %.725, %7
  %.8.i297 = fmul contract <8 x double> %.7.i296, %.6.i293
  %.8.i300 = fmul contract <8 x double> %.7.i296, %.6.i294
  %.874 = icmp slt i64 %count.2.1, 8
  br i1 %.874, label %B472, label %B636130

B472:                                             ; preds = %B150
  %.889 = shufflevector <8 x double> %.8.i297, <8 x double> %.8.i300, <16 x i32> <i32 0, i32 8, i32 1, i32 9, i32 2, i32 10, i32 3, i32 11, i32 4, i32 12, i32 5, i32 13, i32 6, i32 14, i32 7, i32 15>
  store <16 x double> %.889, ptr %arg.tail.4, align 4
  %.979841.not = icmp slt i64 %count.2.1, 1
  br i1 %.979841.not, label %B636242, label %B532.if.lr.ph

B532.if.lr.ph:                                    ; preds = %B472
  %.1048 = shl nsw i64 %j.2.0, 1
  %10 = shl i64 %j.2.0, 4
  %scevgep307 = getelementptr i8, ptr %arg.first.4, i64 %10
  %.1046 = load double, ptr %arg.tail.4, align 8
  %.1063 = icmp slt i64 %j.2.0, 0
  %11 = select i1 %.1063, i64 %1, i64 0
  %scevgep311 = getelementptr i8, ptr %scevgep307, i64 %11
  store double %.1046, ptr %scevgep311, align 8
  %.1046.1 = load double, ptr %sunkaddr3, align 8
  %scevgep310 = getelementptr i8, ptr %scevgep311, i64 8
  store double %.1046.1, ptr %scevgep310, align 8
  %exitcond.not.1 = icmp eq i64 %count.2.1, 1
  br i1 %exitcond.not.1, label %B636242, label %B532.if.1

B636130:                                          ; preds = %B150
  %.1121.idx = shl i64 %j.2.0, 4
  %.1122 = shufflevector <8 x double> %.8.i297, <8 x double> %.8.i300, <16 x i32> <i32 0, i32 8, i32 1, i32 9, i32 2, i32 10, i32 3, i32 11, i32 4, i32 12, i32 5, i32 13, i32 6, i32 14, i32 7, i32 15>
  %sunkaddr6 = getelementptr i8, ptr %arg.first.4, i64 %.1121.idx
  br i1 %3, label %B636202, label %B636204

B636202:                                          ; preds = %B636130
  store <16 x double> %.1122, ptr %sunkaddr6, align 64, !nontemporal !141
  br label %B636242

B636204:                                          ; preds = %B636130
  store <16 x double> %.1122, ptr %sunkaddr6, align 4
  br label %B636242

B636242:                                          ; preds = %B472, %B532.if.lr.ph, %B532.if.1, %B532.if.2, %B532.if.3, %B532.if.4, %B532.if.5, %B532.if.6, %B636204, %B636202
  br i1 %0, label %B636246, label %B636458

B636246:                                          ; preds = %B636242
  %.8.i277 = fmul contract <8 x double> %.7.i, %.6.i294
  %.8.i303 = fmul contract <8 x double> %.7.i302, %.6.i293
  br i1 %.874, label %B636258, label %B636402

B636258:                                          ; preds = %B636246
  %.1278 = shufflevector <8 x double> %.8.i277, <8 x double> %.8.i303, <16 x i32> <i32 0, i32 8, i32 1, i32 9, i32 2, i32 10, i32 3, i32 11, i32 4, i32 12, i32 5, i32 13, i32 6, i32 14, i32 7, i32 15>
  store <16 x double> %.1278, ptr %arg.tail.4, align 4
  %.1368847.not = icmp slt i64 %count.2.1, 1
  br i1 %.1368847.not, label %B636458, label %B636298.if.lr.ph

B636298.if.lr.ph:                                 ; preds = %B636258
  %.1437 = shl nsw i64 %j.2.0, 1
  %12 = shl i64 %j.2.0, 4
  %scevgep316 = getelementptr i8, ptr %arg.second.4, i64 %12
  %.1435 = load double, ptr %arg.tail.4, align 8
  %.1452 = icmp slt i64 %j.2.0, 0
  %13 = select i1 %.1452, i64 %2, i64 0
  %scevgep320 = getelementptr i8, ptr %scevgep316, i64 %13
  store double %.1435, ptr %scevgep320, align 8
  %.1435.1 = load double, ptr %sunkaddr31, align 8
  %scevgep319 = getelementptr i8, ptr %scevgep320, i64 8
  store double %.1435.1, ptr %scevgep319, align 8
  %exitcond1331.not.1 = icmp eq i64 %count.2.1, 1
  br i1 %exitcond1331.not.1, label %B636458, label %B636298.if.1

B636402:                                          ; preds = %B636246
  %.1510.idx = shl i64 %j.2.0, 4
  %.1511 = shufflevector <8 x double> %.8.i277, <8 x double> %.8.i303, <16 x i32> <i32 0, i32 8, i32 1, i32 9, i32 2, i32 10, i32 3, i32 11, i32 4, i32 12, i32 5, i32 13, i32 6, i32 14, i32 7, i32 15>
  %sunkaddr32 = getelementptr i8, ptr %arg.second.4, i64 %.1510.idx
  br i1 %4, label %B636404, label %B636442

B636404:                                          ; preds = %B636402
  store <16 x double> %.1511, ptr %sunkaddr32, align 64, !nontemporal !141
  br label %B636458

B636442:                                          ; preds = %B636402
  store <16 x double> %.1511, ptr %sunkaddr32, align 4
  br label %B636458

B636458:                                          ; preds = %B636404, %B636442, %B636298.if.6, %B636298.if.5, %B636298.if.4, %B636298.if.3, %B636298.if.2, %B636298.if.1, %B636298.if.lr.ph, %B636258, %B636242
  %.1560 = add nsw i64 %count.2.1, %j.2.0
  %.1566 = icmp slt i64 %.1560, %arg.stop
  br i1 %.1566, label %B150, label %common.ret

common.ret:                                       ; preds = %B636458, %entry
  store ptr null, ptr %retptr, align 8
  ret void

B532.if.1:                                        ; preds = %B532.if.lr.ph
  %.1046.11 = load double, ptr %sunkaddr34, align 8
  %14 = add i64 %.1048, 2
  %.1063.1 = icmp slt i64 %14, 0
  %15 = select i1 %.1063.1, i64 %1, i64 0
  %scevgep311.1 = getelementptr i8, ptr %scevgep307, i64 %15
  %scevgep312.1 = getelementptr i8, ptr %scevgep311.1, i64 16
  store double %.1046.11, ptr %scevgep312.1, align 8
  %.1046.1.1 = load double, ptr %sunkaddr35, align 8
  %scevgep310.1 = getelementptr i8, ptr %scevgep311.1, i64 24
  store double %.1046.1.1, ptr %scevgep310.1, align 8
  %exitcond.not.1.1 = icmp eq i64 %count.2.1, 2
  br i1 %exitcond.not.1.1, label %B636242, label %B532.if.2

B532.if.2:                                        ; preds = %B532.if.1
  %.1046.2 = load double, ptr %sunkaddr, align 8
  %16 = add i64 %.1048, 4
  %.1063.2 = icmp slt i64 %16, 0
  %17 = select i1 %.1063.2, i64 %1, i64 0
  %scevgep311.2 = getelementptr i8, ptr %scevgep307, i64 %17
  %scevgep312.2 = getelementptr i8, ptr %scevgep311.2, i64 32
  store double %.1046.2, ptr %scevgep312.2, align 8
  %.1046.1.2 = load double, ptr %sunkaddr36, align 8
  %scevgep310.2 = getelementptr i8, ptr %scevgep311.2, i64 40
  store double %.1046.1.2, ptr %scevgep310.2, align 8
  %exitcond.not.1.2 = icmp eq i64 %count.2.1, 3
  br i1 %exitcond.not.1.2, label %B636242, label %B532.if.3

B532.if.3:                                        ; preds = %B532.if.2
  %.1046.3 = load double, ptr %sunkaddr37, align 8
  %18 = add i64 %.1048, 6
  %.1063.3 = icmp slt i64 %18, 0
  %19 = select i1 %.1063.3, i64 %1, i64 0
  %scevgep311.3 = getelementptr i8, ptr %scevgep307, i64 %19
  %scevgep312.3 = getelementptr i8, ptr %scevgep311.3, i64 48
  store double %.1046.3, ptr %scevgep312.3, align 8
  %.1046.1.3 = load double, ptr %sunkaddr38, align 8
  %scevgep310.3 = getelementptr i8, ptr %scevgep311.3, i64 56
  store double %.1046.1.3, ptr %scevgep310.3, align 8
  %exitcond.not.1.3 = icmp eq i64 %count.2.1, 4
  br i1 %exitcond.not.1.3, label %B636242, label %B532.if.4

B532.if.4:                                        ; preds = %B532.if.3
  %.1046.4 = load double, ptr %sunkaddr39, align 8
  %20 = add i64 %.1048, 8
  %.1063.4 = icmp slt i64 %20, 0
  %21 = select i1 %.1063.4, i64 %1, i64 0
  %scevgep311.4 = getelementptr i8, ptr %scevgep307, i64 %21
  %scevgep312.4 = getelementptr i8, ptr %scevgep311.4, i64 64
  store double %.1046.4, ptr %scevgep312.4, align 8
  %.1046.1.4 = load double, ptr %sunkaddr40, align 8
  %scevgep310.4 = getelementptr i8, ptr %scevgep311.4, i64 72
  store double %.1046.1.4, ptr %scevgep310.4, align 8
  %exitcond.not.1.4 = icmp eq i64 %count.2.1, 5
  br i1 %exitcond.not.1.4, label %B636242, label %B532.if.5

B532.if.5:                                        ; preds = %B532.if.4
  %.1046.5 = load double, ptr %sunkaddr41, align 8
  %22 = add i64 %.1048, 10
  %.1063.5 = icmp slt i64 %22, 0
  %23 = select i1 %.1063.5, i64 %1, i64 0
  %scevgep311.5 = getelementptr i8, ptr %scevgep307, i64 %23
  %scevgep312.5 = getelementptr i8, ptr %scevgep311.5, i64 80
  store double %.1046.5, ptr %scevgep312.5, align 8
  %.1046.1.5 = load double, ptr %sunkaddr42, align 8
  %scevgep310.5 = getelementptr i8, ptr %scevgep311.5, i64 88
  store double %.1046.1.5, ptr %scevgep310.5, align 8
  %exitcond.not.1.5 = icmp eq i64 %count.2.1, 6
  br i1 %exitcond.not.1.5, label %B636242, label %B532.if.6

B532.if.6:                                        ; preds = %B532.if.5
  %.1046.6 = load double, ptr %sunkaddr43, align 8
  %24 = add i64 %.1048, 12
  %.1063.6 = icmp slt i64 %24, 0
  %25 = select i1 %.1063.6, i64 %1, i64 0
  %scevgep311.6 = getelementptr i8, ptr %scevgep307, i64 %25
  %scevgep312.6 = getelementptr i8, ptr %scevgep311.6, i64 96
  store double %.1046.6, ptr %scevgep312.6, align 8
  %.1046.1.6 = load double, ptr %sunkaddr44, align 8
  %scevgep310.6 = getelementptr i8, ptr %scevgep311.6, i64 104
  store double %.1046.1.6, ptr %scevgep310.6, align 8
  br label %B636242

B636298.if.1:                                     ; preds = %B636298.if.lr.ph
  %.1435.12 = load double, ptr %sunkaddr45, align 8
  %26 = add i64 %.1437, 2
  %.1452.1 = icmp slt i64 %26, 0
  %27 = select i1 %.1452.1, i64 %2, i64 0
  %scevgep320.1 = getelementptr i8, ptr %scevgep316, i64 %27
  %scevgep321.1 = getelementptr i8, ptr %scevgep320.1, i64 16
  store double %.1435.12, ptr %scevgep321.1, align 8
  %.1435.1.1 = load double, ptr %sunkaddr46, align 8
  %scevgep319.1 = getelementptr i8, ptr %scevgep320.1, i64 24
  store double %.1435.1.1, ptr %scevgep319.1, align 8
  %exitcond1331.not.1.1 = icmp eq i64 %count.2.1, 2
  br i1 %exitcond1331.not.1.1, label %B636458, label %B636298.if.2

B636298.if.2:                                     ; preds = %B636298.if.1
  %.1435.2 = load double, ptr %sunkaddr47, align 8
  %28 = add i64 %.1437, 4
  %.1452.2 = icmp slt i64 %28, 0
  %29 = select i1 %.1452.2, i64 %2, i64 0
  %scevgep320.2 = getelementptr i8, ptr %scevgep316, i64 %29
  %scevgep321.2 = getelementptr i8, ptr %scevgep320.2, i64 32
  store double %.1435.2, ptr %scevgep321.2, align 8
  %.1435.1.2 = load double, ptr %sunkaddr48, align 8
  %scevgep319.2 = getelementptr i8, ptr %scevgep320.2, i64 40
  store double %.1435.1.2, ptr %scevgep319.2, align 8
  %exitcond1331.not.1.2 = icmp eq i64 %count.2.1, 3
  br i1 %exitcond1331.not.1.2, label %B636458, label %B636298.if.3

B636298.if.3:                                     ; preds = %B636298.if.2
  %.1435.3 = load double, ptr %sunkaddr49, align 8
  %30 = add i64 %.1437, 6
  %.1452.3 = icmp slt i64 %30, 0
  %31 = select i1 %.1452.3, i64 %2, i64 0
  %scevgep320.3 = getelementptr i8, ptr %scevgep316, i64 %31
  %scevgep321.3 = getelementptr i8, ptr %scevgep320.3, i64 48
  store double %.1435.3, ptr %scevgep321.3, align 8
  %.1435.1.3 = load double, ptr %sunkaddr50, align 8
  %scevgep319.3 = getelementptr i8, ptr %scevgep320.3, i64 56
  store double %.1435.1.3, ptr %scevgep319.3, align 8
  %exitcond1331.not.1.3 = icmp eq i64 %count.2.1, 4
  br i1 %exitcond1331.not.1.3, label %B636458, label %B636298.if.4

B636298.if.4:                                     ; preds = %B636298.if.3
  %.1435.4 = load double, ptr %sunkaddr51, align 8
  %32 = add i64 %.1437, 8
  %.1452.4 = icmp slt i64 %32, 0
  %33 = select i1 %.1452.4, i64 %2, i64 0
  %scevgep320.4 = getelementptr i8, ptr %scevgep316, i64 %33
  %scevgep321.4 = getelementptr i8, ptr %scevgep320.4, i64 64
  store double %.1435.4, ptr %scevgep321.4, align 8
  %.1435.1.4 = load double, ptr %sunkaddr52, align 8
  %scevgep319.4 = getelementptr i8, ptr %scevgep320.4, i64 72
  store double %.1435.1.4, ptr %scevgep319.4, align 8
  %exitcond1331.not.1.4 = icmp eq i64 %count.2.1, 5
  br i1 %exitcond1331.not.1.4, label %B636458, label %B636298.if.5

B636298.if.5:                                     ; preds = %B636298.if.4
  %.1435.5 = load double, ptr %sunkaddr53, align 8
  %34 = add i64 %.1437, 10
  %.1452.5 = icmp slt i64 %34, 0
  %35 = select i1 %.1452.5, i64 %2, i64 0
  %scevgep320.5 = getelementptr i8, ptr %scevgep316, i64 %35
  %scevgep321.5 = getelementptr i8, ptr %scevgep320.5, i64 80
  store double %.1435.5, ptr %scevgep321.5, align 8
  %.1435.1.5 = load double, ptr %sunkaddr54, align 8
  %scevgep319.5 = getelementptr i8, ptr %scevgep320.5, i64 88
  store double %.1435.1.5, ptr %scevgep319.5, align 8
  %exitcond1331.not.1.5 = icmp eq i64 %count.2.1, 6
  br i1 %exitcond1331.not.1.5, label %B636458, label %B636298.if.6

B636298.if.6:                                     ; preds = %B636298.if.5
  %.1435.6 = load double, ptr %sunkaddr55, align 8
  %36 = add i64 %.1437, 12
  %.1452.6 = icmp slt i64 %36, 0
  %37 = select i1 %.1452.6, i64 %2, i64 0
  %scevgep320.6 = getelementptr i8, ptr %scevgep316, i64 %37
  %scevgep321.6 = getelementptr i8, ptr %scevgep320.6, i64 96
  store double %.1435.6, ptr %scevgep321.6, align 8
  %.1435.1.6 = load double, ptr %sunkaddr56, align 8
  %scevgep319.6 = getelementptr i8, ptr %scevgep320.6, i64 104
  store double %.1435.1.6, ptr %scevgep319.6, align 8
  br label %B636458
}

; Function Attrs: nofree noinline norecurse nosync nounwind memory(argmem: write)
define internal fastcc void @inner_18(ptr noalias nonnull writeonly captures(none) %retptr, ptr writeonly captures(none) %arg.first.4, i64 range(i64 -9223372036854775808, 9223372036854775807) %arg.first.5.0, ptr writeonly captures(none) %arg.second.4, i64 range(i64 -9223372036854775808, 9223372036854775807) %arg.second.5.0, i64 range(i64 -9223372036854775808, 9223372036854775807) %arg.start) unnamed_addr #7 {
entry:
  %.83 = sub i64 %arg.first.5.0, %arg.start
  %.128135.not = icmp slt i64 %.83, 1
  br i1 %.128135.not, label %B74, label %B58.if.preheader

B58.if.preheader:                                 ; preds = %entry
  %xtraiter = and i64 %.83, 3
  %lcmp.mod.not = icmp eq i64 %xtraiter, 0
  br i1 %lcmp.mod.not, label %B58.if.prol.loopexit, label %B58.if.prol.preheader

B58.if.prol.preheader:                            ; preds = %B58.if.preheader
  %0 = shl i64 %arg.first.5.0, 2
  br label %B58.if.prol

B58.if.prol:                                      ; preds = %B58.if.prol, %B58.if.prol.preheader
  %lsr.iv35 = phi i64 [ %lsr.iv.next36, %B58.if.prol ], [ %xtraiter, %B58.if.prol.preheader ]
  %.134134136.prol = phi i64 [ %.141.prol, %B58.if.prol ], [ %arg.start, %B58.if.prol.preheader ]
  %.141.prol = add i64 %.134134136.prol, 1
  %.179.prol = icmp slt i64 %.134134136.prol, 0
  %1 = select i1 %.179.prol, i64 %0, i64 0
  %scevgep33 = getelementptr i8, ptr %arg.first.4, i64 %1
  %2 = shl i64 %.134134136.prol, 2
  %scevgep34 = getelementptr i8, ptr %scevgep33, i64 %2
  store float 0.000000e+00, ptr %scevgep34, align 4
  %lsr.iv.next36 = add nsw i64 %lsr.iv35, -1
  %prol.iter.cmp.not = icmp eq i64 %lsr.iv.next36, 0
  br i1 %prol.iter.cmp.not, label %B58.if.prol.loopexit.loopexit, label %B58.if.prol, !llvm.loop !142

B58.if.prol.loopexit.loopexit:                    ; preds = %B58.if.prol
  %3 = sub i64 %arg.first.5.0, %.141.prol
  br label %B58.if.prol.loopexit

B58.if.prol.loopexit:                             ; preds = %B58.if.prol.loopexit.loopexit, %B58.if.preheader
  %.127133137.unr = phi i64 [ %.83, %B58.if.preheader ], [ %3, %B58.if.prol.loopexit.loopexit ]
  %.134134136.unr = phi i64 [ %arg.start, %B58.if.preheader ], [ %.141.prol, %B58.if.prol.loopexit.loopexit ]
  %4 = sub i64 %arg.start, %arg.first.5.0
  %5 = icmp ugt i64 %4, -4
  br i1 %5, label %B74, label %B58.if.preheader5

B58.if.preheader5:                                ; preds = %B58.if.prol.loopexit
  %6 = add i64 %.127133137.unr, 4
  %7 = shl i64 %arg.first.5.0, 2
  %8 = add i64 %7, 4
  %9 = add i64 %7, 8
  %10 = add i64 %7, 12
  %11 = shl i64 %.134134136.unr, 2
  %scevgep15 = getelementptr i8, ptr %arg.first.4, i64 %11
  br label %B58.if

B74:                                              ; preds = %B58.if, %B58.if.prol.loopexit, %entry
  %.257 = sub i64 %arg.second.5.0, %arg.start
  %.300141.not = icmp slt i64 %.257, 1
  br i1 %.300141.not, label %B144, label %B128.if.preheader

B128.if.preheader:                                ; preds = %B74
  %xtraiter1 = and i64 %.257, 3
  %lcmp.mod2.not = icmp eq i64 %xtraiter1, 0
  br i1 %lcmp.mod2.not, label %B128.if.prol.loopexit, label %B128.if.prol.preheader

B128.if.prol.preheader:                           ; preds = %B128.if.preheader
  %12 = shl i64 %arg.second.5.0, 2
  br label %B128.if.prol

B128.if.prol:                                     ; preds = %B128.if.prol, %B128.if.prol.preheader
  %lsr.iv18 = phi i64 [ %lsr.iv.next19, %B128.if.prol ], [ %xtraiter1, %B128.if.prol.preheader ]
  %.306140142.prol = phi i64 [ %.313.prol, %B128.if.prol ], [ %arg.start, %B128.if.prol.preheader ]
  %.313.prol = add i64 %.306140142.prol, 1
  %.351.prol = icmp slt i64 %.306140142.prol, 0
  %13 = select i1 %.351.prol, i64 %12, i64 0
  %scevgep16 = getelementptr i8, ptr %arg.second.4, i64 %13
  %14 = shl i64 %.306140142.prol, 2
  %scevgep17 = getelementptr i8, ptr %scevgep16, i64 %14
  store float 0.000000e+00, ptr %scevgep17, align 4
  %lsr.iv.next19 = add nsw i64 %lsr.iv18, -1
  %prol.iter3.cmp.not = icmp eq i64 %lsr.iv.next19, 0
  br i1 %prol.iter3.cmp.not, label %B128.if.prol.loopexit.loopexit, label %B128.if.prol, !llvm.loop !143

B128.if.prol.loopexit.loopexit:                   ; preds = %B128.if.prol
  %15 = sub i64 %arg.second.5.0, %.313.prol
  br label %B128.if.prol.loopexit

B128.if.prol.loopexit:                            ; preds = %B128.if.prol.loopexit.loopexit, %B128.if.preheader
  %.299139143.unr = phi i64 [ %.257, %B128.if.preheader ], [ %15, %B128.if.prol.loopexit.loopexit ]
  %.306140142.unr = phi i64 [ %arg.start, %B128.if.preheader ], [ %.313.prol, %B128.if.prol.loopexit.loopexit ]
  %16 = sub i64 %arg.start, %arg.second.5.0
  %17 = icmp ugt i64 %16, -4
  br i1 %17, label %B144, label %B128.if.preheader4

B128.if.preheader4:                               ; preds = %B128.if.prol.loopexit
  %18 = add i64 %.299139143.unr, 4
  %19 = shl i64 %arg.second.5.0, 2
  %20 = add i64 %19, 4
  %21 = add i64 %19, 8
  %22 = add i64 %19, 12
  %23 = shl i64 %.306140142.unr, 2
  %scevgep6 = getelementptr i8, ptr %arg.second.4, i64 %23
  br label %B128.if

B144:                                             ; preds = %B128.if, %B128.if.prol.loopexit, %B74
  store ptr null, ptr %retptr, align 8
  ret void

B58.if:                                           ; preds = %B58.if, %B58.if.preheader5
  %lsr.iv16 = phi ptr [ %scevgep18, %B58.if ], [ %scevgep15, %B58.if.preheader5 ]
  %lsr.iv20 = phi i64 [ %lsr.iv.next21, %B58.if ], [ %6, %B58.if.preheader5 ]
  %.134134136 = phi i64 [ %31, %B58.if ], [ %.134134136.unr, %B58.if.preheader5 ]
  %.179 = icmp slt i64 %.134134136, 0
  %24 = select i1 %.179, i64 %7, i64 0
  %scevgep25 = getelementptr i8, ptr %lsr.iv16, i64 %24
  store float 0.000000e+00, ptr %scevgep25, align 4
  %25 = add i64 %.134134136, 1
  %.179.1 = icmp slt i64 %25, 0
  %26 = select i1 %.179.1, i64 %8, i64 4
  %scevgep24 = getelementptr i8, ptr %lsr.iv16, i64 %26
  store float 0.000000e+00, ptr %scevgep24, align 4
  %27 = add i64 %.134134136, 2
  %.179.2 = icmp slt i64 %27, 0
  %28 = select i1 %.179.2, i64 %9, i64 8
  %scevgep23 = getelementptr i8, ptr %lsr.iv16, i64 %28
  store float 0.000000e+00, ptr %scevgep23, align 4
  %29 = add i64 %.134134136, 3
  %.179.3 = icmp slt i64 %29, 0
  %30 = select i1 %.179.3, i64 %10, i64 12
  %scevgep22 = getelementptr i8, ptr %lsr.iv16, i64 %30
  store float 0.000000e+00, ptr %scevgep22, align 4
  %lsr.iv.next21 = add i64 %lsr.iv20, -4
  %scevgep18 = getelementptr i8, ptr %lsr.iv16, i64 16
  %.128.3 = icmp sgt i64 %lsr.iv.next21, 4
  %31 = add i64 %.134134136, 4
  br i1 %.128.3, label %B58.if, label %B74

B128.if:                                          ; preds = %B128.if, %B128.if.preheader4
  %lsr.iv7 = phi ptr [ %scevgep8, %B128.if ], [ %scevgep6, %B128.if.preheader4 ]
  %lsr.iv = phi i64 [ %lsr.iv.next, %B128.if ], [ %18, %B128.if.preheader4 ]
  %.306140142 = phi i64 [ %39, %B128.if ], [ %.306140142.unr, %B128.if.preheader4 ]
  %.351 = icmp slt i64 %.306140142, 0
  %32 = select i1 %.351, i64 %19, i64 0
  %scevgep14 = getelementptr i8, ptr %lsr.iv7, i64 %32
  store float 0.000000e+00, ptr %scevgep14, align 4
  %33 = add i64 %.306140142, 1
  %.351.1 = icmp slt i64 %33, 0
  %34 = select i1 %.351.1, i64 %20, i64 4
  %scevgep13 = getelementptr i8, ptr %lsr.iv7, i64 %34
  store float 0.000000e+00, ptr %scevgep13, align 4
  %35 = add i64 %.306140142, 2
  %.351.2 = icmp slt i64 %35, 0
  %36 = select i1 %.351.2, i64 %21, i64 8
  %scevgep10 = getelementptr i8, ptr %lsr.iv7, i64 %36
  store float 0.000000e+00, ptr %scevgep10, align 4
  %37 = add i64 %.306140142, 3
  %.351.3 = icmp slt i64 %37, 0
  %38 = select i1 %.351.3, i64 %22, i64 12
  %scevgep9 = getelementptr i8, ptr %lsr.iv7, i64 %38
  store float 0.000000e+00, ptr %scevgep9, align 4
  %lsr.iv.next = add i64 %lsr.iv, -4
  %scevgep8 = getelementptr i8, ptr %lsr.iv7, i64 16
  %.300.3 = icmp sgt i64 %lsr.iv.next, 4
  %39 = add i64 %.306140142, 4
  br i1 %.300.3, label %B128.if, label %B144
}

; Function Attrs: nofree noinline norecurse nosync nounwind memory(argmem: write)
define internal fastcc void @inner_20(ptr noalias nonnull writeonly captures(none) %retptr, ptr writeonly captures(none) %arg.first.4, i64 range(i64 -9223372036854775808, 9223372036854775807) %arg.first.5.0, ptr writeonly captures(none) %arg.second.4, i64 range(i64 -9223372036854775808, 9223372036854775807) %arg.second.5.0, i64 range(i64 -9223372036854775808, 9223372036854775807) %arg.start) unnamed_addr #7 {
entry:
  %.83 = sub i64 %arg.first.5.0, %arg.start
  %.128135.not = icmp slt i64 %.83, 1
  br i1 %.128135.not, label %B74, label %B58.if.preheader

B58.if.preheader:                                 ; preds = %entry
  %xtraiter = and i64 %.83, 3
  %lcmp.mod.not = icmp eq i64 %xtraiter, 0
  br i1 %lcmp.mod.not, label %B58.if.prol.loopexit, label %B58.if.prol.preheader

B58.if.prol.preheader:                            ; preds = %B58.if.preheader
  %0 = shl i64 %arg.first.5.0, 3
  br label %B58.if.prol

B58.if.prol:                                      ; preds = %B58.if.prol, %B58.if.prol.preheader
  %lsr.iv35 = phi i64 [ %lsr.iv.next36, %B58.if.prol ], [ %xtraiter, %B58.if.prol.preheader ]
  %.134134136.prol = phi i64 [ %.141.prol, %B58.if.prol ], [ %arg.start, %B58.if.prol.preheader ]
  %.141.prol = add i64 %.134134136.prol, 1
  %.179.prol = icmp slt i64 %.134134136.prol, 0
  %1 = select i1 %.179.prol, i64 %0, i64 0
  %scevgep33 = getelementptr i8, ptr %arg.first.4, i64 %1
  %2 = shl i64 %.134134136.prol, 3
  %scevgep34 = getelementptr i8, ptr %scevgep33, i64 %2
  store double 0.000000e+00, ptr %scevgep34, align 8
  %lsr.iv.next36 = add nsw i64 %lsr.iv35, -1
  %prol.iter.cmp.not = icmp eq i64 %lsr.iv.next36, 0
  br i1 %prol.iter.cmp.not, label %B58.if.prol.loopexit.loopexit, label %B58.if.prol, !llvm.loop !144

B58.if.prol.loopexit.loopexit:                    ; preds = %B58.if.prol
  %3 = sub i64 %arg.first.5.0, %.141.prol
  br label %B58.if.prol.loopexit

B58.if.prol.loopexit:                             ; preds = %B58.if.prol.loopexit.loopexit, %B58.if.preheader
  %.127133137.unr = phi i64 [ %.83, %B58.if.preheader ], [ %3, %B58.if.prol.loopexit.loopexit ]
  %.134134136.unr = phi i64 [ %arg.start, %B58.if.preheader ], [ %.141.prol, %B58.if.prol.loopexit.loopexit ]
  %4 = sub i64 %arg.start, %arg.first.5.0
  %5 = icmp ugt i64 %4, -4
  br i1 %5, label %B74, label %B58.if.preheader5

B58.if.preheader5:                                ; preds = %B58.if.prol.loopexit
  %6 = add i64 %.127133137.unr, 4
  %7 = shl i64 %arg.first.5.0, 3
  %8 = add i64 %7, 8
  %9 = add i64 %7, 16
  %10 = add i64 %7, 24
  %11 = shl i64 %.134134136.unr, 3
  %scevgep15 = getelementptr i8, ptr %arg.first.4, i64 %11
  br label %B58.if

B74:                                              ; preds = %B58.if, %B58.if.prol.loopexit, %entry
  %.256 = sub i64 %arg.second.5.0, %arg.start
  %.299141.not = icmp slt i64 %.256, 1
  br i1 %.299141.not, label %B144, label %B128.if.preheader

B128.if.preheader:                                ; preds = %B74
  %xtraiter1 = and i64 %.256, 3
  %lcmp.mod2.not = icmp eq i64 %xtraiter1, 0
  br i1 %lcmp.mod2.not, label %B128.if.prol.loopexit, label %B128.if.prol.preheader

B128.if.prol.preheader:                           ; preds = %B128.if.preheader
  %12 = shl i64 %arg.second.5.0, 3
  br label %B128.if.prol

B128.if.prol:                                     ; preds = %B128.if.prol, %B128.if.prol.preheader
  %lsr.iv18 = phi i64 [ %lsr.iv.next19, %B128.if.prol ], [ %xtraiter1, %B128.if.prol.preheader ]
  %.305140142.prol = phi i64 [ %.312.prol, %B128.if.prol ], [ %arg.start, %B128.if.prol.preheader ]
  %.312.prol = add i64 %.305140142.prol, 1
  %.350.prol = icmp slt i64 %.305140142.prol, 0
  %13 = select i1 %.350.prol, i64 %12, i64 0
  %scevgep16 = getelementptr i8, ptr %arg.second.4, i64 %13
  %14 = shl i64 %.305140142.prol, 3
  %scevgep17 = getelementptr i8, ptr %scevgep16, i64 %14
  store double 0.000000e+00, ptr %scevgep17, align 8
  %lsr.iv.next19 = add nsw i64 %lsr.iv18, -1
  %prol.iter3.cmp.not = icmp eq i64 %lsr.iv.next19, 0
  br i1 %prol.iter3.cmp.not, label %B128.if.prol.loopexit.loopexit, label %B128.if.prol, !llvm.loop !145

B128.if.prol.loopexit.loopexit:                   ; preds = %B128.if.prol
  %15 = sub i64 %arg.second.5.0, %.312.prol
  br label %B128.if.prol.loopexit

B128.if.prol.loopexit:                            ; preds = %B128.if.prol.loopexit.loopexit, %B128.if.preheader
  %.298139143.unr = phi i64 [ %.256, %B128.if.preheader ], [ %15, %B128.if.prol.loopexit.loopexit ]
  %.305140142.unr = phi i64 [ %arg.start, %B128.if.preheader ], [ %.312.prol, %B128.if.prol.loopexit.loopexit ]
  %16 = sub i64 %arg.start, %arg.second.5.0
  %17 = icmp ugt i64 %16, -4
  br i1 %17, label %B144, label %B128.if.preheader4

B128.if.preheader4:                               ; preds = %B128.if.prol.loopexit
  %18 = add i64 %.298139143.unr, 4
  %19 = shl i64 %arg.second.5.0, 3
  %20 = add i64 %19, 8
  %21 = add i64 %19, 16
  %22 = add i64 %19, 24
  %23 = shl i64 %.305140142.unr, 3
  %scevgep6 = getelementptr i8, ptr %arg.second.4, i64 %23
  br label %B128.if

B144:                                             ; preds = %B128.if, %B128.if.prol.loopexit, %B74
  store ptr null, ptr %retptr, align 8
  ret void

B58.if:                                           ; preds = %B58.if, %B58.if.preheader5
  %lsr.iv16 = phi ptr [ %scevgep18, %B58.if ], [ %scevgep15, %B58.if.preheader5 ]
  %lsr.iv20 = phi i64 [ %lsr.iv.next21, %B58.if ], [ %6, %B58.if.preheader5 ]
  %.134134136 = phi i64 [ %31, %B58.if ], [ %.134134136.unr, %B58.if.preheader5 ]
  %.179 = icmp slt i64 %.134134136, 0
  %24 = select i1 %.179, i64 %7, i64 0
  %scevgep25 = getelementptr i8, ptr %lsr.iv16, i64 %24
  store double 0.000000e+00, ptr %scevgep25, align 8
  %25 = add i64 %.134134136, 1
  %.179.1 = icmp slt i64 %25, 0
  %26 = select i1 %.179.1, i64 %8, i64 8
  %scevgep24 = getelementptr i8, ptr %lsr.iv16, i64 %26
  store double 0.000000e+00, ptr %scevgep24, align 8
  %27 = add i64 %.134134136, 2
  %.179.2 = icmp slt i64 %27, 0
  %28 = select i1 %.179.2, i64 %9, i64 16
  %scevgep23 = getelementptr i8, ptr %lsr.iv16, i64 %28
  store double 0.000000e+00, ptr %scevgep23, align 8
  %29 = add i64 %.134134136, 3
  %.179.3 = icmp slt i64 %29, 0
  %30 = select i1 %.179.3, i64 %10, i64 24
  %scevgep22 = getelementptr i8, ptr %lsr.iv16, i64 %30
  store double 0.000000e+00, ptr %scevgep22, align 8
  %lsr.iv.next21 = add i64 %lsr.iv20, -4
  %scevgep18 = getelementptr i8, ptr %lsr.iv16, i64 32
  %.128.3 = icmp sgt i64 %lsr.iv.next21, 4
  %31 = add i64 %.134134136, 4
  br i1 %.128.3, label %B58.if, label %B74

B128.if:                                          ; preds = %B128.if, %B128.if.preheader4
  %lsr.iv7 = phi ptr [ %scevgep8, %B128.if ], [ %scevgep6, %B128.if.preheader4 ]
  %lsr.iv = phi i64 [ %lsr.iv.next, %B128.if ], [ %18, %B128.if.preheader4 ]
  %.305140142 = phi i64 [ %39, %B128.if ], [ %.305140142.unr, %B128.if.preheader4 ]
  %.350 = icmp slt i64 %.305140142, 0
  %32 = select i1 %.350, i64 %19, i64 0
  %scevgep14 = getelementptr i8, ptr %lsr.iv7, i64 %32
  store double 0.000000e+00, ptr %scevgep14, align 8
  %33 = add i64 %.305140142, 1
  %.350.1 = icmp slt i64 %33, 0
  %34 = select i1 %.350.1, i64 %20, i64 8
  %scevgep13 = getelementptr i8, ptr %lsr.iv7, i64 %34
  store double 0.000000e+00, ptr %scevgep13, align 8
  %35 = add i64 %.305140142, 2
  %.350.2 = icmp slt i64 %35, 0
  %36 = select i1 %.350.2, i64 %21, i64 16
  %scevgep10 = getelementptr i8, ptr %lsr.iv7, i64 %36
  store double 0.000000e+00, ptr %scevgep10, align 8
  %37 = add i64 %.305140142, 3
  %.350.3 = icmp slt i64 %37, 0
  %38 = select i1 %.350.3, i64 %22, i64 24
  %scevgep9 = getelementptr i8, ptr %lsr.iv7, i64 %38
  store double 0.000000e+00, ptr %scevgep9, align 8
  %lsr.iv.next = add i64 %lsr.iv, -4
  %scevgep8 = getelementptr i8, ptr %lsr.iv7, i64 32
  %.299.3 = icmp sgt i64 %lsr.iv.next, 4
  %39 = add i64 %.305140142, 4
  br i1 %.299.3, label %B128.if, label %B144
}

; Function Attrs: mustprogress nocallback nocreateundeforpoison nofree nosync nounwind speculatable willreturn memory(none)
declare double @llvm.pow.f64(double, double) #3

; Function Attrs: mustprogress nocallback nocreateundeforpoison nofree nosync nounwind speculatable willreturn memory(none)
declare { i64, i1 } @llvm.uadd.with.overflow.i64(i64, i64) #3

; Function Attrs: mustprogress nocallback nofree nosync nounwind willreturn memory(none)
declare double @sqrt(double) local_unnamed_addr #8

; Function Attrs: nofree noinline norecurse nosync nounwind memory(readwrite, inaccessiblemem: none, target_mem0: none, target_mem1: none)
define internal fastcc noundef range(i32 0, 2) i32 @inner_6(ptr noalias nonnull writeonly captures(none) %retptr, ptr noalias nonnull writeonly captures(none) %excinfo, i64 %arg.i, i64 %arg.lane, ptr readonly captures(none) %arg.row.4, ptr readonly captures(none) %arg.linear.4, i64 range(i64 40, 9) %arg.linear.5.0, ptr readonly captures(none) %arg.ratios.4, ptr readonly captures(none) %arg.arguments.4, ptr readonly captures(none) %arg.contents.4, ptr readonly captures(none) %arg.weights.4, ptr %arg.scratch.4) unnamed_addr #4 {
entry:
  %.4541 = alloca i64, align 8
  store i64 0, ptr %.4541, align 8
  %.4674 = alloca i8, align 1
  store i8 0, ptr %.4674, align 1
  %excinfo.39 = alloca ptr, align 8
  store ptr null, ptr %excinfo.39, align 8
  %.5726 = alloca ptr, align 8
  store ptr null, ptr %.5726, align 8
  %excinfo.43 = alloca ptr, align 8
  store ptr null, ptr %excinfo.43, align 8
  %.6665 = alloca ptr, align 8
  store ptr null, ptr %.6665, align 8
  %.6767 = alloca ptr, align 8
  store ptr null, ptr %.6767, align 8
  %.136 = getelementptr i8, ptr %arg.arguments.4, i64 16
  %.137 = load i64, ptr %.136, align 8
  %.166 = getelementptr i8, ptr %arg.arguments.4, i64 88
  %.167 = load i64, ptr %.166, align 8
  %.203 = getelementptr i8, ptr %arg.arguments.4, i64 168
  %.204 = load i64, ptr %.203, align 8
  %.205 = inttoptr i64 %.204 to ptr
  %.290 = load i64, ptr %.205, align 8
  %.319 = getelementptr i8, ptr %.205, i64 8
  %.320 = load i64, ptr %.319, align 8
  %.353 = getelementptr i8, ptr %.205, i64 16
  %.354 = load i64, ptr %.353, align 8
  %.356 = mul nsw i64 %.290, 40
  %.481 = getelementptr i8, ptr %arg.arguments.4, i64 32
  %.482 = load i64, ptr %.481, align 8
  %.511 = getelementptr i8, ptr %arg.arguments.4, i64 40
  %.512 = load i64, ptr %.511, align 8
  %.548 = getelementptr i8, ptr %arg.arguments.4, i64 24
  %.549 = load i64, ptr %.548, align 8
  %.551 = inttoptr i64 %.549 to ptr
  %.616 = getelementptr inbounds double, ptr %.551, i64 %.482
  %.674 = icmp sgt i64 %.512, 0
  br i1 %.674, label %B1100, label %B1166

B1100:                                            ; preds = %entry
  %0 = getelementptr double, ptr %.616, i64 %.137
  %.685 = getelementptr i8, ptr %0, i64 -8
  %.686 = load double, ptr %.685, align 8
  %.695 = load double, ptr %.616, align 8
  %.696 = fsub contract double %.686, %.695
  %.698 = uitofp nneg i64 %.512 to double
  %.702 = fdiv contract double %.698, %.696
  br label %B1166

B1166:                                            ; preds = %B1100, %entry
  %prepared_grid_v117__vphi308_0.2.0 = phi double [ %.702, %B1100 ], [ 0.000000e+00, %entry ]
  %.742 = getelementptr i8, ptr %arg.arguments.4, i64 48
  %.743 = load i64, ptr %.742, align 8
  %.972 = getelementptr i8, ptr %arg.contents.4, i64 64
  %.973 = load i64, ptr %.972, align 8
  %.974 = sub i64 0, %.973
  %.982.1 = and i64 %.974, -8
  %.1016 = sub i64 0, %.982.1
  %.1046 = getelementptr i8, ptr %arg.contents.4, i64 144
  %.1047 = load i64, ptr %.1046, align 8
  %.1048 = sub i64 0, %.1047
  %.1056.1 = and i64 %.1048, -8
  %.1090 = sub i64 0, %.1056.1
  %.1111 = shl nsw i64 %.1016, 3
  %.1120 = shl i64 %.1016, 2
  %.1193 = getelementptr double, ptr %arg.scratch.4, i64 %.1120
  %.1270 = getelementptr double, ptr %arg.scratch.4, i64 %.1111
  %.1332.idx = shl i64 %.1090, 6
  %.1332 = getelementptr i8, ptr %.1270, i64 %.1332.idx
  %.1412.idx = shl i64 %.1090, 7
  %.1412 = getelementptr i8, ptr %.1270, i64 %.1412.idx
  %.idx563 = shl i64 %.1090, 8
  %1 = getelementptr i8, ptr %arg.scratch.4, i64 %.idx563
  %.1474 = getelementptr double, ptr %1, i64 %.1111
  %.1613 = getelementptr i8, ptr %.1474, i64 1024
  %.1675 = getelementptr i8, ptr %.1474, i64 3136
  %.1738 = getelementptr i8, ptr %.1474, i64 5248
  %.1801 = getelementptr i8, ptr %.1474, i64 7360
  %.1864 = getelementptr i8, ptr %.1474, i64 9472
  %.1927 = getelementptr i8, ptr %.1474, i64 11584
  %.2038 = getelementptr i8, ptr %.1474, i64 13696
  %.2101 = getelementptr i8, ptr %.1474, i64 15808
  %.2164 = getelementptr i8, ptr %.1474, i64 17920
  %.2227 = getelementptr i8, ptr %.1474, i64 20032
  %.2323 = getelementptr i8, ptr %.1474, i64 22144
  %.13.i = tail call i64 @llvm.smax.i64(i64 %.1090, i64 %.1016)
  %.2403 = add nsw i64 %.13.i, 64
  %.2404 = mul nsw i64 %.2403, %.320
  %.2414 = getelementptr i8, ptr %.1474, i64 22272
  %.2509 = getelementptr double, ptr %.2414, i64 %.2404
  %.3735 = getelementptr i8, ptr %arg.contents.4, i64 120
  %.3736 = load i64, ptr %.3735, align 8
  %.3889 = getelementptr i8, ptr %arg.contents.4, i64 56
  %.3890 = load i64, ptr %.3889, align 8
  %2 = lshr i64 %.1016, 33
  %.99.i = and i64 %2, 1073741824
  %.100.i = sub i64 %.99.i, %.982.1
  %3 = tail call i64 @llvm.smax.i64(i64 %.100.i, i64 0)
  %.88.sroa.0.3.i = tail call i64 @llvm.smin.i64(i64 %3, i64 1073741824)
  %.234.i = shl i64 %.1016, 1
  %.272.i = add i64 %.99.i, %.234.i
  %4 = tail call i64 @llvm.smax.i64(i64 %.272.i, i64 0)
  %5 = add i64 %.3890, 6
  %.486.i = lshr i64 %5, 3
  %.463.inv.i = icmp slt i64 %.3890, 2
  %.507321.not325.i = icmp eq i64 %.486.i, 0
  %.507321.not.i = or i1 %.463.inv.i, %.507321.not325.i
  br i1 %.507321.not.i, label %B1166.endif.endif.endif.e...endif.5, label %B94.if.lr.ph.i

B1246:                                            ; preds = %for.end.1.endif.endif.endif.endif.endif
  %.4960 = getelementptr inbounds nuw i8, ptr %.205, i64 48
  %.5051 = load i64, ptr %.4960, align 8
  %.4824 = load i64, ptr %.205, align 8
  %.idx = mul i64 %.4824, 72
  %6 = getelementptr i8, ptr %.205, i64 %.idx
  %.4845 = getelementptr i8, ptr %6, i64 -24
  %.4936 = load i64, ptr %.4845, align 8
  %.5092 = fmul contract double %.4241, 2.000000e+00
  %.5094 = sitofp i64 %.4936 to double
  %.5098 = fdiv contract double %.5092, %.5094
  %.5108.le = tail call contract double @llvm.log.f64(double %.5098)
  %.5118 = sitofp i64 %.5051 to double
  %.5122 = fdiv contract double %.5092, %.5118
  %.5132.le = tail call contract double @llvm.log.f64(double %.5122)
  %.133.i = getelementptr i8, ptr %arg.contents.4, i64 152
  %.134.i = load i64, ptr %.133.i, align 8, !noalias !146
  %.147.i = getelementptr inbounds double, ptr %arg.weights.4, i64 %.134.i
  %.228.i = load i64, ptr %.1046, align 8, !noalias !146
  %.254.i = load double, ptr %.616, align 8, !noalias !146
  %.256.i = fadd contract double %.5108.le, %.254.i
  %.257.i = fadd contract double %.256.i, -1.000000e-09
  %7 = getelementptr double, ptr %.616, i64 %.137
  %.265.i = getelementptr i8, ptr %7, i64 -8
  %.266.i = load double, ptr %.265.i, align 8, !noalias !146
  %.273.i = fadd contract double %.5132.le, %.266.i
  %.274.i = fadd contract double %.273.i, 1.000000e-09
  %.293.i = add i64 %.228.i, -1
  %.295.i = icmp sgt i64 %.228.i, 1
  br i1 %.295.i, label %B296.i, label %B404.i

B296.i:                                           ; preds = %B1246
  %.313.i = load double, ptr %.147.i, align 8, !noalias !146
  %.317.i = fcmp contract olt double %.313.i, %.257.i
  br i1 %.317.i, label %B336.preheader.i, label %B404.i

B336.preheader.i:                                 ; preds = %B296.i
  %8 = add nsw i64 %.228.i, -2
  %9 = shl i64 %.134.i, 3
  %10 = getelementptr i8, ptr %arg.weights.4, i64 %9
  %scevgep11.i = getelementptr i8, ptr %10, i64 8
  br label %B336.i

B336.i:                                           ; preds = %B364.i, %B336.preheader.i
  %first.2.0.i = phi i64 [ %.323.i, %B364.i ], [ 0, %B336.preheader.i ]
  %exitcond.not.i = icmp eq i64 %8, %first.2.0.i
  br i1 %exitcond.not.i, label %B404.i, label %B364.i

B364.i:                                           ; preds = %B336.i
  %.323.i = add nuw nsw i64 %first.2.0.i, 1
  %11 = shl i64 %first.2.0.i, 3
  %scevgep12.i = getelementptr i8, ptr %scevgep11.i, i64 %11
  %.352.i = load double, ptr %scevgep12.i, align 8, !noalias !146
  %.356.i = fcmp contract olt double %.352.i, %.257.i
  br i1 %.356.i, label %B336.i, label %B404.i

B404.i:                                           ; preds = %B364.i, %B336.i, %B296.i, %B1246
  %first.3.1.i = phi i64 [ 0, %B296.i ], [ 0, %B1246 ], [ %.293.i, %B336.i ], [ %.323.i, %B364.i ]
  %.378.i = add nsw i64 %first.3.1.i, 1
  %.380.i = icmp sgt i64 %.228.i, %.378.i
  br i1 %.380.i, label %B422.i, label %B1474

B422.i:                                           ; preds = %B404.i
  %12 = getelementptr double, ptr %.147.i, i64 %.228.i
  %.400.i = getelementptr i8, ptr %12, i64 -16
  %.401.i = load double, ptr %.400.i, align 8, !noalias !146
  %.403.i = fcmp contract ogt double %.401.i, %.274.i
  br i1 %.403.i, label %B468.preheader.i, label %B1474

B468.preheader.i:                                 ; preds = %B422.i
  %13 = shl i64 %.134.i, 3
  %14 = getelementptr i8, ptr %arg.weights.4, i64 %13
  %scevgep.i = getelementptr i8, ptr %14, i64 -24
  br label %B468.i

B468.i:                                           ; preds = %B496.i, %B468.preheader.i
  %last.2.1.i = phi i64 [ %15, %B496.i ], [ %.228.i, %B468.preheader.i ]
  %15 = add nsw i64 %last.2.1.i, -1
  %.421.i = icmp sgt i64 %15, %.378.i
  br i1 %.421.i, label %B496.i, label %B1512

B496.i:                                           ; preds = %B468.i
  %16 = shl i64 %last.2.1.i, 3
  %scevgep9.i = getelementptr i8, ptr %scevgep.i, i64 %16
  %.441.i = load double, ptr %scevgep9.i, align 8, !noalias !146
  %.443.i = fcmp contract ogt double %.441.i, %.274.i
  br i1 %.443.i, label %B468.i, label %B1474

B1352:                                            ; preds = %for.end.1.endif.endif.endif.endif.endif
  %17 = icmp eq i8 %.4709, 0
  br i1 %17, label %B7719, label %B1474.thread

B1474.thread:                                     ; preds = %B1352
  %.5280 = getelementptr i8, ptr %.205, i64 32
  %.5281 = load i64, ptr %.5280, align 8
  %.5317 = add nsw i64 %.5281, 1
  br label %B1512

B1474:                                            ; preds = %B496.i, %B422.i, %B404.i
  %last.3.0.i = phi i64 [ %.228.i, %B422.i ], [ %.228.i, %B404.i ], [ %15, %B496.i ]
  %.5374 = icmp sgt i64 %last.3.0.i, %first.3.1.i
  br i1 %.5374, label %B1512, label %B1550

B1512:                                            ; preds = %B468.i, %B1474, %B1474.thread
  %_cells_to_fit_v152_last.3.018 = phi i64 [ %.5317, %B1474.thread ], [ %last.3.0.i, %B1474 ], [ %.378.i, %B468.i ]
  %_cells_to_fit_v152_first.3.017 = phi i64 [ %.5281, %B1474.thread ], [ %first.3.1.i, %B1474 ], [ %first.3.1.i, %B468.i ]
  store ptr null, ptr %.5726, align 8
  %.5752 = call fastcc i32 @inner_10(ptr nonnull %.5726, ptr nonnull %excinfo.43, ptr %arg.row.4, ptr %arg.linear.4, ptr %arg.contents.4, ptr %arg.weights.4, i64 %.167, ptr %arg.scratch.4, ptr %.1193, i64 %.1016, ptr %.1474, ptr %.1412, ptr %.1270, ptr %.1332, i64 %_cells_to_fit_v152_first.3.017, i64 %_cells_to_fit_v152_last.3.018)
  %cond = icmp eq i32 %.5752, 0
  br i1 %cond, label %B1550, label %B1512.if, !prof !0

B1550:                                            ; preds = %B1512, %B1474
  %18 = icmp eq i8 %.4709, 0
  br i1 %18, label %B7719, label %B1551

B1551:                                            ; preds = %B1550
  %.5879 = getelementptr i8, ptr %.205, i64 32
  %.5880 = load i64, ptr %.5879, align 8
  %sunkaddr584 = inttoptr i64 %.354 to ptr
  %sunkaddr585 = getelementptr i8, ptr %sunkaddr584, i64 %.356
  %sunkaddr586 = getelementptr i8, ptr %sunkaddr585, i64 8
  %.5915 = load double, ptr %sunkaddr586, align 8
  %.105.i = getelementptr i8, ptr %arg.contents.4, i64 152
  %.106.i = load i64, ptr %.105.i, align 8, !noalias !149
  %19 = getelementptr double, ptr %arg.weights.4, i64 %.106.i
  %.123.i = getelementptr double, ptr %19, i64 %.1090
  %20 = lshr i64 %.5880, 33
  %.190.i = and i64 %20, 1073741824
  %21 = getelementptr double, ptr %.123.i, i64 %.5880
  %.204.i = getelementptr double, ptr %21, i64 %.190.i
  %.205.i = load double, ptr %.204.i, align 8, !noalias !149
  %.384.i = fmul contract double %.5915, 0.000000e+00
  %.368.i = shl nsw i64 %.5880, 3
  %.369.i = or disjoint i64 %.368.i, 7
  %.395.i = getelementptr inbounds double, ptr %.1270, i64 %.369.i
  %.396.i = load double, ptr %.395.i, align 8, !noalias !149
  %.397.i = fadd contract double %.384.i, %.396.i
  %.384.1.i = fmul contract double %.5915, %.397.i
  %.369.1.i = or disjoint i64 %.368.i, 6
  %.395.1.i = getelementptr inbounds double, ptr %.1270, i64 %.369.1.i
  %.396.1.i = load double, ptr %.395.1.i, align 8, !noalias !149
  %.397.1.i = fadd contract double %.396.1.i, %.384.1.i
  %.384.2.i = fmul contract double %.5915, %.397.1.i
  %.369.2.i = or disjoint i64 %.368.i, 5
  %.395.2.i = getelementptr inbounds double, ptr %.1270, i64 %.369.2.i
  %.396.2.i = load double, ptr %.395.2.i, align 8, !noalias !149
  %.397.2.i = fadd contract double %.396.2.i, %.384.2.i
  %.384.3.i = fmul contract double %.5915, %.397.2.i
  %.369.3.i = or disjoint i64 %.368.i, 4
  %.395.3.i = getelementptr inbounds double, ptr %.1270, i64 %.369.3.i
  %.396.3.i = load double, ptr %.395.3.i, align 8, !noalias !149
  %.397.3.i = fadd contract double %.396.3.i, %.384.3.i
  %.384.4.i = fmul contract double %.5915, %.397.3.i
  %.369.4.i = or disjoint i64 %.368.i, 3
  %.395.4.i = getelementptr inbounds double, ptr %.1270, i64 %.369.4.i
  %.396.4.i = load double, ptr %.395.4.i, align 8, !noalias !149
  %.397.4.i = fadd contract double %.396.4.i, %.384.4.i
  %.384.5.i = fmul contract double %.5915, %.397.4.i
  %.369.5.i = or disjoint i64 %.368.i, 2
  %.395.5.i = getelementptr inbounds double, ptr %.1270, i64 %.369.5.i
  %.396.5.i = load double, ptr %.395.5.i, align 8, !noalias !149
  %.397.5.i = fadd contract double %.396.5.i, %.384.5.i
  %.384.6.i = fmul contract double %.5915, %.397.5.i
  %.369.6.i = or disjoint i64 %.368.i, 1
  %.395.6.i = getelementptr inbounds double, ptr %.1270, i64 %.369.6.i
  %.396.6.i = load double, ptr %.395.6.i, align 8, !noalias !149
  %.397.6.i = fadd contract double %.396.6.i, %.384.6.i
  %.384.7.i = fmul contract double %.5915, %.397.6.i
  %.395.7.i = getelementptr inbounds double, ptr %.1270, i64 %.368.i
  %.396.7.i = load double, ptr %.395.7.i, align 8, !noalias !149
  %.397.7.i = fadd contract double %.396.7.i, %.384.7.i
  %.377.i = getelementptr inbounds double, ptr %.1332, i64 %.369.i
  %.378.i29 = load double, ptr %.377.i, align 8, !noalias !149
  %.379.i = fadd contract double %.384.i, %.378.i29
  %.366.1.i = fmul contract double %.5915, %.379.i
  %.377.1.i = getelementptr inbounds double, ptr %.1332, i64 %.369.1.i
  %.378.1.i = load double, ptr %.377.1.i, align 8, !noalias !149
  %.379.1.i = fadd contract double %.378.1.i, %.366.1.i
  %.366.2.i = fmul contract double %.5915, %.379.1.i
  %.377.2.i = getelementptr inbounds double, ptr %.1332, i64 %.369.2.i
  %.378.2.i = load double, ptr %.377.2.i, align 8, !noalias !149
  %.379.2.i = fadd contract double %.378.2.i, %.366.2.i
  %.366.3.i = fmul contract double %.5915, %.379.2.i
  %.377.3.i = getelementptr inbounds double, ptr %.1332, i64 %.369.3.i
  %.378.3.i = load double, ptr %.377.3.i, align 8, !noalias !149
  %.379.3.i = fadd contract double %.378.3.i, %.366.3.i
  %.366.4.i = fmul contract double %.5915, %.379.3.i
  %.377.4.i = getelementptr inbounds double, ptr %.1332, i64 %.369.4.i
  %.378.4.i = load double, ptr %.377.4.i, align 8, !noalias !149
  %.379.4.i = fadd contract double %.378.4.i, %.366.4.i
  %.366.5.i = fmul contract double %.5915, %.379.4.i
  %.377.5.i = getelementptr inbounds double, ptr %.1332, i64 %.369.5.i
  %.378.5.i = load double, ptr %.377.5.i, align 8, !noalias !149
  %.379.5.i = fadd contract double %.378.5.i, %.366.5.i
  %.366.6.i = fmul contract double %.5915, %.379.5.i
  %.377.6.i = getelementptr inbounds double, ptr %.1332, i64 %.369.6.i
  %.378.6.i = load double, ptr %.377.6.i, align 8, !noalias !149
  %.379.6.i = fadd contract double %.378.6.i, %.366.6.i
  %.366.7.i = fmul contract double %.5915, %.379.6.i
  %.377.7.i = getelementptr inbounds double, ptr %.1332, i64 %.368.i
  %.378.7.i = load double, ptr %.377.7.i, align 8, !noalias !149
  %.379.7.i = fadd contract double %.378.7.i, %.366.7.i
  %.361.i = fadd contract double %.384.i, 0.000000e+00
  %.359.1.i = fmul contract double %.5915, %.361.i
  %.361.1.i = fadd contract double %.359.1.i, %.379.i
  %.359.2.i = fmul contract double %.5915, %.361.1.i
  %.361.2.i = fadd contract double %.379.1.i, %.359.2.i
  %.359.3.i = fmul contract double %.5915, %.361.2.i
  %.361.3.i = fadd contract double %.379.2.i, %.359.3.i
  %.359.4.i = fmul contract double %.5915, %.361.3.i
  %.361.4.i = fadd contract double %.379.3.i, %.359.4.i
  %.359.5.i = fmul contract double %.5915, %.361.4.i
  %.361.5.i = fadd contract double %.379.4.i, %.359.5.i
  %.359.6.i = fmul contract double %.5915, %.361.5.i
  %.361.6.i = fadd contract double %.379.5.i, %.359.6.i
  %.359.7.i = fmul contract double %.5915, %.361.6.i
  %.361.7.i = fadd contract double %.379.6.i, %.359.7.i
  %.421.i30 = fmul contract double %.205.i, %.361.7.i
  %sunkaddr587 = shl i64 %.4272, 3
  %sunkaddr588 = getelementptr i8, ptr %arg.weights.4, i64 %sunkaddr587
  %sunkaddr589 = getelementptr i8, ptr %sunkaddr588, i64 8
  %.451.i = load double, ptr %sunkaddr589, align 8, !noalias !149
  %.457.i = fmul contract double %.451.i, %.421.i30
  %.459.i = fsub contract double %.379.7.i, %.457.i
  br label %B7719

B7719:                                            ; preds = %B1352, %B1551, %B1550
  %top.2.sroa.16.0 = phi double [ %.421.i30, %B1551 ], [ 0.000000e+00, %B1550 ], [ 0.000000e+00, %B1352 ]
  %top.2.sroa.8.0 = phi double [ %.459.i, %B1551 ], [ 0.000000e+00, %B1550 ], [ 0.000000e+00, %B1352 ]
  %top.2.sroa.0.0 = phi double [ %.397.7.i, %B1551 ], [ 0.000000e+00, %B1550 ], [ 0.000000e+00, %B1352 ]
  %22 = add i64 %.137, 255
  %.6500 = lshr i64 %22, 8
  %.6479.inv = icmp slt i64 %.137, 1
  %.65213220.not3236 = icmp eq i64 %.6500, 0
  %.65213220.not = select i1 %.6479.inv, i1 true, i1 %.65213220.not3236
  br i1 %.65213220.not, label %B8321, label %B7797.if.preheader

B7797.if.preheader:                               ; preds = %B7719
  %23 = add nuw nsw i64 %.6500, 4
  %24 = icmp eq i64 %50, 2
  br label %B7797.if

B8091:                                            ; preds = %B7797.if
  store ptr null, ptr %.6665, align 8
  call fastcc void @inner_21(ptr nonnull %.6665, i64 %arg.i, i64 %arg.lane, i64 %.652732153221, i64 %.13.i256, i64 %.13.i254, ptr %arg.arguments.4, ptr %arg.contents.4, ptr %arg.weights.4, ptr %arg.linear.4, i64 %arg.linear.5.0, ptr %arg.ratios.4, i64 %.1016, i64 %.1090, i8 %.4680, ptr %arg.scratch.4, ptr %.1193, ptr %.1270, ptr %.1332, double %top.2.sroa.0.0, double %top.2.sroa.8.0, double %top.2.sroa.16.0, ptr %.1613, ptr %.1675, ptr %.1738, ptr %.1801, ptr %.1864, ptr %.1927, ptr %.2038, ptr %.2101, ptr %.2164, ptr %.2227, ptr %.2414, ptr %.2509, ptr %.2323)
  br label %B8243

B8239:                                            ; preds = %B7797.if
  store ptr null, ptr %.6767, align 8
  call fastcc void @inner_22(ptr nonnull %.6767, i64 %arg.i, i64 %arg.lane, i64 %.652732153221, i64 %.13.i256, i64 %.13.i254, ptr %arg.arguments.4, ptr %arg.contents.4, ptr %arg.weights.4, ptr %arg.linear.4, i64 %arg.linear.5.0, ptr %arg.ratios.4, i64 %.1016, i64 %.1090, i8 %.4680, ptr %arg.scratch.4, ptr %.1193, ptr %.1270, ptr %.1332, double %top.2.sroa.0.0, double %top.2.sroa.8.0, double %top.2.sroa.16.0, ptr %.1613, ptr %.1675, ptr %.1738, ptr %.1801, ptr %.2414, ptr %.2509, ptr %.2323)
  br label %B8243

B8243:                                            ; preds = %B8239, %B8091
  %lsr.iv.next8 = add nsw i64 %lsr.iv7, -1
  %.6521 = icmp sgt i64 %lsr.iv7, 5
  br i1 %.6521, label %B7797.if, label %B8321

common.ret:                                       ; preds = %B1512.if, %for.end.1.endif.endif.endif.endif.if, %B8321
  %common.ret.op = phi i32 [ 0, %B8321 ], [ 1, %for.end.1.endif.endif.endif.endif.if ], [ 1, %B1512.if ]
  ret i32 %common.ret.op

B8321:                                            ; preds = %B8243, %B7719
  store ptr null, ptr %retptr, align 8
  br label %common.ret

B94.if.lr.ph.i:                                   ; preds = %B1166
  %.3645 = getelementptr i8, ptr %arg.contents.4, i64 112
  %.3646 = load i64, ptr %.3645, align 8
  %25 = getelementptr double, ptr %arg.scratch.4, i64 %.1016
  %26 = getelementptr double, ptr %arg.scratch.4, i64 %.234.i
  %.idx.i = mul i64 %.982.1, -24
  %27 = getelementptr i8, ptr %arg.scratch.4, i64 %.idx.i
  %28 = shl i64 %.974, 3
  %29 = and i64 %28, -64
  %30 = sub i64 8, %29
  %scevgep574 = getelementptr i8, ptr %arg.linear.4, i64 %30
  %smin28 = tail call i64 @llvm.smin.i64(i64 %4, i64 1073741824)
  %31 = add i64 %.3646, %smin28
  %32 = shl i64 %31, 3
  %scevgep29 = getelementptr i8, ptr %arg.weights.4, i64 %32
  %33 = add i64 %.3646, %.88.sroa.0.3.i
  %34 = shl i64 %33, 3
  %scevgep31 = getelementptr i8, ptr %arg.weights.4, i64 %34
  %35 = add nuw nsw i64 %.486.i, 5
  br label %B94.if.i

B94.if.i:                                         ; preds = %B94.if.i, %B94.if.lr.ph.i
  %lsr.iv12 = phi i64 [ %lsr.iv.next13, %B94.if.i ], [ %35, %B94.if.lr.ph.i ]
  %lsr.iv53.i = phi i64 [ %lsr.iv.next54.i, %B94.if.i ], [ 0, %B94.if.lr.ph.i ]
  %sunkaddr18 = getelementptr i8, ptr %arg.linear.4, i64 %lsr.iv53.i
  %.554.i = load <8 x double>, ptr %sunkaddr18, align 8, !noalias !152
  %sunkaddr20 = getelementptr i8, ptr %sunkaddr18, i64 8
  %.565.i = load <8 x double>, ptr %sunkaddr20, align 8, !noalias !152
  %scevgep576 = getelementptr i8, ptr %scevgep574, i64 %lsr.iv53.i
  %scevgep577 = getelementptr i8, ptr %scevgep576, i64 -8
  %.575.i = load <8 x double>, ptr %scevgep577, align 8, !noalias !152
  %.586.i = load <8 x double>, ptr %scevgep576, align 8, !noalias !152
  %scevgep32 = getelementptr i8, ptr %scevgep31, i64 %lsr.iv53.i
  %.596.i = load <8 x double>, ptr %scevgep32, align 8, !noalias !152
  %scevgep30 = getelementptr i8, ptr %scevgep29, i64 %lsr.iv53.i
  %.606.i = load <8 x double>, ptr %scevgep30, align 8, !noalias !152
  %.6.i.i = fsub contract <8 x double> %.565.i, %.554.i
  %.6.i46.i = fmul contract <8 x double> %.6.i.i, %.606.i
  %scevgep65.i = getelementptr i8, ptr %arg.scratch.4, i64 %lsr.iv53.i
  store <8 x double> %.554.i, ptr %scevgep65.i, align 8, !noalias !152
  %.669.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.575.i, <8 x double> splat (double 2.000000e+00), <8 x double> %.586.i)
  %.8.i.i = fmul contract <8 x double> %.669.i, splat (double 0x3FC5555555555555)
  %.6.i47.i = fmul contract <8 x double> %.596.i, %.8.i.i
  %.6.i48.i = fsub contract <8 x double> %.6.i46.i, %.6.i47.i
  %scevgep64.i = getelementptr i8, ptr %25, i64 %lsr.iv53.i
  store <8 x double> %.6.i48.i, ptr %scevgep64.i, align 8, !noalias !152
  %.8.i49.i = fmul contract <8 x double> %.575.i, splat (double 5.000000e-01)
  %scevgep63.i = getelementptr i8, ptr %26, i64 %lsr.iv53.i
  store <8 x double> %.8.i49.i, ptr %scevgep63.i, align 8, !noalias !152
  %.6.i50.i = fsub contract <8 x double> %.586.i, %.575.i
  %.6.i51.i = fmul contract <8 x double> %.6.i50.i, %.606.i
  %.8.i52.i = fmul contract <8 x double> %.6.i51.i, splat (double 0x3FC5555555555555)
  %scevgep62.i = getelementptr i8, ptr %27, i64 %lsr.iv53.i
  store <8 x double> %.8.i52.i, ptr %scevgep62.i, align 8, !noalias !152
  %lsr.iv.next54.i = add i64 %lsr.iv53.i, 64
  %lsr.iv.next13 = add nsw i64 %lsr.iv12, -1
  %.507.i = icmp sgt i64 %lsr.iv12, 6
  br i1 %.507.i, label %B94.if.i, label %B1166.endif.endif.endif.e...endif.5

B1166.endif.endif.endif.e...endif.5:              ; preds = %B94.if.i, %B1166
  %.4097 = load i64, ptr %.972, align 8
  %36 = add i64 %.4097, 6
  %.486.i193 = lshr i64 %36, 3
  %.463.inv.i194 = icmp slt i64 %.4097, 2
  %.507321.not325.i195 = icmp eq i64 %.486.i193, 0
  %.507321.not.i196 = or i1 %.463.inv.i194, %.507321.not325.i195
  br i1 %.507321.not.i196, label %_ZN17bnserve_surrogate6kernel7_points10fill_cellsB4v158B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedExx5ArrayIdLi1E1C7mutable7alignedE.exit233, label %B94.if.lr.ph.i197

B94.if.lr.ph.i197:                                ; preds = %B1166.endif.endif.endif.e...endif.5
  %37 = getelementptr double, ptr %.1193, i64 %.1016
  %38 = getelementptr double, ptr %.1193, i64 %.234.i
  %.idx.i198 = mul i64 %.982.1, -24
  %39 = getelementptr i8, ptr %.1193, i64 %.idx.i198
  %40 = lshr i64 %.974, 3
  %.neg = mul i64 %40, -192
  %41 = getelementptr i8, ptr %arg.linear.4, i64 %.neg
  %scevgep = getelementptr i8, ptr %41, i64 8
  %42 = shl i64 %40, 7
  %43 = sub i64 8, %42
  %scevgep568 = getelementptr i8, ptr %arg.linear.4, i64 %43
  %smin = tail call i64 @llvm.smin.i64(i64 %4, i64 1073741824)
  %44 = add i64 %smin, %.3736
  %45 = shl i64 %44, 3
  %scevgep22 = getelementptr i8, ptr %arg.weights.4, i64 %45
  %46 = add i64 %.88.sroa.0.3.i, %.3736
  %47 = shl i64 %46, 3
  %scevgep24 = getelementptr i8, ptr %arg.weights.4, i64 %47
  %48 = add nuw nsw i64 %.486.i193, 5
  br label %B94.if.i199

B94.if.i199:                                      ; preds = %B94.if.i199, %B94.if.lr.ph.i197
  %lsr.iv10 = phi i64 [ %lsr.iv.next11, %B94.if.i199 ], [ %48, %B94.if.lr.ph.i197 ]
  %lsr.iv53.i200 = phi i64 [ %lsr.iv.next54.i229, %B94.if.i199 ], [ 0, %B94.if.lr.ph.i197 ]
  %scevgep570 = getelementptr i8, ptr %scevgep568, i64 %lsr.iv53.i200
  %scevgep571 = getelementptr i8, ptr %scevgep570, i64 -8
  %.554.i203 = load <8 x double>, ptr %scevgep571, align 8, !noalias !155
  %.565.i205 = load <8 x double>, ptr %scevgep570, align 8, !noalias !155
  %scevgep566 = getelementptr i8, ptr %scevgep, i64 %lsr.iv53.i200
  %scevgep567 = getelementptr i8, ptr %scevgep566, i64 -8
  %.575.i207 = load <8 x double>, ptr %scevgep567, align 8, !noalias !155
  %.586.i209 = load <8 x double>, ptr %scevgep566, align 8, !noalias !155
  %scevgep25 = getelementptr i8, ptr %scevgep24, i64 %lsr.iv53.i200
  %.596.i211 = load <8 x double>, ptr %scevgep25, align 8, !noalias !155
  %scevgep23 = getelementptr i8, ptr %scevgep22, i64 %lsr.iv53.i200
  %.606.i213 = load <8 x double>, ptr %scevgep23, align 8, !noalias !155
  %.6.i.i214 = fsub contract <8 x double> %.565.i205, %.554.i203
  %.6.i46.i215 = fmul contract <8 x double> %.6.i.i214, %.606.i213
  %scevgep65.i216 = getelementptr i8, ptr %.1193, i64 %lsr.iv53.i200
  store <8 x double> %.554.i203, ptr %scevgep65.i216, align 8, !noalias !155
  %.669.i217 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.575.i207, <8 x double> splat (double 2.000000e+00), <8 x double> %.586.i209)
  %.8.i.i218 = fmul contract <8 x double> %.669.i217, splat (double 0x3FC5555555555555)
  %.6.i47.i219 = fmul contract <8 x double> %.596.i211, %.8.i.i218
  %.6.i48.i220 = fsub contract <8 x double> %.6.i46.i215, %.6.i47.i219
  %scevgep64.i221 = getelementptr i8, ptr %37, i64 %lsr.iv53.i200
  store <8 x double> %.6.i48.i220, ptr %scevgep64.i221, align 8, !noalias !155
  %.8.i49.i222 = fmul contract <8 x double> %.575.i207, splat (double 5.000000e-01)
  %scevgep63.i223 = getelementptr i8, ptr %38, i64 %lsr.iv53.i200
  store <8 x double> %.8.i49.i222, ptr %scevgep63.i223, align 8, !noalias !155
  %.6.i50.i224 = fsub contract <8 x double> %.586.i209, %.575.i207
  %.6.i51.i225 = fmul contract <8 x double> %.6.i50.i224, %.606.i213
  %.8.i52.i226 = fmul contract <8 x double> %.6.i51.i225, splat (double 0x3FC5555555555555)
  %scevgep62.i227 = getelementptr i8, ptr %39, i64 %lsr.iv53.i200
  store <8 x double> %.8.i52.i226, ptr %scevgep62.i227, align 8, !noalias !155
  %lsr.iv.next54.i229 = add i64 %lsr.iv53.i200, 64
  %lsr.iv.next11 = add nsw i64 %lsr.iv10, -1
  %.507.i230 = icmp sgt i64 %lsr.iv10, 6
  br i1 %.507.i230, label %B94.if.i199, label %_ZN17bnserve_surrogate6kernel7_points10fill_cellsB4v158B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedExx5ArrayIdLi1E1C7mutable7alignedE.exit233

_ZN17bnserve_surrogate6kernel7_points10fill_cellsB4v158B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedExx5ArrayIdLi1E1C7mutable7alignedE.exit233: ; preds = %B94.if.i199, %B1166.endif.endif.endif.e...endif.5
  %49 = inttoptr i64 %.743 to ptr
  %.4239 = getelementptr i8, ptr %arg.row.4, i64 56
  %.4240 = load double, ptr %.4239, align 8
  %.4241 = fmul contract double %.4240, 0x3ED4A8B4A9ED04E3
  %.4271 = getelementptr i8, ptr %arg.contents.4, i64 128
  %.4272 = load i64, ptr %.4271, align 8
  %.4283 = getelementptr inbounds double, ptr %arg.weights.4, i64 %.4272
  %.4467 = getelementptr i8, ptr %.4283, i64 8
  %.4468 = load double, ptr %.4467, align 8
  %.4470 = fmul contract double %.4468, 0x3FF000000044B830
  %.4478.le = tail call contract double @llvm.log.f64(double %.4470)
  %.4490.le = tail call contract double @llvm.log.f64(double %.4241)
  %.4495 = fsub contract double %.4478.le, %.4490.le
  store i64 0, ptr %.4541, align 8
  call fastcc void @inner_14(ptr nonnull %.4541, ptr %.616, i64 %.137, ptr %49, i64 %.512, double %prepared_grid_v117__vphi308_0.2.0, double %.4495)
  %.4559 = load i64, ptr %.4541, align 8
  %.4347 = getelementptr inbounds double, ptr %arg.linear.4, i64 %.1120
  %.4580 = mul nsw i64 %.320, %.137
  %.4583 = icmp sgt i64 %.4580, 2047
  %.4615 = getelementptr i8, ptr %arg.arguments.4, i64 112
  %.4616 = load i64, ptr %.4615, align 8
  %50 = and i64 %.4616, -2
  store i8 0, ptr %.4674, align 1
  %.4680 = zext i1 %.4583 to i8
  %.4699 = call fastcc i32 @inner_23(ptr nonnull %.4674, ptr nonnull %excinfo.39, i64 %arg.lane, ptr %arg.row.4, double %.4241, i8 %.4680, i64 %.4559, ptr nonnull %.205, ptr %arg.arguments.4, ptr %arg.contents.4, ptr %arg.weights.4, ptr %.4347, ptr %arg.ratios.4, ptr %.1412, ptr %.2414, ptr %.2509)
  %.4709 = load i8, ptr %.4674, align 1
  %cond1 = icmp eq i32 %.4699, 0
  br i1 %cond1, label %for.end.1.endif.endif.endif.endif.endif, label %for.end.1.endif.endif.endif.endif.if, !prof !0

for.end.1.endif.endif.endif.endif.if:             ; preds = %_ZN17bnserve_surrogate6kernel7_points10fill_cellsB4v158B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedExx5ArrayIdLi1E1C7mutable7alignedE.exit233
  %.4700 = load ptr, ptr %excinfo.39, align 8
  store ptr %.4700, ptr %excinfo, align 8
  br label %common.ret

for.end.1.endif.endif.endif.endif.endif:          ; preds = %_ZN17bnserve_surrogate6kernel7_points10fill_cellsB4v158B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedExx5ArrayIdLi1E1C7mutable7alignedE.exit233
  br i1 %.4583, label %B1246, label %B1352

B1512.if:                                         ; preds = %B1512
  %.5753 = load ptr, ptr %excinfo.43, align 8
  store ptr %.5753, ptr %excinfo, align 8
  br label %common.ret

B7797.if:                                         ; preds = %B8243, %B7797.if.preheader
  %lsr.iv7 = phi i64 [ %lsr.iv.next8, %B8243 ], [ %23, %B7797.if.preheader ]
  %.652732153221 = phi i64 [ %51, %B8243 ], [ 0, %B7797.if.preheader ]
  %51 = add nuw i64 %.652732153221, 256
  %.13.i254 = tail call i64 @llvm.smin.i64(i64 %.137, i64 %51)
  %.13.i255 = tail call i64 @llvm.smax.i64(i64 %.652732153221, i64 %.4559)
  %.13.i256 = tail call i64 @llvm.smin.i64(i64 %.13.i254, i64 %.13.i255)
  br i1 %24, label %B8091, label %B8239
}

; Function Attrs: nofree noinline norecurse nosync nounwind memory(readwrite, inaccessiblemem: none, target_mem0: none, target_mem1: none)
define internal fastcc void @inner_5(ptr noalias nonnull writeonly captures(none) %retptr, i64 %arg.start, i64 %arg.stop, ptr readonly captures(none) %arg.arguments.4, ptr readonly captures(none) %arg.contents.4, ptr readonly captures(none) %arg.weights.4, ptr readonly captures(none) %arg.coordinates.4, ptr writeonly captures(none) %arg.linear.4, ptr writeonly captures(none) %arg.ratios.4, ptr initializes((56, 64)) %arg.scratch.4) unnamed_addr #4 {
entry:
  %.787 = alloca { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, align 8
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(56) %.787, i8 0, i64 56, i1 false)
  %.1128 = alloca ptr, align 8
  store ptr null, ptr %.1128, align 8
  %.1966 = alloca { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, align 8
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(56) %.1966, i8 0, i64 56, i1 false)
  %.2043 = alloca ptr, align 8
  store ptr null, ptr %.2043, align 8
  %.110 = sub nsw i64 %arg.stop, %arg.start
  %.143 = getelementptr i8, ptr %arg.arguments.4, i64 168
  %.144 = load i64, ptr %.143, align 8
  %.229 = getelementptr i8, ptr %arg.arguments.4, i64 160
  %.230 = load i64, ptr %.229, align 8
  %.231.not = icmp eq i64 %.230, 0
  %.502 = icmp slt i64 %.110, 1
  %or.cond = select i1 %.231.not, i1 true, i1 %.502, !prof !158
  br i1 %or.cond, label %B218, label %.568.endif.preheader, !prof !158

B218:                                             ; preds = %.568.endif.preheader, %entry
  %.648 = getelementptr i8, ptr %arg.arguments.4, i64 72
  %.649 = load i64, ptr %.648, align 8
  %.650 = inttoptr i64 %.649 to ptr
  %.727 = getelementptr i8, ptr %arg.contents.4, i64 64
  %.728 = load i64, ptr %.727, align 8
  %.neg = mul i64 %.728, -4
  %0 = and i64 %.neg, -32
  %.773 = sub i64 8, %0
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(56) %.787, i8 0, i64 56, i1 false)
  call fastcc void @inner_8(ptr nonnull %.787, ptr %arg.coordinates.4, i64 %.110, ptr %arg.contents.4, ptr %.650, ptr %arg.weights.4, i64 %.773, ptr %arg.linear.4, ptr %arg.scratch.4)
  %sunkaddr166 = getelementptr inbounds nuw i8, ptr %.787, i64 32
  %.813.fca.4.load = load ptr, ptr %sunkaddr166, align 8
  %1 = inttoptr i64 %.144 to ptr
  %sunkaddr167 = getelementptr inbounds nuw i8, ptr %.787, i64 40
  %.813.fca.5.0.load = load i64, ptr %sunkaddr167, align 8
  %.882 = load i64, ptr %1, align 8
  %.962977.not = icmp slt i64 %.882, 1
  br i1 %.962977.not, label %B604, label %B482.if.preheader

B562:                                             ; preds = %B482.if
  store ptr null, ptr %.1128, align 8
  call fastcc void @inner_24(ptr nonnull %.1128, i64 %arg.start, i64 %arg.stop, ptr %lsr.iv159, ptr %.813.fca.4.load, i64 %.813.fca.5.0.load, ptr %arg.contents.4, ptr %arg.arguments.4)
  br label %B602

B602:                                             ; preds = %B562, %B482.if
  %scevgep160 = getelementptr i8, ptr %lsr.iv159, i64 72
  %lsr.iv.next163 = add nsw i64 %lsr.iv162, -1
  %exitcond.not = icmp eq i64 %lsr.iv.next163, 0
  br i1 %exitcond.not, label %B604, label %B482.if

B604:                                             ; preds = %B602, %B218
  %.1215 = load i64, ptr %1, align 8
  %.1295995.not = icmp slt i64 %.1215, 1
  br i1 %.1295995.not, label %B1066, label %B666.if.preheader

B666.if.preheader:                                ; preds = %B604
  %scevgep = getelementptr i8, ptr %1, i64 48
  %sunkaddr8 = getelementptr inbounds nuw i8, ptr %.1966, i64 40
  %sunkaddr12 = getelementptr inbounds nuw i8, ptr %.1966, i64 32
  br label %B666.if

B746:                                             ; preds = %B666.if
  %scevgep155 = getelementptr i8, ptr %lsr.iv, i64 24
  %.1488 = load i64, ptr %scevgep155, align 8
  %.1489 = inttoptr i64 %.1488 to ptr
  %scevgep154 = getelementptr i8, ptr %lsr.iv, i64 32
  %.1566 = load i64, ptr %scevgep154, align 8
  %.1567 = inttoptr i64 %.1566 to ptr
  %scevgep153 = getelementptr i8, ptr %lsr.iv, i64 40
  %.1650 = load i64, ptr %scevgep153, align 8
  %.1654 = inttoptr i64 %.1650 to ptr
  %scevgep152 = getelementptr i8, ptr %lsr.iv, i64 48
  %.1789 = load i64, ptr %scevgep152, align 8
  %.1800 = getelementptr inbounds double, ptr %arg.ratios.4, i64 %.1789
  %.1901 = getelementptr i8, ptr %.1489, i64 64
  %.1902 = load i64, ptr %.1901, align 8
  %.neg947 = mul i64 %.1902, -4
  %2 = and i64 %.neg947, -32
  %.1949 = sub i64 0, %2
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(56) %.1966, i8 0, i64 56, i1 false)
  call fastcc void @inner_8(ptr nonnull %.1966, ptr %arg.coordinates.4, i64 %.110, ptr %.1489, ptr %.1567, ptr %.1654, i64 %.1949, ptr %.1800, ptr %arg.scratch.4)
  %.1992.fca.5.0.load = load i64, ptr %sunkaddr8, align 8
  %.1992.fca.4.load = load ptr, ptr %sunkaddr12, align 8
  store ptr null, ptr %.2043, align 8
  call fastcc void @inner_24(ptr nonnull %.2043, i64 %arg.start, i64 %arg.stop, ptr %lsr.iv, ptr %.1992.fca.4.load, i64 %.1992.fca.5.0.load, ptr %.1489, ptr %arg.arguments.4)
  br label %B1064

B1064:                                            ; preds = %B746, %B666.if
  %scevgep151 = getelementptr i8, ptr %lsr.iv, i64 72
  %lsr.iv.next = add nsw i64 %lsr.iv157, -1
  %exitcond1024.not = icmp eq i64 %lsr.iv.next, 0
  br i1 %exitcond1024.not, label %B1066, label %B666.if

B1066:                                            ; preds = %B1064, %B604
  store ptr null, ptr %retptr, align 8
  ret void

.568.endif.preheader:                             ; preds = %entry
  %.265 = shl nsw i64 %arg.start, 3
  %.266 = add nsw i64 %.230, %.265
  %.268 = inttoptr i64 %.266 to ptr
  %3 = shl i64 %.110, 3
  tail call void @llvm.memset.p0.i64(ptr align 8 %.268, i8 0, i64 %3, i1 false)
  br label %B218

B482.if.preheader:                                ; preds = %B218
  %scevgep158 = getelementptr i8, ptr %1, i64 48
  br label %B482.if

B482.if:                                          ; preds = %B482.if.preheader, %B602
  %lsr.iv162 = phi i64 [ %.882, %B482.if.preheader ], [ %lsr.iv.next163, %B602 ]
  %lsr.iv159 = phi ptr [ %scevgep158, %B482.if.preheader ], [ %scevgep160, %B602 ]
  %scevgep161 = getelementptr i8, ptr %lsr.iv159, i64 16
  %.1118 = load i64, ptr %scevgep161, align 8
  %.1119 = icmp eq i64 %.1118, 0
  br i1 %.1119, label %B562, label %B602

B666.if:                                          ; preds = %B1064, %B666.if.preheader
  %lsr.iv157 = phi i64 [ %.1215, %B666.if.preheader ], [ %lsr.iv.next, %B1064 ]
  %lsr.iv = phi ptr [ %scevgep, %B666.if.preheader ], [ %scevgep151, %B1064 ]
  %scevgep156 = getelementptr i8, ptr %lsr.iv, i64 16
  %.1451 = load i64, ptr %scevgep156, align 8
  %.1452 = icmp sgt i64 %.1451, 0
  br i1 %.1452, label %B746, label %B1064
}

; Function Attrs: nofree noinline norecurse nosync nounwind memory(readwrite, inaccessiblemem: none, target_mem0: none, target_mem1: none)
define internal fastcc void @inner_24(ptr noalias nonnull writeonly captures(none) %retptr, i64 %arg.start, i64 %arg.stop, ptr readonly captures(none) %arg.mode.4, ptr readonly captures(none) %arg.outputs.4, i64 %arg.outputs.5.0, ptr readonly captures(none) %arg.contents.4, ptr readonly captures(none) %arg.arguments.4) unnamed_addr #4 {
entry:
  %.94 = getelementptr i8, ptr %arg.arguments.4, i64 160
  %.95 = load i64, ptr %.94, align 8
  %.96 = icmp eq i64 %.95, 0
  br i1 %.96, label %common.ret, label %B48

B48:                                              ; preds = %entry
  %.126 = getelementptr i8, ptr %arg.mode.4, i64 64
  %.127 = load i64, ptr %.126, align 8
  %.128 = icmp eq i64 %.127, 0
  br i1 %.128, label %common.ret, label %B96

common.ret:                                       ; preds = %B646.if, %B96, %B48, %entry
  store ptr null, ptr %retptr, align 8
  ret void

B96:                                              ; preds = %B48
  %.273 = getelementptr i8, ptr %arg.arguments.4, i64 168
  %.274 = load i64, ptr %.273, align 8
  %.275 = inttoptr i64 %.274 to ptr
  %.351 = load i64, ptr %.275, align 8
  %.782 = sub i64 %arg.stop, %arg.start
  %.825584.not = icmp slt i64 %.782, 1
  br i1 %.825584.not, label %common.ret, label %B646.if.lr.ph

B646.if.lr.ph:                                    ; preds = %B96
  %.466 = getelementptr i8, ptr %arg.arguments.4, i64 144
  %.467 = load i64, ptr %.466, align 8
  %.387 = getelementptr i8, ptr %arg.arguments.4, i64 136
  %.388 = load i64, ptr %.387, align 8
  %.653 = getelementptr i8, ptr %arg.contents.4, i64 24
  %.654 = load i64, ptr %.653, align 8
  %.563 = getelementptr i8, ptr %arg.arguments.4, i64 8
  %.564 = load i64, ptr %.563, align 8
  %.695 = sub i64 0, %.654
  %.703.1 = and i64 %.695, -8
  %.655 = add i64 %.654, 7
  %0 = inttoptr i64 %.564 to ptr
  %1 = add nuw i64 %.782, 1
  %2 = mul i64 %arg.start, 80
  %3 = getelementptr i8, ptr %0, i64 %2
  %scevgep64 = getelementptr i8, ptr %3, i64 48
  %4 = mul i64 %.351, %arg.start
  %5 = shl i64 %arg.stop, 3
  %6 = shl i64 %arg.outputs.5.0, 3
  %7 = inttoptr i64 %.467 to ptr
  %8 = inttoptr i64 %.388 to ptr
  %9 = inttoptr i64 %.95 to ptr
  %sunkaddr = getelementptr i8, ptr %arg.mode.4, i64 8
  br label %B646.if

B646.if:                                          ; preds = %B646.if, %B646.if.lr.ph
  %lsr.iv72 = phi i64 [ %4, %B646.if.lr.ph ], [ %lsr.iv.next73, %B646.if ]
  %lsr.iv69 = phi i64 [ %.655, %B646.if.lr.ph ], [ %lsr.iv.next70, %B646.if ]
  %lsr.iv65 = phi ptr [ %scevgep64, %B646.if.lr.ph ], [ %scevgep66, %B646.if ]
  %lsr.iv = phi i64 [ %1, %B646.if.lr.ph ], [ %lsr.iv.next, %B646.if ]
  %.831583585 = phi i64 [ %arg.start, %B646.if.lr.ph ], [ %.838, %B646.if ]
  %.878 = icmp slt i64 %.831583585, 0
  %.879 = select i1 %.878, i64 8589934592, i64 0
  %scevgep67 = getelementptr i8, ptr %lsr.iv65, i64 %.879
  %.894 = load double, ptr %scevgep67, align 8
  %.902.le = tail call contract double @llvm.cos.f64(double %.894)
  %.147.i = fmul contract double %.902.le, %.902.le
  %.838 = add i64 %.831583585, 1
  %.931 = fadd contract double %.147.i, 1.000000e+00
  %.932 = fmul contract double %.931, 2.500000e-01
  %.934 = fmul contract double %.931, %.932
  %.935 = fadd contract double %.147.i, %.934
  %.967 = load i64, ptr %sunkaddr, align 8
  %10 = add i64 %.967, %lsr.iv72
  %11 = lshr i64 %10, 33
  %.983 = and i64 %11, 1073741824
  %12 = getelementptr double, ptr %8, i64 %10
  %.997 = getelementptr double, ptr %12, i64 %.983
  %.998 = load double, ptr %.997, align 8
  %.1029 = fmul contract double %.998, %.998
  %.idx579 = shl i64 %10, 4
  %13 = getelementptr i8, ptr %7, i64 %.idx579
  %14 = getelementptr i8, ptr %13, i64 8
  %.1060 = getelementptr double, ptr %14, i64 %.983
  %.1061 = load double, ptr %.1060, align 8
  %.1094 = fmul contract double %.1061, %.1061
  %.1095 = fadd contract double %.1029, %.1094
  %15 = select i1 %.878, i64 %5, i64 0
  %scevgep = getelementptr i8, ptr %9, i64 %15
  %16 = shl i64 %.831583585, 3
  %scevgep63 = getelementptr i8, ptr %scevgep, i64 %16
  %.1125 = load double, ptr %scevgep63, align 8
  %.1129 = fdiv contract double %.1095, %.935
  %.1149 = icmp slt i64 %lsr.iv69, 0
  %17 = select i1 %.1149, i64 %6, i64 0
  %scevgep68 = getelementptr i8, ptr %arg.outputs.4, i64 %17
  %18 = shl i64 %lsr.iv69, 3
  %scevgep71 = getelementptr i8, ptr %scevgep68, i64 %18
  %.1165 = load double, ptr %scevgep71, align 8
  %.1173.le = tail call contract double @llvm.exp.f64(double %.1165)
  %.1178 = fmul contract double %.1173.le, %.1129
  %.1179 = fadd contract double %.1125, %.1178
  store double %.1179, ptr %scevgep63, align 8
  %lsr.iv.next = add i64 %lsr.iv, -1
  %scevgep66 = getelementptr i8, ptr %lsr.iv65, i64 80
  %reass.sub1 = sub i64 %lsr.iv69, %.703.1
  %lsr.iv.next70 = add i64 %reass.sub1, 8
  %lsr.iv.next73 = add i64 %lsr.iv72, %.351
  %.825 = icmp sgt i64 %lsr.iv.next, 1
  br i1 %.825, label %B646.if, label %common.ret
}

; Function Attrs: nofree noinline norecurse nosync nounwind memory(readwrite, inaccessiblemem: none, target_mem0: none, target_mem1: none)
define internal fastcc void @inner_21(ptr noalias nonnull writeonly captures(none) %retptr, i64 %arg.i, i64 %arg.lane, i64 %arg.ends.0, i64 %arg.ends.1, i64 %arg.ends.2, ptr readonly captures(none) %arg.state.0.4, ptr readonly captures(none) %arg.state.1.4, ptr readonly captures(none) %arg.state.2.4, ptr readonly captures(none) %arg.state.3.4, i64 range(i64 40, 9) %arg.state.3.5.0, ptr readonly captures(none) %arg.state.4.4, i64 range(i64 8, 1) %arg.state.5.0, i64 range(i64 8, 1) %arg.state.5.1, i8 range(i8 0, 2) %arg.state.6, ptr readonly captures(none) %arg.state.7.0.4, ptr readonly captures(none) %arg.state.7.1.4, ptr readonly captures(none) %arg.state.8.0.4, ptr readonly captures(none) %arg.state.8.1.4, double %arg.state.9.0, double %arg.state.9.1, double %arg.state.9.2, ptr captures(none) %arg.state.10.0.4, ptr captures(none) %arg.state.10.1.4, ptr captures(none) %arg.state.10.2.4, ptr captures(none) %arg.state.10.3.4, ptr captures(none) %arg.state.10.4.4, ptr captures(none) %arg.state.10.5.4, ptr captures(none) %arg.state.11.0.4, ptr captures(none) %arg.state.11.1.4, ptr captures(none) %arg.state.11.2.4, ptr captures(none) %arg.state.11.3.4, ptr captures(none) %arg.state.12.4, ptr captures(none) %arg.state.13.4, ptr captures(none) %arg.state.14.4) unnamed_addr #4 {
entry:
  %.3127 = alloca ptr, align 8
  store ptr null, ptr %.3127, align 8
  %.12445 = alloca ptr, align 8
  store ptr null, ptr %.12445, align 8
  %.524 = getelementptr i8, ptr %arg.state.0.4, i64 168
  %.525 = load i64, ptr %.524, align 8
  %.526 = inttoptr i64 %.525 to ptr
  %.580 = sub nsw i64 %arg.ends.1, %arg.ends.0
  %.665 = getelementptr i8, ptr %arg.state.0.4, i64 32
  %.732 = getelementptr i8, ptr %arg.state.0.4, i64 24
  %.733 = load i64, ptr %.732, align 8
  %.735 = inttoptr i64 %.733 to ptr
  %.1160 = load i64, ptr %.665, align 8
  %.idx = shl i64 %.1160, 4
  %0 = getelementptr i8, ptr %.735, i64 %.idx
  %.1177 = getelementptr double, ptr %0, i64 %arg.ends.0
  %.161611871 = load i64, ptr %.526, align 8
  %.161811872 = icmp sgt i64 %.161611871, 0
  br i1 %.161811872, label %B820.preheader.lr.ph, label %B76211

B820:                                             ; preds = %B820.backedge, %B820.preheader.lr.ph
  %k.6.1 = phi i64 [ 0, %B820.preheader.lr.ph ], [ %k.6.1.be, %B820.backedge ]
  %number.2.1 = phi i64 [ 0, %B820.preheader.lr.ph ], [ %.3381, %B820.backedge ]
  %.idx9136 = mul i64 %k.6.1, 72
  %1 = getelementptr i8, ptr %.526, i64 %.idx9136
  %.1646 = getelementptr i8, ptr %1, i64 48
  %.1744 = load i64, ptr %.1646, align 8
  %.2014 = load i64, ptr %.665, align 8
  %.2081 = load i64, ptr %.732, align 8
  %.2083 = inttoptr i64 %.2081 to ptr
  %.2613 = mul nsw i64 %number.2.1, %.2612
  %.2624 = getelementptr double, ptr %arg.state.12.4, i64 %.2613
  %.2687 = getelementptr i8, ptr %.2624, i64 320
  %.2750 = getelementptr i8, ptr %.2624, i64 384
  %.2816 = getelementptr i8, ptr %.2624, i64 512
  store ptr null, ptr %.3127, align 8
  call fastcc void @inner_25(ptr nonnull %.3127, i64 %arg.ends.0, i64 %arg.ends.1, i8 %arg.state.6, ptr %.2083, i64 %.2014, ptr %arg.state.3.4, i64 %arg.state.3.5.0, ptr %arg.state.1.4, ptr %arg.state.2.4, i64 %arg.state.5.0, i64 %arg.state.5.1, ptr %arg.state.7.0.4, ptr %arg.state.7.1.4, ptr %arg.state.8.0.4, ptr %arg.state.8.1.4, double %arg.state.9.0, double %arg.state.9.1, double %arg.state.9.2, ptr %.2624, ptr %.2687, ptr %.2750, ptr %.2816, ptr %arg.state.10.2.4, ptr %arg.state.10.3.4, ptr %arg.state.10.0.4, ptr %arg.state.10.1.4)
  %.3287 = sitofp i64 %.1744 to double
  %.3288 = fmul contract double %.3287, 5.000000e-01
  %.3381 = add nuw nsw i64 %number.2.1, 1
  %.3415 = getelementptr i8, ptr %1, i64 64
  %.3416 = load i64, ptr %.3415, align 8
  %.3417 = icmp eq i64 %.3416, 0
  br i1 %.3417, label %B1132, label %B18307

B1132:                                            ; preds = %B820
  %.3477 = load i64, ptr %.526, align 8
  %.3481 = mul nsw i64 %.3477, %arg.i
  %.3509 = getelementptr i8, ptr %1, i64 56
  %.3510 = load i64, ptr %.3509, align 8
  %.3514 = add nsw i64 %.3510, %.3481
  %.3544 = load i64, ptr %sunkaddr83, align 8
  %.3545 = inttoptr i64 %.3544 to ptr
  %.3622 = load i64, ptr %sunkaddr85, align 8
  %.3626 = inttoptr i64 %.3622 to ptr
  %2 = lshr i64 %.3514, 33
  %.3693 = and i64 %2, 1073741824
  %3 = getelementptr double, ptr %.3545, i64 %.3514
  %.3707 = getelementptr double, ptr %3, i64 %.3693
  %.3708 = load double, ptr %.3707, align 8
  %.idx9137 = shl i64 %.3514, 4
  %4 = getelementptr i8, ptr %.3626, i64 %.idx9137
  %5 = getelementptr i8, ptr %4, i64 8
  %.3741 = getelementptr double, ptr %5, i64 %.3693
  %.3742 = load double, ptr %.3741, align 8
  %.3759 = add nsw i64 %k.6.1, 1
  %.3895 = icmp eq i64 %.3759, %.3477
  br i1 %.3895, label %B1353, label %B1352

B1352:                                            ; preds = %B1132
  %.idx9138 = mul i64 %.3759, 72
  %6 = getelementptr i8, ptr %.526, i64 %.idx9138
  %.3795 = getelementptr i8, ptr %6, i64 48
  %.3945 = load i64, ptr %.3795, align 8
  %.3952.not = icmp eq i64 %.3945, %.1744
  br i1 %.3952.not, label %B18307, label %B1353

B1353:                                            ; preds = %B1352, %B1132
  %.115.i = insertelement <8 x double> poison, double %.3708, i64 0
  %.116.i = shufflevector <8 x double> %.115.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.120.i = insertelement <8 x double> poison, double %.3742, i64 0
  %.121.i = shufflevector <8 x double> %.120.i, <8 x double> poison, <8 x i32> zeroinitializer
  br i1 %.212254.not.i, label %B75808, label %B164.lr.ph.i

B164.lr.ph.i:                                     ; preds = %B1353
  %.6.i.i = insertelement <8 x double> poison, double %.3288, i64 0
  %.7.i.i = shufflevector <8 x double> %.6.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.6.i280.i = fsub contract <8 x double> zeroinitializer, %.121.i
  %7 = icmp eq i64 %number.2.1, 0
  br label %B164.i

B164.i:                                           ; preds = %B76871.i, %B164.lr.ph.i
  %lsr.iv.i = phi i64 [ %.269.i, %B164.lr.ph.i ], [ %lsr.iv.next.i, %B76871.i ]
  %.202.sroa.0.0260.i = phi i64 [ 0, %B164.lr.ph.i ], [ %.202.sroa.0.0.i, %B76871.i ]
  %.218708258.i = phi i64 [ 8, %B164.lr.ph.i ], [ %.218708.i, %B76871.i ]
  %.268.i = getelementptr inbounds double, ptr %arg.state.10.1.4, i64 %.202.sroa.0.0260.i
  %.270.i = load <8 x double>, ptr %.268.i, align 8, !noalias !159
  %.8.i.i = fmul contract <8 x double> %.7.i.i, %.270.i
  %.302.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i.i, <8 x double> splat (double 0x3FE45F306DC9C883), <8 x double> splat (double 0x4338000000000000))
  %.8.i262.i = fadd contract <8 x double> %.302.i, splat (double 0xC338000000000000)
  %.343.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i262.i, <8 x double> splat (double 0xBFF921FB54442D18), <8 x double> %.8.i.i)
  %.360.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i262.i, <8 x double> splat (double 0xBC91A62633145C07), <8 x double> %.343.i)
  %.6.i263.i = fmul contract <8 x double> %.360.i, %.360.i
  %.6.i264.i = fmul contract <8 x double> %.360.i, %.6.i263.i
  %.389.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i263.i, <8 x double> splat (double 0xBD6AE7F3E733B81F), <8 x double> splat (double 0x3DE6124613A86D09))
  %.392.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i263.i, <8 x double> %.389.i, <8 x double> splat (double 0xBE5AE64567F544E4))
  %.395.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i263.i, <8 x double> %.392.i, <8 x double> splat (double 0x3EC71DE3A556C734))
  %.398.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i263.i, <8 x double> %.395.i, <8 x double> splat (double 0xBF2A01A01A01A01A))
  %.401.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i263.i, <8 x double> %.398.i, <8 x double> splat (double 0x3F81111111111111))
  %.404.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i263.i, <8 x double> %.401.i, <8 x double> splat (double 0xBFC5555555555555))
  %.429.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i264.i, <8 x double> %.404.i, <8 x double> %.360.i)
  %.434.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i263.i, <8 x double> splat (double 0x3D2AE7F3E733B81F), <8 x double> splat (double 0xBDA93974A8C07C9D))
  %.437.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i263.i, <8 x double> %.434.i, <8 x double> splat (double 0x3E21EED8EFF8D898))
  %.440.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i263.i, <8 x double> %.437.i, <8 x double> splat (double 0xBE927E4FB7789F5C))
  %.443.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i263.i, <8 x double> %.440.i, <8 x double> splat (double 0x3EFA01A01A01A01A))
  %.446.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i263.i, <8 x double> %.443.i, <8 x double> splat (double 0xBF56C16C16C16C17))
  %.449.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i263.i, <8 x double> %.446.i, <8 x double> splat (double 0x3FA5555555555555))
  %.452.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i263.i, <8 x double> %.449.i, <8 x double> splat (double -5.000000e-01))
  %.455.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i263.i, <8 x double> %.452.i, <8 x double> splat (double 1.000000e+00))
  %.456.i = bitcast <8 x double> %.302.i to <8 x i64>
  %.457.i = bitcast <8 x double> %.429.i to <8 x i64>
  %.458.i = bitcast <8 x double> %.455.i to <8 x i64>
  %.6.i265.i = xor <8 x i64> %.458.i, %.457.i
  %.8.i266.i = and <8 x i64> %.456.i, splat (i64 1)
  %8 = icmp eq <8 x i64> %.8.i266.i, zeroinitializer
  %.6.i268.i = select <8 x i1> %8, <8 x i64> zeroinitializer, <8 x i64> %.6.i265.i
  %.8.i269.i = shl <8 x i64> %.456.i, splat (i64 62)
  %.8.i270.i = and <8 x i64> %.8.i269.i, splat (i64 -9223372036854775808)
  %.8.i272.i = add <8 x i64> %.8.i269.i, splat (i64 4611686018427387904)
  %.8.i273.i = and <8 x i64> %.8.i272.i, splat (i64 -9223372036854775808)
  %9 = xor <8 x i64> %.8.i270.i, %.457.i
  %.6.i275.i = xor <8 x i64> %9, %.6.i268.i
  %10 = bitcast <8 x i64> %.6.i275.i to <8 x double>
  %11 = xor <8 x i64> %.8.i273.i, %.458.i
  %.6.i277.i = xor <8 x i64> %11, %.6.i268.i
  %12 = bitcast <8 x i64> %.6.i277.i to <8 x double>
  %.799.i = getelementptr inbounds double, ptr %arg.state.10.0.4, i64 %.202.sroa.0.0260.i
  %.801.i = load <8 x double>, ptr %.799.i, align 8, !noalias !159
  %.6.i278.i = fmul contract <8 x double> %.801.i, %12
  %.6.i279.i = fmul contract <8 x double> %.801.i, %10
  br i1 %7, label %B76871.i, label %B248.i

B248.i:                                           ; preds = %B164.i
  %.1010.i = getelementptr inbounds double, ptr %arg.state.11.0.4, i64 %.202.sroa.0.0260.i
  %.1012.i = load <8 x double>, ptr %.1010.i, align 8, !noalias !159
  %.1028.i = getelementptr inbounds double, ptr %arg.state.11.1.4, i64 %.202.sroa.0.0260.i
  %.1030.i = load <8 x double>, ptr %.1028.i, align 8, !noalias !159
  %.1046.i = getelementptr inbounds double, ptr %arg.state.11.2.4, i64 %.202.sroa.0.0260.i
  %.1048.i = load <8 x double>, ptr %.1046.i, align 8, !noalias !159
  %.1064.i = getelementptr inbounds double, ptr %arg.state.11.3.4, i64 %.202.sroa.0.0260.i
  %.1066.i = load <8 x double>, ptr %.1064.i, align 8, !noalias !159
  br label %B76871.i

B76871.i:                                         ; preds = %B248.i, %B164.i
  %_add_v369_first.2.1.i = phi <8 x double> [ zeroinitializer, %B164.i ], [ %.1012.i, %B248.i ]
  %_add_v369_second.2.1.i = phi <8 x double> [ zeroinitializer, %B164.i ], [ %.1030.i, %B248.i ]
  %_add_v369_third.2.1.i = phi <8 x double> [ zeroinitializer, %B164.i ], [ %.1048.i, %B248.i ]
  %_add_v369_fourth.2.1.i = phi <8 x double> [ zeroinitializer, %B164.i ], [ %.1066.i, %B248.i ]
  %.1140.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i279.i, <8 x double> zeroinitializer, <8 x double> %_add_v369_first.2.1.i)
  %.1144.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i278.i, <8 x double> %.116.i, <8 x double> %.1140.i)
  %.1152.i = getelementptr inbounds double, ptr %arg.state.11.0.4, i64 %.202.sroa.0.0260.i
  store <8 x double> %.1144.i, ptr %.1152.i, align 8, !noalias !159
  %.1173.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i279.i, <8 x double> %.116.i, <8 x double> %_add_v369_second.2.1.i)
  %.1177.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i278.i, <8 x double> zeroinitializer, <8 x double> %.1173.i)
  %.1185.i = getelementptr inbounds double, ptr %arg.state.11.1.4, i64 %.202.sroa.0.0260.i
  store <8 x double> %.1177.i, ptr %.1185.i, align 8, !noalias !159
  %.1254.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i279.i, <8 x double> %.6.i280.i, <8 x double> %_add_v369_third.2.1.i)
  %.1258.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i278.i, <8 x double> zeroinitializer, <8 x double> %.1254.i)
  %.1266.i = getelementptr inbounds double, ptr %arg.state.11.2.4, i64 %.202.sroa.0.0260.i
  store <8 x double> %.1258.i, ptr %.1266.i, align 8, !noalias !159
  %.1331.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i279.i, <8 x double> zeroinitializer, <8 x double> %_add_v369_fourth.2.1.i)
  %.1337.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i278.i, <8 x double> %.121.i, <8 x double> %.1331.i)
  %.1347.i = getelementptr inbounds double, ptr %arg.state.11.3.4, i64 %.202.sroa.0.0260.i
  store <8 x double> %.1337.i, ptr %.1347.i, align 8, !noalias !159
  %.212.i = icmp samesign ugt i64 %lsr.iv.i, 1
  %.225.i = add i64 %.218708258.i, 8
  %.218708.i = select i1 %.212.i, i64 %.225.i, i64 %.218708258.i
  %.202.sroa.0.0.i = select i1 %.212.i, i64 %.218708258.i, i64 0
  %lsr.iv.next.i = add nsw i64 %lsr.iv.i, -1
  %B164.termcond.i = icmp sgt i64 %lsr.iv.i, 1
  br i1 %B164.termcond.i, label %B164.i, label %B75808

B18307:                                           ; preds = %B820, %B1352
  %mode.2.sroa.52.3 = phi ptr [ %.3795, %B1352 ], [ %.1646, %B820 ]
  %k.7.3 = phi i64 [ %.3759, %B1352 ], [ %k.6.1, %B820 ]
  %own.3.sroa.14.3 = phi double [ %.3742, %B1352 ], [ 0.000000e+00, %B820 ]
  %own.3.sroa.0.3 = phi double [ %.3708, %B1352 ], [ 0.000000e+00, %B820 ]
  %.4336 = getelementptr i8, ptr %mode.2.sroa.52.3, i64 24
  %.4337 = load i64, ptr %.4336, align 8
  %.4338 = inttoptr i64 %.4337 to ptr
  %.4414 = getelementptr i8, ptr %mode.2.sroa.52.3, i64 40
  %.4415 = load i64, ptr %.4414, align 8
  %.4416 = inttoptr i64 %.4415 to ptr
  %.4498 = getelementptr i8, ptr %.4338, i64 64
  %.4499 = load i64, ptr %.4498, align 8
  %.4500 = sub i64 0, %.4499
  %.4508.1 = and i64 %.4500, -8
  %.4542 = sub i64 0, %.4508.1
  %.4571 = getelementptr i8, ptr %mode.2.sroa.52.3, i64 48
  %.4572 = load i64, ptr %.4571, align 8
  %.4576 = ashr i64 %.4572, 1
  %.4589 = getelementptr inbounds double, ptr %arg.state.13.4, i64 %.4576
  %.4641 = shl nsw i64 %.4542, 2
  %.4714 = getelementptr inbounds double, ptr %.4589, i64 %.4641
  %.4792.idx = shl i64 %.4542, 6
  %.4792 = getelementptr i8, ptr %.4589, i64 %.4792.idx
  %.4939 = getelementptr i8, ptr %.4338, i64 120
  %.4940 = load i64, ptr %.4939, align 8
  %.4953 = getelementptr inbounds double, ptr %.4416, i64 %.4940
  %.5316 = getelementptr i8, ptr %mode.2.sroa.52.3, i64 56
  %.5317 = load i64, ptr %.5316, align 8
  %.idx9139 = mul i64 %.5317, 72
  %13 = getelementptr i8, ptr %.526, i64 %.idx9139
  %.5440 = getelementptr i8, ptr %13, i64 72
  %.5441 = load i64, ptr %.5440, align 8
  %.5442 = inttoptr i64 %.5441 to ptr
  %.5602 = getelementptr i8, ptr %.5442, i64 64
  %.5603 = load i64, ptr %.5602, align 8
  %.5675 = getelementptr i8, ptr %13, i64 96
  %.5676 = load i64, ptr %.5675, align 8
  %.5680 = ashr i64 %.5676, 1
  %.5693 = getelementptr inbounds double, ptr %arg.state.13.4, i64 %.5680
  %.neg = mul i64 %.5603, -64
  %14 = and i64 %.neg, -512
  %.5896.idx = sub i64 0, %14
  %.5896 = getelementptr i8, ptr %.5693, i64 %.5896.idx
  %.5963 = getelementptr i8, ptr %.5896, i64 64
  %.6313 = mul nsw i64 %.4641, %arg.lane
  %15 = getelementptr double, ptr %arg.state.4.4, i64 %.4572
  %.6329 = getelementptr double, ptr %15, i64 %.6313
  %.6410 = shl nsw i64 %.4542, 1
  %.6453.inv = icmp sgt i64 %.4499, 0
  %.6454 = select i1 %.6453.inv, i64 0, i64 %.4641
  %16 = getelementptr double, ptr %.6329, i64 %.4499
  %17 = getelementptr i8, ptr %16, i64 -8
  %.6468 = getelementptr double, ptr %17, i64 %.6454
  %.6469 = load double, ptr %.6468, align 8
  %.6472 = add nsw i64 %.6410, %.4499
  %.6486.inv = icmp sgt i64 %.6472, 0
  %.6487 = select i1 %.6486.inv, i64 0, i64 %.4641
  %18 = getelementptr double, ptr %.6329, i64 %.6472
  %19 = getelementptr i8, ptr %18, i64 -8
  %.6501 = getelementptr double, ptr %19, i64 %.6487
  %.6502 = load double, ptr %.6501, align 8
  %.6665 = load i64, ptr %.732, align 8
  %.6667 = inttoptr i64 %.6665 to ptr
  %.7183 = load i64, ptr %.665, align 8
  %.7199 = getelementptr double, ptr %.6667, i64 %.7183
  %.7288 = getelementptr i8, ptr %.2624, i64 328
  %.7289 = load double, ptr %.7288, align 8
  %.173.i = load i64, ptr %.4792, align 8, !noalias !162
  %.13.i.i = tail call i64 @llvm.smax.i64(i64 %arg.ends.0, i64 %.173.i)
  %.13.i1.i = tail call i64 @llvm.smin.i64(i64 %arg.ends.1, i64 %.13.i.i)
  %.262.i = getelementptr i8, ptr %.4792, i64 8
  %.263.i = load i64, ptr %.262.i, align 8, !noalias !162
  %.13.i2.i = tail call i64 @llvm.smax.i64(i64 %arg.ends.0, i64 %.263.i)
  %.13.i3.i = tail call i64 @llvm.smin.i64(i64 %arg.ends.1, i64 %.13.i2.i)
  %.330.i = sub nsw i64 %.13.i1.i, %arg.ends.0
  %20 = add i64 %.330.i, 7
  %.389.i2924 = lshr i64 %20, 3
  %.368.inv.i = icmp slt i64 %.330.i, 1
  %.410442.not453.i = icmp eq i64 %.389.i2924, 0
  %.410442.not.i = or i1 %.368.inv.i, %.410442.not453.i
  br i1 %.410442.not.i, label %B348.i, label %B198.if.lr.ph.i

B37577:                                           ; preds = %B37499.endif.endif.endif
  %.idx9141 = mul i64 %.7958, 72
  %sunkaddr3972 = getelementptr i8, ptr %.526, i64 %.idx9141
  %sunkaddr3973 = getelementptr i8, ptr %sunkaddr3972, i64 48
  %.8126 = load i64, ptr %sunkaddr3973, align 8
  %.8128.not = icmp eq i64 %.8126, %.1744
  br i1 %.8128.not, label %B75886, label %B37579

B37579:                                           ; preds = %B37499.endif.endif.endif, %B37577
  %.341.i = insertelement <8 x double> poison, double %.7549, i64 0
  %.342.i = shufflevector <8 x double> %.341.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.594.i = insertelement <8 x double> poison, double %own.3.sroa.0.3, i64 0
  %.595.i = shufflevector <8 x double> %.594.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.596.i = insertelement <8 x double> poison, double %.7907, i64 0
  %.597.i = shufflevector <8 x double> %.596.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.633.i = insertelement <8 x double> poison, double %own.3.sroa.14.3, i64 0
  %.634.i = shufflevector <8 x double> %.633.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.635.i = insertelement <8 x double> poison, double %.7941, i64 0
  %.636.i = shufflevector <8 x double> %.635.i, <8 x double> poison, <8 x i32> zeroinitializer
  br i1 %.290534.not.i, label %B75808, label %B50.lr.ph.i

B50.lr.ph.i:                                      ; preds = %B37579
  %.387.i = add i64 %.7617, -1
  %..387.i = tail call i64 @llvm.smax.i64(i64 %.387.i, i64 0)
  %.6.i.i2743 = insertelement <8 x double> poison, double %.7582, i64 0
  %.7.i.i2744 = shufflevector <8 x double> %.6.i.i2743, <8 x double> poison, <8 x i32> zeroinitializer
  %.6.i399.i = insertelement <8 x double> poison, double %.3288, i64 0
  %.7.i400.i = shufflevector <8 x double> %.6.i399.i, <8 x double> poison, <8 x i32> zeroinitializer
  %xtraiter.i = and i64 %..387.i, 3
  %21 = lshr i64 %..387.i, 2
  %22 = mul nsw i64 %21, -4
  %23 = icmp slt i64 %.387.i, 1
  %24 = icmp eq i64 %number.2.1, 0
  %25 = icmp slt i64 %.387.i, 4
  %26 = icmp eq i64 %xtraiter.i, 0
  br label %B50.i

B50.i:                                            ; preds = %B77337.i, %B50.lr.ph.i
  %.242.sroa.0.0387.i = phi i64 [ 0, %B50.lr.ph.i ], [ %.242.sroa.0.0.i, %B77337.i ]
  %.251937386.i = phi i64 [ %math, %B50.lr.ph.i ], [ %.251937.i, %B77337.i ]
  %.258968385.i = phi i64 [ 8, %B50.lr.ph.i ], [ %.258968.i, %B77337.i ]
  %.311.i = getelementptr inbounds double, ptr %.1177, i64 %.242.sroa.0.0387.i
  %.313.i = load <8 x double>, ptr %.311.i, align 8, !noalias !165
  %.8.i.i2745 = fmul contract <8 x double> %.7.i.i2744, %.313.i
  %.343.i2746 = tail call <8 x double> @llvm.minnum.v8f64(<8 x double> %.8.i.i2745, <8 x double> %.342.i)
  br i1 %23, label %B77170.i, label %B512.if.preheader.i

B512.if.preheader.i:                              ; preds = %B50.i
  br i1 %25, label %B512.if.epil.i.preheader, label %B512.if.i

B77170.loopexit.unr-lcssa.i:                      ; preds = %B512.if.i
  br i1 %26, label %B77170.i, label %B512.if.epil.i.preheader

B512.if.epil.i.preheader:                         ; preds = %B77170.loopexit.unr-lcssa.i, %B512.if.preheader.i
  %_velocity_v374_w.2.1934.epil.i.ph = phi <8 x double> [ %.343.i2746, %B512.if.preheader.i ], [ %.6.i391.3.i, %B77170.loopexit.unr-lcssa.i ]
  br label %B512.if.epil.i

B512.if.epil.i:                                   ; preds = %B512.if.epil.i.preheader, %B512.if.epil.i
  %lsr.iv426.i = phi i64 [ %lsr.iv.next427.i, %B512.if.epil.i ], [ %xtraiter.i, %B512.if.epil.i.preheader ]
  %_velocity_v374_w.2.1934.epil.i = phi <8 x double> [ %.6.i391.epil.i, %B512.if.epil.i ], [ %_velocity_v374_w.2.1934.epil.i.ph, %B512.if.epil.i.preheader ]
  %.6.i391.epil.i = fmul contract <8 x double> %.343.i2746, %_velocity_v374_w.2.1934.epil.i
  %lsr.iv.next427.i = add nsw i64 %lsr.iv426.i, -1
  %epil.iter.cmp.not.i = icmp eq i64 %lsr.iv.next427.i, 0
  br i1 %epil.iter.cmp.not.i, label %B77170.i, label %B512.if.epil.i, !llvm.loop !168

B77170.i:                                         ; preds = %B512.if.epil.i, %B77170.loopexit.unr-lcssa.i, %B50.i
  %_velocity_v374_w.2.1.lcssa.i = phi <8 x double> [ %.343.i2746, %B50.i ], [ %.6.i391.3.i, %B77170.loopexit.unr-lcssa.i ], [ %.6.i391.epil.i, %B512.if.epil.i ]
  %.518.i = getelementptr inbounds double, ptr %arg.state.10.2.4, i64 %.242.sroa.0.0387.i
  %.520.i = load <8 x double>, ptr %.518.i, align 8, !noalias !165
  %.6.i389.i = fmul contract <8 x double> %_velocity_v374_w.2.1.lcssa.i, %.520.i
  %.560.i = getelementptr inbounds double, ptr %arg.state.10.3.4, i64 %.242.sroa.0.0387.i
  %.562.i = load <8 x double>, ptr %.560.i, align 8, !noalias !165
  %.6.i392.i = fmul contract <8 x double> %_velocity_v374_w.2.1.lcssa.i, %.562.i
  %.598.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i389.i, <8 x double> %.597.i, <8 x double> %.595.i)
  %.8.i395.i = fmul contract <8 x double> %.597.i, %.6.i392.i
  %.637.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i389.i, <8 x double> %.636.i, <8 x double> %.634.i)
  %.8.i398.i = fmul contract <8 x double> %.636.i, %.6.i392.i
  %.687.i = getelementptr inbounds double, ptr %arg.state.10.1.4, i64 %.242.sroa.0.0387.i
  %.689.i = load <8 x double>, ptr %.687.i, align 8, !noalias !165
  %.8.i401.i = fmul contract <8 x double> %.7.i400.i, %.689.i
  %.721.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i401.i, <8 x double> splat (double 0x3FE45F306DC9C883), <8 x double> splat (double 0x4338000000000000))
  %.8.i402.i = fadd contract <8 x double> %.721.i, splat (double 0xC338000000000000)
  %.762.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i402.i, <8 x double> splat (double 0xBFF921FB54442D18), <8 x double> %.8.i401.i)
  %.779.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i402.i, <8 x double> splat (double 0xBC91A62633145C07), <8 x double> %.762.i)
  %.6.i403.i = fmul contract <8 x double> %.779.i, %.779.i
  %.6.i404.i = fmul contract <8 x double> %.779.i, %.6.i403.i
  %.808.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i403.i, <8 x double> splat (double 0xBD6AE7F3E733B81F), <8 x double> splat (double 0x3DE6124613A86D09))
  %.811.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i403.i, <8 x double> %.808.i, <8 x double> splat (double 0xBE5AE64567F544E4))
  %.814.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i403.i, <8 x double> %.811.i, <8 x double> splat (double 0x3EC71DE3A556C734))
  %.817.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i403.i, <8 x double> %.814.i, <8 x double> splat (double 0xBF2A01A01A01A01A))
  %.820.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i403.i, <8 x double> %.817.i, <8 x double> splat (double 0x3F81111111111111))
  %.823.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i403.i, <8 x double> %.820.i, <8 x double> splat (double 0xBFC5555555555555))
  %.848.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i404.i, <8 x double> %.823.i, <8 x double> %.779.i)
  %.853.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i403.i, <8 x double> splat (double 0x3D2AE7F3E733B81F), <8 x double> splat (double 0xBDA93974A8C07C9D))
  %.856.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i403.i, <8 x double> %.853.i, <8 x double> splat (double 0x3E21EED8EFF8D898))
  %.859.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i403.i, <8 x double> %.856.i, <8 x double> splat (double 0xBE927E4FB7789F5C))
  %.862.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i403.i, <8 x double> %.859.i, <8 x double> splat (double 0x3EFA01A01A01A01A))
  %.865.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i403.i, <8 x double> %.862.i, <8 x double> splat (double 0xBF56C16C16C16C17))
  %.868.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i403.i, <8 x double> %.865.i, <8 x double> splat (double 0x3FA5555555555555))
  %.871.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i403.i, <8 x double> %.868.i, <8 x double> splat (double -5.000000e-01))
  %.874.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i403.i, <8 x double> %.871.i, <8 x double> splat (double 1.000000e+00))
  %.875.i = bitcast <8 x double> %.721.i to <8 x i64>
  %.876.i = bitcast <8 x double> %.848.i to <8 x i64>
  %.877.i = bitcast <8 x double> %.874.i to <8 x i64>
  %.6.i405.i = xor <8 x i64> %.877.i, %.876.i
  %.8.i406.i = and <8 x i64> %.875.i, splat (i64 1)
  %27 = icmp eq <8 x i64> %.8.i406.i, zeroinitializer
  %.6.i408.i = select <8 x i1> %27, <8 x i64> zeroinitializer, <8 x i64> %.6.i405.i
  %.8.i409.i = shl <8 x i64> %.875.i, splat (i64 62)
  %.8.i410.i = and <8 x i64> %.8.i409.i, splat (i64 -9223372036854775808)
  %.8.i412.i = add <8 x i64> %.8.i409.i, splat (i64 4611686018427387904)
  %.8.i413.i = and <8 x i64> %.8.i412.i, splat (i64 -9223372036854775808)
  %28 = xor <8 x i64> %.8.i410.i, %.876.i
  %.6.i415.i = xor <8 x i64> %28, %.6.i408.i
  %29 = bitcast <8 x i64> %.6.i415.i to <8 x double>
  %30 = xor <8 x i64> %.8.i413.i, %.877.i
  %.6.i417.i = xor <8 x i64> %30, %.6.i408.i
  %31 = bitcast <8 x i64> %.6.i417.i to <8 x double>
  %.1218.i = getelementptr inbounds double, ptr %arg.state.10.0.4, i64 %.242.sroa.0.0387.i
  %.1220.i = load <8 x double>, ptr %.1218.i, align 8, !noalias !165
  %.6.i418.i = fmul contract <8 x double> %.1220.i, %31
  %.6.i419.i = fmul contract <8 x double> %.1220.i, %29
  br i1 %24, label %B77337.i, label %B77184.i

B77184.i:                                         ; preds = %B77170.i
  %.1420.i = getelementptr inbounds double, ptr %arg.state.11.0.4, i64 %.242.sroa.0.0387.i
  %.1422.i = load <8 x double>, ptr %.1420.i, align 8, !noalias !165
  %.1438.i = getelementptr inbounds double, ptr %arg.state.11.1.4, i64 %.242.sroa.0.0387.i
  %.1440.i = load <8 x double>, ptr %.1438.i, align 8, !noalias !165
  %.1456.i = getelementptr inbounds double, ptr %arg.state.11.2.4, i64 %.242.sroa.0.0387.i
  %.1458.i = load <8 x double>, ptr %.1456.i, align 8, !noalias !165
  %.1474.i = getelementptr inbounds double, ptr %arg.state.11.3.4, i64 %.242.sroa.0.0387.i
  %.1476.i = load <8 x double>, ptr %.1474.i, align 8, !noalias !165
  br label %B77337.i

B77337.i:                                         ; preds = %B77184.i, %B77170.i
  %_add_v377_first.2.1.i = phi <8 x double> [ zeroinitializer, %B77170.i ], [ %.1422.i, %B77184.i ]
  %_add_v377_second.2.1.i = phi <8 x double> [ zeroinitializer, %B77170.i ], [ %.1440.i, %B77184.i ]
  %_add_v377_third.2.1.i = phi <8 x double> [ zeroinitializer, %B77170.i ], [ %.1458.i, %B77184.i ]
  %_add_v377_fourth.2.1.i = phi <8 x double> [ zeroinitializer, %B77170.i ], [ %.1476.i, %B77184.i ]
  %.6.i390.i = fsub contract <8 x double> zeroinitializer, %.8.i395.i
  %.1550.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i419.i, <8 x double> %.6.i390.i, <8 x double> %_add_v377_first.2.1.i)
  %.1554.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i418.i, <8 x double> %.598.i, <8 x double> %.1550.i)
  %.1562.i = getelementptr inbounds double, ptr %arg.state.11.0.4, i64 %.242.sroa.0.0387.i
  store <8 x double> %.1554.i, ptr %.1562.i, align 8, !noalias !165
  %.1583.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i419.i, <8 x double> %.598.i, <8 x double> %_add_v377_second.2.1.i)
  %.1587.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i418.i, <8 x double> %.8.i395.i, <8 x double> %.1583.i)
  %.1595.i = getelementptr inbounds double, ptr %arg.state.11.1.4, i64 %.242.sroa.0.0387.i
  store <8 x double> %.1587.i, ptr %.1595.i, align 8, !noalias !165
  %.6.i420.i = fsub contract <8 x double> zeroinitializer, %.8.i398.i
  %.6.i421.i = fsub contract <8 x double> zeroinitializer, %.637.i
  %.1664.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i419.i, <8 x double> %.6.i421.i, <8 x double> %_add_v377_third.2.1.i)
  %.1668.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i418.i, <8 x double> %.6.i420.i, <8 x double> %.1664.i)
  %.1676.i = getelementptr inbounds double, ptr %arg.state.11.2.4, i64 %.242.sroa.0.0387.i
  store <8 x double> %.1668.i, ptr %.1676.i, align 8, !noalias !165
  %.1741.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i419.i, <8 x double> %.6.i420.i, <8 x double> %_add_v377_fourth.2.1.i)
  %.1747.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i418.i, <8 x double> %.637.i, <8 x double> %.1741.i)
  %.1757.i = getelementptr inbounds double, ptr %arg.state.11.3.4, i64 %.242.sroa.0.0387.i
  store <8 x double> %.1747.i, ptr %.1757.i, align 8, !noalias !165
  %.252.i = icmp sgt i64 %.251937386.i, 0
  %.265.i = add i64 %.258968385.i, 8
  %.258968.i = select i1 %.252.i, i64 %.265.i, i64 %.258968385.i
  %.261.i = sext i1 %.252.i to i64
  %.251937.i = add nsw i64 %.251937386.i, %.261.i
  %.242.sroa.0.0.i = select i1 %.252.i, i64 %.258968385.i, i64 0
  br i1 %.252.i, label %B50.i, label %B75808

B512.if.i:                                        ; preds = %B512.if.preheader.i, %B512.if.i
  %lsr.iv80 = phi i64 [ %lsr.iv.next81, %B512.if.i ], [ %22, %B512.if.preheader.i ]
  %_velocity_v374_w.2.1934.i = phi <8 x double> [ %.6.i391.3.i, %B512.if.i ], [ %.343.i2746, %B512.if.preheader.i ]
  %.6.i391.i = fmul contract <8 x double> %.343.i2746, %_velocity_v374_w.2.1934.i
  %.6.i391.1.i = fmul contract <8 x double> %.343.i2746, %.6.i391.i
  %.6.i391.2.i = fmul contract <8 x double> %.343.i2746, %.6.i391.1.i
  %.6.i391.3.i = fmul contract <8 x double> %.343.i2746, %.6.i391.2.i
  %lsr.iv.next81 = add nsw i64 %lsr.iv80, 4
  %niter.ncmp.3.i = icmp eq i64 %lsr.iv.next81, 0
  br i1 %niter.ncmp.3.i, label %B77170.loopexit.unr-lcssa.i, label %B512.if.i

B75808:                                           ; preds = %B77337.i, %B76871.i, %B37579, %B1353
  %k.5.1 = phi i64 [ %.3759, %B76871.i ], [ %.3759, %B1353 ], [ %.7958, %B37579 ], [ %.7958, %B77337.i ]
  %.1616 = load i64, ptr %.526, align 8
  %.1618 = icmp slt i64 %k.5.1, %.1616
  br i1 %.1618, label %B820.backedge, label %B76211

B820.backedge:                                    ; preds = %B75808, %_ZN17bnserve_surrogate6kernel5modes5_sums13add_two_modesB4v378B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExbd5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi2EE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi2EE5ArrayIdLi1E1C7mutable7alignedE5TupleIddxE8UniTupleIxLi2EE8UniTupleIdLi2EE8UniTupleIdLi2EE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi4EE.exit
  %k.6.1.be = phi i64 [ %.12153, %_ZN17bnserve_surrogate6kernel5modes5_sums13add_two_modesB4v378B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExbd5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi2EE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi2EE5ArrayIdLi1E1C7mutable7alignedE5TupleIddxE8UniTupleIxLi2EE8UniTupleIdLi2EE8UniTupleIdLi2EE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi4EE.exit ], [ %k.5.1, %B75808 ]
  br label %B820

B75886:                                           ; preds = %B37577
  %sunkaddr92 = getelementptr i8, ptr %sunkaddr3972, i64 72
  %.8530 = load i64, ptr %sunkaddr92, align 8
  %.8531 = inttoptr i64 %.8530 to ptr
  %sunkaddr96 = getelementptr i8, ptr %sunkaddr3972, i64 88
  %.8608 = load i64, ptr %sunkaddr96, align 8
  %.8609 = inttoptr i64 %.8608 to ptr
  %.8691 = getelementptr i8, ptr %.8531, i64 64
  %.8692 = load i64, ptr %.8691, align 8
  %.8693 = sub i64 0, %.8692
  %.8701.1 = and i64 %.8693, -8
  %.8735 = sub i64 0, %.8701.1
  %sunkaddr101 = getelementptr i8, ptr %sunkaddr3972, i64 96
  %.8765 = load i64, ptr %sunkaddr101, align 8
  %.8769 = ashr i64 %.8765, 1
  %.8782 = getelementptr inbounds double, ptr %arg.state.13.4, i64 %.8769
  %.8834 = shl nsw i64 %.8735, 2
  %.8907 = getelementptr inbounds double, ptr %.8782, i64 %.8834
  %.8985.idx = shl i64 %.8735, 6
  %.8985 = getelementptr i8, ptr %.8782, i64 %.8985.idx
  %.9132 = getelementptr i8, ptr %.8531, i64 120
  %.9133 = load i64, ptr %.9132, align 8
  %.9146 = getelementptr inbounds double, ptr %.8609, i64 %.9133
  %sunkaddr104 = getelementptr i8, ptr %sunkaddr3972, i64 104
  %.9510 = load i64, ptr %sunkaddr104, align 8
  %.idx9142 = mul i64 %.9510, 72
  %32 = getelementptr i8, ptr %.526, i64 %.idx9142
  %.9633 = getelementptr i8, ptr %32, i64 72
  %.9634 = load i64, ptr %.9633, align 8
  %.9635 = inttoptr i64 %.9634 to ptr
  %.9795 = getelementptr i8, ptr %.9635, i64 64
  %.9796 = load i64, ptr %.9795, align 8
  %.9868 = getelementptr i8, ptr %32, i64 96
  %.9869 = load i64, ptr %.9868, align 8
  %.9873 = ashr i64 %.9869, 1
  %.9886 = getelementptr inbounds double, ptr %arg.state.13.4, i64 %.9873
  %.neg3824 = mul i64 %.9796, -64
  %33 = and i64 %.neg3824, -512
  %.10089.idx = sub i64 0, %33
  %.10089 = getelementptr i8, ptr %.9886, i64 %.10089.idx
  %.10156 = getelementptr i8, ptr %.10089, i64 64
  %.10506 = mul nsw i64 %.8834, %arg.lane
  %34 = getelementptr double, ptr %arg.state.4.4, i64 %.8765
  %.10522 = getelementptr double, ptr %34, i64 %.10506
  %.10603 = shl nsw i64 %.8735, 1
  %.10646.inv = icmp sgt i64 %.8692, 0
  %.10647 = select i1 %.10646.inv, i64 0, i64 %.8834
  %35 = getelementptr double, ptr %.10522, i64 %.8692
  %36 = getelementptr i8, ptr %35, i64 -8
  %.10661 = getelementptr double, ptr %36, i64 %.10647
  %.10662 = load double, ptr %.10661, align 8
  %.10665 = add nsw i64 %.10603, %.8692
  %.10679.inv = icmp sgt i64 %.10665, 0
  %.10680 = select i1 %.10679.inv, i64 0, i64 %.8834
  %37 = getelementptr double, ptr %.10522, i64 %.10665
  %38 = getelementptr i8, ptr %37, i64 -8
  %.10694 = getelementptr double, ptr %38, i64 %.10680
  %.10695 = load double, ptr %.10694, align 8
  %.10858 = load i64, ptr %.732, align 8
  %.10860 = inttoptr i64 %.10858 to ptr
  %.11381 = load i64, ptr %.665, align 8
  %.11397 = getelementptr double, ptr %.10860, i64 %.11381
  %.11487 = load double, ptr %.7288, align 8
  %.173.i3055 = load i64, ptr %.8985, align 8, !noalias !169
  %.13.i.i3056 = tail call i64 @llvm.smax.i64(i64 %arg.ends.0, i64 %.173.i3055)
  %.13.i1.i3057 = tail call i64 @llvm.smin.i64(i64 %arg.ends.1, i64 %.13.i.i3056)
  %.262.i3058 = getelementptr i8, ptr %.8985, i64 8
  %.263.i3059 = load i64, ptr %.262.i3058, align 8, !noalias !169
  %.13.i2.i3060 = tail call i64 @llvm.smax.i64(i64 %arg.ends.0, i64 %.263.i3059)
  %.13.i3.i3061 = tail call i64 @llvm.smin.i64(i64 %arg.ends.1, i64 %.13.i2.i3060)
  %.330.i3062 = sub nsw i64 %.13.i1.i3057, %arg.ends.0
  %39 = add i64 %.330.i3062, 7
  %.389.i3063 = lshr i64 %39, 3
  %.368.inv.i3064 = icmp slt i64 %.330.i3062, 1
  %.410442.not453.i3065 = icmp eq i64 %.389.i3063, 0
  %.410442.not.i3066 = or i1 %.368.inv.i3064, %.410442.not453.i3065
  br i1 %.410442.not.i3066, label %B348.i3105, label %B198.if.lr.ph.i3067

B76211:                                           ; preds = %_ZN17bnserve_surrogate6kernel5modes5_sums13add_two_modesB4v378B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExbd5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi2EE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi2EE5ArrayIdLi1E1C7mutable7alignedE5TupleIddxE8UniTupleIxLi2EE8UniTupleIdLi2EE8UniTupleIdLi2EE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi4EE.exit, %B75808, %entry
  store ptr null, ptr %.12445, align 8
  call fastcc void @inner_26(ptr nonnull %.12445, i64 %arg.i, i64 %arg.ends.0, i64 %arg.ends.2, ptr %arg.state.0.4, i64 %.580, ptr %arg.state.11.0.4, ptr %arg.state.11.1.4, ptr %arg.state.11.2.4, ptr %arg.state.11.3.4, ptr %arg.state.14.4)
  store ptr null, ptr %retptr, align 8
  ret void

B820.preheader.lr.ph:                             ; preds = %entry
  %.13.i = tail call i64 @llvm.smax.i64(i64 %arg.state.5.1, i64 %arg.state.5.0)
  %.2612 = add nsw i64 %.13.i, 64
  %40 = add i64 %.580, 7
  %.269.i = lshr i64 %40, 3
  %.246.inv.i = icmp slt i64 %.580, 1
  %41 = tail call { i64, i1 } @llvm.usub.with.overflow.i64(i64 %.269.i, i64 1)
  %math = extractvalue { i64, i1 } %41, 0
  %ov = extractvalue { i64, i1 } %41, 1
  %.290534.not.i = select i1 %.246.inv.i, i1 true, i1 %ov
  %.212254.not261.i = icmp eq i64 %.269.i, 0
  %.212254.not.i = or i1 %.246.inv.i, %.212254.not261.i
  %scevgep3904 = getelementptr i8, ptr %arg.state.13.4, i64 72
  %42 = mul i64 %arg.ends.0, -8
  %scevgep3909 = getelementptr i8, ptr %arg.state.10.3.4, i64 %42
  %scevgep3911 = getelementptr i8, ptr %arg.state.10.2.4, i64 %42
  %scevgep3946 = getelementptr i8, ptr %arg.state.10.5.4, i64 %42
  %scevgep3948 = getelementptr i8, ptr %arg.state.10.4.4, i64 %42
  %sunkaddr83 = getelementptr i8, ptr %arg.state.0.4, i64 136
  %sunkaddr85 = getelementptr i8, ptr %arg.state.0.4, i64 144
  %sunkaddr142 = getelementptr i8, ptr %.526, i64 16
  %sunkaddr143 = getelementptr i8, ptr %arg.state.0.4, i64 136
  %sunkaddr144 = getelementptr i8, ptr %arg.state.0.4, i64 144
  br label %B820

B348.loopexit.unr-lcssa.i:                        ; preds = %B198.if.i
  %lcmp.mod.not.i = icmp eq i64 %xtraiter.i2925, 0
  br i1 %lcmp.mod.not.i, label %B348.i, label %B198.if.epil.preheader.i

B198.if.epil.preheader.i:                         ; preds = %B198.if.lr.ph.i, %B348.loopexit.unr-lcssa.i
  %.416441443.epil.init.i = phi i64 [ 0, %B198.if.lr.ph.i ], [ %.423.3.i, %B348.loopexit.unr-lcssa.i ]
  %43 = shl i64 %.416441443.epil.init.i, 3
  %scevgep51.i = getelementptr i8, ptr %arg.state.10.3.4, i64 %43
  %scevgep55.i = getelementptr i8, ptr %arg.state.10.2.4, i64 %43
  %44 = shl nuw nsw i64 %xtraiter.i2925, 6
  br label %B198.if.epil.i

B198.if.epil.i:                                   ; preds = %B198.if.epil.i, %B198.if.epil.preheader.i
  %lsr.iv52.i = phi i64 [ %lsr.iv.next53.i, %B198.if.epil.i ], [ 0, %B198.if.epil.preheader.i ]
  %scevgep56.i = getelementptr i8, ptr %scevgep55.i, i64 %lsr.iv52.i
  store <8 x double> %.451.i, ptr %scevgep56.i, align 8, !noalias !162
  %scevgep54.i = getelementptr i8, ptr %scevgep51.i, i64 %lsr.iv52.i
  store <8 x double> %.465.i, ptr %scevgep54.i, align 8, !noalias !162
  %lsr.iv.next53.i = add nuw nsw i64 %lsr.iv52.i, 64
  %epil.iter.cmp.not.i2927 = icmp eq i64 %44, %lsr.iv.next53.i
  br i1 %epil.iter.cmp.not.i2927, label %B348.i, label %B198.if.epil.i, !llvm.loop !172

B348.i:                                           ; preds = %B198.if.epil.i, %B348.loopexit.unr-lcssa.i, %B18307
  %.487.i = sub nsw i64 %.13.i3.i, %arg.ends.0
  %sunkaddr109 = getelementptr i8, ptr %.4792, i64 16
  %.653.i = load i64, ptr %sunkaddr109, align 8, !noalias !162
  %.126.i.i = icmp slt i64 %.13.i.i, %.13.i3.i
  br i1 %.126.i.i, label %B22.preheader.i.i, label %B348.endif.endif.endif.i

B198.if.lr.ph.i:                                  ; preds = %B18307
  %45 = getelementptr double, ptr %.6329, i64 %.6410
  %.6423 = icmp slt i64 %.4542, 0
  %.6424 = select i1 %.6423, i64 %.4641, i64 0
  %.6438 = getelementptr double, ptr %45, i64 %.6424
  %.6439 = load double, ptr %.6438, align 8
  %.6408 = load double, ptr %.6329, align 8
  %.450.i = insertelement <8 x double> poison, double %.6408, i64 0
  %.451.i = shufflevector <8 x double> %.450.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.464.i = insertelement <8 x double> poison, double %.6439, i64 0
  %.465.i = shufflevector <8 x double> %.464.i, <8 x double> poison, <8 x i32> zeroinitializer
  %46 = add nsw i64 %.389.i2924, -1
  %xtraiter.i2925 = and i64 %.389.i2924, 3
  %47 = icmp ult i64 %46, 3
  br i1 %47, label %B198.if.epil.preheader.i, label %B198.if.lr.ph.new.i

B198.if.lr.ph.new.i:                              ; preds = %B198.if.lr.ph.i
  %48 = lshr i64 %20, 5
  %49 = mul nsw i64 %48, -4
  br label %B198.if.i

B198.if.i:                                        ; preds = %B198.if.i, %B198.if.lr.ph.new.i
  %lsr.iv14 = phi i64 [ %lsr.iv.next15, %B198.if.i ], [ %49, %B198.if.lr.ph.new.i ]
  %.416441443.i = phi i64 [ %.423.3.i, %B198.if.i ], [ 0, %B198.if.lr.ph.new.i ]
  %sunkaddr110 = shl i64 %.416441443.i, 3
  %sunkaddr111 = getelementptr i8, ptr %arg.state.10.2.4, i64 %sunkaddr110
  store <8 x double> %.451.i, ptr %sunkaddr111, align 8, !noalias !162
  %sunkaddr113 = getelementptr i8, ptr %arg.state.10.3.4, i64 %sunkaddr110
  store <8 x double> %.465.i, ptr %sunkaddr113, align 8, !noalias !162
  %sunkaddr116 = getelementptr i8, ptr %sunkaddr111, i64 64
  store <8 x double> %.451.i, ptr %sunkaddr116, align 8, !noalias !162
  %sunkaddr119 = getelementptr i8, ptr %sunkaddr113, i64 64
  store <8 x double> %.465.i, ptr %sunkaddr119, align 8, !noalias !162
  %sunkaddr122 = getelementptr i8, ptr %sunkaddr111, i64 128
  store <8 x double> %.451.i, ptr %sunkaddr122, align 8, !noalias !162
  %sunkaddr128 = getelementptr i8, ptr %sunkaddr113, i64 128
  store <8 x double> %.465.i, ptr %sunkaddr128, align 8, !noalias !162
  %.423.3.i = add i64 %.416441443.i, 32
  %sunkaddr131 = shl i64 %.423.3.i, 3
  %sunkaddr132 = getelementptr i8, ptr %arg.state.10.2.4, i64 %sunkaddr131
  %sunkaddr133 = getelementptr i8, ptr %sunkaddr132, i64 -64
  store <8 x double> %.451.i, ptr %sunkaddr133, align 8, !noalias !162
  %sunkaddr135 = getelementptr i8, ptr %arg.state.10.3.4, i64 %sunkaddr131
  %sunkaddr136 = getelementptr i8, ptr %sunkaddr135, i64 -64
  store <8 x double> %.465.i, ptr %sunkaddr136, align 8, !noalias !162
  %lsr.iv.next15 = add i64 %lsr.iv14, 4
  %niter.ncmp.3.not.i = icmp eq i64 %lsr.iv.next15, 0
  br i1 %niter.ncmp.3.not.i, label %B348.loopexit.unr-lcssa.i, label %B198.if.i

B22.preheader.i.i:                                ; preds = %B348.i
  %.277.i.i = mul i64 %.4508.1, -3
  %50 = shl i64 %.5680, 3
  %51 = sub i64 %50, %14
  %scevgep3905 = getelementptr i8, ptr %scevgep3904, i64 %51
  br label %B22.i.i

B22.i.i:                                          ; preds = %B926.i.i, %B22.preheader.i.i
  %cell.2.0.i.i = phi i64 [ %cell.3.2.i.i, %B926.i.i ], [ %.653.i, %B22.preheader.i.i ]
  %start.2.0.i.i = phi i64 [ %.13.i.i.i, %B926.i.i ], [ %.13.i1.i, %B22.preheader.i.i ]
  %.149.i.i = getelementptr inbounds i64, ptr %.5963, i64 %cell.2.0.i.i
  %.150.i.i = load i64, ptr %.149.i.i, align 8, !noalias !173
  %.154.not.i.i = icmp sgt i64 %.150.i.i, %start.2.0.i.i
  br i1 %.154.not.i.i, label %B112.i.i, label %B62.i.i

B62.i.i:                                          ; preds = %B22.i.i, %B62.i.i
  %cell.4.1.i.i = phi i64 [ %.157.i.i, %B62.i.i ], [ %cell.2.0.i.i, %B22.i.i ]
  %.157.i.i = add i64 %cell.4.1.i.i, 1
  %52 = shl i64 %cell.4.1.i.i, 3
  %scevgep3906 = getelementptr i8, ptr %scevgep3905, i64 %52
  %.170.i.i = load i64, ptr %scevgep3906, align 8, !noalias !173
  %.172.not.i.i = icmp sgt i64 %.170.i.i, %start.2.0.i.i
  br i1 %.172.not.i.i, label %B112.i.i, label %B62.i.i

B112.i.i:                                         ; preds = %B62.i.i, %B22.i.i
  %cell.3.2.i.i = phi i64 [ %cell.2.0.i.i, %B22.i.i ], [ %.157.i.i, %B62.i.i ]
  %.184.i.i = getelementptr inbounds i64, ptr %.5963, i64 %cell.3.2.i.i
  %.185.i.i = load i64, ptr %.184.i.i, align 8, !noalias !173
  %.13.i.i.i = tail call i64 @llvm.smin.i64(i64 %.13.i3.i, i64 %.185.i.i)
  %.395.i.i = sub i64 %.13.i.i.i, %start.2.0.i.i
  %53 = add i64 %.395.i.i, 7
  %.417.i.i = lshr i64 %53, 3
  %.396.inv.i.i = icmp slt i64 %.395.i.i, 1
  %.438305.not326.i.i = icmp eq i64 %.417.i.i, 0
  %.438305.not.i.i = or i1 %.396.inv.i.i, %.438305.not326.i.i
  br i1 %.438305.not.i.i, label %B926.i.i, label %B570.if.lr.ph.i.i

B926.i.i:                                         ; preds = %B570.if.i.i, %B112.i.i
  %.602.i.i = icmp slt i64 %.185.i.i, %.13.i3.i
  br i1 %.602.i.i, label %B22.i.i, label %B348.endif.endif.endif.i

B570.if.lr.ph.i.i:                                ; preds = %B112.i.i
  %.228.i.i = getelementptr inbounds double, ptr %.4953, i64 %cell.3.2.i.i
  %.229.i.i = load double, ptr %.228.i.i, align 8, !noalias !173
  %.231.i.i = fsub contract double %.7289, %.229.i.i
  %.279.i.i = add nsw i64 %cell.3.2.i.i, %.277.i.i
  %.347.i.i = getelementptr inbounds double, ptr %.4714, i64 %.279.i.i
  %.348.i.i = load double, ptr %.347.i.i, align 8, !noalias !173
  %.266.i.i = add nsw i64 %cell.3.2.i.i, %.6410
  %.334.i.i = getelementptr inbounds double, ptr %.4714, i64 %.266.i.i
  %.335.i.i = load double, ptr %.334.i.i, align 8, !noalias !173
  %.247.i.i = sub i64 %cell.3.2.i.i, %.4508.1
  %.315.i.i = getelementptr inbounds double, ptr %.4714, i64 %.247.i.i
  %.316.i.i = load double, ptr %.315.i.i, align 8, !noalias !173
  %.303.i.i = getelementptr inbounds double, ptr %.4714, i64 %cell.3.2.i.i
  %.304.i.i = load double, ptr %.303.i.i, align 8, !noalias !173
  %.287.i.i = getelementptr inbounds double, ptr %.4589, i64 %.279.i.i
  %.288.i.i = load double, ptr %.287.i.i, align 8, !noalias !173
  %.274.i.i = getelementptr inbounds double, ptr %.4589, i64 %.266.i.i
  %.275.i.i = load double, ptr %.274.i.i, align 8, !noalias !173
  %.255.i.i = getelementptr inbounds double, ptr %.4589, i64 %.247.i.i
  %.256.i.i = load double, ptr %.255.i.i, align 8, !noalias !173
  %.243.i.i = getelementptr inbounds double, ptr %.4589, i64 %cell.3.2.i.i
  %.244.i.i = load double, ptr %.243.i.i, align 8, !noalias !173
  %.514.i.i = insertelement <8 x double> poison, double %.288.i.i, i64 0
  %.515.i.i = shufflevector <8 x double> %.514.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.517.i.i = insertelement <8 x double> poison, double %.275.i.i, i64 0
  %.518.i.i = shufflevector <8 x double> %.517.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.521.i.i = insertelement <8 x double> poison, double %.256.i.i, i64 0
  %.522.i.i = shufflevector <8 x double> %.521.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.525.i.i = insertelement <8 x double> poison, double %.244.i.i, i64 0
  %.526.i.i = shufflevector <8 x double> %.525.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.541.i.i = insertelement <8 x double> poison, double %.348.i.i, i64 0
  %.542.i.i = shufflevector <8 x double> %.541.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.544.i.i = insertelement <8 x double> poison, double %.335.i.i, i64 0
  %.545.i.i = shufflevector <8 x double> %.544.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.548.i.i = insertelement <8 x double> poison, double %.316.i.i, i64 0
  %.549.i.i = shufflevector <8 x double> %.548.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.552.i.i = insertelement <8 x double> poison, double %.304.i.i, i64 0
  %.553.i.i = shufflevector <8 x double> %.552.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.6.i.i.i = insertelement <8 x double> poison, double %.231.i.i, i64 0
  %.7.i.i.i = shufflevector <8 x double> %.6.i.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %54 = shl i64 %start.2.0.i.i, 3
  %55 = add nuw nsw i64 %.417.i.i, 7
  br label %B570.if.i.i

B570.if.i.i:                                      ; preds = %B570.if.i.i, %B570.if.lr.ph.i.i
  %lsr.iv31 = phi i64 [ %lsr.iv.next32, %B570.if.i.i ], [ %55, %B570.if.lr.ph.i.i ]
  %lsr.iv8.i.i = phi i64 [ %lsr.iv.next9.i.i, %B570.if.i.i ], [ %54, %B570.if.lr.ph.i.i ]
  %scevgep13.i.i = getelementptr i8, ptr %.7199, i64 %lsr.iv8.i.i
  %.485.i.i = load <8 x double>, ptr %scevgep13.i.i, align 8, !noalias !173
  %.8.i.i.i = fadd contract <8 x double> %.7.i.i.i, %.485.i.i
  %.519.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i.i.i, <8 x double> %.515.i.i, <8 x double> %.518.i.i)
  %.523.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i.i.i, <8 x double> %.519.i.i, <8 x double> %.522.i.i)
  %.527.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i.i.i, <8 x double> %.523.i.i, <8 x double> %.526.i.i)
  %scevgep3912 = getelementptr i8, ptr %scevgep3911, i64 %lsr.iv8.i.i
  store <8 x double> %.527.i.i, ptr %scevgep3912, align 8, !noalias !173
  %.546.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i.i.i, <8 x double> %.542.i.i, <8 x double> %.545.i.i)
  %.550.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i.i.i, <8 x double> %.546.i.i, <8 x double> %.549.i.i)
  %.554.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i.i.i, <8 x double> %.550.i.i, <8 x double> %.553.i.i)
  %scevgep3910 = getelementptr i8, ptr %scevgep3909, i64 %lsr.iv8.i.i
  store <8 x double> %.554.i.i, ptr %scevgep3910, align 8, !noalias !173
  %lsr.iv.next9.i.i = add i64 %lsr.iv8.i.i, 64
  %lsr.iv.next32 = add nsw i64 %lsr.iv31, -1
  %.438.i.i = icmp sgt i64 %lsr.iv31, 8
  br i1 %.438.i.i, label %B570.if.i.i, label %B926.i.i

B348.endif.endif.endif.i:                         ; preds = %B926.i.i, %B348.i
  %cell.5.1.i.i = phi i64 [ %.653.i, %B348.i ], [ %cell.3.2.i.i, %B926.i.i ]
  store i64 %cell.5.1.i.i, ptr %sunkaddr109, align 8, !noalias !162
  %.835.i = sub i64 %arg.ends.1, %.13.i3.i
  %56 = add i64 %.835.i, 7
  %.857.i = lshr i64 %56, 3
  %.836.inv.i = icmp slt i64 %.835.i, 1
  %.878448.not454.i = icmp eq i64 %.857.i, 0
  %.878448.not.i = or i1 %.836.inv.i, %.878448.not454.i
  br i1 %.878448.not.i, label %B37499.endif.endif.endif, label %B590.if.lr.ph.i

B590.if.lr.ph.i:                                  ; preds = %B348.endif.endif.endif.i
  %.918.i = insertelement <8 x double> poison, double %.6469, i64 0
  %.919.i = shufflevector <8 x double> %.918.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.932.i = insertelement <8 x double> poison, double %.6502, i64 0
  %.933.i = shufflevector <8 x double> %.932.i, <8 x double> poison, <8 x i32> zeroinitializer
  %57 = add nsw i64 %.857.i, -1
  %xtraiter28.i = and i64 %.857.i, 3
  %lcmp.mod29.not.i = icmp eq i64 %xtraiter28.i, 0
  br i1 %lcmp.mod29.not.i, label %B590.if.prol.loopexit.i, label %B590.if.prol.i.preheader

B590.if.prol.i.preheader:                         ; preds = %B590.if.lr.ph.i
  %58 = sub nsw i64 0, %xtraiter28.i
  br label %B590.if.prol.i

B590.if.prol.i:                                   ; preds = %B590.if.prol.i, %B590.if.prol.i.preheader
  %lsr.iv33 = phi i64 [ %58, %B590.if.prol.i.preheader ], [ %math139, %B590.if.prol.i ]
  %.884447449.prol.i = phi i64 [ %.487.i, %B590.if.prol.i.preheader ], [ %.891.prol.i, %B590.if.prol.i ]
  %.891.prol.i = add i64 %.884447449.prol.i, 8
  %59 = shl i64 %.884447449.prol.i, 3
  %scevgep46.i = getelementptr i8, ptr %arg.state.10.2.4, i64 %59
  store <8 x double> %.919.i, ptr %scevgep46.i, align 8, !noalias !162
  %scevgep45.i = getelementptr i8, ptr %arg.state.10.3.4, i64 %59
  store <8 x double> %.933.i, ptr %scevgep45.i, align 8, !noalias !162
  %60 = tail call { i64, i1 } @llvm.uadd.with.overflow.i64(i64 %lsr.iv33, i64 1)
  %math139 = extractvalue { i64, i1 } %60, 0
  %ov140 = extractvalue { i64, i1 } %60, 1
  br i1 %ov140, label %B590.if.prol.loopexit.loopexit.i, label %B590.if.prol.i, !llvm.loop !176

B590.if.prol.loopexit.loopexit.i:                 ; preds = %B590.if.prol.i
  %61 = and i64 %.857.i, 2305843009213693948
  br label %B590.if.prol.loopexit.i

B590.if.prol.loopexit.i:                          ; preds = %B590.if.prol.loopexit.loopexit.i, %B590.if.lr.ph.i
  %.877446450.unr.i = phi i64 [ %.857.i, %B590.if.lr.ph.i ], [ %61, %B590.if.prol.loopexit.loopexit.i ]
  %.884447449.unr.i = phi i64 [ %.487.i, %B590.if.lr.ph.i ], [ %.891.prol.i, %B590.if.prol.loopexit.loopexit.i ]
  %62 = icmp ult i64 %57, 3
  br i1 %62, label %B37499.endif.endif.endif, label %B590.if.preheader.i

B590.if.preheader.i:                              ; preds = %B590.if.prol.loopexit.i
  %63 = shl i64 %.884447449.unr.i, 3
  %64 = add i64 %63, 192
  %65 = add nuw nsw i64 %.877446450.unr.i, 24
  br label %B590.if.i

B590.if.i:                                        ; preds = %B590.if.i, %B590.if.preheader.i
  %lsr.iv35 = phi i64 [ %lsr.iv.next36, %B590.if.i ], [ %65, %B590.if.preheader.i ]
  %lsr.iv30.i = phi i64 [ %lsr.iv.next31.i, %B590.if.i ], [ %64, %B590.if.preheader.i ]
  %scevgep41.i = getelementptr i8, ptr %arg.state.10.2.4, i64 %lsr.iv30.i
  %scevgep42.i = getelementptr i8, ptr %scevgep41.i, i64 -192
  store <8 x double> %.919.i, ptr %scevgep42.i, align 8, !noalias !162
  %scevgep34.i = getelementptr i8, ptr %arg.state.10.3.4, i64 %lsr.iv30.i
  %scevgep35.i = getelementptr i8, ptr %scevgep34.i, i64 -192
  store <8 x double> %.933.i, ptr %scevgep35.i, align 8, !noalias !162
  %scevgep44 = getelementptr i8, ptr %scevgep41.i, i64 -128
  store <8 x double> %.919.i, ptr %scevgep44, align 8, !noalias !162
  %scevgep37.i = getelementptr i8, ptr %scevgep34.i, i64 -128
  store <8 x double> %.933.i, ptr %scevgep37.i, align 8, !noalias !162
  %scevgep42 = getelementptr i8, ptr %scevgep41.i, i64 -64
  store <8 x double> %.919.i, ptr %scevgep42, align 8, !noalias !162
  %scevgep39 = getelementptr i8, ptr %scevgep34.i, i64 -64
  store <8 x double> %.933.i, ptr %scevgep39, align 8, !noalias !162
  store <8 x double> %.919.i, ptr %scevgep41.i, align 8, !noalias !162
  store <8 x double> %.933.i, ptr %scevgep34.i, align 8, !noalias !162
  %lsr.iv.next31.i = add i64 %lsr.iv30.i, 256
  %lsr.iv.next36 = add nsw i64 %lsr.iv35, -4
  %.878.3.i = icmp sgt i64 %lsr.iv35, 28
  br i1 %.878.3.i, label %B590.if.i, label %B37499.endif.endif.endif

B37499.endif.endif.endif:                         ; preds = %B590.if.i, %B590.if.prol.loopexit.i, %B348.endif.endif.endif.i
  %.7434 = load i64, ptr %sunkaddr142, align 8
  %.7465 = load i64, ptr %.526, align 8
  %.7471 = mul nsw i64 %.7465, 40
  %.7472 = add nsw i64 %.7471, %.7434
  %.7473 = inttoptr i64 %.7472 to ptr
  %.7548 = getelementptr i8, ptr %.7473, i64 16
  %.7549 = load double, ptr %.7548, align 8
  %.7581 = getelementptr i8, ptr %.2624, i64 344
  %.7582 = load double, ptr %.7581, align 8
  %.7616 = getelementptr i8, ptr %mode.2.sroa.52.3, i64 16
  %.7617 = load i64, ptr %.7616, align 8
  %.7680 = mul nsw i64 %.7465, %arg.i
  %.7708 = getelementptr i8, ptr %mode.2.sroa.52.3, i64 8
  %.7709 = load i64, ptr %.7708, align 8
  %.7713 = add nsw i64 %.7709, %.7680
  %.7743 = load i64, ptr %sunkaddr143, align 8
  %.7744 = inttoptr i64 %.7743 to ptr
  %.7821 = load i64, ptr %sunkaddr144, align 8
  %.7825 = inttoptr i64 %.7821 to ptr
  %66 = lshr i64 %.7713, 33
  %.7892 = and i64 %66, 1073741824
  %67 = getelementptr double, ptr %.7744, i64 %.7713
  %.7906 = getelementptr double, ptr %67, i64 %.7892
  %.7907 = load double, ptr %.7906, align 8
  %.idx9140 = shl i64 %.7713, 4
  %68 = getelementptr i8, ptr %.7825, i64 %.idx9140
  %69 = getelementptr i8, ptr %68, i64 8
  %.7940 = getelementptr double, ptr %69, i64 %.7892
  %.7941 = load double, ptr %.7940, align 8
  %.7958 = add nsw i64 %k.7.3, 1
  %.8095 = icmp eq i64 %.7958, %.7465
  br i1 %.8095, label %B37579, label %B37577

B348.loopexit.unr-lcssa.i3093:                    ; preds = %B198.if.i3075
  %lcmp.mod.not.i3094 = icmp eq i64 %xtraiter.i3072, 0
  br i1 %lcmp.mod.not.i3094, label %B348.i3105, label %B198.if.epil.preheader.i3095

B198.if.epil.preheader.i3095:                     ; preds = %B198.if.lr.ph.i3067, %B348.loopexit.unr-lcssa.i3093
  %.416441443.epil.init.i3096 = phi i64 [ 0, %B198.if.lr.ph.i3067 ], [ %.423.3.i3085, %B348.loopexit.unr-lcssa.i3093 ]
  %70 = shl i64 %.416441443.epil.init.i3096, 3
  %scevgep51.i3097 = getelementptr i8, ptr %arg.state.10.5.4, i64 %70
  %scevgep55.i3098 = getelementptr i8, ptr %arg.state.10.4.4, i64 %70
  %71 = shl nuw nsw i64 %xtraiter.i3072, 6
  br label %B198.if.epil.i3099

B198.if.epil.i3099:                               ; preds = %B198.if.epil.i3099, %B198.if.epil.preheader.i3095
  %lsr.iv52.i3100 = phi i64 [ %lsr.iv.next53.i3103, %B198.if.epil.i3099 ], [ 0, %B198.if.epil.preheader.i3095 ]
  %scevgep56.i3101 = getelementptr i8, ptr %scevgep55.i3098, i64 %lsr.iv52.i3100
  store <8 x double> %.451.i3069, ptr %scevgep56.i3101, align 8, !noalias !169
  %scevgep54.i3102 = getelementptr i8, ptr %scevgep51.i3097, i64 %lsr.iv52.i3100
  store <8 x double> %.465.i3071, ptr %scevgep54.i3102, align 8, !noalias !169
  %lsr.iv.next53.i3103 = add nuw nsw i64 %lsr.iv52.i3100, 64
  %epil.iter.cmp.not.i3104 = icmp eq i64 %71, %lsr.iv.next53.i3103
  br i1 %epil.iter.cmp.not.i3104, label %B348.i3105, label %B198.if.epil.i3099, !llvm.loop !172

B348.i3105:                                       ; preds = %B198.if.epil.i3099, %B348.loopexit.unr-lcssa.i3093, %B75886
  %.487.i3106 = sub nsw i64 %.13.i3.i3061, %arg.ends.0
  %sunkaddr146 = getelementptr i8, ptr %.8985, i64 16
  %.653.i3108 = load i64, ptr %sunkaddr146, align 8, !noalias !169
  %.126.i.i3109 = icmp slt i64 %.13.i.i3056, %.13.i3.i3061
  br i1 %.126.i.i3109, label %B22.preheader.i.i3151, label %B348.endif.endif.endif.i3110

B198.if.lr.ph.i3067:                              ; preds = %B75886
  %72 = getelementptr double, ptr %.10522, i64 %.10603
  %.10616 = icmp slt i64 %.8735, 0
  %.10617 = select i1 %.10616, i64 %.8834, i64 0
  %.10631 = getelementptr double, ptr %72, i64 %.10617
  %.10632 = load double, ptr %.10631, align 8
  %.10601 = load double, ptr %.10522, align 8
  %.450.i3068 = insertelement <8 x double> poison, double %.10601, i64 0
  %.451.i3069 = shufflevector <8 x double> %.450.i3068, <8 x double> poison, <8 x i32> zeroinitializer
  %.464.i3070 = insertelement <8 x double> poison, double %.10632, i64 0
  %.465.i3071 = shufflevector <8 x double> %.464.i3070, <8 x double> poison, <8 x i32> zeroinitializer
  %73 = add nsw i64 %.389.i3063, -1
  %xtraiter.i3072 = and i64 %.389.i3063, 3
  %74 = icmp ult i64 %73, 3
  br i1 %74, label %B198.if.epil.preheader.i3095, label %B198.if.lr.ph.new.i3073

B198.if.lr.ph.new.i3073:                          ; preds = %B198.if.lr.ph.i3067
  %75 = lshr i64 %39, 5
  %76 = mul nsw i64 %75, -4
  br label %B198.if.i3075

B198.if.i3075:                                    ; preds = %B198.if.i3075, %B198.if.lr.ph.new.i3073
  %lsr.iv = phi i64 [ %lsr.iv.next, %B198.if.i3075 ], [ %76, %B198.if.lr.ph.new.i3073 ]
  %.416441443.i3077 = phi i64 [ %.423.3.i3085, %B198.if.i3075 ], [ 0, %B198.if.lr.ph.new.i3073 ]
  %sunkaddr147 = shl i64 %.416441443.i3077, 3
  %sunkaddr148 = getelementptr i8, ptr %arg.state.10.4.4, i64 %sunkaddr147
  store <8 x double> %.451.i3069, ptr %sunkaddr148, align 8, !noalias !169
  %sunkaddr150 = getelementptr i8, ptr %arg.state.10.5.4, i64 %sunkaddr147
  store <8 x double> %.465.i3071, ptr %sunkaddr150, align 8, !noalias !169
  %sunkaddr153 = getelementptr i8, ptr %sunkaddr148, i64 64
  store <8 x double> %.451.i3069, ptr %sunkaddr153, align 8, !noalias !169
  %sunkaddr156 = getelementptr i8, ptr %sunkaddr150, i64 64
  store <8 x double> %.465.i3071, ptr %sunkaddr156, align 8, !noalias !169
  %sunkaddr160 = getelementptr i8, ptr %sunkaddr148, i64 128
  store <8 x double> %.451.i3069, ptr %sunkaddr160, align 8, !noalias !169
  %sunkaddr163 = getelementptr i8, ptr %sunkaddr150, i64 128
  store <8 x double> %.465.i3071, ptr %sunkaddr163, align 8, !noalias !169
  %.423.3.i3085 = add i64 %.416441443.i3077, 32
  %sunkaddr165 = shl i64 %.423.3.i3085, 3
  %sunkaddr166 = getelementptr i8, ptr %arg.state.10.4.4, i64 %sunkaddr165
  %sunkaddr167 = getelementptr i8, ptr %sunkaddr166, i64 -64
  store <8 x double> %.451.i3069, ptr %sunkaddr167, align 8, !noalias !169
  %sunkaddr169 = getelementptr i8, ptr %arg.state.10.5.4, i64 %sunkaddr165
  %sunkaddr170 = getelementptr i8, ptr %sunkaddr169, i64 -64
  store <8 x double> %.465.i3071, ptr %sunkaddr170, align 8, !noalias !169
  %lsr.iv.next = add i64 %lsr.iv, 4
  %niter.ncmp.3.not.i3092 = icmp eq i64 %lsr.iv.next, 0
  br i1 %niter.ncmp.3.not.i3092, label %B348.loopexit.unr-lcssa.i3093, label %B198.if.i3075

B22.preheader.i.i3151:                            ; preds = %B348.i3105
  %.277.i.i3155 = mul i64 %.8701.1, -3
  %77 = shl i64 %.9873, 3
  %78 = sub i64 %77, %33
  %scevgep3942 = getelementptr i8, ptr %scevgep3904, i64 %78
  br label %B22.i.i3158

B22.i.i3158:                                      ; preds = %B926.i.i3239, %B22.preheader.i.i3151
  %cell.2.0.i.i3159 = phi i64 [ %cell.3.2.i.i3172, %B926.i.i3239 ], [ %.653.i3108, %B22.preheader.i.i3151 ]
  %start.2.0.i.i3160 = phi i64 [ %.13.i.i.i3175, %B926.i.i3239 ], [ %.13.i1.i3057, %B22.preheader.i.i3151 ]
  %.149.i.i3161 = getelementptr inbounds i64, ptr %.10156, i64 %cell.2.0.i.i3159
  %.150.i.i3162 = load i64, ptr %.149.i.i3161, align 8, !noalias !177
  %.154.not.i.i3163 = icmp sgt i64 %.150.i.i3162, %start.2.0.i.i3160
  br i1 %.154.not.i.i3163, label %B112.i.i3171, label %B62.i.i3164

B62.i.i3164:                                      ; preds = %B22.i.i3158, %B62.i.i3164
  %cell.4.1.i.i3165 = phi i64 [ %.157.i.i3166, %B62.i.i3164 ], [ %cell.2.0.i.i3159, %B22.i.i3158 ]
  %.157.i.i3166 = add i64 %cell.4.1.i.i3165, 1
  %79 = shl i64 %cell.4.1.i.i3165, 3
  %scevgep3943 = getelementptr i8, ptr %scevgep3942, i64 %79
  %.170.i.i3169 = load i64, ptr %scevgep3943, align 8, !noalias !177
  %.172.not.i.i3170 = icmp sgt i64 %.170.i.i3169, %start.2.0.i.i3160
  br i1 %.172.not.i.i3170, label %B112.i.i3171, label %B62.i.i3164

B112.i.i3171:                                     ; preds = %B62.i.i3164, %B22.i.i3158
  %cell.3.2.i.i3172 = phi i64 [ %cell.2.0.i.i3159, %B22.i.i3158 ], [ %.157.i.i3166, %B62.i.i3164 ]
  %.184.i.i3173 = getelementptr inbounds i64, ptr %.10156, i64 %cell.3.2.i.i3172
  %.185.i.i3174 = load i64, ptr %.184.i.i3173, align 8, !noalias !177
  %.13.i.i.i3175 = tail call i64 @llvm.smin.i64(i64 %.13.i3.i3061, i64 %.185.i.i3174)
  %.395.i.i3176 = sub i64 %.13.i.i.i3175, %start.2.0.i.i3160
  %80 = add i64 %.395.i.i3176, 7
  %.417.i.i3177 = lshr i64 %80, 3
  %.396.inv.i.i3178 = icmp slt i64 %.395.i.i3176, 1
  %.438305.not326.i.i3179 = icmp eq i64 %.417.i.i3177, 0
  %.438305.not.i.i3180 = or i1 %.396.inv.i.i3178, %.438305.not326.i.i3179
  br i1 %.438305.not.i.i3180, label %B926.i.i3239, label %B570.if.lr.ph.i.i3181

B926.i.i3239:                                     ; preds = %B570.if.i.i3222, %B112.i.i3171
  %.602.i.i3240 = icmp slt i64 %.185.i.i3174, %.13.i3.i3061
  br i1 %.602.i.i3240, label %B22.i.i3158, label %B348.endif.endif.endif.i3110

B570.if.lr.ph.i.i3181:                            ; preds = %B112.i.i3171
  %.228.i.i3182 = getelementptr inbounds double, ptr %.9146, i64 %cell.3.2.i.i3172
  %.229.i.i3183 = load double, ptr %.228.i.i3182, align 8, !noalias !177
  %.231.i.i3184 = fsub contract double %.11487, %.229.i.i3183
  %.279.i.i3185 = add nsw i64 %cell.3.2.i.i3172, %.277.i.i3155
  %.347.i.i3186 = getelementptr inbounds double, ptr %.8907, i64 %.279.i.i3185
  %.348.i.i3187 = load double, ptr %.347.i.i3186, align 8, !noalias !177
  %.266.i.i3188 = add nsw i64 %cell.3.2.i.i3172, %.10603
  %.334.i.i3189 = getelementptr inbounds double, ptr %.8907, i64 %.266.i.i3188
  %.335.i.i3190 = load double, ptr %.334.i.i3189, align 8, !noalias !177
  %.247.i.i3191 = sub i64 %cell.3.2.i.i3172, %.8701.1
  %.315.i.i3192 = getelementptr inbounds double, ptr %.8907, i64 %.247.i.i3191
  %.316.i.i3193 = load double, ptr %.315.i.i3192, align 8, !noalias !177
  %.303.i.i3194 = getelementptr inbounds double, ptr %.8907, i64 %cell.3.2.i.i3172
  %.304.i.i3195 = load double, ptr %.303.i.i3194, align 8, !noalias !177
  %.287.i.i3196 = getelementptr inbounds double, ptr %.8782, i64 %.279.i.i3185
  %.288.i.i3197 = load double, ptr %.287.i.i3196, align 8, !noalias !177
  %.274.i.i3198 = getelementptr inbounds double, ptr %.8782, i64 %.266.i.i3188
  %.275.i.i3199 = load double, ptr %.274.i.i3198, align 8, !noalias !177
  %.255.i.i3200 = getelementptr inbounds double, ptr %.8782, i64 %.247.i.i3191
  %.256.i.i3201 = load double, ptr %.255.i.i3200, align 8, !noalias !177
  %.243.i.i3202 = getelementptr inbounds double, ptr %.8782, i64 %cell.3.2.i.i3172
  %.244.i.i3203 = load double, ptr %.243.i.i3202, align 8, !noalias !177
  %.514.i.i3204 = insertelement <8 x double> poison, double %.288.i.i3197, i64 0
  %.515.i.i3205 = shufflevector <8 x double> %.514.i.i3204, <8 x double> poison, <8 x i32> zeroinitializer
  %.517.i.i3206 = insertelement <8 x double> poison, double %.275.i.i3199, i64 0
  %.518.i.i3207 = shufflevector <8 x double> %.517.i.i3206, <8 x double> poison, <8 x i32> zeroinitializer
  %.521.i.i3208 = insertelement <8 x double> poison, double %.256.i.i3201, i64 0
  %.522.i.i3209 = shufflevector <8 x double> %.521.i.i3208, <8 x double> poison, <8 x i32> zeroinitializer
  %.525.i.i3210 = insertelement <8 x double> poison, double %.244.i.i3203, i64 0
  %.526.i.i3211 = shufflevector <8 x double> %.525.i.i3210, <8 x double> poison, <8 x i32> zeroinitializer
  %.541.i.i3212 = insertelement <8 x double> poison, double %.348.i.i3187, i64 0
  %.542.i.i3213 = shufflevector <8 x double> %.541.i.i3212, <8 x double> poison, <8 x i32> zeroinitializer
  %.544.i.i3214 = insertelement <8 x double> poison, double %.335.i.i3190, i64 0
  %.545.i.i3215 = shufflevector <8 x double> %.544.i.i3214, <8 x double> poison, <8 x i32> zeroinitializer
  %.548.i.i3216 = insertelement <8 x double> poison, double %.316.i.i3193, i64 0
  %.549.i.i3217 = shufflevector <8 x double> %.548.i.i3216, <8 x double> poison, <8 x i32> zeroinitializer
  %.552.i.i3218 = insertelement <8 x double> poison, double %.304.i.i3195, i64 0
  %.553.i.i3219 = shufflevector <8 x double> %.552.i.i3218, <8 x double> poison, <8 x i32> zeroinitializer
  %.6.i.i.i3220 = insertelement <8 x double> poison, double %.231.i.i3184, i64 0
  %.7.i.i.i3221 = shufflevector <8 x double> %.6.i.i.i3220, <8 x double> poison, <8 x i32> zeroinitializer
  %81 = shl i64 %start.2.0.i.i3160, 3
  %82 = add nuw nsw i64 %.417.i.i3177, 7
  br label %B570.if.i.i3222

B570.if.i.i3222:                                  ; preds = %B570.if.i.i3222, %B570.if.lr.ph.i.i3181
  %lsr.iv62 = phi i64 [ %lsr.iv.next63, %B570.if.i.i3222 ], [ %82, %B570.if.lr.ph.i.i3181 ]
  %lsr.iv8.i.i3224 = phi i64 [ %lsr.iv.next9.i.i3236, %B570.if.i.i3222 ], [ %81, %B570.if.lr.ph.i.i3181 ]
  %scevgep13.i.i3225 = getelementptr i8, ptr %.11397, i64 %lsr.iv8.i.i3224
  %.485.i.i3226 = load <8 x double>, ptr %scevgep13.i.i3225, align 8, !noalias !177
  %.8.i.i.i3227 = fadd contract <8 x double> %.7.i.i.i3221, %.485.i.i3226
  %.519.i.i3228 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i.i.i3227, <8 x double> %.515.i.i3205, <8 x double> %.518.i.i3207)
  %.523.i.i3229 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i.i.i3227, <8 x double> %.519.i.i3228, <8 x double> %.522.i.i3209)
  %.527.i.i3230 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i.i.i3227, <8 x double> %.523.i.i3229, <8 x double> %.526.i.i3211)
  %scevgep3949 = getelementptr i8, ptr %scevgep3948, i64 %lsr.iv8.i.i3224
  store <8 x double> %.527.i.i3230, ptr %scevgep3949, align 8, !noalias !177
  %.546.i.i3232 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i.i.i3227, <8 x double> %.542.i.i3213, <8 x double> %.545.i.i3215)
  %.550.i.i3233 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i.i.i3227, <8 x double> %.546.i.i3232, <8 x double> %.549.i.i3217)
  %.554.i.i3234 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i.i.i3227, <8 x double> %.550.i.i3233, <8 x double> %.553.i.i3219)
  %scevgep3947 = getelementptr i8, ptr %scevgep3946, i64 %lsr.iv8.i.i3224
  store <8 x double> %.554.i.i3234, ptr %scevgep3947, align 8, !noalias !177
  %lsr.iv.next9.i.i3236 = add i64 %lsr.iv8.i.i3224, 64
  %lsr.iv.next63 = add nsw i64 %lsr.iv62, -1
  %.438.i.i3238 = icmp sgt i64 %lsr.iv62, 8
  br i1 %.438.i.i3238, label %B570.if.i.i3222, label %B926.i.i3239

B348.endif.endif.endif.i3110:                     ; preds = %B926.i.i3239, %B348.i3105
  %cell.5.1.i.i3111 = phi i64 [ %.653.i3108, %B348.i3105 ], [ %cell.3.2.i.i3172, %B926.i.i3239 ]
  store i64 %cell.5.1.i.i3111, ptr %sunkaddr146, align 8, !noalias !169
  %.835.i3112 = sub i64 %arg.ends.1, %.13.i3.i3061
  %83 = add i64 %.835.i3112, 7
  %.857.i3113 = lshr i64 %83, 3
  %.836.inv.i3114 = icmp slt i64 %.835.i3112, 1
  %.878448.not454.i3115 = icmp eq i64 %.857.i3113, 0
  %.878448.not.i3116 = or i1 %.836.inv.i3114, %.878448.not454.i3115
  br i1 %.878448.not.i3116, label %B76209.endif.endif.endif, label %B590.if.lr.ph.i3117

B590.if.lr.ph.i3117:                              ; preds = %B348.endif.endif.endif.i3110
  %.918.i3118 = insertelement <8 x double> poison, double %.10662, i64 0
  %.919.i3119 = shufflevector <8 x double> %.918.i3118, <8 x double> poison, <8 x i32> zeroinitializer
  %.932.i3120 = insertelement <8 x double> poison, double %.10695, i64 0
  %.933.i3121 = shufflevector <8 x double> %.932.i3120, <8 x double> poison, <8 x i32> zeroinitializer
  %84 = add nsw i64 %.857.i3113, -1
  %xtraiter28.i3122 = and i64 %.857.i3113, 3
  %lcmp.mod29.not.i3123 = icmp eq i64 %xtraiter28.i3122, 0
  br i1 %lcmp.mod29.not.i3123, label %B590.if.prol.loopexit.i3133, label %B590.if.prol.i3124.preheader

B590.if.prol.i3124.preheader:                     ; preds = %B590.if.lr.ph.i3117
  %85 = sub nsw i64 0, %xtraiter28.i3122
  br label %B590.if.prol.i3124

B590.if.prol.i3124:                               ; preds = %B590.if.prol.i3124, %B590.if.prol.i3124.preheader
  %lsr.iv64 = phi i64 [ %85, %B590.if.prol.i3124.preheader ], [ %math173, %B590.if.prol.i3124 ]
  %.884447449.prol.i3125 = phi i64 [ %.487.i3106, %B590.if.prol.i3124.preheader ], [ %.891.prol.i3127, %B590.if.prol.i3124 ]
  %.891.prol.i3127 = add i64 %.884447449.prol.i3125, 8
  %86 = shl i64 %.884447449.prol.i3125, 3
  %scevgep46.i3128 = getelementptr i8, ptr %arg.state.10.4.4, i64 %86
  store <8 x double> %.919.i3119, ptr %scevgep46.i3128, align 8, !noalias !169
  %scevgep45.i3129 = getelementptr i8, ptr %arg.state.10.5.4, i64 %86
  store <8 x double> %.933.i3121, ptr %scevgep45.i3129, align 8, !noalias !169
  %87 = tail call { i64, i1 } @llvm.uadd.with.overflow.i64(i64 %lsr.iv64, i64 1)
  %math173 = extractvalue { i64, i1 } %87, 0
  %ov174 = extractvalue { i64, i1 } %87, 1
  br i1 %ov174, label %B590.if.prol.loopexit.loopexit.i3132, label %B590.if.prol.i3124, !llvm.loop !176

B590.if.prol.loopexit.loopexit.i3132:             ; preds = %B590.if.prol.i3124
  %88 = and i64 %.857.i3113, 2305843009213693948
  br label %B590.if.prol.loopexit.i3133

B590.if.prol.loopexit.i3133:                      ; preds = %B590.if.prol.loopexit.loopexit.i3132, %B590.if.lr.ph.i3117
  %.877446450.unr.i3134 = phi i64 [ %.857.i3113, %B590.if.lr.ph.i3117 ], [ %88, %B590.if.prol.loopexit.loopexit.i3132 ]
  %.884447449.unr.i3135 = phi i64 [ %.487.i3106, %B590.if.lr.ph.i3117 ], [ %.891.prol.i3127, %B590.if.prol.loopexit.loopexit.i3132 ]
  %89 = icmp ult i64 %84, 3
  br i1 %89, label %B76209.endif.endif.endif, label %B590.if.preheader.i3136

B590.if.preheader.i3136:                          ; preds = %B590.if.prol.loopexit.i3133
  %90 = shl i64 %.884447449.unr.i3135, 3
  %91 = add i64 %90, 192
  %92 = add nuw nsw i64 %.877446450.unr.i3134, 24
  br label %B590.if.i3137

B590.if.i3137:                                    ; preds = %B590.if.i3137, %B590.if.preheader.i3136
  %lsr.iv66 = phi i64 [ %lsr.iv.next67, %B590.if.i3137 ], [ %92, %B590.if.preheader.i3136 ]
  %lsr.iv30.i3138 = phi i64 [ %lsr.iv.next31.i3149, %B590.if.i3137 ], [ %91, %B590.if.preheader.i3136 ]
  %scevgep41.i3140 = getelementptr i8, ptr %arg.state.10.4.4, i64 %lsr.iv30.i3138
  %scevgep42.i3141 = getelementptr i8, ptr %scevgep41.i3140, i64 -192
  store <8 x double> %.919.i3119, ptr %scevgep42.i3141, align 8, !noalias !169
  %scevgep34.i3142 = getelementptr i8, ptr %arg.state.10.5.4, i64 %lsr.iv30.i3138
  %scevgep35.i3143 = getelementptr i8, ptr %scevgep34.i3142, i64 -192
  store <8 x double> %.933.i3121, ptr %scevgep35.i3143, align 8, !noalias !169
  %scevgep75 = getelementptr i8, ptr %scevgep41.i3140, i64 -128
  store <8 x double> %.919.i3119, ptr %scevgep75, align 8, !noalias !169
  %scevgep37.i3145 = getelementptr i8, ptr %scevgep34.i3142, i64 -128
  store <8 x double> %.933.i3121, ptr %scevgep37.i3145, align 8, !noalias !169
  %scevgep73 = getelementptr i8, ptr %scevgep41.i3140, i64 -64
  store <8 x double> %.919.i3119, ptr %scevgep73, align 8, !noalias !169
  %scevgep71 = getelementptr i8, ptr %scevgep34.i3142, i64 -64
  store <8 x double> %.933.i3121, ptr %scevgep71, align 8, !noalias !169
  store <8 x double> %.919.i3119, ptr %scevgep41.i3140, align 8, !noalias !169
  store <8 x double> %.933.i3121, ptr %scevgep34.i3142, align 8, !noalias !169
  %lsr.iv.next31.i3149 = add i64 %lsr.iv30.i3138, 256
  %lsr.iv.next67 = add nsw i64 %lsr.iv66, -4
  %.878.3.i3150 = icmp sgt i64 %lsr.iv66, 28
  br i1 %.878.3.i3150, label %B590.if.i3137, label %B76209.endif.endif.endif

B76209.endif.endif.endif:                         ; preds = %B590.if.i3137, %B590.if.prol.loopexit.i3133, %B348.endif.endif.endif.i3110
  %.11871 = load i64, ptr %.526, align 8
  %.11875 = mul nsw i64 %.11871, %arg.i
  %sunkaddr177 = getelementptr i8, ptr %sunkaddr3972, i64 56
  %.11904 = load i64, ptr %sunkaddr177, align 8
  %.11908 = add nsw i64 %.11904, %.11875
  %.11938 = load i64, ptr %sunkaddr143, align 8
  %.11939 = inttoptr i64 %.11938 to ptr
  %.12016 = load i64, ptr %sunkaddr144, align 8
  %.12020 = inttoptr i64 %.12016 to ptr
  %93 = lshr i64 %.11908, 33
  %.12087 = and i64 %93, 1073741824
  %94 = getelementptr double, ptr %.11939, i64 %.11908
  %.12101 = getelementptr double, ptr %94, i64 %.12087
  %.12102 = load double, ptr %.12101, align 8
  %.idx9143 = shl i64 %.11908, 4
  %95 = getelementptr i8, ptr %.12020, i64 %.idx9143
  %96 = getelementptr i8, ptr %95, i64 8
  %.12135 = getelementptr double, ptr %96, i64 %.12087
  %.12136 = load double, ptr %.12135, align 8
  %.379.i = insertelement <8 x double> poison, double %.7549, i64 0
  %.380.i = shufflevector <8 x double> %.379.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.960.i = insertelement <8 x double> poison, double %.12102, i64 0
  %.961.i = shufflevector <8 x double> %.960.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1026.i = insertelement <8 x double> poison, double %.12136, i64 0
  %.1027.i = shufflevector <8 x double> %.1026.i, <8 x double> poison, <8 x i32> zeroinitializer
  br i1 %.290534.not.i, label %_ZN17bnserve_surrogate6kernel5modes5_sums13add_two_modesB4v378B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExbd5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi2EE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi2EE5ArrayIdLi1E1C7mutable7alignedE5TupleIddxE8UniTupleIxLi2EE8UniTupleIdLi2EE8UniTupleIdLi2EE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi4EE.exit, label %B52.lr.ph.i

B52.lr.ph.i:                                      ; preds = %B76209.endif.endif.endif
  %sunkaddr182 = getelementptr i8, ptr %sunkaddr3972, i64 64
  %.11815 = load i64, ptr %sunkaddr182, align 8
  %.641.i = add i64 %.11815, -1
  %.425.i = add i64 %.7617, -1
  %..641.i = tail call i64 @llvm.smax.i64(i64 %.641.i, i64 0)
  %..425.i = tail call i64 @llvm.smax.i64(i64 %.425.i, i64 0)
  %.6.i.i3257 = insertelement <8 x double> poison, double %.7582, i64 0
  %.7.i.i3258 = shufflevector <8 x double> %.6.i.i3257, <8 x double> poison, <8 x i32> zeroinitializer
  %.6.i552.i = insertelement <8 x double> poison, double %.7907, i64 0
  %.7.i553.i = shufflevector <8 x double> %.6.i552.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.6.i558.i = insertelement <8 x double> poison, double %.7941, i64 0
  %.7.i559.i = shufflevector <8 x double> %.6.i558.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.6.i564.i = insertelement <8 x double> poison, double %.3288, i64 0
  %.7.i565.i = shufflevector <8 x double> %.6.i564.i, <8 x double> poison, <8 x i32> zeroinitializer
  %xtraiter.i3259 = and i64 %..425.i, 3
  %xtraiter590.i = and i64 %..641.i, 3
  %97 = lshr i64 %..425.i, 2
  %98 = mul nsw i64 %97, -4
  %99 = lshr i64 %..641.i, 2
  %100 = mul nsw i64 %99, -4
  %101 = icmp slt i64 %.425.i, 1
  %102 = icmp slt i64 %.641.i, 1
  %103 = icmp eq i64 %number.2.1, 0
  %104 = icmp slt i64 %.425.i, 4
  %105 = icmp eq i64 %xtraiter.i3259, 0
  %106 = icmp slt i64 %.641.i, 4
  %107 = icmp eq i64 %xtraiter590.i, 0
  br label %B52.i

B52.i:                                            ; preds = %B77922.i, %B52.lr.ph.i
  %.280.sroa.0.0540.i = phi i64 [ 0, %B52.lr.ph.i ], [ %.280.sroa.0.0.i, %B77922.i ]
  %.2891215539.i = phi i64 [ %math, %B52.lr.ph.i ], [ %.2891215.i, %B77922.i ]
  %.2961252538.i = phi i64 [ 8, %B52.lr.ph.i ], [ %.2961252.i, %B77922.i ]
  %.349.i = getelementptr inbounds double, ptr %.1177, i64 %.280.sroa.0.0540.i
  %.351.i = load <8 x double>, ptr %.349.i, align 8, !noalias !180
  %.8.i.i3261 = fmul contract <8 x double> %.7.i.i3258, %.351.i
  %.381.i = tail call <8 x double> @llvm.minnum.v8f64(<8 x double> %.8.i.i3261, <8 x double> %.380.i)
  br i1 %101, label %B77630.i, label %B734.if.preheader.i

B734.if.preheader.i:                              ; preds = %B52.i
  br i1 %104, label %B734.if.epil.i.preheader, label %B734.if.i

B77630.loopexit.unr-lcssa.i:                      ; preds = %B734.if.i
  br i1 %105, label %B77630.i, label %B734.if.epil.i.preheader

B734.if.epil.i.preheader:                         ; preds = %B77630.loopexit.unr-lcssa.i, %B734.if.preheader.i
  %_velocity_v379_w.2.11203.epil.i.ph = phi <8 x double> [ %.381.i, %B734.if.preheader.i ], [ %.6.i547.3.i, %B77630.loopexit.unr-lcssa.i ]
  br label %B734.if.epil.i

B734.if.epil.i:                                   ; preds = %B734.if.epil.i.preheader, %B734.if.epil.i
  %lsr.iv599.i = phi i64 [ %lsr.iv.next600.i, %B734.if.epil.i ], [ %xtraiter.i3259, %B734.if.epil.i.preheader ]
  %_velocity_v379_w.2.11203.epil.i = phi <8 x double> [ %.6.i547.epil.i, %B734.if.epil.i ], [ %_velocity_v379_w.2.11203.epil.i.ph, %B734.if.epil.i.preheader ]
  %.6.i547.epil.i = fmul contract <8 x double> %.381.i, %_velocity_v379_w.2.11203.epil.i
  %lsr.iv.next600.i = add nsw i64 %lsr.iv599.i, -1
  %epil.iter.cmp.not.i3265 = icmp eq i64 %lsr.iv.next600.i, 0
  br i1 %epil.iter.cmp.not.i3265, label %B77630.i, label %B734.if.epil.i, !llvm.loop !183

B77630.i:                                         ; preds = %B734.if.epil.i, %B77630.loopexit.unr-lcssa.i, %B52.i
  %_velocity_v379_w.2.1.lcssa.i = phi <8 x double> [ %.381.i, %B52.i ], [ %.6.i547.3.i, %B77630.loopexit.unr-lcssa.i ], [ %.6.i547.epil.i, %B734.if.epil.i ]
  br i1 %102, label %B77755.i, label %B77644.if.preheader.i

B77644.if.preheader.i:                            ; preds = %B77630.i
  br i1 %106, label %B77644.if.epil.i.preheader, label %B77644.if.i

B77755.loopexit.unr-lcssa.i:                      ; preds = %B77644.if.i
  br i1 %107, label %B77755.i, label %B77644.if.epil.i.preheader

B77644.if.epil.i.preheader:                       ; preds = %B77755.loopexit.unr-lcssa.i, %B77644.if.preheader.i
  %_velocity_v380_w.2.11211.epil.i.ph = phi <8 x double> [ %.381.i, %B77644.if.preheader.i ], [ %.6.i548.3.i, %B77755.loopexit.unr-lcssa.i ]
  br label %B77644.if.epil.i

B77644.if.epil.i:                                 ; preds = %B77644.if.epil.i.preheader, %B77644.if.epil.i
  %lsr.iv603.i = phi i64 [ %lsr.iv.next604.i, %B77644.if.epil.i ], [ %xtraiter590.i, %B77644.if.epil.i.preheader ]
  %_velocity_v380_w.2.11211.epil.i = phi <8 x double> [ %.6.i548.epil.i, %B77644.if.epil.i ], [ %_velocity_v380_w.2.11211.epil.i.ph, %B77644.if.epil.i.preheader ]
  %.6.i548.epil.i = fmul contract <8 x double> %.381.i, %_velocity_v380_w.2.11211.epil.i
  %lsr.iv.next604.i = add nsw i64 %lsr.iv603.i, -1
  %epil.iter591.cmp.not.i = icmp eq i64 %lsr.iv.next604.i, 0
  br i1 %epil.iter591.cmp.not.i, label %B77755.i, label %B77644.if.epil.i, !llvm.loop !184

B77755.i:                                         ; preds = %B77644.if.epil.i, %B77755.loopexit.unr-lcssa.i, %B77630.i
  %_velocity_v380_w.2.1.lcssa.i = phi <8 x double> [ %.381.i, %B77630.i ], [ %.6.i548.3.i, %B77755.loopexit.unr-lcssa.i ], [ %.6.i548.epil.i, %B77644.if.epil.i ]
  %.772.i = getelementptr inbounds double, ptr %arg.state.10.2.4, i64 %.280.sroa.0.0540.i
  %.774.i = load <8 x double>, ptr %.772.i, align 8, !noalias !180
  %.6.i545.i = fmul contract <8 x double> %_velocity_v379_w.2.1.lcssa.i, %.774.i
  %.815.i = getelementptr inbounds double, ptr %arg.state.10.3.4, i64 %.280.sroa.0.0540.i
  %.817.i3266 = load <8 x double>, ptr %.815.i, align 8, !noalias !180
  %.6.i549.i = fmul contract <8 x double> %_velocity_v379_w.2.1.lcssa.i, %.817.i3266
  %.860.i = getelementptr inbounds double, ptr %arg.state.10.4.4, i64 %.280.sroa.0.0540.i
  %.862.i3267 = load <8 x double>, ptr %.860.i, align 8, !noalias !180
  %.6.i550.i = fmul contract <8 x double> %_velocity_v380_w.2.1.lcssa.i, %.862.i3267
  %.902.i = getelementptr inbounds double, ptr %arg.state.10.5.4, i64 %.280.sroa.0.0540.i
  %.904.i = load <8 x double>, ptr %.902.i, align 8, !noalias !180
  %.6.i551.i = fmul contract <8 x double> %_velocity_v380_w.2.1.lcssa.i, %.904.i
  %.8.i554.i = fmul contract <8 x double> %.7.i553.i, %.6.i545.i
  %.962.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i550.i, <8 x double> %.961.i, <8 x double> %.8.i554.i)
  %.8.i557.i = fmul contract <8 x double> %.7.i553.i, %.6.i549.i
  %.993.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i551.i, <8 x double> %.961.i, <8 x double> %.8.i557.i)
  %.8.i560.i = fmul contract <8 x double> %.7.i559.i, %.6.i545.i
  %.1028.i3268 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i550.i, <8 x double> %.1027.i, <8 x double> %.8.i560.i)
  %.8.i563.i = fmul contract <8 x double> %.7.i559.i, %.6.i549.i
  %.1059.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i551.i, <8 x double> %.1027.i, <8 x double> %.8.i563.i)
  %.1083.i = getelementptr inbounds double, ptr %arg.state.10.1.4, i64 %.280.sroa.0.0540.i
  %.1085.i = load <8 x double>, ptr %.1083.i, align 8, !noalias !180
  %.8.i566.i = fmul contract <8 x double> %.7.i565.i, %.1085.i
  %.1117.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i566.i, <8 x double> splat (double 0x3FE45F306DC9C883), <8 x double> splat (double 0x4338000000000000))
  %.8.i567.i = fadd contract <8 x double> %.1117.i, splat (double 0xC338000000000000)
  %.1158.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i567.i, <8 x double> splat (double 0xBFF921FB54442D18), <8 x double> %.8.i566.i)
  %.1175.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i567.i, <8 x double> splat (double 0xBC91A62633145C07), <8 x double> %.1158.i)
  %.6.i568.i = fmul contract <8 x double> %.1175.i, %.1175.i
  %.6.i569.i = fmul contract <8 x double> %.1175.i, %.6.i568.i
  %.1204.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i568.i, <8 x double> splat (double 0xBD6AE7F3E733B81F), <8 x double> splat (double 0x3DE6124613A86D09))
  %.1207.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i568.i, <8 x double> %.1204.i, <8 x double> splat (double 0xBE5AE64567F544E4))
  %.1210.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i568.i, <8 x double> %.1207.i, <8 x double> splat (double 0x3EC71DE3A556C734))
  %.1213.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i568.i, <8 x double> %.1210.i, <8 x double> splat (double 0xBF2A01A01A01A01A))
  %.1216.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i568.i, <8 x double> %.1213.i, <8 x double> splat (double 0x3F81111111111111))
  %.1219.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i568.i, <8 x double> %.1216.i, <8 x double> splat (double 0xBFC5555555555555))
  %.1244.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i569.i, <8 x double> %.1219.i, <8 x double> %.1175.i)
  %.1249.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i568.i, <8 x double> splat (double 0x3D2AE7F3E733B81F), <8 x double> splat (double 0xBDA93974A8C07C9D))
  %.1252.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i568.i, <8 x double> %.1249.i, <8 x double> splat (double 0x3E21EED8EFF8D898))
  %.1255.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i568.i, <8 x double> %.1252.i, <8 x double> splat (double 0xBE927E4FB7789F5C))
  %.1258.i3269 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i568.i, <8 x double> %.1255.i, <8 x double> splat (double 0x3EFA01A01A01A01A))
  %.1261.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i568.i, <8 x double> %.1258.i3269, <8 x double> splat (double 0xBF56C16C16C16C17))
  %.1264.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i568.i, <8 x double> %.1261.i, <8 x double> splat (double 0x3FA5555555555555))
  %.1267.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i568.i, <8 x double> %.1264.i, <8 x double> splat (double -5.000000e-01))
  %.1270.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i568.i, <8 x double> %.1267.i, <8 x double> splat (double 1.000000e+00))
  %.1271.i = bitcast <8 x double> %.1117.i to <8 x i64>
  %.1272.i = bitcast <8 x double> %.1244.i to <8 x i64>
  %.1273.i = bitcast <8 x double> %.1270.i to <8 x i64>
  %.6.i570.i = xor <8 x i64> %.1273.i, %.1272.i
  %.8.i571.i = and <8 x i64> %.1271.i, splat (i64 1)
  %108 = icmp eq <8 x i64> %.8.i571.i, zeroinitializer
  %.6.i573.i = select <8 x i1> %108, <8 x i64> zeroinitializer, <8 x i64> %.6.i570.i
  %.8.i574.i = shl <8 x i64> %.1271.i, splat (i64 62)
  %.8.i575.i = and <8 x i64> %.8.i574.i, splat (i64 -9223372036854775808)
  %.8.i577.i = add <8 x i64> %.8.i574.i, splat (i64 4611686018427387904)
  %.8.i578.i = and <8 x i64> %.8.i577.i, splat (i64 -9223372036854775808)
  %109 = xor <8 x i64> %.8.i575.i, %.1272.i
  %.6.i580.i = xor <8 x i64> %109, %.6.i573.i
  %110 = bitcast <8 x i64> %.6.i580.i to <8 x double>
  %111 = xor <8 x i64> %.8.i578.i, %.1273.i
  %.6.i582.i = xor <8 x i64> %111, %.6.i573.i
  %112 = bitcast <8 x i64> %.6.i582.i to <8 x double>
  %.1614.i = getelementptr inbounds double, ptr %arg.state.10.0.4, i64 %.280.sroa.0.0540.i
  %.1616.i = load <8 x double>, ptr %.1614.i, align 8, !noalias !180
  %.6.i583.i = fmul contract <8 x double> %.1616.i, %112
  %.6.i584.i = fmul contract <8 x double> %.1616.i, %110
  br i1 %103, label %B77922.i, label %B77769.i

B77769.i:                                         ; preds = %B77755.i
  %.1816.i = getelementptr inbounds double, ptr %arg.state.11.0.4, i64 %.280.sroa.0.0540.i
  %.1818.i = load <8 x double>, ptr %.1816.i, align 8, !noalias !180
  %.1834.i = getelementptr inbounds double, ptr %arg.state.11.1.4, i64 %.280.sroa.0.0540.i
  %.1836.i = load <8 x double>, ptr %.1834.i, align 8, !noalias !180
  %.1852.i = getelementptr inbounds double, ptr %arg.state.11.2.4, i64 %.280.sroa.0.0540.i
  %.1854.i = load <8 x double>, ptr %.1852.i, align 8, !noalias !180
  %.1870.i = getelementptr inbounds double, ptr %arg.state.11.3.4, i64 %.280.sroa.0.0540.i
  %.1872.i = load <8 x double>, ptr %.1870.i, align 8, !noalias !180
  br label %B77922.i

B77922.i:                                         ; preds = %B77769.i, %B77755.i
  %_add_v383_first.2.1.i = phi <8 x double> [ zeroinitializer, %B77755.i ], [ %.1818.i, %B77769.i ]
  %_add_v383_second.2.1.i = phi <8 x double> [ zeroinitializer, %B77755.i ], [ %.1836.i, %B77769.i ]
  %_add_v383_third.2.1.i = phi <8 x double> [ zeroinitializer, %B77755.i ], [ %.1854.i, %B77769.i ]
  %_add_v383_fourth.2.1.i = phi <8 x double> [ zeroinitializer, %B77755.i ], [ %.1872.i, %B77769.i ]
  %.6.i546.i = fsub contract <8 x double> zeroinitializer, %.993.i
  %.1946.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i584.i, <8 x double> %.6.i546.i, <8 x double> %_add_v383_first.2.1.i)
  %.1950.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i583.i, <8 x double> %.962.i, <8 x double> %.1946.i)
  %.1958.i = getelementptr inbounds double, ptr %arg.state.11.0.4, i64 %.280.sroa.0.0540.i
  store <8 x double> %.1950.i, ptr %.1958.i, align 8, !noalias !180
  %.1979.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i584.i, <8 x double> %.962.i, <8 x double> %_add_v383_second.2.1.i)
  %.1983.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i583.i, <8 x double> %.993.i, <8 x double> %.1979.i)
  %.1991.i = getelementptr inbounds double, ptr %arg.state.11.1.4, i64 %.280.sroa.0.0540.i
  store <8 x double> %.1983.i, ptr %.1991.i, align 8, !noalias !180
  %.6.i585.i = fsub contract <8 x double> zeroinitializer, %.1059.i
  %.6.i586.i = fsub contract <8 x double> zeroinitializer, %.1028.i3268
  %.2060.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i584.i, <8 x double> %.6.i586.i, <8 x double> %_add_v383_third.2.1.i)
  %.2064.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i583.i, <8 x double> %.6.i585.i, <8 x double> %.2060.i)
  %.2072.i = getelementptr inbounds double, ptr %arg.state.11.2.4, i64 %.280.sroa.0.0540.i
  store <8 x double> %.2064.i, ptr %.2072.i, align 8, !noalias !180
  %.2137.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i584.i, <8 x double> %.6.i585.i, <8 x double> %_add_v383_fourth.2.1.i)
  %.2143.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i583.i, <8 x double> %.1028.i3268, <8 x double> %.2137.i)
  %.2153.i = getelementptr inbounds double, ptr %arg.state.11.3.4, i64 %.280.sroa.0.0540.i
  store <8 x double> %.2143.i, ptr %.2153.i, align 8, !noalias !180
  %.290.i = icmp sgt i64 %.2891215539.i, 0
  %.303.i = add i64 %.2961252538.i, 8
  %.2961252.i = select i1 %.290.i, i64 %.303.i, i64 %.2961252538.i
  %.299.i = sext i1 %.290.i to i64
  %.2891215.i = add nsw i64 %.2891215539.i, %.299.i
  %.280.sroa.0.0.i = select i1 %.290.i, i64 %.2961252538.i, i64 0
  br i1 %.290.i, label %B52.i, label %_ZN17bnserve_surrogate6kernel5modes5_sums13add_two_modesB4v378B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExbd5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi2EE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi2EE5ArrayIdLi1E1C7mutable7alignedE5TupleIddxE8UniTupleIxLi2EE8UniTupleIdLi2EE8UniTupleIdLi2EE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi4EE.exit

B734.if.i:                                        ; preds = %B734.if.preheader.i, %B734.if.i
  %lsr.iv76 = phi i64 [ %lsr.iv.next77, %B734.if.i ], [ %98, %B734.if.preheader.i ]
  %_velocity_v379_w.2.11203.i = phi <8 x double> [ %.6.i547.3.i, %B734.if.i ], [ %.381.i, %B734.if.preheader.i ]
  %.6.i547.i = fmul contract <8 x double> %.381.i, %_velocity_v379_w.2.11203.i
  %.6.i547.1.i = fmul contract <8 x double> %.381.i, %.6.i547.i
  %.6.i547.2.i = fmul contract <8 x double> %.381.i, %.6.i547.1.i
  %.6.i547.3.i = fmul contract <8 x double> %.381.i, %.6.i547.2.i
  %lsr.iv.next77 = add nsw i64 %lsr.iv76, 4
  %niter.ncmp.3.i3264 = icmp eq i64 %lsr.iv.next77, 0
  br i1 %niter.ncmp.3.i3264, label %B77630.loopexit.unr-lcssa.i, label %B734.if.i

B77644.if.i:                                      ; preds = %B77644.if.preheader.i, %B77644.if.i
  %lsr.iv78 = phi i64 [ %lsr.iv.next79, %B77644.if.i ], [ %100, %B77644.if.preheader.i ]
  %_velocity_v380_w.2.11211.i = phi <8 x double> [ %.6.i548.3.i, %B77644.if.i ], [ %.381.i, %B77644.if.preheader.i ]
  %.6.i548.i = fmul contract <8 x double> %.381.i, %_velocity_v380_w.2.11211.i
  %.6.i548.1.i = fmul contract <8 x double> %.381.i, %.6.i548.i
  %.6.i548.2.i = fmul contract <8 x double> %.381.i, %.6.i548.1.i
  %.6.i548.3.i = fmul contract <8 x double> %.381.i, %.6.i548.2.i
  %lsr.iv.next79 = add nsw i64 %lsr.iv78, 4
  %niter596.ncmp.3.i = icmp eq i64 %lsr.iv.next79, 0
  br i1 %niter596.ncmp.3.i, label %B77755.loopexit.unr-lcssa.i, label %B77644.if.i

_ZN17bnserve_surrogate6kernel5modes5_sums13add_two_modesB4v378B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExbd5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi2EE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi2EE5ArrayIdLi1E1C7mutable7alignedE5TupleIddxE8UniTupleIxLi2EE8UniTupleIdLi2EE8UniTupleIdLi2EE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi4EE.exit: ; preds = %B77922.i, %B76209.endif.endif.endif
  %.12153 = add nsw i64 %k.7.3, 2
  %.12285 = load i64, ptr %.526, align 8
  %.12286 = icmp slt i64 %.12153, %.12285
  br i1 %.12286, label %B820.backedge, label %B76211
}

; Function Attrs: nofree noinline norecurse nosync nounwind memory(readwrite, inaccessiblemem: none, target_mem0: none, target_mem1: none)
define internal fastcc void @inner_22(ptr noalias nonnull writeonly captures(none) %retptr, i64 %arg.i, i64 %arg.lane, i64 %arg.ends.0, i64 %arg.ends.1, i64 %arg.ends.2, ptr readonly captures(none) %arg.state.0.4, ptr readonly captures(none) %arg.state.1.4, ptr readonly captures(none) %arg.state.2.4, ptr readonly captures(none) %arg.state.3.4, i64 range(i64 40, 9) %arg.state.3.5.0, ptr readonly captures(none) %arg.state.4.4, i64 range(i64 8, 1) %arg.state.5.0, i64 range(i64 8, 1) %arg.state.5.1, i8 range(i8 0, 2) %arg.state.6, ptr readonly captures(none) %arg.state.7.0.4, ptr readonly captures(none) %arg.state.7.1.4, ptr readonly captures(none) %arg.state.8.0.4, ptr readonly captures(none) %arg.state.8.1.4, double %arg.state.9.0, double %arg.state.9.1, double %arg.state.9.2, ptr captures(none) %arg.state.10.0.4, ptr captures(none) %arg.state.10.1.4, ptr captures(none) %arg.state.10.2.4, ptr captures(none) %arg.state.10.3.4, ptr captures(none) %arg.state.12.4, ptr captures(none) %arg.state.13.4, ptr captures(none) %arg.state.14.4) unnamed_addr #4 {
entry:
  %.3082 = alloca ptr, align 8
  store ptr null, ptr %.3082, align 8
  %.3433 = alloca ptr, align 8
  store ptr null, ptr %.3433, align 8
  %.7111 = alloca ptr, align 8
  store ptr null, ptr %.7111, align 8
  %.498 = getelementptr i8, ptr %arg.state.0.4, i64 168
  %.499 = load i64, ptr %.498, align 8
  %.500 = inttoptr i64 %.499 to ptr
  %.554 = sub i64 %arg.ends.1, %arg.ends.0
  %.639 = getelementptr i8, ptr %arg.state.0.4, i64 32
  %.706 = getelementptr i8, ptr %arg.state.0.4, i64 24
  %.707 = load i64, ptr %.706, align 8
  %.709 = inttoptr i64 %.707 to ptr
  %.1149 = load i64, ptr %.639, align 8
  %.idx = shl i64 %.1149, 4
  %0 = getelementptr i8, ptr %.709, i64 %.idx
  %.1166 = getelementptr double, ptr %0, i64 %arg.ends.0
  %.1359 = load i64, ptr %.500, align 8
  %.14396681.not = icmp slt i64 %.1359, 1
  br i1 %.14396681.not, label %B316613, label %B630.if.lr.ph

B824:                                             ; preds = %B630.if
  %.1700 = add nsw i64 %number.2.06687, 1
  %.1975 = load i64, ptr %.639, align 8
  %.2042 = load i64, ptr %.706, align 8
  %.2044 = inttoptr i64 %.2042 to ptr
  %.2568 = mul nsw i64 %.1700, %.2567
  %.2579 = getelementptr double, ptr %arg.state.12.4, i64 %.2568
  %.2642 = getelementptr i8, ptr %.2579, i64 320
  %.2705 = getelementptr i8, ptr %.2579, i64 384
  %.2771 = getelementptr i8, ptr %.2579, i64 512
  store ptr null, ptr %.3082, align 8
  call fastcc void @inner_25(ptr nonnull %.3082, i64 %arg.ends.0, i64 %arg.ends.1, i8 %arg.state.6, ptr %.2044, i64 %.1975, ptr %arg.state.3.4, i64 %arg.state.3.5.0, ptr %arg.state.1.4, ptr %arg.state.2.4, i64 %arg.state.5.0, i64 %arg.state.5.1, ptr %arg.state.7.0.4, ptr %arg.state.7.1.4, ptr %arg.state.8.0.4, ptr %arg.state.8.1.4, double %arg.state.9.0, double %arg.state.9.1, double %arg.state.9.2, ptr %.2579, ptr %.2642, ptr %.2705, ptr %.2771, ptr %arg.state.10.2.4, ptr %arg.state.10.3.4, ptr %arg.state.10.0.4, ptr %arg.state.10.1.4)
  br i1 %.117323.not.i, label %B157811, label %B48.if.preheader.i

B157811:                                          ; preds = %B48.if.i, %B824, %B630.if
  %number.3.1 = phi i64 [ %number.2.06687, %B630.if ], [ %.1700, %B824 ], [ %.1700, %B48.if.i ]
  %order.3.1 = phi i64 [ %order.2.06688, %B630.if ], [ %.1645, %B824 ], [ %.1645, %B48.if.i ]
  %carrier.1.sroa.121.1 = phi ptr [ %carrier.2.sroa.110.06684, %B630.if ], [ %.2642, %B824 ], [ %.2642, %B48.if.i ]
  %.3348 = load i64, ptr %.500, align 8
  %.3350 = mul nsw i64 %.3348, %arg.i
  %sunkaddr41 = getelementptr i8, ptr %12, i64 56
  %.3380 = load i64, ptr %sunkaddr41, align 8
  %.3381 = add nsw i64 %.3350, %.3380
  %sunkaddr45 = getelementptr i8, ptr %12, i64 64
  %.3414 = load i64, ptr %sunkaddr45, align 8
  %.3415 = icmp eq i64 %.3414, 0
  br i1 %.3415, label %B157813, label %B316204

B157813:                                          ; preds = %B157811
  store ptr null, ptr %.3433, align 8
  call fastcc void @inner_27(ptr nonnull %.3433, i64 %.3381, i64 %arg.ends.0, i64 %arg.ends.2, ptr %arg.state.0.4, i64 %.554, ptr %arg.state.10.0.4, ptr %arg.state.10.1.4, ptr %arg.state.14.4)
  br label %B316611

B316204:                                          ; preds = %B157811
  %sunkaddr50 = getelementptr i8, ptr %12, i64 72
  %.3761 = load i64, ptr %sunkaddr50, align 8
  %.3762 = inttoptr i64 %.3761 to ptr
  %sunkaddr54 = getelementptr i8, ptr %12, i64 88
  %.3839 = load i64, ptr %sunkaddr54, align 8
  %.3840 = inttoptr i64 %.3839 to ptr
  %.3922 = getelementptr i8, ptr %.3762, i64 64
  %.3923 = load i64, ptr %.3922, align 8
  %.3924 = sub i64 0, %.3923
  %.3932.1 = and i64 %.3924, -8
  %.3966 = sub i64 0, %.3932.1
  %sunkaddr59 = getelementptr i8, ptr %12, i64 96
  %.3996 = load i64, ptr %sunkaddr59, align 8
  %.4000 = ashr i64 %.3996, 1
  %.4013 = getelementptr inbounds double, ptr %arg.state.13.4, i64 %.4000
  %.4065 = shl nsw i64 %.3966, 2
  %.4138 = getelementptr inbounds double, ptr %.4013, i64 %.4065
  %.4216.idx = shl i64 %.3966, 6
  %.4216 = getelementptr i8, ptr %.4013, i64 %.4216.idx
  %.4363 = getelementptr i8, ptr %.3762, i64 120
  %.4364 = load i64, ptr %.4363, align 8
  %.4377 = getelementptr inbounds double, ptr %.3840, i64 %.4364
  %sunkaddr62 = getelementptr i8, ptr %12, i64 104
  %.4741 = load i64, ptr %sunkaddr62, align 8
  %.idx6120 = mul i64 %.4741, 72
  %1 = getelementptr i8, ptr %.500, i64 %.idx6120
  %.4864 = getelementptr i8, ptr %1, i64 72
  %.4865 = load i64, ptr %.4864, align 8
  %.4866 = inttoptr i64 %.4865 to ptr
  %.5026 = getelementptr i8, ptr %.4866, i64 64
  %.5027 = load i64, ptr %.5026, align 8
  %.5099 = getelementptr i8, ptr %1, i64 96
  %.5100 = load i64, ptr %.5099, align 8
  %.5104 = ashr i64 %.5100, 1
  %.5117 = getelementptr inbounds double, ptr %arg.state.13.4, i64 %.5104
  %.neg = mul i64 %.5027, -64
  %2 = and i64 %.neg, -512
  %.5320.idx = sub i64 0, %2
  %.5320 = getelementptr i8, ptr %.5117, i64 %.5320.idx
  %.5387 = getelementptr i8, ptr %.5320, i64 64
  %.5737 = mul nsw i64 %.4065, %arg.lane
  %3 = getelementptr double, ptr %arg.state.4.4, i64 %.3996
  %.5753 = getelementptr double, ptr %3, i64 %.5737
  %.5834 = shl nsw i64 %.3966, 1
  %.5877.inv = icmp sgt i64 %.3923, 0
  %.5878 = select i1 %.5877.inv, i64 0, i64 %.4065
  %4 = getelementptr double, ptr %.5753, i64 %.3923
  %5 = getelementptr i8, ptr %4, i64 -8
  %.5892 = getelementptr double, ptr %5, i64 %.5878
  %.5893 = load double, ptr %.5892, align 8
  %.5896 = add nsw i64 %.5834, %.3923
  %.5910.inv = icmp sgt i64 %.5896, 0
  %.5911 = select i1 %.5910.inv, i64 0, i64 %.4065
  %6 = getelementptr double, ptr %.5753, i64 %.5896
  %7 = getelementptr i8, ptr %6, i64 -8
  %.5925 = getelementptr double, ptr %7, i64 %.5911
  %.5926 = load double, ptr %.5925, align 8
  %.6089 = load i64, ptr %.706, align 8
  %.6091 = inttoptr i64 %.6089 to ptr
  %.6607 = load i64, ptr %.639, align 8
  %.6623 = getelementptr double, ptr %.6091, i64 %.6607
  %.6712 = getelementptr i8, ptr %carrier.1.sroa.121.1, i64 8
  %.6713 = load double, ptr %.6712, align 8
  %.173.i = load i64, ptr %.4216, align 8, !noalias !185
  %.13.i.i = tail call i64 @llvm.smax.i64(i64 %arg.ends.0, i64 %.173.i)
  %.13.i1.i = tail call i64 @llvm.smin.i64(i64 %arg.ends.1, i64 %.13.i.i)
  %.262.i = getelementptr i8, ptr %.4216, i64 8
  %.263.i = load i64, ptr %.262.i, align 8, !noalias !185
  %.13.i2.i = tail call i64 @llvm.smax.i64(i64 %arg.ends.0, i64 %.263.i)
  %.13.i3.i = tail call i64 @llvm.smin.i64(i64 %arg.ends.1, i64 %.13.i2.i)
  %.330.i687 = sub nsw i64 %.13.i1.i, %arg.ends.0
  %8 = add i64 %.330.i687, 7
  %.389.i = lshr i64 %8, 3
  %.368.inv.i = icmp slt i64 %.330.i687, 1
  %.410442.not453.i = icmp eq i64 %.389.i, 0
  %.410442.not.i = or i1 %.368.inv.i, %.410442.not453.i
  br i1 %.410442.not.i, label %B348.i, label %B198.if.lr.ph.i

B316611:                                          ; preds = %B157813, %_ZN17bnserve_surrogate6kernel5modes5_sums13multiply_modeB4v453B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi2EE5ArrayIdLi1E1C7mutable7alignedE5TupleIddxE.exit
  %exitcond.not = icmp eq i64 %.1452, %.1359
  br i1 %exitcond.not, label %B316613, label %B630.if

B316613:                                          ; preds = %B316611, %entry
  store ptr null, ptr %retptr, align 8
  ret void

B630.if.lr.ph:                                    ; preds = %entry
  %.13.i = tail call i64 @llvm.smax.i64(i64 %arg.state.5.1, i64 %arg.state.5.0)
  %.2567 = add nsw i64 %.13.i, 64
  %9 = add i64 %.554, 7
  %.96.i = lshr i64 %9, 3
  %.73.inv.i = icmp slt i64 %.554, 1
  %.117323.not517.i = icmp eq i64 %.96.i, 0
  %.117323.not.i = or i1 %.73.inv.i, %.117323.not517.i
  %.163279.not.i = select i1 %.73.inv.i, i1 true, i1 %.117323.not517.i
  %scevgep1022 = getelementptr i8, ptr %arg.state.13.4, i64 72
  %10 = mul i64 %arg.ends.0, -8
  %scevgep1027 = getelementptr i8, ptr %arg.state.10.3.4, i64 %10
  %scevgep1029 = getelementptr i8, ptr %arg.state.10.2.4, i64 %10
  %11 = add nuw nsw i64 %.96.i, 6
  %sunkaddr94 = getelementptr i8, ptr %.500, i64 16
  br label %B630.if

B630.if:                                          ; preds = %B630.if.lr.ph, %B316611
  %.1383.0 = phi i64 [ 0, %B630.if.lr.ph ], [ %.1452, %B316611 ]
  %order.2.06688 = phi i64 [ 0, %B630.if.lr.ph ], [ %order.3.1, %B316611 ]
  %number.2.06687 = phi i64 [ -1, %B630.if.lr.ph ], [ %number.3.1, %B316611 ]
  %carrier.2.sroa.110.06684 = phi ptr [ null, %B630.if.lr.ph ], [ %carrier.1.sroa.121.1, %B316611 ]
  %.1452 = add nuw nsw i64 %.1383.0, 1
  %.idx6119 = mul i64 %.1383.0, 72
  %12 = getelementptr i8, ptr %.500, i64 %.idx6119
  %.1547 = getelementptr i8, ptr %12, i64 48
  %.1645 = load i64, ptr %.1547, align 8
  %.1647.not = icmp eq i64 %.1645, %order.2.06688
  br i1 %.1647.not, label %B157811, label %B824

B48.if.preheader.i:                               ; preds = %B824
  %.3281 = sitofp i64 %.1645 to double
  %.3282 = fmul contract double %.3281, 5.000000e-01
  %.6.i.i = insertelement <8 x double> poison, double %.3282, i64 0
  %.7.i.i = shufflevector <8 x double> %.6.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  br label %B48.if.i

B48.if.i:                                         ; preds = %B48.if.i, %B48.if.preheader.i
  %lsr.iv2 = phi i64 [ %lsr.iv.next3, %B48.if.i ], [ %11, %B48.if.preheader.i ]
  %lsr.iv209.i = phi i64 [ %lsr.iv.next210.i, %B48.if.i ], [ 0, %B48.if.preheader.i ]
  %scevgep211.i = getelementptr i8, ptr %arg.state.10.1.4, i64 %lsr.iv209.i
  %.165.i = load <8 x double>, ptr %scevgep211.i, align 8, !noalias !188
  %.8.i.i = fmul contract <8 x double> %.7.i.i, %.165.i
  %.195.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i.i, <8 x double> splat (double 0x3FE45F306DC9C883), <8 x double> splat (double 0x4338000000000000))
  %.8.i191.i = fadd contract <8 x double> %.195.i, splat (double 0xC338000000000000)
  %.236.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i191.i, <8 x double> splat (double 0xBFF921FB54442D18), <8 x double> %.8.i.i)
  %.253.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i191.i, <8 x double> splat (double 0xBC91A62633145C07), <8 x double> %.236.i)
  %.6.i192.i = fmul contract <8 x double> %.253.i, %.253.i
  %.6.i193.i = fmul contract <8 x double> %.253.i, %.6.i192.i
  %.282.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i192.i, <8 x double> splat (double 0xBD6AE7F3E733B81F), <8 x double> splat (double 0x3DE6124613A86D09))
  %.285.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i192.i, <8 x double> %.282.i, <8 x double> splat (double 0xBE5AE64567F544E4))
  %.288.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i192.i, <8 x double> %.285.i, <8 x double> splat (double 0x3EC71DE3A556C734))
  %.291.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i192.i, <8 x double> %.288.i, <8 x double> splat (double 0xBF2A01A01A01A01A))
  %.294.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i192.i, <8 x double> %.291.i, <8 x double> splat (double 0x3F81111111111111))
  %.297.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i192.i, <8 x double> %.294.i, <8 x double> splat (double 0xBFC5555555555555))
  %.322.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i193.i, <8 x double> %.297.i, <8 x double> %.253.i)
  %.327.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i192.i, <8 x double> splat (double 0x3D2AE7F3E733B81F), <8 x double> splat (double 0xBDA93974A8C07C9D))
  %.330.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i192.i, <8 x double> %.327.i, <8 x double> splat (double 0x3E21EED8EFF8D898))
  %.333.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i192.i, <8 x double> %.330.i, <8 x double> splat (double 0xBE927E4FB7789F5C))
  %.336.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i192.i, <8 x double> %.333.i, <8 x double> splat (double 0x3EFA01A01A01A01A))
  %.339.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i192.i, <8 x double> %.336.i, <8 x double> splat (double 0xBF56C16C16C16C17))
  %.342.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i192.i, <8 x double> %.339.i, <8 x double> splat (double 0x3FA5555555555555))
  %.345.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i192.i, <8 x double> %.342.i, <8 x double> splat (double -5.000000e-01))
  %.348.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i192.i, <8 x double> %.345.i, <8 x double> splat (double 1.000000e+00))
  %.349.i = bitcast <8 x double> %.195.i to <8 x i64>
  %.350.i = bitcast <8 x double> %.322.i to <8 x i64>
  %.351.i = bitcast <8 x double> %.348.i to <8 x i64>
  %.6.i194.i = xor <8 x i64> %.351.i, %.350.i
  %.8.i195.i = and <8 x i64> %.349.i, splat (i64 1)
  %13 = icmp eq <8 x i64> %.8.i195.i, zeroinitializer
  %.6.i197.i = select <8 x i1> %13, <8 x i64> zeroinitializer, <8 x i64> %.6.i194.i
  %.8.i198.i = shl <8 x i64> %.349.i, splat (i64 62)
  %.8.i199.i = and <8 x i64> %.8.i198.i, splat (i64 -9223372036854775808)
  %.8.i201.i = add <8 x i64> %.8.i198.i, splat (i64 4611686018427387904)
  %.8.i202.i = and <8 x i64> %.8.i201.i, splat (i64 -9223372036854775808)
  %14 = xor <8 x i64> %.8.i199.i, %.350.i
  %.6.i204.i = xor <8 x i64> %14, %.6.i197.i
  %15 = bitcast <8 x i64> %.6.i204.i to <8 x double>
  %16 = xor <8 x i64> %.8.i202.i, %.351.i
  %.6.i206.i = xor <8 x i64> %16, %.6.i197.i
  %17 = bitcast <8 x i64> %.6.i206.i to <8 x double>
  %scevgep.i = getelementptr i8, ptr %arg.state.10.0.4, i64 %lsr.iv209.i
  %.695.i = load <8 x double>, ptr %scevgep.i, align 8, !noalias !188
  %.6.i207.i = fmul contract <8 x double> %.695.i, %17
  store <8 x double> %.6.i207.i, ptr %scevgep.i, align 8, !noalias !188
  %.6.i208.i = fmul contract <8 x double> %.695.i, %15
  store <8 x double> %.6.i208.i, ptr %scevgep211.i, align 8, !noalias !188
  %lsr.iv.next210.i = add i64 %lsr.iv209.i, 64
  %lsr.iv.next3 = add nsw i64 %lsr.iv2, -1
  %.117.i = icmp sgt i64 %lsr.iv2, 7
  br i1 %.117.i, label %B48.if.i, label %B157811

B348.loopexit.unr-lcssa.i:                        ; preds = %B198.if.i
  %lcmp.mod.not.i = icmp eq i64 %xtraiter.i, 0
  br i1 %lcmp.mod.not.i, label %B348.i, label %B198.if.epil.preheader.i

B198.if.epil.preheader.i:                         ; preds = %B198.if.lr.ph.i, %B348.loopexit.unr-lcssa.i
  %.416441443.epil.init.i = phi i64 [ 0, %B198.if.lr.ph.i ], [ %.423.3.i, %B348.loopexit.unr-lcssa.i ]
  %18 = shl i64 %.416441443.epil.init.i, 3
  %scevgep51.i = getelementptr i8, ptr %arg.state.10.3.4, i64 %18
  %scevgep55.i = getelementptr i8, ptr %arg.state.10.2.4, i64 %18
  %19 = shl nuw nsw i64 %xtraiter.i, 6
  br label %B198.if.epil.i

B198.if.epil.i:                                   ; preds = %B198.if.epil.i, %B198.if.epil.preheader.i
  %lsr.iv52.i = phi i64 [ %lsr.iv.next53.i, %B198.if.epil.i ], [ 0, %B198.if.epil.preheader.i ]
  %scevgep56.i = getelementptr i8, ptr %scevgep55.i, i64 %lsr.iv52.i
  store <8 x double> %.451.i, ptr %scevgep56.i, align 8, !noalias !185
  %scevgep54.i = getelementptr i8, ptr %scevgep51.i, i64 %lsr.iv52.i
  store <8 x double> %.465.i, ptr %scevgep54.i, align 8, !noalias !185
  %lsr.iv.next53.i = add nuw nsw i64 %lsr.iv52.i, 64
  %epil.iter.cmp.not.i = icmp eq i64 %19, %lsr.iv.next53.i
  br i1 %epil.iter.cmp.not.i, label %B348.i, label %B198.if.epil.i, !llvm.loop !191

B348.i:                                           ; preds = %B198.if.epil.i, %B348.loopexit.unr-lcssa.i, %B316204
  %.487.i = sub nsw i64 %.13.i3.i, %arg.ends.0
  %sunkaddr66 = getelementptr i8, ptr %.4216, i64 16
  %.653.i = load i64, ptr %sunkaddr66, align 8, !noalias !185
  %.126.i.i = icmp slt i64 %.13.i.i, %.13.i3.i
  br i1 %.126.i.i, label %B22.preheader.i.i, label %B348.endif.endif.endif.i

B198.if.lr.ph.i:                                  ; preds = %B316204
  %20 = getelementptr double, ptr %.5753, i64 %.5834
  %.5847 = icmp slt i64 %.3966, 0
  %.5848 = select i1 %.5847, i64 %.4065, i64 0
  %.5862 = getelementptr double, ptr %20, i64 %.5848
  %.5863 = load double, ptr %.5862, align 8
  %.5832 = load double, ptr %.5753, align 8
  %.450.i = insertelement <8 x double> poison, double %.5832, i64 0
  %.451.i = shufflevector <8 x double> %.450.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.464.i = insertelement <8 x double> poison, double %.5863, i64 0
  %.465.i = shufflevector <8 x double> %.464.i, <8 x double> poison, <8 x i32> zeroinitializer
  %21 = add nsw i64 %.389.i, -1
  %xtraiter.i = and i64 %.389.i, 3
  %22 = icmp ult i64 %21, 3
  br i1 %22, label %B198.if.epil.preheader.i, label %B198.if.lr.ph.new.i

B198.if.lr.ph.new.i:                              ; preds = %B198.if.lr.ph.i
  %23 = lshr i64 %8, 5
  %24 = mul nsw i64 %23, -4
  br label %B198.if.i

B198.if.i:                                        ; preds = %B198.if.i, %B198.if.lr.ph.new.i
  %lsr.iv4 = phi i64 [ %lsr.iv.next5, %B198.if.i ], [ %24, %B198.if.lr.ph.new.i ]
  %.416441443.i = phi i64 [ %.423.3.i, %B198.if.i ], [ 0, %B198.if.lr.ph.new.i ]
  %sunkaddr67 = shl i64 %.416441443.i, 3
  %sunkaddr68 = getelementptr i8, ptr %arg.state.10.2.4, i64 %sunkaddr67
  store <8 x double> %.451.i, ptr %sunkaddr68, align 8, !noalias !185
  %sunkaddr70 = getelementptr i8, ptr %arg.state.10.3.4, i64 %sunkaddr67
  store <8 x double> %.465.i, ptr %sunkaddr70, align 8, !noalias !185
  %sunkaddr73 = getelementptr i8, ptr %sunkaddr68, i64 64
  store <8 x double> %.451.i, ptr %sunkaddr73, align 8, !noalias !185
  %sunkaddr76 = getelementptr i8, ptr %sunkaddr70, i64 64
  store <8 x double> %.465.i, ptr %sunkaddr76, align 8, !noalias !185
  %sunkaddr79 = getelementptr i8, ptr %sunkaddr68, i64 128
  store <8 x double> %.451.i, ptr %sunkaddr79, align 8, !noalias !185
  %sunkaddr82 = getelementptr i8, ptr %sunkaddr70, i64 128
  store <8 x double> %.465.i, ptr %sunkaddr82, align 8, !noalias !185
  %.423.3.i = add i64 %.416441443.i, 32
  %sunkaddr84 = shl i64 %.423.3.i, 3
  %sunkaddr85 = getelementptr i8, ptr %arg.state.10.2.4, i64 %sunkaddr84
  %sunkaddr86 = getelementptr i8, ptr %sunkaddr85, i64 -64
  store <8 x double> %.451.i, ptr %sunkaddr86, align 8, !noalias !185
  %sunkaddr88 = getelementptr i8, ptr %arg.state.10.3.4, i64 %sunkaddr84
  %sunkaddr89 = getelementptr i8, ptr %sunkaddr88, i64 -64
  store <8 x double> %.465.i, ptr %sunkaddr89, align 8, !noalias !185
  %lsr.iv.next5 = add i64 %lsr.iv4, 4
  %niter.ncmp.3.not.i = icmp eq i64 %lsr.iv.next5, 0
  br i1 %niter.ncmp.3.not.i, label %B348.loopexit.unr-lcssa.i, label %B198.if.i

B22.preheader.i.i:                                ; preds = %B348.i
  %.277.i.i = mul i64 %.3932.1, -3
  %25 = shl i64 %.5104, 3
  %26 = sub i64 %25, %2
  %scevgep1023 = getelementptr i8, ptr %scevgep1022, i64 %26
  br label %B22.i.i

B22.i.i:                                          ; preds = %B926.i.i, %B22.preheader.i.i
  %cell.2.0.i.i = phi i64 [ %cell.3.2.i.i, %B926.i.i ], [ %.653.i, %B22.preheader.i.i ]
  %start.2.0.i.i = phi i64 [ %.13.i.i.i, %B926.i.i ], [ %.13.i1.i, %B22.preheader.i.i ]
  %.149.i.i = getelementptr inbounds i64, ptr %.5387, i64 %cell.2.0.i.i
  %.150.i.i = load i64, ptr %.149.i.i, align 8, !noalias !192
  %.154.not.i.i = icmp sgt i64 %.150.i.i, %start.2.0.i.i
  br i1 %.154.not.i.i, label %B112.i.i, label %B62.i.i

B62.i.i:                                          ; preds = %B22.i.i, %B62.i.i
  %cell.4.1.i.i = phi i64 [ %.157.i.i, %B62.i.i ], [ %cell.2.0.i.i, %B22.i.i ]
  %.157.i.i = add i64 %cell.4.1.i.i, 1
  %27 = shl i64 %cell.4.1.i.i, 3
  %scevgep1024 = getelementptr i8, ptr %scevgep1023, i64 %27
  %.170.i.i = load i64, ptr %scevgep1024, align 8, !noalias !192
  %.172.not.i.i = icmp sgt i64 %.170.i.i, %start.2.0.i.i
  br i1 %.172.not.i.i, label %B112.i.i, label %B62.i.i

B112.i.i:                                         ; preds = %B62.i.i, %B22.i.i
  %cell.3.2.i.i = phi i64 [ %cell.2.0.i.i, %B22.i.i ], [ %.157.i.i, %B62.i.i ]
  %.184.i.i = getelementptr inbounds i64, ptr %.5387, i64 %cell.3.2.i.i
  %.185.i.i = load i64, ptr %.184.i.i, align 8, !noalias !192
  %.13.i.i.i = tail call i64 @llvm.smin.i64(i64 %.13.i3.i, i64 %.185.i.i)
  %.395.i.i = sub i64 %.13.i.i.i, %start.2.0.i.i
  %28 = add i64 %.395.i.i, 7
  %.417.i.i = lshr i64 %28, 3
  %.396.inv.i.i = icmp slt i64 %.395.i.i, 1
  %.438305.not326.i.i = icmp eq i64 %.417.i.i, 0
  %.438305.not.i.i = or i1 %.396.inv.i.i, %.438305.not326.i.i
  br i1 %.438305.not.i.i, label %B926.i.i, label %B570.if.lr.ph.i.i

B926.i.i:                                         ; preds = %B570.if.i.i, %B112.i.i
  %.602.i.i = icmp slt i64 %.185.i.i, %.13.i3.i
  br i1 %.602.i.i, label %B22.i.i, label %B348.endif.endif.endif.i

B570.if.lr.ph.i.i:                                ; preds = %B112.i.i
  %.228.i.i = getelementptr inbounds double, ptr %.4377, i64 %cell.3.2.i.i
  %.229.i.i = load double, ptr %.228.i.i, align 8, !noalias !192
  %.231.i.i = fsub contract double %.6713, %.229.i.i
  %.279.i.i = add nsw i64 %cell.3.2.i.i, %.277.i.i
  %.347.i.i = getelementptr inbounds double, ptr %.4138, i64 %.279.i.i
  %.348.i.i = load double, ptr %.347.i.i, align 8, !noalias !192
  %.266.i.i = add nsw i64 %cell.3.2.i.i, %.5834
  %.334.i.i = getelementptr inbounds double, ptr %.4138, i64 %.266.i.i
  %.335.i.i = load double, ptr %.334.i.i, align 8, !noalias !192
  %.247.i.i = sub i64 %cell.3.2.i.i, %.3932.1
  %.315.i.i = getelementptr inbounds double, ptr %.4138, i64 %.247.i.i
  %.316.i.i = load double, ptr %.315.i.i, align 8, !noalias !192
  %.303.i.i = getelementptr inbounds double, ptr %.4138, i64 %cell.3.2.i.i
  %.304.i.i = load double, ptr %.303.i.i, align 8, !noalias !192
  %.287.i.i = getelementptr inbounds double, ptr %.4013, i64 %.279.i.i
  %.288.i.i = load double, ptr %.287.i.i, align 8, !noalias !192
  %.274.i.i = getelementptr inbounds double, ptr %.4013, i64 %.266.i.i
  %.275.i.i = load double, ptr %.274.i.i, align 8, !noalias !192
  %.255.i.i = getelementptr inbounds double, ptr %.4013, i64 %.247.i.i
  %.256.i.i = load double, ptr %.255.i.i, align 8, !noalias !192
  %.243.i.i = getelementptr inbounds double, ptr %.4013, i64 %cell.3.2.i.i
  %.244.i.i = load double, ptr %.243.i.i, align 8, !noalias !192
  %.514.i.i = insertelement <8 x double> poison, double %.288.i.i, i64 0
  %.515.i.i = shufflevector <8 x double> %.514.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.517.i.i = insertelement <8 x double> poison, double %.275.i.i, i64 0
  %.518.i.i = shufflevector <8 x double> %.517.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.521.i.i = insertelement <8 x double> poison, double %.256.i.i, i64 0
  %.522.i.i = shufflevector <8 x double> %.521.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.525.i.i = insertelement <8 x double> poison, double %.244.i.i, i64 0
  %.526.i.i = shufflevector <8 x double> %.525.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.541.i.i = insertelement <8 x double> poison, double %.348.i.i, i64 0
  %.542.i.i = shufflevector <8 x double> %.541.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.544.i.i = insertelement <8 x double> poison, double %.335.i.i, i64 0
  %.545.i.i = shufflevector <8 x double> %.544.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.548.i.i = insertelement <8 x double> poison, double %.316.i.i, i64 0
  %.549.i.i = shufflevector <8 x double> %.548.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.552.i.i = insertelement <8 x double> poison, double %.304.i.i, i64 0
  %.553.i.i = shufflevector <8 x double> %.552.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.6.i.i.i = insertelement <8 x double> poison, double %.231.i.i, i64 0
  %.7.i.i.i = shufflevector <8 x double> %.6.i.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %29 = shl i64 %start.2.0.i.i, 3
  %30 = add nuw nsw i64 %.417.i.i, 7
  br label %B570.if.i.i

B570.if.i.i:                                      ; preds = %B570.if.i.i, %B570.if.lr.ph.i.i
  %lsr.iv21 = phi i64 [ %lsr.iv.next22, %B570.if.i.i ], [ %30, %B570.if.lr.ph.i.i ]
  %lsr.iv8.i.i = phi i64 [ %lsr.iv.next9.i.i, %B570.if.i.i ], [ %29, %B570.if.lr.ph.i.i ]
  %scevgep13.i.i = getelementptr i8, ptr %.6623, i64 %lsr.iv8.i.i
  %.485.i.i = load <8 x double>, ptr %scevgep13.i.i, align 8, !noalias !192
  %.8.i.i.i = fadd contract <8 x double> %.7.i.i.i, %.485.i.i
  %.519.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i.i.i, <8 x double> %.515.i.i, <8 x double> %.518.i.i)
  %.523.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i.i.i, <8 x double> %.519.i.i, <8 x double> %.522.i.i)
  %.527.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i.i.i, <8 x double> %.523.i.i, <8 x double> %.526.i.i)
  %scevgep1030 = getelementptr i8, ptr %scevgep1029, i64 %lsr.iv8.i.i
  store <8 x double> %.527.i.i, ptr %scevgep1030, align 8, !noalias !192
  %.546.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i.i.i, <8 x double> %.542.i.i, <8 x double> %.545.i.i)
  %.550.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i.i.i, <8 x double> %.546.i.i, <8 x double> %.549.i.i)
  %.554.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i.i.i, <8 x double> %.550.i.i, <8 x double> %.553.i.i)
  %scevgep1028 = getelementptr i8, ptr %scevgep1027, i64 %lsr.iv8.i.i
  store <8 x double> %.554.i.i, ptr %scevgep1028, align 8, !noalias !192
  %lsr.iv.next9.i.i = add i64 %lsr.iv8.i.i, 64
  %lsr.iv.next22 = add nsw i64 %lsr.iv21, -1
  %.438.i.i = icmp sgt i64 %lsr.iv21, 8
  br i1 %.438.i.i, label %B570.if.i.i, label %B926.i.i

B348.endif.endif.endif.i:                         ; preds = %B926.i.i, %B348.i
  %cell.5.1.i.i = phi i64 [ %.653.i, %B348.i ], [ %cell.3.2.i.i, %B926.i.i ]
  store i64 %cell.5.1.i.i, ptr %sunkaddr66, align 8, !noalias !185
  %.835.i = sub i64 %arg.ends.1, %.13.i3.i
  %31 = add i64 %.835.i, 7
  %.857.i = lshr i64 %31, 3
  %.836.inv.i = icmp slt i64 %.835.i, 1
  %.878448.not454.i = icmp eq i64 %.857.i, 0
  %.878448.not.i = or i1 %.836.inv.i, %.878448.not454.i
  br i1 %.878448.not.i, label %B316533.endif.endif.endif, label %B590.if.lr.ph.i

B590.if.lr.ph.i:                                  ; preds = %B348.endif.endif.endif.i
  %.918.i = insertelement <8 x double> poison, double %.5893, i64 0
  %.919.i = shufflevector <8 x double> %.918.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.932.i = insertelement <8 x double> poison, double %.5926, i64 0
  %.933.i = shufflevector <8 x double> %.932.i, <8 x double> poison, <8 x i32> zeroinitializer
  %32 = add nsw i64 %.857.i, -1
  %xtraiter28.i = and i64 %.857.i, 3
  %lcmp.mod29.not.i = icmp eq i64 %xtraiter28.i, 0
  br i1 %lcmp.mod29.not.i, label %B590.if.prol.loopexit.i, label %B590.if.prol.i.preheader

B590.if.prol.i.preheader:                         ; preds = %B590.if.lr.ph.i
  %33 = sub nsw i64 0, %xtraiter28.i
  br label %B590.if.prol.i

B590.if.prol.i:                                   ; preds = %B590.if.prol.i, %B590.if.prol.i.preheader
  %lsr.iv23 = phi i64 [ %33, %B590.if.prol.i.preheader ], [ %math, %B590.if.prol.i ]
  %.884447449.prol.i = phi i64 [ %.487.i, %B590.if.prol.i.preheader ], [ %.891.prol.i, %B590.if.prol.i ]
  %.891.prol.i = add i64 %.884447449.prol.i, 8
  %34 = shl i64 %.884447449.prol.i, 3
  %scevgep46.i = getelementptr i8, ptr %arg.state.10.2.4, i64 %34
  store <8 x double> %.919.i, ptr %scevgep46.i, align 8, !noalias !185
  %scevgep45.i = getelementptr i8, ptr %arg.state.10.3.4, i64 %34
  store <8 x double> %.933.i, ptr %scevgep45.i, align 8, !noalias !185
  %35 = tail call { i64, i1 } @llvm.uadd.with.overflow.i64(i64 %lsr.iv23, i64 1)
  %math = extractvalue { i64, i1 } %35, 0
  %ov92 = extractvalue { i64, i1 } %35, 1
  br i1 %ov92, label %B590.if.prol.loopexit.loopexit.i, label %B590.if.prol.i, !llvm.loop !195

B590.if.prol.loopexit.loopexit.i:                 ; preds = %B590.if.prol.i
  %36 = and i64 %.857.i, 2305843009213693948
  br label %B590.if.prol.loopexit.i

B590.if.prol.loopexit.i:                          ; preds = %B590.if.prol.loopexit.loopexit.i, %B590.if.lr.ph.i
  %.877446450.unr.i = phi i64 [ %.857.i, %B590.if.lr.ph.i ], [ %36, %B590.if.prol.loopexit.loopexit.i ]
  %.884447449.unr.i = phi i64 [ %.487.i, %B590.if.lr.ph.i ], [ %.891.prol.i, %B590.if.prol.loopexit.loopexit.i ]
  %37 = icmp ult i64 %32, 3
  br i1 %37, label %B316533.endif.endif.endif, label %B590.if.preheader.i

B590.if.preheader.i:                              ; preds = %B590.if.prol.loopexit.i
  %38 = shl i64 %.884447449.unr.i, 3
  %39 = add i64 %38, 192
  %40 = add nuw nsw i64 %.877446450.unr.i, 24
  br label %B590.if.i

B590.if.i:                                        ; preds = %B590.if.i, %B590.if.preheader.i
  %lsr.iv = phi i64 [ %lsr.iv.next, %B590.if.i ], [ %40, %B590.if.preheader.i ]
  %lsr.iv30.i = phi i64 [ %lsr.iv.next31.i, %B590.if.i ], [ %39, %B590.if.preheader.i ]
  %scevgep41.i = getelementptr i8, ptr %arg.state.10.2.4, i64 %lsr.iv30.i
  %scevgep42.i = getelementptr i8, ptr %scevgep41.i, i64 -192
  store <8 x double> %.919.i, ptr %scevgep42.i, align 8, !noalias !185
  %scevgep34.i = getelementptr i8, ptr %arg.state.10.3.4, i64 %lsr.iv30.i
  %scevgep35.i = getelementptr i8, ptr %scevgep34.i, i64 -192
  store <8 x double> %.933.i, ptr %scevgep35.i, align 8, !noalias !185
  %scevgep33 = getelementptr i8, ptr %scevgep41.i, i64 -128
  store <8 x double> %.919.i, ptr %scevgep33, align 8, !noalias !185
  %scevgep37.i = getelementptr i8, ptr %scevgep34.i, i64 -128
  store <8 x double> %.933.i, ptr %scevgep37.i, align 8, !noalias !185
  %scevgep31 = getelementptr i8, ptr %scevgep41.i, i64 -64
  store <8 x double> %.919.i, ptr %scevgep31, align 8, !noalias !185
  %scevgep28 = getelementptr i8, ptr %scevgep34.i, i64 -64
  store <8 x double> %.933.i, ptr %scevgep28, align 8, !noalias !185
  store <8 x double> %.919.i, ptr %scevgep41.i, align 8, !noalias !185
  store <8 x double> %.933.i, ptr %scevgep34.i, align 8, !noalias !185
  %lsr.iv.next31.i = add i64 %lsr.iv30.i, 256
  %lsr.iv.next = add nsw i64 %lsr.iv, -4
  %.878.3.i = icmp sgt i64 %lsr.iv, 28
  br i1 %.878.3.i, label %B590.if.i, label %B316533.endif.endif.endif

B316533.endif.endif.endif:                        ; preds = %B590.if.i, %B590.if.prol.loopexit.i, %B348.endif.endif.endif.i
  br i1 %.163279.not.i, label %_ZN17bnserve_surrogate6kernel5modes5_sums13multiply_modeB4v453B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi2EE5ArrayIdLi1E1C7mutable7alignedE5TupleIddxE.exit, label %B48.if.lr.ph.i

B48.if.lr.ph.i:                                   ; preds = %B316533.endif.endif.endif
  %.6889 = load i64, ptr %.500, align 8
  %.6858 = load i64, ptr %sunkaddr94, align 8
  %.7041 = load i64, ptr %sunkaddr45, align 8
  %.7005 = getelementptr i8, ptr %carrier.1.sroa.121.1, i64 24
  %.7006 = load double, ptr %.7005, align 8
  %.6895 = mul nsw i64 %.6889, 40
  %.6896 = add nsw i64 %.6895, %.6858
  %.6897 = inttoptr i64 %.6896 to ptr
  %.6972 = getelementptr i8, ptr %.6897, i64 16
  %.6973 = load double, ptr %.6972, align 8
  %.252.i = insertelement <8 x double> poison, double %.6973, i64 0
  %.253.i695 = shufflevector <8 x double> %.252.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.298.i = add i64 %.7041, -1
  %..298.i = tail call i64 @llvm.smax.i64(i64 %.298.i, i64 0)
  %.6.i24.i = insertelement <8 x double> poison, double %.7006, i64 0
  %.7.i.i696 = shufflevector <8 x double> %.6.i24.i, <8 x double> poison, <8 x i32> zeroinitializer
  %xtraiter.i697 = and i64 %..298.i, 3
  %41 = lshr i64 %..298.i, 2
  %42 = mul nsw i64 %41, -4
  %43 = icmp slt i64 %.298.i, 1
  %44 = icmp slt i64 %.298.i, 4
  %45 = icmp eq i64 %xtraiter.i697, 0
  br label %B48.if.i699

B316739.loopexit.unr-lcssa.i:                     ; preds = %B488.if.i
  br i1 %45, label %B316739.i, label %B488.if.epil.i.preheader

B488.if.epil.i.preheader:                         ; preds = %B488.if.preheader.i, %B316739.loopexit.unr-lcssa.i
  %_velocity_v454_w.2.1248.epil.i.ph = phi <8 x double> [ %.6.i25.3.i, %B316739.loopexit.unr-lcssa.i ], [ %.254.i, %B488.if.preheader.i ]
  br label %B488.if.epil.i

B488.if.epil.i:                                   ; preds = %B488.if.epil.i.preheader, %B488.if.epil.i
  %lsr.iv33.i = phi i64 [ %lsr.iv.next34.i, %B488.if.epil.i ], [ %xtraiter.i697, %B488.if.epil.i.preheader ]
  %_velocity_v454_w.2.1248.epil.i = phi <8 x double> [ %.6.i25.epil.i, %B488.if.epil.i ], [ %_velocity_v454_w.2.1248.epil.i.ph, %B488.if.epil.i.preheader ]
  %.6.i25.epil.i = fmul contract <8 x double> %.254.i, %_velocity_v454_w.2.1248.epil.i
  %lsr.iv.next34.i = add nsw i64 %lsr.iv33.i, -1
  %epil.iter.cmp.not.i703 = icmp eq i64 %lsr.iv.next34.i, 0
  br i1 %epil.iter.cmp.not.i703, label %B316739.i, label %B488.if.epil.i, !llvm.loop !196

B316739.i:                                        ; preds = %B488.if.epil.i, %B48.if.i699, %B316739.loopexit.unr-lcssa.i
  %_velocity_v454_w.2.1.lcssa.i = phi <8 x double> [ %.254.i, %B48.if.i699 ], [ %.6.i25.3.i, %B316739.loopexit.unr-lcssa.i ], [ %.6.i25.epil.i, %B488.if.epil.i ]
  %.425.i = getelementptr inbounds double, ptr %arg.state.10.0.4, i64 %.169258282.i
  %.427.i = load <8 x double>, ptr %.425.i, align 8, !noalias !197
  %.6.i.i704 = fmul contract <8 x double> %_velocity_v454_w.2.1.lcssa.i, %.427.i
  %.460.i = getelementptr inbounds double, ptr %arg.state.10.1.4, i64 %.169258282.i
  %.462.i = load <8 x double>, ptr %.460.i, align 8, !noalias !197
  %.6.i26.i = fmul contract <8 x double> %_velocity_v454_w.2.1.lcssa.i, %.462.i
  %.499.i = getelementptr inbounds double, ptr %arg.state.10.2.4, i64 %.169258282.i
  %.501.i = load <8 x double>, ptr %.499.i, align 8, !noalias !197
  %.517.i = getelementptr inbounds double, ptr %arg.state.10.3.4, i64 %.169258282.i
  %.519.i = load <8 x double>, ptr %.517.i, align 8, !noalias !197
  %.6.i27.i = fmul contract <8 x double> %.6.i26.i, %.519.i
  %.6.i28.i = fsub contract <8 x double> zeroinitializer, %.6.i27.i
  %.578.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i704, <8 x double> %.501.i, <8 x double> %.6.i28.i)
  store <8 x double> %.578.i, ptr %.499.i, align 8, !noalias !197
  %.6.i29.i = fmul contract <8 x double> %.6.i26.i, %.501.i
  %.621.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i704, <8 x double> %.519.i, <8 x double> %.6.i29.i)
  store <8 x double> %.621.i, ptr %.517.i, align 8, !noalias !197
  %.163.i = icmp sgt i64 %.162251283.i, 1
  br i1 %.163.i, label %B48.if.i699, label %_ZN17bnserve_surrogate6kernel5modes5_sums13multiply_modeB4v453B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi2EE5ArrayIdLi1E1C7mutable7alignedE5TupleIddxE.exit

B48.if.i699:                                      ; preds = %B316739.i, %B48.if.lr.ph.i
  %.162251283.i = phi i64 [ %.96.i, %B48.if.lr.ph.i ], [ %.172.i, %B316739.i ]
  %.169258282.i = phi i64 [ 0, %B48.if.lr.ph.i ], [ %.176.i, %B316739.i ]
  %.172.i = add nsw i64 %.162251283.i, -1
  %.176.i = add nuw i64 %.169258282.i, 8
  %.222.i = getelementptr inbounds double, ptr %.1166, i64 %.169258282.i
  %.224.i = load <8 x double>, ptr %.222.i, align 8, !noalias !197
  %.8.i.i700 = fmul contract <8 x double> %.7.i.i696, %.224.i
  %.254.i = tail call <8 x double> @llvm.minnum.v8f64(<8 x double> %.8.i.i700, <8 x double> %.253.i695)
  br i1 %43, label %B316739.i, label %B488.if.preheader.i

B488.if.preheader.i:                              ; preds = %B48.if.i699
  br i1 %44, label %B488.if.epil.i.preheader, label %B488.if.i

B488.if.i:                                        ; preds = %B488.if.preheader.i, %B488.if.i
  %lsr.iv34 = phi i64 [ %lsr.iv.next35, %B488.if.i ], [ %42, %B488.if.preheader.i ]
  %_velocity_v454_w.2.1248.i = phi <8 x double> [ %.6.i25.3.i, %B488.if.i ], [ %.254.i, %B488.if.preheader.i ]
  %.6.i25.i = fmul contract <8 x double> %.254.i, %_velocity_v454_w.2.1248.i
  %.6.i25.1.i = fmul contract <8 x double> %.254.i, %.6.i25.i
  %.6.i25.2.i = fmul contract <8 x double> %.254.i, %.6.i25.1.i
  %.6.i25.3.i = fmul contract <8 x double> %.254.i, %.6.i25.2.i
  %lsr.iv.next35 = add nsw i64 %lsr.iv34, 4
  %niter.ncmp.3.i = icmp eq i64 %lsr.iv.next35, 0
  br i1 %niter.ncmp.3.i, label %B316739.loopexit.unr-lcssa.i, label %B488.if.i

_ZN17bnserve_surrogate6kernel5modes5_sums13multiply_modeB4v453B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi2EE5ArrayIdLi1E1C7mutable7alignedE5TupleIddxE.exit: ; preds = %B316739.i, %B316533.endif.endif.endif
  store ptr null, ptr %.7111, align 8
  call fastcc void @inner_27(ptr nonnull %.7111, i64 %.3381, i64 %arg.ends.0, i64 %arg.ends.2, ptr %arg.state.0.4, i64 %.554, ptr %arg.state.10.2.4, ptr %arg.state.10.3.4, ptr %arg.state.14.4)
  br label %B316611
}

; Function Attrs: nofree noinline norecurse nosync nounwind memory(readwrite, inaccessiblemem: none, target_mem0: none, target_mem1: none)
define internal fastcc noundef range(i32 0, 2) i32 @inner_23(ptr noalias nonnull writeonly captures(none) %retptr, ptr noalias nonnull writeonly captures(none) %excinfo, i64 %arg.lane, ptr readonly captures(none) %arg.row.4, double %arg.mass, i8 range(i8 0, 2) %arg.dense, i64 %arg.stop, ptr readonly captures(none) %arg.plan.4, ptr readonly captures(none) %arg.arguments.4, ptr readonly captures(none) %arg.contents.4, ptr readonly captures(none) %arg.weights.4, ptr readonly captures(none) %arg.gauge.4, ptr readonly captures(none) %arg.ratios.4, ptr %arg.room.4, ptr captures(none) %arg.carriers.4, ptr writeonly captures(none) %arg.modes.4) unnamed_addr #4 {
entry:
  %.1692 = alloca ptr, align 8
  store ptr null, ptr %.1692, align 8
  %excinfo.10 = alloca ptr, align 8
  store ptr null, ptr %excinfo.10, align 8
  %.1910 = alloca ptr, align 8
  store ptr null, ptr %.1910, align 8
  %.204 = getelementptr i8, ptr %arg.arguments.4, i64 16
  %.205 = load i64, ptr %.204, align 8
  %.234 = getelementptr i8, ptr %arg.arguments.4, i64 32
  %.235 = load i64, ptr %.234, align 8
  %.264 = getelementptr i8, ptr %arg.arguments.4, i64 40
  %.265 = load i64, ptr %.264, align 8
  %.301 = getelementptr i8, ptr %arg.arguments.4, i64 24
  %.302 = load i64, ptr %.301, align 8
  %.304 = inttoptr i64 %.302 to ptr
  %.371 = getelementptr inbounds double, ptr %.304, i64 %.235
  %.429 = icmp sgt i64 %.265, 0
  br i1 %.429, label %B262, label %B342

B262:                                             ; preds = %entry
  %0 = getelementptr double, ptr %.371, i64 %.205
  %.440 = getelementptr i8, ptr %0, i64 -8
  %.441 = load double, ptr %.440, align 8
  %.450 = load double, ptr %.371, align 8
  %.451 = fsub contract double %.441, %.450
  %.453 = uitofp nneg i64 %.265 to double
  %.457 = fdiv contract double %.453, %.451
  br label %B342

B342:                                             ; preds = %B262, %entry
  %prepared_grid_v169__vphi308_0.2.0 = phi double [ %.457, %B262 ], [ 0.000000e+00, %entry ]
  %.751 = getelementptr i8, ptr %arg.contents.4, i64 64
  %.752 = load i64, ptr %.751, align 8
  %.753 = sub i64 0, %.752
  %.761.1 = and i64 %.753, -8
  %.795 = sub i64 0, %.761.1
  %.825 = getelementptr i8, ptr %arg.contents.4, i64 144
  %.826 = load i64, ptr %.825, align 8
  %.827 = sub i64 0, %.826
  %.835.1 = and i64 %.827, -8
  %.869 = sub i64 0, %.835.1
  %.13.i = tail call i64 @llvm.smax.i64(i64 %.869, i64 %.795)
  %.945 = load i64, ptr %arg.plan.4, align 8
  %.10251227.not = icmp slt i64 %.945, 1
  br i1 %.10251227.not, label %B8662, label %B568.if.lr.ph

B724:                                             ; preds = %B568.if
  %.1276 = add nsw i64 %number.2.01233, 1
  %.1290 = mul nsw i64 %.1276, %.1289
  %.1301 = getelementptr double, ptr %arg.carriers.4, i64 %.1290
  %.1364 = getelementptr i8, ptr %.1301, i64 320
  %.1427 = getelementptr i8, ptr %.1301, i64 384
  %.1493 = getelementptr i8, ptr %.1301, i64 512
  %.1649 = sitofp i64 %.1239 to double
  %.1653 = fdiv contract double %.1648, %.1649
  %.1683 = load i64, ptr %sunkaddr, align 8
  store ptr null, ptr %.1692, align 8
  %.1719 = call fastcc i32 @inner_28(ptr nonnull %.1692, ptr nonnull %excinfo.10, ptr %arg.row.4, double %.1653, i8 %arg.dense, ptr %.371, i64 %.205, ptr %2, i64 %.265, double %prepared_grid_v169__vphi308_0.2.0, ptr %arg.contents.4, ptr %arg.weights.4, ptr %arg.gauge.4, i64 %.1683, ptr %arg.room.4, ptr %.1301, ptr %.1364, ptr %.1427, ptr %.1493, i64 %.13.i)
  %cond = icmp eq i32 %.1719, 0
  br i1 %cond, label %B724.endif.endif.endif.endif.endif.endif, label %B724.endif.endif.endif.endif.endif.if, !prof !0

B726:                                             ; preds = %B724.endif.endif.endif.endif.endif.endif, %B568.if
  %number.3.1 = phi i64 [ %.1276, %B724.endif.endif.endif.endif.endif.endif ], [ %number.2.01233, %B568.if ]
  %order.3.1 = phi i64 [ %.1239, %B724.endif.endif.endif.endif.endif.endif ], [ %order.2.01234, %B568.if ]
  %line.3.1 = phi i1 [ %.1790, %B724.endif.endif.endif.endif.endif.endif ], [ %line.2.01235, %B568.if ]
  %carrier.1.sroa.99.1 = phi ptr [ %.1364, %B724.endif.endif.endif.endif.endif.endif ], [ %carrier.2.sroa.110.01230, %B568.if ]
  %scevgep136 = getelementptr i8, ptr %lsr.iv, i64 16
  %.1829 = load i64, ptr %scevgep136, align 8
  %.1830 = icmp sgt i64 %.1829, 0
  br i1 %.1830, label %B8582, label %B8660

B8582:                                            ; preds = %B726
  %scevgep135 = getelementptr i8, ptr %lsr.iv, i64 56
  %.1861 = load i64, ptr %scevgep135, align 8
  %.1863 = icmp eq i64 %.969.0, %.1861
  %.1899 = getelementptr i8, ptr %carrier.1.sroa.99.1, i64 8
  %.1900 = load double, ptr %.1899, align 8
  store ptr null, ptr %.1910, align 8
  %.1916 = zext i1 %.1863 to i8
  call fastcc void @inner_29(ptr nonnull %.1910, ptr nonnull %lsr.iv, i8 %.1916, i64 %arg.lane, ptr %arg.ratios.4, ptr %arg.modes.4, ptr %.371, i64 %.205, ptr %3, i64 %.265, double %prepared_grid_v169__vphi308_0.2.0, double %.1900, i64 %arg.stop)
  br label %B8660

B8660:                                            ; preds = %B8582, %B726
  %scevgep134 = getelementptr i8, ptr %lsr.iv, i64 72
  %exitcond.not = icmp eq i64 %.945, %.1038
  br i1 %exitcond.not, label %B8662.loopexit, label %B568.if

common.ret:                                       ; preds = %B724.endif.endif.endif.endif.endif.if, %B8662
  %common.ret.op = phi i32 [ 0, %B8662 ], [ %.1719, %B724.endif.endif.endif.endif.endif.if ]
  ret i32 %common.ret.op

B8662.loopexit:                                   ; preds = %B8660
  %1 = zext i1 %line.3.1 to i8
  br label %B8662

B8662:                                            ; preds = %B8662.loopexit, %B342
  %line.2.0.lcssa = phi i8 [ 0, %B342 ], [ %1, %B8662.loopexit ]
  store i8 %line.2.0.lcssa, ptr %retptr, align 1
  br label %common.ret

B568.if.lr.ph:                                    ; preds = %B342
  %.512 = getelementptr i8, ptr %arg.arguments.4, i64 48
  %.513 = load i64, ptr %.512, align 8
  %.1289 = add nsw i64 %.13.i, 64
  %.1648 = fmul contract double %arg.mass, 2.000000e+00
  %scevgep = getelementptr i8, ptr %arg.plan.4, i64 48
  %2 = inttoptr i64 %.513 to ptr
  %sunkaddr = getelementptr i8, ptr %arg.arguments.4, i64 88
  %3 = inttoptr i64 %.513 to ptr
  br label %B568.if

B568.if:                                          ; preds = %B568.if.lr.ph, %B8660
  %lsr.iv = phi ptr [ %scevgep, %B568.if.lr.ph ], [ %scevgep134, %B8660 ]
  %.969.0 = phi i64 [ 0, %B568.if.lr.ph ], [ %.1038, %B8660 ]
  %line.2.01235 = phi i1 [ false, %B568.if.lr.ph ], [ %line.3.1, %B8660 ]
  %order.2.01234 = phi i64 [ 0, %B568.if.lr.ph ], [ %order.3.1, %B8660 ]
  %number.2.01233 = phi i64 [ -1, %B568.if.lr.ph ], [ %number.3.1, %B8660 ]
  %carrier.2.sroa.110.01230 = phi ptr [ null, %B568.if.lr.ph ], [ %carrier.1.sroa.99.1, %B8660 ]
  %.1038 = add nuw nsw i64 %.969.0, 1
  %.1239 = load i64, ptr %lsr.iv, align 8
  %.1241.not = icmp eq i64 %.1239, %order.2.01234
  br i1 %.1241.not, label %B726, label %B724

B724.endif.endif.endif.endif.endif.if:            ; preds = %B724
  %.1720 = load ptr, ptr %excinfo.10, align 8
  store ptr %.1720, ptr %excinfo, align 8
  br label %common.ret

B724.endif.endif.endif.endif.endif.endif:         ; preds = %B724
  %.1782 = getelementptr i8, ptr %.1301, i64 392
  %.1783 = load i64, ptr %.1782, align 8
  %.1788 = icmp slt i64 %.1783, %arg.stop
  %.1790 = or i1 %line.2.01235, %.1788
  br label %B726
}

; Function Attrs: nofree noinline norecurse nosync nounwind memory(readwrite, inaccessiblemem: none, target_mem0: none, target_mem1: none)
define internal fastcc noundef range(i32 0, 2) i32 @inner_28(ptr noalias nonnull writeonly captures(none) %retptr, ptr noalias nonnull writeonly captures(none) %excinfo, ptr readonly captures(none) %arg.row.4, double %arg.mass, i8 range(i8 0, 2) %arg.dense, ptr readonly captures(none) %arg.grid_places.0.4, i64 %arg.grid_places.1, ptr readonly captures(none) %arg.grid_places.2.4, i64 %arg.grid_places.3, double %arg.grid_places.4, ptr readonly captures(none) %arg.contents.4, ptr readonly captures(none) %arg.weights.4, ptr readonly captures(none) %arg.gauge.4, i64 %arg.alignment, ptr %arg.room.4, ptr writeonly captures(none) %arg.carrier.0.4, ptr writeonly captures(none) initializes((0, 32)) %arg.carrier.1.4, ptr writeonly captures(none) initializes((0, 48)) %arg.carrier.2.4, ptr writeonly captures(none) %arg.carrier.3.4, i64 range(i64 8, 1) %arg.carrier.3.5.0) unnamed_addr #4 {
entry:
  %.510 = alloca i64, align 8
  store i64 0, ptr %.510, align 8
  %.665 = alloca i64, align 8
  store i64 0, ptr %.665, align 8
  %.786 = alloca i64, align 8
  store i64 0, ptr %.786, align 8
  %.945 = alloca i64, align 8
  store i64 0, ptr %.945, align 8
  %.1474 = alloca double, align 8
  store double 0.000000e+00, ptr %.1474, align 8
  %excinfo.8 = alloca ptr, align 8
  store ptr null, ptr %excinfo.8, align 8
  %.271.le = tail call contract double @llvm.log.f64(double %arg.mass)
  %.305 = getelementptr i8, ptr %arg.contents.4, i64 128
  %.306 = load i64, ptr %.305, align 8
  %.317 = getelementptr inbounds double, ptr %arg.weights.4, i64 %.306
  %.449 = load double, ptr %.317, align 8
  %.451 = fmul contract double %.449, 0x3FEFFFFFFF768FA1
  %.459.le = tail call contract double @llvm.log.f64(double %.451)
  %.464 = fsub contract double %.459.le, %.271.le
  store i64 0, ptr %.510, align 8
  call fastcc void @inner_14(ptr nonnull %.510, ptr %arg.grid_places.0.4, i64 %arg.grid_places.1, ptr %arg.grid_places.2.4, i64 %arg.grid_places.3, double %arg.grid_places.4, double %.464)
  %.528 = load i64, ptr %.510, align 8
  %.600 = getelementptr i8, ptr %.317, i64 8
  %.601 = load double, ptr %.600, align 8
  %.606 = fmul contract double %.601, 0x3FF000000044B830
  %.614.le = tail call contract double @llvm.log.f64(double %.606)
  %.619 = fsub contract double %.614.le, %.271.le
  store i64 0, ptr %.665, align 8
  call fastcc void @inner_14(ptr nonnull %.665, ptr %arg.grid_places.0.4, i64 %arg.grid_places.1, ptr %arg.grid_places.2.4, i64 %arg.grid_places.3, double %arg.grid_places.4, double %.619)
  %.683 = load i64, ptr %.665, align 8
  %.740 = fsub contract double 0xC0126BB1BBB55515, %.271.le
  store i64 0, ptr %.786, align 8
  call fastcc void @inner_14(ptr nonnull %.786, ptr %arg.grid_places.0.4, i64 %arg.grid_places.1, ptr %arg.grid_places.2.4, i64 %arg.grid_places.3, double %arg.grid_places.4, double %.740)
  %.804 = load i64, ptr %.786, align 8
  %.899 = fsub contract double 0xC00F4BD2B7AC1BAF, %.271.le
  store i64 0, ptr %.945, align 8
  call fastcc void @inner_14(ptr nonnull %.945, ptr %arg.grid_places.0.4, i64 %arg.grid_places.1, ptr %arg.grid_places.2.4, i64 %arg.grid_places.3, double %arg.grid_places.4, double %.899)
  %0 = icmp eq i8 %arg.dense, 0
  %.13.i = tail call i64 @llvm.smin.i64(i64 %.683, i64 %.804)
  %.963 = load i64, ptr %.945, align 8
  %.13.i11 = tail call i64 @llvm.smin.i64(i64 %.683, i64 %.963)
  %.1090 = fmul contract double %arg.mass, 0x400921FB54442D18
  %.1091 = tail call contract double @llvm.pow.f64(double %.1090, double 0x3FD5555555555555)
  store double %arg.mass, ptr %arg.carrier.1.4, align 8
  %.1176 = getelementptr i8, ptr %arg.carrier.1.4, i64 8
  store double %.271.le, ptr %.1176, align 8
  %.1206 = getelementptr i8, ptr %arg.carrier.1.4, i64 16
  store double 0.000000e+00, ptr %.1206, align 8
  %.1236 = getelementptr i8, ptr %arg.carrier.1.4, i64 24
  store double %.1091, ptr %.1236, align 8
  store i64 %.528, ptr %arg.carrier.2.4, align 8
  %.1324 = getelementptr i8, ptr %arg.carrier.2.4, i64 8
  store i64 %.683, ptr %.1324, align 8
  %.1353 = getelementptr i8, ptr %arg.carrier.2.4, i64 16
  store i64 %.13.i, ptr %.1353, align 8
  %.1382 = getelementptr i8, ptr %arg.carrier.2.4, i64 24
  store i64 %.13.i11, ptr %.1382, align 8
  %.1423 = getelementptr i8, ptr %arg.carrier.2.4, i64 32
  tail call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(16) %.1423, i8 0, i64 16, i1 false)
  %.1460 = icmp sgt i64 %.528, 0
  %or.cond = select i1 %0, i1 true, i1 %.1460
  br i1 %or.cond, label %B356, label %B404

B356:                                             ; preds = %entry
  store double 0.000000e+00, ptr %.1474, align 8
  %.1488 = call fastcc i32 @inner_11(ptr nonnull %.1474, ptr nonnull %excinfo.8, ptr %arg.row.4, double %arg.mass, ptr nonnull %.317, ptr %arg.gauge.4, i64 %arg.alignment, ptr %arg.room.4, ptr %arg.carrier.0.4)
  %cond = icmp eq i32 %.1488, 0
  br i1 %cond, label %B356.endif, label %B356.if, !prof !0

B404:                                             ; preds = %B356.endif, %entry
  br i1 %0, label %B556, label %B408

B408:                                             ; preds = %B404
  %.1641 = getelementptr i8, ptr %arg.contents.4, i64 152
  %.1642 = load i64, ptr %.1641, align 8
  %.1658 = getelementptr inbounds double, ptr %arg.weights.4, i64 %.1642
  %.1737 = getelementptr i8, ptr %arg.contents.4, i64 144
  %.1738 = load i64, ptr %.1737, align 8
  %.135.i = load double, ptr %arg.grid_places.0.4, align 8, !noalias !200
  %.140.i = add nsw i64 %.1738, -1
  %.178.i = icmp slt i64 %.1738, 2
  %..140.i = select i1 %.178.i, i64 0, i64 %.140.i
  %.222229.i = icmp sgt i64 %..140.i, 0
  br i1 %.222229.i, label %B88.if.i, label %_ZN17bnserve_surrogate6kernel7_places15find_ends_apartB4v197B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5TupleI5ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedExdE5ArrayIdLi1E1C7mutable7alignedExdx5ArrayIxLi1E1C7mutable7alignedE.exit

B556:                                             ; preds = %B404
  %.1831 = getelementptr i8, ptr %arg.contents.4, i64 120
  %.1832 = load i64, ptr %.1831, align 8
  %1 = getelementptr double, ptr %arg.weights.4, i64 %.1832
  %.1849 = getelementptr i8, ptr %1, i64 8
  %.1929 = getelementptr i8, ptr %arg.contents.4, i64 64
  %.1930 = load i64, ptr %.1929, align 8
  %.135.i12 = load double, ptr %arg.grid_places.0.4, align 8, !noalias !203
  %.140.i13 = add nsw i64 %.1930, -2
  %.178.i14 = icmp slt i64 %.1930, 3
  %..140.i15 = select i1 %.178.i14, i64 0, i64 %.140.i13
  %.222229.i16 = icmp sgt i64 %..140.i15, 0
  br i1 %.222229.i16, label %B88.if.i20, label %_ZN17bnserve_surrogate6kernel7_places15find_ends_apartB4v197B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5TupleI5ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedExdE5ArrayIdLi1E1C7mutable7alignedExdx5ArrayIxLi1E1C7mutable7alignedE.exit67

common.ret:                                       ; preds = %_ZN17bnserve_surrogate6kernel7_places15find_ends_apartB4v197B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5TupleI5ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedExdE5ArrayIdLi1E1C7mutable7alignedExdx5ArrayIxLi1E1C7mutable7alignedE.exit67, %_ZN17bnserve_surrogate6kernel7_places15find_ends_apartB4v197B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5TupleI5ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedExdE5ArrayIdLi1E1C7mutable7alignedExdx5ArrayIxLi1E1C7mutable7alignedE.exit, %B356.if
  %common.ret.op = phi i32 [ 1, %B356.if ], [ 0, %_ZN17bnserve_surrogate6kernel7_places15find_ends_apartB4v197B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5TupleI5ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedExdE5ArrayIdLi1E1C7mutable7alignedExdx5ArrayIxLi1E1C7mutable7alignedE.exit ], [ 0, %_ZN17bnserve_surrogate6kernel7_places15find_ends_apartB4v197B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5TupleI5ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedExdE5ArrayIdLi1E1C7mutable7alignedExdx5ArrayIxLi1E1C7mutable7alignedE.exit67 ]
  ret i32 %common.ret.op

B356.if:                                          ; preds = %B356
  %.1489 = load ptr, ptr %excinfo.8, align 8
  store ptr %.1489, ptr %excinfo, align 8
  br label %common.ret

B356.endif:                                       ; preds = %B356
  %.1498 = load double, ptr %.1474, align 8
  store double %.1498, ptr %.1206, align 8
  br label %B404

B146.i:                                           ; preds = %B88.if.i
  %.287.i = fsub contract double %.274.i, %.135.i
  %.289.i = fmul contract double %arg.grid_places.4, %.287.i
  %.5.i.i = fptosi double %.289.i to i64
  %.13.i3.i = tail call i64 @llvm.smin.i64(i64 %arg.grid_places.3, i64 %.5.i.i)
  %.350.i = getelementptr inbounds i64, ptr %arg.grid_places.2.4, i64 %.13.i3.i
  %.351.i = load i64, ptr %.350.i, align 8, !noalias !200
  %.359.i = getelementptr inbounds double, ptr %arg.grid_places.0.4, i64 %.351.i
  %.360.i = load double, ptr %.359.i, align 8, !noalias !200
  %.362.i = fcmp contract ole double %.360.i, %.274.i
  %.364.i = zext i1 %.362.i to i64
  %.365.i = add nsw i64 %.351.i, %.364.i
  %.373.i = getelementptr inbounds double, ptr %arg.grid_places.0.4, i64 %.365.i
  %.374.i = load double, ptr %.373.i, align 8, !noalias !200
  %.376.i = fcmp contract ole double %.374.i, %.274.i
  %.378.i = zext i1 %.376.i to i64
  %.379.i = add nsw i64 %.365.i, %.378.i
  %.387.i = getelementptr inbounds double, ptr %arg.grid_places.0.4, i64 %.379.i
  %.388.i = load double, ptr %.387.i, align 8, !noalias !200
  %.390.i = fcmp contract ole double %.388.i, %.274.i
  %.392.i = zext i1 %.390.i to i64
  %.393.i = add nsw i64 %.379.i, %.392.i
  %.402.i = icmp slt i64 %.393.i, %.683
  br i1 %.402.i, label %B394.i, label %B496.i

B394.i:                                           ; preds = %B146.i
  %.419.i = getelementptr inbounds double, ptr %arg.grid_places.0.4, i64 %.393.i
  %.420.i = load double, ptr %.419.i, align 8, !noalias !200
  %.424.i = fcmp contract ugt double %.420.i, %.274.i
  br i1 %.424.i, label %B496.i, label %B434.i

B434.i:                                           ; preds = %B394.i, %B456.i
  %lsr.iv5 = phi i64 [ %2, %B456.i ], [ %.393.i, %B394.i ]
  %2 = add nsw i64 %lsr.iv5, 1
  %.441.i = icmp slt i64 %2, %.683
  br i1 %.441.i, label %B456.i, label %B496.i

B456.i:                                           ; preds = %B434.i
  %sunkaddr7 = shl i64 %lsr.iv5, 3
  %sunkaddr8 = getelementptr i8, ptr %arg.grid_places.0.4, i64 %sunkaddr7
  %sunkaddr9 = getelementptr i8, ptr %sunkaddr8, i64 8
  %.458.i = load double, ptr %sunkaddr9, align 8, !noalias !200
  %.462.i = fcmp contract ugt double %.458.i, %.274.i
  br i1 %.462.i, label %B496.i, label %B434.i

B496.i:                                           ; preds = %B456.i, %B434.i, %B88.if.i, %B394.i, %B146.i
  %end.7.1.i = phi i64 [ %.393.i, %B146.i ], [ 0, %B88.if.i ], [ %.393.i, %B394.i ], [ %.683, %B434.i ], [ %2, %B456.i ]
  %.13.i.i = tail call i64 @llvm.smin.i64(i64 %.683, i64 %end.7.1.i)
  %3 = getelementptr i64, ptr %arg.carrier.3.4, i64 %.228226230.i
  store i64 %.13.i.i, ptr %3, align 8, !noalias !200
  %exitcond.not.i = icmp eq i64 %.235.i, %..140.i
  br i1 %exitcond.not.i, label %_ZN17bnserve_surrogate6kernel7_places15find_ends_apartB4v197B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5TupleI5ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedExdE5ArrayIdLi1E1C7mutable7alignedExdx5ArrayIxLi1E1C7mutable7alignedE.exit, label %B88.if.i

B88.if.i:                                         ; preds = %B408, %B496.i
  %.228226230.i = phi i64 [ %.235.i, %B496.i ], [ 0, %B408 ]
  %.235.i = add nuw nsw i64 %.228226230.i, 1
  %.271.i = getelementptr inbounds nuw double, ptr %.1658, i64 %.228226230.i
  %.272.i = load double, ptr %.271.i, align 8, !noalias !200
  %.274.i = fsub contract double %.272.i, %.271.le
  %.283.i = fcmp contract ult double %.274.i, %.135.i
  br i1 %.283.i, label %B496.i, label %B146.i

_ZN17bnserve_surrogate6kernel7_places15find_ends_apartB4v197B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5TupleI5ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedExdE5ArrayIdLi1E1C7mutable7alignedExdx5ArrayIxLi1E1C7mutable7alignedE.exit: ; preds = %B496.i, %B408
  %.588.inv.i = icmp sgt i64 %.1738, 0
  %.589.i = select i1 %.588.inv.i, i64 0, i64 %arg.carrier.3.5.0
  %4 = getelementptr i64, ptr %arg.carrier.3.4, i64 %.140.i
  %.603.i = getelementptr i64, ptr %4, i64 %.589.i
  store i64 %.683, ptr %.603.i, align 8, !noalias !200
  store ptr null, ptr %retptr, align 8
  br label %common.ret

B146.i27:                                         ; preds = %B88.if.i20
  %.287.i28 = fsub contract double %.274.i25, %.135.i12
  %.289.i29 = fmul contract double %arg.grid_places.4, %.287.i28
  %.5.i.i30 = fptosi double %.289.i29 to i64
  %.13.i3.i31 = tail call i64 @llvm.smin.i64(i64 %arg.grid_places.3, i64 %.5.i.i30)
  %.350.i32 = getelementptr inbounds i64, ptr %arg.grid_places.2.4, i64 %.13.i3.i31
  %.351.i33 = load i64, ptr %.350.i32, align 8, !noalias !203
  %.359.i34 = getelementptr inbounds double, ptr %arg.grid_places.0.4, i64 %.351.i33
  %.360.i35 = load double, ptr %.359.i34, align 8, !noalias !203
  %.362.i36 = fcmp contract ole double %.360.i35, %.274.i25
  %.364.i37 = zext i1 %.362.i36 to i64
  %.365.i38 = add nsw i64 %.351.i33, %.364.i37
  %.373.i39 = getelementptr inbounds double, ptr %arg.grid_places.0.4, i64 %.365.i38
  %.374.i40 = load double, ptr %.373.i39, align 8, !noalias !203
  %.376.i41 = fcmp contract ole double %.374.i40, %.274.i25
  %.378.i42 = zext i1 %.376.i41 to i64
  %.379.i43 = add nsw i64 %.365.i38, %.378.i42
  %.387.i44 = getelementptr inbounds double, ptr %arg.grid_places.0.4, i64 %.379.i43
  %.388.i45 = load double, ptr %.387.i44, align 8, !noalias !203
  %.390.i46 = fcmp contract ole double %.388.i45, %.274.i25
  %.392.i47 = zext i1 %.390.i46 to i64
  %.393.i48 = add nsw i64 %.379.i43, %.392.i47
  %.402.i49 = icmp slt i64 %.393.i48, %.683
  br i1 %.402.i49, label %B394.i54, label %B496.i50

B394.i54:                                         ; preds = %B146.i27
  %.419.i55 = getelementptr inbounds double, ptr %arg.grid_places.0.4, i64 %.393.i48
  %.420.i56 = load double, ptr %.419.i55, align 8, !noalias !203
  %.424.i57 = fcmp contract ugt double %.420.i56, %.274.i25
  br i1 %.424.i57, label %B496.i50, label %B434.i58

B434.i58:                                         ; preds = %B394.i54, %B456.i61
  %lsr.iv1 = phi i64 [ %5, %B456.i61 ], [ %.393.i48, %B394.i54 ]
  %5 = add nsw i64 %lsr.iv1, 1
  %.441.i60 = icmp slt i64 %5, %.683
  br i1 %.441.i60, label %B456.i61, label %B496.i50

B456.i61:                                         ; preds = %B434.i58
  %sunkaddr10 = shl i64 %lsr.iv1, 3
  %sunkaddr11 = getelementptr i8, ptr %arg.grid_places.0.4, i64 %sunkaddr10
  %sunkaddr12 = getelementptr i8, ptr %sunkaddr11, i64 8
  %.458.i65 = load double, ptr %sunkaddr12, align 8, !noalias !203
  %.462.i66 = fcmp contract ugt double %.458.i65, %.274.i25
  br i1 %.462.i66, label %B496.i50, label %B434.i58

B496.i50:                                         ; preds = %B456.i61, %B434.i58, %B88.if.i20, %B394.i54, %B146.i27
  %end.7.1.i51 = phi i64 [ %.393.i48, %B146.i27 ], [ 0, %B88.if.i20 ], [ %.393.i48, %B394.i54 ], [ %.683, %B434.i58 ], [ %5, %B456.i61 ]
  %.13.i.i52 = tail call i64 @llvm.smin.i64(i64 %.683, i64 %end.7.1.i51)
  %6 = getelementptr i64, ptr %arg.carrier.3.4, i64 %.228226230.i21
  store i64 %.13.i.i52, ptr %6, align 8, !noalias !203
  %exitcond.not.i53 = icmp eq i64 %.235.i22, %..140.i15
  br i1 %exitcond.not.i53, label %_ZN17bnserve_surrogate6kernel7_places15find_ends_apartB4v197B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5TupleI5ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedExdE5ArrayIdLi1E1C7mutable7alignedExdx5ArrayIxLi1E1C7mutable7alignedE.exit67, label %B88.if.i20

B88.if.i20:                                       ; preds = %B556, %B496.i50
  %.228226230.i21 = phi i64 [ %.235.i22, %B496.i50 ], [ 0, %B556 ]
  %.235.i22 = add nuw nsw i64 %.228226230.i21, 1
  %.271.i23 = getelementptr inbounds nuw double, ptr %.1849, i64 %.228226230.i21
  %.272.i24 = load double, ptr %.271.i23, align 8, !noalias !203
  %.274.i25 = fsub contract double %.272.i24, %.271.le
  %.283.i26 = fcmp contract ult double %.274.i25, %.135.i12
  br i1 %.283.i26, label %B496.i50, label %B146.i27

_ZN17bnserve_surrogate6kernel7_places15find_ends_apartB4v197B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5TupleI5ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedExdE5ArrayIdLi1E1C7mutable7alignedExdx5ArrayIxLi1E1C7mutable7alignedE.exit67: ; preds = %B496.i50, %B556
  %.588.inv.i17 = icmp sgt i64 %.1930, 1
  %.589.i18 = select i1 %.588.inv.i17, i64 0, i64 %arg.carrier.3.5.0
  %7 = getelementptr i64, ptr %arg.carrier.3.4, i64 %.140.i13
  %.603.i19 = getelementptr i64, ptr %7, i64 %.589.i18
  store i64 %.683, ptr %.603.i19, align 8, !noalias !203
  store ptr null, ptr %retptr, align 8
  br label %common.ret
}

; Function Attrs: nofree noinline norecurse nosync nounwind memory(readwrite, inaccessiblemem: none, target_mem0: none, target_mem1: none)
define internal fastcc void @inner_29(ptr noalias nonnull writeonly captures(none) %retptr, ptr readonly captures(none) %arg.mode.4, i8 range(i8 0, 2) %arg.ends, i64 %arg.lane, ptr readonly captures(none) %arg.ratios.4, ptr writeonly captures(none) %arg.modes.4, ptr readonly captures(none) %arg.grid_places.0.4, i64 %arg.grid_places.1, ptr readonly captures(none) %arg.grid_places.2.4, i64 %arg.grid_places.3, double %arg.grid_places.4, double %arg.shift, i64 %arg.stop) unnamed_addr #4 {
entry:
  %.1557 = alloca i64, align 8
  store i64 0, ptr %.1557, align 8
  %.1737 = alloca i64, align 8
  store i64 0, ptr %.1737, align 8
  %.122 = getelementptr i8, ptr %arg.mode.4, i64 24
  %.123 = load i64, ptr %.122, align 8
  %.124 = inttoptr i64 %.123 to ptr
  %.202 = getelementptr i8, ptr %arg.mode.4, i64 40
  %.203 = load i64, ptr %.202, align 8
  %.204 = inttoptr i64 %.203 to ptr
  %.286 = getelementptr i8, ptr %.124, i64 64
  %.287 = load i64, ptr %.286, align 8
  %.288 = sub i64 0, %.287
  %.296.1 = and i64 %.288, -8
  %.330 = sub i64 0, %.296.1
  %.359 = getelementptr i8, ptr %arg.mode.4, i64 48
  %.360 = load i64, ptr %.359, align 8
  %.364 = ashr i64 %.360, 1
  %.377 = getelementptr double, ptr %arg.modes.4, i64 %.364
  %.502.idx = shl i64 %.330, 5
  %.502 = getelementptr i8, ptr %.377, i64 %.502.idx
  %.580.idx = shl i64 %.330, 6
  %.580 = getelementptr i8, ptr %.377, i64 %.580.idx
  %.647 = getelementptr i8, ptr %.580, i64 64
  %.727 = getelementptr i8, ptr %.124, i64 120
  %.728 = load i64, ptr %.727, align 8
  %.741 = getelementptr double, ptr %.204, i64 %.728
  %.234.i = shl i64 %.330, 1
  %0 = add i64 %.287, 6
  %.486.i = lshr i64 %0, 3
  %.463.inv.i = icmp slt i64 %.287, 2
  %.507321.not325.i = icmp eq i64 %.486.i, 0
  %.507321.not.i = or i1 %.463.inv.i, %.507321.not325.i
  br i1 %.507321.not.i, label %_ZN17bnserve_surrogate6kernel7_points10fill_cellsB4v158B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedExx5ArrayIdLi1E1C7mutable7alignedE.exit122, label %B94.if.lr.ph.i

B578:                                             ; preds = %_ZN17bnserve_surrogate6kernel7_points10fill_cellsB4v158B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedExx5ArrayIdLi1E1C7mutable7alignedE.exit122
  %.135.i = load double, ptr %arg.grid_places.0.4, align 8, !noalias !206
  %.140.i = add nsw i64 %.287, -2
  %.178.i = icmp slt i64 %.287, 3
  %..140.i = select i1 %.178.i, i64 0, i64 %.140.i
  %.222229.i = icmp sgt i64 %..140.i, 0
  br i1 %.222229.i, label %B88.if.i, label %_ZN17bnserve_surrogate6kernel7_places15find_ends_apartB4v197B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5TupleI5ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedExdE5ArrayIdLi1E1C7mutable7alignedExdx5ArrayIxLi1E1C7mutable7alignedE.exit

common.ret.sink.split:                            ; preds = %_ZN17bnserve_surrogate6kernel7_places15find_ends_apartB4v197B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5TupleI5ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedExdE5ArrayIdLi1E1C7mutable7alignedExdx5ArrayIxLi1E1C7mutable7alignedE.exit, %_ZN17bnserve_surrogate6kernel7_points10fill_cellsB4v158B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedExx5ArrayIdLi1E1C7mutable7alignedE.exit122
  store ptr null, ptr %retptr, align 8
  ret void

B94.if.lr.ph.i:                                   ; preds = %entry
  %1 = lshr i64 %.330, 33
  %.99.i = and i64 %1, 1073741824
  %.272.i = add i64 %.99.i, %.234.i
  %2 = tail call i64 @llvm.smax.i64(i64 %.272.i, i64 0)
  %.100.i = sub i64 %.99.i, %.296.1
  %3 = tail call i64 @llvm.smax.i64(i64 %.100.i, i64 0)
  %.88.sroa.0.3.i = tail call i64 @llvm.smin.i64(i64 %3, i64 1073741824)
  %4 = getelementptr double, ptr %.377, i64 %.330
  %5 = getelementptr double, ptr %.377, i64 %.234.i
  %.idx.i = mul i64 %.296.1, -24
  %6 = getelementptr i8, ptr %.377, i64 %.idx.i
  %7 = lshr i64 %.288, 3
  %8 = shl i64 %arg.lane, 8
  %9 = sub nuw nsw i64 -64, %8
  %10 = mul i64 %7, %9
  %11 = shl i64 %.360, 3
  %12 = getelementptr i8, ptr %arg.ratios.4, i64 %10
  %13 = getelementptr i8, ptr %12, i64 %11
  %scevgep250 = getelementptr i8, ptr %13, i64 8
  %14 = mul i64 %arg.lane, -256
  %.neg = mul i64 %14, %7
  %15 = getelementptr i8, ptr %arg.ratios.4, i64 %11
  %16 = getelementptr i8, ptr %15, i64 8
  %scevgep254 = getelementptr i8, ptr %16, i64 %.neg
  %smin19 = tail call i64 @llvm.smin.i64(i64 %2, i64 1073741824)
  %17 = add i64 %smin19, %.728
  %18 = shl i64 %17, 3
  %scevgep20 = getelementptr i8, ptr %.204, i64 %18
  %19 = add i64 %.88.sroa.0.3.i, %.728
  %20 = shl i64 %19, 3
  %scevgep22 = getelementptr i8, ptr %.204, i64 %20
  %21 = add nuw nsw i64 %.486.i, 7
  br label %B94.if.i

B94.if.i:                                         ; preds = %B94.if.i, %B94.if.lr.ph.i
  %lsr.iv6 = phi i64 [ %lsr.iv.next7, %B94.if.i ], [ %21, %B94.if.lr.ph.i ]
  %lsr.iv53.i = phi i64 [ %lsr.iv.next54.i, %B94.if.i ], [ 0, %B94.if.lr.ph.i ]
  %scevgep256 = getelementptr i8, ptr %scevgep254, i64 %lsr.iv53.i
  %scevgep257 = getelementptr i8, ptr %scevgep256, i64 -8
  %.554.i = load <8 x double>, ptr %scevgep257, align 8, !noalias !209
  %.565.i = load <8 x double>, ptr %scevgep256, align 8, !noalias !209
  %scevgep252 = getelementptr i8, ptr %scevgep250, i64 %lsr.iv53.i
  %scevgep253 = getelementptr i8, ptr %scevgep252, i64 -8
  %.575.i = load <8 x double>, ptr %scevgep253, align 8, !noalias !209
  %.586.i = load <8 x double>, ptr %scevgep252, align 8, !noalias !209
  %scevgep23 = getelementptr i8, ptr %scevgep22, i64 %lsr.iv53.i
  %.596.i = load <8 x double>, ptr %scevgep23, align 8, !noalias !209
  %scevgep21 = getelementptr i8, ptr %scevgep20, i64 %lsr.iv53.i
  %.606.i = load <8 x double>, ptr %scevgep21, align 8, !noalias !209
  %.6.i.i = fsub contract <8 x double> %.565.i, %.554.i
  %.6.i46.i = fmul contract <8 x double> %.6.i.i, %.606.i
  %scevgep65.i = getelementptr i8, ptr %.377, i64 %lsr.iv53.i
  store <8 x double> %.554.i, ptr %scevgep65.i, align 8, !noalias !209
  %.669.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.575.i, <8 x double> splat (double 2.000000e+00), <8 x double> %.586.i)
  %.8.i.i = fmul contract <8 x double> %.669.i, splat (double 0x3FC5555555555555)
  %.6.i47.i = fmul contract <8 x double> %.596.i, %.8.i.i
  %.6.i48.i = fsub contract <8 x double> %.6.i46.i, %.6.i47.i
  %scevgep64.i = getelementptr i8, ptr %4, i64 %lsr.iv53.i
  store <8 x double> %.6.i48.i, ptr %scevgep64.i, align 8, !noalias !209
  %.8.i49.i = fmul contract <8 x double> %.575.i, splat (double 5.000000e-01)
  %scevgep63.i = getelementptr i8, ptr %5, i64 %lsr.iv53.i
  store <8 x double> %.8.i49.i, ptr %scevgep63.i, align 8, !noalias !209
  %.6.i50.i = fsub contract <8 x double> %.586.i, %.575.i
  %.6.i51.i = fmul contract <8 x double> %.6.i50.i, %.606.i
  %.8.i52.i = fmul contract <8 x double> %.6.i51.i, splat (double 0x3FC5555555555555)
  %scevgep62.i = getelementptr i8, ptr %6, i64 %lsr.iv53.i
  store <8 x double> %.8.i52.i, ptr %scevgep62.i, align 8, !noalias !209
  %lsr.iv.next54.i = add i64 %lsr.iv53.i, 64
  %lsr.iv.next7 = add nsw i64 %lsr.iv6, -1
  %.507.i = icmp sgt i64 %lsr.iv6, 8
  br i1 %.507.i, label %B94.if.i, label %B94.if.lr.ph.i86

B94.if.lr.ph.i86:                                 ; preds = %B94.if.i
  %22 = getelementptr double, ptr %.502, i64 %.330
  %23 = getelementptr double, ptr %.502, i64 %.234.i
  %24 = getelementptr i8, ptr %.502, i64 %.idx.i
  %25 = sub nuw nsw i64 -192, %8
  %26 = mul i64 %7, %25
  %27 = getelementptr i8, ptr %arg.ratios.4, i64 %26
  %28 = getelementptr i8, ptr %27, i64 %11
  %scevgep240 = getelementptr i8, ptr %28, i64 8
  %29 = sub nuw nsw i64 -128, %8
  %30 = mul i64 %7, %29
  %31 = getelementptr i8, ptr %arg.ratios.4, i64 %30
  %32 = getelementptr i8, ptr %31, i64 %11
  %scevgep244 = getelementptr i8, ptr %32, i64 8
  br label %B94.if.i88

B94.if.i88:                                       ; preds = %B94.if.i88, %B94.if.lr.ph.i86
  %lsr.iv = phi i64 [ %lsr.iv.next, %B94.if.i88 ], [ %21, %B94.if.lr.ph.i86 ]
  %lsr.iv53.i89 = phi i64 [ %lsr.iv.next54.i118, %B94.if.i88 ], [ 0, %B94.if.lr.ph.i86 ]
  %scevgep246 = getelementptr i8, ptr %scevgep244, i64 %lsr.iv53.i89
  %scevgep247 = getelementptr i8, ptr %scevgep246, i64 -8
  %.554.i92 = load <8 x double>, ptr %scevgep247, align 8, !noalias !212
  %.565.i94 = load <8 x double>, ptr %scevgep246, align 8, !noalias !212
  %scevgep242 = getelementptr i8, ptr %scevgep240, i64 %lsr.iv53.i89
  %scevgep243 = getelementptr i8, ptr %scevgep242, i64 -8
  %.575.i96 = load <8 x double>, ptr %scevgep243, align 8, !noalias !212
  %.586.i98 = load <8 x double>, ptr %scevgep242, align 8, !noalias !212
  %scevgep16 = getelementptr i8, ptr %scevgep22, i64 %lsr.iv53.i89
  %.596.i100 = load <8 x double>, ptr %scevgep16, align 8, !noalias !212
  %scevgep14 = getelementptr i8, ptr %scevgep20, i64 %lsr.iv53.i89
  %.606.i102 = load <8 x double>, ptr %scevgep14, align 8, !noalias !212
  %.6.i.i103 = fsub contract <8 x double> %.565.i94, %.554.i92
  %.6.i46.i104 = fmul contract <8 x double> %.6.i.i103, %.606.i102
  %scevgep65.i105 = getelementptr i8, ptr %.502, i64 %lsr.iv53.i89
  store <8 x double> %.554.i92, ptr %scevgep65.i105, align 8, !noalias !212
  %.669.i106 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.575.i96, <8 x double> splat (double 2.000000e+00), <8 x double> %.586.i98)
  %.8.i.i107 = fmul contract <8 x double> %.669.i106, splat (double 0x3FC5555555555555)
  %.6.i47.i108 = fmul contract <8 x double> %.596.i100, %.8.i.i107
  %.6.i48.i109 = fsub contract <8 x double> %.6.i46.i104, %.6.i47.i108
  %scevgep64.i110 = getelementptr i8, ptr %22, i64 %lsr.iv53.i89
  store <8 x double> %.6.i48.i109, ptr %scevgep64.i110, align 8, !noalias !212
  %.8.i49.i111 = fmul contract <8 x double> %.575.i96, splat (double 5.000000e-01)
  %scevgep63.i112 = getelementptr i8, ptr %23, i64 %lsr.iv53.i89
  store <8 x double> %.8.i49.i111, ptr %scevgep63.i112, align 8, !noalias !212
  %.6.i50.i113 = fsub contract <8 x double> %.586.i98, %.575.i96
  %.6.i51.i114 = fmul contract <8 x double> %.6.i50.i113, %.606.i102
  %.8.i52.i115 = fmul contract <8 x double> %.6.i51.i114, splat (double 0x3FC5555555555555)
  %scevgep62.i116 = getelementptr i8, ptr %24, i64 %lsr.iv53.i89
  store <8 x double> %.8.i52.i115, ptr %scevgep62.i116, align 8, !noalias !212
  %lsr.iv.next54.i118 = add i64 %lsr.iv53.i89, 64
  %lsr.iv.next = add nsw i64 %lsr.iv, -1
  %.507.i119 = icmp sgt i64 %lsr.iv, 8
  br i1 %.507.i119, label %B94.if.i88, label %_ZN17bnserve_surrogate6kernel7_points10fill_cellsB4v158B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedExx5ArrayIdLi1E1C7mutable7alignedE.exit122

_ZN17bnserve_surrogate6kernel7_points10fill_cellsB4v158B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedExx5ArrayIdLi1E1C7mutable7alignedE.exit122: ; preds = %B94.if.i88, %entry
  %.1509 = load double, ptr %.741, align 8
  %.1511 = fsub contract double %.1509, %arg.shift
  store i64 0, ptr %.1557, align 8
  call fastcc void @inner_14(ptr nonnull %.1557, ptr %arg.grid_places.0.4, i64 %arg.grid_places.1, ptr %arg.grid_places.2.4, i64 %arg.grid_places.3, double %arg.grid_places.4, double %.1511)
  %.1575 = load i64, ptr %.1557, align 8
  %.13.i = tail call i64 @llvm.smin.i64(i64 %arg.stop, i64 %.1575)
  store i64 %.13.i, ptr %.580, align 8
  %33 = getelementptr double, ptr %.741, i64 %.287
  %.1688 = getelementptr i8, ptr %33, i64 -8
  %.1689 = load double, ptr %.1688, align 8
  %.1691 = fsub contract double %.1689, %arg.shift
  store i64 0, ptr %.1737, align 8
  call fastcc void @inner_14(ptr nonnull %.1737, ptr %arg.grid_places.0.4, i64 %arg.grid_places.1, ptr %arg.grid_places.2.4, i64 %arg.grid_places.3, double %arg.grid_places.4, double %.1691)
  %34 = icmp eq i8 %arg.ends, 0
  %.1755 = load i64, ptr %.1737, align 8
  %.13.i123 = tail call i64 @llvm.smin.i64(i64 %arg.stop, i64 %.1755)
  %.1827 = getelementptr i8, ptr %.580, i64 8
  store i64 %.13.i123, ptr %.1827, align 8
  %.1857 = getelementptr i8, ptr %.580, i64 16
  store i64 0, ptr %.1857, align 8
  br i1 %34, label %common.ret.sink.split, label %B578

B146.i:                                           ; preds = %B88.if.i
  %.287.i = fsub contract double %.274.i, %.135.i
  %.289.i = fmul contract double %arg.grid_places.4, %.287.i
  %.5.i.i = fptosi double %.289.i to i64
  %.13.i3.i = tail call i64 @llvm.smin.i64(i64 %arg.grid_places.3, i64 %.5.i.i)
  %.350.i = getelementptr inbounds i64, ptr %arg.grid_places.2.4, i64 %.13.i3.i
  %.351.i = load i64, ptr %.350.i, align 8, !noalias !206
  %.359.i = getelementptr inbounds double, ptr %arg.grid_places.0.4, i64 %.351.i
  %.360.i = load double, ptr %.359.i, align 8, !noalias !206
  %.362.i = fcmp contract ole double %.360.i, %.274.i
  %.364.i = zext i1 %.362.i to i64
  %.365.i = add nsw i64 %.351.i, %.364.i
  %.373.i125 = getelementptr inbounds double, ptr %arg.grid_places.0.4, i64 %.365.i
  %.374.i = load double, ptr %.373.i125, align 8, !noalias !206
  %.376.i = fcmp contract ole double %.374.i, %.274.i
  %.378.i = zext i1 %.376.i to i64
  %.379.i = add nsw i64 %.365.i, %.378.i
  %.387.i = getelementptr inbounds double, ptr %arg.grid_places.0.4, i64 %.379.i
  %.388.i = load double, ptr %.387.i, align 8, !noalias !206
  %.390.i = fcmp contract ole double %.388.i, %.274.i
  %.392.i = zext i1 %.390.i to i64
  %.393.i = add nsw i64 %.379.i, %.392.i
  %.402.i = icmp slt i64 %.393.i, %.13.i123
  br i1 %.402.i, label %B394.i, label %B496.i

B394.i:                                           ; preds = %B146.i
  %.419.i = getelementptr inbounds double, ptr %arg.grid_places.0.4, i64 %.393.i
  %.420.i = load double, ptr %.419.i, align 8, !noalias !206
  %.424.i = fcmp contract ugt double %.420.i, %.274.i
  br i1 %.424.i, label %B496.i, label %B434.i

B434.i:                                           ; preds = %B394.i, %B456.i
  %lsr.iv2 = phi i64 [ %35, %B456.i ], [ %.393.i, %B394.i ]
  %35 = add nsw i64 %lsr.iv2, 1
  %.441.i = icmp slt i64 %35, %.13.i123
  br i1 %.441.i, label %B456.i, label %B496.i

B456.i:                                           ; preds = %B434.i
  %sunkaddr = shl i64 %lsr.iv2, 3
  %sunkaddr8 = getelementptr i8, ptr %arg.grid_places.0.4, i64 %sunkaddr
  %sunkaddr9 = getelementptr i8, ptr %sunkaddr8, i64 8
  %.458.i = load double, ptr %sunkaddr9, align 8, !noalias !206
  %.462.i = fcmp contract ugt double %.458.i, %.274.i
  br i1 %.462.i, label %B496.i, label %B434.i

B496.i:                                           ; preds = %B456.i, %B434.i, %B88.if.i, %B394.i, %B146.i
  %end.7.1.i = phi i64 [ %.393.i, %B146.i ], [ 0, %B88.if.i ], [ %.393.i, %B394.i ], [ %.13.i123, %B434.i ], [ %35, %B456.i ]
  %.13.i.i = tail call i64 @llvm.smin.i64(i64 %.13.i123, i64 %end.7.1.i)
  %36 = getelementptr i64, ptr %.647, i64 %.228226230.i
  store i64 %.13.i.i, ptr %36, align 8, !noalias !206
  %exitcond.not.i = icmp eq i64 %.235.i, %..140.i
  br i1 %exitcond.not.i, label %_ZN17bnserve_surrogate6kernel7_places15find_ends_apartB4v197B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5TupleI5ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedExdE5ArrayIdLi1E1C7mutable7alignedExdx5ArrayIxLi1E1C7mutable7alignedE.exit, label %B88.if.i

B88.if.i:                                         ; preds = %B578, %B496.i
  %.228226230.i = phi i64 [ %.235.i, %B496.i ], [ 0, %B578 ]
  %.235.i = add nuw nsw i64 %.228226230.i, 1
  %sunkaddr260 = shl i64 %.228226230.i, 3
  %sunkaddr261 = getelementptr inbounds i8, ptr %.741, i64 %sunkaddr260
  %sunkaddr262 = getelementptr inbounds nuw i8, ptr %sunkaddr261, i64 8
  %.272.i124 = load double, ptr %sunkaddr262, align 8, !noalias !206
  %.274.i = fsub contract double %.272.i124, %arg.shift
  %.283.i = fcmp contract ult double %.274.i, %.135.i
  br i1 %.283.i, label %B496.i, label %B146.i

_ZN17bnserve_surrogate6kernel7_places15find_ends_apartB4v197B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5TupleI5ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedExdE5ArrayIdLi1E1C7mutable7alignedExdx5ArrayIxLi1E1C7mutable7alignedE.exit: ; preds = %B496.i, %B578
  %.588.inv.i = icmp sgt i64 %.287, 1
  %.589.i = select i1 %.588.inv.i, i64 0, i64 %.330
  %37 = getelementptr i64, ptr %.647, i64 %.140.i
  %.603.i = getelementptr i64, ptr %37, i64 %.589.i
  store i64 %.13.i123, ptr %.603.i, align 8, !noalias !206
  br label %common.ret.sink.split
}

; Function Attrs: nofree noinline norecurse nosync nounwind memory(readwrite, inaccessiblemem: none, target_mem0: none, target_mem1: none)
define internal fastcc void @inner_25(ptr noalias nonnull writeonly captures(none) %retptr, i64 %arg.start, i64 %arg.inside, i8 range(i8 0, 2) %arg.dense, ptr readonly captures(none) %arg.grid.4, i64 %arg.stride, ptr readonly captures(none) %arg.linear.4, i64 range(i64 40, 9) %arg.linear.5.0, ptr readonly captures(none) %arg.contents.4, ptr readonly captures(none) %arg.weights.4, i64 range(i64 8, 1) %arg.sizes.0, i64 range(i64 8, 1) %arg.sizes.1, ptr readonly captures(none) %arg.cubics.0.4, ptr readonly captures(none) %arg.cubics.1.4, ptr readonly captures(none) %arg.fitted.0.4, ptr readonly captures(none) %arg.fitted.1.4, double %arg.top.0, double %arg.top.1, double %arg.top.2, ptr readonly captures(none) %arg.carrier.0.4, ptr readonly captures(none) %arg.carrier.1.4, ptr captures(none) %arg.carrier.2.4, ptr readonly captures(none) %arg.carrier.3.4, ptr captures(none) %arg.a.4, ptr captures(none) %arg.p.4, ptr writeonly captures(none) %arg.amplitude.4, ptr writeonly captures(none) %arg.phase.4) unnamed_addr #4 {
entry:
  %.2471 = alloca ptr, align 8
  store ptr null, ptr %.2471, align 8
  %.405 = load double, ptr %arg.carrier.1.4, align 8
  %.434 = getelementptr i8, ptr %arg.carrier.1.4, i64 8
  %.435 = load double, ptr %.434, align 8
  %.471 = getelementptr i8, ptr %arg.contents.4, i64 128
  %.472 = load i64, ptr %.471, align 8
  %.647 = load i64, ptr %arg.carrier.2.4, align 8
  %.13.i24 = tail call i64 @llvm.smax.i64(i64 %arg.start, i64 %.647)
  %.13.i25 = tail call i64 @llvm.smin.i64(i64 %arg.inside, i64 %.13.i24)
  %.734 = getelementptr i8, ptr %arg.carrier.2.4, i64 8
  %.735 = load i64, ptr %.734, align 8
  %.13.i26 = tail call i64 @llvm.smax.i64(i64 %arg.start, i64 %.735)
  %.13.i27 = tail call i64 @llvm.smin.i64(i64 %arg.inside, i64 %.13.i26)
  %.802 = icmp sgt i64 %.13.i25, %arg.start
  br i1 %.802, label %B322, label %B476

B322:                                             ; preds = %entry
  %.549.idx = shl nsw i64 %arg.sizes.0, 5
  %.549 = getelementptr inbounds i8, ptr %arg.linear.4, i64 %.549.idx
  %.833 = load double, ptr %arg.linear.4, align 8
  %.849 = icmp slt i64 %arg.sizes.0, 0
  %.850 = select i1 %.849, i64 %arg.linear.5.0, i64 0
  %.idx = shl i64 %arg.sizes.0, 4
  %0 = getelementptr i8, ptr %arg.linear.4, i64 %.idx
  %.864 = getelementptr double, ptr %0, i64 %.850
  %.865 = load double, ptr %.864, align 8
  %.888 = getelementptr double, ptr %arg.grid.4, i64 %arg.start
  %.941 = sub nsw i64 %.13.i25, %arg.start
  %sunkaddr = shl i64 %.472, 3
  %sunkaddr333 = getelementptr inbounds i8, ptr %arg.weights.4, i64 %sunkaddr
  %.971 = load double, ptr %sunkaddr333, align 8
  %.1000 = getelementptr i8, ptr %.549, i64 8
  %.1001 = load double, ptr %.1000, align 8
  %.145103.not.i = icmp slt i64 %.941, 1
  br i1 %.145103.not.i, label %B476, label %B34.if.i

B476:                                             ; preds = %B144.i, %B322, %entry
  %1 = icmp eq i8 %arg.dense, 0
  br i1 %1, label %B480, label %B736

B480:                                             ; preds = %B476
  %.1090 = getelementptr i8, ptr %arg.contents.4, i64 120
  %.1091 = load i64, ptr %.1090, align 8
  %.1102 = getelementptr inbounds double, ptr %arg.weights.4, i64 %.1091
  %.1211 = getelementptr i8, ptr %arg.carrier.2.4, i64 40
  %.1212 = load i64, ptr %.1211, align 8
  %.1235 = getelementptr double, ptr %arg.grid.4, i64 %arg.stride
  %.126.i = icmp slt i64 %.13.i24, %.13.i27
  br i1 %.126.i, label %B22.preheader.i, label %_ZN17bnserve_surrogate6kernel7_points11two_splinesB4v364B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedExxd5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit

B736:                                             ; preds = %_ZN17bnserve_surrogate6kernel7_points11two_splinesB4v364B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedExxd5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit, %B476
  %.696..784 = phi i64 [ %.13.i25, %B476 ], [ %.13.i27, %_ZN17bnserve_surrogate6kernel7_points11two_splinesB4v364B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedExxd5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit ]
  %.1867 = sub nsw i64 %.696..784, %arg.start
  %.1874 = icmp sgt i64 %.1867, 0
  br i1 %.1874, label %B1168, label %B1270

B1168:                                            ; preds = %B736
  %.1904 = getelementptr i8, ptr %arg.carrier.2.4, i64 16
  %.1905 = load i64, ptr %.1904, align 8
  %.1934 = getelementptr i8, ptr %arg.carrier.2.4, i64 24
  %.1935 = load i64, ptr %.1934, align 8
  %.1969 = getelementptr i8, ptr %arg.carrier.1.4, i64 16
  %.1970 = load double, ptr %.1969, align 8
  %.2026 = sub nsw i64 %.1905, %arg.start
  %.13.i = tail call i64 @llvm.smax.i64(i64 %.2026, i64 0)
  %.13.i49 = tail call i64 @llvm.smin.i64(i64 %.1867, i64 %.13.i)
  %.2086 = sub nsw i64 %.1935, %arg.start
  %.13.i50 = tail call i64 @llvm.smax.i64(i64 %.2086, i64 0)
  %.13.i51 = tail call i64 @llvm.smin.i64(i64 %.1867, i64 %.13.i50)
  %.2159 = getelementptr double, ptr %arg.grid.4, i64 %arg.start
  %.idx1807 = shl i64 %arg.stride, 4
  %2 = getelementptr i8, ptr %arg.grid.4, i64 %.idx1807
  %.2290 = getelementptr double, ptr %2, i64 %arg.start
  %.idx1808 = mul i64 %arg.stride, 24
  %.idx1809 = shl i64 %arg.stride, 5
  %3 = getelementptr i8, ptr %arg.grid.4, i64 %.idx1809
  %.2419 = getelementptr double, ptr %3, i64 %arg.start
  store ptr null, ptr %.2471, align 8
  call fastcc void @inner_12(ptr nonnull %.2471, ptr %.2159, ptr %.2290, ptr %.2419, i64 %.13.i49, i64 %.13.i51, i64 %.1867, double %.405, ptr %arg.carrier.0.4, double %.1970, ptr %arg.a.4, ptr %arg.amplitude.4)
  %4 = add nuw i64 %.1867, 7
  %.1167.i = lshr i64 %4, 3
  %.2596 = getelementptr inbounds nuw i8, ptr %arg.carrier.0.4, i64 192
  %.2532 = getelementptr inbounds nuw i8, ptr %arg.carrier.0.4, i64 64
  %.1012.i = getelementptr i8, ptr %arg.carrier.0.4, i64 264
  %.1013.i = load double, ptr %.1012.i, align 8, !noalias !215
  %.983.i = getelementptr i8, ptr %arg.carrier.0.4, i64 256
  %.984.i = load double, ptr %.983.i, align 8, !noalias !215
  %.954.i = getelementptr i8, ptr %arg.carrier.0.4, i64 248
  %.955.i = load double, ptr %.954.i, align 8, !noalias !215
  %.925.i = getelementptr i8, ptr %arg.carrier.0.4, i64 240
  %.926.i = load double, ptr %.925.i, align 8, !noalias !215
  %.896.i = getelementptr i8, ptr %arg.carrier.0.4, i64 232
  %.897.i = load double, ptr %.896.i, align 8, !noalias !215
  %.867.i = getelementptr i8, ptr %arg.carrier.0.4, i64 224
  %.868.i = load double, ptr %.867.i, align 8, !noalias !215
  %.838.i = getelementptr i8, ptr %arg.carrier.0.4, i64 216
  %.839.i = load double, ptr %.838.i, align 8, !noalias !215
  %.809.i = getelementptr i8, ptr %arg.carrier.0.4, i64 208
  %.810.i = load double, ptr %.809.i, align 8, !noalias !215
  %.780.i = getelementptr i8, ptr %arg.carrier.0.4, i64 200
  %.781.i = load double, ptr %.780.i, align 8, !noalias !215
  %.752.i = load double, ptr %.2596, align 8, !noalias !215
  %.647.i = getelementptr i8, ptr %arg.carrier.0.4, i64 184
  %.648.i = load double, ptr %.647.i, align 8, !noalias !215
  %.618.i = getelementptr i8, ptr %arg.carrier.0.4, i64 176
  %.619.i = load double, ptr %.618.i, align 8, !noalias !215
  %.589.i = getelementptr i8, ptr %arg.carrier.0.4, i64 168
  %.590.i = load double, ptr %.589.i, align 8, !noalias !215
  %.560.i = getelementptr i8, ptr %arg.carrier.0.4, i64 160
  %.561.i = load double, ptr %.560.i, align 8, !noalias !215
  %.531.i = getelementptr i8, ptr %arg.carrier.0.4, i64 152
  %.532.i = load double, ptr %.531.i, align 8, !noalias !215
  %.502.i = getelementptr i8, ptr %arg.carrier.0.4, i64 144
  %.503.i = load double, ptr %.502.i, align 8, !noalias !215
  %.473.i = getelementptr i8, ptr %arg.carrier.0.4, i64 136
  %.474.i = load double, ptr %.473.i, align 8, !noalias !215
  %.444.i = getelementptr i8, ptr %arg.carrier.0.4, i64 128
  %.445.i = load double, ptr %.444.i, align 8, !noalias !215
  %.343.i = getelementptr i8, ptr %arg.carrier.0.4, i64 120
  %.344.i = load double, ptr %.343.i, align 8, !noalias !215
  %.314.i87 = getelementptr i8, ptr %arg.carrier.0.4, i64 112
  %.315.i88 = load double, ptr %.314.i87, align 8, !noalias !215
  %.285.i = getelementptr i8, ptr %arg.carrier.0.4, i64 104
  %.286.i = load double, ptr %.285.i, align 8, !noalias !215
  %.256.i89 = getelementptr i8, ptr %arg.carrier.0.4, i64 96
  %.257.i = load double, ptr %.256.i89, align 8, !noalias !215
  %.227.i = getelementptr i8, ptr %arg.carrier.0.4, i64 88
  %.228.i90 = load double, ptr %.227.i, align 8, !noalias !215
  %.198.i = getelementptr i8, ptr %arg.carrier.0.4, i64 80
  %.199.i = load double, ptr %.198.i, align 8, !noalias !215
  %.169.i = getelementptr i8, ptr %arg.carrier.0.4, i64 72
  %.170.i91 = load double, ptr %.169.i, align 8, !noalias !215
  %.141.i = load double, ptr %.2532, align 8, !noalias !215
  %.1282.i = insertelement <8 x double> poison, double %.619.i, i64 0
  %.1283.i = shufflevector <8 x double> %.1282.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1285.i = insertelement <8 x double> poison, double %.561.i, i64 0
  %.1286.i = shufflevector <8 x double> %.1285.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1289.i = insertelement <8 x double> poison, double %.503.i, i64 0
  %.1290.i = shufflevector <8 x double> %.1289.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1293.i = insertelement <8 x double> poison, double %.445.i, i64 0
  %.1294.i = shufflevector <8 x double> %.1293.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1297.i = insertelement <8 x double> poison, double %.648.i, i64 0
  %.1298.i = shufflevector <8 x double> %.1297.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1300.i = insertelement <8 x double> poison, double %.590.i, i64 0
  %.1301.i = shufflevector <8 x double> %.1300.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1304.i = insertelement <8 x double> poison, double %.532.i, i64 0
  %.1305.i = shufflevector <8 x double> %.1304.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1308.i = insertelement <8 x double> poison, double %.474.i, i64 0
  %.1309.i = shufflevector <8 x double> %.1308.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1312.i = insertelement <8 x double> poison, double %.315.i88, i64 0
  %.1313.i = shufflevector <8 x double> %.1312.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1315.i = insertelement <8 x double> poison, double %.257.i, i64 0
  %.1316.i = shufflevector <8 x double> %.1315.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1319.i = insertelement <8 x double> poison, double %.199.i, i64 0
  %.1320.i = shufflevector <8 x double> %.1319.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1323.i = insertelement <8 x double> poison, double %.141.i, i64 0
  %.1324.i = shufflevector <8 x double> %.1323.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1327.i = insertelement <8 x double> poison, double %.344.i, i64 0
  %.1328.i = shufflevector <8 x double> %.1327.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1330.i = insertelement <8 x double> poison, double %.286.i, i64 0
  %.1331.i = shufflevector <8 x double> %.1330.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1334.i = insertelement <8 x double> poison, double %.228.i90, i64 0
  %.1335.i = shufflevector <8 x double> %.1334.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1338.i = insertelement <8 x double> poison, double %.170.i91, i64 0
  %.1339.i = shufflevector <8 x double> %.1338.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1342.i = insertelement <8 x double> poison, double %.926.i, i64 0
  %.1343.i = shufflevector <8 x double> %.1342.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1345.i = insertelement <8 x double> poison, double %.868.i, i64 0
  %.1346.i = shufflevector <8 x double> %.1345.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1349.i = insertelement <8 x double> poison, double %.810.i, i64 0
  %.1350.i = shufflevector <8 x double> %.1349.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1353.i = insertelement <8 x double> poison, double %.752.i, i64 0
  %.1354.i = shufflevector <8 x double> %.1353.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1357.i = insertelement <8 x double> poison, double %.897.i, i64 0
  %.1358.i = shufflevector <8 x double> %.1357.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1360.i = insertelement <8 x double> poison, double %.839.i, i64 0
  %.1361.i = shufflevector <8 x double> %.1360.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1364.i = insertelement <8 x double> poison, double %.781.i, i64 0
  %.1365.i = shufflevector <8 x double> %.1364.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1428.i = insertelement <8 x double> poison, double %.955.i, i64 0
  %.1429.i = shufflevector <8 x double> %.1428.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1446.i = insertelement <8 x double> poison, double %.1013.i, i64 0
  %.1447.i = shufflevector <8 x double> %.1446.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1448.i = insertelement <8 x double> poison, double %.984.i, i64 0
  %.1449.i = shufflevector <8 x double> %.1448.i, <8 x double> poison, <8 x i32> zeroinitializer
  %5 = add nuw nsw i64 %.1167.i, 7
  %sunkaddr18 = shl i64 %arg.stride, 3
  br label %B484.if.i

B1270:                                            ; preds = %B484.if.i, %B736
  br i1 %1, label %B1552, label %B1272

B1272:                                            ; preds = %B1270
  %.2774 = getelementptr i8, ptr %arg.contents.4, i64 152
  %.2775 = load i64, ptr %.2774, align 8
  %6 = getelementptr double, ptr %arg.weights.4, i64 %.2775
  %.2798 = getelementptr double, ptr %6, i64 %arg.sizes.1
  %.2928 = getelementptr inbounds double, ptr %.2798, i64 %arg.sizes.1
  %.3160 = getelementptr i8, ptr %arg.carrier.2.4, i64 40
  %.3161 = load i64, ptr %.3160, align 8
  %.137.i = icmp slt i64 %.13.i24, %.13.i27
  br i1 %.137.i, label %B22.preheader.i117, label %B1272.endif.endif.endif.endif.endif.endif

B1552:                                            ; preds = %B1272.endif.endif.endif.endif.endif.endif, %B1270
  %.3654 = sub i64 %arg.inside, %.13.i27
  %7 = add i64 %.3654, 7
  %.3676 = lshr i64 %7, 3
  %.3655.inv = icmp slt i64 %.3654, 1
  %.36971817.not1821 = icmp eq i64 %.3676, 0
  %.36971817.not = or i1 %.3655.inv, %.36971817.not1821
  br i1 %.36971817.not, label %B76706, label %B76400.if.lr.ph

B76400.if.lr.ph:                                  ; preds = %B1552
  %sunkaddr334 = shl i64 %.472, 3
  %sunkaddr335 = getelementptr i8, ptr %arg.weights.4, i64 %sunkaddr334
  %sunkaddr336 = getelementptr i8, ptr %sunkaddr335, i64 8
  %.3592 = load double, ptr %sunkaddr336, align 8
  %.3602 = fdiv contract double %.3592, %.405
  %.3603 = tail call contract double @llvm.pow.f64(double %.3602, double 0x400AAAAAAAAAAAAB)
  %.3604 = fmul contract double %arg.top.0, %.3603
  %.idx1811 = mul i64 %arg.stride, 24
  %.3751 = insertelement <8 x double> poison, double %.3604, i64 0
  %.3752 = shufflevector <8 x double> %.3751, <8 x double> poison, <8 x i32> zeroinitializer
  %.3826 = fmul contract double %arg.top.2, %.405
  %.3829 = insertelement <8 x double> poison, double %arg.top.1, i64 0
  %.3830 = shufflevector <8 x double> %.3829, <8 x double> poison, <8 x i32> zeroinitializer
  %.3831 = insertelement <8 x double> poison, double %.3826, i64 0
  %.3832 = shufflevector <8 x double> %.3831, <8 x double> poison, <8 x i32> zeroinitializer
  %8 = shl i64 %.13.i27, 3
  %scevgep306 = getelementptr i8, ptr %arg.grid.4, i64 %.idx1811
  %9 = mul i64 %arg.start, -8
  %scevgep308 = getelementptr i8, ptr %arg.phase.4, i64 %9
  %scevgep310 = getelementptr i8, ptr %arg.amplitude.4, i64 %9
  %10 = add nuw nsw i64 %.3676, 6
  br label %B76400.if

B76706:                                           ; preds = %B76400.if, %B1552
  store ptr null, ptr %retptr, align 8
  ret void

B94.i:                                            ; preds = %B34.if.i
  %.6.i.i = fmul contract double %.229.i, 0x400921FB54442D18
  %.7.i.i = tail call contract double @llvm.fma.f64(double %.6.i.i, double 0x3FE45F306DC9C883, double 0x4338000000000000)
  %.8.i.i = fadd contract double %.7.i.i, 0xC338000000000000
  %.23.i.i = tail call contract double @llvm.fma.f64(double %.8.i.i, double 0xBFF921FB54442D18, double %.6.i.i)
  %.38.i.i = tail call contract double @llvm.fma.f64(double %.8.i.i, double 0xBC91A62633145C07, double %.23.i.i)
  %.39.i.i = fmul contract double %.38.i.i, %.38.i.i
  %.56.i.i = bitcast double %.7.i.i to i64
  %.60.i.i = and i64 %.56.i.i, 1
  %11 = icmp eq i64 %.60.i.i, 0
  br i1 %11, label %select.true.sink.i.i, label %select.false.sink.i.i

select.true.sink.i.i:                             ; preds = %B94.i
  %.48.i.i = tail call contract double @llvm.fma.f64(double %.39.i.i, double 0x3D2AE7F3E733B81F, double 0xBDA93974A8C07C9D)
  %.49.i.i = tail call contract double @llvm.fma.f64(double %.39.i.i, double %.48.i.i, double 0x3E21EED8EFF8D898)
  %.50.i.i = tail call contract double @llvm.fma.f64(double %.39.i.i, double %.49.i.i, double 0xBE927E4FB7789F5C)
  %.51.i.i = tail call contract double @llvm.fma.f64(double %.39.i.i, double %.50.i.i, double 0x3EFA01A01A01A01A)
  %.52.i.i = tail call contract double @llvm.fma.f64(double %.39.i.i, double %.51.i.i, double 0xBF56C16C16C16C17)
  %.53.i.i = tail call contract double @llvm.fma.f64(double %.39.i.i, double %.52.i.i, double 0x3FA5555555555555)
  %.54.i.i = tail call contract double @llvm.fma.f64(double %.39.i.i, double %.53.i.i, double -5.000000e-01)
  %.55.i.i = tail call contract double @llvm.fma.f64(double %.39.i.i, double %.54.i.i, double 1.000000e+00)
  br label %_ZN17bnserve_surrogate6kernel7_points4stepB4v362B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEd.exit.i

select.false.sink.i.i:                            ; preds = %B94.i
  %.46.i.i = fmul contract double %.38.i.i, %.39.i.i
  %.40.i.i = tail call contract double @llvm.fma.f64(double %.39.i.i, double 0xBD6AE7F3E733B81F, double 0x3DE6124613A86D09)
  %.41.i.i = tail call contract double @llvm.fma.f64(double %.39.i.i, double %.40.i.i, double 0xBE5AE64567F544E4)
  %.42.i.i = tail call contract double @llvm.fma.f64(double %.39.i.i, double %.41.i.i, double 0x3EC71DE3A556C734)
  %.43.i.i = tail call contract double @llvm.fma.f64(double %.39.i.i, double %.42.i.i, double 0xBF2A01A01A01A01A)
  %.44.i.i = tail call contract double @llvm.fma.f64(double %.39.i.i, double %.43.i.i, double 0x3F81111111111111)
  %.45.i.i = tail call contract double @llvm.fma.f64(double %.39.i.i, double %.44.i.i, double 0xBFC5555555555555)
  %.47.i.i = tail call contract double @llvm.fma.f64(double %.46.i.i, double %.45.i.i, double %.38.i.i)
  br label %_ZN17bnserve_surrogate6kernel7_points4stepB4v362B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEd.exit.i

_ZN17bnserve_surrogate6kernel7_points4stepB4v362B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEd.exit.i: ; preds = %select.false.sink.i.i, %select.true.sink.i.i
  %.71.v.i.i = phi double [ %.55.i.i, %select.true.sink.i.i ], [ %.47.i.i, %select.false.sink.i.i ]
  %.65.i.i = shl i64 %.56.i.i, 62
  %.66.i.i = add i64 %.65.i.i, 4611686018427387904
  %.67.i.i = and i64 %.66.i.i, -9223372036854775808
  %.71.i.i = bitcast double %.71.v.i.i to i64
  %.72.i.i = xor i64 %.67.i.i, %.71.i.i
  %.73.i.i = bitcast i64 %.72.i.i to double
  %.89.i.i = tail call contract double @llvm.fma.f64(double %.73.i.i, double -5.000000e-01, double 5.000000e-01)
  %.266.i = fmul contract double %.833, %.89.i.i
  br label %B144.i

B144.i:                                           ; preds = %B34.if.i, %_ZN17bnserve_surrogate6kernel7_points4stepB4v362B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEd.exit.i
  %"$phi144.1.2.1.i" = phi double [ %.266.i, %_ZN17bnserve_surrogate6kernel7_points4stepB4v362B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEd.exit.i ], [ 0.000000e+00, %B34.if.i ]
  %scevgep14 = getelementptr i8, ptr %arg.a.4, i64 %13
  store double %"$phi144.1.2.1.i", ptr %scevgep14, align 8, !noalias !218
  %.314.i = fsub contract double %.218.i, %.971
  %12 = fmul contract double %.1001, %.314.i
  %.319.i = fsub contract double %.865, %12
  %scevgep13 = getelementptr i8, ptr %arg.p.4, i64 %13
  store double %.319.i, ptr %scevgep13, align 8, !noalias !218
  %exitcond.not.i = icmp eq i64 %.941, %.158.i
  br i1 %exitcond.not.i, label %B476, label %B34.if.i

B34.if.i:                                         ; preds = %B322, %B144.i
  %.151102104.i = phi i64 [ %.158.i, %B144.i ], [ 0, %B322 ]
  %.158.i = add nuw nsw i64 %.151102104.i, 1
  %13 = shl i64 %.151102104.i, 3
  %scevgep2.i = getelementptr i8, ptr %.888, i64 %13
  %.216.i = load double, ptr %scevgep2.i, align 8, !noalias !218
  %.218.i = fmul contract double %.405, %.216.i
  %.223.i = fmul contract double %.218.i, 2.000000e+00
  %.228.i = fdiv contract double %.223.i, %.971
  %.228.fr.i = freeze double %.228.i
  %.229.i = fadd contract double %.228.fr.i, -1.000000e+00
  %.234.i = fcmp contract ogt double %.229.i, 0.000000e+00
  br i1 %.234.i, label %B94.i, label %B144.i

B22.preheader.i:                                  ; preds = %B480
  %.1498 = sub i64 %.13.i25, %arg.start
  %.1577 = getelementptr double, ptr %arg.p.4, i64 %.1498
  %.1511 = getelementptr double, ptr %arg.a.4, i64 %.1498
  %.264.i = shl nsw i64 %arg.sizes.0, 1
  %.277.i = mul nsw i64 %arg.sizes.0, 3
  %14 = mul i64 %.13.i25, -8
  %scevgep7.i = getelementptr i8, ptr %.1577, i64 %14
  %scevgep11.i = getelementptr i8, ptr %.1511, i64 %14
  br label %B22.i

B22.i:                                            ; preds = %B926.i, %B22.preheader.i
  %cell.2.0.i = phi i64 [ %cell.3.2.i, %B926.i ], [ %.1212, %B22.preheader.i ]
  %start.2.0.i = phi i64 [ %.13.i.i, %B926.i ], [ %.13.i25, %B22.preheader.i ]
  %.149.i = getelementptr inbounds i64, ptr %arg.carrier.3.4, i64 %cell.2.0.i
  %.150.i = load i64, ptr %.149.i, align 8, !noalias !221
  %.154.not.i = icmp sgt i64 %.150.i, %start.2.0.i
  br i1 %.154.not.i, label %B112.i, label %B62.i

B62.i:                                            ; preds = %B22.i, %B62.i
  %cell.4.1.i = phi i64 [ %.157.i, %B62.i ], [ %cell.2.0.i, %B22.i ]
  %.157.i = add i64 %cell.4.1.i, 1
  %sunkaddr15 = shl i64 %.157.i, 3
  %sunkaddr16 = getelementptr i8, ptr %arg.carrier.3.4, i64 %sunkaddr15
  %.170.i = load i64, ptr %sunkaddr16, align 8, !noalias !221
  %.172.not.i = icmp sgt i64 %.170.i, %start.2.0.i
  br i1 %.172.not.i, label %B112.i, label %B62.i

B112.i:                                           ; preds = %B62.i, %B22.i
  %cell.3.2.i = phi i64 [ %cell.2.0.i, %B22.i ], [ %.157.i, %B62.i ]
  %.184.i = getelementptr inbounds i64, ptr %arg.carrier.3.4, i64 %cell.3.2.i
  %.185.i = load i64, ptr %.184.i, align 8, !noalias !221
  %.13.i.i = tail call i64 @llvm.smin.i64(i64 %.13.i27, i64 %.185.i)
  %.395.i = sub i64 %.13.i.i, %start.2.0.i
  %15 = add i64 %.395.i, 7
  %.417.i = lshr i64 %15, 3
  %.396.inv.i = icmp slt i64 %.395.i, 1
  %.438305.not326.i = icmp eq i64 %.417.i, 0
  %.438305.not.i = or i1 %.396.inv.i, %.438305.not326.i
  br i1 %.438305.not.i, label %B926.i, label %B570.if.lr.ph.i

B926.i:                                           ; preds = %B570.if.i, %B112.i
  %.602.i = icmp slt i64 %.185.i, %.13.i27
  br i1 %.602.i, label %B22.i, label %_ZN17bnserve_surrogate6kernel7_points11two_splinesB4v364B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedExxd5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit

B570.if.lr.ph.i:                                  ; preds = %B112.i
  %.228.i43 = getelementptr inbounds double, ptr %.1102, i64 %cell.3.2.i
  %.229.i44 = load double, ptr %.228.i43, align 8, !noalias !221
  %.231.i = fsub contract double %.435, %.229.i44
  %.279.i = add nsw i64 %cell.3.2.i, %.277.i
  %.347.i = getelementptr inbounds double, ptr %arg.cubics.1.4, i64 %.279.i
  %.348.i = load double, ptr %.347.i, align 8, !noalias !221
  %.266.i45 = add nsw i64 %cell.3.2.i, %.264.i
  %.334.i = getelementptr inbounds double, ptr %arg.cubics.1.4, i64 %.266.i45
  %.335.i = load double, ptr %.334.i, align 8, !noalias !221
  %.247.i = add nsw i64 %cell.3.2.i, %arg.sizes.0
  %.315.i = getelementptr inbounds double, ptr %arg.cubics.1.4, i64 %.247.i
  %.316.i = load double, ptr %.315.i, align 8, !noalias !221
  %.303.i = getelementptr inbounds double, ptr %arg.cubics.1.4, i64 %cell.3.2.i
  %.304.i = load double, ptr %.303.i, align 8, !noalias !221
  %.287.i = getelementptr inbounds double, ptr %arg.cubics.0.4, i64 %.279.i
  %.288.i = load double, ptr %.287.i, align 8, !noalias !221
  %.274.i = getelementptr inbounds double, ptr %arg.cubics.0.4, i64 %.266.i45
  %.275.i = load double, ptr %.274.i, align 8, !noalias !221
  %.255.i = getelementptr inbounds double, ptr %arg.cubics.0.4, i64 %.247.i
  %.256.i = load double, ptr %.255.i, align 8, !noalias !221
  %.243.i = getelementptr inbounds double, ptr %arg.cubics.0.4, i64 %cell.3.2.i
  %.244.i = load double, ptr %.243.i, align 8, !noalias !221
  %.514.i = insertelement <8 x double> poison, double %.288.i, i64 0
  %.515.i = shufflevector <8 x double> %.514.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.517.i = insertelement <8 x double> poison, double %.275.i, i64 0
  %.518.i = shufflevector <8 x double> %.517.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.521.i = insertelement <8 x double> poison, double %.256.i, i64 0
  %.522.i = shufflevector <8 x double> %.521.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.525.i = insertelement <8 x double> poison, double %.244.i, i64 0
  %.526.i = shufflevector <8 x double> %.525.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.541.i = insertelement <8 x double> poison, double %.348.i, i64 0
  %.542.i = shufflevector <8 x double> %.541.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.544.i = insertelement <8 x double> poison, double %.335.i, i64 0
  %.545.i = shufflevector <8 x double> %.544.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.548.i = insertelement <8 x double> poison, double %.316.i, i64 0
  %.549.i = shufflevector <8 x double> %.548.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.552.i = insertelement <8 x double> poison, double %.304.i, i64 0
  %.553.i = shufflevector <8 x double> %.552.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.6.i.i46 = insertelement <8 x double> poison, double %.231.i, i64 0
  %.7.i.i47 = shufflevector <8 x double> %.6.i.i46, <8 x double> poison, <8 x i32> zeroinitializer
  %16 = shl i64 %start.2.0.i, 3
  %17 = add nuw nsw i64 %.417.i, 7
  br label %B570.if.i

B570.if.i:                                        ; preds = %B570.if.i, %B570.if.lr.ph.i
  %lsr.iv11 = phi i64 [ %lsr.iv.next12, %B570.if.i ], [ %17, %B570.if.lr.ph.i ]
  %lsr.iv8.i = phi i64 [ %lsr.iv.next9.i, %B570.if.i ], [ %16, %B570.if.lr.ph.i ]
  %scevgep13.i = getelementptr i8, ptr %.1235, i64 %lsr.iv8.i
  %.485.i = load <8 x double>, ptr %scevgep13.i, align 8, !noalias !221
  %.8.i.i48 = fadd contract <8 x double> %.7.i.i47, %.485.i
  %.519.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i.i48, <8 x double> %.515.i, <8 x double> %.518.i)
  %.523.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i.i48, <8 x double> %.519.i, <8 x double> %.522.i)
  %.527.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i.i48, <8 x double> %.523.i, <8 x double> %.526.i)
  %scevgep12.i = getelementptr i8, ptr %scevgep11.i, i64 %lsr.iv8.i
  store <8 x double> %.527.i, ptr %scevgep12.i, align 8, !noalias !221
  %.546.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i.i48, <8 x double> %.542.i, <8 x double> %.545.i)
  %.550.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i.i48, <8 x double> %.546.i, <8 x double> %.549.i)
  %.554.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i.i48, <8 x double> %.550.i, <8 x double> %.553.i)
  %scevgep10.i = getelementptr i8, ptr %scevgep7.i, i64 %lsr.iv8.i
  store <8 x double> %.554.i, ptr %scevgep10.i, align 8, !noalias !221
  %lsr.iv.next9.i = add i64 %lsr.iv8.i, 64
  %lsr.iv.next12 = add nsw i64 %lsr.iv11, -1
  %.438.i = icmp sgt i64 %lsr.iv11, 8
  br i1 %.438.i, label %B570.if.i, label %B926.i

_ZN17bnserve_surrogate6kernel7_points11two_splinesB4v364B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedExxd5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit: ; preds = %B926.i, %B480
  %cell.5.1.i = phi i64 [ %.1212, %B480 ], [ %cell.3.2.i, %B926.i ]
  store i64 %cell.5.1.i, ptr %.1211, align 8
  br label %B736

B484.if.i:                                        ; preds = %B484.if.i, %B1168
  %lsr.iv6 = phi i64 [ %lsr.iv.next7, %B484.if.i ], [ %5, %B1168 ]
  %lsr.iv9 = phi ptr [ %scevgep11, %B484.if.i ], [ %arg.p.4, %B1168 ]
  %lsr.iv = phi ptr [ %scevgep8, %B484.if.i ], [ %arg.phase.4, %B1168 ]
  %lsr.iv320 = phi ptr [ %scevgep321, %B484.if.i ], [ %.2159, %B1168 ]
  %scevgep324 = getelementptr i8, ptr %lsr.iv320, i64 %.idx1807
  %.1236.i = load <8 x double>, ptr %scevgep324, align 8, !noalias !215
  %.1246.i = load <8 x double>, ptr %lsr.iv320, align 8, !noalias !215
  %sunkaddr19 = getelementptr i8, ptr %lsr.iv320, i64 %sunkaddr18
  %.1256.i = load <8 x double>, ptr %sunkaddr19, align 8, !noalias !215
  %.6.i.i93 = fmul contract <8 x double> %.1236.i, %.1236.i
  %.1287.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i93, <8 x double> %.1283.i, <8 x double> %.1286.i)
  %.1291.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i93, <8 x double> %.1287.i, <8 x double> %.1290.i)
  %.1295.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i93, <8 x double> %.1291.i, <8 x double> %.1294.i)
  %.1302.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i93, <8 x double> %.1298.i, <8 x double> %.1301.i)
  %.1306.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i93, <8 x double> %.1302.i, <8 x double> %.1305.i)
  %.1310.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i93, <8 x double> %.1306.i, <8 x double> %.1309.i)
  %.1317.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i93, <8 x double> %.1313.i, <8 x double> %.1316.i)
  %.1321.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i93, <8 x double> %.1317.i, <8 x double> %.1320.i)
  %.1325.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i93, <8 x double> %.1321.i, <8 x double> %.1324.i)
  %.1332.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i93, <8 x double> %.1328.i, <8 x double> %.1331.i)
  %.1336.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i93, <8 x double> %.1332.i, <8 x double> %.1335.i)
  %.1340.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i93, <8 x double> %.1336.i, <8 x double> %.1339.i)
  %.1347.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i93, <8 x double> %.1343.i, <8 x double> %.1346.i)
  %.1351.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i93, <8 x double> %.1347.i, <8 x double> %.1350.i)
  %.1355.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i93, <8 x double> %.1351.i, <8 x double> %.1354.i)
  %.1362.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i93, <8 x double> %.1358.i, <8 x double> %.1361.i)
  %.1366.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i93, <8 x double> %.1362.i, <8 x double> %.1365.i)
  %.1367.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1236.i, <8 x double> %.1340.i, <8 x double> %.1325.i)
  %scevgep322 = getelementptr i8, ptr %lsr.iv320, i64 %.idx1808
  %.1377.i = load <8 x double>, ptr %scevgep322, align 8, !noalias !215
  %.6.i16.i = fmul contract <8 x double> %.1377.i, %.1367.i
  %.6.i17.i = fmul contract <8 x double> %.1246.i, %.1256.i
  %.1426.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1236.i, <8 x double> %.1366.i, <8 x double> %.1355.i)
  %.1430.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i17.i, <8 x double> %.1429.i, <8 x double> %.1426.i)
  %.1431.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1236.i, <8 x double> %.1310.i, <8 x double> %.1295.i)
  %.1441.i = load <8 x double>, ptr %lsr.iv9, align 8, !noalias !215
  %.1442.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1246.i, <8 x double> %.1431.i, <8 x double> %.1441.i)
  %.1443.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1256.i, <8 x double> %.1430.i, <8 x double> %.1442.i)
  %.6.i18.i = fadd contract <8 x double> %.6.i16.i, %.1443.i
  %.1450.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1246.i, <8 x double> %.1447.i, <8 x double> %.1449.i)
  %.6.i19.i = fsub contract <8 x double> %.1450.i, %.6.i18.i
  store <8 x double> %.6.i19.i, ptr %lsr.iv, align 8, !noalias !215
  %scevgep321 = getelementptr i8, ptr %lsr.iv320, i64 64
  %scevgep8 = getelementptr i8, ptr %lsr.iv, i64 64
  %scevgep11 = getelementptr i8, ptr %lsr.iv9, i64 64
  %lsr.iv.next7 = add nsw i64 %lsr.iv6, -1
  %.1189.i = icmp sgt i64 %lsr.iv6, 8
  br i1 %.1189.i, label %B484.if.i, label %B1270

B22.preheader.i117:                               ; preds = %B1272
  %.2988 = sub i64 %.13.i25, %arg.start
  %.3064 = getelementptr double, ptr %arg.phase.4, i64 %.2988
  %.2999 = getelementptr double, ptr %arg.amplitude.4, i64 %.2988
  %18 = mul i64 %.13.i25, -8
  %scevgep4.i = getelementptr i8, ptr %.3064, i64 %18
  %scevgep8.i = getelementptr i8, ptr %.2999, i64 %18
  br label %B22.i118

B22.i118:                                         ; preds = %B1344.i, %B22.preheader.i117
  %cell.2.0.i119 = phi i64 [ %cell.3.2.i125, %B1344.i ], [ %.3161, %B22.preheader.i117 ]
  %start.2.0.i120 = phi i64 [ %.13.i.i126, %B1344.i ], [ %.13.i25, %B22.preheader.i117 ]
  %.160.i = getelementptr inbounds i64, ptr %arg.carrier.3.4, i64 %cell.2.0.i119
  %.161.i = load i64, ptr %.160.i, align 8, !noalias !224
  %.165.not.i = icmp sgt i64 %.161.i, %start.2.0.i120
  br i1 %.165.not.i, label %B112.i124, label %B62.i121

B62.i121:                                         ; preds = %B22.i118, %B62.i121
  %cell.4.1.i122 = phi i64 [ %.168.i, %B62.i121 ], [ %cell.2.0.i119, %B22.i118 ]
  %.168.i = add i64 %cell.4.1.i122, 1
  %sunkaddr20 = shl i64 %.168.i, 3
  %sunkaddr21 = getelementptr i8, ptr %arg.carrier.3.4, i64 %sunkaddr20
  %.181.i = load i64, ptr %sunkaddr21, align 8, !noalias !224
  %.183.not.i = icmp sgt i64 %.181.i, %start.2.0.i120
  br i1 %.183.not.i, label %B112.i124, label %B62.i121

B112.i124:                                        ; preds = %B62.i121, %B22.i118
  %cell.3.2.i125 = phi i64 [ %cell.2.0.i119, %B22.i118 ], [ %.168.i, %B62.i121 ]
  %.195.i = getelementptr inbounds i64, ptr %arg.carrier.3.4, i64 %cell.3.2.i125
  %.196.i = load i64, ptr %.195.i, align 8, !noalias !224
  %.13.i.i126 = tail call i64 @llvm.smin.i64(i64 %.13.i27, i64 %.196.i)
  %.529.i = sub i64 %.13.i.i126, %start.2.0.i120
  %19 = add i64 %.529.i, 7
  %.551.i = lshr i64 %19, 3
  %.530.inv.i = icmp slt i64 %.529.i, 1
  %.573363.not375.i = icmp eq i64 %.551.i, 0
  %.573363.not.i = or i1 %.530.inv.i, %.573363.not375.i
  br i1 %.573363.not.i, label %B1344.i, label %B808.if.lr.ph.i

B1344.i:                                          ; preds = %B808.if.i, %B112.i124
  %.751.i = icmp slt i64 %.196.i, %.13.i27
  br i1 %.751.i, label %B22.i118, label %B1272.endif.endif.endif.endif.endif.endif

B808.if.lr.ph.i:                                  ; preds = %B112.i124
  %.261.i = shl nsw i64 %cell.3.2.i125, 3
  %20 = getelementptr double, ptr %arg.fitted.1.4, i64 %.261.i
  %.478.i = getelementptr i8, ptr %20, i64 48
  %.479.i = load double, ptr %.478.i, align 8, !noalias !224
  %.311.i = or disjoint i64 %.261.i, 5
  %.468.i = getelementptr inbounds double, ptr %arg.fitted.1.4, i64 %.311.i
  %.469.i = load double, ptr %.468.i, align 8, !noalias !224
  %.301.i = or disjoint i64 %.261.i, 4
  %.458.i = getelementptr inbounds double, ptr %arg.fitted.1.4, i64 %.301.i
  %.459.i = load double, ptr %.458.i, align 8, !noalias !224
  %.291.i = or disjoint i64 %.261.i, 3
  %.412.i = getelementptr inbounds double, ptr %arg.fitted.1.4, i64 %.291.i
  %.413.i = load double, ptr %.412.i, align 8, !noalias !224
  %.281.i = or disjoint i64 %.261.i, 2
  %.402.i = getelementptr inbounds double, ptr %arg.fitted.1.4, i64 %.281.i
  %.403.i = load double, ptr %.402.i, align 8, !noalias !224
  %.271.i = or disjoint i64 %.261.i, 1
  %.392.i = getelementptr inbounds double, ptr %arg.fitted.1.4, i64 %.271.i
  %.393.i = load double, ptr %.392.i, align 8, !noalias !224
  %.383.i = load double, ptr %20, align 8, !noalias !224
  %.319.i127 = getelementptr inbounds double, ptr %arg.fitted.0.4, i64 %.311.i
  %.320.i = load double, ptr %.319.i127, align 8, !noalias !224
  %.309.i = getelementptr inbounds double, ptr %arg.fitted.0.4, i64 %.301.i
  %.310.i = load double, ptr %.309.i, align 8, !noalias !224
  %.299.i = getelementptr inbounds double, ptr %arg.fitted.0.4, i64 %.291.i
  %.300.i = load double, ptr %.299.i, align 8, !noalias !224
  %.289.i = getelementptr inbounds double, ptr %arg.fitted.0.4, i64 %.281.i
  %.290.i = load double, ptr %.289.i, align 8, !noalias !224
  %.279.i128 = getelementptr inbounds double, ptr %arg.fitted.0.4, i64 %.271.i
  %.280.i = load double, ptr %.279.i128, align 8, !noalias !224
  %.269.i = getelementptr inbounds double, ptr %arg.fitted.0.4, i64 %.261.i
  %.270.i = load double, ptr %.269.i, align 8, !noalias !224
  %.251.i = getelementptr inbounds double, ptr %.2928, i64 %cell.3.2.i125
  %.252.i = load double, ptr %.251.i, align 8, !noalias !224
  %.253.i = fsub contract double 0.000000e+00, %.252.i
  %.239.i = getelementptr inbounds double, ptr %.2798, i64 %cell.3.2.i125
  %.240.i = load double, ptr %.239.i, align 8, !noalias !224
  %.242.i = fmul contract double %.405, %.240.i
  %.623.i = insertelement <8 x double> poison, double %.242.i, i64 0
  %.624.i = shufflevector <8 x double> %.623.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.625.i = insertelement <8 x double> poison, double %.253.i, i64 0
  %.626.i = shufflevector <8 x double> %.625.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.631.i = insertelement <8 x double> poison, double %.320.i, i64 0
  %.632.i = shufflevector <8 x double> %.631.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.634.i = insertelement <8 x double> poison, double %.310.i, i64 0
  %.635.i = shufflevector <8 x double> %.634.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.638.i = insertelement <8 x double> poison, double %.300.i, i64 0
  %.639.i = shufflevector <8 x double> %.638.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.642.i = insertelement <8 x double> poison, double %.290.i, i64 0
  %.643.i = shufflevector <8 x double> %.642.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.646.i = insertelement <8 x double> poison, double %.280.i, i64 0
  %.647.i129 = shufflevector <8 x double> %.646.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.650.i = insertelement <8 x double> poison, double %.270.i, i64 0
  %.651.i = shufflevector <8 x double> %.650.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.664.i = insertelement <8 x double> poison, double %.479.i, i64 0
  %.665.i = shufflevector <8 x double> %.664.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.667.i = insertelement <8 x double> poison, double %.469.i, i64 0
  %.668.i = shufflevector <8 x double> %.667.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.671.i = insertelement <8 x double> poison, double %.459.i, i64 0
  %.672.i = shufflevector <8 x double> %.671.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.675.i = insertelement <8 x double> poison, double %.413.i, i64 0
  %.676.i = shufflevector <8 x double> %.675.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.681.i = insertelement <8 x double> poison, double %.403.i, i64 0
  %.682.i = shufflevector <8 x double> %.681.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.685.i = insertelement <8 x double> poison, double %.393.i, i64 0
  %.686.i = shufflevector <8 x double> %.685.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.689.i = insertelement <8 x double> poison, double %.383.i, i64 0
  %.690.i = shufflevector <8 x double> %.689.i, <8 x double> poison, <8 x i32> zeroinitializer
  %21 = shl i64 %start.2.0.i120, 3
  %22 = add nuw nsw i64 %.551.i, 7
  br label %B808.if.i

B808.if.i:                                        ; preds = %B808.if.i, %B808.if.lr.ph.i
  %lsr.iv4 = phi i64 [ %lsr.iv.next5, %B808.if.i ], [ %22, %B808.if.lr.ph.i ]
  %lsr.iv5.i = phi i64 [ %lsr.iv.next6.i, %B808.if.i ], [ %21, %B808.if.lr.ph.i ]
  %scevgep10.i131 = getelementptr i8, ptr %arg.grid.4, i64 %lsr.iv5.i
  %.620.i = load <8 x double>, ptr %scevgep10.i131, align 8, !noalias !224
  %.627.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.620.i, <8 x double> %.624.i, <8 x double> %.626.i)
  %.636.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.627.i, <8 x double> %.632.i, <8 x double> %.635.i)
  %.640.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.627.i, <8 x double> %.636.i, <8 x double> %.639.i)
  %.644.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.627.i, <8 x double> %.640.i, <8 x double> %.643.i)
  %.648.i132 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.627.i, <8 x double> %.644.i, <8 x double> %.647.i129)
  %.652.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.627.i, <8 x double> %.648.i132, <8 x double> %.651.i)
  %scevgep9.i = getelementptr i8, ptr %scevgep8.i, i64 %lsr.iv5.i
  store <8 x double> %.652.i, ptr %scevgep9.i, align 8, !noalias !224
  %.669.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.627.i, <8 x double> %.665.i, <8 x double> %.668.i)
  %.673.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.627.i, <8 x double> %.669.i, <8 x double> %.672.i)
  %.677.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.627.i, <8 x double> %.673.i, <8 x double> %.676.i)
  %.683.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.627.i, <8 x double> %.677.i, <8 x double> %.682.i)
  %.687.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.627.i, <8 x double> %.683.i, <8 x double> %.686.i)
  %.691.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.627.i, <8 x double> %.687.i, <8 x double> %.690.i)
  %scevgep7.i133 = getelementptr i8, ptr %scevgep4.i, i64 %lsr.iv5.i
  store <8 x double> %.691.i, ptr %scevgep7.i133, align 8, !noalias !224
  %lsr.iv.next6.i = add i64 %lsr.iv5.i, 64
  %lsr.iv.next5 = add nsw i64 %lsr.iv4, -1
  %.573.i = icmp sgt i64 %lsr.iv4, 8
  br i1 %.573.i, label %B808.if.i, label %B1344.i

B1272.endif.endif.endif.endif.endif.endif:        ; preds = %B1344.i, %B1272
  %cell.5.1.i116 = phi i64 [ %.3161, %B1272 ], [ %cell.3.2.i125, %B1344.i ]
  store i64 %cell.5.1.i116, ptr %.3160, align 8
  br label %B1552

B76400.if:                                        ; preds = %B76400.if, %B76400.if.lr.ph
  %lsr.iv1 = phi i64 [ %lsr.iv.next, %B76400.if ], [ %10, %B76400.if.lr.ph ]
  %lsr.iv304 = phi i64 [ %lsr.iv.next305, %B76400.if ], [ %8, %B76400.if.lr.ph ]
  %scevgep307 = getelementptr i8, ptr %scevgep306, i64 %lsr.iv304
  %.3749 = load <8 x double>, ptr %scevgep307, align 8
  %.6.i = fmul contract <8 x double> %.3752, %.3749
  %.6.i135 = fmul contract <8 x double> %.3749, %.6.i
  %scevgep311 = getelementptr i8, ptr %scevgep310, i64 %lsr.iv304
  store <8 x double> %.6.i135, ptr %scevgep311, align 8
  %scevgep = getelementptr i8, ptr %arg.grid.4, i64 %lsr.iv304
  %.3822 = load <8 x double>, ptr %scevgep, align 8
  %.3833 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.3822, <8 x double> %.3832, <8 x double> %.3830)
  %scevgep309 = getelementptr i8, ptr %scevgep308, i64 %lsr.iv304
  store <8 x double> %.3833, ptr %scevgep309, align 8
  %lsr.iv.next305 = add i64 %lsr.iv304, 64
  %lsr.iv.next = add nsw i64 %lsr.iv1, -1
  %.3697 = icmp sgt i64 %lsr.iv1, 7
  br i1 %.3697, label %B76400.if, label %B76706
}

; Function Attrs: nofree noinline norecurse nosync nounwind memory(readwrite, inaccessiblemem: none, target_mem0: none, target_mem1: none)
define internal fastcc void @inner_27(ptr noalias nonnull writeonly captures(none) initializes((0, 8)) %retptr, i64 %arg.place, i64 %arg.start, i64 %arg.stop, ptr readonly captures(none) %arg.arguments.4, i64 %arg.count, ptr readonly captures(none) %arg.real.4, ptr readonly captures(none) %arg.imaginary.4, ptr captures(none) %arg.tail.4) unnamed_addr #4 {
entry:
  %.344 = alloca ptr, align 8
  store ptr null, ptr %.344, align 8
  %.499 = alloca ptr, align 8
  store ptr null, ptr %.499, align 8
  %.94 = getelementptr i8, ptr %arg.arguments.4, i64 16
  %.95 = load i64, ptr %.94, align 8
  %.124 = getelementptr i8, ptr %arg.arguments.4, i64 120
  %.125 = load i64, ptr %.124, align 8
  %.129 = mul nsw i64 %.95, %arg.place
  %.130 = add nsw i64 %.129, %arg.start
  %.131 = sub nsw i64 %arg.stop, %arg.start
  %.132 = shl nsw i64 %.131, 1
  %.167 = getelementptr i8, ptr %arg.arguments.4, i64 112
  %.168 = load i64, ptr %.167, align 8
  %.169 = icmp eq i64 %.168, 1
  %.65.i = load i64, ptr %arg.arguments.4, align 8, !noalias !227
  %.98.i = mul nsw i64 %.65.i, %.95
  br i1 %.169, label %B172, label %B356

B172:                                             ; preds = %entry
  %.173 = shl nsw i64 %.130, 3
  %.175 = add nsw i64 %.173, %.125
  %.120.i = icmp sgt i64 %.98.i, 524287
  %.209.1.i = and i64 %.125, 7
  %.239.not.i = icmp eq i64 %.209.1.i, 0
  %or.cond.i = select i1 %.120.i, i1 %.239.not.i, i1 false
  %.250.i = sub i64 0, %.175
  %.263.1.i = lshr exact i64 %.250.i, 3
  %.312.i = and i64 %.263.1.i, 7
  %storemerge.i = select i1 %or.cond.i, i64 %.312.i, i64 -1
  %.223 = inttoptr i64 %.175 to ptr
  store ptr null, ptr %.344, align 8
  call fastcc void @inner_30(ptr nonnull %.344, i64 %arg.count, ptr %arg.real.4, ptr %arg.imaginary.4, i64 %storemerge.i, ptr %.223, i64 %.132, ptr %arg.tail.4)
  br label %common.ret.sink.split

B356:                                             ; preds = %entry
  %.398 = shl nsw i64 %.130, 4
  %.400 = add nsw i64 %.398, %.125
  %.120.i5 = icmp sgt i64 %.98.i, 262143
  %.209.1.i6 = and i64 %.125, 15
  %.239.not.i7 = icmp eq i64 %.209.1.i6, 0
  %or.cond.i8 = select i1 %.120.i5, i1 %.239.not.i7, i1 false
  %.250.i9 = sub i64 0, %.400
  %.263.1.i10 = lshr exact i64 %.250.i9, 4
  %.312.i11 = and i64 %.263.1.i10, 3
  %storemerge.i12 = select i1 %or.cond.i8, i64 %.312.i11, i64 -1
  %.447 = inttoptr i64 %.400 to ptr
  store ptr null, ptr %.499, align 8
  call fastcc void @inner_31(ptr nonnull %.499, i64 %arg.count, ptr %arg.real.4, ptr %arg.imaginary.4, i64 %storemerge.i12, ptr %.447, i64 %.132, ptr %arg.tail.4)
  br label %common.ret.sink.split

common.ret.sink.split:                            ; preds = %B356, %B172
  store ptr null, ptr %retptr, align 8
  ret void
}

; Function Attrs: nofree noinline norecurse nosync nounwind memory(argmem: readwrite)
define internal fastcc void @inner_30(ptr noalias nonnull writeonly captures(none) %retptr, i64 %arg.count, ptr readonly captures(none) %arg.real.4, ptr readonly captures(none) %arg.imaginary.4, i64 range(i64 -1, 8) %arg.streamed, ptr writeonly captures(none) %arg.out.4, i64 range(i64 -9223372036854775808, 9223372036854775807) %arg.out.5.0, ptr captures(none) %arg.tail.4) unnamed_addr #6 {
entry:
  %.70 = icmp sgt i64 %arg.count, 0
  br i1 %.70, label %B20.preheader, label %B78264

B20.preheader:                                    ; preds = %entry
  %0 = shl i64 %arg.out.5.0, 2
  %1 = icmp sgt i64 %arg.streamed, -1
  %sunkaddr4 = getelementptr i8, ptr %arg.tail.4, i64 4
  %sunkaddr20 = getelementptr i8, ptr %arg.tail.4, i64 8
  %sunkaddr21 = getelementptr i8, ptr %arg.tail.4, i64 12
  %sunkaddr22 = getelementptr i8, ptr %arg.tail.4, i64 16
  %sunkaddr23 = getelementptr i8, ptr %arg.tail.4, i64 20
  %sunkaddr24 = getelementptr i8, ptr %arg.tail.4, i64 24
  %sunkaddr = getelementptr i8, ptr %arg.tail.4, i64 28
  %sunkaddr25 = getelementptr i8, ptr %arg.tail.4, i64 32
  %sunkaddr26 = getelementptr i8, ptr %arg.tail.4, i64 36
  %sunkaddr27 = getelementptr i8, ptr %arg.tail.4, i64 40
  %sunkaddr28 = getelementptr i8, ptr %arg.tail.4, i64 44
  %sunkaddr29 = getelementptr i8, ptr %arg.tail.4, i64 48
  %sunkaddr30 = getelementptr i8, ptr %arg.tail.4, i64 52
  br label %B20

B20:                                              ; preds = %B78260, %B20.preheader
  %j.2.0 = phi i64 [ %.516, %B78260 ], [ 0, %B20.preheader ]
  %.77 = sub nsw i64 %arg.count, %j.2.0
  %.13.i = tail call i64 @llvm.smin.i64(i64 %.77, i64 8)
  %.117 = icmp slt i64 %j.2.0, %arg.streamed
  %.13.i3 = tail call i64 @llvm.smin.i64(i64 %arg.streamed, i64 %.13.i)
  %size.2.1 = select i1 %.117, i64 %.13.i3, i64 %.13.i
  %.165 = getelementptr inbounds double, ptr %arg.real.4, i64 %j.2.0
  %.167 = load <8 x double>, ptr %.165, align 8
  %.176 = getelementptr inbounds double, ptr %arg.imaginary.4, i64 %j.2.0
  %.178 = load <8 x double>, ptr %.176, align 8
  %.218 = icmp slt i64 %size.2.1, 8
  %2 = shufflevector <8 x double> %.167, <8 x double> %.178, <16 x i32> <i32 0, i32 8, i32 1, i32 9, i32 2, i32 10, i32 3, i32 11, i32 4, i32 12, i32 5, i32 13, i32 6, i32 14, i32 7, i32 15>
  %.235 = fptrunc <16 x double> %2 to <16 x float>
  br i1 %.218, label %B232, label %B78148

B232:                                             ; preds = %B20
  store <16 x float> %.235, ptr %arg.tail.4, align 4
  %.325319.not = icmp slt i64 %size.2.1, 1
  br i1 %.325319.not, label %B78260, label %B292.if.lr.ph

B292.if.lr.ph:                                    ; preds = %B232
  %.394 = shl nsw i64 %j.2.0, 1
  %3 = shl i64 %j.2.0, 3
  %scevgep23 = getelementptr i8, ptr %arg.out.4, i64 %3
  %.392 = load float, ptr %arg.tail.4, align 4
  %.409 = icmp slt i64 %j.2.0, 0
  %4 = select i1 %.409, i64 %0, i64 0
  %scevgep27 = getelementptr i8, ptr %scevgep23, i64 %4
  store float %.392, ptr %scevgep27, align 4
  %.392.1 = load float, ptr %sunkaddr4, align 4
  %scevgep26 = getelementptr i8, ptr %scevgep27, i64 4
  store float %.392.1, ptr %scevgep26, align 4
  %exitcond.not.1 = icmp eq i64 %size.2.1, 1
  br i1 %exitcond.not.1, label %B78260, label %B292.if.1

B78148:                                           ; preds = %B20
  %sunkaddr5 = shl i64 %j.2.0, 3
  %sunkaddr6 = getelementptr i8, ptr %arg.out.4, i64 %sunkaddr5
  br i1 %1, label %B78220, label %B78222

B78220:                                           ; preds = %B78148
  store <16 x float> %.235, ptr %sunkaddr6, align 64, !nontemporal !141
  br label %B78260

B78222:                                           ; preds = %B78148
  store <16 x float> %.235, ptr %sunkaddr6, align 4
  br label %B78260

B78260:                                           ; preds = %B232, %B292.if.lr.ph, %B292.if.1, %B292.if.2, %B292.if.3, %B292.if.4, %B292.if.5, %B292.if.6, %B78222, %B78220
  %.516 = add nsw i64 %size.2.1, %j.2.0
  %.522 = icmp slt i64 %.516, %arg.count
  br i1 %.522, label %B20, label %B78264

B78264:                                           ; preds = %B78260, %entry
  %.549 = shl nsw i64 %arg.count, 1
  %.599 = sub i64 %arg.out.5.0, %.549
  %.642333.not = icmp slt i64 %.599, 1
  br i1 %.642333.not, label %B78317, label %B78276.if.preheader

B78276.if.preheader:                              ; preds = %B78264
  %xtraiter = and i64 %.599, 3
  %lcmp.mod.not = icmp eq i64 %xtraiter, 0
  br i1 %lcmp.mod.not, label %B78276.if.prol.loopexit, label %B78276.if.prol.preheader

B78276.if.prol.preheader:                         ; preds = %B78276.if.preheader
  %5 = shl i64 %arg.out.5.0, 2
  br label %B78276.if.prol

B78276.if.prol:                                   ; preds = %B78276.if.prol, %B78276.if.prol.preheader
  %lsr.iv17 = phi i64 [ %lsr.iv.next18, %B78276.if.prol ], [ %xtraiter, %B78276.if.prol.preheader ]
  %.648332334.prol = phi i64 [ %.655.prol, %B78276.if.prol ], [ %.549, %B78276.if.prol.preheader ]
  %.655.prol = add i64 %.648332334.prol, 1
  %.693.prol = icmp slt i64 %.648332334.prol, 0
  %6 = select i1 %.693.prol, i64 %5, i64 0
  %scevgep15 = getelementptr i8, ptr %arg.out.4, i64 %6
  %7 = shl i64 %.648332334.prol, 2
  %scevgep16 = getelementptr i8, ptr %scevgep15, i64 %7
  store float 0.000000e+00, ptr %scevgep16, align 4
  %lsr.iv.next18 = add nsw i64 %lsr.iv17, -1
  %prol.iter.cmp.not = icmp eq i64 %lsr.iv.next18, 0
  br i1 %prol.iter.cmp.not, label %B78276.if.prol.loopexit.loopexit, label %B78276.if.prol, !llvm.loop !228

B78276.if.prol.loopexit.loopexit:                 ; preds = %B78276.if.prol
  %8 = sub i64 %arg.out.5.0, %.655.prol
  br label %B78276.if.prol.loopexit

B78276.if.prol.loopexit:                          ; preds = %B78276.if.prol.loopexit.loopexit, %B78276.if.preheader
  %.641331335.unr = phi i64 [ %.599, %B78276.if.preheader ], [ %8, %B78276.if.prol.loopexit.loopexit ]
  %.648332334.unr = phi i64 [ %.549, %B78276.if.preheader ], [ %.655.prol, %B78276.if.prol.loopexit.loopexit ]
  %9 = sub i64 %.549, %arg.out.5.0
  %10 = icmp ugt i64 %9, -4
  br i1 %10, label %B78317, label %B78276.if.preheader4

B78276.if.preheader4:                             ; preds = %B78276.if.prol.loopexit
  %11 = add i64 %.641331335.unr, 4
  %12 = shl i64 %arg.out.5.0, 2
  %13 = add i64 %12, 4
  %14 = add i64 %12, 8
  %15 = add i64 %12, 12
  %16 = shl i64 %.648332334.unr, 2
  %scevgep = getelementptr i8, ptr %arg.out.4, i64 %16
  br label %B78276.if

B78317:                                           ; preds = %B78276.if, %B78276.if.prol.loopexit, %B78264
  store ptr null, ptr %retptr, align 8
  ret void

B292.if.1:                                        ; preds = %B292.if.lr.ph
  %.392.11 = load float, ptr %sunkaddr20, align 4
  %17 = add i64 %.394, 2
  %.409.1 = icmp slt i64 %17, 0
  %18 = select i1 %.409.1, i64 %0, i64 0
  %scevgep27.1 = getelementptr i8, ptr %scevgep23, i64 %18
  %scevgep28.1 = getelementptr i8, ptr %scevgep27.1, i64 8
  store float %.392.11, ptr %scevgep28.1, align 4
  %.392.1.1 = load float, ptr %sunkaddr21, align 4
  %scevgep26.1 = getelementptr i8, ptr %scevgep27.1, i64 12
  store float %.392.1.1, ptr %scevgep26.1, align 4
  %exitcond.not.1.1 = icmp eq i64 %size.2.1, 2
  br i1 %exitcond.not.1.1, label %B78260, label %B292.if.2

B292.if.2:                                        ; preds = %B292.if.1
  %.392.2 = load float, ptr %sunkaddr22, align 4
  %19 = add i64 %.394, 4
  %.409.2 = icmp slt i64 %19, 0
  %20 = select i1 %.409.2, i64 %0, i64 0
  %scevgep27.2 = getelementptr i8, ptr %scevgep23, i64 %20
  %scevgep28.2 = getelementptr i8, ptr %scevgep27.2, i64 16
  store float %.392.2, ptr %scevgep28.2, align 4
  %.392.1.2 = load float, ptr %sunkaddr23, align 4
  %scevgep26.2 = getelementptr i8, ptr %scevgep27.2, i64 20
  store float %.392.1.2, ptr %scevgep26.2, align 4
  %exitcond.not.1.2 = icmp eq i64 %size.2.1, 3
  br i1 %exitcond.not.1.2, label %B78260, label %B292.if.3

B292.if.3:                                        ; preds = %B292.if.2
  %.392.3 = load float, ptr %sunkaddr24, align 4
  %21 = add i64 %.394, 6
  %.409.3 = icmp slt i64 %21, 0
  %22 = select i1 %.409.3, i64 %0, i64 0
  %scevgep27.3 = getelementptr i8, ptr %scevgep23, i64 %22
  %scevgep28.3 = getelementptr i8, ptr %scevgep27.3, i64 24
  store float %.392.3, ptr %scevgep28.3, align 4
  %.392.1.3 = load float, ptr %sunkaddr, align 4
  %scevgep26.3 = getelementptr i8, ptr %scevgep27.3, i64 28
  store float %.392.1.3, ptr %scevgep26.3, align 4
  %exitcond.not.1.3 = icmp eq i64 %size.2.1, 4
  br i1 %exitcond.not.1.3, label %B78260, label %B292.if.4

B292.if.4:                                        ; preds = %B292.if.3
  %.392.4 = load float, ptr %sunkaddr25, align 4
  %23 = add i64 %.394, 8
  %.409.4 = icmp slt i64 %23, 0
  %24 = select i1 %.409.4, i64 %0, i64 0
  %scevgep27.4 = getelementptr i8, ptr %scevgep23, i64 %24
  %scevgep28.4 = getelementptr i8, ptr %scevgep27.4, i64 32
  store float %.392.4, ptr %scevgep28.4, align 4
  %.392.1.4 = load float, ptr %sunkaddr26, align 4
  %scevgep26.4 = getelementptr i8, ptr %scevgep27.4, i64 36
  store float %.392.1.4, ptr %scevgep26.4, align 4
  %exitcond.not.1.4 = icmp eq i64 %size.2.1, 5
  br i1 %exitcond.not.1.4, label %B78260, label %B292.if.5

B292.if.5:                                        ; preds = %B292.if.4
  %.392.5 = load float, ptr %sunkaddr27, align 4
  %25 = add i64 %.394, 10
  %.409.5 = icmp slt i64 %25, 0
  %26 = select i1 %.409.5, i64 %0, i64 0
  %scevgep27.5 = getelementptr i8, ptr %scevgep23, i64 %26
  %scevgep28.5 = getelementptr i8, ptr %scevgep27.5, i64 40
  store float %.392.5, ptr %scevgep28.5, align 4
  %.392.1.5 = load float, ptr %sunkaddr28, align 4
  %scevgep26.5 = getelementptr i8, ptr %scevgep27.5, i64 44
  store float %.392.1.5, ptr %scevgep26.5, align 4
  %exitcond.not.1.5 = icmp eq i64 %size.2.1, 6
  br i1 %exitcond.not.1.5, label %B78260, label %B292.if.6

B292.if.6:                                        ; preds = %B292.if.5
  %.392.6 = load float, ptr %sunkaddr29, align 4
  %27 = add i64 %.394, 12
  %.409.6 = icmp slt i64 %27, 0
  %28 = select i1 %.409.6, i64 %0, i64 0
  %scevgep27.6 = getelementptr i8, ptr %scevgep23, i64 %28
  %scevgep28.6 = getelementptr i8, ptr %scevgep27.6, i64 48
  store float %.392.6, ptr %scevgep28.6, align 4
  %.392.1.6 = load float, ptr %sunkaddr30, align 4
  %scevgep26.6 = getelementptr i8, ptr %scevgep27.6, i64 52
  store float %.392.1.6, ptr %scevgep26.6, align 4
  br label %B78260

B78276.if:                                        ; preds = %B78276.if, %B78276.if.preheader4
  %lsr.iv1 = phi ptr [ %scevgep5, %B78276.if ], [ %scevgep, %B78276.if.preheader4 ]
  %lsr.iv = phi i64 [ %lsr.iv.next, %B78276.if ], [ %11, %B78276.if.preheader4 ]
  %.648332334 = phi i64 [ %36, %B78276.if ], [ %.648332334.unr, %B78276.if.preheader4 ]
  %.693 = icmp slt i64 %.648332334, 0
  %29 = select i1 %.693, i64 %12, i64 0
  %scevgep9 = getelementptr i8, ptr %lsr.iv1, i64 %29
  store float 0.000000e+00, ptr %scevgep9, align 4
  %30 = add i64 %.648332334, 1
  %.693.1 = icmp slt i64 %30, 0
  %31 = select i1 %.693.1, i64 %13, i64 4
  %scevgep8 = getelementptr i8, ptr %lsr.iv1, i64 %31
  store float 0.000000e+00, ptr %scevgep8, align 4
  %32 = add i64 %.648332334, 2
  %.693.2 = icmp slt i64 %32, 0
  %33 = select i1 %.693.2, i64 %14, i64 8
  %scevgep7 = getelementptr i8, ptr %lsr.iv1, i64 %33
  store float 0.000000e+00, ptr %scevgep7, align 4
  %34 = add i64 %.648332334, 3
  %.693.3 = icmp slt i64 %34, 0
  %35 = select i1 %.693.3, i64 %15, i64 12
  %scevgep6 = getelementptr i8, ptr %lsr.iv1, i64 %35
  store float 0.000000e+00, ptr %scevgep6, align 4
  %lsr.iv.next = add i64 %lsr.iv, -4
  %scevgep5 = getelementptr i8, ptr %lsr.iv1, i64 16
  %.642.3 = icmp sgt i64 %lsr.iv.next, 4
  %36 = add i64 %.648332334, 4
  br i1 %.642.3, label %B78276.if, label %B78317
}

; Function Attrs: nofree noinline norecurse nosync nounwind memory(argmem: readwrite)
define internal fastcc void @inner_31(ptr noalias nonnull writeonly captures(none) %retptr, i64 %arg.count, ptr readonly captures(none) %arg.real.4, ptr readonly captures(none) %arg.imaginary.4, i64 range(i64 -1, 8) %arg.streamed, ptr writeonly captures(none) %arg.out.4, i64 range(i64 -9223372036854775808, 9223372036854775807) %arg.out.5.0, ptr captures(none) %arg.tail.4) unnamed_addr #6 {
entry:
  %.70 = icmp sgt i64 %arg.count, 0
  br i1 %.70, label %B20.preheader, label %B78461

B20.preheader:                                    ; preds = %entry
  %0 = shl i64 %arg.out.5.0, 3
  %1 = icmp sgt i64 %arg.streamed, -1
  %sunkaddr3 = getelementptr i8, ptr %arg.tail.4, i64 8
  %sunkaddr17 = getelementptr i8, ptr %arg.tail.4, i64 16
  %sunkaddr18 = getelementptr i8, ptr %arg.tail.4, i64 24
  %sunkaddr19 = getelementptr i8, ptr %arg.tail.4, i64 32
  %sunkaddr20 = getelementptr i8, ptr %arg.tail.4, i64 40
  %sunkaddr21 = getelementptr i8, ptr %arg.tail.4, i64 48
  %sunkaddr = getelementptr i8, ptr %arg.tail.4, i64 56
  %sunkaddr22 = getelementptr i8, ptr %arg.tail.4, i64 64
  %sunkaddr23 = getelementptr i8, ptr %arg.tail.4, i64 72
  %sunkaddr24 = getelementptr i8, ptr %arg.tail.4, i64 80
  %sunkaddr25 = getelementptr i8, ptr %arg.tail.4, i64 88
  %sunkaddr26 = getelementptr i8, ptr %arg.tail.4, i64 96
  %sunkaddr27 = getelementptr i8, ptr %arg.tail.4, i64 104
  br label %B20

B20:                                              ; preds = %B78457, %B20.preheader
  %j.2.0 = phi i64 [ %.510, %B78457 ], [ 0, %B20.preheader ]
  %.77 = sub nsw i64 %arg.count, %j.2.0
  %.13.i = tail call i64 @llvm.smin.i64(i64 %.77, i64 8)
  %.117 = icmp slt i64 %j.2.0, %arg.streamed
  %.13.i3 = tail call i64 @llvm.smin.i64(i64 %arg.streamed, i64 %.13.i)
  %size.2.1 = select i1 %.117, i64 %.13.i3, i64 %.13.i
  %.165 = getelementptr inbounds double, ptr %arg.real.4, i64 %j.2.0
  %.167 = load <8 x double>, ptr %.165, align 8
  %.176 = getelementptr inbounds double, ptr %arg.imaginary.4, i64 %j.2.0
  %.178 = load <8 x double>, ptr %.176, align 8
  %.218 = icmp slt i64 %size.2.1, 8
  br i1 %.218, label %B232, label %B78345

B232:                                             ; preds = %B20
  %.233 = shufflevector <8 x double> %.167, <8 x double> %.178, <16 x i32> <i32 0, i32 8, i32 1, i32 9, i32 2, i32 10, i32 3, i32 11, i32 4, i32 12, i32 5, i32 13, i32 6, i32 14, i32 7, i32 15>
  store <16 x double> %.233, ptr %arg.tail.4, align 4
  %.323319.not = icmp slt i64 %size.2.1, 1
  br i1 %.323319.not, label %B78457, label %B292.if.lr.ph

B292.if.lr.ph:                                    ; preds = %B232
  %.392 = shl nsw i64 %j.2.0, 1
  %2 = shl i64 %j.2.0, 4
  %scevgep23 = getelementptr i8, ptr %arg.out.4, i64 %2
  %.390 = load double, ptr %arg.tail.4, align 8
  %.407 = icmp slt i64 %j.2.0, 0
  %3 = select i1 %.407, i64 %0, i64 0
  %scevgep27 = getelementptr i8, ptr %scevgep23, i64 %3
  store double %.390, ptr %scevgep27, align 8
  %.390.1 = load double, ptr %sunkaddr3, align 8
  %scevgep26 = getelementptr i8, ptr %scevgep27, i64 8
  store double %.390.1, ptr %scevgep26, align 8
  %exitcond.not.1 = icmp eq i64 %size.2.1, 1
  br i1 %exitcond.not.1, label %B78457, label %B292.if.1

B78345:                                           ; preds = %B20
  %.465.idx = shl i64 %j.2.0, 4
  %.466 = shufflevector <8 x double> %.167, <8 x double> %.178, <16 x i32> <i32 0, i32 8, i32 1, i32 9, i32 2, i32 10, i32 3, i32 11, i32 4, i32 12, i32 5, i32 13, i32 6, i32 14, i32 7, i32 15>
  %sunkaddr15 = getelementptr i8, ptr %arg.out.4, i64 %.465.idx
  br i1 %1, label %B78417, label %B78419

B78417:                                           ; preds = %B78345
  store <16 x double> %.466, ptr %sunkaddr15, align 64, !nontemporal !141
  br label %B78457

B78419:                                           ; preds = %B78345
  store <16 x double> %.466, ptr %sunkaddr15, align 4
  br label %B78457

B78457:                                           ; preds = %B232, %B292.if.lr.ph, %B292.if.1, %B292.if.2, %B292.if.3, %B292.if.4, %B292.if.5, %B292.if.6, %B78419, %B78417
  %.510 = add nsw i64 %size.2.1, %j.2.0
  %.516 = icmp slt i64 %.510, %arg.count
  br i1 %.516, label %B20, label %B78461

B78461:                                           ; preds = %B78457, %entry
  %.543 = shl nsw i64 %arg.count, 1
  %.593 = sub i64 %arg.out.5.0, %.543
  %.636333.not = icmp slt i64 %.593, 1
  br i1 %.636333.not, label %B78514, label %B78473.if.preheader

B78473.if.preheader:                              ; preds = %B78461
  %xtraiter = and i64 %.593, 3
  %lcmp.mod.not = icmp eq i64 %xtraiter, 0
  br i1 %lcmp.mod.not, label %B78473.if.prol.loopexit, label %B78473.if.prol.preheader

B78473.if.prol.preheader:                         ; preds = %B78473.if.preheader
  %4 = shl i64 %arg.out.5.0, 3
  br label %B78473.if.prol

B78473.if.prol:                                   ; preds = %B78473.if.prol, %B78473.if.prol.preheader
  %lsr.iv17 = phi i64 [ %lsr.iv.next18, %B78473.if.prol ], [ %xtraiter, %B78473.if.prol.preheader ]
  %.642332334.prol = phi i64 [ %.649.prol, %B78473.if.prol ], [ %.543, %B78473.if.prol.preheader ]
  %.649.prol = add i64 %.642332334.prol, 1
  %.687.prol = icmp slt i64 %.642332334.prol, 0
  %5 = select i1 %.687.prol, i64 %4, i64 0
  %scevgep15 = getelementptr i8, ptr %arg.out.4, i64 %5
  %6 = shl i64 %.642332334.prol, 3
  %scevgep16 = getelementptr i8, ptr %scevgep15, i64 %6
  store double 0.000000e+00, ptr %scevgep16, align 8
  %lsr.iv.next18 = add nsw i64 %lsr.iv17, -1
  %prol.iter.cmp.not = icmp eq i64 %lsr.iv.next18, 0
  br i1 %prol.iter.cmp.not, label %B78473.if.prol.loopexit.loopexit, label %B78473.if.prol, !llvm.loop !229

B78473.if.prol.loopexit.loopexit:                 ; preds = %B78473.if.prol
  %7 = sub i64 %arg.out.5.0, %.649.prol
  br label %B78473.if.prol.loopexit

B78473.if.prol.loopexit:                          ; preds = %B78473.if.prol.loopexit.loopexit, %B78473.if.preheader
  %.635331335.unr = phi i64 [ %.593, %B78473.if.preheader ], [ %7, %B78473.if.prol.loopexit.loopexit ]
  %.642332334.unr = phi i64 [ %.543, %B78473.if.preheader ], [ %.649.prol, %B78473.if.prol.loopexit.loopexit ]
  %8 = sub i64 %.543, %arg.out.5.0
  %9 = icmp ugt i64 %8, -4
  br i1 %9, label %B78514, label %B78473.if.preheader4

B78473.if.preheader4:                             ; preds = %B78473.if.prol.loopexit
  %10 = add i64 %.635331335.unr, 4
  %11 = shl i64 %arg.out.5.0, 3
  %12 = add i64 %11, 8
  %13 = add i64 %11, 16
  %14 = add i64 %11, 24
  %15 = shl i64 %.642332334.unr, 3
  %scevgep = getelementptr i8, ptr %arg.out.4, i64 %15
  br label %B78473.if

B78514:                                           ; preds = %B78473.if, %B78473.if.prol.loopexit, %B78461
  store ptr null, ptr %retptr, align 8
  ret void

B292.if.1:                                        ; preds = %B292.if.lr.ph
  %.390.11 = load double, ptr %sunkaddr17, align 8
  %16 = add i64 %.392, 2
  %.407.1 = icmp slt i64 %16, 0
  %17 = select i1 %.407.1, i64 %0, i64 0
  %scevgep27.1 = getelementptr i8, ptr %scevgep23, i64 %17
  %scevgep28.1 = getelementptr i8, ptr %scevgep27.1, i64 16
  store double %.390.11, ptr %scevgep28.1, align 8
  %.390.1.1 = load double, ptr %sunkaddr18, align 8
  %scevgep26.1 = getelementptr i8, ptr %scevgep27.1, i64 24
  store double %.390.1.1, ptr %scevgep26.1, align 8
  %exitcond.not.1.1 = icmp eq i64 %size.2.1, 2
  br i1 %exitcond.not.1.1, label %B78457, label %B292.if.2

B292.if.2:                                        ; preds = %B292.if.1
  %.390.2 = load double, ptr %sunkaddr19, align 8
  %18 = add i64 %.392, 4
  %.407.2 = icmp slt i64 %18, 0
  %19 = select i1 %.407.2, i64 %0, i64 0
  %scevgep27.2 = getelementptr i8, ptr %scevgep23, i64 %19
  %scevgep28.2 = getelementptr i8, ptr %scevgep27.2, i64 32
  store double %.390.2, ptr %scevgep28.2, align 8
  %.390.1.2 = load double, ptr %sunkaddr20, align 8
  %scevgep26.2 = getelementptr i8, ptr %scevgep27.2, i64 40
  store double %.390.1.2, ptr %scevgep26.2, align 8
  %exitcond.not.1.2 = icmp eq i64 %size.2.1, 3
  br i1 %exitcond.not.1.2, label %B78457, label %B292.if.3

B292.if.3:                                        ; preds = %B292.if.2
  %.390.3 = load double, ptr %sunkaddr21, align 8
  %20 = add i64 %.392, 6
  %.407.3 = icmp slt i64 %20, 0
  %21 = select i1 %.407.3, i64 %0, i64 0
  %scevgep27.3 = getelementptr i8, ptr %scevgep23, i64 %21
  %scevgep28.3 = getelementptr i8, ptr %scevgep27.3, i64 48
  store double %.390.3, ptr %scevgep28.3, align 8
  %.390.1.3 = load double, ptr %sunkaddr, align 8
  %scevgep26.3 = getelementptr i8, ptr %scevgep27.3, i64 56
  store double %.390.1.3, ptr %scevgep26.3, align 8
  %exitcond.not.1.3 = icmp eq i64 %size.2.1, 4
  br i1 %exitcond.not.1.3, label %B78457, label %B292.if.4

B292.if.4:                                        ; preds = %B292.if.3
  %.390.4 = load double, ptr %sunkaddr22, align 8
  %22 = add i64 %.392, 8
  %.407.4 = icmp slt i64 %22, 0
  %23 = select i1 %.407.4, i64 %0, i64 0
  %scevgep27.4 = getelementptr i8, ptr %scevgep23, i64 %23
  %scevgep28.4 = getelementptr i8, ptr %scevgep27.4, i64 64
  store double %.390.4, ptr %scevgep28.4, align 8
  %.390.1.4 = load double, ptr %sunkaddr23, align 8
  %scevgep26.4 = getelementptr i8, ptr %scevgep27.4, i64 72
  store double %.390.1.4, ptr %scevgep26.4, align 8
  %exitcond.not.1.4 = icmp eq i64 %size.2.1, 5
  br i1 %exitcond.not.1.4, label %B78457, label %B292.if.5

B292.if.5:                                        ; preds = %B292.if.4
  %.390.5 = load double, ptr %sunkaddr24, align 8
  %24 = add i64 %.392, 10
  %.407.5 = icmp slt i64 %24, 0
  %25 = select i1 %.407.5, i64 %0, i64 0
  %scevgep27.5 = getelementptr i8, ptr %scevgep23, i64 %25
  %scevgep28.5 = getelementptr i8, ptr %scevgep27.5, i64 80
  store double %.390.5, ptr %scevgep28.5, align 8
  %.390.1.5 = load double, ptr %sunkaddr25, align 8
  %scevgep26.5 = getelementptr i8, ptr %scevgep27.5, i64 88
  store double %.390.1.5, ptr %scevgep26.5, align 8
  %exitcond.not.1.5 = icmp eq i64 %size.2.1, 6
  br i1 %exitcond.not.1.5, label %B78457, label %B292.if.6

B292.if.6:                                        ; preds = %B292.if.5
  %.390.6 = load double, ptr %sunkaddr26, align 8
  %26 = add i64 %.392, 12
  %.407.6 = icmp slt i64 %26, 0
  %27 = select i1 %.407.6, i64 %0, i64 0
  %scevgep27.6 = getelementptr i8, ptr %scevgep23, i64 %27
  %scevgep28.6 = getelementptr i8, ptr %scevgep27.6, i64 96
  store double %.390.6, ptr %scevgep28.6, align 8
  %.390.1.6 = load double, ptr %sunkaddr27, align 8
  %scevgep26.6 = getelementptr i8, ptr %scevgep27.6, i64 104
  store double %.390.1.6, ptr %scevgep26.6, align 8
  br label %B78457

B78473.if:                                        ; preds = %B78473.if, %B78473.if.preheader4
  %lsr.iv1 = phi ptr [ %scevgep5, %B78473.if ], [ %scevgep, %B78473.if.preheader4 ]
  %lsr.iv = phi i64 [ %lsr.iv.next, %B78473.if ], [ %10, %B78473.if.preheader4 ]
  %.642332334 = phi i64 [ %35, %B78473.if ], [ %.642332334.unr, %B78473.if.preheader4 ]
  %.687 = icmp slt i64 %.642332334, 0
  %28 = select i1 %.687, i64 %11, i64 0
  %scevgep9 = getelementptr i8, ptr %lsr.iv1, i64 %28
  store double 0.000000e+00, ptr %scevgep9, align 8
  %29 = add i64 %.642332334, 1
  %.687.1 = icmp slt i64 %29, 0
  %30 = select i1 %.687.1, i64 %12, i64 8
  %scevgep8 = getelementptr i8, ptr %lsr.iv1, i64 %30
  store double 0.000000e+00, ptr %scevgep8, align 8
  %31 = add i64 %.642332334, 2
  %.687.2 = icmp slt i64 %31, 0
  %32 = select i1 %.687.2, i64 %13, i64 16
  %scevgep7 = getelementptr i8, ptr %lsr.iv1, i64 %32
  store double 0.000000e+00, ptr %scevgep7, align 8
  %33 = add i64 %.642332334, 3
  %.687.3 = icmp slt i64 %33, 0
  %34 = select i1 %.687.3, i64 %14, i64 24
  %scevgep6 = getelementptr i8, ptr %lsr.iv1, i64 %34
  store double 0.000000e+00, ptr %scevgep6, align 8
  %lsr.iv.next = add i64 %lsr.iv, -4
  %scevgep5 = getelementptr i8, ptr %lsr.iv1, i64 32
  %.636.3 = icmp sgt i64 %lsr.iv.next, 4
  %35 = add i64 %.642332334, 4
  br i1 %.636.3, label %B78473.if, label %B78514
}

; Function Attrs: nofree noinline norecurse nosync nounwind memory(readwrite, inaccessiblemem: none, target_mem0: none, target_mem1: none)
define internal fastcc void @inner_26(ptr noalias nonnull writeonly captures(none) initializes((0, 8)) %retptr, i64 %arg.i, i64 %arg.start, i64 %arg.stop, ptr readonly captures(none) %arg.arguments.4, i64 %arg.count, ptr readonly captures(none) %arg.sums.0.4, ptr readonly captures(none) %arg.sums.1.4, ptr readonly captures(none) %arg.sums.2.4, ptr readonly captures(none) %arg.sums.3.4, ptr captures(none) %arg.tail.4) unnamed_addr #4 {
entry:
  %.436 = alloca ptr, align 8
  store ptr null, ptr %.436, align 8
  %.563 = alloca ptr, align 8
  store ptr null, ptr %.563, align 8
  %.680 = alloca ptr, align 8
  store ptr null, ptr %.680, align 8
  %.808 = alloca ptr, align 8
  store ptr null, ptr %.808, align 8
  %.124 = getelementptr i8, ptr %arg.arguments.4, i64 16
  %.125 = load i64, ptr %.124, align 8
  %.126 = mul nsw i64 %.125, %arg.i
  %.127 = add nsw i64 %.126, %arg.start
  %.128 = sub nsw i64 %arg.stop, %arg.start
  %.129 = shl nsw i64 %.128, 1
  %.164 = getelementptr i8, ptr %arg.arguments.4, i64 112
  %.165 = load i64, ptr %.164, align 8
  %.166 = icmp eq i64 %.165, 3
  %.210 = getelementptr i8, ptr %arg.arguments.4, i64 120
  %.211 = load i64, ptr %.210, align 8
  %0 = select i1 %.166, i64 3, i64 4
  %.213 = shl i64 %.127, %0
  %.214 = add nsw i64 %.213, %.211
  %.243 = getelementptr i8, ptr %arg.arguments.4, i64 128
  %.244 = load i64, ptr %.243, align 8
  %.249 = add nsw i64 %.213, %.244
  %.65.i = load i64, ptr %arg.arguments.4, align 8, !noalias !230
  %.98.i = shl i64 %.65.i, %0
  %.100.i = mul i64 %.98.i, %.125
  %.120.i = icmp slt i64 %.100.i, 2097152
  %.134.i = sub nsw i64 %.211, %.244
  %.147.1.i = and i64 %.134.i, 63
  %.177.i = icmp ne i64 %.147.1.i, 0
  %brmerge.i = or i1 %.177.i, %.120.i
  br i1 %brmerge.i, label %B142.endif, label %B162.i

B162.i:                                           ; preds = %entry
  %"$phi142.0.2.0" = select i1 %.166, i64 8, i64 16
  %"$phi142.0.2.0.neg" = select i1 %.166, i64 -8, i64 -16
  %.218.i = srem i64 %.214, %"$phi142.0.2.0"
  %.220.i = icmp slt i64 %.218.i, 0
  %.229.i.neg = select i1 %.220.i, i64 %"$phi142.0.2.0.neg", i64 0
  %1 = icmp eq i64 %.218.i, %.229.i.neg
  br i1 %1, label %B184.endif.else.if.i, label %B142.endif

B184.endif.else.if.i:                             ; preds = %B162.i
  %.250.i = sub i64 0, %.214
  %.263.1.i = and i64 %.250.i, 63
  %.312.i66 = lshr i64 %.263.1.i, %0
  br label %B142.endif

B282:                                             ; preds = %B142.endif
  store ptr null, ptr %.436, align 8
  call fastcc void @inner_30(ptr nonnull %.436, i64 %arg.count, ptr %arg.sums.0.4, ptr %arg.sums.1.4, i64 %storemerge.i, ptr %2, i64 %.129, ptr %arg.tail.4)
  store ptr null, ptr %.563, align 8
  call fastcc void @inner_30(ptr nonnull %.563, i64 %arg.count, ptr %arg.sums.2.4, ptr %arg.sums.3.4, i64 %storemerge.i, ptr %.513, i64 %.129, ptr %arg.tail.4)
  br label %common.ret.sink.split

B520:                                             ; preds = %B142.endif
  store ptr null, ptr %.680, align 8
  call fastcc void @inner_31(ptr nonnull %.680, i64 %arg.count, ptr %arg.sums.0.4, ptr %arg.sums.1.4, i64 %storemerge.i, ptr %2, i64 %.129, ptr %arg.tail.4)
  store ptr null, ptr %.808, align 8
  call fastcc void @inner_31(ptr nonnull %.808, i64 %arg.count, ptr %arg.sums.2.4, ptr %arg.sums.3.4, i64 %storemerge.i, ptr %.513, i64 %.129, ptr %arg.tail.4)
  br label %common.ret.sink.split

B142.endif:                                       ; preds = %B184.endif.else.if.i, %B162.i, %entry
  %storemerge.i = phi i64 [ -1, %B162.i ], [ -1, %entry ], [ %.312.i66, %B184.endif.else.if.i ]
  %2 = inttoptr i64 %.214 to ptr
  %.513 = inttoptr i64 %.249 to ptr
  br i1 %.166, label %B282, label %B520

common.ret.sink.split:                            ; preds = %B520, %B282
  store ptr null, ptr %retptr, align 8
  ret void
}

; Function Attrs: mustprogress nocallback nocreateundeforpoison nofree nosync nounwind speculatable willreturn memory(none)
declare { i64, i1 } @llvm.usub.with.overflow.i64(i64, i64) #3

attributes #0 = { nofree norecurse nounwind }
attributes #1 = { mustprogress nocallback nofree nounwind willreturn memory(argmem: write) }
attributes #2 = { nofree noinline norecurse nounwind }
attributes #3 = { mustprogress nocallback nocreateundeforpoison nofree nosync nounwind speculatable willreturn memory(none) }
attributes #4 = { nofree noinline norecurse nosync nounwind memory(readwrite, inaccessiblemem: none, target_mem0: none, target_mem1: none) }
attributes #5 = { mustprogress nofree noinline norecurse nosync nounwind willreturn memory(argmem: readwrite) }
attributes #6 = { nofree noinline norecurse nosync nounwind memory(argmem: readwrite) }
attributes #7 = { nofree noinline norecurse nosync nounwind memory(argmem: write) }
attributes #8 = { mustprogress nocallback nofree nosync nounwind willreturn memory(none) }

!0 = !{!"branch_weights", i32 49, i32 1}
!1 = !{!"branch_weights", i32 1, i32 99}
!2 = !{!3}
!3 = distinct !{!3, !4, !"_ZN17bnserve_surrogate6kernel5modes10_synthesis14fill_harmonicsB3v17B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExdd5ArrayIxLi1E1C7mutable7alignedE: %retptr"}
!4 = distinct !{!4, !"_ZN17bnserve_surrogate6kernel5modes10_synthesis14fill_harmonicsB3v17B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExdd5ArrayIxLi1E1C7mutable7alignedE"}
!5 = !{!"branch_weights", i32 99, i32 1}
!6 = !{!7}
!7 = distinct !{!7, !8, !"_ZN17bnserve_surrogate12_coordinates18transform_physicalB3v45B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDAxYh_2bqJnA4AOzNAE_3dEddddd5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!8 = distinct !{!8, !"_ZN17bnserve_surrogate12_coordinates18transform_physicalB3v45B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDAxYh_2bqJnA4AOzNAE_3dEddddd5ArrayIdLi1E1C7mutable7alignedE"}
!9 = !{!10, !12}
!10 = distinct !{!10, !11, !"_ZN17bnserve_surrogate12_coordinates18transform_physicalB3v47B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDAxYh_2bqJnA4AOzNAE_3dEddddd5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!11 = distinct !{!11, !"_ZN17bnserve_surrogate12_coordinates18transform_physicalB3v47B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDAxYh_2bqJnA4AOzNAE_3dEddddd5ArrayIdLi1E1C7mutable7alignedE"}
!12 = distinct !{!12, !13, !"_ZN17bnserve_surrogate12_coordinates19transform_symmetricB3v46B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDAxYh_2bqJnA4AOzNAE_3dEddddd5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!13 = distinct !{!13, !"_ZN17bnserve_surrogate12_coordinates19transform_symmetricB3v46B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDAxYh_2bqJnA4AOzNAE_3dEddddd5ArrayIdLi1E1C7mutable7alignedE"}
!14 = !{!12}
!15 = !{!16}
!16 = distinct !{!16, !17, !"_ZN17bnserve_surrogate6kernel7_places9find_endsB4v532B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5TupleI5ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedExdE5ArrayIdLi1E1C7mutable7alignedExdx5ArrayIxLi1E1C7mutable7alignedE: %retptr"}
!17 = distinct !{!17, !"_ZN17bnserve_surrogate6kernel7_places9find_endsB4v532B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5TupleI5ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedExdE5ArrayIdLi1E1C7mutable7alignedExdx5ArrayIxLi1E1C7mutable7alignedE"}
!18 = !{!19}
!19 = distinct !{!19, !20, !"_ZN17bnserve_surrogate6kernel7_points11two_splinesB4v364B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedExxd5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!20 = distinct !{!20, !"_ZN17bnserve_surrogate6kernel7_points11two_splinesB4v364B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedExxd5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!21 = !{!22}
!22 = distinct !{!22, !23, !"_ZN17bnserve_surrogate6kernel7_points6splineB4v533B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedExxd5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!23 = distinct !{!23, !"_ZN17bnserve_surrogate6kernel7_points6splineB4v533B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedExxd5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE"}
!24 = !{!25}
!25 = distinct !{!25, !26, !"_ZN17bnserve_surrogate6kernel7_points6phasesB4v244B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!26 = distinct !{!26, !"_ZN17bnserve_surrogate6kernel7_points6phasesB4v244B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!27 = !{!28}
!28 = distinct !{!28, !29, !"_ZN17bnserve_surrogate6kernel7_points10fill_cellsB4v158B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedExx5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!29 = distinct !{!29, !"_ZN17bnserve_surrogate6kernel7_points10fill_cellsB4v158B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedExx5ArrayIdLi1E1C7mutable7alignedE"}
!30 = !{!31}
!31 = distinct !{!31, !32, !"_ZN17bnserve_surrogate6kernel7_points10fill_cellsB4v158B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedExx5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!32 = distinct !{!32, !"_ZN17bnserve_surrogate6kernel7_points10fill_cellsB4v158B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedExx5ArrayIdLi1E1C7mutable7alignedE"}
!33 = !{!34}
!34 = distinct !{!34, !35, !"_ZN17bnserve_surrogate6kernel7_places9find_endsB4v532B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5TupleI5ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedExdE5ArrayIdLi1E1C7mutable7alignedExdx5ArrayIxLi1E1C7mutable7alignedE: %retptr"}
!35 = distinct !{!35, !"_ZN17bnserve_surrogate6kernel7_places9find_endsB4v532B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5TupleI5ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedExdE5ArrayIdLi1E1C7mutable7alignedExdx5ArrayIxLi1E1C7mutable7alignedE"}
!36 = !{!37}
!37 = distinct !{!37, !38, !"_ZN17bnserve_surrogate6kernel7_places9find_endsB4v532B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5TupleI5ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedExdE5ArrayIdLi1E1C7mutable7alignedExdx5ArrayIxLi1E1C7mutable7alignedE: %retptr"}
!38 = distinct !{!38, !"_ZN17bnserve_surrogate6kernel7_places9find_endsB4v532B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5TupleI5ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedExdE5ArrayIdLi1E1C7mutable7alignedExdx5ArrayIxLi1E1C7mutable7alignedE"}
!39 = !{!40}
!40 = distinct !{!40, !41, !"_ZN17bnserve_surrogate6kernel7_points12extend_belowB4v361B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedExdd8UniTupleIdLi2EEd5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!41 = distinct !{!41, !"_ZN17bnserve_surrogate6kernel7_points12extend_belowB4v361B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedExdd8UniTupleIdLi2EEd5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!42 = !{!43}
!43 = distinct !{!43, !44, !"_ZN17bnserve_surrogate6kernel7_points6splineB4v533B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedExxd5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!44 = distinct !{!44, !"_ZN17bnserve_surrogate6kernel7_points6splineB4v533B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedExxd5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE"}
!45 = !{!46}
!46 = distinct !{!46, !47, !"_ZN17bnserve_surrogate6kernel7_points11polynomialsB4v365B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedExxd5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!47 = distinct !{!47, !"_ZN17bnserve_surrogate6kernel7_points11polynomialsB4v365B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedExxd5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!48 = !{!"branch_weights", i32 146201250, i32 2001282398}
!49 = !{!"branch_weights", i32 166258294, i32 1981225354}
!50 = !{!"branch_weights", i32 1030503492, i32 1116980156}
!51 = !{!"branch_weights", i32 277993707, i32 1869489941}
!52 = !{!"branch_weights", i32 542333185, i32 1605150463}
!53 = distinct !{!53, !54, !55}
!54 = !{!"llvm.loop.estimated_trip_count", i32 4}
!55 = !{!"llvm.loop.unroll.disable"}
!56 = distinct !{!56, !54, !55}
!57 = !{!"branch_weights", i32 319644862, i32 1827838786}
!58 = distinct !{!58, !59}
!59 = !{!"llvm.loop.estimated_trip_count", i32 6}
!60 = distinct !{!60, !59}
!61 = distinct !{!61, !54, !55}
!62 = distinct !{!62, !54, !55}
!63 = distinct !{!63, !59}
!64 = distinct !{!64, !59}
!65 = !{!66}
!66 = distinct !{!66, !67, !"_ZN17bnserve_surrogate6kernel9_matrices8multiplyB3v84B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIdLi1E1C7mutable7alignedEx23Literal_5bint_5d_281_295ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedEx: %retptr"}
!67 = distinct !{!67, !"_ZN17bnserve_surrogate6kernel9_matrices8multiplyB3v84B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIdLi1E1C7mutable7alignedEx23Literal_5bint_5d_281_295ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedEx"}
!68 = !{!69}
!69 = distinct !{!69, !70, !"_ZN17bnserve_surrogate6kernel11_regression9_productsB3v70B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedExx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!70 = distinct !{!70, !"_ZN17bnserve_surrogate6kernel11_regression9_productsB3v70B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedExx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!71 = !{!72}
!72 = distinct !{!72, !73, !"_ZN17bnserve_surrogate6kernel9_matrices8multiplyB3v74B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIdLi1E1C7mutable7alignedE23Literal_5bint_5d_281_2923Literal_5bint_5d_288_295ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedEx: %retptr"}
!73 = distinct !{!73, !"_ZN17bnserve_surrogate6kernel9_matrices8multiplyB3v74B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIdLi1E1C7mutable7alignedE23Literal_5bint_5d_281_2923Literal_5bint_5d_288_295ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedEx"}
!74 = !{!75}
!75 = distinct !{!75, !76, !"_ZN17bnserve_surrogate6kernel9_matrices8multiplyB3v84B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIdLi1E1C7mutable7alignedEx23Literal_5bint_5d_281_295ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedEx: %retptr"}
!76 = distinct !{!76, !"_ZN17bnserve_surrogate6kernel9_matrices8multiplyB3v84B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIdLi1E1C7mutable7alignedEx23Literal_5bint_5d_281_295ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedEx"}
!77 = !{!78}
!78 = distinct !{!78, !79, !"_ZN17bnserve_surrogate6kernel7_places15first_not_belowB4v235B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedEdx: %retptr"}
!79 = distinct !{!79, !"_ZN17bnserve_surrogate6kernel7_places15first_not_belowB4v235B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedEdx"}
!80 = !{!81}
!81 = distinct !{!81, !82, !"_ZN17bnserve_surrogate6kernel7_places15first_not_belowB4v235B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedEdx: %retptr"}
!82 = distinct !{!82, !"_ZN17bnserve_surrogate6kernel7_places15first_not_belowB4v235B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedEdx"}
!83 = !{!84}
!84 = distinct !{!84, !85, !"_ZN17bnserve_surrogate6kernel7_points15spline_at_nodesB4v236B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!85 = distinct !{!85, !"_ZN17bnserve_surrogate6kernel7_points15spline_at_nodesB4v236B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE"}
!86 = !{!87}
!87 = distinct !{!87, !88, !"_ZN17bnserve_surrogate6kernel7_points16fill_polynomialsB4v243B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!88 = distinct !{!88, !"_ZN17bnserve_surrogate6kernel7_points16fill_polynomialsB4v243B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE"}
!89 = !{!90}
!90 = distinct !{!90, !91, !"_ZN17bnserve_surrogate6kernel7_points15spline_at_nodesB4v236B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!91 = distinct !{!91, !"_ZN17bnserve_surrogate6kernel7_points15spline_at_nodesB4v236B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE"}
!92 = !{!93}
!93 = distinct !{!93, !94, !"_ZN17bnserve_surrogate6kernel7_points6phasesB4v244B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!94 = distinct !{!94, !"_ZN17bnserve_surrogate6kernel7_points6phasesB4v244B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!95 = !{!96}
!96 = distinct !{!96, !97, !"_ZN17bnserve_surrogate6kernel7_points16fill_polynomialsB4v243B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!97 = distinct !{!97, !"_ZN17bnserve_surrogate6kernel7_points16fill_polynomialsB4v243B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE"}
!98 = !{!99}
!99 = distinct !{!99, !100, !"_ZN17bnserve_surrogate8baseline10_amplitude22amplitude_coefficientsB4v184B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDAxYh_2bqJnA4AOzNAE_3dEddd5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!100 = distinct !{!100, !"_ZN17bnserve_surrogate8baseline10_amplitude22amplitude_coefficientsB4v184B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDAxYh_2bqJnA4AOzNAE_3dEddd5ArrayIdLi1E1C7mutable7alignedE"}
!101 = !{!102}
!102 = distinct !{!102, !103, !"_ZN17bnserve_surrogate8baseline6_phase18phase_coefficientsB4v187B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDAxYh_2bqJnA4AOzNAE_3dEddddd5ArrayIdLi2E1C7mutable7alignedE: %retptr"}
!103 = distinct !{!103, !"_ZN17bnserve_surrogate8baseline6_phase18phase_coefficientsB4v187B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDAxYh_2bqJnA4AOzNAE_3dEddddd5ArrayIdLi2E1C7mutable7alignedE"}
!104 = !{!105, !102}
!105 = distinct !{!105, !106, !"_ZN17bnserve_surrogate8baseline6_phase20add_point_mass_phaseB4v188B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDAxYh_2bqJnA4AOzNAE_3dEd5ArrayIdLi2E1C7mutable7alignedE: %retptr"}
!106 = distinct !{!106, !"_ZN17bnserve_surrogate8baseline6_phase20add_point_mass_phaseB4v188B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDAxYh_2bqJnA4AOzNAE_3dEd5ArrayIdLi2E1C7mutable7alignedE"}
!107 = !{!108, !102}
!108 = distinct !{!108, !109, !"_ZN17bnserve_surrogate8baseline6_phase20add_spin_orbit_phaseB4v189B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDAxYh_2bqJnA4AOzNAE_3dEdd5ArrayIdLi2E1C7mutable7alignedE: %retptr"}
!109 = distinct !{!109, !"_ZN17bnserve_surrogate8baseline6_phase20add_spin_orbit_phaseB4v189B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDAxYh_2bqJnA4AOzNAE_3dEdd5ArrayIdLi2E1C7mutable7alignedE"}
!110 = !{!111, !102}
!111 = distinct !{!111, !112, !"_ZN17bnserve_surrogate8baseline6_phase20add_spin_orbit_phaseB4v189B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDAxYh_2bqJnA4AOzNAE_3dEdd5ArrayIdLi2E1C7mutable7alignedE: %retptr"}
!112 = distinct !{!112, !"_ZN17bnserve_surrogate8baseline6_phase20add_spin_orbit_phaseB4v189B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDAxYh_2bqJnA4AOzNAE_3dEdd5ArrayIdLi2E1C7mutable7alignedE"}
!113 = !{!114, !102}
!114 = distinct !{!114, !115, !"_ZN17bnserve_surrogate8baseline6_phase19add_self_spin_phaseB4v192B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDAxYh_2bqJnA4AOzNAE_3dEddd5ArrayIdLi2E1C7mutable7alignedE: %retptr"}
!115 = distinct !{!115, !"_ZN17bnserve_surrogate8baseline6_phase19add_self_spin_phaseB4v192B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDAxYh_2bqJnA4AOzNAE_3dEddd5ArrayIdLi2E1C7mutable7alignedE"}
!116 = !{!117, !102}
!117 = distinct !{!117, !118, !"_ZN17bnserve_surrogate8baseline6_phase19add_self_spin_phaseB4v192B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDAxYh_2bqJnA4AOzNAE_3dEddd5ArrayIdLi2E1C7mutable7alignedE: %retptr"}
!118 = distinct !{!118, !"_ZN17bnserve_surrogate8baseline6_phase19add_self_spin_phaseB4v192B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDAxYh_2bqJnA4AOzNAE_3dEddd5ArrayIdLi2E1C7mutable7alignedE"}
!119 = !{!120, !102}
!120 = distinct !{!120, !121, !"_ZN17bnserve_surrogate8baseline6_phase19add_spin_spin_phaseB4v193B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDAxYh_2bqJnA4AOzNAE_3dEddd5ArrayIdLi2E1C7mutable7alignedE: %retptr"}
!121 = distinct !{!121, !"_ZN17bnserve_surrogate8baseline6_phase19add_spin_spin_phaseB4v193B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDAxYh_2bqJnA4AOzNAE_3dEddd5ArrayIdLi2E1C7mutable7alignedE"}
!122 = !{!123, !102}
!123 = distinct !{!123, !124, !"_ZN17bnserve_surrogate8baseline6_phase15add_tidal_phaseB4v194B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDAxYh_2bqJnA4AOzNAE_3dEdd5ArrayIdLi2E1C7mutable7alignedE: %retptr"}
!124 = distinct !{!124, !"_ZN17bnserve_surrogate8baseline6_phase15add_tidal_phaseB4v194B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDAxYh_2bqJnA4AOzNAE_3dEdd5ArrayIdLi2E1C7mutable7alignedE"}
!125 = !{!126, !102}
!126 = distinct !{!126, !127, !"_ZN17bnserve_surrogate8baseline6_phase15add_tidal_phaseB4v194B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDAxYh_2bqJnA4AOzNAE_3dEdd5ArrayIdLi2E1C7mutable7alignedE: %retptr"}
!127 = distinct !{!127, !"_ZN17bnserve_surrogate8baseline6_phase15add_tidal_phaseB4v194B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDAxYh_2bqJnA4AOzNAE_3dEdd5ArrayIdLi2E1C7mutable7alignedE"}
!128 = !{!129, !131}
!129 = distinct !{!129, !130, !"_ZN17bnserve_surrogate6kernel7_series8legendreB4v196B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dEd5ArrayIdLi2E1C7mutable7alignedE: %retptr"}
!130 = distinct !{!130, !"_ZN17bnserve_surrogate6kernel7_series8legendreB4v196B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dEd5ArrayIdLi2E1C7mutable7alignedE"}
!131 = distinct !{!131, !130, !"_ZN17bnserve_surrogate6kernel7_series8legendreB4v196B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dEd5ArrayIdLi2E1C7mutable7alignedE: %excinfo"}
!132 = !{!133}
!133 = distinct !{!133, !134, !"_ZN17bnserve_surrogate6kernel7_series17fill_phase_powersB4v195B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dEd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!134 = distinct !{!134, !"_ZN17bnserve_surrogate6kernel7_series17fill_phase_powersB4v195B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dEd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!135 = !{!136}
!136 = distinct !{!136, !137, !"_ZN17bnserve_surrogate6kernel8_writing13streamed_fromB4v542B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedExxb23Literal_5bint_5d_288_29: %retptr"}
!137 = distinct !{!137, !"_ZN17bnserve_surrogate6kernel8_writing13streamed_fromB4v542B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedExxb23Literal_5bint_5d_288_29"}
!138 = !{!139}
!139 = distinct !{!139, !140, !"_ZN17bnserve_surrogate6kernel8_writing13streamed_fromB4v548B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedExxb24Literal_5bint_5d_2816_29: %retptr"}
!140 = distinct !{!140, !"_ZN17bnserve_surrogate6kernel8_writing13streamed_fromB4v548B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedExxb24Literal_5bint_5d_2816_29"}
!141 = !{i32 1}
!142 = distinct !{!142, !55}
!143 = distinct !{!143, !55}
!144 = distinct !{!144, !55}
!145 = distinct !{!145, !55}
!146 = !{!147}
!147 = distinct !{!147, !148, !"_ZN17bnserve_surrogate6kernel5modes9_carriers12cells_neededB4v214B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5TupleI5ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedExdE8UniTupleIdLi2EE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!148 = distinct !{!148, !"_ZN17bnserve_surrogate6kernel5modes9_carriers12cells_neededB4v214B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5TupleI5ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedExdE8UniTupleIdLi2EE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!149 = !{!150}
!150 = distinct !{!150, !151, !"_ZN17bnserve_surrogate6kernel5modes9_carriers11top_of_bandB4v245B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedExd5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!151 = distinct !{!151, !"_ZN17bnserve_surrogate6kernel5modes9_carriers11top_of_bandB4v245B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedExd5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!152 = !{!153}
!153 = distinct !{!153, !154, !"_ZN17bnserve_surrogate6kernel7_points10fill_cellsB4v158B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedExx5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!154 = distinct !{!154, !"_ZN17bnserve_surrogate6kernel7_points10fill_cellsB4v158B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedExx5ArrayIdLi1E1C7mutable7alignedE"}
!155 = !{!156}
!156 = distinct !{!156, !157, !"_ZN17bnserve_surrogate6kernel7_points10fill_cellsB4v158B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedExx5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!157 = distinct !{!157, !"_ZN17bnserve_surrogate6kernel7_points10fill_cellsB4v158B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedExx5ArrayIdLi1E1C7mutable7alignedE"}
!158 = !{!"branch_weights", i32 101, i32 99}
!159 = !{!160}
!160 = distinct !{!160, !161, !"_ZN17bnserve_surrogate6kernel5modes5_sums11add_carrierB4v366B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExbd5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE8UniTupleIdLi2EE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi4EE: %retptr"}
!161 = distinct !{!161, !"_ZN17bnserve_surrogate6kernel5modes5_sums11add_carrierB4v366B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExbd5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE8UniTupleIdLi2EE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi4EE"}
!162 = !{!163}
!163 = distinct !{!163, !164, !"_ZN17bnserve_surrogate6kernel5modes5_sums10fill_ratioB4v370B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedExx5ArrayIxLi1E1C7mutable7alignedEd5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi2EEx8UniTupleIdLi4EE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!164 = distinct !{!164, !"_ZN17bnserve_surrogate6kernel5modes5_sums10fill_ratioB4v370B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedExx5ArrayIxLi1E1C7mutable7alignedEd5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi2EEx8UniTupleIdLi4EE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!165 = !{!166}
!166 = distinct !{!166, !167, !"_ZN17bnserve_surrogate6kernel5modes5_sums8add_modeB4v373B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExbd5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE8UniTupleIdLi2EE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi2EE5ArrayIdLi1E1C7mutable7alignedE5TupleIddxE8UniTupleIdLi2EE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi4EE: %retptr"}
!167 = distinct !{!167, !"_ZN17bnserve_surrogate6kernel5modes5_sums8add_modeB4v373B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExbd5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE8UniTupleIdLi2EE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi2EE5ArrayIdLi1E1C7mutable7alignedE5TupleIddxE8UniTupleIdLi2EE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi4EE"}
!168 = distinct !{!168, !55}
!169 = !{!170}
!170 = distinct !{!170, !171, !"_ZN17bnserve_surrogate6kernel5modes5_sums10fill_ratioB4v370B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedExx5ArrayIxLi1E1C7mutable7alignedEd5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi2EEx8UniTupleIdLi4EE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!171 = distinct !{!171, !"_ZN17bnserve_surrogate6kernel5modes5_sums10fill_ratioB4v370B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedExx5ArrayIxLi1E1C7mutable7alignedEd5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi2EEx8UniTupleIdLi4EE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!172 = distinct !{!172, !55}
!173 = !{!174, !163}
!174 = distinct !{!174, !175, !"_ZN17bnserve_surrogate6kernel7_points11two_splinesB4v364B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedExxd5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!175 = distinct !{!175, !"_ZN17bnserve_surrogate6kernel7_points11two_splinesB4v364B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedExxd5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!176 = distinct !{!176, !55}
!177 = !{!178, !170}
!178 = distinct !{!178, !179, !"_ZN17bnserve_surrogate6kernel7_points11two_splinesB4v364B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedExxd5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!179 = distinct !{!179, !"_ZN17bnserve_surrogate6kernel7_points11two_splinesB4v364B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedExxd5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!180 = !{!181}
!181 = distinct !{!181, !182, !"_ZN17bnserve_surrogate6kernel5modes5_sums13add_two_modesB4v378B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExbd5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi2EE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi2EE5ArrayIdLi1E1C7mutable7alignedE5TupleIddxE8UniTupleIxLi2EE8UniTupleIdLi2EE8UniTupleIdLi2EE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi4EE: %retptr"}
!182 = distinct !{!182, !"_ZN17bnserve_surrogate6kernel5modes5_sums13add_two_modesB4v378B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExbd5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi2EE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi2EE5ArrayIdLi1E1C7mutable7alignedE5TupleIddxE8UniTupleIxLi2EE8UniTupleIdLi2EE8UniTupleIdLi2EE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi4EE"}
!183 = distinct !{!183, !55}
!184 = distinct !{!184, !55}
!185 = !{!186}
!186 = distinct !{!186, !187, !"_ZN17bnserve_surrogate6kernel5modes5_sums10fill_ratioB4v370B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedExx5ArrayIxLi1E1C7mutable7alignedEd5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi2EEx8UniTupleIdLi4EE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!187 = distinct !{!187, !"_ZN17bnserve_surrogate6kernel5modes5_sums10fill_ratioB4v370B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedExx5ArrayIxLi1E1C7mutable7alignedEd5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi2EEx8UniTupleIdLi4EE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!188 = !{!189}
!189 = distinct !{!189, !190, !"_ZN17bnserve_surrogate6kernel5modes5_sums4turnB4v445B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExd5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!190 = distinct !{!190, !"_ZN17bnserve_surrogate6kernel5modes5_sums4turnB4v445B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExd5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!191 = distinct !{!191, !55}
!192 = !{!193, !186}
!193 = distinct !{!193, !194, !"_ZN17bnserve_surrogate6kernel7_points11two_splinesB4v364B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedExxd5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!194 = distinct !{!194, !"_ZN17bnserve_surrogate6kernel7_points11two_splinesB4v364B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedExxd5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!195 = distinct !{!195, !55}
!196 = distinct !{!196, !55}
!197 = !{!198}
!198 = distinct !{!198, !199, !"_ZN17bnserve_surrogate6kernel5modes5_sums13multiply_modeB4v453B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi2EE5ArrayIdLi1E1C7mutable7alignedE5TupleIddxE: %retptr"}
!199 = distinct !{!199, !"_ZN17bnserve_surrogate6kernel5modes5_sums13multiply_modeB4v453B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi2EE5ArrayIdLi1E1C7mutable7alignedE5TupleIddxE"}
!200 = !{!201}
!201 = distinct !{!201, !202, !"_ZN17bnserve_surrogate6kernel7_places15find_ends_apartB4v197B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5TupleI5ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedExdE5ArrayIdLi1E1C7mutable7alignedExdx5ArrayIxLi1E1C7mutable7alignedE: %retptr"}
!202 = distinct !{!202, !"_ZN17bnserve_surrogate6kernel7_places15find_ends_apartB4v197B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5TupleI5ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedExdE5ArrayIdLi1E1C7mutable7alignedExdx5ArrayIxLi1E1C7mutable7alignedE"}
!203 = !{!204}
!204 = distinct !{!204, !205, !"_ZN17bnserve_surrogate6kernel7_places15find_ends_apartB4v197B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5TupleI5ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedExdE5ArrayIdLi1E1C7mutable7alignedExdx5ArrayIxLi1E1C7mutable7alignedE: %retptr"}
!205 = distinct !{!205, !"_ZN17bnserve_surrogate6kernel7_places15find_ends_apartB4v197B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5TupleI5ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedExdE5ArrayIdLi1E1C7mutable7alignedExdx5ArrayIxLi1E1C7mutable7alignedE"}
!206 = !{!207}
!207 = distinct !{!207, !208, !"_ZN17bnserve_surrogate6kernel7_places15find_ends_apartB4v197B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5TupleI5ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedExdE5ArrayIdLi1E1C7mutable7alignedExdx5ArrayIxLi1E1C7mutable7alignedE: %retptr"}
!208 = distinct !{!208, !"_ZN17bnserve_surrogate6kernel7_places15find_ends_apartB4v197B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5TupleI5ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedExdE5ArrayIdLi1E1C7mutable7alignedExdx5ArrayIxLi1E1C7mutable7alignedE"}
!209 = !{!210}
!210 = distinct !{!210, !211, !"_ZN17bnserve_surrogate6kernel7_points10fill_cellsB4v158B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedExx5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!211 = distinct !{!211, !"_ZN17bnserve_surrogate6kernel7_points10fill_cellsB4v158B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedExx5ArrayIdLi1E1C7mutable7alignedE"}
!212 = !{!213}
!213 = distinct !{!213, !214, !"_ZN17bnserve_surrogate6kernel7_points10fill_cellsB4v158B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedExx5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!214 = distinct !{!214, !"_ZN17bnserve_surrogate6kernel7_points10fill_cellsB4v158B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedExx5ArrayIdLi1E1C7mutable7alignedE"}
!215 = !{!216}
!216 = distinct !{!216, !217, !"_ZN17bnserve_surrogate6kernel7_points6phasesB4v244B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!217 = distinct !{!217, !"_ZN17bnserve_surrogate6kernel7_points6phasesB4v244B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!218 = !{!219}
!219 = distinct !{!219, !220, !"_ZN17bnserve_surrogate6kernel7_points12extend_belowB4v361B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedExdd8UniTupleIdLi2EEd5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!220 = distinct !{!220, !"_ZN17bnserve_surrogate6kernel7_points12extend_belowB4v361B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedExdd8UniTupleIdLi2EEd5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!221 = !{!222}
!222 = distinct !{!222, !223, !"_ZN17bnserve_surrogate6kernel7_points11two_splinesB4v364B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedExxd5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!223 = distinct !{!223, !"_ZN17bnserve_surrogate6kernel7_points11two_splinesB4v364B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedExxd5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!224 = !{!225}
!225 = distinct !{!225, !226, !"_ZN17bnserve_surrogate6kernel7_points11polynomialsB4v365B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedExxd5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!226 = distinct !{!226, !"_ZN17bnserve_surrogate6kernel7_points11polynomialsB4v365B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedExxd5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!227 = !{}
!228 = distinct !{!228, !55}
!229 = distinct !{!229, !55}
!230 = !{!231}
!231 = distinct !{!231, !232, !"_ZN17bnserve_surrogate6kernel8_writing13streamed_fromB4v390B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedExx27Literal_5bbool_5d_28True_29x: %retptr"}
!232 = distinct !{!232, !"_ZN17bnserve_surrogate6kernel8_writing13streamed_fromB4v390B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedExx27Literal_5bbool_5d_28True_29x"}
