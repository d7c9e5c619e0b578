; sources: 7d99e4dec6b91076b814681fbefca005787ecb34da6bc1c28cf8078f49bc9ae3
; built by: numba 0.68.1, llvmlite 0.50.0, Python 3.11, x86_64
; ModuleID = '<string>'
source_filename = "<string>"


; Function Attrs: nofree norecurse nosync nounwind memory(readwrite, inaccessiblemem: none, target_mem0: none, target_mem1: none)
define noundef i32 @bnserve_pull_back(ptr noalias writeonly captures(none) initializes((0, 8)) %retptr, ptr noalias readnone captures(none) %excinfo, ptr readonly captures(none) %arg.arguments) local_unnamed_addr #0 {
entry:
  %.43 = alloca i64, align 8
  store i64 0, ptr %.43, align 8
  call fastcc void @inner_0(ptr nonnull %.43, ptr %arg.arguments)
  store i64 0, ptr %retptr, align 8
  ret i32 0
}

; Function Attrs: mustprogress nocallback nofree nounwind willreturn memory(argmem: write)
declare void @llvm.memset.p0.i64(ptr writeonly captures(none), i8, i64, i1 immarg) #1

; Function Attrs: nofree norecurse nosync nounwind memory(readwrite, inaccessiblemem: none, target_mem0: none, target_mem1: none)
define internal fastcc void @inner_0(ptr noalias nonnull writeonly captures(none) %retptr, ptr readonly captures(none) %arg.arguments.4) unnamed_addr #0 {
entry:
  %.880.i.i140 = alloca double, align 8
  %.747.i = alloca ptr, align 8
  %.782.i = alloca ptr, align 8
  %.690.i = alloca double, align 8
  %.47 = load i64, ptr %arg.arguments.4, align 8
  %.76 = getelementptr i8, ptr %arg.arguments.4, i64 16
  %.77 = load i64, ptr %.76, align 8
  %.106 = getelementptr i8, ptr %arg.arguments.4, i64 8
  %.140 = getelementptr i8, ptr %arg.arguments.4, i64 24
  %.141 = load i64, ptr %.140, align 8
  %.142 = sub i64 0, %.141
  %.150.1 = and i64 %.142, -8
  %.184 = sub i64 0, %.150.1
  %.193 = mul nsw i64 %.47, 44
  %.223 = getelementptr i8, ptr %arg.arguments.4, i64 224
  %.224 = load i64, ptr %.223, align 8
  %.230 = inttoptr i64 %.224 to ptr
  %.363.idx = mul i64 %.47, 200
  %.363 = getelementptr i8, ptr %.230, i64 %.363.idx
  %.430 = getelementptr inbounds double, ptr %.230, i64 %.193
  %.idx = mul i64 %.77, 27648
  %0 = getelementptr i8, ptr %.230, i64 %.idx
  %1 = getelementptr i8, ptr %0, i64 14336
  %.498 = getelementptr double, ptr %1, i64 %.193
  %.586 = getelementptr i8, ptr %.430, i64 12288
  %.683 = getelementptr i8, ptr %arg.arguments.4, i64 120
  %.684 = load i64, ptr %.683, align 8
  %.7641025.not = icmp slt i64 %.684, 1
  br i1 %.7641025.not, label %B1452, label %B666.if.lr.ph

B1212:                                            ; preds = %_ZN17bnserve_inference14adjoint_kernel7_source12_in_detectorB4v112B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxx5ArrayIxLi1E1C7mutable7alignedEd5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit, %_ZN17bnserve_inference14adjoint_kernel7_source9_polariseB3v77B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit
  %.84.i = load i64, ptr %.106, align 8, !noalias !0
  %.114.i = load i64, ptr %.76, align 8, !noalias !0
  %.144.i = load i64, ptr %.140, align 8, !noalias !0
  %.149.i = sub i64 0, %.144.i
  %.157.1.i = and i64 %.149.i, -8
  %.193.i = sub nsw i64 %.144.i, %.1090933952
  %.13.i.i = tail call i64 @llvm.smin.i64(i64 %.193.i, i64 range(i64 -9223372036854775808, 129) %.13.i)
  %.395674.not.i = icmp slt i64 %.84.i, 1
  br i1 %.395674.not.i, label %B420.i, label %B274.if.lr.ph.i

B420.i:                                           ; preds = %_ZN17bnserve_inference14adjoint_kernel5_back10waves_backB4v472B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE.exit.i, %B1212
  %.704.i = load i64, ptr %.703.i, align 8, !noalias !0
  %.705.not.i = icmp eq i64 %.704.i, 0
  %.901703.not.i = icmp slt i64 %.114.i, 1
  %or.cond.i = select i1 %.705.not.i, i1 true, i1 %.901703.not.i
  br i1 %or.cond.i, label %_ZN17bnserve_inference14adjoint_kernel7_source11_block_backB4v460B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit, label %B570.if.lr.ph.i

B872.loopexit.unr-lcssa.i:                        ; preds = %B798.if.i
  br i1 %13, label %B872.i, label %B798.if.epil.preheader.i

B798.if.epil.preheader.i:                         ; preds = %B570.if.i, %B872.loopexit.unr-lcssa.i
  %.1296679681.epil.init.i = phi i64 [ 0, %B570.if.i ], [ %.1303.1.i, %B872.loopexit.unr-lcssa.i ]
  %2 = inttoptr i64 %.979.i to ptr
  %.1335.epil.i = getelementptr inbounds double, ptr %.1141.i, i64 %.1296679681.epil.init.i
  %.1337.epil.i = load <8 x double>, ptr %.1335.epil.i, align 8, !noalias !0
  %.8.i.epil.i = fmul contract <8 x double> %.7.i.i, %.1337.epil.i
  %.1370.epil.i = getelementptr inbounds double, ptr %2, i64 %.1296679681.epil.init.i
  store <8 x double> %.8.i.epil.i, ptr %.1370.epil.i, align 8, !noalias !0
  br label %B872.i

B872.i:                                           ; preds = %B570.if.i, %B798.if.epil.preheader.i, %B872.loopexit.unr-lcssa.i
  %scevgep111.i = getelementptr i8, ptr %lsr.iv.i3, i64 27648
  %exitcond738.not.i = icmp eq i64 %.914.i, %.114.i
  br i1 %exitcond738.not.i, label %_ZN17bnserve_inference14adjoint_kernel7_source11_block_backB4v460B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit, label %B570.if.i

B274.if.lr.ph.i:                                  ; preds = %B1212
  %.261.i = load i64, ptr %.447.i, align 8, !noalias !0
  %3 = shl i64 %.1090933952, 4
  %scevgep121.i = getelementptr i8, ptr %.498, i64 %3
  %4 = lshr i64 %.149.i, 3
  %5 = mul i64 %4, -128
  %6 = inttoptr i64 %.261.i to ptr
  %.949889.not.i.i = icmp slt i64 %.13.i.i, 1
  br label %B274.if.i

B274.if.i:                                        ; preds = %_ZN17bnserve_inference14adjoint_kernel5_back10waves_backB4v472B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE.exit.i, %B274.if.lr.ph.i
  %lsr.iv122.i = phi ptr [ %scevgep121.i, %B274.if.lr.ph.i ], [ %scevgep123.i, %_ZN17bnserve_inference14adjoint_kernel5_back10waves_backB4v472B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE.exit.i ]
  %.401671675.i = phi i64 [ 0, %B274.if.lr.ph.i ], [ %.408.i, %_ZN17bnserve_inference14adjoint_kernel5_back10waves_backB4v472B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE.exit.i ]
  %7 = shl i64 %.401671675.i, 3
  %scevgep120.i = getelementptr i8, ptr %6, i64 %7
  %.533.i = load i64, ptr %scevgep120.i, align 8, !noalias !0
  %.idx658.i = mul i64 %.533.i, 27648
  %8 = getelementptr i8, ptr %.430, i64 %.idx658.i
  %.555.i = getelementptr i8, ptr %8, i64 14336
  %.74.i.i = load i64, ptr %.106, align 8, !noalias !3
  %.133.i.i = load i64, ptr %.268.i, align 8, !noalias !3
  %.134.i.i = mul nsw i64 %.74.i.i, %.7709701030
  %.135.i.i = add nsw i64 %.134.i.i, %.401671675.i
  %.136.i.i = shl nsw i64 %.135.i.i, 3
  %.137.i.i = add nsw i64 %.136.i.i, %.133.i.i
  %.138.i.i = inttoptr i64 %.137.i.i to ptr
  %.216.i.i = load double, ptr %.138.i.i, align 8, !noalias !3
  %.431.i.i = load i64, ptr %.430.i.i, align 8, !noalias !3
  br i1 %.949889.not.i.i, label %_ZN17bnserve_inference14adjoint_kernel5_back10waves_backB4v472B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE.exit.i, label %B724.if.lr.ph.i.i

B724.if.lr.ph.i.i:                                ; preds = %B274.if.i
  %.255.i.i = shl nsw i64 %.135.i.i, 4
  %.252.i.i = load i64, ptr %.357.i, align 8, !noalias !3
  %.340.i.i = load i64, ptr %.172.i, align 8, !noalias !3
  %.103.i.i = load i64, ptr %.140, align 8, !noalias !3
  %.343.i.i = mul nsw i64 %.103.i.i, %.135.i.i
  %.344.i.i = add nsw i64 %.343.i.i, %.1090933952
  %.345.i.i = shl nsw i64 %.344.i.i, 4
  %.346.i.i = add nsw i64 %.345.i.i, %.340.i.i
  %9 = inttoptr i64 %.346.i.i to ptr
  %scevgep110.i.i = getelementptr i8, ptr %9, i64 8
  %sunkaddr13.i.i = inttoptr i64 %.252.i.i to ptr
  %sunkaddr14.i.i = getelementptr i8, ptr %sunkaddr13.i.i, i64 %.255.i.i
  %sunkaddr21.i.i = getelementptr i8, ptr %sunkaddr14.i.i, i64 8
  br label %B724.if.i.i

B724.if.i.i:                                      ; preds = %B724.if.i.i, %B724.if.lr.ph.i.i
  %lsr.iv114.i.i = phi i64 [ %.13.i.i, %B724.if.lr.ph.i.i ], [ %lsr.iv.next115.i.i, %B724.if.i.i ]
  %lsr.iv.i.i = phi i64 [ 0, %B724.if.lr.ph.i.i ], [ %lsr.iv.next.i.i, %B724.if.i.i ]
  %d.2.0895.i.i = phi double [ 0.000000e+00, %B724.if.lr.ph.i.i ], [ %.1691.i.i, %B724.if.i.i ]
  %c.2.0894.i.i = phi double [ 0.000000e+00, %B724.if.lr.ph.i.i ], [ %.1624.i.i, %B724.if.i.i ]
  %b.2.0893.i.i = phi double [ 0.000000e+00, %B724.if.lr.ph.i.i ], [ %.1557.i.i, %B724.if.i.i ]
  %a.2.0892.i.i = phi double [ 0.000000e+00, %B724.if.lr.ph.i.i ], [ %.1490.i.i, %B724.if.i.i ]
  %10 = shl nuw i64 %lsr.iv.i.i, 1
  %scevgep112.i.i = getelementptr i8, ptr %scevgep110.i.i, i64 %10
  %scevgep113.i.i = getelementptr i8, ptr %scevgep112.i.i, i64 -8
  %.1017.i.i = load double, ptr %scevgep113.i.i, align 8, !noalias !3
  %.1049.i.i = load double, ptr %scevgep112.i.i, align 8, !noalias !3
  %sunkaddr.i.i = getelementptr i8, ptr %.555.i, i64 %lsr.iv.i.i
  %sunkaddr12.i.i = getelementptr i8, ptr %sunkaddr.i.i, i64 22528
  %.1079.i.i = load double, ptr %sunkaddr12.i.i, align 8, !noalias !3
  %.1081.i.i = fmul contract double %.216.i.i, %.1079.i.i
  %.1111.i.i = load double, ptr %sunkaddr14.i.i, align 8, !noalias !3
  %sunkaddr18.i.i = getelementptr i8, ptr %sunkaddr.i.i, i64 24576
  %.1141.i.i = load double, ptr %sunkaddr18.i.i, align 8, !noalias !3
  %.1142.i.i = fmul contract double %.1111.i.i, %.1141.i.i
  %.1143.i.i = fadd contract double %.1081.i.i, %.1142.i.i
  %.1173.i.i = load double, ptr %sunkaddr21.i.i, align 8, !noalias !3
  %sunkaddr24.i.i = getelementptr i8, ptr %sunkaddr.i.i, i64 25600
  %.1203.i.i = load double, ptr %sunkaddr24.i.i, align 8, !noalias !3
  %.1204.i.i = fmul contract double %.1173.i.i, %.1203.i.i
  %.1205.i.i = fsub contract double %.1143.i.i, %.1204.i.i
  %sunkaddr26.i.i = getelementptr i8, ptr %lsr.iv122.i, i64 %10
  store double %.1205.i.i, ptr %sunkaddr26.i.i, align 8, !noalias !3
  %sunkaddr28.i.i = getelementptr i8, ptr %sunkaddr.i.i, i64 23552
  %.1266.i.i = load double, ptr %sunkaddr28.i.i, align 8, !noalias !3
  %.1268.i.i = fmul contract double %.216.i.i, %.1266.i.i
  %.1298.i.i = load double, ptr %sunkaddr14.i.i, align 8, !noalias !3
  %.1328.i.i = load double, ptr %sunkaddr24.i.i, align 8, !noalias !3
  %.1329.i.i = fmul contract double %.1298.i.i, %.1328.i.i
  %.1330.i.i = fadd contract double %.1268.i.i, %.1329.i.i
  %.1360.i.i = load double, ptr %sunkaddr21.i.i, align 8, !noalias !3
  %.1390.i.i = load double, ptr %sunkaddr18.i.i, align 8, !noalias !3
  %.1391.i.i = fmul contract double %.1360.i.i, %.1390.i.i
  %.1392.i.i = fadd contract double %.1330.i.i, %.1391.i.i
  %.1393.i.i = fneg contract double %.1392.i.i
  %sunkaddr31.i.i = getelementptr i8, ptr %sunkaddr26.i.i, i64 8
  store double %.1393.i.i, ptr %sunkaddr31.i.i, align 8, !noalias !3
  %.1455.i.i = load double, ptr %sunkaddr12.i.i, align 8, !noalias !3
  %.1456.i.i = fmul contract double %.1017.i.i, %.1455.i.i
  %.1486.i.i = load double, ptr %sunkaddr28.i.i, align 8, !noalias !3
  %.1487.i.i = fmul contract double %.1049.i.i, %.1486.i.i
  %.1488.i.i = fsub contract double %.1456.i.i, %.1487.i.i
  %.1490.i.i = fadd contract double %a.2.0892.i.i, %.1488.i.i
  %.1523.i.i = fmul contract double %.1049.i.i, %.1455.i.i
  %.1554.i.i = fmul contract double %.1017.i.i, %.1486.i.i
  %.1555.i.i = fadd contract double %.1523.i.i, %.1554.i.i
  %.1557.i.i = fadd contract double %b.2.0893.i.i, %.1555.i.i
  %.1589.i.i = load double, ptr %sunkaddr18.i.i, align 8, !noalias !3
  %.1590.i.i = fmul contract double %.1017.i.i, %.1589.i.i
  %.1620.i.i = load double, ptr %sunkaddr24.i.i, align 8, !noalias !3
  %.1621.i.i = fmul contract double %.1049.i.i, %.1620.i.i
  %.1622.i.i = fsub contract double %.1590.i.i, %.1621.i.i
  %.1624.i.i = fadd contract double %c.2.0894.i.i, %.1622.i.i
  %.1657.i.i = fmul contract double %.1049.i.i, %.1589.i.i
  %.1688.i.i = fmul contract double %.1017.i.i, %.1620.i.i
  %.1689.i.i = fadd contract double %.1657.i.i, %.1688.i.i
  %.1691.i.i = fadd contract double %d.2.0895.i.i, %.1689.i.i
  %lsr.iv.next.i.i = add nuw nsw i64 %lsr.iv.i.i, 8
  %lsr.iv.next115.i.i = add i64 %lsr.iv114.i.i, -1
  %exitcond.not.i.i = icmp eq i64 %lsr.iv.next115.i.i, 0
  br i1 %exitcond.not.i.i, label %_ZN17bnserve_inference14adjoint_kernel5_back10waves_backB4v472B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE.exit.i, label %B724.if.i.i

_ZN17bnserve_inference14adjoint_kernel5_back10waves_backB4v472B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE.exit.i: ; preds = %B724.if.i.i, %B274.if.i
  %a.2.0.lcssa.i.i = phi double [ 0.000000e+00, %B274.if.i ], [ %.1490.i.i, %B724.if.i.i ]
  %b.2.0.lcssa.i.i = phi double [ 0.000000e+00, %B274.if.i ], [ %.1557.i.i, %B724.if.i.i ]
  %c.2.0.lcssa.i.i = phi double [ 0.000000e+00, %B274.if.i ], [ %.1624.i.i, %B724.if.i.i ]
  %d.2.0.lcssa.i.i = phi double [ 0.000000e+00, %B274.if.i ], [ %.1691.i.i, %B724.if.i.i ]
  %.437.i.i = shl nsw i64 %.135.i.i, 5
  %.438.i.i = add nsw i64 %.431.i.i, %.437.i.i
  %.439.i.i = inttoptr i64 %.438.i.i to ptr
  %.1765.i.i = load double, ptr %.439.i.i, align 8, !noalias !3
  %.1767.i.i = fadd contract double %a.2.0.lcssa.i.i, %.1765.i.i
  store double %.1767.i.i, ptr %.439.i.i, align 8, !noalias !3
  %.1828.i.i = getelementptr i8, ptr %.439.i.i, i64 8
  %.1829.i.i = load double, ptr %.1828.i.i, align 8, !noalias !3
  %.1831.i.i = fadd contract double %b.2.0.lcssa.i.i, %.1829.i.i
  store double %.1831.i.i, ptr %.1828.i.i, align 8, !noalias !3
  %.1892.i.i = getelementptr i8, ptr %.439.i.i, i64 16
  %.1893.i.i = load double, ptr %.1892.i.i, align 8, !noalias !3
  %.1895.i.i = fadd contract double %c.2.0.lcssa.i.i, %.1893.i.i
  store double %.1895.i.i, ptr %.1892.i.i, align 8, !noalias !3
  %.1956.i.i = getelementptr i8, ptr %.439.i.i, i64 24
  %.1957.i.i = load double, ptr %.1956.i.i, align 8, !noalias !3
  %.1959.i.i = fadd contract double %d.2.0.lcssa.i.i, %.1957.i.i
  store double %.1959.i.i, ptr %.1956.i.i, align 8, !noalias !3
  %.408.i = add nuw nsw i64 %.401671675.i, 1
  %scevgep123.i = getelementptr i8, ptr %lsr.iv122.i, i64 %5
  %exitcond.not.i1 = icmp eq i64 %.84.i, %.408.i
  br i1 %exitcond.not.i1, label %B420.i, label %B274.if.i

B570.if.lr.ph.i:                                  ; preds = %B420.i
  %.737.i = load i64, ptr %.736.i, align 8, !noalias !0
  %.738.i = inttoptr i64 %.737.i to ptr
  %.813.i = getelementptr i8, ptr %.738.i, i64 8
  %.814.i = load double, ptr %.813.i, align 8, !noalias !0
  %.972.i = mul nuw nsw i64 %.114.i, %.7709701030
  %.1269.i = lshr exact i64 %.13.i, 3
  %.1248.inv.i = icmp sgt i64 %.1127, 0
  %storemerge657.i = select i1 %.1248.inv.i, i64 %.1269.i, i64 0
  %.6.i.i = insertelement <8 x double> poison, double %.814.i, i64 0
  %.7.i.i = shufflevector <8 x double> %.6.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %11 = and i64 %storemerge657.i, 2305843009213693950
  %trunc.i = trunc nuw i64 %storemerge657.i to i61
  %12 = and i64 %storemerge657.i, 1
  %13 = icmp eq i64 %12, 0
  br label %B570.if.i

B570.if.i:                                        ; preds = %B570.if.lr.ph.i, %B872.i
  %lsr.iv.i3 = phi ptr [ %scevgep.i2, %B570.if.lr.ph.i ], [ %scevgep111.i, %B872.i ]
  %.907689706.i = phi i64 [ 0, %B570.if.lr.ph.i ], [ %.914.i, %B872.i ]
  %.914.i = add nuw nsw i64 %.907689706.i, 1
  %.969.i = load i64, ptr %.703.i, align 8, !noalias !0
  %.973.i = add nuw nsw i64 %.907689706.i, %.972.i
  %14 = mul i64 %.973.i, %.157.1.i
  %.977.i = sub i64 %.1090933952, %14
  %.978.i = shl nsw i64 %.977.i, 3
  %.979.i = add nsw i64 %.978.i, %.969.i
  %.idx.i = mul i64 %.907689706.i, 27648
  %15 = getelementptr i8, ptr %.430, i64 %.idx.i
  %.1141.i = getelementptr i8, ptr %15, i64 40960
  switch i61 %trunc.i, label %B798.if.preheader.i [
    i61 0, label %B872.i
    i61 1, label %B798.if.epil.preheader.i
  ]

B798.if.preheader.i:                              ; preds = %B570.if.i
  %16 = inttoptr i64 %.979.i to ptr
  %scevgep115.i = getelementptr i8, ptr %16, i64 64
  br label %B798.if.i

B798.if.i:                                        ; preds = %B798.if.i, %B798.if.preheader.i
  %lsr.iv8.i = phi i64 [ %lsr.iv.next.i4, %B798.if.i ], [ %11, %B798.if.preheader.i ]
  %.1296679681.i = phi i64 [ %.1303.1.i, %B798.if.i ], [ 0, %B798.if.preheader.i ]
  %17 = shl i64 %.1296679681.i, 3
  %scevgep113.i = getelementptr i8, ptr %lsr.iv.i3, i64 %17
  %scevgep114.i = getelementptr i8, ptr %scevgep113.i, i64 -64
  %.1337.i = load <8 x double>, ptr %scevgep114.i, align 8, !noalias !0
  %.8.i.i = fmul contract <8 x double> %.7.i.i, %.1337.i
  %scevgep117.i = getelementptr i8, ptr %scevgep115.i, i64 %17
  %scevgep11.i = getelementptr i8, ptr %scevgep117.i, i64 -64
  store <8 x double> %.8.i.i, ptr %scevgep11.i, align 8, !noalias !0
  %.1337.1.i = load <8 x double>, ptr %scevgep113.i, align 8, !noalias !0
  %.8.i.1.i = fmul contract <8 x double> %.7.i.i, %.1337.1.i
  %.1303.1.i = add i64 %.1296679681.i, 16
  store <8 x double> %.8.i.1.i, ptr %scevgep117.i, align 8, !noalias !0
  %lsr.iv.next.i4 = add i64 %lsr.iv8.i, -2
  %niter.ncmp.1.not.i = icmp eq i64 %lsr.iv.next.i4, 0
  br i1 %niter.ncmp.1.not.i, label %B872.loopexit.unr-lcssa.i, label %B798.if.i

_ZN17bnserve_inference14adjoint_kernel7_source11_block_backB4v460B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit: ; preds = %B872.i, %B420.i
  %.1084 = icmp sgt i64 %.1083927953, 1
  br i1 %.1084, label %B918.if, label %B1254

B1254:                                            ; preds = %_ZN17bnserve_inference14adjoint_kernel7_source11_block_backB4v460B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit, %_ZN17bnserve_inference13moving_kernel8_passing12find_passingB3v59B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIxLi1E1C7mutable7alignedE.exit
  %.74.i = load i64, ptr %sunkaddr115, align 8, !noalias !6
  %.75.i = inttoptr i64 %.74.i to ptr
  %.152.i = getelementptr i8, ptr %.75.i, i64 8
  %.153.i = load double, ptr %.152.i, align 8, !noalias !6
  %.275.i = load i64, ptr %arg.arguments.4, align 8, !noalias !6
  %.358494.not.i = icmp slt i64 %.275.i, 1
  br i1 %.358494.not.i, label %B1254.endif, label %B244.if.lr.ph.i

B244.if.lr.ph.i:                                  ; preds = %B1254
  %.189.i = load i64, ptr %sunkaddr, align 8, !noalias !6
  %.191.i = mul nuw nsw i64 %.7709701030, 80
  %sunkaddr.i = inttoptr i64 %.189.i to ptr
  %sunkaddr62.i = getelementptr i8, ptr %sunkaddr.i, i64 %.191.i
  %sunkaddr63.i = getelementptr i8, ptr %sunkaddr62.i, i64 48
  %sunkaddr66.i = getelementptr i8, ptr %sunkaddr62.i, i64 56
  %sunkaddr69.i = getelementptr i8, ptr %sunkaddr62.i, i64 64
  %sunkaddr72.i = getelementptr i8, ptr %sunkaddr62.i, i64 72
  %sunkaddr63.promoted.i = load double, ptr %sunkaddr63.i, align 8, !noalias !6
  %sunkaddr66.promoted.i = load double, ptr %sunkaddr66.i, align 8, !noalias !6
  %sunkaddr69.promoted.i = load double, ptr %sunkaddr69.i, align 8, !noalias !6
  %sunkaddr72.promoted.i = load double, ptr %sunkaddr72.i, align 8, !noalias !6
  br label %B244.if.i

B244.if.i:                                        ; preds = %B244.if.i, %B244.if.lr.ph.i
  %.9954.i = phi double [ %sunkaddr72.promoted.i, %B244.if.lr.ph.i ], [ %.995.i, %B244.if.i ]
  %.9313.i = phi double [ %sunkaddr69.promoted.i, %B244.if.lr.ph.i ], [ %.931.i, %B244.if.i ]
  %.8382.i = phi double [ %sunkaddr66.promoted.i, %B244.if.lr.ph.i ], [ %.838.i, %B244.if.i ]
  %.7771.i = phi double [ %sunkaddr63.promoted.i, %B244.if.lr.ph.i ], [ %.777.i, %B244.if.i ]
  %lsr.iv61.i = phi i64 [ %.275.i, %B244.if.lr.ph.i ], [ %lsr.iv.next.i, %B244.if.i ]
  %lsr.iv59.i = phi ptr [ %scevgep58.i, %B244.if.lr.ph.i ], [ %scevgep60.i, %B244.if.i ]
  %lsr.iv.i = phi ptr [ %scevgep.i, %B244.if.lr.ph.i ], [ %scevgep51.i, %B244.if.i ]
  %.556.i = load double, ptr %lsr.iv.i, align 8, !noalias !6
  %scevgep52.i = getelementptr i8, ptr %lsr.iv.i, i64 -24
  %.585.i = load double, ptr %scevgep52.i, align 8, !noalias !6
  %.614.i = load double, ptr %lsr.iv59.i, align 8, !noalias !6
  %.618.i = fmul contract double %.556.i, %.614.i
  %.619.i = fadd contract double %.585.i, %.618.i
  %scevgep53.i = getelementptr i8, ptr %lsr.iv.i, i64 -16
  %.648.i = load double, ptr %scevgep53.i, align 8, !noalias !6
  %scevgep54.i = getelementptr i8, ptr %lsr.iv.i, i64 -64
  %.677.i = load double, ptr %scevgep54.i, align 8, !noalias !6
  %.678.i = fmul contract double %.556.i, %.677.i
  %.679.i = fadd contract double %.648.i, %.678.i
  %scevgep55.i = getelementptr i8, ptr %lsr.iv.i, i64 -32
  %.709.i = load double, ptr %scevgep55.i, align 8, !noalias !6
  %.711.i = fmul contract double %.153.i, %.709.i
  %.712.i = fmul contract double %.619.i, %.711.i
  %.713.i = fadd contract double %.679.i, %.712.i
  %scevgep56.i = getelementptr i8, ptr %lsr.iv.i, i64 -40
  %.742.i = load double, ptr %scevgep56.i, align 8, !noalias !6
  %.744.i = fmul contract double %.153.i, %.742.i
  %.745.i = fmul contract double %.619.i, %.744.i
  %.746.i = fadd contract double %.619.i, %.745.i
  %.777.i = fsub contract double %.7771.i, %.746.i
  store double %.777.i, ptr %sunkaddr63.i, align 8, !noalias !6
  %.838.i = fadd contract double %.8382.i, %.713.i
  store double %.838.i, ptr %sunkaddr66.i, align 8, !noalias !6
  %scevgep57.i = getelementptr i8, ptr %lsr.iv.i, i64 -8
  %.927.i = load double, ptr %scevgep57.i, align 8, !noalias !6
  %.931.i = fadd contract double %.9313.i, %.927.i
  store double %.931.i, ptr %sunkaddr69.i, align 8, !noalias !6
  %.993.i = fmul contract double %.153.i, %.746.i
  %.994.i = fadd contract double %.556.i, %.993.i
  %.995.i = fadd contract double %.9954.i, %.994.i
  store double %.995.i, ptr %sunkaddr72.i, align 8, !noalias !6
  %scevgep51.i = getelementptr i8, ptr %lsr.iv.i, i64 152
  %scevgep60.i = getelementptr i8, ptr %lsr.iv59.i, i64 200
  %lsr.iv.next.i = add i64 %lsr.iv61.i, -1
  %exitcond.not.i = icmp eq i64 %lsr.iv.next.i, 0
  br i1 %exitcond.not.i, label %B1254.endif, label %B244.if.i

B1334:                                            ; preds = %B1254.endif
  %.1639 = load i64, ptr %.193.i58, align 8
  %.1640 = icmp eq i64 %.1639, 0
  br i1 %.1640, label %B1378, label %B1412

B1378:                                            ; preds = %B1334
  %.64.i = load i64, ptr %.76, align 8, !noalias !9
  %.94.i = load i64, ptr %.140, align 8, !noalias !9
  %.124.i = load i64, ptr %.106, align 8, !noalias !9
  %.133.i = sub i64 0, %.94.i
  %.141.1.i = and i64 %.133.i, -8
  %.175.i = sub i64 0, %.141.1.i
  %.216.i = shl i64 %.94.i, 1
  %.390.i = load i64, ptr %.389.i, align 8, !noalias !9
  %.393.i = inttoptr i64 %.390.i to ptr
  %.518.i = getelementptr double, ptr %.393.i, i64 %.175.i
  %.667832.not.i = icmp slt i64 %.64.i, 1
  br i1 %.667832.not.i, label %B1412, label %B474.if.lr.ph.i

B1068.i:                                          ; preds = %_ZN17bnserve_inference14adjoint_kernel8_passing10_turn_backB4v501B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedExx8UniTupleIdLi3EE5ArrayIdLi1E1C7mutable7alignedE.exit.i, %B474.if.i
  %exitcond868.not.i = icmp eq i64 %.680.i, %.64.i
  br i1 %exitcond868.not.i, label %B1412, label %B474.if.i

B474.if.lr.ph.i:                                  ; preds = %B1378
  %.305.i = load i64, ptr %.304.i, align 8, !noalias !9
  %.210.i = shl i64 %.7709701030, 4
  %.212.i = mul i64 %.210.i, %.94.i
  %.214.i = mul i64 %.212.i, %.124.i
  %.209.i = load i64, ptr %.208.i, align 8, !noalias !9
  %.215.i = add nsw i64 %.209.i, %.214.i
  %.740.i = shl i64 %.175.i, 4
  %.973.i5 = mul nuw nsw i64 %.64.i, %.7709701030
  %.976.i = shl i64 %.175.i, 3
  %18 = tail call i64 @llvm.smax.i64(i64 %.94.i, i64 1)
  %19 = shl i64 %.133.i, 3
  %20 = and i64 %19, -64
  %21 = sub i64 8, %20
  %22 = icmp sgt i64 %.94.i, 1
  %23 = inttoptr i64 %.305.i to ptr
  %24 = inttoptr i64 %.215.i to ptr
  %.187.i.i = icmp sgt i64 %.124.i, 0
  %.218.i = shl i64 %.124.i, 3
  %25 = mul i64 %.218.i, %.216.i
  %26 = add i64 %25, 16
  %27 = add i64 %25, 24
  %28 = or disjoint i64 %25, 8
  %.699491.not.i.i = icmp slt i64 %.124.i, 1
  %29 = shl i64 %.94.i, 4
  %30 = lshr i64 %.133.i, 3
  %31 = mul i64 %30, -128
  br label %B474.if.i

B474.if.i:                                        ; preds = %B474.if.lr.ph.i, %B1068.i
  %.673815835.i = phi i64 [ 0, %B474.if.lr.ph.i ], [ %.680.i, %B1068.i ]
  %.680.i = add nuw nsw i64 %.673815835.i, 1
  br i1 %22, label %B766.if.preheader.i, label %B1068.i

B766.if.preheader.i:                              ; preds = %B474.if.i
  %.970.i = load i64, ptr %sunkaddr136, align 8, !noalias !9
  %.975.i = add nuw nsw i64 %.673815835.i, %.973.i5
  %.978.i6 = mul i64 %.976.i, %.975.i
  %.979.i7 = add nsw i64 %.970.i, %.978.i6
  %.738.i8 = load i64, ptr %sunkaddr27.i, align 8, !noalias !9
  %.742.i9 = mul i64 %.740.i, %.673815835.i
  %.743.i = add nsw i64 %.738.i8, %.742.i9
  %32 = inttoptr i64 %.979.i7 to ptr
  %33 = inttoptr i64 %.743.i to ptr
  %scevgep.i10 = getelementptr i8, ptr %32, i64 8
  %scevgep139.i = getelementptr i8, ptr %33, i64 %21
  br label %B766.if.i

B766.if.i:                                        ; preds = %_ZN17bnserve_inference14adjoint_kernel8_passing10_turn_backB4v501B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedExx8UniTupleIdLi3EE5ArrayIdLi1E1C7mutable7alignedE.exit.i, %B766.if.preheader.i
  %.1122805807.i = phi i64 [ %48, %_ZN17bnserve_inference14adjoint_kernel8_passing10_turn_backB4v501B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedExx8UniTupleIdLi3EE5ArrayIdLi1E1C7mutable7alignedE.exit.i ], [ 0, %B766.if.preheader.i ]
  %sunkaddr28.i = shl i64 %.1122805807.i, 3
  %sunkaddr29.i = getelementptr i8, ptr %33, i64 %sunkaddr28.i
  %sunkaddr30.i = getelementptr i8, ptr %sunkaddr29.i, i64 8
  %.1184.i = load double, ptr %sunkaddr30.i, align 8, !noalias !9
  %.1214.i = load double, ptr %sunkaddr29.i, align 8, !noalias !9
  %.1215.i = fmul contract double %.1184.i, %.1214.i
  %scevgep22.i = getelementptr i8, ptr %scevgep139.i, i64 %sunkaddr28.i
  %.1246.i = load double, ptr %scevgep22.i, align 8, !noalias !9
  %scevgep21.i = getelementptr i8, ptr %scevgep22.i, i64 -8
  %.1276.i = load double, ptr %scevgep21.i, align 8, !noalias !9
  %.1277.i = fmul contract double %.1246.i, %.1276.i
  %.1278.i = fadd contract double %.1215.i, %.1277.i
  %.1340.i = fmul contract double %.1184.i, %.1276.i
  %.1402.i = fmul contract double %.1214.i, %.1246.i
  %.1403.i = fsub contract double %.1340.i, %.1402.i
  %scevgep18.i = getelementptr i8, ptr %.393.i, i64 %sunkaddr28.i
  %scevgep19.i = getelementptr i8, ptr %scevgep18.i, i64 8
  %.1434.i = load double, ptr %scevgep19.i, align 8, !noalias !9
  %scevgep16.i = getelementptr i8, ptr %scevgep.i10, i64 %sunkaddr28.i
  %.1465.i = load double, ptr %scevgep16.i, align 8, !noalias !9
  %.1466.i = fmul contract double %.1434.i, %.1465.i
  %scevgep17.i = getelementptr i8, ptr %.518.i, i64 %sunkaddr28.i
  %.1496.i = load double, ptr %scevgep17.i, align 8, !noalias !9
  %scevgep13.i = getelementptr i8, ptr %scevgep16.i, i64 -8
  %.1526.i = load double, ptr %scevgep13.i, align 8, !noalias !9
  %.1527.i = fmul contract double %.1496.i, %.1526.i
  %.1528.i = fadd contract double %.1466.i, %.1527.i
  %.1529.i = fneg contract double %.1528.i
  br i1 %.187.i.i, label %B106.if.lr.ph.i.i, label %B242.i.i

B106.if.lr.ph.i.i:                                ; preds = %B766.if.i
  %.328.i.i = shl nuw i64 %.1122805807.i, 1
  br label %B106.if.i.i

B134.i.i:                                         ; preds = %B106.if.i.i
  %.343.i.i15 = icmp slt i64 %lsr.iv23.i.i, -2
  %34 = shl i64 %lsr.iv23.i.i, 3
  %35 = select i1 %.343.i.i15, i64 %26, i64 16
  %scevgep41.i.i = getelementptr i8, ptr %24, i64 %35
  %scevgep42.i.i = getelementptr i8, ptr %scevgep41.i.i, i64 %34
  %.359.i.i = load double, ptr %scevgep42.i.i, align 8, !noalias !12
  %.375.i.i = icmp slt i64 %lsr.iv23.i.i, -3
  %36 = select i1 %.375.i.i, i64 %27, i64 24
  %scevgep39.i.i = getelementptr i8, ptr %24, i64 %36
  %scevgep30.i.i = getelementptr i8, ptr %scevgep39.i.i, i64 %34
  %.391.i.i = load double, ptr %scevgep30.i.i, align 8, !noalias !12
  %.406.i.i = icmp slt i64 %lsr.iv23.i.i, 0
  %37 = select i1 %.406.i.i, i64 %28, i64 8
  %scevgep27.i.i = getelementptr i8, ptr %24, i64 %37
  %scevgep28.i.i = getelementptr i8, ptr %scevgep27.i.i, i64 %34
  %scevgep29.i.i = getelementptr i8, ptr %scevgep28.i.i, i64 -8
  %.422.i.i = load double, ptr %scevgep29.i.i, align 8, !noalias !12
  %.454.i.i = load double, ptr %scevgep28.i.i, align 8, !noalias !12
  %.458.i.i = fmul contract double %.359.i.i, %.422.i.i
  %.459.i.i = fmul contract double %.391.i.i, %.454.i.i
  %.460.i.i = fadd contract double %.458.i.i, %.459.i.i
  %.461.i.i = fmul contract double %.391.i.i, %.422.i.i
  %.462.i.i = fmul contract double %.359.i.i, %.454.i.i
  %.463.i.i = fsub contract double %.461.i.i, %.462.i.i
  %.464.i.i = fmul contract double %.1278.i, %.460.i.i
  %.465.i.i = fmul contract double %.1403.i, %.463.i.i
  %.466.i.i = fsub contract double %.464.i.i, %.465.i.i
  %.467.i.i = fmul contract double %.1403.i, %.460.i.i
  %.468.i.i = fmul contract double %.1278.i, %.463.i.i
  %.469.i.i = fadd contract double %.467.i.i, %.468.i.i
  %.490.i.i = fmul contract double %.466.i.i, %.466.i.i
  %.491.i.i = fmul contract double %.469.i.i, %.469.i.i
  %.492.i.i = fsub contract double %.490.i.i, %.491.i.i
  %.494.i.i = fadd contract double %real.3.0484.i.i, %.492.i.i
  %.499.i.i = fmul contract double %.466.i.i, 2.000000e+00
  %.500.i.i = fmul contract double %.469.i.i, %.499.i.i
  %.502.i.i = fadd contract double %imaginary.3.0485.i.i, %.500.i.i
  br label %B240.i.i

B240.i.i:                                         ; preds = %B106.if.i.i, %B134.i.i
  %real.4.1.i.i = phi double [ %.494.i.i, %B134.i.i ], [ %real.3.0484.i.i, %B106.if.i.i ]
  %imaginary.4.1.i.i = phi double [ %.502.i.i, %B134.i.i ], [ %imaginary.3.0485.i.i, %B106.if.i.i ]
  %lsr.iv.next24.i.i = add i64 %lsr.iv23.i.i, %.216.i
  %exitcond.not.i.i14 = icmp eq i64 %.124.i, %.244.i.i
  br i1 %exitcond.not.i.i14, label %B242.i.i, label %B106.if.i.i

B242.i.i:                                         ; preds = %B240.i.i, %B766.if.i
  %real.3.0.lcssa.i.i = phi double [ 0.000000e+00, %B766.if.i ], [ %real.4.1.i.i, %B240.i.i ]
  %imaginary.3.0.lcssa.i.i = phi double [ 0.000000e+00, %B766.if.i ], [ %imaginary.4.1.i.i, %B240.i.i ]
  %.526.i.i = tail call contract double @llvm.fabs.f64(double %real.3.0.lcssa.i.i)
  %.528.i.i = tail call contract double @llvm.fabs.f64(double %imaginary.3.0.lcssa.i.i)
  %.12.i.i.i = fcmp contract ogt double %.528.i.i, %.526.i.i
  %.13.i.i.i = select i1 %.12.i.i.i, double %.528.i.i, double %.526.i.i
  %.561.i.i = fcmp contract ogt double %.13.i.i.i, 0.000000e+00
  br i1 %.561.i.i, label %B338.endif.i.i, label %_ZN17bnserve_inference14adjoint_kernel8_passing10_turn_backB4v501B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedExx8UniTupleIdLi3EE5ArrayIdLi1E1C7mutable7alignedE.exit.i

B452.i.i:                                         ; preds = %B342.if.i.i
  %.801.i.i = icmp slt i64 %lsr.iv.i.i12, -2
  %38 = select i1 %.801.i.i, i64 %26, i64 16
  %39 = getelementptr i8, ptr %lsr.iv3.i.i, i64 %46
  %scevgep24.i.i = getelementptr i8, ptr %39, i64 %38
  %.817.i.i = load double, ptr %scevgep24.i.i, align 8, !noalias !12
  %.833.i.i = icmp slt i64 %lsr.iv.i.i12, -3
  %40 = select i1 %.833.i.i, i64 %27, i64 24
  %scevgep23.i.i = getelementptr i8, ptr %39, i64 %40
  %.849.i.i = load double, ptr %scevgep23.i.i, align 8, !noalias !12
  %.864.i.i = icmp slt i64 %lsr.iv.i.i12, 0
  %41 = select i1 %.864.i.i, i64 %28, i64 8
  %scevgep21.i.i = getelementptr i8, ptr %39, i64 %41
  %scevgep19.i.i = getelementptr i8, ptr %scevgep21.i.i, i64 -8
  %.880.i.i = load double, ptr %scevgep19.i.i, align 8, !noalias !12
  %.912.i.i = load double, ptr %scevgep21.i.i, align 8, !noalias !12
  %.916.i.i = fmul contract double %.817.i.i, %.880.i.i
  %.917.i.i = fmul contract double %.849.i.i, %.912.i.i
  %.918.i.i = fadd contract double %.916.i.i, %.917.i.i
  %.919.i.i = fmul contract double %.849.i.i, %.880.i.i
  %.920.i.i = fmul contract double %.817.i.i, %.912.i.i
  %.921.i.i = fsub contract double %.919.i.i, %.920.i.i
  %.922.i.i = fmul contract double %.1278.i, %.918.i.i
  %.923.i.i = fmul contract double %.1403.i, %.921.i.i
  %.924.i.i = fsub contract double %.922.i.i, %.923.i.i
  %.925.i.i = fmul contract double %.1403.i, %.918.i.i
  %.926.i.i = fmul contract double %.1278.i, %.921.i.i
  %.927.i.i = fadd contract double %.925.i.i, %.926.i.i
  %.949.i.i = fmul contract double %.568.i.i, %.924.i.i
  %.951.i.i = fmul contract double %.576.i.i, %.927.i.i
  %.952.i.i = fadd contract double %.949.i.i, %.951.i.i
  %.954.i.i = fmul contract double %.568.i.i, %.927.i.i
  %.956.i.i = fmul contract double %.576.i.i, %.924.i.i
  %.957.i.i = fsub contract double %.954.i.i, %.956.i.i
  %.959.i.i = fmul contract double %.603.i.i, %.957.i.i
  %.960.i.i = fneg contract double %.952.i.i
  %.962.i.i = fmul contract double %.603.i.i, %.960.i.i
  %.964.i.i = fmul contract double %.1278.i, %.959.i.i
  %.966.i.i = fmul contract double %.1403.i, %.962.i.i
  %.967.i.i = fsub contract double %.964.i.i, %.966.i.i
  %.969.i.i = fmul contract double %.1403.i, %.959.i.i
  %.971.i.i = fmul contract double %.1278.i, %.962.i.i
  %.972.i.i = fadd contract double %.969.i.i, %.971.i.i
  %.1130.i.i = icmp slt i64 %lsr.iv21.i.i, -1
  %42 = select i1 %.1130.i.i, i64 %61, i64 24
  %43 = getelementptr i8, ptr %lsr.iv12.i.i, i64 %46
  %scevgep8.i.i = getelementptr i8, ptr %43, i64 %42
  %scevgep10.i.i = getelementptr i8, ptr %scevgep8.i.i, i64 -8
  %.1146.i.i = load double, ptr %scevgep10.i.i, align 8, !noalias !12
  %.1147.i.i = fmul contract double %.880.i.i, %.967.i.i
  %.1148.i.i = fmul contract double %.912.i.i, %.972.i.i
  %.1149.i.i = fadd contract double %.1147.i.i, %.1148.i.i
  %.1150.i.i = fadd contract double %.1146.i.i, %.1149.i.i
  store double %.1150.i.i, ptr %scevgep10.i.i, align 8, !noalias !12
  %.1211.i.i = load double, ptr %scevgep8.i.i, align 8, !noalias !12
  %.1212.i.i = fmul contract double %.880.i.i, %.972.i.i
  %.1213.i.i = fmul contract double %.912.i.i, %.967.i.i
  %.1214.i.i = fsub contract double %.1212.i.i, %.1213.i.i
  %.1215.i.i = fsub contract double %.1211.i.i, %.1214.i.i
  store double %.1215.i.i, ptr %scevgep8.i.i, align 8, !noalias !12
  %.1259.i.i = icmp slt i64 %lsr.iv21.i.i, 0
  %44 = select i1 %.1259.i.i, i64 %62, i64 8
  %scevgep3.i.i = getelementptr i8, ptr %43, i64 %44
  %scevgep4.i.i = getelementptr i8, ptr %scevgep3.i.i, i64 -8
  %.1275.i.i = load double, ptr %scevgep4.i.i, align 8, !noalias !12
  %.1276.i.i = fmul contract double %.817.i.i, %.967.i.i
  %.1277.i.i = fmul contract double %.849.i.i, %.972.i.i
  %.1278.i.i = fsub contract double %.1276.i.i, %.1277.i.i
  %.1279.i.i = fadd contract double %.1275.i.i, %.1278.i.i
  store double %.1279.i.i, ptr %scevgep4.i.i, align 8, !noalias !12
  %.1340.i.i = load double, ptr %scevgep3.i.i, align 8, !noalias !12
  %.1341.i.i = fmul contract double %.849.i.i, %.967.i.i
  %.1342.i.i = fmul contract double %.817.i.i, %.972.i.i
  %.1343.i.i = fadd contract double %.1341.i.i, %.1342.i.i
  %.1344.i.i = fadd contract double %.1340.i.i, %.1343.i.i
  store double %.1344.i.i, ptr %scevgep3.i.i, align 8, !noalias !12
  br label %B480.i.i

B480.i.i:                                         ; preds = %B342.if.i.i, %B452.i.i
  %lsr.iv.next.i.i13 = add i64 %lsr.iv.i.i12, %.216.i
  %lsr.iv.next2.i.i = add nsw i64 %lsr.iv1.i.i, -1
  %scevgep.i.i = getelementptr i8, ptr %lsr.iv3.i.i, i64 %29
  %scevgep11.i.i = getelementptr i8, ptr %lsr.iv10.i.i, i64 8
  %scevgep13.i.i = getelementptr i8, ptr %lsr.iv12.i.i, i64 %31
  %lsr.iv.next22.i.i = sub i64 %lsr.iv21.i.i, %.141.1.i
  %exitcond496.not.i.i = icmp eq i64 %lsr.iv.next2.i.i, 0
  br i1 %exitcond496.not.i.i, label %_ZN17bnserve_inference14adjoint_kernel8_passing10_turn_backB4v501B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedExx8UniTupleIdLi3EE5ArrayIdLi1E1C7mutable7alignedE.exit.i, label %B342.if.i.i

B106.if.i.i:                                      ; preds = %B240.i.i, %B106.if.lr.ph.i.i
  %lsr.iv23.i.i = phi i64 [ %.328.i.i, %B106.if.lr.ph.i.i ], [ %lsr.iv.next24.i.i, %B240.i.i ]
  %imaginary.3.0485.i.i = phi double [ 0.000000e+00, %B106.if.lr.ph.i.i ], [ %imaginary.4.1.i.i, %B240.i.i ]
  %real.3.0484.i.i = phi double [ 0.000000e+00, %B106.if.lr.ph.i.i ], [ %real.4.1.i.i, %B240.i.i ]
  %.237480482.i.i = phi i64 [ 0, %B106.if.lr.ph.i.i ], [ %.244.i.i, %B240.i.i ]
  %.244.i.i = add nuw nsw i64 %.237480482.i.i, 1
  %45 = shl i64 %.237480482.i.i, 3
  %scevgep36.i.i = getelementptr i8, ptr %23, i64 %45
  %.310.i.i = load i64, ptr %scevgep36.i.i, align 8, !noalias !12
  %.312.i.i = icmp eq i64 %.310.i.i, %.673815835.i
  br i1 %.312.i.i, label %B134.i.i, label %B240.i.i

B338.endif.i.i:                                   ; preds = %B242.i.i
  %.568.i.i = fdiv contract double %real.3.0.lcssa.i.i, %.13.i.i.i
  %.576.i.i = fdiv contract double %imaginary.3.0.lcssa.i.i, %.13.i.i.i
  %.587.i.i = fmul contract double %.568.i.i, %.568.i.i
  %.590.i.i = fmul contract double %.576.i.i, %.576.i.i
  %.591.i.i = fadd contract double %.587.i.i, %.590.i.i
  %.596.i.i = fdiv contract double %.1529.i, %.591.i.i
  %.603.i.i = fdiv contract double %.596.i.i, %.13.i.i.i
  br i1 %.699491.not.i.i, label %_ZN17bnserve_inference14adjoint_kernel8_passing10_turn_backB4v501B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedExx8UniTupleIdLi3EE5ArrayIdLi1E1C7mutable7alignedE.exit.i, label %B342.if.lr.ph.i.i

B342.if.lr.ph.i.i:                                ; preds = %B338.endif.i.i
  %.786.i.i = shl nuw i64 %.1122805807.i, 1
  %46 = shl i64 %.1122805807.i, 4
  br label %B342.if.i.i

B342.if.i.i:                                      ; preds = %B342.if.lr.ph.i.i, %B480.i.i
  %lsr.iv21.i.i = phi i64 [ %.1122805807.i, %B342.if.lr.ph.i.i ], [ %lsr.iv.next22.i.i, %B480.i.i ]
  %lsr.iv12.i.i = phi ptr [ %.498, %B342.if.lr.ph.i.i ], [ %scevgep13.i.i, %B480.i.i ]
  %lsr.iv10.i.i = phi ptr [ %23, %B342.if.lr.ph.i.i ], [ %scevgep11.i.i, %B480.i.i ]
  %lsr.iv3.i.i = phi ptr [ %24, %B342.if.lr.ph.i.i ], [ %scevgep.i.i, %B480.i.i ]
  %lsr.iv1.i.i = phi i64 [ %.124.i, %B342.if.lr.ph.i.i ], [ %lsr.iv.next2.i.i, %B480.i.i ]
  %lsr.iv.i.i12 = phi i64 [ %.786.i.i, %B342.if.lr.ph.i.i ], [ %lsr.iv.next.i.i13, %B480.i.i ]
  %.770.i.i = load i64, ptr %lsr.iv10.i.i, align 8, !noalias !12
  %.772.i.i = icmp eq i64 %.770.i.i, %.673815835.i
  br i1 %.772.i.i, label %B452.i.i, label %B480.i.i

_ZN17bnserve_inference14adjoint_kernel8_passing10_turn_backB4v501B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedExx8UniTupleIdLi3EE5ArrayIdLi1E1C7mutable7alignedE.exit.i: ; preds = %B480.i.i, %B338.endif.i.i, %B242.i.i
  %47 = add nuw nsw i64 %.1122805807.i, 2
  %exitcond.not.i11 = icmp eq i64 %18, %47
  %48 = add nuw nsw i64 %.1122805807.i, 1
  br i1 %exitcond.not.i11, label %B1068.i, label %B766.if.i

B1412:                                            ; preds = %B1068.i, %B1378, %B1254.endif, %B1334
  call void @llvm.lifetime.start.p0(ptr nonnull %.690.i)
  store double 0.000000e+00, ptr %.690.i, align 8, !noalias !15
  %.78.i = load i64, ptr %.106, align 8, !noalias !15
  %.286409.not.i = icmp slt i64 %.78.i, 1
  br i1 %.286409.not.i, label %_ZN17bnserve_inference14adjoint_kernel5_back11binary_backB4v506B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit, label %B208.if.lr.ph.i

B554.i:                                           ; preds = %B330.if.i
  %.299.i = add nuw nsw i64 %.292400412.i, 1
  %lsr.iv.next.i22 = add i64 %lsr.iv.i19, %53
  %exitcond434.not.i = icmp eq i64 %.299.i, %.78.i
  br i1 %exitcond434.not.i, label %_ZN17bnserve_inference14adjoint_kernel5_back11binary_backB4v506B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit, label %B208.if.i

B208.if.lr.ph.i:                                  ; preds = %B1412
  %.145.i = load i64, ptr %.144.i16, align 8, !noalias !15
  %.148.i = mul nuw nsw i64 %.7709701030, 80
  %.149.i17 = add nsw i64 %.145.i, %.148.i
  %.108.i = load i64, ptr %.140, align 8, !noalias !15
  %.neg.i = mul i64 %.108.i, -2
  %49 = and i64 %.neg.i, -16
  %.377.i = shl nsw i64 %.108.i, 1
  %.593.i = shl i64 %.108.i, 4
  %50 = mul i64 %.7709701030, 96
  %51 = mul i64 %50, %.78.i
  %52 = mul i64 %51, %.108.i
  %53 = mul i64 %.108.i, 96
  %54 = inttoptr i64 %.149.i17 to ptr
  br label %B208.if.i

B208.if.i:                                        ; preds = %B208.if.lr.ph.i, %B554.i
  %lsr.iv.i19 = phi i64 [ %52, %B208.if.lr.ph.i ], [ %lsr.iv.next.i22, %B554.i ]
  %.292400412.i = phi i64 [ 0, %B208.if.lr.ph.i ], [ %.299.i, %B554.i ]
  %55 = mul i64 %49, %.292400412.i
  %.375.i = sub i64 0, %55
  %.388.i = getelementptr inbounds double, ptr %.498, i64 %.375.i
  br label %B330.if.i

B330.if.i:                                        ; preds = %B330.if.i, %B208.if.i
  %lsr.iv48.i = phi i64 [ %lsr.iv.i19, %B208.if.i ], [ %lsr.iv.next49.i, %B330.if.i ]
  %.530391394.i = phi i64 [ 0, %B208.if.i ], [ %.537.i, %B330.if.i ]
  %.591.i = load i64, ptr %sunkaddr.i18, align 8, !noalias !15
  %56 = add i64 %.591.i, %lsr.iv48.i
  %57 = shl nuw nsw i64 %.530391394.i, 3
  %scevgep.i20 = getelementptr i8, ptr %54, i64 %57
  %.633.i = load double, ptr %scevgep.i20, align 8, !noalias !15
  %.638.i = inttoptr i64 %56 to ptr
  store double 0.000000e+00, ptr %.690.i, align 8, !noalias !15
  call fastcc void @inner_1(ptr nonnull %.690.i, ptr readonly %.388.i, i64 %.377.i, ptr %.638.i, i64 %.377.i, i64 %.377.i, ptr nonnull %.586)
  %.537.i = add nuw nsw i64 %.530391394.i, 1
  %.710.i = load double, ptr %.690.i, align 8, !noalias !15
  %.723.i = fadd contract double %.633.i, %.710.i
  store double %.723.i, ptr %scevgep.i20, align 8, !noalias !15
  %lsr.iv.next49.i = add i64 %lsr.iv48.i, %.593.i
  %exitcond.not.i21 = icmp eq i64 %.537.i, 6
  br i1 %exitcond.not.i21, label %B554.i, label %B330.if.i

_ZN17bnserve_inference14adjoint_kernel5_back11binary_backB4v506B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit: ; preds = %B554.i, %B1412
  call void @llvm.lifetime.end.p0(ptr nonnull %.690.i)
  %exitcond1194.not = icmp eq i64 %.777, %.684
  br i1 %exitcond1194.not, label %B1452, label %B666.if

B1452:                                            ; preds = %_ZN17bnserve_inference14adjoint_kernel5_back11binary_backB4v506B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit, %entry
  store i64 0, ptr %retptr, align 8
  ret void

B666.if.lr.ph:                                    ; preds = %entry
  %.107 = load i64, ptr %.106, align 8
  %.1057 = and i64 %.184, 120
  %.1060.not = icmp ne i64 %.1057, 0
  %.1061870 = lshr i64 %.184, 7
  %.1062 = zext i1 %.1060.not to i64
  %.1063 = add nuw nsw i64 %.1061870, %.1062
  %.1042.inv = icmp slt i64 %.184, 1
  %.1084949.not1195 = icmp eq i64 %.1063, 0
  %.1084949.not = select i1 %.1042.inv, i1 true, i1 %.1084949.not1195
  %scevgep.i = getelementptr i8, ptr %.363, i64 144
  %scevgep58.i = getelementptr i8, ptr %.230, i64 96
  %sunkaddr129 = getelementptr i8, ptr %arg.arguments.4, i64 152
  %.193.i58 = getelementptr i8, ptr %arg.arguments.4, i64 272
  %.227.i = getelementptr i8, ptr %arg.arguments.4, i64 280
  %factor.op.mul = mul i64 %.107, %.184
  %.244.i = getelementptr i8, ptr %arg.arguments.4, i64 264
  %.166.i = getelementptr i8, ptr %arg.arguments.4, i64 56
  %sunkaddr3.i = getelementptr i8, ptr %arg.arguments.4, i64 64
  %sunkaddr4.i = getelementptr i8, ptr %arg.arguments.4, i64 72
  %sunkaddr.i24 = getelementptr i8, ptr %arg.arguments.4, i64 232
  %.547.i = getelementptr i8, ptr %arg.arguments.4, i64 240
  %.459.i = getelementptr i8, ptr %arg.arguments.4, i64 88
  %.361.i = getelementptr i8, ptr %arg.arguments.4, i64 128
  %.724.i = getelementptr i8, ptr %arg.arguments.4, i64 256
  %.636.i = getelementptr i8, ptr %arg.arguments.4, i64 248
  %.172.i = getelementptr i8, ptr %arg.arguments.4, i64 128
  %.268.i = getelementptr i8, ptr %arg.arguments.4, i64 136
  %.357.i = getelementptr i8, ptr %arg.arguments.4, i64 144
  %.447.i = getelementptr i8, ptr %arg.arguments.4, i64 88
  %58 = icmp slt i64 %.47, 1
  %.532.i = getelementptr i8, ptr %arg.arguments.4, i64 56
  %scevgep503.i = getelementptr i8, ptr %.430, i64 19456
  %scevgep.i121 = getelementptr i8, ptr %.430, i64 15360
  %scevgep5.i = getelementptr i8, ptr %.430, i64 17408
  %.133.i141 = getelementptr i8, ptr %arg.arguments.4, i64 160
  %.171.i = getelementptr i8, ptr %arg.arguments.4, i64 80
  %.1072.i.i = getelementptr i8, ptr %.430, i64 3072
  %.1199.i.i = getelementptr i8, ptr %arg.arguments.4, i64 112
  %.1282.i.i = getelementptr i8, ptr %arg.arguments.4, i64 168
  %.1001.i.i145 = getelementptr inbounds nuw i8, ptr %.430, i64 2048
  %.1400.i.i = getelementptr i8, ptr %arg.arguments.4, i64 176
  %.1913.i.i = getelementptr inbounds nuw i8, ptr %.430, i64 4096
  %.2303.i.i160 = getelementptr inbounds nuw i8, ptr %.430, i64 5120
  %.148.i.i = getelementptr inbounds nuw i8, ptr %.430, i64 1024
  %sunkaddr67.i.i279 = getelementptr i8, ptr %.430, i64 8
  %sunkaddr70.i.i = getelementptr i8, ptr %.430, i64 16
  %sunkaddr73.i.i = getelementptr i8, ptr %.430, i64 24
  %sunkaddr76.i.i = getelementptr i8, ptr %.430, i64 32
  %sunkaddr79.i.i = getelementptr i8, ptr %.430, i64 40
  %sunkaddr82.i.i = getelementptr i8, ptr %.430, i64 48
  %sunkaddr85.i.i = getelementptr i8, ptr %.430, i64 56
  %sunkaddr88.i.i = getelementptr i8, ptr %.430, i64 64
  %sunkaddr91.i.i = getelementptr i8, ptr %.430, i64 72
  %sunkaddr94.i.i = getelementptr i8, ptr %.430, i64 80
  %sunkaddr97.i.i = getelementptr i8, ptr %.430, i64 88
  %sunkaddr100.i.i = getelementptr i8, ptr %.430, i64 96
  %sunkaddr103.i.i280 = getelementptr i8, ptr %.430, i64 104
  %sunkaddr106.i.i281 = getelementptr i8, ptr %.430, i64 112
  %sunkaddr109.i.i282 = getelementptr i8, ptr %.430, i64 120
  %sunkaddr64.1.i.i = getelementptr i8, ptr %.430, i64 128
  %sunkaddr67.1.i.i = getelementptr i8, ptr %.430, i64 136
  %sunkaddr70.1.i.i = getelementptr i8, ptr %.430, i64 144
  %sunkaddr73.1.i.i = getelementptr i8, ptr %.430, i64 152
  %sunkaddr76.1.i.i = getelementptr i8, ptr %.430, i64 160
  %sunkaddr79.1.i.i = getelementptr i8, ptr %.430, i64 168
  %sunkaddr82.1.i.i = getelementptr i8, ptr %.430, i64 176
  %sunkaddr85.1.i.i = getelementptr i8, ptr %.430, i64 184
  %sunkaddr88.1.i.i = getelementptr i8, ptr %.430, i64 192
  %sunkaddr91.1.i.i = getelementptr i8, ptr %.430, i64 200
  %sunkaddr94.1.i.i = getelementptr i8, ptr %.430, i64 208
  %sunkaddr97.1.i.i = getelementptr i8, ptr %.430, i64 216
  %sunkaddr100.1.i.i = getelementptr i8, ptr %.430, i64 224
  %sunkaddr103.1.i.i = getelementptr i8, ptr %.430, i64 232
  %sunkaddr106.1.i.i = getelementptr i8, ptr %.430, i64 240
  %sunkaddr109.1.i.i = getelementptr i8, ptr %.430, i64 248
  %sunkaddr64.2.i.i = getelementptr i8, ptr %.430, i64 256
  %sunkaddr67.2.i.i = getelementptr i8, ptr %.430, i64 264
  %sunkaddr70.2.i.i = getelementptr i8, ptr %.430, i64 272
  %sunkaddr73.2.i.i = getelementptr i8, ptr %.430, i64 280
  %sunkaddr76.2.i.i = getelementptr i8, ptr %.430, i64 288
  %sunkaddr79.2.i.i = getelementptr i8, ptr %.430, i64 296
  %sunkaddr82.2.i.i = getelementptr i8, ptr %.430, i64 304
  %sunkaddr85.2.i.i = getelementptr i8, ptr %.430, i64 312
  %sunkaddr88.2.i.i = getelementptr i8, ptr %.430, i64 320
  %sunkaddr91.2.i.i = getelementptr i8, ptr %.430, i64 328
  %sunkaddr94.2.i.i = getelementptr i8, ptr %.430, i64 336
  %sunkaddr97.2.i.i = getelementptr i8, ptr %.430, i64 344
  %sunkaddr100.2.i.i = getelementptr i8, ptr %.430, i64 352
  %sunkaddr103.2.i.i = getelementptr i8, ptr %.430, i64 360
  %sunkaddr106.2.i.i = getelementptr i8, ptr %.430, i64 368
  %sunkaddr109.2.i.i = getelementptr i8, ptr %.430, i64 376
  %sunkaddr64.3.i.i = getelementptr i8, ptr %.430, i64 384
  %sunkaddr67.3.i.i = getelementptr i8, ptr %.430, i64 392
  %sunkaddr70.3.i.i = getelementptr i8, ptr %.430, i64 400
  %sunkaddr73.3.i.i = getelementptr i8, ptr %.430, i64 408
  %sunkaddr76.3.i.i = getelementptr i8, ptr %.430, i64 416
  %sunkaddr79.3.i.i = getelementptr i8, ptr %.430, i64 424
  %sunkaddr82.3.i.i = getelementptr i8, ptr %.430, i64 432
  %sunkaddr85.3.i.i = getelementptr i8, ptr %.430, i64 440
  %sunkaddr88.3.i.i = getelementptr i8, ptr %.430, i64 448
  %sunkaddr91.3.i.i = getelementptr i8, ptr %.430, i64 456
  %sunkaddr94.3.i.i = getelementptr i8, ptr %.430, i64 464
  %sunkaddr97.3.i.i = getelementptr i8, ptr %.430, i64 472
  %sunkaddr100.3.i.i = getelementptr i8, ptr %.430, i64 480
  %sunkaddr103.3.i.i = getelementptr i8, ptr %.430, i64 488
  %sunkaddr106.3.i.i = getelementptr i8, ptr %.430, i64 496
  %sunkaddr109.3.i.i = getelementptr i8, ptr %.430, i64 504
  %sunkaddr64.4.i.i = getelementptr i8, ptr %.430, i64 512
  %sunkaddr67.4.i.i = getelementptr i8, ptr %.430, i64 520
  %sunkaddr70.4.i.i = getelementptr i8, ptr %.430, i64 528
  %sunkaddr73.4.i.i = getelementptr i8, ptr %.430, i64 536
  %sunkaddr76.4.i.i = getelementptr i8, ptr %.430, i64 544
  %sunkaddr79.4.i.i = getelementptr i8, ptr %.430, i64 552
  %sunkaddr82.4.i.i = getelementptr i8, ptr %.430, i64 560
  %sunkaddr85.4.i.i = getelementptr i8, ptr %.430, i64 568
  %sunkaddr88.4.i.i = getelementptr i8, ptr %.430, i64 576
  %sunkaddr91.4.i.i = getelementptr i8, ptr %.430, i64 584
  %sunkaddr94.4.i.i = getelementptr i8, ptr %.430, i64 592
  %sunkaddr97.4.i.i = getelementptr i8, ptr %.430, i64 600
  %sunkaddr100.4.i.i = getelementptr i8, ptr %.430, i64 608
  %sunkaddr103.4.i.i = getelementptr i8, ptr %.430, i64 616
  %sunkaddr106.4.i.i = getelementptr i8, ptr %.430, i64 624
  %sunkaddr109.4.i.i = getelementptr i8, ptr %.430, i64 632
  %sunkaddr64.5.i.i = getelementptr i8, ptr %.430, i64 640
  %sunkaddr67.5.i.i = getelementptr i8, ptr %.430, i64 648
  %sunkaddr70.5.i.i = getelementptr i8, ptr %.430, i64 656
  %sunkaddr73.5.i.i = getelementptr i8, ptr %.430, i64 664
  %sunkaddr76.5.i.i = getelementptr i8, ptr %.430, i64 672
  %sunkaddr79.5.i.i = getelementptr i8, ptr %.430, i64 680
  %sunkaddr82.5.i.i = getelementptr i8, ptr %.430, i64 688
  %sunkaddr85.5.i.i = getelementptr i8, ptr %.430, i64 696
  %sunkaddr88.5.i.i = getelementptr i8, ptr %.430, i64 704
  %sunkaddr91.5.i.i = getelementptr i8, ptr %.430, i64 712
  %sunkaddr94.5.i.i = getelementptr i8, ptr %.430, i64 720
  %sunkaddr97.5.i.i = getelementptr i8, ptr %.430, i64 728
  %sunkaddr100.5.i.i = getelementptr i8, ptr %.430, i64 736
  %sunkaddr103.5.i.i = getelementptr i8, ptr %.430, i64 744
  %sunkaddr106.5.i.i = getelementptr i8, ptr %.430, i64 752
  %sunkaddr109.5.i.i = getelementptr i8, ptr %.430, i64 760
  %sunkaddr64.6.i.i = getelementptr i8, ptr %.430, i64 768
  %sunkaddr67.6.i.i = getelementptr i8, ptr %.430, i64 776
  %sunkaddr70.6.i.i = getelementptr i8, ptr %.430, i64 784
  %sunkaddr73.6.i.i = getelementptr i8, ptr %.430, i64 792
  %sunkaddr76.6.i.i = getelementptr i8, ptr %.430, i64 800
  %sunkaddr79.6.i.i = getelementptr i8, ptr %.430, i64 808
  %sunkaddr82.6.i.i = getelementptr i8, ptr %.430, i64 816
  %sunkaddr85.6.i.i = getelementptr i8, ptr %.430, i64 824
  %sunkaddr88.6.i.i = getelementptr i8, ptr %.430, i64 832
  %sunkaddr91.6.i.i = getelementptr i8, ptr %.430, i64 840
  %sunkaddr94.6.i.i = getelementptr i8, ptr %.430, i64 848
  %sunkaddr97.6.i.i = getelementptr i8, ptr %.430, i64 856
  %sunkaddr100.6.i.i = getelementptr i8, ptr %.430, i64 864
  %sunkaddr103.6.i.i = getelementptr i8, ptr %.430, i64 872
  %sunkaddr106.6.i.i = getelementptr i8, ptr %.430, i64 880
  %sunkaddr109.6.i.i = getelementptr i8, ptr %.430, i64 888
  %sunkaddr64.7.i.i = getelementptr i8, ptr %.430, i64 896
  %sunkaddr67.7.i.i = getelementptr i8, ptr %.430, i64 904
  %sunkaddr70.7.i.i = getelementptr i8, ptr %.430, i64 912
  %sunkaddr73.7.i.i = getelementptr i8, ptr %.430, i64 920
  %sunkaddr76.7.i.i = getelementptr i8, ptr %.430, i64 928
  %sunkaddr79.7.i.i = getelementptr i8, ptr %.430, i64 936
  %sunkaddr82.7.i.i = getelementptr i8, ptr %.430, i64 944
  %sunkaddr85.7.i.i = getelementptr i8, ptr %.430, i64 952
  %sunkaddr88.7.i.i = getelementptr i8, ptr %.430, i64 960
  %sunkaddr91.7.i.i = getelementptr i8, ptr %.430, i64 968
  %sunkaddr94.7.i.i = getelementptr i8, ptr %.430, i64 976
  %sunkaddr97.7.i.i = getelementptr i8, ptr %.430, i64 984
  %sunkaddr100.7.i.i = getelementptr i8, ptr %.430, i64 992
  %sunkaddr103.7.i.i = getelementptr i8, ptr %.430, i64 1000
  %sunkaddr106.7.i.i = getelementptr i8, ptr %.430, i64 1008
  %sunkaddr109.7.i.i = getelementptr i8, ptr %.430, i64 1016
  %sunkaddr48.i = getelementptr i8, ptr %arg.arguments.4, i64 264
  %.138.i.i215 = getelementptr i8, ptr %arg.arguments.4, i64 32
  %.454.i.i216 = getelementptr i8, ptr %arg.arguments.4, i64 192
  %.557.i.i = getelementptr i8, ptr %arg.arguments.4, i64 96
  %.500.i.i217 = getelementptr i8, ptr %arg.arguments.4, i64 40
  %.376.i.i218 = getelementptr i8, ptr %arg.arguments.4, i64 48
  %.760.i.i = getelementptr inbounds nuw i8, ptr %.430, i64 6144
  %.1158.i.i219 = getelementptr i8, ptr %arg.arguments.4, i64 184
  %.5616.i.i = getelementptr i8, ptr %.430, i64 12296
  %.5646.i.i = getelementptr i8, ptr %.430, i64 12304
  %.5675.i.i = getelementptr i8, ptr %.430, i64 12312
  %.5706.i.i = getelementptr i8, ptr %.430, i64 12320
  %.5735.i.i = getelementptr i8, ptr %.430, i64 12328
  %.5765.i.i = getelementptr i8, ptr %.430, i64 12336
  %.5794.i.i = getelementptr i8, ptr %.430, i64 12344
  %.358.i.i.i = getelementptr i8, ptr %arg.arguments.4, i64 296
  %.1421.i.i.i = getelementptr i8, ptr %arg.arguments.4, i64 288
  %sunkaddr153.i.i.i = getelementptr i8, ptr %.430, i64 12352
  %sunkaddr156.i.i.i = getelementptr i8, ptr %.430, i64 12360
  %sunkaddr159.i.i.i = getelementptr i8, ptr %.430, i64 12368
  %sunkaddr165.i.i.i = getelementptr i8, ptr %.430, i64 12376
  %sunkaddr168.i.i.i = getelementptr i8, ptr %.430, i64 12384
  %sunkaddr171.i.i.i = getelementptr i8, ptr %.430, i64 12392
  %sunkaddr174.i.i.i = getelementptr i8, ptr %.430, i64 12400
  %sunkaddr177.i.i.i = getelementptr i8, ptr %.430, i64 12408
  %sunkaddr129.1.i.i.i = getelementptr i8, ptr %.430, i64 12416
  %sunkaddr132.1.i.i.i = getelementptr i8, ptr %.430, i64 12424
  %sunkaddr135.1.i.i.i = getelementptr i8, ptr %.430, i64 12432
  %sunkaddr138.1.i.i.i = getelementptr i8, ptr %.430, i64 12440
  %sunkaddr141.1.i.i.i = getelementptr i8, ptr %.430, i64 12448
  %sunkaddr144.1.i.i.i = getelementptr i8, ptr %.430, i64 12456
  %sunkaddr147.1.i.i.i = getelementptr i8, ptr %.430, i64 12464
  %sunkaddr150.1.i.i.i = getelementptr i8, ptr %.430, i64 12472
  %sunkaddr153.1.i.i.i = getelementptr i8, ptr %.430, i64 12480
  %sunkaddr156.1.i.i.i = getelementptr i8, ptr %.430, i64 12488
  %sunkaddr159.1.i.i.i = getelementptr i8, ptr %.430, i64 12496
  %sunkaddr165.1.i.i.i = getelementptr i8, ptr %.430, i64 12504
  %sunkaddr168.1.i.i.i = getelementptr i8, ptr %.430, i64 12512
  %sunkaddr171.1.i.i.i = getelementptr i8, ptr %.430, i64 12520
  %sunkaddr174.1.i.i.i = getelementptr i8, ptr %.430, i64 12528
  %sunkaddr177.1.i.i.i = getelementptr i8, ptr %.430, i64 12536
  %sunkaddr129.2.i.i.i = getelementptr i8, ptr %.430, i64 12544
  %sunkaddr132.2.i.i.i = getelementptr i8, ptr %.430, i64 12552
  %sunkaddr135.2.i.i.i = getelementptr i8, ptr %.430, i64 12560
  %sunkaddr138.2.i.i.i = getelementptr i8, ptr %.430, i64 12568
  %sunkaddr141.2.i.i.i = getelementptr i8, ptr %.430, i64 12576
  %sunkaddr144.2.i.i.i = getelementptr i8, ptr %.430, i64 12584
  %sunkaddr147.2.i.i.i = getelementptr i8, ptr %.430, i64 12592
  %sunkaddr150.2.i.i.i = getelementptr i8, ptr %.430, i64 12600
  %sunkaddr153.2.i.i.i = getelementptr i8, ptr %.430, i64 12608
  %sunkaddr156.2.i.i.i = getelementptr i8, ptr %.430, i64 12616
  %sunkaddr159.2.i.i.i = getelementptr i8, ptr %.430, i64 12624
  %sunkaddr165.2.i.i.i = getelementptr i8, ptr %.430, i64 12632
  %sunkaddr168.2.i.i.i = getelementptr i8, ptr %.430, i64 12640
  %sunkaddr171.2.i.i.i = getelementptr i8, ptr %.430, i64 12648
  %sunkaddr174.2.i.i.i = getelementptr i8, ptr %.430, i64 12656
  %sunkaddr177.2.i.i.i = getelementptr i8, ptr %.430, i64 12664
  %sunkaddr129.3.i.i.i = getelementptr i8, ptr %.430, i64 12672
  %sunkaddr132.3.i.i.i = getelementptr i8, ptr %.430, i64 12680
  %sunkaddr135.3.i.i.i = getelementptr i8, ptr %.430, i64 12688
  %sunkaddr138.3.i.i.i = getelementptr i8, ptr %.430, i64 12696
  %sunkaddr141.3.i.i.i = getelementptr i8, ptr %.430, i64 12704
  %sunkaddr144.3.i.i.i = getelementptr i8, ptr %.430, i64 12712
  %sunkaddr147.3.i.i.i = getelementptr i8, ptr %.430, i64 12720
  %sunkaddr150.3.i.i.i = getelementptr i8, ptr %.430, i64 12728
  %sunkaddr153.3.i.i.i = getelementptr i8, ptr %.430, i64 12736
  %sunkaddr156.3.i.i.i = getelementptr i8, ptr %.430, i64 12744
  %sunkaddr159.3.i.i.i = getelementptr i8, ptr %.430, i64 12752
  %sunkaddr165.3.i.i.i = getelementptr i8, ptr %.430, i64 12760
  %sunkaddr168.3.i.i.i = getelementptr i8, ptr %.430, i64 12768
  %sunkaddr171.3.i.i.i = getelementptr i8, ptr %.430, i64 12776
  %sunkaddr174.3.i.i.i = getelementptr i8, ptr %.430, i64 12784
  %sunkaddr177.3.i.i.i = getelementptr i8, ptr %.430, i64 12792
  %sunkaddr129.4.i.i.i = getelementptr i8, ptr %.430, i64 12800
  %sunkaddr132.4.i.i.i = getelementptr i8, ptr %.430, i64 12808
  %sunkaddr135.4.i.i.i = getelementptr i8, ptr %.430, i64 12816
  %sunkaddr138.4.i.i.i = getelementptr i8, ptr %.430, i64 12824
  %sunkaddr141.4.i.i.i = getelementptr i8, ptr %.430, i64 12832
  %sunkaddr144.4.i.i.i = getelementptr i8, ptr %.430, i64 12840
  %sunkaddr147.4.i.i.i = getelementptr i8, ptr %.430, i64 12848
  %sunkaddr150.4.i.i.i = getelementptr i8, ptr %.430, i64 12856
  %sunkaddr153.4.i.i.i = getelementptr i8, ptr %.430, i64 12864
  %sunkaddr156.4.i.i.i = getelementptr i8, ptr %.430, i64 12872
  %sunkaddr159.4.i.i.i = getelementptr i8, ptr %.430, i64 12880
  %sunkaddr165.4.i.i.i = getelementptr i8, ptr %.430, i64 12888
  %sunkaddr168.4.i.i.i = getelementptr i8, ptr %.430, i64 12896
  %sunkaddr171.4.i.i.i = getelementptr i8, ptr %.430, i64 12904
  %sunkaddr174.4.i.i.i = getelementptr i8, ptr %.430, i64 12912
  %sunkaddr177.4.i.i.i = getelementptr i8, ptr %.430, i64 12920
  %sunkaddr129.5.i.i.i = getelementptr i8, ptr %.430, i64 12928
  %sunkaddr132.5.i.i.i = getelementptr i8, ptr %.430, i64 12936
  %sunkaddr135.5.i.i.i = getelementptr i8, ptr %.430, i64 12944
  %sunkaddr138.5.i.i.i = getelementptr i8, ptr %.430, i64 12952
  %sunkaddr141.5.i.i.i = getelementptr i8, ptr %.430, i64 12960
  %sunkaddr144.5.i.i.i = getelementptr i8, ptr %.430, i64 12968
  %sunkaddr147.5.i.i.i = getelementptr i8, ptr %.430, i64 12976
  %sunkaddr150.5.i.i.i = getelementptr i8, ptr %.430, i64 12984
  %sunkaddr153.5.i.i.i = getelementptr i8, ptr %.430, i64 12992
  %sunkaddr156.5.i.i.i = getelementptr i8, ptr %.430, i64 13000
  %sunkaddr159.5.i.i.i = getelementptr i8, ptr %.430, i64 13008
  %sunkaddr165.5.i.i.i = getelementptr i8, ptr %.430, i64 13016
  %sunkaddr168.5.i.i.i = getelementptr i8, ptr %.430, i64 13024
  %sunkaddr171.5.i.i.i = getelementptr i8, ptr %.430, i64 13032
  %sunkaddr174.5.i.i.i = getelementptr i8, ptr %.430, i64 13040
  %sunkaddr177.5.i.i.i = getelementptr i8, ptr %.430, i64 13048
  %sunkaddr129.6.i.i.i = getelementptr i8, ptr %.430, i64 13056
  %sunkaddr132.6.i.i.i = getelementptr i8, ptr %.430, i64 13064
  %sunkaddr135.6.i.i.i = getelementptr i8, ptr %.430, i64 13072
  %sunkaddr138.6.i.i.i = getelementptr i8, ptr %.430, i64 13080
  %sunkaddr141.6.i.i.i = getelementptr i8, ptr %.430, i64 13088
  %sunkaddr144.6.i.i.i = getelementptr i8, ptr %.430, i64 13096
  %sunkaddr147.6.i.i.i = getelementptr i8, ptr %.430, i64 13104
  %sunkaddr150.6.i.i.i = getelementptr i8, ptr %.430, i64 13112
  %sunkaddr153.6.i.i.i = getelementptr i8, ptr %.430, i64 13120
  %sunkaddr156.6.i.i.i = getelementptr i8, ptr %.430, i64 13128
  %sunkaddr159.6.i.i.i = getelementptr i8, ptr %.430, i64 13136
  %sunkaddr165.6.i.i.i = getelementptr i8, ptr %.430, i64 13144
  %sunkaddr168.6.i.i.i = getelementptr i8, ptr %.430, i64 13152
  %sunkaddr171.6.i.i.i = getelementptr i8, ptr %.430, i64 13160
  %sunkaddr174.6.i.i.i = getelementptr i8, ptr %.430, i64 13168
  %sunkaddr177.6.i.i.i = getelementptr i8, ptr %.430, i64 13176
  %sunkaddr129.7.i.i.i = getelementptr i8, ptr %.430, i64 13184
  %sunkaddr132.7.i.i.i = getelementptr i8, ptr %.430, i64 13192
  %sunkaddr135.7.i.i.i = getelementptr i8, ptr %.430, i64 13200
  %sunkaddr138.7.i.i.i = getelementptr i8, ptr %.430, i64 13208
  %sunkaddr141.7.i.i.i = getelementptr i8, ptr %.430, i64 13216
  %sunkaddr144.7.i.i.i = getelementptr i8, ptr %.430, i64 13224
  %sunkaddr147.7.i.i.i = getelementptr i8, ptr %.430, i64 13232
  %sunkaddr150.7.i.i.i = getelementptr i8, ptr %.430, i64 13240
  %sunkaddr153.7.i.i.i = getelementptr i8, ptr %.430, i64 13248
  %sunkaddr156.7.i.i.i = getelementptr i8, ptr %.430, i64 13256
  %sunkaddr159.7.i.i.i = getelementptr i8, ptr %.430, i64 13264
  %sunkaddr165.7.i.i.i = getelementptr i8, ptr %.430, i64 13272
  %sunkaddr168.7.i.i.i = getelementptr i8, ptr %.430, i64 13280
  %sunkaddr171.7.i.i.i = getelementptr i8, ptr %.430, i64 13288
  %sunkaddr174.7.i.i.i = getelementptr i8, ptr %.430, i64 13296
  %sunkaddr177.7.i.i.i = getelementptr i8, ptr %.430, i64 13304
  %sunkaddr180.i.i.i = getelementptr i8, ptr %.430, i64 13312
  %sunkaddr183.i.i.i = getelementptr i8, ptr %.430, i64 13320
  %sunkaddr186.i.i.i = getelementptr i8, ptr %.430, i64 13328
  %sunkaddr189.i.i.i = getelementptr i8, ptr %.430, i64 13336
  %sunkaddr192.i.i.i = getelementptr i8, ptr %.430, i64 13344
  %sunkaddr195.i.i.i = getelementptr i8, ptr %.430, i64 13352
  %sunkaddr198.i.i.i = getelementptr i8, ptr %.430, i64 13360
  %sunkaddr201.i.i.i = getelementptr i8, ptr %.430, i64 13368
  %sunkaddr204.i.i.i = getelementptr i8, ptr %.430, i64 13376
  %sunkaddr207.i.i.i = getelementptr i8, ptr %.430, i64 13384
  %sunkaddr210.i.i.i = getelementptr i8, ptr %.430, i64 13392
  %sunkaddr213.i.i.i = getelementptr i8, ptr %.430, i64 13400
  %sunkaddr216.i.i.i = getelementptr i8, ptr %.430, i64 13408
  %sunkaddr219.i.i.i = getelementptr i8, ptr %.430, i64 13416
  %sunkaddr222.i.i.i = getelementptr i8, ptr %.430, i64 13424
  %sunkaddr225.i.i.i = getelementptr i8, ptr %.430, i64 13432
  %sunkaddr180.1.i.i.i = getelementptr i8, ptr %.430, i64 13440
  %sunkaddr183.1.i.i.i = getelementptr i8, ptr %.430, i64 13448
  %sunkaddr186.1.i.i.i = getelementptr i8, ptr %.430, i64 13456
  %sunkaddr189.1.i.i.i = getelementptr i8, ptr %.430, i64 13464
  %sunkaddr192.1.i.i.i = getelementptr i8, ptr %.430, i64 13472
  %sunkaddr195.1.i.i.i = getelementptr i8, ptr %.430, i64 13480
  %sunkaddr198.1.i.i.i = getelementptr i8, ptr %.430, i64 13488
  %sunkaddr201.1.i.i.i = getelementptr i8, ptr %.430, i64 13496
  %sunkaddr204.1.i.i.i = getelementptr i8, ptr %.430, i64 13504
  %sunkaddr207.1.i.i.i = getelementptr i8, ptr %.430, i64 13512
  %sunkaddr210.1.i.i.i = getelementptr i8, ptr %.430, i64 13520
  %sunkaddr213.1.i.i.i = getelementptr i8, ptr %.430, i64 13528
  %sunkaddr216.1.i.i.i = getelementptr i8, ptr %.430, i64 13536
  %sunkaddr219.1.i.i.i = getelementptr i8, ptr %.430, i64 13544
  %sunkaddr222.1.i.i.i = getelementptr i8, ptr %.430, i64 13552
  %sunkaddr225.1.i.i.i = getelementptr i8, ptr %.430, i64 13560
  %sunkaddr180.2.i.i.i = getelementptr i8, ptr %.430, i64 13568
  %sunkaddr183.2.i.i.i = getelementptr i8, ptr %.430, i64 13576
  %sunkaddr186.2.i.i.i = getelementptr i8, ptr %.430, i64 13584
  %sunkaddr189.2.i.i.i = getelementptr i8, ptr %.430, i64 13592
  %sunkaddr192.2.i.i.i = getelementptr i8, ptr %.430, i64 13600
  %sunkaddr195.2.i.i.i = getelementptr i8, ptr %.430, i64 13608
  %sunkaddr198.2.i.i.i = getelementptr i8, ptr %.430, i64 13616
  %sunkaddr201.2.i.i.i = getelementptr i8, ptr %.430, i64 13624
  %sunkaddr204.2.i.i.i = getelementptr i8, ptr %.430, i64 13632
  %sunkaddr207.2.i.i.i = getelementptr i8, ptr %.430, i64 13640
  %sunkaddr210.2.i.i.i = getelementptr i8, ptr %.430, i64 13648
  %sunkaddr213.2.i.i.i = getelementptr i8, ptr %.430, i64 13656
  %sunkaddr216.2.i.i.i = getelementptr i8, ptr %.430, i64 13664
  %sunkaddr219.2.i.i.i = getelementptr i8, ptr %.430, i64 13672
  %sunkaddr222.2.i.i.i = getelementptr i8, ptr %.430, i64 13680
  %sunkaddr225.2.i.i.i = getelementptr i8, ptr %.430, i64 13688
  %sunkaddr180.3.i.i.i = getelementptr i8, ptr %.430, i64 13696
  %sunkaddr183.3.i.i.i = getelementptr i8, ptr %.430, i64 13704
  %sunkaddr186.3.i.i.i = getelementptr i8, ptr %.430, i64 13712
  %sunkaddr189.3.i.i.i = getelementptr i8, ptr %.430, i64 13720
  %sunkaddr192.3.i.i.i = getelementptr i8, ptr %.430, i64 13728
  %sunkaddr195.3.i.i.i = getelementptr i8, ptr %.430, i64 13736
  %sunkaddr198.3.i.i.i = getelementptr i8, ptr %.430, i64 13744
  %sunkaddr201.3.i.i.i = getelementptr i8, ptr %.430, i64 13752
  %sunkaddr204.3.i.i.i = getelementptr i8, ptr %.430, i64 13760
  %sunkaddr207.3.i.i.i = getelementptr i8, ptr %.430, i64 13768
  %sunkaddr210.3.i.i.i = getelementptr i8, ptr %.430, i64 13776
  %sunkaddr213.3.i.i.i = getelementptr i8, ptr %.430, i64 13784
  %sunkaddr216.3.i.i.i = getelementptr i8, ptr %.430, i64 13792
  %sunkaddr219.3.i.i.i = getelementptr i8, ptr %.430, i64 13800
  %sunkaddr222.3.i.i.i = getelementptr i8, ptr %.430, i64 13808
  %sunkaddr225.3.i.i.i = getelementptr i8, ptr %.430, i64 13816
  %sunkaddr180.4.i.i.i = getelementptr i8, ptr %.430, i64 13824
  %sunkaddr183.4.i.i.i = getelementptr i8, ptr %.430, i64 13832
  %sunkaddr186.4.i.i.i = getelementptr i8, ptr %.430, i64 13840
  %sunkaddr189.4.i.i.i = getelementptr i8, ptr %.430, i64 13848
  %sunkaddr192.4.i.i.i = getelementptr i8, ptr %.430, i64 13856
  %sunkaddr195.4.i.i.i = getelementptr i8, ptr %.430, i64 13864
  %sunkaddr198.4.i.i.i = getelementptr i8, ptr %.430, i64 13872
  %sunkaddr201.4.i.i.i = getelementptr i8, ptr %.430, i64 13880
  %sunkaddr204.4.i.i.i = getelementptr i8, ptr %.430, i64 13888
  %sunkaddr207.4.i.i.i = getelementptr i8, ptr %.430, i64 13896
  %sunkaddr210.4.i.i.i = getelementptr i8, ptr %.430, i64 13904
  %sunkaddr213.4.i.i.i = getelementptr i8, ptr %.430, i64 13912
  %sunkaddr216.4.i.i.i = getelementptr i8, ptr %.430, i64 13920
  %sunkaddr219.4.i.i.i = getelementptr i8, ptr %.430, i64 13928
  %sunkaddr222.4.i.i.i = getelementptr i8, ptr %.430, i64 13936
  %sunkaddr225.4.i.i.i = getelementptr i8, ptr %.430, i64 13944
  %sunkaddr180.5.i.i.i = getelementptr i8, ptr %.430, i64 13952
  %sunkaddr183.5.i.i.i = getelementptr i8, ptr %.430, i64 13960
  %sunkaddr186.5.i.i.i = getelementptr i8, ptr %.430, i64 13968
  %sunkaddr189.5.i.i.i = getelementptr i8, ptr %.430, i64 13976
  %sunkaddr192.5.i.i.i = getelementptr i8, ptr %.430, i64 13984
  %sunkaddr195.5.i.i.i = getelementptr i8, ptr %.430, i64 13992
  %sunkaddr198.5.i.i.i = getelementptr i8, ptr %.430, i64 14000
  %sunkaddr201.5.i.i.i = getelementptr i8, ptr %.430, i64 14008
  %sunkaddr204.5.i.i.i = getelementptr i8, ptr %.430, i64 14016
  %sunkaddr207.5.i.i.i = getelementptr i8, ptr %.430, i64 14024
  %sunkaddr210.5.i.i.i = getelementptr i8, ptr %.430, i64 14032
  %sunkaddr213.5.i.i.i = getelementptr i8, ptr %.430, i64 14040
  %sunkaddr216.5.i.i.i = getelementptr i8, ptr %.430, i64 14048
  %sunkaddr219.5.i.i.i = getelementptr i8, ptr %.430, i64 14056
  %sunkaddr222.5.i.i.i = getelementptr i8, ptr %.430, i64 14064
  %sunkaddr225.5.i.i.i = getelementptr i8, ptr %.430, i64 14072
  %sunkaddr180.6.i.i.i = getelementptr i8, ptr %.430, i64 14080
  %sunkaddr183.6.i.i.i = getelementptr i8, ptr %.430, i64 14088
  %sunkaddr186.6.i.i.i = getelementptr i8, ptr %.430, i64 14096
  %sunkaddr189.6.i.i.i = getelementptr i8, ptr %.430, i64 14104
  %sunkaddr192.6.i.i.i = getelementptr i8, ptr %.430, i64 14112
  %sunkaddr195.6.i.i.i = getelementptr i8, ptr %.430, i64 14120
  %sunkaddr198.6.i.i.i = getelementptr i8, ptr %.430, i64 14128
  %sunkaddr201.6.i.i.i = getelementptr i8, ptr %.430, i64 14136
  %sunkaddr204.6.i.i.i = getelementptr i8, ptr %.430, i64 14144
  %sunkaddr207.6.i.i.i = getelementptr i8, ptr %.430, i64 14152
  %sunkaddr210.6.i.i.i = getelementptr i8, ptr %.430, i64 14160
  %sunkaddr213.6.i.i.i = getelementptr i8, ptr %.430, i64 14168
  %sunkaddr216.6.i.i.i = getelementptr i8, ptr %.430, i64 14176
  %sunkaddr219.6.i.i.i = getelementptr i8, ptr %.430, i64 14184
  %sunkaddr222.6.i.i.i = getelementptr i8, ptr %.430, i64 14192
  %sunkaddr225.6.i.i.i = getelementptr i8, ptr %.430, i64 14200
  %sunkaddr180.7.i.i.i = getelementptr i8, ptr %.430, i64 14208
  %sunkaddr183.7.i.i.i = getelementptr i8, ptr %.430, i64 14216
  %sunkaddr186.7.i.i.i = getelementptr i8, ptr %.430, i64 14224
  %sunkaddr189.7.i.i.i = getelementptr i8, ptr %.430, i64 14232
  %sunkaddr192.7.i.i.i = getelementptr i8, ptr %.430, i64 14240
  %sunkaddr195.7.i.i.i = getelementptr i8, ptr %.430, i64 14248
  %sunkaddr198.7.i.i.i = getelementptr i8, ptr %.430, i64 14256
  %sunkaddr201.7.i.i.i = getelementptr i8, ptr %.430, i64 14264
  %sunkaddr204.7.i.i.i = getelementptr i8, ptr %.430, i64 14272
  %sunkaddr207.7.i.i.i = getelementptr i8, ptr %.430, i64 14280
  %sunkaddr210.7.i.i.i = getelementptr i8, ptr %.430, i64 14288
  %sunkaddr213.7.i.i.i = getelementptr i8, ptr %.430, i64 14296
  %sunkaddr216.7.i.i.i = getelementptr i8, ptr %.430, i64 14304
  %sunkaddr219.7.i.i.i = getelementptr i8, ptr %.430, i64 14312
  %sunkaddr222.7.i.i.i = getelementptr i8, ptr %.430, i64 14320
  %sunkaddr225.7.i.i.i = getelementptr i8, ptr %.430, i64 14328
  %.265.i.i221 = getelementptr i8, ptr %arg.arguments.4, i64 304
  %scevgep266.i.i = getelementptr i8, ptr %.430, i64 21504
  %sunkaddr12.i36.i = getelementptr i8, ptr %arg.arguments.4, i64 104
  %.307.i.i = getelementptr i8, ptr %arg.arguments.4, i64 112
  %.592.i.i = getelementptr i8, ptr %.430, i64 4096
  %59 = getelementptr i8, ptr %arg.arguments.4, i64 344
  %60 = getelementptr i8, ptr %arg.arguments.4, i64 352
  %.592.1.i.i = getelementptr i8, ptr %.430, i64 5120
  %.430.i.i = getelementptr i8, ptr %arg.arguments.4, i64 328
  %.703.i = getelementptr i8, ptr %arg.arguments.4, i64 336
  %.736.i = getelementptr i8, ptr %arg.arguments.4, i64 56
  %scevgep.i2 = getelementptr i8, ptr %.430, i64 41024
  %sunkaddr115 = getelementptr i8, ptr %arg.arguments.4, i64 56
  %sunkaddr = getelementptr i8, ptr %arg.arguments.4, i64 320
  %sunkaddr136 = getelementptr i8, ptr %arg.arguments.4, i64 336
  %.389.i = getelementptr i8, ptr %arg.arguments.4, i64 256
  %.304.i = getelementptr i8, ptr %arg.arguments.4, i64 88
  %.208.i = getelementptr i8, ptr %arg.arguments.4, i64 128
  %sunkaddr27.i = getelementptr i8, ptr %arg.arguments.4, i64 240
  %.228.reass = shl i64 %factor.op.mul, 4
  %61 = or disjoint i64 %.228.reass, 24
  %62 = or disjoint i64 %.228.reass, 8
  %.144.i16 = getelementptr i8, ptr %arg.arguments.4, i64 320
  %sunkaddr.i18 = getelementptr i8, ptr %arg.arguments.4, i64 312
  br label %B666.if

B666.if:                                          ; preds = %B666.if.lr.ph, %_ZN17bnserve_inference14adjoint_kernel5_back11binary_backB4v506B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit
  %.7709701030 = phi i64 [ 0, %B666.if.lr.ph ], [ %.777, %_ZN17bnserve_inference14adjoint_kernel5_back11binary_backB4v506B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit ]
  %.777 = add nuw nsw i64 %.7709701030, 1
  %.835 = load i64, ptr %sunkaddr129, align 8
  %.838 = mul nuw nsw i64 %.7709701030, 56
  %.839 = add nsw i64 %.835, %.838
  %.840 = inttoptr i64 %.839 to ptr
  %.915 = getelementptr i8, ptr %.840, i64 24
  %.916 = load double, ptr %.915, align 8
  %.290.i = load i64, ptr %arg.arguments.4, align 8, !noalias !18
  %.370466.not.i = icmp slt i64 %.290.i, 1
  br i1 %.370466.not.i, label %_ZN17bnserve_inference14adjoint_kernel7_source6_placeB3v16B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit, label %B268.if.preheader.i

B268.if.preheader.i:                              ; preds = %B666.if
  %.245.i = load i64, ptr %.244.i, align 8, !noalias !18
  %.167.i = load i64, ptr %.166.i, align 8, !noalias !18
  %63 = inttoptr i64 %.167.i to ptr
  %.145.i.i = getelementptr i8, ptr %63, i64 8
  %.345.i.i25 = getelementptr i8, ptr %.840, i64 8
  %.542.i.i = icmp eq i64 %.245.i, 1
  %.2102.i.i = getelementptr i8, ptr %.840, i64 16
  br label %B268.if.i

B268.if.i:                                        ; preds = %_ZN17bnserve_inference14adjoint_kernel9_response13fill_geometryB3v43B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i, %B268.if.preheader.i
  %lsr.iv138.i = phi i64 [ %lsr.iv.next139.i, %_ZN17bnserve_inference14adjoint_kernel9_response13fill_geometryB3v43B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i ], [ %.290.i, %B268.if.preheader.i ]
  %lsr.iv136.i = phi i64 [ %lsr.iv.next137.i, %_ZN17bnserve_inference14adjoint_kernel9_response13fill_geometryB3v43B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i ], [ 0, %B268.if.preheader.i ]
  %lsr.iv134.i = phi i64 [ %lsr.iv.next135.i, %_ZN17bnserve_inference14adjoint_kernel9_response13fill_geometryB3v43B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i ], [ 0, %B268.if.preheader.i ]
  %lsr.iv133.i = phi i64 [ %lsr.iv.next.i52, %_ZN17bnserve_inference14adjoint_kernel9_response13fill_geometryB3v43B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i ], [ 0, %B268.if.preheader.i ]
  %lsr.iv131.i = phi ptr [ %scevgep132.i, %_ZN17bnserve_inference14adjoint_kernel9_response13fill_geometryB3v43B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i ], [ %.230, %B268.if.preheader.i ]
  %lsr.iv.i26 = phi ptr [ %scevgep.i51, %_ZN17bnserve_inference14adjoint_kernel9_response13fill_geometryB3v43B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i ], [ %.363, %B268.if.preheader.i ]
  %.438.i = load i64, ptr %sunkaddr3.i, align 8, !noalias !18
  %64 = add i64 %.438.i, %lsr.iv136.i
  %.441.i = inttoptr i64 %64 to ptr
  %.519.i = load i64, ptr %sunkaddr4.i, align 8, !noalias !18
  %65 = add i64 %.519.i, %lsr.iv134.i
  %.522.i = inttoptr i64 %65 to ptr
  %.600.i = load i64, ptr %sunkaddr.i24, align 8, !noalias !18
  %66 = add i64 %.600.i, %lsr.iv133.i
  %.603.i = inttoptr i64 %66 to ptr
  %.116.i.i = load double, ptr %63, align 8, !noalias !21
  %.146.i.i = load double, ptr %.145.i.i, align 8, !noalias !21
  %.176.i.i = load double, ptr %.915, align 8, !noalias !21
  %.177.i.i = fmul contract double %.146.i.i, %.176.i.i
  %.178.i.i = fadd contract double %.116.i.i, %.177.i.i
  %.208.i.i = load double, ptr %.840, align 8, !noalias !21
  %.209.i.i = fsub contract double %.178.i.i, %.208.i.i
  %.215.i.i = tail call contract double @llvm.fma.f64(double %.209.i.i, double 0x3FE45F306DC9C883, double 0x4338000000000000)
  %.216.i.i27 = fadd contract double %.215.i.i, 0xC338000000000000
  %.231.i.i = tail call contract double @llvm.fma.f64(double %.216.i.i27, double 0xBFF921FB54442D18, double %.209.i.i)
  %.246.i.i = tail call contract double @llvm.fma.f64(double %.216.i.i27, double 0xBC91A62633145C07, double %.231.i.i)
  %.247.i.i = fmul contract double %.246.i.i, %.246.i.i
  %.248.i.i = tail call contract double @llvm.fma.f64(double %.247.i.i, double 0xBD6AE7F3E733B81F, double 0x3DE6124613A86D09)
  %.249.i.i = tail call contract double @llvm.fma.f64(double %.247.i.i, double %.248.i.i, double 0xBE5AE64567F544E4)
  %.250.i.i = tail call contract double @llvm.fma.f64(double %.247.i.i, double %.249.i.i, double 0x3EC71DE3A556C734)
  %.251.i.i28 = tail call contract double @llvm.fma.f64(double %.247.i.i, double %.250.i.i, double 0xBF2A01A01A01A01A)
  %.252.i.i29 = tail call contract double @llvm.fma.f64(double %.247.i.i, double %.251.i.i28, double 0x3F81111111111111)
  %.253.i.i = tail call contract double @llvm.fma.f64(double %.247.i.i, double %.252.i.i29, double 0xBFC5555555555555)
  %.254.i.i = fmul contract double %.246.i.i, %.247.i.i
  %.255.i.i30 = tail call contract double @llvm.fma.f64(double %.254.i.i, double %.253.i.i, double %.246.i.i)
  %.256.i.i = tail call contract double @llvm.fma.f64(double %.247.i.i, double 0x3D2AE7F3E733B81F, double 0xBDA93974A8C07C9D)
  %.257.i.i = tail call contract double @llvm.fma.f64(double %.247.i.i, double %.256.i.i, double 0x3E21EED8EFF8D898)
  %.258.i.i = tail call contract double @llvm.fma.f64(double %.247.i.i, double %.257.i.i, double 0xBE927E4FB7789F5C)
  %.259.i.i = tail call contract double @llvm.fma.f64(double %.247.i.i, double %.258.i.i, double 0x3EFA01A01A01A01A)
  %.260.i.i = tail call contract double @llvm.fma.f64(double %.247.i.i, double %.259.i.i, double 0xBF56C16C16C16C17)
  %.261.i.i = tail call contract double @llvm.fma.f64(double %.247.i.i, double %.260.i.i, double 0x3FA5555555555555)
  %.262.i.i = tail call contract double @llvm.fma.f64(double %.247.i.i, double %.261.i.i, double -5.000000e-01)
  %.263.i.i = tail call contract double @llvm.fma.f64(double %.247.i.i, double %.262.i.i, double 1.000000e+00)
  %.264.i.i = bitcast double %.215.i.i to i64
  %.265.i.i = bitcast double %.255.i.i30 to i64
  %.266.i.i = bitcast double %.263.i.i to i64
  %.267.i.i = xor i64 %.266.i.i, %.265.i.i
  %.268.i.i = and i64 %.264.i.i, 1
  %67 = icmp eq i64 %.268.i.i, 0
  %.270.i.i = select i1 %67, i64 0, i64 %.267.i.i
  %.271.i.i = shl i64 %.264.i.i, 62
  %.272.i.i = and i64 %.271.i.i, -9223372036854775808
  %.274.i.i = add i64 %.271.i.i, 4611686018427387904
  %.275.i.i = and i64 %.274.i.i, -9223372036854775808
  %68 = xor i64 %.272.i.i, %.265.i.i
  %.277.i.i = xor i64 %68, %.270.i.i
  %.278.i.i = bitcast i64 %.277.i.i to double
  %69 = xor i64 %.275.i.i, %.266.i.i
  %.280.i.i = xor i64 %69, %.270.i.i
  %.281.i.i = bitcast i64 %.280.i.i to double
  %.346.i.i31 = load double, ptr %.345.i.i25, align 8, !noalias !21
  %.347.i.i = tail call contract double @llvm.fma.f64(double %.346.i.i31, double 0x3FE45F306DC9C883, double 0x4338000000000000)
  %.348.i.i = fadd contract double %.347.i.i, 0xC338000000000000
  %.363.i.i = tail call contract double @llvm.fma.f64(double %.348.i.i, double 0xBFF921FB54442D18, double %.346.i.i31)
  %.378.i.i = tail call contract double @llvm.fma.f64(double %.348.i.i, double 0xBC91A62633145C07, double %.363.i.i)
  %.379.i.i = fmul contract double %.378.i.i, %.378.i.i
  %.380.i.i = tail call contract double @llvm.fma.f64(double %.379.i.i, double 0xBD6AE7F3E733B81F, double 0x3DE6124613A86D09)
  %.381.i.i = tail call contract double @llvm.fma.f64(double %.379.i.i, double %.380.i.i, double 0xBE5AE64567F544E4)
  %.382.i.i = tail call contract double @llvm.fma.f64(double %.379.i.i, double %.381.i.i, double 0x3EC71DE3A556C734)
  %.383.i.i = tail call contract double @llvm.fma.f64(double %.379.i.i, double %.382.i.i, double 0xBF2A01A01A01A01A)
  %.384.i.i = tail call contract double @llvm.fma.f64(double %.379.i.i, double %.383.i.i, double 0x3F81111111111111)
  %.385.i.i = tail call contract double @llvm.fma.f64(double %.379.i.i, double %.384.i.i, double 0xBFC5555555555555)
  %.386.i.i = fmul contract double %.378.i.i, %.379.i.i
  %.387.i.i = tail call contract double @llvm.fma.f64(double %.386.i.i, double %.385.i.i, double %.378.i.i)
  %.388.i.i = tail call contract double @llvm.fma.f64(double %.379.i.i, double 0x3D2AE7F3E733B81F, double 0xBDA93974A8C07C9D)
  %.389.i.i = tail call contract double @llvm.fma.f64(double %.379.i.i, double %.388.i.i, double 0x3E21EED8EFF8D898)
  %.390.i.i = tail call contract double @llvm.fma.f64(double %.379.i.i, double %.389.i.i, double 0xBE927E4FB7789F5C)
  %.391.i.i32 = tail call contract double @llvm.fma.f64(double %.379.i.i, double %.390.i.i, double 0x3EFA01A01A01A01A)
  %.392.i.i = tail call contract double @llvm.fma.f64(double %.379.i.i, double %.391.i.i32, double 0xBF56C16C16C16C17)
  %.393.i.i = tail call contract double @llvm.fma.f64(double %.379.i.i, double %.392.i.i, double 0x3FA5555555555555)
  %.394.i.i = tail call contract double @llvm.fma.f64(double %.379.i.i, double %.393.i.i, double -5.000000e-01)
  %.395.i.i = tail call contract double @llvm.fma.f64(double %.379.i.i, double %.394.i.i, double 1.000000e+00)
  %.396.i.i = bitcast double %.347.i.i to i64
  %.397.i.i = bitcast double %.387.i.i to i64
  %.398.i.i = bitcast double %.395.i.i to i64
  %.399.i.i = xor i64 %.398.i.i, %.397.i.i
  %.400.i.i = and i64 %.396.i.i, 1
  %70 = icmp eq i64 %.400.i.i, 0
  %.402.i.i = select i1 %70, i64 0, i64 %.399.i.i
  %.403.i.i = shl i64 %.396.i.i, 62
  %.404.i.i = and i64 %.403.i.i, -9223372036854775808
  %.406.i.i33 = add i64 %.403.i.i, 4611686018427387904
  %.407.i.i = and i64 %.406.i.i33, -9223372036854775808
  %71 = xor i64 %.404.i.i, %.397.i.i
  %.409.i.i = xor i64 %71, %.402.i.i
  %.410.i.i = bitcast i64 %.409.i.i to double
  %72 = xor i64 %.407.i.i, %.398.i.i
  %.412.i.i = xor i64 %72, %.402.i.i
  %.413.i.i = bitcast i64 %.412.i.i to double
  %.468.i.i34 = load double, ptr %.522.i, align 8, !noalias !21
  %.496.i.i = getelementptr i8, ptr %.522.i, i64 8
  %.497.i.i = load double, ptr %.496.i.i, align 8, !noalias !21
  %.525.i.i = getelementptr i8, ptr %.522.i, i64 16
  %.526.i.i35 = load double, ptr %.525.i.i, align 8, !noalias !21
  br i1 %.542.i.i, label %B276.i.i, label %_ZN17bnserve_inference13moving_kernel9_response12coefficientsB3v24B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i

B276.i.i:                                         ; preds = %B268.if.i
  %.547.i.i = fmul contract double %.468.i.i34, %.281.i.i
  %.553.i.i = fmul contract double %.497.i.i, %.278.i.i
  %.556.i.i = fsub contract double %.547.i.i, %.553.i.i
  %.558.i.i = fmul contract double %.556.i.i, %.413.i.i
  %.562.i.i = fmul contract double %.526.i.i35, %.410.i.i
  %.563.i.i = fadd contract double %.562.i.i, %.558.i.i
  %.568.i.i55 = fdiv contract double %.563.i.i, 0x41B1DE784A000000
  %.605.i.i = fmul contract double %.146.i.i, %.568.i.i55
  %73 = fsub contract double %.209.i.i, %.605.i.i
  %.610.i.i = tail call contract double @llvm.fma.f64(double %73, double 0x3FE45F306DC9C883, double 0x4338000000000000)
  %.611.i.i = fadd contract double %.610.i.i, 0xC338000000000000
  %.626.i.i = tail call contract double @llvm.fma.f64(double %.611.i.i, double 0xBFF921FB54442D18, double %73)
  %.641.i.i = tail call contract double @llvm.fma.f64(double %.611.i.i, double 0xBC91A62633145C07, double %.626.i.i)
  %.642.i.i = fmul contract double %.641.i.i, %.641.i.i
  %.643.i.i = tail call contract double @llvm.fma.f64(double %.642.i.i, double 0xBD6AE7F3E733B81F, double 0x3DE6124613A86D09)
  %.644.i.i = tail call contract double @llvm.fma.f64(double %.642.i.i, double %.643.i.i, double 0xBE5AE64567F544E4)
  %.645.i.i = tail call contract double @llvm.fma.f64(double %.642.i.i, double %.644.i.i, double 0x3EC71DE3A556C734)
  %.646.i.i = tail call contract double @llvm.fma.f64(double %.642.i.i, double %.645.i.i, double 0xBF2A01A01A01A01A)
  %.647.i.i = tail call contract double @llvm.fma.f64(double %.642.i.i, double %.646.i.i, double 0x3F81111111111111)
  %.648.i.i = tail call contract double @llvm.fma.f64(double %.642.i.i, double %.647.i.i, double 0xBFC5555555555555)
  %.649.i.i = fmul contract double %.641.i.i, %.642.i.i
  %.650.i.i = tail call contract double @llvm.fma.f64(double %.649.i.i, double %.648.i.i, double %.641.i.i)
  %.651.i.i = tail call contract double @llvm.fma.f64(double %.642.i.i, double 0x3D2AE7F3E733B81F, double 0xBDA93974A8C07C9D)
  %.652.i.i = tail call contract double @llvm.fma.f64(double %.642.i.i, double %.651.i.i, double 0x3E21EED8EFF8D898)
  %.653.i.i = tail call contract double @llvm.fma.f64(double %.642.i.i, double %.652.i.i, double 0xBE927E4FB7789F5C)
  %.654.i.i = tail call contract double @llvm.fma.f64(double %.642.i.i, double %.653.i.i, double 0x3EFA01A01A01A01A)
  %.655.i.i = tail call contract double @llvm.fma.f64(double %.642.i.i, double %.654.i.i, double 0xBF56C16C16C16C17)
  %.656.i.i = tail call contract double @llvm.fma.f64(double %.642.i.i, double %.655.i.i, double 0x3FA5555555555555)
  %.657.i.i = tail call contract double @llvm.fma.f64(double %.642.i.i, double %.656.i.i, double -5.000000e-01)
  %.658.i.i = tail call contract double @llvm.fma.f64(double %.642.i.i, double %.657.i.i, double 1.000000e+00)
  %.659.i.i = bitcast double %.610.i.i to i64
  %.660.i.i = bitcast double %.650.i.i to i64
  %.661.i.i = bitcast double %.658.i.i to i64
  %.662.i.i = xor i64 %.661.i.i, %.660.i.i
  %.663.i.i = and i64 %.659.i.i, 1
  %74 = icmp eq i64 %.663.i.i, 0
  %.665.i.i = select i1 %74, i64 0, i64 %.662.i.i
  %.666.i.i = shl i64 %.659.i.i, 62
  %.667.i.i = and i64 %.666.i.i, -9223372036854775808
  %.669.i.i = add i64 %.666.i.i, 4611686018427387904
  %.670.i.i = and i64 %.669.i.i, -9223372036854775808
  %75 = xor i64 %.667.i.i, %.660.i.i
  %.672.i.i = xor i64 %75, %.665.i.i
  %.673.i.i = bitcast i64 %.672.i.i to double
  %76 = xor i64 %.670.i.i, %.661.i.i
  %.675.i.i = xor i64 %76, %.665.i.i
  %.676.i.i = bitcast i64 %.675.i.i to double
  br label %_ZN17bnserve_inference13moving_kernel9_response12coefficientsB3v24B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i

_ZN17bnserve_inference13moving_kernel9_response12coefficientsB3v24B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i: ; preds = %B276.i.i, %B268.if.i
  %sin_h.2.0.i.i = phi double [ %.673.i.i, %B276.i.i ], [ %.278.i.i, %B268.if.i ]
  %cos_h.2.0.i.i = phi double [ %.676.i.i, %B276.i.i ], [ %.281.i.i, %B268.if.i ]
  %.775.i.i = fmul contract double %.468.i.i34, %cos_h.2.0.i.i
  %77 = fmul contract double %.497.i.i, %sin_h.2.0.i.i
  %.779.i.i = fsub contract double %.775.i.i, %77
  %.788.i.i = fmul contract double %.526.i.i35, 0.000000e+00
  %.789.i.i = fadd contract double %.788.i.i, %.779.i.i
  %.791.i.i = fmul contract double %.789.i.i, %.413.i.i
  %.795.i.i = fmul contract double %.526.i.i35, %.410.i.i
  %.796.i.i = fadd contract double %.795.i.i, %.791.i.i
  %.801.i.i36 = fdiv contract double %.796.i.i, 0xC1B1DE784A000000
  store double %.801.i.i36, ptr %lsr.iv131.i, align 8, !noalias !21
  %.863.i.i = fdiv contract double %.791.i.i, 0x41B1DE784A000000
  %.892.i.i = getelementptr i8, ptr %lsr.iv131.i, i64 88
  store double %.863.i.i, ptr %.892.i.i, align 8, !noalias !21
  %.910.i.i = fmul contract double %.468.i.i34, %sin_h.2.0.i.i
  %.913.i.i = fmul contract double %.497.i.i, %cos_h.2.0.i.i
  %.914.i.i = fadd contract double %.910.i.i, %.913.i.i
  %.924.i.i37 = fadd contract double %.788.i.i, %.914.i.i
  %.926.i.i38 = fmul contract double %.924.i.i37, %.413.i.i
  %.930.i.i = fdiv contract double %.926.i.i38, 0x41B1DE784A000000
  %.959.i.i39 = getelementptr i8, ptr %lsr.iv131.i, i64 96
  store double %.930.i.i, ptr %.959.i.i39, align 8, !noalias !21
  %.998.i.i = load double, ptr %.441.i, align 8, !noalias !21
  %.1000.i.i = fmul contract double %cos_h.2.0.i.i, %.998.i.i
  %.1028.i.i = getelementptr i8, ptr %.441.i, i64 8
  %.1029.i.i = load double, ptr %.1028.i.i, align 8, !noalias !21
  %78 = fmul contract double %sin_h.2.0.i.i, %.1029.i.i
  %.1032.i.i = fsub contract double %.1000.i.i, %78
  %.1060.i.i = getelementptr i8, ptr %.441.i, i64 16
  %.1061.i.i = load double, ptr %.1060.i.i, align 8, !noalias !21
  %.1063.i.i = fmul contract double %.1061.i.i, 0.000000e+00
  %.1064.i.i = fadd contract double %.1032.i.i, %.1063.i.i
  %.1092.i.i = getelementptr i8, ptr %.441.i, i64 24
  %.1093.i.i = load double, ptr %.1092.i.i, align 8, !noalias !21
  %.1095.i.i = fmul contract double %cos_h.2.0.i.i, %.1093.i.i
  %.1123.i.i = getelementptr i8, ptr %.441.i, i64 32
  %.1124.i.i = load double, ptr %.1123.i.i, align 8, !noalias !21
  %79 = fmul contract double %sin_h.2.0.i.i, %.1124.i.i
  %.1127.i.i = fsub contract double %.1095.i.i, %79
  %.1155.i.i = getelementptr i8, ptr %.441.i, i64 40
  %.1156.i.i = load double, ptr %.1155.i.i, align 8, !noalias !21
  %.1158.i.i = fmul contract double %.1156.i.i, 0.000000e+00
  %.1159.i.i = fadd contract double %.1127.i.i, %.1158.i.i
  %.1187.i.i = getelementptr i8, ptr %.441.i, i64 48
  %.1188.i.i = load double, ptr %.1187.i.i, align 8, !noalias !21
  %.1190.i.i = fmul contract double %cos_h.2.0.i.i, %.1188.i.i
  %.1218.i.i = getelementptr i8, ptr %.441.i, i64 56
  %.1219.i.i = load double, ptr %.1218.i.i, align 8, !noalias !21
  %80 = fmul contract double %sin_h.2.0.i.i, %.1219.i.i
  %.1222.i.i = fsub contract double %.1190.i.i, %80
  %.1250.i.i = getelementptr i8, ptr %.441.i, i64 64
  %.1251.i.i = load double, ptr %.1250.i.i, align 8, !noalias !21
  %.1259.i.i40 = fmul contract double %.1251.i.i, 0.000000e+00
  %.1260.i.i = fadd contract double %.1222.i.i, %.1259.i.i40
  %.1318.i.i = fmul contract double %sin_h.2.0.i.i, %.998.i.i
  %.1349.i.i = fmul contract double %cos_h.2.0.i.i, %.1029.i.i
  %.1350.i.i = fadd contract double %.1318.i.i, %.1349.i.i
  %.1382.i.i = fadd contract double %.1350.i.i, %.1063.i.i
  %.1413.i.i = fmul contract double %sin_h.2.0.i.i, %.1093.i.i
  %.1444.i.i = fmul contract double %cos_h.2.0.i.i, %.1124.i.i
  %.1445.i.i = fadd contract double %.1413.i.i, %.1444.i.i
  %.1477.i.i = fadd contract double %.1445.i.i, %.1158.i.i
  %.1508.i.i = fmul contract double %sin_h.2.0.i.i, %.1188.i.i
  %.1539.i.i = fmul contract double %cos_h.2.0.i.i, %.1219.i.i
  %.1540.i.i = fadd contract double %.1508.i.i, %.1539.i.i
  %.1578.i.i = fadd contract double %.1540.i.i, %.1259.i.i40
  %.1643.i.i = fmul contract double %.998.i.i, 0.000000e+00
  %.1674.i.i = fmul contract double %.1029.i.i, 0.000000e+00
  %.1675.i.i = fadd contract double %.1643.i.i, %.1674.i.i
  %.1707.i.i = fadd contract double %.1061.i.i, %.1675.i.i
  %.1738.i.i = fmul contract double %.1093.i.i, 0.000000e+00
  %.1769.i.i = fmul contract double %.1124.i.i, 0.000000e+00
  %.1770.i.i = fadd contract double %.1738.i.i, %.1769.i.i
  %.1802.i.i = fadd contract double %.1156.i.i, %.1770.i.i
  %.1833.i.i = fmul contract double %.1188.i.i, 0.000000e+00
  %.1864.i.i = fmul contract double %.1219.i.i, 0.000000e+00
  %.1865.i.i = fadd contract double %.1833.i.i, %.1864.i.i
  %.1903.i.i = fadd contract double %.1251.i.i, %.1865.i.i
  %.1947.i.i = fmul contract double %cos_h.2.0.i.i, %.1064.i.i
  %81 = fmul contract double %sin_h.2.0.i.i, %.1159.i.i
  %.1951.i.i = fsub contract double %.1947.i.i, %81
  %.1960.i.i = fmul contract double %.1260.i.i, 0.000000e+00
  %.1961.i.i = fadd contract double %.1951.i.i, %.1960.i.i
  %.1972.i.i = fmul contract double %cos_h.2.0.i.i, %.1382.i.i
  %82 = fmul contract double %sin_h.2.0.i.i, %.1477.i.i
  %.1976.i.i = fsub contract double %.1972.i.i, %82
  %.1985.i.i = fmul contract double %.1578.i.i, 0.000000e+00
  %.1986.i.i = fadd contract double %.1976.i.i, %.1985.i.i
  %.2000.i.i = fmul contract double %sin_h.2.0.i.i, %.1382.i.i
  %.2003.i.i = fmul contract double %cos_h.2.0.i.i, %.1477.i.i
  %.2004.i.i = fadd contract double %.2000.i.i, %.2003.i.i
  %.2014.i.i = fadd contract double %.2004.i.i, %.1985.i.i
  %.2025.i.i = fmul contract double %cos_h.2.0.i.i, %.1707.i.i
  %83 = fmul contract double %sin_h.2.0.i.i, %.1802.i.i
  %.2029.i.i = fsub contract double %.2025.i.i, %83
  %.2038.i.i = fmul contract double %.1903.i.i, 0.000000e+00
  %.2039.i.i = fadd contract double %.2029.i.i, %.2038.i.i
  %.2050.i.i = fmul contract double %sin_h.2.0.i.i, %.1707.i.i
  %.2053.i.i = fmul contract double %cos_h.2.0.i.i, %.1802.i.i
  %.2054.i.i = fadd contract double %.2050.i.i, %.2053.i.i
  %.2064.i.i = fadd contract double %.2054.i.i, %.2038.i.i
  %.2069.i.i = fadd contract double %.1961.i.i, %.2014.i.i
  %.2070.i.i = fmul contract double %.2069.i.i, 5.000000e-01
  %.2071.i.i = fsub contract double %.2014.i.i, %.1961.i.i
  %.2072.i.i = fmul contract double %.2071.i.i, 5.000000e-01
  %.2103.i.i = load double, ptr %.2102.i.i, align 8, !noalias !21
  %.2109.i.i = fmul contract double %.2103.i.i, 2.000000e+00
  %.2110.i.i = tail call contract double @llvm.fma.f64(double %.2109.i.i, double 0x3FE45F306DC9C883, double 0x4338000000000000)
  %.2111.i.i = fadd contract double %.2110.i.i, 0xC338000000000000
  %.2126.i.i = tail call contract double @llvm.fma.f64(double %.2111.i.i, double 0xBFF921FB54442D18, double %.2109.i.i)
  %.2141.i.i = tail call contract double @llvm.fma.f64(double %.2111.i.i, double 0xBC91A62633145C07, double %.2126.i.i)
  %.2142.i.i = fmul contract double %.2141.i.i, %.2141.i.i
  %.2143.i.i = tail call contract double @llvm.fma.f64(double %.2142.i.i, double 0xBD6AE7F3E733B81F, double 0x3DE6124613A86D09)
  %.2144.i.i = tail call contract double @llvm.fma.f64(double %.2142.i.i, double %.2143.i.i, double 0xBE5AE64567F544E4)
  %.2145.i.i = tail call contract double @llvm.fma.f64(double %.2142.i.i, double %.2144.i.i, double 0x3EC71DE3A556C734)
  %.2146.i.i = tail call contract double @llvm.fma.f64(double %.2142.i.i, double %.2145.i.i, double 0xBF2A01A01A01A01A)
  %.2147.i.i = tail call contract double @llvm.fma.f64(double %.2142.i.i, double %.2146.i.i, double 0x3F81111111111111)
  %.2148.i.i = tail call contract double @llvm.fma.f64(double %.2142.i.i, double %.2147.i.i, double 0xBFC5555555555555)
  %.2149.i.i = fmul contract double %.2141.i.i, %.2142.i.i
  %.2150.i.i = tail call contract double @llvm.fma.f64(double %.2149.i.i, double %.2148.i.i, double %.2141.i.i)
  %.2151.i.i = tail call contract double @llvm.fma.f64(double %.2142.i.i, double 0x3D2AE7F3E733B81F, double 0xBDA93974A8C07C9D)
  %.2152.i.i = tail call contract double @llvm.fma.f64(double %.2142.i.i, double %.2151.i.i, double 0x3E21EED8EFF8D898)
  %.2153.i.i = tail call contract double @llvm.fma.f64(double %.2142.i.i, double %.2152.i.i, double 0xBE927E4FB7789F5C)
  %.2154.i.i = tail call contract double @llvm.fma.f64(double %.2142.i.i, double %.2153.i.i, double 0x3EFA01A01A01A01A)
  %.2155.i.i = tail call contract double @llvm.fma.f64(double %.2142.i.i, double %.2154.i.i, double 0xBF56C16C16C16C17)
  %.2156.i.i = tail call contract double @llvm.fma.f64(double %.2142.i.i, double %.2155.i.i, double 0x3FA5555555555555)
  %.2157.i.i = tail call contract double @llvm.fma.f64(double %.2142.i.i, double %.2156.i.i, double -5.000000e-01)
  %.2158.i.i = tail call contract double @llvm.fma.f64(double %.2142.i.i, double %.2157.i.i, double 1.000000e+00)
  %.2159.i.i = bitcast double %.2110.i.i to i64
  %.2160.i.i = bitcast double %.2150.i.i to i64
  %.2161.i.i = bitcast double %.2158.i.i to i64
  %.2162.i.i = xor i64 %.2161.i.i, %.2160.i.i
  %.2163.i.i = and i64 %.2159.i.i, 1
  %84 = icmp eq i64 %.2163.i.i, 0
  %.2165.i.i = select i1 %84, i64 0, i64 %.2162.i.i
  %.2166.i.i = shl i64 %.2159.i.i, 62
  %.2167.i.i = and i64 %.2166.i.i, -9223372036854775808
  %.2169.i.i = add i64 %.2166.i.i, 4611686018427387904
  %.2170.i.i = and i64 %.2169.i.i, -9223372036854775808
  %85 = xor i64 %.2167.i.i, %.2160.i.i
  %.2172.i.i = xor i64 %85, %.2165.i.i
  %.2173.i.i = bitcast i64 %.2172.i.i to double
  %86 = xor i64 %.2170.i.i, %.2161.i.i
  %.2175.i.i = xor i64 %86, %.2165.i.i
  %.2176.i.i = bitcast i64 %.2175.i.i to double
  %.2204.i.i = fmul contract double %.2070.i.i, %.413.i.i
  %.2206.i.i = fmul contract double %.2204.i.i, %.413.i.i
  %.2209.i.i = fmul contract double %.413.i.i, %.413.i.i
  %.2210.i.i = fmul contract double %.2209.i.i, %.1903.i.i
  %.2211.i.i = fsub contract double %.2206.i.i, %.2210.i.i
  %.2213.i.i = fmul contract double %.410.i.i, 2.000000e+00
  %.2215.i.i = fmul contract double %.2213.i.i, %.413.i.i
  %.2216.i.i = fmul contract double %.2215.i.i, %.2039.i.i
  %.2218.i.i = fmul contract double %.410.i.i, -2.000000e+00
  %.2220.i.i = fmul contract double %.2218.i.i, %.413.i.i
  %.2221.i.i = fmul contract double %.2220.i.i, %.2064.i.i
  %.2224.i.i = fmul contract double %.410.i.i, %.410.i.i
  %.2225.i.i = fadd contract double %.2224.i.i, 1.000000e+00
  %.2226.i.i = fmul contract double %.2225.i.i, %.2072.i.i
  %.2231.i.i = fmul contract double %.2225.i.i, %.1986.i.i
  %.2251.i.i = fmul contract double %.413.i.i, -2.000000e+00
  %.2252.i.i = fmul contract double %.2251.i.i, %.2064.i.i
  %.2255.i.i = fmul contract double %.2251.i.i, %.2039.i.i
  %.2258.i.i = fmul contract double %.2213.i.i, %.1986.i.i
  %.2261.i.i = fmul contract double %.2218.i.i, %.2072.i.i
  %.2418.i.i = fmul contract double %.2211.i.i, %.2176.i.i
  %.2438.i.i = fmul contract double %.2173.i.i, 0.000000e+00
  %.2439.i.i = fadd contract double %.2418.i.i, %.2438.i.i
  %87 = getelementptr i8, ptr %lsr.iv131.i, i64 8
  store double %.2439.i.i, ptr %87, align 8, !noalias !21
  %.2490.i.i = fmul contract double %.2176.i.i, 0.000000e+00
  %.2510.i.i = fmul contract double %.2211.i.i, %.2173.i.i
  %.2511.i.i = fsub contract double %.2490.i.i, %.2510.i.i
  %88 = getelementptr i8, ptr %lsr.iv131.i, i64 48
  store double %.2511.i.i, ptr %88, align 8, !noalias !21
  %.2418.1.i.i = fmul contract double %.2216.i.i, %.2176.i.i
  %.2438.1.i.i = fmul contract double %.2252.i.i, %.2173.i.i
  %.2439.1.i.i = fadd contract double %.2418.1.i.i, %.2438.1.i.i
  %89 = getelementptr i8, ptr %lsr.iv131.i, i64 16
  store double %.2439.1.i.i, ptr %89, align 8, !noalias !21
  %.2490.1.i.i = fmul contract double %.2252.i.i, %.2176.i.i
  %.2510.1.i.i = fmul contract double %.2216.i.i, %.2173.i.i
  %.2511.1.i.i = fsub contract double %.2490.1.i.i, %.2510.1.i.i
  %90 = getelementptr i8, ptr %lsr.iv131.i, i64 56
  store double %.2511.1.i.i, ptr %90, align 8, !noalias !21
  %.2418.2.i.i = fmul contract double %.2221.i.i, %.2176.i.i
  %.2438.2.i.i = fmul contract double %.2255.i.i, %.2173.i.i
  %.2439.2.i.i = fadd contract double %.2418.2.i.i, %.2438.2.i.i
  %91 = getelementptr i8, ptr %lsr.iv131.i, i64 24
  store double %.2439.2.i.i, ptr %91, align 8, !noalias !21
  %.2490.2.i.i = fmul contract double %.2255.i.i, %.2176.i.i
  %.2510.2.i.i = fmul contract double %.2221.i.i, %.2173.i.i
  %.2511.2.i.i = fsub contract double %.2490.2.i.i, %.2510.2.i.i
  %92 = getelementptr i8, ptr %lsr.iv131.i, i64 64
  store double %.2511.2.i.i, ptr %92, align 8, !noalias !21
  %.2418.3.i.i = fmul contract double %.2226.i.i, %.2176.i.i
  %.2438.3.i.i = fmul contract double %.2258.i.i, %.2173.i.i
  %.2439.3.i.i = fadd contract double %.2418.3.i.i, %.2438.3.i.i
  %93 = getelementptr i8, ptr %lsr.iv131.i, i64 32
  store double %.2439.3.i.i, ptr %93, align 8, !noalias !21
  %.2490.3.i.i = fmul contract double %.2258.i.i, %.2176.i.i
  %.2510.3.i.i = fmul contract double %.2226.i.i, %.2173.i.i
  %.2511.3.i.i = fsub contract double %.2490.3.i.i, %.2510.3.i.i
  %94 = getelementptr i8, ptr %lsr.iv131.i, i64 72
  store double %.2511.3.i.i, ptr %94, align 8, !noalias !21
  %.2418.4.i.i = fmul contract double %.2231.i.i, %.2176.i.i
  %.2438.4.i.i = fmul contract double %.2261.i.i, %.2173.i.i
  %.2439.4.i.i = fadd contract double %.2418.4.i.i, %.2438.4.i.i
  %95 = getelementptr i8, ptr %lsr.iv131.i, i64 40
  store double %.2439.4.i.i, ptr %95, align 8, !noalias !21
  %.2490.4.i.i = fmul contract double %.2261.i.i, %.2176.i.i
  %.2510.4.i.i = fmul contract double %.2231.i.i, %.2173.i.i
  %.2511.4.i.i = fsub contract double %.2490.4.i.i, %.2510.4.i.i
  %96 = getelementptr i8, ptr %lsr.iv131.i, i64 80
  store double %.2511.4.i.i, ptr %96, align 8, !noalias !21
  %.2591.i.i = getelementptr i8, ptr %lsr.iv131.i, i64 104
  store i64 %.2175.i.i, ptr %.2591.i.i, align 8, !noalias !21
  %.2624.i.i = getelementptr i8, ptr %lsr.iv131.i, i64 112
  store i64 %.2172.i.i, ptr %.2624.i.i, align 8, !noalias !21
  %.2657.i.i = getelementptr i8, ptr %lsr.iv131.i, i64 120
  store i64 %.412.i.i, ptr %.2657.i.i, align 8, !noalias !21
  %.2690.i.i = getelementptr i8, ptr %lsr.iv131.i, i64 128
  store i64 %.409.i.i, ptr %.2690.i.i, align 8, !noalias !21
  %.2841.i.i = load double, ptr %.603.i, align 8, !noalias !21
  %97 = getelementptr i8, ptr %.603.i, i64 8
  %.2873.i.i = load double, ptr %97, align 8, !noalias !21
  %98 = getelementptr i8, ptr %.603.i, i64 16
  %.2905.i.i = load double, ptr %98, align 8, !noalias !21
  %.2929.i.i = fmul contract double %.2841.i.i, %.2841.i.i
  %.2932.i.i = fmul contract double %.2873.i.i, %.2873.i.i
  %.2933.i.i = fadd contract double %.2929.i.i, %.2932.i.i
  %.2942.i.i = fmul contract double %.2905.i.i, %.2905.i.i
  %.2943.i.i = fadd contract double %.2933.i.i, %.2942.i.i
  %.2951.i.i = tail call contract double @sqrt(double %.2943.i.i)
  %.2951.fr.i.i = freeze double %.2951.i.i
  %.2975.i.i = fcmp contract ogt double %.2951.fr.i.i, 0.000000e+00
  %.2981.i.i = fdiv contract double 1.000000e+00, %.2951.fr.i.i
  %"$phi1856.1.2.1.i.i" = select i1 %.2975.i.i, double %.2981.i.i, double 0.000000e+00
  %.3003.i.i = fmul contract double %cos_h.2.0.i.i, %.2841.i.i
  %99 = fmul contract double %sin_h.2.0.i.i, %.2873.i.i
  %.3007.i.i = fsub contract double %.3003.i.i, %99
  %.3016.i.i = fmul contract double %.2905.i.i, 0.000000e+00
  %.3017.i.i = fadd contract double %.3007.i.i, %.3016.i.i
  %.3018.i.i = fmul contract double %.3017.i.i, %"$phi1856.1.2.1.i.i"
  %.3030.i.i = fmul contract double %sin_h.2.0.i.i, %.2841.i.i
  %.3033.i.i = fmul contract double %cos_h.2.0.i.i, %.2873.i.i
  %.3034.i.i = fadd contract double %.3030.i.i, %.3033.i.i
  %.3044.i.i = fadd contract double %.3034.i.i, %.3016.i.i
  %.3045.i.i = fmul contract double %.3044.i.i, %"$phi1856.1.2.1.i.i"
  %.3075.i.i = getelementptr i8, ptr %lsr.iv131.i, i64 136
  store double %.3018.i.i, ptr %.3075.i.i, align 8, !noalias !21
  %.3107.i.i = getelementptr i8, ptr %lsr.iv131.i, i64 144
  store double %.3045.i.i, ptr %.3107.i.i, align 8, !noalias !21
  %.3116.i.i = fmul contract double %.2905.i.i, %"$phi1856.1.2.1.i.i"
  %.3121.i.i = fdiv contract double %.2951.fr.i.i, 0x41B1DE784A000000
  %.3154.i.i = getelementptr i8, ptr %lsr.iv131.i, i64 152
  store double %.3116.i.i, ptr %.3154.i.i, align 8, !noalias !21
  %.3188.i.i = getelementptr i8, ptr %lsr.iv131.i, i64 160
  store double %.3121.i.i, ptr %.3188.i.i, align 8, !noalias !21
  %100 = getelementptr i8, ptr %.603.i, i64 24
  %.2841.1.i.i = load double, ptr %100, align 8, !noalias !21
  %101 = getelementptr i8, ptr %.603.i, i64 32
  %.2873.1.i.i = load double, ptr %101, align 8, !noalias !21
  %102 = getelementptr i8, ptr %.603.i, i64 40
  %.2905.1.i.i = load double, ptr %102, align 8, !noalias !21
  %.2929.1.i.i = fmul contract double %.2841.1.i.i, %.2841.1.i.i
  %.2932.1.i.i = fmul contract double %.2873.1.i.i, %.2873.1.i.i
  %.2933.1.i.i = fadd contract double %.2929.1.i.i, %.2932.1.i.i
  %.2942.1.i.i = fmul contract double %.2905.1.i.i, %.2905.1.i.i
  %.2943.1.i.i = fadd contract double %.2933.1.i.i, %.2942.1.i.i
  %.2951.1.i.i = tail call contract double @sqrt(double %.2943.1.i.i)
  %.2951.1.fr.i.i = freeze double %.2951.1.i.i
  %.2975.1.i.i = fcmp contract ogt double %.2951.1.fr.i.i, 0.000000e+00
  %.2981.1.i.i = fdiv contract double 1.000000e+00, %.2951.1.fr.i.i
  %"$phi1856.1.2.1.1.i.i" = select i1 %.2975.1.i.i, double %.2981.1.i.i, double 0.000000e+00
  %.3003.1.i.i = fmul contract double %cos_h.2.0.i.i, %.2841.1.i.i
  %103 = fmul contract double %sin_h.2.0.i.i, %.2873.1.i.i
  %.3007.1.i.i = fsub contract double %.3003.1.i.i, %103
  %.3016.1.i.i = fmul contract double %.2905.1.i.i, 0.000000e+00
  %.3017.1.i.i = fadd contract double %.3007.1.i.i, %.3016.1.i.i
  %.3018.1.i.i = fmul contract double %.3017.1.i.i, %"$phi1856.1.2.1.1.i.i"
  %.3030.1.i.i = fmul contract double %sin_h.2.0.i.i, %.2841.1.i.i
  %.3033.1.i.i = fmul contract double %cos_h.2.0.i.i, %.2873.1.i.i
  %.3034.1.i.i = fadd contract double %.3030.1.i.i, %.3033.1.i.i
  %.3044.1.i.i = fadd contract double %.3034.1.i.i, %.3016.1.i.i
  %.3045.1.i.i = fmul contract double %.3044.1.i.i, %"$phi1856.1.2.1.1.i.i"
  %.3075.1.i.i = getelementptr i8, ptr %lsr.iv131.i, i64 168
  store double %.3018.1.i.i, ptr %.3075.1.i.i, align 8, !noalias !21
  %.3107.1.i.i = getelementptr i8, ptr %lsr.iv131.i, i64 176
  store double %.3045.1.i.i, ptr %.3107.1.i.i, align 8, !noalias !21
  %.3116.1.i.i = fmul contract double %.2905.1.i.i, %"$phi1856.1.2.1.1.i.i"
  %.3121.1.i.i = fdiv contract double %.2951.1.fr.i.i, 0x41B1DE784A000000
  %.3154.1.i.i = getelementptr i8, ptr %lsr.iv131.i, i64 184
  store double %.3116.1.i.i, ptr %.3154.1.i.i, align 8, !noalias !21
  %.3188.1.i.i = getelementptr i8, ptr %lsr.iv131.i, i64 192
  store double %.3121.1.i.i, ptr %.3188.1.i.i, align 8, !noalias !21
  %.102.i.i = load double, ptr %63, align 8, !noalias !24
  %.132.i.i41 = load double, ptr %.145.i.i, align 8, !noalias !24
  %.162.i.i = load double, ptr %.915, align 8, !noalias !24
  %.163.i.i = fmul contract double %.132.i.i41, %.162.i.i
  %.164.i.i = fadd contract double %.102.i.i, %.163.i.i
  %.194.i.i = load double, ptr %.840, align 8, !noalias !24
  %.195.i.i = fsub contract double %.164.i.i, %.194.i.i
  %.201.i.i = tail call contract double @llvm.fma.f64(double %.195.i.i, double 0x3FE45F306DC9C883, double 0x4338000000000000)
  %.202.i.i = fadd contract double %.201.i.i, 0xC338000000000000
  %.217.i.i = tail call contract double @llvm.fma.f64(double %.202.i.i, double 0xBFF921FB54442D18, double %.195.i.i)
  %.232.i.i = tail call contract double @llvm.fma.f64(double %.202.i.i, double 0xBC91A62633145C07, double %.217.i.i)
  %.233.i.i = fmul contract double %.232.i.i, %.232.i.i
  %.234.i.i = tail call contract double @llvm.fma.f64(double %.233.i.i, double 0xBD6AE7F3E733B81F, double 0x3DE6124613A86D09)
  %.235.i.i = tail call contract double @llvm.fma.f64(double %.233.i.i, double %.234.i.i, double 0xBE5AE64567F544E4)
  %.236.i.i = tail call contract double @llvm.fma.f64(double %.233.i.i, double %.235.i.i, double 0x3EC71DE3A556C734)
  %.237.i.i = tail call contract double @llvm.fma.f64(double %.233.i.i, double %.236.i.i, double 0xBF2A01A01A01A01A)
  %.238.i.i = tail call contract double @llvm.fma.f64(double %.233.i.i, double %.237.i.i, double 0x3F81111111111111)
  %.239.i.i = tail call contract double @llvm.fma.f64(double %.233.i.i, double %.238.i.i, double 0xBFC5555555555555)
  %.240.i.i = fmul contract double %.232.i.i, %.233.i.i
  %.241.i.i = tail call contract double @llvm.fma.f64(double %.240.i.i, double %.239.i.i, double %.232.i.i)
  %.242.i.i = tail call contract double @llvm.fma.f64(double %.233.i.i, double 0x3D2AE7F3E733B81F, double 0xBDA93974A8C07C9D)
  %.243.i.i = tail call contract double @llvm.fma.f64(double %.233.i.i, double %.242.i.i, double 0x3E21EED8EFF8D898)
  %.244.i.i42 = tail call contract double @llvm.fma.f64(double %.233.i.i, double %.243.i.i, double 0xBE927E4FB7789F5C)
  %.245.i.i = tail call contract double @llvm.fma.f64(double %.233.i.i, double %.244.i.i42, double 0x3EFA01A01A01A01A)
  %.246.i1.i = tail call contract double @llvm.fma.f64(double %.233.i.i, double %.245.i.i, double 0xBF56C16C16C16C17)
  %.247.i2.i = tail call contract double @llvm.fma.f64(double %.233.i.i, double %.246.i1.i, double 0x3FA5555555555555)
  %.248.i3.i = tail call contract double @llvm.fma.f64(double %.233.i.i, double %.247.i2.i, double -5.000000e-01)
  %.249.i4.i = tail call contract double @llvm.fma.f64(double %.233.i.i, double %.248.i3.i, double 1.000000e+00)
  %.250.i5.i = bitcast double %.201.i.i to i64
  %.251.i6.i = bitcast double %.241.i.i to i64
  %.252.i7.i = bitcast double %.249.i4.i to i64
  %.253.i8.i = xor i64 %.252.i7.i, %.251.i6.i
  %.254.i9.i = and i64 %.250.i5.i, 1
  %104 = icmp eq i64 %.254.i9.i, 0
  %.256.i10.i = select i1 %104, i64 0, i64 %.253.i8.i
  %.257.i11.i = shl i64 %.250.i5.i, 62
  %.258.i12.i = and i64 %.257.i11.i, -9223372036854775808
  %.260.i13.i = add i64 %.257.i11.i, 4611686018427387904
  %.261.i14.i = and i64 %.260.i13.i, -9223372036854775808
  %105 = xor i64 %.258.i12.i, %.251.i6.i
  %.263.i15.i = xor i64 %105, %.256.i10.i
  %.264.i16.i = bitcast i64 %.263.i15.i to double
  %106 = xor i64 %.261.i14.i, %.252.i7.i
  %.266.i17.i = xor i64 %106, %.256.i10.i
  %.267.i18.i = bitcast i64 %.266.i17.i to double
  %.332.i.i = load double, ptr %.345.i.i25, align 8, !noalias !24
  %.333.i.i = tail call contract double @llvm.fma.f64(double %.332.i.i, double 0x3FE45F306DC9C883, double 0x4338000000000000)
  %.334.i.i = fadd contract double %.333.i.i, 0xC338000000000000
  %.349.i.i = tail call contract double @llvm.fma.f64(double %.334.i.i, double 0xBFF921FB54442D18, double %.332.i.i)
  %.364.i.i = tail call contract double @llvm.fma.f64(double %.334.i.i, double 0xBC91A62633145C07, double %.349.i.i)
  %.365.i.i = fmul contract double %.364.i.i, %.364.i.i
  %.366.i.i = tail call contract double @llvm.fma.f64(double %.365.i.i, double 0xBD6AE7F3E733B81F, double 0x3DE6124613A86D09)
  %.367.i.i = tail call contract double @llvm.fma.f64(double %.365.i.i, double %.366.i.i, double 0xBE5AE64567F544E4)
  %.368.i.i = tail call contract double @llvm.fma.f64(double %.365.i.i, double %.367.i.i, double 0x3EC71DE3A556C734)
  %.369.i.i = tail call contract double @llvm.fma.f64(double %.365.i.i, double %.368.i.i, double 0xBF2A01A01A01A01A)
  %.370.i.i = tail call contract double @llvm.fma.f64(double %.365.i.i, double %.369.i.i, double 0x3F81111111111111)
  %.371.i.i = tail call contract double @llvm.fma.f64(double %.365.i.i, double %.370.i.i, double 0xBFC5555555555555)
  %.372.i.i = fmul contract double %.364.i.i, %.365.i.i
  %.373.i.i = tail call contract double @llvm.fma.f64(double %.372.i.i, double %.371.i.i, double %.364.i.i)
  %.374.i.i = tail call contract double @llvm.fma.f64(double %.365.i.i, double 0x3D2AE7F3E733B81F, double 0xBDA93974A8C07C9D)
  %.375.i.i43 = tail call contract double @llvm.fma.f64(double %.365.i.i, double %.374.i.i, double 0x3E21EED8EFF8D898)
  %.376.i.i = tail call contract double @llvm.fma.f64(double %.365.i.i, double %.375.i.i43, double 0xBE927E4FB7789F5C)
  %.377.i.i = tail call contract double @llvm.fma.f64(double %.365.i.i, double %.376.i.i, double 0x3EFA01A01A01A01A)
  %.378.i19.i = tail call contract double @llvm.fma.f64(double %.365.i.i, double %.377.i.i, double 0xBF56C16C16C16C17)
  %.379.i20.i = tail call contract double @llvm.fma.f64(double %.365.i.i, double %.378.i19.i, double 0x3FA5555555555555)
  %.380.i21.i = tail call contract double @llvm.fma.f64(double %.365.i.i, double %.379.i20.i, double -5.000000e-01)
  %.381.i22.i = tail call contract double @llvm.fma.f64(double %.365.i.i, double %.380.i21.i, double 1.000000e+00)
  %.382.i23.i = bitcast double %.333.i.i to i64
  %.383.i24.i = bitcast double %.373.i.i to i64
  %.384.i25.i = bitcast double %.381.i22.i to i64
  %.385.i26.i = xor i64 %.384.i25.i, %.383.i24.i
  %.386.i27.i = and i64 %.382.i23.i, 1
  %107 = icmp eq i64 %.386.i27.i, 0
  %.388.i28.i = select i1 %107, i64 0, i64 %.385.i26.i
  %.389.i29.i = shl i64 %.382.i23.i, 62
  %.390.i30.i = and i64 %.389.i29.i, -9223372036854775808
  %.392.i31.i = add i64 %.389.i29.i, 4611686018427387904
  %.393.i32.i = and i64 %.392.i31.i, -9223372036854775808
  %108 = xor i64 %.390.i30.i, %.383.i24.i
  %.395.i33.i = xor i64 %108, %.388.i28.i
  %.396.i34.i = bitcast i64 %.395.i33.i to double
  %109 = xor i64 %.393.i32.i, %.384.i25.i
  %.398.i35.i = xor i64 %109, %.388.i28.i
  %.399.i36.i = bitcast i64 %.398.i35.i to double
  %.454.i.i44 = load double, ptr %.522.i, align 8, !noalias !24
  %.483.i.i = load double, ptr %.496.i.i, align 8, !noalias !24
  %.512.i.i = load double, ptr %.525.i.i, align 8, !noalias !24
  %.568.i37.i = getelementptr i8, ptr %lsr.iv.i26, i64 104
  tail call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(16) %.568.i37.i, i8 0, i64 16, i1 false), !noalias !24
  br i1 %.542.i.i, label %B344.i.i, label %_ZN17bnserve_inference14adjoint_kernel9_response13fill_geometryB3v43B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i

B344.i.i:                                         ; preds = %_ZN17bnserve_inference13moving_kernel9_response12coefficientsB3v24B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i
  %.599.i.i = getelementptr i8, ptr %lsr.iv.i26, i64 112
  %.606.i.i = fmul contract double %.454.i.i44, %.267.i18.i
  %.610.i53.i = fmul contract double %.483.i.i, %.264.i16.i
  %.611.i54.i = fsub contract double %.606.i.i, %.610.i53.i
  %.615.i.i = fmul contract double %.454.i.i44, %.264.i16.i
  %.621.i.i = fmul contract double %.483.i.i, %.267.i18.i
  %.624.i.i = fadd contract double %.615.i.i, %.621.i.i
  %.626.i55.i = fmul contract double %.611.i54.i, %.399.i36.i
  %.630.i.i = fmul contract double %.512.i.i, %.396.i34.i
  %.631.i.i = fadd contract double %.630.i.i, %.626.i55.i
  %.636.i.i = fdiv contract double %.631.i.i, 0x41B1DE784A000000
  %.638.i.i = fmul contract double %.624.i.i, %.399.i36.i
  %.642.i56.i = fdiv contract double %.638.i.i, 0x41B1DE784A000000
  store double %.642.i56.i, ptr %.568.i37.i, align 8, !noalias !24
  %.674.i.i = fmul contract double %.611.i54.i, %.396.i34.i
  %.678.i.i = fmul contract double %.512.i.i, %.399.i36.i
  %.679.i.i = fsub contract double %.674.i.i, %.678.i.i
  %.683.i.i = fdiv contract double %.679.i.i, 0x41B1DE784A000000
  store double %.683.i.i, ptr %.599.i.i, align 8, !noalias !24
  %.745.i.i = load double, ptr %.145.i.i, align 8, !noalias !24
  %.751.i.i = fmul contract double %.636.i.i, %.745.i.i
  %110 = fsub contract double %.195.i.i, %.751.i.i
  %.756.i.i = tail call contract double @llvm.fma.f64(double %110, double 0x3FE45F306DC9C883, double 0x4338000000000000)
  %.757.i.i = fadd contract double %.756.i.i, 0xC338000000000000
  %.772.i.i54 = tail call contract double @llvm.fma.f64(double %.757.i.i, double 0xBFF921FB54442D18, double %110)
  %.787.i.i = tail call contract double @llvm.fma.f64(double %.757.i.i, double 0xBC91A62633145C07, double %.772.i.i54)
  %.788.i57.i = fmul contract double %.787.i.i, %.787.i.i
  %.789.i58.i = tail call contract double @llvm.fma.f64(double %.788.i57.i, double 0xBD6AE7F3E733B81F, double 0x3DE6124613A86D09)
  %.790.i.i = tail call contract double @llvm.fma.f64(double %.788.i57.i, double %.789.i58.i, double 0xBE5AE64567F544E4)
  %.791.i59.i = tail call contract double @llvm.fma.f64(double %.788.i57.i, double %.790.i.i, double 0x3EC71DE3A556C734)
  %.792.i.i = tail call contract double @llvm.fma.f64(double %.788.i57.i, double %.791.i59.i, double 0xBF2A01A01A01A01A)
  %.793.i.i = tail call contract double @llvm.fma.f64(double %.788.i57.i, double %.792.i.i, double 0x3F81111111111111)
  %.794.i.i = tail call contract double @llvm.fma.f64(double %.788.i57.i, double %.793.i.i, double 0xBFC5555555555555)
  %.795.i60.i = fmul contract double %.787.i.i, %.788.i57.i
  %.796.i61.i = tail call contract double @llvm.fma.f64(double %.795.i60.i, double %.794.i.i, double %.787.i.i)
  %.797.i.i = tail call contract double @llvm.fma.f64(double %.788.i57.i, double 0x3D2AE7F3E733B81F, double 0xBDA93974A8C07C9D)
  %.798.i.i = tail call contract double @llvm.fma.f64(double %.788.i57.i, double %.797.i.i, double 0x3E21EED8EFF8D898)
  %.799.i.i = tail call contract double @llvm.fma.f64(double %.788.i57.i, double %.798.i.i, double 0xBE927E4FB7789F5C)
  %.800.i.i = tail call contract double @llvm.fma.f64(double %.788.i57.i, double %.799.i.i, double 0x3EFA01A01A01A01A)
  %.801.i62.i = tail call contract double @llvm.fma.f64(double %.788.i57.i, double %.800.i.i, double 0xBF56C16C16C16C17)
  %.802.i.i = tail call contract double @llvm.fma.f64(double %.788.i57.i, double %.801.i62.i, double 0x3FA5555555555555)
  %.803.i.i = tail call contract double @llvm.fma.f64(double %.788.i57.i, double %.802.i.i, double -5.000000e-01)
  %.804.i.i = tail call contract double @llvm.fma.f64(double %.788.i57.i, double %.803.i.i, double 1.000000e+00)
  %.805.i.i = bitcast double %.756.i.i to i64
  %.806.i.i = bitcast double %.796.i61.i to i64
  %.807.i.i = bitcast double %.804.i.i to i64
  %.808.i.i = xor i64 %.807.i.i, %.806.i.i
  %.809.i.i = and i64 %.805.i.i, 1
  %111 = icmp eq i64 %.809.i.i, 0
  %.811.i.i = select i1 %111, i64 0, i64 %.808.i.i
  %.812.i.i = shl i64 %.805.i.i, 62
  %.813.i.i = and i64 %.812.i.i, -9223372036854775808
  %.815.i.i = add i64 %.812.i.i, 4611686018427387904
  %.816.i.i = and i64 %.815.i.i, -9223372036854775808
  %112 = xor i64 %.813.i.i, %.806.i.i
  %.818.i.i = xor i64 %112, %.811.i.i
  %.819.i.i = bitcast i64 %.818.i.i to double
  %113 = xor i64 %.816.i.i, %.807.i.i
  %.821.i.i = xor i64 %113, %.811.i.i
  %.822.i.i = bitcast i64 %.821.i.i to double
  br label %_ZN17bnserve_inference14adjoint_kernel9_response13fill_geometryB3v43B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i

_ZN17bnserve_inference14adjoint_kernel9_response13fill_geometryB3v43B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i: ; preds = %B344.i.i, %_ZN17bnserve_inference13moving_kernel9_response12coefficientsB3v24B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i
  %sin_h.2.0.i38.i = phi double [ %.819.i.i, %B344.i.i ], [ %.264.i16.i, %_ZN17bnserve_inference13moving_kernel9_response12coefficientsB3v24B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i ]
  %cos_h.2.0.i39.i = phi double [ %.822.i.i, %B344.i.i ], [ %.267.i18.i, %_ZN17bnserve_inference13moving_kernel9_response12coefficientsB3v24B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i ]
  %.908.i.i = fmul contract double %.454.i.i44, %cos_h.2.0.i39.i
  %114 = fmul contract double %.483.i.i, %sin_h.2.0.i38.i
  %.912.i.i45 = fsub contract double %.908.i.i, %114
  %.921.i.i46 = fmul contract double %.512.i.i, 0.000000e+00
  %.922.i.i47 = fadd contract double %.921.i.i46, %.912.i.i45
  %.924.i40.i = fmul contract double %.922.i.i47, %.396.i34.i
  %.928.i.i = fmul contract double %.512.i.i, %.399.i36.i
  %.929.i.i = fsub contract double %.924.i40.i, %.928.i.i
  %.933.i.i = fdiv contract double %.929.i.i, 0x41B1DE784A000000
  %.962.i.i48 = getelementptr i8, ptr %lsr.iv.i26, i64 80
  store double %.933.i.i, ptr %.962.i.i48, align 8, !noalias !24
  %.965.i.i = fneg contract double %.396.i34.i
  %.991.i.i = fmul contract double %.922.i.i47, %.965.i.i
  %.995.i.i = fdiv contract double %.991.i.i, 0x41B1DE784A000000
  %.1024.i.i = getelementptr i8, ptr %lsr.iv.i26, i64 88
  store double %.995.i.i, ptr %.1024.i.i, align 8, !noalias !24
  %.1043.i.i = fmul contract double %.454.i.i44, %sin_h.2.0.i38.i
  %.1046.i.i = fmul contract double %.483.i.i, %cos_h.2.0.i39.i
  %.1047.i.i = fadd contract double %.1043.i.i, %.1046.i.i
  %.1057.i.i = fadd contract double %.921.i.i46, %.1047.i.i
  %.1058.i.i = fmul contract double %.1057.i.i, %.965.i.i
  %.1062.i.i = fdiv contract double %.1058.i.i, 0x41B1DE784A000000
  %.1091.i.i = getelementptr i8, ptr %lsr.iv.i26, i64 96
  store double %.1062.i.i, ptr %.1091.i.i, align 8, !noalias !24
  %.1129.i.i = load double, ptr %.441.i, align 8, !noalias !24
  %.1131.i.i = fmul contract double %cos_h.2.0.i39.i, %.1129.i.i
  %.1160.i.i = load double, ptr %.1028.i.i, align 8, !noalias !24
  %115 = fmul contract double %sin_h.2.0.i38.i, %.1160.i.i
  %.1163.i.i = fsub contract double %.1131.i.i, %115
  %.1192.i.i = load double, ptr %.1060.i.i, align 8, !noalias !24
  %.1194.i.i = fmul contract double %.1192.i.i, 0.000000e+00
  %.1195.i.i = fadd contract double %.1163.i.i, %.1194.i.i
  %.1224.i.i = load double, ptr %.1092.i.i, align 8, !noalias !24
  %.1226.i.i = fmul contract double %cos_h.2.0.i39.i, %.1224.i.i
  %.1255.i.i = load double, ptr %.1123.i.i, align 8, !noalias !24
  %116 = fmul contract double %sin_h.2.0.i38.i, %.1255.i.i
  %.1258.i.i = fsub contract double %.1226.i.i, %116
  %.1287.i.i = load double, ptr %.1155.i.i, align 8, !noalias !24
  %.1289.i.i = fmul contract double %.1287.i.i, 0.000000e+00
  %.1290.i.i = fadd contract double %.1258.i.i, %.1289.i.i
  %.1319.i.i = load double, ptr %.1187.i.i, align 8, !noalias !24
  %.1321.i.i = fmul contract double %cos_h.2.0.i39.i, %.1319.i.i
  %.1350.i44.i = load double, ptr %.1218.i.i, align 8, !noalias !24
  %117 = fmul contract double %sin_h.2.0.i38.i, %.1350.i44.i
  %.1353.i.i = fsub contract double %.1321.i.i, %117
  %.1382.i45.i = load double, ptr %.1250.i.i, align 8, !noalias !24
  %.1390.i.i49 = fmul contract double %.1382.i45.i, 0.000000e+00
  %.1391.i.i50 = fadd contract double %.1353.i.i, %.1390.i.i49
  %.1448.i.i = fmul contract double %sin_h.2.0.i38.i, %.1129.i.i
  %.1479.i.i = fmul contract double %cos_h.2.0.i39.i, %.1160.i.i
  %.1480.i.i = fadd contract double %.1448.i.i, %.1479.i.i
  %.1512.i.i = fadd contract double %.1480.i.i, %.1194.i.i
  %.1543.i.i = fmul contract double %sin_h.2.0.i38.i, %.1224.i.i
  %.1574.i.i = fmul contract double %cos_h.2.0.i39.i, %.1255.i.i
  %.1575.i.i = fadd contract double %.1543.i.i, %.1574.i.i
  %.1607.i.i = fadd contract double %.1575.i.i, %.1289.i.i
  %.1638.i.i = fmul contract double %sin_h.2.0.i38.i, %.1319.i.i
  %.1669.i.i = fmul contract double %cos_h.2.0.i39.i, %.1350.i44.i
  %.1670.i.i = fadd contract double %.1638.i.i, %.1669.i.i
  %.1708.i.i = fadd contract double %.1670.i.i, %.1390.i.i49
  %.1773.i.i = fmul contract double %.1129.i.i, 0.000000e+00
  %.1804.i.i = fmul contract double %.1160.i.i, 0.000000e+00
  %.1805.i.i = fadd contract double %.1773.i.i, %.1804.i.i
  %.1837.i.i = fadd contract double %.1192.i.i, %.1805.i.i
  %.1868.i.i = fmul contract double %.1224.i.i, 0.000000e+00
  %.1899.i.i = fmul contract double %.1255.i.i, 0.000000e+00
  %.1900.i.i = fadd contract double %.1868.i.i, %.1899.i.i
  %.1932.i.i = fadd contract double %.1287.i.i, %.1900.i.i
  %.1963.i.i = fmul contract double %.1319.i.i, 0.000000e+00
  %.1994.i.i = fmul contract double %.1350.i44.i, 0.000000e+00
  %.1995.i.i = fadd contract double %.1963.i.i, %.1994.i.i
  %.2033.i.i = fadd contract double %.1382.i45.i, %.1995.i.i
  %.2076.i.i = fmul contract double %cos_h.2.0.i39.i, %.1195.i.i
  %118 = fmul contract double %sin_h.2.0.i38.i, %.1290.i.i
  %.2080.i.i = fsub contract double %.2076.i.i, %118
  %.2089.i.i = fmul contract double %.1391.i.i50, 0.000000e+00
  %.2090.i.i = fadd contract double %.2080.i.i, %.2089.i.i
  %.2100.i.i = fmul contract double %cos_h.2.0.i39.i, %.1512.i.i
  %119 = fmul contract double %sin_h.2.0.i38.i, %.1607.i.i
  %.2104.i.i = fsub contract double %.2100.i.i, %119
  %.2113.i.i = fmul contract double %.1708.i.i, 0.000000e+00
  %.2114.i.i = fadd contract double %.2104.i.i, %.2113.i.i
  %.2127.i.i = fmul contract double %sin_h.2.0.i38.i, %.1512.i.i
  %.2130.i.i = fmul contract double %cos_h.2.0.i39.i, %.1607.i.i
  %.2131.i.i = fadd contract double %.2127.i.i, %.2130.i.i
  %.2141.i46.i = fadd contract double %.2131.i.i, %.2113.i.i
  %.2154.i47.i = fmul contract double %cos_h.2.0.i39.i, %.1837.i.i
  %120 = fmul contract double %sin_h.2.0.i38.i, %.1932.i.i
  %.2158.i48.i = fsub contract double %.2154.i47.i, %120
  %.2167.i49.i = fmul contract double %.2033.i.i, 0.000000e+00
  %.2168.i.i = fadd contract double %.2158.i48.i, %.2167.i49.i
  %.2181.i.i = fmul contract double %sin_h.2.0.i38.i, %.1837.i.i
  %.2184.i.i = fmul contract double %cos_h.2.0.i39.i, %.1932.i.i
  %.2185.i.i = fadd contract double %.2181.i.i, %.2184.i.i
  %.2195.i.i = fadd contract double %.2185.i.i, %.2167.i49.i
  %.2200.i.i = fadd contract double %.2090.i.i, %.2141.i46.i
  %.2201.i.i = fmul contract double %.2200.i.i, 5.000000e-01
  %.2202.i.i = fsub contract double %.2141.i46.i, %.2090.i.i
  %.2203.i.i = fmul contract double %.2202.i.i, 5.000000e-01
  %.2206.i50.i = fmul contract double %.399.i36.i, %.399.i36.i
  %.2209.i51.i = fmul contract double %.396.i34.i, %.396.i34.i
  %.2210.i52.i = fsub contract double %.2206.i50.i, %.2209.i51.i
  %.2241.i.i = load double, ptr %.2102.i.i, align 8, !noalias !24
  %.2247.i.i = fmul contract double %.2241.i.i, 2.000000e+00
  %.2248.i.i = tail call contract double @llvm.fma.f64(double %.2247.i.i, double 0x3FE45F306DC9C883, double 0x4338000000000000)
  %.2249.i.i = fadd contract double %.2248.i.i, 0xC338000000000000
  %.2264.i.i = tail call contract double @llvm.fma.f64(double %.2249.i.i, double 0xBFF921FB54442D18, double %.2247.i.i)
  %.2279.i.i = tail call contract double @llvm.fma.f64(double %.2249.i.i, double 0xBC91A62633145C07, double %.2264.i.i)
  %.2280.i.i = fmul contract double %.2279.i.i, %.2279.i.i
  %.2281.i.i = tail call contract double @llvm.fma.f64(double %.2280.i.i, double 0xBD6AE7F3E733B81F, double 0x3DE6124613A86D09)
  %.2282.i.i = tail call contract double @llvm.fma.f64(double %.2280.i.i, double %.2281.i.i, double 0xBE5AE64567F544E4)
  %.2283.i.i = tail call contract double @llvm.fma.f64(double %.2280.i.i, double %.2282.i.i, double 0x3EC71DE3A556C734)
  %.2284.i.i = tail call contract double @llvm.fma.f64(double %.2280.i.i, double %.2283.i.i, double 0xBF2A01A01A01A01A)
  %.2285.i.i = tail call contract double @llvm.fma.f64(double %.2280.i.i, double %.2284.i.i, double 0x3F81111111111111)
  %.2286.i.i = tail call contract double @llvm.fma.f64(double %.2280.i.i, double %.2285.i.i, double 0xBFC5555555555555)
  %.2287.i.i = fmul contract double %.2279.i.i, %.2280.i.i
  %.2288.i.i = tail call contract double @llvm.fma.f64(double %.2287.i.i, double %.2286.i.i, double %.2279.i.i)
  %.2289.i.i = tail call contract double @llvm.fma.f64(double %.2280.i.i, double 0x3D2AE7F3E733B81F, double 0xBDA93974A8C07C9D)
  %.2290.i.i = tail call contract double @llvm.fma.f64(double %.2280.i.i, double %.2289.i.i, double 0x3E21EED8EFF8D898)
  %.2291.i.i = tail call contract double @llvm.fma.f64(double %.2280.i.i, double %.2290.i.i, double 0xBE927E4FB7789F5C)
  %.2292.i.i = tail call contract double @llvm.fma.f64(double %.2280.i.i, double %.2291.i.i, double 0x3EFA01A01A01A01A)
  %.2293.i.i = tail call contract double @llvm.fma.f64(double %.2280.i.i, double %.2292.i.i, double 0xBF56C16C16C16C17)
  %.2294.i.i = tail call contract double @llvm.fma.f64(double %.2280.i.i, double %.2293.i.i, double 0x3FA5555555555555)
  %.2295.i.i = tail call contract double @llvm.fma.f64(double %.2280.i.i, double %.2294.i.i, double -5.000000e-01)
  %.2296.i.i = tail call contract double @llvm.fma.f64(double %.2280.i.i, double %.2295.i.i, double 1.000000e+00)
  %.2297.i.i = bitcast double %.2248.i.i to i64
  %.2298.i.i = bitcast double %.2288.i.i to i64
  %.2299.i.i = bitcast double %.2296.i.i to i64
  %.2300.i.i = xor i64 %.2299.i.i, %.2298.i.i
  %.2301.i.i = and i64 %.2297.i.i, 1
  %121 = icmp eq i64 %.2301.i.i, 0
  %.2303.i.i = select i1 %121, i64 0, i64 %.2300.i.i
  %.2304.i.i = shl i64 %.2297.i.i, 62
  %.2305.i.i = and i64 %.2304.i.i, -9223372036854775808
  %.2307.i.i = add i64 %.2304.i.i, 4611686018427387904
  %.2308.i.i = and i64 %.2307.i.i, -9223372036854775808
  %122 = xor i64 %.2305.i.i, %.2298.i.i
  %.2310.i.i = xor i64 %122, %.2303.i.i
  %.2311.i.i = bitcast i64 %.2310.i.i to double
  %123 = xor i64 %.2308.i.i, %.2299.i.i
  %.2313.i.i = xor i64 %123, %.2303.i.i
  %.2314.i.i = bitcast i64 %.2313.i.i to double
  %.2342.i.i = fmul contract double %.396.i34.i, -2.000000e+00
  %.2344.i.i = fmul contract double %.2342.i.i, %.399.i36.i
  %.2345.i.i = fsub contract double %.2201.i.i, %.2033.i.i
  %.2346.i.i = fmul contract double %.2344.i.i, %.2345.i.i
  %.2347.i.i = fmul contract double %.2210.i52.i, 2.000000e+00
  %.2348.i.i = fmul contract double %.2347.i.i, %.2168.i.i
  %.2349.i.i = fmul contract double %.2210.i52.i, -2.000000e+00
  %.2350.i.i = fmul contract double %.2349.i.i, %.2195.i.i
  %.2352.i.i = fmul contract double %.396.i34.i, 2.000000e+00
  %.2354.i.i = fmul contract double %.2352.i.i, %.399.i36.i
  %.2355.i.i = fmul contract double %.2354.i.i, %.2203.i.i
  %.2360.i.i = fmul contract double %.2354.i.i, %.2114.i.i
  %.2381.i.i = fmul contract double %.2352.i.i, %.2195.i.i
  %.2386.i.i = fmul contract double %.2352.i.i, %.2168.i.i
  %.2388.i.i = fmul contract double %.399.i36.i, 2.000000e+00
  %.2389.i.i = fmul contract double %.2388.i.i, %.2114.i.i
  %.2391.i.i = fmul contract double %.399.i36.i, -2.000000e+00
  %.2394.i.i = fmul contract double %.2391.i.i, %.2203.i.i
  %.2551.i.i = fmul contract double %.2346.i.i, %.2314.i.i
  %.2571.i.i = fmul contract double %.2311.i.i, 0.000000e+00
  %.2572.i.i = fadd contract double %.2551.i.i, %.2571.i.i
  store double %.2572.i.i, ptr %lsr.iv.i26, align 8, !noalias !24
  %.2623.i.i = fmul contract double %.2314.i.i, 0.000000e+00
  %.2643.i.i = fmul contract double %.2346.i.i, %.2311.i.i
  %.2644.i.i = fsub contract double %.2623.i.i, %.2643.i.i
  %124 = getelementptr i8, ptr %lsr.iv.i26, i64 40
  store double %.2644.i.i, ptr %124, align 8, !noalias !24
  %.2551.1.i.i = fmul contract double %.2348.i.i, %.2314.i.i
  %.2571.1.i.i = fmul contract double %.2381.i.i, %.2311.i.i
  %.2572.1.i.i = fadd contract double %.2551.1.i.i, %.2571.1.i.i
  %125 = getelementptr i8, ptr %lsr.iv.i26, i64 8
  store double %.2572.1.i.i, ptr %125, align 8, !noalias !24
  %.2623.1.i.i = fmul contract double %.2381.i.i, %.2314.i.i
  %.2643.1.i.i = fmul contract double %.2348.i.i, %.2311.i.i
  %.2644.1.i.i = fsub contract double %.2623.1.i.i, %.2643.1.i.i
  %126 = getelementptr i8, ptr %lsr.iv.i26, i64 48
  store double %.2644.1.i.i, ptr %126, align 8, !noalias !24
  %.2551.2.i.i = fmul contract double %.2350.i.i, %.2314.i.i
  %.2571.2.i.i = fmul contract double %.2386.i.i, %.2311.i.i
  %.2572.2.i.i = fadd contract double %.2551.2.i.i, %.2571.2.i.i
  %127 = getelementptr i8, ptr %lsr.iv.i26, i64 16
  store double %.2572.2.i.i, ptr %127, align 8, !noalias !24
  %.2623.2.i.i = fmul contract double %.2386.i.i, %.2314.i.i
  %.2643.2.i.i = fmul contract double %.2350.i.i, %.2311.i.i
  %.2644.2.i.i = fsub contract double %.2623.2.i.i, %.2643.2.i.i
  %128 = getelementptr i8, ptr %lsr.iv.i26, i64 56
  store double %.2644.2.i.i, ptr %128, align 8, !noalias !24
  %.2551.3.i.i = fmul contract double %.2355.i.i, %.2314.i.i
  %.2571.3.i.i = fmul contract double %.2389.i.i, %.2311.i.i
  %.2572.3.i.i = fadd contract double %.2551.3.i.i, %.2571.3.i.i
  %129 = getelementptr i8, ptr %lsr.iv.i26, i64 24
  store double %.2572.3.i.i, ptr %129, align 8, !noalias !24
  %.2623.3.i.i = fmul contract double %.2389.i.i, %.2314.i.i
  %.2643.3.i.i = fmul contract double %.2355.i.i, %.2311.i.i
  %.2644.3.i.i = fsub contract double %.2623.3.i.i, %.2643.3.i.i
  %130 = getelementptr i8, ptr %lsr.iv.i26, i64 64
  store double %.2644.3.i.i, ptr %130, align 8, !noalias !24
  %.2551.4.i.i = fmul contract double %.2360.i.i, %.2314.i.i
  %.2571.4.i.i = fmul contract double %.2394.i.i, %.2311.i.i
  %.2572.4.i.i = fadd contract double %.2551.4.i.i, %.2571.4.i.i
  %131 = getelementptr i8, ptr %lsr.iv.i26, i64 32
  store double %.2572.4.i.i, ptr %131, align 8, !noalias !24
  %.2623.4.i.i = fmul contract double %.2394.i.i, %.2314.i.i
  %.2643.4.i.i = fmul contract double %.2360.i.i, %.2311.i.i
  %.2644.4.i.i = fsub contract double %.2623.4.i.i, %.2643.4.i.i
  %132 = getelementptr i8, ptr %lsr.iv.i26, i64 72
  store double %.2644.4.i.i, ptr %132, align 8, !noalias !24
  %133 = getelementptr i8, ptr %lsr.iv.i26, i64 120
  tail call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(32) %133, i8 0, i64 32, i1 false), !noalias !24
  %scevgep.i51 = getelementptr i8, ptr %lsr.iv.i26, i64 152
  %scevgep132.i = getelementptr i8, ptr %lsr.iv131.i, i64 200
  %lsr.iv.next.i52 = add i64 %lsr.iv133.i, 48
  %lsr.iv.next135.i = add i64 %lsr.iv134.i, 24
  %lsr.iv.next137.i = add i64 %lsr.iv136.i, 72
  %lsr.iv.next139.i = add nsw i64 %lsr.iv138.i, -1
  %exitcond.not.i53 = icmp eq i64 %lsr.iv.next139.i, 0
  br i1 %exitcond.not.i53, label %_ZN17bnserve_inference14adjoint_kernel7_source6_placeB3v16B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit, label %B268.if.i

_ZN17bnserve_inference14adjoint_kernel7_source6_placeB3v16B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit: ; preds = %_ZN17bnserve_inference14adjoint_kernel9_response13fill_geometryB3v43B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i, %B666.if
  %.50.i = load i64, ptr %.76, align 8, !noalias !27
  %.80.i57 = load i64, ptr %.140, align 8, !noalias !27
  %.110.i = load i64, ptr %.106, align 8, !noalias !27
  %.122.i = sub i64 0, %.80.i57
  %.130.1.i = and i64 %.122.i, -8
  %.164.i = sub i64 0, %.130.1.i
  %.194.i = load i64, ptr %.193.i58, align 8, !noalias !27
  %.228.i = load i64, ptr %.227.i, align 8, !noalias !27
  %.229.i = shl i64 %.7709701030, 3
  %.231.i = mul i64 %.194.i, %.229.i
  %.232.i = add nsw i64 %.231.i, %.228.i
  %.293.i = icmp sgt i64 %.194.i, 0
  br i1 %.293.i, label %_ZN17bnserve_inference13moving_kernel8_passing12find_passingB3v59B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIxLi1E1C7mutable7alignedE.exit, label %B288.i

B288.i:                                           ; preds = %_ZN17bnserve_inference14adjoint_kernel7_source6_placeB3v16B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit
  %.373.i = shl i64 %.80.i57, 1
  %.640.i = mul nsw i64 %.50.i, %.164.i
  %.10071109.not.i = icmp slt i64 %.50.i, 1
  br i1 %.10071109.not.i, label %_ZN17bnserve_inference13moving_kernel8_passing12find_passingB3v59B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIxLi1E1C7mutable7alignedE.exit, label %B766.if.lr.ph.i

B1206.i:                                          ; preds = %B1088.if.i, %_ZN17bnserve_inference13moving_kernel8_passing6_turnsB3v74B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedExx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i
  br i1 %157, label %B1254.i, label %B1238.if.preheader.i

B1238.if.preheader.i:                             ; preds = %B1206.i
  br i1 %172, label %B1238.if.prol.loopexit.i, label %B1238.if.prol.i

B1238.if.prol.i:                                  ; preds = %B1238.if.preheader.i, %B1238.if.prol.i
  %prol.iter.i = phi i64 [ %prol.iter.next.i, %B1238.if.prol.i ], [ 0, %B1238.if.preheader.i ]
  %134 = add i64 %prol.iter.i, %.80.i57
  %.1964.prol.i = icmp slt i64 %134, 0
  %135 = select i1 %.1964.prol.i, i64 %sunkaddr217.i, i64 0
  %scevgep200.i = getelementptr i8, ptr %lsr.iv198.i, i64 %135
  %136 = shl nuw nsw i64 %prol.iter.i, 3
  %scevgep24.i = getelementptr i8, ptr %scevgep200.i, i64 %136
  store double 0.000000e+00, ptr %scevgep24.i, align 8, !noalias !27
  %prol.iter.next.i = add nuw nsw i64 %prol.iter.i, 1
  %prol.iter.cmp.not.i = icmp eq i64 %xtraiter.i, %prol.iter.next.i
  br i1 %prol.iter.cmp.not.i, label %B1238.if.prol.loopexit.loopexit.i, label %B1238.if.prol.i, !llvm.loop !30

B1238.if.prol.loopexit.loopexit.i:                ; preds = %B1238.if.prol.i
  %137 = sub nsw i64 %..1870.i, %prol.iter.next.i
  %138 = add i64 %prol.iter.next.i, %.80.i57
  br label %B1238.if.prol.loopexit.i

B1238.if.prol.loopexit.i:                         ; preds = %B1238.if.prol.loopexit.loopexit.i, %B1238.if.preheader.i
  %.191210641068.unr.i = phi i64 [ %..1870.i, %B1238.if.preheader.i ], [ %137, %B1238.if.prol.loopexit.loopexit.i ]
  %.191910651067.unr.i = phi i64 [ %.80.i57, %B1238.if.preheader.i ], [ %138, %B1238.if.prol.loopexit.loopexit.i ]
  br i1 %173, label %B1254.i, label %B1238.if.preheader179.i

B1238.if.preheader179.i:                          ; preds = %B1238.if.prol.loopexit.i
  %139 = add i64 %.191210641068.unr.i, 4
  br label %B1238.if.i

B1254.i:                                          ; preds = %B1238.if.i, %B1238.if.prol.loopexit.i, %B1206.i
  %scevgep181.i = getelementptr i8, ptr %lsr.iv180.i, i64 %144
  %scevgep192.i = getelementptr i8, ptr %lsr.iv191.i, i64 %144
  %lsr.iv.next196.i = sub i64 %lsr.iv195.i, %.130.1.i
  %scevgep199.i = getelementptr i8, ptr %lsr.iv198.i, i64 %144
  %scevgep205.i = getelementptr i8, ptr %lsr.iv204.i, i64 %144
  %exitcond1157.not.i = icmp eq i64 %.1020.i, %.50.i
  br i1 %exitcond1157.not.i, label %_ZN17bnserve_inference13moving_kernel8_passing12find_passingB3v59B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIxLi1E1C7mutable7alignedE.exit, label %B766.if.i60

B766.if.lr.ph.i:                                  ; preds = %B288.i
  %.548.i = load i64, ptr %.547.i, align 8, !noalias !27
  %.460.i = load i64, ptr %.459.i, align 8, !noalias !27
  %.362.i = load i64, ptr %.361.i, align 8, !noalias !27
  %.364.i = shl i64 %.7709701030, 4
  %.366.i = mul i64 %.364.i, %.80.i57
  %.368.i = mul i64 %.366.i, %.110.i
  %.371.i = add nsw i64 %.362.i, %.368.i
  %.725.i = load i64, ptr %.724.i, align 8, !noalias !27
  %.637.i = load i64, ptr %.636.i, align 8, !noalias !27
  %140 = inttoptr i64 %.725.i to ptr
  %141 = inttoptr i64 %.637.i to ptr
  %142 = inttoptr i64 %.232.i to ptr
  %.1129.i = getelementptr inbounds double, ptr %142, i64 %.640.i
  %.1550.i = add i64 %.80.i57, -1
  %.1870.i = sub i64 %.164.i, %.80.i57
  %..1870.i = tail call i64 @llvm.smax.i64(i64 %.1870.i, i64 0)
  %xtraiter.i = and i64 %..1870.i, 3
  %scevgep.i59 = getelementptr i8, ptr %142, i64 8
  %143 = lshr i64 %.122.i, 3
  %144 = mul i64 %143, -64
  %145 = shl i64 %143, 6
  %146 = sub i64 8, %145
  %scevgep183.i = getelementptr i8, ptr %140, i64 %146
  %147 = shl i64 %.50.i, 6
  %148 = mul i64 %147, %143
  %149 = sub i64 8, %148
  %scevgep185.i = getelementptr i8, ptr %142, i64 %149
  %scevgep190.i = getelementptr i8, ptr %141, i64 8
  %150 = shl i64 %.80.i57, 3
  %scevgep197.i = getelementptr i8, ptr %142, i64 %150
  %sunkaddr217.i = shl i64 %.164.i, 3
  %151 = shl i64 %.640.i, 3
  %152 = inttoptr i64 %.548.i to ptr
  %153 = inttoptr i64 %.460.i to ptr
  %154 = inttoptr i64 %.371.i to ptr
  %.176508.not.i.i = icmp slt i64 %.80.i57, 1
  %.369527.not.i.i = icmp slt i64 %.110.i, 1
  %.1171.i.i = icmp slt i64 %.80.i57, 2
  %..1133.i.i = select i1 %.1171.i.i, i64 0, i64 %.1550.i
  %.1213538.i.i = icmp sgt i64 %..1133.i.i, 0
  %.1406.inv.i.i = icmp sgt i64 %.80.i57, 0
  %.1407.i.i = select i1 %.1406.inv.i.i, i64 0, i64 %.164.i
  %155 = getelementptr double, ptr %.1129.i, i64 %.1550.i
  %.1421.i.i = getelementptr double, ptr %155, i64 %.1407.i.i
  %156 = icmp slt i64 %.1550.i, 1
  %sunkaddr31.i = getelementptr inbounds i8, ptr %140, i64 %sunkaddr217.i
  %157 = icmp slt i64 %.1870.i, 1
  %xtraiter.i.i = and i64 %.80.i57, 3
  %158 = icmp ult i64 %.80.i57, 4
  %159 = add nsw i64 %.80.i57, -4
  %160 = lshr i64 %159, 2
  %161 = icmp eq i64 %160, 0
  %162 = add nuw nsw i64 %160, 1
  %163 = and i64 %162, 9223372036854775806
  %164 = and i64 %159, 4
  %lcmp.mod.not9.not.i.i = icmp eq i64 %164, 0
  %lcmp.mod.not.i.i = icmp eq i64 %xtraiter.i.i, 0
  %165 = tail call i64 @llvm.smax.i64(i64 %.80.i57, i64 1)
  %166 = add nsw i64 %165, -1
  %167 = shl i64 %.80.i57, 4
  %factor.op.mul.i = shl i64 %.80.i57, 4
  %.375.reass.i = mul i64 %factor.op.mul.i, %.110.i
  %168 = add i64 %.375.reass.i, 16
  %169 = add i64 %.375.reass.i, 24
  %170 = icmp sgt i64 %.80.i57, 1
  %171 = or disjoint i64 %.375.reass.i, 8
  %172 = icmp eq i64 %xtraiter.i, 0
  %173 = icmp slt i64 %.1870.i, 4
  br label %B766.if.i60

B766.if.i60:                                      ; preds = %B766.if.lr.ph.i, %B1254.i
  %lsr.iv204.i = phi ptr [ %142, %B766.if.lr.ph.i ], [ %scevgep205.i, %B1254.i ]
  %lsr.iv198.i = phi ptr [ %scevgep197.i, %B766.if.lr.ph.i ], [ %scevgep199.i, %B1254.i ]
  %lsr.iv195.i = phi i64 [ 1, %B766.if.lr.ph.i ], [ %lsr.iv.next196.i, %B1254.i ]
  %lsr.iv191.i = phi ptr [ %scevgep190.i, %B766.if.lr.ph.i ], [ %scevgep192.i, %B1254.i ]
  %lsr.iv180.i = phi ptr [ %scevgep.i59, %B766.if.lr.ph.i ], [ %scevgep181.i, %B1254.i ]
  %.101310761114.i = phi i64 [ 0, %B766.if.lr.ph.i ], [ %.1020.i, %B1254.i ]
  %.1020.i = add nuw nsw i64 %.101310761114.i, 1
  %.1051.i = mul nsw i64 %.101310761114.i, %.164.i
  %.1063.i = getelementptr inbounds double, ptr %142, i64 %.1051.i
  %.1200.i = shl nuw nsw i64 %.101310761114.i, 1
  %.1202.i = mul nsw i64 %.1200.i, %.164.i
  %.1214.i61 = getelementptr inbounds double, ptr %152, i64 %.1202.i
  %.1268.neg.i = xor i64 %.1200.i, -1
  %.1270.i = mul i64 %.130.1.i, %.1268.neg.i
  %.1282.i = getelementptr inbounds double, ptr %152, i64 %.1270.i
  br i1 %.176508.not.i.i, label %B60.i.i, label %B34.if.preheader.i.i

B34.if.preheader.i.i:                             ; preds = %B766.if.i60
  br i1 %158, label %B34.if.epil.preheader.i.i, label %B34.if.preheader.new.i.i

B34.if.preheader.new.i.i:                         ; preds = %B34.if.preheader.i.i
  br i1 %161, label %B34.if.epil.preheader1.i.i, label %B34.if.i.i

B60.loopexit.unr-lcssa.unr-lcssa.i.i:             ; preds = %B34.if.i.i
  br i1 %lcmp.mod.not9.not.i.i, label %B34.if.epil.preheader1.i.i, label %B60.loopexit.unr-lcssa.i.i

B34.if.epil.preheader1.i.i:                       ; preds = %B60.loopexit.unr-lcssa.unr-lcssa.i.i, %B34.if.preheader.new.i.i
  %.182507509.epil.init5.i.i = phi i64 [ 0, %B34.if.preheader.new.i.i ], [ %.189.3.1.i.i, %B60.loopexit.unr-lcssa.unr-lcssa.i.i ]
  %sunkaddr.epil.i.i = shl i64 %.182507509.epil.init5.i.i, 3
  %sunkaddr50.epil.i.i = getelementptr i8, ptr %.1063.i, i64 %sunkaddr.epil.i.i
  store double 0.000000e+00, ptr %sunkaddr50.epil.i.i, align 8, !noalias !32
  %sunkaddr52.epil.i.i = getelementptr i8, ptr %.1129.i, i64 %sunkaddr.epil.i.i
  store double 0.000000e+00, ptr %sunkaddr52.epil.i.i, align 8, !noalias !32
  %sunkaddr55.epil.i.i = getelementptr i8, ptr %sunkaddr50.epil.i.i, i64 8
  store double 0.000000e+00, ptr %sunkaddr55.epil.i.i, align 8, !noalias !32
  %sunkaddr58.epil.i.i = getelementptr i8, ptr %sunkaddr52.epil.i.i, i64 8
  store double 0.000000e+00, ptr %sunkaddr58.epil.i.i, align 8, !noalias !32
  %sunkaddr61.epil.i.i = getelementptr i8, ptr %sunkaddr50.epil.i.i, i64 16
  store double 0.000000e+00, ptr %sunkaddr61.epil.i.i, align 8, !noalias !32
  %sunkaddr64.epil.i.i = getelementptr i8, ptr %sunkaddr52.epil.i.i, i64 16
  store double 0.000000e+00, ptr %sunkaddr64.epil.i.i, align 8, !noalias !32
  %.189.3.epil.i.i = add nuw nsw i64 %.182507509.epil.init5.i.i, 4
  %sunkaddr67.epil.i.i = getelementptr i8, ptr %sunkaddr50.epil.i.i, i64 24
  store double 0.000000e+00, ptr %sunkaddr67.epil.i.i, align 8, !noalias !32
  %sunkaddr70.epil.i.i = getelementptr i8, ptr %sunkaddr52.epil.i.i, i64 24
  store double 0.000000e+00, ptr %sunkaddr70.epil.i.i, align 8, !noalias !32
  br label %B60.loopexit.unr-lcssa.i.i

B60.loopexit.unr-lcssa.i.i:                       ; preds = %B34.if.epil.preheader1.i.i, %B60.loopexit.unr-lcssa.unr-lcssa.i.i
  %.189.3.lcssa.i.i = phi i64 [ %.189.3.epil.i.i, %B34.if.epil.preheader1.i.i ], [ %.189.3.1.i.i, %B60.loopexit.unr-lcssa.unr-lcssa.i.i ]
  br i1 %lcmp.mod.not.i.i, label %B60.i.i, label %B34.if.epil.preheader.i.i

B34.if.epil.preheader.i.i:                        ; preds = %B60.loopexit.unr-lcssa.i.i, %B34.if.preheader.i.i
  %.182507509.epil.init.i.i = phi i64 [ 0, %B34.if.preheader.i.i ], [ %.189.3.lcssa.i.i, %B60.loopexit.unr-lcssa.i.i ]
  %174 = shl i64 %.182507509.epil.init.i.i, 3
  %scevgep30.i.i64 = getelementptr i8, ptr %.1129.i, i64 %174
  %scevgep32.i.i = getelementptr i8, ptr %.1063.i, i64 %174
  br label %B34.if.epil.i.i

B34.if.epil.i.i:                                  ; preds = %B34.if.epil.i.i, %B34.if.epil.preheader.i.i
  %epil.iter.i.i = phi i64 [ %epil.iter.next.i.i, %B34.if.epil.i.i ], [ 0, %B34.if.epil.preheader.i.i ]
  %175 = shl i64 %epil.iter.i.i, 3
  %scevgep42.i.i65 = getelementptr i8, ptr %scevgep32.i.i, i64 %175
  store double 0.000000e+00, ptr %scevgep42.i.i65, align 8, !noalias !32
  %scevgep41.i.i66 = getelementptr i8, ptr %scevgep30.i.i64, i64 %175
  store double 0.000000e+00, ptr %scevgep41.i.i66, align 8, !noalias !32
  %epil.iter.next.i.i = add i64 %epil.iter.i.i, 1
  %epil.iter.cmp.not.i.i = icmp eq i64 %xtraiter.i.i, %epil.iter.next.i.i
  br i1 %epil.iter.cmp.not.i.i, label %B60.i.i, label %B34.if.epil.i.i, !llvm.loop !35

B60.i.i:                                          ; preds = %B34.if.epil.i.i, %B60.loopexit.unr-lcssa.i.i, %B766.if.i60
  br i1 %.369527.not.i.i, label %B682.i.i, label %B112.if.i.i

B678.i.i:                                         ; preds = %B196.if.i.i, %B112.if.i.i
  %lsr.iv.next8.i.i = add i64 %lsr.iv7.i.i, %.373.i
  %scevgep14.i.i = getelementptr i8, ptr %lsr.iv13.i.i, i64 %167
  %exitcond544.not.i.i = icmp eq i64 %.382.i.i67, %.110.i
  br i1 %exitcond544.not.i.i, label %B682.i.i, label %B112.if.i.i

B682.i.i:                                         ; preds = %B678.i.i, %B60.i.i
  br i1 %.1213538.i.i, label %B718.if.i.i, label %_ZN17bnserve_inference13moving_kernel8_passing6_turnsB3v74B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedExx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i

B34.if.i.i:                                       ; preds = %B34.if.preheader.new.i.i, %B34.if.i.i
  %lsr.iv23.i.i62 = phi i64 [ %lsr.iv.next24.i.i63, %B34.if.i.i ], [ %163, %B34.if.preheader.new.i.i ]
  %.182507509.i.i = phi i64 [ %.189.3.1.i.i, %B34.if.i.i ], [ 0, %B34.if.preheader.new.i.i ]
  %sunkaddr64.i.i = shl i64 %.182507509.i.i, 3
  %sunkaddr65.i.i = getelementptr i8, ptr %.1063.i, i64 %sunkaddr64.i.i
  store double 0.000000e+00, ptr %sunkaddr65.i.i, align 8, !noalias !32
  %sunkaddr67.i.i = getelementptr i8, ptr %.1129.i, i64 %sunkaddr64.i.i
  store double 0.000000e+00, ptr %sunkaddr67.i.i, align 8, !noalias !32
  %sunkaddr69.i.i = getelementptr i8, ptr %sunkaddr65.i.i, i64 8
  store double 0.000000e+00, ptr %sunkaddr69.i.i, align 8, !noalias !32
  %sunkaddr72.i.i = getelementptr i8, ptr %sunkaddr67.i.i, i64 8
  store double 0.000000e+00, ptr %sunkaddr72.i.i, align 8, !noalias !32
  %sunkaddr75.i.i = getelementptr i8, ptr %sunkaddr65.i.i, i64 16
  store double 0.000000e+00, ptr %sunkaddr75.i.i, align 8, !noalias !32
  %sunkaddr78.i.i = getelementptr i8, ptr %sunkaddr67.i.i, i64 16
  store double 0.000000e+00, ptr %sunkaddr78.i.i, align 8, !noalias !32
  %sunkaddr81.i.i = getelementptr i8, ptr %sunkaddr65.i.i, i64 24
  store double 0.000000e+00, ptr %sunkaddr81.i.i, align 8, !noalias !32
  %sunkaddr84.i.i = getelementptr i8, ptr %sunkaddr67.i.i, i64 24
  store double 0.000000e+00, ptr %sunkaddr84.i.i, align 8, !noalias !32
  %sunkaddr87.i.i = getelementptr i8, ptr %sunkaddr65.i.i, i64 32
  store double 0.000000e+00, ptr %sunkaddr87.i.i, align 8, !noalias !32
  %sunkaddr90.i.i = getelementptr i8, ptr %sunkaddr67.i.i, i64 32
  store double 0.000000e+00, ptr %sunkaddr90.i.i, align 8, !noalias !32
  %sunkaddr93.i.i = getelementptr i8, ptr %sunkaddr65.i.i, i64 40
  store double 0.000000e+00, ptr %sunkaddr93.i.i, align 8, !noalias !32
  %sunkaddr96.i.i = getelementptr i8, ptr %sunkaddr67.i.i, i64 40
  store double 0.000000e+00, ptr %sunkaddr96.i.i, align 8, !noalias !32
  %sunkaddr99.i.i = getelementptr i8, ptr %sunkaddr65.i.i, i64 48
  store double 0.000000e+00, ptr %sunkaddr99.i.i, align 8, !noalias !32
  %sunkaddr102.i.i = getelementptr i8, ptr %sunkaddr67.i.i, i64 48
  store double 0.000000e+00, ptr %sunkaddr102.i.i, align 8, !noalias !32
  %.189.3.1.i.i = add i64 %.182507509.i.i, 8
  %sunkaddr103.i.i = shl i64 %.189.3.1.i.i, 3
  %sunkaddr104.i.i = getelementptr i8, ptr %.1063.i, i64 %sunkaddr103.i.i
  %sunkaddr106.i.i = getelementptr i8, ptr %sunkaddr104.i.i, i64 -8
  store double 0.000000e+00, ptr %sunkaddr106.i.i, align 8, !noalias !32
  %sunkaddr108.i.i = getelementptr i8, ptr %.1129.i, i64 %sunkaddr103.i.i
  %sunkaddr109.i.i = getelementptr i8, ptr %sunkaddr108.i.i, i64 -8
  store double 0.000000e+00, ptr %sunkaddr109.i.i, align 8, !noalias !32
  %lsr.iv.next24.i.i63 = add i64 %lsr.iv23.i.i62, -2
  %niter.ncmp.1.i.i = icmp eq i64 %lsr.iv.next24.i.i63, 0
  br i1 %niter.ncmp.1.i.i, label %B60.loopexit.unr-lcssa.unr-lcssa.i.i, label %B34.if.i.i

B112.if.i.i:                                      ; preds = %B60.i.i, %B678.i.i
  %lsr.iv13.i.i = phi ptr [ %scevgep14.i.i, %B678.i.i ], [ %154, %B60.i.i ]
  %lsr.iv7.i.i = phi i64 [ %lsr.iv.next8.i.i, %B678.i.i ], [ 0, %B60.i.i ]
  %.375520530.i.i = phi i64 [ %.382.i.i67, %B678.i.i ], [ 0, %B60.i.i ]
  %.382.i.i67 = add nuw nsw i64 %.375520530.i.i, 1
  %176 = getelementptr i64, ptr %153, i64 %.375520530.i.i
  %.440.i.i = load i64, ptr %176, align 8, !noalias !32
  %.442.i.i = icmp eq i64 %.440.i.i, %.101310761114.i
  %or.cond.i.i = and i1 %170, %.442.i.i
  br i1 %or.cond.i.i, label %B196.if.i.i, label %B678.i.i

B196.if.i.i:                                      ; preds = %B112.if.i.i, %B196.if.i.i
  %lsr.iv3.i.i83 = phi i64 [ %lsr.iv.next4.i.i, %B196.if.i.i ], [ 0, %B112.if.i.i ]
  %lsr.iv.i.i84 = phi i64 [ %lsr.iv.next.i.i105, %B196.if.i.i ], [ %166, %B112.if.i.i ]
  %sunkaddr110.i.i = shl i64 %lsr.iv3.i.i83, 2
  %sunkaddr111.i.i = getelementptr i8, ptr %.1214.i61, i64 %sunkaddr110.i.i
  %sunkaddr112.i.i = getelementptr i8, ptr %sunkaddr111.i.i, i64 8
  %.602.i.i = load double, ptr %sunkaddr112.i.i, align 8, !noalias !32
  %.632.i.i = load double, ptr %sunkaddr111.i.i, align 8, !noalias !32
  %.633.i.i = fmul contract double %.602.i.i, %.632.i.i
  %sunkaddr116.i.i = getelementptr i8, ptr %.1282.i, i64 %sunkaddr110.i.i
  %sunkaddr117.i.i = getelementptr i8, ptr %sunkaddr116.i.i, i64 8
  %.664.i.i = load double, ptr %sunkaddr117.i.i, align 8, !noalias !32
  %.694.i.i = load double, ptr %sunkaddr116.i.i, align 8, !noalias !32
  %.695.i.i = fmul contract double %.664.i.i, %.694.i.i
  %.696.i.i = fadd contract double %.633.i.i, %.695.i.i
  %.758.i.i = fmul contract double %.602.i.i, %.694.i.i
  %.820.i.i = fmul contract double %.632.i.i, %.664.i.i
  %.821.i.i85 = fsub contract double %.758.i.i, %.820.i.i
  %177 = add i64 %lsr.iv3.i.i83, %lsr.iv7.i.i
  %.839.i.i = icmp slt i64 %177, -2
  %178 = shl i64 %lsr.iv3.i.i83, 3
  %179 = select i1 %.839.i.i, i64 %168, i64 16
  %scevgep39.i.i86 = getelementptr i8, ptr %lsr.iv13.i.i, i64 %179
  %scevgep40.i.i = getelementptr i8, ptr %scevgep39.i.i86, i64 %178
  %.855.i.i = load double, ptr %scevgep40.i.i, align 8, !noalias !32
  %.873.i.i = icmp slt i64 %177, -3
  %180 = select i1 %.873.i.i, i64 %169, i64 24
  %scevgep37.i.i = getelementptr i8, ptr %lsr.iv13.i.i, i64 %180
  %scevgep22.i.i = getelementptr i8, ptr %scevgep37.i.i, i64 %178
  %.889.i.i = load double, ptr %scevgep22.i.i, align 8, !noalias !32
  %.906.i.i = icmp slt i64 %177, 0
  %181 = select i1 %.906.i.i, i64 %171, i64 8
  %scevgep19.i.i87 = getelementptr i8, ptr %lsr.iv13.i.i, i64 %181
  %scevgep20.i.i = getelementptr i8, ptr %scevgep19.i.i87, i64 %178
  %scevgep21.i.i88 = getelementptr i8, ptr %scevgep20.i.i, i64 -8
  %.922.i.i89 = load double, ptr %scevgep21.i.i88, align 8, !noalias !32
  %.956.i.i90 = load double, ptr %scevgep20.i.i, align 8, !noalias !32
  %.957.i.i91 = fmul contract double %.855.i.i, %.922.i.i89
  %.958.i.i = fmul contract double %.889.i.i, %.956.i.i90
  %.959.i.i92 = fadd contract double %.957.i.i91, %.958.i.i
  %.960.i.i93 = fmul contract double %.889.i.i, %.922.i.i89
  %.961.i.i = fmul contract double %.855.i.i, %.956.i.i90
  %.962.i.i94 = fsub contract double %.960.i.i93, %.961.i.i
  %.963.i.i = fmul contract double %.696.i.i, %.959.i.i92
  %.964.i.i95 = fmul contract double %.821.i.i85, %.962.i.i94
  %.965.i.i96 = fsub contract double %.963.i.i, %.964.i.i95
  %.966.i.i97 = fmul contract double %.821.i.i85, %.959.i.i92
  %.967.i.i98 = fmul contract double %.696.i.i, %.962.i.i94
  %.968.i.i = fadd contract double %.966.i.i97, %.967.i.i98
  %scevgep5.i.i = getelementptr i8, ptr %.1063.i, i64 %sunkaddr110.i.i
  %.998.i.i99 = load double, ptr %scevgep5.i.i, align 8, !noalias !32
  %.999.i.i = fmul contract double %.965.i.i96, %.965.i.i96
  %.1000.i.i100 = fmul contract double %.968.i.i, %.968.i.i
  %.1001.i.i = fsub contract double %.999.i.i, %.1000.i.i100
  %.1002.i.i = fadd contract double %.998.i.i99, %.1001.i.i
  store double %.1002.i.i, ptr %scevgep5.i.i, align 8, !noalias !32
  %scevgep4.i.i101 = getelementptr i8, ptr %.1129.i, i64 %sunkaddr110.i.i
  %.1062.i.i102 = load double, ptr %scevgep4.i.i101, align 8, !noalias !32
  %.1063.i.i103 = fmul contract double %.965.i.i96, 2.000000e+00
  %.1064.i.i104 = fmul contract double %.968.i.i, %.1063.i.i103
  %.1065.i.i = fadd contract double %.1062.i.i102, %.1064.i.i104
  store double %.1065.i.i, ptr %scevgep4.i.i101, align 8, !noalias !32
  %lsr.iv.next.i.i105 = add nsw i64 %lsr.iv.i.i84, -1
  %lsr.iv.next4.i.i = add nuw i64 %lsr.iv3.i.i83, 2
  %exitcond543.not.i.i = icmp eq i64 %lsr.iv.next.i.i105, 0
  br i1 %exitcond543.not.i.i, label %B678.i.i, label %B196.if.i.i

B718.if.i.i:                                      ; preds = %B682.i.i, %B718.if.i.i
  %.1219537539.i.i = phi i64 [ %.1226.i.i73, %B718.if.i.i ], [ 0, %B682.i.i ]
  %.1226.i.i73 = add nuw nsw i64 %.1219537539.i.i, 1
  %182 = shl i64 %.1219537539.i.i, 3
  %scevgep2.i.i = getelementptr i8, ptr %.1063.i, i64 %182
  %.1281.i.i = load double, ptr %scevgep2.i.i, align 8, !noalias !32
  %scevgep.i.i74 = getelementptr i8, ptr %.1129.i, i64 %182
  %.1311.i.i = load double, ptr %scevgep.i.i74, align 8, !noalias !32
  %.1312.i.i = fmul contract double %.1281.i.i, %.1281.i.i
  %.1313.i.i = fmul contract double %.1311.i.i, %.1311.i.i
  %.1314.i.i = fadd contract double %.1312.i.i, %.1313.i.i
  %.1315.i.i = tail call contract double @llvm.sqrt.f64(double %.1314.i.i)
  %.1316.i.i = fadd contract double %.1281.i.i, %.1315.i.i
  %.1317.i.i = fadd contract double %.1316.i.i, 1.000000e-300
  %.1321.i.i75 = fdiv contract double %.1311.i.i, %.1317.i.i
  %.1322.i.i = fmul contract double %.1321.i.i75, %.1321.i.i75
  %.1323.i.i = fadd contract double %.1322.i.i, 1.000000e+00
  %.1324.i.i = tail call contract double @llvm.sqrt.f64(double %.1323.i.i)
  %.1325.i.i = fadd contract double %.1324.i.i, 1.000000e+00
  %.1329.i.i76 = fdiv contract double %.1321.i.i75, %.1325.i.i
  %.1330.i.i77 = fmul contract double %.1329.i.i76, %.1329.i.i76
  %.1331.i.i = fmul contract double %.1330.i.i77, 0x3F677AE9349F5F7A
  %.1332.i.i = fadd contract double %.1331.i.i, 0xBF908DC039C4DC63
  %.1333.i.i = fmul contract double %.1330.i.i77, %.1332.i.i
  %.1334.i.i = fadd contract double %.1333.i.i, 0x3FA5F83FB7E8F47D
  %.1335.i.i = fmul contract double %.1330.i.i77, %.1334.i.i
  %.1336.i.i = fadd contract double %.1335.i.i, 0xBFB3462E8D8711AD
  %.1337.i.i = fmul contract double %.1330.i.i77, %.1336.i.i
  %.1338.i.i = fadd contract double %.1337.i.i, 0x3FBB47B06AC4D989
  %.1339.i.i = fmul contract double %.1330.i.i77, %.1338.i.i
  %.1340.i.i78 = fadd contract double %.1339.i.i, 0xBFC22FF8E008E644
  %.1341.i.i79 = fmul contract double %.1330.i.i77, %.1340.i.i78
  %.1342.i.i80 = fadd contract double %.1341.i.i79, 0x3FC9977C9B288755
  %.1343.i.i81 = fmul contract double %.1330.i.i77, %.1342.i.i80
  %.1344.i.i82 = fadd contract double %.1343.i.i81, 0xBFD5554D72204448
  %.1345.i.i = fmul contract double %.1330.i.i77, %.1344.i.i82
  %.1346.i.i = fadd contract double %.1345.i.i, 1.000000e+00
  %.1347.i.i = fmul contract double %.1329.i.i76, 2.000000e+00
  %.1348.i.i = fmul contract double %.1347.i.i, %.1346.i.i
  store double %.1348.i.i, ptr %scevgep.i.i74, align 8, !noalias !32
  %exitcond545.not.i.i = icmp eq i64 %..1133.i.i, %.1226.i.i73
  br i1 %exitcond545.not.i.i, label %_ZN17bnserve_inference13moving_kernel8_passing6_turnsB3v74B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedExx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i, label %B718.if.i.i

_ZN17bnserve_inference13moving_kernel8_passing6_turnsB3v74B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedExx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i: ; preds = %B718.if.i.i, %B682.i.i
  store double 0.000000e+00, ptr %.1421.i.i, align 8, !noalias !32
  %.1404.i = icmp slt i64 %.1051.i, 0
  %.1405.i = select i1 %.1404.i, i64 %.640.i, i64 0
  %183 = getelementptr double, ptr %141, i64 %.1051.i
  %.1419.i = getelementptr double, ptr %183, i64 %.1405.i
  %.1420.i = load double, ptr %.1419.i, align 8, !noalias !27
  %.1450.i = load double, ptr %sunkaddr31.i, align 8, !noalias !27
  %.1480.i = load double, ptr %.1129.i, align 8, !noalias !27
  %.1481.i = fmul contract double %.1450.i, %.1480.i
  %.1482.i = fsub contract double %.1420.i, %.1481.i
  store double %.1482.i, ptr %.1063.i, align 8, !noalias !27
  br i1 %156, label %B1206.i, label %B1088.if.i

B1088.if.i:                                       ; preds = %_ZN17bnserve_inference13moving_kernel8_passing6_turnsB3v74B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedExx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i, %B1088.if.i
  %lsr.iv.i68 = phi i64 [ %lsr.iv.next.i71, %B1088.if.i ], [ 0, %_ZN17bnserve_inference13moving_kernel8_passing6_turnsB3v74B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedExx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i ]
  %184 = add i64 %lsr.iv.i68, %lsr.iv195.i
  %.1648.i = icmp slt i64 %184, 0
  %185 = select i1 %.1648.i, i64 %151, i64 0
  %scevgep193.i = getelementptr i8, ptr %lsr.iv191.i, i64 %185
  %186 = shl i64 %lsr.iv.i68, 3
  %scevgep194.i = getelementptr i8, ptr %scevgep193.i, i64 %186
  %.1664.i = load double, ptr %scevgep194.i, align 8, !noalias !27
  %sunkaddr32.i = getelementptr i8, ptr %140, i64 %186
  %sunkaddr33.i = getelementptr i8, ptr %sunkaddr32.i, i64 8
  %.1694.i = load double, ptr %sunkaddr33.i, align 8, !noalias !27
  %scevgep20.i = getelementptr i8, ptr %scevgep185.i, i64 %186
  %scevgep21.i69 = getelementptr i8, ptr %scevgep20.i, i64 -8
  %.1725.i = load double, ptr %scevgep21.i69, align 8, !noalias !27
  %.1726.i = fmul contract double %.1694.i, %.1725.i
  %scevgep12.i = getelementptr i8, ptr %scevgep183.i, i64 %186
  %.1756.i = load double, ptr %scevgep12.i, align 8, !noalias !27
  %.1786.i = load double, ptr %scevgep20.i, align 8, !noalias !27
  %.1787.i = fmul contract double %.1756.i, %.1786.i
  %.1788.i = fadd contract double %.1726.i, %.1787.i
  %.1789.i = fsub contract double %.1664.i, %.1788.i
  %scevgep11.i70 = getelementptr i8, ptr %lsr.iv180.i, i64 %186
  store double %.1789.i, ptr %scevgep11.i70, align 8, !noalias !27
  %lsr.iv.next.i71 = add nuw nsw i64 %lsr.iv.i68, 1
  %exitcond.not.i72 = icmp eq i64 %.1550.i, %lsr.iv.next.i71
  br i1 %exitcond.not.i72, label %B1206.i, label %B1088.if.i

B1238.if.i:                                       ; preds = %B1238.if.i, %B1238.if.preheader179.i
  %lsr.iv202.i = phi i64 [ %139, %B1238.if.preheader179.i ], [ %lsr.iv.next203.i, %B1238.if.i ]
  %.191910651067.i = phi i64 [ %.191910651067.unr.i, %B1238.if.preheader179.i ], [ %195, %B1238.if.i ]
  %.1964.i = icmp slt i64 %.191910651067.i, 0
  %187 = select i1 %.1964.i, i64 %sunkaddr217.i, i64 0
  %scevgep212.i = getelementptr i8, ptr %lsr.iv204.i, i64 %187
  %188 = shl i64 %.191910651067.i, 3
  %scevgep213.i = getelementptr i8, ptr %scevgep212.i, i64 %188
  store double 0.000000e+00, ptr %scevgep213.i, align 8, !noalias !27
  %189 = add i64 %.191910651067.i, 1
  %.1964.1.i = icmp slt i64 %189, 0
  %190 = select i1 %.1964.1.i, i64 %sunkaddr217.i, i64 0
  %scevgep214.i = getelementptr i8, ptr %lsr.iv204.i, i64 %190
  %scevgep29.i = getelementptr i8, ptr %scevgep214.i, i64 %188
  %scevgep30.i = getelementptr i8, ptr %scevgep29.i, i64 8
  store double 0.000000e+00, ptr %scevgep30.i, align 8, !noalias !27
  %191 = add i64 %.191910651067.i, 2
  %.1964.2.i = icmp slt i64 %191, 0
  %192 = select i1 %.1964.2.i, i64 %sunkaddr217.i, i64 0
  %scevgep209.i = getelementptr i8, ptr %lsr.iv204.i, i64 %192
  %scevgep27.i = getelementptr i8, ptr %scevgep209.i, i64 %188
  %scevgep28.i = getelementptr i8, ptr %scevgep27.i, i64 16
  store double 0.000000e+00, ptr %scevgep28.i, align 8, !noalias !27
  %193 = add i64 %.191910651067.i, 3
  %.1964.3.i = icmp slt i64 %193, 0
  %194 = select i1 %.1964.3.i, i64 %sunkaddr217.i, i64 0
  %scevgep206.i = getelementptr i8, ptr %lsr.iv204.i, i64 %194
  %scevgep25.i = getelementptr i8, ptr %scevgep206.i, i64 %188
  %scevgep26.i = getelementptr i8, ptr %scevgep25.i, i64 24
  store double 0.000000e+00, ptr %scevgep26.i, align 8, !noalias !27
  %lsr.iv.next203.i = add i64 %lsr.iv202.i, -4
  %.1913.3.i = icmp sgt i64 %lsr.iv.next203.i, 4
  %195 = add i64 %.191910651067.i, 4
  br i1 %.1913.3.i, label %B1238.if.i, label %B1254.i

_ZN17bnserve_inference13moving_kernel8_passing12find_passingB3v59B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIxLi1E1C7mutable7alignedE.exit: ; preds = %B1254.i, %B288.i, %_ZN17bnserve_inference14adjoint_kernel7_source6_placeB3v16B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit
  %.961.sroa.12.1 = inttoptr i64 %.232.i to ptr
  br i1 %.1084949.not, label %B1254, label %B918.if.preheader

B918.if.preheader:                                ; preds = %_ZN17bnserve_inference13moving_kernel8_passing12find_passingB3v59B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIxLi1E1C7mutable7alignedE.exit
  %.268.i.i220 = shl i64 %.7709701030, 4
  br label %B918.if

B918.if:                                          ; preds = %B918.if.preheader, %_ZN17bnserve_inference14adjoint_kernel7_source11_block_backB4v460B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit
  %.1083927953 = phi i64 [ %.1093, %_ZN17bnserve_inference14adjoint_kernel7_source11_block_backB4v460B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit ], [ %.1063, %B918.if.preheader ]
  %.1090933952 = phi i64 [ %.1097, %_ZN17bnserve_inference14adjoint_kernel7_source11_block_backB4v460B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit ], [ 0, %B918.if.preheader ]
  %.1093 = add nsw i64 %.1083927953, -1
  %.1097 = add i64 %.1090933952, 128
  %.1127 = sub nsw i64 %.184, %.1090933952
  %.13.i = tail call i64 @llvm.smin.i64(i64 %.1127, i64 128)
  %.79.i107 = load i64, ptr %.106, align 8, !noalias !36
  %.108.i109 = load i64, ptr %.76, align 8, !noalias !36
  %.137.i = load i64, ptr %.140, align 8, !noalias !36
  %.173.i = load i64, ptr %.172.i, align 8, !noalias !36
  %.175.i110 = shl i64 %.79.i107, 4
  %.177.i = mul i64 %.175.i110, %.7709701030
  %.178.i = mul i64 %.177.i, %.137.i
  %.179.i = add nsw i64 %.178.i, %.173.i
  %.269.i = load i64, ptr %.268.i, align 8, !noalias !36
  %.272.i = mul i64 %.79.i107, %.229.i
  %.273.i = add nsw i64 %.269.i, %.272.i
  %.358.i = load i64, ptr %.357.i, align 8, !noalias !36
  %.362.i111 = add nsw i64 %.358.i, %.177.i
  %.448.i = load i64, ptr %.447.i, align 8, !noalias !36
  %.7471468.not.i = icmp slt i64 %.108.i109, 1
  br i1 %.7471468.not.i, label %B970.i, label %B582.if.lr.ph.i

B968.i:                                           ; preds = %B722.if.i, %B582.if.i
  %scevgep505.i = getelementptr i8, ptr %lsr.iv504.i, i64 27648
  %scevgep513.i = getelementptr i8, ptr %lsr.iv512.i, i64 %204
  %exitcond.not.i119 = icmp eq i64 %.760.i, %.108.i109
  br i1 %exitcond.not.i119, label %B970.i, label %B582.if.i

B970.i:                                           ; preds = %B968.i, %B918.if
  %.21981493.not.i = icmp slt i64 %.79.i107, 1
  br i1 %.21981493.not.i, label %_ZN17bnserve_inference14adjoint_kernel7_source9_polariseB3v77B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit, label %B1000.if.lr.ph.i

B1000.if.lr.ph.i:                                 ; preds = %B970.i
  %.2357.i = sub nsw i64 %.137.i, %.1090933952
  %.13.i.i120 = tail call i64 @llvm.smin.i64(i64 %.2357.i, i64 range(i64 -9223372036854775808, 129) %.13.i)
  %196 = mul i64 %.137.i, %.175.i110
  %197 = icmp slt i64 %.13.i.i120, 1
  %198 = inttoptr i64 %.448.i to ptr
  %199 = inttoptr i64 %.273.i to ptr
  %200 = inttoptr i64 %.179.i to ptr
  %201 = inttoptr i64 %.362.i111 to ptr
  br label %B1000.if.i

B582.if.lr.ph.i:                                  ; preds = %B918.if
  %.619.i112 = sub i64 0, %.137.i
  %.533.i113 = load i64, ptr %.532.i, align 8, !noalias !36
  %.537.i114 = inttoptr i64 %.533.i113 to ptr
  %.612.i = getelementptr i8, ptr %.537.i114, i64 8
  %.613.i = load double, ptr %.612.i, align 8, !noalias !36
  %.1308.i = lshr exact i64 %.13.i, 3
  %.1287.inv.i = icmp sgt i64 %.1127, 0
  %storemerge1115.i = select i1 %.1287.inv.i, i64 %.1308.i, i64 0
  %.6.i.i115 = insertelement <8 x double> poison, double %.613.i, i64 0
  %.7.i.i116 = shufflevector <8 x double> %.6.i.i115, <8 x double> poison, <8 x i32> zeroinitializer
  %202 = shl i64 %.1090933952, 3
  %scevgep511.i = getelementptr i8, ptr %.961.sroa.12.1, i64 %202
  %203 = lshr i64 %.619.i112, 3
  %204 = mul i64 %203, -64
  %205 = add nuw nsw i64 %storemerge1115.i, 3
  %206 = icmp eq i64 %storemerge1115.i, 0
  br label %B582.if.i

B582.if.i:                                        ; preds = %B582.if.lr.ph.i, %B968.i
  %lsr.iv512.i = phi ptr [ %scevgep511.i, %B582.if.lr.ph.i ], [ %scevgep513.i, %B968.i ]
  %lsr.iv504.i = phi ptr [ %scevgep503.i, %B582.if.lr.ph.i ], [ %scevgep505.i, %B968.i ]
  %.75314211471.i = phi i64 [ 0, %B582.if.lr.ph.i ], [ %.760.i, %B968.i ]
  %.760.i = add nuw nsw i64 %.75314211471.i, 1
  %.idx1113.i = mul i64 %.75314211471.i, 27648
  %207 = getelementptr i8, ptr %.430, i64 %.idx1113.i
  %.807.i = getelementptr i8, ptr %207, i64 14336
  tail call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(27648) %.807.i, i8 0, i64 27648, i1 false), !noalias !36
  br i1 %206, label %B968.i, label %B722.if.i

B722.if.i:                                        ; preds = %B582.if.i, %B722.if.i
  %lsr.iv10.i = phi i64 [ %lsr.iv.next11.i, %B722.if.i ], [ %205, %B582.if.i ]
  %lsr.iv506.i = phi i64 [ %lsr.iv.next507.i, %B722.if.i ], [ 0, %B582.if.i ]
  %scevgep514.i = getelementptr i8, ptr %lsr.iv512.i, i64 %lsr.iv506.i
  %.1377.i = load <8 x double>, ptr %scevgep514.i, align 8, !noalias !36
  %.8.i.i117 = fmul contract <8 x double> %.7.i.i116, %.1377.i
  %.1407.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i.i117, <8 x double> splat (double 0x3FE45F306DC9C883), <8 x double> splat (double 0x4338000000000000))
  %.8.i301.i = fadd contract <8 x double> %.1407.i, splat (double 0xC338000000000000)
  %.1448.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i301.i, <8 x double> splat (double 0xBFF921FB54442D18), <8 x double> %.8.i.i117)
  %.1465.i118 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i301.i, <8 x double> splat (double 0xBC91A62633145C07), <8 x double> %.1448.i)
  %.6.i302.i = fmul contract <8 x double> %.1465.i118, %.1465.i118
  %.6.i303.i = fmul contract <8 x double> %.1465.i118, %.6.i302.i
  %.1494.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i302.i, <8 x double> splat (double 0xBD6AE7F3E733B81F), <8 x double> splat (double 0x3DE6124613A86D09))
  %.1497.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i302.i, <8 x double> %.1494.i, <8 x double> splat (double 0xBE5AE64567F544E4))
  %.1500.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i302.i, <8 x double> %.1497.i, <8 x double> splat (double 0x3EC71DE3A556C734))
  %.1503.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i302.i, <8 x double> %.1500.i, <8 x double> splat (double 0xBF2A01A01A01A01A))
  %.1506.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i302.i, <8 x double> %.1503.i, <8 x double> splat (double 0x3F81111111111111))
  %.1509.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i302.i, <8 x double> %.1506.i, <8 x double> splat (double 0xBFC5555555555555))
  %.1534.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i303.i, <8 x double> %.1509.i, <8 x double> %.1465.i118)
  %.1539.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i302.i, <8 x double> splat (double 0x3D2AE7F3E733B81F), <8 x double> splat (double 0xBDA93974A8C07C9D))
  %.1542.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i302.i, <8 x double> %.1539.i, <8 x double> splat (double 0x3E21EED8EFF8D898))
  %.1545.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i302.i, <8 x double> %.1542.i, <8 x double> splat (double 0xBE927E4FB7789F5C))
  %.1548.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i302.i, <8 x double> %.1545.i, <8 x double> splat (double 0x3EFA01A01A01A01A))
  %.1551.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i302.i, <8 x double> %.1548.i, <8 x double> splat (double 0xBF56C16C16C16C17))
  %.1554.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i302.i, <8 x double> %.1551.i, <8 x double> splat (double 0x3FA5555555555555))
  %.1557.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i302.i, <8 x double> %.1554.i, <8 x double> splat (double -5.000000e-01))
  %.1560.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i302.i, <8 x double> %.1557.i, <8 x double> splat (double 1.000000e+00))
  %.1561.i = bitcast <8 x double> %.1407.i to <8 x i64>
  %.1562.i = bitcast <8 x double> %.1534.i to <8 x i64>
  %.1563.i = bitcast <8 x double> %.1560.i to <8 x i64>
  %.6.i304.i = xor <8 x i64> %.1563.i, %.1562.i
  %.8.i305.i = and <8 x i64> %.1561.i, splat (i64 1)
  %208 = icmp eq <8 x i64> %.8.i305.i, zeroinitializer
  %.6.i307.i = select <8 x i1> %208, <8 x i64> zeroinitializer, <8 x i64> %.6.i304.i
  %.8.i308.i = shl <8 x i64> %.1561.i, splat (i64 62)
  %.8.i309.i = and <8 x i64> %.8.i308.i, splat (i64 -9223372036854775808)
  %.8.i311.i = add <8 x i64> %.8.i308.i, splat (i64 4611686018427387904)
  %.8.i312.i = and <8 x i64> %.8.i311.i, splat (i64 -9223372036854775808)
  %209 = xor <8 x i64> %.8.i309.i, %.1562.i
  %.6.i314.i = xor <8 x i64> %209, %.6.i307.i
  %210 = xor <8 x i64> %.8.i312.i, %.1563.i
  %.6.i316.i = xor <8 x i64> %210, %.6.i307.i
  %scevgep509.i = getelementptr i8, ptr %lsr.iv504.i, i64 %lsr.iv506.i
  %scevgep510.i = getelementptr i8, ptr %scevgep509.i, i64 -1024
  store <8 x i64> %.6.i316.i, ptr %scevgep510.i, align 8, !noalias !36
  store <8 x i64> %.6.i314.i, ptr %scevgep509.i, align 8, !noalias !36
  %lsr.iv.next507.i = add i64 %lsr.iv506.i, 64
  %lsr.iv.next11.i = add nsw i64 %lsr.iv10.i, -1
  %.1329.i = icmp sgt i64 %lsr.iv10.i, 4
  br i1 %.1329.i, label %B722.if.i, label %B968.i

B1000.if.i:                                       ; preds = %B1002.endif.endif.endif.endif.endif.endif.endif.endif.i, %B1000.if.lr.ph.i
  %lsr.iv.i122 = phi i64 [ %.1090933952, %B1000.if.lr.ph.i ], [ %lsr.iv.next.i139, %B1002.endif.endif.endif.endif.endif.endif.endif.endif.i ]
  %.220414851494.i = phi i64 [ 0, %B1000.if.lr.ph.i ], [ %.2211.i, %B1002.endif.endif.endif.endif.endif.endif.endif.endif.i ]
  %.2211.i = add nuw nsw i64 %.220414851494.i, 1
  %211 = getelementptr i64, ptr %198, i64 %.220414851494.i
  %.2266.i = load i64, ptr %211, align 8, !noalias !36
  %.idx.i123 = mul i64 %.2266.i, 27648
  %212 = getelementptr double, ptr %199, i64 %.220414851494.i
  %.2764.i = load double, ptr %212, align 8, !noalias !36
  br i1 %197, label %B1002.endif.endif.endif.endif.endif.endif.endif.endif.i, label %B34.if.preheader.i.i124

B34.if.preheader.i.i124:                          ; preds = %B1000.if.i
  %.2352.i = mul nsw i64 %.220414851494.i, %.137.i
  %.2354.i = add nsw i64 %.2352.i, %.1090933952
  %213 = shl i64 %.2354.i, 4
  %214 = getelementptr i8, ptr %200, i64 %213
  %scevgep2.i.i125 = getelementptr i8, ptr %214, i64 8
  %scevgep1.i = getelementptr i8, ptr %scevgep.i121, i64 %.idx.i123
  br label %B34.if.i.i126

B34.if.i.i126:                                    ; preds = %B34.if.i.i126, %B34.if.preheader.i.i124
  %lsr.iv.i.i127 = phi ptr [ %scevgep2.i.i125, %B34.if.preheader.i.i124 ], [ %scevgep3.i.i137, %B34.if.i.i126 ]
  %.143136138.i.i = phi i64 [ 0, %B34.if.preheader.i.i124 ], [ %.150.i.i, %B34.if.i.i126 ]
  %.150.i.i = add nuw nsw i64 %.143136138.i.i, 1
  %215 = add i64 %.143136138.i.i, %lsr.iv.i122
  %.191.i.i = icmp slt i64 %215, 0
  %216 = select i1 %.191.i.i, i64 %196, i64 0
  %scevgep4.i.i128 = getelementptr i8, ptr %lsr.iv.i.i127, i64 %216
  %scevgep5.i.i129 = getelementptr i8, ptr %scevgep4.i.i128, i64 -8
  %.207.i.i = load double, ptr %scevgep5.i.i129, align 8, !noalias !39
  %.241.i.i130 = load double, ptr %scevgep4.i.i128, align 8, !noalias !39
  %sunkaddr.i131 = shl i64 %.143136138.i.i, 3
  %scevgep3.i = getelementptr i8, ptr %scevgep1.i, i64 %sunkaddr.i131
  %scevgep4.i = getelementptr i8, ptr %scevgep3.i, i64 -1024
  %.271.i.i132 = load double, ptr %scevgep4.i, align 8, !noalias !39
  %.273.i.i = fmul contract double %.2764.i, %.207.i.i
  %.275.i.i133 = fmul contract double %.241.i.i130, 0.000000e+00
  %.276.i.i = fsub contract double %.273.i.i, %.275.i.i133
  %.277.i.i134 = fadd contract double %.271.i.i132, %.276.i.i
  store double %.277.i.i134, ptr %scevgep4.i, align 8, !noalias !39
  %.337.i.i = load double, ptr %scevgep3.i, align 8, !noalias !39
  %.339.i.i135 = fmul contract double %.2764.i, %.241.i.i130
  %.341.i.i = fmul contract double %.207.i.i, 0.000000e+00
  %.342.i.i = fadd contract double %.341.i.i, %.339.i.i135
  %.343.i.i136 = fadd contract double %.342.i.i, %.337.i.i
  store double %.343.i.i136, ptr %scevgep3.i, align 8, !noalias !39
  %scevgep3.i.i137 = getelementptr i8, ptr %lsr.iv.i.i127, i64 16
  %exitcond.not.i.i138 = icmp eq i64 %.13.i.i120, %.150.i.i
  br i1 %exitcond.not.i.i138, label %B1002.endif.endif.endif.endif.endif.endif.endif.i, label %B34.if.i.i126

B1002.endif.endif.endif.endif.endif.endif.endif.i: ; preds = %B34.if.i.i126
  %.idx270.i = shl i64 %.220414851494.i, 4
  %217 = getelementptr i8, ptr %201, i64 %.idx270.i
  %.2833.i = load double, ptr %217, align 8, !noalias !36
  %218 = getelementptr i8, ptr %217, i64 8
  %.2865.i = load double, ptr %218, align 8, !noalias !36
  %scevgep6.i = getelementptr i8, ptr %scevgep5.i, i64 %.idx.i123
  br label %B34.if.i355.i

B34.if.i355.i:                                    ; preds = %B34.if.i355.i, %B1002.endif.endif.endif.endif.endif.endif.endif.i
  %lsr.iv.i356.i = phi ptr [ %scevgep2.i.i125, %B1002.endif.endif.endif.endif.endif.endif.endif.i ], [ %scevgep3.i376.i, %B34.if.i355.i ]
  %.143136138.i357.i = phi i64 [ 0, %B1002.endif.endif.endif.endif.endif.endif.endif.i ], [ %.150.i358.i, %B34.if.i355.i ]
  %.150.i358.i = add nuw nsw i64 %.143136138.i357.i, 1
  %219 = add i64 %.143136138.i357.i, %lsr.iv.i122
  %.191.i359.i = icmp slt i64 %219, 0
  %220 = select i1 %.191.i359.i, i64 %196, i64 0
  %scevgep4.i360.i = getelementptr i8, ptr %lsr.iv.i356.i, i64 %220
  %scevgep5.i361.i = getelementptr i8, ptr %scevgep4.i360.i, i64 -8
  %.207.i362.i = load double, ptr %scevgep5.i361.i, align 8, !noalias !42
  %.241.i363.i = load double, ptr %scevgep4.i360.i, align 8, !noalias !42
  %sunkaddr8.i = shl i64 %.143136138.i357.i, 3
  %scevgep8.i = getelementptr i8, ptr %scevgep6.i, i64 %sunkaddr8.i
  %scevgep9.i = getelementptr i8, ptr %scevgep8.i, i64 -1024
  %.271.i365.i = load double, ptr %scevgep9.i, align 8, !noalias !42
  %.273.i366.i = fmul contract double %.2833.i, %.207.i362.i
  %.275.i367.i = fmul contract double %.2865.i, %.241.i363.i
  %.276.i368.i = fsub contract double %.273.i366.i, %.275.i367.i
  %.277.i369.i = fadd contract double %.271.i365.i, %.276.i368.i
  store double %.277.i369.i, ptr %scevgep9.i, align 8, !noalias !42
  %.337.i371.i = load double, ptr %scevgep8.i, align 8, !noalias !42
  %.339.i372.i = fmul contract double %.2833.i, %.241.i363.i
  %.341.i373.i = fmul contract double %.2865.i, %.207.i362.i
  %.342.i374.i = fadd contract double %.341.i373.i, %.339.i372.i
  %.343.i375.i = fadd contract double %.342.i374.i, %.337.i371.i
  store double %.343.i375.i, ptr %scevgep8.i, align 8, !noalias !42
  %scevgep3.i376.i = getelementptr i8, ptr %lsr.iv.i356.i, i64 16
  %exitcond.not.i377.i = icmp eq i64 %.13.i.i120, %.150.i358.i
  br i1 %exitcond.not.i377.i, label %B1002.endif.endif.endif.endif.endif.endif.endif.endif.i, label %B34.if.i355.i

B1002.endif.endif.endif.endif.endif.endif.endif.endif.i: ; preds = %B34.if.i355.i, %B1000.if.i
  %lsr.iv.next.i139 = add i64 %lsr.iv.i122, %.137.i
  %exitcond1845.not.i = icmp eq i64 %.2211.i, %.79.i107
  br i1 %exitcond1845.not.i, label %_ZN17bnserve_inference14adjoint_kernel7_source9_polariseB3v77B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit, label %B1000.if.i

_ZN17bnserve_inference14adjoint_kernel7_source9_polariseB3v77B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit: ; preds = %B1002.endif.endif.endif.endif.endif.endif.endif.endif.i, %B970.i
  br i1 %58, label %B1212, label %B1040.if.preheader

B1040.if.preheader:                               ; preds = %_ZN17bnserve_inference14adjoint_kernel7_source9_polariseB3v77B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit
  %.104.i.i.i = icmp sgt i64 %.1127, 0
  %221 = shl nuw nsw i64 %.13.i, 3
  %unroll_iter.i.i.i = and i64 %.13.i, 9223372036854775800
  %222 = add nsw i64 %unroll_iter.i.i.i, -2
  %223 = lshr exact i64 %222, 1
  %224 = add nuw i64 %223, 1
  %225 = lshr exact i64 %224, 1
  %226 = mul nsw i64 %225, -2
  %227 = icmp slt i64 %.1127, 1
  %228 = shl nuw nsw i64 %.13.i, 3
  %unroll_iter.i84.i.i = and i64 %.13.i, 9223372036854775800
  %229 = add nsw i64 %unroll_iter.i84.i.i, -2
  %230 = lshr exact i64 %229, 1
  %231 = add nuw i64 %230, 1
  %232 = lshr exact i64 %231, 1
  %233 = mul nsw i64 %232, -2
  %234 = icmp slt i64 %.1127, 1
  %.1542.inv.i.i = icmp slt i64 %.1127, 1
  %.1563.i.i = lshr exact i64 %.13.i, 3
  %235 = add nuw nsw i64 %.1563.i.i, 4
  %.116.i.i171 = lshr exact i64 %.13.i, 3
  %.93.inv.i.i = icmp slt i64 %.1127, 1
  %236 = tail call i64 @llvm.smax.i64(i64 %.116.i.i171, i64 1)
  %237 = add nuw nsw i64 %.116.i.i171, 4
  %238 = add nuw nsw i64 %.116.i.i171, 5
  br label %B1040.if

B1040.if:                                         ; preds = %B1040.if.preheader, %_ZN17bnserve_inference14adjoint_kernel7_source12_in_detectorB4v112B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxx5ArrayIxLi1E1C7mutable7alignedEd5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit
  %lsr.iv270 = phi ptr [ %scevgep271, %_ZN17bnserve_inference14adjoint_kernel7_source12_in_detectorB4v112B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxx5ArrayIxLi1E1C7mutable7alignedEd5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit ], [ %.230, %B1040.if.preheader ]
  %lsr.iv = phi ptr [ %scevgep, %_ZN17bnserve_inference14adjoint_kernel7_source12_in_detectorB4v112B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxx5ArrayIxLi1E1C7mutable7alignedEd5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit ], [ %.363, %B1040.if.preheader ]
  %.1282920924 = phi i64 [ %.1289, %_ZN17bnserve_inference14adjoint_kernel7_source12_in_detectorB4v112B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxx5ArrayIxLi1E1C7mutable7alignedEd5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit ], [ 0, %B1040.if.preheader ]
  call void @llvm.lifetime.start.p0(ptr nonnull %.747.i)
  call void @llvm.lifetime.start.p0(ptr nonnull %.782.i)
  store ptr null, ptr %.747.i, align 8, !noalias !45
  store ptr null, ptr %.782.i, align 8, !noalias !45
  %.104.i = load i64, ptr %.76, align 8, !noalias !45
  %.134.i = load i64, ptr %.133.i141, align 8, !noalias !45
  %.172.i142 = load i64, ptr %.171.i, align 8, !noalias !45
  %.247.i = inttoptr i64 %.172.i142 to ptr
  %.311.i = getelementptr inbounds double, ptr %.247.i, i64 %.1090933952
  %.289.i.i = load i64, ptr %.140, align 8, !noalias !48
  %.290.i.i = sub i64 0, %.289.i.i
  %.298.1.i.i = and i64 %.290.i.i, -8
  %.332.i.i143 = sub i64 0, %.298.1.i.i
  %.340.i.i144 = icmp eq i64 %.134.i, 0
  br i1 %.340.i.i144, label %B224.i.i, label %B258.i.i

B224.i.i:                                         ; preds = %B1040.if
  store double 1.000000e+00, ptr %.430, align 8, !noalias !48
  store double 1.000000e+00, ptr %sunkaddr67.i.i279, align 8, !noalias !48
  store double 1.000000e+00, ptr %sunkaddr70.i.i, align 8, !noalias !48
  store double 1.000000e+00, ptr %sunkaddr73.i.i, align 8, !noalias !48
  store double 1.000000e+00, ptr %sunkaddr76.i.i, align 8, !noalias !48
  store double 1.000000e+00, ptr %sunkaddr79.i.i, align 8, !noalias !48
  store double 1.000000e+00, ptr %sunkaddr82.i.i, align 8, !noalias !48
  store double 1.000000e+00, ptr %sunkaddr85.i.i, align 8, !noalias !48
  store double 1.000000e+00, ptr %sunkaddr88.i.i, align 8, !noalias !48
  store double 1.000000e+00, ptr %sunkaddr91.i.i, align 8, !noalias !48
  store double 1.000000e+00, ptr %sunkaddr94.i.i, align 8, !noalias !48
  store double 1.000000e+00, ptr %sunkaddr97.i.i, align 8, !noalias !48
  store double 1.000000e+00, ptr %sunkaddr100.i.i, align 8, !noalias !48
  store double 1.000000e+00, ptr %sunkaddr103.i.i280, align 8, !noalias !48
  store double 1.000000e+00, ptr %sunkaddr106.i.i281, align 8, !noalias !48
  store double 1.000000e+00, ptr %sunkaddr109.i.i282, align 8, !noalias !48
  store double 1.000000e+00, ptr %sunkaddr64.1.i.i, align 8, !noalias !48
  store double 1.000000e+00, ptr %sunkaddr67.1.i.i, align 8, !noalias !48
  store double 1.000000e+00, ptr %sunkaddr70.1.i.i, align 8, !noalias !48
  store double 1.000000e+00, ptr %sunkaddr73.1.i.i, align 8, !noalias !48
  store double 1.000000e+00, ptr %sunkaddr76.1.i.i, align 8, !noalias !48
  store double 1.000000e+00, ptr %sunkaddr79.1.i.i, align 8, !noalias !48
  store double 1.000000e+00, ptr %sunkaddr82.1.i.i, align 8, !noalias !48
  store double 1.000000e+00, ptr %sunkaddr85.1.i.i, align 8, !noalias !48
  store double 1.000000e+00, ptr %sunkaddr88.1.i.i, align 8, !noalias !48
  store double 1.000000e+00, ptr %sunkaddr91.1.i.i, align 8, !noalias !48
  store double 1.000000e+00, ptr %sunkaddr94.1.i.i, align 8, !noalias !48
  store double 1.000000e+00, ptr %sunkaddr97.1.i.i, align 8, !noalias !48
  store double 1.000000e+00, ptr %sunkaddr100.1.i.i, align 8, !noalias !48
  store double 1.000000e+00, ptr %sunkaddr103.1.i.i, align 8, !noalias !48
  store double 1.000000e+00, ptr %sunkaddr106.1.i.i, align 8, !noalias !48
  store double 1.000000e+00, ptr %sunkaddr109.1.i.i, align 8, !noalias !48
  store double 1.000000e+00, ptr %sunkaddr64.2.i.i, align 8, !noalias !48
  store double 1.000000e+00, ptr %sunkaddr67.2.i.i, align 8, !noalias !48
  store double 1.000000e+00, ptr %sunkaddr70.2.i.i, align 8, !noalias !48
  store double 1.000000e+00, ptr %sunkaddr73.2.i.i, align 8, !noalias !48
  store double 1.000000e+00, ptr %sunkaddr76.2.i.i, align 8, !noalias !48
  store double 1.000000e+00, ptr %sunkaddr79.2.i.i, align 8, !noalias !48
  store double 1.000000e+00, ptr %sunkaddr82.2.i.i, align 8, !noalias !48
  store double 1.000000e+00, ptr %sunkaddr85.2.i.i, align 8, !noalias !48
  store double 1.000000e+00, ptr %sunkaddr88.2.i.i, align 8, !noalias !48
  store double 1.000000e+00, ptr %sunkaddr91.2.i.i, align 8, !noalias !48
  store double 1.000000e+00, ptr %sunkaddr94.2.i.i, align 8, !noalias !48
  store double 1.000000e+00, ptr %sunkaddr97.2.i.i, align 8, !noalias !48
  store double 1.000000e+00, ptr %sunkaddr100.2.i.i, align 8, !noalias !48
  store double 1.000000e+00, ptr %sunkaddr103.2.i.i, align 8, !noalias !48
  store double 1.000000e+00, ptr %sunkaddr106.2.i.i, align 8, !noalias !48
  store double 1.000000e+00, ptr %sunkaddr109.2.i.i, align 8, !noalias !48
  store double 1.000000e+00, ptr %sunkaddr64.3.i.i, align 8, !noalias !48
  store double 1.000000e+00, ptr %sunkaddr67.3.i.i, align 8, !noalias !48
  store double 1.000000e+00, ptr %sunkaddr70.3.i.i, align 8, !noalias !48
  store double 1.000000e+00, ptr %sunkaddr73.3.i.i, align 8, !noalias !48
  store double 1.000000e+00, ptr %sunkaddr76.3.i.i, align 8, !noalias !48
  store double 1.000000e+00, ptr %sunkaddr79.3.i.i, align 8, !noalias !48
  store double 1.000000e+00, ptr %sunkaddr82.3.i.i, align 8, !noalias !48
  store double 1.000000e+00, ptr %sunkaddr85.3.i.i, align 8, !noalias !48
  store double 1.000000e+00, ptr %sunkaddr88.3.i.i, align 8, !noalias !48
  store double 1.000000e+00, ptr %sunkaddr91.3.i.i, align 8, !noalias !48
  store double 1.000000e+00, ptr %sunkaddr94.3.i.i, align 8, !noalias !48
  store double 1.000000e+00, ptr %sunkaddr97.3.i.i, align 8, !noalias !48
  store double 1.000000e+00, ptr %sunkaddr100.3.i.i, align 8, !noalias !48
  store double 1.000000e+00, ptr %sunkaddr103.3.i.i, align 8, !noalias !48
  store double 1.000000e+00, ptr %sunkaddr106.3.i.i, align 8, !noalias !48
  store double 1.000000e+00, ptr %sunkaddr109.3.i.i, align 8, !noalias !48
  store double 1.000000e+00, ptr %sunkaddr64.4.i.i, align 8, !noalias !48
  store double 1.000000e+00, ptr %sunkaddr67.4.i.i, align 8, !noalias !48
  store double 1.000000e+00, ptr %sunkaddr70.4.i.i, align 8, !noalias !48
  store double 1.000000e+00, ptr %sunkaddr73.4.i.i, align 8, !noalias !48
  store double 1.000000e+00, ptr %sunkaddr76.4.i.i, align 8, !noalias !48
  store double 1.000000e+00, ptr %sunkaddr79.4.i.i, align 8, !noalias !48
  store double 1.000000e+00, ptr %sunkaddr82.4.i.i, align 8, !noalias !48
  store double 1.000000e+00, ptr %sunkaddr85.4.i.i, align 8, !noalias !48
  store double 1.000000e+00, ptr %sunkaddr88.4.i.i, align 8, !noalias !48
  store double 1.000000e+00, ptr %sunkaddr91.4.i.i, align 8, !noalias !48
  store double 1.000000e+00, ptr %sunkaddr94.4.i.i, align 8, !noalias !48
  store double 1.000000e+00, ptr %sunkaddr97.4.i.i, align 8, !noalias !48
  store double 1.000000e+00, ptr %sunkaddr100.4.i.i, align 8, !noalias !48
  store double 1.000000e+00, ptr %sunkaddr103.4.i.i, align 8, !noalias !48
  store double 1.000000e+00, ptr %sunkaddr106.4.i.i, align 8, !noalias !48
  store double 1.000000e+00, ptr %sunkaddr109.4.i.i, align 8, !noalias !48
  store double 1.000000e+00, ptr %sunkaddr64.5.i.i, align 8, !noalias !48
  store double 1.000000e+00, ptr %sunkaddr67.5.i.i, align 8, !noalias !48
  store double 1.000000e+00, ptr %sunkaddr70.5.i.i, align 8, !noalias !48
  store double 1.000000e+00, ptr %sunkaddr73.5.i.i, align 8, !noalias !48
  store double 1.000000e+00, ptr %sunkaddr76.5.i.i, align 8, !noalias !48
  store double 1.000000e+00, ptr %sunkaddr79.5.i.i, align 8, !noalias !48
  store double 1.000000e+00, ptr %sunkaddr82.5.i.i, align 8, !noalias !48
  store double 1.000000e+00, ptr %sunkaddr85.5.i.i, align 8, !noalias !48
  store double 1.000000e+00, ptr %sunkaddr88.5.i.i, align 8, !noalias !48
  store double 1.000000e+00, ptr %sunkaddr91.5.i.i, align 8, !noalias !48
  store double 1.000000e+00, ptr %sunkaddr94.5.i.i, align 8, !noalias !48
  store double 1.000000e+00, ptr %sunkaddr97.5.i.i, align 8, !noalias !48
  store double 1.000000e+00, ptr %sunkaddr100.5.i.i, align 8, !noalias !48
  store double 1.000000e+00, ptr %sunkaddr103.5.i.i, align 8, !noalias !48
  store double 1.000000e+00, ptr %sunkaddr106.5.i.i, align 8, !noalias !48
  store double 1.000000e+00, ptr %sunkaddr109.5.i.i, align 8, !noalias !48
  store double 1.000000e+00, ptr %sunkaddr64.6.i.i, align 8, !noalias !48
  store double 1.000000e+00, ptr %sunkaddr67.6.i.i, align 8, !noalias !48
  store double 1.000000e+00, ptr %sunkaddr70.6.i.i, align 8, !noalias !48
  store double 1.000000e+00, ptr %sunkaddr73.6.i.i, align 8, !noalias !48
  store double 1.000000e+00, ptr %sunkaddr76.6.i.i, align 8, !noalias !48
  store double 1.000000e+00, ptr %sunkaddr79.6.i.i, align 8, !noalias !48
  store double 1.000000e+00, ptr %sunkaddr82.6.i.i, align 8, !noalias !48
  store double 1.000000e+00, ptr %sunkaddr85.6.i.i, align 8, !noalias !48
  store double 1.000000e+00, ptr %sunkaddr88.6.i.i, align 8, !noalias !48
  store double 1.000000e+00, ptr %sunkaddr91.6.i.i, align 8, !noalias !48
  store double 1.000000e+00, ptr %sunkaddr94.6.i.i, align 8, !noalias !48
  store double 1.000000e+00, ptr %sunkaddr97.6.i.i, align 8, !noalias !48
  store double 1.000000e+00, ptr %sunkaddr100.6.i.i, align 8, !noalias !48
  store double 1.000000e+00, ptr %sunkaddr103.6.i.i, align 8, !noalias !48
  store double 1.000000e+00, ptr %sunkaddr106.6.i.i, align 8, !noalias !48
  store double 1.000000e+00, ptr %sunkaddr109.6.i.i, align 8, !noalias !48
  store double 1.000000e+00, ptr %sunkaddr64.7.i.i, align 8, !noalias !48
  store double 1.000000e+00, ptr %sunkaddr67.7.i.i, align 8, !noalias !48
  store double 1.000000e+00, ptr %sunkaddr70.7.i.i, align 8, !noalias !48
  store double 1.000000e+00, ptr %sunkaddr73.7.i.i, align 8, !noalias !48
  store double 1.000000e+00, ptr %sunkaddr76.7.i.i, align 8, !noalias !48
  store double 1.000000e+00, ptr %sunkaddr79.7.i.i, align 8, !noalias !48
  store double 1.000000e+00, ptr %sunkaddr82.7.i.i, align 8, !noalias !48
  store double 1.000000e+00, ptr %sunkaddr85.7.i.i, align 8, !noalias !48
  store double 1.000000e+00, ptr %sunkaddr88.7.i.i, align 8, !noalias !48
  store double 1.000000e+00, ptr %sunkaddr91.7.i.i, align 8, !noalias !48
  store double 1.000000e+00, ptr %sunkaddr94.7.i.i, align 8, !noalias !48
  store double 1.000000e+00, ptr %sunkaddr97.7.i.i, align 8, !noalias !48
  store double 1.000000e+00, ptr %sunkaddr100.7.i.i, align 8, !noalias !48
  store double 1.000000e+00, ptr %sunkaddr103.7.i.i, align 8, !noalias !48
  store double 1.000000e+00, ptr %sunkaddr106.7.i.i, align 8, !noalias !48
  store double 1.000000e+00, ptr %sunkaddr109.7.i.i, align 8, !noalias !48
  br label %_ZN17bnserve_inference14adjoint_kernel7_source10_calibrateB4v123B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i

B258.i.i:                                         ; preds = %B1040.if
  %.1130.i.i146 = shl nsw i64 %.134.i, 3
  %.1160.i.i147 = load i64, ptr %arg.arguments.4, align 8, !noalias !48
  %.1162.i.i = mul nsw i64 %.1160.i.i147, %.7709701030
  %.1166.i.i = add nsw i64 %.1162.i.i, %.1282920924
  %.1169.i.i = mul nsw i64 %.1166.i.i, %.1130.i.i146
  %.1200.i.i = load i64, ptr %.1199.i.i, align 8, !noalias !48
  %.1203.i.i148 = mul nsw i64 %.134.i, %.332.i.i143
  %.1283.i.i = load i64, ptr %.1282.i.i, align 8, !noalias !48
  %.1284.i.i = add nsw i64 %.1169.i.i, %.1283.i.i
  br i1 %.104.i.i.i, label %B60.if.preheader.i.i.i, label %B76.i.i.i

B1002.i.i:                                        ; preds = %B786.if.i.i, %B258.endif.endif.endif.endif.endif.endif.endif.i.i
  tail call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(1024) %.1913.i.i, i8 0, i64 1024, i1 false), !noalias !48
  br label %_ZN17bnserve_inference14adjoint_kernel7_source10_calibrateB4v123B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i

B60.if.preheader.i.i.i:                           ; preds = %B258.i.i
  tail call void @llvm.memset.p0.i64(ptr nonnull align 8 %.1001.i.i145, i8 0, i64 %221, i1 false), !noalias !51
  br label %B76.i.i.i

B76.i.i.i:                                        ; preds = %B60.if.preheader.i.i.i, %B258.i.i
  %.311284.not.i.i.i = icmp slt i64 %.134.i, 1
  br i1 %.311284.not.i.i.i, label %B258.endif.endif.endif.endif.endif.i.i, label %B128.if.lr.ph.i.i.i

B128.if.lr.ph.i.i.i:                              ; preds = %B76.i.i.i
  %239 = inttoptr i64 %.1200.i.i to ptr
  %scevgep276.i.i = getelementptr i8, ptr %239, i64 24
  %240 = inttoptr i64 %.1284.i.i to ptr
  br label %B128.if.i.i.i

B284.i.i.i:                                       ; preds = %B228.if.i.i.i, %B130.else.endif.endif.endif.endif.i.i.i
  %exitcond292.not.i.i.i = icmp eq i64 %.324.i.i.i, %.134.i
  br i1 %exitcond292.not.i.i.i, label %B258.endif.endif.endif.endif.endif.i.i, label %B128.if.i.i.i

B128.if.i.i.i:                                    ; preds = %B284.i.i.i, %B128.if.lr.ph.i.i.i
  %.317279285.i.i.i = phi i64 [ 0, %B128.if.lr.ph.i.i.i ], [ %.324.i.i.i, %B284.i.i.i ]
  %.324.i.i.i = add nuw nsw i64 %.317279285.i.i.i, 1
  %.350.i.i.i = mul nsw i64 %.317279285.i.i.i, %.332.i.i143
  %.352.i.i.i = add nsw i64 %.350.i.i.i, %.1090933952
  %.395.i.i.i = icmp slt i64 %.352.i.i.i, 0
  %.396.i.i.i = select i1 %.395.i.i.i, i64 %.1203.i.i148, i64 0
  %.397.i.i.i = add i64 %.396.i.i.i, %.352.i.i.i
  %.400.i.i.i = icmp slt i64 %.397.i.i.i, 0
  br i1 %.400.i.i.i, label %B130.else.if.i.i.i, label %B130.else.endif.i.i.i, !prof !54

B130.else.if.i.i.i:                               ; preds = %B128.if.i.i.i
  br label %B130.else.endif.i.i.i

B130.else.endif.i.i.i:                            ; preds = %B130.else.if.i.i.i, %B128.if.i.i.i
  %.385.sroa.0.1.i.i.i = phi i64 [ 0, %B130.else.if.i.i.i ], [ %.397.i.i.i, %B128.if.i.i.i ]
  %.405.not.i.i.i = icmp slt i64 %.397.i.i.i, %.1203.i.i148
  br i1 %.405.not.i.i.i, label %B130.else.endif.endif.endif.endif.i.i.i, label %B130.else.endif.if.i.i.i, !prof !55

B130.else.endif.if.i.i.i:                         ; preds = %B130.else.endif.i.i.i
  br label %B130.else.endif.endif.endif.endif.i.i.i

B130.else.endif.endif.endif.endif.i.i.i:          ; preds = %B130.else.endif.if.i.i.i, %B130.else.endif.i.i.i
  %.385.sroa.0.3.i.i.i = phi i64 [ %.1203.i.i148, %B130.else.endif.if.i.i.i ], [ %.385.sroa.0.1.i.i.i, %B130.else.endif.i.i.i ]
  %241 = getelementptr double, ptr %240, i64 %.317279285.i.i.i
  %.565.i.i.i = load double, ptr %241, align 8, !noalias !51
  br i1 %227, label %B284.i.i.i, label %B228.if.preheader.i.i.i

B228.if.preheader.i.i.i:                          ; preds = %B130.else.endif.endif.endif.endif.i.i.i
  %242 = shl i64 %.385.sroa.0.3.i.i.i, 3
  %scevgep277.i.i = getelementptr i8, ptr %scevgep276.i.i, i64 %242
  br label %B228.if.i.i.i

B228.if.i.i.i:                                    ; preds = %B228.if.i.i.i, %B228.if.preheader.i.i.i
  %lsr.iv23.i.i149 = phi i64 [ %lsr.iv.next24.i.i152, %B228.if.i.i.i ], [ %226, %B228.if.preheader.i.i.i ]
  %.655272274.i.i.i = phi i64 [ %.662.1.i.1.i.i, %B228.if.i.i.i ], [ 0, %B228.if.preheader.i.i.i ]
  %sunkaddr.i1.i = shl i64 %.655272274.i.i.i, 3
  %sunkaddr39.i.i = getelementptr i8, ptr %.430, i64 %sunkaddr.i1.i
  %sunkaddr40.i.i = getelementptr i8, ptr %sunkaddr39.i.i, i64 2048
  %.716.i.i.i = load double, ptr %sunkaddr40.i.i, align 8, !noalias !51
  %scevgep37.i.i150 = getelementptr i8, ptr %scevgep277.i.i, i64 %sunkaddr.i1.i
  %scevgep38.i.i = getelementptr i8, ptr %scevgep37.i.i150, i64 -16
  %scevgep36.i.i151 = getelementptr i8, ptr %scevgep37.i.i150, i64 -24
  %.746.i.i.i = load double, ptr %scevgep36.i.i151, align 8, !noalias !51
  %.748.i.i.i = fmul contract double %.565.i.i.i, %.746.i.i.i
  %.749.i.i.i = fadd contract double %.716.i.i.i, %.748.i.i.i
  store double %.749.i.i.i, ptr %sunkaddr40.i.i, align 8, !noalias !51
  %sunkaddr43.i.i = getelementptr i8, ptr %sunkaddr39.i.i, i64 2056
  %.716.1.i.i.i = load double, ptr %sunkaddr43.i.i, align 8, !noalias !51
  %.746.1.i.i.i = load double, ptr %scevgep38.i.i, align 8, !noalias !51
  %.748.1.i.i.i = fmul contract double %.565.i.i.i, %.746.1.i.i.i
  %.749.1.i.i.i = fadd contract double %.716.1.i.i.i, %.748.1.i.i.i
  store double %.749.1.i.i.i, ptr %sunkaddr43.i.i, align 8, !noalias !51
  %sunkaddr46.i.i = getelementptr i8, ptr %sunkaddr39.i.i, i64 2064
  %.716.i.1.i.i = load double, ptr %sunkaddr46.i.i, align 8, !noalias !51
  %scevgep34.i.i = getelementptr i8, ptr %scevgep37.i.i150, i64 -8
  %.746.i.1.i.i = load double, ptr %scevgep34.i.i, align 8, !noalias !51
  %.748.i.1.i.i = fmul contract double %.565.i.i.i, %.746.i.1.i.i
  %.749.i.1.i.i = fadd contract double %.716.i.1.i.i, %.748.i.1.i.i
  store double %.749.i.1.i.i, ptr %sunkaddr46.i.i, align 8, !noalias !51
  %.662.1.i.1.i.i = add i64 %.655272274.i.i.i, 4
  %sunkaddr47.i.i = shl i64 %.662.1.i.1.i.i, 3
  %sunkaddr48.i.i = getelementptr i8, ptr %.430, i64 %sunkaddr47.i.i
  %sunkaddr49.i.i = getelementptr i8, ptr %sunkaddr48.i.i, i64 2040
  %.716.1.i.1.i.i = load double, ptr %sunkaddr49.i.i, align 8, !noalias !51
  %.746.1.i.1.i.i = load double, ptr %scevgep37.i.i150, align 8, !noalias !51
  %.748.1.i.1.i.i = fmul contract double %.565.i.i.i, %.746.1.i.1.i.i
  %.749.1.i.1.i.i = fadd contract double %.716.1.i.1.i.i, %.748.1.i.1.i.i
  store double %.749.1.i.1.i.i, ptr %sunkaddr49.i.i, align 8, !noalias !51
  %lsr.iv.next24.i.i152 = add i64 %lsr.iv23.i.i149, 2
  %niter.ncmp.1.i.i153 = icmp eq i64 %lsr.iv.next24.i.i152, 0
  br i1 %niter.ncmp.1.i.i153, label %B284.i.i.i, label %B228.if.i.i.i

B258.endif.endif.endif.endif.endif.i.i:           ; preds = %B284.i.i.i, %B76.i.i.i
  %.1401.i2.i = load i64, ptr %.1400.i.i, align 8, !noalias !48
  %.1407.i.i154 = add nsw i64 %.1401.i2.i, %.1169.i.i
  br i1 %.104.i.i.i, label %B60.if.preheader.i132.i.i, label %B76.i81.i.i

B60.if.preheader.i132.i.i:                        ; preds = %B258.endif.endif.endif.endif.endif.i.i
  tail call void @llvm.memset.p0.i64(ptr nonnull align 8 %.1072.i.i, i8 0, i64 %228, i1 false), !noalias !56
  br label %B76.i81.i.i

B76.i81.i.i:                                      ; preds = %B60.if.preheader.i132.i.i, %B258.endif.endif.endif.endif.endif.i.i
  br i1 %.311284.not.i.i.i, label %B258.endif.endif.endif.endif.endif.endif.endif.i.i, label %B128.if.lr.ph.i83.i.i

B128.if.lr.ph.i83.i.i:                            ; preds = %B76.i81.i.i
  %243 = inttoptr i64 %.1200.i.i to ptr
  %scevgep258.i.i = getelementptr i8, ptr %243, i64 24
  %244 = inttoptr i64 %.1407.i.i154 to ptr
  br label %B128.if.i86.i.i

B284.i129.i.i:                                    ; preds = %B228.if.i106.i.i, %B130.else.endif.endif.endif.endif.i99.i.i
  %exitcond292.not.i130.i.i = icmp eq i64 %.324.i88.i.i, %.134.i
  br i1 %exitcond292.not.i130.i.i, label %B258.endif.endif.endif.endif.endif.endif.endif.i.i, label %B128.if.i86.i.i

B128.if.i86.i.i:                                  ; preds = %B284.i129.i.i, %B128.if.lr.ph.i83.i.i
  %.317279285.i87.i.i = phi i64 [ 0, %B128.if.lr.ph.i83.i.i ], [ %.324.i88.i.i, %B284.i129.i.i ]
  %.324.i88.i.i = add nuw nsw i64 %.317279285.i87.i.i, 1
  %.350.i89.i.i = mul nsw i64 %.317279285.i87.i.i, %.332.i.i143
  %.352.i90.i.i = add nsw i64 %.350.i89.i.i, %.1090933952
  %.395.i91.i.i = icmp slt i64 %.352.i90.i.i, 0
  %.396.i92.i.i = select i1 %.395.i91.i.i, i64 %.1203.i.i148, i64 0
  %.397.i93.i.i = add i64 %.396.i92.i.i, %.352.i90.i.i
  %.400.i94.i.i = icmp slt i64 %.397.i93.i.i, 0
  br i1 %.400.i94.i.i, label %B130.else.if.i131.i.i, label %B130.else.endif.i95.i.i, !prof !54

B130.else.if.i131.i.i:                            ; preds = %B128.if.i86.i.i
  br label %B130.else.endif.i95.i.i

B130.else.endif.i95.i.i:                          ; preds = %B130.else.if.i131.i.i, %B128.if.i86.i.i
  %.385.sroa.0.1.i96.i.i = phi i64 [ 0, %B130.else.if.i131.i.i ], [ %.397.i93.i.i, %B128.if.i86.i.i ]
  %.405.not.i97.i.i = icmp slt i64 %.397.i93.i.i, %.1203.i.i148
  br i1 %.405.not.i97.i.i, label %B130.else.endif.endif.endif.endif.i99.i.i, label %B130.else.endif.if.i98.i.i, !prof !55

B130.else.endif.if.i98.i.i:                       ; preds = %B130.else.endif.i95.i.i
  br label %B130.else.endif.endif.endif.endif.i99.i.i

B130.else.endif.endif.endif.endif.i99.i.i:        ; preds = %B130.else.endif.if.i98.i.i, %B130.else.endif.i95.i.i
  %.385.sroa.0.3.i100.i.i = phi i64 [ %.1203.i.i148, %B130.else.endif.if.i98.i.i ], [ %.385.sroa.0.1.i96.i.i, %B130.else.endif.i95.i.i ]
  %245 = getelementptr double, ptr %244, i64 %.317279285.i87.i.i
  %.565.i102.i.i = load double, ptr %245, align 8, !noalias !56
  br i1 %234, label %B284.i129.i.i, label %B228.if.preheader.i103.i.i

B228.if.preheader.i103.i.i:                       ; preds = %B130.else.endif.endif.endif.endif.i99.i.i
  %246 = shl i64 %.385.sroa.0.3.i100.i.i, 3
  %scevgep259.i.i = getelementptr i8, ptr %scevgep258.i.i, i64 %246
  br label %B228.if.i106.i.i

B228.if.i106.i.i:                                 ; preds = %B228.if.i106.i.i, %B228.if.preheader.i103.i.i
  %lsr.iv5.i.i = phi i64 [ %lsr.iv.next6.i.i, %B228.if.i106.i.i ], [ %233, %B228.if.preheader.i103.i.i ]
  %.655272274.i107.i.i = phi i64 [ %.662.1.i115.1.i.i, %B228.if.i106.i.i ], [ 0, %B228.if.preheader.i103.i.i ]
  %sunkaddr50.i.i = shl i64 %.655272274.i107.i.i, 3
  %sunkaddr51.i.i = getelementptr i8, ptr %.430, i64 %sunkaddr50.i.i
  %sunkaddr52.i.i = getelementptr i8, ptr %sunkaddr51.i.i, i64 3072
  %.716.i109.i.i = load double, ptr %sunkaddr52.i.i, align 8, !noalias !56
  %scevgep21.i.i155 = getelementptr i8, ptr %scevgep259.i.i, i64 %sunkaddr50.i.i
  %scevgep22.i.i156 = getelementptr i8, ptr %scevgep21.i.i155, i64 -16
  %scevgep19.i.i157 = getelementptr i8, ptr %scevgep21.i.i155, i64 -24
  %.746.i112.i.i = load double, ptr %scevgep19.i.i157, align 8, !noalias !56
  %.748.i113.i.i = fmul contract double %.565.i102.i.i, %.746.i112.i.i
  %.749.i114.i.i = fadd contract double %.716.i109.i.i, %.748.i113.i.i
  store double %.749.i114.i.i, ptr %sunkaddr52.i.i, align 8, !noalias !56
  %sunkaddr55.i.i = getelementptr i8, ptr %sunkaddr51.i.i, i64 3080
  %.716.1.i117.i.i = load double, ptr %sunkaddr55.i.i, align 8, !noalias !56
  %.746.1.i118.i.i = load double, ptr %scevgep22.i.i156, align 8, !noalias !56
  %.748.1.i119.i.i = fmul contract double %.565.i102.i.i, %.746.1.i118.i.i
  %.749.1.i120.i.i = fadd contract double %.716.1.i117.i.i, %.748.1.i119.i.i
  store double %.749.1.i120.i.i, ptr %sunkaddr55.i.i, align 8, !noalias !56
  %sunkaddr58.i.i = getelementptr i8, ptr %sunkaddr51.i.i, i64 3088
  %.716.i109.1.i.i = load double, ptr %sunkaddr58.i.i, align 8, !noalias !56
  %scevgep16.i.i = getelementptr i8, ptr %scevgep21.i.i155, i64 -8
  %.746.i112.1.i.i = load double, ptr %scevgep16.i.i, align 8, !noalias !56
  %.748.i113.1.i.i = fmul contract double %.565.i102.i.i, %.746.i112.1.i.i
  %.749.i114.1.i.i = fadd contract double %.716.i109.1.i.i, %.748.i113.1.i.i
  store double %.749.i114.1.i.i, ptr %sunkaddr58.i.i, align 8, !noalias !56
  %.662.1.i115.1.i.i = add i64 %.655272274.i107.i.i, 4
  %sunkaddr59.i.i = shl i64 %.662.1.i115.1.i.i, 3
  %sunkaddr60.i.i = getelementptr i8, ptr %.430, i64 %sunkaddr59.i.i
  %sunkaddr61.i.i = getelementptr i8, ptr %sunkaddr60.i.i, i64 3064
  %.716.1.i117.1.i.i = load double, ptr %sunkaddr61.i.i, align 8, !noalias !56
  %.746.1.i118.1.i.i = load double, ptr %scevgep21.i.i155, align 8, !noalias !56
  %.748.1.i119.1.i.i = fmul contract double %.565.i102.i.i, %.746.1.i118.1.i.i
  %.749.1.i120.1.i.i = fadd contract double %.716.1.i117.1.i.i, %.748.1.i119.1.i.i
  store double %.749.1.i120.1.i.i, ptr %sunkaddr61.i.i, align 8, !noalias !56
  %lsr.iv.next6.i.i = add i64 %lsr.iv5.i.i, 2
  %niter229.ncmp.1.i.i = icmp eq i64 %lsr.iv.next6.i.i, 0
  br i1 %niter229.ncmp.1.i.i, label %B284.i129.i.i, label %B228.if.i106.i.i

B258.endif.endif.endif.endif.endif.endif.endif.i.i: ; preds = %B284.i129.i.i, %B76.i81.i.i
  br i1 %.1542.inv.i.i, label %B1002.i.i, label %B786.if.i.i

B786.if.i.i:                                      ; preds = %B258.endif.endif.endif.endif.endif.endif.endif.i.i, %B786.if.i.i
  %lsr.iv3.i.i158 = phi i64 [ %lsr.iv.next4.i.i159, %B786.if.i.i ], [ %235, %B258.endif.endif.endif.endif.endif.endif.endif.i.i ]
  %lsr.iv245.i.i = phi ptr [ %scevgep246.i.i, %B786.if.i.i ], [ %.1072.i.i, %B258.endif.endif.endif.endif.endif.endif.endif.i.i ]
  %.1631.i.i = load <8 x double>, ptr %lsr.iv245.i.i, align 8, !noalias !48
  %scevgep249.i.i = getelementptr i8, ptr %lsr.iv245.i.i, i64 -1024
  %.1641.i.i = load <8 x double>, ptr %scevgep249.i.i, align 8, !noalias !48
  %.8.i.i3.i = fadd contract <8 x double> %.1641.i.i, splat (double 1.000000e+00)
  %.1668.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1631.i.i, <8 x double> %.1631.i.i, <8 x double> splat (double 4.000000e+00))
  %.6.i.i.i = fdiv contract <8 x double> %.8.i.i3.i, %.1668.i.i
  %247 = fmul contract <8 x double> %.1631.i.i, %.1631.i.i
  %.8.i136.i.i = fsub contract <8 x double> splat (double 4.000000e+00), %247
  %.6.i137.i.i = fmul contract <8 x double> %.8.i136.i.i, %.6.i.i.i
  %scevgep248.i.i = getelementptr i8, ptr %lsr.iv245.i.i, i64 -3072
  store <8 x double> %.6.i137.i.i, ptr %scevgep248.i.i, align 8, !noalias !48
  %.6.i138.i.i = fmul contract <8 x double> %.1631.i.i, %.6.i.i.i
  %.8.i139.i.i = fmul contract <8 x double> %.6.i138.i.i, splat (double 4.000000e+00)
  %scevgep247.i.i = getelementptr i8, ptr %lsr.iv245.i.i, i64 -2048
  store <8 x double> %.8.i139.i.i, ptr %scevgep247.i.i, align 8, !noalias !48
  %scevgep246.i.i = getelementptr i8, ptr %lsr.iv245.i.i, i64 64
  %lsr.iv.next4.i.i159 = add nsw i64 %lsr.iv3.i.i158, -1
  %.1584.i.i = icmp sgt i64 %lsr.iv3.i.i158, 5
  br i1 %.1584.i.i, label %B786.if.i.i, label %B1002.i.i

_ZN17bnserve_inference14adjoint_kernel7_source10_calibrateB4v123B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i: ; preds = %B1002.i.i, %B224.i.i
  %.2303.sink.i.i = phi ptr [ %.2303.i.i160, %B1002.i.i ], [ %.148.i.i, %B224.i.i ]
  tail call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(1024) %.2303.sink.i.i, i8 0, i64 1024, i1 false), !noalias !48
  %.510.i = icmp sgt i64 %.104.i, 0
  br i1 %.510.i, label %B358.if.lr.ph.i, label %B1100.i

B444.i:                                           ; preds = %B358.if.i
  %.157.i.i = getelementptr i8, ptr %275, i64 24576
  tail call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(12288) %.157.i.i, i8 0, i64 12288, i1 false), !noalias !59
  store ptr null, ptr %.747.i, align 8, !noalias !45
  call fastcc void @inner_2(ptr nonnull %.747.i, ptr readonly %lsr.iv270, i64 17, double 1.000000e+00, ptr %.311.i, i64 range(i64 -9223372036854775808, 129) %.13.i, i64 range(i64 -9223372036854775808, 129) %.13.i, ptr %.612.i179)
  store ptr null, ptr %.782.i, align 8, !noalias !45
  call fastcc void @inner_2(ptr nonnull %.782.i, ptr readonly %lsr.iv270, i64 21, double -1.000000e+00, ptr %.311.i, i64 range(i64 -9223372036854775808, 129) %.13.i, i64 range(i64 -9223372036854775808, 129) %.13.i, ptr %.612.i179)
  br label %B632.i

B596.i:                                           ; preds = %B358.if.i
  br i1 %.93.inv.i.i, label %B632.endif.i, label %B158.if.lr.ph.i.i

B158.if.lr.ph.i.i:                                ; preds = %B596.i
  %.2220.5.i.i = getelementptr i8, ptr %275, i64 35840
  br label %B158.if.i.i

B158.if.i.i:                                      ; preds = %B158.if.i.i, %B158.if.lr.ph.i.i
  %lsr.iv6.i.i = phi i64 [ %lsr.iv.next7.i.i, %B158.if.i.i ], [ %237, %B158.if.lr.ph.i.i ]
  %lsr.iv226.i.i = phi ptr [ %scevgep.i.i198, %B158.if.i.i ], [ %.2220.5.i.i, %B158.if.lr.ph.i.i ]
  %scevgep239.i.i = getelementptr i8, ptr %lsr.iv226.i.i, i64 -17408
  %.362.i.i = load <8 x double>, ptr %scevgep239.i.i, align 8, !noalias !62
  %scevgep238.i.i = getelementptr i8, ptr %lsr.iv226.i.i, i64 -16384
  %.373.i.i182 = load <8 x double>, ptr %scevgep238.i.i, align 8, !noalias !62
  %.6.i.i6.i = fmul contract <8 x double> %.362.i.i, %.362.i.i
  %.6.i111.i.i = fmul contract <8 x double> %.373.i.i182, %.373.i.i182
  %.6.i112.i.i = fsub contract <8 x double> %.6.i.i6.i, %.6.i111.i.i
  %.6.i113.i.i = fmul contract <8 x double> %.362.i.i, %.373.i.i182
  %.8.i.i7.i = fmul contract <8 x double> %.6.i113.i.i, splat (double 2.000000e+00)
  %.610.i.i183 = load double, ptr %sunkaddr8.i.i, align 8, !noalias !62
  %.640.i.i = load double, ptr %sunkaddr9.i.i, align 8, !noalias !62
  %.669.i.i184 = load double, ptr %sunkaddr10.i.i, align 8, !noalias !62
  %.670.i.i185 = insertelement <8 x double> poison, double %.669.i.i184, i64 0
  %.671.i.i = shufflevector <8 x double> %.670.i.i185, <8 x double> poison, <8 x i32> zeroinitializer
  %.672.i.i186 = insertelement <8 x double> poison, double %.640.i.i, i64 0
  %.673.i.i187 = shufflevector <8 x double> %.672.i.i186, <8 x double> poison, <8 x i32> zeroinitializer
  %.674.i.i188 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.362.i.i, <8 x double> %.673.i.i187, <8 x double> %.671.i.i)
  %.675.i.i189 = insertelement <8 x double> poison, double %.610.i.i183, i64 0
  %.676.i.i190 = shufflevector <8 x double> %.675.i.i189, <8 x double> poison, <8 x i32> zeroinitializer
  %.677.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.373.i.i182, <8 x double> %.676.i.i190, <8 x double> %.674.i.i188)
  %.707.i.i = load double, ptr %sunkaddr11.i.i, align 8, !noalias !62
  %.737.i.i = load double, ptr %sunkaddr12.i.i172, align 8, !noalias !62
  %.741.i.i = insertelement <8 x double> poison, double %.737.i.i, i64 0
  %.742.i.i = shufflevector <8 x double> %.741.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.743.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i112.i.i, <8 x double> %.742.i.i, <8 x double> %.677.i.i)
  %.744.i.i = insertelement <8 x double> poison, double %.707.i.i, i64 0
  %.745.i.i191 = shufflevector <8 x double> %.744.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.746.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i.i7.i, <8 x double> %.745.i.i191, <8 x double> %.743.i.i)
  %scevgep237.i.i = getelementptr i8, ptr %lsr.iv226.i.i, i64 -11264
  store <8 x double> %.746.i.i, ptr %scevgep237.i.i, align 8, !noalias !62
  %.877.i.i = load double, ptr %sunkaddr13.i.i173, align 8, !noalias !62
  %.907.i.i = load double, ptr %sunkaddr14.i.i174, align 8, !noalias !62
  %.936.i.i = load double, ptr %sunkaddr15.i.i, align 8, !noalias !62
  %.937.i.i = insertelement <8 x double> poison, double %.936.i.i, i64 0
  %.938.i.i = shufflevector <8 x double> %.937.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.939.i.i = insertelement <8 x double> poison, double %.907.i.i, i64 0
  %.940.i.i = shufflevector <8 x double> %.939.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.941.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.362.i.i, <8 x double> %.940.i.i, <8 x double> %.938.i.i)
  %.942.i.i = insertelement <8 x double> poison, double %.877.i.i, i64 0
  %.943.i.i = shufflevector <8 x double> %.942.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.944.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.373.i.i182, <8 x double> %.943.i.i, <8 x double> %.941.i.i)
  %.974.i.i = load double, ptr %sunkaddr16.i.i, align 8, !noalias !62
  %.1004.i.i = load double, ptr %sunkaddr17.i.i, align 8, !noalias !62
  %.1008.i.i = insertelement <8 x double> poison, double %.1004.i.i, i64 0
  %.1009.i.i = shufflevector <8 x double> %.1008.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1010.i8.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i112.i.i, <8 x double> %.1009.i.i, <8 x double> %.944.i.i)
  %.1011.i.i = insertelement <8 x double> poison, double %.974.i.i, i64 0
  %.1012.i.i = shufflevector <8 x double> %.1011.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1013.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i.i7.i, <8 x double> %.1012.i.i, <8 x double> %.1010.i8.i)
  %scevgep236.i.i = getelementptr i8, ptr %lsr.iv226.i.i, i64 -9216
  store <8 x double> %.1013.i.i, ptr %scevgep236.i.i, align 8, !noalias !62
  %.1144.i.i = load double, ptr %sunkaddr8.i.i, align 8, !noalias !62
  %.1174.i.i = load double, ptr %sunkaddr9.i.i, align 8, !noalias !62
  %.1175.i.i = fsub contract double 0.000000e+00, %.1174.i.i
  %.6.i129.i9.i = insertelement <8 x double> poison, double %.1175.i.i, i64 0
  %.7.i.i10.i = shufflevector <8 x double> %.6.i129.i9.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.8.i130.i.i = fmul contract <8 x double> %.373.i.i182, %.7.i.i10.i
  %.1200.i11.i = insertelement <8 x double> poison, double %.1144.i.i, i64 0
  %.1201.i.i = shufflevector <8 x double> %.1200.i11.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1202.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.362.i.i, <8 x double> %.1201.i.i, <8 x double> %.8.i130.i.i)
  %.1232.i.i = load double, ptr %sunkaddr11.i.i, align 8, !noalias !62
  %.1233.i.i = fmul contract double %.1232.i.i, 2.000000e+00
  %.1263.i.i = load double, ptr %sunkaddr12.i.i172, align 8, !noalias !62
  %.1267.i.i = fmul contract double %.1263.i.i, -2.000000e+00
  %.1268.i.i192 = insertelement <8 x double> poison, double %.1267.i.i, i64 0
  %.1269.i.i = shufflevector <8 x double> %.1268.i.i192, <8 x double> poison, <8 x i32> zeroinitializer
  %.1270.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i.i7.i, <8 x double> %.1269.i.i, <8 x double> %.1202.i.i)
  %.1271.i.i = insertelement <8 x double> poison, double %.1233.i.i, i64 0
  %.1272.i.i = shufflevector <8 x double> %.1271.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1273.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i112.i.i, <8 x double> %.1272.i.i, <8 x double> %.1270.i.i)
  %scevgep235.i.i = getelementptr i8, ptr %lsr.iv226.i.i, i64 -7168
  store <8 x double> %.1273.i.i, ptr %scevgep235.i.i, align 8, !noalias !62
  %.1404.i.i = load double, ptr %sunkaddr13.i.i173, align 8, !noalias !62
  %.1434.i.i = load double, ptr %sunkaddr14.i.i174, align 8, !noalias !62
  %.1435.i.i = fsub contract double 0.000000e+00, %.1434.i.i
  %.6.i136.i.i = insertelement <8 x double> poison, double %.1435.i.i, i64 0
  %.7.i137.i.i = shufflevector <8 x double> %.6.i136.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.8.i138.i.i = fmul contract <8 x double> %.373.i.i182, %.7.i137.i.i
  %.1460.i.i = insertelement <8 x double> poison, double %.1404.i.i, i64 0
  %.1461.i.i = shufflevector <8 x double> %.1460.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1462.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.362.i.i, <8 x double> %.1461.i.i, <8 x double> %.8.i138.i.i)
  %.1492.i.i = load double, ptr %sunkaddr16.i.i, align 8, !noalias !62
  %.1493.i.i = fmul contract double %.1492.i.i, 2.000000e+00
  %.1523.i.i193 = load double, ptr %sunkaddr17.i.i, align 8, !noalias !62
  %.1527.i12.i = fmul contract double %.1523.i.i193, -2.000000e+00
  %.1528.i.i = insertelement <8 x double> poison, double %.1527.i12.i, i64 0
  %.1529.i.i = shufflevector <8 x double> %.1528.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1530.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i.i7.i, <8 x double> %.1529.i.i, <8 x double> %.1462.i.i)
  %.1531.i.i = insertelement <8 x double> poison, double %.1493.i.i, i64 0
  %.1532.i.i = shufflevector <8 x double> %.1531.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1533.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i112.i.i, <8 x double> %.1532.i.i, <8 x double> %.1530.i.i)
  %scevgep234.i.i = getelementptr i8, ptr %lsr.iv226.i.i, i64 -5120
  store <8 x double> %.1533.i.i, ptr %scevgep234.i.i, align 8, !noalias !62
  %.1664.i.i = load double, ptr %sunkaddr18.i.i175, align 8, !noalias !62
  %.1694.i.i = load double, ptr %sunkaddr19.i.i, align 8, !noalias !62
  %.1723.i.i = load double, ptr %lsr.iv, align 8, !noalias !62
  %.1724.i.i = insertelement <8 x double> poison, double %.1723.i.i, i64 0
  %.1725.i.i = shufflevector <8 x double> %.1724.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1726.i.i = insertelement <8 x double> poison, double %.1694.i.i, i64 0
  %.1727.i.i = shufflevector <8 x double> %.1726.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1728.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.362.i.i, <8 x double> %.1727.i.i, <8 x double> %.1725.i.i)
  %.1729.i.i = insertelement <8 x double> poison, double %.1664.i.i, i64 0
  %.1730.i.i = shufflevector <8 x double> %.1729.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1731.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.373.i.i182, <8 x double> %.1730.i.i, <8 x double> %.1728.i.i)
  %.1761.i.i = load double, ptr %sunkaddr.i5.i, align 8, !noalias !62
  %.1791.i.i = load double, ptr %sunkaddr20.i.i, align 8, !noalias !62
  %.1795.i.i = insertelement <8 x double> poison, double %.1791.i.i, i64 0
  %.1796.i.i = shufflevector <8 x double> %.1795.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1797.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i112.i.i, <8 x double> %.1796.i.i, <8 x double> %.1731.i.i)
  %.1798.i.i = insertelement <8 x double> poison, double %.1761.i.i, i64 0
  %.1799.i.i = shufflevector <8 x double> %.1798.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1800.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i.i7.i, <8 x double> %.1799.i.i, <8 x double> %.1797.i.i)
  %scevgep233.i.i = getelementptr i8, ptr %lsr.iv226.i.i, i64 -3072
  store <8 x double> %.1800.i.i, ptr %scevgep233.i.i, align 8, !noalias !62
  %.1931.i.i = load double, ptr %sunkaddr21.i.i176, align 8, !noalias !62
  %.1961.i.i194 = load double, ptr %sunkaddr22.i.i, align 8, !noalias !62
  %.1990.i.i = load double, ptr %sunkaddr23.i.i, align 8, !noalias !62
  %.1991.i.i = insertelement <8 x double> poison, double %.1990.i.i, i64 0
  %.1992.i.i = shufflevector <8 x double> %.1991.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1993.i.i = insertelement <8 x double> poison, double %.1961.i.i194, i64 0
  %.1994.i.i195 = shufflevector <8 x double> %.1993.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1995.i.i196 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.362.i.i, <8 x double> %.1994.i.i195, <8 x double> %.1992.i.i)
  %.1996.i.i = insertelement <8 x double> poison, double %.1931.i.i, i64 0
  %.1997.i.i = shufflevector <8 x double> %.1996.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1998.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.373.i.i182, <8 x double> %.1997.i.i, <8 x double> %.1995.i.i196)
  %.2028.i.i = load double, ptr %sunkaddr24.i.i177, align 8, !noalias !62
  %.2058.i.i = load double, ptr %sunkaddr25.i.i, align 8, !noalias !62
  %.2062.i.i = insertelement <8 x double> poison, double %.2058.i.i, i64 0
  %.2063.i.i = shufflevector <8 x double> %.2062.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.2064.i.i197 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i112.i.i, <8 x double> %.2063.i.i, <8 x double> %.1998.i.i)
  %.2065.i.i = insertelement <8 x double> poison, double %.2028.i.i, i64 0
  %.2066.i.i = shufflevector <8 x double> %.2065.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.2067.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i.i7.i, <8 x double> %.2066.i.i, <8 x double> %.2064.i.i197)
  %scevgep232.i.i = getelementptr i8, ptr %lsr.iv226.i.i, i64 -1024
  store <8 x double> %.2067.i.i, ptr %scevgep232.i.i, align 8, !noalias !62
  %scevgep231.i.i = getelementptr i8, ptr %lsr.iv226.i.i, i64 -10240
  store <8 x double> zeroinitializer, ptr %scevgep231.i.i, align 8, !noalias !62
  %scevgep230.i.i = getelementptr i8, ptr %lsr.iv226.i.i, i64 -8192
  store <8 x double> zeroinitializer, ptr %scevgep230.i.i, align 8, !noalias !62
  %scevgep229.i.i = getelementptr i8, ptr %lsr.iv226.i.i, i64 -6144
  store <8 x double> zeroinitializer, ptr %scevgep229.i.i, align 8, !noalias !62
  %scevgep228.i.i = getelementptr i8, ptr %lsr.iv226.i.i, i64 -4096
  store <8 x double> zeroinitializer, ptr %scevgep228.i.i, align 8, !noalias !62
  %scevgep227.i.i = getelementptr i8, ptr %lsr.iv226.i.i, i64 -2048
  store <8 x double> zeroinitializer, ptr %scevgep227.i.i, align 8, !noalias !62
  store <8 x double> zeroinitializer, ptr %lsr.iv226.i.i, align 8, !noalias !62
  %scevgep.i.i198 = getelementptr i8, ptr %lsr.iv226.i.i, i64 64
  %lsr.iv.next7.i.i = add nsw i64 %lsr.iv6.i.i, -1
  %.311.i.i = icmp sgt i64 %lsr.iv6.i.i, 5
  br i1 %.311.i.i, label %B158.if.i.i, label %B632.i

B632.i:                                           ; preds = %B158.if.i.i, %B444.i
  %.909.i = load double, ptr %sunkaddr47.i, align 8, !noalias !45
  %.1401.i.i = insertelement <8 x double> poison, double %.909.i, i64 0
  %.1402.i.i = shufflevector <8 x double> %.1401.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  br i1 %.93.inv.i.i, label %B632.endif.i, label %B52.lr.ph.i.i

B52.lr.ph.i.i:                                    ; preds = %B632.i
  %.939.i = load i64, ptr %sunkaddr48.i, align 8, !noalias !45
  %.879.i = load double, ptr %sunkaddr.i178, align 8, !noalias !45
  %.6.i980.i.i = insertelement <8 x double> poison, double %.879.i, i64 0
  %.7.i.i.i = shufflevector <8 x double> %.6.i980.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %248 = icmp eq i64 %.939.i, 1
  br label %B52.i.i

B52.i.i:                                          ; preds = %B1190.i.i, %B52.lr.ph.i.i
  %.127.sroa.0.0923.i.i = phi i64 [ 0, %B52.lr.ph.i.i ], [ %.127.sroa.0.0.i.i, %B1190.i.i ]
  %.82.1922.in.i.i = phi i64 [ %236, %B52.lr.ph.i.i ], [ %259, %B1190.i.i ]
  %.79.1921.i.i = phi i64 [ 8, %B52.lr.ph.i.i ], [ %.79.1.i.i, %B1190.i.i ]
  %.267.i.i199 = getelementptr inbounds double, ptr %.612.i179, i64 %.127.sroa.0.0923.i.i
  %.269.i.i = load <8 x double>, ptr %.267.i.i199, align 8, !noalias !65
  %sunkaddr.i.i200 = shl i64 %.127.sroa.0.0923.i.i, 3
  %sunkaddr1161.i.i = getelementptr inbounds i8, ptr %.612.i179, i64 %sunkaddr.i.i200
  %sunkaddr1162.i.i = getelementptr inbounds nuw i8, ptr %sunkaddr1161.i.i, i64 1024
  %.365.i.i201 = load <8 x double>, ptr %sunkaddr1162.i.i, align 8, !noalias !65
  %sunkaddr1165.i.i = getelementptr inbounds nuw i8, ptr %sunkaddr1161.i.i, i64 2048
  %.460.i.i202 = load <8 x double>, ptr %sunkaddr1165.i.i, align 8, !noalias !65
  %sunkaddr1168.i.i = getelementptr inbounds nuw i8, ptr %sunkaddr1161.i.i, i64 3072
  %.556.i.i203 = load <8 x double>, ptr %sunkaddr1168.i.i, align 8, !noalias !65
  %sunkaddr1171.i.i = getelementptr inbounds nuw i8, ptr %sunkaddr1161.i.i, i64 10240
  %.652.i.i204 = load <8 x double>, ptr %sunkaddr1171.i.i, align 8, !noalias !65
  %sunkaddr1174.i.i = getelementptr inbounds nuw i8, ptr %sunkaddr1161.i.i, i64 11264
  %.748.i.i = load <8 x double>, ptr %sunkaddr1174.i.i, align 8, !noalias !65
  %249 = fneg contract <8 x double> %.365.i.i201
  %.8.i.i.i = fmul contract <8 x double> %.748.i.i, %249
  %.800.i.i205 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.652.i.i204, <8 x double> %.269.i.i, <8 x double> %.8.i.i.i)
  %.6.i960.i.i = fmul contract <8 x double> %.269.i.i, %.748.i.i
  %.825.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.652.i.i204, <8 x double> %.365.i.i201, <8 x double> %.6.i960.i.i)
  %sunkaddr1177.i.i = getelementptr inbounds nuw i8, ptr %sunkaddr1161.i.i, i64 12288
  %.945.i.i = load <8 x double>, ptr %sunkaddr1177.i.i, align 8, !noalias !65
  %sunkaddr1180.i.i = getelementptr inbounds nuw i8, ptr %sunkaddr1161.i.i, i64 13312
  %.1041.i.i = load <8 x double>, ptr %sunkaddr1180.i.i, align 8, !noalias !65
  %250 = fneg contract <8 x double> %.556.i.i203
  %.8.i972.i.i = fmul contract <8 x double> %.1041.i.i, %250
  %.1093.i.i206 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.945.i.i, <8 x double> %.460.i.i202, <8 x double> %.8.i972.i.i)
  %.6.i973.i.i = fmul contract <8 x double> %.460.i.i202, %.1041.i.i
  %.1118.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.945.i.i, <8 x double> %.556.i.i203, <8 x double> %.6.i973.i.i)
  br i1 %248, label %B864.i.i, label %B1190.i.i

B864.i.i:                                         ; preds = %B52.i.i
  %sunkaddr53.i = getelementptr i8, ptr %sunkaddr1161.i.i, i64 4096
  %.1249.i.i = load <8 x double>, ptr %sunkaddr53.i, align 8, !noalias !65
  %sunkaddr57.i = getelementptr i8, ptr %sunkaddr1161.i.i, i64 5120
  %.1345.i.i274 = load <8 x double>, ptr %sunkaddr57.i, align 8, !noalias !65
  %.6.i979.i.i = fsub contract <8 x double> splat (double 1.000000e+00), %.1249.i.i
  %.8.i981.i.i = fmul contract <8 x double> %.7.i.i.i, %.6.i979.i.i
  %.1413.i.i275 = getelementptr inbounds double, ptr %.311.i, i64 %.127.sroa.0.0923.i.i
  %.1415.i.i = load <8 x double>, ptr %.1413.i.i275, align 8, !noalias !65
  %.8.i982.i.i = fmul contract <8 x double> %.1415.i.i, splat (double 0xC01921FB54442D18)
  %.1403.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1345.i.i274, <8 x double> %.1402.i.i, <8 x double> %.8.i981.i.i)
  %.6.i983.i.i = fmul contract <8 x double> %.1403.i.i, %.8.i982.i.i
  %.1469.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i983.i.i, <8 x double> splat (double 0x3FE45F306DC9C883), <8 x double> splat (double 0x4338000000000000))
  %.8.i984.i.i = fadd contract <8 x double> %.1469.i.i, splat (double 0xC338000000000000)
  %.1510.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i984.i.i, <8 x double> splat (double 0xBFF921FB54442D18), <8 x double> %.6.i983.i.i)
  %.1527.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i984.i.i, <8 x double> splat (double 0xBC91A62633145C07), <8 x double> %.1510.i.i)
  %.6.i985.i.i = fmul contract <8 x double> %.1527.i.i, %.1527.i.i
  %.6.i986.i.i = fmul contract <8 x double> %.1527.i.i, %.6.i985.i.i
  %.1556.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i985.i.i, <8 x double> splat (double 0xBD6AE7F3E733B81F), <8 x double> splat (double 0x3DE6124613A86D09))
  %.1559.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i985.i.i, <8 x double> %.1556.i.i, <8 x double> splat (double 0xBE5AE64567F544E4))
  %.1562.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i985.i.i, <8 x double> %.1559.i.i, <8 x double> splat (double 0x3EC71DE3A556C734))
  %.1565.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i985.i.i, <8 x double> %.1562.i.i, <8 x double> splat (double 0xBF2A01A01A01A01A))
  %.1568.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i985.i.i, <8 x double> %.1565.i.i, <8 x double> splat (double 0x3F81111111111111))
  %.1571.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i985.i.i, <8 x double> %.1568.i.i, <8 x double> splat (double 0xBFC5555555555555))
  %.1596.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i986.i.i, <8 x double> %.1571.i.i, <8 x double> %.1527.i.i)
  %.1601.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i985.i.i, <8 x double> splat (double 0x3D2AE7F3E733B81F), <8 x double> splat (double 0xBDA93974A8C07C9D))
  %.1604.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i985.i.i, <8 x double> %.1601.i.i, <8 x double> splat (double 0x3E21EED8EFF8D898))
  %.1607.i.i276 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i985.i.i, <8 x double> %.1604.i.i, <8 x double> splat (double 0xBE927E4FB7789F5C))
  %.1610.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i985.i.i, <8 x double> %.1607.i.i276, <8 x double> splat (double 0x3EFA01A01A01A01A))
  %.1613.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i985.i.i, <8 x double> %.1610.i.i, <8 x double> splat (double 0xBF56C16C16C16C17))
  %.1616.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i985.i.i, <8 x double> %.1613.i.i, <8 x double> splat (double 0x3FA5555555555555))
  %.1619.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i985.i.i, <8 x double> %.1616.i.i, <8 x double> splat (double -5.000000e-01))
  %.1622.i.i277 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i985.i.i, <8 x double> %.1619.i.i, <8 x double> splat (double 1.000000e+00))
  %.1623.i.i = bitcast <8 x double> %.1469.i.i to <8 x i64>
  %.1624.i.i278 = bitcast <8 x double> %.1596.i.i to <8 x i64>
  %.1625.i.i = bitcast <8 x double> %.1622.i.i277 to <8 x i64>
  %.6.i987.i.i = xor <8 x i64> %.1625.i.i, %.1624.i.i278
  %.8.i988.i.i = and <8 x i64> %.1623.i.i, splat (i64 1)
  %251 = icmp eq <8 x i64> %.8.i988.i.i, zeroinitializer
  %.6.i990.i.i = select <8 x i1> %251, <8 x i64> zeroinitializer, <8 x i64> %.6.i987.i.i
  %.8.i991.i.i = shl <8 x i64> %.1623.i.i, splat (i64 62)
  %.8.i992.i.i = and <8 x i64> %.8.i991.i.i, splat (i64 -9223372036854775808)
  %.8.i994.i.i = add <8 x i64> %.8.i991.i.i, splat (i64 4611686018427387904)
  %.8.i995.i.i = and <8 x i64> %.8.i994.i.i, splat (i64 -9223372036854775808)
  %252 = xor <8 x i64> %.8.i992.i.i, %.1624.i.i278
  %.6.i997.i.i = xor <8 x i64> %252, %.6.i990.i.i
  %253 = bitcast <8 x i64> %.6.i997.i.i to <8 x double>
  %254 = xor <8 x i64> %.8.i995.i.i, %.1625.i.i
  %.6.i999.i.i = xor <8 x i64> %254, %.6.i990.i.i
  %255 = bitcast <8 x i64> %.6.i999.i.i to <8 x double>
  br label %B1190.i.i

B1190.i.i:                                        ; preds = %B864.i.i, %B52.i.i
  %sine.2.1.i.i = phi <8 x double> [ %253, %B864.i.i ], [ zeroinitializer, %B52.i.i ]
  %cosine.2.1.i.i = phi <8 x double> [ %255, %B864.i.i ], [ splat (double 1.000000e+00), %B52.i.i ]
  %sunkaddr63.i207 = getelementptr i8, ptr %sunkaddr1161.i.i, i64 8192
  store <8 x double> %cosine.2.1.i.i, ptr %sunkaddr63.i207, align 8, !noalias !65
  %sunkaddr69.i208 = getelementptr i8, ptr %sunkaddr1161.i.i, i64 9216
  store <8 x double> %sine.2.1.i.i, ptr %sunkaddr69.i208, align 8, !noalias !65
  %.6.i1005.i.i = fadd contract <8 x double> %.800.i.i205, %.1093.i.i206
  %.6.i1006.i.i = fadd contract <8 x double> %.825.i.i, %.1118.i.i
  %256 = fneg contract <8 x double> %sine.2.1.i.i
  %.8.i1008.i.i = fmul contract <8 x double> %.6.i1006.i.i, %256
  %.2273.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i1005.i.i, <8 x double> %cosine.2.1.i.i, <8 x double> %.8.i1008.i.i)
  %.6.i1009.i.i = fmul contract <8 x double> %.6.i1006.i.i, %cosine.2.1.i.i
  %.2298.i.i209 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i1005.i.i, <8 x double> %sine.2.1.i.i, <8 x double> %.6.i1009.i.i)
  %.2408.i.i = getelementptr inbounds double, ptr %.430, i64 %.127.sroa.0.0923.i.i
  %.2410.i.i = load <8 x double>, ptr %.2408.i.i, align 8, !noalias !65
  %sunkaddr71.i = getelementptr i8, ptr %.430, i64 %sunkaddr.i.i200
  %sunkaddr72.i210 = getelementptr i8, ptr %sunkaddr71.i, i64 1024
  %.2506.i.i = load <8 x double>, ptr %sunkaddr72.i210, align 8, !noalias !65
  %257 = fneg contract <8 x double> %.2506.i.i
  %.8.i1021.i.i = fmul contract <8 x double> %.2298.i.i209, %257
  %.2559.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.2273.i.i, <8 x double> %.2410.i.i, <8 x double> %.8.i1021.i.i)
  %.6.i1022.i.i = fmul contract <8 x double> %.2298.i.i209, %.2410.i.i
  %.2584.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.2273.i.i, <8 x double> %.2506.i.i, <8 x double> %.6.i1022.i.i)
  %sunkaddr75.i = getelementptr i8, ptr %sunkaddr1161.i.i, i64 6144
  store <8 x double> %.2559.i.i, ptr %sunkaddr75.i, align 8, !noalias !65
  %sunkaddr78.i = getelementptr i8, ptr %sunkaddr1161.i.i, i64 7168
  store <8 x double> %.2584.i.i, ptr %sunkaddr78.i, align 8, !noalias !65
  %.137.i.i211 = icmp samesign ugt i64 %.82.1922.in.i.i, 1
  %.150.i.i212 = add i64 %.79.1921.i.i, 8
  %.79.1.i.i = select i1 %.137.i.i211, i64 %.150.i.i212, i64 %.79.1921.i.i
  %258 = tail call i64 @llvm.smax.i64(i64 %.82.1922.in.i.i, i64 2)
  %259 = add nsw i64 %258, -1
  %.127.sroa.0.0.i.i = select i1 %.137.i.i211, i64 %.79.1921.i.i, i64 0
  br i1 %.137.i.i211, label %B52.i.i, label %B632.endif.i

B802.if.lr.ph.i:                                  ; preds = %B632.endif.i
  %.1298.i = icmp slt i64 %.134.i, 1
  %or.cond.i214 = select i1 %.1298.i, i1 true, i1 %.93.inv.i.i
  %.5541.i.i = getelementptr i8, ptr %lsr.iv, i64 120
  %.5861.i.i = getelementptr i8, ptr %lsr.iv, i64 128
  %.6181.i.i = getelementptr i8, ptr %lsr.iv, i64 136
  %.6501.i.i = getelementptr i8, ptr %lsr.iv, i64 144
  %sunkaddr37.i.i = getelementptr i8, ptr %lsr.iv, i64 88
  %sunkaddr38.i.i = getelementptr i8, ptr %lsr.iv, i64 96
  br label %B802.if.i

B268.if.i.i:                                      ; preds = %_ZN17bnserve_inference14adjoint_kernel7_source14_through_pairsB4v324B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i, %B268.if.i.i
  %lsr.iv44.i = phi i64 [ %lsr.iv.next45.i, %B268.if.i.i ], [ %237, %_ZN17bnserve_inference14adjoint_kernel7_source14_through_pairsB4v324B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i ]
  %lsr.iv145.i = phi ptr [ %scevgep.i261, %B268.if.i.i ], [ %.430, %_ZN17bnserve_inference14adjoint_kernel7_source14_through_pairsB4v324B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i ]
  %scevgep154.i = getelementptr i8, ptr %lsr.iv145.i, i64 6144
  %.608.i.i = load <8 x double>, ptr %scevgep154.i, align 8, !noalias !68
  %scevgep153.i = getelementptr i8, ptr %lsr.iv145.i, i64 7168
  %.703.i.i = load <8 x double>, ptr %scevgep153.i, align 8, !noalias !68
  %scevgep147.i = getelementptr i8, ptr %lsr.iv145.i, i64 %lsr.iv.i222
  %scevgep148.i = getelementptr i8, ptr %scevgep147.i, i64 -1024
  %.797.i.i258 = load <8 x double>, ptr %scevgep148.i, align 8, !noalias !68
  %.892.i.i259 = load <8 x double>, ptr %scevgep147.i, align 8, !noalias !68
  %260 = fneg contract <8 x double> %.892.i.i259
  %.8.i.i30.i = fmul contract <8 x double> %.703.i.i, %260
  %.945.i31.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.608.i.i, <8 x double> %.797.i.i258, <8 x double> %.8.i.i30.i)
  %.6.i127.i.i = fmul contract <8 x double> %.703.i.i, %.797.i.i258
  %.970.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.608.i.i, <8 x double> %.892.i.i259, <8 x double> %.6.i127.i.i)
  %scevgep152.i = getelementptr i8, ptr %lsr.iv145.i, i64 4096
  %.1000.i.i260 = load <8 x double>, ptr %scevgep152.i, align 8, !noalias !68
  %scevgep151.i = getelementptr i8, ptr %lsr.iv145.i, i64 2048
  %.1010.i.i = load <8 x double>, ptr %scevgep151.i, align 8, !noalias !68
  %.8.i128.i.i = fadd contract <8 x double> %.1010.i.i, splat (double 1.000000e+00)
  %.6.i129.i.i = fdiv contract <8 x double> %.945.i31.i, %.8.i128.i.i
  %.6.i130.i.i = fadd contract <8 x double> %.1000.i.i260, %.6.i129.i.i
  store <8 x double> %.6.i130.i.i, ptr %scevgep152.i, align 8, !noalias !68
  %scevgep150.i = getelementptr i8, ptr %lsr.iv145.i, i64 3072
  %.1102.i.i = load <8 x double>, ptr %scevgep150.i, align 8, !noalias !68
  %scevgep149.i = getelementptr i8, ptr %lsr.iv145.i, i64 5120
  %.1112.i.i = load <8 x double>, ptr %scevgep149.i, align 8, !noalias !68
  %.8.i131.i.i = fmul contract <8 x double> %.970.i.i, splat (double 4.000000e+00)
  %.1139.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1102.i.i, <8 x double> %.1102.i.i, <8 x double> splat (double 4.000000e+00))
  %.6.i132.i.i = fdiv contract <8 x double> %.8.i131.i.i, %.1139.i.i
  %.6.i133.i.i = fsub contract <8 x double> %.1112.i.i, %.6.i132.i.i
  store <8 x double> %.6.i133.i.i, ptr %scevgep149.i, align 8, !noalias !68
  %scevgep.i261 = getelementptr i8, ptr %lsr.iv145.i, i64 64
  %lsr.iv.next45.i = add nsw i64 %lsr.iv44.i, -1
  %.480.i.i = icmp sgt i64 %lsr.iv44.i, 5
  br i1 %.480.i.i, label %B268.if.i.i, label %B1008.i

B1008.i:                                          ; preds = %B268.if.i.i, %_ZN17bnserve_inference14adjoint_kernel7_source14_through_pairsB4v324B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i
  br i1 %.93.inv.i.i, label %_ZN17bnserve_inference14adjoint_kernel5_back9pull_backB4v367B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i, label %B250.lr.ph.i.i

B250.lr.ph.i.i:                                   ; preds = %B1008.i
  %.144.i.i = load double, ptr %sunkaddr47.i, align 8, !noalias !71
  %.115.i.i = load double, ptr %sunkaddr.i178, align 8, !noalias !71
  %.6.i4376.i.i = insertelement <8 x double> poison, double %.115.i.i, i64 0
  %.7.i.i14.i = shufflevector <8 x double> %.6.i4376.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.6.i4378.i.i = insertelement <8 x double> poison, double %.144.i.i, i64 0
  %.7.i4379.i.i = shufflevector <8 x double> %.6.i4378.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  br label %B250.i.i

B250.i.i:                                         ; preds = %B5889.i.i, %B250.lr.ph.i.i
  %.269.sroa.0.04226.i.i = phi i64 [ 0, %B250.lr.ph.i.i ], [ %.269.sroa.0.0.i.i, %B5889.i.i ]
  %.224.14225.in.i.i = phi i64 [ %236, %B250.lr.ph.i.i ], [ %266, %B5889.i.i ]
  %.221.14224.i.i = phi i64 [ 8, %B250.lr.ph.i.i ], [ %.221.1.i.i, %B5889.i.i ]
  %by_time.2.04223.i.i = phi <8 x double> [ zeroinitializer, %B250.lr.ph.i.i ], [ %.6.i4263.i.i, %B5889.i.i ]
  %by_polarization.2.04222.i.i = phi <8 x double> [ zeroinitializer, %B250.lr.ph.i.i ], [ %.6.i4464.i.i, %B5889.i.i ]
  %by_declination.2.04221.i.i = phi <8 x double> [ zeroinitializer, %B250.lr.ph.i.i ], [ %.6.i4435.i.i, %B5889.i.i ]
  %by_hour.2.04220.i.i = phi <8 x double> [ zeroinitializer, %B250.lr.ph.i.i ], [ %.6.i4382.i.i, %B5889.i.i ]
  %sunkaddr.i15.i = shl i64 %.269.sroa.0.04226.i.i, 3
  %sunkaddr4737.i.i = getelementptr inbounds i8, ptr %.430, i64 %sunkaddr.i15.i
  %sunkaddr4738.i.i = getelementptr inbounds nuw i8, ptr %sunkaddr4737.i.i, i64 6144
  %.411.i.i = load <8 x double>, ptr %sunkaddr4738.i.i, align 8, !noalias !71
  %sunkaddr4741.i.i = getelementptr inbounds nuw i8, ptr %sunkaddr4737.i.i, i64 7168
  %.507.i.i = load <8 x double>, ptr %sunkaddr4741.i.i, align 8, !noalias !71
  %sunkaddr4743.i.i = getelementptr inbounds i8, ptr %.1126.i, i64 %sunkaddr.i15.i
  %sunkaddr4744.i.i = getelementptr inbounds nuw i8, ptr %sunkaddr4743.i.i, i64 6144
  %.602.i.i262 = load <8 x double>, ptr %sunkaddr4744.i.i, align 8, !noalias !71
  %sunkaddr4747.i.i = getelementptr inbounds nuw i8, ptr %sunkaddr4743.i.i, i64 7168
  %.698.i.i = load <8 x double>, ptr %sunkaddr4747.i.i, align 8, !noalias !71
  %sunkaddr4750.i.i = getelementptr inbounds nuw i8, ptr %sunkaddr4737.i.i, i64 8192
  %.793.i.i263 = load <8 x double>, ptr %sunkaddr4750.i.i, align 8, !noalias !71
  %sunkaddr4753.i.i = getelementptr inbounds nuw i8, ptr %sunkaddr4737.i.i, i64 9216
  %.889.i.i264 = load <8 x double>, ptr %sunkaddr4753.i.i, align 8, !noalias !71
  %.1028.i.i265 = getelementptr inbounds double, ptr %.311.i, i64 %.269.sroa.0.04226.i.i
  %.1030.i.i = load <8 x double>, ptr %.1028.i.i265, align 8, !noalias !71
  %sunkaddr4756.i.i = getelementptr inbounds nuw i8, ptr %sunkaddr4743.i.i, i64 4096
  %.1173.i.i266 = load <8 x double>, ptr %sunkaddr4756.i.i, align 8, !noalias !71
  %sunkaddr4759.i.i = getelementptr inbounds nuw i8, ptr %sunkaddr4743.i.i, i64 5120
  %.1269.i16.i = load <8 x double>, ptr %sunkaddr4759.i.i, align 8, !noalias !71
  %.1368.i.i = getelementptr inbounds double, ptr %.430, i64 %.269.sroa.0.04226.i.i
  %.1370.i.i = load <8 x double>, ptr %.1368.i.i, align 8, !noalias !71
  %sunkaddr4762.i.i = getelementptr inbounds nuw i8, ptr %sunkaddr4737.i.i, i64 1024
  %.1466.i.i = load <8 x double>, ptr %sunkaddr4762.i.i, align 8, !noalias !71
  %261 = fneg contract <8 x double> %.1466.i.i
  %.8.i4287.i.i = fmul contract <8 x double> %.507.i.i, %261
  %.1519.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.411.i.i, <8 x double> %.1370.i.i, <8 x double> %.8.i4287.i.i)
  %.6.i4288.i.i = fmul contract <8 x double> %.507.i.i, %.1370.i.i
  %.1544.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.411.i.i, <8 x double> %.1466.i.i, <8 x double> %.6.i4288.i.i)
  %sunkaddr4765.i.i = getelementptr inbounds nuw i8, ptr %sunkaddr4743.i.i, i64 8192
  %.1657.i.i267 = load <8 x double>, ptr %sunkaddr4765.i.i, align 8, !noalias !71
  %sunkaddr4768.i.i = getelementptr inbounds nuw i8, ptr %sunkaddr4743.i.i, i64 9216
  %.1753.i.i = load <8 x double>, ptr %sunkaddr4768.i.i, align 8, !noalias !71
  %262 = fneg contract <8 x double> %.1753.i.i
  %.8.i4300.i.i = fmul contract <8 x double> %.1544.i.i, %262
  %.1805.i.i268 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1519.i.i, <8 x double> %.1657.i.i267, <8 x double> %.8.i4300.i.i)
  %.6.i4301.i.i = fmul contract <8 x double> %.1544.i.i, %.1657.i.i267
  %.1830.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1519.i.i, <8 x double> %.1753.i.i, <8 x double> %.6.i4301.i.i)
  br label %B2058.if.i.i

B5889.i.i:                                        ; preds = %B2058.if.i.i
  %.6.i.i17.i = fmul contract <8 x double> %.602.i.i262, %.793.i.i263
  %.6.i4261.i.i = fmul contract <8 x double> %.698.i.i, %.889.i.i264
  %.6.i4262.i.i = fsub contract <8 x double> %.6.i.i17.i, %.6.i4261.i.i
  %.6.i4263.i.i = fadd contract <8 x double> %by_time.2.04223.i.i, %.6.i4262.i.i
  %.6.i4264.i.i = fmul contract <8 x double> %.507.i.i, %.602.i.i262
  %.8.i.i18.i = fmul contract <8 x double> %.1030.i.i, splat (double 0x401921FB54442D18)
  %.1019.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.411.i.i, <8 x double> %.698.i.i, <8 x double> %.6.i4264.i.i)
  %.6.i4265.i.i = fmul contract <8 x double> %.1019.i.i, %.8.i.i18.i
  %.2648.i.i = getelementptr inbounds double, ptr %.1126.i, i64 %.269.sroa.0.04226.i.i
  %.2650.i.i = load <8 x double>, ptr %.2648.i.i, align 8, !noalias !71
  %sunkaddr3.i.i = getelementptr i8, ptr %sunkaddr4743.i.i, i64 1024
  %.2746.i.i = load <8 x double>, ptr %sunkaddr3.i.i, align 8, !noalias !71
  %263 = fneg contract <8 x double> %.2746.i.i
  %.8.i4333.i.i = fmul contract <8 x double> %.1830.i.i, %263
  %.2800.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1805.i.i268, <8 x double> %.2650.i.i, <8 x double> %.8.i4333.i.i)
  %.6.i4334.i.i = fmul contract <8 x double> %.1830.i.i, %.2650.i.i
  %.2825.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1805.i.i268, <8 x double> %.2746.i.i, <8 x double> %.6.i4334.i.i)
  %sunkaddr6.i.i = getelementptr i8, ptr %sunkaddr4743.i.i, i64 2048
  %.2938.i.i = load <8 x double>, ptr %sunkaddr6.i.i, align 8, !noalias !71
  %sunkaddr9.i19.i = getelementptr i8, ptr %sunkaddr4743.i.i, i64 3072
  %.3039.i.i = load <8 x double>, ptr %sunkaddr9.i19.i, align 8, !noalias !71
  %264 = fneg contract <8 x double> %.3039.i.i
  %.8.i4346.i.i = fmul contract <8 x double> %.1830.i.i, %264
  %.3099.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1805.i.i268, <8 x double> %.2938.i.i, <8 x double> %.8.i4346.i.i)
  %.6.i4347.i.i = fmul contract <8 x double> %.1830.i.i, %.2938.i.i
  %.3124.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1805.i.i268, <8 x double> %.3039.i.i, <8 x double> %.6.i4347.i.i)
  %sunkaddr12.i20.i = getelementptr i8, ptr %sunkaddr4743.i.i, i64 14336
  %.3282.i.i = load <8 x double>, ptr %sunkaddr12.i20.i, align 8, !noalias !71
  %.6.i4353.i.i = fmul contract <8 x double> %.2800.i.i, %.3282.i.i
  %sunkaddr15.i21.i = getelementptr i8, ptr %sunkaddr4743.i.i, i64 15360
  %.3400.i.i = load <8 x double>, ptr %sunkaddr15.i21.i, align 8, !noalias !71
  %.6.i4359.i.i = fmul contract <8 x double> %.2825.i.i, %.3400.i.i
  %.6.i4360.i.i = fsub contract <8 x double> %.6.i4353.i.i, %.6.i4359.i.i
  %sunkaddr18.i22.i = getelementptr i8, ptr %sunkaddr4743.i.i, i64 16384
  %.3542.i.i = load <8 x double>, ptr %sunkaddr18.i22.i, align 8, !noalias !71
  %.6.i4366.i.i = fmul contract <8 x double> %.3099.i.i, %.3542.i.i
  %sunkaddr21.i23.i = getelementptr i8, ptr %sunkaddr4743.i.i, i64 17408
  %.3663.i.i = load <8 x double>, ptr %sunkaddr21.i23.i, align 8, !noalias !71
  %.6.i4372.i.i = fmul contract <8 x double> %.3124.i.i, %.3663.i.i
  %.6.i4373.i.i = fsub contract <8 x double> %.6.i4366.i.i, %.6.i4372.i.i
  %.6.i4374.i.i = fadd contract <8 x double> %.6.i4360.i.i, %.6.i4373.i.i
  %.6.i4375.i.i = fsub contract <8 x double> splat (double 1.000000e+00), %.1173.i.i266
  %.8.i4377.i.i = fmul contract <8 x double> %.7.i.i14.i, %.1269.i16.i
  %.8.i4380.i.i = fmul contract <8 x double> %.7.i4379.i.i, %.6.i4375.i.i
  %.6.i4381.i.i = fsub contract <8 x double> %.8.i4377.i.i, %.8.i4380.i.i
  %.3842.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i4265.i.i, <8 x double> %.6.i4381.i.i, <8 x double> %.6.i4374.i.i)
  %.6.i4382.i.i = fadd contract <8 x double> %by_hour.2.04220.i.i, %.3842.i.i
  %sunkaddr24.i24.i = getelementptr i8, ptr %sunkaddr4743.i.i, i64 26624
  %.3961.i.i = load <8 x double>, ptr %sunkaddr24.i24.i, align 8, !noalias !71
  %.8.i4398.i.i = fmul contract <8 x double> %.7.i4379.i.i, %.1173.i.i266
  %.6.i4399.i.i = fadd contract <8 x double> %.8.i4398.i.i, %.8.i4377.i.i
  %.4126.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i4265.i.i, <8 x double> %.6.i4399.i.i, <8 x double> %.6.i4374.i.i)
  %.6.i4400.i.i = fadd contract <8 x double> %.3961.i.i, %.4126.i.i
  store <8 x double> %.6.i4400.i.i, ptr %sunkaddr24.i24.i, align 8, !noalias !71
  %sunkaddr27.i.i = getelementptr i8, ptr %sunkaddr4743.i.i, i64 18432
  %.4261.i.i = load <8 x double>, ptr %sunkaddr27.i.i, align 8, !noalias !71
  %.6.i4406.i.i = fmul contract <8 x double> %.2800.i.i, %.4261.i.i
  %sunkaddr30.i.i = getelementptr i8, ptr %sunkaddr4743.i.i, i64 19456
  %.4379.i.i = load <8 x double>, ptr %sunkaddr30.i.i, align 8, !noalias !71
  %.6.i4412.i.i = fmul contract <8 x double> %.2825.i.i, %.4379.i.i
  %.6.i4413.i.i = fsub contract <8 x double> %.6.i4406.i.i, %.6.i4412.i.i
  %sunkaddr33.i.i = getelementptr i8, ptr %sunkaddr4743.i.i, i64 20480
  %.4521.i.i = load <8 x double>, ptr %sunkaddr33.i.i, align 8, !noalias !71
  %.6.i4419.i.i = fmul contract <8 x double> %.3099.i.i, %.4521.i.i
  %sunkaddr36.i.i = getelementptr i8, ptr %sunkaddr4743.i.i, i64 21504
  %.4642.i.i = load <8 x double>, ptr %sunkaddr36.i.i, align 8, !noalias !71
  %.6.i4425.i.i = fmul contract <8 x double> %.3124.i.i, %.4642.i.i
  %.6.i4426.i.i = fsub contract <8 x double> %.6.i4419.i.i, %.6.i4425.i.i
  %.6.i4427.i.i = fadd contract <8 x double> %.6.i4413.i.i, %.6.i4426.i.i
  %.4747.i.i = load double, ptr %sunkaddr37.i.i, align 8, !noalias !71
  %.6.i4428.i.i = insertelement <8 x double> poison, double %.4747.i.i, i64 0
  %.7.i4429.i.i = shufflevector <8 x double> %.6.i4428.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.8.i4430.i.i = fmul contract <8 x double> %.6.i4375.i.i, %.7.i4429.i.i
  %.4801.i.i = load double, ptr %sunkaddr38.i.i, align 8, !noalias !71
  %.6.i4431.i.i = insertelement <8 x double> poison, double %.4801.i.i, i64 0
  %.7.i4432.i.i = shufflevector <8 x double> %.6.i4431.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.8.i4433.i.i = fmul contract <8 x double> %.1269.i16.i, %.7.i4432.i.i
  %.6.i4434.i.i = fadd contract <8 x double> %.8.i4430.i.i, %.8.i4433.i.i
  %.4854.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i4265.i.i, <8 x double> %.6.i4434.i.i, <8 x double> %.6.i4427.i.i)
  %.6.i4435.i.i = fadd contract <8 x double> %by_declination.2.04221.i.i, %.4854.i.i
  %sunkaddr41.i.i = getelementptr i8, ptr %sunkaddr4743.i.i, i64 12288
  %.4982.i.i = load <8 x double>, ptr %sunkaddr41.i.i, align 8, !noalias !71
  %.6.i4441.i.i = fmul contract <8 x double> %.2800.i.i, %.4982.i.i
  %sunkaddr44.i.i = getelementptr i8, ptr %sunkaddr4743.i.i, i64 13312
  %.5100.i.i = load <8 x double>, ptr %sunkaddr44.i.i, align 8, !noalias !71
  %.6.i4447.i.i = fmul contract <8 x double> %.2825.i.i, %.5100.i.i
  %.6.i4448.i.i = fsub contract <8 x double> %.6.i4441.i.i, %.6.i4447.i.i
  %sunkaddr47.i25.i = getelementptr i8, ptr %sunkaddr4743.i.i, i64 10240
  %.5241.i.i = load <8 x double>, ptr %sunkaddr47.i25.i, align 8, !noalias !71
  %.6.i4454.i.i = fmul contract <8 x double> %.3099.i.i, %.5241.i.i
  %sunkaddr50.i26.i = getelementptr i8, ptr %sunkaddr4743.i.i, i64 11264
  %.5362.i.i = load <8 x double>, ptr %sunkaddr50.i26.i, align 8, !noalias !71
  %.6.i4460.i.i = fmul contract <8 x double> %.3124.i.i, %.5362.i.i
  %.6.i4461.i.i = fsub contract <8 x double> %.6.i4454.i.i, %.6.i4460.i.i
  %.6.i4462.i.i = fsub contract <8 x double> %.6.i4448.i.i, %.6.i4461.i.i
  %.8.i4463.i.i = fmul contract <8 x double> %.6.i4462.i.i, splat (double 2.000000e+00)
  %.6.i4464.i.i = fadd contract <8 x double> %by_polarization.2.04222.i.i, %.8.i4463.i.i
  %.279.i.i = icmp samesign ugt i64 %.224.14225.in.i.i, 1
  %.292.i.i = add i64 %.221.14224.i.i, 8
  %.221.1.i.i = select i1 %.279.i.i, i64 %.292.i.i, i64 %.221.14224.i.i
  %265 = tail call i64 @llvm.smax.i64(i64 %.224.14225.in.i.i, i64 2)
  %266 = add nsw i64 %265, -1
  %.269.sroa.0.0.i.i = select i1 %.279.i.i, i64 %.221.14224.i.i, i64 0
  br i1 %.279.i.i, label %B250.i.i, label %_ZN17bnserve_inference14adjoint_kernel5_back9pull_backB4v367B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i

B2058.if.i.i:                                     ; preds = %B2058.if.i.i, %B250.i.i
  %exitcond.not.i.i269 = phi i1 [ true, %B2058.if.i.i ], [ false, %B250.i.i ]
  %.195769656975.i.i = phi i64 [ 2048, %B2058.if.i.i ], [ 0, %B250.i.i ]
  %267 = getelementptr i8, ptr %.1126.i, i64 %.195769656975.i.i
  %.2011.i.i = getelementptr i8, ptr %267, i64 10240
  %.2081.i.i = getelementptr inbounds double, ptr %.2011.i.i, i64 %.269.sroa.0.04226.i.i
  %.2083.i.i = load <8 x double>, ptr %.2081.i.i, align 8, !noalias !71
  %.2107.i.i = getelementptr i8, ptr %267, i64 11264
  %.2177.i.i = getelementptr inbounds double, ptr %.2107.i.i, i64 %.269.sroa.0.04226.i.i
  %.2179.i.i = load <8 x double>, ptr %.2177.i.i, align 8, !noalias !71
  %268 = fneg contract <8 x double> %.2179.i.i
  %.8.i4313.i.i = fmul contract <8 x double> %.1830.i.i, %268
  %.2233.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1805.i.i268, <8 x double> %.2083.i.i, <8 x double> %.8.i4313.i.i)
  %.6.i4314.i.i = fmul contract <8 x double> %.1830.i.i, %.2083.i.i
  %.2258.i.i270 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1805.i.i268, <8 x double> %.2179.i.i, <8 x double> %.6.i4314.i.i)
  %.2300.i.i271 = getelementptr i8, ptr %267, i64 22528
  %.2385.i.i = getelementptr i8, ptr %267, i64 23552
  %.2461.i.i = getelementptr inbounds double, ptr %.2300.i.i271, i64 %.269.sroa.0.04226.i.i
  %.2463.i.i = load <8 x double>, ptr %.2461.i.i, align 8, !noalias !71
  %.6.i4325.i.i = fadd contract <8 x double> %.2463.i.i, %.2233.i.i
  store <8 x double> %.6.i4325.i.i, ptr %.2461.i.i, align 8, !noalias !71
  %.2508.i.i = getelementptr inbounds double, ptr %.2385.i.i, i64 %.269.sroa.0.04226.i.i
  %.2510.i.i272 = load <8 x double>, ptr %.2508.i.i, align 8, !noalias !71
  %.6.i4326.i.i = fadd contract <8 x double> %.2258.i.i270, %.2510.i.i272
  store <8 x double> %.6.i4326.i.i, ptr %.2508.i.i, align 8, !noalias !71
  br i1 %exitcond.not.i.i269, label %B5889.i.i, label %B2058.if.i.i

_ZN17bnserve_inference14adjoint_kernel5_back9pull_backB4v367B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i: ; preds = %B5889.i.i, %B1008.i
  %by_hour.2.0.lcssa.i.i = phi <8 x double> [ zeroinitializer, %B1008.i ], [ %.6.i4382.i.i, %B5889.i.i ]
  %by_declination.2.0.lcssa.i.i = phi <8 x double> [ zeroinitializer, %B1008.i ], [ %.6.i4435.i.i, %B5889.i.i ]
  %by_polarization.2.0.lcssa.i.i = phi <8 x double> [ zeroinitializer, %B1008.i ], [ %.6.i4464.i.i, %B5889.i.i ]
  %by_time.2.0.lcssa.i.i = phi <8 x double> [ zeroinitializer, %B1008.i ], [ %.6.i4263.i.i, %B5889.i.i ]
  %.5542.i.i = load double, ptr %.5541.i.i, align 8, !noalias !71
  store <8 x double> %by_hour.2.0.lcssa.i.i, ptr %.586, align 8, !noalias !71
  %.5588.i.i = load double, ptr %.586, align 8, !noalias !71
  %.5617.i.i = load double, ptr %.5616.i.i, align 8, !noalias !71
  %.5618.i.i = fadd contract double %.5588.i.i, %.5617.i.i
  %.5647.i.i = load double, ptr %.5646.i.i, align 8, !noalias !71
  %.5676.i.i = load double, ptr %.5675.i.i, align 8, !noalias !71
  %.5677.i.i = fadd contract double %.5647.i.i, %.5676.i.i
  %.5678.i.i = fadd contract double %.5618.i.i, %.5677.i.i
  %.5707.i.i = load double, ptr %.5706.i.i, align 8, !noalias !71
  %.5736.i.i = load double, ptr %.5735.i.i, align 8, !noalias !71
  %.5737.i.i = fadd contract double %.5707.i.i, %.5736.i.i
  %.5766.i.i = load double, ptr %.5765.i.i, align 8, !noalias !71
  %.5795.i.i = load double, ptr %.5794.i.i, align 8, !noalias !71
  %.5799.i.i = fadd contract double %.5766.i.i, %.5795.i.i
  %.5800.i.i = fadd contract double %.5737.i.i, %.5799.i.i
  %.5801.i.i = fadd contract double %.5678.i.i, %.5800.i.i
  %.5802.i.i = fadd contract double %.5542.i.i, %.5801.i.i
  store double %.5802.i.i, ptr %.5541.i.i, align 8, !noalias !71
  %.5862.i.i = load double, ptr %.5861.i.i, align 8, !noalias !71
  store <8 x double> %by_declination.2.0.lcssa.i.i, ptr %.586, align 8, !noalias !71
  %.5908.i.i = load double, ptr %.586, align 8, !noalias !71
  %.5937.i.i = load double, ptr %.5616.i.i, align 8, !noalias !71
  %.5938.i.i = fadd contract double %.5908.i.i, %.5937.i.i
  %.5967.i.i = load double, ptr %.5646.i.i, align 8, !noalias !71
  %.5996.i.i = load double, ptr %.5675.i.i, align 8, !noalias !71
  %.5997.i.i = fadd contract double %.5967.i.i, %.5996.i.i
  %.5998.i.i = fadd contract double %.5938.i.i, %.5997.i.i
  %.6027.i.i = load double, ptr %.5706.i.i, align 8, !noalias !71
  %.6056.i.i = load double, ptr %.5735.i.i, align 8, !noalias !71
  %.6057.i.i = fadd contract double %.6027.i.i, %.6056.i.i
  %.6086.i.i = load double, ptr %.5765.i.i, align 8, !noalias !71
  %.6115.i.i = load double, ptr %.5794.i.i, align 8, !noalias !71
  %.6119.i.i = fadd contract double %.6086.i.i, %.6115.i.i
  %.6120.i.i = fadd contract double %.6057.i.i, %.6119.i.i
  %.6121.i.i = fadd contract double %.5998.i.i, %.6120.i.i
  %.6122.i.i = fadd contract double %.5862.i.i, %.6121.i.i
  store double %.6122.i.i, ptr %.5861.i.i, align 8, !noalias !71
  %.6182.i.i = load double, ptr %.6181.i.i, align 8, !noalias !71
  store <8 x double> %by_polarization.2.0.lcssa.i.i, ptr %.586, align 8, !noalias !71
  %.6228.i.i = load double, ptr %.586, align 8, !noalias !71
  %.6257.i.i = load double, ptr %.5616.i.i, align 8, !noalias !71
  %.6258.i.i = fadd contract double %.6228.i.i, %.6257.i.i
  %.6287.i.i = load double, ptr %.5646.i.i, align 8, !noalias !71
  %.6316.i.i = load double, ptr %.5675.i.i, align 8, !noalias !71
  %.6317.i.i = fadd contract double %.6287.i.i, %.6316.i.i
  %.6318.i.i = fadd contract double %.6258.i.i, %.6317.i.i
  %.6347.i.i = load double, ptr %.5706.i.i, align 8, !noalias !71
  %.6376.i.i = load double, ptr %.5735.i.i, align 8, !noalias !71
  %.6377.i.i = fadd contract double %.6347.i.i, %.6376.i.i
  %.6406.i.i = load double, ptr %.5765.i.i, align 8, !noalias !71
  %.6435.i.i = load double, ptr %.5794.i.i, align 8, !noalias !71
  %.6439.i.i = fadd contract double %.6406.i.i, %.6435.i.i
  %.6440.i.i = fadd contract double %.6377.i.i, %.6439.i.i
  %.6441.i.i = fadd contract double %.6318.i.i, %.6440.i.i
  %.6442.i.i = fadd contract double %.6182.i.i, %.6441.i.i
  store double %.6442.i.i, ptr %.6181.i.i, align 8, !noalias !71
  %.6502.i.i = load double, ptr %.6501.i.i, align 8, !noalias !71
  store <8 x double> %by_time.2.0.lcssa.i.i, ptr %.586, align 8, !noalias !71
  %.6553.i.i = load double, ptr %.586, align 8, !noalias !71
  %.6582.i.i = load double, ptr %.5616.i.i, align 8, !noalias !71
  %.6583.i.i = fadd contract double %.6553.i.i, %.6582.i.i
  %.6612.i.i = load double, ptr %.5646.i.i, align 8, !noalias !71
  %.6641.i.i = load double, ptr %.5675.i.i, align 8, !noalias !71
  %.6642.i.i = fadd contract double %.6612.i.i, %.6641.i.i
  %.6643.i.i = fadd contract double %.6583.i.i, %.6642.i.i
  %.6672.i.i = load double, ptr %.5706.i.i, align 8, !noalias !71
  %.6701.i.i = load double, ptr %.5735.i.i, align 8, !noalias !71
  %.6702.i.i = fadd contract double %.6672.i.i, %.6701.i.i
  %.6731.i.i = load double, ptr %.5765.i.i, align 8, !noalias !71
  %.6760.i.i = load double, ptr %.5794.i.i, align 8, !noalias !71
  %.6764.i.i = fadd contract double %.6731.i.i, %.6760.i.i
  %.6765.i.i = fadd contract double %.6702.i.i, %.6764.i.i
  %.6766.i.i = fadd contract double %.6643.i.i, %.6765.i.i
  %.6767.i.i = fadd contract double %.6502.i.i, %.6766.i.i
  store double %.6767.i.i, ptr %.6501.i.i, align 8, !noalias !71
  %lsr.iv.next.i273 = add i64 %lsr.iv.i222, 27648
  %exitcond857.not.i = icmp eq i64 %.1079.i, %.104.i
  br i1 %exitcond857.not.i, label %B1100.i, label %B802.if.i

B1100.i:                                          ; preds = %_ZN17bnserve_inference14adjoint_kernel5_back9pull_backB4v367B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i, %_ZN17bnserve_inference14adjoint_kernel7_source10_calibrateB4v123B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i
  %.1494.i161 = icmp sgt i64 %.134.i, 0
  br i1 %.1494.i161, label %B1112.i, label %_ZN17bnserve_inference14adjoint_kernel7_source12_in_detectorB4v112B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxx5ArrayIxLi1E1C7mutable7alignedEd5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit

B1112.i:                                          ; preds = %B1100.i
  call void @llvm.lifetime.start.p0(ptr nonnull %.880.i.i140), !noalias !45
  store double 0.000000e+00, ptr %.880.i.i140, align 8, !noalias !74
  %.69.i.i = load i64, ptr %.133.i141, align 8, !noalias !74
  %.241.i.i162 = shl nsw i64 %.69.i.i, 3
  %.271.i.i163 = load i64, ptr %arg.arguments.4, align 8, !noalias !74
  %.272.i.i164 = mul nsw i64 %.271.i.i163, %.7709701030
  %.273.i.i165 = add nsw i64 %.272.i.i164, %.1282920924
  %.274.i.i166 = mul nsw i64 %.273.i.i165, %.241.i.i162
  %.308.i.i = load i64, ptr %.307.i.i, align 8, !noalias !74
  %.312.i.i167 = inttoptr i64 %.308.i.i to ptr
  %invariant.gep.i.i = getelementptr double, ptr %.312.i.i167, i64 %.1090933952
  %.741503.not.i.i = icmp slt i64 %.69.i.i, 1
  br i1 %.741503.not.i.i, label %_ZN17bnserve_inference14adjoint_kernel5_back15errors_to_nodesB4v449B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i, label %B482.if.preheader.i.i

B482.if.preheader.i.i:                            ; preds = %B1112.i
  %.514.i.i = load i64, ptr %59, align 8, !noalias !74
  %.516.i.i = add nsw i64 %.514.i.i, %.274.i.i166
  %.100.i.i = load i64, ptr %.140, align 8, !noalias !74
  %.101.i.i = sub i64 0, %.100.i.i
  %269 = lshr i64 %.101.i.i, 3
  %270 = mul i64 %269, -64
  %271 = inttoptr i64 %.516.i.i to ptr
  br label %B482.if.i.i

B594.i.i:                                         ; preds = %B482.if.i.i
  %.514.1.i.i = load i64, ptr %60, align 8, !noalias !74
  %.516.1.i.i = add nsw i64 %.514.1.i.i, %.274.i.i166
  %272 = inttoptr i64 %.516.1.i.i to ptr
  br label %B482.if.1.i.i

B482.if.1.i.i:                                    ; preds = %B482.if.1.i.i, %B594.i.i
  %lsr.iv.i.i170 = phi ptr [ %invariant.gep.i.i, %B594.i.i ], [ %scevgep.i28.i, %B482.if.1.i.i ]
  %.747501504.1.i.i = phi i64 [ 0, %B594.i.i ], [ %.754.1.i.i, %B482.if.1.i.i ]
  %273 = shl i64 %.747501504.1.i.i, 3
  %scevgep88.i.i = getelementptr i8, ptr %272, i64 %273
  %.808.1.i.i = load double, ptr %scevgep88.i.i, align 8, !noalias !74
  store double 0.000000e+00, ptr %.880.i.i140, align 8, !noalias !74
  call fastcc void @inner_1(ptr nonnull %.880.i.i140, ptr %.592.1.i.i, i64 128, ptr %lsr.iv.i.i170, i64 range(i64 -9223372036854775808, 129) %.13.i, i64 range(i64 -9223372036854775808, 129) %.13.i, ptr nonnull %.586)
  %.754.1.i.i = add nuw nsw i64 %.747501504.1.i.i, 1
  %.900.1.i.i = load double, ptr %.880.i.i140, align 8, !noalias !74
  %.913.1.i.i = fadd contract double %.808.1.i.i, %.900.1.i.i
  store double %.913.1.i.i, ptr %scevgep88.i.i, align 8, !noalias !74
  %scevgep.i28.i = getelementptr i8, ptr %lsr.iv.i.i170, i64 %270
  %exitcond.not.1.i.i = icmp eq i64 %.69.i.i, %.754.1.i.i
  br i1 %exitcond.not.1.i.i, label %_ZN17bnserve_inference14adjoint_kernel5_back15errors_to_nodesB4v449B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i, label %B482.if.1.i.i

B482.if.i.i:                                      ; preds = %B482.if.i.i, %B482.if.preheader.i.i
  %lsr.iv89.i.i = phi ptr [ %invariant.gep.i.i, %B482.if.preheader.i.i ], [ %scevgep90.i.i, %B482.if.i.i ]
  %.747501504.i.i = phi i64 [ 0, %B482.if.preheader.i.i ], [ %.754.i.i, %B482.if.i.i ]
  %274 = shl i64 %.747501504.i.i, 3
  %scevgep91.i.i = getelementptr i8, ptr %271, i64 %274
  %.808.i.i168 = load double, ptr %scevgep91.i.i, align 8, !noalias !74
  store double 0.000000e+00, ptr %.880.i.i140, align 8, !noalias !74
  call fastcc void @inner_1(ptr nonnull %.880.i.i140, ptr %.592.i.i, i64 128, ptr %lsr.iv89.i.i, i64 range(i64 -9223372036854775808, 129) %.13.i, i64 range(i64 -9223372036854775808, 129) %.13.i, ptr nonnull %.586)
  %.754.i.i = add nuw nsw i64 %.747501504.i.i, 1
  %.900.i.i = load double, ptr %.880.i.i140, align 8, !noalias !74
  %.913.i.i169 = fadd contract double %.808.i.i168, %.900.i.i
  store double %.913.i.i169, ptr %scevgep91.i.i, align 8, !noalias !74
  %scevgep90.i.i = getelementptr i8, ptr %lsr.iv89.i.i, i64 %270
  %exitcond.not.i27.i = icmp eq i64 %.69.i.i, %.754.i.i
  br i1 %exitcond.not.i27.i, label %B594.i.i, label %B482.if.i.i

_ZN17bnserve_inference14adjoint_kernel5_back15errors_to_nodesB4v449B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i: ; preds = %B482.if.1.i.i, %B1112.i
  call void @llvm.lifetime.end.p0(ptr nonnull %.880.i.i140), !noalias !45
  br label %_ZN17bnserve_inference14adjoint_kernel7_source12_in_detectorB4v112B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxx5ArrayIxLi1E1C7mutable7alignedEd5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit

B358.if.lr.ph.i:                                  ; preds = %_ZN17bnserve_inference14adjoint_kernel7_source10_calibrateB4v123B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i
  %sunkaddr79.i = getelementptr i8, ptr %lsr.iv270, i64 160
  %sunkaddr8.i.i = getelementptr i8, ptr %lsr.iv270, i64 24
  %sunkaddr9.i.i = getelementptr i8, ptr %lsr.iv270, i64 16
  %sunkaddr10.i.i = getelementptr i8, ptr %lsr.iv270, i64 8
  %sunkaddr11.i.i = getelementptr i8, ptr %lsr.iv270, i64 40
  %sunkaddr12.i.i172 = getelementptr i8, ptr %lsr.iv270, i64 32
  %sunkaddr13.i.i173 = getelementptr i8, ptr %lsr.iv270, i64 64
  %sunkaddr14.i.i174 = getelementptr i8, ptr %lsr.iv270, i64 56
  %sunkaddr15.i.i = getelementptr i8, ptr %lsr.iv270, i64 48
  %sunkaddr16.i.i = getelementptr i8, ptr %lsr.iv270, i64 80
  %sunkaddr17.i.i = getelementptr i8, ptr %lsr.iv270, i64 72
  %sunkaddr18.i.i175 = getelementptr i8, ptr %lsr.iv, i64 16
  %sunkaddr19.i.i = getelementptr i8, ptr %lsr.iv, i64 8
  %sunkaddr.i5.i = getelementptr i8, ptr %lsr.iv, i64 32
  %sunkaddr20.i.i = getelementptr i8, ptr %lsr.iv, i64 24
  %sunkaddr21.i.i176 = getelementptr i8, ptr %lsr.iv, i64 56
  %sunkaddr22.i.i = getelementptr i8, ptr %lsr.iv, i64 48
  %sunkaddr23.i.i = getelementptr i8, ptr %lsr.iv, i64 40
  %sunkaddr24.i.i177 = getelementptr i8, ptr %lsr.iv, i64 72
  %sunkaddr25.i.i = getelementptr i8, ptr %lsr.iv, i64 64
  %sunkaddr47.i = getelementptr i8, ptr %lsr.iv270, i64 96
  %sunkaddr.i178 = getelementptr i8, ptr %lsr.iv270, i64 88
  br label %B358.if.i

B358.if.i:                                        ; preds = %B632.endif.i, %B358.if.lr.ph.i
  %.558802809.i = phi i64 [ 0, %B358.if.lr.ph.i ], [ %.565.i, %B632.endif.i ]
  %.565.i = add nuw nsw i64 %.558802809.i, 1
  %.idx773.i = mul i64 %.558802809.i, 27648
  %275 = getelementptr i8, ptr %.430, i64 %.idx773.i
  %.612.i179 = getelementptr i8, ptr %275, i64 14336
  %.711.i180 = load double, ptr %sunkaddr79.i, align 8, !noalias !45
  %.712.i181 = fcmp contract ogt double %.711.i180, 0.000000e+00
  br i1 %.712.i181, label %B444.i, label %B596.i

B632.endif.i:                                     ; preds = %B1190.i.i, %B596.i, %B632.i
  %exitcond.not.i213 = icmp eq i64 %.565.i, %.104.i
  br i1 %exitcond.not.i213, label %B802.if.lr.ph.i, label %B358.if.i

B802.if.i:                                        ; preds = %_ZN17bnserve_inference14adjoint_kernel5_back9pull_backB4v367B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i, %B802.if.lr.ph.i
  %lsr.iv.i222 = phi i64 [ 21504, %B802.if.lr.ph.i ], [ %lsr.iv.next.i273, %_ZN17bnserve_inference14adjoint_kernel5_back9pull_backB4v367B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i ]
  %.1072818825.i = phi i64 [ 0, %B802.if.lr.ph.i ], [ %.1079.i, %_ZN17bnserve_inference14adjoint_kernel5_back9pull_backB4v367B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i ]
  %.1079.i = add nuw nsw i64 %.1072818825.i, 1
  %.idx.i223 = mul i64 %.1072818825.i, 27648
  %276 = getelementptr i8, ptr %.430, i64 %.idx.i223
  %.1126.i = getelementptr i8, ptr %276, i64 14336
  %.1225.i = load double, ptr %lsr.iv270, align 8, !noalias !45
  %.1227.i = fadd contract double %.916, %.1225.i
  %.79.i.i = load i64, ptr %.76, align 8, !noalias !77
  %.109.i.i = load i64, ptr %.140, align 8, !noalias !77
  %.139.i.i = load i64, ptr %.138.i.i215, align 8, !noalias !77
  %.224.i.i = load i64, ptr %.171.i, align 8, !noalias !77
  %.455751.i.i = load double, ptr %.454.i.i216, align 8, !noalias !77
  %.558.i.i224 = load i64, ptr %.557.i.i, align 8, !noalias !77
  %.501.i.i = load i64, ptr %.500.i.i217, align 8, !noalias !77
  %.377.i.i225 = load i64, ptr %.376.i.i218, align 8, !noalias !77
  %.147.i.i = sub i64 0, %.109.i.i
  %.155.1.i.i = and i64 %.147.i.i, -8
  %.189.i.i = sub i64 0, %.155.1.i.i
  %.226.i.i = inttoptr i64 %.224.i.i to ptr
  %.290.i29.i = getelementptr inbounds double, ptr %.226.i.i, i64 %.1090933952
  %.566.i.i = shl nsw i64 %.189.i.i, 1
  tail call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(4096) %.760.i.i, i8 0, i64 4096, i1 false), !noalias !77
  %.1159.i.i226 = load i64, ptr %.1158.i.i219, align 8, !noalias !77
  %.1239800.not.i.i = icmp slt i64 %.1159.i.i226, 1
  br i1 %.1239800.not.i.i, label %_ZN17bnserve_inference14adjoint_kernel7_source16_through_weightsB4v266B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxxx5ArrayIxLi1E1C7mutable7alignedEd5ArrayIdLi1E1C7mutable7alignedE.exit.i, label %B714.if.lr.ph.i.i

B714.if.lr.ph.i.i:                                ; preds = %B802.if.i
  %.560.i.i = shl nsw i64 %.189.i.i, 4
  %.562.i.i227 = mul nsw i64 %.560.i.i, %.139.i.i
  %.502.i.i228 = icmp eq i64 %.501.i.i, 1
  %.515.i.i = mul nsw i64 %.79.i.i, %.1282920924
  %.521.i.i = add nsw i64 %.515.i.i, %.1072818825.i
  %"$phi424.0.2.0.i.i" = select i1 %.502.i.i228, i64 %.1282920924, i64 %.521.i.i
  %.563.i.i229 = mul nsw i64 %.562.i.i227, %"$phi424.0.2.0.i.i"
  %.564.i.i = add nsw i64 %.563.i.i229, %.558.i.i224
  %277 = inttoptr i64 %.564.i.i to ptr
  %.1742.i.i = add nsw i64 %.139.i.i, -4
  %.1337.i.i230 = getelementptr inbounds double, ptr %277, i64 %.1090933952
  %.1391.i.i231 = sub i64 %.1090933952, %.155.1.i.i
  %.1403.i30.i = getelementptr inbounds double, ptr %277, i64 %.1391.i.i231
  %invariant.gep.i.i.i = getelementptr double, ptr %277, i64 %.566.i.i
  %invariant.gep1621.idx.i.i.i = mul i64 %.155.1.i.i, -48
  %invariant.gep1621.i.i.i = getelementptr i8, ptr %277, i64 %invariant.gep1621.idx.i.i.i
  %invariant.gep1623.idx.i.i.i = shl i64 %.189.i.i, 5
  %invariant.gep1623.i.i.i = getelementptr i8, ptr %277, i64 %invariant.gep1623.idx.i.i.i
  %invariant.gep1625.idx.i.i.i = mul i64 %.155.1.i.i, -80
  %invariant.gep1625.i.i.i = getelementptr i8, ptr %277, i64 %invariant.gep1625.idx.i.i.i
  %invariant.gep1627.idx.i.i.i = shl i64 %.189.i.i, 6
  %invariant.gep1627.i.i.i = getelementptr i8, ptr %277, i64 %invariant.gep1627.idx.i.i.i
  %278 = icmp eq i64 %.139.i.i, 1
  %279 = inttoptr i64 %.377.i.i225 to ptr
  %sunkaddr13.i31.i = getelementptr i8, ptr %279, i64 8
  br label %B714.if.i.i

B788.i.i:                                         ; preds = %_ZN17bnserve_inference14adjoint_kernel7_source10_fill_barsB4v277B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i.i
  br i1 %.93.inv.i.i, label %B1016.i.i, label %B382.lr.ph.i.i.i

B896.i.i:                                         ; preds = %_ZN17bnserve_inference14adjoint_kernel7_source10_fill_barsB4v277B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i.i
  %.48.i.i.i = load double, ptr %279, align 8, !noalias !80
  %.49.i.i.i = fsub contract double %.1316.i.i234, %.48.i.i.i
  %.78.i.i.i = load double, ptr %sunkaddr13.i31.i, align 8, !noalias !80
  %.85.i.i.i = fdiv contract double %.49.i.i.i, %.78.i.i.i
  %.93.le.i.i.i = tail call contract double @llvm.floor.f64(double %.85.i.i.i)
  %.5.i.i.i.i = fptosi double %.93.le.i.i.i to i64
  %.13.i.i.i.i = tail call i64 @llvm.smax.i64(i64 %.5.i.i.i.i, i64 2)
  %.13.i1.i.i.i = tail call i64 @llvm.smin.i64(i64 %.1742.i.i, i64 %.13.i.i.i.i)
  %.181.i.i.i = sitofp i64 %.13.i1.i.i.i to double
  %.182.i.i.i = fsub contract double %.85.i.i.i, %.181.i.i.i
  %.183.i.i.i = fsub contract double 1.000000e+00, %.182.i.i.i
  %.184.i.i.i = fmul contract double %.183.i.i.i, %.183.i.i.i
  %.185.i.i.i = fmul contract double %.183.i.i.i, %.184.i.i.i
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
  %.266.i.i.i = mul nsw i64 %.265.i.i.i, %.566.i.i
  %.267.i.i.i = add nsw i64 %.266.i.i.i, %.1090933952
  %.1806.i.i = fmul contract double %.78.i.i.i, 2.400000e+01
  %.1810.i.i = fdiv contract double 1.000000e+00, %.1806.i.i
  %.1811.i.i = fmul contract double %.182.i.i.i, 2.400000e+01
  %.1815.i.i = fsub contract double 2.400000e+01, %.208.i.i.i
  %.1816.i.i = fmul contract double %.245.i.i.i, %.1815.i.i
  %280 = fsub contract double %.1816.i.i, %.1811.i.i
  %.1818.i.i = fmul contract double %.183.i.i.i, 2.400000e+01
  %.1822.i.i = fsub contract double 2.400000e+01, %.220.i.i.i
  %.1823.i.i = fmul contract double %.185.i.i.i, %.1822.i.i
  %281 = fsub contract double %.1823.i.i, %.1818.i.i
  %.1826.i.i = fadd contract double %.192.i.i.i, -1.600000e+01
  %.1827.i.i = fmul contract double %.182.i.i.i, %.1826.i.i
  %.1828.i.i235 = fadd contract double %.1827.i.i, 1.200000e+01
  %.1829.i.i236 = fmul contract double %.182.i.i.i, %.1828.i.i235
  %.1830.i32.i = fadd contract double %.1829.i.i236, 8.000000e+00
  %.1831.i.i237 = fmul contract double %.182.i.i.i, %.1830.i32.i
  %.1832.i.i = fadd contract double %.1831.i.i237, -1.000000e+01
  %.1834.i.i = fadd contract double %.230.i.i.i, -1.600000e+01
  %.1835.i.i = fmul contract double %.183.i.i.i, %.1834.i.i
  %.1836.i.i = fadd contract double %.1835.i.i, 1.200000e+01
  %.1837.i.i238 = fmul contract double %.183.i.i.i, %.1836.i.i
  %.1838.i.i = fadd contract double %.1837.i.i238, 8.000000e+00
  %.1839.i.i = fmul contract double %.183.i.i.i, %.1838.i.i
  %.1840.i.i = fadd contract double %.1839.i.i, -1.000000e+01
  %.1846.i.i = fmul contract double %.1810.i.i, %.1832.i.i
  %.1847.i.i = fmul contract double %.1810.i.i, %280
  %.1848.i.i = fneg contract double %281
  %.1849.i.i = fmul contract double %.1810.i.i, %.1848.i.i
  %.1850.i.i = fneg contract double %.1840.i.i
  %.1851.i.i = fmul contract double %.1810.i.i, %.1850.i.i
  %.1855.i.i = fmul contract double %.1810.i.i, %.246.i.i.i
  %.1458.i.i.i = sub i64 %.267.i.i.i, %.155.1.i.i
  %.1519.i.i.i = insertelement <8 x double> poison, double %.205.i.i.i, i64 0
  %.1520.i.i.i = shufflevector <8 x double> %.1519.i.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1546.i.i.i = insertelement <8 x double> poison, double %.217.i.i.i, i64 0
  %.1547.i.i.i = shufflevector <8 x double> %.1546.i.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1549.i.i.i = insertelement <8 x double> poison, double %.229.i.i.i, i64 0
  %.1550.i.i.i = shufflevector <8 x double> %.1549.i.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1585.i.i.i = insertelement <8 x double> poison, double %.243.i.i.i, i64 0
  %.1586.i.i.i = shufflevector <8 x double> %.1585.i.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1588.i.i.i = insertelement <8 x double> poison, double %.251.i.i.i, i64 0
  %.1589.i.i.i = shufflevector <8 x double> %.1588.i.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1874.i.i.i = insertelement <8 x double> poison, double %.1846.i.i, i64 0
  %.1875.i.i.i = shufflevector <8 x double> %.1874.i.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1901.i.i.i = insertelement <8 x double> poison, double %.1847.i.i, i64 0
  %.1902.i.i.i = shufflevector <8 x double> %.1901.i.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1904.i.i.i = insertelement <8 x double> poison, double %.1849.i.i, i64 0
  %.1905.i.i.i = shufflevector <8 x double> %.1904.i.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1940.i.i.i = insertelement <8 x double> poison, double %.1851.i.i, i64 0
  %.1941.i.i.i = shufflevector <8 x double> %.1940.i.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.1943.i.i.i = insertelement <8 x double> poison, double %.1855.i.i, i64 0
  %.1944.i.i.i = shufflevector <8 x double> %.1943.i.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  br i1 %.93.inv.i.i, label %B1016.i.i, label %B394.lr.ph.i.i.i

B1016.i.i:                                        ; preds = %B394.i.i.i, %B382.i.i.i, %B896.i.i, %B788.i.i
  %exitcond829.not.i.i = icmp eq i64 %.1252.i.i, %.1159.i.i226
  br i1 %exitcond829.not.i.i, label %_ZN17bnserve_inference14adjoint_kernel7_source16_through_weightsB4v266B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxxx5ArrayIxLi1E1C7mutable7alignedEd5ArrayIdLi1E1C7mutable7alignedE.exit.i, label %B714.if.i.i

B714.if.i.i:                                      ; preds = %B1016.i.i, %B714.if.lr.ph.i.i
  %.1245791801.i.i = phi i64 [ 0, %B714.if.lr.ph.i.i ], [ %.1252.i.i, %B1016.i.i ]
  %.1252.i.i = add nuw nsw i64 %.1245791801.i.i, 1
  %.260.i.i.i = load i64, ptr %.76, align 8, !noalias !83
  %.359.i.i.i = load i64, ptr %.358.i.i.i, align 8, !noalias !83
  %.360.i.i.i = icmp eq i64 %.359.i.i.i, 1
  br i1 %.360.i.i.i, label %B266.i.i.i, label %B544.i.i.i

B266.i.i.i:                                       ; preds = %B714.if.i.i
  %.290.i.i.i = load i64, ptr %.140, align 8, !noalias !83
  %.368.i.i.i = sub i64 %.290.i.i.i, %.1090933952
  %.13.i.i1.i.i = tail call i64 @llvm.smin.i64(i64 %.368.i.i.i, i64 range(i64 -9223372036854775808, 129) %.13.i)
  %.430.i.i.i = load i64, ptr %.1421.i.i.i, align 8, !noalias !83
  %.438.i.i.i = mul nsw i64 %.260.i.i.i, %.7709701030
  %.444.i.i.i = add nsw i64 %.438.i.i.i, %.1072818825.i
  %.448.i.i.i = mul nsw i64 %.290.i.i.i, %.444.i.i.i
  %.452.i.i.i = add nsw i64 %.448.i.i.i, %.1090933952
  %.455.i.i.i = shl nsw i64 %.452.i.i.i, 4
  %.456.i.i.i = add nsw i64 %.455.i.i.i, %.430.i.i.i
  %.1203793.not.i.i.i = icmp slt i64 %.13.i.i1.i.i, 1
  tail call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(2048) %.586, i8 0, i64 2048, i1 false), !noalias !83
  br i1 %.1203793.not.i.i.i, label %_ZN17bnserve_inference14adjoint_kernel7_source10_fill_barsB4v277B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i.i, label %B470.if.preheader.i.i.i

B470.if.preheader.i.i.i:                          ; preds = %B266.i.i.i
  %282 = icmp eq i64 %.13.i.i1.i.i, 1
  br i1 %282, label %B470.if.epil.preheader.i.i.i, label %B470.if.preheader.new.i.i.i

B470.if.preheader.new.i.i.i:                      ; preds = %B470.if.preheader.i.i.i
  %283 = inttoptr i64 %.456.i.i.i to ptr
  %scevgep.i.i.i = getelementptr i8, ptr %283, i64 24
  %284 = add nsw i64 %.13.i.i1.i.i, -2
  %285 = lshr i64 %284, 1
  %286 = icmp eq i64 %285, 0
  br i1 %286, label %B470.if.epil.preheader1.i.i.i, label %B470.if.preheader.new.new.i.i.i

B470.if.preheader.new.new.i.i.i:                  ; preds = %B470.if.preheader.new.i.i.i
  %287 = add nuw nsw i64 %285, 1
  %scevgep12.i.i.i = getelementptr i8, ptr %283, i64 56
  %288 = lshr i64 %287, 1
  %289 = mul nsw i64 %288, -2
  br label %B470.if.i.i.i

B540.loopexit.unr-lcssa.unr-lcssa.i.i.i:          ; preds = %B470.if.i.i.i
  %290 = and i64 %284, 2
  %lcmp.mod.not11.not.i.i.i = icmp eq i64 %290, 0
  %scevgep2.i.i.i = getelementptr i8, ptr %lsr.iv13.i.i.i, i64 32
  br i1 %lcmp.mod.not11.not.i.i.i, label %B470.if.epil.preheader1.i.i.i, label %B540.loopexit.unr-lcssa.i.i.i

B470.if.epil.preheader1.i.i.i:                    ; preds = %B540.loopexit.unr-lcssa.unr-lcssa.i.i.i, %B470.if.preheader.new.i.i.i
  %lsr.iv.epil.init.i.i.i = phi ptr [ %scevgep.i.i.i, %B470.if.preheader.new.i.i.i ], [ %scevgep2.i.i.i, %B540.loopexit.unr-lcssa.unr-lcssa.i.i.i ]
  %.1209792794.epil.init4.i.i.i = phi i64 [ 0, %B470.if.preheader.new.i.i.i ], [ %.1216.1.1.i.i.i, %B540.loopexit.unr-lcssa.unr-lcssa.i.i.i ]
  %scevgep59.epil.i.i.i = getelementptr i8, ptr %lsr.iv.epil.init.i.i.i, i64 -24
  %.1271.epil2.i.i.i = load double, ptr %scevgep59.epil.i.i.i, align 8, !noalias !83
  %scevgep60.epil.i.i.i = getelementptr i8, ptr %lsr.iv.epil.init.i.i.i, i64 -16
  %.1303.epil3.i.i.i = load double, ptr %scevgep60.epil.i.i.i, align 8, !noalias !83
  %sunkaddr102.epil.i.i.i = shl i64 %.1209792794.epil.init4.i.i.i, 3
  %sunkaddr103.epil.i.i.i = getelementptr i8, ptr %.430, i64 %sunkaddr102.epil.i.i.i
  %sunkaddr104.epil.i.i.i = getelementptr i8, ptr %sunkaddr103.epil.i.i.i, i64 12288
  store double %.1271.epil2.i.i.i, ptr %sunkaddr104.epil.i.i.i, align 8, !noalias !83
  %sunkaddr107.epil.i.i.i = getelementptr i8, ptr %sunkaddr103.epil.i.i.i, i64 13312
  store double %.1303.epil3.i.i.i, ptr %sunkaddr107.epil.i.i.i, align 8, !noalias !83
  %.1216.1.epil.i.i.i = add nuw i64 %.1209792794.epil.init4.i.i.i, 2
  %scevgep58.epil.i.i.i = getelementptr i8, ptr %lsr.iv.epil.init.i.i.i, i64 -8
  %.1271.1.epil.i.i.i = load double, ptr %scevgep58.epil.i.i.i, align 8, !noalias !83
  %.1303.1.epil.i.i.i = load double, ptr %lsr.iv.epil.init.i.i.i, align 8, !noalias !83
  %sunkaddr110.epil.i.i.i = getelementptr i8, ptr %sunkaddr103.epil.i.i.i, i64 12296
  store double %.1271.1.epil.i.i.i, ptr %sunkaddr110.epil.i.i.i, align 8, !noalias !83
  %sunkaddr113.epil.i.i.i = getelementptr i8, ptr %sunkaddr103.epil.i.i.i, i64 13320
  store double %.1303.1.epil.i.i.i, ptr %sunkaddr113.epil.i.i.i, align 8, !noalias !83
  br label %B540.loopexit.unr-lcssa.i.i.i

B540.loopexit.unr-lcssa.i.i.i:                    ; preds = %B470.if.epil.preheader1.i.i.i, %B540.loopexit.unr-lcssa.unr-lcssa.i.i.i
  %.1216.1.lcssa.i.i.i = phi i64 [ %.1216.1.epil.i.i.i, %B470.if.epil.preheader1.i.i.i ], [ %.1216.1.1.i.i.i, %B540.loopexit.unr-lcssa.unr-lcssa.i.i.i ]
  %291 = and i64 %.13.i.i1.i.i, 1
  %lcmp.mod.not.i.i.i = icmp eq i64 %291, 0
  br i1 %lcmp.mod.not.i.i.i, label %_ZN17bnserve_inference14adjoint_kernel7_source10_fill_barsB4v277B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i.i, label %B470.if.epil.preheader.i.i.i

B470.if.epil.preheader.i.i.i:                     ; preds = %B540.loopexit.unr-lcssa.i.i.i, %B470.if.preheader.i.i.i
  %.1209792794.epil.init.i.i.i = phi i64 [ 0, %B470.if.preheader.i.i.i ], [ %.1216.1.lcssa.i.i.i, %B540.loopexit.unr-lcssa.i.i.i ]
  %292 = inttoptr i64 %.456.i.i.i to ptr
  %.idx.epil.i.i.i = shl i64 %.1209792794.epil.init.i.i.i, 4
  %293 = getelementptr i8, ptr %292, i64 %.idx.epil.i.i.i
  %.1271.epil.i.i.i = load double, ptr %293, align 8, !noalias !83
  %294 = getelementptr i8, ptr %293, i64 8
  %.1303.epil.i.i.i = load double, ptr %294, align 8, !noalias !83
  %sunkaddr162.i.i.i = shl i64 %.1209792794.epil.init.i.i.i, 3
  %sunkaddr163.i.i.i = getelementptr i8, ptr %.430, i64 %sunkaddr162.i.i.i
  %sunkaddr164.i.i.i = getelementptr i8, ptr %sunkaddr163.i.i.i, i64 12288
  store double %.1271.epil.i.i.i, ptr %sunkaddr164.i.i.i, align 8, !noalias !83
  %sunkaddr101.i.i.i = getelementptr i8, ptr %sunkaddr163.i.i.i, i64 13312
  store double %.1303.epil.i.i.i, ptr %sunkaddr101.i.i.i, align 8, !noalias !83
  br label %_ZN17bnserve_inference14adjoint_kernel7_source10_fill_barsB4v277B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i.i

B544.i.i.i:                                       ; preds = %B714.if.i.i
  %.320.i.i.i = load i64, ptr %.1158.i.i219, align 8, !noalias !83
  %.1422.i.i.i = load i64, ptr %.1421.i.i.i, align 8, !noalias !83
  %.1430.i.i.i = mul nsw i64 %.260.i.i.i, %.7709701030
  %.1436.i.i.i = add nsw i64 %.1430.i.i.i, %.1072818825.i
  %.1440.i.i.i = mul nsw i64 %.320.i.i.i, %.1436.i.i.i
  %.1444.i.i.i = add nsw i64 %.1440.i.i.i, %.1245791801.i.i
  %.1447.i.i.i = shl nsw i64 %.1444.i.i.i, 4
  %.1448.i.i.i = add nsw i64 %.1447.i.i.i, %.1422.i.i.i
  %.1449.i.i.i = inttoptr i64 %.1448.i.i.i to ptr
  %.1525.i.i.i = load double, ptr %.1449.i.i.i, align 8, !noalias !83
  %.1553.i.i.i = getelementptr i8, ptr %.1449.i.i.i, i64 8
  %.1554.i.i.i = load double, ptr %.1553.i.i.i, align 8, !noalias !83
  store double %.1525.i.i.i, ptr %.586, align 8, !noalias !83
  store double %.1525.i.i.i, ptr %.5616.i.i, align 8, !noalias !83
  store double %.1525.i.i.i, ptr %.5646.i.i, align 8, !noalias !83
  store double %.1525.i.i.i, ptr %.5675.i.i, align 8, !noalias !83
  store double %.1525.i.i.i, ptr %.5706.i.i, align 8, !noalias !83
  store double %.1525.i.i.i, ptr %.5735.i.i, align 8, !noalias !83
  store double %.1525.i.i.i, ptr %.5765.i.i, align 8, !noalias !83
  store double %.1525.i.i.i, ptr %.5794.i.i, align 8, !noalias !83
  store double %.1525.i.i.i, ptr %sunkaddr153.i.i.i, align 8, !noalias !83
  store double %.1525.i.i.i, ptr %sunkaddr156.i.i.i, align 8, !noalias !83
  store double %.1525.i.i.i, ptr %sunkaddr159.i.i.i, align 8, !noalias !83
  store double %.1525.i.i.i, ptr %sunkaddr165.i.i.i, align 8, !noalias !83
  store double %.1525.i.i.i, ptr %sunkaddr168.i.i.i, align 8, !noalias !83
  store double %.1525.i.i.i, ptr %sunkaddr171.i.i.i, align 8, !noalias !83
  store double %.1525.i.i.i, ptr %sunkaddr174.i.i.i, align 8, !noalias !83
  store double %.1525.i.i.i, ptr %sunkaddr177.i.i.i, align 8, !noalias !83
  store double %.1525.i.i.i, ptr %sunkaddr129.1.i.i.i, align 8, !noalias !83
  store double %.1525.i.i.i, ptr %sunkaddr132.1.i.i.i, align 8, !noalias !83
  store double %.1525.i.i.i, ptr %sunkaddr135.1.i.i.i, align 8, !noalias !83
  store double %.1525.i.i.i, ptr %sunkaddr138.1.i.i.i, align 8, !noalias !83
  store double %.1525.i.i.i, ptr %sunkaddr141.1.i.i.i, align 8, !noalias !83
  store double %.1525.i.i.i, ptr %sunkaddr144.1.i.i.i, align 8, !noalias !83
  store double %.1525.i.i.i, ptr %sunkaddr147.1.i.i.i, align 8, !noalias !83
  store double %.1525.i.i.i, ptr %sunkaddr150.1.i.i.i, align 8, !noalias !83
  store double %.1525.i.i.i, ptr %sunkaddr153.1.i.i.i, align 8, !noalias !83
  store double %.1525.i.i.i, ptr %sunkaddr156.1.i.i.i, align 8, !noalias !83
  store double %.1525.i.i.i, ptr %sunkaddr159.1.i.i.i, align 8, !noalias !83
  store double %.1525.i.i.i, ptr %sunkaddr165.1.i.i.i, align 8, !noalias !83
  store double %.1525.i.i.i, ptr %sunkaddr168.1.i.i.i, align 8, !noalias !83
  store double %.1525.i.i.i, ptr %sunkaddr171.1.i.i.i, align 8, !noalias !83
  store double %.1525.i.i.i, ptr %sunkaddr174.1.i.i.i, align 8, !noalias !83
  store double %.1525.i.i.i, ptr %sunkaddr177.1.i.i.i, align 8, !noalias !83
  store double %.1525.i.i.i, ptr %sunkaddr129.2.i.i.i, align 8, !noalias !83
  store double %.1525.i.i.i, ptr %sunkaddr132.2.i.i.i, align 8, !noalias !83
  store double %.1525.i.i.i, ptr %sunkaddr135.2.i.i.i, align 8, !noalias !83
  store double %.1525.i.i.i, ptr %sunkaddr138.2.i.i.i, align 8, !noalias !83
  store double %.1525.i.i.i, ptr %sunkaddr141.2.i.i.i, align 8, !noalias !83
  store double %.1525.i.i.i, ptr %sunkaddr144.2.i.i.i, align 8, !noalias !83
  store double %.1525.i.i.i, ptr %sunkaddr147.2.i.i.i, align 8, !noalias !83
  store double %.1525.i.i.i, ptr %sunkaddr150.2.i.i.i, align 8, !noalias !83
  store double %.1525.i.i.i, ptr %sunkaddr153.2.i.i.i, align 8, !noalias !83
  store double %.1525.i.i.i, ptr %sunkaddr156.2.i.i.i, align 8, !noalias !83
  store double %.1525.i.i.i, ptr %sunkaddr159.2.i.i.i, align 8, !noalias !83
  store double %.1525.i.i.i, ptr %sunkaddr165.2.i.i.i, align 8, !noalias !83
  store double %.1525.i.i.i, ptr %sunkaddr168.2.i.i.i, align 8, !noalias !83
  store double %.1525.i.i.i, ptr %sunkaddr171.2.i.i.i, align 8, !noalias !83
  store double %.1525.i.i.i, ptr %sunkaddr174.2.i.i.i, align 8, !noalias !83
  store double %.1525.i.i.i, ptr %sunkaddr177.2.i.i.i, align 8, !noalias !83
  store double %.1525.i.i.i, ptr %sunkaddr129.3.i.i.i, align 8, !noalias !83
  store double %.1525.i.i.i, ptr %sunkaddr132.3.i.i.i, align 8, !noalias !83
  store double %.1525.i.i.i, ptr %sunkaddr135.3.i.i.i, align 8, !noalias !83
  store double %.1525.i.i.i, ptr %sunkaddr138.3.i.i.i, align 8, !noalias !83
  store double %.1525.i.i.i, ptr %sunkaddr141.3.i.i.i, align 8, !noalias !83
  store double %.1525.i.i.i, ptr %sunkaddr144.3.i.i.i, align 8, !noalias !83
  store double %.1525.i.i.i, ptr %sunkaddr147.3.i.i.i, align 8, !noalias !83
  store double %.1525.i.i.i, ptr %sunkaddr150.3.i.i.i, align 8, !noalias !83
  store double %.1525.i.i.i, ptr %sunkaddr153.3.i.i.i, align 8, !noalias !83
  store double %.1525.i.i.i, ptr %sunkaddr156.3.i.i.i, align 8, !noalias !83
  store double %.1525.i.i.i, ptr %sunkaddr159.3.i.i.i, align 8, !noalias !83
  store double %.1525.i.i.i, ptr %sunkaddr165.3.i.i.i, align 8, !noalias !83
  store double %.1525.i.i.i, ptr %sunkaddr168.3.i.i.i, align 8, !noalias !83
  store double %.1525.i.i.i, ptr %sunkaddr171.3.i.i.i, align 8, !noalias !83
  store double %.1525.i.i.i, ptr %sunkaddr174.3.i.i.i, align 8, !noalias !83
  store double %.1525.i.i.i, ptr %sunkaddr177.3.i.i.i, align 8, !noalias !83
  store double %.1525.i.i.i, ptr %sunkaddr129.4.i.i.i, align 8, !noalias !83
  store double %.1525.i.i.i, ptr %sunkaddr132.4.i.i.i, align 8, !noalias !83
  store double %.1525.i.i.i, ptr %sunkaddr135.4.i.i.i, align 8, !noalias !83
  store double %.1525.i.i.i, ptr %sunkaddr138.4.i.i.i, align 8, !noalias !83
  store double %.1525.i.i.i, ptr %sunkaddr141.4.i.i.i, align 8, !noalias !83
  store double %.1525.i.i.i, ptr %sunkaddr144.4.i.i.i, align 8, !noalias !83
  store double %.1525.i.i.i, ptr %sunkaddr147.4.i.i.i, align 8, !noalias !83
  store double %.1525.i.i.i, ptr %sunkaddr150.4.i.i.i, align 8, !noalias !83
  store double %.1525.i.i.i, ptr %sunkaddr153.4.i.i.i, align 8, !noalias !83
  store double %.1525.i.i.i, ptr %sunkaddr156.4.i.i.i, align 8, !noalias !83
  store double %.1525.i.i.i, ptr %sunkaddr159.4.i.i.i, align 8, !noalias !83
  store double %.1525.i.i.i, ptr %sunkaddr165.4.i.i.i, align 8, !noalias !83
  store double %.1525.i.i.i, ptr %sunkaddr168.4.i.i.i, align 8, !noalias !83
  store double %.1525.i.i.i, ptr %sunkaddr171.4.i.i.i, align 8, !noalias !83
  store double %.1525.i.i.i, ptr %sunkaddr174.4.i.i.i, align 8, !noalias !83
  store double %.1525.i.i.i, ptr %sunkaddr177.4.i.i.i, align 8, !noalias !83
  store double %.1525.i.i.i, ptr %sunkaddr129.5.i.i.i, align 8, !noalias !83
  store double %.1525.i.i.i, ptr %sunkaddr132.5.i.i.i, align 8, !noalias !83
  store double %.1525.i.i.i, ptr %sunkaddr135.5.i.i.i, align 8, !noalias !83
  store double %.1525.i.i.i, ptr %sunkaddr138.5.i.i.i, align 8, !noalias !83
  store double %.1525.i.i.i, ptr %sunkaddr141.5.i.i.i, align 8, !noalias !83
  store double %.1525.i.i.i, ptr %sunkaddr144.5.i.i.i, align 8, !noalias !83
  store double %.1525.i.i.i, ptr %sunkaddr147.5.i.i.i, align 8, !noalias !83
  store double %.1525.i.i.i, ptr %sunkaddr150.5.i.i.i, align 8, !noalias !83
  store double %.1525.i.i.i, ptr %sunkaddr153.5.i.i.i, align 8, !noalias !83
  store double %.1525.i.i.i, ptr %sunkaddr156.5.i.i.i, align 8, !noalias !83
  store double %.1525.i.i.i, ptr %sunkaddr159.5.i.i.i, align 8, !noalias !83
  store double %.1525.i.i.i, ptr %sunkaddr165.5.i.i.i, align 8, !noalias !83
  store double %.1525.i.i.i, ptr %sunkaddr168.5.i.i.i, align 8, !noalias !83
  store double %.1525.i.i.i, ptr %sunkaddr171.5.i.i.i, align 8, !noalias !83
  store double %.1525.i.i.i, ptr %sunkaddr174.5.i.i.i, align 8, !noalias !83
  store double %.1525.i.i.i, ptr %sunkaddr177.5.i.i.i, align 8, !noalias !83
  store double %.1525.i.i.i, ptr %sunkaddr129.6.i.i.i, align 8, !noalias !83
  store double %.1525.i.i.i, ptr %sunkaddr132.6.i.i.i, align 8, !noalias !83
  store double %.1525.i.i.i, ptr %sunkaddr135.6.i.i.i, align 8, !noalias !83
  store double %.1525.i.i.i, ptr %sunkaddr138.6.i.i.i, align 8, !noalias !83
  store double %.1525.i.i.i, ptr %sunkaddr141.6.i.i.i, align 8, !noalias !83
  store double %.1525.i.i.i, ptr %sunkaddr144.6.i.i.i, align 8, !noalias !83
  store double %.1525.i.i.i, ptr %sunkaddr147.6.i.i.i, align 8, !noalias !83
  store double %.1525.i.i.i, ptr %sunkaddr150.6.i.i.i, align 8, !noalias !83
  store double %.1525.i.i.i, ptr %sunkaddr153.6.i.i.i, align 8, !noalias !83
  store double %.1525.i.i.i, ptr %sunkaddr156.6.i.i.i, align 8, !noalias !83
  store double %.1525.i.i.i, ptr %sunkaddr159.6.i.i.i, align 8, !noalias !83
  store double %.1525.i.i.i, ptr %sunkaddr165.6.i.i.i, align 8, !noalias !83
  store double %.1525.i.i.i, ptr %sunkaddr168.6.i.i.i, align 8, !noalias !83
  store double %.1525.i.i.i, ptr %sunkaddr171.6.i.i.i, align 8, !noalias !83
  store double %.1525.i.i.i, ptr %sunkaddr174.6.i.i.i, align 8, !noalias !83
  store double %.1525.i.i.i, ptr %sunkaddr177.6.i.i.i, align 8, !noalias !83
  store double %.1525.i.i.i, ptr %sunkaddr129.7.i.i.i, align 8, !noalias !83
  store double %.1525.i.i.i, ptr %sunkaddr132.7.i.i.i, align 8, !noalias !83
  store double %.1525.i.i.i, ptr %sunkaddr135.7.i.i.i, align 8, !noalias !83
  store double %.1525.i.i.i, ptr %sunkaddr138.7.i.i.i, align 8, !noalias !83
  store double %.1525.i.i.i, ptr %sunkaddr141.7.i.i.i, align 8, !noalias !83
  store double %.1525.i.i.i, ptr %sunkaddr144.7.i.i.i, align 8, !noalias !83
  store double %.1525.i.i.i, ptr %sunkaddr147.7.i.i.i, align 8, !noalias !83
  store double %.1525.i.i.i, ptr %sunkaddr150.7.i.i.i, align 8, !noalias !83
  store double %.1525.i.i.i, ptr %sunkaddr153.7.i.i.i, align 8, !noalias !83
  store double %.1525.i.i.i, ptr %sunkaddr156.7.i.i.i, align 8, !noalias !83
  store double %.1525.i.i.i, ptr %sunkaddr159.7.i.i.i, align 8, !noalias !83
  store double %.1525.i.i.i, ptr %sunkaddr165.7.i.i.i, align 8, !noalias !83
  store double %.1525.i.i.i, ptr %sunkaddr168.7.i.i.i, align 8, !noalias !83
  store double %.1525.i.i.i, ptr %sunkaddr171.7.i.i.i, align 8, !noalias !83
  store double %.1525.i.i.i, ptr %sunkaddr174.7.i.i.i, align 8, !noalias !83
  store double %.1525.i.i.i, ptr %sunkaddr177.7.i.i.i, align 8, !noalias !83
  store double %.1554.i.i.i, ptr %sunkaddr180.i.i.i, align 8, !noalias !83
  store double %.1554.i.i.i, ptr %sunkaddr183.i.i.i, align 8, !noalias !83
  store double %.1554.i.i.i, ptr %sunkaddr186.i.i.i, align 8, !noalias !83
  store double %.1554.i.i.i, ptr %sunkaddr189.i.i.i, align 8, !noalias !83
  store double %.1554.i.i.i, ptr %sunkaddr192.i.i.i, align 8, !noalias !83
  store double %.1554.i.i.i, ptr %sunkaddr195.i.i.i, align 8, !noalias !83
  store double %.1554.i.i.i, ptr %sunkaddr198.i.i.i, align 8, !noalias !83
  store double %.1554.i.i.i, ptr %sunkaddr201.i.i.i, align 8, !noalias !83
  store double %.1554.i.i.i, ptr %sunkaddr204.i.i.i, align 8, !noalias !83
  store double %.1554.i.i.i, ptr %sunkaddr207.i.i.i, align 8, !noalias !83
  store double %.1554.i.i.i, ptr %sunkaddr210.i.i.i, align 8, !noalias !83
  store double %.1554.i.i.i, ptr %sunkaddr213.i.i.i, align 8, !noalias !83
  store double %.1554.i.i.i, ptr %sunkaddr216.i.i.i, align 8, !noalias !83
  store double %.1554.i.i.i, ptr %sunkaddr219.i.i.i, align 8, !noalias !83
  store double %.1554.i.i.i, ptr %sunkaddr222.i.i.i, align 8, !noalias !83
  store double %.1554.i.i.i, ptr %sunkaddr225.i.i.i, align 8, !noalias !83
  store double %.1554.i.i.i, ptr %sunkaddr180.1.i.i.i, align 8, !noalias !83
  store double %.1554.i.i.i, ptr %sunkaddr183.1.i.i.i, align 8, !noalias !83
  store double %.1554.i.i.i, ptr %sunkaddr186.1.i.i.i, align 8, !noalias !83
  store double %.1554.i.i.i, ptr %sunkaddr189.1.i.i.i, align 8, !noalias !83
  store double %.1554.i.i.i, ptr %sunkaddr192.1.i.i.i, align 8, !noalias !83
  store double %.1554.i.i.i, ptr %sunkaddr195.1.i.i.i, align 8, !noalias !83
  store double %.1554.i.i.i, ptr %sunkaddr198.1.i.i.i, align 8, !noalias !83
  store double %.1554.i.i.i, ptr %sunkaddr201.1.i.i.i, align 8, !noalias !83
  store double %.1554.i.i.i, ptr %sunkaddr204.1.i.i.i, align 8, !noalias !83
  store double %.1554.i.i.i, ptr %sunkaddr207.1.i.i.i, align 8, !noalias !83
  store double %.1554.i.i.i, ptr %sunkaddr210.1.i.i.i, align 8, !noalias !83
  store double %.1554.i.i.i, ptr %sunkaddr213.1.i.i.i, align 8, !noalias !83
  store double %.1554.i.i.i, ptr %sunkaddr216.1.i.i.i, align 8, !noalias !83
  store double %.1554.i.i.i, ptr %sunkaddr219.1.i.i.i, align 8, !noalias !83
  store double %.1554.i.i.i, ptr %sunkaddr222.1.i.i.i, align 8, !noalias !83
  store double %.1554.i.i.i, ptr %sunkaddr225.1.i.i.i, align 8, !noalias !83
  store double %.1554.i.i.i, ptr %sunkaddr180.2.i.i.i, align 8, !noalias !83
  store double %.1554.i.i.i, ptr %sunkaddr183.2.i.i.i, align 8, !noalias !83
  store double %.1554.i.i.i, ptr %sunkaddr186.2.i.i.i, align 8, !noalias !83
  store double %.1554.i.i.i, ptr %sunkaddr189.2.i.i.i, align 8, !noalias !83
  store double %.1554.i.i.i, ptr %sunkaddr192.2.i.i.i, align 8, !noalias !83
  store double %.1554.i.i.i, ptr %sunkaddr195.2.i.i.i, align 8, !noalias !83
  store double %.1554.i.i.i, ptr %sunkaddr198.2.i.i.i, align 8, !noalias !83
  store double %.1554.i.i.i, ptr %sunkaddr201.2.i.i.i, align 8, !noalias !83
  store double %.1554.i.i.i, ptr %sunkaddr204.2.i.i.i, align 8, !noalias !83
  store double %.1554.i.i.i, ptr %sunkaddr207.2.i.i.i, align 8, !noalias !83
  store double %.1554.i.i.i, ptr %sunkaddr210.2.i.i.i, align 8, !noalias !83
  store double %.1554.i.i.i, ptr %sunkaddr213.2.i.i.i, align 8, !noalias !83
  store double %.1554.i.i.i, ptr %sunkaddr216.2.i.i.i, align 8, !noalias !83
  store double %.1554.i.i.i, ptr %sunkaddr219.2.i.i.i, align 8, !noalias !83
  store double %.1554.i.i.i, ptr %sunkaddr222.2.i.i.i, align 8, !noalias !83
  store double %.1554.i.i.i, ptr %sunkaddr225.2.i.i.i, align 8, !noalias !83
  store double %.1554.i.i.i, ptr %sunkaddr180.3.i.i.i, align 8, !noalias !83
  store double %.1554.i.i.i, ptr %sunkaddr183.3.i.i.i, align 8, !noalias !83
  store double %.1554.i.i.i, ptr %sunkaddr186.3.i.i.i, align 8, !noalias !83
  store double %.1554.i.i.i, ptr %sunkaddr189.3.i.i.i, align 8, !noalias !83
  store double %.1554.i.i.i, ptr %sunkaddr192.3.i.i.i, align 8, !noalias !83
  store double %.1554.i.i.i, ptr %sunkaddr195.3.i.i.i, align 8, !noalias !83
  store double %.1554.i.i.i, ptr %sunkaddr198.3.i.i.i, align 8, !noalias !83
  store double %.1554.i.i.i, ptr %sunkaddr201.3.i.i.i, align 8, !noalias !83
  store double %.1554.i.i.i, ptr %sunkaddr204.3.i.i.i, align 8, !noalias !83
  store double %.1554.i.i.i, ptr %sunkaddr207.3.i.i.i, align 8, !noalias !83
  store double %.1554.i.i.i, ptr %sunkaddr210.3.i.i.i, align 8, !noalias !83
  store double %.1554.i.i.i, ptr %sunkaddr213.3.i.i.i, align 8, !noalias !83
  store double %.1554.i.i.i, ptr %sunkaddr216.3.i.i.i, align 8, !noalias !83
  store double %.1554.i.i.i, ptr %sunkaddr219.3.i.i.i, align 8, !noalias !83
  store double %.1554.i.i.i, ptr %sunkaddr222.3.i.i.i, align 8, !noalias !83
  store double %.1554.i.i.i, ptr %sunkaddr225.3.i.i.i, align 8, !noalias !83
  store double %.1554.i.i.i, ptr %sunkaddr180.4.i.i.i, align 8, !noalias !83
  store double %.1554.i.i.i, ptr %sunkaddr183.4.i.i.i, align 8, !noalias !83
  store double %.1554.i.i.i, ptr %sunkaddr186.4.i.i.i, align 8, !noalias !83
  store double %.1554.i.i.i, ptr %sunkaddr189.4.i.i.i, align 8, !noalias !83
  store double %.1554.i.i.i, ptr %sunkaddr192.4.i.i.i, align 8, !noalias !83
  store double %.1554.i.i.i, ptr %sunkaddr195.4.i.i.i, align 8, !noalias !83
  store double %.1554.i.i.i, ptr %sunkaddr198.4.i.i.i, align 8, !noalias !83
  store double %.1554.i.i.i, ptr %sunkaddr201.4.i.i.i, align 8, !noalias !83
  store double %.1554.i.i.i, ptr %sunkaddr204.4.i.i.i, align 8, !noalias !83
  store double %.1554.i.i.i, ptr %sunkaddr207.4.i.i.i, align 8, !noalias !83
  store double %.1554.i.i.i, ptr %sunkaddr210.4.i.i.i, align 8, !noalias !83
  store double %.1554.i.i.i, ptr %sunkaddr213.4.i.i.i, align 8, !noalias !83
  store double %.1554.i.i.i, ptr %sunkaddr216.4.i.i.i, align 8, !noalias !83
  store double %.1554.i.i.i, ptr %sunkaddr219.4.i.i.i, align 8, !noalias !83
  store double %.1554.i.i.i, ptr %sunkaddr222.4.i.i.i, align 8, !noalias !83
  store double %.1554.i.i.i, ptr %sunkaddr225.4.i.i.i, align 8, !noalias !83
  store double %.1554.i.i.i, ptr %sunkaddr180.5.i.i.i, align 8, !noalias !83
  store double %.1554.i.i.i, ptr %sunkaddr183.5.i.i.i, align 8, !noalias !83
  store double %.1554.i.i.i, ptr %sunkaddr186.5.i.i.i, align 8, !noalias !83
  store double %.1554.i.i.i, ptr %sunkaddr189.5.i.i.i, align 8, !noalias !83
  store double %.1554.i.i.i, ptr %sunkaddr192.5.i.i.i, align 8, !noalias !83
  store double %.1554.i.i.i, ptr %sunkaddr195.5.i.i.i, align 8, !noalias !83
  store double %.1554.i.i.i, ptr %sunkaddr198.5.i.i.i, align 8, !noalias !83
  store double %.1554.i.i.i, ptr %sunkaddr201.5.i.i.i, align 8, !noalias !83
  store double %.1554.i.i.i, ptr %sunkaddr204.5.i.i.i, align 8, !noalias !83
  store double %.1554.i.i.i, ptr %sunkaddr207.5.i.i.i, align 8, !noalias !83
  store double %.1554.i.i.i, ptr %sunkaddr210.5.i.i.i, align 8, !noalias !83
  store double %.1554.i.i.i, ptr %sunkaddr213.5.i.i.i, align 8, !noalias !83
  store double %.1554.i.i.i, ptr %sunkaddr216.5.i.i.i, align 8, !noalias !83
  store double %.1554.i.i.i, ptr %sunkaddr219.5.i.i.i, align 8, !noalias !83
  store double %.1554.i.i.i, ptr %sunkaddr222.5.i.i.i, align 8, !noalias !83
  store double %.1554.i.i.i, ptr %sunkaddr225.5.i.i.i, align 8, !noalias !83
  store double %.1554.i.i.i, ptr %sunkaddr180.6.i.i.i, align 8, !noalias !83
  store double %.1554.i.i.i, ptr %sunkaddr183.6.i.i.i, align 8, !noalias !83
  store double %.1554.i.i.i, ptr %sunkaddr186.6.i.i.i, align 8, !noalias !83
  store double %.1554.i.i.i, ptr %sunkaddr189.6.i.i.i, align 8, !noalias !83
  store double %.1554.i.i.i, ptr %sunkaddr192.6.i.i.i, align 8, !noalias !83
  store double %.1554.i.i.i, ptr %sunkaddr195.6.i.i.i, align 8, !noalias !83
  store double %.1554.i.i.i, ptr %sunkaddr198.6.i.i.i, align 8, !noalias !83
  store double %.1554.i.i.i, ptr %sunkaddr201.6.i.i.i, align 8, !noalias !83
  store double %.1554.i.i.i, ptr %sunkaddr204.6.i.i.i, align 8, !noalias !83
  store double %.1554.i.i.i, ptr %sunkaddr207.6.i.i.i, align 8, !noalias !83
  store double %.1554.i.i.i, ptr %sunkaddr210.6.i.i.i, align 8, !noalias !83
  store double %.1554.i.i.i, ptr %sunkaddr213.6.i.i.i, align 8, !noalias !83
  store double %.1554.i.i.i, ptr %sunkaddr216.6.i.i.i, align 8, !noalias !83
  store double %.1554.i.i.i, ptr %sunkaddr219.6.i.i.i, align 8, !noalias !83
  store double %.1554.i.i.i, ptr %sunkaddr222.6.i.i.i, align 8, !noalias !83
  store double %.1554.i.i.i, ptr %sunkaddr225.6.i.i.i, align 8, !noalias !83
  store double %.1554.i.i.i, ptr %sunkaddr180.7.i.i.i, align 8, !noalias !83
  store double %.1554.i.i.i, ptr %sunkaddr183.7.i.i.i, align 8, !noalias !83
  store double %.1554.i.i.i, ptr %sunkaddr186.7.i.i.i, align 8, !noalias !83
  store double %.1554.i.i.i, ptr %sunkaddr189.7.i.i.i, align 8, !noalias !83
  store double %.1554.i.i.i, ptr %sunkaddr192.7.i.i.i, align 8, !noalias !83
  store double %.1554.i.i.i, ptr %sunkaddr195.7.i.i.i, align 8, !noalias !83
  store double %.1554.i.i.i, ptr %sunkaddr198.7.i.i.i, align 8, !noalias !83
  store double %.1554.i.i.i, ptr %sunkaddr201.7.i.i.i, align 8, !noalias !83
  store double %.1554.i.i.i, ptr %sunkaddr204.7.i.i.i, align 8, !noalias !83
  store double %.1554.i.i.i, ptr %sunkaddr207.7.i.i.i, align 8, !noalias !83
  store double %.1554.i.i.i, ptr %sunkaddr210.7.i.i.i, align 8, !noalias !83
  store double %.1554.i.i.i, ptr %sunkaddr213.7.i.i.i, align 8, !noalias !83
  store double %.1554.i.i.i, ptr %sunkaddr216.7.i.i.i, align 8, !noalias !83
  store double %.1554.i.i.i, ptr %sunkaddr219.7.i.i.i, align 8, !noalias !83
  store double %.1554.i.i.i, ptr %sunkaddr222.7.i.i.i, align 8, !noalias !83
  store double %.1554.i.i.i, ptr %sunkaddr225.7.i.i.i, align 8, !noalias !83
  br label %_ZN17bnserve_inference14adjoint_kernel7_source10_fill_barsB4v277B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i.i

B470.if.i.i.i:                                    ; preds = %B470.if.i.i.i, %B470.if.preheader.new.new.i.i.i
  %lsr.iv.i2.i.i = phi i64 [ %lsr.iv.next1.i.i.i, %B470.if.i.i.i ], [ %289, %B470.if.preheader.new.new.i.i.i ]
  %lsr.iv13.i.i.i = phi ptr [ %scevgep14.i.i.i, %B470.if.i.i.i ], [ %scevgep12.i.i.i, %B470.if.preheader.new.new.i.i.i ]
  %.1209792794.i.i.i = phi i64 [ %.1216.1.1.i.i.i, %B470.if.i.i.i ], [ 0, %B470.if.preheader.new.new.i.i.i ]
  %scevgep19.i.i.i = getelementptr i8, ptr %lsr.iv13.i.i.i, i64 -32
  %scevgep22.i.i.i = getelementptr i8, ptr %lsr.iv13.i.i.i, i64 -56
  %.1271.i.i.i = load double, ptr %scevgep22.i.i.i, align 8, !noalias !83
  %scevgep21.i.i.i = getelementptr i8, ptr %lsr.iv13.i.i.i, i64 -48
  %.1303.i3.i.i = load double, ptr %scevgep21.i.i.i, align 8, !noalias !83
  %sunkaddr29.i.i.i = shl i64 %.1209792794.i.i.i, 3
  %sunkaddr30.i.i.i = getelementptr i8, ptr %.430, i64 %sunkaddr29.i.i.i
  %sunkaddr31.i.i.i = getelementptr i8, ptr %sunkaddr30.i.i.i, i64 12288
  store double %.1271.i.i.i, ptr %sunkaddr31.i.i.i, align 8, !noalias !83
  %sunkaddr34.i.i.i = getelementptr i8, ptr %sunkaddr30.i.i.i, i64 13312
  store double %.1303.i3.i.i, ptr %sunkaddr34.i.i.i, align 8, !noalias !83
  %scevgep20.i.i.i = getelementptr i8, ptr %lsr.iv13.i.i.i, i64 -40
  %.1271.1.i.i.i = load double, ptr %scevgep20.i.i.i, align 8, !noalias !83
  %.1303.1.i.i.i = load double, ptr %scevgep19.i.i.i, align 8, !noalias !83
  %sunkaddr36.i.i.i = getelementptr i8, ptr %sunkaddr30.i.i.i, i64 12296
  store double %.1271.1.i.i.i, ptr %sunkaddr36.i.i.i, align 8, !noalias !83
  %sunkaddr39.i.i.i = getelementptr i8, ptr %sunkaddr30.i.i.i, i64 13320
  store double %.1303.1.i.i.i, ptr %sunkaddr39.i.i.i, align 8, !noalias !83
  %scevgep18.i.i.i = getelementptr i8, ptr %lsr.iv13.i.i.i, i64 -24
  %.1271.18.i.i.i = load double, ptr %scevgep18.i.i.i, align 8, !noalias !83
  %scevgep17.i.i.i = getelementptr i8, ptr %lsr.iv13.i.i.i, i64 -16
  %.1303.19.i.i.i = load double, ptr %scevgep17.i.i.i, align 8, !noalias !83
  %sunkaddr42.i.i.i = getelementptr i8, ptr %sunkaddr30.i.i.i, i64 12304
  store double %.1271.18.i.i.i, ptr %sunkaddr42.i.i.i, align 8, !noalias !83
  %sunkaddr45.i.i.i = getelementptr i8, ptr %sunkaddr30.i.i.i, i64 13328
  store double %.1303.19.i.i.i, ptr %sunkaddr45.i.i.i, align 8, !noalias !83
  %.1216.1.1.i.i.i = add i64 %.1209792794.i.i.i, 4
  %scevgep16.i.i.i = getelementptr i8, ptr %lsr.iv13.i.i.i, i64 -8
  %.1271.1.1.i.i.i = load double, ptr %scevgep16.i.i.i, align 8, !noalias !83
  %.1303.1.1.i.i.i = load double, ptr %lsr.iv13.i.i.i, align 8, !noalias !83
  %sunkaddr46.i.i.i = shl i64 %.1216.1.1.i.i.i, 3
  %sunkaddr47.i.i.i = getelementptr i8, ptr %.430, i64 %sunkaddr46.i.i.i
  %sunkaddr48.i.i.i = getelementptr i8, ptr %sunkaddr47.i.i.i, i64 12280
  store double %.1271.1.1.i.i.i, ptr %sunkaddr48.i.i.i, align 8, !noalias !83
  %sunkaddr51.i.i.i = getelementptr i8, ptr %sunkaddr47.i.i.i, i64 13304
  store double %.1303.1.1.i.i.i, ptr %sunkaddr51.i.i.i, align 8, !noalias !83
  %scevgep14.i.i.i = getelementptr i8, ptr %lsr.iv13.i.i.i, i64 64
  %lsr.iv.next1.i.i.i = add i64 %lsr.iv.i2.i.i, 2
  %niter.ncmp.110.i.i.i = icmp eq i64 %lsr.iv.next1.i.i.i, 0
  br i1 %niter.ncmp.110.i.i.i, label %B540.loopexit.unr-lcssa.unr-lcssa.i.i.i, label %B470.if.i.i.i

_ZN17bnserve_inference14adjoint_kernel7_source10_fill_barsB4v277B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i.i: ; preds = %B544.i.i.i, %B470.if.epil.preheader.i.i.i, %B540.loopexit.unr-lcssa.i.i.i, %B266.i.i.i
  %.1313.i.i232 = uitofp nneg i64 %.1245791801.i.i to double
  %.1314.i.i233 = fmul contract double %.455751.i.i, %.1313.i.i232
  %.1316.i.i234 = fadd contract double %.1227.i, %.1314.i.i233
  br i1 %278, label %B788.i.i, label %B896.i.i

B382.i.i.i:                                       ; preds = %B382.lr.ph.i.i.i, %B382.i.i.i
  %lsr.iv.i.i.i = phi i64 [ %.116.i.i171, %B382.lr.ph.i.i.i ], [ %lsr.iv.next.i.i.i, %B382.i.i.i ]
  %.679.sroa.0.0385.i.i.i = phi i64 [ 0, %B382.lr.ph.i.i.i ], [ %.679.sroa.0.0.i.i.i, %B382.i.i.i ]
  %.695954383.i.i.i = phi i64 [ 8, %B382.lr.ph.i.i.i ], [ %.695954.i.i.i, %B382.i.i.i ]
  %.734.i.i.i = getelementptr inbounds double, ptr %.290.i29.i, i64 %.679.sroa.0.0385.i.i.i
  %.736.i.i.i = load <8 x double>, ptr %.734.i.i.i, align 8, !noalias !86
  %.8.i.i.i.i = fmul contract <8 x double> %.736.i.i.i, splat (double 0xC01921FB54442D18)
  %.8.i412.i.i.i = fmul contract <8 x double> %.7.i.i.i.i, %.8.i.i.i.i
  %.792.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i412.i.i.i, <8 x double> splat (double 0x3FE45F306DC9C883), <8 x double> splat (double 0x4338000000000000))
  %.8.i413.i.i.i = fadd contract <8 x double> %.792.i.i.i, splat (double 0xC338000000000000)
  %.833.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i413.i.i.i, <8 x double> splat (double 0xBFF921FB54442D18), <8 x double> %.8.i412.i.i.i)
  %.850.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i413.i.i.i, <8 x double> splat (double 0xBC91A62633145C07), <8 x double> %.833.i.i.i)
  %.6.i414.i.i.i = fmul contract <8 x double> %.850.i.i.i, %.850.i.i.i
  %.6.i415.i.i.i = fmul contract <8 x double> %.850.i.i.i, %.6.i414.i.i.i
  %.879.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i414.i.i.i, <8 x double> splat (double 0xBD6AE7F3E733B81F), <8 x double> splat (double 0x3DE6124613A86D09))
  %.882.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i414.i.i.i, <8 x double> %.879.i.i.i, <8 x double> splat (double 0xBE5AE64567F544E4))
  %.885.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i414.i.i.i, <8 x double> %.882.i.i.i, <8 x double> splat (double 0x3EC71DE3A556C734))
  %.888.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i414.i.i.i, <8 x double> %.885.i.i.i, <8 x double> splat (double 0xBF2A01A01A01A01A))
  %.891.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i414.i.i.i, <8 x double> %.888.i.i.i, <8 x double> splat (double 0x3F81111111111111))
  %.894.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i414.i.i.i, <8 x double> %.891.i.i.i, <8 x double> splat (double 0xBFC5555555555555))
  %.919.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i415.i.i.i, <8 x double> %.894.i.i.i, <8 x double> %.850.i.i.i)
  %.924.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i414.i.i.i, <8 x double> splat (double 0x3D2AE7F3E733B81F), <8 x double> splat (double 0xBDA93974A8C07C9D))
  %.927.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i414.i.i.i, <8 x double> %.924.i.i.i, <8 x double> splat (double 0x3E21EED8EFF8D898))
  %.930.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i414.i.i.i, <8 x double> %.927.i.i.i, <8 x double> splat (double 0xBE927E4FB7789F5C))
  %.933.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i414.i.i.i, <8 x double> %.930.i.i.i, <8 x double> splat (double 0x3EFA01A01A01A01A))
  %.936.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i414.i.i.i, <8 x double> %.933.i.i.i, <8 x double> splat (double 0xBF56C16C16C16C17))
  %.939.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i414.i.i.i, <8 x double> %.936.i.i.i, <8 x double> splat (double 0x3FA5555555555555))
  %.942.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i414.i.i.i, <8 x double> %.939.i.i.i, <8 x double> splat (double -5.000000e-01))
  %.945.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i414.i.i.i, <8 x double> %.942.i.i.i, <8 x double> splat (double 1.000000e+00))
  %.946.i.i.i = bitcast <8 x double> %.792.i.i.i to <8 x i64>
  %.947.i.i.i = bitcast <8 x double> %.919.i.i.i to <8 x i64>
  %.948.i.i.i = bitcast <8 x double> %.945.i.i.i to <8 x i64>
  %.6.i416.i.i.i = xor <8 x i64> %.948.i.i.i, %.947.i.i.i
  %.8.i417.i.i.i = and <8 x i64> %.946.i.i.i, splat (i64 1)
  %295 = icmp eq <8 x i64> %.8.i417.i.i.i, zeroinitializer
  %.6.i419.i.i.i = select <8 x i1> %295, <8 x i64> zeroinitializer, <8 x i64> %.6.i416.i.i.i
  %.8.i420.i.i.i = shl <8 x i64> %.946.i.i.i, splat (i64 62)
  %.8.i421.i.i.i = and <8 x i64> %.8.i420.i.i.i, splat (i64 -9223372036854775808)
  %.8.i423.i.i.i = add <8 x i64> %.8.i420.i.i.i, splat (i64 4611686018427387904)
  %.8.i424.i.i.i = and <8 x i64> %.8.i423.i.i.i, splat (i64 -9223372036854775808)
  %296 = xor <8 x i64> %.8.i421.i.i.i, %.947.i.i.i
  %.6.i426.i.i.i = xor <8 x i64> %296, %.6.i419.i.i.i
  %297 = bitcast <8 x i64> %.6.i426.i.i.i to <8 x double>
  %298 = xor <8 x i64> %.8.i424.i.i.i, %.948.i.i.i
  %.6.i428.i.i.i = xor <8 x i64> %298, %.6.i419.i.i.i
  %299 = bitcast <8 x i64> %.6.i428.i.i.i to <8 x double>
  %sunkaddr.i.i.i = shl i64 %.679.sroa.0.0385.i.i.i, 3
  %sunkaddr487.i.i.i = getelementptr inbounds i8, ptr %.430, i64 %sunkaddr.i.i.i
  %sunkaddr488.i.i.i = getelementptr inbounds nuw i8, ptr %sunkaddr487.i.i.i, i64 12288
  %.1293.i.i.i = load <8 x double>, ptr %sunkaddr488.i.i.i, align 8, !noalias !86
  %sunkaddr491.i.i.i = getelementptr inbounds nuw i8, ptr %sunkaddr487.i.i.i, i64 13312
  %.1303.i.i.i = load <8 x double>, ptr %sunkaddr491.i.i.i, align 8, !noalias !86
  %300 = fneg contract <8 x double> %297
  %.8.i430.i.i.i = fmul contract <8 x double> %.1303.i.i.i, %300
  %.1352.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1293.i.i.i, <8 x double> %299, <8 x double> %.8.i430.i.i.i)
  %.6.i431.i.i.i = fmul contract <8 x double> %.1303.i.i.i, %299
  %.1377.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1293.i.i.i, <8 x double> %297, <8 x double> %.6.i431.i.i.i)
  %.1406.i.i.i = getelementptr inbounds double, ptr %.1337.i.i230, i64 %.679.sroa.0.0385.i.i.i
  %.1408.i.i.i = load <8 x double>, ptr %.1406.i.i.i, align 8, !noalias !86
  %.1416.i.i.i = getelementptr inbounds double, ptr %.1403.i30.i, i64 %.679.sroa.0.0385.i.i.i
  %.1418.i.i.i = load <8 x double>, ptr %.1416.i.i.i, align 8, !noalias !86
  %301 = fneg contract <8 x double> %.1377.i.i.i
  %.8.i433.i.i.i = fmul contract <8 x double> %.1418.i.i.i, %301
  %.1467.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1408.i.i.i, <8 x double> %.1352.i.i.i, <8 x double> %.8.i433.i.i.i)
  %.6.i434.i.i.i = fmul contract <8 x double> %.1418.i.i.i, %.1352.i.i.i
  %.1492.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1408.i.i.i, <8 x double> %.1377.i.i.i, <8 x double> %.6.i434.i.i.i)
  %sunkaddr494.i.i.i = getelementptr inbounds nuw i8, ptr %sunkaddr487.i.i.i, i64 6144
  %.1522.i.i.i = load <8 x double>, ptr %sunkaddr494.i.i.i, align 8, !noalias !86
  %.6.i435.i.i.i = fadd contract <8 x double> %.1522.i.i.i, %.1467.i.i.i
  store <8 x double> %.6.i435.i.i.i, ptr %sunkaddr494.i.i.i, align 8, !noalias !86
  %sunkaddr497.i.i.i = getelementptr inbounds nuw i8, ptr %sunkaddr487.i.i.i, i64 7168
  %.1566.i.i.i = load <8 x double>, ptr %sunkaddr497.i.i.i, align 8, !noalias !86
  %.6.i436.i.i.i = fadd contract <8 x double> %.1566.i.i.i, %.1492.i.i.i
  store <8 x double> %.6.i436.i.i.i, ptr %sunkaddr497.i.i.i, align 8, !noalias !86
  %sunkaddr500.i.i.i = getelementptr inbounds nuw i8, ptr %sunkaddr487.i.i.i, i64 8192
  %.1610.i.i.i = load <8 x double>, ptr %sunkaddr500.i.i.i, align 8, !noalias !86
  %.6.i437.i.i.i = fmul contract <8 x double> %.8.i.i.i.i, %.1492.i.i.i
  %.6.i438.i.i.i = fsub contract <8 x double> %.1610.i.i.i, %.6.i437.i.i.i
  store <8 x double> %.6.i438.i.i.i, ptr %sunkaddr500.i.i.i, align 8, !noalias !86
  %sunkaddr503.i.i.i = getelementptr inbounds nuw i8, ptr %sunkaddr487.i.i.i, i64 9216
  %.1678.i.i.i = load <8 x double>, ptr %sunkaddr503.i.i.i, align 8, !noalias !86
  %.1679.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i.i.i.i, <8 x double> %.1467.i.i.i, <8 x double> %.1678.i.i.i)
  store <8 x double> %.1679.i.i.i, ptr %sunkaddr503.i.i.i, align 8, !noalias !86
  %.689.i.i.i = icmp samesign ugt i64 %lsr.iv.i.i.i, 1
  %.702.i.i.i = add i64 %.695954383.i.i.i, 8
  %.695954.i.i.i = select i1 %.689.i.i.i, i64 %.702.i.i.i, i64 %.695954383.i.i.i
  %.679.sroa.0.0.i.i.i = select i1 %.689.i.i.i, i64 %.695954383.i.i.i, i64 0
  %lsr.iv.next.i.i.i = add nsw i64 %lsr.iv.i.i.i, -1
  %B382.termcond.i.i.i = icmp sgt i64 %lsr.iv.i.i.i, 1
  br i1 %B382.termcond.i.i.i, label %B382.i.i.i, label %B1016.i.i

B382.lr.ph.i.i.i:                                 ; preds = %B788.i.i
  %.6.i.i.i.i = insertelement <8 x double> poison, double %.1316.i.i234, i64 0
  %.7.i.i.i.i = shufflevector <8 x double> %.6.i.i.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  br label %B382.i.i.i

B394.i.i.i:                                       ; preds = %B394.lr.ph.i.i.i, %B394.i.i.i
  %lsr.iv.i59.i.i = phi i64 [ %.116.i.i171, %B394.lr.ph.i.i.i ], [ %lsr.iv.next.i66.i.i, %B394.i.i.i ]
  %.735.sroa.0.0673.i.i.i = phi i64 [ 0, %B394.lr.ph.i.i.i ], [ %.735.sroa.0.0.i.i.i, %B394.i.i.i ]
  %.7511582671.i.i.i = phi i64 [ 8, %B394.lr.ph.i.i.i ], [ %.7511582.i.i.i, %B394.i.i.i ]
  %.790.i.i.i = getelementptr inbounds double, ptr %.290.i29.i, i64 %.735.sroa.0.0673.i.i.i
  %.792.i60.i.i = load <8 x double>, ptr %.790.i.i.i, align 8, !noalias !89
  %.8.i.i61.i.i = fmul contract <8 x double> %.792.i60.i.i, splat (double 0xC01921FB54442D18)
  %.8.i700.i.i.i = fmul contract <8 x double> %.7.i.i58.i.i, %.8.i.i61.i.i
  %.848.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i700.i.i.i, <8 x double> splat (double 0x3FE45F306DC9C883), <8 x double> splat (double 0x4338000000000000))
  %.8.i701.i.i.i = fadd contract <8 x double> %.848.i.i.i, splat (double 0xC338000000000000)
  %.889.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i701.i.i.i, <8 x double> splat (double 0xBFF921FB54442D18), <8 x double> %.8.i700.i.i.i)
  %.906.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i701.i.i.i, <8 x double> splat (double 0xBC91A62633145C07), <8 x double> %.889.i.i.i)
  %.6.i702.i.i.i = fmul contract <8 x double> %.906.i.i.i, %.906.i.i.i
  %.6.i703.i.i.i = fmul contract <8 x double> %.906.i.i.i, %.6.i702.i.i.i
  %.935.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i702.i.i.i, <8 x double> splat (double 0xBD6AE7F3E733B81F), <8 x double> splat (double 0x3DE6124613A86D09))
  %.938.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i702.i.i.i, <8 x double> %.935.i.i.i, <8 x double> splat (double 0xBE5AE64567F544E4))
  %.941.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i702.i.i.i, <8 x double> %.938.i.i.i, <8 x double> splat (double 0x3EC71DE3A556C734))
  %.944.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i702.i.i.i, <8 x double> %.941.i.i.i, <8 x double> splat (double 0xBF2A01A01A01A01A))
  %.947.i62.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i702.i.i.i, <8 x double> %.944.i.i.i, <8 x double> splat (double 0x3F81111111111111))
  %.950.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i702.i.i.i, <8 x double> %.947.i62.i.i, <8 x double> splat (double 0xBFC5555555555555))
  %.975.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i703.i.i.i, <8 x double> %.950.i.i.i, <8 x double> %.906.i.i.i)
  %.980.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i702.i.i.i, <8 x double> splat (double 0x3D2AE7F3E733B81F), <8 x double> splat (double 0xBDA93974A8C07C9D))
  %.983.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i702.i.i.i, <8 x double> %.980.i.i.i, <8 x double> splat (double 0x3E21EED8EFF8D898))
  %.986.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i702.i.i.i, <8 x double> %.983.i.i.i, <8 x double> splat (double 0xBE927E4FB7789F5C))
  %.989.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i702.i.i.i, <8 x double> %.986.i.i.i, <8 x double> splat (double 0x3EFA01A01A01A01A))
  %.992.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i702.i.i.i, <8 x double> %.989.i.i.i, <8 x double> splat (double 0xBF56C16C16C16C17))
  %.995.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i702.i.i.i, <8 x double> %.992.i.i.i, <8 x double> splat (double 0x3FA5555555555555))
  %.998.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i702.i.i.i, <8 x double> %.995.i.i.i, <8 x double> splat (double -5.000000e-01))
  %.1001.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i702.i.i.i, <8 x double> %.998.i.i.i, <8 x double> splat (double 1.000000e+00))
  %.1002.i.i.i = bitcast <8 x double> %.848.i.i.i to <8 x i64>
  %.1003.i.i.i = bitcast <8 x double> %.975.i.i.i to <8 x i64>
  %.1004.i.i.i = bitcast <8 x double> %.1001.i.i.i to <8 x i64>
  %.6.i704.i.i.i = xor <8 x i64> %.1004.i.i.i, %.1003.i.i.i
  %.8.i705.i.i.i = and <8 x i64> %.1002.i.i.i, splat (i64 1)
  %302 = icmp eq <8 x i64> %.8.i705.i.i.i, zeroinitializer
  %.6.i707.i.i.i = select <8 x i1> %302, <8 x i64> zeroinitializer, <8 x i64> %.6.i704.i.i.i
  %.8.i708.i.i.i = shl <8 x i64> %.1002.i.i.i, splat (i64 62)
  %.8.i709.i.i.i = and <8 x i64> %.8.i708.i.i.i, splat (i64 -9223372036854775808)
  %.8.i711.i.i.i = add <8 x i64> %.8.i708.i.i.i, splat (i64 4611686018427387904)
  %.8.i712.i.i.i = and <8 x i64> %.8.i711.i.i.i, splat (i64 -9223372036854775808)
  %303 = xor <8 x i64> %.8.i709.i.i.i, %.1003.i.i.i
  %.6.i714.i.i.i = xor <8 x i64> %303, %.6.i707.i.i.i
  %304 = bitcast <8 x i64> %.6.i714.i.i.i to <8 x double>
  %305 = xor <8 x i64> %.8.i712.i.i.i, %.1004.i.i.i
  %.6.i716.i.i.i = xor <8 x i64> %305, %.6.i707.i.i.i
  %306 = bitcast <8 x i64> %.6.i716.i.i.i to <8 x double>
  %sunkaddr.i63.i.i = shl i64 %.735.sroa.0.0673.i.i.i, 3
  %sunkaddr792.i.i.i = getelementptr inbounds i8, ptr %.430, i64 %sunkaddr.i63.i.i
  %sunkaddr793.i.i.i = getelementptr inbounds nuw i8, ptr %sunkaddr792.i.i.i, i64 12288
  %.1349.i.i.i = load <8 x double>, ptr %sunkaddr793.i.i.i, align 8, !noalias !89
  %sunkaddr796.i.i.i = getelementptr inbounds nuw i8, ptr %sunkaddr792.i.i.i, i64 13312
  %.1359.i.i.i = load <8 x double>, ptr %sunkaddr796.i.i.i, align 8, !noalias !89
  %307 = fneg contract <8 x double> %304
  %.8.i718.i.i.i = fmul contract <8 x double> %.1359.i.i.i, %307
  %.1408.i64.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1349.i.i.i, <8 x double> %306, <8 x double> %.8.i718.i.i.i)
  %.6.i719.i.i.i = fmul contract <8 x double> %.1359.i.i.i, %306
  %.1433.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1349.i.i.i, <8 x double> %304, <8 x double> %.6.i719.i.i.i)
  %.1455.i.i.i = add nsw i64 %.735.sroa.0.0673.i.i.i, %.267.i.i.i
  %.1459.i.i.i = add nsw i64 %.735.sroa.0.0673.i.i.i, %.1458.i.i.i
  %gep.i.i.i = getelementptr double, ptr %invariant.gep.i.i.i, i64 %.1455.i.i.i
  %.1483.i.i.i = load <8 x double>, ptr %gep.i.i.i, align 8, !noalias !89
  %.1491.i.i.i = getelementptr inbounds double, ptr %277, i64 %.1455.i.i.i
  %.1493.i.i.i = load <8 x double>, ptr %.1491.i.i.i, align 8, !noalias !89
  %.8.i722.i.i.i = fmul contract <8 x double> %.7.i721.i.i.i, %.1493.i.i.i
  %.1521.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1483.i.i.i, <8 x double> %.1520.i.i.i, <8 x double> %.8.i722.i.i.i)
  %gep1622.i.i.i = getelementptr double, ptr %invariant.gep1621.i.i.i, i64 %.1455.i.i.i
  %.1532.i.i.i = load <8 x double>, ptr %gep1622.i.i.i, align 8, !noalias !89
  %gep1624.i.i.i = getelementptr double, ptr %invariant.gep1623.i.i.i, i64 %.1455.i.i.i
  %.1544.i.i.i = load <8 x double>, ptr %gep1624.i.i.i, align 8, !noalias !89
  %.1548.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1544.i.i.i, <8 x double> %.1547.i.i.i, <8 x double> %.1521.i.i.i)
  %.1551.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1532.i.i.i, <8 x double> %.1550.i.i.i, <8 x double> %.1548.i.i.i)
  %gep1626.i.i.i = getelementptr double, ptr %invariant.gep1625.i.i.i, i64 %.1455.i.i.i
  %.1562.i.i.i = load <8 x double>, ptr %gep1626.i.i.i, align 8, !noalias !89
  %gep1628.i.i.i = getelementptr double, ptr %invariant.gep1627.i.i.i, i64 %.1455.i.i.i
  %.1574.i.i.i = load <8 x double>, ptr %gep1628.i.i.i, align 8, !noalias !89
  %.1587.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1574.i.i.i, <8 x double> %.1586.i.i.i, <8 x double> %.1551.i.i.i)
  %.1590.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1562.i.i.i, <8 x double> %.1589.i.i.i, <8 x double> %.1587.i.i.i)
  %gep1542.i.i.i = getelementptr double, ptr %invariant.gep.i.i.i, i64 %.1459.i.i.i
  %.1613.i.i.i = load <8 x double>, ptr %gep1542.i.i.i, align 8, !noalias !89
  %.1621.i.i.i = getelementptr inbounds double, ptr %277, i64 %.1459.i.i.i
  %.1623.i.i.i = load <8 x double>, ptr %.1621.i.i.i, align 8, !noalias !89
  %.8.i725.i.i.i = fmul contract <8 x double> %.7.i721.i.i.i, %.1623.i.i.i
  %.1651.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1613.i.i.i, <8 x double> %.1520.i.i.i, <8 x double> %.8.i725.i.i.i)
  %gep1630.i.i.i = getelementptr double, ptr %invariant.gep1621.i.i.i, i64 %.1459.i.i.i
  %.1662.i.i.i = load <8 x double>, ptr %gep1630.i.i.i, align 8, !noalias !89
  %gep1632.i.i.i = getelementptr double, ptr %invariant.gep1623.i.i.i, i64 %.1459.i.i.i
  %.1674.i.i.i = load <8 x double>, ptr %gep1632.i.i.i, align 8, !noalias !89
  %.1678.i65.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1674.i.i.i, <8 x double> %.1547.i.i.i, <8 x double> %.1651.i.i.i)
  %.1681.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1662.i.i.i, <8 x double> %.1550.i.i.i, <8 x double> %.1678.i65.i.i)
  %gep1634.i.i.i = getelementptr double, ptr %invariant.gep1625.i.i.i, i64 %.1459.i.i.i
  %.1692.i.i.i = load <8 x double>, ptr %gep1634.i.i.i, align 8, !noalias !89
  %gep1636.i.i.i = getelementptr double, ptr %invariant.gep1627.i.i.i, i64 %.1459.i.i.i
  %.1704.i.i.i = load <8 x double>, ptr %gep1636.i.i.i, align 8, !noalias !89
  %.1717.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1704.i.i.i, <8 x double> %.1586.i.i.i, <8 x double> %.1681.i.i.i)
  %.1720.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1692.i.i.i, <8 x double> %.1589.i.i.i, <8 x double> %.1717.i.i.i)
  %308 = fneg contract <8 x double> %.1433.i.i.i
  %.8.i727.i.i.i = fmul contract <8 x double> %.1720.i.i.i, %308
  %.1769.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1590.i.i.i, <8 x double> %.1408.i64.i.i, <8 x double> %.8.i727.i.i.i)
  %.6.i728.i.i.i = fmul contract <8 x double> %.1720.i.i.i, %.1408.i64.i.i
  %.1794.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1590.i.i.i, <8 x double> %.1433.i.i.i, <8 x double> %.6.i728.i.i.i)
  %.8.i731.i.i.i = fmul contract <8 x double> %.7.i730.i.i.i, %.1493.i.i.i
  %.1876.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1483.i.i.i, <8 x double> %.1875.i.i.i, <8 x double> %.8.i731.i.i.i)
  %.1903.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1544.i.i.i, <8 x double> %.1902.i.i.i, <8 x double> %.1876.i.i.i)
  %.1906.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1532.i.i.i, <8 x double> %.1905.i.i.i, <8 x double> %.1903.i.i.i)
  %.1942.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1574.i.i.i, <8 x double> %.1941.i.i.i, <8 x double> %.1906.i.i.i)
  %.1945.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1562.i.i.i, <8 x double> %.1944.i.i.i, <8 x double> %.1942.i.i.i)
  %.8.i734.i.i.i = fmul contract <8 x double> %.7.i730.i.i.i, %.1623.i.i.i
  %.2006.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1613.i.i.i, <8 x double> %.1875.i.i.i, <8 x double> %.8.i734.i.i.i)
  %.2033.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1674.i.i.i, <8 x double> %.1902.i.i.i, <8 x double> %.2006.i.i.i)
  %.2036.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1662.i.i.i, <8 x double> %.1905.i.i.i, <8 x double> %.2033.i.i.i)
  %.2072.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1704.i.i.i, <8 x double> %.1941.i.i.i, <8 x double> %.2036.i.i.i)
  %.2075.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1692.i.i.i, <8 x double> %.1944.i.i.i, <8 x double> %.2072.i.i.i)
  %.8.i736.i.i.i = fmul contract <8 x double> %.2075.i.i.i, %308
  %.2124.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1945.i.i.i, <8 x double> %.1408.i64.i.i, <8 x double> %.8.i736.i.i.i)
  %.6.i737.i.i.i = fmul contract <8 x double> %.2075.i.i.i, %.1408.i64.i.i
  %.2149.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.1945.i.i.i, <8 x double> %.1433.i.i.i, <8 x double> %.6.i737.i.i.i)
  %sunkaddr799.i.i.i = getelementptr inbounds nuw i8, ptr %sunkaddr792.i.i.i, i64 6144
  %.2179.i.i.i = load <8 x double>, ptr %sunkaddr799.i.i.i, align 8, !noalias !89
  %.6.i738.i.i.i = fadd contract <8 x double> %.2179.i.i.i, %.1769.i.i.i
  store <8 x double> %.6.i738.i.i.i, ptr %sunkaddr799.i.i.i, align 8, !noalias !89
  %sunkaddr802.i.i.i = getelementptr inbounds nuw i8, ptr %sunkaddr792.i.i.i, i64 7168
  %.2223.i.i.i = load <8 x double>, ptr %sunkaddr802.i.i.i, align 8, !noalias !89
  %.6.i739.i.i.i = fadd contract <8 x double> %.2223.i.i.i, %.1794.i.i.i
  store <8 x double> %.6.i739.i.i.i, ptr %sunkaddr802.i.i.i, align 8, !noalias !89
  %sunkaddr805.i.i.i = getelementptr inbounds nuw i8, ptr %sunkaddr792.i.i.i, i64 8192
  %.2267.i.i.i = load <8 x double>, ptr %sunkaddr805.i.i.i, align 8, !noalias !89
  %.6.i740.i.i.i = fmul contract <8 x double> %.8.i.i61.i.i, %.1794.i.i.i
  %.6.i741.i.i.i = fsub contract <8 x double> %.2124.i.i.i, %.6.i740.i.i.i
  %.6.i742.i.i.i = fadd contract <8 x double> %.2267.i.i.i, %.6.i741.i.i.i
  store <8 x double> %.6.i742.i.i.i, ptr %sunkaddr805.i.i.i, align 8, !noalias !89
  %sunkaddr808.i.i.i = getelementptr inbounds nuw i8, ptr %sunkaddr792.i.i.i, i64 9216
  %.2359.i.i.i = load <8 x double>, ptr %sunkaddr808.i.i.i, align 8, !noalias !89
  %.2360.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.8.i.i61.i.i, <8 x double> %.1769.i.i.i, <8 x double> %.2149.i.i.i)
  %.6.i743.i.i.i = fadd contract <8 x double> %.2359.i.i.i, %.2360.i.i.i
  store <8 x double> %.6.i743.i.i.i, ptr %sunkaddr808.i.i.i, align 8, !noalias !89
  %.745.i.i.i = icmp samesign ugt i64 %lsr.iv.i59.i.i, 1
  %.758.i.i.i = add i64 %.7511582671.i.i.i, 8
  %.7511582.i.i.i = select i1 %.745.i.i.i, i64 %.758.i.i.i, i64 %.7511582671.i.i.i
  %.735.sroa.0.0.i.i.i = select i1 %.745.i.i.i, i64 %.7511582671.i.i.i, i64 0
  %lsr.iv.next.i66.i.i = add nsw i64 %lsr.iv.i59.i.i, -1
  %B394.termcond.i.i.i = icmp sgt i64 %lsr.iv.i59.i.i, 1
  br i1 %B394.termcond.i.i.i, label %B394.i.i.i, label %B1016.i.i

B394.lr.ph.i.i.i:                                 ; preds = %B896.i.i
  %.1841.i.i = fneg contract double %.183.i.i.i
  %.1842.i.i = fmul contract double %.183.i.i.i, %.1841.i.i
  %.1843.i.i = fmul contract double %.183.i.i.i, %.1842.i.i
  %.1844.i.i = fmul contract double %.183.i.i.i, %.1843.i.i
  %.1845.i.i = fmul contract double %.1810.i.i, %.1844.i.i
  %.186.i.i.i = fmul contract double %.183.i.i.i, %.185.i.i.i
  %.187.i.i.i = fmul contract double %.183.i.i.i, %.186.i.i.i
  %.191.i.i.i = fdiv contract double %.187.i.i.i, 1.200000e+02
  %.6.i.i57.i.i = insertelement <8 x double> poison, double %.1316.i.i234, i64 0
  %.7.i.i58.i.i = shufflevector <8 x double> %.6.i.i57.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.6.i720.i.i.i = insertelement <8 x double> poison, double %.191.i.i.i, i64 0
  %.7.i721.i.i.i = shufflevector <8 x double> %.6.i720.i.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.6.i729.i.i.i = insertelement <8 x double> poison, double %.1845.i.i, i64 0
  %.7.i730.i.i.i = shufflevector <8 x double> %.6.i729.i.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  br label %B394.i.i.i

_ZN17bnserve_inference14adjoint_kernel7_source16_through_weightsB4v266B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxxx5ArrayIxLi1E1C7mutable7alignedEd5ArrayIdLi1E1C7mutable7alignedE.exit.i: ; preds = %B1016.i.i, %B802.if.i
  %.74.i.i239 = load i64, ptr %.76, align 8, !noalias !92
  %.190.i.i = add nsw i64 %.74.i.i239, 1
  %.192.i.i = mul nsw i64 %.190.i.i, %.74.i.i239
  %.272.i33.i = and i64 %.192.i.i, -2
  %.412887.not.i.i = icmp slt i64 %.74.i.i239, 1
  br i1 %.412887.not.i.i, label %_ZN17bnserve_inference14adjoint_kernel7_source14_through_pairsB4v324B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i, label %B290.if.lr.ph.i.i

B290.loopexit.i.i:                                ; preds = %B1078.i.i
  %.425.i.i = add nuw nsw i64 %.356.0.i.i, 1
  %scevgep267.i.i = getelementptr i8, ptr %lsr.iv.i37.i, i64 27648
  %exitcond262.not.i.i = icmp eq i64 %.425.i.i, %.74.i.i239
  br i1 %exitcond262.not.i.i, label %_ZN17bnserve_inference14adjoint_kernel7_source14_through_pairsB4v324B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i, label %B290.if.i.i

B836.i.i:                                         ; preds = %B274.i.i.i, %B328.if.i.i
  br i1 %brmerge1.i.i, label %B1078.i.i, label %B174.if.preheader.i117.i.i

B1078.i.i:                                        ; preds = %B274.i130.i.i, %B836.i.i
  %.1704.i.i = add nsw i64 %at.2.1884.i.i, 1
  %scevgep276.i49.i = getelementptr i8, ptr %lsr.iv275.i.i, i64 27648
  %exitcond.not.i50.i = icmp eq i64 %.553.i.i244, %.74.i.i239
  br i1 %exitcond.not.i50.i, label %B290.loopexit.i.i, label %B328.if.i.i

B290.if.lr.ph.i.i:                                ; preds = %_ZN17bnserve_inference14adjoint_kernel7_source16_through_weightsB4v266B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxxx5ArrayIxLi1E1C7mutable7alignedEd5ArrayIdLi1E1C7mutable7alignedE.exit.i
  %.200.1.i.i = lshr i64 %.192.i.i, 1
  %.269.i34.i = mul i64 %.268.i.i220, %.200.1.i.i
  %.266.i.i240 = load i64, ptr %.265.i.i221, align 8, !noalias !92
  %.270.i.i241 = add nsw i64 %.266.i.i240, %.269.i34.i
  %.178.i.i242 = load i64, ptr %.500.i.i217, align 8, !noalias !92
  %309 = icmp eq i64 %.178.i.i242, 1
  %.105.i.i = load i64, ptr %.140, align 8, !noalias !92
  %.106.i.i = sub i64 0, %.105.i.i
  %.114.1.i.i = and i64 %.106.i.i, -8
  %.148.i35.i = sub i64 0, %.114.1.i.i
  %.585.i.i = mul nsw i64 %.1282920924, %.148.i35.i
  %.591.i.i243 = shl nsw i64 %.148.i35.i, 1
  %.594.i.i = mul nuw nsw i64 %.200.1.i.i, %.1282920924
  %310 = mul i64 %.114.1.i.i, -8
  %311 = select i1 %309, i64 0, i64 %310
  %312 = inttoptr i64 %.270.i.i241 to ptr
  br label %B290.if.i.i

B290.if.i.i:                                      ; preds = %B290.if.lr.ph.i.i, %B290.loopexit.i.i
  %lsr.iv.i37.i = phi ptr [ %scevgep266.i.i, %B290.if.lr.ph.i.i ], [ %scevgep267.i.i, %B290.loopexit.i.i ]
  %.356.0.i.i = phi i64 [ 0, %B290.if.lr.ph.i.i ], [ %.425.i.i, %B290.loopexit.i.i ]
  %at.3.0888.i.i = phi i64 [ 0, %B290.if.lr.ph.i.i ], [ %.1704.i.i, %B290.loopexit.i.i ]
  %313 = icmp ne i64 %.356.0.i.i, %.1072818825.i
  %brmerge1.i.i = select i1 %313, i1 true, i1 %.93.inv.i.i
  br label %B328.if.i.i

B328.if.i.i:                                      ; preds = %B290.if.i.i, %B1078.i.i
  %lsr.iv275.i.i = phi ptr [ %lsr.iv.i37.i, %B290.if.i.i ], [ %scevgep276.i49.i, %B1078.i.i ]
  %.484.0.i.i = phi i64 [ %.356.0.i.i, %B290.if.i.i ], [ %.553.i.i244, %B1078.i.i ]
  %at.2.1884.i.i = phi i64 [ %at.3.0888.i.i, %B290.if.i.i ], [ %.1704.i.i, %B1078.i.i ]
  %.553.i.i244 = add nuw i64 %.484.0.i.i, 1
  %.596.i.i245 = add nsw i64 %at.2.1884.i.i, %.594.i.i
  %.597.i.i = mul nsw i64 %.591.i.i243, %.596.i.i245
  %"$phi374.2.2.2.i.i" = select i1 %309, i64 %.585.i.i, i64 %.597.i.i
  %.634.i.i = load i64, ptr %sunkaddr12.i36.i, align 8, !noalias !92
  %.635.i.i = shl nsw i64 %"$phi374.2.2.2.i.i", 3
  %.636.i.i246 = add nsw i64 %.635.i.i, %.634.i.i
  %.639.i.i = inttoptr i64 %.636.i.i246 to ptr
  %.805.i.i247 = getelementptr double, ptr %.639.i.i, i64 %.1090933952
  %.873.i.i248 = icmp slt i64 %at.2.1884.i.i, 0
  %.874.i.i = select i1 %.873.i.i248, i64 %.272.i33.i, i64 0
  %.idx57.i.i = shl i64 %at.2.1884.i.i, 4
  %314 = getelementptr i8, ptr %312, i64 %.idx57.i.i
  %.888.i.i = getelementptr double, ptr %314, i64 %.874.i.i
  %.889.i38.i = load double, ptr %.888.i.i, align 8, !noalias !92
  %315 = getelementptr i8, ptr %314, i64 8
  %.921.i.i249 = getelementptr double, ptr %315, i64 %.874.i.i
  %.922.i.i250 = load double, ptr %.921.i.i249, align 8, !noalias !92
  %.951.i.i251 = icmp ne i64 %.484.0.i.i, %.1072818825.i
  %brmerge.i.i = select i1 %.951.i.i251, i1 true, i1 %.93.inv.i.i
  br i1 %brmerge.i.i, label %B836.i.i, label %B174.if.preheader.i.i.i

B174.if.preheader.i.i.i:                          ; preds = %B328.if.i.i
  %.6.i.i.i39.i = insertelement <8 x double> poison, double %.889.i38.i, i64 0
  %.7.i.i.i40.i = shufflevector <8 x double> %.6.i.i.i39.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.6.i97.i.i.i = insertelement <8 x double> poison, double %.922.i.i250, i64 0
  %.7.i98.i.i.i = shufflevector <8 x double> %.6.i97.i.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %scevgep7.i.i = getelementptr i8, ptr %.805.i.i247, i64 %311
  br label %B174.if.i.i.i

B214.i.i.i:                                       ; preds = %B174.if.i.i.i
  %scevgep8.i.i252 = getelementptr i8, ptr %scevgep7.i.i, i64 %lsr.iv133.i.i.i
  %.478.i.i.i = load <8 x double>, ptr %scevgep8.i.i252, align 8, !noalias !95
  br label %B274.i.i.i

B274.i.i.i:                                       ; preds = %B174.if.i.i.i, %B214.i.i.i
  %"$phi274.1.2.1.i.i.i" = phi <8 x double> [ %.478.i.i.i, %B214.i.i.i ], [ zeroinitializer, %B174.if.i.i.i ]
  %.8.i.i.i41.i = fmul contract <8 x double> %.7.i.i.i40.i, %.462.i.i.i
  %.8.i99.i.i.i = fmul contract <8 x double> %.7.i98.i.i.i, %"$phi274.1.2.1.i.i.i"
  %.6.i100.i.i.i = fsub contract <8 x double> %.8.i.i.i41.i, %.8.i99.i.i.i
  %.8.i103.i.i.i = fmul contract <8 x double> %.7.i98.i.i.i, %.462.i.i.i
  %.8.i106.i.i.i = fmul contract <8 x double> %.7.i.i.i40.i, %"$phi274.1.2.1.i.i.i"
  %.6.i107.i.i.i = fadd contract <8 x double> %.8.i103.i.i.i, %.8.i106.i.i.i
  %scevgep269.i.i = getelementptr i8, ptr %lsr.iv.i37.i, i64 %lsr.iv133.i.i.i
  %scevgep270.i.i = getelementptr i8, ptr %scevgep269.i.i, i64 -1024
  %.678.i.i.i = load <8 x double>, ptr %scevgep270.i.i, align 8, !noalias !95
  %.689.i.i42.i = load <8 x double>, ptr %scevgep269.i.i, align 8, !noalias !95
  %sunkaddr.i43.i = getelementptr i8, ptr %.430, i64 %lsr.iv133.i.i.i
  %sunkaddr13.i44.i = getelementptr i8, ptr %sunkaddr.i43.i, i64 6144
  %.700.i.i.i = load <8 x double>, ptr %sunkaddr13.i44.i, align 8, !noalias !95
  %.6.i111.i.i.i = fmul contract <8 x double> %.689.i.i42.i, %.6.i107.i.i.i
  %.725.i.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i100.i.i.i, <8 x double> %.678.i.i.i, <8 x double> %.6.i111.i.i.i)
  %.6.i112.i.i.i = fadd contract <8 x double> %.700.i.i.i, %.725.i.i.i
  store <8 x double> %.6.i112.i.i.i, ptr %sunkaddr13.i44.i, align 8, !noalias !95
  %sunkaddr15.i45.i = getelementptr i8, ptr %sunkaddr.i43.i, i64 7168
  %.771.i.i.i = load <8 x double>, ptr %sunkaddr15.i45.i, align 8, !noalias !95
  %.6.i113.i.i.i = fmul contract <8 x double> %.678.i.i.i, %.6.i107.i.i.i
  %.6.i114.i.i.i = fmul contract <8 x double> %.6.i100.i.i.i, %.689.i.i42.i
  %.6.i115.i.i.i = fsub contract <8 x double> %.6.i113.i.i.i, %.6.i114.i.i.i
  %.6.i116.i.i.i = fadd contract <8 x double> %.6.i115.i.i.i, %.771.i.i.i
  store <8 x double> %.6.i116.i.i.i, ptr %sunkaddr15.i45.i, align 8, !noalias !95
  %lsr.iv.next134.i.i.i = add i64 %lsr.iv133.i.i.i, 64
  %lsr.iv.next.i.i253 = add nsw i64 %lsr.iv2.i.i, -1
  %.411.i.i.i = icmp sgt i64 %lsr.iv2.i.i, 6
  br i1 %.411.i.i.i, label %B174.if.i.i.i, label %B836.i.i

B174.if.i.i.i:                                    ; preds = %B274.i.i.i, %B174.if.preheader.i.i.i
  %lsr.iv2.i.i = phi i64 [ %lsr.iv.next.i.i253, %B274.i.i.i ], [ %238, %B174.if.preheader.i.i.i ]
  %lsr.iv133.i.i.i = phi i64 [ %lsr.iv.next134.i.i.i, %B274.i.i.i ], [ 0, %B174.if.preheader.i.i.i ]
  %scevgep140.i.i.i = getelementptr i8, ptr %.805.i.i247, i64 %lsr.iv133.i.i.i
  %.462.i.i.i = load <8 x double>, ptr %scevgep140.i.i.i, align 8, !noalias !95
  br i1 %309, label %B274.i.i.i, label %B214.i.i.i

B174.if.preheader.i117.i.i:                       ; preds = %B836.i.i
  %.6.i.i118.i.i = insertelement <8 x double> poison, double %.889.i38.i, i64 0
  %.7.i.i119.i.i = shufflevector <8 x double> %.6.i.i118.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %.6.i97.i120.i.i = insertelement <8 x double> poison, double %.922.i.i250, i64 0
  %.7.i98.i121.i.i = shufflevector <8 x double> %.6.i97.i120.i.i, <8 x double> poison, <8 x i32> zeroinitializer
  %scevgep13.i.i254 = getelementptr i8, ptr %.805.i.i247, i64 %311
  br label %B174.if.i122.i.i

B214.i127.i.i:                                    ; preds = %B174.if.i122.i.i
  %scevgep14.i.i256 = getelementptr i8, ptr %scevgep13.i.i254, i64 %lsr.iv133.i123.i.i
  %.478.i129.i.i = load <8 x double>, ptr %scevgep14.i.i256, align 8, !noalias !98
  br label %B274.i130.i.i

B274.i130.i.i:                                    ; preds = %B174.if.i122.i.i, %B214.i127.i.i
  %"$phi274.1.2.1.i131.i.i" = phi <8 x double> [ %.478.i129.i.i, %B214.i127.i.i ], [ zeroinitializer, %B174.if.i122.i.i ]
  %.8.i.i132.i.i = fmul contract <8 x double> %.7.i.i119.i.i, %.462.i126.i.i
  %.8.i99.i133.i.i = fmul contract <8 x double> %.7.i98.i121.i.i, %"$phi274.1.2.1.i131.i.i"
  %.6.i100.i134.i.i = fsub contract <8 x double> %.8.i.i132.i.i, %.8.i99.i133.i.i
  %.8.i103.i135.i.i = fmul contract <8 x double> %.7.i98.i121.i.i, %.462.i126.i.i
  %.8.i106.i136.i.i = fmul contract <8 x double> %.7.i.i119.i.i, %"$phi274.1.2.1.i131.i.i"
  %.6.i107.i137.i.i = fadd contract <8 x double> %.8.i103.i135.i.i, %.8.i106.i136.i.i
  %.8.i110.i.i.i = fneg contract <8 x double> %.6.i107.i137.i.i
  %scevgep278.i.i = getelementptr i8, ptr %lsr.iv275.i.i, i64 %lsr.iv133.i123.i.i
  %scevgep279.i.i = getelementptr i8, ptr %scevgep278.i.i, i64 -1024
  %.678.i139.i.i = load <8 x double>, ptr %scevgep279.i.i, align 8, !noalias !98
  %.689.i141.i.i = load <8 x double>, ptr %scevgep278.i.i, align 8, !noalias !98
  %sunkaddr16.i46.i = getelementptr i8, ptr %.430, i64 %lsr.iv133.i123.i.i
  %sunkaddr17.i47.i = getelementptr i8, ptr %sunkaddr16.i46.i, i64 6144
  %.700.i144.i.i = load <8 x double>, ptr %sunkaddr17.i47.i, align 8, !noalias !98
  %.6.i111.i145.i.i = fmul contract <8 x double> %.689.i141.i.i, %.8.i110.i.i.i
  %.725.i146.i.i = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.6.i100.i134.i.i, <8 x double> %.678.i139.i.i, <8 x double> %.6.i111.i145.i.i)
  %.6.i112.i147.i.i = fadd contract <8 x double> %.700.i144.i.i, %.725.i146.i.i
  store <8 x double> %.6.i112.i147.i.i, ptr %sunkaddr17.i47.i, align 8, !noalias !98
  %sunkaddr19.i48.i = getelementptr i8, ptr %sunkaddr16.i46.i, i64 7168
  %.771.i149.i.i = load <8 x double>, ptr %sunkaddr19.i48.i, align 8, !noalias !98
  %.6.i113.i150.i.i = fmul contract <8 x double> %.678.i139.i.i, %.8.i110.i.i.i
  %.6.i114.i151.i.i = fmul contract <8 x double> %.6.i100.i134.i.i, %.689.i141.i.i
  %.6.i115.i152.i.i = fsub contract <8 x double> %.6.i113.i150.i.i, %.6.i114.i151.i.i
  %.6.i116.i153.i.i = fadd contract <8 x double> %.6.i115.i152.i.i, %.771.i149.i.i
  store <8 x double> %.6.i116.i153.i.i, ptr %sunkaddr19.i48.i, align 8, !noalias !98
  %lsr.iv.next134.i155.i.i = add i64 %lsr.iv133.i123.i.i, 64
  %lsr.iv.next8.i.i257 = add nsw i64 %lsr.iv7.i.i255, -1
  %.411.i156.i.i = icmp sgt i64 %lsr.iv7.i.i255, 6
  br i1 %.411.i156.i.i, label %B174.if.i122.i.i, label %B1078.i.i

B174.if.i122.i.i:                                 ; preds = %B274.i130.i.i, %B174.if.preheader.i117.i.i
  %lsr.iv7.i.i255 = phi i64 [ %lsr.iv.next8.i.i257, %B274.i130.i.i ], [ %238, %B174.if.preheader.i117.i.i ]
  %lsr.iv133.i123.i.i = phi i64 [ %lsr.iv.next134.i155.i.i, %B274.i130.i.i ], [ 0, %B174.if.preheader.i117.i.i ]
  %scevgep140.i125.i.i = getelementptr i8, ptr %.805.i.i247, i64 %lsr.iv133.i123.i.i
  %.462.i126.i.i = load <8 x double>, ptr %scevgep140.i125.i.i, align 8, !noalias !98
  br i1 %309, label %B274.i130.i.i, label %B214.i127.i.i

_ZN17bnserve_inference14adjoint_kernel7_source14_through_pairsB4v324B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i: ; preds = %B290.loopexit.i.i, %_ZN17bnserve_inference14adjoint_kernel7_source16_through_weightsB4v266B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxxx5ArrayIxLi1E1C7mutable7alignedEd5ArrayIdLi1E1C7mutable7alignedE.exit.i
  br i1 %or.cond.i214, label %B1008.i, label %B268.if.i.i

_ZN17bnserve_inference14adjoint_kernel7_source12_in_detectorB4v112B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxx5ArrayIxLi1E1C7mutable7alignedEd5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit: ; preds = %B1100.i, %_ZN17bnserve_inference14adjoint_kernel5_back15errors_to_nodesB4v449B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit.i
  call void @llvm.lifetime.end.p0(ptr nonnull %.747.i)
  call void @llvm.lifetime.end.p0(ptr nonnull %.782.i)
  %.1289 = add nuw nsw i64 %.1282920924, 1
  %scevgep = getelementptr i8, ptr %lsr.iv, i64 152
  %scevgep271 = getelementptr i8, ptr %lsr.iv270, i64 200
  %exitcond.not = icmp eq i64 %.47, %.1289
  br i1 %exitcond.not, label %B1212, label %B1040.if

B1254.endif:                                      ; preds = %B244.if.i, %B1254
  %.1607 = load i64, ptr %sunkaddr136, align 8
  %.1608.not = icmp eq i64 %.1607, 0
  br i1 %.1608.not, label %B1412, label %B1334
}

; Function Attrs: mustprogress nocallback nocreateundeforpoison nofree nosync nounwind speculatable willreturn memory(none)
declare i64 @llvm.smin.i64(i64, i64) #2

; Function Attrs: nofree norecurse nosync nounwind memory(argmem: readwrite)
define internal fastcc void @inner_2(ptr noalias nonnull writeonly captures(none) %retptr, ptr readonly captures(none) %arg.k.4, i64 range(i64 17, 22) %arg.first, double %arg.sign, ptr readonly captures(none) %arg.f.4, i64 range(i64 -9223372036854775808, 129) %arg.f.5.0, i64 range(i64 -9223372036854775808, 129) %arg.size, ptr captures(none) %arg.own.4) unnamed_addr #3 {
entry:
  %0 = getelementptr double, ptr %arg.k.4, i64 %arg.first
  %.77 = load double, ptr %0, align 8
  %1 = getelementptr i8, ptr %0, i64 8
  %.107 = load double, ptr %1, align 8
  %2 = getelementptr i8, ptr %0, i64 16
  %.137 = load double, ptr %2, align 8
  %3 = getelementptr i8, ptr %0, i64 24
  %.167 = load double, ptr %3, align 8
  %.231 = getelementptr i8, ptr %arg.k.4, i64 104
  %.232 = load double, ptr %.231, align 8
  %.260 = getelementptr i8, ptr %arg.k.4, i64 112
  %.261 = load double, ptr %.260, align 8
  %.295 = getelementptr i8, ptr %arg.k.4, i64 120
  %.296 = load double, ptr %.295, align 8
  %.324 = getelementptr i8, ptr %arg.k.4, i64 128
  %.325 = load double, ptr %.324, align 8
  %.354 = getelementptr inbounds nuw i8, ptr %arg.own.4, i64 4096
  %.439 = getelementptr inbounds nuw i8, ptr %arg.own.4, i64 5120
  %.784 = fmul contract double %.137, %.296
  %.800 = fmul contract double %.137, %.325
  %.1629 = getelementptr inbounds nuw i8, ptr %arg.own.4, i64 10240
  %.1774 = getelementptr inbounds nuw i8, ptr %arg.own.4, i64 11264
  %.1919 = getelementptr inbounds nuw i8, ptr %arg.own.4, i64 12288
  %.2067 = getelementptr inbounds nuw i8, ptr %arg.own.4, i64 13312
  %.2241 = getelementptr inbounds nuw i8, ptr %arg.own.4, i64 14336
  %.2386 = getelementptr inbounds nuw i8, ptr %arg.own.4, i64 15360
  %.2531 = getelementptr inbounds nuw i8, ptr %arg.own.4, i64 16384
  %.2679 = getelementptr inbounds nuw i8, ptr %arg.own.4, i64 17408
  %.3453 = getelementptr inbounds nuw i8, ptr %arg.own.4, i64 18432
  %.3598 = getelementptr inbounds nuw i8, ptr %arg.own.4, i64 19456
  %.3743 = getelementptr inbounds nuw i8, ptr %arg.own.4, i64 20480
  %.3891 = getelementptr inbounds nuw i8, ptr %arg.own.4, i64 21504
  %.599191 = icmp sgt i64 %arg.size, 0
  br i1 %.599191, label %B380, label %B5100

B380:                                             ; preds = %entry, %B5099
  %lsr.iv = phi i64 [ %lsr.iv.next, %B5099 ], [ 1, %entry ]
  %.589.sroa.0.0196 = phi i64 [ %.589.sroa.0.0, %B5099 ], [ 0, %entry ]
  %.546.1195.in = phi i64 [ %33, %B5099 ], [ %arg.size, %entry ]
  %.654 = icmp slt i64 %.589.sroa.0.0196, 0
  %.655 = select i1 %.654, i64 128, i64 0
  %4 = getelementptr double, ptr %.354, i64 %.589.sroa.0.0196
  %.669 = getelementptr double, ptr %4, i64 %.655
  %.670 = load double, ptr %.669, align 8
  %.672 = fmul contract double %.77, %.670
  %5 = getelementptr double, ptr %.439, i64 %.589.sroa.0.0196
  %.702 = getelementptr double, ptr %5, i64 %.655
  %.703 = load double, ptr %.702, align 8
  %.705 = fmul contract double %.107, %.703
  %.706 = fsub contract double %.672, %.705
  %.739 = fmul contract double %.107, %.670
  %.772 = fmul contract double %.77, %.703
  %.773 = fadd contract double %.739, %.772
  %.781 = fneg contract double %.773
  %.787 = fmul contract double %.325, %.706
  %.788 = fsub contract double %.784, %.787
  %.797 = fmul contract double %.296, %.706
  %.801 = fadd contract double %.800, %.797
  %.823 = select i1 %.654, i64 %arg.f.5.0, i64 0
  %6 = getelementptr double, ptr %arg.f.4, i64 %.589.sroa.0.0196
  %.837 = getelementptr double, ptr %6, i64 %.823
  %.838 = load double, ptr %.837, align 8
  %.839 = fmul contract double %.838, 0x400921FB54442D18
  %.841 = fmul contract double %.167, %.839
  %.851 = fsub contract double 1.000000e+00, %.801
  %.853 = fmul contract double %.841, %.851
  %.859 = fmul contract double %.853, %.853
  %.959 = fcmp contract olt double %.859, 0x3EB0C6F7A0B5ED8D
  br i1 %.959, label %B1030.endif, label %B4945

B4945:                                            ; preds = %B380
  %.865 = tail call contract double @llvm.fma.f64(double %.853, double 0x3FE45F306DC9C883, double 0x4338000000000000)
  %.914 = bitcast double %.865 to i64
  %.923 = shl i64 %.914, 62
  %.924 = add i64 %.923, 4611686018427387904
  %.925 = and i64 %.924, -9223372036854775808
  %.866 = fadd contract double %.865, 0xC338000000000000
  %.881 = tail call contract double @llvm.fma.f64(double %.866, double 0xBFF921FB54442D18, double %.853)
  %.896 = tail call contract double @llvm.fma.f64(double %.866, double 0xBC91A62633145C07, double %.881)
  %.897 = fmul contract double %.896, %.896
  %.906 = tail call contract double @llvm.fma.f64(double %.897, double 0x3D2AE7F3E733B81F, double 0xBDA93974A8C07C9D)
  %.907 = tail call contract double @llvm.fma.f64(double %.897, double %.906, double 0x3E21EED8EFF8D898)
  %.908 = tail call contract double @llvm.fma.f64(double %.897, double %.907, double 0xBE927E4FB7789F5C)
  %.909 = tail call contract double @llvm.fma.f64(double %.897, double %.908, double 0x3EFA01A01A01A01A)
  %.910 = tail call contract double @llvm.fma.f64(double %.897, double %.909, double 0xBF56C16C16C16C17)
  %.911 = tail call contract double @llvm.fma.f64(double %.897, double %.910, double 0x3FA5555555555555)
  %.912 = tail call contract double @llvm.fma.f64(double %.897, double %.911, double -5.000000e-01)
  %.913 = tail call contract double @llvm.fma.f64(double %.897, double %.912, double 1.000000e+00)
  %.916 = bitcast double %.913 to i64
  %7 = xor i64 %.925, %.916
  %.918 = and i64 %.914, 1
  %8 = icmp eq i64 %.918, 0
  %.904 = fmul contract double %.896, %.897
  %.898 = tail call contract double @llvm.fma.f64(double %.897, double 0xBD6AE7F3E733B81F, double 0x3DE6124613A86D09)
  %.899 = tail call contract double @llvm.fma.f64(double %.897, double %.898, double 0xBE5AE64567F544E4)
  %.900 = tail call contract double @llvm.fma.f64(double %.897, double %.899, double 0x3EC71DE3A556C734)
  %.901 = tail call contract double @llvm.fma.f64(double %.897, double %.900, double 0xBF2A01A01A01A01A)
  %.902 = tail call contract double @llvm.fma.f64(double %.897, double %.901, double 0x3F81111111111111)
  %.903 = tail call contract double @llvm.fma.f64(double %.897, double %.902, double 0xBFC5555555555555)
  %.905 = tail call contract double @llvm.fma.f64(double %.904, double %.903, double %.896)
  %.915 = bitcast double %.905 to i64
  %.917 = xor i64 %.916, %.915
  %.920 = select i1 %8, i64 0, i64 %.917
  %.930 = xor i64 %7, %.920
  %.931 = bitcast i64 %.930 to double
  %.922 = and i64 %.923, -9223372036854775808
  %9 = xor i64 %.922, %.915
  %.927 = xor i64 %9, %.920
  %.928 = bitcast i64 %.927 to double
  %.1012 = fdiv contract double %.928, %.853
  %.1022 = fsub contract double %.931, %.1012
  %.1029 = fdiv contract double %.1022, %.853
  br label %B4983

B4983:                                            ; preds = %B1030.endif, %B4945
  %_transfer_v145__v34call_7.2.sroa.8.1 = phi double [ %.980, %B1030.endif ], [ %.1029, %B4945 ]
  %_transfer_v145__v34call_7.2.sroa.0.1 = phi double [ %.970, %B1030.endif ], [ %.1012, %B4945 ]
  %.1072 = fadd contract double %.801, 1.000000e+00
  %.1074 = fmul contract double %.841, %.1072
  %.1080 = fmul contract double %.1074, %.1074
  %.1180 = fcmp contract olt double %.1080, 0x3EB0C6F7A0B5ED8D
  br i1 %.1180, label %B4984.endif, label %B5061

B5061:                                            ; preds = %B4983
  %.1086 = tail call contract double @llvm.fma.f64(double %.1074, double 0x3FE45F306DC9C883, double 0x4338000000000000)
  %.1135 = bitcast double %.1086 to i64
  %.1144 = shl i64 %.1135, 62
  %.1145 = add i64 %.1144, 4611686018427387904
  %.1146 = and i64 %.1145, -9223372036854775808
  %.1087 = fadd contract double %.1086, 0xC338000000000000
  %.1102 = tail call contract double @llvm.fma.f64(double %.1087, double 0xBFF921FB54442D18, double %.1074)
  %.1117 = tail call contract double @llvm.fma.f64(double %.1087, double 0xBC91A62633145C07, double %.1102)
  %.1118 = fmul contract double %.1117, %.1117
  %.1127 = tail call contract double @llvm.fma.f64(double %.1118, double 0x3D2AE7F3E733B81F, double 0xBDA93974A8C07C9D)
  %.1128 = tail call contract double @llvm.fma.f64(double %.1118, double %.1127, double 0x3E21EED8EFF8D898)
  %.1129 = tail call contract double @llvm.fma.f64(double %.1118, double %.1128, double 0xBE927E4FB7789F5C)
  %.1130 = tail call contract double @llvm.fma.f64(double %.1118, double %.1129, double 0x3EFA01A01A01A01A)
  %.1131 = tail call contract double @llvm.fma.f64(double %.1118, double %.1130, double 0xBF56C16C16C16C17)
  %.1132 = tail call contract double @llvm.fma.f64(double %.1118, double %.1131, double 0x3FA5555555555555)
  %.1133 = tail call contract double @llvm.fma.f64(double %.1118, double %.1132, double -5.000000e-01)
  %.1134 = tail call contract double @llvm.fma.f64(double %.1118, double %.1133, double 1.000000e+00)
  %.1137 = bitcast double %.1134 to i64
  %10 = xor i64 %.1146, %.1137
  %.1139 = and i64 %.1135, 1
  %11 = icmp eq i64 %.1139, 0
  %.1125 = fmul contract double %.1117, %.1118
  %.1119 = tail call contract double @llvm.fma.f64(double %.1118, double 0xBD6AE7F3E733B81F, double 0x3DE6124613A86D09)
  %.1120 = tail call contract double @llvm.fma.f64(double %.1118, double %.1119, double 0xBE5AE64567F544E4)
  %.1121 = tail call contract double @llvm.fma.f64(double %.1118, double %.1120, double 0x3EC71DE3A556C734)
  %.1122 = tail call contract double @llvm.fma.f64(double %.1118, double %.1121, double 0xBF2A01A01A01A01A)
  %.1123 = tail call contract double @llvm.fma.f64(double %.1118, double %.1122, double 0x3F81111111111111)
  %.1124 = tail call contract double @llvm.fma.f64(double %.1118, double %.1123, double 0xBFC5555555555555)
  %.1126 = tail call contract double @llvm.fma.f64(double %.1125, double %.1124, double %.1117)
  %.1136 = bitcast double %.1126 to i64
  %.1138 = xor i64 %.1137, %.1136
  %.1141 = select i1 %11, i64 0, i64 %.1138
  %.1151 = xor i64 %10, %.1141
  %.1152 = bitcast i64 %.1151 to double
  %.1143 = and i64 %.1144, -9223372036854775808
  %12 = xor i64 %.1143, %.1136
  %.1148 = xor i64 %12, %.1141
  %.1149 = bitcast i64 %.1148 to double
  %.1233 = fdiv contract double %.1149, %.1074
  %.1243 = fsub contract double %.1152, %.1233
  %.1250 = fdiv contract double %.1243, %.1074
  br label %B5099

B5099:                                            ; preds = %B4984.endif, %B5061
  %_transfer_v145__v82call_18.2.sroa.8.1 = phi double [ %.1201, %B4984.endif ], [ %.1250, %B5061 ]
  %_transfer_v145__v82call_18.2.sroa.0.1 = phi double [ %.1191, %B4984.endif ], [ %.1233, %B5061 ]
  %.1287 = tail call contract double @llvm.fma.f64(double %.841, double 0x3FE45F306DC9C883, double 0x4338000000000000)
  %.1288 = fadd contract double %.1287, 0xC338000000000000
  %.1303 = tail call contract double @llvm.fma.f64(double %.1288, double 0xBFF921FB54442D18, double %.841)
  %.1318 = tail call contract double @llvm.fma.f64(double %.1288, double 0xBC91A62633145C07, double %.1303)
  %.1319 = fmul contract double %.1318, %.1318
  %.1320 = tail call contract double @llvm.fma.f64(double %.1319, double 0xBD6AE7F3E733B81F, double 0x3DE6124613A86D09)
  %.1321 = tail call contract double @llvm.fma.f64(double %.1319, double %.1320, double 0xBE5AE64567F544E4)
  %.1322 = tail call contract double @llvm.fma.f64(double %.1319, double %.1321, double 0x3EC71DE3A556C734)
  %.1323 = tail call contract double @llvm.fma.f64(double %.1319, double %.1322, double 0xBF2A01A01A01A01A)
  %.1324 = tail call contract double @llvm.fma.f64(double %.1319, double %.1323, double 0x3F81111111111111)
  %.1325 = tail call contract double @llvm.fma.f64(double %.1319, double %.1324, double 0xBFC5555555555555)
  %.1326 = fmul contract double %.1318, %.1319
  %.1327 = tail call contract double @llvm.fma.f64(double %.1326, double %.1325, double %.1318)
  %.1328 = tail call contract double @llvm.fma.f64(double %.1319, double 0x3D2AE7F3E733B81F, double 0xBDA93974A8C07C9D)
  %.1329 = tail call contract double @llvm.fma.f64(double %.1319, double %.1328, double 0x3E21EED8EFF8D898)
  %.1330 = tail call contract double @llvm.fma.f64(double %.1319, double %.1329, double 0xBE927E4FB7789F5C)
  %.1331 = tail call contract double @llvm.fma.f64(double %.1319, double %.1330, double 0x3EFA01A01A01A01A)
  %.1332 = tail call contract double @llvm.fma.f64(double %.1319, double %.1331, double 0xBF56C16C16C16C17)
  %.1333 = tail call contract double @llvm.fma.f64(double %.1319, double %.1332, double 0x3FA5555555555555)
  %.1334 = tail call contract double @llvm.fma.f64(double %.1319, double %.1333, double -5.000000e-01)
  %.1335 = tail call contract double @llvm.fma.f64(double %.1319, double %.1334, double 1.000000e+00)
  %.1336 = bitcast double %.1287 to i64
  %.1337 = bitcast double %.1327 to i64
  %.1338 = bitcast double %.1335 to i64
  %.1339 = xor i64 %.1338, %.1337
  %.1340 = and i64 %.1336, 1
  %13 = icmp eq i64 %.1340, 0
  %.1342 = select i1 %13, i64 0, i64 %.1339
  %.1343 = shl i64 %.1336, 62
  %.1344 = and i64 %.1343, -9223372036854775808
  %.1346 = add i64 %.1343, 4611686018427387904
  %.1347 = and i64 %.1346, -9223372036854775808
  %14 = xor i64 %.1344, %.1337
  %.1349 = xor i64 %14, %.1342
  %.1350 = bitcast i64 %.1349 to double
  %15 = xor i64 %.1347, %.1338
  %.1352 = xor i64 %15, %.1342
  %.1353 = bitcast i64 %.1352 to double
  %.1374 = fmul contract double %.1353, 5.000000e-01
  %.1376 = fadd contract double %_transfer_v145__v34call_7.2.sroa.0.1, %_transfer_v145__v82call_18.2.sroa.0.1
  %.1377 = fmul contract double %.1374, %.1376
  %.1378 = fmul contract double %.1350, 5.000000e-01
  %.1380 = fsub contract double %_transfer_v145__v34call_7.2.sroa.0.1, %_transfer_v145__v82call_18.2.sroa.0.1
  %.1383 = fmul contract double %.1378, %.1380
  %.1386 = fmul contract double %.841, %.1374
  %.1388 = fsub contract double %_transfer_v145__v34call_7.2.sroa.8.1, %_transfer_v145__v82call_18.2.sroa.8.1
  %.1389 = fmul contract double %.1386, %.1388
  %.1392 = fmul contract double %.841, %.1378
  %.1394 = fadd contract double %_transfer_v145__v34call_7.2.sroa.8.1, %_transfer_v145__v82call_18.2.sroa.8.1
  %.1397 = fmul contract double %.1392, %.1394
  %.1402 = fmul contract double %.841, %.801
  %.1405 = tail call contract double @llvm.fma.f64(double %.1402, double 0x3FE45F306DC9C883, double 0x4338000000000000)
  %.1406 = fadd contract double %.1405, 0xC338000000000000
  %.1421 = tail call contract double @llvm.fma.f64(double %.1406, double 0xBFF921FB54442D18, double %.1402)
  %.1436 = tail call contract double @llvm.fma.f64(double %.1406, double 0xBC91A62633145C07, double %.1421)
  %.1437 = fmul contract double %.1436, %.1436
  %.1438 = tail call contract double @llvm.fma.f64(double %.1437, double 0xBD6AE7F3E733B81F, double 0x3DE6124613A86D09)
  %.1439 = tail call contract double @llvm.fma.f64(double %.1437, double %.1438, double 0xBE5AE64567F544E4)
  %.1440 = tail call contract double @llvm.fma.f64(double %.1437, double %.1439, double 0x3EC71DE3A556C734)
  %.1441 = tail call contract double @llvm.fma.f64(double %.1437, double %.1440, double 0xBF2A01A01A01A01A)
  %.1442 = tail call contract double @llvm.fma.f64(double %.1437, double %.1441, double 0x3F81111111111111)
  %.1443 = tail call contract double @llvm.fma.f64(double %.1437, double %.1442, double 0xBFC5555555555555)
  %.1444 = fmul contract double %.1436, %.1437
  %.1445 = tail call contract double @llvm.fma.f64(double %.1444, double %.1443, double %.1436)
  %.1446 = tail call contract double @llvm.fma.f64(double %.1437, double 0x3D2AE7F3E733B81F, double 0xBDA93974A8C07C9D)
  %.1447 = tail call contract double @llvm.fma.f64(double %.1437, double %.1446, double 0x3E21EED8EFF8D898)
  %.1448 = tail call contract double @llvm.fma.f64(double %.1437, double %.1447, double 0xBE927E4FB7789F5C)
  %.1449 = tail call contract double @llvm.fma.f64(double %.1437, double %.1448, double 0x3EFA01A01A01A01A)
  %.1450 = tail call contract double @llvm.fma.f64(double %.1437, double %.1449, double 0xBF56C16C16C16C17)
  %.1451 = tail call contract double @llvm.fma.f64(double %.1437, double %.1450, double 0x3FA5555555555555)
  %.1452 = tail call contract double @llvm.fma.f64(double %.1437, double %.1451, double -5.000000e-01)
  %.1453 = tail call contract double @llvm.fma.f64(double %.1437, double %.1452, double 1.000000e+00)
  %.1454 = bitcast double %.1405 to i64
  %.1455 = bitcast double %.1445 to i64
  %.1456 = bitcast double %.1453 to i64
  %.1457 = xor i64 %.1456, %.1455
  %.1458 = and i64 %.1454, 1
  %16 = icmp eq i64 %.1458, 0
  %.1460 = select i1 %16, i64 0, i64 %.1457
  %.1461 = shl i64 %.1454, 62
  %.1462 = and i64 %.1461, -9223372036854775808
  %.1464 = add i64 %.1461, 4611686018427387904
  %.1465 = and i64 %.1464, -9223372036854775808
  %17 = xor i64 %.1462, %.1455
  %.1467 = xor i64 %17, %.1460
  %.1468 = bitcast i64 %.1467 to double
  %18 = xor i64 %.1465, %.1456
  %.1470 = xor i64 %18, %.1460
  %.1471 = bitcast i64 %.1470 to double
  %.1492 = fmul contract double %.1377, %.1471
  %.1493 = fmul contract double %.1383, %.1468
  %.1494 = fsub contract double %.1492, %.1493
  %.1495 = fmul contract double %.1377, %.1468
  %.1496 = fmul contract double %.1383, %.1471
  %.1497 = fadd contract double %.1495, %.1496
  %.1498 = fmul contract double %.1389, %.1471
  %.1499 = fmul contract double %.1397, %.1468
  %.1500 = fsub contract double %.1498, %.1499
  %.1502 = fmul contract double %.841, %.1497
  %.1503 = fadd contract double %.1500, %.1502
  %.1504 = fmul contract double %.1389, %.1468
  %.1505 = fmul contract double %.1397, %.1471
  %.1506 = fadd contract double %.1504, %.1505
  %.1508 = fmul contract double %.841, %.1494
  %.1511 = fsub contract double %.1506, %.1508
  %.1554 = fmul contract double %.773, %.773
  %.1557 = fmul contract double %.788, %.788
  %.1558 = fsub contract double %.1554, %.1557
  %.1559 = fmul contract double %.1558, 5.000000e-01
  %.1562 = fmul contract double %.788, %.781
  %.1564 = fmul contract double %arg.sign, %.1494
  %.1566 = fmul contract double %arg.sign, %.1497
  %.1568 = fmul contract double %arg.sign, %.1503
  %.1570 = fmul contract double %arg.sign, %.1511
  %.1603 = fmul contract double %.232, %.1559
  %.1604 = fmul contract double %.261, %.1562
  %.1605 = fadd contract double %.1604, %.1603
  %.1606 = fmul contract double %.232, %.1562
  %.1607 = fmul contract double %.261, %.1559
  %.1608 = fsub contract double %.1606, %.1607
  %19 = getelementptr double, ptr %.1629, i64 %.589.sroa.0.0196
  %.1719 = getelementptr double, ptr %19, i64 %.655
  %.1720 = load double, ptr %.1719, align 8
  %.1721 = fmul contract double %.1605, %.1564
  %.1722 = fadd contract double %.1720, %.1721
  store double %.1722, ptr %.1719, align 8
  %20 = getelementptr double, ptr %.1774, i64 %.589.sroa.0.0196
  %.1864 = getelementptr double, ptr %20, i64 %.655
  %.1865 = load double, ptr %.1864, align 8
  %.1866 = fmul contract double %.1605, %.1566
  %.1867 = fadd contract double %.1865, %.1866
  store double %.1867, ptr %.1864, align 8
  %21 = getelementptr double, ptr %.1919, i64 %.589.sroa.0.0196
  %.2009 = getelementptr double, ptr %21, i64 %.655
  %.2010 = load double, ptr %.2009, align 8
  %.2011 = fmul contract double %.1608, %.1564
  %.2012 = fadd contract double %.2010, %.2011
  store double %.2012, ptr %.2009, align 8
  %22 = getelementptr double, ptr %.2067, i64 %.589.sroa.0.0196
  %.2157 = getelementptr double, ptr %22, i64 %.655
  %.2158 = load double, ptr %.2157, align 8
  %.2159 = fmul contract double %.1608, %.1566
  %.2160 = fadd contract double %.2159, %.2158
  store double %.2160, ptr %.2157, align 8
  %.2199 = fmul contract double %.325, %.773
  %.2202 = fmul contract double %.296, %.773
  %.2206 = fmul contract double %.2202, %.1568
  %.2207 = fmul contract double %.2202, %.1570
  %23 = getelementptr double, ptr %.2241, i64 %.589.sroa.0.0196
  %.2331 = getelementptr double, ptr %23, i64 %.655
  %.2332 = load double, ptr %.2331, align 8
  %.2333 = fmul contract double %.1605, %.2206
  %.2334 = fadd contract double %.2333, %.2332
  store double %.2334, ptr %.2331, align 8
  %24 = getelementptr double, ptr %.2386, i64 %.589.sroa.0.0196
  %.2476 = getelementptr double, ptr %24, i64 %.655
  %.2477 = load double, ptr %.2476, align 8
  %.2478 = fmul contract double %.1605, %.2207
  %.2479 = fadd contract double %.2478, %.2477
  store double %.2479, ptr %.2476, align 8
  %25 = getelementptr double, ptr %.2531, i64 %.589.sroa.0.0196
  %.2621 = getelementptr double, ptr %25, i64 %.655
  %.2622 = load double, ptr %.2621, align 8
  %.2623 = fmul contract double %.1608, %.2206
  %.2624 = fadd contract double %.2623, %.2622
  store double %.2624, ptr %.2621, align 8
  %26 = getelementptr double, ptr %.2679, i64 %.589.sroa.0.0196
  %.2769 = getelementptr double, ptr %26, i64 %.655
  %.2770 = load double, ptr %.2769, align 8
  %.2771 = fmul contract double %.1608, %.2207
  %.2772 = fadd contract double %.2771, %.2770
  store double %.2772, ptr %.2769, align 8
  %.2807 = fmul contract double %.773, %.706
  %.2809 = fmul contract double %.2199, %.788
  %.2810 = fsub contract double %.2807, %.2809
  %.2814 = fmul contract double %.2199, %.781
  %27 = fmul contract double %.706, %.788
  %.2815 = fsub contract double %.2814, %27
  %.2823 = fmul contract double %.232, %.2810
  %.2824 = fmul contract double %.261, %.2815
  %.2825 = fadd contract double %.2823, %.2824
  %.2826 = fmul contract double %.232, %.2815
  %.2827 = fmul contract double %.261, %.2810
  %.2828 = fsub contract double %.2826, %.2827
  %.2941 = fmul contract double %.2825, %.1564
  %.2942 = fadd contract double %.2941, %.2334
  store double %.2942, ptr %.2331, align 8
  %.3086 = fmul contract double %.2825, %.1566
  %.3087 = fadd contract double %.3086, %.2479
  store double %.3087, ptr %.2476, align 8
  %.3231 = fmul contract double %.2828, %.1564
  %.3232 = fadd contract double %.3231, %.2624
  store double %.3232, ptr %.2621, align 8
  %.3379 = fmul contract double %.2828, %.1566
  %.3380 = fadd contract double %.3379, %.2772
  store double %.3380, ptr %.2769, align 8
  %.3414 = fneg contract double %.1568
  %.3416 = fmul contract double %.788, %.3414
  %.3417 = fneg contract double %.1570
  %.3419 = fmul contract double %.788, %.3417
  %28 = getelementptr double, ptr %.3453, i64 %.589.sroa.0.0196
  %.3543 = getelementptr double, ptr %28, i64 %.655
  %.3544 = load double, ptr %.3543, align 8
  %.3545 = fmul contract double %.1605, %.3416
  %.3546 = fadd contract double %.3545, %.3544
  store double %.3546, ptr %.3543, align 8
  %29 = getelementptr double, ptr %.3598, i64 %.589.sroa.0.0196
  %.3688 = getelementptr double, ptr %29, i64 %.655
  %.3689 = load double, ptr %.3688, align 8
  %.3690 = fmul contract double %.1605, %.3419
  %.3691 = fadd contract double %.3690, %.3689
  store double %.3691, ptr %.3688, align 8
  %30 = getelementptr double, ptr %.3743, i64 %.589.sroa.0.0196
  %.3833 = getelementptr double, ptr %30, i64 %.655
  %.3834 = load double, ptr %.3833, align 8
  %.3835 = fmul contract double %.1608, %.3416
  %.3836 = fadd contract double %.3835, %.3834
  store double %.3836, ptr %.3833, align 8
  %31 = getelementptr double, ptr %.3891, i64 %.589.sroa.0.0196
  %.3981 = getelementptr double, ptr %31, i64 %.655
  %.3982 = load double, ptr %.3981, align 8
  %.3983 = fmul contract double %.1608, %.3419
  %.3984 = fadd contract double %.3983, %.3982
  store double %.3984, ptr %.3981, align 8
  %.4023 = fmul contract double %.788, %.801
  %.4026 = fmul contract double %.773, %.801
  %.4040 = fmul contract double %.232, %.4023
  %.4041 = fmul contract double %.261, %.4026
  %.4042 = fadd contract double %.4040, %.4041
  %.4043 = fmul contract double %.232, %.4026
  %.4044 = fmul contract double %.261, %.4023
  %.4045 = fsub contract double %.4043, %.4044
  %.4158 = fmul contract double %.4042, %.1564
  %.4159 = fadd contract double %.4158, %.3546
  store double %.4159, ptr %.3543, align 8
  %.4303 = fmul contract double %.4042, %.1566
  %.4304 = fadd contract double %.4303, %.3691
  store double %.4304, ptr %.3688, align 8
  %.4448 = fmul contract double %.4045, %.1564
  %.4449 = fadd contract double %.4448, %.3836
  store double %.4449, ptr %.3833, align 8
  %.4596 = fmul contract double %.4045, %.1566
  %.4597 = fadd contract double %.4596, %.3984
  store double %.4597, ptr %.3981, align 8
  %.599 = icmp sgt i64 %.546.1195.in, 1
  %32 = tail call i64 @llvm.smax.i64(i64 %.546.1195.in, i64 2)
  %33 = add nsw i64 %32, -1
  %.589.sroa.0.0 = select i1 %.599, i64 %lsr.iv, i64 0
  %lsr.iv.next = add i64 %lsr.iv, 1
  br i1 %.599, label %B380, label %B5100

B5100:                                            ; preds = %B5099, %entry
  store ptr null, ptr %retptr, align 8
  ret void

B1030.endif:                                      ; preds = %B380
  %.969 = fdiv contract double %.859, 6.000000e+00
  %.970 = fsub contract double 1.000000e+00, %.969
  %.975 = fdiv contract double %.859, 3.000000e+01
  %.978 = fadd contract double %.975, 0xBFD5555555555555
  %.980 = fmul contract double %.853, %.978
  br label %B4983

B4984.endif:                                      ; preds = %B4983
  %.1190 = fdiv contract double %.1080, 6.000000e+00
  %.1191 = fsub contract double 1.000000e+00, %.1190
  %.1196 = fdiv contract double %.1080, 3.000000e+01
  %.1199 = fadd contract double %.1196, 0xBFD5555555555555
  %.1201 = fmul contract double %.1074, %.1199
  br label %B5099
}

; Function Attrs: mustprogress nocallback nocreateundeforpoison nofree nosync nounwind speculatable willreturn memory(none)
declare <8 x double> @llvm.fma.v8f64(<8 x double>, <8 x double>, <8 x double>) #2

; Function Attrs: mustprogress nocallback nocreateundeforpoison nofree nosync nounwind speculatable willreturn memory(none)
declare i64 @llvm.smax.i64(i64, i64) #2

; Function Attrs: mustprogress nocallback nocreateundeforpoison nofree nosync nounwind speculatable willreturn memory(none)
declare double @llvm.floor.f64(double) #2

; Function Attrs: nofree norecurse nosync nounwind memory(argmem: readwrite)
define internal fastcc void @inner_1(ptr noalias nonnull writeonly captures(none) %retptr, ptr readonly captures(none) %arg.a.4, i64 range(i64 -9223372036854775808, 9223372036854775807) %arg.a.5.0, ptr readonly captures(none) %arg.b.4, i64 range(i64 -9223372036854775808, 9223372036854775807) %arg.b.5.0, i64 range(i64 -9223372036854775808, 9223372036854775807) %arg.size, ptr captures(none) %arg.lanes.4) unnamed_addr #3 {
entry:
  %.95 = and i64 %arg.size, -8
  %0 = tail call i64 @llvm.smax.i64(i64 %arg.size, i64 7)
  %storemerge = lshr i64 %0, 3
  %.181288.not = icmp eq i64 %storemerge, 0
  br i1 %.181288.not, label %B210, label %B114.if.preheader

B114.if.preheader:                                ; preds = %entry
  %1 = add nuw nsw i64 %storemerge, 5
  br label %B114.if

B210:                                             ; preds = %B114.if, %entry
  %total.2.0.lcssa = phi <8 x double> [ zeroinitializer, %entry ], [ %.240, %B114.if ]
  %.293 = and i64 %arg.size, 7
  %.336296.not = icmp eq i64 %.293, 0
  br i1 %.336296.not, label %B292, label %B246.if

B292:                                             ; preds = %B246.if.6, %B246.if.5, %B246.if.4, %B246.if.3, %B246.if.2, %B246.if.1, %B246.if, %B210
  %rest.2.0.lcssa = phi double [ 0.000000e+00, %B210 ], [ %.436, %B246.if ], [ %.436.1, %B246.if.1 ], [ %.436.2, %B246.if.2 ], [ %.436.3, %B246.if.3 ], [ %.436.4, %B246.if.4 ], [ %.436.5, %B246.if.5 ], [ %.436.6, %B246.if.6 ]
  store <8 x double> %total.2.0.lcssa, ptr %arg.lanes.4, align 8
  %.504 = load double, ptr %arg.lanes.4, align 8
  %.532 = getelementptr i8, ptr %arg.lanes.4, i64 8
  %.533 = load double, ptr %.532, align 8
  %.534 = fadd contract double %.504, %.533
  %.562 = getelementptr i8, ptr %arg.lanes.4, i64 16
  %.563 = load double, ptr %.562, align 8
  %.591 = getelementptr i8, ptr %arg.lanes.4, i64 24
  %.592 = load double, ptr %.591, align 8
  %.593 = fadd contract double %.563, %.592
  %.594 = fadd contract double %.534, %.593
  %.622 = getelementptr i8, ptr %arg.lanes.4, i64 32
  %.623 = load double, ptr %.622, align 8
  %.651 = getelementptr i8, ptr %arg.lanes.4, i64 40
  %.652 = load double, ptr %.651, align 8
  %.653 = fadd contract double %.623, %.652
  %.681 = getelementptr i8, ptr %arg.lanes.4, i64 48
  %.682 = load double, ptr %.681, align 8
  %.710 = getelementptr i8, ptr %arg.lanes.4, i64 56
  %.711 = load double, ptr %.710, align 8
  %.715 = fadd contract double %.682, %.711
  %.716 = fadd contract double %.653, %.715
  %.717 = fadd contract double %.594, %.716
  %.719 = fadd contract double %rest.2.0.lcssa, %.717
  store double %.719, ptr %retptr, align 8
  ret void

B114.if:                                          ; preds = %B114.if, %B114.if.preheader
  %lsr.iv = phi i64 [ %lsr.iv.next, %B114.if ], [ %1, %B114.if.preheader ]
  %lsr.iv1 = phi i64 [ %lsr.iv.next2, %B114.if ], [ 0, %B114.if.preheader ]
  %total.2.0291 = phi <8 x double> [ %.240, %B114.if ], [ zeroinitializer, %B114.if.preheader ]
  %scevgep3 = getelementptr i8, ptr %arg.a.4, i64 %lsr.iv1
  %.228 = load <8 x double>, ptr %scevgep3, align 8
  %scevgep = getelementptr i8, ptr %arg.b.4, i64 %lsr.iv1
  %.238 = load <8 x double>, ptr %scevgep, align 8
  %.240 = tail call <8 x double> @llvm.fma.v8f64(<8 x double> %.228, <8 x double> %.238, <8 x double> %total.2.0291)
  %lsr.iv.next2 = add nuw i64 %lsr.iv1, 64
  %lsr.iv.next = add nsw i64 %lsr.iv, -1
  %.181 = icmp sgt i64 %lsr.iv, 6
  br i1 %.181, label %B114.if, label %B210

B246.if:                                          ; preds = %B210
  %.387 = icmp slt i64 %arg.size, 0
  %.388 = select i1 %.387, i64 %arg.a.5.0, i64 0
  %2 = getelementptr double, ptr %arg.a.4, i64 %.95
  %.402 = getelementptr double, ptr %2, i64 %.388
  %.403 = load double, ptr %.402, align 8
  %.418 = select i1 %.387, i64 %arg.b.5.0, i64 0
  %3 = getelementptr double, ptr %arg.b.4, i64 %.95
  %.432 = getelementptr double, ptr %3, i64 %.418
  %.433 = load double, ptr %.432, align 8
  %.434 = fmul contract double %.403, %.433
  %.436 = fadd contract double %.434, 0.000000e+00
  %.336.not = icmp eq i64 %.293, 1
  br i1 %.336.not, label %B292, label %B246.if.1

B246.if.1:                                        ; preds = %B246.if
  %.349 = or disjoint i64 %.95, 1
  %4 = getelementptr double, ptr %arg.a.4, i64 %.349
  %.402.1 = getelementptr double, ptr %4, i64 %.388
  %.403.1 = load double, ptr %.402.1, align 8
  %5 = getelementptr double, ptr %arg.b.4, i64 %.349
  %.432.1 = getelementptr double, ptr %5, i64 %.418
  %.433.1 = load double, ptr %.432.1, align 8
  %.434.1 = fmul contract double %.403.1, %.433.1
  %.436.1 = fadd contract double %.436, %.434.1
  %.336.1 = icmp samesign ugt i64 %.293, 2
  br i1 %.336.1, label %B246.if.2, label %B292

B246.if.2:                                        ; preds = %B246.if.1
  %.349.1 = or disjoint i64 %.95, 2
  %6 = getelementptr double, ptr %arg.a.4, i64 %.349.1
  %.402.2 = getelementptr double, ptr %6, i64 %.388
  %.403.2 = load double, ptr %.402.2, align 8
  %7 = getelementptr double, ptr %arg.b.4, i64 %.349.1
  %.432.2 = getelementptr double, ptr %7, i64 %.418
  %.433.2 = load double, ptr %.432.2, align 8
  %.434.2 = fmul contract double %.403.2, %.433.2
  %.436.2 = fadd contract double %.436.1, %.434.2
  %.336.2.not = icmp eq i64 %.293, 3
  br i1 %.336.2.not, label %B292, label %B246.if.3

B246.if.3:                                        ; preds = %B246.if.2
  %.349.2 = or disjoint i64 %.95, 3
  %8 = getelementptr double, ptr %arg.a.4, i64 %.349.2
  %.402.3 = getelementptr double, ptr %8, i64 %.388
  %.403.3 = load double, ptr %.402.3, align 8
  %9 = getelementptr double, ptr %arg.b.4, i64 %.349.2
  %.432.3 = getelementptr double, ptr %9, i64 %.418
  %.433.3 = load double, ptr %.432.3, align 8
  %.434.3 = fmul contract double %.403.3, %.433.3
  %.436.3 = fadd contract double %.436.2, %.434.3
  %.336.3 = icmp samesign ugt i64 %.293, 4
  br i1 %.336.3, label %B246.if.4, label %B292

B246.if.4:                                        ; preds = %B246.if.3
  %.349.3 = or disjoint i64 %.95, 4
  %10 = getelementptr double, ptr %arg.a.4, i64 %.349.3
  %.402.4 = getelementptr double, ptr %10, i64 %.388
  %.403.4 = load double, ptr %.402.4, align 8
  %11 = getelementptr double, ptr %arg.b.4, i64 %.349.3
  %.432.4 = getelementptr double, ptr %11, i64 %.418
  %.433.4 = load double, ptr %.432.4, align 8
  %.434.4 = fmul contract double %.403.4, %.433.4
  %.436.4 = fadd contract double %.436.3, %.434.4
  %.336.4.not = icmp eq i64 %.293, 5
  br i1 %.336.4.not, label %B292, label %B246.if.5

B246.if.5:                                        ; preds = %B246.if.4
  %.349.4 = or disjoint i64 %.95, 5
  %12 = getelementptr double, ptr %arg.a.4, i64 %.349.4
  %.402.5 = getelementptr double, ptr %12, i64 %.388
  %.403.5 = load double, ptr %.402.5, align 8
  %13 = getelementptr double, ptr %arg.b.4, i64 %.349.4
  %.432.5 = getelementptr double, ptr %13, i64 %.418
  %.433.5 = load double, ptr %.432.5, align 8
  %.434.5 = fmul contract double %.403.5, %.433.5
  %.436.5 = fadd contract double %.436.4, %.434.5
  %.336.5 = icmp eq i64 %.293, 7
  br i1 %.336.5, label %B246.if.6, label %B292

B246.if.6:                                        ; preds = %B246.if.5
  %.349.5 = or disjoint i64 %.95, 6
  %14 = getelementptr double, ptr %arg.a.4, i64 %.349.5
  %.402.6 = getelementptr double, ptr %14, i64 %.388
  %.403.6 = load double, ptr %.402.6, align 8
  %15 = getelementptr double, ptr %arg.b.4, i64 %.349.5
  %.432.6 = getelementptr double, ptr %15, i64 %.418
  %.433.6 = load double, ptr %.432.6, align 8
  %.434.6 = fmul contract double %.403.6, %.433.6
  %.436.6 = fadd contract double %.436.5, %.434.6
  br label %B292
}

; Function Attrs: mustprogress nocallback nocreateundeforpoison nofree nosync nounwind speculatable willreturn memory(none)
declare double @llvm.fma.f64(double, double, double) #2

; Function Attrs: mustprogress nocallback nocreateundeforpoison nofree nosync nounwind speculatable willreturn memory(none)
declare double @llvm.sqrt.f64(double) #2

; Function Attrs: mustprogress nocallback nofree nosync nounwind willreturn memory(none)
declare double @sqrt(double) local_unnamed_addr #4

; Function Attrs: mustprogress nocallback nocreateundeforpoison nofree nosync nounwind speculatable willreturn memory(none)
declare double @llvm.fabs.f64(double) #2

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

!0 = !{!1}
!1 = distinct !{!1, !2, !"_ZN17bnserve_inference14adjoint_kernel7_source11_block_backB4v460B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!2 = distinct !{!2, !"_ZN17bnserve_inference14adjoint_kernel7_source11_block_backB4v460B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!3 = !{!4, !1}
!4 = distinct !{!4, !5, !"_ZN17bnserve_inference14adjoint_kernel5_back10waves_backB4v472B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!5 = distinct !{!5, !"_ZN17bnserve_inference14adjoint_kernel5_back10waves_backB4v472B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE"}
!6 = !{!7}
!7 = distinct !{!7, !8, !"_ZN17bnserve_inference14adjoint_kernel7_source9_sky_backB4v485B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!8 = distinct !{!8, !"_ZN17bnserve_inference14adjoint_kernel7_source9_sky_backB4v485B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!9 = !{!10}
!10 = distinct !{!10, !11, !"_ZN17bnserve_inference14adjoint_kernel8_passing12passing_backB4v490B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!11 = distinct !{!11, !"_ZN17bnserve_inference14adjoint_kernel8_passing12passing_backB4v490B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!12 = !{!13, !10}
!13 = distinct !{!13, !14, !"_ZN17bnserve_inference14adjoint_kernel8_passing10_turn_backB4v501B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedExx8UniTupleIdLi3EE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!14 = distinct !{!14, !"_ZN17bnserve_inference14adjoint_kernel8_passing10_turn_backB4v501B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi1E1C7mutable7alignedExx8UniTupleIdLi3EE5ArrayIdLi1E1C7mutable7alignedE"}
!15 = !{!16}
!16 = distinct !{!16, !17, !"_ZN17bnserve_inference14adjoint_kernel5_back11binary_backB4v506B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!17 = distinct !{!17, !"_ZN17bnserve_inference14adjoint_kernel5_back11binary_backB4v506B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!18 = !{!19}
!19 = distinct !{!19, !20, !"_ZN17bnserve_inference14adjoint_kernel7_source6_placeB3v16B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!20 = distinct !{!20, !"_ZN17bnserve_inference14adjoint_kernel7_source6_placeB3v16B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!21 = !{!22, !19}
!22 = distinct !{!22, !23, !"_ZN17bnserve_inference13moving_kernel9_response12coefficientsB3v24B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!23 = distinct !{!23, !"_ZN17bnserve_inference13moving_kernel9_response12coefficientsB3v24B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!24 = !{!25, !19}
!25 = distinct !{!25, !26, !"_ZN17bnserve_inference14adjoint_kernel9_response13fill_geometryB3v43B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!26 = distinct !{!26, !"_ZN17bnserve_inference14adjoint_kernel9_response13fill_geometryB3v43B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!27 = !{!28}
!28 = distinct !{!28, !29, !"_ZN17bnserve_inference13moving_kernel8_passing12find_passingB3v59B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIxLi1E1C7mutable7alignedE: %retptr"}
!29 = distinct !{!29, !"_ZN17bnserve_inference13moving_kernel8_passing12find_passingB3v59B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIxLi1E1C7mutable7alignedE"}
!30 = distinct !{!30, !31}
!31 = !{!"llvm.loop.unroll.disable"}
!32 = !{!33, !28}
!33 = distinct !{!33, !34, !"_ZN17bnserve_inference13moving_kernel8_passing6_turnsB3v74B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedExx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!34 = distinct !{!34, !"_ZN17bnserve_inference13moving_kernel8_passing6_turnsB3v74B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedExx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!35 = distinct !{!35, !31}
!36 = !{!37}
!37 = distinct !{!37, !38, !"_ZN17bnserve_inference14adjoint_kernel7_source9_polariseB3v77B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!38 = distinct !{!38, !"_ZN17bnserve_inference14adjoint_kernel7_source9_polariseB3v77B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!39 = !{!40, !37}
!40 = distinct !{!40, !41, !"_ZN17bnserve_inference12modes_kernel7_source9_add_modeB4v111B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedExxdd5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!41 = distinct !{!41, !"_ZN17bnserve_inference12modes_kernel7_source9_add_modeB4v111B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedExxdd5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!42 = !{!43, !37}
!43 = distinct !{!43, !44, !"_ZN17bnserve_inference12modes_kernel7_source9_add_modeB4v111B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedExxdd5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!44 = distinct !{!44, !"_ZN17bnserve_inference12modes_kernel7_source9_add_modeB4v111B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedExxdd5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!45 = !{!46}
!46 = distinct !{!46, !47, !"_ZN17bnserve_inference14adjoint_kernel7_source12_in_detectorB4v112B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxx5ArrayIxLi1E1C7mutable7alignedEd5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!47 = distinct !{!47, !"_ZN17bnserve_inference14adjoint_kernel7_source12_in_detectorB4v112B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxx5ArrayIxLi1E1C7mutable7alignedEd5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!48 = !{!49, !46}
!49 = distinct !{!49, !50, !"_ZN17bnserve_inference14adjoint_kernel7_source10_calibrateB4v123B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!50 = distinct !{!50, !"_ZN17bnserve_inference14adjoint_kernel7_source10_calibrateB4v123B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!51 = !{!52, !49, !46}
!52 = distinct !{!52, !53, !"_ZN17bnserve_inference6kernel5_sums9errors_atB4v138B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedExx5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!53 = distinct !{!53, !"_ZN17bnserve_inference6kernel5_sums9errors_atB4v138B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedExx5ArrayIdLi1E1C7mutable7alignedE"}
!54 = !{!"branch_weights", i32 1, i32 99}
!55 = !{!"branch_weights", i32 99, i32 1}
!56 = !{!57, !49, !46}
!57 = distinct !{!57, !58, !"_ZN17bnserve_inference6kernel5_sums9errors_atB4v138B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedExx5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!58 = distinct !{!58, !"_ZN17bnserve_inference6kernel5_sums9errors_atB4v138B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedExx5ArrayIdLi1E1C7mutable7alignedE"}
!59 = !{!60, !46}
!60 = distinct !{!60, !61, !"_ZN17bnserve_inference14adjoint_kernel9_response14clear_patternsB4v141B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!61 = distinct !{!61, !"_ZN17bnserve_inference14adjoint_kernel9_response14clear_patternsB4v141B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE"}
!62 = !{!63, !46}
!63 = distinct !{!63, !64, !"_ZN17bnserve_inference14adjoint_kernel9_response14short_patternsB4v201B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!64 = distinct !{!64, !"_ZN17bnserve_inference14adjoint_kernel9_response14short_patternsB4v201B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE"}
!65 = !{!66, !46}
!66 = distinct !{!66, !67, !"_ZN17bnserve_inference14adjoint_kernel5_sums7respondB4v227B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedEddxx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!67 = distinct !{!67, !"_ZN17bnserve_inference14adjoint_kernel5_sums7respondB4v227B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedEddxx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!68 = !{!69, !46}
!69 = distinct !{!69, !70, !"_ZN17bnserve_inference14adjoint_kernel5_back11errors_backB4v349B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!70 = distinct !{!70, !"_ZN17bnserve_inference14adjoint_kernel5_back11errors_backB4v349B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!71 = !{!72, !46}
!72 = distinct !{!72, !73, !"_ZN17bnserve_inference14adjoint_kernel5_back9pull_backB4v367B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!73 = distinct !{!73, !"_ZN17bnserve_inference14adjoint_kernel5_back9pull_backB4v367B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!74 = !{!75, !46}
!75 = distinct !{!75, !76, !"_ZN17bnserve_inference14adjoint_kernel5_back15errors_to_nodesB4v449B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!76 = distinct !{!76, !"_ZN17bnserve_inference14adjoint_kernel5_back15errors_to_nodesB4v449B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!77 = !{!78, !46}
!78 = distinct !{!78, !79, !"_ZN17bnserve_inference14adjoint_kernel7_source16_through_weightsB4v266B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxxx5ArrayIxLi1E1C7mutable7alignedEd5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!79 = distinct !{!79, !"_ZN17bnserve_inference14adjoint_kernel7_source16_through_weightsB4v266B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxxx5ArrayIxLi1E1C7mutable7alignedEd5ArrayIdLi1E1C7mutable7alignedE"}
!80 = !{!81, !78, !46}
!81 = distinct !{!81, !82, !"_ZN17bnserve_inference6kernel5_sums9spline_atB4v300B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dEd5ArrayIdLi1E1C7mutable7alignedExxx: %retptr"}
!82 = distinct !{!82, !"_ZN17bnserve_inference6kernel5_sums9spline_atB4v300B86c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAgXrKFt1X1erJ_2bXklRYnJJeq1msDALYIZgpSqwCKaAA_3d_3dEd5ArrayIdLi1E1C7mutable7alignedExxx"}
!83 = !{!84, !78, !46}
!84 = distinct !{!84, !85, !"_ZN17bnserve_inference14adjoint_kernel7_source10_fill_barsB4v277B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!85 = distinct !{!85, !"_ZN17bnserve_inference14adjoint_kernel7_source10_fill_barsB4v277B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!86 = !{!87, !78, !46}
!87 = distinct !{!87, !88, !"_ZN17bnserve_inference14adjoint_kernel5_sums9add_fixedB4v284B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedEd5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!88 = distinct !{!88, !"_ZN17bnserve_inference14adjoint_kernel5_sums9add_fixedB4v284B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedEd5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE"}
!89 = !{!90, !78, !46}
!90 = distinct !{!90, !91, !"_ZN17bnserve_inference14adjoint_kernel5_sums11add_splinedB4v303B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedEd5ArrayIdLi1E1C7mutable7alignedE8UniTupleIxLi3EE8UniTupleIdLi6EE8UniTupleIdLi6EEx5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!91 = distinct !{!91, !"_ZN17bnserve_inference14adjoint_kernel5_sums11add_splinedB4v303B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedEd5ArrayIdLi1E1C7mutable7alignedE8UniTupleIxLi3EE8UniTupleIdLi6EE8UniTupleIdLi6EEx5ArrayIdLi1E1C7mutable7alignedE"}
!92 = !{!93, !46}
!93 = distinct !{!93, !94, !"_ZN17bnserve_inference14adjoint_kernel7_source14_through_pairsB4v324B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!94 = distinct !{!94, !"_ZN17bnserve_inference14adjoint_kernel7_source14_through_pairsB4v324B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBExxxxx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!95 = !{!96, !93, !46}
!96 = distinct !{!96, !97, !"_ZN17bnserve_inference14adjoint_kernel5_sums8add_pairB4v344B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEbddEdx5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!97 = distinct !{!97, !"_ZN17bnserve_inference14adjoint_kernel5_sums8add_pairB4v344B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEbddEdx5ArrayIdLi1E1C7mutable7alignedE"}
!98 = !{!99, !93, !46}
!99 = distinct !{!99, !100, !"_ZN17bnserve_inference14adjoint_kernel5_sums8add_pairB4v344B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEbddEdx5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!100 = distinct !{!100, !"_ZN17bnserve_inference14adjoint_kernel5_sums8add_pairB4v344B86c8tJTIeFIjxB2IKSgI4CrvSCKg1MMbCQQPKkLTj8gEEF9aYtuj_2br1ZPz80qKEpNL1Gs1gcFdBDMWKZ2BRTQBE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEbddEdx5ArrayIdLi1E1C7mutable7alignedE"}
