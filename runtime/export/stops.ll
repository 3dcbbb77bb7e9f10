; Written from stops.c by `python -m runtime.engine.native_text`; do not edit.

%struct.Room = type { ptr, ptr }
%struct.Bounded = type { i32, ptr, ptr, ptr, ptr, ptr, ptr, ptr }
%struct.Run = type { ptr, ptr, ptr, ptr, ptr, ptr, ptr, ptr, ptr, ptr, ptr, ptr, ptr, ptr, ptr, ptr, double, double, double, ptr, i32 }
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
  %65 = tail call fastcc i32 @decide(ptr noundef %0, ptr noundef %1, ptr noundef %2, ptr noundef %3, ptr noundef %4, ptr noundef %22, ptr noundef %5, ptr noundef %64, ptr noundef nonnull byval(%struct.Room) align 8 %7)
  ret i32 %65
}

define internal fastcc range(i32 0, 2) i32 @decide(ptr noundef readonly %0, ptr noundef captures(none) %1, ptr noundef captures(none) %2, ptr noundef readonly captures(none) %3, ptr noundef readonly captures(address_is_null) %4, ptr noundef readonly captures(none) %5, ptr noundef %6, ptr noundef %7, ptr noundef byval(%struct.Room) align 8 captures(none) %8) unnamed_addr {
  %10 = alloca %struct.Bounded, align 8
  %11 = alloca %struct.Bounded, align 8
  %12 = getelementptr inbounds nuw i8, ptr %0, i64 280
  %13 = load i64, ptr %12, align 8
  %14 = load ptr, ptr %8, align 8
  %15 = getelementptr inbounds double, ptr %14, i64 %13
  store ptr %15, ptr %8, align 8
  %16 = getelementptr inbounds nuw i8, ptr %8, i64 8
  %17 = load ptr, ptr %16, align 8
  %18 = getelementptr inbounds i32, ptr %17, i64 %13
  store ptr %18, ptr %16, align 8
  %19 = shl i64 %13, 2
  tail call void @llvm.memset.p0.i64(ptr align 4 %17, i8 0, i64 %19, i1 false)
  %20 = getelementptr inbounds nuw i8, ptr %0, i64 328
  %21 = load i64, ptr %20, align 8
  %22 = getelementptr inbounds double, ptr %6, i64 %21
  %23 = getelementptr inbounds nuw i8, ptr %0, i64 40
  %24 = load i64, ptr %23, align 8
  %25 = getelementptr inbounds double, ptr %22, i64 %24
  %26 = getelementptr inbounds nuw i8, ptr %0, i64 320
  %27 = load i64, ptr %26, align 8
  %28 = getelementptr inbounds double, ptr %25, i64 %27
  %29 = getelementptr inbounds nuw i8, ptr %0, i64 48
  %30 = getelementptr inbounds nuw i8, ptr %0, i64 304
  %31 = getelementptr inbounds nuw i8, ptr %0, i64 312
  %32 = getelementptr inbounds nuw i8, ptr %0, i64 288
  %33 = getelementptr inbounds nuw i8, ptr %11, i64 8
  %34 = getelementptr inbounds nuw i8, ptr %11, i64 16
  %35 = getelementptr inbounds nuw i8, ptr %11, i64 24
  %36 = getelementptr inbounds nuw i8, ptr %11, i64 32
  %37 = getelementptr inbounds nuw i8, ptr %11, i64 40
  %38 = getelementptr inbounds nuw i8, ptr %11, i64 48
  %39 = getelementptr inbounds nuw i8, ptr %11, i64 56
  %40 = getelementptr inbounds nuw i8, ptr %0, i64 472
  %41 = getelementptr inbounds nuw i8, ptr %0, i64 376
  %42 = getelementptr inbounds nuw i8, ptr %0, i64 392
  %43 = icmp eq ptr %4, null
  %44 = getelementptr inbounds nuw i8, ptr %0, i64 296
  %45 = getelementptr inbounds nuw i8, ptr %10, i64 8
  %46 = getelementptr inbounds nuw i8, ptr %10, i64 16
  %47 = getelementptr inbounds nuw i8, ptr %10, i64 24
  %48 = getelementptr inbounds nuw i8, ptr %10, i64 32
  %49 = getelementptr inbounds nuw i8, ptr %10, i64 40
  %50 = getelementptr inbounds nuw i8, ptr %10, i64 48
  %51 = getelementptr inbounds nuw i8, ptr %10, i64 56
  %52 = getelementptr inbounds nuw i8, ptr %0, i64 384
  %53 = getelementptr inbounds nuw i8, ptr %0, i64 488
  %54 = getelementptr inbounds nuw i8, ptr %0, i64 480
  br label %55

55:
  %56 = load i64, ptr %26, align 8
  %57 = shl i64 %56, 3
  tail call void @llvm.memcpy.p0.p0.i64(ptr align 8 %25, ptr align 8 %1, i64 %57, i1 false)
  %58 = load i64, ptr %23, align 8
  %59 = shl i64 %58, 3
  tail call void @llvm.memcpy.p0.p0.i64(ptr align 8 %22, ptr align 8 %3, i64 %59, i1 false)
  %60 = load i64, ptr %23, align 8
  %61 = getelementptr inbounds double, ptr %22, i64 %60
  %62 = load i64, ptr %29, align 8
  %63 = sub i64 0, %62
  %64 = getelementptr inbounds double, ptr %61, i64 %63
  %65 = shl i64 %62, 3
  tail call void @llvm.memcpy.p0.p0.i64(ptr align 8 %64, ptr align 8 %2, i64 %65, i1 false)
  %66 = load i64, ptr %12, align 8
  %67 = icmp sgt i64 %66, 0
  br i1 %67, label %68, label %80

68:
  %69 = load ptr, ptr %41, align 8
  br label %70

70:
  %71 = phi i64 [ 0, %68 ], [ %78, %70 ]
  %72 = getelementptr inbounds nuw i32, ptr %69, i64 %71
  %73 = load i32, ptr %72, align 4
  %74 = sext i32 %73 to i64
  %75 = getelementptr inbounds double, ptr %2, i64 %74
  %76 = load double, ptr %75, align 8
  %77 = getelementptr inbounds nuw double, ptr %14, i64 %71
  store double %76, ptr %77, align 8
  %78 = add nuw nsw i64 %71, 1
  %79 = icmp eq i64 %78, %66
  br i1 %79, label %80, label %70

80:
  %81 = load ptr, ptr %8, align 8
  %82 = load i64, ptr %30, align 8
  %83 = getelementptr inbounds double, ptr %25, i64 %82
  %84 = load i64, ptr %31, align 8
  %85 = getelementptr inbounds double, ptr %83, i64 %84
  %86 = getelementptr inbounds double, ptr %81, i64 %82
  %87 = load i64, ptr %32, align 8
  %88 = getelementptr inbounds double, ptr %86, i64 %87
  %89 = getelementptr inbounds double, ptr %88, i64 %87
  %90 = getelementptr inbounds double, ptr %89, i64 %66
  %91 = getelementptr inbounds double, ptr %90, i64 %66
  %92 = icmp sgt i64 %82, 0
  br i1 %92, label %93, label %106

93:
  %94 = phi double [ %101, %93 ], [ 0.000000e+00, %80 ]
  %95 = phi i64 [ %96, %93 ], [ %82, %80 ]
  %96 = add nsw i64 %95, -1
  %97 = getelementptr inbounds double, ptr %85, i64 %96
  %98 = load double, ptr %97, align 8
  %99 = tail call double @llvm.fabs.f64(double %98)
  %100 = fcmp ogt double %99, %94
  %101 = select i1 %100, double %99, double %94
  %102 = icmp samesign ugt i64 %95, 1
  br i1 %102, label %93, label %103

103:
  %104 = fadd double %101, 1.000000e+00
  %105 = fmul double %104, 1.000000e-09
  br label %106

106:
  %107 = phi double [ 1.000000e-09, %80 ], [ %105, %103 ]
  %108 = getelementptr inbounds i32, ptr %18, i64 %66
  %109 = getelementptr inbounds i32, ptr %108, i64 %66
  %110 = getelementptr inbounds i32, ptr %109, i64 %66
  %111 = getelementptr inbounds i32, ptr %110, i64 %87
  %112 = getelementptr inbounds i32, ptr %111, i64 %87
  store i32 0, ptr %11, align 8
  %113 = getelementptr inbounds i32, ptr %112, i64 %66
  store ptr %112, ptr %33, align 8
  %114 = getelementptr inbounds i32, ptr %113, i64 %66
  store ptr %113, ptr %34, align 8
  %115 = mul nsw i64 %66, %66
  %116 = getelementptr inbounds nuw double, ptr %91, i64 %115
  store ptr %91, ptr %35, align 8
  %117 = getelementptr inbounds double, ptr %116, i64 %66
  store ptr %116, ptr %36, align 8
  %118 = getelementptr inbounds double, ptr %117, i64 %66
  store ptr %117, ptr %37, align 8
  %119 = getelementptr inbounds double, ptr %118, i64 %66
  store ptr %118, ptr %38, align 8
  %120 = getelementptr inbounds double, ptr %119, i64 %66
  store ptr %119, ptr %39, align 8
  %121 = shl i64 %82, 3
  tail call void @llvm.memset.p0.i64(ptr align 8 %81, i8 0, i64 %121, i1 false)
  %122 = load i64, ptr %32, align 8
  %123 = shl i64 %122, 3
  tail call void @llvm.memset.p0.i64(ptr align 8 %88, i8 0, i64 %123, i1 false)
  %124 = load i64, ptr %12, align 8
  %125 = shl i64 %124, 2
  tail call void @llvm.memset.p0.i64(ptr align 4 %109, i8 0, i64 %125, i1 false)
  %126 = load i64, ptr %32, align 8
  %127 = shl i64 %126, 2
  tail call void @llvm.memset.p0.i64(ptr align 4 %110, i8 0, i64 %127, i1 false)
  %128 = load i64, ptr %32, align 8
  %129 = shl i64 %128, 2
  tail call void @llvm.memset.p0.i64(ptr align 4 %111, i8 0, i64 %129, i1 false)
  %130 = load i64, ptr %12, align 8
  %131 = shl i64 %130, 3
  tail call void @llvm.memcpy.p0.p0.i64(ptr align 8 %90, ptr align 8 %14, i64 %131, i1 false)
  %132 = load ptr, ptr %40, align 8
  tail call void %132(ptr noundef %6, ptr noundef %25, ptr noundef %22, ptr noundef %7)
  %133 = load i64, ptr %32, align 8
  %134 = icmp sgt i64 %133, 0
  br i1 %134, label %135, label %143

135:
  %136 = load i64, ptr %30, align 8
  %137 = add i64 %136, 1
  %138 = mul i64 %137, %133
  %139 = getelementptr double, ptr %6, i64 %138
  br label %148

140:
  %141 = add nuw nsw i64 %149, 1
  %142 = icmp eq i64 %141, %133
  br i1 %142, label %143, label %148

143:
  %144 = load i64, ptr %12, align 8
  %145 = icmp sgt i64 %144, 0
  br i1 %145, label %146, label %209

146:
  %147 = load ptr, ptr %42, align 8
  br label %153

148:
  %149 = phi i64 [ 0, %135 ], [ %141, %140 ]
  %150 = getelementptr double, ptr %139, i64 %149
  %151 = load double, ptr %150, align 8
  %152 = fcmp ult double %151, 0xBD719799812DEA11
  br i1 %152, label %1297, label %140

153:
  %154 = phi i64 [ 0, %146 ], [ %207, %203 ]
  %155 = phi i32 [ 0, %146 ], [ %206, %203 ]
  %156 = getelementptr inbounds nuw i32, ptr %147, i64 %154
  %157 = load i32, ptr %156, align 4
  %158 = icmp ne i32 %157, 0
  %159 = zext i1 %158 to i32
  %160 = getelementptr inbounds nuw double, ptr %90, i64 %154
  %161 = load double, ptr %160, align 8
  %162 = fcmp oeq double %161, 0.000000e+00
  br i1 %162, label %186, label %163

163:
  br i1 %43, label %168, label %164

164:
  %165 = getelementptr inbounds nuw i32, ptr %4, i64 %154
  %166 = load i32, ptr %165, align 4
  %167 = icmp ne i32 %166, 0
  br label %168

168:
  %169 = phi i1 [ %167, %164 ], [ false, %163 ]
  %170 = xor i1 %158, true
  %171 = select i1 %170, i1 true, i1 %169
  br i1 %171, label %186, label %172

172:
  %173 = load i64, ptr %30, align 8
  %174 = add i64 %173, 2
  %175 = mul i64 %174, %133
  %176 = zext nneg i32 %155 to i64
  %177 = getelementptr double, ptr %6, i64 %175
  %178 = getelementptr double, ptr %177, i64 %176
  %179 = load double, ptr %178, align 8
  %180 = fcmp ole double %179, 0.000000e+00
  %181 = zext i1 %180 to i32
  %182 = getelementptr inbounds nuw i32, ptr %18, i64 %154
  store i32 %181, ptr %182, align 4
  %183 = fcmp ole double %179, 1.000000e-09
  %184 = zext i1 %183 to i32
  %185 = getelementptr inbounds nuw i32, ptr %108, i64 %154
  store i32 %184, ptr %185, align 4
  br label %189

186:
  %187 = getelementptr inbounds nuw i32, ptr %18, i64 %154
  store i32 %159, ptr %187, align 4
  %188 = getelementptr inbounds nuw i32, ptr %108, i64 %154
  store i32 %159, ptr %188, align 4
  br i1 %158, label %189, label %203

189:
  %190 = getelementptr inbounds nuw i32, ptr %17, i64 %154
  %191 = load i32, ptr %190, align 4
  %192 = icmp eq i32 %191, 0
  br i1 %192, label %193, label %203

193:
  %194 = load i64, ptr %30, align 8
  %195 = add i64 %194, 2
  %196 = mul i64 %195, %133
  %197 = load i64, ptr %44, align 8
  %198 = zext nneg i32 %155 to i64
  %199 = getelementptr double, ptr %6, i64 %196
  %200 = getelementptr double, ptr %199, i64 %197
  %201 = getelementptr double, ptr %200, i64 %198
  %202 = load double, ptr %201, align 8
  br label %203

203:
  %204 = phi double [ %202, %193 ], [ 0.000000e+00, %189 ], [ 0.000000e+00, %186 ]
  %205 = getelementptr inbounds nuw double, ptr %89, i64 %154
  store double %204, ptr %205, align 8
  %206 = add nuw nsw i32 %155, %159
  %207 = add nuw nsw i64 %154, 1
  %208 = icmp eq i64 %207, %144
  br i1 %208, label %209, label %153

209:
  %210 = getelementptr inbounds double, ptr %120, i64 %144
  %211 = getelementptr inbounds i32, ptr %114, i64 %144
  store i32 0, ptr %10, align 8
  %212 = getelementptr inbounds i32, ptr %211, i64 %144
  store ptr %211, ptr %45, align 8
  %213 = getelementptr inbounds i32, ptr %212, i64 %144
  store ptr %212, ptr %46, align 8
  %214 = mul nsw i64 %144, %144
  %215 = getelementptr inbounds nuw double, ptr %210, i64 %214
  store ptr %210, ptr %47, align 8
  %216 = getelementptr inbounds double, ptr %215, i64 %144
  store ptr %215, ptr %48, align 8
  %217 = getelementptr inbounds double, ptr %216, i64 %144
  store ptr %216, ptr %49, align 8
  %218 = getelementptr inbounds double, ptr %217, i64 %144
  store ptr %217, ptr %50, align 8
  %219 = getelementptr inbounds double, ptr %218, i64 %144
  store ptr %218, ptr %51, align 8
  br i1 %145, label %220, label %226

220:
  %221 = load ptr, ptr %42, align 8
  %222 = load i64, ptr %30, align 8
  %223 = mul nsw i64 %222, %133
  %224 = load ptr, ptr %52, align 8
  %225 = getelementptr double, ptr %6, i64 %223
  br label %228

226:
  %227 = fneg double %107
  br label %242

228:
  %229 = phi i64 [ 0, %220 ], [ %240, %228 ]
  %230 = getelementptr inbounds nuw i32, ptr %221, i64 %229
  %231 = load i32, ptr %230, align 4
  %232 = sitofp i32 %231 to double
  %233 = getelementptr inbounds nuw i32, ptr %224, i64 %229
  %234 = load i32, ptr %233, align 4
  %235 = sext i32 %234 to i64
  %236 = getelementptr double, ptr %225, i64 %235
  %237 = load double, ptr %236, align 8
  %238 = fmul double %237, %232
  %239 = getelementptr inbounds nuw double, ptr %120, i64 %229
  store double %238, ptr %239, align 8
  %240 = add nuw nsw i64 %229, 1
  %241 = icmp eq i64 %240, %144
  br i1 %241, label %226, label %228

242:
  %243 = phi i64 [ %144, %226 ], [ %354, %465 ]
  %244 = phi i32 [ 0, %226 ], [ %466, %465 ]
  %245 = icmp ne i32 %244, 50
  %246 = icmp sgt i64 %243, 0
  br i1 %246, label %247, label %468

247:
  %248 = phi i64 [ %290, %286 ], [ 0, %242 ]
  %249 = phi i32 [ %289, %286 ], [ 0, %242 ]
  %250 = phi i32 [ %288, %286 ], [ 0, %242 ]
  %251 = phi i32 [ %287, %286 ], [ 0, %242 ]
  %252 = getelementptr inbounds nuw i32, ptr %18, i64 %248
  %253 = load i32, ptr %252, align 4
  %254 = icmp eq i32 %253, 0
  br i1 %254, label %286, label %255

255:
  %256 = getelementptr inbounds nuw double, ptr %120, i64 %248
  %257 = load double, ptr %256, align 8
  %258 = fcmp ugt double %257, %107
  %259 = select i1 %245, i1 %258, i1 false
  br i1 %259, label %286, label %260

260:
  %261 = fcmp olt double %257, %227
  %262 = icmp ne i32 %249, 0
  %263 = or i1 %262, %261
  %264 = zext i1 %263 to i32
  %265 = getelementptr inbounds nuw i32, ptr %109, i64 %248
  %266 = load i32, ptr %265, align 4
  %267 = icmp ne i32 %266, 0
  %268 = or i1 %261, %267
  %269 = zext i1 %268 to i32
  store i32 %269, ptr %265, align 4
  %270 = sext i32 %250 to i64
  %271 = getelementptr inbounds i32, ptr %114, i64 %270
  %272 = trunc nuw nsw i64 %248 to i32
  store i32 %272, ptr %271, align 4
  %273 = and i1 %245, %261
  br i1 %273, label %274, label %279

274:
  %275 = getelementptr inbounds nuw double, ptr %89, i64 %248
  %276 = load double, ptr %275, align 8
  %277 = fadd double %276, 1.000000e+00
  %278 = fmul double %257, %277
  br label %279

279:
  %280 = phi double [ %278, %274 ], [ %257, %260 ]
  %281 = getelementptr inbounds double, ptr %215, i64 %270
  store double %280, ptr %281, align 8
  %282 = getelementptr inbounds double, ptr %216, i64 %270
  store double 0.000000e+00, ptr %282, align 8
  %283 = getelementptr inbounds double, ptr %217, i64 %270
  store double 0x7FF0000000000000, ptr %283, align 8
  %284 = add nsw i32 %250, 1
  %285 = getelementptr inbounds i32, ptr %212, i64 %270
  store i32 0, ptr %285, align 4
  br label %286

286:
  %287 = phi i32 [ %284, %279 ], [ %251, %255 ], [ %251, %247 ]
  %288 = phi i32 [ %284, %279 ], [ %250, %255 ], [ %250, %247 ]
  %289 = phi i32 [ %264, %279 ], [ %249, %255 ], [ %249, %247 ]
  %290 = add nuw nsw i64 %248, 1
  %291 = icmp eq i64 %290, %243
  br i1 %291, label %292, label %247

292:
  %293 = icmp eq i32 %289, 0
  store i32 %287, ptr %10, align 8
  br i1 %293, label %468, label %294

294:
  %295 = icmp sgt i32 %288, 0
  br i1 %295, label %296, label %346

296:
  %297 = zext nneg i32 %288 to i64
  %298 = load ptr, ptr %42, align 8
  %299 = load i64, ptr %32, align 8
  %300 = load i64, ptr %30, align 8
  %301 = load i64, ptr %44, align 8
  %302 = load ptr, ptr %52, align 8
  %303 = mul nsw i64 %300, %299
  %304 = add i64 %300, 2
  %305 = mul i64 %304, %299
  %306 = getelementptr double, ptr %6, i64 %305
  %307 = shl i64 %301, 4
  %308 = getelementptr i8, ptr %306, i64 %307
  %309 = getelementptr double, ptr %308, i64 %303
  br label %310

310:
  %311 = phi i64 [ 0, %296 ], [ %344, %343 ]
  %312 = getelementptr inbounds nuw i32, ptr %114, i64 %311
  %313 = load i32, ptr %312, align 4
  %314 = sext i32 %313 to i64
  %315 = getelementptr inbounds i32, ptr %298, i64 %314
  %316 = load i32, ptr %315, align 4
  %317 = sitofp i32 %316 to double
  %318 = getelementptr inbounds i32, ptr %302, i64 %314
  %319 = load i32, ptr %318, align 4
  %320 = sext i32 %319 to i64
  %321 = getelementptr double, ptr %309, i64 %320
  %322 = getelementptr inbounds nuw double, ptr %210, i64 %311
  br label %323

323:
  %324 = phi i64 [ 0, %310 ], [ %341, %323 ]
  %325 = getelementptr inbounds nuw i32, ptr %114, i64 %324
  %326 = load i32, ptr %325, align 4
  %327 = sext i32 %326 to i64
  %328 = getelementptr inbounds i32, ptr %302, i64 %327
  %329 = load i32, ptr %328, align 4
  %330 = sext i32 %329 to i64
  %331 = mul nsw i64 %299, %330
  %332 = getelementptr double, ptr %321, i64 %331
  %333 = load double, ptr %332, align 8
  %334 = fmul double %333, %317
  %335 = getelementptr inbounds i32, ptr %298, i64 %327
  %336 = load i32, ptr %335, align 4
  %337 = sitofp i32 %336 to double
  %338 = fmul double %334, %337
  %339 = mul nuw nsw i64 %324, %297
  %340 = getelementptr inbounds nuw double, ptr %322, i64 %339
  store double %338, ptr %340, align 8
  %341 = add nuw nsw i64 %324, 1
  %342 = icmp eq i64 %341, %297
  br i1 %342, label %343, label %323

343:
  %344 = add nuw nsw i64 %311, 1
  %345 = icmp eq i64 %344, %297
  br i1 %345, label %346, label %310

346:
  %347 = call fastcc i32 @complementary(ptr noundef readonly %0, ptr noundef %10, ptr %219, ptr nonnull %213)
  %348 = icmp eq i32 %347, 0
  br i1 %348, label %349, label %350

349:
  br label %1297

350:
  call fastcc void @balance(ptr noundef readonly %0, ptr noundef %10, ptr %219, ptr nonnull %213)
  br i1 %295, label %351, label %353

351:
  %352 = zext nneg i32 %288 to i64
  br label %358

353:
  %354 = load i64, ptr %12, align 8
  %355 = icmp sgt i64 %354, 0
  br i1 %355, label %356, label %366

356:
  %357 = zext nneg i32 %288 to i64
  br label %372

358:
  %359 = phi i64 [ 0, %351 ], [ %364, %358 ]
  %360 = getelementptr inbounds nuw double, ptr %218, i64 %359
  %361 = load double, ptr %360, align 8
  %362 = fcmp ogt double %361, 0.000000e+00
  %363 = select i1 %362, double %361, double 0.000000e+00
  store double %363, ptr %360, align 8
  %364 = add nuw nsw i64 %359, 1
  %365 = icmp eq i64 %364, %352
  br i1 %365, label %353, label %358

366:
  %367 = load i64, ptr %30, align 8
  %368 = icmp sgt i64 %367, 0
  br i1 %368, label %369, label %465

369:
  %370 = add nuw i64 %367, 2
  %371 = zext nneg i32 %288 to i64
  br label %424

372:
  %373 = phi i64 [ 0, %356 ], [ %422, %417 ]
  br i1 %295, label %374, label %417

374:
  %375 = load ptr, ptr %42, align 8
  %376 = getelementptr inbounds nuw i32, ptr %375, i64 %373
  %377 = load i32, ptr %376, align 4
  %378 = sitofp i32 %377 to double
  %379 = load i64, ptr %32, align 8
  %380 = load i64, ptr %30, align 8
  %381 = mul nsw i64 %380, %379
  %382 = add i64 %380, 2
  %383 = mul i64 %382, %379
  %384 = load i64, ptr %44, align 8
  %385 = load ptr, ptr %52, align 8
  %386 = getelementptr inbounds nuw i32, ptr %385, i64 %373
  %387 = load i32, ptr %386, align 4
  %388 = sext i32 %387 to i64
  %389 = getelementptr double, ptr %6, i64 %383
  %390 = shl i64 %384, 4
  %391 = getelementptr i8, ptr %389, i64 %390
  %392 = getelementptr double, ptr %391, i64 %381
  %393 = getelementptr double, ptr %392, i64 %388
  br label %394

394:
  %395 = phi i64 [ 0, %374 ], [ %415, %394 ]
  %396 = phi double [ 0.000000e+00, %374 ], [ %414, %394 ]
  %397 = getelementptr inbounds nuw i32, ptr %114, i64 %395
  %398 = load i32, ptr %397, align 4
  %399 = sext i32 %398 to i64
  %400 = getelementptr inbounds i32, ptr %385, i64 %399
  %401 = load i32, ptr %400, align 4
  %402 = sext i32 %401 to i64
  %403 = mul nsw i64 %379, %402
  %404 = getelementptr double, ptr %393, i64 %403
  %405 = load double, ptr %404, align 8
  %406 = fmul double %405, %378
  %407 = getelementptr inbounds i32, ptr %375, i64 %399
  %408 = load i32, ptr %407, align 4
  %409 = sitofp i32 %408 to double
  %410 = fmul double %406, %409
  %411 = getelementptr inbounds nuw double, ptr %218, i64 %395
  %412 = load double, ptr %411, align 8
  %413 = fmul double %412, %410
  %414 = fadd double %396, %413
  %415 = add nuw nsw i64 %395, 1
  %416 = icmp eq i64 %415, %357
  br i1 %416, label %417, label %394

417:
  %418 = phi double [ 0.000000e+00, %372 ], [ %414, %394 ]
  %419 = getelementptr inbounds nuw double, ptr %120, i64 %373
  %420 = load double, ptr %419, align 8
  %421 = fadd double %418, %420
  store double %421, ptr %419, align 8
  %422 = add nuw nsw i64 %373, 1
  %423 = icmp eq i64 %422, %354
  br i1 %423, label %366, label %372

424:
  %425 = phi i64 [ 0, %369 ], [ %463, %458 ]
  br i1 %295, label %426, label %458

426:
  %427 = load i64, ptr %32, align 8
  %428 = mul i64 %427, %370
  %429 = load i64, ptr %44, align 8
  %430 = load ptr, ptr %52, align 8
  %431 = getelementptr double, ptr %6, i64 %428
  %432 = shl i64 %429, 4
  %433 = getelementptr i8, ptr %431, i64 %432
  %434 = getelementptr double, ptr %433, i64 %425
  %435 = load ptr, ptr %42, align 8
  br label %436

436:
  %437 = phi i64 [ 0, %426 ], [ %456, %436 ]
  %438 = phi double [ 0.000000e+00, %426 ], [ %455, %436 ]
  %439 = getelementptr inbounds nuw i32, ptr %114, i64 %437
  %440 = load i32, ptr %439, align 4
  %441 = sext i32 %440 to i64
  %442 = getelementptr inbounds i32, ptr %430, i64 %441
  %443 = load i32, ptr %442, align 4
  %444 = sext i32 %443 to i64
  %445 = mul nsw i64 %367, %444
  %446 = getelementptr double, ptr %434, i64 %445
  %447 = load double, ptr %446, align 8
  %448 = getelementptr inbounds i32, ptr %435, i64 %441
  %449 = load i32, ptr %448, align 4
  %450 = sitofp i32 %449 to double
  %451 = fmul double %447, %450
  %452 = getelementptr inbounds nuw double, ptr %218, i64 %437
  %453 = load double, ptr %452, align 8
  %454 = fmul double %453, %451
  %455 = fadd double %438, %454
  %456 = add nuw nsw i64 %437, 1
  %457 = icmp eq i64 %456, %371
  br i1 %457, label %458, label %436

458:
  %459 = phi double [ 0.000000e+00, %424 ], [ %455, %436 ]
  %460 = getelementptr inbounds nuw double, ptr %81, i64 %425
  %461 = load double, ptr %460, align 8
  %462 = fadd double %459, %461
  store double %462, ptr %460, align 8
  %463 = add nuw nsw i64 %425, 1
  %464 = icmp eq i64 %463, %367
  br i1 %464, label %465, label %424

465:
  %466 = add nuw nsw i32 %244, 1
  %467 = icmp eq i32 %466, 51
  br i1 %467, label %468, label %242

468:
  %469 = phi i64 [ %243, %242 ], [ %243, %292 ], [ %354, %465 ]
  %470 = load i64, ptr %32, align 8
  %471 = icmp sgt i64 %470, 0
  br i1 %471, label %472, label %481

472:
  %473 = load i64, ptr %30, align 8
  %474 = mul nsw i64 %473, %470
  %475 = getelementptr double, ptr %6, i64 %474
  %476 = trunc i64 %473 to i32
  %477 = icmp sgt i32 %476, 0
  %478 = shl i64 %470, 32
  %479 = ashr exact i64 %478, 32
  %480 = and i64 %473, 2147483647
  br label %485

481:
  %482 = icmp sgt i64 %469, 0
  br i1 %482, label %483, label %569

483:
  %484 = load ptr, ptr %52, align 8
  br label %516

485:
  %486 = phi i64 [ 0, %472 ], [ %507, %503 ]
  %487 = getelementptr double, ptr %475, i64 %486
  %488 = load double, ptr %487, align 8
  br i1 %477, label %489, label %503

489:
  %490 = getelementptr double, ptr %6, i64 %486
  br label %491

491:
  %492 = phi i64 [ 0, %489 ], [ %501, %491 ]
  %493 = phi double [ 0.000000e+00, %489 ], [ %500, %491 ]
  %494 = mul nsw i64 %492, %479
  %495 = getelementptr double, ptr %490, i64 %494
  %496 = load double, ptr %495, align 8
  %497 = getelementptr inbounds nuw double, ptr %81, i64 %492
  %498 = load double, ptr %497, align 8
  %499 = fmul double %496, %498
  %500 = fadd double %493, %499
  %501 = add nuw nsw i64 %492, 1
  %502 = icmp eq i64 %501, %480
  br i1 %502, label %503, label %491

503:
  %504 = phi double [ 0.000000e+00, %485 ], [ %500, %491 ]
  %505 = fadd double %488, %504
  %506 = getelementptr inbounds nuw double, ptr %86, i64 %486
  store double %505, ptr %506, align 8
  %507 = add nuw nsw i64 %486, 1
  %508 = icmp eq i64 %507, %470
  br i1 %508, label %481, label %485

509:
  %510 = load ptr, ptr %42, align 8
  %511 = load i64, ptr %23, align 8
  %512 = load i64, ptr %29, align 8
  %513 = sub nsw i64 %511, %512
  %514 = load ptr, ptr %41, align 8
  %515 = getelementptr double, ptr %22, i64 %513
  br label %573

516:
  %517 = phi i64 [ 0, %483 ], [ %565, %562 ]
  %518 = phi i32 [ 0, %483 ], [ %547, %562 ]
  %519 = getelementptr inbounds nuw i32, ptr %484, i64 %517
  %520 = load i32, ptr %519, align 4
  %521 = sext i32 %520 to i64
  %522 = getelementptr inbounds double, ptr %86, i64 %521
  %523 = load double, ptr %522, align 8
  %524 = tail call double @llvm.fabs.f64(double %523)
  %525 = getelementptr inbounds nuw i32, ptr %108, i64 %517
  %526 = load i32, ptr %525, align 4
  %527 = icmp ne i32 %526, 0
  %528 = fcmp ole double %524, %107
  %529 = select i1 %527, i1 %528, i1 false
  %530 = zext i1 %529 to i32
  store i32 %530, ptr %525, align 4
  br i1 %529, label %542, label %531

531:
  %532 = load ptr, ptr %42, align 8
  %533 = getelementptr inbounds nuw i32, ptr %532, i64 %517
  %534 = load i32, ptr %533, align 4
  %535 = icmp eq i32 %534, 0
  br i1 %535, label %536, label %546

536:
  %537 = getelementptr inbounds nuw double, ptr %5, i64 %517
  %538 = load double, ptr %537, align 8
  %539 = fcmp ogt double %538, %107
  %540 = select i1 %539, double %538, double %107
  %541 = fcmp ugt double %524, %540
  br i1 %541, label %546, label %542

542:
  %543 = load i32, ptr %519, align 4
  %544 = sext i32 %543 to i64
  %545 = getelementptr inbounds i32, ptr %110, i64 %544
  store i32 1, ptr %545, align 4
  br label %546

546:
  %547 = phi i32 [ 1, %542 ], [ %518, %536 ], [ %518, %531 ]
  %548 = load i32, ptr %519, align 4
  %549 = sext i32 %548 to i64
  %550 = getelementptr inbounds i32, ptr %111, i64 %549
  %551 = load i32, ptr %550, align 4
  %552 = icmp ne i32 %551, 0
  %553 = or i1 %43, %552
  br i1 %553, label %562, label %554

554:
  %555 = getelementptr inbounds nuw i32, ptr %4, i64 %517
  %556 = load i32, ptr %555, align 4
  %557 = icmp eq i32 %556, 0
  br i1 %557, label %562, label %558

558:
  %559 = getelementptr inbounds nuw double, ptr %90, i64 %517
  %560 = load double, ptr %559, align 8
  %561 = fcmp oeq double %560, 0.000000e+00
  br label %562

562:
  %563 = phi i1 [ %552, %546 ], [ false, %554 ], [ %561, %558 ]
  %564 = zext i1 %563 to i32
  store i32 %564, ptr %550, align 4
  %565 = add nuw nsw i64 %517, 1
  %566 = icmp eq i64 %565, %469
  br i1 %566, label %509, label %516

567:
  %568 = icmp eq i32 %547, 0
  br label %569

569:
  %570 = phi i1 [ true, %481 ], [ %568, %567 ]
  %571 = load i64, ptr %30, align 8
  %572 = icmp sgt i64 %571, 0
  br i1 %572, label %603, label %612

573:
  %574 = phi i64 [ 0, %509 ], [ %601, %594 ]
  %575 = getelementptr inbounds nuw i32, ptr %484, i64 %574
  %576 = load i32, ptr %575, align 4
  %577 = sext i32 %576 to i64
  %578 = getelementptr inbounds double, ptr %86, i64 %577
  %579 = load double, ptr %578, align 8
  %580 = getelementptr inbounds nuw i32, ptr %510, i64 %574
  %581 = load i32, ptr %580, align 4
  %582 = icmp eq i32 %581, 0
  br i1 %582, label %583, label %594

583:
  %584 = getelementptr inbounds i32, ptr %110, i64 %577
  %585 = load i32, ptr %584, align 4
  %586 = icmp eq i32 %585, 0
  br i1 %586, label %587, label %594

587:
  %588 = fcmp ogt double %579, 0.000000e+00
  %589 = zext i1 %588 to i32
  %590 = fcmp olt double %579, 0.000000e+00
  %591 = sext i1 %590 to i32
  %592 = add nsw i32 %591, %589
  %593 = sitofp i32 %592 to double
  br label %594

594:
  %595 = phi double [ 1.000000e+00, %573 ], [ %593, %587 ], [ 0.000000e+00, %583 ]
  %596 = getelementptr inbounds nuw double, ptr %14, i64 %574
  store double %595, ptr %596, align 8
  %597 = getelementptr inbounds nuw i32, ptr %514, i64 %574
  %598 = load i32, ptr %597, align 4
  %599 = sext i32 %598 to i64
  %600 = getelementptr double, ptr %515, i64 %599
  store double %595, ptr %600, align 8
  %601 = add nuw nsw i64 %574, 1
  %602 = icmp eq i64 %601, %469
  br i1 %602, label %567, label %573

603:
  %604 = phi i64 [ %610, %603 ], [ 0, %569 ]
  %605 = getelementptr inbounds nuw double, ptr %85, i64 %604
  %606 = load double, ptr %605, align 8
  %607 = getelementptr inbounds nuw double, ptr %81, i64 %604
  %608 = load double, ptr %607, align 8
  %609 = fadd double %606, %608
  store double %609, ptr %605, align 8
  %610 = add nuw nsw i64 %604, 1
  %611 = icmp eq i64 %610, %571
  br i1 %611, label %612, label %603

612:
  %613 = load i64, ptr %31, align 8
  %614 = icmp eq i64 %613, 0
  br i1 %614, label %623, label %615

615:
  %616 = load ptr, ptr %53, align 8
  tail call void %616(ptr noundef %120, ptr noundef %25, ptr noundef %22, ptr noundef %7)
  %617 = load i64, ptr %30, align 8
  %618 = shl nsw i64 %617, 4
  %619 = getelementptr inbounds i8, ptr %25, i64 %618
  %620 = load i64, ptr %31, align 8
  %621 = getelementptr inbounds double, ptr %619, i64 %620
  %622 = shl i64 %620, 3
  tail call void @llvm.memcpy.p0.p0.i64(ptr align 8 %621, ptr align 8 %120, i64 %622, i1 false)
  br label %623

623:
  br label %624

624:
  %625 = phi i1 [ true, %818 ], [ false, %623 ]
  %626 = load ptr, ptr %40, align 8
  tail call void %626(ptr noundef %6, ptr noundef %25, ptr noundef %22, ptr noundef %7)
  %627 = load i64, ptr %30, align 8
  %628 = icmp sgt i64 %627, 0
  br i1 %628, label %629, label %641

629:
  %630 = phi double [ %637, %629 ], [ 0.000000e+00, %624 ]
  %631 = phi i64 [ %632, %629 ], [ %627, %624 ]
  %632 = add nsw i64 %631, -1
  %633 = getelementptr inbounds double, ptr %85, i64 %632
  %634 = load double, ptr %633, align 8
  %635 = tail call double @llvm.fabs.f64(double %634)
  %636 = fcmp ogt double %635, %630
  %637 = select i1 %636, double %635, double %630
  %638 = icmp samesign ugt i64 %631, 1
  br i1 %638, label %629, label %639

639:
  %640 = fadd double %637, 1.000000e+00
  br label %641

641:
  %642 = phi double [ 1.000000e+00, %624 ], [ %640, %639 ]
  %643 = load i64, ptr %32, align 8
  %644 = getelementptr inbounds double, ptr %120, i64 %643
  %645 = getelementptr inbounds double, ptr %644, i64 %643
  %646 = getelementptr inbounds i32, ptr %114, i64 %643
  %647 = shl i64 %627, 3
  tail call void @llvm.memset.p0.i64(ptr align 8 %645, i8 0, i64 %647, i1 false)
  %648 = load i64, ptr %32, align 8
  %649 = icmp sgt i64 %648, 0
  %650 = load i64, ptr %30, align 8
  br i1 %649, label %651, label %777

651:
  %652 = icmp sgt i64 %650, 0
  %653 = mul nsw i64 %650, %648
  %654 = getelementptr double, ptr %6, i64 %653
  br label %659

655:
  %656 = icmp sgt i32 %710, 0
  br i1 %656, label %657, label %777

657:
  %658 = zext nneg i32 %710 to i64
  br label %713

659:
  %660 = phi i64 [ 0, %651 ], [ %711, %709 ]
  %661 = phi i32 [ 0, %651 ], [ %710, %709 ]
  %662 = getelementptr inbounds nuw double, ptr %644, i64 %660
  store double 0.000000e+00, ptr %662, align 8
  %663 = getelementptr double, ptr %6, i64 %660
  br i1 %652, label %664, label %677

664:
  %665 = phi i64 [ %673, %664 ], [ 0, %659 ]
  %666 = phi double [ %672, %664 ], [ 0.000000e+00, %659 ]
  %667 = mul nuw nsw i64 %665, %648
  %668 = getelementptr double, ptr %663, i64 %667
  %669 = load double, ptr %668, align 8
  %670 = tail call double @llvm.fabs.f64(double %669)
  %671 = fcmp ogt double %670, %666
  %672 = select i1 %671, double %670, double %666
  store double %672, ptr %662, align 8
  %673 = add nuw nsw i64 %665, 1
  %674 = icmp eq i64 %673, %650
  br i1 %674, label %675, label %664

675:
  %676 = fmul double %672, 0x3EB0C6F7A0B5ED8D
  br label %677

677:
  %678 = phi double [ %676, %675 ], [ 0.000000e+00, %659 ]
  %679 = getelementptr inbounds nuw i32, ptr %110, i64 %660
  %680 = load i32, ptr %679, align 4
  %681 = icmp eq i32 %680, 0
  br i1 %681, label %709, label %682

682:
  %683 = getelementptr double, ptr %654, i64 %660
  %684 = load double, ptr %683, align 8
  %685 = tail call double @llvm.fabs.f64(double %684)
  %686 = fmul double %642, %678
  %687 = fcmp ogt double %685, %686
  br i1 %687, label %709, label %688

688:
  %689 = sext i32 %661 to i64
  br i1 %652, label %690, label %703

690:
  %691 = mul nsw i64 %650, %689
  %692 = getelementptr double, ptr %28, i64 %691
  br label %693

693:
  %694 = phi i64 [ 0, %690 ], [ %699, %693 ]
  %695 = mul nuw nsw i64 %694, %648
  %696 = getelementptr double, ptr %663, i64 %695
  %697 = load double, ptr %696, align 8
  %698 = getelementptr double, ptr %692, i64 %694
  store double %697, ptr %698, align 8
  %699 = add nuw nsw i64 %694, 1
  %700 = icmp eq i64 %699, %650
  br i1 %700, label %701, label %693

701:
  %702 = load double, ptr %683, align 8
  br label %703

703:
  %704 = phi double [ %702, %701 ], [ %684, %688 ]
  %705 = getelementptr inbounds double, ptr %120, i64 %689
  store double %704, ptr %705, align 8
  %706 = add nsw i32 %661, 1
  %707 = getelementptr inbounds i32, ptr %114, i64 %689
  %708 = trunc nuw nsw i64 %660 to i32
  store i32 %708, ptr %707, align 4
  br label %709

709:
  %710 = phi i32 [ %661, %682 ], [ %706, %703 ], [ %661, %677 ]
  %711 = add nuw nsw i64 %660, 1
  %712 = icmp eq i64 %711, %648
  br i1 %712, label %655, label %659

713:
  %714 = phi i64 [ 0, %657 ], [ %775, %774 ]
  %715 = getelementptr inbounds nuw i32, ptr %646, i64 %714
  store i32 -1, ptr %715, align 4
  br i1 %652, label %716, label %774

716:
  %717 = mul nuw nsw i64 %714, %650
  %718 = getelementptr double, ptr %28, i64 %717
  %719 = getelementptr inbounds nuw i32, ptr %114, i64 %714
  br label %725

720:
  %721 = icmp sgt i32 %740, -1
  %722 = zext nneg i32 %740 to i64
  %723 = getelementptr double, ptr %718, i64 %722
  %724 = getelementptr inbounds nuw double, ptr %120, i64 %714
  br i1 %721, label %743, label %774

725:
  %726 = phi i32 [ -1, %716 ], [ %740, %739 ]
  %727 = phi i64 [ 0, %716 ], [ %741, %739 ]
  %728 = getelementptr double, ptr %718, i64 %727
  %729 = load double, ptr %728, align 8
  %730 = tail call double @llvm.fabs.f64(double %729)
  %731 = load i32, ptr %719, align 4
  %732 = sext i32 %731 to i64
  %733 = getelementptr inbounds double, ptr %644, i64 %732
  %734 = load double, ptr %733, align 8
  %735 = fmul double %734, 1.000000e-09
  %736 = fcmp ogt double %730, %735
  br i1 %736, label %737, label %739

737:
  %738 = trunc nuw nsw i64 %727 to i32
  store i32 %738, ptr %715, align 4
  br label %739

739:
  %740 = phi i32 [ %726, %725 ], [ %738, %737 ]
  %741 = add nuw nsw i64 %727, 1
  %742 = icmp eq i64 %741, %650
  br i1 %742, label %720, label %725

743:
  %744 = phi i64 [ %772, %771 ], [ 0, %720 ]
  %745 = icmp eq i64 %744, %714
  br i1 %745, label %771, label %746

746:
  %747 = mul nuw nsw i64 %744, %650
  %748 = getelementptr double, ptr %28, i64 %747
  %749 = getelementptr double, ptr %748, i64 %722
  %750 = load double, ptr %749, align 8
  %751 = fcmp une double %750, 0.000000e+00
  br i1 %751, label %752, label %771

752:
  %753 = load double, ptr %723, align 8
  %754 = fdiv double %750, %753
  br label %755

755:
  %756 = phi i64 [ %763, %755 ], [ 0, %752 ]
  %757 = getelementptr double, ptr %718, i64 %756
  %758 = load double, ptr %757, align 8
  %759 = fmul double %754, %758
  %760 = getelementptr double, ptr %748, i64 %756
  %761 = load double, ptr %760, align 8
  %762 = fsub double %761, %759
  store double %762, ptr %760, align 8
  %763 = add nuw nsw i64 %756, 1
  %764 = icmp eq i64 %763, %650
  br i1 %764, label %765, label %755

765:
  %766 = load double, ptr %724, align 8
  %767 = fmul double %754, %766
  %768 = getelementptr inbounds nuw double, ptr %120, i64 %744
  %769 = load double, ptr %768, align 8
  %770 = fsub double %769, %767
  store double %770, ptr %768, align 8
  br label %771

771:
  %772 = add nuw nsw i64 %744, 1
  %773 = icmp eq i64 %772, %658
  br i1 %773, label %774, label %743

774:
  %775 = add nuw nsw i64 %714, 1
  %776 = icmp eq i64 %775, %658
  br i1 %776, label %779, label %713

777:
  %778 = icmp sgt i64 %650, 0
  br i1 %778, label %798, label %807

779:
  %780 = phi i64 [ %796, %795 ], [ 0, %774 ]
  %781 = getelementptr inbounds nuw i32, ptr %646, i64 %780
  %782 = load i32, ptr %781, align 4
  %783 = icmp sgt i32 %782, -1
  br i1 %783, label %784, label %795

784:
  %785 = getelementptr inbounds nuw double, ptr %120, i64 %780
  %786 = load double, ptr %785, align 8
  %787 = fneg double %786
  %788 = mul nsw i64 %780, %650
  %789 = zext nneg i32 %782 to i64
  %790 = getelementptr double, ptr %28, i64 %788
  %791 = getelementptr double, ptr %790, i64 %789
  %792 = load double, ptr %791, align 8
  %793 = fdiv double %787, %792
  %794 = getelementptr inbounds nuw double, ptr %645, i64 %789
  store double %793, ptr %794, align 8
  br label %795

795:
  %796 = add nuw nsw i64 %780, 1
  %797 = icmp eq i64 %796, %658
  br i1 %797, label %777, label %779

798:
  %799 = phi i64 [ %805, %798 ], [ 0, %777 ]
  %800 = getelementptr inbounds nuw double, ptr %85, i64 %799
  %801 = load double, ptr %800, align 8
  %802 = getelementptr inbounds nuw double, ptr %645, i64 %799
  %803 = load double, ptr %802, align 8
  %804 = fadd double %801, %803
  store double %804, ptr %800, align 8
  %805 = add nuw nsw i64 %799, 1
  %806 = icmp eq i64 %805, %650
  br i1 %806, label %807, label %798

807:
  %808 = load i64, ptr %31, align 8
  %809 = icmp eq i64 %808, 0
  br i1 %809, label %818, label %810

810:
  %811 = load ptr, ptr %53, align 8
  tail call void %811(ptr noundef %120, ptr noundef %25, ptr noundef %22, ptr noundef %7)
  %812 = load i64, ptr %30, align 8
  %813 = shl nsw i64 %812, 4
  %814 = getelementptr inbounds i8, ptr %25, i64 %813
  %815 = load i64, ptr %31, align 8
  %816 = getelementptr inbounds double, ptr %814, i64 %815
  %817 = shl i64 %815, 3
  tail call void @llvm.memcpy.p0.p0.i64(ptr align 8 %816, ptr align 8 %120, i64 %817, i1 false)
  br label %818

818:
  %819 = or i1 %570, %625
  br i1 %819, label %820, label %624

820:
  %821 = load ptr, ptr %40, align 8
  tail call void %821(ptr noundef %6, ptr noundef %25, ptr noundef %22, ptr noundef %7)
  %822 = load i64, ptr %32, align 8
  %823 = icmp sgt i64 %822, 0
  br i1 %823, label %825, label %824

824:
  store i32 0, ptr %11, align 8
  br label %932

825:
  %826 = mul nuw nsw i64 %822, %822
  br label %828

827:
  store i32 %891, ptr %11, align 8
  br label %895

828:
  %829 = phi i64 [ 0, %825 ], [ %893, %890 ]
  %830 = phi i32 [ 0, %825 ], [ %892, %890 ]
  %831 = phi i32 [ 0, %825 ], [ %891, %890 ]
  %832 = getelementptr inbounds nuw i32, ptr %110, i64 %829
  %833 = load i32, ptr %832, align 4
  %834 = icmp eq i32 %833, 0
  br i1 %834, label %890, label %835

835:
  %836 = load i64, ptr %30, align 8
  %837 = mul nsw i64 %836, %822
  %838 = add i64 %836, 2
  %839 = mul i64 %838, %822
  %840 = load i64, ptr %44, align 8
  %841 = getelementptr double, ptr %6, i64 %839
  %842 = shl i64 %840, 4
  %843 = getelementptr i8, ptr %841, i64 %842
  %844 = getelementptr double, ptr %843, i64 %837
  %845 = getelementptr double, ptr %844, i64 %826
  %846 = getelementptr double, ptr %845, i64 %829
  %847 = load double, ptr %846, align 8
  %848 = sext i32 %830 to i64
  %849 = getelementptr inbounds double, ptr %116, i64 %848
  store double %847, ptr %849, align 8
  %850 = add i64 %836, 1
  %851 = mul i64 %850, %822
  %852 = getelementptr double, ptr %6, i64 %851
  %853 = getelementptr double, ptr %852, i64 %829
  %854 = load double, ptr %853, align 8
  %855 = fneg double %854
  %856 = getelementptr inbounds double, ptr %117, i64 %848
  store double %855, ptr %856, align 8
  %857 = load double, ptr %853, align 8
  %858 = getelementptr inbounds double, ptr %118, i64 %848
  store double %857, ptr %858, align 8
  %859 = getelementptr inbounds nuw i32, ptr %111, i64 %829
  %860 = load i32, ptr %859, align 4
  %861 = getelementptr inbounds i32, ptr %113, i64 %848
  store i32 %860, ptr %861, align 4
  %862 = load i64, ptr %12, align 8
  %863 = icmp sgt i64 %862, 0
  br i1 %863, label %864, label %888

864:
  %865 = load ptr, ptr %52, align 8
  br label %866

866:
  %867 = phi i64 [ 0, %864 ], [ %886, %885 ]
  %868 = getelementptr inbounds nuw i32, ptr %865, i64 %867
  %869 = load i32, ptr %868, align 4
  %870 = zext i32 %869 to i64
  %871 = icmp eq i64 %829, %870
  br i1 %871, label %872, label %885

872:
  %873 = getelementptr inbounds nuw i32, ptr %108, i64 %867
  %874 = load i32, ptr %873, align 4
  %875 = icmp eq i32 %874, 0
  br i1 %875, label %885, label %876

876:
  %877 = load ptr, ptr %42, align 8
  %878 = getelementptr inbounds nuw i32, ptr %877, i64 %867
  %879 = load i32, ptr %878, align 4
  %880 = icmp sgt i32 %879, 0
  br i1 %880, label %881, label %882

881:
  store double 0x7FF0000000000000, ptr %858, align 8
  br label %885

882:
  %883 = icmp slt i32 %879, 0
  br i1 %883, label %884, label %885

884:
  store double 0xFFF0000000000000, ptr %856, align 8
  br label %885

885:
  %886 = add nuw nsw i64 %867, 1
  %887 = icmp eq i64 %886, %862
  br i1 %887, label %888, label %866

888:
  %889 = add nsw i32 %830, 1
  store i32 %889, ptr %832, align 4
  br label %890

890:
  %891 = phi i32 [ %831, %828 ], [ %889, %888 ]
  %892 = phi i32 [ %830, %828 ], [ %889, %888 ]
  %893 = add nuw nsw i64 %829, 1
  %894 = icmp eq i64 %893, %822
  br i1 %894, label %827, label %828

895:
  %896 = phi i64 [ %930, %929 ], [ 0, %827 ]
  %897 = getelementptr inbounds nuw i32, ptr %110, i64 %896
  %898 = load i32, ptr %897, align 4
  %899 = icmp eq i32 %898, 0
  %900 = add nsw i32 %898, -1
  br label %901

901:
  %902 = phi i64 [ 0, %895 ], [ %927, %926 ]
  br i1 %899, label %926, label %903

903:
  %904 = getelementptr inbounds nuw i32, ptr %110, i64 %902
  %905 = load i32, ptr %904, align 4
  %906 = icmp eq i32 %905, 0
  br i1 %906, label %926, label %907

907:
  %908 = load i64, ptr %30, align 8
  %909 = mul nsw i64 %908, %822
  %910 = add i64 %908, 2
  %911 = mul i64 %910, %822
  %912 = load i64, ptr %44, align 8
  %913 = mul nuw nsw i64 %902, %822
  %914 = getelementptr double, ptr %6, i64 %911
  %915 = shl i64 %912, 4
  %916 = getelementptr i8, ptr %914, i64 %915
  %917 = getelementptr double, ptr %916, i64 %909
  %918 = getelementptr double, ptr %917, i64 %896
  %919 = getelementptr double, ptr %918, i64 %913
  %920 = load double, ptr %919, align 8
  %921 = add nsw i32 %905, -1
  %922 = mul nsw i32 %921, %892
  %923 = add nsw i32 %900, %922
  %924 = sext i32 %923 to i64
  %925 = getelementptr inbounds double, ptr %91, i64 %924
  store double %920, ptr %925, align 8
  br label %926

926:
  %927 = add nuw nsw i64 %902, 1
  %928 = icmp eq i64 %927, %822
  br i1 %928, label %929, label %901

929:
  %930 = add nuw nsw i64 %896, 1
  %931 = icmp eq i64 %930, %822
  br i1 %931, label %932, label %895

932:
  br label %933

933:
  %934 = call fastcc i32 @complementary(ptr noundef readonly %0, ptr noundef %11, ptr %120, ptr %114)
  %935 = icmp eq i32 %934, 0
  br i1 %935, label %1297, label %936

936:
  %937 = load i64, ptr %32, align 8
  %938 = icmp sgt i64 %937, 0
  br i1 %938, label %939, label %989

939:
  %940 = load i64, ptr %20, align 8
  %941 = load i64, ptr %30, align 8
  %942 = load i64, ptr %44, align 8
  %943 = shl i64 %942, 1
  %944 = shl i64 %941, 1
  %945 = add nuw i64 %937, 2
  %946 = add i64 %945, %944
  %947 = mul i64 %946, %937
  %948 = add i64 %943, %937
  %949 = add i64 %948, %947
  %950 = icmp sgt i64 %940, %949
  %951 = getelementptr double, ptr %6, i64 %949
  br label %952

952:
  %953 = phi i64 [ 0, %939 ], [ %985, %983 ]
  %954 = phi i32 [ 0, %939 ], [ %984, %983 ]
  br i1 %950, label %955, label %983

955:
  %956 = getelementptr inbounds nuw i32, ptr %110, i64 %953
  %957 = load i32, ptr %956, align 4
  %958 = icmp eq i32 %957, 0
  br i1 %958, label %983, label %959

959:
  %960 = add nsw i32 %957, -1
  %961 = sext i32 %960 to i64
  %962 = getelementptr inbounds i32, ptr %112, i64 %961
  %963 = load i32, ptr %962, align 4
  %964 = icmp eq i32 %963, 0
  br i1 %964, label %983, label %965

965:
  %966 = getelementptr double, ptr %951, i64 %953
  %967 = load double, ptr %966, align 8
  %968 = getelementptr inbounds double, ptr %118, i64 %961
  %969 = load double, ptr %968, align 8
  %970 = fcmp one double %969, 0x7FF0000000000000
  %971 = fcmp olt double %967, %969
  %972 = select i1 %970, i1 %971, i1 false
  br i1 %972, label %973, label %974

973:
  store double %967, ptr %968, align 8
  br label %974

974:
  %975 = phi i32 [ 1, %973 ], [ %954, %965 ]
  %976 = getelementptr inbounds double, ptr %117, i64 %961
  %977 = load double, ptr %976, align 8
  %978 = fcmp ueq double %977, 0xFFF0000000000000
  br i1 %978, label %983, label %979

979:
  %980 = fneg double %967
  %981 = fcmp olt double %977, %980
  br i1 %981, label %982, label %983

982:
  store double %980, ptr %976, align 8
  br label %983

983:
  %984 = phi i32 [ %954, %952 ], [ %954, %959 ], [ %954, %955 ], [ 1, %982 ], [ %975, %979 ], [ %975, %974 ]
  %985 = add nuw nsw i64 %953, 1
  %986 = icmp eq i64 %985, %937
  br i1 %986, label %987, label %952

987:
  %988 = icmp eq i32 %984, 0
  br i1 %988, label %989, label %933

989:
  call fastcc void @balance(ptr noundef nonnull readonly %0, ptr noundef %11, ptr %120, ptr %114)
  %990 = load i64, ptr %32, align 8
  %991 = icmp sgt i64 %990, 0
  br i1 %991, label %998, label %992

992:
  %993 = load i64, ptr %12, align 8
  %994 = icmp sgt i64 %993, 0
  br i1 %994, label %995, label %1050

995:
  %996 = load ptr, ptr %52, align 8
  %997 = load ptr, ptr %42, align 8
  br label %1012

998:
  %999 = phi i64 [ %1010, %1009 ], [ 0, %989 ]
  %1000 = getelementptr inbounds nuw i32, ptr %110, i64 %999
  %1001 = load i32, ptr %1000, align 4
  %1002 = icmp eq i32 %1001, 0
  br i1 %1002, label %1009, label %1003

1003:
  %1004 = sext i32 %1001 to i64
  %1005 = getelementptr double, ptr %119, i64 %1004
  %1006 = getelementptr i8, ptr %1005, i64 -8
  %1007 = load double, ptr %1006, align 8
  %1008 = getelementptr inbounds nuw double, ptr %88, i64 %999
  store double %1007, ptr %1008, align 8
  br label %1009

1009:
  %1010 = add nuw nsw i64 %999, 1
  %1011 = icmp eq i64 %1010, %990
  br i1 %1011, label %992, label %998

1012:
  %1013 = phi i64 [ 0, %995 ], [ %1048, %1047 ]
  %1014 = getelementptr inbounds nuw i32, ptr %996, i64 %1013
  %1015 = load i32, ptr %1014, align 4
  %1016 = sext i32 %1015 to i64
  %1017 = getelementptr inbounds i32, ptr %110, i64 %1016
  %1018 = load i32, ptr %1017, align 4
  %1019 = getelementptr inbounds nuw i32, ptr %997, i64 %1013
  %1020 = load i32, ptr %1019, align 4
  %1021 = icmp eq i32 %1020, 0
  %1022 = icmp ne i32 %1018, 0
  %1023 = select i1 %1021, i1 %1022, i1 false
  br i1 %1023, label %1024, label %1032

1024:
  %1025 = sext i32 %1018 to i64
  %1026 = getelementptr i32, ptr %112, i64 %1025
  %1027 = getelementptr i8, ptr %1026, i64 -4
  %1028 = load i32, ptr %1027, align 4
  %1029 = sitofp i32 %1028 to double
  %1030 = fneg double %1029
  %1031 = getelementptr inbounds nuw double, ptr %14, i64 %1013
  store double %1030, ptr %1031, align 8
  br label %1032

1032:
  %1033 = getelementptr inbounds nuw i32, ptr %108, i64 %1013
  %1034 = load i32, ptr %1033, align 4
  %1035 = icmp eq i32 %1034, 0
  br i1 %1035, label %1047, label %1036

1036:
  br i1 %1022, label %1037, label %1044

1037:
  %1038 = sext i32 %1018 to i64
  %1039 = getelementptr i32, ptr %112, i64 %1038
  %1040 = getelementptr i8, ptr %1039, i64 -4
  %1041 = load i32, ptr %1040, align 4
  %1042 = icmp eq i32 %1041, 0
  %1043 = select i1 %1042, double 0.000000e+00, double -1.000000e+00
  br label %1044

1044:
  %1045 = phi double [ -1.000000e+00, %1036 ], [ %1043, %1037 ]
  %1046 = getelementptr inbounds nuw double, ptr %14, i64 %1013
  store double %1045, ptr %1046, align 8
  br label %1047

1047:
  %1048 = add nuw nsw i64 %1013, 1
  %1049 = icmp eq i64 %1048, %993
  br i1 %1049, label %1050, label %1012

1050:
  br i1 %570, label %1218, label %1051

1051:
  %1052 = load i64, ptr %30, align 8
  %1053 = mul nsw i64 %1052, %990
  %1054 = add i64 %1052, 2
  %1055 = mul i64 %1054, %990
  %1056 = load i64, ptr %44, align 8
  %1057 = getelementptr double, ptr %6, i64 %1055
  %1058 = shl i64 %1056, 4
  %1059 = getelementptr i8, ptr %1057, i64 %1058
  %1060 = getelementptr double, ptr %1059, i64 %1053
  %1061 = getelementptr double, ptr %120, i64 %993
  %1062 = shl i64 %990, 4
  %1063 = getelementptr i8, ptr %1061, i64 %1062
  %1064 = mul i64 %990, -2
  %1065 = sub i64 %1064, %993
  %1066 = getelementptr inbounds double, ptr %1063, i64 %1065
  %1067 = getelementptr inbounds double, ptr %1063, i64 %1064
  %1068 = getelementptr inbounds double, ptr %1067, i64 %990
  %1069 = getelementptr inbounds double, ptr %25, i64 %1052
  %1070 = load i64, ptr %31, align 8
  %1071 = getelementptr inbounds double, ptr %1069, i64 %1070
  %1072 = icmp sgt i64 %1052, 0
  br i1 %1072, label %1073, label %1086

1073:
  %1074 = phi double [ %1081, %1073 ], [ 0.000000e+00, %1051 ]
  %1075 = phi i64 [ %1076, %1073 ], [ %1052, %1051 ]
  %1076 = add nsw i64 %1075, -1
  %1077 = getelementptr inbounds double, ptr %1071, i64 %1076
  %1078 = load double, ptr %1077, align 8
  %1079 = tail call double @llvm.fabs.f64(double %1078)
  %1080 = fcmp ogt double %1079, %1074
  %1081 = select i1 %1080, double %1079, double %1074
  %1082 = icmp samesign ugt i64 %1075, 1
  br i1 %1082, label %1073, label %1083

1083:
  %1084 = fadd double %1081, 1.000000e+00
  %1085 = fmul double %1084, 0x3EB0C6F7A0B5ED8D
  br label %1086

1086:
  %1087 = phi double [ 0x3EB0C6F7A0B5ED8D, %1051 ], [ %1085, %1083 ]
  br i1 %994, label %1088, label %1104

1088:
  %1089 = load i64, ptr %23, align 8
  %1090 = load i64, ptr %29, align 8
  %1091 = sub nsw i64 %1089, %1090
  %1092 = load ptr, ptr %41, align 8
  %1093 = getelementptr double, ptr %22, i64 %1091
  br label %1094

1094:
  %1095 = phi i64 [ 0, %1088 ], [ %1102, %1094 ]
  %1096 = getelementptr inbounds nuw double, ptr %14, i64 %1095
  %1097 = load double, ptr %1096, align 8
  %1098 = getelementptr inbounds nuw i32, ptr %1092, i64 %1095
  %1099 = load i32, ptr %1098, align 4
  %1100 = sext i32 %1099 to i64
  %1101 = getelementptr double, ptr %1093, i64 %1100
  store double %1097, ptr %1101, align 8
  %1102 = add nuw nsw i64 %1095, 1
  %1103 = icmp eq i64 %1102, %993
  br i1 %1103, label %1104, label %1094

1104:
  %1105 = load ptr, ptr %54, align 8
  tail call void %1105(ptr noundef %1066, ptr noundef %25, ptr noundef %22, ptr noundef %7)
  %1106 = load i64, ptr %32, align 8
  %1107 = icmp sgt i64 %1106, 0
  br i1 %1107, label %1108, label %1121

1108:
  %1109 = load i64, ptr %30, align 8
  %1110 = mul nsw i64 %1109, %1106
  %1111 = add i64 %1109, 2
  %1112 = mul i64 %1111, %1106
  %1113 = load i64, ptr %44, align 8
  %1114 = mul nuw nsw i64 %1106, %1106
  %1115 = getelementptr double, ptr %6, i64 %1112
  %1116 = shl i64 %1113, 4
  %1117 = getelementptr i8, ptr %1115, i64 %1116
  %1118 = getelementptr double, ptr %1117, i64 %1110
  %1119 = getelementptr double, ptr %1118, i64 %1114
  %1120 = add nuw nsw i64 %1106, 1
  br label %1130

1121:
  %1122 = phi double [ 0.000000e+00, %1104 ], [ %1160, %1150 ]
  %1123 = load i64, ptr %12, align 8
  %1124 = icmp sgt i64 %1123, 0
  br i1 %1124, label %1125, label %1298

1125:
  %1126 = load ptr, ptr %52, align 8
  %1127 = load ptr, ptr %42, align 8
  %1128 = add i64 %1106, 1
  %1129 = fneg double %1122
  br label %1163

1130:
  %1131 = phi i64 [ 0, %1108 ], [ %1161, %1150 ]
  %1132 = phi double [ 0.000000e+00, %1108 ], [ %1160, %1150 ]
  %1133 = getelementptr double, ptr %1060, i64 %1131
  %1134 = getelementptr double, ptr %1119, i64 %1131
  %1135 = load double, ptr %1134, align 8
  %1136 = tail call double @llvm.fabs.f64(double %1135)
  br label %1137

1137:
  %1138 = phi i64 [ 0, %1130 ], [ %1148, %1137 ]
  %1139 = phi double [ %1136, %1130 ], [ %1147, %1137 ]
  %1140 = mul nuw nsw i64 %1138, %1106
  %1141 = getelementptr double, ptr %1133, i64 %1140
  %1142 = load double, ptr %1141, align 8
  %1143 = getelementptr inbounds nuw double, ptr %88, i64 %1138
  %1144 = load double, ptr %1143, align 8
  %1145 = fmul double %1142, %1144
  %1146 = tail call double @llvm.fabs.f64(double %1145)
  %1147 = fadd double %1139, %1146
  %1148 = add nuw nsw i64 %1138, 1
  %1149 = icmp eq i64 %1148, %1106
  br i1 %1149, label %1150, label %1137

1150:
  %1151 = fmul double %1147, 0x3EB0C6F7A0B5ED8D
  %1152 = mul i64 %1131, %1120
  %1153 = getelementptr inbounds double, ptr %1060, i64 %1152
  %1154 = load double, ptr %1153, align 8
  %1155 = fcmp ogt double %1154, 1.000000e-300
  %1156 = select i1 %1155, double %1154, double 1.000000e-300
  %1157 = tail call double @llvm.sqrt.f64(double %1156)
  %1158 = fdiv double %1151, %1157
  %1159 = fcmp ogt double %1158, %1132
  %1160 = select i1 %1159, double %1158, double %1132
  %1161 = add nuw nsw i64 %1131, 1
  %1162 = icmp eq i64 %1161, %1106
  br i1 %1162, label %1121, label %1130

1163:
  %1164 = phi i64 [ 0, %1125 ], [ %1216, %1215 ]
  %1165 = getelementptr inbounds nuw i32, ptr %1126, i64 %1164
  %1166 = load i32, ptr %1165, align 4
  %1167 = getelementptr inbounds nuw i32, ptr %1127, i64 %1164
  %1168 = load i32, ptr %1167, align 4
  %1169 = sext i32 %1166 to i64
  %1170 = mul i64 %1128, %1169
  %1171 = getelementptr inbounds double, ptr %1060, i64 %1170
  %1172 = load double, ptr %1171, align 8
  %1173 = fcmp ogt double %1172, 1.000000e-300
  %1174 = select i1 %1173, double %1172, double 1.000000e-300
  %1175 = tail call double @llvm.sqrt.f64(double %1174)
  %1176 = getelementptr inbounds i32, ptr %110, i64 %1169
  %1177 = load i32, ptr %1176, align 4
  %1178 = icmp eq i32 %1177, 0
  br i1 %1178, label %1215, label %1179

1179:
  %1180 = getelementptr inbounds nuw double, ptr %14, i64 %1164
  %1181 = load double, ptr %1180, align 8
  %1182 = fcmp oeq double %1181, 0.000000e+00
  br i1 %1182, label %1183, label %1203

1183:
  %1184 = getelementptr inbounds double, ptr %1067, i64 %1169
  %1185 = load double, ptr %1184, align 8
  %1186 = tail call double @llvm.fabs.f64(double %1185)
  %1187 = fcmp ogt double %1186, %1087
  br i1 %1187, label %1297, label %1188

1188:
  %1189 = getelementptr inbounds nuw double, ptr %1066, i64 %1164
  %1190 = load double, ptr %1189, align 8
  %1191 = fdiv double %1122, %1175
  %1192 = load i64, ptr %30, align 8
  %1193 = add i64 %1192, 1
  %1194 = mul i64 %1193, %1106
  %1195 = getelementptr double, ptr %6, i64 %1194
  %1196 = getelementptr double, ptr %1195, i64 %1169
  %1197 = load double, ptr %1196, align 8
  %1198 = tail call double @llvm.fabs.f64(double %1197)
  %1199 = fmul double %1198, 0x3EB0C6F7A0B5ED8D
  %1200 = fadd double %1191, %1199
  %1201 = fneg double %1200
  %1202 = fcmp olt double %1190, %1201
  br i1 %1202, label %1297, label %1215

1203:
  %1204 = icmp eq i32 %1168, 0
  %1205 = fcmp olt double %1181, 0.000000e+00
  %1206 = or i1 %1204, %1205
  br i1 %1206, label %1207, label %1215

1207:
  %1208 = sitofp i32 %1168 to double
  %1209 = select i1 %1204, double %1181, double %1208
  %1210 = getelementptr inbounds double, ptr %1068, i64 %1169
  %1211 = load double, ptr %1210, align 8
  %1212 = fmul double %1209, %1211
  %1213 = fmul double %1175, %1129
  %1214 = fcmp olt double %1212, %1213
  br i1 %1214, label %1297, label %1215

1215:
  %1216 = add nuw nsw i64 %1164, 1
  %1217 = icmp eq i64 %1216, %1123
  br i1 %1217, label %1218, label %1163

1218:
  %1219 = phi i64 [ %990, %1050 ], [ %1106, %1215 ]
  %1220 = phi i64 [ %993, %1050 ], [ %1123, %1215 ]
  %1221 = icmp sgt i64 %1220, 0
  br i1 %1221, label %1222, label %1298

1222:
  %1223 = load ptr, ptr %42, align 8
  %1224 = load i64, ptr %30, align 8
  %1225 = mul nsw i64 %1224, %1219
  %1226 = add i64 %1224, 2
  %1227 = mul i64 %1226, %1219
  %1228 = load i64, ptr %44, align 8
  %1229 = mul nsw i64 %1219, %1219
  %1230 = load ptr, ptr %52, align 8
  %1231 = getelementptr double, ptr %6, i64 %1227
  %1232 = shl i64 %1228, 4
  %1233 = getelementptr i8, ptr %1231, i64 %1232
  %1234 = getelementptr double, ptr %1233, i64 %1225
  %1235 = getelementptr double, ptr %1234, i64 %1229
  %1236 = trunc i64 %1219 to i32
  %1237 = icmp sgt i32 %1236, 0
  %1238 = and i64 %1219, 2147483647
  %1239 = getelementptr double, ptr %6, i64 %1225
  br label %1240

1240:
  %1241 = phi i64 [ 0, %1222 ], [ %1293, %1291 ]
  %1242 = phi i32 [ 0, %1222 ], [ %1292, %1291 ]
  %1243 = getelementptr inbounds nuw i32, ptr %1223, i64 %1241
  %1244 = load i32, ptr %1243, align 4
  %1245 = sitofp i32 %1244 to double
  %1246 = getelementptr inbounds nuw i32, ptr %1230, i64 %1241
  %1247 = load i32, ptr %1246, align 4
  %1248 = sext i32 %1247 to i64
  %1249 = getelementptr double, ptr %1235, i64 %1248
  %1250 = load double, ptr %1249, align 8
  br i1 %1237, label %1251, label %1265

1251:
  %1252 = getelementptr double, ptr %1234, i64 %1248
  br label %1253

1253:
  %1254 = phi i64 [ 0, %1251 ], [ %1263, %1253 ]
  %1255 = phi double [ 0.000000e+00, %1251 ], [ %1262, %1253 ]
  %1256 = mul nuw nsw i64 %1254, %1238
  %1257 = getelementptr double, ptr %1252, i64 %1256
  %1258 = load double, ptr %1257, align 8
  %1259 = getelementptr inbounds nuw double, ptr %88, i64 %1254
  %1260 = load double, ptr %1259, align 8
  %1261 = fmul double %1258, %1260
  %1262 = fadd double %1255, %1261
  %1263 = add nuw nsw i64 %1254, 1
  %1264 = icmp eq i64 %1263, %1238
  br i1 %1264, label %1265, label %1253

1265:
  %1266 = phi double [ 0.000000e+00, %1240 ], [ %1262, %1253 ]
  %1267 = fadd double %1250, %1266
  %1268 = getelementptr double, ptr %1239, i64 %1248
  %1269 = load double, ptr %1268, align 8
  %1270 = fmul double %1269, %1245
  %1271 = getelementptr inbounds nuw i32, ptr %109, i64 %1241
  %1272 = load i32, ptr %1271, align 4
  %1273 = icmp eq i32 %1272, 0
  br i1 %1273, label %1291, label %1274

1274:
  %1275 = getelementptr inbounds nuw i32, ptr %17, i64 %1241
  %1276 = load i32, ptr %1275, align 4
  %1277 = icmp eq i32 %1276, 0
  br i1 %1277, label %1278, label %1291

1278:
  %1279 = fmul double %1270, 2.000000e+00
  %1280 = fcmp ogt double %1279, 0.000000e+00
  br i1 %1280, label %1281, label %1291

1281:
  %1282 = fneg double %1245
  %1283 = fmul double %1267, %1282
  %1284 = getelementptr inbounds nuw double, ptr %89, i64 %1241
  %1285 = load double, ptr %1284, align 8
  %1286 = fsub double 1.000000e+00, %1285
  %1287 = fmul double %1283, %1286
  %1288 = fmul double %1287, 1.000000e-04
  %1289 = fcmp olt double %1279, %1288
  br i1 %1289, label %1290, label %1291

1290:
  store i32 1, ptr %1275, align 4
  br label %1291

1291:
  %1292 = phi i32 [ %1242, %1274 ], [ 1, %1290 ], [ %1242, %1281 ], [ %1242, %1278 ], [ %1242, %1265 ]
  %1293 = add nuw nsw i64 %1241, 1
  %1294 = icmp eq i64 %1293, %1220
  br i1 %1294, label %1295, label %1240

1295:
  %1296 = icmp eq i32 %1292, 0
  br i1 %1296, label %1299, label %55

1297:
  br label %1316

1298:
  br label %1299

1299:
  %1300 = load i64, ptr %26, align 8
  %1301 = shl i64 %1300, 3
  tail call void @llvm.memcpy.p0.p0.i64(ptr align 8 %1, ptr align 8 %25, i64 %1301, i1 false)
  %1302 = load i64, ptr %12, align 8
  %1303 = icmp sgt i64 %1302, 0
  br i1 %1303, label %1304, label %1316

1304:
  %1305 = load ptr, ptr %41, align 8
  br label %1306

1306:
  %1307 = phi i64 [ 0, %1304 ], [ %1314, %1306 ]
  %1308 = getelementptr inbounds nuw double, ptr %14, i64 %1307
  %1309 = load double, ptr %1308, align 8
  %1310 = getelementptr inbounds nuw i32, ptr %1305, i64 %1307
  %1311 = load i32, ptr %1310, align 4
  %1312 = sext i32 %1311 to i64
  %1313 = getelementptr inbounds double, ptr %2, i64 %1312
  store double %1309, ptr %1313, align 8
  %1314 = add nuw nsw i64 %1307, 1
  %1315 = icmp eq i64 %1314, %1302
  br i1 %1315, label %1316, label %1306

1316:
  %1317 = phi i32 [ 0, %1297 ], [ 1, %1299 ], [ 1, %1306 ]
  ret i32 %1317
}

