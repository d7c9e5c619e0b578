; sources: b151d09300d67d765e8346714d96dfcfb3d1e39135362dc355697c8a0c6f15bf
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

common.ret:                                       ; preds = %B1480.endif.if, %B1574, %B1430, %B324
  %common.ret.op = phi i32 [ 0, %B324 ], [ 0, %B1430 ], [ 0, %B1574 ], [ %.2374, %B1480.endif.if ]
  ret i32 %common.ret.op

B324:                                             ; preds = %B284.if
  store i64 -1, ptr %retptr, align 8
  br label %common.ret

B344:                                             ; preds = %B284, %entry
  %.697 = load i64, ptr %arg.arguments.4, align 8
  %.733 = mul nsw i64 %.697, 10
  %.986 = shl nsw i64 %.697, 1
  %.11361120.not = icmp slt i64 %.697, 1
  br i1 %.11361120.not, label %B1574, label %B830.if.lr.ph

B1142:                                            ; preds = %B834.else.endif.endif
  %.1964 = getelementptr i8, ptr %.1321, i64 48
  %.1965 = load double, ptr %.1964, align 8
  %.1978.le = tail call contract double @llvm.cos.f64(double %.1965)
  br label %B1236

B1236:                                            ; preds = %B834.else.endif.endif, %B1142
  %"$phi1236.1.2.1" = phi double [ %.1978.le, %B1142 ], [ 0x7FF8000000000000, %B834.else.endif.endif ]
  %.1998 = fmul contract double %"$phi1236.1.2.1", %"$phi1236.1.2.1"
  %.1999 = fadd contract double %.1998, 1.000000e+00
  %.2000 = fmul contract double %.1999, 5.000000e-01
  %2 = shl i64 %.114211191121, 3
  %scevgep132 = getelementptr i8, ptr %14, i64 %2
  store double %.2000, ptr %scevgep132, align 8
  %scevgep131 = getelementptr i8, ptr %lsr.iv129, i64 -8
  store double 0.000000e+00, ptr %scevgep131, align 8
  %.2064 = fneg contract double %"$phi1236.1.2.1"
  store double %.2064, ptr %lsr.iv129, align 8
  %.2101 = icmp ne i64 %.1881, 0
  %.2106 = zext i1 %.2101 to i64
  %.2107 = add nuw nsw i64 %bad.2.01123, %.2106
  %scevgep130 = getelementptr i8, ptr %lsr.iv129, i64 16
  %lsr.iv.next134 = add i64 %lsr.iv133, 10
  %exitcond1140.not = icmp eq i64 %.697, %.1149
  br i1 %exitcond1140.not, label %B1348, label %B830.if

B1348:                                            ; preds = %B1236
  %.2123.not = icmp eq i64 %.2107, 0
  br i1 %.2123.not, label %B1434, label %B1360

B1360:                                            ; preds = %B1348
  %sunkaddr31.le = getelementptr i8, ptr %arg.arguments.4, i64 96
  %.2154 = load i64, ptr %sunkaddr31.le, align 8
  %.2155 = and i64 %.2154, 4
  %.2156.not = icmp eq i64 %.2155, 0
  br i1 %.2156.not, label %B1434, label %B1430

B1430:                                            ; preds = %B1360
  store i64 %.2107, ptr %retptr, align 8
  br label %common.ret

B1434:                                            ; preds = %B1360, %B1348
  %3 = add nuw i64 %.697, 7
  %.2259 = lshr i64 %3, 3
  %4 = add nuw nsw i64 %.2259, 2
  br label %B1478.if

B1574:                                            ; preds = %B1478.backedge, %B344
  %bad.2.0.lcssa713 = phi i64 [ 0, %B344 ], [ %.2107, %B1478.backedge ]
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

B830.if.lr.ph:                                    ; preds = %B344
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
  br label %B830.if

B830.if:                                          ; preds = %B830.if.lr.ph, %B1236
  %lsr.iv133 = phi i64 [ 10, %B830.if.lr.ph ], [ %lsr.iv.next134, %B1236 ]
  %lsr.iv129 = phi ptr [ %scevgep, %B830.if.lr.ph ], [ %scevgep130, %B1236 ]
  %bad.2.01123 = phi i64 [ 0, %B830.if.lr.ph ], [ %.2107, %B1236 ]
  %.114211191121 = phi i64 [ 0, %B830.if.lr.ph ], [ %.1149, %B1236 ]
  %.1149 = add nuw nsw i64 %.114211191121, 1
  %15 = add i64 %lsr.iv133, -10
  %.1228.not = icmp slt i64 %.114211191121, %.697
  br i1 %.1228.not, label %B834.else.endif.endif, label %B834.else.endif.if, !prof !1

B834.else.endif.if:                               ; preds = %B830.if
  br label %B834.else.endif.endif

B834.else.endif.endif:                            ; preds = %B834.else.endif.if, %B830.if
  %.1208.sroa.0.3 = phi i64 [ %.733, %B834.else.endif.if ], [ %15, %B830.if ]
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
  br i1 %.1934, label %B1142, label %B1236

B1478.if:                                         ; preds = %B1478.backedge, %B1434
  %lsr.iv25 = phi i64 [ %lsr.iv.next26, %B1478.backedge ], [ %4, %B1434 ]
  %.228611291132 = phi i64 [ %21, %B1478.backedge ], [ 0, %B1434 ]
  %21 = add nuw i64 %.228611291132, 8
  %.13.i = tail call i64 @llvm.smin.i64(i64 %.697, i64 %21)
  store ptr null, ptr %.2356, align 8
  %.2374 = call fastcc i32 @inner_2(ptr nonnull %.2356, ptr nonnull %excinfo.11, i64 %.228611291132, i64 %.13.i, ptr nonnull %arg.arguments.4, ptr %sunkaddr, ptr %11, ptr %12, ptr %13, i64 %.697, ptr %14, i64 %.697, ptr %6, i64 %.986)
  %cond = icmp eq i32 %.2374, 0
  br i1 %cond, label %B1478.backedge, label %B1480.endif.if, !prof !0

B1478.backedge:                                   ; preds = %B1478.if
  %lsr.iv.next26 = add nsw i64 %lsr.iv25, -1
  %.2280 = icmp sgt i64 %lsr.iv25, 3
  br i1 %.2280, label %B1478.if, label %B1574

B1480.endif.if:                                   ; preds = %B1478.if
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
  br i1 %.219.le, label %B132, label %common.ret

common.ret:                                       ; preds = %B230, %entry, %B132, %B132.1, %B132.2, %B132.3, %B132.4, %B132.5, %B132.6, %B132.7, %B132.8, %B768
  %..sink = phi i64 [ %., %B768 ], [ 1, %entry ], [ 1, %B132.8 ], [ 1, %B132.7 ], [ 1, %B132.6 ], [ 1, %B132.5 ], [ 1, %B132.4 ], [ 1, %B132.3 ], [ 1, %B132.2 ], [ 1, %B132.1 ], [ 1, %B132 ], [ 2, %B230 ]
  store i64 %..sink, ptr %retptr, align 8
  ret void

B132:                                             ; preds = %entry
  %0 = getelementptr i8, ptr %arg.row.4, i64 8
  %.210.1 = load double, ptr %0, align 8
  %.218.le.1 = fsub contract double %.210.1, %.210.1
  %.219.le.1 = fcmp contract ord double %.218.le.1, 0.000000e+00
  br i1 %.219.le.1, label %B132.1, label %common.ret

B132.1:                                           ; preds = %B132
  %1 = getelementptr i8, ptr %arg.row.4, i64 16
  %.210.2 = load double, ptr %1, align 8
  %.218.le.2 = fsub contract double %.210.2, %.210.2
  %.219.le.2 = fcmp contract ord double %.218.le.2, 0.000000e+00
  br i1 %.219.le.2, label %B132.2, label %common.ret

B132.2:                                           ; preds = %B132.1
  %2 = getelementptr i8, ptr %arg.row.4, i64 24
  %.210.3 = load double, ptr %2, align 8
  %.218.le.3 = fsub contract double %.210.3, %.210.3
  %.219.le.3 = fcmp contract ord double %.218.le.3, 0.000000e+00
  br i1 %.219.le.3, label %B132.3, label %common.ret

B132.3:                                           ; preds = %B132.2
  %3 = getelementptr i8, ptr %arg.row.4, i64 32
  %.210.4 = load double, ptr %3, align 8
  %.218.le.4 = fsub contract double %.210.4, %.210.4
  %.219.le.4 = fcmp contract ord double %.218.le.4, 0.000000e+00
  br i1 %.219.le.4, label %B132.4, label %common.ret

B132.4:                                           ; preds = %B132.3
  %4 = getelementptr i8, ptr %arg.row.4, i64 40
  %.210.5 = load double, ptr %4, align 8
  %.218.le.5 = fsub contract double %.210.5, %.210.5
  %.219.le.5 = fcmp contract ord double %.218.le.5, 0.000000e+00
  br i1 %.219.le.5, label %B132.5, label %common.ret

B132.5:                                           ; preds = %B132.4
  %5 = getelementptr i8, ptr %arg.row.4, i64 48
  %.210.6 = load double, ptr %5, align 8
  %.218.le.6 = fsub contract double %.210.6, %.210.6
  %.219.le.6 = fcmp contract ord double %.218.le.6, 0.000000e+00
  br i1 %.219.le.6, label %B132.6, label %common.ret

B132.6:                                           ; preds = %B132.5
  %6 = getelementptr i8, ptr %arg.row.4, i64 56
  %.210.7 = load double, ptr %6, align 8
  %.218.le.7 = fsub contract double %.210.7, %.210.7
  %.219.le.7 = fcmp contract ord double %.218.le.7, 0.000000e+00
  br i1 %.219.le.7, label %B132.7, label %common.ret

B132.7:                                           ; preds = %B132.6
  %7 = getelementptr i8, ptr %arg.row.4, i64 64
  %.210.8 = load double, ptr %7, align 8
  %.218.le.8 = fsub contract double %.210.8, %.210.8
  %.219.le.8 = fcmp contract ord double %.218.le.8, 0.000000e+00
  br i1 %.219.le.8, label %B132.8, label %common.ret

B132.8:                                           ; preds = %B132.7
  %8 = getelementptr i8, ptr %arg.row.4, i64 72
  %.210.9 = load double, ptr %8, align 8
  %.218.le.9 = fsub contract double %.210.9, %.210.9
  %.219.le.9 = fcmp contract ord double %.218.le.9, 0.000000e+00
  br i1 %.219.le.9, label %B230, label %common.ret

B230:                                             ; preds = %B132.8
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
  br i1 %.510, label %B496, label %common.ret

B496:                                             ; preds = %B230
  %.565 = fmul contract double %.210.7, 0x3ED4A8B4A9ED04E3
  %.571 = fmul contract double %arg.first, %.565
  %.572 = fcmp olt double %.571, 1.000000e-09
  %.581 = and i64 %arg.policy, 2
  %.582.not = icmp eq i64 %.581, 0
  br i1 %.582.not, label %B672, label %B614

B614:                                             ; preds = %B496
  %.586 = fmul contract double %arg.last, %.565
  %.617 = getelementptr i8, ptr %arg.band.4, i64 8
  %.618 = load double, ptr %.617, align 8
  %.620 = fmul contract double %.618, 0x3FF000000044B830
  %.621 = fcmp contract ogt double %.586, %.620
  %.623 = or i1 %.572, %.621
  br label %B672

B672:                                             ; preds = %B614, %B496
  %outside.3.0 = phi i1 [ %.623, %B614 ], [ %.572, %B496 ]
  %.638 = and i64 %arg.policy, 1
  %.641.not = icmp eq i64 %.638, 0
  br i1 %.641.not, label %B768, label %B710

B710:                                             ; preds = %B672
  %.678 = getelementptr i8, ptr %arg.band.4, i64 24
  %.679 = load double, ptr %.678, align 8
  %.686 = fmul contract double %.679, 0x3FEFFFFFFF768FA1
  %.687 = fcmp contract olt double %.571, %.686
  %.689 = or i1 %outside.3.0, %.687
  br label %B768

B768:                                             ; preds = %B710, %B672
  %outside.4.0 = phi i1 [ %.689, %B710 ], [ %outside.3.0, %B672 ]
  %. = select i1 %outside.4.0, i64 3, i64 0
  br label %common.ret
}

; Function Attrs: mustprogress nocallback nocreateundeforpoison nofree nosync nounwind speculatable willreturn memory(none)
declare i64 @llvm.smin.i64(i64, i64) #3

; Function Attrs: nofree noinline norecurse nosync nounwind memory(readwrite, inaccessiblemem: none, target_mem0: none, target_mem1: none)
define internal fastcc noundef range(i32 0, 2) i32 @inner_2(ptr noalias nonnull writeonly captures(none) %retptr, ptr noalias nonnull writeonly captures(none) %excinfo, i64 %arg.start, i64 %arg.stop, ptr readonly captures(none) %arg.arguments.4, ptr readonly captures(none) %arg.contents.4, ptr readonly captures(none) %arg.weights.4, ptr readonly captures(none) %arg.parameters.4, ptr readonly captures(none) %arg.status.4, i64 range(i64 1, -9223372036854775808) %arg.status.5.0, ptr readonly captures(none) %arg.plus.4, i64 range(i64 1, -9223372036854775808) %arg.plus.5.0, ptr readonly captures(none) %arg.cross.4, i64 range(i64 -9223372036854775808, 9223372036854775807) %arg.cross.5.0) unnamed_addr #5 {
entry:
  %.1219 = alloca { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, align 8
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(56) %.1219, i8 0, i64 56, i1 false)
  %.2509 = alloca ptr, align 8
  store ptr null, ptr %.2509, align 8
  %excinfo.16 = alloca ptr, align 8
  store ptr null, ptr %excinfo.16, align 8
  %.2557 = alloca ptr, align 8
  store ptr null, ptr %.2557, align 8
  %.137 = getelementptr i8, ptr %arg.arguments.4, i64 104
  %.138 = load i64, ptr %.137, align 8
  %0 = inttoptr i64 %.138 to ptr
  %.414 = add nsw i64 %arg.stop, -1
  %.13.i = tail call i64 @llvm.smin.i64(i64 %.414, i64 %arg.start)
  %.454.idx = mul nsw i64 %.13.i, 80
  %.454 = getelementptr inbounds i8, ptr %arg.parameters.4, i64 %.454.idx
  %.533 = load double, ptr %.454, align 8
  %.561 = getelementptr i8, ptr %.454, i64 24
  %.562 = load double, ptr %.561, align 8
  %scevgep224 = getelementptr i8, ptr %0, i64 32
  store double %.533, ptr %0, align 8
  %scevgep226 = getelementptr i8, ptr %0, i64 8
  store double %.562, ptr %scevgep226, align 8
  %.653 = getelementptr i8, ptr %.454, i64 32
  %.654 = load double, ptr %.653, align 8
  %.682 = getelementptr i8, ptr %.454, i64 8
  %.683 = load double, ptr %.682, align 8
  %scevgep228 = getelementptr i8, ptr %0, i64 16
  store double %.654, ptr %scevgep228, align 8
  %scevgep229 = getelementptr i8, ptr %0, i64 24
  store double %.683, ptr %scevgep229, align 8
  %.775 = getelementptr i8, ptr %.454, i64 16
  %.776 = load double, ptr %.775, align 8
  store double %.776, ptr %scevgep224, align 8
  %lsr.iv.next232 = add i64 %arg.start, 1
  %.13.i.1 = tail call i64 @llvm.smin.i64(i64 %.414, i64 %lsr.iv.next232)
  %.454.idx.1 = mul nsw i64 %.13.i.1, 80
  %.454.1 = getelementptr inbounds i8, ptr %arg.parameters.4, i64 %.454.idx.1
  %.533.1 = load double, ptr %.454.1, align 8
  %.561.1 = getelementptr i8, ptr %.454.1, i64 24
  %.562.1 = load double, ptr %.561.1, align 8
  %scevgep224.1 = getelementptr i8, ptr %0, i64 72
  %scevgep225.1 = getelementptr i8, ptr %0, i64 40
  store double %.533.1, ptr %scevgep225.1, align 8
  %scevgep226.1 = getelementptr i8, ptr %0, i64 48
  store double %.562.1, ptr %scevgep226.1, align 8
  %.653.1 = getelementptr i8, ptr %.454.1, i64 32
  %.654.1 = load double, ptr %.653.1, align 8
  %.682.1 = getelementptr i8, ptr %.454.1, i64 8
  %.683.1 = load double, ptr %.682.1, align 8
  %scevgep228.1 = getelementptr i8, ptr %0, i64 56
  store double %.654.1, ptr %scevgep228.1, align 8
  %scevgep229.1 = getelementptr i8, ptr %0, i64 64
  store double %.683.1, ptr %scevgep229.1, align 8
  %.775.1 = getelementptr i8, ptr %.454.1, i64 16
  %.776.1 = load double, ptr %.775.1, align 8
  store double %.776.1, ptr %scevgep224.1, align 8
  %lsr.iv.next232.1 = add i64 %arg.start, 2
  %.13.i.2 = tail call i64 @llvm.smin.i64(i64 %.414, i64 %lsr.iv.next232.1)
  %.454.idx.2 = mul nsw i64 %.13.i.2, 80
  %.454.2 = getelementptr inbounds i8, ptr %arg.parameters.4, i64 %.454.idx.2
  %.533.2 = load double, ptr %.454.2, align 8
  %.561.2 = getelementptr i8, ptr %.454.2, i64 24
  %.562.2 = load double, ptr %.561.2, align 8
  %scevgep224.2 = getelementptr i8, ptr %0, i64 112
  %scevgep225.2 = getelementptr i8, ptr %0, i64 80
  store double %.533.2, ptr %scevgep225.2, align 8
  %scevgep226.2 = getelementptr i8, ptr %0, i64 88
  store double %.562.2, ptr %scevgep226.2, align 8
  %.653.2 = getelementptr i8, ptr %.454.2, i64 32
  %.654.2 = load double, ptr %.653.2, align 8
  %.682.2 = getelementptr i8, ptr %.454.2, i64 8
  %.683.2 = load double, ptr %.682.2, align 8
  %scevgep228.2 = getelementptr i8, ptr %0, i64 96
  store double %.654.2, ptr %scevgep228.2, align 8
  %scevgep229.2 = getelementptr i8, ptr %0, i64 104
  store double %.683.2, ptr %scevgep229.2, align 8
  %.775.2 = getelementptr i8, ptr %.454.2, i64 16
  %.776.2 = load double, ptr %.775.2, align 8
  store double %.776.2, ptr %scevgep224.2, align 8
  %lsr.iv.next232.2 = add i64 %arg.start, 3
  %.13.i.3 = tail call i64 @llvm.smin.i64(i64 %.414, i64 %lsr.iv.next232.2)
  %.454.idx.3 = mul nsw i64 %.13.i.3, 80
  %.454.3 = getelementptr inbounds i8, ptr %arg.parameters.4, i64 %.454.idx.3
  %.533.3 = load double, ptr %.454.3, align 8
  %.561.3 = getelementptr i8, ptr %.454.3, i64 24
  %.562.3 = load double, ptr %.561.3, align 8
  %scevgep224.3 = getelementptr i8, ptr %0, i64 152
  %scevgep225.3 = getelementptr i8, ptr %0, i64 120
  store double %.533.3, ptr %scevgep225.3, align 8
  %scevgep226.3 = getelementptr i8, ptr %0, i64 128
  store double %.562.3, ptr %scevgep226.3, align 8
  %.653.3 = getelementptr i8, ptr %.454.3, i64 32
  %.654.3 = load double, ptr %.653.3, align 8
  %.682.3 = getelementptr i8, ptr %.454.3, i64 8
  %.683.3 = load double, ptr %.682.3, align 8
  %scevgep228.3 = getelementptr i8, ptr %0, i64 136
  store double %.654.3, ptr %scevgep228.3, align 8
  %scevgep229.3 = getelementptr i8, ptr %0, i64 144
  store double %.683.3, ptr %scevgep229.3, align 8
  %.775.3 = getelementptr i8, ptr %.454.3, i64 16
  %.776.3 = load double, ptr %.775.3, align 8
  store double %.776.3, ptr %scevgep224.3, align 8
  %lsr.iv.next232.3 = add i64 %arg.start, 4
  %.13.i.4 = tail call i64 @llvm.smin.i64(i64 %.414, i64 %lsr.iv.next232.3)
  %.454.idx.4 = mul nsw i64 %.13.i.4, 80
  %.454.4 = getelementptr inbounds i8, ptr %arg.parameters.4, i64 %.454.idx.4
  %.533.4 = load double, ptr %.454.4, align 8
  %.561.4 = getelementptr i8, ptr %.454.4, i64 24
  %.562.4 = load double, ptr %.561.4, align 8
  %scevgep224.4 = getelementptr i8, ptr %0, i64 192
  %scevgep225.4 = getelementptr i8, ptr %0, i64 160
  store double %.533.4, ptr %scevgep225.4, align 8
  %scevgep226.4 = getelementptr i8, ptr %0, i64 168
  store double %.562.4, ptr %scevgep226.4, align 8
  %.653.4 = getelementptr i8, ptr %.454.4, i64 32
  %.654.4 = load double, ptr %.653.4, align 8
  %.682.4 = getelementptr i8, ptr %.454.4, i64 8
  %.683.4 = load double, ptr %.682.4, align 8
  %scevgep228.4 = getelementptr i8, ptr %0, i64 176
  store double %.654.4, ptr %scevgep228.4, align 8
  %scevgep229.4 = getelementptr i8, ptr %0, i64 184
  store double %.683.4, ptr %scevgep229.4, align 8
  %.775.4 = getelementptr i8, ptr %.454.4, i64 16
  %.776.4 = load double, ptr %.775.4, align 8
  store double %.776.4, ptr %scevgep224.4, align 8
  %lsr.iv.next232.4 = add i64 %arg.start, 5
  %.13.i.5 = tail call i64 @llvm.smin.i64(i64 %.414, i64 %lsr.iv.next232.4)
  %.454.idx.5 = mul nsw i64 %.13.i.5, 80
  %.454.5 = getelementptr inbounds i8, ptr %arg.parameters.4, i64 %.454.idx.5
  %.533.5 = load double, ptr %.454.5, align 8
  %.561.5 = getelementptr i8, ptr %.454.5, i64 24
  %.562.5 = load double, ptr %.561.5, align 8
  %scevgep224.5 = getelementptr i8, ptr %0, i64 232
  %scevgep225.5 = getelementptr i8, ptr %0, i64 200
  store double %.533.5, ptr %scevgep225.5, align 8
  %scevgep226.5 = getelementptr i8, ptr %0, i64 208
  store double %.562.5, ptr %scevgep226.5, align 8
  %.653.5 = getelementptr i8, ptr %.454.5, i64 32
  %.654.5 = load double, ptr %.653.5, align 8
  %.682.5 = getelementptr i8, ptr %.454.5, i64 8
  %.683.5 = load double, ptr %.682.5, align 8
  %scevgep228.5 = getelementptr i8, ptr %0, i64 216
  store double %.654.5, ptr %scevgep228.5, align 8
  %scevgep229.5 = getelementptr i8, ptr %0, i64 224
  store double %.683.5, ptr %scevgep229.5, align 8
  %.775.5 = getelementptr i8, ptr %.454.5, i64 16
  %.776.5 = load double, ptr %.775.5, align 8
  store double %.776.5, ptr %scevgep224.5, align 8
  %lsr.iv.next232.5 = add i64 %arg.start, 6
  %.13.i.6 = tail call i64 @llvm.smin.i64(i64 %.414, i64 %lsr.iv.next232.5)
  %.454.idx.6 = mul nsw i64 %.13.i.6, 80
  %.454.6 = getelementptr inbounds i8, ptr %arg.parameters.4, i64 %.454.idx.6
  %.533.6 = load double, ptr %.454.6, align 8
  %.561.6 = getelementptr i8, ptr %.454.6, i64 24
  %.562.6 = load double, ptr %.561.6, align 8
  %scevgep224.6 = getelementptr i8, ptr %0, i64 272
  %scevgep225.6 = getelementptr i8, ptr %0, i64 240
  store double %.533.6, ptr %scevgep225.6, align 8
  %scevgep226.6 = getelementptr i8, ptr %0, i64 248
  store double %.562.6, ptr %scevgep226.6, align 8
  %.653.6 = getelementptr i8, ptr %.454.6, i64 32
  %.654.6 = load double, ptr %.653.6, align 8
  %.682.6 = getelementptr i8, ptr %.454.6, i64 8
  %.683.6 = load double, ptr %.682.6, align 8
  %scevgep228.6 = getelementptr i8, ptr %0, i64 256
  store double %.654.6, ptr %scevgep228.6, align 8
  %scevgep229.6 = getelementptr i8, ptr %0, i64 264
  store double %.683.6, ptr %scevgep229.6, align 8
  %.775.6 = getelementptr i8, ptr %.454.6, i64 16
  %.776.6 = load double, ptr %.775.6, align 8
  store double %.776.6, ptr %scevgep224.6, align 8
  %lsr.iv.next232.6 = add i64 %arg.start, 7
  %.13.i.7 = tail call i64 @llvm.smin.i64(i64 %.414, i64 %lsr.iv.next232.6)
  %.454.idx.7 = mul nsw i64 %.13.i.7, 80
  %.454.7 = getelementptr inbounds i8, ptr %arg.parameters.4, i64 %.454.idx.7
  %.533.7 = load double, ptr %.454.7, align 8
  %.561.7 = getelementptr i8, ptr %.454.7, i64 24
  %.562.7 = load double, ptr %.561.7, align 8
  %scevgep224.7 = getelementptr i8, ptr %0, i64 312
  %scevgep225.7 = getelementptr i8, ptr %0, i64 280
  store double %.533.7, ptr %scevgep225.7, align 8
  %scevgep226.7 = getelementptr i8, ptr %0, i64 288
  store double %.562.7, ptr %scevgep226.7, align 8
  %.653.7 = getelementptr i8, ptr %.454.7, i64 32
  %.654.7 = load double, ptr %.653.7, align 8
  %.682.7 = getelementptr i8, ptr %.454.7, i64 8
  %.683.7 = load double, ptr %.682.7, align 8
  %scevgep228.7 = getelementptr i8, ptr %0, i64 296
  store double %.654.7, ptr %scevgep228.7, align 8
  %scevgep229.7 = getelementptr i8, ptr %0, i64 304
  store double %.683.7, ptr %scevgep229.7, align 8
  %.775.7 = getelementptr i8, ptr %.454.7, i64 16
  %.776.7 = load double, ptr %.775.7, align 8
  store double %.776.7, ptr %scevgep224.7, align 8
  %.fca.4.gep568 = getelementptr inbounds nuw i8, ptr %.1219, i64 32
  %.860 = getelementptr i8, ptr %arg.contents.4, i64 56
  %.861 = load i64, ptr %.860, align 8
  %.862 = sub i64 0, %.861
  %.870.1 = and i64 %.862, 9223372036854775800
  %.934 = getelementptr i8, ptr %arg.contents.4, i64 64
  %.935 = load i64, ptr %.934, align 8
  %.936 = sub i64 0, %.935
  %.944.1 = and i64 %.936, 9223372036854775800
  %1 = add nuw i64 %.944.1, %.870.1
  %.neg = mul i64 %1, -2
  %.981 = or disjoint i64 %.neg, 8
  %.999 = getelementptr i8, ptr %0, i64 320
  %.idx = mul i64 %1, -128
  %2 = getelementptr i8, ptr %0, i64 %.idx
  %.1075 = getelementptr i8, ptr %2, i64 832
  %.1161 = getelementptr i8, ptr %arg.arguments.4, i64 72
  %.1162 = load i64, ptr %.1161, align 8
  %.1163 = inttoptr i64 %.1162 to ptr
  %.1214 = sub i64 %arg.stop, %arg.start
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(56) %.1219, i8 0, i64 56, i1 false)
  call fastcc void @inner_3(ptr nonnull %.1219, ptr %0, i64 %.1214, ptr %arg.contents.4, ptr %.1163, ptr %arg.weights.4, ptr %.1075)
  %.1243.fca.4.load = load ptr, ptr %.fca.4.gep568, align 8
  %.fca.5.0.gep569 = getelementptr inbounds nuw i8, ptr %.1219, i64 40
  %.1243.fca.5.0.load = load i64, ptr %.fca.5.0.gep569, align 8
  %.1307 = getelementptr i8, ptr %arg.contents.4, i64 24
  %.1308 = load i64, ptr %.1307, align 8
  %.1309 = sub i64 0, %.1308
  %.1317.1 = and i64 %.1309, -8
  %.1385 = getelementptr i8, ptr %arg.contents.4, i64 104
  %.1386 = load i64, ptr %.1385, align 8
  %.1397 = getelementptr double, ptr %arg.weights.4, i64 %.1386
  %3 = add nuw i64 %.1214, 3
  %.1515 = lshr i64 %3, 2
  %.1494.inv = icmp slt i64 %.1214, 1
  %.15361452.not1490 = icmp eq i64 %.1515, 0
  %.15361452.not = select i1 %.1494.inv, i1 true, i1 %.15361452.not1490
  br i1 %.15361452.not, label %B1120, label %B1022.if.preheader

B1120:                                            ; preds = %B1118.endif.endif.endif, %entry
  %.1814 = getelementptr i8, ptr %arg.arguments.4, i64 160
  %.1815 = load i64, ptr %.1814, align 8
  %.1816.not = icmp eq i64 %.1815, 0
  br i1 %.1816.not, label %B1334, label %B1254

B1254:                                            ; preds = %B1120
  br i1 %.1494.inv, label %B2041, label %B1286.if.preheader

B1286.if.preheader:                               ; preds = %B1254
  %4 = add nuw i64 %.1214, 1
  %5 = shl i64 %arg.stop, 3
  %6 = inttoptr i64 %.1815 to ptr
  br label %B1286.if

B1334:                                            ; preds = %B1120
  br i1 %.1494.inv, label %B2041, label %B1524.if.preheader

B1524.if.preheader:                               ; preds = %B1286.if, %B1334
  %7 = add i64 %.1214, 1
  %8 = shl i64 %arg.start, 4
  %9 = getelementptr i8, ptr %arg.cross.4, i64 %8
  %scevgep = getelementptr i8, ptr %9, i64 8
  %10 = mul i64 %arg.start, 80
  %scevgep178 = getelementptr i8, ptr %arg.parameters.4, i64 %10
  %11 = shl i64 %.936, 1
  %12 = and i64 %11, 2305843009213693936
  %13 = shl i64 %.862, 1
  %14 = and i64 %13, 2305843009213693936
  %15 = add nuw nsw i64 %12, %14
  %16 = shl i64 %15, 3
  %17 = sub i64 64, %16
  %18 = shl i64 %arg.plus.5.0, 3
  %19 = shl i64 %arg.cross.5.0, 3
  br label %B1524.if

B1559:                                            ; preds = %B1524.if
  %20 = select i1 %.2287, i64 %18, i64 0
  %scevgep176 = getelementptr i8, ptr %arg.plus.4, i64 %20
  %21 = shl i64 %.223814691474, 3
  %scevgep177 = getelementptr i8, ptr %scevgep176, i64 %21
  %.2470 = load double, ptr %scevgep177, align 8
  %22 = select i1 %.2287, i64 %19, i64 0
  %scevgep175 = getelementptr i8, ptr %lsr.iv173, i64 %22
  %.2503 = load double, ptr %scevgep175, align 8
  store ptr null, ptr %.2509, align 8
  %.2525 = call fastcc i32 @inner_4(ptr nonnull %.2509, ptr nonnull %excinfo.16, i64 %.223814691474, ptr %lsr.iv179, ptr nonnull %lsr.iv183, i64 %.981, ptr %arg.arguments.4, ptr %arg.contents.4, ptr %arg.weights.4, ptr %.1075, double %.2470, double %.2503)
  %cond = icmp eq i32 %.2525, 0
  br i1 %cond, label %B1669, label %B1559.endif.endif.if, !prof !0

B1667:                                            ; preds = %B1524.if
  store ptr null, ptr %.2557, align 8
  call fastcc void @inner_5(ptr nonnull %.2557, i64 %.223814691474, ptr %arg.arguments.4)
  br label %B1669

B1669:                                            ; preds = %B1559, %B1667
  %lsr.iv.next = add i64 %lsr.iv, -1
  %scevgep174 = getelementptr i8, ptr %lsr.iv173, i64 16
  %scevgep180 = getelementptr i8, ptr %lsr.iv179, i64 80
  %scevgep184 = getelementptr i8, ptr %lsr.iv183, i64 %17
  %.2245 = add i64 %.223814691474, 1
  %.2232 = icmp sgt i64 %lsr.iv.next, 1
  br i1 %.2232, label %B1524.if, label %B2041

common.ret:                                       ; preds = %B1559.endif.endif.if, %B2041
  %common.ret.op = phi i32 [ 0, %B2041 ], [ %.2525, %B1559.endif.endif.if ]
  ret i32 %common.ret.op

B2041:                                            ; preds = %B1669, %B1254, %B1334
  store ptr null, ptr %retptr, align 8
  br label %common.ret

B1022.if.preheader:                               ; preds = %entry
  %23 = tail call i64 @llvm.smax.i64(i64 %.981, i64 31)
  %storemerge.i = lshr i64 %23, 5
  %.1046.i = and i64 %.neg, -32
  %.1086.i = lshr exact i64 %.981, 3
  %.1106806.i = and i64 %.1086.i, 3
  %.idx.i = shl i64 %.981, 4
  %.idx809.i = mul i64 %.981, 24
  %scevgep17.i = getelementptr i8, ptr %.1397, i64 192
  %24 = and i64 %23, 9223372036854775776
  %25 = lshr i64 %.1309, 3
  %.neg1 = mul i64 %25, -192
  %26 = getelementptr i8, ptr %.1243.fca.4.load, i64 %.neg1
  %scevgep193 = getelementptr i8, ptr %26, i64 248
  %27 = shl i64 %25, 8
  %28 = sub i64 256, %27
  %29 = shl i64 %25, 7
  %30 = sub i64 184, %29
  %scevgep198 = getelementptr i8, ptr %.1243.fca.4.load, i64 %30
  %31 = shl i64 %25, 6
  %32 = sub i64 120, %31
  %scevgep203 = getelementptr i8, ptr %.1243.fca.4.load, i64 %32
  %33 = icmp eq i64 %storemerge.i, 0
  br label %B1022.if

B1022.if:                                         ; preds = %B1118.endif.endif.endif, %B1022.if.preheader
  %lsr.iv208 = phi ptr [ %.1243.fca.4.load, %B1022.if.preheader ], [ %scevgep209, %B1118.endif.endif.endif ]
  %lsr.iv204 = phi ptr [ %scevgep203, %B1022.if.preheader ], [ %scevgep205, %B1118.endif.endif.endif ]
  %lsr.iv199 = phi ptr [ %scevgep198, %B1022.if.preheader ], [ %scevgep200, %B1118.endif.endif.endif ]
  %lsr.iv194 = phi ptr [ %scevgep193, %B1022.if.preheader ], [ %scevgep195, %B1118.endif.endif.endif ]
  %.153514461454 = phi i64 [ %.1515, %B1022.if.preheader ], [ %.1545, %B1118.endif.endif.endif ]
  %.154214491453 = phi i64 [ 0, %B1022.if.preheader ], [ %.1549, %B1118.endif.endif.endif ]
  %.1545 = add nsw i64 %.153514461454, -1
  %.1549 = add nuw i64 %.154214491453, 4
  %.1642 = mul nsw i64 %.154214491453, %.981
  %.1653 = getelementptr inbounds double, ptr %.999, i64 %.1642
  %.1734 = load i64, ptr %.1307, align 8
  %.1735 = add i64 %.1734, 1
  br i1 %33, label %B354.else.i, label %B84.if.lr.ph.i

B84.if.lr.ph.i:                                   ; preds = %B1022.if
  %34 = shl i64 %.1735, 8
  %35 = icmp slt i64 %.1734, 0
  br label %B84.if.i

