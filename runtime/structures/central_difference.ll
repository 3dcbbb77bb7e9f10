; Written from central_difference.c by `python -m runtime.engine.native_text`; do not edit.

%struct.Group = type { i64, i64, i64, i64, double, ptr, ptr, ptr, ptr, ptr, ptr, ptr, ptr, i64, ptr, i64, ptr, ptr, ptr, ptr }

define void @advance(ptr noundef readonly captures(none) %0, i64 noundef %1) {
  %3 = getelementptr inbounds nuw i8, ptr %0, i64 8
  %4 = load i64, ptr %3, align 8
  %5 = icmp sgt i64 %4, 0
  br i1 %5, label %6, label %9

6:
  %7 = getelementptr inbounds nuw i8, ptr %0, i64 80
  %8 = load ptr, ptr %7, align 8
  br label %11

9:
  %10 = icmp sgt i64 %1, 0
  br i1 %10, label %18, label %17

11:
  %12 = phi i64 [ 0, %6 ], [ %14, %11 ]
  %13 = getelementptr inbounds nuw i64, ptr %8, i64 %12
  store i64 0, ptr %13, align 8
  %14 = add nuw nsw i64 %12, 1
  %15 = load i64, ptr %3, align 8
  %16 = icmp slt i64 %14, %15
  br i1 %16, label %11, label %9

17:
  ret void

18:
  %19 = phi i64 [ %22, %18 ], [ 0, %9 ]
  %20 = load i64, ptr %3, align 8
  %21 = add nsw i64 %20, -1
  tail call fastcc void @step(ptr noundef nonnull %0, i64 noundef %21)
  %22 = add nuw nsw i64 %19, 1
  %23 = icmp eq i64 %22, %1
  br i1 %23, label %17, label %18
}