define range(i32 0, 2) i32 @next_jump(ptr noundef readonly captures(none) %0, ptr noundef writeonly captures(none) %1, ptr noundef %2, double noundef %3, double noundef %4, ptr noundef %5) {
  %7 = alloca %struct.Run, align 8
  %8 = getelementptr inbounds nuw i8, ptr %7, i64 136
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(32) %8, i8 0, i64 32, i1 false)
  %9 = getelementptr inbounds nuw i8, ptr %7, i64 120
  store ptr %2, ptr %9, align 8
  %10 = getelementptr inbounds nuw i8, ptr %0, i64 40
  %11 = load i64, ptr %10, align 8
  %12 = getelementptr inbounds double, ptr %2, i64 %11
  %13 = load double, ptr %12, align 8
  %14 = getelementptr inbounds nuw i8, ptr %7, i64 128
  store double %13, ptr %14, align 8
  %15 = getelementptr inbounds nuw i8, ptr %0, i64 112
  %16 = load i64, ptr %15, align 8
  %17 = getelementptr inbounds double, ptr %5, i64 %16
  %18 = getelementptr inbounds nuw i8, ptr %7, i64 8
  store ptr %17, ptr %18, align 8
  %19 = getelementptr inbounds nuw i8, ptr %7, i64 16
  store ptr %5, ptr %19, align 8
  %20 = getelementptr inbounds nuw i8, ptr %0, i64 16
  %21 = load i64, ptr %20, align 8
  %22 = getelementptr inbounds double, ptr %5, i64 %21
  %23 = getelementptr inbounds nuw i8, ptr %7, i64 24
  store ptr %22, ptr %23, align 8
  %24 = getelementptr inbounds double, ptr %22, i64 %21
  %25 = getelementptr inbounds nuw i8, ptr %7, i64 32
  store ptr %24, ptr %25, align 8
  %26 = getelementptr inbounds double, ptr %24, i64 %21
  %27 = getelementptr inbounds nuw i8, ptr %7, i64 40
  store ptr %26, ptr %27, align 8
  %28 = load i64, ptr %0, align 8
  %29 = getelementptr inbounds double, ptr %26, i64 %28
  %30 = getelementptr inbounds nuw i8, ptr %7, i64 48
  store ptr %29, ptr %30, align 8
  %31 = getelementptr inbounds nuw i8, ptr %0, i64 24
  %32 = load i64, ptr %31, align 8
  %33 = getelementptr inbounds double, ptr %29, i64 %32
  %34 = getelementptr inbounds nuw i8, ptr %0, i64 32
  %35 = load i64, ptr %34, align 8
  %36 = getelementptr inbounds double, ptr %33, i64 %35
  %37 = getelementptr inbounds nuw i8, ptr %7, i64 56
  store ptr %36, ptr %37, align 8
  %38 = getelementptr inbounds double, ptr %36, i64 %35
  %39 = getelementptr inbounds nuw i8, ptr %7, i64 64
  store ptr %38, ptr %39, align 8
  %40 = getelementptr inbounds nuw i8, ptr %0, i64 56
  %41 = load i64, ptr %40, align 8
  %42 = mul i64 %41, 4000
  %43 = getelementptr i8, ptr %38, i64 %42
  %44 = getelementptr i8, ptr %43, i64 4000
  %45 = getelementptr inbounds nuw i8, ptr %7, i64 72
  store ptr %44, ptr %45, align 8
  %46 = getelementptr inbounds nuw i8, ptr %0, i64 336
  %47 = load i64, ptr %46, align 8
  %48 = getelementptr inbounds double, ptr %44, i64 %47
  %49 = getelementptr inbounds nuw i8, ptr %7, i64 80
  store ptr %48, ptr %49, align 8
  %50 = getelementptr double, ptr %48, i64 %41
  %51 = getelementptr i8, ptr %50, i64 8
  %52 = getelementptr inbounds nuw i8, ptr %7, i64 88
  store ptr %51, ptr %52, align 8
  %53 = getelementptr double, ptr %51, i64 %41
  %54 = getelementptr i8, ptr %53, i64 8
  %55 = getelementptr inbounds nuw i8, ptr %7, i64 96
  store ptr %54, ptr %55, align 8
  %56 = getelementptr inbounds nuw i8, ptr %0, i64 72
  %57 = load i64, ptr %56, align 8
  %58 = getelementptr inbounds double, ptr %54, i64 %57
  %59 = getelementptr inbounds nuw i8, ptr %7, i64 112
  store ptr %58, ptr %59, align 8
  %60 = shl nsw i64 %57, 5
  %61 = getelementptr inbounds i8, ptr %58, i64 %60
  %62 = getelementptr inbounds nuw i8, ptr %7, i64 104
  store ptr %61, ptr %62, align 8
  %63 = getelementptr inbounds nuw i8, ptr %61, i64 1536
  %64 = getelementptr inbounds nuw i8, ptr %0, i64 344
  %65 = load i64, ptr %64, align 8
  %66 = getelementptr inbounds double, ptr %63, i64 %65
  %67 = getelementptr inbounds nuw i8, ptr %7, i64 152
  store ptr %66, ptr %67, align 8
  %68 = shl i64 %32, 3
  tail call void @llvm.memcpy.p0.p0.i64(ptr align 8 %29, ptr align 8 %2, i64 %68, i1 false)
  %69 = load i64, ptr %31, align 8
  %70 = getelementptr inbounds double, ptr %29, i64 %69
  %71 = load i64, ptr %34, align 8
  %72 = shl i64 %71, 3
  tail call void @llvm.memcpy.p0.p0.i64(ptr align 8 %70, ptr align 8 %2, i64 %72, i1 false)
  %73 = load i64, ptr %0, align 8
  %74 = getelementptr inbounds nuw i8, ptr %0, i64 96
  %75 = load i64, ptr %74, align 8
  %76 = getelementptr double, ptr %63, i64 %73
  %77 = getelementptr double, ptr %76, i64 %75
  %78 = add nsw i64 %75, %73
  %79 = sub i64 0, %78
  %80 = getelementptr inbounds double, ptr %77, i64 %79
  %81 = load i64, ptr %10, align 8
  %82 = getelementptr inbounds double, ptr %2, i64 %81
  %83 = load double, ptr %82, align 8
  %84 = fmul double %83, 6.400000e+01
  %85 = shl i64 %78, 3
  tail call void @llvm.memset.p0.i64(ptr align 8 %80, i8 0, i64 %85, i1 false)
  store ptr %80, ptr %7, align 8
  %86 = load i64, ptr %34, align 8
  %87 = shl i64 %86, 3
  tail call void @llvm.memcpy.p0.p0.i64(ptr align 8 %36, ptr align 8 %2, i64 %87, i1 false)
  %88 = load i64, ptr %0, align 8
  %89 = getelementptr inbounds double, ptr %80, i64 %88
  store double -1.000000e+300, ptr %89, align 8
  br label %90