B280.i:                                           ; preds = %B200.if.i, %B84.if.i
  %_multiply_wide_v57_a00.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B84.if.i ], [ %.577.i, %B200.if.i ]
  %_multiply_wide_v57_a01.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B84.if.i ], [ %.581.i, %B200.if.i ]
  %_multiply_wide_v57_a02.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B84.if.i ], [ %.589.i, %B200.if.i ]
  %_multiply_wide_v57_a03.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B84.if.i ], [ %.593.i, %B200.if.i ]
  %_multiply_wide_v57_a10.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B84.if.i ], [ %.614.i, %B200.if.i ]
  %_multiply_wide_v57_a11.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B84.if.i ], [ %.618.i, %B200.if.i ]
  %_multiply_wide_v57_a12.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B84.if.i ], [ %.626.i, %B200.if.i ]
  %_multiply_wide_v57_a13.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B84.if.i ], [ %.630.i, %B200.if.i ]
  %_multiply_wide_v57_a20.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B84.if.i ], [ %.652.i, %B200.if.i ]
  %_multiply_wide_v57_a21.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B84.if.i ], [ %.656.i, %B200.if.i ]
  %_multiply_wide_v57_a22.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B84.if.i ], [ %.664.i, %B200.if.i ]
  %_multiply_wide_v57_a23.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B84.if.i ], [ %.668.i, %B200.if.i ]
  %_multiply_wide_v57_a30.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B84.if.i ], [ %.690.i, %B200.if.i ]
  %_multiply_wide_v57_a31.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B84.if.i ], [ %.694.i, %B200.if.i ]
  %_multiply_wide_v57_a32.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B84.if.i ], [ %.702.i, %B200.if.i ]
  %_multiply_wide_v57_a33.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B84.if.i ], [ %.706.i, %B200.if.i ]
  store <8 x double> %_multiply_wide_v57_a00.2.1.lcssa.i, ptr %.237.i, align 8, !noalias !2
  %.765.i = getelementptr inbounds nuw i8, ptr %.237.i, i64 64
  store <8 x double> %_multiply_wide_v57_a01.2.1.lcssa.i, ptr %.765.i, align 8, !noalias !2
  %.776.i = getelementptr inbounds nuw i8, ptr %.237.i, i64 128
  store <8 x double> %_multiply_wide_v57_a02.2.1.lcssa.i, ptr %.776.i, align 8, !noalias !2
  %.787.i = getelementptr inbounds nuw i8, ptr %.237.i, i64 192
  store <8 x double> %_multiply_wide_v57_a03.2.1.lcssa.i, ptr %.787.i, align 8, !noalias !2
  %.817.i = getelementptr inbounds double, ptr %.237.i, i64 %.981
  store <8 x double> %_multiply_wide_v57_a10.2.1.lcssa.i, ptr %.817.i, align 8, !noalias !2
  %.827.i = getelementptr i8, ptr %.817.i, i64 64
  store <8 x double> %_multiply_wide_v57_a11.2.1.lcssa.i, ptr %.827.i, align 8, !noalias !2
  %.838.i = getelementptr i8, ptr %.817.i, i64 128
  store <8 x double> %_multiply_wide_v57_a12.2.1.lcssa.i, ptr %.838.i, align 8, !noalias !2
  %.849.i = getelementptr i8, ptr %.817.i, i64 192
  store <8 x double> %_multiply_wide_v57_a13.2.1.lcssa.i, ptr %.849.i, align 8, !noalias !2
  %.880.i = getelementptr inbounds i8, ptr %.237.i, i64 %.idx.i
  store <8 x double> %_multiply_wide_v57_a20.2.1.lcssa.i, ptr %.880.i, align 8, !noalias !2
  %.890.i = getelementptr i8, ptr %.880.i, i64 64
  store <8 x double> %_multiply_wide_v57_a21.2.1.lcssa.i, ptr %.890.i, align 8, !noalias !2
  %.901.i = getelementptr i8, ptr %.880.i, i64 128
  store <8 x double> %_multiply_wide_v57_a22.2.1.lcssa.i, ptr %.901.i, align 8, !noalias !2
  %.912.i = getelementptr i8, ptr %.880.i, i64 192
  store <8 x double> %_multiply_wide_v57_a23.2.1.lcssa.i, ptr %.912.i, align 8, !noalias !2
  %.950.i = getelementptr inbounds i8, ptr %.237.i, i64 %.idx809.i
  store <8 x double> %_multiply_wide_v57_a30.2.1.lcssa.i, ptr %.950.i, align 8, !noalias !2
  %.960.i = getelementptr i8, ptr %.950.i, i64 64
  store <8 x double> %_multiply_wide_v57_a31.2.1.lcssa.i, ptr %.960.i, align 8, !noalias !2
  %.971.i = getelementptr i8, ptr %.950.i, i64 128
  store <8 x double> %_multiply_wide_v57_a32.2.1.lcssa.i, ptr %.971.i, align 8, !noalias !2
  %.982.i = getelementptr i8, ptr %.950.i, i64 192
  store <8 x double> %_multiply_wide_v57_a33.2.1.lcssa.i, ptr %.982.i, align 8, !noalias !2
  %scevgep19.i = getelementptr i8, ptr %lsr.iv18.i, i64 %34
  %.187.i = icmp sgt i64 %.186856868.i, 1
  br i1 %.187.i, label %B84.if.i, label %B354.else.loopexit.i

B3459.loopexit.i:                                 ; preds = %B884.if.i
  %36 = add i64 %position.5.0901.i, %42
  br label %B3459.i

B3459.i:                                          ; preds = %B356.if.i, %B3459.loopexit.i
  %position.4.1.lcssa.i = phi i64 [ %position.5.0901.i, %B356.if.i ], [ %36, %B3459.loopexit.i ]
  %b0.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B356.if.i ], [ %.1337.i, %B3459.loopexit.i ]
  %b1.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B356.if.i ], [ %.1356.i, %B3459.loopexit.i ]
  %b2.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B356.if.i ], [ %.1376.i, %B3459.loopexit.i ]
  %b3.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B356.if.i ], [ %.1396.i, %B3459.loopexit.i ]
  %.1418.i = getelementptr inbounds double, ptr %.1653, i64 %.1135893899.i
  store <8 x double> %b0.2.1.lcssa.i, ptr %.1418.i, align 8, !noalias !2
  %.1434.i = getelementptr double, ptr %39, i64 %.1135893899.i
  store <8 x double> %b1.2.1.lcssa.i, ptr %.1434.i, align 8, !noalias !2
  %.1451.i = getelementptr double, ptr %40, i64 %.1135893899.i
  store <8 x double> %b2.2.1.lcssa.i, ptr %.1451.i, align 8, !noalias !2
  %.1470.i = getelementptr double, ptr %41, i64 %.1135893899.i
  store <8 x double> %b3.2.1.lcssa.i, ptr %.1470.i, align 8, !noalias !2
  %.1129.i = icmp sgt i64 %.1128892900.i, 1
  br i1 %.1129.i, label %B356.if.i, label %B1118.endif.endif.endif

B84.if.i:                                         ; preds = %B280.i, %B84.if.lr.ph.i
  %lsr.iv18.i = phi ptr [ %scevgep17.i, %B84.if.lr.ph.i ], [ %scevgep19.i, %B280.i ]
  %.186856868.i = phi i64 [ %storemerge.i, %B84.if.lr.ph.i ], [ %.196.i, %B280.i ]
  %.193857867.i = phi i64 [ 0, %B84.if.lr.ph.i ], [ %.200.i, %B280.i ]
  %.196.i = add nsw i64 %.186856868.i, -1
  %.200.i = add nuw nsw i64 %.193857867.i, 32
  %.237.i = getelementptr inbounds nuw double, ptr %.1653, i64 %.193857867.i
  br i1 %35, label %B280.i, label %B200.if.i

B200.if.i:                                        ; preds = %B84.if.i, %B200.if.i
  %lsr.iv191 = phi i64 [ %lsr.iv.next192, %B200.if.i ], [ -1, %B84.if.i ]
  %lsr.iv20.i = phi ptr [ %scevgep21.i, %B200.if.i ], [ %lsr.iv18.i, %B84.if.i ]
  %_multiply_wide_v57_a33.2.1838.i = phi <8 x double> [ %.706.i, %B200.if.i ], [ zeroinitializer, %B84.if.i ]
  %_multiply_wide_v57_a32.2.1837.i = phi <8 x double> [ %.702.i, %B200.if.i ], [ zeroinitializer, %B84.if.i ]
  %_multiply_wide_v57_a31.2.1836.i = phi <8 x double> [ %.694.i, %B200.if.i ], [ zeroinitializer, %B84.if.i ]
  %_multiply_wide_v57_a30.2.1835.i = phi <8 x double> [ %.690.i, %B200.if.i ], [ zeroinitializer, %B84.if.i ]
  %_multiply_wide_v57_a23.2.1834.i = phi <8 x double> [ %.668.i, %B200.if.i ], [ zeroinitializer, %B84.if.i ]
  %_multiply_wide_v57_a22.2.1833.i = phi <8 x double> [ %.664.i, %B200.if.i ], [ zeroinitializer, %B84.if.i ]
  %_multiply_wide_v57_a21.2.1832.i = phi <8 x double> [ %.656.i, %B200.if.i ], [ zeroinitializer, %B84.if.i ]
  %_multiply_wide_v57_a20.2.1831.i = phi <8 x double> [ %.652.i, %B200.if.i ], [ zeroinitializer, %B84.if.i ]
  %_multiply_wide_v57_a13.2.1830.i = phi <8 x double> [ %.630.i, %B200.if.i ], [ zeroinitializer, %B84.if.i ]
  %_multiply_wide_v57_a12.2.1829.i = phi <8 x double> [ %.626.i, %B200.if.i ], [ zeroinitializer, %B84.if.i ]
  %_multiply_wide_v57_a11.2.1828.i = phi <8 x double> [ %.618.i, %B200.if.i ], [ zeroinitializer, %B84.if.i ]
  %_multiply_wide_v57_a10.2.1827.i = phi <8 x double> [ %.614.i, %B200.if.i ], [ zeroinitializer, %B84.if.i ]
  %_multiply_wide_v57_a03.2.1826.i = phi <8 x double> [ %.593.i, %B200.if.i ], [ zeroinitializer, %B84.if.i ]
  %_multiply_wide_v57_a02.2.1825.i = phi <8 x double> [ %.589.i, %B200.if.i ], [ zeroinitializer, %B84.if.i ]
  %_multiply_wide_v57_a01.2.1824.i = phi <8 x double> [ %.581.i, %B200.if.i ], [ zeroinitializer, %B84.if.i ]
  %_multiply_wide_v57_a00.2.1823.i = phi <8 x double> [ %.577.i, %B200.if.i ], [ zeroinitializer, %B84.if.i ]
  %scevgep24.i = getelementptr i8, ptr %lsr.iv20.i, i64 -192
  %.520.i = load <8 x double>, ptr %scevgep24.i, align 8, !noalias !2
  %scevgep23.i = getelementptr i8, ptr %lsr.iv20.i, i64 -128
  %.532.i = load <8 x double>, ptr %scevgep23.i, align 8, !noalias !2
  %scevgep22.i = getelementptr i8, ptr %lsr.iv20.i, i64 -64
  %.545.i = load <8 x double>, ptr %scevgep22.i, align 8, !noalias !2
  %.558.i = load <8 x double>, ptr %lsr.iv20.i, align 8, !noalias !2
  %37 = shl i64 %lsr.iv191, 3
  %scevgep210 = getelementptr i8, ptr %lsr.iv208, i64 %37
  %scevgep211 = getelementptr i8, ptr %scevgep210, i64 64
  %.573.i = load double, ptr %scevgep211, align 8, !noalias !2
  %.575.i = insertelement <8 x double> poison, double %.573.i, i64 0
  %.576.i = shufflevector <8 x double> %.575.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.577.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.520.i, <8 x double> %.576.i, <8 x double> %_multiply_wide_v57_a00.2.1823.i)
  %.581.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.532.i, <8 x double> %.576.i, <8 x double> %_multiply_wide_v57_a01.2.1824.i)
  %.589.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.545.i, <8 x double> %.576.i, <8 x double> %_multiply_wide_v57_a02.2.1825.i)
  %.593.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.558.i, <8 x double> %.576.i, <8 x double> %_multiply_wide_v57_a03.2.1826.i)
  %scevgep20 = getelementptr i8, ptr %lsr.iv204, i64 %37
  %scevgep22 = getelementptr i8, ptr %scevgep20, i64 8
  %.610.i = load double, ptr %scevgep22, align 8, !noalias !2
  %.612.i = insertelement <8 x double> poison, double %.610.i, i64 0
  %.613.i = shufflevector <8 x double> %.612.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.614.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.520.i, <8 x double> %.613.i, <8 x double> %_multiply_wide_v57_a10.2.1827.i)
  %.618.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.532.i, <8 x double> %.613.i, <8 x double> %_multiply_wide_v57_a11.2.1828.i)
  %.626.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.545.i, <8 x double> %.613.i, <8 x double> %_multiply_wide_v57_a12.2.1829.i)
  %.630.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.558.i, <8 x double> %.613.i, <8 x double> %_multiply_wide_v57_a13.2.1830.i)
  %scevgep10 = getelementptr i8, ptr %lsr.iv199, i64 %37
  %scevgep11 = getelementptr i8, ptr %scevgep10, i64 8
  %.648.i = load double, ptr %scevgep11, align 8, !noalias !2
  %.650.i = insertelement <8 x double> poison, double %.648.i, i64 0
  %.651.i = shufflevector <8 x double> %.650.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.652.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.520.i, <8 x double> %.651.i, <8 x double> %_multiply_wide_v57_a20.2.1831.i)
  %.656.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.532.i, <8 x double> %.651.i, <8 x double> %_multiply_wide_v57_a21.2.1832.i)
  %.664.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.545.i, <8 x double> %.651.i, <8 x double> %_multiply_wide_v57_a22.2.1833.i)
  %.668.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.558.i, <8 x double> %.651.i, <8 x double> %_multiply_wide_v57_a23.2.1834.i)
  %scevgep2 = getelementptr i8, ptr %lsr.iv194, i64 %37
  %scevgep3 = getelementptr i8, ptr %scevgep2, i64 8
  %.686.i = load double, ptr %scevgep3, align 8, !noalias !2
  %.688.i = insertelement <8 x double> poison, double %.686.i, i64 0
  %.689.i = shufflevector <8 x double> %.688.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.690.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.520.i, <8 x double> %.689.i, <8 x double> %_multiply_wide_v57_a30.2.1835.i)
  %.694.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.532.i, <8 x double> %.689.i, <8 x double> %_multiply_wide_v57_a31.2.1836.i)
  %.702.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.545.i, <8 x double> %.689.i, <8 x double> %_multiply_wide_v57_a32.2.1837.i)
  %.706.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.558.i, <8 x double> %.689.i, <8 x double> %_multiply_wide_v57_a33.2.1838.i)
  %scevgep21.i = getelementptr i8, ptr %lsr.iv20.i, i64 256
  %lsr.iv.next192 = add nsw i64 %lsr.iv191, 1
  %exitcond.not.i = icmp eq i64 %.1734, %lsr.iv.next192
  br i1 %exitcond.not.i, label %B280.i, label %B200.if.i

B354.else.loopexit.i:                             ; preds = %B280.i
  %38 = mul i64 %.1735, %24
  br label %B354.else.i

B354.else.i:                                      ; preds = %B354.else.loopexit.i, %B1022.if
  %position.3.0.lcssa.i = phi i64 [ 0, %B1022.if ], [ %38, %B354.else.loopexit.i ]
  %.arg.count815.i = tail call i64 @llvm.smax.i64(i64 %.1735, i64 0)
  %39 = getelementptr double, ptr %.1653, i64 %.981
  %40 = getelementptr i8, ptr %.1653, i64 %.idx.i
  %41 = getelementptr i8, ptr %.1653, i64 %.idx809.i
  %42 = shl i64 %.arg.count815.i, 3
  %43 = icmp slt i64 %.1734, 0
  br label %B356.if.i

B356.if.i:                                        ; preds = %B354.else.i, %B3459.i
  %position.5.0901.i = phi i64 [ %position.3.0.lcssa.i, %B354.else.i ], [ %position.4.1.lcssa.i, %B3459.i ]
  %.1128892900.i = phi i64 [ %.1106806.i, %B354.else.i ], [ %.1138.i, %B3459.i ]
  %.1135893899.i = phi i64 [ %.1046.i, %B354.else.i ], [ %.1142.i, %B3459.i ]
  %.1138.i = add nsw i64 %.1128892900.i, -1
  %.1142.i = add nuw nsw i64 %.1135893899.i, 8
  br i1 %43, label %B3459.i, label %B884.if.preheader.i

B884.if.preheader.i:                              ; preds = %B356.if.i
  %44 = shl i64 %position.5.0901.i, 3
  %scevgep.i = getelementptr i8, ptr %.1397, i64 %44
  br label %B884.if.i

B884.if.i:                                        ; preds = %B884.if.i, %B884.if.preheader.i
  %lsr.iv26 = phi i64 [ %lsr.iv.next27, %B884.if.i ], [ %.1735, %B884.if.preheader.i ]
  %lsr.iv23 = phi i64 [ %lsr.iv.next24, %B884.if.i ], [ 0, %B884.if.preheader.i ]
  %b3.2.1884.i = phi <8 x double> [ %.1396.i, %B884.if.i ], [ zeroinitializer, %B884.if.preheader.i ]
  %b2.2.1883.i = phi <8 x double> [ %.1376.i, %B884.if.i ], [ zeroinitializer, %B884.if.preheader.i ]
  %b1.2.1882.i = phi <8 x double> [ %.1356.i, %B884.if.i ], [ zeroinitializer, %B884.if.preheader.i ]
  %b0.2.1881.i = phi <8 x double> [ %.1337.i, %B884.if.i ], [ zeroinitializer, %B884.if.preheader.i ]
  %45 = shl i64 %lsr.iv23, 3
  %scevgep25 = getelementptr i8, ptr %scevgep.i, i64 %45
  %.1318.i = load <8 x double>, ptr %scevgep25, align 8, !noalias !2
  %scevgep31 = getelementptr i8, ptr %lsr.iv208, i64 %lsr.iv23
  %scevgep32 = getelementptr i8, ptr %scevgep31, i64 56
  %.1333.i = load double, ptr %scevgep32, align 8, !noalias !2
  %.1335.i = insertelement <8 x double> poison, double %.1333.i, i64 0
  %.1336.i = shufflevector <8 x double> %.1335.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1337.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1318.i, <8 x double> %.1336.i, <8 x double> %b0.2.1881.i)
  %scevgep30 = getelementptr i8, ptr %lsr.iv204, i64 %lsr.iv23
  %.1352.i = load double, ptr %scevgep30, align 8, !noalias !2
  %.1354.i = insertelement <8 x double> poison, double %.1352.i, i64 0
  %.1355.i = shufflevector <8 x double> %.1354.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1356.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1318.i, <8 x double> %.1355.i, <8 x double> %b1.2.1882.i)
  %scevgep29 = getelementptr i8, ptr %lsr.iv199, i64 %lsr.iv23
  %.1372.i = load double, ptr %scevgep29, align 8, !noalias !2
  %.1374.i = insertelement <8 x double> poison, double %.1372.i, i64 0
  %.1375.i = shufflevector <8 x double> %.1374.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1376.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1318.i, <8 x double> %.1375.i, <8 x double> %b2.2.1883.i)
  %scevgep28 = getelementptr i8, ptr %lsr.iv194, i64 %lsr.iv23
  %.1392.i = load double, ptr %scevgep28, align 8, !noalias !2
  %.1394.i = insertelement <8 x double> poison, double %.1392.i, i64 0
  %.1395.i = shufflevector <8 x double> %.1394.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1396.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1318.i, <8 x double> %.1395.i, <8 x double> %b3.2.1884.i)
  %lsr.iv.next24 = add i64 %lsr.iv23, 8
  %lsr.iv.next27 = add i64 %lsr.iv26, -1
  %exitcond909.not.i = icmp eq i64 %lsr.iv.next27, 0
  br i1 %exitcond909.not.i, label %B3459.loopexit.i, label %B884.if.i

B1118.endif.endif.endif:                          ; preds = %B3459.i
  %scevgep195 = getelementptr i8, ptr %lsr.iv194, i64 %28
  %scevgep200 = getelementptr i8, ptr %lsr.iv199, i64 %28
  %scevgep205 = getelementptr i8, ptr %lsr.iv204, i64 %28
  %scevgep209 = getelementptr i8, ptr %lsr.iv208, i64 %28
  %.1536 = icmp sgt i64 %.153514461454, 1
  br i1 %.1536, label %B1022.if, label %B1120

B1286.if:                                         ; preds = %B1286.if, %B1286.if.preheader
  %lsr.iv189 = phi i64 [ 7, %B1286.if.preheader ], [ %lsr.iv.next190, %B1286.if ]
  %lsr.iv185 = phi i64 [ %4, %B1286.if.preheader ], [ %lsr.iv.next186, %B1286.if ]
  %.199114591461 = phi i64 [ %arg.start, %B1286.if.preheader ], [ %.1998, %B1286.if ]
  %.1998 = add i64 %.199114591461, 1
  %.2058 = load i64, ptr %.1307, align 8
  %46 = add i64 %.2058, %lsr.iv189
  %.2073 = icmp slt i64 %46, 0
  %.2074 = select i1 %.2073, i64 %.1243.fca.5.0.load, i64 0
  %47 = getelementptr double, ptr %.1243.fca.4.load, i64 %46
  %.2088 = getelementptr double, ptr %47, i64 %.2074
  %.2089 = load double, ptr %.2088, align 8
  %.2097.le = tail call contract double @llvm.exp.f64(double %.2089)
  %.2115 = icmp slt i64 %.199114591461, 0
  %48 = select i1 %.2115, i64 %5, i64 0
  %scevgep187 = getelementptr i8, ptr %6, i64 %48
  %49 = shl i64 %.199114591461, 3
  %scevgep188 = getelementptr i8, ptr %scevgep187, i64 %49
  store double %.2097.le, ptr %scevgep188, align 8
  %lsr.iv.next186 = add i64 %lsr.iv185, -1
  %reass.sub1 = sub i64 %lsr.iv189, %.1317.1
  %lsr.iv.next190 = add i64 %reass.sub1, 8
  %.1985 = icmp sgt i64 %lsr.iv.next186, 1
  br i1 %.1985, label %B1286.if, label %B1524.if.preheader

B1524.if:                                         ; preds = %B1669, %B1524.if.preheader
  %lsr.iv183 = phi ptr [ %.999, %B1524.if.preheader ], [ %scevgep184, %B1669 ]
  %lsr.iv179 = phi ptr [ %scevgep178, %B1524.if.preheader ], [ %scevgep180, %B1669 ]
  %lsr.iv173 = phi ptr [ %scevgep, %B1524.if.preheader ], [ %scevgep174, %B1669 ]
  %lsr.iv = phi i64 [ %7, %B1524.if.preheader ], [ %lsr.iv.next, %B1669 ]
  %.223814691474 = phi i64 [ %arg.start, %B1524.if.preheader ], [ %.2245, %B1669 ]
  %.2287 = icmp slt i64 %.223814691474, 0
  %.2288 = select i1 %.2287, i64 %arg.status.5.0, i64 0
  %scevgep181 = getelementptr i8, ptr %arg.status.4, i64 %.2288
  %scevgep182 = getelementptr i8, ptr %scevgep181, i64 %.223814691474
  %.2303 = load i8, ptr %scevgep182, align 1
  %.2305 = icmp eq i8 %.2303, 0
  br i1 %.2305, label %B1559, label %B1667

B1559.endif.endif.if:                             ; preds = %B1559
  %.2526 = load ptr, ptr %excinfo.16, align 8
  store ptr %.2526, ptr %excinfo, align 8
  br label %common.ret
}

; Function Attrs: nofree noinline norecurse nosync nounwind memory(readwrite, inaccessiblemem: none, target_mem0: none, target_mem1: none)
define internal fastcc void @inner_3(ptr noalias nonnull writeonly captures(none) %retptr, ptr readonly captures(none) %arg.parameters.4, i64 %arg.rows, ptr readonly captures(none) %arg.contents.4, ptr readonly captures(none) %arg.exponents.4, ptr readonly captures(none) %arg.weights.4, ptr %arg.scratch.4) unnamed_addr #5 {
entry:
  %.1082 = alloca ptr, align 8
  store ptr null, ptr %.1082, align 8
  %.2759 = alloca ptr, align 8
  store ptr null, ptr %.2759, align 8
  %.102 = getelementptr i8, ptr %arg.contents.4, i64 24
  %.103 = load i64, ptr %.102, align 8
  %.104 = sub i64 0, %.103
  %.112.1 = and i64 %.104, -8
  %.146 = sub i64 0, %.112.1
  %.151 = sub i64 8, %.112.1
  %.156 = shl nsw i64 %.151, 3
  %.209 = icmp slt i64 %.151, 0
  %.210 = select i1 %.209, i64 1073741824, i64 0
  %.211 = add i64 %.210, %.156
  %.214 = icmp slt i64 %.211, 0
  br i1 %.214, label %B0.endif.else.endif.endif.if, label %B0.endif.else.endif.endif.endif, !prof !5

B506:                                             ; preds = %B418.if
  %.1525 = getelementptr i8, ptr %arg.contents.4, i64 16
  %.1526 = load i64, ptr %.1525, align 8
  %.53.i = add nsw i64 %.1526, 1
  %.54.i = shl nsw i64 %.53.i, 3
  %.59.i = mul nsw i64 %.53.i, 40
  %.96.i = icmp slt i64 %.1526, -1
  %.97.i = select i1 %.96.i, i64 %.808, i64 0
  %.98.i = add i64 %.97.i, %.59.i
  %.101.i = icmp slt i64 %.98.i, 0
  br i1 %.101.i, label %B0.else.if.i, label %B0.else.endif.i, !prof !5

B414.i:                                           ; preds = %B282.if.i, %B88.else.endif.endif.i
  %exitcond473.not.i = icmp eq i64 %.331.i, 5
  br i1 %exitcond473.not.i, label %B416.i, label %B86.if.i

B416.i:                                           ; preds = %B414.i
  %.199.i = getelementptr double, ptr %.824, i64 %.86.sroa.0.3.i
  %.idx.i = shl i64 %.53.i, 7
  %0 = getelementptr i8, ptr %.824, i64 %.idx.i
  %.idx411.i = mul i64 %.53.i, 192
  %1 = getelementptr i8, ptr %.824, i64 %.idx411.i
  %.idx412.i = shl i64 %.53.i, 8
  %2 = getelementptr i8, ptr %.824, i64 %.idx412.i
  %scevgep.i = getelementptr i8, ptr %arg.exponents.4, i64 32
  br label %B448.if.i

B0.else.if.i:                                     ; preds = %B506
  br label %B0.else.endif.i

B0.else.endif.i:                                  ; preds = %B0.else.if.i, %B506
  %.86.sroa.0.1.i = phi i64 [ 0, %B0.else.if.i ], [ %.98.i, %B506 ]
  %.106.not.i = icmp slt i64 %.98.i, %.808
  br i1 %.106.not.i, label %B0.else.endif.endif.i, label %B0.else.endif.if.i, !prof !1

B0.else.endif.if.i:                               ; preds = %B0.else.endif.i
  br label %B0.else.endif.endif.i

B0.else.endif.endif.i:                            ; preds = %B0.else.endif.if.i, %B0.else.endif.i
  %.86.sroa.0.3.i = phi i64 [ %.808, %B0.else.endif.if.i ], [ %.86.sroa.0.1.i, %B0.else.endif.i ]
  %storemerge413.i = tail call i64 @llvm.smax.i64(i64 %.1526, i64 0)
  %scevgep29.i = getelementptr i8, ptr %.824, i64 64
  %3 = icmp slt i64 %.1526, 1
  br label %B86.if.i

B86.if.i:                                         ; preds = %B0.else.endif.endif.i, %B414.i
  %.324433441.i = phi i64 [ 0, %B0.else.endif.endif.i ], [ %.331.i, %B414.i ]
  %.331.i = add nuw nsw i64 %.324433441.i, 1
  %.364.idx.i = shl nsw i64 %.324433441.i, 6
  %.364.i = getelementptr inbounds nuw i8, ptr %.653, i64 %.364.idx.i
  %.366.i = load <8 x double>, ptr %.364.i, align 8, !noalias !6
  %.371.i = mul nsw i64 %.324433441.i, %.54.i
  %.411.i = icmp slt i64 %.371.i, 0
  %.412.i = select i1 %.411.i, i64 %.808, i64 0
  %.413.i = add i64 %.412.i, %.371.i
  %.416.i = icmp slt i64 %.413.i, 0
  br i1 %.416.i, label %B88.else.if.i, label %B88.else.endif.i, !prof !5

B88.else.if.i:                                    ; preds = %B86.if.i
  br label %B88.else.endif.i

B88.else.endif.i:                                 ; preds = %B88.else.if.i, %B86.if.i
  %.401.sroa.0.1.i = phi i64 [ 0, %B88.else.if.i ], [ %.413.i, %B86.if.i ]
  %.421.not.i = icmp slt i64 %.413.i, %.808
  br i1 %.421.not.i, label %B88.else.endif.endif.i, label %B88.else.endif.if.i, !prof !1

B88.else.endif.if.i:                              ; preds = %B88.else.endif.i
  br label %B88.else.endif.endif.i

B88.else.endif.endif.i:                           ; preds = %B88.else.endif.if.i, %B88.else.endif.i
  %.401.sroa.0.3.i = phi i64 [ %.808, %B88.else.endif.if.i ], [ %.401.sroa.0.1.i, %B88.else.endif.i ]
  %.514.i = getelementptr double, ptr %.824, i64 %.401.sroa.0.3.i
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
  %lsr.iv26.i = phi i64 [ %.1463, %B416.i ], [ %lsr.iv.next.i, %B448.if.i ]
  %lsr.iv24.i = phi ptr [ %.199.i, %B416.i ], [ %scevgep25.i, %B448.if.i ]
  %lsr.iv.i = phi ptr [ %scevgep.i, %B416.i ], [ %scevgep19.i, %B448.if.i ]
  %scevgep20.i = getelementptr i8, ptr %lsr.iv.i, i64 -32
  %.920.i = load i64, ptr %scevgep20.i, align 8, !noalias !6
  %.929.idx.i = shl nsw i64 %.920.i, 6
  %.929.i = getelementptr inbounds i8, ptr %.824, i64 %.929.idx.i
  %.931.i = load <8 x double>, ptr %.929.i, align 8, !noalias !6
  %scevgep21.i = getelementptr i8, ptr %lsr.iv.i, i64 -24
  %.942.i = load i64, ptr %scevgep21.i, align 8, !noalias !6
  %.54410.i = add i64 %.942.i, %.53.i
  %.953.idx.i = shl i64 %.54410.i, 6
  %.953.i = getelementptr inbounds i8, ptr %.824, i64 %.953.idx.i
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
  br i1 %exitcond474.not.i, label %_ZN17bnserve_surrogate6kernel11_regression9_productsB3v41B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedExx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit, label %B448.if.i

_ZN17bnserve_surrogate6kernel11_regression9_productsB3v41B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedExx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit: ; preds = %B448.if.i
  %.174.i = sub nsw i64 %.808, %.86.sroa.0.3.i
  %.183.i = tail call i64 @llvm.smax.i64(i64 %.174.i, i64 0)
  %.1610 = getelementptr i8, ptr %arg.contents.4, i64 88
  %.1611 = load i64, ptr %.1610, align 8
  %5 = lshr i64 %.1611, 33
  %.1649 = and i64 %5, 1073741824
  %.1650 = add i64 %.1649, %.1611
  %.1653 = icmp slt i64 %.1650, 0
  br i1 %.1653, label %B506.endif.else.if, label %B506.endif.else.endif, !prof !5

B854:                                             ; preds = %B706.endif.endif.endif, %B506.endif.else.endif.endif, %B418.if
  %.2372 = getelementptr i8, ptr %arg.contents.4, i64 32
  %.2373 = load i64, ptr %.2372, align 8
  %.2374 = icmp sgt i64 %.2373, 0
  br i1 %.2374, label %B898, label %B1014

B898:                                             ; preds = %B854
  %.2405 = getelementptr i8, ptr %arg.contents.4, i64 96
  %.2406 = load i64, ptr %.2405, align 8
  %6 = lshr i64 %.2406, 33
  %.2444 = and i64 %6, 1073741824
  %.2445 = add i64 %.2444, %.2406
  %.2448 = icmp slt i64 %.2445, 0
  br i1 %.2448, label %B898.else.if, label %B898.else.endif, !prof !5

B1014:                                            ; preds = %B898.endif.else.endif.endif, %B854
  %retptr.repack1017 = getelementptr inbounds nuw i8, ptr %retptr, i64 16
  tail call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(16) %retptr, i8 0, i64 16, i1 false)
  store i64 %.182.sroa.13.2, ptr %retptr.repack1017, align 8
  %retptr.repack1019 = getelementptr inbounds nuw i8, ptr %retptr, i64 24
  store i64 8, ptr %retptr.repack1019, align 8
  %retptr.repack1021 = getelementptr inbounds nuw i8, ptr %retptr, i64 32
  store ptr %arg.scratch.4, ptr %retptr.repack1021, align 8
  %retptr.repack1023 = getelementptr inbounds nuw i8, ptr %retptr, i64 40
  store i64 %.182.sroa.13.2, ptr %retptr.repack1023, align 8
  %retptr.repack1025 = getelementptr inbounds nuw i8, ptr %retptr, i64 48
  store i64 8, ptr %retptr.repack1025, align 8
  ret void

B0.endif.else.endif.endif.if:                     ; preds = %entry
  br label %B0.endif.else.endif.endif.endif

B0.endif.else.endif.endif.endif:                  ; preds = %B0.endif.else.endif.endif.if, %entry
  %.182.sroa.13.1 = phi i64 [ 0, %B0.endif.else.endif.endif.if ], [ %.211, %entry ]
  %.219.not = icmp slt i64 %.211, 1073741824
  br i1 %.219.not, label %B0.endif.else.endif.endif.endif.endif, label %B0.endif.else.endif.endif.endif.if, !prof !1

B0.endif.else.endif.endif.endif.if:               ; preds = %B0.endif.else.endif.endif.endif
  br label %B0.endif.else.endif.endif.endif.endif

B0.endif.else.endif.endif.endif.endif:            ; preds = %B0.endif.else.endif.endif.endif.if, %B0.endif.else.endif.endif.endif
  %.182.sroa.13.2 = phi i64 [ 1073741824, %B0.endif.else.endif.endif.endif.if ], [ %.182.sroa.13.1, %B0.endif.else.endif.endif.endif ]
  br i1 %.214, label %B0.endif.endif.else.if, label %B0.endif.endif.else.endif, !prof !5

B0.endif.endif.else.if:                           ; preds = %B0.endif.else.endif.endif.endif.endif
  br label %B0.endif.endif.else.endif

B0.endif.endif.else.endif:                        ; preds = %B0.endif.endif.else.if, %B0.endif.else.endif.endif.endif.endif
  %.354.sroa.0.1 = phi i64 [ 0, %B0.endif.endif.else.if ], [ %.211, %B0.endif.else.endif.endif.endif.endif ]
  br i1 %.219.not, label %B0.endif.endif.else.endif.endif, label %B0.endif.endif.else.endif.if, !prof !1

B0.endif.endif.else.endif.if:                     ; preds = %B0.endif.endif.else.endif
  br label %B0.endif.endif.else.endif.endif

B0.endif.endif.else.endif.endif:                  ; preds = %B0.endif.endif.else.endif.if, %B0.endif.endif.else.endif
  %.354.sroa.0.3 = phi i64 [ 1073741824, %B0.endif.endif.else.endif.if ], [ %.354.sroa.0.1, %B0.endif.endif.else.endif ]
  %.442 = sub nsw i64 1073741824, %.354.sroa.0.3
  %.449 = icmp sgt i64 %.354.sroa.0.3, 1073741823
  %.451 = select i1 %.449, i64 0, i64 %.442
  %.467 = getelementptr double, ptr %arg.scratch.4, i64 %.354.sroa.0.3
  br i1 %.449, label %B0.endif.endif.endif.else.endif.if, label %B0.endif.endif.endif.else.endif.endif, !prof !5

B0.endif.endif.endif.else.endif.if:               ; preds = %B0.endif.endif.else.endif.endif
  br label %B0.endif.endif.endif.else.endif.endif

B0.endif.endif.endif.else.endif.endif:            ; preds = %B0.endif.endif.endif.else.endif.if, %B0.endif.endif.else.endif.endif
  %.540.sroa.0.3 = phi i64 [ %.451, %B0.endif.endif.endif.else.endif.if ], [ 0, %B0.endif.endif.else.endif.endif ]
  %.577 = icmp slt i64 %.451, 41
  %.653 = getelementptr double, ptr %.467, i64 %.540.sroa.0.3
  br i1 %.577, label %B0.endif.endif.endif.endif.else.endif.if, label %B0.endif.endif.endif.endif.else.endif.endif, !prof !5

B0.endif.endif.endif.endif.else.endif.if:         ; preds = %B0.endif.endif.endif.else.endif.endif
  br label %B0.endif.endif.endif.endif.else.endif.endif

B0.endif.endif.endif.endif.else.endif.endif:      ; preds = %B0.endif.endif.endif.endif.else.endif.if, %B0.endif.endif.endif.else.endif.endif
  %.711.sroa.0.3 = phi i64 [ %.451, %B0.endif.endif.endif.endif.else.endif.if ], [ 40, %B0.endif.endif.endif.else.endif.endif ]
  %.799 = sub nsw i64 %.451, %.711.sroa.0.3
  %.808 = tail call i64 @llvm.smax.i64(i64 %.799, i64 0)
  %.824 = getelementptr double, ptr %.467, i64 %.711.sroa.0.3
  %.906 = getelementptr i8, ptr %arg.contents.4, i64 80
  %.907 = load i64, ptr %.906, align 8
  %7 = lshr i64 %.907, 33
  %.945 = and i64 %7, 1073741824
  %.946 = add i64 %.945, %.907
  %.949 = icmp slt i64 %.946, 0
  br i1 %.949, label %B0.endif.endif.endif.endif.endif.else.if, label %B0.endif.endif.endif.endif.endif.else.endif, !prof !5

B0.endif.endif.endif.endif.endif.else.if:         ; preds = %B0.endif.endif.endif.endif.else.endif.endif
  br label %B0.endif.endif.endif.endif.endif.else.endif

B0.endif.endif.endif.endif.endif.else.endif:      ; preds = %B0.endif.endif.endif.endif.endif.else.if, %B0.endif.endif.endif.endif.else.endif.endif
  %.934.sroa.0.1 = phi i64 [ 0, %B0.endif.endif.endif.endif.endif.else.if ], [ %.946, %B0.endif.endif.endif.endif.else.endif.endif ]
  %.954.not = icmp slt i64 %.946, 1073741824
  br i1 %.954.not, label %B0.endif.endif.endif.endif.endif.else.endif.endif, label %B0.endif.endif.endif.endif.endif.else.endif.if, !prof !1

B0.endif.endif.endif.endif.endif.else.endif.if:   ; preds = %B0.endif.endif.endif.endif.endif.else.endif
  br label %B0.endif.endif.endif.endif.endif.else.endif.endif

B0.endif.endif.endif.endif.endif.else.endif.endif: ; preds = %B0.endif.endif.endif.endif.endif.else.endif.if, %B0.endif.endif.endif.endif.endif.else.endif
  %.934.sroa.0.3 = phi i64 [ 1073741824, %B0.endif.endif.endif.endif.endif.else.endif.if ], [ %.934.sroa.0.1, %B0.endif.endif.endif.endif.endif.else.endif ]
  %.1047 = getelementptr double, ptr %arg.weights.4, i64 %.934.sroa.0.3
  store ptr null, ptr %.1082, align 8
  call fastcc void @inner_6(ptr nonnull %.1082, ptr %arg.parameters.4, ptr %arg.contents.4, ptr %.1047, ptr %.824, ptr %.653)
  %.1163.inv = icmp sgt i64 %.151, 0
  %..156 = select i1 %.1163.inv, i64 %.156, i64 0
  %.12051029 = icmp sgt i64 %..156, 0
  br i1 %.12051029, label %B362.if.preheader, label %B418.if

B362.if.preheader:                                ; preds = %B0.endif.endif.endif.endif.endif.else.endif.endif
  %8 = shl nuw i64 %..156, 3
  tail call void @llvm.memset.p0.i64(ptr align 8 %arg.scratch.4, i8 0, i64 %8, i1 false)
  br label %B418.if