define internal fastcc void @step(ptr noundef readonly captures(none) %0, i64 noundef range(i64 -9223372036854775808, 9223372036854775807) %1) unnamed_addr {
  %3 = load ptr, ptr %0, align 8
  %4 = getelementptr inbounds %struct.Group, ptr %3, i64 %1
  %5 = getelementptr inbounds nuw i8, ptr %0, i64 16
  %6 = load i64, ptr %5, align 8
  %7 = load i64, ptr %4, align 8
  %8 = mul i64 %7, %6
  %9 = getelementptr inbounds nuw i8, ptr %4, i64 8
  %10 = load i64, ptr %9, align 8
  %11 = mul nsw i64 %10, %6
  %12 = sub i64 %10, %7
  %13 = getelementptr inbounds nuw i8, ptr %4, i64 152
  %14 = load ptr, ptr %13, align 8
  %15 = getelementptr inbounds nuw i8, ptr %0, i64 80
  %16 = load ptr, ptr %15, align 8
  %17 = getelementptr inbounds i64, ptr %16, i64 %1
  %18 = load i64, ptr %17, align 8
  %19 = getelementptr inbounds nuw i8, ptr %0, i64 24
  %20 = load i64, ptr %19, align 8
  %21 = mul nsw i64 %20, %18
  %22 = getelementptr inbounds double, ptr %14, i64 %21
  %23 = icmp slt i64 %8, %11
  br i1 %23, label %24, label %31

24:
  %25 = getelementptr inbounds nuw i8, ptr %0, i64 72
  %26 = load ptr, ptr %25, align 8
  %27 = shl i64 %8, 3
  %28 = getelementptr i8, ptr %26, i64 %27
  %29 = shl i64 %6, 3
  %30 = mul i64 %29, %12
  tail call void @llvm.memset.p0.i64(ptr align 8 %28, i8 0, i64 %30, i1 false)
  br label %31

31:
  %32 = getelementptr inbounds nuw i8, ptr %4, i64 120
  %33 = load i64, ptr %32, align 8
  %34 = icmp sgt i64 %33, 0
  br i1 %34, label %38, label %35

35:
  %36 = getelementptr inbounds nuw i8, ptr %0, i64 72
  %37 = load ptr, ptr %36, align 8
  br label %47

38:
  %39 = getelementptr inbounds nuw i8, ptr %4, i64 144
  %40 = load ptr, ptr %39, align 8
  %41 = getelementptr inbounds nuw i8, ptr %4, i64 136
  %42 = load ptr, ptr %41, align 8
  %43 = getelementptr inbounds nuw i8, ptr %0, i64 72
  %44 = load ptr, ptr %43, align 8
  %45 = getelementptr inbounds nuw i8, ptr %4, i64 128
  %46 = load ptr, ptr %45, align 8
  br label %62

47:
  %48 = phi ptr [ %37, %35 ], [ %44, %62 ]
  %49 = getelementptr inbounds nuw i8, ptr %4, i64 40
  %50 = load ptr, ptr %49, align 8
  %51 = getelementptr inbounds nuw i8, ptr %4, i64 48
  %52 = load ptr, ptr %51, align 8
  %53 = getelementptr inbounds nuw i8, ptr %4, i64 56
  %54 = load ptr, ptr %53, align 8
  %55 = getelementptr inbounds nuw i8, ptr %0, i64 32
  %56 = load ptr, ptr %55, align 8
  %57 = getelementptr inbounds nuw i8, ptr %0, i64 72
  %58 = getelementptr inbounds double, ptr %48, i64 %8
  tail call fastcc void @product(i64 noundef %6, i64 noundef %12, ptr noundef %50, ptr noundef %52, ptr noundef %54, ptr noundef %56, ptr noundef %58)
  %59 = getelementptr inbounds nuw i8, ptr %4, i64 64
  %60 = load ptr, ptr %59, align 8
  %61 = icmp eq ptr %60, null
  br i1 %61, label %140, label %80

62:
  %63 = phi i64 [ 0, %38 ], [ %78, %62 ]
  %64 = getelementptr inbounds nuw double, ptr %40, i64 %63
  %65 = load double, ptr %64, align 8
  %66 = getelementptr inbounds nuw i32, ptr %42, i64 %63
  %67 = load i32, ptr %66, align 4
  %68 = sext i32 %67 to i64
  %69 = getelementptr inbounds double, ptr %22, i64 %68
  %70 = load double, ptr %69, align 8
  %71 = fmul double %65, %70
  %72 = getelementptr inbounds nuw i32, ptr %46, i64 %63
  %73 = load i32, ptr %72, align 4
  %74 = sext i32 %73 to i64
  %75 = getelementptr inbounds double, ptr %44, i64 %74
  %76 = load double, ptr %75, align 8
  %77 = fadd double %71, %76
  store double %77, ptr %75, align 8
  %78 = add nuw nsw i64 %63, 1
  %79 = icmp eq i64 %78, %33
  br i1 %79, label %47, label %62

80:
  %81 = icmp slt i64 %1, 0
  br i1 %81, label %119, label %82

82:
  %83 = load ptr, ptr %0, align 8
  %84 = load i64, ptr %5, align 8
  %85 = getelementptr inbounds nuw i8, ptr %0, i64 48
  %86 = getelementptr inbounds nuw i8, ptr %0, i64 56
  %87 = getelementptr inbounds nuw i8, ptr %0, i64 64
  br label %88

88:
  %89 = phi i64 [ 0, %82 ], [ %103, %102 ]
  %90 = getelementptr inbounds nuw %struct.Group, ptr %83, i64 %89
  %91 = load i64, ptr %90, align 8
  %92 = mul nsw i64 %91, %84
  %93 = getelementptr inbounds nuw i8, ptr %90, i64 8
  %94 = load i64, ptr %93, align 8
  %95 = mul nsw i64 %94, %84
  %96 = icmp slt i64 %92, %95
  br i1 %96, label %97, label %102

97:
  %98 = getelementptr inbounds nuw i8, ptr %90, i64 32
  %99 = load ptr, ptr %85, align 8
  %100 = load ptr, ptr %86, align 8
  %101 = load ptr, ptr %87, align 8
  br label %105

102:
  %103 = add nuw nsw i64 %89, 1
  %104 = icmp eq i64 %89, %1
  br i1 %104, label %119, label %88

105:
  %106 = phi i64 [ %92, %97 ], [ %117, %105 ]
  %107 = load double, ptr %98, align 8
  %108 = getelementptr inbounds double, ptr %99, i64 %106
  %109 = load double, ptr %108, align 8
  %110 = fmul double %109, 1.500000e+00
  %111 = getelementptr inbounds double, ptr %100, i64 %106
  %112 = load double, ptr %111, align 8
  %113 = fmul double %112, 5.000000e-01
  %114 = fsub double %110, %113
  %115 = fmul double %107, %114
  %116 = getelementptr inbounds double, ptr %101, i64 %106
  store double %115, ptr %116, align 8
  %117 = add nsw i64 %106, 1
  %118 = icmp slt i64 %117, %95
  br i1 %118, label %105, label %102

119:
  %120 = getelementptr inbounds nuw i8, ptr %4, i64 72
  %121 = load ptr, ptr %120, align 8
  %122 = getelementptr inbounds nuw i8, ptr %4, i64 80
  %123 = load ptr, ptr %122, align 8
  %124 = getelementptr inbounds nuw i8, ptr %0, i64 64
  %125 = load ptr, ptr %124, align 8
  %126 = load ptr, ptr %57, align 8
  %127 = getelementptr inbounds double, ptr %126, i64 %8
  tail call fastcc void @product(i64 noundef %6, i64 noundef %12, ptr noundef nonnull %60, ptr noundef %121, ptr noundef %123, ptr noundef %125, ptr noundef %127)
  br i1 %23, label %128, label %166

128:
  %129 = getelementptr inbounds nuw i8, ptr %0, i64 48
  %130 = load ptr, ptr %129, align 8
  %131 = getelementptr inbounds nuw i8, ptr %0, i64 56
  %132 = load ptr, ptr %131, align 8
  br label %133

133:
  %134 = phi i64 [ %8, %128 ], [ %138, %133 ]
  %135 = getelementptr inbounds double, ptr %130, i64 %134
  %136 = load double, ptr %135, align 8
  %137 = getelementptr inbounds double, ptr %132, i64 %134
  store double %136, ptr %137, align 8
  %138 = add nsw i64 %134, 1
  %139 = icmp slt i64 %138, %11
  br i1 %139, label %133, label %144

140:
  br i1 %23, label %141, label %166

141:
  %142 = getelementptr inbounds nuw i8, ptr %0, i64 48
  %143 = load ptr, ptr %142, align 8
  br label %144

144:
  %145 = phi ptr [ %143, %141 ], [ %130, %133 ]
  %146 = getelementptr inbounds nuw i8, ptr %4, i64 96
  %147 = load ptr, ptr %146, align 8
  %148 = getelementptr inbounds nuw i8, ptr %4, i64 88
  %149 = load ptr, ptr %148, align 8
  %150 = load ptr, ptr %57, align 8
  br label %151

151:
  %152 = phi i64 [ %8, %144 ], [ %164, %151 ]
  %153 = getelementptr inbounds double, ptr %147, i64 %152
  %154 = load double, ptr %153, align 8
  %155 = getelementptr inbounds double, ptr %145, i64 %152
  %156 = load double, ptr %155, align 8
  %157 = fmul double %154, %156
  %158 = getelementptr inbounds double, ptr %149, i64 %152
  %159 = load double, ptr %158, align 8
  %160 = getelementptr inbounds double, ptr %150, i64 %152
  %161 = load double, ptr %160, align 8
  %162 = fmul double %159, %161
  %163 = fadd double %157, %162
  store double %163, ptr %155, align 8
  %164 = add nsw i64 %152, 1
  %165 = icmp slt i64 %164, %11
  br i1 %165, label %151, label %166

166:
  %167 = load ptr, ptr %15, align 8
  %168 = getelementptr inbounds i64, ptr %167, i64 %1
  %169 = load i64, ptr %168, align 8
  %170 = add nsw i64 %169, 1
  store i64 %170, ptr %168, align 8
  %171 = icmp sgt i64 %1, 0
  br i1 %171, label %179, label %172

172:
  %173 = getelementptr inbounds nuw i8, ptr %0, i64 8
  %174 = load i64, ptr %173, align 8
  %175 = icmp sgt i64 %174, 1
  br i1 %175, label %176, label %330

176:
  %177 = getelementptr inbounds nuw i8, ptr %0, i64 88
  %178 = load ptr, ptr %177, align 8
  br label %322

179:
  %180 = getelementptr inbounds nuw i8, ptr %4, i64 104
  %181 = load i64, ptr %180, align 8
  %182 = icmp sgt i64 %181, 0
  br i1 %182, label %183, label %189

183:
  %184 = getelementptr inbounds nuw i8, ptr %4, i64 112
  %185 = load ptr, ptr %184, align 8
  %186 = load i64, ptr %5, align 8
  %187 = getelementptr inbounds nuw i8, ptr %0, i64 40
  %188 = icmp sgt i64 %186, 0
  br label %203

189:
  %190 = getelementptr inbounds nuw i8, ptr %0, i64 88
  %191 = load ptr, ptr %190, align 8
  %192 = getelementptr inbounds nuw i64, ptr %191, i64 %1
  store i64 0, ptr %192, align 8
  %193 = getelementptr inbounds nuw i8, ptr %4, i64 16
  %194 = load i64, ptr %193, align 8
  %195 = icmp sgt i64 %194, 0
  br i1 %195, label %196, label %223

196:
  %197 = getelementptr inbounds nuw i8, ptr %0, i64 8
  %198 = getelementptr inbounds nuw i8, ptr %0, i64 40
  %199 = getelementptr inbounds nuw i8, ptr %0, i64 48
  %200 = getelementptr inbounds nuw i8, ptr %0, i64 56
  %201 = getelementptr inbounds nuw i8, ptr %0, i64 64
  %202 = add nsw i64 %1, -1
  br label %232

203:
  %204 = phi i64 [ 0, %183 ], [ %214, %213 ]
  %205 = getelementptr inbounds nuw i32, ptr %185, i64 %204
  %206 = load i32, ptr %205, align 4
  %207 = sext i32 %206 to i64
  %208 = mul nsw i64 %186, %207
  %209 = add nsw i64 %208, %186
  br i1 %188, label %210, label %213

210:
  %211 = load ptr, ptr %55, align 8
  %212 = load ptr, ptr %187, align 8
  br label %216

213:
  %214 = add nuw nsw i64 %204, 1
  %215 = icmp eq i64 %214, %181
  br i1 %215, label %189, label %203

216:
  %217 = phi i64 [ %208, %210 ], [ %221, %216 ]
  %218 = getelementptr inbounds double, ptr %211, i64 %217
  %219 = load double, ptr %218, align 8
  %220 = getelementptr inbounds double, ptr %212, i64 %217
  store double %219, ptr %220, align 8
  %221 = add nsw i64 %217, 1
  %222 = icmp slt i64 %221, %209
  br i1 %222, label %216, label %213

223:
  %224 = load i64, ptr %180, align 8
  %225 = icmp sgt i64 %224, 0
  br i1 %225, label %226, label %330

226:
  %227 = getelementptr inbounds nuw i8, ptr %4, i64 112
  %228 = load ptr, ptr %227, align 8
  %229 = load i64, ptr %5, align 8
  %230 = getelementptr inbounds nuw i8, ptr %0, i64 40
  %231 = icmp sgt i64 %229, 0
  br label %302

232:
  %233 = phi i64 [ 0, %196 ], [ %299, %298 ]
  %234 = load i64, ptr %197, align 8
  %235 = icmp slt i64 %1, %234
  br i1 %235, label %236, label %298

236:
  %237 = load ptr, ptr %0, align 8
  %238 = load ptr, ptr %190, align 8
  br label %239

239:
  %240 = phi i64 [ %1, %236 ], [ %260, %259 ]
  %241 = getelementptr inbounds nuw %struct.Group, ptr %237, i64 %240
  %242 = getelementptr inbounds nuw i64, ptr %238, i64 %240
  %243 = load i64, ptr %242, align 8
  %244 = sitofp i64 %243 to double
  %245 = getelementptr inbounds nuw i8, ptr %241, i64 24
  %246 = load i64, ptr %245, align 8
  %247 = sitofp i64 %246 to double
  %248 = fdiv double %244, %247
  %249 = getelementptr inbounds nuw i8, ptr %241, i64 104
  %250 = load i64, ptr %249, align 8
  %251 = icmp sgt i64 %250, 0
  br i1 %251, label %252, label %259

252:
  %253 = getelementptr inbounds nuw i8, ptr %241, i64 112
  %254 = load ptr, ptr %253, align 8
  %255 = load i64, ptr %5, align 8
  %256 = getelementptr inbounds nuw i8, ptr %241, i64 32
  %257 = fadd double %248, 5.000000e-01
  %258 = icmp sgt i64 %255, 0
  br label %262

259:
  %260 = add nuw nsw i64 %240, 1
  %261 = icmp eq i64 %260, %234
  br i1 %261, label %298, label %239

262:
  %263 = phi i64 [ 0, %252 ], [ %276, %275 ]
  %264 = getelementptr inbounds nuw i32, ptr %254, i64 %263
  %265 = load i32, ptr %264, align 4
  %266 = sext i32 %265 to i64
  %267 = mul nsw i64 %255, %266
  %268 = add nsw i64 %267, %255
  br i1 %258, label %269, label %275

269:
  %270 = load ptr, ptr %198, align 8
  %271 = load ptr, ptr %199, align 8
  %272 = load ptr, ptr %55, align 8
  %273 = load ptr, ptr %200, align 8
  %274 = load ptr, ptr %201, align 8
  br label %278

275:
  %276 = add nuw nsw i64 %263, 1
  %277 = icmp eq i64 %276, %250
  br i1 %277, label %259, label %262

278:
  %279 = phi i64 [ %267, %269 ], [ %296, %278 ]
  %280 = getelementptr inbounds double, ptr %270, i64 %279
  %281 = load double, ptr %280, align 8
  %282 = getelementptr inbounds double, ptr %271, i64 %279
  %283 = load double, ptr %282, align 8
  %284 = fmul double %248, %283
  %285 = fadd double %281, %284
  %286 = getelementptr inbounds double, ptr %272, i64 %279
  store double %285, ptr %286, align 8
  %287 = load double, ptr %256, align 8
  %288 = getelementptr inbounds double, ptr %273, i64 %279
  %289 = load double, ptr %288, align 8
  %290 = load double, ptr %282, align 8
  %291 = fsub double %290, %289
  %292 = fmul double %257, %291
  %293 = fadd double %289, %292
  %294 = fmul double %287, %293
  %295 = getelementptr inbounds double, ptr %274, i64 %279
  store double %294, ptr %295, align 8
  %296 = add nsw i64 %279, 1
  %297 = icmp slt i64 %296, %268
  br i1 %297, label %278, label %275

298:
  tail call fastcc void @step(ptr noundef nonnull %0, i64 noundef %202)
  %299 = add nuw nsw i64 %233, 1
  %300 = load i64, ptr %193, align 8
  %301 = icmp slt i64 %299, %300
  br i1 %301, label %232, label %223

302:
  %303 = phi i64 [ 0, %226 ], [ %313, %312 ]
  %304 = getelementptr inbounds nuw i32, ptr %228, i64 %303
  %305 = load i32, ptr %304, align 4
  %306 = sext i32 %305 to i64
  %307 = mul nsw i64 %229, %306
  %308 = add nsw i64 %307, %229
  br i1 %231, label %309, label %312

309:
  %310 = load ptr, ptr %230, align 8
  %311 = load ptr, ptr %55, align 8
  br label %315

312:
  %313 = add nuw nsw i64 %303, 1
  %314 = icmp eq i64 %313, %224
  br i1 %314, label %330, label %302

315:
  %316 = phi i64 [ %307, %309 ], [ %320, %315 ]
  %317 = getelementptr inbounds double, ptr %310, i64 %316
  %318 = load double, ptr %317, align 8
  %319 = getelementptr inbounds double, ptr %311, i64 %316
  store double %318, ptr %319, align 8
  %320 = add nsw i64 %316, 1
  %321 = icmp slt i64 %320, %308
  br i1 %321, label %315, label %312

322:
  %323 = phi i64 [ 1, %176 ], [ %327, %322 ]
  %324 = getelementptr inbounds nuw i64, ptr %178, i64 %323
  %325 = load i64, ptr %324, align 8
  %326 = add nsw i64 %325, 1
  store i64 %326, ptr %324, align 8
  %327 = add nuw nsw i64 %323, 1
  %328 = load i64, ptr %173, align 8
  %329 = icmp slt i64 %327, %328
  br i1 %329, label %322, label %330

330:
  %331 = load i64, ptr %4, align 8
  %332 = load i64, ptr %5, align 8
  %333 = mul nsw i64 %332, %331
  %334 = load i64, ptr %9, align 8
  %335 = mul nsw i64 %334, %332
  %336 = icmp slt i64 %333, %335
  br i1 %336, label %337, label %341

337:
  %338 = getelementptr inbounds nuw i8, ptr %0, i64 48
  %339 = load ptr, ptr %338, align 8
  %340 = load ptr, ptr %55, align 8
  br label %342

341:
  ret void

342:
  %343 = phi i64 [ %333, %337 ], [ %349, %342 ]
  %344 = getelementptr inbounds double, ptr %339, i64 %343
  %345 = load double, ptr %344, align 8
  %346 = getelementptr inbounds double, ptr %340, i64 %343
  %347 = load double, ptr %346, align 8
  %348 = fadd double %345, %347
  store double %348, ptr %346, align 8
  %349 = add nsw i64 %343, 1
  %350 = icmp slt i64 %349, %335
  br i1 %350, label %342, label %341
}