90:
  %91 = phi double [ %3, %6 ], [ %114, %132 ]
  %92 = phi double [ %84, %6 ], [ %134, %132 ]
  %93 = fadd double %91, %92
  %94 = fcmp olt double %93, %4
  %95 = select i1 %94, double %93, double %4
  %96 = call fastcc i32 @changes(ptr noundef nonnull %0, ptr noundef %7, double noundef %91, double noundef %95, ptr noundef %61)
  %97 = icmp slt i32 %96, 0
  br i1 %97, label %98, label %112

98:
  %99 = phi double [ %106, %105 ], [ %92, %90 ]
  %100 = load i64, ptr %10, align 8
  %101 = getelementptr inbounds double, ptr %2, i64 %100
  %102 = load double, ptr %101, align 8
  %103 = fmul double %102, 0x3EB0C6F7A0B5ED8D
  %104 = fcmp olt double %99, %103
  br i1 %104, label %135, label %105

105:
  %106 = fmul double %99, 5.000000e-01
  %107 = fadd double %91, %106
  %108 = fcmp olt double %107, %4
  %109 = select i1 %108, double %107, double %4
  %110 = call fastcc i32 @changes(ptr noundef nonnull %0, ptr noundef %7, double noundef %91, double noundef %109, ptr noundef %61)
  %111 = icmp slt i32 %110, 0
  br i1 %111, label %98, label %112

112:
  %113 = phi double [ %92, %90 ], [ %106, %105 ]
  %114 = phi double [ %95, %90 ], [ %109, %105 ]
  %115 = phi i32 [ %96, %90 ], [ %110, %105 ]
  %116 = icmp eq i32 %115, 0
  %117 = fcmp ult double %114, %4
  %118 = and i1 %116, %117
  br i1 %118, label %132, label %119

119:
  br i1 %116, label %120, label %122

120:
  store double %4, ptr %1, align 8
  %121 = getelementptr inbounds nuw i8, ptr %1, i64 8
  store double %4, ptr %121, align 8
  br label %129

122:
  %123 = load double, ptr %61, align 8
  store double %123, ptr %1, align 8
  %124 = getelementptr inbounds nuw i8, ptr %61, i64 8
  %125 = load double, ptr %124, align 8
  %126 = getelementptr inbounds nuw i8, ptr %1, i64 8
  store double %125, ptr %126, align 8
  %127 = getelementptr inbounds nuw i8, ptr %61, i64 16
  %128 = load double, ptr %127, align 8
  br label %129

129:
  %130 = phi double [ %128, %122 ], [ %4, %120 ]
  %131 = getelementptr inbounds nuw i8, ptr %1, i64 16
  store double %130, ptr %131, align 8
  br label %135

132:
  %133 = fmul double %113, 5.000000e-01
  %134 = fmul double %133, 4.000000e+00
  br label %90

135:
  %136 = phi i32 [ 1, %129 ], [ 0, %98 ]
  ret i32 %136
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
  %22 = getelementptr inbounds nuw i8, ptr %1, i64 128
  %23 = getelementptr inbounds nuw i8, ptr %1, i64 96
  %24 = getelementptr inbounds nuw i8, ptr %0, i64 496
  %25 = getelementptr inbounds nuw i8, ptr %1, i64 8
  br label %31

26:
  %27 = icmp sgt i32 %247, 0
  br i1 %27, label %28, label %293

28:
  %29 = getelementptr inbounds nuw i8, ptr %1, i64 128
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
  %7 = getelementptr inbounds nuw i8, ptr %6, i64 136
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(32) %7, i8 0, i64 32, i1 false)
  store ptr %1, ptr %6, align 8
  %8 = getelementptr inbounds nuw i8, ptr %6, i64 120
  store ptr %2, ptr %8, align 8
  %9 = getelementptr inbounds nuw i8, ptr %0, i64 40
  %10 = load i64, ptr %9, align 8
  %11 = getelementptr inbounds double, ptr %2, i64 %10
  %12 = load double, ptr %11, align 8
  %13 = getelementptr inbounds nuw i8, ptr %6, i64 128
  store double %12, ptr %13, align 8
  %14 = getelementptr inbounds nuw i8, ptr %0, i64 112
  %15 = load i64, ptr %14, align 8
  %16 = getelementptr inbounds double, ptr %4, i64 %15
  %17 = getelementptr inbounds nuw i8, ptr %6, i64 8
  store ptr %16, ptr %17, align 8
  %18 = getelementptr inbounds nuw i8, ptr %6, i64 16
  store ptr %4, ptr %18, align 8
  %19 = getelementptr inbounds nuw i8, ptr %0, i64 16
  %20 = load i64, ptr %19, align 8
  %21 = getelementptr inbounds double, ptr %4, i64 %20
  %22 = getelementptr inbounds nuw i8, ptr %6, i64 24
  store ptr %21, ptr %22, align 8
  %23 = getelementptr inbounds double, ptr %21, i64 %20
  %24 = getelementptr inbounds nuw i8, ptr %6, i64 32
  store ptr %23, ptr %24, align 8
  %25 = getelementptr inbounds double, ptr %23, i64 %20
  %26 = getelementptr inbounds nuw i8, ptr %6, i64 40
  store ptr %25, ptr %26, align 8
  %27 = load i64, ptr %0, align 8
  %28 = getelementptr inbounds double, ptr %25, i64 %27
  %29 = getelementptr inbounds nuw i8, ptr %6, i64 48
  store ptr %28, ptr %29, align 8
  %30 = getelementptr inbounds nuw i8, ptr %0, i64 24
  %31 = load i64, ptr %30, align 8
  %32 = getelementptr inbounds double, ptr %28, i64 %31
  %33 = getelementptr inbounds nuw i8, ptr %0, i64 32
  %34 = load i64, ptr %33, align 8
  %35 = getelementptr inbounds double, ptr %32, i64 %34
  %36 = getelementptr inbounds nuw i8, ptr %6, i64 56
  store ptr %35, ptr %36, align 8
  %37 = getelementptr inbounds double, ptr %35, i64 %34
  %38 = getelementptr inbounds nuw i8, ptr %6, i64 64
  store ptr %37, ptr %38, align 8
  %39 = getelementptr inbounds nuw i8, ptr %0, i64 56
  %40 = load i64, ptr %39, align 8
  %41 = mul i64 %40, 4000
  %42 = getelementptr i8, ptr %37, i64 %41
  %43 = getelementptr i8, ptr %42, i64 4000
  %44 = getelementptr inbounds nuw i8, ptr %6, i64 72
  store ptr %43, ptr %44, align 8
  %45 = getelementptr inbounds nuw i8, ptr %0, i64 336
  %46 = load i64, ptr %45, align 8
  %47 = getelementptr inbounds double, ptr %43, i64 %46
  %48 = getelementptr inbounds nuw i8, ptr %6, i64 80
  store ptr %47, ptr %48, align 8
  %49 = getelementptr double, ptr %47, i64 %40
  %50 = getelementptr i8, ptr %49, i64 8
  %51 = getelementptr inbounds nuw i8, ptr %6, i64 88
  store ptr %50, ptr %51, align 8
  %52 = getelementptr double, ptr %50, i64 %40
  %53 = getelementptr i8, ptr %52, i64 8
  %54 = getelementptr inbounds nuw i8, ptr %6, i64 96
  store ptr %53, ptr %54, align 8
  %55 = getelementptr inbounds nuw i8, ptr %0, i64 72
  %56 = load i64, ptr %55, align 8
  %57 = getelementptr inbounds double, ptr %53, i64 %56
  %58 = getelementptr inbounds nuw i8, ptr %6, i64 112
  store ptr %57, ptr %58, align 8
  %59 = shl nsw i64 %56, 5
  %60 = getelementptr inbounds i8, ptr %57, i64 %59
  %61 = getelementptr inbounds nuw i8, ptr %6, i64 104
  store ptr %60, ptr %61, align 8
  %62 = getelementptr inbounds nuw i8, ptr %60, i64 1536
  %63 = getelementptr inbounds nuw i8, ptr %0, i64 344
  %64 = load i64, ptr %63, align 8
  %65 = getelementptr inbounds double, ptr %62, i64 %64
  %66 = getelementptr inbounds nuw i8, ptr %6, i64 152
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
  %74 = load i64, ptr %0, align 8
  %75 = getelementptr inbounds double, ptr %1, i64 %74
  %76 = getelementptr inbounds nuw i8, ptr %0, i64 96
  %77 = load i64, ptr %76, align 8
  %78 = shl i64 %77, 3
  tail call void @llvm.memset.p0.i64(ptr align 8 %75, i8 0, i64 %78, i1 false)
  %79 = load i64, ptr %0, align 8
  %80 = getelementptr inbounds double, ptr %1, i64 %79
  store double %3, ptr %80, align 8
  %81 = load i64, ptr %55, align 8
  %82 = icmp eq i64 %81, 0
  br i1 %82, label %145, label %83