B418.if:                                          ; preds = %B362.if.preheader, %B0.endif.endif.endif.endif.endif.else.endif.endif
  %9 = getelementptr i8, ptr %arg.scratch.4, i64 56
  store double 1.000000e+00, ptr %9, align 8
  %.1413.1 = select i1 %.209, i64 %.182.sroa.13.2, i64 0
  %10 = getelementptr double, ptr %arg.scratch.4, i64 %.151
  %11 = getelementptr i8, ptr %10, i64 56
  %.1427.1 = getelementptr double, ptr %11, i64 %.1413.1
  store double 1.000000e+00, ptr %.1427.1, align 8
  %.idx = shl i64 %.151, 4
  %12 = getelementptr i8, ptr %arg.scratch.4, i64 %.idx
  %13 = getelementptr i8, ptr %12, i64 56
  %.1427.2 = getelementptr double, ptr %13, i64 %.1413.1
  store double 1.000000e+00, ptr %.1427.2, align 8
  %.idx1049 = mul i64 %.151, 24
  %14 = getelementptr i8, ptr %arg.scratch.4, i64 %.idx1049
  %15 = getelementptr i8, ptr %14, i64 56
  %.1427.3 = getelementptr double, ptr %15, i64 %.1413.1
  store double 1.000000e+00, ptr %.1427.3, align 8
  %.idx1050 = shl i64 %.151, 5
  %16 = getelementptr i8, ptr %arg.scratch.4, i64 %.idx1050
  %17 = getelementptr i8, ptr %16, i64 56
  %.1427.4 = getelementptr double, ptr %17, i64 %.1413.1
  store double 1.000000e+00, ptr %.1427.4, align 8
  %.idx1051 = mul i64 %.151, 40
  %18 = getelementptr i8, ptr %arg.scratch.4, i64 %.idx1051
  %19 = getelementptr i8, ptr %18, i64 56
  %.1427.5 = getelementptr double, ptr %19, i64 %.1413.1
  store double 1.000000e+00, ptr %.1427.5, align 8
  %.idx1052 = mul i64 %.151, 48
  %20 = getelementptr i8, ptr %arg.scratch.4, i64 %.idx1052
  %21 = getelementptr i8, ptr %20, i64 56
  %.1427.6 = getelementptr double, ptr %21, i64 %.1413.1
  store double 1.000000e+00, ptr %.1427.6, align 8
  %.idx1053 = mul i64 %.151, 56
  %22 = getelementptr i8, ptr %arg.scratch.4, i64 %.idx1053
  %23 = getelementptr i8, ptr %22, i64 56
  %.1427.7 = getelementptr double, ptr %23, i64 %.1413.1
  store double 1.000000e+00, ptr %.1427.7, align 8
  %.1462 = getelementptr i8, ptr %arg.contents.4, i64 8
  %.1463 = load i64, ptr %.1462, align 8
  %.1464 = icmp sgt i64 %.1463, 0
  br i1 %.1464, label %B506, label %B854

B506.endif.else.if:                               ; preds = %_ZN17bnserve_surrogate6kernel11_regression9_productsB3v41B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedExx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit
  br label %B506.endif.else.endif

B506.endif.else.endif:                            ; preds = %B506.endif.else.if, %_ZN17bnserve_surrogate6kernel11_regression9_productsB3v41B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedExx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit
  %.1638.sroa.0.1 = phi i64 [ 0, %B506.endif.else.if ], [ %.1650, %_ZN17bnserve_surrogate6kernel11_regression9_productsB3v41B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedExx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit ]
  %.1658.not = icmp slt i64 %.1650, 1073741824
  br i1 %.1658.not, label %B506.endif.else.endif.endif, label %B506.endif.else.endif.if, !prof !1

B506.endif.else.endif.if:                         ; preds = %B506.endif.else.endif
  br label %B506.endif.else.endif.endif

B506.endif.else.endif.endif:                      ; preds = %B506.endif.else.endif.if, %B506.endif.else.endif
  %.1638.sroa.0.3 = phi i64 [ 1073741824, %B506.endif.else.endif.if ], [ %.1638.sroa.0.1, %B506.endif.else.endif ]
  %.1751 = getelementptr double, ptr %arg.weights.4, i64 %.1638.sroa.0.3
  %24 = add nuw i64 %arg.rows, 3
  %.1848 = lshr i64 %24, 2
  %.1827.inv = icmp slt i64 %arg.rows, 1
  %.18691042.not1054 = icmp eq i64 %.1848, 0
  %.18691042.not = select i1 %.1827.inv, i1 true, i1 %.18691042.not1054
  br i1 %.18691042.not, label %B854, label %B704.if.preheader

B704.if.preheader:                                ; preds = %B506.endif.else.endif.endif
  %25 = tail call i64 @llvm.smax.i64(i64 %.146, i64 31)
  %storemerge.i = lshr i64 %25, 5
  %.1086.i = and i64 %.146, 24
  %scevgep23.i2 = getelementptr i8, ptr %.1751, i64 192
  %26 = and i64 %25, 9223372036854775776
  %.1046.i = and i64 %.146, -32
  %.1106806.i = lshr exact i64 %.1086.i, 3
  %27 = add i64 %.711.sroa.0.3, %.354.sroa.0.3
  %28 = add i64 %27, %.86.sroa.0.3.i
  %29 = shl i64 %28, 3
  %30 = getelementptr i8, ptr %arg.scratch.4, i64 %29
  %scevgep = getelementptr i8, ptr %30, i64 24
  %31 = icmp eq i64 %storemerge.i, 0
  %32 = icmp eq i64 %.1086.i, 0
  br label %B704.if

B704.if:                                          ; preds = %B706.endif.endif.endif, %B704.if.preheader
  %.186810401044 = phi i64 [ %.1878, %B706.endif.endif.endif ], [ %.1848, %B704.if.preheader ]
  %.187510411043 = phi i64 [ %.1882, %B706.endif.endif.endif ], [ 0, %B704.if.preheader ]
  %.1878 = add nsw i64 %.186810401044, -1
  %.1882 = add nuw i64 %.187510411043, 4
  %.1908 = mul nsw i64 %.187510411043, %.151
  %.1909 = or disjoint i64 %.1908, 8
  %.1946 = icmp slt i64 %.1908, -8
  %.1947 = select i1 %.1946, i64 %.182.sroa.13.2, i64 0
  %.1948 = add i64 %.1947, %.1909
  %.1951 = icmp slt i64 %.1948, 0
  br i1 %.1951, label %B706.else.if, label %B706.else.endif, !prof !5

B706.else.if:                                     ; preds = %B704.if
  br label %B706.else.endif

B706.else.endif:                                  ; preds = %B706.else.if, %B704.if
  %.1936.sroa.0.1 = phi i64 [ 0, %B706.else.if ], [ %.1948, %B704.if ]
  %.1956.not = icmp slt i64 %.1948, %.182.sroa.13.2
  br i1 %.1956.not, label %B706.else.endif.endif, label %B706.else.endif.if, !prof !1

B706.else.endif.if:                               ; preds = %B706.else.endif
  br label %B706.else.endif.endif

B706.else.endif.endif:                            ; preds = %B706.else.endif.if, %B706.else.endif
  %.1936.sroa.0.3 = phi i64 [ %.182.sroa.13.2, %B706.else.endif.if ], [ %.1936.sroa.0.1, %B706.else.endif ]
  %.2049 = getelementptr double, ptr %arg.scratch.4, i64 %.1936.sroa.0.3
  %.2111 = load i64, ptr %.1462, align 8
  %.2148 = icmp slt i64 %.187510411043, 0
  %.2149 = select i1 %.2148, i64 %.183.i, i64 0
  %.2150 = add i64 %.2149, %.187510411043
  %.2153 = icmp slt i64 %.2150, 0
  br i1 %.2153, label %B706.endif.else.if, label %B706.endif.else.endif, !prof !5

B706.endif.else.if:                               ; preds = %B706.else.endif.endif
  br label %B706.endif.else.endif

B706.endif.else.endif:                            ; preds = %B706.endif.else.if, %B706.else.endif.endif
  %.2138.sroa.0.1 = phi i64 [ 0, %B706.endif.else.if ], [ %.2150, %B706.else.endif.endif ]
  %.2158.not = icmp slt i64 %.2150, %.183.i
  br i1 %.2158.not, label %B706.endif.else.endif.endif, label %B706.endif.else.endif.if, !prof !1

B706.endif.else.endif.if:                         ; preds = %B706.endif.else.endif
  br label %B706.endif.else.endif.endif

B706.endif.else.endif.endif:                      ; preds = %B706.endif.else.endif.if, %B706.endif.else.endif
  %.2138.sroa.0.3 = phi i64 [ %.183.i, %B706.endif.else.endif.if ], [ %.2138.sroa.0.1, %B706.endif.else.endif ]
  br i1 %31, label %B354.else.i, label %B84.if.lr.ph.i

B84.if.lr.ph.i:                                   ; preds = %B706.endif.else.endif.endif
  %33 = shl i64 %.2111, 8
  %34 = shl i64 %.2138.sroa.0.3, 3
  %scevgep20 = getelementptr i8, ptr %scevgep, i64 %34
  %35 = icmp slt i64 %.2111, 1
  br label %B84.if.i

B280.i:                                           ; preds = %B200.if.i, %B84.if.i
  %_multiply_wide_v47_a00.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B84.if.i ], [ %.577.i, %B200.if.i ]
  %_multiply_wide_v47_a01.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B84.if.i ], [ %.581.i, %B200.if.i ]
  %_multiply_wide_v47_a02.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B84.if.i ], [ %.589.i, %B200.if.i ]
  %_multiply_wide_v47_a03.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B84.if.i ], [ %.593.i, %B200.if.i ]
  %_multiply_wide_v47_a10.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B84.if.i ], [ %.614.i, %B200.if.i ]
  %_multiply_wide_v47_a11.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B84.if.i ], [ %.618.i, %B200.if.i ]
  %_multiply_wide_v47_a12.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B84.if.i ], [ %.626.i, %B200.if.i ]
  %_multiply_wide_v47_a13.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B84.if.i ], [ %.630.i, %B200.if.i ]
  %_multiply_wide_v47_a20.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B84.if.i ], [ %.652.i, %B200.if.i ]
  %_multiply_wide_v47_a21.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B84.if.i ], [ %.656.i, %B200.if.i ]
  %_multiply_wide_v47_a22.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B84.if.i ], [ %.664.i, %B200.if.i ]
  %_multiply_wide_v47_a23.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B84.if.i ], [ %.668.i, %B200.if.i ]
  %_multiply_wide_v47_a30.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B84.if.i ], [ %.690.i, %B200.if.i ]
  %_multiply_wide_v47_a31.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B84.if.i ], [ %.694.i, %B200.if.i ]
  %_multiply_wide_v47_a32.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B84.if.i ], [ %.702.i, %B200.if.i ]
  %_multiply_wide_v47_a33.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B84.if.i ], [ %.706.i, %B200.if.i ]
  store <8 x double> %_multiply_wide_v47_a00.2.1.lcssa.i, ptr %.237.i, align 8, !noalias !9
  %.765.i = getelementptr inbounds nuw i8, ptr %.237.i, i64 64
  store <8 x double> %_multiply_wide_v47_a01.2.1.lcssa.i, ptr %.765.i, align 8, !noalias !9
  %.776.i = getelementptr inbounds nuw i8, ptr %.237.i, i64 128
  store <8 x double> %_multiply_wide_v47_a02.2.1.lcssa.i, ptr %.776.i, align 8, !noalias !9
  %.787.i = getelementptr inbounds nuw i8, ptr %.237.i, i64 192
  store <8 x double> %_multiply_wide_v47_a03.2.1.lcssa.i, ptr %.787.i, align 8, !noalias !9
  %.817.i = getelementptr inbounds double, ptr %.237.i, i64 %.151
  store <8 x double> %_multiply_wide_v47_a10.2.1.lcssa.i, ptr %.817.i, align 8, !noalias !9
  %.827.i = getelementptr i8, ptr %.817.i, i64 64
  store <8 x double> %_multiply_wide_v47_a11.2.1.lcssa.i, ptr %.827.i, align 8, !noalias !9
  %.838.i = getelementptr i8, ptr %.817.i, i64 128
  store <8 x double> %_multiply_wide_v47_a12.2.1.lcssa.i, ptr %.838.i, align 8, !noalias !9
  %.849.i = getelementptr i8, ptr %.817.i, i64 192
  store <8 x double> %_multiply_wide_v47_a13.2.1.lcssa.i, ptr %.849.i, align 8, !noalias !9
  %.880.i = getelementptr inbounds i8, ptr %.237.i, i64 %.idx
  store <8 x double> %_multiply_wide_v47_a20.2.1.lcssa.i, ptr %.880.i, align 8, !noalias !9
  %.890.i = getelementptr i8, ptr %.880.i, i64 64
  store <8 x double> %_multiply_wide_v47_a21.2.1.lcssa.i, ptr %.890.i, align 8, !noalias !9
  %.901.i = getelementptr i8, ptr %.880.i, i64 128
  store <8 x double> %_multiply_wide_v47_a22.2.1.lcssa.i, ptr %.901.i, align 8, !noalias !9
  %.912.i = getelementptr i8, ptr %.880.i, i64 192
  store <8 x double> %_multiply_wide_v47_a23.2.1.lcssa.i, ptr %.912.i, align 8, !noalias !9
  %.950.i = getelementptr inbounds i8, ptr %.237.i, i64 %.idx1049
  store <8 x double> %_multiply_wide_v47_a30.2.1.lcssa.i, ptr %.950.i, align 8, !noalias !9
  %.960.i = getelementptr i8, ptr %.950.i, i64 64
  store <8 x double> %_multiply_wide_v47_a31.2.1.lcssa.i, ptr %.960.i, align 8, !noalias !9
  %.971.i = getelementptr i8, ptr %.950.i, i64 128
  store <8 x double> %_multiply_wide_v47_a32.2.1.lcssa.i, ptr %.971.i, align 8, !noalias !9
  %.982.i = getelementptr i8, ptr %.950.i, i64 192
  store <8 x double> %_multiply_wide_v47_a33.2.1.lcssa.i, ptr %.982.i, align 8, !noalias !9
  %scevgep25.i8 = getelementptr i8, ptr %lsr.iv24.i3, i64 %33
  %.187.i = icmp sgt i64 %.186852864.i, 1
  br i1 %.187.i, label %B84.if.i, label %B354.else.loopexit.i

B2289.loopexit.i:                                 ; preds = %B884.if.i
  %36 = add i64 %position.5.0897.i, %42
  br label %B2289.i

B2289.i:                                          ; preds = %B356.if.i, %B2289.loopexit.i
  %position.4.1.lcssa.i = phi i64 [ %position.5.0897.i, %B356.if.i ], [ %36, %B2289.loopexit.i ]
  %b0.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B356.if.i ], [ %.1337.i, %B2289.loopexit.i ]
  %b1.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B356.if.i ], [ %.1356.i, %B2289.loopexit.i ]
  %b2.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B356.if.i ], [ %.1376.i, %B2289.loopexit.i ]
  %b3.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B356.if.i ], [ %.1396.i, %B2289.loopexit.i ]
  %.1418.i = getelementptr inbounds double, ptr %.2049, i64 %.1135889895.i
  store <8 x double> %b0.2.1.lcssa.i, ptr %.1418.i, align 8, !noalias !9
  %.1434.i = getelementptr double, ptr %39, i64 %.1135889895.i
  store <8 x double> %b1.2.1.lcssa.i, ptr %.1434.i, align 8, !noalias !9
  %.1451.i = getelementptr double, ptr %40, i64 %.1135889895.i
  store <8 x double> %b2.2.1.lcssa.i, ptr %.1451.i, align 8, !noalias !9
  %.1470.i = getelementptr double, ptr %41, i64 %.1135889895.i
  store <8 x double> %b3.2.1.lcssa.i, ptr %.1470.i, align 8, !noalias !9
  %.1129.i = icmp sgt i64 %.1128888896.i, 1
  br i1 %.1129.i, label %B356.if.i, label %B706.endif.endif.endif

B84.if.i:                                         ; preds = %B280.i, %B84.if.lr.ph.i
  %lsr.iv24.i3 = phi ptr [ %scevgep23.i2, %B84.if.lr.ph.i ], [ %scevgep25.i8, %B280.i ]
  %.186852864.i = phi i64 [ %storemerge.i, %B84.if.lr.ph.i ], [ %.196.i, %B280.i ]
  %.193853863.i = phi i64 [ 0, %B84.if.lr.ph.i ], [ %.200.i, %B280.i ]
  %.196.i = add nsw i64 %.186852864.i, -1
  %.200.i = add nuw nsw i64 %.193853863.i, 32
  %.237.i = getelementptr inbounds nuw double, ptr %.2049, i64 %.193853863.i
  br i1 %35, label %B280.i, label %B200.if.i

B200.if.i:                                        ; preds = %B84.if.i, %B200.if.i
  %lsr.iv43.i = phi i64 [ %lsr.iv.next44.i, %B200.if.i ], [ %.2111, %B84.if.i ]
  %lsr.iv26.i4 = phi i64 [ %lsr.iv.next27.i, %B200.if.i ], [ 0, %B84.if.i ]
  %_multiply_wide_v47_a33.2.1834.i = phi <8 x double> [ %.706.i, %B200.if.i ], [ zeroinitializer, %B84.if.i ]
  %_multiply_wide_v47_a32.2.1833.i = phi <8 x double> [ %.702.i, %B200.if.i ], [ zeroinitializer, %B84.if.i ]
  %_multiply_wide_v47_a31.2.1832.i = phi <8 x double> [ %.694.i, %B200.if.i ], [ zeroinitializer, %B84.if.i ]
  %_multiply_wide_v47_a30.2.1831.i = phi <8 x double> [ %.690.i, %B200.if.i ], [ zeroinitializer, %B84.if.i ]
  %_multiply_wide_v47_a23.2.1830.i = phi <8 x double> [ %.668.i, %B200.if.i ], [ zeroinitializer, %B84.if.i ]
  %_multiply_wide_v47_a22.2.1829.i = phi <8 x double> [ %.664.i, %B200.if.i ], [ zeroinitializer, %B84.if.i ]
  %_multiply_wide_v47_a21.2.1828.i = phi <8 x double> [ %.656.i, %B200.if.i ], [ zeroinitializer, %B84.if.i ]
  %_multiply_wide_v47_a20.2.1827.i = phi <8 x double> [ %.652.i, %B200.if.i ], [ zeroinitializer, %B84.if.i ]
  %_multiply_wide_v47_a13.2.1826.i = phi <8 x double> [ %.630.i, %B200.if.i ], [ zeroinitializer, %B84.if.i ]
  %_multiply_wide_v47_a12.2.1825.i = phi <8 x double> [ %.626.i, %B200.if.i ], [ zeroinitializer, %B84.if.i ]
  %_multiply_wide_v47_a11.2.1824.i = phi <8 x double> [ %.618.i, %B200.if.i ], [ zeroinitializer, %B84.if.i ]
  %_multiply_wide_v47_a10.2.1823.i = phi <8 x double> [ %.614.i, %B200.if.i ], [ zeroinitializer, %B84.if.i ]
  %_multiply_wide_v47_a03.2.1822.i = phi <8 x double> [ %.593.i, %B200.if.i ], [ zeroinitializer, %B84.if.i ]
  %_multiply_wide_v47_a02.2.1821.i = phi <8 x double> [ %.589.i, %B200.if.i ], [ zeroinitializer, %B84.if.i ]
  %_multiply_wide_v47_a01.2.1820.i = phi <8 x double> [ %.581.i, %B200.if.i ], [ zeroinitializer, %B84.if.i ]
  %_multiply_wide_v47_a00.2.1819.i = phi <8 x double> [ %.577.i, %B200.if.i ], [ zeroinitializer, %B84.if.i ]
  %37 = shl i64 %lsr.iv26.i4, 2
  %scevgep33.i = getelementptr i8, ptr %lsr.iv24.i3, i64 %37
  %scevgep34.i = getelementptr i8, ptr %scevgep33.i, i64 -192
  %.520.i = load <8 x double>, ptr %scevgep34.i, align 8, !noalias !9
  %scevgep32.i5 = getelementptr i8, ptr %scevgep33.i, i64 -128
  %.532.i = load <8 x double>, ptr %scevgep32.i5, align 8, !noalias !9
  %scevgep8 = getelementptr i8, ptr %scevgep33.i, i64 -64
  %.545.i = load <8 x double>, ptr %scevgep8, align 8, !noalias !9
  %.558.i = load <8 x double>, ptr %scevgep33.i, align 8, !noalias !9
  %scevgep26 = getelementptr i8, ptr %scevgep20, i64 %lsr.iv26.i4
  %scevgep27 = getelementptr i8, ptr %scevgep26, i64 -24
  %.573.i = load double, ptr %scevgep27, align 8, !noalias !9
  %.575.i = insertelement <8 x double> poison, double %.573.i, i64 0
  %.576.i = shufflevector <8 x double> %.575.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.577.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.520.i, <8 x double> %.576.i, <8 x double> %_multiply_wide_v47_a00.2.1819.i)
  %.581.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.532.i, <8 x double> %.576.i, <8 x double> %_multiply_wide_v47_a01.2.1820.i)
  %.589.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.545.i, <8 x double> %.576.i, <8 x double> %_multiply_wide_v47_a02.2.1821.i)
  %.593.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.558.i, <8 x double> %.576.i, <8 x double> %_multiply_wide_v47_a03.2.1822.i)
  %scevgep5 = getelementptr i8, ptr %scevgep26, i64 -16
  %.610.i = load double, ptr %scevgep5, align 8, !noalias !9
  %.612.i = insertelement <8 x double> poison, double %.610.i, i64 0
  %.613.i = shufflevector <8 x double> %.612.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.614.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.520.i, <8 x double> %.613.i, <8 x double> %_multiply_wide_v47_a10.2.1823.i)
  %.618.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.532.i, <8 x double> %.613.i, <8 x double> %_multiply_wide_v47_a11.2.1824.i)
  %.626.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.545.i, <8 x double> %.613.i, <8 x double> %_multiply_wide_v47_a12.2.1825.i)
  %.630.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.558.i, <8 x double> %.613.i, <8 x double> %_multiply_wide_v47_a13.2.1826.i)
  %scevgep2 = getelementptr i8, ptr %scevgep26, i64 -8
  %.648.i = load double, ptr %scevgep2, align 8, !noalias !9
  %.650.i = insertelement <8 x double> poison, double %.648.i, i64 0
  %.651.i = shufflevector <8 x double> %.650.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.652.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.520.i, <8 x double> %.651.i, <8 x double> %_multiply_wide_v47_a20.2.1827.i)
  %.656.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.532.i, <8 x double> %.651.i, <8 x double> %_multiply_wide_v47_a21.2.1828.i)
  %.664.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.545.i, <8 x double> %.651.i, <8 x double> %_multiply_wide_v47_a22.2.1829.i)
  %.668.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.558.i, <8 x double> %.651.i, <8 x double> %_multiply_wide_v47_a23.2.1830.i)
  %.686.i = load double, ptr %scevgep26, align 8, !noalias !9
  %.688.i = insertelement <8 x double> poison, double %.686.i, i64 0
  %.689.i = shufflevector <8 x double> %.688.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.690.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.520.i, <8 x double> %.689.i, <8 x double> %_multiply_wide_v47_a30.2.1831.i)
  %.694.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.532.i, <8 x double> %.689.i, <8 x double> %_multiply_wide_v47_a31.2.1832.i)
  %.702.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.545.i, <8 x double> %.689.i, <8 x double> %_multiply_wide_v47_a32.2.1833.i)
  %.706.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.558.i, <8 x double> %.689.i, <8 x double> %_multiply_wide_v47_a33.2.1834.i)
  %lsr.iv.next27.i = add nuw i64 %lsr.iv26.i4, 64
  %lsr.iv.next44.i = add i64 %lsr.iv43.i, -1
  %exitcond.not.i7 = icmp eq i64 %lsr.iv.next44.i, 0
  br i1 %exitcond.not.i7, label %B280.i, label %B200.if.i

B354.else.loopexit.i:                             ; preds = %B280.i
  %38 = mul i64 %.2111, %26
  br label %B354.else.i

B354.else.i:                                      ; preds = %B354.else.loopexit.i, %B706.endif.else.endif.endif
  %position.3.0.lcssa.i = phi i64 [ 0, %B706.endif.else.endif.endif ], [ %38, %B354.else.loopexit.i ]
  br i1 %32, label %B706.endif.endif.endif, label %B354.endif.endif.endif.i

B354.endif.endif.endif.i:                         ; preds = %B354.else.i
  %.arg.count811.i = tail call i64 @llvm.smax.i64(i64 %.2111, i64 0)
  %39 = getelementptr double, ptr %.2049, i64 %.151
  %40 = getelementptr i8, ptr %.2049, i64 %.idx
  %41 = getelementptr i8, ptr %.2049, i64 %.idx1049
  %42 = shl i64 %.arg.count811.i, 3
  %43 = shl i64 %.2138.sroa.0.3, 3
  %scevgep31 = getelementptr i8, ptr %scevgep, i64 %43
  %44 = icmp slt i64 %.2111, 1
  br label %B356.if.i

B356.if.i:                                        ; preds = %B354.endif.endif.endif.i, %B2289.i
  %position.5.0897.i = phi i64 [ %position.3.0.lcssa.i, %B354.endif.endif.endif.i ], [ %position.4.1.lcssa.i, %B2289.i ]
  %.1128888896.i = phi i64 [ %.1106806.i, %B354.endif.endif.endif.i ], [ %.1138.i, %B2289.i ]
  %.1135889895.i = phi i64 [ %.1046.i, %B354.endif.endif.endif.i ], [ %.1142.i, %B2289.i ]
  %.1138.i = add nsw i64 %.1128888896.i, -1
  %.1142.i = add nuw nsw i64 %.1135889895.i, 8
  br i1 %44, label %B2289.i, label %B884.if.preheader.i

B884.if.preheader.i:                              ; preds = %B356.if.i
  %45 = shl i64 %position.5.0897.i, 3
  %scevgep.i10 = getelementptr i8, ptr %.1751, i64 %45
  br label %B884.if.i

B884.if.i:                                        ; preds = %B884.if.i, %B884.if.preheader.i
  %lsr.iv21.i = phi i64 [ %.2111, %B884.if.preheader.i ], [ %lsr.iv.next22.i, %B884.if.i ]
  %lsr.iv.i11 = phi i64 [ 0, %B884.if.preheader.i ], [ %lsr.iv.next.i12, %B884.if.i ]
  %b3.2.1880.i = phi <8 x double> [ zeroinitializer, %B884.if.preheader.i ], [ %.1396.i, %B884.if.i ]
  %b2.2.1879.i = phi <8 x double> [ zeroinitializer, %B884.if.preheader.i ], [ %.1376.i, %B884.if.i ]
  %b1.2.1878.i = phi <8 x double> [ zeroinitializer, %B884.if.preheader.i ], [ %.1356.i, %B884.if.i ]
  %b0.2.1877.i = phi <8 x double> [ zeroinitializer, %B884.if.preheader.i ], [ %.1337.i, %B884.if.i ]
  %scevgep12.i = getelementptr i8, ptr %scevgep.i10, i64 %lsr.iv.i11
  %.1318.i = load <8 x double>, ptr %scevgep12.i, align 8, !noalias !9
  %scevgep37 = getelementptr i8, ptr %scevgep31, i64 %lsr.iv.i11
  %scevgep38 = getelementptr i8, ptr %scevgep37, i64 -24
  %.1333.i = load double, ptr %scevgep38, align 8, !noalias !9
  %.1335.i = insertelement <8 x double> poison, double %.1333.i, i64 0
  %.1336.i = shufflevector <8 x double> %.1335.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1337.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1318.i, <8 x double> %.1336.i, <8 x double> %b0.2.1877.i)
  %scevgep12 = getelementptr i8, ptr %scevgep37, i64 -16
  %.1352.i = load double, ptr %scevgep12, align 8, !noalias !9
  %.1354.i = insertelement <8 x double> poison, double %.1352.i, i64 0
  %.1355.i = shufflevector <8 x double> %.1354.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1356.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1318.i, <8 x double> %.1355.i, <8 x double> %b1.2.1878.i)
  %scevgep10 = getelementptr i8, ptr %scevgep37, i64 -8
  %.1372.i = load double, ptr %scevgep10, align 8, !noalias !9
  %.1374.i = insertelement <8 x double> poison, double %.1372.i, i64 0
  %.1375.i = shufflevector <8 x double> %.1374.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1376.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1318.i, <8 x double> %.1375.i, <8 x double> %b2.2.1879.i)
  %.1392.i = load double, ptr %scevgep37, align 8, !noalias !9
  %.1394.i = insertelement <8 x double> poison, double %.1392.i, i64 0
  %.1395.i = shufflevector <8 x double> %.1394.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1396.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1318.i, <8 x double> %.1395.i, <8 x double> %b3.2.1880.i)
  %lsr.iv.next.i12 = add nuw i64 %lsr.iv.i11, 64
  %lsr.iv.next22.i = add i64 %lsr.iv21.i, -1
  %exitcond905.not.i = icmp eq i64 %lsr.iv.next22.i, 0
  br i1 %exitcond905.not.i, label %B2289.loopexit.i, label %B884.if.i

B706.endif.endif.endif:                           ; preds = %B2289.i, %B354.else.i
  %.1869 = icmp sgt i64 %.186810401044, 1
  br i1 %.1869, label %B704.if, label %B854

B898.else.if:                                     ; preds = %B898
  br label %B898.else.endif

B898.else.endif:                                  ; preds = %B898.else.if, %B898
  %.2433.sroa.0.1 = phi i64 [ 0, %B898.else.if ], [ %.2445, %B898 ]
  %.2453.not = icmp slt i64 %.2445, 1073741824
  br i1 %.2453.not, label %B898.else.endif.endif, label %B898.else.endif.if, !prof !1

B898.else.endif.if:                               ; preds = %B898.else.endif
  br label %B898.else.endif.endif

B898.else.endif.endif:                            ; preds = %B898.else.endif.if, %B898.else.endif
  %.2433.sroa.0.3 = phi i64 [ 1073741824, %B898.else.endif.if ], [ %.2433.sroa.0.1, %B898.else.endif ]
  %.2521 = sub nsw i64 1073741824, %.2433.sroa.0.3
  %.2530 = tail call i64 @llvm.smax.i64(i64 %.2521, i64 0)
  %.2546 = getelementptr double, ptr %arg.weights.4, i64 %.2433.sroa.0.3
  %.2629 = icmp slt i64 %.182.sroa.13.2, 9
  br i1 %.2629, label %B898.endif.else.endif.if, label %B898.endif.else.endif.endif, !prof !5

B898.endif.else.endif.if:                         ; preds = %B898.else.endif.endif
  br label %B898.endif.else.endif.endif

B898.endif.else.endif.endif:                      ; preds = %B898.endif.else.endif.if, %B898.else.endif.endif
  %.2609.sroa.0.3 = phi i64 [ %.182.sroa.13.2, %B898.endif.else.endif.if ], [ 8, %B898.else.endif.endif ]
  %.2722 = getelementptr double, ptr %arg.scratch.4, i64 %.2609.sroa.0.3
  store ptr null, ptr %.2759, align 8
  call fastcc void @inner_7(ptr nonnull %.2759, ptr %.653, i64 %arg.rows, ptr %arg.contents.4, ptr %.2546, i64 %.2530, ptr %.824, i64 %.808, ptr %.2722, i64 %.151)
  br label %B1014
}

; Function Attrs: nofree noinline norecurse nosync nounwind memory(readwrite, inaccessiblemem: none, target_mem0: none, target_mem1: none)
define internal fastcc noundef range(i32 0, 2) i32 @inner_4(ptr noalias nonnull writeonly captures(none) %retptr, ptr noalias nonnull writeonly captures(none) %excinfo, i64 %arg.i, ptr readonly captures(none) %arg.row.4, ptr readonly captures(none) %arg.linear.4, i64 range(i64 8, 0) %arg.linear.5.0, ptr readonly captures(none) %arg.arguments.4, ptr readonly captures(none) %arg.contents.4, ptr readonly captures(none) %arg.weights.4, ptr %arg.scratch.4, double %arg.plus, double %arg.cross) unnamed_addr #5 {
entry:
  %.3844 = alloca i64, align 8
  store i64 0, ptr %.3844, align 8
  %.3999 = alloca i64, align 8
  store i64 0, ptr %.3999, align 8
  %.4120 = alloca i64, align 8
  store i64 0, ptr %.4120, align 8
  %.4279 = alloca i64, align 8
  store i64 0, ptr %.4279, align 8
  %.4842 = alloca ptr, align 8
  store ptr null, ptr %.4842, align 8
  %excinfo.34 = alloca ptr, align 8
  store ptr null, ptr %excinfo.34, align 8
  %.5070 = alloca double, align 8
  store double 0.000000e+00, ptr %.5070, align 8
  %excinfo.36 = alloca ptr, align 8
  store ptr null, ptr %excinfo.36, align 8
  %.7353 = alloca ptr, align 8
  store ptr null, ptr %.7353, align 8
  %.8351 = alloca ptr, align 8
  store ptr null, ptr %.8351, align 8
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
  %_prepared_v99__vphi308_0.2.0 = phi double [ %.488, %B900 ], [ 0.000000e+00, %entry ]
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

B1206:                                            ; preds = %_ZN17bnserve_surrogate6kernel7_points10fill_cellsB4v130B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedExx5ArrayIdLi1E1C7mutable7alignedE.exit479
  %.4496 = getelementptr i8, ptr %arg.arguments.4, i64 112
  %.4497 = load i64, ptr %.4496, align 8
  %.4498.not = icmp eq i64 %.4497, 4
  %.4537 = getelementptr i8, ptr %arg.contents.4, i64 152
  %.4538 = load i64, ptr %.4537, align 8
  %.4549 = getelementptr inbounds double, ptr %arg.weights.4, i64 %.4538
  br i1 %.4498.not, label %B1350, label %B1218

B1218:                                            ; preds = %B1206
  store ptr null, ptr %.4842, align 8
  %.4868 = call fastcc i32 @inner_8(ptr nonnull %.4842, ptr nonnull %excinfo.34, ptr %arg.row.4, ptr nonnull %arg.linear.4, ptr %arg.contents.4, ptr %arg.weights.4, i64 %.186, ptr nonnull %.1262, ptr %.1326, i64 %.814, ptr %arg.scratch.4, ptr %.2106, ptr %.1959, ptr %.2023)
  %cond = icmp eq i32 %.4868, 0
  br i1 %cond, label %B1218.endif, label %B1218.if, !prof !0

B1350:                                            ; preds = %B1206, %B1206.thread, %_ZN17bnserve_surrogate6kernel7_places9find_endsB4v177B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5TupleI5ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedExdE5ArrayIdLi1E1C7mutable7alignedExdx5ArrayIxLi1E1C7mutable7alignedE.exit
  %.454917 = phi ptr [ %.4549, %_ZN17bnserve_surrogate6kernel7_places9find_endsB4v177B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5TupleI5ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedExdE5ArrayIdLi1E1C7mutable7alignedExdx5ArrayIxLi1E1C7mutable7alignedE.exit ], [ %.454912, %B1206.thread ], [ %.4549, %B1206 ]
  %"$phi984.0.3.014" = phi i1 [ true, %_ZN17bnserve_surrogate6kernel7_places9find_endsB4v177B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5TupleI5ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedExdE5ArrayIdLi1E1C7mutable7alignedExdx5ArrayIxLi1E1C7mutable7alignedE.exit ], [ false, %B1206.thread ], [ false, %B1206 ]
  store double 0.000000e+00, ptr %.5070, align 8
  %.5084 = call fastcc i32 @inner_9(ptr nonnull %.5070, ptr nonnull %excinfo.36, ptr %arg.row.4, double %.3595, ptr nonnull %.3653, ptr nonnull %.1031, i64 %.186, ptr %.1615, ptr %arg.scratch.4)
  %.5094 = load double, ptr %.5070, align 8
  %cond1 = icmp eq i32 %.5084, 0
  br i1 %cond1, label %B1350.endif, label %B1350.if, !prof !0

B1408:                                            ; preds = %_ZN17bnserve_surrogate6kernel7_places9find_endsB4v177B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5TupleI5ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedExdE5ArrayIdLi1E1C7mutable7alignedExdx5ArrayIxLi1E1C7mutable7alignedE.exit541
  %.5506 = load i64, ptr %.770, align 8
  %.135.i542 = load double, ptr %.402, align 8, !noalias !12
  %.143.i543 = add nsw i64 %.5506, -2
  %.181.i544 = icmp slt i64 %.5506, 3
  %..143.i545 = select i1 %.181.i544, i64 0, i64 %.143.i543
  %.225207.i546 = icmp sgt i64 %..143.i545, 0
  br i1 %.225207.i546, label %B92.if.preheader.i550, label %_ZN17bnserve_surrogate6kernel7_places9find_endsB4v177B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5TupleI5ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedExdE5ArrayIdLi1E1C7mutable7alignedExdx5ArrayIxLi1E1C7mutable7alignedE.exit585

