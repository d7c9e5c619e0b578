; sources: 98ad21e1ca036a9ea65734c2f18bd2286f4b57e51195d89fa01b05abb053e13b
; built by: numba 0.68.1, llvmlite 0.50.0, Python 3.11, x86_64
; ModuleID = '<string>'
source_filename = "<string>"

@.const.pickledata.b28008a0f88bad5ff0f0243e84dab90cab19b366 = internal constant [69 x i8] c"\80\04\95:\00\00\00\00\00\00\00\8C\08builtins\94\8C\11ZeroDivisionError\94\93\94\8C\10division by zero\94\85\94N\87\94."
@.const.pickledata.b28008a0f88bad5ff0f0243e84dab90cab19b366.sha1 = internal constant [20 x i8] c"\B2\80\08\A0\F8\8B\AD_\F0\F0$>\84\DA\B9\0C\AB\19\B3f"
@.const.picklebuf.b28008a0f88bad5ff0f0243e84dab90cab19b366 = internal constant { ptr, i32, ptr, ptr, i32 } { ptr @.const.pickledata.b28008a0f88bad5ff0f0243e84dab90cab19b366, i32 69, ptr @.const.pickledata.b28008a0f88bad5ff0f0243e84dab90cab19b366.sha1, ptr null, i32 0 }

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
  %.1861 = alloca i64, align 8
  store i64 0, ptr %.1861, align 8
  %.2356 = alloca ptr, align 8
  store ptr null, ptr %.2356, align 8
  %excinfo.11 = alloca ptr, align 8
  store ptr null, ptr %excinfo.11, align 8
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
  %.3731116 = phi i64 [ %.380, %B284.if ], [ 0, %B190 ]
  %exitcond.not = icmp eq i64 %..47, %.3731116
  br i1 %exitcond.not, label %B344, label %B284.if

common.ret:                                       ; preds = %B1510.endif.if, %B1604, %B1460, %B324
  %common.ret.op = phi i32 [ 0, %B324 ], [ 0, %B1460 ], [ 0, %B1604 ], [ %.2374, %B1510.endif.if ]
  ret i32 %common.ret.op

B324:                                             ; preds = %B284.if
  store i64 -1, ptr %retptr, align 8
  br label %common.ret

B344:                                             ; preds = %B284, %entry
  %.697 = load i64, ptr %arg.arguments.4, align 8
  %.733 = mul nsw i64 %.697, 10
  %.986 = shl nsw i64 %.697, 1
  %.11361120.not = icmp slt i64 %.697, 1
  br i1 %.11361120.not, label %B1604, label %B840.if.lr.ph

B1172:                                            ; preds = %B844.else.endif.endif
  %.1964 = getelementptr i8, ptr %.1321, i64 48
  %.1965 = load double, ptr %.1964, align 8
  %.1978.le = tail call contract double @llvm.cos.f64(double %.1965)
  br label %B1266

B1266:                                            ; preds = %B844.else.endif.endif, %B1172
  %"$phi1266.1.2.1" = phi double [ %.1978.le, %B1172 ], [ 0x7FF8000000000000, %B844.else.endif.endif ]
  %.1998 = fmul contract double %"$phi1266.1.2.1", %"$phi1266.1.2.1"
  %.1999 = fadd contract double %.1998, 1.000000e+00
  %.2000 = fmul contract double %.1999, 5.000000e-01
  %2 = shl i64 %.114211191121, 3
  %scevgep132 = getelementptr i8, ptr %14, i64 %2
  store double %.2000, ptr %scevgep132, align 8
  %scevgep131 = getelementptr i8, ptr %lsr.iv129, i64 -8
  store double 0.000000e+00, ptr %scevgep131, align 8
  %.2064 = fneg contract double %"$phi1266.1.2.1"
  store double %.2064, ptr %lsr.iv129, align 8
  %.2101 = icmp ne i64 %.1881, 0
  %.2106 = zext i1 %.2101 to i64
  %.2107 = add nuw nsw i64 %bad.2.01123, %.2106
  %scevgep130 = getelementptr i8, ptr %lsr.iv129, i64 16
  %lsr.iv.next134 = add i64 %lsr.iv133, 10
  %exitcond1140.not = icmp eq i64 %.697, %.1149
  br i1 %exitcond1140.not, label %B1378, label %B840.if

B1378:                                            ; preds = %B1266
  %.2123.not = icmp eq i64 %.2107, 0
  br i1 %.2123.not, label %B1464, label %B1390

B1390:                                            ; preds = %B1378
  %sunkaddr31.le = getelementptr i8, ptr %arg.arguments.4, i64 96
  %.2154 = load i64, ptr %sunkaddr31.le, align 8
  %.2155 = and i64 %.2154, 4
  %.2156.not = icmp eq i64 %.2155, 0
  br i1 %.2156.not, label %B1464, label %B1460

B1460:                                            ; preds = %B1390
  store i64 %.2107, ptr %retptr, align 8
  br label %common.ret

B1464:                                            ; preds = %B1390, %B1378
  %3 = add nuw i64 %.697, 7
  %.2259 = lshr i64 %3, 3
  %4 = add nuw nsw i64 %.2259, 2
  br label %B1508.if

B1604:                                            ; preds = %B1508.backedge, %B344
  %bad.2.0.lcssa713 = phi i64 [ 0, %B344 ], [ %.2107, %B1508.backedge ]
  fence seq_cst
  store i64 %bad.2.0.lcssa713, ptr %retptr, align 8
  br label %common.ret

B284.if:                                          ; preds = %B284
  %.380 = add nuw i64 %.3731116, 1
  %5 = shl i64 %.3731116, 3
  %scevgep135 = getelementptr i8, ptr %1, i64 %5
  %.434 = load double, ptr %scevgep135, align 8
  %scevgep136 = getelementptr i8, ptr %0, i64 %5
  %.464 = load double, ptr %scevgep136, align 8
  %.465 = fcmp contract une double %.434, %.464
  br i1 %.465, label %B324, label %B284

B840.if.lr.ph:                                    ; preds = %B344
  %.903 = getelementptr i8, ptr %arg.arguments.4, i64 136
  %.904 = load i64, ptr %.903, align 8
  %.817 = getelementptr i8, ptr %arg.arguments.4, i64 152
  %.818 = load i64, ptr %.817, align 8
  %.730 = getelementptr i8, ptr %arg.arguments.4, i64 8
  %.731 = load i64, ptr %.730, align 8
  %.612 = getelementptr i8, ptr %arg.arguments.4, i64 80
  %.613 = load i64, ptr %.612, align 8
  %.527 = getelementptr i8, ptr %arg.arguments.4, i64 64
  %.528 = load i64, ptr %.527, align 8
  %.983 = getelementptr i8, ptr %arg.arguments.4, i64 144
  %.984 = load i64, ptr %.983, align 8
  %6 = inttoptr i64 %.984 to ptr
  %7 = inttoptr i64 %.111 to ptr
  %.1813.inv = icmp sgt i64 %.47, 0
  %8 = getelementptr double, ptr %7, i64 %.47
  %9 = getelementptr i8, ptr %8, i64 -8
  %scevgep = getelementptr i8, ptr %6, i64 8
  %10 = mul i64 %.77, 40
  %sunkaddr141 = select i1 %.1813.inv, i64 0, i64 %10
  %11 = inttoptr i64 %.613 to ptr
  %12 = inttoptr i64 %.731 to ptr
  %sunkaddr = inttoptr i64 %.528 to ptr
  %sunkaddr27 = getelementptr i8, ptr %sunkaddr, i64 136
  %sunkaddr29 = getelementptr i8, ptr %sunkaddr, i64 128
  %sunkaddr30 = getelementptr inbounds i8, ptr %9, i64 %sunkaddr141
  %sunkaddr31 = getelementptr i8, ptr %arg.arguments.4, i64 96
  %13 = inttoptr i64 %.818 to ptr
  %14 = inttoptr i64 %.904 to ptr
  br label %B840.if

B840.if:                                          ; preds = %B840.if.lr.ph, %B1266
  %lsr.iv133 = phi i64 [ 10, %B840.if.lr.ph ], [ %lsr.iv.next134, %B1266 ]
  %lsr.iv129 = phi ptr [ %scevgep, %B840.if.lr.ph ], [ %scevgep130, %B1266 ]
  %bad.2.01123 = phi i64 [ 0, %B840.if.lr.ph ], [ %.2107, %B1266 ]
  %.114211191121 = phi i64 [ 0, %B840.if.lr.ph ], [ %.1149, %B1266 ]
  %.1149 = add nuw nsw i64 %.114211191121, 1
  %15 = add i64 %lsr.iv133, -10
  %.1228.not = icmp slt i64 %.114211191121, %.697
  br i1 %.1228.not, label %B844.else.endif.endif, label %B844.else.endif.if, !prof !1

B844.else.endif.if:                               ; preds = %B840.if
  br label %B844.else.endif.endif

B844.else.endif.endif:                            ; preds = %B844.else.endif.if, %B840.if
  %.1208.sroa.0.3 = phi i64 [ %.733, %B844.else.endif.if ], [ %15, %B840.if ]
  %.1321 = getelementptr double, ptr %12, i64 %.1208.sroa.0.3
  %.1388 = load i64, ptr %sunkaddr27, align 8
  %16 = lshr i64 %.1388, 33
  %.1426 = and i64 %16, 1073741824
  %.1427 = add i64 %.1426, %.1388
  %17 = tail call i64 @llvm.smax.i64(i64 %.1427, i64 0)
  %.1415.sroa.0.3 = tail call i64 @llvm.smin.i64(i64 %17, i64 1073741824)
  %.1528 = getelementptr double, ptr %11, i64 %.1415.sroa.0.3
  %.1589 = load i64, ptr %sunkaddr29, align 8
  %18 = lshr i64 %.1589, 33
  %.1627 = and i64 %18, 1073741824
  %.1628 = add i64 %.1627, %.1589
  %19 = tail call i64 @llvm.smax.i64(i64 %.1628, i64 0)
  %.1616.sroa.0.3 = tail call i64 @llvm.smin.i64(i64 %19, i64 1073741824)
  %.1729 = getelementptr double, ptr %11, i64 %.1616.sroa.0.3
  %.1797 = load double, ptr %7, align 8
  %.1829 = load double, ptr %sunkaddr30, align 8
  %.1859 = load i64, ptr %sunkaddr31, align 8
  store i64 0, ptr %.1861, align 8
  call fastcc void @inner_1(ptr nonnull %.1861, ptr %.1321, double %.1797, double %.1829, ptr %.1528, ptr %.1729, i64 %.1859)
  %.1881 = load i64, ptr %.1861, align 8
  %20 = getelementptr i8, ptr %13, i64 %.114211191121
  %.1931 = trunc i64 %.1881 to i8
  store i8 %.1931, ptr %20, align 1
  %.1934 = icmp eq i64 %.1881, 0
  br i1 %.1934, label %B1172, label %B1266

B1508.if:                                         ; preds = %B1508.backedge, %B1464
  %lsr.iv25 = phi i64 [ %lsr.iv.next26, %B1508.backedge ], [ %4, %B1464 ]
  %.228611291132 = phi i64 [ %21, %B1508.backedge ], [ 0, %B1464 ]
  %21 = add nuw i64 %.228611291132, 8
  %.13.i = tail call i64 @llvm.smin.i64(i64 %.697, i64 %21)
  store ptr null, ptr %.2356, align 8
  %.2374 = call fastcc i32 @inner_2(ptr nonnull %.2356, ptr nonnull %excinfo.11, i64 %.228611291132, i64 %.13.i, ptr nonnull %arg.arguments.4, ptr %sunkaddr, ptr %11, ptr %12, ptr %13, i64 %.697, ptr %14, i64 %.697, ptr %6, i64 %.986)
  %cond = icmp eq i32 %.2374, 0
  br i1 %cond, label %B1508.backedge, label %B1510.endif.if, !prof !0

B1508.backedge:                                   ; preds = %B1508.if
  %lsr.iv.next26 = add nsw i64 %lsr.iv25, -1
  %.2280 = icmp sgt i64 %lsr.iv25, 3
  br i1 %.2280, label %B1508.if, label %B1604

B1510.endif.if:                                   ; preds = %B1508.if
  %.2375 = load ptr, ptr %excinfo.11, align 8
  store ptr %.2375, ptr %excinfo, align 8
  br label %common.ret
}

; Function Attrs: mustprogress nocallback nocreateundeforpoison nofree nosync nounwind speculatable willreturn memory(none)
declare i64 @llvm.smax.i64(i64, i64) #3

; Function Attrs: mustprogress nocallback nocreateundeforpoison nofree nosync nounwind speculatable willreturn memory(none)
declare double @llvm.cos.f64(double) #3

; Function Attrs: mustprogress nofree noinline norecurse nosync nounwind willreturn memory(argmem: readwrite)
define internal fastcc void @inner_1(ptr noalias nonnull writeonly captures(none) initializes((0, 8)) %retptr, ptr readonly captures(none) %arg.row.4, double %arg.first, double %arg.last, ptr readonly captures(none) %arg.limits.4, ptr readonly captures(none) %arg.band.4, i64 %arg.policy) unnamed_addr #4 {
entry:
  %.210 = load double, ptr %arg.row.4, align 8
  %.218.le = fsub contract double %.210, %.210
  %.219.le = fcmp contract ord double %.218.le, 0.000000e+00
  br i1 %.219.le, label %B142, label %common.ret

common.ret:                                       ; preds = %B250, %entry, %B142, %B142.1, %B142.2, %B142.3, %B142.4, %B142.5, %B142.6, %B142.7, %B142.8, %B788
  %..sink = phi i64 [ %., %B788 ], [ 1, %entry ], [ 1, %B142.8 ], [ 1, %B142.7 ], [ 1, %B142.6 ], [ 1, %B142.5 ], [ 1, %B142.4 ], [ 1, %B142.3 ], [ 1, %B142.2 ], [ 1, %B142.1 ], [ 1, %B142 ], [ 2, %B250 ]
  store i64 %..sink, ptr %retptr, align 8
  ret void

B142:                                             ; preds = %entry
  %0 = getelementptr i8, ptr %arg.row.4, i64 8
  %.210.1 = load double, ptr %0, align 8
  %.218.le.1 = fsub contract double %.210.1, %.210.1
  %.219.le.1 = fcmp contract ord double %.218.le.1, 0.000000e+00
  br i1 %.219.le.1, label %B142.1, label %common.ret

B142.1:                                           ; preds = %B142
  %1 = getelementptr i8, ptr %arg.row.4, i64 16
  %.210.2 = load double, ptr %1, align 8
  %.218.le.2 = fsub contract double %.210.2, %.210.2
  %.219.le.2 = fcmp contract ord double %.218.le.2, 0.000000e+00
  br i1 %.219.le.2, label %B142.2, label %common.ret

B142.2:                                           ; preds = %B142.1
  %2 = getelementptr i8, ptr %arg.row.4, i64 24
  %.210.3 = load double, ptr %2, align 8
  %.218.le.3 = fsub contract double %.210.3, %.210.3
  %.219.le.3 = fcmp contract ord double %.218.le.3, 0.000000e+00
  br i1 %.219.le.3, label %B142.3, label %common.ret

B142.3:                                           ; preds = %B142.2
  %3 = getelementptr i8, ptr %arg.row.4, i64 32
  %.210.4 = load double, ptr %3, align 8
  %.218.le.4 = fsub contract double %.210.4, %.210.4
  %.219.le.4 = fcmp contract ord double %.218.le.4, 0.000000e+00
  br i1 %.219.le.4, label %B142.4, label %common.ret

B142.4:                                           ; preds = %B142.3
  %4 = getelementptr i8, ptr %arg.row.4, i64 40
  %.210.5 = load double, ptr %4, align 8
  %.218.le.5 = fsub contract double %.210.5, %.210.5
  %.219.le.5 = fcmp contract ord double %.218.le.5, 0.000000e+00
  br i1 %.219.le.5, label %B142.5, label %common.ret

B142.5:                                           ; preds = %B142.4
  %5 = getelementptr i8, ptr %arg.row.4, i64 48
  %.210.6 = load double, ptr %5, align 8
  %.218.le.6 = fsub contract double %.210.6, %.210.6
  %.219.le.6 = fcmp contract ord double %.218.le.6, 0.000000e+00
  br i1 %.219.le.6, label %B142.6, label %common.ret

B142.6:                                           ; preds = %B142.5
  %6 = getelementptr i8, ptr %arg.row.4, i64 56
  %.210.7 = load double, ptr %6, align 8
  %.218.le.7 = fsub contract double %.210.7, %.210.7
  %.219.le.7 = fcmp contract ord double %.218.le.7, 0.000000e+00
  br i1 %.219.le.7, label %B142.7, label %common.ret

B142.7:                                           ; preds = %B142.6
  %7 = getelementptr i8, ptr %arg.row.4, i64 64
  %.210.8 = load double, ptr %7, align 8
  %.218.le.8 = fsub contract double %.210.8, %.210.8
  %.219.le.8 = fcmp contract ord double %.218.le.8, 0.000000e+00
  br i1 %.219.le.8, label %B142.8, label %common.ret

B142.8:                                           ; preds = %B142.7
  %8 = getelementptr i8, ptr %arg.row.4, i64 72
  %.210.9 = load double, ptr %8, align 8
  %.218.le.9 = fsub contract double %.210.9, %.210.9
  %.219.le.9 = fcmp contract ord double %.218.le.9, 0.000000e+00
  br i1 %.219.le.9, label %B250, label %common.ret

B250:                                             ; preds = %B142.8
  %.324 = load double, ptr %arg.limits.4, align 8
  %.325 = fcmp contract oge double %.210, %.324
  %9 = getelementptr i8, ptr %arg.limits.4, i64 80
  %.390 = load double, ptr %9, align 8
  %.391 = fcmp contract ole double %.210, %.390
  %.392 = and i1 %.325, %.391
  %10 = getelementptr i8, ptr %arg.limits.4, i64 8
  %.324.1 = load double, ptr %10, align 8
  %.325.1 = fcmp contract oge double %.210.1, %.324.1
  %11 = getelementptr i8, ptr %arg.limits.4, i64 88
  %.390.1 = load double, ptr %11, align 8
  %.391.1 = fcmp contract ole double %.210.1, %.390.1
  %.392.1 = and i1 %.325.1, %.391.1
  %.394.1 = and i1 %.392, %.392.1
  %12 = getelementptr i8, ptr %arg.limits.4, i64 16
  %.324.2 = load double, ptr %12, align 8
  %.325.2 = fcmp contract oge double %.210.2, %.324.2
  %13 = getelementptr i8, ptr %arg.limits.4, i64 96
  %.390.2 = load double, ptr %13, align 8
  %.391.2 = fcmp contract ole double %.210.2, %.390.2
  %.392.2 = and i1 %.325.2, %.391.2
  %.394.2 = and i1 %.394.1, %.392.2
  %14 = getelementptr i8, ptr %arg.limits.4, i64 24
  %.324.3 = load double, ptr %14, align 8
  %.325.3 = fcmp contract oge double %.210.3, %.324.3
  %15 = getelementptr i8, ptr %arg.limits.4, i64 104
  %.390.3 = load double, ptr %15, align 8
  %.391.3 = fcmp contract ole double %.210.3, %.390.3
  %.392.3 = and i1 %.325.3, %.391.3
  %.394.3 = and i1 %.394.2, %.392.3
  %16 = getelementptr i8, ptr %arg.limits.4, i64 32
  %.324.4 = load double, ptr %16, align 8
  %.325.4 = fcmp contract oge double %.210.4, %.324.4
  %17 = getelementptr i8, ptr %arg.limits.4, i64 112
  %.390.4 = load double, ptr %17, align 8
  %.391.4 = fcmp contract ole double %.210.4, %.390.4
  %.392.4 = and i1 %.325.4, %.391.4
  %.394.4 = and i1 %.394.3, %.392.4
  %18 = getelementptr i8, ptr %arg.limits.4, i64 40
  %.324.5 = load double, ptr %18, align 8
  %.325.5 = fcmp contract oge double %.210.5, %.324.5
  %19 = getelementptr i8, ptr %arg.limits.4, i64 120
  %.390.5 = load double, ptr %19, align 8
  %.391.5 = fcmp contract ole double %.210.5, %.390.5
  %.392.5 = and i1 %.325.5, %.391.5
  %.394.5 = and i1 %.394.4, %.392.5
  %20 = getelementptr i8, ptr %arg.limits.4, i64 48
  %.324.6 = load double, ptr %20, align 8
  %.325.6 = fcmp contract oge double %.210.6, %.324.6
  %21 = getelementptr i8, ptr %arg.limits.4, i64 128
  %.390.6 = load double, ptr %21, align 8
  %.391.6 = fcmp contract ole double %.210.6, %.390.6
  %.392.6 = and i1 %.325.6, %.391.6
  %.394.6 = and i1 %.394.5, %.392.6
  %22 = getelementptr i8, ptr %arg.limits.4, i64 56
  %.324.7 = load double, ptr %22, align 8
  %.325.7 = fcmp contract oge double %.210.7, %.324.7
  %23 = getelementptr i8, ptr %arg.limits.4, i64 136
  %.390.7 = load double, ptr %23, align 8
  %.391.7 = fcmp contract ole double %.210.7, %.390.7
  %.392.7 = and i1 %.325.7, %.391.7
  %.394.7 = and i1 %.394.6, %.392.7
  %24 = getelementptr i8, ptr %arg.limits.4, i64 64
  %.324.8 = load double, ptr %24, align 8
  %.325.8 = fcmp contract oge double %.210.8, %.324.8
  %25 = getelementptr i8, ptr %arg.limits.4, i64 144
  %.390.8 = load double, ptr %25, align 8
  %.391.8 = fcmp contract ole double %.210.8, %.390.8
  %.392.8 = and i1 %.325.8, %.391.8
  %.394.8 = and i1 %.394.7, %.392.8
  %26 = getelementptr i8, ptr %arg.limits.4, i64 72
  %.324.9 = load double, ptr %26, align 8
  %.325.9 = fcmp contract oge double %.210.9, %.324.9
  %27 = getelementptr i8, ptr %arg.limits.4, i64 152
  %.390.9 = load double, ptr %27, align 8
  %.391.9 = fcmp contract ole double %.210.9, %.390.9
  %.392.9 = and i1 %.325.9, %.391.9
  %.394.9 = and i1 %.394.8, %.392.9
  %.437 = fcmp contract ogt double %.210.5, 0.000000e+00
  %.472 = tail call contract double @llvm.fabs.f64(double %.210.8)
  %.475 = fmul contract double %arg.last, 0x401921FB54442D18
  %.506 = tail call contract double @llvm.fabs.f64(double %.210.9)
  %.507 = fmul contract double %.475, %.506
  %.508 = fadd contract double %.472, %.507
  %.509 = fcmp contract ole double %.508, 1.000000e+14
  %28 = and i1 %.437, %.509
  %.510 = and i1 %28, %.394.9
  br i1 %.510, label %B516, label %common.ret

B516:                                             ; preds = %B250
  %.565 = fmul contract double %.210.7, 0x3ED4A8B4A9ED04E3
  %.571 = fmul contract double %arg.first, %.565
  %.572 = fcmp olt double %.571, 1.000000e-09
  %.581 = and i64 %arg.policy, 2
  %.582.not = icmp eq i64 %.581, 0
  br i1 %.582.not, label %B692, label %B634

B634:                                             ; preds = %B516
  %.586 = fmul contract double %arg.last, %.565
  %.617 = getelementptr i8, ptr %arg.band.4, i64 8
  %.618 = load double, ptr %.617, align 8
  %.620 = fmul contract double %.618, 0x3FF000000044B830
  %.621 = fcmp contract ogt double %.586, %.620
  %.623 = or i1 %.572, %.621
  br label %B692

B692:                                             ; preds = %B634, %B516
  %outside.3.0 = phi i1 [ %.623, %B634 ], [ %.572, %B516 ]
  %.638 = and i64 %arg.policy, 1
  %.641.not = icmp eq i64 %.638, 0
  br i1 %.641.not, label %B788, label %B730

B730:                                             ; preds = %B692
  %.679 = load double, ptr %arg.band.4, align 8
  %.686 = fmul contract double %.679, 0x3FEFFFFFFF768FA1
  %.687 = fcmp contract olt double %.571, %.686
  %.689 = or i1 %outside.3.0, %.687
  br label %B788

B788:                                             ; preds = %B730, %B692
  %outside.4.0 = phi i1 [ %.689, %B730 ], [ %outside.3.0, %B692 ]
  %. = select i1 %outside.4.0, i64 3, i64 0
  br label %common.ret
}

; Function Attrs: mustprogress nocallback nocreateundeforpoison nofree nosync nounwind speculatable willreturn memory(none)
declare i64 @llvm.smin.i64(i64, i64) #3

; Function Attrs: nofree noinline norecurse nosync nounwind memory(readwrite, inaccessiblemem: none, target_mem0: none, target_mem1: none)
define internal fastcc noundef range(i32 0, 2) i32 @inner_2(ptr noalias nonnull writeonly captures(none) %retptr, ptr noalias nonnull writeonly captures(none) %excinfo, i64 %arg.start, i64 %arg.stop, ptr readonly captures(none) %arg.arguments.4, ptr readonly captures(none) %arg.contents.4, ptr readonly captures(none) %arg.weights.4, ptr readonly captures(none) %arg.parameters.4, ptr readonly captures(none) %arg.status.4, i64 range(i64 1, -9223372036854775808) %arg.status.5.0, ptr readonly captures(none) %arg.plus.4, i64 range(i64 1, -9223372036854775808) %arg.plus.5.0, ptr readonly captures(none) %arg.cross.4, i64 range(i64 -9223372036854775808, 9223372036854775807) %arg.cross.5.0) unnamed_addr #5 {
entry:
  %.1174 = alloca { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, align 8
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(56) %.1174, i8 0, i64 56, i1 false)
  %.2463 = alloca ptr, align 8
  store ptr null, ptr %.2463, align 8
  %excinfo.16 = alloca ptr, align 8
  store ptr null, ptr %excinfo.16, align 8
  %.2511 = alloca ptr, align 8
  store ptr null, ptr %.2511, align 8
  %.137 = getelementptr i8, ptr %arg.arguments.4, i64 104
  %.138 = load i64, ptr %.137, align 8
  %0 = inttoptr i64 %.138 to ptr
  %.385 = add nsw i64 %arg.stop, -1
  %.13.i = tail call i64 @llvm.smin.i64(i64 %.385, i64 %arg.start)
  %.425.idx = mul nsw i64 %.13.i, 80
  %.425 = getelementptr inbounds i8, ptr %arg.parameters.4, i64 %.425.idx
  %.504 = load double, ptr %.425, align 8
  %.532 = getelementptr i8, ptr %.425, i64 24
  %.533 = load double, ptr %.532, align 8
  %scevgep224 = getelementptr i8, ptr %0, i64 32
  store double %.504, ptr %0, align 8
  %scevgep226 = getelementptr i8, ptr %0, i64 8
  store double %.533, ptr %scevgep226, align 8
  %.624 = getelementptr i8, ptr %.425, i64 32
  %.625 = load double, ptr %.624, align 8
  %.653 = getelementptr i8, ptr %.425, i64 8
  %.654 = load double, ptr %.653, align 8
  %scevgep228 = getelementptr i8, ptr %0, i64 16
  store double %.625, ptr %scevgep228, align 8
  %scevgep229 = getelementptr i8, ptr %0, i64 24
  store double %.654, ptr %scevgep229, align 8
  %.746 = getelementptr i8, ptr %.425, i64 16
  %.747 = load double, ptr %.746, align 8
  store double %.747, ptr %scevgep224, align 8
  %lsr.iv.next232 = add i64 %arg.start, 1
  %.13.i.1 = tail call i64 @llvm.smin.i64(i64 %.385, i64 %lsr.iv.next232)
  %.425.idx.1 = mul nsw i64 %.13.i.1, 80
  %.425.1 = getelementptr inbounds i8, ptr %arg.parameters.4, i64 %.425.idx.1
  %.504.1 = load double, ptr %.425.1, align 8
  %.532.1 = getelementptr i8, ptr %.425.1, i64 24
  %.533.1 = load double, ptr %.532.1, align 8
  %scevgep224.1 = getelementptr i8, ptr %0, i64 72
  %scevgep225.1 = getelementptr i8, ptr %0, i64 40
  store double %.504.1, ptr %scevgep225.1, align 8
  %scevgep226.1 = getelementptr i8, ptr %0, i64 48
  store double %.533.1, ptr %scevgep226.1, align 8
  %.624.1 = getelementptr i8, ptr %.425.1, i64 32
  %.625.1 = load double, ptr %.624.1, align 8
  %.653.1 = getelementptr i8, ptr %.425.1, i64 8
  %.654.1 = load double, ptr %.653.1, align 8
  %scevgep228.1 = getelementptr i8, ptr %0, i64 56
  store double %.625.1, ptr %scevgep228.1, align 8
  %scevgep229.1 = getelementptr i8, ptr %0, i64 64
  store double %.654.1, ptr %scevgep229.1, align 8
  %.746.1 = getelementptr i8, ptr %.425.1, i64 16
  %.747.1 = load double, ptr %.746.1, align 8
  store double %.747.1, ptr %scevgep224.1, align 8
  %lsr.iv.next232.1 = add i64 %arg.start, 2
  %.13.i.2 = tail call i64 @llvm.smin.i64(i64 %.385, i64 %lsr.iv.next232.1)
  %.425.idx.2 = mul nsw i64 %.13.i.2, 80
  %.425.2 = getelementptr inbounds i8, ptr %arg.parameters.4, i64 %.425.idx.2
  %.504.2 = load double, ptr %.425.2, align 8
  %.532.2 = getelementptr i8, ptr %.425.2, i64 24
  %.533.2 = load double, ptr %.532.2, align 8
  %scevgep224.2 = getelementptr i8, ptr %0, i64 112
  %scevgep225.2 = getelementptr i8, ptr %0, i64 80
  store double %.504.2, ptr %scevgep225.2, align 8
  %scevgep226.2 = getelementptr i8, ptr %0, i64 88
  store double %.533.2, ptr %scevgep226.2, align 8
  %.624.2 = getelementptr i8, ptr %.425.2, i64 32
  %.625.2 = load double, ptr %.624.2, align 8
  %.653.2 = getelementptr i8, ptr %.425.2, i64 8
  %.654.2 = load double, ptr %.653.2, align 8
  %scevgep228.2 = getelementptr i8, ptr %0, i64 96
  store double %.625.2, ptr %scevgep228.2, align 8
  %scevgep229.2 = getelementptr i8, ptr %0, i64 104
  store double %.654.2, ptr %scevgep229.2, align 8
  %.746.2 = getelementptr i8, ptr %.425.2, i64 16
  %.747.2 = load double, ptr %.746.2, align 8
  store double %.747.2, ptr %scevgep224.2, align 8
  %lsr.iv.next232.2 = add i64 %arg.start, 3
  %.13.i.3 = tail call i64 @llvm.smin.i64(i64 %.385, i64 %lsr.iv.next232.2)
  %.425.idx.3 = mul nsw i64 %.13.i.3, 80
  %.425.3 = getelementptr inbounds i8, ptr %arg.parameters.4, i64 %.425.idx.3
  %.504.3 = load double, ptr %.425.3, align 8
  %.532.3 = getelementptr i8, ptr %.425.3, i64 24
  %.533.3 = load double, ptr %.532.3, align 8
  %scevgep224.3 = getelementptr i8, ptr %0, i64 152
  %scevgep225.3 = getelementptr i8, ptr %0, i64 120
  store double %.504.3, ptr %scevgep225.3, align 8
  %scevgep226.3 = getelementptr i8, ptr %0, i64 128
  store double %.533.3, ptr %scevgep226.3, align 8
  %.624.3 = getelementptr i8, ptr %.425.3, i64 32
  %.625.3 = load double, ptr %.624.3, align 8
  %.653.3 = getelementptr i8, ptr %.425.3, i64 8
  %.654.3 = load double, ptr %.653.3, align 8
  %scevgep228.3 = getelementptr i8, ptr %0, i64 136
  store double %.625.3, ptr %scevgep228.3, align 8
  %scevgep229.3 = getelementptr i8, ptr %0, i64 144
  store double %.654.3, ptr %scevgep229.3, align 8
  %.746.3 = getelementptr i8, ptr %.425.3, i64 16
  %.747.3 = load double, ptr %.746.3, align 8
  store double %.747.3, ptr %scevgep224.3, align 8
  %lsr.iv.next232.3 = add i64 %arg.start, 4
  %.13.i.4 = tail call i64 @llvm.smin.i64(i64 %.385, i64 %lsr.iv.next232.3)
  %.425.idx.4 = mul nsw i64 %.13.i.4, 80
  %.425.4 = getelementptr inbounds i8, ptr %arg.parameters.4, i64 %.425.idx.4
  %.504.4 = load double, ptr %.425.4, align 8
  %.532.4 = getelementptr i8, ptr %.425.4, i64 24
  %.533.4 = load double, ptr %.532.4, align 8
  %scevgep224.4 = getelementptr i8, ptr %0, i64 192
  %scevgep225.4 = getelementptr i8, ptr %0, i64 160
  store double %.504.4, ptr %scevgep225.4, align 8
  %scevgep226.4 = getelementptr i8, ptr %0, i64 168
  store double %.533.4, ptr %scevgep226.4, align 8
  %.624.4 = getelementptr i8, ptr %.425.4, i64 32
  %.625.4 = load double, ptr %.624.4, align 8
  %.653.4 = getelementptr i8, ptr %.425.4, i64 8
  %.654.4 = load double, ptr %.653.4, align 8
  %scevgep228.4 = getelementptr i8, ptr %0, i64 176
  store double %.625.4, ptr %scevgep228.4, align 8
  %scevgep229.4 = getelementptr i8, ptr %0, i64 184
  store double %.654.4, ptr %scevgep229.4, align 8
  %.746.4 = getelementptr i8, ptr %.425.4, i64 16
  %.747.4 = load double, ptr %.746.4, align 8
  store double %.747.4, ptr %scevgep224.4, align 8
  %lsr.iv.next232.4 = add i64 %arg.start, 5
  %.13.i.5 = tail call i64 @llvm.smin.i64(i64 %.385, i64 %lsr.iv.next232.4)
  %.425.idx.5 = mul nsw i64 %.13.i.5, 80
  %.425.5 = getelementptr inbounds i8, ptr %arg.parameters.4, i64 %.425.idx.5
  %.504.5 = load double, ptr %.425.5, align 8
  %.532.5 = getelementptr i8, ptr %.425.5, i64 24
  %.533.5 = load double, ptr %.532.5, align 8
  %scevgep224.5 = getelementptr i8, ptr %0, i64 232
  %scevgep225.5 = getelementptr i8, ptr %0, i64 200
  store double %.504.5, ptr %scevgep225.5, align 8
  %scevgep226.5 = getelementptr i8, ptr %0, i64 208
  store double %.533.5, ptr %scevgep226.5, align 8
  %.624.5 = getelementptr i8, ptr %.425.5, i64 32
  %.625.5 = load double, ptr %.624.5, align 8
  %.653.5 = getelementptr i8, ptr %.425.5, i64 8
  %.654.5 = load double, ptr %.653.5, align 8
  %scevgep228.5 = getelementptr i8, ptr %0, i64 216
  store double %.625.5, ptr %scevgep228.5, align 8
  %scevgep229.5 = getelementptr i8, ptr %0, i64 224
  store double %.654.5, ptr %scevgep229.5, align 8
  %.746.5 = getelementptr i8, ptr %.425.5, i64 16
  %.747.5 = load double, ptr %.746.5, align 8
  store double %.747.5, ptr %scevgep224.5, align 8
  %lsr.iv.next232.5 = add i64 %arg.start, 6
  %.13.i.6 = tail call i64 @llvm.smin.i64(i64 %.385, i64 %lsr.iv.next232.5)
  %.425.idx.6 = mul nsw i64 %.13.i.6, 80
  %.425.6 = getelementptr inbounds i8, ptr %arg.parameters.4, i64 %.425.idx.6
  %.504.6 = load double, ptr %.425.6, align 8
  %.532.6 = getelementptr i8, ptr %.425.6, i64 24
  %.533.6 = load double, ptr %.532.6, align 8
  %scevgep224.6 = getelementptr i8, ptr %0, i64 272
  %scevgep225.6 = getelementptr i8, ptr %0, i64 240
  store double %.504.6, ptr %scevgep225.6, align 8
  %scevgep226.6 = getelementptr i8, ptr %0, i64 248
  store double %.533.6, ptr %scevgep226.6, align 8
  %.624.6 = getelementptr i8, ptr %.425.6, i64 32
  %.625.6 = load double, ptr %.624.6, align 8
  %.653.6 = getelementptr i8, ptr %.425.6, i64 8
  %.654.6 = load double, ptr %.653.6, align 8
  %scevgep228.6 = getelementptr i8, ptr %0, i64 256
  store double %.625.6, ptr %scevgep228.6, align 8
  %scevgep229.6 = getelementptr i8, ptr %0, i64 264
  store double %.654.6, ptr %scevgep229.6, align 8
  %.746.6 = getelementptr i8, ptr %.425.6, i64 16
  %.747.6 = load double, ptr %.746.6, align 8
  store double %.747.6, ptr %scevgep224.6, align 8
  %lsr.iv.next232.6 = add i64 %arg.start, 7
  %.13.i.7 = tail call i64 @llvm.smin.i64(i64 %.385, i64 %lsr.iv.next232.6)
  %.425.idx.7 = mul nsw i64 %.13.i.7, 80
  %.425.7 = getelementptr inbounds i8, ptr %arg.parameters.4, i64 %.425.idx.7
  %.504.7 = load double, ptr %.425.7, align 8
  %.532.7 = getelementptr i8, ptr %.425.7, i64 24
  %.533.7 = load double, ptr %.532.7, align 8
  %scevgep224.7 = getelementptr i8, ptr %0, i64 312
  %scevgep225.7 = getelementptr i8, ptr %0, i64 280
  store double %.504.7, ptr %scevgep225.7, align 8
  %scevgep226.7 = getelementptr i8, ptr %0, i64 288
  store double %.533.7, ptr %scevgep226.7, align 8
  %.624.7 = getelementptr i8, ptr %.425.7, i64 32
  %.625.7 = load double, ptr %.624.7, align 8
  %.653.7 = getelementptr i8, ptr %.425.7, i64 8
  %.654.7 = load double, ptr %.653.7, align 8
  %scevgep228.7 = getelementptr i8, ptr %0, i64 296
  store double %.625.7, ptr %scevgep228.7, align 8
  %scevgep229.7 = getelementptr i8, ptr %0, i64 304
  store double %.654.7, ptr %scevgep229.7, align 8
  %.746.7 = getelementptr i8, ptr %.425.7, i64 16
  %.747.7 = load double, ptr %.746.7, align 8
  store double %.747.7, ptr %scevgep224.7, align 8
  %.fca.4.gep568 = getelementptr inbounds nuw i8, ptr %.1174, i64 32
  %.816 = getelementptr i8, ptr %arg.contents.4, i64 56
  %.817 = load i64, ptr %.816, align 8
  %.819 = add i64 %.817, 7
  %.860 = and i64 %.819, -8
  %.889 = getelementptr i8, ptr %arg.contents.4, i64 64
  %.890 = load i64, ptr %.889, align 8
  %.892 = add i64 %.890, 7
  %.933 = and i64 %.892, -8
  %.934 = add nsw i64 %.933, %.860
  %.935 = shl nsw i64 %.934, 1
  %.936 = or disjoint i64 %.935, 8
  %.954 = getelementptr i8, ptr %0, i64 320
  %.idx = shl i64 %.934, 7
  %1 = getelementptr i8, ptr %0, i64 %.idx
  %.1030 = getelementptr i8, ptr %1, i64 832
  %.1116 = getelementptr i8, ptr %arg.arguments.4, i64 72
  %.1117 = load i64, ptr %.1116, align 8
  %.1118 = inttoptr i64 %.1117 to ptr
  %.1169 = sub i64 %arg.stop, %arg.start
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(56) %.1174, i8 0, i64 56, i1 false)
  call fastcc void @inner_3(ptr nonnull %.1174, ptr %0, i64 %.1169, ptr %arg.contents.4, ptr %.1118, ptr %arg.weights.4, ptr %.1030)
  %.1198.fca.4.load = load ptr, ptr %.fca.4.gep568, align 8
  %.fca.5.0.gep569 = getelementptr inbounds nuw i8, ptr %.1174, i64 40
  %.1198.fca.5.0.load = load i64, ptr %.fca.5.0.gep569, align 8
  %.1261 = getelementptr i8, ptr %arg.contents.4, i64 24
  %.1262 = load i64, ptr %.1261, align 8
  %.1264 = add i64 %.1262, 7
  %.1305 = and i64 %.1264, -8
  %.1306 = add i64 %.1305, 8
  %.1339 = getelementptr i8, ptr %arg.contents.4, i64 104
  %.1340 = load i64, ptr %.1339, align 8
  %.1351 = getelementptr double, ptr %arg.weights.4, i64 %.1340
  %2 = add nuw i64 %.1169, 3
  %.1469 = lshr i64 %2, 2
  %.1448.inv = icmp slt i64 %.1169, 1
  %.14901404.not1442 = icmp eq i64 %.1469, 0
  %.14901404.not = select i1 %.1448.inv, i1 true, i1 %.14901404.not1442
  br i1 %.14901404.not, label %B1468, label %B1258.if.preheader

B1468:                                            ; preds = %B1260.endif.endif.endif, %entry
  %.1768 = getelementptr i8, ptr %arg.arguments.4, i64 160
  %.1769 = load i64, ptr %.1768, align 8
  %.1770.not = icmp eq i64 %.1769, 0
  br i1 %.1770.not, label %B1744, label %B1512

B1512:                                            ; preds = %B1468
  br i1 %.1448.inv, label %B2069, label %B1608.if.preheader

B1608.if.preheader:                               ; preds = %B1512
  %3 = add nuw i64 %.1169, 1
  %4 = shl i64 %arg.stop, 3
  %5 = inttoptr i64 %.1769 to ptr
  br label %B1608.if

B1744:                                            ; preds = %B1468
  br i1 %.1448.inv, label %B2069, label %B1776.if.preheader

B1776.if.preheader:                               ; preds = %B1608.if, %B1744
  %6 = add i64 %.1169, 1
  %7 = shl i64 %arg.start, 4
  %8 = getelementptr i8, ptr %arg.cross.4, i64 %7
  %scevgep = getelementptr i8, ptr %8, i64 8
  %9 = mul i64 %arg.start, 80
  %scevgep178 = getelementptr i8, ptr %arg.parameters.4, i64 %9
  %10 = shl i64 %.892, 1
  %11 = and i64 %10, 2305843009213693936
  %12 = shl i64 %.819, 1
  %13 = and i64 %12, 2305843009213693936
  %14 = add nuw nsw i64 %11, %13
  %15 = shl i64 %14, 3
  %16 = shl i64 %arg.plus.5.0, 3
  %17 = shl i64 %arg.cross.5.0, 3
  br label %B1776.if

B1824:                                            ; preds = %B1776.if
  %18 = select i1 %.2241, i64 %16, i64 0
  %scevgep176 = getelementptr i8, ptr %arg.plus.4, i64 %18
  %19 = shl i64 %.219214211426, 3
  %scevgep177 = getelementptr i8, ptr %scevgep176, i64 %19
  %.2424 = load double, ptr %scevgep177, align 8
  %20 = select i1 %.2241, i64 %17, i64 0
  %scevgep175 = getelementptr i8, ptr %lsr.iv173, i64 %20
  %.2457 = load double, ptr %scevgep175, align 8
  store ptr null, ptr %.2463, align 8
  %.2479 = call fastcc i32 @inner_4(ptr nonnull %.2463, ptr nonnull %excinfo.16, i64 %.219214211426, ptr %lsr.iv179, ptr nonnull %lsr.iv183, i64 %.936, ptr %arg.arguments.4, ptr %arg.contents.4, ptr %arg.weights.4, ptr %.1030, double %.2424, double %.2457)
  %cond = icmp eq i32 %.2479, 0
  br i1 %cond, label %B2068, label %B1824.endif.endif.if, !prof !0

B2034:                                            ; preds = %B1776.if
  store ptr null, ptr %.2511, align 8
  call fastcc void @inner_5(ptr nonnull %.2511, i64 %.219214211426, ptr %arg.arguments.4)
  br label %B2068

B2068:                                            ; preds = %B1824, %B2034
  %lsr.iv.next = add i64 %lsr.iv, -1
  %scevgep174 = getelementptr i8, ptr %lsr.iv173, i64 16
  %scevgep180 = getelementptr i8, ptr %lsr.iv179, i64 80
  %21 = getelementptr i8, ptr %lsr.iv183, i64 %15
  %scevgep184 = getelementptr i8, ptr %21, i64 64
  %.2199 = add i64 %.219214211426, 1
  %.2186 = icmp sgt i64 %lsr.iv.next, 1
  br i1 %.2186, label %B1776.if, label %B2069

common.ret:                                       ; preds = %B1824.endif.endif.if, %B2069
  %common.ret.op = phi i32 [ 0, %B2069 ], [ %.2479, %B1824.endif.endif.if ]
  ret i32 %common.ret.op

B2069:                                            ; preds = %B2068, %B1512, %B1744
  store ptr null, ptr %retptr, align 8
  br label %common.ret

B1258.if.preheader:                               ; preds = %entry
  %22 = tail call i64 @llvm.smax.i64(i64 %.936, i64 31)
  %storemerge.i = lshr i64 %22, 5
  %.951.i = and i64 %.935, -32
  %.991.i = lshr exact i64 %.936, 3
  %.1011678.i = and i64 %.991.i, 3
  %.idx.i = shl i64 %.936, 4
  %.idx681.i = mul i64 %.936, 24
  %scevgep8.i = getelementptr i8, ptr %.1351, i64 192
  %23 = lshr i64 %.1264, 3
  %24 = mul i64 %23, 192
  %25 = getelementptr i8, ptr %.1198.fca.4.load, i64 %24
  %scevgep193 = getelementptr i8, ptr %25, i64 248
  %26 = shl i64 %23, 8
  %27 = add i64 %26, 256
  %28 = shl i64 %23, 7
  %29 = getelementptr i8, ptr %.1198.fca.4.load, i64 %28
  %scevgep198 = getelementptr i8, ptr %29, i64 184
  %30 = shl i64 %23, 6
  %31 = getelementptr i8, ptr %.1198.fca.4.load, i64 %30
  %scevgep203 = getelementptr i8, ptr %31, i64 120
  %32 = icmp eq i64 %storemerge.i, 0
  br label %B1258.if

B1258.if:                                         ; preds = %B1260.endif.endif.endif, %B1258.if.preheader
  %lsr.iv208 = phi ptr [ %.1198.fca.4.load, %B1258.if.preheader ], [ %scevgep209, %B1260.endif.endif.endif ]
  %lsr.iv204 = phi ptr [ %scevgep203, %B1258.if.preheader ], [ %scevgep205, %B1260.endif.endif.endif ]
  %lsr.iv199 = phi ptr [ %scevgep198, %B1258.if.preheader ], [ %scevgep200, %B1260.endif.endif.endif ]
  %lsr.iv194 = phi ptr [ %scevgep193, %B1258.if.preheader ], [ %scevgep195, %B1260.endif.endif.endif ]
  %.148913981406 = phi i64 [ %.1469, %B1258.if.preheader ], [ %.1499, %B1260.endif.endif.endif ]
  %.149614011405 = phi i64 [ 0, %B1258.if.preheader ], [ %.1503, %B1260.endif.endif.endif ]
  %.1499 = add nsw i64 %.148913981406, -1
  %.1503 = add nuw i64 %.149614011405, 4
  %.1596 = mul nsw i64 %.149614011405, %.936
  %.1607 = getelementptr inbounds double, ptr %.954, i64 %.1596
  %.1688 = load i64, ptr %.1261, align 8
  %.1689 = add i64 %.1688, 1
  br i1 %32, label %B2140.else.i, label %B86.if.lr.ph.i

B86.if.lr.ph.i:                                   ; preds = %B1258.if
  %.arg.count.i = tail call i64 @llvm.smax.i64(i64 %.1689, i64 0)
  %33 = shl i64 %.arg.count.i, 5
  %34 = icmp slt i64 %.1688, 0
  br label %B86.if.i

B1232.loopexit.i:                                 ; preds = %B290.if.i
  %35 = add i64 %position.4.0737.i, %33
  br label %B1232.i

B1232.i:                                          ; preds = %B86.if.i, %B1232.loopexit.i
  %position.3.1.lcssa.i = phi i64 [ %position.4.0737.i, %B86.if.i ], [ %35, %B1232.loopexit.i ]
  %a00.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B86.if.i ], [ %.477.i, %B1232.loopexit.i ]
  %a01.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B86.if.i ], [ %.481.i, %B1232.loopexit.i ]
  %a02.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B86.if.i ], [ %.489.i, %B1232.loopexit.i ]
  %a03.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B86.if.i ], [ %.493.i, %B1232.loopexit.i ]
  %a10.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B86.if.i ], [ %.514.i, %B1232.loopexit.i ]
  %a11.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B86.if.i ], [ %.518.i, %B1232.loopexit.i ]
  %a12.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B86.if.i ], [ %.526.i, %B1232.loopexit.i ]
  %a13.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B86.if.i ], [ %.530.i, %B1232.loopexit.i ]
  %a20.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B86.if.i ], [ %.552.i, %B1232.loopexit.i ]
  %a21.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B86.if.i ], [ %.556.i, %B1232.loopexit.i ]
  %a22.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B86.if.i ], [ %.564.i, %B1232.loopexit.i ]
  %a23.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B86.if.i ], [ %.568.i, %B1232.loopexit.i ]
  %a30.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B86.if.i ], [ %.590.i, %B1232.loopexit.i ]
  %a31.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B86.if.i ], [ %.594.i, %B1232.loopexit.i ]
  %a32.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B86.if.i ], [ %.602.i, %B1232.loopexit.i ]
  %a33.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B86.if.i ], [ %.606.i, %B1232.loopexit.i ]
  %.630.i = getelementptr inbounds nuw double, ptr %.1607, i64 %.194729735.i
  store <8 x double> %a00.2.1.lcssa.i, ptr %.630.i, align 8, !noalias !2
  %.645.i = getelementptr i8, ptr %.630.i, i64 64
  store <8 x double> %a01.2.1.lcssa.i, ptr %.645.i, align 8, !noalias !2
  %.661.i = getelementptr i8, ptr %.630.i, i64 128
  store <8 x double> %a02.2.1.lcssa.i, ptr %.661.i, align 8, !noalias !2
  %.677.i = getelementptr i8, ptr %.630.i, i64 192
  store <8 x double> %a03.2.1.lcssa.i, ptr %.677.i, align 8, !noalias !2
  %.693.i = getelementptr double, ptr %.630.i, i64 %.936
  store <8 x double> %a10.2.1.lcssa.i, ptr %.693.i, align 8, !noalias !2
  %.710.i = getelementptr i8, ptr %.693.i, i64 64
  store <8 x double> %a11.2.1.lcssa.i, ptr %.710.i, align 8, !noalias !2
  %.728.i = getelementptr i8, ptr %.693.i, i64 128
  store <8 x double> %a12.2.1.lcssa.i, ptr %.728.i, align 8, !noalias !2
  %.746.i = getelementptr i8, ptr %.693.i, i64 192
  store <8 x double> %a13.2.1.lcssa.i, ptr %.746.i, align 8, !noalias !2
  %.763.i = getelementptr i8, ptr %.630.i, i64 %.idx.i
  store <8 x double> %a20.2.1.lcssa.i, ptr %.763.i, align 8, !noalias !2
  %.781.i = getelementptr i8, ptr %.763.i, i64 64
  store <8 x double> %a21.2.1.lcssa.i, ptr %.781.i, align 8, !noalias !2
  %.800.i = getelementptr i8, ptr %.763.i, i64 128
  store <8 x double> %a22.2.1.lcssa.i, ptr %.800.i, align 8, !noalias !2
  %.819.i = getelementptr i8, ptr %.763.i, i64 192
  store <8 x double> %a23.2.1.lcssa.i, ptr %.819.i, align 8, !noalias !2
  %.836.i = getelementptr i8, ptr %.630.i, i64 %.idx681.i
  store <8 x double> %a30.2.1.lcssa.i, ptr %.836.i, align 8, !noalias !2
  %.854.i = getelementptr i8, ptr %.836.i, i64 64
  store <8 x double> %a31.2.1.lcssa.i, ptr %.854.i, align 8, !noalias !2
  %.873.i = getelementptr i8, ptr %.836.i, i64 128
  store <8 x double> %a32.2.1.lcssa.i, ptr %.873.i, align 8, !noalias !2
  %.894.i = getelementptr i8, ptr %.836.i, i64 192
  store <8 x double> %a33.2.1.lcssa.i, ptr %.894.i, align 8, !noalias !2
  %.188.i = icmp sgt i64 %.187728736.i, 1
  br i1 %.188.i, label %B86.if.i, label %B2140.else.i

B2654.loopexit.i:                                 ; preds = %B2294.if.i
  %36 = add i64 %position.6.0769.i, %42
  br label %B2654.i

B2654.i:                                          ; preds = %B2218.if.i, %B2654.loopexit.i
  %position.5.1.lcssa.i = phi i64 [ %position.6.0769.i, %B2218.if.i ], [ %36, %B2654.loopexit.i ]
  %b0.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B2218.if.i ], [ %.1243.i, %B2654.loopexit.i ]
  %b1.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B2218.if.i ], [ %.1262.i, %B2654.loopexit.i ]
  %b2.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B2218.if.i ], [ %.1282.i, %B2654.loopexit.i ]
  %b3.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B2218.if.i ], [ %.1302.i, %B2654.loopexit.i ]
  %.1324.i = getelementptr inbounds double, ptr %.1607, i64 %.1041761767.i
  store <8 x double> %b0.2.1.lcssa.i, ptr %.1324.i, align 8, !noalias !2
  %.1340.i = getelementptr double, ptr %39, i64 %.1041761767.i
  store <8 x double> %b1.2.1.lcssa.i, ptr %.1340.i, align 8, !noalias !2
  %.1357.i = getelementptr double, ptr %40, i64 %.1041761767.i
  store <8 x double> %b2.2.1.lcssa.i, ptr %.1357.i, align 8, !noalias !2
  %.1376.i = getelementptr double, ptr %41, i64 %.1041761767.i
  store <8 x double> %b3.2.1.lcssa.i, ptr %.1376.i, align 8, !noalias !2
  %.1035.i = icmp sgt i64 %.1034760768.i, 1
  br i1 %.1035.i, label %B2218.if.i, label %B1260.endif.endif.endif

B86.if.i:                                         ; preds = %B1232.i, %B86.if.lr.ph.i
  %position.4.0737.i = phi i64 [ 0, %B86.if.lr.ph.i ], [ %position.3.1.lcssa.i, %B1232.i ]
  %.187728736.i = phi i64 [ %storemerge.i, %B86.if.lr.ph.i ], [ %.197.i, %B1232.i ]
  %.194729735.i = phi i64 [ 0, %B86.if.lr.ph.i ], [ %.201.i, %B1232.i ]
  %.197.i = add nsw i64 %.187728736.i, -1
  %.201.i = add nuw nsw i64 %.194729735.i, 32
  br i1 %34, label %B1232.i, label %B290.if.preheader.i

B290.if.preheader.i:                              ; preds = %B86.if.i
  %37 = shl i64 %position.4.0737.i, 3
  %scevgep9.i = getelementptr i8, ptr %scevgep8.i, i64 %37
  br label %B290.if.i

B290.if.i:                                        ; preds = %B290.if.i, %B290.if.preheader.i
  %lsr.iv191 = phi i64 [ %lsr.iv.next192, %B290.if.i ], [ -1, %B290.if.preheader.i ]
  %lsr.iv10.i = phi ptr [ %scevgep11.i, %B290.if.i ], [ %scevgep9.i, %B290.if.preheader.i ]
  %a33.2.1709.i = phi <8 x double> [ %.606.i, %B290.if.i ], [ zeroinitializer, %B290.if.preheader.i ]
  %a32.2.1708.i = phi <8 x double> [ %.602.i, %B290.if.i ], [ zeroinitializer, %B290.if.preheader.i ]
  %a31.2.1707.i = phi <8 x double> [ %.594.i, %B290.if.i ], [ zeroinitializer, %B290.if.preheader.i ]
  %a30.2.1706.i = phi <8 x double> [ %.590.i, %B290.if.i ], [ zeroinitializer, %B290.if.preheader.i ]
  %a23.2.1705.i = phi <8 x double> [ %.568.i, %B290.if.i ], [ zeroinitializer, %B290.if.preheader.i ]
  %a22.2.1704.i = phi <8 x double> [ %.564.i, %B290.if.i ], [ zeroinitializer, %B290.if.preheader.i ]
  %a21.2.1703.i = phi <8 x double> [ %.556.i, %B290.if.i ], [ zeroinitializer, %B290.if.preheader.i ]
  %a20.2.1702.i = phi <8 x double> [ %.552.i, %B290.if.i ], [ zeroinitializer, %B290.if.preheader.i ]
  %a13.2.1701.i = phi <8 x double> [ %.530.i, %B290.if.i ], [ zeroinitializer, %B290.if.preheader.i ]
  %a12.2.1700.i = phi <8 x double> [ %.526.i, %B290.if.i ], [ zeroinitializer, %B290.if.preheader.i ]
  %a11.2.1699.i = phi <8 x double> [ %.518.i, %B290.if.i ], [ zeroinitializer, %B290.if.preheader.i ]
  %a10.2.1698.i = phi <8 x double> [ %.514.i, %B290.if.i ], [ zeroinitializer, %B290.if.preheader.i ]
  %a03.2.1697.i = phi <8 x double> [ %.493.i, %B290.if.i ], [ zeroinitializer, %B290.if.preheader.i ]
  %a02.2.1696.i = phi <8 x double> [ %.489.i, %B290.if.i ], [ zeroinitializer, %B290.if.preheader.i ]
  %a01.2.1695.i = phi <8 x double> [ %.481.i, %B290.if.i ], [ zeroinitializer, %B290.if.preheader.i ]
  %a00.2.1694.i = phi <8 x double> [ %.477.i, %B290.if.i ], [ zeroinitializer, %B290.if.preheader.i ]
  %scevgep14.i = getelementptr i8, ptr %lsr.iv10.i, i64 -192
  %.420.i = load <8 x double>, ptr %scevgep14.i, align 8, !noalias !2
  %scevgep13.i = getelementptr i8, ptr %lsr.iv10.i, i64 -128
  %.432.i = load <8 x double>, ptr %scevgep13.i, align 8, !noalias !2
  %scevgep12.i = getelementptr i8, ptr %lsr.iv10.i, i64 -64
  %.445.i = load <8 x double>, ptr %scevgep12.i, align 8, !noalias !2
  %.458.i = load <8 x double>, ptr %lsr.iv10.i, align 8, !noalias !2
  %38 = shl i64 %lsr.iv191, 3
  %scevgep210 = getelementptr i8, ptr %lsr.iv208, i64 %38
  %scevgep211 = getelementptr i8, ptr %scevgep210, i64 64
  %.473.i = load double, ptr %scevgep211, align 8, !noalias !2
  %.475.i = insertelement <8 x double> poison, double %.473.i, i64 0
  %.476.i = shufflevector <8 x double> %.475.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.477.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.420.i, <8 x double> %.476.i, <8 x double> %a00.2.1694.i)
  %.481.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.432.i, <8 x double> %.476.i, <8 x double> %a01.2.1695.i)
  %.489.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.445.i, <8 x double> %.476.i, <8 x double> %a02.2.1696.i)
  %.493.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.458.i, <8 x double> %.476.i, <8 x double> %a03.2.1697.i)
  %scevgep22 = getelementptr i8, ptr %lsr.iv204, i64 %38
  %scevgep23 = getelementptr i8, ptr %scevgep22, i64 8
  %.510.i = load double, ptr %scevgep23, align 8, !noalias !2
  %.512.i = insertelement <8 x double> poison, double %.510.i, i64 0
  %.513.i = shufflevector <8 x double> %.512.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.514.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.420.i, <8 x double> %.513.i, <8 x double> %a10.2.1698.i)
  %.518.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.432.i, <8 x double> %.513.i, <8 x double> %a11.2.1699.i)
  %.526.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.445.i, <8 x double> %.513.i, <8 x double> %a12.2.1700.i)
  %.530.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.458.i, <8 x double> %.513.i, <8 x double> %a13.2.1701.i)
  %scevgep19 = getelementptr i8, ptr %lsr.iv199, i64 %38
  %scevgep21 = getelementptr i8, ptr %scevgep19, i64 8
  %.548.i = load double, ptr %scevgep21, align 8, !noalias !2
  %.550.i = insertelement <8 x double> poison, double %.548.i, i64 0
  %.551.i = shufflevector <8 x double> %.550.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.552.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.420.i, <8 x double> %.551.i, <8 x double> %a20.2.1702.i)
  %.556.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.432.i, <8 x double> %.551.i, <8 x double> %a21.2.1703.i)
  %.564.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.445.i, <8 x double> %.551.i, <8 x double> %a22.2.1704.i)
  %.568.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.458.i, <8 x double> %.551.i, <8 x double> %a23.2.1705.i)
  %scevgep9 = getelementptr i8, ptr %lsr.iv194, i64 %38
  %scevgep10 = getelementptr i8, ptr %scevgep9, i64 8
  %.586.i = load double, ptr %scevgep10, align 8, !noalias !2
  %.588.i = insertelement <8 x double> poison, double %.586.i, i64 0
  %.589.i = shufflevector <8 x double> %.588.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.590.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.420.i, <8 x double> %.589.i, <8 x double> %a30.2.1706.i)
  %.594.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.432.i, <8 x double> %.589.i, <8 x double> %a31.2.1707.i)
  %.602.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.445.i, <8 x double> %.589.i, <8 x double> %a32.2.1708.i)
  %.606.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.458.i, <8 x double> %.589.i, <8 x double> %a33.2.1709.i)
  %scevgep11.i = getelementptr i8, ptr %lsr.iv10.i, i64 256
  %lsr.iv.next192 = add nsw i64 %lsr.iv191, 1
  %exitcond.not.i = icmp eq i64 %.1688, %lsr.iv.next192
  br i1 %exitcond.not.i, label %B1232.loopexit.i, label %B290.if.i

B2140.else.i:                                     ; preds = %B1232.i, %B1258.if
  %position.4.0.lcssa.i = phi i64 [ 0, %B1258.if ], [ %position.3.1.lcssa.i, %B1232.i ]
  %.arg.count687.i = tail call i64 @llvm.smax.i64(i64 %.1689, i64 0)
  %39 = getelementptr double, ptr %.1607, i64 %.936
  %40 = getelementptr i8, ptr %.1607, i64 %.idx.i
  %41 = getelementptr i8, ptr %.1607, i64 %.idx681.i
  %42 = shl i64 %.arg.count687.i, 3
  %43 = icmp slt i64 %.1688, 0
  br label %B2218.if.i

B2218.if.i:                                       ; preds = %B2140.else.i, %B2654.i
  %position.6.0769.i = phi i64 [ %position.4.0.lcssa.i, %B2140.else.i ], [ %position.5.1.lcssa.i, %B2654.i ]
  %.1034760768.i = phi i64 [ %.1011678.i, %B2140.else.i ], [ %.1044.i, %B2654.i ]
  %.1041761767.i = phi i64 [ %.951.i, %B2140.else.i ], [ %.1048.i, %B2654.i ]
  %.1044.i = add nsw i64 %.1034760768.i, -1
  %.1048.i = add nuw nsw i64 %.1041761767.i, 8
  br i1 %43, label %B2654.i, label %B2294.if.preheader.i

B2294.if.preheader.i:                             ; preds = %B2218.if.i
  %44 = shl i64 %position.6.0769.i, 3
  %scevgep.i = getelementptr i8, ptr %.1351, i64 %44
  br label %B2294.if.i

B2294.if.i:                                       ; preds = %B2294.if.i, %B2294.if.preheader.i
  %lsr.iv27 = phi i64 [ %lsr.iv.next28, %B2294.if.i ], [ %.1689, %B2294.if.preheader.i ]
  %lsr.iv24 = phi i64 [ %lsr.iv.next25, %B2294.if.i ], [ 0, %B2294.if.preheader.i ]
  %b3.2.1752.i = phi <8 x double> [ %.1302.i, %B2294.if.i ], [ zeroinitializer, %B2294.if.preheader.i ]
  %b2.2.1751.i = phi <8 x double> [ %.1282.i, %B2294.if.i ], [ zeroinitializer, %B2294.if.preheader.i ]
  %b1.2.1750.i = phi <8 x double> [ %.1262.i, %B2294.if.i ], [ zeroinitializer, %B2294.if.preheader.i ]
  %b0.2.1749.i = phi <8 x double> [ %.1243.i, %B2294.if.i ], [ zeroinitializer, %B2294.if.preheader.i ]
  %45 = shl i64 %lsr.iv24, 3
  %scevgep26 = getelementptr i8, ptr %scevgep.i, i64 %45
  %.1224.i = load <8 x double>, ptr %scevgep26, align 8, !noalias !2
  %scevgep32 = getelementptr i8, ptr %lsr.iv208, i64 %lsr.iv24
  %scevgep33 = getelementptr i8, ptr %scevgep32, i64 56
  %.1239.i = load double, ptr %scevgep33, align 8, !noalias !2
  %.1241.i = insertelement <8 x double> poison, double %.1239.i, i64 0
  %.1242.i = shufflevector <8 x double> %.1241.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1243.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1224.i, <8 x double> %.1242.i, <8 x double> %b0.2.1749.i)
  %scevgep31 = getelementptr i8, ptr %lsr.iv204, i64 %lsr.iv24
  %.1258.i = load double, ptr %scevgep31, align 8, !noalias !2
  %.1260.i = insertelement <8 x double> poison, double %.1258.i, i64 0
  %.1261.i = shufflevector <8 x double> %.1260.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1262.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1224.i, <8 x double> %.1261.i, <8 x double> %b1.2.1750.i)
  %scevgep30 = getelementptr i8, ptr %lsr.iv199, i64 %lsr.iv24
  %.1278.i = load double, ptr %scevgep30, align 8, !noalias !2
  %.1280.i = insertelement <8 x double> poison, double %.1278.i, i64 0
  %.1281.i = shufflevector <8 x double> %.1280.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1282.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1224.i, <8 x double> %.1281.i, <8 x double> %b2.2.1751.i)
  %scevgep29 = getelementptr i8, ptr %lsr.iv194, i64 %lsr.iv24
  %.1298.i = load double, ptr %scevgep29, align 8, !noalias !2
  %.1300.i = insertelement <8 x double> poison, double %.1298.i, i64 0
  %.1301.i = shufflevector <8 x double> %.1300.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1302.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1224.i, <8 x double> %.1301.i, <8 x double> %b3.2.1752.i)
  %lsr.iv.next25 = add i64 %lsr.iv24, 8
  %lsr.iv.next28 = add i64 %lsr.iv27, -1
  %exitcond774.not.i = icmp eq i64 %lsr.iv.next28, 0
  br i1 %exitcond774.not.i, label %B2654.loopexit.i, label %B2294.if.i

B1260.endif.endif.endif:                          ; preds = %B2654.i
  %scevgep195 = getelementptr i8, ptr %lsr.iv194, i64 %27
  %scevgep200 = getelementptr i8, ptr %lsr.iv199, i64 %27
  %scevgep205 = getelementptr i8, ptr %lsr.iv204, i64 %27
  %scevgep209 = getelementptr i8, ptr %lsr.iv208, i64 %27
  %.1490 = icmp sgt i64 %.148913981406, 1
  br i1 %.1490, label %B1258.if, label %B1468

B1608.if:                                         ; preds = %B1608.if, %B1608.if.preheader
  %lsr.iv2 = phi i64 [ %lsr.iv.next3, %B1608.if ], [ 7, %B1608.if.preheader ]
  %lsr.iv185 = phi i64 [ %lsr.iv.next186, %B1608.if ], [ %3, %B1608.if.preheader ]
  %.194514111413 = phi i64 [ %.1952, %B1608.if ], [ %arg.start, %B1608.if.preheader ]
  %.1952 = add i64 %.194514111413, 1
  %.2012 = load i64, ptr %.1261, align 8
  %46 = add i64 %.2012, %lsr.iv2
  %.2027 = icmp slt i64 %46, 0
  %.2028 = select i1 %.2027, i64 %.1198.fca.5.0.load, i64 0
  %47 = getelementptr double, ptr %.1198.fca.4.load, i64 %46
  %.2042 = getelementptr double, ptr %47, i64 %.2028
  %.2043 = load double, ptr %.2042, align 8
  %.2051.le = tail call contract double @llvm.exp.f64(double %.2043)
  %.2069 = icmp slt i64 %.194514111413, 0
  %48 = select i1 %.2069, i64 %4, i64 0
  %scevgep187 = getelementptr i8, ptr %5, i64 %48
  %49 = shl i64 %.194514111413, 3
  %scevgep188 = getelementptr i8, ptr %scevgep187, i64 %49
  store double %.2051.le, ptr %scevgep188, align 8
  %lsr.iv.next186 = add i64 %lsr.iv185, -1
  %lsr.iv.next3 = add i64 %.1306, %lsr.iv2
  %.1939 = icmp sgt i64 %lsr.iv.next186, 1
  br i1 %.1939, label %B1608.if, label %B1776.if.preheader

B1776.if:                                         ; preds = %B2068, %B1776.if.preheader
  %lsr.iv183 = phi ptr [ %.954, %B1776.if.preheader ], [ %scevgep184, %B2068 ]
  %lsr.iv179 = phi ptr [ %scevgep178, %B1776.if.preheader ], [ %scevgep180, %B2068 ]
  %lsr.iv173 = phi ptr [ %scevgep, %B1776.if.preheader ], [ %scevgep174, %B2068 ]
  %lsr.iv = phi i64 [ %6, %B1776.if.preheader ], [ %lsr.iv.next, %B2068 ]
  %.219214211426 = phi i64 [ %arg.start, %B1776.if.preheader ], [ %.2199, %B2068 ]
  %.2241 = icmp slt i64 %.219214211426, 0
  %.2242 = select i1 %.2241, i64 %arg.status.5.0, i64 0
  %scevgep181 = getelementptr i8, ptr %arg.status.4, i64 %.2242
  %scevgep182 = getelementptr i8, ptr %scevgep181, i64 %.219214211426
  %.2257 = load i8, ptr %scevgep182, align 1
  %.2259 = icmp eq i8 %.2257, 0
  br i1 %.2259, label %B1824, label %B2034

B1824.endif.endif.if:                             ; preds = %B1824
  %.2480 = load ptr, ptr %excinfo.16, align 8
  store ptr %.2480, ptr %excinfo, align 8
  br label %common.ret
}

; Function Attrs: nofree noinline norecurse nosync nounwind memory(readwrite, inaccessiblemem: none, target_mem0: none, target_mem1: none)
define internal fastcc void @inner_3(ptr noalias nonnull writeonly captures(none) %retptr, ptr readonly captures(none) %arg.parameters.4, i64 %arg.rows, ptr readonly captures(none) %arg.contents.4, ptr readonly captures(none) %arg.exponents.4, ptr readonly captures(none) %arg.weights.4, ptr %arg.scratch.4) unnamed_addr #5 {
entry:
  %.1081 = alloca ptr, align 8
  store ptr null, ptr %.1081, align 8
  %.2758 = alloca ptr, align 8
  store ptr null, ptr %.2758, align 8
  %.101 = getelementptr i8, ptr %arg.contents.4, i64 24
  %.102 = load i64, ptr %.101, align 8
  %.104 = add nsw i64 %.102, 7
  %.145 = and i64 %.104, -8
  %.150 = add nsw i64 %.145, 8
  %.155 = shl nsw i64 %.150, 3
  %.208 = icmp slt i64 %.102, -15
  %.209 = select i1 %.208, i64 1073741824, i64 0
  %.210 = add i64 %.155, %.209
  %.213 = icmp slt i64 %.210, 0
  br i1 %.213, label %B0.endif.else.endif.endif.if, label %B0.endif.else.endif.endif.endif, !prof !5

B504:                                             ; preds = %B426.if
  %.1524 = getelementptr i8, ptr %arg.contents.4, i64 16
  %.1525 = load i64, ptr %.1524, align 8
  %.53.i = add nsw i64 %.1525, 1
  %.54.i = shl nsw i64 %.53.i, 3
  %.59.i = mul nsw i64 %.53.i, 40
  %.96.i = icmp slt i64 %.1525, -1
  %.97.i = select i1 %.96.i, i64 %.807, i64 0
  %.98.i = add i64 %.97.i, %.59.i
  %.101.i = icmp slt i64 %.98.i, 0
  br i1 %.101.i, label %B0.else.if.i, label %B0.else.endif.i, !prof !5

B414.i:                                           ; preds = %B282.if.i, %B88.else.endif.endif.i
  %exitcond473.not.i = icmp eq i64 %.331.i, 5
  br i1 %exitcond473.not.i, label %B416.i, label %B86.if.i

B416.i:                                           ; preds = %B414.i
  %.199.i = getelementptr double, ptr %.823, i64 %.86.sroa.0.3.i
  %.idx.i = shl i64 %.53.i, 7
  %0 = getelementptr i8, ptr %.823, i64 %.idx.i
  %.idx411.i = mul i64 %.53.i, 192
  %1 = getelementptr i8, ptr %.823, i64 %.idx411.i
  %.idx412.i = shl i64 %.53.i, 8
  %2 = getelementptr i8, ptr %.823, i64 %.idx412.i
  %scevgep.i = getelementptr i8, ptr %arg.exponents.4, i64 32
  br label %B448.if.i

B0.else.if.i:                                     ; preds = %B504
  br label %B0.else.endif.i

B0.else.endif.i:                                  ; preds = %B0.else.if.i, %B504
  %.86.sroa.0.1.i = phi i64 [ 0, %B0.else.if.i ], [ %.98.i, %B504 ]
  %.106.not.i = icmp slt i64 %.98.i, %.807
  br i1 %.106.not.i, label %B0.else.endif.endif.i, label %B0.else.endif.if.i, !prof !1

B0.else.endif.if.i:                               ; preds = %B0.else.endif.i
  br label %B0.else.endif.endif.i

B0.else.endif.endif.i:                            ; preds = %B0.else.endif.if.i, %B0.else.endif.i
  %.86.sroa.0.3.i = phi i64 [ %.807, %B0.else.endif.if.i ], [ %.86.sroa.0.1.i, %B0.else.endif.i ]
  %storemerge413.i = tail call i64 @llvm.smax.i64(i64 %.1525, i64 0)
  %scevgep29.i = getelementptr i8, ptr %.823, i64 64
  %3 = icmp slt i64 %.1525, 1
  br label %B86.if.i

B86.if.i:                                         ; preds = %B0.else.endif.endif.i, %B414.i
  %.324433441.i = phi i64 [ 0, %B0.else.endif.endif.i ], [ %.331.i, %B414.i ]
  %.331.i = add nuw nsw i64 %.324433441.i, 1
  %.364.idx.i = shl nsw i64 %.324433441.i, 6
  %.364.i = getelementptr inbounds nuw i8, ptr %.652, i64 %.364.idx.i
  %.366.i = load <8 x double>, ptr %.364.i, align 8, !noalias !6
  %.371.i = mul nsw i64 %.324433441.i, %.54.i
  %.411.i = icmp slt i64 %.371.i, 0
  %.412.i = select i1 %.411.i, i64 %.807, i64 0
  %.413.i = add i64 %.412.i, %.371.i
  %.416.i = icmp slt i64 %.413.i, 0
  br i1 %.416.i, label %B88.else.if.i, label %B88.else.endif.i, !prof !5

B88.else.if.i:                                    ; preds = %B86.if.i
  br label %B88.else.endif.i

B88.else.endif.i:                                 ; preds = %B88.else.if.i, %B86.if.i
  %.401.sroa.0.1.i = phi i64 [ 0, %B88.else.if.i ], [ %.413.i, %B86.if.i ]
  %.421.not.i = icmp slt i64 %.413.i, %.807
  br i1 %.421.not.i, label %B88.else.endif.endif.i, label %B88.else.endif.if.i, !prof !1

B88.else.endif.if.i:                              ; preds = %B88.else.endif.i
  br label %B88.else.endif.endif.i

B88.else.endif.endif.i:                           ; preds = %B88.else.endif.if.i, %B88.else.endif.i
  %.401.sroa.0.3.i = phi i64 [ %.807, %B88.else.endif.if.i ], [ %.401.sroa.0.1.i, %B88.else.endif.i ]
  %.514.i = getelementptr double, ptr %.823, i64 %.401.sroa.0.3.i
  store <8 x double> splat (double 1.000000e+00), ptr %.514.i, align 8, !noalias !6
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
  store <8 x double> %current.2.1428.i, ptr %lsr.iv31.i, align 8, !noalias !6
  %.6.i14.i = fsub contract <8 x double> zeroinitializer, %before.2.1429.i
  %.757.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i, <8 x double> %current.2.1428.i, <8 x double> %.6.i14.i)
  %lsr.iv.next28.i = add nsw i64 %lsr.iv27.i, -1
  %scevgep32.i = getelementptr i8, ptr %lsr.iv31.i, i64 64
  %exitcond.not.i = icmp eq i64 %lsr.iv.next28.i, 0
  br i1 %exitcond.not.i, label %B414.i, label %B282.if.i

B448.if.i:                                        ; preds = %B448.if.i, %B416.i
  %lsr.iv26.i = phi i64 [ %.1462, %B416.i ], [ %lsr.iv.next.i, %B448.if.i ]
  %lsr.iv24.i = phi ptr [ %.199.i, %B416.i ], [ %scevgep25.i, %B448.if.i ]
  %lsr.iv.i = phi ptr [ %scevgep.i, %B416.i ], [ %scevgep19.i, %B448.if.i ]
  %scevgep20.i = getelementptr i8, ptr %lsr.iv.i, i64 -32
  %.920.i = load i64, ptr %scevgep20.i, align 8, !noalias !6
  %.929.idx.i = shl nsw i64 %.920.i, 6
  %.929.i = getelementptr inbounds i8, ptr %.823, i64 %.929.idx.i
  %.931.i = load <8 x double>, ptr %.929.i, align 8, !noalias !6
  %scevgep21.i = getelementptr i8, ptr %lsr.iv.i, i64 -24
  %.942.i = load i64, ptr %scevgep21.i, align 8, !noalias !6
  %.54410.i = add i64 %.942.i, %.53.i
  %.953.idx.i = shl i64 %.54410.i, 6
  %.953.i = getelementptr inbounds i8, ptr %.823, i64 %.953.idx.i
  %.955.i = load <8 x double>, ptr %.953.i, align 8, !noalias !6
  %scevgep22.i = getelementptr i8, ptr %lsr.iv.i, i64 -16
  %.968.i = load i64, ptr %scevgep22.i, align 8, !noalias !6
  %.978.idx.i = shl i64 %.968.i, 6
  %.978.i = getelementptr i8, ptr %0, i64 %.978.idx.i
  %.980.i = load <8 x double>, ptr %.978.i, align 8, !noalias !6
  %scevgep23.i = getelementptr i8, ptr %lsr.iv.i, i64 -8
  %.993.i = load i64, ptr %scevgep23.i, align 8, !noalias !6
  %.1003.idx.i = shl i64 %.993.i, 6
  %.1003.i = getelementptr i8, ptr %1, i64 %.1003.idx.i
  %.1005.i = load <8 x double>, ptr %.1003.i, align 8, !noalias !6
  %.1018.i = load i64, ptr %lsr.iv.i, align 8, !noalias !6
  %.1028.idx.i = shl i64 %.1018.i, 6
  %.1028.i = getelementptr i8, ptr %2, i64 %.1028.idx.i
  %.1030.i = load <8 x double>, ptr %.1028.i, align 8, !noalias !6
  %.6.i15.i = fmul contract <8 x double> %.931.i, %.955.i
  %.6.i16.i = fmul contract <8 x double> %.980.i, %.1005.i
  %.6.i17.i = fmul contract <8 x double> %.6.i15.i, %.6.i16.i
  %.6.i18.i = fmul contract <8 x double> %.6.i17.i, %.1030.i
  store <8 x double> %.6.i18.i, ptr %lsr.iv24.i, align 8, !noalias !6
  %scevgep19.i = getelementptr i8, ptr %lsr.iv.i, i64 40
  %scevgep25.i = getelementptr i8, ptr %lsr.iv24.i, i64 64
  %lsr.iv.next.i = add i64 %lsr.iv26.i, -1
  %exitcond474.not.i = icmp eq i64 %lsr.iv.next.i, 0
  br i1 %exitcond474.not.i, label %_ZN17bnserve_surrogate6kernel11_regression9_productsB3v33B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedExx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit, label %B448.if.i

_ZN17bnserve_surrogate6kernel11_regression9_productsB3v33B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedExx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit: ; preds = %B448.if.i
  %.174.i = sub nsw i64 %.807, %.86.sroa.0.3.i
  %.183.i = tail call i64 @llvm.smax.i64(i64 %.174.i, i64 0)
  %.1609 = getelementptr i8, ptr %arg.contents.4, i64 88
  %.1610 = load i64, ptr %.1609, align 8
  %5 = lshr i64 %.1610, 33
  %.1648 = and i64 %5, 1073741824
  %.1649 = add i64 %.1648, %.1610
  %.1652 = icmp slt i64 %.1649, 0
  br i1 %.1652, label %B504.endif.else.if, label %B504.endif.else.endif, !prof !5

B812:                                             ; preds = %B674.endif.endif.endif, %B504.endif.else.endif.endif, %B426.if
  %.2371 = getelementptr i8, ptr %arg.contents.4, i64 32
  %.2372 = load i64, ptr %.2371, align 8
  %.2373 = icmp sgt i64 %.2372, 0
  br i1 %.2373, label %B846, label %B952

B846:                                             ; preds = %B812
  %.2404 = getelementptr i8, ptr %arg.contents.4, i64 96
  %.2405 = load i64, ptr %.2404, align 8
  %6 = lshr i64 %.2405, 33
  %.2443 = and i64 %6, 1073741824
  %.2444 = add i64 %.2443, %.2405
  %.2447 = icmp slt i64 %.2444, 0
  br i1 %.2447, label %B846.else.if, label %B846.else.endif, !prof !5

B952:                                             ; preds = %B846.endif.else.endif.endif, %B812
  %retptr.repack1017 = getelementptr inbounds nuw i8, ptr %retptr, i64 16
  tail call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(16) %retptr, i8 0, i64 16, i1 false)
  store i64 %.181.sroa.13.2, ptr %retptr.repack1017, align 8
  %retptr.repack1019 = getelementptr inbounds nuw i8, ptr %retptr, i64 24
  store i64 8, ptr %retptr.repack1019, align 8
  %retptr.repack1021 = getelementptr inbounds nuw i8, ptr %retptr, i64 32
  store ptr %arg.scratch.4, ptr %retptr.repack1021, align 8
  %retptr.repack1023 = getelementptr inbounds nuw i8, ptr %retptr, i64 40
  store i64 %.181.sroa.13.2, ptr %retptr.repack1023, align 8
  %retptr.repack1025 = getelementptr inbounds nuw i8, ptr %retptr, i64 48
  store i64 8, ptr %retptr.repack1025, align 8
  ret void

B0.endif.else.endif.endif.if:                     ; preds = %entry
  br label %B0.endif.else.endif.endif.endif

B0.endif.else.endif.endif.endif:                  ; preds = %B0.endif.else.endif.endif.if, %entry
  %.181.sroa.13.1 = phi i64 [ 0, %B0.endif.else.endif.endif.if ], [ %.210, %entry ]
  %.218.not = icmp slt i64 %.210, 1073741824
  br i1 %.218.not, label %B0.endif.else.endif.endif.endif.endif, label %B0.endif.else.endif.endif.endif.if, !prof !1

B0.endif.else.endif.endif.endif.if:               ; preds = %B0.endif.else.endif.endif.endif
  br label %B0.endif.else.endif.endif.endif.endif

B0.endif.else.endif.endif.endif.endif:            ; preds = %B0.endif.else.endif.endif.endif.if, %B0.endif.else.endif.endif.endif
  %.181.sroa.13.2 = phi i64 [ 1073741824, %B0.endif.else.endif.endif.endif.if ], [ %.181.sroa.13.1, %B0.endif.else.endif.endif.endif ]
  br i1 %.213, label %B0.endif.endif.else.if, label %B0.endif.endif.else.endif, !prof !5

B0.endif.endif.else.if:                           ; preds = %B0.endif.else.endif.endif.endif.endif
  br label %B0.endif.endif.else.endif

B0.endif.endif.else.endif:                        ; preds = %B0.endif.endif.else.if, %B0.endif.else.endif.endif.endif.endif
  %.353.sroa.0.1 = phi i64 [ 0, %B0.endif.endif.else.if ], [ %.210, %B0.endif.else.endif.endif.endif.endif ]
  br i1 %.218.not, label %B0.endif.endif.else.endif.endif, label %B0.endif.endif.else.endif.if, !prof !1

B0.endif.endif.else.endif.if:                     ; preds = %B0.endif.endif.else.endif
  br label %B0.endif.endif.else.endif.endif

B0.endif.endif.else.endif.endif:                  ; preds = %B0.endif.endif.else.endif.if, %B0.endif.endif.else.endif
  %.353.sroa.0.3 = phi i64 [ 1073741824, %B0.endif.endif.else.endif.if ], [ %.353.sroa.0.1, %B0.endif.endif.else.endif ]
  %.441 = sub nsw i64 1073741824, %.353.sroa.0.3
  %.448 = icmp sgt i64 %.353.sroa.0.3, 1073741823
  %.450 = select i1 %.448, i64 0, i64 %.441
  %.466 = getelementptr double, ptr %arg.scratch.4, i64 %.353.sroa.0.3
  br i1 %.448, label %B0.endif.endif.endif.else.endif.if, label %B0.endif.endif.endif.else.endif.endif, !prof !5

B0.endif.endif.endif.else.endif.if:               ; preds = %B0.endif.endif.else.endif.endif
  br label %B0.endif.endif.endif.else.endif.endif

B0.endif.endif.endif.else.endif.endif:            ; preds = %B0.endif.endif.endif.else.endif.if, %B0.endif.endif.else.endif.endif
  %.539.sroa.0.3 = phi i64 [ %.450, %B0.endif.endif.endif.else.endif.if ], [ 0, %B0.endif.endif.else.endif.endif ]
  %.576 = icmp slt i64 %.450, 41
  %.652 = getelementptr double, ptr %.466, i64 %.539.sroa.0.3
  br i1 %.576, label %B0.endif.endif.endif.endif.else.endif.if, label %B0.endif.endif.endif.endif.else.endif.endif, !prof !5

B0.endif.endif.endif.endif.else.endif.if:         ; preds = %B0.endif.endif.endif.else.endif.endif
  br label %B0.endif.endif.endif.endif.else.endif.endif

B0.endif.endif.endif.endif.else.endif.endif:      ; preds = %B0.endif.endif.endif.endif.else.endif.if, %B0.endif.endif.endif.else.endif.endif
  %.710.sroa.0.3 = phi i64 [ %.450, %B0.endif.endif.endif.endif.else.endif.if ], [ 40, %B0.endif.endif.endif.else.endif.endif ]
  %.798 = sub nsw i64 %.450, %.710.sroa.0.3
  %.807 = tail call i64 @llvm.smax.i64(i64 %.798, i64 0)
  %.823 = getelementptr double, ptr %.466, i64 %.710.sroa.0.3
  %.905 = getelementptr i8, ptr %arg.contents.4, i64 80
  %.906 = load i64, ptr %.905, align 8
  %7 = lshr i64 %.906, 33
  %.944 = and i64 %7, 1073741824
  %.945 = add i64 %.944, %.906
  %.948 = icmp slt i64 %.945, 0
  br i1 %.948, label %B0.endif.endif.endif.endif.endif.else.if, label %B0.endif.endif.endif.endif.endif.else.endif, !prof !5

B0.endif.endif.endif.endif.endif.else.if:         ; preds = %B0.endif.endif.endif.endif.else.endif.endif
  br label %B0.endif.endif.endif.endif.endif.else.endif

B0.endif.endif.endif.endif.endif.else.endif:      ; preds = %B0.endif.endif.endif.endif.endif.else.if, %B0.endif.endif.endif.endif.else.endif.endif
  %.933.sroa.0.1 = phi i64 [ 0, %B0.endif.endif.endif.endif.endif.else.if ], [ %.945, %B0.endif.endif.endif.endif.else.endif.endif ]
  %.953.not = icmp slt i64 %.945, 1073741824
  br i1 %.953.not, label %B0.endif.endif.endif.endif.endif.else.endif.endif, label %B0.endif.endif.endif.endif.endif.else.endif.if, !prof !1

B0.endif.endif.endif.endif.endif.else.endif.if:   ; preds = %B0.endif.endif.endif.endif.endif.else.endif
  br label %B0.endif.endif.endif.endif.endif.else.endif.endif

B0.endif.endif.endif.endif.endif.else.endif.endif: ; preds = %B0.endif.endif.endif.endif.endif.else.endif.if, %B0.endif.endif.endif.endif.endif.else.endif
  %.933.sroa.0.3 = phi i64 [ 1073741824, %B0.endif.endif.endif.endif.endif.else.endif.if ], [ %.933.sroa.0.1, %B0.endif.endif.endif.endif.endif.else.endif ]
  %.1046 = getelementptr double, ptr %arg.weights.4, i64 %.933.sroa.0.3
  store ptr null, ptr %.1081, align 8
  call fastcc void @inner_6(ptr nonnull %.1081, ptr %arg.parameters.4, ptr %arg.contents.4, ptr %.1046, ptr %.823, ptr %.652)
  %.1162 = icmp slt i64 %.102, -7
  %..155 = select i1 %.1162, i64 0, i64 %.155
  %.12041029 = icmp sgt i64 %..155, 0
  br i1 %.12041029, label %B370.if.preheader, label %B426.if

B370.if.preheader:                                ; preds = %B0.endif.endif.endif.endif.endif.else.endif.endif
  %8 = shl nuw i64 %..155, 3
  tail call void @llvm.memset.p0.i64(ptr align 8 %arg.scratch.4, i8 0, i64 %8, i1 false)
  br label %B426.if

B426.if:                                          ; preds = %B370.if.preheader, %B0.endif.endif.endif.endif.endif.else.endif.endif
  %9 = getelementptr i8, ptr %arg.scratch.4, i64 56
  store double 1.000000e+00, ptr %9, align 8
  %.1412.1 = select i1 %.208, i64 %.181.sroa.13.2, i64 0
  %10 = getelementptr double, ptr %arg.scratch.4, i64 %.150
  %11 = getelementptr i8, ptr %10, i64 56
  %.1426.1 = getelementptr double, ptr %11, i64 %.1412.1
  store double 1.000000e+00, ptr %.1426.1, align 8
  %.idx = shl i64 %.150, 4
  %12 = getelementptr i8, ptr %arg.scratch.4, i64 %.idx
  %13 = getelementptr i8, ptr %12, i64 56
  %.1426.2 = getelementptr double, ptr %13, i64 %.1412.1
  store double 1.000000e+00, ptr %.1426.2, align 8
  %.idx1049 = mul i64 %.150, 24
  %14 = getelementptr i8, ptr %arg.scratch.4, i64 %.idx1049
  %15 = getelementptr i8, ptr %14, i64 56
  %.1426.3 = getelementptr double, ptr %15, i64 %.1412.1
  store double 1.000000e+00, ptr %.1426.3, align 8
  %.idx1050 = shl i64 %.150, 5
  %16 = getelementptr i8, ptr %arg.scratch.4, i64 %.idx1050
  %17 = getelementptr i8, ptr %16, i64 56
  %.1426.4 = getelementptr double, ptr %17, i64 %.1412.1
  store double 1.000000e+00, ptr %.1426.4, align 8
  %.idx1051 = mul i64 %.150, 40
  %18 = getelementptr i8, ptr %arg.scratch.4, i64 %.idx1051
  %19 = getelementptr i8, ptr %18, i64 56
  %.1426.5 = getelementptr double, ptr %19, i64 %.1412.1
  store double 1.000000e+00, ptr %.1426.5, align 8
  %.idx1052 = mul i64 %.150, 48
  %20 = getelementptr i8, ptr %arg.scratch.4, i64 %.idx1052
  %21 = getelementptr i8, ptr %20, i64 56
  %.1426.6 = getelementptr double, ptr %21, i64 %.1412.1
  store double 1.000000e+00, ptr %.1426.6, align 8
  %.idx1053 = mul i64 %.150, 56
  %22 = getelementptr i8, ptr %arg.scratch.4, i64 %.idx1053
  %23 = getelementptr i8, ptr %22, i64 56
  %.1426.7 = getelementptr double, ptr %23, i64 %.1412.1
  store double 1.000000e+00, ptr %.1426.7, align 8
  %.1461 = getelementptr i8, ptr %arg.contents.4, i64 8
  %.1462 = load i64, ptr %.1461, align 8
  %.1463 = icmp sgt i64 %.1462, 0
  br i1 %.1463, label %B504, label %B812

B504.endif.else.if:                               ; preds = %_ZN17bnserve_surrogate6kernel11_regression9_productsB3v33B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedExx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit
  br label %B504.endif.else.endif

B504.endif.else.endif:                            ; preds = %B504.endif.else.if, %_ZN17bnserve_surrogate6kernel11_regression9_productsB3v33B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedExx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit
  %.1637.sroa.0.1 = phi i64 [ 0, %B504.endif.else.if ], [ %.1649, %_ZN17bnserve_surrogate6kernel11_regression9_productsB3v33B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedExx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit ]
  %.1657.not = icmp slt i64 %.1649, 1073741824
  br i1 %.1657.not, label %B504.endif.else.endif.endif, label %B504.endif.else.endif.if, !prof !1

B504.endif.else.endif.if:                         ; preds = %B504.endif.else.endif
  br label %B504.endif.else.endif.endif

B504.endif.else.endif.endif:                      ; preds = %B504.endif.else.endif.if, %B504.endif.else.endif
  %.1637.sroa.0.3 = phi i64 [ 1073741824, %B504.endif.else.endif.if ], [ %.1637.sroa.0.1, %B504.endif.else.endif ]
  %.1750 = getelementptr double, ptr %arg.weights.4, i64 %.1637.sroa.0.3
  %24 = add nuw i64 %arg.rows, 3
  %.1847 = lshr i64 %24, 2
  %.1826.inv = icmp slt i64 %arg.rows, 1
  %.18681042.not1054 = icmp eq i64 %.1847, 0
  %.18681042.not = select i1 %.1826.inv, i1 true, i1 %.18681042.not1054
  br i1 %.18681042.not, label %B812, label %B672.if.preheader

B672.if.preheader:                                ; preds = %B504.endif.else.endif.endif
  %25 = tail call i64 @llvm.smax.i64(i64 %.145, i64 31)
  %storemerge.i = lshr i64 %25, 5
  %.991.i = and i64 %.104, 24
  %scevgep14.i = getelementptr i8, ptr %.1750, i64 192
  %.951.i = and i64 %.104, -32
  %.1011678.i = lshr exact i64 %.991.i, 3
  %26 = add i64 %.710.sroa.0.3, %.353.sroa.0.3
  %27 = add i64 %26, %.86.sroa.0.3.i
  %28 = shl i64 %27, 3
  %29 = getelementptr i8, ptr %arg.scratch.4, i64 %28
  %scevgep = getelementptr i8, ptr %29, i64 24
  %30 = icmp eq i64 %storemerge.i, 0
  %31 = icmp eq i64 %.991.i, 0
  %sunkaddr13 = shl i64 %.145, 3
  br label %B672.if

B672.if:                                          ; preds = %B674.endif.endif.endif, %B672.if.preheader
  %.186710401044 = phi i64 [ %.1877, %B674.endif.endif.endif ], [ %.1847, %B672.if.preheader ]
  %.187410411043 = phi i64 [ %.1881, %B674.endif.endif.endif ], [ 0, %B672.if.preheader ]
  %.1877 = add nsw i64 %.186710401044, -1
  %.1881 = add nuw i64 %.187410411043, 4
  %.1907 = mul nsw i64 %.187410411043, %.150
  %.1908 = or disjoint i64 %.1907, 8
  %.1945 = icmp slt i64 %.1907, -8
  %.1946 = select i1 %.1945, i64 %.181.sroa.13.2, i64 0
  %.1947 = add i64 %.1946, %.1908
  %.1950 = icmp slt i64 %.1947, 0
  br i1 %.1950, label %B674.else.if, label %B674.else.endif, !prof !5

B674.else.if:                                     ; preds = %B672.if
  br label %B674.else.endif

B674.else.endif:                                  ; preds = %B674.else.if, %B672.if
  %.1935.sroa.0.1 = phi i64 [ 0, %B674.else.if ], [ %.1947, %B672.if ]
  %.1955.not = icmp slt i64 %.1947, %.181.sroa.13.2
  br i1 %.1955.not, label %B674.else.endif.endif, label %B674.else.endif.if, !prof !1

B674.else.endif.if:                               ; preds = %B674.else.endif
  br label %B674.else.endif.endif

B674.else.endif.endif:                            ; preds = %B674.else.endif.if, %B674.else.endif
  %.1935.sroa.0.3 = phi i64 [ %.181.sroa.13.2, %B674.else.endif.if ], [ %.1935.sroa.0.1, %B674.else.endif ]
  %.2048 = getelementptr double, ptr %arg.scratch.4, i64 %.1935.sroa.0.3
  %.2110 = load i64, ptr %.1461, align 8
  %.2147 = icmp slt i64 %.187410411043, 0
  %.2148 = select i1 %.2147, i64 %.183.i, i64 0
  %.2149 = add i64 %.2148, %.187410411043
  %.2152 = icmp slt i64 %.2149, 0
  br i1 %.2152, label %B674.endif.else.if, label %B674.endif.else.endif, !prof !5

B674.endif.else.if:                               ; preds = %B674.else.endif.endif
  br label %B674.endif.else.endif

B674.endif.else.endif:                            ; preds = %B674.endif.else.if, %B674.else.endif.endif
  %.2137.sroa.0.1 = phi i64 [ 0, %B674.endif.else.if ], [ %.2149, %B674.else.endif.endif ]
  %.2157.not = icmp slt i64 %.2149, %.183.i
  br i1 %.2157.not, label %B674.endif.else.endif.endif, label %B674.endif.else.endif.if, !prof !1

B674.endif.else.endif.if:                         ; preds = %B674.endif.else.endif
  br label %B674.endif.else.endif.endif

B674.endif.else.endif.endif:                      ; preds = %B674.endif.else.endif.if, %B674.endif.else.endif
  %.2137.sroa.0.3 = phi i64 [ %.183.i, %B674.endif.else.endif.if ], [ %.2137.sroa.0.1, %B674.endif.else.endif ]
  br i1 %30, label %B2140.else.i, label %B86.if.lr.ph.i

B86.if.lr.ph.i:                                   ; preds = %B674.endif.else.endif.endif
  %.arg.count.i = tail call i64 @llvm.smax.i64(i64 %.2110, i64 0)
  %32 = shl i64 %.arg.count.i, 5
  %33 = shl i64 %.2137.sroa.0.3, 3
  %scevgep19 = getelementptr i8, ptr %scevgep, i64 %33
  %34 = icmp slt i64 %.2110, 1
  br label %B86.if.i2

B1232.loopexit.i:                                 ; preds = %B290.if.i
  %35 = add i64 %position.4.0733.i, %32
  br label %B1232.i

B1232.i:                                          ; preds = %B86.if.i2, %B1232.loopexit.i
  %position.3.1.lcssa.i = phi i64 [ %position.4.0733.i, %B86.if.i2 ], [ %35, %B1232.loopexit.i ]
  %a00.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B86.if.i2 ], [ %.477.i, %B1232.loopexit.i ]
  %a01.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B86.if.i2 ], [ %.481.i, %B1232.loopexit.i ]
  %a02.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B86.if.i2 ], [ %.489.i, %B1232.loopexit.i ]
  %a03.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B86.if.i2 ], [ %.493.i, %B1232.loopexit.i ]
  %a10.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B86.if.i2 ], [ %.514.i6, %B1232.loopexit.i ]
  %a11.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B86.if.i2 ], [ %.518.i, %B1232.loopexit.i ]
  %a12.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B86.if.i2 ], [ %.526.i, %B1232.loopexit.i ]
  %a13.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B86.if.i2 ], [ %.530.i, %B1232.loopexit.i ]
  %a20.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B86.if.i2 ], [ %.552.i, %B1232.loopexit.i ]
  %a21.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B86.if.i2 ], [ %.556.i, %B1232.loopexit.i ]
  %a22.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B86.if.i2 ], [ %.564.i, %B1232.loopexit.i ]
  %a23.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B86.if.i2 ], [ %.568.i, %B1232.loopexit.i ]
  %a30.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B86.if.i2 ], [ %.590.i, %B1232.loopexit.i ]
  %a31.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B86.if.i2 ], [ %.594.i, %B1232.loopexit.i ]
  %a32.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B86.if.i2 ], [ %.602.i, %B1232.loopexit.i ]
  %a33.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B86.if.i2 ], [ %.606.i, %B1232.loopexit.i ]
  %.630.i = getelementptr inbounds nuw double, ptr %.2048, i64 %.194725731.i
  store <8 x double> %a00.2.1.lcssa.i, ptr %.630.i, align 8, !noalias !9
  %.645.i = getelementptr i8, ptr %.630.i, i64 64
  store <8 x double> %a01.2.1.lcssa.i, ptr %.645.i, align 8, !noalias !9
  %.661.i = getelementptr i8, ptr %.630.i, i64 128
  store <8 x double> %a02.2.1.lcssa.i, ptr %.661.i, align 8, !noalias !9
  %.677.i = getelementptr i8, ptr %.630.i, i64 192
  store <8 x double> %a03.2.1.lcssa.i, ptr %.677.i, align 8, !noalias !9
  %sunkaddr14 = getelementptr i8, ptr %.630.i, i64 %sunkaddr13
  %sunkaddr15 = getelementptr i8, ptr %sunkaddr14, i64 64
  store <8 x double> %a10.2.1.lcssa.i, ptr %sunkaddr15, align 8, !noalias !9
  %sunkaddr20 = getelementptr i8, ptr %sunkaddr14, i64 128
  store <8 x double> %a11.2.1.lcssa.i, ptr %sunkaddr20, align 8, !noalias !9
  %sunkaddr23 = getelementptr i8, ptr %sunkaddr14, i64 192
  store <8 x double> %a12.2.1.lcssa.i, ptr %sunkaddr23, align 8, !noalias !9
  %sunkaddr26 = getelementptr i8, ptr %sunkaddr14, i64 256
  store <8 x double> %a13.2.1.lcssa.i, ptr %sunkaddr26, align 8, !noalias !9
  %.763.i = getelementptr i8, ptr %.630.i, i64 %.idx
  store <8 x double> %a20.2.1.lcssa.i, ptr %.763.i, align 8, !noalias !9
  %.781.i = getelementptr i8, ptr %.763.i, i64 64
  store <8 x double> %a21.2.1.lcssa.i, ptr %.781.i, align 8, !noalias !9
  %.800.i = getelementptr i8, ptr %.763.i, i64 128
  store <8 x double> %a22.2.1.lcssa.i, ptr %.800.i, align 8, !noalias !9
  %.819.i = getelementptr i8, ptr %.763.i, i64 192
  store <8 x double> %a23.2.1.lcssa.i, ptr %.819.i, align 8, !noalias !9
  %.836.i = getelementptr i8, ptr %.630.i, i64 %.idx1049
  store <8 x double> %a30.2.1.lcssa.i, ptr %.836.i, align 8, !noalias !9
  %.854.i = getelementptr i8, ptr %.836.i, i64 64
  store <8 x double> %a31.2.1.lcssa.i, ptr %.854.i, align 8, !noalias !9
  %.873.i = getelementptr i8, ptr %.836.i, i64 128
  store <8 x double> %a32.2.1.lcssa.i, ptr %.873.i, align 8, !noalias !9
  %.894.i = getelementptr i8, ptr %.836.i, i64 192
  store <8 x double> %a33.2.1.lcssa.i, ptr %.894.i, align 8, !noalias !9
  %.188.i = icmp sgt i64 %.187724732.i, 1
  br i1 %.188.i, label %B86.if.i2, label %B2140.else.i

B2654.loopexit.i:                                 ; preds = %B2294.if.i
  %36 = add i64 %position.6.0765.i, %42
  br label %B2654.i

B2654.i:                                          ; preds = %B2218.if.i, %B2654.loopexit.i
  %position.5.1.lcssa.i = phi i64 [ %position.6.0765.i, %B2218.if.i ], [ %36, %B2654.loopexit.i ]
  %b0.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B2218.if.i ], [ %.1243.i, %B2654.loopexit.i ]
  %b1.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B2218.if.i ], [ %.1262.i, %B2654.loopexit.i ]
  %b2.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B2218.if.i ], [ %.1282.i, %B2654.loopexit.i ]
  %b3.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B2218.if.i ], [ %.1302.i, %B2654.loopexit.i ]
  %.1324.i = getelementptr inbounds double, ptr %.2048, i64 %.1041757763.i
  store <8 x double> %b0.2.1.lcssa.i, ptr %.1324.i, align 8, !noalias !9
  %.1340.i = getelementptr double, ptr %39, i64 %.1041757763.i
  store <8 x double> %b1.2.1.lcssa.i, ptr %.1340.i, align 8, !noalias !9
  %.1357.i = getelementptr double, ptr %40, i64 %.1041757763.i
  store <8 x double> %b2.2.1.lcssa.i, ptr %.1357.i, align 8, !noalias !9
  %.1376.i = getelementptr double, ptr %41, i64 %.1041757763.i
  store <8 x double> %b3.2.1.lcssa.i, ptr %.1376.i, align 8, !noalias !9
  %.1035.i = icmp sgt i64 %.1034756764.i, 1
  br i1 %.1035.i, label %B2218.if.i, label %B674.endif.endif.endif

B86.if.i2:                                        ; preds = %B1232.i, %B86.if.lr.ph.i
  %position.4.0733.i = phi i64 [ 0, %B86.if.lr.ph.i ], [ %position.3.1.lcssa.i, %B1232.i ]
  %.187724732.i = phi i64 [ %storemerge.i, %B86.if.lr.ph.i ], [ %.197.i, %B1232.i ]
  %.194725731.i = phi i64 [ 0, %B86.if.lr.ph.i ], [ %.201.i, %B1232.i ]
  %.197.i = add nsw i64 %.187724732.i, -1
  %.201.i = add nuw nsw i64 %.194725731.i, 32
  br i1 %34, label %B1232.i, label %B290.if.preheader.i

B290.if.preheader.i:                              ; preds = %B86.if.i2
  %37 = shl i64 %position.4.0733.i, 3
  %scevgep15.i = getelementptr i8, ptr %scevgep14.i, i64 %37
  br label %B290.if.i

B290.if.i:                                        ; preds = %B290.if.i, %B290.if.preheader.i
  %lsr.iv33.i = phi i64 [ %.2110, %B290.if.preheader.i ], [ %lsr.iv.next34.i, %B290.if.i ]
  %lsr.iv16.i = phi i64 [ 0, %B290.if.preheader.i ], [ %lsr.iv.next17.i, %B290.if.i ]
  %a33.2.1705.i = phi <8 x double> [ zeroinitializer, %B290.if.preheader.i ], [ %.606.i, %B290.if.i ]
  %a32.2.1704.i = phi <8 x double> [ zeroinitializer, %B290.if.preheader.i ], [ %.602.i, %B290.if.i ]
  %a31.2.1703.i = phi <8 x double> [ zeroinitializer, %B290.if.preheader.i ], [ %.594.i, %B290.if.i ]
  %a30.2.1702.i = phi <8 x double> [ zeroinitializer, %B290.if.preheader.i ], [ %.590.i, %B290.if.i ]
  %a23.2.1701.i = phi <8 x double> [ zeroinitializer, %B290.if.preheader.i ], [ %.568.i, %B290.if.i ]
  %a22.2.1700.i = phi <8 x double> [ zeroinitializer, %B290.if.preheader.i ], [ %.564.i, %B290.if.i ]
  %a21.2.1699.i = phi <8 x double> [ zeroinitializer, %B290.if.preheader.i ], [ %.556.i, %B290.if.i ]
  %a20.2.1698.i = phi <8 x double> [ zeroinitializer, %B290.if.preheader.i ], [ %.552.i, %B290.if.i ]
  %a13.2.1697.i = phi <8 x double> [ zeroinitializer, %B290.if.preheader.i ], [ %.530.i, %B290.if.i ]
  %a12.2.1696.i = phi <8 x double> [ zeroinitializer, %B290.if.preheader.i ], [ %.526.i, %B290.if.i ]
  %a11.2.1695.i = phi <8 x double> [ zeroinitializer, %B290.if.preheader.i ], [ %.518.i, %B290.if.i ]
  %a10.2.1694.i = phi <8 x double> [ zeroinitializer, %B290.if.preheader.i ], [ %.514.i6, %B290.if.i ]
  %a03.2.1693.i = phi <8 x double> [ zeroinitializer, %B290.if.preheader.i ], [ %.493.i, %B290.if.i ]
  %a02.2.1692.i = phi <8 x double> [ zeroinitializer, %B290.if.preheader.i ], [ %.489.i, %B290.if.i ]
  %a01.2.1691.i = phi <8 x double> [ zeroinitializer, %B290.if.preheader.i ], [ %.481.i, %B290.if.i ]
  %a00.2.1690.i = phi <8 x double> [ zeroinitializer, %B290.if.preheader.i ], [ %.477.i, %B290.if.i ]
  %38 = shl i64 %lsr.iv16.i, 2
  %scevgep23.i3 = getelementptr i8, ptr %scevgep15.i, i64 %38
  %scevgep24.i = getelementptr i8, ptr %scevgep23.i3, i64 -192
  %.420.i = load <8 x double>, ptr %scevgep24.i, align 8, !noalias !9
  %scevgep22.i4 = getelementptr i8, ptr %scevgep23.i3, i64 -128
  %.432.i = load <8 x double>, ptr %scevgep22.i4, align 8, !noalias !9
  %scevgep8 = getelementptr i8, ptr %scevgep23.i3, i64 -64
  %.445.i = load <8 x double>, ptr %scevgep8, align 8, !noalias !9
  %.458.i = load <8 x double>, ptr %scevgep23.i3, align 8, !noalias !9
  %scevgep25 = getelementptr i8, ptr %scevgep19, i64 %lsr.iv16.i
  %scevgep26 = getelementptr i8, ptr %scevgep25, i64 -24
  %.473.i = load double, ptr %scevgep26, align 8, !noalias !9
  %.475.i = insertelement <8 x double> poison, double %.473.i, i64 0
  %.476.i = shufflevector <8 x double> %.475.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.477.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.420.i, <8 x double> %.476.i, <8 x double> %a00.2.1690.i)
  %.481.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.432.i, <8 x double> %.476.i, <8 x double> %a01.2.1691.i)
  %.489.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.445.i, <8 x double> %.476.i, <8 x double> %a02.2.1692.i)
  %.493.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.458.i, <8 x double> %.476.i, <8 x double> %a03.2.1693.i)
  %scevgep5 = getelementptr i8, ptr %scevgep25, i64 -16
  %.510.i = load double, ptr %scevgep5, align 8, !noalias !9
  %.512.i = insertelement <8 x double> poison, double %.510.i, i64 0
  %.513.i = shufflevector <8 x double> %.512.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.514.i6 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.420.i, <8 x double> %.513.i, <8 x double> %a10.2.1694.i)
  %.518.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.432.i, <8 x double> %.513.i, <8 x double> %a11.2.1695.i)
  %.526.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.445.i, <8 x double> %.513.i, <8 x double> %a12.2.1696.i)
  %.530.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.458.i, <8 x double> %.513.i, <8 x double> %a13.2.1697.i)
  %scevgep2 = getelementptr i8, ptr %scevgep25, i64 -8
  %.548.i = load double, ptr %scevgep2, align 8, !noalias !9
  %.550.i = insertelement <8 x double> poison, double %.548.i, i64 0
  %.551.i = shufflevector <8 x double> %.550.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.552.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.420.i, <8 x double> %.551.i, <8 x double> %a20.2.1698.i)
  %.556.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.432.i, <8 x double> %.551.i, <8 x double> %a21.2.1699.i)
  %.564.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.445.i, <8 x double> %.551.i, <8 x double> %a22.2.1700.i)
  %.568.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.458.i, <8 x double> %.551.i, <8 x double> %a23.2.1701.i)
  %.586.i = load double, ptr %scevgep25, align 8, !noalias !9
  %.588.i = insertelement <8 x double> poison, double %.586.i, i64 0
  %.589.i = shufflevector <8 x double> %.588.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.590.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.420.i, <8 x double> %.589.i, <8 x double> %a30.2.1702.i)
  %.594.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.432.i, <8 x double> %.589.i, <8 x double> %a31.2.1703.i)
  %.602.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.445.i, <8 x double> %.589.i, <8 x double> %a32.2.1704.i)
  %.606.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.458.i, <8 x double> %.589.i, <8 x double> %a33.2.1705.i)
  %lsr.iv.next17.i = add nuw i64 %lsr.iv16.i, 64
  %lsr.iv.next34.i = add i64 %lsr.iv33.i, -1
  %exitcond.not.i7 = icmp eq i64 %lsr.iv.next34.i, 0
  br i1 %exitcond.not.i7, label %B1232.loopexit.i, label %B290.if.i

B2140.else.i:                                     ; preds = %B1232.i, %B674.endif.else.endif.endif
  %position.4.0.lcssa.i = phi i64 [ 0, %B674.endif.else.endif.endif ], [ %position.3.1.lcssa.i, %B1232.i ]
  br i1 %31, label %B674.endif.endif.endif, label %B2140.endif.endif.endif.i

B2140.endif.endif.endif.i:                        ; preds = %B2140.else.i
  %.arg.count683.i = tail call i64 @llvm.smax.i64(i64 %.2110, i64 0)
  %39 = getelementptr double, ptr %.2048, i64 %.150
  %40 = getelementptr i8, ptr %.2048, i64 %.idx
  %41 = getelementptr i8, ptr %.2048, i64 %.idx1049
  %42 = shl i64 %.arg.count683.i, 3
  %43 = shl i64 %.2137.sroa.0.3, 3
  %scevgep30 = getelementptr i8, ptr %scevgep, i64 %43
  %44 = icmp slt i64 %.2110, 1
  br label %B2218.if.i

B2218.if.i:                                       ; preds = %B2140.endif.endif.endif.i, %B2654.i
  %position.6.0765.i = phi i64 [ %position.4.0.lcssa.i, %B2140.endif.endif.endif.i ], [ %position.5.1.lcssa.i, %B2654.i ]
  %.1034756764.i = phi i64 [ %.1011678.i, %B2140.endif.endif.endif.i ], [ %.1044.i, %B2654.i ]
  %.1041757763.i = phi i64 [ %.951.i, %B2140.endif.endif.endif.i ], [ %.1048.i, %B2654.i ]
  %.1044.i = add nsw i64 %.1034756764.i, -1
  %.1048.i = add nuw nsw i64 %.1041757763.i, 8
  br i1 %44, label %B2654.i, label %B2294.if.preheader.i

B2294.if.preheader.i:                             ; preds = %B2218.if.i
  %45 = shl i64 %position.6.0765.i, 3
  %scevgep.i9 = getelementptr i8, ptr %.1750, i64 %45
  br label %B2294.if.i

B2294.if.i:                                       ; preds = %B2294.if.i, %B2294.if.preheader.i
  %lsr.iv12.i = phi i64 [ %.2110, %B2294.if.preheader.i ], [ %lsr.iv.next13.i, %B2294.if.i ]
  %lsr.iv.i10 = phi i64 [ 0, %B2294.if.preheader.i ], [ %lsr.iv.next.i11, %B2294.if.i ]
  %b3.2.1748.i = phi <8 x double> [ zeroinitializer, %B2294.if.preheader.i ], [ %.1302.i, %B2294.if.i ]
  %b2.2.1747.i = phi <8 x double> [ zeroinitializer, %B2294.if.preheader.i ], [ %.1282.i, %B2294.if.i ]
  %b1.2.1746.i = phi <8 x double> [ zeroinitializer, %B2294.if.preheader.i ], [ %.1262.i, %B2294.if.i ]
  %b0.2.1745.i = phi <8 x double> [ zeroinitializer, %B2294.if.preheader.i ], [ %.1243.i, %B2294.if.i ]
  %scevgep3.i = getelementptr i8, ptr %scevgep.i9, i64 %lsr.iv.i10
  %.1224.i = load <8 x double>, ptr %scevgep3.i, align 8, !noalias !9
  %scevgep36 = getelementptr i8, ptr %scevgep30, i64 %lsr.iv.i10
  %scevgep37 = getelementptr i8, ptr %scevgep36, i64 -24
  %.1239.i = load double, ptr %scevgep37, align 8, !noalias !9
  %.1241.i = insertelement <8 x double> poison, double %.1239.i, i64 0
  %.1242.i = shufflevector <8 x double> %.1241.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1243.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1224.i, <8 x double> %.1242.i, <8 x double> %b0.2.1745.i)
  %scevgep12 = getelementptr i8, ptr %scevgep36, i64 -16
  %.1258.i = load double, ptr %scevgep12, align 8, !noalias !9
  %.1260.i = insertelement <8 x double> poison, double %.1258.i, i64 0
  %.1261.i = shufflevector <8 x double> %.1260.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1262.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1224.i, <8 x double> %.1261.i, <8 x double> %b1.2.1746.i)
  %scevgep10 = getelementptr i8, ptr %scevgep36, i64 -8
  %.1278.i = load double, ptr %scevgep10, align 8, !noalias !9
  %.1280.i = insertelement <8 x double> poison, double %.1278.i, i64 0
  %.1281.i = shufflevector <8 x double> %.1280.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1282.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1224.i, <8 x double> %.1281.i, <8 x double> %b2.2.1747.i)
  %.1298.i = load double, ptr %scevgep36, align 8, !noalias !9
  %.1300.i = insertelement <8 x double> poison, double %.1298.i, i64 0
  %.1301.i = shufflevector <8 x double> %.1300.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1302.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1224.i, <8 x double> %.1301.i, <8 x double> %b3.2.1748.i)
  %lsr.iv.next.i11 = add nuw i64 %lsr.iv.i10, 64
  %lsr.iv.next13.i = add i64 %lsr.iv12.i, -1
  %exitcond770.not.i = icmp eq i64 %lsr.iv.next13.i, 0
  br i1 %exitcond770.not.i, label %B2654.loopexit.i, label %B2294.if.i

B674.endif.endif.endif:                           ; preds = %B2654.i, %B2140.else.i
  %.1868 = icmp sgt i64 %.186710401044, 1
  br i1 %.1868, label %B672.if, label %B812

B846.else.if:                                     ; preds = %B846
  br label %B846.else.endif

B846.else.endif:                                  ; preds = %B846.else.if, %B846
  %.2432.sroa.0.1 = phi i64 [ 0, %B846.else.if ], [ %.2444, %B846 ]
  %.2452.not = icmp slt i64 %.2444, 1073741824
  br i1 %.2452.not, label %B846.else.endif.endif, label %B846.else.endif.if, !prof !1

B846.else.endif.if:                               ; preds = %B846.else.endif
  br label %B846.else.endif.endif

B846.else.endif.endif:                            ; preds = %B846.else.endif.if, %B846.else.endif
  %.2432.sroa.0.3 = phi i64 [ 1073741824, %B846.else.endif.if ], [ %.2432.sroa.0.1, %B846.else.endif ]
  %.2520 = sub nsw i64 1073741824, %.2432.sroa.0.3
  %.2529 = tail call i64 @llvm.smax.i64(i64 %.2520, i64 0)
  %.2545 = getelementptr double, ptr %arg.weights.4, i64 %.2432.sroa.0.3
  %.2628 = icmp slt i64 %.181.sroa.13.2, 9
  br i1 %.2628, label %B846.endif.else.endif.if, label %B846.endif.else.endif.endif, !prof !5

B846.endif.else.endif.if:                         ; preds = %B846.else.endif.endif
  br label %B846.endif.else.endif.endif

B846.endif.else.endif.endif:                      ; preds = %B846.endif.else.endif.if, %B846.else.endif.endif
  %.2608.sroa.0.3 = phi i64 [ %.181.sroa.13.2, %B846.endif.else.endif.if ], [ 8, %B846.else.endif.endif ]
  %.2721 = getelementptr double, ptr %arg.scratch.4, i64 %.2608.sroa.0.3
  store ptr null, ptr %.2758, align 8
  call fastcc void @inner_7(ptr nonnull %.2758, ptr %.652, i64 %arg.rows, ptr %arg.contents.4, ptr %.2545, i64 %.2529, ptr %.823, i64 %.807, ptr %.2721, i64 %.150)
  br label %B952
}

; Function Attrs: nofree noinline norecurse nosync nounwind memory(readwrite, inaccessiblemem: none, target_mem0: none, target_mem1: none)
define internal fastcc noundef range(i32 0, 2) i32 @inner_4(ptr noalias nonnull writeonly captures(none) %retptr, ptr noalias nonnull writeonly captures(none) %excinfo, i64 %arg.i, ptr readonly captures(none) %arg.row.4, ptr readonly captures(none) %arg.linear.4, i64 range(i64 8, 0) %arg.linear.5.0, ptr readonly captures(none) %arg.arguments.4, ptr readonly captures(none) %arg.contents.4, ptr readonly captures(none) %arg.weights.4, ptr %arg.scratch.4, double %arg.plus, double %arg.cross) unnamed_addr #5 {
entry:
  %.3408 = alloca i64, align 8
  store i64 0, ptr %.3408, align 8
  %.3536 = alloca i64, align 8
  store i64 0, ptr %.3536, align 8
  %.3662 = alloca i64, align 8
  store i64 0, ptr %.3662, align 8
  %.3817 = alloca i64, align 8
  store i64 0, ptr %.3817, align 8
  %.4367 = alloca ptr, align 8
  store ptr null, ptr %.4367, align 8
  %excinfo.33 = alloca ptr, align 8
  store ptr null, ptr %excinfo.33, align 8
  %.4534 = alloca double, align 8
  store double 0.000000e+00, ptr %.4534, align 8
  %excinfo.35 = alloca ptr, align 8
  store ptr null, ptr %excinfo.35, align 8
  %.6188 = alloca ptr, align 8
  store ptr null, ptr %.6188, align 8
  %.7151 = alloca ptr, align 8
  store ptr null, ptr %.7151, align 8
  %.125 = getelementptr i8, ptr %arg.arguments.4, i64 16
  %.126 = load i64, ptr %.125, align 8
  %.155 = getelementptr i8, ptr %arg.arguments.4, i64 32
  %.156 = load i64, ptr %.155, align 8
  %.185 = getelementptr i8, ptr %arg.arguments.4, i64 40
  %.186 = load i64, ptr %.185, align 8
  %.225 = getelementptr i8, ptr %arg.arguments.4, i64 24
  %.226 = load i64, ptr %.225, align 8
  %.229 = inttoptr i64 %.226 to ptr
  %.298 = getelementptr double, ptr %.229, i64 %.156
  %.356 = icmp sgt i64 %.186, 0
  br i1 %.356, label %B228, label %B308

B228:                                             ; preds = %entry
  %0 = getelementptr double, ptr %.298, i64 %.126
  %.367 = getelementptr i8, ptr %0, i64 -8
  %.368 = load double, ptr %.367, align 8
  %.377 = load double, ptr %.298, align 8
  %.378 = fsub contract double %.368, %.377
  %.380 = uitofp nneg i64 %.186 to double
  %.384 = fdiv contract double %.380, %.378
  br label %B308

B308:                                             ; preds = %B228, %entry
  %"$phi308.0.2.0" = phi double [ %.384, %B228 ], [ 0.000000e+00, %entry ]
  %.424 = getelementptr i8, ptr %arg.arguments.4, i64 48
  %.425 = load i64, ptr %.424, align 8
  %.532 = getelementptr i8, ptr %arg.contents.4, i64 56
  %.533 = load i64, ptr %.532, align 8
  %.563 = getelementptr i8, ptr %arg.contents.4, i64 64
  %.564 = load i64, ptr %.563, align 8
  %.573 = add i64 %.533, 7
  %.614 = and i64 %.573, -8
  %.619 = add i64 %.564, 7
  %.660 = and i64 %.619, -8
  %.667 = add nsw i64 %.660, %.614
  %.679.idx = shl nsw i64 %.667, 4
  %.679 = getelementptr inbounds i8, ptr %arg.linear.4, i64 %.679.idx
  %.764 = getelementptr i8, ptr %arg.contents.4, i64 144
  %.765 = load i64, ptr %.764, align 8
  %.771 = add nsw i64 %.765, 7
  %.812 = and i64 %.771, -8
  %.830 = shl nsw i64 %.667, 2
  %.831 = add nsw i64 %.830, 40
  %.832 = add nsw i64 %.831, %.614
  %.833 = add nsw i64 %.832, %.660
  %.837 = add nsw i64 %.833, 4144
  %.911 = getelementptr i8, ptr %arg.scratch.4, i64 320
  %.idx2 = shl i64 %.614, 5
  %1 = getelementptr i8, ptr %arg.scratch.4, i64 %.idx2
  %.975 = getelementptr i8, ptr %1, i64 320
  %.1052 = getelementptr inbounds double, ptr %arg.scratch.4, i64 %.831
  %.1115 = getelementptr inbounds double, ptr %arg.scratch.4, i64 %.832
  %.1178 = getelementptr inbounds double, ptr %arg.scratch.4, i64 %.837
  %.1264 = getelementptr double, ptr %arg.scratch.4, i64 %.833
  %.1389 = getelementptr i8, ptr %.1264, i64 16512
  %.1452 = getelementptr i8, ptr %.1264, i64 24768
  %.1546 = getelementptr i8, ptr %.1264, i64 33024
  %2 = getelementptr double, ptr %arg.scratch.4, i64 %.812
  %.1608 = getelementptr double, ptr %2, i64 %.837
  %.1672.idx = shl i64 %.812, 6
  %.1672 = getelementptr i8, ptr %.1608, i64 %.1672.idx
  %.1755.idx = shl i64 %.812, 7
  %.1755 = getelementptr i8, ptr %.1608, i64 %.1755.idx
  %.2714 = getelementptr i8, ptr %arg.contents.4, i64 112
  %.2715 = load i64, ptr %.2714, align 8
  %.2726 = getelementptr double, ptr %arg.weights.4, i64 %.2715
  %.2812 = getelementptr i8, ptr %arg.contents.4, i64 120
  %.2813 = load i64, ptr %.2812, align 8
  %.2824 = getelementptr double, ptr %arg.weights.4, i64 %.2813
  %.234.i = shl i64 %.614, 1
  %3 = add i64 %.533, 6
  %.486.i = lshr i64 %3, 3
  %.463.inv.i = icmp slt i64 %.533, 2
  %.507321.not325.i = icmp eq i64 %.486.i, 0
  %.507321.not.i = select i1 %.463.inv.i, i1 true, i1 %.507321.not325.i
  br i1 %.507321.not.i, label %B308.endif.endif.endif.en...endif.3.endif.endif, label %B94.if.lr.ph.i

B1920:                                            ; preds = %B308.endif.endif.endif.en...endif.4.endif
  %.4018 = getelementptr i8, ptr %arg.arguments.4, i64 112
  %.4019 = load i64, ptr %.4018, align 8
  %.4020.not = icmp eq i64 %.4019, 4
  %.4059 = getelementptr i8, ptr %arg.contents.4, i64 152
  %.4060 = load i64, ptr %.4059, align 8
  %.4071 = getelementptr inbounds double, ptr %arg.weights.4, i64 %.4060
  br i1 %.4020.not, label %B2104, label %B2002

B2002:                                            ; preds = %B1920
  store ptr null, ptr %.4367, align 8
  %.4393 = call fastcc i32 @inner_8(ptr nonnull %.4367, ptr nonnull %excinfo.33, ptr %arg.row.4, ptr %arg.linear.4, ptr %arg.contents.4, ptr %arg.weights.4, i64 %.3943, ptr nonnull %.911, ptr %.975, i64 %.614, ptr %arg.scratch.4, ptr %.1755, ptr %.1608, ptr %.1672)
  %cond = icmp eq i32 %.4393, 0
  br i1 %cond, label %B2002.endif, label %B2002.if, !prof !0

B2084:                                            ; preds = %B386.i, %B2002.endif
  %.586.inv.i = icmp sgt i64 %.765, 0
  %.587.i = select i1 %.586.inv.i, i64 0, i64 %.812
  %4 = getelementptr i64, ptr %.1178, i64 %.143.i
  %.601.i = getelementptr i64, ptr %4, i64 %.587.i
  store i64 %.3554, ptr %.601.i, align 8, !noalias !12
  %.4521 = icmp slt i64 %.3426, 1
  br i1 %.4521, label %B2292, label %B2104

B2104:                                            ; preds = %B1920, %B1920.thread, %B2084
  %"$phi1920.0.3.0716" = phi i1 [ true, %B2084 ], [ false, %B1920.thread ], [ false, %B1920 ]
  %.4071814 = phi ptr [ %.4071, %B2084 ], [ %.40716, %B1920.thread ], [ %.4071, %B1920 ]
  store double 0.000000e+00, ptr %.4534, align 8
  %.4548 = call fastcc i32 @inner_9(ptr nonnull %.4534, ptr nonnull %excinfo.35, ptr %arg.row.4, double %.3197, ptr %arg.weights.4, i64 %.3246, ptr %.679, i64 %.3943, ptr %.1264, ptr %arg.scratch.4)
  %.4558 = load double, ptr %.4534, align 8
  %cond1 = icmp eq i32 %.4548, 0
  br i1 %cond1, label %B2104.endif, label %B2104.if, !prof !0

B2222:                                            ; preds = %_ZN17bnserve_surrogate6kernel7_places9find_endsB4v142B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5TupleI5ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedExdE5ArrayIdLi1E1C7mutable7alignedExdx5ArrayIxLi1E1C7mutable7alignedE.exit575
  %.135.i576 = load double, ptr %.298, align 8, !noalias !15
  %.143.i577 = add nsw i64 %.533, -2
  %.181.i578 = icmp slt i64 %.533, 3
  %..143.i579 = select i1 %.181.i578, i64 0, i64 %.143.i577
  %.225207.i580 = icmp sgt i64 %..143.i579, 0
  br i1 %.225207.i580, label %B92.if.preheader.i584, label %_ZN17bnserve_surrogate6kernel7_places9find_endsB4v142B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5TupleI5ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedExdE5ArrayIdLi1E1C7mutable7alignedExdx5ArrayIxLi1E1C7mutable7alignedE.exit619

B2292:                                            ; preds = %_ZN17bnserve_surrogate6kernel7_places9find_endsB4v142B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5TupleI5ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedExdE5ArrayIdLi1E1C7mutable7alignedExdx5ArrayIxLi1E1C7mutable7alignedE.exit619, %_ZN17bnserve_surrogate6kernel7_places9find_endsB4v142B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5TupleI5ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedExdE5ArrayIdLi1E1C7mutable7alignedExdx5ArrayIxLi1E1C7mutable7alignedE.exit575, %B2084
  %"$phi1920.0.3.0717" = phi i1 [ %"$phi1920.0.3.0716", %_ZN17bnserve_surrogate6kernel7_places9find_endsB4v142B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5TupleI5ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedExdE5ArrayIdLi1E1C7mutable7alignedExdx5ArrayIxLi1E1C7mutable7alignedE.exit575 ], [ %"$phi1920.0.3.0716", %_ZN17bnserve_surrogate6kernel7_places9find_endsB4v142B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5TupleI5ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedExdE5ArrayIdLi1E1C7mutable7alignedExdx5ArrayIxLi1E1C7mutable7alignedE.exit619 ], [ true, %B2084 ]
  %.4071815 = phi ptr [ %.4071814, %_ZN17bnserve_surrogate6kernel7_places9find_endsB4v142B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5TupleI5ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedExdE5ArrayIdLi1E1C7mutable7alignedExdx5ArrayIxLi1E1C7mutable7alignedE.exit575 ], [ %.4071814, %_ZN17bnserve_surrogate6kernel7_places9find_endsB4v142B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5TupleI5ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedExdE5ArrayIdLi1E1C7mutable7alignedExdx5ArrayIxLi1E1C7mutable7alignedE.exit619 ], [ %.4071, %B2084 ]
  %constant.2.1 = phi double [ %.4558, %_ZN17bnserve_surrogate6kernel7_places9find_endsB4v142B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5TupleI5ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedExdE5ArrayIdLi1E1C7mutable7alignedExdx5ArrayIxLi1E1C7mutable7alignedE.exit575 ], [ %.4558, %_ZN17bnserve_surrogate6kernel7_places9find_endsB4v142B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5TupleI5ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedExdE5ArrayIdLi1E1C7mutable7alignedExdx5ArrayIxLi1E1C7mutable7alignedE.exit619 ], [ 0.000000e+00, %B2084 ]
  %5 = add nuw i64 %.126, 1023
  %.4912 = lshr i64 %5, 10
  %.4891.inv = icmp slt i64 %.126, 1
  %.idx = shl i64 %.156, 4
  %6 = getelementptr i8, ptr %.229, i64 %.idx
  %.idx3015 = mul i64 %.156, 24
  %.idx3016 = shl i64 %.156, 5
  %7 = getelementptr i8, ptr %.229, i64 %.idx3016
  %.6592 = getelementptr inbounds double, ptr %.4071815, i64 %.812
  %.6657.idx = shl nsw i64 %.812, 4
  %.6657 = getelementptr inbounds i8, ptr %.4071815, i64 %.6657.idx
  %.4933276.not285 = icmp eq i64 %.4912, 0
  %.4933276.not = select i1 %.4891.inv, i1 true, i1 %.4933276.not285
  br i1 %.4933276.not, label %B3804, label %B2352.lr.ph

B2352.lr.ph:                                      ; preds = %B2292
  %8 = icmp slt i64 %.533, -7
  %9 = tail call i64 @llvm.smax.i64(i64 %.4912, i64 1)
  %.277.i = mul nsw i64 %.614, 3
  %10 = getelementptr double, ptr %.911, i64 %.614
  %11 = getelementptr i8, ptr %.911, i64 %.3000.idx
  %.idx221.i = mul i64 %.614, 24
  %12 = getelementptr i8, ptr %.911, i64 %.idx221.i
  %13 = getelementptr double, ptr %.975, i64 %.660
  %.idx.i641 = shl i64 %.660, 4
  %14 = getelementptr i8, ptr %.975, i64 %.idx.i641
  %.idx221.i642 = mul i64 %.660, 24
  %15 = getelementptr i8, ptr %.975, i64 %.idx221.i642
  %16 = lshr i64 %.573, 3
  %17 = lshr i64 %.619, 3
  %18 = add nuw nsw i64 %17, %16
  %19 = mul i64 %18, 320
  %20 = getelementptr i8, ptr %arg.scratch.4, i64 %19
  %21 = mul i64 %16, 320
  %22 = shl i64 %17, 8
  %23 = shl i64 %18, 8
  %24 = getelementptr i8, ptr %arg.scratch.4, i64 %23
  %scevgep1171 = getelementptr i8, ptr %24, i64 328
  %scevgep1173 = getelementptr i8, ptr %20, i64 320
  %scevgep1185 = getelementptr i8, ptr %20, i64 25088
  %25 = shl i64 %arg.linear.5.0, 3
  %sunkaddr = select i1 %8, i64 %25, i64 0
  %26 = getelementptr i8, ptr %arg.scratch.4, i64 %21
  %27 = getelementptr i8, ptr %26, i64 %22
  %scevgep19 = getelementptr i8, ptr %27, i64 328
  %scevgep24 = getelementptr i8, ptr %20, i64 8576
  %sunkaddr90 = getelementptr inbounds i8, ptr %.3000, i64 %sunkaddr
  %sunkaddr91 = getelementptr i8, ptr %.679, i64 8
  %28 = icmp eq i64 %.3912, 0
  %sunkaddr105 = getelementptr i8, ptr %arg.scratch.4, i64 264
  %sunkaddr106 = getelementptr i8, ptr %arg.scratch.4, i64 256
  %sunkaddr107 = getelementptr i8, ptr %arg.scratch.4, i64 248
  %sunkaddr108 = getelementptr i8, ptr %arg.scratch.4, i64 240
  %sunkaddr109 = getelementptr i8, ptr %arg.scratch.4, i64 232
  %sunkaddr110 = getelementptr i8, ptr %arg.scratch.4, i64 224
  %sunkaddr111 = getelementptr i8, ptr %arg.scratch.4, i64 216
  %sunkaddr112 = getelementptr i8, ptr %arg.scratch.4, i64 208
  %sunkaddr113 = getelementptr i8, ptr %arg.scratch.4, i64 200
  %sunkaddr114 = getelementptr inbounds nuw i8, ptr %arg.scratch.4, i64 192
  %sunkaddr115 = getelementptr i8, ptr %arg.scratch.4, i64 184
  %sunkaddr116 = getelementptr i8, ptr %arg.scratch.4, i64 176
  %sunkaddr117 = getelementptr i8, ptr %arg.scratch.4, i64 168
  %sunkaddr118 = getelementptr i8, ptr %arg.scratch.4, i64 160
  %sunkaddr119 = getelementptr i8, ptr %arg.scratch.4, i64 152
  %sunkaddr120 = getelementptr i8, ptr %arg.scratch.4, i64 144
  %sunkaddr121 = getelementptr i8, ptr %arg.scratch.4, i64 136
  %sunkaddr122 = getelementptr i8, ptr %arg.scratch.4, i64 128
  %sunkaddr123 = getelementptr i8, ptr %arg.scratch.4, i64 120
  %sunkaddr124 = getelementptr i8, ptr %arg.scratch.4, i64 112
  %sunkaddr125 = getelementptr i8, ptr %arg.scratch.4, i64 104
  %sunkaddr126 = getelementptr i8, ptr %arg.scratch.4, i64 96
  %sunkaddr127 = getelementptr i8, ptr %arg.scratch.4, i64 88
  %sunkaddr128 = getelementptr i8, ptr %arg.scratch.4, i64 80
  %sunkaddr129 = getelementptr i8, ptr %arg.scratch.4, i64 72
  %sunkaddr130 = getelementptr inbounds nuw i8, ptr %arg.scratch.4, i64 64
  %sunkaddr131 = shl i64 %.156, 3
  br label %B2352

B2352:                                            ; preds = %B3750, %B2352.lr.ph
  %.4923.sroa.0.0284 = phi i64 [ 0, %B2352.lr.ph ], [ %.4923.sroa.0.0, %B3750 ]
  %.4880.1283.in = phi i64 [ %9, %B2352.lr.ph ], [ %40, %B3750 ]
  %.4877.1282 = phi i64 [ 1024, %B2352.lr.ph ], [ %.4877.1, %B3750 ]
  %cell.2.0281 = phi i64 [ 0, %B2352.lr.ph ], [ %cell.3.1, %B3750 ]
  %cell_p.3.0280 = phi i64 [ 0, %B2352.lr.ph ], [ %cell_p.4.1, %B3750 ]
  %cell_a.2.0279 = phi i64 [ 0, %B2352.lr.ph ], [ %cell_a.3.1, %B3750 ]
  %.4975 = add nsw i64 %.4923.sroa.0.0284, 1024
  %.13.i = tail call i64 @llvm.smin.i64(i64 %.126, i64 %.4975)
  %.13.i620 = tail call i64 @llvm.smax.i64(i64 %.4923.sroa.0.0284, i64 %.3554)
  %.13.i621 = tail call i64 @llvm.smin.i64(i64 %.13.i, i64 %.13.i620)
  %.13.i622 = tail call i64 @llvm.smax.i64(i64 %.4923.sroa.0.0284, i64 %.3426)
  %.13.i623 = tail call i64 @llvm.smin.i64(i64 %.13.i621, i64 %.13.i622)
  %.5134 = icmp sgt i64 %.13.i623, %.4923.sroa.0.0284
  br i1 %.5134, label %B2534, label %B2676

B2534:                                            ; preds = %B2352
  %.5165 = load double, ptr %arg.linear.4, align 8
  %.5197 = load double, ptr %sunkaddr90, align 8
  %.5215 = getelementptr double, ptr %.229, i64 %.4923.sroa.0.0284
  %.5268 = sub nsw i64 %.13.i623, %.4923.sroa.0.0284
  %.5298 = load double, ptr %sunkaddr91, align 8
  %.145103.not.i = icmp slt i64 %.5268, 1
  br i1 %.145103.not.i, label %B2676, label %B34.if.i

B2676:                                            ; preds = %B144.i, %B2534, %B2352
  br i1 %"$phi1920.0.3.0717", label %B2944, label %B2790

B2790:                                            ; preds = %B2676
  %29 = icmp slt i64 %.13.i622, %.13.i621
  br i1 %28, label %B2848, label %B2794

B2794:                                            ; preds = %B2790
  br i1 %29, label %B22.preheader.i, label %B2944

B22.preheader.i:                                  ; preds = %B2794
  %30 = mul i64 %.4923.sroa.0.0284, -8
  %scevgep25 = getelementptr i8, ptr %scevgep24, i64 %30
  br label %B22.i

B22.i:                                            ; preds = %B926.i, %B22.preheader.i
  %cell.2.0.i = phi i64 [ %cell.3.2.i, %B926.i ], [ %cell_p.3.0280, %B22.preheader.i ]
  %start.2.0.i = phi i64 [ %.13.i.i, %B926.i ], [ %.13.i623, %B22.preheader.i ]
  %.149.i = getelementptr inbounds i64, ptr %.1115, i64 %cell.2.0.i
  %.150.i = load i64, ptr %.149.i, align 8, !noalias !18
  %.154.not.i = icmp sgt i64 %.150.i, %start.2.0.i
  br i1 %.154.not.i, label %B112.i, label %B62.i

B62.i:                                            ; preds = %B22.i, %B62.i
  %cell.4.1.i = phi i64 [ %.157.i, %B62.i ], [ %cell.2.0.i, %B22.i ]
  %.157.i = add i64 %cell.4.1.i, 1
  %sunkaddr.i = shl i64 %cell.4.1.i, 3
  %scevgep20 = getelementptr i8, ptr %scevgep19, i64 %sunkaddr.i
  %.170.i = load i64, ptr %scevgep20, align 8, !noalias !18
  %.172.not.i = icmp sgt i64 %.170.i, %start.2.0.i
  br i1 %.172.not.i, label %B112.i, label %B62.i

B112.i:                                           ; preds = %B62.i, %B22.i
  %cell.3.2.i = phi i64 [ %cell.2.0.i, %B22.i ], [ %.157.i, %B62.i ]
  %.184.i = getelementptr inbounds i64, ptr %.1115, i64 %cell.3.2.i
  %.185.i = load i64, ptr %.184.i, align 8, !noalias !18
  %.13.i.i = tail call i64 @llvm.smin.i64(i64 %.13.i621, i64 %.185.i)
  %.395.i = sub i64 %.13.i.i, %start.2.0.i
  %31 = add i64 %.395.i, 7
  %.417.i = lshr i64 %31, 3
  %.396.inv.i = icmp slt i64 %.395.i, 1
  %.438305.not326.i = icmp eq i64 %.417.i, 0
  %.438305.not.i = or i1 %.396.inv.i, %.438305.not326.i
  br i1 %.438305.not.i, label %B926.i, label %B570.if.lr.ph.i

B926.i:                                           ; preds = %B570.if.i, %B112.i
  %.602.i = icmp slt i64 %.185.i, %.13.i621
  br i1 %.602.i, label %B22.i, label %B2944

B570.if.lr.ph.i:                                  ; preds = %B112.i
  %.228.i = getelementptr inbounds double, ptr %.2824, i64 %cell.3.2.i
  %.229.i = load double, ptr %.228.i, align 8, !noalias !18
  %.231.i = fsub contract double %.3209.le, %.229.i
  %.279.i = add nsw i64 %cell.3.2.i, %.277.i
  %.347.i = getelementptr inbounds double, ptr %.975, i64 %.279.i
  %.348.i = load double, ptr %.347.i, align 8, !noalias !18
  %.266.i = add nsw i64 %cell.3.2.i, %.234.i
  %.334.i = getelementptr inbounds double, ptr %.975, i64 %.266.i
  %.335.i = load double, ptr %.334.i, align 8, !noalias !18
  %.247.i = add nsw i64 %cell.3.2.i, %.614
  %.315.i = getelementptr inbounds double, ptr %.975, i64 %.247.i
  %.316.i = load double, ptr %.315.i, align 8, !noalias !18
  %.303.i = getelementptr inbounds double, ptr %.975, i64 %cell.3.2.i
  %.304.i = load double, ptr %.303.i, align 8, !noalias !18
  %.287.i = getelementptr inbounds double, ptr %.911, i64 %.279.i
  %.288.i = load double, ptr %.287.i, align 8, !noalias !18
  %.274.i = getelementptr inbounds double, ptr %.911, i64 %.266.i
  %.275.i = load double, ptr %.274.i, align 8, !noalias !18
  %.255.i = getelementptr inbounds double, ptr %.911, i64 %.247.i
  %.256.i = load double, ptr %.255.i, align 8, !noalias !18
  %.243.i = getelementptr inbounds double, ptr %.911, i64 %cell.3.2.i
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
  %lsr.iv21 = phi i64 [ %lsr.iv.next22, %B570.if.i ], [ %33, %B570.if.lr.ph.i ]
  %lsr.iv8.i = phi i64 [ %lsr.iv.next9.i, %B570.if.i ], [ %32, %B570.if.lr.ph.i ]
  %scevgep13.i = getelementptr i8, ptr %.298, i64 %lsr.iv8.i
  %.485.i = load <8 x double>, ptr %scevgep13.i, align 8, !noalias !18
  %.8.i.i = fadd contract <8 x double> %.7.i.i, %.485.i
  %.519.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i.i, <8 x double> %.515.i, <8 x double> %.518.i)
  %.523.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i.i, <8 x double> %.519.i, <8 x double> %.522.i)
  %.527.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i.i, <8 x double> %.523.i, <8 x double> %.526.i)
  %scevgep27 = getelementptr i8, ptr %scevgep25, i64 %lsr.iv8.i
  %scevgep30 = getelementptr i8, ptr %scevgep27, i64 -8256
  store <8 x double> %.527.i, ptr %scevgep30, align 8, !noalias !18
  %.546.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i.i, <8 x double> %.542.i, <8 x double> %.545.i)
  %.550.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i.i, <8 x double> %.546.i, <8 x double> %.549.i)
  %.554.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i.i, <8 x double> %.550.i, <8 x double> %.553.i)
  store <8 x double> %.554.i, ptr %scevgep27, align 8, !noalias !18
  %lsr.iv.next9.i = add i64 %lsr.iv8.i, 64
  %lsr.iv.next22 = add nsw i64 %lsr.iv21, -1
  %.438.i = icmp sgt i64 %lsr.iv21, 6
  br i1 %.438.i, label %B570.if.i, label %B926.i

B2848:                                            ; preds = %B2790
  br i1 %29, label %B22.preheader.i312, label %B2848.endif

B22.preheader.i312:                               ; preds = %B2848
  %34 = mul i64 %.4923.sroa.0.0284, -8
  %scevgep1174 = getelementptr i8, ptr %scevgep1173, i64 %34
  br label %B22.i314

B22.i314:                                         ; preds = %B612.i, %B22.preheader.i312
  %cell.2.0.i315 = phi i64 [ %cell.3.2.i321, %B612.i ], [ %cell_a.2.0279, %B22.preheader.i312 ]
  %start.2.0.i316 = phi i64 [ %.13.i.i323, %B612.i ], [ %.13.i623, %B22.preheader.i312 ]
  %.121.i = getelementptr inbounds i64, ptr %.1052, i64 %cell.2.0.i315
  %.122.i = load i64, ptr %.121.i, align 8, !noalias !21
  %.126.not.i = icmp sgt i64 %.122.i, %start.2.0.i316
  br i1 %.126.not.i, label %B112.i320, label %B62.i317

B62.i317:                                         ; preds = %B22.i314, %B62.i317
  %cell.4.1.i318 = phi i64 [ %.129.i, %B62.i317 ], [ %cell.2.0.i315, %B22.i314 ]
  %.129.i = add i64 %cell.4.1.i318, 1
  %sunkaddr.i319 = shl i64 %cell.4.1.i318, 3
  %scevgep1172 = getelementptr i8, ptr %scevgep1171, i64 %sunkaddr.i319
  %.142.i = load i64, ptr %scevgep1172, align 8, !noalias !21
  %.144.not.i = icmp sgt i64 %.142.i, %start.2.0.i316
  br i1 %.144.not.i, label %B112.i320, label %B62.i317

B112.i320:                                        ; preds = %B62.i317, %B22.i314
  %cell.3.2.i321 = phi i64 [ %cell.2.0.i315, %B22.i314 ], [ %.129.i, %B62.i317 ]
  %.156.i = getelementptr inbounds i64, ptr %.1052, i64 %cell.3.2.i321
  %.157.i322 = load i64, ptr %.156.i, align 8, !noalias !21
  %.13.i.i323 = tail call i64 @llvm.smin.i64(i64 %.13.i621, i64 %.157.i322)
  %.307.i = sub i64 %.13.i.i323, %start.2.0.i316
  %35 = add i64 %.307.i, 7
  %.329.i = lshr i64 %35, 3
  %.308.inv.i = icmp slt i64 %.307.i, 1
  %.350229.not250.i = icmp eq i64 %.329.i, 0
  %.350229.not.i = or i1 %.308.inv.i, %.350229.not250.i
  br i1 %.350229.not.i, label %B612.i, label %B412.if.lr.ph.i

B612.i:                                           ; preds = %B412.if.i, %B112.i320
  %.479.i = icmp slt i64 %.157.i322, %.13.i621
  br i1 %.479.i, label %B22.i314, label %B2848.endif

B412.if.lr.ph.i:                                  ; preds = %B112.i320
  %.200.i = getelementptr inbounds double, ptr %.2726, i64 %cell.3.2.i321
  %.201.i = load double, ptr %.200.i, align 8, !noalias !21
  %.203.i = fsub contract double %.3209.le, %.201.i
  %.259.i = getelementptr double, ptr %12, i64 %cell.3.2.i321
  %.260.i = load double, ptr %.259.i, align 8, !noalias !21
  %.246.i = getelementptr double, ptr %11, i64 %cell.3.2.i321
  %.247.i324 = load double, ptr %.246.i, align 8, !noalias !21
  %.227.i = getelementptr double, ptr %10, i64 %cell.3.2.i321
  %.228.i325 = load double, ptr %.227.i, align 8, !noalias !21
  %.215.i = getelementptr inbounds double, ptr %.911, i64 %cell.3.2.i321
  %.216.i = load double, ptr %.215.i, align 8, !noalias !21
  %.426.i = insertelement <8 x double> poison, double %.260.i, i64 0
  %.427.i = shufflevector <8 x double> %.426.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.429.i = insertelement <8 x double> poison, double %.247.i324, i64 0
  %.430.i = shufflevector <8 x double> %.429.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.433.i = insertelement <8 x double> poison, double %.228.i325, i64 0
  %.434.i = shufflevector <8 x double> %.433.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.437.i = insertelement <8 x double> poison, double %.216.i, i64 0
  %.438.i326 = shufflevector <8 x double> %.437.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.6.i.i327 = insertelement <8 x double> poison, double %.203.i, i64 0
  %.7.i.i328 = shufflevector <8 x double> %.6.i.i327, <8 x double> poison, <8 x i32> zeroinitializer
  %36 = shl i64 %start.2.0.i316, 3
  %37 = add nuw nsw i64 %.329.i, 5
  br label %B412.if.i

B412.if.i:                                        ; preds = %B412.if.i, %B412.if.lr.ph.i
  %lsr.iv31 = phi i64 [ %lsr.iv.next32, %B412.if.i ], [ %37, %B412.if.lr.ph.i ]
  %lsr.iv8.i329 = phi i64 [ %lsr.iv.next9.i335, %B412.if.i ], [ %36, %B412.if.lr.ph.i ]
  %scevgep11.i331 = getelementptr i8, ptr %.298, i64 %lsr.iv8.i329
  %.397.i = load <8 x double>, ptr %scevgep11.i331, align 8, !noalias !21
  %.8.i.i332 = fadd contract <8 x double> %.7.i.i328, %.397.i
  %.431.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i.i332, <8 x double> %.427.i, <8 x double> %.430.i)
  %.435.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i.i332, <8 x double> %.431.i, <8 x double> %.434.i)
  %.439.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i.i332, <8 x double> %.435.i, <8 x double> %.438.i326)
  %scevgep1175 = getelementptr i8, ptr %scevgep1174, i64 %lsr.iv8.i329
  store <8 x double> %.439.i, ptr %scevgep1175, align 8, !noalias !21
  %lsr.iv.next9.i335 = add i64 %lsr.iv8.i329, 64
  %lsr.iv.next32 = add nsw i64 %lsr.iv31, -1
  %.350.i = icmp sgt i64 %lsr.iv31, 6
  br i1 %.350.i, label %B412.if.i, label %B612.i

B2944:                                            ; preds = %B926.i, %B612.i703, %B2848.endif, %B2794, %B2676
  %cell_a.3.1 = phi i64 [ %cell.5.1.i311, %B612.i703 ], [ %cell.5.1.i311, %B2848.endif ], [ %cell_a.2.0279, %B2676 ], [ %cell_a.2.0279, %B2794 ], [ %cell_a.2.0279, %B926.i ]
  %cell_p.4.1 = phi i64 [ %cell.3.2.i659, %B612.i703 ], [ %cell_p.3.0280, %B2848.endif ], [ %cell_p.3.0280, %B2676 ], [ %cell_p.3.0280, %B2794 ], [ %cell.3.2.i, %B926.i ]
  %direct.2.1 = phi i64 [ %.13.i621, %B612.i703 ], [ %.13.i621, %B2848.endif ], [ %.13.i623, %B2676 ], [ %.13.i621, %B2794 ], [ %.13.i621, %B926.i ]
  %.5719 = icmp sgt i64 %direct.2.1, %.4923.sroa.0.0284
  br i1 %.5719, label %B2958, label %B3524

B2958:                                            ; preds = %B2944
  %.5723 = sub nsw i64 %direct.2.1, %.4923.sroa.0.0284
  %.5728 = sub nsw i64 %.13.i519, %.4923.sroa.0.0284
  %.13.i336 = tail call i64 @llvm.smax.i64(i64 %.5728, i64 0)
  %.13.i706 = tail call i64 @llvm.smin.i64(i64 %.5723, i64 %.13.i336)
  %.5787 = sub nsw i64 %.13.i520, %.4923.sroa.0.0284
  %.13.i707 = tail call i64 @llvm.smax.i64(i64 %.5787, i64 0)
  %.13.i708 = tail call i64 @llvm.smin.i64(i64 %.5723, i64 %.13.i707)
  %.5862 = getelementptr double, ptr %.229, i64 %.4923.sroa.0.0284
  %.5999 = getelementptr double, ptr %6, i64 %.4923.sroa.0.0284
  %.6131 = getelementptr double, ptr %7, i64 %.4923.sroa.0.0284
  store ptr null, ptr %.6188, align 8
  call fastcc void @inner_10(ptr nonnull %.6188, ptr %.5862, ptr %.5999, ptr %.6131, i64 %.13.i706, i64 %.13.i708, i64 %.5723, double %.3197, ptr %arg.scratch.4, double %constant.2.1, ptr %.1264, ptr %.1389)
  %38 = add nuw i64 %.5723, 7
  %.1167.i = lshr i64 %38, 3
  %.1144.inv.i = icmp slt i64 %.5723, 1
  %.1189570.not574.i = icmp eq i64 %.1167.i, 0
  %.1189570.not.i = or i1 %.1144.inv.i, %.1189570.not574.i
  br i1 %.1189570.not.i, label %B3524, label %B484.if.lr.ph.i

B3524:                                            ; preds = %B484.if.i, %B2958, %B2944
  %.137.i = icmp slt i64 %.13.i622, %.13.i621
  %or.cond26 = and i1 %"$phi1920.0.3.0717", %.137.i
  br i1 %or.cond26, label %B22.preheader.i770, label %B3750

B3750:                                            ; preds = %B1344.i, %B3524
  %cell.3.1 = phi i64 [ %cell.2.0281, %B3524 ], [ %cell.3.2.i780, %B1344.i ]
  store ptr null, ptr %.7151, align 8
  call fastcc void @inner_11(ptr nonnull %.7151, i64 %arg.i, i64 %.4923.sroa.0.0284, i64 %.13.i621, i64 %.13.i, ptr %arg.arguments.4, ptr %.1389, ptr %.1452, double %arg.plus, double %arg.cross, ptr %.1546)
  %.4933 = icmp samesign ugt i64 %.4880.1283.in, 1
  %.4946 = add i64 %.4877.1282, 1024
  %.4877.1 = select i1 %.4933, i64 %.4946, i64 %.4877.1282
  %39 = tail call i64 @llvm.smax.i64(i64 %.4880.1283.in, i64 2)
  %40 = add nsw i64 %39, -1
  %.4923.sroa.0.0 = select i1 %.4933, i64 %.4877.1282, i64 0
  br i1 %.4933, label %B2352, label %B3804

common.ret:                                       ; preds = %B2104.if, %B2002.if, %B3804
  %common.ret.op = phi i32 [ 0, %B3804 ], [ 1, %B2104.if ], [ 1, %B2002.if ]
  ret i32 %common.ret.op

B3804:                                            ; preds = %B3750, %B2292
  store ptr null, ptr %retptr, align 8
  br label %common.ret

B94.if.lr.ph.i:                                   ; preds = %B308
  %41 = tail call i64 @llvm.smax.i64(i64 %.234.i, i64 0)
  %.260.sroa.0.3.i = tail call i64 @llvm.smin.i64(i64 %41, i64 1073741824)
  %42 = tail call i64 @llvm.smax.i64(i64 %.614, i64 0)
  %.88.sroa.0.3.i = tail call i64 @llvm.smin.i64(i64 %42, i64 1073741824)
  %43 = getelementptr double, ptr %.911, i64 %.614
  %44 = getelementptr double, ptr %.911, i64 %.234.i
  %.idx.i440 = mul i64 %.614, 24
  %45 = getelementptr i8, ptr %.911, i64 %.idx.i440
  %46 = shl i64 %.573, 3
  %47 = and i64 %46, -64
  %48 = getelementptr i8, ptr %arg.linear.4, i64 %47
  %scevgep1223 = getelementptr i8, ptr %48, i64 8
  %49 = add i64 %.260.sroa.0.3.i, %.2715
  %50 = shl i64 %49, 3
  %scevgep76 = getelementptr i8, ptr %arg.weights.4, i64 %50
  %51 = add i64 %.88.sroa.0.3.i, %.2715
  %52 = shl i64 %51, 3
  %scevgep78 = getelementptr i8, ptr %arg.weights.4, i64 %52
  %53 = add nuw nsw i64 %.486.i, 5
  br label %B94.if.i

B94.if.i:                                         ; preds = %B94.if.i, %B94.if.lr.ph.i
  %lsr.iv58 = phi i64 [ %lsr.iv.next59, %B94.if.i ], [ %53, %B94.if.lr.ph.i ]
  %lsr.iv53.i = phi i64 [ %lsr.iv.next54.i, %B94.if.i ], [ 0, %B94.if.lr.ph.i ]
  %sunkaddr92 = getelementptr i8, ptr %arg.linear.4, i64 %lsr.iv53.i
  %.554.i443 = load <8 x double>, ptr %sunkaddr92, align 8, !noalias !24
  %sunkaddr94 = getelementptr i8, ptr %sunkaddr92, i64 8
  %.565.i = load <8 x double>, ptr %sunkaddr94, align 8, !noalias !24
  %scevgep1225 = getelementptr i8, ptr %scevgep1223, i64 %lsr.iv53.i
  %scevgep1226 = getelementptr i8, ptr %scevgep1225, i64 -8
  %.575.i = load <8 x double>, ptr %scevgep1226, align 8, !noalias !24
  %.586.i = load <8 x double>, ptr %scevgep1225, align 8, !noalias !24
  %scevgep79 = getelementptr i8, ptr %scevgep78, i64 %lsr.iv53.i
  %.596.i = load <8 x double>, ptr %scevgep79, align 8, !noalias !24
  %scevgep77 = getelementptr i8, ptr %scevgep76, i64 %lsr.iv53.i
  %.606.i = load <8 x double>, ptr %scevgep77, align 8, !noalias !24
  %.6.i.i444 = fsub contract <8 x double> %.565.i, %.554.i443
  %.6.i46.i = fmul contract <8 x double> %.6.i.i444, %.606.i
  %scevgep65.i = getelementptr i8, ptr %.911, i64 %lsr.iv53.i
  store <8 x double> %.554.i443, ptr %scevgep65.i, align 8, !noalias !24
  %.669.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.575.i, <8 x double> splat (double 2.000000e+00), <8 x double> %.586.i)
  %.8.i.i445 = fmul contract <8 x double> %.669.i, splat (double 0x3FC5555555555555)
  %.6.i47.i = fmul contract <8 x double> %.596.i, %.8.i.i445
  %.6.i48.i = fsub contract <8 x double> %.6.i46.i, %.6.i47.i
  %scevgep64.i = getelementptr i8, ptr %43, i64 %lsr.iv53.i
  store <8 x double> %.6.i48.i, ptr %scevgep64.i, align 8, !noalias !24
  %.8.i49.i = fmul contract <8 x double> %.575.i, splat (double 5.000000e-01)
  %scevgep63.i = getelementptr i8, ptr %44, i64 %lsr.iv53.i
  store <8 x double> %.8.i49.i, ptr %scevgep63.i, align 8, !noalias !24
  %.6.i50.i = fsub contract <8 x double> %.586.i, %.575.i
  %.6.i51.i = fmul contract <8 x double> %.6.i50.i, %.606.i
  %.8.i52.i = fmul contract <8 x double> %.6.i51.i, splat (double 0x3FC5555555555555)
  %scevgep62.i = getelementptr i8, ptr %45, i64 %lsr.iv53.i
  store <8 x double> %.8.i52.i, ptr %scevgep62.i, align 8, !noalias !24
  %lsr.iv.next54.i = add i64 %lsr.iv53.i, 64
  %lsr.iv.next59 = add nsw i64 %lsr.iv58, -1
  %.507.i = icmp sgt i64 %lsr.iv58, 6
  br i1 %.507.i, label %B94.if.i, label %B308.endif.endif.endif.en...endif.3.endif.endif

B308.endif.endif.endif.en...endif.3.endif.endif:  ; preds = %B94.if.i, %B308
  %.3000.idx = shl i64 %.614, 4
  %.3000 = getelementptr i8, ptr %arg.linear.4, i64 %.3000.idx
  %54 = add i64 %.564, 6
  %.486.i478 = lshr i64 %54, 3
  %.463.inv.i479 = icmp slt i64 %.564, 2
  %.507321.not325.i480 = icmp eq i64 %.486.i478, 0
  %.507321.not.i481 = select i1 %.463.inv.i479, i1 true, i1 %.507321.not325.i480
  br i1 %.507321.not.i481, label %B308.endif.endif.endif.en...endif.4.endif, label %B94.if.lr.ph.i482

B94.if.lr.ph.i482:                                ; preds = %B308.endif.endif.endif.en...endif.3.endif.endif
  %.234.i468 = shl i64 %.660, 1
  %55 = tail call i64 @llvm.smax.i64(i64 %.234.i468, i64 0)
  %.260.sroa.0.3.i476 = tail call i64 @llvm.smin.i64(i64 %55, i64 1073741824)
  %56 = tail call i64 @llvm.smax.i64(i64 %.660, i64 0)
  %.88.sroa.0.3.i466 = tail call i64 @llvm.smin.i64(i64 %56, i64 1073741824)
  %57 = getelementptr double, ptr %.975, i64 %.660
  %.idx.i483 = mul i64 %.660, 24
  %58 = shl i64 %.573, 5
  %59 = and i64 %58, -256
  %60 = shl i64 %.619, 3
  %61 = and i64 %60, -64
  %62 = getelementptr i8, ptr %.3000, i64 %61
  %scevgep1213 = getelementptr i8, ptr %62, i64 8
  %63 = shl i64 %.619, 4
  %64 = and i64 %63, -128
  %65 = add i64 %.260.sroa.0.3.i476, %.2813
  %66 = shl i64 %65, 3
  %scevgep70 = getelementptr i8, ptr %arg.weights.4, i64 %66
  %67 = add i64 %.88.sroa.0.3.i466, %.2813
  %68 = shl i64 %67, 3
  %scevgep72 = getelementptr i8, ptr %arg.weights.4, i64 %68
  %69 = getelementptr i8, ptr %arg.scratch.4, i64 %59
  %70 = getelementptr i8, ptr %69, i64 %64
  %scevgep44 = getelementptr i8, ptr %70, i64 320
  %71 = add nuw nsw i64 %.486.i478, 5
  %72 = getelementptr i8, ptr %69, i64 %.idx.i483
  %scevgep56 = getelementptr i8, ptr %72, i64 320
  br label %B94.if.i484

B94.if.i484:                                      ; preds = %B94.if.i484, %B94.if.lr.ph.i482
  %lsr.iv54 = phi i64 [ %lsr.iv.next55, %B94.if.i484 ], [ %71, %B94.if.lr.ph.i482 ]
  %lsr.iv53.i485 = phi i64 [ %lsr.iv.next54.i514, %B94.if.i484 ], [ 0, %B94.if.lr.ph.i482 ]
  %sunkaddr95 = getelementptr i8, ptr %.3000, i64 %lsr.iv53.i485
  %.554.i488 = load <8 x double>, ptr %sunkaddr95, align 8, !noalias !27
  %sunkaddr97 = getelementptr i8, ptr %sunkaddr95, i64 8
  %.565.i490 = load <8 x double>, ptr %sunkaddr97, align 8, !noalias !27
  %scevgep1215 = getelementptr i8, ptr %scevgep1213, i64 %lsr.iv53.i485
  %scevgep1216 = getelementptr i8, ptr %scevgep1215, i64 -8
  %.575.i492 = load <8 x double>, ptr %scevgep1216, align 8, !noalias !27
  %.586.i494 = load <8 x double>, ptr %scevgep1215, align 8, !noalias !27
  %scevgep73 = getelementptr i8, ptr %scevgep72, i64 %lsr.iv53.i485
  %.596.i496 = load <8 x double>, ptr %scevgep73, align 8, !noalias !27
  %scevgep71 = getelementptr i8, ptr %scevgep70, i64 %lsr.iv53.i485
  %.606.i498 = load <8 x double>, ptr %scevgep71, align 8, !noalias !27
  %.6.i.i499 = fsub contract <8 x double> %.565.i490, %.554.i488
  %.6.i46.i500 = fmul contract <8 x double> %.6.i.i499, %.606.i498
  %scevgep65.i501 = getelementptr i8, ptr %.975, i64 %lsr.iv53.i485
  store <8 x double> %.554.i488, ptr %scevgep65.i501, align 8, !noalias !27
  %.669.i502 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.575.i492, <8 x double> splat (double 2.000000e+00), <8 x double> %.586.i494)
  %.8.i.i503 = fmul contract <8 x double> %.669.i502, splat (double 0x3FC5555555555555)
  %.6.i47.i504 = fmul contract <8 x double> %.596.i496, %.8.i.i503
  %.6.i48.i505 = fsub contract <8 x double> %.6.i46.i500, %.6.i47.i504
  %scevgep64.i506 = getelementptr i8, ptr %57, i64 %lsr.iv53.i485
  store <8 x double> %.6.i48.i505, ptr %scevgep64.i506, align 8, !noalias !27
  %.8.i49.i507 = fmul contract <8 x double> %.575.i492, splat (double 5.000000e-01)
  %scevgep45 = getelementptr i8, ptr %scevgep44, i64 %lsr.iv53.i485
  store <8 x double> %.8.i49.i507, ptr %scevgep45, align 8, !noalias !27
  %.6.i50.i509 = fsub contract <8 x double> %.586.i494, %.575.i492
  %.6.i51.i510 = fmul contract <8 x double> %.6.i50.i509, %.606.i498
  %.8.i52.i511 = fmul contract <8 x double> %.6.i51.i510, splat (double 0x3FC5555555555555)
  %scevgep57 = getelementptr i8, ptr %scevgep56, i64 %lsr.iv53.i485
  store <8 x double> %.8.i52.i511, ptr %scevgep57, align 8, !noalias !27
  %lsr.iv.next54.i514 = add i64 %lsr.iv53.i485, 64
  %lsr.iv.next55 = add nsw i64 %lsr.iv54, -1
  %.507.i515 = icmp sgt i64 %lsr.iv54, 6
  br i1 %.507.i515, label %B94.if.i484, label %B308.endif.endif.endif.en...endif.4.endif

B308.endif.endif.endif.en...endif.4.endif:        ; preds = %B94.if.i484, %B308.endif.endif.endif.en...endif.3.endif.endif
  %73 = inttoptr i64 %.425 to ptr
  %.3195 = getelementptr i8, ptr %arg.row.4, i64 56
  %.3196 = load double, ptr %.3195, align 8
  %.3197 = fmul contract double %.3196, 0x3ED4A8B4A9ED04E3
  %.3209.le = tail call contract double @llvm.log.f64(double %.3197)
  %.3245 = getelementptr i8, ptr %arg.contents.4, i64 128
  %.3246 = load i64, ptr %.3245, align 8
  %74 = lshr i64 %.3246, 33
  %.3265 = and i64 %74, 1073741824
  %75 = getelementptr double, ptr %arg.weights.4, i64 %.3246
  %.3279 = getelementptr double, ptr %75, i64 %.3265
  %.3280 = load double, ptr %.3279, align 8
  %.3296 = icmp slt i64 %.3246, -1
  %.3297 = select i1 %.3296, i64 1073741824, i64 0
  %76 = getelementptr i8, ptr %75, i64 8
  %.3311 = getelementptr double, ptr %76, i64 %.3297
  %.3312 = load double, ptr %.3311, align 8
  %.3348 = fmul contract double %.3280, 0x3FEFFFFFFF768FA1
  %.3356.le = tail call contract double @llvm.log.f64(double %.3348)
  %.3362 = fsub contract double %.3356.le, %.3209.le
  store i64 0, ptr %.3408, align 8
  call fastcc void @inner_12(ptr nonnull %.3408, ptr %.298, i64 %.126, ptr %73, i64 %.186, double %"$phi308.0.2.0", double %.3362)
  %.3426 = load i64, ptr %.3408, align 8
  %.3476 = fmul contract double %.3312, 0x3FF000000044B830
  %.3484.le = tail call contract double @llvm.log.f64(double %.3476)
  %.3490 = fsub contract double %.3484.le, %.3209.le
  store i64 0, ptr %.3536, align 8
  call fastcc void @inner_12(ptr nonnull %.3536, ptr %.298, i64 %.126, ptr %73, i64 %.186, double %"$phi308.0.2.0", double %.3490)
  %.3554 = load i64, ptr %.3536, align 8
  %.3616 = fsub contract double 0xC0126BB1BBB55515, %.3209.le
  store i64 0, ptr %.3662, align 8
  call fastcc void @inner_12(ptr nonnull %.3662, ptr %.298, i64 %.126, ptr %73, i64 %.186, double %"$phi308.0.2.0", double %.3616)
  %.3680 = load i64, ptr %.3662, align 8
  %.13.i519 = tail call i64 @llvm.smin.i64(i64 %.3554, i64 %.3680)
  %.3771 = fsub contract double 0xC00F4BD2B7AC1BAF, %.3209.le
  store i64 0, ptr %.3817, align 8
  call fastcc void @inner_12(ptr nonnull %.3817, ptr %.298, i64 %.126, ptr %73, i64 %.186, double %"$phi308.0.2.0", double %.3771)
  %.3835 = load i64, ptr %.3817, align 8
  %.13.i520 = tail call i64 @llvm.smin.i64(i64 %.3554, i64 %.3835)
  %.3911 = getelementptr i8, ptr %arg.contents.4, i64 72
  %.3912 = load i64, ptr %.3911, align 8
  %.3942 = getelementptr i8, ptr %arg.arguments.4, i64 88
  %.3943 = load i64, ptr %.3942, align 8
  %.3979 = load i64, ptr %.764, align 8
  %.3980 = icmp sgt i64 %.3979, 0
  %.3986 = icmp sgt i64 %.126, 2047
  %or.cond = select i1 %.3980, i1 %.3986, i1 false
  br i1 %or.cond, label %B1920, label %B1920.thread

B1920.thread:                                     ; preds = %B308.endif.endif.endif.en...endif.4.endif
  %.40594 = getelementptr i8, ptr %arg.contents.4, i64 152
  %.40605 = load i64, ptr %.40594, align 8
  %.40716 = getelementptr inbounds double, ptr %arg.weights.4, i64 %.40605
  br label %B2104

B2002.if:                                         ; preds = %B2002
  %.4394 = load ptr, ptr %excinfo.33, align 8
  store ptr %.4394, ptr %excinfo, align 8
  br label %common.ret

B2002.endif:                                      ; preds = %B2002
  %.135.i = load double, ptr %.298, align 8, !noalias !12
  %.143.i = add nsw i64 %.765, -1
  %.181.i = icmp slt i64 %.765, 2
  %..143.i = select i1 %.181.i, i64 0, i64 %.143.i
  %.225207.i = icmp sgt i64 %..143.i, 0
  br i1 %.225207.i, label %B92.if.preheader.i, label %B2084

B92.if.preheader.i:                               ; preds = %B2002.endif
  %77 = add i64 %.3554, -1
  %78 = shl i64 %.156, 3
  %79 = getelementptr i8, ptr %.229, i64 %78
  %scevgep1209 = getelementptr i8, ptr %79, i64 8
  br label %B92.if.i

B146.i:                                           ; preds = %B92.if.i
  %.291.i = fsub contract double %.281.i, %.135.i
  %.293.i = fmul contract double %"$phi308.0.2.0", %.291.i
  %.5.i.i = fptosi double %.293.i to i64
  %.13.i5.i = tail call i64 @llvm.smin.i64(i64 %.186, i64 %.5.i.i)
  %.354.i = getelementptr inbounds i64, ptr %73, i64 %.13.i5.i
  %.355.i = load i64, ptr %.354.i, align 8, !noalias !12
  %.13.i6.i = tail call i64 @llvm.smax.i64(i64 %.355.i, i64 %end.3.0210.i)
  %.395.i523 = icmp slt i64 %.13.i6.i, %.3554
  br i1 %.395.i523, label %B284.i, label %B386.i

B284.i:                                           ; preds = %B146.i
  %.412.i = getelementptr inbounds nuw double, ptr %.298, i64 %.13.i6.i
  %.413.i = load double, ptr %.412.i, align 8, !noalias !12
  %.417.i525 = fcmp contract ugt double %.413.i, %.281.i
  br i1 %.417.i525, label %B386.i, label %B324.i

B324.i:                                           ; preds = %B284.i, %B346.i
  %end.5.2.i = phi i64 [ %.423.i, %B346.i ], [ %.13.i6.i, %B284.i ]
  %exitcond.not.i = icmp eq i64 %77, %end.5.2.i
  br i1 %exitcond.not.i, label %B386.i, label %B346.i

B346.i:                                           ; preds = %B324.i
  %.423.i = add i64 %end.5.2.i, 1
  %80 = shl i64 %end.5.2.i, 3
  %scevgep1210 = getelementptr i8, ptr %scevgep1209, i64 %80
  %.451.i = load double, ptr %scevgep1210, align 8, !noalias !12
  %.455.i = fcmp contract ugt double %.451.i, %.281.i
  br i1 %.455.i, label %B386.i, label %B324.i

B386.i:                                           ; preds = %B346.i, %B324.i, %B92.if.i, %B284.i, %B146.i
  %end.4.1.i = phi i64 [ %.13.i6.i, %B146.i ], [ %end.3.0210.i, %B92.if.i ], [ %.13.i6.i, %B284.i ], [ %.3554, %B324.i ], [ %.423.i, %B346.i ]
  %.13.i.i524 = tail call i64 @llvm.smin.i64(i64 %.3554, i64 %end.4.1.i)
  %81 = getelementptr i64, ptr %.1178, i64 %.231203208.i
  store i64 %.13.i.i524, ptr %81, align 8, !noalias !12
  %exitcond216.not.i = icmp eq i64 %.238.i, %..143.i
  br i1 %exitcond216.not.i, label %B2084, label %B92.if.i

B92.if.i:                                         ; preds = %B386.i, %B92.if.preheader.i
  %end.3.0210.i = phi i64 [ %end.4.1.i, %B386.i ], [ 0, %B92.if.preheader.i ]
  %.231203208.i = phi i64 [ %.238.i, %B386.i ], [ 0, %B92.if.preheader.i ]
  %.238.i = add nuw nsw i64 %.231203208.i, 1
  %.278.i = getelementptr inbounds nuw double, ptr %.4071, i64 %.231203208.i
  %.279.i521 = load double, ptr %.278.i, align 8, !noalias !12
  %.281.i = fsub contract double %.279.i521, %.3209.le
  %.287.i522 = fcmp contract ult double %.281.i, %.135.i
  br i1 %.287.i522, label %B386.i, label %B146.i

B2104.if:                                         ; preds = %B2104
  %.4549 = load ptr, ptr %excinfo.35, align 8
  store ptr %.4549, ptr %excinfo, align 8
  br label %common.ret

B2104.endif:                                      ; preds = %B2104
  %.135.i532 = load double, ptr %.298, align 8, !noalias !30
  %.143.i533 = add nsw i64 %.564, -2
  %.181.i534 = icmp slt i64 %.564, 3
  %..143.i535 = select i1 %.181.i534, i64 0, i64 %.143.i533
  %.225207.i536 = icmp sgt i64 %..143.i535, 0
  br i1 %.225207.i536, label %B92.if.preheader.i540, label %_ZN17bnserve_surrogate6kernel7_places9find_endsB4v142B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5TupleI5ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedExdE5ArrayIdLi1E1C7mutable7alignedExdx5ArrayIxLi1E1C7mutable7alignedE.exit575

B92.if.preheader.i540:                            ; preds = %B2104.endif
  %82 = add i64 %.3554, -1
  %83 = shl i64 %.156, 3
  %84 = getelementptr i8, ptr %.229, i64 %83
  %scevgep1207 = getelementptr i8, ptr %84, i64 8
  br label %B92.if.i541

B146.i549:                                        ; preds = %B92.if.i541
  %.291.i550 = fsub contract double %.281.i547, %.135.i532
  %.293.i551 = fmul contract double %"$phi308.0.2.0", %.291.i550
  %.5.i.i552 = fptosi double %.293.i551 to i64
  %.13.i5.i553 = tail call i64 @llvm.smin.i64(i64 %.186, i64 %.5.i.i552)
  %.354.i554 = getelementptr inbounds i64, ptr %73, i64 %.13.i5.i553
  %.355.i555 = load i64, ptr %.354.i554, align 8, !noalias !30
  %.13.i6.i556 = tail call i64 @llvm.smax.i64(i64 %.355.i555, i64 %end.3.0210.i542)
  %.395.i557 = icmp slt i64 %.13.i6.i556, %.3554
  br i1 %.395.i557, label %B284.i562, label %B386.i558

B284.i562:                                        ; preds = %B146.i549
  %.412.i563 = getelementptr inbounds nuw double, ptr %.298, i64 %.13.i6.i556
  %.413.i564 = load double, ptr %.412.i563, align 8, !noalias !30
  %.417.i565 = fcmp contract ugt double %.413.i564, %.281.i547
  br i1 %.417.i565, label %B386.i558, label %B324.i566

B324.i566:                                        ; preds = %B284.i562, %B346.i569
  %end.5.2.i567 = phi i64 [ %.423.i570, %B346.i569 ], [ %.13.i6.i556, %B284.i562 ]
  %exitcond.not.i568 = icmp eq i64 %82, %end.5.2.i567
  br i1 %exitcond.not.i568, label %B386.i558, label %B346.i569

B346.i569:                                        ; preds = %B324.i566
  %.423.i570 = add i64 %end.5.2.i567, 1
  %85 = shl i64 %end.5.2.i567, 3
  %scevgep1208 = getelementptr i8, ptr %scevgep1207, i64 %85
  %.451.i573 = load double, ptr %scevgep1208, align 8, !noalias !30
  %.455.i574 = fcmp contract ugt double %.451.i573, %.281.i547
  br i1 %.455.i574, label %B386.i558, label %B324.i566

B386.i558:                                        ; preds = %B346.i569, %B324.i566, %B92.if.i541, %B284.i562, %B146.i549
  %end.4.1.i559 = phi i64 [ %.13.i6.i556, %B146.i549 ], [ %end.3.0210.i542, %B92.if.i541 ], [ %.13.i6.i556, %B284.i562 ], [ %.3554, %B324.i566 ], [ %.423.i570, %B346.i569 ]
  %.13.i.i560 = tail call i64 @llvm.smin.i64(i64 %.3554, i64 %end.4.1.i559)
  %86 = getelementptr i64, ptr %.1115, i64 %.231203208.i543
  store i64 %.13.i.i560, ptr %86, align 8, !noalias !30
  %exitcond216.not.i561 = icmp eq i64 %.238.i544, %..143.i535
  br i1 %exitcond216.not.i561, label %_ZN17bnserve_surrogate6kernel7_places9find_endsB4v142B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5TupleI5ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedExdE5ArrayIdLi1E1C7mutable7alignedExdx5ArrayIxLi1E1C7mutable7alignedE.exit575, label %B92.if.i541

B92.if.i541:                                      ; preds = %B386.i558, %B92.if.preheader.i540
  %end.3.0210.i542 = phi i64 [ %end.4.1.i559, %B386.i558 ], [ 0, %B92.if.preheader.i540 ]
  %.231203208.i543 = phi i64 [ %.238.i544, %B386.i558 ], [ 0, %B92.if.preheader.i540 ]
  %.238.i544 = add nuw nsw i64 %.231203208.i543, 1
  %sunkaddr1239 = shl i64 %.231203208.i543, 3
  %sunkaddr1240 = getelementptr inbounds i8, ptr %.2824, i64 %sunkaddr1239
  %sunkaddr1241 = getelementptr inbounds nuw i8, ptr %sunkaddr1240, i64 8
  %.279.i546 = load double, ptr %sunkaddr1241, align 8, !noalias !30
  %.281.i547 = fsub contract double %.279.i546, %.3209.le
  %.287.i548 = fcmp contract ult double %.281.i547, %.135.i532
  br i1 %.287.i548, label %B386.i558, label %B146.i549

_ZN17bnserve_surrogate6kernel7_places9find_endsB4v142B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5TupleI5ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedExdE5ArrayIdLi1E1C7mutable7alignedExdx5ArrayIxLi1E1C7mutable7alignedE.exit575: ; preds = %B386.i558, %B2104.endif
  %87 = icmp eq i64 %.3912, 0
  %.586.inv.i537 = icmp sgt i64 %.564, 1
  %.587.i538 = select i1 %.586.inv.i537, i64 0, i64 %.660
  %88 = getelementptr i64, ptr %.1115, i64 %.143.i533
  %.601.i539 = getelementptr i64, ptr %88, i64 %.587.i538
  store i64 %.3554, ptr %.601.i539, align 8, !noalias !30
  br i1 %87, label %B2222, label %B2292

B92.if.preheader.i584:                            ; preds = %B2222
  %89 = add i64 %.3554, -1
  %90 = shl i64 %.156, 3
  %91 = getelementptr i8, ptr %.229, i64 %90
  %scevgep1205 = getelementptr i8, ptr %91, i64 8
  br label %B92.if.i585

B146.i593:                                        ; preds = %B92.if.i585
  %.291.i594 = fsub contract double %.281.i591, %.135.i576
  %.293.i595 = fmul contract double %"$phi308.0.2.0", %.291.i594
  %.5.i.i596 = fptosi double %.293.i595 to i64
  %.13.i5.i597 = tail call i64 @llvm.smin.i64(i64 %.186, i64 %.5.i.i596)
  %.354.i598 = getelementptr inbounds i64, ptr %73, i64 %.13.i5.i597
  %.355.i599 = load i64, ptr %.354.i598, align 8, !noalias !15
  %.13.i6.i600 = tail call i64 @llvm.smax.i64(i64 %.355.i599, i64 %end.3.0210.i586)
  %.395.i601 = icmp slt i64 %.13.i6.i600, %.3554
  br i1 %.395.i601, label %B284.i606, label %B386.i602

B284.i606:                                        ; preds = %B146.i593
  %.412.i607 = getelementptr inbounds nuw double, ptr %.298, i64 %.13.i6.i600
  %.413.i608 = load double, ptr %.412.i607, align 8, !noalias !15
  %.417.i609 = fcmp contract ugt double %.413.i608, %.281.i591
  br i1 %.417.i609, label %B386.i602, label %B324.i610

B324.i610:                                        ; preds = %B284.i606, %B346.i613
  %end.5.2.i611 = phi i64 [ %.423.i614, %B346.i613 ], [ %.13.i6.i600, %B284.i606 ]
  %exitcond.not.i612 = icmp eq i64 %89, %end.5.2.i611
  br i1 %exitcond.not.i612, label %B386.i602, label %B346.i613

B346.i613:                                        ; preds = %B324.i610
  %.423.i614 = add i64 %end.5.2.i611, 1
  %92 = shl i64 %end.5.2.i611, 3
  %scevgep1206 = getelementptr i8, ptr %scevgep1205, i64 %92
  %.451.i617 = load double, ptr %scevgep1206, align 8, !noalias !15
  %.455.i618 = fcmp contract ugt double %.451.i617, %.281.i591
  br i1 %.455.i618, label %B386.i602, label %B324.i610

B386.i602:                                        ; preds = %B346.i613, %B324.i610, %B92.if.i585, %B284.i606, %B146.i593
  %end.4.1.i603 = phi i64 [ %.13.i6.i600, %B146.i593 ], [ %end.3.0210.i586, %B92.if.i585 ], [ %.13.i6.i600, %B284.i606 ], [ %.3554, %B324.i610 ], [ %.423.i614, %B346.i613 ]
  %.13.i.i604 = tail call i64 @llvm.smin.i64(i64 %.3554, i64 %end.4.1.i603)
  %93 = getelementptr i64, ptr %.1052, i64 %.231203208.i587
  store i64 %.13.i.i604, ptr %93, align 8, !noalias !15
  %exitcond216.not.i605 = icmp eq i64 %.238.i588, %..143.i579
  br i1 %exitcond216.not.i605, label %_ZN17bnserve_surrogate6kernel7_places9find_endsB4v142B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5TupleI5ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedExdE5ArrayIdLi1E1C7mutable7alignedExdx5ArrayIxLi1E1C7mutable7alignedE.exit619, label %B92.if.i585

B92.if.i585:                                      ; preds = %B386.i602, %B92.if.preheader.i584
  %end.3.0210.i586 = phi i64 [ %end.4.1.i603, %B386.i602 ], [ 0, %B92.if.preheader.i584 ]
  %.231203208.i587 = phi i64 [ %.238.i588, %B386.i602 ], [ 0, %B92.if.preheader.i584 ]
  %.238.i588 = add nuw nsw i64 %.231203208.i587, 1
  %sunkaddr1242 = shl i64 %.231203208.i587, 3
  %sunkaddr1243 = getelementptr inbounds i8, ptr %.2726, i64 %sunkaddr1242
  %sunkaddr1244 = getelementptr inbounds nuw i8, ptr %sunkaddr1243, i64 8
  %.279.i590 = load double, ptr %sunkaddr1244, align 8, !noalias !15
  %.281.i591 = fsub contract double %.279.i590, %.3209.le
  %.287.i592 = fcmp contract ult double %.281.i591, %.135.i576
  br i1 %.287.i592, label %B386.i602, label %B146.i593

_ZN17bnserve_surrogate6kernel7_places9find_endsB4v142B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5TupleI5ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedExdE5ArrayIdLi1E1C7mutable7alignedExdx5ArrayIxLi1E1C7mutable7alignedE.exit619: ; preds = %B386.i602, %B2222
  %.586.inv.i581 = icmp sgt i64 %.533, 1
  %.587.i582 = select i1 %.586.inv.i581, i64 0, i64 %.614
  %94 = getelementptr i64, ptr %.1052, i64 %.143.i577
  %.601.i583 = getelementptr i64, ptr %94, i64 %.587.i582
  store i64 %.3554, ptr %.601.i583, align 8, !noalias !15
  br label %B2292

B94.i:                                            ; preds = %B34.if.i
  %.6.i.i629 = fmul contract double %.229.i626, 0x400921FB54442D18
  %.7.i.i630 = tail call contract double @llvm.fma.f64(double %.6.i.i629, double 0x3FE45F306DC9C883, double 0x4338000000000000)
  %.8.i.i631 = fadd contract double %.7.i.i630, 0xC338000000000000
  %.23.i.i = tail call contract double @llvm.fma.f64(double %.8.i.i631, double 0xBFF921FB54442D18, double %.6.i.i629)
  %.38.i.i = tail call contract double @llvm.fma.f64(double %.8.i.i631, double 0xBC91A62633145C07, double %.23.i.i)
  %.39.i.i = fmul contract double %.38.i.i, %.38.i.i
  %.56.i.i = bitcast double %.7.i.i630 to i64
  %.60.i.i = and i64 %.56.i.i, 1
  %95 = icmp eq i64 %.60.i.i, 0
  br i1 %95, label %select.true.sink.i.i, label %select.false.sink.i.i

select.true.sink.i.i:                             ; preds = %B94.i
  %.48.i.i = tail call contract double @llvm.fma.f64(double %.39.i.i, double 0x3D2AE7F3E733B81F, double 0xBDA93974A8C07C9D)
  %.49.i.i = tail call contract double @llvm.fma.f64(double %.39.i.i, double %.48.i.i, double 0x3E21EED8EFF8D898)
  %.50.i.i = tail call contract double @llvm.fma.f64(double %.39.i.i, double %.49.i.i, double 0xBE927E4FB7789F5C)
  %.51.i.i = tail call contract double @llvm.fma.f64(double %.39.i.i, double %.50.i.i, double 0x3EFA01A01A01A01A)
  %.52.i.i = tail call contract double @llvm.fma.f64(double %.39.i.i, double %.51.i.i, double 0xBF56C16C16C16C17)
  %.53.i.i = tail call contract double @llvm.fma.f64(double %.39.i.i, double %.52.i.i, double 0x3FA5555555555555)
  %.54.i.i = tail call contract double @llvm.fma.f64(double %.39.i.i, double %.53.i.i, double -5.000000e-01)
  %.55.i.i = tail call contract double @llvm.fma.f64(double %.39.i.i, double %.54.i.i, double 1.000000e+00)
  br label %_ZN17bnserve_surrogate6kernel7_points4stepB4v144B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEd.exit.i

select.false.sink.i.i:                            ; preds = %B94.i
  %.46.i.i = fmul contract double %.38.i.i, %.39.i.i
  %.40.i.i = tail call contract double @llvm.fma.f64(double %.39.i.i, double 0xBD6AE7F3E733B81F, double 0x3DE6124613A86D09)
  %.41.i.i = tail call contract double @llvm.fma.f64(double %.39.i.i, double %.40.i.i, double 0xBE5AE64567F544E4)
  %.42.i.i = tail call contract double @llvm.fma.f64(double %.39.i.i, double %.41.i.i, double 0x3EC71DE3A556C734)
  %.43.i.i = tail call contract double @llvm.fma.f64(double %.39.i.i, double %.42.i.i, double 0xBF2A01A01A01A01A)
  %.44.i.i = tail call contract double @llvm.fma.f64(double %.39.i.i, double %.43.i.i, double 0x3F81111111111111)
  %.45.i.i = tail call contract double @llvm.fma.f64(double %.39.i.i, double %.44.i.i, double 0xBFC5555555555555)
  %.47.i.i = tail call contract double @llvm.fma.f64(double %.46.i.i, double %.45.i.i, double %.38.i.i)
  br label %_ZN17bnserve_surrogate6kernel7_points4stepB4v144B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEd.exit.i

_ZN17bnserve_surrogate6kernel7_points4stepB4v144B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEd.exit.i: ; preds = %select.false.sink.i.i, %select.true.sink.i.i
  %.71.v.i.i = phi double [ %.55.i.i, %select.true.sink.i.i ], [ %.47.i.i, %select.false.sink.i.i ]
  %.65.i.i = shl i64 %.56.i.i, 62
  %.66.i.i = add i64 %.65.i.i, 4611686018427387904
  %.67.i.i = and i64 %.66.i.i, -9223372036854775808
  %.71.i.i = bitcast double %.71.v.i.i to i64
  %.72.i.i = xor i64 %.67.i.i, %.71.i.i
  %.73.i.i = bitcast i64 %.72.i.i to double
  %.89.i.i = tail call contract double @llvm.fma.f64(double %.73.i.i, double -5.000000e-01, double 5.000000e-01)
  %.266.i632 = fmul contract double %.5165, %.89.i.i
  br label %B144.i

B144.i:                                           ; preds = %B34.if.i, %_ZN17bnserve_surrogate6kernel7_points4stepB4v144B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEd.exit.i
  %"$phi144.1.2.1.i" = phi double [ %.266.i632, %_ZN17bnserve_surrogate6kernel7_points4stepB4v144B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEd.exit.i ], [ 0.000000e+00, %B34.if.i ]
  %sunkaddr100 = getelementptr i8, ptr %20, i64 %97
  %sunkaddr101 = getelementptr i8, ptr %sunkaddr100, i64 320
  store double %"$phi144.1.2.1.i", ptr %sunkaddr101, align 8, !noalias !33
  %.314.i = fsub contract double %.218.i, %.3280
  %96 = fmul contract double %.5298, %.314.i
  %.319.i = fsub contract double %.5197, %96
  %sunkaddr104 = getelementptr i8, ptr %sunkaddr100, i64 8576
  store double %.319.i, ptr %sunkaddr104, align 8, !noalias !33
  %exitcond.not.i628 = icmp eq i64 %.5268, %.158.i
  br i1 %exitcond.not.i628, label %B2676, label %B34.if.i

B34.if.i:                                         ; preds = %B2534, %B144.i
  %.151102104.i = phi i64 [ %.158.i, %B144.i ], [ 0, %B2534 ]
  %.158.i = add nuw nsw i64 %.151102104.i, 1
  %97 = shl i64 %.151102104.i, 3
  %scevgep2.i = getelementptr i8, ptr %.5215, i64 %97
  %.216.i624 = load double, ptr %scevgep2.i, align 8, !noalias !33
  %.218.i = fmul contract double %.3197, %.216.i624
  %.223.i = fmul contract double %.218.i, 2.000000e+00
  %.228.i625 = fdiv contract double %.223.i, %.3280
  %.228.fr.i = freeze double %.228.i625
  %.229.i626 = fadd contract double %.228.fr.i, -1.000000e+00
  %.234.i627 = fcmp contract ogt double %.229.i626, 0.000000e+00
  br i1 %.234.i627, label %B94.i, label %B144.i

B2848.endif:                                      ; preds = %B612.i, %B2848
  %cell.5.1.i311 = phi i64 [ %cell_a.2.0279, %B2848 ], [ %cell.3.2.i321, %B612.i ]
  br i1 %29, label %B22.preheader.i640, label %B2944

B22.preheader.i640:                               ; preds = %B2848.endif
  %98 = mul i64 %.4923.sroa.0.0284, -8
  %scevgep41 = getelementptr i8, ptr %scevgep24, i64 %98
  br label %B22.i644

B22.i644:                                         ; preds = %B612.i703, %B22.preheader.i640
  %cell.2.0.i645 = phi i64 [ %cell.3.2.i659, %B612.i703 ], [ %cell_p.3.0280, %B22.preheader.i640 ]
  %start.2.0.i646 = phi i64 [ %.13.i.i662, %B612.i703 ], [ %.13.i623, %B22.preheader.i640 ]
  %.121.i647 = getelementptr inbounds i64, ptr %.1115, i64 %cell.2.0.i645
  %.122.i648 = load i64, ptr %.121.i647, align 8, !noalias !36
  %.126.not.i649 = icmp sgt i64 %.122.i648, %start.2.0.i646
  br i1 %.126.not.i649, label %B112.i658, label %B62.i650

B62.i650:                                         ; preds = %B22.i644, %B62.i650
  %cell.4.1.i651 = phi i64 [ %.129.i652, %B62.i650 ], [ %cell.2.0.i645, %B22.i644 ]
  %.129.i652 = add i64 %cell.4.1.i651, 1
  %sunkaddr.i653 = shl i64 %cell.4.1.i651, 3
  %scevgep34 = getelementptr i8, ptr %scevgep19, i64 %sunkaddr.i653
  %.142.i656 = load i64, ptr %scevgep34, align 8, !noalias !36
  %.144.not.i657 = icmp sgt i64 %.142.i656, %start.2.0.i646
  br i1 %.144.not.i657, label %B112.i658, label %B62.i650

B112.i658:                                        ; preds = %B62.i650, %B22.i644
  %cell.3.2.i659 = phi i64 [ %cell.2.0.i645, %B22.i644 ], [ %.129.i652, %B62.i650 ]
  %.156.i660 = getelementptr inbounds i64, ptr %.1115, i64 %cell.3.2.i659
  %.157.i661 = load i64, ptr %.156.i660, align 8, !noalias !36
  %.13.i.i662 = tail call i64 @llvm.smin.i64(i64 %.13.i621, i64 %.157.i661)
  %.307.i663 = sub i64 %.13.i.i662, %start.2.0.i646
  %99 = add i64 %.307.i663, 7
  %.329.i664 = lshr i64 %99, 3
  %.308.inv.i665 = icmp slt i64 %.307.i663, 1
  %.350229.not250.i666 = icmp eq i64 %.329.i664, 0
  %.350229.not.i667 = or i1 %.308.inv.i665, %.350229.not250.i666
  br i1 %.350229.not.i667, label %B612.i703, label %B412.if.lr.ph.i668

B612.i703:                                        ; preds = %B412.if.i690, %B112.i658
  %.479.i704 = icmp slt i64 %.157.i661, %.13.i621
  br i1 %.479.i704, label %B22.i644, label %B2944

B412.if.lr.ph.i668:                               ; preds = %B112.i658
  %.200.i669 = getelementptr inbounds double, ptr %.2824, i64 %cell.3.2.i659
  %.201.i670 = load double, ptr %.200.i669, align 8, !noalias !36
  %.203.i671 = fsub contract double %.3209.le, %.201.i670
  %.259.i672 = getelementptr double, ptr %15, i64 %cell.3.2.i659
  %.260.i673 = load double, ptr %.259.i672, align 8, !noalias !36
  %.246.i674 = getelementptr double, ptr %14, i64 %cell.3.2.i659
  %.247.i675 = load double, ptr %.246.i674, align 8, !noalias !36
  %.227.i676 = getelementptr double, ptr %13, i64 %cell.3.2.i659
  %.228.i677 = load double, ptr %.227.i676, align 8, !noalias !36
  %.215.i678 = getelementptr inbounds double, ptr %.975, i64 %cell.3.2.i659
  %.216.i679 = load double, ptr %.215.i678, align 8, !noalias !36
  %.426.i680 = insertelement <8 x double> poison, double %.260.i673, i64 0
  %.427.i681 = shufflevector <8 x double> %.426.i680, <8 x double> poison, <8 x i32> zeroinitializer
  %.429.i682 = insertelement <8 x double> poison, double %.247.i675, i64 0
  %.430.i683 = shufflevector <8 x double> %.429.i682, <8 x double> poison, <8 x i32> zeroinitializer
  %.433.i684 = insertelement <8 x double> poison, double %.228.i677, i64 0
  %.434.i685 = shufflevector <8 x double> %.433.i684, <8 x double> poison, <8 x i32> zeroinitializer
  %.437.i686 = insertelement <8 x double> poison, double %.216.i679, i64 0
  %.438.i687 = shufflevector <8 x double> %.437.i686, <8 x double> poison, <8 x i32> zeroinitializer
  %.6.i.i688 = insertelement <8 x double> poison, double %.203.i671, i64 0
  %.7.i.i689 = shufflevector <8 x double> %.6.i.i688, <8 x double> poison, <8 x i32> zeroinitializer
  %100 = shl i64 %start.2.0.i646, 3
  %101 = add nuw nsw i64 %.329.i664, 5
  br label %B412.if.i690

B412.if.i690:                                     ; preds = %B412.if.i690, %B412.if.lr.ph.i668
  %lsr.iv35 = phi i64 [ %lsr.iv.next36, %B412.if.i690 ], [ %101, %B412.if.lr.ph.i668 ]
  %lsr.iv8.i691 = phi i64 [ %lsr.iv.next9.i701, %B412.if.i690 ], [ %100, %B412.if.lr.ph.i668 ]
  %scevgep11.i693 = getelementptr i8, ptr %.298, i64 %lsr.iv8.i691
  %.397.i694 = load <8 x double>, ptr %scevgep11.i693, align 8, !noalias !36
  %.8.i.i695 = fadd contract <8 x double> %.7.i.i689, %.397.i694
  %.431.i696 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i.i695, <8 x double> %.427.i681, <8 x double> %.430.i683)
  %.435.i697 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i.i695, <8 x double> %.431.i696, <8 x double> %.434.i685)
  %.439.i698 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i.i695, <8 x double> %.435.i697, <8 x double> %.438.i687)
  %scevgep47 = getelementptr i8, ptr %scevgep41, i64 %lsr.iv8.i691
  store <8 x double> %.439.i698, ptr %scevgep47, align 8, !noalias !36
  %lsr.iv.next9.i701 = add i64 %lsr.iv8.i691, 64
  %lsr.iv.next36 = add nsw i64 %lsr.iv35, -1
  %.350.i702 = icmp sgt i64 %lsr.iv35, 6
  br i1 %.350.i702, label %B412.if.i690, label %B612.i703

B484.if.lr.ph.i:                                  ; preds = %B2958
  %.1013.i = load double, ptr %sunkaddr105, align 8, !noalias !39
  %.984.i = load double, ptr %sunkaddr106, align 8, !noalias !39
  %.955.i = load double, ptr %sunkaddr107, align 8, !noalias !39
  %.926.i = load double, ptr %sunkaddr108, align 8, !noalias !39
  %.897.i = load double, ptr %sunkaddr109, align 8, !noalias !39
  %.868.i = load double, ptr %sunkaddr110, align 8, !noalias !39
  %.839.i = load double, ptr %sunkaddr111, align 8, !noalias !39
  %.810.i = load double, ptr %sunkaddr112, align 8, !noalias !39
  %.781.i = load double, ptr %sunkaddr113, align 8, !noalias !39
  %.752.i = load double, ptr %sunkaddr114, align 8, !noalias !39
  %.648.i = load double, ptr %sunkaddr115, align 8, !noalias !39
  %.619.i = load double, ptr %sunkaddr116, align 8, !noalias !39
  %.590.i = load double, ptr %sunkaddr117, align 8, !noalias !39
  %.561.i = load double, ptr %sunkaddr118, align 8, !noalias !39
  %.532.i = load double, ptr %sunkaddr119, align 8, !noalias !39
  %.503.i = load double, ptr %sunkaddr120, align 8, !noalias !39
  %.474.i = load double, ptr %sunkaddr121, align 8, !noalias !39
  %.445.i = load double, ptr %sunkaddr122, align 8, !noalias !39
  %.344.i = load double, ptr %sunkaddr123, align 8, !noalias !39
  %.315.i745 = load double, ptr %sunkaddr124, align 8, !noalias !39
  %.286.i = load double, ptr %sunkaddr125, align 8, !noalias !39
  %.257.i = load double, ptr %sunkaddr126, align 8, !noalias !39
  %.228.i748 = load double, ptr %sunkaddr127, align 8, !noalias !39
  %.199.i = load double, ptr %sunkaddr128, align 8, !noalias !39
  %.170.i749 = load double, ptr %sunkaddr129, align 8, !noalias !39
  %.141.i = load double, ptr %sunkaddr130, align 8, !noalias !39
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
  %.1312.i = insertelement <8 x double> poison, double %.315.i745, i64 0
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
  %.1334.i = insertelement <8 x double> poison, double %.228.i748, i64 0
  %.1335.i = shufflevector <8 x double> %.1334.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1338.i = insertelement <8 x double> poison, double %.170.i749, i64 0
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
  %102 = add nuw nsw i64 %.1167.i, 5
  br label %B484.if.i

B484.if.i:                                        ; preds = %B484.if.i, %B484.if.lr.ph.i
  %lsr.iv = phi i64 [ %lsr.iv.next, %B484.if.i ], [ %102, %B484.if.lr.ph.i ]
  %lsr.iv1189 = phi ptr [ %scevgep1190, %B484.if.i ], [ %.5862, %B484.if.lr.ph.i ]
  %lsr.iv1186 = phi ptr [ %scevgep1187, %B484.if.i ], [ %scevgep1185, %B484.if.lr.ph.i ]
  %scevgep1193 = getelementptr i8, ptr %lsr.iv1189, i64 %.idx
  %.1236.i = load <8 x double>, ptr %scevgep1193, align 8, !noalias !39
  %.1246.i = load <8 x double>, ptr %lsr.iv1189, align 8, !noalias !39
  %sunkaddr132 = getelementptr i8, ptr %lsr.iv1189, i64 %sunkaddr131
  %.1256.i = load <8 x double>, ptr %sunkaddr132, align 8, !noalias !39
  %.6.i.i751 = fmul contract <8 x double> %.1236.i, %.1236.i
  %.1287.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i751, <8 x double> %.1283.i, <8 x double> %.1286.i)
  %.1291.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i751, <8 x double> %.1287.i, <8 x double> %.1290.i)
  %.1295.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i751, <8 x double> %.1291.i, <8 x double> %.1294.i)
  %.1302.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i751, <8 x double> %.1298.i, <8 x double> %.1301.i)
  %.1306.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i751, <8 x double> %.1302.i, <8 x double> %.1305.i)
  %.1310.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i751, <8 x double> %.1306.i, <8 x double> %.1309.i)
  %.1317.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i751, <8 x double> %.1313.i, <8 x double> %.1316.i)
  %.1321.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i751, <8 x double> %.1317.i, <8 x double> %.1320.i)
  %.1325.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i751, <8 x double> %.1321.i, <8 x double> %.1324.i)
  %.1332.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i751, <8 x double> %.1328.i, <8 x double> %.1331.i)
  %.1336.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i751, <8 x double> %.1332.i, <8 x double> %.1335.i)
  %.1340.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i751, <8 x double> %.1336.i, <8 x double> %.1339.i)
  %.1347.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i751, <8 x double> %.1343.i, <8 x double> %.1346.i)
  %.1351.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i751, <8 x double> %.1347.i, <8 x double> %.1350.i)
  %.1355.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i751, <8 x double> %.1351.i, <8 x double> %.1354.i)
  %.1362.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i751, <8 x double> %.1358.i, <8 x double> %.1361.i)
  %.1366.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i751, <8 x double> %.1362.i, <8 x double> %.1365.i)
  %.1367.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1236.i, <8 x double> %.1340.i, <8 x double> %.1325.i)
  %scevgep1191 = getelementptr i8, ptr %lsr.iv1189, i64 %.idx3015
  %.1377.i = load <8 x double>, ptr %scevgep1191, align 8, !noalias !39
  %.6.i16.i = fmul contract <8 x double> %.1377.i, %.1367.i
  %.6.i17.i = fmul contract <8 x double> %.1246.i, %.1256.i
  %.1426.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1236.i, <8 x double> %.1366.i, <8 x double> %.1355.i)
  %.1430.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i17.i, <8 x double> %.1429.i, <8 x double> %.1426.i)
  %.1431.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1236.i, <8 x double> %.1310.i, <8 x double> %.1295.i)
  %scevgep1188 = getelementptr i8, ptr %lsr.iv1186, i64 -16512
  %.1441.i = load <8 x double>, ptr %scevgep1188, align 8, !noalias !39
  %.1442.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1246.i, <8 x double> %.1431.i, <8 x double> %.1441.i)
  %.1443.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1256.i, <8 x double> %.1430.i, <8 x double> %.1442.i)
  %.6.i18.i = fadd contract <8 x double> %.6.i16.i, %.1443.i
  %.1450.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1246.i, <8 x double> %.1447.i, <8 x double> %.1449.i)
  %.6.i19.i = fsub contract <8 x double> %.1450.i, %.6.i18.i
  store <8 x double> %.6.i19.i, ptr %lsr.iv1186, align 8, !noalias !39
  %scevgep1187 = getelementptr i8, ptr %lsr.iv1186, i64 64
  %scevgep1190 = getelementptr i8, ptr %lsr.iv1189, i64 64
  %lsr.iv.next = add nsw i64 %lsr.iv, -1
  %.1189.i = icmp sgt i64 %lsr.iv, 6
  br i1 %.1189.i, label %B484.if.i, label %B3524

B22.preheader.i770:                               ; preds = %B3524
  %103 = mul i64 %.4923.sroa.0.0284, -8
  %scevgep51 = getelementptr i8, ptr %scevgep1185, i64 %103
  br label %B22.i771

B22.i771:                                         ; preds = %B1344.i, %B22.preheader.i770
  %cell.2.0.i772 = phi i64 [ %cell.3.2.i780, %B1344.i ], [ %cell.2.0281, %B22.preheader.i770 ]
  %start.2.0.i773 = phi i64 [ %.13.i.i781, %B1344.i ], [ %.13.i623, %B22.preheader.i770 ]
  %.160.i = getelementptr inbounds i64, ptr %.1178, i64 %cell.2.0.i772
  %.161.i = load i64, ptr %.160.i, align 8, !noalias !42
  %.165.not.i = icmp sgt i64 %.161.i, %start.2.0.i773
  br i1 %.165.not.i, label %B112.i779, label %B62.i774

B62.i774:                                         ; preds = %B22.i771, %B62.i774
  %cell.4.1.i775 = phi i64 [ %.168.i, %B62.i774 ], [ %cell.2.0.i772, %B22.i771 ]
  %.168.i = add i64 %cell.4.1.i775, 1
  %sunkaddr133 = shl i64 %.168.i, 3
  %sunkaddr134 = getelementptr i8, ptr %20, i64 %sunkaddr133
  %sunkaddr135 = getelementptr i8, ptr %sunkaddr134, i64 33472
  %.181.i778 = load i64, ptr %sunkaddr135, align 8, !noalias !42
  %.183.not.i = icmp sgt i64 %.181.i778, %start.2.0.i773
  br i1 %.183.not.i, label %B112.i779, label %B62.i774

B112.i779:                                        ; preds = %B62.i774, %B22.i771
  %cell.3.2.i780 = phi i64 [ %cell.2.0.i772, %B22.i771 ], [ %.168.i, %B62.i774 ]
  %.195.i = getelementptr inbounds i64, ptr %.1178, i64 %cell.3.2.i780
  %.196.i = load i64, ptr %.195.i, align 8, !noalias !42
  %.13.i.i781 = tail call i64 @llvm.smin.i64(i64 %.13.i621, i64 %.196.i)
  %.529.i = sub i64 %.13.i.i781, %start.2.0.i773
  %104 = add i64 %.529.i, 7
  %.551.i = lshr i64 %104, 3
  %.530.inv.i = icmp slt i64 %.529.i, 1
  %.573363.not375.i = icmp eq i64 %.551.i, 0
  %.573363.not.i = or i1 %.530.inv.i, %.573363.not375.i
  br i1 %.573363.not.i, label %B1344.i, label %B808.if.lr.ph.i

B1344.i:                                          ; preds = %B808.if.i, %B112.i779
  %.751.i = icmp slt i64 %.196.i, %.13.i621
  br i1 %.751.i, label %B22.i771, label %B3750

B808.if.lr.ph.i:                                  ; preds = %B112.i779
  %.261.i = shl nsw i64 %cell.3.2.i780, 3
  %105 = getelementptr double, ptr %.1672, i64 %.261.i
  %.478.i = getelementptr i8, ptr %105, i64 48
  %.479.i782 = load double, ptr %.478.i, align 8, !noalias !42
  %.311.i = or disjoint i64 %.261.i, 5
  %.468.i = getelementptr inbounds double, ptr %.1672, i64 %.311.i
  %.469.i = load double, ptr %.468.i, align 8, !noalias !42
  %.301.i = or disjoint i64 %.261.i, 4
  %.458.i = getelementptr inbounds double, ptr %.1672, i64 %.301.i
  %.459.i = load double, ptr %.458.i, align 8, !noalias !42
  %.291.i783 = or disjoint i64 %.261.i, 3
  %.412.i784 = getelementptr inbounds double, ptr %.1672, i64 %.291.i783
  %.413.i785 = load double, ptr %.412.i784, align 8, !noalias !42
  %.281.i786 = or disjoint i64 %.261.i, 2
  %.402.i = getelementptr inbounds double, ptr %.1672, i64 %.281.i786
  %.403.i = load double, ptr %.402.i, align 8, !noalias !42
  %.271.i = or disjoint i64 %.261.i, 1
  %.392.i = getelementptr inbounds double, ptr %.1672, i64 %.271.i
  %.393.i = load double, ptr %.392.i, align 8, !noalias !42
  %.383.i = load double, ptr %105, align 8, !noalias !42
  %.319.i787 = getelementptr inbounds double, ptr %.1608, i64 %.311.i
  %.320.i = load double, ptr %.319.i787, align 8, !noalias !42
  %.309.i = getelementptr inbounds double, ptr %.1608, i64 %.301.i
  %.310.i = load double, ptr %.309.i, align 8, !noalias !42
  %.299.i = getelementptr inbounds double, ptr %.1608, i64 %.291.i783
  %.300.i = load double, ptr %.299.i, align 8, !noalias !42
  %.289.i = getelementptr inbounds double, ptr %.1608, i64 %.281.i786
  %.290.i = load double, ptr %.289.i, align 8, !noalias !42
  %.279.i788 = getelementptr inbounds double, ptr %.1608, i64 %.271.i
  %.280.i = load double, ptr %.279.i788, align 8, !noalias !42
  %.269.i = getelementptr inbounds double, ptr %.1608, i64 %.261.i
  %.270.i = load double, ptr %.269.i, align 8, !noalias !42
  %.251.i = getelementptr inbounds double, ptr %.6657, i64 %cell.3.2.i780
  %.252.i = load double, ptr %.251.i, align 8, !noalias !42
  %.253.i = fsub contract double 0.000000e+00, %.252.i
  %.239.i = getelementptr inbounds double, ptr %.6592, i64 %cell.3.2.i780
  %.240.i = load double, ptr %.239.i, align 8, !noalias !42
  %.242.i = fmul contract double %.3197, %.240.i
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
  %.647.i789 = shufflevector <8 x double> %.646.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.650.i = insertelement <8 x double> poison, double %.270.i, i64 0
  %.651.i = shufflevector <8 x double> %.650.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.664.i = insertelement <8 x double> poison, double %.479.i782, i64 0
  %.665.i = shufflevector <8 x double> %.664.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.667.i = insertelement <8 x double> poison, double %.469.i, i64 0
  %.668.i = shufflevector <8 x double> %.667.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.671.i = insertelement <8 x double> poison, double %.459.i, i64 0
  %.672.i = shufflevector <8 x double> %.671.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.675.i = insertelement <8 x double> poison, double %.413.i785, i64 0
  %.676.i = shufflevector <8 x double> %.675.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.681.i = insertelement <8 x double> poison, double %.403.i, i64 0
  %.682.i = shufflevector <8 x double> %.681.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.685.i = insertelement <8 x double> poison, double %.393.i, i64 0
  %.686.i = shufflevector <8 x double> %.685.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.689.i = insertelement <8 x double> poison, double %.383.i, i64 0
  %.690.i = shufflevector <8 x double> %.689.i, <8 x double> poison, <8 x i32> zeroinitializer
  %106 = shl i64 %start.2.0.i773, 3
  %107 = add nuw nsw i64 %.551.i, 5
  br label %B808.if.i

B808.if.i:                                        ; preds = %B808.if.i, %B808.if.lr.ph.i
  %lsr.iv48 = phi i64 [ %lsr.iv.next49, %B808.if.i ], [ %107, %B808.if.lr.ph.i ]
  %lsr.iv5.i = phi i64 [ %lsr.iv.next6.i, %B808.if.i ], [ %106, %B808.if.lr.ph.i ]
  %scevgep10.i791 = getelementptr i8, ptr %.229, i64 %lsr.iv5.i
  %.620.i = load <8 x double>, ptr %scevgep10.i791, align 8, !noalias !42
  %.627.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.620.i, <8 x double> %.624.i, <8 x double> %.626.i)
  %.636.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.627.i, <8 x double> %.632.i, <8 x double> %.635.i)
  %.640.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.627.i, <8 x double> %.636.i, <8 x double> %.639.i)
  %.644.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.627.i, <8 x double> %.640.i, <8 x double> %.643.i)
  %.648.i792 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.627.i, <8 x double> %.644.i, <8 x double> %.647.i789)
  %.652.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.627.i, <8 x double> %.648.i792, <8 x double> %.651.i)
  %scevgep52 = getelementptr i8, ptr %scevgep51, i64 %lsr.iv5.i
  %scevgep53 = getelementptr i8, ptr %scevgep52, i64 -8256
  store <8 x double> %.652.i, ptr %scevgep53, align 8, !noalias !42
  %.669.i793 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.627.i, <8 x double> %.665.i, <8 x double> %.668.i)
  %.673.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.627.i, <8 x double> %.669.i793, <8 x double> %.672.i)
  %.677.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.627.i, <8 x double> %.673.i, <8 x double> %.676.i)
  %.683.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.627.i, <8 x double> %.677.i, <8 x double> %.682.i)
  %.687.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.627.i, <8 x double> %.683.i, <8 x double> %.686.i)
  %.691.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.627.i, <8 x double> %.687.i, <8 x double> %.690.i)
  store <8 x double> %.691.i, ptr %scevgep52, align 8, !noalias !42
  %lsr.iv.next6.i = add i64 %lsr.iv5.i, 64
  %lsr.iv.next49 = add nsw i64 %lsr.iv48, -1
  %.573.i = icmp sgt i64 %lsr.iv48, 6
  br i1 %.573.i, label %B808.if.i, label %B1344.i
}

; Function Attrs: nofree noinline norecurse nosync nounwind memory(write, argmem: readwrite, inaccessiblemem: none, target_mem0: none, target_mem1: none)
define internal fastcc void @inner_5(ptr noalias nonnull writeonly captures(none) %retptr, i64 %arg.i, ptr readonly captures(none) %arg.arguments.4) unnamed_addr #6 {
entry:
  %.49 = getelementptr i8, ptr %arg.arguments.4, i64 16
  %.50 = load i64, ptr %.49, align 8
  %.79 = getelementptr i8, ptr %arg.arguments.4, i64 112
  %.80 = load i64, ptr %.79, align 8
  %.115 = getelementptr i8, ptr %arg.arguments.4, i64 160
  %.116 = load i64, ptr %.115, align 8
  %.117.not = icmp eq i64 %.116, 0
  br i1 %.117.not, label %B216, label %B120

B120:                                             ; preds = %entry
  %.152 = inttoptr i64 %.116 to ptr
  %0 = tail call i64 @llvm.smin.i64(i64 %arg.i, i64 -1)
  %1 = getelementptr double, ptr %.152, i64 %arg.i
  %2 = getelementptr double, ptr %1, i64 %0
  %.230 = getelementptr i8, ptr %2, i64 8
  store double 0x7FF8000000000000, ptr %.230, align 8
  br label %B216

B216:                                             ; preds = %B120, %entry
  %.237 = icmp ne i64 %.80, 4
  %.247 = zext i1 %.237 to i64
  %"$phi260.0.2.0" = shl nsw i64 %.50, %.247
  %.287 = getelementptr i8, ptr %arg.arguments.4, i64 120
  %.288 = load i64, ptr %.287, align 8
  %.317 = getelementptr i8, ptr %arg.arguments.4, i64 128
  %.318 = load i64, ptr %.317, align 8
  %factor.op.mul389 = mul i64 %"$phi260.0.2.0", %arg.i
  %.459.reass = shl i64 %factor.op.mul389, 2
  %.821.reass = shl i64 %factor.op.mul389, 3
  %3 = and i64 %.80, -3
  %.412.not = icmp eq i64 %.288, 0
  br i1 %.412.not, label %B566, label %B350

B350:                                             ; preds = %B216
  %4 = icmp eq i64 %3, 1
  %5 = icmp slt i64 %.50, 1
  br i1 %4, label %B402, label %B484

B402:                                             ; preds = %B350
  %.463 = add nsw i64 %.288, %.459.reass
  br i1 %5, label %B566, label %.768.endif.preheader, !prof !5

.768.endif.preheader:                             ; preds = %B402
  %xtraiter49 = and i64 %"$phi260.0.2.0", 7
  %6 = icmp ult i64 %"$phi260.0.2.0", 8
  br i1 %6, label %.768.endif.epil.preheader, label %.768.endif.preheader.new, !prof !45

.768.endif.preheader.new:                         ; preds = %.768.endif.preheader
  %7 = add nsw i64 %"$phi260.0.2.0", -8
  %8 = lshr i64 %7, 3
  %9 = icmp eq i64 %8, 0
  br i1 %9, label %.768.endif.epil.preheader21, label %.768.endif.preheader.new.new, !prof !46

.768.endif.preheader.new.new:                     ; preds = %.768.endif.preheader.new
  %10 = add nuw nsw i64 %8, 1
  %11 = inttoptr i64 %.463 to ptr
  %scevgep165 = getelementptr i8, ptr %11, i64 60
  %12 = and i64 %10, 4611686018427387902
  br label %.768.endif

B484:                                             ; preds = %B350
  %.825 = add nsw i64 %.288, %.821.reass
  br i1 %5, label %B566, label %.1129.endif.preheader, !prof !5

.1129.endif.preheader:                            ; preds = %B484
  %xtraiter = and i64 %"$phi260.0.2.0", 7
  %13 = icmp ult i64 %"$phi260.0.2.0", 8
  br i1 %13, label %.1129.endif.epil.preheader, label %.1129.endif.preheader.new, !prof !45

.1129.endif.preheader.new:                        ; preds = %.1129.endif.preheader
  %14 = add nsw i64 %"$phi260.0.2.0", -8
  %15 = lshr i64 %14, 3
  %16 = icmp eq i64 %15, 0
  br i1 %16, label %.1129.endif.epil.preheader11, label %.1129.endif.preheader.new.new, !prof !46

.1129.endif.preheader.new.new:                    ; preds = %.1129.endif.preheader.new
  %17 = add nuw nsw i64 %15, 1
  %18 = inttoptr i64 %.825 to ptr
  %scevgep199 = getelementptr i8, ptr %18, i64 120
  %19 = and i64 %17, 4611686018427387902
  br label %.1129.endif

B566.sink.split.loopexit.unr-lcssa.unr-lcssa:     ; preds = %.768.endif
  %20 = and i64 %7, 8
  %lcmp.mod26.not.not = icmp eq i64 %20, 0
  br i1 %lcmp.mod26.not.not, label %.768.endif.epil.preheader21, label %B566.sink.split.loopexit.unr-lcssa, !prof !47

.768.endif.epil.preheader21:                      ; preds = %B566.sink.split.loopexit.unr-lcssa.unr-lcssa, %.768.endif.preheader.new
  %.764.0386.epil.init25 = phi i64 [ 0, %.768.endif.preheader.new ], [ %.809.7.1, %B566.sink.split.loopexit.unr-lcssa.unr-lcssa ]
  %sunkaddr = inttoptr i64 %.463 to ptr
  %sunkaddr232 = shl i64 %.764.0386.epil.init25, 2
  %sunkaddr233 = getelementptr i8, ptr %sunkaddr, i64 %sunkaddr232
  store float 0x7FF8000000000000, ptr %sunkaddr233, align 4
  %sunkaddr237 = getelementptr i8, ptr %sunkaddr233, i64 4
  store float 0x7FF8000000000000, ptr %sunkaddr237, align 4
  %sunkaddr241 = getelementptr i8, ptr %sunkaddr233, i64 8
  store float 0x7FF8000000000000, ptr %sunkaddr241, align 4
  %sunkaddr245 = getelementptr i8, ptr %sunkaddr233, i64 12
  store float 0x7FF8000000000000, ptr %sunkaddr245, align 4
  %sunkaddr249 = getelementptr i8, ptr %sunkaddr233, i64 16
  store float 0x7FF8000000000000, ptr %sunkaddr249, align 4
  %sunkaddr253 = getelementptr i8, ptr %sunkaddr233, i64 20
  store float 0x7FF8000000000000, ptr %sunkaddr253, align 4
  %sunkaddr257 = getelementptr i8, ptr %sunkaddr233, i64 24
  store float 0x7FF8000000000000, ptr %sunkaddr257, align 4
  %sunkaddr261 = getelementptr i8, ptr %sunkaddr233, i64 28
  store float 0x7FF8000000000000, ptr %sunkaddr261, align 4
  %.809.7.epil = add nuw i64 %.764.0386.epil.init25, 8
  br label %B566.sink.split.loopexit.unr-lcssa

B566.sink.split.loopexit.unr-lcssa:               ; preds = %.768.endif.epil.preheader21, %B566.sink.split.loopexit.unr-lcssa.unr-lcssa
  %.809.7.lcssa = phi i64 [ %.809.7.epil, %.768.endif.epil.preheader21 ], [ %.809.7.1, %B566.sink.split.loopexit.unr-lcssa.unr-lcssa ]
  %lcmp.mod51.not = icmp eq i64 %xtraiter49, 0
  br i1 %lcmp.mod51.not, label %B566, label %.768.endif.epil.preheader, !prof !48

.768.endif.epil.preheader:                        ; preds = %B566.sink.split.loopexit.unr-lcssa, %.768.endif.preheader
  %.764.0386.epil.init = phi i64 [ 0, %.768.endif.preheader ], [ %.809.7.lcssa, %B566.sink.split.loopexit.unr-lcssa ]
  %21 = inttoptr i64 %.463 to ptr
  %22 = shl i64 %.764.0386.epil.init, 2
  %scevgep109 = getelementptr i8, ptr %21, i64 %22
  br label %.768.endif.epil

.768.endif.epil:                                  ; preds = %.768.endif.epil, %.768.endif.epil.preheader
  %epil.iter50 = phi i64 [ %epil.iter50.next, %.768.endif.epil ], [ 0, %.768.endif.epil.preheader ]
  %23 = shl i64 %epil.iter50, 2
  %scevgep164 = getelementptr i8, ptr %scevgep109, i64 %23
  store float 0x7FF8000000000000, ptr %scevgep164, align 4
  %epil.iter50.next = add i64 %epil.iter50, 1
  %epil.iter50.cmp.not = icmp eq i64 %xtraiter49, %epil.iter50.next
  br i1 %epil.iter50.cmp.not, label %B566, label %.768.endif.epil, !prof !49, !llvm.loop !50

B566.sink.split.loopexit42.unr-lcssa.unr-lcssa:   ; preds = %.1129.endif
  %24 = and i64 %14, 8
  %lcmp.mod.not53.not = icmp eq i64 %24, 0
  br i1 %lcmp.mod.not53.not, label %.1129.endif.epil.preheader11, label %B566.sink.split.loopexit42.unr-lcssa, !prof !47

.1129.endif.epil.preheader11:                     ; preds = %B566.sink.split.loopexit42.unr-lcssa.unr-lcssa, %.1129.endif.preheader.new
  %.1125.0388.epil.init15 = phi i64 [ 0, %.1129.endif.preheader.new ], [ %.1170.7.1, %B566.sink.split.loopexit42.unr-lcssa.unr-lcssa ]
  %sunkaddr262 = inttoptr i64 %.825 to ptr
  %sunkaddr263 = shl i64 %.1125.0388.epil.init15, 3
  %sunkaddr264 = getelementptr i8, ptr %sunkaddr262, i64 %sunkaddr263
  store double 0x7FF8000000000000, ptr %sunkaddr264, align 8
  %sunkaddr268 = getelementptr i8, ptr %sunkaddr264, i64 8
  store double 0x7FF8000000000000, ptr %sunkaddr268, align 8
  %sunkaddr272 = getelementptr i8, ptr %sunkaddr264, i64 16
  store double 0x7FF8000000000000, ptr %sunkaddr272, align 8
  %sunkaddr276 = getelementptr i8, ptr %sunkaddr264, i64 24
  store double 0x7FF8000000000000, ptr %sunkaddr276, align 8
  %sunkaddr280 = getelementptr i8, ptr %sunkaddr264, i64 32
  store double 0x7FF8000000000000, ptr %sunkaddr280, align 8
  %sunkaddr284 = getelementptr i8, ptr %sunkaddr264, i64 40
  store double 0x7FF8000000000000, ptr %sunkaddr284, align 8
  %sunkaddr288 = getelementptr i8, ptr %sunkaddr264, i64 48
  store double 0x7FF8000000000000, ptr %sunkaddr288, align 8
  %sunkaddr292 = getelementptr i8, ptr %sunkaddr264, i64 56
  store double 0x7FF8000000000000, ptr %sunkaddr292, align 8
  %.1170.7.epil = add nuw i64 %.1125.0388.epil.init15, 8
  br label %B566.sink.split.loopexit42.unr-lcssa

B566.sink.split.loopexit42.unr-lcssa:             ; preds = %.1129.endif.epil.preheader11, %B566.sink.split.loopexit42.unr-lcssa.unr-lcssa
  %.1170.7.lcssa = phi i64 [ %.1170.7.epil, %.1129.endif.epil.preheader11 ], [ %.1170.7.1, %B566.sink.split.loopexit42.unr-lcssa.unr-lcssa ]
  %lcmp.mod.not = icmp eq i64 %xtraiter, 0
  br i1 %lcmp.mod.not, label %B566, label %.1129.endif.epil.preheader, !prof !48

.1129.endif.epil.preheader:                       ; preds = %B566.sink.split.loopexit42.unr-lcssa, %.1129.endif.preheader
  %.1125.0388.epil.init = phi i64 [ 0, %.1129.endif.preheader ], [ %.1170.7.lcssa, %B566.sink.split.loopexit42.unr-lcssa ]
  %25 = inttoptr i64 %.825 to ptr
  %26 = shl i64 %.1125.0388.epil.init, 3
  %scevgep127 = getelementptr i8, ptr %25, i64 %26
  br label %.1129.endif.epil

.1129.endif.epil:                                 ; preds = %.1129.endif.epil, %.1129.endif.epil.preheader
  %epil.iter = phi i64 [ %epil.iter.next, %.1129.endif.epil ], [ 0, %.1129.endif.epil.preheader ]
  %27 = shl i64 %epil.iter, 3
  %scevgep198 = getelementptr i8, ptr %scevgep127, i64 %27
  store double 0x7FF8000000000000, ptr %scevgep198, align 8
  %epil.iter.next = add i64 %epil.iter, 1
  %epil.iter.cmp.not = icmp eq i64 %xtraiter, %epil.iter.next
  br i1 %epil.iter.cmp.not, label %B566, label %.1129.endif.epil, !prof !49, !llvm.loop !53

B566:                                             ; preds = %.1129.endif.epil, %.768.endif.epil, %B566.sink.split.loopexit42.unr-lcssa, %B566.sink.split.loopexit.unr-lcssa, %B484, %B402, %B216
  %.412.not.1 = icmp eq i64 %.318, 0
  br i1 %.412.not.1, label %B566.1, label %B350.1

B350.1:                                           ; preds = %B566
  %28 = icmp eq i64 %3, 1
  %29 = icmp slt i64 %.50, 1
  br i1 %28, label %B402.1, label %B484.1

B484.1:                                           ; preds = %B350.1
  %.825.1 = add nsw i64 %.318, %.821.reass
  br i1 %29, label %B566.1, label %.1129.endif.1.preheader, !prof !5

.1129.endif.1.preheader:                          ; preds = %B484.1
  %xtraiter60 = and i64 %"$phi260.0.2.0", 7
  %30 = icmp ult i64 %"$phi260.0.2.0", 8
  br i1 %30, label %.1129.endif.1.epil.preheader, label %.1129.endif.1.preheader.new, !prof !45

.1129.endif.1.preheader.new:                      ; preds = %.1129.endif.1.preheader
  %31 = add nsw i64 %"$phi260.0.2.0", -8
  %32 = lshr i64 %31, 3
  %33 = icmp eq i64 %32, 0
  br i1 %33, label %.1129.endif.1.epil.preheader33, label %.1129.endif.1.preheader.new.new, !prof !46

.1129.endif.1.preheader.new.new:                  ; preds = %.1129.endif.1.preheader.new
  %34 = add nuw nsw i64 %32, 1
  %35 = inttoptr i64 %.825.1 to ptr
  %scevgep112 = getelementptr i8, ptr %35, i64 120
  %36 = and i64 %34, 4611686018427387902
  br label %.1129.endif.1

.1129.endif.1:                                    ; preds = %.1129.endif.1, %.1129.endif.1.preheader.new.new
  %lsr.iv72 = phi i64 [ %lsr.iv.next73, %.1129.endif.1 ], [ %36, %.1129.endif.1.preheader.new.new ]
  %.1125.0388.1 = phi i64 [ %.1170.1.7.1, %.1129.endif.1 ], [ 0, %.1129.endif.1.preheader.new.new ]
  %37 = shl i64 %.1125.0388.1, 3
  %scevgep147 = getelementptr i8, ptr %scevgep112, i64 %37
  %scevgep148 = getelementptr i8, ptr %scevgep147, i64 -64
  %scevgep161 = getelementptr i8, ptr %scevgep147, i64 -120
  store double 0x7FF8000000000000, ptr %scevgep161, align 8
  %scevgep160 = getelementptr i8, ptr %scevgep147, i64 -112
  store double 0x7FF8000000000000, ptr %scevgep160, align 8
  %scevgep126 = getelementptr i8, ptr %scevgep147, i64 -104
  store double 0x7FF8000000000000, ptr %scevgep126, align 8
  %scevgep122 = getelementptr i8, ptr %scevgep147, i64 -96
  store double 0x7FF8000000000000, ptr %scevgep122, align 8
  %scevgep118 = getelementptr i8, ptr %scevgep147, i64 -88
  store double 0x7FF8000000000000, ptr %scevgep118, align 8
  %scevgep114 = getelementptr i8, ptr %scevgep147, i64 -80
  store double 0x7FF8000000000000, ptr %scevgep114, align 8
  %scevgep108 = getelementptr i8, ptr %scevgep147, i64 -72
  store double 0x7FF8000000000000, ptr %scevgep108, align 8
  store double 0x7FF8000000000000, ptr %scevgep148, align 8
  %scevgep102 = getelementptr i8, ptr %scevgep147, i64 -56
  store double 0x7FF8000000000000, ptr %scevgep102, align 8
  %scevgep98 = getelementptr i8, ptr %scevgep147, i64 -48
  store double 0x7FF8000000000000, ptr %scevgep98, align 8
  %scevgep94 = getelementptr i8, ptr %scevgep147, i64 -40
  store double 0x7FF8000000000000, ptr %scevgep94, align 8
  %scevgep89 = getelementptr i8, ptr %scevgep147, i64 -32
  store double 0x7FF8000000000000, ptr %scevgep89, align 8
  %scevgep85 = getelementptr i8, ptr %scevgep147, i64 -24
  store double 0x7FF8000000000000, ptr %scevgep85, align 8
  %scevgep81 = getelementptr i8, ptr %scevgep147, i64 -16
  store double 0x7FF8000000000000, ptr %scevgep81, align 8
  %scevgep77 = getelementptr i8, ptr %scevgep147, i64 -8
  store double 0x7FF8000000000000, ptr %scevgep77, align 8
  store double 0x7FF8000000000000, ptr %scevgep147, align 8
  %.1170.1.7.1 = add i64 %.1125.0388.1, 16
  %lsr.iv.next73 = add i64 %lsr.iv72, -2
  %niter42.ncmp.1 = icmp eq i64 %lsr.iv.next73, 0
  br i1 %niter42.ncmp.1, label %B566.1.sink.split.loopexit41.unr-lcssa.unr-lcssa, label %.1129.endif.1, !prof !54, !llvm.loop !55

B402.1:                                           ; preds = %B350.1
  %.463.1 = add nsw i64 %.318, %.459.reass
  br i1 %29, label %B566.1, label %.768.endif.1.preheader, !prof !5

.768.endif.1.preheader:                           ; preds = %B402.1
  %xtraiter66 = and i64 %"$phi260.0.2.0", 7
  %38 = icmp ult i64 %"$phi260.0.2.0", 8
  br i1 %38, label %.768.endif.1.epil.preheader, label %.768.endif.1.preheader.new, !prof !45

.768.endif.1.preheader.new:                       ; preds = %.768.endif.1.preheader
  %39 = add nsw i64 %"$phi260.0.2.0", -8
  %40 = lshr i64 %39, 3
  %41 = icmp eq i64 %40, 0
  br i1 %41, label %.768.endif.1.epil.preheader43, label %.768.endif.1.preheader.new.new, !prof !46

.768.endif.1.preheader.new.new:                   ; preds = %.768.endif.1.preheader.new
  %42 = add nuw nsw i64 %40, 1
  %43 = inttoptr i64 %.463.1 to ptr
  %scevgep57 = getelementptr i8, ptr %43, i64 60
  %44 = and i64 %42, 4611686018427387902
  br label %.768.endif.1

.768.endif.1:                                     ; preds = %.768.endif.1, %.768.endif.1.preheader.new.new
  %lsr.iv20 = phi i64 [ %lsr.iv.next21, %.768.endif.1 ], [ %44, %.768.endif.1.preheader.new.new ]
  %.764.0386.1 = phi i64 [ %.809.1.7.1, %.768.endif.1 ], [ 0, %.768.endif.1.preheader.new.new ]
  %45 = shl i64 %.764.0386.1, 2
  %scevgep73 = getelementptr i8, ptr %scevgep57, i64 %45
  %scevgep74 = getelementptr i8, ptr %scevgep73, i64 -32
  %scevgep103 = getelementptr i8, ptr %scevgep73, i64 -60
  store float 0x7FF8000000000000, ptr %scevgep103, align 4
  %scevgep101 = getelementptr i8, ptr %scevgep73, i64 -56
  store float 0x7FF8000000000000, ptr %scevgep101, align 4
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
  %.809.1.7.1 = add i64 %.764.0386.1, 16
  %lsr.iv.next21 = add i64 %lsr.iv20, -2
  %niter52.ncmp.1 = icmp eq i64 %lsr.iv.next21, 0
  br i1 %niter52.ncmp.1, label %B566.1.sink.split.loopexit.unr-lcssa.unr-lcssa, label %.768.endif.1, !prof !54, !llvm.loop !57

B566.1.sink.split.loopexit.unr-lcssa.unr-lcssa:   ; preds = %.768.endif.1
  %46 = and i64 %39, 8
  %lcmp.mod48.not.not = icmp eq i64 %46, 0
  br i1 %lcmp.mod48.not.not, label %.768.endif.1.epil.preheader43, label %B566.1.sink.split.loopexit.unr-lcssa, !prof !47

.768.endif.1.epil.preheader43:                    ; preds = %B566.1.sink.split.loopexit.unr-lcssa.unr-lcssa, %.768.endif.1.preheader.new
  %.764.0386.1.epil.init47 = phi i64 [ 0, %.768.endif.1.preheader.new ], [ %.809.1.7.1, %B566.1.sink.split.loopexit.unr-lcssa.unr-lcssa ]
  %sunkaddr293 = inttoptr i64 %.463.1 to ptr
  %sunkaddr294 = shl i64 %.764.0386.1.epil.init47, 2
  %sunkaddr295 = getelementptr i8, ptr %sunkaddr293, i64 %sunkaddr294
  store float 0x7FF8000000000000, ptr %sunkaddr295, align 4
  %sunkaddr299 = getelementptr i8, ptr %sunkaddr295, i64 4
  store float 0x7FF8000000000000, ptr %sunkaddr299, align 4
  %sunkaddr303 = getelementptr i8, ptr %sunkaddr295, i64 8
  store float 0x7FF8000000000000, ptr %sunkaddr303, align 4
  %sunkaddr307 = getelementptr i8, ptr %sunkaddr295, i64 12
  store float 0x7FF8000000000000, ptr %sunkaddr307, align 4
  %sunkaddr311 = getelementptr i8, ptr %sunkaddr295, i64 16
  store float 0x7FF8000000000000, ptr %sunkaddr311, align 4
  %sunkaddr315 = getelementptr i8, ptr %sunkaddr295, i64 20
  store float 0x7FF8000000000000, ptr %sunkaddr315, align 4
  %sunkaddr319 = getelementptr i8, ptr %sunkaddr295, i64 24
  store float 0x7FF8000000000000, ptr %sunkaddr319, align 4
  %sunkaddr323 = getelementptr i8, ptr %sunkaddr295, i64 28
  store float 0x7FF8000000000000, ptr %sunkaddr323, align 4
  %.809.1.7.epil = add nuw i64 %.764.0386.1.epil.init47, 8
  br label %B566.1.sink.split.loopexit.unr-lcssa

B566.1.sink.split.loopexit.unr-lcssa:             ; preds = %.768.endif.1.epil.preheader43, %B566.1.sink.split.loopexit.unr-lcssa.unr-lcssa
  %.809.1.7.lcssa = phi i64 [ %.809.1.7.epil, %.768.endif.1.epil.preheader43 ], [ %.809.1.7.1, %B566.1.sink.split.loopexit.unr-lcssa.unr-lcssa ]
  %lcmp.mod68.not = icmp eq i64 %xtraiter66, 0
  br i1 %lcmp.mod68.not, label %B566.1, label %.768.endif.1.epil.preheader, !prof !48

.768.endif.1.epil.preheader:                      ; preds = %B566.1.sink.split.loopexit.unr-lcssa, %.768.endif.1.preheader
  %.764.0386.1.epil.init = phi i64 [ 0, %.768.endif.1.preheader ], [ %.809.1.7.lcssa, %B566.1.sink.split.loopexit.unr-lcssa ]
  %47 = inttoptr i64 %.463.1 to ptr
  %48 = shl i64 %.764.0386.1.epil.init, 2
  %scevgep = getelementptr i8, ptr %47, i64 %48
  br label %.768.endif.1.epil

.768.endif.1.epil:                                ; preds = %.768.endif.1.epil, %.768.endif.1.epil.preheader
  %epil.iter67 = phi i64 [ %epil.iter67.next, %.768.endif.1.epil ], [ 0, %.768.endif.1.epil.preheader ]
  %49 = shl i64 %epil.iter67, 2
  %scevgep56 = getelementptr i8, ptr %scevgep, i64 %49
  store float 0x7FF8000000000000, ptr %scevgep56, align 4
  %epil.iter67.next = add i64 %epil.iter67, 1
  %epil.iter67.cmp.not = icmp eq i64 %xtraiter66, %epil.iter67.next
  br i1 %epil.iter67.cmp.not, label %B566.1, label %.768.endif.1.epil, !prof !49, !llvm.loop !58

B566.1.sink.split.loopexit41.unr-lcssa.unr-lcssa: ; preds = %.1129.endif.1
  %50 = and i64 %31, 8
  %lcmp.mod38.not.not = icmp eq i64 %50, 0
  br i1 %lcmp.mod38.not.not, label %.1129.endif.1.epil.preheader33, label %B566.1.sink.split.loopexit41.unr-lcssa, !prof !47

.1129.endif.1.epil.preheader33:                   ; preds = %B566.1.sink.split.loopexit41.unr-lcssa.unr-lcssa, %.1129.endif.1.preheader.new
  %.1125.0388.1.epil.init37 = phi i64 [ 0, %.1129.endif.1.preheader.new ], [ %.1170.1.7.1, %B566.1.sink.split.loopexit41.unr-lcssa.unr-lcssa ]
  %sunkaddr324 = inttoptr i64 %.825.1 to ptr
  %sunkaddr325 = shl i64 %.1125.0388.1.epil.init37, 3
  %sunkaddr326 = getelementptr i8, ptr %sunkaddr324, i64 %sunkaddr325
  store double 0x7FF8000000000000, ptr %sunkaddr326, align 8
  %sunkaddr330 = getelementptr i8, ptr %sunkaddr326, i64 8
  store double 0x7FF8000000000000, ptr %sunkaddr330, align 8
  %sunkaddr334 = getelementptr i8, ptr %sunkaddr326, i64 16
  store double 0x7FF8000000000000, ptr %sunkaddr334, align 8
  %sunkaddr338 = getelementptr i8, ptr %sunkaddr326, i64 24
  store double 0x7FF8000000000000, ptr %sunkaddr338, align 8
  %sunkaddr342 = getelementptr i8, ptr %sunkaddr326, i64 32
  store double 0x7FF8000000000000, ptr %sunkaddr342, align 8
  %sunkaddr346 = getelementptr i8, ptr %sunkaddr326, i64 40
  store double 0x7FF8000000000000, ptr %sunkaddr346, align 8
  %sunkaddr350 = getelementptr i8, ptr %sunkaddr326, i64 48
  store double 0x7FF8000000000000, ptr %sunkaddr350, align 8
  %sunkaddr354 = getelementptr i8, ptr %sunkaddr326, i64 56
  store double 0x7FF8000000000000, ptr %sunkaddr354, align 8
  %.1170.1.7.epil = add nuw i64 %.1125.0388.1.epil.init37, 8
  br label %B566.1.sink.split.loopexit41.unr-lcssa

B566.1.sink.split.loopexit41.unr-lcssa:           ; preds = %.1129.endif.1.epil.preheader33, %B566.1.sink.split.loopexit41.unr-lcssa.unr-lcssa
  %.1170.1.7.lcssa = phi i64 [ %.1170.1.7.epil, %.1129.endif.1.epil.preheader33 ], [ %.1170.1.7.1, %B566.1.sink.split.loopexit41.unr-lcssa.unr-lcssa ]
  %lcmp.mod62.not = icmp eq i64 %xtraiter60, 0
  br i1 %lcmp.mod62.not, label %B566.1, label %.1129.endif.1.epil.preheader, !prof !48

.1129.endif.1.epil.preheader:                     ; preds = %B566.1.sink.split.loopexit41.unr-lcssa, %.1129.endif.1.preheader
  %.1125.0388.1.epil.init = phi i64 [ 0, %.1129.endif.1.preheader ], [ %.1170.1.7.lcssa, %B566.1.sink.split.loopexit41.unr-lcssa ]
  %51 = inttoptr i64 %.825.1 to ptr
  %52 = shl i64 %.1125.0388.1.epil.init, 3
  %scevgep91 = getelementptr i8, ptr %51, i64 %52
  br label %.1129.endif.1.epil

.1129.endif.1.epil:                               ; preds = %.1129.endif.1.epil, %.1129.endif.1.epil.preheader
  %epil.iter61 = phi i64 [ %epil.iter61.next, %.1129.endif.1.epil ], [ 0, %.1129.endif.1.epil.preheader ]
  %53 = shl i64 %epil.iter61, 3
  %scevgep105 = getelementptr i8, ptr %scevgep91, i64 %53
  store double 0x7FF8000000000000, ptr %scevgep105, align 8
  %epil.iter61.next = add i64 %epil.iter61, 1
  %epil.iter61.cmp.not = icmp eq i64 %xtraiter60, %epil.iter61.next
  br i1 %epil.iter61.cmp.not, label %B566.1, label %.1129.endif.1.epil, !prof !49, !llvm.loop !59

B566.1:                                           ; preds = %.1129.endif.1.epil, %.768.endif.1.epil, %B566.1.sink.split.loopexit41.unr-lcssa, %B566.1.sink.split.loopexit.unr-lcssa, %B402.1, %B484.1, %B566
  store ptr null, ptr %retptr, align 8
  ret void

.768.endif:                                       ; preds = %.768.endif, %.768.endif.preheader.new.new
  %lsr.iv = phi i64 [ %lsr.iv.next, %.768.endif ], [ %12, %.768.endif.preheader.new.new ]
  %.764.0386 = phi i64 [ %.809.7.1, %.768.endif ], [ 0, %.768.endif.preheader.new.new ]
  %54 = shl i64 %.764.0386, 2
  %scevgep181 = getelementptr i8, ptr %scevgep165, i64 %54
  %scevgep182 = getelementptr i8, ptr %scevgep181, i64 -32
  %scevgep195 = getelementptr i8, ptr %scevgep181, i64 -60
  store float 0x7FF8000000000000, ptr %scevgep195, align 4
  %scevgep194 = getelementptr i8, ptr %scevgep181, i64 -56
  store float 0x7FF8000000000000, ptr %scevgep194, align 4
  %scevgep155 = getelementptr i8, ptr %scevgep181, i64 -52
  store float 0x7FF8000000000000, ptr %scevgep155, align 4
  %scevgep153 = getelementptr i8, ptr %scevgep181, i64 -48
  store float 0x7FF8000000000000, ptr %scevgep153, align 4
  %scevgep151 = getelementptr i8, ptr %scevgep181, i64 -44
  store float 0x7FF8000000000000, ptr %scevgep151, align 4
  %scevgep149 = getelementptr i8, ptr %scevgep181, i64 -40
  store float 0x7FF8000000000000, ptr %scevgep149, align 4
  %scevgep145 = getelementptr i8, ptr %scevgep181, i64 -36
  store float 0x7FF8000000000000, ptr %scevgep145, align 4
  store float 0x7FF8000000000000, ptr %scevgep182, align 4
  %scevgep143 = getelementptr i8, ptr %scevgep181, i64 -28
  store float 0x7FF8000000000000, ptr %scevgep143, align 4
  %scevgep141 = getelementptr i8, ptr %scevgep181, i64 -24
  store float 0x7FF8000000000000, ptr %scevgep141, align 4
  %scevgep139 = getelementptr i8, ptr %scevgep181, i64 -20
  store float 0x7FF8000000000000, ptr %scevgep139, align 4
  %scevgep137 = getelementptr i8, ptr %scevgep181, i64 -16
  store float 0x7FF8000000000000, ptr %scevgep137, align 4
  %scevgep135 = getelementptr i8, ptr %scevgep181, i64 -12
  store float 0x7FF8000000000000, ptr %scevgep135, align 4
  %scevgep133 = getelementptr i8, ptr %scevgep181, i64 -8
  store float 0x7FF8000000000000, ptr %scevgep133, align 4
  %scevgep131 = getelementptr i8, ptr %scevgep181, i64 -4
  store float 0x7FF8000000000000, ptr %scevgep131, align 4
  store float 0x7FF8000000000000, ptr %scevgep181, align 4
  %.809.7.1 = add i64 %.764.0386, 16
  %lsr.iv.next = add i64 %lsr.iv, -2
  %niter30.ncmp.1 = icmp eq i64 %lsr.iv.next, 0
  br i1 %niter30.ncmp.1, label %B566.sink.split.loopexit.unr-lcssa.unr-lcssa, label %.768.endif, !prof !54, !llvm.loop !60

.1129.endif:                                      ; preds = %.1129.endif, %.1129.endif.preheader.new.new
  %lsr.iv156 = phi i64 [ %lsr.iv.next157, %.1129.endif ], [ %19, %.1129.endif.preheader.new.new ]
  %.1125.0388 = phi i64 [ %.1170.7.1, %.1129.endif ], [ 0, %.1129.endif.preheader.new.new ]
  %55 = shl i64 %.1125.0388, 3
  %scevgep215 = getelementptr i8, ptr %scevgep199, i64 %55
  %scevgep216 = getelementptr i8, ptr %scevgep215, i64 -64
  %scevgep229 = getelementptr i8, ptr %scevgep215, i64 -120
  store double 0x7FF8000000000000, ptr %scevgep229, align 8
  %scevgep228 = getelementptr i8, ptr %scevgep215, i64 -112
  store double 0x7FF8000000000000, ptr %scevgep228, align 8
  %scevgep187 = getelementptr i8, ptr %scevgep215, i64 -104
  store double 0x7FF8000000000000, ptr %scevgep187, align 8
  %scevgep185 = getelementptr i8, ptr %scevgep215, i64 -96
  store double 0x7FF8000000000000, ptr %scevgep185, align 8
  %scevgep183 = getelementptr i8, ptr %scevgep215, i64 -88
  store double 0x7FF8000000000000, ptr %scevgep183, align 8
  %scevgep179 = getelementptr i8, ptr %scevgep215, i64 -80
  store double 0x7FF8000000000000, ptr %scevgep179, align 8
  %scevgep177 = getelementptr i8, ptr %scevgep215, i64 -72
  store double 0x7FF8000000000000, ptr %scevgep177, align 8
  store double 0x7FF8000000000000, ptr %scevgep216, align 8
  %scevgep175 = getelementptr i8, ptr %scevgep215, i64 -56
  store double 0x7FF8000000000000, ptr %scevgep175, align 8
  %scevgep173 = getelementptr i8, ptr %scevgep215, i64 -48
  store double 0x7FF8000000000000, ptr %scevgep173, align 8
  %scevgep171 = getelementptr i8, ptr %scevgep215, i64 -40
  store double 0x7FF8000000000000, ptr %scevgep171, align 8
  %scevgep169 = getelementptr i8, ptr %scevgep215, i64 -32
  store double 0x7FF8000000000000, ptr %scevgep169, align 8
  %scevgep167 = getelementptr i8, ptr %scevgep215, i64 -24
  store double 0x7FF8000000000000, ptr %scevgep167, align 8
  %scevgep163 = getelementptr i8, ptr %scevgep215, i64 -16
  store double 0x7FF8000000000000, ptr %scevgep163, align 8
  %scevgep159 = getelementptr i8, ptr %scevgep215, i64 -8
  store double 0x7FF8000000000000, ptr %scevgep159, align 8
  store double 0x7FF8000000000000, ptr %scevgep215, align 8
  %.1170.7.1 = add i64 %.1125.0388, 16
  %lsr.iv.next157 = add i64 %lsr.iv156, -2
  %niter.ncmp.1 = icmp eq i64 %lsr.iv.next157, 0
  br i1 %niter.ncmp.1, label %B566.sink.split.loopexit42.unr-lcssa.unr-lcssa, label %.1129.endif, !prof !54, !llvm.loop !61
}

; Function Attrs: mustprogress nocallback nocreateundeforpoison nofree nosync nounwind speculatable willreturn memory(none)
declare <8 x double> @llvm.fma.v8f64(<8 x double>, <8 x double>, <8 x double>) #3

; Function Attrs: mustprogress nocallback nocreateundeforpoison nofree nosync nounwind speculatable willreturn memory(none)
declare double @llvm.exp.f64(double) #3

; Function Attrs: nofree noinline norecurse nosync nounwind memory(readwrite, inaccessiblemem: none, target_mem0: none, target_mem1: none)
define internal fastcc noundef range(i32 0, 2) i32 @inner_8(ptr noalias nonnull writeonly captures(none) %retptr, ptr noalias nonnull writeonly captures(none) %excinfo, ptr readonly captures(none) %arg.row.4, ptr readonly captures(none) %arg.linear.4, ptr readonly captures(none) %arg.contents.4, ptr readonly captures(none) %arg.weights.4, i64 %arg.alignment, ptr readonly captures(none) %arg.cubics.0.4, ptr readonly captures(none) %arg.cubics.1.4, i64 range(i64 0, -7) %arg.stride, ptr captures(none) initializes((0, 64)) %arg.series.4, ptr initializes((0, 384)) %arg.work.4, ptr writeonly captures(none) %arg.polynomials_a.4, ptr writeonly captures(none) %arg.polynomials_p.4) unnamed_addr #5 {
entry:
  %.1075 = alloca double, align 8
  store double 0.000000e+00, ptr %.1075, align 8
  %excinfo.10 = alloca ptr, align 8
  store ptr null, ptr %excinfo.10, align 8
  %.1286 = alloca ptr, align 8
  store ptr null, ptr %.1286, align 8
  %.157 = getelementptr i8, ptr %arg.contents.4, i64 144
  %.158 = load i64, ptr %.157, align 8
  %.160 = add i64 %.158, 7
  %.201 = and i64 %.160, -8
  %.202 = shl i64 %.158, 3
  %.231 = getelementptr i8, ptr %arg.contents.4, i64 152
  %.232 = load i64, ptr %.231, align 8
  %.242 = getelementptr double, ptr %arg.weights.4, i64 %.232
  %.322 = getelementptr i8, ptr %arg.contents.4, i64 160
  %.323 = load i64, ptr %.322, align 8
  %0 = lshr i64 %.323, 47
  %.360 = and i64 %0, 65536
  %.361 = add i64 %.360, %.323
  %.364 = icmp slt i64 %.361, 0
  br i1 %.364, label %B0.endif.endif.else.if, label %B0.endif.endif.else.endif, !prof !5

common.ret:                                       ; preds = %B0.endif.endif.endif.endi...endif.4.endif.endif.endif, %B0.endif.endif.endif.endi...endif.1.endif.if
  %common.ret.op = phi i32 [ 1, %B0.endif.endif.endif.endi...endif.1.endif.if ], [ 0, %B0.endif.endif.endif.endi...endif.4.endif.endif.endif ]
  ret i32 %common.ret.op

B0.endif.endif.else.if:                           ; preds = %entry
  br label %B0.endif.endif.else.endif

B0.endif.endif.else.endif:                        ; preds = %B0.endif.endif.else.if, %entry
  %.349.sroa.0.1 = phi i64 [ 0, %B0.endif.endif.else.if ], [ %.361, %entry ]
  %.369.not = icmp slt i64 %.361, 65536
  br i1 %.369.not, label %B0.endif.endif.else.endif.endif, label %B0.endif.endif.else.endif.if, !prof !1

B0.endif.endif.else.endif.if:                     ; preds = %B0.endif.endif.else.endif
  br label %B0.endif.endif.else.endif.endif

B0.endif.endif.else.endif.endif:                  ; preds = %B0.endif.endif.else.endif.if, %B0.endif.endif.else.endif
  %.349.sroa.0.3 = phi i64 [ 65536, %B0.endif.endif.else.endif.if ], [ %.349.sroa.0.1, %B0.endif.endif.else.endif ]
  %.462 = getelementptr i64, ptr %arg.contents.4, i64 %.349.sroa.0.3
  %.507.idx = mul i64 %.201, 24
  %.507 = getelementptr i8, ptr %.242, i64 %.507.idx
  %.576 = getelementptr i8, ptr %.507, i64 1024
  %.637 = getelementptr double, ptr %.576, i64 %.202
  %.699.idx = shl i64 %.158, 7
  %.699 = getelementptr i8, ptr %.576, i64 %.699.idx
  %.830.idx = shl i64 %.201, 6
  %.830 = getelementptr i8, ptr %arg.work.4, i64 %.830.idx
  %.915 = getelementptr i8, ptr %arg.contents.4, i64 120
  %.916 = load i64, ptr %.915, align 8
  %.926 = getelementptr inbounds double, ptr %arg.weights.4, i64 %.916
  %.991.idx = shl nsw i64 %arg.stride, 5
  %.991 = getelementptr inbounds i8, ptr %arg.linear.4, i64 %.991.idx
  %.1070 = getelementptr i8, ptr %arg.contents.4, i64 128
  %.1071 = load i64, ptr %.1070, align 8
  store double 0.000000e+00, ptr %.1075, align 8
  %.1089 = call fastcc i32 @inner_9(ptr nonnull %.1075, ptr nonnull %excinfo.10, ptr %arg.row.4, double 1.000000e+00, ptr %arg.weights.4, i64 %.1071, ptr %.991, i64 %arg.alignment, ptr %arg.work.4, ptr %arg.series.4)
  %.1099 = load double, ptr %.1075, align 8
  %cond = icmp eq i32 %.1089, 0
  br i1 %cond, label %B0.endif.endif.endif.endi...endif.1.endif.endif, label %B0.endif.endif.endif.endi...endif.1.endif.if, !prof !0

B0.endif.endif.endif.endi...endif.1.endif.if:     ; preds = %B0.endif.endif.else.endif.endif
  %.1090 = load ptr, ptr %excinfo.10, align 8
  store ptr %.1090, ptr %excinfo, align 8
  br label %common.ret

B0.endif.endif.endif.endi...endif.1.endif.endif:  ; preds = %B0.endif.endif.else.endif.endif
  %.31.i = icmp sgt i64 %.158, 0
  br i1 %.31.i, label %B24.i, label %B0.endif.endif.endif.endi...endif.2.endif

B24.i:                                            ; preds = %B0.endif.endif.endif.endi...endif.1.endif.endif, %B24.i
  %high.2.0.i = phi i64 [ %high.3.1.i, %B24.i ], [ %.202, %B0.endif.endif.endif.endi...endif.1.endif.endif ]
  %low.2.0.i = phi i64 [ %low.3.1.i, %B24.i ], [ 0, %B0.endif.endif.endif.endi...endif.1.endif.endif ]
  %.40.i = add nuw nsw i64 %low.2.0.i, %high.2.0.i
  %.41.i = lshr i64 %.40.i, 1
  %.53.i = getelementptr inbounds nuw double, ptr %.576, i64 %.41.i
  %.54.i = load double, ptr %.53.i, align 8, !noalias !62
  %.56.i = fcmp contract olt double %.54.i, 1.000000e-02
  %.67.i = add nuw nsw i64 %.41.i, 1
  %high.3.1.i = select i1 %.56.i, i64 %high.2.0.i, i64 %.41.i
  %low.3.1.i = select i1 %.56.i, i64 %.67.i, i64 %low.2.0.i
  %.98.i = icmp slt i64 %low.3.1.i, %high.3.1.i
  br i1 %.98.i, label %B24.i, label %B24.i43

B24.i43:                                          ; preds = %B24.i, %B24.i43
  %high.2.0.i44 = phi i64 [ %high.3.1.i52, %B24.i43 ], [ %.202, %B24.i ]
  %low.2.0.i45 = phi i64 [ %low.3.1.i53, %B24.i43 ], [ 0, %B24.i ]
  %.40.i46 = add nuw nsw i64 %low.2.0.i45, %high.2.0.i44
  %.41.i47 = lshr i64 %.40.i46, 1
  %.53.i48 = getelementptr inbounds nuw double, ptr %.576, i64 %.41.i47
  %.54.i49 = load double, ptr %.53.i48, align 8, !noalias !65
  %.56.i50 = fcmp contract olt double %.54.i49, 2.000000e-02
  %.67.i51 = add nuw nsw i64 %.41.i47, 1
  %high.3.1.i52 = select i1 %.56.i50, i64 %high.2.0.i44, i64 %.41.i47
  %low.3.1.i53 = select i1 %.56.i50, i64 %.67.i51, i64 %low.2.0.i45
  %.98.i54 = icmp slt i64 %low.3.1.i53, %high.3.1.i52
  br i1 %.98.i54, label %B24.i43, label %B34.if.lr.ph.i

B34.if.lr.ph.i:                                   ; preds = %B24.i43
  %1 = getelementptr double, ptr %arg.cubics.0.4, i64 %arg.stride
  %.idx.i = shl i64 %arg.stride, 4
  %2 = getelementptr i8, ptr %arg.cubics.0.4, i64 %.idx.i
  %.idx161.i = mul i64 %arg.stride, 24
  %3 = getelementptr i8, ptr %arg.cubics.0.4, i64 %.idx161.i
  br label %B34.if.i

B34.if.i:                                         ; preds = %B34.if.i, %B34.if.lr.ph.i
  %lsr.iv4.i = phi i64 [ %.158, %B34.if.lr.ph.i ], [ %lsr.iv.next5.i, %B34.if.i ]
  %lsr.iv.i = phi i64 [ 0, %B34.if.lr.ph.i ], [ %lsr.iv.next.i, %B34.if.i ]
  %scevgep3.i = getelementptr i8, ptr %.462, i64 %lsr.iv.i
  %.205.i = load i64, ptr %scevgep3.i, align 8, !noalias !68
  %4 = shl i64 %lsr.iv.i, 3
  %scevgep.i = getelementptr i8, ptr %.637, i64 %4
  %.216.i = load <8 x double>, ptr %scevgep.i, align 8, !noalias !68
  %.224.i = getelementptr inbounds double, ptr %.926, i64 %.205.i
  %.225.i = load double, ptr %.224.i, align 8, !noalias !68
  %.6.i.i = insertelement <8 x double> poison, double %.225.i, i64 0
  %.7.i.i = shufflevector <8 x double> %.6.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.8.i.i = fsub contract <8 x double> %.216.i, %.7.i.i
  %.257.i = getelementptr inbounds double, ptr %arg.cubics.0.4, i64 %.205.i
  %.258.i = load double, ptr %.257.i, align 8, !noalias !68
  %.268.i = getelementptr double, ptr %1, i64 %.205.i
  %.269.i = load double, ptr %.268.i, align 8, !noalias !68
  %.280.i = getelementptr double, ptr %2, i64 %.205.i
  %.281.i = load double, ptr %.280.i, align 8, !noalias !68
  %.292.i = getelementptr double, ptr %3, i64 %.205.i
  %.293.i = load double, ptr %.292.i, align 8, !noalias !68
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
  %scevgep11 = getelementptr i8, ptr %arg.work.4, i64 %4
  store <8 x double> %.305.i, ptr %scevgep11, align 8, !noalias !68
  %lsr.iv.next.i = add nuw i64 %lsr.iv.i, 8
  %lsr.iv.next5.i = add i64 %lsr.iv4.i, -1
  %exitcond.not.i = icmp eq i64 %lsr.iv.next5.i, 0
  br i1 %exitcond.not.i, label %B0.endif.endif.endif.endi...endif.2.endif, label %B34.if.i

B0.endif.endif.endif.endi...endif.2.endif:        ; preds = %B34.if.i, %B0.endif.endif.endif.endi...endif.1.endif.endif
  %low.4.1.i428 = phi i64 [ 0, %B0.endif.endif.endif.endi...endif.1.endif.endif ], [ %low.3.1.i53, %B34.if.i ]
  %low.4.1.i27 = phi i64 [ 0, %B0.endif.endif.endif.endi...endif.1.endif.endif ], [ %low.3.1.i, %B34.if.i ]
  %.1235.idx = shl nsw i64 %.158, 8
  %.1235 = getelementptr inbounds i8, ptr %.576, i64 %.1235.idx
  store ptr null, ptr %.1286, align 8
  call fastcc void @inner_10(ptr nonnull %.1286, ptr %.576, ptr %.699, ptr %.1235, i64 %low.4.1.i27, i64 %low.4.1.i428, i64 %.202, double 1.000000e+00, ptr %arg.series.4, double %.1099, ptr %arg.work.4, ptr %.830)
  %5 = icmp slt i64 %.158, 1
  br i1 %5, label %_ZN17bnserve_surrogate6kernel7_points15spline_at_nodesB4v133B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE.exit109, label %B64.if.i.preheader

B64.if.i.preheader:                               ; preds = %B0.endif.endif.endif.endi...endif.2.endif
  %6 = shl i64 %.232, 3
  %7 = getelementptr i8, ptr %arg.weights.4, i64 %.507.idx
  %8 = getelementptr i8, ptr %7, i64 %6
  %scevgep299 = getelementptr i8, ptr %8, i64 576
  br label %B64.if.i

B424.i:                                           ; preds = %B172.if.i
  %.138.i = add nsw i64 %.128167175.i, -1
  %.142.i = add i64 %.135168174.i, 8
  %.6.i.i68 = fadd contract <8 x double> %.322.i, %.352.i
  %.398.i = getelementptr inbounds double, ptr %arg.polynomials_a.4, i64 %.135168174.i
  store <8 x double> %.6.i.i68, ptr %.398.i, align 8, !noalias !71
  %scevgep.i69 = getelementptr i8, ptr %lsr.iv2.i, i64 64
  %.129.i = icmp sgt i64 %.128167175.i, 1
  br i1 %.129.i, label %B64.if.i, label %B34.if.lr.ph.i71

B64.if.i:                                         ; preds = %B424.i, %B64.if.i.preheader
  %lsr.iv2.i = phi ptr [ %scevgep.i69, %B424.i ], [ %.830, %B64.if.i.preheader ]
  %.128167175.i = phi i64 [ %.138.i, %B424.i ], [ %.158, %B64.if.i.preheader ]
  %.135168174.i = phi i64 [ %.142.i, %B424.i ], [ 0, %B64.if.i.preheader ]
  br label %B172.if.i

B172.if.i:                                        ; preds = %B172.if.i, %B64.if.i
  %lsr.iv6 = phi i64 [ %lsr.iv.next7, %B172.if.i ], [ 10, %B64.if.i ]
  %lsr.iv295 = phi i64 [ %lsr.iv.next296, %B172.if.i ], [ 0, %B64.if.i ]
  %even.2.1163.i = phi <8 x double> [ %.322.i, %B172.if.i ], [ zeroinitializer, %B64.if.i ]
  %odd.2.1162.i = phi <8 x double> [ %.352.i, %B172.if.i ], [ zeroinitializer, %B64.if.i ]
  %9 = shl nuw nsw i64 %lsr.iv295, 3
  %scevgep10 = getelementptr i8, ptr %scevgep299, i64 %9
  %scevgep9 = getelementptr i8, ptr %scevgep10, i64 -64
  %.307.i = load <8 x double>, ptr %scevgep9, align 8, !noalias !71
  %scevgep297 = getelementptr i8, ptr %lsr.iv2.i, i64 %lsr.iv295
  %scevgep298 = getelementptr i8, ptr %scevgep297, i64 8
  %.318.i = load double, ptr %scevgep297, align 8, !noalias !71
  %.320.i = insertelement <8 x double> poison, double %.318.i, i64 0
  %.321.i = shufflevector <8 x double> %.320.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.322.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.307.i, <8 x double> %.321.i, <8 x double> %even.2.1163.i)
  %.336.i = load <8 x double>, ptr %scevgep10, align 8, !noalias !71
  %.348.i = load double, ptr %scevgep298, align 8, !noalias !71
  %.350.i = insertelement <8 x double> poison, double %.348.i, i64 0
  %.351.i = shufflevector <8 x double> %.350.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.352.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.336.i, <8 x double> %.351.i, <8 x double> %odd.2.1162.i)
  %lsr.iv.next296 = add nuw nsw i64 %lsr.iv295, 16
  %lsr.iv.next7 = add nsw i64 %lsr.iv6, -1
  %.259.i = icmp samesign ugt i64 %lsr.iv6, 7
  br i1 %.259.i, label %B172.if.i, label %B424.i

B34.if.lr.ph.i71:                                 ; preds = %B424.i
  %10 = getelementptr double, ptr %arg.cubics.1.4, i64 %arg.stride
  %.idx.i72 = shl i64 %arg.stride, 4
  %11 = getelementptr i8, ptr %arg.cubics.1.4, i64 %.idx.i72
  %.idx161.i73 = mul i64 %arg.stride, 24
  %12 = getelementptr i8, ptr %arg.cubics.1.4, i64 %.idx161.i73
  br label %B34.if.i74

B34.if.i74:                                       ; preds = %B34.if.i74, %B34.if.lr.ph.i71
  %lsr.iv4.i75 = phi i64 [ %.158, %B34.if.lr.ph.i71 ], [ %lsr.iv.next5.i107, %B34.if.i74 ]
  %lsr.iv.i76 = phi i64 [ 0, %B34.if.lr.ph.i71 ], [ %lsr.iv.next.i106, %B34.if.i74 ]
  %scevgep3.i77 = getelementptr i8, ptr %.462, i64 %lsr.iv.i76
  %.205.i78 = load i64, ptr %scevgep3.i77, align 8, !noalias !74
  %13 = shl i64 %lsr.iv.i76, 3
  %scevgep.i79 = getelementptr i8, ptr %.637, i64 %13
  %.216.i80 = load <8 x double>, ptr %scevgep.i79, align 8, !noalias !74
  %.224.i81 = getelementptr inbounds double, ptr %.926, i64 %.205.i78
  %.225.i82 = load double, ptr %.224.i81, align 8, !noalias !74
  %.6.i.i83 = insertelement <8 x double> poison, double %.225.i82, i64 0
  %.7.i.i84 = shufflevector <8 x double> %.6.i.i83, <8 x double> poison, <8 x i32> zeroinitializer
  %.8.i.i85 = fsub contract <8 x double> %.216.i80, %.7.i.i84
  %.257.i86 = getelementptr inbounds double, ptr %arg.cubics.1.4, i64 %.205.i78
  %.258.i87 = load double, ptr %.257.i86, align 8, !noalias !74
  %.268.i88 = getelementptr double, ptr %10, i64 %.205.i78
  %.269.i89 = load double, ptr %.268.i88, align 8, !noalias !74
  %.280.i90 = getelementptr double, ptr %11, i64 %.205.i78
  %.281.i91 = load double, ptr %.280.i90, align 8, !noalias !74
  %.292.i92 = getelementptr double, ptr %12, i64 %.205.i78
  %.293.i93 = load double, ptr %.292.i92, align 8, !noalias !74
  %.295.i94 = insertelement <8 x double> poison, double %.293.i93, i64 0
  %.296.i95 = shufflevector <8 x double> %.295.i94, <8 x double> poison, <8 x i32> zeroinitializer
  %.297.i96 = insertelement <8 x double> poison, double %.281.i91, i64 0
  %.298.i97 = shufflevector <8 x double> %.297.i96, <8 x double> poison, <8 x i32> zeroinitializer
  %.299.i98 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i.i85, <8 x double> %.296.i95, <8 x double> %.298.i97)
  %.300.i99 = insertelement <8 x double> poison, double %.269.i89, i64 0
  %.301.i100 = shufflevector <8 x double> %.300.i99, <8 x double> poison, <8 x i32> zeroinitializer
  %.302.i101 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i.i85, <8 x double> %.299.i98, <8 x double> %.301.i100)
  %.303.i102 = insertelement <8 x double> poison, double %.258.i87, i64 0
  %.304.i103 = shufflevector <8 x double> %.303.i102, <8 x double> poison, <8 x i32> zeroinitializer
  %.305.i104 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i.i85, <8 x double> %.302.i101, <8 x double> %.304.i103)
  %scevgep5 = getelementptr i8, ptr %arg.work.4, i64 %13
  store <8 x double> %.305.i104, ptr %scevgep5, align 8, !noalias !74
  %lsr.iv.next.i106 = add nuw i64 %lsr.iv.i76, 8
  %lsr.iv.next5.i107 = add i64 %lsr.iv4.i75, -1
  %exitcond.not.i108 = icmp eq i64 %lsr.iv.next5.i107, 0
  br i1 %exitcond.not.i108, label %_ZN17bnserve_surrogate6kernel7_points15spline_at_nodesB4v133B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE.exit109, label %B34.if.i74

_ZN17bnserve_surrogate6kernel7_points15spline_at_nodesB4v133B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE.exit109: ; preds = %B34.if.i74, %B0.endif.endif.endif.endi...endif.2.endif
  %.1630.idx = mul i64 %.158, 192
  %.1630 = getelementptr i8, ptr %.576, i64 %.1630.idx
  %.1167.i = and i64 %.158, 2305843009213693951
  %.1189570.not574.i = icmp eq i64 %.1167.i, 0
  %.1189570.not.i = or i1 %5, %.1189570.not574.i
  br i1 %.1189570.not.i, label %B0.endif.endif.endif.endi...endif.4.endif.endif, label %B484.if.lr.ph.i

B484.if.lr.ph.i:                                  ; preds = %_ZN17bnserve_surrogate6kernel7_points15spline_at_nodesB4v133B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE.exit109
  %.1561 = getelementptr inbounds nuw i8, ptr %arg.series.4, i64 192
  %.1497 = getelementptr inbounds nuw i8, ptr %arg.series.4, i64 64
  %.1012.i = getelementptr i8, ptr %arg.series.4, i64 264
  %.1013.i = load double, ptr %.1012.i, align 8, !noalias !77
  %.983.i = getelementptr i8, ptr %arg.series.4, i64 256
  %.984.i = load double, ptr %.983.i, align 8, !noalias !77
  %.954.i = getelementptr i8, ptr %arg.series.4, i64 248
  %.955.i = load double, ptr %.954.i, align 8, !noalias !77
  %.925.i = getelementptr i8, ptr %arg.series.4, i64 240
  %.926.i = load double, ptr %.925.i, align 8, !noalias !77
  %.896.i = getelementptr i8, ptr %arg.series.4, i64 232
  %.897.i = load double, ptr %.896.i, align 8, !noalias !77
  %.867.i = getelementptr i8, ptr %arg.series.4, i64 224
  %.868.i = load double, ptr %.867.i, align 8, !noalias !77
  %.838.i = getelementptr i8, ptr %arg.series.4, i64 216
  %.839.i = load double, ptr %.838.i, align 8, !noalias !77
  %.809.i = getelementptr i8, ptr %arg.series.4, i64 208
  %.810.i = load double, ptr %.809.i, align 8, !noalias !77
  %.780.i = getelementptr i8, ptr %arg.series.4, i64 200
  %.781.i = load double, ptr %.780.i, align 8, !noalias !77
  %.752.i = load double, ptr %.1561, align 8, !noalias !77
  %.647.i = getelementptr i8, ptr %arg.series.4, i64 184
  %.648.i = load double, ptr %.647.i, align 8, !noalias !77
  %.618.i = getelementptr i8, ptr %arg.series.4, i64 176
  %.619.i = load double, ptr %.618.i, align 8, !noalias !77
  %.589.i = getelementptr i8, ptr %arg.series.4, i64 168
  %.590.i = load double, ptr %.589.i, align 8, !noalias !77
  %.560.i = getelementptr i8, ptr %arg.series.4, i64 160
  %.561.i = load double, ptr %.560.i, align 8, !noalias !77
  %.531.i = getelementptr i8, ptr %arg.series.4, i64 152
  %.532.i = load double, ptr %.531.i, align 8, !noalias !77
  %.502.i = getelementptr i8, ptr %arg.series.4, i64 144
  %.503.i = load double, ptr %.502.i, align 8, !noalias !77
  %.473.i = getelementptr i8, ptr %arg.series.4, i64 136
  %.474.i = load double, ptr %.473.i, align 8, !noalias !77
  %.444.i = getelementptr i8, ptr %arg.series.4, i64 128
  %.445.i = load double, ptr %.444.i, align 8, !noalias !77
  %.343.i = getelementptr i8, ptr %arg.series.4, i64 120
  %.344.i = load double, ptr %.343.i, align 8, !noalias !77
  %.314.i = getelementptr i8, ptr %arg.series.4, i64 112
  %.315.i = load double, ptr %.314.i, align 8, !noalias !77
  %.285.i = getelementptr i8, ptr %arg.series.4, i64 104
  %.286.i = load double, ptr %.285.i, align 8, !noalias !77
  %.256.i = getelementptr i8, ptr %arg.series.4, i64 96
  %.257.i125 = load double, ptr %.256.i, align 8, !noalias !77
  %.227.i = getelementptr i8, ptr %arg.series.4, i64 88
  %.228.i = load double, ptr %.227.i, align 8, !noalias !77
  %.198.i = getelementptr i8, ptr %arg.series.4, i64 80
  %.199.i = load double, ptr %.198.i, align 8, !noalias !77
  %.169.i = getelementptr i8, ptr %arg.series.4, i64 72
  %.170.i = load double, ptr %.169.i, align 8, !noalias !77
  %.141.i = load double, ptr %.1497, align 8, !noalias !77
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
  %.1315.i = insertelement <8 x double> poison, double %.257.i125, i64 0
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
  %14 = add nuw nsw i64 %.1167.i, 6
  br label %B484.if.i

B484.if.i:                                        ; preds = %B484.if.i, %B484.if.lr.ph.i
  %lsr.iv3 = phi i64 [ %lsr.iv.next4, %B484.if.i ], [ %14, %B484.if.lr.ph.i ]
  %lsr.iv20.i = phi i64 [ %lsr.iv.next21.i, %B484.if.i ], [ 0, %B484.if.lr.ph.i ]
  %scevgep26.i = getelementptr i8, ptr %.699, i64 %lsr.iv20.i
  %.1236.i = load <8 x double>, ptr %scevgep26.i, align 8, !noalias !77
  %scevgep25.i = getelementptr i8, ptr %.576, i64 %lsr.iv20.i
  %.1246.i = load <8 x double>, ptr %scevgep25.i, align 8, !noalias !77
  %scevgep24.i = getelementptr i8, ptr %.637, i64 %lsr.iv20.i
  %.1256.i = load <8 x double>, ptr %scevgep24.i, align 8, !noalias !77
  %.6.i.i127 = fmul contract <8 x double> %.1236.i, %.1236.i
  %.1287.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i127, <8 x double> %.1283.i, <8 x double> %.1286.i)
  %.1291.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i127, <8 x double> %.1287.i, <8 x double> %.1290.i)
  %.1295.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i127, <8 x double> %.1291.i, <8 x double> %.1294.i)
  %.1302.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i127, <8 x double> %.1298.i, <8 x double> %.1301.i)
  %.1306.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i127, <8 x double> %.1302.i, <8 x double> %.1305.i)
  %.1310.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i127, <8 x double> %.1306.i, <8 x double> %.1309.i)
  %.1317.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i127, <8 x double> %.1313.i, <8 x double> %.1316.i)
  %.1321.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i127, <8 x double> %.1317.i, <8 x double> %.1320.i)
  %.1325.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i127, <8 x double> %.1321.i, <8 x double> %.1324.i)
  %.1332.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i127, <8 x double> %.1328.i, <8 x double> %.1331.i)
  %.1336.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i127, <8 x double> %.1332.i, <8 x double> %.1335.i)
  %.1340.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i127, <8 x double> %.1336.i, <8 x double> %.1339.i)
  %.1347.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i127, <8 x double> %.1343.i, <8 x double> %.1346.i)
  %.1351.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i127, <8 x double> %.1347.i, <8 x double> %.1350.i)
  %.1355.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i127, <8 x double> %.1351.i, <8 x double> %.1354.i)
  %.1362.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i127, <8 x double> %.1358.i, <8 x double> %.1361.i)
  %.1366.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i127, <8 x double> %.1362.i, <8 x double> %.1365.i)
  %.1367.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1236.i, <8 x double> %.1340.i, <8 x double> %.1325.i)
  %scevgep23.i = getelementptr i8, ptr %.1630, i64 %lsr.iv20.i
  %.1377.i = load <8 x double>, ptr %scevgep23.i, align 8, !noalias !77
  %.6.i16.i = fmul contract <8 x double> %.1377.i, %.1367.i
  %.6.i17.i = fmul contract <8 x double> %.1246.i, %.1256.i
  %.1426.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1236.i, <8 x double> %.1366.i, <8 x double> %.1355.i)
  %.1430.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i17.i, <8 x double> %.1429.i, <8 x double> %.1426.i)
  %.1431.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1236.i, <8 x double> %.1310.i, <8 x double> %.1295.i)
  %scevgep22.i = getelementptr i8, ptr %arg.work.4, i64 %lsr.iv20.i
  %.1441.i = load <8 x double>, ptr %scevgep22.i, align 8, !noalias !77
  %.1442.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1246.i, <8 x double> %.1431.i, <8 x double> %.1441.i)
  %.1443.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1256.i, <8 x double> %.1430.i, <8 x double> %.1442.i)
  %.6.i18.i = fadd contract <8 x double> %.6.i16.i, %.1443.i
  %.1450.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1246.i, <8 x double> %.1447.i, <8 x double> %.1449.i)
  %.6.i19.i = fsub contract <8 x double> %.1450.i, %.6.i18.i
  %scevgep.i128 = getelementptr i8, ptr %.830, i64 %lsr.iv20.i
  store <8 x double> %.6.i19.i, ptr %scevgep.i128, align 8, !noalias !77
  %lsr.iv.next21.i = add i64 %lsr.iv20.i, 64
  %lsr.iv.next4 = add nsw i64 %lsr.iv3, -1
  %.1189.i = icmp sgt i64 %lsr.iv3, 7
  br i1 %.1189.i, label %B484.if.i, label %B64.if.i131.preheader

B0.endif.endif.endif.endi...endif.4.endif.endif:  ; preds = %_ZN17bnserve_surrogate6kernel7_points15spline_at_nodesB4v133B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE.exit109
  br i1 %5, label %B0.endif.endif.endif.endi...endif.4.endif.endif.endif, label %B64.if.i131.preheader

B64.if.i131.preheader:                            ; preds = %B484.if.i, %B0.endif.endif.endif.endi...endif.4.endif.endif
  br label %B64.if.i131

B424.i157:                                        ; preds = %B172.if.i135
  %.138.i158 = add nsw i64 %.128167175.i133, -1
  %.142.i159 = add i64 %.135168174.i134, 8
  %.6.i.i160 = fadd contract <8 x double> %.322.i148, %.352.i153
  %.398.i161 = getelementptr inbounds double, ptr %arg.polynomials_p.4, i64 %.135168174.i134
  store <8 x double> %.6.i.i160, ptr %.398.i161, align 8, !noalias !80
  %scevgep.i162 = getelementptr i8, ptr %lsr.iv2.i132, i64 64
  %.129.i163 = icmp sgt i64 %.128167175.i133, 1
  br i1 %.129.i163, label %B64.if.i131, label %B0.endif.endif.endif.endi...endif.4.endif.endif.endif

B64.if.i131:                                      ; preds = %B64.if.i131.preheader, %B424.i157
  %lsr.iv2.i132 = phi ptr [ %scevgep.i162, %B424.i157 ], [ %.830, %B64.if.i131.preheader ]
  %.128167175.i133 = phi i64 [ %.138.i158, %B424.i157 ], [ %.158, %B64.if.i131.preheader ]
  %.135168174.i134 = phi i64 [ %.142.i159, %B424.i157 ], [ 0, %B64.if.i131.preheader ]
  br label %B172.if.i135

B172.if.i135:                                     ; preds = %B172.if.i135, %B64.if.i131
  %lsr.iv = phi i64 [ %lsr.iv.next, %B172.if.i135 ], [ 10, %B64.if.i131 ]
  %lsr.iv3.i136 = phi i64 [ %lsr.iv.next4.i155, %B172.if.i135 ], [ 8, %B64.if.i131 ]
  %even.2.1163.i138 = phi <8 x double> [ %.322.i148, %B172.if.i135 ], [ zeroinitializer, %B64.if.i131 ]
  %odd.2.1162.i139 = phi <8 x double> [ %.352.i153, %B172.if.i135 ], [ zeroinitializer, %B64.if.i131 ]
  %15 = shl nuw nsw i64 %lsr.iv3.i136, 3
  %scevgep2 = getelementptr i8, ptr %.507, i64 %15
  %scevgep1 = getelementptr i8, ptr %scevgep2, i64 -64
  %.307.i142 = load <8 x double>, ptr %scevgep1, align 8, !noalias !80
  %scevgep6.i143 = getelementptr i8, ptr %lsr.iv2.i132, i64 %lsr.iv3.i136
  %scevgep7.i144 = getelementptr i8, ptr %scevgep6.i143, i64 -8
  %.318.i145 = load double, ptr %scevgep7.i144, align 8, !noalias !80
  %.320.i146 = insertelement <8 x double> poison, double %.318.i145, i64 0
  %.321.i147 = shufflevector <8 x double> %.320.i146, <8 x double> poison, <8 x i32> zeroinitializer
  %.322.i148 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.307.i142, <8 x double> %.321.i147, <8 x double> %even.2.1163.i138)
  %.336.i149 = load <8 x double>, ptr %scevgep2, align 8, !noalias !80
  %.348.i150 = load double, ptr %scevgep6.i143, align 8, !noalias !80
  %.350.i151 = insertelement <8 x double> poison, double %.348.i150, i64 0
  %.351.i152 = shufflevector <8 x double> %.350.i151, <8 x double> poison, <8 x i32> zeroinitializer
  %.352.i153 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.336.i149, <8 x double> %.351.i152, <8 x double> %odd.2.1162.i139)
  %lsr.iv.next4.i155 = add nuw nsw i64 %lsr.iv3.i136, 16
  %lsr.iv.next = add nsw i64 %lsr.iv, -1
  %.259.i156 = icmp samesign ugt i64 %lsr.iv, 7
  br i1 %.259.i156, label %B172.if.i135, label %B424.i157

B0.endif.endif.endif.endi...endif.4.endif.endif.endif: ; preds = %B424.i157, %B0.endif.endif.endif.endi...endif.4.endif.endif
  store ptr null, ptr %retptr, align 8
  br label %common.ret
}

; Function Attrs: nofree noinline norecurse nosync nounwind memory(argmem: readwrite)
define internal fastcc noundef range(i32 0, 2) i32 @inner_9(ptr noalias nonnull writeonly captures(none) %retptr, ptr noalias nonnull writeonly captures(none) %excinfo, ptr readonly captures(none) %arg.row.4, double %arg.unit, ptr readonly captures(none) %arg.weights.4, i64 %arg.band_at, ptr readonly captures(none) %arg.gauge.4, i64 %arg.alignment, ptr initializes((0, 384)) %arg.room.4, ptr writeonly captures(none) initializes((0, 64)) %arg.out.4) unnamed_addr #7 {
entry:
  %.109 = getelementptr i8, ptr %arg.row.4, i64 56
  %.110 = load double, ptr %.109, align 8
  %.210 = fmul contract double %arg.unit, 0x400921FB54442D18
  %.211 = tail call contract double @llvm.pow.f64(double %.210, double 0x3FD5555555555555)
  %.223.le = tail call contract double @llvm.log.f64(double %.211)
  %.260 = load double, ptr %arg.row.4, align 8
  %.5.i = fadd contract double %.260, 1.000000e+00
  %.147.i.i9 = fmul contract double %.5.i, %.5.i
  %.35.i = fdiv contract double %.260, %.147.i.i9
  %.285 = fmul contract double %.35.i, 0x3AD23C9F83511538
  %.346 = fmul contract double %.110, %.110
  %.347 = fmul contract double %.346, %.285
  %.376 = getelementptr i8, ptr %arg.row.4, i64 40
  %.377 = load double, ptr %.376, align 8
  %.381 = fdiv contract double %.347, %.377
  %.443 = getelementptr i8, ptr %arg.row.4, i64 24
  %.444 = load double, ptr %.443, align 8
  %.473 = getelementptr i8, ptr %arg.row.4, i64 32
  %.474 = load double, ptr %.473, align 8
  %.54.i = fsub contract double %.444, %.474
  %.147.i.i1 = fmul contract double %.54.i, %.54.i
  %.45.i = fadd contract double %.260, -1.000000e+00
  %.50.i = fdiv contract double %.45.i, %.5.i
  %.51.i = fadd contract double %.444, %.474
  %.52.i = fmul contract double %.51.i, 5.000000e-01
  %.53.i = fmul contract double %.50.i, 5.000000e-01
  %.55.i = fmul contract double %.53.i, %.54.i
  %.81.i = fmul contract double %.147.i.i1, 2.500000e-01
  store double 1.000000e+00, ptr %arg.out.4, align 8, !noalias !83
  %.138.i = getelementptr i8, ptr %arg.out.4, i64 8
  store double 0.000000e+00, ptr %.138.i, align 8, !noalias !83
  %.140.i = fmul contract double %.35.i, 0x400579E79E79E79E
  %.141.i = fadd contract double %.140.i, 0xBFF7124924924925
  %.169.i = getelementptr i8, ptr %arg.out.4, i64 16
  store double %.141.i, ptr %.169.i, align 8, !noalias !83
  %.171.i = fmul contract double %.55.i, 3.375000e+00
  %.172.i = fmul contract double %.35.i, 0x3FFD555555555555
  %.173.i = fsub contract double 3.375000e+00, %.172.i
  %.174.i = fmul contract double %.52.i, %.173.i
  %.175.i = fadd contract double %.171.i, %.174.i
  %.203.i = getelementptr i8, ptr %arg.out.4, i64 24
  store double %.175.i, ptr %.203.i, align 8, !noalias !83
  %.205.i = fmul contract double %.35.i, 0x401167EA53FA94FF
  %.206.i = fadd contract double %.205.i, 0xC0175371959340D3
  %.207.i = fmul contract double %.35.i, %.206.i
  %.208.i = fadd contract double %.207.i, 0xC00AE15A0AB4FC95
  %.236.i = getelementptr i8, ptr %arg.out.4, i64 32
  %.267.i = fmul contract double %.35.i, 6.000000e+00
  %.268.i = fadd contract double %.267.i, -1.531250e+00
  %.269.i = fmul contract double %.268.i, %.81.i
  %.270.i = fmul contract double %.55.i, 3.062500e+00
  %.271.i = fmul contract double %.52.i, %.270.i
  %.272.i = fsub contract double %.269.i, %.271.i
  %.273.i = fadd contract double %.208.i, %.272.i
  %.147.i15.i = fmul contract double %.52.i, %.52.i
  %.335.i = fmul contract double %.35.i, 1.250000e-01
  %.336.i = fadd contract double %.335.i, -1.531250e+00
  %.361.i = fmul contract double %.336.i, %.147.i15.i
  %.362.i5 = fadd contract double %.361.i, %.273.i
  store double %.362.i5, ptr %.236.i, align 8, !noalias !83
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
  store double %.463.i, ptr %.427.i, align 8, !noalias !83
  %.519.i = fmul contract double %.35.i, 0x4050B13F2FF5EE90
  %.520.i = fadd contract double %.519.i, 0xC034AE5A84540D99
  %.548.i = getelementptr i8, ptr %arg.out.4, i64 48
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
  %.671.i = fadd contract double %.606.i, %.670.i
  %.730.i = fmul contract double %.35.i, 0x4017618618618618
  %.731.i = fadd contract double %.730.i, 0x404C130E38E38E39
  %.732.i = fmul contract double %.35.i, %.731.i
  %.733.i = fadd contract double %.732.i, 0xC02B20D145145145
  %.734.i = fmul contract double %.81.i, %.733.i
  %.735.i = fadd contract double %.734.i, %.671.i
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
  store double %.886.i, ptr %.548.i, align 8, !noalias !83
  %.916.i = fmul contract double %.35.i, 0x402001CC877321DD
  %.917.i = fsub contract double 0x403044E0D8B8362E, %.916.i
  %.918.i = fmul contract double %.35.i, %.917.i
  %.919.i = fsub contract double 0x400A4763546E2A71, %.918.i
  %.920.i = fmul contract double %.919.i, 0x400921FB54442D18
  %.948.i = getelementptr i8, ptr %arg.out.4, i64 56
  store double %.920.i, ptr %.948.i, align 8, !noalias !83
  %.531 = load double, ptr %arg.row.4, align 8
  %.5.i.i = fadd contract double %.531, 1.000000e+00
  %.147.i.i.i = fmul contract double %.5.i.i, %.5.i.i
  %.35.i.i = fdiv contract double %.531, %.147.i.i.i
  %.39.i = fdiv contract double 0x3FE4F1A6C638D03F, %.35.i.i
  %.47.i = tail call contract double @sqrt(double %.39.i)
  %.557 = fmul contract double %.381, %.47.i
  %.560 = fmul contract double %.211, %.211
  %.562 = fmul contract double %.211, %.560
  %.571 = tail call contract double @sqrt(double %.211)
  %.576 = fmul contract double %.562, %.571
  %.580 = fdiv contract double %.557, %.576
  store double %.580, ptr %arg.out.4, align 8
  %.765 = fmul contract double %.211, %.580
  %.732.1 = fmul contract double %.765, 0.000000e+00
  store double %.732.1, ptr %.138.i, align 8
  %.765.1 = fmul contract double %.211, %.765
  %.732.2 = fmul contract double %.141.i, %.765.1
  store double %.732.2, ptr %.169.i, align 8
  %.765.2 = fmul contract double %.211, %.765.1
  %.732.3 = fmul contract double %.175.i, %.765.2
  store double %.732.3, ptr %.203.i, align 8
  %.765.3 = fmul contract double %.211, %.765.2
  %.732.4 = fmul contract double %.362.i5, %.765.3
  store double %.732.4, ptr %.236.i, align 8
  %.765.4 = fmul contract double %.211, %.765.3
  %.732.5 = fmul contract double %.463.i, %.765.4
  store double %.732.5, ptr %.427.i, align 8
  %.765.5 = fmul contract double %.211, %.765.4
  %.732.6 = fmul contract double %.886.i, %.765.5
  store double %.732.6, ptr %.548.i, align 8
  %.765.6 = fmul contract double %.211, %.765.5
  %.732.7 = fmul contract double %.920.i, %.765.6
  store double %.732.7, ptr %.948.i, align 8
  %.804 = load double, ptr %arg.row.4, align 8
  %.834 = load double, ptr %.443, align 8
  %.864 = load double, ptr %.473, align 8
  %.893 = getelementptr i8, ptr %arg.row.4, i64 8
  %.894 = load double, ptr %.893, align 8
  %.923 = getelementptr i8, ptr %arg.row.4, i64 16
  %.924 = load double, ptr %.923, align 8
  tail call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(384) %arg.room.4, i8 0, i64 384, i1 false), !noalias !86
  %.29.i = fadd contract double %.804, 1.000000e+00
  %.33.i = fdiv contract double %.804, %.29.i
  %.38.i = fdiv contract double 1.000000e+00, %.29.i
  %.39.i6 = fmul contract double %.33.i, %.38.i
  store double 1.000000e+00, ptr %arg.room.4, align 8, !noalias !89
  %.183.i.i = getelementptr i8, ptr %arg.room.4, i64 16
  %.184.i.i = load double, ptr %.183.i.i, align 8, !noalias !89
  %.203.i.i = fmul contract double %.39.i6, 0x401871C71C71C71C
  %.204.i.i = fadd contract double %.203.i.i, 0x4013A7F529FD4A7F
  %.205.i.i = fadd contract double %.204.i.i, %.184.i.i
  store double %.205.i.i, ptr %.183.i.i, align 8, !noalias !89
  %.308.i.i = getelementptr i8, ptr %arg.room.4, i64 24
  %.309.i.i = load double, ptr %.308.i.i, align 8, !noalias !89
  %.310.i.i = fadd contract double %.309.i.i, 0xC04921FB54442D18
  store double %.310.i.i, ptr %.308.i.i, align 8, !noalias !89
  %.413.i.i = getelementptr i8, ptr %arg.room.4, i64 32
  %.414.i.i = load double, ptr %.413.i.i, align 8, !noalias !89
  %.454.i2.i = fmul contract double %.39.i6, 0x40456C71C71C71C7
  %.455.i3.i = fadd contract double %.454.i2.i, 0x404AEDF7DF7DF7DF
  %.456.i4.i = fmul contract double %.39.i6, %.455.i3.i
  %.457.i.i = fadd contract double %.456.i4.i, 0x403E1A683B5702A5
  %.458.i.i = fadd contract double %.457.i.i, %.414.i.i
  store double %.458.i.i, ptr %.413.i.i, align 8, !noalias !89
  %.561.i.i = getelementptr i8, ptr %arg.room.4, i64 168
  %.562.i.i = load double, ptr %.561.i.i, align 8, !noalias !89
  %.581.i.i = fmul contract double %.39.i6, 0x40510457810E2933
  %1 = fsub contract double 0x407E1C5F0E074C89, %.581.i.i
  %.583.i.i = fadd contract double %1, %.562.i.i
  store double %.583.i.i, ptr %.561.i.i, align 8, !noalias !89
  %.686.i.i = getelementptr i8, ptr %arg.room.4, i64 48
  %.687.i.i = load double, ptr %.686.i.i, align 8, !noalias !89
  %.756.i.i = fmul contract double %.39.i6, 0x4058A8587E6B74F0
  %2 = fsub contract double 0x404601B425ED097B, %.756.i.i
  %.758.i.i = fmul contract double %.39.i6, %2
  %.759.i.i = fadd contract double %.758.i.i, 0xC0A9D8A41ED3317E
  %.760.i.i = fmul contract double %.39.i6, %.759.i.i
  %.761.i.i = fadd contract double %.760.i.i, 0xC071640B49E85C3E
  %.762.i.i = fadd contract double %.761.i.i, %.687.i.i
  store double %.762.i.i, ptr %.686.i.i, align 8, !noalias !89
  %.865.i.i = getelementptr i8, ptr %arg.room.4, i64 176
  %.866.i.i = load double, ptr %.865.i.i, align 8, !noalias !89
  %.867.i.i = fadd contract double %.866.i.i, 0xC074618618618618
  store double %.867.i.i, ptr %.865.i.i, align 8, !noalias !89
  %.970.i.i = getelementptr i8, ptr %arg.room.4, i64 56
  %.971.i.i = load double, ptr %.970.i.i, align 8, !noalias !89
  %.1011.i.i = fmul contract double %.39.i6, 0x40733B288412FE12
  %3 = fsub contract double 0x408893BEE8443B83, %.1011.i.i
  %.1013.i.i = fmul contract double %.39.i6, %3
  %.1014.i.i = fadd contract double %.1013.i.i, 0x408DCC10DD757C0B
  %.1015.i.i = fadd contract double %.1014.i.i, %.971.i.i
  store double %.1015.i.i, ptr %.970.i.i, align 8, !noalias !89
  %.1118.i.i = getelementptr i8, ptr %arg.room.4, i64 192
  %.1119.i.i = load double, ptr %.1118.i.i, align 8, !noalias !89
  %.1225.i.i = fmul contract double %.39.i6, 0x40514C5F3B7242FB
  %.1226.i.i = fadd contract double %.1225.i.i, 0xC05D2FBB067D39F9
  %.1227.i.i = fmul contract double %.39.i6, %.1226.i.i
  %.1228.i.i = fadd contract double %.1227.i.i, 0xC091A4640F04B974
  %.1229.i.i = fmul contract double %.39.i6, %.1228.i.i
  %.1230.i.i = fadd contract double %.1229.i.i, 0x40CE3F8117DB38CA
  %.1231.i.i = fmul contract double %.39.i6, %.1230.i.i
  %.1232.i.i = fadd contract double %.1231.i.i, 0xC0A8D75E6BF57F9D
  %.1233.i.i = fadd contract double %.1232.i.i, %.1119.i.i
  store double %.1233.i.i, ptr %.1118.i.i, align 8, !noalias !89
  %.1336.i.i = getelementptr i8, ptr %arg.room.4, i64 320
  %.1337.i.i = load double, ptr %.1336.i.i, align 8, !noalias !89
  %.1356.i.i = fmul contract double %.39.i6, 0x409F6EC11CD4D97E
  %.1357.i.i = fadd contract double %.1356.i.i, 0x4072428A28A28A29
  %.1358.i.i = fadd contract double %.1357.i.i, %.1337.i.i
  store double %.1358.i.i, ptr %.1336.i.i, align 8, !noalias !89
  %.1461.i.i = getelementptr i8, ptr %arg.room.4, i64 72
  %.1462.i.i = load double, ptr %.1461.i.i, align 8, !noalias !89
  %.1531.i.i = fmul contract double %.39.i6, 0x40645019F9E83A77
  %.1532.i.i = fadd contract double %.1531.i.i, 0x40918164C0B5D6FD
  %.1533.i.i = fmul contract double %.39.i6, %.1532.i.i
  %.1534.i.i = fadd contract double %.1533.i.i, 0xC0D6C519D7F78519
  %.1535.i.i = fmul contract double %.39.i6, %.1534.i.i
  %.1536.i.i = fadd contract double %.1535.i.i, 0x40BB4B9C657BC796
  %.1537.i.i = fadd contract double %.1536.i.i, %.1462.i.i
  store double %.1537.i.i, ptr %.1461.i.i, align 8, !noalias !89
  %.1640.i.i = getelementptr i8, ptr %arg.room.4, i64 200
  %.1641.i.i = load double, ptr %.1640.i.i, align 8, !noalias !89
  %.1642.i.i = fadd contract double %.1641.i.i, 0xC0A001D567F49087
  store double %.1642.i.i, ptr %.1640.i.i, align 8, !noalias !89
  %.1810.i.i = fmul contract double %.39.i6, 0x40A619E547AE6DA3
  %.1811.i.i = fadd contract double %.1810.i.i, 0xC0D25E7665446D0F
  %.1812.i.i = fmul contract double %.39.i6, %.1811.i.i
  %.1813.i.i = fadd contract double %.1812.i.i, 0x40E19BDA5330D73F
  %.1814.i.i = fmul contract double %.39.i6, %.1813.i.i
  %.1815.i.i = fadd contract double %.1814.i.i, 0xC0E154650FD9ACF1
  %.1867.i.i = getelementptr i8, ptr %arg.room.4, i64 80
  %.1868.i.i = load double, ptr %.1867.i.i, align 8, !noalias !89
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
  store double %.1968.i.i, ptr %.1867.i.i, align 8, !noalias !89
  %.2088.i.i = fmul contract double %.39.i6, 0x40C0712C540DB5CD
  %.2089.i.i = fadd contract double %.2088.i.i, 0x40A79A477BF30A91
  %.2090.i.i = fmul contract double %.39.i6, %.2089.i.i
  %.2091.i.i = fadd contract double %.2090.i.i, 0xC0A4B055B758E414
  %.2092.i.i = fmul contract double %.39.i6, %.2091.i.i
  %.2093.i.i = fadd contract double %.2092.i.i, 0x406D67FD70A13797
  %.2145.i.i = getelementptr i8, ptr %arg.room.4, i64 208
  %.2146.i.i = load double, ptr %.2145.i.i, align 8, !noalias !89
  %.2152.i.i = fdiv contract double %.2093.i.i, %.1963.i.i
  %.2153.i.i = fadd contract double %.2152.i.i, %.2146.i.i
  store double %.2153.i.i, ptr %.2145.i.i, align 8, !noalias !89
  %.2256.i.i = getelementptr i8, ptr %arg.room.4, i64 88
  %.2257.i.i = load double, ptr %.2256.i.i, align 8, !noalias !89
  %.2363.i.i = fmul contract double %.39.i6, 0x402CA90C106318D7
  %.2364.i.i = fadd contract double %.2363.i.i, 0xC06030460C29F3DF
  %.2365.i.i = fmul contract double %.39.i6, %.2364.i.i
  %.2366.i.i = fadd contract double %.2365.i.i, 0x40D015D04F4BC5D2
  %.2367.i.i = fmul contract double %.39.i6, %.2366.i.i
  %.2368.i.i = fadd contract double %.2367.i.i, 0xC0E536054A2E10AB
  %.2369.i.i = fmul contract double %.39.i6, %.2368.i.i
  %.2370.i.i = fadd contract double %.2369.i.i, 0x40C95DBCC2240A74
  %.2371.i.i = fadd contract double %.2370.i.i, %.2257.i.i
  store double %.2371.i.i, ptr %.2256.i.i, align 8, !noalias !89
  %.2474.i.i = getelementptr i8, ptr %arg.room.4, i64 216
  %.2475.i.i = load double, ptr %.2474.i.i, align 8, !noalias !89
  %.2494.i.i = fmul contract double %.39.i6, 0x40BD257CD0AE1310
  %4 = fsub contract double 0xC09600901EF7C9A4, %.2494.i.i
  %.2496.i.i = fadd contract double %4, %.2475.i.i
  store double %.2496.i.i, ptr %.2474.i.i, align 8, !noalias !89
  %.24.i.i = fsub contract double 1.000000e+00, %.33.i
  %.25.i.i = fmul contract double %.33.i, %.24.i.i
  %.26.i.i = fmul contract double %.834, %.33.i
  %.80.i.i = fmul contract double %.33.i, 0x4029555555555555
  %.81.i.i = fadd contract double %.80.i.i, 2.500000e+01
  %.82.i.i = fmul contract double %.26.i.i, %.81.i.i
  %.83.i.i = fadd contract double %.82.i.i, %.310.i.i
  store double %.83.i.i, ptr %.308.i.i, align 8, !noalias !92
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
  store double %6, ptr %.561.i.i, align 8, !noalias !92
  %.301.i.i = fmul contract double %.26.i.i, 0x400921FB54442D18
  %.302.i.i = fmul contract double %.33.i, 2.600000e+02
  %.303.i.i = fadd contract double %.302.i.i, 0x407F0AAAAAAAAAAB
  %.304.i.i = fmul contract double %.303.i.i, %.301.i.i
  %.305.i.i = fadd contract double %.304.i.i, %.762.i.i
  store double %.305.i.i, ptr %.686.i.i, align 8, !noalias !92
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
  store double %.424.i.i, ptr %.970.i.i, align 8, !noalias !92
  %.24.i7.i = fsub contract double 1.000000e+00, %.38.i
  %.25.i8.i = fmul contract double %.38.i, %.24.i7.i
  %.26.i9.i = fmul contract double %.38.i, %.864
  %.80.i12.i = fmul contract double %.38.i, 0x4029555555555555
  %.81.i13.i = fadd contract double %.80.i12.i, 2.500000e+01
  %.82.i14.i = fmul contract double %.26.i9.i, %.81.i13.i
  %.83.i15.i = fadd contract double %.82.i14.i, %.83.i.i
  store double %.83.i15.i, ptr %.308.i.i, align 8, !noalias !95
  %.188.i18.i = fmul contract double %.26.i9.i, 3.000000e+00
  %.189.i19.i = fmul contract double %.25.i8.i, 0x400AAAAAAAAAAAAB
  %.190.i20.i = fsub contract double 0x4064B4F3CF3CF3CF, %.189.i19.i
  %.191.i21.i = fmul contract double %.25.i8.i, 0x4032E38E38E38E39
  %.192.i22.i = fadd contract double %.191.i21.i, 0x4063B0FCD6E9E065
  %.193.i23.i = fmul contract double %.38.i, %.192.i22.i
  %.194.i24.i = fadd contract double %.190.i20.i, %.193.i23.i
  %.195.i25.i = fmul contract double %.188.i18.i, %.194.i24.i
  %7 = fsub contract double %6, %.195.i25.i
  store double %7, ptr %.561.i.i, align 8, !noalias !95
  %.301.i28.i = fmul contract double %.26.i9.i, 0x400921FB54442D18
  %.302.i29.i = fmul contract double %.38.i, 2.600000e+02
  %.303.i30.i = fadd contract double %.302.i29.i, 0x407F0AAAAAAAAAAB
  %.304.i31.i = fmul contract double %.303.i30.i, %.301.i28.i
  %.305.i32.i = fadd contract double %.304.i31.i, %.305.i.i
  store double %.305.i32.i, ptr %.686.i.i, align 8, !noalias !95
  %.357.i33.i = fmul contract double %.25.i8.i, 0x4020F1C71C71C71C
  %.358.i34.i = fsub contract double 0x40C10436B015AC05, %.357.i33.i
  %.359.i35.i = fmul contract double %.25.i8.i, %.358.i34.i
  %.360.i36.i = fadd contract double %.359.i35.i, 0xC0C7044BD0923320
  %.361.i37.i = fmul contract double %.25.i8.i, 0x404070E38E38E38E
  %.362.i38.i = fadd contract double %.361.i37.i, 0x40B0B864F3CF3CF4
  %.363.i39.i = fmul contract double %.25.i8.i, %.362.i38.i
  %.364.i40.i = fsub contract double 0x40AB9B8B602B580B, %.363.i39.i
  %.418.i43.i = fmul contract double %.38.i, %.360.i36.i
  %.419.i44.i = fmul contract double %.38.i, 2.000000e+00
  %.420.i45.i = fadd contract double %.419.i44.i, -1.000000e+00
  %.421.i46.i = fmul contract double %.420.i45.i, %.364.i40.i
  %.422.i47.i = fadd contract double %.418.i43.i, %.421.i46.i
  %.423.i48.i = fmul contract double %.26.i9.i, %.422.i47.i
  %.424.i49.i = fadd contract double %.423.i48.i, %.424.i.i
  store double %.424.i49.i, ptr %.970.i.i, align 8, !noalias !95
  %.15.le.i.i = fcmp contract uno double %.894, 0.000000e+00
  %.17.le.i.i = fcmp contract oge double %.894, 1.000000e+00
  %8 = or i1 %.15.le.i.i, %.17.le.i.i
  %9 = tail call contract double @llvm.log.f64(double %.894)
  %.31.le.i.i = select i1 %8, double %9, double 0.000000e+00
  %.36.i.i = fmul contract double %.31.le.i.i, 1.230000e-04
  %.37.i.i = fadd contract double %.36.i.i, -4.210000e-03
  %.38.i.i = fmul contract double %.31.le.i.i, %.37.i.i
  %.39.i.i = fadd contract double %.38.i.i, 4.740000e-02
  %.40.i.i = fmul contract double %.31.le.i.i, %.39.i.i
  %.41.i.i = fadd contract double %.40.i.i, 9.360000e-02
  %.42.i.i = fmul contract double %.31.le.i.i, %.41.i.i
  %.43.i.i = fadd contract double %.42.i.i, 1.940000e-01
  %.44.i.i = fcmp contract ogt double %.894, 1.000000e+00
  %.46.i.i = uitofp i1 %.44.i.i to double
  %.47.i.i = fmul contract double %.43.i.i, %.46.i.i
  %.55.le.i.i = tail call contract double @llvm.exp.f64(double %.47.i.i)
  %.147.i.i.i7 = fmul contract double %.26.i.i, %.26.i.i
  %.106.i.i = fmul contract double %.55.le.i.i, 5.000000e+01
  %.107.i.i = fadd contract double %.106.i.i, 6.250000e-01
  %10 = fmul contract double %.147.i.i.i7, %.107.i.i
  %.109.i.i = fsub contract double %.458.i.i, %10
  store double %.109.i.i, ptr %.413.i.i, align 8, !noalias !98
  %.214.i.i = fmul contract double %.33.i, 1.200000e+02
  %.215.i.i = fsub contract double 0x407E92AAAAAAAAAB, %.214.i.i
  %.216.i.i = fmul contract double %.33.i, %.215.i.i
  %.217.i.i = fadd contract double %.216.i.i, 0x40817F8618618618
  %.218.i.i = fmul contract double %.217.i.i, %.55.le.i.i
  %.219.i.i = fmul contract double %.33.i, 0x40416E38E38E38E4
  %.220.i.i = fsub contract double 0x40569AAAAAAAAAAB, %.219.i.i
  %.221.i.i = fmul contract double %.33.i, %.220.i.i
  %.222.i.i = fadd contract double %.221.i.i, 0x40831AC618618618
  %.223.i.i = fsub contract double %.218.i.i, %.222.i.i
  %.224.i.i = fmul contract double %.147.i.i.i7, %.223.i.i
  %.225.i.i = fadd contract double %.305.i32.i, %.224.i.i
  store double %.225.i.i, ptr %.686.i.i, align 8, !noalias !98
  %.331.i.i = fmul contract double %.147.i.i.i7, 0x4093A28C59D5433B
  %.332.i.i = fmul contract double %.331.i.i, %.55.le.i.i
  %11 = fsub contract double %.424.i49.i, %.332.i.i
  store double %11, ptr %.970.i.i, align 8, !noalias !98
  %.15.le.i51.i = fcmp contract uno double %.924, 0.000000e+00
  %.17.le.i52.i = fcmp contract oge double %.924, 1.000000e+00
  %12 = or i1 %.15.le.i51.i, %.17.le.i52.i
  %13 = tail call contract double @llvm.log.f64(double %.924)
  %.31.le.i53.i = select i1 %12, double %13, double 0.000000e+00
  %.36.i54.i = fmul contract double %.31.le.i53.i, 1.230000e-04
  %.37.i55.i = fadd contract double %.36.i54.i, -4.210000e-03
  %.38.i56.i = fmul contract double %.31.le.i53.i, %.37.i55.i
  %.39.i57.i = fadd contract double %.38.i56.i, 4.740000e-02
  %.40.i58.i = fmul contract double %.31.le.i53.i, %.39.i57.i
  %.41.i59.i = fadd contract double %.40.i58.i, 9.360000e-02
  %.42.i60.i = fmul contract double %.31.le.i53.i, %.41.i59.i
  %.43.i61.i = fadd contract double %.42.i60.i, 1.940000e-01
  %.44.i62.i = fcmp contract ogt double %.924, 1.000000e+00
  %.46.i63.i = uitofp i1 %.44.i62.i to double
  %.47.i64.i = fmul contract double %.43.i61.i, %.46.i63.i
  %.55.le.i65.i = tail call contract double @llvm.exp.f64(double %.47.i64.i)
  %.147.i.i67.i = fmul contract double %.26.i9.i, %.26.i9.i
  %.106.i70.i = fmul contract double %.55.le.i65.i, 5.000000e+01
  %.107.i71.i = fadd contract double %.106.i70.i, 6.250000e-01
  %14 = fmul contract double %.147.i.i67.i, %.107.i71.i
  %.109.i72.i = fsub contract double %.109.i.i, %14
  store double %.109.i72.i, ptr %.413.i.i, align 8, !noalias !101
  %.214.i75.i = fmul contract double %.38.i, 1.200000e+02
  %.215.i76.i = fsub contract double 0x407E92AAAAAAAAAB, %.214.i75.i
  %.216.i77.i = fmul contract double %.38.i, %.215.i76.i
  %.217.i78.i = fadd contract double %.216.i77.i, 0x40817F8618618618
  %.218.i79.i = fmul contract double %.217.i78.i, %.55.le.i65.i
  %.219.i80.i = fmul contract double %.38.i, 0x40416E38E38E38E4
  %.220.i81.i = fsub contract double 0x40569AAAAAAAAAAB, %.219.i80.i
  %.221.i82.i = fmul contract double %.38.i, %.220.i81.i
  %.222.i83.i = fadd contract double %.221.i82.i, 0x40831AC618618618
  %.223.i84.i = fsub contract double %.218.i79.i, %.222.i83.i
  %.224.i85.i = fmul contract double %.147.i.i67.i, %.223.i84.i
  %.225.i86.i = fadd contract double %.224.i85.i, %.225.i.i
  store double %.225.i86.i, ptr %.686.i.i, align 8, !noalias !101
  %.331.i89.i = fmul contract double %.147.i.i67.i, 0x4093A28C59D5433B
  %.332.i90.i = fmul contract double %.331.i89.i, %.55.le.i65.i
  %15 = fsub contract double %11, %.332.i90.i
  store double %15, ptr %.970.i.i, align 8, !noalias !101
  %.27.i.i = fmul contract double %.834, %.25.i.i
  %.28.i.i = fmul contract double %.864, %.27.i.i
  %.82.i95.i = fmul contract double %.28.i.i, 9.875000e+01
  %16 = fsub contract double %.109.i72.i, %.82.i95.i
  store double %16, ptr %.413.i.i, align 8, !noalias !104
  %.188.i98.i = fmul contract double %.25.i.i, 0x40735B8E38E38E39
  %.189.i99.i = fadd contract double %.188.i98.i, 0x40723BDB6DB6DB6E
  %.190.i100.i = fmul contract double %.28.i.i, %.189.i99.i
  %.191.i101.i = fadd contract double %.190.i100.i, %.225.i86.i
  store double %.191.i101.i, ptr %.686.i.i, align 8, !noalias !104
  %.245.i.i = fmul contract double %.864, %.24.i.i
  %.246.i.i = fsub contract double %.26.i.i, %.245.i.i
  %.147.i.i103.i = fmul contract double %.246.i.i, %.246.i.i
  %.301.i104.i = fmul contract double %.28.i.i, 8.000000e+02
  %.328.i105.i = fmul contract double %.147.i.i103.i, 7.500000e+00
  %.329.i106.i = fadd contract double %.301.i104.i, %.328.i105.i
  %.330.i.i = fmul contract double %.329.i106.i, 0x400921FB54442D18
  %17 = fsub contract double %15, %.330.i.i
  store double %17, ptr %.970.i.i, align 8, !noalias !104
  %.147.i.i107.i = fmul contract double %.33.i, %.33.i
  %.147.i.1.i.i = fmul contract double %.147.i.i107.i, %.147.i.i107.i
  %.50.i.i = fmul contract double %.147.i.1.i.i, -2.400000e+01
  %.51.i.i = fmul contract double %.894, %.50.i.i
  %.105.i.i = fmul contract double %.33.i, 1.100000e+01
  %.106.i110.i = fsub contract double 1.200000e+01, %.105.i.i
  %.107.i111.i = fmul contract double %.106.i110.i, %.51.i.i
  %.108.i.i = fadd contract double %.107.i111.i, %.1968.i.i
  store double %.108.i.i, ptr %.1867.i.i, align 8, !noalias !107
  %.211.i.i = getelementptr i8, ptr %arg.room.4, i64 96
  %.212.i112.i = load double, ptr %.211.i.i, align 8, !noalias !107
  %.213.i113.i = fmul contract double %.51.i.i, 5.000000e+00
  %.217.i114.i = fdiv contract double %.213.i113.i, 6.720000e+02
  %.219.i116.i = fsub contract double 2.286000e+03, %.302.i.i
  %.220.i117.i = fmul contract double %.33.i, %.219.i116.i
  %.221.i118.i = fadd contract double %.220.i117.i, 9.190000e+02
  %.222.i119.i = fmul contract double %.33.i, %.221.i118.i
  %.223.i120.i = fsub contract double 3.179000e+03, %.222.i119.i
  %.224.i121.i = fmul contract double %.223.i120.i, %.217.i114.i
  %.225.i122.i = fadd contract double %.224.i121.i, %.212.i112.i
  store double %.225.i122.i, ptr %.211.i.i, align 8, !noalias !107
  %.328.i123.i = getelementptr i8, ptr %arg.room.4, i64 104
  %.329.i124.i = load double, ptr %.328.i123.i, align 8, !noalias !107
  %.331.i125.i = fmul contract double %.51.i.i, 0xC00921FB54442D18
  %.334.i.i = fmul contract double %.106.i110.i, %.331.i125.i
  %.335.i.i = fadd contract double %.334.i.i, %.329.i124.i
  store double %.335.i.i, ptr %.328.i123.i, align 8, !noalias !107
  %.387.i.i = fmul contract double %.33.i, 0x4151712000000000
  %.388.i.i = fsub contract double 0x41737B1700000000, %.387.i.i
  %.389.i.i = fmul contract double %.33.i, %.388.i.i
  %.390.i.i = fsub contract double 0x41A2E151D8000000, %.389.i.i
  %.442.i.i = getelementptr i8, ptr %arg.room.4, i64 112
  %.443.i.i = load double, ptr %.442.i.i, align 8, !noalias !107
  %.448.i.i = fdiv contract double %.213.i113.i, 0x417A29B000000000
  %.449.i.i = fmul contract double %.33.i, %.390.i.i
  %.450.i.i = fadd contract double %.449.i.i, 0x41A4DB86E0000000
  %.451.i.i = fmul contract double %.33.i, %.450.i.i
  %.452.i.i = fadd contract double %.451.i.i, 0x41849F27B8000000
  %.453.i.i = fmul contract double %.33.i, %.452.i.i
  %.454.i.i = fsub contract double 0x41B72002EE000000, %.453.i.i
  %.455.i.i = fmul contract double %.448.i.i, %.454.i.i
  %.456.i.i = fadd contract double %.455.i.i, %.443.i.i
  store double %.456.i.i, ptr %.442.i.i, align 8, !noalias !107
  %.559.i.i = getelementptr i8, ptr %arg.room.4, i64 120
  %.560.i.i = load double, ptr %.559.i.i, align 8, !noalias !107
  %.566.i.i = fdiv contract double %.331.i125.i, 6.720000e+02
  %.567.i.i = fmul contract double %.33.i, 1.052000e+04
  %.568.i.i = fsub contract double 7.598000e+03, %.567.i.i
  %.569.i.i = fmul contract double %.33.i, %.568.i.i
  %.570.i.i = fsub contract double 2.241500e+04, %.569.i.i
  %.571.i.i = fmul contract double %.33.i, %.570.i.i
  %.572.i.i = fsub contract double 2.771900e+04, %.571.i.i
  %.573.i.i = fmul contract double %.572.i.i, %.566.i.i
  %.574.i.i = fadd contract double %.573.i.i, %.560.i.i
  store double %.574.i.i, ptr %.559.i.i, align 8, !noalias !107
  %.147.i.i126.i = fmul contract double %.38.i, %.38.i
  %.147.i.1.i127.i = fmul contract double %.147.i.i126.i, %.147.i.i126.i
  %.50.i128.i = fmul contract double %.147.i.1.i127.i, -2.400000e+01
  %.51.i129.i = fmul contract double %.924, %.50.i128.i
  %.105.i132.i = fmul contract double %.38.i, 1.100000e+01
  %.106.i133.i = fsub contract double 1.200000e+01, %.105.i132.i
  %.107.i134.i = fmul contract double %.106.i133.i, %.51.i129.i
  %.108.i135.i = fadd contract double %.107.i134.i, %.108.i.i
  store double %.108.i135.i, ptr %.1867.i.i, align 8, !noalias !110
  %.213.i138.i = fmul contract double %.51.i129.i, 5.000000e+00
  %.217.i139.i = fdiv contract double %.213.i138.i, 6.720000e+02
  %.219.i141.i = fsub contract double 2.286000e+03, %.302.i29.i
  %.220.i142.i = fmul contract double %.38.i, %.219.i141.i
  %.221.i143.i = fadd contract double %.220.i142.i, 9.190000e+02
  %.222.i144.i = fmul contract double %.38.i, %.221.i143.i
  %.223.i145.i = fsub contract double 3.179000e+03, %.222.i144.i
  %.224.i146.i = fmul contract double %.223.i145.i, %.217.i139.i
  %.225.i147.i = fadd contract double %.224.i146.i, %.225.i122.i
  store double %.225.i147.i, ptr %.211.i.i, align 8, !noalias !110
  %.331.i150.i = fmul contract double %.51.i129.i, 0xC00921FB54442D18
  %.334.i151.i = fmul contract double %.106.i133.i, %.331.i150.i
  %.335.i152.i = fadd contract double %.334.i151.i, %.335.i.i
  store double %.335.i152.i, ptr %.328.i123.i, align 8, !noalias !110
  %.387.i153.i = fmul contract double %.38.i, 0x4151712000000000
  %.388.i154.i = fsub contract double 0x41737B1700000000, %.387.i153.i
  %.389.i155.i = fmul contract double %.38.i, %.388.i154.i
  %.390.i156.i = fsub contract double 0x41A2E151D8000000, %.389.i155.i
  %.448.i159.i = fdiv contract double %.213.i138.i, 0x417A29B000000000
  %.449.i160.i = fmul contract double %.38.i, %.390.i156.i
  %.450.i161.i = fadd contract double %.449.i160.i, 0x41A4DB86E0000000
  %.451.i162.i = fmul contract double %.38.i, %.450.i161.i
  %.452.i163.i = fadd contract double %.451.i162.i, 0x41849F27B8000000
  %.453.i164.i = fmul contract double %.38.i, %.452.i163.i
  %.454.i165.i = fsub contract double 0x41B72002EE000000, %.453.i164.i
  %.455.i166.i = fmul contract double %.448.i159.i, %.454.i165.i
  %.456.i167.i = fadd contract double %.455.i166.i, %.456.i.i
  store double %.456.i167.i, ptr %.442.i.i, align 8, !noalias !110
  %.566.i170.i = fdiv contract double %.331.i150.i, 6.720000e+02
  %.567.i171.i = fmul contract double %.38.i, 1.052000e+04
  %.568.i172.i = fsub contract double 7.598000e+03, %.567.i171.i
  %.569.i173.i = fmul contract double %.38.i, %.568.i172.i
  %.570.i174.i = fsub contract double 2.241500e+04, %.569.i173.i
  %.571.i175.i = fmul contract double %.38.i, %.570.i174.i
  %.572.i176.i = fsub contract double 2.771900e+04, %.571.i175.i
  %.573.i177.i = fmul contract double %.572.i176.i, %.566.i170.i
  %.574.i178.i = fadd contract double %.573.i177.i, %.574.i.i
  store double %.574.i178.i, ptr %.559.i.i, align 8, !noalias !110
  %.671.i8 = fmul contract double %.39.i6, 1.280000e+02
  %.675.i = fdiv contract double 3.000000e+00, %.671.i8
  store double %.675.i, ptr %arg.room.4, align 8, !noalias !86
  %18 = getelementptr i8, ptr %arg.room.4, i64 8
  %.968.1.i = load double, ptr %18, align 8, !noalias !86
  %.970.1.i = fmul contract double %.675.i, %.968.1.i
  store double %.970.1.i, ptr %18, align 8, !noalias !86
  %.970.2.i = fmul contract double %.675.i, %.205.i.i
  store double %.970.2.i, ptr %.183.i.i, align 8, !noalias !86
  %.970.3.i = fmul contract double %.675.i, %.83.i15.i
  store double %.970.3.i, ptr %.308.i.i, align 8, !noalias !86
  %.970.4.i = fmul contract double %.675.i, %16
  store double %.970.4.i, ptr %.413.i.i, align 8, !noalias !86
  %19 = getelementptr i8, ptr %arg.room.4, i64 40
  %.968.5.i = load double, ptr %19, align 8, !noalias !86
  %.970.5.i = fmul contract double %.675.i, %.968.5.i
  store double %.970.5.i, ptr %19, align 8, !noalias !86
  %.970.6.i = fmul contract double %.675.i, %.191.i101.i
  store double %.970.6.i, ptr %.686.i.i, align 8, !noalias !86
  %.970.7.i = fmul contract double %.675.i, %17
  store double %.970.7.i, ptr %.970.i.i, align 8, !noalias !86
  %20 = getelementptr i8, ptr %arg.room.4, i64 64
  %.968.8.i = load double, ptr %20, align 8, !noalias !86
  %.970.8.i = fmul contract double %.675.i, %.968.8.i
  store double %.970.8.i, ptr %20, align 8, !noalias !86
  %.970.9.i = fmul contract double %.675.i, %.1537.i.i
  store double %.970.9.i, ptr %.1461.i.i, align 8, !noalias !86
  %.970.10.i = fmul contract double %.675.i, %.108.i135.i
  store double %.970.10.i, ptr %.1867.i.i, align 8, !noalias !86
  %.970.11.i = fmul contract double %.675.i, %.2371.i.i
  store double %.970.11.i, ptr %.2256.i.i, align 8, !noalias !86
  %.970.12.i = fmul contract double %.675.i, %.225.i147.i
  store double %.970.12.i, ptr %.211.i.i, align 8, !noalias !86
  %.970.13.i = fmul contract double %.675.i, %.335.i152.i
  store double %.970.13.i, ptr %.328.i123.i, align 8, !noalias !86
  %.970.14.i = fmul contract double %.675.i, %.456.i167.i
  store double %.970.14.i, ptr %.442.i.i, align 8, !noalias !86
  %.970.15.i = fmul contract double %.675.i, %.574.i178.i
  store double %.970.15.i, ptr %.559.i.i, align 8, !noalias !86
  %.968.1276.i = load double, ptr %5, align 8, !noalias !86
  %.970.1277.i = fmul contract double %.675.i, %.968.1276.i
  store double %.970.1277.i, ptr %5, align 8, !noalias !86
  %21 = getelementptr i8, ptr %arg.room.4, i64 136
  %.968.1.1.i = load double, ptr %21, align 8, !noalias !86
  %.970.1.1.i = fmul contract double %.675.i, %.968.1.1.i
  store double %.970.1.1.i, ptr %21, align 8, !noalias !86
  %22 = getelementptr i8, ptr %arg.room.4, i64 144
  %.968.2.1.i = load double, ptr %22, align 8, !noalias !86
  %.970.2.1.i = fmul contract double %.675.i, %.968.2.1.i
  store double %.970.2.1.i, ptr %22, align 8, !noalias !86
  %23 = getelementptr i8, ptr %arg.room.4, i64 152
  %.968.3.1.i = load double, ptr %23, align 8, !noalias !86
  %.970.3.1.i = fmul contract double %.675.i, %.968.3.1.i
  store double %.970.3.1.i, ptr %23, align 8, !noalias !86
  %24 = getelementptr i8, ptr %arg.room.4, i64 160
  %.968.4.1.i = load double, ptr %24, align 8, !noalias !86
  %.970.4.1.i = fmul contract double %.675.i, %.968.4.1.i
  store double %.970.4.1.i, ptr %24, align 8, !noalias !86
  %.970.5.1.i = fmul contract double %.675.i, %7
  store double %.970.5.1.i, ptr %.561.i.i, align 8, !noalias !86
  %.970.6.1.i = fmul contract double %.675.i, %.867.i.i
  store double %.970.6.1.i, ptr %.865.i.i, align 8, !noalias !86
  %25 = getelementptr i8, ptr %arg.room.4, i64 184
  %.968.7.1.i = load double, ptr %25, align 8, !noalias !86
  %.970.7.1.i = fmul contract double %.675.i, %.968.7.1.i
  store double %.970.7.1.i, ptr %25, align 8, !noalias !86
  %.970.8.1.i = fmul contract double %.675.i, %.1233.i.i
  store double %.970.8.1.i, ptr %.1118.i.i, align 8, !noalias !86
  %.970.9.1.i = fmul contract double %.675.i, %.1642.i.i
  store double %.970.9.1.i, ptr %.1640.i.i, align 8, !noalias !86
  %.970.10.1.i = fmul contract double %.675.i, %.2153.i.i
  store double %.970.10.1.i, ptr %.2145.i.i, align 8, !noalias !86
  %.970.11.1.i = fmul contract double %.675.i, %.2496.i.i
  store double %.970.11.1.i, ptr %.2474.i.i, align 8, !noalias !86
  %26 = getelementptr i8, ptr %arg.room.4, i64 224
  %.968.12.1.i = load double, ptr %26, align 8, !noalias !86
  %.970.12.1.i = fmul contract double %.675.i, %.968.12.1.i
  store double %.970.12.1.i, ptr %26, align 8, !noalias !86
  %27 = getelementptr i8, ptr %arg.room.4, i64 232
  %.968.13.1.i = load double, ptr %27, align 8, !noalias !86
  %.970.13.1.i = fmul contract double %.675.i, %.968.13.1.i
  store double %.970.13.1.i, ptr %27, align 8, !noalias !86
  %28 = getelementptr i8, ptr %arg.room.4, i64 240
  %.968.14.1.i = load double, ptr %28, align 8, !noalias !86
  %.970.14.1.i = fmul contract double %.675.i, %.968.14.1.i
  store double %.970.14.1.i, ptr %28, align 8, !noalias !86
  %29 = getelementptr i8, ptr %arg.room.4, i64 248
  %.968.15.1.i = load double, ptr %29, align 8, !noalias !86
  %.970.15.1.i = fmul contract double %.675.i, %.968.15.1.i
  store double %.970.15.1.i, ptr %29, align 8, !noalias !86
  %30 = getelementptr i8, ptr %arg.room.4, i64 256
  %.968.2278.i = load double, ptr %30, align 8, !noalias !86
  %.970.2279.i = fmul contract double %.675.i, %.968.2278.i
  store double %.970.2279.i, ptr %30, align 8, !noalias !86
  %31 = getelementptr i8, ptr %arg.room.4, i64 264
  %.968.1.2.i = load double, ptr %31, align 8, !noalias !86
  %.970.1.2.i = fmul contract double %.675.i, %.968.1.2.i
  store double %.970.1.2.i, ptr %31, align 8, !noalias !86
  %32 = getelementptr i8, ptr %arg.room.4, i64 272
  %.968.2.2.i = load double, ptr %32, align 8, !noalias !86
  %.970.2.2.i = fmul contract double %.675.i, %.968.2.2.i
  store double %.970.2.2.i, ptr %32, align 8, !noalias !86
  %33 = getelementptr i8, ptr %arg.room.4, i64 280
  %.968.3.2.i = load double, ptr %33, align 8, !noalias !86
  %.970.3.2.i = fmul contract double %.675.i, %.968.3.2.i
  store double %.970.3.2.i, ptr %33, align 8, !noalias !86
  %34 = getelementptr i8, ptr %arg.room.4, i64 288
  %.968.4.2.i = load double, ptr %34, align 8, !noalias !86
  %.970.4.2.i = fmul contract double %.675.i, %.968.4.2.i
  store double %.970.4.2.i, ptr %34, align 8, !noalias !86
  %35 = getelementptr i8, ptr %arg.room.4, i64 296
  %.968.5.2.i = load double, ptr %35, align 8, !noalias !86
  %.970.5.2.i = fmul contract double %.675.i, %.968.5.2.i
  store double %.970.5.2.i, ptr %35, align 8, !noalias !86
  %36 = getelementptr i8, ptr %arg.room.4, i64 304
  %.968.6.2.i = load double, ptr %36, align 8, !noalias !86
  %.970.6.2.i = fmul contract double %.675.i, %.968.6.2.i
  store double %.970.6.2.i, ptr %36, align 8, !noalias !86
  %37 = getelementptr i8, ptr %arg.room.4, i64 312
  %.968.7.2.i = load double, ptr %37, align 8, !noalias !86
  %.970.7.2.i = fmul contract double %.675.i, %.968.7.2.i
  store double %.970.7.2.i, ptr %37, align 8, !noalias !86
  %.970.8.2.i = fmul contract double %.675.i, %.1358.i.i
  store double %.970.8.2.i, ptr %.1336.i.i, align 8, !noalias !86
  %38 = getelementptr i8, ptr %arg.room.4, i64 328
  %.968.9.2.i = load double, ptr %38, align 8, !noalias !86
  %.970.9.2.i = fmul contract double %.675.i, %.968.9.2.i
  store double %.970.9.2.i, ptr %38, align 8, !noalias !86
  %39 = getelementptr i8, ptr %arg.room.4, i64 336
  %.968.10.2.i = load double, ptr %39, align 8, !noalias !86
  %.970.10.2.i = fmul contract double %.675.i, %.968.10.2.i
  store double %.970.10.2.i, ptr %39, align 8, !noalias !86
  %40 = getelementptr i8, ptr %arg.room.4, i64 344
  %.968.11.2.i = load double, ptr %40, align 8, !noalias !86
  %.970.11.2.i = fmul contract double %.675.i, %.968.11.2.i
  store double %.970.11.2.i, ptr %40, align 8, !noalias !86
  %41 = getelementptr i8, ptr %arg.room.4, i64 352
  %.968.12.2.i = load double, ptr %41, align 8, !noalias !86
  %.970.12.2.i = fmul contract double %.675.i, %.968.12.2.i
  store double %.970.12.2.i, ptr %41, align 8, !noalias !86
  %42 = getelementptr i8, ptr %arg.room.4, i64 360
  %.968.13.2.i = load double, ptr %42, align 8, !noalias !86
  %.970.13.2.i = fmul contract double %.675.i, %.968.13.2.i
  store double %.970.13.2.i, ptr %42, align 8, !noalias !86
  %43 = getelementptr i8, ptr %arg.room.4, i64 368
  %.968.14.2.i = load double, ptr %43, align 8, !noalias !86
  %.970.14.2.i = fmul contract double %.675.i, %.968.14.2.i
  store double %.970.14.2.i, ptr %43, align 8, !noalias !86
  %44 = getelementptr i8, ptr %arg.room.4, i64 376
  %.968.15.2.i = load double, ptr %44, align 8, !noalias !86
  %.970.15.2.i = fmul contract double %.675.i, %.968.15.2.i
  store double %.970.15.2.i, ptr %44, align 8, !noalias !86
  %.1093 = getelementptr i8, ptr %arg.out.4, i64 64
  %.1326 = fmul contract double %.211, %.562
  %.1328 = fmul contract double %.211, %.1326
  %.1332 = fdiv contract double 1.000000e+00, %.1328
  %.1728 = fmul contract double %.223.le, 2.000000e+00
  br label %B1080.if

B1198:                                            ; preds = %B1080.if
  %.1726 = load double, ptr %sunkaddr44, align 8
  %.1783 = load double, ptr %sunkaddr47, align 8
  %.1784 = fmul contract double %.1728, %.1783
  %.1785 = fadd contract double %.1726, %.1784
  %.1787 = fmul contract double %power.1.2.0806, %.1785
  %.1791 = fdiv contract double %.1787, 3.000000e+00
  %sunkaddr25 = getelementptr i8, ptr %arg.out.4, i64 %sunkaddr40
  %sunkaddr26 = getelementptr i8, ptr %sunkaddr25, i64 152
  store double %.1791, ptr %sunkaddr26, align 8
  br label %B1282

B1282:                                            ; preds = %B1080.if, %B1198
  %.1836 = fmul contract double %.211, %power.1.2.0806
  %exitcond.not = icmp eq i64 %.1428, 16
  br i1 %exitcond.not, label %B1294, label %B1080.if

B1294:                                            ; preds = %B1282
  %.111 = fmul contract double %.110, 0x3ED4A8B4A9ED04E3
  %.1910 = load double, ptr %.1336.i.i, align 8
  %.1911 = fmul contract double %.210, %.1910
  %.1915 = fdiv contract double %.1911, 9.000000e+00
  %sunkaddr22 = getelementptr i8, ptr %arg.out.4, i64 248
  store double %.1915, ptr %sunkaddr22, align 8
  %.1974 = getelementptr i8, ptr %arg.row.4, i64 64
  %.1975 = load double, ptr %.1974, align 8
  %45 = lshr i64 %arg.alignment, 61
  %.1992 = and i64 %45, 4
  %.idx = shl i64 %arg.alignment, 4
  %46 = getelementptr i8, ptr %arg.gauge.4, i64 %.idx
  %.2006 = getelementptr double, ptr %46, i64 %.1992
  %.2007 = load double, ptr %.2006, align 8
  %.2008 = fsub contract double %.1975, %.2007
  %sunkaddr24 = getelementptr i8, ptr %arg.out.4, i64 256
  store double %.2008, ptr %sunkaddr24, align 8
  %.2056 = icmp slt i64 %arg.band_at, -2
  %.2057 = select i1 %.2056, i64 1073741824, i64 0
  %47 = getelementptr double, ptr %arg.weights.4, i64 %arg.band_at
  %48 = getelementptr i8, ptr %47, i64 16
  %.2071 = getelementptr double, ptr %48, i64 %.2057
  %.2072 = load double, ptr %.2071, align 8
  %.2082 = icmp eq i64 %arg.alignment, 1
  %.2085 = fcmp contract ogt double %.2072, 0.000000e+00
  %or.cond = select i1 %.2082, i1 %.2085, i1 false
  br i1 %or.cond, label %B1466, label %B1526

B1466:                                            ; preds = %B1294
  %.25.i = fmul contract double %.2072, 0x400921FB54442D18
  %.26.i = tail call contract double @llvm.pow.f64(double %.25.i, double 0x3FD5555555555555)
  %.147.i.i = fmul contract double %.26.i, %.26.i
  %.147.i.1.i = fmul contract double %.147.i.i, %.147.i.i
  %.127.i.2.i = fmul contract double %.26.i, %.147.i.1.i
  %.38.le.i = tail call contract double @llvm.log.f64(double %.26.i)
  %.168.i.i = fcmp une double %.127.i.2.i, 0.000000e+00
  br i1 %.168.i.i, label %B134.if.lr.ph.i, label %_ZN17bnserve_surrogate6kernel7_series9_legendreB4v131B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dEd5ArrayIdLi2E1C7mutable7alignedE.exit, !prof !0

B134.if.lr.ph.i:                                  ; preds = %B1466
  %.175.i.i = fdiv contract double 1.000000e+00, %.127.i.2.i
  %.423.i = fmul contract double %.38.le.i, 2.000000e+00
  br label %B134.if.i

B134.if.i:                                        ; preds = %B134.if.i, %B134.if.lr.ph.i
  %lsr.iv = phi i64 [ %math, %B134.if.i ], [ -16, %B134.if.lr.ph.i ]
  %power.2.0146.i = phi double [ %.493.i, %B134.if.i ], [ %.175.i.i, %B134.if.lr.ph.i ]
  %result.2.0145.i = phi double [ %.488.i, %B134.if.i ], [ 0.000000e+00, %B134.if.lr.ph.i ]
  %49 = add nsw i64 %lsr.iv, 11
  %sunkaddr28 = shl i64 %lsr.iv, 3
  %sunkaddr29 = getelementptr i8, ptr %arg.room.4, i64 %sunkaddr28
  %sunkaddr30 = getelementptr i8, ptr %sunkaddr29, i64 128
  %.249.i = load double, ptr %sunkaddr30, align 8, !noalias !113
  %sunkaddr33 = getelementptr i8, ptr %sunkaddr29, i64 256
  %.303.i = load double, ptr %sunkaddr33, align 8, !noalias !113
  %sunkaddr36 = getelementptr i8, ptr %sunkaddr29, i64 384
  %.357.i = load double, ptr %sunkaddr36, align 8, !noalias !113
  %.359.i = fmul contract double %.38.le.i, %.357.i
  %.360.i = fadd contract double %.303.i, %.359.i
  %.362.i = fmul contract double %.38.le.i, %.360.i
  %.363.i = fadd contract double %.249.i, %.362.i
  %.365.i = sitofp i64 %49 to double
  %.366.i = fmul contract double %.363.i, %.365.i
  %.421.i = fadd contract double %.303.i, %.366.i
  %.478.i = fmul contract double %.423.i, %.357.i
  %.479.i = fadd contract double %.478.i, %.421.i
  %.483.i = fdiv contract double %.479.i, 3.000000e+00
  %.484.i = fsub contract double %.363.i, %.483.i
  %.486.i = fmul contract double %power.2.0146.i, %.484.i
  %.488.i = fadd contract double %result.2.0145.i, %.486.i
  %.493.i = fmul contract double %.26.i, %power.2.0146.i
  %50 = tail call { i64, i1 } @llvm.uadd.with.overflow.i64(i64 %lsr.iv, i64 1)
  %math = extractvalue { i64, i1 } %50, 0
  %ov = extractvalue { i64, i1 } %50, 1
  br i1 %ov, label %_ZN17bnserve_surrogate6kernel7_series9_legendreB4v131B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dEd5ArrayIdLi2E1C7mutable7alignedE.exit, label %B134.if.i

_ZN17bnserve_surrogate6kernel7_series9_legendreB4v131B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dEd5ArrayIdLi2E1C7mutable7alignedE.exit: ; preds = %B134.if.i, %B1466
  %.2120.0 = phi double [ 0.000000e+00, %B1466 ], [ %.488.i, %B134.if.i ]
  %excinfo.6.0 = phi ptr [ @.const.picklebuf.b28008a0f88bad5ff0f0243e84dab90cab19b366, %B1466 ], [ null, %B134.if.i ]
  br i1 %.168.i.i, label %B1466.endif, label %B1466.if, !prof !0

B1526:                                            ; preds = %B1466.endif, %B1294
  %.2227 = getelementptr i8, ptr %arg.row.4, i64 72
  %.2228 = load double, ptr %.2227, align 8
  %.2234 = fmul contract double %.2228, 0x401921FB54442D18
  %.2240 = fdiv contract double %arg.unit, %.111
  %.2243 = fmul contract double %.2240, %.2234
  %51 = getelementptr i8, ptr %46, i64 8
  %.2277 = getelementptr double, ptr %51, i64 %.1992
  %.2278 = load double, ptr %.2277, align 8
  %.2285 = fmul contract double %arg.unit, %.2278
  %.2288 = fsub contract double %.2243, %.2285
  %sunkaddr39 = getelementptr i8, ptr %arg.out.4, i64 264
  store double %.2288, ptr %sunkaddr39, align 8
  %.2325 = fmul contract double %.381, 2.000000e+01
  store double %.2325, ptr %retptr, align 8
  br label %common.ret

common.ret:                                       ; preds = %B1466.if, %B1526
  %common.ret.op = phi i32 [ 0, %B1526 ], [ 1, %B1466.if ]
  ret i32 %common.ret.op

B1080.if:                                         ; preds = %entry, %B1282
  %power.1.2.0806 = phi double [ %.1332, %entry ], [ %.1836, %B1282 ]
  %.1421802804 = phi i64 [ 0, %entry ], [ %.1428, %B1282 ]
  %.1428 = add nuw nsw i64 %.1421802804, 1
  %sunkaddr40 = shl i64 %.1421802804, 3
  %sunkaddr41 = getelementptr i8, ptr %arg.room.4, i64 %sunkaddr40
  %.1510 = load double, ptr %sunkaddr41, align 8
  %sunkaddr44 = getelementptr i8, ptr %sunkaddr41, i64 128
  %.1565 = load double, ptr %sunkaddr44, align 8
  %sunkaddr47 = getelementptr i8, ptr %sunkaddr41, i64 256
  %.1620 = load double, ptr %sunkaddr47, align 8
  %.1622 = fmul contract double %.223.le, %.1620
  %.1623 = fadd contract double %.1565, %.1622
  %.1625 = fmul contract double %.223.le, %.1623
  %.1626 = fadd contract double %.1510, %.1625
  %.1628 = fmul contract double %power.1.2.0806, %.1626
  %scevgep10 = getelementptr i8, ptr %.1093, i64 %sunkaddr40
  store double %.1628, ptr %scevgep10, align 8
  %52 = add nsw i64 %.1421802804, -5
  %or.cond791 = icmp ult i64 %52, 7
  br i1 %or.cond791, label %B1198, label %B1282

B1466.if:                                         ; preds = %_ZN17bnserve_surrogate6kernel7_series9_legendreB4v131B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dEd5ArrayIdLi2E1C7mutable7alignedE.exit
  store ptr %excinfo.6.0, ptr %excinfo, align 8
  br label %common.ret

B1466.endif:                                      ; preds = %_ZN17bnserve_surrogate6kernel7_series9_legendreB4v131B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dEd5ArrayIdLi2E1C7mutable7alignedE.exit
  %.2157 = fadd contract double %.2008, %.2120.0
  store double %.2157, ptr %sunkaddr24, align 8
  br label %B1526
}

; Function Attrs: nofree noinline norecurse nosync nounwind memory(argmem: readwrite)
define internal fastcc void @inner_10(ptr noalias nonnull writeonly captures(none) %retptr, ptr readonly captures(none) %arg.f.4, ptr readonly captures(none) %arg.cbrt_f.4, ptr readonly captures(none) %arg.power.4, i64 %arg.segments.0, i64 %arg.segments.1, i64 %arg.segments.2, double %arg.mass, ptr readonly captures(none) %arg.c.4, double %arg.constant, ptr readonly captures(none) %arg.residuals.4, ptr writeonly captures(none) %arg.out.4) unnamed_addr #7 {
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
  %0 = add i64 %arg.segments.0, 7
  %.490 = lshr i64 %0, 3
  %.467.inv = icmp slt i64 %arg.segments.0, 1
  %.511530.not578 = icmp eq i64 %.490, 0
  %.511530.not = or i1 %.467.inv, %.511530.not578
  br i1 %.511530.not, label %B604, label %B194.if.lr.ph

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
  %.909 = sub i64 %arg.segments.1, %arg.segments.0
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
define internal fastcc void @inner_11(ptr noalias nonnull writeonly captures(none) %retptr, i64 %arg.i, i64 %arg.start, i64 %arg.inside, i64 range(i64 -9223372036854774784, -9223372036854775808) %arg.stop, ptr readonly captures(none) %arg.arguments.4, ptr readonly captures(none) %arg.amplitude.4, ptr readonly captures(none) %arg.phase.4, double %arg.factors.0, double %arg.factors.1, ptr captures(none) %arg.tail.4) unnamed_addr #5 {
entry:
  %.1158 = alloca ptr, align 8
  store ptr null, ptr %.1158, align 8
  %.1221 = alloca ptr, align 8
  store ptr null, ptr %.1221, align 8
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
  %scevgep48 = getelementptr i8, ptr %5, i64 24
  %scevgep63 = getelementptr i8, ptr %6, i64 24
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
  %sunkaddr167.epil = getelementptr i8, ptr %arg.amplitude.4, i64 %10
  %.519.epil2 = load double, ptr %sunkaddr167.epil, align 8
  %sunkaddr = inttoptr i64 %.236 to ptr
  %sunkaddr71 = getelementptr i8, ptr %sunkaddr, i64 %10
  store double %.519.epil2, ptr %sunkaddr71, align 8
  %sunkaddr169.epil = getelementptr i8, ptr %arg.phase.4, i64 %10
  %.579.epil3 = load double, ptr %sunkaddr169.epil, align 8
  %sunkaddr72 = inttoptr i64 %.298 to ptr
  %sunkaddr74 = getelementptr i8, ptr %sunkaddr72, i64 %10
  store double %.579.epil3, ptr %sunkaddr74, align 8
  %.465.1.epil = add nuw i64 %.458813815.epil.init4, 2
  %sunkaddr172.epil = getelementptr i8, ptr %sunkaddr167.epil, i64 8
  %.519.1.epil = load double, ptr %sunkaddr172.epil, align 8
  %sunkaddr78 = getelementptr i8, ptr %sunkaddr71, i64 8
  store double %.519.1.epil, ptr %sunkaddr78, align 8
  %sunkaddr175.epil = getelementptr i8, ptr %sunkaddr169.epil, i64 8
  %.579.1.epil = load double, ptr %sunkaddr175.epil, align 8
  %sunkaddr82 = getelementptr i8, ptr %sunkaddr74, i64 8
  store double %.579.1.epil, ptr %sunkaddr82, align 8
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
  %.neg119 = add i64 %arg.inside, 1
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
  %22 = icmp eq i64 %arg.stop, %.neg119
  br i1 %22, label %common.ret, label %B422.if.preheader120

B422.if.preheader120:                             ; preds = %B422.if.prol.loopexit
  %23 = add nuw i64 %.715818822.unr, 2
  %24 = inttoptr i64 %.298 to ptr
  %25 = inttoptr i64 %.236 to ptr
  %26 = shl i64 %.241, 3
  %27 = shl i64 %.722819821.unr, 3
  %scevgep = getelementptr i8, ptr %24, i64 %27
  %scevgep34 = getelementptr i8, ptr %25, i64 %27
  %28 = add i64 %26, 8
  br label %B422.if

common.ret:                                       ; preds = %B422.if, %B378, %B422.if.prol.loopexit, %B504, %B1006.endif.endif.endif
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
  %.65.i = load i64, ptr %arg.arguments.4, align 8, !noalias !117
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
  call fastcc void @inner_13(ptr nonnull %.1158, ptr %arg.amplitude.4, ptr %arg.phase.4, i64 %.1084, double %arg.factors.0, double %arg.factors.1, i64 %storemerge.i, ptr %.889, i64 %.879, ptr %.974, i64 %"$phi628.3.2.0", ptr %arg.tail.4)
  %.1219 = shl nsw i64 %.1084, 1
  store ptr null, ptr %.1221, align 8
  call fastcc void @inner_14(ptr nonnull %.1221, ptr %.889, i64 %.879, ptr %.974, i64 %"$phi628.3.2.0", i64 %.1219)
  br label %common.ret

B882:                                             ; preds = %entry
  %.1261 = sub nsw i64 %arg.stop, %arg.start
  %.1264 = shl nsw i64 %.1261, 1
  %.1270 = shl nsw i64 %.209, 4
  %.1272 = add nsw i64 %.1270, %.137
  %.1332 = add nsw i64 %.1270, %.167
  %.1334 = icmp eq i64 %.107, 2
  %"$phi1006.3.2.0" = select i1 %.1334, i64 %.1264, i64 0
  %.1432 = icmp sgt i64 %"$phi1006.3.2.0", 0
  %.65.i31 = load i64, ptr %arg.arguments.4, align 8, !noalias !120
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
  %.122.i = icmp sgt i64 %.1469, 0
  br i1 %.122.i, label %B152.preheader.i, label %B1006.endif.endif.endif

B328.if:                                          ; preds = %B328.if, %B328.if.preheader.new.new
  %lsr.iv29 = phi i64 [ %lsr.iv.next, %B328.if ], [ %8, %B328.if.preheader.new.new ]
  %.458813815 = phi i64 [ %.465.1.1, %B328.if ], [ 0, %B328.if.preheader.new.new ]
  %31 = shl i64 %.458813815, 3
  %sunkaddr76 = getelementptr i8, ptr %arg.amplitude.4, i64 %31
  %.519 = load double, ptr %sunkaddr76, align 8
  %scevgep51 = getelementptr i8, ptr %scevgep48, i64 %31
  %scevgep73 = getelementptr i8, ptr %scevgep51, i64 -16
  %scevgep71 = getelementptr i8, ptr %scevgep51, i64 -24
  store double %.519, ptr %scevgep71, align 8
  %sunkaddr79 = getelementptr i8, ptr %arg.phase.4, i64 %31
  %.579 = load double, ptr %sunkaddr79, align 8
  %scevgep64 = getelementptr i8, ptr %scevgep63, i64 %31
  %scevgep62 = getelementptr i8, ptr %scevgep64, i64 -16
  %scevgep59 = getelementptr i8, ptr %scevgep64, i64 -24
  store double %.579, ptr %scevgep59, align 8
  %sunkaddr83 = getelementptr i8, ptr %sunkaddr76, i64 8
  %.519.1 = load double, ptr %sunkaddr83, align 8
  store double %.519.1, ptr %scevgep73, align 8
  %sunkaddr86 = getelementptr i8, ptr %sunkaddr79, i64 8
  %.579.1 = load double, ptr %sunkaddr86, align 8
  store double %.579.1, ptr %scevgep62, align 8
  %sunkaddr89 = getelementptr i8, ptr %sunkaddr76, i64 16
  %.519.18 = load double, ptr %sunkaddr89, align 8
  %scevgep68 = getelementptr i8, ptr %scevgep51, i64 -8
  store double %.519.18, ptr %scevgep68, align 8
  %sunkaddr92 = getelementptr i8, ptr %sunkaddr79, i64 16
  %.579.19 = load double, ptr %sunkaddr92, align 8
  %scevgep55 = getelementptr i8, ptr %scevgep64, i64 -8
  store double %.579.19, ptr %scevgep55, align 8
  %.465.1.1 = add i64 %.458813815, 4
  %sunkaddr93 = shl i64 %.465.1.1, 3
  %sunkaddr94 = getelementptr i8, ptr %arg.amplitude.4, i64 %sunkaddr93
  %sunkaddr95 = getelementptr i8, ptr %sunkaddr94, i64 -8
  %.519.1.1 = load double, ptr %sunkaddr95, align 8
  store double %.519.1.1, ptr %scevgep51, align 8
  %sunkaddr97 = getelementptr i8, ptr %arg.phase.4, i64 %sunkaddr93
  %sunkaddr112 = getelementptr i8, ptr %sunkaddr97, i64 -8
  %.579.1.1 = load double, ptr %sunkaddr112, align 8
  store double %.579.1.1, ptr %scevgep64, align 8
  %lsr.iv.next = add i64 %lsr.iv29, 2
  %niter.ncmp.110 = icmp eq i64 %lsr.iv.next, 0
  br i1 %niter.ncmp.110, label %B378.loopexit.unr-lcssa.unr-lcssa, label %B328.if

B422.if:                                          ; preds = %B422.if, %B422.if.preheader120
  %lsr.iv35 = phi ptr [ %scevgep36, %B422.if ], [ %scevgep34, %B422.if.preheader120 ]
  %lsr.iv = phi ptr [ %scevgep32, %B422.if ], [ %scevgep, %B422.if.preheader120 ]
  %lsr.iv138 = phi i64 [ %lsr.iv.next139, %B422.if ], [ %23, %B422.if.preheader120 ]
  %.722819821 = phi i64 [ %35, %B422.if ], [ %.722819821.unr, %B422.if.preheader120 ]
  %.767 = icmp slt i64 %.722819821, 0
  %32 = select i1 %.767, i64 %26, i64 0
  %scevgep39 = getelementptr i8, ptr %lsr.iv35, i64 %32
  store double 0.000000e+00, ptr %scevgep39, align 8
  %scevgep38 = getelementptr i8, ptr %lsr.iv, i64 %32
  store double 0.000000e+00, ptr %scevgep38, align 8
  %33 = add i64 %.722819821, 1
  %.767.1 = icmp slt i64 %33, 0
  %34 = select i1 %.767.1, i64 %28, i64 8
  %scevgep28 = getelementptr i8, ptr %lsr.iv35, i64 %34
  store double 0.000000e+00, ptr %scevgep28, align 8
  %scevgep29 = getelementptr i8, ptr %lsr.iv, i64 %34
  store double 0.000000e+00, ptr %scevgep29, align 8
  %lsr.iv.next139 = add i64 %lsr.iv138, -2
  %scevgep32 = getelementptr i8, ptr %lsr.iv, i64 16
  %scevgep36 = getelementptr i8, ptr %lsr.iv35, i64 16
  %.716.1 = icmp sgt i64 %lsr.iv.next139, 2
  %35 = add i64 %.722819821, 2
  br i1 %.716.1, label %B422.if, label %common.ret

B152.preheader.i:                                 ; preds = %B882
  %plus.2.0.i = select i1 %.1432, double %arg.factors.0, double 1.000000e+00
  %.1513.i = fsub contract double 0.000000e+00, %arg.factors.1
  %.6.i449.i = insertelement <8 x double> poison, double %plus.2.0.i, i64 0
  %.7.i450.i = shufflevector <8 x double> %.6.i449.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.6.i452.i = insertelement <8 x double> poison, double %.1513.i, i64 0
  %.7.i453.i = shufflevector <8 x double> %.6.i452.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.6.i487.i = insertelement <8 x double> poison, double %arg.factors.1, i64 0
  %.7.i488.i = shufflevector <8 x double> %.6.i487.i, <8 x double> poison, <8 x i32> zeroinitializer
  %36 = shl i64 %.1261, 4
  %37 = shl i64 %"$phi1006.3.2.0", 3
  %38 = inttoptr i64 %.1272 to ptr
  %39 = inttoptr i64 %.1332 to ptr
  %40 = inttoptr i64 %.1272 to ptr
  %41 = inttoptr i64 %.1332 to ptr
  %42 = inttoptr i64 %.1272 to ptr
  %sunkaddr113 = getelementptr i8, ptr %arg.tail.4, i64 8
  %sunkaddr114 = getelementptr i8, ptr %arg.tail.4, i64 16
  %sunkaddr115 = getelementptr i8, ptr %arg.tail.4, i64 24
  %sunkaddr116 = getelementptr i8, ptr %arg.tail.4, i64 32
  %sunkaddr117 = getelementptr i8, ptr %arg.tail.4, i64 40
  %sunkaddr118 = getelementptr i8, ptr %arg.tail.4, i64 48
  %sunkaddr119 = getelementptr i8, ptr %arg.tail.4, i64 56
  %sunkaddr120 = getelementptr i8, ptr %arg.tail.4, i64 64
  %sunkaddr121 = getelementptr i8, ptr %arg.tail.4, i64 72
  %sunkaddr122 = getelementptr i8, ptr %arg.tail.4, i64 80
  %sunkaddr123 = getelementptr i8, ptr %arg.tail.4, i64 88
  %sunkaddr124 = getelementptr i8, ptr %arg.tail.4, i64 96
  %sunkaddr125 = getelementptr i8, ptr %arg.tail.4, i64 104
  %43 = inttoptr i64 %.1332 to ptr
  %44 = or disjoint i64 %37, 8
  %45 = add i64 %37, 24
  br label %B152.i

B152.i:                                           ; preds = %B924.i, %B152.preheader.i
  %j.2.0.i = phi i64 [ %.1589.i, %B924.i ], [ 0, %B152.preheader.i ]
  %.129.i = sub nsw i64 %.1469, %j.2.0.i
  %.13.i.i = tail call i64 @llvm.smin.i64(i64 %.129.i, i64 8)
  %.169.i = icmp slt i64 %j.2.0.i, %storemerge.i49
  %.13.i438.i = tail call i64 @llvm.smin.i64(i64 %storemerge.i49, i64 %.13.i.i)
  %count.2.1.i = select i1 %.169.i, i64 %.13.i438.i, i64 %.13.i.i
  %.217.i = getelementptr inbounds double, ptr %arg.phase.4, i64 %j.2.0.i
  %.219.i = load <8 x double>, ptr %.217.i, align 8, !noalias !123
  %.224.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.219.i, <8 x double> splat (double 0x3FE45F306DC9C883), <8 x double> splat (double 0x4338000000000000))
  %.8.i.i = fadd contract <8 x double> %.224.i, splat (double 0xC338000000000000)
  %.265.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i.i, <8 x double> splat (double 0xBFF921FB54442D18), <8 x double> %.219.i)
  %.282.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i.i, <8 x double> splat (double 0xBC91A62633145C07), <8 x double> %.265.i)
  %.6.i455.i = fmul contract <8 x double> %.282.i, %.282.i
  %.6.i456.i = fmul contract <8 x double> %.282.i, %.6.i455.i
  %.311.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i455.i, <8 x double> splat (double 0xBD6AE7F3E733B81F), <8 x double> splat (double 0x3DE6124613A86D09))
  %.314.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i455.i, <8 x double> %.311.i, <8 x double> splat (double 0xBE5AE64567F544E4))
  %.317.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i455.i, <8 x double> %.314.i, <8 x double> splat (double 0x3EC71DE3A556C734))
  %.320.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i455.i, <8 x double> %.317.i, <8 x double> splat (double 0xBF2A01A01A01A01A))
  %.323.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i455.i, <8 x double> %.320.i, <8 x double> splat (double 0x3F81111111111111))
  %.326.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i455.i, <8 x double> %.323.i, <8 x double> splat (double 0xBFC5555555555555))
  %.351.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i456.i, <8 x double> %.326.i, <8 x double> %.282.i)
  %.356.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i455.i, <8 x double> splat (double 0x3D2AE7F3E733B81F), <8 x double> splat (double 0xBDA93974A8C07C9D))
  %.359.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i455.i, <8 x double> %.356.i, <8 x double> splat (double 0x3E21EED8EFF8D898))
  %.362.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i455.i, <8 x double> %.359.i, <8 x double> splat (double 0xBE927E4FB7789F5C))
  %.365.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i455.i, <8 x double> %.362.i, <8 x double> splat (double 0x3EFA01A01A01A01A))
  %.368.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i455.i, <8 x double> %.365.i, <8 x double> splat (double 0xBF56C16C16C16C17))
  %.371.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i455.i, <8 x double> %.368.i, <8 x double> splat (double 0x3FA5555555555555))
  %.374.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i455.i, <8 x double> %.371.i, <8 x double> splat (double -5.000000e-01))
  %.377.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i455.i, <8 x double> %.374.i, <8 x double> splat (double 1.000000e+00))
  %.378.i = bitcast <8 x double> %.224.i to <8 x i64>
  %.379.i = bitcast <8 x double> %.351.i to <8 x i64>
  %.380.i = bitcast <8 x double> %.377.i to <8 x i64>
  %.6.i457.i = xor <8 x i64> %.380.i, %.379.i
  %.8.i458.i = and <8 x i64> %.378.i, splat (i64 1)
  %46 = icmp eq <8 x i64> %.8.i458.i, zeroinitializer
  %.6.i460.i = select <8 x i1> %46, <8 x i64> zeroinitializer, <8 x i64> %.6.i457.i
  %.8.i461.i = shl <8 x i64> %.378.i, splat (i64 62)
  %.8.i462.i = and <8 x i64> %.8.i461.i, splat (i64 -9223372036854775808)
  %.8.i464.i = add <8 x i64> %.8.i461.i, splat (i64 4611686018427387904)
  %.8.i465.i = and <8 x i64> %.8.i464.i, splat (i64 -9223372036854775808)
  %47 = xor <8 x i64> %.8.i462.i, %.379.i
  %.6.i467.i = xor <8 x i64> %47, %.6.i460.i
  %48 = bitcast <8 x i64> %.6.i467.i to <8 x double>
  %49 = xor <8 x i64> %.8.i465.i, %.380.i
  %.6.i469.i = xor <8 x i64> %49, %.6.i460.i
  %50 = bitcast <8 x i64> %.6.i469.i to <8 x double>
  %.723.i = getelementptr inbounds double, ptr %arg.amplitude.4, i64 %j.2.0.i
  %.725.i = load <8 x double>, ptr %.723.i, align 8, !noalias !123
  %.6.i470.i = fmul contract <8 x double> %.725.i, %50
  %.6.i471.i = fmul contract <8 x double> %.725.i, %48
  %.783.i = icmp slt i64 %count.2.1.i, 8
  br i1 %.783.i, label %B438.i, label %B698.i

B438.i:                                           ; preds = %B152.i
  %.8.i439.i = fmul contract <8 x double> %.7.i450.i, %.6.i470.i
  %.8.i474.i = fmul contract <8 x double> %.7.i450.i, %.6.i471.i
  %.846.i = shufflevector <8 x double> %.8.i439.i, <8 x double> %.8.i474.i, <16 x i32> <i32 0, i32 8, i32 1, i32 9, i32 2, i32 10, i32 3, i32 11, i32 4, i32 12, i32 5, i32 13, i32 6, i32 14, i32 7, i32 15>
  store <16 x double> %.846.i, ptr %arg.tail.4, align 4, !noalias !123
  %51 = tail call i64 @llvm.smax.i64(i64 %count.2.1.i, i64 0)
  %.930856.not.i = icmp slt i64 %count.2.1.i, 1
  br i1 %.930856.not.i, label %B562.i, label %B522.if.lr.ph.i

B562.i:                                           ; preds = %B522.if.i.6, %B522.if.i.5, %B522.if.i.4, %B522.if.i.3, %B522.if.i.2, %B522.if.i.1, %B522.if.lr.ph.i, %B438.i
  br i1 %.1432, label %B566.i, label %B924.i

B566.i:                                           ; preds = %B562.i
  %.8.i442.i = fmul contract <8 x double> %.7.i453.i, %.6.i471.i
  %.8.i477.i = fmul contract <8 x double> %.7.i488.i, %.6.i470.i
  %.1104.i = shufflevector <8 x double> %.8.i442.i, <8 x double> %.8.i477.i, <16 x i32> <i32 0, i32 8, i32 1, i32 9, i32 2, i32 10, i32 3, i32 11, i32 4, i32 12, i32 5, i32 13, i32 6, i32 14, i32 7, i32 15>
  store <16 x double> %.1104.i, ptr %arg.tail.4, align 4, !noalias !123
  br i1 %.930856.not.i, label %B924.i, label %B656.if.lr.ph.i

B698.i:                                           ; preds = %B152.i
  %.1356.i = shl i64 %j.2.0.i, 1
  %.8.i451.i = fmul contract <8 x double> %.7.i450.i, %.6.i470.i
  %.8.i486.i = fmul contract <8 x double> %.7.i450.i, %.6.i471.i
  %.1507.i = shufflevector <8 x double> %.8.i451.i, <8 x double> %.8.i486.i, <16 x i32> <i32 0, i32 8, i32 1, i32 9, i32 2, i32 10, i32 3, i32 11, i32 4, i32 12, i32 5, i32 13, i32 6, i32 14, i32 7, i32 15>
  %sunkaddr509.i = shl i64 %j.2.0.i, 4
  br i1 %or.cond.not.i45, label %B818.i, label %B710.i

B710.i:                                           ; preds = %B698.i
  %sunkaddr177 = getelementptr i8, ptr %38, i64 %sunkaddr509.i
  store <16 x double> %.1507.i, ptr %sunkaddr177, align 64, !noalias !123, !nontemporal !126
  br i1 %.1432, label %B762.i, label %B924.i

B762.i:                                           ; preds = %B710.i
  %.8.i448.i = fmul contract <8 x double> %.7.i453.i, %.6.i471.i
  %.8.i483.i = fmul contract <8 x double> %.7.i488.i, %.6.i470.i
  %.1435.i = getelementptr inbounds double, ptr %39, i64 %.1356.i
  %.1436.i = shufflevector <8 x double> %.8.i448.i, <8 x double> %.8.i483.i, <16 x i32> <i32 0, i32 8, i32 1, i32 9, i32 2, i32 10, i32 3, i32 11, i32 4, i32 12, i32 5, i32 13, i32 6, i32 14, i32 7, i32 15>
  store <16 x double> %.1436.i, ptr %.1435.i, align 64, !noalias !123, !nontemporal !126
  br label %B924.i

B818.i:                                           ; preds = %B698.i
  %sunkaddr179 = getelementptr i8, ptr %40, i64 %sunkaddr509.i
  store <16 x double> %.1507.i, ptr %sunkaddr179, align 4, !noalias !123
  br i1 %.1432, label %B870.i, label %B924.i

B870.i:                                           ; preds = %B818.i
  %.8.i454.i = fmul contract <8 x double> %.7.i453.i, %.6.i471.i
  %.8.i489.i = fmul contract <8 x double> %.7.i488.i, %.6.i470.i
  %.1578.i = getelementptr inbounds double, ptr %41, i64 %.1356.i
  %.1579.i = shufflevector <8 x double> %.8.i454.i, <8 x double> %.8.i489.i, <16 x i32> <i32 0, i32 8, i32 1, i32 9, i32 2, i32 10, i32 3, i32 11, i32 4, i32 12, i32 5, i32 13, i32 6, i32 14, i32 7, i32 15>
  store <16 x double> %.1579.i, ptr %.1578.i, align 4, !noalias !123
  br label %B924.i

B924.i.loopexit.unr-lcssa:                        ; preds = %B656.if.i
  %52 = and i64 %70, 1
  %lcmp.mod115.not.not = icmp eq i64 %52, 0
  br i1 %lcmp.mod115.not.not, label %B656.if.i.epil.preheader, label %B924.i

B656.if.i.epil.preheader:                         ; preds = %B656.if.lr.ph.i, %B924.i.loopexit.unr-lcssa
  %.1194861863.i.epil.init = phi i64 [ 0, %B656.if.lr.ph.i ], [ %.1201.1.i.1, %B924.i.loopexit.unr-lcssa ]
  %sunkaddr516.i.epil = shl i64 %.1194861863.i.epil.init, 3
  %sunkaddr517.i.epil = getelementptr i8, ptr %arg.tail.4, i64 %sunkaddr516.i.epil
  %.1255.i.epil = load double, ptr %sunkaddr517.i.epil, align 8, !noalias !123
  %53 = add i64 %.1194861863.i.epil.init, %.1257.i
  %.1272.i.epil = icmp slt i64 %53, 0
  %54 = select i1 %.1272.i.epil, i64 %37, i64 0
  %scevgep506.i.epil = getelementptr i8, ptr %scevgep502.i, i64 %54
  %scevgep507.i.epil = getelementptr i8, ptr %scevgep506.i.epil, i64 %sunkaddr516.i.epil
  store double %.1255.i.epil, ptr %scevgep507.i.epil, align 8, !noalias !123
  %sunkaddr520.i.epil = getelementptr i8, ptr %sunkaddr517.i.epil, i64 8
  %.1255.1.i.epil = load double, ptr %sunkaddr520.i.epil, align 8, !noalias !123
  %scevgep505.i.epil = getelementptr i8, ptr %scevgep507.i.epil, i64 8
  store double %.1255.1.i.epil, ptr %scevgep505.i.epil, align 8, !noalias !123
  br label %B924.i

B924.i:                                           ; preds = %B656.if.i.epil.preheader, %B924.i.loopexit.unr-lcssa, %B870.i, %B818.i, %B762.i, %B710.i, %B566.i, %B562.i
  %.1589.i = add nsw i64 %count.2.1.i, %j.2.0.i
  %.1595.i = icmp slt i64 %.1589.i, %.1469
  br i1 %.1595.i, label %B152.i, label %B1006.endif.endif.endif

B522.if.lr.ph.i:                                  ; preds = %B438.i
  %.999.i = shl nsw i64 %j.2.0.i, 1
  %55 = shl i64 %j.2.0.i, 4
  %scevgep493.i = getelementptr i8, ptr %42, i64 %55
  %.997.i = load double, ptr %arg.tail.4, align 8, !noalias !123
  %.1014.i = icmp slt i64 %j.2.0.i, 0
  %56 = select i1 %.1014.i, i64 %36, i64 0
  %scevgep497.i = getelementptr i8, ptr %scevgep493.i, i64 %56
  store double %.997.i, ptr %scevgep497.i, align 8, !noalias !123
  %.997.1.i = load double, ptr %sunkaddr113, align 8, !noalias !123
  %scevgep496.i = getelementptr i8, ptr %scevgep497.i, i64 8
  store double %.997.1.i, ptr %scevgep496.i, align 8, !noalias !123
  %exitcond.not.1.i = icmp eq i64 %count.2.1.i, 1
  br i1 %exitcond.not.1.i, label %B562.i, label %B522.if.i.1

B522.if.i.1:                                      ; preds = %B522.if.lr.ph.i
  %.997.i.1 = load double, ptr %sunkaddr114, align 8, !noalias !123
  %57 = add i64 %.999.i, 2
  %.1014.i.1 = icmp slt i64 %57, 0
  %58 = select i1 %.1014.i.1, i64 %36, i64 0
  %scevgep497.i.1 = getelementptr i8, ptr %scevgep493.i, i64 %58
  %scevgep498.i.1 = getelementptr i8, ptr %scevgep497.i.1, i64 16
  store double %.997.i.1, ptr %scevgep498.i.1, align 8, !noalias !123
  %.997.1.i.1 = load double, ptr %sunkaddr115, align 8, !noalias !123
  %scevgep496.i.1 = getelementptr i8, ptr %scevgep497.i.1, i64 24
  store double %.997.1.i.1, ptr %scevgep496.i.1, align 8, !noalias !123
  %exitcond.not.1.i.1 = icmp eq i64 %count.2.1.i, 2
  br i1 %exitcond.not.1.i.1, label %B562.i, label %B522.if.i.2

B522.if.i.2:                                      ; preds = %B522.if.i.1
  %.997.i.2 = load double, ptr %sunkaddr116, align 8, !noalias !123
  %59 = add i64 %.999.i, 4
  %.1014.i.2 = icmp slt i64 %59, 0
  %60 = select i1 %.1014.i.2, i64 %36, i64 0
  %scevgep497.i.2 = getelementptr i8, ptr %scevgep493.i, i64 %60
  %scevgep498.i.2 = getelementptr i8, ptr %scevgep497.i.2, i64 32
  store double %.997.i.2, ptr %scevgep498.i.2, align 8, !noalias !123
  %.997.1.i.2 = load double, ptr %sunkaddr117, align 8, !noalias !123
  %scevgep496.i.2 = getelementptr i8, ptr %scevgep497.i.2, i64 40
  store double %.997.1.i.2, ptr %scevgep496.i.2, align 8, !noalias !123
  %exitcond.not.1.i.2 = icmp eq i64 %count.2.1.i, 3
  br i1 %exitcond.not.1.i.2, label %B562.i, label %B522.if.i.3

B522.if.i.3:                                      ; preds = %B522.if.i.2
  %.997.i.3 = load double, ptr %sunkaddr118, align 8, !noalias !123
  %61 = add i64 %.999.i, 6
  %.1014.i.3 = icmp slt i64 %61, 0
  %62 = select i1 %.1014.i.3, i64 %36, i64 0
  %scevgep497.i.3 = getelementptr i8, ptr %scevgep493.i, i64 %62
  %scevgep498.i.3 = getelementptr i8, ptr %scevgep497.i.3, i64 48
  store double %.997.i.3, ptr %scevgep498.i.3, align 8, !noalias !123
  %.997.1.i.3 = load double, ptr %sunkaddr119, align 8, !noalias !123
  %scevgep496.i.3 = getelementptr i8, ptr %scevgep497.i.3, i64 56
  store double %.997.1.i.3, ptr %scevgep496.i.3, align 8, !noalias !123
  %exitcond.not.1.i.3 = icmp eq i64 %count.2.1.i, 4
  br i1 %exitcond.not.1.i.3, label %B562.i, label %B522.if.i.4

B522.if.i.4:                                      ; preds = %B522.if.i.3
  %.997.i.4 = load double, ptr %sunkaddr120, align 8, !noalias !123
  %63 = add i64 %.999.i, 8
  %.1014.i.4 = icmp slt i64 %63, 0
  %64 = select i1 %.1014.i.4, i64 %36, i64 0
  %scevgep497.i.4 = getelementptr i8, ptr %scevgep493.i, i64 %64
  %scevgep498.i.4 = getelementptr i8, ptr %scevgep497.i.4, i64 64
  store double %.997.i.4, ptr %scevgep498.i.4, align 8, !noalias !123
  %.997.1.i.4 = load double, ptr %sunkaddr121, align 8, !noalias !123
  %scevgep496.i.4 = getelementptr i8, ptr %scevgep497.i.4, i64 72
  store double %.997.1.i.4, ptr %scevgep496.i.4, align 8, !noalias !123
  %exitcond.not.1.i.4 = icmp eq i64 %count.2.1.i, 5
  br i1 %exitcond.not.1.i.4, label %B562.i, label %B522.if.i.5

B522.if.i.5:                                      ; preds = %B522.if.i.4
  %.997.i.5 = load double, ptr %sunkaddr122, align 8, !noalias !123
  %65 = add i64 %.999.i, 10
  %.1014.i.5 = icmp slt i64 %65, 0
  %66 = select i1 %.1014.i.5, i64 %36, i64 0
  %scevgep497.i.5 = getelementptr i8, ptr %scevgep493.i, i64 %66
  %scevgep498.i.5 = getelementptr i8, ptr %scevgep497.i.5, i64 80
  store double %.997.i.5, ptr %scevgep498.i.5, align 8, !noalias !123
  %.997.1.i.5 = load double, ptr %sunkaddr123, align 8, !noalias !123
  %scevgep496.i.5 = getelementptr i8, ptr %scevgep497.i.5, i64 88
  store double %.997.1.i.5, ptr %scevgep496.i.5, align 8, !noalias !123
  %exitcond.not.1.i.5 = icmp eq i64 %count.2.1.i, 6
  br i1 %exitcond.not.1.i.5, label %B562.i, label %B522.if.i.6

B522.if.i.6:                                      ; preds = %B522.if.i.5
  %.997.i.6 = load double, ptr %sunkaddr124, align 8, !noalias !123
  %67 = add i64 %.999.i, 12
  %.1014.i.6 = icmp slt i64 %67, 0
  %68 = select i1 %.1014.i.6, i64 %36, i64 0
  %scevgep497.i.6 = getelementptr i8, ptr %scevgep493.i, i64 %68
  %scevgep498.i.6 = getelementptr i8, ptr %scevgep497.i.6, i64 96
  store double %.997.i.6, ptr %scevgep498.i.6, align 8, !noalias !123
  %.997.1.i.6 = load double, ptr %sunkaddr125, align 8, !noalias !123
  %scevgep496.i.6 = getelementptr i8, ptr %scevgep497.i.6, i64 104
  store double %.997.1.i.6, ptr %scevgep496.i.6, align 8, !noalias !123
  br label %B562.i

B656.if.lr.ph.i:                                  ; preds = %B566.i
  %.1257.i = shl i64 %j.2.0.i, 1
  %69 = shl i64 %j.2.0.i, 4
  %scevgep502.i = getelementptr i8, ptr %43, i64 %69
  %70 = add nuw i64 %51, 9223372036854775807
  %71 = icmp eq i64 %count.2.1.i, 1
  br i1 %71, label %B656.if.i.epil.preheader, label %B656.if.lr.ph.i.new

B656.if.lr.ph.i.new:                              ; preds = %B656.if.lr.ph.i
  %72 = and i64 %70, 9223372036854775807
  %73 = add nuw i64 %72, 1
  %74 = add i64 %.1257.i, 2
  %75 = and i64 %73, -2
  br label %B656.if.i

B656.if.i:                                        ; preds = %B656.if.i, %B656.if.lr.ph.i.new
  %lsr.iv1 = phi i64 [ %lsr.iv.next2, %B656.if.i ], [ %75, %B656.if.lr.ph.i.new ]
  %.1194861863.i = phi i64 [ %.1201.1.i.1, %B656.if.i ], [ 0, %B656.if.lr.ph.i.new ]
  %sunkaddr126 = shl i64 %.1194861863.i, 3
  %sunkaddr127 = getelementptr i8, ptr %arg.tail.4, i64 %sunkaddr126
  %.1255.i = load double, ptr %sunkaddr127, align 8, !noalias !123
  %76 = add i64 %.1194861863.i, %.1257.i
  %.1272.i = icmp slt i64 %76, 0
  %77 = select i1 %.1272.i, i64 %44, i64 8
  %scevgep12 = getelementptr i8, ptr %scevgep502.i, i64 %77
  %scevgep17 = getelementptr i8, ptr %scevgep12, i64 %sunkaddr126
  %scevgep19 = getelementptr i8, ptr %scevgep17, i64 -8
  store double %.1255.i, ptr %scevgep19, align 8, !noalias !123
  %sunkaddr130 = getelementptr i8, ptr %sunkaddr127, i64 8
  %.1255.1.i = load double, ptr %sunkaddr130, align 8, !noalias !123
  store double %.1255.1.i, ptr %scevgep17, align 8, !noalias !123
  %sunkaddr133 = getelementptr i8, ptr %sunkaddr127, i64 16
  %.1255.i.1 = load double, ptr %sunkaddr133, align 8, !noalias !123
  %78 = add i64 %74, %.1194861863.i
  %.1272.i.1 = icmp slt i64 %78, 0
  %79 = select i1 %.1272.i.1, i64 %45, i64 24
  %scevgep6 = getelementptr i8, ptr %scevgep502.i, i64 %79
  %scevgep7 = getelementptr i8, ptr %scevgep6, i64 %sunkaddr126
  %scevgep8 = getelementptr i8, ptr %scevgep7, i64 -8
  store double %.1255.i.1, ptr %scevgep8, align 8, !noalias !123
  %.1201.1.i.1 = add i64 %.1194861863.i, 4
  %sunkaddr134 = shl i64 %.1201.1.i.1, 3
  %sunkaddr135 = getelementptr i8, ptr %arg.tail.4, i64 %sunkaddr134
  %sunkaddr136 = getelementptr i8, ptr %sunkaddr135, i64 -8
  %.1255.1.i.1 = load double, ptr %sunkaddr136, align 8, !noalias !123
  store double %.1255.1.i.1, ptr %scevgep7, align 8, !noalias !123
  %lsr.iv.next2 = add i64 %lsr.iv1, -2
  %niter118.ncmp.1 = icmp eq i64 %lsr.iv.next2, 0
  br i1 %niter118.ncmp.1, label %B924.i.loopexit.unr-lcssa, label %B656.if.i

B1006.endif.endif.endif:                          ; preds = %B924.i, %B882
  %80 = inttoptr i64 %.1332 to ptr
  %81 = inttoptr i64 %.1272 to ptr
  %.1538 = shl nsw i64 %.1469, 1
  store ptr null, ptr %.1540, align 8
  call fastcc void @inner_15(ptr nonnull %.1540, ptr %81, i64 %.1264, ptr %80, i64 %"$phi1006.3.2.0", i64 %.1538)
  br label %common.ret
}

; Function Attrs: mustprogress nocallback nocreateundeforpoison nofree nosync nounwind speculatable willreturn memory(none)
declare double @llvm.log.f64(double) #3

; Function Attrs: nofree noinline norecurse nosync nounwind memory(argmem: readwrite)
define internal fastcc void @inner_12(ptr noalias nonnull writeonly captures(none) %retptr, ptr readonly captures(none) %arg.log_f.4, i64 %arg.points, ptr readonly captures(none) %arg.table.4, i64 %arg.bins, double %arg.density, double %arg.bound) unnamed_addr #7 {
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
define internal fastcc void @inner_13(ptr noalias nonnull writeonly captures(none) %retptr, ptr readonly captures(none) %arg.amplitude.4, ptr readonly captures(none) %arg.phase.4, i64 %arg.stop, double %arg.factors.0, double %arg.factors.1, i64 range(i64 -1, 8) %arg.streamed, ptr writeonly captures(none) %arg.first.4, i64 range(i64 -9223372036854775808, 9223372036854775807) %arg.first.5.0, ptr writeonly captures(none) %arg.second.4, i64 range(i64 -9223372036854775808, 9223372036854775807) %arg.second.5.0, ptr captures(none) %arg.tail.4) unnamed_addr #7 {
entry:
  %.126 = icmp sgt i64 %arg.stop, 0
  br i1 %.126, label %B152.preheader, label %common.ret

B152.preheader:                                   ; preds = %entry
  %0 = icmp sgt i64 %arg.second.5.0, 0
  %.88 = fptrunc double %arg.factors.0 to float
  %.89 = fpext float %.88 to double
  %plus.2.0 = select i1 %0, double %.89, double 1.000000e+00
  %.94 = fptrunc double %arg.factors.1 to float
  %.95 = fpext float %.94 to double
  %.1531 = fsub contract double 0.000000e+00, %.95
  %.6.i449 = insertelement <8 x double> poison, double %plus.2.0, i64 0
  %.7.i450 = shufflevector <8 x double> %.6.i449, <8 x double> poison, <8 x i32> zeroinitializer
  %.6.i452 = insertelement <8 x double> poison, double %.1531, i64 0
  %.7.i453 = shufflevector <8 x double> %.6.i452, <8 x double> poison, <8 x i32> zeroinitializer
  %.6.i487 = insertelement <8 x double> poison, double %.95, i64 0
  %.7.i488 = shufflevector <8 x double> %.6.i487, <8 x double> poison, <8 x i32> zeroinitializer
  %1 = shl i64 %arg.first.5.0, 2
  %2 = shl i64 %arg.second.5.0, 2
  %3 = icmp sgt i64 %arg.streamed, -1
  %sunkaddr31 = getelementptr i8, ptr %arg.tail.4, i64 4
  %sunkaddr32 = getelementptr i8, ptr %arg.tail.4, i64 8
  %sunkaddr33 = getelementptr i8, ptr %arg.tail.4, i64 12
  %sunkaddr34 = getelementptr i8, ptr %arg.tail.4, i64 16
  %sunkaddr = getelementptr i8, ptr %arg.tail.4, i64 20
  %sunkaddr35 = getelementptr i8, ptr %arg.tail.4, i64 24
  %sunkaddr36 = getelementptr i8, ptr %arg.tail.4, i64 28
  %sunkaddr37 = getelementptr i8, ptr %arg.tail.4, i64 32
  %sunkaddr38 = getelementptr i8, ptr %arg.tail.4, i64 36
  %sunkaddr39 = getelementptr i8, ptr %arg.tail.4, i64 40
  %sunkaddr40 = getelementptr i8, ptr %arg.tail.4, i64 44
  %sunkaddr41 = getelementptr i8, ptr %arg.tail.4, i64 48
  %sunkaddr42 = getelementptr i8, ptr %arg.tail.4, i64 52
  %4 = add i64 %2, 4
  %5 = add i64 %2, 12
  br label %B152

B152:                                             ; preds = %B924, %B152.preheader
  %j.2.0 = phi i64 [ %.1609, %B924 ], [ 0, %B152.preheader ]
  %.133 = sub nsw i64 %arg.stop, %j.2.0
  %.13.i = tail call i64 @llvm.smin.i64(i64 %.133, i64 8)
  %.173 = icmp slt i64 %j.2.0, %arg.streamed
  %.13.i438 = tail call i64 @llvm.smin.i64(i64 %arg.streamed, i64 %.13.i)
  %count.2.1 = select i1 %.173, i64 %.13.i438, i64 %.13.i
  %.221 = getelementptr inbounds double, ptr %arg.phase.4, i64 %j.2.0
  %.223 = load <8 x double>, ptr %.221, align 8
  %.228 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.223, <8 x double> splat (double 0x3FE45F306DC9C883), <8 x double> splat (double 0x4338000000000000))
  %.8.i = fadd contract <8 x double> %.228, splat (double 0xC338000000000000)
  %.269 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i, <8 x double> splat (double 0xBFF921FB54442D18), <8 x double> %.223)
  %.286 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i, <8 x double> splat (double 0xBC91A62633145C07), <8 x double> %.269)
  %.6.i455 = fmul contract <8 x double> %.286, %.286
  %.6.i456 = fmul contract <8 x double> %.286, %.6.i455
  %.315 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i455, <8 x double> splat (double 0xBD6AE7F3E733B81F), <8 x double> splat (double 0x3DE6124613A86D09))
  %.318 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i455, <8 x double> %.315, <8 x double> splat (double 0xBE5AE64567F544E4))
  %.321 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i455, <8 x double> %.318, <8 x double> splat (double 0x3EC71DE3A556C734))
  %.324 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i455, <8 x double> %.321, <8 x double> splat (double 0xBF2A01A01A01A01A))
  %.327 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i455, <8 x double> %.324, <8 x double> splat (double 0x3F81111111111111))
  %.330 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i455, <8 x double> %.327, <8 x double> splat (double 0xBFC5555555555555))
  %.355 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i456, <8 x double> %.330, <8 x double> %.286)
  %.360 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i455, <8 x double> splat (double 0x3D2AE7F3E733B81F), <8 x double> splat (double 0xBDA93974A8C07C9D))
  %.363 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i455, <8 x double> %.360, <8 x double> splat (double 0x3E21EED8EFF8D898))
  %.366 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i455, <8 x double> %.363, <8 x double> splat (double 0xBE927E4FB7789F5C))
  %.369 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i455, <8 x double> %.366, <8 x double> splat (double 0x3EFA01A01A01A01A))
  %.372 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i455, <8 x double> %.369, <8 x double> splat (double 0xBF56C16C16C16C17))
  %.375 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i455, <8 x double> %.372, <8 x double> splat (double 0x3FA5555555555555))
  %.378 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i455, <8 x double> %.375, <8 x double> splat (double -5.000000e-01))
  %.381 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i455, <8 x double> %.378, <8 x double> splat (double 1.000000e+00))
  %.382 = bitcast <8 x double> %.228 to <8 x i64>
  %.383 = bitcast <8 x double> %.355 to <8 x i64>
  %.384 = bitcast <8 x double> %.381 to <8 x i64>
  %.6.i457 = xor <8 x i64> %.384, %.383
  %.8.i458 = and <8 x i64> %.382, splat (i64 1)
  %6 = icmp eq <8 x i64> %.8.i458, zeroinitializer
  %.6.i460 = select <8 x i1> %6, <8 x i64> zeroinitializer, <8 x i64> %.6.i457
  %.8.i461 = shl <8 x i64> %.382, splat (i64 62)
  %.8.i462 = and <8 x i64> %.8.i461, splat (i64 -9223372036854775808)
  %.8.i464 = add <8 x i64> %.8.i461, splat (i64 4611686018427387904)
  %.8.i465 = and <8 x i64> %.8.i464, splat (i64 -9223372036854775808)
  %7 = xor <8 x i64> %.8.i462, %.383
  %.6.i467 = xor <8 x i64> %7, %.6.i460
  %8 = bitcast <8 x i64> %.6.i467 to <8 x double>
  %9 = xor <8 x i64> %.8.i465, %.384
  %.6.i469 = xor <8 x i64> %9, %.6.i460
  %10 = bitcast <8 x i64> %.6.i469 to <8 x double>
  %.727 = getelementptr inbounds double, ptr %arg.amplitude.4, i64 %j.2.0
  %.729 = load <8 x double>, ptr %.727, align 8
  %.6.i470 = fmul contract <8 x double> %.729, %10
  %.755 = fptrunc <8 x double> %.6.i470 to <8 x float>
  %.756 = fpext <8 x float> %.755 to <8 x double>
  %.6.i471 = fmul contract <8 x double> %.729, %8
  %.782 = fptrunc <8 x double> %.6.i471 to <8 x float>
  %.783 = fpext <8 x float> %.782 to <8 x double>
  %.791 = icmp slt i64 %count.2.1, 8
  br i1 %.791, label %B438, label %B698

B438:                                             ; preds = %B152
  %.8.i439 = fmul contract <8 x double> %.7.i450, %.756
  %.8.i474 = fmul contract <8 x double> %.7.i450, %.783
  %11 = shufflevector <8 x double> %.8.i439, <8 x double> %.8.i474, <16 x i32> <i32 0, i32 8, i32 1, i32 9, i32 2, i32 10, i32 3, i32 11, i32 4, i32 12, i32 5, i32 13, i32 6, i32 14, i32 7, i32 15>
  %.856 = fptrunc <16 x double> %11 to <16 x float>
  store <16 x float> %.856, ptr %arg.tail.4, align 4
  %12 = tail call i64 @llvm.smax.i64(i64 %count.2.1, i64 0)
  %.940856.not = icmp slt i64 %count.2.1, 1
  br i1 %.940856.not, label %B562, label %B522.if.lr.ph

B562:                                             ; preds = %B522.if.6, %B522.if.5, %B522.if.4, %B522.if.3, %B522.if.2, %B522.if.1, %B522.if.lr.ph, %B438
  br i1 %0, label %B566, label %B924

B566:                                             ; preds = %B562
  %.8.i442 = fmul contract <8 x double> %.7.i453, %.783
  %.8.i477 = fmul contract <8 x double> %.7.i488, %.756
  %13 = shufflevector <8 x double> %.8.i442, <8 x double> %.8.i477, <16 x i32> <i32 0, i32 8, i32 1, i32 9, i32 2, i32 10, i32 3, i32 11, i32 4, i32 12, i32 5, i32 13, i32 6, i32 14, i32 7, i32 15>
  %.1116 = fptrunc <16 x double> %13 to <16 x float>
  store <16 x float> %.1116, ptr %arg.tail.4, align 4
  br i1 %.940856.not, label %B924, label %B656.if.lr.ph

B698:                                             ; preds = %B152
  %.1368 = shl i64 %j.2.0, 1
  %.8.i445 = fmul contract <8 x double> %.7.i450, %.756
  %.8.i480 = fmul contract <8 x double> %.7.i450, %.783
  %14 = shufflevector <8 x double> %.8.i445, <8 x double> %.8.i480, <16 x i32> <i32 0, i32 8, i32 1, i32 9, i32 2, i32 10, i32 3, i32 11, i32 4, i32 12, i32 5, i32 13, i32 6, i32 14, i32 7, i32 15>
  %.1378 = fptrunc <16 x double> %14 to <16 x float>
  %sunkaddr25 = shl i64 %j.2.0, 3
  %sunkaddr26 = getelementptr i8, ptr %arg.first.4, i64 %sunkaddr25
  br i1 %3, label %B710, label %B818

B710:                                             ; preds = %B698
  store <16 x float> %.1378, ptr %sunkaddr26, align 64, !nontemporal !126
  br i1 %0, label %B762, label %B924

B762:                                             ; preds = %B710
  %.8.i448 = fmul contract <8 x double> %.7.i453, %.783
  %.8.i483 = fmul contract <8 x double> %.7.i488, %.756
  %.1449 = getelementptr inbounds float, ptr %arg.second.4, i64 %.1368
  %15 = shufflevector <8 x double> %.8.i448, <8 x double> %.8.i483, <16 x i32> <i32 0, i32 8, i32 1, i32 9, i32 2, i32 10, i32 3, i32 11, i32 4, i32 12, i32 5, i32 13, i32 6, i32 14, i32 7, i32 15>
  %.1452 = fptrunc <16 x double> %15 to <16 x float>
  store <16 x float> %.1452, ptr %.1449, align 64, !nontemporal !126
  br label %B924

B818:                                             ; preds = %B698
  store <16 x float> %.1378, ptr %sunkaddr26, align 4
  br i1 %0, label %B870, label %B924

B870:                                             ; preds = %B818
  %.8.i454 = fmul contract <8 x double> %.7.i453, %.783
  %.8.i489 = fmul contract <8 x double> %.7.i488, %.756
  %.1596 = getelementptr inbounds float, ptr %arg.second.4, i64 %.1368
  %16 = shufflevector <8 x double> %.8.i454, <8 x double> %.8.i489, <16 x i32> <i32 0, i32 8, i32 1, i32 9, i32 2, i32 10, i32 3, i32 11, i32 4, i32 12, i32 5, i32 13, i32 6, i32 14, i32 7, i32 15>
  %.1599 = fptrunc <16 x double> %16 to <16 x float>
  store <16 x float> %.1599, ptr %.1596, align 4
  br label %B924

B924.loopexit.unr-lcssa:                          ; preds = %B656.if
  %17 = and i64 %35, 1
  %lcmp.mod.not.not = icmp eq i64 %17, 0
  br i1 %lcmp.mod.not.not, label %B656.if.epil.preheader, label %B924

B656.if.epil.preheader:                           ; preds = %B656.if.lr.ph, %B924.loopexit.unr-lcssa
  %.1206861863.epil.init = phi i64 [ 0, %B656.if.lr.ph ], [ %.1213.1.1, %B924.loopexit.unr-lcssa ]
  %sunkaddr516.epil = shl i64 %.1206861863.epil.init, 2
  %sunkaddr517.epil = getelementptr i8, ptr %arg.tail.4, i64 %sunkaddr516.epil
  %.1267.epil = load float, ptr %sunkaddr517.epil, align 4
  %18 = add i64 %.1206861863.epil.init, %.1269
  %.1284.epil = icmp slt i64 %18, 0
  %19 = select i1 %.1284.epil, i64 %2, i64 0
  %scevgep506.epil = getelementptr i8, ptr %scevgep502, i64 %19
  %scevgep507.epil = getelementptr i8, ptr %scevgep506.epil, i64 %sunkaddr516.epil
  store float %.1267.epil, ptr %scevgep507.epil, align 4
  %sunkaddr520.epil = getelementptr i8, ptr %sunkaddr517.epil, i64 4
  %.1267.1.epil = load float, ptr %sunkaddr520.epil, align 4
  %scevgep505.epil = getelementptr i8, ptr %scevgep507.epil, i64 4
  store float %.1267.1.epil, ptr %scevgep505.epil, align 4
  br label %B924

B924:                                             ; preds = %B656.if.epil.preheader, %B924.loopexit.unr-lcssa, %B870, %B818, %B762, %B710, %B566, %B562
  %.1609 = add nsw i64 %count.2.1, %j.2.0
  %.1615 = icmp slt i64 %.1609, %arg.stop
  br i1 %.1615, label %B152, label %common.ret

common.ret:                                       ; preds = %B924, %entry
  store ptr null, ptr %retptr, align 8
  ret void

B522.if.lr.ph:                                    ; preds = %B438
  %.1009 = shl nsw i64 %j.2.0, 1
  %20 = shl i64 %j.2.0, 3
  %scevgep493 = getelementptr i8, ptr %arg.first.4, i64 %20
  %.1007 = load float, ptr %arg.tail.4, align 4
  %.1024 = icmp slt i64 %j.2.0, 0
  %21 = select i1 %.1024, i64 %1, i64 0
  %scevgep497 = getelementptr i8, ptr %scevgep493, i64 %21
  store float %.1007, ptr %scevgep497, align 4
  %.1007.1 = load float, ptr %sunkaddr31, align 4
  %scevgep496 = getelementptr i8, ptr %scevgep497, i64 4
  store float %.1007.1, ptr %scevgep496, align 4
  %exitcond.not.1 = icmp eq i64 %count.2.1, 1
  br i1 %exitcond.not.1, label %B562, label %B522.if.1

B522.if.1:                                        ; preds = %B522.if.lr.ph
  %.1007.11 = load float, ptr %sunkaddr32, align 4
  %22 = add i64 %.1009, 2
  %.1024.1 = icmp slt i64 %22, 0
  %23 = select i1 %.1024.1, i64 %1, i64 0
  %scevgep497.1 = getelementptr i8, ptr %scevgep493, i64 %23
  %scevgep498.1 = getelementptr i8, ptr %scevgep497.1, i64 8
  store float %.1007.11, ptr %scevgep498.1, align 4
  %.1007.1.1 = load float, ptr %sunkaddr33, align 4
  %scevgep496.1 = getelementptr i8, ptr %scevgep497.1, i64 12
  store float %.1007.1.1, ptr %scevgep496.1, align 4
  %exitcond.not.1.1 = icmp eq i64 %count.2.1, 2
  br i1 %exitcond.not.1.1, label %B562, label %B522.if.2

B522.if.2:                                        ; preds = %B522.if.1
  %.1007.2 = load float, ptr %sunkaddr34, align 4
  %24 = add i64 %.1009, 4
  %.1024.2 = icmp slt i64 %24, 0
  %25 = select i1 %.1024.2, i64 %1, i64 0
  %scevgep497.2 = getelementptr i8, ptr %scevgep493, i64 %25
  %scevgep498.2 = getelementptr i8, ptr %scevgep497.2, i64 16
  store float %.1007.2, ptr %scevgep498.2, align 4
  %.1007.1.2 = load float, ptr %sunkaddr, align 4
  %scevgep496.2 = getelementptr i8, ptr %scevgep497.2, i64 20
  store float %.1007.1.2, ptr %scevgep496.2, align 4
  %exitcond.not.1.2 = icmp eq i64 %count.2.1, 3
  br i1 %exitcond.not.1.2, label %B562, label %B522.if.3

B522.if.3:                                        ; preds = %B522.if.2
  %.1007.3 = load float, ptr %sunkaddr35, align 4
  %26 = add i64 %.1009, 6
  %.1024.3 = icmp slt i64 %26, 0
  %27 = select i1 %.1024.3, i64 %1, i64 0
  %scevgep497.3 = getelementptr i8, ptr %scevgep493, i64 %27
  %scevgep498.3 = getelementptr i8, ptr %scevgep497.3, i64 24
  store float %.1007.3, ptr %scevgep498.3, align 4
  %.1007.1.3 = load float, ptr %sunkaddr36, align 4
  %scevgep496.3 = getelementptr i8, ptr %scevgep497.3, i64 28
  store float %.1007.1.3, ptr %scevgep496.3, align 4
  %exitcond.not.1.3 = icmp eq i64 %count.2.1, 4
  br i1 %exitcond.not.1.3, label %B562, label %B522.if.4

B522.if.4:                                        ; preds = %B522.if.3
  %.1007.4 = load float, ptr %sunkaddr37, align 4
  %28 = add i64 %.1009, 8
  %.1024.4 = icmp slt i64 %28, 0
  %29 = select i1 %.1024.4, i64 %1, i64 0
  %scevgep497.4 = getelementptr i8, ptr %scevgep493, i64 %29
  %scevgep498.4 = getelementptr i8, ptr %scevgep497.4, i64 32
  store float %.1007.4, ptr %scevgep498.4, align 4
  %.1007.1.4 = load float, ptr %sunkaddr38, align 4
  %scevgep496.4 = getelementptr i8, ptr %scevgep497.4, i64 36
  store float %.1007.1.4, ptr %scevgep496.4, align 4
  %exitcond.not.1.4 = icmp eq i64 %count.2.1, 5
  br i1 %exitcond.not.1.4, label %B562, label %B522.if.5

B522.if.5:                                        ; preds = %B522.if.4
  %.1007.5 = load float, ptr %sunkaddr39, align 4
  %30 = add i64 %.1009, 10
  %.1024.5 = icmp slt i64 %30, 0
  %31 = select i1 %.1024.5, i64 %1, i64 0
  %scevgep497.5 = getelementptr i8, ptr %scevgep493, i64 %31
  %scevgep498.5 = getelementptr i8, ptr %scevgep497.5, i64 40
  store float %.1007.5, ptr %scevgep498.5, align 4
  %.1007.1.5 = load float, ptr %sunkaddr40, align 4
  %scevgep496.5 = getelementptr i8, ptr %scevgep497.5, i64 44
  store float %.1007.1.5, ptr %scevgep496.5, align 4
  %exitcond.not.1.5 = icmp eq i64 %count.2.1, 6
  br i1 %exitcond.not.1.5, label %B562, label %B522.if.6

B522.if.6:                                        ; preds = %B522.if.5
  %.1007.6 = load float, ptr %sunkaddr41, align 4
  %32 = add i64 %.1009, 12
  %.1024.6 = icmp slt i64 %32, 0
  %33 = select i1 %.1024.6, i64 %1, i64 0
  %scevgep497.6 = getelementptr i8, ptr %scevgep493, i64 %33
  %scevgep498.6 = getelementptr i8, ptr %scevgep497.6, i64 48
  store float %.1007.6, ptr %scevgep498.6, align 4
  %.1007.1.6 = load float, ptr %sunkaddr42, align 4
  %scevgep496.6 = getelementptr i8, ptr %scevgep497.6, i64 52
  store float %.1007.1.6, ptr %scevgep496.6, align 4
  br label %B562

B656.if.lr.ph:                                    ; preds = %B566
  %.1269 = shl i64 %j.2.0, 1
  %34 = shl i64 %j.2.0, 3
  %scevgep502 = getelementptr i8, ptr %arg.second.4, i64 %34
  %35 = add nuw i64 %12, 9223372036854775807
  %36 = icmp eq i64 %count.2.1, 1
  br i1 %36, label %B656.if.epil.preheader, label %B656.if.lr.ph.new

B656.if.lr.ph.new:                                ; preds = %B656.if.lr.ph
  %37 = and i64 %35, 9223372036854775807
  %38 = add nuw i64 %37, 1
  %39 = add i64 %.1269, 2
  %40 = and i64 %38, -2
  br label %B656.if

B656.if:                                          ; preds = %B656.if, %B656.if.lr.ph.new
  %lsr.iv = phi i64 [ %lsr.iv.next, %B656.if ], [ %40, %B656.if.lr.ph.new ]
  %.1206861863 = phi i64 [ %.1213.1.1, %B656.if ], [ 0, %B656.if.lr.ph.new ]
  %sunkaddr43 = shl i64 %.1206861863, 2
  %sunkaddr44 = getelementptr i8, ptr %arg.tail.4, i64 %sunkaddr43
  %.1267 = load float, ptr %sunkaddr44, align 4
  %41 = add i64 %.1206861863, %.1269
  %.1284 = icmp slt i64 %41, 0
  %42 = select i1 %.1284, i64 %4, i64 4
  %scevgep9 = getelementptr i8, ptr %scevgep502, i64 %42
  %scevgep14 = getelementptr i8, ptr %scevgep9, i64 %sunkaddr43
  %scevgep15 = getelementptr i8, ptr %scevgep14, i64 -4
  store float %.1267, ptr %scevgep15, align 4
  %sunkaddr47 = getelementptr i8, ptr %sunkaddr44, i64 4
  %.1267.1 = load float, ptr %sunkaddr47, align 4
  store float %.1267.1, ptr %scevgep14, align 4
  %sunkaddr50 = getelementptr i8, ptr %sunkaddr44, i64 8
  %.1267.13 = load float, ptr %sunkaddr50, align 4
  %43 = add i64 %39, %.1206861863
  %.1284.1 = icmp slt i64 %43, 0
  %44 = select i1 %.1284.1, i64 %5, i64 12
  %scevgep2 = getelementptr i8, ptr %scevgep502, i64 %44
  %scevgep4 = getelementptr i8, ptr %scevgep2, i64 %sunkaddr43
  %scevgep6 = getelementptr i8, ptr %scevgep4, i64 -4
  store float %.1267.13, ptr %scevgep6, align 4
  %.1213.1.1 = add i64 %.1206861863, 4
  %sunkaddr51 = shl i64 %.1213.1.1, 2
  %sunkaddr52 = getelementptr i8, ptr %arg.tail.4, i64 %sunkaddr51
  %sunkaddr53 = getelementptr i8, ptr %sunkaddr52, i64 -4
  %.1267.1.1 = load float, ptr %sunkaddr53, align 4
  store float %.1267.1.1, ptr %scevgep4, align 4
  %lsr.iv.next = add i64 %lsr.iv, -2
  %niter.ncmp.1 = icmp eq i64 %lsr.iv.next, 0
  br i1 %niter.ncmp.1, label %B924.loopexit.unr-lcssa, label %B656.if
}

; Function Attrs: nofree noinline norecurse nosync nounwind memory(argmem: write)
define internal fastcc void @inner_14(ptr noalias nonnull writeonly captures(none) %retptr, ptr writeonly captures(none) %arg.first.4, i64 range(i64 -9223372036854775808, 9223372036854775807) %arg.first.5.0, ptr writeonly captures(none) %arg.second.4, i64 range(i64 -9223372036854775808, 9223372036854775807) %arg.second.5.0, i64 range(i64 -9223372036854775808, 9223372036854775807) %arg.start) unnamed_addr #8 {
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
  br i1 %prol.iter.cmp.not, label %B58.if.prol.loopexit.loopexit, label %B58.if.prol, !llvm.loop !127

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
  br i1 %prol.iter3.cmp.not, label %B128.if.prol.loopexit.loopexit, label %B128.if.prol, !llvm.loop !128

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
define internal fastcc void @inner_15(ptr noalias nonnull writeonly captures(none) %retptr, ptr writeonly captures(none) %arg.first.4, i64 range(i64 -9223372036854775808, 9223372036854775807) %arg.first.5.0, ptr writeonly captures(none) %arg.second.4, i64 range(i64 -9223372036854775808, 9223372036854775807) %arg.second.5.0, i64 range(i64 -9223372036854775808, 9223372036854775807) %arg.start) unnamed_addr #8 {
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
  br i1 %prol.iter.cmp.not, label %B58.if.prol.loopexit.loopexit, label %B58.if.prol, !llvm.loop !129

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
  br i1 %prol.iter3.cmp.not, label %B128.if.prol.loopexit.loopexit, label %B128.if.prol, !llvm.loop !130

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

; Function Attrs: mustprogress nocallback nofree nosync nounwind willreturn memory(none)
declare double @sqrt(double) local_unnamed_addr #9

; Function Attrs: nofree noinline norecurse nosync nounwind memory(argmem: readwrite)
define internal fastcc void @inner_6(ptr noalias nonnull writeonly captures(none) %retptr, ptr readonly captures(none) %arg.parameters.4, ptr readonly captures(none) %arg.contents.4, ptr readonly captures(none) %arg.scaling.4, ptr captures(none) initializes((0, 40)) %arg.scratch.4, ptr writeonly captures(none) %arg.out.4) unnamed_addr #7 {
entry:
  %scevgep = getelementptr i8, ptr %arg.out.4, i64 256
  %sunkaddr37 = getelementptr i8, ptr %arg.scaling.4, i64 40
  %sunkaddr43 = getelementptr i8, ptr %arg.scratch.4, i64 8
  %sunkaddr49 = getelementptr i8, ptr %arg.scaling.4, i64 8
  %sunkaddr50 = getelementptr i8, ptr %arg.scaling.4, i64 48
  %sunkaddr55 = getelementptr i8, ptr %arg.scratch.4, i64 16
  %sunkaddr56 = getelementptr i8, ptr %arg.scaling.4, i64 16
  %sunkaddr58 = getelementptr i8, ptr %arg.scaling.4, i64 56
  %sunkaddr65 = getelementptr i8, ptr %arg.scratch.4, i64 24
  %sunkaddr66 = getelementptr i8, ptr %arg.scaling.4, i64 24
  %sunkaddr67 = getelementptr i8, ptr %arg.scaling.4, i64 64
  %sunkaddr71 = getelementptr i8, ptr %arg.scratch.4, i64 32
  %sunkaddr72 = getelementptr i8, ptr %arg.scaling.4, i64 32
  %sunkaddr73 = getelementptr i8, ptr %arg.scaling.4, i64 72
  %sunkaddr8 = getelementptr i8, ptr %arg.scratch.4, i64 8
  %sunkaddr14 = getelementptr i8, ptr %arg.scratch.4, i64 16
  %sunkaddr25 = getelementptr i8, ptr %arg.scratch.4, i64 24
  %sunkaddr31 = getelementptr i8, ptr %arg.scratch.4, i64 32
  %sunkaddr79 = getelementptr i8, ptr %arg.scratch.4, i64 8
  %sunkaddr83 = getelementptr i8, ptr %arg.scratch.4, i64 16
  %sunkaddr86 = getelementptr i8, ptr %arg.scratch.4, i64 24
  %sunkaddr89 = getelementptr i8, ptr %arg.scratch.4, i64 32
  br label %B64.if

B140:                                             ; preds = %B64.if
  %sunkaddr = shl nuw nsw i64 %lsr.iv10, 3
  %sunkaddr11 = getelementptr i8, ptr %arg.parameters.4, i64 %sunkaddr
  %sunkaddr12 = getelementptr i8, ptr %sunkaddr11, i64 8
  %.646 = load double, ptr %sunkaddr12, align 8
  %sunkaddr15 = getelementptr i8, ptr %sunkaddr11, i64 16
  %.676 = load double, ptr %sunkaddr15, align 8
  %sunkaddr18 = getelementptr i8, ptr %sunkaddr11, i64 24
  %.706 = load double, ptr %sunkaddr18, align 8
  %sunkaddr21 = getelementptr i8, ptr %sunkaddr11, i64 32
  %.736 = load double, ptr %sunkaddr21, align 8
  %.38.le.i = tail call contract double @llvm.log.f64(double %.916)
  %.21.i = fadd contract double %.916, 1.000000e+00
  %.30.i = fdiv contract double 1.000000e+00, %.21.i
  %.25.i = fdiv contract double %.916, %.21.i
  store double %.38.le.i, ptr %arg.scratch.4, align 8, !noalias !131
  %.72.i = tail call contract double @llvm.pow.f64(double %.706, double 4.000000e-01)
  %.73.i = fmul contract double %.25.i, %.72.i
  store double %.73.i, ptr %sunkaddr8, align 8, !noalias !131
  %.103.i = tail call contract double @llvm.pow.f64(double %.736, double 4.000000e-01)
  %.104.i = fmul contract double %.30.i, %.103.i
  store double %.104.i, ptr %sunkaddr14, align 8, !noalias !131
  %.134.i = fmul contract double %.25.i, %.646
  %.135.i = fmul contract double %.30.i, %.676
  %.136.i = fadd contract double %.134.i, %.135.i
  %.137.i = fmul contract double %.25.i, 0x3FD585A9E9585A9F
  %.138.i = fmul contract double %.30.i, %.137.i
  %.139.i = fadd contract double %.646, %.676
  %.140.i = fmul contract double %.138.i, %.139.i
  %.141.i = fsub contract double %.136.i, %.140.i
  store double %.141.i, ptr %sunkaddr25, align 8, !noalias !131
  %.171.i = fsub contract double %.646, %.676
  %.172.i = fmul contract double %.171.i, 5.000000e-01
  store double %.172.i, ptr %sunkaddr31, align 8, !noalias !131
  br label %B300

B300:                                             ; preds = %B272.if, %B140
  %.1103 = load double, ptr %arg.scratch.4, align 8
  %.1133 = load double, ptr %arg.scaling.4, align 8
  %.1134 = fsub contract double %.1103, %.1133
  %.1165 = load double, ptr %sunkaddr37, align 8
  %.1166 = fmul contract double %.1134, %.1165
  %scevgep9 = getelementptr i8, ptr %lsr.iv, i64 -256
  store double %.1166, ptr %scevgep9, align 8
  %.1103.1 = load double, ptr %sunkaddr43, align 8
  %.1133.1 = load double, ptr %sunkaddr49, align 8
  %.1134.1 = fsub contract double %.1103.1, %.1133.1
  %.1165.1 = load double, ptr %sunkaddr50, align 8
  %.1166.1 = fmul contract double %.1134.1, %.1165.1
  %scevgep8 = getelementptr i8, ptr %lsr.iv, i64 -192
  store double %.1166.1, ptr %scevgep8, align 8
  %.1103.2 = load double, ptr %sunkaddr55, align 8
  %.1133.2 = load double, ptr %sunkaddr56, align 8
  %.1134.2 = fsub contract double %.1103.2, %.1133.2
  %.1165.2 = load double, ptr %sunkaddr58, align 8
  %.1166.2 = fmul contract double %.1134.2, %.1165.2
  %scevgep7 = getelementptr i8, ptr %lsr.iv, i64 -128
  store double %.1166.2, ptr %scevgep7, align 8
  %.1103.3 = load double, ptr %sunkaddr65, align 8
  %.1133.3 = load double, ptr %sunkaddr66, align 8
  %.1134.3 = fsub contract double %.1103.3, %.1133.3
  %.1165.3 = load double, ptr %sunkaddr67, align 8
  %.1166.3 = fmul contract double %.1134.3, %.1165.3
  %scevgep6 = getelementptr i8, ptr %lsr.iv, i64 -64
  store double %.1166.3, ptr %scevgep6, align 8
  %.1103.4 = load double, ptr %sunkaddr71, align 8
  %.1133.4 = load double, ptr %sunkaddr72, align 8
  %.1134.4 = fsub contract double %.1103.4, %.1133.4
  %.1165.4 = load double, ptr %sunkaddr73, align 8
  %.1166.4 = fmul contract double %.1134.4, %.1165.4
  store double %.1166.4, ptr %lsr.iv, align 8
  %scevgep5 = getelementptr i8, ptr %lsr.iv, i64 8
  %lsr.iv.next = add nuw nsw i64 %lsr.iv10, 5
  %exitcond.not = icmp eq i64 %lsr.iv.next, 40
  br i1 %exitcond.not, label %B424, label %B64.if

B424:                                             ; preds = %B300
  store ptr null, ptr %retptr, align 8
  ret void

B64.if:                                           ; preds = %B300, %entry
  %lsr.iv10 = phi i64 [ 0, %entry ], [ %lsr.iv.next, %B300 ]
  %lsr.iv = phi ptr [ %scevgep, %entry ], [ %scevgep5, %B300 ]
  %.517 = getelementptr double, ptr %arg.parameters.4, i64 %lsr.iv10
  %.584 = load i64, ptr %arg.contents.4, align 8
  %.585.not = icmp eq i64 %.584, 0
  %.916 = load double, ptr %.517, align 8
  br i1 %.585.not, label %B272.if, label %B140

B272.if:                                          ; preds = %B64.if
  store double %.916, ptr %arg.scratch.4, align 8
  %sunkaddr61 = shl nuw nsw i64 %lsr.iv10, 3
  %sunkaddr62 = getelementptr i8, ptr %arg.parameters.4, i64 %sunkaddr61
  %sunkaddr63 = getelementptr i8, ptr %sunkaddr62, i64 8
  %.916.1 = load double, ptr %sunkaddr63, align 8
  store double %.916.1, ptr %sunkaddr79, align 8
  %sunkaddr69 = getelementptr i8, ptr %sunkaddr62, i64 16
  %.916.2 = load double, ptr %sunkaddr69, align 8
  store double %.916.2, ptr %sunkaddr83, align 8
  %sunkaddr75 = getelementptr i8, ptr %sunkaddr62, i64 24
  %.916.3 = load double, ptr %sunkaddr75, align 8
  store double %.916.3, ptr %sunkaddr86, align 8
  %sunkaddr81 = getelementptr i8, ptr %sunkaddr62, i64 32
  %.916.4 = load double, ptr %sunkaddr81, align 8
  store double %.916.4, ptr %sunkaddr89, align 8
  br label %B300
}

; Function Attrs: nofree noinline norecurse nosync nounwind memory(argmem: readwrite)
define internal fastcc void @inner_7(ptr noalias nonnull writeonly captures(none) %retptr, ptr readonly captures(none) %arg.coordinates.4, i64 %arg.rows, ptr readonly captures(none) %arg.contents.4, ptr readonly captures(none) %arg.layers.4, i64 range(i64 0, 1073741825) %arg.layers.5.0, ptr %arg.scratch.4, i64 range(i64 0, -9223372036854775808) %arg.scratch.5.0, ptr captures(none) %arg.out.4, i64 range(i64 -9223372036854775800, -9223372036854775808) %arg.out_row) unnamed_addr #7 {
entry:
  %.106 = getelementptr i8, ptr %arg.contents.4, i64 40
  %.107 = load i64, ptr %.106, align 8
  %.109 = add i64 %.107, 7
  %.150 = and i64 %.109, -8
  %.151 = add i64 %.150, 8
  %.156 = shl i64 %.151, 3
  %.209 = icmp slt i64 %.107, -15
  %.210 = select i1 %.209, i64 %arg.scratch.5.0, i64 0
  %.211 = add i64 %.156, %.210
  %.214 = icmp slt i64 %.211, 0
  br i1 %.214, label %B0.endif.else.endif.endif.if, label %B0.endif.else.endif.endif.endif, !prof !5

B424:                                             ; preds = %B234.if
  %.978 = getelementptr i8, ptr %arg.contents.4, i64 32
  %.979 = load i64, ptr %.978, align 8
  %.980 = add nsw i64 %.979, -1
  %.1069813.not = icmp slt i64 %.979, 1
  br i1 %.1069813.not, label %B1120, label %B498.if.lr.ph

B498.if.lr.ph:                                    ; preds = %B424
  %.470 = getelementptr double, ptr %arg.scratch.4, i64 %.357.sroa.0.3
  %0 = add nuw i64 %arg.rows, 3
  %.1286 = lshr i64 %0, 2
  %.1265.inv = icmp sgt i64 %arg.rows, 0
  %storemerge762 = select i1 %.1265.inv, i64 %.1286, i64 0
  %.idx686.i = mul i64 %.151, 24
  %1 = icmp eq i64 %storemerge762, 0
  %2 = icmp slt i64 %arg.rows, 1
  %sunkaddr80 = shl i64 %.150, 3
  %sunkaddr92 = getelementptr i8, ptr %arg.contents.4, i64 48
  br label %B498.if

B832:                                             ; preds = %B678.endif.endif.endif.endif, %B498.if
  %.1923 = mul nsw i64 %.1223, %.1144
  %.1927 = add nsw i64 %.1923, %position.2.0818
  %.1935 = icmp sge i64 %.1012.0, %.980
  %or.cond = select i1 %.1935, i1 true, i1 %2
  br i1 %or.cond, label %B1108, label %B890.if.lr.ph

B890.if.lr.ph:                                    ; preds = %B832
  %.2102.inv = icmp sgt i64 %.1180, 0
  %..1190.1 = select i1 %.2102.inv, i64 %.1190.1, i64 0
  %scevgep44 = getelementptr i8, ptr %following.2.sroa.44.0815, i64 64
  %3 = add nsw i64 %..1190.1, 5
  %4 = icmp sgt i64 %..1190.1, 0
  br label %B890.if

B890.loopexit:                                    ; preds = %B990.endif, %B890.if
  %scevgep46 = getelementptr i8, ptr %lsr.iv45, i64 %.156
  %exitcond854.not = icmp eq i64 %arg.rows, %.2032
  br i1 %exitcond854.not, label %B1108, label %B890.if

B1108:                                            ; preds = %B890.loopexit, %B832
  %exitcond.not14 = icmp eq i64 %.1082, %.979
  br i1 %exitcond.not14, label %B1120, label %B498.if

B1120:                                            ; preds = %B1108, %B424
  %current.2.sroa.40.0.lcssa = phi ptr [ %arg.scratch.4, %B424 ], [ %following.2.sroa.44.0815, %B1108 ]
  %columns.1.0.lcssa = phi i64 [ 0, %B424 ], [ %.1223, %B1108 ]
  %.2419835.not = icmp slt i64 %arg.rows, 1
  br i1 %.2419835.not, label %B1346, label %B1150.if.lr.ph

B1150.if.lr.ph:                                   ; preds = %B1120
  %5 = tail call i64 @llvm.smax.i64(i64 %columns.1.0.lcssa, i64 0)
  %storemerge760 = lshr exact i64 %5, 3
  %6 = shl i64 %.109, 3
  %7 = and i64 %6, -64
  %8 = shl i64 %arg.out_row, 3
  %9 = add nuw nsw i64 %storemerge760, 5
  %10 = icmp slt i64 %columns.1.0.lcssa, 1
  br label %B1150.if

B1150.loopexit:                                   ; preds = %B1198.if, %B1150.if
  %11 = getelementptr i8, ptr %lsr.iv15, i64 %7
  %scevgep21 = getelementptr i8, ptr %lsr.iv20, i64 %8
  %exitcond856.not = icmp eq i64 %.2432, %arg.rows
  br i1 %exitcond856.not, label %B1346, label %B1150.if

B1346:                                            ; preds = %B1150.loopexit, %B1120
  store ptr null, ptr %retptr, align 8
  ret void

B0.endif.else.endif.endif.if:                     ; preds = %entry
  br label %B0.endif.else.endif.endif.endif

B0.endif.else.endif.endif.endif:                  ; preds = %B0.endif.else.endif.endif.if, %entry
  %.182.sroa.13.1 = phi i64 [ 0, %B0.endif.else.endif.endif.if ], [ %.211, %entry ]
  %.219.not = icmp slt i64 %.211, %arg.scratch.5.0
  br i1 %.219.not, label %B0.endif.else.endif.endif.endif.endif, label %B0.endif.else.endif.endif.endif.if, !prof !1

B0.endif.else.endif.endif.endif.if:               ; preds = %B0.endif.else.endif.endif.endif
  br label %B0.endif.else.endif.endif.endif.endif

B0.endif.else.endif.endif.endif.endif:            ; preds = %B0.endif.else.endif.endif.endif.if, %B0.endif.else.endif.endif.endif
  %.182.sroa.13.2 = phi i64 [ %arg.scratch.5.0, %B0.endif.else.endif.endif.endif.if ], [ %.182.sroa.13.1, %B0.endif.else.endif.endif.endif ]
  %.331 = shl i64 %.151, 4
  br i1 %.214, label %B0.endif.endif.else.if, label %B0.endif.endif.else.endif, !prof !5

B0.endif.endif.else.if:                           ; preds = %B0.endif.else.endif.endif.endif.endif
  br label %B0.endif.endif.else.endif

B0.endif.endif.else.endif:                        ; preds = %B0.endif.endif.else.if, %B0.endif.else.endif.endif.endif.endif
  %.357.sroa.0.1 = phi i64 [ 0, %B0.endif.endif.else.if ], [ %.211, %B0.endif.else.endif.endif.endif.endif ]
  br i1 %.219.not, label %B0.endif.endif.else.endif.endif, label %B0.endif.endif.else.endif.if, !prof !1

B0.endif.endif.else.endif.if:                     ; preds = %B0.endif.endif.else.endif
  br label %B0.endif.endif.else.endif.endif

B0.endif.endif.else.endif.endif:                  ; preds = %B0.endif.endif.else.endif.if, %B0.endif.endif.else.endif
  %.357.sroa.0.3 = phi i64 [ %arg.scratch.5.0, %B0.endif.endif.else.endif.if ], [ %.357.sroa.0.1, %B0.endif.endif.else.endif ]
  %.386 = add i64 %.331, %.210
  %.389 = icmp slt i64 %.386, 0
  br i1 %.389, label %B0.endif.endif.else.endif.endif.if, label %B0.endif.endif.else.endif.endif.endif, !prof !5

B0.endif.endif.else.endif.endif.if:               ; preds = %B0.endif.endif.else.endif.endif
  br label %B0.endif.endif.else.endif.endif.endif

B0.endif.endif.else.endif.endif.endif:            ; preds = %B0.endif.endif.else.endif.endif.if, %B0.endif.endif.else.endif.endif
  %.357.sroa.13.1 = phi i64 [ 0, %B0.endif.endif.else.endif.endif.if ], [ %.386, %B0.endif.endif.else.endif.endif ]
  %.394.not = icmp slt i64 %.386, %arg.scratch.5.0
  br i1 %.394.not, label %B0.endif.endif.else.endif.endif.endif.endif, label %B0.endif.endif.else.endif.endif.endif.if, !prof !1

B0.endif.endif.else.endif.endif.endif.if:         ; preds = %B0.endif.endif.else.endif.endif.endif
  br label %B0.endif.endif.else.endif.endif.endif.endif

B0.endif.endif.else.endif.endif.endif.endif:      ; preds = %B0.endif.endif.else.endif.endif.endif.if, %B0.endif.endif.else.endif.endif.endif
  %.357.sroa.13.2 = phi i64 [ %arg.scratch.5.0, %B0.endif.endif.else.endif.endif.endif.if ], [ %.357.sroa.13.1, %B0.endif.endif.else.endif.endif.endif ]
  %.445 = sub nsw i64 %.357.sroa.13.2, %.357.sroa.0.3
  %.454 = tail call i64 @llvm.smax.i64(i64 %.445, i64 0)
  %12 = shl i64 %.357.sroa.0.3, 3
  %13 = shl i64 %.182.sroa.13.2, 3
  %14 = shl i64 %.454, 3
  %15 = add i64 %13, 56
  %16 = add i64 %13, 64
  %17 = add i64 %13, 72
  %18 = add i64 %13, 80
  %19 = add i64 %13, 88
  %20 = add i64 %13, 96
  br label %B234.if

B234.if:                                          ; preds = %B234.if, %B0.endif.endif.else.endif.endif.endif.endif
  %lsr.iv = phi ptr [ %scevgep45, %B234.if ], [ %arg.scratch.4, %B0.endif.endif.else.endif.endif.endif.endif ]
  %lsr.iv52 = phi i64 [ %lsr.iv.next53, %B234.if ], [ -64, %B0.endif.endif.else.endif.endif.endif.endif ]
  %lsr.iv61 = phi i64 [ %lsr.iv.next62, %B234.if ], [ 0, %B0.endif.endif.else.endif.endif.endif.endif ]
  %.663 = icmp slt i64 %lsr.iv61, 0
  %21 = select i1 %.663, i64 %15, i64 56
  %scevgep43 = getelementptr i8, ptr %lsr.iv, i64 %21
  store double 1.000000e+00, ptr %scevgep43, align 8
  %22 = select i1 %.663, i64 %14, i64 0
  %23 = getelementptr i8, ptr %lsr.iv, i64 %12
  %24 = getelementptr i8, ptr %23, i64 56
  %scevgep37 = getelementptr i8, ptr %24, i64 %22
  store double 1.000000e+00, ptr %scevgep37, align 8
  %sunkaddr = getelementptr i8, ptr %arg.coordinates.4, i64 %lsr.iv52
  %sunkaddr67 = getelementptr i8, ptr %sunkaddr, i64 64
  %.864 = load double, ptr %sunkaddr67, align 8
  %.883 = icmp slt i64 %lsr.iv61, -8
  %25 = select i1 %.883, i64 %16, i64 64
  %scevgep42 = getelementptr i8, ptr %lsr.iv, i64 %25
  store double %.864, ptr %scevgep42, align 8
  %sunkaddr70 = getelementptr i8, ptr %sunkaddr, i64 128
  %.864.1 = load double, ptr %sunkaddr70, align 8
  %.883.1 = icmp slt i64 %lsr.iv61, -9
  %26 = select i1 %.883.1, i64 %17, i64 72
  %scevgep41 = getelementptr i8, ptr %lsr.iv, i64 %26
  store double %.864.1, ptr %scevgep41, align 8
  %sunkaddr73 = getelementptr i8, ptr %sunkaddr, i64 192
  %.864.2 = load double, ptr %sunkaddr73, align 8
  %.883.2 = icmp slt i64 %lsr.iv61, -10
  %27 = select i1 %.883.2, i64 %18, i64 80
  %scevgep40 = getelementptr i8, ptr %lsr.iv, i64 %27
  store double %.864.2, ptr %scevgep40, align 8
  %sunkaddr77 = getelementptr i8, ptr %sunkaddr, i64 256
  %.864.3 = load double, ptr %sunkaddr77, align 8
  %.883.3 = icmp slt i64 %lsr.iv61, -11
  %28 = select i1 %.883.3, i64 %19, i64 88
  %scevgep39 = getelementptr i8, ptr %lsr.iv, i64 %28
  store double %.864.3, ptr %scevgep39, align 8
  %sunkaddr79 = getelementptr i8, ptr %sunkaddr, i64 320
  %.864.4 = load double, ptr %sunkaddr79, align 8
  %.883.4 = icmp slt i64 %lsr.iv61, -12
  %29 = select i1 %.883.4, i64 %20, i64 96
  %scevgep38 = getelementptr i8, ptr %lsr.iv, i64 %29
  store double %.864.4, ptr %scevgep38, align 8
  %lsr.iv.next62 = add i64 %lsr.iv61, %.151
  %lsr.iv.next53 = add nsw i64 %lsr.iv52, 8
  %scevgep45 = getelementptr i8, ptr %lsr.iv, i64 %.156
  %ov = icmp eq i64 %lsr.iv.next53, 0
  br i1 %ov, label %B424, label %B234.if

B498.if:                                          ; preds = %B1108, %B498.if.lr.ph
  %.1012.0 = phi i64 [ 0, %B498.if.lr.ph ], [ %.1082, %B1108 ]
  %position.2.0818 = phi i64 [ 0, %B498.if.lr.ph ], [ %.1927, %B1108 ]
  %current.2.sroa.40.0817 = phi ptr [ %arg.scratch.4, %B498.if.lr.ph ], [ %following.2.sroa.44.0815, %B1108 ]
  %current.2.sroa.50.0816 = phi i64 [ %.182.sroa.13.2, %B498.if.lr.ph ], [ %following.2.sroa.55.0814, %B1108 ]
  %following.2.sroa.44.0815 = phi ptr [ %.470, %B498.if.lr.ph ], [ %current.2.sroa.40.0817, %B1108 ]
  %following.2.sroa.55.0814 = phi i64 [ %.454, %B498.if.lr.ph ], [ %current.2.sroa.50.0816, %B1108 ]
  %.1082 = add nuw nsw i64 %.1012.0, 1
  %30 = getelementptr i64, ptr %arg.contents.4, i64 %.1012.0
  %31 = getelementptr i8, ptr %30, i64 168
  %.1143 = load i64, ptr %31, align 8
  %.1144 = add i64 %.1143, 1
  %32 = getelementptr i8, ptr %30, i64 176
  %.1180 = load i64, ptr %32, align 8
  %.1182 = add nsw i64 %.1180, 7
  %.1190.1 = ashr i64 %.1182, 3
  %.1223 = and i64 %.1182, -8
  br i1 %1, label %B832, label %B676.if.lr.ph

B676.if.lr.ph:                                    ; preds = %B498.if
  %.1738 = icmp slt i64 %position.2.0818, 0
  %.1739 = select i1 %.1738, i64 %arg.layers.5.0, i64 0
  %.1740 = add i64 %.1739, %position.2.0818
  %33 = tail call i64 @llvm.smax.i64(i64 %.1223, i64 31)
  %storemerge.i = lshr i64 %33, 5
  %.991.i = and i64 %.1182, 24
  %.arg.count.i = tail call i64 @llvm.smax.i64(i64 %.1144, i64 0)
  %34 = shl i64 %.arg.count.i, 5
  %.951.i = and i64 %.1182, -32
  %.1011678.i = lshr exact i64 %.991.i, 3
  %35 = shl i64 %.arg.count.i, 3
  %36 = icmp slt i64 %.1740, 0
  %37 = icmp slt i64 %.1740, %arg.layers.5.0
  %38 = icmp eq i64 %storemerge.i, 0
  %39 = icmp eq i64 %.991.i, 0
  %40 = icmp slt i64 %.1143, 0
  %41 = icmp slt i64 %.1143, 0
  br label %B676.if

B676.if:                                          ; preds = %B678.endif.endif.endif.endif, %B676.if.lr.ph
  %.1251.0 = phi i64 [ 0, %B676.if.lr.ph ], [ %.1320, %B678.endif.endif.endif.endif ]
  %.1306791 = phi i64 [ %storemerge762, %B676.if.lr.ph ], [ %.1316, %B678.endif.endif.endif.endif ]
  %.1316 = add nsw i64 %.1306791, -1
  %.1320 = add nuw i64 %.1251.0, 4
  %.1346 = mul nsw i64 %.1251.0, %.151
  %.1347 = or disjoint i64 %.1346, 8
  %.1348 = or disjoint i64 %.1346, 7
  %.1385 = icmp slt i64 %.1346, 0
  %.1386 = select i1 %.1385, i64 %current.2.sroa.50.0816, i64 0
  %.1387 = add i64 %.1386, %.1348
  %.1390 = icmp slt i64 %.1387, 0
  br i1 %.1390, label %B678.else.if, label %B678.else.endif, !prof !5

B678.else.if:                                     ; preds = %B676.if
  br label %B678.else.endif

B678.else.endif:                                  ; preds = %B678.else.if, %B676.if
  %.1375.sroa.0.1 = phi i64 [ 0, %B678.else.if ], [ %.1387, %B676.if ]
  %.1395.not = icmp slt i64 %.1387, %current.2.sroa.50.0816
  br i1 %.1395.not, label %B678.else.endif.endif, label %B678.else.endif.if, !prof !1

B678.else.endif.if:                               ; preds = %B678.else.endif
  br label %B678.else.endif.endif

B678.else.endif.endif:                            ; preds = %B678.else.endif.if, %B678.else.endif
  %.1375.sroa.0.3 = phi i64 [ %current.2.sroa.50.0816, %B678.else.endif.if ], [ %.1375.sroa.0.1, %B678.else.endif ]
  %.1488 = getelementptr double, ptr %current.2.sroa.40.0817, i64 %.1375.sroa.0.3
  %.1559 = icmp slt i64 %.1346, -8
  %.1560 = select i1 %.1559, i64 %following.2.sroa.55.0814, i64 0
  %.1561 = add i64 %.1560, %.1347
  %.1564 = icmp slt i64 %.1561, 0
  br i1 %.1564, label %B678.endif.else.if, label %B678.endif.else.endif, !prof !5

B678.endif.else.if:                               ; preds = %B678.else.endif.endif
  br label %B678.endif.else.endif

B678.endif.else.endif:                            ; preds = %B678.endif.else.if, %B678.else.endif.endif
  %.1549.sroa.0.1 = phi i64 [ 0, %B678.endif.else.if ], [ %.1561, %B678.else.endif.endif ]
  %.1569.not = icmp slt i64 %.1561, %following.2.sroa.55.0814
  br i1 %.1569.not, label %B678.endif.else.endif.endif, label %B678.endif.else.endif.if, !prof !1

B678.endif.else.endif.if:                         ; preds = %B678.endif.else.endif
  br label %B678.endif.else.endif.endif

B678.endif.else.endif.endif:                      ; preds = %B678.endif.else.endif.if, %B678.endif.else.endif
  %.1549.sroa.0.3 = phi i64 [ %following.2.sroa.55.0814, %B678.endif.else.endif.if ], [ %.1549.sroa.0.1, %B678.endif.else.endif ]
  %.1662 = getelementptr double, ptr %following.2.sroa.44.0815, i64 %.1549.sroa.0.3
  br i1 %36, label %B678.endif.endif.else.if, label %B678.endif.endif.else.endif, !prof !5

B678.endif.endif.else.if:                         ; preds = %B678.endif.else.endif.endif
  br label %B678.endif.endif.else.endif

B678.endif.endif.else.endif:                      ; preds = %B678.endif.endif.else.if, %B678.endif.else.endif.endif
  %.1728.sroa.0.1 = phi i64 [ 0, %B678.endif.endif.else.if ], [ %.1740, %B678.endif.else.endif.endif ]
  br i1 %37, label %B678.endif.endif.else.endif.endif, label %B678.endif.endif.else.endif.if, !prof !1

B678.endif.endif.else.endif.if:                   ; preds = %B678.endif.endif.else.endif
  br label %B678.endif.endif.else.endif.endif

B678.endif.endif.else.endif.endif:                ; preds = %B678.endif.endif.else.endif.if, %B678.endif.endif.else.endif
  %.1728.sroa.0.3 = phi i64 [ %arg.layers.5.0, %B678.endif.endif.else.endif.if ], [ %.1728.sroa.0.1, %B678.endif.endif.else.endif ]
  %.1841 = getelementptr double, ptr %arg.layers.4, i64 %.1728.sroa.0.3
  br i1 %38, label %B2140.else.i, label %B86.if.lr.ph.i

B86.if.lr.ph.i:                                   ; preds = %B678.endif.endif.else.endif.endif
  %42 = getelementptr double, ptr %.1488, i64 %.151
  %43 = getelementptr i8, ptr %.1488, i64 %.331
  %44 = getelementptr i8, ptr %.1488, i64 %.idx686.i
  %scevgep8.i = getelementptr i8, ptr %.1841, i64 192
  br label %B86.if.i

B1232.loopexit.i:                                 ; preds = %B290.if.i
  %45 = add i64 %position.4.0737.i, %34
  br label %B1232.i

B1232.i:                                          ; preds = %B86.if.i, %B1232.loopexit.i
  %position.3.1.lcssa.i = phi i64 [ %position.4.0737.i, %B86.if.i ], [ %45, %B1232.loopexit.i ]
  %a00.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B86.if.i ], [ %.477.i, %B1232.loopexit.i ]
  %a01.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B86.if.i ], [ %.481.i, %B1232.loopexit.i ]
  %a02.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B86.if.i ], [ %.489.i, %B1232.loopexit.i ]
  %a03.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B86.if.i ], [ %.493.i, %B1232.loopexit.i ]
  %a10.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B86.if.i ], [ %.514.i, %B1232.loopexit.i ]
  %a11.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B86.if.i ], [ %.518.i, %B1232.loopexit.i ]
  %a12.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B86.if.i ], [ %.526.i, %B1232.loopexit.i ]
  %a13.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B86.if.i ], [ %.530.i, %B1232.loopexit.i ]
  %a20.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B86.if.i ], [ %.552.i, %B1232.loopexit.i ]
  %a21.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B86.if.i ], [ %.556.i, %B1232.loopexit.i ]
  %a22.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B86.if.i ], [ %.564.i, %B1232.loopexit.i ]
  %a23.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B86.if.i ], [ %.568.i, %B1232.loopexit.i ]
  %a30.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B86.if.i ], [ %.590.i, %B1232.loopexit.i ]
  %a31.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B86.if.i ], [ %.594.i, %B1232.loopexit.i ]
  %a32.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B86.if.i ], [ %.602.i, %B1232.loopexit.i ]
  %a33.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B86.if.i ], [ %.606.i, %B1232.loopexit.i ]
  %.630.i = getelementptr inbounds nuw double, ptr %.1662, i64 %.194729735.i
  store <8 x double> %a00.2.1.lcssa.i, ptr %.630.i, align 8, !noalias !134
  %.645.i = getelementptr i8, ptr %.630.i, i64 64
  store <8 x double> %a01.2.1.lcssa.i, ptr %.645.i, align 8, !noalias !134
  %.661.i = getelementptr i8, ptr %.630.i, i64 128
  store <8 x double> %a02.2.1.lcssa.i, ptr %.661.i, align 8, !noalias !134
  %.677.i = getelementptr i8, ptr %.630.i, i64 192
  store <8 x double> %a03.2.1.lcssa.i, ptr %.677.i, align 8, !noalias !134
  %sunkaddr81 = getelementptr i8, ptr %.630.i, i64 %sunkaddr80
  %sunkaddr82 = getelementptr i8, ptr %sunkaddr81, i64 64
  store <8 x double> %a10.2.1.lcssa.i, ptr %sunkaddr82, align 8, !noalias !134
  %sunkaddr85 = getelementptr i8, ptr %sunkaddr81, i64 128
  store <8 x double> %a11.2.1.lcssa.i, ptr %sunkaddr85, align 8, !noalias !134
  %sunkaddr88 = getelementptr i8, ptr %sunkaddr81, i64 192
  store <8 x double> %a12.2.1.lcssa.i, ptr %sunkaddr88, align 8, !noalias !134
  %sunkaddr91 = getelementptr i8, ptr %sunkaddr81, i64 256
  store <8 x double> %a13.2.1.lcssa.i, ptr %sunkaddr91, align 8, !noalias !134
  %.763.i = getelementptr i8, ptr %.630.i, i64 %.331
  store <8 x double> %a20.2.1.lcssa.i, ptr %.763.i, align 8, !noalias !134
  %.781.i = getelementptr i8, ptr %.763.i, i64 64
  store <8 x double> %a21.2.1.lcssa.i, ptr %.781.i, align 8, !noalias !134
  %.800.i = getelementptr i8, ptr %.763.i, i64 128
  store <8 x double> %a22.2.1.lcssa.i, ptr %.800.i, align 8, !noalias !134
  %.819.i = getelementptr i8, ptr %.763.i, i64 192
  store <8 x double> %a23.2.1.lcssa.i, ptr %.819.i, align 8, !noalias !134
  %.836.i = getelementptr i8, ptr %.630.i, i64 %.idx686.i
  store <8 x double> %a30.2.1.lcssa.i, ptr %.836.i, align 8, !noalias !134
  %.854.i = getelementptr i8, ptr %.836.i, i64 64
  store <8 x double> %a31.2.1.lcssa.i, ptr %.854.i, align 8, !noalias !134
  %.873.i = getelementptr i8, ptr %.836.i, i64 128
  store <8 x double> %a32.2.1.lcssa.i, ptr %.873.i, align 8, !noalias !134
  %.894.i = getelementptr i8, ptr %.836.i, i64 192
  store <8 x double> %a33.2.1.lcssa.i, ptr %.894.i, align 8, !noalias !134
  %.188.i = icmp sgt i64 %.187728736.i, 1
  br i1 %.188.i, label %B86.if.i, label %B2140.else.i

B2654.loopexit.i:                                 ; preds = %B2294.if.i
  %46 = add i64 %position.6.0769.i, %35
  br label %B2654.i

B2654.i:                                          ; preds = %B2218.if.i, %B2654.loopexit.i
  %position.5.1.lcssa.i = phi i64 [ %position.6.0769.i, %B2218.if.i ], [ %46, %B2654.loopexit.i ]
  %b0.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B2218.if.i ], [ %.1243.i, %B2654.loopexit.i ]
  %b1.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B2218.if.i ], [ %.1262.i, %B2654.loopexit.i ]
  %b2.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B2218.if.i ], [ %.1282.i, %B2654.loopexit.i ]
  %b3.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B2218.if.i ], [ %.1302.i, %B2654.loopexit.i ]
  %.1324.i = getelementptr inbounds double, ptr %.1662, i64 %.1041761767.i
  store <8 x double> %b0.2.1.lcssa.i, ptr %.1324.i, align 8, !noalias !134
  %.1340.i = getelementptr double, ptr %52, i64 %.1041761767.i
  store <8 x double> %b1.2.1.lcssa.i, ptr %.1340.i, align 8, !noalias !134
  %.1357.i = getelementptr double, ptr %53, i64 %.1041761767.i
  store <8 x double> %b2.2.1.lcssa.i, ptr %.1357.i, align 8, !noalias !134
  %.1376.i = getelementptr double, ptr %54, i64 %.1041761767.i
  store <8 x double> %b3.2.1.lcssa.i, ptr %.1376.i, align 8, !noalias !134
  %.1035.i = icmp sgt i64 %.1034760768.i, 1
  br i1 %.1035.i, label %B2218.if.i, label %B678.endif.endif.endif.endif

B86.if.i:                                         ; preds = %B1232.i, %B86.if.lr.ph.i
  %position.4.0737.i = phi i64 [ 0, %B86.if.lr.ph.i ], [ %position.3.1.lcssa.i, %B1232.i ]
  %.187728736.i = phi i64 [ %storemerge.i, %B86.if.lr.ph.i ], [ %.197.i, %B1232.i ]
  %.194729735.i = phi i64 [ 0, %B86.if.lr.ph.i ], [ %.201.i, %B1232.i ]
  %.197.i = add nsw i64 %.187728736.i, -1
  %.201.i = add nuw nsw i64 %.194729735.i, 32
  br i1 %40, label %B1232.i, label %B290.if.preheader.i

B290.if.preheader.i:                              ; preds = %B86.if.i
  %47 = shl i64 %position.4.0737.i, 3
  %scevgep9.i = getelementptr i8, ptr %scevgep8.i, i64 %47
  br label %B290.if.i

B290.if.i:                                        ; preds = %B290.if.i, %B290.if.preheader.i
  %lsr.iv23 = phi i64 [ %lsr.iv.next24, %B290.if.i ], [ -1, %B290.if.preheader.i ]
  %lsr.iv10.i = phi ptr [ %scevgep11.i, %B290.if.i ], [ %scevgep9.i, %B290.if.preheader.i ]
  %a33.2.1709.i = phi <8 x double> [ %.606.i, %B290.if.i ], [ zeroinitializer, %B290.if.preheader.i ]
  %a32.2.1708.i = phi <8 x double> [ %.602.i, %B290.if.i ], [ zeroinitializer, %B290.if.preheader.i ]
  %a31.2.1707.i = phi <8 x double> [ %.594.i, %B290.if.i ], [ zeroinitializer, %B290.if.preheader.i ]
  %a30.2.1706.i = phi <8 x double> [ %.590.i, %B290.if.i ], [ zeroinitializer, %B290.if.preheader.i ]
  %a23.2.1705.i = phi <8 x double> [ %.568.i, %B290.if.i ], [ zeroinitializer, %B290.if.preheader.i ]
  %a22.2.1704.i = phi <8 x double> [ %.564.i, %B290.if.i ], [ zeroinitializer, %B290.if.preheader.i ]
  %a21.2.1703.i = phi <8 x double> [ %.556.i, %B290.if.i ], [ zeroinitializer, %B290.if.preheader.i ]
  %a20.2.1702.i = phi <8 x double> [ %.552.i, %B290.if.i ], [ zeroinitializer, %B290.if.preheader.i ]
  %a13.2.1701.i = phi <8 x double> [ %.530.i, %B290.if.i ], [ zeroinitializer, %B290.if.preheader.i ]
  %a12.2.1700.i = phi <8 x double> [ %.526.i, %B290.if.i ], [ zeroinitializer, %B290.if.preheader.i ]
  %a11.2.1699.i = phi <8 x double> [ %.518.i, %B290.if.i ], [ zeroinitializer, %B290.if.preheader.i ]
  %a10.2.1698.i = phi <8 x double> [ %.514.i, %B290.if.i ], [ zeroinitializer, %B290.if.preheader.i ]
  %a03.2.1697.i = phi <8 x double> [ %.493.i, %B290.if.i ], [ zeroinitializer, %B290.if.preheader.i ]
  %a02.2.1696.i = phi <8 x double> [ %.489.i, %B290.if.i ], [ zeroinitializer, %B290.if.preheader.i ]
  %a01.2.1695.i = phi <8 x double> [ %.481.i, %B290.if.i ], [ zeroinitializer, %B290.if.preheader.i ]
  %a00.2.1694.i = phi <8 x double> [ %.477.i, %B290.if.i ], [ zeroinitializer, %B290.if.preheader.i ]
  %scevgep14.i = getelementptr i8, ptr %lsr.iv10.i, i64 -192
  %.420.i = load <8 x double>, ptr %scevgep14.i, align 8, !noalias !134
  %scevgep13.i = getelementptr i8, ptr %lsr.iv10.i, i64 -128
  %.432.i = load <8 x double>, ptr %scevgep13.i, align 8, !noalias !134
  %scevgep12.i = getelementptr i8, ptr %lsr.iv10.i, i64 -64
  %.445.i = load <8 x double>, ptr %scevgep12.i, align 8, !noalias !134
  %.458.i = load <8 x double>, ptr %lsr.iv10.i, align 8, !noalias !134
  %48 = shl i64 %lsr.iv23, 3
  %scevgep31 = getelementptr i8, ptr %.1488, i64 %48
  %scevgep32 = getelementptr i8, ptr %scevgep31, i64 8
  %.473.i = load double, ptr %scevgep32, align 8, !noalias !134
  %.475.i = insertelement <8 x double> poison, double %.473.i, i64 0
  %.476.i = shufflevector <8 x double> %.475.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.477.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.420.i, <8 x double> %.476.i, <8 x double> %a00.2.1694.i)
  %.481.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.432.i, <8 x double> %.476.i, <8 x double> %a01.2.1695.i)
  %.489.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.445.i, <8 x double> %.476.i, <8 x double> %a02.2.1696.i)
  %.493.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.458.i, <8 x double> %.476.i, <8 x double> %a03.2.1697.i)
  %scevgep20 = getelementptr i8, ptr %42, i64 %48
  %scevgep23 = getelementptr i8, ptr %scevgep20, i64 8
  %.510.i = load double, ptr %scevgep23, align 8, !noalias !134
  %.512.i = insertelement <8 x double> poison, double %.510.i, i64 0
  %.513.i = shufflevector <8 x double> %.512.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.514.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.420.i, <8 x double> %.513.i, <8 x double> %a10.2.1698.i)
  %.518.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.432.i, <8 x double> %.513.i, <8 x double> %a11.2.1699.i)
  %.526.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.445.i, <8 x double> %.513.i, <8 x double> %a12.2.1700.i)
  %.530.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.458.i, <8 x double> %.513.i, <8 x double> %a13.2.1701.i)
  %scevgep10 = getelementptr i8, ptr %43, i64 %48
  %scevgep11 = getelementptr i8, ptr %scevgep10, i64 8
  %.548.i = load double, ptr %scevgep11, align 8, !noalias !134
  %.550.i = insertelement <8 x double> poison, double %.548.i, i64 0
  %.551.i = shufflevector <8 x double> %.550.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.552.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.420.i, <8 x double> %.551.i, <8 x double> %a20.2.1702.i)
  %.556.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.432.i, <8 x double> %.551.i, <8 x double> %a21.2.1703.i)
  %.564.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.445.i, <8 x double> %.551.i, <8 x double> %a22.2.1704.i)
  %.568.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.458.i, <8 x double> %.551.i, <8 x double> %a23.2.1705.i)
  %scevgep2 = getelementptr i8, ptr %44, i64 %48
  %scevgep3 = getelementptr i8, ptr %scevgep2, i64 8
  %.586.i = load double, ptr %scevgep3, align 8, !noalias !134
  %.588.i = insertelement <8 x double> poison, double %.586.i, i64 0
  %.589.i = shufflevector <8 x double> %.588.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.590.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.420.i, <8 x double> %.589.i, <8 x double> %a30.2.1706.i)
  %.594.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.432.i, <8 x double> %.589.i, <8 x double> %a31.2.1707.i)
  %.602.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.445.i, <8 x double> %.589.i, <8 x double> %a32.2.1708.i)
  %.606.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.458.i, <8 x double> %.589.i, <8 x double> %a33.2.1709.i)
  %scevgep11.i = getelementptr i8, ptr %lsr.iv10.i, i64 256
  %lsr.iv.next24 = add nsw i64 %lsr.iv23, 1
  %exitcond.not.i = icmp eq i64 %.1143, %lsr.iv.next24
  br i1 %exitcond.not.i, label %B1232.loopexit.i, label %B290.if.i

B2140.else.i:                                     ; preds = %B1232.i, %B678.endif.endif.else.endif.endif
  %position.4.0.lcssa.i = phi i64 [ 0, %B678.endif.endif.else.endif.endif ], [ %position.3.1.lcssa.i, %B1232.i ]
  br i1 %39, label %B678.endif.endif.endif.endif, label %B2140.endif.endif.endif.i

B2140.endif.endif.endif.i:                        ; preds = %B2140.else.i
  %49 = getelementptr double, ptr %.1488, i64 %.151
  %50 = getelementptr i8, ptr %.1488, i64 %.331
  %51 = getelementptr i8, ptr %.1488, i64 %.idx686.i
  %52 = getelementptr double, ptr %.1662, i64 %.151
  %53 = getelementptr i8, ptr %.1662, i64 %.331
  %54 = getelementptr i8, ptr %.1662, i64 %.idx686.i
  br label %B2218.if.i

B2218.if.i:                                       ; preds = %B2140.endif.endif.endif.i, %B2654.i
  %position.6.0769.i = phi i64 [ %position.4.0.lcssa.i, %B2140.endif.endif.endif.i ], [ %position.5.1.lcssa.i, %B2654.i ]
  %.1034760768.i = phi i64 [ %.1011678.i, %B2140.endif.endif.endif.i ], [ %.1044.i, %B2654.i ]
  %.1041761767.i = phi i64 [ %.951.i, %B2140.endif.endif.endif.i ], [ %.1048.i, %B2654.i ]
  %.1044.i = add nsw i64 %.1034760768.i, -1
  %.1048.i = add nuw nsw i64 %.1041761767.i, 8
  br i1 %41, label %B2654.i, label %B2294.if.preheader.i

B2294.if.preheader.i:                             ; preds = %B2218.if.i
  %55 = shl i64 %position.6.0769.i, 3
  %scevgep.i = getelementptr i8, ptr %.1841, i64 %55
  br label %B2294.if.i

B2294.if.i:                                       ; preds = %B2294.if.i, %B2294.if.preheader.i
  %lsr.iv27 = phi i64 [ %lsr.iv.next28, %B2294.if.i ], [ %.1144, %B2294.if.preheader.i ]
  %lsr.iv24 = phi i64 [ %lsr.iv.next25, %B2294.if.i ], [ 0, %B2294.if.preheader.i ]
  %b3.2.1752.i = phi <8 x double> [ %.1302.i, %B2294.if.i ], [ zeroinitializer, %B2294.if.preheader.i ]
  %b2.2.1751.i = phi <8 x double> [ %.1282.i, %B2294.if.i ], [ zeroinitializer, %B2294.if.preheader.i ]
  %b1.2.1750.i = phi <8 x double> [ %.1262.i, %B2294.if.i ], [ zeroinitializer, %B2294.if.preheader.i ]
  %b0.2.1749.i = phi <8 x double> [ %.1243.i, %B2294.if.i ], [ zeroinitializer, %B2294.if.preheader.i ]
  %56 = shl i64 %lsr.iv24, 3
  %scevgep26 = getelementptr i8, ptr %scevgep.i, i64 %56
  %.1224.i = load <8 x double>, ptr %scevgep26, align 8, !noalias !134
  %scevgep34 = getelementptr i8, ptr %.1488, i64 %lsr.iv24
  %.1239.i = load double, ptr %scevgep34, align 8, !noalias !134
  %.1241.i = insertelement <8 x double> poison, double %.1239.i, i64 0
  %.1242.i = shufflevector <8 x double> %.1241.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1243.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1224.i, <8 x double> %.1242.i, <8 x double> %b0.2.1749.i)
  %scevgep33 = getelementptr i8, ptr %49, i64 %lsr.iv24
  %.1258.i = load double, ptr %scevgep33, align 8, !noalias !134
  %.1260.i = insertelement <8 x double> poison, double %.1258.i, i64 0
  %.1261.i = shufflevector <8 x double> %.1260.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1262.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1224.i, <8 x double> %.1261.i, <8 x double> %b1.2.1750.i)
  %scevgep30 = getelementptr i8, ptr %50, i64 %lsr.iv24
  %.1278.i = load double, ptr %scevgep30, align 8, !noalias !134
  %.1280.i = insertelement <8 x double> poison, double %.1278.i, i64 0
  %.1281.i = shufflevector <8 x double> %.1280.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1282.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1224.i, <8 x double> %.1281.i, <8 x double> %b2.2.1751.i)
  %scevgep29 = getelementptr i8, ptr %51, i64 %lsr.iv24
  %.1298.i = load double, ptr %scevgep29, align 8, !noalias !134
  %.1300.i = insertelement <8 x double> poison, double %.1298.i, i64 0
  %.1301.i = shufflevector <8 x double> %.1300.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1302.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1224.i, <8 x double> %.1301.i, <8 x double> %b3.2.1752.i)
  %lsr.iv.next25 = add i64 %lsr.iv24, 8
  %lsr.iv.next28 = add i64 %lsr.iv27, -1
  %exitcond774.not.i = icmp eq i64 %lsr.iv.next28, 0
  br i1 %exitcond774.not.i, label %B2654.loopexit.i, label %B2294.if.i

B678.endif.endif.endif.endif:                     ; preds = %B2654.i, %B2140.else.i
  %.1307 = icmp sgt i64 %.1306791, 1
  br i1 %.1307, label %B676.if, label %B832

B890.if:                                          ; preds = %B890.loopexit, %B890.if.lr.ph
  %lsr.iv45 = phi ptr [ %scevgep44, %B890.if.lr.ph ], [ %scevgep46, %B890.loopexit ]
  %.2025800806 = phi i64 [ 0, %B890.if.lr.ph ], [ %.2032, %B890.loopexit ]
  %.2032 = add nuw nsw i64 %.2025800806, 1
  br i1 %4, label %B988.if, label %B890.loopexit

B988.if:                                          ; preds = %B890.if, %B990.endif
  %lsr.iv35 = phi i64 [ %lsr.iv.next36, %B990.endif ], [ %3, %B890.if ]
  %lsr.iv47 = phi ptr [ %scevgep48, %B990.endif ], [ %lsr.iv45, %B890.if ]
  %.2192 = load <8 x double>, ptr %lsr.iv47, align 8
  %.2222 = load i64, ptr %sunkaddr92, align 8
  %.11.i = bitcast <8 x double> %.2192 to <8 x i64>
  %57 = tail call <8 x double> @llvm.fabs.v8f64(<8 x double> %.2192)
  %.8.i.i = bitcast <8 x double> %57 to <8 x i64>
  %.43.i = icmp eq i64 %.2222, 1
  br i1 %.43.i, label %B98.i, label %B114.i

B98.i:                                            ; preds = %B988.if
  %.6.i.i = fadd contract <8 x double> %.2192, %57
  %.8.i3.i = fmul contract <8 x double> %.6.i.i, splat (double 5.000000e-01)
  br label %B990.endif

B114.i:                                           ; preds = %B988.if
  %.106.i = tail call <8 x double> @llvm.minnum.v8f64(<8 x double> %57, <8 x double> splat (double 3.500000e+02))
  %.111.i = icmp eq i64 %.2222, 0
  br i1 %.111.i, label %B168.i, label %B372.i

B168.i:                                           ; preds = %B114.i
  %.8.i1.i = fmul contract <8 x double> %.106.i, splat (double -2.000000e+00)
  %.147.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i1.i, <8 x double> splat (double 0x3FF71547652B82FE), <8 x double> splat (double 0x4338000000000000))
  %.8.i4.i = fadd contract <8 x double> %.147.i, splat (double 0xC338000000000000)
  %.176.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i4.i, <8 x double> splat (double 0xBFE62E42FEFA39EF), <8 x double> %.8.i1.i)
  %.179.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i4.i, <8 x double> splat (double 0xBC7ABC9E3B39803F), <8 x double> %.176.i)
  %.184.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.179.i, <8 x double> splat (double 0x3DE6124613A86D09), <8 x double> splat (double 0x3E21EED8EFF8D898))
  %.187.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.179.i, <8 x double> %.184.i, <8 x double> splat (double 0x3E5AE64567F544E4))
  %.190.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.179.i, <8 x double> %.187.i, <8 x double> splat (double 0x3E927E4FB7789F5C))
  %.193.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.179.i, <8 x double> %.190.i, <8 x double> splat (double 0x3EC71DE3A556C734))
  %.196.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.179.i, <8 x double> %.193.i, <8 x double> splat (double 0x3EFA01A01A01A01A))
  %.199.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.179.i, <8 x double> %.196.i, <8 x double> splat (double 0x3F2A01A01A01A01A))
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
  %58 = bitcast <8 x i64> %.8.i8.i to <8 x double>
  %.6.i9.i = fmul contract <8 x double> %.263.i, %58
  %.6.i10.i = fsub contract <8 x double> splat (double 1.000000e+00), %.6.i9.i
  %.8.i11.i = fadd contract <8 x double> %.6.i9.i, splat (double 1.000000e+00)
  %.6.i12.i = fdiv contract <8 x double> %.6.i10.i, %.8.i11.i
  %59 = bitcast <8 x double> %.6.i12.i to <8 x i64>
  %60 = xor <8 x i64> %.8.i.i, %59
  %.6.i14.i = xor <8 x i64> %60, %.11.i
  %61 = bitcast <8 x i64> %.6.i14.i to <8 x double>
  br label %B990.endif

B372.i:                                           ; preds = %B114.i
  %.6.i2.i = fsub contract <8 x double> zeroinitializer, %.106.i
  %.508.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i2.i, <8 x double> splat (double 0x3FF71547652B82FE), <8 x double> splat (double 0x4338000000000000))
  %.8.i15.i = fadd contract <8 x double> %.508.i, splat (double 0xC338000000000000)
  %.537.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i15.i, <8 x double> splat (double 0xBFE62E42FEFA39EF), <8 x double> %.6.i2.i)
  %.540.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i15.i, <8 x double> splat (double 0xBC7ABC9E3B39803F), <8 x double> %.537.i)
  %.545.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.540.i, <8 x double> splat (double 0x3DE6124613A86D09), <8 x double> splat (double 0x3E21EED8EFF8D898))
  %.548.i8 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.540.i, <8 x double> %.545.i, <8 x double> splat (double 0x3E5AE64567F544E4))
  %.551.i9 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.540.i, <8 x double> %.548.i8, <8 x double> splat (double 0x3E927E4FB7789F5C))
  %.554.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.540.i, <8 x double> %.551.i9, <8 x double> splat (double 0x3EC71DE3A556C734))
  %.557.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.540.i, <8 x double> %.554.i, <8 x double> splat (double 0x3EFA01A01A01A01A))
  %.560.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.540.i, <8 x double> %.557.i, <8 x double> splat (double 0x3F2A01A01A01A01A))
  %.563.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.540.i, <8 x double> %.560.i, <8 x double> splat (double 0x3F56C16C16C16C17))
  %.566.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.540.i, <8 x double> %.563.i, <8 x double> splat (double 0x3F81111111111111))
  %.569.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.540.i, <8 x double> %.566.i, <8 x double> splat (double 0x3FA5555555555555))
  %.572.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.540.i, <8 x double> %.569.i, <8 x double> splat (double 0x3FC5555555555555))
  %.575.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.540.i, <8 x double> %.572.i, <8 x double> splat (double 5.000000e-01))
  %.6.i16.i = fmul contract <8 x double> %.540.i, %.540.i
  %.8.i17.i = fadd contract <8 x double> %.540.i, splat (double 1.000000e+00)
  %.624.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i16.i, <8 x double> %.575.i, <8 x double> %.8.i17.i)
  %.625.i = bitcast <8 x double> %.508.i to <8 x i64>
  %.8.i18.i = shl <8 x i64> %.625.i, splat (i64 52)
  %.8.i19.i = add <8 x i64> %.8.i18.i, splat (i64 4607182418800017408)
  %62 = bitcast <8 x i64> %.8.i19.i to <8 x double>
  %.6.i20.i = fmul contract <8 x double> %.624.i, %62
  %.8.i21.i = fadd contract <8 x double> %.6.i20.i, splat (double 1.000000e+00)
  %isneg.i = icmp slt <8 x i64> %.11.i, zeroinitializer
  %.6.i31.v.v.i = select <8 x i1> %isneg.i, <8 x double> %.6.i20.i, <8 x double> splat (double 1.000000e+00)
  %.6.i31.v.i = fdiv contract <8 x double> %.6.i31.v.v.i, %.8.i21.i
  br label %B990.endif

B990.endif:                                       ; preds = %B372.i, %B168.i, %B98.i
  %.2223.sroa.0.5 = phi <8 x double> [ %.8.i3.i, %B98.i ], [ %61, %B168.i ], [ %.6.i31.v.i, %B372.i ]
  store <8 x double> %.2223.sroa.0.5, ptr %lsr.iv47, align 8
  %scevgep48 = getelementptr i8, ptr %lsr.iv47, i64 64
  %lsr.iv.next36 = add nsw i64 %lsr.iv35, -1
  %.2144 = icmp sgt i64 %lsr.iv35, 6
  br i1 %.2144, label %B988.if, label %B890.loopexit

B1150.if:                                         ; preds = %B1150.loopexit, %B1150.if.lr.ph
  %lsr.iv20 = phi ptr [ %arg.out.4, %B1150.if.lr.ph ], [ %scevgep21, %B1150.loopexit ]
  %current.2.sroa.40.0.lcssa.pn = phi ptr [ %current.2.sroa.40.0.lcssa, %B1150.if.lr.ph ], [ %11, %B1150.loopexit ]
  %.2425830836 = phi i64 [ 0, %B1150.if.lr.ph ], [ %.2432, %B1150.loopexit ]
  %lsr.iv15 = getelementptr i8, ptr %current.2.sroa.40.0.lcssa.pn, i64 64
  %.2432 = add nuw nsw i64 %.2425830836, 1
  br i1 %10, label %B1150.loopexit, label %B1198.if

B1198.if:                                         ; preds = %B1150.if, %B1198.if
  %lsr.iv1 = phi i64 [ %lsr.iv.next, %B1198.if ], [ %9, %B1150.if ]
  %lsr.iv17 = phi i64 [ %lsr.iv.next18, %B1198.if ], [ 0, %B1150.if ]
  %scevgep22 = getelementptr i8, ptr %lsr.iv20, i64 %lsr.iv17
  %.2591 = load <8 x double>, ptr %scevgep22, align 8
  %scevgep = getelementptr i8, ptr %current.2.sroa.40.0.lcssa.pn, i64 %lsr.iv17
  %scevgep1 = getelementptr i8, ptr %scevgep, i64 64
  %.2606 = load <8 x double>, ptr %scevgep1, align 8
  %.6.i = fadd contract <8 x double> %.2591, %.2606
  store <8 x double> %.6.i, ptr %scevgep22, align 8
  %lsr.iv.next18 = add i64 %lsr.iv17, 64
  %lsr.iv.next = add nsw i64 %lsr.iv1, -1
  %.2540 = icmp sgt i64 %lsr.iv1, 6
  br i1 %.2540, label %B1198.if, label %B1150.loopexit
}

; Function Attrs: mustprogress nocallback nocreateundeforpoison nofree nosync nounwind speculatable willreturn memory(none)
declare <8 x double> @llvm.fabs.v8f64(<8 x double>) #3

; Function Attrs: mustprogress nocallback nocreateundeforpoison nofree nosync nounwind speculatable willreturn memory(none)
declare <8 x double> @llvm.minnum.v8f64(<8 x double>, <8 x double>) #3

; Function Attrs: mustprogress nocallback nocreateundeforpoison nofree nosync nounwind speculatable willreturn memory(none)
declare double @llvm.fabs.f64(double) #3

; Function Attrs: mustprogress nocallback nocreateundeforpoison nofree nosync nounwind speculatable willreturn memory(none)
declare { i64, i1 } @llvm.uadd.with.overflow.i64(i64, i64) #3

attributes #0 = { nofree norecurse nounwind }
attributes #1 = { mustprogress nocallback nofree nounwind willreturn memory(argmem: write) }
attributes #2 = { nofree noinline norecurse nounwind }
attributes #3 = { mustprogress nocallback nocreateundeforpoison nofree nosync nounwind speculatable willreturn memory(none) }
attributes #4 = { mustprogress nofree noinline norecurse nosync nounwind willreturn memory(argmem: readwrite) }
attributes #5 = { nofree noinline norecurse nosync nounwind memory(readwrite, inaccessiblemem: none, target_mem0: none, target_mem1: none) }
attributes #6 = { nofree noinline norecurse nosync nounwind memory(write, argmem: readwrite, inaccessiblemem: none, target_mem0: none, target_mem1: none) }
attributes #7 = { nofree noinline norecurse nosync nounwind memory(argmem: readwrite) }
attributes #8 = { nofree noinline norecurse nosync nounwind memory(argmem: write) }
attributes #9 = { mustprogress nocallback nofree nosync nounwind willreturn memory(none) }

!0 = !{!"branch_weights", i32 49, i32 1}
!1 = !{!"branch_weights", i32 99, i32 1}
!2 = !{!3}
!3 = distinct !{!3, !4, !"_ZN17bnserve_surrogate6kernel11_regression8multiplyB3v39B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dEx5ArrayIdLi1E1C7mutable7alignedEx23Literal_5bint_5d_281_295ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedEx: %retptr"}
!4 = distinct !{!4, !"_ZN17bnserve_surrogate6kernel11_regression8multiplyB3v39B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dEx5ArrayIdLi1E1C7mutable7alignedEx23Literal_5bint_5d_281_295ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedEx"}
!5 = !{!"branch_weights", i32 1, i32 99}
!6 = !{!7}
!7 = distinct !{!7, !8, !"_ZN17bnserve_surrogate6kernel11_regression9_productsB3v33B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedExx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!8 = distinct !{!8, !"_ZN17bnserve_surrogate6kernel11_regression9_productsB3v33B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedExx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!9 = !{!10}
!10 = distinct !{!10, !11, !"_ZN17bnserve_surrogate6kernel11_regression8multiplyB3v37B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dEx5ArrayIdLi1E1C7mutable7alignedE23Literal_5bint_5d_281_2923Literal_5bint_5d_288_295ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedEx: %retptr"}
!11 = distinct !{!11, !"_ZN17bnserve_surrogate6kernel11_regression8multiplyB3v37B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dEx5ArrayIdLi1E1C7mutable7alignedE23Literal_5bint_5d_281_2923Literal_5bint_5d_288_295ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedEx"}
!12 = !{!13}
!13 = distinct !{!13, !14, !"_ZN17bnserve_surrogate6kernel7_places9find_endsB4v142B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5TupleI5ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedExdE5ArrayIdLi1E1C7mutable7alignedExdx5ArrayIxLi1E1C7mutable7alignedE: %retptr"}
!14 = distinct !{!14, !"_ZN17bnserve_surrogate6kernel7_places9find_endsB4v142B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5TupleI5ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedExdE5ArrayIdLi1E1C7mutable7alignedExdx5ArrayIxLi1E1C7mutable7alignedE"}
!15 = !{!16}
!16 = distinct !{!16, !17, !"_ZN17bnserve_surrogate6kernel7_places9find_endsB4v142B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5TupleI5ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedExdE5ArrayIdLi1E1C7mutable7alignedExdx5ArrayIxLi1E1C7mutable7alignedE: %retptr"}
!17 = distinct !{!17, !"_ZN17bnserve_surrogate6kernel7_places9find_endsB4v142B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5TupleI5ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedExdE5ArrayIdLi1E1C7mutable7alignedExdx5ArrayIxLi1E1C7mutable7alignedE"}
!18 = !{!19}
!19 = distinct !{!19, !20, !"_ZN17bnserve_surrogate6kernel7_points11two_splinesB4v167B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedExxd5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!20 = distinct !{!20, !"_ZN17bnserve_surrogate6kernel7_points11two_splinesB4v167B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedExxd5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!21 = !{!22}
!22 = distinct !{!22, !23, !"_ZN17bnserve_surrogate6kernel7_points6splineB4v168B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedExxd5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!23 = distinct !{!23, !"_ZN17bnserve_surrogate6kernel7_points6splineB4v168B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedExxd5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE"}
!24 = !{!25}
!25 = distinct !{!25, !26, !"_ZN17bnserve_surrogate6kernel7_points10fill_cellsB3v97B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedExx5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!26 = distinct !{!26, !"_ZN17bnserve_surrogate6kernel7_points10fill_cellsB3v97B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedExx5ArrayIdLi1E1C7mutable7alignedE"}
!27 = !{!28}
!28 = distinct !{!28, !29, !"_ZN17bnserve_surrogate6kernel7_points10fill_cellsB3v97B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedExx5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!29 = distinct !{!29, !"_ZN17bnserve_surrogate6kernel7_points10fill_cellsB3v97B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedExx5ArrayIdLi1E1C7mutable7alignedE"}
!30 = !{!31}
!31 = distinct !{!31, !32, !"_ZN17bnserve_surrogate6kernel7_places9find_endsB4v142B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5TupleI5ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedExdE5ArrayIdLi1E1C7mutable7alignedExdx5ArrayIxLi1E1C7mutable7alignedE: %retptr"}
!32 = distinct !{!32, !"_ZN17bnserve_surrogate6kernel7_places9find_endsB4v142B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5TupleI5ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedExdE5ArrayIdLi1E1C7mutable7alignedExdx5ArrayIxLi1E1C7mutable7alignedE"}
!33 = !{!34}
!34 = distinct !{!34, !35, !"_ZN17bnserve_surrogate6kernel7_points12extend_belowB4v143B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedExdd8UniTupleIdLi2EEd5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!35 = distinct !{!35, !"_ZN17bnserve_surrogate6kernel7_points12extend_belowB4v143B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedExdd8UniTupleIdLi2EEd5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!36 = !{!37}
!37 = distinct !{!37, !38, !"_ZN17bnserve_surrogate6kernel7_points6splineB4v168B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedExxd5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!38 = distinct !{!38, !"_ZN17bnserve_surrogate6kernel7_points6splineB4v168B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedExxd5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE"}
!39 = !{!40}
!40 = distinct !{!40, !41, !"_ZN17bnserve_surrogate6kernel7_points6phasesB4v141B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!41 = distinct !{!41, !"_ZN17bnserve_surrogate6kernel7_points6phasesB4v141B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!42 = !{!43}
!43 = distinct !{!43, !44, !"_ZN17bnserve_surrogate6kernel7_points11polynomialsB4v148B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedExxd5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!44 = distinct !{!44, !"_ZN17bnserve_surrogate6kernel7_points11polynomialsB4v148B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedExxd5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!45 = !{!"branch_weights", i32 146201250, i32 2001282398}
!46 = !{!"branch_weights", i32 166258294, i32 1981225354}
!47 = !{!"branch_weights", i32 1030503492, i32 1116980156}
!48 = !{!"branch_weights", i32 277993707, i32 1869489941}
!49 = !{!"branch_weights", i32 542333185, i32 1605150463}
!50 = distinct !{!50, !51, !52}
!51 = !{!"llvm.loop.estimated_trip_count", i32 4}
!52 = !{!"llvm.loop.unroll.disable"}
!53 = distinct !{!53, !51, !52}
!54 = !{!"branch_weights", i32 319644862, i32 1827838786}
!55 = distinct !{!55, !56}
!56 = !{!"llvm.loop.estimated_trip_count", i32 6}
!57 = distinct !{!57, !56}
!58 = distinct !{!58, !51, !52}
!59 = distinct !{!59, !51, !52}
!60 = distinct !{!60, !56}
!61 = distinct !{!61, !56}
!62 = !{!63}
!63 = distinct !{!63, !64, !"_ZN17bnserve_surrogate6kernel7_places15first_not_belowB4v132B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedEdx: %retptr"}
!64 = distinct !{!64, !"_ZN17bnserve_surrogate6kernel7_places15first_not_belowB4v132B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedEdx"}
!65 = !{!66}
!66 = distinct !{!66, !67, !"_ZN17bnserve_surrogate6kernel7_places15first_not_belowB4v132B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedEdx: %retptr"}
!67 = distinct !{!67, !"_ZN17bnserve_surrogate6kernel7_places15first_not_belowB4v132B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedEdx"}
!68 = !{!69}
!69 = distinct !{!69, !70, !"_ZN17bnserve_surrogate6kernel7_points15spline_at_nodesB4v133B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!70 = distinct !{!70, !"_ZN17bnserve_surrogate6kernel7_points15spline_at_nodesB4v133B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE"}
!71 = !{!72}
!72 = distinct !{!72, !73, !"_ZN17bnserve_surrogate6kernel7_points16fill_polynomialsB4v140B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!73 = distinct !{!73, !"_ZN17bnserve_surrogate6kernel7_points16fill_polynomialsB4v140B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE"}
!74 = !{!75}
!75 = distinct !{!75, !76, !"_ZN17bnserve_surrogate6kernel7_points15spline_at_nodesB4v133B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!76 = distinct !{!76, !"_ZN17bnserve_surrogate6kernel7_points15spline_at_nodesB4v133B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE"}
!77 = !{!78}
!78 = distinct !{!78, !79, !"_ZN17bnserve_surrogate6kernel7_points6phasesB4v141B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!79 = distinct !{!79, !"_ZN17bnserve_surrogate6kernel7_points6phasesB4v141B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!80 = !{!81}
!81 = distinct !{!81, !82, !"_ZN17bnserve_surrogate6kernel7_points16fill_polynomialsB4v140B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!82 = distinct !{!82, !"_ZN17bnserve_surrogate6kernel7_points16fill_polynomialsB4v140B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE"}
!83 = !{!84}
!84 = distinct !{!84, !85, !"_ZN17bnserve_surrogate8baseline10_amplitude22amplitude_coefficientsB4v121B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDAxYh_2bqJnA4AOzNAE_3dEddd5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!85 = distinct !{!85, !"_ZN17bnserve_surrogate8baseline10_amplitude22amplitude_coefficientsB4v121B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDAxYh_2bqJnA4AOzNAE_3dEddd5ArrayIdLi1E1C7mutable7alignedE"}
!86 = !{!87}
!87 = distinct !{!87, !88, !"_ZN17bnserve_surrogate8baseline6_phase18phase_coefficientsB4v124B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDAxYh_2bqJnA4AOzNAE_3dEddddd5ArrayIdLi2E1C7mutable7alignedE: %retptr"}
!88 = distinct !{!88, !"_ZN17bnserve_surrogate8baseline6_phase18phase_coefficientsB4v124B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDAxYh_2bqJnA4AOzNAE_3dEddddd5ArrayIdLi2E1C7mutable7alignedE"}
!89 = !{!90, !87}
!90 = distinct !{!90, !91, !"_ZN17bnserve_surrogate8baseline11_point_mass20add_point_mass_phaseB4v125B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDAxYh_2bqJnA4AOzNAE_3dEd5ArrayIdLi2E1C7mutable7alignedE: %retptr"}
!91 = distinct !{!91, !"_ZN17bnserve_surrogate8baseline11_point_mass20add_point_mass_phaseB4v125B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDAxYh_2bqJnA4AOzNAE_3dEd5ArrayIdLi2E1C7mutable7alignedE"}
!92 = !{!93, !87}
!93 = distinct !{!93, !94, !"_ZN17bnserve_surrogate8baseline6_spins20add_spin_orbit_phaseB4v126B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDAxYh_2bqJnA4AOzNAE_3dEdd5ArrayIdLi2E1C7mutable7alignedE: %retptr"}
!94 = distinct !{!94, !"_ZN17bnserve_surrogate8baseline6_spins20add_spin_orbit_phaseB4v126B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDAxYh_2bqJnA4AOzNAE_3dEdd5ArrayIdLi2E1C7mutable7alignedE"}
!95 = !{!96, !87}
!96 = distinct !{!96, !97, !"_ZN17bnserve_surrogate8baseline6_spins20add_spin_orbit_phaseB4v126B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDAxYh_2bqJnA4AOzNAE_3dEdd5ArrayIdLi2E1C7mutable7alignedE: %retptr"}
!97 = distinct !{!97, !"_ZN17bnserve_surrogate8baseline6_spins20add_spin_orbit_phaseB4v126B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDAxYh_2bqJnA4AOzNAE_3dEdd5ArrayIdLi2E1C7mutable7alignedE"}
!98 = !{!99, !87}
!99 = distinct !{!99, !100, !"_ZN17bnserve_surrogate8baseline6_spins19add_self_spin_phaseB4v128B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDAxYh_2bqJnA4AOzNAE_3dEddd5ArrayIdLi2E1C7mutable7alignedE: %retptr"}
!100 = distinct !{!100, !"_ZN17bnserve_surrogate8baseline6_spins19add_self_spin_phaseB4v128B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDAxYh_2bqJnA4AOzNAE_3dEddd5ArrayIdLi2E1C7mutable7alignedE"}
!101 = !{!102, !87}
!102 = distinct !{!102, !103, !"_ZN17bnserve_surrogate8baseline6_spins19add_self_spin_phaseB4v128B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDAxYh_2bqJnA4AOzNAE_3dEddd5ArrayIdLi2E1C7mutable7alignedE: %retptr"}
!103 = distinct !{!103, !"_ZN17bnserve_surrogate8baseline6_spins19add_self_spin_phaseB4v128B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDAxYh_2bqJnA4AOzNAE_3dEddd5ArrayIdLi2E1C7mutable7alignedE"}
!104 = !{!105, !87}
!105 = distinct !{!105, !106, !"_ZN17bnserve_surrogate8baseline6_spins19add_spin_spin_phaseB4v129B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDAxYh_2bqJnA4AOzNAE_3dEddd5ArrayIdLi2E1C7mutable7alignedE: %retptr"}
!106 = distinct !{!106, !"_ZN17bnserve_surrogate8baseline6_spins19add_spin_spin_phaseB4v129B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDAxYh_2bqJnA4AOzNAE_3dEddd5ArrayIdLi2E1C7mutable7alignedE"}
!107 = !{!108, !87}
!108 = distinct !{!108, !109, !"_ZN17bnserve_surrogate8baseline6_tides15add_tidal_phaseB4v130B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDAxYh_2bqJnA4AOzNAE_3dEdd5ArrayIdLi2E1C7mutable7alignedE: %retptr"}
!109 = distinct !{!109, !"_ZN17bnserve_surrogate8baseline6_tides15add_tidal_phaseB4v130B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDAxYh_2bqJnA4AOzNAE_3dEdd5ArrayIdLi2E1C7mutable7alignedE"}
!110 = !{!111, !87}
!111 = distinct !{!111, !112, !"_ZN17bnserve_surrogate8baseline6_tides15add_tidal_phaseB4v130B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDAxYh_2bqJnA4AOzNAE_3dEdd5ArrayIdLi2E1C7mutable7alignedE: %retptr"}
!112 = distinct !{!112, !"_ZN17bnserve_surrogate8baseline6_tides15add_tidal_phaseB4v130B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDAxYh_2bqJnA4AOzNAE_3dEdd5ArrayIdLi2E1C7mutable7alignedE"}
!113 = !{!114, !116}
!114 = distinct !{!114, !115, !"_ZN17bnserve_surrogate6kernel7_series9_legendreB4v131B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dEd5ArrayIdLi2E1C7mutable7alignedE: %retptr"}
!115 = distinct !{!115, !"_ZN17bnserve_surrogate6kernel7_series9_legendreB4v131B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dEd5ArrayIdLi2E1C7mutable7alignedE"}
!116 = distinct !{!116, !115, !"_ZN17bnserve_surrogate6kernel7_series9_legendreB4v131B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dEd5ArrayIdLi2E1C7mutable7alignedE: %excinfo"}
!117 = !{!118}
!118 = distinct !{!118, !119, !"_ZN17bnserve_surrogate6kernel8_writing9_streamedB4v158B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedExxb23Literal_5bint_5d_288_29: %retptr"}
!119 = distinct !{!119, !"_ZN17bnserve_surrogate6kernel8_writing9_streamedB4v158B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedExxb23Literal_5bint_5d_288_29"}
!120 = !{!121}
!121 = distinct !{!121, !122, !"_ZN17bnserve_surrogate6kernel8_writing9_streamedB4v162B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedExxb24Literal_5bint_5d_2816_29: %retptr"}
!122 = distinct !{!122, !"_ZN17bnserve_surrogate6kernel8_writing9_streamedB4v162B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedExxb24Literal_5bint_5d_2816_29"}
!123 = !{!124}
!124 = distinct !{!124, !125, !"_ZN17bnserve_surrogate6kernel8_writing10to_complexB4v163B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx8UniTupleIdLi2EEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!125 = distinct !{!125, !"_ZN17bnserve_surrogate6kernel8_writing10to_complexB4v163B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx8UniTupleIdLi2EEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!126 = !{i32 1}
!127 = distinct !{!127, !52}
!128 = distinct !{!128, !52}
!129 = distinct !{!129, !52}
!130 = distinct !{!130, !52}
!131 = !{!132}
!132 = distinct !{!132, !133, !"_ZN17bnserve_surrogate12_coordinates18transform_physicalB3v32B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDAxYh_2bqJnA4AOzNAE_3dEddddd5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!133 = distinct !{!133, !"_ZN17bnserve_surrogate12_coordinates18transform_physicalB3v32B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDAxYh_2bqJnA4AOzNAE_3dEddddd5ArrayIdLi1E1C7mutable7alignedE"}
!134 = !{!135}
!135 = distinct !{!135, !136, !"_ZN17bnserve_surrogate6kernel11_regression8multiplyB3v39B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dEx5ArrayIdLi1E1C7mutable7alignedEx23Literal_5bint_5d_281_295ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedEx: %retptr"}
!136 = distinct !{!136, !"_ZN17bnserve_surrogate6kernel11_regression8multiplyB3v39B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dEx5ArrayIdLi1E1C7mutable7alignedEx23Literal_5bint_5d_281_295ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedEx"}