83:
  %84 = load i64, ptr %9, align 8
  %85 = shl i64 %84, 3
  tail call void @llvm.memcpy.p0.p0.i64(ptr align 8 %35, ptr nonnull align 8 %2, i64 %85, i1 false)
  %86 = load i64, ptr %9, align 8
  %87 = load i64, ptr %33, align 8
  %88 = icmp slt i64 %86, %87
  br i1 %88, label %89, label %101

89:
  %90 = getelementptr inbounds double, ptr %2, i64 %86
  br label %91

91:
  %92 = phi i64 [ %86, %89 ], [ %99, %91 ]
  %93 = getelementptr inbounds double, ptr %2, i64 %92
  %94 = load double, ptr %93, align 8
  %95 = load double, ptr %90, align 8
  %96 = fdiv double %12, %95
  %97 = fmul double %94, %96
  %98 = getelementptr inbounds double, ptr %35, i64 %92
  store double %97, ptr %98, align 8
  %99 = add nsw i64 %92, 1
  %100 = icmp eq i64 %99, %87
  br i1 %100, label %101, label %91

101:
  %102 = getelementptr inbounds double, ptr %35, i64 %86
  %103 = getelementptr inbounds nuw i8, ptr %0, i64 48
  %104 = load i64, ptr %103, align 8
  %105 = sub i64 0, %104
  %106 = getelementptr inbounds double, ptr %102, i64 %105
  %107 = getelementptr inbounds nuw i8, ptr %0, i64 120
  %108 = load i64, ptr %107, align 8
  %109 = getelementptr inbounds double, ptr %1, i64 %108
  %110 = shl i64 %104, 3
  tail call void @llvm.memcpy.p0.p0.i64(ptr align 8 %106, ptr align 8 %109, i64 %110, i1 false)
  %111 = fmul double %12, 2.000000e-09
  %112 = fsub double %3, %111
  %113 = fadd double %3, %111
  %114 = call fastcc i32 @changes(ptr noundef nonnull readonly %0, ptr noundef nonnull readonly %6, double noundef %112, double noundef %113, ptr noundef %60)
  %115 = icmp slt i32 %114, 1
  br i1 %115, label %141, label %116

116:
  %117 = load i64, ptr %0, align 8
  %118 = getelementptr inbounds double, ptr %1, i64 %117
  %119 = load double, ptr %118, align 8
  %120 = fmul double %12, 0.000000e+00
  %121 = fadd double %120, %119
  %122 = fmul double %12, 1.000000e-09
  br label %123

123:
  %124 = phi double [ 0xFFF0000000000000, %116 ], [ %137, %136 ]
  %125 = phi i32 [ %114, %116 ], [ %138, %136 ]
  %126 = phi ptr [ %60, %116 ], [ %139, %136 ]
  %127 = load double, ptr %126, align 8
  %128 = fsub double %127, %121
  %129 = tail call double @llvm.fabs.f64(double %128)
  %130 = fcmp ogt double %129, %122
  br i1 %130, label %136, label %131

131:
  %132 = getelementptr inbounds nuw i8, ptr %126, i64 16
  %133 = load double, ptr %132, align 8
  %134 = fcmp ogt double %133, %124
  br i1 %134, label %135, label %136

135:
  br label %136

136:
  %137 = phi double [ %124, %131 ], [ %133, %135 ], [ %124, %123 ]
  %138 = add nsw i32 %125, -1
  %139 = getelementptr inbounds nuw i8, ptr %126, i64 24
  %140 = icmp sgt i32 %125, 1
  br i1 %140, label %123, label %141

141:
  %142 = phi double [ 0xFFF0000000000000, %101 ], [ %137, %136 ]
  %143 = fcmp ogt double %142, %3
  %144 = select i1 %143, double %142, double %3
  br label %145

145:
  %146 = phi double [ %144, %141 ], [ %3, %5 ]
  store double %146, ptr %1, align 8
  %147 = load i64, ptr %39, align 8
  %148 = icmp eq i64 %147, 0
  br i1 %148, label %201, label %149

149:
  %150 = icmp sgt i64 %147, 0
  br i1 %150, label %151, label %161

151:
  %152 = getelementptr inbounds nuw i8, ptr %0, i64 184
  %153 = load i64, ptr %152, align 8
  %154 = icmp sgt i64 %153, -1
  %155 = getelementptr inbounds nuw double, ptr %1, i64 %153
  br i1 %154, label %156, label %161

156:
  %157 = phi i64 [ %159, %156 ], [ 0, %151 ]
  %158 = getelementptr inbounds nuw double, ptr %155, i64 %157
  store double -1.000000e+300, ptr %158, align 8
  %159 = add nuw nsw i64 %157, 1
  %160 = icmp eq i64 %159, %147
  br i1 %160, label %161, label %156

161:
  %162 = getelementptr inbounds nuw i8, ptr %0, i64 296
  %163 = load i64, ptr %162, align 8
  %164 = icmp sgt i64 %163, 0
  br i1 %164, label %165, label %200

165:
  %166 = getelementptr inbounds nuw i8, ptr %0, i64 320
  %167 = load i64, ptr %166, align 8
  %168 = getelementptr inbounds double, ptr %43, i64 %167
  %169 = getelementptr inbounds nuw i8, ptr %0, i64 328
  %170 = load i64, ptr %169, align 8
  %171 = getelementptr inbounds double, ptr %168, i64 %170
  %172 = getelementptr inbounds nuw i8, ptr %0, i64 464
  %173 = load ptr, ptr %172, align 8
  tail call void %173(ptr noundef %43, ptr noundef nonnull %1, ptr noundef %2, ptr noundef %16)
  %174 = load i64, ptr %9, align 8
  %175 = shl i64 %174, 3
  tail call void @llvm.memcpy.p0.p0.i64(ptr align 8 %171, ptr align 8 %2, i64 %175, i1 false)
  %176 = getelementptr inbounds nuw i8, ptr %0, i64 472
  %177 = load ptr, ptr %176, align 8
  tail call void %177(ptr noundef %168, ptr noundef %43, ptr noundef %171, ptr noundef %16)
  %178 = load i64, ptr %162, align 8
  %179 = icmp sgt i64 %178, 0
  br i1 %179, label %180, label %200

180:
  %181 = getelementptr inbounds nuw i8, ptr %0, i64 288
  %182 = load i64, ptr %181, align 8
  %183 = getelementptr inbounds nuw i8, ptr %0, i64 304
  %184 = load i64, ptr %183, align 8
  %185 = add i64 %184, 2
  %186 = mul i64 %185, %182
  %187 = getelementptr double, ptr %168, i64 %186
  br label %191

188:
  %189 = add nuw nsw i64 %192, 1
  %190 = icmp eq i64 %189, %178
  br i1 %190, label %200, label %191

191:
  %192 = phi i64 [ 0, %180 ], [ %189, %188 ]
  %193 = getelementptr double, ptr %187, i64 %192
  %194 = load double, ptr %193, align 8
  %195 = fcmp ult double %194, -1.000000e-09
  br i1 %195, label %196, label %188

196:
  %197 = load i64, ptr %0, align 8
  %198 = getelementptr double, ptr %1, i64 %197
  %199 = getelementptr i8, ptr %198, i64 8
  store double 6.000000e+00, ptr %199, align 8
  br label %201

200:
  call fastcc void @look_anew(ptr noundef nonnull %0, ptr noundef nonnull readonly %6, ptr nonnull %62, ptr %68)
  br label %201

201:
  ret void
}

define void @look_again(ptr noundef %0, ptr noundef %1, ptr noundef %2, ptr noundef %3) {
  %5 = alloca %struct.Run, align 8
  %6 = getelementptr inbounds nuw i8, ptr %5, i64 136
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(32) %6, i8 0, i64 32, i1 false)
  store ptr %1, ptr %5, align 8
  %7 = getelementptr inbounds nuw i8, ptr %5, i64 120
  store ptr %2, ptr %7, align 8
  %8 = getelementptr inbounds nuw i8, ptr %0, i64 40
  %9 = load i64, ptr %8, align 8
  %10 = getelementptr inbounds double, ptr %2, i64 %9
  %11 = load double, ptr %10, align 8
  %12 = getelementptr inbounds nuw i8, ptr %5, i64 128
  store double %11, ptr %12, align 8
  %13 = getelementptr inbounds nuw i8, ptr %0, i64 112
  %14 = load i64, ptr %13, align 8
  %15 = getelementptr inbounds double, ptr %3, i64 %14
  %16 = getelementptr inbounds nuw i8, ptr %5, i64 8
  store ptr %15, ptr %16, align 8
  %17 = getelementptr inbounds nuw i8, ptr %5, i64 16
  store ptr %3, ptr %17, align 8
  %18 = getelementptr inbounds nuw i8, ptr %0, i64 16
  %19 = load i64, ptr %18, align 8
  %20 = getelementptr inbounds double, ptr %3, i64 %19
  %21 = getelementptr inbounds nuw i8, ptr %5, i64 24
  store ptr %20, ptr %21, align 8
  %22 = getelementptr inbounds double, ptr %20, i64 %19
  %23 = getelementptr inbounds nuw i8, ptr %5, i64 32
  store ptr %22, ptr %23, align 8
  %24 = getelementptr inbounds double, ptr %22, i64 %19
  %25 = getelementptr inbounds nuw i8, ptr %5, i64 40
  store ptr %24, ptr %25, align 8
  %26 = load i64, ptr %0, align 8
  %27 = getelementptr inbounds double, ptr %24, i64 %26
  %28 = getelementptr inbounds nuw i8, ptr %5, i64 48
  store ptr %27, ptr %28, align 8
  %29 = getelementptr inbounds nuw i8, ptr %0, i64 24
  %30 = load i64, ptr %29, align 8
  %31 = getelementptr inbounds double, ptr %27, i64 %30
  %32 = getelementptr inbounds nuw i8, ptr %0, i64 32
  %33 = load i64, ptr %32, align 8
  %34 = getelementptr inbounds double, ptr %31, i64 %33
  %35 = getelementptr inbounds nuw i8, ptr %5, i64 56
  store ptr %34, ptr %35, align 8
  %36 = getelementptr inbounds double, ptr %34, i64 %33
  %37 = getelementptr inbounds nuw i8, ptr %5, i64 64
  store ptr %36, ptr %37, align 8
  %38 = getelementptr inbounds nuw i8, ptr %0, i64 56
  %39 = load i64, ptr %38, align 8
  %40 = mul i64 %39, 4000
  %41 = getelementptr i8, ptr %36, i64 %40
  %42 = getelementptr i8, ptr %41, i64 4000
  %43 = getelementptr inbounds nuw i8, ptr %5, i64 72
  store ptr %42, ptr %43, align 8
  %44 = getelementptr inbounds nuw i8, ptr %0, i64 336
  %45 = load i64, ptr %44, align 8
  %46 = getelementptr inbounds double, ptr %42, i64 %45
  %47 = getelementptr inbounds nuw i8, ptr %5, i64 80
  store ptr %46, ptr %47, align 8
  %48 = getelementptr double, ptr %46, i64 %39
  %49 = getelementptr i8, ptr %48, i64 8
  %50 = getelementptr inbounds nuw i8, ptr %5, i64 88
  store ptr %49, ptr %50, align 8
  %51 = getelementptr double, ptr %49, i64 %39
  %52 = getelementptr i8, ptr %51, i64 8
  %53 = getelementptr inbounds nuw i8, ptr %5, i64 96
  store ptr %52, ptr %53, align 8
  %54 = getelementptr inbounds nuw i8, ptr %0, i64 72
  %55 = load i64, ptr %54, align 8
  %56 = getelementptr inbounds double, ptr %52, i64 %55
  %57 = getelementptr inbounds nuw i8, ptr %5, i64 112
  store ptr %56, ptr %57, align 8
  %58 = shl nsw i64 %55, 5
  %59 = getelementptr inbounds i8, ptr %56, i64 %58
  %60 = getelementptr inbounds nuw i8, ptr %5, i64 104
  store ptr %59, ptr %60, align 8
  %61 = getelementptr inbounds nuw i8, ptr %59, i64 1536
  %62 = getelementptr inbounds nuw i8, ptr %0, i64 344
  %63 = load i64, ptr %62, align 8
  %64 = getelementptr inbounds double, ptr %61, i64 %63
  %65 = getelementptr inbounds nuw i8, ptr %5, i64 152
  store ptr %64, ptr %65, align 8
  %66 = getelementptr i32, ptr %64, i64 %39
  %67 = getelementptr i8, ptr %66, i64 4
  %68 = shl i64 %30, 3
  tail call void @llvm.memcpy.p0.p0.i64(ptr align 8 %27, ptr align 8 %2, i64 %68, i1 false)
  %69 = load i64, ptr %29, align 8
  %70 = getelementptr inbounds double, ptr %27, i64 %69
  %71 = load i64, ptr %32, align 8
  %72 = shl i64 %71, 3
  tail call void @llvm.memcpy.p0.p0.i64(ptr align 8 %70, ptr align 8 %2, i64 %72, i1 false)
  call fastcc void @look_anew(ptr noundef nonnull %0, ptr noundef %5, ptr nonnull %61, ptr %67)
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
  %30 = getelementptr inbounds nuw i8, ptr %1, i64 128
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
  %70 = tail call fastcc i32 @decide(ptr noundef nonnull %0, ptr noundef %44, ptr noundef nonnull %19, ptr noundef %65, ptr noundef null, ptr noundef %55, ptr noundef %68, ptr noundef %69, ptr noundef nonnull byval(%struct.Room) align 8 %5)
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
  %6 = alloca i32, align 4
  %7 = alloca %struct.Run, align 8
  %8 = getelementptr inbounds nuw i8, ptr %7, i64 136
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(32) %8, i8 0, i64 32, i1 false)
  store ptr %1, ptr %7, align 8
  %9 = getelementptr inbounds nuw i8, ptr %7, i64 120
  store ptr %2, ptr %9, align 8
  %10 = getelementptr inbounds nuw i8, ptr %0, i64 40
  %11 = load i64, ptr %10, align 8
  %12 = getelementptr inbounds double, ptr %2, i64 %11
  %13 = load double, ptr %12, align 8
  %14 = getelementptr inbounds nuw i8, ptr %7, i64 128
  store double %13, ptr %14, align 8
  %15 = getelementptr inbounds nuw i8, ptr %0, i64 112
  %16 = load i64, ptr %15, align 8
  %17 = getelementptr inbounds double, ptr %3, i64 %16
  %18 = getelementptr inbounds nuw i8, ptr %7, i64 8
  store ptr %17, ptr %18, align 8
  %19 = getelementptr inbounds nuw i8, ptr %7, i64 16
  store ptr %3, ptr %19, align 8
  %20 = getelementptr inbounds nuw i8, ptr %0, i64 16
  %21 = load i64, ptr %20, align 8
  %22 = getelementptr inbounds double, ptr %3, i64 %21
  %23 = getelementptr inbounds nuw i8, ptr %7, i64 24
  store ptr %22, ptr %23, align 8
  %24 = getelementptr inbounds double, ptr %22, i64 %21
  %25 = getelementptr inbounds nuw i8, ptr %7, i64 32
  store ptr %24, ptr %25, align 8
  %26 = getelementptr inbounds double, ptr %24, i64 %21
  %27 = getelementptr inbounds nuw i8, ptr %7, i64 40
  store ptr %26, ptr %27, align 8
  %28 = load i64, ptr %0, align 8
  %29 = getelementptr inbounds double, ptr %26, i64 %28
  %30 = getelementptr inbounds nuw i8, ptr %7, i64 48
  store ptr %29, ptr %30, align 8
  %31 = getelementptr inbounds nuw i8, ptr %0, i64 24
  %32 = load i64, ptr %31, align 8
  %33 = getelementptr inbounds double, ptr %29, i64 %32
  %34 = getelementptr inbounds nuw i8, ptr %0, i64 32
  %35 = load i64, ptr %34, align 8
  %36 = getelementptr inbounds double, ptr %33, i64 %35
  %37 = getelementptr inbounds nuw i8, ptr %7, i64 56
  store ptr %36, ptr %37, align 8
  %38 = getelementptr inbounds double, ptr %36, i64 %35
  %39 = getelementptr inbounds nuw i8, ptr %7, i64 64
  store ptr %38, ptr %39, align 8
  %40 = getelementptr inbounds nuw i8, ptr %0, i64 56
  %41 = load i64, ptr %40, align 8
  %42 = mul i64 %41, 4000
  %43 = getelementptr i8, ptr %38, i64 %42
  %44 = getelementptr i8, ptr %43, i64 4000
  %45 = getelementptr inbounds nuw i8, ptr %7, i64 72
  store ptr %44, ptr %45, align 8
  %46 = getelementptr inbounds nuw i8, ptr %0, i64 336
  %47 = load i64, ptr %46, align 8
  %48 = getelementptr inbounds double, ptr %44, i64 %47
  %49 = getelementptr inbounds nuw i8, ptr %7, i64 80
  store ptr %48, ptr %49, align 8
  %50 = getelementptr double, ptr %48, i64 %41
  %51 = getelementptr i8, ptr %50, i64 8
  %52 = getelementptr inbounds nuw i8, ptr %7, i64 88
  store ptr %51, ptr %52, align 8
  %53 = getelementptr double, ptr %51, i64 %41
  %54 = getelementptr i8, ptr %53, i64 8
  %55 = getelementptr inbounds nuw i8, ptr %7, i64 96
  store ptr %54, ptr %55, align 8
  %56 = getelementptr inbounds nuw i8, ptr %0, i64 72
  %57 = load i64, ptr %56, align 8
  %58 = getelementptr inbounds double, ptr %54, i64 %57
  %59 = getelementptr inbounds nuw i8, ptr %7, i64 112
  store ptr %58, ptr %59, align 8
  %60 = shl nsw i64 %57, 5
  %61 = getelementptr inbounds i8, ptr %58, i64 %60
  %62 = getelementptr inbounds nuw i8, ptr %7, i64 104
  store ptr %61, ptr %62, align 8
  %63 = getelementptr inbounds nuw i8, ptr %61, i64 1536
  %64 = getelementptr inbounds nuw i8, ptr %0, i64 344
  %65 = load i64, ptr %64, align 8
  %66 = getelementptr inbounds double, ptr %63, i64 %65
  %67 = getelementptr inbounds nuw i8, ptr %7, i64 152
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
  %81 = fcmp olt double %78, %80
  br i1 %81, label %82, label %358

82:
  %83 = getelementptr inbounds nuw i8, ptr %0, i64 48
  %84 = getelementptr inbounds nuw i8, ptr %0, i64 120
  %85 = getelementptr inbounds nuw i8, ptr %0, i64 504
  %86 = getelementptr inbounds nuw i8, ptr %0, i64 400
  %87 = getelementptr inbounds nuw i8, ptr %0, i64 136
  %88 = getelementptr inbounds nuw i8, ptr %7, i64 160
  %89 = getelementptr inbounds nuw i8, ptr %0, i64 128
  %90 = getelementptr inbounds nuw i8, ptr %0, i64 360
  br label %91

91:
  %92 = phi double [ %78, %82 ], [ %354, %353 ]
  %93 = load i64, ptr %0, align 8
  %94 = getelementptr double, ptr %1, i64 %93
  %95 = getelementptr i8, ptr %94, i64 8
  %96 = load double, ptr %95, align 8
  %97 = fcmp oeq double %96, 0.000000e+00
  br i1 %97, label %98, label %358

98:
  %99 = fsub double %80, %92
  %100 = fcmp olt double %99, 6.400000e+01
  %101 = select i1 %100, double %99, double 6.400000e+01
  %102 = fptosi double %101 to i64
  %103 = load double, ptr %14, align 8
  %104 = fmul double %103, 2.000000e-09
  %105 = load ptr, ptr %62, align 8
  %106 = load ptr, ptr %59, align 8
  %107 = load i64, ptr %56, align 8
  %108 = icmp eq i64 %107, 0
  br i1 %108, label %211, label %109

109:
  %110 = load ptr, ptr %37, align 8
  %111 = load ptr, ptr %9, align 8
  %112 = load i64, ptr %10, align 8
  %113 = shl i64 %112, 3
  call void @llvm.memcpy.p0.p0.i64(ptr align 8 %110, ptr align 8 %111, i64 %113, i1 false)
  %114 = load i64, ptr %10, align 8
  %115 = load i64, ptr %34, align 8
  %116 = icmp slt i64 %114, %115
  %117 = load ptr, ptr %37, align 8
  br i1 %116, label %118, label %131

118:
  %119 = load ptr, ptr %9, align 8
  %120 = getelementptr inbounds double, ptr %119, i64 %114
  br label %121

121:
  %122 = phi i64 [ %114, %118 ], [ %129, %121 ]
  %123 = getelementptr inbounds double, ptr %119, i64 %122
  %124 = load double, ptr %123, align 8
  %125 = load double, ptr %120, align 8
  %126 = fdiv double %103, %125
  %127 = fmul double %124, %126
  %128 = getelementptr inbounds double, ptr %117, i64 %122
  store double %127, ptr %128, align 8
  %129 = add nsw i64 %122, 1
  %130 = icmp eq i64 %129, %115
  br i1 %130, label %131, label %121

131:
  %132 = getelementptr inbounds double, ptr %117, i64 %114
  %133 = load i64, ptr %83, align 8
  %134 = sub i64 0, %133
  %135 = getelementptr inbounds double, ptr %132, i64 %134
  %136 = load ptr, ptr %7, align 8
  %137 = load i64, ptr %84, align 8
  %138 = getelementptr inbounds double, ptr %136, i64 %137
  %139 = shl i64 %133, 3
  call void @llvm.memcpy.p0.p0.i64(ptr align 8 %135, ptr align 8 %138, i64 %139, i1 false)
  %140 = icmp sgt i64 %102, 1
  br i1 %140, label %141, label %190

141:
  %142 = phi i64 [ %188, %187 ], [ %102, %131 ]
  store i32 0, ptr %6, align 4
  %143 = load ptr, ptr %85, align 8
  %144 = load ptr, ptr %7, align 8
  %145 = getelementptr inbounds nuw i8, ptr %144, i64 8
  %146 = load double, ptr %145, align 8
  %147 = load i64, ptr %0, align 8
  %148 = getelementptr inbounds double, ptr %144, i64 %147
  %149 = load double, ptr %148, align 8
  %150 = load double, ptr %14, align 8
  %151 = fmul double %146, %150
  %152 = fadd double %149, %151
  %153 = fsub double %152, %104
  %154 = uitofp nneg i64 %142 to double
  %155 = fadd double %146, %154
  %156 = fmul double %155, %150
  %157 = fadd double %149, %156
  %158 = fadd double %104, %157
  %159 = load ptr, ptr %37, align 8
  call void %143(ptr noundef %106, ptr noundef nonnull %6, double noundef %153, double noundef %158, ptr noundef %159)
  %160 = load i64, ptr %56, align 8
  %161 = icmp sgt i64 %160, 0
  br i1 %161, label %162, label %217

162:
  %163 = phi i64 [ %180, %179 ], [ 0, %141 ]
  %164 = phi i1 [ %181, %179 ], [ false, %141 ]
  br i1 %164, label %176, label %165

165:
  %166 = shl nuw nsw i64 %163, 5
  %167 = getelementptr inbounds nuw i8, ptr %106, i64 %166
  %168 = load double, ptr %167, align 8
  %169 = fcmp ogt double %168, 0.000000e+00
  br i1 %169, label %183, label %170

170:
  %171 = getelementptr inbounds nuw i8, ptr %167, i64 8
  %172 = load double, ptr %171, align 8
  %173 = fcmp uge double %172, 0.000000e+00
  %174 = add nuw nsw i64 %163, 1
  %175 = icmp eq i64 %174, %160
  br i1 %175, label %186, label %179

176:
  %177 = add nuw nsw i64 %163, 1
  %178 = icmp eq i64 %177, %160
  br i1 %178, label %182, label %179

179:
  %180 = phi i64 [ %177, %176 ], [ %174, %170 ], [ %184, %183 ]
  %181 = phi i1 [ true, %176 ], [ %173, %170 ], [ false, %183 ]
  br label %162

182:
  br label %187

183:
  %184 = add nuw nsw i64 %163, 1
  %185 = icmp eq i64 %184, %160
  br i1 %185, label %217, label %179

186:
  br i1 %173, label %187, label %218

187:
  %188 = lshr i64 %142, 1
  %189 = icmp samesign ugt i64 %142, 3
  br i1 %189, label %141, label %190

190:
  %191 = load ptr, ptr %7, align 8
  %192 = getelementptr inbounds nuw i8, ptr %191, i64 8
  %193 = load double, ptr %192, align 8
  %194 = load i64, ptr %0, align 8
  %195 = getelementptr inbounds double, ptr %191, i64 %194
  %196 = load double, ptr %195, align 8
  %197 = load double, ptr %14, align 8
  %198 = fmul double %193, %197
  %199 = fadd double %196, %198
  %200 = fsub double %199, %104
  %201 = fadd double %193, 1.000000e+00
  %202 = fmul double %201, %197
  %203 = fadd double %196, %202
  %204 = fadd double %104, %203
  %205 = call fastcc i32 @changes(ptr noundef nonnull readonly %0, ptr noundef nonnull readonly %7, double noundef %200, double noundef %204, ptr noundef %105)
  %206 = icmp eq i32 %205, 0
  %207 = zext i1 %206 to i64
  %208 = icmp sgt i32 %205, -1
  br i1 %208, label %218, label %209

209:
  %210 = load i64, ptr %0, align 8
  br label %213

211:
  %212 = icmp sgt i64 %102, -1
  br i1 %212, label %218, label %213

213:
  %214 = phi i64 [ %210, %209 ], [ %93, %211 ]
  %215 = getelementptr double, ptr %1, i64 %214
  %216 = getelementptr i8, ptr %215, i64 8
  store double 5.000000e+00, ptr %216, align 8
  br label %364

217:
  br label %218

218:
  %219 = phi i64 [ %102, %211 ], [ %142, %217 ], [ %207, %190 ], [ %142, %186 ]
  %220 = load double, ptr %77, align 8
  %221 = load i64, ptr %0, align 8
  %222 = shl i64 %221, 3
  call void @llvm.memcpy.p0.p0.i64(ptr nonnull align 8 %63, ptr nonnull align 8 %1, i64 %222, i1 false)
  %223 = icmp eq i64 %219, 0
  br i1 %223, label %250, label %224

224:
  %225 = load ptr, ptr %7, align 8
  %226 = load double, ptr %225, align 8
  %227 = load i64, ptr %0, align 8
  %228 = getelementptr inbounds double, ptr %225, i64 %227
  %229 = load double, ptr %228, align 8
  %230 = fcmp une double %226, %229
  %231 = load ptr, ptr %9, align 8
  %232 = load ptr, ptr %18, align 8
  br i1 %230, label %233, label %244

233:
  %234 = load ptr, ptr %86, align 8
  call void %234(ptr noundef nonnull %225, ptr noundef %231, ptr noundef %232, i64 noundef 1)
  %235 = load ptr, ptr %7, align 8
  %236 = load i64, ptr %0, align 8
  %237 = getelementptr inbounds double, ptr %235, i64 %236
  %238 = load double, ptr %237, align 8
  store double %238, ptr %235, align 8
  %239 = add nsw i64 %219, -1
  %240 = icmp eq i64 %239, 0
  br i1 %240, label %251, label %241

241:
  %242 = load ptr, ptr %9, align 8
  %243 = load ptr, ptr %18, align 8
  br label %244

244:
  %245 = phi ptr [ %243, %241 ], [ %232, %224 ]
  %246 = phi ptr [ %242, %241 ], [ %231, %224 ]
  %247 = phi ptr [ %235, %241 ], [ %225, %224 ]
  %248 = phi i64 [ %239, %241 ], [ %219, %224 ]
  %249 = load ptr, ptr %86, align 8
  call void %249(ptr noundef nonnull %247, ptr noundef %246, ptr noundef %245, i64 noundef %248)
  br label %251

250:
  call fastcc void @one_step(ptr noundef nonnull %0, ptr noundef %7, i32 noundef 0, ptr nonnull %76, ptr %69)
  br label %251

251:
  %252 = load i64, ptr %40, align 8
  %253 = icmp sgt i64 %252, 0
  br i1 %253, label %254, label %353

254:
  %255 = load i64, ptr %87, align 8
  %256 = getelementptr inbounds double, ptr %1, i64 %255
  %257 = load double, ptr %256, align 8
  %258 = fcmp olt double %257, 1.000000e+300
  br i1 %258, label %259, label %353