B1596:                                            ; preds = %_ZN17bnserve_surrogate6kernel7_places9find_endsB4v177B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5TupleI5ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedExdE5ArrayIdLi1E1C7mutable7alignedExdx5ArrayIxLi1E1C7mutable7alignedE.exit541, %_ZN17bnserve_surrogate6kernel7_places9find_endsB4v177B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5TupleI5ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedExdE5ArrayIdLi1E1C7mutable7alignedExdx5ArrayIxLi1E1C7mutable7alignedE.exit585, %_ZN17bnserve_surrogate6kernel7_places9find_endsB4v177B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5TupleI5ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedExdE5ArrayIdLi1E1C7mutable7alignedExdx5ArrayIxLi1E1C7mutable7alignedE.exit
  %.454916 = phi ptr [ %.4549, %_ZN17bnserve_surrogate6kernel7_places9find_endsB4v177B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5TupleI5ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedExdE5ArrayIdLi1E1C7mutable7alignedExdx5ArrayIxLi1E1C7mutable7alignedE.exit ], [ %.454917, %_ZN17bnserve_surrogate6kernel7_places9find_endsB4v177B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5TupleI5ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedExdE5ArrayIdLi1E1C7mutable7alignedExdx5ArrayIxLi1E1C7mutable7alignedE.exit585 ], [ %.454917, %_ZN17bnserve_surrogate6kernel7_places9find_endsB4v177B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5TupleI5ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedExdE5ArrayIdLi1E1C7mutable7alignedExdx5ArrayIxLi1E1C7mutable7alignedE.exit541 ]
  %"$phi984.0.3.013" = phi i1 [ true, %_ZN17bnserve_surrogate6kernel7_places9find_endsB4v177B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5TupleI5ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedExdE5ArrayIdLi1E1C7mutable7alignedExdx5ArrayIxLi1E1C7mutable7alignedE.exit ], [ %"$phi984.0.3.014", %_ZN17bnserve_surrogate6kernel7_places9find_endsB4v177B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5TupleI5ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedExdE5ArrayIdLi1E1C7mutable7alignedExdx5ArrayIxLi1E1C7mutable7alignedE.exit585 ], [ %"$phi984.0.3.014", %_ZN17bnserve_surrogate6kernel7_places9find_endsB4v177B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5TupleI5ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedExdE5ArrayIdLi1E1C7mutable7alignedExdx5ArrayIxLi1E1C7mutable7alignedE.exit541 ]
  %constant.2.1 = phi double [ 0.000000e+00, %_ZN17bnserve_surrogate6kernel7_places9find_endsB4v177B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5TupleI5ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedExdE5ArrayIdLi1E1C7mutable7alignedExdx5ArrayIxLi1E1C7mutable7alignedE.exit ], [ %.5094, %_ZN17bnserve_surrogate6kernel7_places9find_endsB4v177B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5TupleI5ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedExdE5ArrayIdLi1E1C7mutable7alignedExdx5ArrayIxLi1E1C7mutable7alignedE.exit585 ], [ %.5094, %_ZN17bnserve_surrogate6kernel7_places9find_endsB4v177B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5TupleI5ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedExdE5ArrayIdLi1E1C7mutable7alignedExdx5ArrayIxLi1E1C7mutable7alignedE.exit541 ]
  %7 = add nuw i64 %.126, 1023
  %.5721 = lshr i64 %7, 10
  %.5700.inv = icmp slt i64 %.126, 1
  %.idx = shl i64 %.156, 4
  %8 = getelementptr i8, ptr %.335, i64 %.idx
  %.idx3736 = mul i64 %.156, 24
  %.idx3737 = shl i64 %.156, 5
  %9 = getelementptr i8, ptr %.335, i64 %.idx3737
  %.7772 = getelementptr inbounds double, ptr %.454916, i64 %.973
  %.7837.idx = shl nsw i64 %.973, 4
  %.7837 = getelementptr inbounds i8, ptr %.454916, i64 %.7837.idx
  %.5742238.not246 = icmp eq i64 %.5721, 0
  %.5742238.not = select i1 %.5700.inv, i1 true, i1 %.5742238.not246
  br i1 %.5742238.not, label %B5566, label %B1604.lr.ph

B1604.lr.ph:                                      ; preds = %B1596
  %10 = tail call i64 @llvm.smax.i64(i64 %.5721, i64 1)
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
  %sunkaddr38 = getelementptr i8, ptr %.1031, i64 8
  %28 = icmp eq i64 %.1003, 0
  %sunkaddr75 = getelementptr i8, ptr %arg.scratch.4, i64 264
  %sunkaddr76 = getelementptr i8, ptr %arg.scratch.4, i64 256
  %sunkaddr77 = getelementptr i8, ptr %arg.scratch.4, i64 248
  %sunkaddr78 = getelementptr i8, ptr %arg.scratch.4, i64 240
  %sunkaddr79 = getelementptr i8, ptr %arg.scratch.4, i64 232
  %sunkaddr80 = getelementptr i8, ptr %arg.scratch.4, i64 224
  %sunkaddr81 = getelementptr i8, ptr %arg.scratch.4, i64 216
  %sunkaddr82 = getelementptr i8, ptr %arg.scratch.4, i64 208
  %sunkaddr83 = getelementptr i8, ptr %arg.scratch.4, i64 200
  %sunkaddr84 = getelementptr inbounds nuw i8, ptr %arg.scratch.4, i64 192
  %sunkaddr85 = getelementptr i8, ptr %arg.scratch.4, i64 184
  %sunkaddr86 = getelementptr i8, ptr %arg.scratch.4, i64 176
  %sunkaddr87 = getelementptr i8, ptr %arg.scratch.4, i64 168
  %sunkaddr88 = getelementptr i8, ptr %arg.scratch.4, i64 160
  %sunkaddr89 = getelementptr i8, ptr %arg.scratch.4, i64 152
  %sunkaddr90 = getelementptr i8, ptr %arg.scratch.4, i64 144
  %sunkaddr91 = getelementptr i8, ptr %arg.scratch.4, i64 136
  %sunkaddr92 = getelementptr i8, ptr %arg.scratch.4, i64 128
  %sunkaddr93 = getelementptr i8, ptr %arg.scratch.4, i64 120
  %sunkaddr94 = getelementptr i8, ptr %arg.scratch.4, i64 112
  %sunkaddr95 = getelementptr i8, ptr %arg.scratch.4, i64 104
  %sunkaddr96 = getelementptr i8, ptr %arg.scratch.4, i64 96
  %sunkaddr97 = getelementptr i8, ptr %arg.scratch.4, i64 88
  %sunkaddr98 = getelementptr i8, ptr %arg.scratch.4, i64 80
  %sunkaddr99 = getelementptr i8, ptr %arg.scratch.4, i64 72
  %sunkaddr100 = getelementptr inbounds nuw i8, ptr %arg.scratch.4, i64 64
  %sunkaddr101 = shl i64 %.156, 3
  br label %B1604

B1604:                                            ; preds = %B5564, %B1604.lr.ph
  %.5732.sroa.0.0245 = phi i64 [ 0, %B1604.lr.ph ], [ %.5732.sroa.0.0, %B5564 ]
  %.5689.1244.in = phi i64 [ %10, %B1604.lr.ph ], [ %41, %B5564 ]
  %.5686.1243 = phi i64 [ 1024, %B1604.lr.ph ], [ %.5686.1, %B5564 ]
  %cells.3.sroa.0.0242 = phi i64 [ 0, %B1604.lr.ph ], [ %cells.4.sroa.0.1, %B5564 ]
  %cells.3.sroa.13.0241 = phi i64 [ 0, %B1604.lr.ph ], [ %cells.4.sroa.8.1, %B5564 ]
  %.5788 = add nsw i64 %.5732.sroa.0.0245, 1024
  %.13.i = tail call i64 @llvm.smin.i64(i64 %.126, i64 %.5788)
  %.13.i586 = tail call i64 @llvm.smax.i64(i64 %.5732.sroa.0.0245, i64 %.4017)
  %.13.i587 = tail call i64 @llvm.smin.i64(i64 %.13.i, i64 %.13.i586)
  %.13.i588 = tail call i64 @llvm.smax.i64(i64 %.5732.sroa.0.0245, i64 %.3862)
  %.13.i589 = tail call i64 @llvm.smin.i64(i64 %.13.i587, i64 %.13.i588)
  %.5970 = icmp sgt i64 %.13.i589, %.5732.sroa.0.0245
  br i1 %.5970, label %B1606, label %B1626

B1606:                                            ; preds = %B1604
  %.5985 = getelementptr double, ptr %.335, i64 %.5732.sroa.0.0245
  %.6038 = sub nsw i64 %.13.i589, %.5732.sroa.0.0245
  %.6068 = load double, ptr %.3653, align 8
  %.6098 = load double, ptr %sunkaddr38, align 8
  %.145103.not.i = icmp slt i64 %.6038, 1
  br i1 %.145103.not.i, label %B1626, label %B34.if.i

B1626:                                            ; preds = %B144.i, %B1606, %B1604
  br i1 %"$phi984.0.3.013", label %B4582, label %B1678

B1678:                                            ; preds = %B1626
  %29 = icmp slt i64 %.13.i588, %.13.i587
  br i1 %28, label %B1932, label %B1682

B1682:                                            ; preds = %B1678
  br i1 %29, label %B22.preheader.i, label %B4582

B22.preheader.i:                                  ; preds = %B1682
  %30 = mul i64 %.5732.sroa.0.0245, -8
  %scevgep1142 = getelementptr i8, ptr %scevgep, i64 %30
  br label %B22.i

B22.i:                                            ; preds = %B926.i, %B22.preheader.i
  %cell.2.0.i = phi i64 [ %cell.3.2.i, %B926.i ], [ %cells.3.sroa.13.0241, %B22.preheader.i ]
  %start.2.0.i = phi i64 [ %.13.i.i, %B926.i ], [ %.13.i589, %B22.preheader.i ]
  %.149.i = getelementptr inbounds i64, ptr %.1466, i64 %cell.2.0.i
  %.150.i = load i64, ptr %.149.i, align 8, !noalias !15
  %.154.not.i = icmp sgt i64 %.150.i, %start.2.0.i
  br i1 %.154.not.i, label %B112.i, label %B62.i

B62.i:                                            ; preds = %B22.i, %B62.i
  %cell.4.1.i = phi i64 [ %.157.i, %B62.i ], [ %cell.2.0.i, %B22.i ]
  %.157.i = add i64 %cell.4.1.i, 1
  %sunkaddr.i = shl i64 %cell.4.1.i, 3
  %scevgep1140 = getelementptr i8, ptr %scevgep1139, i64 %sunkaddr.i
  %.170.i = load i64, ptr %scevgep1140, align 8, !noalias !15
  %.172.not.i = icmp sgt i64 %.170.i, %start.2.0.i
  br i1 %.172.not.i, label %B112.i, label %B62.i

B112.i:                                           ; preds = %B62.i, %B22.i
  %cell.3.2.i = phi i64 [ %cell.2.0.i, %B22.i ], [ %.157.i, %B62.i ]
  %.184.i = getelementptr inbounds i64, ptr %.1466, i64 %cell.3.2.i
  %.185.i = load i64, ptr %.184.i, align 8, !noalias !15
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
  br i1 %.602.i, label %B22.i, label %B4582

B570.if.lr.ph.i:                                  ; preds = %B112.i
  %.228.i = getelementptr inbounds double, ptr %.3100, i64 %cell.3.2.i
  %.229.i = load double, ptr %.228.i, align 8, !noalias !15
  %.231.i = fsub contract double %.3607.le, %.229.i
  %.279.i = add nsw i64 %cell.3.2.i, %.277.i
  %.347.i = getelementptr inbounds double, ptr %.1326, i64 %.279.i
  %.348.i = load double, ptr %.347.i, align 8, !noalias !15
  %.266.i = add nsw i64 %cell.3.2.i, %.1113
  %.334.i = getelementptr inbounds double, ptr %.1326, i64 %.266.i
  %.335.i = load double, ptr %.334.i, align 8, !noalias !15
  %.247.i = sub i64 %cell.3.2.i, %.780.1
  %.315.i = getelementptr inbounds double, ptr %.1326, i64 %.247.i
  %.316.i = load double, ptr %.315.i, align 8, !noalias !15
  %.303.i = getelementptr inbounds double, ptr %.1326, i64 %cell.3.2.i
  %.304.i = load double, ptr %.303.i, align 8, !noalias !15
  %.287.i = getelementptr inbounds double, ptr %.1262, i64 %.279.i
  %.288.i = load double, ptr %.287.i, align 8, !noalias !15
  %.274.i = getelementptr inbounds double, ptr %.1262, i64 %.266.i
  %.275.i = load double, ptr %.274.i, align 8, !noalias !15
  %.255.i = getelementptr inbounds double, ptr %.1262, i64 %.247.i
  %.256.i = load double, ptr %.255.i, align 8, !noalias !15
  %.243.i = getelementptr inbounds double, ptr %.1262, i64 %cell.3.2.i
  %.244.i = load double, ptr %.243.i, align 8, !noalias !15
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
  %.485.i = load <8 x double>, ptr %scevgep13.i, align 8, !noalias !15
  %.8.i.i = fadd contract <8 x double> %.7.i.i, %.485.i
  %.519.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i.i, <8 x double> %.515.i, <8 x double> %.518.i)
  %.523.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i.i, <8 x double> %.519.i, <8 x double> %.522.i)
  %.527.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i.i, <8 x double> %.523.i, <8 x double> %.526.i)
  %scevgep1144 = getelementptr i8, ptr %scevgep1142, i64 %lsr.iv8.i
  %scevgep1145 = getelementptr i8, ptr %scevgep1144, i64 -8256
  store <8 x double> %.527.i, ptr %scevgep1145, align 8, !noalias !15
  %.546.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i.i, <8 x double> %.542.i, <8 x double> %.545.i)
  %.550.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i.i, <8 x double> %.546.i, <8 x double> %.549.i)
  %.554.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i.i, <8 x double> %.550.i, <8 x double> %.553.i)
  store <8 x double> %.554.i, ptr %scevgep1144, align 8, !noalias !15
  %lsr.iv.next9.i = add i64 %lsr.iv8.i, 64
  %lsr.iv.next23 = add nsw i64 %lsr.iv22, -1
  %.438.i = icmp sgt i64 %lsr.iv22, 6
  br i1 %.438.i, label %B570.if.i, label %B926.i

B1932:                                            ; preds = %B1678
  br i1 %29, label %B22.preheader.i273, label %B1932.endif

B22.preheader.i273:                               ; preds = %B1932
  %34 = mul i64 %.5732.sroa.0.0245, -8
  %scevgep1149 = getelementptr i8, ptr %scevgep1148, i64 %34
  br label %B22.i275

B22.i275:                                         ; preds = %B612.i, %B22.preheader.i273
  %cell.2.0.i276 = phi i64 [ %cell.3.2.i282, %B612.i ], [ %cells.3.sroa.0.0242, %B22.preheader.i273 ]
  %start.2.0.i277 = phi i64 [ %.13.i.i284, %B612.i ], [ %.13.i589, %B22.preheader.i273 ]
  %.121.i = getelementptr inbounds i64, ptr %.1403, i64 %cell.2.0.i276
  %.122.i = load i64, ptr %.121.i, align 8, !noalias !18
  %.126.not.i = icmp sgt i64 %.122.i, %start.2.0.i277
  br i1 %.126.not.i, label %B112.i281, label %B62.i278

B62.i278:                                         ; preds = %B22.i275, %B62.i278
  %cell.4.1.i279 = phi i64 [ %.129.i, %B62.i278 ], [ %cell.2.0.i276, %B22.i275 ]
  %.129.i = add i64 %cell.4.1.i279, 1
  %sunkaddr.i280 = shl i64 %cell.4.1.i279, 3
  %scevgep1147 = getelementptr i8, ptr %scevgep1146, i64 %sunkaddr.i280
  %.142.i = load i64, ptr %scevgep1147, align 8, !noalias !18
  %.144.not.i = icmp sgt i64 %.142.i, %start.2.0.i277
  br i1 %.144.not.i, label %B112.i281, label %B62.i278

B112.i281:                                        ; preds = %B62.i278, %B22.i275
  %cell.3.2.i282 = phi i64 [ %cell.2.0.i276, %B22.i275 ], [ %.129.i, %B62.i278 ]
  %.156.i = getelementptr inbounds i64, ptr %.1403, i64 %cell.3.2.i282
  %.157.i283 = load i64, ptr %.156.i, align 8, !noalias !18
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
  br i1 %.479.i, label %B22.i275, label %B1932.endif

B412.if.lr.ph.i:                                  ; preds = %B112.i281
  %.200.i = getelementptr inbounds double, ptr %.3007, i64 %cell.3.2.i282
  %.201.i = load double, ptr %.200.i, align 8, !noalias !18
  %.203.i = fsub contract double %.3607.le, %.201.i
  %.259.i = getelementptr double, ptr %13, i64 %cell.3.2.i282
  %.260.i = load double, ptr %.259.i, align 8, !noalias !18
  %.246.i = getelementptr double, ptr %12, i64 %cell.3.2.i282
  %.247.i285 = load double, ptr %.246.i, align 8, !noalias !18
  %.227.i = getelementptr double, ptr %11, i64 %cell.3.2.i282
  %.228.i286 = load double, ptr %.227.i, align 8, !noalias !18
  %.215.i = getelementptr inbounds double, ptr %.1262, i64 %cell.3.2.i282
  %.216.i = load double, ptr %.215.i, align 8, !noalias !18
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
  %.397.i = load <8 x double>, ptr %scevgep11.i292, align 8, !noalias !18
  %.8.i.i293 = fadd contract <8 x double> %.7.i.i289, %.397.i
  %.431.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i.i293, <8 x double> %.427.i, <8 x double> %.430.i)
  %.435.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i.i293, <8 x double> %.431.i, <8 x double> %.434.i)
  %.439.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i.i293, <8 x double> %.435.i, <8 x double> %.438.i287)
  %scevgep1150 = getelementptr i8, ptr %scevgep1149, i64 %lsr.iv8.i290
  store <8 x double> %.439.i, ptr %scevgep1150, align 8, !noalias !18
  %lsr.iv.next9.i296 = add i64 %lsr.iv8.i290, 64
  %lsr.iv.next25 = add nsw i64 %lsr.iv24, -1
  %.350.i = icmp sgt i64 %lsr.iv24, 6
  br i1 %.350.i, label %B412.if.i, label %B612.i

B4582:                                            ; preds = %B926.i, %B612.i669, %B1932.endif, %B1682, %B1626
  %.5919..5863 = phi i64 [ %.13.i589, %B1626 ], [ %.13.i587, %B612.i669 ], [ %.13.i587, %B1682 ], [ %.13.i587, %B1932.endif ], [ %.13.i587, %B926.i ]
  %cells.5.sroa.13.1 = phi i64 [ %cells.3.sroa.13.0241, %B1626 ], [ %cell.3.2.i625, %B612.i669 ], [ %cells.3.sroa.13.0241, %B1682 ], [ %cells.3.sroa.13.0241, %B1932.endif ], [ %cell.3.2.i, %B926.i ]
  %cells.5.sroa.0.1 = phi i64 [ %cells.3.sroa.0.0242, %B1626 ], [ %cell.5.1.i272, %B612.i669 ], [ %cells.3.sroa.0.0242, %B1682 ], [ %cell.5.1.i272, %B1932.endif ], [ %cells.3.sroa.0.0242, %B926.i ]
  %.6863 = sub nsw i64 %.5919..5863, %.5732.sroa.0.0245
  %.6870 = icmp sgt i64 %.6863, 0
  br i1 %.6870, label %B5243, label %B5244

B5243:                                            ; preds = %B4582
  %.6908 = sub nsw i64 %.13.i485, %.5732.sroa.0.0245
  %.13.i297 = tail call i64 @llvm.smax.i64(i64 %.6908, i64 0)
  %.13.i672 = tail call i64 @llvm.smin.i64(i64 %.6863, i64 %.13.i297)
  %.6968 = sub nsw i64 %.13.i486, %.5732.sroa.0.0245
  %.13.i673 = tail call i64 @llvm.smax.i64(i64 %.6968, i64 0)
  %.13.i674 = tail call i64 @llvm.smin.i64(i64 %.6863, i64 %.13.i673)
  %.7041 = getelementptr double, ptr %.335, i64 %.5732.sroa.0.0245
  %.7172 = getelementptr double, ptr %8, i64 %.5732.sroa.0.0245
  %.7301 = getelementptr double, ptr %9, i64 %.5732.sroa.0.0245
  store ptr null, ptr %.7353, align 8
  call fastcc void @inner_10(ptr nonnull %.7353, ptr %.7041, ptr %.7172, ptr %.7301, i64 %.13.i672, i64 %.13.i674, i64 %.6863, double %.3595, ptr %arg.scratch.4, double %constant.2.1, ptr %.1615, ptr %.1740)
  %38 = add nuw i64 %.6863, 7
  %.1167.i = lshr i64 %38, 3
  %.1013.i = load double, ptr %sunkaddr75, align 8, !noalias !21
  %.984.i = load double, ptr %sunkaddr76, align 8, !noalias !21
  %.955.i = load double, ptr %sunkaddr77, align 8, !noalias !21
  %.926.i = load double, ptr %sunkaddr78, align 8, !noalias !21
  %.897.i = load double, ptr %sunkaddr79, align 8, !noalias !21
  %.868.i = load double, ptr %sunkaddr80, align 8, !noalias !21
  %.839.i = load double, ptr %sunkaddr81, align 8, !noalias !21
  %.810.i = load double, ptr %sunkaddr82, align 8, !noalias !21
  %.781.i = load double, ptr %sunkaddr83, align 8, !noalias !21
  %.752.i = load double, ptr %sunkaddr84, align 8, !noalias !21
  %.648.i = load double, ptr %sunkaddr85, align 8, !noalias !21
  %.619.i = load double, ptr %sunkaddr86, align 8, !noalias !21
  %.590.i = load double, ptr %sunkaddr87, align 8, !noalias !21
  %.561.i = load double, ptr %sunkaddr88, align 8, !noalias !21
  %.532.i = load double, ptr %sunkaddr89, align 8, !noalias !21
  %.503.i = load double, ptr %sunkaddr90, align 8, !noalias !21
  %.474.i = load double, ptr %sunkaddr91, align 8, !noalias !21
  %.445.i = load double, ptr %sunkaddr92, align 8, !noalias !21
  %.344.i = load double, ptr %sunkaddr93, align 8, !noalias !21
  %.315.i711 = load double, ptr %sunkaddr94, align 8, !noalias !21
  %.286.i = load double, ptr %sunkaddr95, align 8, !noalias !21
  %.257.i = load double, ptr %sunkaddr96, align 8, !noalias !21
  %.228.i714 = load double, ptr %sunkaddr97, align 8, !noalias !21
  %.199.i = load double, ptr %sunkaddr98, align 8, !noalias !21
  %.170.i715 = load double, ptr %sunkaddr99, align 8, !noalias !21
  %.141.i = load double, ptr %sunkaddr100, align 8, !noalias !21
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

B5244:                                            ; preds = %B484.if.i, %B4582
  br i1 %"$phi984.0.3.013", label %B5486, label %B5564

B5486:                                            ; preds = %B5244
  %.137.i = icmp slt i64 %.13.i588, %.13.i587
  br i1 %.137.i, label %B22.preheader.i736, label %B5564

B5564:                                            ; preds = %B1344.i, %B5486, %B5244
  %cells.4.sroa.8.1 = phi i64 [ %cells.5.sroa.13.1, %B5244 ], [ %cells.5.sroa.13.1, %B5486 ], [ %cell.3.2.i746, %B1344.i ]
  %cells.4.sroa.0.1 = phi i64 [ %cells.5.sroa.0.1, %B5244 ], [ 0, %B5486 ], [ 0, %B1344.i ]
  store ptr null, ptr %.8351, align 8
  call fastcc void @inner_11(ptr nonnull %.8351, i64 %arg.i, i64 %.5732.sroa.0.0245, i64 %.13.i587, i64 %.13.i, ptr %arg.arguments.4, ptr %.1740, ptr %.1803, double %arg.plus, double %arg.cross, ptr %.1897)
  %.5742 = icmp samesign ugt i64 %.5689.1244.in, 1
  %.5755 = add i64 %.5686.1243, 1024
  %.5686.1 = select i1 %.5742, i64 %.5755, i64 %.5686.1243
  %40 = tail call i64 @llvm.smax.i64(i64 %.5689.1244.in, i64 2)
  %41 = add nsw i64 %40, -1
  %.5732.sroa.0.0 = select i1 %.5742, i64 %.5686.1243, i64 0
  br i1 %.5742, label %B1604, label %B5566

common.ret:                                       ; preds = %B1350.if, %B1218.if, %B5566
  %common.ret.op = phi i32 [ 0, %B5566 ], [ 1, %B1350.if ], [ 1, %B1218.if ]
  ret i32 %common.ret.op

B5566:                                            ; preds = %B5564, %B1596
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
  %sunkaddr39 = getelementptr i8, ptr %arg.linear.4, i64 %lsr.iv53.i
  %.554.i404 = load <8 x double>, ptr %sunkaddr39, align 8, !noalias !24
  %sunkaddr41 = getelementptr i8, ptr %sunkaddr39, i64 8
  %.565.i = load <8 x double>, ptr %sunkaddr41, align 8, !noalias !24
  %scevgep1198 = getelementptr i8, ptr %scevgep1196, i64 %lsr.iv53.i
  %scevgep1199 = getelementptr i8, ptr %scevgep1198, i64 -8
  %.575.i = load <8 x double>, ptr %scevgep1199, align 8, !noalias !24
  %.586.i = load <8 x double>, ptr %scevgep1198, align 8, !noalias !24
  %scevgep67.i = getelementptr i8, ptr %.201.i399, i64 %lsr.iv53.i
  %.596.i = load <8 x double>, ptr %scevgep67.i, align 8, !noalias !24
  %scevgep66.i = getelementptr i8, ptr %.373.i, i64 %lsr.iv53.i
  %.606.i = load <8 x double>, ptr %scevgep66.i, align 8, !noalias !24
  %.6.i.i405 = fsub contract <8 x double> %.565.i, %.554.i404
  %.6.i46.i = fmul contract <8 x double> %.6.i.i405, %.606.i
  %scevgep65.i = getelementptr i8, ptr %.1262, i64 %lsr.iv53.i
  store <8 x double> %.554.i404, ptr %scevgep65.i, align 8, !noalias !24
  %.669.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.575.i, <8 x double> splat (double 2.000000e+00), <8 x double> %.586.i)
  %.8.i.i406 = fmul contract <8 x double> %.669.i, splat (double 0x3FC5555555555555)
  %.6.i47.i = fmul contract <8 x double> %.596.i, %.8.i.i406
  %.6.i48.i = fsub contract <8 x double> %.6.i46.i, %.6.i47.i
  %scevgep64.i = getelementptr i8, ptr %42, i64 %lsr.iv53.i
  store <8 x double> %.6.i48.i, ptr %scevgep64.i, align 8, !noalias !24
  %.8.i49.i = fmul contract <8 x double> %.575.i, splat (double 5.000000e-01)
  %scevgep63.i = getelementptr i8, ptr %43, i64 %lsr.iv53.i
  store <8 x double> %.8.i49.i, ptr %scevgep63.i, align 8, !noalias !24
  %.6.i50.i = fsub contract <8 x double> %.586.i, %.575.i
  %.6.i51.i = fmul contract <8 x double> %.6.i50.i, %.606.i
  %.8.i52.i = fmul contract <8 x double> %.6.i51.i, splat (double 0x3FC5555555555555)
  %scevgep62.i = getelementptr i8, ptr %44, i64 %lsr.iv53.i
  store <8 x double> %.8.i52.i, ptr %scevgep62.i, align 8, !noalias !24
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
  br i1 %.507321.not.i442, label %_ZN17bnserve_surrogate6kernel7_points10fill_cellsB4v130B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedExx5ArrayIdLi1E1C7mutable7alignedE.exit479, label %B94.if.lr.ph.i443

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
  %.554.i449 = load <8 x double>, ptr %scevgep1193, align 8, !noalias !27
  %.565.i451 = load <8 x double>, ptr %scevgep1192, align 8, !noalias !27
  %scevgep1188 = getelementptr i8, ptr %scevgep1186, i64 %lsr.iv53.i446
  %scevgep1189 = getelementptr i8, ptr %scevgep1188, i64 -8
  %.575.i453 = load <8 x double>, ptr %scevgep1189, align 8, !noalias !27
  %.586.i455 = load <8 x double>, ptr %scevgep1188, align 8, !noalias !27
  %scevgep58 = getelementptr i8, ptr %scevgep57, i64 %lsr.iv53.i446
  %.596.i457 = load <8 x double>, ptr %scevgep58, align 8, !noalias !27
  %scevgep56 = getelementptr i8, ptr %scevgep55, i64 %lsr.iv53.i446
  %.606.i459 = load <8 x double>, ptr %scevgep56, align 8, !noalias !27
  %.6.i.i460 = fsub contract <8 x double> %.565.i451, %.554.i449
  %.6.i46.i461 = fmul contract <8 x double> %.6.i.i460, %.606.i459
  %scevgep65.i462 = getelementptr i8, ptr %.1326, i64 %lsr.iv53.i446
  store <8 x double> %.554.i449, ptr %scevgep65.i462, align 8, !noalias !27
  %.669.i463 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.575.i453, <8 x double> splat (double 2.000000e+00), <8 x double> %.586.i455)
  %.8.i.i464 = fmul contract <8 x double> %.669.i463, splat (double 0x3FC5555555555555)
  %.6.i47.i465 = fmul contract <8 x double> %.596.i457, %.8.i.i464
  %.6.i48.i466 = fsub contract <8 x double> %.6.i46.i461, %.6.i47.i465
  %scevgep64.i467 = getelementptr i8, ptr %53, i64 %lsr.iv53.i446
  store <8 x double> %.6.i48.i466, ptr %scevgep64.i467, align 8, !noalias !27
  %.8.i49.i468 = fmul contract <8 x double> %.575.i453, splat (double 5.000000e-01)
  %scevgep63.i469 = getelementptr i8, ptr %54, i64 %lsr.iv53.i446
  store <8 x double> %.8.i49.i468, ptr %scevgep63.i469, align 8, !noalias !27
  %.6.i50.i470 = fsub contract <8 x double> %.586.i455, %.575.i453
  %.6.i51.i471 = fmul contract <8 x double> %.6.i50.i470, %.606.i459
  %.8.i52.i472 = fmul contract <8 x double> %.6.i51.i471, splat (double 0x3FC5555555555555)
  %scevgep62.i473 = getelementptr i8, ptr %55, i64 %lsr.iv53.i446
  store <8 x double> %.8.i52.i472, ptr %scevgep62.i473, align 8, !noalias !27
  %lsr.iv.next54.i475 = add i64 %lsr.iv53.i446, 64
  %lsr.iv.next31 = add nsw i64 %lsr.iv30, -1
  %.507.i476 = icmp sgt i64 %lsr.iv30, 6
  br i1 %.507.i476, label %B94.if.i445, label %_ZN17bnserve_surrogate6kernel7_points10fill_cellsB4v130B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedExx5ArrayIdLi1E1C7mutable7alignedE.exit479

_ZN17bnserve_surrogate6kernel7_points10fill_cellsB4v130B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedExx5ArrayIdLi1E1C7mutable7alignedE.exit479: ; preds = %B94.if.i445, %B984.endif.endif.endif.en...endif.3.endif.endif
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
  call fastcc void @inner_12(ptr nonnull %.3844, ptr %.402, i64 %.126, ptr %68, i64 %.296, double %_prepared_v99__vphi308_0.2.0, double %.3798)
  %.3862 = load i64, ptr %.3844, align 8
  %.3934 = getelementptr i8, ptr %.3653, i64 8
  %.3935 = load double, ptr %.3934, align 8
  %.3940 = fmul contract double %.3935, 0x3FF000000044B830
  %.3948.le = tail call contract double @llvm.log.f64(double %.3940)
  %.3953 = fsub contract double %.3948.le, %.3607.le
  store i64 0, ptr %.3999, align 8
  call fastcc void @inner_12(ptr nonnull %.3999, ptr %.402, i64 %.126, ptr %68, i64 %.296, double %_prepared_v99__vphi308_0.2.0, double %.3953)
  %.4017 = load i64, ptr %.3999, align 8
  %.4074 = fsub contract double 0xC0126BB1BBB55515, %.3607.le
  store i64 0, ptr %.4120, align 8
  call fastcc void @inner_12(ptr nonnull %.4120, ptr %.402, i64 %.126, ptr %68, i64 %.296, double %_prepared_v99__vphi308_0.2.0, double %.4074)
  %.4138 = load i64, ptr %.4120, align 8
  %.13.i485 = tail call i64 @llvm.smin.i64(i64 %.4017, i64 %.4138)
  %.4233 = fsub contract double 0xC00F4BD2B7AC1BAF, %.3607.le
  store i64 0, ptr %.4279, align 8
  call fastcc void @inner_12(ptr nonnull %.4279, ptr %.402, i64 %.126, ptr %68, i64 %.296, double %_prepared_v99__vphi308_0.2.0, double %.4233)
  %.4297 = load i64, ptr %.4279, align 8
  %.13.i486 = tail call i64 @llvm.smin.i64(i64 %.4017, i64 %.4297)
  %.4457 = load i64, ptr %.929, align 8
  %.4458 = icmp sgt i64 %.4457, 0
  %.4464 = icmp sgt i64 %.126, 2047
  %or.cond = select i1 %.4458, i1 %.4464, i1 false
  br i1 %or.cond, label %B1206, label %B1206.thread

B1206.thread:                                     ; preds = %_ZN17bnserve_surrogate6kernel7_points10fill_cellsB4v130B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedExx5ArrayIdLi1E1C7mutable7alignedE.exit479
  %.453710 = getelementptr i8, ptr %arg.contents.4, i64 152
  %.453811 = load i64, ptr %.453710, align 8
  %.454912 = getelementptr inbounds double, ptr %arg.weights.4, i64 %.453811
  br label %B1350

B1218.if:                                         ; preds = %B1218
  %.4869 = load ptr, ptr %excinfo.34, align 8
  store ptr %.4869, ptr %excinfo, align 8
  br label %common.ret

B1218.endif:                                      ; preds = %B1218
  %.4950 = load i64, ptr %.929, align 8
  %.135.i = load double, ptr %.402, align 8, !noalias !30
  %.143.i = add nsw i64 %.4950, -1
  %.181.i = icmp slt i64 %.4950, 2
  %..143.i = select i1 %.181.i, i64 0, i64 %.143.i
  %.225207.i = icmp sgt i64 %..143.i, 0
  br i1 %.225207.i, label %B92.if.preheader.i, label %_ZN17bnserve_surrogate6kernel7_places9find_endsB4v177B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5TupleI5ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedExdE5ArrayIdLi1E1C7mutable7alignedExdx5ArrayIxLi1E1C7mutable7alignedE.exit

B92.if.preheader.i:                               ; preds = %B1218.endif
  %69 = add i64 %.4017, -1
  %70 = shl i64 %.156, 3
  %71 = getelementptr i8, ptr %.335, i64 %70
  %scevgep1184 = getelementptr i8, ptr %71, i64 8
  br label %B92.if.i

B146.i:                                           ; preds = %B92.if.i
  %.291.i = fsub contract double %.281.i, %.135.i
  %.293.i = fmul contract double %_prepared_v99__vphi308_0.2.0, %.291.i
  %.5.i.i = fptosi double %.293.i to i64
  %.13.i5.i = tail call i64 @llvm.smin.i64(i64 %.296, i64 %.5.i.i)
  %.354.i = getelementptr inbounds i64, ptr %68, i64 %.13.i5.i
  %.355.i = load i64, ptr %.354.i, align 8, !noalias !30
  %.13.i6.i = tail call i64 @llvm.smax.i64(i64 %.355.i, i64 %end.3.0210.i)
  %.395.i489 = icmp slt i64 %.13.i6.i, %.4017
  br i1 %.395.i489, label %B284.i, label %B386.i

B284.i:                                           ; preds = %B146.i
  %.412.i = getelementptr inbounds nuw double, ptr %.402, i64 %.13.i6.i
  %.413.i = load double, ptr %.412.i, align 8, !noalias !30
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
  %.451.i = load double, ptr %scevgep1185, align 8, !noalias !30
  %.455.i = fcmp contract ugt double %.451.i, %.281.i
  br i1 %.455.i, label %B386.i, label %B324.i

B386.i:                                           ; preds = %B346.i, %B324.i, %B92.if.i, %B284.i, %B146.i
  %end.4.1.i = phi i64 [ %.13.i6.i, %B146.i ], [ %end.3.0210.i, %B92.if.i ], [ %.13.i6.i, %B284.i ], [ %.4017, %B324.i ], [ %.423.i, %B346.i ]
  %.13.i.i490 = tail call i64 @llvm.smin.i64(i64 %.4017, i64 %end.4.1.i)
  %73 = getelementptr i64, ptr %.1529, i64 %.231203208.i
  store i64 %.13.i.i490, ptr %73, align 8, !noalias !30
  %exitcond216.not.i = icmp eq i64 %.238.i, %..143.i
  br i1 %exitcond216.not.i, label %_ZN17bnserve_surrogate6kernel7_places9find_endsB4v177B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5TupleI5ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedExdE5ArrayIdLi1E1C7mutable7alignedExdx5ArrayIxLi1E1C7mutable7alignedE.exit, label %B92.if.i

B92.if.i:                                         ; preds = %B386.i, %B92.if.preheader.i
  %end.3.0210.i = phi i64 [ %end.4.1.i, %B386.i ], [ 0, %B92.if.preheader.i ]
  %.231203208.i = phi i64 [ %.238.i, %B386.i ], [ 0, %B92.if.preheader.i ]
  %.238.i = add nuw nsw i64 %.231203208.i, 1
  %.278.i = getelementptr inbounds nuw double, ptr %.4549, i64 %.231203208.i
  %.279.i487 = load double, ptr %.278.i, align 8, !noalias !30
  %.281.i = fsub contract double %.279.i487, %.3607.le
  %.287.i488 = fcmp contract ult double %.281.i, %.135.i
  br i1 %.287.i488, label %B386.i, label %B146.i

_ZN17bnserve_surrogate6kernel7_places9find_endsB4v177B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5TupleI5ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedExdE5ArrayIdLi1E1C7mutable7alignedExdx5ArrayIxLi1E1C7mutable7alignedE.exit: ; preds = %B386.i, %B1218.endif
  %.586.inv.i = icmp sgt i64 %.4950, 0
  %.587.i = select i1 %.586.inv.i, i64 0, i64 %.973
  %74 = getelementptr i64, ptr %.1529, i64 %.143.i
  %.601.i = getelementptr i64, ptr %74, i64 %.587.i
  store i64 %.4017, ptr %.601.i, align 8, !noalias !30
  %.5056 = icmp sgt i64 %.3862, 0
  br i1 %.5056, label %B1350, label %B1596

B1350.if:                                         ; preds = %B1350
  %.5085 = load ptr, ptr %excinfo.36, align 8
  store ptr %.5085, ptr %excinfo, align 8
  br label %common.ret

B1350.endif:                                      ; preds = %B1350
  %.5311 = load i64, ptr %.844, align 8
  %.135.i498 = load double, ptr %.402, align 8, !noalias !33
  %.143.i499 = add nsw i64 %.5311, -2
  %.181.i500 = icmp slt i64 %.5311, 3
  %..143.i501 = select i1 %.181.i500, i64 0, i64 %.143.i499
  %.225207.i502 = icmp sgt i64 %..143.i501, 0
  br i1 %.225207.i502, label %B92.if.preheader.i506, label %_ZN17bnserve_surrogate6kernel7_places9find_endsB4v177B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5TupleI5ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedExdE5ArrayIdLi1E1C7mutable7alignedExdx5ArrayIxLi1E1C7mutable7alignedE.exit541

B92.if.preheader.i506:                            ; preds = %B1350.endif
  %75 = add i64 %.4017, -1
  %76 = shl i64 %.156, 3
  %77 = getelementptr i8, ptr %.335, i64 %76
  %scevgep1182 = getelementptr i8, ptr %77, i64 8
  br label %B92.if.i507