define internal fastcc void @product(i64 noundef %0, i64 noundef %1, ptr noundef readonly captures(none) %2, ptr noundef readonly captures(none) %3, ptr noundef readonly captures(none) %4, ptr noundef readonly captures(none) %5, ptr noundef captures(none) %6) unnamed_addr {
  %8 = alloca [3 x double], align 16
  %9 = icmp sgt i64 %1, 0
  switch i64 %0, label %101 [
    i64 1, label %10
    i64 2, label %47
  ]

10:
  br i1 %9, label %11, label %159

11:
  %12 = phi i64 [ %20, %27 ], [ 0, %10 ]
  %13 = phi double [ %28, %27 ], [ undef, %10 ]
  br label %14

14:
  %15 = phi double [ 0.000000e+00, %14 ], [ %13, %11 ]
  %16 = phi i1 [ false, %14 ], [ true, %11 ]
  br i1 %16, label %14, label %17

17:
  %18 = getelementptr inbounds nuw i32, ptr %2, i64 %12
  %19 = load i32, ptr %18, align 4
  %20 = add nuw nsw i64 %12, 1
  %21 = getelementptr inbounds nuw i32, ptr %2, i64 %20
  %22 = load i32, ptr %21, align 4
  %23 = sext i32 %22 to i64
  %24 = icmp slt i32 %19, %22
  br i1 %24, label %25, label %27

25:
  %26 = sext i32 %19 to i64
  br label %33

27:
  %28 = phi double [ %15, %17 ], [ %44, %33 ]
  %29 = getelementptr inbounds nuw double, ptr %6, i64 %12
  %30 = load double, ptr %29, align 8
  %31 = fsub double %30, %28
  store double %31, ptr %29, align 8
  %32 = icmp eq i64 %20, %1
  br i1 %32, label %159, label %11

33:
  %34 = phi i64 [ %45, %33 ], [ %26, %25 ]
  %35 = phi double [ %44, %33 ], [ %15, %25 ]
  %36 = getelementptr inbounds double, ptr %4, i64 %34
  %37 = getelementptr inbounds i32, ptr %3, i64 %34
  %38 = load i32, ptr %37, align 4
  %39 = sext i32 %38 to i64
  %40 = getelementptr inbounds double, ptr %5, i64 %39
  %41 = load double, ptr %36, align 8
  %42 = load double, ptr %40, align 8
  %43 = fmul double %41, %42
  %44 = fadd double %35, %43
  %45 = add nsw i64 %34, 1
  %46 = icmp eq i64 %45, %23
  br i1 %46, label %27, label %33

47:
  br i1 %9, label %48, label %159

48:
  %49 = load i32, ptr %2, align 4
  br label %50

50:
  %51 = phi i32 [ %55, %60 ], [ %49, %48 ]
  %52 = phi i64 [ %53, %60 ], [ 0, %48 ]
  %53 = add nuw nsw i64 %52, 1
  %54 = getelementptr inbounds nuw i32, ptr %2, i64 %53
  %55 = load i32, ptr %54, align 4
  %56 = sext i32 %55 to i64
  %57 = icmp slt i32 %51, %55
  br i1 %57, label %58, label %60

58:
  %59 = sext i32 %51 to i64
  br label %71

60:
  %61 = phi double [ 0.000000e+00, %50 ], [ %93, %98 ]
  %62 = phi double [ 0.000000e+00, %50 ], [ %97, %98 ]
  %63 = shl nuw nsw i64 %52, 4
  %64 = getelementptr inbounds nuw i8, ptr %6, i64 %63
  %65 = load double, ptr %64, align 8
  %66 = fsub double %65, %61
  store double %66, ptr %64, align 8
  %67 = getelementptr inbounds nuw i8, ptr %64, i64 8
  %68 = load double, ptr %67, align 8
  %69 = fsub double %68, %62
  store double %69, ptr %67, align 8
  %70 = icmp eq i64 %53, %1
  br i1 %70, label %159, label %50

71:
  %72 = phi double [ 0.000000e+00, %58 ], [ %93, %98 ]
  %73 = phi double [ 0.000000e+00, %58 ], [ %97, %98 ]
  %74 = phi i64 [ %59, %58 ], [ %99, %98 ]
  %75 = shl nsw i64 %74, 5
  %76 = getelementptr inbounds i8, ptr %4, i64 %75
  %77 = getelementptr inbounds i32, ptr %3, i64 %74
  %78 = load i32, ptr %77, align 4
  %79 = sext i32 %78 to i64
  %80 = shl nsw i64 %79, 4
  %81 = getelementptr inbounds i8, ptr %5, i64 %80
  br label %82

82:
  %83 = phi double [ %72, %71 ], [ %93, %82 ]
  %84 = phi double [ %73, %71 ], [ %97, %82 ]
  %85 = phi i1 [ true, %71 ], [ false, %82 ]
  %86 = phi i64 [ 0, %71 ], [ 1, %82 ]
  %87 = getelementptr inbounds nuw double, ptr %81, i64 %86
  %88 = load double, ptr %87, align 8
  %89 = shl nuw nsw i64 %86, 4
  %90 = getelementptr inbounds nuw i8, ptr %76, i64 %89
  %91 = load double, ptr %90, align 8
  %92 = fmul double %88, %91
  %93 = fadd double %83, %92
  %94 = getelementptr inbounds nuw i8, ptr %90, i64 8
  %95 = load double, ptr %94, align 8
  %96 = fmul double %88, %95
  %97 = fadd double %84, %96
  br i1 %85, label %82, label %98

98:
  %99 = add nsw i64 %74, 1
  %100 = icmp eq i64 %99, %56
  br i1 %100, label %60, label %71

101:
  br i1 %9, label %102, label %159

102:
  %103 = load i32, ptr %2, align 4
  br label %104

104:
  %105 = phi i32 [ %109, %148 ], [ %103, %102 ]
  %106 = phi i64 [ %107, %148 ], [ 0, %102 ]
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 16 dereferenceable(24) %8, i8 0, i64 24, i1 false)
  %107 = add nuw nsw i64 %106, 1
  %108 = getelementptr inbounds nuw i32, ptr %2, i64 %107
  %109 = load i32, ptr %108, align 4
  %110 = sext i32 %109 to i64
  %111 = icmp slt i32 %105, %109
  br i1 %111, label %112, label %114