259:
  %260 = fadd double %257, -1.000000e+00
  %261 = fsub double %260, %220
  %262 = fptosi double %261 to i64
  %263 = load i64, ptr %0, align 8
  %264 = shl i64 %263, 3
  call void @llvm.memcpy.p0.p0.i64(ptr nonnull align 8 %1, ptr nonnull align 8 %63, i64 %264, i1 false)
  %265 = icmp sgt i64 %262, 0
  %266 = load i64, ptr %0, align 8
  %267 = load ptr, ptr %7, align 8
  br i1 %265, label %268, label %291

268:
  %269 = load double, ptr %267, align 8
  %270 = getelementptr inbounds double, ptr %267, i64 %266
  %271 = load double, ptr %270, align 8
  %272 = fcmp une double %269, %271
  br i1 %272, label %273, label %283

273:
  %274 = load ptr, ptr %86, align 8
  %275 = load ptr, ptr %9, align 8
  %276 = load ptr, ptr %18, align 8
  call void %274(ptr noundef nonnull %267, ptr noundef %275, ptr noundef %276, i64 noundef 1)
  %277 = load ptr, ptr %7, align 8
  %278 = load i64, ptr %0, align 8
  %279 = getelementptr inbounds double, ptr %277, i64 %278
  %280 = load double, ptr %279, align 8
  store double %280, ptr %277, align 8
  %281 = add nsw i64 %262, -1
  %282 = icmp eq i64 %281, 0
  br i1 %282, label %291, label %283

283:
  %284 = phi ptr [ %277, %273 ], [ %267, %268 ]
  %285 = phi i64 [ %281, %273 ], [ %262, %268 ]
  %286 = load ptr, ptr %86, align 8
  %287 = load ptr, ptr %9, align 8
  %288 = load ptr, ptr %18, align 8
  call void %286(ptr noundef nonnull %284, ptr noundef %287, ptr noundef %288, i64 noundef %285)
  %289 = load i64, ptr %0, align 8
  %290 = load ptr, ptr %7, align 8
  br label %291

291:
  %292 = phi ptr [ %290, %283 ], [ %277, %273 ], [ %267, %259 ]
  %293 = phi i64 [ %289, %283 ], [ %278, %273 ], [ %266, %259 ]
  %294 = getelementptr inbounds double, ptr %76, i64 %293
  %295 = load ptr, ptr %27, align 8
  %296 = shl i64 %293, 3
  call void @llvm.memcpy.p0.p0.i64(ptr align 8 %295, ptr align 8 %292, i64 %296, i1 false)
  %297 = load ptr, ptr %27, align 8
  %298 = load i64, ptr %87, align 8
  %299 = getelementptr inbounds double, ptr %297, i64 %298
  store double 1.000000e+300, ptr %299, align 8
  store i32 0, ptr %88, align 8
  %300 = load ptr, ptr %67, align 8
  %301 = load i64, ptr %40, align 8
  %302 = shl i64 %301, 2
  %303 = add i64 %302, 4
  call void @llvm.memset.p0.i64(ptr align 4 %300, i8 0, i64 %303, i1 false)
  call fastcc void @one_step(ptr noundef nonnull %0, ptr noundef nonnull %7, i32 noundef 1, ptr nonnull %294, ptr %69)
  %304 = load i64, ptr %87, align 8
  %305 = getelementptr inbounds double, ptr %292, i64 %304
  store double 1.000000e+300, ptr %305, align 8
  %306 = load i32, ptr %88, align 8
  %307 = icmp eq i32 %306, 0
  br i1 %307, label %308, label %353

308:
  %309 = load i64, ptr %0, align 8
  %310 = shl i64 %309, 3
  call void @llvm.memcpy.p0.p0.i64(ptr nonnull align 8 %76, ptr nonnull align 8 %292, i64 %310, i1 false)
  %311 = load ptr, ptr %27, align 8
  %312 = load i64, ptr %0, align 8
  %313 = shl i64 %312, 3
  call void @llvm.memcpy.p0.p0.i64(ptr nonnull align 8 %292, ptr align 8 %311, i64 %313, i1 false)
  call fastcc void @one_step(ptr noundef nonnull %0, ptr noundef nonnull %7, i32 noundef 0, ptr nonnull %294, ptr %69)
  %314 = load i64, ptr %89, align 8
  %315 = getelementptr inbounds double, ptr %76, i64 %314
  %316 = getelementptr inbounds double, ptr %292, i64 %314
  %317 = load i64, ptr %40, align 8
  %318 = icmp sgt i64 %317, 0
  br i1 %318, label %319, label %350

319:
  %320 = load ptr, ptr %90, align 8
  br label %321

321:
  %322 = phi i64 [ 0, %319 ], [ %344, %341 ]
  %323 = phi i1 [ false, %319 ], [ %343, %341 ]
  %324 = getelementptr inbounds nuw double, ptr %315, i64 %322
  %325 = load double, ptr %324, align 8
  %326 = getelementptr inbounds nuw double, ptr %316, i64 %322
  %327 = load double, ptr %326, align 8
  %328 = getelementptr inbounds nuw %struct.Event, ptr %320, i64 %322
  %329 = load i32, ptr %328, align 8
  %330 = icmp sgt i32 %329, -1
  %331 = fcmp olt double %325, 0.000000e+00
  %332 = and i1 %331, %330
  %333 = fcmp oge double %327, 0.000000e+00
  %334 = and i1 %333, %332
  br i1 %334, label %341, label %335

335:
  %336 = icmp slt i32 %329, 1
  %337 = fcmp ogt double %325, 0.000000e+00
  %338 = and i1 %337, %336
  %339 = fcmp ole double %327, 0.000000e+00
  %340 = and i1 %339, %338
  br label %341

341:
  %342 = phi i1 [ true, %321 ], [ %340, %335 ]
  %343 = or i1 %323, %342
  %344 = add nuw nsw i64 %322, 1
  %345 = icmp eq i64 %344, %317
  br i1 %345, label %346, label %321

346:
  br i1 %343, label %347, label %350

347:
  %348 = load i64, ptr %0, align 8
  %349 = shl i64 %348, 3
  call void @llvm.memcpy.p0.p0.i64(ptr nonnull align 8 %292, ptr nonnull align 8 %76, i64 %349, i1 false)
  br label %350

350:
  %351 = load i64, ptr %87, align 8
  %352 = getelementptr inbounds double, ptr %292, i64 %351
  store double 1.000000e+300, ptr %352, align 8
  br label %353

353:
  %354 = load double, ptr %77, align 8
  %355 = fcmp olt double %354, %80
  br i1 %355, label %91, label %356

356:
  %357 = load i64, ptr %0, align 8
  br label %358

358:
  %359 = phi i64 [ %75, %5 ], [ %357, %356 ], [ %93, %91 ]
  %360 = getelementptr double, ptr %1, i64 %359
  %361 = getelementptr i8, ptr %360, i64 8
  %362 = load double, ptr %361, align 8
  %363 = fptosi double %362 to i32
  br label %364

364:
  %365 = phi i32 [ 5, %213 ], [ %363, %358 ]
  ret i32 %365
}

define internal fastcc void @one_step(ptr noundef %0, ptr noundef nonnull %1, i32 noundef range(i32 0, 2) %2, ptr initializes((16, 24)) %3, ptr %4) unnamed_addr {
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
  %17 = getelementptr inbounds nuw i8, ptr %1, i64 128
  %18 = load double, ptr %17, align 8
  %19 = fmul double %13, %18
  %20 = fadd double %16, %19
  %21 = getelementptr inbounds nuw i8, ptr %3, i64 16
  store double 1.000000e+300, ptr %21, align 8
  %22 = load double, ptr %11, align 8
  %23 = load double, ptr %15, align 8
  %24 = fmul double %18, %22
  %25 = fadd double %23, %24
  %26 = fadd double %22, 1.000000e+00
  %27 = fmul double %18, %26
  %28 = fadd double %23, %27
  %29 = getelementptr inbounds nuw i8, ptr %1, i64 104
  %30 = load ptr, ptr %29, align 8
  %31 = getelementptr inbounds nuw i8, ptr %0, i64 72
  %32 = load i64, ptr %31, align 8
  %33 = icmp eq i64 %32, 0
  br i1 %33, label %34, label %38

34:
  store double %25, ptr %3, align 8
  %35 = fsub double %28, %25
  %36 = getelementptr inbounds nuw i8, ptr %3, i64 8
  store double %35, ptr %36, align 8
  store double 1.000000e+300, ptr %21, align 8
  %37 = getelementptr inbounds nuw i8, ptr %3, i64 24
  store double -1.000000e+300, ptr %37, align 8
  br label %264

38:
  %39 = getelementptr inbounds nuw i8, ptr %1, i64 56
  %40 = load ptr, ptr %39, align 8
  %41 = getelementptr inbounds nuw i8, ptr %1, i64 120
  %42 = load ptr, ptr %41, align 8
  %43 = getelementptr inbounds nuw i8, ptr %0, i64 40
  %44 = load i64, ptr %43, align 8
  %45 = shl i64 %44, 3
  tail call void @llvm.memcpy.p0.p0.i64(ptr align 8 %40, ptr align 8 %42, i64 %45, i1 false)
  %46 = load i64, ptr %43, align 8
  %47 = getelementptr inbounds nuw i8, ptr %0, i64 32
  %48 = load i64, ptr %47, align 8
  %49 = icmp slt i64 %46, %48
  %50 = load ptr, ptr %39, align 8
  br i1 %49, label %51, label %64

51:
  %52 = load ptr, ptr %41, align 8
  %53 = getelementptr inbounds double, ptr %52, i64 %46
  br label %54

54:
  %55 = phi i64 [ %46, %51 ], [ %62, %54 ]
  %56 = getelementptr inbounds double, ptr %52, i64 %55
  %57 = load double, ptr %56, align 8
  %58 = load double, ptr %53, align 8
  %59 = fdiv double %18, %58
  %60 = fmul double %57, %59
  %61 = getelementptr inbounds double, ptr %50, i64 %55
  store double %60, ptr %61, align 8
  %62 = add nsw i64 %55, 1
  %63 = icmp eq i64 %62, %48
  br i1 %63, label %64, label %54

64:
  %65 = getelementptr inbounds double, ptr %50, i64 %46
  %66 = getelementptr inbounds nuw i8, ptr %0, i64 48
  %67 = load i64, ptr %66, align 8
  %68 = sub i64 0, %67
  %69 = getelementptr inbounds double, ptr %65, i64 %68
  %70 = load ptr, ptr %1, align 8
  %71 = getelementptr inbounds nuw i8, ptr %0, i64 120
  %72 = load i64, ptr %71, align 8
  %73 = getelementptr inbounds double, ptr %70, i64 %72
  %74 = shl i64 %67, 3
  tail call void @llvm.memcpy.p0.p0.i64(ptr align 8 %69, ptr align 8 %73, i64 %74, i1 false)
  %75 = load double, ptr %17, align 8
  %76 = fmul double %75, 2.000000e-09
  %77 = fsub double %25, %76
  %78 = fadd double %28, %76
  %79 = tail call fastcc i32 @changes(ptr noundef nonnull readonly %0, ptr noundef nonnull readonly %1, double noundef %77, double noundef %78, ptr noundef %30)
  %80 = icmp sgt i32 %79, 0
  %81 = load double, ptr %17, align 8
  br i1 %80, label %82, label %144

82:
  %83 = load ptr, ptr %1, align 8
  %84 = load i64, ptr %0, align 8
  %85 = getelementptr inbounds double, ptr %83, i64 %84
  %86 = load double, ptr %85, align 8
  %87 = fmul double %22, %81
  %88 = fadd double %86, %87
  %89 = fmul double %81, 1.000000e-09
  br label %90

90:
  %91 = phi double [ 0xFFF0000000000000, %82 ], [ %104, %103 ]
  %92 = phi i32 [ %79, %82 ], [ %105, %103 ]
  %93 = phi ptr [ %30, %82 ], [ %106, %103 ]
  %94 = load double, ptr %93, align 8
  %95 = fsub double %94, %88
  %96 = tail call double @llvm.fabs.f64(double %95)
  %97 = fcmp ogt double %96, %89
  br i1 %97, label %103, label %98

98:
  %99 = getelementptr inbounds nuw i8, ptr %93, i64 16
  %100 = load double, ptr %99, align 8
  %101 = fcmp ogt double %100, %91
  br i1 %101, label %102, label %103

102:
  br label %103

103:
  %104 = phi double [ %91, %98 ], [ %100, %102 ], [ %91, %90 ]
  %105 = add nsw i32 %92, -1
  %106 = getelementptr inbounds nuw i8, ptr %93, i64 24
  %107 = icmp sgt i32 %92, 1
  br i1 %107, label %90, label %108

108:
  %109 = fmul double %26, %81
  %110 = fadd double %86, %109
  br label %111

111:
  %112 = phi double [ 0xFFF0000000000000, %108 ], [ %130, %129 ]
  %113 = phi double [ 0x7FF0000000000000, %108 ], [ %131, %129 ]
  %114 = phi i32 [ %79, %108 ], [ %132, %129 ]
  %115 = phi ptr [ %30, %108 ], [ %133, %129 ]
  %116 = load double, ptr %115, align 8
  %117 = fsub double %116, %110
  %118 = tail call double @llvm.fabs.f64(double %117)
  %119 = fcmp ogt double %118, %89
  br i1 %119, label %129, label %120

120:
  %121 = getelementptr inbounds nuw i8, ptr %115, i64 8
  %122 = load double, ptr %121, align 8
  %123 = fcmp olt double %122, %113
  %124 = select i1 %123, double %122, double %113
  %125 = getelementptr inbounds nuw i8, ptr %115, i64 16
  %126 = load double, ptr %125, align 8
  %127 = fcmp ogt double %126, %112
  br i1 %127, label %128, label %129

128:
  br label %129

129:
  %130 = phi double [ %112, %120 ], [ %126, %128 ], [ %112, %111 ]
  %131 = phi double [ %124, %120 ], [ %124, %128 ], [ %113, %111 ]
  %132 = add nsw i32 %114, -1
  %133 = getelementptr inbounds nuw i8, ptr %115, i64 24
  %134 = icmp sgt i32 %114, 1
  br i1 %134, label %111, label %135

135:
  %136 = zext nneg i32 %79 to i64
  br label %154

137:
  %138 = icmp slt i32 %182, 0
  br i1 %138, label %139, label %142

139:
  %140 = fcmp ogt double %130, %20
  %141 = select i1 %140, double %130, double %20
  br label %259

142:
  %143 = load double, ptr %17, align 8
  br label %144

144:
  %145 = phi double [ %143, %142 ], [ %81, %64 ]
  %146 = phi i32 [ %182, %142 ], [ 0, %64 ]
  %147 = phi double [ %104, %142 ], [ 0xFFF0000000000000, %64 ]
  %148 = phi double [ %130, %142 ], [ 0xFFF0000000000000, %64 ]
  %149 = phi double [ %131, %142 ], [ 0x7FF0000000000000, %64 ]
  %150 = fmul double %145, 0x3DA5FD7FE1796495
  %151 = zext nneg i32 %146 to i64
  %152 = add nuw i32 %146, 1
  %153 = zext i32 %152 to i64
  br label %185

154:
  %155 = phi i64 [ 0, %135 ], [ %183, %181 ]
  %156 = phi i32 [ 0, %135 ], [ %182, %181 ]
  %157 = getelementptr inbounds nuw %struct.Stop, ptr %30, i64 %155
  %158 = load double, ptr %157, align 8
  %159 = load ptr, ptr %1, align 8
  %160 = load i64, ptr %0, align 8
  %161 = getelementptr inbounds double, ptr %159, i64 %160
  %162 = load double, ptr %161, align 8
  %163 = fsub double %158, %162
  %164 = load double, ptr %17, align 8
  %165 = fdiv double %163, %164
  %166 = tail call double @llvm.floor.f64(double %165)
  %167 = fcmp oeq double %166, %22
  br i1 %167, label %168, label %181

168:
  %169 = fsub double %158, %25
  %170 = tail call double @llvm.fabs.f64(double %169)
  %171 = fmul double %164, 1.000000e-09
  %172 = fcmp ogt double %170, %171
  br i1 %172, label %173, label %181

173:
  %174 = fsub double %158, %28
  %175 = tail call double @llvm.fabs.f64(double %174)
  %176 = fcmp ogt double %175, %171
  br i1 %176, label %177, label %181

177:
  %178 = add nsw i32 %156, 1
  %179 = sext i32 %156 to i64
  %180 = getelementptr inbounds %struct.Stop, ptr %30, i64 %179
  tail call void @llvm.memcpy.p0.p0.i64(ptr noundef nonnull align 8 dereferenceable(24) %180, ptr noundef nonnull align 8 dereferenceable(24) %157, i64 24, i1 false)
  br label %181

181:
  %182 = phi i32 [ %178, %177 ], [ %156, %173 ], [ %156, %168 ], [ %156, %154 ]
  %183 = add nuw nsw i64 %155, 1
  %184 = icmp eq i64 %183, %136
  br i1 %184, label %137, label %154

185:
  %186 = phi i64 [ 0, %144 ], [ %251, %239 ]
  %187 = phi i32 [ 0, %144 ], [ %249, %239 ]
  %188 = icmp eq i64 %186, 0
  br i1 %188, label %195, label %189

189:
  %190 = getelementptr %struct.Stop, ptr %30, i64 %186
  %191 = getelementptr i8, ptr %190, i64 -24
  %192 = load double, ptr %191, align 8
  %193 = getelementptr i8, ptr %190, i64 -8
  %194 = load double, ptr %193, align 8
  br label %195

195:
  %196 = phi double [ %194, %189 ], [ %147, %185 ]
  %197 = phi double [ %192, %189 ], [ %25, %185 ]
  %198 = icmp eq i64 %186, %151
  br i1 %198, label %206, label %199

199:
  %200 = getelementptr inbounds nuw %struct.Stop, ptr %30, i64 %186
  %201 = load double, ptr %200, align 8
  %202 = getelementptr inbounds nuw i8, ptr %200, i64 8
  %203 = load double, ptr %202, align 8
  %204 = getelementptr inbounds nuw i8, ptr %200, i64 16
  %205 = load double, ptr %204, align 8
  br label %206

206:
  %207 = phi double [ %205, %199 ], [ %148, %195 ]
  %208 = phi double [ %203, %199 ], [ %149, %195 ]
  %209 = phi double [ %201, %199 ], [ %28, %195 ]
  %210 = fsub double %209, %197
  %211 = fcmp ogt double %196, %197
  %212 = select i1 %211, double %196, double %197
  %213 = fadd double %212, %210
  %214 = fsub double %213, %208
  %215 = fcmp ogt double %214, %150
  br i1 %215, label %216, label %235

216:
  %217 = fcmp oeq double %196, 0xFFF0000000000000
  br i1 %217, label %218, label %226

218:
  %219 = load ptr, ptr %1, align 8
  %220 = load i64, ptr %0, align 8
  %221 = getelementptr inbounds double, ptr %219, i64 %220
  %222 = load double, ptr %221, align 8
  %223 = fcmp ugt double %197, %222
  br i1 %223, label %224, label %235

224:
  %225 = fsub double %208, %210
  br label %239

226:
  %227 = fmul double %210, 5.000000e-01
  %228 = sext i32 %187 to i64
  %229 = getelementptr inbounds %struct.Part, ptr %3, i64 %228
  store double %212, ptr %229, align 8
  %230 = getelementptr inbounds nuw i8, ptr %229, i64 8
  store double %227, ptr %230, align 8
  %231 = getelementptr inbounds nuw i8, ptr %229, i64 16
  store double 1.000000e+300, ptr %231, align 8
  %232 = add nsw i32 %187, 1
  %233 = getelementptr inbounds nuw i8, ptr %229, i64 24
  store double -1.000000e+300, ptr %233, align 8
  %234 = fsub double %208, %227
  br label %239

235:
  %236 = fsub double %208, %212
  %237 = fcmp olt double %236, %210
  br i1 %237, label %238, label %239

238:
  br label %239

239:
  %240 = phi i32 [ %187, %238 ], [ %187, %235 ], [ %187, %224 ], [ %232, %226 ]
  %241 = phi double [ %236, %238 ], [ %210, %235 ], [ %210, %224 ], [ %227, %226 ]
  %242 = phi double [ %212, %238 ], [ %212, %235 ], [ %225, %224 ], [ %234, %226 ]
  %243 = sext i32 %240 to i64
  %244 = getelementptr inbounds %struct.Part, ptr %3, i64 %243
  store double %242, ptr %244, align 8
  %245 = getelementptr inbounds nuw i8, ptr %244, i64 8
  store double %241, ptr %245, align 8
  %246 = fcmp one double %208, 0x7FF0000000000000
  %247 = select i1 %246, double %208, double 1.000000e+300
  %248 = getelementptr inbounds nuw i8, ptr %244, i64 16
  store double %247, ptr %248, align 8
  %249 = add nsw i32 %240, 1
  %250 = getelementptr inbounds nuw i8, ptr %244, i64 24
  store double %207, ptr %250, align 8
  %251 = add nuw nsw i64 %186, 1
  %252 = icmp eq i64 %251, %153
  br i1 %252, label %253, label %185

253:
  %254 = fcmp ogt double %148, %20
  %255 = select i1 %254, double %148, double %20
  %256 = icmp sgt i32 %240, 0
  br i1 %256, label %257, label %259

257:
  %258 = load ptr, ptr %1, align 8
  br label %271

259:
  %260 = phi double [ %141, %139 ], [ %255, %253 ]
  %261 = phi i32 [ 0, %139 ], [ %249, %253 ]
  %262 = load double, ptr %21, align 8
  %263 = fcmp olt double %262, 1.000000e+300
  br label %264

264:
  %265 = phi i1 [ false, %34 ], [ %263, %259 ]
  %266 = phi i32 [ 1, %34 ], [ %261, %259 ]
  %267 = phi double [ %20, %34 ], [ %260, %259 ]
  %268 = icmp ne i32 %2, 0
  %269 = or i1 %268, %265
  %270 = load ptr, ptr %1, align 8
  br i1 %269, label %271, label %1524

271:
  %272 = phi ptr [ %270, %264 ], [ %258, %257 ]
  %273 = phi i32 [ %266, %264 ], [ %249, %257 ]
  %274 = phi double [ %267, %264 ], [ %255, %257 ]
  %275 = getelementptr inbounds nuw i8, ptr %1, i64 16
  %276 = load ptr, ptr %275, align 8
  %277 = getelementptr inbounds nuw i8, ptr %272, i64 8
  %278 = load double, ptr %277, align 8
  %279 = getelementptr inbounds nuw i8, ptr %0, i64 16
  %280 = load i64, ptr %279, align 8
  %281 = shl i64 %280, 3
  tail call void @llvm.memset.p0.i64(ptr align 8 %276, i8 0, i64 %281, i1 false)
  %282 = load ptr, ptr %1, align 8
  %283 = load i64, ptr %0, align 8
  %284 = shl i64 %283, 3
  tail call void @llvm.memcpy.p0.p0.i64(ptr align 8 %276, ptr align 8 %282, i64 %284, i1 false)
  %285 = getelementptr inbounds nuw i8, ptr %0, i64 248
  %286 = load i64, ptr %285, align 8
  %287 = getelementptr inbounds double, ptr %276, i64 %286
  %288 = load ptr, ptr %1, align 8
  %289 = getelementptr inbounds nuw i8, ptr %0, i64 120
  %290 = load i64, ptr %289, align 8
  %291 = getelementptr inbounds double, ptr %288, i64 %290
  %292 = getelementptr inbounds nuw i8, ptr %0, i64 48
  %293 = load i64, ptr %292, align 8
  %294 = shl i64 %293, 3
  tail call void @llvm.memcpy.p0.p0.i64(ptr align 8 %287, ptr align 8 %291, i64 %294, i1 false)
  %295 = getelementptr inbounds nuw i8, ptr %0, i64 192
  %296 = load i64, ptr %295, align 8
  %297 = getelementptr inbounds double, ptr %276, i64 %296
  store double %278, ptr %297, align 8
  %298 = load double, ptr %17, align 8
  %299 = getelementptr inbounds nuw i8, ptr %0, i64 200
  %300 = load i64, ptr %299, align 8
  %301 = getelementptr inbounds double, ptr %276, i64 %300
  store double %298, ptr %301, align 8
  %302 = getelementptr inbounds nuw i8, ptr %0, i64 56
  %303 = load i64, ptr %302, align 8
  %304 = icmp sgt i64 %303, 0
  br i1 %304, label %305, label %318

305:
  %306 = icmp eq i32 %2, 0
  %307 = getelementptr inbounds nuw i8, ptr %0, i64 136
  %308 = load i64, ptr %307, align 8
  br i1 %306, label %309, label %312

309:
  %310 = getelementptr inbounds double, ptr %276, i64 %308
  %311 = load double, ptr %310, align 8
  br label %312

312:
  %313 = phi double [ %311, %309 ], [ 1.000000e+300, %305 ]
  %314 = getelementptr inbounds nuw i8, ptr %0, i64 232
  %315 = load i64, ptr %314, align 8
  %316 = getelementptr inbounds double, ptr %276, i64 %315
  store double %313, ptr %316, align 8
  %317 = getelementptr inbounds double, ptr %276, i64 %308
  store double 1.000000e+300, ptr %317, align 8
  br label %318

318:
  %319 = icmp sgt i32 %273, 0
  br i1 %319, label %320, label %1497

320:
  %321 = icmp eq i32 %2, 0
  %322 = getelementptr inbounds nuw i8, ptr %0, i64 184
  %323 = getelementptr inbounds nuw i8, ptr %1, i64 136
  %324 = getelementptr inbounds nuw i8, ptr %1, i64 144
  %325 = getelementptr inbounds nuw i8, ptr %1, i64 24
  %326 = getelementptr inbounds nuw i8, ptr %0, i64 104
  %327 = getelementptr inbounds nuw i8, ptr %0, i64 208
  %328 = getelementptr inbounds nuw i8, ptr %0, i64 216
  %329 = getelementptr inbounds nuw i8, ptr %0, i64 224
  %330 = getelementptr inbounds nuw i8, ptr %0, i64 408
  %331 = getelementptr inbounds nuw i8, ptr %1, i64 48
  %332 = getelementptr inbounds nuw i8, ptr %1, i64 8
  %333 = getelementptr inbounds nuw i8, ptr %0, i64 400
  %334 = getelementptr inbounds nuw i8, ptr %0, i64 240
  %335 = getelementptr inbounds nuw i8, ptr %0, i64 432
  %336 = getelementptr inbounds nuw i8, ptr %1, i64 80
  %337 = getelementptr inbounds nuw i8, ptr %1, i64 32
  %338 = getelementptr inbounds nuw i8, ptr %1, i64 88
  %339 = getelementptr inbounds nuw i8, ptr %1, i64 56
  %340 = getelementptr inbounds nuw i8, ptr %1, i64 120
  %341 = getelementptr inbounds nuw i8, ptr %0, i64 40
  %342 = getelementptr inbounds nuw i8, ptr %0, i64 32
  %343 = getelementptr inbounds nuw i8, ptr %0, i64 360
  %344 = getelementptr inbounds nuw i8, ptr %0, i64 64
  %345 = getelementptr inbounds nuw i8, ptr %0, i64 440
  %346 = getelementptr inbounds nuw i8, ptr %1, i64 64
  %347 = zext nneg i32 %273 to i64
  br label %348

348:
  %349 = phi i64 [ 0, %320 ], [ %1495, %1494 ]
  %350 = getelementptr inbounds nuw %struct.Part, ptr %3, i64 %349
  %351 = load double, ptr %350, align 8
  %352 = getelementptr inbounds nuw i8, ptr %350, i64 8
  %353 = load double, ptr %352, align 8
  br i1 %321, label %1471, label %354

354:
  %355 = fadd double %351, %353
  %356 = load double, ptr %17, align 8
  %357 = fmul double %356, 1.000000e-09
  %358 = fsub double %355, %357
  %359 = load i64, ptr %302, align 8
  %360 = getelementptr i32, ptr %4, i64 %359
  %361 = getelementptr i8, ptr %360, i64 4
  %362 = xor i64 %359, -1
  %363 = getelementptr inbounds i32, ptr %361, i64 %362
  %364 = icmp eq ptr %361, null
  br label %365

365:
  %366 = phi i64 [ %359, %354 ], [ %1363, %1360 ]
  %367 = phi double [ %353, %354 ], [ %1361, %1360 ]
  %368 = phi double [ %351, %354 ], [ %1362, %1360 ]
  %369 = load ptr, ptr %275, align 8
  %370 = load i64, ptr %322, align 8
  %371 = icmp sgt i64 %370, -1
  %372 = getelementptr inbounds nuw double, ptr %369, i64 %370
  %373 = icmp ne ptr %369, null
  %374 = icmp sgt i64 %366, 0
  %375 = select i1 %374, i1 %371, i1 false
  %376 = select i1 %375, i1 %373, i1 false
  br i1 %376, label %377, label %390

377:
  %378 = phi i64 [ %388, %377 ], [ 0, %365 ]
  %379 = phi double [ %387, %377 ], [ 1.000000e+300, %365 ]
  %380 = getelementptr inbounds nuw double, ptr %372, i64 %378
  %381 = load double, ptr %380, align 8
  %382 = fcmp ogt double %381, %368
  %383 = fcmp olt double %381, %358
  %384 = select i1 %382, i1 %383, i1 false
  %385 = fcmp olt double %381, %379
  %386 = select i1 %384, i1 %385, i1 false
  %387 = select i1 %386, double %381, double %379
  %388 = add nuw nsw i64 %378, 1
  %389 = icmp eq i64 %388, %366
  br i1 %389, label %390, label %377

390:
  %391 = phi double [ 1.000000e+300, %365 ], [ %387, %377 ]
  store double %368, ptr %323, align 8
  %392 = fcmp olt double %391, 1.000000e+300
  %393 = fsub double %391, %368
  %394 = select i1 %392, double %393, double %367
  store double %394, ptr %324, align 8
  %395 = load ptr, ptr %325, align 8
  %396 = load i64, ptr %279, align 8
  %397 = shl i64 %396, 3
  tail call void @llvm.memcpy.p0.p0.i64(ptr align 8 %395, ptr align 8 %369, i64 %397, i1 false)
  %398 = load ptr, ptr %325, align 8
  %399 = load double, ptr %324, align 8
  %400 = load i64, ptr %326, align 8
  %401 = sitofp i64 %400 to double
  %402 = fmul double %401, 0x3CC0000000000000
  %403 = fsub double 1.000000e+00, %402
  %404 = fmul double %399, %403
  %405 = load i64, ptr %327, align 8
  %406 = getelementptr inbounds double, ptr %398, i64 %405
  store double %368, ptr %406, align 8
  %407 = load i64, ptr %328, align 8
  %408 = getelementptr inbounds double, ptr %398, i64 %407
  store double %404, ptr %408, align 8
  %409 = load double, ptr %17, align 8
  %410 = fdiv double %404, %409
  %411 = load i64, ptr %329, align 8
  %412 = getelementptr inbounds double, ptr %398, i64 %411
  store double %410, ptr %412, align 8
  %413 = load ptr, ptr %330, align 8
  %414 = load ptr, ptr %331, align 8
  %415 = load ptr, ptr %332, align 8
  tail call void %413(ptr noundef %398, ptr noundef %414, ptr noundef %415)
  %416 = load ptr, ptr %333, align 8
  %417 = load i64, ptr %334, align 8
  %418 = getelementptr inbounds double, ptr %398, i64 %417
  %419 = load ptr, ptr %332, align 8
  tail call void %416(ptr noundef %398, ptr noundef %418, ptr noundef %419, i64 noundef 1)
  %420 = load i64, ptr %299, align 8
  %421 = getelementptr inbounds double, ptr %398, i64 %420
  store double %404, ptr %421, align 8
  %422 = load ptr, ptr %335, align 8
  %423 = load ptr, ptr %336, align 8
  %424 = load ptr, ptr %337, align 8
  %425 = load ptr, ptr %275, align 8
  %426 = load double, ptr %324, align 8
  %427 = tail call fastcc ptr @set_out(ptr noundef nonnull %0, ptr noundef nonnull %1, ptr noundef %425, double noundef %426, double noundef %368)
  %428 = load ptr, ptr %332, align 8
  tail call void %422(ptr noundef %423, ptr noundef %424, ptr noundef %427, ptr noundef %428)
  %429 = load ptr, ptr %338, align 8
  %430 = load ptr, ptr %325, align 8
  %431 = load ptr, ptr %335, align 8
  %432 = load i64, ptr %299, align 8
  %433 = getelementptr inbounds double, ptr %430, i64 %432
  %434 = load double, ptr %433, align 8
  %435 = load ptr, ptr %339, align 8
  %436 = load ptr, ptr %340, align 8
  %437 = load i64, ptr %341, align 8
  %438 = shl i64 %437, 3
  tail call void @llvm.memcpy.p0.p0.i64(ptr align 8 %435, ptr align 8 %436, i64 %438, i1 false)
  %439 = load i64, ptr %341, align 8
  %440 = load i64, ptr %342, align 8
  %441 = icmp slt i64 %439, %440
  %442 = load ptr, ptr %339, align 8
  br i1 %441, label %443, label %456

443:
  %444 = load ptr, ptr %340, align 8
  %445 = getelementptr inbounds double, ptr %444, i64 %439
  br label %446

446:
  %447 = phi i64 [ %439, %443 ], [ %454, %446 ]
  %448 = getelementptr inbounds double, ptr %444, i64 %447
  %449 = load double, ptr %448, align 8
  %450 = load double, ptr %445, align 8
  %451 = fdiv double %434, %450
  %452 = fmul double %449, %451
  %453 = getelementptr inbounds double, ptr %442, i64 %447
  store double %452, ptr %453, align 8
  %454 = add nsw i64 %447, 1
  %455 = icmp eq i64 %454, %440
  br i1 %455, label %456, label %446

456:
  %457 = load ptr, ptr %332, align 8
  tail call void %431(ptr noundef %429, ptr noundef nonnull %430, ptr noundef %442, ptr noundef %457)
  %458 = load i64, ptr %302, align 8
  %459 = add nsw i64 %458, 1
  %460 = getelementptr inbounds double, ptr %9, i64 %459
  %461 = getelementptr inbounds double, ptr %460, i64 %459
  %462 = getelementptr inbounds double, ptr %461, i64 %459
  %463 = load ptr, ptr %275, align 8
  %464 = load i64, ptr %322, align 8
  %465 = icmp slt i64 %464, 0
  %466 = getelementptr inbounds nuw double, ptr %463, i64 %464
  %467 = select i1 %465, ptr null, ptr %466
  %468 = load ptr, ptr %336, align 8
  %469 = load ptr, ptr %338, align 8
  %470 = load double, ptr %323, align 8
  %471 = icmp sgt i64 %458, 0
  br i1 %471, label %472, label %507

472:
  %473 = icmp eq ptr %467, null
  br label %474

474:
  %475 = phi i64 [ 0, %472 ], [ %503, %500 ]
  %476 = phi i1 [ false, %472 ], [ %502, %500 ]
  br i1 %473, label %481, label %477

477:
  %478 = getelementptr inbounds nuw double, ptr %466, i64 %475
  %479 = load double, ptr %478, align 8
  %480 = fcmp ogt double %479, %470
  br i1 %480, label %500, label %481

481:
  %482 = getelementptr inbounds nuw double, ptr %468, i64 %475
  %483 = load double, ptr %482, align 8
  %484 = getelementptr inbounds nuw double, ptr %469, i64 %475
  %485 = load double, ptr %484, align 8
  %486 = load ptr, ptr %343, align 8
  %487 = getelementptr inbounds nuw %struct.Event, ptr %486, i64 %475
  %488 = load i32, ptr %487, align 8
  %489 = icmp sgt i32 %488, -1
  %490 = fcmp olt double %483, 0.000000e+00
  %491 = and i1 %490, %489
  %492 = fcmp oge double %485, 0.000000e+00
  %493 = and i1 %492, %491
  br i1 %493, label %500, label %494

494:
  %495 = icmp slt i32 %488, 1
  %496 = fcmp ogt double %483, 0.000000e+00
  %497 = and i1 %496, %495
  %498 = fcmp ole double %485, 0.000000e+00
  %499 = and i1 %498, %497
  br label %500

500:
  %501 = phi i1 [ false, %477 ], [ %499, %494 ], [ true, %481 ]
  %502 = or i1 %476, %501
  %503 = add nuw nsw i64 %475, 1
  %504 = icmp eq i64 %503, %458
  br i1 %504, label %505, label %474

505:
  %506 = zext i1 %502 to i32
  br label %507

507:
  %508 = phi i32 [ 0, %456 ], [ %506, %505 ]
  %509 = load double, ptr %324, align 8
  %510 = load i64, ptr %344, align 8
  %511 = icmp eq i64 %510, 0
  br i1 %511, label %1039, label %512

512:
  %513 = load ptr, ptr %345, align 8
  %514 = load ptr, ptr %337, align 8
  %515 = tail call fastcc ptr @set_out(ptr noundef nonnull readonly %0, ptr noundef nonnull readonly %1, ptr noundef %463, double noundef %509, double noundef %470)
  %516 = load ptr, ptr %332, align 8
  tail call void %513(ptr noundef nonnull %9, ptr noundef %514, ptr noundef %515, ptr noundef %516)
  %517 = load ptr, ptr %345, align 8
  %518 = load ptr, ptr %325, align 8
  %519 = load i64, ptr %299, align 8
  %520 = getelementptr inbounds double, ptr %518, i64 %519
  %521 = load double, ptr %520, align 8
  %522 = load ptr, ptr %339, align 8
  %523 = load ptr, ptr %340, align 8
  %524 = load i64, ptr %341, align 8
  %525 = shl i64 %524, 3
  tail call void @llvm.memcpy.p0.p0.i64(ptr align 8 %522, ptr align 8 %523, i64 %525, i1 false)
  %526 = load i64, ptr %341, align 8
  %527 = load i64, ptr %342, align 8
  %528 = icmp slt i64 %526, %527
  %529 = load ptr, ptr %339, align 8
  br i1 %528, label %530, label %543

530:
  %531 = load ptr, ptr %340, align 8
  %532 = getelementptr inbounds double, ptr %531, i64 %526
  br label %533

533:
  %534 = phi i64 [ %526, %530 ], [ %541, %533 ]
  %535 = getelementptr inbounds double, ptr %531, i64 %534
  %536 = load double, ptr %535, align 8
  %537 = load double, ptr %532, align 8
  %538 = fdiv double %521, %537
  %539 = fmul double %536, %538
  %540 = getelementptr inbounds double, ptr %529, i64 %534
  store double %539, ptr %540, align 8
  %541 = add nsw i64 %534, 1
  %542 = icmp eq i64 %541, %527
  br i1 %542, label %543, label %533

543:
  %544 = load ptr, ptr %332, align 8
  tail call void %517(ptr noundef nonnull %460, ptr noundef nonnull %518, ptr noundef %529, ptr noundef %544)
  %545 = load i64, ptr %344, align 8
  %546 = icmp sgt i64 %545, 0
  br i1 %546, label %547, label %1039

547:
  %548 = load ptr, ptr %336, align 8
  %549 = load ptr, ptr %338, align 8
  %550 = load double, ptr %324, align 8
  %551 = fdiv double %550, 3.000000e+00
  %552 = icmp eq ptr %467, null
  br label %553

553:
  %554 = phi i64 [ 0, %547 ], [ %607, %606 ]
  %555 = getelementptr inbounds nuw double, ptr %548, i64 %554
  %556 = load double, ptr %555, align 8
  %557 = getelementptr inbounds nuw double, ptr %549, i64 %554
  %558 = load double, ptr %557, align 8
  %559 = getelementptr inbounds nuw double, ptr %9, i64 %554
  %560 = load double, ptr %559, align 8
  %561 = fmul double %551, %560
  %562 = fadd double %556, %561
  %563 = getelementptr inbounds nuw double, ptr %460, i64 %554
  %564 = load double, ptr %563, align 8
  %565 = fmul double %551, %564
  %566 = fsub double %558, %565
  %567 = fcmp ogt double %556, 0.000000e+00
  %568 = zext i1 %567 to i32
  %569 = fcmp olt double %556, 0.000000e+00
  %570 = sext i1 %569 to i32
  %571 = add nsw i32 %570, %568
  %572 = sitofp i32 %571 to double
  %573 = fsub double %558, %556
  %574 = fcmp ogt double %573, 0.000000e+00
  %575 = zext i1 %574 to i32
  %576 = fcmp olt double %573, 0.000000e+00
  %577 = sext i1 %576 to i32
  %578 = add nsw i32 %577, %575
  %579 = sitofp i32 %578 to double
  br i1 %552, label %585, label %580

580:
  %581 = getelementptr inbounds nuw double, ptr %466, i64 %554
  %582 = load double, ptr %581, align 8
  %583 = load double, ptr %323, align 8
  %584 = fcmp ogt double %582, %583
  br i1 %584, label %606, label %585

585:
  %586 = fmul double %558, %572
  %587 = fcmp ogt double %586, 0.000000e+00
  br i1 %587, label %588, label %594

588:
  %589 = fmul double %562, %572
  %590 = fcmp ugt double %589, 0.000000e+00
  %591 = fmul double %566, %572
  %592 = fcmp ugt double %591, 0.000000e+00
  %593 = select i1 %590, i1 %592, i1 false
  br i1 %593, label %606, label %609

594:
  %595 = fsub double %562, %556
  %596 = fmul double %595, %579
  %597 = fcmp olt double %596, 0.000000e+00
  br i1 %597, label %609, label %598

598:
  %599 = fsub double %566, %562
  %600 = fmul double %599, %579
  %601 = fcmp olt double %600, 0.000000e+00
  br i1 %601, label %609, label %602

602:
  %603 = fsub double %558, %566
  %604 = fmul double %603, %579
  %605 = fcmp olt double %604, 0.000000e+00
  br i1 %605, label %609, label %606

606:
  %607 = add nuw nsw i64 %554, 1
  %608 = icmp eq i64 %607, %545
  br i1 %608, label %1039, label %553

609:
  %610 = load ptr, ptr %346, align 8
  %611 = load i64, ptr %302, align 8
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 16 dereferenceable(2000) %6, i8 0, i64 2000, i1 false)
  br label %618