B146.i515:                                        ; preds = %B92.if.i507
  %.291.i516 = fsub contract double %.281.i513, %.135.i498
  %.293.i517 = fmul contract double %_prepared_v99__vphi308_0.2.0, %.291.i516
  %.5.i.i518 = fptosi double %.293.i517 to i64
  %.13.i5.i519 = tail call i64 @llvm.smin.i64(i64 %.296, i64 %.5.i.i518)
  %.354.i520 = getelementptr inbounds i64, ptr %68, i64 %.13.i5.i519
  %.355.i521 = load i64, ptr %.354.i520, align 8, !noalias !33
  %.13.i6.i522 = tail call i64 @llvm.smax.i64(i64 %.355.i521, i64 %end.3.0210.i508)
  %.395.i523 = icmp slt i64 %.13.i6.i522, %.4017
  br i1 %.395.i523, label %B284.i528, label %B386.i524

B284.i528:                                        ; preds = %B146.i515
  %.412.i529 = getelementptr inbounds nuw double, ptr %.402, i64 %.13.i6.i522
  %.413.i530 = load double, ptr %.412.i529, align 8, !noalias !33
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
  %.451.i539 = load double, ptr %scevgep1183, align 8, !noalias !33
  %.455.i540 = fcmp contract ugt double %.451.i539, %.281.i513
  br i1 %.455.i540, label %B386.i524, label %B324.i532

B386.i524:                                        ; preds = %B346.i535, %B324.i532, %B92.if.i507, %B284.i528, %B146.i515
  %end.4.1.i525 = phi i64 [ %.13.i6.i522, %B146.i515 ], [ %end.3.0210.i508, %B92.if.i507 ], [ %.13.i6.i522, %B284.i528 ], [ %.4017, %B324.i532 ], [ %.423.i536, %B346.i535 ]
  %.13.i.i526 = tail call i64 @llvm.smin.i64(i64 %.4017, i64 %end.4.1.i525)
  %79 = getelementptr i64, ptr %.1466, i64 %.231203208.i509
  store i64 %.13.i.i526, ptr %79, align 8, !noalias !33
  %exitcond216.not.i527 = icmp eq i64 %.238.i510, %..143.i501
  br i1 %exitcond216.not.i527, label %_ZN17bnserve_surrogate6kernel7_places9find_endsB4v177B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5TupleI5ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedExdE5ArrayIdLi1E1C7mutable7alignedExdx5ArrayIxLi1E1C7mutable7alignedE.exit541, label %B92.if.i507

B92.if.i507:                                      ; preds = %B386.i524, %B92.if.preheader.i506
  %end.3.0210.i508 = phi i64 [ %end.4.1.i525, %B386.i524 ], [ 0, %B92.if.preheader.i506 ]
  %.231203208.i509 = phi i64 [ %.238.i510, %B386.i524 ], [ 0, %B92.if.preheader.i506 ]
  %.238.i510 = add nuw nsw i64 %.231203208.i509, 1
  %sunkaddr1214 = shl i64 %.231203208.i509, 3
  %sunkaddr1215 = getelementptr inbounds i8, ptr %.3100, i64 %sunkaddr1214
  %sunkaddr1216 = getelementptr inbounds nuw i8, ptr %sunkaddr1215, i64 8
  %.279.i512 = load double, ptr %sunkaddr1216, align 8, !noalias !33
  %.281.i513 = fsub contract double %.279.i512, %.3607.le
  %.287.i514 = fcmp contract ult double %.281.i513, %.135.i498
  br i1 %.287.i514, label %B386.i524, label %B146.i515

_ZN17bnserve_surrogate6kernel7_places9find_endsB4v177B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5TupleI5ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedExdE5ArrayIdLi1E1C7mutable7alignedExdx5ArrayIxLi1E1C7mutable7alignedE.exit541: ; preds = %B386.i524, %B1350.endif
  %.586.inv.i503 = icmp sgt i64 %.5311, 1
  %.587.i504 = select i1 %.586.inv.i503, i64 0, i64 %.888
  %80 = getelementptr i64, ptr %.1466, i64 %.143.i499
  %.601.i505 = getelementptr i64, ptr %80, i64 %.587.i504
  store i64 %.4017, ptr %.601.i505, align 8, !noalias !33
  %.5388 = load i64, ptr %.1002, align 8
  %.5389 = icmp eq i64 %.5388, 0
  br i1 %.5389, label %B1408, label %B1596

B92.if.preheader.i550:                            ; preds = %B1408
  %81 = add i64 %.4017, -1
  %82 = shl i64 %.156, 3
  %83 = getelementptr i8, ptr %.335, i64 %82
  %scevgep1180 = getelementptr i8, ptr %83, i64 8
  br label %B92.if.i551

B146.i559:                                        ; preds = %B92.if.i551
  %.291.i560 = fsub contract double %.281.i557, %.135.i542
  %.293.i561 = fmul contract double %_prepared_v99__vphi308_0.2.0, %.291.i560
  %.5.i.i562 = fptosi double %.293.i561 to i64
  %.13.i5.i563 = tail call i64 @llvm.smin.i64(i64 %.296, i64 %.5.i.i562)
  %.354.i564 = getelementptr inbounds i64, ptr %68, i64 %.13.i5.i563
  %.355.i565 = load i64, ptr %.354.i564, align 8, !noalias !12
  %.13.i6.i566 = tail call i64 @llvm.smax.i64(i64 %.355.i565, i64 %end.3.0210.i552)
  %.395.i567 = icmp slt i64 %.13.i6.i566, %.4017
  br i1 %.395.i567, label %B284.i572, label %B386.i568

B284.i572:                                        ; preds = %B146.i559
  %.412.i573 = getelementptr inbounds nuw double, ptr %.402, i64 %.13.i6.i566
  %.413.i574 = load double, ptr %.412.i573, align 8, !noalias !12
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
  %.451.i583 = load double, ptr %scevgep1181, align 8, !noalias !12
  %.455.i584 = fcmp contract ugt double %.451.i583, %.281.i557
  br i1 %.455.i584, label %B386.i568, label %B324.i576

B386.i568:                                        ; preds = %B346.i579, %B324.i576, %B92.if.i551, %B284.i572, %B146.i559
  %end.4.1.i569 = phi i64 [ %.13.i6.i566, %B146.i559 ], [ %end.3.0210.i552, %B92.if.i551 ], [ %.13.i6.i566, %B284.i572 ], [ %.4017, %B324.i576 ], [ %.423.i580, %B346.i579 ]
  %.13.i.i570 = tail call i64 @llvm.smin.i64(i64 %.4017, i64 %end.4.1.i569)
  %85 = getelementptr i64, ptr %.1403, i64 %.231203208.i553
  store i64 %.13.i.i570, ptr %85, align 8, !noalias !12
  %exitcond216.not.i571 = icmp eq i64 %.238.i554, %..143.i545
  br i1 %exitcond216.not.i571, label %_ZN17bnserve_surrogate6kernel7_places9find_endsB4v177B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5TupleI5ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedExdE5ArrayIdLi1E1C7mutable7alignedExdx5ArrayIxLi1E1C7mutable7alignedE.exit585, label %B92.if.i551

B92.if.i551:                                      ; preds = %B386.i568, %B92.if.preheader.i550
  %end.3.0210.i552 = phi i64 [ %end.4.1.i569, %B386.i568 ], [ 0, %B92.if.preheader.i550 ]
  %.231203208.i553 = phi i64 [ %.238.i554, %B386.i568 ], [ 0, %B92.if.preheader.i550 ]
  %.238.i554 = add nuw nsw i64 %.231203208.i553, 1
  %sunkaddr1218 = shl i64 %.231203208.i553, 3
  %sunkaddr1219 = getelementptr inbounds i8, ptr %.3007, i64 %sunkaddr1218
  %sunkaddr1220 = getelementptr inbounds nuw i8, ptr %sunkaddr1219, i64 8
  %.279.i556 = load double, ptr %sunkaddr1220, align 8, !noalias !12
  %.281.i557 = fsub contract double %.279.i556, %.3607.le
  %.287.i558 = fcmp contract ult double %.281.i557, %.135.i542
  br i1 %.287.i558, label %B386.i568, label %B146.i559

_ZN17bnserve_surrogate6kernel7_places9find_endsB4v177B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5TupleI5ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedExdE5ArrayIdLi1E1C7mutable7alignedExdx5ArrayIxLi1E1C7mutable7alignedE.exit585: ; preds = %B386.i568, %B1408
  %.586.inv.i547 = icmp sgt i64 %.5506, 1
  %.587.i548 = select i1 %.586.inv.i547, i64 0, i64 %.814
  %86 = getelementptr i64, ptr %.1403, i64 %.143.i543
  %.601.i549 = getelementptr i64, ptr %86, i64 %.587.i548
  store i64 %.4017, ptr %.601.i549, align 8, !noalias !12
  br label %B1596

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
  br label %_ZN17bnserve_surrogate6kernel7_points4stepB4v179B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEd.exit.i

select.false.sink.i.i:                            ; preds = %B94.i
  %.46.i.i = fmul contract double %.38.i.i, %.39.i.i
  %.40.i.i = tail call contract double @llvm.fma.f64(double %.39.i.i, double 0xBD6AE7F3E733B81F, double 0x3DE6124613A86D09)
  %.41.i.i = tail call contract double @llvm.fma.f64(double %.39.i.i, double %.40.i.i, double 0xBE5AE64567F544E4)
  %.42.i.i = tail call contract double @llvm.fma.f64(double %.39.i.i, double %.41.i.i, double 0x3EC71DE3A556C734)
  %.43.i.i = tail call contract double @llvm.fma.f64(double %.39.i.i, double %.42.i.i, double 0xBF2A01A01A01A01A)
  %.44.i.i = tail call contract double @llvm.fma.f64(double %.39.i.i, double %.43.i.i, double 0x3F81111111111111)
  %.45.i.i = tail call contract double @llvm.fma.f64(double %.39.i.i, double %.44.i.i, double 0xBFC5555555555555)
  %.47.i.i = tail call contract double @llvm.fma.f64(double %.46.i.i, double %.45.i.i, double %.38.i.i)
  br label %_ZN17bnserve_surrogate6kernel7_points4stepB4v179B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEd.exit.i

_ZN17bnserve_surrogate6kernel7_points4stepB4v179B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEd.exit.i: ; preds = %select.false.sink.i.i, %select.true.sink.i.i
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

B144.i:                                           ; preds = %B34.if.i, %_ZN17bnserve_surrogate6kernel7_points4stepB4v179B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEd.exit.i
  %"$phi144.1.2.1.i" = phi double [ %.266.i598, %_ZN17bnserve_surrogate6kernel7_points4stepB4v179B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEd.exit.i ], [ 0.000000e+00, %B34.if.i ]
  %scevgep19 = getelementptr i8, ptr %scevgep, i64 %89
  %scevgep20 = getelementptr i8, ptr %scevgep19, i64 -8256
  store double %"$phi144.1.2.1.i", ptr %scevgep20, align 8, !noalias !36
  %.314.i = fsub contract double %.218.i, %.6068
  %88 = fmul contract double %.6098, %.314.i
  %.319.i = fsub contract double %.1143, %88
  store double %.319.i, ptr %scevgep19, align 8, !noalias !36
  %exitcond.not.i594 = icmp eq i64 %.6038, %.158.i
  br i1 %exitcond.not.i594, label %B1626, label %B34.if.i

B34.if.i:                                         ; preds = %B1606, %B144.i
  %.151102104.i = phi i64 [ %.158.i, %B144.i ], [ 0, %B1606 ]
  %.158.i = add nuw nsw i64 %.151102104.i, 1
  %89 = shl i64 %.151102104.i, 3
  %scevgep2.i = getelementptr i8, ptr %.5985, i64 %89
  %.216.i590 = load double, ptr %scevgep2.i, align 8, !noalias !36
  %.218.i = fmul contract double %.3595, %.216.i590
  %.223.i = fmul contract double %.218.i, 2.000000e+00
  %.228.i591 = fdiv contract double %.223.i, %.6068
  %.228.fr.i = freeze double %.228.i591
  %.229.i592 = fadd contract double %.228.fr.i, -1.000000e+00
  %.234.i593 = fcmp contract ogt double %.229.i592, 0.000000e+00
  br i1 %.234.i593, label %B94.i, label %B144.i

B1932.endif:                                      ; preds = %B612.i, %B1932
  %cell.5.1.i272 = phi i64 [ %cells.3.sroa.0.0242, %B1932 ], [ %cell.3.2.i282, %B612.i ]
  br i1 %29, label %B22.preheader.i606, label %B4582

B22.preheader.i606:                               ; preds = %B1932.endif
  %90 = mul i64 %.5732.sroa.0.0245, -8
  %scevgep1156 = getelementptr i8, ptr %scevgep, i64 %90
  br label %B22.i610

B22.i610:                                         ; preds = %B612.i669, %B22.preheader.i606
  %cell.2.0.i611 = phi i64 [ %cell.3.2.i625, %B612.i669 ], [ %cells.3.sroa.13.0241, %B22.preheader.i606 ]
  %start.2.0.i612 = phi i64 [ %.13.i.i628, %B612.i669 ], [ %.13.i589, %B22.preheader.i606 ]
  %.121.i613 = getelementptr inbounds i64, ptr %.1466, i64 %cell.2.0.i611
  %.122.i614 = load i64, ptr %.121.i613, align 8, !noalias !39
  %.126.not.i615 = icmp sgt i64 %.122.i614, %start.2.0.i612
  br i1 %.126.not.i615, label %B112.i624, label %B62.i616

B62.i616:                                         ; preds = %B22.i610, %B62.i616
  %cell.4.1.i617 = phi i64 [ %.129.i618, %B62.i616 ], [ %cell.2.0.i611, %B22.i610 ]
  %.129.i618 = add i64 %cell.4.1.i617, 1
  %sunkaddr.i619 = shl i64 %cell.4.1.i617, 3
  %scevgep1154 = getelementptr i8, ptr %scevgep1139, i64 %sunkaddr.i619
  %.142.i622 = load i64, ptr %scevgep1154, align 8, !noalias !39
  %.144.not.i623 = icmp sgt i64 %.142.i622, %start.2.0.i612
  br i1 %.144.not.i623, label %B112.i624, label %B62.i616

B112.i624:                                        ; preds = %B62.i616, %B22.i610
  %cell.3.2.i625 = phi i64 [ %cell.2.0.i611, %B22.i610 ], [ %.129.i618, %B62.i616 ]
  %.156.i626 = getelementptr inbounds i64, ptr %.1466, i64 %cell.3.2.i625
  %.157.i627 = load i64, ptr %.156.i626, align 8, !noalias !39
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
  br i1 %.479.i670, label %B22.i610, label %B4582

B412.if.lr.ph.i634:                               ; preds = %B112.i624
  %.200.i635 = getelementptr inbounds double, ptr %.3100, i64 %cell.3.2.i625
  %.201.i636 = load double, ptr %.200.i635, align 8, !noalias !39
  %.203.i637 = fsub contract double %.3607.le, %.201.i636
  %.259.i638 = getelementptr double, ptr %16, i64 %cell.3.2.i625
  %.260.i639 = load double, ptr %.259.i638, align 8, !noalias !39
  %.246.i640 = getelementptr double, ptr %15, i64 %cell.3.2.i625
  %.247.i641 = load double, ptr %.246.i640, align 8, !noalias !39
  %.227.i642 = getelementptr double, ptr %14, i64 %cell.3.2.i625
  %.228.i643 = load double, ptr %.227.i642, align 8, !noalias !39
  %.215.i644 = getelementptr inbounds double, ptr %.1326, i64 %cell.3.2.i625
  %.216.i645 = load double, ptr %.215.i644, align 8, !noalias !39
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
  %.397.i660 = load <8 x double>, ptr %scevgep11.i659, align 8, !noalias !39
  %.8.i.i661 = fadd contract <8 x double> %.7.i.i655, %.397.i660
  %.431.i662 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i.i661, <8 x double> %.427.i647, <8 x double> %.430.i649)
  %.435.i663 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i.i661, <8 x double> %.431.i662, <8 x double> %.434.i651)
  %.439.i664 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i.i661, <8 x double> %.435.i663, <8 x double> %.438.i653)
  %scevgep1157 = getelementptr i8, ptr %scevgep1156, i64 %lsr.iv8.i657
  store <8 x double> %.439.i664, ptr %scevgep1157, align 8, !noalias !39
  %lsr.iv.next9.i667 = add i64 %lsr.iv8.i657, 64
  %lsr.iv.next27 = add nsw i64 %lsr.iv26, -1
  %.350.i668 = icmp sgt i64 %lsr.iv26, 6
  br i1 %.350.i668, label %B412.if.i656, label %B612.i669

B484.if.i:                                        ; preds = %B484.if.i, %B5243
  %lsr.iv = phi i64 [ %lsr.iv.next, %B484.if.i ], [ %39, %B5243 ]
  %lsr.iv1164 = phi ptr [ %scevgep1165, %B484.if.i ], [ %.7041, %B5243 ]
  %lsr.iv1161 = phi ptr [ %scevgep1162, %B484.if.i ], [ %scevgep1160, %B5243 ]
  %scevgep1168 = getelementptr i8, ptr %lsr.iv1164, i64 %.idx
  %.1236.i = load <8 x double>, ptr %scevgep1168, align 8, !noalias !21
  %.1246.i = load <8 x double>, ptr %lsr.iv1164, align 8, !noalias !21
  %sunkaddr102 = getelementptr i8, ptr %lsr.iv1164, i64 %sunkaddr101
  %.1256.i = load <8 x double>, ptr %sunkaddr102, align 8, !noalias !21
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
  %scevgep1166 = getelementptr i8, ptr %lsr.iv1164, i64 %.idx3736
  %.1377.i = load <8 x double>, ptr %scevgep1166, align 8, !noalias !21
  %.6.i16.i = fmul contract <8 x double> %.1377.i, %.1367.i
  %.6.i17.i = fmul contract <8 x double> %.1246.i, %.1256.i
  %.1426.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1236.i, <8 x double> %.1366.i, <8 x double> %.1355.i)
  %.1430.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i17.i, <8 x double> %.1429.i, <8 x double> %.1426.i)
  %.1431.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1236.i, <8 x double> %.1310.i, <8 x double> %.1295.i)
  %scevgep1163 = getelementptr i8, ptr %lsr.iv1161, i64 -16512
  %.1441.i = load <8 x double>, ptr %scevgep1163, align 8, !noalias !21
  %.1442.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1246.i, <8 x double> %.1431.i, <8 x double> %.1441.i)
  %.1443.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1256.i, <8 x double> %.1430.i, <8 x double> %.1442.i)
  %.6.i18.i = fadd contract <8 x double> %.6.i16.i, %.1443.i
  %.1450.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1246.i, <8 x double> %.1447.i, <8 x double> %.1449.i)
  %.6.i19.i = fsub contract <8 x double> %.1450.i, %.6.i18.i
  store <8 x double> %.6.i19.i, ptr %lsr.iv1161, align 8, !noalias !21
  %scevgep1162 = getelementptr i8, ptr %lsr.iv1161, i64 64
  %scevgep1165 = getelementptr i8, ptr %lsr.iv1164, i64 64
  %lsr.iv.next = add nsw i64 %lsr.iv, -1
  %.1189.i = icmp sgt i64 %lsr.iv, 6
  br i1 %.1189.i, label %B484.if.i, label %B5244

B22.preheader.i736:                               ; preds = %B5486
  %94 = mul i64 %.5732.sroa.0.0245, -8
  %scevgep1174 = getelementptr i8, ptr %scevgep1160, i64 %94
  br label %B22.i737

B22.i737:                                         ; preds = %B1344.i, %B22.preheader.i736
  %cell.2.0.i738 = phi i64 [ %cell.3.2.i746, %B1344.i ], [ %cells.5.sroa.13.1, %B22.preheader.i736 ]
  %start.2.0.i739 = phi i64 [ %.13.i.i747, %B1344.i ], [ %.13.i589, %B22.preheader.i736 ]
  %.160.i = getelementptr inbounds i64, ptr %.1529, i64 %cell.2.0.i738
  %.161.i = load i64, ptr %.160.i, align 8, !noalias !42
  %.165.not.i = icmp sgt i64 %.161.i, %start.2.0.i739
  br i1 %.165.not.i, label %B112.i745, label %B62.i740

B62.i740:                                         ; preds = %B22.i737, %B62.i740
  %cell.4.1.i741 = phi i64 [ %.168.i, %B62.i740 ], [ %cell.2.0.i738, %B22.i737 ]
  %.168.i = add i64 %cell.4.1.i741, 1
  %sunkaddr.i742 = shl i64 %cell.4.1.i741, 3
  %scevgep1172 = getelementptr i8, ptr %scevgep1171, i64 %sunkaddr.i742
  %.181.i744 = load i64, ptr %scevgep1172, align 8, !noalias !42
  %.183.not.i = icmp sgt i64 %.181.i744, %start.2.0.i739
  br i1 %.183.not.i, label %B112.i745, label %B62.i740

B112.i745:                                        ; preds = %B62.i740, %B22.i737
  %cell.3.2.i746 = phi i64 [ %cell.2.0.i738, %B22.i737 ], [ %.168.i, %B62.i740 ]
  %.195.i = getelementptr inbounds i64, ptr %.1529, i64 %cell.3.2.i746
  %.196.i = load i64, ptr %.195.i, align 8, !noalias !42
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
  br i1 %.751.i, label %B22.i737, label %B5564

B808.if.lr.ph.i:                                  ; preds = %B112.i745
  %.261.i = shl nsw i64 %cell.3.2.i746, 3
  %96 = getelementptr double, ptr %.2023, i64 %.261.i
  %.478.i = getelementptr i8, ptr %96, i64 48
  %.479.i748 = load double, ptr %.478.i, align 8, !noalias !42
  %.311.i = or disjoint i64 %.261.i, 5
  %.468.i = getelementptr inbounds double, ptr %.2023, i64 %.311.i
  %.469.i = load double, ptr %.468.i, align 8, !noalias !42
  %.301.i = or disjoint i64 %.261.i, 4
  %.458.i = getelementptr inbounds double, ptr %.2023, i64 %.301.i
  %.459.i = load double, ptr %.458.i, align 8, !noalias !42
  %.291.i749 = or disjoint i64 %.261.i, 3
  %.412.i750 = getelementptr inbounds double, ptr %.2023, i64 %.291.i749
  %.413.i751 = load double, ptr %.412.i750, align 8, !noalias !42
  %.281.i752 = or disjoint i64 %.261.i, 2
  %.402.i = getelementptr inbounds double, ptr %.2023, i64 %.281.i752
  %.403.i = load double, ptr %.402.i, align 8, !noalias !42
  %.271.i = or disjoint i64 %.261.i, 1
  %.392.i = getelementptr inbounds double, ptr %.2023, i64 %.271.i
  %.393.i = load double, ptr %.392.i, align 8, !noalias !42
  %.383.i = load double, ptr %96, align 8, !noalias !42
  %.319.i753 = getelementptr inbounds double, ptr %.1959, i64 %.311.i
  %.320.i = load double, ptr %.319.i753, align 8, !noalias !42
  %.309.i = getelementptr inbounds double, ptr %.1959, i64 %.301.i
  %.310.i = load double, ptr %.309.i, align 8, !noalias !42
  %.299.i = getelementptr inbounds double, ptr %.1959, i64 %.291.i749
  %.300.i = load double, ptr %.299.i, align 8, !noalias !42
  %.289.i = getelementptr inbounds double, ptr %.1959, i64 %.281.i752
  %.290.i = load double, ptr %.289.i, align 8, !noalias !42
  %.279.i754 = getelementptr inbounds double, ptr %.1959, i64 %.271.i
  %.280.i = load double, ptr %.279.i754, align 8, !noalias !42
  %.269.i = getelementptr inbounds double, ptr %.1959, i64 %.261.i
  %.270.i = load double, ptr %.269.i, align 8, !noalias !42
  %.251.i = getelementptr inbounds double, ptr %.7837, i64 %cell.3.2.i746
  %.252.i = load double, ptr %.251.i, align 8, !noalias !42
  %.253.i = fsub contract double 0.000000e+00, %.252.i
  %.239.i = getelementptr inbounds double, ptr %.7772, i64 %cell.3.2.i746
  %.240.i = load double, ptr %.239.i, align 8, !noalias !42
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
  %.620.i = load <8 x double>, ptr %scevgep10.i757, align 8, !noalias !42
  %.627.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.620.i, <8 x double> %.624.i, <8 x double> %.626.i)
  %.636.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.627.i, <8 x double> %.632.i, <8 x double> %.635.i)
  %.640.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.627.i, <8 x double> %.636.i, <8 x double> %.639.i)
  %.644.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.627.i, <8 x double> %.640.i, <8 x double> %.643.i)
  %.648.i758 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.627.i, <8 x double> %.644.i, <8 x double> %.647.i755)
  %.652.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.627.i, <8 x double> %.648.i758, <8 x double> %.651.i)
  %scevgep1176 = getelementptr i8, ptr %scevgep1174, i64 %lsr.iv5.i
  %scevgep1177 = getelementptr i8, ptr %scevgep1176, i64 -8256
  store <8 x double> %.652.i, ptr %scevgep1177, align 8, !noalias !42
  %.669.i759 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.627.i, <8 x double> %.665.i, <8 x double> %.668.i)
  %.673.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.627.i, <8 x double> %.669.i759, <8 x double> %.672.i)
  %.677.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.627.i, <8 x double> %.673.i, <8 x double> %.676.i)
  %.683.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.627.i, <8 x double> %.677.i, <8 x double> %.682.i)
  %.687.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.627.i, <8 x double> %.683.i, <8 x double> %.686.i)
  %.691.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.627.i, <8 x double> %.687.i, <8 x double> %.690.i)
  store <8 x double> %.691.i, ptr %scevgep1176, align 8, !noalias !42
  %lsr.iv.next6.i = add i64 %lsr.iv5.i, 64
  %lsr.iv.next29 = add nsw i64 %lsr.iv28, -1
  %.573.i = icmp sgt i64 %lsr.iv28, 6
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
define internal fastcc noundef range(i32 0, 2) i32 @inner_8(ptr noalias nonnull writeonly captures(none) %retptr, ptr noalias nonnull writeonly captures(none) %excinfo, ptr readonly captures(none) %arg.row.4, ptr readonly captures(none) %arg.linear.4, ptr readonly captures(none) %arg.contents.4, ptr readonly captures(none) %arg.weights.4, i64 %arg.alignment, ptr readonly captures(none) %arg.cubics.0.4, ptr readonly captures(none) %arg.cubics.1.4, i64 range(i64 8, 1) %arg.stride, ptr captures(none) initializes((0, 64)) %arg.series.4, ptr initializes((0, 384)) %arg.work.4, ptr writeonly captures(none) %arg.polynomials_a.4, ptr writeonly captures(none) %arg.polynomials_p.4) unnamed_addr #5 {
entry:
  %.1140 = alloca double, align 8
  store double 0.000000e+00, ptr %.1140, align 8
  %excinfo.11 = alloca ptr, align 8
  store ptr null, ptr %excinfo.11, align 8
  %.1351 = alloca ptr, align 8
  store ptr null, ptr %.1351, align 8
  %.157 = getelementptr i8, ptr %arg.contents.4, i64 144
  %.158 = load i64, ptr %.157, align 8
  %.160 = sub i64 0, %.158
  %.168.1 = and i64 %.160, -8
  %.203 = shl i64 %.158, 3
  %.232 = getelementptr i8, ptr %arg.contents.4, i64 152
  %.233 = load i64, ptr %.232, align 8
  %.243 = getelementptr double, ptr %arg.weights.4, i64 %.233
  %.323 = getelementptr i8, ptr %arg.contents.4, i64 160
  %.324 = load i64, ptr %.323, align 8
  %0 = lshr i64 %.324, 47
  %.361 = and i64 %0, 65536
  %.362 = add i64 %.361, %.324
  %.365 = icmp slt i64 %.362, 0
  br i1 %.365, label %B0.endif.endif.else.if, label %B0.endif.endif.else.endif, !prof !5

common.ret:                                       ; preds = %B0.endif.endif.endif.endi...endif.5, %B0.endif.endif.endif.endi...endif.1.endif.endif.if
  %common.ret.op = phi i32 [ 1, %B0.endif.endif.endif.endi...endif.1.endif.endif.if ], [ 0, %B0.endif.endif.endif.endi...endif.5 ]
  ret i32 %common.ret.op

B0.endif.endif.else.if:                           ; preds = %entry
  br label %B0.endif.endif.else.endif

B0.endif.endif.else.endif:                        ; preds = %B0.endif.endif.else.if, %entry
  %.350.sroa.0.1 = phi i64 [ 0, %B0.endif.endif.else.if ], [ %.362, %entry ]
  %.370.not = icmp slt i64 %.362, 65536
  br i1 %.370.not, label %B0.endif.endif.else.endif.endif, label %B0.endif.endif.else.endif.if, !prof !1

B0.endif.endif.else.endif.if:                     ; preds = %B0.endif.endif.else.endif
  br label %B0.endif.endif.else.endif.endif

B0.endif.endif.else.endif.endif:                  ; preds = %B0.endif.endif.else.endif.if, %B0.endif.endif.else.endif
  %.350.sroa.0.3 = phi i64 [ 65536, %B0.endif.endif.else.endif.if ], [ %.350.sroa.0.1, %B0.endif.endif.else.endif ]
  %.463 = getelementptr i64, ptr %arg.contents.4, i64 %.350.sroa.0.3
  %.508.idx = mul i64 %.168.1, -24
  %.508 = getelementptr i8, ptr %.243, i64 %.508.idx
  %.577 = getelementptr i8, ptr %.508, i64 1024
  %.638 = getelementptr double, ptr %.577, i64 %.203
  %.700.idx = shl i64 %.158, 7
  %.700 = getelementptr i8, ptr %.577, i64 %.700.idx
  %.831.idx = mul i64 %.168.1, -64
  %.831 = getelementptr i8, ptr %arg.work.4, i64 %.831.idx
  %.916 = getelementptr i8, ptr %arg.contents.4, i64 120
  %.917 = load i64, ptr %.916, align 8
  %.927 = getelementptr inbounds double, ptr %arg.weights.4, i64 %.917
  %.992.idx = shl nsw i64 %arg.stride, 5
  %.992 = getelementptr inbounds i8, ptr %arg.linear.4, i64 %.992.idx
  %.1071 = getelementptr i8, ptr %arg.contents.4, i64 128
  %.1072 = load i64, ptr %.1071, align 8
  %.1088 = getelementptr inbounds double, ptr %arg.weights.4, i64 %.1072
  store double 0.000000e+00, ptr %.1140, align 8
  %.1154 = call fastcc i32 @inner_9(ptr nonnull %.1140, ptr nonnull %excinfo.11, ptr %arg.row.4, double 1.000000e+00, ptr %.1088, ptr %.992, i64 %arg.alignment, ptr %arg.work.4, ptr %arg.series.4)
  %.1164 = load double, ptr %.1140, align 8
  %cond = icmp eq i32 %.1154, 0
  br i1 %cond, label %B0.endif.endif.endif.endi...endif.1.endif.endif.endif, label %B0.endif.endif.endif.endi...endif.1.endif.endif.if, !prof !0

B0.endif.endif.endif.endi...endif.1.endif.endif.if: ; preds = %B0.endif.endif.else.endif.endif
  %.1155 = load ptr, ptr %excinfo.11, align 8
  store ptr %.1155, ptr %excinfo, align 8
  br label %common.ret

B0.endif.endif.endif.endi...endif.1.endif.endif.endif: ; preds = %B0.endif.endif.else.endif.endif
  %.31.i = icmp sgt i64 %.158, 0
  br i1 %.31.i, label %B24.i, label %B0.endif.endif.endif.endi...endif.2.endif.endif

B24.i:                                            ; preds = %B0.endif.endif.endif.endi...endif.1.endif.endif.endif, %B24.i
  %high.2.0.i = phi i64 [ %high.3.1.i, %B24.i ], [ %.203, %B0.endif.endif.endif.endi...endif.1.endif.endif.endif ]
  %low.2.0.i = phi i64 [ %low.3.1.i, %B24.i ], [ 0, %B0.endif.endif.endif.endi...endif.1.endif.endif.endif ]
  %.40.i = add nuw nsw i64 %low.2.0.i, %high.2.0.i
  %.41.i = lshr i64 %.40.i, 1
  %.53.i = getelementptr inbounds nuw double, ptr %.577, i64 %.41.i
  %.54.i = load double, ptr %.53.i, align 8, !noalias !62
  %.56.i = fcmp contract olt double %.54.i, 1.000000e-02
  %.67.i = add nuw nsw i64 %.41.i, 1
  %high.3.1.i = select i1 %.56.i, i64 %high.2.0.i, i64 %.41.i
  %low.3.1.i = select i1 %.56.i, i64 %.67.i, i64 %low.2.0.i
  %.98.i = icmp slt i64 %low.3.1.i, %high.3.1.i
  br i1 %.98.i, label %B24.i, label %B24.i48

B24.i48:                                          ; preds = %B24.i, %B24.i48
  %high.2.0.i49 = phi i64 [ %high.3.1.i57, %B24.i48 ], [ %.203, %B24.i ]
  %low.2.0.i50 = phi i64 [ %low.3.1.i58, %B24.i48 ], [ 0, %B24.i ]
  %.40.i51 = add nuw nsw i64 %low.2.0.i50, %high.2.0.i49
  %.41.i52 = lshr i64 %.40.i51, 1
  %.53.i53 = getelementptr inbounds nuw double, ptr %.577, i64 %.41.i52
  %.54.i54 = load double, ptr %.53.i53, align 8, !noalias !65
  %.56.i55 = fcmp contract olt double %.54.i54, 2.000000e-02
  %.67.i56 = add nuw nsw i64 %.41.i52, 1
  %high.3.1.i57 = select i1 %.56.i55, i64 %high.2.0.i49, i64 %.41.i52
  %low.3.1.i58 = select i1 %.56.i55, i64 %.67.i56, i64 %low.2.0.i50
  %.98.i59 = icmp slt i64 %low.3.1.i58, %high.3.1.i57
  br i1 %.98.i59, label %B24.i48, label %B34.if.lr.ph.i

B34.if.lr.ph.i:                                   ; preds = %B24.i48
  %1 = getelementptr double, ptr %arg.cubics.0.4, i64 %arg.stride
  %.idx.i = shl i64 %arg.stride, 4
  %2 = getelementptr i8, ptr %arg.cubics.0.4, i64 %.idx.i
  %.idx161.i = mul i64 %arg.stride, 24
  %3 = getelementptr i8, ptr %arg.cubics.0.4, i64 %.idx161.i
  br label %B34.if.i

B34.if.i:                                         ; preds = %B34.if.i, %B34.if.lr.ph.i
  %lsr.iv4.i = phi i64 [ %.158, %B34.if.lr.ph.i ], [ %lsr.iv.next5.i, %B34.if.i ]
  %lsr.iv.i = phi i64 [ 0, %B34.if.lr.ph.i ], [ %lsr.iv.next.i, %B34.if.i ]
  %scevgep3.i = getelementptr i8, ptr %.463, i64 %lsr.iv.i
  %.205.i = load i64, ptr %scevgep3.i, align 8, !noalias !68
  %4 = shl i64 %lsr.iv.i, 3
  %scevgep.i = getelementptr i8, ptr %.638, i64 %4
  %.216.i = load <8 x double>, ptr %scevgep.i, align 8, !noalias !68
  %.224.i = getelementptr inbounds double, ptr %.927, i64 %.205.i
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
  br i1 %exitcond.not.i, label %B0.endif.endif.endif.endi...endif.2.endif.endif, label %B34.if.i

B0.endif.endif.endif.endi...endif.2.endif.endif:  ; preds = %B34.if.i, %B0.endif.endif.endif.endi...endif.1.endif.endif.endif
  %low.4.1.i479 = phi i64 [ 0, %B0.endif.endif.endif.endi...endif.1.endif.endif.endif ], [ %low.3.1.i58, %B34.if.i ]
  %low.4.1.i38 = phi i64 [ 0, %B0.endif.endif.endif.endi...endif.1.endif.endif.endif ], [ %low.3.1.i, %B34.if.i ]
  %.1300.idx = shl nsw i64 %.158, 8
  %.1300 = getelementptr inbounds i8, ptr %.577, i64 %.1300.idx
  store ptr null, ptr %.1351, align 8
  call fastcc void @inner_10(ptr nonnull %.1351, ptr %.577, ptr %.700, ptr %.1300, i64 %low.4.1.i38, i64 %low.4.1.i479, i64 %.203, double 1.000000e+00, ptr %arg.series.4, double %.1164, ptr %arg.work.4, ptr %.831)
  %5 = icmp slt i64 %.158, 1
  br i1 %5, label %_ZN17bnserve_surrogate6kernel7_points15spline_at_nodesB4v168B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE.exit114, label %B64.if.i.preheader

B64.if.i.preheader:                               ; preds = %B0.endif.endif.endif.endi...endif.2.endif.endif
  %6 = shl i64 %.233, 3
  %7 = lshr i64 %.160, 3
  %.neg1 = mul i64 %7, -192
  %8 = getelementptr i8, ptr %arg.weights.4, i64 %.neg1
  %9 = getelementptr i8, ptr %8, i64 %6
  %scevgep313 = getelementptr i8, ptr %9, i64 576
  br label %B64.if.i

B424.i:                                           ; preds = %B172.if.i
  %.138.i = add nsw i64 %.128167175.i, -1
  %.142.i = add i64 %.135168174.i, 8
  %.6.i.i73 = fadd contract <8 x double> %.322.i, %.352.i
  %.398.i = getelementptr inbounds double, ptr %arg.polynomials_a.4, i64 %.135168174.i
  store <8 x double> %.6.i.i73, ptr %.398.i, align 8, !noalias !71
  %scevgep.i74 = getelementptr i8, ptr %lsr.iv2.i, i64 64
  %.129.i = icmp sgt i64 %.128167175.i, 1
  br i1 %.129.i, label %B64.if.i, label %B34.if.lr.ph.i76

B64.if.i:                                         ; preds = %B424.i, %B64.if.i.preheader
  %lsr.iv2.i = phi ptr [ %scevgep.i74, %B424.i ], [ %.831, %B64.if.i.preheader ]
  %.128167175.i = phi i64 [ %.138.i, %B424.i ], [ %.158, %B64.if.i.preheader ]
  %.135168174.i = phi i64 [ %.142.i, %B424.i ], [ 0, %B64.if.i.preheader ]
  br label %B172.if.i

