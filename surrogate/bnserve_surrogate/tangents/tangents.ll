; sources: a84340a25497b3ac77c9daab7496cece06bdd9dee10d2a2016fbf107908543ea
; built by: numba 0.68.1, llvmlite 0.50.0, Python 3.11, x86_64
; ModuleID = '<string>'
source_filename = "<string>"


; Function Attrs: nofree norecurse nosync nounwind memory(readwrite, inaccessiblemem: none, target_mem0: none, target_mem1: none)
define noundef range(i32 0, 2) i32 @bnserve_differentiate(ptr noalias writeonly captures(none) %retptr, ptr noalias writeonly captures(none) %excinfo, ptr readonly captures(none) %arg.arguments) local_unnamed_addr #0 {
entry:
  %.852.i.i = alloca ptr, align 8
  %.972.i.i = alloca ptr, align 8
  %.1246.i = alloca ptr, align 8
  %.2840.i = alloca ptr, align 8
  %excinfo.28.i = alloca ptr, align 8
  %.47.i = load i64, ptr %arg.arguments, align 8, !noalias !0
  %0 = add i64 %.47.i, 7
  %.112.i = lshr i64 %0, 3
  %.89.inv.i = icmp slt i64 %.47.i, 1
  %.13369.not76.i = icmp eq i64 %.112.i, 0
  %.13369.not.i = or i1 %.89.inv.i, %.13369.not76.i
  br i1 %.13369.not.i, label %B0.endif.endif, label %B84.if.preheader.i

B84.if.preheader.i:                               ; preds = %entry
  %1 = add nuw nsw i64 %.112.i, 2
  %.53.i = getelementptr i8, ptr %arg.arguments, i64 64
  %.134.i = getelementptr i8, ptr %arg.arguments, i64 72
  %.231.i = getelementptr i8, ptr %arg.arguments, i64 80
  %.310.i = getelementptr i8, ptr %arg.arguments, i64 104
  %.407.i = getelementptr i8, ptr %arg.arguments, i64 8
  %.494.i = getelementptr i8, ptr %arg.arguments, i64 152
  %.955.i = getelementptr i8, ptr %arg.arguments, i64 168
  %sunkaddr39.i = getelementptr i8, ptr %arg.arguments, i64 16
  %sunkaddr40.i = getelementptr i8, ptr %arg.arguments, i64 128
  br label %B84.if.i

B84.if.i:                                         ; preds = %B84.backedge.i, %B84.if.preheader.i
  %excinfo.2.i.0 = phi ptr [ null, %B84.if.preheader.i ], [ %excinfo.2.i.1, %B84.backedge.i ]
  %lsr.iv = phi i64 [ %1, %B84.if.preheader.i ], [ %lsr.iv.next, %B84.backedge.i ]
  %.1396770.i = phi i64 [ 0, %B84.if.preheader.i ], [ %2, %B84.backedge.i ]
  %2 = add nuw i64 %.1396770.i, 8
  %.13.i.i = tail call i64 @llvm.smin.i64(i64 %.47.i, i64 %2)
  call void @llvm.lifetime.start.p0(ptr nonnull %.1246.i)
  call void @llvm.lifetime.start.p0(ptr nonnull %.2840.i)
  call void @llvm.lifetime.start.p0(ptr nonnull %excinfo.28.i)
  store ptr null, ptr %.1246.i, align 8, !noalias !4
  store ptr null, ptr %.2840.i, align 8, !noalias !4
  store ptr null, ptr %excinfo.28.i, align 8, !noalias !4
  %.54.i = load i64, ptr %.53.i, align 8, !noalias !4
  %.55.i = inttoptr i64 %.54.i to ptr
  %.135.i = load i64, ptr %.134.i, align 8, !noalias !4
  %.232.i = load i64, ptr %.231.i, align 8, !noalias !4
  %.233.i = inttoptr i64 %.232.i to ptr
  %.311.i = load i64, ptr %.310.i, align 8, !noalias !4
  %.312.i = inttoptr i64 %.311.i to ptr
  %.408.i = load i64, ptr %.407.i, align 8, !noalias !4
  %.411.i = inttoptr i64 %.408.i to ptr
  %.495.i = load i64, ptr %.494.i, align 8, !noalias !4
  %.564.i = getelementptr inbounds nuw i8, ptr %.312.i, i64 640
  call void @llvm.lifetime.start.p0(ptr nonnull %.972.i.i), !noalias !4
  store ptr null, ptr %.972.i.i, align 8, !noalias !8
  %.254.i.i = getelementptr i8, ptr %.55.i, i64 80
  %.255.i.i = load i64, ptr %.254.i.i, align 8, !noalias !8
  %.268.i.i = getelementptr inbounds double, ptr %.233.i, i64 %.255.i.i
  %.446.i.i = add nsw i64 %.13.i.i, -1
  %scevgep.i1.i = getelementptr i8, ptr %.312.i, i64 32
  %.121.i.i.i = getelementptr i8, ptr %.268.i.i, i64 80
  %sunkaddr6.i.i.i = getelementptr i8, ptr %.268.i.i, i64 40
  %sunkaddr7.i.i.i = getelementptr i8, ptr %.268.i.i, i64 48
  %sunkaddr8.i.i.i = getelementptr i8, ptr %.268.i.i, i64 56
  %sunkaddr9.i.i.i = getelementptr i8, ptr %.268.i.i, i64 64
  %sunkaddr.i.i.i = getelementptr i8, ptr %.268.i.i, i64 72
  br label %B226.if.i.i

B226.if.i.i:                                      ; preds = %_ZN17bnserve_surrogate8tangents12_coordinates13fill_jacobianB3v42B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE.exit.i.i, %B84.if.i
  %lsr.iv.i.i = phi ptr [ %scevgep.i1.i, %B84.if.i ], [ %scevgep77.i.i, %_ZN17bnserve_surrogate8tangents12_coordinates13fill_jacobianB3v42B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE.exit.i.i ]
  %.410605609.i.i = phi i64 [ 0, %B84.if.i ], [ %.417.i.i, %_ZN17bnserve_surrogate8tangents12_coordinates13fill_jacobianB3v42B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE.exit.i.i ]
  %3 = add nuw nsw i64 %.410605609.i.i, %.1396770.i
  %.13.i.i.i = tail call i64 @llvm.smin.i64(i64 %.446.i.i, i64 %3)
  %.486.idx.i.i = mul nsw i64 %.13.i.i.i, 80
  %.486.i.i = getelementptr inbounds i8, ptr %.411.i, i64 %.486.idx.i.i
  %.565.i.i = load double, ptr %.486.i.i, align 8, !noalias !8
  %.593.i.i = getelementptr i8, ptr %.486.i.i, i64 24
  %.594.i.i = load double, ptr %.593.i.i, align 8, !noalias !8
  %scevgep78.i.i = getelementptr i8, ptr %lsr.iv.i.i, i64 -32
  store double %.565.i.i, ptr %scevgep78.i.i, align 8, !noalias !8
  %scevgep79.i.i = getelementptr i8, ptr %lsr.iv.i.i, i64 -24
  store double %.594.i.i, ptr %scevgep79.i.i, align 8, !noalias !8
  %.685.i.i = getelementptr i8, ptr %.486.i.i, i64 32
  %.686.i.i = load double, ptr %.685.i.i, align 8, !noalias !8
  %.714.i.i = getelementptr i8, ptr %.486.i.i, i64 8
  %.715.i.i = load double, ptr %.714.i.i, align 8, !noalias !8
  %scevgep80.i.i = getelementptr i8, ptr %lsr.iv.i.i, i64 -16
  store double %.686.i.i, ptr %scevgep80.i.i, align 8, !noalias !8
  %scevgep81.i.i = getelementptr i8, ptr %lsr.iv.i.i, i64 -8
  store double %.715.i.i, ptr %scevgep81.i.i, align 8, !noalias !8
  %.807.i.i = getelementptr i8, ptr %.486.i.i, i64 16
  %.808.i.i = load double, ptr %.807.i.i, align 8, !noalias !8
  store double %.808.i.i, ptr %lsr.iv.i.i, align 8, !noalias !8
  %.89.i.i.i = load i64, ptr %.55.i, align 8, !noalias !11
  %.122.i.i.i = load double, ptr %.121.i.i.i, align 8, !noalias !11
  %4 = shl i64 %.410605609.i.i, 3
  %scevgep15.i.i.i = getelementptr i8, ptr %.564.i, i64 %4
  store double 0.000000e+00, ptr %scevgep15.i.i.i, align 8, !noalias !11
  %scevgep20.i.i.i = getelementptr i8, ptr %scevgep15.i.i.i, i64 64
  store double 0.000000e+00, ptr %scevgep20.i.i.i, align 8, !noalias !11
  %scevgep22.i.i.i = getelementptr i8, ptr %scevgep15.i.i.i, i64 128
  store double 0.000000e+00, ptr %scevgep22.i.i.i, align 8, !noalias !11
  %scevgep20.1.i.i.i = getelementptr i8, ptr %scevgep15.i.i.i, i64 192
  store double 0.000000e+00, ptr %scevgep20.1.i.i.i, align 8, !noalias !11
  %scevgep22.1.i.i.i = getelementptr i8, ptr %scevgep15.i.i.i, i64 256
  store double 0.000000e+00, ptr %scevgep22.1.i.i.i, align 8, !noalias !11
  %scevgep20.2.i.i.i = getelementptr i8, ptr %scevgep15.i.i.i, i64 320
  store double 0.000000e+00, ptr %scevgep20.2.i.i.i, align 8, !noalias !11
  %scevgep22.2.i.i.i = getelementptr i8, ptr %scevgep15.i.i.i, i64 384
  store double 0.000000e+00, ptr %scevgep22.2.i.i.i, align 8, !noalias !11
  %scevgep20.3.i.i.i = getelementptr i8, ptr %scevgep15.i.i.i, i64 448
  store double 0.000000e+00, ptr %scevgep20.3.i.i.i, align 8, !noalias !11
  %scevgep22.3.i.i.i = getelementptr i8, ptr %scevgep15.i.i.i, i64 512
  store double 0.000000e+00, ptr %scevgep22.3.i.i.i, align 8, !noalias !11
  %scevgep20.4.i.i.i = getelementptr i8, ptr %scevgep15.i.i.i, i64 576
  store double 0.000000e+00, ptr %scevgep20.4.i.i.i, align 8, !noalias !11
  %scevgep22.4.i.i.i = getelementptr i8, ptr %scevgep15.i.i.i, i64 640
  store double 0.000000e+00, ptr %scevgep22.4.i.i.i, align 8, !noalias !11
  %scevgep20.5.i.i.i = getelementptr i8, ptr %scevgep15.i.i.i, i64 704
  store double 0.000000e+00, ptr %scevgep20.5.i.i.i, align 8, !noalias !11
  %scevgep22.5.i.i.i = getelementptr i8, ptr %scevgep15.i.i.i, i64 768
  store double 0.000000e+00, ptr %scevgep22.5.i.i.i, align 8, !noalias !11
  %scevgep20.6.i.i.i = getelementptr i8, ptr %scevgep15.i.i.i, i64 832
  store double 0.000000e+00, ptr %scevgep20.6.i.i.i, align 8, !noalias !11
  %scevgep22.6.i.i.i = getelementptr i8, ptr %scevgep15.i.i.i, i64 896
  store double 0.000000e+00, ptr %scevgep22.6.i.i.i, align 8, !noalias !11
  %scevgep20.7.i.i.i = getelementptr i8, ptr %scevgep15.i.i.i, i64 960
  store double 0.000000e+00, ptr %scevgep20.7.i.i.i, align 8, !noalias !11
  %scevgep22.7.i.i.i = getelementptr i8, ptr %scevgep15.i.i.i, i64 1024
  store double 0.000000e+00, ptr %scevgep22.7.i.i.i, align 8, !noalias !11
  %scevgep20.8.i.i.i = getelementptr i8, ptr %scevgep15.i.i.i, i64 1088
  store double 0.000000e+00, ptr %scevgep20.8.i.i.i, align 8, !noalias !11
  %scevgep22.8.i.i.i = getelementptr i8, ptr %scevgep15.i.i.i, i64 1152
  store double 0.000000e+00, ptr %scevgep22.8.i.i.i, align 8, !noalias !11
  %scevgep20.9.i.i.i = getelementptr i8, ptr %scevgep15.i.i.i, i64 1216
  store double 0.000000e+00, ptr %scevgep20.9.i.i.i, align 8, !noalias !11
  %scevgep22.9.i.i.i = getelementptr i8, ptr %scevgep15.i.i.i, i64 1280
  store double 0.000000e+00, ptr %scevgep22.9.i.i.i, align 8, !noalias !11
  %scevgep20.10.i.i.i = getelementptr i8, ptr %scevgep15.i.i.i, i64 1344
  store double 0.000000e+00, ptr %scevgep20.10.i.i.i, align 8, !noalias !11
  %scevgep22.10.i.i.i = getelementptr i8, ptr %scevgep15.i.i.i, i64 1408
  store double 0.000000e+00, ptr %scevgep22.10.i.i.i, align 8, !noalias !11
  %scevgep20.11.i.i.i = getelementptr i8, ptr %scevgep15.i.i.i, i64 1472
  store double 0.000000e+00, ptr %scevgep20.11.i.i.i, align 8, !noalias !11
  %scevgep22.11.i.i.i = getelementptr i8, ptr %scevgep15.i.i.i, i64 1536
  store double 0.000000e+00, ptr %scevgep22.11.i.i.i, align 8, !noalias !11
  %.288.i.i.i = icmp eq i64 %.89.i.i.i, 0
  br i1 %.288.i.i.i, label %B162.i.i.i, label %B550.i.i.i

B162.i.i.i:                                       ; preds = %B226.if.i.i
  %5 = getelementptr double, ptr %.564.i, i64 %.410605609.i.i
  store double 1.000000e+00, ptr %5, align 8, !noalias !11
  %6 = getelementptr i8, ptr %5, i64 1024
  store double 1.000000e+00, ptr %6, align 8, !noalias !11
  %7 = getelementptr i8, ptr %5, i64 1408
  store double 1.000000e+00, ptr %7, align 8, !noalias !11
  %.448.i.i.i = load double, ptr %.714.i.i, align 8, !noalias !11
  %.450.i.i.i = fcmp contract oge double %.448.i.i.i, %.122.i.i.i
  %..i.i.i = select i1 %.450.i.i.i, double 1.000000e+00, double 0.000000e+00
  %8 = getelementptr i8, ptr %5, i64 512
  store double %..i.i.i, ptr %8, align 8, !noalias !11
  %.545.i.i.i = load double, ptr %.807.i.i, align 8, !noalias !11
  %.552.i.i.i = fcmp contract oge double %.545.i.i.i, %.122.i.i.i
  %"$phi528.4.2.0.i.i.i" = select i1 %.552.i.i.i, double 1.000000e+00, double 0.000000e+00
  %9 = getelementptr i8, ptr %5, i64 896
  store double %"$phi528.4.2.0.i.i.i", ptr %9, align 8, !noalias !11
  br label %B646.if.i.i.i.preheader

B550.i.i.i:                                       ; preds = %B226.if.i.i
  %.622.not.i.i.i = icmp eq i64 %.89.i.i.i, 2
  %.79.i.i.i.i = load double, ptr %.486.i.i, align 8, !noalias !14
  %.109.i.i.i.i = load double, ptr %.593.i.i, align 8, !noalias !14
  %.139.i.i.i.i = load double, ptr %.685.i.i, align 8, !noalias !14
  %.140.i.i.i.i = fadd contract double %.79.i.i.i.i, 1.000000e+00
  %.144.i.i.i.i = fdiv contract double %.79.i.i.i.i, %.140.i.i.i.i
  %.149.i.i.i.i = fdiv contract double 1.000000e+00, %.140.i.i.i.i
  %.158.i.i.i.i = fmul contract double %.149.i.i.i.i, %.149.i.i.i.i
  %.163.i.i.i.i = fdiv contract double 1.000000e+00, %.79.i.i.i.i
  %10 = getelementptr double, ptr %.564.i, i64 %.410605609.i.i
  store double %.163.i.i.i.i, ptr %10, align 8, !noalias !14
  %.207.i.i.i.i = fsub contract double %.149.i.i.i.i, %.144.i.i.i.i
  %.208.i.i.i.i = fmul contract double %.158.i.i.i.i, %.207.i.i.i.i
  %.209.i.i.i.i = fsub contract double %.109.i.i.i.i, %.139.i.i.i.i
  %.210.i.i.i.i = fmul contract double %.158.i.i.i.i, %.209.i.i.i.i
  %.211.i.i.i.i = fmul contract double %.208.i.i.i.i, 0x3FD585A9E9585A9F
  %.212.i.i.i.i = fadd contract double %.109.i.i.i.i, %.139.i.i.i.i
  %.213.i.i.i.i = fmul contract double %.212.i.i.i.i, %.211.i.i.i.i
  %.214.i.i.i.i = fsub contract double %.210.i.i.i.i, %.213.i.i.i.i
  %11 = getelementptr i8, ptr %10, i64 192
  store double %.214.i.i.i.i, ptr %11, align 8, !noalias !14
  %.259.i.i.i.i = fmul contract double %.144.i.i.i.i, 0x3FD585A9E9585A9F
  %.261.i.i.i.i = fmul contract double %.149.i.i.i.i, %.259.i.i.i.i
  %.263.i.i.i.i = fsub contract double %.144.i.i.i.i, %.261.i.i.i.i
  %12 = getelementptr i8, ptr %10, i64 1152
  store double %.263.i.i.i.i, ptr %12, align 8, !noalias !14
  %.311.i.i.i.i = fsub contract double %.149.i.i.i.i, %.261.i.i.i.i
  %13 = getelementptr i8, ptr %10, i64 1472
  store double %.311.i.i.i.i, ptr %13, align 8, !noalias !14
  %14 = getelementptr i8, ptr %10, i64 1216
  store double 5.000000e-01, ptr %14, align 8, !noalias !14
  %15 = getelementptr i8, ptr %10, i64 1536
  store double -5.000000e-01, ptr %15, align 8, !noalias !14
  %.466.i.i.i.i = load double, ptr %.714.i.i, align 8, !noalias !14
  %.12.i.i.i.i.i = fcmp contract ogt double %.122.i.i.i, %.466.i.i.i.i
  %.13.i.i.i.i.i = select i1 %.12.i.i.i.i.i, double %.122.i.i.i, double %.466.i.i.i.i
  %.527.i.i.i.i = load double, ptr %.807.i.i, align 8, !noalias !14
  %.12.i1.i.i.i.i = fcmp contract ogt double %.122.i.i.i, %.527.i.i.i.i
  %.13.i2.i.i.i.i = select i1 %.12.i1.i.i.i.i, double %.122.i.i.i, double %.527.i.i.i.i
  %.564.i.i.i.i = tail call contract double @llvm.pow.f64(double %.13.i.i.i.i.i, double 4.000000e-01)
  %.566.i.i.i.i = tail call contract double @llvm.pow.f64(double %.13.i2.i.i.i.i, double 4.000000e-01)
  %.574.i.i.i.i = fmul contract double %.158.i.i.i.i, %.564.i.i.i.i
  %.576.i.i.i.i = fmul contract double %.158.i.i.i.i, %.566.i.i.i.i
  %.577.i.i.i.i = fsub contract double 0.000000e+00, %.576.i.i.i.i
  %.618.i.i.i.i = fcmp contract oge double %.466.i.i.i.i, %.122.i.i.i
  %.621.i.i.i.i = fcmp contract ogt double %.13.i.i.i.i.i, 0.000000e+00
  %or.cond.i.i.i.i = select i1 %.618.i.i.i.i, i1 %.621.i.i.i.i, i1 false
  %.624.i.i.i.i = fmul contract double %.144.i.i.i.i, 4.000000e-01
  %.628.i.i.i.i = fmul contract double %.624.i.i.i.i, %.564.i.i.i.i
  %.635.i.i.i.i = fdiv contract double %.628.i.i.i.i, %.13.i.i.i.i.i
  %"$phi914.0.2.0.i.i.i.i" = select i1 %or.cond.i.i.i.i, double %.635.i.i.i.i, double 0.000000e+00
  %.693.i.i.i.i = fcmp contract oge double %.527.i.i.i.i, %.122.i.i.i
  %.698.i.i.i.i = fcmp contract ogt double %.13.i2.i.i.i.i, 0.000000e+00
  %or.cond347.i.i.i.i = select i1 %.693.i.i.i.i, i1 %.698.i.i.i.i, i1 false
  %.701.i.i.i.i = fmul contract double %.149.i.i.i.i, 4.000000e-01
  %.705.i.i.i.i = fmul contract double %.701.i.i.i.i, %.566.i.i.i.i
  %.712.i.i.i.i = fdiv contract double %.705.i.i.i.i, %.13.i2.i.i.i.i
  %"$phi1006.0.2.0.i.i.i.i" = select i1 %or.cond347.i.i.i.i, double %.712.i.i.i.i, double 0.000000e+00
  br i1 %.622.not.i.i.i, label %B1012.i.i.i.i, label %B1430.i.i.i.i

B1012.i.i.i.i:                                    ; preds = %B550.i.i.i
  %.743.i.i.i.i = fsub contract double %.574.i.i.i.i, %.577.i.i.i.i
  %16 = getelementptr i8, ptr %10, i64 64
  store double %.743.i.i.i.i, ptr %16, align 8, !noalias !14
  %.794.i.i.i.i = fadd contract double %.574.i.i.i.i, %.577.i.i.i.i
  %17 = getelementptr i8, ptr %10, i64 128
  store double %.794.i.i.i.i, ptr %17, align 8, !noalias !14
  %18 = getelementptr i8, ptr %10, i64 384
  store double %"$phi914.0.2.0.i.i.i.i", ptr %18, align 8, !noalias !14
  %19 = getelementptr i8, ptr %10, i64 448
  store double %"$phi914.0.2.0.i.i.i.i", ptr %19, align 8, !noalias !14
  %.926.i.i.i.i = fsub contract double 0.000000e+00, %"$phi1006.0.2.0.i.i.i.i"
  br label %_ZN17bnserve_surrogate8tangents12_coordinates9_physicalB3v48B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedEdbx5ArrayIdLi1E1C7mutable7alignedE.exit.i.i.i

B1430.i.i.i.i:                                    ; preds = %B550.i.i.i
  %20 = getelementptr i8, ptr %10, i64 64
  store double %.574.i.i.i.i, ptr %20, align 8, !noalias !14
  %21 = getelementptr i8, ptr %10, i64 128
  store double %.577.i.i.i.i, ptr %21, align 8, !noalias !14
  br label %_ZN17bnserve_surrogate8tangents12_coordinates9_physicalB3v48B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedEdbx5ArrayIdLi1E1C7mutable7alignedE.exit.i.i.i

_ZN17bnserve_surrogate8tangents12_coordinates9_physicalB3v48B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedEdbx5ArrayIdLi1E1C7mutable7alignedE.exit.i.i.i: ; preds = %B1430.i.i.i.i, %B1012.i.i.i.i
  %.sink3.i.i.i.i = phi i64 [ 384, %B1430.i.i.i.i ], [ 704, %B1012.i.i.i.i ]
  %"$phi914.0.2.0.sink.i.i.i.i" = phi double [ %"$phi914.0.2.0.i.i.i.i", %B1430.i.i.i.i ], [ %.926.i.i.i.i, %B1012.i.i.i.i ]
  %22 = getelementptr i8, ptr %10, i64 %.sink3.i.i.i.i
  store double %"$phi914.0.2.0.sink.i.i.i.i", ptr %22, align 8, !noalias !14
  %23 = getelementptr i8, ptr %10, i64 768
  store double %"$phi1006.0.2.0.i.i.i.i", ptr %23, align 8, !noalias !14
  br label %B646.if.i.i.i.preheader

B646.if.i.i.i.preheader:                          ; preds = %_ZN17bnserve_surrogate8tangents12_coordinates9_physicalB3v48B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedEdbx5ArrayIdLi1E1C7mutable7alignedE.exit.i.i.i, %B162.i.i.i
  br label %B646.if.i.i.i

B646.if.i.i.i:                                    ; preds = %B646.if.i.i.i.preheader, %B646.if.i.i.i
  %lsr.iv.i.i.i = phi i64 [ %lsr.iv.next.i.i.i, %B646.if.i.i.i ], [ 0, %B646.if.i.i.i.preheader ]
  %24 = shl nuw nsw i64 %lsr.iv.i.i.i, 3
  %scevgep5.i.i.i = getelementptr i8, ptr %scevgep15.i.i.i, i64 %24
  %.938.i.i.i = load double, ptr %scevgep5.i.i.i, align 8, !noalias !11
  %.969.i.i.i = load double, ptr %sunkaddr6.i.i.i, align 8, !noalias !11
  %.970.i.i.i = fmul contract double %.938.i.i.i, %.969.i.i.i
  store double %.970.i.i.i, ptr %scevgep5.i.i.i, align 8, !noalias !11
  %scevgep4.i.i.i = getelementptr i8, ptr %scevgep20.i.i.i, i64 %24
  %.938.1.i.i.i = load double, ptr %scevgep4.i.i.i, align 8, !noalias !11
  %.969.1.i.i.i = load double, ptr %sunkaddr7.i.i.i, align 8, !noalias !11
  %.970.1.i.i.i = fmul contract double %.938.1.i.i.i, %.969.1.i.i.i
  store double %.970.1.i.i.i, ptr %scevgep4.i.i.i, align 8, !noalias !11
  %scevgep3.i.i.i = getelementptr i8, ptr %scevgep22.i.i.i, i64 %24
  %.938.2.i.i.i = load double, ptr %scevgep3.i.i.i, align 8, !noalias !11
  %.969.2.i.i.i = load double, ptr %sunkaddr8.i.i.i, align 8, !noalias !11
  %.970.2.i.i.i = fmul contract double %.938.2.i.i.i, %.969.2.i.i.i
  store double %.970.2.i.i.i, ptr %scevgep3.i.i.i, align 8, !noalias !11
  %scevgep2.i.i.i = getelementptr i8, ptr %scevgep20.1.i.i.i, i64 %24
  %.938.3.i.i.i = load double, ptr %scevgep2.i.i.i, align 8, !noalias !11
  %.969.3.i.i.i = load double, ptr %sunkaddr9.i.i.i, align 8, !noalias !11
  %.970.3.i.i.i = fmul contract double %.938.3.i.i.i, %.969.3.i.i.i
  store double %.970.3.i.i.i, ptr %scevgep2.i.i.i, align 8, !noalias !11
  %scevgep1.i.i.i = getelementptr i8, ptr %scevgep22.1.i.i.i, i64 %24
  %.938.4.i.i.i = load double, ptr %scevgep1.i.i.i, align 8, !noalias !11
  %.969.4.i.i.i = load double, ptr %sunkaddr.i.i.i, align 8, !noalias !11
  %.970.4.i.i.i = fmul contract double %.938.4.i.i.i, %.969.4.i.i.i
  store double %.970.4.i.i.i, ptr %scevgep1.i.i.i, align 8, !noalias !11
  %lsr.iv.next.i.i.i = add nuw nsw i64 %lsr.iv.i.i.i, 40
  %exitcond357.not.i.i.i = icmp eq i64 %lsr.iv.next.i.i.i, 200
  br i1 %exitcond357.not.i.i.i, label %_ZN17bnserve_surrogate8tangents12_coordinates13fill_jacobianB3v42B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE.exit.i.i, label %B646.if.i.i.i

_ZN17bnserve_surrogate8tangents12_coordinates13fill_jacobianB3v42B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE.exit.i.i: ; preds = %B646.if.i.i.i
  %.417.i.i = add nuw nsw i64 %.410605609.i.i, 1
  %scevgep77.i.i = getelementptr i8, ptr %lsr.iv.i.i, i64 40
  %exitcond.not.i.i = icmp eq i64 %.417.i.i, 8
  br i1 %exitcond.not.i.i, label %_ZN17bnserve_surrogate8tangents7_source12_coordinatesB3v36B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i, label %B226.if.i.i

_ZN17bnserve_surrogate8tangents7_source12_coordinatesB3v36B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i: ; preds = %_ZN17bnserve_surrogate8tangents12_coordinates13fill_jacobianB3v42B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE.exit.i.i
  %.156.i.i = getelementptr inbounds nuw i8, ptr %.312.i, i64 320
  %.917.i.i = getelementptr inbounds nuw i8, ptr %.312.i, i64 2240
  store ptr null, ptr %.972.i.i, align 8, !noalias !8
  call fastcc void @inner_0(ptr nonnull %.972.i.i, ptr %.312.i, ptr nonnull readonly %.55.i, ptr readonly %.268.i.i, ptr nonnull %.917.i.i, ptr nonnull %.156.i.i)
  call void @llvm.lifetime.end.p0(ptr nonnull %.972.i.i), !noalias !4
  %.709.i = getelementptr i8, ptr %.55.i, i64 56
  %.710.i = load i64, ptr %.709.i, align 8, !noalias !4
  %.711.i = sub i64 0, %.710.i
  %.719.1.i = and i64 %.711.i, -8
  %.753.i = sub i64 0, %.719.1.i
  %.783.i = getelementptr i8, ptr %.55.i, i64 64
  %.784.i = load i64, ptr %.783.i, align 8, !noalias !4
  %.785.i = sub i64 0, %.784.i
  %.793.1.i = and i64 %.785.i, -8
  %.827.i = sub i64 0, %.793.1.i
  %25 = add i64 %.793.1.i, %.719.1.i
  %.neg.i = mul i64 %25, -2
  %.843.i = or disjoint i64 %.neg.i, 8
  %.862.i = getelementptr inbounds nuw i8, ptr %.312.i, i64 2560
  %.956.i = load i64, ptr %.955.i, align 8, !noalias !4
  %.957.not.i = icmp eq i64 %.956.i, 0
  br i1 %.957.not.i, label %B1014.i, label %B906.i

B906.i:                                           ; preds = %_ZN17bnserve_surrogate8tangents7_source12_coordinatesB3v36B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i
  %.990.i = inttoptr i64 %.956.i to ptr
  %.1065.i = getelementptr i8, ptr %.990.i, i64 24
  %.1066.i = load i64, ptr %.1065.i, align 8, !noalias !4
  br label %B1014.i

B1014.i:                                          ; preds = %B906.i, %_ZN17bnserve_surrogate8tangents7_source12_coordinatesB3v36B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i
  %"$phi1014.0.2.0.i" = phi i64 [ %.1066.i, %B906.i ], [ 0, %_ZN17bnserve_surrogate8tangents7_source12_coordinatesB3v36B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i ]
  %26 = inttoptr i64 %.135.i to ptr
  %.idx = mul i64 %.843.i, 384
  %27 = getelementptr i8, ptr %.312.i, i64 %.idx
  %.1093.i = getelementptr i8, ptr %27, i64 2560
  %.1165.i.idx = mul i64 %"$phi1014.0.2.0.i", 48
  %.1165.i = getelementptr i8, ptr %.1093.i, i64 %.1165.i.idx
  %.1237.i = sub i64 %.13.i.i, %.1396770.i
  store ptr null, ptr %.1246.i, align 8, !noalias !4
  call fastcc void @inner_1(ptr nonnull %.1246.i, ptr nonnull %.156.i.i, ptr nonnull %.564.i, i64 %.1237.i, ptr nonnull %.55.i, ptr %26, ptr %.233.i, i64 %.843.i, ptr nonnull %.862.i, ptr %.1165.i)
  %.1289.i = icmp sgt i64 %"$phi1014.0.2.0.i", 0
  br i1 %.1289.i, label %B1196.i, label %B1242.i

B1196.i:                                          ; preds = %B1014.i
  call void @llvm.lifetime.start.p0(ptr nonnull %.852.i.i), !noalias !4
  store ptr null, ptr %.852.i.i, align 8, !noalias !17
  %.104.i.i = load i64, ptr %.955.i, align 8, !noalias !17
  %.108.i.i = inttoptr i64 %.104.i.i to ptr
  %.193.i.i = load i64, ptr %.108.i.i, align 8, !noalias !17
  %.273466.not.i.i = icmp slt i64 %.193.i.i, 1
  br i1 %.273466.not.i.i, label %_ZN17bnserve_surrogate8tangents7_source7_ratiosB4v127B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i, label %B140.if.preheader.i.i

B140.if.preheader.i.i:                            ; preds = %B1196.i
  %scevgep.i2.i = getelementptr i8, ptr %.108.i.i, i64 96
  br label %B140.if.i.i

B220.i.i:                                         ; preds = %B140.if.i.i
  %scevgep97.i.i = getelementptr i8, ptr %lsr.iv.i3.i, i64 -24
  %.462.i.i = load i64, ptr %scevgep97.i.i, align 8, !noalias !17
  %.463.i.i = inttoptr i64 %.462.i.i to ptr
  %scevgep96.i.i = getelementptr i8, ptr %lsr.iv.i3.i, i64 -16
  %.541.i.i = load i64, ptr %scevgep96.i.i, align 8, !noalias !17
  %.542.i.i = inttoptr i64 %.541.i.i to ptr
  %scevgep95.i.i = getelementptr i8, ptr %lsr.iv.i3.i, i64 -8
  %.620.i.i = load i64, ptr %scevgep95.i.i, align 8, !noalias !17
  %.621.i.i = inttoptr i64 %.620.i.i to ptr
  %.705.i.i = load i64, ptr %lsr.iv.i3.i, align 8, !noalias !17
  %.722.idx.i.i = mul nsw i64 %.705.i.i, 48
  %.722.i.i = getelementptr inbounds i8, ptr %.1093.i, i64 %.722.idx.i.i
  %.801.i.i = getelementptr i8, ptr %.463.i.i, i64 64
  %.802.i.i = load i64, ptr %.801.i.i, align 8, !noalias !17
  %.neg.i.i = mul i64 %.802.i.i, -4
  %28 = and i64 %.neg.i.i, -32
  %.846.i.i = sub i64 0, %28
  store ptr null, ptr %.852.i.i, align 8, !noalias !17
  call fastcc void @inner_1(ptr nonnull %.852.i.i, ptr nonnull readonly %.156.i.i, ptr nonnull readonly %.564.i, i64 %.1237.i, ptr %.463.i.i, ptr %.542.i.i, ptr %.621.i.i, i64 %.846.i.i, ptr %.722.i.i, ptr %.1165.i)
  br label %B648.i.i

B648.i.i:                                         ; preds = %B140.if.i.i, %B220.i.i
  %scevgep94.i.i = getelementptr i8, ptr %lsr.iv.i3.i, i64 72
  %lsr.iv.next.i.i = add nsw i64 %lsr.iv99.i.i, -1
  %exitcond.not.i4.i = icmp eq i64 %lsr.iv.next.i.i, 0
  br i1 %exitcond.not.i4.i, label %_ZN17bnserve_surrogate8tangents7_source7_ratiosB4v127B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i, label %B140.if.i.i

B140.if.i.i:                                      ; preds = %B648.i.i, %B140.if.preheader.i.i
  %lsr.iv99.i.i = phi i64 [ %.193.i.i, %B140.if.preheader.i.i ], [ %lsr.iv.next.i.i, %B648.i.i ]
  %lsr.iv.i3.i = phi ptr [ %scevgep.i2.i, %B140.if.preheader.i.i ], [ %scevgep94.i.i, %B648.i.i ]
  %scevgep98.i.i = getelementptr i8, ptr %lsr.iv.i3.i, i64 -32
  %.429.i.i = load i64, ptr %scevgep98.i.i, align 8, !noalias !17
  %.430.i.i = icmp sgt i64 %.429.i.i, 0
  br i1 %.430.i.i, label %B220.i.i, label %B648.i.i

_ZN17bnserve_surrogate8tangents7_source7_ratiosB4v127B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i: ; preds = %B648.i.i, %B1196.i
  call void @llvm.lifetime.end.p0(ptr nonnull %.852.i.i), !noalias !4
  br label %B1242.i

B1242.i:                                          ; preds = %_ZN17bnserve_surrogate8tangents7_source7_ratiosB4v127B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i, %B1014.i
  %.14381466.not.i = icmp slt i64 %.1237.i, 1
  br i1 %.14381466.not.i, label %_ZN17bnserve_surrogate8tangents7_source5_tileB2v5B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExx5ArrayIxLi1E1C7mutable7alignedE.exit, label %B1274.if.lr.ph.i

B1274.if.lr.ph.i:                                 ; preds = %B1242.i
  %.1633.i = mul i64 %25, -28
  %.1634.i = add nsw i64 %.1633.i, 392
  %.1635.i = sub i64 %.1634.i, %.719.1.i
  %.1636.i = sub i64 %.1635.i, %.793.1.i
  %.1654.i = getelementptr inbounds nuw i8, ptr %.1165.i, i64 3136
  %.idx3 = mul i64 %.719.1.i, -224
  %29 = getelementptr i8, ptr %.1165.i, i64 %.idx3
  %.1720.i = getelementptr i8, ptr %29, i64 3136
  %.1797.i = getelementptr inbounds double, ptr %.1165.i, i64 %.1634.i
  %.1860.i = getelementptr inbounds double, ptr %.1165.i, i64 %.1635.i
  %.1999.i = getelementptr inbounds nuw i8, ptr %.1165.i, i64 2688
  %.2077.i = getelementptr double, ptr %.1165.i, i64 %.1636.i
  %.2139.i = getelementptr i8, ptr %.2077.i, i64 2016
  %.2203.i = getelementptr i8, ptr %.2077.i, i64 2144
  %.2264.i = getelementptr i8, ptr %.2077.i, i64 2656
  %.2326.i = getelementptr i8, ptr %.2077.i, i64 2848
  %.2392.i = getelementptr i8, ptr %.2077.i, i64 25696
  %30 = inttoptr i64 %.495.i to ptr
  br label %B1274.if.i

B1322.i:                                          ; preds = %B1274.if.i
  %.1526.idx.i = mul nsw i64 %.1382.0.i, 80
  %.1526.i = getelementptr inbounds i8, ptr %.411.i, i64 %.1526.idx.i
  %.1580.i = sub nsw i64 %.1382.0.i, %.1396770.i
  store ptr null, ptr %.2840.i, align 8, !noalias !4
  %.2889.i = call fastcc i32 @inner_2(ptr nonnull %.2840.i, ptr nonnull %excinfo.28.i, i64 %.1382.0.i, ptr nonnull readonly %arg.arguments, ptr nonnull %.55.i, ptr %.233.i, ptr nonnull %.862.i, ptr %.1093.i, i64 %.1580.i, ptr %.1526.i, i64 %.753.i, i64 %.827.i, i64 %.843.i, ptr nonnull %.1654.i, ptr %.1720.i, ptr nonnull %.1797.i, i64 %.753.i, ptr %.1860.i, i64 %.827.i, ptr %.1165.i, ptr nonnull %.1999.i, ptr %.2077.i, ptr %.2139.i, ptr %.2203.i, ptr %.2264.i, ptr %.2326.i, ptr %.2392.i)
  %cond.i = icmp eq i32 %.2889.i, 0
  br i1 %cond.i, label %B1532.i, label %B1322.endif.endif.endif.e...endif.1.if.i, !prof !20

B1498.i:                                          ; preds = %B1274.if.i
  %.50.i.i = load i64, ptr %.955.i, align 8, !noalias !21
  %.51.not.i.i = icmp eq i64 %.50.i.i, 0
  br i1 %.51.not.i.i, label %B146.i.i, label %B48.i.i

B48.i.i:                                          ; preds = %B1498.i
  %.84.i.i = inttoptr i64 %.50.i.i to ptr
  %.162.i.i = load i64, ptr %.84.i.i, align 8, !noalias !21
  %31 = mul nsw i64 %.162.i.i, 12
  br label %B146.i.i

B146.i.i:                                         ; preds = %B48.i.i, %B1498.i
  %"$phi146.0.2.0.i.i" = phi i64 [ %31, %B48.i.i ], [ 12, %B1498.i ]
  %.207.i.i = load i64, ptr %sunkaddr39.i, align 8, !noalias !21
  %.208.i.i = mul i64 %.207.i.i, %"$phi146.0.2.0.i.i"
  %.239.i.i = load i64, ptr %sunkaddr40.i, align 8, !noalias !21
  %.246.i.i = shl nsw i64 %.1382.0.i, 3
  %.249.i.i = mul nsw i64 %.246.i.i, %.208.i.i
  %.250.i.i = add nsw i64 %.249.i.i, %.239.i.i
  %.485.i.i = icmp slt i64 %.208.i.i, 1
  br i1 %.485.i.i, label %B1532.i, label %.551.endif.preheader.i.i, !prof !24

.551.endif.preheader.i.i:                         ; preds = %B146.i.i
  %32 = icmp ult i64 %.208.i.i, 8
  br i1 %32, label %.551.endif.epil.preheader.i.i, label %.551.endif.preheader.new.i.i, !prof !25

.551.endif.preheader.new.i.i:                     ; preds = %.551.endif.preheader.i.i
  %33 = add nsw i64 %.208.i.i, -8
  %34 = lshr i64 %33, 3
  %35 = icmp eq i64 %34, 0
  br i1 %35, label %.551.endif.i.epil.preheader.i, label %.551.endif.preheader.new.i.new.i, !prof !26

.551.endif.preheader.new.i.new.i:                 ; preds = %.551.endif.preheader.new.i.i
  %36 = add nuw nsw i64 %34, 1
  %37 = inttoptr i64 %.250.i.i to ptr
  %scevgep.i = getelementptr i8, ptr %37, i64 120
  %38 = and i64 %36, 4611686018427387902
  br label %.551.endif.i.i

.551.if.loopexit.unr-lcssa.i.unr-lcssa.i:         ; preds = %.551.endif.i.i
  %39 = and i64 %33, 8
  %lcmp.mod.not.not.i = icmp eq i64 %39, 0
  br i1 %lcmp.mod.not.not.i, label %.551.endif.i.epil.preheader.i, label %.551.if.loopexit.unr-lcssa.i.i, !prof !27

.551.endif.i.epil.preheader.i:                    ; preds = %.551.if.loopexit.unr-lcssa.i.unr-lcssa.i, %.551.endif.preheader.new.i.i
  %.547.0194.i.epil.init.i = phi i64 [ 0, %.551.endif.preheader.new.i.i ], [ %.592.7.i.1.i, %.551.if.loopexit.unr-lcssa.i.unr-lcssa.i ]
  %sunkaddr456.i = inttoptr i64 %.250.i.i to ptr
  %sunkaddr457.i = shl i64 %.547.0194.i.epil.init.i, 3
  %sunkaddr458.i = getelementptr i8, ptr %sunkaddr456.i, i64 %sunkaddr457.i
  store double 0x7FF8000000000000, ptr %sunkaddr458.i, align 8, !noalias !21
  %sunkaddr462.i = getelementptr i8, ptr %sunkaddr458.i, i64 8
  store double 0x7FF8000000000000, ptr %sunkaddr462.i, align 8, !noalias !21
  %sunkaddr466.i = getelementptr i8, ptr %sunkaddr458.i, i64 16
  store double 0x7FF8000000000000, ptr %sunkaddr466.i, align 8, !noalias !21
  %sunkaddr470.i = getelementptr i8, ptr %sunkaddr458.i, i64 24
  store double 0x7FF8000000000000, ptr %sunkaddr470.i, align 8, !noalias !21
  %sunkaddr474.i = getelementptr i8, ptr %sunkaddr458.i, i64 32
  store double 0x7FF8000000000000, ptr %sunkaddr474.i, align 8, !noalias !21
  %sunkaddr478.i = getelementptr i8, ptr %sunkaddr458.i, i64 40
  store double 0x7FF8000000000000, ptr %sunkaddr478.i, align 8, !noalias !21
  %sunkaddr482.i = getelementptr i8, ptr %sunkaddr458.i, i64 48
  store double 0x7FF8000000000000, ptr %sunkaddr482.i, align 8, !noalias !21
  %sunkaddr486.i = getelementptr i8, ptr %sunkaddr458.i, i64 56
  store double 0x7FF8000000000000, ptr %sunkaddr486.i, align 8, !noalias !21
  %.592.7.i.epil.i = add nuw i64 %.547.0194.i.epil.init.i, 8
  br label %.551.if.loopexit.unr-lcssa.i.i

.551.if.loopexit.unr-lcssa.i.i:                   ; preds = %.551.endif.i.epil.preheader.i, %.551.if.loopexit.unr-lcssa.i.unr-lcssa.i
  %.592.7.i.lcssa.i = phi i64 [ %.592.7.i.epil.i, %.551.endif.i.epil.preheader.i ], [ %.592.7.i.1.i, %.551.if.loopexit.unr-lcssa.i.unr-lcssa.i ]
  %40 = and i64 %.208.i.i, 4
  %lcmp.mod.not.i.i = icmp eq i64 %40, 0
  br i1 %lcmp.mod.not.i.i, label %B1532.i, label %.551.endif.epil.preheader.i.i, !prof !28

.551.endif.epil.preheader.i.i:                    ; preds = %.551.if.loopexit.unr-lcssa.i.i, %.551.endif.preheader.i.i
  %.547.0194.epil.init.i.i = phi i64 [ 0, %.551.endif.preheader.i.i ], [ %.592.7.i.lcssa.i, %.551.if.loopexit.unr-lcssa.i.i ]
  %41 = inttoptr i64 %.250.i.i to ptr
  %42 = shl i64 %.547.0194.epil.init.i.i, 3
  %scevgep.i.i = getelementptr i8, ptr %41, i64 %42
  br label %.551.endif.epil.i.i

.551.endif.epil.i.i:                              ; preds = %.551.endif.epil.i.i, %.551.endif.epil.preheader.i.i
  %epil.iter.i.i = phi i64 [ %epil.iter.next.i.i, %.551.endif.epil.i.i ], [ 0, %.551.endif.epil.preheader.i.i ]
  %43 = shl nuw nsw i64 %epil.iter.i.i, 3
  %scevgep38.i = getelementptr i8, ptr %scevgep.i.i, i64 %43
  store double 0x7FF8000000000000, ptr %scevgep38.i, align 8, !noalias !21
  %epil.iter.next.i.i = add nuw nsw i64 %epil.iter.i.i, 1
  %epil.iter.cmp.not.i.i = icmp eq i64 %epil.iter.next.i.i, 4
  br i1 %epil.iter.cmp.not.i.i, label %B1532.i, label %.551.endif.epil.i.i, !prof !29, !llvm.loop !30

.551.endif.i.i:                                   ; preds = %.551.endif.i.i, %.551.endif.preheader.new.i.new.i
  %lsr.iv.i = phi i64 [ %lsr.iv.next.i, %.551.endif.i.i ], [ %38, %.551.endif.preheader.new.i.new.i ]
  %.547.0194.i.i = phi i64 [ %.592.7.i.1.i, %.551.endif.i.i ], [ 0, %.551.endif.preheader.new.i.new.i ]
  %44 = shl i64 %.547.0194.i.i, 3
  %scevgep438.i = getelementptr i8, ptr %scevgep.i, i64 %44
  %scevgep439.i = getelementptr i8, ptr %scevgep438.i, i64 -64
  %scevgep452.i = getelementptr i8, ptr %scevgep438.i, i64 -120
  store double 0x7FF8000000000000, ptr %scevgep452.i, align 8, !noalias !21
  %scevgep451.i = getelementptr i8, ptr %scevgep438.i, i64 -112
  store double 0x7FF8000000000000, ptr %scevgep451.i, align 8, !noalias !21
  %scevgep37.i = getelementptr i8, ptr %scevgep438.i, i64 -104
  store double 0x7FF8000000000000, ptr %scevgep37.i, align 8, !noalias !21
  %scevgep35.i = getelementptr i8, ptr %scevgep438.i, i64 -96
  store double 0x7FF8000000000000, ptr %scevgep35.i, align 8, !noalias !21
  %scevgep33.i = getelementptr i8, ptr %scevgep438.i, i64 -88
  store double 0x7FF8000000000000, ptr %scevgep33.i, align 8, !noalias !21
  %scevgep31.i = getelementptr i8, ptr %scevgep438.i, i64 -80
  store double 0x7FF8000000000000, ptr %scevgep31.i, align 8, !noalias !21
  %scevgep29.i = getelementptr i8, ptr %scevgep438.i, i64 -72
  store double 0x7FF8000000000000, ptr %scevgep29.i, align 8, !noalias !21
  store double 0x7FF8000000000000, ptr %scevgep439.i, align 8, !noalias !21
  %scevgep25.i = getelementptr i8, ptr %scevgep438.i, i64 -56
  store double 0x7FF8000000000000, ptr %scevgep25.i, align 8, !noalias !21
  %scevgep21.i = getelementptr i8, ptr %scevgep438.i, i64 -48
  store double 0x7FF8000000000000, ptr %scevgep21.i, align 8, !noalias !21
  %scevgep17.i = getelementptr i8, ptr %scevgep438.i, i64 -40
  store double 0x7FF8000000000000, ptr %scevgep17.i, align 8, !noalias !21
  %scevgep13.i = getelementptr i8, ptr %scevgep438.i, i64 -32
  store double 0x7FF8000000000000, ptr %scevgep13.i, align 8, !noalias !21
  %scevgep9.i = getelementptr i8, ptr %scevgep438.i, i64 -24
  store double 0x7FF8000000000000, ptr %scevgep9.i, align 8, !noalias !21
  %scevgep5.i = getelementptr i8, ptr %scevgep438.i, i64 -16
  store double 0x7FF8000000000000, ptr %scevgep5.i, align 8, !noalias !21
  %scevgep2.i = getelementptr i8, ptr %scevgep438.i, i64 -8
  store double 0x7FF8000000000000, ptr %scevgep2.i, align 8, !noalias !21
  store double 0x7FF8000000000000, ptr %scevgep438.i, align 8, !noalias !21
  %.592.7.i.1.i = add i64 %.547.0194.i.i, 16
  %lsr.iv.next.i = add i64 %lsr.iv.i, -2
  %niter.ncmp.1.i = icmp eq i64 %lsr.iv.next.i, 0
  br i1 %niter.ncmp.1.i, label %.551.if.loopexit.unr-lcssa.i.unr-lcssa.i, label %.551.endif.i.i, !prof !33, !llvm.loop !34

B1532.i:                                          ; preds = %.551.endif.epil.i.i, %.551.if.loopexit.unr-lcssa.i.i, %B146.i.i, %B1322.i
  %.1438.i = icmp sgt i64 %.14371467.i, 1
  br i1 %.1438.i, label %B1274.if.i, label %_ZN17bnserve_surrogate8tangents7_source5_tileB2v5B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExx5ArrayIxLi1E1C7mutable7alignedE.exit

B1274.if.i:                                       ; preds = %B1532.i, %B1274.if.lr.ph.i
  %.1382.0.i = phi i64 [ %.1396770.i, %B1274.if.lr.ph.i ], [ %.1451.i, %B1532.i ]
  %.14371467.i = phi i64 [ %.1237.i, %B1274.if.lr.ph.i ], [ %.1447.i, %B1532.i ]
  %.1447.i = add nsw i64 %.14371467.i, -1
  %.1451.i = add i64 %.1382.0.i, 1
  %.1493.i = icmp slt i64 %.1382.0.i, 0
  %.1494.i = select i1 %.1493.i, i64 %.13.i.i, i64 0
  %45 = getelementptr i8, ptr %30, i64 %.1382.0.i
  %.1508.i = getelementptr i8, ptr %45, i64 %.1494.i
  %.1509.i = load i8, ptr %.1508.i, align 1, !noalias !4
  %.1511.i = icmp eq i8 %.1509.i, 0
  br i1 %.1511.i, label %B1322.i, label %B1498.i

B1322.endif.endif.endif.e...endif.1.if.i:         ; preds = %B1322.i
  %.2890.i = load ptr, ptr %excinfo.28.i, align 8, !noalias !4
  br label %_ZN17bnserve_surrogate8tangents7_source5_tileB2v5B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExx5ArrayIxLi1E1C7mutable7alignedE.exit

_ZN17bnserve_surrogate8tangents7_source5_tileB2v5B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExx5ArrayIxLi1E1C7mutable7alignedE.exit: ; preds = %B1532.i, %B1242.i, %B1322.endif.endif.endif.e...endif.1.if.i
  %excinfo.2.i.1 = phi ptr [ %.2890.i, %B1322.endif.endif.endif.e...endif.1.if.i ], [ %excinfo.2.i.0, %B1242.i ], [ %excinfo.2.i.0, %B1532.i ]
  %cond = phi i1 [ false, %B1322.endif.endif.endif.e...endif.1.if.i ], [ true, %B1242.i ], [ true, %B1532.i ]
  call void @llvm.lifetime.end.p0(ptr nonnull %.1246.i)
  call void @llvm.lifetime.end.p0(ptr nonnull %.2840.i)
  call void @llvm.lifetime.end.p0(ptr nonnull %excinfo.28.i)
  br i1 %cond, label %B84.backedge.i, label %_ZN17bnserve_surrogate8tangents7_source13differentiateB2v3B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE.exit, !prof !20

B84.backedge.i:                                   ; preds = %_ZN17bnserve_surrogate8tangents7_source5_tileB2v5B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExx5ArrayIxLi1E1C7mutable7alignedE.exit
  %lsr.iv.next = add nsw i64 %lsr.iv, -1
  %.133.i = icmp sgt i64 %lsr.iv, 3
  br i1 %.133.i, label %B84.if.i, label %_ZN17bnserve_surrogate8tangents7_source13differentiateB2v3B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE.exit

_ZN17bnserve_surrogate8tangents7_source13differentiateB2v3B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE.exit: ; preds = %_ZN17bnserve_surrogate8tangents7_source5_tileB2v5B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExx5ArrayIxLi1E1C7mutable7alignedE.exit, %B84.backedge.i
  %excinfo.2.0 = phi ptr [ %excinfo.2.i.1, %_ZN17bnserve_surrogate8tangents7_source5_tileB2v5B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExx5ArrayIxLi1E1C7mutable7alignedE.exit ], [ null, %B84.backedge.i ]
  br i1 %cond, label %B0.endif.endif, label %B0.endif.if, !prof !20

common.ret:                                       ; preds = %B0.endif.endif, %B0.endif.if
  %common.ret.op = phi i32 [ 1, %B0.endif.if ], [ 0, %B0.endif.endif ]
  ret i32 %common.ret.op

B0.endif.if:                                      ; preds = %_ZN17bnserve_surrogate8tangents7_source13differentiateB2v3B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE.exit
  store ptr %excinfo.2.0, ptr %excinfo, align 8
  br label %common.ret

B0.endif.endif:                                   ; preds = %entry, %_ZN17bnserve_surrogate8tangents7_source13differentiateB2v3B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE.exit
  store i64 0, ptr %retptr, align 8
  br label %common.ret
}

; Function Attrs: mustprogress nocallback nofree nounwind willreturn memory(argmem: write)
declare void @llvm.memset.p0.i64(ptr writeonly captures(none), i8, i64, i1 immarg) #1

; Function Attrs: mustprogress nocallback nocreateundeforpoison nofree nosync nounwind speculatable willreturn memory(none)
declare i64 @llvm.smin.i64(i64, i64) #2

; Function Attrs: nofree norecurse nosync nounwind memory(readwrite, inaccessiblemem: none, target_mem0: none, target_mem1: none)
define internal fastcc void @inner_1(ptr noalias nonnull writeonly captures(none) %retptr, ptr readonly captures(none) %arg.coordinates.4, ptr readonly captures(none) %arg.jacobian.4, i64 %arg.rows, ptr readonly captures(none) %arg.contents.4, ptr readonly captures(none) %arg.exponents.4, ptr readonly captures(none) %arg.weights.4, i64 range(i64 8, 1) %arg.width, ptr writeonly captures(none) %arg.linear.4, ptr initializes((56, 64)) %arg.scratch.4) unnamed_addr #0 {
entry:
  %.183 = alloca { ptr, ptr, i64, i64, ptr, [1 x i64], [1 x i64] }, align 8
  %.fca.4.gep306 = getelementptr inbounds nuw i8, ptr %.183, i64 32
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(56) %.183, i8 0, i64 56, i1 false)
  %.558 = alloca ptr, align 8
  store ptr null, ptr %.558, align 8
  %.846 = alloca ptr, align 8
  store ptr null, ptr %.846, align 8
  %.129 = getelementptr i8, ptr %arg.contents.4, i64 24
  %.130 = load i64, ptr %.129, align 8
  %.131 = sub i64 0, %.130
  %.139.1 = and i64 %.131, -8
  %.174 = sub i64 8, %.139.1
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(56) %.183, i8 0, i64 56, i1 false)
  call fastcc void @inner_3(ptr nonnull %.183, ptr %arg.coordinates.4, i64 %arg.rows, ptr %arg.contents.4, ptr %arg.exponents.4, ptr %arg.weights.4, ptr %arg.scratch.4)
  %.207.fca.4.load = load ptr, ptr %.fca.4.gep306, align 8
  %.231 = mul nsw i64 %.174, 40
  %.241.idx = shl i64 %.174, 6
  %.241 = getelementptr inbounds i8, ptr %arg.scratch.4, i64 %.241.idx
  %.306.idx = mul nsw i64 %.174, 384
  %.306 = getelementptr inbounds i8, ptr %arg.scratch.4, i64 %.306.idx
  %.114.i = load i64, ptr %.129, align 8, !noalias !36
  %.115.i = sub i64 0, %.114.i
  %.123.1.i = and i64 %.115.i, -8
  %.157.i = sub i64 0, %.123.1.i
  %.185.i = getelementptr i8, ptr %arg.contents.4, i64 8
  %.186.i = load i64, ptr %.185.i, align 8, !noalias !36
  %.214.i = getelementptr i8, ptr %arg.contents.4, i64 16
  %.215.i = load i64, ptr %.214.i, align 8, !noalias !36
  %.223.i = sub i64 8, %.123.1.i
  %.224.i = shl i64 %.215.i, 3
  %.225.i = add i64 %.224.i, 8
  %.259.i = getelementptr i8, ptr %arg.contents.4, i64 88
  %.260.i = load i64, ptr %.259.i, align 8, !noalias !36
  %0 = lshr i64 %.260.i, 33
  %.300.i = and i64 %0, 1073741824
  %.301.i = add i64 %.300.i, %.260.i
  %.304.i = icmp slt i64 %.301.i, 0
  br i1 %.304.i, label %B0.endif.else.if.i, label %B0.endif.else.endif.i, !prof !24

B418.if.lr.ph.i:                                  ; preds = %B372.if.preheader.i, %B0.endif.endif.endif.i
  %1 = add nuw i64 %arg.rows, 3
  %.919.i = lshr i64 %1, 2
  %.898.inv.i = icmp sgt i64 %arg.rows, 0
  %storemerge539.i = select i1 %.898.inv.i, i64 %.919.i, i64 0
  %factor.op.mul61.i = shl i64 %.186.i, 5
  %.164.i.i = mul nsw i64 %.225.i, 5
  %2 = getelementptr double, ptr %.306, i64 %.225.i
  %.idx.i.i = shl i64 %.225.i, 4
  %invariant.gep.i = getelementptr i8, ptr %.306, i64 %.idx.i.i
  %.idx229.i.i = mul i64 %.225.i, 24
  %invariant.gep62.i = getelementptr i8, ptr %.306, i64 %.idx229.i.i
  %.idx230.i.i = shl i64 %.225.i, 5
  %invariant.gep64.i = getelementptr i8, ptr %.306, i64 %.idx230.i.i
  %scevgep.i11.i = getelementptr i8, ptr %arg.exponents.4, i64 32
  %3 = tail call i64 @llvm.smax.i64(i64 %.157.i, i64 31)
  %storemerge.i.i = lshr i64 %3, 5
  %factor.op.mul.reass.i = mul i64 %factor.op.mul61.i, %storemerge.i.i
  %.1086.i.i = and i64 %.157.i, 24
  %.880.idx.i.i = shl i64 %.223.i, 4
  %.950.idx.i.i = mul i64 %.223.i, 24
  %scevgep23.i.i = getelementptr i8, ptr %.402.i, i64 192
  %4 = shl i64 %.186.i, 8
  %.1046.i.i = and i64 %.157.i, -32
  %.1106806.i.i = lshr exact i64 %.1086.i.i, 3
  %.arg.count811.i.i = tail call i64 @llvm.smax.i64(i64 %.186.i, i64 0)
  %5 = shl i64 %.arg.count811.i.i, 3
  %6 = mul i64 %.215.i, 640
  %7 = getelementptr i8, ptr %.306, i64 %6
  %scevgep.i = getelementptr i8, ptr %7, i64 664
  %8 = icmp slt i64 %.186.i, 1
  %9 = icmp eq i64 %storemerge539.i, 0
  %10 = icmp eq i64 %storemerge.i.i, 0
  %11 = icmp eq i64 %.1086.i.i, 0
  br label %B418.if.i

B418.loopexit.i:                                  ; preds = %B508.endif.endif.endif.i, %B420.endif.i
  %exitcond.not.i4 = icmp eq i64 %.795.i, 5
  br i1 %exitcond.not.i4, label %_ZN17bnserve_surrogate8tangents11_regression11_along_axesB4v114B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit, label %B418.if.i

B0.endif.else.if.i:                               ; preds = %entry
  br label %B0.endif.else.endif.i

B0.endif.else.endif.i:                            ; preds = %B0.endif.else.if.i, %entry
  %.289.sroa.0.1.i = phi i64 [ 0, %B0.endif.else.if.i ], [ %.301.i, %entry ]
  %.309.not.i = icmp slt i64 %.301.i, 1073741824
  br i1 %.309.not.i, label %B0.endif.else.endif.endif.i, label %B0.endif.else.endif.if.i, !prof !39

B0.endif.else.endif.if.i:                         ; preds = %B0.endif.else.endif.i
  br label %B0.endif.else.endif.endif.i

B0.endif.else.endif.endif.i:                      ; preds = %B0.endif.else.endif.if.i, %B0.endif.else.endif.i
  %.289.sroa.0.3.i = phi i64 [ 1073741824, %B0.endif.else.endif.if.i ], [ %.289.sroa.0.1.i, %B0.endif.else.endif.i ]
  %.arg.degree.i.i = tail call i64 @llvm.smax.i64(i64 %.215.i, i64 0)
  %12 = shl i64 %.215.i, 6
  %13 = mul i64 %.215.i, 320
  %14 = icmp slt i64 %.215.i, 1
  br label %B60.if.i.i

B692.i.i:                                         ; preds = %B400.if.i.i, %B60.if.i.i
  %15 = getelementptr i8, ptr %lsr.iv46.i.i, i64 %12
  %scevgep.i.i = getelementptr i8, ptr %15, i64 64
  %exitcond401.not.i.i = icmp eq i64 %.135.i.i, 5
  br i1 %exitcond401.not.i.i, label %B0.endif.endif.endif.i, label %B60.if.i.i

B60.if.i.i:                                       ; preds = %B692.i.i, %B0.endif.else.endif.endif.i
  %lsr.iv46.i.i = phi ptr [ %.306, %B0.endif.else.endif.endif.i ], [ %scevgep.i.i, %B692.i.i ]
  %.128334354.i.i = phi i64 [ 0, %B0.endif.else.endif.endif.i ], [ %.135.i.i, %B692.i.i ]
  %.135.i.i = add nuw nsw i64 %.128334354.i.i, 1
  %.168.idx.i.i = shl nsw i64 %.128334354.i.i, 6
  %.168.i.i = getelementptr inbounds nuw i8, ptr %arg.coordinates.4, i64 %.168.idx.i.i
  %.170.i.i = load <8 x double>, ptr %.168.i.i, align 8, !noalias !40
  %.176.i.i = mul nsw i64 %.128334354.i.i, %.225.i
  %.188.i.i = getelementptr inbounds double, ptr %.306, i64 %.176.i.i
  %.240.i.i = add nuw nsw i64 %.128334354.i.i, 5
  %.242.i.i = mul nsw i64 %.240.i.i, %.225.i
  %.254.i.i = getelementptr inbounds double, ptr %.306, i64 %.242.i.i
  store <8 x double> splat (double 1.000000e+00), ptr %.188.i.i, align 8, !noalias !40
  store <8 x double> zeroinitializer, ptr %.254.i.i, align 8, !noalias !40
  br i1 %14, label %B692.i.i, label %B400.if.preheader.i.i

B400.if.preheader.i.i:                            ; preds = %B60.if.i.i
  %.6.i.i.i = fadd contract <8 x double> %.170.i.i, %.170.i.i
  br label %B400.if.i.i

B400.if.i.i:                                      ; preds = %B400.if.i.i, %B400.if.preheader.i.i
  %lsr.iv47.i.i = phi ptr [ %lsr.iv46.i.i, %B400.if.preheader.i.i ], [ %scevgep49.i.i, %B400.if.i.i ]
  %lsr.iv.i.i = phi i64 [ %.arg.degree.i.i, %B400.if.preheader.i.i ], [ %lsr.iv.next.i.i, %B400.if.i.i ]
  %slope_before.2.1326.i.i = phi <8 x double> [ zeroinitializer, %B400.if.preheader.i.i ], [ %slope.2.1325.i.i, %B400.if.i.i ]
  %slope.2.1325.i.i = phi <8 x double> [ splat (double 1.000000e+00), %B400.if.preheader.i.i ], [ %.563.i.i, %B400.if.i.i ]
  %before.2.1324.i.i = phi <8 x double> [ splat (double 1.000000e+00), %B400.if.preheader.i.i ], [ %current.2.1323.i.i, %B400.if.i.i ]
  %current.2.1323.i.i = phi <8 x double> [ %.170.i.i, %B400.if.preheader.i.i ], [ %.624.i.i, %B400.if.i.i ]
  %scevgep49.i.i = getelementptr i8, ptr %lsr.iv47.i.i, i64 64
  store <8 x double> %current.2.1323.i.i, ptr %scevgep49.i.i, align 8, !noalias !40
  %sunkaddr.i3 = getelementptr i8, ptr %lsr.iv47.i.i, i64 %13
  %sunkaddr17.i = getelementptr i8, ptr %sunkaddr.i3, i64 384
  store <8 x double> %slope.2.1325.i.i, ptr %sunkaddr17.i, align 8, !noalias !40
  %.6.i27.i.i = fsub contract <8 x double> zeroinitializer, %slope_before.2.1326.i.i
  %.561.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %current.2.1323.i.i, <8 x double> splat (double 2.000000e+00), <8 x double> %.6.i27.i.i)
  %.563.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i.i, <8 x double> %slope.2.1325.i.i, <8 x double> %.561.i.i)
  %.6.i29.i.i = fsub contract <8 x double> zeroinitializer, %before.2.1324.i.i
  %.624.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i.i, <8 x double> %current.2.1323.i.i, <8 x double> %.6.i29.i.i)
  %lsr.iv.next.i.i = add nsw i64 %lsr.iv.i.i, -1
  %exitcond.not.i.i = icmp eq i64 %lsr.iv.next.i.i, 0
  br i1 %exitcond.not.i.i, label %B692.i.i, label %B400.if.i.i

B0.endif.endif.endif.i:                           ; preds = %B692.i.i
  %.402.i = getelementptr double, ptr %arg.weights.4, i64 %.289.sroa.0.3.i
  %.491.idx.i = mul nsw i64 %.225.i, 80
  %.491.i = getelementptr inbounds i8, ptr %.306, i64 %.491.idx.i
  %.630548.not.i = icmp slt i64 %.223.i, 1
  br i1 %.630548.not.i, label %B418.if.lr.ph.i, label %B372.if.preheader.i

B372.if.preheader.i:                              ; preds = %B0.endif.endif.endif.i
  %storemerge.i = mul i64 %.223.i, 40
  %smin.i = tail call i64 @llvm.smin.i64(i64 %storemerge.i, i64 1)
  %16 = lshr i64 %.115.i, 3
  %.neg.i = mul i64 %16, 2305843009213693632
  %reass.sub.i = sub i64 %.neg.i, %smin.i
  %17 = shl i64 %reass.sub.i, 3
  %18 = add i64 %17, 2568
  tail call void @llvm.memset.p0.i64(ptr align 8 %.241, i8 0, i64 %18, i1 false), !noalias !36
  br label %B418.if.lr.ph.i

B418.if.i:                                        ; preds = %B418.loopexit.i, %B418.if.lr.ph.i
  %.788567582.i = phi i64 [ 0, %B418.if.lr.ph.i ], [ %.795.i, %B418.loopexit.i ]
  %.795.i = add nuw nsw i64 %.788567582.i, 1
  br i1 %8, label %B420.endif.i, label %B208.if.lr.ph.i.i

B208.if.lr.ph.i.i:                                ; preds = %B418.if.i
  %.156.i.i = icmp eq i64 %.788567582.i, 4
  %"$phi170.1.2.0.i.i" = select i1 %.156.i.i, i64 %.164.i.i, i64 0
  %.129.i.i = icmp eq i64 %.788567582.i, 3
  %"$phi132.1.2.0.i.i" = select i1 %.129.i.i, i64 %.164.i.i, i64 0
  %.102.i.i = icmp eq i64 %.788567582.i, 2
  %"$phi94.1.2.0.i.i" = select i1 %.102.i.i, i64 %.164.i.i, i64 0
  %.74.i.i = icmp eq i64 %.788567582.i, 1
  %"$phi56.1.2.0.i.i" = select i1 %.74.i.i, i64 %.164.i.i, i64 0
  %.56.i.i = icmp eq i64 %.788567582.i, 0
  %"$phi28.0.2.0.i.i" = select i1 %.56.i.i, i64 %.164.i.i, i64 0
  %19 = getelementptr double, ptr %.306, i64 %"$phi28.0.2.0.i.i"
  %20 = getelementptr double, ptr %2, i64 %"$phi56.1.2.0.i.i"
  %gep.i = getelementptr double, ptr %invariant.gep.i, i64 %"$phi94.1.2.0.i.i"
  %gep63.i = getelementptr double, ptr %invariant.gep62.i, i64 %"$phi132.1.2.0.i.i"
  %gep65.i = getelementptr double, ptr %invariant.gep64.i, i64 %"$phi170.1.2.0.i.i"
  br label %B208.if.i.i

B208.if.i.i:                                      ; preds = %B208.if.i.i, %B208.if.lr.ph.i.i
  %lsr.iv21.i.i = phi i64 [ %.186.i, %B208.if.lr.ph.i.i ], [ %lsr.iv.next.i14.i, %B208.if.i.i ]
  %lsr.iv19.i.i = phi ptr [ %.491.i, %B208.if.lr.ph.i.i ], [ %scevgep20.i.i, %B208.if.i.i ]
  %lsr.iv.i12.i = phi ptr [ %scevgep.i11.i, %B208.if.lr.ph.i.i ], [ %scevgep14.i.i, %B208.if.i.i ]
  %scevgep15.i.i = getelementptr i8, ptr %lsr.iv.i12.i, i64 -32
  %.318.i.i = load i64, ptr %scevgep15.i.i, align 8, !noalias !43
  %.329.idx.i.i = shl i64 %.318.i.i, 6
  %.329.i.i = getelementptr i8, ptr %19, i64 %.329.idx.i.i
  %.331.i.i = load <8 x double>, ptr %.329.i.i, align 8, !noalias !43
  %scevgep16.i.i = getelementptr i8, ptr %lsr.iv.i12.i, i64 -24
  %.342.i.i = load i64, ptr %scevgep16.i.i, align 8, !noalias !43
  %.353.idx.i.i = shl i64 %.342.i.i, 6
  %.353.i.i = getelementptr i8, ptr %20, i64 %.353.idx.i.i
  %.355.i.i = load <8 x double>, ptr %.353.i.i, align 8, !noalias !43
  %scevgep17.i.i = getelementptr i8, ptr %lsr.iv.i12.i, i64 -16
  %.366.i.i = load i64, ptr %scevgep17.i.i, align 8, !noalias !43
  %.377.idx.i.i = shl i64 %.366.i.i, 6
  %.377.i.i = getelementptr i8, ptr %gep.i, i64 %.377.idx.i.i
  %.379.i.i = load <8 x double>, ptr %.377.i.i, align 8, !noalias !43
  %scevgep18.i.i = getelementptr i8, ptr %lsr.iv.i12.i, i64 -8
  %.390.i.i = load i64, ptr %scevgep18.i.i, align 8, !noalias !43
  %.401.idx.i.i = shl i64 %.390.i.i, 6
  %.401.i.i = getelementptr i8, ptr %gep63.i, i64 %.401.idx.i.i
  %.403.i.i = load <8 x double>, ptr %.401.i.i, align 8, !noalias !43
  %.414.i.i = load i64, ptr %lsr.iv.i12.i, align 8, !noalias !43
  %.425.idx.i.i = shl i64 %.414.i.i, 6
  %.425.i.i = getelementptr i8, ptr %gep65.i, i64 %.425.idx.i.i
  %.427.i.i = load <8 x double>, ptr %.425.i.i, align 8, !noalias !43
  %.6.i.i13.i = fmul contract <8 x double> %.331.i.i, %.355.i.i
  %.6.i11.i.i = fmul contract <8 x double> %.379.i.i, %.403.i.i
  %.6.i12.i.i = fmul contract <8 x double> %.6.i.i13.i, %.6.i11.i.i
  %.6.i13.i.i = fmul contract <8 x double> %.6.i12.i.i, %.427.i.i
  store <8 x double> %.6.i13.i.i, ptr %lsr.iv19.i.i, align 8, !noalias !43
  %scevgep14.i.i = getelementptr i8, ptr %lsr.iv.i12.i, i64 40
  %scevgep20.i.i = getelementptr i8, ptr %lsr.iv19.i.i, i64 64
  %lsr.iv.next.i14.i = add i64 %lsr.iv21.i.i, -1
  %exitcond.not.i15.i = icmp eq i64 %lsr.iv.next.i14.i, 0
  br i1 %exitcond.not.i15.i, label %B420.endif.i, label %B208.if.i.i

B420.endif.i:                                     ; preds = %B208.if.i.i, %B418.if.i
  br i1 %9, label %B418.loopexit.i, label %B506.if.lr.ph.i

B506.if.lr.ph.i:                                  ; preds = %B420.endif.i
  %.980.i = shl nsw i64 %.788567582.i, 3
  br label %B506.if.i

B506.if.i:                                        ; preds = %B508.endif.endif.endif.i, %B506.if.lr.ph.i
  %lsr.iv.i = phi ptr [ %scevgep.i, %B506.if.lr.ph.i ], [ %scevgep66.i, %B508.endif.endif.endif.i ]
  %.939552560.i = phi i64 [ %storemerge539.i, %B506.if.lr.ph.i ], [ %.949.i, %B508.endif.endif.endif.i ]
  %.946555559.i = phi i64 [ 0, %B506.if.lr.ph.i ], [ %.953.i, %B508.endif.endif.endif.i ]
  %.949.i = add nsw i64 %.939552560.i, -1
  %.953.i = add nuw i64 %.946555559.i, 4
  %.981.i = add nsw i64 %.946555559.i, %.980.i
  %.983.i = mul nsw i64 %.981.i, %.223.i
  %21 = getelementptr double, ptr %.241, i64 %.983.i
  %.995.i = getelementptr i8, ptr %21, i64 64
  br i1 %10, label %B354.else.i.i, label %B84.if.i.i

B280.i.i:                                         ; preds = %B200.if.i.i, %B84.if.i.i
  %_multiply_wide_v84_a00.2.1.lcssa.i.i = phi <8 x double> [ zeroinitializer, %B84.if.i.i ], [ %.577.i.i, %B200.if.i.i ]
  %_multiply_wide_v84_a01.2.1.lcssa.i.i = phi <8 x double> [ zeroinitializer, %B84.if.i.i ], [ %.581.i.i, %B200.if.i.i ]
  %_multiply_wide_v84_a02.2.1.lcssa.i.i = phi <8 x double> [ zeroinitializer, %B84.if.i.i ], [ %.589.i.i, %B200.if.i.i ]
  %_multiply_wide_v84_a03.2.1.lcssa.i.i = phi <8 x double> [ zeroinitializer, %B84.if.i.i ], [ %.593.i.i, %B200.if.i.i ]
  %_multiply_wide_v84_a10.2.1.lcssa.i.i = phi <8 x double> [ zeroinitializer, %B84.if.i.i ], [ %.614.i.i, %B200.if.i.i ]
  %_multiply_wide_v84_a11.2.1.lcssa.i.i = phi <8 x double> [ zeroinitializer, %B84.if.i.i ], [ %.618.i.i, %B200.if.i.i ]
  %_multiply_wide_v84_a12.2.1.lcssa.i.i = phi <8 x double> [ zeroinitializer, %B84.if.i.i ], [ %.626.i.i, %B200.if.i.i ]
  %_multiply_wide_v84_a13.2.1.lcssa.i.i = phi <8 x double> [ zeroinitializer, %B84.if.i.i ], [ %.630.i.i, %B200.if.i.i ]
  %_multiply_wide_v84_a20.2.1.lcssa.i.i = phi <8 x double> [ zeroinitializer, %B84.if.i.i ], [ %.652.i.i, %B200.if.i.i ]
  %_multiply_wide_v84_a21.2.1.lcssa.i.i = phi <8 x double> [ zeroinitializer, %B84.if.i.i ], [ %.656.i.i, %B200.if.i.i ]
  %_multiply_wide_v84_a22.2.1.lcssa.i.i = phi <8 x double> [ zeroinitializer, %B84.if.i.i ], [ %.664.i.i, %B200.if.i.i ]
  %_multiply_wide_v84_a23.2.1.lcssa.i.i = phi <8 x double> [ zeroinitializer, %B84.if.i.i ], [ %.668.i.i, %B200.if.i.i ]
  %_multiply_wide_v84_a30.2.1.lcssa.i.i = phi <8 x double> [ zeroinitializer, %B84.if.i.i ], [ %.690.i.i, %B200.if.i.i ]
  %_multiply_wide_v84_a31.2.1.lcssa.i.i = phi <8 x double> [ zeroinitializer, %B84.if.i.i ], [ %.694.i.i, %B200.if.i.i ]
  %_multiply_wide_v84_a32.2.1.lcssa.i.i = phi <8 x double> [ zeroinitializer, %B84.if.i.i ], [ %.702.i.i, %B200.if.i.i ]
  %_multiply_wide_v84_a33.2.1.lcssa.i.i = phi <8 x double> [ zeroinitializer, %B84.if.i.i ], [ %.706.i.i, %B200.if.i.i ]
  store <8 x double> %_multiply_wide_v84_a00.2.1.lcssa.i.i, ptr %.237.i.i, align 8, !noalias !46
  %.765.i.i = getelementptr inbounds nuw i8, ptr %.237.i.i, i64 64
  store <8 x double> %_multiply_wide_v84_a01.2.1.lcssa.i.i, ptr %.765.i.i, align 8, !noalias !46
  %.776.i.i = getelementptr inbounds nuw i8, ptr %.237.i.i, i64 128
  store <8 x double> %_multiply_wide_v84_a02.2.1.lcssa.i.i, ptr %.776.i.i, align 8, !noalias !46
  %.787.i.i = getelementptr inbounds nuw i8, ptr %.237.i.i, i64 192
  store <8 x double> %_multiply_wide_v84_a03.2.1.lcssa.i.i, ptr %.787.i.i, align 8, !noalias !46
  %.817.i.i = getelementptr inbounds double, ptr %.237.i.i, i64 %.223.i
  store <8 x double> %_multiply_wide_v84_a10.2.1.lcssa.i.i, ptr %.817.i.i, align 8, !noalias !46
  %.827.i.i = getelementptr i8, ptr %.817.i.i, i64 64
  store <8 x double> %_multiply_wide_v84_a11.2.1.lcssa.i.i, ptr %.827.i.i, align 8, !noalias !46
  %.838.i.i = getelementptr i8, ptr %.817.i.i, i64 128
  store <8 x double> %_multiply_wide_v84_a12.2.1.lcssa.i.i, ptr %.838.i.i, align 8, !noalias !46
  %.849.i.i = getelementptr i8, ptr %.817.i.i, i64 192
  store <8 x double> %_multiply_wide_v84_a13.2.1.lcssa.i.i, ptr %.849.i.i, align 8, !noalias !46
  %.880.i.i = getelementptr inbounds i8, ptr %.237.i.i, i64 %.880.idx.i.i
  store <8 x double> %_multiply_wide_v84_a20.2.1.lcssa.i.i, ptr %.880.i.i, align 8, !noalias !46
  %.890.i.i = getelementptr i8, ptr %.880.i.i, i64 64
  store <8 x double> %_multiply_wide_v84_a21.2.1.lcssa.i.i, ptr %.890.i.i, align 8, !noalias !46
  %.901.i.i = getelementptr i8, ptr %.880.i.i, i64 128
  store <8 x double> %_multiply_wide_v84_a22.2.1.lcssa.i.i, ptr %.901.i.i, align 8, !noalias !46
  %.912.i.i = getelementptr i8, ptr %.880.i.i, i64 192
  store <8 x double> %_multiply_wide_v84_a23.2.1.lcssa.i.i, ptr %.912.i.i, align 8, !noalias !46
  %.950.i.i = getelementptr inbounds i8, ptr %.237.i.i, i64 %.950.idx.i.i
  store <8 x double> %_multiply_wide_v84_a30.2.1.lcssa.i.i, ptr %.950.i.i, align 8, !noalias !46
  %.960.i.i = getelementptr i8, ptr %.950.i.i, i64 64
  store <8 x double> %_multiply_wide_v84_a31.2.1.lcssa.i.i, ptr %.960.i.i, align 8, !noalias !46
  %.971.i.i = getelementptr i8, ptr %.950.i.i, i64 128
  store <8 x double> %_multiply_wide_v84_a32.2.1.lcssa.i.i, ptr %.971.i.i, align 8, !noalias !46
  %.982.i.i = getelementptr i8, ptr %.950.i.i, i64 192
  store <8 x double> %_multiply_wide_v84_a33.2.1.lcssa.i.i, ptr %.982.i.i, align 8, !noalias !46
  %scevgep25.i.i = getelementptr i8, ptr %lsr.iv24.i.i, i64 %4
  %.187.i.i = icmp sgt i64 %.186852864.i.i, 1
  br i1 %.187.i.i, label %B84.if.i.i, label %B354.else.i.i

B1932.loopexit.i.i:                               ; preds = %B884.if.i.i
  %22 = add i64 %position.5.0897.i.i, %5
  br label %B1932.i.i

B1932.i.i:                                        ; preds = %B356.if.i.i, %B1932.loopexit.i.i
  %position.4.1.lcssa.i.i = phi i64 [ %position.5.0897.i.i, %B356.if.i.i ], [ %22, %B1932.loopexit.i.i ]
  %b0.2.1.lcssa.i.i = phi <8 x double> [ zeroinitializer, %B356.if.i.i ], [ %.1337.i.i, %B1932.loopexit.i.i ]
  %b1.2.1.lcssa.i.i = phi <8 x double> [ zeroinitializer, %B356.if.i.i ], [ %.1356.i.i, %B1932.loopexit.i.i ]
  %b2.2.1.lcssa.i.i = phi <8 x double> [ zeroinitializer, %B356.if.i.i ], [ %.1376.i.i, %B1932.loopexit.i.i ]
  %b3.2.1.lcssa.i.i = phi <8 x double> [ zeroinitializer, %B356.if.i.i ], [ %.1396.i.i, %B1932.loopexit.i.i ]
  %.1418.i.i = getelementptr inbounds double, ptr %.995.i, i64 %.1135889895.i.i
  store <8 x double> %b0.2.1.lcssa.i.i, ptr %.1418.i.i, align 8, !noalias !46
  %.1434.i.i = getelementptr double, ptr %24, i64 %.1135889895.i.i
  store <8 x double> %b1.2.1.lcssa.i.i, ptr %.1434.i.i, align 8, !noalias !46
  %.1451.i.i = getelementptr double, ptr %25, i64 %.1135889895.i.i
  store <8 x double> %b2.2.1.lcssa.i.i, ptr %.1451.i.i, align 8, !noalias !46
  %.1470.i.i = getelementptr double, ptr %26, i64 %.1135889895.i.i
  store <8 x double> %b3.2.1.lcssa.i.i, ptr %.1470.i.i, align 8, !noalias !46
  %.1129.i.i = icmp sgt i64 %.1128888896.i.i, 1
  br i1 %.1129.i.i, label %B356.if.i.i, label %B508.endif.endif.endif.i

B84.if.i.i:                                       ; preds = %B506.if.i, %B280.i.i
  %lsr.iv24.i.i = phi ptr [ %scevgep25.i.i, %B280.i.i ], [ %scevgep23.i.i, %B506.if.i ]
  %.186852864.i.i = phi i64 [ %.196.i.i, %B280.i.i ], [ %storemerge.i.i, %B506.if.i ]
  %.193853863.i.i = phi i64 [ %.200.i.i, %B280.i.i ], [ 0, %B506.if.i ]
  %.196.i.i = add nsw i64 %.186852864.i.i, -1
  %.200.i.i = add nuw nsw i64 %.193853863.i.i, 32
  %.237.i.i = getelementptr inbounds nuw double, ptr %.995.i, i64 %.193853863.i.i
  br i1 %8, label %B280.i.i, label %B200.if.i.i

B200.if.i.i:                                      ; preds = %B84.if.i.i, %B200.if.i.i
  %lsr.iv43.i.i = phi i64 [ %lsr.iv.next44.i.i, %B200.if.i.i ], [ %.186.i, %B84.if.i.i ]
  %lsr.iv26.i.i = phi i64 [ %lsr.iv.next27.i.i, %B200.if.i.i ], [ 0, %B84.if.i.i ]
  %_multiply_wide_v84_a33.2.1834.i.i = phi <8 x double> [ %.706.i.i, %B200.if.i.i ], [ zeroinitializer, %B84.if.i.i ]
  %_multiply_wide_v84_a32.2.1833.i.i = phi <8 x double> [ %.702.i.i, %B200.if.i.i ], [ zeroinitializer, %B84.if.i.i ]
  %_multiply_wide_v84_a31.2.1832.i.i = phi <8 x double> [ %.694.i.i, %B200.if.i.i ], [ zeroinitializer, %B84.if.i.i ]
  %_multiply_wide_v84_a30.2.1831.i.i = phi <8 x double> [ %.690.i.i, %B200.if.i.i ], [ zeroinitializer, %B84.if.i.i ]
  %_multiply_wide_v84_a23.2.1830.i.i = phi <8 x double> [ %.668.i.i, %B200.if.i.i ], [ zeroinitializer, %B84.if.i.i ]
  %_multiply_wide_v84_a22.2.1829.i.i = phi <8 x double> [ %.664.i.i, %B200.if.i.i ], [ zeroinitializer, %B84.if.i.i ]
  %_multiply_wide_v84_a21.2.1828.i.i = phi <8 x double> [ %.656.i.i, %B200.if.i.i ], [ zeroinitializer, %B84.if.i.i ]
  %_multiply_wide_v84_a20.2.1827.i.i = phi <8 x double> [ %.652.i.i, %B200.if.i.i ], [ zeroinitializer, %B84.if.i.i ]
  %_multiply_wide_v84_a13.2.1826.i.i = phi <8 x double> [ %.630.i.i, %B200.if.i.i ], [ zeroinitializer, %B84.if.i.i ]
  %_multiply_wide_v84_a12.2.1825.i.i = phi <8 x double> [ %.626.i.i, %B200.if.i.i ], [ zeroinitializer, %B84.if.i.i ]
  %_multiply_wide_v84_a11.2.1824.i.i = phi <8 x double> [ %.618.i.i, %B200.if.i.i ], [ zeroinitializer, %B84.if.i.i ]
  %_multiply_wide_v84_a10.2.1823.i.i = phi <8 x double> [ %.614.i.i, %B200.if.i.i ], [ zeroinitializer, %B84.if.i.i ]
  %_multiply_wide_v84_a03.2.1822.i.i = phi <8 x double> [ %.593.i.i, %B200.if.i.i ], [ zeroinitializer, %B84.if.i.i ]
  %_multiply_wide_v84_a02.2.1821.i.i = phi <8 x double> [ %.589.i.i, %B200.if.i.i ], [ zeroinitializer, %B84.if.i.i ]
  %_multiply_wide_v84_a01.2.1820.i.i = phi <8 x double> [ %.581.i.i, %B200.if.i.i ], [ zeroinitializer, %B84.if.i.i ]
  %_multiply_wide_v84_a00.2.1819.i.i = phi <8 x double> [ %.577.i.i, %B200.if.i.i ], [ zeroinitializer, %B84.if.i.i ]
  %23 = shl i64 %lsr.iv26.i.i, 2
  %scevgep33.i.i = getelementptr i8, ptr %lsr.iv24.i.i, i64 %23
  %scevgep34.i.i = getelementptr i8, ptr %scevgep33.i.i, i64 -192
  %.520.i.i = load <8 x double>, ptr %scevgep34.i.i, align 8, !noalias !46
  %scevgep32.i.i = getelementptr i8, ptr %scevgep33.i.i, i64 -128
  %.532.i.i = load <8 x double>, ptr %scevgep32.i.i, align 8, !noalias !46
  %scevgep9.i = getelementptr i8, ptr %scevgep33.i.i, i64 -64
  %.545.i.i = load <8 x double>, ptr %scevgep9.i, align 8, !noalias !46
  %.558.i.i = load <8 x double>, ptr %scevgep33.i.i, align 8, !noalias !46
  %scevgep72.i = getelementptr i8, ptr %lsr.iv.i, i64 %lsr.iv26.i.i
  %scevgep73.i = getelementptr i8, ptr %scevgep72.i, i64 -24
  %.573.i.i = load double, ptr %scevgep73.i, align 8, !noalias !46
  %.575.i.i = insertelement <8 x double> poison, double %.573.i.i, i64 0
  %.576.i.i = shufflevector <8 x double> %.575.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.577.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.520.i.i, <8 x double> %.576.i.i, <8 x double> %_multiply_wide_v84_a00.2.1819.i.i)
  %.581.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.532.i.i, <8 x double> %.576.i.i, <8 x double> %_multiply_wide_v84_a01.2.1820.i.i)
  %.589.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.545.i.i, <8 x double> %.576.i.i, <8 x double> %_multiply_wide_v84_a02.2.1821.i.i)
  %.593.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.558.i.i, <8 x double> %.576.i.i, <8 x double> %_multiply_wide_v84_a03.2.1822.i.i)
  %scevgep6.i = getelementptr i8, ptr %scevgep72.i, i64 -16
  %.610.i.i = load double, ptr %scevgep6.i, align 8, !noalias !46
  %.612.i.i = insertelement <8 x double> poison, double %.610.i.i, i64 0
  %.613.i.i = shufflevector <8 x double> %.612.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.614.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.520.i.i, <8 x double> %.613.i.i, <8 x double> %_multiply_wide_v84_a10.2.1823.i.i)
  %.618.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.532.i.i, <8 x double> %.613.i.i, <8 x double> %_multiply_wide_v84_a11.2.1824.i.i)
  %.626.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.545.i.i, <8 x double> %.613.i.i, <8 x double> %_multiply_wide_v84_a12.2.1825.i.i)
  %.630.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.558.i.i, <8 x double> %.613.i.i, <8 x double> %_multiply_wide_v84_a13.2.1826.i.i)
  %scevgep3.i = getelementptr i8, ptr %scevgep72.i, i64 -8
  %.648.i.i = load double, ptr %scevgep3.i, align 8, !noalias !46
  %.650.i.i = insertelement <8 x double> poison, double %.648.i.i, i64 0
  %.651.i.i = shufflevector <8 x double> %.650.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.652.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.520.i.i, <8 x double> %.651.i.i, <8 x double> %_multiply_wide_v84_a20.2.1827.i.i)
  %.656.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.532.i.i, <8 x double> %.651.i.i, <8 x double> %_multiply_wide_v84_a21.2.1828.i.i)
  %.664.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.545.i.i, <8 x double> %.651.i.i, <8 x double> %_multiply_wide_v84_a22.2.1829.i.i)
  %.668.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.558.i.i, <8 x double> %.651.i.i, <8 x double> %_multiply_wide_v84_a23.2.1830.i.i)
  %.686.i.i = load double, ptr %scevgep72.i, align 8, !noalias !46
  %.688.i.i = insertelement <8 x double> poison, double %.686.i.i, i64 0
  %.689.i.i = shufflevector <8 x double> %.688.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.690.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.520.i.i, <8 x double> %.689.i.i, <8 x double> %_multiply_wide_v84_a30.2.1831.i.i)
  %.694.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.532.i.i, <8 x double> %.689.i.i, <8 x double> %_multiply_wide_v84_a31.2.1832.i.i)
  %.702.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.545.i.i, <8 x double> %.689.i.i, <8 x double> %_multiply_wide_v84_a32.2.1833.i.i)
  %.706.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.558.i.i, <8 x double> %.689.i.i, <8 x double> %_multiply_wide_v84_a33.2.1834.i.i)
  %lsr.iv.next27.i.i = add nuw i64 %lsr.iv26.i.i, 64
  %lsr.iv.next44.i.i = add i64 %lsr.iv43.i.i, -1
  %exitcond.not.i27.i = icmp eq i64 %lsr.iv.next44.i.i, 0
  br i1 %exitcond.not.i27.i, label %B280.i.i, label %B200.if.i.i

B354.else.i.i:                                    ; preds = %B280.i.i, %B506.if.i
  %position.3.0.lcssa.i.i = phi i64 [ 0, %B506.if.i ], [ %factor.op.mul.reass.i, %B280.i.i ]
  br i1 %11, label %B508.endif.endif.endif.i, label %B354.endif.endif.endif.i.i

B354.endif.endif.endif.i.i:                       ; preds = %B354.else.i.i
  %24 = getelementptr double, ptr %.995.i, i64 %.223.i
  %25 = getelementptr i8, ptr %.995.i, i64 %.880.idx.i.i
  %26 = getelementptr i8, ptr %.995.i, i64 %.950.idx.i.i
  br label %B356.if.i.i

B356.if.i.i:                                      ; preds = %B354.endif.endif.endif.i.i, %B1932.i.i
  %position.5.0897.i.i = phi i64 [ %position.3.0.lcssa.i.i, %B354.endif.endif.endif.i.i ], [ %position.4.1.lcssa.i.i, %B1932.i.i ]
  %.1128888896.i.i = phi i64 [ %.1106806.i.i, %B354.endif.endif.endif.i.i ], [ %.1138.i.i, %B1932.i.i ]
  %.1135889895.i.i = phi i64 [ %.1046.i.i, %B354.endif.endif.endif.i.i ], [ %.1142.i.i, %B1932.i.i ]
  %.1138.i.i = add nsw i64 %.1128888896.i.i, -1
  %.1142.i.i = add nuw nsw i64 %.1135889895.i.i, 8
  br i1 %8, label %B1932.i.i, label %B884.if.preheader.i.i

B884.if.preheader.i.i:                            ; preds = %B356.if.i.i
  %27 = shl i64 %position.5.0897.i.i, 3
  %scevgep.i29.i = getelementptr i8, ptr %.402.i, i64 %27
  br label %B884.if.i.i

B884.if.i.i:                                      ; preds = %B884.if.i.i, %B884.if.preheader.i.i
  %lsr.iv21.i30.i = phi i64 [ %.186.i, %B884.if.preheader.i.i ], [ %lsr.iv.next22.i.i, %B884.if.i.i ]
  %lsr.iv.i31.i = phi i64 [ 0, %B884.if.preheader.i.i ], [ %lsr.iv.next.i33.i, %B884.if.i.i ]
  %b3.2.1880.i.i = phi <8 x double> [ zeroinitializer, %B884.if.preheader.i.i ], [ %.1396.i.i, %B884.if.i.i ]
  %b2.2.1879.i.i = phi <8 x double> [ zeroinitializer, %B884.if.preheader.i.i ], [ %.1376.i.i, %B884.if.i.i ]
  %b1.2.1878.i.i = phi <8 x double> [ zeroinitializer, %B884.if.preheader.i.i ], [ %.1356.i.i, %B884.if.i.i ]
  %b0.2.1877.i.i = phi <8 x double> [ zeroinitializer, %B884.if.preheader.i.i ], [ %.1337.i.i, %B884.if.i.i ]
  %scevgep12.i.i = getelementptr i8, ptr %scevgep.i29.i, i64 %lsr.iv.i31.i
  %.1318.i.i = load <8 x double>, ptr %scevgep12.i.i, align 8, !noalias !46
  %scevgep81.i = getelementptr i8, ptr %lsr.iv.i, i64 %lsr.iv.i31.i
  %scevgep82.i = getelementptr i8, ptr %scevgep81.i, i64 -24
  %.1333.i.i = load double, ptr %scevgep82.i, align 8, !noalias !46
  %.1335.i.i = insertelement <8 x double> poison, double %.1333.i.i, i64 0
  %.1336.i.i = shufflevector <8 x double> %.1335.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1337.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1318.i.i, <8 x double> %.1336.i.i, <8 x double> %b0.2.1877.i.i)
  %scevgep15.i = getelementptr i8, ptr %scevgep81.i, i64 -16
  %.1352.i.i = load double, ptr %scevgep15.i, align 8, !noalias !46
  %.1354.i.i = insertelement <8 x double> poison, double %.1352.i.i, i64 0
  %.1355.i.i = shufflevector <8 x double> %.1354.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1356.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1318.i.i, <8 x double> %.1355.i.i, <8 x double> %b1.2.1878.i.i)
  %scevgep13.i = getelementptr i8, ptr %scevgep81.i, i64 -8
  %.1372.i.i = load double, ptr %scevgep13.i, align 8, !noalias !46
  %.1374.i.i = insertelement <8 x double> poison, double %.1372.i.i, i64 0
  %.1375.i.i = shufflevector <8 x double> %.1374.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1376.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1318.i.i, <8 x double> %.1375.i.i, <8 x double> %b2.2.1879.i.i)
  %.1392.i.i = load double, ptr %scevgep81.i, align 8, !noalias !46
  %.1394.i.i = insertelement <8 x double> poison, double %.1392.i.i, i64 0
  %.1395.i.i = shufflevector <8 x double> %.1394.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1396.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1318.i.i, <8 x double> %.1395.i.i, <8 x double> %b3.2.1880.i.i)
  %lsr.iv.next.i33.i = add nuw i64 %lsr.iv.i31.i, 64
  %lsr.iv.next22.i.i = add i64 %lsr.iv21.i30.i, -1
  %exitcond905.not.i.i = icmp eq i64 %lsr.iv.next22.i.i, 0
  br i1 %exitcond905.not.i.i, label %B1932.loopexit.i.i, label %B884.if.i.i

B508.endif.endif.endif.i:                         ; preds = %B1932.i.i, %B354.else.i.i
  %scevgep66.i = getelementptr i8, ptr %lsr.iv.i, i64 32
  %.940.i = icmp sgt i64 %.939552560.i, 1
  br i1 %.940.i, label %B506.if.i, label %B418.loopexit.i

_ZN17bnserve_surrogate8tangents11_regression11_along_axesB4v114B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit: ; preds = %B418.loopexit.i
  %.451 = getelementptr i8, ptr %arg.contents.4, i64 104
  %.452 = load i64, ptr %.451, align 8
  %.465 = getelementptr inbounds double, ptr %arg.weights.4, i64 %.452
  %.552 = load i64, ptr %.129, align 8
  store ptr null, ptr %.558, align 8
  call fastcc void @inner_4(ptr nonnull %.558, ptr %.207.fca.4.load, i64 %arg.rows, i64 %.552, i64 %.174, ptr %.465, i64 %arg.width, ptr %arg.linear.4)
  %.190.2.idx.i = shl nsw i64 %.174, 4
  %.190.3.idx.i = mul nsw i64 %.174, 24
  %.190.4.idx.i = shl nsw i64 %.174, 5
  %.190.6.idx.i = mul nsw i64 %.174, 48
  %.190.7.idx.i = mul nsw i64 %.174, 56
  %28 = sub i64 0, %.139.1
  %.467.i = lshr exact i64 %28, 3
  %29 = shl i64 %.174, 3
  %30 = lshr i64 %.131, 3
  %31 = shl i64 %30, 11
  %32 = sub i64 2112, %31
  %33 = shl i64 %30, 9
  %34 = sub i64 576, %33
  %35 = shl i64 %30, 10
  %36 = sub i64 1088, %35
  %37 = add nuw nsw i64 %.467.i, 5
  %.neg = mul i64 %30, -3072
  %.neg1 = mul i64 %30, -2560
  %.neg2 = mul i64 %30, -1536
  %38 = icmp slt i64 %arg.rows, 1
  %sunkaddr14 = getelementptr inbounds i8, ptr %.306, i64 %29
  %sunkaddr15 = getelementptr i8, ptr %.306, i64 %.190.2.idx.i
  %sunkaddr16 = getelementptr i8, ptr %.306, i64 %.190.3.idx.i
  %sunkaddr17 = getelementptr i8, ptr %.306, i64 %.190.4.idx.i
  %sunkaddr18 = getelementptr i8, ptr %.306, i64 %.231
  %sunkaddr19 = getelementptr i8, ptr %.306, i64 %.190.6.idx.i
  %sunkaddr20 = getelementptr i8, ptr %.306, i64 %.190.7.idx.i
  %39 = icmp ult i64 %.139.1, -9223372036854775807
  br label %B464.if

B656:                                             ; preds = %B466.endif
  store ptr null, ptr %retptr, align 8
  ret void

B464.if:                                          ; preds = %B466.endif, %_ZN17bnserve_surrogate8tangents11_regression11_along_axesB4v114B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit
  %.676429433 = phi i64 [ %.683, %B466.endif ], [ 0, %_ZN17bnserve_surrogate8tangents11_regression11_along_axesB4v114B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit ]
  %.683 = add nuw nsw i64 %.676429433, 1
  store <8 x double> zeroinitializer, ptr %.306, align 8, !noalias !49
  store <8 x double> zeroinitializer, ptr %sunkaddr14, align 8, !noalias !49
  store <8 x double> zeroinitializer, ptr %sunkaddr15, align 8, !noalias !49
  store <8 x double> zeroinitializer, ptr %sunkaddr16, align 8, !noalias !49
  store <8 x double> zeroinitializer, ptr %sunkaddr17, align 8, !noalias !49
  store <8 x double> zeroinitializer, ptr %sunkaddr18, align 8, !noalias !49
  store <8 x double> zeroinitializer, ptr %sunkaddr19, align 8, !noalias !49
  store <8 x double> zeroinitializer, ptr %sunkaddr20, align 8, !noalias !49
  br i1 %38, label %B466.endif, label %B168.if.lr.ph.i

B168.if.lr.ph.i:                                  ; preds = %B464.if
  %.idx.i = mul nuw nsw i64 %.676429433, 320
  %40 = getelementptr i8, ptr %arg.jacobian.4, i64 %.idx.i
  br label %B168.if.i

B166.loopexit.i:                                  ; preds = %B574.if.i, %B168.if.i
  %scevgep = getelementptr i8, ptr %lsr.iv, i64 %29
  %exitcond.not.i = icmp eq i64 %.294.i, %arg.rows
  br i1 %exitcond.not.i, label %B466.endif, label %B168.if.i

B168.if.i:                                        ; preds = %B166.loopexit.i, %B168.if.lr.ph.i
  %lsr.iv = phi ptr [ %scevgep, %B166.loopexit.i ], [ %arg.scratch.4, %B168.if.lr.ph.i ]
  %.287306318.i = phi i64 [ %.294.i, %B166.loopexit.i ], [ 0, %B168.if.lr.ph.i ]
  %.294.i = add nuw nsw i64 %.287306318.i, 1
  br i1 %39, label %B166.loopexit.i, label %B574.if.lr.ph.i

B574.if.lr.ph.i:                                  ; preds = %B168.if.i
  %sunkaddr.i = shl i64 %.287306318.i, 3
  %sunkaddr26.i = getelementptr i8, ptr %40, i64 %sunkaddr.i
  %sunkaddr27.i = getelementptr i8, ptr %sunkaddr26.i, i64 128
  %.365.i = load double, ptr %sunkaddr27.i, align 8, !noalias !49
  %.330.i = getelementptr double, ptr %40, i64 %.287306318.i
  %.331.i = load double, ptr %.330.i, align 8, !noalias !49
  %sunkaddr30.i = getelementptr i8, ptr %sunkaddr26.i, i64 256
  %.399.i = load double, ptr %sunkaddr30.i, align 8, !noalias !49
  %sunkaddr33.i = getelementptr i8, ptr %sunkaddr26.i, i64 192
  %.379.i = load double, ptr %sunkaddr33.i, align 8, !noalias !49
  %sunkaddr36.i = getelementptr i8, ptr %sunkaddr26.i, i64 64
  %.345.i = load double, ptr %sunkaddr36.i, align 8, !noalias !49
  %.574.i = insertelement <8 x double> poison, double %.345.i, i64 0
  %.575.i = shufflevector <8 x double> %.574.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.629.i = insertelement <8 x double> poison, double %.379.i, i64 0
  %.630.i = shufflevector <8 x double> %.629.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.670.i = insertelement <8 x double> poison, double %.399.i, i64 0
  %.671.i = shufflevector <8 x double> %.670.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.6.i.i = insertelement <8 x double> poison, double %.331.i, i64 0
  %.7.i.i = shufflevector <8 x double> %.6.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.6.i7.i = insertelement <8 x double> poison, double %.365.i, i64 0
  %.7.i8.i = shufflevector <8 x double> %.6.i7.i, <8 x double> poison, <8 x i32> zeroinitializer
  br label %B574.if.i

B574.if.i:                                        ; preds = %B574.if.i, %B574.if.lr.ph.i
  %lsr.iv9 = phi i64 [ %lsr.iv.next10, %B574.if.i ], [ %37, %B574.if.lr.ph.i ]
  %lsr.iv63 = phi ptr [ %scevgep64, %B574.if.i ], [ %lsr.iv, %B574.if.lr.ph.i ]
  %scevgep70 = getelementptr i8, ptr %lsr.iv63, i64 %36
  %.537.i = load <8 x double>, ptr %scevgep70, align 8, !noalias !49
  %scevgep69 = getelementptr i8, ptr %lsr.iv63, i64 %34
  %.547.i = load <8 x double>, ptr %scevgep69, align 8, !noalias !49
  %.8.i.i = fmul contract <8 x double> %.7.i.i, %.547.i
  %scevgep68 = getelementptr i8, ptr %lsr.iv63, i64 %32
  %.589.i = load <8 x double>, ptr %scevgep68, align 8, !noalias !49
  %41 = getelementptr i8, ptr %lsr.iv63, i64 %.neg2
  %scevgep13 = getelementptr i8, ptr %41, i64 1600
  %.602.i = load <8 x double>, ptr %scevgep13, align 8, !noalias !49
  %.8.i9.i = fmul contract <8 x double> %.7.i8.i, %.602.i
  %.576.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.537.i, <8 x double> %.575.i, <8 x double> %.8.i.i)
  %.631.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.589.i, <8 x double> %.630.i, <8 x double> %.8.i9.i)
  %42 = getelementptr i8, ptr %lsr.iv63, i64 %.neg1
  %scevgep12 = getelementptr i8, ptr %42, i64 2624
  %.644.i = load <8 x double>, ptr %scevgep12, align 8, !noalias !49
  %.6.i10.i = fadd contract <8 x double> %.576.i, %.631.i
  %.672.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.644.i, <8 x double> %.671.i, <8 x double> %.6.i10.i)
  %43 = getelementptr i8, ptr %lsr.iv63, i64 %.neg
  %scevgep11 = getelementptr i8, ptr %43, i64 3136
  store <8 x double> %.672.i, ptr %scevgep11, align 8, !noalias !49
  %scevgep64 = getelementptr i8, ptr %lsr.iv63, i64 64
  %lsr.iv.next10 = add nsw i64 %lsr.iv9, -1
  %.488.i = icmp sgt i64 %lsr.iv9, 6
  br i1 %.488.i, label %B574.if.i, label %B166.loopexit.i

B466.endif:                                       ; preds = %B166.loopexit.i, %B464.if
  %.745 = shl i64 %.676429433, 3
  %.746 = add nuw nsw i64 %.745, 8
  %.748 = mul nsw i64 %.746, %arg.width
  %.759 = getelementptr inbounds double, ptr %arg.linear.4, i64 %.748
  %.840 = load i64, ptr %.129, align 8
  store ptr null, ptr %.846, align 8
  call fastcc void @inner_4(ptr nonnull %.846, ptr nonnull %.306, i64 %arg.rows, i64 %.840, i64 %.174, ptr %.465, i64 %arg.width, ptr %.759)
  %exitcond.not = icmp eq i64 %.683, 5
  br i1 %exitcond.not, label %B656, label %B464.if
}

; Function Attrs: nofree norecurse nosync nounwind memory(readwrite, inaccessiblemem: none, target_mem0: none, target_mem1: none)
define internal fastcc noundef range(i32 0, 2) i32 @inner_2(ptr noalias nonnull writeonly captures(none) %retptr, ptr noalias nonnull writeonly captures(none) %excinfo, i64 %arg.i, ptr readonly captures(none) %arg.state.0.4, ptr readonly captures(none) %arg.state.1.4, ptr readonly captures(none) %arg.state.2.4, ptr readonly captures(none) %arg.state.3.4, ptr readonly captures(none) %arg.state.4.4, i64 %arg.state.5, ptr readonly captures(none) %arg.state.6.4, i64 range(i64 8, 1) %arg.state.7.0, i64 range(i64 8, 1) %arg.state.7.1, i64 range(i64 8, 0) %arg.state.7.2, ptr captures(none) %arg.state.8.0.4, ptr captures(none) %arg.state.8.1.4, ptr captures(none) %arg.state.9.0.4, i64 range(i64 8, 1) %arg.state.9.0.5.0, ptr captures(none) %arg.state.9.1.4, i64 range(i64 8, 1) %arg.state.9.1.5.0, ptr captures(none) %arg.state.10.0.4, ptr captures(none) %arg.state.10.1.4, ptr %arg.state.11.4, ptr captures(none) %arg.state.12.4, ptr captures(none) %arg.state.13.4, ptr captures(none) %arg.state.14.4, ptr %arg.state.15.4, ptr captures(none) %arg.state.16.4) unnamed_addr #0 {
entry:
  %.3274.i.i = alloca i64, align 8
  %.3454.i.i = alloca i64, align 8
  %.1098.i7 = alloca i64, align 8
  %.1138.i9 = alloca [4 x i64], align 8
  %excinfo.6.i10 = alloca ptr, align 8
  %.1222.i11 = alloca ptr, align 8
  %.1994.i13 = alloca [2 x i64], align 8
  %.2352.i = alloca ptr, align 8
  %.1098.i = alloca i64, align 8
  %.1138.i = alloca [4 x i64], align 8
  %excinfo.6.i = alloca ptr, align 8
  %.1222.i = alloca ptr, align 8
  %.1994.i = alloca [2 x i64], align 8
  %.2351.i = alloca ptr, align 8
  %.568.i.i.i = alloca ptr, align 8
  %.599.i.i.i = alloca ptr, align 8
  %.632.i.i.i = alloca ptr, align 8
  %.669.i.i.i = alloca ptr, align 8
  %.737.i.i.i = alloca ptr, align 8
  %.775.i.i.i = alloca ptr, align 8
  %.305.i = getelementptr i8, ptr %arg.state.1.4, i64 112
  %.306.i = load i64, ptr %.305.i, align 8, !noalias !52
  %.322.i = getelementptr double, ptr %arg.state.2.4, i64 %.306.i
  %.419.i = getelementptr i8, ptr %arg.state.1.4, i64 120
  %.420.i = load i64, ptr %.419.i, align 8, !noalias !52
  %.436.i = getelementptr double, ptr %arg.state.2.4, i64 %.420.i
  %0 = lshr i64 %arg.state.7.0, 33
  %.99.i.i = and i64 %0, 1073741824
  %.100.i.i = add i64 %.99.i.i, %arg.state.7.0
  %.234.i.i = shl i64 %arg.state.7.0, 1
  %.272.i.i = add i64 %.99.i.i, %.234.i.i
  %.idx.i.i = mul i64 %arg.state.7.0, 24
  %.1398.idx.i = shl i64 %arg.state.7.0, 4
  %1 = lshr i64 %arg.state.7.1, 33
  %.99.i78.i = and i64 %1, 1073741824
  %.100.i79.i = add i64 %.99.i78.i, %arg.state.7.1
  %.234.i88.i = shl i64 %arg.state.7.1, 1
  %.272.i89.i = add i64 %.99.i78.i, %.234.i88.i
  %.idx.i103.i = mul i64 %arg.state.7.1, 24
  %scevgep356.i = getelementptr i8, ptr %arg.state.8.0.4, i64 %.idx.i.i
  %2 = shl i64 %arg.state.7.0, 5
  %scevgep359.i = getelementptr i8, ptr %arg.state.8.0.4, i64 %.1398.idx.i
  %3 = shl i64 %arg.state.7.0, 3
  %scevgep363.i = getelementptr i8, ptr %arg.state.8.0.4, i64 %3
  %4 = shl i64 %arg.state.5, 3
  %5 = mul i64 %4, %arg.state.7.2
  %6 = getelementptr i8, ptr %arg.state.3.4, i64 %5
  %7 = getelementptr i8, ptr %6, i64 %3
  %scevgep370.i = getelementptr i8, ptr %7, i64 8
  %8 = shl i64 %arg.state.7.2, 6
  %scevgep376.i = getelementptr i8, ptr %6, i64 8
  %scevgep383.i = getelementptr i8, ptr %arg.state.8.1.4, i64 %.idx.i103.i
  %9 = shl i64 %arg.state.7.1, 5
  %10 = shl i64 %arg.state.7.1, 4
  %scevgep387.i = getelementptr i8, ptr %arg.state.8.1.4, i64 %10
  %11 = shl i64 %arg.state.7.1, 3
  %scevgep391.i = getelementptr i8, ptr %arg.state.8.1.4, i64 %11
  %12 = getelementptr i8, ptr %6, i64 %.1398.idx.i
  %13 = getelementptr i8, ptr %12, i64 %11
  %scevgep398.i = getelementptr i8, ptr %13, i64 8
  %scevgep404.i = getelementptr i8, ptr %12, i64 8
  %14 = tail call i64 @llvm.smax.i64(i64 %.100.i.i, i64 0)
  %.88.sroa.0.3.i.i = tail call i64 @llvm.smin.i64(i64 %14, i64 1073741824)
  %.201.i.i = getelementptr double, ptr %.322.i, i64 %.88.sroa.0.3.i.i
  %15 = tail call i64 @llvm.smax.i64(i64 %.272.i.i, i64 0)
  %.260.sroa.0.3.i.i = tail call i64 @llvm.smin.i64(i64 %15, i64 1073741824)
  %16 = tail call i64 @llvm.smax.i64(i64 %.100.i79.i, i64 0)
  %.88.sroa.0.3.i86.i = tail call i64 @llvm.smin.i64(i64 %16, i64 1073741824)
  %.201.i87.i = getelementptr double, ptr %.436.i, i64 %.88.sroa.0.3.i86.i
  %17 = tail call i64 @llvm.smax.i64(i64 %.272.i89.i, i64 0)
  %.260.sroa.0.3.i96.i = tail call i64 @llvm.smin.i64(i64 %17, i64 1073741824)
  %18 = add i64 %.306.i, %.260.sroa.0.3.i.i
  %19 = add i64 %.420.i, %.260.sroa.0.3.i96.i
  %20 = shl i64 %19, 3
  %scevgep22.i = getelementptr i8, ptr %arg.state.2.4, i64 %20
  %21 = shl i64 %18, 3
  %scevgep.i = getelementptr i8, ptr %arg.state.2.4, i64 %21
  %sunkaddr14.i = getelementptr i8, ptr %arg.state.1.4, i64 56
  %sunkaddr.i = getelementptr i8, ptr %arg.state.1.4, i64 64
  br label %B264.if.i

B632.i:                                           ; preds = %B266.endif.endif.endif.endif.endif.endif.endif.endif.i
  %.1653.i = getelementptr i8, ptr %arg.state.6.4, i64 56
  %.1654.i = load double, ptr %.1653.i, align 8, !noalias !52
  %.1661.i = fdiv contract double 1.000000e+00, %.1654.i
  %.2193.idx.i = mul i64 %arg.state.7.0, 192
  %.2193.i = getelementptr i8, ptr %arg.state.8.0.4, i64 %.2193.idx.i
  %.2344.idx.i = mul i64 %arg.state.7.1, 192
  %.2344.i = getelementptr i8, ptr %arg.state.8.1.4, i64 %.2344.idx.i
  %.120148.not.i.i = icmp slt i64 %arg.state.7.0, 1
  br i1 %.120148.not.i.i, label %B632.endif.endif.endif.endif.endif.endif.i, label %B34.if.lr.ph.i.i

B264.if.i:                                        ; preds = %B266.endif.endif.endif.endif.endif.endif.endif.endif.i, %entry
  %lsr.iv405.i = phi ptr [ %scevgep404.i, %entry ], [ %scevgep406.i, %B266.endif.endif.endif.endif.endif.endif.endif.endif.i ]
  %lsr.iv399.i = phi ptr [ %scevgep398.i, %entry ], [ %scevgep400.i, %B266.endif.endif.endif.endif.endif.endif.endif.endif.i ]
  %lsr.iv395.i = phi ptr [ %arg.state.8.1.4, %entry ], [ %scevgep396.i, %B266.endif.endif.endif.endif.endif.endif.endif.endif.i ]
  %lsr.iv392.i = phi ptr [ %scevgep391.i, %entry ], [ %scevgep393.i, %B266.endif.endif.endif.endif.endif.endif.endif.endif.i ]
  %lsr.iv388.i = phi ptr [ %scevgep387.i, %entry ], [ %scevgep389.i, %B266.endif.endif.endif.endif.endif.endif.endif.endif.i ]
  %lsr.iv384.i = phi ptr [ %scevgep383.i, %entry ], [ %scevgep385.i, %B266.endif.endif.endif.endif.endif.endif.endif.endif.i ]
  %lsr.iv377.i = phi ptr [ %scevgep376.i, %entry ], [ %scevgep378.i, %B266.endif.endif.endif.endif.endif.endif.endif.endif.i ]
  %lsr.iv371.i = phi ptr [ %scevgep370.i, %entry ], [ %scevgep372.i, %B266.endif.endif.endif.endif.endif.endif.endif.endif.i ]
  %lsr.iv367.i = phi ptr [ %arg.state.8.0.4, %entry ], [ %scevgep368.i, %B266.endif.endif.endif.endif.endif.endif.endif.endif.i ]
  %lsr.iv364.i = phi ptr [ %scevgep363.i, %entry ], [ %scevgep365.i, %B266.endif.endif.endif.endif.endif.endif.endif.endif.i ]
  %lsr.iv360.i = phi ptr [ %scevgep359.i, %entry ], [ %scevgep361.i, %B266.endif.endif.endif.endif.endif.endif.endif.endif.i ]
  %lsr.iv.i = phi ptr [ %scevgep356.i, %entry ], [ %scevgep357.i, %B266.endif.endif.endif.endif.endif.endif.endif.endif.i ]
  %.517.0.i = phi i64 [ 0, %entry ], [ %.586.i, %B266.endif.endif.endif.endif.endif.endif.endif.endif.i ]
  %.586.i = add nuw nsw i64 %.517.0.i, 1
  %.1340.i = load i64, ptr %sunkaddr14.i, align 8, !noalias !52
  %22 = add i64 %.1340.i, 6
  %.486.i.i = lshr i64 %22, 3
  %.463.inv.i.i = icmp slt i64 %.1340.i, 2
  %.507321.not325.i.i = icmp eq i64 %.486.i.i, 0
  %.507321.not.i.i = or i1 %.463.inv.i.i, %.507321.not325.i.i
  br i1 %.507321.not.i.i, label %B266.endif.endif.endif.endif.endif.i, label %B94.if.lr.ph.i.i

B94.if.lr.ph.i.i:                                 ; preds = %B264.if.i
  %23 = add nuw nsw i64 %.486.i.i, 6
  br label %B94.if.i.i

B94.if.i.i:                                       ; preds = %B94.if.i.i, %B94.if.lr.ph.i.i
  %lsr.iv11.i = phi i64 [ %lsr.iv.next12.i, %B94.if.i.i ], [ %23, %B94.if.lr.ph.i.i ]
  %lsr.iv53.i.i = phi i64 [ %lsr.iv.next54.i.i, %B94.if.i.i ], [ 0, %B94.if.lr.ph.i.i ]
  %scevgep380.i = getelementptr i8, ptr %lsr.iv377.i, i64 %lsr.iv53.i.i
  %scevgep381.i = getelementptr i8, ptr %scevgep380.i, i64 -8
  %.554.i.i = load <8 x double>, ptr %scevgep381.i, align 8, !noalias !56
  %.565.i.i = load <8 x double>, ptr %scevgep380.i, align 8, !noalias !56
  %scevgep374.i = getelementptr i8, ptr %lsr.iv371.i, i64 %lsr.iv53.i.i
  %scevgep375.i = getelementptr i8, ptr %scevgep374.i, i64 -8
  %.575.i.i = load <8 x double>, ptr %scevgep375.i, align 8, !noalias !56
  %.586.i.i = load <8 x double>, ptr %scevgep374.i, align 8, !noalias !56
  %scevgep67.i.i = getelementptr i8, ptr %.201.i.i, i64 %lsr.iv53.i.i
  %.596.i.i = load <8 x double>, ptr %scevgep67.i.i, align 8, !noalias !56
  %scevgep13.i = getelementptr i8, ptr %scevgep.i, i64 %lsr.iv53.i.i
  %.606.i.i = load <8 x double>, ptr %scevgep13.i, align 8, !noalias !56
  %.6.i.i.i = fsub contract <8 x double> %.565.i.i, %.554.i.i
  %.6.i46.i.i = fmul contract <8 x double> %.6.i.i.i, %.606.i.i
  %scevgep369.i = getelementptr i8, ptr %lsr.iv367.i, i64 %lsr.iv53.i.i
  store <8 x double> %.554.i.i, ptr %scevgep369.i, align 8, !noalias !56
  %.669.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.575.i.i, <8 x double> splat (double 2.000000e+00), <8 x double> %.586.i.i)
  %.8.i.i.i = fmul contract <8 x double> %.669.i.i, splat (double 0x3FC5555555555555)
  %.6.i47.i.i = fmul contract <8 x double> %.596.i.i, %.8.i.i.i
  %.6.i48.i.i = fsub contract <8 x double> %.6.i46.i.i, %.6.i47.i.i
  %scevgep366.i = getelementptr i8, ptr %lsr.iv364.i, i64 %lsr.iv53.i.i
  store <8 x double> %.6.i48.i.i, ptr %scevgep366.i, align 8, !noalias !56
  %.8.i49.i.i = fmul contract <8 x double> %.575.i.i, splat (double 5.000000e-01)
  %scevgep362.i = getelementptr i8, ptr %lsr.iv360.i, i64 %lsr.iv53.i.i
  store <8 x double> %.8.i49.i.i, ptr %scevgep362.i, align 8, !noalias !56
  %.6.i50.i.i = fsub contract <8 x double> %.586.i.i, %.575.i.i
  %.6.i51.i.i = fmul contract <8 x double> %.6.i50.i.i, %.606.i.i
  %.8.i52.i.i = fmul contract <8 x double> %.6.i51.i.i, splat (double 0x3FC5555555555555)
  %scevgep358.i = getelementptr i8, ptr %lsr.iv.i, i64 %lsr.iv53.i.i
  store <8 x double> %.8.i52.i.i, ptr %scevgep358.i, align 8, !noalias !56
  %lsr.iv.next54.i.i = add i64 %lsr.iv53.i.i, 64
  %lsr.iv.next12.i = add nsw i64 %lsr.iv11.i, -1
  %.507.i.i = icmp sgt i64 %lsr.iv11.i, 7
  br i1 %.507.i.i, label %B94.if.i.i, label %B266.endif.endif.endif.endif.endif.i

B266.endif.endif.endif.endif.endif.i:             ; preds = %B94.if.i.i, %B264.if.i
  %.1558.i = load i64, ptr %sunkaddr.i, align 8, !noalias !52
  %24 = add i64 %.1558.i, 6
  %.486.i98.i = lshr i64 %24, 3
  %.463.inv.i99.i = icmp slt i64 %.1558.i, 2
  %.507321.not325.i100.i = icmp eq i64 %.486.i98.i, 0
  %.507321.not.i101.i = or i1 %.463.inv.i99.i, %.507321.not325.i100.i
  br i1 %.507321.not.i101.i, label %B266.endif.endif.endif.endif.endif.endif.endif.endif.i, label %B94.if.lr.ph.i102.i

B94.if.lr.ph.i102.i:                              ; preds = %B266.endif.endif.endif.endif.endif.i
  %25 = add nuw nsw i64 %.486.i98.i, 6
  br label %B94.if.i104.i

B94.if.i104.i:                                    ; preds = %B94.if.i104.i, %B94.if.lr.ph.i102.i
  %lsr.iv13.i = phi i64 [ %lsr.iv.next.i, %B94.if.i104.i ], [ %25, %B94.if.lr.ph.i102.i ]
  %lsr.iv53.i105.i = phi i64 [ %lsr.iv.next54.i134.i, %B94.if.i104.i ], [ 0, %B94.if.lr.ph.i102.i ]
  %scevgep408.i = getelementptr i8, ptr %lsr.iv405.i, i64 %lsr.iv53.i105.i
  %scevgep409.i = getelementptr i8, ptr %scevgep408.i, i64 -8
  %.554.i108.i = load <8 x double>, ptr %scevgep409.i, align 8, !noalias !59
  %.565.i110.i = load <8 x double>, ptr %scevgep408.i, align 8, !noalias !59
  %scevgep402.i = getelementptr i8, ptr %lsr.iv399.i, i64 %lsr.iv53.i105.i
  %scevgep403.i = getelementptr i8, ptr %scevgep402.i, i64 -8
  %.575.i112.i = load <8 x double>, ptr %scevgep403.i, align 8, !noalias !59
  %.586.i114.i = load <8 x double>, ptr %scevgep402.i, align 8, !noalias !59
  %scevgep67.i115.i = getelementptr i8, ptr %.201.i87.i, i64 %lsr.iv53.i105.i
  %.596.i116.i = load <8 x double>, ptr %scevgep67.i115.i, align 8, !noalias !59
  %scevgep23.i = getelementptr i8, ptr %scevgep22.i, i64 %lsr.iv53.i105.i
  %.606.i118.i = load <8 x double>, ptr %scevgep23.i, align 8, !noalias !59
  %.6.i.i119.i = fsub contract <8 x double> %.565.i110.i, %.554.i108.i
  %.6.i46.i120.i = fmul contract <8 x double> %.6.i.i119.i, %.606.i118.i
  %scevgep397.i = getelementptr i8, ptr %lsr.iv395.i, i64 %lsr.iv53.i105.i
  store <8 x double> %.554.i108.i, ptr %scevgep397.i, align 8, !noalias !59
  %.669.i122.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.575.i112.i, <8 x double> splat (double 2.000000e+00), <8 x double> %.586.i114.i)
  %.8.i.i123.i = fmul contract <8 x double> %.669.i122.i, splat (double 0x3FC5555555555555)
  %.6.i47.i124.i = fmul contract <8 x double> %.596.i116.i, %.8.i.i123.i
  %.6.i48.i125.i = fsub contract <8 x double> %.6.i46.i120.i, %.6.i47.i124.i
  %scevgep394.i = getelementptr i8, ptr %lsr.iv392.i, i64 %lsr.iv53.i105.i
  store <8 x double> %.6.i48.i125.i, ptr %scevgep394.i, align 8, !noalias !59
  %.8.i49.i127.i = fmul contract <8 x double> %.575.i112.i, splat (double 5.000000e-01)
  %scevgep390.i = getelementptr i8, ptr %lsr.iv388.i, i64 %lsr.iv53.i105.i
  store <8 x double> %.8.i49.i127.i, ptr %scevgep390.i, align 8, !noalias !59
  %.6.i50.i129.i = fsub contract <8 x double> %.586.i114.i, %.575.i112.i
  %.6.i51.i130.i = fmul contract <8 x double> %.6.i50.i129.i, %.606.i118.i
  %.8.i52.i131.i = fmul contract <8 x double> %.6.i51.i130.i, splat (double 0x3FC5555555555555)
  %scevgep386.i = getelementptr i8, ptr %lsr.iv384.i, i64 %lsr.iv53.i105.i
  store <8 x double> %.8.i52.i131.i, ptr %scevgep386.i, align 8, !noalias !59
  %lsr.iv.next54.i134.i = add i64 %lsr.iv53.i105.i, 64
  %lsr.iv.next.i = add nsw i64 %lsr.iv13.i, -1
  %.507.i135.i = icmp sgt i64 %lsr.iv13.i, 7
  br i1 %.507.i135.i, label %B94.if.i104.i, label %B266.endif.endif.endif.endif.endif.endif.endif.endif.i

B266.endif.endif.endif.endif.endif.endif.endif.endif.i: ; preds = %B94.if.i104.i, %B266.endif.endif.endif.endif.endif.i
  %scevgep357.i = getelementptr i8, ptr %lsr.iv.i, i64 %2
  %scevgep361.i = getelementptr i8, ptr %lsr.iv360.i, i64 %2
  %scevgep365.i = getelementptr i8, ptr %lsr.iv364.i, i64 %2
  %scevgep368.i = getelementptr i8, ptr %lsr.iv367.i, i64 %2
  %scevgep372.i = getelementptr i8, ptr %lsr.iv371.i, i64 %8
  %scevgep378.i = getelementptr i8, ptr %lsr.iv377.i, i64 %8
  %scevgep385.i = getelementptr i8, ptr %lsr.iv384.i, i64 %9
  %scevgep389.i = getelementptr i8, ptr %lsr.iv388.i, i64 %9
  %scevgep393.i = getelementptr i8, ptr %lsr.iv392.i, i64 %9
  %scevgep396.i = getelementptr i8, ptr %lsr.iv395.i, i64 %9
  %scevgep400.i = getelementptr i8, ptr %lsr.iv399.i, i64 %8
  %scevgep406.i = getelementptr i8, ptr %lsr.iv405.i, i64 %8
  %exitcond.not.i = icmp eq i64 %.586.i, 6
  br i1 %exitcond.not.i, label %B632.i, label %B264.if.i

B34.if.lr.ph.i.i:                                 ; preds = %B632.i
  %.223.i.i = fmul contract double %.1661.i, 2.000000e+00
  %.291.i.i = fmul contract double %.1661.i, 3.000000e+00
  %scevgep1.i.i = getelementptr i8, ptr %.2193.i, i64 %.idx.i.i
  %scevgep5.i.i = getelementptr i8, ptr %.2193.i, i64 %.1398.idx.i
  %scevgep9.i.i = getelementptr i8, ptr %.2193.i, i64 %3
  br label %B34.if.i.i

B34.if.i.i:                                       ; preds = %B34.if.i.i, %B34.if.lr.ph.i.i
  %.126147149.i.i = phi i64 [ 0, %B34.if.lr.ph.i.i ], [ %.133.i.i, %B34.if.i.i ]
  %.133.i.i = add nuw nsw i64 %.126147149.i.i, 1
  %26 = shl i64 %.126147149.i.i, 3
  %scevgep12.i.i = getelementptr i8, ptr %scevgep363.i, i64 %26
  %.189.i.i = load double, ptr %scevgep12.i.i, align 8, !noalias !62
  %.191.i.i = fmul contract double %.1661.i, %.189.i.i
  %scevgep.i.i = getelementptr i8, ptr %.2193.i, i64 %26
  store double %.191.i.i, ptr %scevgep.i.i, align 8, !noalias !62
  %scevgep10.i = getelementptr i8, ptr %scevgep359.i, i64 %26
  %.256.i.i = load double, ptr %scevgep10.i, align 8, !noalias !62
  %.257.i.i = fmul contract double %.223.i.i, %.256.i.i
  %scevgep9.i = getelementptr i8, ptr %scevgep9.i.i, i64 %26
  store double %.257.i.i, ptr %scevgep9.i, align 8, !noalias !62
  %scevgep8.i = getelementptr i8, ptr %scevgep356.i, i64 %26
  %.324.i.i = load double, ptr %scevgep8.i, align 8, !noalias !62
  %.325.i.i = fmul contract double %.291.i.i, %.324.i.i
  %scevgep7.i = getelementptr i8, ptr %scevgep5.i.i, i64 %26
  store double %.325.i.i, ptr %scevgep7.i, align 8, !noalias !62
  %scevgep6.i = getelementptr i8, ptr %scevgep1.i.i, i64 %26
  store double 0.000000e+00, ptr %scevgep6.i, align 8, !noalias !62
  %exitcond.not.i.i = icmp eq i64 %arg.state.7.0, %.133.i.i
  br i1 %exitcond.not.i.i, label %B632.endif.endif.endif.endif.endif.endif.i, label %B34.if.i.i

B632.endif.endif.endif.endif.endif.endif.i:       ; preds = %B34.if.i.i, %B632.i
  %.120148.not.i154.i = icmp slt i64 %arg.state.7.1, 1
  br i1 %.120148.not.i154.i, label %B632.endif.endif.endif.endif.endif.endif.endif.i, label %B34.if.lr.ph.i155.i

B34.if.lr.ph.i155.i:                              ; preds = %B632.endif.endif.endif.endif.endif.endif.i
  %.223.i156.i = fmul contract double %.1661.i, 2.000000e+00
  %.291.i157.i = fmul contract double %.1661.i, 3.000000e+00
  %scevgep1.i158.i = getelementptr i8, ptr %.2344.i, i64 %.idx.i103.i
  %scevgep5.i160.i = getelementptr i8, ptr %.2344.i, i64 %10
  %scevgep9.i162.i = getelementptr i8, ptr %.2344.i, i64 %11
  br label %B34.if.i164.i

B34.if.i164.i:                                    ; preds = %B34.if.i164.i, %B34.if.lr.ph.i155.i
  %.126147149.i165.i = phi i64 [ 0, %B34.if.lr.ph.i155.i ], [ %.133.i166.i, %B34.if.i164.i ]
  %.133.i166.i = add nuw nsw i64 %.126147149.i165.i, 1
  %27 = shl i64 %.126147149.i165.i, 3
  %scevgep12.i167.i = getelementptr i8, ptr %scevgep391.i, i64 %27
  %.189.i168.i = load double, ptr %scevgep12.i167.i, align 8, !noalias !65
  %.191.i169.i = fmul contract double %.1661.i, %.189.i168.i
  %scevgep.i170.i = getelementptr i8, ptr %.2344.i, i64 %27
  store double %.191.i169.i, ptr %scevgep.i170.i, align 8, !noalias !65
  %scevgep5.i = getelementptr i8, ptr %scevgep387.i, i64 %27
  %.256.i172.i = load double, ptr %scevgep5.i, align 8, !noalias !65
  %.257.i173.i = fmul contract double %.223.i156.i, %.256.i172.i
  %scevgep4.i = getelementptr i8, ptr %scevgep9.i162.i, i64 %27
  store double %.257.i173.i, ptr %scevgep4.i, align 8, !noalias !65
  %scevgep3.i = getelementptr i8, ptr %scevgep383.i, i64 %27
  %.324.i176.i = load double, ptr %scevgep3.i, align 8, !noalias !65
  %.325.i177.i = fmul contract double %.291.i157.i, %.324.i176.i
  %scevgep2.i = getelementptr i8, ptr %scevgep5.i160.i, i64 %27
  store double %.325.i177.i, ptr %scevgep2.i, align 8, !noalias !65
  %scevgep1.i = getelementptr i8, ptr %scevgep1.i158.i, i64 %27
  store double 0.000000e+00, ptr %scevgep1.i, align 8, !noalias !65
  %exitcond.not.i180.i = icmp eq i64 %arg.state.7.1, %.133.i166.i
  br i1 %exitcond.not.i180.i, label %B632.endif.endif.endif.endif.endif.endif.endif.i, label %B34.if.i164.i

B632.endif.endif.endif.endif.endif.endif.endif.i: ; preds = %B34.if.i164.i, %B632.endif.endif.endif.endif.endif.endif.i
  %.80.i.i = getelementptr i8, ptr %arg.state.6.4, i64 8
  %.81.i.i = load double, ptr %.80.i.i, align 8, !noalias !68
  %.110.i.i = getelementptr i8, ptr %arg.state.6.4, i64 16
  %.111.i.i = load double, ptr %.110.i.i, align 8, !noalias !68
  %.15.le.i.i.i = fcmp contract uno double %.81.i.i, 0.000000e+00
  %.17.le.i.i.i = fcmp contract oge double %.81.i.i, 1.000000e+00
  %28 = or i1 %.15.le.i.i.i, %.17.le.i.i.i
  %29 = tail call contract double @llvm.log.f64(double %.81.i.i)
  %.31.le.i.i.i = select i1 %28, double %29, double 0.000000e+00
  %.5.i.i.i.i = fmul contract double %.31.le.i.i.i, 1.230000e-04
  %.6.i.i.i.i = fadd contract double %.5.i.i.i.i, -4.210000e-03
  %.7.i.i.i.i = fmul contract double %.31.le.i.i.i, %.6.i.i.i.i
  %.8.i.i.i.i = fadd contract double %.7.i.i.i.i, 4.740000e-02
  %.9.i.i.i.i = fmul contract double %.31.le.i.i.i, %.8.i.i.i.i
  %.10.i.i.i.i = fadd contract double %.9.i.i.i.i, 9.360000e-02
  %.11.i.i.i.i = fmul contract double %.31.le.i.i.i, %.10.i.i.i.i
  %.12.i.i.i.i = fadd contract double %.11.i.i.i.i, 1.940000e-01
  %.62.i.i.i = fcmp contract ogt double %.81.i.i, 1.000000e+00
  %.64.i.i.i = uitofp i1 %.62.i.i.i to double
  %.65.i.i.i = fmul contract double %.12.i.i.i.i, %.64.i.i.i
  %.73.le.i.i.i = tail call contract double @llvm.exp.f64(double %.65.i.i.i)
  %.15.le.i3.i.i = fcmp contract uno double %.111.i.i, 0.000000e+00
  %.17.le.i4.i.i = fcmp contract oge double %.111.i.i, 1.000000e+00
  %30 = or i1 %.15.le.i3.i.i, %.17.le.i4.i.i
  %31 = tail call contract double @llvm.log.f64(double %.111.i.i)
  %.31.le.i5.i.i = select i1 %30, double %31, double 0.000000e+00
  %.5.i.i6.i.i = fmul contract double %.31.le.i5.i.i, 1.230000e-04
  %.6.i.i7.i.i = fadd contract double %.5.i.i6.i.i, -4.210000e-03
  %.7.i.i8.i.i = fmul contract double %.31.le.i5.i.i, %.6.i.i7.i.i
  %.8.i.i9.i.i = fadd contract double %.7.i.i8.i.i, 4.740000e-02
  %.9.i.i10.i.i = fmul contract double %.31.le.i5.i.i, %.8.i.i9.i.i
  %.10.i.i11.i.i = fadd contract double %.9.i.i10.i.i, 9.360000e-02
  %.11.i.i12.i.i = fmul contract double %.31.le.i5.i.i, %.10.i.i11.i.i
  %.12.i.i13.i.i = fadd contract double %.11.i.i12.i.i, 1.940000e-01
  %.62.i14.i.i = fcmp contract ogt double %.111.i.i, 1.000000e+00
  %.64.i15.i.i = uitofp i1 %.62.i14.i.i to double
  %.65.i16.i.i = fmul contract double %.12.i.i13.i.i, %.64.i15.i.i
  %.73.le.i17.i.i = tail call contract double @llvm.exp.f64(double %.65.i16.i.i)
  %.8.i.i2.i = fcmp contract ugt double %.81.i.i, 1.000000e+00
  br i1 %.8.i.i2.i, label %for.end.i.i.i, label %B0.endif.endif.endif.i.i

for.end.i.i.i:                                    ; preds = %B632.endif.endif.endif.endif.endif.endif.endif.i
  %.31.i.i.i = fdiv contract double 1.000000e-30, %.81.i.i
  %.58.i.i.i.i.i = fmul contract double %29, 0.000000e+00
  %.64.i.i.i.i.i = fmul contract double %.31.i.i.i, 1.230000e-04
  %.80.i.i.i.i.i = fadd contract double %.58.i.i.i.i.i, %.64.i.i.i.i.i
  %.46.i.i.i.i.i = fmul contract double %29, 1.230000e-04
  %.52.i.i.i.i.i = fmul contract double %.31.i.i.i, 0.000000e+00
  %.70.i.i.i.i.i = fsub contract double %.46.i.i.i.i.i, %.52.i.i.i.i.i
  %.69.i.i.i.i = fadd contract double %.70.i.i.i.i.i, -4.210000e-03
  %.58.i1.i.i.i.i = fmul contract double %29, %.80.i.i.i.i.i
  %.64.i2.i.i.i.i = fmul contract double %.31.i.i.i, %.69.i.i.i.i
  %.80.i3.i.i.i.i = fadd contract double %.58.i1.i.i.i.i, %.64.i2.i.i.i.i
  %.46.i4.i.i.i.i = fmul contract double %29, %.69.i.i.i.i
  %.52.i5.i.i.i.i = fmul contract double %.31.i.i.i, %.80.i.i.i.i.i
  %.70.i6.i.i.i.i = fsub contract double %.46.i4.i.i.i.i, %.52.i5.i.i.i.i
  %.129.i.i.i.i = fadd contract double %.70.i6.i.i.i.i, 4.740000e-02
  %.132.i.i.i.i = fadd contract double %.80.i3.i.i.i.i, 0.000000e+00
  %.58.i8.i.i.i.i = fmul contract double %29, %.132.i.i.i.i
  %.64.i9.i.i.i.i = fmul contract double %.31.i.i.i, %.129.i.i.i.i
  %.80.i10.i.i.i.i = fadd contract double %.64.i9.i.i.i.i, %.58.i8.i.i.i.i
  %.46.i11.i.i.i.i = fmul contract double %29, %.129.i.i.i.i
  %.52.i12.i.i.i.i = fmul contract double %.31.i.i.i, %.132.i.i.i.i
  %.70.i13.i.i.i.i = fsub contract double %.46.i11.i.i.i.i, %.52.i12.i.i.i.i
  %.189.i.i.i.i = fadd contract double %.70.i13.i.i.i.i, 9.360000e-02
  %.192.i.i.i.i = fadd contract double %.80.i10.i.i.i.i, 0.000000e+00
  %.58.i15.i.i.i.i = fmul contract double %29, %.192.i.i.i.i
  %.64.i16.i.i.i.i = fmul contract double %.31.i.i.i, %.189.i.i.i.i
  %.80.i17.i.i.i.i = fadd contract double %.64.i16.i.i.i.i, %.58.i15.i.i.i.i
  %.252.i.i.i.i = fadd contract double %.80.i17.i.i.i.i, 0.000000e+00
  %.104.i.i.i = fdiv contract double %.252.i.i.i.i, 1.000000e-30
  %.105.i.i.i = fmul contract double %.73.le.i.i.i, %.104.i.i.i
  br label %B0.endif.endif.endif.i.i

B0.endif.endif.endif.i.i:                         ; preds = %for.end.i.i.i, %B632.endif.endif.endif.endif.endif.endif.endif.i
  %storemerge.i.i.i = phi double [ %.105.i.i.i, %for.end.i.i.i ], [ 0.000000e+00, %B632.endif.endif.endif.endif.endif.endif.endif.i ]
  %.8.i18.i.i = fcmp contract ugt double %.111.i.i, 1.000000e+00
  br i1 %.8.i18.i.i, label %for.end.i20.i.i, label %B238.if.lr.ph.i.i

for.end.i20.i.i:                                  ; preds = %B0.endif.endif.endif.i.i
  %.31.i36.i.i = fdiv contract double 1.000000e-30, %.111.i.i
  %.58.i.i.i37.i.i = fmul contract double %31, 0.000000e+00
  %.64.i.i.i38.i.i = fmul contract double %.31.i36.i.i, 1.230000e-04
  %.80.i.i.i39.i.i = fadd contract double %.58.i.i.i37.i.i, %.64.i.i.i38.i.i
  %.46.i.i.i40.i.i = fmul contract double %31, 1.230000e-04
  %.52.i.i.i41.i.i = fmul contract double %.31.i36.i.i, 0.000000e+00
  %.70.i.i.i42.i.i = fsub contract double %.46.i.i.i40.i.i, %.52.i.i.i41.i.i
  %.69.i.i43.i.i = fadd contract double %.70.i.i.i42.i.i, -4.210000e-03
  %.58.i1.i.i44.i.i = fmul contract double %31, %.80.i.i.i39.i.i
  %.64.i2.i.i45.i.i = fmul contract double %.31.i36.i.i, %.69.i.i43.i.i
  %.80.i3.i.i46.i.i = fadd contract double %.58.i1.i.i44.i.i, %.64.i2.i.i45.i.i
  %.46.i4.i.i47.i.i = fmul contract double %31, %.69.i.i43.i.i
  %.52.i5.i.i48.i.i = fmul contract double %.31.i36.i.i, %.80.i.i.i39.i.i
  %.70.i6.i.i49.i.i = fsub contract double %.46.i4.i.i47.i.i, %.52.i5.i.i48.i.i
  %.129.i.i50.i.i = fadd contract double %.70.i6.i.i49.i.i, 4.740000e-02
  %.132.i.i51.i.i = fadd contract double %.80.i3.i.i46.i.i, 0.000000e+00
  %.58.i8.i.i52.i.i = fmul contract double %31, %.132.i.i51.i.i
  %.64.i9.i.i53.i.i = fmul contract double %.31.i36.i.i, %.129.i.i50.i.i
  %.80.i10.i.i54.i.i = fadd contract double %.64.i9.i.i53.i.i, %.58.i8.i.i52.i.i
  %.46.i11.i.i55.i.i = fmul contract double %31, %.129.i.i50.i.i
  %.52.i12.i.i56.i.i = fmul contract double %.31.i36.i.i, %.132.i.i51.i.i
  %.70.i13.i.i57.i.i = fsub contract double %.46.i11.i.i55.i.i, %.52.i12.i.i56.i.i
  %.189.i.i58.i.i = fadd contract double %.70.i13.i.i57.i.i, 9.360000e-02
  %.192.i.i59.i.i = fadd contract double %.80.i10.i.i54.i.i, 0.000000e+00
  %.58.i15.i.i60.i.i = fmul contract double %31, %.192.i.i59.i.i
  %.64.i16.i.i61.i.i = fmul contract double %.31.i36.i.i, %.189.i.i58.i.i
  %.80.i17.i.i62.i.i = fadd contract double %.64.i16.i.i61.i.i, %.58.i15.i.i60.i.i
  %.252.i.i63.i.i = fadd contract double %.80.i17.i.i62.i.i, 0.000000e+00
  %.104.i64.i.i = fdiv contract double %.252.i.i63.i.i, 1.000000e-30
  %.105.i65.i.i = fmul contract double %.73.le.i17.i.i, %.104.i64.i.i
  br label %B238.if.lr.ph.i.i

B238.if.lr.ph.i.i:                                ; preds = %for.end.i20.i.i, %B0.endif.endif.endif.i.i
  %storemerge.i19.i.i = phi double [ %.105.i65.i.i, %for.end.i20.i.i ], [ 0.000000e+00, %B0.endif.endif.endif.i.i ]
  %scevgep.i3.i = getelementptr i8, ptr %arg.state.10.0.4, i64 1144
  %sunkaddr142.i.i = getelementptr i8, ptr %arg.state.6.4, i64 24
  %sunkaddr143.i.i = getelementptr i8, ptr %arg.state.6.4, i64 32
  %32 = getelementptr i8, ptr %arg.state.10.0.4, i64 256
  %33 = getelementptr i8, ptr %arg.state.10.0.4, i64 512
  %.80.i1.i.i.i = getelementptr inbounds nuw i8, ptr %arg.state.10.0.4, i64 8
  %.222.i.i.i.i = getelementptr i8, ptr %arg.state.10.0.4, i64 32
  %.225.i.i.i.i = getelementptr i8, ptr %arg.state.10.0.4, i64 40
  %.445.i.i.i.i = getelementptr i8, ptr %arg.state.10.0.4, i64 48
  %.448.i.i.i.i = getelementptr i8, ptr %arg.state.10.0.4, i64 56
  %.588.i.i.i.i = getelementptr i8, ptr %arg.state.10.0.4, i64 64
  %.591.i.i.i.i = getelementptr i8, ptr %arg.state.10.0.4, i64 72
  %.890.i.i.i.i = getelementptr i8, ptr %arg.state.10.0.4, i64 336
  %.893.i.i.i.i = getelementptr i8, ptr %arg.state.10.0.4, i64 344
  %.1111.i.i.i.i = getelementptr i8, ptr %arg.state.10.0.4, i64 96
  %.1114.i.i.i.i = getelementptr i8, ptr %arg.state.10.0.4, i64 104
  %.1502.i.i.i.i = getelementptr i8, ptr %arg.state.10.0.4, i64 352
  %.1505.i.i.i.i = getelementptr i8, ptr %arg.state.10.0.4, i64 360
  %.1645.i.i.i.i = getelementptr i8, ptr %arg.state.10.0.4, i64 112
  %.1648.i.i.i.i = getelementptr i8, ptr %arg.state.10.0.4, i64 120
  %.1947.i.i.i.i = getelementptr i8, ptr %arg.state.10.0.4, i64 384
  %.1950.i.i.i.i = getelementptr i8, ptr %arg.state.10.0.4, i64 392
  %.2435.i.i.i.i = getelementptr i8, ptr %arg.state.10.0.4, i64 640
  %.2438.i.i.i.i = getelementptr i8, ptr %arg.state.10.0.4, i64 648
  %.2656.i.i.i.i = getelementptr i8, ptr %arg.state.10.0.4, i64 144
  %.2659.i.i.i.i = getelementptr i8, ptr %arg.state.10.0.4, i64 152
  %.3047.i.i.i.i = getelementptr i8, ptr %arg.state.10.0.4, i64 400
  %.3050.i.i.i.i = getelementptr i8, ptr %arg.state.10.0.4, i64 408
  %.3494.i.i.i.i = getelementptr i8, ptr %arg.state.10.0.4, i64 160
  %.3497.i.i.i.i = getelementptr i8, ptr %arg.state.10.0.4, i64 168
  %.4246.i.i.i.i = getelementptr i8, ptr %arg.state.10.0.4, i64 416
  %.4249.i.i.i.i = getelementptr i8, ptr %arg.state.10.0.4, i64 424
  %.4475.i.i.i.i = getelementptr i8, ptr %arg.state.10.0.4, i64 176
  %.4478.i.i.i.i = getelementptr i8, ptr %arg.state.10.0.4, i64 184
  %.4963.i.i.i.i = getelementptr i8, ptr %arg.state.10.0.4, i64 432
  %.4966.i.i.i.i = getelementptr i8, ptr %arg.state.10.0.4, i64 440
  %sunkaddr173.i.i.i = getelementptr i8, ptr %arg.state.10.0.4, i64 16
  %sunkaddr175.i.i.i = getelementptr i8, ptr %arg.state.10.0.4, i64 24
  %sunkaddr173.2.i.i.i = getelementptr i8, ptr %arg.state.10.0.4, i64 80
  %sunkaddr175.2.i.i.i = getelementptr i8, ptr %arg.state.10.0.4, i64 88
  %sunkaddr.4.i.i.i = getelementptr i8, ptr %arg.state.10.0.4, i64 128
  %sunkaddr171.4.i.i.i = getelementptr i8, ptr %arg.state.10.0.4, i64 136
  %sunkaddr.6.i.i.i = getelementptr i8, ptr %arg.state.10.0.4, i64 192
  %sunkaddr171.6.i.i.i = getelementptr i8, ptr %arg.state.10.0.4, i64 200
  %sunkaddr173.6.i.i.i = getelementptr i8, ptr %arg.state.10.0.4, i64 208
  %sunkaddr175.6.i.i.i = getelementptr i8, ptr %arg.state.10.0.4, i64 216
  %sunkaddr.7.i.i.i = getelementptr i8, ptr %arg.state.10.0.4, i64 224
  %sunkaddr171.7.i.i.i = getelementptr i8, ptr %arg.state.10.0.4, i64 232
  %sunkaddr173.7.i.i.i = getelementptr i8, ptr %arg.state.10.0.4, i64 240
  %sunkaddr175.7.i.i.i = getelementptr i8, ptr %arg.state.10.0.4, i64 248
  %scevgep152.i.i.i = getelementptr i8, ptr %arg.state.10.0.4, i64 280
  %scevgep160.i.i.i = getelementptr i8, ptr %arg.state.10.0.4, i64 264
  %scevgep157.i.i.i = getelementptr i8, ptr %arg.state.10.0.4, i64 272
  %scevgep158.1.i.i.i = getelementptr i8, ptr %arg.state.10.0.4, i64 312
  %scevgep159.1.i.i.i = getelementptr i8, ptr %arg.state.10.0.4, i64 288
  %scevgep160.1.i.i.i = getelementptr i8, ptr %arg.state.10.0.4, i64 296
  %scevgep157.1.i.i.i = getelementptr i8, ptr %arg.state.10.0.4, i64 304
  %scevgep159.2.i.i.i = getelementptr i8, ptr %arg.state.10.0.4, i64 320
  %scevgep160.2.i.i.i = getelementptr i8, ptr %arg.state.10.0.4, i64 328
  %scevgep158.3.i.i.i = getelementptr i8, ptr %arg.state.10.0.4, i64 376
  %scevgep157.3.i.i.i = getelementptr i8, ptr %arg.state.10.0.4, i64 368
  %scevgep158.6.i.i.i = getelementptr i8, ptr %arg.state.10.0.4, i64 472
  %scevgep159.6.i.i.i = getelementptr i8, ptr %arg.state.10.0.4, i64 448
  %scevgep160.6.i.i.i = getelementptr i8, ptr %arg.state.10.0.4, i64 456
  %scevgep157.6.i.i.i = getelementptr i8, ptr %arg.state.10.0.4, i64 464
  %scevgep158.7.i.i.i = getelementptr i8, ptr %arg.state.10.0.4, i64 504
  %scevgep159.7.i.i.i = getelementptr i8, ptr %arg.state.10.0.4, i64 480
  %scevgep160.7.i.i.i = getelementptr i8, ptr %arg.state.10.0.4, i64 488
  %scevgep157.7.i.i.i = getelementptr i8, ptr %arg.state.10.0.4, i64 496
  %scevgep.i.i.i = getelementptr i8, ptr %arg.state.10.0.4, i64 536
  %scevgep151.i.i.i = getelementptr i8, ptr %arg.state.10.0.4, i64 520
  %scevgep148.i.i.i = getelementptr i8, ptr %arg.state.10.0.4, i64 528
  %scevgep149.1.i.i.i = getelementptr i8, ptr %arg.state.10.0.4, i64 568
  %scevgep150.1.i.i.i = getelementptr i8, ptr %arg.state.10.0.4, i64 544
  %scevgep151.1.i.i.i = getelementptr i8, ptr %arg.state.10.0.4, i64 552
  %scevgep148.1.i.i.i = getelementptr i8, ptr %arg.state.10.0.4, i64 560
  %scevgep149.2.i.i.i = getelementptr i8, ptr %arg.state.10.0.4, i64 600
  %scevgep150.2.i.i.i = getelementptr i8, ptr %arg.state.10.0.4, i64 576
  %scevgep151.2.i.i.i = getelementptr i8, ptr %arg.state.10.0.4, i64 584
  %scevgep148.2.i.i.i = getelementptr i8, ptr %arg.state.10.0.4, i64 592
  %scevgep149.3.i.i.i = getelementptr i8, ptr %arg.state.10.0.4, i64 632
  %scevgep150.3.i.i.i = getelementptr i8, ptr %arg.state.10.0.4, i64 608
  %scevgep151.3.i.i.i = getelementptr i8, ptr %arg.state.10.0.4, i64 616
  %scevgep148.3.i.i.i = getelementptr i8, ptr %arg.state.10.0.4, i64 624
  %scevgep149.4.i.i.i = getelementptr i8, ptr %arg.state.10.0.4, i64 664
  %scevgep148.4.i.i.i = getelementptr i8, ptr %arg.state.10.0.4, i64 656
  %scevgep149.5.i.i.i = getelementptr i8, ptr %arg.state.10.0.4, i64 696
  %scevgep150.5.i.i.i = getelementptr i8, ptr %arg.state.10.0.4, i64 672
  %scevgep151.5.i.i.i = getelementptr i8, ptr %arg.state.10.0.4, i64 680
  %scevgep148.5.i.i.i = getelementptr i8, ptr %arg.state.10.0.4, i64 688
  %scevgep149.6.i.i.i = getelementptr i8, ptr %arg.state.10.0.4, i64 728
  %scevgep150.6.i.i.i = getelementptr i8, ptr %arg.state.10.0.4, i64 704
  %scevgep151.6.i.i.i = getelementptr i8, ptr %arg.state.10.0.4, i64 712
  %scevgep148.6.i.i.i = getelementptr i8, ptr %arg.state.10.0.4, i64 720
  %scevgep149.7.i.i.i = getelementptr i8, ptr %arg.state.10.0.4, i64 760
  %scevgep150.7.i.i.i = getelementptr i8, ptr %arg.state.10.0.4, i64 736
  %scevgep151.7.i.i.i = getelementptr i8, ptr %arg.state.10.0.4, i64 744
  %scevgep148.7.i.i.i = getelementptr i8, ptr %arg.state.10.0.4, i64 752
  br label %B238.if.i.i

B238.if.i.i:                                      ; preds = %B940.if.i.i, %B238.if.lr.ph.i.i
  %excinfo.5.0.i.i = phi ptr [ null, %B238.if.lr.ph.i.i ], [ %excinfo.5.1.i.i, %B940.if.i.i ]
  %lsr.iv.i.i = phi i64 [ 0, %B238.if.lr.ph.i.i ], [ %lsr.iv.next.i.i, %B940.if.i.i ]
  %.390.i.i = load double, ptr %arg.state.6.4, align 8, !noalias !68
  %.392.i.i = icmp eq i64 %lsr.iv.i.i, 0
  %..i.i = select i1 %.392.i.i, double 1.000000e-30, double 0.000000e+00
  %.455.i.i = load double, ptr %sunkaddr142.i.i, align 8, !noalias !68
  %.457.i.i = icmp eq i64 %lsr.iv.i.i, 1152
  %"$phi446.4.2.1.i.i" = select i1 %.457.i.i, double 1.000000e-30, double 0.000000e+00
  %.520.i.i = load double, ptr %sunkaddr143.i.i, align 8, !noalias !68
  %.522.i.i = icmp eq i64 %lsr.iv.i.i, 1536
  %"$phi556.4.2.1.i.i" = select i1 %.522.i.i, double 1.000000e-30, double 0.000000e+00
  %.557.i.i = icmp eq i64 %lsr.iv.i.i, 384
  %"$phi620.1.2.1.i.i" = select i1 %.557.i.i, double 1.000000e-30, double 0.000000e+00
  %.573.i.i = icmp eq i64 %lsr.iv.i.i, 768
  %"$phi670.1.2.1.i.i" = select i1 %.573.i.i, double 1.000000e-30, double 0.000000e+00
  %.613.i.i = fmul contract double %storemerge.i.i.i, %"$phi620.1.2.1.i.i"
  %.628.i.i = fmul contract double %storemerge.i19.i.i, %"$phi670.1.2.1.i.i"
  call void @llvm.lifetime.start.p0(ptr nonnull %.568.i.i.i), !noalias !68
  call void @llvm.lifetime.start.p0(ptr nonnull %.599.i.i.i), !noalias !68
  call void @llvm.lifetime.start.p0(ptr nonnull %.632.i.i.i), !noalias !68
  call void @llvm.lifetime.start.p0(ptr nonnull %.669.i.i.i), !noalias !68
  call void @llvm.lifetime.start.p0(ptr nonnull %.737.i.i.i), !noalias !68
  call void @llvm.lifetime.start.p0(ptr nonnull %.775.i.i.i), !noalias !68
  store ptr null, ptr %.568.i.i.i, align 8, !noalias !72
  store ptr null, ptr %.599.i.i.i, align 8, !noalias !72
  store ptr null, ptr %.632.i.i.i, align 8, !noalias !72
  store ptr null, ptr %.669.i.i.i, align 8, !noalias !72
  store ptr null, ptr %.737.i.i.i, align 8, !noalias !72
  store ptr null, ptr %.775.i.i.i, align 8, !noalias !72
  %.81.i.i.i = fadd contract double %.390.i.i, 1.000000e+00
  %.45.i.i.i.i = tail call contract double @llvm.fabs.f64(double %.81.i.i.i)
  %.56.i.i.i.i = fcmp ult double %.45.i.i.i.i, %..i.i
  br i1 %.56.i.i.i.i, label %B270.i.i.i.i, label %B132.i.i.i.i

B132.i.i.i.i:                                     ; preds = %B238.if.i.i
  %.59.i.i.i.i = fcmp contract oeq double %.81.i.i.i, 0.000000e+00
  br i1 %.59.i.i.i.i, label %_ZN17bnserve_surrogate8tangents7_series6_phaseB4v174B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE10complex12810complex12810complex1288UniTupleI10complex128Li2EE8UniTupleI10complex128Li2EE5ArrayI10complex128Li2E1C7mutable7alignedE.exit.i.i, label %B174.endif.i.i.i.i, !prof !76

B270.i.i.i.i:                                     ; preds = %B238.if.i.i
  %.132.i.i21.i.i = fcmp contract ult double %..i.i, %.45.i.i.i.i
  br i1 %.132.i.i21.i.i, label %B0.endif.i.i.i, label %B282.i.i.i.i

B282.i.i.i.i:                                     ; preds = %B270.i.i.i.i
  %.136.i.i.i.i = fcmp contract oeq double %..i.i, 0.000000e+00
  br i1 %.136.i.i.i.i, label %_ZN17bnserve_surrogate8tangents7_series6_phaseB4v174B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE10complex12810complex12810complex1288UniTupleI10complex128Li2EE8UniTupleI10complex128Li2EE5ArrayI10complex128Li2E1C7mutable7alignedE.exit.i.i, label %B282.endif.i.i.i.i, !prof !24

B174.endif.i.i.i.i:                               ; preds = %B132.i.i.i.i
  %.89.i.i.i.i = fdiv contract double %..i.i, %.81.i.i.i
  %.91.i.i.i.i = fmul contract double %..i.i, %.89.i.i.i.i
  %.93.i.i.i.i = fadd contract double %.81.i.i.i, %.91.i.i.i.i
  %.98.i.i.i.i = fcmp contract oeq double %.93.i.i.i.i, 0.000000e+00
  br i1 %.98.i.i.i.i, label %_ZN17bnserve_surrogate8tangents7_series6_phaseB4v174B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE10complex12810complex12810complex1288UniTupleI10complex128Li2EE8UniTupleI10complex128Li2EE5ArrayI10complex128Li2E1C7mutable7alignedE.exit.i.i, label %B174.endif.endif.i.i.i.i, !prof !24

B174.endif.endif.i.i.i.i:                         ; preds = %B174.endif.i.i.i.i
  %.97.i.i.i.i = fadd contract double %.390.i.i, %.91.i.i.i.i
  %.105.i.i.i.i = fdiv contract double %.97.i.i.i.i, %.93.i.i.i.i
  %.107.i.i.i.i = fmul contract double %.390.i.i, %.89.i.i.i.i
  %.109.i.i.i.i = fsub contract double %..i.i, %.107.i.i.i.i
  %.117.i.i.i.i = fdiv contract double %.109.i.i.i.i, %.93.i.i.i.i
  br label %B0.endif.i.i.i

B282.endif.i.i.i.i:                               ; preds = %B282.i.i.i.i
  %.143.i.i.i.i = fdiv contract double %.81.i.i.i, %..i.i
  %.145.i.i.i.i = fmul contract double %.81.i.i.i, %.143.i.i.i.i
  %.147.i.i.i.i = fadd contract double %..i.i, %.145.i.i.i.i
  %.152.i.i.i.i = fcmp contract oeq double %.147.i.i.i.i, 0.000000e+00
  br i1 %.152.i.i.i.i, label %_ZN17bnserve_surrogate8tangents7_series6_phaseB4v174B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE10complex12810complex12810complex1288UniTupleI10complex128Li2EE8UniTupleI10complex128Li2EE5ArrayI10complex128Li2E1C7mutable7alignedE.exit.i.i, label %B282.endif.endif.i.i.i.i, !prof !24

B282.endif.endif.i.i.i.i:                         ; preds = %B282.endif.i.i.i.i
  %.149.i.i.i.i = fmul contract double %.390.i.i, %.143.i.i.i.i
  %.151.i.i.i.i = fadd contract double %..i.i, %.149.i.i.i.i
  %.159.i.i.i.i = fdiv contract double %.151.i.i.i.i, %.147.i.i.i.i
  %.161.i.i.i.i = fmul contract double %..i.i, %.143.i.i.i.i
  %.163.i.i.i.i = fsub contract double %.161.i.i.i.i, %.390.i.i
  %.171.i.i.i.i = fdiv contract double %.163.i.i.i.i, %.147.i.i.i.i
  br label %B0.endif.i.i.i

B0.endif.i.i.i:                                   ; preds = %B282.endif.endif.i.i.i.i, %B174.endif.endif.i.i.i.i, %B270.i.i.i.i
  %.88.sroa.4.0.i.i.i = phi double [ 0x7FF8000000000000, %B270.i.i.i.i ], [ %.171.i.i.i.i, %B282.endif.endif.i.i.i.i ], [ %.117.i.i.i.i, %B174.endif.endif.i.i.i.i ]
  %.88.sroa.0.0.i.i.i = phi double [ 0x7FF8000000000000, %B270.i.i.i.i ], [ %.159.i.i.i.i, %B282.endif.endif.i.i.i.i ], [ %.105.i.i.i.i, %B174.endif.endif.i.i.i.i ]
  br i1 %.56.i.i.i.i, label %B270.i41.i.i.i, label %B132.i20.i.i.i

B132.i20.i.i.i:                                   ; preds = %B0.endif.i.i.i
  %.59.i21.i.i.i = fcmp contract oeq double %.81.i.i.i, 0.000000e+00
  br i1 %.59.i21.i.i.i, label %_ZN17bnserve_surrogate8tangents7_series6_phaseB4v174B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE10complex12810complex12810complex1288UniTupleI10complex128Li2EE8UniTupleI10complex128Li2EE5ArrayI10complex128Li2E1C7mutable7alignedE.exit.i.i, label %B174.endif.i22.i.i.i, !prof !76

B270.i41.i.i.i:                                   ; preds = %B0.endif.i.i.i
  %.132.i42.i.i.i = fcmp contract ult double %..i.i, %.45.i.i.i.i
  br i1 %.132.i42.i.i.i, label %B0.endif.endif.i.i.i, label %B282.i43.i.i.i

B282.i43.i.i.i:                                   ; preds = %B270.i41.i.i.i
  %.136.i44.i.i.i = fcmp contract oeq double %..i.i, 0.000000e+00
  br i1 %.136.i44.i.i.i, label %_ZN17bnserve_surrogate8tangents7_series6_phaseB4v174B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE10complex12810complex12810complex1288UniTupleI10complex128Li2EE8UniTupleI10complex128Li2EE5ArrayI10complex128Li2E1C7mutable7alignedE.exit.i.i, label %B282.endif.i45.i.i.i, !prof !24

B174.endif.i22.i.i.i:                             ; preds = %B132.i20.i.i.i
  %.89.i23.i.i.i = fdiv contract double %..i.i, %.81.i.i.i
  %.91.i24.i.i.i = fmul contract double %..i.i, %.89.i23.i.i.i
  %.93.i25.i.i.i = fadd contract double %.81.i.i.i, %.91.i24.i.i.i
  %.98.i26.i.i.i = fcmp contract oeq double %.93.i25.i.i.i, 0.000000e+00
  br i1 %.98.i26.i.i.i, label %_ZN17bnserve_surrogate8tangents7_series6_phaseB4v174B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE10complex12810complex12810complex1288UniTupleI10complex128Li2EE8UniTupleI10complex128Li2EE5ArrayI10complex128Li2E1C7mutable7alignedE.exit.i.i, label %B174.endif.endif.i27.i.i.i, !prof !24

B174.endif.endif.i27.i.i.i:                       ; preds = %B174.endif.i22.i.i.i
  %.95.i28.i.i.i = fmul contract double %.89.i23.i.i.i, 0.000000e+00
  %.97.i29.i.i.i = fadd contract double %.95.i28.i.i.i, 1.000000e+00
  %.105.i30.i.i.i = fdiv contract double %.97.i29.i.i.i, %.93.i25.i.i.i
  %.109.i32.i.i.i = fsub contract double 0.000000e+00, %.89.i23.i.i.i
  %.117.i33.i.i.i = fdiv contract double %.109.i32.i.i.i, %.93.i25.i.i.i
  br label %B0.endif.endif.i.i.i

B282.endif.i45.i.i.i:                             ; preds = %B282.i43.i.i.i
  %.143.i46.i.i.i = fdiv contract double %.81.i.i.i, %..i.i
  %.145.i47.i.i.i = fmul contract double %.81.i.i.i, %.143.i46.i.i.i
  %.147.i48.i.i.i = fadd contract double %..i.i, %.145.i47.i.i.i
  %.152.i49.i.i.i = fcmp contract oeq double %.147.i48.i.i.i, 0.000000e+00
  br i1 %.152.i49.i.i.i, label %_ZN17bnserve_surrogate8tangents7_series6_phaseB4v174B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE10complex12810complex12810complex1288UniTupleI10complex128Li2EE8UniTupleI10complex128Li2EE5ArrayI10complex128Li2E1C7mutable7alignedE.exit.i.i, label %B282.endif.endif.i50.i.i.i, !prof !24

B282.endif.endif.i50.i.i.i:                       ; preds = %B282.endif.i45.i.i.i
  %.151.i52.i.i.i = fadd contract double %.143.i46.i.i.i, 0.000000e+00
  %.159.i53.i.i.i = fdiv contract double %.151.i52.i.i.i, %.147.i48.i.i.i
  %.161.i54.i.i.i = fmul contract double %.143.i46.i.i.i, 0.000000e+00
  %.163.i55.i.i.i = fadd contract double %.161.i54.i.i.i, -1.000000e+00
  %.171.i56.i.i.i = fdiv contract double %.163.i55.i.i.i, %.147.i48.i.i.i
  br label %B0.endif.endif.i.i.i

B0.endif.endif.i.i.i:                             ; preds = %B282.endif.endif.i50.i.i.i, %B174.endif.endif.i27.i.i.i, %B270.i41.i.i.i
  %.161.sroa.0.0.i.i.i = phi double [ 0x7FF8000000000000, %B270.i41.i.i.i ], [ %.105.i30.i.i.i, %B174.endif.endif.i27.i.i.i ], [ %.159.i53.i.i.i, %B282.endif.endif.i50.i.i.i ]
  %.161.sroa.4.0.i.i.i = phi double [ 0x7FF8000000000000, %B270.i41.i.i.i ], [ %.117.i33.i.i.i, %B174.endif.endif.i27.i.i.i ], [ %.171.i56.i.i.i, %B282.endif.endif.i50.i.i.i ]
  %.58.i60.i.i.i = fmul contract double %.88.sroa.0.0.i.i.i, %.161.sroa.4.0.i.i.i
  %.64.i61.i.i.i = fmul contract double %.88.sroa.4.0.i.i.i, %.161.sroa.0.0.i.i.i
  %.80.i62.i.i.i = fadd contract double %.64.i61.i.i.i, %.58.i60.i.i.i
  %.46.i63.i.i.i = fmul contract double %.88.sroa.0.0.i.i.i, %.161.sroa.0.0.i.i.i
  %.52.i64.i.i.i = fmul contract double %.88.sroa.4.0.i.i.i, %.161.sroa.4.0.i.i.i
  %.70.i65.i.i.i = fsub contract double %.46.i63.i.i.i, %.52.i64.i.i.i
  tail call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(768) %arg.state.10.0.4, i8 0, i64 768, i1 false), !noalias !72
  store double 1.000000e+00, ptr %arg.state.10.0.4, align 8, !noalias !77
  store double 0.000000e+00, ptr %.80.i1.i.i.i, align 8, !noalias !77
  %.58.i.i.i1.i.i = fmul contract double %.70.i65.i.i.i, 0.000000e+00
  %.64.i.i.i2.i.i = fmul contract double %.80.i62.i.i.i, 0x401871C71C71C71C
  %.80.i.i.i3.i.i = fadd contract double %.58.i.i.i1.i.i, %.64.i.i.i2.i.i
  %.46.i.i.i4.i.i = fmul contract double %.70.i65.i.i.i, 0x401871C71C71C71C
  %.52.i.i.i5.i.i = fmul contract double %.80.i62.i.i.i, 0.000000e+00
  %.70.i.i.i6.i.i = fsub contract double %.46.i.i.i4.i.i, %.52.i.i.i5.i.i
  %.308.i.i.i.i = fadd contract double %.70.i.i.i6.i.i, 0x4013A7F529FD4A7F
  %.311.i.i.i.i = fadd contract double %.80.i.i.i3.i.i, 0.000000e+00
  store double %.308.i.i.i.i, ptr %.222.i.i.i.i, align 8, !noalias !77
  store double %.311.i.i.i.i, ptr %.225.i.i.i.i, align 8, !noalias !77
  %.447.i.i.i.i = load double, ptr %.445.i.i.i.i, align 8, !noalias !77
  %.449.i.i.i.i = load double, ptr %.448.i.i.i.i, align 8, !noalias !77
  %.477.i.i.i.i = fadd contract double %.447.i.i.i.i, 0xC04921FB54442D18
  %.480.i.i.i.i = fadd contract double %.449.i.i.i.i, 0.000000e+00
  store double %.477.i.i.i.i, ptr %.445.i.i.i.i, align 8, !noalias !77
  store double %.480.i.i.i.i, ptr %.448.i.i.i.i, align 8, !noalias !77
  %.590.i.i.i.i = load double, ptr %.588.i.i.i.i, align 8, !noalias !77
  %.592.i.i.i.i = load double, ptr %.591.i.i.i.i, align 8, !noalias !77
  %.64.i3.i.i.i.i = fmul contract double %.80.i62.i.i.i, 0x40456C71C71C71C7
  %.80.i4.i.i.i.i = fadd contract double %.58.i.i.i1.i.i, %.64.i3.i.i.i.i
  %.46.i5.i.i.i.i = fmul contract double %.70.i65.i.i.i, 0x40456C71C71C71C7
  %.70.i7.i.i.i.i = fsub contract double %.46.i5.i.i.i.i, %.52.i.i.i5.i.i
  %.693.i.i.i.i = fadd contract double %.70.i7.i.i.i.i, 0x404AEDF7DF7DF7DF
  %.696.i.i.i.i = fadd contract double %.80.i4.i.i.i.i, 0.000000e+00
  %.58.i9.i.i.i.i = fmul contract double %.70.i65.i.i.i, %.696.i.i.i.i
  %.64.i10.i.i.i.i = fmul contract double %.80.i62.i.i.i, %.693.i.i.i.i
  %.80.i11.i.i.i.i = fadd contract double %.64.i10.i.i.i.i, %.58.i9.i.i.i.i
  %.46.i12.i.i.i.i = fmul contract double %.70.i65.i.i.i, %.693.i.i.i.i
  %.52.i13.i.i.i.i = fmul contract double %.80.i62.i.i.i, %.696.i.i.i.i
  %.70.i14.i.i.i.i = fsub contract double %.46.i12.i.i.i.i, %.52.i13.i.i.i.i
  %.753.i.i.i.i = fadd contract double %.70.i14.i.i.i.i, 0x403E1A683B5702A5
  %.756.i.i.i.i = fadd contract double %.80.i11.i.i.i.i, 0.000000e+00
  %.779.i.i.i.i = fadd contract double %.753.i.i.i.i, %.590.i.i.i.i
  %.782.i.i.i.i = fadd contract double %.756.i.i.i.i, %.592.i.i.i.i
  store double %.779.i.i.i.i, ptr %.588.i.i.i.i, align 8, !noalias !77
  store double %.782.i.i.i.i, ptr %.591.i.i.i.i, align 8, !noalias !77
  %.892.i.i.i.i = load double, ptr %.890.i.i.i.i, align 8, !noalias !77
  %.894.i.i.i.i = load double, ptr %.893.i.i.i.i, align 8, !noalias !77
  %.64.i17.i.i.i.i = fmul contract double %.80.i62.i.i.i, 0x40510457810E2933
  %34 = fsub contract double %.58.i.i.i1.i.i, %.64.i17.i.i.i.i
  %.46.i19.i.i.i.i = fmul contract double %.70.i65.i.i.i, 0xC0510457810E2933
  %.70.i21.i.i.i.i = fsub contract double %.46.i19.i.i.i.i, %.52.i.i.i5.i.i
  %.974.i.i.i.i = fadd contract double %.70.i21.i.i.i.i, 0x407E1C5F0E074C89
  %.977.i.i.i.i = fadd contract double %34, 0.000000e+00
  %.1000.i.i.i.i = fadd contract double %.974.i.i.i.i, %.892.i.i.i.i
  %.1003.i.i.i.i = fadd contract double %.977.i.i.i.i, %.894.i.i.i.i
  store double %.1000.i.i.i.i, ptr %.890.i.i.i.i, align 8, !noalias !77
  store double %.1003.i.i.i.i, ptr %.893.i.i.i.i, align 8, !noalias !77
  %.1113.i.i.i.i = load double, ptr %.1111.i.i.i.i, align 8, !noalias !77
  %.1115.i.i.i.i = load double, ptr %.1114.i.i.i.i, align 8, !noalias !77
  %.64.i24.i.i.i.i = fmul contract double %.80.i62.i.i.i, 0x4058A8587E6B74F0
  %35 = fsub contract double %.58.i.i.i1.i.i, %.64.i24.i.i.i.i
  %.46.i26.i.i.i.i = fmul contract double %.70.i65.i.i.i, 0xC058A8587E6B74F0
  %.70.i28.i.i.i.i = fsub contract double %.46.i26.i.i.i.i, %.52.i.i.i5.i.i
  %.1245.i.i.i.i = fadd contract double %.70.i28.i.i.i.i, 0x404601B425ED097B
  %.1248.i.i.i.i = fadd contract double %35, 0.000000e+00
  %.58.i30.i.i.i.i = fmul contract double %.70.i65.i.i.i, %.1248.i.i.i.i
  %.64.i31.i.i.i.i = fmul contract double %.80.i62.i.i.i, %.1245.i.i.i.i
  %.80.i32.i.i.i.i = fadd contract double %.64.i31.i.i.i.i, %.58.i30.i.i.i.i
  %.46.i33.i.i.i.i = fmul contract double %.70.i65.i.i.i, %.1245.i.i.i.i
  %.52.i34.i.i.i.i = fmul contract double %.80.i62.i.i.i, %.1248.i.i.i.i
  %.70.i35.i.i.i.i = fsub contract double %.46.i33.i.i.i.i, %.52.i34.i.i.i.i
  %.1305.i.i.i.i = fadd contract double %.70.i35.i.i.i.i, 0xC0A9D8A41ED3317E
  %.1308.i.i.i.i = fadd contract double %.80.i32.i.i.i.i, 0.000000e+00
  %.58.i37.i.i.i.i = fmul contract double %.70.i65.i.i.i, %.1308.i.i.i.i
  %.64.i38.i.i.i.i = fmul contract double %.80.i62.i.i.i, %.1305.i.i.i.i
  %.80.i39.i.i.i.i = fadd contract double %.64.i38.i.i.i.i, %.58.i37.i.i.i.i
  %.46.i40.i.i.i.i = fmul contract double %.70.i65.i.i.i, %.1305.i.i.i.i
  %.52.i41.i.i.i.i = fmul contract double %.80.i62.i.i.i, %.1308.i.i.i.i
  %.70.i42.i.i.i.i = fsub contract double %.46.i40.i.i.i.i, %.52.i41.i.i.i.i
  %.1365.i.i.i.i = fadd contract double %.70.i42.i.i.i.i, 0xC071640B49E85C3E
  %.1368.i.i.i.i = fadd contract double %.80.i39.i.i.i.i, 0.000000e+00
  %.1391.i.i.i.i = fadd contract double %.1365.i.i.i.i, %.1113.i.i.i.i
  %.1394.i.i.i.i = fadd contract double %.1368.i.i.i.i, %.1115.i.i.i.i
  store double %.1391.i.i.i.i, ptr %.1111.i.i.i.i, align 8, !noalias !77
  store double %.1394.i.i.i.i, ptr %.1114.i.i.i.i, align 8, !noalias !77
  %.1504.i.i.i.i = load double, ptr %.1502.i.i.i.i, align 8, !noalias !77
  %.1506.i.i.i.i = load double, ptr %.1505.i.i.i.i, align 8, !noalias !77
  %.1534.i.i.i.i = fadd contract double %.1504.i.i.i.i, 0xC074618618618618
  %.1537.i.i.i.i = fadd contract double %.1506.i.i.i.i, 0.000000e+00
  store double %.1534.i.i.i.i, ptr %.1502.i.i.i.i, align 8, !noalias !77
  store double %.1537.i.i.i.i, ptr %.1505.i.i.i.i, align 8, !noalias !77
  %.1647.i.i.i.i = load double, ptr %.1645.i.i.i.i, align 8, !noalias !77
  %.1649.i.i.i.i = load double, ptr %.1648.i.i.i.i, align 8, !noalias !77
  %.64.i45.i.i.i.i = fmul contract double %.80.i62.i.i.i, 0x40733B288412FE12
  %36 = fsub contract double %.58.i.i.i1.i.i, %.64.i45.i.i.i.i
  %.46.i47.i.i.i.i = fmul contract double %.70.i65.i.i.i, 0xC0733B288412FE12
  %.70.i49.i.i.i.i = fsub contract double %.46.i47.i.i.i.i, %.52.i.i.i5.i.i
  %.1750.i.i.i.i = fadd contract double %.70.i49.i.i.i.i, 0x408893BEE8443B83
  %.1753.i.i.i.i = fadd contract double %36, 0.000000e+00
  %.58.i51.i.i.i.i = fmul contract double %.70.i65.i.i.i, %.1753.i.i.i.i
  %.64.i52.i.i.i.i = fmul contract double %.80.i62.i.i.i, %.1750.i.i.i.i
  %.80.i53.i.i.i.i = fadd contract double %.64.i52.i.i.i.i, %.58.i51.i.i.i.i
  %.46.i54.i.i.i.i = fmul contract double %.70.i65.i.i.i, %.1750.i.i.i.i
  %.52.i55.i.i.i.i = fmul contract double %.80.i62.i.i.i, %.1753.i.i.i.i
  %.70.i56.i.i.i.i = fsub contract double %.46.i54.i.i.i.i, %.52.i55.i.i.i.i
  %.1810.i.i.i.i = fadd contract double %.70.i56.i.i.i.i, 0x408DCC10DD757C0B
  %.1813.i.i.i.i = fadd contract double %.80.i53.i.i.i.i, 0.000000e+00
  %.1836.i.i.i.i = fadd contract double %.1810.i.i.i.i, %.1647.i.i.i.i
  %.1839.i.i.i.i = fadd contract double %.1813.i.i.i.i, %.1649.i.i.i.i
  store double %.1836.i.i.i.i, ptr %.1645.i.i.i.i, align 8, !noalias !77
  store double %.1839.i.i.i.i, ptr %.1648.i.i.i.i, align 8, !noalias !77
  %.1949.i.i.i.i = load double, ptr %.1947.i.i.i.i, align 8, !noalias !77
  %.1951.i.i.i.i = load double, ptr %.1950.i.i.i.i, align 8, !noalias !77
  %.64.i59.i.i.i.i = fmul contract double %.80.i62.i.i.i, 0x40514C5F3B7242FB
  %.80.i60.i.i.i.i = fadd contract double %.58.i.i.i1.i.i, %.64.i59.i.i.i.i
  %.46.i61.i.i.i.i = fmul contract double %.70.i65.i.i.i, 0x40514C5F3B7242FB
  %.70.i63.i.i.i.i = fsub contract double %.46.i61.i.i.i.i, %.52.i.i.i5.i.i
  %.2118.i.i.i.i = fadd contract double %.70.i63.i.i.i.i, 0xC05D2FBB067D39F9
  %.2121.i.i.i.i = fadd contract double %.80.i60.i.i.i.i, 0.000000e+00
  %.58.i65.i.i.i.i = fmul contract double %.70.i65.i.i.i, %.2121.i.i.i.i
  %.64.i66.i.i.i.i = fmul contract double %.80.i62.i.i.i, %.2118.i.i.i.i
  %.80.i67.i.i.i.i = fadd contract double %.64.i66.i.i.i.i, %.58.i65.i.i.i.i
  %.46.i68.i.i.i.i = fmul contract double %.70.i65.i.i.i, %.2118.i.i.i.i
  %.52.i69.i.i.i.i = fmul contract double %.80.i62.i.i.i, %.2121.i.i.i.i
  %.70.i70.i.i.i.i = fsub contract double %.46.i68.i.i.i.i, %.52.i69.i.i.i.i
  %.2178.i.i.i.i = fadd contract double %.70.i70.i.i.i.i, 0xC091A4640F04B974
  %.2181.i.i.i.i = fadd contract double %.80.i67.i.i.i.i, 0.000000e+00
  %.58.i72.i.i.i.i = fmul contract double %.70.i65.i.i.i, %.2181.i.i.i.i
  %.64.i73.i.i.i.i = fmul contract double %.80.i62.i.i.i, %.2178.i.i.i.i
  %.80.i74.i.i.i.i = fadd contract double %.64.i73.i.i.i.i, %.58.i72.i.i.i.i
  %.46.i75.i.i.i.i = fmul contract double %.70.i65.i.i.i, %.2178.i.i.i.i
  %.52.i76.i.i.i.i = fmul contract double %.80.i62.i.i.i, %.2181.i.i.i.i
  %.70.i77.i.i.i.i = fsub contract double %.46.i75.i.i.i.i, %.52.i76.i.i.i.i
  %.2238.i.i.i.i = fadd contract double %.70.i77.i.i.i.i, 0x40CE3F8117DB38CA
  %.2241.i.i.i.i = fadd contract double %.80.i74.i.i.i.i, 0.000000e+00
  %.58.i79.i.i.i.i = fmul contract double %.70.i65.i.i.i, %.2241.i.i.i.i
  %.64.i80.i.i.i.i = fmul contract double %.80.i62.i.i.i, %.2238.i.i.i.i
  %.80.i81.i.i.i.i = fadd contract double %.64.i80.i.i.i.i, %.58.i79.i.i.i.i
  %.46.i82.i.i.i.i = fmul contract double %.70.i65.i.i.i, %.2238.i.i.i.i
  %.52.i83.i.i.i.i = fmul contract double %.80.i62.i.i.i, %.2241.i.i.i.i
  %.70.i84.i.i.i.i = fsub contract double %.46.i82.i.i.i.i, %.52.i83.i.i.i.i
  %.2298.i.i.i.i = fadd contract double %.70.i84.i.i.i.i, 0xC0A8D75E6BF57F9D
  %.2301.i.i.i.i = fadd contract double %.80.i81.i.i.i.i, 0.000000e+00
  %.2324.i.i.i.i = fadd contract double %.2298.i.i.i.i, %.1949.i.i.i.i
  %.2327.i.i.i.i = fadd contract double %.2301.i.i.i.i, %.1951.i.i.i.i
  store double %.2324.i.i.i.i, ptr %.1947.i.i.i.i, align 8, !noalias !77
  store double %.2327.i.i.i.i, ptr %.1950.i.i.i.i, align 8, !noalias !77
  %.2437.i.i.i.i = load double, ptr %.2435.i.i.i.i, align 8, !noalias !77
  %.2439.i.i.i.i = load double, ptr %.2438.i.i.i.i, align 8, !noalias !77
  %.64.i87.i.i.i.i = fmul contract double %.80.i62.i.i.i, 0x409F6EC11CD4D97E
  %.80.i88.i.i.i.i = fadd contract double %.58.i.i.i1.i.i, %.64.i87.i.i.i.i
  %.46.i89.i.i.i.i = fmul contract double %.70.i65.i.i.i, 0x409F6EC11CD4D97E
  %.70.i91.i.i.i.i = fsub contract double %.46.i89.i.i.i.i, %.52.i.i.i5.i.i
  %.2519.i.i.i.i = fadd contract double %.70.i91.i.i.i.i, 0x4072428A28A28A29
  %.2522.i.i.i.i = fadd contract double %.80.i88.i.i.i.i, 0.000000e+00
  %.2545.i.i.i.i = fadd contract double %.2519.i.i.i.i, %.2437.i.i.i.i
  %.2548.i.i.i.i = fadd contract double %.2522.i.i.i.i, %.2439.i.i.i.i
  store double %.2545.i.i.i.i, ptr %.2435.i.i.i.i, align 8, !noalias !77
  store double %.2548.i.i.i.i, ptr %.2438.i.i.i.i, align 8, !noalias !77
  %.2658.i.i.i.i = load double, ptr %.2656.i.i.i.i, align 8, !noalias !77
  %.2660.i.i.i.i = load double, ptr %.2659.i.i.i.i, align 8, !noalias !77
  %.64.i94.i.i.i.i = fmul contract double %.80.i62.i.i.i, 0x40645019F9E83A77
  %.80.i95.i.i.i.i = fadd contract double %.58.i.i.i1.i.i, %.64.i94.i.i.i.i
  %.46.i96.i.i.i.i = fmul contract double %.70.i65.i.i.i, 0x40645019F9E83A77
  %.70.i98.i.i.i.i = fsub contract double %.46.i96.i.i.i.i, %.52.i.i.i5.i.i
  %.2790.i.i.i.i = fadd contract double %.70.i98.i.i.i.i, 0x40918164C0B5D6FD
  %.2793.i.i.i.i = fadd contract double %.80.i95.i.i.i.i, 0.000000e+00
  %.58.i100.i.i.i.i = fmul contract double %.70.i65.i.i.i, %.2793.i.i.i.i
  %.64.i101.i.i.i.i = fmul contract double %.80.i62.i.i.i, %.2790.i.i.i.i
  %.80.i102.i.i.i.i = fadd contract double %.64.i101.i.i.i.i, %.58.i100.i.i.i.i
  %.46.i103.i.i.i.i = fmul contract double %.70.i65.i.i.i, %.2790.i.i.i.i
  %.52.i104.i.i.i.i = fmul contract double %.80.i62.i.i.i, %.2793.i.i.i.i
  %.70.i105.i.i.i.i = fsub contract double %.46.i103.i.i.i.i, %.52.i104.i.i.i.i
  %.2850.i.i.i.i = fadd contract double %.70.i105.i.i.i.i, 0xC0D6C519D7F78519
  %.2853.i.i.i.i = fadd contract double %.80.i102.i.i.i.i, 0.000000e+00
  %.58.i107.i.i.i.i = fmul contract double %.70.i65.i.i.i, %.2853.i.i.i.i
  %.64.i108.i.i.i.i = fmul contract double %.80.i62.i.i.i, %.2850.i.i.i.i
  %.80.i109.i.i.i.i = fadd contract double %.64.i108.i.i.i.i, %.58.i107.i.i.i.i
  %.46.i110.i.i.i.i = fmul contract double %.70.i65.i.i.i, %.2850.i.i.i.i
  %.52.i111.i.i.i.i = fmul contract double %.80.i62.i.i.i, %.2853.i.i.i.i
  %.70.i112.i.i.i.i = fsub contract double %.46.i110.i.i.i.i, %.52.i111.i.i.i.i
  %.2910.i.i.i.i = fadd contract double %.70.i112.i.i.i.i, 0x40BB4B9C657BC796
  %.2913.i.i.i.i = fadd contract double %.80.i109.i.i.i.i, 0.000000e+00
  %.2936.i.i.i.i = fadd contract double %.2910.i.i.i.i, %.2658.i.i.i.i
  %.2939.i.i.i.i = fadd contract double %.2913.i.i.i.i, %.2660.i.i.i.i
  store double %.2936.i.i.i.i, ptr %.2656.i.i.i.i, align 8, !noalias !77
  store double %.2939.i.i.i.i, ptr %.2659.i.i.i.i, align 8, !noalias !77
  %.3049.i.i.i.i = load double, ptr %.3047.i.i.i.i, align 8, !noalias !77
  %.3051.i.i.i.i = load double, ptr %.3050.i.i.i.i, align 8, !noalias !77
  %.3079.i.i.i.i = fadd contract double %.3049.i.i.i.i, 0xC0A001D567F49087
  %.3082.i.i.i.i = fadd contract double %.3051.i.i.i.i, 0.000000e+00
  store double %.3079.i.i.i.i, ptr %.3047.i.i.i.i, align 8, !noalias !77
  store double %.3082.i.i.i.i, ptr %.3050.i.i.i.i, align 8, !noalias !77
  %.64.i115.i.i.i.i = fmul contract double %.80.i62.i.i.i, 0x40A619E547AE6DA3
  %.80.i116.i.i.i.i = fadd contract double %.58.i.i.i1.i.i, %.64.i115.i.i.i.i
  %.46.i117.i.i.i.i = fmul contract double %.70.i65.i.i.i, 0x40A619E547AE6DA3
  %.70.i119.i.i.i.i = fsub contract double %.46.i117.i.i.i.i, %.52.i.i.i5.i.i
  %.3316.i.i.i.i = fadd contract double %.70.i119.i.i.i.i, 0xC0D25E7665446D0F
  %.3319.i.i.i.i = fadd contract double %.80.i116.i.i.i.i, 0.000000e+00
  %.58.i121.i.i.i.i = fmul contract double %.70.i65.i.i.i, %.3319.i.i.i.i
  %.64.i122.i.i.i.i = fmul contract double %.80.i62.i.i.i, %.3316.i.i.i.i
  %.80.i123.i.i.i.i = fadd contract double %.64.i122.i.i.i.i, %.58.i121.i.i.i.i
  %.46.i124.i.i.i.i = fmul contract double %.70.i65.i.i.i, %.3316.i.i.i.i
  %.52.i125.i.i.i.i = fmul contract double %.80.i62.i.i.i, %.3319.i.i.i.i
  %.70.i126.i.i.i.i = fsub contract double %.46.i124.i.i.i.i, %.52.i125.i.i.i.i
  %.3376.i.i.i.i = fadd contract double %.70.i126.i.i.i.i, 0x40E19BDA5330D73F
  %.3379.i.i.i.i = fadd contract double %.80.i123.i.i.i.i, 0.000000e+00
  %.58.i128.i.i.i.i = fmul contract double %.70.i65.i.i.i, %.3379.i.i.i.i
  %.64.i129.i.i.i.i = fmul contract double %.80.i62.i.i.i, %.3376.i.i.i.i
  %.80.i130.i.i.i.i = fadd contract double %.64.i129.i.i.i.i, %.58.i128.i.i.i.i
  %.46.i131.i.i.i.i = fmul contract double %.70.i65.i.i.i, %.3376.i.i.i.i
  %.52.i132.i.i.i.i = fmul contract double %.80.i62.i.i.i, %.3379.i.i.i.i
  %.70.i133.i.i.i.i = fsub contract double %.46.i131.i.i.i.i, %.52.i132.i.i.i.i
  %.3436.i.i.i.i = fadd contract double %.70.i133.i.i.i.i, 0xC0E154650FD9ACF1
  %.3439.i.i.i.i = fadd contract double %.80.i130.i.i.i.i, 0.000000e+00
  %.3496.i.i.i.i = load double, ptr %.3494.i.i.i.i, align 8, !noalias !77
  %.3498.i.i.i.i = load double, ptr %.3497.i.i.i.i, align 8, !noalias !77
  %.58.i135.i.i.i.i = fmul contract double %.70.i65.i.i.i, %.3439.i.i.i.i
  %.64.i136.i.i.i.i = fmul contract double %.80.i62.i.i.i, %.3436.i.i.i.i
  %.80.i137.i.i.i.i = fadd contract double %.64.i136.i.i.i.i, %.58.i135.i.i.i.i
  %.46.i138.i.i.i.i = fmul contract double %.70.i65.i.i.i, %.3436.i.i.i.i
  %.52.i139.i.i.i.i = fmul contract double %.80.i62.i.i.i, %.3439.i.i.i.i
  %.70.i140.i.i.i.i = fsub contract double %.46.i138.i.i.i.i, %.52.i139.i.i.i.i
  %.3639.i.i.i.i = fadd contract double %.70.i140.i.i.i.i, 0xC0F5A16228D9F21A
  %.3642.i.i.i.i = fadd contract double %.80.i137.i.i.i.i, 0.000000e+00
  %.58.i142.i.i.i.i = fmul contract double %.70.i65.i.i.i, %.3642.i.i.i.i
  %.64.i143.i.i.i.i = fmul contract double %.80.i62.i.i.i, %.3639.i.i.i.i
  %.80.i144.i.i.i.i = fadd contract double %.64.i143.i.i.i.i, %.58.i142.i.i.i.i
  %.46.i145.i.i.i.i = fmul contract double %.70.i65.i.i.i, %.3639.i.i.i.i
  %.52.i146.i.i.i.i = fmul contract double %.80.i62.i.i.i, %.3642.i.i.i.i
  %.70.i147.i.i.i.i = fsub contract double %.46.i145.i.i.i.i, %.52.i146.i.i.i.i
  %.3699.i.i.i.i = fadd contract double %.70.i147.i.i.i.i, 0x40ECE30547C08F3B
  %.3702.i.i.i.i = fadd contract double %.80.i144.i.i.i.i, 0.000000e+00
  %.58.i149.i.i.i.i = fmul contract double %.70.i65.i.i.i, %.3702.i.i.i.i
  %.64.i150.i.i.i.i = fmul contract double %.80.i62.i.i.i, %.3699.i.i.i.i
  %.80.i151.i.i.i.i = fadd contract double %.64.i150.i.i.i.i, %.58.i149.i.i.i.i
  %.46.i152.i.i.i.i = fmul contract double %.70.i65.i.i.i, %.3699.i.i.i.i
  %.52.i153.i.i.i.i = fmul contract double %.80.i62.i.i.i, %.3702.i.i.i.i
  %.70.i154.i.i.i.i = fsub contract double %.46.i152.i.i.i.i, %.52.i153.i.i.i.i
  %.58.i156.i.i.i.i = fmul contract double %.80.i62.i.i.i, 3.000000e+00
  %.80.i158.i.i.i.i = fadd contract double %.58.i.i.i1.i.i, %.58.i156.i.i.i.i
  %.46.i159.i.i.i.i = fmul contract double %.70.i65.i.i.i, 3.000000e+00
  %.3762.i.i.i.i = fadd contract double %.80.i151.i.i.i.i, 0.000000e+00
  %.3759.i.i.i.i = fadd contract double %.70.i154.i.i.i.i, 0xC0C172813AB99F84
  %37 = fsub contract double %.52.i.i.i5.i.i, %.46.i159.i.i.i.i
  %.3827.i.i.i.i = fadd contract double %37, 1.000000e+00
  %.3830.i.i.i.i = fsub contract double 0.000000e+00, %.80.i158.i.i.i.i
  %.45.i.i.i.i.i = tail call contract double @llvm.fabs.f64(double %.3827.i.i.i.i)
  %.50.i.i.i.i.i = tail call contract double @llvm.fabs.f64(double %.3830.i.i.i.i)
  %.56.i.i.i.i.i = fcmp ult double %.45.i.i.i.i.i, %.50.i.i.i.i.i
  br i1 %.56.i.i.i.i.i, label %B270.i.i.i.i.i, label %B132.i.i.i.i.i

B132.i.i.i.i.i:                                   ; preds = %B0.endif.endif.i.i.i
  %.59.i.i.i.i.i = fcmp contract oeq double %.3827.i.i.i.i, 0.000000e+00
  br i1 %.59.i.i.i.i.i, label %_ZN17bnserve_surrogate8tangents7_series6_phaseB4v174B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE10complex12810complex12810complex1288UniTupleI10complex128Li2EE8UniTupleI10complex128Li2EE5ArrayI10complex128Li2E1C7mutable7alignedE.exit.i.i, label %B174.endif.i.i.i.i.i, !prof !76

B270.i.i.i.i.i:                                   ; preds = %B0.endif.endif.i.i.i
  %.132.i.i.i.i.i = fcmp contract ult double %.50.i.i.i.i.i, %.45.i.i.i.i.i
  br i1 %.132.i.i.i.i.i, label %B0.endif.endif.endif.endi...endif.4.endif.endif.endif.i.i.i.i, label %B282.i.i.i.i.i

B282.i.i.i.i.i:                                   ; preds = %B270.i.i.i.i.i
  %.136.i.i.i.i.i = fcmp contract oeq double %.3830.i.i.i.i, 0.000000e+00
  br i1 %.136.i.i.i.i.i, label %_ZN17bnserve_surrogate8tangents7_series6_phaseB4v174B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE10complex12810complex12810complex1288UniTupleI10complex128Li2EE8UniTupleI10complex128Li2EE5ArrayI10complex128Li2E1C7mutable7alignedE.exit.i.i, label %B282.endif.i.i.i.i.i, !prof !24

B174.endif.i.i.i.i.i:                             ; preds = %B132.i.i.i.i.i
  %.89.i.i.i.i.i = fdiv contract double %.3830.i.i.i.i, %.3827.i.i.i.i
  %.91.i.i.i.i.i = fmul contract double %.3830.i.i.i.i, %.89.i.i.i.i.i
  %.93.i.i.i.i.i = fadd contract double %.3827.i.i.i.i, %.91.i.i.i.i.i
  %.98.i.i.i.i.i = fcmp contract oeq double %.93.i.i.i.i.i, 0.000000e+00
  br i1 %.98.i.i.i.i.i, label %_ZN17bnserve_surrogate8tangents7_series6_phaseB4v174B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE10complex12810complex12810complex1288UniTupleI10complex128Li2EE8UniTupleI10complex128Li2EE5ArrayI10complex128Li2E1C7mutable7alignedE.exit.i.i, label %B174.endif.endif.i.i.i.i.i, !prof !24

B174.endif.endif.i.i.i.i.i:                       ; preds = %B174.endif.i.i.i.i.i
  %.95.i.i.i.i.i = fmul contract double %.89.i.i.i.i.i, %.3762.i.i.i.i
  %.97.i.i.i.i.i = fadd contract double %.3759.i.i.i.i, %.95.i.i.i.i.i
  %.105.i.i.i.i.i = fdiv contract double %.97.i.i.i.i.i, %.93.i.i.i.i.i
  %.107.i.i.i.i.i = fmul contract double %.89.i.i.i.i.i, %.3759.i.i.i.i
  %.109.i.i.i.i.i = fsub contract double %.3762.i.i.i.i, %.107.i.i.i.i.i
  %.117.i.i.i.i.i = fdiv contract double %.109.i.i.i.i.i, %.93.i.i.i.i.i
  br label %B0.endif.endif.endif.endi...endif.4.endif.endif.endif.i.i.i.i

B282.endif.i.i.i.i.i:                             ; preds = %B282.i.i.i.i.i
  %.143.i.i.i.i.i = fdiv contract double %.3827.i.i.i.i, %.3830.i.i.i.i
  %.145.i.i.i.i.i = fmul contract double %.3827.i.i.i.i, %.143.i.i.i.i.i
  %.147.i.i.i.i.i = fadd contract double %.3830.i.i.i.i, %.145.i.i.i.i.i
  %.152.i.i.i.i.i = fcmp contract oeq double %.147.i.i.i.i.i, 0.000000e+00
  br i1 %.152.i.i.i.i.i, label %_ZN17bnserve_surrogate8tangents7_series6_phaseB4v174B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE10complex12810complex12810complex1288UniTupleI10complex128Li2EE8UniTupleI10complex128Li2EE5ArrayI10complex128Li2E1C7mutable7alignedE.exit.i.i, label %B282.endif.endif.i.i.i.i.i, !prof !24

B282.endif.endif.i.i.i.i.i:                       ; preds = %B282.endif.i.i.i.i.i
  %.149.i.i.i.i.i = fmul contract double %.143.i.i.i.i.i, %.3759.i.i.i.i
  %.151.i.i.i.i.i = fadd contract double %.3762.i.i.i.i, %.149.i.i.i.i.i
  %.159.i.i.i.i.i = fdiv contract double %.151.i.i.i.i.i, %.147.i.i.i.i.i
  %.161.i.i.i.i.i = fmul contract double %.143.i.i.i.i.i, %.3762.i.i.i.i
  %.163.i.i.i.i.i = fsub contract double %.161.i.i.i.i.i, %.3759.i.i.i.i
  %.171.i.i.i.i.i = fdiv contract double %.163.i.i.i.i.i, %.147.i.i.i.i.i
  br label %B0.endif.endif.endif.endi...endif.4.endif.endif.endif.i.i.i.i

B0.endif.endif.endif.endi...endif.4.endif.endif.endif.i.i.i.i: ; preds = %B282.endif.endif.i.i.i.i.i, %B174.endif.endif.i.i.i.i.i, %B270.i.i.i.i.i
  %.3834.sroa.0.0.i.i.i.i = phi double [ 0x7FF8000000000000, %B270.i.i.i.i.i ], [ %.105.i.i.i.i.i, %B174.endif.endif.i.i.i.i.i ], [ %.159.i.i.i.i.i, %B282.endif.endif.i.i.i.i.i ]
  %.3834.sroa.4.0.i.i.i.i = phi double [ 0x7FF8000000000000, %B270.i.i.i.i.i ], [ %.117.i.i.i.i.i, %B174.endif.endif.i.i.i.i.i ], [ %.171.i.i.i.i.i, %B282.endif.endif.i.i.i.i.i ]
  %.3879.i.i.i.i = fadd contract double %.3496.i.i.i.i, %.3834.sroa.0.0.i.i.i.i
  %.3882.i.i.i.i = fadd contract double %.3498.i.i.i.i, %.3834.sroa.4.0.i.i.i.i
  store double %.3879.i.i.i.i, ptr %.3494.i.i.i.i, align 8, !noalias !77
  store double %.3882.i.i.i.i, ptr %.3497.i.i.i.i, align 8, !noalias !77
  %.64.i164.i.i.i.i = fmul contract double %.80.i62.i.i.i, 0x40C0712C540DB5CD
  %.80.i165.i.i.i.i = fadd contract double %.58.i.i.i1.i.i, %.64.i164.i.i.i.i
  %.46.i166.i.i.i.i = fmul contract double %.70.i65.i.i.i, 0x40C0712C540DB5CD
  %.70.i168.i.i.i.i = fsub contract double %.46.i166.i.i.i.i, %.52.i.i.i5.i.i
  %.4068.i.i.i.i = fadd contract double %.70.i168.i.i.i.i, 0x40A79A477BF30A91
  %.4071.i.i.i.i = fadd contract double %.80.i165.i.i.i.i, 0.000000e+00
  %.58.i170.i.i.i.i = fmul contract double %.70.i65.i.i.i, %.4071.i.i.i.i
  %.64.i171.i.i.i.i = fmul contract double %.80.i62.i.i.i, %.4068.i.i.i.i
  %.80.i172.i.i.i.i = fadd contract double %.64.i171.i.i.i.i, %.58.i170.i.i.i.i
  %.46.i173.i.i.i.i = fmul contract double %.70.i65.i.i.i, %.4068.i.i.i.i
  %.52.i174.i.i.i.i = fmul contract double %.80.i62.i.i.i, %.4071.i.i.i.i
  %.70.i175.i.i.i.i = fsub contract double %.46.i173.i.i.i.i, %.52.i174.i.i.i.i
  %.4128.i.i.i.i = fadd contract double %.70.i175.i.i.i.i, 0xC0A4B055B758E414
  %.4131.i.i.i.i = fadd contract double %.80.i172.i.i.i.i, 0.000000e+00
  %.58.i177.i.i.i.i = fmul contract double %.70.i65.i.i.i, %.4131.i.i.i.i
  %.64.i178.i.i.i.i = fmul contract double %.80.i62.i.i.i, %.4128.i.i.i.i
  %.80.i179.i.i.i.i = fadd contract double %.64.i178.i.i.i.i, %.58.i177.i.i.i.i
  %.46.i180.i.i.i.i = fmul contract double %.70.i65.i.i.i, %.4128.i.i.i.i
  %.52.i181.i.i.i.i = fmul contract double %.80.i62.i.i.i, %.4131.i.i.i.i
  %.70.i182.i.i.i.i = fsub contract double %.46.i180.i.i.i.i, %.52.i181.i.i.i.i
  %.4248.i.i.i.i = load double, ptr %.4246.i.i.i.i, align 8, !noalias !77
  %.4250.i.i.i.i = load double, ptr %.4249.i.i.i.i, align 8, !noalias !77
  %.4191.i.i.i.i = fadd contract double %.80.i179.i.i.i.i, 0.000000e+00
  %.4188.i.i.i.i = fadd contract double %.70.i182.i.i.i.i, 0x406D67FD70A13797
  br i1 %.56.i.i.i.i.i, label %B270.i215.i.i.i.i, label %B132.i194.i.i.i.i

B132.i194.i.i.i.i:                                ; preds = %B0.endif.endif.endif.endi...endif.4.endif.endif.endif.i.i.i.i
  %.59.i195.i.i.i.i = fcmp contract oeq double %.3827.i.i.i.i, 0.000000e+00
  br i1 %.59.i195.i.i.i.i, label %_ZN17bnserve_surrogate8tangents7_series6_phaseB4v174B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE10complex12810complex12810complex1288UniTupleI10complex128Li2EE8UniTupleI10complex128Li2EE5ArrayI10complex128Li2E1C7mutable7alignedE.exit.i.i, label %B174.endif.i196.i.i.i.i, !prof !76

B270.i215.i.i.i.i:                                ; preds = %B0.endif.endif.endif.endi...endif.4.endif.endif.endif.i.i.i.i
  %.132.i216.i.i.i.i = fcmp contract ult double %.50.i.i.i.i.i, %.45.i.i.i.i.i
  br i1 %.132.i216.i.i.i.i, label %B0.endif.endif.endif.endi...endif.6.i.i.i.i, label %B282.i217.i.i.i.i

B282.i217.i.i.i.i:                                ; preds = %B270.i215.i.i.i.i
  %.136.i218.i.i.i.i = fcmp contract oeq double %.3830.i.i.i.i, 0.000000e+00
  br i1 %.136.i218.i.i.i.i, label %_ZN17bnserve_surrogate8tangents7_series6_phaseB4v174B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE10complex12810complex12810complex1288UniTupleI10complex128Li2EE8UniTupleI10complex128Li2EE5ArrayI10complex128Li2E1C7mutable7alignedE.exit.i.i, label %B282.endif.i219.i.i.i.i, !prof !24

B174.endif.i196.i.i.i.i:                          ; preds = %B132.i194.i.i.i.i
  %.89.i197.i.i.i.i = fdiv contract double %.3830.i.i.i.i, %.3827.i.i.i.i
  %.91.i198.i.i.i.i = fmul contract double %.3830.i.i.i.i, %.89.i197.i.i.i.i
  %.93.i199.i.i.i.i = fadd contract double %.3827.i.i.i.i, %.91.i198.i.i.i.i
  %.98.i200.i.i.i.i = fcmp contract oeq double %.93.i199.i.i.i.i, 0.000000e+00
  br i1 %.98.i200.i.i.i.i, label %_ZN17bnserve_surrogate8tangents7_series6_phaseB4v174B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE10complex12810complex12810complex1288UniTupleI10complex128Li2EE8UniTupleI10complex128Li2EE5ArrayI10complex128Li2E1C7mutable7alignedE.exit.i.i, label %B174.endif.endif.i201.i.i.i.i, !prof !24

B174.endif.endif.i201.i.i.i.i:                    ; preds = %B174.endif.i196.i.i.i.i
  %.95.i202.i.i.i.i = fmul contract double %.89.i197.i.i.i.i, %.4191.i.i.i.i
  %.97.i203.i.i.i.i = fadd contract double %.4188.i.i.i.i, %.95.i202.i.i.i.i
  %.105.i204.i.i.i.i = fdiv contract double %.97.i203.i.i.i.i, %.93.i199.i.i.i.i
  %.107.i205.i.i.i.i = fmul contract double %.89.i197.i.i.i.i, %.4188.i.i.i.i
  %.109.i206.i.i.i.i = fsub contract double %.4191.i.i.i.i, %.107.i205.i.i.i.i
  %.117.i207.i.i.i.i = fdiv contract double %.109.i206.i.i.i.i, %.93.i199.i.i.i.i
  br label %B0.endif.endif.endif.endi...endif.6.i.i.i.i

B282.endif.i219.i.i.i.i:                          ; preds = %B282.i217.i.i.i.i
  %.143.i220.i.i.i.i = fdiv contract double %.3827.i.i.i.i, %.3830.i.i.i.i
  %.145.i221.i.i.i.i = fmul contract double %.3827.i.i.i.i, %.143.i220.i.i.i.i
  %.147.i222.i.i.i.i = fadd contract double %.3830.i.i.i.i, %.145.i221.i.i.i.i
  %.152.i223.i.i.i.i = fcmp contract oeq double %.147.i222.i.i.i.i, 0.000000e+00
  br i1 %.152.i223.i.i.i.i, label %_ZN17bnserve_surrogate8tangents7_series6_phaseB4v174B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE10complex12810complex12810complex1288UniTupleI10complex128Li2EE8UniTupleI10complex128Li2EE5ArrayI10complex128Li2E1C7mutable7alignedE.exit.i.i, label %B282.endif.endif.i224.i.i.i.i, !prof !24

B282.endif.endif.i224.i.i.i.i:                    ; preds = %B282.endif.i219.i.i.i.i
  %.149.i225.i.i.i.i = fmul contract double %.143.i220.i.i.i.i, %.4188.i.i.i.i
  %.151.i226.i.i.i.i = fadd contract double %.4191.i.i.i.i, %.149.i225.i.i.i.i
  %.159.i227.i.i.i.i = fdiv contract double %.151.i226.i.i.i.i, %.147.i222.i.i.i.i
  %.161.i228.i.i.i.i = fmul contract double %.143.i220.i.i.i.i, %.4191.i.i.i.i
  %.163.i229.i.i.i.i = fsub contract double %.161.i228.i.i.i.i, %.4188.i.i.i.i
  %.171.i230.i.i.i.i = fdiv contract double %.163.i229.i.i.i.i, %.147.i222.i.i.i.i
  br label %B0.endif.endif.endif.endi...endif.6.i.i.i.i

B0.endif.endif.endif.endi...endif.6.i.i.i.i:      ; preds = %B282.endif.endif.i224.i.i.i.i, %B174.endif.endif.i201.i.i.i.i, %B270.i215.i.i.i.i
  %.4319.sroa.0.0.i.i.i.i = phi double [ 0x7FF8000000000000, %B270.i215.i.i.i.i ], [ %.105.i204.i.i.i.i, %B174.endif.endif.i201.i.i.i.i ], [ %.159.i227.i.i.i.i, %B282.endif.endif.i224.i.i.i.i ]
  %.4319.sroa.4.0.i.i.i.i = phi double [ 0x7FF8000000000000, %B270.i215.i.i.i.i ], [ %.117.i207.i.i.i.i, %B174.endif.endif.i201.i.i.i.i ], [ %.171.i230.i.i.i.i, %B282.endif.endif.i224.i.i.i.i ]
  %.4364.i.i.i.i = fadd contract double %.4248.i.i.i.i, %.4319.sroa.0.0.i.i.i.i
  %.4367.i.i.i.i = fadd contract double %.4250.i.i.i.i, %.4319.sroa.4.0.i.i.i.i
  store double %.4364.i.i.i.i, ptr %.4246.i.i.i.i, align 8, !noalias !77
  store double %.4367.i.i.i.i, ptr %.4249.i.i.i.i, align 8, !noalias !77
  %.4477.i.i.i.i = load double, ptr %.4475.i.i.i.i, align 8, !noalias !77
  %.4479.i.i.i.i = load double, ptr %.4478.i.i.i.i, align 8, !noalias !77
  %.64.i235.i.i.i.i = fmul contract double %.80.i62.i.i.i, 0x402CA90C106318D7
  %.80.i236.i.i.i.i = fadd contract double %.58.i.i.i1.i.i, %.64.i235.i.i.i.i
  %.46.i237.i.i.i.i = fmul contract double %.70.i65.i.i.i, 0x402CA90C106318D7
  %.70.i239.i.i.i.i = fsub contract double %.46.i237.i.i.i.i, %.52.i.i.i5.i.i
  %.4646.i.i.i.i = fadd contract double %.70.i239.i.i.i.i, 0xC06030460C29F3DF
  %.4649.i.i.i.i = fadd contract double %.80.i236.i.i.i.i, 0.000000e+00
  %.58.i241.i.i.i.i = fmul contract double %.70.i65.i.i.i, %.4649.i.i.i.i
  %.64.i242.i.i.i.i = fmul contract double %.80.i62.i.i.i, %.4646.i.i.i.i
  %.80.i243.i.i.i.i = fadd contract double %.64.i242.i.i.i.i, %.58.i241.i.i.i.i
  %.46.i244.i.i.i.i = fmul contract double %.70.i65.i.i.i, %.4646.i.i.i.i
  %.52.i245.i.i.i.i = fmul contract double %.80.i62.i.i.i, %.4649.i.i.i.i
  %.70.i246.i.i.i.i = fsub contract double %.46.i244.i.i.i.i, %.52.i245.i.i.i.i
  %.4706.i.i.i.i = fadd contract double %.70.i246.i.i.i.i, 0x40D015D04F4BC5D2
  %.4709.i.i.i.i = fadd contract double %.80.i243.i.i.i.i, 0.000000e+00
  %.58.i248.i.i.i.i = fmul contract double %.70.i65.i.i.i, %.4709.i.i.i.i
  %.64.i249.i.i.i.i = fmul contract double %.80.i62.i.i.i, %.4706.i.i.i.i
  %.80.i250.i.i.i.i = fadd contract double %.64.i249.i.i.i.i, %.58.i248.i.i.i.i
  %.46.i251.i.i.i.i = fmul contract double %.70.i65.i.i.i, %.4706.i.i.i.i
  %.52.i252.i.i.i.i = fmul contract double %.80.i62.i.i.i, %.4709.i.i.i.i
  %.70.i253.i.i.i.i = fsub contract double %.46.i251.i.i.i.i, %.52.i252.i.i.i.i
  %.4766.i.i.i.i = fadd contract double %.70.i253.i.i.i.i, 0xC0E536054A2E10AB
  %.4769.i.i.i.i = fadd contract double %.80.i250.i.i.i.i, 0.000000e+00
  %.58.i255.i.i.i.i = fmul contract double %.70.i65.i.i.i, %.4769.i.i.i.i
  %.64.i256.i.i.i.i = fmul contract double %.80.i62.i.i.i, %.4766.i.i.i.i
  %.80.i257.i.i.i.i = fadd contract double %.64.i256.i.i.i.i, %.58.i255.i.i.i.i
  %.46.i258.i.i.i.i = fmul contract double %.70.i65.i.i.i, %.4766.i.i.i.i
  %.52.i259.i.i.i.i = fmul contract double %.80.i62.i.i.i, %.4769.i.i.i.i
  %.70.i260.i.i.i.i = fsub contract double %.46.i258.i.i.i.i, %.52.i259.i.i.i.i
  %.4826.i.i.i.i = fadd contract double %.70.i260.i.i.i.i, 0x40C95DBCC2240A74
  %.4829.i.i.i.i = fadd contract double %.80.i257.i.i.i.i, 0.000000e+00
  %.4852.i.i.i.i = fadd contract double %.4826.i.i.i.i, %.4477.i.i.i.i
  %.4855.i.i.i.i = fadd contract double %.4829.i.i.i.i, %.4479.i.i.i.i
  store double %.4852.i.i.i.i, ptr %.4475.i.i.i.i, align 8, !noalias !77
  store double %.4855.i.i.i.i, ptr %.4478.i.i.i.i, align 8, !noalias !77
  %.4965.i.i.i.i = load double, ptr %.4963.i.i.i.i, align 8, !noalias !77
  %.4967.i.i.i.i = load double, ptr %.4966.i.i.i.i, align 8, !noalias !77
  %.64.i263.i.i.i.i = fmul contract double %.80.i62.i.i.i, 0x40BD257CD0AE1310
  %38 = fsub contract double %.58.i.i.i1.i.i, %.64.i263.i.i.i.i
  %.46.i265.i.i.i.i = fmul contract double %.70.i65.i.i.i, 0xC0BD257CD0AE1310
  %.70.i267.i.i.i.i = fsub contract double %.46.i265.i.i.i.i, %.52.i.i.i5.i.i
  %.5047.i.i.i.i = fadd contract double %.70.i267.i.i.i.i, 0xC09600901EF7C9A4
  %.5050.i.i.i.i = fadd contract double %38, 0.000000e+00
  %.5073.i.i.i.i = fadd contract double %.5047.i.i.i.i, %.4965.i.i.i.i
  %.5076.i.i.i.i = fadd contract double %.5050.i.i.i.i, %.4967.i.i.i.i
  store double %.5073.i.i.i.i, ptr %.4963.i.i.i.i, align 8, !noalias !77
  store double %.5076.i.i.i.i, ptr %.4966.i.i.i.i, align 8, !noalias !77
  store ptr null, ptr %.568.i.i.i, align 8, !noalias !72
  call fastcc void @inner_5(ptr nonnull %.568.i.i.i, double %.88.sroa.0.0.i.i.i, double %.88.sroa.4.0.i.i.i, double %.455.i.i, double %"$phi446.4.2.1.i.i", ptr nonnull %arg.state.10.0.4)
  store ptr null, ptr %.599.i.i.i, align 8, !noalias !72
  call fastcc void @inner_5(ptr nonnull %.599.i.i.i, double %.161.sroa.0.0.i.i.i, double %.161.sroa.4.0.i.i.i, double %.520.i.i, double %"$phi556.4.2.1.i.i", ptr nonnull %arg.state.10.0.4)
  store ptr null, ptr %.632.i.i.i, align 8, !noalias !72
  call fastcc void @inner_6(ptr nonnull %.632.i.i.i, double %.88.sroa.0.0.i.i.i, double %.88.sroa.4.0.i.i.i, double %.455.i.i, double %"$phi446.4.2.1.i.i", double %.73.le.i.i.i, double %.613.i.i, ptr nonnull %arg.state.10.0.4)
  store ptr null, ptr %.669.i.i.i, align 8, !noalias !72
  call fastcc void @inner_6(ptr nonnull %.669.i.i.i, double %.161.sroa.0.0.i.i.i, double %.161.sroa.4.0.i.i.i, double %.520.i.i, double %"$phi556.4.2.1.i.i", double %.73.le.i17.i.i, double %.628.i.i, ptr nonnull %arg.state.10.0.4)
  %.55.i.i.i.i = fsub contract double 1.000000e+00, %.88.sroa.0.0.i.i.i
  %.58.i3.i.i.i = fsub contract double 0.000000e+00, %.88.sroa.4.0.i.i.i
  %.58.i.i4.i.i.i = fmul contract double %.88.sroa.0.0.i.i.i, %.58.i3.i.i.i
  %.64.i.i5.i.i.i = fmul contract double %.88.sroa.4.0.i.i.i, %.55.i.i.i.i
  %.80.i.i6.i.i.i = fadd contract double %.58.i.i4.i.i.i, %.64.i.i5.i.i.i
  %.46.i.i7.i.i.i = fmul contract double %.88.sroa.0.0.i.i.i, %.55.i.i.i.i
  %.52.i.i8.i.i.i = fmul contract double %.88.sroa.4.0.i.i.i, %.58.i3.i.i.i
  %.70.i.i9.i.i.i = fsub contract double %.46.i.i7.i.i.i, %.52.i.i8.i.i.i
  %.58.i1.i.i7.i.i = fmul contract double %"$phi446.4.2.1.i.i", %.70.i.i9.i.i.i
  %.64.i2.i.i8.i.i = fmul contract double %.455.i.i, %.80.i.i6.i.i.i
  %.80.i3.i.i9.i.i = fadd contract double %.64.i2.i.i8.i.i, %.58.i1.i.i7.i.i
  %.46.i4.i.i10.i.i = fmul contract double %.455.i.i, %.70.i.i9.i.i.i
  %.52.i5.i.i11.i.i = fmul contract double %"$phi446.4.2.1.i.i", %.80.i.i6.i.i.i
  %.70.i6.i.i12.i.i = fsub contract double %.46.i4.i.i10.i.i, %.52.i5.i.i11.i.i
  %.58.i8.i.i13.i.i = fmul contract double %"$phi556.4.2.1.i.i", %.70.i6.i.i12.i.i
  %.64.i9.i.i14.i.i = fmul contract double %.520.i.i, %.80.i3.i.i9.i.i
  %.80.i10.i.i15.i.i = fadd contract double %.64.i9.i.i14.i.i, %.58.i8.i.i13.i.i
  %.46.i11.i.i16.i.i = fmul contract double %.520.i.i, %.70.i6.i.i12.i.i
  %.52.i12.i.i17.i.i = fmul contract double %"$phi556.4.2.1.i.i", %.80.i3.i.i9.i.i
  %.70.i13.i.i18.i.i = fsub contract double %.46.i11.i.i16.i.i, %.52.i12.i.i17.i.i
  %.195.i.i.i.i = load double, ptr %.588.i.i.i.i, align 8, !noalias !81
  %.197.i.i.i.i = load double, ptr %.591.i.i.i.i, align 8, !noalias !81
  %.58.i15.i.i19.i.i = fmul contract double %.80.i10.i.i15.i.i, 9.875000e+01
  %.64.i16.i.i20.i.i = fmul contract double %.70.i13.i.i18.i.i, 0.000000e+00
  %39 = fsub contract double %.64.i16.i.i20.i.i, %.58.i15.i.i19.i.i
  %.46.i18.i.i.i.i = fmul contract double %.70.i13.i.i18.i.i, -9.875000e+01
  %.52.i19.i.i.i.i = fmul contract double %.80.i10.i.i15.i.i, 0.000000e+00
  %.70.i20.i.i.i.i = fsub contract double %.46.i18.i.i.i.i, %.52.i19.i.i.i.i
  %.251.i.i.i.i = fadd contract double %.70.i20.i.i.i.i, %.195.i.i.i.i
  %.254.i.i.i.i = fadd contract double %39, %.197.i.i.i.i
  store double %.251.i.i.i.i, ptr %.588.i.i.i.i, align 8, !noalias !81
  store double %.254.i.i.i.i, ptr %.591.i.i.i.i, align 8, !noalias !81
  %.364.i.i.i.i = load double, ptr %.1111.i.i.i.i, align 8, !noalias !81
  %.366.i.i.i.i = load double, ptr %.1114.i.i.i.i, align 8, !noalias !81
  %.58.i22.i.i.i.i = fmul contract double %.80.i.i6.i.i.i, 0x40735B8E38E38E39
  %.64.i23.i.i.i.i = fmul contract double %.70.i.i9.i.i.i, 0.000000e+00
  %.80.i24.i.i.i.i = fadd contract double %.64.i23.i.i.i.i, %.58.i22.i.i.i.i
  %.46.i25.i.i.i.i = fmul contract double %.70.i.i9.i.i.i, 0x40735B8E38E38E39
  %.52.i26.i.i.i.i = fmul contract double %.80.i.i6.i.i.i, 0.000000e+00
  %.70.i27.i.i.i.i = fsub contract double %.46.i25.i.i.i.i, %.52.i26.i.i.i.i
  %.428.i.i.i.i = fadd contract double %.70.i27.i.i.i.i, 0x40723BDB6DB6DB6E
  %.431.i.i.i.i = fadd contract double %.80.i24.i.i.i.i, 0.000000e+00
  %.58.i29.i.i.i.i = fmul contract double %.431.i.i.i.i, %.70.i13.i.i18.i.i
  %.64.i30.i.i.i.i = fmul contract double %.428.i.i.i.i, %.80.i10.i.i15.i.i
  %.80.i31.i.i.i.i = fadd contract double %.64.i30.i.i.i.i, %.58.i29.i.i.i.i
  %.46.i32.i.i.i.i = fmul contract double %.428.i.i.i.i, %.70.i13.i.i18.i.i
  %.52.i33.i.i.i.i = fmul contract double %.431.i.i.i.i, %.80.i10.i.i15.i.i
  %.70.i34.i.i.i.i = fsub contract double %.46.i32.i.i.i.i, %.52.i33.i.i.i.i
  %.480.i10.i.i.i = fadd contract double %.70.i34.i.i.i.i, %.364.i.i.i.i
  %.483.i.i.i.i = fadd contract double %.80.i31.i.i.i.i, %.366.i.i.i.i
  store double %.480.i10.i.i.i, ptr %.1111.i.i.i.i, align 8, !noalias !81
  store double %.483.i.i.i.i, ptr %.1114.i.i.i.i, align 8, !noalias !81
  %.58.i36.i.i.i.i = fmul contract double %"$phi446.4.2.1.i.i", %.88.sroa.0.0.i.i.i
  %.64.i37.i.i.i.i = fmul contract double %.455.i.i, %.88.sroa.4.0.i.i.i
  %.80.i38.i.i.i.i = fadd contract double %.64.i37.i.i.i.i, %.58.i36.i.i.i.i
  %.46.i39.i.i.i.i = fmul contract double %.455.i.i, %.88.sroa.0.0.i.i.i
  %.52.i40.i.i.i.i = fmul contract double %"$phi446.4.2.1.i.i", %.88.sroa.4.0.i.i.i
  %.70.i41.i.i.i.i = fsub contract double %.46.i39.i.i.i.i, %.52.i40.i.i.i.i
  %.58.i43.i.i.i.i = fmul contract double %"$phi556.4.2.1.i.i", %.55.i.i.i.i
  %.64.i44.i.i.i.i = fmul contract double %.520.i.i, %.58.i3.i.i.i
  %.80.i45.i.i.i.i = fadd contract double %.64.i44.i.i.i.i, %.58.i43.i.i.i.i
  %.46.i46.i.i.i.i = fmul contract double %.520.i.i, %.55.i.i.i.i
  %.52.i47.i.i.i.i = fmul contract double %"$phi556.4.2.1.i.i", %.58.i3.i.i.i
  %.70.i48.i.i.i.i = fsub contract double %.46.i46.i.i.i.i, %.52.i47.i.i.i.i
  %.705.i.i.i.i = load double, ptr %.1645.i.i.i.i, align 8, !noalias !81
  %.707.i.i.i.i = load double, ptr %.1648.i.i.i.i, align 8, !noalias !81
  %.58.i50.i.i.i.i = fmul contract double %.80.i10.i.i15.i.i, 8.000000e+02
  %.80.i52.i.i.i.i = fadd contract double %.64.i16.i.i20.i.i, %.58.i50.i.i.i.i
  %.46.i53.i.i.i.i = fmul contract double %.70.i13.i.i18.i.i, 8.000000e+02
  %.70.i55.i.i.i.i = fsub contract double %.46.i53.i.i.i.i, %.52.i19.i.i.i.i
  %.648.i.i.i.i = fsub contract double %.80.i38.i.i.i.i, %.80.i45.i.i.i.i
  %.645.i.i.i.i = fsub contract double %.70.i41.i.i.i.i, %.70.i48.i.i.i.i
  %.58.i57.i.i.i.i = fmul contract double %.645.i.i.i.i, %.648.i.i.i.i
  %.80.i59.i.i.i.i = fadd contract double %.58.i57.i.i.i.i, %.58.i57.i.i.i.i
  %.46.i60.i.i.i.i = fmul contract double %.645.i.i.i.i, %.645.i.i.i.i
  %.52.i61.i.i.i.i = fmul contract double %.648.i.i.i.i, %.648.i.i.i.i
  %.70.i62.i.i.i.i = fsub contract double %.46.i60.i.i.i.i, %.52.i61.i.i.i.i
  %.58.i64.i.i.i.i = fmul contract double %.80.i59.i.i.i.i, 7.500000e+00
  %.64.i65.i.i.i.i = fmul contract double %.70.i62.i.i.i.i, 0.000000e+00
  %.80.i66.i.i.i.i = fadd contract double %.64.i65.i.i.i.i, %.58.i64.i.i.i.i
  %.46.i67.i.i.i.i = fmul contract double %.70.i62.i.i.i.i, 7.500000e+00
  %.52.i68.i.i.i.i = fmul contract double %.80.i59.i.i.i.i, 0.000000e+00
  %.70.i69.i.i.i.i = fsub contract double %.46.i67.i.i.i.i, %.52.i68.i.i.i.i
  %.866.i.i.i.i = fadd contract double %.70.i69.i.i.i.i, %.70.i55.i.i.i.i
  %.869.i.i.i.i = fadd contract double %.80.i66.i.i.i.i, %.80.i52.i.i.i.i
  %.58.i71.i.i.i.i = fmul contract double %.869.i.i.i.i, 0x400921FB54442D18
  %.64.i72.i.i.i.i = fmul contract double %.866.i.i.i.i, 0.000000e+00
  %40 = fsub contract double %.64.i72.i.i.i.i, %.58.i71.i.i.i.i
  %.46.i74.i.i.i.i = fmul contract double %.866.i.i.i.i, 0xC00921FB54442D18
  %.52.i75.i.i.i.i = fmul contract double %.869.i.i.i.i, 0.000000e+00
  %.70.i76.i.i.i.i = fsub contract double %.46.i74.i.i.i.i, %.52.i75.i.i.i.i
  %.926.i.i.i.i = fadd contract double %.70.i76.i.i.i.i, %.705.i.i.i.i
  %.929.i.i.i.i = fadd contract double %40, %.707.i.i.i.i
  store double %.926.i.i.i.i, ptr %.1645.i.i.i.i, align 8, !noalias !81
  store double %.929.i.i.i.i, ptr %.1648.i.i.i.i, align 8, !noalias !81
  store ptr null, ptr %.737.i.i.i, align 8, !noalias !72
  call fastcc void @inner_7(ptr nonnull %.737.i.i.i, double %.88.sroa.0.0.i.i.i, double %.88.sroa.4.0.i.i.i, double %.81.i.i, double %"$phi620.1.2.1.i.i", ptr nonnull %arg.state.10.0.4)
  store ptr null, ptr %.775.i.i.i, align 8, !noalias !72
  call fastcc void @inner_7(ptr nonnull %.775.i.i.i, double %.161.sroa.0.0.i.i.i, double %.161.sroa.4.0.i.i.i, double %.111.i.i, double %"$phi670.1.2.1.i.i", ptr nonnull %arg.state.10.0.4)
  %.58.i67.i.i.i = fmul contract double %.80.i62.i.i.i, 1.280000e+02
  %.80.i69.i.i.i = fadd contract double %.58.i.i.i1.i.i, %.58.i67.i.i.i
  %.46.i70.i.i.i = fmul contract double %.70.i65.i.i.i, 1.280000e+02
  %.70.i72.i.i.i = fsub contract double %.46.i70.i.i.i, %.52.i.i.i5.i.i
  %.45.i74.i.i.i = tail call contract double @llvm.fabs.f64(double %.70.i72.i.i.i)
  %.50.i75.i.i.i = tail call contract double @llvm.fabs.f64(double %.80.i69.i.i.i)
  %.56.i76.i.i.i = fcmp contract ult double %.45.i74.i.i.i, %.50.i75.i.i.i
  br i1 %.56.i76.i.i.i, label %B270.i98.i.i.i, label %B132.i77.i.i.i

B132.i77.i.i.i:                                   ; preds = %B0.endif.endif.endif.endi...endif.6.i.i.i.i
  %.59.i78.i.i.i = fcmp contract oeq double %.70.i72.i.i.i, 0.000000e+00
  br i1 %.59.i78.i.i.i, label %_ZN17bnserve_surrogate8tangents7_series6_phaseB4v174B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE10complex12810complex12810complex1288UniTupleI10complex128Li2EE8UniTupleI10complex128Li2EE5ArrayI10complex128Li2E1C7mutable7alignedE.exit.i.i, label %B174.endif.i79.i.i.i, !prof !76

B270.i98.i.i.i:                                   ; preds = %B0.endif.endif.endif.endi...endif.6.i.i.i.i
  %.132.i99.i.i.i = fcmp contract ult double %.50.i75.i.i.i, %.45.i74.i.i.i
  br i1 %.132.i99.i.i.i, label %B576.if.i.i.i, label %B282.i100.i.i.i

B282.i100.i.i.i:                                  ; preds = %B270.i98.i.i.i
  %.136.i101.i.i.i = fcmp contract oeq double %.80.i69.i.i.i, 0.000000e+00
  br i1 %.136.i101.i.i.i, label %_ZN17bnserve_surrogate8tangents7_series6_phaseB4v174B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE10complex12810complex12810complex1288UniTupleI10complex128Li2EE8UniTupleI10complex128Li2EE5ArrayI10complex128Li2E1C7mutable7alignedE.exit.i.i, label %B282.endif.i102.i.i.i, !prof !24

B174.endif.i79.i.i.i:                             ; preds = %B132.i77.i.i.i
  %.89.i80.i.i.i = fdiv contract double %.80.i69.i.i.i, %.70.i72.i.i.i
  %.91.i81.i.i.i = fmul contract double %.80.i69.i.i.i, %.89.i80.i.i.i
  %.93.i82.i.i.i = fadd contract double %.70.i72.i.i.i, %.91.i81.i.i.i
  %.98.i83.i.i.i = fcmp contract oeq double %.93.i82.i.i.i, 0.000000e+00
  br i1 %.98.i83.i.i.i, label %_ZN17bnserve_surrogate8tangents7_series6_phaseB4v174B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE10complex12810complex12810complex1288UniTupleI10complex128Li2EE8UniTupleI10complex128Li2EE5ArrayI10complex128Li2E1C7mutable7alignedE.exit.i.i, label %B174.endif.endif.i84.i.i.i, !prof !24

B174.endif.endif.i84.i.i.i:                       ; preds = %B174.endif.i79.i.i.i
  %.95.i85.i.i.i = fmul contract double %.89.i80.i.i.i, 0.000000e+00
  %.97.i86.i.i.i = fadd contract double %.95.i85.i.i.i, 3.000000e+00
  %.105.i87.i.i.i = fdiv contract double %.97.i86.i.i.i, %.93.i82.i.i.i
  %.107.i88.i.i.i = fmul contract double %.89.i80.i.i.i, 3.000000e+00
  %.109.i89.i.i.i = fsub contract double 0.000000e+00, %.107.i88.i.i.i
  %.117.i90.i.i.i = fdiv contract double %.109.i89.i.i.i, %.93.i82.i.i.i
  br label %B576.if.i.i.i

B282.endif.i102.i.i.i:                            ; preds = %B282.i100.i.i.i
  %.143.i103.i.i.i = fdiv contract double %.70.i72.i.i.i, %.80.i69.i.i.i
  %.145.i104.i.i.i = fmul contract double %.70.i72.i.i.i, %.143.i103.i.i.i
  %.147.i105.i.i.i = fadd contract double %.80.i69.i.i.i, %.145.i104.i.i.i
  %.152.i106.i.i.i = fcmp contract oeq double %.147.i105.i.i.i, 0.000000e+00
  br i1 %.152.i106.i.i.i, label %_ZN17bnserve_surrogate8tangents7_series6_phaseB4v174B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE10complex12810complex12810complex1288UniTupleI10complex128Li2EE8UniTupleI10complex128Li2EE5ArrayI10complex128Li2E1C7mutable7alignedE.exit.i.i, label %B282.endif.endif.i107.i.i.i, !prof !24

B282.endif.endif.i107.i.i.i:                      ; preds = %B282.endif.i102.i.i.i
  %.149.i108.i.i.i = fmul contract double %.143.i103.i.i.i, 3.000000e+00
  %.151.i109.i.i.i = fadd contract double %.149.i108.i.i.i, 0.000000e+00
  %.159.i110.i.i.i = fdiv contract double %.151.i109.i.i.i, %.147.i105.i.i.i
  %.161.i111.i.i.i = fmul contract double %.143.i103.i.i.i, 0.000000e+00
  %.163.i112.i.i.i = fadd contract double %.161.i111.i.i.i, -3.000000e+00
  %.171.i113.i.i.i = fdiv contract double %.163.i112.i.i.i, %.147.i105.i.i.i
  br label %B576.if.i.i.i

B576.if.i.i.i:                                    ; preds = %B282.endif.endif.i107.i.i.i, %B174.endif.endif.i84.i.i.i, %B270.i98.i.i.i
  %.850.sroa.0.0.i.i.i = phi double [ 0x7FF8000000000000, %B270.i98.i.i.i ], [ %.105.i87.i.i.i, %B174.endif.endif.i84.i.i.i ], [ %.159.i110.i.i.i, %B282.endif.endif.i107.i.i.i ]
  %.850.sroa.4.0.i.i.i = phi double [ 0x7FF8000000000000, %B270.i98.i.i.i ], [ %.117.i90.i.i.i, %B174.endif.endif.i84.i.i.i ], [ %.171.i113.i.i.i, %B282.endif.endif.i107.i.i.i ]
  %.1169.i.i.i = load double, ptr %arg.state.10.0.4, align 8, !noalias !72
  %.1171.i.i.i = load double, ptr %.80.i1.i.i.i, align 8, !noalias !72
  %.58.i117.i.i.i = fmul contract double %.850.sroa.4.0.i.i.i, %.1169.i.i.i
  %.64.i118.i.i.i = fmul contract double %.850.sroa.0.0.i.i.i, %.1171.i.i.i
  %.80.i119.i.i.i = fadd contract double %.58.i117.i.i.i, %.64.i118.i.i.i
  %.46.i120.i.i.i = fmul contract double %.850.sroa.0.0.i.i.i, %.1169.i.i.i
  %.52.i121.i.i.i = fmul contract double %.850.sroa.4.0.i.i.i, %.1171.i.i.i
  %.70.i122.i.i.i = fsub contract double %.46.i120.i.i.i, %.52.i121.i.i.i
  store double %.70.i122.i.i.i, ptr %arg.state.10.0.4, align 8, !noalias !72
  store double %.80.i119.i.i.i, ptr %.80.i1.i.i.i, align 8, !noalias !72
  %.1169.1141.i.i.i = load double, ptr %sunkaddr173.i.i.i, align 8, !noalias !72
  %.1171.1143.i.i.i = load double, ptr %sunkaddr175.i.i.i, align 8, !noalias !72
  %.58.i117.1.i.i.i = fmul contract double %.850.sroa.4.0.i.i.i, %.1169.1141.i.i.i
  %.64.i118.1.i.i.i = fmul contract double %.850.sroa.0.0.i.i.i, %.1171.1143.i.i.i
  %.80.i119.1.i.i.i = fadd contract double %.58.i117.1.i.i.i, %.64.i118.1.i.i.i
  %.46.i120.1.i.i.i = fmul contract double %.850.sroa.0.0.i.i.i, %.1169.1141.i.i.i
  %.52.i121.1.i.i.i = fmul contract double %.850.sroa.4.0.i.i.i, %.1171.1143.i.i.i
  %.70.i122.1.i.i.i = fsub contract double %.46.i120.1.i.i.i, %.52.i121.1.i.i.i
  store double %.70.i122.1.i.i.i, ptr %sunkaddr173.i.i.i, align 8, !noalias !72
  store double %.80.i119.1.i.i.i, ptr %sunkaddr175.i.i.i, align 8, !noalias !72
  %.1169.116.i.i.i = load double, ptr %.222.i.i.i.i, align 8, !noalias !72
  %.1171.117.i.i.i = load double, ptr %.225.i.i.i.i, align 8, !noalias !72
  %.58.i117.118.i.i.i = fmul contract double %.850.sroa.4.0.i.i.i, %.1169.116.i.i.i
  %.64.i118.119.i.i.i = fmul contract double %.850.sroa.0.0.i.i.i, %.1171.117.i.i.i
  %.80.i119.120.i.i.i = fadd contract double %.58.i117.118.i.i.i, %.64.i118.119.i.i.i
  %.46.i120.121.i.i.i = fmul contract double %.850.sroa.0.0.i.i.i, %.1169.116.i.i.i
  %.52.i121.122.i.i.i = fmul contract double %.850.sroa.4.0.i.i.i, %.1171.117.i.i.i
  %.70.i122.123.i.i.i = fsub contract double %.46.i120.121.i.i.i, %.52.i121.122.i.i.i
  store double %.70.i122.123.i.i.i, ptr %.222.i.i.i.i, align 8, !noalias !72
  store double %.80.i119.120.i.i.i, ptr %.225.i.i.i.i, align 8, !noalias !72
  %.1169.1141.1.i.i.i = load double, ptr %.445.i.i.i.i, align 8, !noalias !72
  %.1171.1143.1.i.i.i = load double, ptr %.448.i.i.i.i, align 8, !noalias !72
  %.58.i117.1.1.i.i.i = fmul contract double %.850.sroa.4.0.i.i.i, %.1169.1141.1.i.i.i
  %.64.i118.1.1.i.i.i = fmul contract double %.850.sroa.0.0.i.i.i, %.1171.1143.1.i.i.i
  %.80.i119.1.1.i.i.i = fadd contract double %.58.i117.1.1.i.i.i, %.64.i118.1.1.i.i.i
  %.46.i120.1.1.i.i.i = fmul contract double %.850.sroa.0.0.i.i.i, %.1169.1141.1.i.i.i
  %.52.i121.1.1.i.i.i = fmul contract double %.850.sroa.4.0.i.i.i, %.1171.1143.1.i.i.i
  %.70.i122.1.1.i.i.i = fsub contract double %.46.i120.1.1.i.i.i, %.52.i121.1.1.i.i.i
  store double %.70.i122.1.1.i.i.i, ptr %.445.i.i.i.i, align 8, !noalias !72
  store double %.80.i119.1.1.i.i.i, ptr %.448.i.i.i.i, align 8, !noalias !72
  %.1169.225.i.i.i = load double, ptr %.588.i.i.i.i, align 8, !noalias !72
  %.1171.226.i.i.i = load double, ptr %.591.i.i.i.i, align 8, !noalias !72
  %.58.i117.2.i.i.i = fmul contract double %.850.sroa.4.0.i.i.i, %.1169.225.i.i.i
  %.64.i118.2.i.i.i = fmul contract double %.850.sroa.0.0.i.i.i, %.1171.226.i.i.i
  %.80.i119.2.i.i.i = fadd contract double %.58.i117.2.i.i.i, %.64.i118.2.i.i.i
  %.46.i120.2.i.i.i = fmul contract double %.850.sroa.0.0.i.i.i, %.1169.225.i.i.i
  %.52.i121.2.i.i.i = fmul contract double %.850.sroa.4.0.i.i.i, %.1171.226.i.i.i
  %.70.i122.2.i.i.i = fsub contract double %.46.i120.2.i.i.i, %.52.i121.2.i.i.i
  store double %.70.i122.2.i.i.i, ptr %.588.i.i.i.i, align 8, !noalias !72
  store double %.80.i119.2.i.i.i, ptr %.591.i.i.i.i, align 8, !noalias !72
  %.1169.1141.2.i.i.i = load double, ptr %sunkaddr173.2.i.i.i, align 8, !noalias !72
  %.1171.1143.2.i.i.i = load double, ptr %sunkaddr175.2.i.i.i, align 8, !noalias !72
  %.58.i117.1.2.i.i.i = fmul contract double %.850.sroa.4.0.i.i.i, %.1169.1141.2.i.i.i
  %.64.i118.1.2.i.i.i = fmul contract double %.850.sroa.0.0.i.i.i, %.1171.1143.2.i.i.i
  %.80.i119.1.2.i.i.i = fadd contract double %.58.i117.1.2.i.i.i, %.64.i118.1.2.i.i.i
  %.46.i120.1.2.i.i.i = fmul contract double %.850.sroa.0.0.i.i.i, %.1169.1141.2.i.i.i
  %.52.i121.1.2.i.i.i = fmul contract double %.850.sroa.4.0.i.i.i, %.1171.1143.2.i.i.i
  %.70.i122.1.2.i.i.i = fsub contract double %.46.i120.1.2.i.i.i, %.52.i121.1.2.i.i.i
  store double %.70.i122.1.2.i.i.i, ptr %sunkaddr173.2.i.i.i, align 8, !noalias !72
  store double %.80.i119.1.2.i.i.i, ptr %sunkaddr175.2.i.i.i, align 8, !noalias !72
  %.1169.3.i.i.i = load double, ptr %.1111.i.i.i.i, align 8, !noalias !72
  %.1171.3.i.i.i = load double, ptr %.1114.i.i.i.i, align 8, !noalias !72
  %.58.i117.3.i.i.i = fmul contract double %.850.sroa.4.0.i.i.i, %.1169.3.i.i.i
  %.64.i118.3.i.i.i = fmul contract double %.850.sroa.0.0.i.i.i, %.1171.3.i.i.i
  %.80.i119.3.i.i.i = fadd contract double %.58.i117.3.i.i.i, %.64.i118.3.i.i.i
  %.46.i120.3.i.i.i = fmul contract double %.850.sroa.0.0.i.i.i, %.1169.3.i.i.i
  %.52.i121.3.i.i.i = fmul contract double %.850.sroa.4.0.i.i.i, %.1171.3.i.i.i
  %.70.i122.3.i.i.i = fsub contract double %.46.i120.3.i.i.i, %.52.i121.3.i.i.i
  store double %.70.i122.3.i.i.i, ptr %.1111.i.i.i.i, align 8, !noalias !72
  store double %.80.i119.3.i.i.i, ptr %.1114.i.i.i.i, align 8, !noalias !72
  %.1169.1141.3.i.i.i = load double, ptr %.1645.i.i.i.i, align 8, !noalias !72
  %.1171.1143.3.i.i.i = load double, ptr %.1648.i.i.i.i, align 8, !noalias !72
  %.58.i117.1.3.i.i.i = fmul contract double %.850.sroa.4.0.i.i.i, %.1169.1141.3.i.i.i
  %.64.i118.1.3.i.i.i = fmul contract double %.850.sroa.0.0.i.i.i, %.1171.1143.3.i.i.i
  %.80.i119.1.3.i.i.i = fadd contract double %.58.i117.1.3.i.i.i, %.64.i118.1.3.i.i.i
  %.46.i120.1.3.i.i.i = fmul contract double %.850.sroa.0.0.i.i.i, %.1169.1141.3.i.i.i
  %.52.i121.1.3.i.i.i = fmul contract double %.850.sroa.4.0.i.i.i, %.1171.1143.3.i.i.i
  %.70.i122.1.3.i.i.i = fsub contract double %.46.i120.1.3.i.i.i, %.52.i121.1.3.i.i.i
  store double %.70.i122.1.3.i.i.i, ptr %.1645.i.i.i.i, align 8, !noalias !72
  store double %.80.i119.1.3.i.i.i, ptr %.1648.i.i.i.i, align 8, !noalias !72
  %.1169.4.i.i.i = load double, ptr %sunkaddr.4.i.i.i, align 8, !noalias !72
  %.1171.4.i.i.i = load double, ptr %sunkaddr171.4.i.i.i, align 8, !noalias !72
  %.58.i117.4.i.i.i = fmul contract double %.850.sroa.4.0.i.i.i, %.1169.4.i.i.i
  %.64.i118.4.i.i.i = fmul contract double %.850.sroa.0.0.i.i.i, %.1171.4.i.i.i
  %.80.i119.4.i.i.i = fadd contract double %.58.i117.4.i.i.i, %.64.i118.4.i.i.i
  %.46.i120.4.i.i.i = fmul contract double %.850.sroa.0.0.i.i.i, %.1169.4.i.i.i
  %.52.i121.4.i.i.i = fmul contract double %.850.sroa.4.0.i.i.i, %.1171.4.i.i.i
  %.70.i122.4.i.i.i = fsub contract double %.46.i120.4.i.i.i, %.52.i121.4.i.i.i
  store double %.70.i122.4.i.i.i, ptr %sunkaddr.4.i.i.i, align 8, !noalias !72
  store double %.80.i119.4.i.i.i, ptr %sunkaddr171.4.i.i.i, align 8, !noalias !72
  %.1169.1141.4.i.i.i = load double, ptr %.2656.i.i.i.i, align 8, !noalias !72
  %.1171.1143.4.i.i.i = load double, ptr %.2659.i.i.i.i, align 8, !noalias !72
  %.58.i117.1.4.i.i.i = fmul contract double %.850.sroa.4.0.i.i.i, %.1169.1141.4.i.i.i
  %.64.i118.1.4.i.i.i = fmul contract double %.850.sroa.0.0.i.i.i, %.1171.1143.4.i.i.i
  %.80.i119.1.4.i.i.i = fadd contract double %.58.i117.1.4.i.i.i, %.64.i118.1.4.i.i.i
  %.46.i120.1.4.i.i.i = fmul contract double %.850.sroa.0.0.i.i.i, %.1169.1141.4.i.i.i
  %.52.i121.1.4.i.i.i = fmul contract double %.850.sroa.4.0.i.i.i, %.1171.1143.4.i.i.i
  %.70.i122.1.4.i.i.i = fsub contract double %.46.i120.1.4.i.i.i, %.52.i121.1.4.i.i.i
  store double %.70.i122.1.4.i.i.i, ptr %.2656.i.i.i.i, align 8, !noalias !72
  store double %.80.i119.1.4.i.i.i, ptr %.2659.i.i.i.i, align 8, !noalias !72
  %.1169.5.i.i.i = load double, ptr %.3494.i.i.i.i, align 8, !noalias !72
  %.1171.5.i.i.i = load double, ptr %.3497.i.i.i.i, align 8, !noalias !72
  %.58.i117.5.i.i.i = fmul contract double %.850.sroa.4.0.i.i.i, %.1169.5.i.i.i
  %.64.i118.5.i.i.i = fmul contract double %.850.sroa.0.0.i.i.i, %.1171.5.i.i.i
  %.80.i119.5.i.i.i = fadd contract double %.58.i117.5.i.i.i, %.64.i118.5.i.i.i
  %.46.i120.5.i.i.i = fmul contract double %.850.sroa.0.0.i.i.i, %.1169.5.i.i.i
  %.52.i121.5.i.i.i = fmul contract double %.850.sroa.4.0.i.i.i, %.1171.5.i.i.i
  %.70.i122.5.i.i.i = fsub contract double %.46.i120.5.i.i.i, %.52.i121.5.i.i.i
  store double %.70.i122.5.i.i.i, ptr %.3494.i.i.i.i, align 8, !noalias !72
  store double %.80.i119.5.i.i.i, ptr %.3497.i.i.i.i, align 8, !noalias !72
  %.1169.1141.5.i.i.i = load double, ptr %.4475.i.i.i.i, align 8, !noalias !72
  %.1171.1143.5.i.i.i = load double, ptr %.4478.i.i.i.i, align 8, !noalias !72
  %.58.i117.1.5.i.i.i = fmul contract double %.850.sroa.4.0.i.i.i, %.1169.1141.5.i.i.i
  %.64.i118.1.5.i.i.i = fmul contract double %.850.sroa.0.0.i.i.i, %.1171.1143.5.i.i.i
  %.80.i119.1.5.i.i.i = fadd contract double %.58.i117.1.5.i.i.i, %.64.i118.1.5.i.i.i
  %.46.i120.1.5.i.i.i = fmul contract double %.850.sroa.0.0.i.i.i, %.1169.1141.5.i.i.i
  %.52.i121.1.5.i.i.i = fmul contract double %.850.sroa.4.0.i.i.i, %.1171.1143.5.i.i.i
  %.70.i122.1.5.i.i.i = fsub contract double %.46.i120.1.5.i.i.i, %.52.i121.1.5.i.i.i
  store double %.70.i122.1.5.i.i.i, ptr %.4475.i.i.i.i, align 8, !noalias !72
  store double %.80.i119.1.5.i.i.i, ptr %.4478.i.i.i.i, align 8, !noalias !72
  %.1169.6.i.i.i = load double, ptr %sunkaddr.6.i.i.i, align 8, !noalias !72
  %.1171.6.i.i.i = load double, ptr %sunkaddr171.6.i.i.i, align 8, !noalias !72
  %.58.i117.6.i.i.i = fmul contract double %.850.sroa.4.0.i.i.i, %.1169.6.i.i.i
  %.64.i118.6.i.i.i = fmul contract double %.850.sroa.0.0.i.i.i, %.1171.6.i.i.i
  %.80.i119.6.i.i.i = fadd contract double %.58.i117.6.i.i.i, %.64.i118.6.i.i.i
  %.46.i120.6.i.i.i = fmul contract double %.850.sroa.0.0.i.i.i, %.1169.6.i.i.i
  %.52.i121.6.i.i.i = fmul contract double %.850.sroa.4.0.i.i.i, %.1171.6.i.i.i
  %.70.i122.6.i.i.i = fsub contract double %.46.i120.6.i.i.i, %.52.i121.6.i.i.i
  store double %.70.i122.6.i.i.i, ptr %sunkaddr.6.i.i.i, align 8, !noalias !72
  store double %.80.i119.6.i.i.i, ptr %sunkaddr171.6.i.i.i, align 8, !noalias !72
  %.1169.1141.6.i.i.i = load double, ptr %sunkaddr173.6.i.i.i, align 8, !noalias !72
  %.1171.1143.6.i.i.i = load double, ptr %sunkaddr175.6.i.i.i, align 8, !noalias !72
  %.58.i117.1.6.i.i.i = fmul contract double %.850.sroa.4.0.i.i.i, %.1169.1141.6.i.i.i
  %.64.i118.1.6.i.i.i = fmul contract double %.850.sroa.0.0.i.i.i, %.1171.1143.6.i.i.i
  %.80.i119.1.6.i.i.i = fadd contract double %.58.i117.1.6.i.i.i, %.64.i118.1.6.i.i.i
  %.46.i120.1.6.i.i.i = fmul contract double %.850.sroa.0.0.i.i.i, %.1169.1141.6.i.i.i
  %.52.i121.1.6.i.i.i = fmul contract double %.850.sroa.4.0.i.i.i, %.1171.1143.6.i.i.i
  %.70.i122.1.6.i.i.i = fsub contract double %.46.i120.1.6.i.i.i, %.52.i121.1.6.i.i.i
  store double %.70.i122.1.6.i.i.i, ptr %sunkaddr173.6.i.i.i, align 8, !noalias !72
  store double %.80.i119.1.6.i.i.i, ptr %sunkaddr175.6.i.i.i, align 8, !noalias !72
  %.1169.7.i.i.i = load double, ptr %sunkaddr.7.i.i.i, align 8, !noalias !72
  %.1171.7.i.i.i = load double, ptr %sunkaddr171.7.i.i.i, align 8, !noalias !72
  %.58.i117.7.i.i.i = fmul contract double %.850.sroa.4.0.i.i.i, %.1169.7.i.i.i
  %.64.i118.7.i.i.i = fmul contract double %.850.sroa.0.0.i.i.i, %.1171.7.i.i.i
  %.80.i119.7.i.i.i = fadd contract double %.58.i117.7.i.i.i, %.64.i118.7.i.i.i
  %.46.i120.7.i.i.i = fmul contract double %.850.sroa.0.0.i.i.i, %.1169.7.i.i.i
  %.52.i121.7.i.i.i = fmul contract double %.850.sroa.4.0.i.i.i, %.1171.7.i.i.i
  %.70.i122.7.i.i.i = fsub contract double %.46.i120.7.i.i.i, %.52.i121.7.i.i.i
  store double %.70.i122.7.i.i.i, ptr %sunkaddr.7.i.i.i, align 8, !noalias !72
  store double %.80.i119.7.i.i.i, ptr %sunkaddr171.7.i.i.i, align 8, !noalias !72
  %.1169.1141.7.i.i.i = load double, ptr %sunkaddr173.7.i.i.i, align 8, !noalias !72
  %.1171.1143.7.i.i.i = load double, ptr %sunkaddr175.7.i.i.i, align 8, !noalias !72
  %.58.i117.1.7.i.i.i = fmul contract double %.850.sroa.4.0.i.i.i, %.1169.1141.7.i.i.i
  %.64.i118.1.7.i.i.i = fmul contract double %.850.sroa.0.0.i.i.i, %.1171.1143.7.i.i.i
  %.80.i119.1.7.i.i.i = fadd contract double %.58.i117.1.7.i.i.i, %.64.i118.1.7.i.i.i
  %.46.i120.1.7.i.i.i = fmul contract double %.850.sroa.0.0.i.i.i, %.1169.1141.7.i.i.i
  %.52.i121.1.7.i.i.i = fmul contract double %.850.sroa.4.0.i.i.i, %.1171.1143.7.i.i.i
  %.70.i122.1.7.i.i.i = fsub contract double %.46.i120.1.7.i.i.i, %.52.i121.1.7.i.i.i
  store double %.70.i122.1.7.i.i.i, ptr %sunkaddr173.7.i.i.i, align 8, !noalias !72
  store double %.80.i119.1.7.i.i.i, ptr %sunkaddr175.7.i.i.i, align 8, !noalias !72
  %.1169.1.i.i.i = load double, ptr %32, align 8, !noalias !72
  %.1171.1.i.i.i = load double, ptr %scevgep160.i.i.i, align 8, !noalias !72
  %.58.i.i.i.i = fmul contract double %.850.sroa.4.0.i.i.i, %.1169.1.i.i.i
  %.64.i.i.i.i = fmul contract double %.850.sroa.0.0.i.i.i, %.1171.1.i.i.i
  %.80.i.i.i.i = fadd contract double %.58.i.i.i.i, %.64.i.i.i.i
  %.46.i.i.i.i = fmul contract double %.850.sroa.0.0.i.i.i, %.1169.1.i.i.i
  %.52.i.i.i.i = fmul contract double %.850.sroa.4.0.i.i.i, %.1171.1.i.i.i
  %.70.i.i.i.i = fsub contract double %.46.i.i.i.i, %.52.i.i.i.i
  store double %.70.i.i.i.i, ptr %32, align 8, !noalias !72
  store double %.80.i.i.i.i, ptr %scevgep160.i.i.i, align 8, !noalias !72
  %.1169.1.1.i.i.i = load double, ptr %scevgep157.i.i.i, align 8, !noalias !72
  %.1171.1.1.i.i.i = load double, ptr %scevgep152.i.i.i, align 8, !noalias !72
  %.58.i.1.i.i.i = fmul contract double %.850.sroa.4.0.i.i.i, %.1169.1.1.i.i.i
  %.64.i.1.i.i.i = fmul contract double %.850.sroa.0.0.i.i.i, %.1171.1.1.i.i.i
  %.80.i.1.i.i.i = fadd contract double %.58.i.1.i.i.i, %.64.i.1.i.i.i
  %.46.i.1.i.i.i = fmul contract double %.850.sroa.0.0.i.i.i, %.1169.1.1.i.i.i
  %.52.i.1.i.i.i = fmul contract double %.850.sroa.4.0.i.i.i, %.1171.1.1.i.i.i
  %.70.i.1.i.i.i = fsub contract double %.46.i.1.i.i.i, %.52.i.1.i.i.i
  store double %.70.i.1.i.i.i, ptr %scevgep157.i.i.i, align 8, !noalias !72
  store double %.80.i.1.i.i.i, ptr %scevgep152.i.i.i, align 8, !noalias !72
  %.1169.1.128.i.i.i = load double, ptr %scevgep159.1.i.i.i, align 8, !noalias !72
  %.1171.1.129.i.i.i = load double, ptr %scevgep160.1.i.i.i, align 8, !noalias !72
  %.58.i.130.i.i.i = fmul contract double %.850.sroa.4.0.i.i.i, %.1169.1.128.i.i.i
  %.64.i.131.i.i.i = fmul contract double %.850.sroa.0.0.i.i.i, %.1171.1.129.i.i.i
  %.80.i.132.i.i.i = fadd contract double %.58.i.130.i.i.i, %.64.i.131.i.i.i
  %.46.i.133.i.i.i = fmul contract double %.850.sroa.0.0.i.i.i, %.1169.1.128.i.i.i
  %.52.i.134.i.i.i = fmul contract double %.850.sroa.4.0.i.i.i, %.1171.1.129.i.i.i
  %.70.i.135.i.i.i = fsub contract double %.46.i.133.i.i.i, %.52.i.134.i.i.i
  store double %.70.i.135.i.i.i, ptr %scevgep159.1.i.i.i, align 8, !noalias !72
  store double %.80.i.132.i.i.i, ptr %scevgep160.1.i.i.i, align 8, !noalias !72
  %.1169.1.1.1.i.i.i = load double, ptr %scevgep157.1.i.i.i, align 8, !noalias !72
  %.1171.1.1.1.i.i.i = load double, ptr %scevgep158.1.i.i.i, align 8, !noalias !72
  %.58.i.1.1.i.i.i = fmul contract double %.850.sroa.4.0.i.i.i, %.1169.1.1.1.i.i.i
  %.64.i.1.1.i.i.i = fmul contract double %.850.sroa.0.0.i.i.i, %.1171.1.1.1.i.i.i
  %.80.i.1.1.i.i.i = fadd contract double %.58.i.1.1.i.i.i, %.64.i.1.1.i.i.i
  %.46.i.1.1.i.i.i = fmul contract double %.850.sroa.0.0.i.i.i, %.1169.1.1.1.i.i.i
  %.52.i.1.1.i.i.i = fmul contract double %.850.sroa.4.0.i.i.i, %.1171.1.1.1.i.i.i
  %.70.i.1.1.i.i.i = fsub contract double %.46.i.1.1.i.i.i, %.52.i.1.1.i.i.i
  store double %.70.i.1.1.i.i.i, ptr %scevgep157.1.i.i.i, align 8, !noalias !72
  store double %.80.i.1.1.i.i.i, ptr %scevgep158.1.i.i.i, align 8, !noalias !72
  %.1169.1.2.i.i.i = load double, ptr %scevgep159.2.i.i.i, align 8, !noalias !72
  %.1171.1.2.i.i.i = load double, ptr %scevgep160.2.i.i.i, align 8, !noalias !72
  %.58.i.2.i.i.i = fmul contract double %.850.sroa.4.0.i.i.i, %.1169.1.2.i.i.i
  %.64.i.2.i.i.i = fmul contract double %.850.sroa.0.0.i.i.i, %.1171.1.2.i.i.i
  %.80.i.2.i.i.i = fadd contract double %.58.i.2.i.i.i, %.64.i.2.i.i.i
  %.46.i.2.i.i.i = fmul contract double %.850.sroa.0.0.i.i.i, %.1169.1.2.i.i.i
  %.52.i.2.i.i.i = fmul contract double %.850.sroa.4.0.i.i.i, %.1171.1.2.i.i.i
  %.70.i.2.i.i.i = fsub contract double %.46.i.2.i.i.i, %.52.i.2.i.i.i
  store double %.70.i.2.i.i.i, ptr %scevgep159.2.i.i.i, align 8, !noalias !72
  store double %.80.i.2.i.i.i, ptr %scevgep160.2.i.i.i, align 8, !noalias !72
  %.1169.1.1.2.i.i.i = load double, ptr %.890.i.i.i.i, align 8, !noalias !72
  %.1171.1.1.2.i.i.i = load double, ptr %.893.i.i.i.i, align 8, !noalias !72
  %.58.i.1.2.i.i.i = fmul contract double %.850.sroa.4.0.i.i.i, %.1169.1.1.2.i.i.i
  %.64.i.1.2.i.i.i = fmul contract double %.850.sroa.0.0.i.i.i, %.1171.1.1.2.i.i.i
  %.80.i.1.2.i.i.i = fadd contract double %.58.i.1.2.i.i.i, %.64.i.1.2.i.i.i
  %.46.i.1.2.i.i.i = fmul contract double %.850.sroa.0.0.i.i.i, %.1169.1.1.2.i.i.i
  %.52.i.1.2.i.i.i = fmul contract double %.850.sroa.4.0.i.i.i, %.1171.1.1.2.i.i.i
  %.70.i.1.2.i.i.i = fsub contract double %.46.i.1.2.i.i.i, %.52.i.1.2.i.i.i
  store double %.70.i.1.2.i.i.i, ptr %.890.i.i.i.i, align 8, !noalias !72
  store double %.80.i.1.2.i.i.i, ptr %.893.i.i.i.i, align 8, !noalias !72
  %.1169.1.3.i.i.i = load double, ptr %.1502.i.i.i.i, align 8, !noalias !72
  %.1171.1.3.i.i.i = load double, ptr %.1505.i.i.i.i, align 8, !noalias !72
  %.58.i.3.i.i.i = fmul contract double %.850.sroa.4.0.i.i.i, %.1169.1.3.i.i.i
  %.64.i.3.i.i.i = fmul contract double %.850.sroa.0.0.i.i.i, %.1171.1.3.i.i.i
  %.80.i.3.i.i.i = fadd contract double %.58.i.3.i.i.i, %.64.i.3.i.i.i
  %.46.i.3.i.i.i = fmul contract double %.850.sroa.0.0.i.i.i, %.1169.1.3.i.i.i
  %.52.i.3.i.i.i = fmul contract double %.850.sroa.4.0.i.i.i, %.1171.1.3.i.i.i
  %.70.i.3.i.i.i = fsub contract double %.46.i.3.i.i.i, %.52.i.3.i.i.i
  store double %.70.i.3.i.i.i, ptr %.1502.i.i.i.i, align 8, !noalias !72
  store double %.80.i.3.i.i.i, ptr %.1505.i.i.i.i, align 8, !noalias !72
  %.1169.1.1.3.i.i.i = load double, ptr %scevgep157.3.i.i.i, align 8, !noalias !72
  %.1171.1.1.3.i.i.i = load double, ptr %scevgep158.3.i.i.i, align 8, !noalias !72
  %.58.i.1.3.i.i.i = fmul contract double %.850.sroa.4.0.i.i.i, %.1169.1.1.3.i.i.i
  %.64.i.1.3.i.i.i = fmul contract double %.850.sroa.0.0.i.i.i, %.1171.1.1.3.i.i.i
  %.80.i.1.3.i.i.i = fadd contract double %.58.i.1.3.i.i.i, %.64.i.1.3.i.i.i
  %.46.i.1.3.i.i.i = fmul contract double %.850.sroa.0.0.i.i.i, %.1169.1.1.3.i.i.i
  %.52.i.1.3.i.i.i = fmul contract double %.850.sroa.4.0.i.i.i, %.1171.1.1.3.i.i.i
  %.70.i.1.3.i.i.i = fsub contract double %.46.i.1.3.i.i.i, %.52.i.1.3.i.i.i
  store double %.70.i.1.3.i.i.i, ptr %scevgep157.3.i.i.i, align 8, !noalias !72
  store double %.80.i.1.3.i.i.i, ptr %scevgep158.3.i.i.i, align 8, !noalias !72
  %.1169.1.4.i.i.i = load double, ptr %.1947.i.i.i.i, align 8, !noalias !72
  %.1171.1.4.i.i.i = load double, ptr %.1950.i.i.i.i, align 8, !noalias !72
  %.58.i.4.i.i.i = fmul contract double %.850.sroa.4.0.i.i.i, %.1169.1.4.i.i.i
  %.64.i.4.i.i.i = fmul contract double %.850.sroa.0.0.i.i.i, %.1171.1.4.i.i.i
  %.80.i.4.i.i.i = fadd contract double %.58.i.4.i.i.i, %.64.i.4.i.i.i
  %.46.i.4.i.i.i = fmul contract double %.850.sroa.0.0.i.i.i, %.1169.1.4.i.i.i
  %.52.i.4.i.i.i = fmul contract double %.850.sroa.4.0.i.i.i, %.1171.1.4.i.i.i
  %.70.i.4.i.i.i = fsub contract double %.46.i.4.i.i.i, %.52.i.4.i.i.i
  store double %.70.i.4.i.i.i, ptr %.1947.i.i.i.i, align 8, !noalias !72
  store double %.80.i.4.i.i.i, ptr %.1950.i.i.i.i, align 8, !noalias !72
  %.1169.1.1.4.i.i.i = load double, ptr %.3047.i.i.i.i, align 8, !noalias !72
  %.1171.1.1.4.i.i.i = load double, ptr %.3050.i.i.i.i, align 8, !noalias !72
  %.58.i.1.4.i.i.i = fmul contract double %.850.sroa.4.0.i.i.i, %.1169.1.1.4.i.i.i
  %.64.i.1.4.i.i.i = fmul contract double %.850.sroa.0.0.i.i.i, %.1171.1.1.4.i.i.i
  %.80.i.1.4.i.i.i = fadd contract double %.58.i.1.4.i.i.i, %.64.i.1.4.i.i.i
  %.46.i.1.4.i.i.i = fmul contract double %.850.sroa.0.0.i.i.i, %.1169.1.1.4.i.i.i
  %.52.i.1.4.i.i.i = fmul contract double %.850.sroa.4.0.i.i.i, %.1171.1.1.4.i.i.i
  %.70.i.1.4.i.i.i = fsub contract double %.46.i.1.4.i.i.i, %.52.i.1.4.i.i.i
  store double %.70.i.1.4.i.i.i, ptr %.3047.i.i.i.i, align 8, !noalias !72
  store double %.80.i.1.4.i.i.i, ptr %.3050.i.i.i.i, align 8, !noalias !72
  %.1169.1.5.i.i.i = load double, ptr %.4246.i.i.i.i, align 8, !noalias !72
  %.1171.1.5.i.i.i = load double, ptr %.4249.i.i.i.i, align 8, !noalias !72
  %.58.i.5.i.i.i = fmul contract double %.850.sroa.4.0.i.i.i, %.1169.1.5.i.i.i
  %.64.i.5.i.i.i = fmul contract double %.850.sroa.0.0.i.i.i, %.1171.1.5.i.i.i
  %.80.i.5.i.i.i = fadd contract double %.58.i.5.i.i.i, %.64.i.5.i.i.i
  %.46.i.5.i.i.i = fmul contract double %.850.sroa.0.0.i.i.i, %.1169.1.5.i.i.i
  %.52.i.5.i.i.i = fmul contract double %.850.sroa.4.0.i.i.i, %.1171.1.5.i.i.i
  %.70.i.5.i.i.i = fsub contract double %.46.i.5.i.i.i, %.52.i.5.i.i.i
  store double %.70.i.5.i.i.i, ptr %.4246.i.i.i.i, align 8, !noalias !72
  store double %.80.i.5.i.i.i, ptr %.4249.i.i.i.i, align 8, !noalias !72
  %.1169.1.1.5.i.i.i = load double, ptr %.4963.i.i.i.i, align 8, !noalias !72
  %.1171.1.1.5.i.i.i = load double, ptr %.4966.i.i.i.i, align 8, !noalias !72
  %.58.i.1.5.i.i.i = fmul contract double %.850.sroa.4.0.i.i.i, %.1169.1.1.5.i.i.i
  %.64.i.1.5.i.i.i = fmul contract double %.850.sroa.0.0.i.i.i, %.1171.1.1.5.i.i.i
  %.80.i.1.5.i.i.i = fadd contract double %.58.i.1.5.i.i.i, %.64.i.1.5.i.i.i
  %.46.i.1.5.i.i.i = fmul contract double %.850.sroa.0.0.i.i.i, %.1169.1.1.5.i.i.i
  %.52.i.1.5.i.i.i = fmul contract double %.850.sroa.4.0.i.i.i, %.1171.1.1.5.i.i.i
  %.70.i.1.5.i.i.i = fsub contract double %.46.i.1.5.i.i.i, %.52.i.1.5.i.i.i
  store double %.70.i.1.5.i.i.i, ptr %.4963.i.i.i.i, align 8, !noalias !72
  store double %.80.i.1.5.i.i.i, ptr %.4966.i.i.i.i, align 8, !noalias !72
  %.1169.1.6.i.i.i = load double, ptr %scevgep159.6.i.i.i, align 8, !noalias !72
  %.1171.1.6.i.i.i = load double, ptr %scevgep160.6.i.i.i, align 8, !noalias !72
  %.58.i.6.i.i.i = fmul contract double %.850.sroa.4.0.i.i.i, %.1169.1.6.i.i.i
  %.64.i.6.i.i.i = fmul contract double %.850.sroa.0.0.i.i.i, %.1171.1.6.i.i.i
  %.80.i.6.i.i.i = fadd contract double %.58.i.6.i.i.i, %.64.i.6.i.i.i
  %.46.i.6.i.i.i = fmul contract double %.850.sroa.0.0.i.i.i, %.1169.1.6.i.i.i
  %.52.i.6.i.i.i = fmul contract double %.850.sroa.4.0.i.i.i, %.1171.1.6.i.i.i
  %.70.i.6.i.i.i = fsub contract double %.46.i.6.i.i.i, %.52.i.6.i.i.i
  store double %.70.i.6.i.i.i, ptr %scevgep159.6.i.i.i, align 8, !noalias !72
  store double %.80.i.6.i.i.i, ptr %scevgep160.6.i.i.i, align 8, !noalias !72
  %.1169.1.1.6.i.i.i = load double, ptr %scevgep157.6.i.i.i, align 8, !noalias !72
  %.1171.1.1.6.i.i.i = load double, ptr %scevgep158.6.i.i.i, align 8, !noalias !72
  %.58.i.1.6.i.i.i = fmul contract double %.850.sroa.4.0.i.i.i, %.1169.1.1.6.i.i.i
  %.64.i.1.6.i.i.i = fmul contract double %.850.sroa.0.0.i.i.i, %.1171.1.1.6.i.i.i
  %.80.i.1.6.i.i.i = fadd contract double %.58.i.1.6.i.i.i, %.64.i.1.6.i.i.i
  %.46.i.1.6.i.i.i = fmul contract double %.850.sroa.0.0.i.i.i, %.1169.1.1.6.i.i.i
  %.52.i.1.6.i.i.i = fmul contract double %.850.sroa.4.0.i.i.i, %.1171.1.1.6.i.i.i
  %.70.i.1.6.i.i.i = fsub contract double %.46.i.1.6.i.i.i, %.52.i.1.6.i.i.i
  store double %.70.i.1.6.i.i.i, ptr %scevgep157.6.i.i.i, align 8, !noalias !72
  store double %.80.i.1.6.i.i.i, ptr %scevgep158.6.i.i.i, align 8, !noalias !72
  %.1169.1.7.i.i.i = load double, ptr %scevgep159.7.i.i.i, align 8, !noalias !72
  %.1171.1.7.i.i.i = load double, ptr %scevgep160.7.i.i.i, align 8, !noalias !72
  %.58.i.7.i.i.i = fmul contract double %.850.sroa.4.0.i.i.i, %.1169.1.7.i.i.i
  %.64.i.7.i.i.i = fmul contract double %.850.sroa.0.0.i.i.i, %.1171.1.7.i.i.i
  %.80.i.7.i.i.i = fadd contract double %.58.i.7.i.i.i, %.64.i.7.i.i.i
  %.46.i.7.i.i.i = fmul contract double %.850.sroa.0.0.i.i.i, %.1169.1.7.i.i.i
  %.52.i.7.i.i.i = fmul contract double %.850.sroa.4.0.i.i.i, %.1171.1.7.i.i.i
  %.70.i.7.i.i.i = fsub contract double %.46.i.7.i.i.i, %.52.i.7.i.i.i
  store double %.70.i.7.i.i.i, ptr %scevgep159.7.i.i.i, align 8, !noalias !72
  store double %.80.i.7.i.i.i, ptr %scevgep160.7.i.i.i, align 8, !noalias !72
  %.1169.1.1.7.i.i.i = load double, ptr %scevgep157.7.i.i.i, align 8, !noalias !72
  %.1171.1.1.7.i.i.i = load double, ptr %scevgep158.7.i.i.i, align 8, !noalias !72
  %.58.i.1.7.i.i.i = fmul contract double %.850.sroa.4.0.i.i.i, %.1169.1.1.7.i.i.i
  %.64.i.1.7.i.i.i = fmul contract double %.850.sroa.0.0.i.i.i, %.1171.1.1.7.i.i.i
  %.80.i.1.7.i.i.i = fadd contract double %.58.i.1.7.i.i.i, %.64.i.1.7.i.i.i
  %.46.i.1.7.i.i.i = fmul contract double %.850.sroa.0.0.i.i.i, %.1169.1.1.7.i.i.i
  %.52.i.1.7.i.i.i = fmul contract double %.850.sroa.4.0.i.i.i, %.1171.1.1.7.i.i.i
  %.70.i.1.7.i.i.i = fsub contract double %.46.i.1.7.i.i.i, %.52.i.1.7.i.i.i
  store double %.70.i.1.7.i.i.i, ptr %scevgep157.7.i.i.i, align 8, !noalias !72
  store double %.80.i.1.7.i.i.i, ptr %scevgep158.7.i.i.i, align 8, !noalias !72
  %.1169.2.i.i.i = load double, ptr %33, align 8, !noalias !72
  %.1171.2.i.i.i = load double, ptr %scevgep151.i.i.i, align 8, !noalias !72
  %.58.i10.i.i.i = fmul contract double %.850.sroa.4.0.i.i.i, %.1169.2.i.i.i
  %.64.i11.i.i.i = fmul contract double %.850.sroa.0.0.i.i.i, %.1171.2.i.i.i
  %.80.i12.i.i.i = fadd contract double %.58.i10.i.i.i, %.64.i11.i.i.i
  %.46.i13.i.i.i = fmul contract double %.850.sroa.0.0.i.i.i, %.1169.2.i.i.i
  %.52.i14.i.i.i = fmul contract double %.850.sroa.4.0.i.i.i, %.1171.2.i.i.i
  %.70.i15.i.i.i = fsub contract double %.46.i13.i.i.i, %.52.i14.i.i.i
  store double %.70.i15.i.i.i, ptr %33, align 8, !noalias !72
  store double %.80.i12.i.i.i, ptr %scevgep151.i.i.i, align 8, !noalias !72
  %.1169.2.1.i.i.i = load double, ptr %scevgep148.i.i.i, align 8, !noalias !72
  %.1171.2.1.i.i.i = load double, ptr %scevgep.i.i.i, align 8, !noalias !72
  %.58.i10.1.i.i.i = fmul contract double %.850.sroa.4.0.i.i.i, %.1169.2.1.i.i.i
  %.64.i11.1.i.i.i = fmul contract double %.850.sroa.0.0.i.i.i, %.1171.2.1.i.i.i
  %.80.i12.1.i.i.i = fadd contract double %.58.i10.1.i.i.i, %.64.i11.1.i.i.i
  %.46.i13.1.i.i.i = fmul contract double %.850.sroa.0.0.i.i.i, %.1169.2.1.i.i.i
  %.52.i14.1.i.i.i = fmul contract double %.850.sroa.4.0.i.i.i, %.1171.2.1.i.i.i
  %.70.i15.1.i.i.i = fsub contract double %.46.i13.1.i.i.i, %.52.i14.1.i.i.i
  store double %.70.i15.1.i.i.i, ptr %scevgep148.i.i.i, align 8, !noalias !72
  store double %.80.i12.1.i.i.i, ptr %scevgep.i.i.i, align 8, !noalias !72
  %.1169.2.136.i.i.i = load double, ptr %scevgep150.1.i.i.i, align 8, !noalias !72
  %.1171.2.137.i.i.i = load double, ptr %scevgep151.1.i.i.i, align 8, !noalias !72
  %.58.i10.138.i.i.i = fmul contract double %.850.sroa.4.0.i.i.i, %.1169.2.136.i.i.i
  %.64.i11.139.i.i.i = fmul contract double %.850.sroa.0.0.i.i.i, %.1171.2.137.i.i.i
  %.80.i12.140.i.i.i = fadd contract double %.58.i10.138.i.i.i, %.64.i11.139.i.i.i
  %.46.i13.141.i.i.i = fmul contract double %.850.sroa.0.0.i.i.i, %.1169.2.136.i.i.i
  %.52.i14.142.i.i.i = fmul contract double %.850.sroa.4.0.i.i.i, %.1171.2.137.i.i.i
  %.70.i15.143.i.i.i = fsub contract double %.46.i13.141.i.i.i, %.52.i14.142.i.i.i
  store double %.70.i15.143.i.i.i, ptr %scevgep150.1.i.i.i, align 8, !noalias !72
  store double %.80.i12.140.i.i.i, ptr %scevgep151.1.i.i.i, align 8, !noalias !72
  %.1169.2.1.1.i.i.i = load double, ptr %scevgep148.1.i.i.i, align 8, !noalias !72
  %.1171.2.1.1.i.i.i = load double, ptr %scevgep149.1.i.i.i, align 8, !noalias !72
  %.58.i10.1.1.i.i.i = fmul contract double %.850.sroa.4.0.i.i.i, %.1169.2.1.1.i.i.i
  %.64.i11.1.1.i.i.i = fmul contract double %.850.sroa.0.0.i.i.i, %.1171.2.1.1.i.i.i
  %.80.i12.1.1.i.i.i = fadd contract double %.58.i10.1.1.i.i.i, %.64.i11.1.1.i.i.i
  %.46.i13.1.1.i.i.i = fmul contract double %.850.sroa.0.0.i.i.i, %.1169.2.1.1.i.i.i
  %.52.i14.1.1.i.i.i = fmul contract double %.850.sroa.4.0.i.i.i, %.1171.2.1.1.i.i.i
  %.70.i15.1.1.i.i.i = fsub contract double %.46.i13.1.1.i.i.i, %.52.i14.1.1.i.i.i
  store double %.70.i15.1.1.i.i.i, ptr %scevgep148.1.i.i.i, align 8, !noalias !72
  store double %.80.i12.1.1.i.i.i, ptr %scevgep149.1.i.i.i, align 8, !noalias !72
  %.1169.2.2.i.i.i = load double, ptr %scevgep150.2.i.i.i, align 8, !noalias !72
  %.1171.2.2.i.i.i = load double, ptr %scevgep151.2.i.i.i, align 8, !noalias !72
  %.58.i10.2.i.i.i = fmul contract double %.850.sroa.4.0.i.i.i, %.1169.2.2.i.i.i
  %.64.i11.2.i.i.i = fmul contract double %.850.sroa.0.0.i.i.i, %.1171.2.2.i.i.i
  %.80.i12.2.i.i.i = fadd contract double %.58.i10.2.i.i.i, %.64.i11.2.i.i.i
  %.46.i13.2.i.i.i = fmul contract double %.850.sroa.0.0.i.i.i, %.1169.2.2.i.i.i
  %.52.i14.2.i.i.i = fmul contract double %.850.sroa.4.0.i.i.i, %.1171.2.2.i.i.i
  %.70.i15.2.i.i.i = fsub contract double %.46.i13.2.i.i.i, %.52.i14.2.i.i.i
  store double %.70.i15.2.i.i.i, ptr %scevgep150.2.i.i.i, align 8, !noalias !72
  store double %.80.i12.2.i.i.i, ptr %scevgep151.2.i.i.i, align 8, !noalias !72
  %.1169.2.1.2.i.i.i = load double, ptr %scevgep148.2.i.i.i, align 8, !noalias !72
  %.1171.2.1.2.i.i.i = load double, ptr %scevgep149.2.i.i.i, align 8, !noalias !72
  %.58.i10.1.2.i.i.i = fmul contract double %.850.sroa.4.0.i.i.i, %.1169.2.1.2.i.i.i
  %.64.i11.1.2.i.i.i = fmul contract double %.850.sroa.0.0.i.i.i, %.1171.2.1.2.i.i.i
  %.80.i12.1.2.i.i.i = fadd contract double %.58.i10.1.2.i.i.i, %.64.i11.1.2.i.i.i
  %.46.i13.1.2.i.i.i = fmul contract double %.850.sroa.0.0.i.i.i, %.1169.2.1.2.i.i.i
  %.52.i14.1.2.i.i.i = fmul contract double %.850.sroa.4.0.i.i.i, %.1171.2.1.2.i.i.i
  %.70.i15.1.2.i.i.i = fsub contract double %.46.i13.1.2.i.i.i, %.52.i14.1.2.i.i.i
  store double %.70.i15.1.2.i.i.i, ptr %scevgep148.2.i.i.i, align 8, !noalias !72
  store double %.80.i12.1.2.i.i.i, ptr %scevgep149.2.i.i.i, align 8, !noalias !72
  %.1169.2.3.i.i.i = load double, ptr %scevgep150.3.i.i.i, align 8, !noalias !72
  %.1171.2.3.i.i.i = load double, ptr %scevgep151.3.i.i.i, align 8, !noalias !72
  %.58.i10.3.i.i.i = fmul contract double %.850.sroa.4.0.i.i.i, %.1169.2.3.i.i.i
  %.64.i11.3.i.i.i = fmul contract double %.850.sroa.0.0.i.i.i, %.1171.2.3.i.i.i
  %.80.i12.3.i.i.i = fadd contract double %.58.i10.3.i.i.i, %.64.i11.3.i.i.i
  %.46.i13.3.i.i.i = fmul contract double %.850.sroa.0.0.i.i.i, %.1169.2.3.i.i.i
  %.52.i14.3.i.i.i = fmul contract double %.850.sroa.4.0.i.i.i, %.1171.2.3.i.i.i
  %.70.i15.3.i.i.i = fsub contract double %.46.i13.3.i.i.i, %.52.i14.3.i.i.i
  store double %.70.i15.3.i.i.i, ptr %scevgep150.3.i.i.i, align 8, !noalias !72
  store double %.80.i12.3.i.i.i, ptr %scevgep151.3.i.i.i, align 8, !noalias !72
  %.1169.2.1.3.i.i.i = load double, ptr %scevgep148.3.i.i.i, align 8, !noalias !72
  %.1171.2.1.3.i.i.i = load double, ptr %scevgep149.3.i.i.i, align 8, !noalias !72
  %.58.i10.1.3.i.i.i = fmul contract double %.850.sroa.4.0.i.i.i, %.1169.2.1.3.i.i.i
  %.64.i11.1.3.i.i.i = fmul contract double %.850.sroa.0.0.i.i.i, %.1171.2.1.3.i.i.i
  %.80.i12.1.3.i.i.i = fadd contract double %.58.i10.1.3.i.i.i, %.64.i11.1.3.i.i.i
  %.46.i13.1.3.i.i.i = fmul contract double %.850.sroa.0.0.i.i.i, %.1169.2.1.3.i.i.i
  %.52.i14.1.3.i.i.i = fmul contract double %.850.sroa.4.0.i.i.i, %.1171.2.1.3.i.i.i
  %.70.i15.1.3.i.i.i = fsub contract double %.46.i13.1.3.i.i.i, %.52.i14.1.3.i.i.i
  store double %.70.i15.1.3.i.i.i, ptr %scevgep148.3.i.i.i, align 8, !noalias !72
  store double %.80.i12.1.3.i.i.i, ptr %scevgep149.3.i.i.i, align 8, !noalias !72
  %.1169.2.4.i.i.i = load double, ptr %.2435.i.i.i.i, align 8, !noalias !72
  %.1171.2.4.i.i.i = load double, ptr %.2438.i.i.i.i, align 8, !noalias !72
  %.58.i10.4.i.i.i = fmul contract double %.850.sroa.4.0.i.i.i, %.1169.2.4.i.i.i
  %.64.i11.4.i.i.i = fmul contract double %.850.sroa.0.0.i.i.i, %.1171.2.4.i.i.i
  %.80.i12.4.i.i.i = fadd contract double %.58.i10.4.i.i.i, %.64.i11.4.i.i.i
  %.46.i13.4.i.i.i = fmul contract double %.850.sroa.0.0.i.i.i, %.1169.2.4.i.i.i
  %.52.i14.4.i.i.i = fmul contract double %.850.sroa.4.0.i.i.i, %.1171.2.4.i.i.i
  %.70.i15.4.i.i.i = fsub contract double %.46.i13.4.i.i.i, %.52.i14.4.i.i.i
  store double %.70.i15.4.i.i.i, ptr %.2435.i.i.i.i, align 8, !noalias !72
  store double %.80.i12.4.i.i.i, ptr %.2438.i.i.i.i, align 8, !noalias !72
  %.1169.2.1.4.i.i.i = load double, ptr %scevgep148.4.i.i.i, align 8, !noalias !72
  %.1171.2.1.4.i.i.i = load double, ptr %scevgep149.4.i.i.i, align 8, !noalias !72
  %.58.i10.1.4.i.i.i = fmul contract double %.850.sroa.4.0.i.i.i, %.1169.2.1.4.i.i.i
  %.64.i11.1.4.i.i.i = fmul contract double %.850.sroa.0.0.i.i.i, %.1171.2.1.4.i.i.i
  %.80.i12.1.4.i.i.i = fadd contract double %.58.i10.1.4.i.i.i, %.64.i11.1.4.i.i.i
  %.46.i13.1.4.i.i.i = fmul contract double %.850.sroa.0.0.i.i.i, %.1169.2.1.4.i.i.i
  %.52.i14.1.4.i.i.i = fmul contract double %.850.sroa.4.0.i.i.i, %.1171.2.1.4.i.i.i
  %.70.i15.1.4.i.i.i = fsub contract double %.46.i13.1.4.i.i.i, %.52.i14.1.4.i.i.i
  store double %.70.i15.1.4.i.i.i, ptr %scevgep148.4.i.i.i, align 8, !noalias !72
  store double %.80.i12.1.4.i.i.i, ptr %scevgep149.4.i.i.i, align 8, !noalias !72
  %.1169.2.5.i.i.i = load double, ptr %scevgep150.5.i.i.i, align 8, !noalias !72
  %.1171.2.5.i.i.i = load double, ptr %scevgep151.5.i.i.i, align 8, !noalias !72
  %.58.i10.5.i.i.i = fmul contract double %.850.sroa.4.0.i.i.i, %.1169.2.5.i.i.i
  %.64.i11.5.i.i.i = fmul contract double %.850.sroa.0.0.i.i.i, %.1171.2.5.i.i.i
  %.80.i12.5.i.i.i = fadd contract double %.58.i10.5.i.i.i, %.64.i11.5.i.i.i
  %.46.i13.5.i.i.i = fmul contract double %.850.sroa.0.0.i.i.i, %.1169.2.5.i.i.i
  %.52.i14.5.i.i.i = fmul contract double %.850.sroa.4.0.i.i.i, %.1171.2.5.i.i.i
  %.70.i15.5.i.i.i = fsub contract double %.46.i13.5.i.i.i, %.52.i14.5.i.i.i
  store double %.70.i15.5.i.i.i, ptr %scevgep150.5.i.i.i, align 8, !noalias !72
  store double %.80.i12.5.i.i.i, ptr %scevgep151.5.i.i.i, align 8, !noalias !72
  %.1169.2.1.5.i.i.i = load double, ptr %scevgep148.5.i.i.i, align 8, !noalias !72
  %.1171.2.1.5.i.i.i = load double, ptr %scevgep149.5.i.i.i, align 8, !noalias !72
  %.58.i10.1.5.i.i.i = fmul contract double %.850.sroa.4.0.i.i.i, %.1169.2.1.5.i.i.i
  %.64.i11.1.5.i.i.i = fmul contract double %.850.sroa.0.0.i.i.i, %.1171.2.1.5.i.i.i
  %.80.i12.1.5.i.i.i = fadd contract double %.58.i10.1.5.i.i.i, %.64.i11.1.5.i.i.i
  %.46.i13.1.5.i.i.i = fmul contract double %.850.sroa.0.0.i.i.i, %.1169.2.1.5.i.i.i
  %.52.i14.1.5.i.i.i = fmul contract double %.850.sroa.4.0.i.i.i, %.1171.2.1.5.i.i.i
  %.70.i15.1.5.i.i.i = fsub contract double %.46.i13.1.5.i.i.i, %.52.i14.1.5.i.i.i
  store double %.70.i15.1.5.i.i.i, ptr %scevgep148.5.i.i.i, align 8, !noalias !72
  store double %.80.i12.1.5.i.i.i, ptr %scevgep149.5.i.i.i, align 8, !noalias !72
  %.1169.2.6.i.i.i = load double, ptr %scevgep150.6.i.i.i, align 8, !noalias !72
  %.1171.2.6.i.i.i = load double, ptr %scevgep151.6.i.i.i, align 8, !noalias !72
  %.58.i10.6.i.i.i = fmul contract double %.850.sroa.4.0.i.i.i, %.1169.2.6.i.i.i
  %.64.i11.6.i.i.i = fmul contract double %.850.sroa.0.0.i.i.i, %.1171.2.6.i.i.i
  %.80.i12.6.i.i.i = fadd contract double %.58.i10.6.i.i.i, %.64.i11.6.i.i.i
  %.46.i13.6.i.i.i = fmul contract double %.850.sroa.0.0.i.i.i, %.1169.2.6.i.i.i
  %.52.i14.6.i.i.i = fmul contract double %.850.sroa.4.0.i.i.i, %.1171.2.6.i.i.i
  %.70.i15.6.i.i.i = fsub contract double %.46.i13.6.i.i.i, %.52.i14.6.i.i.i
  store double %.70.i15.6.i.i.i, ptr %scevgep150.6.i.i.i, align 8, !noalias !72
  store double %.80.i12.6.i.i.i, ptr %scevgep151.6.i.i.i, align 8, !noalias !72
  %.1169.2.1.6.i.i.i = load double, ptr %scevgep148.6.i.i.i, align 8, !noalias !72
  %.1171.2.1.6.i.i.i = load double, ptr %scevgep149.6.i.i.i, align 8, !noalias !72
  %.58.i10.1.6.i.i.i = fmul contract double %.850.sroa.4.0.i.i.i, %.1169.2.1.6.i.i.i
  %.64.i11.1.6.i.i.i = fmul contract double %.850.sroa.0.0.i.i.i, %.1171.2.1.6.i.i.i
  %.80.i12.1.6.i.i.i = fadd contract double %.58.i10.1.6.i.i.i, %.64.i11.1.6.i.i.i
  %.46.i13.1.6.i.i.i = fmul contract double %.850.sroa.0.0.i.i.i, %.1169.2.1.6.i.i.i
  %.52.i14.1.6.i.i.i = fmul contract double %.850.sroa.4.0.i.i.i, %.1171.2.1.6.i.i.i
  %.70.i15.1.6.i.i.i = fsub contract double %.46.i13.1.6.i.i.i, %.52.i14.1.6.i.i.i
  store double %.70.i15.1.6.i.i.i, ptr %scevgep148.6.i.i.i, align 8, !noalias !72
  store double %.80.i12.1.6.i.i.i, ptr %scevgep149.6.i.i.i, align 8, !noalias !72
  %.1169.2.7.i.i.i = load double, ptr %scevgep150.7.i.i.i, align 8, !noalias !72
  %.1171.2.7.i.i.i = load double, ptr %scevgep151.7.i.i.i, align 8, !noalias !72
  %.58.i10.7.i.i.i = fmul contract double %.850.sroa.4.0.i.i.i, %.1169.2.7.i.i.i
  %.64.i11.7.i.i.i = fmul contract double %.850.sroa.0.0.i.i.i, %.1171.2.7.i.i.i
  %.80.i12.7.i.i.i = fadd contract double %.58.i10.7.i.i.i, %.64.i11.7.i.i.i
  %.46.i13.7.i.i.i = fmul contract double %.850.sroa.0.0.i.i.i, %.1169.2.7.i.i.i
  %.52.i14.7.i.i.i = fmul contract double %.850.sroa.4.0.i.i.i, %.1171.2.7.i.i.i
  %.70.i15.7.i.i.i = fsub contract double %.46.i13.7.i.i.i, %.52.i14.7.i.i.i
  store double %.70.i15.7.i.i.i, ptr %scevgep150.7.i.i.i, align 8, !noalias !72
  store double %.80.i12.7.i.i.i, ptr %scevgep151.7.i.i.i, align 8, !noalias !72
  %.1169.2.1.7.i.i.i = load double, ptr %scevgep148.7.i.i.i, align 8, !noalias !72
  %.1171.2.1.7.i.i.i = load double, ptr %scevgep149.7.i.i.i, align 8, !noalias !72
  %.58.i10.1.7.i.i.i = fmul contract double %.850.sroa.4.0.i.i.i, %.1169.2.1.7.i.i.i
  %.64.i11.1.7.i.i.i = fmul contract double %.850.sroa.0.0.i.i.i, %.1171.2.1.7.i.i.i
  %.80.i12.1.7.i.i.i = fadd contract double %.58.i10.1.7.i.i.i, %.64.i11.1.7.i.i.i
  %.46.i13.1.7.i.i.i = fmul contract double %.850.sroa.0.0.i.i.i, %.1169.2.1.7.i.i.i
  %.52.i14.1.7.i.i.i = fmul contract double %.850.sroa.4.0.i.i.i, %.1171.2.1.7.i.i.i
  %.70.i15.1.7.i.i.i = fsub contract double %.46.i13.1.7.i.i.i, %.52.i14.1.7.i.i.i
  store double %.70.i15.1.7.i.i.i, ptr %scevgep148.7.i.i.i, align 8, !noalias !72
  store double %.80.i12.1.7.i.i.i, ptr %scevgep149.7.i.i.i, align 8, !noalias !72
  br label %_ZN17bnserve_surrogate8tangents7_series6_phaseB4v174B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE10complex12810complex12810complex1288UniTupleI10complex128Li2EE8UniTupleI10complex128Li2EE5ArrayI10complex128Li2E1C7mutable7alignedE.exit.i.i

_ZN17bnserve_surrogate8tangents7_series6_phaseB4v174B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE10complex12810complex12810complex1288UniTupleI10complex128Li2EE8UniTupleI10complex128Li2EE5ArrayI10complex128Li2E1C7mutable7alignedE.exit.i.i: ; preds = %B576.if.i.i.i, %B282.endif.i102.i.i.i, %B174.endif.i79.i.i.i, %B282.i100.i.i.i, %B132.i77.i.i.i, %B282.endif.i219.i.i.i.i, %B174.endif.i196.i.i.i.i, %B282.i217.i.i.i.i, %B132.i194.i.i.i.i, %B282.endif.i.i.i.i.i, %B174.endif.i.i.i.i.i, %B282.i.i.i.i.i, %B132.i.i.i.i.i, %B282.endif.i45.i.i.i, %B174.endif.i22.i.i.i, %B282.i43.i.i.i, %B132.i20.i.i.i, %B282.endif.i.i.i.i, %B174.endif.i.i.i.i, %B282.i.i.i.i, %B132.i.i.i.i
  %excinfo.5.1.i.i = phi ptr [ %excinfo.5.0.i.i, %B576.if.i.i.i ], [ null, %B174.endif.i196.i.i.i.i ], [ null, %B132.i20.i.i.i ], [ null, %B132.i.i.i.i ], [ null, %B282.endif.i.i.i.i ], [ null, %B282.i.i.i.i ], [ null, %B174.endif.i.i.i.i ], [ null, %B282.endif.i45.i.i.i ], [ null, %B282.i43.i.i.i ], [ null, %B174.endif.i22.i.i.i ], [ null, %B132.i194.i.i.i.i ], [ null, %B132.i.i.i.i.i ], [ null, %B282.endif.i.i.i.i.i ], [ null, %B282.i.i.i.i.i ], [ null, %B174.endif.i.i.i.i.i ], [ null, %B282.endif.i219.i.i.i.i ], [ null, %B282.i217.i.i.i.i ], [ null, %B282.endif.i102.i.i.i ], [ null, %B282.i100.i.i.i ], [ null, %B174.endif.i79.i.i.i ], [ null, %B132.i77.i.i.i ]
  %cond.i.i = phi i1 [ true, %B576.if.i.i.i ], [ false, %B174.endif.i196.i.i.i.i ], [ false, %B132.i20.i.i.i ], [ false, %B132.i.i.i.i ], [ false, %B282.endif.i.i.i.i ], [ false, %B282.i.i.i.i ], [ false, %B174.endif.i.i.i.i ], [ false, %B282.endif.i45.i.i.i ], [ false, %B282.i43.i.i.i ], [ false, %B174.endif.i22.i.i.i ], [ false, %B132.i194.i.i.i.i ], [ false, %B132.i.i.i.i.i ], [ false, %B282.endif.i.i.i.i.i ], [ false, %B282.i.i.i.i.i ], [ false, %B174.endif.i.i.i.i.i ], [ false, %B282.endif.i219.i.i.i.i ], [ false, %B282.i217.i.i.i.i ], [ false, %B282.endif.i102.i.i.i ], [ false, %B282.i100.i.i.i ], [ false, %B174.endif.i79.i.i.i ], [ false, %B132.i77.i.i.i ]
  %common.ret.op.i.i.i = phi i32 [ 0, %B576.if.i.i.i ], [ 1, %B174.endif.i196.i.i.i.i ], [ 1, %B132.i20.i.i.i ], [ 1, %B132.i.i.i.i ], [ 1, %B282.endif.i.i.i.i ], [ 1, %B282.i.i.i.i ], [ 1, %B174.endif.i.i.i.i ], [ 1, %B282.endif.i45.i.i.i ], [ 1, %B282.i43.i.i.i ], [ 1, %B174.endif.i22.i.i.i ], [ 1, %B132.i194.i.i.i.i ], [ 1, %B132.i.i.i.i.i ], [ 1, %B282.endif.i.i.i.i.i ], [ 1, %B282.i.i.i.i.i ], [ 1, %B174.endif.i.i.i.i.i ], [ 1, %B282.endif.i219.i.i.i.i ], [ 1, %B282.i217.i.i.i.i ], [ 1, %B282.endif.i102.i.i.i ], [ 1, %B282.i100.i.i.i ], [ 1, %B174.endif.i79.i.i.i ], [ 1, %B132.i77.i.i.i ]
  call void @llvm.lifetime.end.p0(ptr nonnull %.568.i.i.i), !noalias !68
  call void @llvm.lifetime.end.p0(ptr nonnull %.599.i.i.i), !noalias !68
  call void @llvm.lifetime.end.p0(ptr nonnull %.632.i.i.i), !noalias !68
  call void @llvm.lifetime.end.p0(ptr nonnull %.669.i.i.i), !noalias !68
  call void @llvm.lifetime.end.p0(ptr nonnull %.737.i.i.i), !noalias !68
  call void @llvm.lifetime.end.p0(ptr nonnull %.775.i.i.i), !noalias !68
  br i1 %cond.i.i, label %B940.if.i.i, label %_ZN17bnserve_surrogate8tangents7_series19fill_phase_tangentsB4v168B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayI10complex128Li2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i, !prof !20

B940.if.i.i:                                      ; preds = %_ZN17bnserve_surrogate8tangents7_series6_phaseB4v174B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE10complex12810complex12810complex1288UniTupleI10complex128Li2EE8UniTupleI10complex128Li2EE5ArrayI10complex128Li2E1C7mutable7alignedE.exit.i.i
  %scevgep167.i.i = getelementptr i8, ptr %scevgep.i3.i, i64 %lsr.iv.i.i
  %scevgep168.i.i = getelementptr i8, ptr %scevgep167.i.i, i64 -376
  %.980.i.i = load double, ptr %.80.i1.i.i.i, align 8, !noalias !68
  %.992.i.i = fdiv contract double %.980.i.i, 1.000000e-30
  store double %.992.i.i, ptr %scevgep168.i.i, align 8, !noalias !68
  %.980.1.i.i = load double, ptr %sunkaddr175.i.i.i, align 8, !noalias !68
  %.992.1.i.i = fdiv contract double %.980.1.i.i, 1.000000e-30
  %scevgep141.i.i = getelementptr i8, ptr %scevgep167.i.i, i64 -368
  store double %.992.1.i.i, ptr %scevgep141.i.i, align 8, !noalias !68
  %.980.2.i.i = load double, ptr %.225.i.i.i.i, align 8, !noalias !68
  %.992.2.i.i = fdiv contract double %.980.2.i.i, 1.000000e-30
  %scevgep138.i.i = getelementptr i8, ptr %scevgep167.i.i, i64 -360
  store double %.992.2.i.i, ptr %scevgep138.i.i, align 8, !noalias !68
  %.980.3.i.i = load double, ptr %.448.i.i.i.i, align 8, !noalias !68
  %.992.3.i.i = fdiv contract double %.980.3.i.i, 1.000000e-30
  %scevgep135.i.i = getelementptr i8, ptr %scevgep167.i.i, i64 -352
  store double %.992.3.i.i, ptr %scevgep135.i.i, align 8, !noalias !68
  %.980.4.i.i = load double, ptr %.591.i.i.i.i, align 8, !noalias !68
  %.992.4.i.i = fdiv contract double %.980.4.i.i, 1.000000e-30
  %scevgep132.i.i = getelementptr i8, ptr %scevgep167.i.i, i64 -344
  store double %.992.4.i.i, ptr %scevgep132.i.i, align 8, !noalias !68
  %.980.5.i.i = load double, ptr %sunkaddr175.2.i.i.i, align 8, !noalias !68
  %.992.5.i.i = fdiv contract double %.980.5.i.i, 1.000000e-30
  %scevgep129.i.i = getelementptr i8, ptr %scevgep167.i.i, i64 -336
  store double %.992.5.i.i, ptr %scevgep129.i.i, align 8, !noalias !68
  %.980.6.i.i = load double, ptr %.1114.i.i.i.i, align 8, !noalias !68
  %.992.6.i.i = fdiv contract double %.980.6.i.i, 1.000000e-30
  %scevgep125.i.i = getelementptr i8, ptr %scevgep167.i.i, i64 -328
  store double %.992.6.i.i, ptr %scevgep125.i.i, align 8, !noalias !68
  %.980.7.i.i = load double, ptr %.1648.i.i.i.i, align 8, !noalias !68
  %.992.7.i.i = fdiv contract double %.980.7.i.i, 1.000000e-30
  %scevgep122.i.i = getelementptr i8, ptr %scevgep167.i.i, i64 -320
  store double %.992.7.i.i, ptr %scevgep122.i.i, align 8, !noalias !68
  %.980.8.i.i = load double, ptr %sunkaddr171.4.i.i.i, align 8, !noalias !68
  %.992.8.i.i = fdiv contract double %.980.8.i.i, 1.000000e-30
  %scevgep119.i.i = getelementptr i8, ptr %scevgep167.i.i, i64 -312
  store double %.992.8.i.i, ptr %scevgep119.i.i, align 8, !noalias !68
  %.980.9.i.i = load double, ptr %.2659.i.i.i.i, align 8, !noalias !68
  %.992.9.i.i = fdiv contract double %.980.9.i.i, 1.000000e-30
  %scevgep116.i.i = getelementptr i8, ptr %scevgep167.i.i, i64 -304
  store double %.992.9.i.i, ptr %scevgep116.i.i, align 8, !noalias !68
  %.980.10.i.i = load double, ptr %.3497.i.i.i.i, align 8, !noalias !68
  %.992.10.i.i = fdiv contract double %.980.10.i.i, 1.000000e-30
  %scevgep113.i.i = getelementptr i8, ptr %scevgep167.i.i, i64 -296
  store double %.992.10.i.i, ptr %scevgep113.i.i, align 8, !noalias !68
  %.980.11.i.i = load double, ptr %.4478.i.i.i.i, align 8, !noalias !68
  %.992.11.i.i = fdiv contract double %.980.11.i.i, 1.000000e-30
  %scevgep109.i.i = getelementptr i8, ptr %scevgep167.i.i, i64 -288
  store double %.992.11.i.i, ptr %scevgep109.i.i, align 8, !noalias !68
  %.980.12.i.i = load double, ptr %sunkaddr171.6.i.i.i, align 8, !noalias !68
  %.992.12.i.i = fdiv contract double %.980.12.i.i, 1.000000e-30
  %scevgep106.i.i = getelementptr i8, ptr %scevgep167.i.i, i64 -280
  store double %.992.12.i.i, ptr %scevgep106.i.i, align 8, !noalias !68
  %.980.13.i.i = load double, ptr %sunkaddr175.6.i.i.i, align 8, !noalias !68
  %.992.13.i.i = fdiv contract double %.980.13.i.i, 1.000000e-30
  %scevgep103.i.i = getelementptr i8, ptr %scevgep167.i.i, i64 -272
  store double %.992.13.i.i, ptr %scevgep103.i.i, align 8, !noalias !68
  %.980.14.i.i = load double, ptr %sunkaddr171.7.i.i.i, align 8, !noalias !68
  %.992.14.i.i = fdiv contract double %.980.14.i.i, 1.000000e-30
  %scevgep100.i.i = getelementptr i8, ptr %scevgep167.i.i, i64 -264
  store double %.992.14.i.i, ptr %scevgep100.i.i, align 8, !noalias !68
  %.980.15.i.i = load double, ptr %sunkaddr175.7.i.i.i, align 8, !noalias !68
  %.992.15.i.i = fdiv contract double %.980.15.i.i, 1.000000e-30
  %scevgep95.i.i = getelementptr i8, ptr %scevgep167.i.i, i64 -256
  store double %.992.15.i.i, ptr %scevgep95.i.i, align 8, !noalias !68
  %.980.170.i.i = load double, ptr %scevgep160.i.i.i, align 8, !noalias !68
  %.992.171.i.i = fdiv contract double %.980.170.i.i, 1.000000e-30
  %scevgep97.i.i = getelementptr i8, ptr %scevgep167.i.i, i64 -248
  store double %.992.171.i.i, ptr %scevgep97.i.i, align 8, !noalias !68
  %.980.1.1.i.i = load double, ptr %scevgep152.i.i.i, align 8, !noalias !68
  %.992.1.1.i.i = fdiv contract double %.980.1.1.i.i, 1.000000e-30
  %scevgep92.i.i = getelementptr i8, ptr %scevgep167.i.i, i64 -240
  store double %.992.1.1.i.i, ptr %scevgep92.i.i, align 8, !noalias !68
  %.980.2.1.i.i = load double, ptr %scevgep160.1.i.i.i, align 8, !noalias !68
  %.992.2.1.i.i = fdiv contract double %.980.2.1.i.i, 1.000000e-30
  %scevgep89.i.i = getelementptr i8, ptr %scevgep167.i.i, i64 -232
  store double %.992.2.1.i.i, ptr %scevgep89.i.i, align 8, !noalias !68
  %.980.3.1.i.i = load double, ptr %scevgep158.1.i.i.i, align 8, !noalias !68
  %.992.3.1.i.i = fdiv contract double %.980.3.1.i.i, 1.000000e-30
  %scevgep86.i.i = getelementptr i8, ptr %scevgep167.i.i, i64 -224
  store double %.992.3.1.i.i, ptr %scevgep86.i.i, align 8, !noalias !68
  %.980.4.1.i.i = load double, ptr %scevgep160.2.i.i.i, align 8, !noalias !68
  %.992.4.1.i.i = fdiv contract double %.980.4.1.i.i, 1.000000e-30
  %scevgep83.i.i = getelementptr i8, ptr %scevgep167.i.i, i64 -216
  store double %.992.4.1.i.i, ptr %scevgep83.i.i, align 8, !noalias !68
  %.980.5.1.i.i = load double, ptr %.893.i.i.i.i, align 8, !noalias !68
  %.992.5.1.i.i = fdiv contract double %.980.5.1.i.i, 1.000000e-30
  %scevgep80.i.i = getelementptr i8, ptr %scevgep167.i.i, i64 -208
  store double %.992.5.1.i.i, ptr %scevgep80.i.i, align 8, !noalias !68
  %.980.6.1.i.i = load double, ptr %.1505.i.i.i.i, align 8, !noalias !68
  %.992.6.1.i.i = fdiv contract double %.980.6.1.i.i, 1.000000e-30
  %scevgep77.i.i = getelementptr i8, ptr %scevgep167.i.i, i64 -200
  store double %.992.6.1.i.i, ptr %scevgep77.i.i, align 8, !noalias !68
  %.980.7.1.i.i = load double, ptr %scevgep158.3.i.i.i, align 8, !noalias !68
  %.992.7.1.i.i = fdiv contract double %.980.7.1.i.i, 1.000000e-30
  %scevgep74.i.i = getelementptr i8, ptr %scevgep167.i.i, i64 -192
  store double %.992.7.1.i.i, ptr %scevgep74.i.i, align 8, !noalias !68
  %.980.8.1.i.i = load double, ptr %.1950.i.i.i.i, align 8, !noalias !68
  %.992.8.1.i.i = fdiv contract double %.980.8.1.i.i, 1.000000e-30
  %scevgep71.i.i = getelementptr i8, ptr %scevgep167.i.i, i64 -184
  store double %.992.8.1.i.i, ptr %scevgep71.i.i, align 8, !noalias !68
  %.980.9.1.i.i = load double, ptr %.3050.i.i.i.i, align 8, !noalias !68
  %.992.9.1.i.i = fdiv contract double %.980.9.1.i.i, 1.000000e-30
  %scevgep68.i.i = getelementptr i8, ptr %scevgep167.i.i, i64 -176
  store double %.992.9.1.i.i, ptr %scevgep68.i.i, align 8, !noalias !68
  %.980.10.1.i.i = load double, ptr %.4249.i.i.i.i, align 8, !noalias !68
  %.992.10.1.i.i = fdiv contract double %.980.10.1.i.i, 1.000000e-30
  %scevgep65.i.i = getelementptr i8, ptr %scevgep167.i.i, i64 -168
  store double %.992.10.1.i.i, ptr %scevgep65.i.i, align 8, !noalias !68
  %.980.11.1.i.i = load double, ptr %.4966.i.i.i.i, align 8, !noalias !68
  %.992.11.1.i.i = fdiv contract double %.980.11.1.i.i, 1.000000e-30
  %scevgep63.i.i = getelementptr i8, ptr %scevgep167.i.i, i64 -160
  store double %.992.11.1.i.i, ptr %scevgep63.i.i, align 8, !noalias !68
  %.980.12.1.i.i = load double, ptr %scevgep160.6.i.i.i, align 8, !noalias !68
  %.992.12.1.i.i = fdiv contract double %.980.12.1.i.i, 1.000000e-30
  %scevgep60.i.i = getelementptr i8, ptr %scevgep167.i.i, i64 -152
  store double %.992.12.1.i.i, ptr %scevgep60.i.i, align 8, !noalias !68
  %.980.13.1.i.i = load double, ptr %scevgep158.6.i.i.i, align 8, !noalias !68
  %.992.13.1.i.i = fdiv contract double %.980.13.1.i.i, 1.000000e-30
  %scevgep57.i.i = getelementptr i8, ptr %scevgep167.i.i, i64 -144
  store double %.992.13.1.i.i, ptr %scevgep57.i.i, align 8, !noalias !68
  %.980.14.1.i.i = load double, ptr %scevgep160.7.i.i.i, align 8, !noalias !68
  %.992.14.1.i.i = fdiv contract double %.980.14.1.i.i, 1.000000e-30
  %scevgep53.i.i = getelementptr i8, ptr %scevgep167.i.i, i64 -136
  store double %.992.14.1.i.i, ptr %scevgep53.i.i, align 8, !noalias !68
  %.980.15.1.i.i = load double, ptr %scevgep158.7.i.i.i, align 8, !noalias !68
  %.992.15.1.i.i = fdiv contract double %.980.15.1.i.i, 1.000000e-30
  %scevgep49.i.i = getelementptr i8, ptr %scevgep167.i.i, i64 -128
  store double %.992.15.1.i.i, ptr %scevgep49.i.i, align 8, !noalias !68
  %.980.273.i.i = load double, ptr %scevgep151.i.i.i, align 8, !noalias !68
  %.992.274.i.i = fdiv contract double %.980.273.i.i, 1.000000e-30
  %scevgep50.i.i = getelementptr i8, ptr %scevgep167.i.i, i64 -120
  store double %.992.274.i.i, ptr %scevgep50.i.i, align 8, !noalias !68
  %.980.1.2.i.i = load double, ptr %scevgep.i.i.i, align 8, !noalias !68
  %.992.1.2.i.i = fdiv contract double %.980.1.2.i.i, 1.000000e-30
  %scevgep46.i.i = getelementptr i8, ptr %scevgep167.i.i, i64 -112
  store double %.992.1.2.i.i, ptr %scevgep46.i.i, align 8, !noalias !68
  %.980.2.2.i.i = load double, ptr %scevgep151.1.i.i.i, align 8, !noalias !68
  %.992.2.2.i.i = fdiv contract double %.980.2.2.i.i, 1.000000e-30
  %scevgep43.i.i = getelementptr i8, ptr %scevgep167.i.i, i64 -104
  store double %.992.2.2.i.i, ptr %scevgep43.i.i, align 8, !noalias !68
  %.980.3.2.i.i = load double, ptr %scevgep149.1.i.i.i, align 8, !noalias !68
  %.992.3.2.i.i = fdiv contract double %.980.3.2.i.i, 1.000000e-30
  %scevgep40.i.i = getelementptr i8, ptr %scevgep167.i.i, i64 -96
  store double %.992.3.2.i.i, ptr %scevgep40.i.i, align 8, !noalias !68
  %.980.4.2.i.i = load double, ptr %scevgep151.2.i.i.i, align 8, !noalias !68
  %.992.4.2.i.i = fdiv contract double %.980.4.2.i.i, 1.000000e-30
  %scevgep37.i.i = getelementptr i8, ptr %scevgep167.i.i, i64 -88
  store double %.992.4.2.i.i, ptr %scevgep37.i.i, align 8, !noalias !68
  %.980.5.2.i.i = load double, ptr %scevgep149.2.i.i.i, align 8, !noalias !68
  %.992.5.2.i.i = fdiv contract double %.980.5.2.i.i, 1.000000e-30
  %scevgep35.i.i = getelementptr i8, ptr %scevgep167.i.i, i64 -80
  store double %.992.5.2.i.i, ptr %scevgep35.i.i, align 8, !noalias !68
  %.980.6.2.i.i = load double, ptr %scevgep151.3.i.i.i, align 8, !noalias !68
  %.992.6.2.i.i = fdiv contract double %.980.6.2.i.i, 1.000000e-30
  %scevgep32.i.i = getelementptr i8, ptr %scevgep167.i.i, i64 -72
  store double %.992.6.2.i.i, ptr %scevgep32.i.i, align 8, !noalias !68
  %.980.7.2.i.i = load double, ptr %scevgep149.3.i.i.i, align 8, !noalias !68
  %.992.7.2.i.i = fdiv contract double %.980.7.2.i.i, 1.000000e-30
  %scevgep29.i.i = getelementptr i8, ptr %scevgep167.i.i, i64 -64
  store double %.992.7.2.i.i, ptr %scevgep29.i.i, align 8, !noalias !68
  %.980.8.2.i.i = load double, ptr %.2438.i.i.i.i, align 8, !noalias !68
  %.992.8.2.i.i = fdiv contract double %.980.8.2.i.i, 1.000000e-30
  %scevgep26.i.i = getelementptr i8, ptr %scevgep167.i.i, i64 -56
  store double %.992.8.2.i.i, ptr %scevgep26.i.i, align 8, !noalias !68
  %.980.9.2.i.i = load double, ptr %scevgep149.4.i.i.i, align 8, !noalias !68
  %.992.9.2.i.i = fdiv contract double %.980.9.2.i.i, 1.000000e-30
  %scevgep23.i.i = getelementptr i8, ptr %scevgep167.i.i, i64 -48
  store double %.992.9.2.i.i, ptr %scevgep23.i.i, align 8, !noalias !68
  %.980.10.2.i.i = load double, ptr %scevgep151.5.i.i.i, align 8, !noalias !68
  %.992.10.2.i.i = fdiv contract double %.980.10.2.i.i, 1.000000e-30
  %scevgep20.i.i = getelementptr i8, ptr %scevgep167.i.i, i64 -40
  store double %.992.10.2.i.i, ptr %scevgep20.i.i, align 8, !noalias !68
  %.980.11.2.i.i = load double, ptr %scevgep149.5.i.i.i, align 8, !noalias !68
  %.992.11.2.i.i = fdiv contract double %.980.11.2.i.i, 1.000000e-30
  %scevgep17.i.i = getelementptr i8, ptr %scevgep167.i.i, i64 -32
  store double %.992.11.2.i.i, ptr %scevgep17.i.i, align 8, !noalias !68
  %.980.12.2.i.i = load double, ptr %scevgep151.6.i.i.i, align 8, !noalias !68
  %.992.12.2.i.i = fdiv contract double %.980.12.2.i.i, 1.000000e-30
  %scevgep14.i.i = getelementptr i8, ptr %scevgep167.i.i, i64 -24
  store double %.992.12.2.i.i, ptr %scevgep14.i.i, align 8, !noalias !68
  %.980.13.2.i.i = load double, ptr %scevgep149.6.i.i.i, align 8, !noalias !68
  %.992.13.2.i.i = fdiv contract double %.980.13.2.i.i, 1.000000e-30
  %scevgep11.i.i = getelementptr i8, ptr %scevgep167.i.i, i64 -16
  store double %.992.13.2.i.i, ptr %scevgep11.i.i, align 8, !noalias !68
  %.980.14.2.i.i = load double, ptr %scevgep151.7.i.i.i, align 8, !noalias !68
  %.992.14.2.i.i = fdiv contract double %.980.14.2.i.i, 1.000000e-30
  %scevgep8.i.i = getelementptr i8, ptr %scevgep167.i.i, i64 -8
  store double %.992.14.2.i.i, ptr %scevgep8.i.i, align 8, !noalias !68
  %.980.15.2.i.i = load double, ptr %scevgep149.7.i.i.i, align 8, !noalias !68
  %.992.15.2.i.i = fdiv contract double %.980.15.2.i.i, 1.000000e-30
  store double %.992.15.2.i.i, ptr %scevgep167.i.i, align 8, !noalias !68
  %lsr.iv.next.i.i = add nuw nsw i64 %lsr.iv.i.i, 384
  %exitcond318.not.i.i = icmp eq i64 %lsr.iv.next.i.i, 1920
  br i1 %exitcond318.not.i.i, label %_ZN17bnserve_surrogate8tangents7_series19fill_phase_tangentsB4v168B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayI10complex128Li2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i, label %B238.if.i.i

_ZN17bnserve_surrogate8tangents7_series19fill_phase_tangentsB4v168B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayI10complex128Li2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i: ; preds = %B940.if.i.i, %_ZN17bnserve_surrogate8tangents7_series6_phaseB4v174B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE10complex12810complex12810complex1288UniTupleI10complex128Li2EE8UniTupleI10complex128Li2EE5ArrayI10complex128Li2E1C7mutable7alignedE.exit.i.i
  %excinfo.19.0.i = phi ptr [ null, %B940.if.i.i ], [ %excinfo.5.1.i.i, %_ZN17bnserve_surrogate8tangents7_series6_phaseB4v174B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE10complex12810complex12810complex1288UniTupleI10complex128Li2EE8UniTupleI10complex128Li2EE5ArrayI10complex128Li2E1C7mutable7alignedE.exit.i.i ]
  %common.ret.op.i.i = phi i32 [ 0, %B940.if.i.i ], [ %common.ret.op.i.i.i, %_ZN17bnserve_surrogate8tangents7_series6_phaseB4v174B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE10complex12810complex12810complex1288UniTupleI10complex128Li2EE8UniTupleI10complex128Li2EE5ArrayI10complex128Li2E1C7mutable7alignedE.exit.i.i ]
  %cond1.i = icmp eq i32 %common.ret.op.i.i, 0
  br i1 %cond1.i, label %B632.endif.endif.endif.en...endif.endif.i, label %_ZN17bnserve_surrogate8tangents8_carrier15prepare_splinesB4v144B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE692Row_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20int64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_203_29_2c_20UniTuple_28array_28float64_2c_201d_2c_20C_29_20x_202_29_2c_20UniTuple_28array_28int64_2c_201d_2c_20C_29_20x_202_29_2c_20UniTuple_28array_28float64_2c_201d_2c_20C_29_20x_202_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29.exit, !prof !20

B632.endif.endif.endif.en...endif.endif.i:        ; preds = %_ZN17bnserve_surrogate8tangents7_series19fill_phase_tangentsB4v168B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayI10complex128Li2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i
  %.3002.i = getelementptr inbounds nuw i8, ptr %arg.state.10.1.4, i64 128
  %.75.i.i = load double, ptr %arg.state.6.4, align 8, !noalias !84
  %.402.i.i = fsub contract double 1.000000e+00, %.75.i.i
  %.403.i.i = fadd contract double %.75.i.i, 1.000000e+00
  %.404.i.i = fmul contract double %.75.i.i, %.403.i.i
  %.408.i.i = fdiv contract double %.402.i.i, %.404.i.i
  %.409.i.i = fmul contract double %.408.i.i, 5.000000e-01
  %.46.i.i.i.i5.i = fmul contract double %.403.i.i, %.403.i.i
  %.77.i.i.i = fadd contract double %.75.i.i, -1.000000e+00
  %.45.i.i.i6.i = tail call contract double @llvm.fabs.f64(double %.403.i.i)
  %.59.i.i.i7.i = fcmp contract oeq double %.403.i.i, 0.000000e+00
  %arg.out.4.repack1402.i.i.i = getelementptr inbounds nuw i8, ptr %arg.state.10.1.4, i64 8
  %.593.i.i.i = getelementptr i8, ptr %arg.state.10.1.4, i64 32
  %.593.repack1404.i.i.i = getelementptr i8, ptr %arg.state.10.1.4, i64 40
  %.778.i.i.i = getelementptr i8, ptr %arg.state.10.1.4, i64 48
  %.778.repack1406.i.i.i = getelementptr i8, ptr %arg.state.10.1.4, i64 56
  %.937.i.i.i = getelementptr i8, ptr %arg.state.10.1.4, i64 64
  %.937.repack1408.i.i.i = getelementptr i8, ptr %arg.state.10.1.4, i64 72
  %.1713.i.i.i = getelementptr i8, ptr %arg.state.10.1.4, i64 80
  %.1713.repack1414.i.i.i = getelementptr i8, ptr %arg.state.10.1.4, i64 88
  %.2081.i.i.i = getelementptr i8, ptr %arg.state.10.1.4, i64 96
  %.2081.repack1418.i.i.i = getelementptr i8, ptr %arg.state.10.1.4, i64 104
  %.3569.i.i.i = getelementptr i8, ptr %arg.state.10.1.4, i64 112
  %.3569.repack1430.i.i.i = getelementptr i8, ptr %arg.state.10.1.4, i64 120
  %sunkaddr23.i.i = getelementptr i8, ptr %arg.state.10.1.4, i64 16
  %sunkaddr24.i.i = getelementptr i8, ptr %arg.state.10.1.4, i64 24
  br label %B80.if.i.i

B80.if.i.i:                                       ; preds = %B368.endif.i.i, %B632.endif.endif.endif.en...endif.endif.i
  %excinfo.1.0.i.i = phi ptr [ null, %B632.endif.endif.endif.en...endif.endif.i ], [ %excinfo.1.1.i.i, %B368.endif.i.i ]
  %lsr.iv.i8.i = phi i64 [ 0, %B632.endif.endif.endif.en...endif.endif.i ], [ %lsr.iv.next.i54.i, %B368.endif.i.i ]
  %.202.i.i = icmp eq i64 %lsr.iv.i8.i, 0
  %..i9.i = select i1 %.202.i.i, double 1.000000e-30, double 0.000000e+00
  %.266.i.i = load double, ptr %sunkaddr142.i.i, align 8, !noalias !84
  %.268.i.i = icmp eq i64 %lsr.iv.i8.i, 192
  %"$phi258.4.2.1.i.i" = select i1 %.268.i.i, double 1.000000e-30, double 0.000000e+00
  %.331.i.i = load double, ptr %sunkaddr143.i.i, align 8, !noalias !84
  %.333.i.i = icmp eq i64 %lsr.iv.i8.i, 256
  %"$phi368.4.2.1.i.i" = select i1 %.333.i.i, double 1.000000e-30, double 0.000000e+00
  %.58.i.i.i.i10.i = fmul contract double %.403.i.i, %..i9.i
  %.80.i.i.i.i11.i = fadd contract double %.58.i.i.i.i10.i, %.58.i.i.i.i10.i
  %.52.i.i.i.i12.i = select contract i1 %.202.i.i, double 0x3379B604AAACA627, double 0.000000e+00
  %.70.i.i.i.i13.i = fsub contract double %.46.i.i.i.i5.i, %.52.i.i.i.i12.i
  %.45.i.i.i.i14.i = tail call contract double @llvm.fabs.f64(double %.70.i.i.i.i13.i)
  %.50.i.i.i.i15.i = tail call contract double @llvm.fabs.f64(double %.80.i.i.i.i11.i)
  %.56.i.i.i.i16.i = fcmp contract ult double %.45.i.i.i.i14.i, %.50.i.i.i.i15.i
  br i1 %.56.i.i.i.i16.i, label %B270.i.i.i.i72.i, label %B132.i.i.i.i17.i

B132.i.i.i.i17.i:                                 ; preds = %B80.if.i.i
  %.59.i.i.i.i18.i = fcmp contract oeq double %.70.i.i.i.i13.i, 0.000000e+00
  br i1 %.59.i.i.i.i18.i, label %_ZN17bnserve_surrogate8baseline10_amplitude22amplitude_coefficientsB4v184B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDAxYh_2bqJnA4AOzNAE_3dE10complex12810complex12810complex1285ArrayI10complex128Li1E1C7mutable7alignedE.exit.i.i, label %B174.endif.i.i.i.i19.i, !prof !76

B270.i.i.i.i72.i:                                 ; preds = %B80.if.i.i
  %.132.i.i.i.i73.i = fcmp contract ult double %.50.i.i.i.i15.i, %.45.i.i.i.i14.i
  br i1 %.132.i.i.i.i73.i, label %B0.endif.i.i31.i, label %B282.i.i.i.i74.i

B282.i.i.i.i74.i:                                 ; preds = %B270.i.i.i.i72.i
  %.136.i.i.i.i75.i = fcmp contract oeq double %.80.i.i.i.i11.i, 0.000000e+00
  br i1 %.136.i.i.i.i75.i, label %_ZN17bnserve_surrogate8baseline10_amplitude22amplitude_coefficientsB4v184B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDAxYh_2bqJnA4AOzNAE_3dE10complex12810complex12810complex1285ArrayI10complex128Li1E1C7mutable7alignedE.exit.i.i, label %B282.endif.i.i.i.i76.i, !prof !24

B174.endif.i.i.i.i19.i:                           ; preds = %B132.i.i.i.i17.i
  %.89.i.i.i.i20.i = fdiv contract double %.80.i.i.i.i11.i, %.70.i.i.i.i13.i
  %.91.i.i.i.i21.i = fmul contract double %.80.i.i.i.i11.i, %.89.i.i.i.i20.i
  %.93.i.i.i.i22.i = fadd contract double %.70.i.i.i.i13.i, %.91.i.i.i.i21.i
  %.98.i.i.i.i23.i = fcmp contract oeq double %.93.i.i.i.i22.i, 0.000000e+00
  br i1 %.98.i.i.i.i23.i, label %_ZN17bnserve_surrogate8baseline10_amplitude22amplitude_coefficientsB4v184B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDAxYh_2bqJnA4AOzNAE_3dE10complex12810complex12810complex1285ArrayI10complex128Li1E1C7mutable7alignedE.exit.i.i, label %B174.endif.endif.i.i.i.i24.i, !prof !24

B174.endif.endif.i.i.i.i24.i:                     ; preds = %B174.endif.i.i.i.i19.i
  %.95.i.i.i.i25.i = fmul contract double %..i9.i, %.89.i.i.i.i20.i
  %.97.i.i.i.i26.i = fadd contract double %.75.i.i, %.95.i.i.i.i25.i
  %.105.i.i.i.i27.i = fdiv contract double %.97.i.i.i.i26.i, %.93.i.i.i.i22.i
  %.107.i.i.i.i28.i = fmul contract double %.75.i.i, %.89.i.i.i.i20.i
  %.109.i.i.i.i29.i = fsub contract double %..i9.i, %.107.i.i.i.i28.i
  %.117.i.i.i.i30.i = fdiv contract double %.109.i.i.i.i29.i, %.93.i.i.i.i22.i
  br label %B0.endif.i.i31.i

B282.endif.i.i.i.i76.i:                           ; preds = %B282.i.i.i.i74.i
  %.143.i.i.i.i77.i = fdiv contract double %.70.i.i.i.i13.i, %.80.i.i.i.i11.i
  %.145.i.i.i.i78.i = fmul contract double %.70.i.i.i.i13.i, %.143.i.i.i.i77.i
  %.147.i.i.i.i79.i = fadd contract double %.80.i.i.i.i11.i, %.145.i.i.i.i78.i
  %.152.i.i.i.i80.i = fcmp contract oeq double %.147.i.i.i.i79.i, 0.000000e+00
  br i1 %.152.i.i.i.i80.i, label %_ZN17bnserve_surrogate8baseline10_amplitude22amplitude_coefficientsB4v184B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDAxYh_2bqJnA4AOzNAE_3dE10complex12810complex12810complex1285ArrayI10complex128Li1E1C7mutable7alignedE.exit.i.i, label %B282.endif.endif.i.i.i.i81.i, !prof !24

B282.endif.endif.i.i.i.i81.i:                     ; preds = %B282.endif.i.i.i.i76.i
  %.149.i.i.i.i82.i = fmul contract double %.75.i.i, %.143.i.i.i.i77.i
  %.151.i.i.i.i83.i = fadd contract double %..i9.i, %.149.i.i.i.i82.i
  %.159.i.i.i.i84.i = fdiv contract double %.151.i.i.i.i83.i, %.147.i.i.i.i79.i
  %.161.i.i.i.i85.i = fmul contract double %..i9.i, %.143.i.i.i.i77.i
  %.163.i.i.i.i86.i = fsub contract double %.161.i.i.i.i85.i, %.75.i.i
  %.171.i.i.i.i87.i = fdiv contract double %.163.i.i.i.i86.i, %.147.i.i.i.i79.i
  br label %B0.endif.i.i31.i

B0.endif.i.i31.i:                                 ; preds = %B282.endif.endif.i.i.i.i81.i, %B174.endif.endif.i.i.i.i24.i, %B270.i.i.i.i72.i
  %.22.sroa.4.0.i.i.i = phi double [ 0x7FF8000000000000, %B270.i.i.i.i72.i ], [ %.171.i.i.i.i87.i, %B282.endif.endif.i.i.i.i81.i ], [ %.117.i.i.i.i30.i, %B174.endif.endif.i.i.i.i24.i ]
  %.22.sroa.0.0.i.i.i = phi double [ 0x7FF8000000000000, %B270.i.i.i.i72.i ], [ %.159.i.i.i.i84.i, %B282.endif.endif.i.i.i.i81.i ], [ %.105.i.i.i.i27.i, %B174.endif.endif.i.i.i.i24.i ]
  %.56.i.i.i32.i = fcmp contract ult double %.45.i.i.i6.i, %..i9.i
  br i1 %.56.i.i.i32.i, label %B270.i.i.i56.i, label %B132.i.i.i33.i

B132.i.i.i33.i:                                   ; preds = %B0.endif.i.i31.i
  br i1 %.59.i.i.i7.i, label %_ZN17bnserve_surrogate8baseline10_amplitude22amplitude_coefficientsB4v184B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDAxYh_2bqJnA4AOzNAE_3dE10complex12810complex12810complex1285ArrayI10complex128Li1E1C7mutable7alignedE.exit.i.i, label %B174.endif.i.i.i34.i, !prof !76

B270.i.i.i56.i:                                   ; preds = %B0.endif.i.i31.i
  %.132.i.i.i57.i = fcmp contract ult double %..i9.i, %.45.i.i.i6.i
  br i1 %.132.i.i.i57.i, label %B0.endif.endif.i.i45.i, label %B282.i.i.i58.i

B282.i.i.i58.i:                                   ; preds = %B270.i.i.i56.i
  %.136.i.i.i59.i = fcmp contract oeq double %..i9.i, 0.000000e+00
  br i1 %.136.i.i.i59.i, label %_ZN17bnserve_surrogate8baseline10_amplitude22amplitude_coefficientsB4v184B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDAxYh_2bqJnA4AOzNAE_3dE10complex12810complex12810complex1285ArrayI10complex128Li1E1C7mutable7alignedE.exit.i.i, label %B282.endif.i.i.i60.i, !prof !24

B174.endif.i.i.i34.i:                             ; preds = %B132.i.i.i33.i
  %.89.i.i.i35.i = fdiv contract double %..i9.i, %.403.i.i
  %.91.i.i.i36.i = fmul contract double %..i9.i, %.89.i.i.i35.i
  %.93.i.i.i37.i = fadd contract double %.403.i.i, %.91.i.i.i36.i
  %.98.i.i.i38.i = fcmp contract oeq double %.93.i.i.i37.i, 0.000000e+00
  br i1 %.98.i.i.i38.i, label %_ZN17bnserve_surrogate8baseline10_amplitude22amplitude_coefficientsB4v184B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDAxYh_2bqJnA4AOzNAE_3dE10complex12810complex12810complex1285ArrayI10complex128Li1E1C7mutable7alignedE.exit.i.i, label %B174.endif.endif.i.i.i39.i, !prof !24

B174.endif.endif.i.i.i39.i:                       ; preds = %B174.endif.i.i.i34.i
  %.97.i.i.i40.i = fadd contract double %.77.i.i.i, %.91.i.i.i36.i
  %.105.i.i.i41.i = fdiv contract double %.97.i.i.i40.i, %.93.i.i.i37.i
  %.107.i.i.i42.i = fmul contract double %.77.i.i.i, %.89.i.i.i35.i
  %.109.i.i.i43.i = fsub contract double %..i9.i, %.107.i.i.i42.i
  %.117.i.i.i44.i = fdiv contract double %.109.i.i.i43.i, %.93.i.i.i37.i
  br label %B0.endif.endif.i.i45.i

B282.endif.i.i.i60.i:                             ; preds = %B282.i.i.i58.i
  %.143.i.i.i61.i = fdiv contract double %.403.i.i, %..i9.i
  %.145.i.i.i62.i = fmul contract double %.403.i.i, %.143.i.i.i61.i
  %.147.i.i.i63.i = fadd contract double %..i9.i, %.145.i.i.i62.i
  %.152.i.i.i64.i = fcmp contract oeq double %.147.i.i.i63.i, 0.000000e+00
  br i1 %.152.i.i.i64.i, label %_ZN17bnserve_surrogate8baseline10_amplitude22amplitude_coefficientsB4v184B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDAxYh_2bqJnA4AOzNAE_3dE10complex12810complex12810complex1285ArrayI10complex128Li1E1C7mutable7alignedE.exit.i.i, label %B282.endif.endif.i.i.i65.i, !prof !24

B282.endif.endif.i.i.i65.i:                       ; preds = %B282.endif.i.i.i60.i
  %.149.i.i.i66.i = fmul contract double %.77.i.i.i, %.143.i.i.i61.i
  %.151.i.i.i67.i = fadd contract double %..i9.i, %.149.i.i.i66.i
  %.159.i.i.i68.i = fdiv contract double %.151.i.i.i67.i, %.147.i.i.i63.i
  %.161.i.i.i69.i = fmul contract double %..i9.i, %.143.i.i.i61.i
  %.163.i.i.i70.i = fsub contract double %.161.i.i.i69.i, %.77.i.i.i
  %.171.i.i.i71.i = fdiv contract double %.163.i.i.i70.i, %.147.i.i.i63.i
  br label %B0.endif.endif.i.i45.i

B0.endif.endif.i.i45.i:                           ; preds = %B282.endif.endif.i.i.i65.i, %B174.endif.endif.i.i.i39.i, %B270.i.i.i56.i
  %.118.sroa.4.0.i.i.i = phi double [ 0x7FF8000000000000, %B270.i.i.i56.i ], [ %.171.i.i.i71.i, %B282.endif.endif.i.i.i65.i ], [ %.117.i.i.i44.i, %B174.endif.endif.i.i.i39.i ]
  %.118.sroa.0.0.i.i.i = phi double [ 0x7FF8000000000000, %B270.i.i.i56.i ], [ %.159.i.i.i68.i, %B282.endif.endif.i.i.i65.i ], [ %.105.i.i.i41.i, %B174.endif.endif.i.i.i39.i ]
  %.163.i.i.i = fadd contract double %.266.i.i, %.331.i.i
  %.166.i.i.i = fadd contract double %"$phi258.4.2.1.i.i", %"$phi368.4.2.1.i.i"
  %.58.i.i.i46.i = fmul contract double %.166.i.i.i, 5.000000e-01
  %.64.i.i.i47.i = fmul contract double %.163.i.i.i, 0.000000e+00
  %.80.i.i.i48.i = fadd contract double %.64.i.i.i47.i, %.58.i.i.i46.i
  %.46.i.i.i49.i = fmul contract double %.163.i.i.i, 5.000000e-01
  %.52.i.i.i50.i = fmul contract double %.166.i.i.i, 0.000000e+00
  %.70.i.i.i51.i = fsub contract double %.46.i.i.i49.i, %.52.i.i.i50.i
  %.58.i6.i.i.i = fmul contract double %.118.sroa.4.0.i.i.i, 5.000000e-01
  %.64.i7.i.i.i = fmul contract double %.118.sroa.0.0.i.i.i, 0.000000e+00
  %.80.i8.i.i.i = fadd contract double %.58.i6.i.i.i, %.64.i7.i.i.i
  %.46.i9.i.i.i = fmul contract double %.118.sroa.0.0.i.i.i, 5.000000e-01
  %.52.i10.i.i.i = fmul contract double %.118.sroa.4.0.i.i.i, 0.000000e+00
  %.70.i11.i.i.i = fsub contract double %.46.i9.i.i.i, %.52.i10.i.i.i
  %.257.i.i.i = fsub contract double %.266.i.i, %.331.i.i
  %.260.i.i.i = fsub contract double %"$phi258.4.2.1.i.i", %"$phi368.4.2.1.i.i"
  %.58.i13.i.i.i = fmul contract double %.260.i.i.i, %.70.i11.i.i.i
  %.64.i14.i.i.i = fmul contract double %.257.i.i.i, %.80.i8.i.i.i
  %.80.i15.i.i.i = fadd contract double %.64.i14.i.i.i, %.58.i13.i.i.i
  %.46.i16.i.i.i = fmul contract double %.257.i.i.i, %.70.i11.i.i.i
  %.52.i17.i.i.i = fmul contract double %.260.i.i.i, %.80.i8.i.i.i
  %.70.i18.i.i.i = fsub contract double %.46.i16.i.i.i, %.52.i17.i.i.i
  %.58.i20.i.i.i = fmul contract double %.257.i.i.i, %.260.i.i.i
  %.80.i22.i.i.i = fadd contract double %.58.i20.i.i.i, %.58.i20.i.i.i
  %.46.i23.i.i.i = fmul contract double %.257.i.i.i, %.257.i.i.i
  %.52.i24.i.i.i = fmul contract double %.260.i.i.i, %.260.i.i.i
  %.70.i25.i.i.i = fsub contract double %.46.i23.i.i.i, %.52.i24.i.i.i
  %.58.i27.i.i.i = fmul contract double %.80.i22.i.i.i, 2.500000e-01
  %.64.i28.i.i.i = fmul contract double %.70.i25.i.i.i, 0.000000e+00
  %.80.i29.i.i.i = fadd contract double %.64.i28.i.i.i, %.58.i27.i.i.i
  %.46.i30.i.i.i = fmul contract double %.70.i25.i.i.i, 2.500000e-01
  %.52.i31.i.i.i = fmul contract double %.80.i22.i.i.i, 0.000000e+00
  %.70.i32.i.i.i = fsub contract double %.46.i30.i.i.i, %.52.i31.i.i.i
  store double 1.000000e+00, ptr %arg.state.10.1.4, align 8, !noalias !88
  tail call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(24) %arg.out.4.repack1402.i.i.i, i8 0, i64 24, i1 false), !noalias !88
  %.58.i34.i.i.i = fmul contract double %.22.sroa.4.0.i.i.i, 0x400579E79E79E79E
  %.64.i35.i.i.i = fmul contract double %.22.sroa.0.0.i.i.i, 0.000000e+00
  %.80.i36.i.i.i = fadd contract double %.58.i34.i.i.i, %.64.i35.i.i.i
  %.46.i37.i.i.i = fmul contract double %.22.sroa.0.0.i.i.i, 0x400579E79E79E79E
  %.52.i38.i.i.i = fmul contract double %.22.sroa.4.0.i.i.i, 0.000000e+00
  %.70.i39.i.i.i = fsub contract double %.46.i37.i.i.i, %.52.i38.i.i.i
  %.559.i.i.i = fadd contract double %.70.i39.i.i.i, 0xBFF7124924924925
  %.562.i.i.i = fadd contract double %.80.i36.i.i.i, 0.000000e+00
  store double %.559.i.i.i, ptr %.593.i.i.i, align 8, !noalias !88
  store double %.562.i.i.i, ptr %.593.repack1404.i.i.i, align 8, !noalias !88
  %.58.i41.i.i.i = fmul contract double %.80.i15.i.i.i, 3.375000e+00
  %.64.i42.i.i.i = fmul contract double %.70.i18.i.i.i, 0.000000e+00
  %.80.i43.i.i.i = fadd contract double %.64.i42.i.i.i, %.58.i41.i.i.i
  %.46.i44.i.i.i = fmul contract double %.70.i18.i.i.i, 3.375000e+00
  %.52.i45.i.i.i = fmul contract double %.80.i15.i.i.i, 0.000000e+00
  %.70.i46.i.i.i = fsub contract double %.46.i44.i.i.i, %.52.i45.i.i.i
  %.58.i48.i.i.i = fmul contract double %.22.sroa.4.0.i.i.i, 0x3FFD555555555555
  %.80.i50.i.i.i = fadd contract double %.58.i48.i.i.i, %.64.i35.i.i.i
  %.46.i51.i.i.i = fmul contract double %.22.sroa.0.0.i.i.i, 0x3FFD555555555555
  %41 = fsub contract double %.52.i38.i.i.i, %.46.i51.i.i.i
  %.692.i.i.i = fadd contract double %41, 3.375000e+00
  %.695.i.i.i = fsub contract double 0.000000e+00, %.80.i50.i.i.i
  %.58.i55.i.i.i = fmul contract double %.80.i.i.i48.i, %.692.i.i.i
  %.64.i56.i.i.i = fmul contract double %.70.i.i.i51.i, %.695.i.i.i
  %.80.i57.i.i.i = fadd contract double %.64.i56.i.i.i, %.58.i55.i.i.i
  %.46.i58.i.i.i = fmul contract double %.70.i.i.i51.i, %.692.i.i.i
  %.52.i59.i.i.i = fmul contract double %.80.i.i.i48.i, %.695.i.i.i
  %.70.i60.i.i.i = fsub contract double %.46.i58.i.i.i, %.52.i59.i.i.i
  %.744.i.i.i = fadd contract double %.70.i60.i.i.i, %.70.i46.i.i.i
  %.747.i.i.i = fadd contract double %.80.i57.i.i.i, %.80.i43.i.i.i
  store double %.744.i.i.i, ptr %.778.i.i.i, align 8, !noalias !88
  store double %.747.i.i.i, ptr %.778.repack1406.i.i.i, align 8, !noalias !88
  %.58.i62.i.i.i = fmul contract double %.22.sroa.4.0.i.i.i, 0x401167EA53FA94FF
  %.80.i64.i.i.i = fadd contract double %.58.i62.i.i.i, %.64.i35.i.i.i
  %.46.i65.i.i.i = fmul contract double %.22.sroa.0.0.i.i.i, 0x401167EA53FA94FF
  %.70.i67.i.i.i = fsub contract double %.46.i65.i.i.i, %.52.i38.i.i.i
  %.843.i.i.i = fadd contract double %.70.i67.i.i.i, 0xC0175371959340D3
  %.846.i.i.i = fadd contract double %.80.i64.i.i.i, 0.000000e+00
  %.58.i69.i.i.i = fmul contract double %.22.sroa.0.0.i.i.i, %.846.i.i.i
  %.64.i70.i.i.i = fmul contract double %.22.sroa.4.0.i.i.i, %.843.i.i.i
  %.80.i71.i.i.i = fadd contract double %.64.i70.i.i.i, %.58.i69.i.i.i
  %.46.i72.i.i.i = fmul contract double %.22.sroa.0.0.i.i.i, %.843.i.i.i
  %.52.i73.i.i.i = fmul contract double %.22.sroa.4.0.i.i.i, %.846.i.i.i
  %.70.i74.i.i.i = fsub contract double %.46.i72.i.i.i, %.52.i73.i.i.i
  %.903.i.i.i = fadd contract double %.70.i74.i.i.i, 0xC00AE15A0AB4FC95
  %.906.i.i.i = fadd contract double %.80.i71.i.i.i, 0.000000e+00
  store double %.903.i.i.i, ptr %.937.i.i.i, align 8, !noalias !88
  store double %.906.i.i.i, ptr %.937.repack1408.i.i.i, align 8, !noalias !88
  %.58.i76.i.i.i = fmul contract double %.22.sroa.4.0.i.i.i, 6.000000e+00
  %.80.i78.i.i.i = fadd contract double %.58.i76.i.i.i, %.64.i35.i.i.i
  %.46.i79.i.i.i = fmul contract double %.22.sroa.0.0.i.i.i, 6.000000e+00
  %.70.i81.i.i.i = fsub contract double %.46.i79.i.i.i, %.52.i38.i.i.i
  %.1034.i.i.i = fadd contract double %.70.i81.i.i.i, -1.531250e+00
  %.1037.i.i.i = fadd contract double %.80.i78.i.i.i, 0.000000e+00
  %.58.i83.i.i.i = fmul contract double %.80.i29.i.i.i, %.1034.i.i.i
  %.64.i84.i.i.i = fmul contract double %.70.i32.i.i.i, %.1037.i.i.i
  %.80.i85.i.i.i = fadd contract double %.64.i84.i.i.i, %.58.i83.i.i.i
  %.46.i86.i.i.i = fmul contract double %.70.i32.i.i.i, %.1034.i.i.i
  %.52.i87.i.i.i = fmul contract double %.80.i29.i.i.i, %.1037.i.i.i
  %.70.i88.i.i.i = fsub contract double %.46.i86.i.i.i, %.52.i87.i.i.i
  %.58.i90.i.i.i = fmul contract double %.80.i15.i.i.i, 3.062500e+00
  %.80.i92.i.i.i = fadd contract double %.64.i42.i.i.i, %.58.i90.i.i.i
  %.46.i93.i.i.i = fmul contract double %.70.i18.i.i.i, 3.062500e+00
  %.70.i95.i.i.i = fsub contract double %.46.i93.i.i.i, %.52.i45.i.i.i
  %.58.i97.i.i.i = fmul contract double %.80.i.i.i48.i, %.70.i95.i.i.i
  %.64.i98.i.i.i = fmul contract double %.70.i.i.i51.i, %.80.i92.i.i.i
  %.80.i99.i.i.i = fadd contract double %.64.i98.i.i.i, %.58.i97.i.i.i
  %.46.i100.i.i.i = fmul contract double %.70.i.i.i51.i, %.70.i95.i.i.i
  %.52.i101.i.i.i = fmul contract double %.80.i.i.i48.i, %.80.i92.i.i.i
  %.70.i102.i.i.i = fsub contract double %.46.i100.i.i.i, %.52.i101.i.i.i
  %.1146.i.i.i = fsub contract double %.70.i88.i.i.i, %.70.i102.i.i.i
  %.1149.i.i.i = fsub contract double %.80.i85.i.i.i, %.80.i99.i.i.i
  %.1172.i.i.i = fadd contract double %.903.i.i.i, %.1146.i.i.i
  %.1175.i.i.i = fadd contract double %.906.i.i.i, %.1149.i.i.i
  store double %.1172.i.i.i, ptr %.937.i.i.i, align 8, !noalias !88
  store double %.1175.i.i.i, ptr %.937.repack1408.i.i.i, align 8, !noalias !88
  %.97.i108.i.i.i = fadd contract double %.22.sroa.0.0.i.i.i, %.52.i38.i.i.i
  %.105.i109.i.i.i = fmul contract double %.97.i108.i.i.i, 1.250000e-01
  %.109.i111.i.i.i = fsub contract double %.22.sroa.4.0.i.i.i, %.64.i35.i.i.i
  %.117.i112.i.i.i = fmul contract double %.109.i111.i.i.i, 1.250000e-01
  %.58.i118.i.i.i = fmul contract double %.70.i.i.i51.i, %.80.i.i.i48.i
  %.80.i120.i.i.i = fadd contract double %.58.i118.i.i.i, %.58.i118.i.i.i
  %.46.i121.i.i.i = fmul contract double %.70.i.i.i51.i, %.70.i.i.i51.i
  %.52.i122.i.i.i = fmul contract double %.80.i.i.i48.i, %.80.i.i.i48.i
  %.70.i123.i.i.i = fsub contract double %.46.i121.i.i.i, %.52.i122.i.i.i
  %.1306.i.i.i = fadd contract double %.117.i112.i.i.i, 0.000000e+00
  %.1303.i.i.i = fadd contract double %.105.i109.i.i.i, -1.531250e+00
  %.58.i125.i.i.i = fmul contract double %.80.i120.i.i.i, %.1303.i.i.i
  %.64.i126.i.i.i = fmul contract double %.70.i123.i.i.i, %.1306.i.i.i
  %.80.i127.i.i.i = fadd contract double %.58.i125.i.i.i, %.64.i126.i.i.i
  %.46.i128.i.i.i = fmul contract double %.70.i123.i.i.i, %.1303.i.i.i
  %.52.i129.i.i.i = fmul contract double %.80.i120.i.i.i, %.1306.i.i.i
  %.70.i130.i.i.i = fsub contract double %.46.i128.i.i.i, %.52.i129.i.i.i
  %.1425.i.i.i = fadd contract double %.70.i130.i.i.i, %.1172.i.i.i
  %.1428.i.i.i = fadd contract double %.80.i127.i.i.i, %.1175.i.i.i
  store double %.1425.i.i.i, ptr %.937.i.i.i, align 8, !noalias !88
  store double %.1428.i.i.i, ptr %.937.repack1408.i.i.i, align 8, !noalias !88
  %.58.i132.i.i.i = fmul contract double %.22.sroa.4.0.i.i.i, 4.000000e+00
  %.80.i134.i.i.i = fadd contract double %.58.i132.i.i.i, %.64.i35.i.i.i
  %.46.i135.i.i.i = fmul contract double %.22.sroa.0.0.i.i.i, 4.000000e+00
  %42 = fsub contract double %.52.i38.i.i.i, %.46.i135.i.i.i
  %.1525.i.i.i = fadd contract double %42, 1.000000e+00
  %.1528.i.i.i = fsub contract double 0.000000e+00, %.80.i134.i.i.i
  %.58.i139.i.i.i = fmul contract double %.1528.i.i.i, 0x4010B090E5F545F2
  %.64.i140.i.i.i = fmul contract double %.1525.i.i.i, 0.000000e+00
  %43 = fsub contract double %.64.i140.i.i.i, %.58.i139.i.i.i
  %.46.i142.i.i.i = fmul contract double %.1525.i.i.i, 0xC010B090E5F545F2
  %.52.i143.i.i.i = fmul contract double %.1528.i.i.i, 0.000000e+00
  %.70.i144.i.i.i = fsub contract double %.46.i142.i.i.i, %.52.i143.i.i.i
  %.58.i146.i.i.i = fmul contract double %.22.sroa.4.0.i.i.i, 0x3FD9104104104104
  %.80.i148.i.i.i = fadd contract double %.58.i146.i.i.i, %.64.i35.i.i.i
  %.46.i149.i.i.i = fmul contract double %.22.sroa.0.0.i.i.i, 0x3FD9104104104104
  %44 = fsub contract double %.52.i38.i.i.i, %.46.i149.i.i.i
  %.1627.i.i.i = fadd contract double %44, 0x4031AEEFBEFBEFBF
  %.1630.i.i.i = fsub contract double 0.000000e+00, %.80.i148.i.i.i
  %.58.i153.i.i.i = fmul contract double %.1627.i.i.i, %.80.i15.i.i.i
  %.64.i154.i.i.i = fmul contract double %.1630.i.i.i, %.70.i18.i.i.i
  %.80.i155.i.i.i = fadd contract double %.64.i154.i.i.i, %.58.i153.i.i.i
  %.46.i156.i.i.i = fmul contract double %.1627.i.i.i, %.70.i18.i.i.i
  %.52.i157.i.i.i = fmul contract double %.1630.i.i.i, %.80.i15.i.i.i
  %.70.i158.i.i.i = fsub contract double %.46.i156.i.i.i, %.52.i157.i.i.i
  %.1679.i.i.i = fadd contract double %.70.i144.i.i.i, %.70.i158.i.i.i
  %.1682.i.i.i = fadd contract double %43, %.80.i155.i.i.i
  store double %.1679.i.i.i, ptr %.1713.i.i.i, align 8, !noalias !88
  store double %.1682.i.i.i, ptr %.1713.repack1414.i.i.i, align 8, !noalias !88
  %.58.i160.i.i.i = fmul contract double %.22.sroa.4.0.i.i.i, 0x4001ACB2CB2CB2CB
  %.80.i162.i.i.i = fadd contract double %.58.i160.i.i.i, %.64.i35.i.i.i
  %.46.i163.i.i.i = fmul contract double %.22.sroa.0.0.i.i.i, 0x4001ACB2CB2CB2CB
  %.70.i165.i.i.i = fsub contract double %.46.i163.i.i.i, %.52.i38.i.i.i
  %.1810.i.i.i = fadd contract double %.70.i165.i.i.i, 0x4036CB0C30C30C31
  %.1813.i.i.i = fadd contract double %.80.i162.i.i.i, 0.000000e+00
  %.58.i167.i.i.i = fmul contract double %.22.sroa.0.0.i.i.i, %.1813.i.i.i
  %.64.i168.i.i.i = fmul contract double %.22.sroa.4.0.i.i.i, %.1810.i.i.i
  %.80.i169.i.i.i = fadd contract double %.64.i168.i.i.i, %.58.i167.i.i.i
  %.46.i170.i.i.i = fmul contract double %.22.sroa.0.0.i.i.i, %.1810.i.i.i
  %.52.i171.i.i.i = fmul contract double %.22.sroa.4.0.i.i.i, %.1813.i.i.i
  %45 = fsub contract double %.52.i171.i.i.i, %.46.i170.i.i.i
  %.1870.i.i.i = fadd contract double %45, 0x4031AEEFBEFBEFBF
  %.1873.i.i.i = fsub contract double 0.000000e+00, %.80.i169.i.i.i
  %.58.i174.i.i.i = fmul contract double %.80.i.i.i48.i, %.1870.i.i.i
  %.64.i175.i.i.i = fmul contract double %.70.i.i.i51.i, %.1873.i.i.i
  %.80.i176.i.i.i = fadd contract double %.64.i175.i.i.i, %.58.i174.i.i.i
  %.46.i177.i.i.i = fmul contract double %.70.i.i.i51.i, %.1870.i.i.i
  %.52.i178.i.i.i = fmul contract double %.80.i.i.i48.i, %.1873.i.i.i
  %.70.i179.i.i.i = fsub contract double %.46.i177.i.i.i, %.52.i178.i.i.i
  %.1922.i.i.i = fadd contract double %.70.i179.i.i.i, %.1679.i.i.i
  %.1925.i.i.i = fadd contract double %.80.i176.i.i.i, %.1682.i.i.i
  store double %.1922.i.i.i, ptr %.1713.i.i.i, align 8, !noalias !88
  store double %.1925.i.i.i, ptr %.1713.repack1414.i.i.i, align 8, !noalias !88
  %.64.i186.i.i.i = fmul contract double %.22.sroa.4.0.i.i.i, 0x4050B13F2FF5EE90
  %.80.i187.i.i.i = fadd contract double %.64.i186.i.i.i, %.64.i35.i.i.i
  %.46.i188.i.i.i = fmul contract double %.22.sroa.0.0.i.i.i, 0x4050B13F2FF5EE90
  %.70.i190.i.i.i = fsub contract double %.46.i188.i.i.i, %.52.i38.i.i.i
  %.2047.i.i.i = fadd contract double %.70.i190.i.i.i, 0xC034AE5A84540D99
  %.2050.i.i.i = fadd contract double %.80.i187.i.i.i, 0.000000e+00
  store double %.2047.i.i.i, ptr %.2081.i.i.i, align 8, !noalias !88
  store double %.2050.i.i.i, ptr %.2081.repack1418.i.i.i, align 8, !noalias !88
  %.58.i192.i.i.i = fmul contract double %.22.sroa.4.0.i.i.i, %.22.sroa.0.0.i.i.i
  %.80.i194.i.i.i = fadd contract double %.58.i192.i.i.i, %.58.i192.i.i.i
  %.46.i195.i.i.i = fmul contract double %.22.sroa.0.0.i.i.i, %.22.sroa.0.0.i.i.i
  %.52.i196.i.i.i = fmul contract double %.22.sroa.4.0.i.i.i, %.22.sroa.4.0.i.i.i
  %.70.i197.i.i.i = fsub contract double %.46.i195.i.i.i, %.52.i196.i.i.i
  %.58.i199.i.i.i = fmul contract double %.22.sroa.4.0.i.i.i, 0x401597306EFC97DE
  %.80.i201.i.i.i = fadd contract double %.58.i199.i.i.i, %.64.i35.i.i.i
  %.46.i202.i.i.i = fmul contract double %.22.sroa.0.0.i.i.i, 0x401597306EFC97DE
  %.70.i204.i.i.i = fsub contract double %.46.i202.i.i.i, %.52.i38.i.i.i
  %.2248.i.i.i = fadd contract double %.70.i204.i.i.i, 0xC0322AE304374842
  %.2251.i.i.i = fadd contract double %.80.i201.i.i.i, 0.000000e+00
  %.58.i206.i.i.i = fmul contract double %.70.i197.i.i.i, %.2251.i.i.i
  %.64.i207.i.i.i = fmul contract double %.80.i194.i.i.i, %.2248.i.i.i
  %.80.i208.i.i.i = fadd contract double %.64.i207.i.i.i, %.58.i206.i.i.i
  %.46.i209.i.i.i = fmul contract double %.70.i197.i.i.i, %.2248.i.i.i
  %.52.i210.i.i.i = fmul contract double %.80.i194.i.i.i, %.2251.i.i.i
  %.70.i211.i.i.i = fsub contract double %.46.i209.i.i.i, %.52.i210.i.i.i
  %.2300.i.i.i = fadd contract double %.2047.i.i.i, %.70.i211.i.i.i
  %.2303.i.i.i = fadd contract double %.2050.i.i.i, %.80.i208.i.i.i
  store double %.2300.i.i.i, ptr %.2081.i.i.i, align 8, !noalias !88
  store double %.2303.i.i.i, ptr %.2081.repack1418.i.i.i, align 8, !noalias !88
  %.58.i213.i.i.i = fmul contract double %.80.i15.i.i.i, 0x4004AAAAAAAAAAAB
  %.80.i215.i.i.i = fadd contract double %.64.i42.i.i.i, %.58.i213.i.i.i
  %.46.i216.i.i.i = fmul contract double %.70.i18.i.i.i, 0x4004AAAAAAAAAAAB
  %.70.i218.i.i.i = fsub contract double %.46.i216.i.i.i, %.52.i45.i.i.i
  %.58.i220.i.i.i = fmul contract double %.22.sroa.4.0.i.i.i, 0x4002AAAAAAAAAAAB
  %.80.i222.i.i.i = fadd contract double %.58.i220.i.i.i, %.64.i35.i.i.i
  %.46.i223.i.i.i = fmul contract double %.22.sroa.0.0.i.i.i, 0x4002AAAAAAAAAAAB
  %46 = fsub contract double %.52.i38.i.i.i, %.46.i223.i.i.i
  %.2465.i.i.i = fadd contract double %46, 0x4004AAAAAAAAAAAB
  %.2468.i.i.i = fsub contract double 0.000000e+00, %.80.i222.i.i.i
  %.58.i227.i.i.i = fmul contract double %.80.i.i.i48.i, %.2465.i.i.i
  %.64.i228.i.i.i = fmul contract double %.70.i.i.i51.i, %.2468.i.i.i
  %.80.i229.i.i.i = fadd contract double %.64.i228.i.i.i, %.58.i227.i.i.i
  %.46.i230.i.i.i = fmul contract double %.70.i.i.i51.i, %.2465.i.i.i
  %.52.i231.i.i.i = fmul contract double %.80.i.i.i48.i, %.2468.i.i.i
  %.70.i232.i.i.i = fsub contract double %.46.i230.i.i.i, %.52.i231.i.i.i
  %.2517.i.i.i = fadd contract double %.70.i232.i.i.i, %.70.i218.i.i.i
  %.2520.i.i.i = fadd contract double %.80.i229.i.i.i, %.80.i215.i.i.i
  %.58.i234.i.i.i = fmul contract double %.2520.i.i.i, 0x400921FB54442D18
  %.64.i235.i.i.i = fmul contract double %.2517.i.i.i, 0.000000e+00
  %.80.i236.i.i.i = fadd contract double %.64.i235.i.i.i, %.58.i234.i.i.i
  %.46.i237.i.i.i = fmul contract double %.2517.i.i.i, 0x400921FB54442D18
  %.52.i238.i.i.i = fmul contract double %.2520.i.i.i, 0.000000e+00
  %.70.i239.i.i.i = fsub contract double %.46.i237.i.i.i, %.52.i238.i.i.i
  %.2577.i.i.i = fadd contract double %.2300.i.i.i, %.70.i239.i.i.i
  %.2580.i.i.i = fadd contract double %.2303.i.i.i, %.80.i236.i.i.i
  store double %.2577.i.i.i, ptr %.2081.i.i.i, align 8, !noalias !88
  store double %.2580.i.i.i, ptr %.2081.repack1418.i.i.i, align 8, !noalias !88
  %.58.i241.i.i.i = fmul contract double %.22.sroa.4.0.i.i.i, 0x4017618618618618
  %.80.i243.i.i.i = fadd contract double %.58.i241.i.i.i, %.64.i35.i.i.i
  %.46.i244.i.i.i = fmul contract double %.22.sroa.0.0.i.i.i, 0x4017618618618618
  %.70.i246.i.i.i = fsub contract double %.46.i244.i.i.i, %.52.i38.i.i.i
  %.2708.i.i.i = fadd contract double %.70.i246.i.i.i, 0x404C130E38E38E39
  %.2711.i.i.i = fadd contract double %.80.i243.i.i.i, 0.000000e+00
  %.58.i248.i.i.i = fmul contract double %.22.sroa.0.0.i.i.i, %.2711.i.i.i
  %.64.i249.i.i.i = fmul contract double %.22.sroa.4.0.i.i.i, %.2708.i.i.i
  %.80.i250.i.i.i = fadd contract double %.64.i249.i.i.i, %.58.i248.i.i.i
  %.46.i251.i.i.i = fmul contract double %.22.sroa.0.0.i.i.i, %.2708.i.i.i
  %.52.i252.i.i.i = fmul contract double %.22.sroa.4.0.i.i.i, %.2711.i.i.i
  %.70.i253.i.i.i = fsub contract double %.46.i251.i.i.i, %.52.i252.i.i.i
  %.2768.i.i.i = fadd contract double %.70.i253.i.i.i, 0xC02B20D145145145
  %.2771.i.i.i = fadd contract double %.80.i250.i.i.i, 0.000000e+00
  %.58.i255.i.i.i = fmul contract double %.80.i29.i.i.i, %.2768.i.i.i
  %.64.i256.i.i.i = fmul contract double %.70.i32.i.i.i, %.2771.i.i.i
  %.80.i257.i.i.i = fadd contract double %.64.i256.i.i.i, %.58.i255.i.i.i
  %.46.i258.i.i.i = fmul contract double %.70.i32.i.i.i, %.2768.i.i.i
  %.52.i259.i.i.i = fmul contract double %.80.i29.i.i.i, %.2771.i.i.i
  %.70.i260.i.i.i = fsub contract double %.46.i258.i.i.i, %.52.i259.i.i.i
  %.2820.i.i.i = fadd contract double %.70.i260.i.i.i, %.2577.i.i.i
  %.2823.i.i.i = fadd contract double %.80.i257.i.i.i, %.2580.i.i.i
  store double %.2820.i.i.i, ptr %.2081.i.i.i, align 8, !noalias !88
  store double %.2823.i.i.i, ptr %.2081.repack1418.i.i.i, align 8, !noalias !88
  %.58.i262.i.i.i = fmul contract double %.22.sroa.4.0.i.i.i, 0x4043F51861861862
  %.80.i264.i.i.i = fadd contract double %.58.i262.i.i.i, %.64.i35.i.i.i
  %.46.i265.i.i.i = fmul contract double %.22.sroa.0.0.i.i.i, 0x4043F51861861862
  %.70.i267.i.i.i = fsub contract double %.46.i265.i.i.i, %.52.i38.i.i.i
  %.2951.i.i.i = fadd contract double %.70.i267.i.i.i, 0xC03B20D145145145
  %.2954.i.i.i = fadd contract double %.80.i264.i.i.i, 0.000000e+00
  %.58.i269.i.i.i = fmul contract double %.2951.i.i.i, %.80.i15.i.i.i
  %.64.i270.i.i.i = fmul contract double %.2954.i.i.i, %.70.i18.i.i.i
  %.80.i271.i.i.i = fadd contract double %.64.i270.i.i.i, %.58.i269.i.i.i
  %.46.i272.i.i.i = fmul contract double %.2951.i.i.i, %.70.i18.i.i.i
  %.52.i273.i.i.i = fmul contract double %.2954.i.i.i, %.80.i15.i.i.i
  %.70.i274.i.i.i = fsub contract double %.46.i272.i.i.i, %.52.i273.i.i.i
  %.58.i276.i.i.i = fmul contract double %.80.i.i.i48.i, %.70.i274.i.i.i
  %.64.i277.i.i.i = fmul contract double %.70.i.i.i51.i, %.80.i271.i.i.i
  %.80.i278.i.i.i = fadd contract double %.64.i277.i.i.i, %.58.i276.i.i.i
  %.46.i279.i.i.i = fmul contract double %.70.i.i.i51.i, %.70.i274.i.i.i
  %.52.i280.i.i.i = fmul contract double %.80.i.i.i48.i, %.80.i271.i.i.i
  %.70.i281.i.i.i = fsub contract double %.46.i279.i.i.i, %.52.i280.i.i.i
  %.3029.i.i.i = fadd contract double %.70.i281.i.i.i, %.2820.i.i.i
  %.3032.i.i.i = fadd contract double %.80.i278.i.i.i, %.2823.i.i.i
  store double %.3029.i.i.i, ptr %.2081.i.i.i, align 8, !noalias !88
  store double %.3032.i.i.i, ptr %.2081.repack1418.i.i.i, align 8, !noalias !88
  %.58.i283.i.i.i = fmul contract double %.22.sroa.4.0.i.i.i, 0x402975F7DF7DF7DF
  %.80.i285.i.i.i = fadd contract double %.58.i283.i.i.i, %.64.i35.i.i.i
  %.46.i286.i.i.i = fmul contract double %.22.sroa.0.0.i.i.i, 0x402975F7DF7DF7DF
  %47 = fsub contract double %.52.i38.i.i.i, %.46.i286.i.i.i
  %.3160.i.i.i = fadd contract double %47, 0x404302DB6DB6DB6E
  %.3163.i.i.i = fsub contract double 0.000000e+00, %.80.i285.i.i.i
  %.58.i290.i.i.i = fmul contract double %.22.sroa.0.0.i.i.i, %.3163.i.i.i
  %.64.i291.i.i.i = fmul contract double %.22.sroa.4.0.i.i.i, %.3160.i.i.i
  %.80.i292.i.i.i = fadd contract double %.64.i291.i.i.i, %.58.i290.i.i.i
  %.46.i293.i.i.i = fmul contract double %.22.sroa.0.0.i.i.i, %.3160.i.i.i
  %.52.i294.i.i.i = fmul contract double %.22.sroa.4.0.i.i.i, %.3163.i.i.i
  %.70.i295.i.i.i = fsub contract double %.46.i293.i.i.i, %.52.i294.i.i.i
  %.3223.i.i.i = fadd contract double %.80.i292.i.i.i, 0.000000e+00
  %.3220.i.i.i = fadd contract double %.70.i295.i.i.i, 0xC02B20D145145145
  %.58.i304.i.i.i = fmul contract double %.80.i120.i.i.i, %.3220.i.i.i
  %.64.i305.i.i.i = fmul contract double %.70.i123.i.i.i, %.3223.i.i.i
  %.80.i306.i.i.i = fadd contract double %.64.i305.i.i.i, %.58.i304.i.i.i
  %.46.i307.i.i.i = fmul contract double %.70.i123.i.i.i, %.3220.i.i.i
  %.52.i308.i.i.i = fmul contract double %.80.i120.i.i.i, %.3223.i.i.i
  %.70.i309.i.i.i = fsub contract double %.46.i307.i.i.i, %.52.i308.i.i.i
  %.3342.i.i.i = fadd contract double %.70.i309.i.i.i, %.3029.i.i.i
  %.3345.i.i.i = fadd contract double %.80.i306.i.i.i, %.3032.i.i.i
  store double %.3342.i.i.i, ptr %.2081.i.i.i, align 8, !noalias !88
  store double %.3345.i.i.i, ptr %.2081.repack1418.i.i.i, align 8, !noalias !88
  %.58.i311.i.i.i = fmul contract double %.22.sroa.4.0.i.i.i, 0x402001CC877321DD
  %.80.i313.i.i.i = fadd contract double %.58.i311.i.i.i, %.64.i35.i.i.i
  %.46.i314.i.i.i = fmul contract double %.22.sroa.0.0.i.i.i, 0x402001CC877321DD
  %48 = fsub contract double %.52.i38.i.i.i, %.46.i314.i.i.i
  %.3441.i.i.i = fadd contract double %48, 0x403044E0D8B8362E
  %.3444.i.i.i = fsub contract double 0.000000e+00, %.80.i313.i.i.i
  %.58.i318.i.i.i = fmul contract double %.22.sroa.0.0.i.i.i, %.3444.i.i.i
  %.64.i319.i.i.i = fmul contract double %.22.sroa.4.0.i.i.i, %.3441.i.i.i
  %.80.i320.i.i.i = fadd contract double %.64.i319.i.i.i, %.58.i318.i.i.i
  %.46.i321.i.i.i = fmul contract double %.22.sroa.0.0.i.i.i, %.3441.i.i.i
  %.52.i322.i.i.i = fmul contract double %.22.sroa.4.0.i.i.i, %.3444.i.i.i
  %49 = fsub contract double %.52.i322.i.i.i, %.46.i321.i.i.i
  %.3501.i.i.i = fadd contract double %49, 0x400A4763546E2A71
  %.3504.i.i.i = fsub contract double 0.000000e+00, %.80.i320.i.i.i
  %.58.i325.i.i.i = fmul contract double %.3504.i.i.i, 0x400921FB54442D18
  %.64.i326.i.i.i = fmul contract double %.3501.i.i.i, 0.000000e+00
  %.80.i327.i.i.i = fadd contract double %.64.i326.i.i.i, %.58.i325.i.i.i
  %.46.i328.i.i.i = fmul contract double %.3501.i.i.i, 0x400921FB54442D18
  %.52.i329.i.i.i = fmul contract double %.3504.i.i.i, 0.000000e+00
  %.70.i330.i.i.i = fsub contract double %.46.i328.i.i.i, %.52.i329.i.i.i
  store double %.70.i330.i.i.i, ptr %.3569.i.i.i, align 8, !noalias !88
  store double %.80.i327.i.i.i, ptr %.3569.repack1430.i.i.i, align 8, !noalias !88
  br label %_ZN17bnserve_surrogate8baseline10_amplitude22amplitude_coefficientsB4v184B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDAxYh_2bqJnA4AOzNAE_3dE10complex12810complex12810complex1285ArrayI10complex128Li1E1C7mutable7alignedE.exit.i.i

_ZN17bnserve_surrogate8baseline10_amplitude22amplitude_coefficientsB4v184B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDAxYh_2bqJnA4AOzNAE_3dE10complex12810complex12810complex1285ArrayI10complex128Li1E1C7mutable7alignedE.exit.i.i: ; preds = %B0.endif.endif.i.i45.i, %B282.endif.i.i.i60.i, %B174.endif.i.i.i34.i, %B282.i.i.i58.i, %B132.i.i.i33.i, %B282.endif.i.i.i.i76.i, %B174.endif.i.i.i.i19.i, %B282.i.i.i.i74.i, %B132.i.i.i.i17.i
  %excinfo.1.1.i.i = phi ptr [ %excinfo.1.0.i.i, %B0.endif.endif.i.i45.i ], [ null, %B132.i.i.i.i17.i ], [ null, %B174.endif.i.i.i.i19.i ], [ null, %B282.i.i.i.i74.i ], [ null, %B282.endif.i.i.i.i76.i ], [ null, %B282.endif.i.i.i60.i ], [ null, %B282.i.i.i58.i ], [ null, %B174.endif.i.i.i34.i ], [ null, %B132.i.i.i33.i ]
  %cond.i52.i = phi i1 [ true, %B0.endif.endif.i.i45.i ], [ false, %B132.i.i.i.i17.i ], [ false, %B174.endif.i.i.i.i19.i ], [ false, %B282.i.i.i.i74.i ], [ false, %B282.endif.i.i.i.i76.i ], [ false, %B282.endif.i.i.i60.i ], [ false, %B282.i.i.i58.i ], [ false, %B174.endif.i.i.i34.i ], [ false, %B132.i.i.i33.i ]
  br i1 %cond.i52.i, label %B368.endif.i.i, label %_ZN17bnserve_surrogate8tangents8_carrier15prepare_splinesB4v144B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE692Row_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20int64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_203_29_2c_20UniTuple_28array_28float64_2c_201d_2c_20C_29_20x_202_29_2c_20UniTuple_28array_28int64_2c_201d_2c_20C_29_20x_202_29_2c_20UniTuple_28array_28float64_2c_201d_2c_20C_29_20x_202_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29.exit, !prof !20

B368.endif.i.i:                                   ; preds = %_ZN17bnserve_surrogate8baseline10_amplitude22amplitude_coefficientsB4v184B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDAxYh_2bqJnA4AOzNAE_3dE10complex12810complex12810complex1285ArrayI10complex128Li1E1C7mutable7alignedE.exit.i.i
  %"$phi490.1.2.1.i.i" = select i1 %.202.i.i, double %.409.i.i, double 0.000000e+00
  %.570.i.i = load double, ptr %arg.state.10.1.4, align 8, !noalias !84
  %.572.i.i = load double, ptr %arg.out.4.repack1402.i.i.i, align 8, !noalias !84
  %.582.i.i = fdiv contract double %.572.i.i, 1.000000e-30
  %.623.i.i = fmul contract double %"$phi490.1.2.1.i.i", %.570.i.i
  %.624.i.i = fadd contract double %.623.i.i, %.582.i.i
  %sunkaddr20.i.i = getelementptr i8, ptr %.3002.i, i64 %lsr.iv.i8.i
  store double %.624.i.i, ptr %sunkaddr20.i.i, align 8, !noalias !84
  %.570.1.i.i = load double, ptr %sunkaddr23.i.i, align 8, !noalias !84
  %.572.1.i.i = load double, ptr %sunkaddr24.i.i, align 8, !noalias !84
  %.582.1.i.i = fdiv contract double %.572.1.i.i, 1.000000e-30
  %.623.1.i.i = fmul contract double %"$phi490.1.2.1.i.i", %.570.1.i.i
  %.624.1.i.i = fadd contract double %.623.1.i.i, %.582.1.i.i
  %sunkaddr26.i.i = getelementptr i8, ptr %sunkaddr20.i.i, i64 8
  store double %.624.1.i.i, ptr %sunkaddr26.i.i, align 8, !noalias !84
  %.570.2.i.i = load double, ptr %.593.i.i.i, align 8, !noalias !84
  %.572.2.i.i = load double, ptr %.593.repack1404.i.i.i, align 8, !noalias !84
  %.582.2.i.i = fdiv contract double %.572.2.i.i, 1.000000e-30
  %.623.2.i.i = fmul contract double %"$phi490.1.2.1.i.i", %.570.2.i.i
  %.624.2.i.i = fadd contract double %.623.2.i.i, %.582.2.i.i
  %sunkaddr30.i.i = getelementptr i8, ptr %sunkaddr20.i.i, i64 16
  store double %.624.2.i.i, ptr %sunkaddr30.i.i, align 8, !noalias !84
  %.570.3.i.i = load double, ptr %.778.i.i.i, align 8, !noalias !84
  %.572.3.i.i = load double, ptr %.778.repack1406.i.i.i, align 8, !noalias !84
  %.582.3.i.i = fdiv contract double %.572.3.i.i, 1.000000e-30
  %.623.3.i.i = fmul contract double %"$phi490.1.2.1.i.i", %.570.3.i.i
  %.624.3.i.i = fadd contract double %.623.3.i.i, %.582.3.i.i
  %sunkaddr34.i.i = getelementptr i8, ptr %sunkaddr20.i.i, i64 24
  store double %.624.3.i.i, ptr %sunkaddr34.i.i, align 8, !noalias !84
  %.570.4.i.i = load double, ptr %.937.i.i.i, align 8, !noalias !84
  %.572.4.i.i = load double, ptr %.937.repack1408.i.i.i, align 8, !noalias !84
  %.582.4.i.i = fdiv contract double %.572.4.i.i, 1.000000e-30
  %.623.4.i.i = fmul contract double %"$phi490.1.2.1.i.i", %.570.4.i.i
  %.624.4.i.i = fadd contract double %.623.4.i.i, %.582.4.i.i
  %sunkaddr38.i.i = getelementptr i8, ptr %sunkaddr20.i.i, i64 32
  store double %.624.4.i.i, ptr %sunkaddr38.i.i, align 8, !noalias !84
  %.570.5.i.i = load double, ptr %.1713.i.i.i, align 8, !noalias !84
  %.572.5.i.i = load double, ptr %.1713.repack1414.i.i.i, align 8, !noalias !84
  %.582.5.i.i = fdiv contract double %.572.5.i.i, 1.000000e-30
  %.623.5.i.i = fmul contract double %"$phi490.1.2.1.i.i", %.570.5.i.i
  %.624.5.i.i = fadd contract double %.623.5.i.i, %.582.5.i.i
  %sunkaddr42.i.i = getelementptr i8, ptr %sunkaddr20.i.i, i64 40
  store double %.624.5.i.i, ptr %sunkaddr42.i.i, align 8, !noalias !84
  %.570.6.i.i = load double, ptr %.2081.i.i.i, align 8, !noalias !84
  %.572.6.i.i = load double, ptr %.2081.repack1418.i.i.i, align 8, !noalias !84
  %.582.6.i.i = fdiv contract double %.572.6.i.i, 1.000000e-30
  %.623.6.i.i = fmul contract double %"$phi490.1.2.1.i.i", %.570.6.i.i
  %.624.6.i.i = fadd contract double %.623.6.i.i, %.582.6.i.i
  %sunkaddr46.i.i = getelementptr i8, ptr %sunkaddr20.i.i, i64 48
  store double %.624.6.i.i, ptr %sunkaddr46.i.i, align 8, !noalias !84
  %.570.7.i.i = load double, ptr %.3569.i.i.i, align 8, !noalias !84
  %.572.7.i.i = load double, ptr %.3569.repack1430.i.i.i, align 8, !noalias !84
  %.582.7.i.i = fdiv contract double %.572.7.i.i, 1.000000e-30
  %.623.7.i.i = fmul contract double %"$phi490.1.2.1.i.i", %.570.7.i.i
  %.624.7.i.i = fadd contract double %.623.7.i.i, %.582.7.i.i
  %sunkaddr50.i.i = getelementptr i8, ptr %sunkaddr20.i.i, i64 56
  store double %.624.7.i.i, ptr %sunkaddr50.i.i, align 8, !noalias !84
  %lsr.iv.next.i54.i = add nuw nsw i64 %lsr.iv.i8.i, 64
  %exitcond.not.i55.i = icmp eq i64 %lsr.iv.next.i54.i, 320
  br i1 %exitcond.not.i55.i, label %_ZN17bnserve_surrogate8tangents8_carrier15prepare_splinesB4v144B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE692Row_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20int64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_203_29_2c_20UniTuple_28array_28float64_2c_201d_2c_20C_29_20x_202_29_2c_20UniTuple_28array_28int64_2c_201d_2c_20C_29_20x_202_29_2c_20UniTuple_28array_28float64_2c_201d_2c_20C_29_20x_202_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29.exit, label %B80.if.i.i

_ZN17bnserve_surrogate8tangents8_carrier15prepare_splinesB4v144B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE692Row_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20int64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_203_29_2c_20UniTuple_28array_28float64_2c_201d_2c_20C_29_20x_202_29_2c_20UniTuple_28array_28int64_2c_201d_2c_20C_29_20x_202_29_2c_20UniTuple_28array_28float64_2c_201d_2c_20C_29_20x_202_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29.exit: ; preds = %_ZN17bnserve_surrogate8baseline10_amplitude22amplitude_coefficientsB4v184B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDAxYh_2bqJnA4AOzNAE_3dE10complex12810complex12810complex1285ArrayI10complex128Li1E1C7mutable7alignedE.exit.i.i, %B368.endif.i.i, %_ZN17bnserve_surrogate8tangents7_series19fill_phase_tangentsB4v168B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayI10complex128Li2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i
  %excinfo.1.0 = phi ptr [ %excinfo.19.0.i, %_ZN17bnserve_surrogate8tangents7_series19fill_phase_tangentsB4v168B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayI10complex128Li2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i ], [ null, %B368.endif.i.i ], [ %excinfo.1.1.i.i, %_ZN17bnserve_surrogate8baseline10_amplitude22amplitude_coefficientsB4v184B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDAxYh_2bqJnA4AOzNAE_3dE10complex12810complex12810complex1285ArrayI10complex128Li1E1C7mutable7alignedE.exit.i.i ]
  %common.ret.op.i = phi i1 [ false, %_ZN17bnserve_surrogate8tangents7_series19fill_phase_tangentsB4v168B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayI10complex128Li2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i ], [ %cond.i52.i, %B368.endif.i.i ], [ %cond.i52.i, %_ZN17bnserve_surrogate8baseline10_amplitude22amplitude_coefficientsB4v184B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDAxYh_2bqJnA4AOzNAE_3dE10complex12810complex12810complex1285ArrayI10complex128Li1E1C7mutable7alignedE.exit.i.i ]
  br i1 %common.ret.op.i, label %B0.endif, label %B0.if, !prof !20

B150:                                             ; preds = %B0.endif
  call void @llvm.lifetime.start.p0(ptr nonnull %.1098.i)
  call void @llvm.lifetime.start.p0(ptr nonnull %.1138.i)
  call void @llvm.lifetime.start.p0(ptr nonnull %excinfo.6.i)
  call void @llvm.lifetime.start.p0(ptr nonnull %.1222.i)
  call void @llvm.lifetime.start.p0(ptr nonnull %.1994.i)
  call void @llvm.lifetime.start.p0(ptr nonnull %.2351.i)
  store i64 0, ptr %.1098.i, align 8, !noalias !92
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(32) %.1138.i, i8 0, i64 32, i1 false), !noalias !92
  store ptr null, ptr %excinfo.6.i, align 8, !noalias !92
  store ptr null, ptr %.1222.i, align 8, !noalias !92
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(16) %.1994.i, i8 0, i64 16, i1 false), !noalias !92
  store ptr null, ptr %.2351.i, align 8, !noalias !92
  %.291.i = getelementptr i8, ptr %arg.state.0.4, i64 16
  %.292.i = load i64, ptr %.291.i, align 8, !noalias !92
  %.297.i = fmul contract double %.357, 2.000000e+00
  %.303.i = fmul contract double %.297.i, 5.000000e-01
  %.386.i = getelementptr i8, ptr %arg.state.0.4, i64 32
  %.387.i = load i64, ptr %.386.i, align 8, !noalias !92
  %.416.i = getelementptr i8, ptr %arg.state.0.4, i64 40
  %.417.i = load i64, ptr %.416.i, align 8, !noalias !92
  %.453.i = getelementptr i8, ptr %arg.state.0.4, i64 24
  %.454.i = load i64, ptr %.453.i, align 8, !noalias !92
  %.456.i = inttoptr i64 %.454.i to ptr
  %.523.i = getelementptr inbounds double, ptr %.456.i, i64 %.387.i
  %.581.i = icmp sgt i64 %.417.i, 0
  br i1 %.581.i, label %B394.i, label %B462.i

B394.i:                                           ; preds = %B150
  %50 = getelementptr double, ptr %.523.i, i64 %.292.i
  %.592.i = getelementptr i8, ptr %50, i64 -8
  %.593.i = load double, ptr %.592.i, align 8, !noalias !92
  %.602.i = load double, ptr %.523.i, align 8, !noalias !92
  %.603.i = fsub contract double %.593.i, %.602.i
  %.605.i = uitofp nneg i64 %.417.i to double
  %.609.i = fdiv contract double %.605.i, %.603.i
  br label %B462.i

B462.i:                                           ; preds = %B394.i, %B150
  %prepared_grid_v198__vphi308_0.2.0.i = phi double [ %.609.i, %B394.i ], [ 0.000000e+00, %B150 ]
  %.649.i = getelementptr i8, ptr %arg.state.0.4, i64 48
  %.650.i = load i64, ptr %.649.i, align 8, !noalias !92
  %.658.i = inttoptr i64 %.650.i to ptr
  %.888.i = getelementptr i8, ptr %arg.state.1.4, i64 128
  %.889.i = load i64, ptr %.888.i, align 8, !noalias !92
  %.905.i = getelementptr inbounds double, ptr %arg.state.2.4, i64 %.889.i
  %.1018.i = getelementptr i8, ptr %.905.i, i64 8
  %.1019.i = load double, ptr %.1018.i, align 8, !noalias !92
  %.1024.i = fmul contract double %.1019.i, 0x3FF000000044B830
  %.1032.le.i = tail call contract double @llvm.log.f64(double %.1024.i)
  %.1045.le.i = tail call contract double @llvm.log.f64(double %.357)
  %.1052.i = fsub contract double %.1032.le.i, %.1045.le.i
  store i64 0, ptr %.1098.i, align 8, !noalias !92
  call fastcc void @inner_8(ptr nonnull %.1098.i, ptr %.523.i, i64 %.292.i, ptr %.658.i, i64 %.417.i, double %prepared_grid_v198__vphi308_0.2.0.i, double %.1052.i)
  %.1116.i = load i64, ptr %.1098.i, align 8, !noalias !92
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(32) %.1138.i, i8 0, i64 32, i1 false), !noalias !92
  %.1187.i = call fastcc i32 @inner_9(ptr nonnull %.1138.i, ptr nonnull %excinfo.6.i, ptr readonly %arg.state.0.4, ptr readonly %arg.state.1.4, ptr readonly %arg.state.2.4, ptr readonly %arg.state.3.4, i64 %arg.state.5, ptr nonnull readonly %arg.state.6.4, i64 range(i64 8, 1) %arg.state.7.0, i64 range(i64 8, 1) %arg.state.7.1, i64 range(i64 8, 0) %arg.state.7.2, ptr %arg.state.9.0.4, i64 range(i64 8, 1) %arg.state.9.0.5.0, ptr %arg.state.9.1.4, i64 range(i64 8, 1) %arg.state.9.1.5.0, ptr readonly %arg.state.10.0.4, ptr readonly %arg.state.10.1.4, ptr %arg.state.11.4, ptr %arg.state.15.4, double %.303.i)
  %.1197.fca.0.load.i = load i64, ptr %.1138.i, align 8, !noalias !92
  %sunkaddr.i3 = getelementptr inbounds nuw i8, ptr %.1138.i, i64 8
  %.1197.fca.1.load.i = load i64, ptr %sunkaddr.i3, align 8, !noalias !92
  %sunkaddr70.i = getelementptr inbounds nuw i8, ptr %.1138.i, i64 16
  %.1197.fca.2.load.i = load i64, ptr %sunkaddr70.i, align 8, !noalias !92
  %sunkaddr71.i = getelementptr inbounds nuw i8, ptr %.1138.i, i64 24
  %.1197.fca.3.load.i = load i64, ptr %sunkaddr71.i, align 8, !noalias !92
  %cond.i = icmp eq i32 %.1187.i, 0
  br i1 %cond.i, label %for.end.1.endif.endif.i, label %for.end.1.endif.if.i, !prof !20

B464.i:                                           ; preds = %for.end.1.endif.endif.i
  store ptr null, ptr %.1222.i, align 8, !noalias !92
  call fastcc void @inner_10(ptr nonnull %.1222.i, ptr readonly %arg.state.1.4, ptr readonly %arg.state.2.4, ptr nonnull readonly %arg.state.6.4, i64 range(i64 8, 1) %arg.state.7.0, i64 range(i64 8, 1) %arg.state.7.1, ptr readonly %arg.state.8.0.4, ptr readonly %arg.state.8.1.4, ptr %arg.state.11.4, ptr %arg.state.13.4, ptr %arg.state.14.4, ptr %arg.state.15.4, double %.303.i)
  br label %B874.i

B874.i:                                           ; preds = %for.end.1.endif.endif.i, %B464.i
  %51 = add i64 %.292.i, 127
  %.1816.i = lshr i64 %51, 7
  %.1795.inv.i = icmp slt i64 %.292.i, 1
  %.18372180.not2191.i = icmp eq i64 %.1816.i, 0
  %.18372180.not.i = select i1 %.1795.inv.i, i1 true, i1 %.18372180.not2191.i
  br i1 %.18372180.not.i, label %_ZN17bnserve_surrogate8tangents4_row6_orderB4v187B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx23Literal_5bint_5d_282_2923Literal_5bint_5d_280_2923Literal_5bint_5d_280_29d692Row_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20int64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_203_29_2c_20UniTuple_28array_28float64_2c_201d_2c_20C_29_20x_202_29_2c_20UniTuple_28array_28int64_2c_201d_2c_20C_29_20x_202_29_2c_20UniTuple_28array_28float64_2c_201d_2c_20C_29_20x_202_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29.exit, label %B920.if.preheader.i

B920.if.preheader.i:                              ; preds = %B874.i
  %52 = add nuw nsw i64 %.1816.i, 5
  %sunkaddr7.i = getelementptr inbounds nuw i8, ptr %.1994.i, i64 8
  br label %B920.if.i

B1104.i:                                          ; preds = %B920.if.i
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(16) %.1994.i, i8 0, i64 16, i1 false), !noalias !92
  call fastcc void @inner_11(ptr nonnull %.1994.i, ptr readonly %arg.state.0.4, ptr readonly %arg.state.1.4, ptr readonly %arg.state.2.4, ptr readonly %arg.state.3.4, i64 %arg.state.5, ptr nonnull readonly %arg.state.6.4, i64 range(i64 8, 1) %arg.state.7.0, i64 range(i64 8, 1) %arg.state.7.1, i64 range(i64 8, 0) %arg.state.7.2, ptr readonly %arg.state.8.0.4, ptr readonly %arg.state.8.1.4, ptr %arg.state.9.0.4, ptr %arg.state.9.1.4, ptr %arg.state.11.4, ptr %arg.state.14.4, ptr %arg.state.15.4, double %.303.i, i64 %.184321492183.i, i64 %.13.i30.i, i64 %.1197.fca.0.load.i, i64 %.1197.fca.1.load.i, i64 %.1197.fca.2.load.i, i64 %.1197.fca.3.load.i, i64 %cells.2.sroa.0.02186.i, i64 %cells.2.sroa.13.02185.i, i8 0)
  %.2060.fca.0.load.i = load i64, ptr %.1994.i, align 8, !noalias !92
  %.2060.fca.1.load.i = load i64, ptr %sunkaddr7.i, align 8, !noalias !92
  br label %B1184.i

B1184.i:                                          ; preds = %B920.if.i, %B1104.i
  %cells.3.sroa.10.1.i = phi i64 [ %cells.2.sroa.13.02185.i, %B920.if.i ], [ %.2060.fca.1.load.i, %B1104.i ]
  %cells.3.sroa.0.1.i = phi i64 [ %cells.2.sroa.0.02186.i, %B920.if.i ], [ %.2060.fca.0.load.i, %B1104.i ]
  store ptr null, ptr %.2351.i, align 8, !noalias !92
  call fastcc void @inner_12(ptr nonnull %.2351.i, i64 %arg.i, i64 %.184321492183.i, i64 %.13.i30.i, i64 %.13.i.i, double 1.000000e+00, ptr readonly %arg.state.0.4, ptr %arg.state.12.4, ptr %arg.state.15.4)
  %lsr.iv.next.i6 = add nsw i64 %lsr.iv.i5, -1
  %.1837.i = icmp sgt i64 %lsr.iv.i5, 6
  br i1 %.1837.i, label %B920.if.i, label %_ZN17bnserve_surrogate8tangents4_row6_orderB4v187B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx23Literal_5bint_5d_282_2923Literal_5bint_5d_280_2923Literal_5bint_5d_280_29d692Row_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20int64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_203_29_2c_20UniTuple_28array_28float64_2c_201d_2c_20C_29_20x_202_29_2c_20UniTuple_28array_28int64_2c_201d_2c_20C_29_20x_202_29_2c_20UniTuple_28array_28float64_2c_201d_2c_20C_29_20x_202_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29.exit

for.end.1.endif.if.i:                             ; preds = %B462.i
  %.1188.i = load ptr, ptr %excinfo.6.i, align 8, !noalias !92
  br label %_ZN17bnserve_surrogate8tangents4_row6_orderB4v187B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx23Literal_5bint_5d_282_2923Literal_5bint_5d_280_2923Literal_5bint_5d_280_29d692Row_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20int64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_203_29_2c_20UniTuple_28array_28float64_2c_201d_2c_20C_29_20x_202_29_2c_20UniTuple_28array_28int64_2c_201d_2c_20C_29_20x_202_29_2c_20UniTuple_28array_28float64_2c_201d_2c_20C_29_20x_202_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29.exit

for.end.1.endif.endif.i:                          ; preds = %B462.i
  %.1217.i = icmp slt i64 %.1197.fca.1.load.i, %.1116.i
  br i1 %.1217.i, label %B464.i, label %B874.i

B920.if.i:                                        ; preds = %B1184.i, %B920.if.preheader.i
  %lsr.iv.i5 = phi i64 [ %lsr.iv.next.i6, %B1184.i ], [ %52, %B920.if.preheader.i ]
  %cells.2.sroa.0.02186.i = phi i64 [ %cells.3.sroa.0.1.i, %B1184.i ], [ 0, %B920.if.preheader.i ]
  %cells.2.sroa.13.02185.i = phi i64 [ %cells.3.sroa.10.1.i, %B1184.i ], [ 0, %B920.if.preheader.i ]
  %.184321492183.i = phi i64 [ %53, %B1184.i ], [ 0, %B920.if.preheader.i ]
  %53 = add nuw i64 %.184321492183.i, 128
  %.13.i.i = tail call i64 @llvm.smin.i64(i64 %.292.i, i64 %53)
  %.13.i29.i = tail call i64 @llvm.smax.i64(i64 %.184321492183.i, i64 %.1116.i)
  %.13.i30.i = tail call i64 @llvm.smin.i64(i64 %.13.i.i, i64 %.13.i29.i)
  %.1984.i = icmp sgt i64 %.13.i30.i, %.184321492183.i
  br i1 %.1984.i, label %B1104.i, label %B1184.i

_ZN17bnserve_surrogate8tangents4_row6_orderB4v187B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx23Literal_5bint_5d_282_2923Literal_5bint_5d_280_2923Literal_5bint_5d_280_29d692Row_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20int64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_203_29_2c_20UniTuple_28array_28float64_2c_201d_2c_20C_29_20x_202_29_2c_20UniTuple_28array_28int64_2c_201d_2c_20C_29_20x_202_29_2c_20UniTuple_28array_28float64_2c_201d_2c_20C_29_20x_202_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29.exit: ; preds = %B1184.i, %B874.i, %for.end.1.endif.if.i
  %excinfo.2.0 = phi ptr [ %.1188.i, %for.end.1.endif.if.i ], [ null, %B874.i ], [ null, %B1184.i ]
  %common.ret.op.i4 = phi i32 [ 1, %for.end.1.endif.if.i ], [ 0, %B874.i ], [ 0, %B1184.i ]
  call void @llvm.lifetime.end.p0(ptr nonnull %.1098.i)
  call void @llvm.lifetime.end.p0(ptr nonnull %.1138.i)
  call void @llvm.lifetime.end.p0(ptr nonnull %excinfo.6.i)
  call void @llvm.lifetime.end.p0(ptr nonnull %.1222.i)
  call void @llvm.lifetime.end.p0(ptr nonnull %.1994.i)
  call void @llvm.lifetime.end.p0(ptr nonnull %.2351.i)
  br i1 %cond.i, label %B150.endif, label %B150.if, !prof !20

B204:                                             ; preds = %B0.endif
  %.582 = inttoptr i64 %.394 to ptr
  %.668 = load i64, ptr %.582, align 8
  %.669 = icmp sgt i64 %.668, 0
  br i1 %.669, label %B336.preheader, label %B744

B336.preheader:                                   ; preds = %B204
  %scevgep = getelementptr i8, ptr %.582, i64 192
  %.291.i16 = getelementptr i8, ptr %arg.state.0.4, i64 16
  %.297.i18 = fmul contract double %.357, 2.000000e+00
  %.386.i20 = getelementptr i8, ptr %arg.state.0.4, i64 32
  %.416.i22 = getelementptr i8, ptr %arg.state.0.4, i64 40
  %.453.i24 = getelementptr i8, ptr %arg.state.0.4, i64 24
  %.649.i30 = getelementptr i8, ptr %arg.state.0.4, i64 48
  %.888.i34 = getelementptr i8, ptr %arg.state.1.4, i64 128
  %.1045.le.i41 = tail call contract double @llvm.log.f64(double %.357)
  %sunkaddr205.i = getelementptr inbounds nuw i8, ptr %.1138.i9, i64 8
  %sunkaddr206.i = getelementptr inbounds nuw i8, ptr %.1138.i9, i64 16
  %sunkaddr207.i = getelementptr inbounds nuw i8, ptr %.1138.i9, i64 24
  %54 = shl i64 %arg.state.5, 8
  %55 = sub nuw nsw i64 -64, %54
  %56 = sub nuw nsw i64 -192, %54
  %57 = sub nuw nsw i64 -128, %54
  %.2214.i = getelementptr i8, ptr %arg.state.15.4, i64 4352
  %sunkaddr.i60 = getelementptr inbounds nuw i8, ptr %.1994.i13, i64 8
  %.3044.i.i = getelementptr i8, ptr %arg.state.15.4, i64 8704
  %58 = shl i64 %arg.state.5, 2
  %sunkaddr262.i.i = getelementptr i8, ptr %arg.state.0.4, i64 120
  %sunkaddr263.i.i = getelementptr i8, ptr %arg.state.0.4, i64 128
  %sunkaddr264.i.i = getelementptr i8, ptr %arg.state.12.4, i64 8
  %sunkaddr265.i.i = getelementptr i8, ptr %arg.state.12.4, i64 16
  %sunkaddr266.i.i = getelementptr i8, ptr %arg.state.12.4, i64 24
  %sunkaddr267.i.i = getelementptr i8, ptr %arg.state.12.4, i64 32
  %sunkaddr268.i.i = getelementptr i8, ptr %arg.state.12.4, i64 40
  %sunkaddr269.i.i = getelementptr i8, ptr %arg.state.12.4, i64 48
  %sunkaddr270.i.i = getelementptr i8, ptr %arg.state.12.4, i64 56
  %sunkaddr271.i.i = getelementptr i8, ptr %arg.state.12.4, i64 64
  %sunkaddr272.i.i = getelementptr i8, ptr %arg.state.12.4, i64 72
  %sunkaddr273.i.i = getelementptr i8, ptr %arg.state.12.4, i64 80
  %sunkaddr274.i.i = getelementptr i8, ptr %arg.state.12.4, i64 88
  %sunkaddr275.i.i = getelementptr i8, ptr %arg.state.12.4, i64 96
  %sunkaddr276.i.i = getelementptr i8, ptr %arg.state.12.4, i64 104
  br label %B336

B336:                                             ; preds = %B652.endif, %B336.preheader
  %excinfo.7.0 = phi ptr [ null, %B336.preheader ], [ %excinfo.7.1, %B652.endif ]
  %first.2.0 = phi i64 [ 0, %B336.preheader ], [ %last.3.2, %B652.endif ]
  %.idx = mul i64 %first.2.0, 72
  %59 = getelementptr i8, ptr %.582, i64 %.idx
  %.695 = getelementptr i8, ptr %59, i64 48
  %.786 = load i64, ptr %.695, align 8
  %.794 = add nsw i64 %first.2.0, 1
  %.831 = load i64, ptr %.582, align 8
  %.833 = icmp slt i64 %.794, %.831
  br i1 %.833, label %B454, label %B652

B454:                                             ; preds = %B336
  %.idx1339 = mul i64 %.794, 72
  %60 = getelementptr i8, ptr %.582, i64 %.idx1339
  %.865 = getelementptr i8, ptr %60, i64 48
  %.956 = load i64, ptr %.865, align 8
  %.961 = icmp eq i64 %.956, %.786
  br i1 %.961, label %B526.preheader, label %B652

B526.preheader:                                   ; preds = %B454
  %scevgep60 = getelementptr i8, ptr %scevgep, i64 %.idx
  br label %B526

B526:                                             ; preds = %B580, %B526.preheader
  %lsr.iv7 = phi i64 [ %lsr.iv.next8, %B580 ], [ %.794, %B526.preheader ]
  %lsr.iv61 = phi ptr [ %scevgep62, %B580 ], [ %scevgep60, %B526.preheader ]
  %reass.sub = sub i64 %lsr.iv7, %.831
  %exitcond.not = icmp eq i64 %reass.sub, -1
  br i1 %exitcond.not, label %B652, label %B580

B580:                                             ; preds = %B526
  %.1129 = load i64, ptr %lsr.iv61, align 8
  %.1134 = icmp eq i64 %.1129, %.786
  %scevgep62 = getelementptr i8, ptr %lsr.iv61, i64 72
  %lsr.iv.next8 = add i64 %lsr.iv7, 1
  br i1 %.1134, label %B526, label %B652

B652:                                             ; preds = %B580, %B526, %B454, %B336
  %last.3.2 = phi i64 [ %.794, %B454 ], [ %.794, %B336 ], [ %.831, %B526 ], [ %lsr.iv.next8, %B580 ]
  call void @llvm.lifetime.start.p0(ptr nonnull %.1098.i7)
  call void @llvm.lifetime.start.p0(ptr nonnull %.1138.i9)
  call void @llvm.lifetime.start.p0(ptr nonnull %excinfo.6.i10)
  call void @llvm.lifetime.start.p0(ptr nonnull %.1222.i11)
  call void @llvm.lifetime.start.p0(ptr nonnull %.1994.i13)
  call void @llvm.lifetime.start.p0(ptr nonnull %.2352.i)
  store i64 0, ptr %.1098.i7, align 8, !noalias !96
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(32) %.1138.i9, i8 0, i64 32, i1 false), !noalias !96
  store ptr null, ptr %excinfo.6.i10, align 8, !noalias !96
  store ptr null, ptr %.1222.i11, align 8, !noalias !96
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(16) %.1994.i13, i8 0, i64 16, i1 false), !noalias !96
  store ptr null, ptr %.2352.i, align 8, !noalias !96
  %.292.i17 = load i64, ptr %.291.i16, align 8, !noalias !96
  %.299.i = sitofp i64 %.786 to double
  %.303.i19 = fdiv contract double %.297.i18, %.299.i
  %.387.i21 = load i64, ptr %.386.i20, align 8, !noalias !96
  %.417.i23 = load i64, ptr %.416.i22, align 8, !noalias !96
  %.454.i25 = load i64, ptr %.453.i24, align 8, !noalias !96
  %.456.i26 = inttoptr i64 %.454.i25 to ptr
  %.523.i27 = getelementptr inbounds double, ptr %.456.i26, i64 %.387.i21
  %.581.i28 = icmp sgt i64 %.417.i23, 0
  br i1 %.581.i28, label %B394.i117, label %B462.i29

B394.i117:                                        ; preds = %B652
  %61 = getelementptr double, ptr %.523.i27, i64 %.292.i17
  %.592.i118 = getelementptr i8, ptr %61, i64 -8
  %.593.i119 = load double, ptr %.592.i118, align 8, !noalias !96
  %.602.i120 = load double, ptr %.523.i27, align 8, !noalias !96
  %.603.i121 = fsub contract double %.593.i119, %.602.i120
  %.605.i122 = uitofp nneg i64 %.417.i23 to double
  %.609.i123 = fdiv contract double %.605.i122, %.603.i121
  br label %B462.i29

B462.i29:                                         ; preds = %B394.i117, %B652
  %prepared_grid_v571__vphi308_0.2.0.i = phi double [ %.609.i123, %B394.i117 ], [ 0.000000e+00, %B652 ]
  %.650.i31 = load i64, ptr %.649.i30, align 8, !noalias !96
  %.658.i33 = inttoptr i64 %.650.i31 to ptr
  %.889.i35 = load i64, ptr %.888.i34, align 8, !noalias !96
  %.905.i36 = getelementptr inbounds double, ptr %arg.state.2.4, i64 %.889.i35
  %.1018.i37 = getelementptr i8, ptr %.905.i36, i64 8
  %.1019.i38 = load double, ptr %.1018.i37, align 8, !noalias !96
  %.1024.i39 = fmul contract double %.1019.i38, 0x3FF000000044B830
  %.1032.le.i40 = tail call contract double @llvm.log.f64(double %.1024.i39)
  %.1052.i42 = fsub contract double %.1032.le.i40, %.1045.le.i41
  store i64 0, ptr %.1098.i7, align 8, !noalias !96
  call fastcc void @inner_8(ptr nonnull %.1098.i7, ptr %.523.i27, i64 %.292.i17, ptr %.658.i33, i64 %.417.i23, double %prepared_grid_v571__vphi308_0.2.0.i, double %.1052.i42)
  %.1116.i44 = load i64, ptr %.1098.i7, align 8, !noalias !96
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(32) %.1138.i9, i8 0, i64 32, i1 false), !noalias !96
  %.1187.i45 = call fastcc i32 @inner_9(ptr nonnull %.1138.i9, ptr nonnull %excinfo.6.i10, ptr readonly %arg.state.0.4, ptr readonly %arg.state.1.4, ptr readonly %arg.state.2.4, ptr readonly %arg.state.3.4, i64 %arg.state.5, ptr nonnull readonly %arg.state.6.4, i64 range(i64 8, 1) %arg.state.7.0, i64 range(i64 8, 1) %arg.state.7.1, i64 range(i64 8, 0) %arg.state.7.2, ptr %arg.state.9.0.4, i64 range(i64 8, 1) %arg.state.9.0.5.0, ptr %arg.state.9.1.4, i64 range(i64 8, 1) %arg.state.9.1.5.0, ptr readonly %arg.state.10.0.4, ptr readonly %arg.state.10.1.4, ptr %arg.state.11.4, ptr %arg.state.15.4, double %.303.i19)
  %.1197.fca.0.load.i46 = load i64, ptr %.1138.i9, align 8, !noalias !96
  %.1197.fca.1.load.i47 = load i64, ptr %sunkaddr205.i, align 8, !noalias !96
  %.1197.fca.2.load.i48 = load i64, ptr %sunkaddr206.i, align 8, !noalias !96
  %.1197.fca.3.load.i49 = load i64, ptr %sunkaddr207.i, align 8, !noalias !96
  %cond.i50 = icmp eq i32 %.1187.i45, 0
  br i1 %cond.i50, label %for.end.1.endif.endif.i54, label %for.end.1.endif.if.i51, !prof !20

B464.i115:                                        ; preds = %for.end.1.endif.endif.i54
  store ptr null, ptr %.1222.i11, align 8, !noalias !96
  call fastcc void @inner_10(ptr nonnull %.1222.i11, ptr readonly %arg.state.1.4, ptr readonly %arg.state.2.4, ptr nonnull readonly %arg.state.6.4, i64 range(i64 8, 1) %arg.state.7.0, i64 range(i64 8, 1) %arg.state.7.1, ptr readonly %arg.state.8.0.4, ptr readonly %arg.state.8.1.4, ptr %arg.state.11.4, ptr %arg.state.13.4, ptr %arg.state.14.4, ptr %arg.state.15.4, double %.303.i19)
  br label %B622.i

B622.i:                                           ; preds = %for.end.1.endif.endif.i54, %B464.i115
  %.1333.i = sub i64 %last.3.2, %first.2.0
  %.1334.i = icmp sgt i64 %.1333.i, 0
  br i1 %.1334.i, label %B698.if.lr.ph.i, label %B874.i56

B698.if.lr.ph.i:                                  ; preds = %B622.i
  %.1640.le.i = tail call contract double @llvm.log.f64(double %.303.i19)
  %62 = add nuw i64 %.1333.i, 1
  %63 = add i64 %.idx, 48
  br label %B698.if.i

B752.i:                                           ; preds = %_ZN17bnserve_surrogate8tangents6_ratio13prepare_ratioB4v284B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE692Row_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20int64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_203_29_2c_20UniTuple_28array_28float64_2c_201d_2c_20C_29_20x_202_29_2c_20UniTuple_28array_28int64_2c_201d_2c_20C_29_20x_202_29_2c_20UniTuple_28array_28float64_2c_201d_2c_20C_29_20x_202_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_295ArrayIxLi1E1C7mutable7alignedEdx.exit.i, %B698.if.i
  %ratios.3.1.i = phi i1 [ %ratios.2.02123.i, %B698.if.i ], [ true, %_ZN17bnserve_surrogate8tangents6_ratio13prepare_ratioB4v284B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE692Row_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20int64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_203_29_2c_20UniTuple_28array_28float64_2c_201d_2c_20C_29_20x_202_29_2c_20UniTuple_28array_28int64_2c_201d_2c_20C_29_20x_202_29_2c_20UniTuple_28array_28float64_2c_201d_2c_20C_29_20x_202_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_295ArrayIxLi1E1C7mutable7alignedEdx.exit.i ]
  %lsr.iv.next199.i = add i64 %lsr.iv198.i, -1
  %lsr.iv.next201.i = add i64 %lsr.iv200.i, 72
  %.1376.i = icmp sgt i64 %lsr.iv.next199.i, 1
  br i1 %.1376.i, label %B698.if.i, label %B874.i56

B874.i56:                                         ; preds = %B752.i, %B622.i
  %ratios.2.0.lcssa.i = phi i1 [ false, %B622.i ], [ %ratios.3.1.i, %B752.i ]
  %64 = add nuw i64 %.292.i17, 127
  %.1816.i57 = lshr i64 %64, 7
  %.1795.inv.i58 = icmp slt i64 %.292.i17, 1
  %.18372182.not2193.i = icmp eq i64 %.1816.i57, 0
  %.18372182.not.i = select i1 %.1795.inv.i58, i1 true, i1 %.18372182.not2193.i
  br i1 %.18372182.not.i, label %_ZN17bnserve_surrogate8tangents4_row6_orderB4v560B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxxd692Row_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20int64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_203_29_2c_20UniTuple_28array_28float64_2c_201d_2c_20C_29_20x_202_29_2c_20UniTuple_28array_28int64_2c_201d_2c_20C_29_20x_202_29_2c_20UniTuple_28array_28float64_2c_201d_2c_20C_29_20x_202_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29.exit, label %B920.if.lr.ph.i

B920.if.lr.ph.i:                                  ; preds = %B874.i56
  %.2049.i = zext i1 %ratios.2.0.lcssa.i to i8
  %.2289.i = fmul contract double %.299.i, 5.000000e-01
  %..13332068.i = tail call i64 @llvm.smax.i64(i64 %.1333.i, i64 0)
  %.6.i.i.i59 = insertelement <8 x double> poison, double %.2289.i, i64 0
  %.7.i.i.i = shufflevector <8 x double> %.6.i.i.i59, <8 x double> poison, <8 x i32> zeroinitializer
  %65 = add nuw i64 %..13332068.i, 1
  %66 = add i64 %.idx, 48
  %67 = icmp eq i64 %last.3.2, %first.2.0
  %68 = icmp slt i64 %.1333.i, 1
  %.1945.le.i.i = tail call contract double @llvm.log.f64(double %.303.i19)
  %.3341.i.i = fmul contract double %.303.i19, 0x400921FB54442D18
  %.3344.i.i = tail call contract double @llvm.pow.f64(double %.3341.i.i, double 0x3FD5555555555555)
  %.6.i14.i.i.i = insertelement <8 x double> poison, double %.3344.i.i, i64 0
  %.7.i.i190.i.i = shufflevector <8 x double> %.6.i14.i.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  br label %B920.if.i61

B920.loopexit.i:                                  ; preds = %_ZN17bnserve_surrogate8tangents4_row11_write_modeB4v413B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi3EEd692Row_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20int64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_203_29_2c_20UniTuple_28array_28float64_2c_201d_2c_20C_29_20x_202_29_2c_20UniTuple_28array_28int64_2c_201d_2c_20C_29_20x_202_29_2c_20UniTuple_28array_28float64_2c_201d_2c_20C_29_20x_202_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29.exit.i, %B1346.i, %B1186.i
  %lsr.iv.next.i77 = add i64 %lsr.iv187.i, 128
  %lsr.iv.next190.i = add i64 %lsr.iv189.i, -128
  %.1837.i78 = icmp sgt i64 %.183621382186.i, 1
  br i1 %.1837.i78, label %B920.if.i61, label %_ZN17bnserve_surrogate8tangents4_row6_orderB4v560B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxxd692Row_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20int64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_203_29_2c_20UniTuple_28array_28float64_2c_201d_2c_20C_29_20x_202_29_2c_20UniTuple_28array_28int64_2c_201d_2c_20C_29_20x_202_29_2c_20UniTuple_28array_28float64_2c_201d_2c_20C_29_20x_202_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29.exit

B1104.i85:                                        ; preds = %B920.if.i61
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(16) %.1994.i13, i8 0, i64 16, i1 false), !noalias !96
  call fastcc void @inner_11(ptr nonnull %.1994.i13, ptr readonly %arg.state.0.4, ptr readonly %arg.state.1.4, ptr readonly %arg.state.2.4, ptr readonly %arg.state.3.4, i64 %arg.state.5, ptr nonnull readonly %arg.state.6.4, i64 range(i64 8, 1) %arg.state.7.0, i64 range(i64 8, 1) %arg.state.7.1, i64 range(i64 8, 0) %arg.state.7.2, ptr readonly %arg.state.8.0.4, ptr readonly %arg.state.8.1.4, ptr %arg.state.9.0.4, ptr %arg.state.9.1.4, ptr %arg.state.11.4, ptr %arg.state.14.4, ptr %arg.state.15.4, double %.303.i19, i64 %.184321492185.i, i64 %.13.i79.i, i64 %.1197.fca.0.load.i46, i64 %.1197.fca.1.load.i47, i64 %.1197.fca.2.load.i48, i64 %.1197.fca.3.load.i49, i64 %cells.2.sroa.0.02188.i, i64 %cells.2.sroa.13.02187.i, i8 %.2049.i)
  %.2060.fca.0.load.i87 = load i64, ptr %.1994.i13, align 8, !noalias !96
  %.2060.fca.1.load.i88 = load i64, ptr %sunkaddr.i60, align 8, !noalias !96
  br i1 %ratios.2.0.lcssa.i, label %B48.if.i.preheader.i, label %B1184.i64

B48.if.i.preheader.i:                             ; preds = %B1104.i85
  %smin.i = tail call i64 @llvm.smin.i64(i64 %.292.i17, i64 %.13.i78.i)
  %smin7.i = tail call i64 @llvm.smin.i64(i64 %smin.i, i64 %lsr.iv187.i)
  %69 = add i64 %smin7.i, %lsr.iv189.i
  %70 = lshr i64 %69, 3
  %71 = add nuw nsw i64 %70, 6
  br label %B48.if.i.i

B1184.i64:                                        ; preds = %B48.if.i.i, %B920.if.i61, %B1104.i85
  %cells.3.sroa.10.1.i65 = phi i64 [ %cells.2.sroa.13.02187.i, %B920.if.i61 ], [ %.2060.fca.1.load.i88, %B1104.i85 ], [ %.2060.fca.1.load.i88, %B48.if.i.i ]
  %cells.3.sroa.0.1.i66 = phi i64 [ %cells.2.sroa.0.02188.i, %B920.if.i61 ], [ %.2060.fca.0.load.i87, %B1104.i85 ], [ %.2060.fca.0.load.i87, %B48.if.i.i ]
  br i1 %67, label %B1186.i, label %B1346.i

B1186.i:                                          ; preds = %B1184.i64
  store ptr null, ptr %.2352.i, align 8, !noalias !96
  call fastcc void @inner_12(ptr nonnull %.2352.i, i64 %arg.i, i64 %.184321492185.i, i64 %.13.i79.i, i64 %.13.i.i62, double %.2289.i, ptr readonly %arg.state.0.4, ptr %arg.state.12.4, ptr %arg.state.15.4)
  br label %B920.loopexit.i

B1346.i:                                          ; preds = %B1184.i64
  br i1 %68, label %B920.loopexit.i, label %B1350.if.preheader.i

B1350.if.preheader.i:                             ; preds = %B1346.i
  %.1936.i.i = sub i64 %.13.i79.i, %.184321492185.i
  %72 = add nuw i64 %.1936.i.i, 7
  %.616.i.i.i = lshr i64 %72, 3
  %.595.inv.i.i.i = icmp slt i64 %.1936.i.i, 1
  %.637334.not343.i.i.i = icmp eq i64 %.616.i.i.i, 0
  %.637334.not.i.i.i = select i1 %.595.inv.i.i.i, i1 true, i1 %.637334.not343.i.i.i
  %.1026.i.i.i = icmp sgt i64 %.1936.i.i, 0
  %73 = add nsw i64 %.1936.i.i, -1
  %74 = shl i64 %.184321492185.i, 3
  %.3705.i.i = sub nsw i64 %.13.i.i62, %.184321492185.i
  %unroll_iter.i72.i.i = and i64 %.1936.i.i, 9223372036854775806
  %75 = shl i64 %.3705.i.i, 4
  %76 = sub i64 %.3705.i.i, %.1936.i.i
  %.58.i223.i.i = shl i64 %76, 1
  %.20.i226.i.i = shl i64 %.1936.i.i, 1
  %77 = sub i64 %.1936.i.i, %.3705.i.i
  %78 = add nsw i64 %unroll_iter.i72.i.i, -2
  %79 = lshr exact i64 %78, 1
  %80 = add nuw i64 %79, 1
  %81 = sub i64 8704, %74
  %scevgep573.i.i = getelementptr i8, ptr %arg.state.15.4, i64 %81
  %82 = sub i64 %.13.i.i62, %.13.i79.i
  %83 = shl i64 %82, 1
  %84 = and i64 %83, 2
  %85 = shl i64 %.1936.i.i, 4
  %86 = or disjoint i64 %75, 8
  %87 = add i64 %75, 16
  %88 = add i64 %75, 24
  %89 = lshr i64 %80, 1
  %90 = mul nsw i64 %89, -2
  %91 = icmp slt i64 %.58.i223.i.i, 1
  %92 = icmp eq i64 %.1936.i.i, 1
  %93 = icmp eq i64 %78, 0
  %94 = and i64 %78, 2
  %95 = icmp eq i64 %94, 0
  %96 = and i64 %.13.i79.i, 1
  %97 = icmp eq i64 %96, 0
  %98 = and i64 %76, 1
  %99 = icmp eq i64 %98, 0
  %100 = trunc i64 %77 to i63
  %101 = icmp eq i63 %100, -1
  br label %B1350.if.i

for.end.1.endif.if.i51:                           ; preds = %B462.i29
  %.1188.i52 = load ptr, ptr %excinfo.6.i10, align 8, !noalias !96
  br label %_ZN17bnserve_surrogate8tangents4_row6_orderB4v560B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxxd692Row_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20int64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_203_29_2c_20UniTuple_28array_28float64_2c_201d_2c_20C_29_20x_202_29_2c_20UniTuple_28array_28int64_2c_201d_2c_20C_29_20x_202_29_2c_20UniTuple_28array_28float64_2c_201d_2c_20C_29_20x_202_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29.exit

for.end.1.endif.endif.i54:                        ; preds = %B462.i29
  %.1217.i55 = icmp slt i64 %.1197.fca.1.load.i47, %.1116.i44
  br i1 %.1217.i55, label %B464.i115, label %B622.i

B698.if.i:                                        ; preds = %B752.i, %B698.if.lr.ph.i
  %lsr.iv200.i = phi i64 [ %63, %B698.if.lr.ph.i ], [ %lsr.iv.next201.i, %B752.i ]
  %lsr.iv198.i = phi i64 [ %62, %B698.if.lr.ph.i ], [ %lsr.iv.next199.i, %B752.i ]
  %ratios.2.02123.i = phi i1 [ false, %B698.if.lr.ph.i ], [ %ratios.3.1.i, %B752.i ]
  %.1455.i = load i64, ptr %.393, align 8, !noalias !96
  %.1459.i = inttoptr i64 %.1455.i to ptr
  %scevgep202.i = getelementptr i8, ptr %.1459.i, i64 %lsr.iv200.i
  %scevgep203.i = getelementptr i8, ptr %scevgep202.i, i64 16
  %.1626.i = load i64, ptr %scevgep203.i, align 8, !noalias !96
  %.1627.i = icmp sgt i64 %.1626.i, 0
  br i1 %.1627.i, label %for.end.2.i, label %B752.i

for.end.2.i:                                      ; preds = %B698.if.i
  call void @llvm.lifetime.start.p0(ptr nonnull %.3274.i.i), !noalias !96
  call void @llvm.lifetime.start.p0(ptr nonnull %.3454.i.i), !noalias !96
  store i64 0, ptr %.3274.i.i, align 8, !noalias !100
  store i64 0, ptr %.3454.i.i, align 8, !noalias !100
  %.361.i.i = getelementptr i8, ptr %scevgep202.i, i64 24
  %.362.i.i = load i64, ptr %.361.i.i, align 8, !noalias !100
  %.363.i.i = inttoptr i64 %.362.i.i to ptr
  %.441.i.i = getelementptr i8, ptr %scevgep202.i, i64 40
  %.442.i.i = load i64, ptr %.441.i.i, align 8, !noalias !100
  %.443.i.i = inttoptr i64 %.442.i.i to ptr
  %.525.i.i = getelementptr i8, ptr %.363.i.i, i64 64
  %.526.i.i = load i64, ptr %.525.i.i, align 8, !noalias !100
  %.527.i.i = sub i64 0, %.526.i.i
  %.535.1.i.i = and i64 %.527.i.i, -8
  %.569.i.i = sub i64 0, %.535.1.i.i
  %.665.i.i = getelementptr i8, ptr %scevgep202.i, i64 48
  %.666.i.i = load i64, ptr %.665.i.i, align 8, !noalias !100
  %.683.idx.i.i = shl i64 %.666.i.i, 4
  %.683.i.i = getelementptr i8, ptr %arg.state.16.4, i64 %.683.idx.i.i
  %.889.i.i = getelementptr i8, ptr %.363.i.i, i64 120
  %.890.i.i = load i64, ptr %.889.i.i, align 8, !noalias !100
  %.1467.i.i = shl i64 %.569.i.i, 2
  %invariant.gep.i.i = getelementptr double, ptr %.683.i.i, i64 %.1467.i.i
  %102 = lshr i64 %.569.i.i, 33
  %.99.i.i.i = and i64 %102, 1073741824
  %.100.i.i.i = sub i64 %.99.i.i.i, %.535.1.i.i
  %.234.i.i.i = shl i64 %.569.i.i, 1
  %.272.i.i.i = add i64 %.99.i.i.i, %.234.i.i.i
  %103 = add i64 %.526.i.i, 6
  %.486.i.i.i = lshr i64 %103, 3
  %.463.inv.i.i.i = icmp slt i64 %.526.i.i, 2
  %.507321.not325.i.i.i = icmp eq i64 %.486.i.i.i, 0
  %.507321.not.i.i.i = select i1 %.463.inv.i.i.i, i1 true, i1 %.507321.not325.i.i.i
  %104 = lshr i64 %.527.i.i, 3
  %.neg.i.i = mul i64 %104, -192
  %105 = getelementptr i8, ptr %arg.state.16.4, i64 %.neg.i.i
  %scevgep414.i.i = getelementptr i8, ptr %105, i64 %.683.idx.i.i
  %106 = mul i64 %104, -512
  %107 = shl i64 %104, 7
  %108 = sub i64 %.683.idx.i.i, %107
  %scevgep417.i.i = getelementptr i8, ptr %arg.state.16.4, i64 %108
  %109 = shl i64 %104, 6
  %110 = sub i64 %.683.idx.i.i, %109
  %scevgep421.i.i = getelementptr i8, ptr %arg.state.16.4, i64 %110
  %111 = mul i64 %104, %55
  %scevgep429.i.i = getelementptr i8, ptr %arg.state.4.4, i64 %111
  %112 = mul i64 %104, -2048
  %.neg1.i.i = mul i64 %104, -448
  %113 = getelementptr i8, ptr %arg.state.16.4, i64 %.neg1.i.i
  %scevgep441.i.i = getelementptr i8, ptr %113, i64 %.683.idx.i.i
  %.neg2.i.i = mul i64 %104, -384
  %114 = getelementptr i8, ptr %arg.state.16.4, i64 %.neg2.i.i
  %scevgep445.i.i = getelementptr i8, ptr %114, i64 %.683.idx.i.i
  %.neg3.i.i = mul i64 %104, -320
  %115 = getelementptr i8, ptr %arg.state.16.4, i64 %.neg3.i.i
  %scevgep449.i.i = getelementptr i8, ptr %115, i64 %.683.idx.i.i
  %116 = mul i64 %104, %56
  %scevgep458.i.i = getelementptr i8, ptr %arg.state.4.4, i64 %116
  %117 = mul i64 %104, %57
  %118 = tail call i64 @llvm.smax.i64(i64 %.100.i.i.i, i64 0)
  %.88.sroa.0.3.i.i.i = tail call i64 @llvm.smin.i64(i64 %118, i64 1073741824)
  %119 = tail call i64 @llvm.smax.i64(i64 %.272.i.i.i, i64 0)
  %120 = mul i64 %104, %54
  %121 = sub i64 8, %120
  %scevgep29.i.i94 = getelementptr i8, ptr %arg.state.4.4, i64 %121
  %122 = getelementptr i8, ptr %arg.state.4.4, i64 %117
  %scevgep42.i.i = getelementptr i8, ptr %122, i64 8
  %123 = add nuw nsw i64 %.486.i.i.i, 7
  %smin.i.i = tail call i64 @llvm.smin.i64(i64 %119, i64 1073741824)
  %124 = add i64 %smin.i.i, %.890.i.i
  %125 = shl i64 %124, 3
  %scevgep30.i.i = getelementptr i8, ptr %.443.i.i, i64 %125
  %126 = add i64 %.88.sroa.0.3.i.i.i, %.890.i.i
  %127 = shl i64 %126, 3
  %scevgep36.i.i = getelementptr i8, ptr %.443.i.i, i64 %127
  br label %B96.if.i.i

B398.i.i:                                         ; preds = %_ZN17bnserve_surrogate6kernel7_points10fill_cellsB4v165B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedExx5ArrayIdLi1E1C7mutable7alignedE.exit163.i.i
  %.903.i.i = getelementptr double, ptr %.443.i.i, i64 %.890.i.i
  %.1549.i.i = shl i64 %.569.i.i, 3
  %.1857.idx.i.i = shl i64 %.569.i.i, 4
  %.745.idx.i.i = mul i64 %.535.1.i.i, -448
  %.745.i.i = getelementptr i8, ptr %.683.i.i, i64 %.745.idx.i.i
  %.809.i.i = getelementptr i8, ptr %.745.i.i, i64 64
  %.2259.idx.i.i = mul i64 %.535.1.i.i, -384
  %.2259.i.i = getelementptr i8, ptr %.683.i.i, i64 %.2259.idx.i.i
  %.2326.i.i = getelementptr double, ptr %.2259.i.i, i64 %.1467.i.i
  %.2474.i.i = load double, ptr %.1653.i, align 8, !noalias !100
  %.2481.i.i = fdiv contract double 1.000000e+00, %.2474.i.i
  %.120148.not.i.i.i = icmp slt i64 %.569.i.i, 1
  br i1 %.120148.not.i.i.i, label %_ZN17bnserve_surrogate8tangents8_carrier11fill_slopesB4v166B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedExd5ArrayIdLi1E1C7mutable7alignedE.exit206.i.i, label %B34.if.lr.ph.i.i.i

B6275.i.i:                                        ; preds = %_ZN17bnserve_surrogate8tangents8_carrier11fill_slopesB4v166B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedExd5ArrayIdLi1E1C7mutable7alignedE.exit206.i.i
  %128 = getelementptr double, ptr %.2862.i.i, i64 %.2698.i.i
  %.2931.i.i = getelementptr i8, ptr %128, i64 -8
  %.2932.i.i = load double, ptr %.2931.i.i, align 8, !noalias !100
  %.2941.i.i = load double, ptr %.2862.i.i, align 8, !noalias !100
  %.2942.i.i = fsub contract double %.2932.i.i, %.2941.i.i
  %.2944.i.i = uitofp nneg i64 %.2758.i.i to double
  %.2948.i.i = fdiv contract double %.2944.i.i, %.2942.i.i
  br label %B6355.i.i

B6355.i.i:                                        ; preds = %_ZN17bnserve_surrogate8tangents8_carrier11fill_slopesB4v166B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedExd5ArrayIdLi1E1C7mutable7alignedE.exit206.i.i, %B6275.i.i
  %prepared_grid_v291__vphi308_0.2.0.i.i = phi double [ %.2948.i.i, %B6275.i.i ], [ 0.000000e+00, %_ZN17bnserve_surrogate8tangents8_carrier11fill_slopesB4v166B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedExd5ArrayIdLi1E1C7mutable7alignedE.exit206.i.i ]
  %.2989.i.i = load i64, ptr %.649.i30, align 8, !noalias !100
  %.2997.i.i = inttoptr i64 %.2989.i.i to ptr
  %.3226.i.i = load double, ptr %.903.i.i, align 8, !noalias !100
  %.3228.i.i = fsub contract double %.3226.i.i, %.1640.le.i
  store i64 0, ptr %.3274.i.i, align 8, !noalias !100
  call fastcc void @inner_8(ptr nonnull %.3274.i.i, ptr %.2862.i.i, i64 %.2698.i.i, ptr %.2997.i.i, i64 %.2758.i.i, double %prepared_grid_v291__vphi308_0.2.0.i.i, double %.3228.i.i)
  %.3292.i.i = load i64, ptr %.3274.i.i, align 8, !noalias !100
  %.13.i.i.i = tail call i64 @llvm.smin.i64(i64 %.1116.i44, i64 %.3292.i.i)
  store i64 %.13.i.i.i, ptr %.745.i.i, align 8, !noalias !100
  %129 = getelementptr double, ptr %.903.i.i, i64 %.526.i.i
  %.3405.i.i = getelementptr i8, ptr %129, i64 -8
  %.3406.i.i = load double, ptr %.3405.i.i, align 8, !noalias !100
  %.3408.i.i = fsub contract double %.3406.i.i, %.1640.le.i
  store i64 0, ptr %.3454.i.i, align 8, !noalias !100
  call fastcc void @inner_8(ptr nonnull %.3454.i.i, ptr %.2862.i.i, i64 %.2698.i.i, ptr %.2997.i.i, i64 %.2758.i.i, double %prepared_grid_v291__vphi308_0.2.0.i.i, double %.3408.i.i)
  %.3472.i.i = load i64, ptr %.3454.i.i, align 8, !noalias !100
  %.13.i217.i.i = tail call i64 @llvm.smin.i64(i64 %.1116.i44, i64 %.3472.i.i)
  %.3547.i.i = getelementptr i8, ptr %.745.i.i, i64 8
  store i64 %.13.i217.i.i, ptr %.3547.i.i, align 8, !noalias !100
  %.3577.i.i = getelementptr i8, ptr %.745.i.i, i64 16
  store i64 0, ptr %.3577.i.i, align 8, !noalias !100
  %.135.i.i.i = load double, ptr %.2862.i.i, align 8, !noalias !103
  %.143.i.i.i = add nsw i64 %.526.i.i, -2
  %.181.i.i.i = icmp slt i64 %.526.i.i, 3
  %..143.i.i.i = select i1 %.181.i.i.i, i64 0, i64 %.143.i.i.i
  %.225207.i.i.i = icmp sgt i64 %..143.i.i.i, 0
  br i1 %.225207.i.i.i, label %B92.if.preheader.i.i.i, label %_ZN17bnserve_surrogate8tangents6_ratio13prepare_ratioB4v284B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE692Row_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20int64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_203_29_2c_20UniTuple_28array_28float64_2c_201d_2c_20C_29_20x_202_29_2c_20UniTuple_28array_28int64_2c_201d_2c_20C_29_20x_202_29_2c_20UniTuple_28array_28float64_2c_201d_2c_20C_29_20x_202_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_295ArrayIxLi1E1C7mutable7alignedEdx.exit.i

B96.if.i.i:                                       ; preds = %_ZN17bnserve_surrogate6kernel7_points10fill_cellsB4v165B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedExx5ArrayIdLi1E1C7mutable7alignedE.exit163.i.i, %for.end.2.i
  %lsr.iv43.i.i = phi ptr [ %scevgep44.i.i, %_ZN17bnserve_surrogate6kernel7_points10fill_cellsB4v165B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedExx5ArrayIdLi1E1C7mutable7alignedE.exit163.i.i ], [ %scevgep42.i.i, %for.end.2.i ]
  %lsr.iv30.i.i = phi ptr [ %scevgep31.i.i, %_ZN17bnserve_surrogate6kernel7_points10fill_cellsB4v165B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedExx5ArrayIdLi1E1C7mutable7alignedE.exit163.i.i ], [ %scevgep29.i.i94, %for.end.2.i ]
  %lsr.iv459.i.i = phi ptr [ %scevgep460.i.i, %_ZN17bnserve_surrogate6kernel7_points10fill_cellsB4v165B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedExx5ArrayIdLi1E1C7mutable7alignedE.exit163.i.i ], [ %scevgep458.i.i, %for.end.2.i ]
  %lsr.iv453.i.i = phi ptr [ %scevgep454.i.i, %_ZN17bnserve_surrogate6kernel7_points10fill_cellsB4v165B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedExx5ArrayIdLi1E1C7mutable7alignedE.exit163.i.i ], [ %invariant.gep.i.i, %for.end.2.i ]
  %lsr.iv450.i.i = phi ptr [ %scevgep451.i.i, %_ZN17bnserve_surrogate6kernel7_points10fill_cellsB4v165B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedExx5ArrayIdLi1E1C7mutable7alignedE.exit163.i.i ], [ %scevgep449.i.i, %for.end.2.i ]
  %lsr.iv446.i.i = phi ptr [ %scevgep447.i.i, %_ZN17bnserve_surrogate6kernel7_points10fill_cellsB4v165B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedExx5ArrayIdLi1E1C7mutable7alignedE.exit163.i.i ], [ %scevgep445.i.i, %for.end.2.i ]
  %lsr.iv442.i.i = phi ptr [ %scevgep443.i.i, %_ZN17bnserve_surrogate6kernel7_points10fill_cellsB4v165B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedExx5ArrayIdLi1E1C7mutable7alignedE.exit163.i.i ], [ %scevgep441.i.i, %for.end.2.i ]
  %lsr.iv430.i.i = phi ptr [ %scevgep431.i.i, %_ZN17bnserve_surrogate6kernel7_points10fill_cellsB4v165B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedExx5ArrayIdLi1E1C7mutable7alignedE.exit163.i.i ], [ %scevgep429.i.i, %for.end.2.i ]
  %lsr.iv425.i.i = phi ptr [ %scevgep426.i.i, %_ZN17bnserve_surrogate6kernel7_points10fill_cellsB4v165B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedExx5ArrayIdLi1E1C7mutable7alignedE.exit163.i.i ], [ %.683.i.i, %for.end.2.i ]
  %lsr.iv422.i.i = phi ptr [ %scevgep423.i.i, %_ZN17bnserve_surrogate6kernel7_points10fill_cellsB4v165B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedExx5ArrayIdLi1E1C7mutable7alignedE.exit163.i.i ], [ %scevgep421.i.i, %for.end.2.i ]
  %lsr.iv418.i.i = phi ptr [ %scevgep419.i.i, %_ZN17bnserve_surrogate6kernel7_points10fill_cellsB4v165B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedExx5ArrayIdLi1E1C7mutable7alignedE.exit163.i.i ], [ %scevgep417.i.i, %for.end.2.i ]
  %lsr.iv.i.i95 = phi ptr [ %scevgep415.i.i, %_ZN17bnserve_surrogate6kernel7_points10fill_cellsB4v165B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedExx5ArrayIdLi1E1C7mutable7alignedE.exit163.i.i ], [ %scevgep414.i.i, %for.end.2.i ]
  %.125817191728.i.i = phi i64 [ %.1265.i.i, %_ZN17bnserve_surrogate6kernel7_points10fill_cellsB4v165B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedExx5ArrayIdLi1E1C7mutable7alignedE.exit163.i.i ], [ 0, %for.end.2.i ]
  %.1265.i.i = add nuw nsw i64 %.125817191728.i.i, 1
  %.1388.i.i = load i64, ptr %.665.i.i, align 8, !noalias !100
  %.idx.i.i96 = mul i64 %.1388.i.i, 48
  br i1 %.507321.not.i.i.i, label %_ZN17bnserve_surrogate6kernel7_points10fill_cellsB4v165B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedExx5ArrayIdLi1E1C7mutable7alignedE.exit163.i.i, label %B94.if.lr.ph.i.i.i

B94.if.lr.ph.i.i.i:                               ; preds = %B96.if.i.i
  %scevgep432.i.i = getelementptr i8, ptr %lsr.iv430.i.i, i64 %.idx.i.i96
  %scevgep32.i.i97 = getelementptr i8, ptr %lsr.iv30.i.i, i64 %.idx.i.i96
  br label %B94.if.i.i.i

B94.if.i.i.i:                                     ; preds = %B94.if.i.i.i, %B94.if.lr.ph.i.i.i
  %lsr.iv28.i.i = phi i64 [ %lsr.iv.next29.i.i, %B94.if.i.i.i ], [ %123, %B94.if.lr.ph.i.i.i ]
  %lsr.iv53.i.i.i = phi i64 [ %lsr.iv.next54.i.i.i, %B94.if.i.i.i ], [ 0, %B94.if.lr.ph.i.i.i ]
  %scevgep34.i.i = getelementptr i8, ptr %scevgep32.i.i97, i64 %lsr.iv53.i.i.i
  %scevgep35.i.i98 = getelementptr i8, ptr %scevgep34.i.i, i64 -8
  %.554.i.i.i = load <8 x double>, ptr %scevgep35.i.i98, align 8, !noalias !106
  %.565.i.i.i = load <8 x double>, ptr %scevgep34.i.i, align 8, !noalias !106
  %scevgep433.i.i = getelementptr i8, ptr %scevgep432.i.i, i64 %lsr.iv53.i.i.i
  %.575.i.i.i = load <8 x double>, ptr %scevgep433.i.i, align 8, !noalias !106
  %scevgep434.i.i = getelementptr i8, ptr %scevgep433.i.i, i64 8
  %.586.i.i.i = load <8 x double>, ptr %scevgep434.i.i, align 8, !noalias !106
  %scevgep37.i.i99 = getelementptr i8, ptr %scevgep36.i.i, i64 %lsr.iv53.i.i.i
  %.596.i.i.i = load <8 x double>, ptr %scevgep37.i.i99, align 8, !noalias !106
  %scevgep33.i.i = getelementptr i8, ptr %scevgep30.i.i, i64 %lsr.iv53.i.i.i
  %.606.i.i.i = load <8 x double>, ptr %scevgep33.i.i, align 8, !noalias !106
  %.6.i.i.i.i100 = fsub contract <8 x double> %.565.i.i.i, %.554.i.i.i
  %.6.i46.i.i.i = fmul contract <8 x double> %.6.i.i.i.i100, %.606.i.i.i
  %scevgep427.i.i = getelementptr i8, ptr %lsr.iv425.i.i, i64 %lsr.iv53.i.i.i
  store <8 x double> %.554.i.i.i, ptr %scevgep427.i.i, align 8, !noalias !106
  %.669.i.i.i101 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.575.i.i.i, <8 x double> splat (double 2.000000e+00), <8 x double> %.586.i.i.i)
  %.8.i.i.i.i102 = fmul contract <8 x double> %.669.i.i.i101, splat (double 0x3FC5555555555555)
  %.6.i47.i.i.i = fmul contract <8 x double> %.596.i.i.i, %.8.i.i.i.i102
  %.6.i48.i.i.i = fsub contract <8 x double> %.6.i46.i.i.i, %.6.i47.i.i.i
  %scevgep424.i.i = getelementptr i8, ptr %lsr.iv422.i.i, i64 %lsr.iv53.i.i.i
  store <8 x double> %.6.i48.i.i.i, ptr %scevgep424.i.i, align 8, !noalias !106
  %.8.i49.i.i.i = fmul contract <8 x double> %.575.i.i.i, splat (double 5.000000e-01)
  %scevgep420.i.i = getelementptr i8, ptr %lsr.iv418.i.i, i64 %lsr.iv53.i.i.i
  store <8 x double> %.8.i49.i.i.i, ptr %scevgep420.i.i, align 8, !noalias !106
  %.6.i50.i.i.i = fsub contract <8 x double> %.586.i.i.i, %.575.i.i.i
  %.6.i51.i.i.i = fmul contract <8 x double> %.6.i50.i.i.i, %.606.i.i.i
  %.8.i52.i.i.i = fmul contract <8 x double> %.6.i51.i.i.i, splat (double 0x3FC5555555555555)
  %scevgep416.i.i = getelementptr i8, ptr %lsr.iv.i.i95, i64 %lsr.iv53.i.i.i
  store <8 x double> %.8.i52.i.i.i, ptr %scevgep416.i.i, align 8, !noalias !106
  %lsr.iv.next54.i.i.i = add i64 %lsr.iv53.i.i.i, 64
  %lsr.iv.next29.i.i = add nsw i64 %lsr.iv28.i.i, -1
  %.507.i.i.i = icmp sgt i64 %lsr.iv28.i.i, 8
  br i1 %.507.i.i.i, label %B94.if.i.i.i, label %B94.if.lr.ph.i127.i.i

B94.if.lr.ph.i127.i.i:                            ; preds = %B94.if.i.i.i
  %scevgep461.i.i = getelementptr i8, ptr %lsr.iv459.i.i, i64 %.idx.i.i96
  %scevgep45.i.i = getelementptr i8, ptr %lsr.iv43.i.i, i64 %.idx.i.i96
  br label %B94.if.i129.i.i

B94.if.i129.i.i:                                  ; preds = %B94.if.i129.i.i, %B94.if.lr.ph.i127.i.i
  %lsr.iv38.i.i = phi i64 [ %lsr.iv.next39.i.i, %B94.if.i129.i.i ], [ %123, %B94.if.lr.ph.i127.i.i ]
  %lsr.iv53.i130.i.i = phi i64 [ %lsr.iv.next54.i159.i.i, %B94.if.i129.i.i ], [ 0, %B94.if.lr.ph.i127.i.i ]
  %scevgep47.i.i = getelementptr i8, ptr %scevgep45.i.i, i64 %lsr.iv53.i130.i.i
  %scevgep48.i.i = getelementptr i8, ptr %scevgep47.i.i, i64 -8
  %.554.i133.i.i = load <8 x double>, ptr %scevgep48.i.i, align 8, !noalias !109
  %.565.i135.i.i = load <8 x double>, ptr %scevgep47.i.i, align 8, !noalias !109
  %scevgep462.i.i = getelementptr i8, ptr %scevgep461.i.i, i64 %lsr.iv53.i130.i.i
  %.575.i137.i.i = load <8 x double>, ptr %scevgep462.i.i, align 8, !noalias !109
  %scevgep463.i.i = getelementptr i8, ptr %scevgep462.i.i, i64 8
  %.586.i139.i.i = load <8 x double>, ptr %scevgep463.i.i, align 8, !noalias !109
  %scevgep49.i.i103 = getelementptr i8, ptr %scevgep36.i.i, i64 %lsr.iv53.i130.i.i
  %.596.i141.i.i = load <8 x double>, ptr %scevgep49.i.i103, align 8, !noalias !109
  %scevgep43.i.i104 = getelementptr i8, ptr %scevgep30.i.i, i64 %lsr.iv53.i130.i.i
  %.606.i143.i.i = load <8 x double>, ptr %scevgep43.i.i104, align 8, !noalias !109
  %.6.i.i144.i.i = fsub contract <8 x double> %.565.i135.i.i, %.554.i133.i.i
  %.6.i46.i145.i.i = fmul contract <8 x double> %.6.i.i144.i.i, %.606.i143.i.i
  %scevgep455.i.i = getelementptr i8, ptr %lsr.iv453.i.i, i64 %lsr.iv53.i130.i.i
  store <8 x double> %.554.i133.i.i, ptr %scevgep455.i.i, align 8, !noalias !109
  %.669.i147.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.575.i137.i.i, <8 x double> splat (double 2.000000e+00), <8 x double> %.586.i139.i.i)
  %.8.i.i148.i.i = fmul contract <8 x double> %.669.i147.i.i, splat (double 0x3FC5555555555555)
  %.6.i47.i149.i.i = fmul contract <8 x double> %.596.i141.i.i, %.8.i.i148.i.i
  %.6.i48.i150.i.i = fsub contract <8 x double> %.6.i46.i145.i.i, %.6.i47.i149.i.i
  %scevgep452.i.i = getelementptr i8, ptr %lsr.iv450.i.i, i64 %lsr.iv53.i130.i.i
  store <8 x double> %.6.i48.i150.i.i, ptr %scevgep452.i.i, align 8, !noalias !109
  %.8.i49.i152.i.i = fmul contract <8 x double> %.575.i137.i.i, splat (double 5.000000e-01)
  %scevgep448.i.i = getelementptr i8, ptr %lsr.iv446.i.i, i64 %lsr.iv53.i130.i.i
  store <8 x double> %.8.i49.i152.i.i, ptr %scevgep448.i.i, align 8, !noalias !109
  %.6.i50.i154.i.i = fsub contract <8 x double> %.586.i139.i.i, %.575.i137.i.i
  %.6.i51.i155.i.i = fmul contract <8 x double> %.6.i50.i154.i.i, %.606.i143.i.i
  %.8.i52.i156.i.i = fmul contract <8 x double> %.6.i51.i155.i.i, splat (double 0x3FC5555555555555)
  %scevgep444.i.i = getelementptr i8, ptr %lsr.iv442.i.i, i64 %lsr.iv53.i130.i.i
  store <8 x double> %.8.i52.i156.i.i, ptr %scevgep444.i.i, align 8, !noalias !109
  %lsr.iv.next54.i159.i.i = add i64 %lsr.iv53.i130.i.i, 64
  %lsr.iv.next39.i.i = add nsw i64 %lsr.iv38.i.i, -1
  %.507.i160.i.i = icmp sgt i64 %lsr.iv38.i.i, 8
  br i1 %.507.i160.i.i, label %B94.if.i129.i.i, label %_ZN17bnserve_surrogate6kernel7_points10fill_cellsB4v165B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedExx5ArrayIdLi1E1C7mutable7alignedE.exit163.i.i

_ZN17bnserve_surrogate6kernel7_points10fill_cellsB4v165B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedExx5ArrayIdLi1E1C7mutable7alignedE.exit163.i.i: ; preds = %B94.if.i129.i.i, %B96.if.i.i
  %scevgep415.i.i = getelementptr i8, ptr %lsr.iv.i.i95, i64 %106
  %scevgep419.i.i = getelementptr i8, ptr %lsr.iv418.i.i, i64 %106
  %scevgep423.i.i = getelementptr i8, ptr %lsr.iv422.i.i, i64 %106
  %scevgep426.i.i = getelementptr i8, ptr %lsr.iv425.i.i, i64 %106
  %scevgep431.i.i = getelementptr i8, ptr %lsr.iv430.i.i, i64 %112
  %scevgep443.i.i = getelementptr i8, ptr %lsr.iv442.i.i, i64 %106
  %scevgep447.i.i = getelementptr i8, ptr %lsr.iv446.i.i, i64 %106
  %scevgep451.i.i = getelementptr i8, ptr %lsr.iv450.i.i, i64 %106
  %scevgep454.i.i = getelementptr i8, ptr %lsr.iv453.i.i, i64 %106
  %scevgep460.i.i = getelementptr i8, ptr %lsr.iv459.i.i, i64 %112
  %scevgep31.i.i = getelementptr i8, ptr %lsr.iv30.i.i, i64 %112
  %scevgep44.i.i = getelementptr i8, ptr %lsr.iv43.i.i, i64 %112
  %exitcond.not.i.i105 = icmp eq i64 %.1265.i.i, 6
  br i1 %exitcond.not.i.i105, label %B398.i.i, label %B96.if.i.i

B34.if.lr.ph.i.i.i:                               ; preds = %B398.i.i
  %.223.i.i.i = fmul contract double %.2481.i.i, 2.000000e+00
  %.291.i.i.i = fmul contract double %.2481.i.i, 3.000000e+00
  %130 = mul i64 %.535.1.i.i, -24
  %scevgep1.i.i.i = getelementptr i8, ptr %.2259.i.i, i64 %130
  %scevgep3.i.i.i = getelementptr i8, ptr %.683.i.i, i64 %130
  %scevgep5.i.i.i = getelementptr i8, ptr %.2259.i.i, i64 %.1857.idx.i.i
  %scevgep7.i.i.i = getelementptr i8, ptr %.683.i.i, i64 %.1857.idx.i.i
  %scevgep9.i.i.i = getelementptr i8, ptr %.2259.i.i, i64 %.1549.i.i
  %scevgep11.i.i.i = getelementptr i8, ptr %.683.i.i, i64 %.1549.i.i
  br label %B34.if.i.i.i

B34.if.i.i.i:                                     ; preds = %B34.if.i.i.i, %B34.if.lr.ph.i.i.i
  %.126147149.i.i.i = phi i64 [ 0, %B34.if.lr.ph.i.i.i ], [ %.133.i.i.i, %B34.if.i.i.i ]
  %.133.i.i.i = add nuw nsw i64 %.126147149.i.i.i, 1
  %131 = shl i64 %.126147149.i.i.i, 3
  %scevgep12.i.i.i = getelementptr i8, ptr %scevgep11.i.i.i, i64 %131
  %.189.i.i.i = load double, ptr %scevgep12.i.i.i, align 8, !noalias !112
  %.191.i.i.i = fmul contract double %.2481.i.i, %.189.i.i.i
  %scevgep.i.i.i106 = getelementptr i8, ptr %.2259.i.i, i64 %131
  store double %.191.i.i.i, ptr %scevgep.i.i.i106, align 8, !noalias !112
  %scevgep27.i.i = getelementptr i8, ptr %scevgep7.i.i.i, i64 %131
  %.256.i.i.i = load double, ptr %scevgep27.i.i, align 8, !noalias !112
  %.257.i.i.i107 = fmul contract double %.223.i.i.i, %.256.i.i.i
  %scevgep26.i.i108 = getelementptr i8, ptr %scevgep9.i.i.i, i64 %131
  store double %.257.i.i.i107, ptr %scevgep26.i.i108, align 8, !noalias !112
  %scevgep25.i.i = getelementptr i8, ptr %scevgep3.i.i.i, i64 %131
  %.324.i.i.i = load double, ptr %scevgep25.i.i, align 8, !noalias !112
  %.325.i.i.i = fmul contract double %.291.i.i.i, %.324.i.i.i
  %scevgep23.i.i109 = getelementptr i8, ptr %scevgep5.i.i.i, i64 %131
  store double %.325.i.i.i, ptr %scevgep23.i.i109, align 8, !noalias !112
  %scevgep21.i.i = getelementptr i8, ptr %scevgep1.i.i.i, i64 %131
  store double 0.000000e+00, ptr %scevgep21.i.i, align 8, !noalias !112
  %exitcond.not.i.i.i = icmp eq i64 %.133.i.i.i, %.569.i.i
  br i1 %exitcond.not.i.i.i, label %B34.if.lr.ph.i180.i.i, label %B34.if.i.i.i

B34.if.lr.ph.i180.i.i:                            ; preds = %B34.if.i.i.i
  %scevgep1.i183.i.i = getelementptr i8, ptr %.2326.i.i, i64 %130
  %scevgep3.i184.i.i = getelementptr i8, ptr %invariant.gep.i.i, i64 %130
  %scevgep5.i185.i.i = getelementptr i8, ptr %.2326.i.i, i64 %.1857.idx.i.i
  %scevgep7.i186.i.i = getelementptr i8, ptr %invariant.gep.i.i, i64 %.1857.idx.i.i
  %scevgep9.i187.i.i = getelementptr i8, ptr %.2326.i.i, i64 %.1549.i.i
  %scevgep11.i188.i.i = getelementptr i8, ptr %invariant.gep.i.i, i64 %.1549.i.i
  %.neg4.i.i = mul i64 %104, -3328
  %132 = getelementptr i8, ptr %arg.state.16.4, i64 %.neg4.i.i
  %scevgep407.i.i = getelementptr i8, ptr %132, i64 %.683.idx.i.i
  br label %B34.if.i189.i.i

B34.if.i189.i.i:                                  ; preds = %B34.if.i189.i.i, %B34.if.lr.ph.i180.i.i
  %.126147149.i190.i.i = phi i64 [ 0, %B34.if.lr.ph.i180.i.i ], [ %.133.i191.i.i, %B34.if.i189.i.i ]
  %.133.i191.i.i = add nuw nsw i64 %.126147149.i190.i.i, 1
  %133 = shl i64 %.126147149.i190.i.i, 3
  %scevgep12.i192.i.i = getelementptr i8, ptr %scevgep11.i188.i.i, i64 %133
  %.189.i193.i.i = load double, ptr %scevgep12.i192.i.i, align 8, !noalias !115
  %.191.i194.i.i = fmul contract double %.2481.i.i, %.189.i193.i.i
  %scevgep408.i.i = getelementptr i8, ptr %scevgep407.i.i, i64 %133
  store double %.191.i194.i.i, ptr %scevgep408.i.i, align 8, !noalias !115
  %scevgep20.i.i110 = getelementptr i8, ptr %scevgep7.i186.i.i, i64 %133
  %.256.i197.i.i = load double, ptr %scevgep20.i.i110, align 8, !noalias !115
  %.257.i198.i.i = fmul contract double %.223.i.i.i, %.256.i197.i.i
  %scevgep19.i.i = getelementptr i8, ptr %scevgep9.i187.i.i, i64 %133
  store double %.257.i198.i.i, ptr %scevgep19.i.i, align 8, !noalias !115
  %scevgep14.i.i111 = getelementptr i8, ptr %scevgep3.i184.i.i, i64 %133
  %.324.i201.i.i = load double, ptr %scevgep14.i.i111, align 8, !noalias !115
  %.325.i202.i.i = fmul contract double %.291.i.i.i, %.324.i201.i.i
  %scevgep13.i.i = getelementptr i8, ptr %scevgep5.i185.i.i, i64 %133
  store double %.325.i202.i.i, ptr %scevgep13.i.i, align 8, !noalias !115
  %scevgep12.i.i112 = getelementptr i8, ptr %scevgep1.i183.i.i, i64 %133
  store double 0.000000e+00, ptr %scevgep12.i.i112, align 8, !noalias !115
  %exitcond.not.i205.i.i = icmp eq i64 %.133.i191.i.i, %.569.i.i
  br i1 %exitcond.not.i205.i.i, label %_ZN17bnserve_surrogate8tangents8_carrier11fill_slopesB4v166B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedExd5ArrayIdLi1E1C7mutable7alignedE.exit206.i.i, label %B34.if.i189.i.i

_ZN17bnserve_surrogate8tangents8_carrier11fill_slopesB4v166B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedExd5ArrayIdLi1E1C7mutable7alignedE.exit206.i.i: ; preds = %B34.if.i189.i.i, %B398.i.i
  %.2698.i.i = load i64, ptr %.291.i16, align 8, !noalias !100
  %.2728.i.i = load i64, ptr %.386.i20, align 8, !noalias !100
  %.2758.i.i = load i64, ptr %.416.i22, align 8, !noalias !100
  %.2795.i.i = load i64, ptr %.453.i24, align 8, !noalias !100
  %.2797.i.i = inttoptr i64 %.2795.i.i to ptr
  %.2862.i.i = getelementptr inbounds double, ptr %.2797.i.i, i64 %.2728.i.i
  %.2920.i.i = icmp sgt i64 %.2758.i.i, 0
  br i1 %.2920.i.i, label %B6275.i.i, label %B6355.i.i

B92.if.preheader.i.i.i:                           ; preds = %B6355.i.i
  %134 = add i64 %.13.i217.i.i, -1
  %135 = shl i64 %.2728.i.i, 3
  %136 = getelementptr i8, ptr %.2797.i.i, i64 %135
  %scevgep.i.i113 = getelementptr i8, ptr %136, i64 8
  br label %B92.if.i.i.i

B146.i.i.i:                                       ; preds = %B92.if.i.i.i
  %.291.i223.i.i = fsub contract double %.281.i.i.i, %.135.i.i.i
  %.293.i.i.i = fmul contract double %prepared_grid_v291__vphi308_0.2.0.i.i, %.291.i223.i.i
  %.5.i.i.i.i114 = fptosi double %.293.i.i.i to i64
  %.13.i5.i.i.i = tail call i64 @llvm.smin.i64(i64 %.2758.i.i, i64 %.5.i.i.i.i114)
  %.354.i.i.i = getelementptr inbounds i64, ptr %.2997.i.i, i64 %.13.i5.i.i.i
  %.355.i.i.i = load i64, ptr %.354.i.i.i, align 8, !noalias !103
  %.13.i6.i.i.i = tail call i64 @llvm.smax.i64(i64 %.355.i.i.i, i64 %end.3.0210.i.i.i)
  %.395.i.i.i = icmp slt i64 %.13.i6.i.i.i, %.13.i217.i.i
  br i1 %.395.i.i.i, label %B284.i.i.i, label %B386.i.i.i

B284.i.i.i:                                       ; preds = %B146.i.i.i
  %.412.i.i.i = getelementptr inbounds nuw double, ptr %.2862.i.i, i64 %.13.i6.i.i.i
  %.413.i.i.i = load double, ptr %.412.i.i.i, align 8, !noalias !103
  %.417.i.i.i = fcmp contract ugt double %.413.i.i.i, %.281.i.i.i
  br i1 %.417.i.i.i, label %B386.i.i.i, label %B324.i.i.i

B324.i.i.i:                                       ; preds = %B284.i.i.i, %B346.i.i.i
  %end.5.2.i.i.i = phi i64 [ %.423.i.i.i, %B346.i.i.i ], [ %.13.i6.i.i.i, %B284.i.i.i ]
  %exitcond.not.i224.i.i = icmp eq i64 %134, %end.5.2.i.i.i
  br i1 %exitcond.not.i224.i.i, label %B386.i.i.i, label %B346.i.i.i

B346.i.i.i:                                       ; preds = %B324.i.i.i
  %.423.i.i.i = add i64 %end.5.2.i.i.i, 1
  %137 = shl i64 %end.5.2.i.i.i, 3
  %scevgep401.i.i = getelementptr i8, ptr %scevgep.i.i113, i64 %137
  %.451.i.i.i = load double, ptr %scevgep401.i.i, align 8, !noalias !103
  %.455.i.i.i = fcmp contract ugt double %.451.i.i.i, %.281.i.i.i
  br i1 %.455.i.i.i, label %B386.i.i.i, label %B324.i.i.i

B386.i.i.i:                                       ; preds = %B346.i.i.i, %B324.i.i.i, %B92.if.i.i.i, %B284.i.i.i, %B146.i.i.i
  %end.4.1.i.i.i = phi i64 [ %.13.i6.i.i.i, %B146.i.i.i ], [ %end.3.0210.i.i.i, %B92.if.i.i.i ], [ %.13.i6.i.i.i, %B284.i.i.i ], [ %.13.i217.i.i, %B324.i.i.i ], [ %.423.i.i.i, %B346.i.i.i ]
  %.13.i.i.i.i = tail call i64 @llvm.smin.i64(i64 %.13.i217.i.i, i64 %end.4.1.i.i.i)
  %138 = getelementptr i64, ptr %.809.i.i, i64 %.231203208.i.i.i
  store i64 %.13.i.i.i.i, ptr %138, align 8, !noalias !103
  %exitcond216.not.i.i.i = icmp eq i64 %.238.i.i.i, %..143.i.i.i
  br i1 %exitcond216.not.i.i.i, label %_ZN17bnserve_surrogate8tangents6_ratio13prepare_ratioB4v284B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE692Row_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20int64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_203_29_2c_20UniTuple_28array_28float64_2c_201d_2c_20C_29_20x_202_29_2c_20UniTuple_28array_28int64_2c_201d_2c_20C_29_20x_202_29_2c_20UniTuple_28array_28float64_2c_201d_2c_20C_29_20x_202_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_295ArrayIxLi1E1C7mutable7alignedEdx.exit.i, label %B92.if.i.i.i

B92.if.i.i.i:                                     ; preds = %B386.i.i.i, %B92.if.preheader.i.i.i
  %end.3.0210.i.i.i = phi i64 [ %end.4.1.i.i.i, %B386.i.i.i ], [ 0, %B92.if.preheader.i.i.i ]
  %.231203208.i.i.i = phi i64 [ %.238.i.i.i, %B386.i.i.i ], [ 0, %B92.if.preheader.i.i.i ]
  %.238.i.i.i = add nuw nsw i64 %.231203208.i.i.i, 1
  %sunkaddr470.i.i = shl i64 %.231203208.i.i.i, 3
  %sunkaddr471.i.i = getelementptr inbounds i8, ptr %.903.i.i, i64 %sunkaddr470.i.i
  %sunkaddr472.i.i = getelementptr inbounds nuw i8, ptr %sunkaddr471.i.i, i64 8
  %.279.i.i.i = load double, ptr %sunkaddr472.i.i, align 8, !noalias !103
  %.281.i.i.i = fsub contract double %.279.i.i.i, %.1640.le.i
  %.287.i.i.i = fcmp contract ult double %.281.i.i.i, %.135.i.i.i
  br i1 %.287.i.i.i, label %B386.i.i.i, label %B146.i.i.i

_ZN17bnserve_surrogate8tangents6_ratio13prepare_ratioB4v284B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE692Row_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20int64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_203_29_2c_20UniTuple_28array_28float64_2c_201d_2c_20C_29_20x_202_29_2c_20UniTuple_28array_28int64_2c_201d_2c_20C_29_20x_202_29_2c_20UniTuple_28array_28float64_2c_201d_2c_20C_29_20x_202_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_295ArrayIxLi1E1C7mutable7alignedEdx.exit.i: ; preds = %B386.i.i.i, %B6355.i.i
  %.586.inv.i.i.i = icmp sgt i64 %.526.i.i, 1
  %.587.i.i.i = select i1 %.586.inv.i.i.i, i64 0, i64 %.569.i.i
  %139 = getelementptr i64, ptr %.809.i.i, i64 %.143.i.i.i
  %.601.i.i.i = getelementptr i64, ptr %139, i64 %.587.i.i.i
  store i64 %.13.i217.i.i, ptr %.601.i.i.i, align 8, !noalias !103
  call void @llvm.lifetime.end.p0(ptr nonnull %.3274.i.i), !noalias !96
  call void @llvm.lifetime.end.p0(ptr nonnull %.3454.i.i), !noalias !96
  br label %B752.i

B920.if.i61:                                      ; preds = %B920.loopexit.i, %B920.if.lr.ph.i
  %lsr.iv189.i = phi i64 [ 7, %B920.if.lr.ph.i ], [ %lsr.iv.next190.i, %B920.loopexit.i ]
  %lsr.iv187.i = phi i64 [ 128, %B920.if.lr.ph.i ], [ %lsr.iv.next.i77, %B920.loopexit.i ]
  %cells.2.sroa.0.02188.i = phi i64 [ 0, %B920.if.lr.ph.i ], [ %cells.3.sroa.0.1.i66, %B920.loopexit.i ]
  %cells.2.sroa.13.02187.i = phi i64 [ 0, %B920.if.lr.ph.i ], [ %cells.3.sroa.10.1.i65, %B920.loopexit.i ]
  %.183621382186.i = phi i64 [ %.1816.i57, %B920.if.lr.ph.i ], [ %.1846.i, %B920.loopexit.i ]
  %.184321492185.i = phi i64 [ 0, %B920.if.lr.ph.i ], [ %.1850.i, %B920.loopexit.i ]
  %.1846.i = add nsw i64 %.183621382186.i, -1
  %.1850.i = add nuw i64 %.184321492185.i, 128
  %.13.i.i62 = tail call i64 @llvm.smin.i64(i64 %.292.i17, i64 %.1850.i)
  %.13.i78.i = tail call i64 @llvm.smax.i64(i64 %.184321492185.i, i64 %.1116.i44)
  %.13.i79.i = tail call i64 @llvm.smin.i64(i64 %.13.i.i62, i64 %.13.i78.i)
  %.1984.i63 = icmp sgt i64 %.13.i79.i, %.184321492185.i
  br i1 %.1984.i63, label %B1104.i85, label %B1184.i64

B48.if.i.i:                                       ; preds = %B48.if.i.i, %B48.if.i.preheader.i
  %lsr.iv8.i = phi i64 [ %lsr.iv.next9.i, %B48.if.i.i ], [ %71, %B48.if.i.preheader.i ]
  %lsr.iv.i89 = phi ptr [ %scevgep.i93, %B48.if.i.i ], [ %.2214.i, %B48.if.i.preheader.i ]
  %.165.i.i = load <8 x double>, ptr %lsr.iv.i89, align 8, !noalias !118
  %.8.i.i.i90 = fmul contract <8 x double> %.7.i.i.i, %.165.i.i
  %.195.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i.i.i90, <8 x double> splat (double 0x3FE45F306DC9C883), <8 x double> splat (double 0x4338000000000000))
  %.8.i191.i.i = fadd contract <8 x double> %.195.i.i, splat (double 0xC338000000000000)
  %.236.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i191.i.i, <8 x double> splat (double 0xBFF921FB54442D18), <8 x double> %.8.i.i.i90)
  %.253.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i191.i.i, <8 x double> splat (double 0xBC91A62633145C07), <8 x double> %.236.i.i)
  %.6.i192.i.i = fmul contract <8 x double> %.253.i.i, %.253.i.i
  %.6.i193.i.i = fmul contract <8 x double> %.253.i.i, %.6.i192.i.i
  %.282.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i192.i.i, <8 x double> splat (double 0xBD6AE7F3E733B81F), <8 x double> splat (double 0x3DE6124613A86D09))
  %.285.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i192.i.i, <8 x double> %.282.i.i, <8 x double> splat (double 0xBE5AE64567F544E4))
  %.288.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i192.i.i, <8 x double> %.285.i.i, <8 x double> splat (double 0x3EC71DE3A556C734))
  %.291.i.i91 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i192.i.i, <8 x double> %.288.i.i, <8 x double> splat (double 0xBF2A01A01A01A01A))
  %.294.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i192.i.i, <8 x double> %.291.i.i91, <8 x double> splat (double 0x3F81111111111111))
  %.297.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i192.i.i, <8 x double> %.294.i.i, <8 x double> splat (double 0xBFC5555555555555))
  %.322.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i193.i.i, <8 x double> %.297.i.i, <8 x double> %.253.i.i)
  %.327.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i192.i.i, <8 x double> splat (double 0x3D2AE7F3E733B81F), <8 x double> splat (double 0xBDA93974A8C07C9D))
  %.330.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i192.i.i, <8 x double> %.327.i.i, <8 x double> splat (double 0x3E21EED8EFF8D898))
  %.333.i.i92 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i192.i.i, <8 x double> %.330.i.i, <8 x double> splat (double 0xBE927E4FB7789F5C))
  %.336.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i192.i.i, <8 x double> %.333.i.i92, <8 x double> splat (double 0x3EFA01A01A01A01A))
  %.339.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i192.i.i, <8 x double> %.336.i.i, <8 x double> splat (double 0xBF56C16C16C16C17))
  %.342.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i192.i.i, <8 x double> %.339.i.i, <8 x double> splat (double 0x3FA5555555555555))
  %.345.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i192.i.i, <8 x double> %.342.i.i, <8 x double> splat (double -5.000000e-01))
  %.348.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i192.i.i, <8 x double> %.345.i.i, <8 x double> splat (double 1.000000e+00))
  %.349.i.i = bitcast <8 x double> %.195.i.i to <8 x i64>
  %.350.i.i = bitcast <8 x double> %.322.i.i to <8 x i64>
  %.351.i.i = bitcast <8 x double> %.348.i.i to <8 x i64>
  %.6.i194.i.i = xor <8 x i64> %.351.i.i, %.350.i.i
  %.8.i195.i.i = and <8 x i64> %.349.i.i, splat (i64 1)
  %140 = icmp eq <8 x i64> %.8.i195.i.i, zeroinitializer
  %.6.i197.i.i = select <8 x i1> %140, <8 x i64> zeroinitializer, <8 x i64> %.6.i194.i.i
  %.8.i198.i.i = shl <8 x i64> %.349.i.i, splat (i64 62)
  %.8.i199.i.i = and <8 x i64> %.8.i198.i.i, splat (i64 -9223372036854775808)
  %.8.i201.i.i = add <8 x i64> %.8.i198.i.i, splat (i64 4611686018427387904)
  %.8.i202.i.i = and <8 x i64> %.8.i201.i.i, splat (i64 -9223372036854775808)
  %141 = xor <8 x i64> %.8.i199.i.i, %.350.i.i
  %.6.i204.i.i = xor <8 x i64> %141, %.6.i197.i.i
  %142 = bitcast <8 x i64> %.6.i204.i.i to <8 x double>
  %143 = xor <8 x i64> %.8.i202.i.i, %.351.i.i
  %.6.i206.i.i = xor <8 x i64> %143, %.6.i197.i.i
  %144 = bitcast <8 x i64> %.6.i206.i.i to <8 x double>
  %scevgep186.i = getelementptr i8, ptr %lsr.iv.i89, i64 -1088
  %.695.i.i = load <8 x double>, ptr %scevgep186.i, align 8, !noalias !118
  %.6.i207.i.i = fmul contract <8 x double> %.695.i.i, %144
  store <8 x double> %.6.i207.i.i, ptr %scevgep186.i, align 8, !noalias !118
  %.6.i208.i.i = fmul contract <8 x double> %.695.i.i, %142
  store <8 x double> %.6.i208.i.i, ptr %lsr.iv.i89, align 8, !noalias !118
  %scevgep.i93 = getelementptr i8, ptr %lsr.iv.i89, i64 64
  %lsr.iv.next9.i = add nsw i64 %lsr.iv8.i, -1
  %.117.i.i = icmp sgt i64 %lsr.iv8.i, 7
  br i1 %.117.i.i, label %B48.if.i.i, label %B1184.i64

B1350.if.i:                                       ; preds = %_ZN17bnserve_surrogate8tangents4_row11_write_modeB4v413B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi3EEd692Row_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20int64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_203_29_2c_20UniTuple_28array_28float64_2c_201d_2c_20C_29_20x_202_29_2c_20UniTuple_28array_28int64_2c_201d_2c_20C_29_20x_202_29_2c_20UniTuple_28array_28float64_2c_201d_2c_20C_29_20x_202_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29.exit.i, %B1350.if.preheader.i
  %lsr.iv195.i = phi i64 [ %lsr.iv.next196.i, %_ZN17bnserve_surrogate8tangents4_row11_write_modeB4v413B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi3EEd692Row_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20int64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_203_29_2c_20UniTuple_28array_28float64_2c_201d_2c_20C_29_20x_202_29_2c_20UniTuple_28array_28int64_2c_201d_2c_20C_29_20x_202_29_2c_20UniTuple_28array_28float64_2c_201d_2c_20C_29_20x_202_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29.exit.i ], [ %66, %B1350.if.preheader.i ]
  %lsr.iv193.i = phi i64 [ %lsr.iv.next194.i, %_ZN17bnserve_surrogate8tangents4_row11_write_modeB4v413B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi3EEd692Row_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20int64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_203_29_2c_20UniTuple_28array_28float64_2c_201d_2c_20C_29_20x_202_29_2c_20UniTuple_28array_28int64_2c_201d_2c_20C_29_20x_202_29_2c_20UniTuple_28array_28float64_2c_201d_2c_20C_29_20x_202_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29.exit.i ], [ %65, %B1350.if.preheader.i ]
  %.2582.i = load i64, ptr %.393, align 8, !noalias !96
  %.2586.i = inttoptr i64 %.2582.i to ptr
  %scevgep197.i = getelementptr i8, ptr %.2586.i, i64 %lsr.iv195.i
  %.398.i.i = load i64, ptr %.2586.i, align 8, !noalias !121
  %.427.i.i = getelementptr i8, ptr %scevgep197.i, i64 8
  %.428.i.i = load i64, ptr %.427.i.i, align 8, !noalias !121
  %.457.i.i67 = getelementptr i8, ptr %scevgep197.i, i64 16
  %.458.i.i = load i64, ptr %.457.i.i67, align 8, !noalias !121
  %.497.i.i = load i64, ptr %scevgep197.i, align 8, !noalias !121
  %.498.i.i = sitofp i64 %.497.i.i to double
  %.499.i.i = fmul contract double %.498.i.i, 5.000000e-01
  %.504.i.i = icmp eq i64 %.458.i.i, 0
  br i1 %.504.i.i, label %B250.i.i, label %B1214.i.i

B250.i.i:                                         ; preds = %B1350.if.i
  %.1202.i.i = mul nsw i64 %.398.i.i, %arg.i
  %.1203.i.i = add nsw i64 %.1202.i.i, %.428.i.i
  %.1395.i.i = mul nsw i64 %.1203.i.i, 6
  %.6.i.i.i6.i = insertelement <8 x double> poison, double %.499.i.i, i64 0
  %.7.i.i.i.i80 = shufflevector <8 x double> %.6.i.i.i6.i, <8 x double> poison, <8 x i32> zeroinitializer
  br label %B294.if.i.i

B34.if.preheader.i.i.i:                           ; preds = %B294.if.i.i
  br i1 %92, label %B34.if.epil.preheader.i.i.i, label %B34.if.preheader.new.i.i.i

B34.if.preheader.new.i.i.i:                       ; preds = %B34.if.preheader.i.i.i
  %145 = inttoptr i64 %.1244.i.i to ptr
  %scevgep.i.i7.i = getelementptr i8, ptr %145, i64 24
  br i1 %93, label %B34.if.i.epil.preheader.i.i, label %B34.if.i.preheader.i.i

B34.if.i.preheader.i.i:                           ; preds = %B34.if.preheader.new.i.i.i
  %scevgep.i8.i = getelementptr i8, ptr %145, i64 56
  br label %B34.if.i.i9.i

B102.loopexit.unr-lcssa.i.unr-lcssa.i.i:          ; preds = %B34.if.i.i9.i
  %scevgep11.i.i81 = getelementptr i8, ptr %lsr.iv.i10.i, i64 32
  br i1 %95, label %B34.if.i.epil.preheader.i.i, label %B102.loopexit.unr-lcssa.i.i.i

B34.if.i.epil.preheader.i.i:                      ; preds = %B102.loopexit.unr-lcssa.i.unr-lcssa.i.i, %B34.if.preheader.new.i.i.i
  %lsr.iv.i.epil.init.i.i = phi ptr [ %scevgep.i.i7.i, %B34.if.preheader.new.i.i.i ], [ %scevgep11.i.i81, %B102.loopexit.unr-lcssa.i.unr-lcssa.i.i ]
  %.134108110.i.epil.init.i.i = phi i64 [ 0, %B34.if.preheader.new.i.i.i ], [ %.141.1.i.1.i.i, %B102.loopexit.unr-lcssa.i.unr-lcssa.i.i ]
  %scevgep4.i.epil.i.i = getelementptr i8, ptr %lsr.iv.i.epil.init.i.i, i64 -24
  %.196.i.epil.i.i = load double, ptr %scevgep4.i.epil.i.i, align 8, !noalias !124
  %sunkaddr.i.i = shl i64 %.134108110.i.epil.init.i.i, 3
  %sunkaddr596.i.i = getelementptr i8, ptr %arg.state.15.4, i64 %sunkaddr.i.i
  %sunkaddr597.i.i = getelementptr i8, ptr %sunkaddr596.i.i, i64 5440
  store double %.196.i.epil.i.i, ptr %sunkaddr597.i.i, align 8, !noalias !124
  %scevgep5.i.epil.i.i = getelementptr i8, ptr %lsr.iv.i.epil.init.i.i, i64 -16
  %.258.i.epil.i.i = load double, ptr %scevgep5.i.epil.i.i, align 8, !noalias !124
  %sunkaddr600.i.i = getelementptr i8, ptr %sunkaddr596.i.i, i64 6528
  store double %.258.i.epil.i.i, ptr %sunkaddr600.i.i, align 8, !noalias !124
  %.141.1.i.epil.i.i = add nuw i64 %.134108110.i.epil.init.i.i, 2
  %scevgep3.i.epil.i.i = getelementptr i8, ptr %lsr.iv.i.epil.init.i.i, i64 -8
  %.196.1.i.epil.i.i = load double, ptr %scevgep3.i.epil.i.i, align 8, !noalias !124
  %sunkaddr603.i.i = getelementptr i8, ptr %sunkaddr596.i.i, i64 5448
  store double %.196.1.i.epil.i.i, ptr %sunkaddr603.i.i, align 8, !noalias !124
  %.258.1.i.epil.i.i = load double, ptr %lsr.iv.i.epil.init.i.i, align 8, !noalias !124
  %sunkaddr606.i.i = getelementptr i8, ptr %sunkaddr596.i.i, i64 6536
  store double %.258.1.i.epil.i.i, ptr %sunkaddr606.i.i, align 8, !noalias !124
  br label %B102.loopexit.unr-lcssa.i.i.i

B102.loopexit.unr-lcssa.i.i.i:                    ; preds = %B34.if.i.epil.preheader.i.i, %B102.loopexit.unr-lcssa.i.unr-lcssa.i.i
  %.141.1.i.lcssa.i.i = phi i64 [ %.141.1.i.epil.i.i, %B34.if.i.epil.preheader.i.i ], [ %.141.1.i.1.i.i, %B102.loopexit.unr-lcssa.i.unr-lcssa.i.i ]
  br i1 %97, label %B1154.i.i, label %B34.if.epil.preheader.i.i.i

B34.if.epil.preheader.i.i.i:                      ; preds = %B102.loopexit.unr-lcssa.i.i.i, %B34.if.preheader.i.i.i
  %.134108110.epil.init.i.i.i = phi i64 [ 0, %B34.if.preheader.i.i.i ], [ %.141.1.i.lcssa.i.i, %B102.loopexit.unr-lcssa.i.i.i ]
  %146 = inttoptr i64 %.1244.i.i to ptr
  %.idx.epil.i.i.i = shl i64 %.134108110.epil.init.i.i.i, 4
  %147 = getelementptr i8, ptr %146, i64 %.idx.epil.i.i.i
  %.196.epil.i.i.i = load double, ptr %147, align 8, !noalias !124
  %sunkaddr607.i.i = shl i64 %.134108110.epil.init.i.i.i, 3
  %sunkaddr608.i.i = getelementptr i8, ptr %arg.state.15.4, i64 %sunkaddr607.i.i
  %sunkaddr609.i.i = getelementptr i8, ptr %sunkaddr608.i.i, i64 5440
  store double %.196.epil.i.i.i, ptr %sunkaddr609.i.i, align 8, !noalias !124
  %148 = getelementptr i8, ptr %147, i64 8
  %.258.epil.i.i.i = load double, ptr %148, align 8, !noalias !124
  %sunkaddr612.i.i = getelementptr i8, ptr %sunkaddr608.i.i, i64 6528
  store double %.258.epil.i.i.i, ptr %sunkaddr612.i.i, align 8, !noalias !124
  br label %B1154.i.i

B34.if.i.i9.i:                                    ; preds = %B34.if.i.i9.i, %B34.if.i.preheader.i.i
  %lsr.iv9.i.i = phi i64 [ %lsr.iv.next10.i.i, %B34.if.i.i9.i ], [ %90, %B34.if.i.preheader.i.i ]
  %lsr.iv.i10.i = phi ptr [ %scevgep471.i.i, %B34.if.i.i9.i ], [ %scevgep.i8.i, %B34.if.i.preheader.i.i ]
  %.134108110.i.i.i = phi i64 [ %.141.1.i.1.i.i, %B34.if.i.i9.i ], [ 0, %B34.if.i.preheader.i.i ]
  %scevgep476.i.i = getelementptr i8, ptr %lsr.iv.i10.i, i64 -32
  %scevgep479.i.i = getelementptr i8, ptr %lsr.iv.i10.i, i64 -56
  %.196.i.i.i = load double, ptr %scevgep479.i.i, align 8, !noalias !124
  %sunkaddr116.i.i = shl i64 %.134108110.i.i.i, 3
  %sunkaddr117.i.i = getelementptr i8, ptr %arg.state.15.4, i64 %sunkaddr116.i.i
  %sunkaddr118.i.i = getelementptr i8, ptr %sunkaddr117.i.i, i64 5440
  store double %.196.i.i.i, ptr %sunkaddr118.i.i, align 8, !noalias !124
  %scevgep478.i.i = getelementptr i8, ptr %lsr.iv.i10.i, i64 -48
  %.258.i.i.i = load double, ptr %scevgep478.i.i, align 8, !noalias !124
  %sunkaddr121.i.i = getelementptr i8, ptr %sunkaddr117.i.i, i64 6528
  store double %.258.i.i.i, ptr %sunkaddr121.i.i, align 8, !noalias !124
  %scevgep477.i.i = getelementptr i8, ptr %lsr.iv.i10.i, i64 -40
  %.196.1.i.i.i = load double, ptr %scevgep477.i.i, align 8, !noalias !124
  %sunkaddr124.i.i = getelementptr i8, ptr %sunkaddr117.i.i, i64 5448
  store double %.196.1.i.i.i, ptr %sunkaddr124.i.i, align 8, !noalias !124
  %.258.1.i.i.i = load double, ptr %scevgep476.i.i, align 8, !noalias !124
  %sunkaddr127.i.i = getelementptr i8, ptr %sunkaddr117.i.i, i64 6536
  store double %.258.1.i.i.i, ptr %sunkaddr127.i.i, align 8, !noalias !124
  %scevgep475.i.i = getelementptr i8, ptr %lsr.iv.i10.i, i64 -24
  %.196.i.1.i.i = load double, ptr %scevgep475.i.i, align 8, !noalias !124
  %sunkaddr130.i.i = getelementptr i8, ptr %sunkaddr117.i.i, i64 5456
  store double %.196.i.1.i.i, ptr %sunkaddr130.i.i, align 8, !noalias !124
  %scevgep474.i.i = getelementptr i8, ptr %lsr.iv.i10.i, i64 -16
  %.258.i.1.i.i = load double, ptr %scevgep474.i.i, align 8, !noalias !124
  %sunkaddr133.i.i = getelementptr i8, ptr %sunkaddr117.i.i, i64 6544
  store double %.258.i.1.i.i, ptr %sunkaddr133.i.i, align 8, !noalias !124
  %.141.1.i.1.i.i = add i64 %.134108110.i.i.i, 4
  %scevgep473.i.i = getelementptr i8, ptr %lsr.iv.i10.i, i64 -8
  %.196.1.i.1.i.i = load double, ptr %scevgep473.i.i, align 8, !noalias !124
  %sunkaddr134.i.i = shl i64 %.141.1.i.1.i.i, 3
  %sunkaddr135.i.i = getelementptr i8, ptr %arg.state.15.4, i64 %sunkaddr134.i.i
  %sunkaddr136.i.i = getelementptr i8, ptr %sunkaddr135.i.i, i64 5432
  store double %.196.1.i.1.i.i, ptr %sunkaddr136.i.i, align 8, !noalias !124
  %.258.1.i.1.i.i = load double, ptr %lsr.iv.i10.i, align 8, !noalias !124
  %sunkaddr140.i.i = getelementptr i8, ptr %sunkaddr135.i.i, i64 6520
  store double %.258.1.i.1.i.i, ptr %sunkaddr140.i.i, align 8, !noalias !124
  %scevgep471.i.i = getelementptr i8, ptr %lsr.iv.i10.i, i64 64
  %lsr.iv.next10.i.i = add i64 %lsr.iv9.i.i, 2
  %niter465.ncmp.1.i.i = icmp eq i64 %lsr.iv.next10.i.i, 0
  br i1 %niter465.ncmp.1.i.i, label %B102.loopexit.unr-lcssa.i.unr-lcssa.i.i, label %B34.if.i.i9.i

B1154.i.i:                                        ; preds = %B294.if.i.i, %B34.if.epil.preheader.i.i.i, %B102.loopexit.unr-lcssa.i.i.i
  %.idx3828.i.i = mul nuw nsw i64 %.106038983906.i.i, 1088
  %149 = getelementptr i8, ptr %arg.state.15.4, i64 %.idx3828.i.i
  br i1 %.637334.not.i.i.i, label %B1154.endif.endif.endif.i.i, label %B48.if.i.preheader.i.i

B48.if.i.preheader.i.i:                           ; preds = %B1154.i.i
  %150 = inttoptr i64 %.1400.i.i to ptr
  br label %B48.if.i.i.i

B1214.i.i:                                        ; preds = %B1350.if.i
  %.1985.i.i = getelementptr i8, ptr %.2586.i, i64 16
  %.1986.i.i = load i64, ptr %.1985.i.i, align 8, !noalias !121
  %.1994.i.i = mul nsw i64 %.398.i.i, 40
  %.1995.i.i = add nsw i64 %.1986.i.i, %.1994.i.i
  %.1996.i.i = inttoptr i64 %.1995.i.i to ptr
  %.2071.i.i = getelementptr i8, ptr %.1996.i.i, i64 16
  %.2072.i.i = load double, ptr %.2071.i.i, align 8, !noalias !121
  %.2223.i.i = load i64, ptr %.453.i24, align 8, !noalias !121
  %.2225.i.i = inttoptr i64 %.2223.i.i to ptr
  %.2654.i.i = load i64, ptr %.386.i20, align 8, !noalias !121
  %.idx.i1.i = shl i64 %.2654.i.i, 4
  %151 = getelementptr i8, ptr %.2225.i.i, i64 %.idx.i1.i
  %.2673.i.i = getelementptr double, ptr %151, i64 %.184321492185.i
  br i1 %.637334.not.i.i.i, label %B456.i.i.i, label %B172.if.lr.ph.i.i.i

B34.if.preheader.i70.i.i:                         ; preds = %B1592.if.i.i
  br i1 %92, label %B34.if.epil.preheader.i94.i.i, label %B34.if.preheader.new.i71.i.i

B34.if.preheader.new.i71.i.i:                     ; preds = %B34.if.preheader.i70.i.i
  %152 = inttoptr i64 %.3704.i.i to ptr
  %scevgep.i73.i.i = getelementptr i8, ptr %152, i64 24
  br i1 %93, label %B34.if.i74.epil.preheader.i.i, label %B34.if.i74.preheader.i.i

B34.if.i74.preheader.i.i:                         ; preds = %B34.if.preheader.new.i71.i.i
  %scevgep525.i.i = getelementptr i8, ptr %152, i64 56
  br label %B34.if.i74.i.i

B102.loopexit.unr-lcssa.i92.unr-lcssa.i.i:        ; preds = %B34.if.i74.i.i
  %scevgep55.i.i = getelementptr i8, ptr %lsr.iv526.i.i, i64 32
  br i1 %95, label %B34.if.i74.epil.preheader.i.i, label %B102.loopexit.unr-lcssa.i92.i.i

B34.if.i74.epil.preheader.i.i:                    ; preds = %B102.loopexit.unr-lcssa.i92.unr-lcssa.i.i, %B34.if.preheader.new.i71.i.i
  %lsr.iv.i75.epil.init.i.i = phi ptr [ %scevgep.i73.i.i, %B34.if.preheader.new.i71.i.i ], [ %scevgep55.i.i, %B102.loopexit.unr-lcssa.i92.unr-lcssa.i.i ]
  %.134108110.i76.epil.init.i.i = phi i64 [ 0, %B34.if.preheader.new.i71.i.i ], [ %.141.1.i84.1.i.i, %B102.loopexit.unr-lcssa.i92.unr-lcssa.i.i ]
  %scevgep4.i77.epil.i.i = getelementptr i8, ptr %lsr.iv.i75.epil.init.i.i, i64 -24
  %.196.i78.epil.i.i = load double, ptr %scevgep4.i77.epil.i.i, align 8, !noalias !127
  %sunkaddr637.i.i = shl i64 %.134108110.i76.epil.init.i.i, 3
  %sunkaddr638.i.i = getelementptr i8, ptr %arg.state.15.4, i64 %sunkaddr637.i.i
  %sunkaddr639.i.i = getelementptr i8, ptr %sunkaddr638.i.i, i64 5440
  store double %.196.i78.epil.i.i, ptr %sunkaddr639.i.i, align 8, !noalias !127
  %scevgep5.i81.epil.i.i = getelementptr i8, ptr %lsr.iv.i75.epil.init.i.i, i64 -16
  %.258.i82.epil.i.i = load double, ptr %scevgep5.i81.epil.i.i, align 8, !noalias !127
  %sunkaddr642.i.i = getelementptr i8, ptr %sunkaddr638.i.i, i64 6528
  store double %.258.i82.epil.i.i, ptr %sunkaddr642.i.i, align 8, !noalias !127
  %.141.1.i84.epil.i.i = add nuw i64 %.134108110.i76.epil.init.i.i, 2
  %scevgep3.i85.epil.i.i = getelementptr i8, ptr %lsr.iv.i75.epil.init.i.i, i64 -8
  %.196.1.i86.epil.i.i = load double, ptr %scevgep3.i85.epil.i.i, align 8, !noalias !127
  %sunkaddr645.i.i = getelementptr i8, ptr %sunkaddr638.i.i, i64 5448
  store double %.196.1.i86.epil.i.i, ptr %sunkaddr645.i.i, align 8, !noalias !127
  %.258.1.i88.epil.i.i = load double, ptr %lsr.iv.i75.epil.init.i.i, align 8, !noalias !127
  %sunkaddr648.i.i = getelementptr i8, ptr %sunkaddr638.i.i, i64 6536
  store double %.258.1.i88.epil.i.i, ptr %sunkaddr648.i.i, align 8, !noalias !127
  br label %B102.loopexit.unr-lcssa.i92.i.i

B102.loopexit.unr-lcssa.i92.i.i:                  ; preds = %B34.if.i74.epil.preheader.i.i, %B102.loopexit.unr-lcssa.i92.unr-lcssa.i.i
  %.141.1.i84.lcssa.i.i = phi i64 [ %.141.1.i84.epil.i.i, %B34.if.i74.epil.preheader.i.i ], [ %.141.1.i84.1.i.i, %B102.loopexit.unr-lcssa.i92.unr-lcssa.i.i ]
  br i1 %97, label %B8644.i.i, label %B34.if.epil.preheader.i94.i.i

B34.if.epil.preheader.i94.i.i:                    ; preds = %B102.loopexit.unr-lcssa.i92.i.i, %B34.if.preheader.i70.i.i
  %.134108110.epil.init.i95.i.i = phi i64 [ 0, %B34.if.preheader.i70.i.i ], [ %.141.1.i84.lcssa.i.i, %B102.loopexit.unr-lcssa.i92.i.i ]
  %153 = inttoptr i64 %.3704.i.i to ptr
  %.idx.epil.i96.i.i = shl i64 %.134108110.epil.init.i95.i.i, 4
  %154 = getelementptr i8, ptr %153, i64 %.idx.epil.i96.i.i
  %.196.epil.i97.i.i = load double, ptr %154, align 8, !noalias !127
  %sunkaddr649.i.i = shl i64 %.134108110.epil.init.i95.i.i, 3
  %sunkaddr650.i.i = getelementptr i8, ptr %arg.state.15.4, i64 %sunkaddr649.i.i
  %sunkaddr651.i.i = getelementptr i8, ptr %sunkaddr650.i.i, i64 5440
  store double %.196.epil.i97.i.i, ptr %sunkaddr651.i.i, align 8, !noalias !127
  %155 = getelementptr i8, ptr %154, i64 8
  %.258.epil.i98.i.i = load double, ptr %155, align 8, !noalias !127
  %sunkaddr654.i.i = getelementptr i8, ptr %sunkaddr650.i.i, i64 6528
  store double %.258.epil.i98.i.i, ptr %sunkaddr654.i.i, align 8, !noalias !127
  br label %B8644.i.i

B34.if.i74.i.i:                                   ; preds = %B34.if.i74.i.i, %B34.if.i74.preheader.i.i
  %lsr.iv50.i.i = phi i64 [ %lsr.iv.next51.i.i, %B34.if.i74.i.i ], [ %90, %B34.if.i74.preheader.i.i ]
  %lsr.iv526.i.i = phi ptr [ %scevgep527.i.i, %B34.if.i74.i.i ], [ %scevgep525.i.i, %B34.if.i74.preheader.i.i ]
  %.134108110.i76.i.i = phi i64 [ %.141.1.i84.1.i.i, %B34.if.i74.i.i ], [ 0, %B34.if.i74.preheader.i.i ]
  %scevgep532.i.i = getelementptr i8, ptr %lsr.iv526.i.i, i64 -32
  %scevgep535.i.i = getelementptr i8, ptr %lsr.iv526.i.i, i64 -56
  %.196.i78.i.i = load double, ptr %scevgep535.i.i, align 8, !noalias !127
  %sunkaddr141.i.i = shl i64 %.134108110.i76.i.i, 3
  %sunkaddr142.i.i68 = getelementptr i8, ptr %arg.state.15.4, i64 %sunkaddr141.i.i
  %sunkaddr143.i.i69 = getelementptr i8, ptr %sunkaddr142.i.i68, i64 5440
  store double %.196.i78.i.i, ptr %sunkaddr143.i.i69, align 8, !noalias !127
  %scevgep534.i.i = getelementptr i8, ptr %lsr.iv526.i.i, i64 -48
  %.258.i82.i.i = load double, ptr %scevgep534.i.i, align 8, !noalias !127
  %sunkaddr146.i.i = getelementptr i8, ptr %sunkaddr142.i.i68, i64 6528
  store double %.258.i82.i.i, ptr %sunkaddr146.i.i, align 8, !noalias !127
  %scevgep533.i.i = getelementptr i8, ptr %lsr.iv526.i.i, i64 -40
  %.196.1.i86.i.i = load double, ptr %scevgep533.i.i, align 8, !noalias !127
  %sunkaddr149.i.i = getelementptr i8, ptr %sunkaddr142.i.i68, i64 5448
  store double %.196.1.i86.i.i, ptr %sunkaddr149.i.i, align 8, !noalias !127
  %.258.1.i88.i.i = load double, ptr %scevgep532.i.i, align 8, !noalias !127
  %sunkaddr152.i.i = getelementptr i8, ptr %sunkaddr142.i.i68, i64 6536
  store double %.258.1.i88.i.i, ptr %sunkaddr152.i.i, align 8, !noalias !127
  %scevgep531.i.i = getelementptr i8, ptr %lsr.iv526.i.i, i64 -24
  %.196.i78.1.i.i = load double, ptr %scevgep531.i.i, align 8, !noalias !127
  %sunkaddr155.i.i = getelementptr i8, ptr %sunkaddr142.i.i68, i64 5456
  store double %.196.i78.1.i.i, ptr %sunkaddr155.i.i, align 8, !noalias !127
  %scevgep530.i.i = getelementptr i8, ptr %lsr.iv526.i.i, i64 -16
  %.258.i82.1.i.i = load double, ptr %scevgep530.i.i, align 8, !noalias !127
  %sunkaddr158.i.i = getelementptr i8, ptr %sunkaddr142.i.i68, i64 6544
  store double %.258.i82.1.i.i, ptr %sunkaddr158.i.i, align 8, !noalias !127
  %.141.1.i84.1.i.i = add i64 %.134108110.i76.i.i, 4
  %scevgep529.i.i = getelementptr i8, ptr %lsr.iv526.i.i, i64 -8
  %.196.1.i86.1.i.i = load double, ptr %scevgep529.i.i, align 8, !noalias !127
  %sunkaddr159.i.i = shl i64 %.141.1.i84.1.i.i, 3
  %sunkaddr160.i.i = getelementptr i8, ptr %arg.state.15.4, i64 %sunkaddr159.i.i
  %sunkaddr161.i.i = getelementptr i8, ptr %sunkaddr160.i.i, i64 5432
  store double %.196.1.i86.1.i.i, ptr %sunkaddr161.i.i, align 8, !noalias !127
  %.258.1.i88.1.i.i = load double, ptr %lsr.iv526.i.i, align 8, !noalias !127
  %sunkaddr167.i.i = getelementptr i8, ptr %sunkaddr160.i.i, i64 6520
  store double %.258.1.i88.1.i.i, ptr %sunkaddr167.i.i, align 8, !noalias !127
  %scevgep527.i.i = getelementptr i8, ptr %lsr.iv526.i.i, i64 64
  %lsr.iv.next51.i.i = add i64 %lsr.iv50.i.i, 2
  %niter.ncmp.1.i.i = icmp eq i64 %lsr.iv.next51.i.i, 0
  br i1 %niter.ncmp.1.i.i, label %B102.loopexit.unr-lcssa.i92.unr-lcssa.i.i, label %B34.if.i74.i.i

B8644.i.i:                                        ; preds = %B1592.if.i.i, %B34.if.epil.preheader.i94.i.i, %B102.loopexit.unr-lcssa.i92.i.i
  %.365.i.i.i = load i64, ptr %sunkaddr168.i.i, align 8, !noalias !130
  %.366.i.i.i = inttoptr i64 %.365.i.i.i to ptr
  %.445.i.i.i = load i64, ptr %sunkaddr169.i.i, align 8, !noalias !130
  %.446.i.i.i = inttoptr i64 %.445.i.i.i to ptr
  %.528.i.i.i = getelementptr i8, ptr %.366.i.i.i, i64 64
  %.529.i.i.i = load i64, ptr %.528.i.i.i, align 8, !noalias !130
  %.530.i.i.i = sub i64 0, %.529.i.i.i
  %.538.1.i.i.i = and i64 %.530.i.i.i, -8
  %.572.i.i.i = sub i64 0, %.538.1.i.i.i
  %.669.i.i2.i = load i64, ptr %sunkaddr171.i.i, align 8, !noalias !130
  %.686.idx.i.i.i = shl i64 %.669.i.i2.i, 4
  %.686.i.i.i = getelementptr inbounds i8, ptr %arg.state.16.4, i64 %.686.idx.i.i.i
  %.748.idx.i.i.i = mul i64 %.538.1.i.i.i, -448
  %.748.i.i.i = getelementptr i8, ptr %.686.i.i.i, i64 %.748.idx.i.i.i
  %.812.i.i.i = getelementptr i8, ptr %.748.i.i.i, i64 64
  %.892.i.i.i = getelementptr i8, ptr %.366.i.i.i, i64 120
  %.893.i.i.i = load i64, ptr %.892.i.i.i, align 8, !noalias !130
  %.906.i.i.i70 = getelementptr inbounds double, ptr %.446.i.i.i, i64 %.893.i.i.i
  %.1384.i.i.i = shl nsw i64 %.572.i.i.i, 2
  %.1496.not.i.i.i = icmp eq i64 %.352038793888.i.i, 5
  br i1 %.1496.not.i.i.i, label %B246.i.i.i, label %B156.i.i.i

B156.i.i.i:                                       ; preds = %B8644.i.i
  %.idx.i.i.i = mul i64 %.669.i.i2.i, 48
  %156 = getelementptr i8, ptr %arg.state.4.4, i64 %.idx.i.i.i
  %.13.i.i.i3.i = tail call i64 @llvm.smin.i64(i64 %.3527.i.i, i64 5)
  %157 = shl nuw nsw i64 %.13.i.i.i3.i, 5
  %.1313.i.i.i = add i64 %157, %58
  %.1314.i.i.i = mul nsw i64 %.1313.i.i.i, %.572.i.i.i
  %.1397.i.i.i = getelementptr double, ptr %156, i64 %.1314.i.i.i
  %.1527.i.i.i = load double, ptr %.1397.i.i.i, align 8, !noalias !130
  %.1529.i.i.i = shl nsw i64 %.572.i.i.i, 1
  %.1543.i.i.i = icmp slt i64 %.572.i.i.i, 0
  %.1544.i.i.i = select i1 %.1543.i.i.i, i64 %.1384.i.i.i, i64 0
  %158 = getelementptr double, ptr %.1397.i.i.i, i64 %.1529.i.i.i
  %.1558.i.i.i = getelementptr double, ptr %158, i64 %.1544.i.i.i
  %.1559.i.i.i = load double, ptr %.1558.i.i.i, align 8, !noalias !130
  %.1575.inv.i.i.i = icmp sgt i64 %.529.i.i.i, 0
  %.1576.i.i.i = select i1 %.1575.inv.i.i.i, i64 0, i64 %.1384.i.i.i
  %159 = getelementptr double, ptr %.1397.i.i.i, i64 %.529.i.i.i
  %160 = getelementptr i8, ptr %159, i64 -8
  %.1590.i.i.i = getelementptr double, ptr %160, i64 %.1576.i.i.i
  %.1591.i.i.i = load double, ptr %.1590.i.i.i, align 8, !noalias !130
  %.1595.i.i.i = add nsw i64 %.1529.i.i.i, %.529.i.i.i
  %.1612.inv.i.i.i = icmp sgt i64 %.1595.i.i.i, 0
  %.1613.i.i.i = select i1 %.1612.inv.i.i.i, i64 0, i64 %.1384.i.i.i
  %161 = getelementptr double, ptr %.1397.i.i.i, i64 %.1595.i.i.i
  %162 = getelementptr i8, ptr %161, i64 -8
  %.1627.i.i.i71 = getelementptr double, ptr %162, i64 %.1613.i.i.i
  %.1628.i.i.i = load double, ptr %.1627.i.i.i71, align 8, !noalias !130
  br label %B246.i.i.i

B246.i.i.i:                                       ; preds = %B156.i.i.i, %B8644.i.i
  %edges.2.sroa.24.0.i.i.i = phi double [ %.1628.i.i.i, %B156.i.i.i ], [ 0.000000e+00, %B8644.i.i ]
  %edges.2.sroa.16.0.i.i.i = phi double [ %.1591.i.i.i, %B156.i.i.i ], [ 0.000000e+00, %B8644.i.i ]
  %edges.2.sroa.8.0.i.i.i = phi double [ %.1559.i.i.i, %B156.i.i.i ], [ 0.000000e+00, %B8644.i.i ]
  %edges.2.sroa.0.0.i.i.i = phi double [ %.1527.i.i.i, %B156.i.i.i ], [ 0.000000e+00, %B8644.i.i ]
  %.1808.i.i.i = load i64, ptr %.453.i24, align 8, !noalias !130
  %.1810.i.i.i72 = inttoptr i64 %.1808.i.i.i to ptr
  %.2239.i.i.i = load i64, ptr %.386.i20, align 8, !noalias !130
  %.2255.i.i.i = getelementptr double, ptr %.1810.i.i.i72, i64 %.2239.i.i.i
  %.2334.i.i.i = getelementptr i8, ptr %.748.i.i.i, i64 16
  %.2335.i.i.i = load i64, ptr %.2334.i.i.i, align 8, !noalias !130
  %.2608.i.i.i = shl i64 %.3527.i.i, 3
  %.2609.i.i.i = mul i64 %.2608.i.i.i, %.572.i.i.i
  %.2621.i.i.i = getelementptr double, ptr %.686.i.i.i, i64 %.2609.i.i.i
  %.2688.i.i.i = getelementptr double, ptr %.2621.i.i.i, i64 %.1384.i.i.i
  %.173.i.i.i.i = load i64, ptr %.748.i.i.i, align 8, !noalias !133
  %.13.i.i.i.i.i = tail call i64 @llvm.smax.i64(i64 %.184321492185.i, i64 %.173.i.i.i.i)
  %.13.i1.i.i.i.i = tail call i64 @llvm.smin.i64(i64 %.13.i79.i, i64 %.13.i.i.i.i.i)
  %.262.i.i.i.i = getelementptr i8, ptr %.748.i.i.i, i64 8
  %.263.i.i.i.i = load i64, ptr %.262.i.i.i.i, align 8, !noalias !133
  %.13.i2.i.i.i.i = tail call i64 @llvm.smax.i64(i64 %.184321492185.i, i64 %.263.i.i.i.i)
  %.13.i3.i.i.i.i = tail call i64 @llvm.smin.i64(i64 %.13.i79.i, i64 %.13.i2.i.i.i.i)
  %.330.i.i.i.i = sub nsw i64 %.13.i1.i.i.i.i, %.184321492185.i
  %163 = add i64 %.330.i.i.i.i, 7
  %.389.i.i.i.i = lshr i64 %163, 3
  %.368.inv.i.i.i.i = icmp slt i64 %.330.i.i.i.i, 1
  %.410442.not453.i.i.i.i = icmp eq i64 %.389.i.i.i.i, 0
  %.410442.not.i.i.i.i = or i1 %.368.inv.i.i.i.i, %.410442.not453.i.i.i.i
  br i1 %.410442.not.i.i.i.i, label %B348.i.i.i.i, label %B198.if.lr.ph.i.i.i.i

B8644.endif.thread.i.i:                           ; preds = %B9542.endif.endif.endif.endif.endif.endif.endif.i.i.i
  store i64 %.2335.i.i.i, ptr %.2334.i.i.i, align 8, !noalias !130
  br label %B8963.i.i

B348.loopexit.unr-lcssa.i.i.unr-lcssa.i.i:        ; preds = %B198.if.i.i.i.i
  %164 = and i64 %169, 4
  %lcmp.mod.not.not.i.i = icmp eq i64 %164, 0
  br i1 %lcmp.mod.not.not.i.i, label %B198.if.i.i.epil.preheader.i.i, label %B348.loopexit.unr-lcssa.i.i.i.i

B198.if.i.i.epil.preheader.i.i:                   ; preds = %B198.if.lr.ph.new.i.i.i.i, %B348.loopexit.unr-lcssa.i.i.unr-lcssa.i.i
  %.416441443.i.i.epil.init.i.i = phi i64 [ 0, %B198.if.lr.ph.new.i.i.i.i ], [ %.423.3.i.i.1.i.i, %B348.loopexit.unr-lcssa.i.i.unr-lcssa.i.i ]
  %sunkaddr686.epil.i.i = shl i64 %.416441443.i.i.epil.init.i.i, 3
  %sunkaddr687.epil.i.i = getelementptr i8, ptr %arg.state.15.4, i64 %sunkaddr686.epil.i.i
  %sunkaddr688.epil.i.i = getelementptr i8, ptr %sunkaddr687.epil.i.i, i64 7616
  store <8 x double> %.451.i.i.i.i, ptr %sunkaddr688.epil.i.i, align 8, !noalias !133
  %sunkaddr691.epil.i.i = getelementptr i8, ptr %sunkaddr687.epil.i.i, i64 8704
  store <8 x double> %.465.i.i.i.i, ptr %sunkaddr691.epil.i.i, align 8, !noalias !133
  %sunkaddr694.epil.i.i = getelementptr i8, ptr %sunkaddr687.epil.i.i, i64 7680
  store <8 x double> %.451.i.i.i.i, ptr %sunkaddr694.epil.i.i, align 8, !noalias !133
  %sunkaddr697.epil.i.i = getelementptr i8, ptr %sunkaddr687.epil.i.i, i64 8768
  store <8 x double> %.465.i.i.i.i, ptr %sunkaddr697.epil.i.i, align 8, !noalias !133
  %sunkaddr700.epil.i.i = getelementptr i8, ptr %sunkaddr687.epil.i.i, i64 7744
  store <8 x double> %.451.i.i.i.i, ptr %sunkaddr700.epil.i.i, align 8, !noalias !133
  %sunkaddr703.epil.i.i = getelementptr i8, ptr %sunkaddr687.epil.i.i, i64 8832
  store <8 x double> %.465.i.i.i.i, ptr %sunkaddr703.epil.i.i, align 8, !noalias !133
  %.423.3.i.i.epil.i.i = add i64 %.416441443.i.i.epil.init.i.i, 32
  %sunkaddr704.epil.i.i = shl i64 %.423.3.i.i.epil.i.i, 3
  %sunkaddr705.epil.i.i = getelementptr i8, ptr %arg.state.15.4, i64 %sunkaddr704.epil.i.i
  %sunkaddr706.epil.i.i = getelementptr i8, ptr %sunkaddr705.epil.i.i, i64 7552
  store <8 x double> %.451.i.i.i.i, ptr %sunkaddr706.epil.i.i, align 8, !noalias !133
  %sunkaddr709.epil.i.i = getelementptr i8, ptr %sunkaddr705.epil.i.i, i64 8640
  store <8 x double> %.465.i.i.i.i, ptr %sunkaddr709.epil.i.i, align 8, !noalias !133
  br label %B348.loopexit.unr-lcssa.i.i.i.i

B348.loopexit.unr-lcssa.i.i.i.i:                  ; preds = %B198.if.i.i.epil.preheader.i.i, %B348.loopexit.unr-lcssa.i.i.unr-lcssa.i.i
  %.423.3.i.i.lcssa.i.i = phi i64 [ %.423.3.i.i.epil.i.i, %B198.if.i.i.epil.preheader.i.i ], [ %.423.3.i.i.1.i.i, %B348.loopexit.unr-lcssa.i.i.unr-lcssa.i.i ]
  %lcmp.mod.not.i.i.i.i = icmp eq i64 %xtraiter.i.i.i.i, 0
  br i1 %lcmp.mod.not.i.i.i.i, label %B348.i.i.i.i, label %B198.if.epil.preheader.i.i.i.i

B198.if.epil.preheader.i.i.i.i:                   ; preds = %B198.if.lr.ph.i.i.i.i, %B348.loopexit.unr-lcssa.i.i.i.i
  %.416441443.epil.init.i.i.i.i = phi i64 [ 0, %B198.if.lr.ph.i.i.i.i ], [ %.423.3.i.i.lcssa.i.i, %B348.loopexit.unr-lcssa.i.i.i.i ]
  %165 = shl i64 %.416441443.epil.init.i.i.i.i, 3
  %scevgep51.i.i.i.i = getelementptr i8, ptr %.3044.i.i, i64 %165
  %166 = shl nuw nsw i64 %xtraiter.i.i.i.i, 6
  br label %B198.if.epil.i.i.i.i

B198.if.epil.i.i.i.i:                             ; preds = %B198.if.epil.i.i.i.i, %B198.if.epil.preheader.i.i.i.i
  %lsr.iv52.i.i.i.i = phi i64 [ %lsr.iv.next53.i.i.i.i, %B198.if.epil.i.i.i.i ], [ 0, %B198.if.epil.preheader.i.i.i.i ]
  %scevgep218.i.i.i = getelementptr i8, ptr %scevgep51.i.i.i.i, i64 %lsr.iv52.i.i.i.i
  %scevgep219.i.i.i = getelementptr i8, ptr %scevgep218.i.i.i, i64 -1088
  store <8 x double> %.451.i.i.i.i, ptr %scevgep219.i.i.i, align 8, !noalias !133
  store <8 x double> %.465.i.i.i.i, ptr %scevgep218.i.i.i, align 8, !noalias !133
  %lsr.iv.next53.i.i.i.i = add nuw nsw i64 %lsr.iv52.i.i.i.i, 64
  %epil.iter.cmp.not.i.i.i.i = icmp eq i64 %166, %lsr.iv.next53.i.i.i.i
  br i1 %epil.iter.cmp.not.i.i.i.i, label %B348.i.i.i.i, label %B198.if.epil.i.i.i.i, !llvm.loop !136

B348.i.i.i.i:                                     ; preds = %B198.if.epil.i.i.i.i, %B348.loopexit.unr-lcssa.i.i.i.i, %B246.i.i.i
  %.487.i.i.i.i = sub nsw i64 %.13.i3.i.i.i.i, %.184321492185.i
  %.653.i.i.i.i = load i64, ptr %.2334.i.i.i, align 8, !noalias !133
  %.126.i.i.i.i.i = icmp slt i64 %.13.i.i.i.i.i, %.13.i3.i.i.i.i
  br i1 %.126.i.i.i.i.i, label %B22.preheader.i.i.i.i.i, label %B348.endif.endif.endif.i.i.i.i

B198.if.lr.ph.i.i.i.i:                            ; preds = %B246.i.i.i
  %.450.i.i.i.i = insertelement <8 x double> poison, double %edges.2.sroa.0.0.i.i.i, i64 0
  %.451.i.i.i.i = shufflevector <8 x double> %.450.i.i.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.464.i.i.i.i = insertelement <8 x double> poison, double %edges.2.sroa.8.0.i.i.i, i64 0
  %.465.i.i.i.i = shufflevector <8 x double> %.464.i.i.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %167 = add nsw i64 %.389.i.i.i.i, -1
  %xtraiter.i.i.i.i = and i64 %.389.i.i.i.i, 3
  %168 = icmp ult i64 %167, 3
  br i1 %168, label %B198.if.epil.preheader.i.i.i.i, label %B198.if.lr.ph.new.i.i.i.i

B198.if.lr.ph.new.i.i.i.i:                        ; preds = %B198.if.lr.ph.i.i.i.i
  %169 = add nsw i64 %.389.i.i.i.i, -4
  %170 = lshr i64 %169, 2
  %171 = icmp eq i64 %170, 0
  br i1 %171, label %B198.if.i.i.epil.preheader.i.i, label %B198.if.lr.ph.new.i.i.new.i.i

B198.if.lr.ph.new.i.i.new.i.i:                    ; preds = %B198.if.lr.ph.new.i.i.i.i
  %172 = add nuw nsw i64 %170, 1
  %173 = and i64 %172, 9223372036854775806
  br label %B198.if.i.i.i.i

B198.if.i.i.i.i:                                  ; preds = %B198.if.i.i.i.i, %B198.if.lr.ph.new.i.i.new.i.i
  %lsr.iv73.i.i = phi i64 [ %lsr.iv.next74.i.i, %B198.if.i.i.i.i ], [ %173, %B198.if.lr.ph.new.i.i.new.i.i ]
  %.416441443.i.i.i.i = phi i64 [ %.423.3.i.i.1.i.i, %B198.if.i.i.i.i ], [ 0, %B198.if.lr.ph.new.i.i.new.i.i ]
  %sunkaddr176.i.i = shl i64 %.416441443.i.i.i.i, 3
  %sunkaddr177.i.i = getelementptr i8, ptr %arg.state.15.4, i64 %sunkaddr176.i.i
  %sunkaddr178.i.i = getelementptr i8, ptr %sunkaddr177.i.i, i64 7616
  store <8 x double> %.451.i.i.i.i, ptr %sunkaddr178.i.i, align 8, !noalias !133
  %sunkaddr181.i.i = getelementptr i8, ptr %sunkaddr177.i.i, i64 8704
  store <8 x double> %.465.i.i.i.i, ptr %sunkaddr181.i.i, align 8, !noalias !133
  %sunkaddr184.i.i = getelementptr i8, ptr %sunkaddr177.i.i, i64 7680
  store <8 x double> %.451.i.i.i.i, ptr %sunkaddr184.i.i, align 8, !noalias !133
  %sunkaddr187.i.i = getelementptr i8, ptr %sunkaddr177.i.i, i64 8768
  store <8 x double> %.465.i.i.i.i, ptr %sunkaddr187.i.i, align 8, !noalias !133
  %sunkaddr190.i.i = getelementptr i8, ptr %sunkaddr177.i.i, i64 7744
  store <8 x double> %.451.i.i.i.i, ptr %sunkaddr190.i.i, align 8, !noalias !133
  %sunkaddr193.i.i = getelementptr i8, ptr %sunkaddr177.i.i, i64 8832
  store <8 x double> %.465.i.i.i.i, ptr %sunkaddr193.i.i, align 8, !noalias !133
  %sunkaddr196.i.i = getelementptr i8, ptr %sunkaddr177.i.i, i64 7808
  store <8 x double> %.451.i.i.i.i, ptr %sunkaddr196.i.i, align 8, !noalias !133
  %sunkaddr199.i.i = getelementptr i8, ptr %sunkaddr177.i.i, i64 8896
  store <8 x double> %.465.i.i.i.i, ptr %sunkaddr199.i.i, align 8, !noalias !133
  %sunkaddr202.i.i = getelementptr i8, ptr %sunkaddr177.i.i, i64 7872
  store <8 x double> %.451.i.i.i.i, ptr %sunkaddr202.i.i, align 8, !noalias !133
  %sunkaddr205.i.i = getelementptr i8, ptr %sunkaddr177.i.i, i64 8960
  store <8 x double> %.465.i.i.i.i, ptr %sunkaddr205.i.i, align 8, !noalias !133
  %sunkaddr208.i.i = getelementptr i8, ptr %sunkaddr177.i.i, i64 7936
  store <8 x double> %.451.i.i.i.i, ptr %sunkaddr208.i.i, align 8, !noalias !133
  %sunkaddr211.i.i = getelementptr i8, ptr %sunkaddr177.i.i, i64 9024
  store <8 x double> %.465.i.i.i.i, ptr %sunkaddr211.i.i, align 8, !noalias !133
  %sunkaddr214.i.i = getelementptr i8, ptr %sunkaddr177.i.i, i64 8000
  store <8 x double> %.451.i.i.i.i, ptr %sunkaddr214.i.i, align 8, !noalias !133
  %sunkaddr217.i.i = getelementptr i8, ptr %sunkaddr177.i.i, i64 9088
  store <8 x double> %.465.i.i.i.i, ptr %sunkaddr217.i.i, align 8, !noalias !133
  %.423.3.i.i.1.i.i = add i64 %.416441443.i.i.i.i, 64
  %sunkaddr218.i.i = shl i64 %.423.3.i.i.1.i.i, 3
  %sunkaddr219.i.i = getelementptr i8, ptr %arg.state.15.4, i64 %sunkaddr218.i.i
  %sunkaddr225.i.i = getelementptr i8, ptr %sunkaddr219.i.i, i64 7552
  store <8 x double> %.451.i.i.i.i, ptr %sunkaddr225.i.i, align 8, !noalias !133
  %sunkaddr228.i.i = getelementptr i8, ptr %sunkaddr219.i.i, i64 8640
  store <8 x double> %.465.i.i.i.i, ptr %sunkaddr228.i.i, align 8, !noalias !133
  %lsr.iv.next74.i.i = add i64 %lsr.iv73.i.i, -2
  %niter.ncmp.111.i.i = icmp eq i64 %lsr.iv.next74.i.i, 0
  br i1 %niter.ncmp.111.i.i, label %B348.loopexit.unr-lcssa.i.i.unr-lcssa.i.i, label %B198.if.i.i.i.i

B22.preheader.i.i.i.i.i:                          ; preds = %B348.i.i.i.i
  %.264.i.i.i.i.i = shl nsw i64 %.572.i.i.i, 1
  %.277.i.i.i.i.i = mul i64 %.538.1.i.i.i, -3
  %174 = lshr i64 %.530.i.i.i, 3
  %.neg.i.i.i = mul i64 %174, -3584
  %175 = getelementptr i8, ptr %arg.state.16.4, i64 %.neg.i.i.i
  %176 = getelementptr i8, ptr %175, i64 %.686.idx.i.i.i
  %scevgep212.i.i.i = getelementptr i8, ptr %176, i64 72
  br label %B22.i.i.i.i.i

B22.i.i.i.i.i:                                    ; preds = %B926.i.i.i.i.i, %B22.preheader.i.i.i.i.i
  %cell.2.0.i.i.i.i.i = phi i64 [ %cell.3.2.i.i.i.i.i, %B926.i.i.i.i.i ], [ %.653.i.i.i.i, %B22.preheader.i.i.i.i.i ]
  %start.2.0.i.i.i.i.i = phi i64 [ %.13.i.i.i.i.i.i, %B926.i.i.i.i.i ], [ %.13.i1.i.i.i.i, %B22.preheader.i.i.i.i.i ]
  %.149.i.i.i.i.i79 = getelementptr inbounds i64, ptr %.812.i.i.i, i64 %cell.2.0.i.i.i.i.i
  %.150.i.i.i.i.i = load i64, ptr %.149.i.i.i.i.i79, align 8, !noalias !137
  %.154.not.i.i.i.i.i = icmp sgt i64 %.150.i.i.i.i.i, %start.2.0.i.i.i.i.i
  br i1 %.154.not.i.i.i.i.i, label %B112.i.i.i.i.i, label %B62.i.i.i.i.i

B62.i.i.i.i.i:                                    ; preds = %B22.i.i.i.i.i, %B62.i.i.i.i.i
  %cell.4.1.i.i.i.i.i = phi i64 [ %.157.i.i.i.i.i, %B62.i.i.i.i.i ], [ %cell.2.0.i.i.i.i.i, %B22.i.i.i.i.i ]
  %.157.i.i.i.i.i = add i64 %cell.4.1.i.i.i.i.i, 1
  %177 = shl i64 %cell.4.1.i.i.i.i.i, 3
  %scevgep213.i.i.i = getelementptr i8, ptr %scevgep212.i.i.i, i64 %177
  %.170.i.i.i.i.i = load i64, ptr %scevgep213.i.i.i, align 8, !noalias !137
  %.172.not.i.i.i.i.i = icmp sgt i64 %.170.i.i.i.i.i, %start.2.0.i.i.i.i.i
  br i1 %.172.not.i.i.i.i.i, label %B112.i.i.i.i.i, label %B62.i.i.i.i.i

B112.i.i.i.i.i:                                   ; preds = %B62.i.i.i.i.i, %B22.i.i.i.i.i
  %cell.3.2.i.i.i.i.i = phi i64 [ %cell.2.0.i.i.i.i.i, %B22.i.i.i.i.i ], [ %.157.i.i.i.i.i, %B62.i.i.i.i.i ]
  %.184.i.i.i.i.i = getelementptr inbounds i64, ptr %.812.i.i.i, i64 %cell.3.2.i.i.i.i.i
  %.185.i.i.i.i.i = load i64, ptr %.184.i.i.i.i.i, align 8, !noalias !137
  %.13.i.i.i.i.i.i = tail call i64 @llvm.smin.i64(i64 %.13.i3.i.i.i.i, i64 %.185.i.i.i.i.i)
  %.395.i.i.i.i.i = sub i64 %.13.i.i.i.i.i.i, %start.2.0.i.i.i.i.i
  %178 = add i64 %.395.i.i.i.i.i, 7
  %.417.i.i.i.i.i = lshr i64 %178, 3
  %.396.inv.i.i.i.i.i = icmp slt i64 %.395.i.i.i.i.i, 1
  %.438305.not326.i.i.i.i.i = icmp eq i64 %.417.i.i.i.i.i, 0
  %.438305.not.i.i.i.i.i = or i1 %.396.inv.i.i.i.i.i, %.438305.not326.i.i.i.i.i
  br i1 %.438305.not.i.i.i.i.i, label %B926.i.i.i.i.i, label %B570.if.lr.ph.i.i.i.i.i

B926.i.i.i.i.i:                                   ; preds = %B570.if.i.i.i.i.i, %B112.i.i.i.i.i
  %.602.i.i.i.i.i = icmp slt i64 %.185.i.i.i.i.i, %.13.i3.i.i.i.i
  br i1 %.602.i.i.i.i.i, label %B22.i.i.i.i.i, label %B348.endif.endif.endif.i.i.i.i

B570.if.lr.ph.i.i.i.i.i:                          ; preds = %B112.i.i.i.i.i
  %.228.i.i.i.i.i = getelementptr inbounds double, ptr %.906.i.i.i70, i64 %cell.3.2.i.i.i.i.i
  %.229.i.i.i.i.i = load double, ptr %.228.i.i.i.i.i, align 8, !noalias !137
  %.231.i.i.i.i.i = fsub contract double %.1945.le.i.i, %.229.i.i.i.i.i
  %.279.i.i.i.i.i = add nsw i64 %cell.3.2.i.i.i.i.i, %.277.i.i.i.i.i
  %.347.i.i.i.i.i = getelementptr inbounds double, ptr %.2688.i.i.i, i64 %.279.i.i.i.i.i
  %.348.i.i.i.i.i = load double, ptr %.347.i.i.i.i.i, align 8, !noalias !137
  %.266.i.i.i.i.i = add nsw i64 %cell.3.2.i.i.i.i.i, %.264.i.i.i.i.i
  %.334.i.i.i.i.i = getelementptr inbounds double, ptr %.2688.i.i.i, i64 %.266.i.i.i.i.i
  %.335.i.i.i.i.i = load double, ptr %.334.i.i.i.i.i, align 8, !noalias !137
  %.247.i.i.i.i.i = sub i64 %cell.3.2.i.i.i.i.i, %.538.1.i.i.i
  %.315.i.i.i.i.i = getelementptr inbounds double, ptr %.2688.i.i.i, i64 %.247.i.i.i.i.i
  %.316.i.i.i.i.i = load double, ptr %.315.i.i.i.i.i, align 8, !noalias !137
  %.303.i.i.i.i.i = getelementptr inbounds double, ptr %.2688.i.i.i, i64 %cell.3.2.i.i.i.i.i
  %.304.i.i.i.i.i = load double, ptr %.303.i.i.i.i.i, align 8, !noalias !137
  %.287.i.i.i.i.i = getelementptr inbounds double, ptr %.2621.i.i.i, i64 %.279.i.i.i.i.i
  %.288.i.i.i.i.i = load double, ptr %.287.i.i.i.i.i, align 8, !noalias !137
  %.274.i.i.i.i.i = getelementptr inbounds double, ptr %.2621.i.i.i, i64 %.266.i.i.i.i.i
  %.275.i.i.i.i.i = load double, ptr %.274.i.i.i.i.i, align 8, !noalias !137
  %.255.i.i.i.i.i = getelementptr inbounds double, ptr %.2621.i.i.i, i64 %.247.i.i.i.i.i
  %.256.i.i.i.i.i = load double, ptr %.255.i.i.i.i.i, align 8, !noalias !137
  %.243.i.i.i.i.i = getelementptr inbounds double, ptr %.2621.i.i.i, i64 %cell.3.2.i.i.i.i.i
  %.244.i.i.i.i.i = load double, ptr %.243.i.i.i.i.i, align 8, !noalias !137
  %.514.i.i.i.i.i = insertelement <8 x double> poison, double %.288.i.i.i.i.i, i64 0
  %.515.i.i.i.i.i = shufflevector <8 x double> %.514.i.i.i.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.517.i.i.i.i.i = insertelement <8 x double> poison, double %.275.i.i.i.i.i, i64 0
  %.518.i.i.i.i.i = shufflevector <8 x double> %.517.i.i.i.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.521.i.i.i.i.i = insertelement <8 x double> poison, double %.256.i.i.i.i.i, i64 0
  %.522.i.i.i.i.i = shufflevector <8 x double> %.521.i.i.i.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.525.i.i.i.i.i = insertelement <8 x double> poison, double %.244.i.i.i.i.i, i64 0
  %.526.i.i.i.i.i = shufflevector <8 x double> %.525.i.i.i.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.541.i.i.i.i.i = insertelement <8 x double> poison, double %.348.i.i.i.i.i, i64 0
  %.542.i.i.i.i.i = shufflevector <8 x double> %.541.i.i.i.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.544.i.i.i.i.i = insertelement <8 x double> poison, double %.335.i.i.i.i.i, i64 0
  %.545.i.i.i.i.i = shufflevector <8 x double> %.544.i.i.i.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.548.i.i.i.i.i = insertelement <8 x double> poison, double %.316.i.i.i.i.i, i64 0
  %.549.i.i.i.i.i = shufflevector <8 x double> %.548.i.i.i.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.552.i.i.i.i.i = insertelement <8 x double> poison, double %.304.i.i.i.i.i, i64 0
  %.553.i.i.i.i.i = shufflevector <8 x double> %.552.i.i.i.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.6.i.i.i.i.i.i = insertelement <8 x double> poison, double %.231.i.i.i.i.i, i64 0
  %.7.i.i.i.i.i.i = shufflevector <8 x double> %.6.i.i.i.i.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %179 = shl i64 %start.2.0.i.i.i.i.i, 3
  %180 = add nuw nsw i64 %.417.i.i.i.i.i, 9
  br label %B570.if.i.i.i.i.i

B570.if.i.i.i.i.i:                                ; preds = %B570.if.i.i.i.i.i, %B570.if.lr.ph.i.i.i.i.i
  %lsr.iv108.i.i = phi i64 [ %lsr.iv.next109.i.i, %B570.if.i.i.i.i.i ], [ %180, %B570.if.lr.ph.i.i.i.i.i ]
  %lsr.iv8.i.i.i.i.i = phi i64 [ %lsr.iv.next9.i.i.i.i.i, %B570.if.i.i.i.i.i ], [ %179, %B570.if.lr.ph.i.i.i.i.i ]
  %scevgep13.i.i.i.i.i = getelementptr i8, ptr %.2255.i.i.i, i64 %lsr.iv8.i.i.i.i.i
  %.485.i.i.i.i.i = load <8 x double>, ptr %scevgep13.i.i.i.i.i, align 8, !noalias !137
  %.8.i.i.i.i.i.i = fadd contract <8 x double> %.7.i.i.i.i.i.i, %.485.i.i.i.i.i
  %.519.i.i.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i.i.i.i.i.i, <8 x double> %.515.i.i.i.i.i, <8 x double> %.518.i.i.i.i.i)
  %.523.i.i.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i.i.i.i.i.i, <8 x double> %.519.i.i.i.i.i, <8 x double> %.522.i.i.i.i.i)
  %.527.i.i.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i.i.i.i.i.i, <8 x double> %.523.i.i.i.i.i, <8 x double> %.526.i.i.i.i.i)
  %scevgep574.i.i = getelementptr i8, ptr %scevgep573.i.i, i64 %lsr.iv8.i.i.i.i.i
  %scevgep575.i.i = getelementptr i8, ptr %scevgep574.i.i, i64 -1088
  store <8 x double> %.527.i.i.i.i.i, ptr %scevgep575.i.i, align 8, !noalias !137
  %.546.i.i.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i.i.i.i.i.i, <8 x double> %.542.i.i.i.i.i, <8 x double> %.545.i.i.i.i.i)
  %.550.i.i.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i.i.i.i.i.i, <8 x double> %.546.i.i.i.i.i, <8 x double> %.549.i.i.i.i.i)
  %.554.i.i.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i.i.i.i.i.i, <8 x double> %.550.i.i.i.i.i, <8 x double> %.553.i.i.i.i.i)
  store <8 x double> %.554.i.i.i.i.i, ptr %scevgep574.i.i, align 8, !noalias !137
  %lsr.iv.next9.i.i.i.i.i = add i64 %lsr.iv8.i.i.i.i.i, 64
  %lsr.iv.next109.i.i = add nsw i64 %lsr.iv108.i.i, -1
  %.438.i.i.i.i.i = icmp sgt i64 %lsr.iv108.i.i, 10
  br i1 %.438.i.i.i.i.i, label %B570.if.i.i.i.i.i, label %B926.i.i.i.i.i

B348.endif.endif.endif.i.i.i.i:                   ; preds = %B926.i.i.i.i.i, %B348.i.i.i.i
  %cell.5.1.i.i.i.i.i = phi i64 [ %.653.i.i.i.i, %B348.i.i.i.i ], [ %cell.3.2.i.i.i.i.i, %B926.i.i.i.i.i ]
  store i64 %cell.5.1.i.i.i.i.i, ptr %.2334.i.i.i, align 8, !noalias !133
  %.835.i.i.i.i = sub i64 %.13.i79.i, %.13.i3.i.i.i.i
  %181 = add i64 %.835.i.i.i.i, 7
  %.857.i.i.i.i = lshr i64 %181, 3
  %.836.inv.i.i.i.i = icmp slt i64 %.835.i.i.i.i, 1
  %.878448.not454.i.i.i.i = icmp eq i64 %.857.i.i.i.i, 0
  %.878448.not.i.i.i.i = or i1 %.836.inv.i.i.i.i, %.878448.not454.i.i.i.i
  br i1 %.878448.not.i.i.i.i, label %B9542.endif.endif.endif.endif.endif.endif.endif.i.i.i, label %B590.if.lr.ph.i.i.i.i

B590.if.lr.ph.i.i.i.i:                            ; preds = %B348.endif.endif.endif.i.i.i.i
  %.918.i.i.i.i = insertelement <8 x double> poison, double %edges.2.sroa.16.0.i.i.i, i64 0
  %.919.i.i.i.i = shufflevector <8 x double> %.918.i.i.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.932.i.i.i.i = insertelement <8 x double> poison, double %edges.2.sroa.24.0.i.i.i, i64 0
  %.933.i.i.i.i = shufflevector <8 x double> %.932.i.i.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %182 = add nsw i64 %.857.i.i.i.i, -1
  %xtraiter28.i.i.i.i = and i64 %.857.i.i.i.i, 3
  %lcmp.mod29.not.i.i.i.i = icmp eq i64 %xtraiter28.i.i.i.i, 0
  br i1 %lcmp.mod29.not.i.i.i.i, label %B590.if.prol.loopexit.i.i.i.i, label %B590.if.prol.i.i.i.i

B590.if.prol.i.i.i.i:                             ; preds = %B590.if.lr.ph.i.i.i.i, %B590.if.prol.i.i.i.i
  %lsr.iv110.i.i = phi i64 [ %lsr.iv.next.i.i73, %B590.if.prol.i.i.i.i ], [ %xtraiter28.i.i.i.i, %B590.if.lr.ph.i.i.i.i ]
  %.884447449.prol.i.i.i.i = phi i64 [ %.891.prol.i.i.i.i, %B590.if.prol.i.i.i.i ], [ %.487.i.i.i.i, %B590.if.lr.ph.i.i.i.i ]
  %.891.prol.i.i.i.i = add i64 %.884447449.prol.i.i.i.i, 8
  %183 = shl i64 %.884447449.prol.i.i.i.i, 3
  %scevgep208.i.i.i = getelementptr i8, ptr %.3044.i.i, i64 %183
  %scevgep209.i.i.i = getelementptr i8, ptr %scevgep208.i.i.i, i64 -1088
  store <8 x double> %.919.i.i.i.i, ptr %scevgep209.i.i.i, align 8, !noalias !133
  store <8 x double> %.933.i.i.i.i, ptr %scevgep208.i.i.i, align 8, !noalias !133
  %lsr.iv.next.i.i73 = add nsw i64 %lsr.iv110.i.i, -1
  %ov229.i.i = icmp eq i64 %lsr.iv.next.i.i73, 0
  br i1 %ov229.i.i, label %B590.if.prol.loopexit.loopexit.i.i.i.i, label %B590.if.prol.i.i.i.i, !llvm.loop !140

B590.if.prol.loopexit.loopexit.i.i.i.i:           ; preds = %B590.if.prol.i.i.i.i
  %184 = and i64 %.857.i.i.i.i, 2305843009213693948
  br label %B590.if.prol.loopexit.i.i.i.i

B590.if.prol.loopexit.i.i.i.i:                    ; preds = %B590.if.prol.loopexit.loopexit.i.i.i.i, %B590.if.lr.ph.i.i.i.i
  %.877446450.unr.i.i.i.i = phi i64 [ %.857.i.i.i.i, %B590.if.lr.ph.i.i.i.i ], [ %184, %B590.if.prol.loopexit.loopexit.i.i.i.i ]
  %.884447449.unr.i.i.i.i = phi i64 [ %.487.i.i.i.i, %B590.if.lr.ph.i.i.i.i ], [ %.891.prol.i.i.i.i, %B590.if.prol.loopexit.loopexit.i.i.i.i ]
  %185 = icmp ult i64 %182, 3
  br i1 %185, label %B9542.endif.endif.endif.endif.endif.endif.endif.i.i.i, label %B590.if.preheader.i.i.i.i

B590.if.preheader.i.i.i.i:                        ; preds = %B590.if.prol.loopexit.i.i.i.i
  %186 = shl i64 %.884447449.unr.i.i.i.i, 3
  %187 = getelementptr i8, ptr %arg.state.15.4, i64 %186
  %scevgep.i100.i.i = getelementptr i8, ptr %187, i64 8896
  %188 = add nuw nsw i64 %.877446450.unr.i.i.i.i, 32
  br label %B590.if.i.i.i.i

B590.if.i.i.i.i:                                  ; preds = %B590.if.i.i.i.i, %B590.if.preheader.i.i.i.i
  %lsr.iv112.i.i = phi i64 [ %lsr.iv.next113.i.i, %B590.if.i.i.i.i ], [ %188, %B590.if.preheader.i.i.i.i ]
  %lsr.iv.i101.i.i = phi ptr [ %scevgep199.i.i.i, %B590.if.i.i.i.i ], [ %scevgep.i100.i.i, %B590.if.preheader.i.i.i.i ]
  %scevgep203.i.i.i = getelementptr i8, ptr %lsr.iv.i101.i.i, i64 -1088
  %scevgep206.i.i.i = getelementptr i8, ptr %lsr.iv.i101.i.i, i64 -1280
  store <8 x double> %.919.i.i.i.i, ptr %scevgep206.i.i.i, align 8, !noalias !133
  %scevgep202.i.i.i = getelementptr i8, ptr %lsr.iv.i101.i.i, i64 -192
  store <8 x double> %.933.i.i.i.i, ptr %scevgep202.i.i.i, align 8, !noalias !133
  %scevgep205.i.i.i = getelementptr i8, ptr %lsr.iv.i101.i.i, i64 -1216
  store <8 x double> %.919.i.i.i.i, ptr %scevgep205.i.i.i, align 8, !noalias !133
  %scevgep201.i.i.i = getelementptr i8, ptr %lsr.iv.i101.i.i, i64 -128
  store <8 x double> %.933.i.i.i.i, ptr %scevgep201.i.i.i, align 8, !noalias !133
  %scevgep204.i.i.i = getelementptr i8, ptr %lsr.iv.i101.i.i, i64 -1152
  store <8 x double> %.919.i.i.i.i, ptr %scevgep204.i.i.i, align 8, !noalias !133
  %scevgep200.i.i.i = getelementptr i8, ptr %lsr.iv.i101.i.i, i64 -64
  store <8 x double> %.933.i.i.i.i, ptr %scevgep200.i.i.i, align 8, !noalias !133
  store <8 x double> %.919.i.i.i.i, ptr %scevgep203.i.i.i, align 8, !noalias !133
  store <8 x double> %.933.i.i.i.i, ptr %lsr.iv.i101.i.i, align 8, !noalias !133
  %scevgep199.i.i.i = getelementptr i8, ptr %lsr.iv.i101.i.i, i64 256
  %lsr.iv.next113.i.i = add nsw i64 %lsr.iv112.i.i, -4
  %.878.3.i.i.i.i = icmp sgt i64 %lsr.iv112.i.i, 36
  br i1 %.878.3.i.i.i.i, label %B590.if.i.i.i.i, label %B9542.endif.endif.endif.endif.endif.endif.endif.i.i.i

B9542.endif.endif.endif.endif.endif.endif.endif.i.i.i: ; preds = %B590.if.i.i.i.i, %B590.if.prol.loopexit.i.i.i.i, %B348.endif.endif.endif.i.i.i.i
  %.2883.i.i.i = icmp samesign ult i64 %.352038793888.i.i, 5
  br i1 %.2883.i.i.i, label %B8644.endif.thread.i.i, label %B8644.endif.i.i

B8899.i.i:                                        ; preds = %B8644.endif.i.i
  %.4192.i.i = load double, ptr %.1653.i, align 8, !noalias !121
  %.4196.i.i = fmul contract double %.4192.i.i, 3.000000e+00
  %.4202.i.i = fdiv contract double %.4198.i.i, %.4196.i.i
  br label %B8963.i.i

B8963.i.i:                                        ; preds = %B8644.endif.i.i, %B8899.i.i, %B8644.endif.thread.i.i
  %"$phi1336.1.2.1.i.i" = phi double [ %.4202.i.i, %B8899.i.i ], [ 0.000000e+00, %B8644.endif.i.i ], [ 0.000000e+00, %B8644.endif.thread.i.i ]
  %.idx3826.i.i = mul nuw nsw i64 %.352038793888.i.i, 1088
  %189 = getelementptr i8, ptr %arg.state.15.4, i64 %.idx3826.i.i
  br i1 %.1026.i.i.i, label %B22.i.preheader.i.i, label %B8963.endif.endif.endif.i.i

B22.i.preheader.i.i:                              ; preds = %B8963.i.i
  %190 = inttoptr i64 %.3860.i.i to ptr
  br label %B22.i.i.i

B294.if.i.i:                                      ; preds = %B1154.endif.endif.endif.endif.i.i, %B250.i.i
  %.106038983906.i.i = phi i64 [ 0, %B250.i.i ], [ %.1067.i.i, %B1154.endif.endif.endif.endif.i.i ]
  %.1067.i.i = add nuw nsw i64 %.106038983906.i.i, 1
  %.1198.i.i = load i64, ptr %.291.i16, align 8, !noalias !121
  %.1237.i.i = load i64, ptr %sunkaddr262.i.i, align 8, !noalias !121
  %.1241.i.i = mul nsw i64 %.1198.i.i, %.1203.i.i
  %.1242.i.i = add nsw i64 %.1241.i.i, %.184321492185.i
  %.1243.i.i = shl nsw i64 %.1242.i.i, 4
  %.1244.i.i = add nsw i64 %.1243.i.i, %.1237.i.i
  %.1391.i.i = load i64, ptr %sunkaddr263.i.i, align 8, !noalias !121
  %.1396.i.i = add nsw i64 %.106038983906.i.i, %.1395.i.i
  %.1397.i.i = mul nsw i64 %.1198.i.i, %.1396.i.i
  %.1398.i.i = add nsw i64 %.1397.i.i, %.184321492185.i
  %.1399.i.i = shl nsw i64 %.1398.i.i, 4
  %.1400.i.i = add nsw i64 %.1399.i.i, %.1391.i.i
  %.1556.i.i = icmp ne i64 %.106038983906.i.i, 0
  %or.cond.i.i = or i1 %.595.inv.i.i.i, %.1556.i.i
  br i1 %or.cond.i.i, label %B1154.i.i, label %B34.if.preheader.i.i.i

B412.i.i.i:                                       ; preds = %B48.if.i.i.i
  %.472.i.i.i = shufflevector <8 x double> %.369.i.i.i, <8 x double> %.425.i.i.i, <16 x i32> <i32 0, i32 8, i32 1, i32 9, i32 2, i32 10, i32 3, i32 11, i32 4, i32 12, i32 5, i32 13, i32 6, i32 14, i32 7, i32 15>
  store <16 x double> %.472.i.i.i, ptr %arg.state.12.4, align 4, !noalias !141
  %.562299.not.i.i.i = icmp slt i64 %.372.i.i.i, 1
  br i1 %.562299.not.i.i.i, label %B8300.i.i.i, label %B8132.if.i.preheader.i.i

B8132.if.i.preheader.i.i:                         ; preds = %B412.i.i.i
  %191 = icmp eq i64 %lsr.iv27.i.i.i, 1
  br i1 %191, label %B8132.if.i.epil.preheader.i.i, label %B8132.if.i.i.i

B8244.i.i.i:                                      ; preds = %B48.if.i.i.i
  %.700.idx.i.i.i = shl i64 %.184308332.i.i.i, 4
  %.700.i.i.i = getelementptr inbounds i8, ptr %150, i64 %.700.idx.i.i.i
  %.701.i.i.i = shufflevector <8 x double> %.369.i.i.i, <8 x double> %.425.i.i.i, <16 x i32> <i32 0, i32 8, i32 1, i32 9, i32 2, i32 10, i32 3, i32 11, i32 4, i32 12, i32 5, i32 13, i32 6, i32 14, i32 7, i32 15>
  store <16 x double> %.701.i.i.i, ptr %.700.i.i.i, align 4, !noalias !141
  br label %B8300.i.i.i

B8300.i.loopexit.unr-lcssa.i.i:                   ; preds = %B8132.if.i.i.i
  %192 = and i64 %smax29.i.i, 1
  %lcmp.mod467.not.i.i = icmp eq i64 %192, 0
  br i1 %lcmp.mod467.not.i.i, label %B8300.i.i.i, label %B8132.if.i.epil.preheader.i.i

B8132.if.i.epil.preheader.i.i:                    ; preds = %B8300.i.loopexit.unr-lcssa.i.i, %B8132.if.i.preheader.i.i
  %.568298300.i.epil.init.i.i = phi i64 [ 0, %B8132.if.i.preheader.i.i ], [ %.575.1.i.1.i.i, %B8300.i.loopexit.unr-lcssa.i.i ]
  %sunkaddr.i129.epil.i.i = shl i64 %.568298300.i.epil.init.i.i, 3
  %sunkaddr33.i.epil.i.i = getelementptr i8, ptr %arg.state.12.4, i64 %sunkaddr.i129.epil.i.i
  %.629.i.epil.i.i = load double, ptr %sunkaddr33.i.epil.i.i, align 8, !noalias !141
  %193 = add i64 %.568298300.i.epil.init.i.i, %lsr.iv31.i.i.i
  %.646.i.epil.i.i = icmp slt i64 %193, 0
  %194 = select i1 %.646.i.epil.i.i, i64 %75, i64 0
  %scevgep29.i.epil.i.i = getelementptr i8, ptr %lsr.iv.i127.i.i, i64 %194
  %scevgep30.i.epil.i.i = getelementptr i8, ptr %scevgep29.i.epil.i.i, i64 %sunkaddr.i129.epil.i.i
  store double %.629.i.epil.i.i, ptr %scevgep30.i.epil.i.i, align 8, !noalias !141
  %sunkaddr36.i.epil.i.i = getelementptr i8, ptr %sunkaddr33.i.epil.i.i, i64 8
  %.629.1.i.epil.i.i = load double, ptr %sunkaddr36.i.epil.i.i, align 8, !noalias !141
  %195 = add i64 %.568298300.i.epil.init.i.i, %lsr.iv26.i.i.i
  %.646.1.i.epil.i.i = icmp slt i64 %195, 0
  %196 = select i1 %.646.1.i.epil.i.i, i64 %75, i64 0
  %scevgep23.i.epil.i.i = getelementptr i8, ptr %lsr.iv.i127.i.i, i64 %196
  %scevgep24.i.epil.i.i = getelementptr i8, ptr %scevgep23.i.epil.i.i, i64 %sunkaddr.i129.epil.i.i
  %scevgep25.i.epil.i.i = getelementptr i8, ptr %scevgep24.i.epil.i.i, i64 8
  store double %.629.1.i.epil.i.i, ptr %scevgep25.i.epil.i.i, align 8, !noalias !141
  br label %B8300.i.i.i

B8300.i.i.i:                                      ; preds = %B8132.if.i.epil.preheader.i.i, %B8300.i.loopexit.unr-lcssa.i.i, %B8244.i.i.i, %B412.i.i.i
  %scevgep22.i.i.i = getelementptr i8, ptr %lsr.iv.i127.i.i, i64 128
  %lsr.iv.next.i128.i.i = add i64 %lsr.iv26.i.i.i, 16
  %lsr.iv.next28.i.i.i = add i64 %lsr.iv27.i.i.i, -8
  %lsr.iv.next32.i.i.i = add i64 %lsr.iv31.i.i.i, 16
  %.178.i.i.i = icmp sgt i64 %.177303333.i.i.i, 1
  br i1 %.178.i.i.i, label %B48.if.i.i.i, label %B1154.endif.endif.endif.i.i

B48.if.i.i.i:                                     ; preds = %B8300.i.i.i, %B48.if.i.preheader.i.i
  %lsr.iv31.i.i.i = phi i64 [ %lsr.iv.next32.i.i.i, %B8300.i.i.i ], [ 0, %B48.if.i.preheader.i.i ]
  %lsr.iv27.i.i.i = phi i64 [ %lsr.iv.next28.i.i.i, %B8300.i.i.i ], [ %.1936.i.i, %B48.if.i.preheader.i.i ]
  %lsr.iv26.i.i.i = phi i64 [ %lsr.iv.next.i128.i.i, %B8300.i.i.i ], [ 1, %B48.if.i.preheader.i.i ]
  %lsr.iv.i127.i.i = phi ptr [ %scevgep22.i.i.i, %B8300.i.i.i ], [ %150, %B48.if.i.preheader.i.i ]
  %.177303333.i.i.i = phi i64 [ %.187.i.i.i, %B8300.i.i.i ], [ %.616.i.i.i, %B48.if.i.preheader.i.i ]
  %.184308332.i.i.i = phi i64 [ %.191.i.i11.i, %B8300.i.i.i ], [ 0, %B48.if.i.preheader.i.i ]
  %smax29.i.i = tail call i64 @llvm.smax.i64(i64 %lsr.iv27.i.i.i, i64 0)
  %197 = trunc nuw i64 %smax29.i.i to i63
  %198 = add i63 %197, -1
  %199 = zext i63 %198 to i64
  %200 = add nuw i64 %199, 1
  %201 = lshr i64 %200, 1
  %202 = mul nsw i64 %201, -2
  %.187.i.i.i = add nsw i64 %.177303333.i.i.i, -1
  %.191.i.i11.i = add nuw i64 %.184308332.i.i.i, 8
  %sunkaddr715.i.i = shl i64 %.184308332.i.i.i, 3
  %sunkaddr716.i.i = getelementptr inbounds i8, ptr %arg.state.15.4, i64 %sunkaddr715.i.i
  %sunkaddr717.i.i = getelementptr inbounds nuw i8, ptr %sunkaddr716.i.i, i64 5440
  %.229.i.i.i = load <8 x double>, ptr %sunkaddr717.i.i, align 8, !noalias !141
  %sunkaddr720.i.i = getelementptr inbounds nuw i8, ptr %sunkaddr716.i.i, i64 6528
  %.246.i.i.i = load <8 x double>, ptr %sunkaddr720.i.i, align 8, !noalias !141
  %sunkaddr722.i.i = getelementptr i8, ptr %149, i64 %sunkaddr715.i.i
  %sunkaddr723.i.i = getelementptr i8, ptr %sunkaddr722.i.i, i64 9792
  %.259.i.i.i = load <8 x double>, ptr %sunkaddr723.i.i, align 8, !noalias !141
  %sunkaddr726.i.i = getelementptr i8, ptr %sunkaddr722.i.i, i64 16320
  %.269.i.i.i = load <8 x double>, ptr %sunkaddr726.i.i, align 8, !noalias !141
  %.8.i.i.i12.i = fmul contract <8 x double> %.7.i.i.i.i80, %.269.i.i.i
  %.6.i16.i.i.i = fmul contract <8 x double> %.246.i.i.i, %.8.i.i.i12.i
  %.6.i17.i.i.i = fsub contract <8 x double> zeroinitializer, %.6.i16.i.i.i
  %.369.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.229.i.i.i, <8 x double> %.259.i.i.i, <8 x double> %.6.i17.i.i.i)
  %.372.i.i.i = sub nsw i64 %.1936.i.i, %.184308332.i.i.i
  %.6.i18.i.i.i = fmul contract <8 x double> %.246.i.i.i, %.259.i.i.i
  %.425.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.229.i.i.i, <8 x double> %.8.i.i.i12.i, <8 x double> %.6.i18.i.i.i)
  %.459.i.i.i = icmp slt i64 %.372.i.i.i, 8
  br i1 %.459.i.i.i, label %B412.i.i.i, label %B8244.i.i.i

B8132.if.i.i.i:                                   ; preds = %B8132.if.i.preheader.i.i, %B8132.if.i.i.i
  %lsr.iv30.i15.i = phi i64 [ %lsr.iv.next31.i.i, %B8132.if.i.i.i ], [ %202, %B8132.if.i.preheader.i.i ]
  %.568298300.i.i.i = phi i64 [ %.575.1.i.1.i.i, %B8132.if.i.i.i ], [ 0, %B8132.if.i.preheader.i.i ]
  %sunkaddr234.i.i = shl i64 %.568298300.i.i.i, 3
  %sunkaddr251.i.i = getelementptr i8, ptr %arg.state.12.4, i64 %sunkaddr234.i.i
  %.629.i.i.i = load double, ptr %sunkaddr251.i.i, align 8, !noalias !141
  %203 = add i64 %.568298300.i.i.i, %lsr.iv31.i.i.i
  %.646.i.i.i = icmp slt i64 %203, 0
  %204 = select i1 %.646.i.i.i, i64 %75, i64 0
  %scevgep29.i.i.i = getelementptr i8, ptr %lsr.iv.i127.i.i, i64 %204
  %scevgep37.i16.i = getelementptr i8, ptr %scevgep29.i.i.i, i64 %sunkaddr234.i.i
  store double %.629.i.i.i, ptr %scevgep37.i16.i, align 8, !noalias !141
  %sunkaddr254.i.i = getelementptr i8, ptr %sunkaddr251.i.i, i64 8
  %.629.1.i.i.i = load double, ptr %sunkaddr254.i.i, align 8, !noalias !141
  %205 = select i1 %.646.i.i.i, i64 %86, i64 8
  %scevgep508.i.i = getelementptr i8, ptr %lsr.iv.i127.i.i, i64 %205
  %scevgep36.i17.i = getelementptr i8, ptr %scevgep508.i.i, i64 %sunkaddr234.i.i
  store double %.629.1.i.i.i, ptr %scevgep36.i17.i, align 8, !noalias !141
  %sunkaddr257.i.i = getelementptr i8, ptr %sunkaddr251.i.i, i64 16
  %.629.i.1.i.i = load double, ptr %sunkaddr257.i.i, align 8, !noalias !141
  %206 = select i1 %.646.i.i.i, i64 %87, i64 16
  %scevgep498.i.i = getelementptr i8, ptr %lsr.iv.i127.i.i, i64 %206
  %scevgep35.i18.i = getelementptr i8, ptr %scevgep498.i.i, i64 %sunkaddr234.i.i
  store double %.629.i.1.i.i, ptr %scevgep35.i18.i, align 8, !noalias !141
  %.575.1.i.1.i.i = add i64 %.568298300.i.i.i, 4
  %sunkaddr258.i.i = shl i64 %.575.1.i.1.i.i, 3
  %sunkaddr259.i.i = getelementptr i8, ptr %arg.state.12.4, i64 %sunkaddr258.i.i
  %sunkaddr260.i.i = getelementptr i8, ptr %sunkaddr259.i.i, i64 -8
  %.629.1.i.1.i.i = load double, ptr %sunkaddr260.i.i, align 8, !noalias !141
  %207 = select i1 %.646.i.i.i, i64 %88, i64 24
  %scevgep496.i.i = getelementptr i8, ptr %lsr.iv.i127.i.i, i64 %207
  %scevgep34.i19.i = getelementptr i8, ptr %scevgep496.i.i, i64 %sunkaddr234.i.i
  store double %.629.1.i.1.i.i, ptr %scevgep34.i19.i, align 8, !noalias !141
  %lsr.iv.next31.i.i = add i64 %lsr.iv30.i15.i, 2
  %niter470.ncmp.1.i.i = icmp eq i64 %lsr.iv.next31.i.i, 0
  br i1 %niter470.ncmp.1.i.i, label %B8300.i.loopexit.unr-lcssa.i.i, label %B8132.if.i.i.i

B1154.endif.endif.endif.i.i:                      ; preds = %B8300.i.i.i, %B1154.i.i
  br i1 %91, label %B1154.endif.endif.endif.endif.i.i, label %B48.if.preheader.i130.i.i

B48.if.preheader.i130.i.i:                        ; preds = %B1154.endif.endif.endif.i.i
  br i1 %99, label %B48.if.prol.loopexit.i.i.i, label %B48.if.prol.i.preheader.i.i

B48.if.prol.i.preheader.i.i:                      ; preds = %B48.if.preheader.i130.i.i
  %208 = inttoptr i64 %.1400.i.i to ptr
  %scevgep516.i.i = getelementptr i8, ptr %208, i64 %85
  br label %B48.if.prol.i.i.i

B48.if.prol.i.i.i:                                ; preds = %B48.if.prol.i.i.i, %B48.if.prol.i.preheader.i.i
  %lsr.iv514.i.i = phi i64 [ 0, %B48.if.prol.i.preheader.i.i ], [ %lsr.iv.next515.i.i, %B48.if.prol.i.i.i ]
  %209 = add i64 %lsr.iv514.i.i, %.20.i226.i.i
  %.154.prol.i.i.i = icmp slt i64 %209, 0
  %210 = select i1 %.154.prol.i.i.i, i64 %75, i64 0
  %scevgep517.i.i = getelementptr i8, ptr %scevgep516.i.i, i64 %210
  %211 = shl i64 %lsr.iv514.i.i, 3
  %scevgep46.i.i82 = getelementptr i8, ptr %scevgep517.i.i, i64 %211
  store double 0.000000e+00, ptr %scevgep46.i.i82, align 8, !noalias !144
  %lsr.iv.next515.i.i = add nuw nsw i64 %lsr.iv514.i.i, 1
  %prol.iter.cmp.not.i.i.i = icmp eq i64 %84, %lsr.iv.next515.i.i
  br i1 %prol.iter.cmp.not.i.i.i, label %B48.if.prol.loopexit.loopexit.i.i.i, label %B48.if.prol.i.i.i, !llvm.loop !147

B48.if.prol.loopexit.loopexit.i.i.i:              ; preds = %B48.if.prol.i.i.i
  %212 = sub i64 %83, %lsr.iv.next515.i.i
  %213 = add i64 %lsr.iv.next515.i.i, %.20.i226.i.i
  br label %B48.if.prol.loopexit.i.i.i

B48.if.prol.loopexit.i.i.i:                       ; preds = %B48.if.prol.loopexit.loopexit.i.i.i, %B48.if.preheader.i130.i.i
  %.1025458.unr.i.i.i = phi i64 [ %.58.i223.i.i, %B48.if.preheader.i130.i.i ], [ %212, %B48.if.prol.loopexit.loopexit.i.i.i ]
  %.1095557.unr.i.i.i = phi i64 [ %.20.i226.i.i, %B48.if.preheader.i130.i.i ], [ %213, %B48.if.prol.loopexit.loopexit.i.i.i ]
  br i1 %101, label %B1154.endif.endif.endif.endif.i.i, label %B48.if.preheader1.i.i.i

B48.if.preheader1.i.i.i:                          ; preds = %B48.if.prol.loopexit.i.i.i
  %214 = add i64 %.1025458.unr.i.i.i, 4
  %215 = inttoptr i64 %.1400.i.i to ptr
  %216 = shl i64 %.1095557.unr.i.i.i, 3
  %scevgep47.i13.i = getelementptr i8, ptr %215, i64 %216
  br label %B48.if.i132.i.i

B48.if.i132.i.i:                                  ; preds = %B48.if.i132.i.i, %B48.if.preheader1.i.i.i
  %lsr.iv48.i.i = phi ptr [ %scevgep49.i14.i, %B48.if.i132.i.i ], [ %scevgep47.i13.i, %B48.if.preheader1.i.i.i ]
  %lsr.iv.i133.i.i = phi i64 [ %lsr.iv.next.i139.i.i, %B48.if.i132.i.i ], [ %214, %B48.if.preheader1.i.i.i ]
  %.1095557.i.i.i = phi i64 [ %224, %B48.if.i132.i.i ], [ %.1095557.unr.i.i.i, %B48.if.preheader1.i.i.i ]
  %.154.i.i.i = icmp slt i64 %.1095557.i.i.i, 0
  %217 = select i1 %.154.i.i.i, i64 %75, i64 0
  %scevgep53.i.i83 = getelementptr i8, ptr %lsr.iv48.i.i, i64 %217
  store double 0.000000e+00, ptr %scevgep53.i.i83, align 8, !noalias !144
  %218 = add i64 %.1095557.i.i.i, 1
  %.154.1.i.i.i = icmp slt i64 %218, 0
  %219 = select i1 %.154.1.i.i.i, i64 %86, i64 8
  %scevgep52.i.i = getelementptr i8, ptr %lsr.iv48.i.i, i64 %219
  store double 0.000000e+00, ptr %scevgep52.i.i, align 8, !noalias !144
  %220 = add i64 %.1095557.i.i.i, 2
  %.154.2.i.i.i = icmp slt i64 %220, 0
  %221 = select i1 %.154.2.i.i.i, i64 %87, i64 16
  %scevgep51.i.i = getelementptr i8, ptr %lsr.iv48.i.i, i64 %221
  store double 0.000000e+00, ptr %scevgep51.i.i, align 8, !noalias !144
  %222 = add i64 %.1095557.i.i.i, 3
  %.154.3.i.i.i = icmp slt i64 %222, 0
  %223 = select i1 %.154.3.i.i.i, i64 %88, i64 24
  %scevgep50.i.i84 = getelementptr i8, ptr %lsr.iv48.i.i, i64 %223
  store double 0.000000e+00, ptr %scevgep50.i.i84, align 8, !noalias !144
  %lsr.iv.next.i139.i.i = add i64 %lsr.iv.i133.i.i, -4
  %scevgep49.i14.i = getelementptr i8, ptr %lsr.iv48.i.i, i64 32
  %.103.3.i.i.i = icmp sgt i64 %lsr.iv.next.i139.i.i, 4
  %224 = add i64 %.1095557.i.i.i, 4
  br i1 %.103.3.i.i.i, label %B48.if.i132.i.i, label %B1154.endif.endif.endif.endif.i.i

B1154.endif.endif.endif.endif.i.i:                ; preds = %B48.if.i132.i.i, %B48.if.prol.loopexit.i.i.i, %B1154.endif.endif.endif.i.i
  %exitcond3963.not.i.i = icmp eq i64 %.1067.i.i, 6
  br i1 %exitcond3963.not.i.i, label %_ZN17bnserve_surrogate8tangents4_row11_write_modeB4v413B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi3EEd692Row_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20int64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_203_29_2c_20UniTuple_28array_28float64_2c_201d_2c_20C_29_20x_202_29_2c_20UniTuple_28array_28int64_2c_201d_2c_20C_29_20x_202_29_2c_20UniTuple_28array_28float64_2c_201d_2c_20C_29_20x_202_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29.exit.i, label %B294.if.i.i

B294.loopexit.unr-lcssa.i.i.i:                    ; preds = %B278.if.i.i.i
  br i1 %229, label %B294.i.i.i, label %B278.if.epil.i.i.i.preheader

B278.if.epil.i.i.i.preheader:                     ; preds = %B278.if.preheader.i.i.i, %B294.loopexit.unr-lcssa.i.i.i
  %w.2.1315.epil.i.i.i.ph = phi <8 x double> [ %.6.i15.3.i.i.i, %B294.loopexit.unr-lcssa.i.i.i ], [ %.717.i.i.i, %B278.if.preheader.i.i.i ]
  br label %B278.if.epil.i.i.i

B278.if.epil.i.i.i:                               ; preds = %B278.if.epil.i.i.i.preheader, %B278.if.epil.i.i.i
  %lsr.iv37.i.i.i = phi i64 [ %lsr.iv.next38.i.i.i, %B278.if.epil.i.i.i ], [ %xtraiter.i191.i.i, %B278.if.epil.i.i.i.preheader ]
  %w.2.1315.epil.i.i.i = phi <8 x double> [ %.6.i15.epil.i.i.i, %B278.if.epil.i.i.i ], [ %w.2.1315.epil.i.i.i.ph, %B278.if.epil.i.i.i.preheader ]
  %.6.i15.epil.i.i.i = fmul contract <8 x double> %.717.i.i.i, %w.2.1315.epil.i.i.i
  %lsr.iv.next38.i.i.i = add nsw i64 %lsr.iv37.i.i.i, -1
  %epil.iter.cmp.not.i.i.i = icmp eq i64 %lsr.iv.next38.i.i.i, 0
  br i1 %epil.iter.cmp.not.i.i.i, label %B294.i.i.i, label %B278.if.epil.i.i.i, !llvm.loop !148

B294.i.i.i:                                       ; preds = %B278.if.epil.i.i.i, %B172.if.i.i.i, %B294.loopexit.unr-lcssa.i.i.i
  %w.2.1.lcssa.i.i.i = phi <8 x double> [ %.717.i.i.i, %B172.if.i.i.i ], [ %.6.i15.3.i.i.i, %B294.loopexit.unr-lcssa.i.i.i ], [ %.6.i15.epil.i.i.i, %B278.if.epil.i.i.i ]
  %sunkaddr.i198.i.i = shl i64 %.643322337.i.i.i, 3
  %sunkaddr39.i.i.i = getelementptr inbounds i8, ptr %arg.state.15.4, i64 %sunkaddr.i198.i.i
  %sunkaddr40.i.i.i = getelementptr inbounds nuw i8, ptr %sunkaddr39.i.i.i, i64 3264
  %.893.i199.i.i = load <8 x double>, ptr %sunkaddr40.i.i.i, align 8, !noalias !149
  %.6.i.i200.i.i = fmul contract <8 x double> %w.2.1.lcssa.i.i.i, %.893.i199.i.i
  %.926.i.i.i = getelementptr inbounds double, ptr %arg.state.15.4, i64 %.643322337.i.i.i
  store <8 x double> %.6.i.i200.i.i, ptr %.926.i.i.i, align 8, !noalias !149
  %sunkaddr43.i.i.i = getelementptr inbounds nuw i8, ptr %sunkaddr39.i.i.i, i64 4352
  %.947.i.i.i = load <8 x double>, ptr %sunkaddr43.i.i.i, align 8, !noalias !149
  %.6.i16.i201.i.i = fmul contract <8 x double> %w.2.1.lcssa.i.i.i, %.947.i.i.i
  %sunkaddr740.i.i = getelementptr inbounds nuw i8, ptr %sunkaddr39.i.i.i, i64 1088
  store <8 x double> %.6.i16.i201.i.i, ptr %sunkaddr740.i.i, align 8, !noalias !149
  %.637.i.i.i = icmp sgt i64 %.636318338.i.i.i, 1
  br i1 %.637.i.i.i, label %B172.if.i.i.i, label %B456.i.i.i

B456.i.i.i:                                       ; preds = %B294.i.i.i, %B1214.i.i
  br i1 %.1026.i.i.i, label %B472.i.i.i, label %B1336.endif.endif.endif.e...endif.i.i

B472.i.i.i:                                       ; preds = %B456.i.i.i
  %.1065.i.i.i = load double, ptr %.2673.i.i, align 8, !noalias !149
  %.1069.i.i.i = fmul contract double %.3344.i.i, %.1065.i.i.i
  %.1071.i.i.i = fcmp contract olt double %.1069.i.i.i, %.2072.i.i
  br i1 %.1071.i.i.i, label %B502.preheader.i.i.i, label %B1336.endif.endif.endif.e...endif.i.i

B502.preheader.i.i.i:                             ; preds = %B472.i.i.i
  %225 = getelementptr i8, ptr %151, i64 %74
  %scevgep591.i.i = getelementptr i8, ptr %225, i64 8
  br label %B502.i.i.i

B502.i.i.i:                                       ; preds = %B524.i.i.i, %B502.preheader.i.i.i
  %cut.2.1.i.i.i = phi i64 [ %.1077.i.i.i, %B524.i.i.i ], [ 0, %B502.preheader.i.i.i ]
  %exitcond366.not.i.i.i = icmp eq i64 %73, %cut.2.1.i.i.i
  br i1 %exitcond366.not.i.i.i, label %B1336.endif.endif.endif.e...endif.i.i, label %B524.i.i.i

B524.i.i.i:                                       ; preds = %B502.i.i.i
  %.1077.i.i.i = add nuw nsw i64 %cut.2.1.i.i.i, 1
  %sunkaddr44.i.i.i = shl i64 %cut.2.1.i.i.i, 3
  %scevgep592.i.i = getelementptr i8, ptr %scevgep591.i.i, i64 %sunkaddr44.i.i.i
  %.1126.i.i.i = load double, ptr %scevgep592.i.i, align 8, !noalias !149
  %.1130.i.i.i = fmul contract double %.3344.i.i, %.1126.i.i.i
  %.1132.i.i.i = fcmp contract olt double %.1130.i.i.i, %.2072.i.i
  br i1 %.1132.i.i.i, label %B502.i.i.i, label %B1336.endif.endif.endif.e...endif.i.i

B172.if.lr.ph.i.i.i:                              ; preds = %B1214.i.i
  %.715.i.i.i = insertelement <8 x double> poison, double %.2072.i.i, i64 0
  %.716.i.i.i = shufflevector <8 x double> %.715.i.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.762.i.i.i = add i64 %.458.i.i, -1
  %..762.i.i.i = tail call i64 @llvm.smax.i64(i64 %.762.i.i.i, i64 0)
  %xtraiter.i191.i.i = and i64 %..762.i.i.i, 3
  %226 = and i64 %..762.i.i.i, 9223372036854775804
  %227 = icmp slt i64 %.762.i.i.i, 1
  %228 = icmp slt i64 %.762.i.i.i, 4
  %229 = icmp eq i64 %xtraiter.i191.i.i, 0
  br label %B172.if.i.i.i

B172.if.i.i.i:                                    ; preds = %B172.if.lr.ph.i.i.i, %B294.i.i.i
  %.636318338.i.i.i = phi i64 [ %.616.i.i.i, %B172.if.lr.ph.i.i.i ], [ %.646.i193.i.i, %B294.i.i.i ]
  %.643322337.i.i.i = phi i64 [ 0, %B172.if.lr.ph.i.i.i ], [ %.650.i.i.i, %B294.i.i.i ]
  %.646.i193.i.i = add nsw i64 %.636318338.i.i.i, -1
  %.650.i.i.i = add nuw i64 %.643322337.i.i.i, 8
  %.686.i194.i.i = getelementptr inbounds double, ptr %.2673.i.i, i64 %.643322337.i.i.i
  %.688.i.i.i = load <8 x double>, ptr %.686.i194.i.i, align 8, !noalias !149
  %.8.i.i195.i.i = fmul contract <8 x double> %.7.i.i190.i.i, %.688.i.i.i
  %.717.i.i.i = tail call <8 x double> @llvm.minnum.v8f64(<8 x double> %.8.i.i195.i.i, <8 x double> %.716.i.i.i)
  br i1 %227, label %B294.i.i.i, label %B278.if.preheader.i.i.i

B278.if.preheader.i.i.i:                          ; preds = %B172.if.i.i.i
  br i1 %228, label %B278.if.epil.i.i.i.preheader, label %B278.if.i.i.i

B278.if.i.i.i:                                    ; preds = %B278.if.preheader.i.i.i, %B278.if.i.i.i
  %lsr.iv114.i.i = phi i64 [ %lsr.iv.next115.i.i, %B278.if.i.i.i ], [ %226, %B278.if.preheader.i.i.i ]
  %w.2.1315.i.i.i = phi <8 x double> [ %.6.i15.3.i.i.i, %B278.if.i.i.i ], [ %.717.i.i.i, %B278.if.preheader.i.i.i ]
  %.6.i15.i.i.i = fmul contract <8 x double> %.717.i.i.i, %w.2.1315.i.i.i
  %.6.i15.1.i.i.i = fmul contract <8 x double> %.717.i.i.i, %.6.i15.i.i.i
  %.6.i15.2.i.i.i = fmul contract <8 x double> %.717.i.i.i, %.6.i15.1.i.i.i
  %.6.i15.3.i.i.i = fmul contract <8 x double> %.717.i.i.i, %.6.i15.2.i.i.i
  %lsr.iv.next115.i.i = add nsw i64 %lsr.iv114.i.i, -4
  %niter.ncmp.3.i.i.i = icmp eq i64 %lsr.iv.next115.i.i, 0
  br i1 %niter.ncmp.3.i.i.i, label %B294.loopexit.unr-lcssa.i.i.i, label %B278.if.i.i.i

B1336.endif.endif.endif.e...endif.i.i:            ; preds = %B524.i.i.i, %B502.i.i.i, %B472.i.i.i, %B456.i.i.i
  %cut.3.0.i.i.i = phi i64 [ 0, %B472.i.i.i ], [ 0, %B456.i.i.i ], [ %.1936.i.i, %B502.i.i.i ], [ %.1077.i.i.i, %B524.i.i.i ]
  %.3662.i.i = mul nsw i64 %.398.i.i, %arg.i
  %.3663.i.i = add nsw i64 %.3662.i.i, %.428.i.i
  %.3855.i.i = mul nsw i64 %.3663.i.i, 6
  %.4198.i.i = sitofp i64 %.458.i.i to double
  %.6.i69.i.i.i = insertelement <8 x double> poison, double %.499.i.i, i64 0
  %.7.i70.i.i.i = shufflevector <8 x double> %.6.i69.i.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %sunkaddr168.i.i = getelementptr i8, ptr %scevgep197.i, i64 24
  %sunkaddr169.i.i = getelementptr i8, ptr %scevgep197.i, i64 40
  %sunkaddr171.i.i = getelementptr i8, ptr %scevgep197.i, i64 48
  br label %B1592.if.i.i

B1592.if.i.i:                                     ; preds = %B8963.endif.endif.endif.endif.i.i, %B1336.endif.endif.endif.e...endif.i.i
  %.352038793888.i.i = phi i64 [ 0, %B1336.endif.endif.endif.e...endif.i.i ], [ %.3527.i.i, %B8963.endif.endif.endif.endif.i.i ]
  %.3527.i.i = add nuw nsw i64 %.352038793888.i.i, 1
  %.3658.i.i = load i64, ptr %.291.i16, align 8, !noalias !121
  %.3697.i.i = load i64, ptr %sunkaddr262.i.i, align 8, !noalias !121
  %.3701.i.i = mul nsw i64 %.3658.i.i, %.3663.i.i
  %.3702.i.i = add nsw i64 %.3701.i.i, %.184321492185.i
  %.3703.i.i = shl nsw i64 %.3702.i.i, 4
  %.3704.i.i = add nsw i64 %.3703.i.i, %.3697.i.i
  %.3851.i.i = load i64, ptr %sunkaddr263.i.i, align 8, !noalias !121
  %.3856.i.i = add nsw i64 %.352038793888.i.i, %.3855.i.i
  %.3857.i.i = mul nsw i64 %.3658.i.i, %.3856.i.i
  %.3858.i.i = add nsw i64 %.3857.i.i, %.184321492185.i
  %.3859.i.i = shl nsw i64 %.3858.i.i, 4
  %.3860.i.i = add nsw i64 %.3859.i.i, %.3851.i.i
  %.4016.i.i = icmp ne i64 %.352038793888.i.i, 0
  %or.cond2.i.i = or i1 %.595.inv.i.i.i, %.4016.i.i
  br i1 %or.cond2.i.i, label %B8644.i.i, label %B34.if.preheader.i70.i.i

B8644.endif.i.i:                                  ; preds = %B9542.endif.endif.endif.endif.endif.endif.endif.i.i.i
  br i1 %.1496.not.i.i.i, label %B8899.i.i, label %B8963.i.i

B22.i.i.i:                                        ; preds = %B9839.i.i.i, %B22.i.preheader.i.i
  %j.2.0.i.i.i = phi i64 [ %.987.i.i.i, %B9839.i.i.i ], [ 0, %B22.i.preheader.i.i ]
  %.173.i.i.i = sub nsw i64 %.1936.i.i, %j.2.0.i.i.i
  %.13.i.i217.i.i = tail call i64 @llvm.smin.i64(i64 %.173.i.i.i, i64 8)
  %.213.i.i.i = icmp sgt i64 %cut.3.0.i.i.i, %j.2.0.i.i.i
  %.217.i.i.i = sub nsw i64 %cut.3.0.i.i.i, %j.2.0.i.i.i
  %.13.i68.i.i.i = tail call i64 @llvm.smin.i64(i64 %.217.i.i.i, i64 %.13.i.i217.i.i)
  %arg.rising..i.i.i = select i1 %.213.i.i.i, double %"$phi1336.1.2.1.i.i", double 0.000000e+00
  %size.2.1.i.i.i = select i1 %.213.i.i.i, i64 %.13.i68.i.i.i, i64 %.13.i.i217.i.i
  %sunkaddr744.i.i = shl i64 %j.2.0.i.i.i, 3
  %sunkaddr745.i.i = getelementptr inbounds i8, ptr %arg.state.15.4, i64 %sunkaddr744.i.i
  %sunkaddr746.i.i = getelementptr inbounds nuw i8, ptr %sunkaddr745.i.i, i64 5440
  %.268.i.i.i = load <8 x double>, ptr %sunkaddr746.i.i, align 8, !noalias !152
  %sunkaddr749.i.i = getelementptr inbounds nuw i8, ptr %sunkaddr745.i.i, i64 6528
  %.286.i.i.i = load <8 x double>, ptr %sunkaddr749.i.i, align 8, !noalias !152
  %sunkaddr751.i.i = getelementptr i8, ptr %189, i64 %sunkaddr744.i.i
  %sunkaddr752.i.i = getelementptr i8, ptr %sunkaddr751.i.i, i64 9792
  %.306.i.i.i = load <8 x double>, ptr %sunkaddr752.i.i, align 8, !noalias !152
  %.6.i.i218.i.i = insertelement <8 x double> poison, double %arg.rising..i.i.i, i64 0
  %.7.i.i219.i.i = shufflevector <8 x double> %.6.i.i218.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.8.i.i220.i.i = fadd contract <8 x double> %.306.i.i.i, %.7.i.i219.i.i
  %sunkaddr755.i.i = getelementptr i8, ptr %sunkaddr751.i.i, i64 16320
  %.362.i.i.i = load <8 x double>, ptr %sunkaddr755.i.i, align 8, !noalias !152
  %.8.i71.i.i.i = fmul contract <8 x double> %.7.i70.i.i.i, %.362.i.i.i
  %.400.i.i.i = getelementptr inbounds double, ptr %arg.state.15.4, i64 %j.2.0.i.i.i
  %.402.i.i.i = load <8 x double>, ptr %.400.i.i.i, align 8, !noalias !152
  %sunkaddr758.i.i = getelementptr inbounds nuw i8, ptr %sunkaddr745.i.i, i64 1088
  %.420.i.i.i = load <8 x double>, ptr %sunkaddr758.i.i, align 8, !noalias !152
  %sunkaddr761.i.i = getelementptr inbounds nuw i8, ptr %sunkaddr745.i.i, i64 7616
  %.438.i.i.i = load <8 x double>, ptr %sunkaddr761.i.i, align 8, !noalias !152
  %sunkaddr764.i.i = getelementptr i8, ptr %sunkaddr745.i.i, i64 8704
  %.456.i.i.i = load <8 x double>, ptr %sunkaddr764.i.i, align 8, !noalias !152
  %.6.i72.i.i.i = fmul contract <8 x double> %.420.i.i.i, %.456.i.i.i
  %.6.i73.i.i.i = fsub contract <8 x double> zeroinitializer, %.6.i72.i.i.i
  %.534.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.402.i.i.i, <8 x double> %.438.i.i.i, <8 x double> %.6.i73.i.i.i)
  %.6.i74.i.i.i = fmul contract <8 x double> %.286.i.i.i, %.8.i71.i.i.i
  %.6.i75.i.i.i = fsub contract <8 x double> zeroinitializer, %.6.i74.i.i.i
  %.587.i.i5.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.268.i.i.i, <8 x double> %.8.i.i220.i.i, <8 x double> %.6.i75.i.i.i)
  %.6.i76.i.i.i = fadd contract <8 x double> %.587.i.i5.i, %.534.i.i.i
  %.6.i77.i.i.i = fmul contract <8 x double> %.420.i.i.i, %.438.i.i.i
  %.6.i78.i.i.i = fmul contract <8 x double> %.286.i.i.i, %.8.i.i220.i.i
  %.636.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.402.i.i.i, <8 x double> %.456.i.i.i, <8 x double> %.6.i77.i.i.i)
  %.665.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.268.i.i.i, <8 x double> %.8.i71.i.i.i, <8 x double> %.6.i78.i.i.i)
  %.6.i79.i.i.i = fadd contract <8 x double> %.665.i.i.i, %.636.i.i.i
  %.728.i.i.i = icmp slt i64 %size.2.1.i.i.i, 8
  br i1 %.728.i.i.i, label %B776.i.i.i, label %B9785.i.i.i

B776.i.i.i:                                       ; preds = %B22.i.i.i
  %.741.i.i.i = shufflevector <8 x double> %.6.i76.i.i.i, <8 x double> %.6.i79.i.i.i, <16 x i32> <i32 0, i32 8, i32 1, i32 9, i32 2, i32 10, i32 3, i32 11, i32 4, i32 12, i32 5, i32 13, i32 6, i32 14, i32 7, i32 15>
  store <16 x double> %.741.i.i.i, ptr %arg.state.12.4, align 4, !noalias !152
  %.831564.not.i.i.i = icmp slt i64 %size.2.1.i.i.i, 1
  br i1 %.831564.not.i.i.i, label %B9839.i.i.i, label %B780.if.lr.ph.i.i.i

B780.if.lr.ph.i.i.i:                              ; preds = %B776.i.i.i
  %.900.i.i.i = shl nsw i64 %j.2.0.i.i.i, 1
  %230 = shl i64 %j.2.0.i.i.i, 4
  %scevgep83.i.i.i = getelementptr i8, ptr %190, i64 %230
  %.898.i.i.i = load double, ptr %arg.state.12.4, align 8, !noalias !152
  %.915.i.i.i = icmp slt i64 %j.2.0.i.i.i, 0
  %231 = select i1 %.915.i.i.i, i64 %75, i64 0
  %scevgep87.i.i.i = getelementptr i8, ptr %scevgep83.i.i.i, i64 %231
  store double %.898.i.i.i, ptr %scevgep87.i.i.i, align 8, !noalias !152
  %.898.1.i.i.i = load double, ptr %sunkaddr264.i.i, align 8, !noalias !152
  %scevgep86.i.i.i = getelementptr i8, ptr %scevgep87.i.i.i, i64 8
  store double %.898.1.i.i.i, ptr %scevgep86.i.i.i, align 8, !noalias !152
  %exitcond.not.1.i222.i.i = icmp eq i64 %size.2.1.i.i.i, 1
  br i1 %exitcond.not.1.i222.i.i, label %B9839.i.i.i, label %B780.if.i.1.i.i

B9785.i.i.i:                                      ; preds = %B22.i.i.i
  %.969.idx.i.i.i = shl i64 %j.2.0.i.i.i, 4
  %.969.i.i.i = getelementptr inbounds i8, ptr %190, i64 %.969.idx.i.i.i
  %.970.i.i.i = shufflevector <8 x double> %.6.i76.i.i.i, <8 x double> %.6.i79.i.i.i, <16 x i32> <i32 0, i32 8, i32 1, i32 9, i32 2, i32 10, i32 3, i32 11, i32 4, i32 12, i32 5, i32 13, i32 6, i32 14, i32 7, i32 15>
  store <16 x double> %.970.i.i.i, ptr %.969.i.i.i, align 4, !noalias !152
  br label %B9839.i.i.i

B9839.i.i.i:                                      ; preds = %B780.if.i.6.i.i, %B780.if.i.5.i.i, %B780.if.i.4.i.i, %B780.if.i.3.i.i, %B780.if.i.2.i.i, %B780.if.i.1.i.i, %B9785.i.i.i, %B780.if.lr.ph.i.i.i, %B776.i.i.i
  %.987.i.i.i = add nsw i64 %size.2.1.i.i.i, %j.2.0.i.i.i
  %.993.i.i.i = icmp slt i64 %.987.i.i.i, %.1936.i.i
  br i1 %.993.i.i.i, label %B22.i.i.i, label %B8963.endif.endif.endif.i.i

B780.if.i.1.i.i:                                  ; preds = %B780.if.lr.ph.i.i.i
  %.898.i.1.i.i = load double, ptr %sunkaddr265.i.i, align 8, !noalias !152
  %232 = add i64 %.900.i.i.i, 2
  %.915.i.1.i.i = icmp slt i64 %232, 0
  %233 = select i1 %.915.i.1.i.i, i64 %75, i64 0
  %scevgep87.i.1.i.i = getelementptr i8, ptr %scevgep83.i.i.i, i64 %233
  %scevgep88.i.1.i.i = getelementptr i8, ptr %scevgep87.i.1.i.i, i64 16
  store double %.898.i.1.i.i, ptr %scevgep88.i.1.i.i, align 8, !noalias !152
  %.898.1.i.1.i.i = load double, ptr %sunkaddr266.i.i, align 8, !noalias !152
  %scevgep86.i.1.i.i = getelementptr i8, ptr %scevgep87.i.1.i.i, i64 24
  store double %.898.1.i.1.i.i, ptr %scevgep86.i.1.i.i, align 8, !noalias !152
  %exitcond.not.1.i222.1.i.i = icmp eq i64 %size.2.1.i.i.i, 2
  br i1 %exitcond.not.1.i222.1.i.i, label %B9839.i.i.i, label %B780.if.i.2.i.i

B780.if.i.2.i.i:                                  ; preds = %B780.if.i.1.i.i
  %.898.i.2.i.i = load double, ptr %sunkaddr267.i.i, align 8, !noalias !152
  %234 = add i64 %.900.i.i.i, 4
  %.915.i.2.i.i = icmp slt i64 %234, 0
  %235 = select i1 %.915.i.2.i.i, i64 %75, i64 0
  %scevgep87.i.2.i.i = getelementptr i8, ptr %scevgep83.i.i.i, i64 %235
  %scevgep88.i.2.i.i = getelementptr i8, ptr %scevgep87.i.2.i.i, i64 32
  store double %.898.i.2.i.i, ptr %scevgep88.i.2.i.i, align 8, !noalias !152
  %.898.1.i.2.i.i = load double, ptr %sunkaddr268.i.i, align 8, !noalias !152
  %scevgep86.i.2.i.i = getelementptr i8, ptr %scevgep87.i.2.i.i, i64 40
  store double %.898.1.i.2.i.i, ptr %scevgep86.i.2.i.i, align 8, !noalias !152
  %exitcond.not.1.i222.2.i.i = icmp eq i64 %size.2.1.i.i.i, 3
  br i1 %exitcond.not.1.i222.2.i.i, label %B9839.i.i.i, label %B780.if.i.3.i.i

B780.if.i.3.i.i:                                  ; preds = %B780.if.i.2.i.i
  %.898.i.3.i.i = load double, ptr %sunkaddr269.i.i, align 8, !noalias !152
  %236 = add i64 %.900.i.i.i, 6
  %.915.i.3.i.i = icmp slt i64 %236, 0
  %237 = select i1 %.915.i.3.i.i, i64 %75, i64 0
  %scevgep87.i.3.i.i = getelementptr i8, ptr %scevgep83.i.i.i, i64 %237
  %scevgep88.i.3.i.i = getelementptr i8, ptr %scevgep87.i.3.i.i, i64 48
  store double %.898.i.3.i.i, ptr %scevgep88.i.3.i.i, align 8, !noalias !152
  %.898.1.i.3.i.i = load double, ptr %sunkaddr270.i.i, align 8, !noalias !152
  %scevgep86.i.3.i.i = getelementptr i8, ptr %scevgep87.i.3.i.i, i64 56
  store double %.898.1.i.3.i.i, ptr %scevgep86.i.3.i.i, align 8, !noalias !152
  %exitcond.not.1.i222.3.i.i = icmp eq i64 %size.2.1.i.i.i, 4
  br i1 %exitcond.not.1.i222.3.i.i, label %B9839.i.i.i, label %B780.if.i.4.i.i

B780.if.i.4.i.i:                                  ; preds = %B780.if.i.3.i.i
  %.898.i.4.i.i = load double, ptr %sunkaddr271.i.i, align 8, !noalias !152
  %238 = add i64 %.900.i.i.i, 8
  %.915.i.4.i.i = icmp slt i64 %238, 0
  %239 = select i1 %.915.i.4.i.i, i64 %75, i64 0
  %scevgep87.i.4.i.i = getelementptr i8, ptr %scevgep83.i.i.i, i64 %239
  %scevgep88.i.4.i.i = getelementptr i8, ptr %scevgep87.i.4.i.i, i64 64
  store double %.898.i.4.i.i, ptr %scevgep88.i.4.i.i, align 8, !noalias !152
  %.898.1.i.4.i.i = load double, ptr %sunkaddr272.i.i, align 8, !noalias !152
  %scevgep86.i.4.i.i = getelementptr i8, ptr %scevgep87.i.4.i.i, i64 72
  store double %.898.1.i.4.i.i, ptr %scevgep86.i.4.i.i, align 8, !noalias !152
  %exitcond.not.1.i222.4.i.i = icmp eq i64 %size.2.1.i.i.i, 5
  br i1 %exitcond.not.1.i222.4.i.i, label %B9839.i.i.i, label %B780.if.i.5.i.i

B780.if.i.5.i.i:                                  ; preds = %B780.if.i.4.i.i
  %.898.i.5.i.i = load double, ptr %sunkaddr273.i.i, align 8, !noalias !152
  %240 = add i64 %.900.i.i.i, 10
  %.915.i.5.i.i = icmp slt i64 %240, 0
  %241 = select i1 %.915.i.5.i.i, i64 %75, i64 0
  %scevgep87.i.5.i.i = getelementptr i8, ptr %scevgep83.i.i.i, i64 %241
  %scevgep88.i.5.i.i = getelementptr i8, ptr %scevgep87.i.5.i.i, i64 80
  store double %.898.i.5.i.i, ptr %scevgep88.i.5.i.i, align 8, !noalias !152
  %.898.1.i.5.i.i = load double, ptr %sunkaddr274.i.i, align 8, !noalias !152
  %scevgep86.i.5.i.i = getelementptr i8, ptr %scevgep87.i.5.i.i, i64 88
  store double %.898.1.i.5.i.i, ptr %scevgep86.i.5.i.i, align 8, !noalias !152
  %exitcond.not.1.i222.5.i.i = icmp eq i64 %size.2.1.i.i.i, 6
  br i1 %exitcond.not.1.i222.5.i.i, label %B9839.i.i.i, label %B780.if.i.6.i.i

B780.if.i.6.i.i:                                  ; preds = %B780.if.i.5.i.i
  %.898.i.6.i.i = load double, ptr %sunkaddr275.i.i, align 8, !noalias !152
  %242 = add i64 %.900.i.i.i, 12
  %.915.i.6.i.i = icmp slt i64 %242, 0
  %243 = select i1 %.915.i.6.i.i, i64 %75, i64 0
  %scevgep87.i.6.i.i = getelementptr i8, ptr %scevgep83.i.i.i, i64 %243
  %scevgep88.i.6.i.i = getelementptr i8, ptr %scevgep87.i.6.i.i, i64 96
  store double %.898.i.6.i.i, ptr %scevgep88.i.6.i.i, align 8, !noalias !152
  %.898.1.i.6.i.i = load double, ptr %sunkaddr276.i.i, align 8, !noalias !152
  %scevgep86.i.6.i.i = getelementptr i8, ptr %scevgep87.i.6.i.i, i64 104
  store double %.898.1.i.6.i.i, ptr %scevgep86.i.6.i.i, align 8, !noalias !152
  br label %B9839.i.i.i

B8963.endif.endif.endif.i.i:                      ; preds = %B9839.i.i.i, %B8963.i.i
  br i1 %91, label %B8963.endif.endif.endif.endif.i.i, label %B48.if.preheader.i225.i.i

B48.if.preheader.i225.i.i:                        ; preds = %B8963.endif.endif.endif.i.i
  br i1 %99, label %B48.if.prol.loopexit.i240.i.i, label %B48.if.prol.i230.preheader.i.i

B48.if.prol.i230.preheader.i.i:                   ; preds = %B48.if.preheader.i225.i.i
  %244 = inttoptr i64 %.3860.i.i to ptr
  %scevgep582.i.i = getelementptr i8, ptr %244, i64 %85
  br label %B48.if.prol.i230.i.i

B48.if.prol.i230.i.i:                             ; preds = %B48.if.prol.i230.i.i, %B48.if.prol.i230.preheader.i.i
  %lsr.iv580.i.i = phi i64 [ 0, %B48.if.prol.i230.preheader.i.i ], [ %lsr.iv.next581.i.i, %B48.if.prol.i230.i.i ]
  %245 = add i64 %lsr.iv580.i.i, %.20.i226.i.i
  %.154.prol.i234.i.i = icmp slt i64 %245, 0
  %246 = select i1 %.154.prol.i234.i.i, i64 %75, i64 0
  %scevgep583.i.i = getelementptr i8, ptr %scevgep582.i.i, i64 %246
  %247 = shl i64 %lsr.iv580.i.i, 3
  %scevgep113.i.i74 = getelementptr i8, ptr %scevgep583.i.i, i64 %247
  store double 0.000000e+00, ptr %scevgep113.i.i74, align 8, !noalias !155
  %lsr.iv.next581.i.i = add nuw nsw i64 %lsr.iv580.i.i, 1
  %prol.iter.cmp.not.i238.i.i = icmp eq i64 %84, %lsr.iv.next581.i.i
  br i1 %prol.iter.cmp.not.i238.i.i, label %B48.if.prol.loopexit.loopexit.i239.i.i, label %B48.if.prol.i230.i.i, !llvm.loop !147

B48.if.prol.loopexit.loopexit.i239.i.i:           ; preds = %B48.if.prol.i230.i.i
  %248 = sub i64 %83, %lsr.iv.next581.i.i
  %249 = add i64 %lsr.iv.next581.i.i, %.20.i226.i.i
  br label %B48.if.prol.loopexit.i240.i.i

B48.if.prol.loopexit.i240.i.i:                    ; preds = %B48.if.prol.loopexit.loopexit.i239.i.i, %B48.if.preheader.i225.i.i
  %.1025458.unr.i241.i.i = phi i64 [ %.58.i223.i.i, %B48.if.preheader.i225.i.i ], [ %248, %B48.if.prol.loopexit.loopexit.i239.i.i ]
  %.1095557.unr.i242.i.i = phi i64 [ %.20.i226.i.i, %B48.if.preheader.i225.i.i ], [ %249, %B48.if.prol.loopexit.loopexit.i239.i.i ]
  br i1 %101, label %B8963.endif.endif.endif.endif.i.i, label %B48.if.preheader1.i243.i.i

B48.if.preheader1.i243.i.i:                       ; preds = %B48.if.prol.loopexit.i240.i.i
  %250 = add i64 %.1025458.unr.i241.i.i, 4
  %251 = inttoptr i64 %.3860.i.i to ptr
  %252 = shl i64 %.1095557.unr.i242.i.i, 3
  %scevgep114.i.i = getelementptr i8, ptr %251, i64 %252
  br label %B48.if.i244.i.i

B48.if.i244.i.i:                                  ; preds = %B48.if.i244.i.i, %B48.if.preheader1.i243.i.i
  %lsr.iv115.i.i = phi ptr [ %scevgep116.i.i76, %B48.if.i244.i.i ], [ %scevgep114.i.i, %B48.if.preheader1.i243.i.i ]
  %lsr.iv.i245.i.i = phi i64 [ %lsr.iv.next.i262.i.i, %B48.if.i244.i.i ], [ %250, %B48.if.preheader1.i243.i.i ]
  %.1095557.i246.i.i = phi i64 [ %260, %B48.if.i244.i.i ], [ %.1095557.unr.i242.i.i, %B48.if.preheader1.i243.i.i ]
  %.154.i247.i.i = icmp slt i64 %.1095557.i246.i.i, 0
  %253 = select i1 %.154.i247.i.i, i64 %75, i64 0
  %scevgep120.i.i = getelementptr i8, ptr %lsr.iv115.i.i, i64 %253
  store double 0.000000e+00, ptr %scevgep120.i.i, align 8, !noalias !155
  %254 = add i64 %.1095557.i246.i.i, 1
  %.154.1.i250.i.i = icmp slt i64 %254, 0
  %255 = select i1 %.154.1.i250.i.i, i64 %86, i64 8
  %scevgep119.i.i75 = getelementptr i8, ptr %lsr.iv115.i.i, i64 %255
  store double 0.000000e+00, ptr %scevgep119.i.i75, align 8, !noalias !155
  %256 = add i64 %.1095557.i246.i.i, 2
  %.154.2.i254.i.i = icmp slt i64 %256, 0
  %257 = select i1 %.154.2.i254.i.i, i64 %87, i64 16
  %scevgep118.i.i = getelementptr i8, ptr %lsr.iv115.i.i, i64 %257
  store double 0.000000e+00, ptr %scevgep118.i.i, align 8, !noalias !155
  %258 = add i64 %.1095557.i246.i.i, 3
  %.154.3.i258.i.i = icmp slt i64 %258, 0
  %259 = select i1 %.154.3.i258.i.i, i64 %88, i64 24
  %scevgep117.i.i = getelementptr i8, ptr %lsr.iv115.i.i, i64 %259
  store double 0.000000e+00, ptr %scevgep117.i.i, align 8, !noalias !155
  %lsr.iv.next.i262.i.i = add i64 %lsr.iv.i245.i.i, -4
  %scevgep116.i.i76 = getelementptr i8, ptr %lsr.iv115.i.i, i64 32
  %.103.3.i263.i.i = icmp sgt i64 %lsr.iv.next.i262.i.i, 4
  %260 = add i64 %.1095557.i246.i.i, 4
  br i1 %.103.3.i263.i.i, label %B48.if.i244.i.i, label %B8963.endif.endif.endif.endif.i.i

B8963.endif.endif.endif.endif.i.i:                ; preds = %B48.if.i244.i.i, %B48.if.prol.loopexit.i240.i.i, %B8963.endif.endif.endif.i.i
  %exitcond.not.i4.i = icmp eq i64 %.3527.i.i, 6
  br i1 %exitcond.not.i4.i, label %_ZN17bnserve_surrogate8tangents4_row11_write_modeB4v413B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi3EEd692Row_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20int64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_203_29_2c_20UniTuple_28array_28float64_2c_201d_2c_20C_29_20x_202_29_2c_20UniTuple_28array_28int64_2c_201d_2c_20C_29_20x_202_29_2c_20UniTuple_28array_28float64_2c_201d_2c_20C_29_20x_202_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29.exit.i, label %B1592.if.i.i

_ZN17bnserve_surrogate8tangents4_row11_write_modeB4v413B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi3EEd692Row_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20int64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_203_29_2c_20UniTuple_28array_28float64_2c_201d_2c_20C_29_20x_202_29_2c_20UniTuple_28array_28int64_2c_201d_2c_20C_29_20x_202_29_2c_20UniTuple_28array_28float64_2c_201d_2c_20C_29_20x_202_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29.exit.i: ; preds = %B8963.endif.endif.endif.endif.i.i, %B1154.endif.endif.endif.endif.i.i
  %lsr.iv.next194.i = add i64 %lsr.iv193.i, -1
  %lsr.iv.next196.i = add i64 %lsr.iv195.i, 72
  %.2509.i = icmp sgt i64 %lsr.iv.next194.i, 1
  br i1 %.2509.i, label %B1350.if.i, label %B920.loopexit.i

_ZN17bnserve_surrogate8tangents4_row6_orderB4v560B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxxd692Row_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20int64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_203_29_2c_20UniTuple_28array_28float64_2c_201d_2c_20C_29_20x_202_29_2c_20UniTuple_28array_28int64_2c_201d_2c_20C_29_20x_202_29_2c_20UniTuple_28array_28float64_2c_201d_2c_20C_29_20x_202_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29.exit: ; preds = %B920.loopexit.i, %B874.i56, %for.end.1.endif.if.i51
  %excinfo.7.1 = phi ptr [ %.1188.i52, %for.end.1.endif.if.i51 ], [ %excinfo.7.0, %B874.i56 ], [ %excinfo.7.0, %B920.loopexit.i ]
  %common.ret.op.i53 = phi i32 [ 1, %for.end.1.endif.if.i51 ], [ 0, %B874.i56 ], [ 0, %B920.loopexit.i ]
  call void @llvm.lifetime.end.p0(ptr nonnull %.1098.i7)
  call void @llvm.lifetime.end.p0(ptr nonnull %.1138.i9)
  call void @llvm.lifetime.end.p0(ptr nonnull %excinfo.6.i10)
  call void @llvm.lifetime.end.p0(ptr nonnull %.1222.i11)
  call void @llvm.lifetime.end.p0(ptr nonnull %.1994.i13)
  call void @llvm.lifetime.end.p0(ptr nonnull %.2352.i)
  br i1 %cond.i50, label %B652.endif, label %B652.if, !prof !20

common.ret:                                       ; preds = %B652.if, %B150.endif, %B150.if, %B0.if, %B744, %B740
  %common.ret.op = phi i32 [ 0, %B740 ], [ 0, %B744 ], [ 1, %B0.if ], [ 0, %B150.endif ], [ %common.ret.op.i4, %B150.if ], [ %common.ret.op.i53, %B652.if ]
  ret i32 %common.ret.op

B740:                                             ; preds = %B652.endif
  store ptr null, ptr %retptr, align 8
  br label %common.ret

B744:                                             ; preds = %B204
  store ptr null, ptr %retptr, align 8
  br label %common.ret

B0.if:                                            ; preds = %_ZN17bnserve_surrogate8tangents8_carrier15prepare_splinesB4v144B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE692Row_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20int64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_203_29_2c_20UniTuple_28array_28float64_2c_201d_2c_20C_29_20x_202_29_2c_20UniTuple_28array_28int64_2c_201d_2c_20C_29_20x_202_29_2c_20UniTuple_28array_28float64_2c_201d_2c_20C_29_20x_202_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29.exit
  store ptr %excinfo.1.0, ptr %excinfo, align 8
  br label %common.ret

B0.endif:                                         ; preds = %_ZN17bnserve_surrogate8tangents8_carrier15prepare_splinesB4v144B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE692Row_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20int64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_203_29_2c_20UniTuple_28array_28float64_2c_201d_2c_20C_29_20x_202_29_2c_20UniTuple_28array_28int64_2c_201d_2c_20C_29_20x_202_29_2c_20UniTuple_28array_28float64_2c_201d_2c_20C_29_20x_202_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29.exit
  %.353 = load double, ptr %.1653.i, align 8
  %.357 = fmul contract double %.353, 0x3ED4A8B4A9ED04E3
  %.393 = getelementptr i8, ptr %arg.state.0.4, i64 168
  %.394 = load i64, ptr %.393, align 8
  %.398 = icmp eq i64 %.394, 0
  br i1 %.398, label %B150, label %B204

B150.if:                                          ; preds = %_ZN17bnserve_surrogate8tangents4_row6_orderB4v187B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx23Literal_5bint_5d_282_2923Literal_5bint_5d_280_2923Literal_5bint_5d_280_29d692Row_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20int64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_203_29_2c_20UniTuple_28array_28float64_2c_201d_2c_20C_29_20x_202_29_2c_20UniTuple_28array_28int64_2c_201d_2c_20C_29_20x_202_29_2c_20UniTuple_28array_28float64_2c_201d_2c_20C_29_20x_202_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29.exit
  store ptr %excinfo.2.0, ptr %excinfo, align 8
  br label %common.ret

B150.endif:                                       ; preds = %_ZN17bnserve_surrogate8tangents4_row6_orderB4v187B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx23Literal_5bint_5d_282_2923Literal_5bint_5d_280_2923Literal_5bint_5d_280_29d692Row_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20int64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_203_29_2c_20UniTuple_28array_28float64_2c_201d_2c_20C_29_20x_202_29_2c_20UniTuple_28array_28int64_2c_201d_2c_20C_29_20x_202_29_2c_20UniTuple_28array_28float64_2c_201d_2c_20C_29_20x_202_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29.exit
  store ptr null, ptr %retptr, align 8
  br label %common.ret

B652.if:                                          ; preds = %_ZN17bnserve_surrogate8tangents4_row6_orderB4v560B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxxd692Row_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20int64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_203_29_2c_20UniTuple_28array_28float64_2c_201d_2c_20C_29_20x_202_29_2c_20UniTuple_28array_28int64_2c_201d_2c_20C_29_20x_202_29_2c_20UniTuple_28array_28float64_2c_201d_2c_20C_29_20x_202_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29.exit
  store ptr %excinfo.7.1, ptr %excinfo, align 8
  br label %common.ret

B652.endif:                                       ; preds = %_ZN17bnserve_surrogate8tangents4_row6_orderB4v560B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxxd692Row_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20int64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_203_29_2c_20UniTuple_28array_28float64_2c_201d_2c_20C_29_20x_202_29_2c_20UniTuple_28array_28int64_2c_201d_2c_20C_29_20x_202_29_2c_20UniTuple_28array_28float64_2c_201d_2c_20C_29_20x_202_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29.exit
  %.1259 = load i64, ptr %.582, align 8
  %.1260 = icmp slt i64 %last.3.2, %.1259
  br i1 %.1260, label %B336, label %B740
}

; Function Attrs: mustprogress nocallback nocreateundeforpoison nofree nosync nounwind speculatable willreturn memory(none)
declare double @llvm.log.f64(double) #2

; Function Attrs: nofree noinline norecurse nosync nounwind memory(argmem: readwrite)
define internal fastcc void @inner_8(ptr noalias nonnull writeonly captures(none) %retptr, ptr readonly captures(none) %arg.log_f.4, i64 %arg.points, ptr readonly captures(none) %arg.table.4, i64 %arg.bins, double %arg.density, double %arg.bound) unnamed_addr #3 {
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

; Function Attrs: nofree norecurse nosync nounwind memory(argmem: readwrite)
define internal fastcc void @inner_10(ptr noalias nonnull writeonly captures(none) %retptr, ptr readonly captures(none) %arg.state.1.4, ptr readonly captures(none) %arg.state.2.4, ptr readonly captures(none) %arg.state.6.4, i64 range(i64 8, 1) %arg.state.7.0, i64 range(i64 8, 1) %arg.state.7.1, ptr readonly captures(none) %arg.state.8.0.4, ptr readonly captures(none) %arg.state.8.1.4, ptr readonly captures(none) %arg.state.11.4, ptr captures(none) initializes((0, 384)) %arg.state.13.4, ptr captures(none) %arg.state.14.4, ptr captures(none) %arg.state.15.4, double %arg.mass) unnamed_addr #4 {
entry:
  %.283 = getelementptr i8, ptr %arg.state.1.4, i64 128
  %.284 = load i64, ptr %.283, align 8
  %.300 = getelementptr inbounds double, ptr %arg.state.2.4, i64 %.284
  %.380 = getelementptr i8, ptr %.300, i64 8
  %.381 = load double, ptr %.380, align 8
  %.481 = getelementptr inbounds nuw i8, ptr %arg.state.13.4, i64 64
  %.561 = getelementptr inbounds nuw i8, ptr %arg.state.13.4, i64 128
  %.623 = getelementptr inbounds nuw i8, ptr %arg.state.13.4, i64 192
  %.841 = fdiv contract double %.381, %arg.mass
  %.842 = insertelement <8 x double> poison, double %.841, i64 0
  %.843 = shufflevector <8 x double> %.842, <8 x double> poison, <8 x i32> zeroinitializer
  store <8 x double> %.843, ptr %arg.state.13.4, align 8
  %.861.le = tail call contract double @llvm.log.f64(double %.841)
  %.866 = insertelement <8 x double> poison, double %.861.le, i64 0
  %.867 = shufflevector <8 x double> %.866, <8 x double> poison, <8 x i32> zeroinitializer
  store <8 x double> %.867, ptr %.481, align 8
  %.878 = tail call contract double @llvm.pow.f64(double %.841, double 0x3FD5555555555555)
  %.879 = insertelement <8 x double> poison, double %.878, i64 0
  %.880 = shufflevector <8 x double> %.879, <8 x double> poison, <8 x i32> zeroinitializer
  store <8 x double> %.880, ptr %.561, align 8
  %.891 = tail call contract double @llvm.pow.f64(double %.841, double 0xBFFAAAAAAAAAAAAB)
  %.892 = insertelement <8 x double> poison, double %.891, i64 0
  %.893 = shufflevector <8 x double> %.892, <8 x double> poison, <8 x i32> zeroinitializer
  store <8 x double> %.893, ptr %.623, align 8
  %.1246 = shl nsw i64 %arg.state.7.0, 2
  %.1397 = shl nsw i64 %arg.state.7.1, 2
  %.1786.le = tail call contract double @llvm.log.f64(double %.381)
  %.idx = shl i64 %arg.state.7.0, 4
  %.idx2690 = mul i64 %arg.state.7.0, 24
  %.idx60 = shl i64 %arg.state.7.1, 4
  %.idx61 = mul i64 %arg.state.7.1, 24
  %scevgep416 = getelementptr i8, ptr %arg.state.11.4, i64 152
  %sunkaddr35 = getelementptr i8, ptr %arg.state.15.4, i64 216
  %sunkaddr9 = getelementptr i8, ptr %arg.state.1.4, i64 56
  %sunkaddr10 = getelementptr i8, ptr %arg.state.1.4, i64 112
  %sunkaddr11 = getelementptr i8, ptr %arg.state.1.4, i64 64
  %sunkaddr12 = getelementptr i8, ptr %arg.state.1.4, i64 120
  %sunkaddr13 = getelementptr inbounds nuw i8, ptr %arg.state.13.4, i64 256
  %sunkaddr17 = getelementptr inbounds nuw i8, ptr %arg.state.13.4, i64 320
  %sunkaddr38 = getelementptr i8, ptr %arg.state.15.4, i64 248
  %sunkaddr39 = getelementptr i8, ptr %arg.state.15.4, i64 256
  %sunkaddr40 = getelementptr i8, ptr %arg.state.15.4, i64 264
  %sunkaddr44 = getelementptr inbounds nuw i8, ptr %arg.state.15.4, i64 64
  %sunkaddr45 = getelementptr i8, ptr %arg.state.15.4, i64 72
  %sunkaddr46 = getelementptr i8, ptr %arg.state.15.4, i64 80
  %sunkaddr47 = getelementptr i8, ptr %arg.state.15.4, i64 88
  %sunkaddr48 = getelementptr i8, ptr %arg.state.15.4, i64 96
  %sunkaddr49 = getelementptr i8, ptr %arg.state.15.4, i64 104
  %sunkaddr50 = getelementptr i8, ptr %arg.state.15.4, i64 112
  %sunkaddr51 = getelementptr i8, ptr %arg.state.15.4, i64 120
  %sunkaddr52 = getelementptr i8, ptr %arg.state.15.4, i64 128
  %sunkaddr53 = getelementptr i8, ptr %arg.state.15.4, i64 136
  %sunkaddr54 = getelementptr i8, ptr %arg.state.15.4, i64 144
  %sunkaddr55 = getelementptr i8, ptr %arg.state.15.4, i64 152
  %sunkaddr56 = getelementptr i8, ptr %arg.state.15.4, i64 160
  %sunkaddr57 = getelementptr i8, ptr %arg.state.15.4, i64 168
  %sunkaddr58 = getelementptr i8, ptr %arg.state.15.4, i64 176
  %sunkaddr59 = getelementptr i8, ptr %arg.state.15.4, i64 184
  %sunkaddr60 = getelementptr inbounds nuw i8, ptr %arg.state.15.4, i64 192
  %sunkaddr61 = getelementptr i8, ptr %arg.state.15.4, i64 200
  %sunkaddr62 = getelementptr i8, ptr %arg.state.15.4, i64 208
  %sunkaddr63 = getelementptr i8, ptr %arg.state.15.4, i64 224
  %sunkaddr64 = getelementptr i8, ptr %arg.state.15.4, i64 232
  %sunkaddr65 = getelementptr i8, ptr %arg.state.15.4, i64 240
  %sunkaddr7 = getelementptr i8, ptr %arg.state.11.4, i64 272
  br label %B894.if

B5201:                                            ; preds = %B894.if
  %sunkaddr = getelementptr i8, ptr %arg.state.11.4, i64 %.1708.idx
  %sunkaddr421 = getelementptr i8, ptr %sunkaddr, i64 272
  %.2218 = load double, ptr %sunkaddr421, align 8
  %.2456 = load double, ptr %sunkaddr7, align 8
  %.2463 = fdiv contract double %.2218, %.2456
  %.2464 = fadd contract double %.2112, %.2463
  store double %.2464, ptr %5, align 8
  br label %for.end.2

B5990:                                            ; preds = %_ZN17bnserve_surrogate8tangents7_series17fill_slope_seriesB4v257B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedEdd5ArrayIdLi1E1C7mutable7alignedE.exit
  %.3910 = getelementptr i8, ptr %arg.state.6.4, i64 56
  %.3911 = load double, ptr %.3910, align 8
  %.3918 = fdiv contract double 1.000000e+00, %.3911
  %.3919 = fmul contract double %.3918, 0xBFF5555555555556
  %.3950 = getelementptr i8, ptr %arg.state.14.4, i64 144
  store double %.3919, ptr %.3950, align 8
  %.3983 = getelementptr i8, ptr %arg.state.14.4, i64 152
  %.3984 = load double, ptr %.3983, align 8
  %.3989 = fdiv contract double %.3984, %.381
  %.4023 = getelementptr i8, ptr %arg.state.14.4, i64 160
  store double %.3989, ptr %.4023, align 8
  store ptr null, ptr %retptr, align 8
  ret void

B894.if:                                          ; preds = %_ZN17bnserve_surrogate8tangents7_series17fill_slope_seriesB4v257B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedEdd5ArrayIdLi1E1C7mutable7alignedE.exit, %entry
  %lsr.iv = phi ptr [ %scevgep416, %entry ], [ %scevgep417, %_ZN17bnserve_surrogate8tangents7_series17fill_slope_seriesB4v257B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedEdd5ArrayIdLi1E1C7mutable7alignedE.exit ]
  %.1045.0 = phi i64 [ 0, %entry ], [ %.1114, %_ZN17bnserve_surrogate8tangents7_series17fill_slope_seriesB4v257B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedEdd5ArrayIdLi1E1C7mutable7alignedE.exit ]
  %.1114 = add nuw nsw i64 %.1045.0, 1
  %.1247 = mul nsw i64 %.1246, %.1045.0
  %.1261 = getelementptr inbounds double, ptr %arg.state.8.0.4, i64 %.1247
  %.1398 = mul nsw i64 %.1397, %.1045.0
  %.1412 = getelementptr inbounds double, ptr %arg.state.8.1.4, i64 %.1398
  %.1708.idx = mul nuw nsw i64 %.1045.0, 288
  %.1894 = load i64, ptr %sunkaddr9, align 8
  %.1898 = add nsw i64 %.1894, -2
  %.1998 = load i64, ptr %sunkaddr10, align 8
  %.2002 = add nsw i64 %.1998, %.1898
  %0 = lshr i64 %.2002, 33
  %.2016 = and i64 %0, 1073741824
  %1 = getelementptr double, ptr %arg.state.2.4, i64 %.2002
  %.2030 = getelementptr double, ptr %1, i64 %.2016
  %.2031 = load double, ptr %.2030, align 8
  %.2035 = fsub contract double %.1786.le, %.2031
  %.2045 = getelementptr inbounds double, ptr %.1261, i64 %.1898
  %.2046 = load double, ptr %.2045, align 8
  %2 = getelementptr double, ptr %.1261, i64 %arg.state.7.0
  %.2054 = getelementptr double, ptr %2, i64 %.1898
  %.2055 = load double, ptr %.2054, align 8
  %3 = getelementptr i8, ptr %.1261, i64 %.idx
  %.2070 = getelementptr double, ptr %3, i64 %.1898
  %.2071 = load double, ptr %.2070, align 8
  %4 = getelementptr i8, ptr %.1261, i64 %.idx2690
  %.2080 = getelementptr double, ptr %4, i64 %.1898
  %.2081 = load double, ptr %.2080, align 8
  %.2094 = fmul contract double %.2035, %.2081
  %.2098 = fadd contract double %.2071, %.2094
  %.2102 = fmul contract double %.2035, %.2098
  %.2104 = fadd contract double %.2055, %.2102
  %.2108 = fmul contract double %.2035, %.2104
  %.2112 = fadd contract double %.2046, %.2108
  %.idx59 = mul nuw nsw i64 %.1045.0, 24
  %5 = getelementptr i8, ptr %arg.state.14.4, i64 %.idx59
  store double %.2112, ptr %5, align 8
  %.2155.not = icmp eq i64 %.1045.0, 0
  br i1 %.2155.not, label %for.end.2, label %B5201

for.end.2:                                        ; preds = %B894.if, %B5201
  %.2611 = load i64, ptr %sunkaddr11, align 8
  %.2615 = add nsw i64 %.2611, -2
  %.2715 = load i64, ptr %sunkaddr12, align 8
  %.2719 = add nsw i64 %.2715, %.2615
  %6 = lshr i64 %.2719, 33
  %.2733 = and i64 %6, 1073741824
  %7 = getelementptr double, ptr %arg.state.2.4, i64 %.2719
  %.2747 = getelementptr double, ptr %7, i64 %.2733
  %.2748 = load double, ptr %.2747, align 8
  %.2752 = fsub contract double %.1786.le, %.2748
  %.2762 = getelementptr inbounds double, ptr %.1412, i64 %.2615
  %.2763 = load double, ptr %.2762, align 8
  %8 = getelementptr double, ptr %.1412, i64 %arg.state.7.1
  %.2771 = getelementptr double, ptr %8, i64 %.2615
  %.2772 = load double, ptr %.2771, align 8
  %9 = getelementptr i8, ptr %.1412, i64 %.idx60
  %.2787 = getelementptr double, ptr %9, i64 %.2615
  %.2788 = load double, ptr %.2787, align 8
  %10 = getelementptr i8, ptr %.1412, i64 %.idx61
  %.2797 = getelementptr double, ptr %10, i64 %.2615
  %.2798 = load double, ptr %.2797, align 8
  %.2811 = fmul contract double %.2752, %.2798
  %.2815 = fadd contract double %.2788, %.2811
  %.2819 = fmul contract double %.2752, %.2815
  %.2821 = fadd contract double %.2772, %.2819
  %.2825 = fmul contract double %.2752, %.2821
  %.2829 = fadd contract double %.2763, %.2825
  %.2839 = insertelement <8 x double> poison, double %.2829, i64 0
  %.2840 = shufflevector <8 x double> %.2839, <8 x double> poison, <8 x i32> zeroinitializer
  store <8 x double> %.2840, ptr %sunkaddr13, align 8
  %sunkaddr429 = getelementptr i8, ptr %arg.state.11.4, i64 %.1708.idx
  %sunkaddr430 = getelementptr i8, ptr %sunkaddr429, i64 64
  %.141.i = load double, ptr %sunkaddr430, align 8, !noalias !158
  %sunkaddr432 = getelementptr i8, ptr %sunkaddr429, i64 72
  %.170.i = load double, ptr %sunkaddr432, align 8, !noalias !158
  %sunkaddr434 = getelementptr i8, ptr %sunkaddr429, i64 80
  %.199.i = load double, ptr %sunkaddr434, align 8, !noalias !158
  %sunkaddr436 = getelementptr i8, ptr %sunkaddr429, i64 88
  %.228.i = load double, ptr %sunkaddr436, align 8, !noalias !158
  %sunkaddr438 = getelementptr i8, ptr %sunkaddr429, i64 96
  %.257.i = load double, ptr %sunkaddr438, align 8, !noalias !158
  %sunkaddr440 = getelementptr i8, ptr %sunkaddr429, i64 104
  %.286.i = load double, ptr %sunkaddr440, align 8, !noalias !158
  %sunkaddr442 = getelementptr i8, ptr %sunkaddr429, i64 112
  %.315.i = load double, ptr %sunkaddr442, align 8, !noalias !158
  %sunkaddr444 = getelementptr i8, ptr %sunkaddr429, i64 120
  %.344.i = load double, ptr %sunkaddr444, align 8, !noalias !158
  %sunkaddr446 = getelementptr i8, ptr %sunkaddr429, i64 128
  %.445.i = load double, ptr %sunkaddr446, align 8, !noalias !158
  %sunkaddr448 = getelementptr i8, ptr %sunkaddr429, i64 136
  %.474.i = load double, ptr %sunkaddr448, align 8, !noalias !158
  %sunkaddr450 = getelementptr i8, ptr %sunkaddr429, i64 144
  %.503.i = load double, ptr %sunkaddr450, align 8, !noalias !158
  %sunkaddr452 = getelementptr i8, ptr %sunkaddr429, i64 152
  %.532.i = load double, ptr %sunkaddr452, align 8, !noalias !158
  %sunkaddr454 = getelementptr i8, ptr %sunkaddr429, i64 160
  %.561.i = load double, ptr %sunkaddr454, align 8, !noalias !158
  %sunkaddr456 = getelementptr i8, ptr %sunkaddr429, i64 168
  %.590.i = load double, ptr %sunkaddr456, align 8, !noalias !158
  %sunkaddr458 = getelementptr i8, ptr %sunkaddr429, i64 176
  %.619.i = load double, ptr %sunkaddr458, align 8, !noalias !158
  %sunkaddr460 = getelementptr i8, ptr %sunkaddr429, i64 184
  %.648.i = load double, ptr %sunkaddr460, align 8, !noalias !158
  %sunkaddr462 = getelementptr i8, ptr %sunkaddr429, i64 192
  %.752.i = load double, ptr %sunkaddr462, align 8, !noalias !158
  %sunkaddr464 = getelementptr i8, ptr %sunkaddr429, i64 200
  %.781.i = load double, ptr %sunkaddr464, align 8, !noalias !158
  %sunkaddr466 = getelementptr i8, ptr %sunkaddr429, i64 208
  %.810.i = load double, ptr %sunkaddr466, align 8, !noalias !158
  %sunkaddr468 = getelementptr i8, ptr %sunkaddr429, i64 216
  %.839.i = load double, ptr %sunkaddr468, align 8, !noalias !158
  %sunkaddr470 = getelementptr i8, ptr %sunkaddr429, i64 224
  %.868.i = load double, ptr %sunkaddr470, align 8, !noalias !158
  %sunkaddr472 = getelementptr i8, ptr %sunkaddr429, i64 232
  %.897.i = load double, ptr %sunkaddr472, align 8, !noalias !158
  %sunkaddr474 = getelementptr i8, ptr %sunkaddr429, i64 240
  %.926.i = load double, ptr %sunkaddr474, align 8, !noalias !158
  %sunkaddr476 = getelementptr i8, ptr %sunkaddr429, i64 248
  %.955.i = load double, ptr %sunkaddr476, align 8, !noalias !158
  %sunkaddr478 = getelementptr i8, ptr %sunkaddr429, i64 256
  %.984.i = load double, ptr %sunkaddr478, align 8, !noalias !158
  %sunkaddr480 = getelementptr i8, ptr %sunkaddr429, i64 264
  %.1013.i = load double, ptr %sunkaddr480, align 8, !noalias !158
  %.1428.i = insertelement <8 x double> poison, double %.955.i, i64 0
  %.1429.i = shufflevector <8 x double> %.1428.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1446.i = insertelement <8 x double> poison, double %.1013.i, i64 0
  %.1447.i = shufflevector <8 x double> %.1446.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1448.i = insertelement <8 x double> poison, double %.984.i, i64 0
  %.1449.i = shufflevector <8 x double> %.1448.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1236.i = load <8 x double>, ptr %.561, align 8, !noalias !158
  %.1246.i = load <8 x double>, ptr %arg.state.13.4, align 8, !noalias !158
  %.1256.i = load <8 x double>, ptr %.481, align 8, !noalias !158
  %.6.i.i = fmul contract <8 x double> %.1236.i, %.1236.i
  %.1364.i = insertelement <8 x double> poison, double %.781.i, i64 0
  %.1365.i = shufflevector <8 x double> %.1364.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1360.i = insertelement <8 x double> poison, double %.839.i, i64 0
  %.1361.i = shufflevector <8 x double> %.1360.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1357.i = insertelement <8 x double> poison, double %.897.i, i64 0
  %.1358.i = shufflevector <8 x double> %.1357.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1353.i = insertelement <8 x double> poison, double %.752.i, i64 0
  %.1354.i = shufflevector <8 x double> %.1353.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1349.i = insertelement <8 x double> poison, double %.810.i, i64 0
  %.1350.i = shufflevector <8 x double> %.1349.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1345.i = insertelement <8 x double> poison, double %.868.i, i64 0
  %.1346.i = shufflevector <8 x double> %.1345.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1342.i = insertelement <8 x double> poison, double %.926.i, i64 0
  %.1343.i = shufflevector <8 x double> %.1342.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1338.i = insertelement <8 x double> poison, double %.170.i, i64 0
  %.1339.i = shufflevector <8 x double> %.1338.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1334.i = insertelement <8 x double> poison, double %.228.i, i64 0
  %.1335.i = shufflevector <8 x double> %.1334.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1330.i = insertelement <8 x double> poison, double %.286.i, i64 0
  %.1331.i = shufflevector <8 x double> %.1330.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1327.i = insertelement <8 x double> poison, double %.344.i, i64 0
  %.1328.i = shufflevector <8 x double> %.1327.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1323.i = insertelement <8 x double> poison, double %.141.i, i64 0
  %.1324.i = shufflevector <8 x double> %.1323.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1319.i = insertelement <8 x double> poison, double %.199.i, i64 0
  %.1320.i = shufflevector <8 x double> %.1319.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1315.i = insertelement <8 x double> poison, double %.257.i, i64 0
  %.1316.i = shufflevector <8 x double> %.1315.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1312.i = insertelement <8 x double> poison, double %.315.i, i64 0
  %.1313.i = shufflevector <8 x double> %.1312.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1308.i = insertelement <8 x double> poison, double %.474.i, i64 0
  %.1309.i = shufflevector <8 x double> %.1308.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1304.i = insertelement <8 x double> poison, double %.532.i, i64 0
  %.1305.i = shufflevector <8 x double> %.1304.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1300.i = insertelement <8 x double> poison, double %.590.i, i64 0
  %.1301.i = shufflevector <8 x double> %.1300.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1297.i = insertelement <8 x double> poison, double %.648.i, i64 0
  %.1298.i = shufflevector <8 x double> %.1297.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1293.i = insertelement <8 x double> poison, double %.445.i, i64 0
  %.1294.i = shufflevector <8 x double> %.1293.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1289.i = insertelement <8 x double> poison, double %.503.i, i64 0
  %.1290.i = shufflevector <8 x double> %.1289.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1285.i = insertelement <8 x double> poison, double %.561.i, i64 0
  %.1286.i = shufflevector <8 x double> %.1285.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1282.i = insertelement <8 x double> poison, double %.619.i, i64 0
  %.1283.i = shufflevector <8 x double> %.1282.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1287.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i, <8 x double> %.1283.i, <8 x double> %.1286.i)
  %.1291.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i, <8 x double> %.1287.i, <8 x double> %.1290.i)
  %.1295.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i, <8 x double> %.1291.i, <8 x double> %.1294.i)
  %.1302.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i, <8 x double> %.1298.i, <8 x double> %.1301.i)
  %.1306.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i, <8 x double> %.1302.i, <8 x double> %.1305.i)
  %.1310.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i, <8 x double> %.1306.i, <8 x double> %.1309.i)
  %.1317.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i, <8 x double> %.1313.i, <8 x double> %.1316.i)
  %.1321.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i, <8 x double> %.1317.i, <8 x double> %.1320.i)
  %.1325.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i, <8 x double> %.1321.i, <8 x double> %.1324.i)
  %.1332.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i, <8 x double> %.1328.i, <8 x double> %.1331.i)
  %.1336.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i, <8 x double> %.1332.i, <8 x double> %.1335.i)
  %.1340.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i, <8 x double> %.1336.i, <8 x double> %.1339.i)
  %.1347.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i, <8 x double> %.1343.i, <8 x double> %.1346.i)
  %.1351.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i, <8 x double> %.1347.i, <8 x double> %.1350.i)
  %.1355.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i, <8 x double> %.1351.i, <8 x double> %.1354.i)
  %.1362.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i, <8 x double> %.1358.i, <8 x double> %.1361.i)
  %.1366.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i, <8 x double> %.1362.i, <8 x double> %.1365.i)
  %.1367.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1236.i, <8 x double> %.1340.i, <8 x double> %.1325.i)
  %.1377.i = load <8 x double>, ptr %.623, align 8, !noalias !158
  %.6.i1.i = fmul contract <8 x double> %.1377.i, %.1367.i
  %.6.i2.i = fmul contract <8 x double> %.1246.i, %.1256.i
  %.1426.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1236.i, <8 x double> %.1366.i, <8 x double> %.1355.i)
  %.1430.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i2.i, <8 x double> %.1429.i, <8 x double> %.1426.i)
  %.1431.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1236.i, <8 x double> %.1310.i, <8 x double> %.1295.i)
  %.1442.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1246.i, <8 x double> %.1431.i, <8 x double> %.2840)
  %.1443.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1256.i, <8 x double> %.1430.i, <8 x double> %.1442.i)
  %.6.i3.i = fadd contract <8 x double> %.6.i1.i, %.1443.i
  %.1450.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1246.i, <8 x double> %.1447.i, <8 x double> %.1449.i)
  %.6.i4.i = fsub contract <8 x double> %.1450.i, %.6.i3.i
  store <8 x double> %.6.i4.i, ptr %sunkaddr17, align 8, !noalias !158
  %.3063 = load double, ptr %sunkaddr17, align 8
  %sunkaddr19 = getelementptr i8, ptr %5, i64 8
  store double %.3063, ptr %sunkaddr19, align 8
  %.3127 = load double, ptr %sunkaddr480, align 8
  br label %B44.if.i

B158.i:                                           ; preds = %B44.if.i
  %.284.i = load double, ptr %scevgep5, align 8, !noalias !161
  %.319.i = fadd contract double %.201.i, %.284.i
  store double %.319.i, ptr %sunkaddr34, align 8, !noalias !161
  %.359.i = fmul contract double %.200.i, %.284.i
  %sunkaddr31 = getelementptr i8, ptr %sunkaddr33, i64 152
  store double %.359.i, ptr %sunkaddr31, align 8, !noalias !161
  br label %B309.i

B309.i:                                           ; preds = %B44.if.i, %B158.i
  %exitcond.not.i = icmp eq i64 %.132.i, 16
  br i1 %exitcond.not.i, label %_ZN17bnserve_surrogate8tangents7_series17fill_slope_seriesB4v257B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedEdd5ArrayIdLi1E1C7mutable7alignedE.exit, label %B44.if.i

B44.if.i:                                         ; preds = %B309.i, %for.end.2
  %.125233235.i = phi i64 [ %.132.i, %B309.i ], [ 0, %for.end.2 ]
  %.132.i = add nuw nsw i64 %.125233235.i, 1
  %11 = shl nuw nsw i64 %.125233235.i, 3
  %scevgep5 = getelementptr i8, ptr %lsr.iv, i64 %11
  %scevgep6 = getelementptr i8, ptr %scevgep5, i64 -88
  %.191.i = load double, ptr %scevgep6, align 8, !noalias !161
  %12 = add nsw i64 %.125233235.i, -5
  %.196.i = sitofp i64 %12 to double
  %.200.i = fdiv contract double %.196.i, 3.000000e+00
  %.201.i = fmul contract double %.191.i, %.200.i
  %sunkaddr33 = getelementptr i8, ptr %arg.state.15.4, i64 %11
  %sunkaddr34 = getelementptr i8, ptr %sunkaddr33, i64 64
  store double %.201.i, ptr %sunkaddr34, align 8, !noalias !161
  %or.cond.i = icmp ult i64 %12, 7
  br i1 %or.cond.i, label %B158.i, label %B309.i

_ZN17bnserve_surrogate8tangents7_series17fill_slope_seriesB4v257B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedEdd5ArrayIdLi1E1C7mutable7alignedE.exit: ; preds = %B309.i
  %.433.i = load double, ptr %sunkaddr35, align 8, !noalias !161
  %.466.i = load double, ptr %sunkaddr476, align 8, !noalias !161
  %.467.i = fmul contract double %.466.i, 2.000000e+00
  %.468.i = fadd contract double %.433.i, %.467.i
  store double %.468.i, ptr %sunkaddr35, align 8, !noalias !161
  %.529.i = load double, ptr %sunkaddr476, align 8, !noalias !161
  store double %.529.i, ptr %sunkaddr38, align 8, !noalias !161
  store double 0.000000e+00, ptr %sunkaddr39, align 8, !noalias !161
  store double %.3127, ptr %sunkaddr40, align 8, !noalias !161
  %.3283 = load i64, ptr %sunkaddr11, align 8
  %.3287 = add nsw i64 %.3283, -2
  %.3387 = load i64, ptr %sunkaddr12, align 8
  %.3391 = add nsw i64 %.3387, %.3287
  %13 = lshr i64 %.3391, 33
  %.3405 = and i64 %13, 1073741824
  %14 = getelementptr double, ptr %arg.state.2.4, i64 %.3391
  %.3419 = getelementptr double, ptr %14, i64 %.3405
  %.3420 = load double, ptr %.3419, align 8
  %.3424 = fsub contract double %.1786.le, %.3420
  %.3443 = getelementptr double, ptr %8, i64 %.3287
  %.3444 = load double, ptr %.3443, align 8
  %.3456 = getelementptr double, ptr %9, i64 %.3287
  %.3457 = load double, ptr %.3456, align 8
  %.3466 = getelementptr double, ptr %10, i64 %.3287
  %.3467 = load double, ptr %.3466, align 8
  %.3479 = fmul contract double %.3457, 2.000000e+00
  %.3483 = fmul contract double %.3424, 3.000000e+00
  %.3485 = fmul contract double %.3483, %.3467
  %.3488 = fadd contract double %.3479, %.3485
  %.3490 = fmul contract double %.3424, %.3488
  %.3494 = fadd contract double %.3444, %.3490
  %.3504 = insertelement <8 x double> poison, double %.3494, i64 0
  %.3505 = shufflevector <8 x double> %.3504, <8 x double> poison, <8 x i32> zeroinitializer
  store <8 x double> %.3505, ptr %sunkaddr13, align 8
  %.141.i137 = load double, ptr %sunkaddr44, align 8, !noalias !164
  %.170.i139 = load double, ptr %sunkaddr45, align 8, !noalias !164
  %.199.i141 = load double, ptr %sunkaddr46, align 8, !noalias !164
  %.228.i143 = load double, ptr %sunkaddr47, align 8, !noalias !164
  %.257.i145 = load double, ptr %sunkaddr48, align 8, !noalias !164
  %.286.i147 = load double, ptr %sunkaddr49, align 8, !noalias !164
  %.315.i149 = load double, ptr %sunkaddr50, align 8, !noalias !164
  %.344.i151 = load double, ptr %sunkaddr51, align 8, !noalias !164
  %.445.i153 = load double, ptr %sunkaddr52, align 8, !noalias !164
  %.474.i155 = load double, ptr %sunkaddr53, align 8, !noalias !164
  %.503.i157 = load double, ptr %sunkaddr54, align 8, !noalias !164
  %.532.i159 = load double, ptr %sunkaddr55, align 8, !noalias !164
  %.561.i161 = load double, ptr %sunkaddr56, align 8, !noalias !164
  %.590.i163 = load double, ptr %sunkaddr57, align 8, !noalias !164
  %.619.i165 = load double, ptr %sunkaddr58, align 8, !noalias !164
  %.648.i167 = load double, ptr %sunkaddr59, align 8, !noalias !164
  %.752.i168 = load double, ptr %sunkaddr60, align 8, !noalias !164
  %.781.i170 = load double, ptr %sunkaddr61, align 8, !noalias !164
  %.810.i172 = load double, ptr %sunkaddr62, align 8, !noalias !164
  %.839.i174 = load double, ptr %sunkaddr35, align 8, !noalias !164
  %.868.i176 = load double, ptr %sunkaddr63, align 8, !noalias !164
  %.897.i178 = load double, ptr %sunkaddr64, align 8, !noalias !164
  %.926.i180 = load double, ptr %sunkaddr65, align 8, !noalias !164
  %.955.i182 = load double, ptr %sunkaddr38, align 8, !noalias !164
  %.984.i184 = load double, ptr %sunkaddr39, align 8, !noalias !164
  %.1013.i186 = load double, ptr %sunkaddr40, align 8, !noalias !164
  %.1428.i187 = insertelement <8 x double> poison, double %.955.i182, i64 0
  %.1429.i188 = shufflevector <8 x double> %.1428.i187, <8 x double> poison, <8 x i32> zeroinitializer
  %.1446.i189 = insertelement <8 x double> poison, double %.1013.i186, i64 0
  %.1447.i190 = shufflevector <8 x double> %.1446.i189, <8 x double> poison, <8 x i32> zeroinitializer
  %.1448.i191 = insertelement <8 x double> poison, double %.984.i184, i64 0
  %.1449.i192 = shufflevector <8 x double> %.1448.i191, <8 x double> poison, <8 x i32> zeroinitializer
  %.1236.i193 = load <8 x double>, ptr %.561, align 8, !noalias !164
  %.1246.i194 = load <8 x double>, ptr %arg.state.13.4, align 8, !noalias !164
  %.1256.i195 = load <8 x double>, ptr %.481, align 8, !noalias !164
  %.6.i.i196 = fmul contract <8 x double> %.1236.i193, %.1236.i193
  %.1364.i197 = insertelement <8 x double> poison, double %.781.i170, i64 0
  %.1365.i198 = shufflevector <8 x double> %.1364.i197, <8 x double> poison, <8 x i32> zeroinitializer
  %.1360.i199 = insertelement <8 x double> poison, double %.839.i174, i64 0
  %.1361.i200 = shufflevector <8 x double> %.1360.i199, <8 x double> poison, <8 x i32> zeroinitializer
  %.1357.i201 = insertelement <8 x double> poison, double %.897.i178, i64 0
  %.1358.i202 = shufflevector <8 x double> %.1357.i201, <8 x double> poison, <8 x i32> zeroinitializer
  %.1353.i203 = insertelement <8 x double> poison, double %.752.i168, i64 0
  %.1354.i204 = shufflevector <8 x double> %.1353.i203, <8 x double> poison, <8 x i32> zeroinitializer
  %.1349.i205 = insertelement <8 x double> poison, double %.810.i172, i64 0
  %.1350.i206 = shufflevector <8 x double> %.1349.i205, <8 x double> poison, <8 x i32> zeroinitializer
  %.1345.i207 = insertelement <8 x double> poison, double %.868.i176, i64 0
  %.1346.i208 = shufflevector <8 x double> %.1345.i207, <8 x double> poison, <8 x i32> zeroinitializer
  %.1342.i209 = insertelement <8 x double> poison, double %.926.i180, i64 0
  %.1343.i210 = shufflevector <8 x double> %.1342.i209, <8 x double> poison, <8 x i32> zeroinitializer
  %.1338.i211 = insertelement <8 x double> poison, double %.170.i139, i64 0
  %.1339.i212 = shufflevector <8 x double> %.1338.i211, <8 x double> poison, <8 x i32> zeroinitializer
  %.1334.i213 = insertelement <8 x double> poison, double %.228.i143, i64 0
  %.1335.i214 = shufflevector <8 x double> %.1334.i213, <8 x double> poison, <8 x i32> zeroinitializer
  %.1330.i215 = insertelement <8 x double> poison, double %.286.i147, i64 0
  %.1331.i216 = shufflevector <8 x double> %.1330.i215, <8 x double> poison, <8 x i32> zeroinitializer
  %.1327.i217 = insertelement <8 x double> poison, double %.344.i151, i64 0
  %.1328.i218 = shufflevector <8 x double> %.1327.i217, <8 x double> poison, <8 x i32> zeroinitializer
  %.1323.i219 = insertelement <8 x double> poison, double %.141.i137, i64 0
  %.1324.i220 = shufflevector <8 x double> %.1323.i219, <8 x double> poison, <8 x i32> zeroinitializer
  %.1319.i221 = insertelement <8 x double> poison, double %.199.i141, i64 0
  %.1320.i222 = shufflevector <8 x double> %.1319.i221, <8 x double> poison, <8 x i32> zeroinitializer
  %.1315.i223 = insertelement <8 x double> poison, double %.257.i145, i64 0
  %.1316.i224 = shufflevector <8 x double> %.1315.i223, <8 x double> poison, <8 x i32> zeroinitializer
  %.1312.i225 = insertelement <8 x double> poison, double %.315.i149, i64 0
  %.1313.i226 = shufflevector <8 x double> %.1312.i225, <8 x double> poison, <8 x i32> zeroinitializer
  %.1308.i227 = insertelement <8 x double> poison, double %.474.i155, i64 0
  %.1309.i228 = shufflevector <8 x double> %.1308.i227, <8 x double> poison, <8 x i32> zeroinitializer
  %.1304.i229 = insertelement <8 x double> poison, double %.532.i159, i64 0
  %.1305.i230 = shufflevector <8 x double> %.1304.i229, <8 x double> poison, <8 x i32> zeroinitializer
  %.1300.i231 = insertelement <8 x double> poison, double %.590.i163, i64 0
  %.1301.i232 = shufflevector <8 x double> %.1300.i231, <8 x double> poison, <8 x i32> zeroinitializer
  %.1297.i233 = insertelement <8 x double> poison, double %.648.i167, i64 0
  %.1298.i234 = shufflevector <8 x double> %.1297.i233, <8 x double> poison, <8 x i32> zeroinitializer
  %.1293.i235 = insertelement <8 x double> poison, double %.445.i153, i64 0
  %.1294.i236 = shufflevector <8 x double> %.1293.i235, <8 x double> poison, <8 x i32> zeroinitializer
  %.1289.i237 = insertelement <8 x double> poison, double %.503.i157, i64 0
  %.1290.i238 = shufflevector <8 x double> %.1289.i237, <8 x double> poison, <8 x i32> zeroinitializer
  %.1285.i239 = insertelement <8 x double> poison, double %.561.i161, i64 0
  %.1286.i240 = shufflevector <8 x double> %.1285.i239, <8 x double> poison, <8 x i32> zeroinitializer
  %.1282.i241 = insertelement <8 x double> poison, double %.619.i165, i64 0
  %.1283.i242 = shufflevector <8 x double> %.1282.i241, <8 x double> poison, <8 x i32> zeroinitializer
  %.1287.i243 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i196, <8 x double> %.1283.i242, <8 x double> %.1286.i240)
  %.1291.i244 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i196, <8 x double> %.1287.i243, <8 x double> %.1290.i238)
  %.1295.i245 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i196, <8 x double> %.1291.i244, <8 x double> %.1294.i236)
  %.1302.i246 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i196, <8 x double> %.1298.i234, <8 x double> %.1301.i232)
  %.1306.i247 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i196, <8 x double> %.1302.i246, <8 x double> %.1305.i230)
  %.1310.i248 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i196, <8 x double> %.1306.i247, <8 x double> %.1309.i228)
  %.1317.i249 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i196, <8 x double> %.1313.i226, <8 x double> %.1316.i224)
  %.1321.i250 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i196, <8 x double> %.1317.i249, <8 x double> %.1320.i222)
  %.1325.i251 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i196, <8 x double> %.1321.i250, <8 x double> %.1324.i220)
  %.1332.i252 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i196, <8 x double> %.1328.i218, <8 x double> %.1331.i216)
  %.1336.i253 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i196, <8 x double> %.1332.i252, <8 x double> %.1335.i214)
  %.1340.i254 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i196, <8 x double> %.1336.i253, <8 x double> %.1339.i212)
  %.1347.i255 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i196, <8 x double> %.1343.i210, <8 x double> %.1346.i208)
  %.1351.i256 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i196, <8 x double> %.1347.i255, <8 x double> %.1350.i206)
  %.1355.i257 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i196, <8 x double> %.1351.i256, <8 x double> %.1354.i204)
  %.1362.i258 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i196, <8 x double> %.1358.i202, <8 x double> %.1361.i200)
  %.1366.i259 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i196, <8 x double> %.1362.i258, <8 x double> %.1365.i198)
  %.1367.i260 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1236.i193, <8 x double> %.1340.i254, <8 x double> %.1325.i251)
  %.1377.i261 = load <8 x double>, ptr %.623, align 8, !noalias !164
  %.6.i1.i262 = fmul contract <8 x double> %.1377.i261, %.1367.i260
  %.6.i2.i263 = fmul contract <8 x double> %.1246.i194, %.1256.i195
  %.1426.i264 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1236.i193, <8 x double> %.1366.i259, <8 x double> %.1355.i257)
  %.1430.i265 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i2.i263, <8 x double> %.1429.i188, <8 x double> %.1426.i264)
  %.1431.i266 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1236.i193, <8 x double> %.1310.i248, <8 x double> %.1295.i245)
  %.1442.i268 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1246.i194, <8 x double> %.1431.i266, <8 x double> %.3505)
  %.1443.i269 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1256.i195, <8 x double> %.1430.i265, <8 x double> %.1442.i268)
  %.6.i3.i270 = fadd contract <8 x double> %.6.i1.i262, %.1443.i269
  %.1450.i271 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1246.i194, <8 x double> %.1447.i190, <8 x double> %.1449.i192)
  %.6.i4.i272 = fsub contract <8 x double> %.1450.i271, %.6.i3.i270
  store <8 x double> %.6.i4.i272, ptr %sunkaddr17, align 8, !noalias !164
  %.3728 = load double, ptr %sunkaddr17, align 8
  %.3733 = fdiv contract double %.3728, %.381
  %sunkaddr71 = getelementptr i8, ptr %5, i64 16
  store double %.3733, ptr %sunkaddr71, align 8
  %scevgep417 = getelementptr i8, ptr %lsr.iv, i64 288
  %exitcond.not = icmp eq i64 %.1114, 7
  br i1 %exitcond.not, label %B5990, label %B894.if
}

; Function Attrs: mustprogress nocallback nocreateundeforpoison nofree nosync nounwind speculatable willreturn memory(none)
declare i64 @llvm.smax.i64(i64, i64) #2

; Function Attrs: nofree norecurse nosync nounwind memory(readwrite, inaccessiblemem: none, target_mem0: none, target_mem1: none)
define internal fastcc void @inner_11(ptr noalias nonnull writeonly captures(none) %retptr, ptr readonly captures(none) %arg.state.0.4, ptr readonly captures(none) %arg.state.1.4, ptr readonly captures(none) %arg.state.2.4, ptr readonly captures(none) %arg.state.3.4, i64 %arg.state.5, ptr readonly captures(none) %arg.state.6.4, i64 range(i64 8, 1) %arg.state.7.0, i64 range(i64 8, 1) %arg.state.7.1, i64 range(i64 8, 0) %arg.state.7.2, ptr readonly captures(none) %arg.state.8.0.4, ptr readonly captures(none) %arg.state.8.1.4, ptr readonly captures(none) %arg.state.9.0.4, ptr readonly captures(none) %arg.state.9.1.4, ptr readonly %arg.state.11.4, ptr readonly captures(none) %arg.state.14.4, ptr captures(none) %arg.state.15.4, double %arg.mass, i64 %arg.start, i64 %arg.inside, i64 %arg.places.0, i64 %arg.places.1, i64 %arg.places.2, i64 %arg.places.3, i64 %arg.cells.0, i64 %arg.cells.1, i8 range(i8 0, 2) %arg.values) unnamed_addr #0 {
entry:
  %.5757 = alloca ptr, align 8
  store ptr null, ptr %.5757, align 8
  %.363 = getelementptr i8, ptr %arg.state.0.4, i64 32
  %.364 = load i64, ptr %.363, align 8
  %.430 = getelementptr i8, ptr %arg.state.0.4, i64 24
  %.431 = load i64, ptr %.430, align 8
  %.433 = inttoptr i64 %.431 to ptr
  %.500 = getelementptr double, ptr %.433, i64 %.364
  %.13.i = tail call i64 @llvm.smax.i64(i64 %arg.start, i64 %arg.places.0)
  %.13.i445 = tail call i64 @llvm.smin.i64(i64 %arg.inside, i64 %.13.i)
  %.13.i446 = tail call i64 @llvm.smax.i64(i64 %arg.start, i64 %arg.places.1)
  %.13.i447 = tail call i64 @llvm.smin.i64(i64 %arg.inside, i64 %.13.i446)
  %.1007 = sub i64 %.13.i447, %arg.start
  %.1023 = getelementptr double, ptr %.433, i64 %arg.start
  %.idx = shl i64 %.364, 4
  %0 = getelementptr i8, ptr %.433, i64 %.idx
  %.1089 = getelementptr double, ptr %0, i64 %arg.start
  %.idx5652 = mul i64 %.364, 24
  %.idx5653 = shl i64 %.364, 5
  %1 = getelementptr i8, ptr %.433, i64 %.idx5653
  %.1239 = getelementptr double, ptr %1, i64 %arg.start
  %.1391 = sub nsw i64 %arg.places.2, %arg.start
  %.13.i473 = tail call i64 @llvm.smax.i64(i64 %.1391, i64 0)
  %.13.i474 = tail call i64 @llvm.smin.i64(i64 %.1007, i64 %.13.i473)
  %.1452 = sub i64 %arg.places.3, %arg.start
  %.13.i475 = tail call i64 @llvm.smax.i64(i64 %.1452, i64 0)
  %.13.i476 = tail call i64 @llvm.smin.i64(i64 %.1007, i64 %.13.i475)
  %.1770 = getelementptr i8, ptr %arg.state.1.4, i64 128
  %.1771 = load i64, ptr %.1770, align 8
  %.1971 = getelementptr i8, ptr %arg.state.15.4, i64 1088
  %.2078 = getelementptr inbounds nuw i8, ptr %arg.state.15.4, i64 2176
  %.2173 = getelementptr i8, ptr %arg.state.1.4, i64 72
  %.2174 = load i64, ptr %.2173, align 8
  %.2228 = getelementptr i8, ptr %arg.state.11.4, i64 272
  %.2229 = load double, ptr %.2228, align 8
  %2 = add i64 %.13.i474, 7
  %.199.i1 = lshr i64 %2, 3
  %.176.inv.i = icmp slt i64 %.13.i474, 1
  %.2201037.not1112.i = icmp eq i64 %.199.i1, 0
  %.2201037.not.i = or i1 %.176.inv.i, %.2201037.not1112.i
  br i1 %.2201037.not.i, label %B308.i, label %B60.if.lr.ph.i

B60.if.lr.ph.i:                                   ; preds = %entry
  %3 = add nuw nsw i64 %.199.i1, 7
  %sunkaddr11.i = getelementptr i8, ptr %arg.state.11.4, i64 56
  %sunkaddr12.i = getelementptr i8, ptr %arg.state.11.4, i64 48
  %sunkaddr13.i = getelementptr i8, ptr %arg.state.11.4, i64 40
  %sunkaddr14.i = getelementptr i8, ptr %arg.state.11.4, i64 32
  %sunkaddr15.i = getelementptr i8, ptr %arg.state.11.4, i64 24
  %sunkaddr16.i = getelementptr i8, ptr %arg.state.11.4, i64 16
  %sunkaddr17.i = getelementptr i8, ptr %arg.state.11.4, i64 8
  br label %B60.if.i

B308.i:                                           ; preds = %B60.if.i, %entry
  %.636.i = sub i64 %.13.i476, %.13.i474
  %4 = add i64 %.636.i, 7
  %.658.i = lshr i64 %4, 3
  %.637.inv.i = icmp slt i64 %.636.i, 1
  %.1038.i = fdiv contract double %arg.mass, 1.000000e-02
  %.1044.i = insertelement <8 x double> poison, double %.1038.i, i64 0
  %.1045.i = shufflevector <8 x double> %.1044.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1592.i = insertelement <8 x double> poison, double %.2229, i64 0
  %.1593.i = shufflevector <8 x double> %.1592.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.679437.not446.i = icmp eq i64 %.658.i, 0
  %.679437.not.i = or i1 %.637.inv.i, %.679437.not446.i
  br i1 %.679437.not.i, label %B1050.i, label %B356.lr.ph.i

B356.lr.ph.i:                                     ; preds = %B308.i
  %.1773.i = fmul contract double %arg.mass, 0x3FF921FB54442D18
  %.1777.i = fdiv contract double %.1773.i, 1.000000e-02
  %.692438.i = add i64 %.13.i474, 8
  %.6.i470.i = insertelement <8 x double> poison, double %.1777.i, i64 0
  %.7.i.i14 = shufflevector <8 x double> %.6.i470.i, <8 x double> poison, <8 x i32> zeroinitializer
  %sunkaddr5.i = getelementptr i8, ptr %arg.state.11.4, i64 56
  %sunkaddr6.i = getelementptr i8, ptr %arg.state.11.4, i64 48
  %sunkaddr7.i = getelementptr i8, ptr %arg.state.11.4, i64 40
  %sunkaddr8.i = getelementptr i8, ptr %arg.state.11.4, i64 32
  %sunkaddr9.i = getelementptr i8, ptr %arg.state.11.4, i64 24
  %sunkaddr10.i = getelementptr i8, ptr %arg.state.11.4, i64 16
  %sunkaddr.i = getelementptr i8, ptr %arg.state.11.4, i64 8
  br label %B356.i

B356.i:                                           ; preds = %B356.i, %B356.lr.ph.i
  %lsr.iv487.i = phi i64 [ %.658.i, %B356.lr.ph.i ], [ %lsr.iv.next488.i, %B356.i ]
  %.669.sroa.0.0445.i = phi i64 [ %.13.i474, %B356.lr.ph.i ], [ %.669.sroa.0.0.i, %B356.i ]
  %.6851073443.i = phi i64 [ %.692438.i, %B356.lr.ph.i ], [ %.6851073.i, %B356.i ]
  %.724.i = getelementptr inbounds double, ptr %.1239, i64 %.669.sroa.0.0445.i
  %.726.i = load <8 x double>, ptr %.724.i, align 8, !noalias !167
  %.735.i = getelementptr inbounds double, ptr %.1089, i64 %.669.sroa.0.0445.i
  %.737.i = load <8 x double>, ptr %.735.i, align 8, !noalias !167
  %.770.i15 = load double, ptr %sunkaddr5.i, align 8, !noalias !167
  %.771.i = insertelement <8 x double> poison, double %.770.i15, i64 0
  %.772.i = shufflevector <8 x double> %.771.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.801.i = load double, ptr %sunkaddr6.i, align 8, !noalias !167
  %.802.i = insertelement <8 x double> poison, double %.801.i, i64 0
  %.803.i = shufflevector <8 x double> %.802.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.804.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.737.i, <8 x double> %.772.i, <8 x double> %.803.i)
  %.833.i = load double, ptr %sunkaddr7.i, align 8, !noalias !167
  %.834.i = insertelement <8 x double> poison, double %.833.i, i64 0
  %.835.i = shufflevector <8 x double> %.834.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.836.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.737.i, <8 x double> %.804.i, <8 x double> %.835.i)
  %.865.i = load double, ptr %sunkaddr8.i, align 8, !noalias !167
  %.866.i = insertelement <8 x double> poison, double %.865.i, i64 0
  %.867.i = shufflevector <8 x double> %.866.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.868.i16 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.737.i, <8 x double> %.836.i, <8 x double> %.867.i)
  %.897.i17 = load double, ptr %sunkaddr9.i, align 8, !noalias !167
  %.898.i = insertelement <8 x double> poison, double %.897.i17, i64 0
  %.899.i = shufflevector <8 x double> %.898.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.900.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.737.i, <8 x double> %.868.i16, <8 x double> %.899.i)
  %.929.i = load double, ptr %sunkaddr10.i, align 8, !noalias !167
  %.930.i = insertelement <8 x double> poison, double %.929.i, i64 0
  %.931.i = shufflevector <8 x double> %.930.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.932.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.737.i, <8 x double> %.900.i, <8 x double> %.931.i)
  %.961.i = load double, ptr %sunkaddr.i, align 8, !noalias !167
  %.962.i = insertelement <8 x double> poison, double %.961.i, i64 0
  %.963.i = shufflevector <8 x double> %.962.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.964.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.737.i, <8 x double> %.932.i, <8 x double> %.963.i)
  %.993.i = load double, ptr %arg.state.11.4, align 8, !noalias !167
  %.997.i = insertelement <8 x double> poison, double %.993.i, i64 0
  %.998.i = shufflevector <8 x double> %.997.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.999.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.737.i, <8 x double> %.964.i, <8 x double> %.998.i)
  %.6.i.i18 = fmul contract <8 x double> %.726.i, %.999.i
  %.1031.i = getelementptr inbounds double, ptr %.1023, i64 %.669.sroa.0.0445.i
  %.1033.i = load <8 x double>, ptr %.1031.i, align 8, !noalias !167
  %.1048.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1033.i, <8 x double> %.1045.i, <8 x double> splat (double -1.000000e+00))
  %.8.i.i.i19 = fmul contract <8 x double> %.1048.i, splat (double 0x400921FB54442D18)
  %.36.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i.i.i19, <8 x double> splat (double 0x3FE45F306DC9C883), <8 x double> splat (double 0x4338000000000000))
  %.8.i1.i.i = fadd contract <8 x double> %.36.i.i, splat (double 0xC338000000000000)
  %.77.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i1.i.i, <8 x double> splat (double 0xBFF921FB54442D18), <8 x double> %.8.i.i.i19)
  %.94.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i1.i.i, <8 x double> splat (double 0xBC91A62633145C07), <8 x double> %.77.i.i)
  %.6.i.i.i20 = fmul contract <8 x double> %.94.i.i, %.94.i.i
  %.6.i2.i.i = fmul contract <8 x double> %.94.i.i, %.6.i.i.i20
  %.123.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i.i20, <8 x double> splat (double 0xBD6AE7F3E733B81F), <8 x double> splat (double 0x3DE6124613A86D09))
  %.126.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i.i20, <8 x double> %.123.i.i, <8 x double> splat (double 0xBE5AE64567F544E4))
  %.129.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i.i20, <8 x double> %.126.i.i, <8 x double> splat (double 0x3EC71DE3A556C734))
  %.132.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i.i20, <8 x double> %.129.i.i, <8 x double> splat (double 0xBF2A01A01A01A01A))
  %.135.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i.i20, <8 x double> %.132.i.i, <8 x double> splat (double 0x3F81111111111111))
  %.138.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i.i20, <8 x double> %.135.i.i, <8 x double> splat (double 0xBFC5555555555555))
  %.163.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i2.i.i, <8 x double> %.138.i.i, <8 x double> %.94.i.i)
  %.168.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i.i20, <8 x double> splat (double 0x3D2AE7F3E733B81F), <8 x double> splat (double 0xBDA93974A8C07C9D))
  %.171.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i.i20, <8 x double> %.168.i.i, <8 x double> splat (double 0x3E21EED8EFF8D898))
  %.174.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i.i20, <8 x double> %.171.i.i, <8 x double> splat (double 0xBE927E4FB7789F5C))
  %.177.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i.i20, <8 x double> %.174.i.i, <8 x double> splat (double 0x3EFA01A01A01A01A))
  %.180.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i.i20, <8 x double> %.177.i.i, <8 x double> splat (double 0xBF56C16C16C16C17))
  %.183.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i.i20, <8 x double> %.180.i.i, <8 x double> splat (double 0x3FA5555555555555))
  %.186.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i.i20, <8 x double> %.183.i.i, <8 x double> splat (double -5.000000e-01))
  %.189.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i.i20, <8 x double> %.186.i.i, <8 x double> splat (double 1.000000e+00))
  %.190.i.i = bitcast <8 x double> %.36.i.i to <8 x i64>
  %.8.i4.i.i = and <8 x i64> %.190.i.i, splat (i64 1)
  %5 = icmp eq <8 x i64> %.8.i4.i.i, zeroinitializer
  %.8.i9.i.i = shl <8 x i64> %.190.i.i, splat (i64 62)
  %.8.i10.i.i = add <8 x i64> %.8.i9.i.i, splat (i64 4611686018427387904)
  %.8.i11.i.i = and <8 x i64> %.8.i10.i.i, splat (i64 -9223372036854775808)
  %.6.i14.v.i.i = select <8 x i1> %5, <8 x double> %.189.i.i, <8 x double> %.163.i.i
  %.6.i14.i.i = bitcast <8 x double> %.6.i14.v.i.i to <8 x i64>
  %.6.i15.i.i = xor <8 x i64> %.8.i11.i.i, %.6.i14.i.i
  %6 = bitcast <8 x i64> %.6.i15.i.i to <8 x double>
  %.526.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %6, <8 x double> splat (double -5.000000e-01), <8 x double> splat (double 5.000000e-01))
  %.8.i456.i = and <8 x i64> %.8.i9.i.i, splat (i64 -9223372036854775808)
  %.6.i460.v.i = select <8 x i1> %5, <8 x double> %.163.i.i, <8 x double> %.189.i.i
  %.6.i460.i = bitcast <8 x double> %.6.i460.v.i to <8 x i64>
  %.6.i461.i = xor <8 x i64> %.8.i456.i, %.6.i460.i
  %7 = bitcast <8 x i64> %.6.i461.i to <8 x double>
  %.6.i464.i = fsub contract <8 x double> %.1593.i, %.6.i.i18
  %.1618.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.526.i.i, <8 x double> %.6.i464.i, <8 x double> %.6.i.i18)
  %.6.i465.i = fdiv contract <8 x double> splat (double 1.000000e+00), %.1618.i
  %.6.i466.i = fsub contract <8 x double> splat (double 1.000000e+00), %.526.i.i
  %.6.i467.i = fmul contract <8 x double> %.726.i, %.6.i466.i
  %.6.i468.i = fmul contract <8 x double> %.6.i467.i, %.6.i465.i
  %.1724.i = getelementptr inbounds double, ptr %arg.state.15.4, i64 %.669.sroa.0.0445.i
  store <8 x double> %.6.i468.i, ptr %.1724.i, align 8, !noalias !167
  %.6.i469.i = fmul contract <8 x double> %.526.i.i, %.6.i465.i
  %.1758.i = getelementptr inbounds double, ptr %.1971, i64 %.669.sroa.0.0445.i
  store <8 x double> %.6.i469.i, ptr %.1758.i, align 8, !noalias !167
  %.1770.i = load <8 x double>, ptr %.1031.i, align 8, !noalias !167
  %.8.i471.i = fmul contract <8 x double> %.7.i.i14, %.1770.i
  %.6.i472.i = fmul contract <8 x double> %.8.i471.i, %7
  %.6.i474.i = fmul contract <8 x double> %.6.i464.i, %.6.i472.i
  %.6.i475.i = fmul contract <8 x double> %.6.i474.i, %.6.i465.i
  %.1908.i = getelementptr inbounds double, ptr %.2078, i64 %.669.sroa.0.0445.i
  store <8 x double> %.6.i475.i, ptr %.1908.i, align 8, !noalias !167
  %.679.i = icmp samesign ugt i64 %lsr.iv487.i, 1
  %.692.i = add i64 %.6851073443.i, 8
  %.6851073.i = select i1 %.679.i, i64 %.692.i, i64 %.6851073443.i
  %.669.sroa.0.0.i = select i1 %.679.i, i64 %.6851073443.i, i64 0
  %lsr.iv.next488.i = add nsw i64 %lsr.iv487.i, -1
  %B356.termcond.i = icmp sgt i64 %lsr.iv487.i, 1
  br i1 %B356.termcond.i, label %B356.i, label %B1050.i

B1050.i:                                          ; preds = %B356.i, %B308.i
  %.1980.i = sub i64 %.1007, %.13.i476
  %8 = add i64 %.1980.i, 7
  %.2002.i = lshr i64 %8, 3
  %.1981.inv.i = icmp slt i64 %.1980.i, 1
  %.20231107.not1113.i = icmp eq i64 %.2002.i, 0
  %.20231107.not.i = or i1 %.1981.inv.i, %.20231107.not1113.i
  br i1 %.20231107.not.i, label %_ZN17bnserve_surrogate8tangents7_points11fill_sharesB4v369B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE8UniTupleIxLi3EEd5ArrayIdLi1E1C7mutable7alignedEd5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit, label %B1094.if.lr.ph.i

B1094.if.lr.ph.i:                                 ; preds = %B1050.i
  %.2077.i = fdiv contract double 1.000000e+00, %.2229
  %.2078.i = insertelement <8 x double> poison, double %.2077.i, i64 0
  %.2079.i = shufflevector <8 x double> %.2078.i, <8 x double> poison, <8 x i32> zeroinitializer
  %9 = and i64 %8, 8
  %lcmp.mod.not.i = icmp eq i64 %9, 0
  br i1 %lcmp.mod.not.i, label %B1094.if.prol.loopexit.i, label %B1094.if.prol.i

B1094.if.prol.i:                                  ; preds = %B1094.if.lr.ph.i
  %.2032.prol.i = add nsw i64 %.2002.i, -1
  %.2036.prol.i = add i64 %.13.i476, 8
  %.2070.prol.i = getelementptr inbounds double, ptr %arg.state.15.4, i64 %.13.i476
  store <8 x double> zeroinitializer, ptr %.2070.prol.i, align 8, !noalias !167
  %.2087.prol.i = getelementptr inbounds double, ptr %.1971, i64 %.13.i476
  store <8 x double> %.2079.i, ptr %.2087.prol.i, align 8, !noalias !167
  %.2099.prol.i = getelementptr inbounds double, ptr %.2078, i64 %.13.i476
  store <8 x double> zeroinitializer, ptr %.2099.prol.i, align 8, !noalias !167
  br label %B1094.if.prol.loopexit.i

B1094.if.prol.loopexit.i:                         ; preds = %B1094.if.prol.i, %B1094.if.lr.ph.i
  %.202211051109.unr.i = phi i64 [ %.2002.i, %B1094.if.lr.ph.i ], [ %.2032.prol.i, %B1094.if.prol.i ]
  %.202911061108.unr.i = phi i64 [ %.13.i476, %B1094.if.lr.ph.i ], [ %.2036.prol.i, %B1094.if.prol.i ]
  %10 = icmp eq i64 %.2002.i, 1
  br i1 %10, label %_ZN17bnserve_surrogate8tangents7_points11fill_sharesB4v369B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE8UniTupleIxLi3EEd5ArrayIdLi1E1C7mutable7alignedEd5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit, label %B1094.if.preheader.i

B1094.if.preheader.i:                             ; preds = %B1094.if.prol.loopexit.i
  %11 = shl i64 %.202911061108.unr.i, 3
  %12 = add i64 %11, 64
  %13 = add nuw nsw i64 %.202211051109.unr.i, 14
  br label %B1094.if.i

B60.if.i:                                         ; preds = %B60.if.i, %B60.if.lr.ph.i
  %lsr.iv3.i2 = phi i64 [ %lsr.iv.next4.i13, %B60.if.i ], [ %3, %B60.if.lr.ph.i ]
  %lsr.iv491.i = phi i64 [ %lsr.iv.next492.i, %B60.if.i ], [ 0, %B60.if.lr.ph.i ]
  %scevgep496.i = getelementptr i8, ptr %.1089, i64 %lsr.iv491.i
  %.270.i = load <8 x double>, ptr %scevgep496.i, align 8, !noalias !167
  %.303.i3 = load double, ptr %sunkaddr11.i, align 8, !noalias !167
  %.304.i4 = insertelement <8 x double> poison, double %.303.i3, i64 0
  %.305.i = shufflevector <8 x double> %.304.i4, <8 x double> poison, <8 x i32> zeroinitializer
  %.334.i5 = load double, ptr %sunkaddr12.i, align 8, !noalias !167
  %.335.i6 = insertelement <8 x double> poison, double %.334.i5, i64 0
  %.336.i = shufflevector <8 x double> %.335.i6, <8 x double> poison, <8 x i32> zeroinitializer
  %.337.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.270.i, <8 x double> %.305.i, <8 x double> %.336.i)
  %.366.i = load double, ptr %sunkaddr13.i, align 8, !noalias !167
  %.367.i = insertelement <8 x double> poison, double %.366.i, i64 0
  %.368.i = shufflevector <8 x double> %.367.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.369.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.270.i, <8 x double> %.337.i, <8 x double> %.368.i)
  %.398.i = load double, ptr %sunkaddr14.i, align 8, !noalias !167
  %.399.i = insertelement <8 x double> poison, double %.398.i, i64 0
  %.400.i = shufflevector <8 x double> %.399.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.401.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.270.i, <8 x double> %.369.i, <8 x double> %.400.i)
  %.430.i7 = load double, ptr %sunkaddr15.i, align 8, !noalias !167
  %.431.i8 = insertelement <8 x double> poison, double %.430.i7, i64 0
  %.432.i = shufflevector <8 x double> %.431.i8, <8 x double> poison, <8 x i32> zeroinitializer
  %.433.i9 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.270.i, <8 x double> %.401.i, <8 x double> %.432.i)
  %.462.i = load double, ptr %sunkaddr16.i, align 8, !noalias !167
  %.463.i = insertelement <8 x double> poison, double %.462.i, i64 0
  %.464.i = shufflevector <8 x double> %.463.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.465.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.270.i, <8 x double> %.433.i9, <8 x double> %.464.i)
  %.494.i = load double, ptr %sunkaddr17.i, align 8, !noalias !167
  %.495.i = insertelement <8 x double> poison, double %.494.i, i64 0
  %.496.i = shufflevector <8 x double> %.495.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.497.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.270.i, <8 x double> %.465.i, <8 x double> %.496.i)
  %.526.i10 = load double, ptr %arg.state.11.4, align 8, !noalias !167
  %.530.i = insertelement <8 x double> poison, double %.526.i10, i64 0
  %.531.i11 = shufflevector <8 x double> %.530.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.532.i12 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.270.i, <8 x double> %.497.i, <8 x double> %.531.i11)
  %.6.i447.i = fdiv contract <8 x double> splat (double 1.000000e+00), %.532.i12
  %scevgep495.i = getelementptr i8, ptr %arg.state.15.4, i64 %lsr.iv491.i
  store <8 x double> %.6.i447.i, ptr %scevgep495.i, align 8, !noalias !167
  %scevgep494.i = getelementptr i8, ptr %.1971, i64 %lsr.iv491.i
  store <8 x double> zeroinitializer, ptr %scevgep494.i, align 8, !noalias !167
  %scevgep493.i = getelementptr i8, ptr %.2078, i64 %lsr.iv491.i
  store <8 x double> zeroinitializer, ptr %scevgep493.i, align 8, !noalias !167
  %lsr.iv.next492.i = add i64 %lsr.iv491.i, 64
  %lsr.iv.next4.i13 = add nsw i64 %lsr.iv3.i2, -1
  %.220.i = icmp sgt i64 %lsr.iv3.i2, 8
  br i1 %.220.i, label %B60.if.i, label %B308.i

B1094.if.i:                                       ; preds = %B1094.if.i, %B1094.if.preheader.i
  %lsr.iv.i = phi i64 [ %lsr.iv.next.i, %B1094.if.i ], [ %13, %B1094.if.preheader.i ]
  %lsr.iv477.i = phi i64 [ %lsr.iv.next478.i, %B1094.if.i ], [ %12, %B1094.if.preheader.i ]
  %scevgep484.i = getelementptr i8, ptr %arg.state.15.4, i64 %lsr.iv477.i
  %scevgep485.i = getelementptr i8, ptr %scevgep484.i, i64 -64
  store <8 x double> zeroinitializer, ptr %scevgep485.i, align 8, !noalias !167
  %scevgep481.i = getelementptr i8, ptr %.1971, i64 %lsr.iv477.i
  %scevgep482.i = getelementptr i8, ptr %scevgep481.i, i64 -64
  store <8 x double> %.2079.i, ptr %scevgep482.i, align 8, !noalias !167
  %scevgep.i = getelementptr i8, ptr %.2078, i64 %lsr.iv477.i
  %scevgep479.i = getelementptr i8, ptr %scevgep.i, i64 -64
  store <8 x double> zeroinitializer, ptr %scevgep479.i, align 8, !noalias !167
  store <8 x double> zeroinitializer, ptr %scevgep484.i, align 8, !noalias !167
  store <8 x double> %.2079.i, ptr %scevgep481.i, align 8, !noalias !167
  store <8 x double> zeroinitializer, ptr %scevgep.i, align 8, !noalias !167
  %lsr.iv.next478.i = add i64 %lsr.iv477.i, 128
  %lsr.iv.next.i = add nsw i64 %lsr.iv.i, -2
  %.2023.1.i = icmp sgt i64 %lsr.iv.i, 16
  br i1 %.2023.1.i, label %B1094.if.i, label %_ZN17bnserve_surrogate8tangents7_points11fill_sharesB4v369B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE8UniTupleIxLi3EEd5ArrayIdLi1E1C7mutable7alignedEd5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit

_ZN17bnserve_surrogate8tangents7_points11fill_sharesB4v369B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE8UniTupleIxLi3EEd5ArrayIdLi1E1C7mutable7alignedEd5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit: ; preds = %B1094.if.i, %B1050.i, %B1094.if.prol.loopexit.i
  %14 = getelementptr i8, ptr %.433, i64 %.idx5652
  %.197.not = icmp eq i8 %arg.values, 0
  %.2320 = getelementptr i8, ptr %arg.state.1.4, i64 112
  %.2321 = load i64, ptr %.2320, align 8
  %.2337 = getelementptr inbounds double, ptr %arg.state.2.4, i64 %.2321
  %.2426 = getelementptr i8, ptr %arg.state.1.4, i64 120
  %.2427 = load i64, ptr %.2426, align 8
  %.2443 = getelementptr inbounds double, ptr %arg.state.2.4, i64 %.2427
  %.2551.le = tail call contract double @llvm.log.f64(double %arg.mass)
  %.2608 = getelementptr i8, ptr %arg.state.6.4, i64 56
  %.2609 = load double, ptr %.2608, align 8
  %.2616 = fdiv contract double 1.000000e+00, %.2609
  %15 = xor i8 %arg.values, 1
  %"$phi1472.2.2.0" = zext nneg i8 %15 to i64
  %.2941 = getelementptr inbounds nuw i8, ptr %arg.state.15.4, i64 7616
  %.3095 = getelementptr inbounds nuw i8, ptr %arg.state.15.4, i64 8704
  %.3624 = sub i64 %.13.i445, %arg.start
  %.3867 = shl nsw i64 %arg.state.7.0, 2
  %.4018 = shl nsw i64 %arg.state.7.1, 2
  %.5060 = getelementptr inbounds nuw i8, ptr %arg.state.15.4, i64 3264
  %.5149 = getelementptr i8, ptr %arg.state.15.4, i64 4352
  %.6618 = sub i64 %arg.inside, %arg.start
  %.2674.1337 = select i1 %.197.not, i64 2, i64 1
  %.2677.1338 = select i1 %.197.not, i64 5, i64 6
  %.784.i = icmp slt i64 %arg.state.7.0, 0
  %.785.i = select i1 %.784.i, i64 %arg.state.7.2, i64 0
  %.idx.i = shl i64 %arg.state.7.0, 4
  %.888.i = add nsw i64 %arg.state.7.1, %arg.state.7.0
  %.903.i = icmp slt i64 %.888.i, 0
  %.904.i = select i1 %.903.i, i64 %arg.state.7.2, i64 0
  %.idx895.i = shl i64 %.888.i, 4
  %.264.i = shl nsw i64 %arg.state.7.0, 1
  %.277.i = mul nsw i64 %arg.state.7.0, 3
  %.idx221.i = mul i64 %arg.state.7.0, 24
  %.idx.i540 = shl i64 %arg.state.7.1, 4
  %.idx221.i541 = mul i64 %arg.state.7.1, 24
  %.99.i = sub i64 0, %.13.i476
  %.107.1.i = and i64 %.99.i, -8
  %.666.i = add i64 %.107.1.i, %.1007
  %.667.i = icmp slt i64 %.666.i, 1
  %.682.i = and i64 %.1007, 7
  %.685.not.i = icmp ne i64 %.682.i, 0
  %.686338.i = lshr i64 %.666.i, 3
  %.687.i = zext i1 %.685.not.i to i64
  %16 = or i64 %.686338.i, %.687.i
  %.709348.not.i = icmp eq i64 %16, 0
  %17 = lshr i64 %.99.i, 3
  %18 = mul i64 %17, -64
  %19 = add i64 %.1007, 7
  %.1167.i672 = lshr i64 %19, 3
  %.1144.inv.i673 = icmp slt i64 %.1007, 1
  %.1189570.not574.i674 = icmp eq i64 %.1167.i672, 0
  %.1189570.not.i675 = or i1 %.1144.inv.i673, %.1189570.not574.i674
  %.99.i421 = sub i64 %.6618, %.1007
  %20 = add i64 %.99.i421, 7
  %.123.i = lshr i64 %20, 3
  %.100.inv.i = icmp slt i64 %.99.i421, 1
  %.14491.not95.i = icmp eq i64 %.123.i, 0
  %.14491.not.i = or i1 %.100.inv.i, %.14491.not95.i
  %.208.i = insertelement <8 x double> poison, double %arg.mass, i64 0
  %.209.i = shufflevector <8 x double> %.208.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.neg.i = add i64 %.1007, 1
  %.130.prol.i = add nsw i64 %.99.i421, -1
  %.176.prol.i = icmp slt i64 %.1007, 0
  %21 = getelementptr double, ptr %14, i64 %.13.i447
  %.239.prol.i = select i1 %.176.prol.i, i64 136, i64 0
  %brmerge = select i1 %.667.i, i1 true, i1 %.709348.not.i
  %22 = mul i64 %arg.start, -8
  %23 = shl i64 %.13.i447, 3
  %sunkaddr1279 = select i1 %.176.prol.i, i64 8589934592, i64 0
  %24 = shl i64 %arg.start, 3
  %scevgep66 = getelementptr i8, ptr %14, i64 %24
  %25 = trunc nuw i64 %17 to i61
  %26 = sub i61 0, %25
  %27 = zext i61 %26 to i64
  %28 = add nuw nsw i64 %27, 7
  %29 = sub i64 %.13.i447, %arg.start
  %30 = add i64 %29, %.107.1.i
  %31 = lshr i64 %30, 3
  %32 = select i1 %.685.not.i, i64 8, i64 7
  %33 = add nuw nsw i64 %32, %31
  %34 = add nuw nsw i64 %.1167.i672, 7
  %35 = add nuw nsw i64 %.123.i, 7
  %36 = icmp sgt i64 %.13.i445, %arg.start
  %37 = icmp eq i64 %.2174, 0
  %sunkaddr65 = shl i64 %.1771, 3
  %sunkaddr67 = getelementptr i8, ptr %arg.state.2.4, i64 %sunkaddr65
  %38 = icmp slt i64 %.3624, 1
  %39 = icmp slt i64 %.3624, 1
  %40 = icmp slt i64 %.13.i, %.13.i447
  %41 = icmp slt i64 %.13.i, %.13.i447
  %42 = icmp ult i64 %.107.1.i, -9223372036854775807
  %sunkaddr244 = shl i64 %.364, 3
  %43 = icmp sgt i64 %.1007, 0
  %sunkaddr154 = getelementptr i8, ptr %arg.state.11.4, i64 264
  %sunkaddr156 = getelementptr i8, ptr %arg.state.11.4, i64 256
  %sunkaddr158 = getelementptr i8, ptr %arg.state.11.4, i64 248
  %sunkaddr160 = getelementptr i8, ptr %arg.state.11.4, i64 240
  %sunkaddr162 = getelementptr i8, ptr %arg.state.11.4, i64 232
  %sunkaddr164 = getelementptr i8, ptr %arg.state.11.4, i64 224
  %sunkaddr166 = getelementptr i8, ptr %arg.state.11.4, i64 216
  %sunkaddr168 = getelementptr i8, ptr %arg.state.11.4, i64 208
  %sunkaddr172 = getelementptr i8, ptr %arg.state.11.4, i64 200
  %sunkaddr173 = getelementptr inbounds nuw i8, ptr %arg.state.11.4, i64 192
  %sunkaddr174 = getelementptr i8, ptr %arg.state.11.4, i64 184
  %sunkaddr175 = getelementptr i8, ptr %arg.state.11.4, i64 176
  %sunkaddr176 = getelementptr i8, ptr %arg.state.11.4, i64 168
  %sunkaddr177 = getelementptr i8, ptr %arg.state.11.4, i64 160
  %sunkaddr178 = getelementptr i8, ptr %arg.state.11.4, i64 152
  %sunkaddr179 = getelementptr i8, ptr %arg.state.11.4, i64 144
  %sunkaddr180 = getelementptr i8, ptr %arg.state.11.4, i64 136
  %sunkaddr181 = getelementptr i8, ptr %arg.state.11.4, i64 128
  %sunkaddr182 = getelementptr i8, ptr %arg.state.11.4, i64 120
  %sunkaddr183 = getelementptr i8, ptr %arg.state.11.4, i64 112
  %sunkaddr184 = getelementptr i8, ptr %arg.state.11.4, i64 104
  %sunkaddr185 = getelementptr i8, ptr %arg.state.11.4, i64 96
  %sunkaddr186 = getelementptr i8, ptr %arg.state.11.4, i64 88
  %sunkaddr187 = getelementptr i8, ptr %arg.state.11.4, i64 80
  %sunkaddr188 = getelementptr i8, ptr %arg.state.11.4, i64 72
  %sunkaddr189 = getelementptr inbounds nuw i8, ptr %arg.state.11.4, i64 64
  %sunkaddr190 = shl i64 %.364, 3
  %44 = icmp slt i64 %.13.i446, %arg.inside
  %sunkaddr134 = shl i64 %.1771, 3
  %sunkaddr136 = getelementptr i8, ptr %arg.state.2.4, i64 %sunkaddr134
  %sunkaddr138 = getelementptr i8, ptr %sunkaddr136, i64 8
  %45 = and i64 %.99.i421, 1
  %46 = icmp eq i64 %45, 0
  %sunkaddr140 = shl i64 %.1771, 3
  %sunkaddr142 = getelementptr i8, ptr %arg.state.2.4, i64 %sunkaddr140
  %sunkaddr144 = getelementptr i8, ptr %sunkaddr142, i64 8
  %sunkaddr148 = getelementptr inbounds nuw i8, ptr %21, i64 %sunkaddr1279
  %47 = icmp eq i64 %.6618, %.neg.i
  br label %B1770

B1770:                                            ; preds = %_ZN17bnserve_surrogate8tangents7_points11fill_sharesB4v369B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE8UniTupleIxLi3EEd5ArrayIdLi1E1C7mutable7alignedEd5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit, %B10883
  %.2720.sroa.0.0341 = phi i64 [ %"$phi1472.2.2.0", %_ZN17bnserve_surrogate8tangents7_points11fill_sharesB4v369B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE8UniTupleIxLi3EEd5ArrayIdLi1E1C7mutable7alignedEd5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit ], [ %.2720.sroa.0.0, %B10883 ]
  %.2677.1340 = phi i64 [ %.2677.1338, %_ZN17bnserve_surrogate8tangents7_points11fill_sharesB4v369B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE8UniTupleIxLi3EEd5ArrayIdLi1E1C7mutable7alignedEd5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit ], [ %.2677.1, %B10883 ]
  %.2674.1339 = phi i64 [ %.2674.1337, %_ZN17bnserve_surrogate8tangents7_points11fill_sharesB4v369B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE8UniTupleIxLi3EEd5ArrayIdLi1E1C7mutable7alignedEd5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit ], [ %.2674.1, %B10883 ]
  %.2911 = icmp eq i64 %.2720.sroa.0.0341, 0
  %48 = mul i64 %.2720.sroa.0.0341, 1088
  %49 = getelementptr i8, ptr %arg.state.15.4, i64 %48
  %.3265 = getelementptr i8, ptr %49, i64 8704
  %.3420 = getelementptr i8, ptr %49, i64 15232
  %"$1526call.6.2.sroa.88.1" = select i1 %.2911, ptr %.3095, ptr %.3420
  %"$1526call.6.2.sroa.32.1" = select i1 %.2911, ptr %.2941, ptr %.3265
  br i1 %36, label %B2066, label %B2070

B2066:                                            ; preds = %B1770
  %.3654 = load double, ptr %sunkaddr67, align 8
  %.304.i = icmp eq i64 %.2720.sroa.0.0341, 6
  %50 = shl nsw i64 %.2720.sroa.0.0341, 3
  %.589.i = select i1 %.304.i, i64 0, i64 %50
  %.654.i = add nsw i64 %.589.i, %arg.state.5
  %.655.i = mul nsw i64 %.654.i, %arg.state.7.2
  %.668.i = getelementptr inbounds double, ptr %arg.state.3.4, i64 %.655.i
  %.761.i = load double, ptr %.668.i, align 8, !noalias !170
  %51 = getelementptr i8, ptr %.668.i, i64 %.idx.i
  %.799.i = getelementptr double, ptr %51, i64 %.785.i
  %.800.i = load double, ptr %.799.i, align 8, !noalias !170
  %52 = getelementptr i8, ptr %.668.i, i64 %.idx895.i
  %53 = getelementptr i8, ptr %52, i64 8
  %.918.i = getelementptr double, ptr %53, i64 %.904.i
  %.919.i = load double, ptr %.918.i, align 8, !noalias !170
  %.923.i = fneg contract double %.919.i
  br i1 %.304.i, label %B236.i, label %B298.i

B236.i:                                           ; preds = %B2066
  br i1 %39, label %B2070, label %B34.if.i.i

B94.i.i:                                          ; preds = %B34.if.i.i
  %.236.i.i = fmul contract double %.227.i.i, 0x400921FB54442D18
  %.246.le.i.i = tail call contract double @llvm.sin.f64(double %.236.i.i)
  %.251.i.i = fmul contract double %.246.le.i.i, 0x3FF921FB54442D18
  br label %B194.i.i

B194.i.i:                                         ; preds = %B34.if.i.i, %B94.i.i
  %"$phi194.1.2.1.i.i" = phi double [ %.251.i.i, %B94.i.i ], [ 0.000000e+00, %B34.if.i.i ]
  %.265.i.i = fmul contract double %.761.i, %"$phi194.1.2.1.i.i"
  %.273.i.i = fmul contract double %.226.i.i, %.265.i.i
  %.275.i.i = fmul contract double %.2616, %.273.i.i
  %scevgep37 = getelementptr i8, ptr %"$1526call.6.2.sroa.32.1", i64 %54
  store double %.275.i.i, ptr %scevgep37, align 8, !noalias !173
  %.309.i.i = fmul contract double %.216.i.i, %.923.i
  %.313.i.i = fmul contract double %.2616, %.309.i.i
  %scevgep36 = getelementptr i8, ptr %"$1526call.6.2.sroa.88.1", i64 %54
  store double %.313.i.i, ptr %scevgep36, align 8, !noalias !173
  %exitcond.not.i.i = icmp eq i64 %.3624, %.156.i.i
  br i1 %exitcond.not.i.i, label %B2070, label %B34.if.i.i

B34.if.i.i:                                       ; preds = %B236.i, %B194.i.i
  %.149100102.i.i = phi i64 [ %.156.i.i, %B194.i.i ], [ 0, %B236.i ]
  %.156.i.i = add nuw nsw i64 %.149100102.i.i, 1
  %54 = shl i64 %.149100102.i.i, 3
  %scevgep2.i.i = getelementptr i8, ptr %.1023, i64 %54
  %.214.i.i = load double, ptr %scevgep2.i.i, align 8, !noalias !173
  %.216.i.i = fmul contract double %arg.mass, %.214.i.i
  %.221.i.i = fmul contract double %.216.i.i, 2.000000e+00
  %.226.i.i = fdiv contract double %.221.i.i, %.3654
  %.227.i.i = fadd contract double %.226.i.i, -1.000000e+00
  %.232.i.i = fcmp contract ogt double %.227.i.i, 0.000000e+00
  br i1 %.232.i.i, label %B94.i.i, label %B194.i.i

B298.i:                                           ; preds = %B2066
  br i1 %38, label %B2070, label %B34.if.i1.i

B94.i8.i:                                         ; preds = %B34.if.i1.i
  %.6.i.i.i = fmul contract double %.229.i.i, 0x400921FB54442D18
  %.7.i.i.i = tail call contract double @llvm.fma.f64(double %.6.i.i.i, double 0x3FE45F306DC9C883, double 0x4338000000000000)
  %.8.i.i.i = fadd contract double %.7.i.i.i, 0xC338000000000000
  %.23.i.i.i = tail call contract double @llvm.fma.f64(double %.8.i.i.i, double 0xBFF921FB54442D18, double %.6.i.i.i)
  %.38.i.i.i = tail call contract double @llvm.fma.f64(double %.8.i.i.i, double 0xBC91A62633145C07, double %.23.i.i.i)
  %.39.i.i.i = fmul contract double %.38.i.i.i, %.38.i.i.i
  %.56.i.i.i = bitcast double %.7.i.i.i to i64
  %.60.i.i.i = and i64 %.56.i.i.i, 1
  %55 = icmp eq i64 %.60.i.i.i, 0
  br i1 %55, label %select.true.sink.i.i.i, label %select.false.sink.i.i.i

select.true.sink.i.i.i:                           ; preds = %B94.i8.i
  %.48.i.i.i = tail call contract double @llvm.fma.f64(double %.39.i.i.i, double 0x3D2AE7F3E733B81F, double 0xBDA93974A8C07C9D)
  %.49.i.i.i = tail call contract double @llvm.fma.f64(double %.39.i.i.i, double %.48.i.i.i, double 0x3E21EED8EFF8D898)
  %.50.i.i.i = tail call contract double @llvm.fma.f64(double %.39.i.i.i, double %.49.i.i.i, double 0xBE927E4FB7789F5C)
  %.51.i.i.i = tail call contract double @llvm.fma.f64(double %.39.i.i.i, double %.50.i.i.i, double 0x3EFA01A01A01A01A)
  %.52.i.i.i = tail call contract double @llvm.fma.f64(double %.39.i.i.i, double %.51.i.i.i, double 0xBF56C16C16C16C17)
  %.53.i.i.i = tail call contract double @llvm.fma.f64(double %.39.i.i.i, double %.52.i.i.i, double 0x3FA5555555555555)
  %.54.i.i.i = tail call contract double @llvm.fma.f64(double %.39.i.i.i, double %.53.i.i.i, double -5.000000e-01)
  %.55.i.i.i = tail call contract double @llvm.fma.f64(double %.39.i.i.i, double %.54.i.i.i, double 1.000000e+00)
  br label %_ZN17bnserve_surrogate6kernel7_points4stepB4v380B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEd.exit.i.i

select.false.sink.i.i.i:                          ; preds = %B94.i8.i
  %.46.i.i.i = fmul contract double %.38.i.i.i, %.39.i.i.i
  %.40.i.i.i = tail call contract double @llvm.fma.f64(double %.39.i.i.i, double 0xBD6AE7F3E733B81F, double 0x3DE6124613A86D09)
  %.41.i.i.i = tail call contract double @llvm.fma.f64(double %.39.i.i.i, double %.40.i.i.i, double 0xBE5AE64567F544E4)
  %.42.i.i.i = tail call contract double @llvm.fma.f64(double %.39.i.i.i, double %.41.i.i.i, double 0x3EC71DE3A556C734)
  %.43.i.i.i = tail call contract double @llvm.fma.f64(double %.39.i.i.i, double %.42.i.i.i, double 0xBF2A01A01A01A01A)
  %.44.i.i.i = tail call contract double @llvm.fma.f64(double %.39.i.i.i, double %.43.i.i.i, double 0x3F81111111111111)
  %.45.i.i.i = tail call contract double @llvm.fma.f64(double %.39.i.i.i, double %.44.i.i.i, double 0xBFC5555555555555)
  %.47.i.i.i = tail call contract double @llvm.fma.f64(double %.46.i.i.i, double %.45.i.i.i, double %.38.i.i.i)
  br label %_ZN17bnserve_surrogate6kernel7_points4stepB4v380B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEd.exit.i.i

_ZN17bnserve_surrogate6kernel7_points4stepB4v380B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEd.exit.i.i: ; preds = %select.false.sink.i.i.i, %select.true.sink.i.i.i
  %.71.v.i.i.i = phi double [ %.55.i.i.i, %select.true.sink.i.i.i ], [ %.47.i.i.i, %select.false.sink.i.i.i ]
  %.65.i.i.i = shl i64 %.56.i.i.i, 62
  %.66.i.i.i = add i64 %.65.i.i.i, 4611686018427387904
  %.67.i.i.i = and i64 %.66.i.i.i, -9223372036854775808
  %.71.i.i.i = bitcast double %.71.v.i.i.i to i64
  %.72.i.i.i = xor i64 %.67.i.i.i, %.71.i.i.i
  %.73.i.i.i = bitcast i64 %.72.i.i.i to double
  %.89.i.i.i = tail call contract double @llvm.fma.f64(double %.73.i.i.i, double -5.000000e-01, double 5.000000e-01)
  %.266.i.i = fmul contract double %.761.i, %.89.i.i.i
  br label %B144.i.i

B144.i.i:                                         ; preds = %B34.if.i1.i, %_ZN17bnserve_surrogate6kernel7_points4stepB4v380B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEd.exit.i.i
  %"$phi144.1.2.1.i.i" = phi double [ %.266.i.i, %_ZN17bnserve_surrogate6kernel7_points4stepB4v380B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEd.exit.i.i ], [ 0.000000e+00, %B34.if.i1.i ]
  %scevgep35 = getelementptr i8, ptr %"$1526call.6.2.sroa.32.1", i64 %57
  store double %"$phi144.1.2.1.i.i", ptr %scevgep35, align 8, !noalias !176
  %.314.i.i = fsub contract double %.218.i.i, %.3654
  %56 = fmul contract double %.919.i, %.314.i.i
  %.319.i.i = fsub contract double %.800.i, %56
  %scevgep34 = getelementptr i8, ptr %"$1526call.6.2.sroa.88.1", i64 %57
  store double %.319.i.i, ptr %scevgep34, align 8, !noalias !176
  %exitcond.not.i6.i = icmp eq i64 %.3624, %.158.i.i
  br i1 %exitcond.not.i6.i, label %B2070, label %B34.if.i1.i

B34.if.i1.i:                                      ; preds = %B298.i, %B144.i.i
  %.151102104.i.i = phi i64 [ %.158.i.i, %B144.i.i ], [ 0, %B298.i ]
  %.158.i.i = add nuw nsw i64 %.151102104.i.i, 1
  %57 = shl i64 %.151102104.i.i, 3
  %scevgep2.i2.i = getelementptr i8, ptr %.1023, i64 %57
  %.216.i3.i = load double, ptr %scevgep2.i2.i, align 8, !noalias !176
  %.218.i.i = fmul contract double %arg.mass, %.216.i3.i
  %.223.i.i = fmul contract double %.218.i.i, 2.000000e+00
  %.228.i.i = fdiv contract double %.223.i.i, %.3654
  %.228.fr.i.i = freeze double %.228.i.i
  %.229.i.i = fadd contract double %.228.fr.i.i, -1.000000e+00
  %.234.i.i = fcmp contract ogt double %.229.i.i, 0.000000e+00
  br i1 %.234.i.i, label %B94.i8.i, label %B144.i.i

B2070:                                            ; preds = %B144.i.i, %B194.i.i, %B298.i, %B236.i, %B1770
  %.3868 = mul nsw i64 %.3867, %.2720.sroa.0.0341
  %.3882 = getelementptr inbounds double, ptr %arg.state.8.0.4, i64 %.3868
  %.4019 = mul nsw i64 %.4018, %.2720.sroa.0.0341
  %.4033 = getelementptr inbounds double, ptr %arg.state.8.1.4, i64 %.4019
  br i1 %37, label %B2302, label %B2072

B2072:                                            ; preds = %B2070
  br i1 %40, label %B22.preheader.i, label %B2314

B22.preheader.i:                                  ; preds = %B2072
  %scevgep1187 = getelementptr i8, ptr %"$1526call.6.2.sroa.88.1", i64 %22
  %scevgep1189 = getelementptr i8, ptr %"$1526call.6.2.sroa.32.1", i64 %22
  br label %B22.i

B22.i:                                            ; preds = %B926.i, %B22.preheader.i
  %cell.2.0.i = phi i64 [ %cell.3.2.i, %B926.i ], [ %arg.cells.1, %B22.preheader.i ]
  %start.2.0.i = phi i64 [ %.13.i.i, %B926.i ], [ %.13.i445, %B22.preheader.i ]
  %.149.i = getelementptr inbounds i64, ptr %arg.state.9.1.4, i64 %cell.2.0.i
  %.150.i = load i64, ptr %.149.i, align 8, !noalias !179
  %.154.not.i = icmp sgt i64 %.150.i, %start.2.0.i
  br i1 %.154.not.i, label %B112.i, label %B62.i

B62.i:                                            ; preds = %B22.i, %B62.i
  %cell.4.1.i = phi i64 [ %.157.i, %B62.i ], [ %cell.2.0.i, %B22.i ]
  %.157.i = add i64 %cell.4.1.i, 1
  %sunkaddr = shl i64 %.157.i, 3
  %sunkaddr69 = getelementptr i8, ptr %arg.state.9.1.4, i64 %sunkaddr
  %.170.i = load i64, ptr %sunkaddr69, align 8, !noalias !179
  %.172.not.i = icmp sgt i64 %.170.i, %start.2.0.i
  br i1 %.172.not.i, label %B112.i, label %B62.i

B112.i:                                           ; preds = %B62.i, %B22.i
  %cell.3.2.i = phi i64 [ %cell.2.0.i, %B22.i ], [ %.157.i, %B62.i ]
  %.184.i = getelementptr inbounds i64, ptr %arg.state.9.1.4, i64 %cell.3.2.i
  %.185.i = load i64, ptr %.184.i, align 8, !noalias !179
  %.13.i.i = tail call i64 @llvm.smin.i64(i64 %.13.i447, i64 %.185.i)
  %.395.i = sub i64 %.13.i.i, %start.2.0.i
  %58 = add i64 %.395.i, 7
  %.417.i = lshr i64 %58, 3
  %.396.inv.i = icmp slt i64 %.395.i, 1
  %.438305.not326.i = icmp eq i64 %.417.i, 0
  %.438305.not.i = or i1 %.396.inv.i, %.438305.not326.i
  br i1 %.438305.not.i, label %B926.i, label %B570.if.lr.ph.i

B926.i:                                           ; preds = %B570.if.i, %B112.i
  %.602.i = icmp slt i64 %.185.i, %.13.i447
  br i1 %.602.i, label %B22.i, label %B2314

B570.if.lr.ph.i:                                  ; preds = %B112.i
  %.228.i = getelementptr inbounds double, ptr %.2443, i64 %cell.3.2.i
  %.229.i = load double, ptr %.228.i, align 8, !noalias !179
  %.231.i = fsub contract double %.2551.le, %.229.i
  %.279.i = add nsw i64 %cell.3.2.i, %.277.i
  %.347.i = getelementptr inbounds double, ptr %.4033, i64 %.279.i
  %.348.i = load double, ptr %.347.i, align 8, !noalias !179
  %.266.i = add nsw i64 %cell.3.2.i, %.264.i
  %.334.i = getelementptr inbounds double, ptr %.4033, i64 %.266.i
  %.335.i = load double, ptr %.334.i, align 8, !noalias !179
  %.247.i = add nsw i64 %cell.3.2.i, %arg.state.7.0
  %.315.i = getelementptr inbounds double, ptr %.4033, i64 %.247.i
  %.316.i = load double, ptr %.315.i, align 8, !noalias !179
  %.303.i = getelementptr inbounds double, ptr %.4033, i64 %cell.3.2.i
  %.304.i358 = load double, ptr %.303.i, align 8, !noalias !179
  %.287.i = getelementptr inbounds double, ptr %.3882, i64 %.279.i
  %.288.i = load double, ptr %.287.i, align 8, !noalias !179
  %.274.i = getelementptr inbounds double, ptr %.3882, i64 %.266.i
  %.275.i = load double, ptr %.274.i, align 8, !noalias !179
  %.255.i = getelementptr inbounds double, ptr %.3882, i64 %.247.i
  %.256.i = load double, ptr %.255.i, align 8, !noalias !179
  %.243.i = getelementptr inbounds double, ptr %.3882, i64 %cell.3.2.i
  %.244.i = load double, ptr %.243.i, align 8, !noalias !179
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
  %.552.i = insertelement <8 x double> poison, double %.304.i358, i64 0
  %.553.i = shufflevector <8 x double> %.552.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.6.i.i = insertelement <8 x double> poison, double %.231.i, i64 0
  %.7.i.i = shufflevector <8 x double> %.6.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %59 = shl i64 %start.2.0.i, 3
  %60 = add nuw nsw i64 %.417.i, 7
  br label %B570.if.i

B570.if.i:                                        ; preds = %B570.if.i, %B570.if.lr.ph.i
  %lsr.iv39 = phi i64 [ %lsr.iv.next40, %B570.if.i ], [ %60, %B570.if.lr.ph.i ]
  %lsr.iv8.i = phi i64 [ %lsr.iv.next9.i, %B570.if.i ], [ %59, %B570.if.lr.ph.i ]
  %scevgep13.i = getelementptr i8, ptr %.500, i64 %lsr.iv8.i
  %.485.i = load <8 x double>, ptr %scevgep13.i, align 8, !noalias !179
  %.8.i.i = fadd contract <8 x double> %.7.i.i, %.485.i
  %.519.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i.i, <8 x double> %.515.i, <8 x double> %.518.i)
  %.523.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i.i, <8 x double> %.519.i, <8 x double> %.522.i)
  %.527.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i.i, <8 x double> %.523.i, <8 x double> %.526.i)
  %scevgep1190 = getelementptr i8, ptr %scevgep1189, i64 %lsr.iv8.i
  store <8 x double> %.527.i, ptr %scevgep1190, align 8, !noalias !179
  %.546.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i.i, <8 x double> %.542.i, <8 x double> %.545.i)
  %.550.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i.i, <8 x double> %.546.i, <8 x double> %.549.i)
  %.554.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i.i, <8 x double> %.550.i, <8 x double> %.553.i)
  %scevgep1188 = getelementptr i8, ptr %scevgep1187, i64 %lsr.iv8.i
  store <8 x double> %.554.i, ptr %scevgep1188, align 8, !noalias !179
  %lsr.iv.next9.i = add i64 %lsr.iv8.i, 64
  %lsr.iv.next40 = add nsw i64 %lsr.iv39, -1
  %.438.i = icmp sgt i64 %lsr.iv39, 8
  br i1 %.438.i, label %B570.if.i, label %B926.i

B2302:                                            ; preds = %B2070
  br i1 %41, label %B22.preheader.i360, label %B2302.endif

B22.preheader.i360:                               ; preds = %B2302
  %61 = getelementptr double, ptr %.3882, i64 %arg.state.7.0
  %62 = getelementptr i8, ptr %.3882, i64 %.idx.i
  %63 = getelementptr i8, ptr %.3882, i64 %.idx221.i
  %scevgep1193 = getelementptr i8, ptr %"$1526call.6.2.sroa.32.1", i64 %22
  br label %B22.i363

B22.i363:                                         ; preds = %B612.i, %B22.preheader.i360
  %cell.2.0.i364 = phi i64 [ %cell.3.2.i370, %B612.i ], [ %arg.cells.0, %B22.preheader.i360 ]
  %start.2.0.i365 = phi i64 [ %.13.i.i372, %B612.i ], [ %.13.i445, %B22.preheader.i360 ]
  %.121.i = getelementptr inbounds i64, ptr %arg.state.9.0.4, i64 %cell.2.0.i364
  %.122.i = load i64, ptr %.121.i, align 8, !noalias !182
  %.126.not.i = icmp sgt i64 %.122.i, %start.2.0.i365
  br i1 %.126.not.i, label %B112.i369, label %B62.i366

B62.i366:                                         ; preds = %B22.i363, %B62.i366
  %cell.4.1.i367 = phi i64 [ %.129.i, %B62.i366 ], [ %cell.2.0.i364, %B22.i363 ]
  %.129.i = add i64 %cell.4.1.i367, 1
  %sunkaddr71 = shl i64 %.129.i, 3
  %sunkaddr73 = getelementptr i8, ptr %arg.state.9.0.4, i64 %sunkaddr71
  %.142.i = load i64, ptr %sunkaddr73, align 8, !noalias !182
  %.144.not.i = icmp sgt i64 %.142.i, %start.2.0.i365
  br i1 %.144.not.i, label %B112.i369, label %B62.i366

B112.i369:                                        ; preds = %B62.i366, %B22.i363
  %cell.3.2.i370 = phi i64 [ %cell.2.0.i364, %B22.i363 ], [ %.129.i, %B62.i366 ]
  %.156.i = getelementptr inbounds i64, ptr %arg.state.9.0.4, i64 %cell.3.2.i370
  %.157.i371 = load i64, ptr %.156.i, align 8, !noalias !182
  %.13.i.i372 = tail call i64 @llvm.smin.i64(i64 %.13.i447, i64 %.157.i371)
  %.307.i = sub i64 %.13.i.i372, %start.2.0.i365
  %64 = add i64 %.307.i, 7
  %.329.i = lshr i64 %64, 3
  %.308.inv.i = icmp slt i64 %.307.i, 1
  %.350229.not250.i = icmp eq i64 %.329.i, 0
  %.350229.not.i = or i1 %.308.inv.i, %.350229.not250.i
  br i1 %.350229.not.i, label %B612.i, label %B412.if.lr.ph.i

B612.i:                                           ; preds = %B412.if.i, %B112.i369
  %.479.i = icmp slt i64 %.157.i371, %.13.i447
  br i1 %.479.i, label %B22.i363, label %B2302.endif

B412.if.lr.ph.i:                                  ; preds = %B112.i369
  %.200.i = getelementptr inbounds double, ptr %.2337, i64 %cell.3.2.i370
  %.201.i = load double, ptr %.200.i, align 8, !noalias !182
  %.203.i = fsub contract double %.2551.le, %.201.i
  %.259.i = getelementptr double, ptr %63, i64 %cell.3.2.i370
  %.260.i = load double, ptr %.259.i, align 8, !noalias !182
  %.246.i = getelementptr double, ptr %62, i64 %cell.3.2.i370
  %.247.i373 = load double, ptr %.246.i, align 8, !noalias !182
  %.227.i = getelementptr double, ptr %61, i64 %cell.3.2.i370
  %.228.i374 = load double, ptr %.227.i, align 8, !noalias !182
  %.215.i = getelementptr inbounds double, ptr %.3882, i64 %cell.3.2.i370
  %.216.i = load double, ptr %.215.i, align 8, !noalias !182
  %.426.i = insertelement <8 x double> poison, double %.260.i, i64 0
  %.427.i = shufflevector <8 x double> %.426.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.429.i = insertelement <8 x double> poison, double %.247.i373, i64 0
  %.430.i = shufflevector <8 x double> %.429.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.433.i = insertelement <8 x double> poison, double %.228.i374, i64 0
  %.434.i = shufflevector <8 x double> %.433.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.437.i = insertelement <8 x double> poison, double %.216.i, i64 0
  %.438.i375 = shufflevector <8 x double> %.437.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.6.i.i376 = insertelement <8 x double> poison, double %.203.i, i64 0
  %.7.i.i377 = shufflevector <8 x double> %.6.i.i376, <8 x double> poison, <8 x i32> zeroinitializer
  %65 = shl i64 %start.2.0.i365, 3
  %66 = add nuw nsw i64 %.329.i, 7
  br label %B412.if.i

B412.if.i:                                        ; preds = %B412.if.i, %B412.if.lr.ph.i
  %lsr.iv44 = phi i64 [ %lsr.iv.next45, %B412.if.i ], [ %66, %B412.if.lr.ph.i ]
  %lsr.iv8.i378 = phi i64 [ %lsr.iv.next9.i384, %B412.if.i ], [ %65, %B412.if.lr.ph.i ]
  %scevgep11.i380 = getelementptr i8, ptr %.500, i64 %lsr.iv8.i378
  %.397.i = load <8 x double>, ptr %scevgep11.i380, align 8, !noalias !182
  %.8.i.i381 = fadd contract <8 x double> %.7.i.i377, %.397.i
  %.431.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i.i381, <8 x double> %.427.i, <8 x double> %.430.i)
  %.435.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i.i381, <8 x double> %.431.i, <8 x double> %.434.i)
  %.439.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i.i381, <8 x double> %.435.i, <8 x double> %.438.i375)
  %scevgep1194 = getelementptr i8, ptr %scevgep1193, i64 %lsr.iv8.i378
  store <8 x double> %.439.i, ptr %scevgep1194, align 8, !noalias !182
  %lsr.iv.next9.i384 = add i64 %lsr.iv8.i378, 64
  %lsr.iv.next45 = add nsw i64 %lsr.iv44, -1
  %.350.i = icmp sgt i64 %lsr.iv44, 8
  br i1 %.350.i, label %B412.if.i, label %B612.i

B2314:                                            ; preds = %B926.i, %B612.i602, %B2302.endif, %B2072
  %fill_residuals_v509_cell_a.2.1 = phi i64 [ %cell.5.1.i359, %B612.i602 ], [ %arg.cells.0, %B2072 ], [ %cell.5.1.i359, %B2302.endif ], [ %arg.cells.0, %B926.i ]
  %fill_residuals_v509_cell_p.3.1 = phi i64 [ %cell.3.2.i558, %B612.i602 ], [ %arg.cells.1, %B2072 ], [ %arg.cells.1, %B2302.endif ], [ %cell.3.2.i, %B926.i ]
  br i1 %.2911, label %B2376, label %B2766

B2376:                                            ; preds = %B2314
  br i1 %43, label %B2500, label %B10392

B2500:                                            ; preds = %B2376
  %.5258 = load double, ptr %.2228, align 8
  store ptr null, ptr %.5757, align 8
  call fastcc void @inner_13(ptr nonnull %.5757, ptr %.1023, ptr %.1089, ptr %.1239, i64 %.13.i474, i64 %.13.i476, i64 %.1007, double %arg.mass, ptr %arg.state.11.4, double %.5258, ptr %"$1526call.6.2.sroa.32.1", ptr nonnull %.5060)
  %.1013.i = load double, ptr %sunkaddr154, align 8, !noalias !185
  %.984.i = load double, ptr %sunkaddr156, align 8, !noalias !185
  %.955.i = load double, ptr %sunkaddr158, align 8, !noalias !185
  %.926.i = load double, ptr %sunkaddr160, align 8, !noalias !185
  %.897.i = load double, ptr %sunkaddr162, align 8, !noalias !185
  %.868.i = load double, ptr %sunkaddr164, align 8, !noalias !185
  %.839.i = load double, ptr %sunkaddr166, align 8, !noalias !185
  %.810.i = load double, ptr %sunkaddr168, align 8, !noalias !185
  %.781.i = load double, ptr %sunkaddr172, align 8, !noalias !185
  %.752.i = load double, ptr %sunkaddr173, align 8, !noalias !185
  %.648.i = load double, ptr %sunkaddr174, align 8, !noalias !185
  %.619.i = load double, ptr %sunkaddr175, align 8, !noalias !185
  %.590.i = load double, ptr %sunkaddr176, align 8, !noalias !185
  %.561.i = load double, ptr %sunkaddr177, align 8, !noalias !185
  %.532.i = load double, ptr %sunkaddr178, align 8, !noalias !185
  %.503.i = load double, ptr %sunkaddr179, align 8, !noalias !185
  %.474.i = load double, ptr %sunkaddr180, align 8, !noalias !185
  %.445.i = load double, ptr %sunkaddr181, align 8, !noalias !185
  %.344.i = load double, ptr %sunkaddr182, align 8, !noalias !185
  %.315.i652 = load double, ptr %sunkaddr183, align 8, !noalias !185
  %.286.i = load double, ptr %sunkaddr184, align 8, !noalias !185
  %.257.i = load double, ptr %sunkaddr185, align 8, !noalias !185
  %.228.i655 = load double, ptr %sunkaddr186, align 8, !noalias !185
  %.199.i = load double, ptr %sunkaddr187, align 8, !noalias !185
  %.170.i656 = load double, ptr %sunkaddr188, align 8, !noalias !185
  %.141.i657 = load double, ptr %sunkaddr189, align 8, !noalias !185
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
  %.1312.i = insertelement <8 x double> poison, double %.315.i652, i64 0
  %.1313.i = shufflevector <8 x double> %.1312.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1315.i = insertelement <8 x double> poison, double %.257.i, i64 0
  %.1316.i = shufflevector <8 x double> %.1315.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1319.i = insertelement <8 x double> poison, double %.199.i, i64 0
  %.1320.i = shufflevector <8 x double> %.1319.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1323.i = insertelement <8 x double> poison, double %.141.i657, i64 0
  %.1324.i = shufflevector <8 x double> %.1323.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1327.i = insertelement <8 x double> poison, double %.344.i, i64 0
  %.1328.i = shufflevector <8 x double> %.1327.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1330.i = insertelement <8 x double> poison, double %.286.i, i64 0
  %.1331.i = shufflevector <8 x double> %.1330.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1334.i = insertelement <8 x double> poison, double %.228.i655, i64 0
  %.1335.i = shufflevector <8 x double> %.1334.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1338.i = insertelement <8 x double> poison, double %.170.i656, i64 0
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
  br label %B484.if.i

B2766:                                            ; preds = %B2314
  %.4946.idx = mul nsw i64 %.2720.sroa.0.0341, 288
  %sunkaddr1249 = getelementptr i8, ptr %arg.state.11.4, i64 %.4946.idx
  %sunkaddr1250 = getelementptr i8, ptr %sunkaddr1249, i64 272
  %.6053 = load double, ptr %sunkaddr1250, align 8
  br i1 %42, label %B380.i, label %B78.if.lr.ph.i

B78.if.lr.ph.i:                                   ; preds = %B2766
  %.6008 = icmp eq i64 %.2720.sroa.0.0341, 6
  %.2616. = select i1 %.6008, double %.2616, double 0.000000e+00
  %.580.i = insertelement <8 x double> poison, double %.2616., i64 0
  %.581.i = shufflevector <8 x double> %.580.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.584.i = insertelement <8 x double> poison, double %.6053, i64 0
  %.585.i = shufflevector <8 x double> %.584.i, <8 x double> poison, <8 x i32> zeroinitializer
  %sunkaddr79 = getelementptr i8, ptr %sunkaddr1249, i64 56
  %sunkaddr88 = getelementptr i8, ptr %sunkaddr1249, i64 48
  %sunkaddr116 = getelementptr i8, ptr %sunkaddr1249, i64 40
  %sunkaddr118 = getelementptr i8, ptr %sunkaddr1249, i64 32
  %sunkaddr122 = getelementptr i8, ptr %sunkaddr1249, i64 24
  %sunkaddr126 = getelementptr i8, ptr %sunkaddr1249, i64 16
  %sunkaddr130 = getelementptr i8, ptr %sunkaddr1249, i64 8
  br label %B78.if.i

B380.i:                                           ; preds = %B78.if.i, %B2766
  br i1 %brmerge, label %B10200.endif, label %B424.if.lr.ph.i

B78.if.i:                                         ; preds = %B78.if.i, %B78.if.lr.ph.i
  %lsr.iv50 = phi i64 [ %lsr.iv.next51, %B78.if.i ], [ %28, %B78.if.lr.ph.i ]
  %lsr.iv8.i397 = phi i64 [ %lsr.iv.next9.i406, %B78.if.i ], [ 0, %B78.if.lr.ph.i ]
  %scevgep14.i = getelementptr i8, ptr %.1089, i64 %lsr.iv8.i397
  %.275.i398 = load <8 x double>, ptr %scevgep14.i, align 8, !noalias !188
  %.308.i = load double, ptr %sunkaddr79, align 8, !noalias !188
  %.309.i = insertelement <8 x double> poison, double %.308.i, i64 0
  %.310.i = shufflevector <8 x double> %.309.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.339.i = load double, ptr %sunkaddr88, align 8, !noalias !188
  %.340.i = insertelement <8 x double> poison, double %.339.i, i64 0
  %.341.i = shufflevector <8 x double> %.340.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.342.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.275.i398, <8 x double> %.310.i, <8 x double> %.341.i)
  %.371.i = load double, ptr %sunkaddr116, align 8, !noalias !188
  %.372.i = insertelement <8 x double> poison, double %.371.i, i64 0
  %.373.i = shufflevector <8 x double> %.372.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.374.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.275.i398, <8 x double> %.342.i, <8 x double> %.373.i)
  %.403.i = load double, ptr %sunkaddr118, align 8, !noalias !188
  %.404.i = insertelement <8 x double> poison, double %.403.i, i64 0
  %.405.i = shufflevector <8 x double> %.404.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.406.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.275.i398, <8 x double> %.374.i, <8 x double> %.405.i)
  %.435.i399 = load double, ptr %sunkaddr122, align 8, !noalias !188
  %.436.i = insertelement <8 x double> poison, double %.435.i399, i64 0
  %.437.i400 = shufflevector <8 x double> %.436.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.438.i401 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.275.i398, <8 x double> %.406.i, <8 x double> %.437.i400)
  %.467.i = load double, ptr %sunkaddr126, align 8, !noalias !188
  %.468.i = insertelement <8 x double> poison, double %.467.i, i64 0
  %.469.i = shufflevector <8 x double> %.468.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.470.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.275.i398, <8 x double> %.438.i401, <8 x double> %.469.i)
  %.499.i = load double, ptr %sunkaddr130, align 8, !noalias !188
  %.500.i = insertelement <8 x double> poison, double %.499.i, i64 0
  %.501.i = shufflevector <8 x double> %.500.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.502.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.275.i398, <8 x double> %.470.i, <8 x double> %.501.i)
  %.531.i = load double, ptr %sunkaddr1249, align 8, !noalias !188
  %.535.i = insertelement <8 x double> poison, double %.531.i, i64 0
  %.536.i = shufflevector <8 x double> %.535.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.537.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.275.i398, <8 x double> %.502.i, <8 x double> %.536.i)
  %scevgep13.i402 = getelementptr i8, ptr %arg.state.15.4, i64 %lsr.iv8.i397
  %.547.i = load <8 x double>, ptr %scevgep13.i402, align 8, !noalias !188
  %scevgep12.i403 = getelementptr i8, ptr %"$1526call.6.2.sroa.32.1", i64 %lsr.iv8.i397
  %.557.i = load <8 x double>, ptr %scevgep12.i403, align 8, !noalias !188
  %.558.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.537.i, <8 x double> %.547.i, <8 x double> %.557.i)
  %scevgep1204 = getelementptr i8, ptr %scevgep13.i402, i64 1088
  %.568.i = load <8 x double>, ptr %scevgep1204, align 8, !noalias !188
  %scevgep54 = getelementptr i8, ptr %scevgep13.i402, i64 2176
  %.578.i = load <8 x double>, ptr %scevgep54, align 8, !noalias !188
  %.582.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.578.i, <8 x double> %.581.i, <8 x double> %.558.i)
  %.586.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.568.i, <8 x double> %.585.i, <8 x double> %.582.i)
  store <8 x double> %.586.i, ptr %scevgep12.i403, align 8, !noalias !188
  %lsr.iv.next9.i406 = add i64 %lsr.iv8.i397, 64
  %lsr.iv.next51 = add nsw i64 %lsr.iv50, -1
  %.227.i407 = icmp sgt i64 %lsr.iv50, 8
  br i1 %.227.i407, label %B78.if.i, label %B380.i

B424.if.lr.ph.i:                                  ; preds = %B380.i
  %.768.i = insertelement <8 x double> poison, double %.6053, i64 0
  %.769.i = shufflevector <8 x double> %.768.i, <8 x double> poison, <8 x i32> zeroinitializer
  br label %B424.if.i

B424.if.i:                                        ; preds = %B424.if.i, %B424.if.lr.ph.i
  %lsr.iv56 = phi i64 [ %lsr.iv.next57, %B424.if.i ], [ %33, %B424.if.lr.ph.i ]
  %lsr.iv3.i = phi i64 [ %lsr.iv.next4.i, %B424.if.i ], [ %18, %B424.if.lr.ph.i ]
  %scevgep5.i = getelementptr i8, ptr %.1971, i64 %lsr.iv3.i
  %.756.i = load <8 x double>, ptr %scevgep5.i, align 8, !noalias !188
  %scevgep.i409 = getelementptr i8, ptr %"$1526call.6.2.sroa.32.1", i64 %lsr.iv3.i
  %.766.i = load <8 x double>, ptr %scevgep.i409, align 8, !noalias !188
  %.770.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.756.i, <8 x double> %.769.i, <8 x double> %.766.i)
  store <8 x double> %.770.i, ptr %scevgep.i409, align 8, !noalias !188
  %lsr.iv.next4.i = add i64 %lsr.iv3.i, 64
  %lsr.iv.next57 = add nsw i64 %lsr.iv56, -1
  %.709.i = icmp sgt i64 %lsr.iv56, 8
  br i1 %.709.i, label %B424.if.i, label %B10200.endif

B10392:                                           ; preds = %B484.if.i779, %B484.if.i, %B10200.endif, %B2376
  br i1 %44, label %B10441, label %B10883

B10441:                                           ; preds = %B10392
  %.6348.idx = mul nsw i64 %.2720.sroa.0.0341, 24
  %spec.select7 = select i1 %.2911, ptr %.5060, ptr %.3265
  br i1 %.14491.not.i, label %B10566.endif, label %B48.if.lr.ph.i

B48.if.lr.ph.i:                                   ; preds = %B10441
  %spec.select = select i1 %.2911, ptr %.5149, ptr %.3420
  %sunkaddr1266 = getelementptr i8, ptr %arg.state.14.4, i64 %.6348.idx
  %sunkaddr1267 = getelementptr i8, ptr %sunkaddr1266, i64 16
  %.6738 = load double, ptr %sunkaddr1267, align 8
  %sunkaddr1269 = getelementptr i8, ptr %sunkaddr1266, i64 8
  %.6708 = load double, ptr %sunkaddr1269, align 8
  %.6678 = load double, ptr %sunkaddr1266, align 8
  %.6648 = load double, ptr %sunkaddr138, align 8
  %.183.i = insertelement <8 x double> poison, double %.6678, i64 0
  %.184.i422 = shufflevector <8 x double> %.183.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.206.i = fneg contract double %.6648
  %.210.i = insertelement <8 x double> poison, double %.206.i, i64 0
  %.211.i = shufflevector <8 x double> %.210.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.215.i423 = insertelement <8 x double> poison, double %.6738, i64 0
  %.216.i424 = shufflevector <8 x double> %.215.i423, <8 x double> poison, <8 x i32> zeroinitializer
  %.217.i = insertelement <8 x double> poison, double %.6708, i64 0
  %.218.i = shufflevector <8 x double> %.217.i, <8 x double> poison, <8 x i32> zeroinitializer
  %scevgep1229 = getelementptr i8, ptr %spec.select, i64 %22
  %scevgep1234 = getelementptr i8, ptr %spec.select7, i64 %22
  br label %B48.if.i

B48.if.i:                                         ; preds = %B48.if.i, %B48.if.lr.ph.i
  %lsr.iv61 = phi i64 [ %lsr.iv.next62, %B48.if.i ], [ %35, %B48.if.lr.ph.i ]
  %lsr.iv1230 = phi i64 [ %lsr.iv.next1231, %B48.if.i ], [ %23, %B48.if.lr.ph.i ]
  %scevgep1235 = getelementptr i8, ptr %scevgep1234, i64 %lsr.iv1230
  store <8 x double> %.184.i422, ptr %scevgep1235, align 8, !noalias !191
  %scevgep1233 = getelementptr i8, ptr %.433, i64 %lsr.iv1230
  %.204.i = load <8 x double>, ptr %scevgep1233, align 8, !noalias !191
  %.212.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.204.i, <8 x double> %.209.i, <8 x double> %.211.i)
  %.219.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.212.i, <8 x double> %.216.i424, <8 x double> %.218.i)
  %scevgep1232 = getelementptr i8, ptr %scevgep1229, i64 %lsr.iv1230
  store <8 x double> %.219.i, ptr %scevgep1232, align 8, !noalias !191
  %lsr.iv.next1231 = add i64 %lsr.iv1230, 64
  %lsr.iv.next62 = add nsw i64 %lsr.iv61, -1
  %.144.i = icmp sgt i64 %lsr.iv61, 8
  br i1 %.144.i, label %B48.if.i, label %B10566.endif

B36.if.lr.ph.i:                                   ; preds = %B10566.endif
  %.6900 = load double, ptr %sunkaddr144, align 8
  %.6905 = fdiv contract double %.6900, %arg.mass
  %.6822 = load double, ptr %.2228, align 8
  %sunkaddr1278 = getelementptr i8, ptr %arg.state.14.4, i64 %.6348.idx
  %.6852 = load double, ptr %sunkaddr1278, align 8
  %.6865.le = tail call contract double @llvm.exp.f64(double %.6852)
  %.6870 = fmul contract double %.6822, %.6865.le
  %.160.i = tail call contract double @llvm.pow.f64(double %.6905, double 0x400AAAAAAAAAAAAB)
  %.162.i = fmul contract double %.160.i, %.6870
  br i1 %46, label %B36.if.prol.loopexit.i, label %B36.if.prol.i

B36.if.prol.i:                                    ; preds = %B36.if.lr.ph.i
  %.192.prol.i = load double, ptr %sunkaddr148, align 8, !noalias !194
  %.193.prol.i = fmul contract double %.162.i, %.192.prol.i
  %.224.prol.i = fmul contract double %.192.prol.i, %.193.prol.i
  %67 = getelementptr double, ptr %spec.select7, i64 %.1007
  %.253.prol.i = getelementptr double, ptr %67, i64 %.239.prol.i
  store double %.224.prol.i, ptr %.253.prol.i, align 8, !noalias !194
  br label %B36.if.prol.loopexit.i

B36.if.prol.loopexit.i:                           ; preds = %B36.if.prol.i, %B36.if.lr.ph.i
  %.1208791.unr.i = phi i64 [ %.99.i421, %B36.if.lr.ph.i ], [ %.130.prol.i, %B36.if.prol.i ]
  %.1278890.unr.i = phi i64 [ %.1007, %B36.if.lr.ph.i ], [ %.neg.i, %B36.if.prol.i ]
  br i1 %47, label %B10883, label %B36.if.preheader.i

B36.if.preheader.i:                               ; preds = %B36.if.prol.loopexit.i
  %68 = add nuw i64 %.1208791.unr.i, 2
  %69 = shl i64 %.1278890.unr.i, 3
  %scevgep62 = getelementptr i8, ptr %spec.select7, i64 %69
  %scevgep67 = getelementptr i8, ptr %scevgep66, i64 %69
  br label %B36.if.i

B36.if.i:                                         ; preds = %B36.if.i, %B36.if.preheader.i
  %lsr.iv68 = phi ptr [ %scevgep69, %B36.if.i ], [ %scevgep67, %B36.if.preheader.i ]
  %lsr.iv63 = phi ptr [ %scevgep64, %B36.if.i ], [ %scevgep62, %B36.if.preheader.i ]
  %lsr.iv.i428 = phi i64 [ %lsr.iv.next.i434, %B36.if.i ], [ %68, %B36.if.preheader.i ]
  %.1278890.i = phi i64 [ %75, %B36.if.i ], [ %.1278890.unr.i, %B36.if.preheader.i ]
  %.176.i = icmp slt i64 %.1278890.i, 0
  %70 = select i1 %.176.i, i64 8589934592, i64 0
  %scevgep72 = getelementptr i8, ptr %lsr.iv68, i64 %70
  %.192.i = load double, ptr %scevgep72, align 8, !noalias !194
  %.193.i = fmul contract double %.162.i, %.192.i
  %.224.i = fmul contract double %.192.i, %.193.i
  %71 = select i1 %.176.i, i64 1088, i64 0
  %scevgep71 = getelementptr i8, ptr %lsr.iv63, i64 %71
  store double %.224.i, ptr %scevgep71, align 8, !noalias !194
  %72 = add i64 %.1278890.i, 1
  %.176.1.i = icmp slt i64 %72, 0
  %73 = select i1 %.176.1.i, i64 8589934600, i64 8
  %scevgep70 = getelementptr i8, ptr %lsr.iv68, i64 %73
  %.192.1.i = load double, ptr %scevgep70, align 8, !noalias !194
  %.193.1.i = fmul contract double %.162.i, %.192.1.i
  %.224.1.i = fmul contract double %.192.1.i, %.193.1.i
  %74 = select i1 %.176.1.i, i64 1096, i64 8
  %scevgep65 = getelementptr i8, ptr %lsr.iv63, i64 %74
  store double %.224.1.i, ptr %scevgep65, align 8, !noalias !194
  %lsr.iv.next.i434 = add i64 %lsr.iv.i428, -2
  %scevgep64 = getelementptr i8, ptr %lsr.iv63, i64 16
  %scevgep69 = getelementptr i8, ptr %lsr.iv68, i64 16
  %.121.1.i = icmp sgt i64 %lsr.iv.next.i434, 2
  %75 = add i64 %.1278890.i, 2
  br i1 %.121.1.i, label %B36.if.i, label %B10883

B10883:                                           ; preds = %B36.if.i, %B10566.endif, %B36.if.prol.loopexit.i, %B10392
  %.2730 = icmp sgt i64 %.2677.1340, 0
  %.2743 = zext i1 %.2730 to i64
  %.2674.1 = add i64 %.2674.1339, %.2743
  %.2739 = sext i1 %.2730 to i64
  %.2677.1 = add nsw i64 %.2677.1340, %.2739
  %.2720.sroa.0.0 = select i1 %.2730, i64 %.2674.1339, i64 0
  br i1 %.2730, label %B1770, label %B10885

B10885:                                           ; preds = %B10883
  store i64 %fill_residuals_v509_cell_a.2.1, ptr %retptr, align 8
  %retptr.repack5654 = getelementptr inbounds nuw i8, ptr %retptr, i64 8
  store i64 %fill_residuals_v509_cell_p.3.1, ptr %retptr.repack5654, align 8
  ret void

B2302.endif:                                      ; preds = %B612.i, %B2302
  %cell.5.1.i359 = phi i64 [ %arg.cells.0, %B2302 ], [ %cell.3.2.i370, %B612.i ]
  br i1 %41, label %B22.preheader.i539, label %B2314

B22.preheader.i539:                               ; preds = %B2302.endif
  %76 = getelementptr double, ptr %.4033, i64 %arg.state.7.1
  %77 = getelementptr i8, ptr %.4033, i64 %.idx.i540
  %78 = getelementptr i8, ptr %.4033, i64 %.idx221.i541
  %scevgep1198 = getelementptr i8, ptr %"$1526call.6.2.sroa.88.1", i64 %22
  br label %B22.i543

B22.i543:                                         ; preds = %B612.i602, %B22.preheader.i539
  %cell.2.0.i544 = phi i64 [ %cell.3.2.i558, %B612.i602 ], [ %arg.cells.1, %B22.preheader.i539 ]
  %start.2.0.i545 = phi i64 [ %.13.i.i561, %B612.i602 ], [ %.13.i445, %B22.preheader.i539 ]
  %.121.i546 = getelementptr inbounds i64, ptr %arg.state.9.1.4, i64 %cell.2.0.i544
  %.122.i547 = load i64, ptr %.121.i546, align 8, !noalias !197
  %.126.not.i548 = icmp sgt i64 %.122.i547, %start.2.0.i545
  br i1 %.126.not.i548, label %B112.i557, label %B62.i549

B62.i549:                                         ; preds = %B22.i543, %B62.i549
  %cell.4.1.i550 = phi i64 [ %.129.i551, %B62.i549 ], [ %cell.2.0.i544, %B22.i543 ]
  %.129.i551 = add i64 %cell.4.1.i550, 1
  %sunkaddr150 = shl i64 %.129.i551, 3
  %sunkaddr152 = getelementptr i8, ptr %arg.state.9.1.4, i64 %sunkaddr150
  %.142.i555 = load i64, ptr %sunkaddr152, align 8, !noalias !197
  %.144.not.i556 = icmp sgt i64 %.142.i555, %start.2.0.i545
  br i1 %.144.not.i556, label %B112.i557, label %B62.i549

B112.i557:                                        ; preds = %B62.i549, %B22.i543
  %cell.3.2.i558 = phi i64 [ %cell.2.0.i544, %B22.i543 ], [ %.129.i551, %B62.i549 ]
  %.156.i559 = getelementptr inbounds i64, ptr %arg.state.9.1.4, i64 %cell.3.2.i558
  %.157.i560 = load i64, ptr %.156.i559, align 8, !noalias !197
  %.13.i.i561 = tail call i64 @llvm.smin.i64(i64 %.13.i447, i64 %.157.i560)
  %.307.i562 = sub i64 %.13.i.i561, %start.2.0.i545
  %79 = add i64 %.307.i562, 7
  %.329.i563 = lshr i64 %79, 3
  %.308.inv.i564 = icmp slt i64 %.307.i562, 1
  %.350229.not250.i565 = icmp eq i64 %.329.i563, 0
  %.350229.not.i566 = or i1 %.308.inv.i564, %.350229.not250.i565
  br i1 %.350229.not.i566, label %B612.i602, label %B412.if.lr.ph.i567

B612.i602:                                        ; preds = %B412.if.i589, %B112.i557
  %.479.i603 = icmp slt i64 %.157.i560, %.13.i447
  br i1 %.479.i603, label %B22.i543, label %B2314

B412.if.lr.ph.i567:                               ; preds = %B112.i557
  %.200.i568 = getelementptr inbounds double, ptr %.2443, i64 %cell.3.2.i558
  %.201.i569 = load double, ptr %.200.i568, align 8, !noalias !197
  %.203.i570 = fsub contract double %.2551.le, %.201.i569
  %.259.i571 = getelementptr double, ptr %78, i64 %cell.3.2.i558
  %.260.i572 = load double, ptr %.259.i571, align 8, !noalias !197
  %.246.i573 = getelementptr double, ptr %77, i64 %cell.3.2.i558
  %.247.i574 = load double, ptr %.246.i573, align 8, !noalias !197
  %.227.i575 = getelementptr double, ptr %76, i64 %cell.3.2.i558
  %.228.i576 = load double, ptr %.227.i575, align 8, !noalias !197
  %.215.i577 = getelementptr inbounds double, ptr %.4033, i64 %cell.3.2.i558
  %.216.i578 = load double, ptr %.215.i577, align 8, !noalias !197
  %.426.i579 = insertelement <8 x double> poison, double %.260.i572, i64 0
  %.427.i580 = shufflevector <8 x double> %.426.i579, <8 x double> poison, <8 x i32> zeroinitializer
  %.429.i581 = insertelement <8 x double> poison, double %.247.i574, i64 0
  %.430.i582 = shufflevector <8 x double> %.429.i581, <8 x double> poison, <8 x i32> zeroinitializer
  %.433.i583 = insertelement <8 x double> poison, double %.228.i576, i64 0
  %.434.i584 = shufflevector <8 x double> %.433.i583, <8 x double> poison, <8 x i32> zeroinitializer
  %.437.i585 = insertelement <8 x double> poison, double %.216.i578, i64 0
  %.438.i586 = shufflevector <8 x double> %.437.i585, <8 x double> poison, <8 x i32> zeroinitializer
  %.6.i.i587 = insertelement <8 x double> poison, double %.203.i570, i64 0
  %.7.i.i588 = shufflevector <8 x double> %.6.i.i587, <8 x double> poison, <8 x i32> zeroinitializer
  %80 = shl i64 %start.2.0.i545, 3
  %81 = add nuw nsw i64 %.329.i563, 7
  br label %B412.if.i589

B412.if.i589:                                     ; preds = %B412.if.i589, %B412.if.lr.ph.i567
  %lsr.iv47 = phi i64 [ %lsr.iv.next48, %B412.if.i589 ], [ %81, %B412.if.lr.ph.i567 ]
  %lsr.iv8.i590 = phi i64 [ %lsr.iv.next9.i600, %B412.if.i589 ], [ %80, %B412.if.lr.ph.i567 ]
  %scevgep11.i592 = getelementptr i8, ptr %.500, i64 %lsr.iv8.i590
  %.397.i593 = load <8 x double>, ptr %scevgep11.i592, align 8, !noalias !197
  %.8.i.i594 = fadd contract <8 x double> %.7.i.i588, %.397.i593
  %.431.i595 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i.i594, <8 x double> %.427.i580, <8 x double> %.430.i582)
  %.435.i596 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i.i594, <8 x double> %.431.i595, <8 x double> %.434.i584)
  %.439.i597 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i.i594, <8 x double> %.435.i596, <8 x double> %.438.i586)
  %scevgep1199 = getelementptr i8, ptr %scevgep1198, i64 %lsr.iv8.i590
  store <8 x double> %.439.i597, ptr %scevgep1199, align 8, !noalias !197
  %lsr.iv.next9.i600 = add i64 %lsr.iv8.i590, 64
  %lsr.iv.next48 = add nsw i64 %lsr.iv47, -1
  %.350.i601 = icmp sgt i64 %lsr.iv47, 8
  br i1 %.350.i601, label %B412.if.i589, label %B612.i602

B484.if.i:                                        ; preds = %B484.if.i, %B2500
  %lsr.iv58 = phi i64 [ %lsr.iv.next59, %B484.if.i ], [ %34, %B2500 ]
  %lsr.iv54 = phi ptr [ %scevgep55, %B484.if.i ], [ %"$1526call.6.2.sroa.88.1", %B2500 ]
  %lsr.iv51 = phi ptr [ %scevgep52, %B484.if.i ], [ %.5149, %B2500 ]
  %lsr.iv1222 = phi ptr [ %scevgep1223, %B484.if.i ], [ %.1023, %B2500 ]
  %scevgep1226 = getelementptr i8, ptr %lsr.iv1222, i64 %.idx
  %.1236.i = load <8 x double>, ptr %scevgep1226, align 8, !noalias !185
  %.1246.i = load <8 x double>, ptr %lsr.iv1222, align 8, !noalias !185
  %sunkaddr191 = getelementptr i8, ptr %lsr.iv1222, i64 %sunkaddr190
  %.1256.i = load <8 x double>, ptr %sunkaddr191, align 8, !noalias !185
  %.6.i.i659 = fmul contract <8 x double> %.1236.i, %.1236.i
  %.1287.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i659, <8 x double> %.1283.i, <8 x double> %.1286.i)
  %.1291.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i659, <8 x double> %.1287.i, <8 x double> %.1290.i)
  %.1295.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i659, <8 x double> %.1291.i, <8 x double> %.1294.i)
  %.1302.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i659, <8 x double> %.1298.i, <8 x double> %.1301.i)
  %.1306.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i659, <8 x double> %.1302.i, <8 x double> %.1305.i)
  %.1310.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i659, <8 x double> %.1306.i, <8 x double> %.1309.i)
  %.1317.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i659, <8 x double> %.1313.i, <8 x double> %.1316.i)
  %.1321.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i659, <8 x double> %.1317.i, <8 x double> %.1320.i)
  %.1325.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i659, <8 x double> %.1321.i, <8 x double> %.1324.i)
  %.1332.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i659, <8 x double> %.1328.i, <8 x double> %.1331.i)
  %.1336.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i659, <8 x double> %.1332.i, <8 x double> %.1335.i)
  %.1340.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i659, <8 x double> %.1336.i, <8 x double> %.1339.i)
  %.1347.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i659, <8 x double> %.1343.i, <8 x double> %.1346.i)
  %.1351.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i659, <8 x double> %.1347.i, <8 x double> %.1350.i)
  %.1355.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i659, <8 x double> %.1351.i, <8 x double> %.1354.i)
  %.1362.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i659, <8 x double> %.1358.i, <8 x double> %.1361.i)
  %.1366.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i659, <8 x double> %.1362.i, <8 x double> %.1365.i)
  %.1367.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1236.i, <8 x double> %.1340.i, <8 x double> %.1325.i)
  %scevgep1224 = getelementptr i8, ptr %lsr.iv1222, i64 %.idx5652
  %.1377.i = load <8 x double>, ptr %scevgep1224, align 8, !noalias !185
  %.6.i16.i = fmul contract <8 x double> %.1377.i, %.1367.i
  %.6.i17.i = fmul contract <8 x double> %.1246.i, %.1256.i
  %.1426.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1236.i, <8 x double> %.1366.i, <8 x double> %.1355.i)
  %.1430.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i17.i, <8 x double> %.1429.i, <8 x double> %.1426.i)
  %.1431.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1236.i, <8 x double> %.1310.i, <8 x double> %.1295.i)
  %.1441.i = load <8 x double>, ptr %lsr.iv54, align 8, !noalias !185
  %.1442.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1246.i, <8 x double> %.1431.i, <8 x double> %.1441.i)
  %.1443.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1256.i, <8 x double> %.1430.i, <8 x double> %.1442.i)
  %.6.i18.i = fadd contract <8 x double> %.6.i16.i, %.1443.i
  %.1450.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1246.i, <8 x double> %.1447.i, <8 x double> %.1449.i)
  %.6.i19.i = fsub contract <8 x double> %.1450.i, %.6.i18.i
  store <8 x double> %.6.i19.i, ptr %lsr.iv51, align 8, !noalias !185
  %scevgep1223 = getelementptr i8, ptr %lsr.iv1222, i64 64
  %scevgep52 = getelementptr i8, ptr %lsr.iv51, i64 64
  %scevgep55 = getelementptr i8, ptr %lsr.iv54, i64 64
  %lsr.iv.next59 = add nsw i64 %lsr.iv58, -1
  %.1189.i = icmp sgt i64 %lsr.iv58, 8
  br i1 %.1189.i, label %B484.if.i, label %B10392

B10200.endif:                                     ; preds = %B424.if.i, %B380.i
  br i1 %.1189570.not.i675, label %B10392, label %B484.if.lr.ph.i676

B484.if.lr.ph.i676:                               ; preds = %B10200.endif
  %sunkaddr193 = getelementptr i8, ptr %sunkaddr1249, i64 264
  %.1013.i678 = load double, ptr %sunkaddr193, align 8, !noalias !200
  %sunkaddr195 = getelementptr i8, ptr %sunkaddr1249, i64 256
  %.984.i680 = load double, ptr %sunkaddr195, align 8, !noalias !200
  %sunkaddr197 = getelementptr i8, ptr %sunkaddr1249, i64 248
  %.955.i682 = load double, ptr %sunkaddr197, align 8, !noalias !200
  %sunkaddr199 = getelementptr i8, ptr %sunkaddr1249, i64 240
  %.926.i684 = load double, ptr %sunkaddr199, align 8, !noalias !200
  %sunkaddr201 = getelementptr i8, ptr %sunkaddr1249, i64 232
  %.897.i686 = load double, ptr %sunkaddr201, align 8, !noalias !200
  %sunkaddr203 = getelementptr i8, ptr %sunkaddr1249, i64 224
  %.868.i688 = load double, ptr %sunkaddr203, align 8, !noalias !200
  %sunkaddr205 = getelementptr i8, ptr %sunkaddr1249, i64 216
  %.839.i690 = load double, ptr %sunkaddr205, align 8, !noalias !200
  %sunkaddr207 = getelementptr i8, ptr %sunkaddr1249, i64 208
  %.810.i692 = load double, ptr %sunkaddr207, align 8, !noalias !200
  %sunkaddr209 = getelementptr i8, ptr %sunkaddr1249, i64 200
  %.781.i694 = load double, ptr %sunkaddr209, align 8, !noalias !200
  %sunkaddr211 = getelementptr i8, ptr %sunkaddr1249, i64 192
  %.752.i695 = load double, ptr %sunkaddr211, align 8, !noalias !200
  %sunkaddr213 = getelementptr i8, ptr %sunkaddr1249, i64 184
  %.648.i697 = load double, ptr %sunkaddr213, align 8, !noalias !200
  %sunkaddr215 = getelementptr i8, ptr %sunkaddr1249, i64 176
  %.619.i699 = load double, ptr %sunkaddr215, align 8, !noalias !200
  %sunkaddr217 = getelementptr i8, ptr %sunkaddr1249, i64 168
  %.590.i701 = load double, ptr %sunkaddr217, align 8, !noalias !200
  %sunkaddr219 = getelementptr i8, ptr %sunkaddr1249, i64 160
  %.561.i703 = load double, ptr %sunkaddr219, align 8, !noalias !200
  %sunkaddr221 = getelementptr i8, ptr %sunkaddr1249, i64 152
  %.532.i705 = load double, ptr %sunkaddr221, align 8, !noalias !200
  %sunkaddr223 = getelementptr i8, ptr %sunkaddr1249, i64 144
  %.503.i707 = load double, ptr %sunkaddr223, align 8, !noalias !200
  %sunkaddr225 = getelementptr i8, ptr %sunkaddr1249, i64 136
  %.474.i709 = load double, ptr %sunkaddr225, align 8, !noalias !200
  %sunkaddr227 = getelementptr i8, ptr %sunkaddr1249, i64 128
  %.445.i711 = load double, ptr %sunkaddr227, align 8, !noalias !200
  %sunkaddr229 = getelementptr i8, ptr %sunkaddr1249, i64 120
  %.344.i713 = load double, ptr %sunkaddr229, align 8, !noalias !200
  %sunkaddr231 = getelementptr i8, ptr %sunkaddr1249, i64 112
  %.315.i715 = load double, ptr %sunkaddr231, align 8, !noalias !200
  %sunkaddr233 = getelementptr i8, ptr %sunkaddr1249, i64 104
  %.286.i717 = load double, ptr %sunkaddr233, align 8, !noalias !200
  %sunkaddr235 = getelementptr i8, ptr %sunkaddr1249, i64 96
  %.257.i719 = load double, ptr %sunkaddr235, align 8, !noalias !200
  %sunkaddr237 = getelementptr i8, ptr %sunkaddr1249, i64 88
  %.228.i721 = load double, ptr %sunkaddr237, align 8, !noalias !200
  %sunkaddr239 = getelementptr i8, ptr %sunkaddr1249, i64 80
  %.199.i723 = load double, ptr %sunkaddr239, align 8, !noalias !200
  %sunkaddr241 = getelementptr i8, ptr %sunkaddr1249, i64 72
  %.170.i725 = load double, ptr %sunkaddr241, align 8, !noalias !200
  %sunkaddr243 = getelementptr i8, ptr %sunkaddr1249, i64 64
  %.141.i726 = load double, ptr %sunkaddr243, align 8, !noalias !200
  %.1282.i727 = insertelement <8 x double> poison, double %.619.i699, i64 0
  %.1283.i728 = shufflevector <8 x double> %.1282.i727, <8 x double> poison, <8 x i32> zeroinitializer
  %.1285.i729 = insertelement <8 x double> poison, double %.561.i703, i64 0
  %.1286.i730 = shufflevector <8 x double> %.1285.i729, <8 x double> poison, <8 x i32> zeroinitializer
  %.1289.i731 = insertelement <8 x double> poison, double %.503.i707, i64 0
  %.1290.i732 = shufflevector <8 x double> %.1289.i731, <8 x double> poison, <8 x i32> zeroinitializer
  %.1293.i733 = insertelement <8 x double> poison, double %.445.i711, i64 0
  %.1294.i734 = shufflevector <8 x double> %.1293.i733, <8 x double> poison, <8 x i32> zeroinitializer
  %.1297.i735 = insertelement <8 x double> poison, double %.648.i697, i64 0
  %.1298.i736 = shufflevector <8 x double> %.1297.i735, <8 x double> poison, <8 x i32> zeroinitializer
  %.1300.i737 = insertelement <8 x double> poison, double %.590.i701, i64 0
  %.1301.i738 = shufflevector <8 x double> %.1300.i737, <8 x double> poison, <8 x i32> zeroinitializer
  %.1304.i739 = insertelement <8 x double> poison, double %.532.i705, i64 0
  %.1305.i740 = shufflevector <8 x double> %.1304.i739, <8 x double> poison, <8 x i32> zeroinitializer
  %.1308.i741 = insertelement <8 x double> poison, double %.474.i709, i64 0
  %.1309.i742 = shufflevector <8 x double> %.1308.i741, <8 x double> poison, <8 x i32> zeroinitializer
  %.1312.i743 = insertelement <8 x double> poison, double %.315.i715, i64 0
  %.1313.i744 = shufflevector <8 x double> %.1312.i743, <8 x double> poison, <8 x i32> zeroinitializer
  %.1315.i745 = insertelement <8 x double> poison, double %.257.i719, i64 0
  %.1316.i746 = shufflevector <8 x double> %.1315.i745, <8 x double> poison, <8 x i32> zeroinitializer
  %.1319.i747 = insertelement <8 x double> poison, double %.199.i723, i64 0
  %.1320.i748 = shufflevector <8 x double> %.1319.i747, <8 x double> poison, <8 x i32> zeroinitializer
  %.1323.i749 = insertelement <8 x double> poison, double %.141.i726, i64 0
  %.1324.i750 = shufflevector <8 x double> %.1323.i749, <8 x double> poison, <8 x i32> zeroinitializer
  %.1327.i751 = insertelement <8 x double> poison, double %.344.i713, i64 0
  %.1328.i752 = shufflevector <8 x double> %.1327.i751, <8 x double> poison, <8 x i32> zeroinitializer
  %.1330.i753 = insertelement <8 x double> poison, double %.286.i717, i64 0
  %.1331.i754 = shufflevector <8 x double> %.1330.i753, <8 x double> poison, <8 x i32> zeroinitializer
  %.1334.i755 = insertelement <8 x double> poison, double %.228.i721, i64 0
  %.1335.i756 = shufflevector <8 x double> %.1334.i755, <8 x double> poison, <8 x i32> zeroinitializer
  %.1338.i757 = insertelement <8 x double> poison, double %.170.i725, i64 0
  %.1339.i758 = shufflevector <8 x double> %.1338.i757, <8 x double> poison, <8 x i32> zeroinitializer
  %.1342.i759 = insertelement <8 x double> poison, double %.926.i684, i64 0
  %.1343.i760 = shufflevector <8 x double> %.1342.i759, <8 x double> poison, <8 x i32> zeroinitializer
  %.1345.i761 = insertelement <8 x double> poison, double %.868.i688, i64 0
  %.1346.i762 = shufflevector <8 x double> %.1345.i761, <8 x double> poison, <8 x i32> zeroinitializer
  %.1349.i763 = insertelement <8 x double> poison, double %.810.i692, i64 0
  %.1350.i764 = shufflevector <8 x double> %.1349.i763, <8 x double> poison, <8 x i32> zeroinitializer
  %.1353.i765 = insertelement <8 x double> poison, double %.752.i695, i64 0
  %.1354.i766 = shufflevector <8 x double> %.1353.i765, <8 x double> poison, <8 x i32> zeroinitializer
  %.1357.i767 = insertelement <8 x double> poison, double %.897.i686, i64 0
  %.1358.i768 = shufflevector <8 x double> %.1357.i767, <8 x double> poison, <8 x i32> zeroinitializer
  %.1360.i769 = insertelement <8 x double> poison, double %.839.i690, i64 0
  %.1361.i770 = shufflevector <8 x double> %.1360.i769, <8 x double> poison, <8 x i32> zeroinitializer
  %.1364.i771 = insertelement <8 x double> poison, double %.781.i694, i64 0
  %.1365.i772 = shufflevector <8 x double> %.1364.i771, <8 x double> poison, <8 x i32> zeroinitializer
  %.1428.i773 = insertelement <8 x double> poison, double %.955.i682, i64 0
  %.1429.i774 = shufflevector <8 x double> %.1428.i773, <8 x double> poison, <8 x i32> zeroinitializer
  %.1446.i775 = insertelement <8 x double> poison, double %.1013.i678, i64 0
  %.1447.i776 = shufflevector <8 x double> %.1446.i775, <8 x double> poison, <8 x i32> zeroinitializer
  %.1448.i777 = insertelement <8 x double> poison, double %.984.i680, i64 0
  %.1449.i778 = shufflevector <8 x double> %.1448.i777, <8 x double> poison, <8 x i32> zeroinitializer
  br label %B484.if.i779

B484.if.i779:                                     ; preds = %B484.if.i779, %B484.if.lr.ph.i676
  %lsr.iv = phi i64 [ %lsr.iv.next, %B484.if.i779 ], [ %34, %B484.if.lr.ph.i676 ]
  %lsr.iv1211 = phi ptr [ %scevgep1212, %B484.if.i779 ], [ %.1023, %B484.if.lr.ph.i676 ]
  %lsr.iv1209 = phi ptr [ %scevgep1210, %B484.if.i779 ], [ %"$1526call.6.2.sroa.88.1", %B484.if.lr.ph.i676 ]
  %scevgep1215 = getelementptr i8, ptr %lsr.iv1211, i64 %.idx
  %.1236.i783 = load <8 x double>, ptr %scevgep1215, align 8, !noalias !200
  %.1246.i785 = load <8 x double>, ptr %lsr.iv1211, align 8, !noalias !200
  %sunkaddr245 = getelementptr i8, ptr %lsr.iv1211, i64 %sunkaddr244
  %.1256.i787 = load <8 x double>, ptr %sunkaddr245, align 8, !noalias !200
  %.6.i.i788 = fmul contract <8 x double> %.1236.i783, %.1236.i783
  %.1287.i789 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i788, <8 x double> %.1283.i728, <8 x double> %.1286.i730)
  %.1291.i790 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i788, <8 x double> %.1287.i789, <8 x double> %.1290.i732)
  %.1295.i791 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i788, <8 x double> %.1291.i790, <8 x double> %.1294.i734)
  %.1302.i792 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i788, <8 x double> %.1298.i736, <8 x double> %.1301.i738)
  %.1306.i793 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i788, <8 x double> %.1302.i792, <8 x double> %.1305.i740)
  %.1310.i794 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i788, <8 x double> %.1306.i793, <8 x double> %.1309.i742)
  %.1317.i795 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i788, <8 x double> %.1313.i744, <8 x double> %.1316.i746)
  %.1321.i796 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i788, <8 x double> %.1317.i795, <8 x double> %.1320.i748)
  %.1325.i797 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i788, <8 x double> %.1321.i796, <8 x double> %.1324.i750)
  %.1332.i798 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i788, <8 x double> %.1328.i752, <8 x double> %.1331.i754)
  %.1336.i799 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i788, <8 x double> %.1332.i798, <8 x double> %.1335.i756)
  %.1340.i800 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i788, <8 x double> %.1336.i799, <8 x double> %.1339.i758)
  %.1347.i801 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i788, <8 x double> %.1343.i760, <8 x double> %.1346.i762)
  %.1351.i802 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i788, <8 x double> %.1347.i801, <8 x double> %.1350.i764)
  %.1355.i803 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i788, <8 x double> %.1351.i802, <8 x double> %.1354.i766)
  %.1362.i804 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i788, <8 x double> %.1358.i768, <8 x double> %.1361.i770)
  %.1366.i805 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i.i788, <8 x double> %.1362.i804, <8 x double> %.1365.i772)
  %.1367.i806 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1236.i783, <8 x double> %.1340.i800, <8 x double> %.1325.i797)
  %scevgep1213 = getelementptr i8, ptr %lsr.iv1211, i64 %.idx5652
  %.1377.i808 = load <8 x double>, ptr %scevgep1213, align 8, !noalias !200
  %.6.i16.i809 = fmul contract <8 x double> %.1377.i808, %.1367.i806
  %.6.i17.i810 = fmul contract <8 x double> %.1246.i785, %.1256.i787
  %.1426.i811 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1236.i783, <8 x double> %.1366.i805, <8 x double> %.1355.i803)
  %.1430.i812 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i17.i810, <8 x double> %.1429.i774, <8 x double> %.1426.i811)
  %.1431.i813 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1236.i783, <8 x double> %.1310.i794, <8 x double> %.1295.i791)
  %.1441.i815 = load <8 x double>, ptr %lsr.iv1209, align 8, !noalias !200
  %.1442.i816 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1246.i785, <8 x double> %.1431.i813, <8 x double> %.1441.i815)
  %.1443.i817 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1256.i787, <8 x double> %.1430.i812, <8 x double> %.1442.i816)
  %.6.i18.i818 = fadd contract <8 x double> %.6.i16.i809, %.1443.i817
  %.1450.i819 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1246.i785, <8 x double> %.1447.i776, <8 x double> %.1449.i778)
  %.6.i19.i820 = fsub contract <8 x double> %.1450.i819, %.6.i18.i818
  store <8 x double> %.6.i19.i820, ptr %lsr.iv1209, align 8, !noalias !200
  %scevgep1210 = getelementptr i8, ptr %lsr.iv1209, i64 64
  %scevgep1212 = getelementptr i8, ptr %lsr.iv1211, i64 64
  %lsr.iv.next = add nsw i64 %lsr.iv, -1
  %.1189.i824 = icmp sgt i64 %lsr.iv, 8
  br i1 %.1189.i824, label %B484.if.i779, label %B10392

B10566.endif:                                     ; preds = %B48.if.i, %B10441
  %82 = icmp ne i64 %.2720.sroa.0.0341, 0
  %or.cond = select i1 %82, i1 true, i1 %.100.inv.i
  br i1 %or.cond, label %B10883, label %B36.if.lr.ph.i
}

; Function Attrs: nofree norecurse nosync nounwind memory(readwrite, inaccessiblemem: none, target_mem0: none, target_mem1: none)
define internal fastcc void @inner_12(ptr noalias nonnull writeonly captures(none) %retptr, i64 %arg.i, i64 %arg.ends.0, i64 %arg.ends.1, i64 %arg.ends.2, double %arg.turns, ptr readonly captures(none) %arg.state.0.4, ptr captures(none) %arg.state.12.4, ptr captures(none) %arg.state.15.4) unnamed_addr #0 {
entry:
  %.962 = sub nsw i64 %arg.ends.2, %arg.ends.0
  %.1112 = mul nsw i64 %arg.i, 6
  %.1278 = sub i64 %arg.ends.1, %arg.ends.0
  %unroll_iter.i = and i64 %.1278, 9223372036854775806
  %0 = add nuw i64 %.1278, 7
  %.157.i = lshr i64 %0, 3
  %.134.inv.i = icmp slt i64 %.1278, 1
  %.178329.not363.i = icmp eq i64 %.157.i, 0
  %.178329.not.i = select i1 %.134.inv.i, i1 true, i1 %.178329.not363.i
  %.6.i.i = insertelement <8 x double> poison, double %arg.turns, i64 0
  %.7.i.i = shufflevector <8 x double> %.6.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %1 = shl i64 %.962, 4
  %2 = sub i64 %.962, %.1278
  %.58.i = shl i64 %2, 1
  %.20.i = shl i64 %.1278, 1
  %3 = sub i64 %.1278, %.962
  %4 = add nsw i64 %unroll_iter.i, -2
  %5 = lshr exact i64 %4, 1
  %6 = add nuw i64 %5, 1
  %7 = sub i64 %arg.ends.2, %arg.ends.1
  %8 = shl i64 %7, 1
  %9 = and i64 %8, 2
  %10 = shl i64 %.1278, 4
  %11 = or disjoint i64 %1, 8
  %12 = add i64 %1, 16
  %13 = add i64 %1, 24
  %14 = lshr i64 %6, 1
  %15 = mul nsw i64 %14, -2
  %sunkaddr77 = getelementptr i8, ptr %arg.state.0.4, i64 16
  %sunkaddr78 = getelementptr i8, ptr %arg.state.0.4, i64 120
  %sunkaddr79 = getelementptr i8, ptr %arg.state.0.4, i64 128
  %16 = icmp slt i64 %.58.i, 1
  %17 = icmp eq i64 %.1278, 1
  %18 = icmp eq i64 %4, 0
  %19 = and i64 %4, 2
  %20 = icmp eq i64 %19, 0
  %21 = and i64 %.1278, 1
  %22 = icmp eq i64 %21, 0
  %23 = and i64 %2, 1
  %24 = icmp eq i64 %23, 0
  %25 = trunc i64 %3 to i63
  %26 = icmp eq i63 %25, -1
  br label %B7715.if

B34.if.preheader.i:                               ; preds = %B7715.if
  br i1 %17, label %B34.if.epil.preheader.i, label %B34.if.preheader.new.i

B34.if.preheader.new.i:                           ; preds = %B34.if.preheader.i
  %27 = inttoptr i64 %.961 to ptr
  %scevgep.i = getelementptr i8, ptr %27, i64 24
  br i1 %18, label %B34.if.i.epil.preheader, label %B34.if.i.preheader

B34.if.i.preheader:                               ; preds = %B34.if.preheader.new.i
  %scevgep = getelementptr i8, ptr %27, i64 56
  br label %B34.if.i

B102.loopexit.unr-lcssa.i.unr-lcssa:              ; preds = %B34.if.i
  %scevgep8 = getelementptr i8, ptr %lsr.iv, i64 32
  br i1 %20, label %B34.if.i.epil.preheader, label %B102.loopexit.unr-lcssa.i

B34.if.i.epil.preheader:                          ; preds = %B102.loopexit.unr-lcssa.i.unr-lcssa, %B34.if.preheader.new.i
  %lsr.iv.i.epil.init = phi ptr [ %scevgep.i, %B34.if.preheader.new.i ], [ %scevgep8, %B102.loopexit.unr-lcssa.i.unr-lcssa ]
  %.134108110.i.epil.init = phi i64 [ 0, %B34.if.preheader.new.i ], [ %.141.1.i.1, %B102.loopexit.unr-lcssa.i.unr-lcssa ]
  %scevgep4.i.epil = getelementptr i8, ptr %lsr.iv.i.epil.init, i64 -24
  %.196.i.epil = load double, ptr %scevgep4.i.epil, align 8, !noalias !203
  %sunkaddr = shl i64 %.134108110.i.epil.init, 3
  %sunkaddr176 = getelementptr i8, ptr %arg.state.15.4, i64 %sunkaddr
  %sunkaddr177 = getelementptr i8, ptr %sunkaddr176, i64 5440
  store double %.196.i.epil, ptr %sunkaddr177, align 8, !noalias !203
  %scevgep5.i.epil = getelementptr i8, ptr %lsr.iv.i.epil.init, i64 -16
  %.258.i.epil = load double, ptr %scevgep5.i.epil, align 8, !noalias !203
  %sunkaddr180 = getelementptr i8, ptr %sunkaddr176, i64 6528
  store double %.258.i.epil, ptr %sunkaddr180, align 8, !noalias !203
  %.141.1.i.epil = add nuw i64 %.134108110.i.epil.init, 2
  %scevgep3.i.epil = getelementptr i8, ptr %lsr.iv.i.epil.init, i64 -8
  %.196.1.i.epil = load double, ptr %scevgep3.i.epil, align 8, !noalias !203
  %sunkaddr183 = getelementptr i8, ptr %sunkaddr176, i64 5448
  store double %.196.1.i.epil, ptr %sunkaddr183, align 8, !noalias !203
  %.258.1.i.epil = load double, ptr %lsr.iv.i.epil.init, align 8, !noalias !203
  %sunkaddr186 = getelementptr i8, ptr %sunkaddr176, i64 6536
  store double %.258.1.i.epil, ptr %sunkaddr186, align 8, !noalias !203
  br label %B102.loopexit.unr-lcssa.i

B102.loopexit.unr-lcssa.i:                        ; preds = %B34.if.i.epil.preheader, %B102.loopexit.unr-lcssa.i.unr-lcssa
  %.141.1.i.lcssa = phi i64 [ %.141.1.i.epil, %B34.if.i.epil.preheader ], [ %.141.1.i.1, %B102.loopexit.unr-lcssa.i.unr-lcssa ]
  br i1 %22, label %B7845, label %B34.if.epil.preheader.i

B34.if.epil.preheader.i:                          ; preds = %B102.loopexit.unr-lcssa.i, %B34.if.preheader.i
  %.134108110.epil.init.i = phi i64 [ 0, %B34.if.preheader.i ], [ %.141.1.i.lcssa, %B102.loopexit.unr-lcssa.i ]
  %28 = inttoptr i64 %.961 to ptr
  %.idx.epil.i = shl i64 %.134108110.epil.init.i, 4
  %29 = getelementptr i8, ptr %28, i64 %.idx.epil.i
  %.196.epil.i = load double, ptr %29, align 8, !noalias !203
  %sunkaddr187 = shl i64 %.134108110.epil.init.i, 3
  %sunkaddr188 = getelementptr i8, ptr %arg.state.15.4, i64 %sunkaddr187
  %sunkaddr189 = getelementptr i8, ptr %sunkaddr188, i64 5440
  store double %.196.epil.i, ptr %sunkaddr189, align 8, !noalias !203
  %30 = getelementptr i8, ptr %29, i64 8
  %.258.epil.i = load double, ptr %30, align 8, !noalias !203
  %sunkaddr192 = getelementptr i8, ptr %sunkaddr188, i64 6528
  store double %.258.epil.i, ptr %sunkaddr192, align 8, !noalias !203
  br label %B7845

B34.if.i:                                         ; preds = %B34.if.i, %B34.if.i.preheader
  %lsr.iv6 = phi i64 [ %lsr.iv.next7, %B34.if.i ], [ %15, %B34.if.i.preheader ]
  %lsr.iv = phi ptr [ %scevgep122, %B34.if.i ], [ %scevgep, %B34.if.i.preheader ]
  %.134108110.i = phi i64 [ %.141.1.i.1, %B34.if.i ], [ 0, %B34.if.i.preheader ]
  %scevgep127 = getelementptr i8, ptr %lsr.iv, i64 -32
  %scevgep130 = getelementptr i8, ptr %lsr.iv, i64 -56
  %.196.i = load double, ptr %scevgep130, align 8, !noalias !203
  %sunkaddr53 = shl i64 %.134108110.i, 3
  %sunkaddr54 = getelementptr i8, ptr %arg.state.15.4, i64 %sunkaddr53
  %sunkaddr55 = getelementptr i8, ptr %sunkaddr54, i64 5440
  store double %.196.i, ptr %sunkaddr55, align 8, !noalias !203
  %scevgep129 = getelementptr i8, ptr %lsr.iv, i64 -48
  %.258.i = load double, ptr %scevgep129, align 8, !noalias !203
  %sunkaddr58 = getelementptr i8, ptr %sunkaddr54, i64 6528
  store double %.258.i, ptr %sunkaddr58, align 8, !noalias !203
  %scevgep128 = getelementptr i8, ptr %lsr.iv, i64 -40
  %.196.1.i = load double, ptr %scevgep128, align 8, !noalias !203
  %sunkaddr61 = getelementptr i8, ptr %sunkaddr54, i64 5448
  store double %.196.1.i, ptr %sunkaddr61, align 8, !noalias !203
  %.258.1.i = load double, ptr %scevgep127, align 8, !noalias !203
  %sunkaddr64 = getelementptr i8, ptr %sunkaddr54, i64 6536
  store double %.258.1.i, ptr %sunkaddr64, align 8, !noalias !203
  %scevgep126 = getelementptr i8, ptr %lsr.iv, i64 -24
  %.196.i.1 = load double, ptr %scevgep126, align 8, !noalias !203
  %sunkaddr67 = getelementptr i8, ptr %sunkaddr54, i64 5456
  store double %.196.i.1, ptr %sunkaddr67, align 8, !noalias !203
  %scevgep125 = getelementptr i8, ptr %lsr.iv, i64 -16
  %.258.i.1 = load double, ptr %scevgep125, align 8, !noalias !203
  %sunkaddr70 = getelementptr i8, ptr %sunkaddr54, i64 6544
  store double %.258.i.1, ptr %sunkaddr70, align 8, !noalias !203
  %.141.1.i.1 = add i64 %.134108110.i, 4
  %scevgep124 = getelementptr i8, ptr %lsr.iv, i64 -8
  %.196.1.i.1 = load double, ptr %scevgep124, align 8, !noalias !203
  %sunkaddr71 = shl i64 %.141.1.i.1, 3
  %sunkaddr72 = getelementptr i8, ptr %arg.state.15.4, i64 %sunkaddr71
  %sunkaddr73 = getelementptr i8, ptr %sunkaddr72, i64 5432
  store double %.196.1.i.1, ptr %sunkaddr73, align 8, !noalias !203
  %.258.1.i.1 = load double, ptr %lsr.iv, align 8, !noalias !203
  %sunkaddr76 = getelementptr i8, ptr %sunkaddr72, i64 6520
  store double %.258.1.i.1, ptr %sunkaddr76, align 8, !noalias !203
  %scevgep122 = getelementptr i8, ptr %lsr.iv, i64 64
  %lsr.iv.next7 = add i64 %lsr.iv6, 2
  %niter.ncmp.1 = icmp eq i64 %lsr.iv.next7, 0
  br i1 %niter.ncmp.1, label %B102.loopexit.unr-lcssa.i.unr-lcssa, label %B34.if.i

B7845:                                            ; preds = %B7715.if, %B34.if.epil.preheader.i, %B102.loopexit.unr-lcssa.i
  %.idx = mul nuw nsw i64 %.77710651073, 1088
  %31 = getelementptr i8, ptr %arg.state.15.4, i64 %.idx
  br i1 %.178329.not.i, label %B7845.endif.endif.endif, label %B48.if.i.preheader

B48.if.i.preheader:                               ; preds = %B7845
  %32 = inttoptr i64 %.1117 to ptr
  br label %B48.if.i

B8103:                                            ; preds = %B7845.endif.endif.endif.endif
  store ptr null, ptr %retptr, align 8
  ret void

B7715.if:                                         ; preds = %B7845.endif.endif.endif.endif, %entry
  %.77710651073 = phi i64 [ 0, %entry ], [ %.784, %B7845.endif.endif.endif.endif ]
  %.784 = add nuw nsw i64 %.77710651073, 1
  %.915 = load i64, ptr %sunkaddr77, align 8
  %.954 = load i64, ptr %sunkaddr78, align 8
  %.958 = mul nsw i64 %.915, %arg.i
  %.959 = add nsw i64 %.958, %arg.ends.0
  %.960 = shl nsw i64 %.959, 4
  %.961 = add nsw i64 %.960, %.954
  %.1108 = load i64, ptr %sunkaddr79, align 8
  %.1113 = add nsw i64 %.77710651073, %.1112
  %.1114 = mul nsw i64 %.915, %.1113
  %.1115 = add nsw i64 %.1114, %arg.ends.0
  %.1116 = shl nsw i64 %.1115, 4
  %.1117 = add nsw i64 %.1116, %.1108
  %.1273 = icmp ne i64 %.77710651073, 0
  %or.cond = select i1 %.1273, i1 true, i1 %.134.inv.i
  br i1 %or.cond, label %B7845, label %B34.if.preheader.i

B412.i:                                           ; preds = %B48.if.i
  %.472.i = shufflevector <8 x double> %.369.i, <8 x double> %.425.i, <16 x i32> <i32 0, i32 8, i32 1, i32 9, i32 2, i32 10, i32 3, i32 11, i32 4, i32 12, i32 5, i32 13, i32 6, i32 14, i32 7, i32 15>
  store <16 x double> %.472.i, ptr %arg.state.12.4, align 4, !noalias !206
  %.562299.not.i = icmp slt i64 %.372.i, 1
  br i1 %.562299.not.i, label %B8300.i, label %B8132.if.i.preheader

B8132.if.i.preheader:                             ; preds = %B412.i
  %33 = icmp eq i64 %lsr.iv27.i, 1
  br i1 %33, label %B8132.if.i.epil.preheader, label %B8132.if.i

B8244.i:                                          ; preds = %B48.if.i
  %.700.idx.i = shl i64 %.184308332.i, 4
  %.700.i = getelementptr inbounds i8, ptr %32, i64 %.700.idx.i
  %.701.i = shufflevector <8 x double> %.369.i, <8 x double> %.425.i, <16 x i32> <i32 0, i32 8, i32 1, i32 9, i32 2, i32 10, i32 3, i32 11, i32 4, i32 12, i32 5, i32 13, i32 6, i32 14, i32 7, i32 15>
  store <16 x double> %.701.i, ptr %.700.i, align 4, !noalias !206
  br label %B8300.i

B8300.i.loopexit.unr-lcssa:                       ; preds = %B8132.if.i
  %34 = and i64 %smax, 1
  %lcmp.mod118.not = icmp eq i64 %34, 0
  br i1 %lcmp.mod118.not, label %B8300.i, label %B8132.if.i.epil.preheader

B8132.if.i.epil.preheader:                        ; preds = %B8300.i.loopexit.unr-lcssa, %B8132.if.i.preheader
  %.568298300.i.epil.init = phi i64 [ 0, %B8132.if.i.preheader ], [ %.575.1.i.1, %B8300.i.loopexit.unr-lcssa ]
  %sunkaddr.i50.epil = shl i64 %.568298300.i.epil.init, 3
  %sunkaddr33.i.epil = getelementptr i8, ptr %arg.state.12.4, i64 %sunkaddr.i50.epil
  %.629.i.epil = load double, ptr %sunkaddr33.i.epil, align 8, !noalias !206
  %35 = add i64 %.568298300.i.epil.init, %lsr.iv31.i
  %.646.i.epil = icmp slt i64 %35, 0
  %36 = select i1 %.646.i.epil, i64 %1, i64 0
  %scevgep29.i.epil = getelementptr i8, ptr %lsr.iv.i49, i64 %36
  %scevgep30.i.epil = getelementptr i8, ptr %scevgep29.i.epil, i64 %sunkaddr.i50.epil
  store double %.629.i.epil, ptr %scevgep30.i.epil, align 8, !noalias !206
  %sunkaddr36.i.epil = getelementptr i8, ptr %sunkaddr33.i.epil, i64 8
  %.629.1.i.epil = load double, ptr %sunkaddr36.i.epil, align 8, !noalias !206
  %37 = add i64 %.568298300.i.epil.init, %lsr.iv26.i
  %.646.1.i.epil = icmp slt i64 %37, 0
  %38 = select i1 %.646.1.i.epil, i64 %1, i64 0
  %scevgep23.i.epil = getelementptr i8, ptr %lsr.iv.i49, i64 %38
  %scevgep24.i.epil = getelementptr i8, ptr %scevgep23.i.epil, i64 %sunkaddr.i50.epil
  %scevgep25.i.epil = getelementptr i8, ptr %scevgep24.i.epil, i64 8
  store double %.629.1.i.epil, ptr %scevgep25.i.epil, align 8, !noalias !206
  br label %B8300.i

B8300.i:                                          ; preds = %B8132.if.i.epil.preheader, %B8300.i.loopexit.unr-lcssa, %B8244.i, %B412.i
  %scevgep22.i = getelementptr i8, ptr %lsr.iv.i49, i64 128
  %lsr.iv.next.i = add i64 %lsr.iv26.i, 16
  %lsr.iv.next28.i = add i64 %lsr.iv27.i, -8
  %lsr.iv.next32.i = add i64 %lsr.iv31.i, 16
  %.178.i = icmp sgt i64 %.177303333.i, 1
  br i1 %.178.i, label %B48.if.i, label %B7845.endif.endif.endif

B48.if.i:                                         ; preds = %B8300.i, %B48.if.i.preheader
  %lsr.iv31.i = phi i64 [ %lsr.iv.next32.i, %B8300.i ], [ 0, %B48.if.i.preheader ]
  %lsr.iv27.i = phi i64 [ %lsr.iv.next28.i, %B8300.i ], [ %.1278, %B48.if.i.preheader ]
  %lsr.iv26.i = phi i64 [ %lsr.iv.next.i, %B8300.i ], [ 1, %B48.if.i.preheader ]
  %lsr.iv.i49 = phi ptr [ %scevgep22.i, %B8300.i ], [ %32, %B48.if.i.preheader ]
  %.177303333.i = phi i64 [ %.187.i, %B8300.i ], [ %.157.i, %B48.if.i.preheader ]
  %.184308332.i = phi i64 [ %.191.i, %B8300.i ], [ 0, %B48.if.i.preheader ]
  %smax27 = tail call i64 @llvm.smax.i64(i64 %lsr.iv27.i, i64 0)
  %39 = trunc nuw i64 %smax27 to i63
  %40 = add i63 %39, -1
  %41 = zext i63 %40 to i64
  %42 = add nuw i64 %41, 1
  %43 = lshr i64 %42, 1
  %44 = mul nsw i64 %43, -2
  %smax = tail call i64 @llvm.smax.i64(i64 %lsr.iv27.i, i64 0)
  %.187.i = add nsw i64 %.177303333.i, -1
  %.191.i = add nuw i64 %.184308332.i, 8
  %sunkaddr220 = shl i64 %.184308332.i, 3
  %sunkaddr221 = getelementptr inbounds i8, ptr %arg.state.15.4, i64 %sunkaddr220
  %sunkaddr222 = getelementptr inbounds nuw i8, ptr %sunkaddr221, i64 5440
  %.229.i = load <8 x double>, ptr %sunkaddr222, align 8, !noalias !206
  %sunkaddr225 = getelementptr inbounds nuw i8, ptr %sunkaddr221, i64 6528
  %.246.i = load <8 x double>, ptr %sunkaddr225, align 8, !noalias !206
  %sunkaddr227 = getelementptr i8, ptr %31, i64 %sunkaddr220
  %sunkaddr228 = getelementptr i8, ptr %sunkaddr227, i64 9792
  %.259.i = load <8 x double>, ptr %sunkaddr228, align 8, !noalias !206
  %sunkaddr231 = getelementptr i8, ptr %sunkaddr227, i64 16320
  %.269.i = load <8 x double>, ptr %sunkaddr231, align 8, !noalias !206
  %.8.i.i = fmul contract <8 x double> %.7.i.i, %.269.i
  %.6.i16.i = fmul contract <8 x double> %.246.i, %.8.i.i
  %.6.i17.i = fsub contract <8 x double> zeroinitializer, %.6.i16.i
  %.369.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.229.i, <8 x double> %.259.i, <8 x double> %.6.i17.i)
  %.372.i = sub nsw i64 %.1278, %.184308332.i
  %.6.i18.i = fmul contract <8 x double> %.246.i, %.259.i
  %.425.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.229.i, <8 x double> %.8.i.i, <8 x double> %.6.i18.i)
  %.459.i = icmp slt i64 %.372.i, 8
  br i1 %.459.i, label %B412.i, label %B8244.i

B8132.if.i:                                       ; preds = %B8132.if.i.preheader, %B8132.if.i
  %lsr.iv28 = phi i64 [ %lsr.iv.next29, %B8132.if.i ], [ %44, %B8132.if.i.preheader ]
  %.568298300.i = phi i64 [ %.575.1.i.1, %B8132.if.i ], [ 0, %B8132.if.i.preheader ]
  %sunkaddr80 = shl i64 %.568298300.i, 3
  %sunkaddr81 = getelementptr i8, ptr %arg.state.12.4, i64 %sunkaddr80
  %.629.i = load double, ptr %sunkaddr81, align 8, !noalias !206
  %45 = add i64 %.568298300.i, %lsr.iv31.i
  %.646.i = icmp slt i64 %45, 0
  %46 = select i1 %.646.i, i64 %1, i64 0
  %scevgep29.i = getelementptr i8, ptr %lsr.iv.i49, i64 %46
  %scevgep37 = getelementptr i8, ptr %scevgep29.i, i64 %sunkaddr80
  store double %.629.i, ptr %scevgep37, align 8, !noalias !206
  %sunkaddr84 = getelementptr i8, ptr %sunkaddr81, i64 8
  %.629.1.i = load double, ptr %sunkaddr84, align 8, !noalias !206
  %47 = select i1 %.646.i, i64 %11, i64 8
  %scevgep159 = getelementptr i8, ptr %lsr.iv.i49, i64 %47
  %scevgep36 = getelementptr i8, ptr %scevgep159, i64 %sunkaddr80
  store double %.629.1.i, ptr %scevgep36, align 8, !noalias !206
  %sunkaddr87 = getelementptr i8, ptr %sunkaddr81, i64 16
  %.629.i.1 = load double, ptr %sunkaddr87, align 8, !noalias !206
  %48 = select i1 %.646.i, i64 %12, i64 16
  %scevgep149 = getelementptr i8, ptr %lsr.iv.i49, i64 %48
  %scevgep35 = getelementptr i8, ptr %scevgep149, i64 %sunkaddr80
  store double %.629.i.1, ptr %scevgep35, align 8, !noalias !206
  %.575.1.i.1 = add i64 %.568298300.i, 4
  %sunkaddr88 = shl i64 %.575.1.i.1, 3
  %sunkaddr89 = getelementptr i8, ptr %arg.state.12.4, i64 %sunkaddr88
  %sunkaddr90 = getelementptr i8, ptr %sunkaddr89, i64 -8
  %.629.1.i.1 = load double, ptr %sunkaddr90, align 8, !noalias !206
  %49 = select i1 %.646.i, i64 %13, i64 24
  %scevgep147 = getelementptr i8, ptr %lsr.iv.i49, i64 %49
  %scevgep30 = getelementptr i8, ptr %scevgep147, i64 %sunkaddr80
  store double %.629.1.i.1, ptr %scevgep30, align 8, !noalias !206
  %lsr.iv.next29 = add i64 %lsr.iv28, 2
  %niter121.ncmp.1 = icmp eq i64 %lsr.iv.next29, 0
  br i1 %niter121.ncmp.1, label %B8300.i.loopexit.unr-lcssa, label %B8132.if.i

B7845.endif.endif.endif:                          ; preds = %B8300.i, %B7845
  br i1 %16, label %B7845.endif.endif.endif.endif, label %B48.if.preheader.i51

B48.if.preheader.i51:                             ; preds = %B7845.endif.endif.endif
  br i1 %24, label %B48.if.prol.loopexit.i, label %B48.if.prol.i.preheader

B48.if.prol.i.preheader:                          ; preds = %B48.if.preheader.i51
  %50 = inttoptr i64 %.1117 to ptr
  %scevgep167 = getelementptr i8, ptr %50, i64 %10
  br label %B48.if.prol.i

B48.if.prol.i:                                    ; preds = %B48.if.prol.i, %B48.if.prol.i.preheader
  %lsr.iv165 = phi i64 [ 0, %B48.if.prol.i.preheader ], [ %lsr.iv.next166, %B48.if.prol.i ]
  %51 = add i64 %lsr.iv165, %.20.i
  %.154.prol.i = icmp slt i64 %51, 0
  %52 = select i1 %.154.prol.i, i64 %1, i64 0
  %scevgep168 = getelementptr i8, ptr %scevgep167, i64 %52
  %53 = shl i64 %lsr.iv165, 3
  %scevgep39 = getelementptr i8, ptr %scevgep168, i64 %53
  store double 0.000000e+00, ptr %scevgep39, align 8, !noalias !209
  %lsr.iv.next166 = add nuw nsw i64 %lsr.iv165, 1
  %prol.iter.cmp.not.i = icmp eq i64 %9, %lsr.iv.next166
  br i1 %prol.iter.cmp.not.i, label %B48.if.prol.loopexit.loopexit.i, label %B48.if.prol.i, !llvm.loop !212

B48.if.prol.loopexit.loopexit.i:                  ; preds = %B48.if.prol.i
  %54 = sub i64 %8, %lsr.iv.next166
  %55 = add i64 %lsr.iv.next166, %.20.i
  br label %B48.if.prol.loopexit.i

B48.if.prol.loopexit.i:                           ; preds = %B48.if.prol.loopexit.loopexit.i, %B48.if.preheader.i51
  %.1025458.unr.i = phi i64 [ %.58.i, %B48.if.preheader.i51 ], [ %54, %B48.if.prol.loopexit.loopexit.i ]
  %.1095557.unr.i = phi i64 [ %.20.i, %B48.if.preheader.i51 ], [ %55, %B48.if.prol.loopexit.loopexit.i ]
  br i1 %26, label %B7845.endif.endif.endif.endif, label %B48.if.preheader1.i

B48.if.preheader1.i:                              ; preds = %B48.if.prol.loopexit.i
  %56 = add i64 %.1025458.unr.i, 4
  %57 = inttoptr i64 %.1117 to ptr
  %58 = shl i64 %.1095557.unr.i, 3
  %scevgep40 = getelementptr i8, ptr %57, i64 %58
  br label %B48.if.i53

B48.if.i53:                                       ; preds = %B48.if.i53, %B48.if.preheader1.i
  %lsr.iv41 = phi ptr [ %scevgep42, %B48.if.i53 ], [ %scevgep40, %B48.if.preheader1.i ]
  %lsr.iv.i54 = phi i64 [ %lsr.iv.next.i60, %B48.if.i53 ], [ %56, %B48.if.preheader1.i ]
  %.1095557.i = phi i64 [ %66, %B48.if.i53 ], [ %.1095557.unr.i, %B48.if.preheader1.i ]
  %.154.i = icmp slt i64 %.1095557.i, 0
  %59 = select i1 %.154.i, i64 %1, i64 0
  %scevgep46 = getelementptr i8, ptr %lsr.iv41, i64 %59
  store double 0.000000e+00, ptr %scevgep46, align 8, !noalias !209
  %60 = add i64 %.1095557.i, 1
  %.154.1.i = icmp slt i64 %60, 0
  %61 = select i1 %.154.1.i, i64 %11, i64 8
  %scevgep45 = getelementptr i8, ptr %lsr.iv41, i64 %61
  store double 0.000000e+00, ptr %scevgep45, align 8, !noalias !209
  %62 = add i64 %.1095557.i, 2
  %.154.2.i = icmp slt i64 %62, 0
  %63 = select i1 %.154.2.i, i64 %12, i64 16
  %scevgep44 = getelementptr i8, ptr %lsr.iv41, i64 %63
  store double 0.000000e+00, ptr %scevgep44, align 8, !noalias !209
  %64 = add i64 %.1095557.i, 3
  %.154.3.i = icmp slt i64 %64, 0
  %65 = select i1 %.154.3.i, i64 %13, i64 24
  %scevgep43 = getelementptr i8, ptr %lsr.iv41, i64 %65
  store double 0.000000e+00, ptr %scevgep43, align 8, !noalias !209
  %lsr.iv.next.i60 = add i64 %lsr.iv.i54, -4
  %scevgep42 = getelementptr i8, ptr %lsr.iv41, i64 32
  %.103.3.i = icmp sgt i64 %lsr.iv.next.i60, 4
  %66 = add i64 %.1095557.i, 4
  br i1 %.103.3.i, label %B48.if.i53, label %B7845.endif.endif.endif.endif

B7845.endif.endif.endif.endif:                    ; preds = %B48.if.i53, %B48.if.prol.loopexit.i, %B7845.endif.endif.endif
  %exitcond.not = icmp eq i64 %.784, 6
  br i1 %exitcond.not, label %B8103, label %B7715.if
}

; Function Attrs: nofree norecurse nosync nounwind memory(readwrite, inaccessiblemem: none, target_mem0: none, target_mem1: none)
define internal fastcc noundef range(i32 0, 2) i32 @inner_9(ptr noalias nonnull writeonly captures(none) %retptr, ptr noalias nonnull writeonly captures(none) %excinfo, ptr readonly captures(none) %arg.state.0.4, ptr readonly captures(none) %arg.state.1.4, ptr readonly captures(none) %arg.state.2.4, ptr readonly captures(none) %arg.state.3.4, i64 %arg.state.5, ptr readonly captures(none) %arg.state.6.4, i64 range(i64 8, 1) %arg.state.7.0, i64 range(i64 8, 1) %arg.state.7.1, i64 range(i64 8, 0) %arg.state.7.2, ptr writeonly captures(none) %arg.state.9.0.4, i64 range(i64 8, 1) %arg.state.9.0.5.0, ptr writeonly captures(none) %arg.state.9.1.4, i64 range(i64 8, 1) %arg.state.9.1.5.0, ptr readonly captures(none) %arg.state.10.0.4, ptr readonly captures(none) %arg.state.10.1.4, ptr captures(none) initializes((0, 64)) %arg.state.11.4, ptr initializes((0, 384)) %arg.state.15.4, double %arg.mass) unnamed_addr #0 {
entry:
  %.1175 = alloca double, align 8
  store double 0.000000e+00, ptr %.1175, align 8
  %excinfo.6 = alloca ptr, align 8
  store ptr null, ptr %excinfo.6, align 8
  %.3676 = alloca i64, align 8
  store i64 0, ptr %.3676, align 8
  %.3831 = alloca i64, align 8
  store i64 0, ptr %.3831, align 8
  %.3952 = alloca i64, align 8
  store i64 0, ptr %.3952, align 8
  %.4111 = alloca i64, align 8
  store i64 0, ptr %.4111, align 8
  %.284 = getelementptr i8, ptr %arg.state.0.4, i64 88
  %.285 = load i64, ptr %.284, align 8
  %.342 = getelementptr i8, ptr %arg.state.1.4, i64 128
  %.343 = load i64, ptr %.342, align 8
  %.359 = getelementptr inbounds double, ptr %arg.state.2.4, i64 %.343
  %.938 = mul nsw i64 %arg.state.7.2, %arg.state.5
  %.951 = getelementptr inbounds double, ptr %arg.state.3.4, i64 %.938
  %.1093 = add i64 %arg.state.7.1, %arg.state.7.0
  %.1107.idx = shl i64 %.1093, 4
  %.1107 = getelementptr inbounds i8, ptr %.951, i64 %.1107.idx
  store double 0.000000e+00, ptr %.1175, align 8
  %.1189 = call fastcc i32 @inner_14(ptr nonnull %.1175, ptr nonnull %excinfo.6, ptr %arg.state.6.4, double %arg.mass, ptr %.359, ptr %.1107, i64 %.285, ptr %arg.state.15.4, ptr %arg.state.11.4)
  %cond1 = icmp eq i32 %.1189, 0
  br i1 %cond1, label %B0.endif.endif.endif.endif.endif.endif, label %B0.endif.endif.endif.endif.endif.if, !prof !20

B672:                                             ; preds = %B548.endif.endif.endif.endif
  %.2858 = getelementptr inbounds nuw i8, ptr %arg.state.11.4, i64 1728
  %.91.i = getelementptr i8, ptr %arg.state.6.4, i64 56
  %.92.i = load double, ptr %.91.i, align 8, !noalias !213
  %.99.i = fdiv contract double 1.000000e+00, %.92.i
  %.251.i = load double, ptr %arg.state.11.4, align 8, !noalias !213
  %.259.i = fmul contract double %.99.i, 0x3FEAAAAAAAAAAAAB
  %.260.i = fmul contract double %.251.i, %.259.i
  store double %.260.i, ptr %.2858, align 8, !noalias !213
  %0 = getelementptr i8, ptr %arg.state.11.4, i64 8
  %.251.1.i = load double, ptr %0, align 8, !noalias !213
  %.259.1.i = fmul contract double %.99.i, 0x3FF2AAAAAAAAAAAB
  %.260.1.i = fmul contract double %.259.1.i, %.251.1.i
  %1 = getelementptr i8, ptr %arg.state.11.4, i64 1736
  store double %.260.1.i, ptr %1, align 8, !noalias !213
  %2 = getelementptr i8, ptr %arg.state.11.4, i64 16
  %.251.2.i = load double, ptr %2, align 8, !noalias !213
  %.259.2.i = fmul contract double %.99.i, 1.500000e+00
  %.260.2.i = fmul contract double %.259.2.i, %.251.2.i
  %3 = getelementptr i8, ptr %arg.state.11.4, i64 1744
  store double %.260.2.i, ptr %3, align 8, !noalias !213
  %4 = getelementptr i8, ptr %arg.state.11.4, i64 24
  %.251.3.i = load double, ptr %4, align 8, !noalias !213
  %.259.3.i = fmul contract double %.99.i, 0x3FFD555555555556
  %.260.3.i = fmul contract double %.259.3.i, %.251.3.i
  %5 = getelementptr i8, ptr %arg.state.11.4, i64 1752
  store double %.260.3.i, ptr %5, align 8, !noalias !213
  %6 = getelementptr i8, ptr %arg.state.11.4, i64 32
  %.251.4.i = load double, ptr %6, align 8, !noalias !213
  %.259.4.i = fmul contract double %.99.i, 0x4001555555555555
  %.260.4.i = fmul contract double %.259.4.i, %.251.4.i
  %7 = getelementptr i8, ptr %arg.state.11.4, i64 1760
  store double %.260.4.i, ptr %7, align 8, !noalias !213
  %8 = getelementptr i8, ptr %arg.state.11.4, i64 40
  %.251.5.i = load double, ptr %8, align 8, !noalias !213
  %.259.5.i = fmul contract double %.99.i, 2.500000e+00
  %.260.5.i = fmul contract double %.259.5.i, %.251.5.i
  %9 = getelementptr i8, ptr %arg.state.11.4, i64 1768
  store double %.260.5.i, ptr %9, align 8, !noalias !213
  %10 = getelementptr i8, ptr %arg.state.11.4, i64 48
  %.251.6.i = load double, ptr %10, align 8, !noalias !213
  %.259.6.i = fmul contract double %.99.i, 0x4006AAAAAAAAAAAB
  %.260.6.i = fmul contract double %.259.6.i, %.251.6.i
  %11 = getelementptr i8, ptr %arg.state.11.4, i64 1776
  store double %.260.6.i, ptr %11, align 8, !noalias !213
  %12 = getelementptr i8, ptr %arg.state.11.4, i64 56
  %.251.7.i = load double, ptr %12, align 8, !noalias !213
  %.259.7.i = fmul contract double %.99.i, 0x4009555555555556
  %.260.7.i = fmul contract double %.259.7.i, %.251.7.i
  %13 = getelementptr i8, ptr %arg.state.11.4, i64 1784
  store double %.260.7.i, ptr %13, align 8, !noalias !213
  %14 = getelementptr i8, ptr %.1107, i64 %.idx1.i
  %15 = getelementptr i8, ptr %14, i64 8
  %.330.i = getelementptr double, ptr %15, i64 %.849.i
  %.331.i = load double, ptr %.330.i, align 8, !noalias !213
  br label %B44.if.i.i

B1182:                                            ; preds = %_ZN17bnserve_surrogate8tangents7_series16fill_mass_seriesB4v256B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedEd5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit
  %16 = getelementptr double, ptr %.3186, i64 %.3022
  %.3255 = getelementptr i8, ptr %16, i64 -8
  %.3256 = load double, ptr %.3255, align 8
  %.3265 = load double, ptr %.3186, align 8
  %.3266 = fsub contract double %.3256, %.3265
  %.3268 = uitofp nneg i64 %.3082 to double
  %.3272 = fdiv contract double %.3268, %.3266
  br label %B4794

B4794:                                            ; preds = %_ZN17bnserve_surrogate8tangents7_series16fill_mass_seriesB4v256B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedEd5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit, %B1182
  %prepared_grid_v214__vphi308_0.2.0 = phi double [ %.3272, %B1182 ], [ 0.000000e+00, %_ZN17bnserve_surrogate8tangents7_series16fill_mass_seriesB4v256B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedEd5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit ]
  %.3312 = getelementptr i8, ptr %arg.state.0.4, i64 48
  %.3313 = load i64, ptr %.3312, align 8
  %.3321 = inttoptr i64 %.3313 to ptr
  %.3530.le = tail call contract double @llvm.log.f64(double %arg.mass)
  %.3615 = load double, ptr %.359, align 8
  %.3617 = fmul contract double %.3615, 0x3FEFFFFFFF768FA1
  %.3625.le = tail call contract double @llvm.log.f64(double %.3617)
  %.3630 = fsub contract double %.3625.le, %.3530.le
  store i64 0, ptr %.3676, align 8
  call fastcc void @inner_8(ptr nonnull %.3676, ptr %.3186, i64 %.3022, ptr %.3321, i64 %.3082, double %prepared_grid_v214__vphi308_0.2.0, double %.3630)
  %.3694 = load i64, ptr %.3676, align 8
  %.3766 = getelementptr i8, ptr %.359, i64 8
  %.3767 = load double, ptr %.3766, align 8
  %.3772 = fmul contract double %.3767, 0x3FF000000044B830
  %.3780.le = tail call contract double @llvm.log.f64(double %.3772)
  %.3785 = fsub contract double %.3780.le, %.3530.le
  store i64 0, ptr %.3831, align 8
  call fastcc void @inner_8(ptr nonnull %.3831, ptr %.3186, i64 %.3022, ptr %.3321, i64 %.3082, double %prepared_grid_v214__vphi308_0.2.0, double %.3785)
  %.3849 = load i64, ptr %.3831, align 8
  %.3906 = fsub contract double 0xC0126BB1BBB55515, %.3530.le
  store i64 0, ptr %.3952, align 8
  call fastcc void @inner_8(ptr nonnull %.3952, ptr %.3186, i64 %.3022, ptr %.3321, i64 %.3082, double %prepared_grid_v214__vphi308_0.2.0, double %.3906)
  %.3970 = load i64, ptr %.3952, align 8
  %.13.i = tail call i64 @llvm.smin.i64(i64 %.3849, i64 %.3970)
  %.4065 = fsub contract double 0xC00F4BD2B7AC1BAF, %.3530.le
  store i64 0, ptr %.4111, align 8
  call fastcc void @inner_8(ptr nonnull %.4111, ptr %.3186, i64 %.3022, ptr %.3321, i64 %.3082, double %prepared_grid_v214__vphi308_0.2.0, double %.4065)
  %.4129 = load i64, ptr %.4111, align 8
  %.13.i91 = tail call i64 @llvm.smin.i64(i64 %.3849, i64 %.4129)
  %.4298 = getelementptr i8, ptr %arg.state.1.4, i64 120
  %.4299 = load i64, ptr %.4298, align 8
  %17 = getelementptr double, ptr %arg.state.2.4, i64 %.4299
  %.4316 = getelementptr i8, ptr %17, i64 8
  %.4400 = getelementptr i8, ptr %arg.state.1.4, i64 64
  %.4401 = load i64, ptr %.4400, align 8
  %.135.i = load double, ptr %.3186, align 8, !noalias !216
  %.143.i = add nsw i64 %.4401, -2
  %.181.i = icmp slt i64 %.4401, 3
  %..143.i = select i1 %.181.i, i64 0, i64 %.143.i
  %.225207.i = icmp sgt i64 %..143.i, 0
  br i1 %.225207.i, label %B92.if.preheader.i, label %_ZN17bnserve_surrogate6kernel7_places9find_endsB4v258B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5TupleI5ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedExdE5ArrayIdLi1E1C7mutable7alignedExdx5ArrayIxLi1E1C7mutable7alignedE.exit

B4872:                                            ; preds = %_ZN17bnserve_surrogate6kernel7_places9find_endsB4v258B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5TupleI5ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedExdE5ArrayIdLi1E1C7mutable7alignedExdx5ArrayIxLi1E1C7mutable7alignedE.exit
  %.4546 = getelementptr i8, ptr %arg.state.1.4, i64 112
  %.4547 = load i64, ptr %.4546, align 8
  %18 = getelementptr double, ptr %arg.state.2.4, i64 %.4547
  %.4564 = getelementptr i8, ptr %18, i64 8
  %.4648 = getelementptr i8, ptr %arg.state.1.4, i64 56
  %.4649 = load i64, ptr %.4648, align 8
  %.135.i98 = load double, ptr %.3186, align 8, !noalias !219
  %.143.i99 = add nsw i64 %.4649, -2
  %.181.i100 = icmp slt i64 %.4649, 3
  %..143.i101 = select i1 %.181.i100, i64 0, i64 %.143.i99
  %.225207.i102 = icmp sgt i64 %..143.i101, 0
  br i1 %.225207.i102, label %B92.if.preheader.i106, label %_ZN17bnserve_surrogate6kernel7_places9find_endsB4v258B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5TupleI5ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedExdE5ArrayIdLi1E1C7mutable7alignedExdx5ArrayIxLi1E1C7mutable7alignedE.exit141

common.ret:                                       ; preds = %B548.endif.endif.endif.if, %B0.endif.endif.endif.endif.endif.if, %B4874
  %common.ret.op = phi i32 [ 0, %B4874 ], [ 1, %B0.endif.endif.endif.endif.endif.if ], [ 1, %B548.endif.endif.endif.if ]
  ret i32 %common.ret.op

B4874:                                            ; preds = %_ZN17bnserve_surrogate6kernel7_places9find_endsB4v258B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5TupleI5ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedExdE5ArrayIdLi1E1C7mutable7alignedExdx5ArrayIxLi1E1C7mutable7alignedE.exit141, %_ZN17bnserve_surrogate6kernel7_places9find_endsB4v258B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5TupleI5ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedExdE5ArrayIdLi1E1C7mutable7alignedExdx5ArrayIxLi1E1C7mutable7alignedE.exit
  store i64 %.3694, ptr %retptr, align 8
  %retptr.repack3256 = getelementptr inbounds nuw i8, ptr %retptr, i64 8
  store i64 %.3849, ptr %retptr.repack3256, align 8
  %retptr.repack3258 = getelementptr inbounds nuw i8, ptr %retptr, i64 16
  store i64 %.13.i, ptr %retptr.repack3258, align 8
  %retptr.repack3260 = getelementptr inbounds nuw i8, ptr %retptr, i64 24
  store i64 %.13.i91, ptr %retptr.repack3260, align 8
  br label %common.ret

B0.endif.endif.endif.endif.endif.if:              ; preds = %entry
  %.1190 = load ptr, ptr %excinfo.6, align 8
  store ptr %.1190, ptr %excinfo, align 8
  br label %common.ret

B0.endif.endif.endif.endif.endif.endif:           ; preds = %entry
  %.1199 = load double, ptr %.1175, align 8
  %.1243 = getelementptr i8, ptr %arg.state.11.4, i64 272
  store double %.1199, ptr %.1243, align 8
  %.1282 = getelementptr inbounds nuw i8, ptr %arg.state.10.0.4, i64 768
  %.1376 = getelementptr inbounds nuw i8, ptr %arg.state.10.1.4, i64 128
  %19 = shl i64 %arg.state.5, 3
  %20 = add i64 %19, 64
  %21 = mul i64 %arg.state.7.2, %20
  %22 = getelementptr i8, ptr %arg.state.3.4, i64 %21
  %scevgep311 = getelementptr i8, ptr %22, i64 %.1107.idx
  %23 = shl i64 %arg.state.7.2, 6
  %.112.i = fmul contract double %arg.mass, 0x400921FB54442D18
  %.113.i = tail call contract double @llvm.pow.f64(double %.112.i, double 0x3FD5555555555555)
  %.69.le.i.i = tail call contract double @llvm.log.f64(double %.113.i)
  %.79.i.i = fmul contract double %.113.i, %.113.i
  %.81.i.i = fmul contract double %.113.i, %.79.i.i
  %.83.i.i = fmul contract double %.113.i, %.81.i.i
  %.85.i.i = fmul contract double %.113.i, %.83.i.i
  %.89.i.i = fdiv contract double 1.000000e+00, %.85.i.i
  %.493.i2.i = fmul contract double %.69.le.i.i, 2.000000e+00
  %24 = lshr i64 %.285, 61
  %.849.i = and i64 %24, 4
  %.idx1.i = shl i64 %.285, 4
  %.897.i = icmp eq i64 %.285, 1
  %.927.i = getelementptr i8, ptr %.359, i64 16
  br label %B546.if

B546.if:                                          ; preds = %B548.endif.endif.endif.endif, %B0.endif.endif.endif.endif.endif.endif
  %excinfo.12.0 = phi ptr [ null, %B0.endif.endif.endif.endif.endif.endif ], [ %excinfo.12.1, %B548.endif.endif.endif.endif ]
  %lsr.iv10.pn = phi ptr [ %arg.state.11.4, %B0.endif.endif.endif.endif.endif.endif ], [ %lsr.iv10, %B548.endif.endif.endif.endif ]
  %lsr.iv = phi ptr [ %scevgep311, %B0.endif.endif.endif.endif.endif.endif ], [ %scevgep312, %B548.endif.endif.endif.endif ]
  %.151832723277 = phi i64 [ 0, %B0.endif.endif.endif.endif.endif.endif ], [ %.1525, %B548.endif.endif.endif.endif ]
  %lsr.iv10 = getelementptr i8, ptr %lsr.iv10.pn, i64 288
  %.143.i2 = load double, ptr %arg.state.11.4, align 8, !noalias !222
  %.idx.i3 = shl i64 %.151832723277, 6
  %25 = getelementptr i8, ptr %.1376, i64 %.idx.i3
  %.301.i = load double, ptr %25, align 8, !noalias !222
  %.303.i = fmul contract double %.143.i2, %.301.i
  store double %.303.i, ptr %lsr.iv10, align 8, !noalias !222
  %.336.i = fmul contract double %.113.i, %.143.i2
  %26 = getelementptr i8, ptr %25, i64 8
  %.301.1.i = load double, ptr %26, align 8, !noalias !222
  %.303.1.i = fmul contract double %.336.i, %.301.1.i
  %27 = getelementptr i8, ptr %lsr.iv10.pn, i64 296
  store double %.303.1.i, ptr %27, align 8, !noalias !222
  %.336.1.i = fmul contract double %.113.i, %.336.i
  %28 = getelementptr i8, ptr %25, i64 16
  %.301.2.i = load double, ptr %28, align 8, !noalias !222
  %.303.2.i = fmul contract double %.336.1.i, %.301.2.i
  %29 = getelementptr i8, ptr %lsr.iv10.pn, i64 304
  store double %.303.2.i, ptr %29, align 8, !noalias !222
  %.336.2.i = fmul contract double %.113.i, %.336.1.i
  %30 = getelementptr i8, ptr %25, i64 24
  %.301.3.i = load double, ptr %30, align 8, !noalias !222
  %.303.3.i = fmul contract double %.336.2.i, %.301.3.i
  %31 = getelementptr i8, ptr %lsr.iv10.pn, i64 312
  store double %.303.3.i, ptr %31, align 8, !noalias !222
  %.336.3.i = fmul contract double %.113.i, %.336.2.i
  %32 = getelementptr i8, ptr %25, i64 32
  %.301.4.i = load double, ptr %32, align 8, !noalias !222
  %.303.4.i = fmul contract double %.336.3.i, %.301.4.i
  %33 = getelementptr i8, ptr %lsr.iv10.pn, i64 320
  store double %.303.4.i, ptr %33, align 8, !noalias !222
  %.336.4.i = fmul contract double %.113.i, %.336.3.i
  %34 = getelementptr i8, ptr %25, i64 40
  %.301.5.i = load double, ptr %34, align 8, !noalias !222
  %.303.5.i = fmul contract double %.336.4.i, %.301.5.i
  %35 = getelementptr i8, ptr %lsr.iv10.pn, i64 328
  store double %.303.5.i, ptr %35, align 8, !noalias !222
  %.336.5.i = fmul contract double %.113.i, %.336.4.i
  %36 = getelementptr i8, ptr %25, i64 48
  %.301.6.i = load double, ptr %36, align 8, !noalias !222
  %.303.6.i = fmul contract double %.336.5.i, %.301.6.i
  %37 = getelementptr i8, ptr %lsr.iv10.pn, i64 336
  store double %.303.6.i, ptr %37, align 8, !noalias !222
  %.336.6.i = fmul contract double %.113.i, %.336.5.i
  %38 = getelementptr i8, ptr %25, i64 56
  %.301.7.i = load double, ptr %38, align 8, !noalias !222
  %.303.7.i = fmul contract double %.336.6.i, %.301.7.i
  %39 = getelementptr i8, ptr %lsr.iv10.pn, i64 344
  store double %.303.7.i, ptr %39, align 8, !noalias !222
  %.373.idx.i = mul nuw nsw i64 %.151832723277, 384
  %.373.i = getelementptr i8, ptr %.1282, i64 %.373.idx.i
  %.590.i = getelementptr i8, ptr %lsr.iv10.pn, i64 352
  %scevgep26.i = getelementptr i8, ptr %.373.i, i64 256
  %scevgep11.i = getelementptr i8, ptr %lsr.iv10.pn, i64 440
  br label %B154.if.i.i

B380.i:                                           ; preds = %_ZN17bnserve_surrogate6kernel7_series17fill_phase_powersB4v251B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dEd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i
  %.928.i = load double, ptr %.927.i, align 8, !noalias !222
  %.929.i = fcmp contract ogt double %.928.i, 0.000000e+00
  br i1 %.929.i, label %B404.i, label %B486.i

B404.i:                                           ; preds = %B380.i
  %.25.i.i = fmul contract double %.928.i, 0x400921FB54442D18
  %.26.i.i = tail call contract double @llvm.pow.f64(double %.25.i.i, double 0x3FD5555555555555)
  %.147.i.i.i = fmul contract double %.26.i.i, %.26.i.i
  %.147.i.1.i.i = fmul contract double %.147.i.i.i, %.147.i.i.i
  %.127.i.2.i.i = fmul contract double %.26.i.i, %.147.i.1.i.i
  %.38.le.i.i = tail call contract double @llvm.log.f64(double %.26.i.i)
  %.168.i.i.i = fcmp une double %.127.i.2.i.i, 0.000000e+00
  br i1 %.168.i.i.i, label %B134.if.lr.ph.i.i, label %_ZN17bnserve_surrogate6kernel7_series8legendreB4v252B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dEd5ArrayIdLi2E1C7mutable7alignedE.exit.i, !prof !20

B134.if.lr.ph.i.i:                                ; preds = %B404.i
  %.175.i.i.i = fdiv contract double 1.000000e+00, %.127.i.2.i.i
  %.423.i.i = fmul contract double %.38.le.i.i, 2.000000e+00
  br label %B134.if.i.i

B134.if.i.i:                                      ; preds = %B134.if.i.i, %B134.if.lr.ph.i.i
  %lsr.iv1.i = phi i64 [ %lsr.iv.next2.i, %B134.if.i.i ], [ -16, %B134.if.lr.ph.i.i ]
  %power.2.0146.i.i = phi double [ %.493.i.i, %B134.if.i.i ], [ %.175.i.i.i, %B134.if.lr.ph.i.i ]
  %result.2.0145.i.i = phi double [ %.488.i.i, %B134.if.i.i ], [ 0.000000e+00, %B134.if.lr.ph.i.i ]
  %40 = add nsw i64 %lsr.iv1.i, 11
  %41 = shl nsw i64 %lsr.iv1.i, 3
  %scevgep10.i = getelementptr i8, ptr %scevgep26.i, i64 %41
  %scevgep9.i = getelementptr i8, ptr %scevgep10.i, i64 -128
  %.249.i.i = load double, ptr %scevgep9.i, align 8, !noalias !226
  %.303.i.i = load double, ptr %scevgep10.i, align 8, !noalias !226
  %scevgep4.i = getelementptr i8, ptr %scevgep10.i, i64 128
  %.357.i.i = load double, ptr %scevgep4.i, align 8, !noalias !226
  %.359.i.i5 = fmul contract double %.38.le.i.i, %.357.i.i
  %.360.i.i = fadd contract double %.303.i.i, %.359.i.i5
  %.362.i.i = fmul contract double %.38.le.i.i, %.360.i.i
  %.363.i.i = fadd contract double %.249.i.i, %.362.i.i
  %.365.i.i = sitofp i64 %40 to double
  %.366.i.i = fmul contract double %.363.i.i, %.365.i.i
  %.421.i.i = fadd contract double %.303.i.i, %.366.i.i
  %.478.i.i = fmul contract double %.423.i.i, %.357.i.i
  %.479.i.i = fadd contract double %.478.i.i, %.421.i.i
  %.483.i.i = fdiv contract double %.479.i.i, 3.000000e+00
  %.484.i.i = fsub contract double %.363.i.i, %.483.i.i
  %.486.i.i = fmul contract double %power.2.0146.i.i, %.484.i.i
  %.488.i.i = fadd contract double %result.2.0145.i.i, %.486.i.i
  %.493.i.i = fmul contract double %.26.i.i, %power.2.0146.i.i
  %ov.i = icmp eq i64 %lsr.iv1.i, -1
  %lsr.iv.next2.i = add nsw i64 %lsr.iv1.i, 1
  br i1 %ov.i, label %_ZN17bnserve_surrogate6kernel7_series8legendreB4v252B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dEd5ArrayIdLi2E1C7mutable7alignedE.exit.i, label %B134.if.i.i

_ZN17bnserve_surrogate6kernel7_series8legendreB4v252B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dEd5ArrayIdLi2E1C7mutable7alignedE.exit.i: ; preds = %B134.if.i.i, %B404.i
  %.998.0.i = phi double [ 0.000000e+00, %B404.i ], [ %.488.i.i, %B134.if.i.i ]
  %excinfo.3.0.i = phi ptr [ null, %B404.i ], [ null, %B134.if.i.i ]
  br i1 %.168.i.i.i, label %B404.endif.i, label %_ZN17bnserve_surrogate8tangents7_series19fill_tangent_seriesB4v253B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIdLi1E1C7mutable7alignedEd5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit, !prof !20

B486.i:                                           ; preds = %B404.endif.i, %_ZN17bnserve_surrogate6kernel7_series17fill_phase_powersB4v251B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dEd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i, %B380.i
  %42 = getelementptr i8, ptr %45, i64 8
  %.1110.i = getelementptr double, ptr %42, i64 %.849.i
  %.1111.i = load double, ptr %.1110.i, align 8, !noalias !222
  %.1118.i = fmul contract double %arg.mass, %.1111.i
  %.1121.i = fsub contract double 0.000000e+00, %.1118.i
  %.1150.i = getelementptr i8, ptr %lsr.iv10.pn, i64 552
  store double %.1121.i, ptr %.1150.i, align 8, !noalias !222
  %.1153.i = icmp eq i64 %.151832723277, 0
  br i1 %.1153.i, label %B574.i, label %B666.i

B574.i:                                           ; preds = %B486.i
  %.1186.i = load double, ptr %.1243, align 8, !noalias !222
  %.1222.i = load double, ptr %arg.state.6.4, align 8, !noalias !222
  %.1228.i = fsub contract double 1.000000e+00, %.1222.i
  %.1229.i = fadd contract double %.1222.i, 1.000000e+00
  %.1230.i = fmul contract double %.1222.i, %.1229.i
  %.1234.i = fdiv contract double %.1228.i, %.1230.i
  %.1235.i = fmul contract double %.1186.i, %.1234.i
  br label %B666.i

B666.i:                                           ; preds = %B574.i, %B486.i
  %"$phi666.0.2.0.i" = phi double [ %.1235.i, %B574.i ], [ 0.000000e+00, %B486.i ]
  %.1282.i = getelementptr i8, ptr %lsr.iv10.pn, i64 560
  store double %"$phi666.0.2.0.i", ptr %.1282.i, align 8, !noalias !222
  br label %_ZN17bnserve_surrogate8tangents7_series19fill_tangent_seriesB4v253B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIdLi1E1C7mutable7alignedEd5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit

B278.i.i:                                         ; preds = %B154.if.i.i
  %.491.i.i = load double, ptr %scevgep18.i, align 8, !noalias !230
  %.548.i.i = load double, ptr %scevgep15.i, align 8, !noalias !230
  %.549.i.i = fmul contract double %.493.i2.i, %.548.i.i
  %.550.i.i = fadd contract double %.491.i.i, %.549.i.i
  %.552.i.i = fmul contract double %power.2.0232.i.i, %.550.i.i
  %.556.i.i = fdiv contract double %.552.i.i, 3.000000e+00
  %scevgep12.i = getelementptr i8, ptr %scevgep11.i, i64 %44
  store double %.556.i.i, ptr %scevgep12.i, align 8, !noalias !230
  br label %B356.i.i

B356.i.i:                                         ; preds = %B154.if.i.i, %B278.i.i
  %.596.i.i = fmul contract double %.113.i, %power.2.0232.i.i
  %lsr.iv.next.i = add nuw nsw i64 %lsr.iv.i, 1
  %exitcond.not.i7.i = icmp eq i64 %lsr.iv.next.i, 16
  br i1 %exitcond.not.i7.i, label %_ZN17bnserve_surrogate6kernel7_series17fill_phase_powersB4v251B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dEd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i, label %B154.if.i.i

B154.if.i.i:                                      ; preds = %B356.i.i, %B546.if
  %lsr.iv.i = phi i64 [ %lsr.iv.next.i, %B356.i.i ], [ 0, %B546.if ]
  %power.2.0232.i.i = phi double [ %.596.i.i, %B356.i.i ], [ %.89.i.i, %B546.if ]
  %43 = add nsw i64 %lsr.iv.i, -5
  %44 = shl nuw nsw i64 %lsr.iv.i, 3
  %scevgep15.i = getelementptr i8, ptr %scevgep26.i, i64 %44
  %scevgep20.i = getelementptr i8, ptr %scevgep15.i, i64 -256
  %.269.i.i = load double, ptr %scevgep20.i, align 8, !noalias !230
  %scevgep18.i = getelementptr i8, ptr %scevgep15.i, i64 -128
  %.324.i.i = load double, ptr %scevgep18.i, align 8, !noalias !230
  %.379.i.i = load double, ptr %scevgep15.i, align 8, !noalias !230
  %.381.i.i = fmul contract double %.69.le.i.i, %.379.i.i
  %.382.i.i = fadd contract double %.324.i.i, %.381.i.i
  %.384.i.i = fmul contract double %.69.le.i.i, %.382.i.i
  %.385.i.i = fadd contract double %.269.i.i, %.384.i.i
  %.387.i.i = fmul contract double %power.2.0232.i.i, %.385.i.i
  %scevgep13.i = getelementptr i8, ptr %.590.i, i64 %44
  store double %.387.i.i, ptr %scevgep13.i, align 8, !noalias !230
  %or.cond.i.i4 = icmp ult i64 %43, 7
  br i1 %or.cond.i.i4, label %B278.i.i, label %B356.i.i

_ZN17bnserve_surrogate6kernel7_series17fill_phase_powersB4v251B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dEd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i: ; preds = %B356.i.i
  %.671.i.i = getelementptr i8, ptr %.373.i, i64 320
  %.672.i.i = load double, ptr %.671.i.i, align 8, !noalias !230
  %.680.i.i = fmul contract double %.112.i, %.672.i.i
  %.684.i.i = fdiv contract double %.680.i.i, 9.000000e+00
  %sunkaddr27.i = getelementptr i8, ptr %lsr.iv10.pn, i64 536
  store double %.684.i.i, ptr %sunkaddr27.i, align 8, !noalias !230
  %45 = getelementptr i8, ptr %lsr.iv, i64 %.idx1.i
  %.863.i = getelementptr double, ptr %45, i64 %.849.i
  %.864.i = load double, ptr %.863.i, align 8, !noalias !222
  %.865.i = fsub contract double 0.000000e+00, %.864.i
  %.894.i = getelementptr i8, ptr %lsr.iv10.pn, i64 544
  store double %.865.i, ptr %.894.i, align 8, !noalias !222
  br i1 %.897.i, label %B380.i, label %B486.i

B404.endif.i:                                     ; preds = %_ZN17bnserve_surrogate6kernel7_series8legendreB4v252B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dEd5ArrayIdLi2E1C7mutable7alignedE.exit.i
  %.1033.i = fadd contract double %.865.i, %.998.0.i
  store double %.1033.i, ptr %.894.i, align 8, !noalias !222
  br label %B486.i

_ZN17bnserve_surrogate8tangents7_series19fill_tangent_seriesB4v253B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIdLi1E1C7mutable7alignedEd5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit: ; preds = %_ZN17bnserve_surrogate6kernel7_series8legendreB4v252B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dEd5ArrayIdLi2E1C7mutable7alignedE.exit.i, %B666.i
  %excinfo.12.1 = phi ptr [ %excinfo.12.0, %B666.i ], [ %excinfo.3.0.i, %_ZN17bnserve_surrogate6kernel7_series8legendreB4v252B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dEd5ArrayIdLi2E1C7mutable7alignedE.exit.i ]
  %cond = phi i1 [ true, %B666.i ], [ false, %_ZN17bnserve_surrogate6kernel7_series8legendreB4v252B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dEd5ArrayIdLi2E1C7mutable7alignedE.exit.i ]
  br i1 %cond, label %B548.endif.endif.endif.endif, label %B548.endif.endif.endif.if, !prof !20

B548.endif.endif.endif.if:                        ; preds = %_ZN17bnserve_surrogate8tangents7_series19fill_tangent_seriesB4v253B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIdLi1E1C7mutable7alignedEd5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit
  store ptr %excinfo.12.1, ptr %excinfo, align 8
  br label %common.ret

B548.endif.endif.endif.endif:                     ; preds = %_ZN17bnserve_surrogate8tangents7_series19fill_tangent_seriesB4v253B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIdLi1E1C7mutable7alignedEd5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit
  %.1525 = add nuw nsw i64 %.151832723277, 1
  %scevgep312 = getelementptr i8, ptr %lsr.iv, i64 %23
  %exitcond.not = icmp eq i64 %.1525, 5
  br i1 %exitcond.not, label %B672, label %B546.if

B158.i.i:                                         ; preds = %B44.if.i.i
  %sunkaddr13 = getelementptr i8, ptr %sunkaddr21, i64 152
  %.284.i.i = load double, ptr %sunkaddr13, align 8, !noalias !233
  %.318.i.i = fmul contract double %.99.i, %.284.i.i
  %.319.i.i = fadd contract double %.201.i.i, %.318.i.i
  store double %.319.i.i, ptr %sunkaddr25, align 8, !noalias !233
  %.359.i.i = fmul contract double %.200.i.i, %.318.i.i
  %sunkaddr19 = getelementptr i8, ptr %sunkaddr21, i64 1880
  store double %.359.i.i, ptr %sunkaddr19, align 8, !noalias !233
  br label %B309.i.i

B309.i.i:                                         ; preds = %B44.if.i.i, %B158.i.i
  %exitcond.not.i.i = icmp eq i64 %.132.i.i, 16
  br i1 %exitcond.not.i.i, label %_ZN17bnserve_surrogate8tangents7_series16fill_mass_seriesB4v256B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedEd5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit, label %B44.if.i.i

B44.if.i.i:                                       ; preds = %B309.i.i, %B672
  %.125233235.i.i = phi i64 [ %.132.i.i, %B309.i.i ], [ 0, %B672 ]
  %.132.i.i = add nuw nsw i64 %.125233235.i.i, 1
  %sunkaddr20 = shl i64 %.125233235.i.i, 3
  %sunkaddr21 = getelementptr i8, ptr %arg.state.11.4, i64 %sunkaddr20
  %sunkaddr22 = getelementptr i8, ptr %sunkaddr21, i64 64
  %.191.i.i = load double, ptr %sunkaddr22, align 8, !noalias !233
  %.193.i.i = fmul contract double %.99.i, %.191.i.i
  %46 = add nsw i64 %.125233235.i.i, -5
  %.196.i.i = sitofp i64 %46 to double
  %.200.i.i = fdiv contract double %.196.i.i, 3.000000e+00
  %.201.i.i = fmul contract double %.193.i.i, %.200.i.i
  %sunkaddr25 = getelementptr i8, ptr %sunkaddr21, i64 1792
  store double %.201.i.i, ptr %sunkaddr25, align 8, !noalias !233
  %or.cond.i.i = icmp ult i64 %46, 7
  br i1 %or.cond.i.i, label %B158.i.i, label %B309.i.i

_ZN17bnserve_surrogate8tangents7_series16fill_mass_seriesB4v256B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedEd5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit: ; preds = %B309.i.i
  %.338.i = fmul contract double %arg.mass, %.331.i
  %.341.i = fsub contract double 0.000000e+00, %.338.i
  %.432.i.i = getelementptr i8, ptr %arg.state.11.4, i64 1944
  %.433.i.i = load double, ptr %.432.i.i, align 8, !noalias !233
  %.435.i.i = fmul contract double %.99.i, 2.000000e+00
  %.465.i.i = getelementptr i8, ptr %arg.state.11.4, i64 248
  %.466.i.i = load double, ptr %.465.i.i, align 8, !noalias !233
  %.467.i.i = fmul contract double %.435.i.i, %.466.i.i
  %.468.i.i = fadd contract double %.433.i.i, %.467.i.i
  store double %.468.i.i, ptr %.432.i.i, align 8, !noalias !233
  %.536.i.i = fmul contract double %.99.i, %.466.i.i
  %.566.i.i = getelementptr i8, ptr %arg.state.11.4, i64 1976
  store double %.536.i.i, ptr %.566.i.i, align 8, !noalias !233
  %.570.i.i = fmul contract double %.99.i, %.341.i
  %.603.i.i = getelementptr i8, ptr %arg.state.11.4, i64 1984
  store double 0.000000e+00, ptr %.603.i.i, align 8, !noalias !233
  %.633.i.i = getelementptr i8, ptr %arg.state.11.4, i64 1992
  store double %.570.i.i, ptr %.633.i.i, align 8, !noalias !233
  %.406.i = load double, ptr %.1243, align 8, !noalias !213
  %.412.i = fmul contract double %.435.i.i, %.406.i
  %.441.i = getelementptr i8, ptr %arg.state.11.4, i64 2000
  store double %.412.i, ptr %.441.i, align 8, !noalias !213
  %.3021 = getelementptr i8, ptr %arg.state.0.4, i64 16
  %.3022 = load i64, ptr %.3021, align 8
  %.3051 = getelementptr i8, ptr %arg.state.0.4, i64 32
  %.3052 = load i64, ptr %.3051, align 8
  %.3081 = getelementptr i8, ptr %arg.state.0.4, i64 40
  %.3082 = load i64, ptr %.3081, align 8
  %.3118 = getelementptr i8, ptr %arg.state.0.4, i64 24
  %.3119 = load i64, ptr %.3118, align 8
  %.3121 = inttoptr i64 %.3119 to ptr
  %.3186 = getelementptr inbounds double, ptr %.3121, i64 %.3052
  %.3244 = icmp sgt i64 %.3082, 0
  br i1 %.3244, label %B1182, label %B4794

B92.if.preheader.i:                               ; preds = %B4794
  %47 = add i64 %.3849, -1
  %48 = shl i64 %.3052, 3
  %49 = getelementptr i8, ptr %.3121, i64 %48
  %scevgep301 = getelementptr i8, ptr %49, i64 8
  br label %B92.if.i

B146.i:                                           ; preds = %B92.if.i
  %.291.i = fsub contract double %.281.i, %.135.i
  %.293.i = fmul contract double %prepared_grid_v214__vphi308_0.2.0, %.291.i
  %.5.i.i = fptosi double %.293.i to i64
  %.13.i5.i = tail call i64 @llvm.smin.i64(i64 %.3082, i64 %.5.i.i)
  %.354.i = getelementptr inbounds i64, ptr %.3321, i64 %.13.i5.i
  %.355.i = load i64, ptr %.354.i, align 8, !noalias !216
  %.13.i6.i = tail call i64 @llvm.smax.i64(i64 %.355.i, i64 %end.3.0210.i)
  %.395.i = icmp slt i64 %.13.i6.i, %.3849
  br i1 %.395.i, label %B284.i, label %B386.i

B284.i:                                           ; preds = %B146.i
  %.412.i97 = getelementptr inbounds nuw double, ptr %.3186, i64 %.13.i6.i
  %.413.i = load double, ptr %.412.i97, align 8, !noalias !216
  %.417.i = fcmp contract ugt double %.413.i, %.281.i
  br i1 %.417.i, label %B386.i, label %B324.i

B324.i:                                           ; preds = %B284.i, %B346.i
  %end.5.2.i = phi i64 [ %.423.i, %B346.i ], [ %.13.i6.i, %B284.i ]
  %exitcond.not.i = icmp eq i64 %47, %end.5.2.i
  br i1 %exitcond.not.i, label %B386.i, label %B346.i

B346.i:                                           ; preds = %B324.i
  %.423.i = add i64 %end.5.2.i, 1
  %50 = shl i64 %end.5.2.i, 3
  %scevgep302 = getelementptr i8, ptr %scevgep301, i64 %50
  %.451.i = load double, ptr %scevgep302, align 8, !noalias !216
  %.455.i = fcmp contract ugt double %.451.i, %.281.i
  br i1 %.455.i, label %B386.i, label %B324.i

B386.i:                                           ; preds = %B346.i, %B324.i, %B92.if.i, %B284.i, %B146.i
  %end.4.1.i = phi i64 [ %.13.i6.i, %B146.i ], [ %end.3.0210.i, %B92.if.i ], [ %.13.i6.i, %B284.i ], [ %.3849, %B324.i ], [ %.423.i, %B346.i ]
  %.13.i.i = tail call i64 @llvm.smin.i64(i64 %.3849, i64 %end.4.1.i)
  %51 = getelementptr i64, ptr %arg.state.9.1.4, i64 %.231203208.i
  store i64 %.13.i.i, ptr %51, align 8, !noalias !216
  %exitcond216.not.i = icmp eq i64 %.238.i, %..143.i
  br i1 %exitcond216.not.i, label %_ZN17bnserve_surrogate6kernel7_places9find_endsB4v258B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5TupleI5ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedExdE5ArrayIdLi1E1C7mutable7alignedExdx5ArrayIxLi1E1C7mutable7alignedE.exit, label %B92.if.i

B92.if.i:                                         ; preds = %B386.i, %B92.if.preheader.i
  %end.3.0210.i = phi i64 [ %end.4.1.i, %B386.i ], [ 0, %B92.if.preheader.i ]
  %.231203208.i = phi i64 [ %.238.i, %B386.i ], [ 0, %B92.if.preheader.i ]
  %.238.i = add nuw nsw i64 %.231203208.i, 1
  %.278.i = getelementptr inbounds nuw double, ptr %.4316, i64 %.231203208.i
  %.279.i = load double, ptr %.278.i, align 8, !noalias !216
  %.281.i = fsub contract double %.279.i, %.3530.le
  %.287.i = fcmp contract ult double %.281.i, %.135.i
  br i1 %.287.i, label %B386.i, label %B146.i

_ZN17bnserve_surrogate6kernel7_places9find_endsB4v258B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5TupleI5ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedExdE5ArrayIdLi1E1C7mutable7alignedExdx5ArrayIxLi1E1C7mutable7alignedE.exit: ; preds = %B386.i, %B4794
  %.586.inv.i = icmp sgt i64 %.4401, 1
  %.587.i = select i1 %.586.inv.i, i64 0, i64 %arg.state.9.1.5.0
  %52 = getelementptr i64, ptr %arg.state.9.1.4, i64 %.143.i
  %.601.i = getelementptr i64, ptr %52, i64 %.587.i
  store i64 %.3849, ptr %.601.i, align 8, !noalias !216
  %.4501 = getelementptr i8, ptr %arg.state.1.4, i64 72
  %.4502 = load i64, ptr %.4501, align 8
  %.4506 = icmp eq i64 %.4502, 0
  br i1 %.4506, label %B4872, label %B4874

B92.if.preheader.i106:                            ; preds = %B4872
  %53 = add i64 %.3849, -1
  %54 = shl i64 %.3052, 3
  %55 = getelementptr i8, ptr %.3121, i64 %54
  %scevgep = getelementptr i8, ptr %55, i64 8
  br label %B92.if.i107

B146.i115:                                        ; preds = %B92.if.i107
  %.291.i116 = fsub contract double %.281.i113, %.135.i98
  %.293.i117 = fmul contract double %prepared_grid_v214__vphi308_0.2.0, %.291.i116
  %.5.i.i118 = fptosi double %.293.i117 to i64
  %.13.i5.i119 = tail call i64 @llvm.smin.i64(i64 %.3082, i64 %.5.i.i118)
  %.354.i120 = getelementptr inbounds i64, ptr %.3321, i64 %.13.i5.i119
  %.355.i121 = load i64, ptr %.354.i120, align 8, !noalias !219
  %.13.i6.i122 = tail call i64 @llvm.smax.i64(i64 %.355.i121, i64 %end.3.0210.i108)
  %.395.i123 = icmp slt i64 %.13.i6.i122, %.3849
  br i1 %.395.i123, label %B284.i128, label %B386.i124

B284.i128:                                        ; preds = %B146.i115
  %.412.i129 = getelementptr inbounds nuw double, ptr %.3186, i64 %.13.i6.i122
  %.413.i130 = load double, ptr %.412.i129, align 8, !noalias !219
  %.417.i131 = fcmp contract ugt double %.413.i130, %.281.i113
  br i1 %.417.i131, label %B386.i124, label %B324.i132

B324.i132:                                        ; preds = %B284.i128, %B346.i135
  %end.5.2.i133 = phi i64 [ %.423.i136, %B346.i135 ], [ %.13.i6.i122, %B284.i128 ]
  %exitcond.not.i134 = icmp eq i64 %53, %end.5.2.i133
  br i1 %exitcond.not.i134, label %B386.i124, label %B346.i135

B346.i135:                                        ; preds = %B324.i132
  %.423.i136 = add i64 %end.5.2.i133, 1
  %56 = shl i64 %end.5.2.i133, 3
  %scevgep300 = getelementptr i8, ptr %scevgep, i64 %56
  %.451.i139 = load double, ptr %scevgep300, align 8, !noalias !219
  %.455.i140 = fcmp contract ugt double %.451.i139, %.281.i113
  br i1 %.455.i140, label %B386.i124, label %B324.i132

B386.i124:                                        ; preds = %B346.i135, %B324.i132, %B92.if.i107, %B284.i128, %B146.i115
  %end.4.1.i125 = phi i64 [ %.13.i6.i122, %B146.i115 ], [ %end.3.0210.i108, %B92.if.i107 ], [ %.13.i6.i122, %B284.i128 ], [ %.3849, %B324.i132 ], [ %.423.i136, %B346.i135 ]
  %.13.i.i126 = tail call i64 @llvm.smin.i64(i64 %.3849, i64 %end.4.1.i125)
  %57 = getelementptr i64, ptr %arg.state.9.0.4, i64 %.231203208.i109
  store i64 %.13.i.i126, ptr %57, align 8, !noalias !219
  %exitcond216.not.i127 = icmp eq i64 %.238.i110, %..143.i101
  br i1 %exitcond216.not.i127, label %_ZN17bnserve_surrogate6kernel7_places9find_endsB4v258B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5TupleI5ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedExdE5ArrayIdLi1E1C7mutable7alignedExdx5ArrayIxLi1E1C7mutable7alignedE.exit141, label %B92.if.i107

B92.if.i107:                                      ; preds = %B386.i124, %B92.if.preheader.i106
  %end.3.0210.i108 = phi i64 [ %end.4.1.i125, %B386.i124 ], [ 0, %B92.if.preheader.i106 ]
  %.231203208.i109 = phi i64 [ %.238.i110, %B386.i124 ], [ 0, %B92.if.preheader.i106 ]
  %.238.i110 = add nuw nsw i64 %.231203208.i109, 1
  %.278.i111 = getelementptr inbounds nuw double, ptr %.4564, i64 %.231203208.i109
  %.279.i112 = load double, ptr %.278.i111, align 8, !noalias !219
  %.281.i113 = fsub contract double %.279.i112, %.3530.le
  %.287.i114 = fcmp contract ult double %.281.i113, %.135.i98
  br i1 %.287.i114, label %B386.i124, label %B146.i115

_ZN17bnserve_surrogate6kernel7_places9find_endsB4v258B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5TupleI5ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedExdE5ArrayIdLi1E1C7mutable7alignedExdx5ArrayIxLi1E1C7mutable7alignedE.exit141: ; preds = %B386.i124, %B4872
  %.586.inv.i103 = icmp sgt i64 %.4649, 1
  %.587.i104 = select i1 %.586.inv.i103, i64 0, i64 %arg.state.9.0.5.0
  %58 = getelementptr i64, ptr %arg.state.9.0.4, i64 %.143.i99
  %.601.i105 = getelementptr i64, ptr %58, i64 %.587.i104
  store i64 %.3849, ptr %.601.i105, align 8, !noalias !219
  br label %B4874
}

; Function Attrs: mustprogress nocallback nocreateundeforpoison nofree nosync nounwind speculatable willreturn memory(none)
declare <8 x double> @llvm.fma.v8f64(<8 x double>, <8 x double>, <8 x double>) #2

; Function Attrs: mustprogress nocallback nocreateundeforpoison nofree nosync nounwind speculatable willreturn memory(none)
declare double @llvm.pow.f64(double, double) #2

; Function Attrs: mustprogress nocallback nocreateundeforpoison nofree nosync nounwind speculatable willreturn memory(none)
declare <8 x double> @llvm.minnum.v8f64(<8 x double>, <8 x double>) #2

; Function Attrs: nofree noinline norecurse nosync nounwind memory(argmem: readwrite)
define internal fastcc noundef range(i32 0, 2) i32 @inner_14(ptr noalias nonnull writeonly captures(none) %retptr, ptr noalias nonnull writeonly captures(none) %excinfo, ptr readonly captures(none) %arg.row.4, double %arg.unit, ptr readonly captures(none) %arg.band.4, ptr readonly captures(none) %arg.gauge.4, i64 %arg.alignment, ptr initializes((0, 384)) %arg.room.4, ptr writeonly captures(none) initializes((0, 64)) %arg.out.4) unnamed_addr #3 {
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
  store double 1.000000e+00, ptr %arg.out.4, align 8, !noalias !236
  %.138.i = getelementptr i8, ptr %arg.out.4, i64 8
  store double 0.000000e+00, ptr %.138.i, align 8, !noalias !236
  %.140.i = fmul contract double %.35.i, 0x400579E79E79E79E
  %.141.i = fadd contract double %.140.i, 0xBFF7124924924925
  %.169.i = getelementptr i8, ptr %arg.out.4, i64 16
  store double %.141.i, ptr %.169.i, align 8, !noalias !236
  %.171.i = fmul contract double %.55.i, 3.375000e+00
  %.172.i = fmul contract double %.35.i, 0x3FFD555555555555
  %.173.i = fsub contract double 3.375000e+00, %.172.i
  %.174.i = fmul contract double %.52.i, %.173.i
  %.175.i = fadd contract double %.171.i, %.174.i
  %.203.i = getelementptr i8, ptr %arg.out.4, i64 24
  store double %.175.i, ptr %.203.i, align 8, !noalias !236
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
  store double %.362.i3, ptr %.236.i, align 8, !noalias !236
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
  store double %.463.i, ptr %.427.i, align 8, !noalias !236
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
  store double %.886.i, ptr %.548.i4, align 8, !noalias !236
  %.916.i = fmul contract double %.35.i, 0x402001CC877321DD
  %.917.i = fsub contract double 0x403044E0D8B8362E, %.916.i
  %.918.i = fmul contract double %.35.i, %.917.i
  %.919.i = fsub contract double 0x400A4763546E2A71, %.918.i
  %.920.i = fmul contract double %.919.i, 0x400921FB54442D18
  %.948.i = getelementptr i8, ptr %arg.out.4, i64 56
  store double %.920.i, ptr %.948.i, align 8, !noalias !236
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
  tail call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(384) %arg.room.4, i8 0, i64 384, i1 false), !noalias !239
  %.33.i = fdiv contract double %.107, %.5.i
  %.38.i = fdiv contract double 1.000000e+00, %.5.i
  %.39.i6 = fmul contract double %.33.i, %.38.i
  store double 1.000000e+00, ptr %arg.room.4, align 8, !noalias !242
  %.183.i.i = getelementptr i8, ptr %arg.room.4, i64 16
  %.203.i.i = fmul contract double %.39.i6, 0x401871C71C71C71C
  %.204.i.i = fadd contract double %.203.i.i, 0x4013A7F529FD4A7F
  store double %.204.i.i, ptr %.183.i.i, align 8, !noalias !242
  %.308.i.i = getelementptr i8, ptr %arg.room.4, i64 24
  %.309.i.i = load double, ptr %.308.i.i, align 8, !noalias !242
  %.310.i2.i = fadd contract double %.309.i.i, 0xC04921FB54442D18
  store double %.310.i2.i, ptr %.308.i.i, align 8, !noalias !242
  %.413.i.i = getelementptr i8, ptr %arg.room.4, i64 32
  %.414.i.i = load double, ptr %.413.i.i, align 8, !noalias !242
  %.454.i.i = fmul contract double %.39.i6, 0x40456C71C71C71C7
  %.455.i.i = fadd contract double %.454.i.i, 0x404AEDF7DF7DF7DF
  %.456.i.i = fmul contract double %.39.i6, %.455.i.i
  %.457.i.i = fadd contract double %.456.i.i, 0x403E1A683B5702A5
  %.458.i.i = fadd contract double %.457.i.i, %.414.i.i
  store double %.458.i.i, ptr %.413.i.i, align 8, !noalias !242
  %.561.i.i = getelementptr i8, ptr %arg.room.4, i64 168
  %.562.i.i = load double, ptr %.561.i.i, align 8, !noalias !242
  %.581.i.i = fmul contract double %.39.i6, 0x40510457810E2933
  %1 = fsub contract double 0x407E1C5F0E074C89, %.581.i.i
  %.583.i.i = fadd contract double %1, %.562.i.i
  store double %.583.i.i, ptr %.561.i.i, align 8, !noalias !242
  %.686.i.i = getelementptr i8, ptr %arg.room.4, i64 48
  %.687.i.i = load double, ptr %.686.i.i, align 8, !noalias !242
  %.756.i.i = fmul contract double %.39.i6, 0x4058A8587E6B74F0
  %2 = fsub contract double 0x404601B425ED097B, %.756.i.i
  %.758.i.i = fmul contract double %.39.i6, %2
  %.759.i.i = fadd contract double %.758.i.i, 0xC0A9D8A41ED3317E
  %.760.i.i = fmul contract double %.39.i6, %.759.i.i
  %.761.i.i = fadd contract double %.760.i.i, 0xC071640B49E85C3E
  %.762.i.i = fadd contract double %.761.i.i, %.687.i.i
  store double %.762.i.i, ptr %.686.i.i, align 8, !noalias !242
  %.865.i.i = getelementptr i8, ptr %arg.room.4, i64 176
  %.866.i.i = load double, ptr %.865.i.i, align 8, !noalias !242
  %.867.i.i = fadd contract double %.866.i.i, 0xC074618618618618
  store double %.867.i.i, ptr %.865.i.i, align 8, !noalias !242
  %.970.i.i = getelementptr i8, ptr %arg.room.4, i64 56
  %.971.i.i = load double, ptr %.970.i.i, align 8, !noalias !242
  %.1011.i.i = fmul contract double %.39.i6, 0x40733B288412FE12
  %3 = fsub contract double 0x408893BEE8443B83, %.1011.i.i
  %.1013.i.i = fmul contract double %.39.i6, %3
  %.1014.i.i = fadd contract double %.1013.i.i, 0x408DCC10DD757C0B
  %.1015.i.i = fadd contract double %.1014.i.i, %.971.i.i
  store double %.1015.i.i, ptr %.970.i.i, align 8, !noalias !242
  %.1118.i.i = getelementptr i8, ptr %arg.room.4, i64 192
  %.1119.i.i = load double, ptr %.1118.i.i, align 8, !noalias !242
  %.1225.i.i = fmul contract double %.39.i6, 0x40514C5F3B7242FB
  %.1226.i.i = fadd contract double %.1225.i.i, 0xC05D2FBB067D39F9
  %.1227.i.i = fmul contract double %.39.i6, %.1226.i.i
  %.1228.i.i = fadd contract double %.1227.i.i, 0xC091A4640F04B974
  %.1229.i.i = fmul contract double %.39.i6, %.1228.i.i
  %.1230.i.i = fadd contract double %.1229.i.i, 0x40CE3F8117DB38CA
  %.1231.i.i = fmul contract double %.39.i6, %.1230.i.i
  %.1232.i.i = fadd contract double %.1231.i.i, 0xC0A8D75E6BF57F9D
  %.1233.i.i = fadd contract double %.1232.i.i, %.1119.i.i
  store double %.1233.i.i, ptr %.1118.i.i, align 8, !noalias !242
  %.1336.i.i = getelementptr i8, ptr %arg.room.4, i64 320
  %.1337.i.i = load double, ptr %.1336.i.i, align 8, !noalias !242
  %.1356.i.i = fmul contract double %.39.i6, 0x409F6EC11CD4D97E
  %.1357.i.i = fadd contract double %.1356.i.i, 0x4072428A28A28A29
  %.1358.i.i = fadd contract double %.1357.i.i, %.1337.i.i
  store double %.1358.i.i, ptr %.1336.i.i, align 8, !noalias !242
  %.1461.i.i = getelementptr i8, ptr %arg.room.4, i64 72
  %.1462.i.i = load double, ptr %.1461.i.i, align 8, !noalias !242
  %.1531.i.i = fmul contract double %.39.i6, 0x40645019F9E83A77
  %.1532.i.i = fadd contract double %.1531.i.i, 0x40918164C0B5D6FD
  %.1533.i.i = fmul contract double %.39.i6, %.1532.i.i
  %.1534.i.i = fadd contract double %.1533.i.i, 0xC0D6C519D7F78519
  %.1535.i.i = fmul contract double %.39.i6, %.1534.i.i
  %.1536.i.i = fadd contract double %.1535.i.i, 0x40BB4B9C657BC796
  %.1537.i.i = fadd contract double %.1536.i.i, %.1462.i.i
  store double %.1537.i.i, ptr %.1461.i.i, align 8, !noalias !242
  %.1640.i.i = getelementptr i8, ptr %arg.room.4, i64 200
  %.1641.i.i = load double, ptr %.1640.i.i, align 8, !noalias !242
  %.1642.i.i = fadd contract double %.1641.i.i, 0xC0A001D567F49087
  store double %.1642.i.i, ptr %.1640.i.i, align 8, !noalias !242
  %.1810.i.i = fmul contract double %.39.i6, 0x40A619E547AE6DA3
  %.1811.i.i = fadd contract double %.1810.i.i, 0xC0D25E7665446D0F
  %.1812.i.i = fmul contract double %.39.i6, %.1811.i.i
  %.1813.i.i = fadd contract double %.1812.i.i, 0x40E19BDA5330D73F
  %.1814.i.i = fmul contract double %.39.i6, %.1813.i.i
  %.1815.i.i = fadd contract double %.1814.i.i, 0xC0E154650FD9ACF1
  %.1867.i.i = getelementptr i8, ptr %arg.room.4, i64 80
  %.1868.i.i = load double, ptr %.1867.i.i, align 8, !noalias !242
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
  store double %.1968.i.i, ptr %.1867.i.i, align 8, !noalias !242
  %.2088.i.i = fmul contract double %.39.i6, 0x40C0712C540DB5CD
  %.2089.i.i = fadd contract double %.2088.i.i, 0x40A79A477BF30A91
  %.2090.i.i = fmul contract double %.39.i6, %.2089.i.i
  %.2091.i.i = fadd contract double %.2090.i.i, 0xC0A4B055B758E414
  %.2092.i.i = fmul contract double %.39.i6, %.2091.i.i
  %.2093.i.i = fadd contract double %.2092.i.i, 0x406D67FD70A13797
  %.2145.i.i = getelementptr i8, ptr %arg.room.4, i64 208
  %.2146.i.i = load double, ptr %.2145.i.i, align 8, !noalias !242
  %.2152.i.i = fdiv contract double %.2093.i.i, %.1963.i.i
  %.2153.i.i = fadd contract double %.2152.i.i, %.2146.i.i
  store double %.2153.i.i, ptr %.2145.i.i, align 8, !noalias !242
  %.2256.i.i = getelementptr i8, ptr %arg.room.4, i64 88
  %.2257.i.i = load double, ptr %.2256.i.i, align 8, !noalias !242
  %.2363.i.i = fmul contract double %.39.i6, 0x402CA90C106318D7
  %.2364.i.i = fadd contract double %.2363.i.i, 0xC06030460C29F3DF
  %.2365.i.i = fmul contract double %.39.i6, %.2364.i.i
  %.2366.i.i = fadd contract double %.2365.i.i, 0x40D015D04F4BC5D2
  %.2367.i.i = fmul contract double %.39.i6, %.2366.i.i
  %.2368.i.i = fadd contract double %.2367.i.i, 0xC0E536054A2E10AB
  %.2369.i.i = fmul contract double %.39.i6, %.2368.i.i
  %.2370.i.i = fadd contract double %.2369.i.i, 0x40C95DBCC2240A74
  %.2371.i.i = fadd contract double %.2370.i.i, %.2257.i.i
  store double %.2371.i.i, ptr %.2256.i.i, align 8, !noalias !242
  %.2474.i.i = getelementptr i8, ptr %arg.room.4, i64 216
  %.2475.i.i = load double, ptr %.2474.i.i, align 8, !noalias !242
  %.2494.i.i = fmul contract double %.39.i6, 0x40BD257CD0AE1310
  %4 = fsub contract double 0xC09600901EF7C9A4, %.2494.i.i
  %.2496.i.i = fadd contract double %4, %.2475.i.i
  store double %.2496.i.i, ptr %.2474.i.i, align 8, !noalias !242
  %.24.i.i = fsub contract double 1.000000e+00, %.33.i
  %.25.i.i = fmul contract double %.33.i, %.24.i.i
  %.26.i.i = fmul contract double %.137, %.33.i
  %.80.i.i = fmul contract double %.33.i, 0x4029555555555555
  %.81.i.i = fadd contract double %.80.i.i, 2.500000e+01
  %.82.i.i = fmul contract double %.26.i.i, %.81.i.i
  %.83.i.i = fadd contract double %.82.i.i, %.310.i2.i
  store double %.83.i.i, ptr %.308.i.i, align 8, !noalias !245
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
  store double %6, ptr %.561.i.i, align 8, !noalias !245
  %.301.i.i = fmul contract double %.26.i.i, 0x400921FB54442D18
  %.302.i.i = fmul contract double %.33.i, 2.600000e+02
  %.303.i.i = fadd contract double %.302.i.i, 0x407F0AAAAAAAAAAB
  %.304.i.i = fmul contract double %.303.i.i, %.301.i.i
  %.305.i.i = fadd contract double %.304.i.i, %.762.i.i
  store double %.305.i.i, ptr %.686.i.i, align 8, !noalias !245
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
  store double %.424.i.i, ptr %.970.i.i, align 8, !noalias !245
  %.24.i5.i = fsub contract double 1.000000e+00, %.38.i
  %.25.i6.i = fmul contract double %.38.i, %.24.i5.i
  %.26.i7.i = fmul contract double %.38.i, %.167
  %.80.i10.i = fmul contract double %.38.i, 0x4029555555555555
  %.81.i11.i = fadd contract double %.80.i10.i, 2.500000e+01
  %.82.i12.i = fmul contract double %.26.i7.i, %.81.i11.i
  %.83.i13.i = fadd contract double %.82.i12.i, %.83.i.i
  store double %.83.i13.i, ptr %.308.i.i, align 8, !noalias !248
  %.188.i16.i = fmul contract double %.26.i7.i, 3.000000e+00
  %.189.i17.i = fmul contract double %.25.i6.i, 0x400AAAAAAAAAAAAB
  %.190.i18.i = fsub contract double 0x4064B4F3CF3CF3CF, %.189.i17.i
  %.191.i19.i = fmul contract double %.25.i6.i, 0x4032E38E38E38E39
  %.192.i20.i = fadd contract double %.191.i19.i, 0x4063B0FCD6E9E065
  %.193.i21.i = fmul contract double %.38.i, %.192.i20.i
  %.194.i22.i = fadd contract double %.190.i18.i, %.193.i21.i
  %.195.i23.i = fmul contract double %.188.i16.i, %.194.i22.i
  %7 = fsub contract double %6, %.195.i23.i
  store double %7, ptr %.561.i.i, align 8, !noalias !248
  %.301.i26.i = fmul contract double %.26.i7.i, 0x400921FB54442D18
  %.302.i27.i = fmul contract double %.38.i, 2.600000e+02
  %.303.i28.i = fadd contract double %.302.i27.i, 0x407F0AAAAAAAAAAB
  %.304.i29.i = fmul contract double %.303.i28.i, %.301.i26.i
  %.305.i30.i = fadd contract double %.304.i29.i, %.305.i.i
  store double %.305.i30.i, ptr %.686.i.i, align 8, !noalias !248
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
  store double %.424.i47.i, ptr %.970.i.i, align 8, !noalias !248
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
  store double %.109.i.i, ptr %.413.i.i, align 8, !noalias !251
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
  store double %.225.i.i, ptr %.686.i.i, align 8, !noalias !251
  %.331.i.i = fmul contract double %.147.i.i.i7, 0x4093A28C59D5433B
  %.332.i.i = fmul contract double %.331.i.i, %.73.le.i.i
  %11 = fsub contract double %.424.i47.i, %.332.i.i
  store double %11, ptr %.970.i.i, align 8, !noalias !251
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
  store double %.109.i70.i, ptr %.413.i.i, align 8, !noalias !254
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
  store double %.225.i84.i, ptr %.686.i.i, align 8, !noalias !254
  %.331.i87.i = fmul contract double %.147.i.i65.i, 0x4093A28C59D5433B
  %.332.i88.i = fmul contract double %.331.i87.i, %.73.le.i63.i
  %15 = fsub contract double %11, %.332.i88.i
  store double %15, ptr %.970.i.i, align 8, !noalias !254
  %.27.i.i = fmul contract double %.137, %.25.i.i
  %.28.i.i = fmul contract double %.167, %.27.i.i
  %.82.i93.i = fmul contract double %.28.i.i, 9.875000e+01
  %16 = fsub contract double %.109.i70.i, %.82.i93.i
  store double %16, ptr %.413.i.i, align 8, !noalias !257
  %.188.i96.i = fmul contract double %.25.i.i, 0x40735B8E38E38E39
  %.189.i97.i = fadd contract double %.188.i96.i, 0x40723BDB6DB6DB6E
  %.190.i98.i = fmul contract double %.28.i.i, %.189.i97.i
  %.191.i99.i = fadd contract double %.190.i98.i, %.225.i84.i
  store double %.191.i99.i, ptr %.686.i.i, align 8, !noalias !257
  %.245.i.i = fmul contract double %.167, %.24.i.i
  %.246.i.i = fsub contract double %.26.i.i, %.245.i.i
  %.147.i.i101.i = fmul contract double %.246.i.i, %.246.i.i
  %.301.i102.i = fmul contract double %.28.i.i, 8.000000e+02
  %.328.i103.i = fmul contract double %.147.i.i101.i, 7.500000e+00
  %.329.i104.i = fadd contract double %.301.i102.i, %.328.i103.i
  %.330.i.i = fmul contract double %.329.i104.i, 0x400921FB54442D18
  %17 = fsub contract double %15, %.330.i.i
  store double %17, ptr %.970.i.i, align 8, !noalias !257
  %.24.i105.i = fmul contract double %.33.i, %.33.i
  %.25.i106.i = fmul contract double %.24.i105.i, %.24.i105.i
  %.26.i107.i = fmul contract double %.25.i106.i, -2.400000e+01
  %.27.i108.i = fmul contract double %.26.i107.i, %.682
  %.81.i111.i = fmul contract double %.33.i, 1.100000e+01
  %.82.i112.i = fsub contract double 1.200000e+01, %.81.i111.i
  %.83.i113.i = fmul contract double %.82.i112.i, %.27.i108.i
  %.84.i.i = fadd contract double %.83.i113.i, %.1968.i.i
  store double %.84.i.i, ptr %.1867.i.i, align 8, !noalias !260
  %.187.i114.i = getelementptr i8, ptr %arg.room.4, i64 96
  %.188.i115.i = load double, ptr %.187.i114.i, align 8, !noalias !260
  %.189.i116.i = fmul contract double %.27.i108.i, 5.000000e+00
  %.193.i117.i = fdiv contract double %.189.i116.i, 6.720000e+02
  %.195.i119.i = fsub contract double 2.286000e+03, %.302.i.i
  %.196.i.i = fmul contract double %.33.i, %.195.i119.i
  %.197.i.i = fadd contract double %.196.i.i, 9.190000e+02
  %.198.i.i = fmul contract double %.33.i, %.197.i.i
  %.199.i.i = fsub contract double 3.179000e+03, %.198.i.i
  %.200.i.i = fmul contract double %.199.i.i, %.193.i117.i
  %.201.i.i = fadd contract double %.200.i.i, %.188.i115.i
  store double %.201.i.i, ptr %.187.i114.i, align 8, !noalias !260
  %.304.i120.i = getelementptr i8, ptr %arg.room.4, i64 104
  %.305.i121.i = load double, ptr %.304.i120.i, align 8, !noalias !260
  %.307.i.i = fmul contract double %.27.i108.i, 0xC00921FB54442D18
  %.310.i.i = fmul contract double %.82.i112.i, %.307.i.i
  %.311.i.i = fadd contract double %.310.i.i, %.305.i121.i
  store double %.311.i.i, ptr %.304.i120.i, align 8, !noalias !260
  %.363.i122.i = fmul contract double %.33.i, 0x4151712000000000
  %.364.i123.i = fsub contract double 0x41737B1700000000, %.363.i122.i
  %.365.i.i = fmul contract double %.33.i, %.364.i123.i
  %.366.i.i = fsub contract double 0x41A2E151D8000000, %.365.i.i
  %.418.i124.i = getelementptr i8, ptr %arg.room.4, i64 112
  %.419.i125.i = load double, ptr %.418.i124.i, align 8, !noalias !260
  %.424.i126.i = fdiv contract double %.189.i116.i, 0x417A29B000000000
  %.425.i.i = fmul contract double %.33.i, %.366.i.i
  %.426.i.i = fadd contract double %.425.i.i, 0x41A4DB86E0000000
  %.427.i.i = fmul contract double %.33.i, %.426.i.i
  %.428.i.i = fadd contract double %.427.i.i, 0x41849F27B8000000
  %.429.i.i = fmul contract double %.33.i, %.428.i.i
  %.430.i.i = fsub contract double 0x41B72002EE000000, %.429.i.i
  %.431.i.i = fmul contract double %.430.i.i, %.424.i126.i
  %.432.i.i = fadd contract double %.431.i.i, %.419.i125.i
  store double %.432.i.i, ptr %.418.i124.i, align 8, !noalias !260
  %.535.i.i = getelementptr i8, ptr %arg.room.4, i64 120
  %.536.i.i = load double, ptr %.535.i.i, align 8, !noalias !260
  %.542.i.i = fdiv contract double %.307.i.i, 6.720000e+02
  %.543.i.i = fmul contract double %.33.i, 1.052000e+04
  %.544.i.i = fsub contract double 7.598000e+03, %.543.i.i
  %.545.i.i = fmul contract double %.33.i, %.544.i.i
  %.546.i.i = fsub contract double 2.241500e+04, %.545.i.i
  %.547.i.i = fmul contract double %.33.i, %.546.i.i
  %.548.i.i = fsub contract double 2.771900e+04, %.547.i.i
  %.549.i.i = fmul contract double %.548.i.i, %.542.i.i
  %.550.i.i = fadd contract double %.549.i.i, %.536.i.i
  store double %.550.i.i, ptr %.535.i.i, align 8, !noalias !260
  %.24.i127.i = fmul contract double %.38.i, %.38.i
  %.25.i128.i = fmul contract double %.24.i127.i, %.24.i127.i
  %.26.i129.i = fmul contract double %.25.i128.i, -2.400000e+01
  %.27.i130.i = fmul contract double %.26.i129.i, %.712
  %.81.i133.i = fmul contract double %.38.i, 1.100000e+01
  %.82.i134.i = fsub contract double 1.200000e+01, %.81.i133.i
  %.83.i135.i = fmul contract double %.82.i134.i, %.27.i130.i
  %.84.i136.i = fadd contract double %.83.i135.i, %.84.i.i
  store double %.84.i136.i, ptr %.1867.i.i, align 8, !noalias !263
  %.189.i139.i = fmul contract double %.27.i130.i, 5.000000e+00
  %.193.i140.i = fdiv contract double %.189.i139.i, 6.720000e+02
  %.195.i142.i = fsub contract double 2.286000e+03, %.302.i27.i
  %.196.i143.i = fmul contract double %.38.i, %.195.i142.i
  %.197.i144.i = fadd contract double %.196.i143.i, 9.190000e+02
  %.198.i145.i = fmul contract double %.38.i, %.197.i144.i
  %.199.i146.i = fsub contract double 3.179000e+03, %.198.i145.i
  %.200.i147.i = fmul contract double %.199.i146.i, %.193.i140.i
  %.201.i148.i = fadd contract double %.200.i147.i, %.201.i.i
  store double %.201.i148.i, ptr %.187.i114.i, align 8, !noalias !263
  %.307.i151.i = fmul contract double %.27.i130.i, 0xC00921FB54442D18
  %.310.i152.i = fmul contract double %.82.i134.i, %.307.i151.i
  %.311.i153.i = fadd contract double %.310.i152.i, %.311.i.i
  store double %.311.i153.i, ptr %.304.i120.i, align 8, !noalias !263
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
  store double %.432.i168.i, ptr %.418.i124.i, align 8, !noalias !263
  %.542.i171.i = fdiv contract double %.307.i151.i, 6.720000e+02
  %.543.i172.i = fmul contract double %.38.i, 1.052000e+04
  %.544.i173.i = fsub contract double 7.598000e+03, %.543.i172.i
  %.545.i174.i = fmul contract double %.38.i, %.544.i173.i
  %.546.i175.i = fsub contract double 2.241500e+04, %.545.i174.i
  %.547.i176.i = fmul contract double %.38.i, %.546.i175.i
  %.548.i177.i = fsub contract double 2.771900e+04, %.547.i176.i
  %.549.i178.i = fmul contract double %.548.i177.i, %.542.i171.i
  %.550.i179.i = fadd contract double %.549.i178.i, %.550.i.i
  store double %.550.i179.i, ptr %.535.i.i, align 8, !noalias !263
  %.671.i8 = fmul contract double %.39.i6, 1.280000e+02
  %.675.i = fdiv contract double 3.000000e+00, %.671.i8
  store double %.675.i, ptr %arg.room.4, align 8, !noalias !239
  %18 = getelementptr i8, ptr %arg.room.4, i64 8
  %.968.1.i = load double, ptr %18, align 8, !noalias !239
  %.970.1.i = fmul contract double %.675.i, %.968.1.i
  store double %.970.1.i, ptr %18, align 8, !noalias !239
  %.970.2.i = fmul contract double %.675.i, %.204.i.i
  store double %.970.2.i, ptr %.183.i.i, align 8, !noalias !239
  %.970.3.i = fmul contract double %.675.i, %.83.i13.i
  store double %.970.3.i, ptr %.308.i.i, align 8, !noalias !239
  %.970.4.i = fmul contract double %.675.i, %16
  store double %.970.4.i, ptr %.413.i.i, align 8, !noalias !239
  %19 = getelementptr i8, ptr %arg.room.4, i64 40
  %.968.5.i = load double, ptr %19, align 8, !noalias !239
  %.970.5.i = fmul contract double %.675.i, %.968.5.i
  store double %.970.5.i, ptr %19, align 8, !noalias !239
  %.970.6.i = fmul contract double %.675.i, %.191.i99.i
  store double %.970.6.i, ptr %.686.i.i, align 8, !noalias !239
  %.970.7.i = fmul contract double %.675.i, %17
  store double %.970.7.i, ptr %.970.i.i, align 8, !noalias !239
  %20 = getelementptr i8, ptr %arg.room.4, i64 64
  %.968.8.i = load double, ptr %20, align 8, !noalias !239
  %.970.8.i = fmul contract double %.675.i, %.968.8.i
  store double %.970.8.i, ptr %20, align 8, !noalias !239
  %.970.9.i = fmul contract double %.675.i, %.1537.i.i
  store double %.970.9.i, ptr %.1461.i.i, align 8, !noalias !239
  %.970.10.i = fmul contract double %.675.i, %.84.i136.i
  store double %.970.10.i, ptr %.1867.i.i, align 8, !noalias !239
  %.970.11.i = fmul contract double %.675.i, %.2371.i.i
  store double %.970.11.i, ptr %.2256.i.i, align 8, !noalias !239
  %.970.12.i = fmul contract double %.675.i, %.201.i148.i
  store double %.970.12.i, ptr %.187.i114.i, align 8, !noalias !239
  %.970.13.i = fmul contract double %.675.i, %.311.i153.i
  store double %.970.13.i, ptr %.304.i120.i, align 8, !noalias !239
  %.970.14.i = fmul contract double %.675.i, %.432.i168.i
  store double %.970.14.i, ptr %.418.i124.i, align 8, !noalias !239
  %.970.15.i = fmul contract double %.675.i, %.550.i179.i
  store double %.970.15.i, ptr %.535.i.i, align 8, !noalias !239
  %.968.1276.i = load double, ptr %5, align 8, !noalias !239
  %.970.1277.i = fmul contract double %.675.i, %.968.1276.i
  store double %.970.1277.i, ptr %5, align 8, !noalias !239
  %21 = getelementptr i8, ptr %arg.room.4, i64 136
  %.968.1.1.i = load double, ptr %21, align 8, !noalias !239
  %.970.1.1.i = fmul contract double %.675.i, %.968.1.1.i
  store double %.970.1.1.i, ptr %21, align 8, !noalias !239
  %22 = getelementptr i8, ptr %arg.room.4, i64 144
  %.968.2.1.i = load double, ptr %22, align 8, !noalias !239
  %.970.2.1.i = fmul contract double %.675.i, %.968.2.1.i
  store double %.970.2.1.i, ptr %22, align 8, !noalias !239
  %23 = getelementptr i8, ptr %arg.room.4, i64 152
  %.968.3.1.i = load double, ptr %23, align 8, !noalias !239
  %.970.3.1.i = fmul contract double %.675.i, %.968.3.1.i
  store double %.970.3.1.i, ptr %23, align 8, !noalias !239
  %24 = getelementptr i8, ptr %arg.room.4, i64 160
  %.968.4.1.i = load double, ptr %24, align 8, !noalias !239
  %.970.4.1.i = fmul contract double %.675.i, %.968.4.1.i
  store double %.970.4.1.i, ptr %24, align 8, !noalias !239
  %.970.5.1.i = fmul contract double %.675.i, %7
  store double %.970.5.1.i, ptr %.561.i.i, align 8, !noalias !239
  %.970.6.1.i = fmul contract double %.675.i, %.867.i.i
  store double %.970.6.1.i, ptr %.865.i.i, align 8, !noalias !239
  %25 = getelementptr i8, ptr %arg.room.4, i64 184
  %.968.7.1.i = load double, ptr %25, align 8, !noalias !239
  %.970.7.1.i = fmul contract double %.675.i, %.968.7.1.i
  store double %.970.7.1.i, ptr %25, align 8, !noalias !239
  %.970.8.1.i = fmul contract double %.675.i, %.1233.i.i
  store double %.970.8.1.i, ptr %.1118.i.i, align 8, !noalias !239
  %.970.9.1.i = fmul contract double %.675.i, %.1642.i.i
  store double %.970.9.1.i, ptr %.1640.i.i, align 8, !noalias !239
  %.970.10.1.i = fmul contract double %.675.i, %.2153.i.i
  store double %.970.10.1.i, ptr %.2145.i.i, align 8, !noalias !239
  %.970.11.1.i = fmul contract double %.675.i, %.2496.i.i
  store double %.970.11.1.i, ptr %.2474.i.i, align 8, !noalias !239
  %26 = getelementptr i8, ptr %arg.room.4, i64 224
  %.968.12.1.i = load double, ptr %26, align 8, !noalias !239
  %.970.12.1.i = fmul contract double %.675.i, %.968.12.1.i
  store double %.970.12.1.i, ptr %26, align 8, !noalias !239
  %27 = getelementptr i8, ptr %arg.room.4, i64 232
  %.968.13.1.i = load double, ptr %27, align 8, !noalias !239
  %.970.13.1.i = fmul contract double %.675.i, %.968.13.1.i
  store double %.970.13.1.i, ptr %27, align 8, !noalias !239
  %28 = getelementptr i8, ptr %arg.room.4, i64 240
  %.968.14.1.i = load double, ptr %28, align 8, !noalias !239
  %.970.14.1.i = fmul contract double %.675.i, %.968.14.1.i
  store double %.970.14.1.i, ptr %28, align 8, !noalias !239
  %29 = getelementptr i8, ptr %arg.room.4, i64 248
  %.968.15.1.i = load double, ptr %29, align 8, !noalias !239
  %.970.15.1.i = fmul contract double %.675.i, %.968.15.1.i
  store double %.970.15.1.i, ptr %29, align 8, !noalias !239
  %30 = getelementptr i8, ptr %arg.room.4, i64 256
  %.968.2278.i = load double, ptr %30, align 8, !noalias !239
  %.970.2279.i = fmul contract double %.675.i, %.968.2278.i
  store double %.970.2279.i, ptr %30, align 8, !noalias !239
  %31 = getelementptr i8, ptr %arg.room.4, i64 264
  %.968.1.2.i = load double, ptr %31, align 8, !noalias !239
  %.970.1.2.i = fmul contract double %.675.i, %.968.1.2.i
  store double %.970.1.2.i, ptr %31, align 8, !noalias !239
  %32 = getelementptr i8, ptr %arg.room.4, i64 272
  %.968.2.2.i = load double, ptr %32, align 8, !noalias !239
  %.970.2.2.i = fmul contract double %.675.i, %.968.2.2.i
  store double %.970.2.2.i, ptr %32, align 8, !noalias !239
  %33 = getelementptr i8, ptr %arg.room.4, i64 280
  %.968.3.2.i = load double, ptr %33, align 8, !noalias !239
  %.970.3.2.i = fmul contract double %.675.i, %.968.3.2.i
  store double %.970.3.2.i, ptr %33, align 8, !noalias !239
  %34 = getelementptr i8, ptr %arg.room.4, i64 288
  %.968.4.2.i = load double, ptr %34, align 8, !noalias !239
  %.970.4.2.i = fmul contract double %.675.i, %.968.4.2.i
  store double %.970.4.2.i, ptr %34, align 8, !noalias !239
  %35 = getelementptr i8, ptr %arg.room.4, i64 296
  %.968.5.2.i = load double, ptr %35, align 8, !noalias !239
  %.970.5.2.i = fmul contract double %.675.i, %.968.5.2.i
  store double %.970.5.2.i, ptr %35, align 8, !noalias !239
  %36 = getelementptr i8, ptr %arg.room.4, i64 304
  %.968.6.2.i = load double, ptr %36, align 8, !noalias !239
  %.970.6.2.i = fmul contract double %.675.i, %.968.6.2.i
  store double %.970.6.2.i, ptr %36, align 8, !noalias !239
  %37 = getelementptr i8, ptr %arg.room.4, i64 312
  %.968.7.2.i = load double, ptr %37, align 8, !noalias !239
  %.970.7.2.i = fmul contract double %.675.i, %.968.7.2.i
  store double %.970.7.2.i, ptr %37, align 8, !noalias !239
  %.970.8.2.i = fmul contract double %.675.i, %.1358.i.i
  store double %.970.8.2.i, ptr %.1336.i.i, align 8, !noalias !239
  %38 = getelementptr i8, ptr %arg.room.4, i64 328
  %.968.9.2.i = load double, ptr %38, align 8, !noalias !239
  %.970.9.2.i = fmul contract double %.675.i, %.968.9.2.i
  store double %.970.9.2.i, ptr %38, align 8, !noalias !239
  %39 = getelementptr i8, ptr %arg.room.4, i64 336
  %.968.10.2.i = load double, ptr %39, align 8, !noalias !239
  %.970.10.2.i = fmul contract double %.675.i, %.968.10.2.i
  store double %.970.10.2.i, ptr %39, align 8, !noalias !239
  %40 = getelementptr i8, ptr %arg.room.4, i64 344
  %.968.11.2.i = load double, ptr %40, align 8, !noalias !239
  %.970.11.2.i = fmul contract double %.675.i, %.968.11.2.i
  store double %.970.11.2.i, ptr %40, align 8, !noalias !239
  %41 = getelementptr i8, ptr %arg.room.4, i64 352
  %.968.12.2.i = load double, ptr %41, align 8, !noalias !239
  %.970.12.2.i = fmul contract double %.675.i, %.968.12.2.i
  store double %.970.12.2.i, ptr %41, align 8, !noalias !239
  %42 = getelementptr i8, ptr %arg.room.4, i64 360
  %.968.13.2.i = load double, ptr %42, align 8, !noalias !239
  %.970.13.2.i = fmul contract double %.675.i, %.968.13.2.i
  store double %.970.13.2.i, ptr %42, align 8, !noalias !239
  %43 = getelementptr i8, ptr %arg.room.4, i64 368
  %.968.14.2.i = load double, ptr %43, align 8, !noalias !239
  %.970.14.2.i = fmul contract double %.675.i, %.968.14.2.i
  store double %.970.14.2.i, ptr %43, align 8, !noalias !239
  %44 = getelementptr i8, ptr %arg.room.4, i64 376
  %.968.15.2.i = load double, ptr %44, align 8, !noalias !239
  %.970.15.2.i = fmul contract double %.675.i, %.968.15.2.i
  store double %.970.15.2.i, ptr %44, align 8, !noalias !239
  %.1069 = getelementptr i8, ptr %arg.out.4, i64 64
  %.69.le.i = tail call contract double @llvm.log.f64(double %.306)
  %.83.i = fmul contract double %.306, %.438
  %.85.i = fmul contract double %.306, %.83.i
  %.89.i = fdiv contract double 1.000000e+00, %.85.i
  %.493.i5 = fmul contract double %.69.le.i, 2.000000e+00
  %scevgep9 = getelementptr i8, ptr %arg.out.4, i64 152
  br label %B154.if.i

B848:                                             ; preds = %_ZN17bnserve_surrogate6kernel7_series17fill_phase_powersB4v251B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dEd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit
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
  br i1 %.168.i.i, label %B134.if.lr.ph.i, label %_ZN17bnserve_surrogate6kernel7_series8legendreB4v252B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dEd5ArrayIdLi2E1C7mutable7alignedE.exit, !prof !20

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
  %.249.i = load double, ptr %sunkaddr19, align 8, !noalias !266
  %sunkaddr22 = getelementptr i8, ptr %sunkaddr18, i64 256
  %.303.i = load double, ptr %sunkaddr22, align 8, !noalias !266
  %sunkaddr25 = getelementptr i8, ptr %sunkaddr18, i64 384
  %.357.i = load double, ptr %sunkaddr25, align 8, !noalias !266
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
  br i1 %ov, label %_ZN17bnserve_surrogate6kernel7_series8legendreB4v252B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dEd5ArrayIdLi2E1C7mutable7alignedE.exit, label %B134.if.i

_ZN17bnserve_surrogate6kernel7_series8legendreB4v252B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dEd5ArrayIdLi2E1C7mutable7alignedE.exit: ; preds = %B134.if.i, %B872
  %.1339.0 = phi double [ 0.000000e+00, %B872 ], [ %.488.i, %B134.if.i ]
  %excinfo.7.0 = phi ptr [ null, %B872 ], [ null, %B134.if.i ]
  br i1 %.168.i.i, label %B872.endif, label %B872.if, !prof !20

B944:                                             ; preds = %B872.endif, %_ZN17bnserve_surrogate6kernel7_series17fill_phase_powersB4v251B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dEd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit, %B848
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
  %.491.i = load double, ptr %sunkaddr38, align 8, !noalias !270
  %.548.i = load double, ptr %sunkaddr41, align 8, !noalias !270
  %.549.i = fmul contract double %.493.i5, %.548.i
  %.550.i = fadd contract double %.491.i, %.549.i
  %.552.i = fmul contract double %power.2.0232.i, %.550.i
  %.556.i = fdiv contract double %.552.i, 3.000000e+00
  %scevgep10 = getelementptr i8, ptr %scevgep9, i64 %sunkaddr34
  store double %.556.i, ptr %scevgep10, align 8, !noalias !270
  br label %B356.i

B356.i:                                           ; preds = %B154.if.i, %B278.i
  %.596.i = fmul contract double %.306, %power.2.0232.i
  %lsr.iv.next = add nuw nsw i64 %lsr.iv, 1
  %exitcond.not.i10 = icmp eq i64 %lsr.iv.next, 16
  br i1 %exitcond.not.i10, label %_ZN17bnserve_surrogate6kernel7_series17fill_phase_powersB4v251B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dEd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit, label %B154.if.i

B154.if.i:                                        ; preds = %B356.i, %entry
  %lsr.iv = phi i64 [ %lsr.iv.next, %B356.i ], [ 0, %entry ]
  %power.2.0232.i = phi double [ %.596.i, %B356.i ], [ %.89.i, %entry ]
  %47 = add nsw i64 %lsr.iv, -5
  %sunkaddr34 = shl i64 %lsr.iv, 3
  %sunkaddr35 = getelementptr i8, ptr %arg.room.4, i64 %sunkaddr34
  %.269.i = load double, ptr %sunkaddr35, align 8, !noalias !270
  %sunkaddr38 = getelementptr i8, ptr %sunkaddr35, i64 128
  %.324.i = load double, ptr %sunkaddr38, align 8, !noalias !270
  %sunkaddr41 = getelementptr i8, ptr %sunkaddr35, i64 256
  %.379.i = load double, ptr %sunkaddr41, align 8, !noalias !270
  %.381.i = fmul contract double %.69.le.i, %.379.i
  %.382.i = fadd contract double %.324.i, %.381.i
  %.384.i = fmul contract double %.69.le.i, %.382.i
  %.385.i = fadd contract double %.269.i, %.384.i
  %.387.i = fmul contract double %power.2.0232.i, %.385.i
  %scevgep11 = getelementptr i8, ptr %.1069, i64 %sunkaddr34
  store double %.387.i, ptr %scevgep11, align 8, !noalias !270
  %or.cond.i = icmp ult i64 %47, 7
  br i1 %or.cond.i, label %B278.i, label %B356.i

_ZN17bnserve_surrogate6kernel7_series17fill_phase_powersB4v251B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dEd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit: ; preds = %B356.i
  %.672.i = load double, ptr %.1336.i.i, align 8, !noalias !270
  %.680.i = fmul contract double %.305, %.672.i
  %.684.i = fdiv contract double %.680.i, 9.000000e+00
  %sunkaddr43 = getelementptr i8, ptr %arg.out.4, i64 248
  store double %.684.i, ptr %sunkaddr43, align 8, !noalias !270
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

B872.if:                                          ; preds = %_ZN17bnserve_surrogate6kernel7_series8legendreB4v252B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dEd5ArrayIdLi2E1C7mutable7alignedE.exit
  store ptr %excinfo.7.0, ptr %excinfo, align 8
  br label %common.ret

B872.endif:                                       ; preds = %_ZN17bnserve_surrogate6kernel7_series8legendreB4v252B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dEd5ArrayIdLi2E1C7mutable7alignedE.exit
  %.1374 = fadd contract double %.1206, %.1339.0
  store double %.1374, ptr %sunkaddr45, align 8
  br label %B944
}

; Function Attrs: mustprogress nocallback nofree nosync nounwind willreturn memory(none)
declare double @sqrt(double) local_unnamed_addr #5

; Function Attrs: mustprogress nocallback nocreateundeforpoison nofree nosync nounwind speculatable willreturn memory(none)
declare double @llvm.exp.f64(double) #2

; Function Attrs: mustprogress nocallback nocreateundeforpoison nofree nosync nounwind speculatable willreturn memory(none)
declare double @llvm.sin.f64(double) #2

; Function Attrs: mustprogress nocallback nocreateundeforpoison nofree nosync nounwind speculatable willreturn memory(none)
declare double @llvm.fma.f64(double, double, double) #2

; Function Attrs: nofree noinline norecurse nosync nounwind memory(argmem: readwrite)
define internal fastcc void @inner_13(ptr noalias nonnull writeonly captures(none) %retptr, ptr readonly captures(none) %arg.f.4, ptr readonly captures(none) %arg.cbrt_f.4, ptr readonly captures(none) %arg.power.4, i64 %arg.segments.0, i64 %arg.segments.1, i64 range(i64 1, -9223372036854775808) %arg.segments.2, double %arg.mass, ptr readonly captures(none) %arg.c.4, double %arg.constant, ptr readonly captures(none) %arg.residuals.4, ptr writeonly captures(none) %arg.out.4) unnamed_addr #3 {
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
  %1 = add nuw nsw i64 %.490, 7
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
  %4 = add nuw nsw i64 %.931, 7
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
  %7 = add nuw nsw i64 %.1487, 7
  br label %B1332.if

B1432:                                            ; preds = %B1332.if, %B1288
  store ptr null, ptr %retptr, align 8
  ret void

B194.if:                                          ; preds = %B194.if, %B194.if.lr.ph
  %lsr.iv = phi i64 [ %lsr.iv.next, %B194.if ], [ %1, %B194.if.lr.ph ]
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
  %lsr.iv.next = add nsw i64 %lsr.iv, -1
  %.511 = icmp sgt i64 %lsr.iv, 8
  br i1 %.511, label %B194.if, label %B604

B648.if:                                          ; preds = %B648.if, %B648.if.lr.ph
  %lsr.iv3 = phi i64 [ %lsr.iv.next4, %B648.if ], [ %4, %B648.if.lr.ph ]
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
  %lsr.iv.next4 = add nsw i64 %lsr.iv3, -1
  %.952 = icmp sgt i64 %lsr.iv3, 8
  br i1 %.952, label %B648.if, label %B1288

B1332.if:                                         ; preds = %B1332.if, %B1332.if.preheader
  %lsr.iv1 = phi i64 [ %lsr.iv.next2, %B1332.if ], [ %7, %B1332.if.preheader ]
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
  %lsr.iv.next2 = add nsw i64 %lsr.iv1, -1
  %.1508 = icmp sgt i64 %lsr.iv1, 8
  br i1 %.1508, label %B1332.if, label %B1432
}

; Function Attrs: mustprogress nocallback nocreateundeforpoison nofree nosync nounwind speculatable willreturn memory(none)
declare double @llvm.fabs.f64(double) #2

; Function Attrs: mustprogress nofree norecurse nosync nounwind willreturn memory(argmem: readwrite)
define internal fastcc void @inner_5(ptr noalias nonnull writeonly captures(none) initializes((0, 8)) %retptr, double %arg.mass_fraction.0, double %arg.mass_fraction.1, double %arg.chi.0, double %arg.chi.1, ptr captures(none) %arg.out.4) unnamed_addr #6 {
entry:
  %.53 = fsub contract double 1.000000e+00, %arg.mass_fraction.0
  %.56 = fsub contract double 0.000000e+00, %arg.mass_fraction.1
  %.58.i = fmul contract double %arg.mass_fraction.0, %.56
  %.64.i = fmul contract double %arg.mass_fraction.1, %.53
  %.80.i = fadd contract double %.64.i, %.58.i
  %.46.i = fmul contract double %arg.mass_fraction.0, %.53
  %.52.i = fmul contract double %arg.mass_fraction.1, %.56
  %.70.i = fsub contract double %.46.i, %.52.i
  %.58.i1 = fmul contract double %arg.mass_fraction.0, %arg.chi.1
  %.64.i2 = fmul contract double %arg.mass_fraction.1, %arg.chi.0
  %.80.i3 = fadd contract double %.64.i2, %.58.i1
  %.46.i4 = fmul contract double %arg.mass_fraction.0, %arg.chi.0
  %.52.i5 = fmul contract double %arg.mass_fraction.1, %arg.chi.1
  %.70.i6 = fsub contract double %.46.i4, %.52.i5
  %.165 = getelementptr i8, ptr %arg.out.4, i64 48
  %.167 = load double, ptr %.165, align 8
  %.168 = getelementptr i8, ptr %arg.out.4, i64 56
  %.169 = load double, ptr %.168, align 8
  %.58.i8 = fmul contract double %arg.mass_fraction.1, 0x4029555555555555
  %.64.i9 = fmul contract double %arg.mass_fraction.0, 0.000000e+00
  %.80.i10 = fadd contract double %.64.i9, %.58.i8
  %.46.i11 = fmul contract double %arg.mass_fraction.0, 0x4029555555555555
  %.52.i12 = fmul contract double %arg.mass_fraction.1, 0.000000e+00
  %.70.i13 = fsub contract double %.46.i11, %.52.i12
  %.231 = fadd contract double %.70.i13, 2.500000e+01
  %.234 = fadd contract double %.80.i10, 0.000000e+00
  %.58.i15 = fmul contract double %.234, %.70.i6
  %.64.i16 = fmul contract double %.231, %.80.i3
  %.80.i17 = fadd contract double %.64.i16, %.58.i15
  %.46.i18 = fmul contract double %.231, %.70.i6
  %.52.i19 = fmul contract double %.234, %.80.i3
  %.70.i20 = fsub contract double %.46.i18, %.52.i19
  %.283 = fadd contract double %.70.i20, %.167
  %.286 = fadd contract double %.80.i17, %.169
  store double %.283, ptr %.165, align 8
  store double %.286, ptr %.168, align 8
  %.394 = getelementptr i8, ptr %arg.out.4, i64 336
  %.396 = load double, ptr %.394, align 8
  %.397 = getelementptr i8, ptr %arg.out.4, i64 344
  %.398 = load double, ptr %.397, align 8
  %.58.i22 = fmul contract double %.80.i3, 3.000000e+00
  %.64.i23 = fmul contract double %.70.i6, 0.000000e+00
  %0 = fsub contract double %.64.i23, %.58.i22
  %.46.i25 = fmul contract double %.70.i6, -3.000000e+00
  %.52.i26 = fmul contract double %.80.i3, 0.000000e+00
  %.70.i27 = fsub contract double %.46.i25, %.52.i26
  %.58.i29 = fmul contract double %.80.i, 0x400AAAAAAAAAAAAB
  %.64.i30 = fmul contract double %.70.i, 0.000000e+00
  %.80.i31 = fadd contract double %.64.i30, %.58.i29
  %.46.i32 = fmul contract double %.70.i, 0x400AAAAAAAAAAAAB
  %.52.i33 = fmul contract double %.80.i, 0.000000e+00
  %1 = fsub contract double %.52.i33, %.46.i32
  %.494 = fadd contract double %1, 0x4064B4F3CF3CF3CF
  %.497 = fsub contract double 0.000000e+00, %.80.i31
  %.58.i36 = fmul contract double %.80.i, 0x4032E38E38E38E39
  %.80.i38 = fadd contract double %.64.i30, %.58.i36
  %.46.i39 = fmul contract double %.70.i, 0x4032E38E38E38E39
  %.70.i41 = fsub contract double %.46.i39, %.52.i33
  %.562 = fadd contract double %.70.i41, 0x4063B0FCD6E9E065
  %.565 = fadd contract double %.80.i38, 0.000000e+00
  %.58.i43 = fmul contract double %arg.mass_fraction.0, %.565
  %.64.i44 = fmul contract double %arg.mass_fraction.1, %.562
  %.80.i45 = fadd contract double %.64.i44, %.58.i43
  %.46.i46 = fmul contract double %arg.mass_fraction.0, %.562
  %.52.i47 = fmul contract double %arg.mass_fraction.1, %.565
  %.70.i48 = fsub contract double %.46.i46, %.52.i47
  %.614 = fadd contract double %.494, %.70.i48
  %.617 = fadd contract double %.497, %.80.i45
  %.58.i50 = fmul contract double %.70.i27, %.617
  %.64.i51 = fmul contract double %0, %.614
  %.80.i52 = fadd contract double %.64.i51, %.58.i50
  %.46.i53 = fmul contract double %.70.i27, %.614
  %.52.i54 = fmul contract double %0, %.617
  %.70.i55 = fsub contract double %.46.i53, %.52.i54
  %.666 = fadd contract double %.70.i55, %.396
  %.669 = fadd contract double %.80.i52, %.398
  store double %.666, ptr %.394, align 8
  store double %.669, ptr %.397, align 8
  %.777 = getelementptr i8, ptr %arg.out.4, i64 96
  %.779 = load double, ptr %.777, align 8
  %.780 = getelementptr i8, ptr %arg.out.4, i64 104
  %.781 = load double, ptr %.780, align 8
  %.58.i57 = fmul contract double %.80.i3, 0x400921FB54442D18
  %.80.i59 = fadd contract double %.64.i23, %.58.i57
  %.46.i60 = fmul contract double %.70.i6, 0x400921FB54442D18
  %.70.i62 = fsub contract double %.46.i60, %.52.i26
  %.58.i64 = fmul contract double %arg.mass_fraction.1, 2.600000e+02
  %.80.i66 = fadd contract double %.64.i9, %.58.i64
  %.46.i67 = fmul contract double %arg.mass_fraction.0, 2.600000e+02
  %.70.i69 = fsub contract double %.46.i67, %.52.i12
  %.877 = fadd contract double %.70.i69, 0x407F0AAAAAAAAAAB
  %.880 = fadd contract double %.80.i66, 0.000000e+00
  %.58.i71 = fmul contract double %.880, %.70.i62
  %.64.i72 = fmul contract double %.877, %.80.i59
  %.80.i73 = fadd contract double %.64.i72, %.58.i71
  %.46.i74 = fmul contract double %.877, %.70.i62
  %.52.i75 = fmul contract double %.880, %.80.i59
  %.70.i76 = fsub contract double %.46.i74, %.52.i75
  %.929 = fadd contract double %.70.i76, %.779
  %.932 = fadd contract double %.80.i73, %.781
  store double %.929, ptr %.777, align 8
  store double %.932, ptr %.780, align 8
  %.58.i78 = fmul contract double %.80.i, 0x4020F1C71C71C71C
  %.80.i80 = fadd contract double %.64.i30, %.58.i78
  %.46.i81 = fmul contract double %.70.i, 0x4020F1C71C71C71C
  %2 = fsub contract double %.52.i33, %.46.i81
  %.1050 = fadd contract double %2, 0x40C10436B015AC05
  %.1053 = fsub contract double 0.000000e+00, %.80.i80
  %.58.i85 = fmul contract double %.70.i, %.1053
  %.64.i86 = fmul contract double %.80.i, %.1050
  %.80.i87 = fadd contract double %.64.i86, %.58.i85
  %.46.i88 = fmul contract double %.70.i, %.1050
  %.52.i89 = fmul contract double %.80.i, %.1053
  %.70.i90 = fsub contract double %.46.i88, %.52.i89
  %.1110 = fadd contract double %.70.i90, 0xC0C7044BD0923320
  %.1113 = fadd contract double %.80.i87, 0.000000e+00
  %.58.i92 = fmul contract double %.80.i, 0x404070E38E38E38E
  %.80.i94 = fadd contract double %.64.i30, %.58.i92
  %.46.i95 = fmul contract double %.70.i, 0x404070E38E38E38E
  %.70.i97 = fsub contract double %.46.i95, %.52.i33
  %.1178 = fadd contract double %.70.i97, 0x40B0B864F3CF3CF4
  %.1181 = fadd contract double %.80.i94, 0.000000e+00
  %.58.i99 = fmul contract double %.70.i, %.1181
  %.64.i100 = fmul contract double %.80.i, %.1178
  %.80.i101 = fadd contract double %.64.i100, %.58.i99
  %.46.i102 = fmul contract double %.70.i, %.1178
  %.52.i103 = fmul contract double %.80.i, %.1181
  %3 = fsub contract double %.52.i103, %.46.i102
  %.1238 = fadd contract double %3, 0x40AB9B8B602B580B
  %.1241 = fsub contract double 0.000000e+00, %.80.i101
  %.1296 = getelementptr i8, ptr %arg.out.4, i64 112
  %.1298 = load double, ptr %.1296, align 8
  %.1299 = getelementptr i8, ptr %arg.out.4, i64 120
  %.1300 = load double, ptr %.1299, align 8
  %.58.i106 = fmul contract double %arg.mass_fraction.1, %.1110
  %.64.i107 = fmul contract double %arg.mass_fraction.0, %.1113
  %.80.i108 = fadd contract double %.64.i107, %.58.i106
  %.46.i109 = fmul contract double %arg.mass_fraction.0, %.1110
  %.52.i110 = fmul contract double %arg.mass_fraction.1, %.1113
  %.70.i111 = fsub contract double %.46.i109, %.52.i110
  %.58.i113 = fmul contract double %arg.mass_fraction.1, 2.000000e+00
  %.80.i115 = fadd contract double %.64.i9, %.58.i113
  %.46.i116 = fmul contract double %arg.mass_fraction.0, 2.000000e+00
  %.70.i118 = fsub contract double %.46.i116, %.52.i12
  %.1388 = fadd contract double %.70.i118, -1.000000e+00
  %.58.i120 = fmul contract double %.80.i115, %.1238
  %.64.i121 = fmul contract double %.1388, %.1241
  %.80.i122 = fadd contract double %.64.i121, %.58.i120
  %.46.i123 = fmul contract double %.1388, %.1238
  %.52.i124 = fmul contract double %.80.i115, %.1241
  %.70.i125 = fsub contract double %.46.i123, %.52.i124
  %.1440 = fadd contract double %.70.i111, %.70.i125
  %.1443 = fadd contract double %.80.i108, %.80.i122
  %.58.i127 = fmul contract double %.70.i6, %.1443
  %.64.i128 = fmul contract double %.80.i3, %.1440
  %.80.i129 = fadd contract double %.64.i128, %.58.i127
  %.46.i130 = fmul contract double %.70.i6, %.1440
  %.52.i131 = fmul contract double %.80.i3, %.1443
  %.70.i132 = fsub contract double %.46.i130, %.52.i131
  %.1492 = fadd contract double %.70.i132, %.1298
  %.1495 = fadd contract double %.80.i129, %.1300
  store double %.1492, ptr %.1296, align 8
  store double %.1495, ptr %.1299, align 8
  store ptr null, ptr %retptr, align 8
  ret void
}

; Function Attrs: mustprogress nofree norecurse nosync nounwind willreturn memory(argmem: readwrite)
define internal fastcc void @inner_6(ptr noalias nonnull writeonly captures(none) initializes((0, 8)) %retptr, double %arg.mass_fraction.0, double %arg.mass_fraction.1, double %arg.chi.0, double %arg.chi.1, double %arg.quadrupole.0, double %arg.quadrupole.1, ptr captures(none) %arg.out.4) unnamed_addr #6 {
entry:
  %.58.i = fmul contract double %arg.mass_fraction.0, %arg.chi.1
  %.64.i = fmul contract double %arg.mass_fraction.1, %arg.chi.0
  %.80.i = fadd contract double %.64.i, %.58.i
  %.46.i = fmul contract double %arg.mass_fraction.0, %arg.chi.0
  %.52.i = fmul contract double %arg.mass_fraction.1, %arg.chi.1
  %.70.i = fsub contract double %.46.i, %.52.i
  %.58.i1 = fmul contract double %.70.i, %.80.i
  %.80.i3 = fadd contract double %.58.i1, %.58.i1
  %.46.i4 = fmul contract double %.70.i, %.70.i
  %.52.i5 = fmul contract double %.80.i, %.80.i
  %.70.i6 = fsub contract double %.46.i4, %.52.i5
  %.177 = getelementptr i8, ptr %arg.out.4, i64 64
  %.179 = load double, ptr %.177, align 8
  %.180 = getelementptr i8, ptr %arg.out.4, i64 72
  %.181 = load double, ptr %.180, align 8
  %.58.i8 = fmul contract double %arg.quadrupole.1, 5.000000e+01
  %.64.i9 = fmul contract double %arg.quadrupole.0, 0.000000e+00
  %.80.i10 = fadd contract double %.64.i9, %.58.i8
  %.46.i11 = fmul contract double %arg.quadrupole.0, 5.000000e+01
  %.52.i12 = fmul contract double %arg.quadrupole.1, 0.000000e+00
  %.70.i13 = fsub contract double %.46.i11, %.52.i12
  %.191 = fneg contract double %.70.i6
  %.261 = fadd contract double %.70.i13, 6.250000e-01
  %.264 = fadd contract double %.80.i10, 0.000000e+00
  %.58.i15 = fmul contract double %.264, %.191
  %0 = fmul contract double %.80.i3, %.261
  %.80.i17 = fsub contract double %.58.i15, %0
  %1 = fmul contract double %.80.i3, %.264
  %2 = fmul contract double %.70.i6, %.261
  %.70.i20 = fsub contract double %1, %2
  %.313 = fadd contract double %.70.i20, %.179
  %.316 = fadd contract double %.80.i17, %.181
  store double %.313, ptr %.177, align 8
  store double %.316, ptr %.180, align 8
  %.424 = getelementptr i8, ptr %arg.out.4, i64 96
  %.426 = load double, ptr %.424, align 8
  %.427 = getelementptr i8, ptr %arg.out.4, i64 104
  %.428 = load double, ptr %.427, align 8
  %.58.i22 = fmul contract double %arg.mass_fraction.1, 1.200000e+02
  %.64.i23 = fmul contract double %arg.mass_fraction.0, 0.000000e+00
  %.80.i24 = fadd contract double %.64.i23, %.58.i22
  %.46.i25 = fmul contract double %arg.mass_fraction.0, 1.200000e+02
  %.52.i26 = fmul contract double %arg.mass_fraction.1, 0.000000e+00
  %3 = fsub contract double %.52.i26, %.46.i25
  %.490 = fadd contract double %3, 0x407E92AAAAAAAAAB
  %.493 = fsub contract double 0.000000e+00, %.80.i24
  %.58.i29 = fmul contract double %arg.mass_fraction.0, %.493
  %.64.i30 = fmul contract double %arg.mass_fraction.1, %.490
  %.80.i31 = fadd contract double %.64.i30, %.58.i29
  %.46.i32 = fmul contract double %arg.mass_fraction.0, %.490
  %.52.i33 = fmul contract double %arg.mass_fraction.1, %.493
  %.70.i34 = fsub contract double %.46.i32, %.52.i33
  %.550 = fadd contract double %.70.i34, 0x40817F8618618618
  %.553 = fadd contract double %.80.i31, 0.000000e+00
  %.58.i36 = fmul contract double %arg.quadrupole.0, %.553
  %.64.i37 = fmul contract double %arg.quadrupole.1, %.550
  %.80.i38 = fadd contract double %.64.i37, %.58.i36
  %.46.i39 = fmul contract double %arg.quadrupole.0, %.550
  %.52.i40 = fmul contract double %arg.quadrupole.1, %.553
  %.70.i41 = fsub contract double %.46.i39, %.52.i40
  %.58.i43 = fmul contract double %arg.mass_fraction.1, 0x40416E38E38E38E4
  %.80.i45 = fadd contract double %.64.i23, %.58.i43
  %.46.i46 = fmul contract double %arg.mass_fraction.0, 0x40416E38E38E38E4
  %4 = fsub contract double %.52.i26, %.46.i46
  %.644 = fadd contract double %4, 0x40569AAAAAAAAAAB
  %.647 = fsub contract double 0.000000e+00, %.80.i45
  %.58.i50 = fmul contract double %arg.mass_fraction.0, %.647
  %.64.i51 = fmul contract double %arg.mass_fraction.1, %.644
  %.80.i52 = fadd contract double %.64.i51, %.58.i50
  %.46.i53 = fmul contract double %arg.mass_fraction.0, %.644
  %.52.i54 = fmul contract double %arg.mass_fraction.1, %.647
  %.70.i55 = fsub contract double %.46.i53, %.52.i54
  %.704 = fadd contract double %.70.i55, 0x40831AC618618618
  %.707 = fadd contract double %.80.i52, 0.000000e+00
  %.730 = fsub contract double %.70.i41, %.704
  %.733 = fsub contract double %.80.i38, %.707
  %.58.i57 = fmul contract double %.70.i6, %.733
  %.64.i58 = fmul contract double %.80.i3, %.730
  %.80.i59 = fadd contract double %.64.i58, %.58.i57
  %.46.i60 = fmul contract double %.70.i6, %.730
  %.52.i61 = fmul contract double %.80.i3, %.733
  %.70.i62 = fsub contract double %.46.i60, %.52.i61
  %.782 = fadd contract double %.70.i62, %.426
  %.785 = fadd contract double %.80.i59, %.428
  store double %.782, ptr %.424, align 8
  store double %.785, ptr %.427, align 8
  %.893 = getelementptr i8, ptr %arg.out.4, i64 112
  %.895 = load double, ptr %.893, align 8
  %.896 = getelementptr i8, ptr %arg.out.4, i64 120
  %.897 = load double, ptr %.896, align 8
  %.58.i64 = fmul contract double %.80.i3, 0x4093A28C59D5433B
  %.64.i65 = fmul contract double %.70.i6, 0.000000e+00
  %5 = fsub contract double %.64.i65, %.58.i64
  %.46.i67 = fmul contract double %.70.i6, 0xC093A28C59D5433B
  %.52.i68 = fmul contract double %.80.i3, 0.000000e+00
  %.70.i69 = fsub contract double %.46.i67, %.52.i68
  %.58.i71 = fmul contract double %arg.quadrupole.1, %.70.i69
  %.64.i72 = fmul contract double %arg.quadrupole.0, %5
  %.80.i73 = fadd contract double %.64.i72, %.58.i71
  %.46.i74 = fmul contract double %arg.quadrupole.0, %.70.i69
  %.52.i75 = fmul contract double %arg.quadrupole.1, %5
  %.70.i76 = fsub contract double %.46.i74, %.52.i75
  %.978 = fadd contract double %.70.i76, %.895
  %.981 = fadd contract double %.80.i73, %.897
  store double %.978, ptr %.893, align 8
  store double %.981, ptr %.896, align 8
  store ptr null, ptr %retptr, align 8
  ret void
}

; Function Attrs: mustprogress nofree norecurse nosync nounwind willreturn memory(argmem: readwrite)
define internal fastcc void @inner_7(ptr noalias nonnull writeonly captures(none) initializes((0, 8)) %retptr, double %arg.mass_fraction.0, double %arg.mass_fraction.1, double %arg.tidal_deformability.0, double %arg.tidal_deformability.1, ptr captures(none) %arg.out.4) unnamed_addr #6 {
entry:
  %.58.i = fmul contract double %arg.mass_fraction.0, %arg.mass_fraction.1
  %.80.i = fadd contract double %.58.i, %.58.i
  %.46.i = fmul contract double %arg.mass_fraction.0, %arg.mass_fraction.0
  %.52.i = fmul contract double %arg.mass_fraction.1, %arg.mass_fraction.1
  %.70.i = fsub contract double %.46.i, %.52.i
  %.58.i3 = fmul contract double %.70.i, %.80.i
  %.80.i5 = fadd contract double %.58.i3, %.58.i3
  %.46.i6 = fmul contract double %.70.i, %.70.i
  %.52.i7 = fmul contract double %.80.i, %.80.i
  %.70.i8 = fsub contract double %.46.i6, %.52.i7
  %.58.i10 = fmul contract double %.80.i5, 2.400000e+01
  %.64.i11 = fmul contract double %.70.i8, 0.000000e+00
  %0 = fsub contract double %.64.i11, %.58.i10
  %.46.i13 = fmul contract double %.70.i8, -2.400000e+01
  %.52.i14 = fmul contract double %.80.i5, 0.000000e+00
  %.70.i15 = fsub contract double %.46.i13, %.52.i14
  %.58.i17 = fmul contract double %arg.tidal_deformability.1, %.70.i15
  %.64.i18 = fmul contract double %arg.tidal_deformability.0, %0
  %.80.i19 = fadd contract double %.64.i18, %.58.i17
  %.46.i20 = fmul contract double %arg.tidal_deformability.0, %.70.i15
  %.52.i21 = fmul contract double %arg.tidal_deformability.1, %0
  %.70.i22 = fsub contract double %.46.i20, %.52.i21
  %.191 = getelementptr i8, ptr %arg.out.4, i64 160
  %.193 = load double, ptr %.191, align 8
  %.194 = getelementptr i8, ptr %arg.out.4, i64 168
  %.195 = load double, ptr %.194, align 8
  %.58.i24 = fmul contract double %arg.mass_fraction.1, 1.100000e+01
  %.64.i25 = fmul contract double %arg.mass_fraction.0, 0.000000e+00
  %.80.i26 = fadd contract double %.64.i25, %.58.i24
  %.46.i27 = fmul contract double %arg.mass_fraction.0, 1.100000e+01
  %.52.i28 = fmul contract double %arg.mass_fraction.1, 0.000000e+00
  %1 = fsub contract double %.52.i28, %.46.i27
  %.257 = fadd contract double %1, 1.200000e+01
  %.260 = fsub contract double 0.000000e+00, %.80.i26
  %.58.i31 = fmul contract double %.260, %.70.i22
  %.64.i32 = fmul contract double %.257, %.80.i19
  %.80.i33 = fadd contract double %.64.i32, %.58.i31
  %.46.i34 = fmul contract double %.257, %.70.i22
  %.52.i35 = fmul contract double %.260, %.80.i19
  %.70.i36 = fsub contract double %.46.i34, %.52.i35
  %.309 = fadd contract double %.70.i36, %.193
  %.312 = fadd contract double %.80.i33, %.195
  store double %.309, ptr %.191, align 8
  store double %.312, ptr %.194, align 8
  %.420 = getelementptr i8, ptr %arg.out.4, i64 192
  %.422 = load double, ptr %.420, align 8
  %.423 = getelementptr i8, ptr %arg.out.4, i64 200
  %.424 = load double, ptr %.423, align 8
  %.58.i38 = fmul contract double %.70.i22, 0.000000e+00
  %.64.i39 = fmul contract double %.80.i19, 5.000000e+00
  %.80.i40 = fadd contract double %.64.i39, %.58.i38
  %.46.i41 = fmul contract double %.70.i22, 5.000000e+00
  %.52.i42 = fmul contract double %.80.i19, 0.000000e+00
  %.70.i43 = fsub contract double %.46.i41, %.52.i42
  %.95.i = fmul contract double %.80.i40, 0.000000e+00
  %.97.i = fadd contract double %.70.i43, %.95.i
  %.105.i = fdiv contract double %.97.i, 6.720000e+02
  %.107.i = fmul contract double %.70.i43, 0.000000e+00
  %.109.i = fsub contract double %.80.i40, %.107.i
  %.117.i = fdiv contract double %.109.i, 6.720000e+02
  %.58.i45 = fmul contract double %arg.mass_fraction.1, 2.600000e+02
  %.80.i47 = fadd contract double %.64.i25, %.58.i45
  %.46.i48 = fmul contract double %arg.mass_fraction.0, 2.600000e+02
  %2 = fsub contract double %.52.i28, %.46.i48
  %.554 = fadd contract double %2, 2.286000e+03
  %.557 = fsub contract double 0.000000e+00, %.80.i47
  %.58.i52 = fmul contract double %arg.mass_fraction.0, %.557
  %.64.i53 = fmul contract double %arg.mass_fraction.1, %.554
  %.80.i54 = fadd contract double %.64.i53, %.58.i52
  %.46.i55 = fmul contract double %arg.mass_fraction.0, %.554
  %.52.i56 = fmul contract double %arg.mass_fraction.1, %.557
  %.70.i57 = fsub contract double %.46.i55, %.52.i56
  %.614 = fadd contract double %.70.i57, 9.190000e+02
  %.617 = fadd contract double %.80.i54, 0.000000e+00
  %.58.i59 = fmul contract double %arg.mass_fraction.0, %.617
  %.64.i60 = fmul contract double %arg.mass_fraction.1, %.614
  %.80.i61 = fadd contract double %.64.i60, %.58.i59
  %.46.i62 = fmul contract double %arg.mass_fraction.0, %.614
  %.52.i63 = fmul contract double %arg.mass_fraction.1, %.617
  %3 = fsub contract double %.52.i63, %.46.i62
  %.674 = fadd contract double %3, 3.179000e+03
  %.677 = fsub contract double 0.000000e+00, %.80.i61
  %.58.i66 = fmul contract double %.677, %.105.i
  %.64.i67 = fmul contract double %.674, %.117.i
  %.80.i68 = fadd contract double %.64.i67, %.58.i66
  %.46.i69 = fmul contract double %.674, %.105.i
  %.52.i70 = fmul contract double %.677, %.117.i
  %.70.i71 = fsub contract double %.46.i69, %.52.i70
  %.726 = fadd contract double %.70.i71, %.422
  %.729 = fadd contract double %.80.i68, %.424
  store double %.726, ptr %.420, align 8
  store double %.729, ptr %.423, align 8
  %.837 = getelementptr i8, ptr %arg.out.4, i64 208
  %.839 = load double, ptr %.837, align 8
  %.840 = getelementptr i8, ptr %arg.out.4, i64 216
  %.841 = load double, ptr %.840, align 8
  %.58.i73 = fmul contract double %.80.i19, 0x400921FB54442D18
  %4 = fsub contract double %.58.i38, %.58.i73
  %.46.i76 = fmul contract double %.70.i22, 0xC00921FB54442D18
  %.70.i78 = fsub contract double %.46.i76, %.52.i42
  %.58.i87 = fmul contract double %.260, %.70.i78
  %.64.i88 = fmul contract double %.257, %4
  %.80.i89 = fadd contract double %.64.i88, %.58.i87
  %.46.i90 = fmul contract double %.257, %.70.i78
  %.52.i91 = fmul contract double %.260, %4
  %.70.i92 = fsub contract double %.46.i90, %.52.i91
  %.990 = fadd contract double %.70.i92, %.839
  %.993 = fadd contract double %.80.i89, %.841
  store double %.990, ptr %.837, align 8
  store double %.993, ptr %.840, align 8
  %.58.i94 = fmul contract double %arg.mass_fraction.1, 0x4151712000000000
  %.80.i96 = fadd contract double %.64.i25, %.58.i94
  %.46.i97 = fmul contract double %arg.mass_fraction.0, 0x4151712000000000
  %5 = fsub contract double %.52.i28, %.46.i97
  %.1111 = fadd contract double %5, 0x41737B1700000000
  %.1114 = fsub contract double 0.000000e+00, %.80.i96
  %.58.i101 = fmul contract double %arg.mass_fraction.0, %.1114
  %.64.i102 = fmul contract double %arg.mass_fraction.1, %.1111
  %.80.i103 = fadd contract double %.64.i102, %.58.i101
  %.46.i104 = fmul contract double %arg.mass_fraction.0, %.1111
  %.52.i105 = fmul contract double %arg.mass_fraction.1, %.1114
  %6 = fsub contract double %.52.i105, %.46.i104
  %.1171 = fadd contract double %6, 0x41A2E151D8000000
  %.1174 = fsub contract double 0.000000e+00, %.80.i103
  %.1229 = getelementptr i8, ptr %arg.out.4, i64 224
  %.1231 = load double, ptr %.1229, align 8
  %.1232 = getelementptr i8, ptr %arg.out.4, i64 232
  %.1233 = load double, ptr %.1232, align 8
  %.105.i117 = fdiv contract double %.97.i, 0x417A29B000000000
  %.117.i120 = fdiv contract double %.109.i, 0x417A29B000000000
  %.58.i122 = fmul contract double %arg.mass_fraction.0, %.1174
  %.64.i123 = fmul contract double %arg.mass_fraction.1, %.1171
  %.80.i124 = fadd contract double %.64.i123, %.58.i122
  %.46.i125 = fmul contract double %arg.mass_fraction.0, %.1171
  %.52.i126 = fmul contract double %arg.mass_fraction.1, %.1174
  %.70.i127 = fsub contract double %.46.i125, %.52.i126
  %.1355 = fadd contract double %.70.i127, 0x41A4DB86E0000000
  %.1358 = fadd contract double %.80.i124, 0.000000e+00
  %.58.i129 = fmul contract double %arg.mass_fraction.0, %.1358
  %.64.i130 = fmul contract double %arg.mass_fraction.1, %.1355
  %.80.i131 = fadd contract double %.64.i130, %.58.i129
  %.46.i132 = fmul contract double %arg.mass_fraction.0, %.1355
  %.52.i133 = fmul contract double %arg.mass_fraction.1, %.1358
  %.70.i134 = fsub contract double %.46.i132, %.52.i133
  %.1415 = fadd contract double %.70.i134, 0x41849F27B8000000
  %.1418 = fadd contract double %.80.i131, 0.000000e+00
  %.58.i136 = fmul contract double %arg.mass_fraction.0, %.1418
  %.64.i137 = fmul contract double %arg.mass_fraction.1, %.1415
  %.80.i138 = fadd contract double %.64.i137, %.58.i136
  %.46.i139 = fmul contract double %arg.mass_fraction.0, %.1415
  %.52.i140 = fmul contract double %arg.mass_fraction.1, %.1418
  %7 = fsub contract double %.52.i140, %.46.i139
  %.1475 = fadd contract double %7, 0x41B72002EE000000
  %.1478 = fsub contract double 0.000000e+00, %.80.i138
  %.58.i143 = fmul contract double %.105.i117, %.1478
  %.64.i144 = fmul contract double %.117.i120, %.1475
  %.80.i145 = fadd contract double %.64.i144, %.58.i143
  %.46.i146 = fmul contract double %.105.i117, %.1475
  %.52.i147 = fmul contract double %.117.i120, %.1478
  %.70.i148 = fsub contract double %.46.i146, %.52.i147
  %.1527 = fadd contract double %.70.i148, %.1231
  %.1530 = fadd contract double %.80.i145, %.1233
  store double %.1527, ptr %.1229, align 8
  store double %.1530, ptr %.1232, align 8
  %.1638 = getelementptr i8, ptr %arg.out.4, i64 240
  %.1640 = load double, ptr %.1638, align 8
  %.1641 = getelementptr i8, ptr %arg.out.4, i64 248
  %.1642 = load double, ptr %.1641, align 8
  %.95.i157 = fmul contract double %4, 0.000000e+00
  %.97.i158 = fadd contract double %.70.i78, %.95.i157
  %.105.i159 = fdiv contract double %.97.i158, 6.720000e+02
  %.107.i160 = fmul contract double %.70.i78, 0.000000e+00
  %.109.i161 = fsub contract double %4, %.107.i160
  %.117.i162 = fdiv contract double %.109.i161, 6.720000e+02
  %.58.i164 = fmul contract double %arg.mass_fraction.1, 1.052000e+04
  %.80.i166 = fadd contract double %.64.i25, %.58.i164
  %.46.i167 = fmul contract double %arg.mass_fraction.0, 1.052000e+04
  %8 = fsub contract double %.52.i28, %.46.i167
  %.1773 = fadd contract double %8, 7.598000e+03
  %.1776 = fsub contract double 0.000000e+00, %.80.i166
  %.58.i171 = fmul contract double %arg.mass_fraction.0, %.1776
  %.64.i172 = fmul contract double %arg.mass_fraction.1, %.1773
  %.80.i173 = fadd contract double %.64.i172, %.58.i171
  %.46.i174 = fmul contract double %arg.mass_fraction.0, %.1773
  %.52.i175 = fmul contract double %arg.mass_fraction.1, %.1776
  %9 = fsub contract double %.52.i175, %.46.i174
  %.1833 = fadd contract double %9, 2.241500e+04
  %.1836 = fsub contract double 0.000000e+00, %.80.i173
  %.58.i178 = fmul contract double %arg.mass_fraction.0, %.1836
  %.64.i179 = fmul contract double %arg.mass_fraction.1, %.1833
  %.80.i180 = fadd contract double %.64.i179, %.58.i178
  %.46.i181 = fmul contract double %arg.mass_fraction.0, %.1833
  %.52.i182 = fmul contract double %arg.mass_fraction.1, %.1836
  %10 = fsub contract double %.52.i182, %.46.i181
  %.1893 = fadd contract double %10, 2.771900e+04
  %.1896 = fsub contract double 0.000000e+00, %.80.i180
  %.58.i185 = fmul contract double %.1896, %.105.i159
  %.64.i186 = fmul contract double %.1893, %.117.i162
  %.80.i187 = fadd contract double %.64.i186, %.58.i185
  %.46.i188 = fmul contract double %.1893, %.105.i159
  %.52.i189 = fmul contract double %.1896, %.117.i162
  %.70.i190 = fsub contract double %.46.i188, %.52.i189
  %.1945 = fadd contract double %.70.i190, %.1640
  %.1948 = fadd contract double %.80.i187, %.1642
  store double %.1945, ptr %.1638, align 8
  store double %.1948, ptr %.1641, align 8
  store ptr null, ptr %retptr, align 8
  ret void
}

; Function Attrs: nofree noinline norecurse nosync nounwind memory(readwrite, inaccessiblemem: none, target_mem0: none, target_mem1: none)
define internal fastcc void @inner_3(ptr noalias nonnull writeonly captures(none) %retptr, ptr readonly captures(none) %arg.coordinates.4, i64 %arg.rows, ptr readonly captures(none) %arg.contents.4, ptr readonly captures(none) %arg.exponents.4, ptr readonly captures(none) %arg.weights.4, ptr initializes((56, 64)) %arg.scratch.4) unnamed_addr #7 {
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
  br i1 %.216, label %B0.endif.else.endif.endif.if, label %B0.endif.else.endif.endif.endif, !prof !24

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
  br i1 %.101.i, label %B0.else.if.i, label %B0.else.endif.i, !prof !24

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
  br i1 %.106.not.i, label %B0.else.endif.endif.i, label %B0.else.endif.if.i, !prof !39

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
  %.366.i = load <8 x double>, ptr %.364.i, align 8, !noalias !273
  %.371.i = mul nsw i64 %.324433441.i, %.54.i
  %.411.i = icmp slt i64 %.371.i, 0
  %.412.i = select i1 %.411.i, i64 %.453, i64 0
  %.413.i = add i64 %.412.i, %.371.i
  %.416.i = icmp slt i64 %.413.i, 0
  br i1 %.416.i, label %B88.else.if.i, label %B88.else.endif.i, !prof !24

B88.else.if.i:                                    ; preds = %B86.if.i
  br label %B88.else.endif.i

B88.else.endif.i:                                 ; preds = %B88.else.if.i, %B86.if.i
  %.401.sroa.0.1.i = phi i64 [ 0, %B88.else.if.i ], [ %.413.i, %B86.if.i ]
  %.421.not.i = icmp slt i64 %.413.i, %.453
  br i1 %.421.not.i, label %B88.else.endif.endif.i, label %B88.else.endif.if.i, !prof !39

B88.else.endif.if.i:                              ; preds = %B88.else.endif.i
  br label %B88.else.endif.endif.i

B88.else.endif.endif.i:                           ; preds = %B88.else.endif.if.i, %B88.else.endif.i
  %.401.sroa.0.3.i = phi i64 [ %.453, %B88.else.endif.if.i ], [ %.401.sroa.0.1.i, %B88.else.endif.i ]
  %.514.i = getelementptr double, ptr %.469, i64 %.401.sroa.0.3.i
  store <8 x double> splat (double 1.000000e+00), ptr %.514.i, align 8, !noalias !273
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
  store <8 x double> %current.2.1428.i, ptr %lsr.iv31.i, align 8, !noalias !273
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
  %.920.i = load i64, ptr %scevgep20.i, align 8, !noalias !273
  %.929.idx.i = shl nsw i64 %.920.i, 6
  %.929.i = getelementptr inbounds i8, ptr %.469, i64 %.929.idx.i
  %.931.i = load <8 x double>, ptr %.929.i, align 8, !noalias !273
  %scevgep21.i = getelementptr i8, ptr %lsr.iv.i, i64 -24
  %.942.i = load i64, ptr %scevgep21.i, align 8, !noalias !273
  %.54410.i = add i64 %.942.i, %.53.i
  %.953.idx.i = shl i64 %.54410.i, 6
  %.953.i = getelementptr inbounds i8, ptr %.469, i64 %.953.idx.i
  %.955.i = load <8 x double>, ptr %.953.i, align 8, !noalias !273
  %scevgep22.i = getelementptr i8, ptr %lsr.iv.i, i64 -16
  %.968.i = load i64, ptr %scevgep22.i, align 8, !noalias !273
  %.978.idx.i = shl i64 %.968.i, 6
  %.978.i = getelementptr i8, ptr %0, i64 %.978.idx.i
  %.980.i = load <8 x double>, ptr %.978.i, align 8, !noalias !273
  %scevgep23.i = getelementptr i8, ptr %lsr.iv.i, i64 -8
  %.993.i = load i64, ptr %scevgep23.i, align 8, !noalias !273
  %.1003.idx.i = shl i64 %.993.i, 6
  %.1003.i = getelementptr i8, ptr %1, i64 %.1003.idx.i
  %.1005.i = load <8 x double>, ptr %.1003.i, align 8, !noalias !273
  %.1018.i = load i64, ptr %lsr.iv.i, align 8, !noalias !273
  %.1028.idx.i = shl i64 %.1018.i, 6
  %.1028.i = getelementptr i8, ptr %2, i64 %.1028.idx.i
  %.1030.i = load <8 x double>, ptr %.1028.i, align 8, !noalias !273
  %.6.i15.i = fmul contract <8 x double> %.931.i, %.955.i
  %.6.i16.i = fmul contract <8 x double> %.980.i, %.1005.i
  %.6.i17.i = fmul contract <8 x double> %.6.i15.i, %.6.i16.i
  %.6.i18.i = fmul contract <8 x double> %.6.i17.i, %.1030.i
  store <8 x double> %.6.i18.i, ptr %lsr.iv24.i, align 8, !noalias !273
  %scevgep19.i = getelementptr i8, ptr %lsr.iv.i, i64 40
  %scevgep25.i = getelementptr i8, ptr %lsr.iv24.i, i64 64
  %lsr.iv.next.i = add i64 %lsr.iv26.i, -1
  %exitcond474.not.i = icmp eq i64 %lsr.iv.next.i, 0
  br i1 %exitcond474.not.i, label %_ZN17bnserve_surrogate6kernel11_regression9_productsB3v78B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedExx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit, label %B448.if.i

_ZN17bnserve_surrogate6kernel11_regression9_productsB3v78B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedExx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit: ; preds = %B448.if.i
  %.174.i = sub nsw i64 %.453, %.86.sroa.0.3.i
  %.183.i = tail call i64 @llvm.smax.i64(i64 %.174.i, i64 0)
  %.1010 = getelementptr i8, ptr %arg.contents.4, i64 88
  %.1011 = load i64, ptr %.1010, align 8
  %5 = lshr i64 %.1011, 33
  %.1049 = and i64 %5, 1073741824
  %.1050 = add i64 %.1049, %.1011
  %.1053 = icmp slt i64 %.1050, 0
  br i1 %.1053, label %B348.endif.else.if, label %B348.endif.else.endif, !prof !24

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
  br i1 %.1848, label %B740.else.if, label %B740.else.endif, !prof !24

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
  br i1 %.221.not, label %B0.endif.else.endif.endif.endif.endif, label %B0.endif.else.endif.endif.endif.if, !prof !39

B0.endif.else.endif.endif.endif.if:               ; preds = %B0.endif.else.endif.endif.endif
  br label %B0.endif.else.endif.endif.endif.endif

B0.endif.else.endif.endif.endif.endif:            ; preds = %B0.endif.else.endif.endif.endif.if, %B0.endif.else.endif.endif.endif
  %.184.sroa.13.2 = phi i64 [ 1073741824, %B0.endif.else.endif.endif.endif.if ], [ %.184.sroa.13.1, %B0.endif.else.endif.endif.endif ]
  br i1 %.216, label %B0.endif.endif.else.if, label %B0.endif.endif.else.endif, !prof !24

B0.endif.endif.else.if:                           ; preds = %B0.endif.else.endif.endif.endif.endif
  br label %B0.endif.endif.else.endif

B0.endif.endif.else.endif:                        ; preds = %B0.endif.endif.else.if, %B0.endif.else.endif.endif.endif.endif
  %.356.sroa.0.1 = phi i64 [ 0, %B0.endif.endif.else.if ], [ %.213, %B0.endif.else.endif.endif.endif.endif ]
  br i1 %.221.not, label %B0.endif.endif.else.endif.endif, label %B0.endif.endif.else.endif.if, !prof !39

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

B348.endif.else.if:                               ; preds = %_ZN17bnserve_surrogate6kernel11_regression9_productsB3v78B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedExx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit
  br label %B348.endif.else.endif

B348.endif.else.endif:                            ; preds = %B348.endif.else.if, %_ZN17bnserve_surrogate6kernel11_regression9_productsB3v78B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedExx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit
  %.1038.sroa.0.1 = phi i64 [ 0, %B348.endif.else.if ], [ %.1050, %_ZN17bnserve_surrogate6kernel11_regression9_productsB3v78B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedExx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit ]
  %.1058.not = icmp slt i64 %.1050, 1073741824
  br i1 %.1058.not, label %B348.endif.else.endif.endif, label %B348.endif.else.endif.if, !prof !39

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
  br i1 %.1351, label %B548.else.if, label %B548.else.endif, !prof !24

B548.else.if:                                     ; preds = %B546.if
  br label %B548.else.endif

B548.else.endif:                                  ; preds = %B548.else.if, %B546.if
  %.1336.sroa.0.1 = phi i64 [ 0, %B548.else.if ], [ %.1348, %B546.if ]
  %.1356.not = icmp slt i64 %.1348, %.184.sroa.13.2
  br i1 %.1356.not, label %B548.else.endif.endif, label %B548.else.endif.if, !prof !39

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
  br i1 %.1553, label %B548.endif.else.if, label %B548.endif.else.endif, !prof !24

B548.endif.else.if:                               ; preds = %B548.else.endif.endif
  br label %B548.endif.else.endif

B548.endif.else.endif:                            ; preds = %B548.endif.else.if, %B548.else.endif.endif
  %.1538.sroa.0.1 = phi i64 [ 0, %B548.endif.else.if ], [ %.1550, %B548.else.endif.endif ]
  %.1558.not = icmp slt i64 %.1550, %.183.i
  br i1 %.1558.not, label %B548.endif.else.endif.endif, label %B548.endif.else.endif.if, !prof !39

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
  %_multiply_wide_v84_a00.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B84.if.i ], [ %.577.i, %B200.if.i ]
  %_multiply_wide_v84_a01.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B84.if.i ], [ %.581.i, %B200.if.i ]
  %_multiply_wide_v84_a02.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B84.if.i ], [ %.589.i, %B200.if.i ]
  %_multiply_wide_v84_a03.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B84.if.i ], [ %.593.i, %B200.if.i ]
  %_multiply_wide_v84_a10.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B84.if.i ], [ %.614.i, %B200.if.i ]
  %_multiply_wide_v84_a11.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B84.if.i ], [ %.618.i, %B200.if.i ]
  %_multiply_wide_v84_a12.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B84.if.i ], [ %.626.i, %B200.if.i ]
  %_multiply_wide_v84_a13.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B84.if.i ], [ %.630.i, %B200.if.i ]
  %_multiply_wide_v84_a20.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B84.if.i ], [ %.652.i, %B200.if.i ]
  %_multiply_wide_v84_a21.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B84.if.i ], [ %.656.i, %B200.if.i ]
  %_multiply_wide_v84_a22.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B84.if.i ], [ %.664.i, %B200.if.i ]
  %_multiply_wide_v84_a23.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B84.if.i ], [ %.668.i, %B200.if.i ]
  %_multiply_wide_v84_a30.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B84.if.i ], [ %.690.i, %B200.if.i ]
  %_multiply_wide_v84_a31.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B84.if.i ], [ %.694.i, %B200.if.i ]
  %_multiply_wide_v84_a32.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B84.if.i ], [ %.702.i, %B200.if.i ]
  %_multiply_wide_v84_a33.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B84.if.i ], [ %.706.i, %B200.if.i ]
  store <8 x double> %_multiply_wide_v84_a00.2.1.lcssa.i, ptr %.237.i, align 8, !noalias !276
  %.765.i = getelementptr inbounds nuw i8, ptr %.237.i, i64 64
  store <8 x double> %_multiply_wide_v84_a01.2.1.lcssa.i, ptr %.765.i, align 8, !noalias !276
  %.776.i = getelementptr inbounds nuw i8, ptr %.237.i, i64 128
  store <8 x double> %_multiply_wide_v84_a02.2.1.lcssa.i, ptr %.776.i, align 8, !noalias !276
  %.787.i = getelementptr inbounds nuw i8, ptr %.237.i, i64 192
  store <8 x double> %_multiply_wide_v84_a03.2.1.lcssa.i, ptr %.787.i, align 8, !noalias !276
  %.817.i = getelementptr inbounds double, ptr %.237.i, i64 %.153
  store <8 x double> %_multiply_wide_v84_a10.2.1.lcssa.i, ptr %.817.i, align 8, !noalias !276
  %.827.i = getelementptr i8, ptr %.817.i, i64 64
  store <8 x double> %_multiply_wide_v84_a11.2.1.lcssa.i, ptr %.827.i, align 8, !noalias !276
  %.838.i = getelementptr i8, ptr %.817.i, i64 128
  store <8 x double> %_multiply_wide_v84_a12.2.1.lcssa.i, ptr %.838.i, align 8, !noalias !276
  %.849.i = getelementptr i8, ptr %.817.i, i64 192
  store <8 x double> %_multiply_wide_v84_a13.2.1.lcssa.i, ptr %.849.i, align 8, !noalias !276
  %.880.i = getelementptr inbounds i8, ptr %.237.i, i64 %.idx
  store <8 x double> %_multiply_wide_v84_a20.2.1.lcssa.i, ptr %.880.i, align 8, !noalias !276
  %.890.i = getelementptr i8, ptr %.880.i, i64 64
  store <8 x double> %_multiply_wide_v84_a21.2.1.lcssa.i, ptr %.890.i, align 8, !noalias !276
  %.901.i = getelementptr i8, ptr %.880.i, i64 128
  store <8 x double> %_multiply_wide_v84_a22.2.1.lcssa.i, ptr %.901.i, align 8, !noalias !276
  %.912.i = getelementptr i8, ptr %.880.i, i64 192
  store <8 x double> %_multiply_wide_v84_a23.2.1.lcssa.i, ptr %.912.i, align 8, !noalias !276
  %.950.i = getelementptr inbounds i8, ptr %.237.i, i64 %.idx854
  store <8 x double> %_multiply_wide_v84_a30.2.1.lcssa.i, ptr %.950.i, align 8, !noalias !276
  %.960.i = getelementptr i8, ptr %.950.i, i64 64
  store <8 x double> %_multiply_wide_v84_a31.2.1.lcssa.i, ptr %.960.i, align 8, !noalias !276
  %.971.i = getelementptr i8, ptr %.950.i, i64 128
  store <8 x double> %_multiply_wide_v84_a32.2.1.lcssa.i, ptr %.971.i, align 8, !noalias !276
  %.982.i = getelementptr i8, ptr %.950.i, i64 192
  store <8 x double> %_multiply_wide_v84_a33.2.1.lcssa.i, ptr %.982.i, align 8, !noalias !276
  %scevgep25.i8 = getelementptr i8, ptr %lsr.iv24.i3, i64 %31
  %.187.i = icmp sgt i64 %.186852864.i, 1
  br i1 %.187.i, label %B84.if.i, label %B354.else.loopexit.i

B1932.loopexit.i:                                 ; preds = %B884.if.i
  %34 = add i64 %position.5.0897.i, %40
  br label %B1932.i

B1932.i:                                          ; preds = %B356.if.i, %B1932.loopexit.i
  %position.4.1.lcssa.i = phi i64 [ %position.5.0897.i, %B356.if.i ], [ %34, %B1932.loopexit.i ]
  %b0.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B356.if.i ], [ %.1337.i, %B1932.loopexit.i ]
  %b1.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B356.if.i ], [ %.1356.i, %B1932.loopexit.i ]
  %b2.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B356.if.i ], [ %.1376.i, %B1932.loopexit.i ]
  %b3.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B356.if.i ], [ %.1396.i, %B1932.loopexit.i ]
  %.1418.i = getelementptr inbounds double, ptr %.1449, i64 %.1135889895.i
  store <8 x double> %b0.2.1.lcssa.i, ptr %.1418.i, align 8, !noalias !276
  %.1434.i = getelementptr double, ptr %37, i64 %.1135889895.i
  store <8 x double> %b1.2.1.lcssa.i, ptr %.1434.i, align 8, !noalias !276
  %.1451.i = getelementptr double, ptr %38, i64 %.1135889895.i
  store <8 x double> %b2.2.1.lcssa.i, ptr %.1451.i, align 8, !noalias !276
  %.1470.i = getelementptr double, ptr %39, i64 %.1135889895.i
  store <8 x double> %b3.2.1.lcssa.i, ptr %.1470.i, align 8, !noalias !276
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
  %_multiply_wide_v84_a33.2.1834.i = phi <8 x double> [ %.706.i, %B200.if.i ], [ zeroinitializer, %B84.if.i ]
  %_multiply_wide_v84_a32.2.1833.i = phi <8 x double> [ %.702.i, %B200.if.i ], [ zeroinitializer, %B84.if.i ]
  %_multiply_wide_v84_a31.2.1832.i = phi <8 x double> [ %.694.i, %B200.if.i ], [ zeroinitializer, %B84.if.i ]
  %_multiply_wide_v84_a30.2.1831.i = phi <8 x double> [ %.690.i, %B200.if.i ], [ zeroinitializer, %B84.if.i ]
  %_multiply_wide_v84_a23.2.1830.i = phi <8 x double> [ %.668.i, %B200.if.i ], [ zeroinitializer, %B84.if.i ]
  %_multiply_wide_v84_a22.2.1829.i = phi <8 x double> [ %.664.i, %B200.if.i ], [ zeroinitializer, %B84.if.i ]
  %_multiply_wide_v84_a21.2.1828.i = phi <8 x double> [ %.656.i, %B200.if.i ], [ zeroinitializer, %B84.if.i ]
  %_multiply_wide_v84_a20.2.1827.i = phi <8 x double> [ %.652.i, %B200.if.i ], [ zeroinitializer, %B84.if.i ]
  %_multiply_wide_v84_a13.2.1826.i = phi <8 x double> [ %.630.i, %B200.if.i ], [ zeroinitializer, %B84.if.i ]
  %_multiply_wide_v84_a12.2.1825.i = phi <8 x double> [ %.626.i, %B200.if.i ], [ zeroinitializer, %B84.if.i ]
  %_multiply_wide_v84_a11.2.1824.i = phi <8 x double> [ %.618.i, %B200.if.i ], [ zeroinitializer, %B84.if.i ]
  %_multiply_wide_v84_a10.2.1823.i = phi <8 x double> [ %.614.i, %B200.if.i ], [ zeroinitializer, %B84.if.i ]
  %_multiply_wide_v84_a03.2.1822.i = phi <8 x double> [ %.593.i, %B200.if.i ], [ zeroinitializer, %B84.if.i ]
  %_multiply_wide_v84_a02.2.1821.i = phi <8 x double> [ %.589.i, %B200.if.i ], [ zeroinitializer, %B84.if.i ]
  %_multiply_wide_v84_a01.2.1820.i = phi <8 x double> [ %.581.i, %B200.if.i ], [ zeroinitializer, %B84.if.i ]
  %_multiply_wide_v84_a00.2.1819.i = phi <8 x double> [ %.577.i, %B200.if.i ], [ zeroinitializer, %B84.if.i ]
  %35 = shl i64 %lsr.iv26.i4, 2
  %scevgep33.i = getelementptr i8, ptr %lsr.iv24.i3, i64 %35
  %scevgep34.i = getelementptr i8, ptr %scevgep33.i, i64 -192
  %.520.i = load <8 x double>, ptr %scevgep34.i, align 8, !noalias !276
  %scevgep32.i5 = getelementptr i8, ptr %scevgep33.i, i64 -128
  %.532.i = load <8 x double>, ptr %scevgep32.i5, align 8, !noalias !276
  %scevgep9 = getelementptr i8, ptr %scevgep33.i, i64 -64
  %.545.i = load <8 x double>, ptr %scevgep9, align 8, !noalias !276
  %.558.i = load <8 x double>, ptr %scevgep33.i, align 8, !noalias !276
  %scevgep26 = getelementptr i8, ptr %scevgep20, i64 %lsr.iv26.i4
  %scevgep27 = getelementptr i8, ptr %scevgep26, i64 -24
  %.573.i = load double, ptr %scevgep27, align 8, !noalias !276
  %.575.i = insertelement <8 x double> poison, double %.573.i, i64 0
  %.576.i = shufflevector <8 x double> %.575.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.577.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.520.i, <8 x double> %.576.i, <8 x double> %_multiply_wide_v84_a00.2.1819.i)
  %.581.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.532.i, <8 x double> %.576.i, <8 x double> %_multiply_wide_v84_a01.2.1820.i)
  %.589.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.545.i, <8 x double> %.576.i, <8 x double> %_multiply_wide_v84_a02.2.1821.i)
  %.593.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.558.i, <8 x double> %.576.i, <8 x double> %_multiply_wide_v84_a03.2.1822.i)
  %scevgep6 = getelementptr i8, ptr %scevgep26, i64 -16
  %.610.i = load double, ptr %scevgep6, align 8, !noalias !276
  %.612.i = insertelement <8 x double> poison, double %.610.i, i64 0
  %.613.i = shufflevector <8 x double> %.612.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.614.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.520.i, <8 x double> %.613.i, <8 x double> %_multiply_wide_v84_a10.2.1823.i)
  %.618.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.532.i, <8 x double> %.613.i, <8 x double> %_multiply_wide_v84_a11.2.1824.i)
  %.626.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.545.i, <8 x double> %.613.i, <8 x double> %_multiply_wide_v84_a12.2.1825.i)
  %.630.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.558.i, <8 x double> %.613.i, <8 x double> %_multiply_wide_v84_a13.2.1826.i)
  %scevgep3 = getelementptr i8, ptr %scevgep26, i64 -8
  %.648.i = load double, ptr %scevgep3, align 8, !noalias !276
  %.650.i = insertelement <8 x double> poison, double %.648.i, i64 0
  %.651.i = shufflevector <8 x double> %.650.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.652.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.520.i, <8 x double> %.651.i, <8 x double> %_multiply_wide_v84_a20.2.1827.i)
  %.656.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.532.i, <8 x double> %.651.i, <8 x double> %_multiply_wide_v84_a21.2.1828.i)
  %.664.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.545.i, <8 x double> %.651.i, <8 x double> %_multiply_wide_v84_a22.2.1829.i)
  %.668.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.558.i, <8 x double> %.651.i, <8 x double> %_multiply_wide_v84_a23.2.1830.i)
  %.686.i = load double, ptr %scevgep26, align 8, !noalias !276
  %.688.i = insertelement <8 x double> poison, double %.686.i, i64 0
  %.689.i = shufflevector <8 x double> %.688.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.690.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.520.i, <8 x double> %.689.i, <8 x double> %_multiply_wide_v84_a30.2.1831.i)
  %.694.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.532.i, <8 x double> %.689.i, <8 x double> %_multiply_wide_v84_a31.2.1832.i)
  %.702.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.545.i, <8 x double> %.689.i, <8 x double> %_multiply_wide_v84_a32.2.1833.i)
  %.706.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.558.i, <8 x double> %.689.i, <8 x double> %_multiply_wide_v84_a33.2.1834.i)
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

B356.if.i:                                        ; preds = %B354.endif.endif.endif.i, %B1932.i
  %position.5.0897.i = phi i64 [ %position.3.0.lcssa.i, %B354.endif.endif.endif.i ], [ %position.4.1.lcssa.i, %B1932.i ]
  %.1128888896.i = phi i64 [ %.1106806.i, %B354.endif.endif.endif.i ], [ %.1138.i, %B1932.i ]
  %.1135889895.i = phi i64 [ %.1046.i, %B354.endif.endif.endif.i ], [ %.1142.i, %B1932.i ]
  %.1138.i = add nsw i64 %.1128888896.i, -1
  %.1142.i = add nuw nsw i64 %.1135889895.i, 8
  br i1 %42, label %B1932.i, label %B884.if.preheader.i

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
  %.1318.i = load <8 x double>, ptr %scevgep12.i, align 8, !noalias !276
  %scevgep37 = getelementptr i8, ptr %scevgep31, i64 %lsr.iv.i11
  %scevgep38 = getelementptr i8, ptr %scevgep37, i64 -24
  %.1333.i = load double, ptr %scevgep38, align 8, !noalias !276
  %.1335.i = insertelement <8 x double> poison, double %.1333.i, i64 0
  %.1336.i = shufflevector <8 x double> %.1335.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1337.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1318.i, <8 x double> %.1336.i, <8 x double> %b0.2.1877.i)
  %scevgep15 = getelementptr i8, ptr %scevgep37, i64 -16
  %.1352.i = load double, ptr %scevgep15, align 8, !noalias !276
  %.1354.i = insertelement <8 x double> poison, double %.1352.i, i64 0
  %.1355.i = shufflevector <8 x double> %.1354.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1356.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1318.i, <8 x double> %.1355.i, <8 x double> %b1.2.1878.i)
  %scevgep13 = getelementptr i8, ptr %scevgep37, i64 -8
  %.1372.i = load double, ptr %scevgep13, align 8, !noalias !276
  %.1374.i = insertelement <8 x double> poison, double %.1372.i, i64 0
  %.1375.i = shufflevector <8 x double> %.1374.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1376.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1318.i, <8 x double> %.1375.i, <8 x double> %b2.2.1879.i)
  %.1392.i = load double, ptr %scevgep37, align 8, !noalias !276
  %.1394.i = insertelement <8 x double> poison, double %.1392.i, i64 0
  %.1395.i = shufflevector <8 x double> %.1394.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1396.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1318.i, <8 x double> %.1395.i, <8 x double> %b3.2.1880.i)
  %lsr.iv.next.i12 = add nuw i64 %lsr.iv.i11, 64
  %lsr.iv.next22.i = add i64 %lsr.iv21.i, -1
  %exitcond905.not.i = icmp eq i64 %lsr.iv.next22.i, 0
  br i1 %exitcond905.not.i, label %B1932.loopexit.i, label %B884.if.i

B548.endif.endif.endif:                           ; preds = %B1932.i, %B354.else.i
  %.1269 = icmp sgt i64 %.1268845849, 1
  br i1 %.1269, label %B546.if, label %B696

B740.else.if:                                     ; preds = %B740
  br label %B740.else.endif

B740.else.endif:                                  ; preds = %B740.else.if, %B740
  %.1833.sroa.0.1 = phi i64 [ 0, %B740.else.if ], [ %.1845, %B740 ]
  %.1853.not = icmp slt i64 %.1845, 1073741824
  br i1 %.1853.not, label %B740.else.endif.endif, label %B740.else.endif.if, !prof !39

B740.else.endif.if:                               ; preds = %B740.else.endif
  br label %B740.else.endif.endif

B740.else.endif.endif:                            ; preds = %B740.else.endif.if, %B740.else.endif
  %.1833.sroa.0.3 = phi i64 [ 1073741824, %B740.else.endif.if ], [ %.1833.sroa.0.1, %B740.else.endif ]
  %.1921 = sub nsw i64 1073741824, %.1833.sroa.0.3
  %.1930 = tail call i64 @llvm.smax.i64(i64 %.1921, i64 0)
  %.1946 = getelementptr double, ptr %arg.weights.4, i64 %.1833.sroa.0.3
  %.2029 = icmp slt i64 %.184.sroa.13.2, 9
  br i1 %.2029, label %B740.endif.else.endif.if, label %B740.endif.else.endif.endif, !prof !24

B740.endif.else.endif.if:                         ; preds = %B740.else.endif.endif
  br label %B740.endif.else.endif.endif

B740.endif.else.endif.endif:                      ; preds = %B740.endif.else.endif.if, %B740.else.endif.endif
  %.2009.sroa.0.3 = phi i64 [ %.184.sroa.13.2, %B740.endif.else.endif.if ], [ 8, %B740.else.endif.endif ]
  %.2122 = getelementptr double, ptr %arg.scratch.4, i64 %.2009.sroa.0.3
  store ptr null, ptr %.2159, align 8
  call fastcc void @inner_15(ptr nonnull %.2159, ptr %arg.coordinates.4, i64 %arg.rows, ptr %arg.contents.4, ptr %.1946, i64 %.1930, ptr %.469, i64 %.453, ptr %.2122, i64 %.153)
  br label %B856
}

; Function Attrs: nofree norecurse nosync nounwind memory(argmem: readwrite)
define internal fastcc void @inner_4(ptr noalias nonnull writeonly captures(none) %retptr, ptr readonly captures(none) %arg.outputs.4, i64 %arg.rows, i64 %arg.count, i64 range(i64 16, 9) %arg.per_row, ptr readonly captures(none) %arg.synthesis.4, i64 range(i64 8, 1) %arg.width, ptr writeonly captures(none) %arg.linear.4) unnamed_addr #4 {
entry:
  %0 = add nuw i64 %arg.rows, 3
  %.116 = lshr i64 %0, 2
  %.93.inv = icmp slt i64 %arg.rows, 1
  %.137180.not184 = icmp eq i64 %.116, 0
  %.137180.not = select i1 %.93.inv, i1 true, i1 %.137180.not184
  br i1 %.137180.not, label %B226, label %B48.if.lr.ph

B48.if.lr.ph:                                     ; preds = %entry
  %.313 = add i64 %arg.count, 1
  %1 = tail call i64 @llvm.smax.i64(i64 %arg.width, i64 31)
  %storemerge.i = lshr i64 %1, 5
  %.1046.i = and i64 %arg.width, -32
  %.1086.i = and i64 %arg.width, 31
  %.1087.not.i = icmp eq i64 %.1086.i, 0
  %.idx813.i = shl i64 %arg.per_row, 4
  %.idx814.i = mul i64 %arg.per_row, 24
  %.880.idx.i = shl i64 %arg.width, 4
  %.950.idx.i = mul i64 %arg.width, 24
  %scevgep17.i = getelementptr i8, ptr %arg.synthesis.4, i64 192
  %2 = shl i64 %.313, 8
  %factor.op.mul = shl i64 %.313, 5
  %.reass = mul i64 %factor.op.mul, %storemerge.i
  %.1102.i = and i64 %arg.width, 7
  %.1105.not.i = icmp ne i64 %.1102.i, 0
  %.1106806.i = lshr i64 %.1086.i, 3
  %.1107.i = zext i1 %.1105.not.i to i64
  %.1108.i = add nuw nsw i64 %.1106806.i, %.1107.i
  %.1129898.not.i = icmp eq i64 %.1108.i, 0
  %.arg.count815.i = tail call i64 @llvm.smax.i64(i64 %.313, i64 0)
  %3 = shl i64 %.arg.count815.i, 3
  %brmerge = select i1 %.1087.not.i, i1 true, i1 %.1129898.not.i
  %4 = getelementptr i8, ptr %arg.outputs.4, i64 %.idx814.i
  %scevgep = getelementptr i8, ptr %4, i64 56
  %5 = shl i64 %arg.per_row, 5
  %6 = getelementptr i8, ptr %arg.outputs.4, i64 %.idx813.i
  %scevgep34 = getelementptr i8, ptr %6, i64 56
  %7 = shl i64 %arg.per_row, 3
  %8 = getelementptr i8, ptr %arg.outputs.4, i64 %7
  %scevgep39 = getelementptr i8, ptr %8, i64 56
  %scevgep44 = getelementptr i8, ptr %arg.outputs.4, i64 56
  %9 = icmp eq i64 %storemerge.i, 0
  %10 = icmp slt i64 %arg.count, 0
  %11 = icmp slt i64 %arg.count, 0
  br label %B48.if

B226:                                             ; preds = %B50.endif.endif.endif, %entry
  store ptr null, ptr %retptr, align 8
  ret void

B48.if:                                           ; preds = %B50.endif.endif.endif, %B48.if.lr.ph
  %lsr.iv45 = phi ptr [ %scevgep44, %B48.if.lr.ph ], [ %scevgep46, %B50.endif.endif.endif ]
  %lsr.iv40 = phi ptr [ %scevgep39, %B48.if.lr.ph ], [ %scevgep41, %B50.endif.endif.endif ]
  %lsr.iv35 = phi ptr [ %scevgep34, %B48.if.lr.ph ], [ %scevgep36, %B50.endif.endif.endif ]
  %lsr.iv30 = phi ptr [ %scevgep, %B48.if.lr.ph ], [ %scevgep31, %B50.endif.endif.endif ]
  %.136174182 = phi i64 [ %.116, %B48.if.lr.ph ], [ %.146, %B50.endif.endif.endif ]
  %.143177181 = phi i64 [ 0, %B48.if.lr.ph ], [ %.150, %B50.endif.endif.endif ]
  %.146 = add nsw i64 %.136174182, -1
  %.150 = add nuw i64 %.143177181, 4
  %.243 = mul nsw i64 %.143177181, %arg.width
  %.254 = getelementptr inbounds double, ptr %arg.linear.4, i64 %.243
  br i1 %9, label %B354.else.i, label %B84.if.i

B280.i:                                           ; preds = %B200.if.i, %B84.if.i
  %_multiply_wide_v94_a00.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B84.if.i ], [ %.577.i, %B200.if.i ]
  %_multiply_wide_v94_a01.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B84.if.i ], [ %.581.i, %B200.if.i ]
  %_multiply_wide_v94_a02.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B84.if.i ], [ %.589.i, %B200.if.i ]
  %_multiply_wide_v94_a03.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B84.if.i ], [ %.593.i, %B200.if.i ]
  %_multiply_wide_v94_a10.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B84.if.i ], [ %.614.i, %B200.if.i ]
  %_multiply_wide_v94_a11.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B84.if.i ], [ %.618.i, %B200.if.i ]
  %_multiply_wide_v94_a12.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B84.if.i ], [ %.626.i, %B200.if.i ]
  %_multiply_wide_v94_a13.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B84.if.i ], [ %.630.i, %B200.if.i ]
  %_multiply_wide_v94_a20.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B84.if.i ], [ %.652.i, %B200.if.i ]
  %_multiply_wide_v94_a21.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B84.if.i ], [ %.656.i, %B200.if.i ]
  %_multiply_wide_v94_a22.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B84.if.i ], [ %.664.i, %B200.if.i ]
  %_multiply_wide_v94_a23.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B84.if.i ], [ %.668.i, %B200.if.i ]
  %_multiply_wide_v94_a30.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B84.if.i ], [ %.690.i, %B200.if.i ]
  %_multiply_wide_v94_a31.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B84.if.i ], [ %.694.i, %B200.if.i ]
  %_multiply_wide_v94_a32.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B84.if.i ], [ %.702.i, %B200.if.i ]
  %_multiply_wide_v94_a33.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B84.if.i ], [ %.706.i, %B200.if.i ]
  store <8 x double> %_multiply_wide_v94_a00.2.1.lcssa.i, ptr %.237.i, align 8, !noalias !279
  %.765.i = getelementptr inbounds nuw i8, ptr %.237.i, i64 64
  store <8 x double> %_multiply_wide_v94_a01.2.1.lcssa.i, ptr %.765.i, align 8, !noalias !279
  %.776.i = getelementptr inbounds nuw i8, ptr %.237.i, i64 128
  store <8 x double> %_multiply_wide_v94_a02.2.1.lcssa.i, ptr %.776.i, align 8, !noalias !279
  %.787.i = getelementptr inbounds nuw i8, ptr %.237.i, i64 192
  store <8 x double> %_multiply_wide_v94_a03.2.1.lcssa.i, ptr %.787.i, align 8, !noalias !279
  %.817.i = getelementptr inbounds double, ptr %.237.i, i64 %arg.width
  store <8 x double> %_multiply_wide_v94_a10.2.1.lcssa.i, ptr %.817.i, align 8, !noalias !279
  %.827.i = getelementptr i8, ptr %.817.i, i64 64
  store <8 x double> %_multiply_wide_v94_a11.2.1.lcssa.i, ptr %.827.i, align 8, !noalias !279
  %.838.i = getelementptr i8, ptr %.817.i, i64 128
  store <8 x double> %_multiply_wide_v94_a12.2.1.lcssa.i, ptr %.838.i, align 8, !noalias !279
  %.849.i = getelementptr i8, ptr %.817.i, i64 192
  store <8 x double> %_multiply_wide_v94_a13.2.1.lcssa.i, ptr %.849.i, align 8, !noalias !279
  %.880.i = getelementptr inbounds i8, ptr %.237.i, i64 %.880.idx.i
  store <8 x double> %_multiply_wide_v94_a20.2.1.lcssa.i, ptr %.880.i, align 8, !noalias !279
  %.890.i = getelementptr i8, ptr %.880.i, i64 64
  store <8 x double> %_multiply_wide_v94_a21.2.1.lcssa.i, ptr %.890.i, align 8, !noalias !279
  %.901.i = getelementptr i8, ptr %.880.i, i64 128
  store <8 x double> %_multiply_wide_v94_a22.2.1.lcssa.i, ptr %.901.i, align 8, !noalias !279
  %.912.i = getelementptr i8, ptr %.880.i, i64 192
  store <8 x double> %_multiply_wide_v94_a23.2.1.lcssa.i, ptr %.912.i, align 8, !noalias !279
  %.950.i = getelementptr inbounds i8, ptr %.237.i, i64 %.950.idx.i
  store <8 x double> %_multiply_wide_v94_a30.2.1.lcssa.i, ptr %.950.i, align 8, !noalias !279
  %.960.i = getelementptr i8, ptr %.950.i, i64 64
  store <8 x double> %_multiply_wide_v94_a31.2.1.lcssa.i, ptr %.960.i, align 8, !noalias !279
  %.971.i = getelementptr i8, ptr %.950.i, i64 128
  store <8 x double> %_multiply_wide_v94_a32.2.1.lcssa.i, ptr %.971.i, align 8, !noalias !279
  %.982.i = getelementptr i8, ptr %.950.i, i64 192
  store <8 x double> %_multiply_wide_v94_a33.2.1.lcssa.i, ptr %.982.i, align 8, !noalias !279
  %scevgep19.i = getelementptr i8, ptr %lsr.iv18.i, i64 %2
  %.187.i = icmp sgt i64 %.186856868.i, 1
  br i1 %.187.i, label %B84.if.i, label %B354.else.i

B3102.loopexit.i:                                 ; preds = %B884.if.i
  %12 = add i64 %position.5.0901.i, %3
  br label %B3102.i

B3102.i:                                          ; preds = %B356.if.i, %B3102.loopexit.i
  %position.4.1.lcssa.i = phi i64 [ %position.5.0901.i, %B356.if.i ], [ %12, %B3102.loopexit.i ]
  %b0.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B356.if.i ], [ %.1337.i, %B3102.loopexit.i ]
  %b1.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B356.if.i ], [ %.1356.i, %B3102.loopexit.i ]
  %b2.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B356.if.i ], [ %.1376.i, %B3102.loopexit.i ]
  %b3.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B356.if.i ], [ %.1396.i, %B3102.loopexit.i ]
  %.1418.i = getelementptr inbounds double, ptr %.254, i64 %.1135893899.i
  store <8 x double> %b0.2.1.lcssa.i, ptr %.1418.i, align 8, !noalias !279
  %.1434.i = getelementptr double, ptr %14, i64 %.1135893899.i
  store <8 x double> %b1.2.1.lcssa.i, ptr %.1434.i, align 8, !noalias !279
  %.1451.i = getelementptr double, ptr %15, i64 %.1135893899.i
  store <8 x double> %b2.2.1.lcssa.i, ptr %.1451.i, align 8, !noalias !279
  %.1470.i = getelementptr double, ptr %16, i64 %.1135893899.i
  store <8 x double> %b3.2.1.lcssa.i, ptr %.1470.i, align 8, !noalias !279
  %.1129.i = icmp sgt i64 %.1128892900.i, 1
  br i1 %.1129.i, label %B356.if.i, label %B50.endif.endif.endif

B84.if.i:                                         ; preds = %B48.if, %B280.i
  %lsr.iv18.i = phi ptr [ %scevgep19.i, %B280.i ], [ %scevgep17.i, %B48.if ]
  %.186856868.i = phi i64 [ %.196.i, %B280.i ], [ %storemerge.i, %B48.if ]
  %.193857867.i = phi i64 [ %.200.i, %B280.i ], [ 0, %B48.if ]
  %.196.i = add nsw i64 %.186856868.i, -1
  %.200.i = add nuw nsw i64 %.193857867.i, 32
  %.237.i = getelementptr inbounds nuw double, ptr %.254, i64 %.193857867.i
  br i1 %10, label %B280.i, label %B200.if.i

B200.if.i:                                        ; preds = %B84.if.i, %B200.if.i
  %lsr.iv = phi i64 [ %lsr.iv.next, %B200.if.i ], [ -1, %B84.if.i ]
  %lsr.iv20.i = phi ptr [ %scevgep21.i, %B200.if.i ], [ %lsr.iv18.i, %B84.if.i ]
  %_multiply_wide_v94_a33.2.1838.i = phi <8 x double> [ %.706.i, %B200.if.i ], [ zeroinitializer, %B84.if.i ]
  %_multiply_wide_v94_a32.2.1837.i = phi <8 x double> [ %.702.i, %B200.if.i ], [ zeroinitializer, %B84.if.i ]
  %_multiply_wide_v94_a31.2.1836.i = phi <8 x double> [ %.694.i, %B200.if.i ], [ zeroinitializer, %B84.if.i ]
  %_multiply_wide_v94_a30.2.1835.i = phi <8 x double> [ %.690.i, %B200.if.i ], [ zeroinitializer, %B84.if.i ]
  %_multiply_wide_v94_a23.2.1834.i = phi <8 x double> [ %.668.i, %B200.if.i ], [ zeroinitializer, %B84.if.i ]
  %_multiply_wide_v94_a22.2.1833.i = phi <8 x double> [ %.664.i, %B200.if.i ], [ zeroinitializer, %B84.if.i ]
  %_multiply_wide_v94_a21.2.1832.i = phi <8 x double> [ %.656.i, %B200.if.i ], [ zeroinitializer, %B84.if.i ]
  %_multiply_wide_v94_a20.2.1831.i = phi <8 x double> [ %.652.i, %B200.if.i ], [ zeroinitializer, %B84.if.i ]
  %_multiply_wide_v94_a13.2.1830.i = phi <8 x double> [ %.630.i, %B200.if.i ], [ zeroinitializer, %B84.if.i ]
  %_multiply_wide_v94_a12.2.1829.i = phi <8 x double> [ %.626.i, %B200.if.i ], [ zeroinitializer, %B84.if.i ]
  %_multiply_wide_v94_a11.2.1828.i = phi <8 x double> [ %.618.i, %B200.if.i ], [ zeroinitializer, %B84.if.i ]
  %_multiply_wide_v94_a10.2.1827.i = phi <8 x double> [ %.614.i, %B200.if.i ], [ zeroinitializer, %B84.if.i ]
  %_multiply_wide_v94_a03.2.1826.i = phi <8 x double> [ %.593.i, %B200.if.i ], [ zeroinitializer, %B84.if.i ]
  %_multiply_wide_v94_a02.2.1825.i = phi <8 x double> [ %.589.i, %B200.if.i ], [ zeroinitializer, %B84.if.i ]
  %_multiply_wide_v94_a01.2.1824.i = phi <8 x double> [ %.581.i, %B200.if.i ], [ zeroinitializer, %B84.if.i ]
  %_multiply_wide_v94_a00.2.1823.i = phi <8 x double> [ %.577.i, %B200.if.i ], [ zeroinitializer, %B84.if.i ]
  %scevgep24.i = getelementptr i8, ptr %lsr.iv20.i, i64 -192
  %.520.i = load <8 x double>, ptr %scevgep24.i, align 8, !noalias !279
  %scevgep23.i = getelementptr i8, ptr %lsr.iv20.i, i64 -128
  %.532.i = load <8 x double>, ptr %scevgep23.i, align 8, !noalias !279
  %scevgep22.i = getelementptr i8, ptr %lsr.iv20.i, i64 -64
  %.545.i = load <8 x double>, ptr %scevgep22.i, align 8, !noalias !279
  %.558.i = load <8 x double>, ptr %lsr.iv20.i, align 8, !noalias !279
  %13 = shl i64 %lsr.iv, 3
  %scevgep47 = getelementptr i8, ptr %lsr.iv45, i64 %13
  %scevgep48 = getelementptr i8, ptr %scevgep47, i64 8
  %.573.i = load double, ptr %scevgep48, align 8, !noalias !279
  %.575.i = insertelement <8 x double> poison, double %.573.i, i64 0
  %.576.i = shufflevector <8 x double> %.575.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.577.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.520.i, <8 x double> %.576.i, <8 x double> %_multiply_wide_v94_a00.2.1823.i)
  %.581.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.532.i, <8 x double> %.576.i, <8 x double> %_multiply_wide_v94_a01.2.1824.i)
  %.589.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.545.i, <8 x double> %.576.i, <8 x double> %_multiply_wide_v94_a02.2.1825.i)
  %.593.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.558.i, <8 x double> %.576.i, <8 x double> %_multiply_wide_v94_a03.2.1826.i)
  %scevgep20 = getelementptr i8, ptr %lsr.iv40, i64 %13
  %scevgep21 = getelementptr i8, ptr %scevgep20, i64 8
  %.610.i = load double, ptr %scevgep21, align 8, !noalias !279
  %.612.i = insertelement <8 x double> poison, double %.610.i, i64 0
  %.613.i = shufflevector <8 x double> %.612.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.614.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.520.i, <8 x double> %.613.i, <8 x double> %_multiply_wide_v94_a10.2.1827.i)
  %.618.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.532.i, <8 x double> %.613.i, <8 x double> %_multiply_wide_v94_a11.2.1828.i)
  %.626.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.545.i, <8 x double> %.613.i, <8 x double> %_multiply_wide_v94_a12.2.1829.i)
  %.630.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.558.i, <8 x double> %.613.i, <8 x double> %_multiply_wide_v94_a13.2.1830.i)
  %scevgep17 = getelementptr i8, ptr %lsr.iv35, i64 %13
  %scevgep19 = getelementptr i8, ptr %scevgep17, i64 8
  %.648.i = load double, ptr %scevgep19, align 8, !noalias !279
  %.650.i = insertelement <8 x double> poison, double %.648.i, i64 0
  %.651.i = shufflevector <8 x double> %.650.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.652.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.520.i, <8 x double> %.651.i, <8 x double> %_multiply_wide_v94_a20.2.1831.i)
  %.656.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.532.i, <8 x double> %.651.i, <8 x double> %_multiply_wide_v94_a21.2.1832.i)
  %.664.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.545.i, <8 x double> %.651.i, <8 x double> %_multiply_wide_v94_a22.2.1833.i)
  %.668.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.558.i, <8 x double> %.651.i, <8 x double> %_multiply_wide_v94_a23.2.1834.i)
  %scevgep7 = getelementptr i8, ptr %lsr.iv30, i64 %13
  %scevgep8 = getelementptr i8, ptr %scevgep7, i64 8
  %.686.i = load double, ptr %scevgep8, align 8, !noalias !279
  %.688.i = insertelement <8 x double> poison, double %.686.i, i64 0
  %.689.i = shufflevector <8 x double> %.688.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.690.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.520.i, <8 x double> %.689.i, <8 x double> %_multiply_wide_v94_a30.2.1835.i)
  %.694.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.532.i, <8 x double> %.689.i, <8 x double> %_multiply_wide_v94_a31.2.1836.i)
  %.702.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.545.i, <8 x double> %.689.i, <8 x double> %_multiply_wide_v94_a32.2.1837.i)
  %.706.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.558.i, <8 x double> %.689.i, <8 x double> %_multiply_wide_v94_a33.2.1838.i)
  %scevgep21.i = getelementptr i8, ptr %lsr.iv20.i, i64 256
  %lsr.iv.next = add nsw i64 %lsr.iv, 1
  %exitcond.not.i = icmp eq i64 %arg.count, %lsr.iv.next
  br i1 %exitcond.not.i, label %B280.i, label %B200.if.i

B354.else.i:                                      ; preds = %B280.i, %B48.if
  %position.3.0.lcssa.i = phi i64 [ 0, %B48.if ], [ %.reass, %B280.i ]
  br i1 %brmerge, label %B50.endif.endif.endif, label %B356.if.lr.ph.i

B356.if.lr.ph.i:                                  ; preds = %B354.else.i
  %14 = getelementptr double, ptr %.254, i64 %arg.width
  %15 = getelementptr i8, ptr %.254, i64 %.880.idx.i
  %16 = getelementptr i8, ptr %.254, i64 %.950.idx.i
  br label %B356.if.i

B356.if.i:                                        ; preds = %B356.if.lr.ph.i, %B3102.i
  %position.5.0901.i = phi i64 [ %position.3.0.lcssa.i, %B356.if.lr.ph.i ], [ %position.4.1.lcssa.i, %B3102.i ]
  %.1128892900.i = phi i64 [ %.1108.i, %B356.if.lr.ph.i ], [ %.1138.i, %B3102.i ]
  %.1135893899.i = phi i64 [ %.1046.i, %B356.if.lr.ph.i ], [ %.1142.i, %B3102.i ]
  %.1138.i = add nsw i64 %.1128892900.i, -1
  %.1142.i = add i64 %.1135893899.i, 8
  br i1 %11, label %B3102.i, label %B884.if.preheader.i

B884.if.preheader.i:                              ; preds = %B356.if.i
  %17 = shl i64 %position.5.0901.i, 3
  %scevgep.i = getelementptr i8, ptr %arg.synthesis.4, i64 %17
  br label %B884.if.i

B884.if.i:                                        ; preds = %B884.if.i, %B884.if.preheader.i
  %lsr.iv25 = phi i64 [ %lsr.iv.next26, %B884.if.i ], [ %.313, %B884.if.preheader.i ]
  %lsr.iv22 = phi i64 [ %lsr.iv.next23, %B884.if.i ], [ 0, %B884.if.preheader.i ]
  %b3.2.1884.i = phi <8 x double> [ %.1396.i, %B884.if.i ], [ zeroinitializer, %B884.if.preheader.i ]
  %b2.2.1883.i = phi <8 x double> [ %.1376.i, %B884.if.i ], [ zeroinitializer, %B884.if.preheader.i ]
  %b1.2.1882.i = phi <8 x double> [ %.1356.i, %B884.if.i ], [ zeroinitializer, %B884.if.preheader.i ]
  %b0.2.1881.i = phi <8 x double> [ %.1337.i, %B884.if.i ], [ zeroinitializer, %B884.if.preheader.i ]
  %18 = shl i64 %lsr.iv22, 3
  %scevgep24 = getelementptr i8, ptr %scevgep.i, i64 %18
  %.1318.i = load <8 x double>, ptr %scevgep24, align 8, !noalias !279
  %scevgep30 = getelementptr i8, ptr %lsr.iv45, i64 %lsr.iv22
  %.1333.i = load double, ptr %scevgep30, align 8, !noalias !279
  %.1335.i = insertelement <8 x double> poison, double %.1333.i, i64 0
  %.1336.i = shufflevector <8 x double> %.1335.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1337.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1318.i, <8 x double> %.1336.i, <8 x double> %b0.2.1881.i)
  %scevgep29 = getelementptr i8, ptr %lsr.iv40, i64 %lsr.iv22
  %.1352.i = load double, ptr %scevgep29, align 8, !noalias !279
  %.1354.i = insertelement <8 x double> poison, double %.1352.i, i64 0
  %.1355.i = shufflevector <8 x double> %.1354.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1356.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1318.i, <8 x double> %.1355.i, <8 x double> %b1.2.1882.i)
  %scevgep28 = getelementptr i8, ptr %lsr.iv35, i64 %lsr.iv22
  %.1372.i = load double, ptr %scevgep28, align 8, !noalias !279
  %.1374.i = insertelement <8 x double> poison, double %.1372.i, i64 0
  %.1375.i = shufflevector <8 x double> %.1374.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1376.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1318.i, <8 x double> %.1375.i, <8 x double> %b2.2.1883.i)
  %scevgep27 = getelementptr i8, ptr %lsr.iv30, i64 %lsr.iv22
  %.1392.i = load double, ptr %scevgep27, align 8, !noalias !279
  %.1394.i = insertelement <8 x double> poison, double %.1392.i, i64 0
  %.1395.i = shufflevector <8 x double> %.1394.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1396.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1318.i, <8 x double> %.1395.i, <8 x double> %b3.2.1884.i)
  %lsr.iv.next23 = add i64 %lsr.iv22, 8
  %lsr.iv.next26 = add i64 %lsr.iv25, -1
  %exitcond909.not.i = icmp eq i64 %lsr.iv.next26, 0
  br i1 %exitcond909.not.i, label %B3102.loopexit.i, label %B884.if.i

B50.endif.endif.endif:                            ; preds = %B3102.i, %B354.else.i
  %scevgep31 = getelementptr i8, ptr %lsr.iv30, i64 %5
  %scevgep36 = getelementptr i8, ptr %lsr.iv35, i64 %5
  %scevgep41 = getelementptr i8, ptr %lsr.iv40, i64 %5
  %scevgep46 = getelementptr i8, ptr %lsr.iv45, i64 %5
  %.137 = icmp sgt i64 %.136174182, 1
  br i1 %.137, label %B48.if, label %B226
}

; Function Attrs: nofree noinline norecurse nosync nounwind memory(argmem: readwrite)
define internal fastcc void @inner_15(ptr noalias nonnull writeonly captures(none) %retptr, ptr readonly captures(none) %arg.coordinates.4, i64 %arg.rows, ptr readonly captures(none) %arg.contents.4, ptr readonly captures(none) %arg.layers.4, i64 range(i64 0, 1073741825) %arg.layers.5.0, ptr %arg.scratch.4, i64 range(i64 0, 1073741825) %arg.scratch.5.0, ptr captures(none) %arg.out.4, i64 range(i64 16, 9) %arg.out_row) unnamed_addr #3 {
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
  br i1 %.215, label %B0.endif.else.endif.endif.if, label %B0.endif.else.endif.endif.endif, !prof !24

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
  %sunkaddr59 = getelementptr i8, ptr %arg.contents.4, i64 48
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
  %3 = add nsw i64 %reass.sub, 6
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
  %10 = add nuw nsw i64 %storemerge760, 6
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
  br i1 %.220.not, label %B0.endif.else.endif.endif.endif.endif, label %B0.endif.else.endif.endif.endif.if, !prof !39

B0.endif.else.endif.endif.endif.if:               ; preds = %B0.endif.else.endif.endif.endif
  br label %B0.endif.else.endif.endif.endif.endif

B0.endif.else.endif.endif.endif.endif:            ; preds = %B0.endif.else.endif.endif.endif.if, %B0.endif.else.endif.endif.endif
  %.183.sroa.13.2 = phi i64 [ %arg.scratch.5.0, %B0.endif.else.endif.endif.endif.if ], [ %.183.sroa.13.1, %B0.endif.else.endif.endif.endif ]
  %.332 = shl i64 %.152, 4
  br i1 %.215, label %B0.endif.endif.else.if, label %B0.endif.endif.else.endif, !prof !24

B0.endif.endif.else.if:                           ; preds = %B0.endif.else.endif.endif.endif.endif
  br label %B0.endif.endif.else.endif

B0.endif.endif.else.endif:                        ; preds = %B0.endif.endif.else.if, %B0.endif.else.endif.endif.endif.endif
  %.358.sroa.0.1 = phi i64 [ 0, %B0.endif.endif.else.if ], [ %.212, %B0.endif.else.endif.endif.endif.endif ]
  br i1 %.220.not, label %B0.endif.endif.else.endif.endif, label %B0.endif.endif.else.endif.if, !prof !39

B0.endif.endif.else.endif.if:                     ; preds = %B0.endif.endif.else.endif
  br label %B0.endif.endif.else.endif.endif

B0.endif.endif.else.endif.endif:                  ; preds = %B0.endif.endif.else.endif.if, %B0.endif.endif.else.endif
  %.358.sroa.0.3 = phi i64 [ %arg.scratch.5.0, %B0.endif.endif.else.endif.if ], [ %.358.sroa.0.1, %B0.endif.endif.else.endif ]
  %.387 = add i64 %.211, %.332
  %.390 = icmp slt i64 %.387, 0
  br i1 %.390, label %B0.endif.endif.else.endif.endif.if, label %B0.endif.endif.else.endif.endif.endif, !prof !24

B0.endif.endif.else.endif.endif.if:               ; preds = %B0.endif.endif.else.endif.endif
  br label %B0.endif.endif.else.endif.endif.endif

B0.endif.endif.else.endif.endif.endif:            ; preds = %B0.endif.endif.else.endif.endif.if, %B0.endif.endif.else.endif.endif
  %.358.sroa.13.1 = phi i64 [ 0, %B0.endif.endif.else.endif.endif.if ], [ %.387, %B0.endif.endif.else.endif.endif ]
  %.395.not = icmp slt i64 %.387, %arg.scratch.5.0
  br i1 %.395.not, label %B0.endif.endif.else.endif.endif.endif.endif, label %B0.endif.endif.else.endif.endif.endif.if, !prof !39

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
  %scevgep30 = getelementptr i8, ptr %lsr.iv, i64 %21
  store double 1.000000e+00, ptr %scevgep30, align 8
  %22 = select i1 %.664, i64 %14, i64 0
  %23 = getelementptr i8, ptr %lsr.iv, i64 %12
  %24 = getelementptr i8, ptr %23, i64 56
  %scevgep22 = getelementptr i8, ptr %24, i64 %22
  store double 1.000000e+00, ptr %scevgep22, align 8
  %sunkaddr = getelementptr i8, ptr %arg.coordinates.4, i64 %lsr.iv54
  %sunkaddr50 = getelementptr i8, ptr %sunkaddr, i64 64
  %.865 = load double, ptr %sunkaddr50, align 8
  %.884 = icmp slt i64 %lsr.iv63, -8
  %25 = select i1 %.884, i64 %16, i64 64
  %scevgep29 = getelementptr i8, ptr %lsr.iv, i64 %25
  store double %.865, ptr %scevgep29, align 8
  %sunkaddr52 = getelementptr i8, ptr %sunkaddr, i64 128
  %.865.1 = load double, ptr %sunkaddr52, align 8
  %.884.1 = icmp slt i64 %lsr.iv63, -9
  %26 = select i1 %.884.1, i64 %17, i64 72
  %scevgep28 = getelementptr i8, ptr %lsr.iv, i64 %26
  store double %.865.1, ptr %scevgep28, align 8
  %sunkaddr54 = getelementptr i8, ptr %sunkaddr, i64 192
  %.865.2 = load double, ptr %sunkaddr54, align 8
  %.884.2 = icmp slt i64 %lsr.iv63, -10
  %27 = select i1 %.884.2, i64 %18, i64 80
  %scevgep27 = getelementptr i8, ptr %lsr.iv, i64 %27
  store double %.865.2, ptr %scevgep27, align 8
  %sunkaddr56 = getelementptr i8, ptr %sunkaddr, i64 256
  %.865.3 = load double, ptr %sunkaddr56, align 8
  %.884.3 = icmp slt i64 %lsr.iv63, -11
  %28 = select i1 %.884.3, i64 %19, i64 88
  %scevgep26 = getelementptr i8, ptr %lsr.iv, i64 %28
  store double %.865.3, ptr %scevgep26, align 8
  %sunkaddr58 = getelementptr i8, ptr %sunkaddr, i64 320
  %.865.4 = load double, ptr %sunkaddr58, align 8
  %.884.4 = icmp slt i64 %lsr.iv63, -12
  %29 = select i1 %.884.4, i64 %20, i64 96
  %scevgep25 = getelementptr i8, ptr %lsr.iv, i64 %29
  store double %.865.4, ptr %scevgep25, align 8
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
  br i1 %.1391, label %B662.else.if, label %B662.else.endif, !prof !24

B662.else.if:                                     ; preds = %B660.if
  br label %B662.else.endif

B662.else.endif:                                  ; preds = %B662.else.if, %B660.if
  %.1376.sroa.0.1 = phi i64 [ 0, %B662.else.if ], [ %.1388, %B660.if ]
  %.1396.not = icmp slt i64 %.1388, %current.2.sroa.50.0816
  br i1 %.1396.not, label %B662.else.endif.endif, label %B662.else.endif.if, !prof !39

B662.else.endif.if:                               ; preds = %B662.else.endif
  br label %B662.else.endif.endif

B662.else.endif.endif:                            ; preds = %B662.else.endif.if, %B662.else.endif
  %.1376.sroa.0.3 = phi i64 [ %current.2.sroa.50.0816, %B662.else.endif.if ], [ %.1376.sroa.0.1, %B662.else.endif ]
  %.1489 = getelementptr double, ptr %current.2.sroa.40.0817, i64 %.1376.sroa.0.3
  %.1560 = icmp slt i64 %.1347, -8
  %.1561 = select i1 %.1560, i64 %following.2.sroa.55.0814, i64 0
  %.1562 = add i64 %.1561, %.1348
  %.1565 = icmp slt i64 %.1562, 0
  br i1 %.1565, label %B662.endif.else.if, label %B662.endif.else.endif, !prof !24

B662.endif.else.if:                               ; preds = %B662.else.endif.endif
  br label %B662.endif.else.endif

B662.endif.else.endif:                            ; preds = %B662.endif.else.if, %B662.else.endif.endif
  %.1550.sroa.0.1 = phi i64 [ 0, %B662.endif.else.if ], [ %.1562, %B662.else.endif.endif ]
  %.1570.not = icmp slt i64 %.1562, %following.2.sroa.55.0814
  br i1 %.1570.not, label %B662.endif.else.endif.endif, label %B662.endif.else.endif.if, !prof !39

B662.endif.else.endif.if:                         ; preds = %B662.endif.else.endif
  br label %B662.endif.else.endif.endif

B662.endif.else.endif.endif:                      ; preds = %B662.endif.else.endif.if, %B662.endif.else.endif
  %.1550.sroa.0.3 = phi i64 [ %following.2.sroa.55.0814, %B662.endif.else.endif.if ], [ %.1550.sroa.0.1, %B662.endif.else.endif ]
  %.1663 = getelementptr double, ptr %following.2.sroa.44.0815, i64 %.1550.sroa.0.3
  br i1 %37, label %B662.endif.endif.else.if, label %B662.endif.endif.else.endif, !prof !24

B662.endif.endif.else.if:                         ; preds = %B662.endif.else.endif.endif
  br label %B662.endif.endif.else.endif

B662.endif.endif.else.endif:                      ; preds = %B662.endif.endif.else.if, %B662.endif.else.endif.endif
  %.1729.sroa.0.1 = phi i64 [ 0, %B662.endif.endif.else.if ], [ %.1741, %B662.endif.else.endif.endif ]
  br i1 %38, label %B662.endif.endif.else.endif.endif, label %B662.endif.endif.else.endif.if, !prof !39

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
  %_multiply_wide_v94_a00.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B84.if.i ], [ %.577.i, %B200.if.i ]
  %_multiply_wide_v94_a01.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B84.if.i ], [ %.581.i, %B200.if.i ]
  %_multiply_wide_v94_a02.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B84.if.i ], [ %.589.i, %B200.if.i ]
  %_multiply_wide_v94_a03.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B84.if.i ], [ %.593.i, %B200.if.i ]
  %_multiply_wide_v94_a10.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B84.if.i ], [ %.614.i, %B200.if.i ]
  %_multiply_wide_v94_a11.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B84.if.i ], [ %.618.i, %B200.if.i ]
  %_multiply_wide_v94_a12.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B84.if.i ], [ %.626.i, %B200.if.i ]
  %_multiply_wide_v94_a13.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B84.if.i ], [ %.630.i, %B200.if.i ]
  %_multiply_wide_v94_a20.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B84.if.i ], [ %.652.i, %B200.if.i ]
  %_multiply_wide_v94_a21.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B84.if.i ], [ %.656.i, %B200.if.i ]
  %_multiply_wide_v94_a22.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B84.if.i ], [ %.664.i, %B200.if.i ]
  %_multiply_wide_v94_a23.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B84.if.i ], [ %.668.i, %B200.if.i ]
  %_multiply_wide_v94_a30.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B84.if.i ], [ %.690.i, %B200.if.i ]
  %_multiply_wide_v94_a31.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B84.if.i ], [ %.694.i, %B200.if.i ]
  %_multiply_wide_v94_a32.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B84.if.i ], [ %.702.i, %B200.if.i ]
  %_multiply_wide_v94_a33.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B84.if.i ], [ %.706.i, %B200.if.i ]
  store <8 x double> %_multiply_wide_v94_a00.2.1.lcssa.i, ptr %.237.i, align 8, !noalias !282
  %.765.i = getelementptr inbounds nuw i8, ptr %.237.i, i64 64
  store <8 x double> %_multiply_wide_v94_a01.2.1.lcssa.i, ptr %.765.i, align 8, !noalias !282
  %.776.i = getelementptr inbounds nuw i8, ptr %.237.i, i64 128
  store <8 x double> %_multiply_wide_v94_a02.2.1.lcssa.i, ptr %.776.i, align 8, !noalias !282
  %.787.i = getelementptr inbounds nuw i8, ptr %.237.i, i64 192
  store <8 x double> %_multiply_wide_v94_a03.2.1.lcssa.i, ptr %.787.i, align 8, !noalias !282
  %.817.i = getelementptr inbounds double, ptr %.237.i, i64 %.152
  store <8 x double> %_multiply_wide_v94_a10.2.1.lcssa.i, ptr %.817.i, align 8, !noalias !282
  %.827.i = getelementptr i8, ptr %.817.i, i64 64
  store <8 x double> %_multiply_wide_v94_a11.2.1.lcssa.i, ptr %.827.i, align 8, !noalias !282
  %.838.i = getelementptr i8, ptr %.817.i, i64 128
  store <8 x double> %_multiply_wide_v94_a12.2.1.lcssa.i, ptr %.838.i, align 8, !noalias !282
  %.849.i = getelementptr i8, ptr %.817.i, i64 192
  store <8 x double> %_multiply_wide_v94_a13.2.1.lcssa.i, ptr %.849.i, align 8, !noalias !282
  %.880.i = getelementptr inbounds i8, ptr %.237.i, i64 %.332
  store <8 x double> %_multiply_wide_v94_a20.2.1.lcssa.i, ptr %.880.i, align 8, !noalias !282
  %.890.i = getelementptr i8, ptr %.880.i, i64 64
  store <8 x double> %_multiply_wide_v94_a21.2.1.lcssa.i, ptr %.890.i, align 8, !noalias !282
  %.901.i = getelementptr i8, ptr %.880.i, i64 128
  store <8 x double> %_multiply_wide_v94_a22.2.1.lcssa.i, ptr %.901.i, align 8, !noalias !282
  %.912.i = getelementptr i8, ptr %.880.i, i64 192
  store <8 x double> %_multiply_wide_v94_a23.2.1.lcssa.i, ptr %.912.i, align 8, !noalias !282
  %.950.i = getelementptr inbounds i8, ptr %.237.i, i64 %.idx814.i
  store <8 x double> %_multiply_wide_v94_a30.2.1.lcssa.i, ptr %.950.i, align 8, !noalias !282
  %.960.i = getelementptr i8, ptr %.950.i, i64 64
  store <8 x double> %_multiply_wide_v94_a31.2.1.lcssa.i, ptr %.960.i, align 8, !noalias !282
  %.971.i = getelementptr i8, ptr %.950.i, i64 128
  store <8 x double> %_multiply_wide_v94_a32.2.1.lcssa.i, ptr %.971.i, align 8, !noalias !282
  %.982.i = getelementptr i8, ptr %.950.i, i64 192
  store <8 x double> %_multiply_wide_v94_a33.2.1.lcssa.i, ptr %.982.i, align 8, !noalias !282
  %scevgep19.i = getelementptr i8, ptr %lsr.iv18.i, i64 %35
  %.187.i = icmp sgt i64 %.186856868.i, 1
  br i1 %.187.i, label %B84.if.i, label %B354.else.i

B3102.loopexit.i:                                 ; preds = %B884.if.i
  %46 = add i64 %position.5.0901.i, %36
  br label %B3102.i

B3102.i:                                          ; preds = %B356.if.i, %B3102.loopexit.i
  %position.4.1.lcssa.i = phi i64 [ %position.5.0901.i, %B356.if.i ], [ %46, %B3102.loopexit.i ]
  %b0.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B356.if.i ], [ %.1337.i, %B3102.loopexit.i ]
  %b1.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B356.if.i ], [ %.1356.i, %B3102.loopexit.i ]
  %b2.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B356.if.i ], [ %.1376.i, %B3102.loopexit.i ]
  %b3.2.1.lcssa.i = phi <8 x double> [ zeroinitializer, %B356.if.i ], [ %.1396.i, %B3102.loopexit.i ]
  %.1418.i = getelementptr inbounds double, ptr %.1663, i64 %.1135893899.i
  store <8 x double> %b0.2.1.lcssa.i, ptr %.1418.i, align 8, !noalias !282
  %.1434.i = getelementptr double, ptr %51, i64 %.1135893899.i
  store <8 x double> %b1.2.1.lcssa.i, ptr %.1434.i, align 8, !noalias !282
  %.1451.i = getelementptr double, ptr %52, i64 %.1135893899.i
  store <8 x double> %b2.2.1.lcssa.i, ptr %.1451.i, align 8, !noalias !282
  %.1470.i = getelementptr double, ptr %53, i64 %.1135893899.i
  store <8 x double> %b3.2.1.lcssa.i, ptr %.1470.i, align 8, !noalias !282
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
  %_multiply_wide_v94_a33.2.1838.i = phi <8 x double> [ %.706.i, %B200.if.i ], [ zeroinitializer, %B84.if.i ]
  %_multiply_wide_v94_a32.2.1837.i = phi <8 x double> [ %.702.i, %B200.if.i ], [ zeroinitializer, %B84.if.i ]
  %_multiply_wide_v94_a31.2.1836.i = phi <8 x double> [ %.694.i, %B200.if.i ], [ zeroinitializer, %B84.if.i ]
  %_multiply_wide_v94_a30.2.1835.i = phi <8 x double> [ %.690.i, %B200.if.i ], [ zeroinitializer, %B84.if.i ]
  %_multiply_wide_v94_a23.2.1834.i = phi <8 x double> [ %.668.i, %B200.if.i ], [ zeroinitializer, %B84.if.i ]
  %_multiply_wide_v94_a22.2.1833.i = phi <8 x double> [ %.664.i, %B200.if.i ], [ zeroinitializer, %B84.if.i ]
  %_multiply_wide_v94_a21.2.1832.i = phi <8 x double> [ %.656.i, %B200.if.i ], [ zeroinitializer, %B84.if.i ]
  %_multiply_wide_v94_a20.2.1831.i = phi <8 x double> [ %.652.i, %B200.if.i ], [ zeroinitializer, %B84.if.i ]
  %_multiply_wide_v94_a13.2.1830.i = phi <8 x double> [ %.630.i, %B200.if.i ], [ zeroinitializer, %B84.if.i ]
  %_multiply_wide_v94_a12.2.1829.i = phi <8 x double> [ %.626.i, %B200.if.i ], [ zeroinitializer, %B84.if.i ]
  %_multiply_wide_v94_a11.2.1828.i = phi <8 x double> [ %.618.i, %B200.if.i ], [ zeroinitializer, %B84.if.i ]
  %_multiply_wide_v94_a10.2.1827.i = phi <8 x double> [ %.614.i, %B200.if.i ], [ zeroinitializer, %B84.if.i ]
  %_multiply_wide_v94_a03.2.1826.i = phi <8 x double> [ %.593.i, %B200.if.i ], [ zeroinitializer, %B84.if.i ]
  %_multiply_wide_v94_a02.2.1825.i = phi <8 x double> [ %.589.i, %B200.if.i ], [ zeroinitializer, %B84.if.i ]
  %_multiply_wide_v94_a01.2.1824.i = phi <8 x double> [ %.581.i, %B200.if.i ], [ zeroinitializer, %B84.if.i ]
  %_multiply_wide_v94_a00.2.1823.i = phi <8 x double> [ %.577.i, %B200.if.i ], [ zeroinitializer, %B84.if.i ]
  %scevgep24.i = getelementptr i8, ptr %lsr.iv20.i, i64 -192
  %.520.i = load <8 x double>, ptr %scevgep24.i, align 8, !noalias !282
  %scevgep23.i = getelementptr i8, ptr %lsr.iv20.i, i64 -128
  %.532.i = load <8 x double>, ptr %scevgep23.i, align 8, !noalias !282
  %scevgep22.i = getelementptr i8, ptr %lsr.iv20.i, i64 -64
  %.545.i = load <8 x double>, ptr %scevgep22.i, align 8, !noalias !282
  %.558.i = load <8 x double>, ptr %lsr.iv20.i, align 8, !noalias !282
  %47 = shl i64 %lsr.iv25, 3
  %scevgep33 = getelementptr i8, ptr %.1489, i64 %47
  %scevgep34 = getelementptr i8, ptr %scevgep33, i64 8
  %.573.i = load double, ptr %scevgep34, align 8, !noalias !282
  %.575.i = insertelement <8 x double> poison, double %.573.i, i64 0
  %.576.i = shufflevector <8 x double> %.575.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.577.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.520.i, <8 x double> %.576.i, <8 x double> %_multiply_wide_v94_a00.2.1823.i)
  %.581.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.532.i, <8 x double> %.576.i, <8 x double> %_multiply_wide_v94_a01.2.1824.i)
  %.589.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.545.i, <8 x double> %.576.i, <8 x double> %_multiply_wide_v94_a02.2.1825.i)
  %.593.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.558.i, <8 x double> %.576.i, <8 x double> %_multiply_wide_v94_a03.2.1826.i)
  %scevgep7 = getelementptr i8, ptr %43, i64 %47
  %scevgep8 = getelementptr i8, ptr %scevgep7, i64 8
  %.610.i = load double, ptr %scevgep8, align 8, !noalias !282
  %.612.i = insertelement <8 x double> poison, double %.610.i, i64 0
  %.613.i = shufflevector <8 x double> %.612.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.614.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.520.i, <8 x double> %.613.i, <8 x double> %_multiply_wide_v94_a10.2.1827.i)
  %.618.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.532.i, <8 x double> %.613.i, <8 x double> %_multiply_wide_v94_a11.2.1828.i)
  %.626.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.545.i, <8 x double> %.613.i, <8 x double> %_multiply_wide_v94_a12.2.1829.i)
  %.630.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.558.i, <8 x double> %.613.i, <8 x double> %_multiply_wide_v94_a13.2.1830.i)
  %scevgep5 = getelementptr i8, ptr %44, i64 %47
  %scevgep6 = getelementptr i8, ptr %scevgep5, i64 8
  %.648.i = load double, ptr %scevgep6, align 8, !noalias !282
  %.650.i = insertelement <8 x double> poison, double %.648.i, i64 0
  %.651.i = shufflevector <8 x double> %.650.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.652.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.520.i, <8 x double> %.651.i, <8 x double> %_multiply_wide_v94_a20.2.1831.i)
  %.656.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.532.i, <8 x double> %.651.i, <8 x double> %_multiply_wide_v94_a21.2.1832.i)
  %.664.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.545.i, <8 x double> %.651.i, <8 x double> %_multiply_wide_v94_a22.2.1833.i)
  %.668.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.558.i, <8 x double> %.651.i, <8 x double> %_multiply_wide_v94_a23.2.1834.i)
  %scevgep3 = getelementptr i8, ptr %45, i64 %47
  %scevgep4 = getelementptr i8, ptr %scevgep3, i64 8
  %.686.i = load double, ptr %scevgep4, align 8, !noalias !282
  %.688.i = insertelement <8 x double> poison, double %.686.i, i64 0
  %.689.i = shufflevector <8 x double> %.688.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.690.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.520.i, <8 x double> %.689.i, <8 x double> %_multiply_wide_v94_a30.2.1835.i)
  %.694.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.532.i, <8 x double> %.689.i, <8 x double> %_multiply_wide_v94_a31.2.1836.i)
  %.702.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.545.i, <8 x double> %.689.i, <8 x double> %_multiply_wide_v94_a32.2.1837.i)
  %.706.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.558.i, <8 x double> %.689.i, <8 x double> %_multiply_wide_v94_a33.2.1838.i)
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

B356.if.i:                                        ; preds = %B354.endif.endif.endif.i, %B3102.i
  %position.5.0901.i = phi i64 [ %position.3.0.lcssa.i, %B354.endif.endif.endif.i ], [ %position.4.1.lcssa.i, %B3102.i ]
  %.1128892900.i = phi i64 [ %.1106806.i, %B354.endif.endif.endif.i ], [ %.1138.i, %B3102.i ]
  %.1135893899.i = phi i64 [ %.1046.i, %B354.endif.endif.endif.i ], [ %.1142.i, %B3102.i ]
  %.1138.i = add nsw i64 %.1128892900.i, -1
  %.1142.i = add nuw nsw i64 %.1135893899.i, 8
  br i1 %42, label %B3102.i, label %B884.if.preheader.i

B884.if.preheader.i:                              ; preds = %B356.if.i
  %54 = shl i64 %position.5.0901.i, 3
  %scevgep.i = getelementptr i8, ptr %.1842, i64 %54
  br label %B884.if.i

B884.if.i:                                        ; preds = %B884.if.i, %B884.if.preheader.i
  %lsr.iv18 = phi ptr [ %scevgep19, %B884.if.i ], [ %scevgep.i, %B884.if.preheader.i ]
  %lsr.iv9 = phi i64 [ %lsr.iv.next, %B884.if.i ], [ -1, %B884.if.preheader.i ]
  %b3.2.1884.i = phi <8 x double> [ %.1396.i, %B884.if.i ], [ zeroinitializer, %B884.if.preheader.i ]
  %b2.2.1883.i = phi <8 x double> [ %.1376.i, %B884.if.i ], [ zeroinitializer, %B884.if.preheader.i ]
  %b1.2.1882.i = phi <8 x double> [ %.1356.i, %B884.if.i ], [ zeroinitializer, %B884.if.preheader.i ]
  %b0.2.1881.i = phi <8 x double> [ %.1337.i, %B884.if.i ], [ zeroinitializer, %B884.if.preheader.i ]
  %.1318.i = load <8 x double>, ptr %lsr.iv18, align 8, !noalias !282
  %55 = shl i64 %lsr.iv9, 3
  %scevgep16 = getelementptr i8, ptr %.1489, i64 %55
  %scevgep17 = getelementptr i8, ptr %scevgep16, i64 8
  %.1333.i = load double, ptr %scevgep17, align 8, !noalias !282
  %.1335.i = insertelement <8 x double> poison, double %.1333.i, i64 0
  %.1336.i = shufflevector <8 x double> %.1335.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1337.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1318.i, <8 x double> %.1336.i, <8 x double> %b0.2.1881.i)
  %scevgep14 = getelementptr i8, ptr %48, i64 %55
  %scevgep15 = getelementptr i8, ptr %scevgep14, i64 8
  %.1352.i = load double, ptr %scevgep15, align 8, !noalias !282
  %.1354.i = insertelement <8 x double> poison, double %.1352.i, i64 0
  %.1355.i = shufflevector <8 x double> %.1354.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1356.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1318.i, <8 x double> %.1355.i, <8 x double> %b1.2.1882.i)
  %scevgep12 = getelementptr i8, ptr %49, i64 %55
  %scevgep13 = getelementptr i8, ptr %scevgep12, i64 8
  %.1372.i = load double, ptr %scevgep13, align 8, !noalias !282
  %.1374.i = insertelement <8 x double> poison, double %.1372.i, i64 0
  %.1375.i = shufflevector <8 x double> %.1374.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1376.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1318.i, <8 x double> %.1375.i, <8 x double> %b2.2.1883.i)
  %scevgep10 = getelementptr i8, ptr %50, i64 %55
  %scevgep11 = getelementptr i8, ptr %scevgep10, i64 8
  %.1392.i = load double, ptr %scevgep11, align 8, !noalias !282
  %.1394.i = insertelement <8 x double> poison, double %.1392.i, i64 0
  %.1395.i = shufflevector <8 x double> %.1394.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1396.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1318.i, <8 x double> %.1395.i, <8 x double> %b3.2.1884.i)
  %lsr.iv.next = add nsw i64 %lsr.iv9, 1
  %scevgep19 = getelementptr i8, ptr %lsr.iv18, i64 64
  %exitcond909.not.i = icmp eq i64 %.1143, %lsr.iv.next
  br i1 %exitcond909.not.i, label %B3102.loopexit.i, label %B884.if.i

B662.endif.endif.endif.endif:                     ; preds = %B3102.i, %B354.else.i
  %.1308 = icmp sgt i64 %.1307791, 1
  br i1 %.1308, label %B660.if, label %B816

B874.if:                                          ; preds = %B874.loopexit, %B874.if.lr.ph
  %lsr.iv47 = phi ptr [ %scevgep46, %B874.if.lr.ph ], [ %scevgep48, %B874.loopexit ]
  %.2026800806 = phi i64 [ 0, %B874.if.lr.ph ], [ %.2033, %B874.loopexit ]
  %.2033 = add nuw nsw i64 %.2026800806, 1
  br i1 %4, label %B972.if, label %B874.loopexit

B972.if:                                          ; preds = %B874.if, %B974.endif
  %lsr.iv20 = phi i64 [ %lsr.iv.next21, %B974.endif ], [ %3, %B874.if ]
  %lsr.iv49 = phi ptr [ %scevgep50, %B974.endif ], [ %lsr.iv47, %B874.if ]
  %.2193 = load <8 x double>, ptr %lsr.iv49, align 8
  %.2223 = load i64, ptr %sunkaddr59, align 8
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
  %lsr.iv.next21 = add nsw i64 %lsr.iv20, -1
  %.2145 = icmp sgt i64 %lsr.iv20, 7
  br i1 %.2145, label %B972.if, label %B874.loopexit

B1144.if:                                         ; preds = %B1144.loopexit, %B1144.if.lr.ph
  %lsr.iv22 = phi ptr [ %arg.out.4, %B1144.if.lr.ph ], [ %scevgep23, %B1144.loopexit ]
  %lsr.iv17 = phi ptr [ %scevgep, %B1144.if.lr.ph ], [ %scevgep18, %B1144.loopexit ]
  %.2426830836 = phi i64 [ 0, %B1144.if.lr.ph ], [ %.2433, %B1144.loopexit ]
  %.2433 = add nuw nsw i64 %.2426830836, 1
  br i1 %11, label %B1144.loopexit, label %B1192.if

B1192.if:                                         ; preds = %B1144.if, %B1192.if
  %lsr.iv1 = phi i64 [ %lsr.iv.next2, %B1192.if ], [ %10, %B1144.if ]
  %lsr.iv19 = phi i64 [ %lsr.iv.next20, %B1192.if ], [ 0, %B1144.if ]
  %scevgep24 = getelementptr i8, ptr %lsr.iv22, i64 %lsr.iv19
  %.2592 = load <8 x double>, ptr %scevgep24, align 8
  %scevgep21 = getelementptr i8, ptr %lsr.iv17, i64 %lsr.iv19
  %.2607 = load <8 x double>, ptr %scevgep21, align 8
  %.6.i = fadd contract <8 x double> %.2592, %.2607
  store <8 x double> %.6.i, ptr %scevgep24, align 8
  %lsr.iv.next20 = add i64 %lsr.iv19, 64
  %lsr.iv.next2 = add nsw i64 %lsr.iv1, -1
  %.2541 = icmp sgt i64 %lsr.iv1, 7
  br i1 %.2541, label %B1192.if, label %B1144.loopexit
}

; Function Attrs: mustprogress nocallback nocreateundeforpoison nofree nosync nounwind speculatable willreturn memory(none)
declare <8 x double> @llvm.fabs.v8f64(<8 x double>) #2

; Function Attrs: nofree noinline norecurse nosync nounwind memory(argmem: readwrite)
define internal fastcc void @inner_0(ptr noalias nonnull writeonly captures(none) %retptr, ptr readonly captures(none) %arg.parameters.4, ptr readonly captures(none) %arg.contents.4, ptr readonly captures(none) %arg.scaling.4, ptr captures(none) initializes((0, 40)) %arg.scratch.4, ptr writeonly captures(none) %arg.out.4) unnamed_addr #3 {
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
  store double %.38.le.i, ptr %arg.scratch.4, align 8, !noalias !285
  %.72.i = tail call contract double @llvm.pow.f64(double %.13.i, double 4.000000e-01)
  %.73.i = fmul contract double %.72.i, %.25.i
  store double %.73.i, ptr %sunkaddr8, align 8, !noalias !285
  %.103.i = tail call contract double @llvm.pow.f64(double %.13.i13, double 4.000000e-01)
  %.104.i = fmul contract double %.103.i, %.30.i
  store double %.104.i, ptr %sunkaddr12, align 8, !noalias !285
  %.134.i = fmul contract double %.1075, %.25.i
  %.135.i = fmul contract double %.30.i, %.1105
  %.136.i = fadd contract double %.134.i, %.135.i
  %.137.i = fmul contract double %.25.i, 0x3FD585A9E9585A9F
  %.138.i = fmul contract double %.30.i, %.137.i
  %.139.i = fadd contract double %.1075, %.1105
  %.140.i = fmul contract double %.139.i, %.138.i
  %.141.i = fsub contract double %.136.i, %.140.i
  store double %.141.i, ptr %sunkaddr19, align 8, !noalias !285
  %.171.i = fsub contract double %.1075, %.1105
  %.172.i = fmul contract double %.171.i, 5.000000e-01
  store double %.172.i, ptr %sunkaddr23, align 8, !noalias !285
  br label %B570.if

B370:                                             ; preds = %B118.if
  %.38.le.i.i = tail call contract double @llvm.log.f64(double %.1045)
  %.21.i.i = fadd contract double %.1045, 1.000000e+00
  %.30.i.i = fdiv contract double 1.000000e+00, %.21.i.i
  %.25.i.i = fdiv contract double %.1045, %.21.i.i
  store double %.38.le.i.i, ptr %arg.scratch.4, align 8, !noalias !288
  %.72.i.i = tail call contract double @llvm.pow.f64(double %.13.i, double 4.000000e-01)
  %.73.i.i = fmul contract double %.72.i.i, %.25.i.i
  store double %.73.i.i, ptr %sunkaddr30, align 8, !noalias !288
  %.103.i.i = tail call contract double @llvm.pow.f64(double %.13.i13, double 4.000000e-01)
  %.104.i.i = fmul contract double %.103.i.i, %.30.i.i
  store double %.104.i.i, ptr %sunkaddr36, align 8, !noalias !288
  %.134.i.i = fmul contract double %.1075, %.25.i.i
  %.135.i.i = fmul contract double %.30.i.i, %.1105
  %.136.i.i = fadd contract double %.134.i.i, %.135.i.i
  %.137.i.i = fmul contract double %.25.i.i, 0x3FD585A9E9585A9F
  %.138.i.i = fmul contract double %.30.i.i, %.137.i.i
  %.139.i.i = fadd contract double %.1075, %.1105
  %.140.i.i = fmul contract double %.139.i.i, %.138.i.i
  %.141.i.i = fsub contract double %.136.i.i, %.140.i.i
  store double %.141.i.i, ptr %sunkaddr41, align 8, !noalias !288
  %.171.i.i = fsub contract double %.1075, %.1105
  %.172.i.i = fmul contract double %.171.i.i, 5.000000e-01
  store double %.172.i.i, ptr %sunkaddr45, align 8, !noalias !288
  %.107.i = fsub contract double %.73.i.i, %.104.i.i
  %.166.i = fadd contract double %.73.i.i, %.104.i.i
  store double %.107.i, ptr %sunkaddr30, align 8, !noalias !293
  store double %.166.i, ptr %sunkaddr36, align 8, !noalias !293
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

; Function Attrs: mustprogress nocallback nofree nosync nounwind willreturn memory(argmem: readwrite)
declare void @llvm.lifetime.start.p0(ptr captures(none)) #8

; Function Attrs: mustprogress nocallback nofree nosync nounwind willreturn memory(argmem: readwrite)
declare void @llvm.lifetime.end.p0(ptr captures(none)) #8

attributes #0 = { nofree norecurse nosync nounwind memory(readwrite, inaccessiblemem: none, target_mem0: none, target_mem1: none) }
attributes #1 = { mustprogress nocallback nofree nounwind willreturn memory(argmem: write) }
attributes #2 = { mustprogress nocallback nocreateundeforpoison nofree nosync nounwind speculatable willreturn memory(none) }
attributes #3 = { nofree noinline norecurse nosync nounwind memory(argmem: readwrite) }
attributes #4 = { nofree norecurse nosync nounwind memory(argmem: readwrite) }
attributes #5 = { mustprogress nocallback nofree nosync nounwind willreturn memory(none) }
attributes #6 = { mustprogress nofree norecurse nosync nounwind willreturn memory(argmem: readwrite) }
attributes #7 = { nofree noinline norecurse nosync nounwind memory(readwrite, inaccessiblemem: none, target_mem0: none, target_mem1: none) }
attributes #8 = { mustprogress nocallback nofree nosync nounwind willreturn memory(argmem: readwrite) }

!0 = !{!1, !3}
!1 = distinct !{!1, !2, !"_ZN17bnserve_surrogate8tangents7_source13differentiateB2v3B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE: %retptr"}
!2 = distinct !{!2, !"_ZN17bnserve_surrogate8tangents7_source13differentiateB2v3B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE"}
!3 = distinct !{!3, !2, !"_ZN17bnserve_surrogate8tangents7_source13differentiateB2v3B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE: %excinfo"}
!4 = !{!5, !7, !1, !3}
!5 = distinct !{!5, !6, !"_ZN17bnserve_surrogate8tangents7_source5_tileB2v5B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExx5ArrayIxLi1E1C7mutable7alignedE: %retptr"}
!6 = distinct !{!6, !"_ZN17bnserve_surrogate8tangents7_source5_tileB2v5B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExx5ArrayIxLi1E1C7mutable7alignedE"}
!7 = distinct !{!7, !6, !"_ZN17bnserve_surrogate8tangents7_source5_tileB2v5B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExx5ArrayIxLi1E1C7mutable7alignedE: %excinfo"}
!8 = !{!9, !5, !7, !1, !3}
!9 = distinct !{!9, !10, !"_ZN17bnserve_surrogate8tangents7_source12_coordinatesB3v36B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!10 = distinct !{!10, !"_ZN17bnserve_surrogate8tangents7_source12_coordinatesB3v36B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!11 = !{!12, !9, !5, !7, !1, !3}
!12 = distinct !{!12, !13, !"_ZN17bnserve_surrogate8tangents12_coordinates13fill_jacobianB3v42B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!13 = distinct !{!13, !"_ZN17bnserve_surrogate8tangents12_coordinates13fill_jacobianB3v42B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE"}
!14 = !{!15, !12, !9, !5, !7, !1, !3}
!15 = distinct !{!15, !16, !"_ZN17bnserve_surrogate8tangents12_coordinates9_physicalB3v48B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedEdbx5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!16 = distinct !{!16, !"_ZN17bnserve_surrogate8tangents12_coordinates9_physicalB3v48B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedEdbx5ArrayIdLi1E1C7mutable7alignedE"}
!17 = !{!18, !5, !7, !1, !3}
!18 = distinct !{!18, !19, !"_ZN17bnserve_surrogate8tangents7_source7_ratiosB4v127B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!19 = distinct !{!19, !"_ZN17bnserve_surrogate8tangents7_source7_ratiosB4v127B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!20 = !{!"branch_weights", i32 49, i32 1}
!21 = !{!22, !5, !7, !1, !3}
!22 = distinct !{!22, !23, !"_ZN17bnserve_surrogate8tangents7_source7_refuseB4v576B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIxLi1E1C7mutable7alignedE: %retptr"}
!23 = distinct !{!23, !"_ZN17bnserve_surrogate8tangents7_source7_refuseB4v576B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIxLi1E1C7mutable7alignedE"}
!24 = !{!"branch_weights", i32 1, i32 99}
!25 = !{!"branch_weights", i32 146201250, i32 2001282398}
!26 = !{!"branch_weights", i32 166258294, i32 1981225354}
!27 = !{!"branch_weights", i32 1030503492, i32 1116980156}
!28 = !{!"branch_weights", i32 277993707, i32 1869489941}
!29 = !{!"branch_weights", i32 542333185, i32 1605150463}
!30 = distinct !{!30, !31, !32}
!31 = !{!"llvm.loop.estimated_trip_count", i32 4}
!32 = !{!"llvm.loop.unroll.disable"}
!33 = !{!"branch_weights", i32 319644862, i32 1827838786}
!34 = distinct !{!34, !35}
!35 = !{!"llvm.loop.estimated_trip_count", i32 6}
!36 = !{!37}
!37 = distinct !{!37, !38, !"_ZN17bnserve_surrogate8tangents11_regression11_along_axesB4v114B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!38 = distinct !{!38, !"_ZN17bnserve_surrogate8tangents11_regression11_along_axesB4v114B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!39 = !{!"branch_weights", i32 99, i32 1}
!40 = !{!41, !37}
!41 = distinct !{!41, !42, !"_ZN17bnserve_surrogate8tangents11_regression10_chebyshevB4v119B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!42 = distinct !{!42, !"_ZN17bnserve_surrogate8tangents11_regression10_chebyshevB4v119B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE"}
!43 = !{!44, !37}
!44 = distinct !{!44, !45, !"_ZN17bnserve_surrogate8tangents11_regression9_productsB4v122B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dExxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!45 = distinct !{!45, !"_ZN17bnserve_surrogate8tangents11_regression9_productsB4v122B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dExxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!46 = !{!47, !37}
!47 = distinct !{!47, !48, !"_ZN17bnserve_surrogate6kernel9_matrices8multiplyB3v82B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIdLi1E1C7mutable7alignedE23Literal_5bint_5d_281_2923Literal_5bint_5d_288_295ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedEx: %retptr"}
!48 = distinct !{!48, !"_ZN17bnserve_surrogate6kernel9_matrices8multiplyB3v82B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIdLi1E1C7mutable7alignedE23Literal_5bint_5d_281_2923Literal_5bint_5d_288_295ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedEx"}
!49 = !{!50}
!50 = distinct !{!50, !51, !"_ZN17bnserve_surrogate8tangents11_regression8_combineB4v126B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedExxx5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!51 = distinct !{!51, !"_ZN17bnserve_surrogate8tangents11_regression8_combineB4v126B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedExxx5ArrayIdLi1E1C7mutable7alignedE"}
!52 = !{!53, !55}
!53 = distinct !{!53, !54, !"_ZN17bnserve_surrogate8tangents8_carrier15prepare_splinesB4v144B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE692Row_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20int64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_203_29_2c_20UniTuple_28array_28float64_2c_201d_2c_20C_29_20x_202_29_2c_20UniTuple_28array_28int64_2c_201d_2c_20C_29_20x_202_29_2c_20UniTuple_28array_28float64_2c_201d_2c_20C_29_20x_202_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29: %retptr"}
!54 = distinct !{!54, !"_ZN17bnserve_surrogate8tangents8_carrier15prepare_splinesB4v144B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE692Row_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20int64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_203_29_2c_20UniTuple_28array_28float64_2c_201d_2c_20C_29_20x_202_29_2c_20UniTuple_28array_28int64_2c_201d_2c_20C_29_20x_202_29_2c_20UniTuple_28array_28float64_2c_201d_2c_20C_29_20x_202_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29"}
!55 = distinct !{!55, !54, !"_ZN17bnserve_surrogate8tangents8_carrier15prepare_splinesB4v144B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE692Row_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20int64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_203_29_2c_20UniTuple_28array_28float64_2c_201d_2c_20C_29_20x_202_29_2c_20UniTuple_28array_28int64_2c_201d_2c_20C_29_20x_202_29_2c_20UniTuple_28array_28float64_2c_201d_2c_20C_29_20x_202_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29: %excinfo"}
!56 = !{!57, !53, !55}
!57 = distinct !{!57, !58, !"_ZN17bnserve_surrogate6kernel7_points10fill_cellsB4v165B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedExx5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!58 = distinct !{!58, !"_ZN17bnserve_surrogate6kernel7_points10fill_cellsB4v165B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedExx5ArrayIdLi1E1C7mutable7alignedE"}
!59 = !{!60, !53, !55}
!60 = distinct !{!60, !61, !"_ZN17bnserve_surrogate6kernel7_points10fill_cellsB4v165B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedExx5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!61 = distinct !{!61, !"_ZN17bnserve_surrogate6kernel7_points10fill_cellsB4v165B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedExx5ArrayIdLi1E1C7mutable7alignedE"}
!62 = !{!63, !53, !55}
!63 = distinct !{!63, !64, !"_ZN17bnserve_surrogate8tangents8_carrier11fill_slopesB4v166B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedExd5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!64 = distinct !{!64, !"_ZN17bnserve_surrogate8tangents8_carrier11fill_slopesB4v166B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedExd5ArrayIdLi1E1C7mutable7alignedE"}
!65 = !{!66, !53, !55}
!66 = distinct !{!66, !67, !"_ZN17bnserve_surrogate8tangents8_carrier11fill_slopesB4v166B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedExd5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!67 = distinct !{!67, !"_ZN17bnserve_surrogate8tangents8_carrier11fill_slopesB4v166B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedExd5ArrayIdLi1E1C7mutable7alignedE"}
!68 = !{!69, !71, !53, !55}
!69 = distinct !{!69, !70, !"_ZN17bnserve_surrogate8tangents7_series19fill_phase_tangentsB4v168B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayI10complex128Li2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!70 = distinct !{!70, !"_ZN17bnserve_surrogate8tangents7_series19fill_phase_tangentsB4v168B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayI10complex128Li2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!71 = distinct !{!71, !70, !"_ZN17bnserve_surrogate8tangents7_series19fill_phase_tangentsB4v168B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayI10complex128Li2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %excinfo"}
!72 = !{!73, !75, !69, !71, !53, !55}
!73 = distinct !{!73, !74, !"_ZN17bnserve_surrogate8tangents7_series6_phaseB4v174B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE10complex12810complex12810complex1288UniTupleI10complex128Li2EE8UniTupleI10complex128Li2EE5ArrayI10complex128Li2E1C7mutable7alignedE: %retptr"}
!74 = distinct !{!74, !"_ZN17bnserve_surrogate8tangents7_series6_phaseB4v174B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE10complex12810complex12810complex1288UniTupleI10complex128Li2EE8UniTupleI10complex128Li2EE5ArrayI10complex128Li2E1C7mutable7alignedE"}
!75 = distinct !{!75, !74, !"_ZN17bnserve_surrogate8tangents7_series6_phaseB4v174B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE10complex12810complex12810complex1288UniTupleI10complex128Li2EE8UniTupleI10complex128Li2EE5ArrayI10complex128Li2E1C7mutable7alignedE: %excinfo"}
!76 = !{!"branch_weights", i32 42949673, i32 2104533975}
!77 = !{!78, !80, !73, !75, !69, !71, !53, !55}
!78 = distinct !{!78, !79, !"_ZN17bnserve_surrogate8baseline6_phase20add_point_mass_phaseB4v175B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDAxYh_2bqJnA4AOzNAE_3dE10complex1285ArrayI10complex128Li2E1C7mutable7alignedE: %retptr"}
!79 = distinct !{!79, !"_ZN17bnserve_surrogate8baseline6_phase20add_point_mass_phaseB4v175B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDAxYh_2bqJnA4AOzNAE_3dE10complex1285ArrayI10complex128Li2E1C7mutable7alignedE"}
!80 = distinct !{!80, !79, !"_ZN17bnserve_surrogate8baseline6_phase20add_point_mass_phaseB4v175B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDAxYh_2bqJnA4AOzNAE_3dE10complex1285ArrayI10complex128Li2E1C7mutable7alignedE: %excinfo"}
!81 = !{!82, !73, !75, !69, !71, !53, !55}
!82 = distinct !{!82, !83, !"_ZN17bnserve_surrogate8baseline6_phase19add_spin_spin_phaseB4v179B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDAxYh_2bqJnA4AOzNAE_3dE10complex12810complex12810complex1285ArrayI10complex128Li2E1C7mutable7alignedE: %retptr"}
!83 = distinct !{!83, !"_ZN17bnserve_surrogate8baseline6_phase19add_spin_spin_phaseB4v179B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDAxYh_2bqJnA4AOzNAE_3dE10complex12810complex12810complex1285ArrayI10complex128Li2E1C7mutable7alignedE"}
!84 = !{!85, !87, !53, !55}
!85 = distinct !{!85, !86, !"_ZN17bnserve_surrogate8tangents7_series23fill_amplitude_tangentsB4v182B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayI10complex128Li1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!86 = distinct !{!86, !"_ZN17bnserve_surrogate8tangents7_series23fill_amplitude_tangentsB4v182B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayI10complex128Li1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!87 = distinct !{!87, !86, !"_ZN17bnserve_surrogate8tangents7_series23fill_amplitude_tangentsB4v182B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayI10complex128Li1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %excinfo"}
!88 = !{!89, !91, !85, !87, !53, !55}
!89 = distinct !{!89, !90, !"_ZN17bnserve_surrogate8baseline10_amplitude22amplitude_coefficientsB4v184B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDAxYh_2bqJnA4AOzNAE_3dE10complex12810complex12810complex1285ArrayI10complex128Li1E1C7mutable7alignedE: %retptr"}
!90 = distinct !{!90, !"_ZN17bnserve_surrogate8baseline10_amplitude22amplitude_coefficientsB4v184B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDAxYh_2bqJnA4AOzNAE_3dE10complex12810complex12810complex1285ArrayI10complex128Li1E1C7mutable7alignedE"}
!91 = distinct !{!91, !90, !"_ZN17bnserve_surrogate8baseline10_amplitude22amplitude_coefficientsB4v184B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDAxYh_2bqJnA4AOzNAE_3dE10complex12810complex12810complex1285ArrayI10complex128Li1E1C7mutable7alignedE: %excinfo"}
!92 = !{!93, !95}
!93 = distinct !{!93, !94, !"_ZN17bnserve_surrogate8tangents4_row6_orderB4v187B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx23Literal_5bint_5d_282_2923Literal_5bint_5d_280_2923Literal_5bint_5d_280_29d692Row_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20int64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_203_29_2c_20UniTuple_28array_28float64_2c_201d_2c_20C_29_20x_202_29_2c_20UniTuple_28array_28int64_2c_201d_2c_20C_29_20x_202_29_2c_20UniTuple_28array_28float64_2c_201d_2c_20C_29_20x_202_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29: %retptr"}
!94 = distinct !{!94, !"_ZN17bnserve_surrogate8tangents4_row6_orderB4v187B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx23Literal_5bint_5d_282_2923Literal_5bint_5d_280_2923Literal_5bint_5d_280_29d692Row_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20int64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_203_29_2c_20UniTuple_28array_28float64_2c_201d_2c_20C_29_20x_202_29_2c_20UniTuple_28array_28int64_2c_201d_2c_20C_29_20x_202_29_2c_20UniTuple_28array_28float64_2c_201d_2c_20C_29_20x_202_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29"}
!95 = distinct !{!95, !94, !"_ZN17bnserve_surrogate8tangents4_row6_orderB4v187B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx23Literal_5bint_5d_282_2923Literal_5bint_5d_280_2923Literal_5bint_5d_280_29d692Row_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20int64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_203_29_2c_20UniTuple_28array_28float64_2c_201d_2c_20C_29_20x_202_29_2c_20UniTuple_28array_28int64_2c_201d_2c_20C_29_20x_202_29_2c_20UniTuple_28array_28float64_2c_201d_2c_20C_29_20x_202_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29: %excinfo"}
!96 = !{!97, !99}
!97 = distinct !{!97, !98, !"_ZN17bnserve_surrogate8tangents4_row6_orderB4v560B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxxd692Row_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20int64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_203_29_2c_20UniTuple_28array_28float64_2c_201d_2c_20C_29_20x_202_29_2c_20UniTuple_28array_28int64_2c_201d_2c_20C_29_20x_202_29_2c_20UniTuple_28array_28float64_2c_201d_2c_20C_29_20x_202_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29: %retptr"}
!98 = distinct !{!98, !"_ZN17bnserve_surrogate8tangents4_row6_orderB4v560B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxxd692Row_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20int64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_203_29_2c_20UniTuple_28array_28float64_2c_201d_2c_20C_29_20x_202_29_2c_20UniTuple_28array_28int64_2c_201d_2c_20C_29_20x_202_29_2c_20UniTuple_28array_28float64_2c_201d_2c_20C_29_20x_202_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29"}
!99 = distinct !{!99, !98, !"_ZN17bnserve_surrogate8tangents4_row6_orderB4v560B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxxd692Row_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20int64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_203_29_2c_20UniTuple_28array_28float64_2c_201d_2c_20C_29_20x_202_29_2c_20UniTuple_28array_28int64_2c_201d_2c_20C_29_20x_202_29_2c_20UniTuple_28array_28float64_2c_201d_2c_20C_29_20x_202_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29: %excinfo"}
!100 = !{!101, !97, !99}
!101 = distinct !{!101, !102, !"_ZN17bnserve_surrogate8tangents6_ratio13prepare_ratioB4v284B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE692Row_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20int64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_203_29_2c_20UniTuple_28array_28float64_2c_201d_2c_20C_29_20x_202_29_2c_20UniTuple_28array_28int64_2c_201d_2c_20C_29_20x_202_29_2c_20UniTuple_28array_28float64_2c_201d_2c_20C_29_20x_202_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_295ArrayIxLi1E1C7mutable7alignedEdx: %retptr"}
!102 = distinct !{!102, !"_ZN17bnserve_surrogate8tangents6_ratio13prepare_ratioB4v284B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE692Row_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20int64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_203_29_2c_20UniTuple_28array_28float64_2c_201d_2c_20C_29_20x_202_29_2c_20UniTuple_28array_28int64_2c_201d_2c_20C_29_20x_202_29_2c_20UniTuple_28array_28float64_2c_201d_2c_20C_29_20x_202_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_295ArrayIxLi1E1C7mutable7alignedEdx"}
!103 = !{!104, !101, !97, !99}
!104 = distinct !{!104, !105, !"_ZN17bnserve_surrogate6kernel7_places9find_endsB4v258B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5TupleI5ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedExdE5ArrayIdLi1E1C7mutable7alignedExdx5ArrayIxLi1E1C7mutable7alignedE: %retptr"}
!105 = distinct !{!105, !"_ZN17bnserve_surrogate6kernel7_places9find_endsB4v258B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5TupleI5ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedExdE5ArrayIdLi1E1C7mutable7alignedExdx5ArrayIxLi1E1C7mutable7alignedE"}
!106 = !{!107, !101, !97, !99}
!107 = distinct !{!107, !108, !"_ZN17bnserve_surrogate6kernel7_points10fill_cellsB4v165B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedExx5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!108 = distinct !{!108, !"_ZN17bnserve_surrogate6kernel7_points10fill_cellsB4v165B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedExx5ArrayIdLi1E1C7mutable7alignedE"}
!109 = !{!110, !101, !97, !99}
!110 = distinct !{!110, !111, !"_ZN17bnserve_surrogate6kernel7_points10fill_cellsB4v165B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedExx5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!111 = distinct !{!111, !"_ZN17bnserve_surrogate6kernel7_points10fill_cellsB4v165B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedExx5ArrayIdLi1E1C7mutable7alignedE"}
!112 = !{!113, !101, !97, !99}
!113 = distinct !{!113, !114, !"_ZN17bnserve_surrogate8tangents8_carrier11fill_slopesB4v166B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedExd5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!114 = distinct !{!114, !"_ZN17bnserve_surrogate8tangents8_carrier11fill_slopesB4v166B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedExd5ArrayIdLi1E1C7mutable7alignedE"}
!115 = !{!116, !101, !97, !99}
!116 = distinct !{!116, !117, !"_ZN17bnserve_surrogate8tangents8_carrier11fill_slopesB4v166B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedExd5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!117 = distinct !{!117, !"_ZN17bnserve_surrogate8tangents8_carrier11fill_slopesB4v166B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedExd5ArrayIdLi1E1C7mutable7alignedE"}
!118 = !{!119, !97, !99}
!119 = distinct !{!119, !120, !"_ZN17bnserve_surrogate6kernel5modes5_sums4turnB4v394B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExd5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!120 = distinct !{!120, !"_ZN17bnserve_surrogate6kernel5modes5_sums4turnB4v394B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExd5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!121 = !{!122, !97, !99}
!122 = distinct !{!122, !123, !"_ZN17bnserve_surrogate8tangents4_row11_write_modeB4v413B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi3EEd692Row_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20int64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_203_29_2c_20UniTuple_28array_28float64_2c_201d_2c_20C_29_20x_202_29_2c_20UniTuple_28array_28int64_2c_201d_2c_20C_29_20x_202_29_2c_20UniTuple_28array_28float64_2c_201d_2c_20C_29_20x_202_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29: %retptr"}
!123 = distinct !{!123, !"_ZN17bnserve_surrogate8tangents4_row11_write_modeB4v413B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi3EEd692Row_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20int64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_203_29_2c_20UniTuple_28array_28float64_2c_201d_2c_20C_29_20x_202_29_2c_20UniTuple_28array_28int64_2c_201d_2c_20C_29_20x_202_29_2c_20UniTuple_28array_28float64_2c_201d_2c_20C_29_20x_202_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29"}
!124 = !{!125, !122, !97, !99}
!125 = distinct !{!125, !126, !"_ZN17bnserve_surrogate8tangents7_points5splitB4v409B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!126 = distinct !{!126, !"_ZN17bnserve_surrogate8tangents7_points5splitB4v409B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!127 = !{!128, !122, !97, !99}
!128 = distinct !{!128, !129, !"_ZN17bnserve_surrogate8tangents7_points5splitB4v409B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!129 = distinct !{!129, !"_ZN17bnserve_surrogate8tangents7_points5splitB4v409B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!130 = !{!131, !122, !97, !99}
!131 = distinct !{!131, !132, !"_ZN17bnserve_surrogate8tangents6_ratio18fill_ratio_tangentB4v457B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE692Row_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20int64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_203_29_2c_20UniTuple_28array_28float64_2c_201d_2c_20C_29_20x_202_29_2c_20UniTuple_28array_28int64_2c_201d_2c_20C_29_20x_202_29_2c_20UniTuple_28array_28float64_2c_201d_2c_20C_29_20x_202_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_295ArrayIxLi1E1C7mutable7alignedExxxd: %retptr"}
!132 = distinct !{!132, !"_ZN17bnserve_surrogate8tangents6_ratio18fill_ratio_tangentB4v457B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE692Row_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20int64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_203_29_2c_20UniTuple_28array_28float64_2c_201d_2c_20C_29_20x_202_29_2c_20UniTuple_28array_28int64_2c_201d_2c_20C_29_20x_202_29_2c_20UniTuple_28array_28float64_2c_201d_2c_20C_29_20x_202_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_295ArrayIxLi1E1C7mutable7alignedExxxd"}
!133 = !{!134, !131, !122, !97, !99}
!134 = distinct !{!134, !135, !"_ZN17bnserve_surrogate6kernel5modes5_sums10fill_ratioB4v480B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedExx5ArrayIxLi1E1C7mutable7alignedEd5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi2EEx8UniTupleIdLi4EE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!135 = distinct !{!135, !"_ZN17bnserve_surrogate6kernel5modes5_sums10fill_ratioB4v480B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedExx5ArrayIxLi1E1C7mutable7alignedEd5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi2EEx8UniTupleIdLi4EE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!136 = distinct !{!136, !32}
!137 = !{!138, !134, !131, !122, !97, !99}
!138 = distinct !{!138, !139, !"_ZN17bnserve_surrogate6kernel7_points11two_splinesB4v483B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedExxd5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!139 = distinct !{!139, !"_ZN17bnserve_surrogate6kernel7_points11two_splinesB4v483B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedExxd5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!140 = distinct !{!140, !32}
!141 = !{!142, !122, !97, !99}
!142 = distinct !{!142, !143, !"_ZN17bnserve_surrogate8tangents7_points13write_carrierB4v410B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExd8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi2EE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!143 = distinct !{!143, !"_ZN17bnserve_surrogate8tangents7_points13write_carrierB4v410B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExd8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi2EE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!144 = !{!145, !122, !97, !99}
!145 = distinct !{!145, !146, !"_ZN17bnserve_surrogate8tangents7_points5zerosB4v412B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dExx5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!146 = distinct !{!146, !"_ZN17bnserve_surrogate8tangents7_points5zerosB4v412B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dExx5ArrayIdLi1E1C7mutable7alignedE"}
!147 = distinct !{!147, !32}
!148 = distinct !{!148, !32}
!149 = !{!150, !122, !97, !99}
!150 = distinct !{!150, !151, !"_ZN17bnserve_surrogate8tangents4_row5_riseB4v452B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIdLi1E1C7mutable7alignedEddx692Row_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20int64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_203_29_2c_20UniTuple_28array_28float64_2c_201d_2c_20C_29_20x_202_29_2c_20UniTuple_28array_28int64_2c_201d_2c_20C_29_20x_202_29_2c_20UniTuple_28array_28float64_2c_201d_2c_20C_29_20x_202_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_298UniTupleI5ArrayIdLi1E1C7mutable7alignedELi2EE: %retptr"}
!151 = distinct !{!151, !"_ZN17bnserve_surrogate8tangents4_row5_riseB4v452B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIdLi1E1C7mutable7alignedEddx692Row_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20int64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_203_29_2c_20UniTuple_28array_28float64_2c_201d_2c_20C_29_20x_202_29_2c_20UniTuple_28array_28int64_2c_201d_2c_20C_29_20x_202_29_2c_20UniTuple_28array_28float64_2c_201d_2c_20C_29_20x_202_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_298UniTupleI5ArrayIdLi1E1C7mutable7alignedELi2EE"}
!152 = !{!153, !122, !97, !99}
!153 = distinct !{!153, !154, !"_ZN17bnserve_surrogate8tangents7_points10write_modeB4v484B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExddx8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi2EE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi2EE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi2EE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!154 = distinct !{!154, !"_ZN17bnserve_surrogate8tangents7_points10write_modeB4v484B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExddx8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi2EE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi2EE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi2EE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!155 = !{!156, !122, !97, !99}
!156 = distinct !{!156, !157, !"_ZN17bnserve_surrogate8tangents7_points5zerosB4v412B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dExx5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!157 = distinct !{!157, !"_ZN17bnserve_surrogate8tangents7_points5zerosB4v412B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dExx5ArrayIdLi1E1C7mutable7alignedE"}
!158 = !{!159}
!159 = distinct !{!159, !160, !"_ZN17bnserve_surrogate6kernel7_points6phasesB4v283B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE23Literal_5bint_5d_281_295ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!160 = distinct !{!160, !"_ZN17bnserve_surrogate6kernel7_points6phasesB4v283B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE23Literal_5bint_5d_281_295ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!161 = !{!162}
!162 = distinct !{!162, !163, !"_ZN17bnserve_surrogate8tangents7_series17fill_slope_seriesB4v257B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedEdd5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!163 = distinct !{!163, !"_ZN17bnserve_surrogate8tangents7_series17fill_slope_seriesB4v257B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedEdd5ArrayIdLi1E1C7mutable7alignedE"}
!164 = !{!165}
!165 = distinct !{!165, !166, !"_ZN17bnserve_surrogate6kernel7_points6phasesB4v283B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE23Literal_5bint_5d_281_295ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!166 = distinct !{!166, !"_ZN17bnserve_surrogate6kernel7_points6phasesB4v283B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE23Literal_5bint_5d_281_295ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!167 = !{!168}
!168 = distinct !{!168, !169, !"_ZN17bnserve_surrogate8tangents7_points11fill_sharesB4v369B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE8UniTupleIxLi3EEd5ArrayIdLi1E1C7mutable7alignedEd5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!169 = distinct !{!169, !"_ZN17bnserve_surrogate8tangents7_points11fill_sharesB4v369B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE8UniTupleIxLi3EEd5ArrayIdLi1E1C7mutable7alignedEd5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!170 = !{!171}
!171 = distinct !{!171, !172, !"_ZN17bnserve_surrogate8tangents8_carrier7_extendB4v375B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE692Row_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20int64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_203_29_2c_20UniTuple_28array_28float64_2c_201d_2c_20C_29_20x_202_29_2c_20UniTuple_28array_28int64_2c_201d_2c_20C_29_20x_202_29_2c_20UniTuple_28array_28float64_2c_201d_2c_20C_29_20x_202_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29x5ArrayIdLi1E1C7mutable7alignedExddd5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!172 = distinct !{!172, !"_ZN17bnserve_surrogate8tangents8_carrier7_extendB4v375B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE692Row_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20int64_2c_20array_28float64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_203_29_2c_20UniTuple_28array_28float64_2c_201d_2c_20C_29_20x_202_29_2c_20UniTuple_28array_28int64_2c_201d_2c_20C_29_20x_202_29_2c_20UniTuple_28array_28float64_2c_201d_2c_20C_29_20x_202_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_29x5ArrayIdLi1E1C7mutable7alignedExddd5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!173 = !{!174, !171}
!174 = distinct !{!174, !175, !"_ZN17bnserve_surrogate8tangents7_points17extend_mass_belowB4v378B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedExddddd5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!175 = distinct !{!175, !"_ZN17bnserve_surrogate8tangents7_points17extend_mass_belowB4v378B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedExddddd5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!176 = !{!177, !171}
!177 = distinct !{!177, !178, !"_ZN17bnserve_surrogate6kernel7_points12extend_belowB4v379B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedExdd8UniTupleIdLi2EEd5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!178 = distinct !{!178, !"_ZN17bnserve_surrogate6kernel7_points12extend_belowB4v379B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedExdd8UniTupleIdLi2EEd5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!179 = !{!180}
!180 = distinct !{!180, !181, !"_ZN17bnserve_surrogate6kernel7_points11two_splinesB4v483B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedExxd5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!181 = distinct !{!181, !"_ZN17bnserve_surrogate6kernel7_points11two_splinesB4v483B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedExxd5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!182 = !{!183}
!183 = distinct !{!183, !184, !"_ZN17bnserve_surrogate6kernel7_points6splineB4v543B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedExxd5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!184 = distinct !{!184, !"_ZN17bnserve_surrogate6kernel7_points6splineB4v543B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedExxd5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE"}
!185 = !{!186}
!186 = distinct !{!186, !187, !"_ZN17bnserve_surrogate6kernel7_points6phasesB4v388B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!187 = distinct !{!187, !"_ZN17bnserve_surrogate6kernel7_points6phasesB4v388B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!188 = !{!189}
!189 = distinct !{!189, !190, !"_ZN17bnserve_surrogate8tangents7_points21add_amplitude_tangentB4v389B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedExx5ArrayIdLi1E1C7mutable7alignedEdd5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!190 = distinct !{!190, !"_ZN17bnserve_surrogate8tangents7_points21add_amplitude_tangentB4v389B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedExx5ArrayIdLi1E1C7mutable7alignedEdd5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!191 = !{!192}
!192 = distinct !{!192, !193, !"_ZN17bnserve_surrogate8tangents7_points9fill_lineB4v392B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedExxddddd5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!193 = distinct !{!193, !"_ZN17bnserve_surrogate8tangents7_points9fill_lineB4v392B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedExxddddd5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!194 = !{!195}
!195 = distinct !{!195, !196, !"_ZN17bnserve_surrogate8tangents8_carrier5_fallB4v393B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedExxdd5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!196 = distinct !{!196, !"_ZN17bnserve_surrogate8tangents8_carrier5_fallB4v393B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedExxdd5ArrayIdLi1E1C7mutable7alignedE"}
!197 = !{!198}
!198 = distinct !{!198, !199, !"_ZN17bnserve_surrogate6kernel7_points6splineB4v543B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedExxd5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!199 = distinct !{!199, !"_ZN17bnserve_surrogate6kernel7_points6splineB4v543B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedExxd5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE"}
!200 = !{!201}
!201 = distinct !{!201, !202, !"_ZN17bnserve_surrogate6kernel7_points6phasesB4v388B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!202 = distinct !{!202, !"_ZN17bnserve_surrogate6kernel7_points6phasesB4v388B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!203 = !{!204}
!204 = distinct !{!204, !205, !"_ZN17bnserve_surrogate8tangents7_points5splitB4v409B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!205 = distinct !{!205, !"_ZN17bnserve_surrogate8tangents7_points5splitB4v409B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!206 = !{!207}
!207 = distinct !{!207, !208, !"_ZN17bnserve_surrogate8tangents7_points13write_carrierB4v410B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExd8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi2EE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!208 = distinct !{!208, !"_ZN17bnserve_surrogate8tangents7_points13write_carrierB4v410B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExd8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi2EE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!209 = !{!210}
!210 = distinct !{!210, !211, !"_ZN17bnserve_surrogate8tangents7_points5zerosB4v412B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dExx5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!211 = distinct !{!211, !"_ZN17bnserve_surrogate8tangents7_points5zerosB4v412B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dExx5ArrayIdLi1E1C7mutable7alignedE"}
!212 = distinct !{!212, !32}
!213 = !{!214}
!214 = distinct !{!214, !215, !"_ZN17bnserve_surrogate8tangents7_series16fill_mass_seriesB4v256B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedEd5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!215 = distinct !{!215, !"_ZN17bnserve_surrogate8tangents7_series16fill_mass_seriesB4v256B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedEd5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!216 = !{!217}
!217 = distinct !{!217, !218, !"_ZN17bnserve_surrogate6kernel7_places9find_endsB4v258B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5TupleI5ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedExdE5ArrayIdLi1E1C7mutable7alignedExdx5ArrayIxLi1E1C7mutable7alignedE: %retptr"}
!218 = distinct !{!218, !"_ZN17bnserve_surrogate6kernel7_places9find_endsB4v258B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5TupleI5ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedExdE5ArrayIdLi1E1C7mutable7alignedExdx5ArrayIxLi1E1C7mutable7alignedE"}
!219 = !{!220}
!220 = distinct !{!220, !221, !"_ZN17bnserve_surrogate6kernel7_places9find_endsB4v258B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5TupleI5ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedExdE5ArrayIdLi1E1C7mutable7alignedExdx5ArrayIxLi1E1C7mutable7alignedE: %retptr"}
!221 = distinct !{!221, !"_ZN17bnserve_surrogate6kernel7_places9find_endsB4v258B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5TupleI5ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedExdE5ArrayIdLi1E1C7mutable7alignedExdx5ArrayIxLi1E1C7mutable7alignedE"}
!222 = !{!223, !225}
!223 = distinct !{!223, !224, !"_ZN17bnserve_surrogate8tangents7_series19fill_tangent_seriesB4v253B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIdLi1E1C7mutable7alignedEd5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!224 = distinct !{!224, !"_ZN17bnserve_surrogate8tangents7_series19fill_tangent_seriesB4v253B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIdLi1E1C7mutable7alignedEd5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!225 = distinct !{!225, !224, !"_ZN17bnserve_surrogate8tangents7_series19fill_tangent_seriesB4v253B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIdLi1E1C7mutable7alignedEd5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %excinfo"}
!226 = !{!227, !229, !223, !225}
!227 = distinct !{!227, !228, !"_ZN17bnserve_surrogate6kernel7_series8legendreB4v252B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dEd5ArrayIdLi2E1C7mutable7alignedE: %retptr"}
!228 = distinct !{!228, !"_ZN17bnserve_surrogate6kernel7_series8legendreB4v252B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dEd5ArrayIdLi2E1C7mutable7alignedE"}
!229 = distinct !{!229, !228, !"_ZN17bnserve_surrogate6kernel7_series8legendreB4v252B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dEd5ArrayIdLi2E1C7mutable7alignedE: %excinfo"}
!230 = !{!231, !223, !225}
!231 = distinct !{!231, !232, !"_ZN17bnserve_surrogate6kernel7_series17fill_phase_powersB4v251B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dEd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!232 = distinct !{!232, !"_ZN17bnserve_surrogate6kernel7_series17fill_phase_powersB4v251B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dEd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!233 = !{!234, !214}
!234 = distinct !{!234, !235, !"_ZN17bnserve_surrogate8tangents7_series17fill_slope_seriesB4v257B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedEdd5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!235 = distinct !{!235, !"_ZN17bnserve_surrogate8tangents7_series17fill_slope_seriesB4v257B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedEdd5ArrayIdLi1E1C7mutable7alignedE"}
!236 = !{!237}
!237 = distinct !{!237, !238, !"_ZN17bnserve_surrogate8baseline10_amplitude22amplitude_coefficientsB4v241B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDAxYh_2bqJnA4AOzNAE_3dEddd5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!238 = distinct !{!238, !"_ZN17bnserve_surrogate8baseline10_amplitude22amplitude_coefficientsB4v241B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDAxYh_2bqJnA4AOzNAE_3dEddd5ArrayIdLi1E1C7mutable7alignedE"}
!239 = !{!240}
!240 = distinct !{!240, !241, !"_ZN17bnserve_surrogate8baseline6_phase18phase_coefficientsB4v244B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDAxYh_2bqJnA4AOzNAE_3dEddddd5ArrayIdLi2E1C7mutable7alignedE: %retptr"}
!241 = distinct !{!241, !"_ZN17bnserve_surrogate8baseline6_phase18phase_coefficientsB4v244B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDAxYh_2bqJnA4AOzNAE_3dEddddd5ArrayIdLi2E1C7mutable7alignedE"}
!242 = !{!243, !240}
!243 = distinct !{!243, !244, !"_ZN17bnserve_surrogate8baseline6_phase20add_point_mass_phaseB4v245B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDAxYh_2bqJnA4AOzNAE_3dEd5ArrayIdLi2E1C7mutable7alignedE: %retptr"}
!244 = distinct !{!244, !"_ZN17bnserve_surrogate8baseline6_phase20add_point_mass_phaseB4v245B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDAxYh_2bqJnA4AOzNAE_3dEd5ArrayIdLi2E1C7mutable7alignedE"}
!245 = !{!246, !240}
!246 = distinct !{!246, !247, !"_ZN17bnserve_surrogate8baseline6_phase20add_spin_orbit_phaseB4v246B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDAxYh_2bqJnA4AOzNAE_3dEdd5ArrayIdLi2E1C7mutable7alignedE: %retptr"}
!247 = distinct !{!247, !"_ZN17bnserve_surrogate8baseline6_phase20add_spin_orbit_phaseB4v246B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDAxYh_2bqJnA4AOzNAE_3dEdd5ArrayIdLi2E1C7mutable7alignedE"}
!248 = !{!249, !240}
!249 = distinct !{!249, !250, !"_ZN17bnserve_surrogate8baseline6_phase20add_spin_orbit_phaseB4v246B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDAxYh_2bqJnA4AOzNAE_3dEdd5ArrayIdLi2E1C7mutable7alignedE: %retptr"}
!250 = distinct !{!250, !"_ZN17bnserve_surrogate8baseline6_phase20add_spin_orbit_phaseB4v246B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDAxYh_2bqJnA4AOzNAE_3dEdd5ArrayIdLi2E1C7mutable7alignedE"}
!251 = !{!252, !240}
!252 = distinct !{!252, !253, !"_ZN17bnserve_surrogate8baseline6_phase19add_self_spin_phaseB4v248B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDAxYh_2bqJnA4AOzNAE_3dEddd5ArrayIdLi2E1C7mutable7alignedE: %retptr"}
!253 = distinct !{!253, !"_ZN17bnserve_surrogate8baseline6_phase19add_self_spin_phaseB4v248B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDAxYh_2bqJnA4AOzNAE_3dEddd5ArrayIdLi2E1C7mutable7alignedE"}
!254 = !{!255, !240}
!255 = distinct !{!255, !256, !"_ZN17bnserve_surrogate8baseline6_phase19add_self_spin_phaseB4v248B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDAxYh_2bqJnA4AOzNAE_3dEddd5ArrayIdLi2E1C7mutable7alignedE: %retptr"}
!256 = distinct !{!256, !"_ZN17bnserve_surrogate8baseline6_phase19add_self_spin_phaseB4v248B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDAxYh_2bqJnA4AOzNAE_3dEddd5ArrayIdLi2E1C7mutable7alignedE"}
!257 = !{!258, !240}
!258 = distinct !{!258, !259, !"_ZN17bnserve_surrogate8baseline6_phase19add_spin_spin_phaseB4v249B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDAxYh_2bqJnA4AOzNAE_3dEddd5ArrayIdLi2E1C7mutable7alignedE: %retptr"}
!259 = distinct !{!259, !"_ZN17bnserve_surrogate8baseline6_phase19add_spin_spin_phaseB4v249B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDAxYh_2bqJnA4AOzNAE_3dEddd5ArrayIdLi2E1C7mutable7alignedE"}
!260 = !{!261, !240}
!261 = distinct !{!261, !262, !"_ZN17bnserve_surrogate8baseline6_phase15add_tidal_phaseB4v250B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDAxYh_2bqJnA4AOzNAE_3dEdd5ArrayIdLi2E1C7mutable7alignedE: %retptr"}
!262 = distinct !{!262, !"_ZN17bnserve_surrogate8baseline6_phase15add_tidal_phaseB4v250B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDAxYh_2bqJnA4AOzNAE_3dEdd5ArrayIdLi2E1C7mutable7alignedE"}
!263 = !{!264, !240}
!264 = distinct !{!264, !265, !"_ZN17bnserve_surrogate8baseline6_phase15add_tidal_phaseB4v250B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDAxYh_2bqJnA4AOzNAE_3dEdd5ArrayIdLi2E1C7mutable7alignedE: %retptr"}
!265 = distinct !{!265, !"_ZN17bnserve_surrogate8baseline6_phase15add_tidal_phaseB4v250B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDAxYh_2bqJnA4AOzNAE_3dEdd5ArrayIdLi2E1C7mutable7alignedE"}
!266 = !{!267, !269}
!267 = distinct !{!267, !268, !"_ZN17bnserve_surrogate6kernel7_series8legendreB4v252B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dEd5ArrayIdLi2E1C7mutable7alignedE: %retptr"}
!268 = distinct !{!268, !"_ZN17bnserve_surrogate6kernel7_series8legendreB4v252B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dEd5ArrayIdLi2E1C7mutable7alignedE"}
!269 = distinct !{!269, !268, !"_ZN17bnserve_surrogate6kernel7_series8legendreB4v252B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dEd5ArrayIdLi2E1C7mutable7alignedE: %excinfo"}
!270 = !{!271}
!271 = distinct !{!271, !272, !"_ZN17bnserve_surrogate6kernel7_series17fill_phase_powersB4v251B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dEd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!272 = distinct !{!272, !"_ZN17bnserve_surrogate6kernel7_series17fill_phase_powersB4v251B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dEd5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!273 = !{!274}
!274 = distinct !{!274, !275, !"_ZN17bnserve_surrogate6kernel11_regression9_productsB3v78B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedExx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!275 = distinct !{!275, !"_ZN17bnserve_surrogate6kernel11_regression9_productsB3v78B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedExx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!276 = !{!277}
!277 = distinct !{!277, !278, !"_ZN17bnserve_surrogate6kernel9_matrices8multiplyB3v82B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIdLi1E1C7mutable7alignedE23Literal_5bint_5d_281_2923Literal_5bint_5d_288_295ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedEx: %retptr"}
!278 = distinct !{!278, !"_ZN17bnserve_surrogate6kernel9_matrices8multiplyB3v82B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIdLi1E1C7mutable7alignedE23Literal_5bint_5d_281_2923Literal_5bint_5d_288_295ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedEx"}
!279 = !{!280}
!280 = distinct !{!280, !281, !"_ZN17bnserve_surrogate6kernel9_matrices8multiplyB3v92B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIdLi1E1C7mutable7alignedEx23Literal_5bint_5d_281_295ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedEx: %retptr"}
!281 = distinct !{!281, !"_ZN17bnserve_surrogate6kernel9_matrices8multiplyB3v92B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIdLi1E1C7mutable7alignedEx23Literal_5bint_5d_281_295ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedEx"}
!282 = !{!283}
!283 = distinct !{!283, !284, !"_ZN17bnserve_surrogate6kernel9_matrices8multiplyB3v92B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIdLi1E1C7mutable7alignedEx23Literal_5bint_5d_281_295ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedEx: %retptr"}
!284 = distinct !{!284, !"_ZN17bnserve_surrogate6kernel9_matrices8multiplyB3v92B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIdLi1E1C7mutable7alignedEx23Literal_5bint_5d_281_295ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedEx"}
!285 = !{!286}
!286 = distinct !{!286, !287, !"_ZN17bnserve_surrogate12_coordinates18transform_physicalB3v67B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDAxYh_2bqJnA4AOzNAE_3dEddddd5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!287 = distinct !{!287, !"_ZN17bnserve_surrogate12_coordinates18transform_physicalB3v67B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDAxYh_2bqJnA4AOzNAE_3dEddddd5ArrayIdLi1E1C7mutable7alignedE"}
!288 = !{!289, !291}
!289 = distinct !{!289, !290, !"_ZN17bnserve_surrogate12_coordinates18transform_physicalB3v69B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDAxYh_2bqJnA4AOzNAE_3dEddddd5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!290 = distinct !{!290, !"_ZN17bnserve_surrogate12_coordinates18transform_physicalB3v69B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDAxYh_2bqJnA4AOzNAE_3dEddddd5ArrayIdLi1E1C7mutable7alignedE"}
!291 = distinct !{!291, !292, !"_ZN17bnserve_surrogate12_coordinates19transform_symmetricB3v68B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDAxYh_2bqJnA4AOzNAE_3dEddddd5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!292 = distinct !{!292, !"_ZN17bnserve_surrogate12_coordinates19transform_symmetricB3v68B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDAxYh_2bqJnA4AOzNAE_3dEddddd5ArrayIdLi1E1C7mutable7alignedE"}
!293 = !{!291}