612:
  %613 = shl i64 %611, 4
  %614 = getelementptr double, ptr %462, i64 %613
  %615 = getelementptr i8, ptr %614, i64 128
  %616 = sub nuw nsw i64 -16, %613
  %617 = getelementptr inbounds double, ptr %615, i64 %616
  br label %642

618:
  %619 = phi i64 [ 0, %609 ], [ %636, %629 ]
  %620 = icmp eq i64 %619, 4
  br i1 %620, label %627, label %621

621:
  %622 = trunc nuw nsw i64 %619 to i32
  %623 = uitofp nneg i32 %622 to double
  %624 = load double, ptr %324, align 8
  %625 = fmul double %624, 2.500000e-01
  %626 = fmul double %625, %623
  br label %629

627:
  %628 = load double, ptr %324, align 8
  br label %629

629:
  %630 = phi double [ %626, %621 ], [ %628, %627 ]
  %631 = load i64, ptr %302, align 8
  %632 = add nsw i64 %631, 1
  %633 = mul nsw i64 %632, %619
  %634 = getelementptr double, ptr %610, i64 %633
  %635 = getelementptr double, ptr %634, i64 %631
  store double %630, ptr %635, align 8
  tail call fastcc void @look(ptr noundef nonnull readonly %0, ptr noundef nonnull readonly %1, double noundef %630, ptr noundef %634)
  %636 = add nuw nsw i64 %619, 1
  %637 = icmp eq i64 %636, 5
  br i1 %637, label %612, label %618

638:
  %639 = phi i32 [ %644, %824 ], [ %821, %972 ]
  %640 = add nsw i32 %639, -1
  %641 = icmp sgt i32 %639, 1
  br i1 %641, label %642, label %988

642:
  %643 = phi i32 [ 4, %612 ], [ %640, %638 ]
  %644 = phi i32 [ 5, %612 ], [ %639, %638 ]
  %645 = load i64, ptr %302, align 8
  %646 = add nsw i64 %645, 1
  %647 = load ptr, ptr %275, align 8
  %648 = load i64, ptr %322, align 8
  %649 = getelementptr inbounds nuw double, ptr %647, i64 %648
  %650 = load double, ptr %323, align 8
  %651 = icmp sgt i64 %645, 0
  %652 = icmp slt i64 %648, 0
  %653 = icmp eq ptr %647, null
  %654 = select i1 %652, i1 true, i1 %653
  %655 = zext nneg i32 %643 to i64
  br label %656

656:
  %657 = phi i64 [ 0, %642 ], [ %660, %699 ]
  %658 = mul nsw i64 %657, %646
  %659 = getelementptr inbounds double, ptr %610, i64 %658
  %660 = add nuw nsw i64 %657, 1
  %661 = mul nsw i64 %660, %646
  %662 = getelementptr inbounds double, ptr %610, i64 %661
  br i1 %651, label %663, label %699

663:
  %664 = load i64, ptr %344, align 8
  br label %665

665:
  %666 = phi i64 [ 0, %663 ], [ %696, %693 ]
  %667 = phi i1 [ false, %663 ], [ %695, %693 ]
  %668 = icmp sgt i64 %664, %666
  br i1 %668, label %669, label %693

669:
  br i1 %654, label %674, label %670

670:
  %671 = getelementptr inbounds nuw double, ptr %649, i64 %666
  %672 = load double, ptr %671, align 8
  %673 = fcmp ogt double %672, %650
  br i1 %673, label %693, label %674

674:
  %675 = getelementptr inbounds nuw double, ptr %659, i64 %666
  %676 = load double, ptr %675, align 8
  %677 = getelementptr inbounds nuw double, ptr %662, i64 %666
  %678 = load double, ptr %677, align 8
  %679 = load ptr, ptr %343, align 8
  %680 = getelementptr inbounds nuw %struct.Event, ptr %679, i64 %666
  %681 = load i32, ptr %680, align 8
  %682 = icmp sgt i32 %681, -1
  %683 = fcmp olt double %676, 0.000000e+00
  %684 = and i1 %683, %682
  %685 = fcmp oge double %678, 0.000000e+00
  %686 = and i1 %685, %684
  br i1 %686, label %693, label %687

687:
  %688 = icmp slt i32 %681, 1
  %689 = fcmp ogt double %676, 0.000000e+00
  %690 = and i1 %689, %688
  %691 = fcmp ole double %678, 0.000000e+00
  %692 = and i1 %691, %690
  br label %693

693:
  %694 = phi i1 [ false, %670 ], [ false, %665 ], [ true, %674 ], [ %692, %687 ]
  %695 = or i1 %667, %694
  %696 = add nuw nsw i64 %666, 1
  %697 = icmp eq i64 %696, %645
  br i1 %697, label %698, label %665

698:
  br i1 %695, label %701, label %699

699:
  %700 = icmp eq i64 %660, %655
  br i1 %700, label %704, label %656

701:
  %702 = trunc nuw nsw i64 %657 to i32
  %703 = and i64 %657, 4294967295
  br label %704

704:
  %705 = phi i64 [ %703, %701 ], [ %655, %699 ]
  %706 = phi i32 [ %702, %701 ], [ %643, %699 ]
  %707 = phi i1 [ true, %701 ], [ false, %699 ]
  %708 = add nsw i32 %644, -3
  %709 = icmp slt i64 %645, 1
  br label %710

710:
  %711 = phi i64 [ 0, %704 ], [ %721, %815 ]
  %712 = phi i32 [ 0, %704 ], [ %816, %815 ]
  %713 = trunc nuw nsw i64 %711 to i32
  %714 = tail call i32 @llvm.smax.i32(i32 %713, i32 1)
  %715 = zext nneg i32 %714 to i64
  %716 = add nsw i64 %715, -1
  %717 = icmp samesign ule i64 %711, %705
  %718 = icmp slt i32 %712, 16
  %719 = select i1 %717, i1 %718, i1 false
  br i1 %719, label %720, label %818

720:
  %721 = add nuw nsw i64 %711, 1
  %722 = mul nsw i64 %721, %646
  %723 = getelementptr double, ptr %610, i64 %722
  %724 = getelementptr double, ptr %723, i64 %645
  %725 = load double, ptr %724, align 8
  %726 = mul nsw i64 %711, %646
  %727 = getelementptr double, ptr %610, i64 %726
  %728 = getelementptr double, ptr %727, i64 %645
  %729 = load double, ptr %728, align 8
  %730 = fsub double %725, %729
  %731 = getelementptr inbounds nuw i32, ptr %6, i64 %711
  %732 = load i32, ptr %731, align 4
  %733 = icmp slt i32 %732, 1
  %734 = select i1 %709, i1 true, i1 %733
  br i1 %734, label %805, label %735

735:
  %736 = add nsw i32 %714, -1
  %737 = tail call i32 @llvm.smin.i32(i32 %713, i32 %708)
  %738 = icmp sgt i32 %736, %737
  %739 = fmul double %730, %730
  %740 = sext i32 %737 to i64
  br label %741

741:
  %742 = phi i64 [ 0, %735 ], [ %802, %800 ]
  %743 = getelementptr double, ptr %727, i64 %742
  %744 = load double, ptr %743, align 8
  %745 = getelementptr double, ptr %723, i64 %742
  %746 = load double, ptr %745, align 8
  %747 = tail call double @llvm.fabs.f64(double %744)
  %748 = tail call double @llvm.fabs.f64(double %746)
  %749 = fcmp olt double %747, %748
  %750 = select i1 %749, double %747, double %748
  br i1 %738, label %786, label %751

751:
  %752 = phi i64 [ %782, %751 ], [ %716, %741 ]
  %753 = phi double [ %781, %751 ], [ 0.000000e+00, %741 ]
  %754 = mul nsw i64 %752, %646
  %755 = getelementptr inbounds double, ptr %610, i64 %754
  %756 = getelementptr inbounds nuw double, ptr %755, i64 %646
  %757 = getelementptr inbounds nuw double, ptr %756, i64 %646
  %758 = getelementptr inbounds nuw double, ptr %757, i64 %742
  %759 = load double, ptr %758, align 8
  %760 = getelementptr inbounds nuw double, ptr %756, i64 %742
  %761 = load double, ptr %760, align 8
  %762 = fsub double %759, %761
  %763 = getelementptr inbounds nuw double, ptr %757, i64 %645
  %764 = load double, ptr %763, align 8
  %765 = getelementptr inbounds nuw double, ptr %756, i64 %645
  %766 = load double, ptr %765, align 8
  %767 = fsub double %764, %766
  %768 = fdiv double %762, %767
  %769 = getelementptr inbounds nuw double, ptr %755, i64 %742
  %770 = load double, ptr %769, align 8
  %771 = fsub double %761, %770
  %772 = getelementptr inbounds nuw double, ptr %755, i64 %645
  %773 = load double, ptr %772, align 8
  %774 = fsub double %766, %773
  %775 = fdiv double %771, %774
  %776 = fsub double %768, %775
  %777 = fsub double %764, %773
  %778 = fdiv double %776, %777
  %779 = tail call double @llvm.fabs.f64(double %778)
  %780 = fcmp ogt double %779, %753
  %781 = select i1 %780, double %779, double %753
  %782 = add nuw nsw i64 %752, 1
  %783 = icmp slt i64 %752, %740
  br i1 %783, label %751, label %784

784:
  %785 = fmul double %781, 3.000000e+00
  br label %786

786:
  %787 = phi double [ 0.000000e+00, %741 ], [ %785, %784 ]
  %788 = fmul double %744, %746
  %789 = fcmp ogt double %788, 0.000000e+00
  br i1 %789, label %790, label %794

790:
  %791 = fmul double %739, %787
  %792 = fmul double %791, 2.500000e-01
  %793 = fcmp ogt double %792, %750
  br label %800

794:
  %795 = fmul double %730, %787
  %796 = fsub double %746, %744
  %797 = fdiv double %796, %730
  %798 = tail call double @llvm.fabs.f64(double %797)
  %799 = fcmp ogt double %795, %798
  br label %800

800:
  %801 = phi i1 [ %793, %790 ], [ %799, %794 ]
  %802 = add nuw nsw i64 %742, 1
  %803 = icmp sle i64 %645, %802
  %804 = select i1 %803, i1 true, i1 %801
  br i1 %804, label %805, label %741

805:
  %806 = phi i1 [ %733, %720 ], [ %801, %800 ]
  br i1 %806, label %807, label %815

807:
  %808 = load double, ptr %324, align 8
  %809 = fmul double %808, 0x3EB0C6F7A0B5ED8D
  %810 = fcmp ogt double %730, %809
  br i1 %810, label %811, label %815

811:
  %812 = add nsw i32 %712, 1
  %813 = sext i32 %712 to i64
  %814 = getelementptr inbounds i32, ptr %7, i64 %813
  store i32 %713, ptr %814, align 4
  br label %815

815:
  %816 = phi i32 [ %812, %811 ], [ %712, %807 ], [ %712, %805 ]
  %817 = icmp eq i64 %721, %655
  br i1 %817, label %818, label %710

818:
  %819 = phi i32 [ %816, %815 ], [ %712, %710 ]
  %820 = icmp eq i32 %819, 0
  %821 = add i32 %819, %644
  %822 = icmp sgt i32 %821, 499
  %823 = or i1 %820, %822
  br i1 %823, label %829, label %824

824:
  %825 = icmp sgt i32 %819, 0
  br i1 %825, label %826, label %638

826:
  %827 = add nsw i32 %644, -4
  %828 = zext nneg i32 %819 to i64
  br label %830

829:
  br i1 %707, label %977, label %988

830:
  %831 = phi i64 [ %645, %826 ], [ %853, %928 ]
  %832 = phi i64 [ 0, %826 ], [ %929, %928 ]
  %833 = add nsw i64 %831, 1
  %834 = mul nsw i64 %833, %832
  %835 = getelementptr inbounds double, ptr %617, i64 %834
  %836 = getelementptr inbounds nuw i32, ptr %7, i64 %832
  %837 = load i32, ptr %836, align 4
  %838 = sext i32 %837 to i64
  %839 = mul nsw i64 %833, %838
  %840 = getelementptr double, ptr %610, i64 %839
  %841 = getelementptr double, ptr %840, i64 %831
  %842 = load double, ptr %841, align 8
  %843 = add nsw i32 %837, 1
  %844 = sext i32 %843 to i64
  %845 = mul nsw i64 %833, %844
  %846 = getelementptr double, ptr %610, i64 %845
  %847 = getelementptr double, ptr %846, i64 %831
  %848 = load double, ptr %847, align 8
  %849 = fadd double %842, %848
  %850 = fmul double %849, 5.000000e-01
  %851 = getelementptr inbounds double, ptr %835, i64 %831
  store double %850, ptr %851, align 8
  tail call fastcc void @look(ptr noundef nonnull readonly %0, ptr noundef nonnull readonly %1, double noundef %850, ptr noundef %835)
  %852 = getelementptr inbounds nuw i32, ptr %8, i64 %832
  store i32 1, ptr %852, align 4
  %853 = load i64, ptr %302, align 8
  %854 = icmp sgt i64 %853, 0
  br i1 %854, label %855, label %928

855:
  %856 = icmp sgt i32 %837, 0
  %857 = add nsw i32 %837, -1
  %858 = tail call i32 @llvm.smin.i32(i32 %857, i32 %827)
  %859 = select i1 %856, i32 %858, i32 0
  %860 = add nsw i32 %859, 4
  %861 = add nuw nsw i64 %853, 1
  %862 = getelementptr double, ptr %610, i64 %853
  %863 = getelementptr inbounds nuw double, ptr %835, i64 %853
  %864 = sext i32 %859 to i64
  %865 = sext i32 %860 to i64
  br label %866

866:
  %867 = phi i64 [ 0, %855 ], [ %925, %923 ]
  %868 = phi i32 [ 1, %855 ], [ %924, %923 ]
  br label %869

869:
  %870 = phi i64 [ %864, %866 ], [ %908, %898 ]
  %871 = phi double [ 0.000000e+00, %866 ], [ %907, %898 ]
  %872 = phi double [ 0xFFF0000000000000, %866 ], [ %904, %898 ]
  %873 = phi double [ 0x7FF0000000000000, %866 ], [ %902, %898 ]
  %874 = phi double [ 0.000000e+00, %866 ], [ %900, %898 ]
  %875 = mul nsw i64 %870, %861
  %876 = getelementptr double, ptr %610, i64 %875
  %877 = getelementptr double, ptr %876, i64 %867
  %878 = load double, ptr %877, align 8
  %879 = getelementptr double, ptr %876, i64 %853
  br label %880

880:
  %881 = phi i64 [ %864, %869 ], [ %896, %894 ]
  %882 = phi double [ 1.000000e+00, %869 ], [ %895, %894 ]
  %883 = icmp eq i64 %881, %870
  br i1 %883, label %894, label %884

884:
  %885 = load double, ptr %863, align 8
  %886 = mul nsw i64 %881, %861
  %887 = getelementptr double, ptr %862, i64 %886
  %888 = load double, ptr %887, align 8
  %889 = fsub double %885, %888
  %890 = load double, ptr %879, align 8
  %891 = fsub double %890, %888
  %892 = fdiv double %889, %891
  %893 = fmul double %882, %892
  br label %894

894:
  %895 = phi double [ %893, %884 ], [ %882, %880 ]
  %896 = add nsw i64 %881, 1
  %897 = icmp slt i64 %896, %865
  br i1 %897, label %880, label %898

898:
  %899 = fmul double %878, %895
  %900 = fadd double %874, %899
  %901 = fcmp olt double %878, %873
  %902 = select i1 %901, double %878, double %873
  %903 = fcmp ogt double %878, %872
  %904 = select i1 %903, double %878, double %872
  %905 = tail call double @llvm.fabs.f64(double %878)
  %906 = fcmp ogt double %905, %871
  %907 = select i1 %906, double %905, double %871
  %908 = add nsw i64 %870, 1
  %909 = icmp slt i64 %908, %865
  br i1 %909, label %869, label %910

910:
  %911 = icmp eq i32 %868, 0
  br i1 %911, label %923, label %912

912:
  %913 = getelementptr inbounds nuw double, ptr %835, i64 %867
  %914 = load double, ptr %913, align 8
  %915 = fsub double %914, %900
  %916 = tail call double @llvm.fabs.f64(double %915)
  %917 = fsub double %904, %902
  %918 = fmul double %917, 5.000000e-02
  %919 = fmul double %907, 1.000000e-13
  %920 = fadd double %918, %919
  %921 = fcmp ole double %916, %920
  %922 = zext i1 %921 to i32
  br label %923

923:
  %924 = phi i32 [ 0, %910 ], [ %922, %912 ]
  %925 = add nuw nsw i64 %867, 1
  %926 = icmp eq i64 %925, %853
  br i1 %926, label %927, label %866

927:
  store i32 %924, ptr %852, align 4
  br label %928

928:
  %929 = add nuw nsw i64 %832, 1
  %930 = icmp eq i64 %929, %828
  br i1 %930, label %931, label %830

931:
  %932 = phi i64 [ %934, %972 ], [ %828, %928 ]
  %933 = phi i32 [ %975, %972 ], [ %644, %928 ]
  %934 = add nsw i64 %932, -1
  %935 = getelementptr inbounds nuw i32, ptr %7, i64 %934
  %936 = load i32, ptr %935, align 4
  %937 = add nsw i32 %936, 2
  %938 = sext i32 %937 to i64
  %939 = load i64, ptr %302, align 8
  %940 = add nsw i64 %939, 1
  %941 = mul nsw i64 %940, %938
  %942 = getelementptr inbounds double, ptr %610, i64 %941
  %943 = add nsw i32 %936, 1
  %944 = sext i32 %943 to i64
  %945 = mul nsw i64 %940, %944
  %946 = getelementptr inbounds double, ptr %610, i64 %945
  %947 = sub nsw i32 %933, %936
  %948 = add nsw i32 %947, -1
  %949 = sext i32 %948 to i64
  %950 = shl i64 %940, 3
  %951 = mul i64 %950, %949
  tail call void @llvm.memmove.p0.p0.i64(ptr align 8 %942, ptr align 8 %946, i64 %951, i1 false)
  %952 = load i64, ptr %302, align 8
  %953 = add nsw i64 %952, 1
  %954 = mul nsw i64 %953, %944
  %955 = getelementptr inbounds double, ptr %610, i64 %954
  %956 = mul nsw i64 %953, %934
  %957 = getelementptr inbounds double, ptr %617, i64 %956
  %958 = shl i64 %953, 3
  tail call void @llvm.memcpy.p0.p0.i64(ptr align 8 %955, ptr align 8 %957, i64 %958, i1 false)
  %959 = sext i32 %936 to i64
  %960 = getelementptr inbounds i32, ptr %6, i64 %959
  %961 = getelementptr inbounds nuw i8, ptr %960, i64 8
  %962 = getelementptr inbounds nuw i8, ptr %960, i64 4
  %963 = add nsw i32 %947, -2
  %964 = sext i32 %963 to i64
  %965 = shl nsw i64 %964, 2
  call void @llvm.memmove.p0.p0.i64(ptr nonnull align 4 %961, ptr nonnull align 4 %962, i64 %965, i1 false)
  %966 = getelementptr inbounds nuw i32, ptr %8, i64 %934
  %967 = load i32, ptr %966, align 4
  %968 = icmp eq i32 %967, 0
  br i1 %968, label %972, label %969