B172.if.i:                                        ; preds = %B172.if.i, %B64.if.i
  %lsr.iv6 = phi i64 [ %lsr.iv.next7, %B172.if.i ], [ 10, %B64.if.i ]
  %lsr.iv309 = phi i64 [ %lsr.iv.next310, %B172.if.i ], [ 0, %B64.if.i ]
  %even.2.1163.i = phi <8 x double> [ %.322.i, %B172.if.i ], [ zeroinitializer, %B64.if.i ]
  %odd.2.1162.i = phi <8 x double> [ %.352.i, %B172.if.i ], [ zeroinitializer, %B64.if.i ]
  %10 = shl nuw nsw i64 %lsr.iv309, 3
  %scevgep10 = getelementptr i8, ptr %scevgep313, i64 %10
  %scevgep9 = getelementptr i8, ptr %scevgep10, i64 -64
  %.307.i = load <8 x double>, ptr %scevgep9, align 8, !noalias !71
  %scevgep311 = getelementptr i8, ptr %lsr.iv2.i, i64 %lsr.iv309
  %scevgep312 = getelementptr i8, ptr %scevgep311, i64 8
  %.318.i = load double, ptr %scevgep311, align 8, !noalias !71
  %.320.i = insertelement <8 x double> poison, double %.318.i, i64 0
  %.321.i = shufflevector <8 x double> %.320.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.322.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.307.i, <8 x double> %.321.i, <8 x double> %even.2.1163.i)
  %.336.i = load <8 x double>, ptr %scevgep10, align 8, !noalias !71
  %.348.i = load double, ptr %scevgep312, align 8, !noalias !71
  %.350.i = insertelement <8 x double> poison, double %.348.i, i64 0
  %.351.i = shufflevector <8 x double> %.350.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.352.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.336.i, <8 x double> %.351.i, <8 x double> %odd.2.1162.i)
  %lsr.iv.next310 = add nuw nsw i64 %lsr.iv309, 16
  %lsr.iv.next7 = add nsw i64 %lsr.iv6, -1
  %.259.i = icmp samesign ugt i64 %lsr.iv6, 7
  br i1 %.259.i, label %B172.if.i, label %B424.i

B34.if.lr.ph.i76:                                 ; preds = %B424.i
  %11 = getelementptr double, ptr %arg.cubics.1.4, i64 %arg.stride
  %.idx.i77 = shl i64 %arg.stride, 4
  %12 = getelementptr i8, ptr %arg.cubics.1.4, i64 %.idx.i77
  %.idx161.i78 = mul i64 %arg.stride, 24
  %13 = getelementptr i8, ptr %arg.cubics.1.4, i64 %.idx161.i78
  br label %B34.if.i79

B34.if.i79:                                       ; preds = %B34.if.i79, %B34.if.lr.ph.i76
  %lsr.iv4.i80 = phi i64 [ %.158, %B34.if.lr.ph.i76 ], [ %lsr.iv.next5.i112, %B34.if.i79 ]
  %lsr.iv.i81 = phi i64 [ 0, %B34.if.lr.ph.i76 ], [ %lsr.iv.next.i111, %B34.if.i79 ]
  %scevgep3.i82 = getelementptr i8, ptr %.463, i64 %lsr.iv.i81
  %.205.i83 = load i64, ptr %scevgep3.i82, align 8, !noalias !74
  %14 = shl i64 %lsr.iv.i81, 3
  %scevgep.i84 = getelementptr i8, ptr %.638, i64 %14
  %.216.i85 = load <8 x double>, ptr %scevgep.i84, align 8, !noalias !74
  %.224.i86 = getelementptr inbounds double, ptr %.927, i64 %.205.i83
  %.225.i87 = load double, ptr %.224.i86, align 8, !noalias !74
  %.6.i.i88 = insertelement <8 x double> poison, double %.225.i87, i64 0
  %.7.i.i89 = shufflevector <8 x double> %.6.i.i88, <8 x double> poison, <8 x i32> zeroinitializer
  %.8.i.i90 = fsub contract <8 x double> %.216.i85, %.7.i.i89
  %.257.i91 = getelementptr inbounds double, ptr %arg.cubics.1.4, i64 %.205.i83
  %.258.i92 = load double, ptr %.257.i91, align 8, !noalias !74
  %.268.i93 = getelementptr double, ptr %11, i64 %.205.i83
  %.269.i94 = load double, ptr %.268.i93, align 8, !noalias !74
  %.280.i95 = getelementptr double, ptr %12, i64 %.205.i83
  %.281.i96 = load double, ptr %.280.i95, align 8, !noalias !74
  %.292.i97 = getelementptr double, ptr %13, i64 %.205.i83
  %.293.i98 = load double, ptr %.292.i97, align 8, !noalias !74
  %.295.i99 = insertelement <8 x double> poison, double %.293.i98, i64 0
  %.296.i100 = shufflevector <8 x double> %.295.i99, <8 x double> poison, <8 x i32> zeroinitializer
  %.297.i101 = insertelement <8 x double> poison, double %.281.i96, i64 0
  %.298.i102 = shufflevector <8 x double> %.297.i101, <8 x double> poison, <8 x i32> zeroinitializer
  %.299.i103 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i.i90, <8 x double> %.296.i100, <8 x double> %.298.i102)
  %.300.i104 = insertelement <8 x double> poison, double %.269.i94, i64 0
  %.301.i105 = shufflevector <8 x double> %.300.i104, <8 x double> poison, <8 x i32> zeroinitializer
  %.302.i106 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i.i90, <8 x double> %.299.i103, <8 x double> %.301.i105)
  %.303.i107 = insertelement <8 x double> poison, double %.258.i92, i64 0
  %.304.i108 = shufflevector <8 x double> %.303.i107, <8 x double> poison, <8 x i32> zeroinitializer
  %.305.i109 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i.i90, <8 x double> %.302.i106, <8 x double> %.304.i108)
  %scevgep5 = getelementptr i8, ptr %arg.work.4, i64 %14
  store <8 x double> %.305.i109, ptr %scevgep5, align 8, !noalias !74
  %lsr.iv.next.i111 = add nuw i64 %lsr.iv.i81, 8
  %lsr.iv.next5.i112 = add i64 %lsr.iv4.i80, -1
  %exitcond.not.i113 = icmp eq i64 %lsr.iv.next5.i112, 0
  br i1 %exitcond.not.i113, label %_ZN17bnserve_surrogate6kernel7_points15spline_at_nodesB4v168B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE.exit114, label %B34.if.i79

_ZN17bnserve_surrogate6kernel7_points15spline_at_nodesB4v168B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE.exit114: ; preds = %B34.if.i79, %B0.endif.endif.endif.endi...endif.2.endif.endif
  %.1695.idx = mul i64 %.158, 192
  %.1695 = getelementptr i8, ptr %.577, i64 %.1695.idx
  %.1167.i = and i64 %.158, 2305843009213693951
  %.1189570.not574.i = icmp eq i64 %.1167.i, 0
  %.1189570.not.i = or i1 %5, %.1189570.not574.i
  br i1 %.1189570.not.i, label %B0.endif.endif.endif.endi...endif.4.endif.endif.endif, label %B484.if.lr.ph.i

B484.if.lr.ph.i:                                  ; preds = %_ZN17bnserve_surrogate6kernel7_points15spline_at_nodesB4v168B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE.exit114
  %.1626 = getelementptr inbounds nuw i8, ptr %arg.series.4, i64 192
  %.1562 = getelementptr inbounds nuw i8, ptr %arg.series.4, i64 64
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
  %.752.i = load double, ptr %.1626, align 8, !noalias !77
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
  %.257.i130 = load double, ptr %.256.i, align 8, !noalias !77
  %.227.i = getelementptr i8, ptr %arg.series.4, i64 88
  %.228.i = load double, ptr %.227.i, align 8, !noalias !77
  %.198.i = getelementptr i8, ptr %arg.series.4, i64 80
  %.199.i = load double, ptr %.198.i, align 8, !noalias !77
  %.169.i = getelementptr i8, ptr %arg.series.4, i64 72
  %.170.i = load double, ptr %.169.i, align 8, !noalias !77
  %.141.i = load double, ptr %.1562, align 8, !noalias !77
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
  %.1315.i = insertelement <8 x double> poison, double %.257.i130, i64 0
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
  %15 = add nuw nsw i64 %.1167.i, 6
  br label %B484.if.i

B484.if.i:                                        ; preds = %B484.if.i, %B484.if.lr.ph.i
  %lsr.iv3 = phi i64 [ %lsr.iv.next4, %B484.if.i ], [ %15, %B484.if.lr.ph.i ]
  %lsr.iv20.i = phi i64 [ %lsr.iv.next21.i, %B484.if.i ], [ 0, %B484.if.lr.ph.i ]
  %scevgep26.i = getelementptr i8, ptr %.700, i64 %lsr.iv20.i
  %.1236.i = load <8 x double>, ptr %scevgep26.i, align 8, !noalias !77
  %scevgep25.i = getelementptr i8, ptr %.577, i64 %lsr.iv20.i
  %.1246.i = load <8 x double>, ptr %scevgep25.i, align 8, !noalias !77
  %scevgep24.i = getelementptr i8, ptr %.638, i64 %lsr.iv20.i
  %.1256.i = load <8 x double>, ptr %scevgep24.i, align 8, !noalias !77
  %.6.i.i132 = fmul contract <8 x double> %.1236.i, %.1236.i
  %.1287.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i132, <8 x double> %.1283.i, <8 x double> %.1286.i)
  %.1291.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i132, <8 x double> %.1287.i, <8 x double> %.1290.i)
  %.1295.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i132, <8 x double> %.1291.i, <8 x double> %.1294.i)
  %.1302.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i132, <8 x double> %.1298.i, <8 x double> %.1301.i)
  %.1306.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i132, <8 x double> %.1302.i, <8 x double> %.1305.i)
  %.1310.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i132, <8 x double> %.1306.i, <8 x double> %.1309.i)
  %.1317.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i132, <8 x double> %.1313.i, <8 x double> %.1316.i)
  %.1321.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i132, <8 x double> %.1317.i, <8 x double> %.1320.i)
  %.1325.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i132, <8 x double> %.1321.i, <8 x double> %.1324.i)
  %.1332.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i132, <8 x double> %.1328.i, <8 x double> %.1331.i)
  %.1336.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i132, <8 x double> %.1332.i, <8 x double> %.1335.i)
  %.1340.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i132, <8 x double> %.1336.i, <8 x double> %.1339.i)
  %.1347.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i132, <8 x double> %.1343.i, <8 x double> %.1346.i)
  %.1351.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i132, <8 x double> %.1347.i, <8 x double> %.1350.i)
  %.1355.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i132, <8 x double> %.1351.i, <8 x double> %.1354.i)
  %.1362.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i132, <8 x double> %.1358.i, <8 x double> %.1361.i)
  %.1366.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i132, <8 x double> %.1362.i, <8 x double> %.1365.i)
  %.1367.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1236.i, <8 x double> %.1340.i, <8 x double> %.1325.i)
  %scevgep23.i = getelementptr i8, ptr %.1695, i64 %lsr.iv20.i
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
  %scevgep.i133 = getelementptr i8, ptr %.831, i64 %lsr.iv20.i
  store <8 x double> %.6.i19.i, ptr %scevgep.i133, align 8, !noalias !77
  %lsr.iv.next21.i = add i64 %lsr.iv20.i, 64
  %lsr.iv.next4 = add nsw i64 %lsr.iv3, -1
  %.1189.i = icmp sgt i64 %lsr.iv3, 7
  br i1 %.1189.i, label %B484.if.i, label %B64.if.i136.preheader

B0.endif.endif.endif.endi...endif.4.endif.endif.endif: ; preds = %_ZN17bnserve_surrogate6kernel7_points15spline_at_nodesB4v168B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE.exit114
  br i1 %5, label %B0.endif.endif.endif.endi...endif.5, label %B64.if.i136.preheader

B64.if.i136.preheader:                            ; preds = %B484.if.i, %B0.endif.endif.endif.endi...endif.4.endif.endif.endif
  br label %B64.if.i136

B424.i162:                                        ; preds = %B172.if.i140
  %.138.i163 = add nsw i64 %.128167175.i138, -1
  %.142.i164 = add i64 %.135168174.i139, 8
  %.6.i.i165 = fadd contract <8 x double> %.322.i153, %.352.i158
  %.398.i166 = getelementptr inbounds double, ptr %arg.polynomials_p.4, i64 %.135168174.i139
  store <8 x double> %.6.i.i165, ptr %.398.i166, align 8, !noalias !80
  %scevgep.i167 = getelementptr i8, ptr %lsr.iv2.i137, i64 64
  %.129.i168 = icmp sgt i64 %.128167175.i138, 1
  br i1 %.129.i168, label %B64.if.i136, label %B0.endif.endif.endif.endi...endif.5

B64.if.i136:                                      ; preds = %B64.if.i136.preheader, %B424.i162
  %lsr.iv2.i137 = phi ptr [ %scevgep.i167, %B424.i162 ], [ %.831, %B64.if.i136.preheader ]
  %.128167175.i138 = phi i64 [ %.138.i163, %B424.i162 ], [ %.158, %B64.if.i136.preheader ]
  %.135168174.i139 = phi i64 [ %.142.i164, %B424.i162 ], [ 0, %B64.if.i136.preheader ]
  br label %B172.if.i140

B172.if.i140:                                     ; preds = %B172.if.i140, %B64.if.i136
  %lsr.iv = phi i64 [ %lsr.iv.next, %B172.if.i140 ], [ 10, %B64.if.i136 ]
  %lsr.iv3.i141 = phi i64 [ %lsr.iv.next4.i160, %B172.if.i140 ], [ 8, %B64.if.i136 ]
  %even.2.1163.i143 = phi <8 x double> [ %.322.i153, %B172.if.i140 ], [ zeroinitializer, %B64.if.i136 ]
  %odd.2.1162.i144 = phi <8 x double> [ %.352.i158, %B172.if.i140 ], [ zeroinitializer, %B64.if.i136 ]
  %16 = shl nuw nsw i64 %lsr.iv3.i141, 3
  %scevgep2 = getelementptr i8, ptr %.508, i64 %16
  %scevgep1 = getelementptr i8, ptr %scevgep2, i64 -64
  %.307.i147 = load <8 x double>, ptr %scevgep1, align 8, !noalias !80
  %scevgep6.i148 = getelementptr i8, ptr %lsr.iv2.i137, i64 %lsr.iv3.i141
  %scevgep7.i149 = getelementptr i8, ptr %scevgep6.i148, i64 -8
  %.318.i150 = load double, ptr %scevgep7.i149, align 8, !noalias !80
  %.320.i151 = insertelement <8 x double> poison, double %.318.i150, i64 0
  %.321.i152 = shufflevector <8 x double> %.320.i151, <8 x double> poison, <8 x i32> zeroinitializer
  %.322.i153 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.307.i147, <8 x double> %.321.i152, <8 x double> %even.2.1163.i143)
  %.336.i154 = load <8 x double>, ptr %scevgep2, align 8, !noalias !80
  %.348.i155 = load double, ptr %scevgep6.i148, align 8, !noalias !80
  %.350.i156 = insertelement <8 x double> poison, double %.348.i155, i64 0
  %.351.i157 = shufflevector <8 x double> %.350.i156, <8 x double> poison, <8 x i32> zeroinitializer
  %.352.i158 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.336.i154, <8 x double> %.351.i157, <8 x double> %odd.2.1162.i144)
  %lsr.iv.next4.i160 = add nuw nsw i64 %lsr.iv3.i141, 16
  %lsr.iv.next = add nsw i64 %lsr.iv, -1
  %.259.i161 = icmp samesign ugt i64 %lsr.iv, 7
  br i1 %.259.i161, label %B172.if.i140, label %B424.i162

B0.endif.endif.endif.endi...endif.5:              ; preds = %B424.i162, %B0.endif.endif.endif.endi...endif.4.endif.endif.endif
  store ptr null, ptr %retptr, align 8
  br label %common.ret
}

; Function Attrs: nofree noinline norecurse nosync nounwind memory(argmem: readwrite)
define internal fastcc noundef range(i32 0, 2) i32 @inner_9(ptr noalias nonnull writeonly captures(none) %retptr, ptr noalias nonnull writeonly captures(none) %excinfo, ptr readonly captures(none) %arg.row.4, double %arg.unit, ptr readonly captures(none) %arg.band.4, ptr readonly captures(none) %arg.gauge.4, i64 %arg.alignment, ptr initializes((0, 384)) %arg.room.4, ptr writeonly captures(none) initializes((0, 64)) %arg.out.4) unnamed_addr #7 {
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
  %.318.le = tail call contract double @llvm.log.f64(double %.306)
  %.5.i = fadd contract double %.107, 1.000000e+00
  %.147.i.i9 = fmul contract double %.5.i, %.5.i
  %.35.i = fdiv contract double %.107, %.147.i.i9
  %.351 = fmul contract double %.35.i, 0x3AD23C9F83511538
  %.354 = fmul contract double %.206, %.206
  %.355 = fmul contract double %.354, %.351
  %.384 = getelementptr i8, ptr %arg.row.4, i64 40
  %.385 = load double, ptr %.384, align 8
  %.389 = fdiv contract double %.355, %.385
  %.54.i = fsub contract double %.137, %.167
  %.147.i.i1 = fmul contract double %.54.i, %.54.i
  %.45.i = fadd contract double %.107, -1.000000e+00
  %.50.i = fdiv contract double %.45.i, %.5.i
  %.51.i = fadd contract double %.137, %.167
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
  %.362.i2 = fadd contract double %.361.i, %.273.i
  store double %.362.i2, ptr %.236.i, align 8, !noalias !83
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
  %.39.i = fdiv contract double 0x3FE4F1A6C638D03F, %.35.i
  %.47.i = tail call contract double @sqrt(double %.39.i)
  %.449 = fmul contract double %.389, %.47.i
  %.452 = fmul contract double %.306, %.306
  %.454 = fmul contract double %.306, %.452
  %.463 = tail call contract double @sqrt(double %.306)
  %.468 = fmul contract double %.454, %.463
  %.472 = fdiv contract double %.449, %.468
  store double %.472, ptr %arg.out.4, align 8
  %.657 = fmul contract double %.306, %.472
  %.624.1 = fmul contract double %.657, 0.000000e+00
  store double %.624.1, ptr %.138.i, align 8
  %.657.1 = fmul contract double %.306, %.657
  %.624.2 = fmul contract double %.141.i, %.657.1
  store double %.624.2, ptr %.169.i, align 8
  %.657.2 = fmul contract double %.306, %.657.1
  %.624.3 = fmul contract double %.175.i, %.657.2
  store double %.624.3, ptr %.203.i, align 8
  %.657.3 = fmul contract double %.306, %.657.2
  %.624.4 = fmul contract double %.362.i2, %.657.3
  store double %.624.4, ptr %.236.i, align 8
  %.657.4 = fmul contract double %.306, %.657.3
  %.624.5 = fmul contract double %.463.i, %.657.4
  store double %.624.5, ptr %.427.i, align 8
  %.657.5 = fmul contract double %.306, %.657.4
  %.624.6 = fmul contract double %.886.i, %.657.5
  store double %.624.6, ptr %.548.i, align 8
  %.657.6 = fmul contract double %.306, %.657.5
  %.624.7 = fmul contract double %.920.i, %.657.6
  store double %.624.7, ptr %.948.i, align 8
  %.695 = getelementptr i8, ptr %arg.row.4, i64 8
  %.696 = load double, ptr %.695, align 8
  %.725 = getelementptr i8, ptr %arg.row.4, i64 16
  %.726 = load double, ptr %.725, align 8
  tail call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(384) %arg.room.4, i8 0, i64 384, i1 false), !noalias !86
  %.33.i = fdiv contract double %.107, %.5.i
  %.38.i = fdiv contract double 1.000000e+00, %.5.i
  %.39.i3 = fmul contract double %.33.i, %.38.i
  store double 1.000000e+00, ptr %arg.room.4, align 8, !noalias !89
  %.183.i.i = getelementptr i8, ptr %arg.room.4, i64 16
  %.203.i.i = fmul contract double %.39.i3, 0x401871C71C71C71C
  %.204.i.i = fadd contract double %.203.i.i, 0x4013A7F529FD4A7F
  store double %.204.i.i, ptr %.183.i.i, align 8, !noalias !89
  %.308.i.i = getelementptr i8, ptr %arg.room.4, i64 24
  %.309.i.i = load double, ptr %.308.i.i, align 8, !noalias !89
  %.310.i.i = fadd contract double %.309.i.i, 0xC04921FB54442D18
  store double %.310.i.i, ptr %.308.i.i, align 8, !noalias !89
  %.413.i.i = getelementptr i8, ptr %arg.room.4, i64 32
  %.414.i.i = load double, ptr %.413.i.i, align 8, !noalias !89
  %.454.i2.i = fmul contract double %.39.i3, 0x40456C71C71C71C7
  %.455.i3.i = fadd contract double %.454.i2.i, 0x404AEDF7DF7DF7DF
  %.456.i4.i = fmul contract double %.39.i3, %.455.i3.i
  %.457.i.i = fadd contract double %.456.i4.i, 0x403E1A683B5702A5
  %.458.i.i = fadd contract double %.457.i.i, %.414.i.i
  store double %.458.i.i, ptr %.413.i.i, align 8, !noalias !89
  %.561.i.i = getelementptr i8, ptr %arg.room.4, i64 168
  %.562.i.i = load double, ptr %.561.i.i, align 8, !noalias !89
  %.581.i.i = fmul contract double %.39.i3, 0x40510457810E2933
  %1 = fsub contract double 0x407E1C5F0E074C89, %.581.i.i
  %.583.i.i = fadd contract double %1, %.562.i.i
  store double %.583.i.i, ptr %.561.i.i, align 8, !noalias !89
  %.686.i.i = getelementptr i8, ptr %arg.room.4, i64 48
  %.687.i.i = load double, ptr %.686.i.i, align 8, !noalias !89
  %.756.i.i = fmul contract double %.39.i3, 0x4058A8587E6B74F0
  %2 = fsub contract double 0x404601B425ED097B, %.756.i.i
  %.758.i.i = fmul contract double %.39.i3, %2
  %.759.i.i = fadd contract double %.758.i.i, 0xC0A9D8A41ED3317E
  %.760.i.i = fmul contract double %.39.i3, %.759.i.i
  %.761.i.i = fadd contract double %.760.i.i, 0xC071640B49E85C3E
  %.762.i.i = fadd contract double %.761.i.i, %.687.i.i
  store double %.762.i.i, ptr %.686.i.i, align 8, !noalias !89
  %.865.i.i = getelementptr i8, ptr %arg.room.4, i64 176
  %.866.i.i = load double, ptr %.865.i.i, align 8, !noalias !89
  %.867.i.i = fadd contract double %.866.i.i, 0xC074618618618618
  store double %.867.i.i, ptr %.865.i.i, align 8, !noalias !89
  %.970.i.i = getelementptr i8, ptr %arg.room.4, i64 56
  %.971.i.i = load double, ptr %.970.i.i, align 8, !noalias !89
  %.1011.i.i = fmul contract double %.39.i3, 0x40733B288412FE12
  %3 = fsub contract double 0x408893BEE8443B83, %.1011.i.i
  %.1013.i.i = fmul contract double %.39.i3, %3
  %.1014.i.i = fadd contract double %.1013.i.i, 0x408DCC10DD757C0B
  %.1015.i.i = fadd contract double %.1014.i.i, %.971.i.i
  store double %.1015.i.i, ptr %.970.i.i, align 8, !noalias !89
  %.1118.i.i = getelementptr i8, ptr %arg.room.4, i64 192
  %.1119.i.i = load double, ptr %.1118.i.i, align 8, !noalias !89
  %.1225.i.i = fmul contract double %.39.i3, 0x40514C5F3B7242FB
  %.1226.i.i = fadd contract double %.1225.i.i, 0xC05D2FBB067D39F9
  %.1227.i.i = fmul contract double %.39.i3, %.1226.i.i
  %.1228.i.i = fadd contract double %.1227.i.i, 0xC091A4640F04B974
  %.1229.i.i = fmul contract double %.39.i3, %.1228.i.i
  %.1230.i.i = fadd contract double %.1229.i.i, 0x40CE3F8117DB38CA
  %.1231.i.i = fmul contract double %.39.i3, %.1230.i.i
  %.1232.i.i = fadd contract double %.1231.i.i, 0xC0A8D75E6BF57F9D
  %.1233.i.i = fadd contract double %.1232.i.i, %.1119.i.i
  store double %.1233.i.i, ptr %.1118.i.i, align 8, !noalias !89
  %.1336.i.i = getelementptr i8, ptr %arg.room.4, i64 320
  %.1337.i.i = load double, ptr %.1336.i.i, align 8, !noalias !89
  %.1356.i.i = fmul contract double %.39.i3, 0x409F6EC11CD4D97E
  %.1357.i.i = fadd contract double %.1356.i.i, 0x4072428A28A28A29
  %.1358.i.i = fadd contract double %.1357.i.i, %.1337.i.i
  store double %.1358.i.i, ptr %.1336.i.i, align 8, !noalias !89
  %.1461.i.i = getelementptr i8, ptr %arg.room.4, i64 72
  %.1462.i.i = load double, ptr %.1461.i.i, align 8, !noalias !89
  %.1531.i.i = fmul contract double %.39.i3, 0x40645019F9E83A77
  %.1532.i.i = fadd contract double %.1531.i.i, 0x40918164C0B5D6FD
  %.1533.i.i = fmul contract double %.39.i3, %.1532.i.i
  %.1534.i.i = fadd contract double %.1533.i.i, 0xC0D6C519D7F78519
  %.1535.i.i = fmul contract double %.39.i3, %.1534.i.i
  %.1536.i.i = fadd contract double %.1535.i.i, 0x40BB4B9C657BC796
  %.1537.i.i = fadd contract double %.1536.i.i, %.1462.i.i
  store double %.1537.i.i, ptr %.1461.i.i, align 8, !noalias !89
  %.1640.i.i = getelementptr i8, ptr %arg.room.4, i64 200
  %.1641.i.i = load double, ptr %.1640.i.i, align 8, !noalias !89
  %.1642.i.i = fadd contract double %.1641.i.i, 0xC0A001D567F49087
  store double %.1642.i.i, ptr %.1640.i.i, align 8, !noalias !89
  %.1810.i.i = fmul contract double %.39.i3, 0x40A619E547AE6DA3
  %.1811.i.i = fadd contract double %.1810.i.i, 0xC0D25E7665446D0F
  %.1812.i.i = fmul contract double %.39.i3, %.1811.i.i
  %.1813.i.i = fadd contract double %.1812.i.i, 0x40E19BDA5330D73F
  %.1814.i.i = fmul contract double %.39.i3, %.1813.i.i
  %.1815.i.i = fadd contract double %.1814.i.i, 0xC0E154650FD9ACF1
  %.1867.i.i = getelementptr i8, ptr %arg.room.4, i64 80
  %.1868.i.i = load double, ptr %.1867.i.i, align 8, !noalias !89
  %.1956.i.i = fmul contract double %.39.i3, %.1815.i.i
  %.1957.i.i = fadd contract double %.1956.i.i, 0xC0F5A16228D9F21A
  %.1958.i.i = fmul contract double %.39.i3, %.1957.i.i
  %.1959.i.i = fadd contract double %.1958.i.i, 0x40ECE30547C08F3B
  %.1960.i.i = fmul contract double %.39.i3, %.1959.i.i
  %.1961.i.i = fadd contract double %.1960.i.i, 0xC0C172813AB99F84
  %.1962.i.i = fmul contract double %.39.i3, 3.000000e+00
  %.1963.i.i = fsub contract double 1.000000e+00, %.1962.i.i
  %.1967.i.i = fdiv contract double %.1961.i.i, %.1963.i.i
  %.1968.i.i = fadd contract double %.1967.i.i, %.1868.i.i
  store double %.1968.i.i, ptr %.1867.i.i, align 8, !noalias !89
  %.2088.i.i = fmul contract double %.39.i3, 0x40C0712C540DB5CD
  %.2089.i.i = fadd contract double %.2088.i.i, 0x40A79A477BF30A91
  %.2090.i.i = fmul contract double %.39.i3, %.2089.i.i
  %.2091.i.i = fadd contract double %.2090.i.i, 0xC0A4B055B758E414
  %.2092.i.i = fmul contract double %.39.i3, %.2091.i.i
  %.2093.i.i = fadd contract double %.2092.i.i, 0x406D67FD70A13797
  %.2145.i.i = getelementptr i8, ptr %arg.room.4, i64 208
  %.2146.i.i = load double, ptr %.2145.i.i, align 8, !noalias !89
  %.2152.i.i = fdiv contract double %.2093.i.i, %.1963.i.i
  %.2153.i.i = fadd contract double %.2152.i.i, %.2146.i.i
  store double %.2153.i.i, ptr %.2145.i.i, align 8, !noalias !89
  %.2256.i.i = getelementptr i8, ptr %arg.room.4, i64 88
  %.2257.i.i = load double, ptr %.2256.i.i, align 8, !noalias !89
  %.2363.i.i = fmul contract double %.39.i3, 0x402CA90C106318D7
  %.2364.i.i = fadd contract double %.2363.i.i, 0xC06030460C29F3DF
  %.2365.i.i = fmul contract double %.39.i3, %.2364.i.i
  %.2366.i.i = fadd contract double %.2365.i.i, 0x40D015D04F4BC5D2
  %.2367.i.i = fmul contract double %.39.i3, %.2366.i.i
  %.2368.i.i = fadd contract double %.2367.i.i, 0xC0E536054A2E10AB
  %.2369.i.i = fmul contract double %.39.i3, %.2368.i.i
  %.2370.i.i = fadd contract double %.2369.i.i, 0x40C95DBCC2240A74
  %.2371.i.i = fadd contract double %.2370.i.i, %.2257.i.i
  store double %.2371.i.i, ptr %.2256.i.i, align 8, !noalias !89
  %.2474.i.i = getelementptr i8, ptr %arg.room.4, i64 216
  %.2475.i.i = load double, ptr %.2474.i.i, align 8, !noalias !89
  %.2494.i.i = fmul contract double %.39.i3, 0x40BD257CD0AE1310
  %4 = fsub contract double 0xC09600901EF7C9A4, %.2494.i.i
  %.2496.i.i = fadd contract double %4, %.2475.i.i
  store double %.2496.i.i, ptr %.2474.i.i, align 8, !noalias !89
  %.24.i.i = fsub contract double 1.000000e+00, %.33.i
  %.25.i.i = fmul contract double %.33.i, %.24.i.i
  %.26.i.i = fmul contract double %.137, %.33.i
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
  %.26.i9.i = fmul contract double %.38.i, %.167
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
  %.15.le.i.i = fcmp contract uno double %.696, 0.000000e+00
  %.17.le.i.i = fcmp contract oge double %.696, 1.000000e+00
  %8 = or i1 %.15.le.i.i, %.17.le.i.i
  %9 = tail call contract double @llvm.log.f64(double %.696)
  %.31.le.i.i = select i1 %8, double %9, double 0.000000e+00
  %.36.i.i = fmul contract double %.31.le.i.i, 1.230000e-04
  %.37.i.i = fadd contract double %.36.i.i, -4.210000e-03
  %.38.i.i = fmul contract double %.31.le.i.i, %.37.i.i
  %.39.i.i = fadd contract double %.38.i.i, 4.740000e-02
  %.40.i.i = fmul contract double %.31.le.i.i, %.39.i.i
  %.41.i.i = fadd contract double %.40.i.i, 9.360000e-02
  %.42.i.i = fmul contract double %.31.le.i.i, %.41.i.i
  %.43.i.i = fadd contract double %.42.i.i, 1.940000e-01
  %.44.i.i = fcmp contract ogt double %.696, 1.000000e+00
  %.46.i.i = uitofp i1 %.44.i.i to double
  %.47.i.i = fmul contract double %.43.i.i, %.46.i.i
  %.55.le.i.i = tail call contract double @llvm.exp.f64(double %.47.i.i)
  %.147.i.i.i4 = fmul contract double %.26.i.i, %.26.i.i
  %.106.i.i = fmul contract double %.55.le.i.i, 5.000000e+01
  %.107.i.i = fadd contract double %.106.i.i, 6.250000e-01
  %10 = fmul contract double %.147.i.i.i4, %.107.i.i
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
  %.224.i.i = fmul contract double %.147.i.i.i4, %.223.i.i
  %.225.i.i = fadd contract double %.305.i32.i, %.224.i.i
  store double %.225.i.i, ptr %.686.i.i, align 8, !noalias !98
  %.331.i.i = fmul contract double %.147.i.i.i4, 0x4093A28C59D5433B
  %.332.i.i = fmul contract double %.331.i.i, %.55.le.i.i
  %11 = fsub contract double %.424.i49.i, %.332.i.i
  store double %11, ptr %.970.i.i, align 8, !noalias !98
  %.15.le.i51.i = fcmp contract uno double %.726, 0.000000e+00
  %.17.le.i52.i = fcmp contract oge double %.726, 1.000000e+00
  %12 = or i1 %.15.le.i51.i, %.17.le.i52.i
  %13 = tail call contract double @llvm.log.f64(double %.726)
  %.31.le.i53.i = select i1 %12, double %13, double 0.000000e+00
  %.36.i54.i = fmul contract double %.31.le.i53.i, 1.230000e-04
  %.37.i55.i = fadd contract double %.36.i54.i, -4.210000e-03
  %.38.i56.i = fmul contract double %.31.le.i53.i, %.37.i55.i
  %.39.i57.i = fadd contract double %.38.i56.i, 4.740000e-02
  %.40.i58.i = fmul contract double %.31.le.i53.i, %.39.i57.i
  %.41.i59.i = fadd contract double %.40.i58.i, 9.360000e-02
  %.42.i60.i = fmul contract double %.31.le.i53.i, %.41.i59.i
  %.43.i61.i = fadd contract double %.42.i60.i, 1.940000e-01
  %.44.i62.i = fcmp contract ogt double %.726, 1.000000e+00
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
  %.27.i.i = fmul contract double %.137, %.25.i.i
  %.28.i.i = fmul contract double %.167, %.27.i.i
  %.82.i95.i = fmul contract double %.28.i.i, 9.875000e+01
  %16 = fsub contract double %.109.i72.i, %.82.i95.i
  store double %16, ptr %.413.i.i, align 8, !noalias !104
  %.188.i98.i = fmul contract double %.25.i.i, 0x40735B8E38E38E39
  %.189.i99.i = fadd contract double %.188.i98.i, 0x40723BDB6DB6DB6E
  %.190.i100.i = fmul contract double %.28.i.i, %.189.i99.i
  %.191.i101.i = fadd contract double %.190.i100.i, %.225.i86.i
  store double %.191.i101.i, ptr %.686.i.i, align 8, !noalias !104
  %.245.i.i = fmul contract double %.167, %.24.i.i
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
  %.51.i.i = fmul contract double %.50.i.i, %.696
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
  %.455.i.i = fmul contract double %.454.i.i, %.448.i.i
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
  %.51.i129.i = fmul contract double %.50.i128.i, %.726
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
  %.455.i166.i = fmul contract double %.454.i165.i, %.448.i159.i
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
  %.671.i5 = fmul contract double %.39.i3, 1.280000e+02
  %.675.i = fdiv contract double 3.000000e+00, %.671.i5
  store double %.675.i, ptr %arg.room.4, align 8, !noalias !86
  %18 = getelementptr i8, ptr %arg.room.4, i64 8
  %.968.1.i = load double, ptr %18, align 8, !noalias !86
  %.970.1.i = fmul contract double %.675.i, %.968.1.i
  store double %.970.1.i, ptr %18, align 8, !noalias !86
  %.970.2.i = fmul contract double %.675.i, %.204.i.i
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
  %.904 = getelementptr i8, ptr %arg.out.4, i64 64
  %.1137 = fmul contract double %.306, %.454
  %.1139 = fmul contract double %.306, %.1137
  %.1143 = fdiv contract double 1.000000e+00, %.1139
  %.1539 = fmul contract double %.318.le, 2.000000e+00
  br label %B852.if

B970:                                             ; preds = %B852.if
  %.1537 = load double, ptr %sunkaddr41, align 8
  %.1594 = load double, ptr %sunkaddr44, align 8
  %.1595 = fmul contract double %.1539, %.1594
  %.1596 = fadd contract double %.1537, %.1595
  %.1598 = fmul contract double %power.1.2.0758, %.1596
  %.1602 = fdiv contract double %.1598, 3.000000e+00
  %sunkaddr25 = getelementptr i8, ptr %arg.out.4, i64 %sunkaddr36
  %sunkaddr26 = getelementptr i8, ptr %sunkaddr25, i64 152
  store double %.1602, ptr %sunkaddr26, align 8
  br label %B1054

B1054:                                            ; preds = %B852.if, %B970
  %.1647 = fmul contract double %.306, %power.1.2.0758
  %exitcond.not = icmp eq i64 %.1239, 16
  br i1 %exitcond.not, label %B1066, label %B852.if

B1066:                                            ; preds = %B1054
  %.1721 = load double, ptr %.1336.i.i, align 8
  %.1722 = fmul contract double %.305, %.1721
  %.1726 = fdiv contract double %.1722, 9.000000e+00
  %sunkaddr22 = getelementptr i8, ptr %arg.out.4, i64 248
  store double %.1726, ptr %sunkaddr22, align 8
  %.1785 = getelementptr i8, ptr %arg.row.4, i64 64
  %.1786 = load double, ptr %.1785, align 8
  %45 = lshr i64 %arg.alignment, 61
  %.1803 = and i64 %45, 4
  %.idx = shl i64 %arg.alignment, 4
  %46 = getelementptr i8, ptr %arg.gauge.4, i64 %.idx
  %.1817 = getelementptr double, ptr %46, i64 %.1803
  %.1818 = load double, ptr %.1817, align 8
  %.1819 = fsub contract double %.1786, %.1818
  %sunkaddr24 = getelementptr i8, ptr %arg.out.4, i64 256
  store double %.1819, ptr %sunkaddr24, align 8
  %.1851 = icmp eq i64 %arg.alignment, 1
  br i1 %.1851, label %B1204, label %B1300

B1204:                                            ; preds = %B1066
  %.1881 = getelementptr i8, ptr %arg.band.4, i64 16
  %.1882 = load double, ptr %.1881, align 8
  %.1883 = fcmp contract ogt double %.1882, 0.000000e+00
  br i1 %.1883, label %B1228, label %B1300

