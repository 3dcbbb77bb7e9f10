; Written from stops.c by `python -m runtime.engine.native_text`; do not edit.

%struct.Room = type { ptr, ptr }
%struct.Bounded = type { i32, ptr, ptr, ptr, ptr, ptr, ptr, ptr }
%struct.Run = type { ptr, ptr, ptr, ptr, ptr, ptr, ptr, ptr, ptr, ptr, ptr, ptr, ptr, ptr, ptr, ptr, ptr, double, double, double, ptr, i32, ptr, ptr }
%struct.Stop = type { double, double, double }
%struct.Event = type { i32, i32, i32, i32, double }
%struct.Part = type { double, double, double, double }

define range(i32 0, 2) i32 @settle_at(ptr noundef %0, ptr noundef captures(none) %1, ptr noundef captures(none) %2, ptr noundef readonly captures(none) %3, ptr noundef readonly captures(address_is_null) %4, ptr noundef %5) {
  %7 = alloca %struct.Room, align 8
  %8 = getelementptr inbounds nuw i8, ptr %0, i64 328
  %9 = load i64, ptr %8, align 8
  %10 = getelementptr inbounds double, ptr %5, i64 %9
  %11 = getelementptr inbounds nuw i8, ptr %0, i64 40
  %12 = load i64, ptr %11, align 8
  %13 = getelementptr inbounds double, ptr %10, i64 %12
  %14 = getelementptr inbounds nuw i8, ptr %0, i64 320
  %15 = load i64, ptr %14, align 8
  %16 = getelementptr inbounds double, ptr %13, i64 %15
  %17 = getelementptr inbounds nuw i8, ptr %0, i64 304
  %18 = load i64, ptr %17, align 8
  %19 = getelementptr inbounds nuw i8, ptr %0, i64 288
  %20 = load i64, ptr %19, align 8
  %21 = mul nsw i64 %20, %18
  %22 = getelementptr inbounds double, ptr %16, i64 %21
  %23 = getelementptr inbounds nuw i8, ptr %7, i64 8
  %24 = getelementptr inbounds nuw i8, ptr %0, i64 344
  %25 = load i64, ptr %24, align 8
  %26 = getelementptr inbounds double, ptr %22, i64 %25
  store ptr %26, ptr %23, align 8
  %27 = getelementptr inbounds nuw i8, ptr %0, i64 280
  %28 = load i64, ptr %27, align 8
  %29 = getelementptr inbounds double, ptr %22, i64 %28
  store ptr %29, ptr %7, align 8
  %30 = icmp sgt i64 %28, 0
  br i1 %30, label %31, label %61

31:
  %32 = getelementptr inbounds double, ptr %1, i64 %18
  %33 = getelementptr inbounds nuw i8, ptr %0, i64 312
  %34 = icmp sgt i64 %18, 0
  br label %35

35:
  %36 = phi i64 [ 0, %31 ], [ %59, %56 ]
  %37 = getelementptr inbounds nuw i32, ptr %4, i64 %36
  %38 = load i32, ptr %37, align 4
  %39 = icmp eq i32 %38, 0
  br i1 %39, label %56, label %40

40:
  %41 = load i64, ptr %33, align 8
  %42 = getelementptr inbounds double, ptr %32, i64 %41
  br i1 %34, label %43, label %56

43:
  %44 = phi double [ %51, %43 ], [ 0.000000e+00, %40 ]
  %45 = phi i64 [ %46, %43 ], [ %18, %40 ]
  %46 = add nsw i64 %45, -1
  %47 = getelementptr inbounds double, ptr %42, i64 %46
  %48 = load double, ptr %47, align 8
  %49 = tail call double @llvm.fabs.f64(double %48)
  %50 = fcmp ogt double %49, %44
  %51 = select i1 %50, double %49, double %44
  %52 = icmp samesign ugt i64 %45, 1
  br i1 %52, label %43, label %53

53:
  %54 = fadd double %51, 1.000000e+00
  %55 = fmul double %54, 0x3EB0C6F7A0B5ED8D
  br label %56

56:
  %57 = phi double [ 0.000000e+00, %35 ], [ 0x3EB0C6F7A0B5ED8D, %40 ], [ %55, %53 ]
  %58 = getelementptr inbounds nuw double, ptr %22, i64 %36
  store double %57, ptr %58, align 8
  %59 = add nuw nsw i64 %36, 1
  %60 = icmp eq i64 %59, %28
  br i1 %60, label %61, label %35

61:
  %62 = getelementptr inbounds nuw i8, ptr %0, i64 352
  %63 = load i64, ptr %62, align 8
  %64 = getelementptr inbounds double, ptr %26, i64 %63
  %65 = tail call fastcc i32 @decide(ptr noundef %0, ptr noundef %1, ptr noundef %2, ptr noundef %3, ptr noundef %4, ptr noundef %22, ptr noundef %5, ptr noundef %64, ptr noundef null, ptr noundef nonnull byval(%struct.Room) align 8 %7)
  ret i32 %65
}

define internal fastcc range(i32 0, 2) i32 @decide(ptr noundef readonly %0, ptr noundef captures(none) %1, ptr noundef captures(none) %2, ptr noundef readonly captures(none) %3, ptr noundef readonly captures(address_is_null) %4, ptr noundef readonly captures(none) %5, ptr noundef %6, ptr noundef %7, ptr noundef captures(address_is_null) %8, ptr noundef byval(%struct.Room) align 8 captures(none) %9) unnamed_addr {
  %11 = alloca %struct.Bounded, align 8
  %12 = alloca %struct.Bounded, align 8
  %13 = getelementptr inbounds nuw i8, ptr %0, i64 280
  %14 = load i64, ptr %13, align 8
  %15 = load ptr, ptr %9, align 8
  %16 = getelementptr inbounds double, ptr %15, i64 %14
  store ptr %16, ptr %9, align 8
  %17 = getelementptr inbounds nuw i8, ptr %9, i64 8
  %18 = load ptr, ptr %17, align 8
  %19 = getelementptr inbounds i32, ptr %18, i64 %14
  store ptr %19, ptr %17, align 8
  %20 = shl i64 %14, 2
  tail call void @llvm.memset.p0.i64(ptr align 4 %18, i8 0, i64 %20, i1 false)
  %21 = getelementptr inbounds nuw i8, ptr %0, i64 328
  %22 = load i64, ptr %21, align 8
  %23 = getelementptr inbounds double, ptr %6, i64 %22
  %24 = getelementptr inbounds nuw i8, ptr %0, i64 40
  %25 = load i64, ptr %24, align 8
  %26 = getelementptr inbounds double, ptr %23, i64 %25
  %27 = getelementptr inbounds nuw i8, ptr %0, i64 320
  %28 = load i64, ptr %27, align 8
  %29 = getelementptr inbounds double, ptr %26, i64 %28
  %30 = getelementptr inbounds nuw i8, ptr %0, i64 48
  %31 = getelementptr inbounds nuw i8, ptr %0, i64 304
  %32 = getelementptr inbounds nuw i8, ptr %0, i64 312
  %33 = getelementptr inbounds nuw i8, ptr %0, i64 288
  %34 = getelementptr inbounds nuw i8, ptr %12, i64 8
  %35 = getelementptr inbounds nuw i8, ptr %12, i64 16
  %36 = getelementptr inbounds nuw i8, ptr %12, i64 24
  %37 = getelementptr inbounds nuw i8, ptr %12, i64 32
  %38 = getelementptr inbounds nuw i8, ptr %12, i64 40
  %39 = getelementptr inbounds nuw i8, ptr %12, i64 48
  %40 = getelementptr inbounds nuw i8, ptr %12, i64 56
  %41 = getelementptr inbounds nuw i8, ptr %0, i64 472
  %42 = getelementptr inbounds nuw i8, ptr %0, i64 376
  %43 = icmp eq ptr %8, null
  %44 = getelementptr inbounds nuw i8, ptr %0, i64 392
  %45 = icmp eq ptr %4, null
  %46 = getelementptr inbounds nuw i8, ptr %0, i64 296
  %47 = getelementptr inbounds nuw i8, ptr %11, i64 8
  %48 = getelementptr inbounds nuw i8, ptr %11, i64 16
  %49 = getelementptr inbounds nuw i8, ptr %11, i64 24
  %50 = getelementptr inbounds nuw i8, ptr %11, i64 32
  %51 = getelementptr inbounds nuw i8, ptr %11, i64 40
  %52 = getelementptr inbounds nuw i8, ptr %11, i64 48
  %53 = getelementptr inbounds nuw i8, ptr %11, i64 56
  %54 = getelementptr inbounds nuw i8, ptr %0, i64 384
  %55 = icmp ne ptr %8, null
  %56 = getelementptr inbounds nuw i8, ptr %0, i64 488
  %57 = getelementptr inbounds nuw i8, ptr %0, i64 480
  br label %58

58:
  %59 = load i64, ptr %27, align 8
  %60 = shl i64 %59, 3
  tail call void @llvm.memcpy.p0.p0.i64(ptr align 8 %26, ptr align 8 %1, i64 %60, i1 false)
  %61 = load i64, ptr %24, align 8
  %62 = shl i64 %61, 3
  tail call void @llvm.memcpy.p0.p0.i64(ptr align 8 %23, ptr align 8 %3, i64 %62, i1 false)
  %63 = load i64, ptr %24, align 8
  %64 = getelementptr inbounds double, ptr %23, i64 %63
  %65 = load i64, ptr %30, align 8
  %66 = sub i64 0, %65
  %67 = getelementptr inbounds double, ptr %64, i64 %66
  %68 = shl i64 %65, 3
  tail call void @llvm.memcpy.p0.p0.i64(ptr align 8 %67, ptr align 8 %2, i64 %68, i1 false)
  %69 = load i64, ptr %13, align 8
  %70 = icmp sgt i64 %69, 0
  br i1 %70, label %71, label %83

71:
  %72 = load ptr, ptr %42, align 8
  br label %73

73:
  %74 = phi i64 [ 0, %71 ], [ %81, %73 ]
  %75 = getelementptr inbounds nuw i32, ptr %72, i64 %74
  %76 = load i32, ptr %75, align 4
  %77 = sext i32 %76 to i64
  %78 = getelementptr inbounds double, ptr %2, i64 %77
  %79 = load double, ptr %78, align 8
  %80 = getelementptr inbounds nuw double, ptr %15, i64 %74
  store double %79, ptr %80, align 8
  %81 = add nuw nsw i64 %74, 1
  %82 = icmp eq i64 %81, %69
  br i1 %82, label %83, label %73

83:
  %84 = load ptr, ptr %9, align 8
  %85 = load ptr, ptr %17, align 8
  %86 = load i64, ptr %31, align 8
  %87 = getelementptr inbounds double, ptr %26, i64 %86
  %88 = load i64, ptr %32, align 8
  %89 = getelementptr inbounds double, ptr %87, i64 %88
  %90 = getelementptr inbounds double, ptr %84, i64 %86
  %91 = load i64, ptr %33, align 8
  %92 = getelementptr inbounds double, ptr %90, i64 %91
  %93 = getelementptr inbounds double, ptr %92, i64 %91
  %94 = getelementptr inbounds double, ptr %93, i64 %69
  %95 = getelementptr inbounds double, ptr %94, i64 %69
  %96 = icmp sgt i64 %86, 0
  br i1 %96, label %97, label %110

97:
  %98 = phi double [ %105, %97 ], [ 0.000000e+00, %83 ]
  %99 = phi i64 [ %100, %97 ], [ %86, %83 ]
  %100 = add nsw i64 %99, -1
  %101 = getelementptr inbounds double, ptr %89, i64 %100
  %102 = load double, ptr %101, align 8
  %103 = tail call double @llvm.fabs.f64(double %102)
  %104 = fcmp ogt double %103, %98
  %105 = select i1 %104, double %103, double %98
  %106 = icmp samesign ugt i64 %99, 1
  br i1 %106, label %97, label %107

107:
  %108 = fadd double %105, 1.000000e+00
  %109 = fmul double %108, 1.000000e-09
  br label %110

110:
  %111 = phi double [ 1.000000e-09, %83 ], [ %109, %107 ]
  %112 = getelementptr inbounds i32, ptr %85, i64 %69
  %113 = getelementptr inbounds i32, ptr %112, i64 %69
  %114 = getelementptr inbounds i32, ptr %113, i64 %69
  %115 = getelementptr inbounds i32, ptr %114, i64 %91
  %116 = getelementptr inbounds i32, ptr %115, i64 %91
  store i32 0, ptr %12, align 8
  %117 = getelementptr inbounds i32, ptr %116, i64 %69
  store ptr %116, ptr %34, align 8
  %118 = getelementptr inbounds i32, ptr %117, i64 %69
  store ptr %117, ptr %35, align 8
  %119 = mul nsw i64 %69, %69
  %120 = getelementptr inbounds nuw double, ptr %95, i64 %119
  store ptr %95, ptr %36, align 8
  %121 = getelementptr inbounds double, ptr %120, i64 %69
  store ptr %120, ptr %37, align 8
  %122 = getelementptr inbounds double, ptr %121, i64 %69
  store ptr %121, ptr %38, align 8
  %123 = getelementptr inbounds double, ptr %122, i64 %69
  store ptr %122, ptr %39, align 8
  %124 = getelementptr inbounds double, ptr %123, i64 %69
  store ptr %123, ptr %40, align 8
  %125 = shl i64 %86, 3
  tail call void @llvm.memset.p0.i64(ptr align 8 %84, i8 0, i64 %125, i1 false)
  %126 = load i64, ptr %33, align 8
  %127 = shl i64 %126, 3
  tail call void @llvm.memset.p0.i64(ptr align 8 %92, i8 0, i64 %127, i1 false)
  %128 = load i64, ptr %13, align 8
  %129 = shl i64 %128, 2
  tail call void @llvm.memset.p0.i64(ptr align 4 %113, i8 0, i64 %129, i1 false)
  %130 = load i64, ptr %33, align 8
  %131 = shl i64 %130, 2
  tail call void @llvm.memset.p0.i64(ptr align 4 %114, i8 0, i64 %131, i1 false)
  %132 = load i64, ptr %33, align 8
  %133 = shl i64 %132, 2
  tail call void @llvm.memset.p0.i64(ptr align 4 %115, i8 0, i64 %133, i1 false)
  %134 = load i64, ptr %13, align 8
  %135 = shl i64 %134, 3
  tail call void @llvm.memcpy.p0.p0.i64(ptr align 8 %94, ptr align 8 %15, i64 %135, i1 false)
  %136 = load ptr, ptr %41, align 8
  tail call void %136(ptr noundef %6, ptr noundef %26, ptr noundef %23, ptr noundef %7)
  br i1 %43, label %148, label %137

137:
  %138 = load i64, ptr %13, align 8
  %139 = shl i64 %138, 5
  tail call void @llvm.memset.p0.i64(ptr nonnull align 8 %8, i8 0, i64 %139, i1 false)
  %140 = load i64, ptr %13, align 8
  %141 = mul nsw i64 %140, 40
  %142 = getelementptr inbounds i8, ptr %8, i64 %141
  %143 = load i64, ptr %33, align 8
  %144 = load i64, ptr %31, align 8
  %145 = mul nsw i64 %144, %143
  %146 = getelementptr inbounds double, ptr %6, i64 %145
  %147 = shl i64 %143, 3
  tail call void @llvm.memcpy.p0.p0.i64(ptr nonnull align 8 %142, ptr align 8 %146, i64 %147, i1 false)
  br label %148

148:
  %149 = load i64, ptr %33, align 8
  %150 = icmp sgt i64 %149, 0
  br i1 %150, label %151, label %159

151:
  %152 = load i64, ptr %31, align 8
  %153 = add i64 %152, 1
  %154 = mul i64 %153, %149
  %155 = getelementptr double, ptr %6, i64 %154
  br label %164

156:
  %157 = add nuw nsw i64 %165, 1
  %158 = icmp eq i64 %157, %149
  br i1 %158, label %159, label %164

159:
  %160 = load i64, ptr %13, align 8
  %161 = icmp sgt i64 %160, 0
  br i1 %161, label %162, label %225

162:
  %163 = load ptr, ptr %44, align 8
  br label %169

164:
  %165 = phi i64 [ 0, %151 ], [ %157, %156 ]
  %166 = getelementptr double, ptr %155, i64 %165
  %167 = load double, ptr %166, align 8
  %168 = fcmp ult double %167, 0xBD719799812DEA11
  br i1 %168, label %1371, label %156

169:
  %170 = phi i64 [ 0, %162 ], [ %223, %219 ]
  %171 = phi i32 [ 0, %162 ], [ %222, %219 ]
  %172 = getelementptr inbounds nuw i32, ptr %163, i64 %170
  %173 = load i32, ptr %172, align 4
  %174 = icmp ne i32 %173, 0
  %175 = zext i1 %174 to i32
  %176 = getelementptr inbounds nuw double, ptr %94, i64 %170
  %177 = load double, ptr %176, align 8
  %178 = fcmp oeq double %177, 0.000000e+00
  br i1 %178, label %202, label %179

179:
  br i1 %45, label %184, label %180

180:
  %181 = getelementptr inbounds nuw i32, ptr %4, i64 %170
  %182 = load i32, ptr %181, align 4
  %183 = icmp ne i32 %182, 0
  br label %184

184:
  %185 = phi i1 [ %183, %180 ], [ false, %179 ]
  %186 = xor i1 %174, true
  %187 = select i1 %186, i1 true, i1 %185
  br i1 %187, label %202, label %188

188:
  %189 = load i64, ptr %31, align 8
  %190 = add i64 %189, 2
  %191 = mul i64 %190, %149
  %192 = zext nneg i32 %171 to i64
  %193 = getelementptr double, ptr %6, i64 %191
  %194 = getelementptr double, ptr %193, i64 %192
  %195 = load double, ptr %194, align 8
  %196 = fcmp ole double %195, 0.000000e+00
  %197 = zext i1 %196 to i32
  %198 = getelementptr inbounds nuw i32, ptr %85, i64 %170
  store i32 %197, ptr %198, align 4
  %199 = fcmp ole double %195, 1.000000e-09
  %200 = zext i1 %199 to i32
  %201 = getelementptr inbounds nuw i32, ptr %112, i64 %170
  store i32 %200, ptr %201, align 4
  br label %205

202:
  %203 = getelementptr inbounds nuw i32, ptr %85, i64 %170
  store i32 %175, ptr %203, align 4
  %204 = getelementptr inbounds nuw i32, ptr %112, i64 %170
  store i32 %175, ptr %204, align 4
  br i1 %174, label %205, label %219

205:
  %206 = getelementptr inbounds nuw i32, ptr %18, i64 %170
  %207 = load i32, ptr %206, align 4
  %208 = icmp eq i32 %207, 0
  br i1 %208, label %209, label %219

209:
  %210 = load i64, ptr %31, align 8
  %211 = add i64 %210, 2
  %212 = mul i64 %211, %149
  %213 = load i64, ptr %46, align 8
  %214 = zext nneg i32 %171 to i64
  %215 = getelementptr double, ptr %6, i64 %212
  %216 = getelementptr double, ptr %215, i64 %213
  %217 = getelementptr double, ptr %216, i64 %214
  %218 = load double, ptr %217, align 8
  br label %219

219:
  %220 = phi double [ %218, %209 ], [ 0.000000e+00, %205 ], [ 0.000000e+00, %202 ]
  %221 = getelementptr inbounds nuw double, ptr %93, i64 %170
  store double %220, ptr %221, align 8
  %222 = add nuw nsw i32 %171, %175
  %223 = add nuw nsw i64 %170, 1
  %224 = icmp eq i64 %223, %160
  br i1 %224, label %225, label %169

225:
  %226 = getelementptr inbounds double, ptr %124, i64 %160
  %227 = getelementptr inbounds i32, ptr %118, i64 %160
  store i32 0, ptr %11, align 8
  %228 = getelementptr inbounds i32, ptr %227, i64 %160
  store ptr %227, ptr %47, align 8
  %229 = getelementptr inbounds i32, ptr %228, i64 %160
  store ptr %228, ptr %48, align 8
  %230 = mul nsw i64 %160, %160
  %231 = getelementptr inbounds nuw double, ptr %226, i64 %230
  store ptr %226, ptr %49, align 8
  %232 = getelementptr inbounds double, ptr %231, i64 %160
  store ptr %231, ptr %50, align 8
  %233 = getelementptr inbounds double, ptr %232, i64 %160
  store ptr %232, ptr %51, align 8
  %234 = getelementptr inbounds double, ptr %233, i64 %160
  store ptr %233, ptr %52, align 8
  %235 = getelementptr inbounds double, ptr %234, i64 %160
  store ptr %234, ptr %53, align 8
  br i1 %161, label %236, label %242

236:
  %237 = load ptr, ptr %44, align 8
  %238 = load i64, ptr %31, align 8
  %239 = mul nsw i64 %238, %149
  %240 = load ptr, ptr %54, align 8
  %241 = getelementptr double, ptr %6, i64 %239
  br label %244

242:
  %243 = fneg double %111
  br label %258

244:
  %245 = phi i64 [ 0, %236 ], [ %256, %244 ]
  %246 = getelementptr inbounds nuw i32, ptr %237, i64 %245
  %247 = load i32, ptr %246, align 4
  %248 = sitofp i32 %247 to double
  %249 = getelementptr inbounds nuw i32, ptr %240, i64 %245
  %250 = load i32, ptr %249, align 4
  %251 = sext i32 %250 to i64
  %252 = getelementptr double, ptr %241, i64 %251
  %253 = load double, ptr %252, align 8
  %254 = fmul double %253, %248
  %255 = getelementptr inbounds nuw double, ptr %124, i64 %245
  store double %254, ptr %255, align 8
  %256 = add nuw nsw i64 %245, 1
  %257 = icmp eq i64 %256, %160
  br i1 %257, label %242, label %244

258:
  %259 = phi i64 [ %160, %242 ], [ %416, %533 ]
  %260 = phi i32 [ 0, %242 ], [ %534, %533 ]
  %261 = phi i32 [ 0, %242 ], [ %323, %533 ]
  %262 = icmp ne i32 %260, 50
  %263 = icmp sgt i64 %259, 0
  br i1 %263, label %264, label %536

264:
  %265 = getelementptr double, ptr %8, i64 %259
  br label %266

266:
  %267 = phi i64 [ 0, %264 ], [ %325, %320 ]
  %268 = phi i32 [ 0, %264 ], [ %324, %320 ]
  %269 = phi i32 [ %261, %264 ], [ %323, %320 ]
  %270 = phi i32 [ 0, %264 ], [ %322, %320 ]
  %271 = phi i32 [ 0, %264 ], [ %321, %320 ]
  %272 = getelementptr inbounds nuw i32, ptr %85, i64 %267
  %273 = load i32, ptr %272, align 4
  %274 = icmp eq i32 %273, 0
  br i1 %274, label %320, label %275

275:
  %276 = getelementptr inbounds nuw double, ptr %124, i64 %267
  %277 = load double, ptr %276, align 8
  %278 = fcmp olt double %277, %243
  %279 = fcmp ugt double %277, %111
  %280 = select i1 %262, i1 %279, i1 false
  br i1 %280, label %320, label %281

281:
  %282 = select i1 %55, i1 %278, i1 false
  %283 = getelementptr inbounds nuw i32, ptr %113, i64 %267
  %284 = load i32, ptr %283, align 4
  br i1 %282, label %289, label %285

285:
  %286 = icmp ne i32 %284, 0
  %287 = select i1 %286, i1 true, i1 %278
  %288 = zext i1 %287 to i32
  br label %297

289:
  %290 = icmp eq i32 %284, 0
  br i1 %290, label %291, label %297

291:
  %292 = add nsw i32 %269, 1
  %293 = sitofp i32 %292 to double
  %294 = getelementptr inbounds nuw double, ptr %8, i64 %267
  store double %293, ptr %294, align 8
  %295 = load double, ptr %276, align 8
  %296 = getelementptr double, ptr %265, i64 %267
  store double %295, ptr %296, align 8
  br label %297

297:
  %298 = phi double [ %277, %289 ], [ %295, %291 ], [ %277, %285 ]
  %299 = phi i32 [ 1, %289 ], [ 1, %291 ], [ %288, %285 ]
  %300 = phi i32 [ %269, %289 ], [ %292, %291 ], [ %269, %285 ]
  %301 = icmp ne i32 %268, 0
  %302 = select i1 %301, i1 true, i1 %278
  %303 = zext i1 %302 to i32
  store i32 %299, ptr %283, align 4
  %304 = sext i32 %270 to i64
  %305 = getelementptr inbounds i32, ptr %118, i64 %304
  %306 = trunc nuw nsw i64 %267 to i32
  store i32 %306, ptr %305, align 4
  %307 = and i1 %262, %278
  br i1 %307, label %308, label %313

308:
  %309 = getelementptr inbounds nuw double, ptr %93, i64 %267
  %310 = load double, ptr %309, align 8
  %311 = fadd double %310, 1.000000e+00
  %312 = fmul double %298, %311
  br label %313

313:
  %314 = phi double [ %312, %308 ], [ %298, %297 ]
  %315 = getelementptr inbounds double, ptr %231, i64 %304
  store double %314, ptr %315, align 8
  %316 = getelementptr inbounds double, ptr %232, i64 %304
  store double 0.000000e+00, ptr %316, align 8
  %317 = getelementptr inbounds double, ptr %233, i64 %304
  store double 0x7FF0000000000000, ptr %317, align 8
  %318 = add nsw i32 %270, 1
  %319 = getelementptr inbounds i32, ptr %228, i64 %304
  store i32 0, ptr %319, align 4
  br label %320

320:
  %321 = phi i32 [ %318, %313 ], [ %271, %275 ], [ %271, %266 ]
  %322 = phi i32 [ %318, %313 ], [ %270, %275 ], [ %270, %266 ]
  %323 = phi i32 [ %300, %313 ], [ %269, %275 ], [ %269, %266 ]
  %324 = phi i32 [ %303, %313 ], [ %268, %275 ], [ %268, %266 ]
  %325 = add nuw nsw i64 %267, 1
  %326 = icmp eq i64 %325, %259
  br i1 %326, label %327, label %266

327:
  %328 = icmp eq i32 %324, 0
  store i32 %321, ptr %11, align 8
  br i1 %328, label %536, label %329

329:
  %330 = icmp sgt i32 %322, 0
  br i1 %330, label %331, label %381

331:
  %332 = zext nneg i32 %322 to i64
  %333 = load ptr, ptr %44, align 8
  %334 = load i64, ptr %33, align 8
  %335 = load i64, ptr %31, align 8
  %336 = load i64, ptr %46, align 8
  %337 = load ptr, ptr %54, align 8
  %338 = mul nsw i64 %335, %334
  %339 = add i64 %335, 2
  %340 = mul i64 %339, %334
  %341 = getelementptr double, ptr %6, i64 %340
  %342 = shl i64 %336, 4
  %343 = getelementptr i8, ptr %341, i64 %342
  %344 = getelementptr double, ptr %343, i64 %338
  br label %345

345:
  %346 = phi i64 [ 0, %331 ], [ %379, %378 ]
  %347 = getelementptr inbounds nuw i32, ptr %118, i64 %346
  %348 = load i32, ptr %347, align 4
  %349 = sext i32 %348 to i64
  %350 = getelementptr inbounds i32, ptr %333, i64 %349
  %351 = load i32, ptr %350, align 4
  %352 = sitofp i32 %351 to double
  %353 = getelementptr inbounds i32, ptr %337, i64 %349
  %354 = load i32, ptr %353, align 4
  %355 = sext i32 %354 to i64
  %356 = getelementptr double, ptr %344, i64 %355
  %357 = getelementptr inbounds nuw double, ptr %226, i64 %346
  br label %358

358:
  %359 = phi i64 [ 0, %345 ], [ %376, %358 ]
  %360 = getelementptr inbounds nuw i32, ptr %118, i64 %359
  %361 = load i32, ptr %360, align 4
  %362 = sext i32 %361 to i64
  %363 = getelementptr inbounds i32, ptr %337, i64 %362
  %364 = load i32, ptr %363, align 4
  %365 = sext i32 %364 to i64
  %366 = mul nsw i64 %334, %365
  %367 = getelementptr double, ptr %356, i64 %366
  %368 = load double, ptr %367, align 8
  %369 = fmul double %368, %352
  %370 = getelementptr inbounds i32, ptr %333, i64 %362
  %371 = load i32, ptr %370, align 4
  %372 = sitofp i32 %371 to double
  %373 = fmul double %369, %372
  %374 = mul nuw nsw i64 %359, %332
  %375 = getelementptr inbounds nuw double, ptr %357, i64 %374
  store double %373, ptr %375, align 8
  %376 = add nuw nsw i64 %359, 1
  %377 = icmp eq i64 %376, %332
  br i1 %377, label %378, label %358

378:
  %379 = add nuw nsw i64 %346, 1
  %380 = icmp eq i64 %379, %332
  br i1 %380, label %381, label %345

381:
  %382 = call fastcc i32 @complementary(ptr noundef readonly %0, ptr noundef %11, ptr %235, ptr nonnull %229)
  %383 = icmp eq i32 %382, 0
  br i1 %383, label %384, label %385

384:
  br label %1371

385:
  call fastcc void @balance(ptr noundef readonly %0, ptr noundef %11, ptr %235, ptr nonnull %229)
  br i1 %330, label %388, label %386

386:
  %387 = load i64, ptr %13, align 8
  br label %415

388:
  %389 = zext nneg i32 %322 to i64
  br label %390

390:
  %391 = phi i64 [ 0, %388 ], [ %396, %390 ]
  %392 = getelementptr inbounds nuw double, ptr %234, i64 %391
  %393 = load double, ptr %392, align 8
  %394 = fcmp ogt double %393, 0.000000e+00
  %395 = select i1 %394, double %393, double 0.000000e+00
  store double %395, ptr %392, align 8
  %396 = add nuw nsw i64 %391, 1
  %397 = icmp eq i64 %396, %389
  br i1 %397, label %398, label %390

398:
  %399 = load i64, ptr %13, align 8
  br i1 %55, label %400, label %415

400:
  %401 = mul i64 %399, 24
  %402 = getelementptr i8, ptr %8, i64 %401
  br label %403

403:
  %404 = phi i64 [ 0, %400 ], [ %413, %403 ]
  %405 = getelementptr inbounds nuw double, ptr %234, i64 %404
  %406 = load double, ptr %405, align 8
  %407 = getelementptr inbounds nuw i32, ptr %118, i64 %404
  %408 = load i32, ptr %407, align 4
  %409 = sext i32 %408 to i64
  %410 = getelementptr double, ptr %402, i64 %409
  %411 = load double, ptr %410, align 8
  %412 = fadd double %406, %411
  store double %412, ptr %410, align 8
  %413 = add nuw nsw i64 %404, 1
  %414 = icmp eq i64 %413, %389
  br i1 %414, label %415, label %403

415:
  %416 = phi i64 [ %387, %386 ], [ %399, %398 ], [ %399, %403 ]
  %417 = icmp sgt i64 %416, 0
  br i1 %417, label %418, label %422

418:
  %419 = shl i64 %416, 4
  %420 = getelementptr i8, ptr %8, i64 %419
  %421 = zext nneg i32 %322 to i64
  br label %428

422:
  %423 = load i64, ptr %31, align 8
  %424 = icmp sgt i64 %423, 0
  br i1 %424, label %425, label %533

425:
  %426 = add nuw i64 %423, 2
  %427 = zext nneg i32 %322 to i64
  br label %492

428:
  %429 = phi i64 [ 0, %418 ], [ %490, %486 ]
  br i1 %330, label %430, label %473

430:
  %431 = load ptr, ptr %44, align 8
  %432 = getelementptr inbounds nuw i32, ptr %431, i64 %429
  %433 = load i32, ptr %432, align 4
  %434 = sitofp i32 %433 to double
  %435 = load i64, ptr %33, align 8
  %436 = load i64, ptr %31, align 8
  %437 = mul nsw i64 %436, %435
  %438 = add i64 %436, 2
  %439 = mul i64 %438, %435
  %440 = load i64, ptr %46, align 8
  %441 = load ptr, ptr %54, align 8
  %442 = getelementptr inbounds nuw i32, ptr %441, i64 %429
  %443 = load i32, ptr %442, align 4
  %444 = sext i32 %443 to i64
  %445 = getelementptr double, ptr %6, i64 %439
  %446 = shl i64 %440, 4
  %447 = getelementptr i8, ptr %445, i64 %446
  %448 = getelementptr double, ptr %447, i64 %437
  %449 = getelementptr double, ptr %448, i64 %444
  br label %450

450:
  %451 = phi i64 [ 0, %430 ], [ %471, %450 ]
  %452 = phi double [ 0.000000e+00, %430 ], [ %470, %450 ]
  %453 = getelementptr inbounds nuw i32, ptr %118, i64 %451
  %454 = load i32, ptr %453, align 4
  %455 = sext i32 %454 to i64
  %456 = getelementptr inbounds i32, ptr %441, i64 %455
  %457 = load i32, ptr %456, align 4
  %458 = sext i32 %457 to i64
  %459 = mul nsw i64 %435, %458
  %460 = getelementptr double, ptr %449, i64 %459
  %461 = load double, ptr %460, align 8
  %462 = fmul double %461, %434
  %463 = getelementptr inbounds i32, ptr %431, i64 %455
  %464 = load i32, ptr %463, align 4
  %465 = sitofp i32 %464 to double
  %466 = fmul double %462, %465
  %467 = getelementptr inbounds nuw double, ptr %234, i64 %451
  %468 = load double, ptr %467, align 8
  %469 = fmul double %468, %466
  %470 = fadd double %452, %469
  %471 = add nuw nsw i64 %451, 1
  %472 = icmp eq i64 %471, %421
  br i1 %472, label %473, label %450

473:
  %474 = phi double [ 0.000000e+00, %428 ], [ %470, %450 ]
  br i1 %55, label %475, label %486

475:
  %476 = getelementptr inbounds nuw i32, ptr %85, i64 %429
  %477 = load i32, ptr %476, align 4
  %478 = icmp eq i32 %477, 0
  br i1 %478, label %486, label %479

479:
  %480 = getelementptr inbounds nuw double, ptr %124, i64 %429
  %481 = load double, ptr %480, align 8
  %482 = fcmp olt double %481, %243
  br i1 %482, label %483, label %486

483:
  %484 = fadd double %474, %481
  %485 = getelementptr double, ptr %420, i64 %429
  store double %484, ptr %485, align 8
  br label %486

486:
  %487 = getelementptr inbounds nuw double, ptr %124, i64 %429
  %488 = load double, ptr %487, align 8
  %489 = fadd double %474, %488
  store double %489, ptr %487, align 8
  %490 = add nuw nsw i64 %429, 1
  %491 = icmp eq i64 %490, %416
  br i1 %491, label %422, label %428

492:
  %493 = phi i64 [ 0, %425 ], [ %531, %526 ]
  br i1 %330, label %494, label %526

494:
  %495 = load i64, ptr %33, align 8
  %496 = mul i64 %495, %426
  %497 = load i64, ptr %46, align 8
  %498 = load ptr, ptr %54, align 8
  %499 = getelementptr double, ptr %6, i64 %496
  %500 = shl i64 %497, 4
  %501 = getelementptr i8, ptr %499, i64 %500
  %502 = getelementptr double, ptr %501, i64 %493
  %503 = load ptr, ptr %44, align 8
  br label %504

504:
  %505 = phi i64 [ 0, %494 ], [ %524, %504 ]
  %506 = phi double [ 0.000000e+00, %494 ], [ %523, %504 ]
  %507 = getelementptr inbounds nuw i32, ptr %118, i64 %505
  %508 = load i32, ptr %507, align 4
  %509 = sext i32 %508 to i64
  %510 = getelementptr inbounds i32, ptr %498, i64 %509
  %511 = load i32, ptr %510, align 4
  %512 = sext i32 %511 to i64
  %513 = mul nsw i64 %423, %512
  %514 = getelementptr double, ptr %502, i64 %513
  %515 = load double, ptr %514, align 8
  %516 = getelementptr inbounds i32, ptr %503, i64 %509
  %517 = load i32, ptr %516, align 4
  %518 = sitofp i32 %517 to double
  %519 = fmul double %515, %518
  %520 = getelementptr inbounds nuw double, ptr %234, i64 %505
  %521 = load double, ptr %520, align 8
  %522 = fmul double %521, %519
  %523 = fadd double %506, %522
  %524 = add nuw nsw i64 %505, 1
  %525 = icmp eq i64 %524, %427
  br i1 %525, label %526, label %504

526:
  %527 = phi double [ 0.000000e+00, %492 ], [ %523, %504 ]
  %528 = getelementptr inbounds nuw double, ptr %84, i64 %493
  %529 = load double, ptr %528, align 8
  %530 = fadd double %527, %529
  store double %530, ptr %528, align 8
  %531 = add nuw nsw i64 %493, 1
  %532 = icmp eq i64 %531, %423
  br i1 %532, label %533, label %492

533:
  %534 = add nuw nsw i32 %260, 1
  %535 = icmp eq i32 %534, 51
  br i1 %535, label %536, label %258

536:
  %537 = phi i64 [ %259, %258 ], [ %259, %327 ], [ %416, %533 ]
  %538 = load i64, ptr %33, align 8
  %539 = icmp sgt i64 %538, 0
  br i1 %539, label %540, label %549

540:
  %541 = load i64, ptr %31, align 8
  %542 = mul nsw i64 %541, %538
  %543 = getelementptr double, ptr %6, i64 %542
  %544 = trunc i64 %541 to i32
  %545 = icmp sgt i32 %544, 0
  %546 = shl i64 %538, 32
  %547 = ashr exact i64 %546, 32
  %548 = and i64 %541, 2147483647
  br label %553

549:
  %550 = icmp sgt i64 %537, 0
  br i1 %550, label %551, label %637

551:
  %552 = load ptr, ptr %54, align 8
  br label %584

553:
  %554 = phi i64 [ 0, %540 ], [ %575, %571 ]
  %555 = getelementptr double, ptr %543, i64 %554
  %556 = load double, ptr %555, align 8
  br i1 %545, label %557, label %571

557:
  %558 = getelementptr double, ptr %6, i64 %554
  br label %559

559:
  %560 = phi i64 [ 0, %557 ], [ %569, %559 ]
  %561 = phi double [ 0.000000e+00, %557 ], [ %568, %559 ]
  %562 = mul nsw i64 %560, %547
  %563 = getelementptr double, ptr %558, i64 %562
  %564 = load double, ptr %563, align 8
  %565 = getelementptr inbounds nuw double, ptr %84, i64 %560
  %566 = load double, ptr %565, align 8
  %567 = fmul double %564, %566
  %568 = fadd double %561, %567
  %569 = add nuw nsw i64 %560, 1
  %570 = icmp eq i64 %569, %548
  br i1 %570, label %571, label %559

571:
  %572 = phi double [ 0.000000e+00, %553 ], [ %568, %559 ]
  %573 = fadd double %556, %572
  %574 = getelementptr inbounds nuw double, ptr %90, i64 %554
  store double %573, ptr %574, align 8
  %575 = add nuw nsw i64 %554, 1
  %576 = icmp eq i64 %575, %538
  br i1 %576, label %549, label %553

577:
  %578 = load ptr, ptr %44, align 8
  %579 = load i64, ptr %24, align 8
  %580 = load i64, ptr %30, align 8
  %581 = sub nsw i64 %579, %580
  %582 = load ptr, ptr %42, align 8
  %583 = getelementptr double, ptr %23, i64 %581
  br label %641

584:
  %585 = phi i64 [ 0, %551 ], [ %633, %630 ]
  %586 = phi i32 [ 0, %551 ], [ %615, %630 ]
  %587 = getelementptr inbounds nuw i32, ptr %552, i64 %585
  %588 = load i32, ptr %587, align 4
  %589 = sext i32 %588 to i64
  %590 = getelementptr inbounds double, ptr %90, i64 %589
  %591 = load double, ptr %590, align 8
  %592 = tail call double @llvm.fabs.f64(double %591)
  %593 = getelementptr inbounds nuw i32, ptr %112, i64 %585
  %594 = load i32, ptr %593, align 4
  %595 = icmp ne i32 %594, 0
  %596 = fcmp ole double %592, %111
  %597 = select i1 %595, i1 %596, i1 false
  %598 = zext i1 %597 to i32
  store i32 %598, ptr %593, align 4
  br i1 %597, label %610, label %599

599:
  %600 = load ptr, ptr %44, align 8
  %601 = getelementptr inbounds nuw i32, ptr %600, i64 %585
  %602 = load i32, ptr %601, align 4
  %603 = icmp eq i32 %602, 0
  br i1 %603, label %604, label %614

604:
  %605 = getelementptr inbounds nuw double, ptr %5, i64 %585
  %606 = load double, ptr %605, align 8
  %607 = fcmp ogt double %606, %111
  %608 = select i1 %607, double %606, double %111
  %609 = fcmp ugt double %592, %608
  br i1 %609, label %614, label %610

610:
  %611 = load i32, ptr %587, align 4
  %612 = sext i32 %611 to i64
  %613 = getelementptr inbounds i32, ptr %114, i64 %612
  store i32 1, ptr %613, align 4
  br label %614

614:
  %615 = phi i32 [ 1, %610 ], [ %586, %604 ], [ %586, %599 ]
  %616 = load i32, ptr %587, align 4
  %617 = sext i32 %616 to i64
  %618 = getelementptr inbounds i32, ptr %115, i64 %617
  %619 = load i32, ptr %618, align 4
  %620 = icmp ne i32 %619, 0
  %621 = or i1 %45, %620
  br i1 %621, label %630, label %622

622:
  %623 = getelementptr inbounds nuw i32, ptr %4, i64 %585
  %624 = load i32, ptr %623, align 4
  %625 = icmp eq i32 %624, 0
  br i1 %625, label %630, label %626

626:
  %627 = getelementptr inbounds nuw double, ptr %94, i64 %585
  %628 = load double, ptr %627, align 8
  %629 = fcmp oeq double %628, 0.000000e+00
  br label %630

630:
  %631 = phi i1 [ %620, %614 ], [ false, %622 ], [ %629, %626 ]
  %632 = zext i1 %631 to i32
  store i32 %632, ptr %618, align 4
  %633 = add nuw nsw i64 %585, 1
  %634 = icmp eq i64 %633, %537
  br i1 %634, label %577, label %584

635:
  %636 = icmp eq i32 %615, 0
  br label %637

637:
  %638 = phi i1 [ true, %549 ], [ %636, %635 ]
  %639 = load i64, ptr %31, align 8
  %640 = icmp sgt i64 %639, 0
  br i1 %640, label %671, label %680

641:
  %642 = phi i64 [ 0, %577 ], [ %669, %662 ]
  %643 = getelementptr inbounds nuw i32, ptr %552, i64 %642
  %644 = load i32, ptr %643, align 4
  %645 = sext i32 %644 to i64
  %646 = getelementptr inbounds double, ptr %90, i64 %645
  %647 = load double, ptr %646, align 8
  %648 = getelementptr inbounds nuw i32, ptr %578, i64 %642
  %649 = load i32, ptr %648, align 4
  %650 = icmp eq i32 %649, 0
  br i1 %650, label %651, label %662

651:
  %652 = getelementptr inbounds i32, ptr %114, i64 %645
  %653 = load i32, ptr %652, align 4
  %654 = icmp eq i32 %653, 0
  br i1 %654, label %655, label %662

655:
  %656 = fcmp ogt double %647, 0.000000e+00
  %657 = zext i1 %656 to i32
  %658 = fcmp olt double %647, 0.000000e+00
  %659 = sext i1 %658 to i32
  %660 = add nsw i32 %659, %657
  %661 = sitofp i32 %660 to double
  br label %662

662:
  %663 = phi double [ 1.000000e+00, %641 ], [ %661, %655 ], [ 0.000000e+00, %651 ]
  %664 = getelementptr inbounds nuw double, ptr %15, i64 %642
  store double %663, ptr %664, align 8
  %665 = getelementptr inbounds nuw i32, ptr %582, i64 %642
  %666 = load i32, ptr %665, align 4
  %667 = sext i32 %666 to i64
  %668 = getelementptr double, ptr %583, i64 %667
  store double %663, ptr %668, align 8
  %669 = add nuw nsw i64 %642, 1
  %670 = icmp eq i64 %669, %537
  br i1 %670, label %635, label %641

671:
  %672 = phi i64 [ %678, %671 ], [ 0, %637 ]
  %673 = getelementptr inbounds nuw double, ptr %89, i64 %672
  %674 = load double, ptr %673, align 8
  %675 = getelementptr inbounds nuw double, ptr %84, i64 %672
  %676 = load double, ptr %675, align 8
  %677 = fadd double %674, %676
  store double %677, ptr %673, align 8
  %678 = add nuw nsw i64 %672, 1
  %679 = icmp eq i64 %678, %639
  br i1 %679, label %680, label %671

680:
  %681 = load i64, ptr %32, align 8
  %682 = icmp eq i64 %681, 0
  br i1 %682, label %691, label %683

683:
  %684 = load ptr, ptr %56, align 8
  tail call void %684(ptr noundef %124, ptr noundef %26, ptr noundef %23, ptr noundef %7)
  %685 = load i64, ptr %31, align 8
  %686 = shl nsw i64 %685, 4
  %687 = getelementptr inbounds i8, ptr %26, i64 %686
  %688 = load i64, ptr %32, align 8
  %689 = getelementptr inbounds double, ptr %687, i64 %688
  %690 = shl i64 %688, 3
  tail call void @llvm.memcpy.p0.p0.i64(ptr align 8 %689, ptr align 8 %124, i64 %690, i1 false)
  br label %691

691:
  br label %692

692:
  %693 = phi i1 [ true, %886 ], [ false, %691 ]
  %694 = load ptr, ptr %41, align 8
  tail call void %694(ptr noundef %6, ptr noundef %26, ptr noundef %23, ptr noundef %7)
  %695 = load i64, ptr %31, align 8
  %696 = icmp sgt i64 %695, 0
  br i1 %696, label %697, label %709

697:
  %698 = phi double [ %705, %697 ], [ 0.000000e+00, %692 ]
  %699 = phi i64 [ %700, %697 ], [ %695, %692 ]
  %700 = add nsw i64 %699, -1
  %701 = getelementptr inbounds double, ptr %89, i64 %700
  %702 = load double, ptr %701, align 8
  %703 = tail call double @llvm.fabs.f64(double %702)
  %704 = fcmp ogt double %703, %698
  %705 = select i1 %704, double %703, double %698
  %706 = icmp samesign ugt i64 %699, 1
  br i1 %706, label %697, label %707

707:
  %708 = fadd double %705, 1.000000e+00
  br label %709

709:
  %710 = phi double [ 1.000000e+00, %692 ], [ %708, %707 ]
  %711 = load i64, ptr %33, align 8
  %712 = getelementptr inbounds double, ptr %124, i64 %711
  %713 = getelementptr inbounds double, ptr %712, i64 %711
  %714 = getelementptr inbounds i32, ptr %118, i64 %711
  %715 = shl i64 %695, 3
  tail call void @llvm.memset.p0.i64(ptr align 8 %713, i8 0, i64 %715, i1 false)
  %716 = load i64, ptr %33, align 8
  %717 = icmp sgt i64 %716, 0
  %718 = load i64, ptr %31, align 8
  br i1 %717, label %719, label %845

719:
  %720 = icmp sgt i64 %718, 0
  %721 = mul nsw i64 %718, %716
  %722 = getelementptr double, ptr %6, i64 %721
  br label %727

723:
  %724 = icmp sgt i32 %778, 0
  br i1 %724, label %725, label %845

725:
  %726 = zext nneg i32 %778 to i64
  br label %781

727:
  %728 = phi i64 [ 0, %719 ], [ %779, %777 ]
  %729 = phi i32 [ 0, %719 ], [ %778, %777 ]
  %730 = getelementptr inbounds nuw double, ptr %712, i64 %728
  store double 0.000000e+00, ptr %730, align 8
  %731 = getelementptr double, ptr %6, i64 %728
  br i1 %720, label %732, label %745

732:
  %733 = phi i64 [ %741, %732 ], [ 0, %727 ]
  %734 = phi double [ %740, %732 ], [ 0.000000e+00, %727 ]
  %735 = mul nuw nsw i64 %733, %716
  %736 = getelementptr double, ptr %731, i64 %735
  %737 = load double, ptr %736, align 8
  %738 = tail call double @llvm.fabs.f64(double %737)
  %739 = fcmp ogt double %738, %734
  %740 = select i1 %739, double %738, double %734
  store double %740, ptr %730, align 8
  %741 = add nuw nsw i64 %733, 1
  %742 = icmp eq i64 %741, %718
  br i1 %742, label %743, label %732

743:
  %744 = fmul double %740, 0x3EB0C6F7A0B5ED8D
  br label %745

745:
  %746 = phi double [ %744, %743 ], [ 0.000000e+00, %727 ]
  %747 = getelementptr inbounds nuw i32, ptr %114, i64 %728
  %748 = load i32, ptr %747, align 4
  %749 = icmp eq i32 %748, 0
  br i1 %749, label %777, label %750

750:
  %751 = getelementptr double, ptr %722, i64 %728
  %752 = load double, ptr %751, align 8
  %753 = tail call double @llvm.fabs.f64(double %752)
  %754 = fmul double %710, %746
  %755 = fcmp ogt double %753, %754
  br i1 %755, label %777, label %756

756:
  %757 = sext i32 %729 to i64
  br i1 %720, label %758, label %771

758:
  %759 = mul nsw i64 %718, %757
  %760 = getelementptr double, ptr %29, i64 %759
  br label %761

761:
  %762 = phi i64 [ 0, %758 ], [ %767, %761 ]
  %763 = mul nuw nsw i64 %762, %716
  %764 = getelementptr double, ptr %731, i64 %763
  %765 = load double, ptr %764, align 8
  %766 = getelementptr double, ptr %760, i64 %762
  store double %765, ptr %766, align 8
  %767 = add nuw nsw i64 %762, 1
  %768 = icmp eq i64 %767, %718
  br i1 %768, label %769, label %761

769:
  %770 = load double, ptr %751, align 8
  br label %771

771:
  %772 = phi double [ %770, %769 ], [ %752, %756 ]
  %773 = getelementptr inbounds double, ptr %124, i64 %757
  store double %772, ptr %773, align 8
  %774 = add nsw i32 %729, 1
  %775 = getelementptr inbounds i32, ptr %118, i64 %757
  %776 = trunc nuw nsw i64 %728 to i32
  store i32 %776, ptr %775, align 4
  br label %777

777:
  %778 = phi i32 [ %729, %750 ], [ %774, %771 ], [ %729, %745 ]
  %779 = add nuw nsw i64 %728, 1
  %780 = icmp eq i64 %779, %716
  br i1 %780, label %723, label %727

781:
  %782 = phi i64 [ 0, %725 ], [ %843, %842 ]
  %783 = getelementptr inbounds nuw i32, ptr %714, i64 %782
  store i32 -1, ptr %783, align 4
  br i1 %720, label %784, label %842

784:
  %785 = mul nuw nsw i64 %782, %718
  %786 = getelementptr double, ptr %29, i64 %785
  %787 = getelementptr inbounds nuw i32, ptr %118, i64 %782
  br label %793

788:
  %789 = icmp sgt i32 %808, -1
  %790 = zext nneg i32 %808 to i64
  %791 = getelementptr double, ptr %786, i64 %790
  %792 = getelementptr inbounds nuw double, ptr %124, i64 %782
  br i1 %789, label %811, label %842

793:
  %794 = phi i32 [ -1, %784 ], [ %808, %807 ]
  %795 = phi i64 [ 0, %784 ], [ %809, %807 ]
  %796 = getelementptr double, ptr %786, i64 %795
  %797 = load double, ptr %796, align 8
  %798 = tail call double @llvm.fabs.f64(double %797)
  %799 = load i32, ptr %787, align 4
  %800 = sext i32 %799 to i64
  %801 = getelementptr inbounds double, ptr %712, i64 %800
  %802 = load double, ptr %801, align 8
  %803 = fmul double %802, 1.000000e-09
  %804 = fcmp ogt double %798, %803
  br i1 %804, label %805, label %807

805:
  %806 = trunc nuw nsw i64 %795 to i32
  store i32 %806, ptr %783, align 4
  br label %807

807:
  %808 = phi i32 [ %794, %793 ], [ %806, %805 ]
  %809 = add nuw nsw i64 %795, 1
  %810 = icmp eq i64 %809, %718
  br i1 %810, label %788, label %793

811:
  %812 = phi i64 [ %840, %839 ], [ 0, %788 ]
  %813 = icmp eq i64 %812, %782
  br i1 %813, label %839, label %814

814:
  %815 = mul nuw nsw i64 %812, %718
  %816 = getelementptr double, ptr %29, i64 %815
  %817 = getelementptr double, ptr %816, i64 %790
  %818 = load double, ptr %817, align 8
  %819 = fcmp une double %818, 0.000000e+00
  br i1 %819, label %820, label %839

820:
  %821 = load double, ptr %791, align 8
  %822 = fdiv double %818, %821
  br label %823

823:
  %824 = phi i64 [ %831, %823 ], [ 0, %820 ]
  %825 = getelementptr double, ptr %786, i64 %824
  %826 = load double, ptr %825, align 8
  %827 = fmul double %822, %826
  %828 = getelementptr double, ptr %816, i64 %824
  %829 = load double, ptr %828, align 8
  %830 = fsub double %829, %827
  store double %830, ptr %828, align 8
  %831 = add nuw nsw i64 %824, 1
  %832 = icmp eq i64 %831, %718
  br i1 %832, label %833, label %823

833:
  %834 = load double, ptr %792, align 8
  %835 = fmul double %822, %834
  %836 = getelementptr inbounds nuw double, ptr %124, i64 %812
  %837 = load double, ptr %836, align 8
  %838 = fsub double %837, %835
  store double %838, ptr %836, align 8
  br label %839

839:
  %840 = add nuw nsw i64 %812, 1
  %841 = icmp eq i64 %840, %726
  br i1 %841, label %842, label %811

842:
  %843 = add nuw nsw i64 %782, 1
  %844 = icmp eq i64 %843, %726
  br i1 %844, label %847, label %781

845:
  %846 = icmp sgt i64 %718, 0
  br i1 %846, label %866, label %875

847:
  %848 = phi i64 [ %864, %863 ], [ 0, %842 ]
  %849 = getelementptr inbounds nuw i32, ptr %714, i64 %848
  %850 = load i32, ptr %849, align 4
  %851 = icmp sgt i32 %850, -1
  br i1 %851, label %852, label %863

852:
  %853 = getelementptr inbounds nuw double, ptr %124, i64 %848
  %854 = load double, ptr %853, align 8
  %855 = fneg double %854
  %856 = mul nsw i64 %848, %718
  %857 = zext nneg i32 %850 to i64
  %858 = getelementptr double, ptr %29, i64 %856
  %859 = getelementptr double, ptr %858, i64 %857
  %860 = load double, ptr %859, align 8
  %861 = fdiv double %855, %860
  %862 = getelementptr inbounds nuw double, ptr %713, i64 %857
  store double %861, ptr %862, align 8
  br label %863

863:
  %864 = add nuw nsw i64 %848, 1
  %865 = icmp eq i64 %864, %726
  br i1 %865, label %845, label %847

866:
  %867 = phi i64 [ %873, %866 ], [ 0, %845 ]
  %868 = getelementptr inbounds nuw double, ptr %89, i64 %867
  %869 = load double, ptr %868, align 8
  %870 = getelementptr inbounds nuw double, ptr %713, i64 %867
  %871 = load double, ptr %870, align 8
  %872 = fadd double %869, %871
  store double %872, ptr %868, align 8
  %873 = add nuw nsw i64 %867, 1
  %874 = icmp eq i64 %873, %718
  br i1 %874, label %875, label %866

875:
  %876 = load i64, ptr %32, align 8
  %877 = icmp eq i64 %876, 0
  br i1 %877, label %886, label %878

878:
  %879 = load ptr, ptr %56, align 8
  tail call void %879(ptr noundef %124, ptr noundef %26, ptr noundef %23, ptr noundef %7)
  %880 = load i64, ptr %31, align 8
  %881 = shl nsw i64 %880, 4
  %882 = getelementptr inbounds i8, ptr %26, i64 %881
  %883 = load i64, ptr %32, align 8
  %884 = getelementptr inbounds double, ptr %882, i64 %883
  %885 = shl i64 %883, 3
  tail call void @llvm.memcpy.p0.p0.i64(ptr align 8 %884, ptr align 8 %124, i64 %885, i1 false)
  br label %886

886:
  %887 = or i1 %638, %693
  br i1 %887, label %888, label %692

888:
  %889 = load ptr, ptr %41, align 8
  tail call void %889(ptr noundef %6, ptr noundef %26, ptr noundef %23, ptr noundef %7)
  %890 = load i64, ptr %33, align 8
  %891 = icmp sgt i64 %890, 0
  br i1 %891, label %893, label %892

892:
  store i32 0, ptr %12, align 8
  br label %1000

893:
  %894 = mul nuw nsw i64 %890, %890
  br label %896

895:
  store i32 %959, ptr %12, align 8
  br label %963

896:
  %897 = phi i64 [ 0, %893 ], [ %961, %958 ]
  %898 = phi i32 [ 0, %893 ], [ %960, %958 ]
  %899 = phi i32 [ 0, %893 ], [ %959, %958 ]
  %900 = getelementptr inbounds nuw i32, ptr %114, i64 %897
  %901 = load i32, ptr %900, align 4
  %902 = icmp eq i32 %901, 0
  br i1 %902, label %958, label %903

903:
  %904 = load i64, ptr %31, align 8
  %905 = mul nsw i64 %904, %890
  %906 = add i64 %904, 2
  %907 = mul i64 %906, %890
  %908 = load i64, ptr %46, align 8
  %909 = getelementptr double, ptr %6, i64 %907
  %910 = shl i64 %908, 4
  %911 = getelementptr i8, ptr %909, i64 %910
  %912 = getelementptr double, ptr %911, i64 %905
  %913 = getelementptr double, ptr %912, i64 %894
  %914 = getelementptr double, ptr %913, i64 %897
  %915 = load double, ptr %914, align 8
  %916 = sext i32 %898 to i64
  %917 = getelementptr inbounds double, ptr %120, i64 %916
  store double %915, ptr %917, align 8
  %918 = add i64 %904, 1
  %919 = mul i64 %918, %890
  %920 = getelementptr double, ptr %6, i64 %919
  %921 = getelementptr double, ptr %920, i64 %897
  %922 = load double, ptr %921, align 8
  %923 = fneg double %922
  %924 = getelementptr inbounds double, ptr %121, i64 %916
  store double %923, ptr %924, align 8
  %925 = load double, ptr %921, align 8
  %926 = getelementptr inbounds double, ptr %122, i64 %916
  store double %925, ptr %926, align 8
  %927 = getelementptr inbounds nuw i32, ptr %115, i64 %897
  %928 = load i32, ptr %927, align 4
  %929 = getelementptr inbounds i32, ptr %117, i64 %916
  store i32 %928, ptr %929, align 4
  %930 = load i64, ptr %13, align 8
  %931 = icmp sgt i64 %930, 0
  br i1 %931, label %932, label %956

932:
  %933 = load ptr, ptr %54, align 8
  br label %934

934:
  %935 = phi i64 [ 0, %932 ], [ %954, %953 ]
  %936 = getelementptr inbounds nuw i32, ptr %933, i64 %935
  %937 = load i32, ptr %936, align 4
  %938 = zext i32 %937 to i64
  %939 = icmp eq i64 %897, %938
  br i1 %939, label %940, label %953

940:
  %941 = getelementptr inbounds nuw i32, ptr %112, i64 %935
  %942 = load i32, ptr %941, align 4
  %943 = icmp eq i32 %942, 0
  br i1 %943, label %953, label %944

944:
  %945 = load ptr, ptr %44, align 8
  %946 = getelementptr inbounds nuw i32, ptr %945, i64 %935
  %947 = load i32, ptr %946, align 4
  %948 = icmp sgt i32 %947, 0
  br i1 %948, label %949, label %950

949:
  store double 0x7FF0000000000000, ptr %926, align 8
  br label %953

950:
  %951 = icmp slt i32 %947, 0
  br i1 %951, label %952, label %953

952:
  store double 0xFFF0000000000000, ptr %924, align 8
  br label %953

953:
  %954 = add nuw nsw i64 %935, 1
  %955 = icmp eq i64 %954, %930
  br i1 %955, label %956, label %934

956:
  %957 = add nsw i32 %898, 1
  store i32 %957, ptr %900, align 4
  br label %958

958:
  %959 = phi i32 [ %899, %896 ], [ %957, %956 ]
  %960 = phi i32 [ %898, %896 ], [ %957, %956 ]
  %961 = add nuw nsw i64 %897, 1
  %962 = icmp eq i64 %961, %890
  br i1 %962, label %895, label %896

963:
  %964 = phi i64 [ %998, %997 ], [ 0, %895 ]
  %965 = getelementptr inbounds nuw i32, ptr %114, i64 %964
  %966 = load i32, ptr %965, align 4
  %967 = icmp eq i32 %966, 0
  %968 = add nsw i32 %966, -1
  br label %969

969:
  %970 = phi i64 [ 0, %963 ], [ %995, %994 ]
  br i1 %967, label %994, label %971

971:
  %972 = getelementptr inbounds nuw i32, ptr %114, i64 %970
  %973 = load i32, ptr %972, align 4
  %974 = icmp eq i32 %973, 0
  br i1 %974, label %994, label %975

975:
  %976 = load i64, ptr %31, align 8
  %977 = mul nsw i64 %976, %890
  %978 = add i64 %976, 2
  %979 = mul i64 %978, %890
  %980 = load i64, ptr %46, align 8
  %981 = mul nuw nsw i64 %970, %890
  %982 = getelementptr double, ptr %6, i64 %979
  %983 = shl i64 %980, 4
  %984 = getelementptr i8, ptr %982, i64 %983
  %985 = getelementptr double, ptr %984, i64 %977
  %986 = getelementptr double, ptr %985, i64 %964
  %987 = getelementptr double, ptr %986, i64 %981
  %988 = load double, ptr %987, align 8
  %989 = add nsw i32 %973, -1
  %990 = mul nsw i32 %989, %960
  %991 = add nsw i32 %968, %990
  %992 = sext i32 %991 to i64
  %993 = getelementptr inbounds double, ptr %95, i64 %992
  store double %988, ptr %993, align 8
  br label %994

994:
  %995 = add nuw nsw i64 %970, 1
  %996 = icmp eq i64 %995, %890
  br i1 %996, label %997, label %969

997:
  %998 = add nuw nsw i64 %964, 1
  %999 = icmp eq i64 %998, %890
  br i1 %999, label %1000, label %963

1000:
  br label %1001

1001:
  %1002 = call fastcc i32 @complementary(ptr noundef readonly %0, ptr noundef %12, ptr %124, ptr %118)
  %1003 = icmp eq i32 %1002, 0
  br i1 %1003, label %1371, label %1004

1004:
  %1005 = load i64, ptr %33, align 8
  %1006 = icmp sgt i64 %1005, 0
  br i1 %1006, label %1007, label %1057

1007:
  %1008 = load i64, ptr %21, align 8
  %1009 = load i64, ptr %31, align 8
  %1010 = load i64, ptr %46, align 8
  %1011 = shl i64 %1010, 1
  %1012 = shl i64 %1009, 1
  %1013 = add nuw i64 %1005, 2
  %1014 = add i64 %1013, %1012
  %1015 = mul i64 %1014, %1005
  %1016 = add i64 %1011, %1005
  %1017 = add i64 %1016, %1015
  %1018 = icmp sgt i64 %1008, %1017
  %1019 = getelementptr double, ptr %6, i64 %1017
  br label %1020

1020:
  %1021 = phi i64 [ 0, %1007 ], [ %1053, %1051 ]
  %1022 = phi i32 [ 0, %1007 ], [ %1052, %1051 ]
  br i1 %1018, label %1023, label %1051

1023:
  %1024 = getelementptr inbounds nuw i32, ptr %114, i64 %1021
  %1025 = load i32, ptr %1024, align 4
  %1026 = icmp eq i32 %1025, 0
  br i1 %1026, label %1051, label %1027

1027:
  %1028 = add nsw i32 %1025, -1
  %1029 = sext i32 %1028 to i64
  %1030 = getelementptr inbounds i32, ptr %116, i64 %1029
  %1031 = load i32, ptr %1030, align 4
  %1032 = icmp eq i32 %1031, 0
  br i1 %1032, label %1051, label %1033

1033:
  %1034 = getelementptr double, ptr %1019, i64 %1021
  %1035 = load double, ptr %1034, align 8
  %1036 = getelementptr inbounds double, ptr %122, i64 %1029
  %1037 = load double, ptr %1036, align 8
  %1038 = fcmp one double %1037, 0x7FF0000000000000
  %1039 = fcmp olt double %1035, %1037
  %1040 = select i1 %1038, i1 %1039, i1 false
  br i1 %1040, label %1041, label %1042

1041:
  store double %1035, ptr %1036, align 8
  br label %1042

1042:
  %1043 = phi i32 [ 1, %1041 ], [ %1022, %1033 ]
  %1044 = getelementptr inbounds double, ptr %121, i64 %1029
  %1045 = load double, ptr %1044, align 8
  %1046 = fcmp ueq double %1045, 0xFFF0000000000000
  br i1 %1046, label %1051, label %1047

1047:
  %1048 = fneg double %1035
  %1049 = fcmp olt double %1045, %1048
  br i1 %1049, label %1050, label %1051

1050:
  store double %1048, ptr %1044, align 8
  br label %1051

1051:
  %1052 = phi i32 [ %1022, %1020 ], [ %1022, %1027 ], [ %1022, %1023 ], [ 1, %1050 ], [ %1043, %1047 ], [ %1043, %1042 ]
  %1053 = add nuw nsw i64 %1021, 1
  %1054 = icmp eq i64 %1053, %1005
  br i1 %1054, label %1055, label %1020

1055:
  %1056 = icmp eq i32 %1052, 0
  br i1 %1056, label %1057, label %1001

1057:
  call fastcc void @balance(ptr noundef nonnull readonly %0, ptr noundef %12, ptr %124, ptr %118)
  %1058 = load i64, ptr %33, align 8
  %1059 = icmp sgt i64 %1058, 0
  br i1 %1059, label %1066, label %1060

1060:
  %1061 = load i64, ptr %13, align 8
  %1062 = icmp sgt i64 %1061, 0
  br i1 %1062, label %1063, label %1118

1063:
  %1064 = load ptr, ptr %54, align 8
  %1065 = load ptr, ptr %44, align 8
  br label %1080

1066:
  %1067 = phi i64 [ %1078, %1077 ], [ 0, %1057 ]
  %1068 = getelementptr inbounds nuw i32, ptr %114, i64 %1067
  %1069 = load i32, ptr %1068, align 4
  %1070 = icmp eq i32 %1069, 0
  br i1 %1070, label %1077, label %1071

1071:
  %1072 = sext i32 %1069 to i64
  %1073 = getelementptr double, ptr %123, i64 %1072
  %1074 = getelementptr i8, ptr %1073, i64 -8
  %1075 = load double, ptr %1074, align 8
  %1076 = getelementptr inbounds nuw double, ptr %92, i64 %1067
  store double %1075, ptr %1076, align 8
  br label %1077

1077:
  %1078 = add nuw nsw i64 %1067, 1
  %1079 = icmp eq i64 %1078, %1058
  br i1 %1079, label %1060, label %1066

1080:
  %1081 = phi i64 [ 0, %1063 ], [ %1116, %1115 ]
  %1082 = getelementptr inbounds nuw i32, ptr %1064, i64 %1081
  %1083 = load i32, ptr %1082, align 4
  %1084 = sext i32 %1083 to i64
  %1085 = getelementptr inbounds i32, ptr %114, i64 %1084
  %1086 = load i32, ptr %1085, align 4
  %1087 = getelementptr inbounds nuw i32, ptr %1065, i64 %1081
  %1088 = load i32, ptr %1087, align 4
  %1089 = icmp eq i32 %1088, 0
  %1090 = icmp ne i32 %1086, 0
  %1091 = select i1 %1089, i1 %1090, i1 false
  br i1 %1091, label %1092, label %1100

1092:
  %1093 = sext i32 %1086 to i64
  %1094 = getelementptr i32, ptr %116, i64 %1093
  %1095 = getelementptr i8, ptr %1094, i64 -4
  %1096 = load i32, ptr %1095, align 4
  %1097 = sitofp i32 %1096 to double
  %1098 = fneg double %1097
  %1099 = getelementptr inbounds nuw double, ptr %15, i64 %1081
  store double %1098, ptr %1099, align 8
  br label %1100

1100:
  %1101 = getelementptr inbounds nuw i32, ptr %112, i64 %1081
  %1102 = load i32, ptr %1101, align 4
  %1103 = icmp eq i32 %1102, 0
  br i1 %1103, label %1115, label %1104

1104:
  br i1 %1090, label %1105, label %1112

1105:
  %1106 = sext i32 %1086 to i64
  %1107 = getelementptr i32, ptr %116, i64 %1106
  %1108 = getelementptr i8, ptr %1107, i64 -4
  %1109 = load i32, ptr %1108, align 4
  %1110 = icmp eq i32 %1109, 0
  %1111 = select i1 %1110, double 0.000000e+00, double -1.000000e+00
  br label %1112

1112:
  %1113 = phi double [ -1.000000e+00, %1104 ], [ %1111, %1105 ]
  %1114 = getelementptr inbounds nuw double, ptr %15, i64 %1081
  store double %1113, ptr %1114, align 8
  br label %1115

1115:
  %1116 = add nuw nsw i64 %1081, 1
  %1117 = icmp eq i64 %1116, %1061
  br i1 %1117, label %1118, label %1080

1118:
  br i1 %638, label %1286, label %1119

1119:
  %1120 = load i64, ptr %31, align 8
  %1121 = mul nsw i64 %1120, %1058
  %1122 = add i64 %1120, 2
  %1123 = mul i64 %1122, %1058
  %1124 = load i64, ptr %46, align 8
  %1125 = getelementptr double, ptr %6, i64 %1123
  %1126 = shl i64 %1124, 4
  %1127 = getelementptr i8, ptr %1125, i64 %1126
  %1128 = getelementptr double, ptr %1127, i64 %1121
  %1129 = getelementptr double, ptr %124, i64 %1061
  %1130 = shl i64 %1058, 4
  %1131 = getelementptr i8, ptr %1129, i64 %1130
  %1132 = mul i64 %1058, -2
  %1133 = sub i64 %1132, %1061
  %1134 = getelementptr inbounds double, ptr %1131, i64 %1133
  %1135 = getelementptr inbounds double, ptr %1131, i64 %1132
  %1136 = getelementptr inbounds double, ptr %1135, i64 %1058
  %1137 = getelementptr inbounds double, ptr %26, i64 %1120
  %1138 = load i64, ptr %32, align 8
  %1139 = getelementptr inbounds double, ptr %1137, i64 %1138
  %1140 = icmp sgt i64 %1120, 0
  br i1 %1140, label %1141, label %1154

1141:
  %1142 = phi double [ %1149, %1141 ], [ 0.000000e+00, %1119 ]
  %1143 = phi i64 [ %1144, %1141 ], [ %1120, %1119 ]
  %1144 = add nsw i64 %1143, -1
  %1145 = getelementptr inbounds double, ptr %1139, i64 %1144
  %1146 = load double, ptr %1145, align 8
  %1147 = tail call double @llvm.fabs.f64(double %1146)
  %1148 = fcmp ogt double %1147, %1142
  %1149 = select i1 %1148, double %1147, double %1142
  %1150 = icmp samesign ugt i64 %1143, 1
  br i1 %1150, label %1141, label %1151

1151:
  %1152 = fadd double %1149, 1.000000e+00
  %1153 = fmul double %1152, 0x3EB0C6F7A0B5ED8D
  br label %1154

1154:
  %1155 = phi double [ 0x3EB0C6F7A0B5ED8D, %1119 ], [ %1153, %1151 ]
  br i1 %1062, label %1156, label %1172

1156:
  %1157 = load i64, ptr %24, align 8
  %1158 = load i64, ptr %30, align 8
  %1159 = sub nsw i64 %1157, %1158
  %1160 = load ptr, ptr %42, align 8
  %1161 = getelementptr double, ptr %23, i64 %1159
  br label %1162

1162:
  %1163 = phi i64 [ 0, %1156 ], [ %1170, %1162 ]
  %1164 = getelementptr inbounds nuw double, ptr %15, i64 %1163
  %1165 = load double, ptr %1164, align 8
  %1166 = getelementptr inbounds nuw i32, ptr %1160, i64 %1163
  %1167 = load i32, ptr %1166, align 4
  %1168 = sext i32 %1167 to i64
  %1169 = getelementptr double, ptr %1161, i64 %1168
  store double %1165, ptr %1169, align 8
  %1170 = add nuw nsw i64 %1163, 1
  %1171 = icmp eq i64 %1170, %1061
  br i1 %1171, label %1172, label %1162

1172:
  %1173 = load ptr, ptr %57, align 8
  tail call void %1173(ptr noundef %1134, ptr noundef %26, ptr noundef %23, ptr noundef %7)
  %1174 = load i64, ptr %33, align 8
  %1175 = icmp sgt i64 %1174, 0
  br i1 %1175, label %1176, label %1189

1176:
  %1177 = load i64, ptr %31, align 8
  %1178 = mul nsw i64 %1177, %1174
  %1179 = add i64 %1177, 2
  %1180 = mul i64 %1179, %1174
  %1181 = load i64, ptr %46, align 8
  %1182 = mul nuw nsw i64 %1174, %1174
  %1183 = getelementptr double, ptr %6, i64 %1180
  %1184 = shl i64 %1181, 4
  %1185 = getelementptr i8, ptr %1183, i64 %1184
  %1186 = getelementptr double, ptr %1185, i64 %1178
  %1187 = getelementptr double, ptr %1186, i64 %1182
  %1188 = add nuw nsw i64 %1174, 1
  br label %1198

1189:
  %1190 = phi double [ 0.000000e+00, %1172 ], [ %1228, %1218 ]
  %1191 = load i64, ptr %13, align 8
  %1192 = icmp sgt i64 %1191, 0
  br i1 %1192, label %1193, label %1372

1193:
  %1194 = load ptr, ptr %54, align 8
  %1195 = load ptr, ptr %44, align 8
  %1196 = add i64 %1174, 1
  %1197 = fneg double %1190
  br label %1231

1198:
  %1199 = phi i64 [ 0, %1176 ], [ %1229, %1218 ]
  %1200 = phi double [ 0.000000e+00, %1176 ], [ %1228, %1218 ]
  %1201 = getelementptr double, ptr %1128, i64 %1199
  %1202 = getelementptr double, ptr %1187, i64 %1199
  %1203 = load double, ptr %1202, align 8
  %1204 = tail call double @llvm.fabs.f64(double %1203)
  br label %1205

1205:
  %1206 = phi i64 [ 0, %1198 ], [ %1216, %1205 ]
  %1207 = phi double [ %1204, %1198 ], [ %1215, %1205 ]
  %1208 = mul nuw nsw i64 %1206, %1174
  %1209 = getelementptr double, ptr %1201, i64 %1208
  %1210 = load double, ptr %1209, align 8
  %1211 = getelementptr inbounds nuw double, ptr %92, i64 %1206
  %1212 = load double, ptr %1211, align 8
  %1213 = fmul double %1210, %1212
  %1214 = tail call double @llvm.fabs.f64(double %1213)
  %1215 = fadd double %1207, %1214
  %1216 = add nuw nsw i64 %1206, 1
  %1217 = icmp eq i64 %1216, %1174
  br i1 %1217, label %1218, label %1205

1218:
  %1219 = fmul double %1215, 0x3EB0C6F7A0B5ED8D
  %1220 = mul i64 %1199, %1188
  %1221 = getelementptr inbounds double, ptr %1128, i64 %1220
  %1222 = load double, ptr %1221, align 8
  %1223 = fcmp ogt double %1222, 1.000000e-300
  %1224 = select i1 %1223, double %1222, double 1.000000e-300
  %1225 = tail call double @llvm.sqrt.f64(double %1224)
  %1226 = fdiv double %1219, %1225
  %1227 = fcmp ogt double %1226, %1200
  %1228 = select i1 %1227, double %1226, double %1200
  %1229 = add nuw nsw i64 %1199, 1
  %1230 = icmp eq i64 %1229, %1174
  br i1 %1230, label %1189, label %1198

1231:
  %1232 = phi i64 [ 0, %1193 ], [ %1284, %1283 ]
  %1233 = getelementptr inbounds nuw i32, ptr %1194, i64 %1232
  %1234 = load i32, ptr %1233, align 4
  %1235 = getelementptr inbounds nuw i32, ptr %1195, i64 %1232
  %1236 = load i32, ptr %1235, align 4
  %1237 = sext i32 %1234 to i64
  %1238 = mul i64 %1196, %1237
  %1239 = getelementptr inbounds double, ptr %1128, i64 %1238
  %1240 = load double, ptr %1239, align 8
  %1241 = fcmp ogt double %1240, 1.000000e-300
  %1242 = select i1 %1241, double %1240, double 1.000000e-300
  %1243 = tail call double @llvm.sqrt.f64(double %1242)
  %1244 = getelementptr inbounds i32, ptr %114, i64 %1237
  %1245 = load i32, ptr %1244, align 4
  %1246 = icmp eq i32 %1245, 0
  br i1 %1246, label %1283, label %1247

1247:
  %1248 = getelementptr inbounds nuw double, ptr %15, i64 %1232
  %1249 = load double, ptr %1248, align 8
  %1250 = fcmp oeq double %1249, 0.000000e+00
  br i1 %1250, label %1251, label %1271

1251:
  %1252 = getelementptr inbounds double, ptr %1135, i64 %1237
  %1253 = load double, ptr %1252, align 8
  %1254 = tail call double @llvm.fabs.f64(double %1253)
  %1255 = fcmp ogt double %1254, %1155
  br i1 %1255, label %1371, label %1256

1256:
  %1257 = getelementptr inbounds nuw double, ptr %1134, i64 %1232
  %1258 = load double, ptr %1257, align 8
  %1259 = fdiv double %1190, %1243
  %1260 = load i64, ptr %31, align 8
  %1261 = add i64 %1260, 1
  %1262 = mul i64 %1261, %1174
  %1263 = getelementptr double, ptr %6, i64 %1262
  %1264 = getelementptr double, ptr %1263, i64 %1237
  %1265 = load double, ptr %1264, align 8
  %1266 = tail call double @llvm.fabs.f64(double %1265)
  %1267 = fmul double %1266, 0x3EB0C6F7A0B5ED8D
  %1268 = fadd double %1259, %1267
  %1269 = fneg double %1268
  %1270 = fcmp olt double %1258, %1269
  br i1 %1270, label %1371, label %1283

1271:
  %1272 = icmp eq i32 %1236, 0
  %1273 = fcmp olt double %1249, 0.000000e+00
  %1274 = or i1 %1272, %1273
  br i1 %1274, label %1275, label %1283

1275:
  %1276 = sitofp i32 %1236 to double
  %1277 = select i1 %1272, double %1249, double %1276
  %1278 = getelementptr inbounds double, ptr %1136, i64 %1237
  %1279 = load double, ptr %1278, align 8
  %1280 = fmul double %1277, %1279
  %1281 = fmul double %1243, %1197
  %1282 = fcmp olt double %1280, %1281
  br i1 %1282, label %1371, label %1283

1283:
  %1284 = add nuw nsw i64 %1232, 1
  %1285 = icmp eq i64 %1284, %1191
  br i1 %1285, label %1286, label %1231

1286:
  %1287 = phi i64 [ %1058, %1118 ], [ %1174, %1283 ]
  %1288 = phi i64 [ %1061, %1118 ], [ %1191, %1283 ]
  %1289 = icmp sgt i64 %1288, 0
  br i1 %1289, label %1290, label %1372

1290:
  %1291 = load ptr, ptr %44, align 8
  %1292 = load i64, ptr %31, align 8
  %1293 = mul nsw i64 %1292, %1287
  %1294 = add i64 %1292, 2
  %1295 = mul i64 %1294, %1287
  %1296 = load i64, ptr %46, align 8
  %1297 = mul nsw i64 %1287, %1287
  %1298 = load ptr, ptr %54, align 8
  %1299 = getelementptr double, ptr %6, i64 %1295
  %1300 = shl i64 %1296, 4
  %1301 = getelementptr i8, ptr %1299, i64 %1300
  %1302 = getelementptr double, ptr %1301, i64 %1293
  %1303 = getelementptr double, ptr %1302, i64 %1297
  %1304 = trunc i64 %1287 to i32
  %1305 = icmp sgt i32 %1304, 0
  %1306 = and i64 %1287, 2147483647
  %1307 = getelementptr double, ptr %6, i64 %1293
  %1308 = shl i64 %1288, 5
  %1309 = getelementptr i8, ptr %8, i64 %1308
  br label %1310

1310:
  %1311 = phi i64 [ 0, %1290 ], [ %1367, %1365 ]
  %1312 = phi i32 [ 0, %1290 ], [ %1366, %1365 ]
  %1313 = getelementptr inbounds nuw i32, ptr %1291, i64 %1311
  %1314 = load i32, ptr %1313, align 4
  %1315 = sitofp i32 %1314 to double
  %1316 = getelementptr inbounds nuw i32, ptr %1298, i64 %1311
  %1317 = load i32, ptr %1316, align 4
  %1318 = sext i32 %1317 to i64
  %1319 = getelementptr double, ptr %1303, i64 %1318
  %1320 = load double, ptr %1319, align 8
  br i1 %1305, label %1321, label %1335

1321:
  %1322 = getelementptr double, ptr %1302, i64 %1318
  br label %1323

1323:
  %1324 = phi i64 [ 0, %1321 ], [ %1333, %1323 ]
  %1325 = phi double [ 0.000000e+00, %1321 ], [ %1332, %1323 ]
  %1326 = mul nuw nsw i64 %1324, %1306
  %1327 = getelementptr double, ptr %1322, i64 %1326
  %1328 = load double, ptr %1327, align 8
  %1329 = getelementptr inbounds nuw double, ptr %92, i64 %1324
  %1330 = load double, ptr %1329, align 8
  %1331 = fmul double %1328, %1330
  %1332 = fadd double %1325, %1331
  %1333 = add nuw nsw i64 %1324, 1
  %1334 = icmp eq i64 %1333, %1306
  br i1 %1334, label %1335, label %1323

1335:
  %1336 = phi double [ 0.000000e+00, %1310 ], [ %1332, %1323 ]
  %1337 = fadd double %1320, %1336
  %1338 = getelementptr double, ptr %1307, i64 %1318
  %1339 = load double, ptr %1338, align 8
  %1340 = fmul double %1339, %1315
  %1341 = fneg double %1315
  %1342 = fmul double %1337, %1341
  %1343 = getelementptr inbounds nuw double, ptr %93, i64 %1311
  %1344 = load double, ptr %1343, align 8
  %1345 = fsub double 1.000000e+00, %1344
  %1346 = fmul double %1342, %1345
  %1347 = fmul double %1346, 1.000000e-04
  %1348 = getelementptr inbounds nuw i32, ptr %113, i64 %1311
  %1349 = load i32, ptr %1348, align 4
  %1350 = icmp eq i32 %1349, 0
  br i1 %1350, label %1365, label %1351

1351:
  %1352 = getelementptr inbounds nuw i32, ptr %18, i64 %1311
  %1353 = load i32, ptr %1352, align 4
  %1354 = icmp eq i32 %1353, 0
  br i1 %1354, label %1355, label %1365

1355:
  %1356 = fmul double %1340, 2.000000e+00
  %1357 = fcmp ogt double %1356, 0.000000e+00
  %1358 = fcmp olt double %1356, %1347
  %1359 = select i1 %1357, i1 %1358, i1 false
  br i1 %1359, label %1360, label %1365

1360:
  store i32 1, ptr %1352, align 4
  br i1 %43, label %1365, label %1361

1361:
  %1362 = fdiv double %1356, %1347
  %1363 = fmul double %1362, 1.000000e-04
  %1364 = getelementptr double, ptr %1309, i64 %1311
  store double %1363, ptr %1364, align 8
  br label %1365

1365:
  %1366 = phi i32 [ %1312, %1335 ], [ %1312, %1355 ], [ %1312, %1351 ], [ 1, %1361 ], [ 1, %1360 ]
  %1367 = add nuw nsw i64 %1311, 1
  %1368 = icmp eq i64 %1367, %1288
  br i1 %1368, label %1369, label %1310

1369:
  %1370 = icmp eq i32 %1366, 0
  br i1 %1370, label %1373, label %58

1371:
  br label %1390

1372:
  br label %1373

1373:
  %1374 = load i64, ptr %27, align 8
  %1375 = shl i64 %1374, 3
  tail call void @llvm.memcpy.p0.p0.i64(ptr align 8 %1, ptr align 8 %26, i64 %1375, i1 false)
  %1376 = load i64, ptr %13, align 8
  %1377 = icmp sgt i64 %1376, 0
  br i1 %1377, label %1378, label %1390

1378:
  %1379 = load ptr, ptr %42, align 8
  br label %1380

1380:
  %1381 = phi i64 [ 0, %1378 ], [ %1388, %1380 ]
  %1382 = getelementptr inbounds nuw double, ptr %15, i64 %1381
  %1383 = load double, ptr %1382, align 8
  %1384 = getelementptr inbounds nuw i32, ptr %1379, i64 %1381
  %1385 = load i32, ptr %1384, align 4
  %1386 = sext i32 %1385 to i64
  %1387 = getelementptr inbounds double, ptr %2, i64 %1386
  store double %1383, ptr %1387, align 8
  %1388 = add nuw nsw i64 %1381, 1
  %1389 = icmp eq i64 %1388, %1376
  br i1 %1389, label %1390, label %1380

1390:
  %1391 = phi i32 [ 0, %1371 ], [ 1, %1373 ], [ 1, %1380 ]
  ret i32 %1391
}

define range(i32 0, 2) i32 @next_jump(ptr noundef readonly captures(none) %0, ptr noundef writeonly captures(none) %1, ptr noundef %2, double noundef %3, double noundef %4, ptr noundef %5) {
  %7 = alloca %struct.Run, align 8
  %8 = getelementptr inbounds nuw i8, ptr %7, i64 144
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(48) %8, i8 0, i64 48, i1 false)
  %9 = getelementptr inbounds nuw i8, ptr %7, i64 120
  store ptr %2, ptr %9, align 8
  %10 = getelementptr inbounds nuw i8, ptr %7, i64 128
  store ptr %2, ptr %10, align 8
  %11 = getelementptr inbounds nuw i8, ptr %0, i64 40
  %12 = load i64, ptr %11, align 8
  %13 = getelementptr inbounds double, ptr %2, i64 %12
  %14 = load double, ptr %13, align 8
  %15 = getelementptr inbounds nuw i8, ptr %7, i64 136
  store double %14, ptr %15, align 8
  %16 = getelementptr inbounds nuw i8, ptr %0, i64 112
  %17 = load i64, ptr %16, align 8
  %18 = getelementptr inbounds double, ptr %5, i64 %17
  %19 = getelementptr inbounds nuw i8, ptr %7, i64 8
  store ptr %18, ptr %19, align 8
  %20 = getelementptr inbounds nuw i8, ptr %7, i64 16
  store ptr %5, ptr %20, align 8
  %21 = getelementptr inbounds nuw i8, ptr %0, i64 16
  %22 = load i64, ptr %21, align 8
  %23 = getelementptr inbounds double, ptr %5, i64 %22
  %24 = getelementptr inbounds nuw i8, ptr %7, i64 24
  store ptr %23, ptr %24, align 8
  %25 = getelementptr inbounds double, ptr %23, i64 %22
  %26 = getelementptr inbounds nuw i8, ptr %7, i64 32
  store ptr %25, ptr %26, align 8
  %27 = getelementptr inbounds double, ptr %25, i64 %22
  %28 = getelementptr inbounds nuw i8, ptr %7, i64 40
  store ptr %27, ptr %28, align 8
  %29 = load i64, ptr %0, align 8
  %30 = getelementptr inbounds double, ptr %27, i64 %29
  %31 = getelementptr inbounds nuw i8, ptr %7, i64 48
  store ptr %30, ptr %31, align 8
  %32 = getelementptr inbounds nuw i8, ptr %0, i64 24
  %33 = load i64, ptr %32, align 8
  %34 = getelementptr inbounds double, ptr %30, i64 %33
  %35 = getelementptr inbounds nuw i8, ptr %0, i64 32
  %36 = load i64, ptr %35, align 8
  %37 = getelementptr inbounds double, ptr %34, i64 %36
  %38 = getelementptr inbounds nuw i8, ptr %7, i64 56
  store ptr %37, ptr %38, align 8
  %39 = getelementptr inbounds double, ptr %37, i64 %36
  %40 = getelementptr inbounds nuw i8, ptr %7, i64 64
  store ptr %39, ptr %40, align 8
  %41 = getelementptr inbounds nuw i8, ptr %0, i64 56
  %42 = load i64, ptr %41, align 8
  %43 = mul i64 %42, 4000
  %44 = getelementptr i8, ptr %39, i64 %43
  %45 = getelementptr i8, ptr %44, i64 4000
  %46 = getelementptr inbounds nuw i8, ptr %7, i64 72
  store ptr %45, ptr %46, align 8
  %47 = getelementptr inbounds nuw i8, ptr %0, i64 336
  %48 = load i64, ptr %47, align 8
  %49 = getelementptr inbounds double, ptr %45, i64 %48
  %50 = getelementptr inbounds nuw i8, ptr %7, i64 80
  store ptr %49, ptr %50, align 8
  %51 = getelementptr double, ptr %49, i64 %42
  %52 = getelementptr i8, ptr %51, i64 8
  %53 = getelementptr inbounds nuw i8, ptr %7, i64 88
  store ptr %52, ptr %53, align 8
  %54 = getelementptr double, ptr %52, i64 %42
  %55 = getelementptr i8, ptr %54, i64 8
  %56 = getelementptr inbounds nuw i8, ptr %7, i64 96
  store ptr %55, ptr %56, align 8
  %57 = getelementptr inbounds nuw i8, ptr %0, i64 72
  %58 = load i64, ptr %57, align 8
  %59 = getelementptr inbounds double, ptr %55, i64 %58
  %60 = getelementptr inbounds nuw i8, ptr %7, i64 112
  store ptr %59, ptr %60, align 8
  %61 = shl nsw i64 %58, 5
  %62 = getelementptr inbounds i8, ptr %59, i64 %61
  %63 = getelementptr inbounds nuw i8, ptr %7, i64 104
  store ptr %62, ptr %63, align 8
  %64 = getelementptr inbounds nuw i8, ptr %62, i64 1536
  %65 = getelementptr inbounds nuw i8, ptr %0, i64 344
  %66 = load i64, ptr %65, align 8
  %67 = getelementptr inbounds double, ptr %64, i64 %66
  %68 = getelementptr inbounds nuw i8, ptr %7, i64 160
  store ptr %67, ptr %68, align 8
  %69 = shl i64 %33, 3
  tail call void @llvm.memcpy.p0.p0.i64(ptr align 8 %30, ptr align 8 %2, i64 %69, i1 false)
  %70 = load i64, ptr %32, align 8
  %71 = getelementptr inbounds double, ptr %30, i64 %70
  %72 = load i64, ptr %35, align 8
  %73 = shl i64 %72, 3
  tail call void @llvm.memcpy.p0.p0.i64(ptr align 8 %71, ptr align 8 %2, i64 %73, i1 false)
  %74 = load i64, ptr %0, align 8
  %75 = getelementptr inbounds nuw i8, ptr %0, i64 96
  %76 = load i64, ptr %75, align 8
  %77 = getelementptr double, ptr %64, i64 %74
  %78 = getelementptr double, ptr %77, i64 %76
  %79 = add nsw i64 %76, %74
  %80 = sub i64 0, %79
  %81 = getelementptr inbounds double, ptr %78, i64 %80
  %82 = load i64, ptr %11, align 8
  %83 = getelementptr inbounds double, ptr %2, i64 %82
  %84 = load double, ptr %83, align 8
  %85 = fmul double %84, 6.400000e+01
  %86 = shl i64 %79, 3
  tail call void @llvm.memset.p0.i64(ptr align 8 %81, i8 0, i64 %86, i1 false)
  store ptr %81, ptr %7, align 8
  %87 = load i64, ptr %35, align 8
  %88 = shl i64 %87, 3
  tail call void @llvm.memcpy.p0.p0.i64(ptr align 8 %37, ptr align 8 %2, i64 %88, i1 false)
  %89 = load i64, ptr %0, align 8
  %90 = getelementptr inbounds double, ptr %81, i64 %89
  store double -1.000000e+300, ptr %90, align 8
  br label %91

91:
  %92 = phi double [ %3, %6 ], [ %115, %133 ]
  %93 = phi double [ %85, %6 ], [ %135, %133 ]
  %94 = fadd double %92, %93
  %95 = fcmp olt double %94, %4
  %96 = select i1 %95, double %94, double %4
  %97 = call fastcc i32 @changes(ptr noundef nonnull %0, ptr noundef %7, double noundef %92, double noundef %96, ptr noundef %62)
  %98 = icmp slt i32 %97, 0
  br i1 %98, label %99, label %113

99:
  %100 = phi double [ %107, %106 ], [ %93, %91 ]
  %101 = load i64, ptr %11, align 8
  %102 = getelementptr inbounds double, ptr %2, i64 %101
  %103 = load double, ptr %102, align 8
  %104 = fmul double %103, 0x3EB0C6F7A0B5ED8D
  %105 = fcmp olt double %100, %104
  br i1 %105, label %136, label %106

106:
  %107 = fmul double %100, 5.000000e-01
  %108 = fadd double %92, %107
  %109 = fcmp olt double %108, %4
  %110 = select i1 %109, double %108, double %4
  %111 = call fastcc i32 @changes(ptr noundef nonnull %0, ptr noundef %7, double noundef %92, double noundef %110, ptr noundef %62)
  %112 = icmp slt i32 %111, 0
  br i1 %112, label %99, label %113

113:
  %114 = phi double [ %93, %91 ], [ %107, %106 ]
  %115 = phi double [ %96, %91 ], [ %110, %106 ]
  %116 = phi i32 [ %97, %91 ], [ %111, %106 ]
  %117 = icmp eq i32 %116, 0
  %118 = fcmp ult double %115, %4
  %119 = and i1 %117, %118
  br i1 %119, label %133, label %120

120:
  br i1 %117, label %121, label %123

121:
  store double %4, ptr %1, align 8
  %122 = getelementptr inbounds nuw i8, ptr %1, i64 8
  store double %4, ptr %122, align 8
  br label %130

123:
  %124 = load double, ptr %62, align 8
  store double %124, ptr %1, align 8
  %125 = getelementptr inbounds nuw i8, ptr %62, i64 8
  %126 = load double, ptr %125, align 8
  %127 = getelementptr inbounds nuw i8, ptr %1, i64 8
  store double %126, ptr %127, align 8
  %128 = getelementptr inbounds nuw i8, ptr %62, i64 16
  %129 = load double, ptr %128, align 8
  br label %130

130:
  %131 = phi double [ %129, %123 ], [ %4, %121 ]
  %132 = getelementptr inbounds nuw i8, ptr %1, i64 16
  store double %131, ptr %132, align 8
  br label %136

133:
  %134 = fmul double %114, 5.000000e-01
  %135 = fmul double %134, 4.000000e+00
  br label %91

136:
  %137 = phi i32 [ 1, %130 ], [ 0, %99 ]
  ret i32 %137
}

declare void @llvm.memset.p0.i64(ptr writeonly captures(none), i8, i64, i1 immarg)

declare void @llvm.memcpy.p0.p0.i64(ptr noalias writeonly captures(none), ptr noalias readonly captures(none), i64, i1 immarg)

define internal fastcc range(i32 -2147483647, -2147483648) i32 @changes(ptr noundef readonly captures(none) %0, ptr noundef nonnull readonly captures(none) %1, double noundef %2, double noundef %3, ptr noundef captures(none) %4) unnamed_addr {
  %6 = alloca double, align 8
  %7 = alloca double, align 8
  %8 = alloca double, align 8
  %9 = alloca double, align 8
  %10 = alloca double, align 8
  %11 = alloca [64 x double], align 16
  %12 = alloca [64 x double], align 16
  %13 = alloca i32, align 4
  %14 = getelementptr inbounds nuw i8, ptr %1, i64 112
  %15 = load ptr, ptr %14, align 8
  %16 = getelementptr inbounds nuw i8, ptr %0, i64 72
  %17 = load i64, ptr %16, align 8
  %18 = icmp sgt i64 %17, 0
  br i1 %18, label %19, label %293

19:
  %20 = getelementptr inbounds nuw i8, ptr %0, i64 504
  %21 = getelementptr inbounds nuw i8, ptr %1, i64 56
  %22 = getelementptr inbounds nuw i8, ptr %1, i64 136
  %23 = getelementptr inbounds nuw i8, ptr %1, i64 96
  %24 = getelementptr inbounds nuw i8, ptr %0, i64 496
  %25 = getelementptr inbounds nuw i8, ptr %1, i64 8
  br label %31

26:
  %27 = icmp sgt i32 %247, 0
  br i1 %27, label %28, label %293

28:
  %29 = getelementptr inbounds nuw i8, ptr %1, i64 136
  %30 = zext nneg i32 %247 to i64
  br label %255

31:
  %32 = phi i64 [ 0, %19 ], [ %252, %251 ]
  %33 = phi i32 [ 0, %19 ], [ %247, %251 ]
  store double %2, ptr %11, align 16
  store double %3, ptr %12, align 16
  %34 = shl nuw nsw i64 %32, 5
  %35 = getelementptr inbounds nuw i8, ptr %15, i64 %34
  %36 = getelementptr inbounds nuw i8, ptr %35, i64 8
  %37 = getelementptr inbounds nuw i8, ptr %35, i64 16
  %38 = getelementptr inbounds nuw i8, ptr %35, i64 24
  br label %39

39:
  %40 = phi i32 [ 1, %31 ], [ %248, %246 ]
  %41 = phi i32 [ %33, %31 ], [ %247, %246 ]
  store i32 0, ptr %13, align 4
  %42 = add nsw i32 %40, -1
  %43 = zext nneg i32 %42 to i64
  %44 = getelementptr inbounds nuw double, ptr %11, i64 %43
  %45 = load double, ptr %44, align 8
  %46 = getelementptr inbounds nuw double, ptr %12, i64 %43
  %47 = load double, ptr %46, align 8
  %48 = load ptr, ptr %20, align 8
  %49 = load ptr, ptr %21, align 8
  call void %48(ptr noundef %15, ptr noundef nonnull %13, double noundef %45, double noundef %47, ptr noundef %49)
  %50 = load double, ptr %35, align 8
  %51 = fcmp ogt double %50, 0.000000e+00
  br i1 %51, label %246, label %52

52:
  %53 = load double, ptr %36, align 8
  %54 = fcmp olt double %53, 0.000000e+00
  br i1 %54, label %246, label %55

55:
  %56 = load double, ptr %37, align 8
  %57 = fcmp ogt double %56, 0.000000e+00
  br i1 %57, label %64, label %58

58:
  %59 = load double, ptr %38, align 8
  %60 = fcmp olt double %59, 0.000000e+00
  %61 = load i32, ptr %13, align 4
  %62 = icmp eq i32 %61, 0
  %63 = select i1 %60, i1 %62, i1 false
  br i1 %63, label %74, label %67

64:
  %65 = load i32, ptr %13, align 4
  %66 = icmp eq i32 %65, 0
  br i1 %66, label %74, label %67

67:
  %68 = fsub double %47, %45
  %69 = load double, ptr %22, align 8
  %70 = fmul double %69, 4.096000e-09
  %71 = fcmp ole double %68, %70
  %72 = icmp samesign ugt i32 %40, 62
  %73 = or i1 %72, %71
  br i1 %73, label %74, label %239

74:
  store double %45, ptr %10, align 8
  %75 = load ptr, ptr %23, align 8
  %76 = load ptr, ptr %24, align 8
  %77 = load ptr, ptr %21, align 8
  %78 = load ptr, ptr %25, align 8
  call void %76(ptr noundef %75, ptr noundef nonnull %10, ptr noundef %77, ptr noundef %78)
  %79 = getelementptr inbounds nuw double, ptr %75, i64 %32
  %80 = load double, ptr %79, align 8
  store double %47, ptr %9, align 8
  %81 = load ptr, ptr %23, align 8
  %82 = load ptr, ptr %24, align 8
  %83 = load ptr, ptr %21, align 8
  %84 = load ptr, ptr %25, align 8
  call void %82(ptr noundef %81, ptr noundef nonnull %9, ptr noundef %83, ptr noundef %84)
  %85 = getelementptr inbounds nuw double, ptr %81, i64 %32
  %86 = load double, ptr %85, align 8
  %87 = fcmp ogt double %86, %80
  %88 = select i1 %87, double 1.000000e+00, double -1.000000e+00
  %89 = fcmp oge double %80, 0.000000e+00
  %90 = fcmp ult double %86, 0.000000e+00
  %91 = xor i1 %89, %90
  br i1 %91, label %246, label %92

92:
  %93 = fneg double %88
  %94 = fmul double %80, %93
  %95 = fcmp ule double %94, 0.000000e+00
  %96 = fsub double %47, %45
  %97 = fmul double %96, 1.000000e-18
  %98 = select i1 %95, double %45, double %47
  %99 = fsub double %98, %45
  %100 = fmul double %99, 5.000000e-01
  %101 = fadd double %45, %100
  %102 = fcmp olt double %45, %101
  %103 = fcmp olt double %101, %98
  %104 = and i1 %102, %103
  %105 = fcmp ogt double %99, %97
  %106 = and i1 %105, %104
  br i1 %106, label %107, label %130

107:
  %108 = phi double [ %124, %107 ], [ %101, %92 ]
  %109 = phi double [ %121, %107 ], [ %45, %92 ]
  %110 = phi double [ %120, %107 ], [ %98, %92 ]
  store double %108, ptr %8, align 8
  %111 = load ptr, ptr %23, align 8
  %112 = load ptr, ptr %24, align 8
  %113 = load ptr, ptr %21, align 8
  %114 = load ptr, ptr %25, align 8
  call void %112(ptr noundef %111, ptr noundef nonnull %8, ptr noundef %113, ptr noundef %114)
  %115 = getelementptr inbounds nuw double, ptr %111, i64 %32
  %116 = load double, ptr %115, align 8
  %117 = fcmp uge double %116, 0.000000e+00
  %118 = fcmp ule double %116, 0.000000e+00
  %119 = select i1 %87, i1 %117, i1 %118
  %120 = select i1 %119, double %108, double %110
  %121 = select i1 %119, double %109, double %108
  %122 = fsub double %120, %121
  %123 = fmul double %122, 5.000000e-01
  %124 = fadd double %121, %123
  %125 = fcmp olt double %121, %124
  %126 = fcmp olt double %124, %120
  %127 = and i1 %125, %126
  %128 = fcmp ogt double %122, %97
  %129 = and i1 %128, %127
  br i1 %129, label %107, label %130

130:
  %131 = phi double [ %45, %92 ], [ %121, %107 ]
  %132 = call double @llvm.fabs.f64(double %131)
  %133 = call double @nextafter(double noundef %132, double noundef 0x7FF0000000000000)
  %134 = fsub double %133, %132
  %135 = fmul double %134, 2.000000e+00
  %136 = fadd double %131, %135
  %137 = fcmp olt double %136, %47
  br i1 %137, label %138, label %157

138:
  %139 = fcmp olt double %88, 0.000000e+00
  br label %140

140:
  %141 = phi double [ %136, %138 ], [ %155, %140 ]
  %142 = phi double [ %135, %138 ], [ %154, %140 ]
  %143 = phi double [ %47, %138 ], [ %153, %140 ]
  store double %141, ptr %7, align 8
  %144 = load ptr, ptr %23, align 8
  %145 = load ptr, ptr %24, align 8
  %146 = load ptr, ptr %21, align 8
  %147 = load ptr, ptr %25, align 8
  call void %145(ptr noundef %144, ptr noundef nonnull %7, ptr noundef %146, ptr noundef %147)
  %148 = getelementptr inbounds nuw double, ptr %144, i64 %32
  %149 = load double, ptr %148, align 8
  %150 = fcmp uge double %149, 0.000000e+00
  %151 = fcmp ule double %149, 0.000000e+00
  %152 = select i1 %139, i1 %150, i1 %151
  %153 = select i1 %152, double %143, double %141
  %154 = fmul double %142, 8.000000e+00
  %155 = fadd double %131, %154
  %156 = fcmp olt double %155, %153
  br i1 %156, label %140, label %157

157:
  %158 = phi double [ %47, %130 ], [ %153, %140 ]
  %159 = fneg double %158
  %160 = fmul double %86, %88
  %161 = fcmp ule double %160, 0.000000e+00
  %162 = fsub double %158, %131
  %163 = fmul double %162, 1.000000e-18
  %164 = select i1 %161, double %158, double %131
  %165 = fneg double %164
  %166 = fsub double %158, %164
  %167 = fmul double %166, 5.000000e-01
  %168 = fsub double %167, %158
  %169 = fcmp ogt double %168, %159
  %170 = fcmp olt double %168, %165
  %171 = and i1 %169, %170
  %172 = fcmp ogt double %166, %163
  %173 = and i1 %172, %171
  br i1 %173, label %174, label %200

174:
  %175 = fcmp olt double %88, 0.000000e+00
  br label %176

176:
  %177 = phi double [ %168, %174 ], [ %194, %176 ]
  %178 = phi double [ %159, %174 ], [ %191, %176 ]
  %179 = phi double [ %165, %174 ], [ %190, %176 ]
  %180 = fneg double %177
  store double %180, ptr %6, align 8
  %181 = load ptr, ptr %23, align 8
  %182 = load ptr, ptr %24, align 8
  %183 = load ptr, ptr %21, align 8
  %184 = load ptr, ptr %25, align 8
  call void %182(ptr noundef %181, ptr noundef nonnull %6, ptr noundef %183, ptr noundef %184)
  %185 = getelementptr inbounds nuw double, ptr %181, i64 %32
  %186 = load double, ptr %185, align 8
  %187 = fcmp uge double %186, 0.000000e+00
  %188 = fcmp ule double %186, 0.000000e+00
  %189 = select i1 %175, i1 %187, i1 %188
  %190 = select i1 %189, double %177, double %179
  %191 = select i1 %189, double %178, double %177
  %192 = fsub double %190, %191
  %193 = fmul double %192, 5.000000e-01
  %194 = fadd double %191, %193
  %195 = fcmp olt double %191, %194
  %196 = fcmp olt double %194, %190
  %197 = and i1 %195, %196
  %198 = fcmp ogt double %192, %163
  %199 = and i1 %198, %197
  br i1 %199, label %176, label %200

200:
  %201 = phi double [ %159, %157 ], [ %191, %176 ]
  %202 = fneg double %201
  %203 = fsub double %202, %131
  %204 = fmul double %203, 5.000000e-01
  %205 = fadd double %131, %204
  %206 = call double @llvm.fabs.f64(double %205)
  %207 = fmul double %206, 0x3CF0000000000000
  %208 = fsub double %131, %207
  %209 = fsub double %207, %201
  %210 = load ptr, ptr %1, align 8
  %211 = load i64, ptr %0, align 8
  %212 = getelementptr inbounds double, ptr %210, i64 %211
  %213 = load double, ptr %212, align 8
  %214 = fcmp olt double %205, %213
  %215 = select i1 %214, double %213, double %205
  %216 = icmp eq i32 %41, 64
  br i1 %216, label %250, label %217

217:
  %218 = add nsw i32 %41, 1
  %219 = icmp sgt i32 %41, 0
  br i1 %219, label %220, label %233

220:
  %221 = zext nneg i32 %41 to i64
  br label %222

222:
  %223 = phi i64 [ %221, %220 ], [ %229, %228 ]
  %224 = getelementptr %struct.Stop, ptr %4, i64 %223
  %225 = getelementptr i8, ptr %224, i64 -24
  %226 = load double, ptr %225, align 8
  %227 = fcmp ogt double %226, %215
  br i1 %227, label %228, label %231

228:
  call void @llvm.memcpy.p0.p0.i64(ptr noundef nonnull align 8 dereferenceable(24) %224, ptr noundef nonnull align 8 dereferenceable(24) %225, i64 24, i1 false)
  %229 = add nsw i64 %223, -1
  %230 = icmp sgt i64 %223, 1
  br i1 %230, label %222, label %233

231:
  %232 = trunc nuw nsw i64 %223 to i32
  br label %233

233:
  %234 = phi i32 [ %41, %217 ], [ %232, %231 ], [ 0, %228 ]
  %235 = sext i32 %234 to i64
  %236 = getelementptr inbounds %struct.Stop, ptr %4, i64 %235
  store double %215, ptr %236, align 8
  %237 = getelementptr inbounds nuw i8, ptr %236, i64 8
  store double %208, ptr %237, align 8
  %238 = getelementptr inbounds nuw i8, ptr %236, i64 16
  store double %209, ptr %238, align 8
  br label %246

239:
  %240 = fmul double %68, 5.000000e-01
  %241 = fadd double %45, %240
  store double %241, ptr %44, align 8
  %242 = zext nneg i32 %40 to i64
  %243 = getelementptr inbounds nuw double, ptr %11, i64 %242
  store double %45, ptr %243, align 8
  %244 = getelementptr inbounds nuw double, ptr %12, i64 %242
  store double %241, ptr %244, align 8
  %245 = add nuw nsw i32 %40, 1
  br label %246

246:
  %247 = phi i32 [ %41, %239 ], [ %41, %74 ], [ %218, %233 ], [ %41, %39 ], [ %41, %52 ]
  %248 = phi i32 [ %245, %239 ], [ %42, %74 ], [ %42, %233 ], [ %42, %39 ], [ %42, %52 ]
  %249 = icmp sgt i32 %248, 0
  br i1 %249, label %39, label %251

250:
  br label %293

251:
  %252 = add nuw nsw i64 %32, 1
  %253 = load i64, ptr %16, align 8
  %254 = icmp sgt i64 %253, %252
  br i1 %254, label %31, label %26

255:
  %256 = phi i64 [ 0, %28 ], [ %291, %289 ]
  %257 = phi i32 [ 0, %28 ], [ %290, %289 ]
  %258 = icmp sgt i32 %257, 0
  br i1 %258, label %259, label %284

259:
  %260 = getelementptr inbounds nuw %struct.Stop, ptr %4, i64 %256
  %261 = load double, ptr %260, align 8
  %262 = zext nneg i32 %257 to i64
  %263 = getelementptr %struct.Stop, ptr %4, i64 %262
  %264 = getelementptr i8, ptr %263, i64 -24
  %265 = load double, ptr %264, align 8
  %266 = fsub double %261, %265
  %267 = load double, ptr %29, align 8
  %268 = fmul double %267, 4.096000e-09
  %269 = fcmp ugt double %266, %268
  br i1 %269, label %284, label %270

270:
  %271 = getelementptr inbounds nuw i8, ptr %260, i64 8
  %272 = load double, ptr %271, align 8
  %273 = getelementptr i8, ptr %263, i64 -16
  %274 = load double, ptr %273, align 8
  %275 = fcmp olt double %272, %274
  br i1 %275, label %276, label %277

276:
  store double %272, ptr %273, align 8
  br label %277

277:
  %278 = getelementptr inbounds nuw i8, ptr %260, i64 16
  %279 = load double, ptr %278, align 8
  %280 = getelementptr i8, ptr %263, i64 -8
  %281 = load double, ptr %280, align 8
  %282 = fcmp ogt double %279, %281
  br i1 %282, label %283, label %289

283:
  store double %279, ptr %280, align 8
  br label %289

284:
  %285 = add nsw i32 %257, 1
  %286 = sext i32 %257 to i64
  %287 = getelementptr inbounds %struct.Stop, ptr %4, i64 %286
  %288 = getelementptr inbounds nuw %struct.Stop, ptr %4, i64 %256
  call void @llvm.memcpy.p0.p0.i64(ptr noundef nonnull align 8 dereferenceable(24) %287, ptr noundef nonnull align 8 dereferenceable(24) %288, i64 24, i1 false)
  br label %289

289:
  %290 = phi i32 [ %257, %283 ], [ %257, %277 ], [ %285, %284 ]
  %291 = add nuw nsw i64 %256, 1
  %292 = icmp eq i64 %291, %30
  br i1 %292, label %293, label %255

293:
  %294 = phi i32 [ -1, %250 ], [ 0, %26 ], [ 0, %5 ], [ %290, %289 ]
  ret i32 %294
}

define void @set_out_at(ptr noundef %0, ptr noundef %1, ptr noundef %2, double noundef %3, ptr noundef %4) {
  %6 = alloca %struct.Run, align 8
  %7 = getelementptr inbounds nuw i8, ptr %6, i64 144
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(48) %7, i8 0, i64 48, i1 false)
  store ptr %1, ptr %6, align 8
  %8 = getelementptr inbounds nuw i8, ptr %6, i64 120
  store ptr %2, ptr %8, align 8
  %9 = getelementptr inbounds nuw i8, ptr %6, i64 128
  store ptr %2, ptr %9, align 8
  %10 = getelementptr inbounds nuw i8, ptr %0, i64 40
  %11 = load i64, ptr %10, align 8
  %12 = getelementptr inbounds double, ptr %2, i64 %11
  %13 = load double, ptr %12, align 8
  %14 = getelementptr inbounds nuw i8, ptr %6, i64 136
  store double %13, ptr %14, align 8
  %15 = getelementptr inbounds nuw i8, ptr %0, i64 112
  %16 = load i64, ptr %15, align 8
  %17 = getelementptr inbounds double, ptr %4, i64 %16
  %18 = getelementptr inbounds nuw i8, ptr %6, i64 8
  store ptr %17, ptr %18, align 8
  %19 = getelementptr inbounds nuw i8, ptr %6, i64 16
  store ptr %4, ptr %19, align 8
  %20 = getelementptr inbounds nuw i8, ptr %0, i64 16
  %21 = load i64, ptr %20, align 8
  %22 = getelementptr inbounds double, ptr %4, i64 %21
  %23 = getelementptr inbounds nuw i8, ptr %6, i64 24
  store ptr %22, ptr %23, align 8
  %24 = getelementptr inbounds double, ptr %22, i64 %21
  %25 = getelementptr inbounds nuw i8, ptr %6, i64 32
  store ptr %24, ptr %25, align 8
  %26 = getelementptr inbounds double, ptr %24, i64 %21
  %27 = getelementptr inbounds nuw i8, ptr %6, i64 40
  store ptr %26, ptr %27, align 8
  %28 = load i64, ptr %0, align 8
  %29 = getelementptr inbounds double, ptr %26, i64 %28
  %30 = getelementptr inbounds nuw i8, ptr %6, i64 48
  store ptr %29, ptr %30, align 8
  %31 = getelementptr inbounds nuw i8, ptr %0, i64 24
  %32 = load i64, ptr %31, align 8
  %33 = getelementptr inbounds double, ptr %29, i64 %32
  %34 = getelementptr inbounds nuw i8, ptr %0, i64 32
  %35 = load i64, ptr %34, align 8
  %36 = getelementptr inbounds double, ptr %33, i64 %35
  %37 = getelementptr inbounds nuw i8, ptr %6, i64 56
  store ptr %36, ptr %37, align 8
  %38 = getelementptr inbounds double, ptr %36, i64 %35
  %39 = getelementptr inbounds nuw i8, ptr %6, i64 64
  store ptr %38, ptr %39, align 8
  %40 = getelementptr inbounds nuw i8, ptr %0, i64 56
  %41 = load i64, ptr %40, align 8
  %42 = mul i64 %41, 4000
  %43 = getelementptr i8, ptr %38, i64 %42
  %44 = getelementptr i8, ptr %43, i64 4000
  %45 = getelementptr inbounds nuw i8, ptr %6, i64 72
  store ptr %44, ptr %45, align 8
  %46 = getelementptr inbounds nuw i8, ptr %0, i64 336
  %47 = load i64, ptr %46, align 8
  %48 = getelementptr inbounds double, ptr %44, i64 %47
  %49 = getelementptr inbounds nuw i8, ptr %6, i64 80
  store ptr %48, ptr %49, align 8
  %50 = getelementptr double, ptr %48, i64 %41
  %51 = getelementptr i8, ptr %50, i64 8
  %52 = getelementptr inbounds nuw i8, ptr %6, i64 88
  store ptr %51, ptr %52, align 8
  %53 = getelementptr double, ptr %51, i64 %41
  %54 = getelementptr i8, ptr %53, i64 8
  %55 = getelementptr inbounds nuw i8, ptr %6, i64 96
  store ptr %54, ptr %55, align 8
  %56 = getelementptr inbounds nuw i8, ptr %0, i64 72
  %57 = load i64, ptr %56, align 8
  %58 = getelementptr inbounds double, ptr %54, i64 %57
  %59 = getelementptr inbounds nuw i8, ptr %6, i64 112
  store ptr %58, ptr %59, align 8
  %60 = shl nsw i64 %57, 5
  %61 = getelementptr inbounds i8, ptr %58, i64 %60
  %62 = getelementptr inbounds nuw i8, ptr %6, i64 104
  store ptr %61, ptr %62, align 8
  %63 = getelementptr inbounds nuw i8, ptr %61, i64 1536
  %64 = getelementptr inbounds nuw i8, ptr %0, i64 344
  %65 = load i64, ptr %64, align 8
  %66 = getelementptr inbounds double, ptr %63, i64 %65
  %67 = getelementptr inbounds nuw i8, ptr %6, i64 160
  store ptr %66, ptr %67, align 8
  %68 = getelementptr i32, ptr %66, i64 %41
  %69 = getelementptr i8, ptr %68, i64 4
  %70 = shl i64 %32, 3
  tail call void @llvm.memcpy.p0.p0.i64(ptr align 8 %29, ptr align 8 %2, i64 %70, i1 false)
  %71 = load i64, ptr %31, align 8
  %72 = getelementptr inbounds double, ptr %29, i64 %71
  %73 = load i64, ptr %34, align 8
  %74 = shl i64 %73, 3
  tail call void @llvm.memcpy.p0.p0.i64(ptr align 8 %72, ptr align 8 %2, i64 %74, i1 false)
  %75 = load i64, ptr %0, align 8
  %76 = getelementptr inbounds double, ptr %1, i64 %75
  %77 = getelementptr inbounds nuw i8, ptr %0, i64 96
  %78 = load i64, ptr %77, align 8
  %79 = shl i64 %78, 3
  tail call void @llvm.memset.p0.i64(ptr align 8 %76, i8 0, i64 %79, i1 false)
  %80 = load i64, ptr %0, align 8
  %81 = getelementptr inbounds double, ptr %1, i64 %80
  store double %3, ptr %81, align 8
  %82 = load i64, ptr %56, align 8
  %83 = icmp eq i64 %82, 0
  br i1 %83, label %146, label %84

84:
  %85 = load i64, ptr %10, align 8
  %86 = shl i64 %85, 3
  tail call void @llvm.memcpy.p0.p0.i64(ptr align 8 %36, ptr nonnull align 8 %2, i64 %86, i1 false)
  %87 = load i64, ptr %10, align 8
  %88 = load i64, ptr %34, align 8
  %89 = icmp slt i64 %87, %88
  br i1 %89, label %90, label %102

90:
  %91 = getelementptr inbounds double, ptr %2, i64 %87
  br label %92

92:
  %93 = phi i64 [ %87, %90 ], [ %100, %92 ]
  %94 = getelementptr inbounds double, ptr %2, i64 %93
  %95 = load double, ptr %94, align 8
  %96 = load double, ptr %91, align 8
  %97 = fdiv double %13, %96
  %98 = fmul double %95, %97
  %99 = getelementptr inbounds double, ptr %36, i64 %93
  store double %98, ptr %99, align 8
  %100 = add nsw i64 %93, 1
  %101 = icmp eq i64 %100, %88
  br i1 %101, label %102, label %92

102:
  %103 = getelementptr inbounds double, ptr %36, i64 %87
  %104 = getelementptr inbounds nuw i8, ptr %0, i64 48
  %105 = load i64, ptr %104, align 8
  %106 = sub i64 0, %105
  %107 = getelementptr inbounds double, ptr %103, i64 %106
  %108 = getelementptr inbounds nuw i8, ptr %0, i64 120
  %109 = load i64, ptr %108, align 8
  %110 = getelementptr inbounds double, ptr %1, i64 %109
  %111 = shl i64 %105, 3
  tail call void @llvm.memcpy.p0.p0.i64(ptr align 8 %107, ptr align 8 %110, i64 %111, i1 false)
  %112 = fmul double %13, 2.000000e-09
  %113 = fsub double %3, %112
  %114 = fadd double %3, %112
  %115 = call fastcc i32 @changes(ptr noundef nonnull readonly %0, ptr noundef nonnull readonly %6, double noundef %113, double noundef %114, ptr noundef %61)
  %116 = icmp slt i32 %115, 1
  br i1 %116, label %142, label %117

117:
  %118 = load i64, ptr %0, align 8
  %119 = getelementptr inbounds double, ptr %1, i64 %118
  %120 = load double, ptr %119, align 8
  %121 = fmul double %13, 0.000000e+00
  %122 = fadd double %121, %120
  %123 = fmul double %13, 1.000000e-09
  br label %124

124:
  %125 = phi double [ 0xFFF0000000000000, %117 ], [ %138, %137 ]
  %126 = phi i32 [ %115, %117 ], [ %139, %137 ]
  %127 = phi ptr [ %61, %117 ], [ %140, %137 ]
  %128 = load double, ptr %127, align 8
  %129 = fsub double %128, %122
  %130 = tail call double @llvm.fabs.f64(double %129)
  %131 = fcmp ogt double %130, %123
  br i1 %131, label %137, label %132

132:
  %133 = getelementptr inbounds nuw i8, ptr %127, i64 16
  %134 = load double, ptr %133, align 8
  %135 = fcmp ogt double %134, %125
  br i1 %135, label %136, label %137

136:
  br label %137

137:
  %138 = phi double [ %125, %132 ], [ %134, %136 ], [ %125, %124 ]
  %139 = add nsw i32 %126, -1
  %140 = getelementptr inbounds nuw i8, ptr %127, i64 24
  %141 = icmp sgt i32 %126, 1
  br i1 %141, label %124, label %142

142:
  %143 = phi double [ 0xFFF0000000000000, %102 ], [ %138, %137 ]
  %144 = fcmp ogt double %143, %3
  %145 = select i1 %144, double %143, double %3
  br label %146

146:
  %147 = phi double [ %145, %142 ], [ %3, %5 ]
  store double %147, ptr %1, align 8
  %148 = load i64, ptr %40, align 8
  %149 = icmp eq i64 %148, 0
  br i1 %149, label %202, label %150

150:
  %151 = icmp sgt i64 %148, 0
  br i1 %151, label %152, label %162

152:
  %153 = getelementptr inbounds nuw i8, ptr %0, i64 184
  %154 = load i64, ptr %153, align 8
  %155 = icmp sgt i64 %154, -1
  %156 = getelementptr inbounds nuw double, ptr %1, i64 %154
  br i1 %155, label %157, label %162

157:
  %158 = phi i64 [ %160, %157 ], [ 0, %152 ]
  %159 = getelementptr inbounds nuw double, ptr %156, i64 %158
  store double -1.000000e+300, ptr %159, align 8
  %160 = add nuw nsw i64 %158, 1
  %161 = icmp eq i64 %160, %148
  br i1 %161, label %162, label %157

162:
  %163 = getelementptr inbounds nuw i8, ptr %0, i64 296
  %164 = load i64, ptr %163, align 8
  %165 = icmp sgt i64 %164, 0
  br i1 %165, label %166, label %201

166:
  %167 = getelementptr inbounds nuw i8, ptr %0, i64 320
  %168 = load i64, ptr %167, align 8
  %169 = getelementptr inbounds double, ptr %44, i64 %168
  %170 = getelementptr inbounds nuw i8, ptr %0, i64 328
  %171 = load i64, ptr %170, align 8
  %172 = getelementptr inbounds double, ptr %169, i64 %171
  %173 = getelementptr inbounds nuw i8, ptr %0, i64 464
  %174 = load ptr, ptr %173, align 8
  tail call void %174(ptr noundef %44, ptr noundef nonnull %1, ptr noundef %2, ptr noundef %17)
  %175 = load i64, ptr %10, align 8
  %176 = shl i64 %175, 3
  tail call void @llvm.memcpy.p0.p0.i64(ptr align 8 %172, ptr align 8 %2, i64 %176, i1 false)
  %177 = getelementptr inbounds nuw i8, ptr %0, i64 472
  %178 = load ptr, ptr %177, align 8
  tail call void %178(ptr noundef %169, ptr noundef %44, ptr noundef %172, ptr noundef %17)
  %179 = load i64, ptr %163, align 8
  %180 = icmp sgt i64 %179, 0
  br i1 %180, label %181, label %201

181:
  %182 = getelementptr inbounds nuw i8, ptr %0, i64 288
  %183 = load i64, ptr %182, align 8
  %184 = getelementptr inbounds nuw i8, ptr %0, i64 304
  %185 = load i64, ptr %184, align 8
  %186 = add i64 %185, 2
  %187 = mul i64 %186, %183
  %188 = getelementptr double, ptr %169, i64 %187
  br label %192

189:
  %190 = add nuw nsw i64 %193, 1
  %191 = icmp eq i64 %190, %179
  br i1 %191, label %201, label %192

192:
  %193 = phi i64 [ 0, %181 ], [ %190, %189 ]
  %194 = getelementptr double, ptr %188, i64 %193
  %195 = load double, ptr %194, align 8
  %196 = fcmp ult double %195, -1.000000e-09
  br i1 %196, label %197, label %189

197:
  %198 = load i64, ptr %0, align 8
  %199 = getelementptr double, ptr %1, i64 %198
  %200 = getelementptr i8, ptr %199, i64 8
  store double 6.000000e+00, ptr %200, align 8
  br label %202

201:
  call fastcc void @look_anew(ptr noundef nonnull %0, ptr noundef nonnull readonly %6, ptr nonnull %63, ptr %69)
  br label %202

202:
  ret void
}

define void @look_again(ptr noundef %0, ptr noundef %1, ptr noundef %2, ptr noundef %3) {
  %5 = alloca %struct.Run, align 8
  %6 = getelementptr inbounds nuw i8, ptr %5, i64 144
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(48) %6, i8 0, i64 48, i1 false)
  store ptr %1, ptr %5, align 8
  %7 = getelementptr inbounds nuw i8, ptr %5, i64 120
  store ptr %2, ptr %7, align 8
  %8 = getelementptr inbounds nuw i8, ptr %5, i64 128
  store ptr %2, ptr %8, align 8
  %9 = getelementptr inbounds nuw i8, ptr %0, i64 40
  %10 = load i64, ptr %9, align 8
  %11 = getelementptr inbounds double, ptr %2, i64 %10
  %12 = load double, ptr %11, align 8
  %13 = getelementptr inbounds nuw i8, ptr %5, i64 136
  store double %12, ptr %13, align 8
  %14 = getelementptr inbounds nuw i8, ptr %0, i64 112
  %15 = load i64, ptr %14, align 8
  %16 = getelementptr inbounds double, ptr %3, i64 %15
  %17 = getelementptr inbounds nuw i8, ptr %5, i64 8
  store ptr %16, ptr %17, align 8
  %18 = getelementptr inbounds nuw i8, ptr %5, i64 16
  store ptr %3, ptr %18, align 8
  %19 = getelementptr inbounds nuw i8, ptr %0, i64 16
  %20 = load i64, ptr %19, align 8
  %21 = getelementptr inbounds double, ptr %3, i64 %20
  %22 = getelementptr inbounds nuw i8, ptr %5, i64 24
  store ptr %21, ptr %22, align 8
  %23 = getelementptr inbounds double, ptr %21, i64 %20
  %24 = getelementptr inbounds nuw i8, ptr %5, i64 32
  store ptr %23, ptr %24, align 8
  %25 = getelementptr inbounds double, ptr %23, i64 %20
  %26 = getelementptr inbounds nuw i8, ptr %5, i64 40
  store ptr %25, ptr %26, align 8
  %27 = load i64, ptr %0, align 8
  %28 = getelementptr inbounds double, ptr %25, i64 %27
  %29 = getelementptr inbounds nuw i8, ptr %5, i64 48
  store ptr %28, ptr %29, align 8
  %30 = getelementptr inbounds nuw i8, ptr %0, i64 24
  %31 = load i64, ptr %30, align 8
  %32 = getelementptr inbounds double, ptr %28, i64 %31
  %33 = getelementptr inbounds nuw i8, ptr %0, i64 32
  %34 = load i64, ptr %33, align 8
  %35 = getelementptr inbounds double, ptr %32, i64 %34
  %36 = getelementptr inbounds nuw i8, ptr %5, i64 56
  store ptr %35, ptr %36, align 8
  %37 = getelementptr inbounds double, ptr %35, i64 %34
  %38 = getelementptr inbounds nuw i8, ptr %5, i64 64
  store ptr %37, ptr %38, align 8
  %39 = getelementptr inbounds nuw i8, ptr %0, i64 56
  %40 = load i64, ptr %39, align 8
  %41 = mul i64 %40, 4000
  %42 = getelementptr i8, ptr %37, i64 %41
  %43 = getelementptr i8, ptr %42, i64 4000
  %44 = getelementptr inbounds nuw i8, ptr %5, i64 72
  store ptr %43, ptr %44, align 8
  %45 = getelementptr inbounds nuw i8, ptr %0, i64 336
  %46 = load i64, ptr %45, align 8
  %47 = getelementptr inbounds double, ptr %43, i64 %46
  %48 = getelementptr inbounds nuw i8, ptr %5, i64 80
  store ptr %47, ptr %48, align 8
  %49 = getelementptr double, ptr %47, i64 %40
  %50 = getelementptr i8, ptr %49, i64 8
  %51 = getelementptr inbounds nuw i8, ptr %5, i64 88
  store ptr %50, ptr %51, align 8
  %52 = getelementptr double, ptr %50, i64 %40
  %53 = getelementptr i8, ptr %52, i64 8
  %54 = getelementptr inbounds nuw i8, ptr %5, i64 96
  store ptr %53, ptr %54, align 8
  %55 = getelementptr inbounds nuw i8, ptr %0, i64 72
  %56 = load i64, ptr %55, align 8
  %57 = getelementptr inbounds double, ptr %53, i64 %56
  %58 = getelementptr inbounds nuw i8, ptr %5, i64 112
  store ptr %57, ptr %58, align 8
  %59 = shl nsw i64 %56, 5
  %60 = getelementptr inbounds i8, ptr %57, i64 %59
  %61 = getelementptr inbounds nuw i8, ptr %5, i64 104
  store ptr %60, ptr %61, align 8
  %62 = getelementptr inbounds nuw i8, ptr %60, i64 1536
  %63 = getelementptr inbounds nuw i8, ptr %0, i64 344
  %64 = load i64, ptr %63, align 8
  %65 = getelementptr inbounds double, ptr %62, i64 %64
  %66 = getelementptr inbounds nuw i8, ptr %5, i64 160
  store ptr %65, ptr %66, align 8
  %67 = getelementptr i32, ptr %65, i64 %40
  %68 = getelementptr i8, ptr %67, i64 4
  %69 = shl i64 %31, 3
  tail call void @llvm.memcpy.p0.p0.i64(ptr align 8 %28, ptr align 8 %2, i64 %69, i1 false)
  %70 = load i64, ptr %30, align 8
  %71 = getelementptr inbounds double, ptr %28, i64 %70
  %72 = load i64, ptr %33, align 8
  %73 = shl i64 %72, 3
  tail call void @llvm.memcpy.p0.p0.i64(ptr align 8 %71, ptr align 8 %2, i64 %73, i1 false)
  call fastcc void @look_anew(ptr noundef nonnull %0, ptr noundef %5, ptr nonnull %62, ptr %68)
  ret void
}

define internal fastcc void @look_anew(ptr noundef %0, ptr noundef nonnull readonly captures(none) %1, ptr %2, ptr %3) unnamed_addr {
  %5 = alloca %struct.Room, align 8
  tail call fastcc void @look_at_events(ptr noundef %0, ptr noundef %1, ptr %2)
  %6 = getelementptr inbounds nuw i8, ptr %0, i64 280
  %7 = load i64, ptr %6, align 8
  %8 = icmp sgt i64 %7, 0
  br i1 %8, label %9, label %135

9:
  %10 = load ptr, ptr %1, align 8
  %11 = load double, ptr %10, align 8
  %12 = getelementptr inbounds nuw i8, ptr %10, i64 8
  %13 = load double, ptr %12, align 8
  %14 = getelementptr inbounds nuw i8, ptr %1, i64 32
  %15 = load ptr, ptr %14, align 8
  %16 = getelementptr inbounds nuw i8, ptr %0, i64 8
  %17 = load i64, ptr %16, align 8
  %18 = getelementptr inbounds double, ptr %15, i64 %17
  %19 = getelementptr inbounds nuw i8, ptr %18, i64 24
  %20 = getelementptr inbounds nuw i8, ptr %0, i64 48
  %21 = load i64, ptr %20, align 8
  %22 = getelementptr inbounds double, ptr %19, i64 %21
  %23 = shl i64 %17, 3
  tail call void @llvm.memcpy.p0.p0.i64(ptr align 8 %15, ptr nonnull align 8 %10, i64 %23, i1 false)
  %24 = load ptr, ptr %1, align 8
  %25 = getelementptr inbounds nuw i8, ptr %0, i64 120
  %26 = load i64, ptr %25, align 8
  %27 = getelementptr inbounds double, ptr %24, i64 %26
  %28 = load i64, ptr %20, align 8
  %29 = shl i64 %28, 3
  tail call void @llvm.memcpy.p0.p0.i64(ptr nonnull align 8 %19, ptr align 8 %27, i64 %29, i1 false)
  %30 = getelementptr inbounds nuw i8, ptr %1, i64 136
  %31 = load double, ptr %30, align 8
  %32 = load i64, ptr %16, align 8
  %33 = getelementptr double, ptr %15, i64 %32
  %34 = getelementptr i8, ptr %33, i64 8
  store double %31, ptr %34, align 8
  store double %31, ptr %33, align 8
  %35 = load double, ptr %30, align 8
  %36 = fmul double %13, %35
  %37 = fadd double %11, %36
  %38 = getelementptr i8, ptr %33, i64 16
  store double %37, ptr %38, align 8
  %39 = load ptr, ptr %1, align 8
  %40 = getelementptr inbounds nuw i8, ptr %1, i64 120
  %41 = load ptr, ptr %40, align 8
  %42 = getelementptr inbounds nuw i8, ptr %5, i64 8
  store ptr %3, ptr %42, align 8
  %43 = getelementptr inbounds nuw i8, ptr %1, i64 72
  %44 = load ptr, ptr %43, align 8
  %45 = getelementptr inbounds nuw i8, ptr %0, i64 304
  %46 = load i64, ptr %45, align 8
  %47 = getelementptr inbounds double, ptr %44, i64 %46
  %48 = getelementptr inbounds nuw i8, ptr %0, i64 312
  %49 = load i64, ptr %48, align 8
  %50 = getelementptr inbounds double, ptr %47, i64 %49
  %51 = getelementptr inbounds nuw i8, ptr %0, i64 56
  %52 = load i64, ptr %51, align 8
  %53 = getelementptr double, ptr %2, i64 %52
  %54 = getelementptr i8, ptr %53, i64 8
  %55 = getelementptr inbounds double, ptr %54, i64 %46
  %56 = load i64, ptr %6, align 8
  %57 = getelementptr inbounds double, ptr %55, i64 %56
  store ptr %57, ptr %5, align 8
  %58 = shl i64 %56, 3
  tail call void @llvm.memset.p0.i64(ptr align 8 %55, i8 0, i64 %58, i1 false)
  %59 = getelementptr inbounds nuw i8, ptr %0, i64 464
  %60 = load ptr, ptr %59, align 8
  %61 = getelementptr inbounds nuw i8, ptr %1, i64 8
  %62 = load ptr, ptr %61, align 8
  tail call void %60(ptr noundef %44, ptr noundef %39, ptr noundef %41, ptr noundef %62)
  %63 = load i64, ptr %45, align 8
  %64 = shl i64 %63, 3
  tail call void @llvm.memcpy.p0.p0.i64(ptr align 8 %54, ptr align 8 %50, i64 %64, i1 false)
  %65 = load ptr, ptr %40, align 8
  %66 = getelementptr inbounds nuw i8, ptr %0, i64 320
  %67 = load i64, ptr %66, align 8
  %68 = getelementptr inbounds double, ptr %44, i64 %67
  %69 = load ptr, ptr %61, align 8
  %70 = tail call fastcc i32 @decide(ptr noundef nonnull %0, ptr noundef %44, ptr noundef nonnull %19, ptr noundef %65, ptr noundef null, ptr noundef %55, ptr noundef %68, ptr noundef %69, ptr noundef null, ptr noundef nonnull byval(%struct.Room) align 8 %5)
  %71 = icmp eq i32 %70, 0
  br i1 %71, label %72, label %77

72:
  %73 = load ptr, ptr %1, align 8
  %74 = load i64, ptr %0, align 8
  %75 = getelementptr double, ptr %73, i64 %74
  %76 = getelementptr i8, ptr %75, i64 8
  store double 3.000000e+00, ptr %76, align 8
  br label %77

77:
  %78 = load i64, ptr %45, align 8
  %79 = icmp sgt i64 %78, 0
  br i1 %79, label %80, label %90

80:
  %81 = phi i64 [ %88, %80 ], [ 0, %77 ]
  %82 = getelementptr inbounds nuw double, ptr %50, i64 %81
  %83 = load double, ptr %82, align 8
  %84 = getelementptr inbounds nuw double, ptr %54, i64 %81
  %85 = load double, ptr %84, align 8
  %86 = fsub double %83, %85
  %87 = getelementptr inbounds nuw double, ptr %22, i64 %81
  store double %86, ptr %87, align 8
  %88 = add nuw nsw i64 %81, 1
  %89 = icmp eq i64 %88, %78
  br i1 %89, label %91, label %80

90:
  br label %92

91:
  br label %96

92:
  %93 = phi i1 [ true, %90 ], [ %104, %103 ]
  %94 = load i64, ptr %20, align 8
  %95 = icmp sgt i64 %94, 0
  br i1 %95, label %107, label %123

96:
  %97 = phi i64 [ 0, %91 ], [ %105, %103 ]
  %98 = phi i1 [ true, %91 ], [ %104, %103 ]
  br i1 %98, label %99, label %103

99:
  %100 = getelementptr inbounds nuw double, ptr %22, i64 %97
  %101 = load double, ptr %100, align 8
  %102 = fcmp oeq double %101, 0.000000e+00
  br label %103

103:
  %104 = phi i1 [ false, %96 ], [ %102, %99 ]
  %105 = add nuw nsw i64 %97, 1
  %106 = icmp eq i64 %105, %78
  br i1 %106, label %92, label %96

107:
  %108 = phi i64 [ %121, %119 ], [ 0, %92 ]
  %109 = phi i1 [ %120, %119 ], [ %93, %92 ]
  br i1 %109, label %110, label %119

110:
  %111 = getelementptr inbounds nuw double, ptr %19, i64 %108
  %112 = load double, ptr %111, align 8
  %113 = load ptr, ptr %1, align 8
  %114 = load i64, ptr %25, align 8
  %115 = getelementptr double, ptr %113, i64 %114
  %116 = getelementptr double, ptr %115, i64 %108
  %117 = load double, ptr %116, align 8
  %118 = fcmp oeq double %112, %117
  br label %119

119:
  %120 = phi i1 [ false, %107 ], [ %118, %110 ]
  %121 = add nuw nsw i64 %108, 1
  %122 = icmp eq i64 %121, %94
  br i1 %122, label %123, label %107

123:
  %124 = phi i1 [ %93, %92 ], [ %120, %119 ]
  br i1 %124, label %135, label %125

125:
  %126 = getelementptr inbounds nuw i8, ptr %0, i64 424
  %127 = load ptr, ptr %126, align 8
  %128 = load ptr, ptr %40, align 8
  %129 = load ptr, ptr %61, align 8
  tail call void %127(ptr noundef %15, ptr noundef %128, ptr noundef %129)
  %130 = load ptr, ptr %1, align 8
  %131 = load i64, ptr %16, align 8
  %132 = shl i64 %131, 3
  tail call void @llvm.memcpy.p0.p0.i64(ptr align 8 %130, ptr align 8 %15, i64 %132, i1 false)
  %133 = load ptr, ptr %1, align 8
  store double %11, ptr %133, align 8
  %134 = getelementptr inbounds nuw i8, ptr %133, i64 8
  store double %13, ptr %134, align 8
  tail call fastcc void @look_at_events(ptr noundef nonnull %0, ptr noundef nonnull readonly %1, ptr %2)
  br label %135

135:
  ret void
}

define i32 @step(ptr noundef %0, ptr noundef %1, ptr noundef %2, ptr noundef %3, i64 noundef %4) {
  %6 = alloca %struct.Run, align 8
  %7 = getelementptr inbounds nuw i8, ptr %6, i64 144
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(48) %7, i8 0, i64 48, i1 false)
  store ptr %1, ptr %6, align 8
  %8 = getelementptr inbounds nuw i8, ptr %6, i64 120
  store ptr %2, ptr %8, align 8
  %9 = getelementptr inbounds nuw i8, ptr %6, i64 128
  store ptr %2, ptr %9, align 8
  %10 = getelementptr inbounds nuw i8, ptr %0, i64 40
  %11 = load i64, ptr %10, align 8
  %12 = getelementptr inbounds double, ptr %2, i64 %11
  %13 = load double, ptr %12, align 8
  %14 = getelementptr inbounds nuw i8, ptr %6, i64 136
  store double %13, ptr %14, align 8
  %15 = getelementptr inbounds nuw i8, ptr %0, i64 112
  %16 = load i64, ptr %15, align 8
  %17 = getelementptr inbounds double, ptr %3, i64 %16
  %18 = getelementptr inbounds nuw i8, ptr %6, i64 8
  store ptr %17, ptr %18, align 8
  %19 = getelementptr inbounds nuw i8, ptr %6, i64 16
  store ptr %3, ptr %19, align 8
  %20 = getelementptr inbounds nuw i8, ptr %0, i64 16
  %21 = load i64, ptr %20, align 8
  %22 = getelementptr inbounds double, ptr %3, i64 %21
  %23 = getelementptr inbounds nuw i8, ptr %6, i64 24
  store ptr %22, ptr %23, align 8
  %24 = getelementptr inbounds double, ptr %22, i64 %21
  %25 = getelementptr inbounds nuw i8, ptr %6, i64 32
  store ptr %24, ptr %25, align 8
  %26 = getelementptr inbounds double, ptr %24, i64 %21
  %27 = getelementptr inbounds nuw i8, ptr %6, i64 40
  store ptr %26, ptr %27, align 8
  %28 = load i64, ptr %0, align 8
  %29 = getelementptr inbounds double, ptr %26, i64 %28
  %30 = getelementptr inbounds nuw i8, ptr %6, i64 48
  store ptr %29, ptr %30, align 8
  %31 = getelementptr inbounds nuw i8, ptr %0, i64 24
  %32 = load i64, ptr %31, align 8
  %33 = getelementptr inbounds double, ptr %29, i64 %32
  %34 = getelementptr inbounds nuw i8, ptr %0, i64 32
  %35 = load i64, ptr %34, align 8
  %36 = getelementptr inbounds double, ptr %33, i64 %35
  %37 = getelementptr inbounds nuw i8, ptr %6, i64 56
  store ptr %36, ptr %37, align 8
  %38 = getelementptr inbounds double, ptr %36, i64 %35
  %39 = getelementptr inbounds nuw i8, ptr %6, i64 64
  store ptr %38, ptr %39, align 8
  %40 = getelementptr inbounds nuw i8, ptr %0, i64 56
  %41 = load i64, ptr %40, align 8
  %42 = mul i64 %41, 4000
  %43 = getelementptr i8, ptr %38, i64 %42
  %44 = getelementptr i8, ptr %43, i64 4000
  %45 = getelementptr inbounds nuw i8, ptr %6, i64 72
  store ptr %44, ptr %45, align 8
  %46 = getelementptr inbounds nuw i8, ptr %0, i64 336
  %47 = load i64, ptr %46, align 8
  %48 = getelementptr inbounds double, ptr %44, i64 %47
  %49 = getelementptr inbounds nuw i8, ptr %6, i64 80
  store ptr %48, ptr %49, align 8
  %50 = getelementptr double, ptr %48, i64 %41
  %51 = getelementptr i8, ptr %50, i64 8
  %52 = getelementptr inbounds nuw i8, ptr %6, i64 88
  store ptr %51, ptr %52, align 8
  %53 = getelementptr double, ptr %51, i64 %41
  %54 = getelementptr i8, ptr %53, i64 8
  %55 = getelementptr inbounds nuw i8, ptr %6, i64 96
  store ptr %54, ptr %55, align 8
  %56 = getelementptr inbounds nuw i8, ptr %0, i64 72
  %57 = load i64, ptr %56, align 8
  %58 = getelementptr inbounds double, ptr %54, i64 %57
  %59 = getelementptr inbounds nuw i8, ptr %6, i64 112
  store ptr %58, ptr %59, align 8
  %60 = shl nsw i64 %57, 5
  %61 = getelementptr inbounds i8, ptr %58, i64 %60
  %62 = getelementptr inbounds nuw i8, ptr %6, i64 104
  store ptr %61, ptr %62, align 8
  %63 = getelementptr inbounds nuw i8, ptr %61, i64 1536
  %64 = getelementptr inbounds nuw i8, ptr %0, i64 344
  %65 = load i64, ptr %64, align 8
  %66 = getelementptr inbounds double, ptr %63, i64 %65
  %67 = getelementptr inbounds nuw i8, ptr %6, i64 160
  store ptr %66, ptr %67, align 8
  %68 = getelementptr i32, ptr %66, i64 %41
  %69 = getelementptr i8, ptr %68, i64 4
  %70 = shl i64 %32, 3
  tail call void @llvm.memcpy.p0.p0.i64(ptr align 8 %29, ptr align 8 %2, i64 %70, i1 false)
  %71 = load i64, ptr %31, align 8
  %72 = getelementptr inbounds double, ptr %29, i64 %71
  %73 = load i64, ptr %34, align 8
  %74 = shl i64 %73, 3
  tail call void @llvm.memcpy.p0.p0.i64(ptr align 8 %72, ptr align 8 %2, i64 %74, i1 false)
  %75 = load i64, ptr %0, align 8
  %76 = getelementptr inbounds double, ptr %63, i64 %75
  %77 = getelementptr inbounds nuw i8, ptr %1, i64 8
  %78 = load double, ptr %77, align 8
  %79 = sitofp i64 %4 to double
  %80 = fadd double %78, %79
  %81 = call fastcc i32 @advance(ptr noundef nonnull %0, ptr noundef %6, double noundef %80, ptr noundef nonnull %63, ptr nonnull %76, ptr %69)
  %82 = load i64, ptr %0, align 8
  %83 = getelementptr double, ptr %1, i64 %82
  %84 = getelementptr i8, ptr %83, i64 8
  %85 = load double, ptr %84, align 8
  %86 = fptosi double %85 to i32
  ret i32 %86
}

define internal fastcc range(i32 0, 2) i32 @advance(ptr noundef %0, ptr noundef nonnull %1, double noundef %2, ptr noundef captures(none) %3, ptr %4, ptr %5) unnamed_addr {
  %7 = alloca i32, align 4
  %8 = load ptr, ptr %1, align 8
  %9 = getelementptr inbounds nuw i8, ptr %8, i64 8
  %10 = load double, ptr %9, align 8
  %11 = fcmp olt double %10, %2
  br i1 %11, label %12, label %340

12:
  %13 = getelementptr inbounds nuw i8, ptr %1, i64 176
  %14 = getelementptr inbounds nuw i8, ptr %1, i64 136
  %15 = getelementptr inbounds nuw i8, ptr %1, i64 104
  %16 = getelementptr inbounds nuw i8, ptr %1, i64 112
  %17 = getelementptr inbounds nuw i8, ptr %0, i64 72
  %18 = getelementptr inbounds nuw i8, ptr %1, i64 56
  %19 = getelementptr inbounds nuw i8, ptr %1, i64 120
  %20 = getelementptr inbounds nuw i8, ptr %0, i64 40
  %21 = getelementptr inbounds nuw i8, ptr %0, i64 32
  %22 = getelementptr inbounds nuw i8, ptr %0, i64 48
  %23 = getelementptr inbounds nuw i8, ptr %0, i64 120
  %24 = getelementptr inbounds nuw i8, ptr %0, i64 504
  %25 = getelementptr inbounds nuw i8, ptr %0, i64 400
  %26 = getelementptr inbounds nuw i8, ptr %1, i64 128
  %27 = getelementptr inbounds nuw i8, ptr %1, i64 8
  %28 = getelementptr inbounds nuw i8, ptr %0, i64 56
  %29 = getelementptr inbounds nuw i8, ptr %0, i64 136
  %30 = getelementptr inbounds nuw i8, ptr %1, i64 184
  %31 = getelementptr inbounds nuw i8, ptr %1, i64 40
  %32 = getelementptr inbounds nuw i8, ptr %1, i64 168
  %33 = getelementptr inbounds nuw i8, ptr %1, i64 160
  %34 = getelementptr inbounds nuw i8, ptr %0, i64 128
  %35 = getelementptr inbounds nuw i8, ptr %0, i64 360
  br label %36

36:
  %37 = phi double [ %10, %12 ], [ %338, %337 ]
  %38 = load i64, ptr %0, align 8
  %39 = getelementptr double, ptr %8, i64 %38
  %40 = getelementptr i8, ptr %39, i64 8
  %41 = load double, ptr %40, align 8
  %42 = fcmp oeq double %41, 0.000000e+00
  br i1 %42, label %43, label %340

43:
  %44 = fsub double %2, %37
  %45 = fcmp olt double %44, 6.400000e+01
  %46 = select i1 %45, double %44, double 6.400000e+01
  %47 = fptosi double %46 to i64
  %48 = load ptr, ptr %13, align 8
  %49 = icmp eq ptr %48, null
  br i1 %49, label %50, label %159

50:
  %51 = load double, ptr %14, align 8
  %52 = fmul double %51, 2.000000e-09
  %53 = load ptr, ptr %15, align 8
  %54 = load ptr, ptr %16, align 8
  %55 = load i64, ptr %17, align 8
  %56 = icmp eq i64 %55, 0
  br i1 %56, label %192, label %57

57:
  %58 = load ptr, ptr %18, align 8
  %59 = load ptr, ptr %19, align 8
  %60 = load i64, ptr %20, align 8
  %61 = shl i64 %60, 3
  call void @llvm.memcpy.p0.p0.i64(ptr align 8 %58, ptr align 8 %59, i64 %61, i1 false)
  %62 = load i64, ptr %20, align 8
  %63 = load i64, ptr %21, align 8
  %64 = icmp slt i64 %62, %63
  %65 = load ptr, ptr %18, align 8
  br i1 %64, label %66, label %79

66:
  %67 = load ptr, ptr %19, align 8
  %68 = getelementptr inbounds double, ptr %67, i64 %62
  br label %69

69:
  %70 = phi i64 [ %62, %66 ], [ %77, %69 ]
  %71 = getelementptr inbounds double, ptr %67, i64 %70
  %72 = load double, ptr %71, align 8
  %73 = load double, ptr %68, align 8
  %74 = fdiv double %51, %73
  %75 = fmul double %72, %74
  %76 = getelementptr inbounds double, ptr %65, i64 %70
  store double %75, ptr %76, align 8
  %77 = add nsw i64 %70, 1
  %78 = icmp eq i64 %77, %63
  br i1 %78, label %79, label %69

79:
  %80 = getelementptr inbounds double, ptr %65, i64 %62
  %81 = load i64, ptr %22, align 8
  %82 = sub i64 0, %81
  %83 = getelementptr inbounds double, ptr %80, i64 %82
  %84 = load ptr, ptr %1, align 8
  %85 = load i64, ptr %23, align 8
  %86 = getelementptr inbounds double, ptr %84, i64 %85
  %87 = shl i64 %81, 3
  call void @llvm.memcpy.p0.p0.i64(ptr align 8 %83, ptr align 8 %86, i64 %87, i1 false)
  %88 = icmp sgt i64 %47, 1
  br i1 %88, label %89, label %138

89:
  %90 = phi i64 [ %136, %135 ], [ %47, %79 ]
  store i32 0, ptr %7, align 4
  %91 = load ptr, ptr %24, align 8
  %92 = load ptr, ptr %1, align 8
  %93 = getelementptr inbounds nuw i8, ptr %92, i64 8
  %94 = load double, ptr %93, align 8
  %95 = load i64, ptr %0, align 8
  %96 = getelementptr inbounds double, ptr %92, i64 %95
  %97 = load double, ptr %96, align 8
  %98 = load double, ptr %14, align 8
  %99 = fmul double %94, %98
  %100 = fadd double %97, %99
  %101 = fsub double %100, %52
  %102 = uitofp nneg i64 %90 to double
  %103 = fadd double %94, %102
  %104 = fmul double %103, %98
  %105 = fadd double %97, %104
  %106 = fadd double %52, %105
  %107 = load ptr, ptr %18, align 8
  call void %91(ptr noundef %54, ptr noundef nonnull %7, double noundef %101, double noundef %106, ptr noundef %107)
  %108 = load i64, ptr %17, align 8
  %109 = icmp sgt i64 %108, 0
  br i1 %109, label %110, label %199

110:
  %111 = phi i64 [ %132, %131 ], [ 0, %89 ]
  %112 = phi i1 [ %133, %131 ], [ false, %89 ]
  br i1 %112, label %124, label %113

113:
  %114 = shl nuw nsw i64 %111, 5
  %115 = getelementptr inbounds nuw i8, ptr %54, i64 %114
  %116 = load double, ptr %115, align 8
  %117 = fcmp ogt double %116, 0.000000e+00
  br i1 %117, label %128, label %118

118:
  %119 = getelementptr inbounds nuw i8, ptr %115, i64 8
  %120 = load double, ptr %119, align 8
  %121 = fcmp uge double %120, 0.000000e+00
  %122 = add nuw nsw i64 %111, 1
  %123 = icmp eq i64 %122, %108
  br i1 %123, label %134, label %131

124:
  %125 = add nuw nsw i64 %111, 1
  %126 = icmp eq i64 %125, %108
  br i1 %126, label %127, label %131

127:
  br label %135

128:
  %129 = add nuw nsw i64 %111, 1
  %130 = icmp eq i64 %129, %108
  br i1 %130, label %199, label %131

131:
  %132 = phi i64 [ %125, %124 ], [ %122, %118 ], [ %129, %128 ]
  %133 = phi i1 [ true, %124 ], [ %121, %118 ], [ false, %128 ]
  br label %110

134:
  br i1 %121, label %135, label %200

135:
  %136 = lshr i64 %90, 1
  %137 = icmp samesign ugt i64 %90, 3
  br i1 %137, label %89, label %138

138:
  %139 = load ptr, ptr %1, align 8
  %140 = getelementptr inbounds nuw i8, ptr %139, i64 8
  %141 = load double, ptr %140, align 8
  %142 = load i64, ptr %0, align 8
  %143 = getelementptr inbounds double, ptr %139, i64 %142
  %144 = load double, ptr %143, align 8
  %145 = load double, ptr %14, align 8
  %146 = fmul double %141, %145
  %147 = fadd double %144, %146
  %148 = fsub double %147, %52
  %149 = fadd double %141, 1.000000e+00
  %150 = fmul double %149, %145
  %151 = fadd double %144, %150
  %152 = fadd double %52, %151
  %153 = call fastcc i32 @changes(ptr noundef nonnull readonly %0, ptr noundef nonnull readonly %1, double noundef %148, double noundef %152, ptr noundef %53)
  %154 = icmp eq i32 %153, 0
  %155 = zext i1 %154 to i64
  %156 = icmp sgt i32 %153, -1
  br i1 %156, label %200, label %157

157:
  %158 = load i64, ptr %0, align 8
  br label %195

159:
  %160 = load ptr, ptr %1, align 8
  %161 = getelementptr inbounds nuw i8, ptr %160, i64 8
  %162 = load double, ptr %161, align 8
  %163 = load i64, ptr %48, align 8
  %164 = icmp sgt i64 %163, 0
  br i1 %164, label %165, label %181

165:
  %166 = getelementptr inbounds nuw i8, ptr %48, i64 8
  %167 = load ptr, ptr %166, align 8
  br label %168

168:
  %169 = phi i64 [ 0, %165 ], [ %179, %168 ]
  %170 = phi i64 [ %163, %165 ], [ %178, %168 ]
  %171 = add nuw nsw i64 %170, %169
  %172 = lshr i64 %171, 1
  %173 = getelementptr inbounds nuw i64, ptr %167, i64 %172
  %174 = load i64, ptr %173, align 8
  %175 = sitofp i64 %174 to double
  %176 = fcmp ogt double %162, %175
  %177 = add nuw nsw i64 %172, 1
  %178 = select i1 %176, i64 %170, i64 %172
  %179 = select i1 %176, i64 %177, i64 %169
  %180 = icmp slt i64 %179, %178
  br i1 %180, label %168, label %181

181:
  %182 = phi i64 [ 0, %159 ], [ %179, %168 ]
  %183 = icmp eq i64 %182, %163
  br i1 %183, label %192, label %184

184:
  %185 = getelementptr inbounds nuw i8, ptr %48, i64 8
  %186 = load ptr, ptr %185, align 8
  %187 = getelementptr inbounds nuw i64, ptr %186, i64 %182
  %188 = load i64, ptr %187, align 8
  %189 = fptosi double %162 to i64
  %190 = sub nsw i64 %188, %189
  %191 = call i64 @llvm.smin.i64(i64 %190, i64 %47)
  br label %192

192:
  %193 = phi i64 [ %47, %181 ], [ %191, %184 ], [ %47, %50 ]
  %194 = icmp slt i64 %193, 0
  br i1 %194, label %195, label %200

195:
  %196 = phi i64 [ %158, %157 ], [ %38, %192 ]
  %197 = getelementptr double, ptr %8, i64 %196
  %198 = getelementptr i8, ptr %197, i64 8
  store double 5.000000e+00, ptr %198, align 8
  br label %340

199:
  br label %200

200:
  %201 = phi i64 [ %193, %192 ], [ %90, %199 ], [ %155, %138 ], [ %90, %134 ]
  %202 = load double, ptr %9, align 8
  %203 = load i64, ptr %0, align 8
  %204 = shl i64 %203, 3
  call void @llvm.memcpy.p0.p0.i64(ptr align 8 %3, ptr nonnull align 8 %8, i64 %204, i1 false)
  %205 = icmp eq i64 %201, 0
  br i1 %205, label %229, label %206

206:
  %207 = load ptr, ptr %1, align 8
  %208 = load double, ptr %207, align 8
  %209 = load i64, ptr %0, align 8
  %210 = getelementptr inbounds double, ptr %207, i64 %209
  %211 = load double, ptr %210, align 8
  %212 = fcmp une double %208, %211
  br i1 %212, label %213, label %223

213:
  %214 = load ptr, ptr %25, align 8
  %215 = load ptr, ptr %26, align 8
  %216 = load ptr, ptr %27, align 8
  call void %214(ptr noundef nonnull %207, ptr noundef %215, ptr noundef %216, i64 noundef 1)
  %217 = load ptr, ptr %1, align 8
  %218 = load i64, ptr %0, align 8
  %219 = getelementptr inbounds double, ptr %217, i64 %218
  %220 = load double, ptr %219, align 8
  store double %220, ptr %217, align 8
  %221 = add nsw i64 %201, -1
  %222 = icmp eq i64 %221, 0
  br i1 %222, label %230, label %223

223:
  %224 = phi ptr [ %217, %213 ], [ %207, %206 ]
  %225 = phi i64 [ %221, %213 ], [ %201, %206 ]
  %226 = load ptr, ptr %25, align 8
  %227 = load ptr, ptr %26, align 8
  %228 = load ptr, ptr %27, align 8
  call void %226(ptr noundef nonnull %224, ptr noundef %227, ptr noundef %228, i64 noundef %225)
  br label %230

229:
  call fastcc void @one_step(ptr noundef nonnull %0, ptr noundef %1, i32 noundef 0, ptr %4, ptr %5)
  br label %230

230:
  %231 = load i64, ptr %28, align 8
  %232 = icmp sgt i64 %231, 0
  br i1 %232, label %233, label %337

233:
  %234 = load i64, ptr %29, align 8
  %235 = getelementptr inbounds double, ptr %8, i64 %234
  %236 = load double, ptr %235, align 8
  %237 = fcmp olt double %236, 1.000000e+300
  br i1 %237, label %238, label %337

238:
  %239 = fadd double %236, -1.000000e+00
  %240 = fsub double %239, %202
  %241 = fptosi double %240 to i64
  %242 = load i64, ptr %0, align 8
  %243 = shl i64 %242, 3
  call void @llvm.memcpy.p0.p0.i64(ptr nonnull align 8 %8, ptr align 8 %3, i64 %243, i1 false)
  %244 = icmp sgt i64 %241, 0
  br i1 %244, label %245, label %268

245:
  %246 = load ptr, ptr %1, align 8
  %247 = load double, ptr %246, align 8
  %248 = load i64, ptr %0, align 8
  %249 = getelementptr inbounds double, ptr %246, i64 %248
  %250 = load double, ptr %249, align 8
  %251 = fcmp une double %247, %250
  br i1 %251, label %252, label %262

252:
  %253 = load ptr, ptr %25, align 8
  %254 = load ptr, ptr %26, align 8
  %255 = load ptr, ptr %27, align 8
  call void %253(ptr noundef nonnull %246, ptr noundef %254, ptr noundef %255, i64 noundef 1)
  %256 = load ptr, ptr %1, align 8
  %257 = load i64, ptr %0, align 8
  %258 = getelementptr inbounds double, ptr %256, i64 %257
  %259 = load double, ptr %258, align 8
  store double %259, ptr %256, align 8
  %260 = add nsw i64 %241, -1
  %261 = icmp eq i64 %260, 0
  br i1 %261, label %268, label %262

262:
  %263 = phi ptr [ %256, %252 ], [ %246, %245 ]
  %264 = phi i64 [ %260, %252 ], [ %241, %245 ]
  %265 = load ptr, ptr %25, align 8
  %266 = load ptr, ptr %26, align 8
  %267 = load ptr, ptr %27, align 8
  call void %265(ptr noundef nonnull %263, ptr noundef %266, ptr noundef %267, i64 noundef %264)
  br label %268

268:
  %269 = load ptr, ptr %30, align 8
  %270 = icmp eq ptr %269, null
  br i1 %270, label %275, label %271

271:
  %272 = getelementptr inbounds nuw i8, ptr %269, i64 16
  %273 = load i64, ptr %272, align 8
  %274 = icmp slt i64 %273, 200
  br i1 %274, label %340, label %275

275:
  %276 = load i64, ptr %0, align 8
  %277 = getelementptr inbounds double, ptr %4, i64 %276
  %278 = load ptr, ptr %1, align 8
  %279 = load ptr, ptr %31, align 8
  %280 = shl i64 %276, 3
  call void @llvm.memcpy.p0.p0.i64(ptr align 8 %279, ptr align 8 %278, i64 %280, i1 false)
  %281 = load ptr, ptr %31, align 8
  %282 = load i64, ptr %29, align 8
  %283 = getelementptr inbounds double, ptr %281, i64 %282
  store double 1.000000e+300, ptr %283, align 8
  store i32 0, ptr %32, align 8
  %284 = load ptr, ptr %33, align 8
  %285 = load i64, ptr %28, align 8
  %286 = shl i64 %285, 2
  %287 = add i64 %286, 4
  call void @llvm.memset.p0.i64(ptr align 4 %284, i8 0, i64 %287, i1 false)
  call fastcc void @one_step(ptr noundef nonnull %0, ptr noundef nonnull %1, i32 noundef 1, ptr %277, ptr %5)
  %288 = load i64, ptr %29, align 8
  %289 = getelementptr inbounds double, ptr %278, i64 %288
  store double 1.000000e+300, ptr %289, align 8
  %290 = load i32, ptr %32, align 8
  %291 = icmp eq i32 %290, 0
  br i1 %291, label %292, label %337

292:
  %293 = load i64, ptr %0, align 8
  %294 = shl i64 %293, 3
  call void @llvm.memcpy.p0.p0.i64(ptr align 8 %4, ptr nonnull align 8 %278, i64 %294, i1 false)
  %295 = load ptr, ptr %31, align 8
  %296 = load i64, ptr %0, align 8
  %297 = shl i64 %296, 3
  call void @llvm.memcpy.p0.p0.i64(ptr nonnull align 8 %278, ptr align 8 %295, i64 %297, i1 false)
  call fastcc void @one_step(ptr noundef nonnull %0, ptr noundef nonnull %1, i32 noundef 0, ptr %277, ptr %5)
  %298 = load i64, ptr %34, align 8
  %299 = getelementptr inbounds double, ptr %4, i64 %298
  %300 = getelementptr inbounds double, ptr %278, i64 %298
  %301 = load i64, ptr %28, align 8
  %302 = icmp sgt i64 %301, 0
  br i1 %302, label %303, label %334

303:
  %304 = load ptr, ptr %35, align 8
  br label %305

305:
  %306 = phi i64 [ 0, %303 ], [ %328, %325 ]
  %307 = phi i1 [ false, %303 ], [ %327, %325 ]
  %308 = getelementptr inbounds nuw double, ptr %299, i64 %306
  %309 = load double, ptr %308, align 8
  %310 = getelementptr inbounds nuw double, ptr %300, i64 %306
  %311 = load double, ptr %310, align 8
  %312 = getelementptr inbounds nuw %struct.Event, ptr %304, i64 %306
  %313 = load i32, ptr %312, align 8
  %314 = icmp sgt i32 %313, -1
  %315 = fcmp olt double %309, 0.000000e+00
  %316 = and i1 %315, %314
  %317 = fcmp oge double %311, 0.000000e+00
  %318 = and i1 %317, %316
  br i1 %318, label %325, label %319

319:
  %320 = icmp slt i32 %313, 1
  %321 = fcmp ogt double %309, 0.000000e+00
  %322 = and i1 %321, %320
  %323 = fcmp ole double %311, 0.000000e+00
  %324 = and i1 %323, %322
  br label %325

325:
  %326 = phi i1 [ true, %305 ], [ %324, %319 ]
  %327 = or i1 %307, %326
  %328 = add nuw nsw i64 %306, 1
  %329 = icmp eq i64 %328, %301
  br i1 %329, label %330, label %305

330:
  br i1 %327, label %331, label %334

331:
  %332 = load i64, ptr %0, align 8
  %333 = shl i64 %332, 3
  call void @llvm.memcpy.p0.p0.i64(ptr nonnull align 8 %278, ptr nonnull align 8 %4, i64 %333, i1 false)
  br label %334

334:
  %335 = load i64, ptr %29, align 8
  %336 = getelementptr inbounds double, ptr %278, i64 %335
  store double 1.000000e+300, ptr %336, align 8
  br label %337

337:
  %338 = load double, ptr %9, align 8
  %339 = fcmp olt double %338, %2
  br i1 %339, label %36, label %340

340:
  %341 = phi i32 [ 0, %195 ], [ 0, %6 ], [ 0, %36 ], [ 0, %337 ], [ 1, %271 ]
  ret i32 %341
}

define i64 @run_rows(ptr noundef %0, ptr noundef %1, ptr noundef %2, ptr noundef %3, ptr noundef %4, ptr noundef %5, ptr noundef %6, ptr noundef readonly captures(none) %7, i64 noundef %8, ptr noundef writeonly captures(none) %9) {
  %11 = alloca %struct.Run, align 8
  %12 = getelementptr inbounds nuw i8, ptr %11, i64 144
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(48) %12, i8 0, i64 32, i1 false)
  store ptr %3, ptr %11, align 8
  %13 = getelementptr inbounds nuw i8, ptr %11, i64 120
  store ptr %5, ptr %13, align 8
  %14 = getelementptr inbounds nuw i8, ptr %11, i64 128
  store ptr %4, ptr %14, align 8
  %15 = getelementptr inbounds nuw i8, ptr %0, i64 40
  %16 = load i64, ptr %15, align 8
  %17 = getelementptr inbounds double, ptr %5, i64 %16
  %18 = load double, ptr %17, align 8
  %19 = getelementptr inbounds nuw i8, ptr %11, i64 136
  store double %18, ptr %19, align 8
  %20 = getelementptr inbounds nuw i8, ptr %0, i64 112
  %21 = load i64, ptr %20, align 8
  %22 = getelementptr inbounds double, ptr %6, i64 %21
  %23 = getelementptr inbounds nuw i8, ptr %11, i64 8
  store ptr %22, ptr %23, align 8
  %24 = getelementptr inbounds nuw i8, ptr %11, i64 16
  store ptr %6, ptr %24, align 8
  %25 = getelementptr inbounds nuw i8, ptr %0, i64 16
  %26 = load i64, ptr %25, align 8
  %27 = getelementptr inbounds double, ptr %6, i64 %26
  %28 = getelementptr inbounds nuw i8, ptr %11, i64 24
  store ptr %27, ptr %28, align 8
  %29 = getelementptr inbounds double, ptr %27, i64 %26
  %30 = getelementptr inbounds nuw i8, ptr %11, i64 32
  store ptr %29, ptr %30, align 8
  %31 = getelementptr inbounds double, ptr %29, i64 %26
  %32 = getelementptr inbounds nuw i8, ptr %11, i64 40
  store ptr %31, ptr %32, align 8
  %33 = load i64, ptr %0, align 8
  %34 = getelementptr inbounds double, ptr %31, i64 %33
  %35 = getelementptr inbounds nuw i8, ptr %11, i64 48
  store ptr %34, ptr %35, align 8
  %36 = getelementptr inbounds nuw i8, ptr %0, i64 24
  %37 = load i64, ptr %36, align 8
  %38 = getelementptr inbounds double, ptr %34, i64 %37
  %39 = getelementptr inbounds nuw i8, ptr %0, i64 32
  %40 = load i64, ptr %39, align 8
  %41 = getelementptr inbounds double, ptr %38, i64 %40
  %42 = getelementptr inbounds nuw i8, ptr %11, i64 56
  store ptr %41, ptr %42, align 8
  %43 = getelementptr inbounds double, ptr %41, i64 %40
  %44 = getelementptr inbounds nuw i8, ptr %11, i64 64
  store ptr %43, ptr %44, align 8
  %45 = getelementptr inbounds nuw i8, ptr %0, i64 56
  %46 = load i64, ptr %45, align 8
  %47 = mul i64 %46, 4000
  %48 = getelementptr i8, ptr %43, i64 %47
  %49 = getelementptr i8, ptr %48, i64 4000
  %50 = getelementptr inbounds nuw i8, ptr %11, i64 72
  store ptr %49, ptr %50, align 8
  %51 = getelementptr inbounds nuw i8, ptr %0, i64 336
  %52 = load i64, ptr %51, align 8
  %53 = getelementptr inbounds double, ptr %49, i64 %52
  %54 = getelementptr inbounds nuw i8, ptr %11, i64 80
  store ptr %53, ptr %54, align 8
  %55 = getelementptr double, ptr %53, i64 %46
  %56 = getelementptr i8, ptr %55, i64 8
  %57 = getelementptr inbounds nuw i8, ptr %11, i64 88
  store ptr %56, ptr %57, align 8
  %58 = getelementptr double, ptr %56, i64 %46
  %59 = getelementptr i8, ptr %58, i64 8
  %60 = getelementptr inbounds nuw i8, ptr %11, i64 96
  store ptr %59, ptr %60, align 8
  %61 = getelementptr inbounds nuw i8, ptr %0, i64 72
  %62 = load i64, ptr %61, align 8
  %63 = getelementptr inbounds double, ptr %59, i64 %62
  %64 = getelementptr inbounds nuw i8, ptr %11, i64 112
  store ptr %63, ptr %64, align 8
  %65 = shl nsw i64 %62, 5
  %66 = getelementptr inbounds i8, ptr %63, i64 %65
  %67 = getelementptr inbounds nuw i8, ptr %11, i64 104
  store ptr %66, ptr %67, align 8
  %68 = getelementptr inbounds nuw i8, ptr %66, i64 1536
  %69 = getelementptr inbounds nuw i8, ptr %0, i64 344
  %70 = load i64, ptr %69, align 8
  %71 = getelementptr inbounds double, ptr %68, i64 %70
  %72 = getelementptr inbounds nuw i8, ptr %11, i64 160
  store ptr %71, ptr %72, align 8
  %73 = getelementptr i32, ptr %71, i64 %46
  %74 = getelementptr i8, ptr %73, i64 4
  %75 = shl i64 %37, 3
  tail call void @llvm.memcpy.p0.p0.i64(ptr align 8 %34, ptr align 8 %4, i64 %75, i1 false)
  %76 = load i64, ptr %36, align 8
  %77 = getelementptr inbounds double, ptr %34, i64 %76
  %78 = load i64, ptr %39, align 8
  %79 = shl i64 %78, 3
  tail call void @llvm.memcpy.p0.p0.i64(ptr align 8 %77, ptr align 8 %5, i64 %79, i1 false)
  %80 = load i64, ptr %0, align 8
  %81 = getelementptr inbounds double, ptr %68, i64 %80
  %82 = getelementptr inbounds nuw i8, ptr %11, i64 176
  store ptr %1, ptr %82, align 8
  %83 = getelementptr inbounds nuw i8, ptr %11, i64 184
  store ptr %2, ptr %83, align 8
  %84 = getelementptr inbounds nuw i8, ptr %2, i64 24
  %85 = icmp sgt i64 %8, 0
  br i1 %85, label %86, label %108

86:
  %87 = phi i64 [ %106, %102 ], [ 0, %10 ]
  %88 = getelementptr inbounds nuw i64, ptr %7, i64 %87
  %89 = load i64, ptr %88, align 8
  %90 = sitofp i64 %89 to double
  %91 = call fastcc i32 @advance(ptr noundef nonnull %0, ptr noundef %11, double noundef %90, ptr noundef nonnull %68, ptr nonnull %81, ptr %74)
  %92 = icmp eq i32 %91, 0
  br i1 %92, label %93, label %108

93:
  %94 = load i64, ptr %0, align 8
  %95 = getelementptr double, ptr %3, i64 %94
  %96 = getelementptr i8, ptr %95, i64 8
  %97 = load double, ptr %96, align 8
  %98 = fcmp une double %97, 0.000000e+00
  br i1 %98, label %108, label %99

99:
  %100 = load i64, ptr %84, align 8
  %101 = icmp eq i64 %100, 0
  br i1 %101, label %102, label %108

102:
  %103 = mul nsw i64 %94, %87
  %104 = getelementptr inbounds double, ptr %9, i64 %103
  %105 = shl i64 %94, 3
  call void @llvm.memcpy.p0.p0.i64(ptr align 8 %104, ptr nonnull align 8 %3, i64 %105, i1 false)
  %106 = add nuw nsw i64 %87, 1
  %107 = icmp eq i64 %106, %8
  br i1 %107, label %108, label %86

108:
  %109 = phi i64 [ 0, %10 ], [ %8, %102 ], [ %87, %86 ], [ %87, %93 ], [ %87, %99 ]
  ret i64 %109
}

declare double @llvm.fabs.f64(double)

define internal fastcc range(i32 0, 2) i32 @complementary(ptr noundef readonly captures(none) %0, ptr noundef nonnull readonly captures(none) %1, ptr captures(none) %2, ptr captures(none) %3) unnamed_addr {
  %5 = getelementptr inbounds nuw i8, ptr %1, i64 32
  %6 = load ptr, ptr %5, align 8
  %7 = load i32, ptr %1, align 8
  %8 = sext i32 %7 to i64
  %9 = icmp sgt i32 %7, 0
  br i1 %9, label %10, label %20

10:
  %11 = phi double [ %18, %10 ], [ 0.000000e+00, %4 ]
  %12 = phi i64 [ %13, %10 ], [ %8, %4 ]
  %13 = add nsw i64 %12, -1
  %14 = getelementptr inbounds double, ptr %6, i64 %13
  %15 = load double, ptr %14, align 8
  %16 = tail call double @llvm.fabs.f64(double %15)
  %17 = fcmp ogt double %16, %11
  %18 = select i1 %17, double %16, double %11
  %19 = icmp samesign ugt i64 %12, 1
  br i1 %19, label %10, label %23

20:
  %21 = getelementptr inbounds nuw i8, ptr %0, i64 280
  %22 = load i64, ptr %21, align 8
  br label %58

23:
  %24 = getelementptr inbounds nuw i8, ptr %0, i64 280
  %25 = load i64, ptr %24, align 8
  %26 = getelementptr inbounds nuw i8, ptr %1, i64 48
  %27 = load ptr, ptr %26, align 8
  %28 = getelementptr inbounds nuw i8, ptr %1, i64 40
  %29 = load ptr, ptr %28, align 8
  %30 = getelementptr inbounds nuw i8, ptr %1, i64 8
  %31 = load ptr, ptr %30, align 8
  br label %32

32:
  %33 = phi i64 [ 0, %23 ], [ %54, %51 ]
  %34 = phi double [ 0.000000e+00, %23 ], [ %52, %51 ]
  %35 = getelementptr inbounds nuw double, ptr %27, i64 %33
  %36 = load double, ptr %35, align 8
  %37 = fcmp ueq double %36, 0x7FF0000000000000
  br i1 %37, label %42, label %38

38:
  %39 = tail call double @llvm.fabs.f64(double %36)
  %40 = fcmp ogt double %39, %34
  %41 = select i1 %40, double %39, double %34
  br label %42

42:
  %43 = phi double [ %41, %38 ], [ %34, %32 ]
  %44 = getelementptr inbounds nuw double, ptr %29, i64 %33
  %45 = load double, ptr %44, align 8
  %46 = fcmp ueq double %45, 0xFFF0000000000000
  br i1 %46, label %51, label %47

47:
  %48 = tail call double @llvm.fabs.f64(double %45)
  %49 = fcmp ogt double %48, %43
  %50 = select i1 %49, double %48, double %43
  br label %51

51:
  %52 = phi double [ %50, %47 ], [ %43, %42 ]
  %53 = getelementptr inbounds nuw i32, ptr %31, i64 %33
  store i32 0, ptr %53, align 4
  %54 = add nuw nsw i64 %33, 1
  %55 = load i32, ptr %1, align 8
  %56 = sext i32 %55 to i64
  %57 = icmp slt i64 %54, %56
  br i1 %57, label %32, label %58

58:
  %59 = phi i64 [ %22, %20 ], [ %25, %51 ]
  %60 = phi ptr [ %21, %20 ], [ %24, %51 ]
  %61 = phi double [ 0.000000e+00, %20 ], [ %18, %51 ]
  %62 = phi i64 [ %8, %20 ], [ %56, %51 ]
  %63 = phi double [ 0.000000e+00, %20 ], [ %52, %51 ]
  %64 = phi i32 [ %7, %20 ], [ %55, %51 ]
  %65 = getelementptr inbounds i32, ptr %3, i64 %59
  %66 = getelementptr inbounds nuw i8, ptr %1, i64 24
  %67 = load ptr, ptr %66, align 8
  %68 = icmp eq i32 %64, 0
  br i1 %68, label %81, label %69

69:
  %70 = mul nsw i64 %62, %62
  br label %71

71:
  %72 = phi double [ %79, %71 ], [ 0.000000e+00, %69 ]
  %73 = phi i64 [ %74, %71 ], [ %70, %69 ]
  %74 = add nsw i64 %73, -1
  %75 = getelementptr inbounds double, ptr %67, i64 %74
  %76 = load double, ptr %75, align 8
  %77 = tail call double @llvm.fabs.f64(double %76)
  %78 = fcmp ogt double %77, %72
  %79 = select i1 %78, double %77, double %72
  %80 = icmp samesign ugt i64 %73, 1
  br i1 %80, label %71, label %81

81:
  %82 = phi double [ 0.000000e+00, %58 ], [ %79, %71 ]
  %83 = fmul double %63, %82
  %84 = fadd double %61, %83
  %85 = fmul double %84, 0x3D719799812DEA11
  tail call fastcc void @balance(ptr noundef %0, ptr noundef %1, ptr %2, ptr %65)
  %86 = load i32, ptr %1, align 8
  %87 = icmp sgt i32 %86, 0
  br i1 %87, label %88, label %97

88:
  %89 = getelementptr inbounds nuw i8, ptr %1, i64 48
  %90 = load ptr, ptr %89, align 8
  %91 = getelementptr inbounds nuw i8, ptr %1, i64 40
  %92 = load ptr, ptr %91, align 8
  %93 = getelementptr inbounds nuw i8, ptr %1, i64 16
  %94 = getelementptr inbounds nuw i8, ptr %1, i64 56
  %95 = getelementptr inbounds nuw i8, ptr %1, i64 8
  %96 = load ptr, ptr %95, align 8
  br label %109

97:
  %98 = phi i32 [ %86, %81 ], [ %133, %129 ]
  %99 = icmp sgt i32 %98, -10
  br i1 %99, label %100, label %294

100:
  %101 = getelementptr inbounds nuw i8, ptr %1, i64 48
  %102 = getelementptr inbounds nuw i8, ptr %1, i64 40
  %103 = fmul double %63, 0x3D719799812DEA11
  %104 = fmul double %61, 0x3D719799812DEA11
  %105 = getelementptr inbounds nuw i8, ptr %1, i64 56
  %106 = getelementptr inbounds nuw i8, ptr %1, i64 8
  %107 = getelementptr inbounds nuw i8, ptr %1, i64 16
  %108 = fmul double %85, 1.000000e+06
  br label %136

109:
  %110 = phi i64 [ 0, %88 ], [ %132, %129 ]
  %111 = getelementptr inbounds nuw double, ptr %90, i64 %110
  %112 = load double, ptr %111, align 8
  %113 = getelementptr inbounds nuw double, ptr %92, i64 %110
  %114 = load double, ptr %113, align 8
  %115 = fcmp ugt double %112, %114
  br i1 %115, label %116, label %129

116:
  %117 = load ptr, ptr %93, align 8
  %118 = getelementptr inbounds nuw i32, ptr %117, i64 %110
  %119 = load i32, ptr %118, align 4
  %120 = icmp eq i32 %119, 0
  br i1 %120, label %129, label %121

121:
  %122 = load ptr, ptr %94, align 8
  %123 = getelementptr inbounds nuw double, ptr %122, i64 %110
  %124 = load double, ptr %123, align 8
  %125 = fsub double %112, %124
  %126 = fsub double %124, %114
  %127 = fcmp ole double %125, %126
  %128 = select i1 %127, i32 1, i32 -1
  br label %129

129:
  %130 = phi i32 [ 1, %109 ], [ %128, %121 ], [ 0, %116 ]
  %131 = getelementptr inbounds nuw i32, ptr %96, i64 %110
  store i32 %130, ptr %131, align 4
  %132 = add nuw nsw i64 %110, 1
  %133 = load i32, ptr %1, align 8
  %134 = sext i32 %133 to i64
  %135 = icmp slt i64 %132, %134
  br i1 %135, label %109, label %97

136:
  %137 = phi i32 [ 0, %100 ], [ %286, %285 ]
  %138 = load i64, ptr %60, align 8
  %139 = shl i64 %138, 2
  tail call void @llvm.memset.p0.i64(ptr align 4 %3, i8 0, i64 %139, i1 false)
  tail call fastcc void @balance(ptr noundef %0, ptr noundef %1, ptr %2, ptr %65)
  %140 = load i32, ptr %1, align 8
  %141 = icmp sgt i32 %140, 0
  br i1 %141, label %142, label %239

142:
  %143 = load ptr, ptr %66, align 8
  %144 = load ptr, ptr %101, align 8
  %145 = load ptr, ptr %105, align 8
  %146 = load ptr, ptr %102, align 8
  %147 = load ptr, ptr %5, align 8
  %148 = load ptr, ptr %106, align 8
  %149 = load ptr, ptr %107, align 8
  br label %150

150:
  %151 = phi i32 [ %140, %142 ], [ %233, %232 ]
  %152 = phi i64 [ 0, %142 ], [ %236, %232 ]
  %153 = phi i32 [ -1, %142 ], [ %220, %232 ]
  %154 = phi double [ 0.000000e+00, %142 ], [ %235, %232 ]
  %155 = phi double [ 0.000000e+00, %142 ], [ %219, %232 ]
  %156 = phi i32 [ -1, %142 ], [ %234, %232 ]
  %157 = add i32 %151, 1
  %158 = trunc nuw nsw i64 %152 to i32
  %159 = mul i32 %157, %158
  %160 = sext i32 %159 to i64
  %161 = getelementptr inbounds double, ptr %143, i64 %160
  %162 = load double, ptr %161, align 8
  %163 = getelementptr inbounds nuw double, ptr %144, i64 %152
  %164 = load double, ptr %163, align 8
  %165 = fcmp ueq double %164, 0x7FF0000000000000
  %166 = getelementptr inbounds nuw double, ptr %146, i64 %152
  %167 = load double, ptr %166, align 8
  %168 = fcmp ueq double %167, 0xFFF0000000000000
  %169 = select i1 %165, i1 true, i1 %168
  br i1 %169, label %170, label %175

170:
  %171 = fcmp ogt double %162, 1.000000e-300
  %172 = select i1 %171, double %162, double 1.000000e-300
  %173 = fdiv double %104, %172
  %174 = fadd double %173, 1.000000e-300
  br label %175

175:
  %176 = phi double [ %174, %170 ], [ 0.000000e+00, %150 ]
  %177 = fadd double %103, %176
  %178 = getelementptr inbounds nuw double, ptr %145, i64 %152
  %179 = load double, ptr %178, align 8
  %180 = fsub double %179, %164
  %181 = fsub double %167, %179
  %182 = fcmp ogt double %180, %181
  %183 = select i1 %182, double %180, double %181
  %184 = fadd double %177, %183
  %185 = fmul double %162, %184
  %186 = getelementptr inbounds nuw double, ptr %147, i64 %152
  %187 = load double, ptr %186, align 8
  %188 = icmp sgt i32 %151, 0
  br i1 %188, label %189, label %204

189:
  %190 = zext nneg i32 %151 to i64
  %191 = getelementptr double, ptr %143, i64 %152
  br label %192

192:
  %193 = phi i64 [ 0, %189 ], [ %202, %192 ]
  %194 = phi double [ 0.000000e+00, %189 ], [ %201, %192 ]
  %195 = mul nuw nsw i64 %193, %190
  %196 = getelementptr double, ptr %191, i64 %195
  %197 = load double, ptr %196, align 8
  %198 = getelementptr inbounds nuw double, ptr %145, i64 %193
  %199 = load double, ptr %198, align 8
  %200 = fmul double %197, %199
  %201 = fadd double %194, %200
  %202 = add nuw nsw i64 %193, 1
  %203 = icmp eq i64 %202, %190
  br i1 %203, label %204, label %192

204:
  %205 = phi double [ 0.000000e+00, %175 ], [ %201, %192 ]
  %206 = fadd double %187, %205
  %207 = getelementptr inbounds nuw i32, ptr %148, i64 %152
  %208 = load i32, ptr %207, align 4
  %209 = sitofp i32 %208 to double
  %210 = fmul double %206, %209
  %211 = getelementptr inbounds nuw i32, ptr %149, i64 %152
  %212 = load i32, ptr %211, align 4
  %213 = icmp eq i32 %212, 0
  %214 = select i1 %213, double %85, double %108
  %215 = fsub double %210, %214
  %216 = icmp eq i32 %208, 0
  %217 = fcmp ogt double %185, %155
  %218 = select i1 %216, i1 %217, i1 false
  %219 = select i1 %218, double %185, double %155
  %220 = select i1 %218, i32 %158, i32 %153
  %221 = fcmp ugt double %164, %167
  br i1 %221, label %227, label %222

222:
  %223 = fcmp ogt double %206, 0.000000e+00
  %224 = select i1 %223, i32 -1, i32 1
  %225 = getelementptr inbounds nuw i32, ptr %3, i64 %152
  store i32 %224, ptr %225, align 4
  %226 = load i32, ptr %1, align 8
  br label %232

227:
  %228 = icmp ne i32 %208, 0
  %229 = fcmp ogt double %215, %154
  %230 = select i1 %228, i1 %229, i1 false
  br i1 %230, label %231, label %232

231:
  br label %232

232:
  %233 = phi i32 [ %226, %222 ], [ %151, %231 ], [ %151, %227 ]
  %234 = phi i32 [ %156, %222 ], [ %158, %231 ], [ %156, %227 ]
  %235 = phi double [ %154, %222 ], [ %215, %231 ], [ %154, %227 ]
  %236 = add nuw nsw i64 %152, 1
  %237 = sext i32 %233 to i64
  %238 = icmp slt i64 %236, %237
  br i1 %238, label %150, label %239

239:
  %240 = phi i32 [ %140, %136 ], [ %233, %232 ]
  %241 = phi i32 [ -1, %136 ], [ %234, %232 ]
  %242 = phi i32 [ -1, %136 ], [ %220, %232 ]
  %243 = icmp sgt i32 %242, -1
  %244 = icmp sgt i32 %241, -1
  %245 = select i1 %243, i1 true, i1 %244
  br i1 %245, label %263, label %246

246:
  %247 = icmp sgt i32 %240, 0
  br i1 %247, label %248, label %294

248:
  %249 = phi i32 [ %259, %258 ], [ %240, %246 ]
  %250 = phi i64 [ %260, %258 ], [ 0, %246 ]
  %251 = getelementptr inbounds nuw i32, ptr %3, i64 %250
  %252 = load i32, ptr %251, align 4
  %253 = icmp eq i32 %252, 0
  br i1 %253, label %258, label %254

254:
  %255 = load ptr, ptr %106, align 8
  %256 = getelementptr inbounds nuw i32, ptr %255, i64 %250
  store i32 %252, ptr %256, align 4
  %257 = load i32, ptr %1, align 8
  br label %258

258:
  %259 = phi i32 [ %249, %248 ], [ %257, %254 ]
  %260 = add nuw nsw i64 %250, 1
  %261 = sext i32 %259 to i64
  %262 = icmp slt i64 %260, %261
  br i1 %262, label %248, label %294

263:
  br i1 %243, label %264, label %281

264:
  %265 = load ptr, ptr %101, align 8
  %266 = zext nneg i32 %242 to i64
  %267 = getelementptr inbounds nuw double, ptr %265, i64 %266
  %268 = load double, ptr %267, align 8
  %269 = load ptr, ptr %105, align 8
  %270 = getelementptr inbounds nuw double, ptr %269, i64 %266
  %271 = load double, ptr %270, align 8
  %272 = fsub double %268, %271
  %273 = load ptr, ptr %102, align 8
  %274 = getelementptr inbounds nuw double, ptr %273, i64 %266
  %275 = load double, ptr %274, align 8
  %276 = fsub double %271, %275
  %277 = fcmp ole double %272, %276
  %278 = select i1 %277, i32 1, i32 -1
  %279 = load ptr, ptr %106, align 8
  %280 = getelementptr inbounds nuw i32, ptr %279, i64 %266
  store i32 %278, ptr %280, align 4
  br label %285

281:
  %282 = load ptr, ptr %106, align 8
  %283 = sext i32 %241 to i64
  %284 = getelementptr inbounds i32, ptr %282, i64 %283
  store i32 0, ptr %284, align 4
  br label %285

285:
  %286 = add nuw nsw i32 %137, 1
  %287 = load i32, ptr %1, align 8
  %288 = shl nsw i32 %287, 1
  %289 = add nsw i32 %288, 19
  %290 = icmp slt i32 %137, %289
  br i1 %290, label %136, label %291

291:
  %292 = icmp eq i32 %287, 0
  %293 = zext i1 %292 to i32
  br label %294

294:
  %295 = phi i32 [ %293, %291 ], [ 1, %246 ], [ 0, %97 ], [ 1, %258 ]
  ret i32 %295
}

define internal fastcc void @balance(ptr noundef readonly captures(none) %0, ptr noundef nonnull readonly captures(none) %1, ptr captures(none) %2, ptr captures(none) %3) unnamed_addr {
  %5 = getelementptr inbounds nuw i8, ptr %0, i64 280
  %6 = load i64, ptr %5, align 8
  %7 = mul nsw i64 %6, %6
  %8 = getelementptr inbounds nuw double, ptr %2, i64 %7
  %9 = getelementptr inbounds double, ptr %8, i64 %6
  %10 = getelementptr inbounds double, ptr %9, i64 %6
  %11 = getelementptr inbounds i32, ptr %3, i64 %6
  %12 = shl i64 %6, 3
  tail call void @llvm.memset.p0.i64(ptr align 8 %9, i8 0, i64 %12, i1 false)
  %13 = load i32, ptr %1, align 8
  %14 = icmp sgt i32 %13, 0
  br i1 %14, label %15, label %77

15:
  %16 = getelementptr inbounds nuw i8, ptr %1, i64 8
  %17 = load ptr, ptr %16, align 8
  %18 = getelementptr inbounds nuw i8, ptr %1, i64 56
  %19 = getelementptr inbounds nuw i8, ptr %1, i64 48
  %20 = getelementptr inbounds nuw i8, ptr %1, i64 40
  br label %27

21:
  %22 = icmp sgt i32 %73, 0
  br i1 %22, label %23, label %77

23:
  %24 = fcmp ogt double %72, 0.000000e+00
  %25 = select i1 %24, double %72, double 1.000000e+00
  %26 = zext nneg i32 %73 to i64
  br label %90

27:
  %28 = phi i32 [ %13, %15 ], [ %71, %70 ]
  %29 = phi i64 [ 0, %15 ], [ %74, %70 ]
  %30 = phi i32 [ 0, %15 ], [ %73, %70 ]
  %31 = phi double [ 0.000000e+00, %15 ], [ %72, %70 ]
  %32 = getelementptr inbounds nuw i32, ptr %17, i64 %29
  %33 = load i32, ptr %32, align 4
  %34 = icmp sgt i32 %33, 0
  br i1 %34, label %35, label %37

35:
  %36 = load ptr, ptr %18, align 8
  br label %40

37:
  %38 = icmp slt i32 %33, 0
  %39 = load ptr, ptr %18, align 8
  br i1 %38, label %40, label %47

40:
  %41 = phi ptr [ %36, %35 ], [ %39, %37 ]
  %42 = phi ptr [ %19, %35 ], [ %20, %37 ]
  %43 = load ptr, ptr %42, align 8
  %44 = getelementptr inbounds nuw double, ptr %43, i64 %29
  %45 = load double, ptr %44, align 8
  %46 = getelementptr inbounds nuw double, ptr %41, i64 %29
  store double %45, ptr %46, align 8
  br label %70

47:
  %48 = getelementptr inbounds nuw double, ptr %39, i64 %29
  store double 0.000000e+00, ptr %48, align 8
  %49 = load ptr, ptr %19, align 8
  %50 = getelementptr inbounds nuw double, ptr %49, i64 %29
  %51 = load double, ptr %50, align 8
  %52 = fcmp ueq double %51, 0x7FF0000000000000
  br i1 %52, label %53, label %60

53:
  %54 = load ptr, ptr %20, align 8
  %55 = getelementptr inbounds nuw double, ptr %54, i64 %29
  %56 = load double, ptr %55, align 8
  %57 = fcmp ueq double %56, 0xFFF0000000000000
  br i1 %57, label %60, label %58

58:
  %59 = fneg double %56
  br label %60

60:
  %61 = phi double [ 0.000000e+00, %53 ], [ %59, %58 ], [ %51, %47 ]
  %62 = sext i32 %30 to i64
  %63 = getelementptr inbounds double, ptr %9, i64 %62
  store double %61, ptr %63, align 8
  %64 = fcmp ogt double %61, %31
  %65 = select i1 %64, double %61, double %31
  %66 = add nsw i32 %30, 1
  %67 = getelementptr inbounds i32, ptr %3, i64 %62
  %68 = trunc nuw nsw i64 %29 to i32
  store i32 %68, ptr %67, align 4
  %69 = load i32, ptr %1, align 8
  br label %70

70:
  %71 = phi i32 [ %28, %40 ], [ %69, %60 ]
  %72 = phi double [ %31, %40 ], [ %65, %60 ]
  %73 = phi i32 [ %30, %40 ], [ %66, %60 ]
  %74 = add nuw nsw i64 %29, 1
  %75 = sext i32 %71 to i64
  %76 = icmp slt i64 %74, %75
  br i1 %76, label %27, label %21

77:
  %78 = phi i32 [ %73, %21 ], [ 0, %4 ]
  %79 = zext i32 %78 to i64
  br label %150

80:
  %81 = getelementptr inbounds nuw i8, ptr %1, i64 56
  %82 = load ptr, ptr %81, align 8
  %83 = getelementptr inbounds nuw i8, ptr %1, i64 32
  %84 = load ptr, ptr %83, align 8
  %85 = icmp sgt i32 %71, 0
  %86 = getelementptr inbounds nuw i8, ptr %1, i64 24
  %87 = zext nneg i32 %71 to i64
  %88 = zext nneg i32 %73 to i64
  %89 = load ptr, ptr %86, align 8
  br label %98

90:
  %91 = phi i64 [ 0, %23 ], [ %96, %90 ]
  %92 = getelementptr inbounds nuw double, ptr %9, i64 %91
  %93 = load double, ptr %92, align 8
  %94 = fcmp ogt double %93, 0.000000e+00
  %95 = select i1 %94, double %93, double %25
  store double %95, ptr %92, align 8
  %96 = add nuw nsw i64 %91, 1
  %97 = icmp eq i64 %96, %26
  br i1 %97, label %80, label %90

98:
  %99 = phi i64 [ 0, %80 ], [ %148, %147 ]
  %100 = getelementptr inbounds nuw double, ptr %9, i64 %99
  %101 = load double, ptr %100, align 8
  %102 = fneg double %101
  %103 = getelementptr inbounds nuw i32, ptr %3, i64 %99
  %104 = load i32, ptr %103, align 4
  %105 = sext i32 %104 to i64
  %106 = getelementptr inbounds double, ptr %84, i64 %105
  %107 = load double, ptr %106, align 8
  br i1 %85, label %108, label %123

108:
  %109 = load ptr, ptr %86, align 8
  %110 = getelementptr double, ptr %109, i64 %105
  br label %111

111:
  %112 = phi i64 [ 0, %108 ], [ %121, %111 ]
  %113 = phi double [ 0.000000e+00, %108 ], [ %120, %111 ]
  %114 = mul nuw nsw i64 %112, %87
  %115 = getelementptr double, ptr %110, i64 %114
  %116 = load double, ptr %115, align 8
  %117 = getelementptr inbounds nuw double, ptr %82, i64 %112
  %118 = load double, ptr %117, align 8
  %119 = fmul double %116, %118
  %120 = fadd double %113, %119
  %121 = add nuw nsw i64 %112, 1
  %122 = icmp eq i64 %121, %87
  br i1 %122, label %123, label %111

123:
  %124 = phi double [ 0.000000e+00, %98 ], [ %120, %111 ]
  %125 = fadd double %107, %124
  %126 = fmul double %125, %102
  %127 = getelementptr inbounds nuw double, ptr %8, i64 %99
  store double %126, ptr %127, align 8
  %128 = getelementptr inbounds nuw double, ptr %2, i64 %99
  br label %129

129:
  %130 = phi i64 [ 0, %123 ], [ %145, %129 ]
  %131 = load double, ptr %100, align 8
  %132 = getelementptr inbounds nuw i32, ptr %3, i64 %130
  %133 = load i32, ptr %132, align 4
  %134 = mul nsw i32 %133, %71
  %135 = add nsw i32 %134, %104
  %136 = sext i32 %135 to i64
  %137 = getelementptr inbounds double, ptr %89, i64 %136
  %138 = load double, ptr %137, align 8
  %139 = fmul double %131, %138
  %140 = getelementptr inbounds nuw double, ptr %9, i64 %130
  %141 = load double, ptr %140, align 8
  %142 = fmul double %139, %141
  %143 = mul nuw nsw i64 %130, %88
  %144 = getelementptr inbounds nuw double, ptr %128, i64 %143
  store double %142, ptr %144, align 8
  %145 = add nuw nsw i64 %130, 1
  %146 = icmp eq i64 %145, %88
  br i1 %146, label %147, label %129

147:
  %148 = add nuw nsw i64 %99, 1
  %149 = icmp eq i64 %148, %88
  br i1 %149, label %150, label %98

150:
  %151 = phi i32 [ %78, %77 ], [ %73, %147 ]
  %152 = phi i1 [ false, %77 ], [ true, %147 ]
  %153 = phi i64 [ %79, %77 ], [ %88, %147 ]
  %154 = load i64, ptr %5, align 8
  %155 = mul nsw i64 %154, %154
  %156 = getelementptr inbounds nuw double, ptr %10, i64 %155
  %157 = getelementptr inbounds nuw double, ptr %156, i64 %155
  %158 = getelementptr inbounds i32, ptr %11, i64 %154
  %159 = shl i64 %154, 2
  tail call void @llvm.memset.p0.i64(ptr align 4 %11, i8 0, i64 %159, i1 false)
  %160 = load i64, ptr %5, align 8
  %161 = shl i64 %160, 2
  tail call void @llvm.memset.p0.i64(ptr align 4 %158, i8 0, i64 %161, i1 false)
  %162 = mul nsw i32 %151, %151
  %163 = zext nneg i32 %162 to i64
  %164 = shl nuw nsw i64 %163, 3
  tail call void @llvm.memcpy.p0.p0.i64(ptr align 8 %10, ptr align 8 %2, i64 %164, i1 false)
  %165 = add i32 %151, 1
  br i1 %152, label %168, label %254

166:
  %167 = fmul double %177, 0x3DA5FD7FE1796495
  br label %180

168:
  %169 = phi i64 [ %178, %168 ], [ 0, %150 ]
  %170 = phi double [ %177, %168 ], [ 0.000000e+00, %150 ]
  %171 = trunc nuw nsw i64 %169 to i32
  %172 = mul i32 %165, %171
  %173 = sext i32 %172 to i64
  %174 = getelementptr inbounds double, ptr %2, i64 %173
  %175 = load double, ptr %174, align 8
  %176 = fcmp ogt double %175, %170
  %177 = select i1 %176, double %175, double %170
  %178 = add nuw nsw i64 %169, 1
  %179 = icmp eq i64 %178, %153
  br i1 %179, label %166, label %168

180:
  %181 = phi i64 [ %248, %246 ], [ 0, %166 ]
  br label %182

182:
  %183 = phi i64 [ %204, %202 ], [ 0, %180 ]
  %184 = phi i32 [ %203, %202 ], [ -1, %180 ]
  %185 = getelementptr inbounds nuw i32, ptr %158, i64 %183
  %186 = load i32, ptr %185, align 4
  %187 = icmp eq i32 %186, 0
  br i1 %187, label %188, label %202

188:
  %189 = icmp slt i32 %184, 0
  %190 = trunc nuw nsw i64 %183 to i32
  br i1 %189, label %202, label %191

191:
  %192 = mul i32 %165, %190
  %193 = sext i32 %192 to i64
  %194 = getelementptr inbounds double, ptr %10, i64 %193
  %195 = load double, ptr %194, align 8
  %196 = mul i32 %184, %165
  %197 = sext i32 %196 to i64
  %198 = getelementptr inbounds double, ptr %10, i64 %197
  %199 = load double, ptr %198, align 8
  %200 = fcmp ogt double %195, %199
  br i1 %200, label %201, label %202

201:
  br label %202

202:
  %203 = phi i32 [ %184, %182 ], [ %184, %191 ], [ %190, %201 ], [ %190, %188 ]
  %204 = add nuw nsw i64 %183, 1
  %205 = icmp eq i64 %204, %153
  br i1 %205, label %206, label %182

206:
  %207 = icmp slt i32 %203, 0
  br i1 %207, label %250, label %208

208:
  %209 = mul nuw nsw i32 %203, %151
  %210 = add nuw nsw i32 %209, %203
  %211 = zext nneg i32 %210 to i64
  %212 = getelementptr inbounds nuw double, ptr %10, i64 %211
  %213 = load double, ptr %212, align 8
  %214 = fcmp ugt double %213, %167
  br i1 %214, label %215, label %250

215:
  %216 = zext nneg i32 %203 to i64
  %217 = zext nneg i32 %209 to i64
  %218 = getelementptr inbounds nuw double, ptr %10, i64 %217
  %219 = getelementptr inbounds nuw double, ptr %10, i64 %216
  br label %220

220:
  %221 = phi i64 [ 0, %215 ], [ %244, %243 ]
  %222 = icmp eq i64 %221, %216
  %223 = getelementptr inbounds nuw double, ptr %218, i64 %221
  %224 = getelementptr inbounds nuw double, ptr %10, i64 %221
  br label %225

225:
  %226 = phi i64 [ 0, %220 ], [ %241, %240 ]
  %227 = icmp eq i64 %226, %216
  %228 = or i1 %222, %227
  br i1 %228, label %240, label %229

229:
  %230 = load double, ptr %223, align 8
  %231 = mul nuw nsw i64 %226, %153
  %232 = getelementptr inbounds nuw double, ptr %219, i64 %231
  %233 = load double, ptr %232, align 8
  %234 = fmul double %230, %233
  %235 = load double, ptr %212, align 8
  %236 = fdiv double %234, %235
  %237 = getelementptr inbounds nuw double, ptr %224, i64 %231
  %238 = load double, ptr %237, align 8
  %239 = fsub double %238, %236
  store double %239, ptr %237, align 8
  br label %240

240:
  %241 = add nuw nsw i64 %226, 1
  %242 = icmp eq i64 %241, %153
  br i1 %242, label %243, label %225

243:
  %244 = add nuw nsw i64 %221, 1
  %245 = icmp eq i64 %244, %153
  br i1 %245, label %246, label %220

246:
  %247 = getelementptr inbounds nuw i32, ptr %158, i64 %216
  store i32 1, ptr %247, align 4
  %248 = add nuw i64 %181, 1
  %249 = getelementptr inbounds nuw i32, ptr %11, i64 %181
  store i32 %203, ptr %249, align 4
  br label %180

250:
  %251 = and i64 %181, 4294967295
  %252 = trunc nuw nsw i64 %181 to i32
  %253 = icmp eq i32 %151, %252
  br i1 %253, label %261, label %257

254:
  %255 = icmp eq i32 %151, 0
  br i1 %255, label %261, label %256

256:
  tail call fastcc void @solve(ptr noundef %156, ptr noundef %157, i32 noundef 0)
  br label %344

257:
  %258 = icmp eq i64 %181, 0
  br i1 %258, label %300, label %259

259:
  %260 = and i64 %181, 4294967295
  br label %262

261:
  tail call fastcc void @solve(ptr noundef %2, ptr noundef %8, i32 noundef %151)
  br label %327

262:
  %263 = phi i64 [ 0, %259 ], [ %298, %297 ]
  %264 = getelementptr inbounds nuw i32, ptr %11, i64 %263
  %265 = load i32, ptr %264, align 4
  %266 = sext i32 %265 to i64
  %267 = getelementptr inbounds double, ptr %8, i64 %266
  %268 = load double, ptr %267, align 8
  %269 = getelementptr inbounds nuw double, ptr %157, i64 %263
  store double %268, ptr %269, align 8
  %270 = mul nsw i32 %265, %151
  %271 = sext i32 %270 to i64
  %272 = getelementptr inbounds nuw double, ptr %156, i64 %263
  %273 = getelementptr double, ptr %2, i64 %271
  br label %274

274:
  %275 = phi i64 [ 0, %262 ], [ %295, %294 ]
  %276 = mul nuw nsw i64 %275, %260
  %277 = getelementptr inbounds nuw double, ptr %272, i64 %276
  store double 0.000000e+00, ptr %277, align 8
  %278 = getelementptr inbounds nuw i32, ptr %11, i64 %275
  %279 = load i32, ptr %278, align 4
  %280 = mul nsw i32 %279, %151
  %281 = sext i32 %280 to i64
  %282 = getelementptr double, ptr %2, i64 %281
  br label %283

283:
  %284 = phi i64 [ 0, %274 ], [ %292, %283 ]
  %285 = phi double [ 0.000000e+00, %274 ], [ %291, %283 ]
  %286 = getelementptr double, ptr %273, i64 %284
  %287 = load double, ptr %286, align 8
  %288 = getelementptr double, ptr %282, i64 %284
  %289 = load double, ptr %288, align 8
  %290 = fmul double %287, %289
  %291 = fadd double %285, %290
  store double %291, ptr %277, align 8
  %292 = add nuw nsw i64 %284, 1
  %293 = icmp eq i64 %292, %153
  br i1 %293, label %294, label %283

294:
  %295 = add nuw nsw i64 %275, 1
  %296 = icmp eq i64 %295, %251
  br i1 %296, label %297, label %274

297:
  %298 = add nuw nsw i64 %263, 1
  %299 = icmp eq i64 %298, %251
  br i1 %299, label %300, label %262

300:
  %301 = phi i64 [ 0, %257 ], [ %251, %297 ]
  %302 = phi i32 [ 0, %257 ], [ %252, %297 ]
  tail call fastcc void @solve(ptr noundef %156, ptr noundef %157, i32 noundef %302)
  br label %303

303:
  %304 = phi i64 [ %325, %324 ], [ 0, %300 ]
  %305 = getelementptr inbounds nuw double, ptr %8, i64 %304
  store double 0.000000e+00, ptr %305, align 8
  br i1 %258, label %324, label %306

306:
  %307 = trunc nuw nsw i64 %304 to i32
  br label %308

308:
  %309 = phi i64 [ 0, %306 ], [ %322, %308 ]
  %310 = phi double [ 0.000000e+00, %306 ], [ %321, %308 ]
  %311 = getelementptr inbounds nuw i32, ptr %11, i64 %309
  %312 = load i32, ptr %311, align 4
  %313 = mul nsw i32 %312, %151
  %314 = add nsw i32 %313, %307
  %315 = sext i32 %314 to i64
  %316 = getelementptr inbounds double, ptr %2, i64 %315
  %317 = load double, ptr %316, align 8
  %318 = getelementptr inbounds nuw double, ptr %157, i64 %309
  %319 = load double, ptr %318, align 8
  %320 = fmul double %317, %319
  %321 = fadd double %310, %320
  store double %321, ptr %305, align 8
  %322 = add nuw nsw i64 %309, 1
  %323 = icmp eq i64 %322, %301
  br i1 %323, label %324, label %308

324:
  %325 = add nuw nsw i64 %304, 1
  %326 = icmp eq i64 %325, %153
  br i1 %326, label %327, label %303

327:
  br i1 %152, label %328, label %344

328:
  %329 = getelementptr inbounds nuw i8, ptr %1, i64 56
  %330 = load ptr, ptr %329, align 8
  br label %331

331:
  %332 = phi i64 [ 0, %328 ], [ %342, %331 ]
  %333 = getelementptr inbounds nuw double, ptr %9, i64 %332
  %334 = load double, ptr %333, align 8
  %335 = getelementptr inbounds nuw double, ptr %8, i64 %332
  %336 = load double, ptr %335, align 8
  %337 = fmul double %334, %336
  %338 = getelementptr inbounds nuw i32, ptr %3, i64 %332
  %339 = load i32, ptr %338, align 4
  %340 = sext i32 %339 to i64
  %341 = getelementptr inbounds double, ptr %330, i64 %340
  store double %337, ptr %341, align 8
  %342 = add nuw nsw i64 %332, 1
  %343 = icmp eq i64 %342, %153
  br i1 %343, label %344, label %331

344:
  ret void
}

define internal fastcc void @solve(ptr noundef captures(none) %0, ptr noundef captures(none) %1, i32 noundef %2) unnamed_addr {
  %4 = icmp sgt i32 %2, 0
  br i1 %4, label %5, label %127

5:
  %6 = zext nneg i32 %2 to i64
  %7 = zext nneg i32 %2 to i64
  %8 = add nuw i32 %2, 1
  %9 = zext i32 %8 to i64
  br label %17

10:
  %11 = add nuw nsw i64 %19, 1
  %12 = icmp eq i64 %21, %6
  br i1 %12, label %13, label %17

13:
  %14 = add nuw i32 %2, 1
  %15 = zext nneg i32 %2 to i64
  %16 = zext nneg i32 %2 to i64
  br label %94

17:
  %18 = phi i64 [ 0, %5 ], [ %21, %10 ]
  %19 = phi i64 [ 1, %5 ], [ %11, %10 ]
  %20 = trunc i64 %18 to i32
  %21 = add nuw nsw i64 %18, 1
  %22 = icmp samesign ult i64 %21, %7
  br i1 %22, label %23, label %27

23:
  %24 = mul nuw nsw i64 %18, %6
  %25 = getelementptr inbounds nuw double, ptr %0, i64 %24
  %26 = trunc nuw i64 %24 to i32
  br label %30

27:
  %28 = phi i32 [ %20, %17 ], [ %43, %30 ]
  %29 = sext i32 %28 to i64
  br label %56

30:
  %31 = phi i64 [ %19, %23 ], [ %44, %30 ]
  %32 = phi i32 [ %20, %23 ], [ %43, %30 ]
  %33 = getelementptr inbounds nuw double, ptr %25, i64 %31
  %34 = load double, ptr %33, align 8
  %35 = tail call double @llvm.fabs.f64(double %34)
  %36 = add nsw i32 %32, %26
  %37 = sext i32 %36 to i64
  %38 = getelementptr inbounds double, ptr %0, i64 %37
  %39 = load double, ptr %38, align 8
  %40 = tail call double @llvm.fabs.f64(double %39)
  %41 = fcmp ogt double %35, %40
  %42 = trunc nuw nsw i64 %31 to i32
  %43 = select i1 %41, i32 %42, i32 %32
  %44 = add nuw nsw i64 %31, 1
  %45 = icmp eq i64 %44, %6
  br i1 %45, label %27, label %30

46:
  br i1 %22, label %47, label %10

47:
  %48 = mul nuw nsw i64 %18, %6
  %49 = mul nuw nsw i32 %2, %20
  %50 = zext i32 %49 to i64
  %51 = getelementptr inbounds nuw double, ptr %0, i64 %18
  %52 = getelementptr inbounds nuw double, ptr %51, i64 %50
  %53 = getelementptr inbounds nuw double, ptr %1, i64 %18
  %54 = getelementptr inbounds nuw double, ptr %0, i64 %48
  %55 = getelementptr inbounds nuw double, ptr %0, i64 %18
  br label %68

56:
  %57 = phi i64 [ 0, %27 ], [ %66, %56 ]
  %58 = icmp samesign ult i64 %57, %7
  %59 = mul nuw nsw i64 %57, %6
  %60 = getelementptr inbounds nuw double, ptr %0, i64 %59
  %61 = select i1 %58, ptr %60, ptr %1
  %62 = getelementptr inbounds nuw double, ptr %61, i64 %18
  %63 = load double, ptr %62, align 8
  %64 = getelementptr inbounds double, ptr %61, i64 %29
  %65 = load double, ptr %64, align 8
  store double %65, ptr %62, align 8
  store double %63, ptr %64, align 8
  %66 = add nuw nsw i64 %57, 1
  %67 = icmp eq i64 %66, %9
  br i1 %67, label %46, label %56

68:
  %69 = phi i64 [ %19, %47 ], [ %92, %86 ]
  %70 = getelementptr inbounds nuw double, ptr %54, i64 %69
  %71 = load double, ptr %70, align 8
  %72 = load double, ptr %52, align 8
  %73 = fdiv double %71, %72
  %74 = getelementptr inbounds nuw double, ptr %0, i64 %69
  br label %75

75:
  %76 = phi i64 [ %18, %68 ], [ %84, %75 ]
  %77 = mul nuw nsw i64 %76, %6
  %78 = getelementptr inbounds nuw double, ptr %55, i64 %77
  %79 = load double, ptr %78, align 8
  %80 = fmul double %73, %79
  %81 = getelementptr inbounds nuw double, ptr %74, i64 %77
  %82 = load double, ptr %81, align 8
  %83 = fsub double %82, %80
  store double %83, ptr %81, align 8
  %84 = add nuw nsw i64 %76, 1
  %85 = icmp eq i64 %84, %6
  br i1 %85, label %86, label %75

86:
  %87 = load double, ptr %53, align 8
  %88 = fmul double %73, %87
  %89 = getelementptr inbounds nuw double, ptr %1, i64 %69
  %90 = load double, ptr %89, align 8
  %91 = fsub double %90, %88
  store double %91, ptr %89, align 8
  %92 = add nuw nsw i64 %69, 1
  %93 = icmp eq i64 %92, %6
  br i1 %93, label %10, label %68

94:
  %95 = phi i64 [ %16, %13 ], [ %97, %117 ]
  %96 = phi i64 [ %15, %13 ], [ %98, %117 ]
  %97 = add nsw i64 %95, -1
  %98 = add nsw i64 %96, -1
  %99 = icmp slt i64 %95, %16
  %100 = getelementptr inbounds nuw double, ptr %1, i64 %97
  %101 = load double, ptr %100, align 8
  br i1 %99, label %102, label %117

102:
  %103 = getelementptr double, ptr %0, i64 %97
  br label %104

104:
  %105 = phi i64 [ %96, %102 ], [ %114, %104 ]
  %106 = phi double [ %101, %102 ], [ %113, %104 ]
  %107 = mul nuw nsw i64 %105, %15
  %108 = getelementptr double, ptr %103, i64 %107
  %109 = load double, ptr %108, align 8
  %110 = getelementptr inbounds nuw double, ptr %1, i64 %105
  %111 = load double, ptr %110, align 8
  %112 = fmul double %109, %111
  %113 = fsub double %106, %112
  store double %113, ptr %100, align 8
  %114 = add nuw nsw i64 %105, 1
  %115 = trunc nuw i64 %114 to i32
  %116 = icmp sgt i32 %2, %115
  br i1 %116, label %104, label %117

117:
  %118 = phi double [ %101, %94 ], [ %113, %104 ]
  %119 = trunc nuw nsw i64 %97 to i32
  %120 = mul i32 %14, %119
  %121 = sext i32 %120 to i64
  %122 = getelementptr inbounds double, ptr %0, i64 %121
  %123 = load double, ptr %122, align 8
  %124 = getelementptr inbounds nuw double, ptr %1, i64 %97
  %125 = fdiv double %118, %123
  store double %125, ptr %124, align 8
  %126 = icmp samesign ugt i64 %95, 1
  br i1 %126, label %94, label %127

127:
  ret void
}

declare double @llvm.sqrt.f64(double)

declare double @nextafter(double noundef, double noundef)

define internal fastcc void @look_at_events(ptr noundef readonly captures(none) %0, ptr noundef nonnull readonly captures(none) %1, ptr %2) unnamed_addr {
  %4 = getelementptr inbounds nuw i8, ptr %0, i64 56
  %5 = load i64, ptr %4, align 8
  %6 = add nsw i64 %5, 1
  %7 = getelementptr inbounds double, ptr %2, i64 %6
  %8 = getelementptr inbounds double, ptr %7, i64 %6
  %9 = load ptr, ptr %1, align 8
  %10 = getelementptr inbounds nuw i8, ptr %0, i64 432
  %11 = load ptr, ptr %10, align 8
  %12 = getelementptr inbounds nuw i8, ptr %1, i64 120
  %13 = load ptr, ptr %12, align 8
  %14 = getelementptr inbounds nuw i8, ptr %1, i64 8
  %15 = load ptr, ptr %14, align 8
  tail call void %11(ptr noundef %2, ptr noundef %9, ptr noundef %13, ptr noundef %15)
  %16 = getelementptr inbounds nuw i8, ptr %0, i64 440
  %17 = load ptr, ptr %16, align 8
  %18 = load ptr, ptr %12, align 8
  %19 = load ptr, ptr %14, align 8
  tail call void %17(ptr noundef %7, ptr noundef %9, ptr noundef %18, ptr noundef %19)
  %20 = getelementptr inbounds nuw i8, ptr %0, i64 136
  %21 = load i64, ptr %20, align 8
  %22 = getelementptr inbounds double, ptr %9, i64 %21
  store double 1.000000e+300, ptr %22, align 8
  %23 = load i64, ptr %4, align 8
  %24 = icmp sgt i64 %23, 0
  br i1 %24, label %25, label %32

25:
  %26 = getelementptr inbounds nuw i8, ptr %0, i64 128
  %27 = load i64, ptr %26, align 8
  %28 = getelementptr double, ptr %9, i64 %27
  %29 = getelementptr inbounds nuw i8, ptr %0, i64 144
  %30 = load i64, ptr %29, align 8
  %31 = getelementptr double, ptr %9, i64 %30
  br label %40

32:
  %33 = getelementptr inbounds nuw i8, ptr %0, i64 64
  %34 = load i64, ptr %33, align 8
  %35 = icmp sgt i64 %34, 0
  br i1 %35, label %36, label %55

36:
  %37 = getelementptr inbounds nuw i8, ptr %0, i64 152
  %38 = load i64, ptr %37, align 8
  %39 = getelementptr double, ptr %9, i64 %38
  br label %48

40:
  %41 = phi i64 [ 0, %25 ], [ %46, %40 ]
  %42 = getelementptr inbounds nuw double, ptr %2, i64 %41
  %43 = load double, ptr %42, align 8
  %44 = getelementptr double, ptr %28, i64 %41
  store double %43, ptr %44, align 8
  %45 = getelementptr double, ptr %31, i64 %41
  store double 1.000000e+300, ptr %45, align 8
  %46 = add nuw nsw i64 %41, 1
  %47 = icmp eq i64 %46, %23
  br i1 %47, label %32, label %40

48:
  %49 = phi i64 [ 0, %36 ], [ %53, %48 ]
  %50 = getelementptr inbounds nuw double, ptr %7, i64 %49
  %51 = load double, ptr %50, align 8
  %52 = getelementptr double, ptr %39, i64 %49
  store double %51, ptr %52, align 8
  %53 = add nuw nsw i64 %49, 1
  %54 = icmp eq i64 %53, %34
  br i1 %54, label %55, label %48

55:
  %56 = getelementptr inbounds nuw i8, ptr %0, i64 160
  %57 = load i64, ptr %56, align 8
  %58 = icmp sgt i64 %57, 0
  br i1 %58, label %59, label %81

59:
  %60 = getelementptr inbounds nuw i8, ptr %0, i64 456
  %61 = load ptr, ptr %60, align 8
  %62 = load ptr, ptr %12, align 8
  %63 = load ptr, ptr %14, align 8
  tail call void %61(ptr noundef %8, ptr noundef nonnull %9, ptr noundef %62, ptr noundef %63)
  %64 = load i64, ptr %56, align 8
  %65 = icmp sgt i64 %64, 0
  br i1 %65, label %66, label %81

66:
  %67 = getelementptr inbounds nuw i8, ptr %0, i64 176
  %68 = load i64, ptr %67, align 8
  %69 = getelementptr double, ptr %9, i64 %68
  %70 = getelementptr inbounds nuw i8, ptr %0, i64 168
  %71 = load i64, ptr %70, align 8
  %72 = getelementptr double, ptr %9, i64 %71
  br label %73

73:
  %74 = phi i64 [ 0, %66 ], [ %79, %73 ]
  %75 = getelementptr inbounds nuw double, ptr %8, i64 %74
  %76 = load double, ptr %75, align 8
  %77 = getelementptr double, ptr %69, i64 %74
  store double %76, ptr %77, align 8
  %78 = getelementptr double, ptr %72, i64 %74
  store double %76, ptr %78, align 8
  %79 = add nuw nsw i64 %74, 1
  %80 = icmp eq i64 %79, %64
  br i1 %80, label %81, label %73

81:
  ret void
}

define internal fastcc void @one_step(ptr noundef %0, ptr noundef nonnull %1, i32 noundef range(i32 0, 2) %2, ptr %3, ptr %4) unnamed_addr {
  %6 = alloca [500 x i32], align 16
  %7 = alloca [16 x i32], align 16
  %8 = alloca [16 x i32], align 16
  %9 = getelementptr inbounds nuw i8, ptr %3, i64 4160
  %10 = load ptr, ptr %1, align 8
  %11 = getelementptr inbounds nuw i8, ptr %10, i64 8
  %12 = load double, ptr %11, align 8
  %13 = fadd double %12, 1.000000e+00
  %14 = load i64, ptr %0, align 8
  %15 = getelementptr inbounds double, ptr %10, i64 %14
  %16 = load double, ptr %15, align 8
  %17 = getelementptr inbounds nuw i8, ptr %1, i64 136
  %18 = load double, ptr %17, align 8
  %19 = fmul double %13, %18
  %20 = fadd double %16, %19
  %21 = getelementptr inbounds nuw i8, ptr %1, i64 176
  %22 = load ptr, ptr %21, align 8
  %23 = icmp eq ptr %22, null
  br i1 %23, label %87, label %24

24:
  %25 = load i64, ptr %22, align 8
  %26 = icmp sgt i64 %25, 0
  br i1 %26, label %27, label %43

27:
  %28 = getelementptr inbounds nuw i8, ptr %22, i64 8
  %29 = load ptr, ptr %28, align 8
  br label %30

30:
  %31 = phi i64 [ 0, %27 ], [ %41, %30 ]
  %32 = phi i64 [ %25, %27 ], [ %40, %30 ]
  %33 = add nuw nsw i64 %32, %31
  %34 = lshr i64 %33, 1
  %35 = getelementptr inbounds nuw i64, ptr %29, i64 %34
  %36 = load i64, ptr %35, align 8
  %37 = sitofp i64 %36 to double
  %38 = fcmp ogt double %12, %37
  %39 = add nuw nsw i64 %34, 1
  %40 = select i1 %38, i64 %32, i64 %34
  %41 = select i1 %38, i64 %39, i64 %31
  %42 = icmp slt i64 %41, %40
  br i1 %42, label %30, label %43

43:
  %44 = phi i64 [ 0, %24 ], [ %41, %30 ]
  %45 = icmp slt i64 %44, %25
  br i1 %45, label %46, label %53

46:
  %47 = getelementptr inbounds nuw i8, ptr %22, i64 8
  %48 = load ptr, ptr %47, align 8
  %49 = getelementptr inbounds nuw i64, ptr %48, i64 %44
  %50 = load i64, ptr %49, align 8
  %51 = sitofp i64 %50 to double
  %52 = fcmp oeq double %12, %51
  br i1 %52, label %60, label %53

53:
  %54 = fmul double %12, %18
  %55 = fadd double %16, %54
  store double %55, ptr %3, align 8
  %56 = fsub double %20, %55
  %57 = getelementptr inbounds nuw i8, ptr %3, i64 8
  store double %56, ptr %57, align 8
  %58 = getelementptr inbounds nuw i8, ptr %3, i64 16
  store double 1.000000e+300, ptr %58, align 8
  %59 = getelementptr inbounds nuw i8, ptr %3, i64 24
  store double -1.000000e+300, ptr %59, align 8
  br label %326

60:
  %61 = getelementptr inbounds nuw i8, ptr %22, i64 24
  %62 = load ptr, ptr %61, align 8
  %63 = getelementptr inbounds nuw i64, ptr %62, i64 %44
  %64 = getelementptr inbounds nuw i8, ptr %63, i64 8
  %65 = load i64, ptr %64, align 8
  %66 = load i64, ptr %63, align 8
  %67 = sub nsw i64 %65, %66
  %68 = trunc i64 %67 to i32
  %69 = getelementptr inbounds nuw i8, ptr %22, i64 32
  %70 = load ptr, ptr %69, align 8
  %71 = getelementptr inbounds %struct.Part, ptr %70, i64 %66
  %72 = shl i64 %67, 32
  %73 = ashr exact i64 %72, 27
  tail call void @llvm.memcpy.p0.p0.i64(ptr align 8 %3, ptr align 8 %71, i64 %73, i1 false)
  %74 = getelementptr inbounds nuw i8, ptr %22, i64 40
  %75 = load ptr, ptr %74, align 8
  %76 = getelementptr inbounds nuw double, ptr %75, i64 %44
  %77 = load double, ptr %76, align 8
  %78 = getelementptr inbounds nuw i8, ptr %22, i64 16
  %79 = load ptr, ptr %78, align 8
  %80 = getelementptr inbounds nuw i64, ptr %79, i64 %44
  %81 = load i64, ptr %80, align 8
  %82 = trunc i64 %81 to i32
  %83 = getelementptr inbounds nuw i8, ptr %22, i64 48
  %84 = load ptr, ptr %83, align 8
  %85 = getelementptr inbounds nuw double, ptr %84, i64 %44
  %86 = load double, ptr %85, align 8
  br label %336

87:
  %88 = fmul double %12, %18
  %89 = fadd double %16, %88
  %90 = getelementptr inbounds nuw i8, ptr %1, i64 104
  %91 = load ptr, ptr %90, align 8
  %92 = getelementptr inbounds nuw i8, ptr %0, i64 72
  %93 = load i64, ptr %92, align 8
  %94 = icmp eq i64 %93, 0
  br i1 %94, label %95, label %100

95:
  store double %89, ptr %3, align 8
  %96 = fsub double %20, %89
  %97 = getelementptr inbounds nuw i8, ptr %3, i64 8
  store double %96, ptr %97, align 8
  %98 = getelementptr inbounds nuw i8, ptr %3, i64 16
  store double 1.000000e+300, ptr %98, align 8
  %99 = getelementptr inbounds nuw i8, ptr %3, i64 24
  store double -1.000000e+300, ptr %99, align 8
  br label %326

100:
  %101 = getelementptr inbounds nuw i8, ptr %1, i64 56
  %102 = load ptr, ptr %101, align 8
  %103 = getelementptr inbounds nuw i8, ptr %1, i64 120
  %104 = load ptr, ptr %103, align 8
  %105 = getelementptr inbounds nuw i8, ptr %0, i64 40
  %106 = load i64, ptr %105, align 8
  %107 = shl i64 %106, 3
  tail call void @llvm.memcpy.p0.p0.i64(ptr align 8 %102, ptr align 8 %104, i64 %107, i1 false)
  %108 = load i64, ptr %105, align 8
  %109 = getelementptr inbounds nuw i8, ptr %0, i64 32
  %110 = load i64, ptr %109, align 8
  %111 = icmp slt i64 %108, %110
  %112 = load ptr, ptr %101, align 8
  br i1 %111, label %113, label %126

113:
  %114 = load ptr, ptr %103, align 8
  %115 = getelementptr inbounds double, ptr %114, i64 %108
  br label %116

116:
  %117 = phi i64 [ %108, %113 ], [ %124, %116 ]
  %118 = getelementptr inbounds double, ptr %114, i64 %117
  %119 = load double, ptr %118, align 8
  %120 = load double, ptr %115, align 8
  %121 = fdiv double %18, %120
  %122 = fmul double %119, %121
  %123 = getelementptr inbounds double, ptr %112, i64 %117
  store double %122, ptr %123, align 8
  %124 = add nsw i64 %117, 1
  %125 = icmp eq i64 %124, %110
  br i1 %125, label %126, label %116

126:
  %127 = getelementptr inbounds double, ptr %112, i64 %108
  %128 = getelementptr inbounds nuw i8, ptr %0, i64 48
  %129 = load i64, ptr %128, align 8
  %130 = sub i64 0, %129
  %131 = getelementptr inbounds double, ptr %127, i64 %130
  %132 = load ptr, ptr %1, align 8
  %133 = getelementptr inbounds nuw i8, ptr %0, i64 120
  %134 = load i64, ptr %133, align 8
  %135 = getelementptr inbounds double, ptr %132, i64 %134
  %136 = shl i64 %129, 3
  tail call void @llvm.memcpy.p0.p0.i64(ptr align 8 %131, ptr align 8 %135, i64 %136, i1 false)
  %137 = load double, ptr %17, align 8
  %138 = fmul double %137, 2.000000e-09
  %139 = fsub double %89, %138
  %140 = fadd double %20, %138
  %141 = tail call fastcc i32 @changes(ptr noundef nonnull readonly %0, ptr noundef nonnull readonly %1, double noundef %139, double noundef %140, ptr noundef %91)
  %142 = icmp sgt i32 %141, 0
  %143 = load double, ptr %17, align 8
  br i1 %142, label %144, label %206

144:
  %145 = load ptr, ptr %1, align 8
  %146 = load i64, ptr %0, align 8
  %147 = getelementptr inbounds double, ptr %145, i64 %146
  %148 = load double, ptr %147, align 8
  %149 = fmul double %12, %143
  %150 = fadd double %149, %148
  %151 = fmul double %143, 1.000000e-09
  br label %152

152:
  %153 = phi double [ 0xFFF0000000000000, %144 ], [ %166, %165 ]
  %154 = phi i32 [ %141, %144 ], [ %167, %165 ]
  %155 = phi ptr [ %91, %144 ], [ %168, %165 ]
  %156 = load double, ptr %155, align 8
  %157 = fsub double %156, %150
  %158 = tail call double @llvm.fabs.f64(double %157)
  %159 = fcmp ogt double %158, %151
  br i1 %159, label %165, label %160

160:
  %161 = getelementptr inbounds nuw i8, ptr %155, i64 16
  %162 = load double, ptr %161, align 8
  %163 = fcmp ogt double %162, %153
  br i1 %163, label %164, label %165

164:
  br label %165

165:
  %166 = phi double [ %153, %160 ], [ %162, %164 ], [ %153, %152 ]
  %167 = add nsw i32 %154, -1
  %168 = getelementptr inbounds nuw i8, ptr %155, i64 24
  %169 = icmp sgt i32 %154, 1
  br i1 %169, label %152, label %170

170:
  %171 = fmul double %13, %143
  %172 = fadd double %171, %148
  br label %173

173:
  %174 = phi double [ 0xFFF0000000000000, %170 ], [ %192, %191 ]
  %175 = phi double [ 0x7FF0000000000000, %170 ], [ %193, %191 ]
  %176 = phi i32 [ %141, %170 ], [ %194, %191 ]
  %177 = phi ptr [ %91, %170 ], [ %195, %191 ]
  %178 = load double, ptr %177, align 8
  %179 = fsub double %178, %172
  %180 = tail call double @llvm.fabs.f64(double %179)
  %181 = fcmp ogt double %180, %151
  br i1 %181, label %191, label %182

182:
  %183 = getelementptr inbounds nuw i8, ptr %177, i64 8
  %184 = load double, ptr %183, align 8
  %185 = fcmp olt double %184, %175
  %186 = select i1 %185, double %184, double %175
  %187 = getelementptr inbounds nuw i8, ptr %177, i64 16
  %188 = load double, ptr %187, align 8
  %189 = fcmp ogt double %188, %174
  br i1 %189, label %190, label %191

190:
  br label %191

191:
  %192 = phi double [ %174, %182 ], [ %188, %190 ], [ %174, %173 ]
  %193 = phi double [ %186, %182 ], [ %186, %190 ], [ %175, %173 ]
  %194 = add nsw i32 %176, -1
  %195 = getelementptr inbounds nuw i8, ptr %177, i64 24
  %196 = icmp sgt i32 %176, 1
  br i1 %196, label %173, label %197

197:
  %198 = zext nneg i32 %141 to i64
  br label %216

199:
  %200 = icmp slt i32 %244, 0
  br i1 %200, label %201, label %204

201:
  %202 = fcmp ogt double %192, %20
  %203 = select i1 %202, double %192, double %20
  br label %319

204:
  %205 = load double, ptr %17, align 8
  br label %206

206:
  %207 = phi double [ %205, %204 ], [ %143, %126 ]
  %208 = phi i32 [ %244, %204 ], [ 0, %126 ]
  %209 = phi double [ %166, %204 ], [ 0xFFF0000000000000, %126 ]
  %210 = phi double [ %192, %204 ], [ 0xFFF0000000000000, %126 ]
  %211 = phi double [ %193, %204 ], [ 0x7FF0000000000000, %126 ]
  %212 = fmul double %207, 0x3DA5FD7FE1796495
  %213 = zext nneg i32 %208 to i64
  %214 = add nuw i32 %208, 1
  %215 = zext i32 %214 to i64
  br label %247

216:
  %217 = phi i64 [ 0, %197 ], [ %245, %243 ]
  %218 = phi i32 [ 0, %197 ], [ %244, %243 ]
  %219 = getelementptr inbounds nuw %struct.Stop, ptr %91, i64 %217
  %220 = load double, ptr %219, align 8
  %221 = load ptr, ptr %1, align 8
  %222 = load i64, ptr %0, align 8
  %223 = getelementptr inbounds double, ptr %221, i64 %222
  %224 = load double, ptr %223, align 8
  %225 = fsub double %220, %224
  %226 = load double, ptr %17, align 8
  %227 = fdiv double %225, %226
  %228 = tail call double @llvm.floor.f64(double %227)
  %229 = fcmp oeq double %228, %12
  br i1 %229, label %230, label %243

230:
  %231 = fsub double %220, %89
  %232 = tail call double @llvm.fabs.f64(double %231)
  %233 = fmul double %226, 1.000000e-09
  %234 = fcmp ogt double %232, %233
  br i1 %234, label %235, label %243

235:
  %236 = fsub double %220, %20
  %237 = tail call double @llvm.fabs.f64(double %236)
  %238 = fcmp ogt double %237, %233
  br i1 %238, label %239, label %243

239:
  %240 = add nsw i32 %218, 1
  %241 = sext i32 %218 to i64
  %242 = getelementptr inbounds %struct.Stop, ptr %91, i64 %241
  tail call void @llvm.memcpy.p0.p0.i64(ptr noundef nonnull align 8 dereferenceable(24) %242, ptr noundef nonnull align 8 dereferenceable(24) %219, i64 24, i1 false)
  br label %243

243:
  %244 = phi i32 [ %240, %239 ], [ %218, %235 ], [ %218, %230 ], [ %218, %216 ]
  %245 = add nuw nsw i64 %217, 1
  %246 = icmp eq i64 %245, %198
  br i1 %246, label %199, label %216

247:
  %248 = phi i64 [ 0, %206 ], [ %313, %301 ]
  %249 = phi i32 [ 0, %206 ], [ %311, %301 ]
  %250 = icmp eq i64 %248, 0
  br i1 %250, label %257, label %251

251:
  %252 = getelementptr %struct.Stop, ptr %91, i64 %248
  %253 = getelementptr i8, ptr %252, i64 -24
  %254 = load double, ptr %253, align 8
  %255 = getelementptr i8, ptr %252, i64 -8
  %256 = load double, ptr %255, align 8
  br label %257

257:
  %258 = phi double [ %256, %251 ], [ %209, %247 ]
  %259 = phi double [ %254, %251 ], [ %89, %247 ]
  %260 = icmp eq i64 %248, %213
  br i1 %260, label %268, label %261

261:
  %262 = getelementptr inbounds nuw %struct.Stop, ptr %91, i64 %248
  %263 = load double, ptr %262, align 8
  %264 = getelementptr inbounds nuw i8, ptr %262, i64 8
  %265 = load double, ptr %264, align 8
  %266 = getelementptr inbounds nuw i8, ptr %262, i64 16
  %267 = load double, ptr %266, align 8
  br label %268

268:
  %269 = phi double [ %267, %261 ], [ %210, %257 ]
  %270 = phi double [ %265, %261 ], [ %211, %257 ]
  %271 = phi double [ %263, %261 ], [ %20, %257 ]
  %272 = fsub double %271, %259
  %273 = fcmp ogt double %258, %259
  %274 = select i1 %273, double %258, double %259
  %275 = fadd double %274, %272
  %276 = fsub double %275, %270
  %277 = fcmp ogt double %276, %212
  br i1 %277, label %278, label %297

278:
  %279 = fcmp oeq double %258, 0xFFF0000000000000
  br i1 %279, label %280, label %288

280:
  %281 = load ptr, ptr %1, align 8
  %282 = load i64, ptr %0, align 8
  %283 = getelementptr inbounds double, ptr %281, i64 %282
  %284 = load double, ptr %283, align 8
  %285 = fcmp ugt double %259, %284
  br i1 %285, label %286, label %297

286:
  %287 = fsub double %270, %272
  br label %301

288:
  %289 = fmul double %272, 5.000000e-01
  %290 = sext i32 %249 to i64
  %291 = getelementptr inbounds %struct.Part, ptr %3, i64 %290
  store double %274, ptr %291, align 8
  %292 = getelementptr inbounds nuw i8, ptr %291, i64 8
  store double %289, ptr %292, align 8
  %293 = getelementptr inbounds nuw i8, ptr %291, i64 16
  store double 1.000000e+300, ptr %293, align 8
  %294 = add nsw i32 %249, 1
  %295 = getelementptr inbounds nuw i8, ptr %291, i64 24
  store double -1.000000e+300, ptr %295, align 8
  %296 = fsub double %270, %289
  br label %301

297:
  %298 = fsub double %270, %274
  %299 = fcmp olt double %298, %272
  br i1 %299, label %300, label %301

300:
  br label %301

301:
  %302 = phi i32 [ %249, %300 ], [ %249, %297 ], [ %249, %286 ], [ %294, %288 ]
  %303 = phi double [ %298, %300 ], [ %272, %297 ], [ %272, %286 ], [ %289, %288 ]
  %304 = phi double [ %274, %300 ], [ %274, %297 ], [ %287, %286 ], [ %296, %288 ]
  %305 = sext i32 %302 to i64
  %306 = getelementptr inbounds %struct.Part, ptr %3, i64 %305
  store double %304, ptr %306, align 8
  %307 = getelementptr inbounds nuw i8, ptr %306, i64 8
  store double %303, ptr %307, align 8
  %308 = fcmp one double %270, 0x7FF0000000000000
  %309 = select i1 %308, double %270, double 1.000000e+300
  %310 = getelementptr inbounds nuw i8, ptr %306, i64 16
  store double %309, ptr %310, align 8
  %311 = add nsw i32 %302, 1
  %312 = getelementptr inbounds nuw i8, ptr %306, i64 24
  store double %269, ptr %312, align 8
  %313 = add nuw nsw i64 %248, 1
  %314 = icmp eq i64 %313, %215
  br i1 %314, label %315, label %247

315:
  %316 = fcmp ogt double %210, %20
  %317 = select i1 %316, double %210, double %20
  %318 = icmp sgt i32 %302, 0
  br i1 %318, label %326, label %319

319:
  %320 = phi double [ %203, %201 ], [ %317, %315 ]
  %321 = phi i32 [ 0, %201 ], [ %311, %315 ]
  %322 = getelementptr inbounds nuw i8, ptr %3, i64 16
  %323 = load double, ptr %322, align 8
  %324 = fcmp olt double %323, 1.000000e+300
  %325 = zext i1 %324 to i32
  br label %326

326:
  %327 = phi double [ %20, %53 ], [ %20, %95 ], [ %317, %315 ], [ %320, %319 ]
  %328 = phi i32 [ 0, %53 ], [ 0, %95 ], [ 1, %315 ], [ %325, %319 ]
  %329 = phi i32 [ 1, %53 ], [ 1, %95 ], [ %311, %315 ], [ %321, %319 ]
  %330 = load ptr, ptr %1, align 8
  %331 = load i64, ptr %0, align 8
  %332 = getelementptr inbounds double, ptr %330, i64 %331
  %333 = load double, ptr %332, align 8
  %334 = fsub double %327, %20
  %335 = fadd double %334, %333
  br label %336

336:
  %337 = phi double [ %327, %326 ], [ %77, %60 ]
  %338 = phi i32 [ %328, %326 ], [ %82, %60 ]
  %339 = phi double [ %335, %326 ], [ %86, %60 ]
  %340 = phi i32 [ %329, %326 ], [ %68, %60 ]
  %341 = or i32 %338, %2
  %342 = icmp eq i32 %341, 0
  br i1 %342, label %1843, label %343

343:
  %344 = getelementptr inbounds nuw i8, ptr %1, i64 16
  %345 = load ptr, ptr %344, align 8
  %346 = load ptr, ptr %1, align 8
  %347 = getelementptr inbounds nuw i8, ptr %346, i64 8
  %348 = load double, ptr %347, align 8
  %349 = getelementptr inbounds nuw i8, ptr %0, i64 16
  %350 = load i64, ptr %349, align 8
  %351 = shl i64 %350, 3
  tail call void @llvm.memset.p0.i64(ptr align 8 %345, i8 0, i64 %351, i1 false)
  %352 = load ptr, ptr %1, align 8
  %353 = load i64, ptr %0, align 8
  %354 = shl i64 %353, 3
  tail call void @llvm.memcpy.p0.p0.i64(ptr align 8 %345, ptr align 8 %352, i64 %354, i1 false)
  %355 = getelementptr inbounds nuw i8, ptr %0, i64 248
  %356 = load i64, ptr %355, align 8
  %357 = getelementptr inbounds double, ptr %345, i64 %356
  %358 = load ptr, ptr %1, align 8
  %359 = getelementptr inbounds nuw i8, ptr %0, i64 120
  %360 = load i64, ptr %359, align 8
  %361 = getelementptr inbounds double, ptr %358, i64 %360
  %362 = getelementptr inbounds nuw i8, ptr %0, i64 48
  %363 = load i64, ptr %362, align 8
  %364 = shl i64 %363, 3
  tail call void @llvm.memcpy.p0.p0.i64(ptr align 8 %357, ptr align 8 %361, i64 %364, i1 false)
  %365 = getelementptr inbounds nuw i8, ptr %0, i64 192
  %366 = load i64, ptr %365, align 8
  %367 = getelementptr inbounds double, ptr %345, i64 %366
  store double %348, ptr %367, align 8
  %368 = load double, ptr %17, align 8
  %369 = getelementptr inbounds nuw i8, ptr %0, i64 200
  %370 = load i64, ptr %369, align 8
  %371 = getelementptr inbounds double, ptr %345, i64 %370
  store double %368, ptr %371, align 8
  %372 = getelementptr inbounds nuw i8, ptr %0, i64 56
  %373 = load i64, ptr %372, align 8
  %374 = icmp sgt i64 %373, 0
  br i1 %374, label %375, label %388

375:
  %376 = icmp eq i32 %2, 0
  %377 = getelementptr inbounds nuw i8, ptr %0, i64 136
  %378 = load i64, ptr %377, align 8
  br i1 %376, label %379, label %382

379:
  %380 = getelementptr inbounds double, ptr %345, i64 %378
  %381 = load double, ptr %380, align 8
  br label %382

382:
  %383 = phi double [ %381, %379 ], [ 1.000000e+300, %375 ]
  %384 = getelementptr inbounds nuw i8, ptr %0, i64 232
  %385 = load i64, ptr %384, align 8
  %386 = getelementptr inbounds double, ptr %345, i64 %385
  store double %383, ptr %386, align 8
  %387 = getelementptr inbounds double, ptr %345, i64 %378
  store double 1.000000e+300, ptr %387, align 8
  br label %388

388:
  %389 = icmp sgt i32 %340, 0
  br i1 %389, label %390, label %1825

390:
  %391 = icmp eq i32 %2, 0
  %392 = getelementptr inbounds nuw i8, ptr %0, i64 184
  %393 = getelementptr inbounds nuw i8, ptr %1, i64 144
  %394 = getelementptr inbounds nuw i8, ptr %1, i64 152
  %395 = getelementptr inbounds nuw i8, ptr %1, i64 24
  %396 = getelementptr inbounds nuw i8, ptr %0, i64 104
  %397 = getelementptr inbounds nuw i8, ptr %0, i64 208
  %398 = getelementptr inbounds nuw i8, ptr %0, i64 216
  %399 = getelementptr inbounds nuw i8, ptr %0, i64 224
  %400 = getelementptr inbounds nuw i8, ptr %0, i64 408
  %401 = getelementptr inbounds nuw i8, ptr %1, i64 48
  %402 = getelementptr inbounds nuw i8, ptr %1, i64 8
  %403 = getelementptr inbounds nuw i8, ptr %0, i64 400
  %404 = getelementptr inbounds nuw i8, ptr %0, i64 240
  %405 = getelementptr inbounds nuw i8, ptr %0, i64 432
  %406 = getelementptr inbounds nuw i8, ptr %1, i64 80
  %407 = getelementptr inbounds nuw i8, ptr %1, i64 32
  %408 = getelementptr inbounds nuw i8, ptr %1, i64 88
  %409 = getelementptr inbounds nuw i8, ptr %1, i64 56
  %410 = getelementptr inbounds nuw i8, ptr %1, i64 120
  %411 = getelementptr inbounds nuw i8, ptr %0, i64 40
  %412 = getelementptr inbounds nuw i8, ptr %0, i64 32
  %413 = getelementptr inbounds nuw i8, ptr %0, i64 360
  %414 = getelementptr inbounds nuw i8, ptr %0, i64 64
  %415 = getelementptr inbounds nuw i8, ptr %0, i64 440
  %416 = getelementptr inbounds nuw i8, ptr %1, i64 64
  %417 = getelementptr inbounds nuw i8, ptr %1, i64 184
  %418 = getelementptr inbounds nuw i8, ptr %0, i64 320
  %419 = getelementptr inbounds nuw i8, ptr %0, i64 464
  %420 = getelementptr inbounds nuw i8, ptr %0, i64 304
  %421 = getelementptr inbounds nuw i8, ptr %0, i64 312
  %422 = fadd double %348, 1.000000e+00
  %423 = zext nneg i32 %340 to i64
  br label %424

424:
  %425 = phi i64 [ 0, %390 ], [ %1823, %1822 ]
  %426 = getelementptr inbounds nuw %struct.Part, ptr %3, i64 %425
  %427 = load double, ptr %426, align 8
  %428 = getelementptr inbounds nuw i8, ptr %426, i64 8
  %429 = load double, ptr %428, align 8
  br i1 %391, label %1799, label %430

430:
  %431 = fadd double %427, %429
  %432 = load double, ptr %17, align 8
  %433 = fmul double %432, 1.000000e-09
  %434 = fsub double %431, %433
  %435 = load i64, ptr %372, align 8
  %436 = getelementptr i32, ptr %4, i64 %435
  %437 = getelementptr i8, ptr %436, i64 4
  %438 = xor i64 %435, -1
  %439 = getelementptr inbounds i32, ptr %437, i64 %438
  %440 = icmp eq ptr %437, null
  br label %441

441:
  %442 = phi i64 [ %435, %430 ], [ %1681, %1678 ]
  %443 = phi double [ %429, %430 ], [ %1679, %1678 ]
  %444 = phi double [ %427, %430 ], [ %1680, %1678 ]
  %445 = load ptr, ptr %344, align 8
  %446 = load i64, ptr %392, align 8
  %447 = icmp sgt i64 %446, -1
  %448 = getelementptr inbounds nuw double, ptr %445, i64 %446
  %449 = icmp ne ptr %445, null
  %450 = icmp sgt i64 %442, 0
  %451 = select i1 %450, i1 %447, i1 false
  %452 = select i1 %451, i1 %449, i1 false
  br i1 %452, label %453, label %466

453:
  %454 = phi i64 [ %464, %453 ], [ 0, %441 ]
  %455 = phi double [ %463, %453 ], [ 1.000000e+300, %441 ]
  %456 = getelementptr inbounds nuw double, ptr %448, i64 %454
  %457 = load double, ptr %456, align 8
  %458 = fcmp ogt double %457, %444
  %459 = fcmp olt double %457, %434
  %460 = select i1 %458, i1 %459, i1 false
  %461 = fcmp olt double %457, %455
  %462 = select i1 %460, i1 %461, i1 false
  %463 = select i1 %462, double %457, double %455
  %464 = add nuw nsw i64 %454, 1
  %465 = icmp eq i64 %464, %442
  br i1 %465, label %466, label %453

466:
  %467 = phi double [ 1.000000e+300, %441 ], [ %463, %453 ]
  store double %444, ptr %393, align 8
  %468 = fcmp olt double %467, 1.000000e+300
  %469 = fsub double %467, %444
  %470 = select i1 %468, double %469, double %443
  store double %470, ptr %394, align 8
  %471 = load ptr, ptr %395, align 8
  %472 = load i64, ptr %349, align 8
  %473 = shl i64 %472, 3
  tail call void @llvm.memcpy.p0.p0.i64(ptr align 8 %471, ptr align 8 %445, i64 %473, i1 false)
  %474 = load ptr, ptr %395, align 8
  %475 = load double, ptr %394, align 8
  %476 = load i64, ptr %396, align 8
  %477 = sitofp i64 %476 to double
  %478 = fmul double %477, 0x3CC0000000000000
  %479 = fsub double 1.000000e+00, %478
  %480 = fmul double %475, %479
  %481 = load i64, ptr %397, align 8
  %482 = getelementptr inbounds double, ptr %474, i64 %481
  store double %444, ptr %482, align 8
  %483 = load i64, ptr %398, align 8
  %484 = getelementptr inbounds double, ptr %474, i64 %483
  store double %480, ptr %484, align 8
  %485 = load double, ptr %17, align 8
  %486 = fdiv double %480, %485
  %487 = load i64, ptr %399, align 8
  %488 = getelementptr inbounds double, ptr %474, i64 %487
  store double %486, ptr %488, align 8
  %489 = load ptr, ptr %400, align 8
  %490 = load ptr, ptr %401, align 8
  %491 = load ptr, ptr %402, align 8
  tail call void %489(ptr noundef %474, ptr noundef %490, ptr noundef %491)
  %492 = load ptr, ptr %403, align 8
  %493 = load i64, ptr %404, align 8
  %494 = getelementptr inbounds double, ptr %474, i64 %493
  %495 = load ptr, ptr %402, align 8
  tail call void %492(ptr noundef %474, ptr noundef %494, ptr noundef %495, i64 noundef 1)
  %496 = load i64, ptr %369, align 8
  %497 = getelementptr inbounds double, ptr %474, i64 %496
  store double %480, ptr %497, align 8
  %498 = load ptr, ptr %405, align 8
  %499 = load ptr, ptr %406, align 8
  %500 = load ptr, ptr %407, align 8
  %501 = load ptr, ptr %344, align 8
  %502 = load double, ptr %394, align 8
  %503 = tail call fastcc ptr @set_out(ptr noundef nonnull %0, ptr noundef nonnull %1, ptr noundef %501, double noundef %502, double noundef %444)
  %504 = load ptr, ptr %402, align 8
  tail call void %498(ptr noundef %499, ptr noundef %500, ptr noundef %503, ptr noundef %504)
  %505 = load ptr, ptr %408, align 8
  %506 = load ptr, ptr %395, align 8
  %507 = load ptr, ptr %405, align 8
  %508 = load i64, ptr %369, align 8
  %509 = getelementptr inbounds double, ptr %506, i64 %508
  %510 = load double, ptr %509, align 8
  %511 = load ptr, ptr %409, align 8
  %512 = load ptr, ptr %410, align 8
  %513 = load i64, ptr %411, align 8
  %514 = shl i64 %513, 3
  tail call void @llvm.memcpy.p0.p0.i64(ptr align 8 %511, ptr align 8 %512, i64 %514, i1 false)
  %515 = load i64, ptr %411, align 8
  %516 = load i64, ptr %412, align 8
  %517 = icmp slt i64 %515, %516
  %518 = load ptr, ptr %409, align 8
  br i1 %517, label %519, label %532

519:
  %520 = load ptr, ptr %410, align 8
  %521 = getelementptr inbounds double, ptr %520, i64 %515
  br label %522

522:
  %523 = phi i64 [ %515, %519 ], [ %530, %522 ]
  %524 = getelementptr inbounds double, ptr %520, i64 %523
  %525 = load double, ptr %524, align 8
  %526 = load double, ptr %521, align 8
  %527 = fdiv double %510, %526
  %528 = fmul double %525, %527
  %529 = getelementptr inbounds double, ptr %518, i64 %523
  store double %528, ptr %529, align 8
  %530 = add nsw i64 %523, 1
  %531 = icmp eq i64 %530, %516
  br i1 %531, label %532, label %522

532:
  %533 = load ptr, ptr %402, align 8
  tail call void %507(ptr noundef %505, ptr noundef nonnull %506, ptr noundef %518, ptr noundef %533)
  %534 = load i64, ptr %372, align 8
  %535 = add nsw i64 %534, 1
  %536 = getelementptr inbounds double, ptr %9, i64 %535
  %537 = getelementptr inbounds double, ptr %536, i64 %535
  %538 = getelementptr inbounds double, ptr %537, i64 %535
  %539 = load ptr, ptr %344, align 8
  %540 = load i64, ptr %392, align 8
  %541 = icmp slt i64 %540, 0
  %542 = getelementptr inbounds nuw double, ptr %539, i64 %540
  %543 = select i1 %541, ptr null, ptr %542
  %544 = load ptr, ptr %406, align 8
  %545 = load ptr, ptr %408, align 8
  %546 = load double, ptr %393, align 8
  %547 = icmp sgt i64 %534, 0
  br i1 %547, label %548, label %583

548:
  %549 = icmp eq ptr %543, null
  br label %550

550:
  %551 = phi i64 [ 0, %548 ], [ %579, %576 ]
  %552 = phi i1 [ false, %548 ], [ %578, %576 ]
  br i1 %549, label %557, label %553

553:
  %554 = getelementptr inbounds nuw double, ptr %542, i64 %551
  %555 = load double, ptr %554, align 8
  %556 = fcmp ogt double %555, %546
  br i1 %556, label %576, label %557

557:
  %558 = getelementptr inbounds nuw double, ptr %544, i64 %551
  %559 = load double, ptr %558, align 8
  %560 = getelementptr inbounds nuw double, ptr %545, i64 %551
  %561 = load double, ptr %560, align 8
  %562 = load ptr, ptr %413, align 8
  %563 = getelementptr inbounds nuw %struct.Event, ptr %562, i64 %551
  %564 = load i32, ptr %563, align 8
  %565 = icmp sgt i32 %564, -1
  %566 = fcmp olt double %559, 0.000000e+00
  %567 = and i1 %566, %565
  %568 = fcmp oge double %561, 0.000000e+00
  %569 = and i1 %568, %567
  br i1 %569, label %576, label %570

570:
  %571 = icmp slt i32 %564, 1
  %572 = fcmp ogt double %559, 0.000000e+00
  %573 = and i1 %572, %571
  %574 = fcmp ole double %561, 0.000000e+00
  %575 = and i1 %574, %573
  br label %576

576:
  %577 = phi i1 [ false, %553 ], [ %575, %570 ], [ true, %557 ]
  %578 = or i1 %552, %577
  %579 = add nuw nsw i64 %551, 1
  %580 = icmp eq i64 %579, %534
  br i1 %580, label %581, label %550

581:
  %582 = zext i1 %578 to i32
  br label %583

583:
  %584 = phi i32 [ 0, %532 ], [ %582, %581 ]
  %585 = load double, ptr %394, align 8
  %586 = load i64, ptr %414, align 8
  %587 = icmp eq i64 %586, 0
  br i1 %587, label %1115, label %588

588:
  %589 = load ptr, ptr %415, align 8
  %590 = load ptr, ptr %407, align 8
  %591 = tail call fastcc ptr @set_out(ptr noundef nonnull readonly %0, ptr noundef nonnull readonly %1, ptr noundef %539, double noundef %585, double noundef %546)
  %592 = load ptr, ptr %402, align 8
  tail call void %589(ptr noundef nonnull %9, ptr noundef %590, ptr noundef %591, ptr noundef %592)
  %593 = load ptr, ptr %415, align 8
  %594 = load ptr, ptr %395, align 8
  %595 = load i64, ptr %369, align 8
  %596 = getelementptr inbounds double, ptr %594, i64 %595
  %597 = load double, ptr %596, align 8
  %598 = load ptr, ptr %409, align 8
  %599 = load ptr, ptr %410, align 8
  %600 = load i64, ptr %411, align 8
  %601 = shl i64 %600, 3
  tail call void @llvm.memcpy.p0.p0.i64(ptr align 8 %598, ptr align 8 %599, i64 %601, i1 false)
  %602 = load i64, ptr %411, align 8
  %603 = load i64, ptr %412, align 8
  %604 = icmp slt i64 %602, %603
  %605 = load ptr, ptr %409, align 8
  br i1 %604, label %606, label %619

606:
  %607 = load ptr, ptr %410, align 8
  %608 = getelementptr inbounds double, ptr %607, i64 %602
  br label %609

609:
  %610 = phi i64 [ %602, %606 ], [ %617, %609 ]
  %611 = getelementptr inbounds double, ptr %607, i64 %610
  %612 = load double, ptr %611, align 8
  %613 = load double, ptr %608, align 8
  %614 = fdiv double %597, %613
  %615 = fmul double %612, %614
  %616 = getelementptr inbounds double, ptr %605, i64 %610
  store double %615, ptr %616, align 8
  %617 = add nsw i64 %610, 1
  %618 = icmp eq i64 %617, %603
  br i1 %618, label %619, label %609

619:
  %620 = load ptr, ptr %402, align 8
  tail call void %593(ptr noundef nonnull %536, ptr noundef nonnull %594, ptr noundef %605, ptr noundef %620)
  %621 = load i64, ptr %414, align 8
  %622 = icmp sgt i64 %621, 0
  br i1 %622, label %623, label %1115

623:
  %624 = load ptr, ptr %406, align 8
  %625 = load ptr, ptr %408, align 8
  %626 = load double, ptr %394, align 8
  %627 = fdiv double %626, 3.000000e+00
  %628 = icmp eq ptr %543, null
  br label %629

629:
  %630 = phi i64 [ 0, %623 ], [ %683, %682 ]
  %631 = getelementptr inbounds nuw double, ptr %624, i64 %630
  %632 = load double, ptr %631, align 8
  %633 = getelementptr inbounds nuw double, ptr %625, i64 %630
  %634 = load double, ptr %633, align 8
  %635 = getelementptr inbounds nuw double, ptr %9, i64 %630
  %636 = load double, ptr %635, align 8
  %637 = fmul double %627, %636
  %638 = fadd double %632, %637
  %639 = getelementptr inbounds nuw double, ptr %536, i64 %630
  %640 = load double, ptr %639, align 8
  %641 = fmul double %627, %640
  %642 = fsub double %634, %641
  %643 = fcmp ogt double %632, 0.000000e+00
  %644 = zext i1 %643 to i32
  %645 = fcmp olt double %632, 0.000000e+00
  %646 = sext i1 %645 to i32
  %647 = add nsw i32 %646, %644
  %648 = sitofp i32 %647 to double
  %649 = fsub double %634, %632
  %650 = fcmp ogt double %649, 0.000000e+00
  %651 = zext i1 %650 to i32
  %652 = fcmp olt double %649, 0.000000e+00
  %653 = sext i1 %652 to i32
  %654 = add nsw i32 %653, %651
  %655 = sitofp i32 %654 to double
  br i1 %628, label %661, label %656

656:
  %657 = getelementptr inbounds nuw double, ptr %542, i64 %630
  %658 = load double, ptr %657, align 8
  %659 = load double, ptr %393, align 8
  %660 = fcmp ogt double %658, %659
  br i1 %660, label %682, label %661

661:
  %662 = fmul double %634, %648
  %663 = fcmp ogt double %662, 0.000000e+00
  br i1 %663, label %664, label %670

664:
  %665 = fmul double %638, %648
  %666 = fcmp ugt double %665, 0.000000e+00
  %667 = fmul double %642, %648
  %668 = fcmp ugt double %667, 0.000000e+00
  %669 = select i1 %666, i1 %668, i1 false
  br i1 %669, label %682, label %685

670:
  %671 = fsub double %638, %632
  %672 = fmul double %671, %655
  %673 = fcmp olt double %672, 0.000000e+00
  br i1 %673, label %685, label %674

674:
  %675 = fsub double %642, %638
  %676 = fmul double %675, %655
  %677 = fcmp olt double %676, 0.000000e+00
  br i1 %677, label %685, label %678

678:
  %679 = fsub double %634, %642
  %680 = fmul double %679, %655
  %681 = fcmp olt double %680, 0.000000e+00
  br i1 %681, label %685, label %682

682:
  %683 = add nuw nsw i64 %630, 1
  %684 = icmp eq i64 %683, %621
  br i1 %684, label %1115, label %629

685:
  %686 = load ptr, ptr %416, align 8
  %687 = load i64, ptr %372, align 8
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 16 dereferenceable(2000) %6, i8 0, i64 2000, i1 false)
  br label %694

688:
  %689 = shl i64 %687, 4
  %690 = getelementptr double, ptr %538, i64 %689
  %691 = getelementptr i8, ptr %690, i64 128
  %692 = sub nuw nsw i64 -16, %689
  %693 = getelementptr inbounds double, ptr %691, i64 %692
  br label %718

694:
  %695 = phi i64 [ 0, %685 ], [ %712, %705 ]
  %696 = icmp eq i64 %695, 4
  br i1 %696, label %703, label %697

697:
  %698 = trunc nuw nsw i64 %695 to i32
  %699 = uitofp nneg i32 %698 to double
  %700 = load double, ptr %394, align 8
  %701 = fmul double %700, 2.500000e-01
  %702 = fmul double %701, %699
  br label %705

703:
  %704 = load double, ptr %394, align 8
  br label %705

705:
  %706 = phi double [ %702, %697 ], [ %704, %703 ]
  %707 = load i64, ptr %372, align 8
  %708 = add nsw i64 %707, 1
  %709 = mul nsw i64 %708, %695
  %710 = getelementptr double, ptr %686, i64 %709
  %711 = getelementptr double, ptr %710, i64 %707
  store double %706, ptr %711, align 8
  tail call fastcc void @look(ptr noundef nonnull readonly %0, ptr noundef nonnull readonly %1, double noundef %706, ptr noundef %710)
  %712 = add nuw nsw i64 %695, 1
  %713 = icmp eq i64 %712, 5
  br i1 %713, label %688, label %694

714:
  %715 = phi i32 [ %720, %900 ], [ %897, %1048 ]
  %716 = add nsw i32 %715, -1
  %717 = icmp sgt i32 %715, 1
  br i1 %717, label %718, label %1064

718:
  %719 = phi i32 [ 4, %688 ], [ %716, %714 ]
  %720 = phi i32 [ 5, %688 ], [ %715, %714 ]
  %721 = load i64, ptr %372, align 8
  %722 = add nsw i64 %721, 1
  %723 = load ptr, ptr %344, align 8
  %724 = load i64, ptr %392, align 8
  %725 = getelementptr inbounds nuw double, ptr %723, i64 %724
  %726 = load double, ptr %393, align 8
  %727 = icmp sgt i64 %721, 0
  %728 = icmp slt i64 %724, 0
  %729 = icmp eq ptr %723, null
  %730 = select i1 %728, i1 true, i1 %729
  %731 = zext nneg i32 %719 to i64
  br label %732

732:
  %733 = phi i64 [ 0, %718 ], [ %736, %775 ]
  %734 = mul nsw i64 %733, %722
  %735 = getelementptr inbounds double, ptr %686, i64 %734
  %736 = add nuw nsw i64 %733, 1
  %737 = mul nsw i64 %736, %722
  %738 = getelementptr inbounds double, ptr %686, i64 %737
  br i1 %727, label %739, label %775

739:
  %740 = load i64, ptr %414, align 8
  br label %741

741:
  %742 = phi i64 [ 0, %739 ], [ %772, %769 ]
  %743 = phi i1 [ false, %739 ], [ %771, %769 ]
  %744 = icmp sgt i64 %740, %742
  br i1 %744, label %745, label %769

745:
  br i1 %730, label %750, label %746

746:
  %747 = getelementptr inbounds nuw double, ptr %725, i64 %742
  %748 = load double, ptr %747, align 8
  %749 = fcmp ogt double %748, %726
  br i1 %749, label %769, label %750

750:
  %751 = getelementptr inbounds nuw double, ptr %735, i64 %742
  %752 = load double, ptr %751, align 8
  %753 = getelementptr inbounds nuw double, ptr %738, i64 %742
  %754 = load double, ptr %753, align 8
  %755 = load ptr, ptr %413, align 8
  %756 = getelementptr inbounds nuw %struct.Event, ptr %755, i64 %742
  %757 = load i32, ptr %756, align 8
  %758 = icmp sgt i32 %757, -1
  %759 = fcmp olt double %752, 0.000000e+00
  %760 = and i1 %759, %758
  %761 = fcmp oge double %754, 0.000000e+00
  %762 = and i1 %761, %760
  br i1 %762, label %769, label %763

763:
  %764 = icmp slt i32 %757, 1
  %765 = fcmp ogt double %752, 0.000000e+00
  %766 = and i1 %765, %764
  %767 = fcmp ole double %754, 0.000000e+00
  %768 = and i1 %767, %766
  br label %769

769:
  %770 = phi i1 [ false, %746 ], [ false, %741 ], [ true, %750 ], [ %768, %763 ]
  %771 = or i1 %743, %770
  %772 = add nuw nsw i64 %742, 1
  %773 = icmp eq i64 %772, %721
  br i1 %773, label %774, label %741

774:
  br i1 %771, label %777, label %775

775:
  %776 = icmp eq i64 %736, %731
  br i1 %776, label %780, label %732

777:
  %778 = trunc nuw nsw i64 %733 to i32
  %779 = and i64 %733, 4294967295
  br label %780

780:
  %781 = phi i64 [ %779, %777 ], [ %731, %775 ]
  %782 = phi i32 [ %778, %777 ], [ %719, %775 ]
  %783 = phi i1 [ true, %777 ], [ false, %775 ]
  %784 = add nsw i32 %720, -3
  %785 = icmp slt i64 %721, 1
  br label %786

786:
  %787 = phi i64 [ 0, %780 ], [ %797, %891 ]
  %788 = phi i32 [ 0, %780 ], [ %892, %891 ]
  %789 = trunc nuw nsw i64 %787 to i32
  %790 = tail call i32 @llvm.smax.i32(i32 %789, i32 1)
  %791 = zext nneg i32 %790 to i64
  %792 = add nsw i64 %791, -1
  %793 = icmp samesign ule i64 %787, %781
  %794 = icmp slt i32 %788, 16
  %795 = select i1 %793, i1 %794, i1 false
  br i1 %795, label %796, label %894

796:
  %797 = add nuw nsw i64 %787, 1
  %798 = mul nsw i64 %797, %722
  %799 = getelementptr double, ptr %686, i64 %798
  %800 = getelementptr double, ptr %799, i64 %721
  %801 = load double, ptr %800, align 8
  %802 = mul nsw i64 %787, %722
  %803 = getelementptr double, ptr %686, i64 %802
  %804 = getelementptr double, ptr %803, i64 %721
  %805 = load double, ptr %804, align 8
  %806 = fsub double %801, %805
  %807 = getelementptr inbounds nuw i32, ptr %6, i64 %787
  %808 = load i32, ptr %807, align 4
  %809 = icmp slt i32 %808, 1
  %810 = select i1 %785, i1 true, i1 %809
  br i1 %810, label %881, label %811

811:
  %812 = add nsw i32 %790, -1
  %813 = tail call i32 @llvm.smin.i32(i32 %789, i32 %784)
  %814 = icmp sgt i32 %812, %813
  %815 = fmul double %806, %806
  %816 = sext i32 %813 to i64
  br label %817

817:
  %818 = phi i64 [ 0, %811 ], [ %878, %876 ]
  %819 = getelementptr double, ptr %803, i64 %818
  %820 = load double, ptr %819, align 8
  %821 = getelementptr double, ptr %799, i64 %818
  %822 = load double, ptr %821, align 8
  %823 = tail call double @llvm.fabs.f64(double %820)
  %824 = tail call double @llvm.fabs.f64(double %822)
  %825 = fcmp olt double %823, %824
  %826 = select i1 %825, double %823, double %824
  br i1 %814, label %862, label %827

827:
  %828 = phi i64 [ %858, %827 ], [ %792, %817 ]
  %829 = phi double [ %857, %827 ], [ 0.000000e+00, %817 ]
  %830 = mul nsw i64 %828, %722
  %831 = getelementptr inbounds double, ptr %686, i64 %830
  %832 = getelementptr inbounds nuw double, ptr %831, i64 %722
  %833 = getelementptr inbounds nuw double, ptr %832, i64 %722
  %834 = getelementptr inbounds nuw double, ptr %833, i64 %818
  %835 = load double, ptr %834, align 8
  %836 = getelementptr inbounds nuw double, ptr %832, i64 %818
  %837 = load double, ptr %836, align 8
  %838 = fsub double %835, %837
  %839 = getelementptr inbounds nuw double, ptr %833, i64 %721
  %840 = load double, ptr %839, align 8
  %841 = getelementptr inbounds nuw double, ptr %832, i64 %721
  %842 = load double, ptr %841, align 8
  %843 = fsub double %840, %842
  %844 = fdiv double %838, %843
  %845 = getelementptr inbounds nuw double, ptr %831, i64 %818
  %846 = load double, ptr %845, align 8
  %847 = fsub double %837, %846
  %848 = getelementptr inbounds nuw double, ptr %831, i64 %721
  %849 = load double, ptr %848, align 8
  %850 = fsub double %842, %849
  %851 = fdiv double %847, %850
  %852 = fsub double %844, %851
  %853 = fsub double %840, %849
  %854 = fdiv double %852, %853
  %855 = tail call double @llvm.fabs.f64(double %854)
  %856 = fcmp ogt double %855, %829
  %857 = select i1 %856, double %855, double %829
  %858 = add nuw nsw i64 %828, 1
  %859 = icmp slt i64 %828, %816
  br i1 %859, label %827, label %860

860:
  %861 = fmul double %857, 3.000000e+00
  br label %862

862:
  %863 = phi double [ 0.000000e+00, %817 ], [ %861, %860 ]
  %864 = fmul double %820, %822
  %865 = fcmp ogt double %864, 0.000000e+00
  br i1 %865, label %866, label %870

866:
  %867 = fmul double %815, %863
  %868 = fmul double %867, 2.500000e-01
  %869 = fcmp ogt double %868, %826
  br label %876

870:
  %871 = fmul double %806, %863
  %872 = fsub double %822, %820
  %873 = fdiv double %872, %806
  %874 = tail call double @llvm.fabs.f64(double %873)
  %875 = fcmp ogt double %871, %874
  br label %876

876:
  %877 = phi i1 [ %869, %866 ], [ %875, %870 ]
  %878 = add nuw nsw i64 %818, 1
  %879 = icmp sle i64 %721, %878
  %880 = select i1 %879, i1 true, i1 %877
  br i1 %880, label %881, label %817

881:
  %882 = phi i1 [ %809, %796 ], [ %877, %876 ]
  br i1 %882, label %883, label %891

883:
  %884 = load double, ptr %394, align 8
  %885 = fmul double %884, 0x3EB0C6F7A0B5ED8D
  %886 = fcmp ogt double %806, %885
  br i1 %886, label %887, label %891

887:
  %888 = add nsw i32 %788, 1
  %889 = sext i32 %788 to i64
  %890 = getelementptr inbounds i32, ptr %7, i64 %889
  store i32 %789, ptr %890, align 4
  br label %891

891:
  %892 = phi i32 [ %888, %887 ], [ %788, %883 ], [ %788, %881 ]
  %893 = icmp eq i64 %797, %731
  br i1 %893, label %894, label %786

894:
  %895 = phi i32 [ %892, %891 ], [ %788, %786 ]
  %896 = icmp eq i32 %895, 0
  %897 = add i32 %895, %720
  %898 = icmp sgt i32 %897, 499
  %899 = or i1 %896, %898
  br i1 %899, label %905, label %900

900:
  %901 = icmp sgt i32 %895, 0
  br i1 %901, label %902, label %714

902:
  %903 = add nsw i32 %720, -4
  %904 = zext nneg i32 %895 to i64
  br label %906

905:
  br i1 %783, label %1053, label %1064

906:
  %907 = phi i64 [ %721, %902 ], [ %929, %1004 ]
  %908 = phi i64 [ 0, %902 ], [ %1005, %1004 ]
  %909 = add nsw i64 %907, 1
  %910 = mul nsw i64 %909, %908
  %911 = getelementptr inbounds double, ptr %693, i64 %910
  %912 = getelementptr inbounds nuw i32, ptr %7, i64 %908
  %913 = load i32, ptr %912, align 4
  %914 = sext i32 %913 to i64
  %915 = mul nsw i64 %909, %914
  %916 = getelementptr double, ptr %686, i64 %915
  %917 = getelementptr double, ptr %916, i64 %907
  %918 = load double, ptr %917, align 8
  %919 = add nsw i32 %913, 1
  %920 = sext i32 %919 to i64
  %921 = mul nsw i64 %909, %920
  %922 = getelementptr double, ptr %686, i64 %921
  %923 = getelementptr double, ptr %922, i64 %907
  %924 = load double, ptr %923, align 8
  %925 = fadd double %918, %924
  %926 = fmul double %925, 5.000000e-01
  %927 = getelementptr inbounds double, ptr %911, i64 %907
  store double %926, ptr %927, align 8
  tail call fastcc void @look(ptr noundef nonnull readonly %0, ptr noundef nonnull readonly %1, double noundef %926, ptr noundef %911)
  %928 = getelementptr inbounds nuw i32, ptr %8, i64 %908
  store i32 1, ptr %928, align 4
  %929 = load i64, ptr %372, align 8
  %930 = icmp sgt i64 %929, 0
  br i1 %930, label %931, label %1004

931:
  %932 = icmp sgt i32 %913, 0
  %933 = add nsw i32 %913, -1
  %934 = tail call i32 @llvm.smin.i32(i32 %933, i32 %903)
  %935 = select i1 %932, i32 %934, i32 0
  %936 = add nsw i32 %935, 4
  %937 = add nuw nsw i64 %929, 1
  %938 = getelementptr double, ptr %686, i64 %929
  %939 = getelementptr inbounds nuw double, ptr %911, i64 %929
  %940 = sext i32 %935 to i64
  %941 = sext i32 %936 to i64
  br label %942

942:
  %943 = phi i64 [ 0, %931 ], [ %1001, %999 ]
  %944 = phi i32 [ 1, %931 ], [ %1000, %999 ]
  br label %945

945:
  %946 = phi i64 [ %940, %942 ], [ %984, %974 ]
  %947 = phi double [ 0.000000e+00, %942 ], [ %983, %974 ]
  %948 = phi double [ 0xFFF0000000000000, %942 ], [ %980, %974 ]
  %949 = phi double [ 0x7FF0000000000000, %942 ], [ %978, %974 ]
  %950 = phi double [ 0.000000e+00, %942 ], [ %976, %974 ]
  %951 = mul nsw i64 %946, %937
  %952 = getelementptr double, ptr %686, i64 %951
  %953 = getelementptr double, ptr %952, i64 %943
  %954 = load double, ptr %953, align 8
  %955 = getelementptr double, ptr %952, i64 %929
  br label %956

956:
  %957 = phi i64 [ %940, %945 ], [ %972, %970 ]
  %958 = phi double [ 1.000000e+00, %945 ], [ %971, %970 ]
  %959 = icmp eq i64 %957, %946
  br i1 %959, label %970, label %960

960:
  %961 = load double, ptr %939, align 8
  %962 = mul nsw i64 %957, %937
  %963 = getelementptr double, ptr %938, i64 %962
  %964 = load double, ptr %963, align 8
  %965 = fsub double %961, %964
  %966 = load double, ptr %955, align 8
  %967 = fsub double %966, %964
  %968 = fdiv double %965, %967
  %969 = fmul double %958, %968
  br label %970

970:
  %971 = phi double [ %969, %960 ], [ %958, %956 ]
  %972 = add nsw i64 %957, 1
  %973 = icmp slt i64 %972, %941
  br i1 %973, label %956, label %974

974:
  %975 = fmul double %954, %971
  %976 = fadd double %950, %975
  %977 = fcmp olt double %954, %949
  %978 = select i1 %977, double %954, double %949
  %979 = fcmp ogt double %954, %948
  %980 = select i1 %979, double %954, double %948
  %981 = tail call double @llvm.fabs.f64(double %954)
  %982 = fcmp ogt double %981, %947
  %983 = select i1 %982, double %981, double %947
  %984 = add nsw i64 %946, 1
  %985 = icmp slt i64 %984, %941
  br i1 %985, label %945, label %986

986:
  %987 = icmp eq i32 %944, 0
  br i1 %987, label %999, label %988

988:
  %989 = getelementptr inbounds nuw double, ptr %911, i64 %943
  %990 = load double, ptr %989, align 8
  %991 = fsub double %990, %976
  %992 = tail call double @llvm.fabs.f64(double %991)
  %993 = fsub double %980, %978
  %994 = fmul double %993, 5.000000e-02
  %995 = fmul double %983, 1.000000e-13
  %996 = fadd double %994, %995
  %997 = fcmp ole double %992, %996
  %998 = zext i1 %997 to i32
  br label %999

999:
  %1000 = phi i32 [ 0, %986 ], [ %998, %988 ]
  %1001 = add nuw nsw i64 %943, 1
  %1002 = icmp eq i64 %1001, %929
  br i1 %1002, label %1003, label %942

1003:
  store i32 %1000, ptr %928, align 4
  br label %1004

1004:
  %1005 = add nuw nsw i64 %908, 1
  %1006 = icmp eq i64 %1005, %904
  br i1 %1006, label %1007, label %906

1007:
  %1008 = phi i64 [ %1010, %1048 ], [ %904, %1004 ]
  %1009 = phi i32 [ %1051, %1048 ], [ %720, %1004 ]
  %1010 = add nsw i64 %1008, -1
  %1011 = getelementptr inbounds nuw i32, ptr %7, i64 %1010
  %1012 = load i32, ptr %1011, align 4
  %1013 = add nsw i32 %1012, 2
  %1014 = sext i32 %1013 to i64
  %1015 = load i64, ptr %372, align 8
  %1016 = add nsw i64 %1015, 1
  %1017 = mul nsw i64 %1016, %1014
  %1018 = getelementptr inbounds double, ptr %686, i64 %1017
  %1019 = add nsw i32 %1012, 1
  %1020 = sext i32 %1019 to i64
  %1021 = mul nsw i64 %1016, %1020
  %1022 = getelementptr inbounds double, ptr %686, i64 %1021
  %1023 = sub nsw i32 %1009, %1012
  %1024 = add nsw i32 %1023, -1
  %1025 = sext i32 %1024 to i64
  %1026 = shl i64 %1016, 3
  %1027 = mul i64 %1026, %1025
  tail call void @llvm.memmove.p0.p0.i64(ptr align 8 %1018, ptr align 8 %1022, i64 %1027, i1 false)
  %1028 = load i64, ptr %372, align 8
  %1029 = add nsw i64 %1028, 1
  %1030 = mul nsw i64 %1029, %1020
  %1031 = getelementptr inbounds double, ptr %686, i64 %1030
  %1032 = mul nsw i64 %1029, %1010
  %1033 = getelementptr inbounds double, ptr %693, i64 %1032
  %1034 = shl i64 %1029, 3
  tail call void @llvm.memcpy.p0.p0.i64(ptr align 8 %1031, ptr align 8 %1033, i64 %1034, i1 false)
  %1035 = sext i32 %1012 to i64
  %1036 = getelementptr inbounds i32, ptr %6, i64 %1035
  %1037 = getelementptr inbounds nuw i8, ptr %1036, i64 8
  %1038 = getelementptr inbounds nuw i8, ptr %1036, i64 4
  %1039 = add nsw i32 %1023, -2
  %1040 = sext i32 %1039 to i64
  %1041 = shl nsw i64 %1040, 2
  call void @llvm.memmove.p0.p0.i64(ptr nonnull align 4 %1037, ptr nonnull align 4 %1038, i64 %1041, i1 false)
  %1042 = getelementptr inbounds nuw i32, ptr %8, i64 %1010
  %1043 = load i32, ptr %1042, align 4
  %1044 = icmp eq i32 %1043, 0
  br i1 %1044, label %1048, label %1045

1045:
  %1046 = load i32, ptr %1036, align 4
  %1047 = add nsw i32 %1046, 1
  br label %1048

1048:
  %1049 = phi i32 [ %1047, %1045 ], [ 0, %1007 ]
  %1050 = getelementptr inbounds i32, ptr %6, i64 %1020
  store i32 %1049, ptr %1050, align 4
  store i32 %1049, ptr %1036, align 4
  %1051 = add i32 %1009, 1
  %1052 = icmp eq i32 %1051, %897
  br i1 %1052, label %714, label %1007

1053:
  %1054 = mul nsw i64 %781, %722
  %1055 = getelementptr double, ptr %686, i64 %1054
  %1056 = getelementptr double, ptr %1055, i64 %721
  %1057 = load double, ptr %1056, align 8
  %1058 = add nuw nsw i32 %782, 1
  %1059 = zext nneg i32 %1058 to i64
  %1060 = mul nsw i64 %722, %1059
  %1061 = getelementptr double, ptr %686, i64 %1060
  %1062 = getelementptr double, ptr %1061, i64 %721
  %1063 = load double, ptr %1062, align 8
  br label %1066

1064:
  %1065 = load double, ptr %394, align 8
  br label %1066

1066:
  %1067 = phi i1 [ true, %1064 ], [ false, %1053 ]
  %1068 = phi i32 [ 0, %1064 ], [ 1, %1053 ]
  %1069 = phi double [ 0.000000e+00, %1064 ], [ %1063, %1053 ]
  %1070 = phi double [ 0.000000e+00, %1064 ], [ %1057, %1053 ]
  %1071 = phi double [ %1065, %1064 ], [ %1057, %1053 ]
  tail call fastcc void @look(ptr noundef nonnull readonly %0, ptr noundef nonnull readonly %1, double noundef %1071, ptr noundef nonnull %537)
  %1072 = load ptr, ptr %406, align 8
  %1073 = load double, ptr %393, align 8
  %1074 = load i64, ptr %372, align 8
  %1075 = icmp sgt i64 %1074, 0
  br i1 %1075, label %1076, label %1115

1076:
  %1077 = load i64, ptr %414, align 8
  br label %1078

1078:
  %1079 = phi i64 [ 0, %1076 ], [ %1109, %1106 ]
  %1080 = phi i1 [ false, %1076 ], [ %1108, %1106 ]
  %1081 = icmp sgt i64 %1077, %1079
  br i1 %1081, label %1106, label %1082

1082:
  br i1 %628, label %1087, label %1083

1083:
  %1084 = getelementptr inbounds nuw double, ptr %542, i64 %1079
  %1085 = load double, ptr %1084, align 8
  %1086 = fcmp ogt double %1085, %1073
  br i1 %1086, label %1106, label %1087

1087:
  %1088 = getelementptr inbounds nuw double, ptr %1072, i64 %1079
  %1089 = load double, ptr %1088, align 8
  %1090 = getelementptr inbounds nuw double, ptr %537, i64 %1079
  %1091 = load double, ptr %1090, align 8
  %1092 = load ptr, ptr %413, align 8
  %1093 = getelementptr inbounds nuw %struct.Event, ptr %1092, i64 %1079
  %1094 = load i32, ptr %1093, align 8
  %1095 = icmp sgt i32 %1094, -1
  %1096 = fcmp olt double %1089, 0.000000e+00
  %1097 = and i1 %1096, %1095
  %1098 = fcmp oge double %1091, 0.000000e+00
  %1099 = and i1 %1098, %1097
  br i1 %1099, label %1106, label %1100

1100:
  %1101 = icmp slt i32 %1094, 1
  %1102 = fcmp ogt double %1089, 0.000000e+00
  %1103 = and i1 %1102, %1101
  %1104 = fcmp ole double %1091, 0.000000e+00
  %1105 = and i1 %1104, %1103
  br label %1106

1106:
  %1107 = phi i1 [ false, %1083 ], [ false, %1078 ], [ true, %1087 ], [ %1105, %1100 ]
  %1108 = or i1 %1080, %1107
  %1109 = add nuw nsw i64 %1079, 1
  %1110 = icmp eq i64 %1109, %1074
  br i1 %1110, label %1111, label %1078

1111:
  br i1 %1108, label %1112, label %1115

1112:
  %1113 = load double, ptr %394, align 8
  br i1 %1067, label %1114, label %1131

1114:
  br label %1131

1115:
  %1116 = phi double [ 0.000000e+00, %583 ], [ %1070, %1066 ], [ 0.000000e+00, %619 ], [ %1070, %1111 ], [ 0.000000e+00, %682 ]
  %1117 = phi double [ %585, %583 ], [ %1069, %1066 ], [ %585, %619 ], [ %1069, %1111 ], [ %585, %682 ]
  %1118 = phi i32 [ %584, %583 ], [ %1068, %1066 ], [ %584, %619 ], [ %1068, %1111 ], [ %584, %682 ]
  %1119 = icmp eq i32 %1118, 0
  br i1 %1119, label %1123, label %1120

1120:
  %1121 = load double, ptr %394, align 8
  %1122 = load i64, ptr %372, align 8
  br label %1131

1123:
  %1124 = load ptr, ptr %344, align 8
  %1125 = load ptr, ptr %395, align 8
  %1126 = load i64, ptr %349, align 8
  %1127 = shl i64 %1126, 3
  tail call void @llvm.memcpy.p0.p0.i64(ptr align 8 %1124, ptr align 8 %1125, i64 %1127, i1 false)
  %1128 = fcmp oeq double %467, 1.000000e+300
  br i1 %1128, label %1682, label %1129

1129:
  %1130 = fsub double %431, %467
  br label %1678

1131:
  %1132 = phi i64 [ %1122, %1120 ], [ %1074, %1114 ], [ %1074, %1112 ]
  %1133 = phi double [ %1121, %1120 ], [ %1113, %1114 ], [ %1113, %1112 ]
  %1134 = phi double [ %1117, %1120 ], [ %1113, %1114 ], [ %1070, %1112 ]
  %1135 = phi double [ %1116, %1120 ], [ 0.000000e+00, %1114 ], [ 0.000000e+00, %1112 ]
  %1136 = fmul double %1133, 0x3E7AD7F29ABCAF48
  %1137 = fcmp ogt double %1136, 0x3D719799812DEA11
  %1138 = select i1 %1137, double 0x3D719799812DEA11, double %1136
  %1139 = load ptr, ptr %344, align 8
  %1140 = load i64, ptr %392, align 8
  %1141 = icmp slt i64 %1140, 0
  %1142 = getelementptr inbounds nuw double, ptr %1139, i64 %1140
  %1143 = add nsw i64 %1132, 1
  %1144 = getelementptr inbounds double, ptr %9, i64 %1143
  %1145 = getelementptr inbounds double, ptr %1144, i64 %1143
  %1146 = getelementptr inbounds double, ptr %1145, i64 %1143
  %1147 = load ptr, ptr %416, align 8
  tail call fastcc void @look(ptr noundef nonnull readonly %0, ptr noundef nonnull readonly %1, double noundef %1135, ptr noundef nonnull %1144)
  %1148 = load i64, ptr %372, align 8
  %1149 = getelementptr inbounds double, ptr %1144, i64 %1148
  store double %1135, ptr %1149, align 8
  tail call fastcc void @look(ptr noundef nonnull readonly %0, ptr noundef nonnull readonly %1, double noundef %1134, ptr noundef nonnull %1145)
  %1150 = load i64, ptr %372, align 8
  %1151 = getelementptr inbounds double, ptr %1145, i64 %1150
  store double %1134, ptr %1151, align 8
  %1152 = shl i64 %1150, 3
  %1153 = add i64 %1152, 8
  tail call void @llvm.memcpy.p0.p0.i64(ptr nonnull align 8 %9, ptr nonnull align 8 %1144, i64 %1153, i1 false)
  %1154 = load i64, ptr %372, align 8
  %1155 = shl i64 %1154, 3
  %1156 = add i64 %1155, 8
  tail call void @llvm.memcpy.p0.p0.i64(ptr align 8 %1147, ptr nonnull align 8 %1144, i64 %1156, i1 false)
  %1157 = load i64, ptr %372, align 8
  %1158 = add nsw i64 %1157, 1
  %1159 = getelementptr inbounds double, ptr %1147, i64 %1158
  %1160 = shl i64 %1158, 3
  tail call void @llvm.memcpy.p0.p0.i64(ptr align 8 %1159, ptr nonnull align 8 %1145, i64 %1160, i1 false)
  %1161 = icmp eq ptr %1139, null
  %1162 = select i1 %1141, i1 true, i1 %1161
  %1163 = fmul double %1138, 2.500000e-01
  br label %1164

1164:
  %1165 = phi i64 [ 0, %1131 ], [ %1359, %1355 ]
  %1166 = load i64, ptr %372, align 8
  %1167 = getelementptr inbounds double, ptr %1145, i64 %1166
  %1168 = load double, ptr %1167, align 8
  %1169 = getelementptr inbounds double, ptr %1144, i64 %1166
  %1170 = load double, ptr %1169, align 8
  %1171 = fsub double %1168, %1170
  %1172 = fcmp ogt double %1171, %1138
  br i1 %1172, label %1173, label %1363

1173:
  %1174 = fadd double %1168, %1170
  %1175 = fmul double %1174, 5.000000e-01
  %1176 = trunc i64 %1165 to i8
  %1177 = urem i8 %1176, 5
  %1178 = icmp eq i8 %1177, 4
  br i1 %1178, label %1303, label %1179

1179:
  %1180 = load double, ptr %393, align 8
  %1181 = icmp sgt i64 %1166, 0
  br i1 %1181, label %1182, label %1295

1182:
  %1183 = phi i64 [ %1213, %1212 ], [ 0, %1179 ]
  br i1 %1162, label %1188, label %1184

1184:
  %1185 = getelementptr inbounds nuw double, ptr %1142, i64 %1183
  %1186 = load double, ptr %1185, align 8
  %1187 = fcmp ogt double %1186, %1180
  br i1 %1187, label %1208, label %1188

1188:
  %1189 = getelementptr inbounds nuw double, ptr %9, i64 %1183
  %1190 = load double, ptr %1189, align 8
  %1191 = getelementptr inbounds nuw double, ptr %1145, i64 %1183
  %1192 = load double, ptr %1191, align 8
  %1193 = load ptr, ptr %413, align 8
  %1194 = getelementptr inbounds nuw %struct.Event, ptr %1193, i64 %1183
  %1195 = load i32, ptr %1194, align 8
  %1196 = icmp sgt i32 %1195, -1
  %1197 = fcmp olt double %1190, 0.000000e+00
  %1198 = and i1 %1197, %1196
  %1199 = fcmp oge double %1192, 0.000000e+00
  %1200 = and i1 %1199, %1198
  br i1 %1200, label %1208, label %1201

1201:
  %1202 = icmp slt i32 %1195, 1
  %1203 = fcmp ogt double %1190, 0.000000e+00
  %1204 = and i1 %1203, %1202
  %1205 = fcmp ole double %1192, 0.000000e+00
  %1206 = and i1 %1205, %1204
  %1207 = zext i1 %1206 to i32
  br label %1208

1208:
  %1209 = phi i32 [ 0, %1184 ], [ %1207, %1201 ], [ 1, %1188 ]
  br i1 %440, label %1212, label %1210

1210:
  %1211 = getelementptr inbounds nuw i32, ptr %437, i64 %1183
  store i32 %1209, ptr %1211, align 4
  br label %1212

1212:
  %1213 = add nuw nsw i64 %1183, 1
  %1214 = icmp eq i64 %1213, %1166
  br i1 %1214, label %1215, label %1182

1215:
  %1216 = add nuw nsw i64 %1165, 2
  %1217 = getelementptr double, ptr %1147, i64 %1166
  %1218 = add nuw nsw i64 %1166, 1
  br label %1219

1219:
  %1220 = phi i64 [ 0, %1215 ], [ %1293, %1291 ]
  %1221 = phi double [ 1.000000e+300, %1215 ], [ %1292, %1291 ]
  %1222 = getelementptr inbounds nuw i32, ptr %437, i64 %1220
  %1223 = load i32, ptr %1222, align 4
  %1224 = icmp eq i32 %1223, 0
  br i1 %1224, label %1291, label %1225

1225:
  %1226 = getelementptr inbounds nuw double, ptr %1144, i64 %1220
  %1227 = load double, ptr %1226, align 8
  %1228 = getelementptr inbounds nuw double, ptr %1145, i64 %1220
  %1229 = load double, ptr %1228, align 8
  %1230 = tail call double @llvm.fabs.f64(double %1227)
  %1231 = tail call double @llvm.fabs.f64(double %1229)
  %1232 = fadd double %1230, %1231
  %1233 = fmul double %1171, %1230
  %1234 = fcmp ogt double %1232, 1.000000e-300
  %1235 = select i1 %1234, double %1232, double 1.000000e-300
  %1236 = fdiv double %1233, %1235
  %1237 = fadd double %1170, %1236
  br label %1238

1238:
  %1239 = phi i64 [ %1242, %1241 ], [ %1216, %1225 ]
  %1240 = icmp sgt i64 %1239, 0
  br i1 %1240, label %1241, label %1287

1241:
  %1242 = add nsw i64 %1239, -1
  %1243 = mul nsw i64 %1242, %1218
  %1244 = getelementptr double, ptr %1217, i64 %1243
  %1245 = load double, ptr %1244, align 8
  %1246 = fcmp oeq double %1245, %1170
  %1247 = fcmp oeq double %1245, %1168
  %1248 = or i1 %1246, %1247
  br i1 %1248, label %1238, label %1249

1249:
  %1250 = and i64 %1242, 4294967295
  %1251 = mul nuw nsw i64 %1250, %1218
  %1252 = getelementptr double, ptr %1147, i64 %1251
  %1253 = getelementptr double, ptr %1252, i64 %1220
  %1254 = load double, ptr %1253, align 8
  %1255 = fcmp oeq double %1254, %1227
  %1256 = fcmp oeq double %1254, %1229
  %1257 = select i1 %1255, i1 true, i1 %1256
  %1258 = fcmp oeq double %1227, %1229
  %1259 = select i1 %1257, i1 true, i1 %1258
  br i1 %1259, label %1287, label %1260

1260:
  %1261 = getelementptr double, ptr %1252, i64 %1166
  %1262 = load double, ptr %1261, align 8
  %1263 = fmul double %1170, %1229
  %1264 = fmul double %1263, %1254
  %1265 = fsub double %1227, %1229
  %1266 = fsub double %1227, %1254
  %1267 = fmul double %1265, %1266
  %1268 = fdiv double %1264, %1267
  %1269 = fmul double %1168, %1227
  %1270 = fmul double %1269, %1254
  %1271 = fsub double %1229, %1227
  %1272 = fsub double %1229, %1254
  %1273 = fmul double %1271, %1272
  %1274 = fdiv double %1270, %1273
  %1275 = fadd double %1268, %1274
  %1276 = fmul double %1227, %1262
  %1277 = fmul double %1229, %1276
  %1278 = fsub double %1254, %1227
  %1279 = fsub double %1254, %1229
  %1280 = fmul double %1278, %1279
  %1281 = fdiv double %1277, %1280
  %1282 = fadd double %1275, %1281
  %1283 = fcmp olt double %1170, %1282
  %1284 = fcmp olt double %1282, %1168
  %1285 = and i1 %1283, %1284
  %1286 = select i1 %1285, double %1282, double %1237
  br label %1287

1287:
  %1288 = phi double [ %1286, %1260 ], [ %1237, %1249 ], [ %1237, %1238 ]
  %1289 = fcmp olt double %1288, %1221
  %1290 = select i1 %1289, double %1288, double %1221
  br label %1291

1291:
  %1292 = phi double [ %1290, %1287 ], [ %1221, %1219 ]
  %1293 = add nuw nsw i64 %1220, 1
  %1294 = icmp eq i64 %1293, %1166
  br i1 %1294, label %1295, label %1219

1295:
  %1296 = phi double [ 1.000000e+300, %1179 ], [ %1292, %1291 ]
  %1297 = fsub double %1168, %1296
  %1298 = fsub double %1296, %1170
  %1299 = fcmp ogt double %1297, %1298
  %1300 = select i1 %1299, double 4.000000e-01, double -4.000000e-01
  %1301 = fmul double %1138, %1300
  %1302 = fadd double %1296, %1301
  br label %1303

1303:
  %1304 = phi double [ %1302, %1295 ], [ %1175, %1173 ]
  %1305 = fadd double %1163, %1170
  %1306 = fcmp ogt double %1304, %1305
  %1307 = select i1 %1306, double %1304, double %1305
  %1308 = fsub double %1168, %1163
  %1309 = fcmp olt double %1307, %1308
  %1310 = select i1 %1309, double %1307, double %1308
  tail call fastcc void @look(ptr noundef nonnull readonly %0, ptr noundef nonnull readonly %1, double noundef %1310, ptr noundef nonnull %1146)
  %1311 = load i64, ptr %372, align 8
  %1312 = getelementptr inbounds double, ptr %1146, i64 %1311
  store double %1310, ptr %1312, align 8
  %1313 = add nuw nsw i64 %1165, 2
  %1314 = add nsw i64 %1311, 1
  %1315 = mul nsw i64 %1314, %1313
  %1316 = getelementptr inbounds double, ptr %1147, i64 %1315
  %1317 = shl i64 %1314, 3
  tail call void @llvm.memcpy.p0.p0.i64(ptr align 8 %1316, ptr nonnull align 8 %1146, i64 %1317, i1 false)
  %1318 = load double, ptr %393, align 8
  %1319 = load i64, ptr %372, align 8
  %1320 = icmp sgt i64 %1319, 0
  br i1 %1320, label %1321, label %1354

1321:
  %1322 = phi i64 [ %1351, %1348 ], [ 0, %1303 ]
  %1323 = phi i1 [ %1350, %1348 ], [ false, %1303 ]
  br i1 %1162, label %1328, label %1324

1324:
  %1325 = getelementptr inbounds nuw double, ptr %1142, i64 %1322
  %1326 = load double, ptr %1325, align 8
  %1327 = fcmp ogt double %1326, %1318
  br i1 %1327, label %1348, label %1328

1328:
  %1329 = getelementptr inbounds nuw double, ptr %9, i64 %1322
  %1330 = load double, ptr %1329, align 8
  %1331 = getelementptr inbounds nuw double, ptr %1146, i64 %1322
  %1332 = load double, ptr %1331, align 8
  %1333 = load ptr, ptr %413, align 8
  %1334 = getelementptr inbounds nuw %struct.Event, ptr %1333, i64 %1322
  %1335 = load i32, ptr %1334, align 8
  %1336 = icmp sgt i32 %1335, -1
  %1337 = fcmp olt double %1330, 0.000000e+00
  %1338 = and i1 %1337, %1336
  %1339 = fcmp oge double %1332, 0.000000e+00
  %1340 = and i1 %1339, %1338
  br i1 %1340, label %1348, label %1341

1341:
  %1342 = icmp slt i32 %1335, 1
  %1343 = fcmp ogt double %1330, 0.000000e+00
  %1344 = and i1 %1343, %1342
  %1345 = fcmp ole double %1332, 0.000000e+00
  %1346 = and i1 %1345, %1344
  %1347 = freeze i1 %1346
  br label %1348

1348:
  %1349 = phi i1 [ false, %1324 ], [ %1347, %1341 ], [ true, %1328 ]
  %1350 = or i1 %1323, %1349
  %1351 = add nuw nsw i64 %1322, 1
  %1352 = icmp eq i64 %1351, %1319
  br i1 %1352, label %1353, label %1321

1353:
  br i1 %1350, label %1355, label %1354

1354:
  br label %1355

1355:
  %1356 = phi ptr [ %1144, %1354 ], [ %1145, %1353 ]
  %1357 = shl i64 %1319, 3
  %1358 = add i64 %1357, 8
  tail call void @llvm.memcpy.p0.p0.i64(ptr nonnull align 8 %1356, ptr nonnull align 8 %1146, i64 %1358, i1 false)
  %1359 = add nuw nsw i64 %1165, 1
  %1360 = icmp eq i64 %1359, 100
  br i1 %1360, label %1361, label %1164

1361:
  %1362 = load i64, ptr %372, align 8
  br label %1363

1363:
  %1364 = phi i64 [ %1362, %1361 ], [ %1166, %1164 ]
  %1365 = load double, ptr %393, align 8
  %1366 = icmp sgt i64 %1364, 0
  br i1 %1366, label %1367, label %1400

1367:
  %1368 = phi i64 [ %1398, %1397 ], [ 0, %1363 ]
  br i1 %1162, label %1373, label %1369

1369:
  %1370 = getelementptr inbounds nuw double, ptr %1142, i64 %1368
  %1371 = load double, ptr %1370, align 8
  %1372 = fcmp ogt double %1371, %1365
  br i1 %1372, label %1393, label %1373

1373:
  %1374 = getelementptr inbounds nuw double, ptr %9, i64 %1368
  %1375 = load double, ptr %1374, align 8
  %1376 = getelementptr inbounds nuw double, ptr %1145, i64 %1368
  %1377 = load double, ptr %1376, align 8
  %1378 = load ptr, ptr %413, align 8
  %1379 = getelementptr inbounds nuw %struct.Event, ptr %1378, i64 %1368
  %1380 = load i32, ptr %1379, align 8
  %1381 = icmp sgt i32 %1380, -1
  %1382 = fcmp olt double %1375, 0.000000e+00
  %1383 = and i1 %1382, %1381
  %1384 = fcmp oge double %1377, 0.000000e+00
  %1385 = and i1 %1384, %1383
  br i1 %1385, label %1393, label %1386

1386:
  %1387 = icmp slt i32 %1380, 1
  %1388 = fcmp ogt double %1375, 0.000000e+00
  %1389 = and i1 %1388, %1387
  %1390 = fcmp ole double %1377, 0.000000e+00
  %1391 = and i1 %1390, %1389
  %1392 = zext i1 %1391 to i32
  br label %1393

1393:
  %1394 = phi i32 [ 0, %1369 ], [ %1392, %1386 ], [ 1, %1373 ]
  br i1 %440, label %1397, label %1395

1395:
  %1396 = getelementptr inbounds nuw i32, ptr %439, i64 %1368
  store i32 %1394, ptr %1396, align 4
  br label %1397

1397:
  %1398 = add nuw nsw i64 %1368, 1
  %1399 = icmp eq i64 %1398, %1364
  br i1 %1399, label %1400, label %1367

1400:
  %1401 = getelementptr inbounds double, ptr %1145, i64 %1364
  %1402 = load double, ptr %1401, align 8
  %1403 = fadd double %444, %1402
  %1404 = load ptr, ptr %344, align 8
  %1405 = fsub double %1403, %444
  %1406 = load i64, ptr %396, align 8
  %1407 = sitofp i64 %1406 to double
  %1408 = fmul double %1407, 0x3CC0000000000000
  %1409 = fsub double 1.000000e+00, %1408
  %1410 = fmul double %1405, %1409
  %1411 = load i64, ptr %397, align 8
  %1412 = getelementptr inbounds double, ptr %1404, i64 %1411
  store double %444, ptr %1412, align 8
  %1413 = load i64, ptr %398, align 8
  %1414 = getelementptr inbounds double, ptr %1404, i64 %1413
  store double %1410, ptr %1414, align 8
  %1415 = load double, ptr %17, align 8
  %1416 = fdiv double %1410, %1415
  %1417 = load i64, ptr %399, align 8
  %1418 = getelementptr inbounds double, ptr %1404, i64 %1417
  store double %1416, ptr %1418, align 8
  %1419 = load ptr, ptr %400, align 8
  %1420 = load ptr, ptr %401, align 8
  %1421 = load ptr, ptr %402, align 8
  tail call void %1419(ptr noundef %1404, ptr noundef %1420, ptr noundef %1421)
  %1422 = load ptr, ptr %403, align 8
  %1423 = load i64, ptr %404, align 8
  %1424 = getelementptr inbounds double, ptr %1404, i64 %1423
  %1425 = load ptr, ptr %402, align 8
  tail call void %1422(ptr noundef %1404, ptr noundef %1424, ptr noundef %1425, i64 noundef 1)
  %1426 = load i64, ptr %369, align 8
  %1427 = getelementptr inbounds double, ptr %1404, i64 %1426
  store double %1410, ptr %1427, align 8
  %1428 = load ptr, ptr %417, align 8
  %1429 = icmp eq ptr %1428, null
  br i1 %1429, label %1639, label %1430

1430:
  %1431 = load i64, ptr %414, align 8
  %1432 = load i64, ptr %372, align 8
  %1433 = icmp slt i64 %1431, %1432
  br i1 %1433, label %1434, label %1639

1434:
  %1435 = load ptr, ptr %407, align 8
  %1436 = load i64, ptr %418, align 8
  %1437 = getelementptr inbounds double, ptr %9, i64 %1436
  %1438 = getelementptr inbounds nuw i8, ptr %1428, i64 40
  %1439 = load ptr, ptr %1438, align 8
  %1440 = load double, ptr %1439, align 8
  %1441 = fsub double %1403, %1440
  %1442 = shl i64 %1431, 32
  %1443 = ashr exact i64 %1442, 32
  %1444 = icmp sgt i64 %1432, %1443
  br i1 %1444, label %1445, label %1639

1445:
  %1446 = phi i64 [ %1459, %1457 ], [ %1443, %1434 ]
  %1447 = phi i1 [ %1458, %1457 ], [ false, %1434 ]
  br i1 %1447, label %1457, label %1448

1448:
  %1449 = getelementptr inbounds i32, ptr %439, i64 %1446
  %1450 = load i32, ptr %1449, align 4
  %1451 = icmp eq i32 %1450, 0
  br i1 %1451, label %1457, label %1452

1452:
  %1453 = getelementptr double, ptr %1439, i64 %1446
  %1454 = getelementptr i8, ptr %1453, i64 8
  %1455 = load double, ptr %1454, align 8
  %1456 = fcmp une double %1455, 0.000000e+00
  br label %1457

1457:
  %1458 = phi i1 [ true, %1445 ], [ false, %1448 ], [ %1456, %1452 ]
  %1459 = add nsw i64 %1446, 1
  %1460 = icmp eq i64 %1459, %1432
  br i1 %1460, label %1461, label %1445

1461:
  %1462 = fcmp ogt double %1441, 0.000000e+00
  %1463 = select i1 %1458, i1 %1462, i1 false
  br i1 %1463, label %1464, label %1639

1464:
  %1465 = load double, ptr %17, align 8
  %1466 = fmul double %1465, 2.000000e+00
  %1467 = fcmp olt double %1441, %1466
  br i1 %1467, label %1468, label %1639

1468:
  %1469 = load ptr, ptr %21, align 8
  %1470 = load ptr, ptr %1, align 8
  %1471 = load i64, ptr %0, align 8
  %1472 = getelementptr inbounds double, ptr %1470, i64 %1471
  %1473 = load double, ptr %1472, align 8
  %1474 = fsub double %1440, %1473
  %1475 = fdiv double %1474, %1465
  %1476 = tail call double @llvm.floor.f64(double %1475)
  %1477 = load i64, ptr %1469, align 8
  %1478 = icmp sgt i64 %1477, 0
  br i1 %1478, label %1479, label %1495

1479:
  %1480 = getelementptr inbounds nuw i8, ptr %1469, i64 8
  %1481 = load ptr, ptr %1480, align 8
  br label %1482

1482:
  %1483 = phi i64 [ 0, %1479 ], [ %1493, %1482 ]
  %1484 = phi i64 [ %1477, %1479 ], [ %1492, %1482 ]
  %1485 = add nuw nsw i64 %1484, %1483
  %1486 = lshr i64 %1485, 1
  %1487 = getelementptr inbounds nuw i64, ptr %1481, i64 %1486
  %1488 = load i64, ptr %1487, align 8
  %1489 = sitofp i64 %1488 to double
  %1490 = fcmp ogt double %1476, %1489
  %1491 = add nuw nsw i64 %1486, 1
  %1492 = select i1 %1490, i64 %1484, i64 %1486
  %1493 = select i1 %1490, i64 %1491, i64 %1483
  %1494 = icmp slt i64 %1493, %1492
  br i1 %1494, label %1482, label %1495

1495:
  %1496 = phi i64 [ 0, %1468 ], [ %1493, %1482 ]
  %1497 = icmp slt i64 %1496, %1477
  br i1 %1497, label %1498, label %1519

1498:
  %1499 = getelementptr inbounds nuw i8, ptr %1469, i64 8
  %1500 = load ptr, ptr %1499, align 8
  %1501 = fsub double %1403, %1473
  %1502 = fdiv double %1501, %1465
  %1503 = tail call double @llvm.floor.f64(double %1502)
  %1504 = getelementptr inbounds nuw i8, ptr %1469, i64 16
  br label %1508

1505:
  %1506 = add i64 %1509, 1
  %1507 = icmp eq i64 %1506, %1477
  br i1 %1507, label %1519, label %1508

1508:
  %1509 = phi i64 [ %1496, %1498 ], [ %1506, %1505 ]
  %1510 = getelementptr inbounds nuw i64, ptr %1500, i64 %1509
  %1511 = load i64, ptr %1510, align 8
  %1512 = sitofp i64 %1511 to double
  %1513 = fcmp ult double %1503, %1512
  br i1 %1513, label %1519, label %1514

1514:
  %1515 = load ptr, ptr %1504, align 8
  %1516 = getelementptr inbounds nuw i64, ptr %1515, i64 %1509
  %1517 = load i64, ptr %1516, align 8
  %1518 = icmp eq i64 %1517, 0
  br i1 %1518, label %1505, label %1639

1519:
  %1520 = getelementptr inbounds nuw i8, ptr %1439, i64 8
  %1521 = getelementptr inbounds double, ptr %1520, i64 %1432
  %1522 = load i64, ptr %349, align 8
  %1523 = shl i64 %1522, 3
  tail call void @llvm.memcpy.p0.p0.i64(ptr align 8 %1435, ptr nonnull align 8 %1521, i64 %1523, i1 false)
  %1524 = fmul double %1441, 2.500000e-01
  br label %1525

1525:
  %1526 = phi i32 [ 0, %1519 ], [ %1554, %1525 ]
  %1527 = load double, ptr %1439, align 8
  %1528 = uitofp nneg i32 %1526 to double
  %1529 = fmul double %1441, %1528
  %1530 = fmul double %1529, 2.500000e-01
  %1531 = fadd double %1527, %1530
  %1532 = load i64, ptr %396, align 8
  %1533 = sitofp i64 %1532 to double
  %1534 = fmul double %1533, 0x3CC0000000000000
  %1535 = fsub double 1.000000e+00, %1534
  %1536 = fmul double %1524, %1535
  %1537 = load i64, ptr %397, align 8
  %1538 = getelementptr inbounds double, ptr %1435, i64 %1537
  store double %1531, ptr %1538, align 8
  %1539 = load i64, ptr %398, align 8
  %1540 = getelementptr inbounds double, ptr %1435, i64 %1539
  store double %1536, ptr %1540, align 8
  %1541 = load double, ptr %17, align 8
  %1542 = fdiv double %1536, %1541
  %1543 = load i64, ptr %399, align 8
  %1544 = getelementptr inbounds double, ptr %1435, i64 %1543
  store double %1542, ptr %1544, align 8
  %1545 = load ptr, ptr %400, align 8
  %1546 = load ptr, ptr %401, align 8
  %1547 = load ptr, ptr %402, align 8
  tail call void %1545(ptr noundef %1435, ptr noundef %1546, ptr noundef %1547)
  %1548 = load ptr, ptr %403, align 8
  %1549 = load i64, ptr %404, align 8
  %1550 = getelementptr inbounds double, ptr %1435, i64 %1549
  %1551 = load ptr, ptr %402, align 8
  tail call void %1548(ptr noundef %1435, ptr noundef %1550, ptr noundef %1551, i64 noundef 1)
  %1552 = load i64, ptr %369, align 8
  %1553 = getelementptr inbounds double, ptr %1435, i64 %1552
  store double %1536, ptr %1553, align 8
  %1554 = add nuw nsw i32 %1526, 1
  %1555 = icmp eq i32 %1554, 4
  br i1 %1555, label %1556, label %1525

1556:
  %1557 = load ptr, ptr %419, align 8
  %1558 = load ptr, ptr %409, align 8
  %1559 = load ptr, ptr %410, align 8
  %1560 = load i64, ptr %411, align 8
  %1561 = shl i64 %1560, 3
  tail call void @llvm.memcpy.p0.p0.i64(ptr align 8 %1558, ptr align 8 %1559, i64 %1561, i1 false)
  %1562 = load i64, ptr %411, align 8
  %1563 = load i64, ptr %412, align 8
  %1564 = icmp slt i64 %1562, %1563
  %1565 = load ptr, ptr %409, align 8
  br i1 %1564, label %1566, label %1579

1566:
  %1567 = load ptr, ptr %410, align 8
  %1568 = getelementptr inbounds double, ptr %1567, i64 %1562
  br label %1569

1569:
  %1570 = phi i64 [ %1562, %1566 ], [ %1577, %1569 ]
  %1571 = getelementptr inbounds double, ptr %1567, i64 %1570
  %1572 = load double, ptr %1571, align 8
  %1573 = load double, ptr %1568, align 8
  %1574 = fdiv double %1536, %1573
  %1575 = fmul double %1572, %1574
  %1576 = getelementptr inbounds double, ptr %1565, i64 %1570
  store double %1575, ptr %1576, align 8
  %1577 = add nsw i64 %1570, 1
  %1578 = icmp eq i64 %1577, %1563
  br i1 %1578, label %1579, label %1569

1579:
  %1580 = load ptr, ptr %402, align 8
  tail call void %1557(ptr noundef nonnull %1437, ptr noundef nonnull %1435, ptr noundef %1565, ptr noundef %1580)
  %1581 = load ptr, ptr %419, align 8
  %1582 = load ptr, ptr %344, align 8
  %1583 = load i64, ptr %369, align 8
  %1584 = getelementptr inbounds double, ptr %1582, i64 %1583
  %1585 = load double, ptr %1584, align 8
  %1586 = load ptr, ptr %409, align 8
  %1587 = load ptr, ptr %410, align 8
  %1588 = load i64, ptr %411, align 8
  %1589 = shl i64 %1588, 3
  tail call void @llvm.memcpy.p0.p0.i64(ptr align 8 %1586, ptr align 8 %1587, i64 %1589, i1 false)
  %1590 = load i64, ptr %411, align 8
  %1591 = load i64, ptr %412, align 8
  %1592 = icmp slt i64 %1590, %1591
  %1593 = load ptr, ptr %409, align 8
  br i1 %1592, label %1594, label %1607

1594:
  %1595 = load ptr, ptr %410, align 8
  %1596 = getelementptr inbounds double, ptr %1595, i64 %1590
  br label %1597

1597:
  %1598 = phi i64 [ %1590, %1594 ], [ %1605, %1597 ]
  %1599 = getelementptr inbounds double, ptr %1595, i64 %1598
  %1600 = load double, ptr %1599, align 8
  %1601 = load double, ptr %1596, align 8
  %1602 = fdiv double %1585, %1601
  %1603 = fmul double %1600, %1602
  %1604 = getelementptr inbounds double, ptr %1593, i64 %1598
  store double %1603, ptr %1604, align 8
  %1605 = add nsw i64 %1598, 1
  %1606 = icmp eq i64 %1605, %1591
  br i1 %1606, label %1607, label %1597

1607:
  %1608 = load ptr, ptr %402, align 8
  tail call void %1581(ptr noundef nonnull %9, ptr noundef nonnull %1582, ptr noundef %1593, ptr noundef %1608)
  %1609 = load i64, ptr %420, align 8
  %1610 = icmp sgt i64 %1609, 0
  br i1 %1610, label %1611, label %1633

1611:
  %1612 = load i64, ptr %421, align 8
  %1613 = add i64 %1612, %1609
  br label %1617

1614:
  %1615 = add nuw nsw i64 %1618, 1
  %1616 = icmp eq i64 %1615, %1609
  br i1 %1616, label %1633, label %1617

1617:
  %1618 = phi i64 [ 0, %1611 ], [ %1615, %1614 ]
  %1619 = phi double [ 0.000000e+00, %1611 ], [ %1631, %1614 ]
  %1620 = add i64 %1613, %1618
  %1621 = getelementptr inbounds double, ptr %9, i64 %1620
  %1622 = load double, ptr %1621, align 8
  %1623 = getelementptr inbounds double, ptr %1437, i64 %1620
  %1624 = load double, ptr %1623, align 8
  %1625 = fsub double %1622, %1624
  %1626 = tail call double @llvm.fabs.f64(double %1625)
  %1627 = fsub double %1626, %1626
  %1628 = fcmp oeq double %1627, 0.000000e+00
  %1629 = fcmp ogt double %1626, %1619
  %1630 = select i1 %1629, double %1626, double %1619
  %1631 = select i1 %1628, double %1630, double 0x7FF0000000000000
  %1632 = fcmp oeq double %1631, 0x7FF0000000000000
  br i1 %1632, label %1633, label %1614

1633:
  %1634 = phi double [ 0.000000e+00, %1607 ], [ 0x7FF0000000000000, %1617 ], [ %1631, %1614 ]
  %1635 = getelementptr inbounds nuw i8, ptr %1428, i64 32
  %1636 = load double, ptr %1635, align 8
  %1637 = fcmp ogt double %1634, %1636
  br i1 %1637, label %1638, label %1639

1638:
  store double %1634, ptr %1635, align 8
  br label %1639

1639:
  %1640 = load ptr, ptr %344, align 8
  %1641 = tail call fastcc i32 @act(ptr noundef nonnull %0, ptr noundef nonnull %1, ptr noundef %1640, double noundef %1403, ptr noundef %439, ptr nonnull %9, ptr %437)
  %1642 = load ptr, ptr %417, align 8
  %1643 = icmp eq ptr %1642, null
  br i1 %1643, label %1671, label %1644

1644:
  %1645 = load i64, ptr %414, align 8
  %1646 = load i64, ptr %372, align 8
  %1647 = icmp slt i64 %1645, %1646
  br i1 %1647, label %1648, label %1671

1648:
  %1649 = getelementptr inbounds nuw i8, ptr %1642, i64 40
  %1650 = load ptr, ptr %1649, align 8
  store double %1403, ptr %1650, align 8
  %1651 = icmp sgt i64 %1646, 0
  br i1 %1651, label %1652, label %1665

1652:
  %1653 = phi i64 [ %1662, %1660 ], [ 0, %1648 ]
  %1654 = icmp sgt i64 %1645, %1653
  br i1 %1654, label %1660, label %1655

1655:
  %1656 = getelementptr inbounds nuw i32, ptr %439, i64 %1653
  %1657 = load i32, ptr %1656, align 4
  %1658 = icmp ne i32 %1657, 0
  %1659 = uitofp i1 %1658 to double
  br label %1660

1660:
  %1661 = phi double [ 0.000000e+00, %1652 ], [ %1659, %1655 ]
  %1662 = add nuw nsw i64 %1653, 1
  %1663 = getelementptr inbounds nuw double, ptr %1650, i64 %1662
  store double %1661, ptr %1663, align 8
  %1664 = icmp eq i64 %1662, %1646
  br i1 %1664, label %1665, label %1652

1665:
  %1666 = getelementptr inbounds nuw i8, ptr %1650, i64 8
  %1667 = getelementptr inbounds double, ptr %1666, i64 %1646
  %1668 = load ptr, ptr %344, align 8
  %1669 = load i64, ptr %349, align 8
  %1670 = shl i64 %1669, 3
  tail call void @llvm.memcpy.p0.p0.i64(ptr nonnull align 8 %1667, ptr align 8 %1668, i64 %1670, i1 false)
  br label %1671

1671:
  %1672 = icmp eq i32 %1641, 0
  br i1 %1672, label %1673, label %1788

1673:
  %1674 = fsub double %431, %1403
  %1675 = load double, ptr %17, align 8
  %1676 = fmul double %1675, 1.000000e-09
  %1677 = fcmp ugt double %1674, %1676
  br i1 %1677, label %1678, label %1682

1678:
  %1679 = phi double [ %1130, %1129 ], [ %1674, %1673 ]
  %1680 = phi double [ %467, %1129 ], [ %1403, %1673 ]
  %1681 = load i64, ptr %372, align 8
  br label %441

1682:
  %1683 = phi double [ %1403, %1673 ], [ %431, %1123 ]
  %1684 = getelementptr inbounds nuw i8, ptr %426, i64 16
  %1685 = load double, ptr %1684, align 8
  %1686 = fcmp olt double %1685, 1.000000e+300
  br i1 %1686, label %1687, label %1822

1687:
  %1688 = getelementptr inbounds nuw i8, ptr %426, i64 24
  %1689 = load double, ptr %1688, align 8
  %1690 = load i64, ptr %372, align 8
  %1691 = add nsw i64 %1690, 1
  %1692 = getelementptr inbounds double, ptr %9, i64 %1691
  %1693 = load ptr, ptr %344, align 8
  %1694 = load i64, ptr %392, align 8
  %1695 = icmp slt i64 %1694, 0
  %1696 = getelementptr inbounds nuw double, ptr %1693, i64 %1694
  %1697 = load double, ptr %1693, align 8
  %1698 = getelementptr i32, ptr %4, i64 %1690
  %1699 = getelementptr i8, ptr %1698, i64 4
  %1700 = xor i64 %1690, -1
  %1701 = getelementptr inbounds i32, ptr %1699, i64 %1700
  %1702 = load ptr, ptr %405, align 8
  %1703 = load i64, ptr %369, align 8
  %1704 = getelementptr inbounds double, ptr %1693, i64 %1703
  %1705 = load double, ptr %1704, align 8
  %1706 = load ptr, ptr %409, align 8
  %1707 = load ptr, ptr %410, align 8
  %1708 = load i64, ptr %411, align 8
  %1709 = shl i64 %1708, 3
  tail call void @llvm.memcpy.p0.p0.i64(ptr align 8 %1706, ptr align 8 %1707, i64 %1709, i1 false)
  %1710 = load i64, ptr %411, align 8
  %1711 = load i64, ptr %412, align 8
  %1712 = icmp slt i64 %1710, %1711
  %1713 = load ptr, ptr %409, align 8
  br i1 %1712, label %1714, label %1727

1714:
  %1715 = load ptr, ptr %410, align 8
  %1716 = getelementptr inbounds double, ptr %1715, i64 %1710
  br label %1717

1717:
  %1718 = phi i64 [ %1710, %1714 ], [ %1725, %1717 ]
  %1719 = getelementptr inbounds double, ptr %1715, i64 %1718
  %1720 = load double, ptr %1719, align 8
  %1721 = load double, ptr %1716, align 8
  %1722 = fdiv double %1705, %1721
  %1723 = fmul double %1720, %1722
  %1724 = getelementptr inbounds double, ptr %1713, i64 %1718
  store double %1723, ptr %1724, align 8
  %1725 = add nsw i64 %1718, 1
  %1726 = icmp eq i64 %1725, %1711
  br i1 %1726, label %1727, label %1717

1727:
  %1728 = load ptr, ptr %402, align 8
  tail call void %1702(ptr noundef nonnull %9, ptr noundef nonnull %1693, ptr noundef %1713, ptr noundef %1728)
  %1729 = load ptr, ptr %405, align 8
  %1730 = load ptr, ptr %407, align 8
  %1731 = load ptr, ptr %344, align 8
  %1732 = load i64, ptr %369, align 8
  %1733 = getelementptr inbounds double, ptr %1731, i64 %1732
  %1734 = load double, ptr %1733, align 8
  %1735 = tail call fastcc ptr @set_out(ptr noundef nonnull %0, ptr noundef nonnull %1, ptr noundef %1731, double noundef %1734, double noundef %1689)
  %1736 = load ptr, ptr %402, align 8
  tail call void %1729(ptr noundef nonnull %1692, ptr noundef %1730, ptr noundef %1735, ptr noundef %1736)
  %1737 = load i64, ptr %372, align 8
  %1738 = icmp sgt i64 %1737, 0
  br i1 %1738, label %1739, label %1822

1739:
  %1740 = icmp eq ptr %1699, null
  br label %1741

1741:
  %1742 = phi i64 [ 0, %1739 ], [ %1774, %1772 ]
  %1743 = phi i1 [ false, %1739 ], [ %1773, %1772 ]
  br i1 %1695, label %1748, label %1744

1744:
  %1745 = getelementptr inbounds nuw double, ptr %1696, i64 %1742
  %1746 = load double, ptr %1745, align 8
  %1747 = fcmp ogt double %1746, %1685
  br i1 %1747, label %1767, label %1748

1748:
  %1749 = getelementptr inbounds nuw double, ptr %9, i64 %1742
  %1750 = load double, ptr %1749, align 8
  %1751 = getelementptr inbounds nuw double, ptr %1692, i64 %1742
  %1752 = load double, ptr %1751, align 8
  %1753 = load ptr, ptr %413, align 8
  %1754 = getelementptr inbounds nuw %struct.Event, ptr %1753, i64 %1742
  %1755 = load i32, ptr %1754, align 8
  %1756 = icmp sgt i32 %1755, -1
  %1757 = fcmp olt double %1750, 0.000000e+00
  %1758 = and i1 %1757, %1756
  %1759 = fcmp oge double %1752, 0.000000e+00
  %1760 = and i1 %1759, %1758
  br i1 %1760, label %1767, label %1761

1761:
  %1762 = icmp slt i32 %1755, 1
  %1763 = fcmp ogt double %1750, 0.000000e+00
  %1764 = and i1 %1763, %1762
  %1765 = fcmp ole double %1752, 0.000000e+00
  %1766 = and i1 %1765, %1764
  br label %1767

1767:
  %1768 = phi i1 [ false, %1744 ], [ %1766, %1761 ], [ true, %1748 ]
  br i1 %1740, label %1772, label %1769

1769:
  %1770 = zext i1 %1768 to i32
  %1771 = getelementptr inbounds nuw i32, ptr %1701, i64 %1742
  store i32 %1770, ptr %1771, align 4
  br label %1772

1772:
  %1773 = or i1 %1743, %1768
  %1774 = add nuw nsw i64 %1742, 1
  %1775 = icmp eq i64 %1774, %1737
  br i1 %1775, label %1776, label %1741

1776:
  br i1 %1773, label %1777, label %1822

1777:
  %1778 = getelementptr inbounds double, ptr %1692, i64 %1691
  %1779 = fsub double %1689, %1685
  %1780 = load ptr, ptr %344, align 8
  %1781 = load double, ptr %1780, align 8
  %1782 = fadd double %1779, %1781
  store double %1782, ptr %1780, align 8
  %1783 = fadd double %1685, %1689
  %1784 = fmul double %1783, 5.000000e-01
  %1785 = tail call fastcc i32 @act(ptr noundef nonnull %0, ptr noundef nonnull %1, ptr noundef nonnull %1780, double noundef %1784, ptr noundef %1701, ptr nonnull %1778, ptr %1699)
  %1786 = load ptr, ptr %344, align 8
  store double %1697, ptr %1786, align 8
  %1787 = icmp eq i32 %1785, 0
  br i1 %1787, label %1822, label %1788

1788:
  %1789 = phi double [ %1403, %1671 ], [ %1683, %1777 ]
  %1790 = load ptr, ptr %1, align 8
  %1791 = load i64, ptr %0, align 8
  %1792 = getelementptr inbounds double, ptr %1790, i64 %1791
  %1793 = load double, ptr %1792, align 8
  %1794 = load double, ptr %17, align 8
  %1795 = fmul double %422, %1794
  %1796 = fadd double %1793, %1795
  %1797 = fsub double %1789, %1796
  %1798 = fadd double %1793, %1797
  br label %1825

1799:
  %1800 = load i64, ptr %396, align 8
  %1801 = sitofp i64 %1800 to double
  %1802 = fmul double %1801, 0x3CC0000000000000
  %1803 = fsub double 1.000000e+00, %1802
  %1804 = fmul double %429, %1803
  %1805 = load i64, ptr %397, align 8
  %1806 = getelementptr inbounds double, ptr %345, i64 %1805
  store double %427, ptr %1806, align 8
  %1807 = load i64, ptr %398, align 8
  %1808 = getelementptr inbounds double, ptr %345, i64 %1807
  store double %1804, ptr %1808, align 8
  %1809 = load double, ptr %17, align 8
  %1810 = fdiv double %1804, %1809
  %1811 = load i64, ptr %399, align 8
  %1812 = getelementptr inbounds double, ptr %345, i64 %1811
  store double %1810, ptr %1812, align 8
  %1813 = load ptr, ptr %400, align 8
  %1814 = load ptr, ptr %401, align 8
  %1815 = load ptr, ptr %402, align 8
  tail call void %1813(ptr noundef %345, ptr noundef %1814, ptr noundef %1815)
  %1816 = load ptr, ptr %403, align 8
  %1817 = load i64, ptr %404, align 8
  %1818 = getelementptr inbounds double, ptr %345, i64 %1817
  %1819 = load ptr, ptr %402, align 8
  tail call void %1816(ptr noundef %345, ptr noundef %1818, ptr noundef %1819, i64 noundef 1)
  %1820 = load i64, ptr %369, align 8
  %1821 = getelementptr inbounds double, ptr %345, i64 %1820
  store double %1804, ptr %1821, align 8
  br label %1822

1822:
  %1823 = add nuw nsw i64 %425, 1
  %1824 = icmp eq i64 %1823, %423
  br i1 %1824, label %1825, label %424

1825:
  %1826 = phi double [ %339, %388 ], [ %1798, %1788 ], [ %339, %1822 ]
  %1827 = phi double [ %337, %388 ], [ %1789, %1788 ], [ %337, %1822 ]
  %1828 = getelementptr inbounds nuw i8, ptr %0, i64 264
  %1829 = load i64, ptr %1828, align 8
  %1830 = getelementptr inbounds double, ptr %345, i64 %1829
  store double %1827, ptr %1830, align 8
  %1831 = getelementptr inbounds nuw i8, ptr %0, i64 272
  %1832 = load i64, ptr %1831, align 8
  %1833 = getelementptr inbounds double, ptr %345, i64 %1832
  store double %1826, ptr %1833, align 8
  %1834 = getelementptr inbounds nuw i8, ptr %0, i64 416
  %1835 = load ptr, ptr %1834, align 8
  %1836 = getelementptr inbounds nuw i8, ptr %1, i64 48
  %1837 = load ptr, ptr %1836, align 8
  %1838 = getelementptr inbounds nuw i8, ptr %1, i64 8
  %1839 = load ptr, ptr %1838, align 8
  tail call void %1835(ptr noundef %345, ptr noundef %1837, ptr noundef %1839)
  %1840 = load ptr, ptr %1, align 8
  %1841 = load i64, ptr %0, align 8
  %1842 = shl i64 %1841, 3
  tail call void @llvm.memcpy.p0.p0.i64(ptr align 8 %1840, ptr align 8 %345, i64 %1842, i1 false)
  br label %1861

1843:
  %1844 = load ptr, ptr %1, align 8
  %1845 = load double, ptr %1844, align 8
  %1846 = load i64, ptr %0, align 8
  %1847 = getelementptr inbounds double, ptr %1844, i64 %1846
  %1848 = load double, ptr %1847, align 8
  %1849 = fcmp une double %1845, %1848
  %1850 = getelementptr inbounds nuw i8, ptr %0, i64 400
  %1851 = load ptr, ptr %1850, align 8
  %1852 = getelementptr inbounds nuw i8, ptr %1, i64 128
  %1853 = load ptr, ptr %1852, align 8
  %1854 = getelementptr inbounds nuw i8, ptr %1, i64 8
  %1855 = load ptr, ptr %1854, align 8
  tail call void %1851(ptr noundef nonnull %1844, ptr noundef %1853, ptr noundef %1855, i64 noundef 1)
  br i1 %1849, label %1856, label %1861

1856:
  %1857 = load ptr, ptr %1, align 8
  %1858 = load i64, ptr %0, align 8
  %1859 = getelementptr inbounds double, ptr %1857, i64 %1858
  %1860 = load double, ptr %1859, align 8
  store double %1860, ptr %1857, align 8
  br label %1861

1861:
  ret void
}

declare double @llvm.floor.f64(double)

define internal fastcc ptr @set_out(ptr noundef readonly captures(none) %0, ptr noundef nonnull readonly captures(none) %1, ptr noundef readonly captures(none) %2, double noundef %3, double noundef %4) unnamed_addr {
  %6 = getelementptr inbounds nuw i8, ptr %1, i64 32
  %7 = load ptr, ptr %6, align 8
  %8 = getelementptr inbounds nuw i8, ptr %0, i64 8
  %9 = load i64, ptr %8, align 8
  %10 = shl i64 %9, 3
  tail call void @llvm.memcpy.p0.p0.i64(ptr align 8 %7, ptr align 8 %2, i64 %10, i1 false)
  %11 = getelementptr inbounds nuw i8, ptr %0, i64 200
  %12 = load i64, ptr %11, align 8
  %13 = getelementptr inbounds double, ptr %2, i64 %12
  %14 = load double, ptr %13, align 8
  %15 = load i64, ptr %8, align 8
  %16 = getelementptr inbounds double, ptr %7, i64 %15
  store double %14, ptr %16, align 8
  %17 = getelementptr i8, ptr %16, i64 8
  store double %3, ptr %17, align 8
  %18 = getelementptr i8, ptr %16, i64 16
  store double %4, ptr %18, align 8
  %19 = getelementptr inbounds nuw i8, ptr %16, i64 24
  %20 = getelementptr inbounds nuw i8, ptr %0, i64 248
  %21 = load i64, ptr %20, align 8
  %22 = getelementptr inbounds double, ptr %2, i64 %21
  %23 = getelementptr inbounds nuw i8, ptr %0, i64 48
  %24 = load i64, ptr %23, align 8
  %25 = shl i64 %24, 3
  tail call void @llvm.memcpy.p0.p0.i64(ptr nonnull align 8 %19, ptr align 8 %22, i64 %25, i1 false)
  %26 = load i64, ptr %8, align 8
  %27 = getelementptr inbounds double, ptr %7, i64 %26
  %28 = getelementptr inbounds nuw i8, ptr %27, i64 24
  %29 = load i64, ptr %23, align 8
  %30 = getelementptr inbounds double, ptr %28, i64 %29
  %31 = getelementptr inbounds nuw i8, ptr %0, i64 256
  %32 = load i64, ptr %31, align 8
  %33 = getelementptr inbounds double, ptr %2, i64 %32
  %34 = getelementptr inbounds nuw i8, ptr %0, i64 88
  %35 = load i64, ptr %34, align 8
  %36 = shl i64 %35, 3
  tail call void @llvm.memcpy.p0.p0.i64(ptr nonnull align 8 %30, ptr align 8 %33, i64 %36, i1 false)
  %37 = getelementptr inbounds nuw i8, ptr %0, i64 424
  %38 = load ptr, ptr %37, align 8
  %39 = getelementptr inbounds nuw i8, ptr %1, i64 136
  %40 = load double, ptr %39, align 8
  %41 = getelementptr inbounds nuw i8, ptr %1, i64 56
  %42 = load ptr, ptr %41, align 8
  %43 = getelementptr inbounds nuw i8, ptr %1, i64 120
  %44 = load ptr, ptr %43, align 8
  %45 = getelementptr inbounds nuw i8, ptr %0, i64 40
  %46 = load i64, ptr %45, align 8
  %47 = shl i64 %46, 3
  tail call void @llvm.memcpy.p0.p0.i64(ptr align 8 %42, ptr align 8 %44, i64 %47, i1 false)
  %48 = load i64, ptr %45, align 8
  %49 = getelementptr inbounds nuw i8, ptr %0, i64 32
  %50 = load i64, ptr %49, align 8
  %51 = icmp slt i64 %48, %50
  %52 = load ptr, ptr %41, align 8
  br i1 %51, label %53, label %66

53:
  %54 = load ptr, ptr %43, align 8
  %55 = getelementptr inbounds double, ptr %54, i64 %48
  br label %56

56:
  %57 = phi i64 [ %48, %53 ], [ %64, %56 ]
  %58 = getelementptr inbounds double, ptr %54, i64 %57
  %59 = load double, ptr %58, align 8
  %60 = load double, ptr %55, align 8
  %61 = fdiv double %40, %60
  %62 = fmul double %59, %61
  %63 = getelementptr inbounds double, ptr %52, i64 %57
  store double %62, ptr %63, align 8
  %64 = add nsw i64 %57, 1
  %65 = icmp eq i64 %64, %50
  br i1 %65, label %66, label %56

66:
  %67 = getelementptr inbounds nuw i8, ptr %1, i64 8
  %68 = load ptr, ptr %67, align 8
  tail call void %38(ptr noundef nonnull %7, ptr noundef %52, ptr noundef %68)
  %69 = load ptr, ptr %41, align 8
  %70 = load ptr, ptr %43, align 8
  %71 = load i64, ptr %45, align 8
  %72 = shl i64 %71, 3
  tail call void @llvm.memcpy.p0.p0.i64(ptr align 8 %69, ptr align 8 %70, i64 %72, i1 false)
  %73 = load i64, ptr %45, align 8
  %74 = load i64, ptr %49, align 8
  %75 = icmp slt i64 %73, %74
  %76 = load ptr, ptr %41, align 8
  br i1 %75, label %77, label %90

77:
  %78 = load ptr, ptr %43, align 8
  %79 = getelementptr inbounds double, ptr %78, i64 %73
  br label %80

80:
  %81 = phi i64 [ %73, %77 ], [ %88, %80 ]
  %82 = getelementptr inbounds double, ptr %78, i64 %81
  %83 = load double, ptr %82, align 8
  %84 = load double, ptr %79, align 8
  %85 = fdiv double %3, %84
  %86 = fmul double %83, %85
  %87 = getelementptr inbounds double, ptr %76, i64 %81
  store double %86, ptr %87, align 8
  %88 = add nsw i64 %81, 1
  %89 = icmp eq i64 %88, %74
  br i1 %89, label %90, label %80

90:
  ret ptr %76
}

define internal fastcc range(i32 0, 2) i32 @act(ptr noundef %0, ptr noundef nonnull captures(none) initializes((168, 172)) %1, ptr noundef %2, double noundef %3, ptr noundef readonly captures(address_is_null) %4, ptr %5, ptr %6) unnamed_addr {
  %8 = alloca %struct.Room, align 8
  %9 = getelementptr inbounds nuw i8, ptr %0, i64 48
  %10 = load i64, ptr %9, align 8
  %11 = getelementptr double, ptr %5, i64 %10
  %12 = getelementptr i8, ptr %11, i64 8
  %13 = xor i64 %10, -1
  %14 = getelementptr inbounds double, ptr %12, i64 %13
  %15 = getelementptr inbounds nuw i8, ptr %0, i64 80
  %16 = load i64, ptr %15, align 8
  %17 = getelementptr double, ptr %12, i64 %16
  %18 = getelementptr i8, ptr %17, i64 8
  %19 = xor i64 %16, -1
  %20 = getelementptr inbounds double, ptr %18, i64 %19
  %21 = getelementptr inbounds nuw i8, ptr %0, i64 184
  %22 = load i64, ptr %21, align 8
  %23 = icmp slt i64 %22, 0
  %24 = getelementptr inbounds nuw double, ptr %2, i64 %22
  %25 = shl i64 %16, 3
  %26 = add i64 %25, 8
  tail call void @llvm.memset.p0.i64(ptr align 8 %20, i8 0, i64 %26, i1 false)
  %27 = getelementptr inbounds nuw i8, ptr %1, i64 168
  store i32 1, ptr %27, align 8
  %28 = getelementptr inbounds nuw i8, ptr %0, i64 120
  %29 = load i64, ptr %28, align 8
  %30 = getelementptr inbounds double, ptr %2, i64 %29
  %31 = load i64, ptr %9, align 8
  %32 = shl i64 %31, 3
  tail call void @llvm.memcpy.p0.p0.i64(ptr align 8 %14, ptr align 8 %30, i64 %32, i1 false)
  %33 = load i64, ptr %28, align 8
  %34 = getelementptr inbounds double, ptr %2, i64 %33
  %35 = getelementptr inbounds nuw i8, ptr %0, i64 248
  %36 = load i64, ptr %35, align 8
  %37 = getelementptr inbounds double, ptr %2, i64 %36
  %38 = load i64, ptr %9, align 8
  %39 = shl i64 %38, 3
  tail call void @llvm.memcpy.p0.p0.i64(ptr align 8 %34, ptr align 8 %37, i64 %39, i1 false)
  %40 = getelementptr inbounds nuw i8, ptr %1, i64 184
  %41 = load ptr, ptr %40, align 8
  %42 = icmp eq ptr %41, null
  br i1 %42, label %158, label %43

43:
  %44 = getelementptr inbounds nuw i8, ptr %41, i64 16
  %45 = load i64, ptr %44, align 8
  %46 = icmp slt i64 %45, 1
  br i1 %46, label %47, label %49

47:
  %48 = getelementptr inbounds nuw i8, ptr %41, i64 24
  store i64 1, ptr %48, align 8
  br label %158

49:
  %50 = load ptr, ptr %41, align 8
  %51 = getelementptr inbounds nuw i8, ptr %41, i64 8
  %52 = load i64, ptr %51, align 8
  %53 = getelementptr inbounds nuw i8, ptr %0, i64 56
  %54 = load i64, ptr %53, align 8
  %55 = shl nsw i64 %54, 1
  %56 = add nsw i64 %55, 3
  %57 = getelementptr inbounds nuw i8, ptr %0, i64 8
  %58 = load i64, ptr %57, align 8
  %59 = add nsw i64 %56, %58
  %60 = load i64, ptr %9, align 8
  %61 = add nsw i64 %59, %60
  %62 = getelementptr inbounds nuw i8, ptr %0, i64 304
  %63 = load i64, ptr %62, align 8
  %64 = add nsw i64 %61, %63
  %65 = getelementptr inbounds nuw i8, ptr %0, i64 280
  %66 = load i64, ptr %65, align 8
  %67 = icmp sgt i64 %66, 0
  br i1 %67, label %68, label %77

68:
  %69 = mul nuw nsw i64 %66, 5
  %70 = getelementptr inbounds nuw i8, ptr %0, i64 288
  %71 = load i64, ptr %70, align 8
  %72 = add nsw i64 %71, %69
  %73 = getelementptr inbounds nuw i8, ptr %0, i64 320
  %74 = load i64, ptr %73, align 8
  %75 = shl nsw i64 %74, 1
  %76 = add nsw i64 %72, %75
  br label %77

77:
  %78 = phi i64 [ %76, %68 ], [ 0, %49 ]
  %79 = add nsw i64 %64, %78
  %80 = mul nsw i64 %79, %52
  %81 = getelementptr inbounds double, ptr %50, i64 %80
  %82 = add nsw i64 %52, 1
  store i64 %82, ptr %51, align 8
  %83 = add nsw i64 %45, -1
  store i64 %83, ptr %44, align 8
  store double %3, ptr %81, align 8
  %84 = getelementptr inbounds nuw i8, ptr %0, i64 192
  %85 = load i64, ptr %84, align 8
  %86 = getelementptr inbounds double, ptr %2, i64 %85
  %87 = load double, ptr %86, align 8
  %88 = getelementptr inbounds nuw i8, ptr %81, i64 8
  store double %87, ptr %88, align 8
  %89 = getelementptr inbounds nuw i8, ptr %0, i64 200
  %90 = load i64, ptr %89, align 8
  %91 = getelementptr inbounds double, ptr %2, i64 %90
  %92 = load double, ptr %91, align 8
  %93 = getelementptr inbounds nuw i8, ptr %81, i64 16
  store double %92, ptr %93, align 8
  %94 = icmp sgt i64 %54, 0
  br i1 %94, label %95, label %106

95:
  %96 = phi i64 [ %102, %95 ], [ 0, %77 ]
  %97 = getelementptr inbounds nuw i32, ptr %4, i64 %96
  %98 = load i32, ptr %97, align 4
  %99 = sitofp i32 %98 to double
  %100 = getelementptr inbounds nuw double, ptr %81, i64 %96
  %101 = getelementptr inbounds nuw i8, ptr %100, i64 24
  store double %99, ptr %101, align 8
  %102 = add nuw nsw i64 %96, 1
  %103 = icmp eq i64 %102, %54
  br i1 %103, label %104, label %95

104:
  %105 = load double, ptr %91, align 8
  br label %106

106:
  %107 = phi double [ %105, %104 ], [ %92, %77 ]
  %108 = getelementptr inbounds nuw i8, ptr %81, i64 24
  %109 = getelementptr inbounds double, ptr %108, i64 %54
  %110 = getelementptr inbounds nuw i8, ptr %0, i64 432
  %111 = load ptr, ptr %110, align 8
  %112 = getelementptr inbounds nuw i8, ptr %1, i64 56
  %113 = load ptr, ptr %112, align 8
  %114 = getelementptr inbounds nuw i8, ptr %1, i64 120
  %115 = load ptr, ptr %114, align 8
  %116 = getelementptr inbounds nuw i8, ptr %0, i64 40
  %117 = load i64, ptr %116, align 8
  %118 = shl i64 %117, 3
  tail call void @llvm.memcpy.p0.p0.i64(ptr align 8 %113, ptr align 8 %115, i64 %118, i1 false)
  %119 = load i64, ptr %116, align 8
  %120 = getelementptr inbounds nuw i8, ptr %0, i64 32
  %121 = load i64, ptr %120, align 8
  %122 = icmp slt i64 %119, %121
  %123 = load ptr, ptr %112, align 8
  br i1 %122, label %124, label %137

124:
  %125 = load ptr, ptr %114, align 8
  %126 = getelementptr inbounds double, ptr %125, i64 %119
  br label %127

127:
  %128 = phi i64 [ %119, %124 ], [ %135, %127 ]
  %129 = getelementptr inbounds double, ptr %125, i64 %128
  %130 = load double, ptr %129, align 8
  %131 = load double, ptr %126, align 8
  %132 = fdiv double %107, %131
  %133 = fmul double %130, %132
  %134 = getelementptr inbounds double, ptr %123, i64 %128
  store double %133, ptr %134, align 8
  %135 = add nsw i64 %128, 1
  %136 = icmp eq i64 %135, %121
  br i1 %136, label %137, label %127

137:
  %138 = getelementptr inbounds nuw i8, ptr %1, i64 8
  %139 = load ptr, ptr %138, align 8
  tail call void %111(ptr noundef nonnull %109, ptr noundef nonnull %2, ptr noundef %123, ptr noundef %139)
  %140 = load i64, ptr %53, align 8
  %141 = shl nsw i64 %140, 4
  %142 = getelementptr inbounds i8, ptr %108, i64 %141
  %143 = load i64, ptr %57, align 8
  %144 = shl i64 %143, 3
  tail call void @llvm.memcpy.p0.p0.i64(ptr nonnull align 8 %142, ptr nonnull align 8 %2, i64 %144, i1 false)
  %145 = load i64, ptr %53, align 8
  %146 = shl nsw i64 %145, 4
  %147 = getelementptr inbounds i8, ptr %108, i64 %146
  %148 = load i64, ptr %57, align 8
  %149 = getelementptr inbounds double, ptr %147, i64 %148
  %150 = load i64, ptr %9, align 8
  %151 = getelementptr inbounds double, ptr %149, i64 %150
  %152 = load i64, ptr %62, align 8
  %153 = shl i64 %152, 3
  tail call void @llvm.memset.p0.i64(ptr nonnull align 8 %151, i8 0, i64 %153, i1 false)
  %154 = load i64, ptr %9, align 8
  %155 = getelementptr inbounds double, ptr %149, i64 %154
  %156 = load i64, ptr %62, align 8
  %157 = getelementptr inbounds double, ptr %155, i64 %156
  br label %158

158:
  %159 = phi i1 [ false, %137 ], [ true, %47 ], [ true, %7 ]
  %160 = phi ptr [ %149, %137 ], [ null, %47 ], [ null, %7 ]
  %161 = phi ptr [ %157, %137 ], [ null, %47 ], [ null, %7 ]
  %162 = load i64, ptr %15, align 8
  %163 = icmp sgt i64 %162, 0
  br i1 %163, label %164, label %199

164:
  %165 = getelementptr inbounds nuw i8, ptr %0, i64 448
  %166 = load ptr, ptr %165, align 8
  %167 = getelementptr inbounds nuw i8, ptr %0, i64 200
  %168 = load i64, ptr %167, align 8
  %169 = getelementptr inbounds double, ptr %2, i64 %168
  %170 = load double, ptr %169, align 8
  %171 = getelementptr inbounds nuw i8, ptr %1, i64 56
  %172 = load ptr, ptr %171, align 8
  %173 = getelementptr inbounds nuw i8, ptr %1, i64 120
  %174 = load ptr, ptr %173, align 8
  %175 = getelementptr inbounds nuw i8, ptr %0, i64 40
  %176 = load i64, ptr %175, align 8
  %177 = shl i64 %176, 3
  tail call void @llvm.memcpy.p0.p0.i64(ptr align 8 %172, ptr align 8 %174, i64 %177, i1 false)
  %178 = load i64, ptr %175, align 8
  %179 = getelementptr inbounds nuw i8, ptr %0, i64 32
  %180 = load i64, ptr %179, align 8
  %181 = icmp slt i64 %178, %180
  %182 = load ptr, ptr %171, align 8
  br i1 %181, label %183, label %196

183:
  %184 = load ptr, ptr %173, align 8
  %185 = getelementptr inbounds double, ptr %184, i64 %178
  br label %186

186:
  %187 = phi i64 [ %178, %183 ], [ %194, %186 ]
  %188 = getelementptr inbounds double, ptr %184, i64 %187
  %189 = load double, ptr %188, align 8
  %190 = load double, ptr %185, align 8
  %191 = fdiv double %170, %190
  %192 = fmul double %189, %191
  %193 = getelementptr inbounds double, ptr %182, i64 %187
  store double %192, ptr %193, align 8
  %194 = add nsw i64 %187, 1
  %195 = icmp eq i64 %194, %180
  br i1 %195, label %196, label %186

196:
  %197 = getelementptr inbounds nuw i8, ptr %1, i64 8
  %198 = load ptr, ptr %197, align 8
  tail call void %166(ptr noundef %20, ptr noundef nonnull %2, ptr noundef %182, ptr noundef %198)
  br label %199

199:
  %200 = getelementptr inbounds nuw i8, ptr %0, i64 56
  %201 = load i64, ptr %200, align 8
  %202 = icmp sgt i64 %201, 0
  br i1 %202, label %203, label %369

203:
  %204 = icmp eq ptr %2, null
  %205 = or i1 %204, %23
  %206 = getelementptr inbounds nuw i8, ptr %0, i64 360
  %207 = getelementptr inbounds nuw i8, ptr %0, i64 64
  %208 = getelementptr inbounds nuw i8, ptr %1, i64 136
  %209 = getelementptr inbounds nuw i8, ptr %0, i64 368
  %210 = getelementptr inbounds nuw i8, ptr %1, i64 160
  %211 = getelementptr inbounds nuw i8, ptr %0, i64 280
  %212 = getelementptr inbounds nuw i8, ptr %0, i64 392
  br label %213

213:
  %214 = phi i64 [ 0, %203 ], [ %366, %365 ]
  %215 = getelementptr inbounds nuw i32, ptr %4, i64 %214
  %216 = load i32, ptr %215, align 4
  %217 = icmp eq i32 %216, 0
  br i1 %217, label %365, label %218

218:
  br i1 %205, label %228, label %219

219:
  %220 = load ptr, ptr %206, align 8
  %221 = getelementptr inbounds nuw %struct.Event, ptr %220, i64 %214
  %222 = getelementptr inbounds nuw i8, ptr %221, i64 16
  %223 = load double, ptr %222, align 8
  %224 = fcmp ogt double %223, 0.000000e+00
  %225 = fadd double %3, %223
  %226 = select i1 %224, double %225, double -1.000000e+300
  %227 = getelementptr inbounds nuw double, ptr %24, i64 %214
  store double %226, ptr %227, align 8
  br label %228

228:
  %229 = load i64, ptr %207, align 8
  %230 = icmp sgt i64 %229, %214
  br i1 %230, label %293, label %231

231:
  %232 = load ptr, ptr %1, align 8
  %233 = load i64, ptr %0, align 8
  %234 = getelementptr double, ptr %232, i64 %233
  %235 = getelementptr i8, ptr %234, i64 16
  %236 = sub nsw i64 %214, %229
  %237 = mul nuw nsw i64 %236, 176
  %238 = getelementptr inbounds nuw i8, ptr %235, i64 %237
  %239 = getelementptr inbounds nuw i8, ptr %238, i64 16
  %240 = load double, ptr %234, align 8
  %241 = fsub double %3, %240
  %242 = load double, ptr %208, align 8
  %243 = fdiv double %241, %242
  %244 = fadd double %243, -1.000000e-09
  %245 = tail call double @llvm.ceil.f64(double %244)
  %246 = getelementptr inbounds nuw i8, ptr %238, i64 8
  %247 = load double, ptr %246, align 8
  %248 = fcmp oeq double %247, 2.000000e+01
  br i1 %248, label %249, label %251

249:
  %250 = getelementptr inbounds nuw i8, ptr %238, i64 24
  tail call void @llvm.memmove.p0.p0.i64(ptr noundef nonnull align 8 dereferenceable(152) %239, ptr noundef nonnull align 8 dereferenceable(152) %250, i64 152, i1 false)
  br label %255

251:
  %252 = fadd double %247, 1.000000e+00
  store double %252, ptr %246, align 8
  %253 = fptosi double %252 to i32
  %254 = sext i32 %253 to i64
  br label %255

255:
  %256 = phi i64 [ %254, %251 ], [ 20, %249 ]
  %257 = getelementptr double, ptr %239, i64 %256
  %258 = getelementptr i8, ptr %257, i64 -8
  store double %245, ptr %258, align 8
  %259 = load double, ptr %246, align 8
  %260 = fcmp oeq double %259, 2.000000e+01
  br i1 %260, label %261, label %365

261:
  %262 = load double, ptr %239, align 8
  %263 = fsub double %245, %262
  %264 = fcmp olt double %263, 6.000000e+01
  br i1 %264, label %265, label %365

265:
  %266 = load double, ptr %238, align 8
  %267 = fptosi double %266 to i32
  %268 = icmp sgt i32 %267, 0
  br i1 %268, label %269, label %277

269:
  %270 = phi i32 [ %272, %269 ], [ %267, %265 ]
  %271 = phi double [ %273, %269 ], [ 1.000000e+00, %265 ]
  %272 = add nsw i32 %270, -1
  %273 = fmul double %271, 2.000000e+00
  %274 = icmp samesign ugt i32 %270, 1
  br i1 %274, label %269, label %275

275:
  %276 = fadd double %273, -1.000000e+00
  br label %277

277:
  %278 = phi double [ 0.000000e+00, %265 ], [ %276, %275 ]
  %279 = load ptr, ptr %1, align 8
  %280 = load i64, ptr %0, align 8
  %281 = getelementptr inbounds double, ptr %279, i64 %280
  %282 = load double, ptr %281, align 8
  %283 = load double, ptr %208, align 8
  %284 = fmul double %245, %283
  %285 = fadd double %282, %284
  %286 = fmul double %278, %283
  %287 = fadd double %286, %285
  %288 = load i64, ptr %21, align 8
  %289 = getelementptr inbounds nuw double, ptr %2, i64 %288
  %290 = getelementptr inbounds nuw double, ptr %289, i64 %214
  store double %287, ptr %290, align 8
  %291 = load double, ptr %238, align 8
  %292 = fadd double %291, 1.000000e+00
  store double %292, ptr %238, align 8
  store double 0.000000e+00, ptr %246, align 8
  br label %365

293:
  %294 = load ptr, ptr %206, align 8
  %295 = getelementptr inbounds nuw %struct.Event, ptr %294, i64 %214
  %296 = getelementptr inbounds nuw i8, ptr %295, i64 8
  %297 = load i32, ptr %296, align 8
  %298 = getelementptr inbounds nuw i8, ptr %295, i64 12
  %299 = load i32, ptr %298, align 4
  %300 = icmp slt i32 %297, %299
  br i1 %300, label %301, label %327

301:
  %302 = load i64, ptr %28, align 8
  %303 = load ptr, ptr %209, align 8
  %304 = getelementptr double, ptr %2, i64 %302
  %305 = sext i32 %297 to i64
  %306 = sext i32 %299 to i64
  br label %307

307:
  %308 = phi i64 [ %305, %301 ], [ %325, %319 ]
  %309 = getelementptr inbounds double, ptr %20, i64 %308
  %310 = load double, ptr %309, align 8
  %311 = fsub double %310, %310
  %312 = fcmp oeq double %311, 0.000000e+00
  br i1 %312, label %319, label %313

313:
  %314 = load ptr, ptr %1, align 8
  %315 = load i64, ptr %0, align 8
  %316 = getelementptr double, ptr %314, i64 %315
  %317 = getelementptr i8, ptr %316, i64 8
  store double 4.000000e+00, ptr %317, align 8
  %318 = load double, ptr %309, align 8
  br label %319

319:
  %320 = phi double [ %318, %313 ], [ %310, %307 ]
  %321 = getelementptr inbounds i32, ptr %303, i64 %308
  %322 = load i32, ptr %321, align 4
  %323 = sext i32 %322 to i64
  %324 = getelementptr double, ptr %304, i64 %323
  store double %320, ptr %324, align 8
  %325 = add nsw i64 %308, 1
  %326 = icmp eq i64 %325, %306
  br i1 %326, label %327, label %307

327:
  %328 = getelementptr inbounds nuw i8, ptr %295, i64 4
  %329 = load i32, ptr %328, align 4
  %330 = icmp eq i32 %329, 0
  br i1 %330, label %339, label %331

331:
  %332 = load ptr, ptr %1, align 8
  %333 = load i64, ptr %0, align 8
  %334 = getelementptr double, ptr %332, i64 %333
  %335 = getelementptr i8, ptr %334, i64 8
  %336 = load double, ptr %335, align 8
  %337 = fcmp oeq double %336, 0.000000e+00
  br i1 %337, label %338, label %339

338:
  store double 1.000000e+00, ptr %335, align 8
  br label %339

339:
  %340 = load ptr, ptr %210, align 8
  %341 = getelementptr inbounds nuw i32, ptr %340, i64 %214
  %342 = load i32, ptr %341, align 4
  %343 = add nsw i32 %342, 1
  store i32 %343, ptr %341, align 4
  %344 = load i64, ptr %211, align 8
  %345 = sub nsw i64 %229, %344
  %346 = icmp sgt i64 %345, %214
  br i1 %346, label %354, label %347

347:
  %348 = load ptr, ptr %212, align 8
  %349 = sub nsw i64 %214, %345
  %350 = getelementptr inbounds nuw i32, ptr %348, i64 %349
  %351 = load i32, ptr %350, align 4
  %352 = icmp eq i32 %351, 0
  %353 = select i1 %352, i32 50, i32 20000
  br label %354

354:
  %355 = phi i32 [ 50, %339 ], [ %353, %347 ]
  %356 = icmp slt i32 %343, %355
  br i1 %356, label %365, label %357

357:
  %358 = load ptr, ptr %1, align 8
  %359 = load i64, ptr %0, align 8
  %360 = getelementptr double, ptr %358, i64 %359
  %361 = getelementptr i8, ptr %360, i64 8
  %362 = load double, ptr %361, align 8
  %363 = fcmp oeq double %362, 0.000000e+00
  br i1 %363, label %364, label %365

364:
  store double 2.000000e+00, ptr %361, align 8
  br label %365

365:
  %366 = add nuw nsw i64 %214, 1
  %367 = load i64, ptr %200, align 8
  %368 = icmp sgt i64 %367, %366
  br i1 %368, label %213, label %369

369:
  %370 = getelementptr inbounds nuw i8, ptr %0, i64 280
  %371 = load i64, ptr %370, align 8
  %372 = icmp sgt i64 %371, 0
  br i1 %372, label %373, label %596

373:
  %374 = load ptr, ptr %1, align 8
  %375 = load i64, ptr %0, align 8
  %376 = getelementptr double, ptr %374, i64 %375
  %377 = getelementptr i8, ptr %376, i64 8
  %378 = load double, ptr %377, align 8
  %379 = fcmp oeq double %378, 0.000000e+00
  br i1 %379, label %380, label %596

380:
  %381 = getelementptr inbounds nuw i8, ptr %0, i64 304
  %382 = load i64, ptr %381, align 8
  %383 = getelementptr inbounds double, ptr %18, i64 %382
  %384 = load i64, ptr %28, align 8
  %385 = getelementptr inbounds double, ptr %2, i64 %384
  %386 = getelementptr inbounds nuw i8, ptr %0, i64 200
  %387 = load i64, ptr %386, align 8
  %388 = getelementptr inbounds double, ptr %2, i64 %387
  %389 = load double, ptr %388, align 8
  %390 = getelementptr inbounds nuw i8, ptr %1, i64 56
  %391 = load ptr, ptr %390, align 8
  %392 = getelementptr inbounds nuw i8, ptr %1, i64 120
  %393 = load ptr, ptr %392, align 8
  %394 = getelementptr inbounds nuw i8, ptr %0, i64 40
  %395 = load i64, ptr %394, align 8
  %396 = shl i64 %395, 3
  tail call void @llvm.memcpy.p0.p0.i64(ptr align 8 %391, ptr align 8 %393, i64 %396, i1 false)
  %397 = load i64, ptr %394, align 8
  %398 = getelementptr inbounds nuw i8, ptr %0, i64 32
  %399 = load i64, ptr %398, align 8
  %400 = icmp slt i64 %397, %399
  %401 = load ptr, ptr %390, align 8
  br i1 %400, label %402, label %415

402:
  %403 = load ptr, ptr %392, align 8
  %404 = getelementptr inbounds double, ptr %403, i64 %397
  br label %405

405:
  %406 = phi i64 [ %397, %402 ], [ %413, %405 ]
  %407 = getelementptr inbounds double, ptr %403, i64 %406
  %408 = load double, ptr %407, align 8
  %409 = load double, ptr %404, align 8
  %410 = fdiv double %389, %409
  %411 = fmul double %408, %410
  %412 = getelementptr inbounds double, ptr %401, i64 %406
  store double %411, ptr %412, align 8
  %413 = add nsw i64 %406, 1
  %414 = icmp eq i64 %413, %399
  br i1 %414, label %415, label %405

415:
  %416 = getelementptr inbounds nuw i8, ptr %0, i64 64
  %417 = load i64, ptr %416, align 8
  %418 = getelementptr inbounds i32, ptr %4, i64 %417
  %419 = load i64, ptr %370, align 8
  %420 = sub i64 0, %419
  %421 = getelementptr inbounds i32, ptr %418, i64 %420
  %422 = getelementptr inbounds nuw i8, ptr %8, i64 8
  store ptr %6, ptr %422, align 8
  %423 = getelementptr inbounds nuw i8, ptr %1, i64 72
  %424 = load ptr, ptr %423, align 8
  %425 = load i64, ptr %381, align 8
  %426 = getelementptr inbounds double, ptr %424, i64 %425
  %427 = getelementptr inbounds nuw i8, ptr %0, i64 312
  %428 = load i64, ptr %427, align 8
  %429 = getelementptr inbounds double, ptr %426, i64 %428
  %430 = load i64, ptr %200, align 8
  %431 = getelementptr double, ptr %383, i64 %430
  %432 = getelementptr i8, ptr %431, i64 8
  %433 = xor i64 %430, -1
  %434 = getelementptr inbounds double, ptr %432, i64 %433
  %435 = getelementptr inbounds double, ptr %432, i64 %425
  %436 = getelementptr inbounds double, ptr %435, i64 %419
  store ptr %436, ptr %8, align 8
  %437 = shl i64 %419, 3
  tail call void @llvm.memset.p0.i64(ptr align 8 %435, i8 0, i64 %437, i1 false)
  %438 = getelementptr inbounds nuw i8, ptr %0, i64 464
  %439 = load ptr, ptr %438, align 8
  %440 = getelementptr inbounds nuw i8, ptr %1, i64 8
  %441 = load ptr, ptr %440, align 8
  tail call void %439(ptr noundef %424, ptr noundef nonnull %2, ptr noundef %401, ptr noundef %441)
  %442 = load i64, ptr %381, align 8
  %443 = shl i64 %442, 3
  tail call void @llvm.memcpy.p0.p0.i64(ptr align 8 %432, ptr align 8 %429, i64 %443, i1 false)
  %444 = icmp eq ptr %4, null
  br i1 %444, label %478, label %445

445:
  %446 = getelementptr inbounds nuw i8, ptr %0, i64 440
  %447 = load ptr, ptr %446, align 8
  %448 = load ptr, ptr %440, align 8
  tail call void %447(ptr noundef %434, ptr noundef nonnull %2, ptr noundef %401, ptr noundef %448)
  %449 = load i64, ptr %370, align 8
  %450 = icmp sgt i64 %449, 0
  br i1 %450, label %451, label %478

451:
  %452 = getelementptr inbounds nuw i8, ptr %0, i64 376
  br label %453

453:
  %454 = phi i64 [ 0, %451 ], [ %476, %475 ]
  %455 = getelementptr inbounds nuw i32, ptr %421, i64 %454
  %456 = load i32, ptr %455, align 4
  %457 = icmp eq i32 %456, 0
  br i1 %457, label %475, label %458

458:
  %459 = load ptr, ptr %452, align 8
  %460 = getelementptr inbounds nuw i32, ptr %459, i64 %454
  %461 = load i32, ptr %460, align 4
  %462 = sext i32 %461 to i64
  %463 = getelementptr inbounds double, ptr %385, i64 %462
  %464 = load double, ptr %463, align 8
  %465 = fcmp une double %464, 0.000000e+00
  br i1 %465, label %466, label %475

466:
  %467 = load i64, ptr %416, align 8
  %468 = sub nsw i64 %467, %449
  %469 = getelementptr double, ptr %434, i64 %468
  %470 = getelementptr double, ptr %469, i64 %454
  %471 = load double, ptr %470, align 8
  %472 = tail call double @llvm.fabs.f64(double %471)
  %473 = fmul double %472, 0x3DA5FD7FE1796495
  %474 = getelementptr inbounds nuw double, ptr %435, i64 %454
  store double %473, ptr %474, align 8
  br label %475

475:
  %476 = add nuw nsw i64 %454, 1
  %477 = icmp eq i64 %476, %449
  br i1 %477, label %478, label %453

478:
  %479 = icmp eq ptr %161, null
  br i1 %479, label %498, label %480

480:
  %481 = load i64, ptr %370, align 8
  %482 = mul nsw i64 %481, 5
  %483 = getelementptr inbounds nuw i8, ptr %0, i64 288
  %484 = load i64, ptr %483, align 8
  %485 = add nsw i64 %482, %484
  %486 = getelementptr inbounds nuw i8, ptr %0, i64 320
  %487 = load i64, ptr %486, align 8
  %488 = shl i64 %487, 4
  %489 = shl i64 %485, 3
  %490 = add i64 %488, %489
  tail call void @llvm.memset.p0.i64(ptr nonnull align 8 %161, i8 0, i64 %490, i1 false)
  %491 = load i64, ptr %370, align 8
  %492 = load i64, ptr %483, align 8
  %493 = mul i64 %491, 40
  %494 = getelementptr i8, ptr %161, i64 %493
  %495 = getelementptr double, ptr %494, i64 %492
  %496 = load i64, ptr %486, align 8
  %497 = shl i64 %496, 3
  tail call void @llvm.memcpy.p0.p0.i64(ptr align 8 %495, ptr align 8 %424, i64 %497, i1 false)
  br label %498

498:
  %499 = load ptr, ptr %392, align 8
  %500 = getelementptr inbounds nuw i8, ptr %0, i64 320
  %501 = load i64, ptr %500, align 8
  %502 = getelementptr inbounds double, ptr %424, i64 %501
  %503 = load ptr, ptr %440, align 8
  %504 = tail call fastcc i32 @decide(ptr noundef nonnull %0, ptr noundef %424, ptr noundef nonnull %385, ptr noundef %499, ptr noundef readonly %421, ptr noundef %435, ptr noundef %502, ptr noundef %503, ptr noundef %161, ptr noundef nonnull byval(%struct.Room) align 8 %8)
  %505 = icmp eq i32 %504, 0
  br i1 %505, label %506, label %511

506:
  %507 = load ptr, ptr %1, align 8
  %508 = load i64, ptr %0, align 8
  %509 = getelementptr double, ptr %507, i64 %508
  %510 = getelementptr i8, ptr %509, i64 8
  store double 3.000000e+00, ptr %510, align 8
  br label %511

511:
  %512 = load i64, ptr %381, align 8
  %513 = icmp sgt i64 %512, 0
  br i1 %513, label %514, label %524

514:
  %515 = phi i64 [ %522, %514 ], [ 0, %511 ]
  %516 = getelementptr inbounds nuw double, ptr %429, i64 %515
  %517 = load double, ptr %516, align 8
  %518 = getelementptr inbounds nuw double, ptr %432, i64 %515
  %519 = load double, ptr %518, align 8
  %520 = fsub double %517, %519
  %521 = getelementptr inbounds nuw double, ptr %18, i64 %515
  store double %520, ptr %521, align 8
  %522 = add nuw nsw i64 %515, 1
  %523 = icmp eq i64 %522, %512
  br i1 %523, label %524, label %514

524:
  br i1 %479, label %575, label %525

525:
  %526 = getelementptr inbounds nuw i8, ptr %0, i64 288
  %527 = load i64, ptr %526, align 8
  %528 = icmp sgt i64 %527, 0
  %529 = load i64, ptr %370, align 8
  br i1 %528, label %532, label %530

530:
  %531 = mul i64 %529, 40
  br label %567

532:
  %533 = trunc i64 %512 to i32
  %534 = icmp sgt i32 %533, 0
  %535 = shl i64 %527, 32
  %536 = ashr exact i64 %535, 32
  %537 = and i64 %512, 2147483647
  %538 = mul i64 %529, 40
  %539 = getelementptr i8, ptr %161, i64 %538
  br label %540

540:
  %541 = phi i64 [ 0, %532 ], [ %565, %560 ]
  br i1 %534, label %542, label %560

542:
  %543 = load i64, ptr %500, align 8
  %544 = getelementptr inbounds double, ptr %424, i64 %543
  %545 = getelementptr double, ptr %544, i64 %541
  br label %546

546:
  %547 = phi i64 [ 0, %542 ], [ %556, %546 ]
  %548 = phi double [ 0.000000e+00, %542 ], [ %555, %546 ]
  %549 = mul nsw i64 %547, %536
  %550 = getelementptr double, ptr %545, i64 %549
  %551 = load double, ptr %550, align 8
  %552 = getelementptr inbounds nuw double, ptr %18, i64 %547
  %553 = load double, ptr %552, align 8
  %554 = fmul double %551, %553
  %555 = fadd double %548, %554
  %556 = add nuw nsw i64 %547, 1
  %557 = icmp eq i64 %556, %537
  br i1 %557, label %558, label %546

558:
  %559 = fmul double %555, 5.000000e-01
  br label %560

560:
  %561 = phi double [ 0.000000e+00, %540 ], [ %559, %558 ]
  %562 = getelementptr double, ptr %539, i64 %541
  %563 = load double, ptr %562, align 8
  %564 = fadd double %561, %563
  store double %564, ptr %562, align 8
  %565 = add nuw nsw i64 %541, 1
  %566 = icmp eq i64 %565, %527
  br i1 %566, label %567, label %540

567:
  %568 = phi i64 [ %531, %530 ], [ %538, %560 ]
  %569 = getelementptr i8, ptr %161, i64 %568
  %570 = getelementptr double, ptr %569, i64 %527
  %571 = load i64, ptr %500, align 8
  %572 = getelementptr inbounds double, ptr %570, i64 %571
  %573 = shl i64 %571, 3
  tail call void @llvm.memcpy.p0.p0.i64(ptr align 8 %572, ptr align 8 %424, i64 %573, i1 false)
  %574 = load i64, ptr %381, align 8
  br label %575

575:
  %576 = phi i64 [ %512, %524 ], [ %574, %567 ]
  %577 = icmp sgt i64 %576, 0
  br i1 %577, label %578, label %591

578:
  %579 = getelementptr inbounds nuw i8, ptr %0, i64 256
  %580 = load i64, ptr %579, align 8
  %581 = getelementptr double, ptr %2, i64 %580
  br label %582

582:
  %583 = phi i64 [ 0, %578 ], [ %589, %582 ]
  %584 = getelementptr inbounds nuw double, ptr %18, i64 %583
  %585 = load double, ptr %584, align 8
  %586 = getelementptr double, ptr %581, i64 %583
  %587 = load double, ptr %586, align 8
  %588 = fadd double %585, %587
  store double %588, ptr %586, align 8
  %589 = add nuw nsw i64 %583, 1
  %590 = icmp eq i64 %589, %576
  br i1 %590, label %591, label %582

591:
  br i1 %159, label %602, label %592

592:
  %593 = load i64, ptr %9, align 8
  %594 = getelementptr inbounds double, ptr %160, i64 %593
  %595 = shl i64 %576, 3
  tail call void @llvm.memcpy.p0.p0.i64(ptr nonnull align 8 %594, ptr align 8 %18, i64 %595, i1 false)
  br label %597

596:
  br i1 %159, label %602, label %597

597:
  %598 = load i64, ptr %28, align 8
  %599 = getelementptr inbounds double, ptr %2, i64 %598
  %600 = load i64, ptr %9, align 8
  %601 = shl i64 %600, 3
  tail call void @llvm.memcpy.p0.p0.i64(ptr nonnull align 8 %160, ptr align 8 %599, i64 %601, i1 false)
  br label %602

602:
  %603 = load i64, ptr %9, align 8
  %604 = icmp sgt i64 %603, 0
  br i1 %604, label %605, label %619

605:
  %606 = load i64, ptr %28, align 8
  %607 = getelementptr double, ptr %2, i64 %606
  %608 = load i64, ptr %35, align 8
  %609 = getelementptr double, ptr %2, i64 %608
  br label %610

610:
  %611 = phi i64 [ 0, %605 ], [ %617, %610 ]
  %612 = getelementptr double, ptr %607, i64 %611
  %613 = load double, ptr %612, align 8
  %614 = getelementptr double, ptr %609, i64 %611
  store double %613, ptr %614, align 8
  %615 = getelementptr inbounds nuw double, ptr %14, i64 %611
  %616 = load double, ptr %615, align 8
  store double %616, ptr %612, align 8
  %617 = add nuw nsw i64 %611, 1
  %618 = icmp eq i64 %617, %603
  br i1 %618, label %619, label %610

619:
  %620 = load ptr, ptr %1, align 8
  %621 = load i64, ptr %0, align 8
  %622 = getelementptr double, ptr %620, i64 %621
  %623 = getelementptr i8, ptr %622, i64 8
  %624 = load double, ptr %623, align 8
  %625 = fcmp une double %624, 0.000000e+00
  %626 = zext i1 %625 to i32
  ret i32 %626
}

define internal fastcc void @look(ptr noundef readonly captures(none) %0, ptr noundef nonnull readonly captures(none) %1, double noundef %2, ptr noundef %3) unnamed_addr {
  %5 = fcmp oeq double %2, 0.000000e+00
  br i1 %5, label %10, label %6

6:
  %7 = getelementptr inbounds nuw i8, ptr %1, i64 152
  %8 = load double, ptr %7, align 8
  %9 = fcmp oeq double %2, %8
  br i1 %9, label %10, label %17

10:
  %11 = phi i64 [ 80, %4 ], [ 88, %6 ]
  %12 = getelementptr inbounds nuw i8, ptr %1, i64 %11
  %13 = load ptr, ptr %12, align 8
  %14 = getelementptr inbounds nuw i8, ptr %0, i64 56
  %15 = load i64, ptr %14, align 8
  %16 = shl i64 %15, 3
  tail call void @llvm.memcpy.p0.p0.i64(ptr align 8 %3, ptr align 8 %13, i64 %16, i1 false)
  br label %93

17:
  %18 = getelementptr inbounds nuw i8, ptr %1, i64 32
  %19 = load ptr, ptr %18, align 8
  %20 = getelementptr inbounds nuw i8, ptr %1, i64 16
  %21 = load ptr, ptr %20, align 8
  %22 = getelementptr inbounds nuw i8, ptr %0, i64 16
  %23 = load i64, ptr %22, align 8
  %24 = shl i64 %23, 3
  tail call void @llvm.memcpy.p0.p0.i64(ptr align 8 %19, ptr align 8 %21, i64 %24, i1 false)
  %25 = load ptr, ptr %18, align 8
  %26 = getelementptr inbounds nuw i8, ptr %1, i64 144
  %27 = load double, ptr %26, align 8
  %28 = getelementptr inbounds nuw i8, ptr %0, i64 104
  %29 = load i64, ptr %28, align 8
  %30 = sitofp i64 %29 to double
  %31 = fmul double %30, 0x3CC0000000000000
  %32 = fsub double 1.000000e+00, %31
  %33 = fmul double %2, %32
  %34 = getelementptr inbounds nuw i8, ptr %0, i64 208
  %35 = load i64, ptr %34, align 8
  %36 = getelementptr inbounds double, ptr %25, i64 %35
  store double %27, ptr %36, align 8
  %37 = getelementptr inbounds nuw i8, ptr %0, i64 216
  %38 = load i64, ptr %37, align 8
  %39 = getelementptr inbounds double, ptr %25, i64 %38
  store double %33, ptr %39, align 8
  %40 = getelementptr inbounds nuw i8, ptr %1, i64 136
  %41 = load double, ptr %40, align 8
  %42 = fdiv double %33, %41
  %43 = getelementptr inbounds nuw i8, ptr %0, i64 224
  %44 = load i64, ptr %43, align 8
  %45 = getelementptr inbounds double, ptr %25, i64 %44
  store double %42, ptr %45, align 8
  %46 = getelementptr inbounds nuw i8, ptr %0, i64 408
  %47 = load ptr, ptr %46, align 8
  %48 = getelementptr inbounds nuw i8, ptr %1, i64 48
  %49 = load ptr, ptr %48, align 8
  %50 = getelementptr inbounds nuw i8, ptr %1, i64 8
  %51 = load ptr, ptr %50, align 8
  tail call void %47(ptr noundef %25, ptr noundef %49, ptr noundef %51)
  %52 = getelementptr inbounds nuw i8, ptr %0, i64 400
  %53 = load ptr, ptr %52, align 8
  %54 = getelementptr inbounds nuw i8, ptr %0, i64 240
  %55 = load i64, ptr %54, align 8
  %56 = getelementptr inbounds double, ptr %25, i64 %55
  %57 = load ptr, ptr %50, align 8
  tail call void %53(ptr noundef %25, ptr noundef %56, ptr noundef %57, i64 noundef 1)
  %58 = getelementptr inbounds nuw i8, ptr %0, i64 200
  %59 = load i64, ptr %58, align 8
  %60 = getelementptr inbounds double, ptr %25, i64 %59
  store double %33, ptr %60, align 8
  %61 = load ptr, ptr %18, align 8
  %62 = getelementptr inbounds nuw i8, ptr %0, i64 432
  %63 = load ptr, ptr %62, align 8
  %64 = getelementptr inbounds double, ptr %61, i64 %59
  %65 = load double, ptr %64, align 8
  %66 = getelementptr inbounds nuw i8, ptr %1, i64 56
  %67 = load ptr, ptr %66, align 8
  %68 = getelementptr inbounds nuw i8, ptr %1, i64 120
  %69 = load ptr, ptr %68, align 8
  %70 = getelementptr inbounds nuw i8, ptr %0, i64 40
  %71 = load i64, ptr %70, align 8
  %72 = shl i64 %71, 3
  tail call void @llvm.memcpy.p0.p0.i64(ptr align 8 %67, ptr align 8 %69, i64 %72, i1 false)
  %73 = load i64, ptr %70, align 8
  %74 = getelementptr inbounds nuw i8, ptr %0, i64 32
  %75 = load i64, ptr %74, align 8
  %76 = icmp slt i64 %73, %75
  %77 = load ptr, ptr %66, align 8
  br i1 %76, label %78, label %91

78:
  %79 = load ptr, ptr %68, align 8
  %80 = getelementptr inbounds double, ptr %79, i64 %73
  br label %81

81:
  %82 = phi i64 [ %73, %78 ], [ %89, %81 ]
  %83 = getelementptr inbounds double, ptr %79, i64 %82
  %84 = load double, ptr %83, align 8
  %85 = load double, ptr %80, align 8
  %86 = fdiv double %65, %85
  %87 = fmul double %84, %86
  %88 = getelementptr inbounds double, ptr %77, i64 %82
  store double %87, ptr %88, align 8
  %89 = add nsw i64 %82, 1
  %90 = icmp eq i64 %89, %75
  br i1 %90, label %91, label %81

91:
  %92 = load ptr, ptr %50, align 8
  tail call void %63(ptr noundef %3, ptr noundef nonnull %61, ptr noundef %77, ptr noundef %92)
  br label %93

93:
  ret void
}

declare void @llvm.memmove.p0.p0.i64(ptr writeonly captures(none), ptr readonly captures(none), i64, i1 immarg)

declare double @llvm.ceil.f64(double)

declare i32 @llvm.smax.i32(i32, i32)

declare i64 @llvm.smin.i64(i64, i64)

declare i32 @llvm.smin.i32(i32, i32)