969:
  %970 = load i32, ptr %960, align 4
  %971 = add nsw i32 %970, 1
  br label %972

972:
  %973 = phi i32 [ %971, %969 ], [ 0, %931 ]
  %974 = getelementptr inbounds i32, ptr %6, i64 %944
  store i32 %973, ptr %974, align 4
  store i32 %973, ptr %960, align 4
  %975 = add i32 %933, 1
  %976 = icmp eq i32 %975, %821
  br i1 %976, label %638, label %931

977:
  %978 = mul nsw i64 %705, %646
  %979 = getelementptr double, ptr %610, i64 %978
  %980 = getelementptr double, ptr %979, i64 %645
  %981 = load double, ptr %980, align 8
  %982 = add nuw nsw i32 %706, 1
  %983 = zext nneg i32 %982 to i64
  %984 = mul nsw i64 %646, %983
  %985 = getelementptr double, ptr %610, i64 %984
  %986 = getelementptr double, ptr %985, i64 %645
  %987 = load double, ptr %986, align 8
  br label %990

988:
  %989 = load double, ptr %324, align 8
  br label %990

990:
  %991 = phi i1 [ true, %988 ], [ false, %977 ]
  %992 = phi i32 [ 0, %988 ], [ 1, %977 ]
  %993 = phi double [ 0.000000e+00, %988 ], [ %987, %977 ]
  %994 = phi double [ 0.000000e+00, %988 ], [ %981, %977 ]
  %995 = phi double [ %989, %988 ], [ %981, %977 ]
  tail call fastcc void @look(ptr noundef nonnull readonly %0, ptr noundef nonnull readonly %1, double noundef %995, ptr noundef nonnull %461)
  %996 = load ptr, ptr %336, align 8
  %997 = load double, ptr %323, align 8
  %998 = load i64, ptr %302, align 8
  %999 = icmp sgt i64 %998, 0
  br i1 %999, label %1000, label %1039

1000:
  %1001 = load i64, ptr %344, align 8
  br label %1002

1002:
  %1003 = phi i64 [ 0, %1000 ], [ %1033, %1030 ]
  %1004 = phi i1 [ false, %1000 ], [ %1032, %1030 ]
  %1005 = icmp sgt i64 %1001, %1003
  br i1 %1005, label %1030, label %1006

1006:
  br i1 %552, label %1011, label %1007

1007:
  %1008 = getelementptr inbounds nuw double, ptr %466, i64 %1003
  %1009 = load double, ptr %1008, align 8
  %1010 = fcmp ogt double %1009, %997
  br i1 %1010, label %1030, label %1011

1011:
  %1012 = getelementptr inbounds nuw double, ptr %996, i64 %1003
  %1013 = load double, ptr %1012, align 8
  %1014 = getelementptr inbounds nuw double, ptr %461, i64 %1003
  %1015 = load double, ptr %1014, align 8
  %1016 = load ptr, ptr %343, align 8
  %1017 = getelementptr inbounds nuw %struct.Event, ptr %1016, i64 %1003
  %1018 = load i32, ptr %1017, align 8
  %1019 = icmp sgt i32 %1018, -1
  %1020 = fcmp olt double %1013, 0.000000e+00
  %1021 = and i1 %1020, %1019
  %1022 = fcmp oge double %1015, 0.000000e+00
  %1023 = and i1 %1022, %1021
  br i1 %1023, label %1030, label %1024

1024:
  %1025 = icmp slt i32 %1018, 1
  %1026 = fcmp ogt double %1013, 0.000000e+00
  %1027 = and i1 %1026, %1025
  %1028 = fcmp ole double %1015, 0.000000e+00
  %1029 = and i1 %1028, %1027
  br label %1030

1030:
  %1031 = phi i1 [ false, %1007 ], [ false, %1002 ], [ true, %1011 ], [ %1029, %1024 ]
  %1032 = or i1 %1004, %1031
  %1033 = add nuw nsw i64 %1003, 1
  %1034 = icmp eq i64 %1033, %998
  br i1 %1034, label %1035, label %1002

1035:
  br i1 %1032, label %1036, label %1039

1036:
  %1037 = load double, ptr %324, align 8
  br i1 %991, label %1038, label %1055

1038:
  br label %1055

1039:
  %1040 = phi double [ 0.000000e+00, %507 ], [ %994, %990 ], [ 0.000000e+00, %543 ], [ %994, %1035 ], [ 0.000000e+00, %606 ]
  %1041 = phi double [ %509, %507 ], [ %993, %990 ], [ %509, %543 ], [ %993, %1035 ], [ %509, %606 ]
  %1042 = phi i32 [ %508, %507 ], [ %992, %990 ], [ %508, %543 ], [ %992, %1035 ], [ %508, %606 ]
  %1043 = icmp eq i32 %1042, 0
  br i1 %1043, label %1047, label %1044

1044:
  %1045 = load double, ptr %324, align 8
  %1046 = load i64, ptr %302, align 8
  br label %1055

1047:
  %1048 = load ptr, ptr %275, align 8
  %1049 = load ptr, ptr %325, align 8
  %1050 = load i64, ptr %279, align 8
  %1051 = shl i64 %1050, 3
  tail call void @llvm.memcpy.p0.p0.i64(ptr align 8 %1048, ptr align 8 %1049, i64 %1051, i1 false)
  %1052 = fcmp oeq double %391, 1.000000e+300
  br i1 %1052, label %1364, label %1053

1053:
  %1054 = fsub double %355, %391
  br label %1360

1055:
  %1056 = phi i64 [ %1046, %1044 ], [ %998, %1038 ], [ %998, %1036 ]
  %1057 = phi double [ %1045, %1044 ], [ %1037, %1038 ], [ %1037, %1036 ]
  %1058 = phi double [ %1041, %1044 ], [ %1037, %1038 ], [ %994, %1036 ]
  %1059 = phi double [ %1040, %1044 ], [ 0.000000e+00, %1038 ], [ 0.000000e+00, %1036 ]
  %1060 = fmul double %1057, 0x3E7AD7F29ABCAF48
  %1061 = fcmp ogt double %1060, 0x3D719799812DEA11
  %1062 = select i1 %1061, double 0x3D719799812DEA11, double %1060
  %1063 = load ptr, ptr %275, align 8
  %1064 = load i64, ptr %322, align 8
  %1065 = icmp slt i64 %1064, 0
  %1066 = getelementptr inbounds nuw double, ptr %1063, i64 %1064
  %1067 = add nsw i64 %1056, 1
  %1068 = getelementptr inbounds double, ptr %9, i64 %1067
  %1069 = getelementptr inbounds double, ptr %1068, i64 %1067
  %1070 = getelementptr inbounds double, ptr %1069, i64 %1067
  %1071 = load ptr, ptr %346, align 8
  tail call fastcc void @look(ptr noundef nonnull readonly %0, ptr noundef nonnull readonly %1, double noundef %1059, ptr noundef nonnull %1068)
  %1072 = load i64, ptr %302, align 8
  %1073 = getelementptr inbounds double, ptr %1068, i64 %1072
  store double %1059, ptr %1073, align 8
  tail call fastcc void @look(ptr noundef nonnull readonly %0, ptr noundef nonnull readonly %1, double noundef %1058, ptr noundef nonnull %1069)
  %1074 = load i64, ptr %302, align 8
  %1075 = getelementptr inbounds double, ptr %1069, i64 %1074
  store double %1058, ptr %1075, align 8
  %1076 = shl i64 %1074, 3
  %1077 = add i64 %1076, 8
  tail call void @llvm.memcpy.p0.p0.i64(ptr nonnull align 8 %9, ptr nonnull align 8 %1068, i64 %1077, i1 false)
  %1078 = load i64, ptr %302, align 8
  %1079 = shl i64 %1078, 3
  %1080 = add i64 %1079, 8
  tail call void @llvm.memcpy.p0.p0.i64(ptr align 8 %1071, ptr nonnull align 8 %1068, i64 %1080, i1 false)
  %1081 = load i64, ptr %302, align 8
  %1082 = add nsw i64 %1081, 1
  %1083 = getelementptr inbounds double, ptr %1071, i64 %1082
  %1084 = shl i64 %1082, 3
  tail call void @llvm.memcpy.p0.p0.i64(ptr align 8 %1083, ptr nonnull align 8 %1069, i64 %1084, i1 false)
  %1085 = icmp eq ptr %1063, null
  %1086 = select i1 %1065, i1 true, i1 %1085
  %1087 = fmul double %1062, 2.500000e-01
  br label %1088

1088:
  %1089 = phi i64 [ 0, %1055 ], [ %1283, %1279 ]
  %1090 = load i64, ptr %302, align 8
  %1091 = getelementptr inbounds double, ptr %1069, i64 %1090
  %1092 = load double, ptr %1091, align 8
  %1093 = getelementptr inbounds double, ptr %1068, i64 %1090
  %1094 = load double, ptr %1093, align 8
  %1095 = fsub double %1092, %1094
  %1096 = fcmp ogt double %1095, %1062
  br i1 %1096, label %1097, label %1287

1097:
  %1098 = fadd double %1092, %1094
  %1099 = fmul double %1098, 5.000000e-01
  %1100 = trunc i64 %1089 to i8
  %1101 = urem i8 %1100, 5
  %1102 = icmp eq i8 %1101, 4
  br i1 %1102, label %1227, label %1103

1103:
  %1104 = load double, ptr %323, align 8
  %1105 = icmp sgt i64 %1090, 0
  br i1 %1105, label %1106, label %1219

1106:
  %1107 = phi i64 [ %1137, %1136 ], [ 0, %1103 ]
  br i1 %1086, label %1112, label %1108

1108:
  %1109 = getelementptr inbounds nuw double, ptr %1066, i64 %1107
  %1110 = load double, ptr %1109, align 8
  %1111 = fcmp ogt double %1110, %1104
  br i1 %1111, label %1132, label %1112

1112:
  %1113 = getelementptr inbounds nuw double, ptr %9, i64 %1107
  %1114 = load double, ptr %1113, align 8
  %1115 = getelementptr inbounds nuw double, ptr %1069, i64 %1107
  %1116 = load double, ptr %1115, align 8
  %1117 = load ptr, ptr %343, align 8
  %1118 = getelementptr inbounds nuw %struct.Event, ptr %1117, i64 %1107
  %1119 = load i32, ptr %1118, align 8
  %1120 = icmp sgt i32 %1119, -1
  %1121 = fcmp olt double %1114, 0.000000e+00
  %1122 = and i1 %1121, %1120
  %1123 = fcmp oge double %1116, 0.000000e+00
  %1124 = and i1 %1123, %1122
  br i1 %1124, label %1132, label %1125

1125:
  %1126 = icmp slt i32 %1119, 1
  %1127 = fcmp ogt double %1114, 0.000000e+00
  %1128 = and i1 %1127, %1126
  %1129 = fcmp ole double %1116, 0.000000e+00
  %1130 = and i1 %1129, %1128
  %1131 = zext i1 %1130 to i32
  br label %1132

1132:
  %1133 = phi i32 [ 0, %1108 ], [ %1131, %1125 ], [ 1, %1112 ]
  br i1 %364, label %1136, label %1134

1134:
  %1135 = getelementptr inbounds nuw i32, ptr %361, i64 %1107
  store i32 %1133, ptr %1135, align 4
  br label %1136

1136:
  %1137 = add nuw nsw i64 %1107, 1
  %1138 = icmp eq i64 %1137, %1090
  br i1 %1138, label %1139, label %1106

1139:
  %1140 = add nuw nsw i64 %1089, 2
  %1141 = getelementptr double, ptr %1071, i64 %1090
  %1142 = add nuw nsw i64 %1090, 1
  br label %1143

1143:
  %1144 = phi i64 [ 0, %1139 ], [ %1217, %1215 ]
  %1145 = phi double [ 1.000000e+300, %1139 ], [ %1216, %1215 ]
  %1146 = getelementptr inbounds nuw i32, ptr %361, i64 %1144
  %1147 = load i32, ptr %1146, align 4
  %1148 = icmp eq i32 %1147, 0
  br i1 %1148, label %1215, label %1149

1149:
  %1150 = getelementptr inbounds nuw double, ptr %1068, i64 %1144
  %1151 = load double, ptr %1150, align 8
  %1152 = getelementptr inbounds nuw double, ptr %1069, i64 %1144
  %1153 = load double, ptr %1152, align 8
  %1154 = tail call double @llvm.fabs.f64(double %1151)
  %1155 = tail call double @llvm.fabs.f64(double %1153)
  %1156 = fadd double %1154, %1155
  %1157 = fmul double %1095, %1154
  %1158 = fcmp ogt double %1156, 1.000000e-300
  %1159 = select i1 %1158, double %1156, double 1.000000e-300
  %1160 = fdiv double %1157, %1159
  %1161 = fadd double %1094, %1160
  br label %1162

1162:
  %1163 = phi i64 [ %1166, %1165 ], [ %1140, %1149 ]
  %1164 = icmp sgt i64 %1163, 0
  br i1 %1164, label %1165, label %1211

1165:
  %1166 = add nsw i64 %1163, -1
  %1167 = mul nsw i64 %1166, %1142
  %1168 = getelementptr double, ptr %1141, i64 %1167
  %1169 = load double, ptr %1168, align 8
  %1170 = fcmp oeq double %1169, %1094
  %1171 = fcmp oeq double %1169, %1092
  %1172 = or i1 %1170, %1171
  br i1 %1172, label %1162, label %1173

1173:
  %1174 = and i64 %1166, 4294967295
  %1175 = mul nuw nsw i64 %1174, %1142
  %1176 = getelementptr double, ptr %1071, i64 %1175
  %1177 = getelementptr double, ptr %1176, i64 %1144
  %1178 = load double, ptr %1177, align 8
  %1179 = fcmp oeq double %1178, %1151
  %1180 = fcmp oeq double %1178, %1153
  %1181 = select i1 %1179, i1 true, i1 %1180
  %1182 = fcmp oeq double %1151, %1153
  %1183 = select i1 %1181, i1 true, i1 %1182
  br i1 %1183, label %1211, label %1184

1184:
  %1185 = getelementptr double, ptr %1176, i64 %1090
  %1186 = load double, ptr %1185, align 8
  %1187 = fmul double %1094, %1153
  %1188 = fmul double %1187, %1178
  %1189 = fsub double %1151, %1153
  %1190 = fsub double %1151, %1178
  %1191 = fmul double %1189, %1190
  %1192 = fdiv double %1188, %1191
  %1193 = fmul double %1092, %1151
  %1194 = fmul double %1193, %1178
  %1195 = fsub double %1153, %1151
  %1196 = fsub double %1153, %1178
  %1197 = fmul double %1195, %1196
  %1198 = fdiv double %1194, %1197
  %1199 = fadd double %1192, %1198
  %1200 = fmul double %1151, %1186
  %1201 = fmul double %1153, %1200
  %1202 = fsub double %1178, %1151
  %1203 = fsub double %1178, %1153
  %1204 = fmul double %1202, %1203
  %1205 = fdiv double %1201, %1204
  %1206 = fadd double %1199, %1205
  %1207 = fcmp olt double %1094, %1206
  %1208 = fcmp olt double %1206, %1092
  %1209 = and i1 %1207, %1208
  %1210 = select i1 %1209, double %1206, double %1161
  br label %1211

1211:
  %1212 = phi double [ %1210, %1184 ], [ %1161, %1173 ], [ %1161, %1162 ]
  %1213 = fcmp olt double %1212, %1145
  %1214 = select i1 %1213, double %1212, double %1145
  br label %1215

1215:
  %1216 = phi double [ %1214, %1211 ], [ %1145, %1143 ]
  %1217 = add nuw nsw i64 %1144, 1
  %1218 = icmp eq i64 %1217, %1090
  br i1 %1218, label %1219, label %1143

1219:
  %1220 = phi double [ 1.000000e+300, %1103 ], [ %1216, %1215 ]
  %1221 = fsub double %1092, %1220
  %1222 = fsub double %1220, %1094
  %1223 = fcmp ogt double %1221, %1222
  %1224 = select i1 %1223, double 4.000000e-01, double -4.000000e-01
  %1225 = fmul double %1062, %1224
  %1226 = fadd double %1220, %1225
  br label %1227

1227:
  %1228 = phi double [ %1226, %1219 ], [ %1099, %1097 ]
  %1229 = fadd double %1087, %1094
  %1230 = fcmp ogt double %1228, %1229
  %1231 = select i1 %1230, double %1228, double %1229
  %1232 = fsub double %1092, %1087
  %1233 = fcmp olt double %1231, %1232
  %1234 = select i1 %1233, double %1231, double %1232
  tail call fastcc void @look(ptr noundef nonnull readonly %0, ptr noundef nonnull readonly %1, double noundef %1234, ptr noundef nonnull %1070)
  %1235 = load i64, ptr %302, align 8
  %1236 = getelementptr inbounds double, ptr %1070, i64 %1235
  store double %1234, ptr %1236, align 8
  %1237 = add nuw nsw i64 %1089, 2
  %1238 = add nsw i64 %1235, 1
  %1239 = mul nsw i64 %1238, %1237
  %1240 = getelementptr inbounds double, ptr %1071, i64 %1239
  %1241 = shl i64 %1238, 3
  tail call void @llvm.memcpy.p0.p0.i64(ptr align 8 %1240, ptr nonnull align 8 %1070, i64 %1241, i1 false)
  %1242 = load double, ptr %323, align 8
  %1243 = load i64, ptr %302, align 8
  %1244 = icmp sgt i64 %1243, 0
  br i1 %1244, label %1245, label %1278

1245:
  %1246 = phi i64 [ %1275, %1272 ], [ 0, %1227 ]
  %1247 = phi i1 [ %1274, %1272 ], [ false, %1227 ]
  br i1 %1086, label %1252, label %1248

1248:
  %1249 = getelementptr inbounds nuw double, ptr %1066, i64 %1246
  %1250 = load double, ptr %1249, align 8
  %1251 = fcmp ogt double %1250, %1242
  br i1 %1251, label %1272, label %1252

1252:
  %1253 = getelementptr inbounds nuw double, ptr %9, i64 %1246
  %1254 = load double, ptr %1253, align 8
  %1255 = getelementptr inbounds nuw double, ptr %1070, i64 %1246
  %1256 = load double, ptr %1255, align 8
  %1257 = load ptr, ptr %343, align 8
  %1258 = getelementptr inbounds nuw %struct.Event, ptr %1257, i64 %1246
  %1259 = load i32, ptr %1258, align 8
  %1260 = icmp sgt i32 %1259, -1
  %1261 = fcmp olt double %1254, 0.000000e+00
  %1262 = and i1 %1261, %1260
  %1263 = fcmp oge double %1256, 0.000000e+00
  %1264 = and i1 %1263, %1262
  br i1 %1264, label %1272, label %1265

1265:
  %1266 = icmp slt i32 %1259, 1
  %1267 = fcmp ogt double %1254, 0.000000e+00
  %1268 = and i1 %1267, %1266
  %1269 = fcmp ole double %1256, 0.000000e+00
  %1270 = and i1 %1269, %1268
  %1271 = freeze i1 %1270
  br label %1272

1272:
  %1273 = phi i1 [ false, %1248 ], [ %1271, %1265 ], [ true, %1252 ]
  %1274 = or i1 %1247, %1273
  %1275 = add nuw nsw i64 %1246, 1
  %1276 = icmp eq i64 %1275, %1243
  br i1 %1276, label %1277, label %1245

1277:
  br i1 %1274, label %1279, label %1278

1278:
  br label %1279

1279:
  %1280 = phi ptr [ %1068, %1278 ], [ %1069, %1277 ]
  %1281 = shl i64 %1243, 3
  %1282 = add i64 %1281, 8
  tail call void @llvm.memcpy.p0.p0.i64(ptr nonnull align 8 %1280, ptr nonnull align 8 %1070, i64 %1282, i1 false)
  %1283 = add nuw nsw i64 %1089, 1
  %1284 = icmp eq i64 %1283, 100
  br i1 %1284, label %1285, label %1088

1285:
  %1286 = load i64, ptr %302, align 8
  br label %1287

1287:
  %1288 = phi i64 [ %1286, %1285 ], [ %1090, %1088 ]
  %1289 = load double, ptr %323, align 8
  %1290 = icmp sgt i64 %1288, 0
  br i1 %1290, label %1291, label %1324

1291:
  %1292 = phi i64 [ %1322, %1321 ], [ 0, %1287 ]
  br i1 %1086, label %1297, label %1293

1293:
  %1294 = getelementptr inbounds nuw double, ptr %1066, i64 %1292
  %1295 = load double, ptr %1294, align 8
  %1296 = fcmp ogt double %1295, %1289
  br i1 %1296, label %1317, label %1297

1297:
  %1298 = getelementptr inbounds nuw double, ptr %9, i64 %1292
  %1299 = load double, ptr %1298, align 8
  %1300 = getelementptr inbounds nuw double, ptr %1069, i64 %1292
  %1301 = load double, ptr %1300, align 8
  %1302 = load ptr, ptr %343, align 8
  %1303 = getelementptr inbounds nuw %struct.Event, ptr %1302, i64 %1292
  %1304 = load i32, ptr %1303, align 8
  %1305 = icmp sgt i32 %1304, -1
  %1306 = fcmp olt double %1299, 0.000000e+00
  %1307 = and i1 %1306, %1305
  %1308 = fcmp oge double %1301, 0.000000e+00
  %1309 = and i1 %1308, %1307
  br i1 %1309, label %1317, label %1310

1310:
  %1311 = icmp slt i32 %1304, 1
  %1312 = fcmp ogt double %1299, 0.000000e+00
  %1313 = and i1 %1312, %1311
  %1314 = fcmp ole double %1301, 0.000000e+00
  %1315 = and i1 %1314, %1313
  %1316 = zext i1 %1315 to i32
  br label %1317

1317:
  %1318 = phi i32 [ 0, %1293 ], [ %1316, %1310 ], [ 1, %1297 ]
  br i1 %364, label %1321, label %1319

1319:
  %1320 = getelementptr inbounds nuw i32, ptr %363, i64 %1292
  store i32 %1318, ptr %1320, align 4
  br label %1321

1321:
  %1322 = add nuw nsw i64 %1292, 1
  %1323 = icmp eq i64 %1322, %1288
  br i1 %1323, label %1324, label %1291

1324:
  %1325 = getelementptr inbounds double, ptr %1069, i64 %1288
  %1326 = load double, ptr %1325, align 8
  %1327 = fadd double %368, %1326
  %1328 = load ptr, ptr %275, align 8
  %1329 = fsub double %1327, %368
  %1330 = load i64, ptr %326, align 8
  %1331 = sitofp i64 %1330 to double
  %1332 = fmul double %1331, 0x3CC0000000000000
  %1333 = fsub double 1.000000e+00, %1332
  %1334 = fmul double %1329, %1333
  %1335 = load i64, ptr %327, align 8
  %1336 = getelementptr inbounds double, ptr %1328, i64 %1335
  store double %368, ptr %1336, align 8
  %1337 = load i64, ptr %328, align 8
  %1338 = getelementptr inbounds double, ptr %1328, i64 %1337
  store double %1334, ptr %1338, align 8
  %1339 = load double, ptr %17, align 8
  %1340 = fdiv double %1334, %1339
  %1341 = load i64, ptr %329, align 8
  %1342 = getelementptr inbounds double, ptr %1328, i64 %1341
  store double %1340, ptr %1342, align 8
  %1343 = load ptr, ptr %330, align 8
  %1344 = load ptr, ptr %331, align 8
  %1345 = load ptr, ptr %332, align 8
  tail call void %1343(ptr noundef %1328, ptr noundef %1344, ptr noundef %1345)
  %1346 = load ptr, ptr %333, align 8
  %1347 = load i64, ptr %334, align 8
  %1348 = getelementptr inbounds double, ptr %1328, i64 %1347
  %1349 = load ptr, ptr %332, align 8
  tail call void %1346(ptr noundef %1328, ptr noundef %1348, ptr noundef %1349, i64 noundef 1)
  %1350 = load i64, ptr %299, align 8
  %1351 = getelementptr inbounds double, ptr %1328, i64 %1350
  store double %1334, ptr %1351, align 8
  %1352 = load ptr, ptr %275, align 8
  %1353 = tail call fastcc i32 @act(ptr noundef nonnull %0, ptr noundef nonnull %1, ptr noundef %1352, double noundef %1327, ptr noundef %363, ptr nonnull %9, ptr %361)
  %1354 = icmp eq i32 %1353, 0
  br i1 %1354, label %1355, label %1497

1355:
  %1356 = fsub double %355, %1327
  %1357 = load double, ptr %17, align 8
  %1358 = fmul double %1357, 1.000000e-09
  %1359 = fcmp ugt double %1356, %1358
  br i1 %1359, label %1360, label %1364

1360:
  %1361 = phi double [ %1054, %1053 ], [ %1356, %1355 ]
  %1362 = phi double [ %391, %1053 ], [ %1327, %1355 ]
  %1363 = load i64, ptr %302, align 8
  br label %365

1364:
  %1365 = phi double [ %1327, %1355 ], [ %355, %1047 ]
  %1366 = getelementptr inbounds nuw i8, ptr %350, i64 16
  %1367 = load double, ptr %1366, align 8
  %1368 = fcmp olt double %1367, 1.000000e+300
  br i1 %1368, label %1369, label %1494

1369:
  %1370 = getelementptr inbounds nuw i8, ptr %350, i64 24
  %1371 = load double, ptr %1370, align 8
  %1372 = load i64, ptr %302, align 8
  %1373 = add nsw i64 %1372, 1
  %1374 = getelementptr inbounds double, ptr %9, i64 %1373
  %1375 = load ptr, ptr %275, align 8
  %1376 = load i64, ptr %322, align 8
  %1377 = icmp slt i64 %1376, 0
  %1378 = getelementptr inbounds nuw double, ptr %1375, i64 %1376
  %1379 = load double, ptr %1375, align 8
  %1380 = getelementptr i32, ptr %4, i64 %1372
  %1381 = getelementptr i8, ptr %1380, i64 4
  %1382 = xor i64 %1372, -1
  %1383 = getelementptr inbounds i32, ptr %1381, i64 %1382
  %1384 = load ptr, ptr %335, align 8
  %1385 = load i64, ptr %299, align 8
  %1386 = getelementptr inbounds double, ptr %1375, i64 %1385
  %1387 = load double, ptr %1386, align 8
  %1388 = load ptr, ptr %339, align 8
  %1389 = load ptr, ptr %340, align 8
  %1390 = load i64, ptr %341, align 8
  %1391 = shl i64 %1390, 3
  tail call void @llvm.memcpy.p0.p0.i64(ptr align 8 %1388, ptr align 8 %1389, i64 %1391, i1 false)
  %1392 = load i64, ptr %341, align 8
  %1393 = load i64, ptr %342, align 8
  %1394 = icmp slt i64 %1392, %1393
  %1395 = load ptr, ptr %339, align 8
  br i1 %1394, label %1396, label %1409

1396:
  %1397 = load ptr, ptr %340, align 8
  %1398 = getelementptr inbounds double, ptr %1397, i64 %1392
  br label %1399

1399:
  %1400 = phi i64 [ %1392, %1396 ], [ %1407, %1399 ]
  %1401 = getelementptr inbounds double, ptr %1397, i64 %1400
  %1402 = load double, ptr %1401, align 8
  %1403 = load double, ptr %1398, align 8
  %1404 = fdiv double %1387, %1403
  %1405 = fmul double %1402, %1404
  %1406 = getelementptr inbounds double, ptr %1395, i64 %1400
  store double %1405, ptr %1406, align 8
  %1407 = add nsw i64 %1400, 1
  %1408 = icmp eq i64 %1407, %1393
  br i1 %1408, label %1409, label %1399

1409:
  %1410 = load ptr, ptr %332, align 8
  tail call void %1384(ptr noundef nonnull %9, ptr noundef nonnull %1375, ptr noundef %1395, ptr noundef %1410)
  %1411 = load ptr, ptr %335, align 8
  %1412 = load ptr, ptr %337, align 8
  %1413 = load ptr, ptr %275, align 8
  %1414 = load i64, ptr %299, align 8
  %1415 = getelementptr inbounds double, ptr %1413, i64 %1414
  %1416 = load double, ptr %1415, align 8
  %1417 = tail call fastcc ptr @set_out(ptr noundef nonnull %0, ptr noundef nonnull %1, ptr noundef %1413, double noundef %1416, double noundef %1371)
  %1418 = load ptr, ptr %332, align 8
  tail call void %1411(ptr noundef nonnull %1374, ptr noundef %1412, ptr noundef %1417, ptr noundef %1418)
  %1419 = load i64, ptr %302, align 8
  %1420 = icmp sgt i64 %1419, 0
  br i1 %1420, label %1421, label %1494

1421:
  %1422 = icmp eq ptr %1381, null
  br label %1423

1423:
  %1424 = phi i64 [ 0, %1421 ], [ %1456, %1454 ]
  %1425 = phi i1 [ false, %1421 ], [ %1455, %1454 ]
  br i1 %1377, label %1430, label %1426

1426:
  %1427 = getelementptr inbounds nuw double, ptr %1378, i64 %1424
  %1428 = load double, ptr %1427, align 8
  %1429 = fcmp ogt double %1428, %1367
  br i1 %1429, label %1449, label %1430

1430:
  %1431 = getelementptr inbounds nuw double, ptr %9, i64 %1424
  %1432 = load double, ptr %1431, align 8
  %1433 = getelementptr inbounds nuw double, ptr %1374, i64 %1424
  %1434 = load double, ptr %1433, align 8
  %1435 = load ptr, ptr %343, align 8
  %1436 = getelementptr inbounds nuw %struct.Event, ptr %1435, i64 %1424
  %1437 = load i32, ptr %1436, align 8
  %1438 = icmp sgt i32 %1437, -1
  %1439 = fcmp olt double %1432, 0.000000e+00
  %1440 = and i1 %1439, %1438
  %1441 = fcmp oge double %1434, 0.000000e+00
  %1442 = and i1 %1441, %1440
  br i1 %1442, label %1449, label %1443