B1228:                                            ; preds = %B1204
  %.25.i = fmul contract double %.1882, 0x400921FB54442D18
  %.26.i = tail call contract double @llvm.pow.f64(double %.25.i, double 0x3FD5555555555555)
  %.147.i.i = fmul contract double %.26.i, %.26.i
  %.147.i.1.i = fmul contract double %.147.i.i, %.147.i.i
  %.127.i.2.i = fmul contract double %.26.i, %.147.i.1.i
  %.38.le.i = tail call contract double @llvm.log.f64(double %.26.i)
  %.168.i.i = fcmp une double %.127.i.2.i, 0.000000e+00
  br i1 %.168.i.i, label %B134.if.lr.ph.i, label %_ZN17bnserve_surrogate6kernel7_series9_legendreB4v166B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dEd5ArrayIdLi2E1C7mutable7alignedE.exit, !prof !0

B134.if.lr.ph.i:                                  ; preds = %B1228
  %.175.i.i = fdiv contract double 1.000000e+00, %.127.i.2.i
  %.423.i = fmul contract double %.38.le.i, 2.000000e+00
  br label %B134.if.i

B134.if.i:                                        ; preds = %B134.if.i, %B134.if.lr.ph.i
  %lsr.iv = phi i64 [ %math, %B134.if.i ], [ -16, %B134.if.lr.ph.i ]
  %power.2.0146.i = phi double [ %.493.i, %B134.if.i ], [ %.175.i.i, %B134.if.lr.ph.i ]
  %result.2.0145.i = phi double [ %.488.i, %B134.if.i ], [ 0.000000e+00, %B134.if.lr.ph.i ]
  %47 = add nsw i64 %lsr.iv, 11
  %sunkaddr27 = shl i64 %lsr.iv, 3
  %sunkaddr28 = getelementptr i8, ptr %arg.room.4, i64 %sunkaddr27
  %sunkaddr29 = getelementptr i8, ptr %sunkaddr28, i64 128
  %.249.i = load double, ptr %sunkaddr29, align 8, !noalias !113
  %sunkaddr32 = getelementptr i8, ptr %sunkaddr28, i64 256
  %.303.i = load double, ptr %sunkaddr32, align 8, !noalias !113
  %sunkaddr35 = getelementptr i8, ptr %sunkaddr28, i64 384
  %.357.i = load double, ptr %sunkaddr35, align 8, !noalias !113
  %.359.i = fmul contract double %.38.le.i, %.357.i
  %.360.i = fadd contract double %.303.i, %.359.i
  %.362.i = fmul contract double %.38.le.i, %.360.i
  %.363.i = fadd contract double %.249.i, %.362.i
  %.365.i = sitofp i64 %47 to double
  %.366.i = fmul contract double %.363.i, %.365.i
  %.421.i = fadd contract double %.303.i, %.366.i
  %.478.i = fmul contract double %.423.i, %.357.i
  %.479.i = fadd contract double %.478.i, %.421.i
  %.483.i = fdiv contract double %.479.i, 3.000000e+00
  %.484.i = fsub contract double %.363.i, %.483.i
  %.486.i = fmul contract double %power.2.0146.i, %.484.i
  %.488.i = fadd contract double %result.2.0145.i, %.486.i
  %.493.i = fmul contract double %.26.i, %power.2.0146.i
  %48 = tail call { i64, i1 } @llvm.uadd.with.overflow.i64(i64 %lsr.iv, i64 1)
  %math = extractvalue { i64, i1 } %48, 0
  %ov = extractvalue { i64, i1 } %48, 1
  br i1 %ov, label %_ZN17bnserve_surrogate6kernel7_series9_legendreB4v166B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dEd5ArrayIdLi2E1C7mutable7alignedE.exit, label %B134.if.i

_ZN17bnserve_surrogate6kernel7_series9_legendreB4v166B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dEd5ArrayIdLi2E1C7mutable7alignedE.exit: ; preds = %B134.if.i, %B1228
  %.1952.0 = phi double [ 0.000000e+00, %B1228 ], [ %.488.i, %B134.if.i ]
  %excinfo.6.0 = phi ptr [ @.const.picklebuf.b28008a0f88bad5ff0f0243e84dab90cab19b366, %B1228 ], [ null, %B134.if.i ]
  br i1 %.168.i.i, label %B1228.endif, label %B1228.if, !prof !0

B1300:                                            ; preds = %B1228.endif, %B1204, %B1066
  %.2060 = getelementptr i8, ptr %arg.row.4, i64 72
  %.2061 = load double, ptr %.2060, align 8
  %.2067 = fmul contract double %.2061, 0x401921FB54442D18
  %.2069 = fmul contract double %.206, 0x3ED4A8B4A9ED04E3
  %.2076 = fdiv contract double %arg.unit, %.2069
  %.2077 = fmul contract double %.2076, %.2067
  %49 = getelementptr i8, ptr %46, i64 8
  %.2111 = getelementptr double, ptr %49, i64 %.1803
  %.2112 = load double, ptr %.2111, align 8
  %.2119 = fmul contract double %arg.unit, %.2112
  %.2122 = fsub contract double %.2077, %.2119
  %sunkaddr37 = getelementptr i8, ptr %arg.out.4, i64 264
  store double %.2122, ptr %sunkaddr37, align 8
  %.2159 = fmul contract double %.389, 2.000000e+01
  store double %.2159, ptr %retptr, align 8
  br label %common.ret

common.ret:                                       ; preds = %B1228.if, %B1300
  %common.ret.op = phi i32 [ 0, %B1300 ], [ 1, %B1228.if ]
  ret i32 %common.ret.op

B852.if:                                          ; preds = %entry, %B1054
  %power.1.2.0758 = phi double [ %.1143, %entry ], [ %.1647, %B1054 ]
  %.1232754756 = phi i64 [ 0, %entry ], [ %.1239, %B1054 ]
  %.1239 = add nuw nsw i64 %.1232754756, 1
  %sunkaddr36 = shl i64 %.1232754756, 3
  %sunkaddr38 = getelementptr i8, ptr %arg.room.4, i64 %sunkaddr36
  %.1321 = load double, ptr %sunkaddr38, align 8
  %sunkaddr41 = getelementptr i8, ptr %sunkaddr38, i64 128
  %.1376 = load double, ptr %sunkaddr41, align 8
  %sunkaddr44 = getelementptr i8, ptr %sunkaddr38, i64 256
  %.1431 = load double, ptr %sunkaddr44, align 8
  %.1433 = fmul contract double %.318.le, %.1431
  %.1434 = fadd contract double %.1376, %.1433
  %.1436 = fmul contract double %.318.le, %.1434
  %.1437 = fadd contract double %.1321, %.1436
  %.1439 = fmul contract double %power.1.2.0758, %.1437
  %scevgep10 = getelementptr i8, ptr %.904, i64 %sunkaddr36
  store double %.1439, ptr %scevgep10, align 8
  %50 = add nsw i64 %.1232754756, -5
  %or.cond = icmp ult i64 %50, 7
  br i1 %or.cond, label %B970, label %B1054

B1228.if:                                         ; preds = %_ZN17bnserve_surrogate6kernel7_series9_legendreB4v166B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dEd5ArrayIdLi2E1C7mutable7alignedE.exit
  store ptr %excinfo.6.0, ptr %excinfo, align 8
  br label %common.ret

B1228.endif:                                      ; preds = %_ZN17bnserve_surrogate6kernel7_series9_legendreB4v166B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dEd5ArrayIdLi2E1C7mutable7alignedE.exit
  %.1987 = fadd contract double %.1819, %.1952.0
  store double %.1987, ptr %sunkaddr24, align 8
  br label %B1300
}

; Function Attrs: nofree noinline norecurse nosync nounwind memory(argmem: readwrite)
define internal fastcc void @inner_10(ptr noalias nonnull writeonly captures(none) %retptr, ptr readonly captures(none) %arg.f.4, ptr readonly captures(none) %arg.cbrt_f.4, ptr readonly captures(none) %arg.power.4, i64 range(i64 0, -9223372036854775808) %arg.segments.0, i64 range(i64 0, -9223372036854775808) %arg.segments.1, i64 range(i64 0, -7) %arg.segments.2, double %arg.mass, ptr readonly captures(none) %arg.c.4, double %arg.constant, ptr readonly captures(none) %arg.residuals.4, ptr writeonly captures(none) %arg.out.4) unnamed_addr #7 {
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
define internal fastcc void @inner_11(ptr noalias nonnull writeonly captures(none) %retptr, i64 %arg.i, i64 %arg.start, i64 %arg.inside, i64 range(i64 -9223372036854774784, -9223372036854775808) %arg.stop, ptr readonly captures(none) %arg.arguments.4, ptr readonly captures(none) %arg.amplitude.4, ptr readonly captures(none) %arg.phase.4, double %arg.factors.0, double %arg.factors.1, ptr captures(none) %arg.tail.4) unnamed_addr #5 {
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
  %.1274 = inttoptr i64 %.1272 to ptr
  %.1332 = add nsw i64 %.1270, %.167
  %.1334 = icmp eq i64 %.107, 2
  %"$phi1006.3.2.0" = select i1 %.1334, i64 %.1264, i64 0
  %.1359 = inttoptr i64 %.1332 to ptr
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
  store ptr null, ptr %.1475, align 8
  call fastcc void @inner_15(ptr nonnull %.1475, ptr %arg.amplitude.4, ptr %arg.phase.4, i64 %.1469, double %arg.factors.0, double %arg.factors.1, i64 %storemerge.i49, ptr %.1274, i64 %.1264, ptr %.1359, i64 %"$phi1006.3.2.0", ptr %arg.tail.4)
  %.1538 = shl nsw i64 %.1469, 1
  store ptr null, ptr %.1540, align 8
  call fastcc void @inner_16(ptr nonnull %.1540, ptr %.1274, i64 %.1264, ptr %.1359, i64 %"$phi1006.3.2.0", i64 %.1538)
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

B150:                                             ; preds = %B6091, %B150.preheader
  %j.2.0 = phi i64 [ %.1580, %B6091 ], [ 0, %B150.preheader ]
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
  br i1 %.882, label %B472, label %B5763

B472:                                             ; preds = %B150
  store <16 x float> %.899, ptr %arg.tail.4, align 4
  %.989841.not = icmp slt i64 %count.2.1, 1
  br i1 %.989841.not, label %B5875, label %B532.if.lr.ph

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
  br i1 %exitcond.not.1, label %B5875, label %B532.if.1

B5763:                                            ; preds = %B150
  %sunkaddr5 = shl i64 %j.2.0, 3
  %sunkaddr6 = getelementptr i8, ptr %arg.first.4, i64 %sunkaddr5
  br i1 %3, label %B5835, label %B5837

B5835:                                            ; preds = %B5763
  store <16 x float> %.899, ptr %sunkaddr6, align 64, !nontemporal !123
  br label %B5875

B5837:                                            ; preds = %B5763
  store <16 x float> %.899, ptr %sunkaddr6, align 4
  br label %B5875

B5875:                                            ; preds = %B472, %B532.if.lr.ph, %B532.if.1, %B532.if.2, %B532.if.3, %B532.if.4, %B532.if.5, %B532.if.6, %B5837, %B5835
  br i1 %0, label %B5879, label %B6091

B5879:                                            ; preds = %B5875
  %.8.i277 = fmul contract <8 x double> %.7.i, %.783
  %.8.i303 = fmul contract <8 x double> %.7.i302, %.756
  %13 = shufflevector <8 x double> %.8.i277, <8 x double> %.8.i303, <16 x i32> <i32 0, i32 8, i32 1, i32 9, i32 2, i32 10, i32 3, i32 11, i32 4, i32 12, i32 5, i32 13, i32 6, i32 14, i32 7, i32 15>
  %.1294 = fptrunc <16 x double> %13 to <16 x float>
  br i1 %.882, label %B5891, label %B6035

B5891:                                            ; preds = %B5879
  store <16 x float> %.1294, ptr %arg.tail.4, align 4
  %.1384847.not = icmp slt i64 %count.2.1, 1
  br i1 %.1384847.not, label %B6091, label %B5931.if.lr.ph

B5931.if.lr.ph:                                   ; preds = %B5891
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
  br i1 %exitcond1331.not.1, label %B6091, label %B5931.if.1

B6035:                                            ; preds = %B5879
  %sunkaddr13 = shl i64 %j.2.0, 3
  %sunkaddr14 = getelementptr i8, ptr %arg.second.4, i64 %sunkaddr13
  br i1 %4, label %B6037, label %B6075

B6037:                                            ; preds = %B6035
  store <16 x float> %.1294, ptr %sunkaddr14, align 64, !nontemporal !123
  br label %B6091

B6075:                                            ; preds = %B6035
  store <16 x float> %.1294, ptr %sunkaddr14, align 4
  br label %B6091

B6091:                                            ; preds = %B6037, %B6075, %B5931.if.6, %B5931.if.5, %B5931.if.4, %B5931.if.3, %B5931.if.2, %B5931.if.1, %B5931.if.lr.ph, %B5891, %B5875
  %.1580 = add nsw i64 %count.2.1, %j.2.0
  %.1586 = icmp slt i64 %.1580, %arg.stop
  br i1 %.1586, label %B150, label %common.ret

common.ret:                                       ; preds = %B6091, %entry
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
  br i1 %exitcond.not.1.1, label %B5875, label %B532.if.2

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
  br i1 %exitcond.not.1.2, label %B5875, label %B532.if.3

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
  br i1 %exitcond.not.1.3, label %B5875, label %B532.if.4

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
  br i1 %exitcond.not.1.4, label %B5875, label %B532.if.5

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
  br i1 %exitcond.not.1.5, label %B5875, label %B532.if.6

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
  br label %B5875

B5931.if.1:                                       ; preds = %B5931.if.lr.ph
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
  br i1 %exitcond1331.not.1.1, label %B6091, label %B5931.if.2

B5931.if.2:                                       ; preds = %B5931.if.1
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
  br i1 %exitcond1331.not.1.2, label %B6091, label %B5931.if.3

B5931.if.3:                                       ; preds = %B5931.if.2
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
  br i1 %exitcond1331.not.1.3, label %B6091, label %B5931.if.4

B5931.if.4:                                       ; preds = %B5931.if.3
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
  br i1 %exitcond1331.not.1.4, label %B6091, label %B5931.if.5

B5931.if.5:                                       ; preds = %B5931.if.4
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
  br i1 %exitcond1331.not.1.5, label %B6091, label %B5931.if.6

B5931.if.6:                                       ; preds = %B5931.if.5
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
  br label %B6091
}

; Function Attrs: nofree noinline norecurse nosync nounwind memory(argmem: readwrite)
define internal fastcc void @inner_15(ptr noalias nonnull writeonly captures(none) %retptr, ptr readonly captures(none) %arg.amplitude.4, ptr readonly captures(none) %arg.phase.4, i64 %arg.stop, double %arg.factors.0, double %arg.factors.1, i64 range(i64 -1, 4) %arg.streamed, ptr writeonly captures(none) %arg.first.4, i64 range(i64 -9223372036854775808, 9223372036854775807) %arg.first.5.0, ptr writeonly captures(none) %arg.second.4, i64 range(i64 -9223372036854775808, 9223372036854775807) %arg.second.5.0, ptr captures(none) %arg.tail.4) unnamed_addr #7 {
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

B150:                                             ; preds = %B6488, %B150.preheader
  %j.2.0 = phi i64 [ %.1560, %B6488 ], [ 0, %B150.preheader ]
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
  br i1 %.874, label %B472, label %B6160

B472:                                             ; preds = %B150
  %.889 = shufflevector <8 x double> %.8.i297, <8 x double> %.8.i300, <16 x i32> <i32 0, i32 8, i32 1, i32 9, i32 2, i32 10, i32 3, i32 11, i32 4, i32 12, i32 5, i32 13, i32 6, i32 14, i32 7, i32 15>
  store <16 x double> %.889, ptr %arg.tail.4, align 4
  %.979841.not = icmp slt i64 %count.2.1, 1
  br i1 %.979841.not, label %B6272, label %B532.if.lr.ph

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
  br i1 %exitcond.not.1, label %B6272, label %B532.if.1

B6160:                                            ; preds = %B150
  %.1121.idx = shl i64 %j.2.0, 4
  %.1122 = shufflevector <8 x double> %.8.i297, <8 x double> %.8.i300, <16 x i32> <i32 0, i32 8, i32 1, i32 9, i32 2, i32 10, i32 3, i32 11, i32 4, i32 12, i32 5, i32 13, i32 6, i32 14, i32 7, i32 15>
  %sunkaddr6 = getelementptr i8, ptr %arg.first.4, i64 %.1121.idx
  br i1 %3, label %B6232, label %B6234

B6232:                                            ; preds = %B6160
  store <16 x double> %.1122, ptr %sunkaddr6, align 64, !nontemporal !123
  br label %B6272

B6234:                                            ; preds = %B6160
  store <16 x double> %.1122, ptr %sunkaddr6, align 4
  br label %B6272

B6272:                                            ; preds = %B472, %B532.if.lr.ph, %B532.if.1, %B532.if.2, %B532.if.3, %B532.if.4, %B532.if.5, %B532.if.6, %B6234, %B6232
  br i1 %0, label %B6276, label %B6488

B6276:                                            ; preds = %B6272
  %.8.i277 = fmul contract <8 x double> %.7.i, %.6.i294
  %.8.i303 = fmul contract <8 x double> %.7.i302, %.6.i293
  br i1 %.874, label %B6288, label %B6432

B6288:                                            ; preds = %B6276
  %.1278 = shufflevector <8 x double> %.8.i277, <8 x double> %.8.i303, <16 x i32> <i32 0, i32 8, i32 1, i32 9, i32 2, i32 10, i32 3, i32 11, i32 4, i32 12, i32 5, i32 13, i32 6, i32 14, i32 7, i32 15>
  store <16 x double> %.1278, ptr %arg.tail.4, align 4
  %.1368847.not = icmp slt i64 %count.2.1, 1
  br i1 %.1368847.not, label %B6488, label %B6328.if.lr.ph

B6328.if.lr.ph:                                   ; preds = %B6288
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
  br i1 %exitcond1331.not.1, label %B6488, label %B6328.if.1

B6432:                                            ; preds = %B6276
  %.1510.idx = shl i64 %j.2.0, 4
  %.1511 = shufflevector <8 x double> %.8.i277, <8 x double> %.8.i303, <16 x i32> <i32 0, i32 8, i32 1, i32 9, i32 2, i32 10, i32 3, i32 11, i32 4, i32 12, i32 5, i32 13, i32 6, i32 14, i32 7, i32 15>
  %sunkaddr32 = getelementptr i8, ptr %arg.second.4, i64 %.1510.idx
  br i1 %4, label %B6434, label %B6472

B6434:                                            ; preds = %B6432
  store <16 x double> %.1511, ptr %sunkaddr32, align 64, !nontemporal !123
  br label %B6488

B6472:                                            ; preds = %B6432
  store <16 x double> %.1511, ptr %sunkaddr32, align 4
  br label %B6488

B6488:                                            ; preds = %B6434, %B6472, %B6328.if.6, %B6328.if.5, %B6328.if.4, %B6328.if.3, %B6328.if.2, %B6328.if.1, %B6328.if.lr.ph, %B6288, %B6272
  %.1560 = add nsw i64 %count.2.1, %j.2.0
  %.1566 = icmp slt i64 %.1560, %arg.stop
  br i1 %.1566, label %B150, label %common.ret

common.ret:                                       ; preds = %B6488, %entry
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
  br i1 %exitcond.not.1.1, label %B6272, label %B532.if.2

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
  br i1 %exitcond.not.1.2, label %B6272, label %B532.if.3

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
  br i1 %exitcond.not.1.3, label %B6272, label %B532.if.4

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
  br i1 %exitcond.not.1.4, label %B6272, label %B532.if.5

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
  br i1 %exitcond.not.1.5, label %B6272, label %B532.if.6

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
  br label %B6272

B6328.if.1:                                       ; preds = %B6328.if.lr.ph
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
  br i1 %exitcond1331.not.1.1, label %B6488, label %B6328.if.2

B6328.if.2:                                       ; preds = %B6328.if.1
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
  br i1 %exitcond1331.not.1.2, label %B6488, label %B6328.if.3

B6328.if.3:                                       ; preds = %B6328.if.2
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
  br i1 %exitcond1331.not.1.3, label %B6488, label %B6328.if.4

B6328.if.4:                                       ; preds = %B6328.if.3
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
  br i1 %exitcond1331.not.1.4, label %B6488, label %B6328.if.5

B6328.if.5:                                       ; preds = %B6328.if.4
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
  br i1 %exitcond1331.not.1.5, label %B6488, label %B6328.if.6

B6328.if.6:                                       ; preds = %B6328.if.5
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
  br label %B6488
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
  br i1 %prol.iter.cmp.not, label %B58.if.prol.loopexit.loopexit, label %B58.if.prol, !llvm.loop !124

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
  br i1 %prol.iter3.cmp.not, label %B128.if.prol.loopexit.loopexit, label %B128.if.prol, !llvm.loop !125

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
define internal fastcc void @inner_16(ptr noalias nonnull writeonly captures(none) %retptr, ptr writeonly captures(none) %arg.first.4, i64 range(i64 -9223372036854775808, 9223372036854775807) %arg.first.5.0, ptr writeonly captures(none) %arg.second.4, i64 range(i64 -9223372036854775808, 9223372036854775807) %arg.second.5.0, i64 range(i64 -9223372036854775808, 9223372036854775807) %arg.start) unnamed_addr #8 {
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
  br i1 %prol.iter.cmp.not, label %B58.if.prol.loopexit.loopexit, label %B58.if.prol, !llvm.loop !126

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
  br i1 %prol.iter3.cmp.not, label %B128.if.prol.loopexit.loopexit, label %B128.if.prol, !llvm.loop !127

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
  %.271 = load i64, ptr %arg.contents.4, align 8
  %.303 = getelementptr i8, ptr %arg.scaling.4, i64 80
  %.304 = load double, ptr %.303, align 8
  %scevgep = getelementptr i8, ptr %arg.out.4, i64 256
  %sunkaddr77 = getelementptr i8, ptr %arg.scaling.4, i64 40
  %sunkaddr80 = getelementptr i8, ptr %arg.scratch.4, i64 8
  %sunkaddr81 = getelementptr i8, ptr %arg.scaling.4, i64 8
  %sunkaddr82 = getelementptr i8, ptr %arg.scaling.4, i64 48
  %sunkaddr85 = getelementptr i8, ptr %arg.scratch.4, i64 16
  %sunkaddr86 = getelementptr i8, ptr %arg.scaling.4, i64 16
  %sunkaddr87 = getelementptr i8, ptr %arg.scaling.4, i64 56
  %sunkaddr90 = getelementptr i8, ptr %arg.scratch.4, i64 24
  %sunkaddr91 = getelementptr i8, ptr %arg.scaling.4, i64 24
  %sunkaddr92 = getelementptr i8, ptr %arg.scaling.4, i64 64
  %sunkaddr95 = getelementptr i8, ptr %arg.scratch.4, i64 32
  %sunkaddr = getelementptr i8, ptr %arg.scaling.4, i64 32
  %sunkaddr96 = getelementptr i8, ptr %arg.scaling.4, i64 72
  %sunkaddr30 = getelementptr i8, ptr %arg.scratch.4, i64 8
  %sunkaddr36 = getelementptr i8, ptr %arg.scratch.4, i64 16
  %sunkaddr41 = getelementptr i8, ptr %arg.scratch.4, i64 24
  %sunkaddr45 = getelementptr i8, ptr %arg.scratch.4, i64 32
  %sunkaddr8 = getelementptr i8, ptr %arg.scratch.4, i64 8
  %sunkaddr12 = getelementptr i8, ptr %arg.scratch.4, i64 16
  %sunkaddr19 = getelementptr i8, ptr %arg.scratch.4, i64 24
  %sunkaddr23 = getelementptr i8, ptr %arg.scratch.4, i64 32
  %sunkaddr59 = getelementptr i8, ptr %arg.scratch.4, i64 8
  %sunkaddr65 = getelementptr i8, ptr %arg.scratch.4, i64 16
  %sunkaddr71 = getelementptr i8, ptr %arg.scratch.4, i64 24
  %sunkaddr74 = getelementptr i8, ptr %arg.scratch.4, i64 32
  br label %B118.if

B270:                                             ; preds = %B118.if
  %.38.le.i = tail call contract double @llvm.log.f64(double %.1045)
  %.21.i = fadd contract double %.1045, 1.000000e+00
  %.30.i = fdiv contract double 1.000000e+00, %.21.i
  %.25.i = fdiv contract double %.1045, %.21.i
  store double %.38.le.i, ptr %arg.scratch.4, align 8, !noalias !128
  %.72.i = tail call contract double @llvm.pow.f64(double %.13.i, double 4.000000e-01)
  %.73.i = fmul contract double %.72.i, %.25.i
  store double %.73.i, ptr %sunkaddr8, align 8, !noalias !128
  %.103.i = tail call contract double @llvm.pow.f64(double %.13.i13, double 4.000000e-01)
  %.104.i = fmul contract double %.103.i, %.30.i
  store double %.104.i, ptr %sunkaddr12, align 8, !noalias !128
  %.134.i = fmul contract double %.1075, %.25.i
  %.135.i = fmul contract double %.30.i, %.1105
  %.136.i = fadd contract double %.134.i, %.135.i
  %.137.i = fmul contract double %.25.i, 0x3FD585A9E9585A9F
  %.138.i = fmul contract double %.30.i, %.137.i
  %.139.i = fadd contract double %.1075, %.1105
  %.140.i = fmul contract double %.139.i, %.138.i
  %.141.i = fsub contract double %.136.i, %.140.i
  store double %.141.i, ptr %sunkaddr19, align 8, !noalias !128
  %.171.i = fsub contract double %.1075, %.1105
  %.172.i = fmul contract double %.171.i, 5.000000e-01
  store double %.172.i, ptr %sunkaddr23, align 8, !noalias !128
  br label %B570.if

B370:                                             ; preds = %B118.if
  %.38.le.i.i = tail call contract double @llvm.log.f64(double %.1045)
  %.21.i.i = fadd contract double %.1045, 1.000000e+00
  %.30.i.i = fdiv contract double 1.000000e+00, %.21.i.i
  %.25.i.i = fdiv contract double %.1045, %.21.i.i
  store double %.38.le.i.i, ptr %arg.scratch.4, align 8, !noalias !131
  %.72.i.i = tail call contract double @llvm.pow.f64(double %.13.i, double 4.000000e-01)
  %.73.i.i = fmul contract double %.72.i.i, %.25.i.i
  store double %.73.i.i, ptr %sunkaddr30, align 8, !noalias !131
  %.103.i.i = tail call contract double @llvm.pow.f64(double %.13.i13, double 4.000000e-01)
  %.104.i.i = fmul contract double %.103.i.i, %.30.i.i
  store double %.104.i.i, ptr %sunkaddr36, align 8, !noalias !131
  %.134.i.i = fmul contract double %.1075, %.25.i.i
  %.135.i.i = fmul contract double %.30.i.i, %.1105
  %.136.i.i = fadd contract double %.134.i.i, %.135.i.i
  %.137.i.i = fmul contract double %.25.i.i, 0x3FD585A9E9585A9F
  %.138.i.i = fmul contract double %.30.i.i, %.137.i.i
  %.139.i.i = fadd contract double %.1075, %.1105
  %.140.i.i = fmul contract double %.139.i.i, %.138.i.i
  %.141.i.i = fsub contract double %.136.i.i, %.140.i.i
  store double %.141.i.i, ptr %sunkaddr41, align 8, !noalias !131
  %.171.i.i = fsub contract double %.1075, %.1105
  %.172.i.i = fmul contract double %.171.i.i, 5.000000e-01
  store double %.172.i.i, ptr %sunkaddr45, align 8, !noalias !131
  %.107.i = fsub contract double %.73.i.i, %.104.i.i
  %.166.i = fadd contract double %.73.i.i, %.104.i.i
  store double %.107.i, ptr %sunkaddr30, align 8, !noalias !136
  store double %.166.i, ptr %sunkaddr36, align 8, !noalias !136
  br label %B570.if

B448:                                             ; preds = %B118.if
  store double %.1045, ptr %arg.scratch.4, align 8
  store double %.1075, ptr %sunkaddr59, align 8
  store double %.1105, ptr %sunkaddr65, align 8
  store double %.13.i, ptr %sunkaddr71, align 8
  store double %.13.i13, ptr %sunkaddr74, align 8
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
  %.1506 = load double, ptr %sunkaddr77, align 8
  %.1507 = fmul contract double %.1475, %.1506
  %scevgep18 = getelementptr i8, ptr %lsr.iv, i64 -256
  store double %.1507, ptr %scevgep18, align 8
  %.1444.1 = load double, ptr %sunkaddr80, align 8
  %.1474.1 = load double, ptr %sunkaddr81, align 8
  %.1475.1 = fsub contract double %.1444.1, %.1474.1
  %.1506.1 = load double, ptr %sunkaddr82, align 8
  %.1507.1 = fmul contract double %.1475.1, %.1506.1
  %scevgep17 = getelementptr i8, ptr %lsr.iv, i64 -192
  store double %.1507.1, ptr %scevgep17, align 8
  %.1444.2 = load double, ptr %sunkaddr85, align 8
  %.1474.2 = load double, ptr %sunkaddr86, align 8
  %.1475.2 = fsub contract double %.1444.2, %.1474.2
  %.1506.2 = load double, ptr %sunkaddr87, align 8
  %.1507.2 = fmul contract double %.1475.2, %.1506.2
  %scevgep16 = getelementptr i8, ptr %lsr.iv, i64 -128
  store double %.1507.2, ptr %scevgep16, align 8
  %.1444.3 = load double, ptr %sunkaddr90, align 8
  %.1474.3 = load double, ptr %sunkaddr91, align 8
  %.1475.3 = fsub contract double %.1444.3, %.1474.3
  %.1506.3 = load double, ptr %sunkaddr92, align 8
  %.1507.3 = fmul contract double %.1475.3, %.1506.3
  %scevgep15 = getelementptr i8, ptr %lsr.iv, i64 -64
  store double %.1507.3, ptr %scevgep15, align 8
  %.1444.4 = load double, ptr %sunkaddr95, align 8
  %.1474.4 = load double, ptr %sunkaddr, align 8
  %.1475.4 = fsub contract double %.1444.4, %.1474.4
  %.1506.4 = load double, ptr %sunkaddr96, align 8
  %.1507.4 = fmul contract double %.1475.4, %.1506.4
  store double %.1507.4, ptr %lsr.iv, align 8
  %scevgep14 = getelementptr i8, ptr %lsr.iv, i64 8
  %lsr.iv.next = add nuw nsw i64 %lsr.iv19, 5
  %exitcond.not = icmp eq i64 %lsr.iv.next, 40
  br i1 %exitcond.not, label %B666, label %B118.if
}

; Function Attrs: nofree noinline norecurse nosync nounwind memory(argmem: readwrite)
define internal fastcc void @inner_7(ptr noalias nonnull writeonly captures(none) %retptr, ptr readonly captures(none) %arg.coordinates.4, i64 %arg.rows, ptr readonly captures(none) %arg.contents.4, ptr readonly captures(none) %arg.layers.4, i64 range(i64 0, 1073741825) %arg.layers.5.0, ptr %arg.scratch.4, i64 range(i64 0, -9223372036854775808) %arg.scratch.5.0, ptr captures(none) %arg.out.4, i64 range(i64 16, 9) %arg.out_row) unnamed_addr #7 {
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
  br i1 %.215, label %B0.endif.else.endif.endif.if, label %B0.endif.else.endif.endif.endif, !prof !5

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
  %sunkaddr78 = getelementptr i8, ptr %arg.contents.4, i64 48
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
  %3 = add nsw i64 %reass.sub, 5
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
  %10 = add nuw nsw i64 %storemerge760, 5
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
  br i1 %.220.not, label %B0.endif.else.endif.endif.endif.endif, label %B0.endif.else.endif.endif.endif.if, !prof !1

B0.endif.else.endif.endif.endif.if:               ; preds = %B0.endif.else.endif.endif.endif
  br label %B0.endif.else.endif.endif.endif.endif

B0.endif.else.endif.endif.endif.endif:            ; preds = %B0.endif.else.endif.endif.endif.if, %B0.endif.else.endif.endif.endif
  %.183.sroa.13.2 = phi i64 [ %arg.scratch.5.0, %B0.endif.else.endif.endif.endif.if ], [ %.183.sroa.13.1, %B0.endif.else.endif.endif.endif ]
  %.332 = shl i64 %.152, 4
  br i1 %.215, label %B0.endif.endif.else.if, label %B0.endif.endif.else.endif, !prof !5

B0.endif.endif.else.if:                           ; preds = %B0.endif.else.endif.endif.endif.endif
  br label %B0.endif.endif.else.endif

B0.endif.endif.else.endif:                        ; preds = %B0.endif.endif.else.if, %B0.endif.else.endif.endif.endif.endif
  %.358.sroa.0.1 = phi i64 [ 0, %B0.endif.endif.else.if ], [ %.212, %B0.endif.else.endif.endif.endif.endif ]
  br i1 %.220.not, label %B0.endif.endif.else.endif.endif, label %B0.endif.endif.else.endif.if, !prof !1

B0.endif.endif.else.endif.if:                     ; preds = %B0.endif.endif.else.endif
  br label %B0.endif.endif.else.endif.endif

B0.endif.endif.else.endif.endif:                  ; preds = %B0.endif.endif.else.endif.if, %B0.endif.endif.else.endif
  %.358.sroa.0.3 = phi i64 [ %arg.scratch.5.0, %B0.endif.endif.else.endif.if ], [ %.358.sroa.0.1, %B0.endif.endif.else.endif ]
  %.387 = add i64 %.211, %.332
  %.390 = icmp slt i64 %.387, 0
  br i1 %.390, label %B0.endif.endif.else.endif.endif.if, label %B0.endif.endif.else.endif.endif.endif, !prof !5

B0.endif.endif.else.endif.endif.if:               ; preds = %B0.endif.endif.else.endif.endif
  br label %B0.endif.endif.else.endif.endif.endif

B0.endif.endif.else.endif.endif.endif:            ; preds = %B0.endif.endif.else.endif.endif.if, %B0.endif.endif.else.endif.endif
  %.358.sroa.13.1 = phi i64 [ 0, %B0.endif.endif.else.endif.endif.if ], [ %.387, %B0.endif.endif.else.endif.endif ]
  %.395.not = icmp slt i64 %.387, %arg.scratch.5.0
  br i1 %.395.not, label %B0.endif.endif.else.endif.endif.endif.endif, label %B0.endif.endif.else.endif.endif.endif.if, !prof !1

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
  %scevgep58 = getelementptr i8, ptr %lsr.iv, i64 %21
  store double 1.000000e+00, ptr %scevgep58, align 8
  %22 = select i1 %.664, i64 %14, i64 0
  %23 = getelementptr i8, ptr %lsr.iv, i64 %12
  %24 = getelementptr i8, ptr %23, i64 56
  %scevgep41 = getelementptr i8, ptr %24, i64 %22
  store double 1.000000e+00, ptr %scevgep41, align 8
  %sunkaddr = getelementptr i8, ptr %arg.coordinates.4, i64 %lsr.iv54
  %sunkaddr69 = getelementptr i8, ptr %sunkaddr, i64 64
  %.865 = load double, ptr %sunkaddr69, align 8
  %.884 = icmp slt i64 %lsr.iv63, -8
  %25 = select i1 %.884, i64 %16, i64 64
  %scevgep57 = getelementptr i8, ptr %lsr.iv, i64 %25
  store double %.865, ptr %scevgep57, align 8
  %sunkaddr71 = getelementptr i8, ptr %sunkaddr, i64 128
  %.865.1 = load double, ptr %sunkaddr71, align 8
  %.884.1 = icmp slt i64 %lsr.iv63, -9
  %26 = select i1 %.884.1, i64 %17, i64 72
  %scevgep56 = getelementptr i8, ptr %lsr.iv, i64 %26
  store double %.865.1, ptr %scevgep56, align 8
  %sunkaddr73 = getelementptr i8, ptr %sunkaddr, i64 192
  %.865.2 = load double, ptr %sunkaddr73, align 8
  %.884.2 = icmp slt i64 %lsr.iv63, -10
  %27 = select i1 %.884.2, i64 %18, i64 80
  %scevgep44 = getelementptr i8, ptr %lsr.iv, i64 %27
  store double %.865.2, ptr %scevgep44, align 8
  %sunkaddr75 = getelementptr i8, ptr %sunkaddr, i64 256
  %.865.3 = load double, ptr %sunkaddr75, align 8
  %.884.3 = icmp slt i64 %lsr.iv63, -11
  %28 = select i1 %.884.3, i64 %19, i64 88
  %scevgep43 = getelementptr i8, ptr %lsr.iv, i64 %28
  store double %.865.3, ptr %scevgep43, align 8
  %sunkaddr77 = getelementptr i8, ptr %sunkaddr, i64 320
  %.865.4 = load double, ptr %sunkaddr77, align 8
  %.884.4 = icmp slt i64 %lsr.iv63, -12
  %29 = select i1 %.884.4, i64 %20, i64 96
  %scevgep42 = getelementptr i8, ptr %lsr.iv, i64 %29
  store double %.865.4, ptr %scevgep42, align 8
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
  br i1 %.1391, label %B662.else.if, label %B662.else.endif, !prof !5

B662.else.if:                                     ; preds = %B660.if
  br label %B662.else.endif

B662.else.endif:                                  ; preds = %B662.else.if, %B660.if
  %.1376.sroa.0.1 = phi i64 [ 0, %B662.else.if ], [ %.1388, %B660.if ]
  %.1396.not = icmp slt i64 %.1388, %current.2.sroa.50.0816
  br i1 %.1396.not, label %B662.else.endif.endif, label %B662.else.endif.if, !prof !1

B662.else.endif.if:                               ; preds = %B662.else.endif
  br label %B662.else.endif.endif

B662.else.endif.endif:                            ; preds = %B662.else.endif.if, %B662.else.endif
  %.1376.sroa.0.3 = phi i64 [ %current.2.sroa.50.0816, %B662.else.endif.if ], [ %.1376.sroa.0.1, %B662.else.endif ]
  %.1489 = getelementptr double, ptr %current.2.sroa.40.0817, i64 %.1376.sroa.0.3
  %.1560 = icmp slt i64 %.1347, -8
  %.1561 = select i1 %.1560, i64 %following.2.sroa.55.0814, i64 0
  %.1562 = add i64 %.1561, %.1348
  %.1565 = icmp slt i64 %.1562, 0
  br i1 %.1565, label %B662.endif.else.if, label %B662.endif.else.endif, !prof !5