112:
  %113 = sext i32 %105 to i64
  br label %117

114:
  %115 = mul nuw nsw i64 %106, 24
  %116 = getelementptr inbounds nuw i8, ptr %6, i64 %115
  br label %150

117:
  %118 = phi i64 [ %133, %132 ], [ %113, %112 ]
  %119 = mul nsw i64 %118, 72
  %120 = getelementptr inbounds i8, ptr %4, i64 %119
  %121 = getelementptr inbounds i32, ptr %3, i64 %118
  %122 = load i32, ptr %121, align 4
  %123 = sext i32 %122 to i64
  %124 = mul nsw i64 %123, 24
  %125 = getelementptr inbounds i8, ptr %5, i64 %124
  br label %126

126:
  %127 = phi i64 [ 0, %117 ], [ %136, %135 ]
  %128 = getelementptr inbounds nuw double, ptr %125, i64 %127
  %129 = load double, ptr %128, align 8
  %130 = mul nuw nsw i64 %127, 24
  %131 = getelementptr inbounds nuw i8, ptr %120, i64 %130
  br label %138

132:
  %133 = add nsw i64 %118, 1
  %134 = icmp eq i64 %133, %110
  br i1 %134, label %114, label %117

135:
  %136 = add nuw nsw i64 %127, 1
  %137 = icmp eq i64 %136, 3
  br i1 %137, label %132, label %126