1443:
  %1444 = icmp slt i32 %1437, 1
  %1445 = fcmp ogt double %1432, 0.000000e+00
  %1446 = and i1 %1445, %1444
  %1447 = fcmp ole double %1434, 0.000000e+00
  %1448 = and i1 %1447, %1446
  br label %1449

1449:
  %1450 = phi i1 [ false, %1426 ], [ %1448, %1443 ], [ true, %1430 ]
  br i1 %1422, label %1454, label %1451

1451:
  %1452 = zext i1 %1450 to i32
  %1453 = getelementptr inbounds nuw i32, ptr %1383, i64 %1424
  store i32 %1452, ptr %1453, align 4
  br label %1454

1454:
  %1455 = or i1 %1425, %1450
  %1456 = add nuw nsw i64 %1424, 1
  %1457 = icmp eq i64 %1456, %1419
  br i1 %1457, label %1458, label %1423

1458:
  br i1 %1455, label %1459, label %1494

1459:
  %1460 = getelementptr inbounds double, ptr %1374, i64 %1373
  %1461 = fsub double %1371, %1367
  %1462 = load ptr, ptr %275, align 8
  %1463 = load double, ptr %1462, align 8
  %1464 = fadd double %1461, %1463
  store double %1464, ptr %1462, align 8
  %1465 = fadd double %1367, %1371
  %1466 = fmul double %1465, 5.000000e-01
  %1467 = tail call fastcc i32 @act(ptr noundef nonnull %0, ptr noundef nonnull %1, ptr noundef nonnull %1462, double noundef %1466, ptr noundef %1383, ptr nonnull %1460, ptr %1381)
  %1468 = freeze i32 %1467
  %1469 = load ptr, ptr %275, align 8
  store double %1379, ptr %1469, align 8
  %1470 = icmp eq i32 %1468, 0
  br i1 %1470, label %1494, label %1497

1471:
  %1472 = load i64, ptr %326, align 8
  %1473 = sitofp i64 %1472 to double
  %1474 = fmul double %1473, 0x3CC0000000000000
  %1475 = fsub double 1.000000e+00, %1474
  %1476 = fmul double %353, %1475
  %1477 = load i64, ptr %327, align 8
  %1478 = getelementptr inbounds double, ptr %276, i64 %1477
  store double %351, ptr %1478, align 8
  %1479 = load i64, ptr %328, align 8
  %1480 = getelementptr inbounds double, ptr %276, i64 %1479
  store double %1476, ptr %1480, align 8
  %1481 = load double, ptr %17, align 8
  %1482 = fdiv double %1476, %1481
  %1483 = load i64, ptr %329, align 8
  %1484 = getelementptr inbounds double, ptr %276, i64 %1483
  store double %1482, ptr %1484, align 8
  %1485 = load ptr, ptr %330, align 8
  %1486 = load ptr, ptr %331, align 8
  %1487 = load ptr, ptr %332, align 8
  tail call void %1485(ptr noundef %276, ptr noundef %1486, ptr noundef %1487)
  %1488 = load ptr, ptr %333, align 8
  %1489 = load i64, ptr %334, align 8
  %1490 = getelementptr inbounds double, ptr %276, i64 %1489
  %1491 = load ptr, ptr %332, align 8
  tail call void %1488(ptr noundef %276, ptr noundef %1490, ptr noundef %1491, i64 noundef 1)
  %1492 = load i64, ptr %299, align 8
  %1493 = getelementptr inbounds double, ptr %276, i64 %1492
  store double %1476, ptr %1493, align 8
  br label %1494

1494:
  %1495 = add nuw nsw i64 %349, 1
  %1496 = icmp eq i64 %1495, %347
  br i1 %1496, label %1497, label %348

1497:
  %1498 = phi double [ %274, %318 ], [ %1327, %1324 ], [ %1365, %1459 ], [ %274, %1494 ]
  %1499 = getelementptr inbounds nuw i8, ptr %0, i64 264
  %1500 = load i64, ptr %1499, align 8
  %1501 = getelementptr inbounds double, ptr %276, i64 %1500
  store double %1498, ptr %1501, align 8
  %1502 = load ptr, ptr %1, align 8
  %1503 = load i64, ptr %0, align 8
  %1504 = getelementptr inbounds double, ptr %1502, i64 %1503
  %1505 = load double, ptr %1504, align 8
  %1506 = fadd double %278, 1.000000e+00
  %1507 = load double, ptr %17, align 8
  %1508 = fmul double %1506, %1507
  %1509 = fadd double %1505, %1508
  %1510 = fsub double %1498, %1509
  %1511 = fadd double %1505, %1510
  %1512 = getelementptr inbounds nuw i8, ptr %0, i64 272
  %1513 = load i64, ptr %1512, align 8
  %1514 = getelementptr inbounds double, ptr %276, i64 %1513
  store double %1511, ptr %1514, align 8
  %1515 = getelementptr inbounds nuw i8, ptr %0, i64 416
  %1516 = load ptr, ptr %1515, align 8
  %1517 = getelementptr inbounds nuw i8, ptr %1, i64 48
  %1518 = load ptr, ptr %1517, align 8
  %1519 = getelementptr inbounds nuw i8, ptr %1, i64 8
  %1520 = load ptr, ptr %1519, align 8
  tail call void %1516(ptr noundef %276, ptr noundef %1518, ptr noundef %1520)
  %1521 = load ptr, ptr %1, align 8
  %1522 = load i64, ptr %0, align 8
  %1523 = shl i64 %1522, 3
  tail call void @llvm.memcpy.p0.p0.i64(ptr align 8 %1521, ptr align 8 %276, i64 %1523, i1 false)
  br label %1541

1524:
  %1525 = load double, ptr %270, align 8
  %1526 = load i64, ptr %0, align 8
  %1527 = getelementptr inbounds double, ptr %270, i64 %1526
  %1528 = load double, ptr %1527, align 8
  %1529 = fcmp une double %1525, %1528
  %1530 = getelementptr inbounds nuw i8, ptr %0, i64 400
  %1531 = load ptr, ptr %1530, align 8
  %1532 = getelementptr inbounds nuw i8, ptr %1, i64 120
  %1533 = load ptr, ptr %1532, align 8
  %1534 = getelementptr inbounds nuw i8, ptr %1, i64 8
  %1535 = load ptr, ptr %1534, align 8
  tail call void %1531(ptr noundef nonnull %270, ptr noundef %1533, ptr noundef %1535, i64 noundef 1)
  br i1 %1529, label %1536, label %1541

1536:
  %1537 = load ptr, ptr %1, align 8
  %1538 = load i64, ptr %0, align 8
  %1539 = getelementptr inbounds double, ptr %1537, i64 %1538
  %1540 = load double, ptr %1539, align 8
  store double %1540, ptr %1537, align 8
  br label %1541

1541:
  ret void
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
  %39 = getelementptr inbounds nuw i8, ptr %1, i64 128
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

define internal fastcc range(i32 0, 2) i32 @act(ptr noundef %0, ptr noundef nonnull captures(none) initializes((160, 164)) %1, ptr noundef %2, double noundef %3, ptr noundef readonly captures(address_is_null) %4, ptr %5, ptr %6) unnamed_addr {
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
  %27 = getelementptr inbounds nuw i8, ptr %1, i64 160
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
  %40 = load i64, ptr %15, align 8
  %41 = icmp sgt i64 %40, 0
  br i1 %41, label %42, label %77

42:
  %43 = getelementptr inbounds nuw i8, ptr %0, i64 448
  %44 = load ptr, ptr %43, align 8
  %45 = getelementptr inbounds nuw i8, ptr %0, i64 200
  %46 = load i64, ptr %45, align 8
  %47 = getelementptr inbounds double, ptr %2, i64 %46
  %48 = load double, ptr %47, align 8
  %49 = getelementptr inbounds nuw i8, ptr %1, i64 56
  %50 = load ptr, ptr %49, align 8
  %51 = getelementptr inbounds nuw i8, ptr %1, i64 120
  %52 = load ptr, ptr %51, align 8
  %53 = getelementptr inbounds nuw i8, ptr %0, i64 40
  %54 = load i64, ptr %53, align 8
  %55 = shl i64 %54, 3
  tail call void @llvm.memcpy.p0.p0.i64(ptr align 8 %50, ptr align 8 %52, i64 %55, i1 false)
  %56 = load i64, ptr %53, align 8
  %57 = getelementptr inbounds nuw i8, ptr %0, i64 32
  %58 = load i64, ptr %57, align 8
  %59 = icmp slt i64 %56, %58
  %60 = load ptr, ptr %49, align 8
  br i1 %59, label %61, label %74

61:
  %62 = load ptr, ptr %51, align 8
  %63 = getelementptr inbounds double, ptr %62, i64 %56
  br label %64

64:
  %65 = phi i64 [ %56, %61 ], [ %72, %64 ]
  %66 = getelementptr inbounds double, ptr %62, i64 %65
  %67 = load double, ptr %66, align 8
  %68 = load double, ptr %63, align 8
  %69 = fdiv double %48, %68
  %70 = fmul double %67, %69
  %71 = getelementptr inbounds double, ptr %60, i64 %65
  store double %70, ptr %71, align 8
  %72 = add nsw i64 %65, 1
  %73 = icmp eq i64 %72, %58
  br i1 %73, label %74, label %64

74:
  %75 = getelementptr inbounds nuw i8, ptr %1, i64 8
  %76 = load ptr, ptr %75, align 8
  tail call void %44(ptr noundef %20, ptr noundef nonnull %2, ptr noundef %60, ptr noundef %76)
  br label %77

77:
  %78 = getelementptr inbounds nuw i8, ptr %0, i64 56
  %79 = load i64, ptr %78, align 8
  %80 = icmp sgt i64 %79, 0
  br i1 %80, label %81, label %247

81:
  %82 = icmp eq ptr %2, null
  %83 = or i1 %82, %23
  %84 = getelementptr inbounds nuw i8, ptr %0, i64 360
  %85 = getelementptr inbounds nuw i8, ptr %0, i64 64
  %86 = getelementptr inbounds nuw i8, ptr %1, i64 128
  %87 = getelementptr inbounds nuw i8, ptr %0, i64 368
  %88 = getelementptr inbounds nuw i8, ptr %1, i64 152
  %89 = getelementptr inbounds nuw i8, ptr %0, i64 280
  %90 = getelementptr inbounds nuw i8, ptr %0, i64 392
  br label %91

91:
  %92 = phi i64 [ 0, %81 ], [ %244, %243 ]
  %93 = getelementptr inbounds nuw i32, ptr %4, i64 %92
  %94 = load i32, ptr %93, align 4
  %95 = icmp eq i32 %94, 0
  br i1 %95, label %243, label %96

96:
  br i1 %83, label %106, label %97

97:
  %98 = load ptr, ptr %84, align 8
  %99 = getelementptr inbounds nuw %struct.Event, ptr %98, i64 %92
  %100 = getelementptr inbounds nuw i8, ptr %99, i64 16
  %101 = load double, ptr %100, align 8
  %102 = fcmp ogt double %101, 0.000000e+00
  %103 = fadd double %3, %101
  %104 = select i1 %102, double %103, double -1.000000e+300
  %105 = getelementptr inbounds nuw double, ptr %24, i64 %92
  store double %104, ptr %105, align 8
  br label %106

106:
  %107 = load i64, ptr %85, align 8
  %108 = icmp sgt i64 %107, %92
  br i1 %108, label %171, label %109

109:
  %110 = load ptr, ptr %1, align 8
  %111 = load i64, ptr %0, align 8
  %112 = getelementptr double, ptr %110, i64 %111
  %113 = getelementptr i8, ptr %112, i64 16
  %114 = sub nsw i64 %92, %107
  %115 = mul nuw nsw i64 %114, 176
  %116 = getelementptr inbounds nuw i8, ptr %113, i64 %115
  %117 = getelementptr inbounds nuw i8, ptr %116, i64 16
  %118 = load double, ptr %112, align 8
  %119 = fsub double %3, %118
  %120 = load double, ptr %86, align 8
  %121 = fdiv double %119, %120
  %122 = fadd double %121, -1.000000e-09
  %123 = tail call double @llvm.ceil.f64(double %122)
  %124 = getelementptr inbounds nuw i8, ptr %116, i64 8
  %125 = load double, ptr %124, align 8
  %126 = fcmp oeq double %125, 2.000000e+01
  br i1 %126, label %127, label %129

127:
  %128 = getelementptr inbounds nuw i8, ptr %116, i64 24
  tail call void @llvm.memmove.p0.p0.i64(ptr noundef nonnull align 8 dereferenceable(152) %117, ptr noundef nonnull align 8 dereferenceable(152) %128, i64 152, i1 false)
  br label %133

129:
  %130 = fadd double %125, 1.000000e+00
  store double %130, ptr %124, align 8
  %131 = fptosi double %130 to i32
  %132 = sext i32 %131 to i64
  br label %133

133:
  %134 = phi i64 [ %132, %129 ], [ 20, %127 ]
  %135 = getelementptr double, ptr %117, i64 %134
  %136 = getelementptr i8, ptr %135, i64 -8
  store double %123, ptr %136, align 8
  %137 = load double, ptr %124, align 8
  %138 = fcmp oeq double %137, 2.000000e+01
  br i1 %138, label %139, label %243

139:
  %140 = load double, ptr %117, align 8
  %141 = fsub double %123, %140
  %142 = fcmp olt double %141, 6.000000e+01
  br i1 %142, label %143, label %243

143:
  %144 = load double, ptr %116, align 8
  %145 = fptosi double %144 to i32
  %146 = icmp sgt i32 %145, 0
  br i1 %146, label %147, label %155

147:
  %148 = phi i32 [ %150, %147 ], [ %145, %143 ]
  %149 = phi double [ %151, %147 ], [ 1.000000e+00, %143 ]
  %150 = add nsw i32 %148, -1
  %151 = fmul double %149, 2.000000e+00
  %152 = icmp samesign ugt i32 %148, 1
  br i1 %152, label %147, label %153

153:
  %154 = fadd double %151, -1.000000e+00
  br label %155

155:
  %156 = phi double [ 0.000000e+00, %143 ], [ %154, %153 ]
  %157 = load ptr, ptr %1, align 8
  %158 = load i64, ptr %0, align 8
  %159 = getelementptr inbounds double, ptr %157, i64 %158
  %160 = load double, ptr %159, align 8
  %161 = load double, ptr %86, align 8
  %162 = fmul double %123, %161
  %163 = fadd double %160, %162
  %164 = fmul double %156, %161
  %165 = fadd double %164, %163
  %166 = load i64, ptr %21, align 8
  %167 = getelementptr inbounds nuw double, ptr %2, i64 %166
  %168 = getelementptr inbounds nuw double, ptr %167, i64 %92
  store double %165, ptr %168, align 8
  %169 = load double, ptr %116, align 8
  %170 = fadd double %169, 1.000000e+00
  store double %170, ptr %116, align 8
  store double 0.000000e+00, ptr %124, align 8
  br label %243

171:
  %172 = load ptr, ptr %84, align 8
  %173 = getelementptr inbounds nuw %struct.Event, ptr %172, i64 %92
  %174 = getelementptr inbounds nuw i8, ptr %173, i64 8
  %175 = load i32, ptr %174, align 8
  %176 = getelementptr inbounds nuw i8, ptr %173, i64 12
  %177 = load i32, ptr %176, align 4
  %178 = icmp slt i32 %175, %177
  br i1 %178, label %179, label %205

179:
  %180 = load i64, ptr %28, align 8
  %181 = load ptr, ptr %87, align 8
  %182 = getelementptr double, ptr %2, i64 %180
  %183 = sext i32 %175 to i64
  %184 = sext i32 %177 to i64
  br label %185

185:
  %186 = phi i64 [ %183, %179 ], [ %203, %197 ]
  %187 = getelementptr inbounds double, ptr %20, i64 %186
  %188 = load double, ptr %187, align 8
  %189 = fsub double %188, %188
  %190 = fcmp oeq double %189, 0.000000e+00
  br i1 %190, label %197, label %191

191:
  %192 = load ptr, ptr %1, align 8
  %193 = load i64, ptr %0, align 8
  %194 = getelementptr double, ptr %192, i64 %193
  %195 = getelementptr i8, ptr %194, i64 8
  store double 4.000000e+00, ptr %195, align 8
  %196 = load double, ptr %187, align 8
  br label %197

197:
  %198 = phi double [ %196, %191 ], [ %188, %185 ]
  %199 = getelementptr inbounds i32, ptr %181, i64 %186
  %200 = load i32, ptr %199, align 4
  %201 = sext i32 %200 to i64
  %202 = getelementptr double, ptr %182, i64 %201
  store double %198, ptr %202, align 8
  %203 = add nsw i64 %186, 1
  %204 = icmp eq i64 %203, %184
  br i1 %204, label %205, label %185

205:
  %206 = getelementptr inbounds nuw i8, ptr %173, i64 4
  %207 = load i32, ptr %206, align 4
  %208 = icmp eq i32 %207, 0
  br i1 %208, label %217, label %209

209:
  %210 = load ptr, ptr %1, align 8
  %211 = load i64, ptr %0, align 8
  %212 = getelementptr double, ptr %210, i64 %211
  %213 = getelementptr i8, ptr %212, i64 8
  %214 = load double, ptr %213, align 8
  %215 = fcmp oeq double %214, 0.000000e+00
  br i1 %215, label %216, label %217

216:
  store double 1.000000e+00, ptr %213, align 8
  br label %217

217:
  %218 = load ptr, ptr %88, align 8
  %219 = getelementptr inbounds nuw i32, ptr %218, i64 %92
  %220 = load i32, ptr %219, align 4
  %221 = add nsw i32 %220, 1
  store i32 %221, ptr %219, align 4
  %222 = load i64, ptr %89, align 8
  %223 = sub nsw i64 %107, %222
  %224 = icmp sgt i64 %223, %92
  br i1 %224, label %232, label %225

225:
  %226 = load ptr, ptr %90, align 8
  %227 = sub nsw i64 %92, %223
  %228 = getelementptr inbounds nuw i32, ptr %226, i64 %227
  %229 = load i32, ptr %228, align 4
  %230 = icmp eq i32 %229, 0
  %231 = select i1 %230, i32 50, i32 20000
  br label %232

232:
  %233 = phi i32 [ 50, %217 ], [ %231, %225 ]
  %234 = icmp slt i32 %221, %233
  br i1 %234, label %243, label %235

235:
  %236 = load ptr, ptr %1, align 8
  %237 = load i64, ptr %0, align 8
  %238 = getelementptr double, ptr %236, i64 %237
  %239 = getelementptr i8, ptr %238, i64 8
  %240 = load double, ptr %239, align 8
  %241 = fcmp oeq double %240, 0.000000e+00
  br i1 %241, label %242, label %243

242:
  store double 2.000000e+00, ptr %239, align 8
  br label %243

243:
  %244 = add nuw nsw i64 %92, 1
  %245 = load i64, ptr %78, align 8
  %246 = icmp sgt i64 %245, %244
  br i1 %246, label %91, label %247

247:
  %248 = getelementptr inbounds nuw i8, ptr %0, i64 280
  %249 = load i64, ptr %248, align 8
  %250 = icmp sgt i64 %249, 0
  br i1 %250, label %251, label %396

251:
  %252 = load ptr, ptr %1, align 8
  %253 = load i64, ptr %0, align 8
  %254 = getelementptr double, ptr %252, i64 %253
  %255 = getelementptr i8, ptr %254, i64 8
  %256 = load double, ptr %255, align 8
  %257 = fcmp oeq double %256, 0.000000e+00
  br i1 %257, label %258, label %396

258:
  %259 = getelementptr inbounds nuw i8, ptr %0, i64 304
  %260 = load i64, ptr %259, align 8
  %261 = getelementptr inbounds double, ptr %18, i64 %260
  %262 = load i64, ptr %28, align 8
  %263 = getelementptr inbounds double, ptr %2, i64 %262
  %264 = getelementptr inbounds nuw i8, ptr %0, i64 200
  %265 = load i64, ptr %264, align 8
  %266 = getelementptr inbounds double, ptr %2, i64 %265
  %267 = load double, ptr %266, align 8
  %268 = getelementptr inbounds nuw i8, ptr %1, i64 56
  %269 = load ptr, ptr %268, align 8
  %270 = getelementptr inbounds nuw i8, ptr %1, i64 120
  %271 = load ptr, ptr %270, align 8
  %272 = getelementptr inbounds nuw i8, ptr %0, i64 40
  %273 = load i64, ptr %272, align 8
  %274 = shl i64 %273, 3
  tail call void @llvm.memcpy.p0.p0.i64(ptr align 8 %269, ptr align 8 %271, i64 %274, i1 false)
  %275 = load i64, ptr %272, align 8
  %276 = getelementptr inbounds nuw i8, ptr %0, i64 32
  %277 = load i64, ptr %276, align 8
  %278 = icmp slt i64 %275, %277
  %279 = load ptr, ptr %268, align 8
  br i1 %278, label %280, label %293

280:
  %281 = load ptr, ptr %270, align 8
  %282 = getelementptr inbounds double, ptr %281, i64 %275
  br label %283

283:
  %284 = phi i64 [ %275, %280 ], [ %291, %283 ]
  %285 = getelementptr inbounds double, ptr %281, i64 %284
  %286 = load double, ptr %285, align 8
  %287 = load double, ptr %282, align 8
  %288 = fdiv double %267, %287
  %289 = fmul double %286, %288
  %290 = getelementptr inbounds double, ptr %279, i64 %284
  store double %289, ptr %290, align 8
  %291 = add nsw i64 %284, 1
  %292 = icmp eq i64 %291, %277
  br i1 %292, label %293, label %283

293:
  %294 = getelementptr inbounds nuw i8, ptr %0, i64 64
  %295 = load i64, ptr %294, align 8
  %296 = getelementptr inbounds i32, ptr %4, i64 %295
  %297 = load i64, ptr %248, align 8
  %298 = sub i64 0, %297
  %299 = getelementptr inbounds i32, ptr %296, i64 %298
  %300 = getelementptr inbounds nuw i8, ptr %8, i64 8
  store ptr %6, ptr %300, align 8
  %301 = getelementptr inbounds nuw i8, ptr %1, i64 72
  %302 = load ptr, ptr %301, align 8
  %303 = load i64, ptr %259, align 8
  %304 = getelementptr inbounds double, ptr %302, i64 %303
  %305 = getelementptr inbounds nuw i8, ptr %0, i64 312
  %306 = load i64, ptr %305, align 8
  %307 = getelementptr inbounds double, ptr %304, i64 %306
  %308 = load i64, ptr %78, align 8
  %309 = getelementptr double, ptr %261, i64 %308
  %310 = getelementptr i8, ptr %309, i64 8
  %311 = xor i64 %308, -1
  %312 = getelementptr inbounds double, ptr %310, i64 %311
  %313 = getelementptr inbounds double, ptr %310, i64 %303
  %314 = getelementptr inbounds double, ptr %313, i64 %297
  store ptr %314, ptr %8, align 8
  %315 = shl i64 %297, 3
  tail call void @llvm.memset.p0.i64(ptr align 8 %313, i8 0, i64 %315, i1 false)
  %316 = getelementptr inbounds nuw i8, ptr %0, i64 464
  %317 = load ptr, ptr %316, align 8
  %318 = getelementptr inbounds nuw i8, ptr %1, i64 8
  %319 = load ptr, ptr %318, align 8
  tail call void %317(ptr noundef %302, ptr noundef nonnull %2, ptr noundef %279, ptr noundef %319)
  %320 = load i64, ptr %259, align 8
  %321 = shl i64 %320, 3
  tail call void @llvm.memcpy.p0.p0.i64(ptr align 8 %310, ptr align 8 %307, i64 %321, i1 false)
  %322 = icmp eq ptr %4, null
  br i1 %322, label %356, label %323

323:
  %324 = getelementptr inbounds nuw i8, ptr %0, i64 440
  %325 = load ptr, ptr %324, align 8
  %326 = load ptr, ptr %318, align 8
  tail call void %325(ptr noundef %312, ptr noundef nonnull %2, ptr noundef %279, ptr noundef %326)
  %327 = load i64, ptr %248, align 8
  %328 = icmp sgt i64 %327, 0
  br i1 %328, label %329, label %356

329:
  %330 = getelementptr inbounds nuw i8, ptr %0, i64 376
  br label %331

331:
  %332 = phi i64 [ 0, %329 ], [ %354, %353 ]
  %333 = getelementptr inbounds nuw i32, ptr %299, i64 %332
  %334 = load i32, ptr %333, align 4
  %335 = icmp eq i32 %334, 0
  br i1 %335, label %353, label %336

336:
  %337 = load ptr, ptr %330, align 8
  %338 = getelementptr inbounds nuw i32, ptr %337, i64 %332
  %339 = load i32, ptr %338, align 4
  %340 = sext i32 %339 to i64
  %341 = getelementptr inbounds double, ptr %263, i64 %340
  %342 = load double, ptr %341, align 8
  %343 = fcmp une double %342, 0.000000e+00
  br i1 %343, label %344, label %353

344:
  %345 = load i64, ptr %294, align 8
  %346 = sub nsw i64 %345, %327
  %347 = getelementptr double, ptr %312, i64 %346
  %348 = getelementptr double, ptr %347, i64 %332
  %349 = load double, ptr %348, align 8
  %350 = tail call double @llvm.fabs.f64(double %349)
  %351 = fmul double %350, 0x3DA5FD7FE1796495
  %352 = getelementptr inbounds nuw double, ptr %313, i64 %332
  store double %351, ptr %352, align 8
  br label %353

353:
  %354 = add nuw nsw i64 %332, 1
  %355 = icmp eq i64 %354, %327
  br i1 %355, label %356, label %331

356:
  %357 = load ptr, ptr %270, align 8
  %358 = getelementptr inbounds nuw i8, ptr %0, i64 320
  %359 = load i64, ptr %358, align 8
  %360 = getelementptr inbounds double, ptr %302, i64 %359
  %361 = load ptr, ptr %318, align 8
  %362 = tail call fastcc i32 @decide(ptr noundef nonnull %0, ptr noundef %302, ptr noundef nonnull %263, ptr noundef %357, ptr noundef readonly %299, ptr noundef %313, ptr noundef %360, ptr noundef %361, ptr noundef nonnull byval(%struct.Room) align 8 %8)
  %363 = icmp eq i32 %362, 0
  br i1 %363, label %364, label %369

364:
  %365 = load ptr, ptr %1, align 8
  %366 = load i64, ptr %0, align 8
  %367 = getelementptr double, ptr %365, i64 %366
  %368 = getelementptr i8, ptr %367, i64 8
  store double 3.000000e+00, ptr %368, align 8
  br label %369

369:
  %370 = load i64, ptr %259, align 8
  %371 = icmp sgt i64 %370, 0
  br i1 %371, label %372, label %382

372:
  %373 = phi i64 [ %380, %372 ], [ 0, %369 ]
  %374 = getelementptr inbounds nuw double, ptr %307, i64 %373
  %375 = load double, ptr %374, align 8
  %376 = getelementptr inbounds nuw double, ptr %310, i64 %373
  %377 = load double, ptr %376, align 8
  %378 = fsub double %375, %377
  %379 = getelementptr inbounds nuw double, ptr %18, i64 %373
  store double %378, ptr %379, align 8
  %380 = add nuw nsw i64 %373, 1
  %381 = icmp eq i64 %380, %370
  br i1 %381, label %383, label %372

382:
  br label %396

383:
  %384 = getelementptr inbounds nuw i8, ptr %0, i64 256
  %385 = load i64, ptr %384, align 8
  %386 = getelementptr double, ptr %2, i64 %385
  br label %387

387:
  %388 = phi i64 [ 0, %383 ], [ %394, %387 ]
  %389 = getelementptr inbounds nuw double, ptr %18, i64 %388
  %390 = load double, ptr %389, align 8
  %391 = getelementptr double, ptr %386, i64 %388
  %392 = load double, ptr %391, align 8
  %393 = fadd double %390, %392
  store double %393, ptr %391, align 8
  %394 = add nuw nsw i64 %388, 1
  %395 = icmp eq i64 %394, %370
  br i1 %395, label %396, label %387

396:
  %397 = load i64, ptr %9, align 8
  %398 = icmp sgt i64 %397, 0
  br i1 %398, label %399, label %413

399:
  %400 = load i64, ptr %28, align 8
  %401 = getelementptr double, ptr %2, i64 %400
  %402 = load i64, ptr %35, align 8
  %403 = getelementptr double, ptr %2, i64 %402
  br label %404

404:
  %405 = phi i64 [ 0, %399 ], [ %411, %404 ]
  %406 = getelementptr double, ptr %401, i64 %405
  %407 = load double, ptr %406, align 8
  %408 = getelementptr double, ptr %403, i64 %405
  store double %407, ptr %408, align 8
  %409 = getelementptr inbounds nuw double, ptr %14, i64 %405
  %410 = load double, ptr %409, align 8
  store double %410, ptr %406, align 8
  %411 = add nuw nsw i64 %405, 1
  %412 = icmp eq i64 %411, %397
  br i1 %412, label %413, label %404

413:
  %414 = load ptr, ptr %1, align 8
  %415 = load i64, ptr %0, align 8
  %416 = getelementptr double, ptr %414, i64 %415
  %417 = getelementptr i8, ptr %416, i64 8
  %418 = load double, ptr %417, align 8
  %419 = fcmp une double %418, 0.000000e+00
  %420 = zext i1 %419 to i32
  ret i32 %420
}

define internal fastcc void @look(ptr noundef readonly captures(none) %0, ptr noundef nonnull readonly captures(none) %1, double noundef %2, ptr noundef %3) unnamed_addr {
  %5 = fcmp oeq double %2, 0.000000e+00
  br i1 %5, label %10, label %6

6:
  %7 = getelementptr inbounds nuw i8, ptr %1, i64 144
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
  %26 = getelementptr inbounds nuw i8, ptr %1, i64 136
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
  %40 = getelementptr inbounds nuw i8, ptr %1, i64 128
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

declare i32 @llvm.smin.i32(i32, i32)