B662.endif.else.if:                               ; preds = %B662.else.endif.endif
  br label %B662.endif.else.endif

B662.endif.else.endif:                            ; preds = %B662.endif.else.if, %B662.else.endif.endif
  %.1550.sroa.0.1 = phi i64 [ 0, %B662.endif.else.if ], [ %.1562, %B662.else.endif.endif ]
  %.1570.not = icmp slt i64 %.1562, %following.2.sroa.55.0814
  br i1 %.1570.not, label %B662.endif.else.endif.endif, label %B662.endif.else.endif.if, !prof !1

B662.endif.else.endif.if:                         ; preds = %B662.endif.else.endif
  br label %B662.endif.else.endif.endif

B662.endif.else.endif.endif:                      ; preds = %B662.endif.else.endif.if, %B662.endif.else.endif
  %.1550.sroa.0.3 = phi i64 [ %following.2.sroa.55.0814, %B662.endif.else.endif.if ], [ %.1550.sroa.0.1, %B662.endif.else.endif ]
  %.1663 = getelementptr double, ptr %following.2.sroa.44.0815, i64 %.1550.sroa.0.3
  br i1 %37, label %B662.endif.endif.else.if, label %B662.endif.endif.else.endif, !prof !5

B662.endif.endif.else.if:                         ; preds = %B662.endif.else.endif.endif
  br label %B662.endif.endif.else.endif

B662.endif.endif.else.endif:                      ; preds = %B662.endif.endif.else.if, %B662.endif.else.endif.endif
  %.1729.sroa.0.1 = phi i64 [ 0, %B662.endif.endif.else.if ], [ %.1741, %B662.endif.else.endif.endif ]
  br i1 %38, label %B662.endif.endif.else.endif.endif, label %B662.endif.endif.else.endif.if, !prof !1

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
  %_multiply_wide_v57_a00.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B84.if.i ], [ %.577.i, %B200.if.i ]
  %_multiply_wide_v57_a01.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B84.if.i ], [ %.581.i, %B200.if.i ]
  %_multiply_wide_v57_a02.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B84.if.i ], [ %.589.i, %B200.if.i ]
  %_multiply_wide_v57_a03.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B84.if.i ], [ %.593.i, %B200.if.i ]
  %_multiply_wide_v57_a10.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B84.if.i ], [ %.614.i, %B200.if.i ]
  %_multiply_wide_v57_a11.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B84.if.i ], [ %.618.i, %B200.if.i ]
  %_multiply_wide_v57_a12.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B84.if.i ], [ %.626.i, %B200.if.i ]
  %_multiply_wide_v57_a13.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B84.if.i ], [ %.630.i, %B200.if.i ]
  %_multiply_wide_v57_a20.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B84.if.i ], [ %.652.i, %B200.if.i ]
  %_multiply_wide_v57_a21.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B84.if.i ], [ %.656.i, %B200.if.i ]
  %_multiply_wide_v57_a22.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B84.if.i ], [ %.664.i, %B200.if.i ]
  %_multiply_wide_v57_a23.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B84.if.i ], [ %.668.i, %B200.if.i ]
  %_multiply_wide_v57_a30.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B84.if.i ], [ %.690.i, %B200.if.i ]
  %_multiply_wide_v57_a31.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B84.if.i ], [ %.694.i, %B200.if.i ]
  %_multiply_wide_v57_a32.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B84.if.i ], [ %.702.i, %B200.if.i ]
  %_multiply_wide_v57_a33.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B84.if.i ], [ %.706.i, %B200.if.i ]
  store <8 x double> %_multiply_wide_v57_a00.2.1.lcssa.i, ptr %.237.i, align 8, !noalias !137
  %.765.i = getelementptr inbounds nuw i8, ptr %.237.i, i64 64
  store <8 x double> %_multiply_wide_v57_a01.2.1.lcssa.i, ptr %.765.i, align 8, !noalias !137
  %.776.i = getelementptr inbounds nuw i8, ptr %.237.i, i64 128
  store <8 x double> %_multiply_wide_v57_a02.2.1.lcssa.i, ptr %.776.i, align 8, !noalias !137
  %.787.i = getelementptr inbounds nuw i8, ptr %.237.i, i64 192
  store <8 x double> %_multiply_wide_v57_a03.2.1.lcssa.i, ptr %.787.i, align 8, !noalias !137
  %.817.i = getelementptr inbounds double, ptr %.237.i, i64 %.152
  store <8 x double> %_multiply_wide_v57_a10.2.1.lcssa.i, ptr %.817.i, align 8, !noalias !137
  %.827.i = getelementptr i8, ptr %.817.i, i64 64
  store <8 x double> %_multiply_wide_v57_a11.2.1.lcssa.i, ptr %.827.i, align 8, !noalias !137
  %.838.i = getelementptr i8, ptr %.817.i, i64 128
  store <8 x double> %_multiply_wide_v57_a12.2.1.lcssa.i, ptr %.838.i, align 8, !noalias !137
  %.849.i = getelementptr i8, ptr %.817.i, i64 192
  store <8 x double> %_multiply_wide_v57_a13.2.1.lcssa.i, ptr %.849.i, align 8, !noalias !137
  %.880.i = getelementptr inbounds i8, ptr %.237.i, i64 %.332
  store <8 x double> %_multiply_wide_v57_a20.2.1.lcssa.i, ptr %.880.i, align 8, !noalias !137
  %.890.i = getelementptr i8, ptr %.880.i, i64 64
  store <8 x double> %_multiply_wide_v57_a21.2.1.lcssa.i, ptr %.890.i, align 8, !noalias !137
  %.901.i = getelementptr i8, ptr %.880.i, i64 128
  store <8 x double> %_multiply_wide_v57_a22.2.1.lcssa.i, ptr %.901.i, align 8, !noalias !137
  %.912.i = getelementptr i8, ptr %.880.i, i64 192
  store <8 x double> %_multiply_wide_v57_a23.2.1.lcssa.i, ptr %.912.i, align 8, !noalias !137
  %.950.i = getelementptr inbounds i8, ptr %.237.i, i64 %.idx814.i
  store <8 x double> %_multiply_wide_v57_a30.2.1.lcssa.i, ptr %.950.i, align 8, !noalias !137
  %.960.i = getelementptr i8, ptr %.950.i, i64 64
  store <8 x double> %_multiply_wide_v57_a31.2.1.lcssa.i, ptr %.960.i, align 8, !noalias !137
  %.971.i = getelementptr i8, ptr %.950.i, i64 128
  store <8 x double> %_multiply_wide_v57_a32.2.1.lcssa.i, ptr %.971.i, align 8, !noalias !137
  %.982.i = getelementptr i8, ptr %.950.i, i64 192
  store <8 x double> %_multiply_wide_v57_a33.2.1.lcssa.i, ptr %.982.i, align 8, !noalias !137
  %scevgep19.i = getelementptr i8, ptr %lsr.iv18.i, i64 %35
  %.187.i = icmp sgt i64 %.186856868.i, 1
  br i1 %.187.i, label %B84.if.i, label %B354.else.i

B3459.loopexit.i:                                 ; preds = %B884.if.i
  %46 = add i64 %position.5.0901.i, %36
  br label %B3459.i

B3459.i:                                          ; preds = %B356.if.i, %B3459.loopexit.i
  %position.4.1.lcssa.i = phi i64 [ %position.5.0901.i, %B356.if.i ], [ %46, %B3459.loopexit.i ]
  %b0.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B356.if.i ], [ %.1337.i, %B3459.loopexit.i ]
  %b1.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B356.if.i ], [ %.1356.i, %B3459.loopexit.i ]
  %b2.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B356.if.i ], [ %.1376.i, %B3459.loopexit.i ]
  %b3.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B356.if.i ], [ %.1396.i, %B3459.loopexit.i ]
  %.1418.i = getelementptr inbounds double, ptr %.1663, i64 %.1135893899.i
  store <8 x double> %b0.2.1.lcssa.i, ptr %.1418.i, align 8, !noalias !137
  %.1434.i = getelementptr double, ptr %51, i64 %.1135893899.i
  store <8 x double> %b1.2.1.lcssa.i, ptr %.1434.i, align 8, !noalias !137
  %.1451.i = getelementptr double, ptr %52, i64 %.1135893899.i
  store <8 x double> %b2.2.1.lcssa.i, ptr %.1451.i, align 8, !noalias !137
  %.1470.i = getelementptr double, ptr %53, i64 %.1135893899.i
  store <8 x double> %b3.2.1.lcssa.i, ptr %.1470.i, align 8, !noalias !137
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
  %_multiply_wide_v57_a33.2.1838.i = phi <8 x double> [ %.706.i, %B200.if.i ], [ zeroinitializer, %B84.if.i ]
  %_multiply_wide_v57_a32.2.1837.i = phi <8 x double> [ %.702.i, %B200.if.i ], [ zeroinitializer, %B84.if.i ]
  %_multiply_wide_v57_a31.2.1836.i = phi <8 x double> [ %.694.i, %B200.if.i ], [ zeroinitializer, %B84.if.i ]
  %_multiply_wide_v57_a30.2.1835.i = phi <8 x double> [ %.690.i, %B200.if.i ], [ zeroinitializer, %B84.if.i ]
  %_multiply_wide_v57_a23.2.1834.i = phi <8 x double> [ %.668.i, %B200.if.i ], [ zeroinitializer, %B84.if.i ]
  %_multiply_wide_v57_a22.2.1833.i = phi <8 x double> [ %.664.i, %B200.if.i ], [ zeroinitializer, %B84.if.i ]
  %_multiply_wide_v57_a21.2.1832.i = phi <8 x double> [ %.656.i, %B200.if.i ], [ zeroinitializer, %B84.if.i ]
  %_multiply_wide_v57_a20.2.1831.i = phi <8 x double> [ %.652.i, %B200.if.i ], [ zeroinitializer, %B84.if.i ]
  %_multiply_wide_v57_a13.2.1830.i = phi <8 x double> [ %.630.i, %B200.if.i ], [ zeroinitializer, %B84.if.i ]
  %_multiply_wide_v57_a12.2.1829.i = phi <8 x double> [ %.626.i, %B200.if.i ], [ zeroinitializer, %B84.if.i ]
  %_multiply_wide_v57_a11.2.1828.i = phi <8 x double> [ %.618.i, %B200.if.i ], [ zeroinitializer, %B84.if.i ]
  %_multiply_wide_v57_a10.2.1827.i = phi <8 x double> [ %.614.i, %B200.if.i ], [ zeroinitializer, %B84.if.i ]
  %_multiply_wide_v57_a03.2.1826.i = phi <8 x double> [ %.593.i, %B200.if.i ], [ zeroinitializer, %B84.if.i ]
  %_multiply_wide_v57_a02.2.1825.i = phi <8 x double> [ %.589.i, %B200.if.i ], [ zeroinitializer, %B84.if.i ]
  %_multiply_wide_v57_a01.2.1824.i = phi <8 x double> [ %.581.i, %B200.if.i ], [ zeroinitializer, %B84.if.i ]
  %_multiply_wide_v57_a00.2.1823.i = phi <8 x double> [ %.577.i, %B200.if.i ], [ zeroinitializer, %B84.if.i ]
  %scevgep24.i = getelementptr i8, ptr %lsr.iv20.i, i64 -192
  %.520.i = load <8 x double>, ptr %scevgep24.i, align 8, !noalias !137
  %scevgep23.i = getelementptr i8, ptr %lsr.iv20.i, i64 -128
  %.532.i = load <8 x double>, ptr %scevgep23.i, align 8, !noalias !137
  %scevgep22.i = getelementptr i8, ptr %lsr.iv20.i, i64 -64
  %.545.i = load <8 x double>, ptr %scevgep22.i, align 8, !noalias !137
  %.558.i = load <8 x double>, ptr %lsr.iv20.i, align 8, !noalias !137
  %47 = shl i64 %lsr.iv25, 3
  %scevgep33 = getelementptr i8, ptr %.1489, i64 %47
  %scevgep34 = getelementptr i8, ptr %scevgep33, i64 8
  %.573.i = load double, ptr %scevgep34, align 8, !noalias !137
  %.575.i = insertelement <8 x double> poison, double %.573.i, i64 0
  %.576.i = shufflevector <8 x double> %.575.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.577.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.520.i, <8 x double> %.576.i, <8 x double> %_multiply_wide_v57_a00.2.1823.i)
  %.581.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.532.i, <8 x double> %.576.i, <8 x double> %_multiply_wide_v57_a01.2.1824.i)
  %.589.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.545.i, <8 x double> %.576.i, <8 x double> %_multiply_wide_v57_a02.2.1825.i)
  %.593.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.558.i, <8 x double> %.576.i, <8 x double> %_multiply_wide_v57_a03.2.1826.i)
  %scevgep26 = getelementptr i8, ptr %43, i64 %47
  %scevgep27 = getelementptr i8, ptr %scevgep26, i64 8
  %.610.i = load double, ptr %scevgep27, align 8, !noalias !137
  %.612.i = insertelement <8 x double> poison, double %.610.i, i64 0
  %.613.i = shufflevector <8 x double> %.612.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.614.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.520.i, <8 x double> %.613.i, <8 x double> %_multiply_wide_v57_a10.2.1827.i)
  %.618.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.532.i, <8 x double> %.613.i, <8 x double> %_multiply_wide_v57_a11.2.1828.i)
  %.626.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.545.i, <8 x double> %.613.i, <8 x double> %_multiply_wide_v57_a12.2.1829.i)
  %.630.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.558.i, <8 x double> %.613.i, <8 x double> %_multiply_wide_v57_a13.2.1830.i)
  %scevgep20 = getelementptr i8, ptr %44, i64 %47
  %scevgep22 = getelementptr i8, ptr %scevgep20, i64 8
  %.648.i = load double, ptr %scevgep22, align 8, !noalias !137
  %.650.i = insertelement <8 x double> poison, double %.648.i, i64 0
  %.651.i = shufflevector <8 x double> %.650.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.652.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.520.i, <8 x double> %.651.i, <8 x double> %_multiply_wide_v57_a20.2.1831.i)
  %.656.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.532.i, <8 x double> %.651.i, <8 x double> %_multiply_wide_v57_a21.2.1832.i)
  %.664.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.545.i, <8 x double> %.651.i, <8 x double> %_multiply_wide_v57_a22.2.1833.i)
  %.668.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.558.i, <8 x double> %.651.i, <8 x double> %_multiply_wide_v57_a23.2.1834.i)
  %scevgep9 = getelementptr i8, ptr %45, i64 %47
  %scevgep10 = getelementptr i8, ptr %scevgep9, i64 8
  %.686.i = load double, ptr %scevgep10, align 8, !noalias !137
  %.688.i = insertelement <8 x double> poison, double %.686.i, i64 0
  %.689.i = shufflevector <8 x double> %.688.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.690.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.520.i, <8 x double> %.689.i, <8 x double> %_multiply_wide_v57_a30.2.1835.i)
  %.694.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.532.i, <8 x double> %.689.i, <8 x double> %_multiply_wide_v57_a31.2.1836.i)
  %.702.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.545.i, <8 x double> %.689.i, <8 x double> %_multiply_wide_v57_a32.2.1837.i)
  %.706.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.558.i, <8 x double> %.689.i, <8 x double> %_multiply_wide_v57_a33.2.1838.i)
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

B356.if.i:                                        ; preds = %B354.endif.endif.endif.i, %B3459.i
  %position.5.0901.i = phi i64 [ %position.3.0.lcssa.i, %B354.endif.endif.endif.i ], [ %position.4.1.lcssa.i, %B3459.i ]
  %.1128892900.i = phi i64 [ %.1106806.i, %B354.endif.endif.endif.i ], [ %.1138.i, %B3459.i ]
  %.1135893899.i = phi i64 [ %.1046.i, %B354.endif.endif.endif.i ], [ %.1142.i, %B3459.i ]
  %.1138.i = add nsw i64 %.1128892900.i, -1
  %.1142.i = add nuw nsw i64 %.1135893899.i, 8
  br i1 %42, label %B3459.i, label %B884.if.preheader.i

B884.if.preheader.i:                              ; preds = %B356.if.i
  %54 = shl i64 %position.5.0901.i, 3
  %scevgep.i = getelementptr i8, ptr %.1842, i64 %54
  br label %B884.if.i

B884.if.i:                                        ; preds = %B884.if.i, %B884.if.preheader.i
  %lsr.iv31 = phi i64 [ %lsr.iv.next32, %B884.if.i ], [ %.1144, %B884.if.preheader.i ]
  %lsr.iv28 = phi i64 [ %lsr.iv.next29, %B884.if.i ], [ 0, %B884.if.preheader.i ]
  %b3.2.1884.i = phi <8 x double> [ %.1396.i, %B884.if.i ], [ zeroinitializer, %B884.if.preheader.i ]
  %b2.2.1883.i = phi <8 x double> [ %.1376.i, %B884.if.i ], [ zeroinitializer, %B884.if.preheader.i ]
  %b1.2.1882.i = phi <8 x double> [ %.1356.i, %B884.if.i ], [ zeroinitializer, %B884.if.preheader.i ]
  %b0.2.1881.i = phi <8 x double> [ %.1337.i, %B884.if.i ], [ zeroinitializer, %B884.if.preheader.i ]
  %55 = shl i64 %lsr.iv28, 3
  %scevgep30 = getelementptr i8, ptr %scevgep.i, i64 %55
  %.1318.i = load <8 x double>, ptr %scevgep30, align 8, !noalias !137
  %scevgep38 = getelementptr i8, ptr %.1489, i64 %lsr.iv28
  %.1333.i = load double, ptr %scevgep38, align 8, !noalias !137
  %.1335.i = insertelement <8 x double> poison, double %.1333.i, i64 0
  %.1336.i = shufflevector <8 x double> %.1335.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1337.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1318.i, <8 x double> %.1336.i, <8 x double> %b0.2.1881.i)
  %scevgep37 = getelementptr i8, ptr %48, i64 %lsr.iv28
  %.1352.i = load double, ptr %scevgep37, align 8, !noalias !137
  %.1354.i = insertelement <8 x double> poison, double %.1352.i, i64 0
  %.1355.i = shufflevector <8 x double> %.1354.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1356.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1318.i, <8 x double> %.1355.i, <8 x double> %b1.2.1882.i)
  %scevgep36 = getelementptr i8, ptr %49, i64 %lsr.iv28
  %.1372.i = load double, ptr %scevgep36, align 8, !noalias !137
  %.1374.i = insertelement <8 x double> poison, double %.1372.i, i64 0
  %.1375.i = shufflevector <8 x double> %.1374.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1376.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1318.i, <8 x double> %.1375.i, <8 x double> %b2.2.1883.i)
  %scevgep35 = getelementptr i8, ptr %50, i64 %lsr.iv28
  %.1392.i = load double, ptr %scevgep35, align 8, !noalias !137
  %.1394.i = insertelement <8 x double> poison, double %.1392.i, i64 0
  %.1395.i = shufflevector <8 x double> %.1394.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1396.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1318.i, <8 x double> %.1395.i, <8 x double> %b3.2.1884.i)
  %lsr.iv.next29 = add i64 %lsr.iv28, 8
  %lsr.iv.next32 = add i64 %lsr.iv31, -1
  %exitcond909.not.i = icmp eq i64 %lsr.iv.next32, 0
  br i1 %exitcond909.not.i, label %B3459.loopexit.i, label %B884.if.i

B662.endif.endif.endif.endif:                     ; preds = %B3459.i, %B354.else.i
  %.1308 = icmp sgt i64 %.1307791, 1
  br i1 %.1308, label %B660.if, label %B816

B874.if:                                          ; preds = %B874.loopexit, %B874.if.lr.ph
  %lsr.iv47 = phi ptr [ %scevgep46, %B874.if.lr.ph ], [ %scevgep48, %B874.loopexit ]
  %.2026800806 = phi i64 [ 0, %B874.if.lr.ph ], [ %.2033, %B874.loopexit ]
  %.2033 = add nuw nsw i64 %.2026800806, 1
  br i1 %4, label %B972.if, label %B874.loopexit

B972.if:                                          ; preds = %B874.if, %B974.endif
  %lsr.iv39 = phi i64 [ %lsr.iv.next40, %B974.endif ], [ %3, %B874.if ]
  %lsr.iv49 = phi ptr [ %scevgep50, %B974.endif ], [ %lsr.iv47, %B874.if ]
  %.2193 = load <8 x double>, ptr %lsr.iv49, align 8
  %.2223 = load i64, ptr %sunkaddr78, align 8
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
  %lsr.iv.next40 = add nsw i64 %lsr.iv39, -1
  %.2145 = icmp sgt i64 %lsr.iv39, 6
  br i1 %.2145, label %B972.if, label %B874.loopexit

B1144.if:                                         ; preds = %B1144.loopexit, %B1144.if.lr.ph
  %lsr.iv22 = phi ptr [ %arg.out.4, %B1144.if.lr.ph ], [ %scevgep23, %B1144.loopexit ]
  %lsr.iv17 = phi ptr [ %scevgep, %B1144.if.lr.ph ], [ %scevgep18, %B1144.loopexit ]
  %.2426830836 = phi i64 [ 0, %B1144.if.lr.ph ], [ %.2433, %B1144.loopexit ]
  %.2433 = add nuw nsw i64 %.2426830836, 1
  br i1 %11, label %B1144.loopexit, label %B1192.if

B1192.if:                                         ; preds = %B1144.if, %B1192.if
  %lsr.iv2 = phi i64 [ %lsr.iv.next, %B1192.if ], [ %10, %B1144.if ]
  %lsr.iv19 = phi i64 [ %lsr.iv.next20, %B1192.if ], [ 0, %B1144.if ]
  %scevgep24 = getelementptr i8, ptr %lsr.iv22, i64 %lsr.iv19
  %.2592 = load <8 x double>, ptr %scevgep24, align 8
  %scevgep21 = getelementptr i8, ptr %lsr.iv17, i64 %lsr.iv19
  %.2607 = load <8 x double>, ptr %scevgep21, align 8
  %.6.i = fadd contract <8 x double> %.2592, %.2607
  store <8 x double> %.6.i, ptr %scevgep24, align 8
  %lsr.iv.next20 = add i64 %lsr.iv19, 64
  %lsr.iv.next = add nsw i64 %lsr.iv2, -1
  %.2541 = icmp sgt i64 %lsr.iv2, 6
  br i1 %.2541, label %B1192.if, label %B1144.loopexit
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
!3 = distinct !{!3, !4, !"_ZN17bnserve_surrogate6kernel9_matrices8multiplyB3v55B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIdLi1E1C7mutable7alignedEx23Literal_5bint_5d_281_295ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedEx: %retptr"}
!4 = distinct !{!4, !"_ZN17bnserve_surrogate6kernel9_matrices8multiplyB3v55B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIdLi1E1C7mutable7alignedEx23Literal_5bint_5d_281_295ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedEx"}
!5 = !{!"branch_weights", i32 1, i32 99}
!6 = !{!7}
!7 = distinct !{!7, !8, !"_ZN17bnserve_surrogate6kernel11_regression9_productsB3v41B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedExx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!8 = distinct !{!8, !"_ZN17bnserve_surrogate6kernel11_regression9_productsB3v41B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedExx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!9 = !{!10}
!10 = distinct !{!10, !11, !"_ZN17bnserve_surrogate6kernel9_matrices8multiplyB3v45B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIdLi1E1C7mutable7alignedE23Literal_5bint_5d_281_2923Literal_5bint_5d_288_295ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedEx: %retptr"}
!11 = distinct !{!11, !"_ZN17bnserve_surrogate6kernel9_matrices8multiplyB3v45B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIdLi1E1C7mutable7alignedE23Literal_5bint_5d_281_2923Literal_5bint_5d_288_295ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedEx"}
!12 = !{!13}
!13 = distinct !{!13, !14, !"_ZN17bnserve_surrogate6kernel7_places9find_endsB4v177B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5TupleI5ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedExdE5ArrayIdLi1E1C7mutable7alignedExdx5ArrayIxLi1E1C7mutable7alignedE: %retptr"}
!14 = distinct !{!14, !"_ZN17bnserve_surrogate6kernel7_places9find_endsB4v177B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5TupleI5ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedExdE5ArrayIdLi1E1C7mutable7alignedExdx5ArrayIxLi1E1C7mutable7alignedE"}
!15 = !{!16}
!16 = distinct !{!16, !17, !"_ZN17bnserve_surrogate6kernel7_points11two_splinesB4v181B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedExxd5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!17 = distinct !{!17, !"_ZN17bnserve_surrogate6kernel7_points11two_splinesB4v181B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedExxd5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!18 = !{!19}
!19 = distinct !{!19, !20, !"_ZN17bnserve_surrogate6kernel7_points6splineB4v182B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedExxd5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!20 = distinct !{!20, !"_ZN17bnserve_surrogate6kernel7_points6splineB4v182B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedExxd5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE"}
!21 = !{!22}
!22 = distinct !{!22, !23, !"_ZN17bnserve_surrogate6kernel7_points6phasesB4v176B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!23 = distinct !{!23, !"_ZN17bnserve_surrogate6kernel7_points6phasesB4v176B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!24 = !{!25}
!25 = distinct !{!25, !26, !"_ZN17bnserve_surrogate6kernel7_points10fill_cellsB4v130B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedExx5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!26 = distinct !{!26, !"_ZN17bnserve_surrogate6kernel7_points10fill_cellsB4v130B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedExx5ArrayIdLi1E1C7mutable7alignedE"}
!27 = !{!28}
!28 = distinct !{!28, !29, !"_ZN17bnserve_surrogate6kernel7_points10fill_cellsB4v130B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedExx5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!29 = distinct !{!29, !"_ZN17bnserve_surrogate6kernel7_points10fill_cellsB4v130B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedExx5ArrayIdLi1E1C7mutable7alignedE"}
!30 = !{!31}
!31 = distinct !{!31, !32, !"_ZN17bnserve_surrogate6kernel7_places9find_endsB4v177B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5TupleI5ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedExdE5ArrayIdLi1E1C7mutable7alignedExdx5ArrayIxLi1E1C7mutable7alignedE: %retptr"}
!32 = distinct !{!32, !"_ZN17bnserve_surrogate6kernel7_places9find_endsB4v177B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5TupleI5ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedExdE5ArrayIdLi1E1C7mutable7alignedExdx5ArrayIxLi1E1C7mutable7alignedE"}
!33 = !{!34}
!34 = distinct !{!34, !35, !"_ZN17bnserve_surrogate6kernel7_places9find_endsB4v177B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5TupleI5ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedExdE5ArrayIdLi1E1C7mutable7alignedExdx5ArrayIxLi1E1C7mutable7alignedE: %retptr"}
!35 = distinct !{!35, !"_ZN17bnserve_surrogate6kernel7_places9find_endsB4v177B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5TupleI5ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedExdE5ArrayIdLi1E1C7mutable7alignedExdx5ArrayIxLi1E1C7mutable7alignedE"}
!36 = !{!37}
!37 = distinct !{!37, !38, !"_ZN17bnserve_surrogate6kernel7_points12extend_belowB4v178B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedExdd8UniTupleIdLi2EEd5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!38 = distinct !{!38, !"_ZN17bnserve_surrogate6kernel7_points12extend_belowB4v178B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedExdd8UniTupleIdLi2EEd5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!39 = !{!40}
!40 = distinct !{!40, !41, !"_ZN17bnserve_surrogate6kernel7_points6splineB4v182B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedExxd5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!41 = distinct !{!41, !"_ZN17bnserve_surrogate6kernel7_points6splineB4v182B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedExxd5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE"}
!42 = !{!43}
!43 = distinct !{!43, !44, !"_ZN17bnserve_surrogate6kernel7_points11polynomialsB4v183B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedExxd5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!44 = distinct !{!44, !"_ZN17bnserve_surrogate6kernel7_points11polynomialsB4v183B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedExxd5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
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
!63 = distinct !{!63, !64, !"_ZN17bnserve_surrogate6kernel7_places15first_not_belowB4v167B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedEdx: %retptr"}
!64 = distinct !{!64, !"_ZN17bnserve_surrogate6kernel7_places15first_not_belowB4v167B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedEdx"}
!65 = !{!66}
!66 = distinct !{!66, !67, !"_ZN17bnserve_surrogate6kernel7_places15first_not_belowB4v167B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedEdx: %retptr"}
!67 = distinct !{!67, !"_ZN17bnserve_surrogate6kernel7_places15first_not_belowB4v167B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedEdx"}
!68 = !{!69}
!69 = distinct !{!69, !70, !"_ZN17bnserve_surrogate6kernel7_points15spline_at_nodesB4v168B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!70 = distinct !{!70, !"_ZN17bnserve_surrogate6kernel7_points15spline_at_nodesB4v168B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE"}
!71 = !{!72}
!72 = distinct !{!72, !73, !"_ZN17bnserve_surrogate6kernel7_points16fill_polynomialsB4v175B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!73 = distinct !{!73, !"_ZN17bnserve_surrogate6kernel7_points16fill_polynomialsB4v175B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE"}
!74 = !{!75}
!75 = distinct !{!75, !76, !"_ZN17bnserve_surrogate6kernel7_points15spline_at_nodesB4v168B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!76 = distinct !{!76, !"_ZN17bnserve_surrogate6kernel7_points15spline_at_nodesB4v168B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE"}
!77 = !{!78}
!78 = distinct !{!78, !79, !"_ZN17bnserve_surrogate6kernel7_points6phasesB4v176B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!79 = distinct !{!79, !"_ZN17bnserve_surrogate6kernel7_points6phasesB4v176B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!80 = !{!81}
!81 = distinct !{!81, !82, !"_ZN17bnserve_surrogate6kernel7_points16fill_polynomialsB4v175B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!82 = distinct !{!82, !"_ZN17bnserve_surrogate6kernel7_points16fill_polynomialsB4v175B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE"}
!83 = !{!84}
!84 = distinct !{!84, !85, !"_ZN17bnserve_surrogate8baseline10_amplitude22amplitude_coefficientsB4v156B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDAxYh_2bqJnA4AOzNAE_3dEddd5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!85 = distinct !{!85, !"_ZN17bnserve_surrogate8baseline10_amplitude22amplitude_coefficientsB4v156B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDAxYh_2bqJnA4AOzNAE_3dEddd5ArrayIdLi1E1C7mutable7alignedE"}
!86 = !{!87}
!87 = distinct !{!87, !88, !"_ZN17bnserve_surrogate8baseline6_phase18phase_coefficientsB4v159B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDAxYh_2bqJnA4AOzNAE_3dEddddd5ArrayIdLi2E1C7mutable7alignedE: %retptr"}
!88 = distinct !{!88, !"_ZN17bnserve_surrogate8baseline6_phase18phase_coefficientsB4v159B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDAxYh_2bqJnA4AOzNAE_3dEddddd5ArrayIdLi2E1C7mutable7alignedE"}
!89 = !{!90, !87}
!90 = distinct !{!90, !91, !"_ZN17bnserve_surrogate8baseline6_phase20add_point_mass_phaseB4v160B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDAxYh_2bqJnA4AOzNAE_3dEd5ArrayIdLi2E1C7mutable7alignedE: %retptr"}
!91 = distinct !{!91, !"_ZN17bnserve_surrogate8baseline6_phase20add_point_mass_phaseB4v160B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDAxYh_2bqJnA4AOzNAE_3dEd5ArrayIdLi2E1C7mutable7alignedE"}
!92 = !{!93, !87}
!93 = distinct !{!93, !94, !"_ZN17bnserve_surrogate8baseline6_phase20add_spin_orbit_phaseB4v161B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDAxYh_2bqJnA4AOzNAE_3dEdd5ArrayIdLi2E1C7mutable7alignedE: %retptr"}
!94 = distinct !{!94, !"_ZN17bnserve_surrogate8baseline6_phase20add_spin_orbit_phaseB4v161B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDAxYh_2bqJnA4AOzNAE_3dEdd5ArrayIdLi2E1C7mutable7alignedE"}
!95 = !{!96, !87}
!96 = distinct !{!96, !97, !"_ZN17bnserve_surrogate8baseline6_phase20add_spin_orbit_phaseB4v161B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDAxYh_2bqJnA4AOzNAE_3dEdd5ArrayIdLi2E1C7mutable7alignedE: %retptr"}
!97 = distinct !{!97, !"_ZN17bnserve_surrogate8baseline6_phase20add_spin_orbit_phaseB4v161B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDAxYh_2bqJnA4AOzNAE_3dEdd5ArrayIdLi2E1C7mutable7alignedE"}
!98 = !{!99, !87}
!99 = distinct !{!99, !100, !"_ZN17bnserve_surrogate8baseline6_phase19add_self_spin_phaseB4v163B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDAxYh_2bqJnA4AOzNAE_3dEddd5ArrayIdLi2E1C7mutable7alignedE: %retptr"}
!100 = distinct !{!100, !"_ZN17bnserve_surrogate8baseline6_phase19add_self_spin_phaseB4v163B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDAxYh_2bqJnA4AOzNAE_3dEddd5ArrayIdLi2E1C7mutable7alignedE"}
!101 = !{!102, !87}
!102 = distinct !{!102, !103, !"_ZN17bnserve_surrogate8baseline6_phase19add_self_spin_phaseB4v163B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDAxYh_2bqJnA4AOzNAE_3dEddd5ArrayIdLi2E1C7mutable7alignedE: %retptr"}
!103 = distinct !{!103, !"_ZN17bnserve_surrogate8baseline6_phase19add_self_spin_phaseB4v163B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDAxYh_2bqJnA4AOzNAE_3dEddd5ArrayIdLi2E1C7mutable7alignedE"}
!104 = !{!105, !87}
!105 = distinct !{!105, !106, !"_ZN17bnserve_surrogate8baseline6_phase19add_spin_spin_phaseB4v164B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDAxYh_2bqJnA4AOzNAE_3dEddd5ArrayIdLi2E1C7mutable7alignedE: %retptr"}
!106 = distinct !{!106, !"_ZN17bnserve_surrogate8baseline6_phase19add_spin_spin_phaseB4v164B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDAxYh_2bqJnA4AOzNAE_3dEddd5ArrayIdLi2E1C7mutable7alignedE"}
!107 = !{!108, !87}
!108 = distinct !{!108, !109, !"_ZN17bnserve_surrogate8baseline6_phase15add_tidal_phaseB4v165B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDAxYh_2bqJnA4AOzNAE_3dEdd5ArrayIdLi2E1C7mutable7alignedE: %retptr"}
!109 = distinct !{!109, !"_ZN17bnserve_surrogate8baseline6_phase15add_tidal_phaseB4v165B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDAxYh_2bqJnA4AOzNAE_3dEdd5ArrayIdLi2E1C7mutable7alignedE"}
!110 = !{!111, !87}
!111 = distinct !{!111, !112, !"_ZN17bnserve_surrogate8baseline6_phase15add_tidal_phaseB4v165B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDAxYh_2bqJnA4AOzNAE_3dEdd5ArrayIdLi2E1C7mutable7alignedE: %retptr"}
!112 = distinct !{!112, !"_ZN17bnserve_surrogate8baseline6_phase15add_tidal_phaseB4v165B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDAxYh_2bqJnA4AOzNAE_3dEdd5ArrayIdLi2E1C7mutable7alignedE"}
!113 = !{!114, !116}
!114 = distinct !{!114, !115, !"_ZN17bnserve_surrogate6kernel7_series9_legendreB4v166B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dEd5ArrayIdLi2E1C7mutable7alignedE: %retptr"}
!115 = distinct !{!115, !"_ZN17bnserve_surrogate6kernel7_series9_legendreB4v166B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dEd5ArrayIdLi2E1C7mutable7alignedE"}
!116 = distinct !{!116, !115, !"_ZN17bnserve_surrogate6kernel7_series9_legendreB4v166B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dEd5ArrayIdLi2E1C7mutable7alignedE: %excinfo"}
!117 = !{!118}
!118 = distinct !{!118, !119, !"_ZN17bnserve_surrogate6kernel8_writing9_streamedB4v193B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedExxb23Literal_5bint_5d_288_29: %retptr"}
!119 = distinct !{!119, !"_ZN17bnserve_surrogate6kernel8_writing9_streamedB4v193B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedExxb23Literal_5bint_5d_288_29"}
!120 = !{!121}
!121 = distinct !{!121, !122, !"_ZN17bnserve_surrogate6kernel8_writing9_streamedB4v199B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedExxb24Literal_5bint_5d_2816_29: %retptr"}
!122 = distinct !{!122, !"_ZN17bnserve_surrogate6kernel8_writing9_streamedB4v199B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedExxb24Literal_5bint_5d_2816_29"}
!123 = !{i32 1}
!124 = distinct !{!124, !52}
!125 = distinct !{!125, !52}
!126 = distinct !{!126, !52}
!127 = distinct !{!127, !52}
!128 = !{!129}
!129 = distinct !{!129, !130, !"_ZN17bnserve_surrogate12_coordinates18transform_physicalB3v38B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDAxYh_2bqJnA4AOzNAE_3dEddddd5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!130 = distinct !{!130, !"_ZN17bnserve_surrogate12_coordinates18transform_physicalB3v38B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDAxYh_2bqJnA4AOzNAE_3dEddddd5ArrayIdLi1E1C7mutable7alignedE"}
!131 = !{!132, !134}
!132 = distinct !{!132, !133, !"_ZN17bnserve_surrogate12_coordinates18transform_physicalB3v40B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDAxYh_2bqJnA4AOzNAE_3dEddddd5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!133 = distinct !{!133, !"_ZN17bnserve_surrogate12_coordinates18transform_physicalB3v40B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDAxYh_2bqJnA4AOzNAE_3dEddddd5ArrayIdLi1E1C7mutable7alignedE"}
!134 = distinct !{!134, !135, !"_ZN17bnserve_surrogate12_coordinates19transform_symmetricB3v39B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDAxYh_2bqJnA4AOzNAE_3dEddddd5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!135 = distinct !{!135, !"_ZN17bnserve_surrogate12_coordinates19transform_symmetricB3v39B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDAxYh_2bqJnA4AOzNAE_3dEddddd5ArrayIdLi1E1C7mutable7alignedE"}
!136 = !{!134}
!137 = !{!138}
!138 = distinct !{!138, !139, !"_ZN17bnserve_surrogate6kernel9_matrices8multiplyB3v55B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIdLi1E1C7mutable7alignedEx23Literal_5bint_5d_281_295ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedEx: %retptr"}
!139 = distinct !{!139, !"_ZN17bnserve_surrogate6kernel9_matrices8multiplyB3v55B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIdLi1E1C7mutable7alignedEx23Literal_5bint_5d_281_295ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedEx"}