138:
  %139 = phi i64 [ 0, %126 ], [ %146, %138 ]
  %140 = getelementptr inbounds nuw double, ptr %131, i64 %139
  %141 = load double, ptr %140, align 8
  %142 = fmul double %129, %141
  %143 = getelementptr inbounds nuw double, ptr %8, i64 %139
  %144 = load double, ptr %143, align 8
  %145 = fadd double %144, %142
  store double %145, ptr %143, align 8
  %146 = add nuw nsw i64 %139, 1
  %147 = icmp eq i64 %146, 3
  br i1 %147, label %135, label %138

148:
  %149 = icmp eq i64 %107, %1
  br i1 %149, label %159, label %104

150:
  %151 = phi i64 [ 0, %114 ], [ %157, %150 ]
  %152 = getelementptr inbounds nuw double, ptr %8, i64 %151
  %153 = load double, ptr %152, align 8
  %154 = getelementptr inbounds nuw double, ptr %116, i64 %151
  %155 = load double, ptr %154, align 8
  %156 = fsub double %155, %153
  store double %156, ptr %154, align 8
  %157 = add nuw nsw i64 %151, 1
  %158 = icmp eq i64 %157, 3
  br i1 %158, label %148, label %150

159:
  ret void
}

declare void @llvm.memset.p0.i64(ptr writeonly captures(none), i8, i64, i1 immarg)
