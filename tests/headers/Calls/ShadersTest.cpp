// Calls of shaders: intrinsics, functions of the engine's includes, members of View. Each is an expression of a shader
// that the test writes; it runs inside a frame, and its value is compared with plain double.
#include "Calls.h"
#include "FrameCalls.h"

#include "GlobalShader.h"
#include "PostProcess/PostProcessing.h"
#include "RenderGraphUtils.h"
#include "ShaderCore.h"
#include "ShaderParameterStruct.h"

#include <cmath>
#include <filesystem>
#include <fstream>
#include <unistd.h>

namespace
{

constexpr Calls::EArea Area = Calls::EArea::Shaders;

class FShaderCallsCS : public FGlobalShader
{
public:
	DECLARE_GLOBAL_SHADER(FShaderCallsCS);
	SHADER_USE_PARAMETER_STRUCT(FShaderCallsCS, FGlobalShader);

	BEGIN_SHADER_PARAMETER_STRUCT(FParameters, )
		SHADER_PARAMETER_STRUCT_REF(FViewUniformShaderParameters, View)
		SHADER_PARAMETER_STRUCT_INCLUDE(FSceneTextureShaderParameters, SceneTextures)
		SHADER_PARAMETER_STRUCT(FScreenPassTextureViewportParameters, Input)
		SHADER_PARAMETER(FVector4f, A)
		SHADER_PARAMETER(FVector4f, B)
		SHADER_PARAMETER(FIntVector4, I)
		SHADER_PARAMETER(FVector4f, Transform)
		SHADER_PARAMETER_RDG_TEXTURE(Texture2D, Tex)
		SHADER_PARAMETER_SAMPLER(SamplerState, TexSampler)
		SHADER_PARAMETER_RDG_TEXTURE_UAV(RWTexture2D<float4>, OutTexture)
	END_SHADER_PARAMETER_STRUCT()
};
IMPLEMENT_GLOBAL_SHADER(FShaderCallsCS, "/DrydockCalls/ShaderCalls.usf", "MainCS", SF_Compute);

// The parameters A and B, and of I.
constexpr double X = 0.25, Y = 0.5, Z = 0.75, W = 1.0;
constexpr double P = 2.0, Q = 3.0, R = -4.0, S = 5.5;
constexpr double Pi = 3.14159265358979323846;
constexpr double Width = Calls::FrameWidth, Height = Calls::FrameHeight;

/** A call: what it is, its expression, of one to four components, and their values. */
struct FShaderCall
{
	const char* Name;
	const char* Expression;
	std::vector<double> Values;
};

double Fold(double V)
{
	return V - std::floor(V);
}

const std::vector<FShaderCall>& GetCalls()
{
	static const std::vector<FShaderCall> List = {
		{"lerp", "lerp(A.x, B.y, A.y)", {(X + Q) / 2}},
		{"lerp of vectors", "lerp(A, B, 0.25f)", {X + (P - X) / 4, Y + (Q - Y) / 4, Z + (R - Z) / 4, W + (S - W) / 4}},
		{"dot", "dot(A.xyz, B.xyz)", {X * P + Y * Q + Z * R}},
		{"abs", "abs(B.zw)", {4, 5.5}},
		{"max, min", "float2(max(A.x, B.z), min(A.x, B.z))", {X, R}},
		{"clamp, saturate", "float2(clamp(B.w, 0.0f, 2.0f), saturate(B.z))", {2, 0}},
		{"pow", "pow(A.x, B.y)", {X * X * X}},
		{"exp, exp2", "float2(exp(A.x), exp2(A.y))", {std::exp(X), std::exp2(Y)}},
		{"log, log2, log10", "float3(log(B.x), log2(B.x), log10(B.x))", {std::log(P), 1, std::log10(P)}},
		{"sin, cos, tan", "float3(sin(A.x), cos(A.x), tan(A.x))", {std::sin(X), std::cos(X), std::tan(X)}},
		{"asin, acos, atan", "float3(asin(A.x), acos(A.x), atan(A.x))", {std::asin(X), std::acos(X), std::atan(X)}},
		{"atan2", "atan2(A.x, B.z)", {std::atan2(X, R)}},
		{"sinh, cosh, tanh", "float3(sinh(A.x), cosh(A.x), tanh(A.x))", {std::sinh(X), std::cosh(X), std::tanh(X)}},
		{"sincos", "SinCos(A.x)", {std::sin(X), std::cos(X)}},
		{"sqrt, rsqrt, rcp", "float3(sqrt(A.x), rsqrt(A.x), rcp(A.x))", {Y, 2, 4}},
		{"length, distance", "float2(length(A.xy), distance(A.xy, B.xy))",
			{std::hypot(X, Y), std::hypot(P - X, Q - Y)}},
		{"normalize", "normalize(B.xy)", {P / std::hypot(P, Q), Q / std::hypot(P, Q)}},
		{"cross", "cross(A.xyz, B.xyz)", {Y * R - Z * Q, Z * P - X * R, X * Q - Y * P}},
		{"reflect", "reflect(A.xy, float2(0, 1))", {X, -Y}},
		{"refract", "refract(float2(0, -1), float2(0, 1), A.x)", {0, -1}},
		{"faceforward", "faceforward(A.xy, float2(0, 1), float2(0, 1))", {-X, -Y}},
		{"smoothstep, step", "float2(smoothstep(0.0f, 1.0f, A.x), step(A.y, A.x))", {X * X * (3 - 2 * X), 0}},
		{"floor, ceil, round, trunc", "float4(floor(B.w), ceil(A.x), round(A.z), trunc(-B.w))", {5, 1, 1, -5}},
		{"frac, fmod", "float2(frac(-A.x), fmod(B.w, B.x))", {Z, 1.5}},
		{"modf", "Modf(B.w)", {5, 0.5}},
		{"sign", "float3(sign(B.z), sign(A.x), sign(0.0f))", {-1, 1, 0}},
		{"mad, fma by mad", "mad(A.x, B.x, B.y)", {X * P + Q}},
		{"ldexp, frexp by ldexp", "ldexp(A.x, 3.0f)", {2}},
		{"degrees, radians", "float2(degrees(A.x), radians(B.w))", {X * 180 / Pi, S * Pi / 180}},
		{"any, all", "float2(any(B > 3.0f), all(B > 3.0f))", {1, 0}},
		{"isnan, isinf, isfinite", "float3(isnan(A.x), isinf(A.x), isfinite(A.x))", {0, 0, 1}},
		{"asuint, asint, asfloat", "float2(asuint(A.w) == 0x3f800000, asfloat(asint(A.x)))", {1, X}},
		{"f16tof32, f32tof16", "f16tof32(f32tof16(A.x))", {X}},
		{"countbits, reversebits, firstbithigh, firstbitlow",
			"float4(countbits(uint(I.x)), reversebits(uint(I.y)) >> 28, firstbithigh(uint(I.x)), "
			"firstbitlow(uint(I.y)))",
			{3, 4, 2, 1}},
		{"mul(vector, matrix), float2x2", "mul(A.xy, float2x2(B.x, B.y, B.z, B.w))", {X * P + Y * R, X * Q + Y * S}},
		{"mul(matrix, vector), transpose", "mul(transpose(float2x2(B.x, B.y, B.z, B.w)), A.xy)",
			{X * P + Y * R, X * Q + Y * S}},
		{"determinant", "determinant(float2x2(B.x, B.y, B.z, B.w))", {P * S - Q * R}},
		{"float3x3, float4x4, row access", "float3x3(1, 2, 3, 4, 5, 6, 7, 8, 9)[1]", {4, 5, 6}},
		{"select", "float3(select(A.x > 0.0f, A.y, B.x), select(A.xy > 0.3f, B.xy, A.xy))", {Y, X, Q}},
		{"swizzles of scalars and l-values", "Swizzle(A)", {Z, X, X, 7}},
		{"integer arithmetic, %, bit operations", "float4(I.x % 4, I.x / 2, (I.x ^ I.y) & 7, I.x << 2)", {3, 3, 5, 28}},
		{"arrays, loops, switch, while, discard-free flow", "Loop(I.y)", {10}},
		{"static const arrays", "Table[I.y]", {30}},
		{"structs, out and inout parameters", "Structs(A)", {X * 2, Y + 1}},
		{"Texture2DSampleLevel", "Texture2DSampleLevel(Tex, TexSampler, float2(0.5f, 0.5f), 0)", {0.25, 0.25, 0.25, 1}},
		{"Texture2DSample", "Texture2DSample(Tex, TexSampler, float2(0.5f, 0.5f)).r", {0.25}},
		{"Tex.SampleLevel", "Tex.SampleLevel(TexSampler, A.xy, 0).g", {0.25}},
		{"Tex.Load", "Tex.Load(int3(1, 1, 0)).b", {0.25}},
		{"Tex[uint2]", "Tex[uint2(1, 1)].a", {1}},
		{"Tex.GetDimensions", "Dimensions()", {Width, Height}},
		{"Tex.Gather", "Tex.GatherRed(TexSampler, float2(0.5f, 0.5f))", {0.25, 0.25, 0.25, 0.25}},
		{"GlobalPointClampedSampler, GlobalBilinearClampedSampler",
			"float2(Tex.SampleLevel(GlobalPointClampedSampler, A.xy, 0).r, "
			"Tex.SampleLevel(GlobalBilinearClampedSampler, A.xy, 0).r)",
			{0.25, 0.25}},
		{"View.SharedBilinearClampedSampler, SharedPointClampedSampler",
			"Tex.SampleLevel(View.SharedBilinearClampedSampler, A.xy, 0).r", {0.25}},
		{"Square, Pow2, Pow3, Pow4, Pow5", "float4(Square(B.z), Pow2(B.z), Pow3(B.z), Pow5(B.x))", {16, 16, -64, 32}},
		{"max3, min3, max4, min4",
			"float4(max3(B.x, B.y, B.z), min3(B.x, B.y, B.z), max4(B.x, B.y, B.z, B.w), min4(B.x, B.y, B.z, B.w))",
			{3, -4, 5.5, -4}},
		{"PositiveClampedPow, ClampedPow", "float2(PositiveClampedPow(B.z, 2.0f), ClampedPow(B.z, 2.0f))", {0, 16}},
		{"MakePositiveFinite, MakeFinite, ClampToHalfFloatRange",
			"float3(MakePositiveFinite(B.z), MakeFinite(B.z), ClampToHalfFloatRange(B.w))", {0, -4, 5.5}},
		{"SafeRcp, SafeDivide, SafeSqrt", "float3(SafeRcp(B.x), SafeDivide(B.y, 0.0f), SafeSqrt(B.z))", {0.5, 0, 0}},
		{"SafeNormalize, Length2", "float4(SafeNormalize(float3(0, B.y, 0)), Length2(A.xy))", {0, 1, 0, X * X + Y * Y}},
		{"Luminance", "Luminance(A.xyz)", {0.3 * X + 0.59 * Y + 0.11 * Z}},
		{"VectorSum", "float2(VectorSum(A), VectorSum(A.xy))", {X + Y + Z + W, X + Y}},
		{"rcpFast, rsqrtFast, sqrtFast", "float3(rcpFast(A.x), rsqrtFast(A.x), sqrtFast(A.x))", {4, 2, Y}},
		{"PI, HALF_PI, MaxHalfFloat", "float3(PI, HALF_PI, MaxHalfFloat)", {Pi, Pi / 2, 65504}},
		{"InterleavedGradientNoise", "InterleavedGradientNoise(B.xy, 0.0f)",
			{Fold(52.9829189 * Fold(P * 0.06711056 + Q * 0.00583715))}},
		{"PseudoRandom", "PseudoRandom(A.xy) >= 0.0f && PseudoRandom(A.xy) < 1.0f ? 1.0f : 0.0f", {1}},
		{"Rand3DPCG16, Rand3DPCG32",
			"float2(all(Rand3DPCG16(int3(I.xyz)) < 65536u), any(Rand3DPCG32(int3(I.xyz)) > 65536u))", {1, 1}},
		{"LinearToSrgb, sRGBToLinear", "float2(LinearToSrgb(A.x), sRGBToLinear(A.x))",
			{1.055 * std::pow(X, 1 / 2.4) - 0.055, std::pow((X + 0.055) / 1.055, 2.4)}},
		{"LinearTo709Branchless, LinearToSrgbBranchless", "LinearTo709Branchless(A.x)",
			{1.099 * std::pow(X, 0.45) - 0.099}},
		{"LinearToST2084, ST2084ToLinear",
			"float3(abs(ST2084ToLinear(LinearToST2084(float3(1, 2, 3))) / float3(1, 2, 3) - 1.0f) < 0.001f)",
			{1, 1, 1}},
		{"LinearRGB_2_HSV, HSV_2_LinearRGB", "HSV_2_LinearRGB(LinearRGB_2_HSV(A.xyz))", {X, Y, Z}},
		{"RGBToYCoCg, YCoCgToRGB", "RGBToYCoCg(A.xyz)", {(X + 2 * Y + Z) / 4, (X - Z) / 2, (-X + 2 * Y - Z) / 4}},
		{"MortonEncode, MortonDecode", "float2(MortonDecode(MortonEncode(uint2(I.xy))))", {7, 2}},
		{"Hammersley", "Hammersley(1u, 4u, uint2(0, 0))", {0.25, 0.5}},
		{"UniformSampleDisk, CosineSampleHemisphere",
			"float2(length(UniformSampleDisk(A.xy)), length(CosineSampleHemisphere(A.xy).xyz))", {std::sqrt(Y), 1}},
		{"ImportanceSampleGGX", "length(ImportanceSampleGGX(A.xy, A.z).xyz)", {1}},
		{"GetTangentBasis, TangentToWorld", "TangentToWorld(float3(0, 0, 1), float3(0, 1, 0))", {0, 1, 0}},
		{"EncodeNormal, DecodeNormal", "DecodeNormal(EncodeNormal(A.xyz))", {X, Y, Z}},
		{"DecodeShadingModelId, EncodeShadingModelIdAndSelectiveOutputMask",
			"DecodeShadingModelId(EncodeShadingModelIdAndSelectiveOutputMask(uint(I.x), 16u))", {7}},
		{"SHADINGMODELID_UNLIT, SHADINGMODELID_DEFAULT_LIT, SHADINGMODELID_CLOTH",
			"float3(SHADINGMODELID_UNLIT, SHADINGMODELID_DEFAULT_LIT, SHADINGMODELID_CLOTH)", {0, 1, 8}},
		{"ComputeF0", "ComputeF0(0.5f, A.xyz, 0.0f)", {0.04, 0.04, 0.04}},
		{"UnitVectorToOctahedron, OctahedronToUnitVector",
			"OctahedronToUnitVector(UnitVectorToOctahedron(float3(0, 0, 1)))", {0, 0, 1}},
		{"D_GGX, F_Schlick, Vis_SmithJointApprox", "D_GGX(A.x, 1.0f)", {1 / (Pi * X)}},
		{"SHBasisFunction3, DotSH3, CalcDiffuseTransferSH3",
			"DotSH3(SHBasisFunction3(float3(0, 0, 1)), SHBasisFunction3(float3(0, 0, 1)))", {9 / (4 * Pi)}},
		{"HenyeyGreensteinPhase, RayleighPhase", "HenyeyGreensteinPhase(0.0f, A.x)", {1 / (4 * Pi)}},
		{"acosFast, asinFast, atanFast, atan2Fast", "abs(acosFast(A.x) - acos(A.x)) < 0.01f ? 1.0f : 0.0f", {1}},
		{"LineBoxIntersect, RayIntersectSphere", "LineBoxIntersect(float3(-2, 0, 0), float3(2, 0, 0), -1.0f, 1.0f)",
			{0.25, 0.75}},
		{"ComputeDistanceFromBoxToPoint",
			"ComputeDistanceFromBoxToPoint(float3(-1, -1, -1), float3(1, 1, 1), float3(3, 0, 0))", {2}},
		{"ReverseBits32", "float(ReverseBits32(uint(I.y)) >> 28)", {4}},
		{"LWCToFloat, LWCHackToFloat, DFHackToFloat, DFDemote", "float2(LWCToFloat(A.x), DFHackToFloat(A.y))", {X, Y}},
		{"ApplyScreenTransform, FScreenTransform", "ApplyScreenTransform(A.xy, Transform)", {X * 2 + 1, Y * 3 + 2}},
		{"SCREEN_PASS_TEXTURE_VIEWPORT: Input_Extent, Input_ExtentInverse", "float4(Input_Extent, Input_ExtentInverse)",
			{Width, Height, 1 / Width, 1 / Height}},
		{"Input_ViewportMin, Input_ViewportMax", "float4(Input_ViewportMin, Input_ViewportMax)", {0, 0, Width, Height}},
		{"Input_ViewportSize, Input_ViewportSizeInverse", "float4(Input_ViewportSize, Input_ViewportSizeInverse)",
			{Width, Height, 1 / Width, 1 / Height}},
		{"Input_UVViewportMin, Input_UVViewportMax, Input_UVViewportSize",
			"float4(Input_UVViewportMin, Input_UVViewportMax)", {0, 0, 1, 1}},
		{"Input_UVViewportBilinearMin, Input_UVViewportBilinearMax",
			"float4(Input_UVViewportBilinearMin, Input_UVViewportBilinearMax)",
			{0.5 / Width, 0.5 / Height, 1 - 0.5 / Width, 1 - 0.5 / Height}},
		{"Input_ScreenPosToViewportScale, Input_ScreenPosToViewportBias",
			"float4(Input_ScreenPosToViewportScale, Input_ScreenPosToViewportBias)",
			{Width / 2, -Height / 2, Width / 2, Height / 2}},
		{"SvPositionToBufferUV, SvPositionToViewportUV",
			"float4(SvPositionToBufferUV(float4(6, 3, 0, 1)), SvPositionToViewportUV(float4(6, 3, 0, 1)))",
			{0.25, 0.25, 0.25, 0.25}},
		{"ViewportUVToBufferUV, BufferUVToViewportUV", "float4(ViewportUVToBufferUV(A.xy), BufferUVToViewportUV(A.xy))",
			{X, Y, X, Y}},
		{"ViewportUVToScreenPos, ScreenPosToViewportUV",
			"float4(ViewportUVToScreenPos(A.xy), ScreenPosToViewportUV(A.xy))",
			{2 * X - 1, 1 - 2 * Y, 0.5 + X / 2, 0.5 - Y / 2}},
		{"ScreenPosToBufferUV", "ScreenPosToBufferUV(A.xy)", {0.5 + X / 2, 0.5 - Y / 2}},
		{"ConvertFromDeviceZ, ConvertToDeviceZ", "ConvertFromDeviceZ(ConvertToDeviceZ(300.0f)) / 300.0f", {1}},
		{"SvPositionToTranslatedWorld, SvPositionToWorld",
			"SvPositionToWorld(float4(12, 6, ConvertToDeviceZ(100.0f), 1)) / 100.0f - View.WorldCameraOrigin / 100.0f "
			"- View.ViewForward",
			{0, 0, 0}},
		{"SvPositionToScreenPosition, GetScreenPositionForProjectionType",
			"SvPositionToScreenPosition(float4(12, 6, 0.5f, 1))", {0, 0, 0.5, 1}},
		{"GetWorldPositionFromScreenUV, GetTranslatedWorldPositionFromScreenUV",
			"(GetWorldPositionFromScreenUV(float2(0.5f, 0.5f), 100.0f) - View.WorldCameraOrigin) / 100.0f - "
			"View.ViewForward",
			{0, 0, 0}},
		{"Calculate3DVelocity", "Calculate3DVelocity(float4(2, 4, 6, 2), float4(1, 1, 1, 1))", {0, 1, 2}},
		{"EncodeVelocityToTexture, DecodeVelocityFromTexture",
			"DecodeVelocityFromTexture(EncodeVelocityToTexture(float3(A.xy, 0))).xy", {X, Y}},
		{"CalcSceneColor", "CalcSceneColor(A.xy)", {0.25, 0.25, 0.25}},
		{"CalcSceneColorAndDepth, CalcSceneDepth",
			"float4(CalcSceneColorAndDepth(A.xy).rgb, CalcSceneColorAndDepth(A.xy).w == CalcSceneDepth(A.xy))",
			{0.25, 0.25, 0.25, 1}},
		{"LookupDeviceZ", "LookupDeviceZ(A.xy)", {0}},
		{"CalcSceneCustomDepth, CalcSceneCustomStencil", "CalcSceneCustomStencil(uint2(1, 1))", {0}},
		{"GetGBufferData, GetGBufferDataUint",
			"GetGBufferData(A.xy, false).Metallic - GetGBufferDataUint(uint2(6, 6), false).Metallic", {0}},
		{"GetScreenSpaceData, FScreenSpaceData.GBuffer",
			"GetScreenSpaceData(A.xy, false).GBuffer.ShadingModelID == GetGBufferData(A.xy, false).ShadingModelID ? "
			"1.0f : 0.0f",
			{1}},
		{"View.ViewSizeAndInvSize", "View.ViewSizeAndInvSize", {Width, Height, 1 / Width, 1 / Height}},
		{"View.BufferSizeAndInvSize", "View.BufferSizeAndInvSize", {Width, Height, 1 / Width, 1 / Height}},
		{"View.ViewRectMin, View.ViewRectMinAndSize", "float4(View.ViewRectMin.xy, View.ViewRectMinAndSize.zw)",
			{0, 0, Width, Height}},
		{"View.BufferBilinearUVMinMax", "View.BufferBilinearUVMinMax",
			{0.5 / Width, 0.5 / Height, 1 - 0.5 / Width, 1 - 0.5 / Height}},
		{"View.ScreenPositionScaleBias", "View.ScreenPositionScaleBias", {0.5, -0.5, 0.5, 0.5}},
		{"View.PreExposure, View.OneOverPreExposure", "float2(View.PreExposure, View.OneOverPreExposure)", {1, 1}},
		{"View.ViewForward, ViewUp, ViewRight",
			"float3(length(View.ViewForward), length(View.ViewUp), dot(View.ViewRight, View.ViewForward))", {1, 1, 0}},
		{"View.WorldCameraOrigin, TranslatedWorldCameraOrigin, PreViewTranslation",
			"View.WorldCameraOrigin + View.PreViewTranslation", {0, 0, 0}},
		{"View.ClipToView, ViewToClip", "mul(mul(float4(A.xyz, 1), View.ViewToClip), View.ClipToView)", {X, Y, Z, 1}},
		{"View.TranslatedWorldToClip, ClipToTranslatedWorld",
			"mul(mul(float4(A.xyz, 1), View.TranslatedWorldToClip), View.ClipToTranslatedWorld)", {X, Y, Z, 1}},
		{"View.ClipToPrevClip (a still camera)", "mul(float4(A.xyz, 1), View.ClipToPrevClip)", {X, Y, Z, 1}},
		{"View.ScreenToTranslatedWorld, ScreenToWorld",
			"length(mul(float4(0, 0, 100, 1), View.ScreenToTranslatedWorld).xyz) / 100.0f", {1}},
		{"View.SVPositionToTranslatedWorld",
			"dot(normalize(SvPositionToTranslatedWorld(float4(12, 6, 0.5f, 1))), View.ViewForward)", {1}},
		{"View.TemporalAAJitter", "View.TemporalAAJitter", {0, 0, 0, 0}},
		{"View.GameTime, RealTime, DeltaTime",
			"float3(View.GameTime >= 0.0f, View.RealTime >= 0.0f, View.DeltaTime >= 0.0f)", {1, 1, 1}},
		{"View.StateFrameIndex, StateFrameIndexMod8, FrameNumber",
			"float(View.StateFrameIndex % 8u) - float(View.StateFrameIndexMod8)", {0}},
		{"View.InvDeviceZToWorldZTransform, NearPlane",
			"float2(View.NearPlane > 0.0f, ConvertFromDeviceZ(1.0f) / View.NearPlane)", {1, 1}},
		{"View.FieldOfViewWideAngles", "View.FieldOfViewWideAngles.x > 0.0f ? 1.0f : 0.0f", {1}},
		{"ResolvedView, PrimaryView", "float2(ResolvedView.PreExposure, PrimaryView.PreExposure)", {1, 1}},
		{"UNROLL, LOOP, BRANCH, FLATTEN", "Attributes(A.x)", {8 * X}},
		{"half, half3, half4, MaterialFloat", "float3(half3(A.xyz))", {X, Y, Z}},
		{"COMPUTESHADER, PIXELSHADER, FEATURE_LEVEL, SM5_PROFILE",
			"float3(COMPUTESHADER, PIXELSHADER, FEATURE_LEVEL >= FEATURE_LEVEL_SM5)", {1, 0, 1}},
		{"ValueNoise3D_ALU, PerlinRamp", "PerlinRamp(A.yyy)", {0.5, 0.5, 0.5}},
		{"DrawRectangle, FScreenVertexOutput", "float(sizeof_of_vertex_output())", {3}},
	};
	return List;
}

TRefCountPtr<IPooledRenderTarget> GValues;

void RunShader(FRDGBuilder& GraphBuilder, const FSceneView& View, const FPostProcessingInputs& Inputs)
{
	const int32 Num = static_cast<int32>(GetCalls().size());
	const FRDGTextureRef Values =
		GraphBuilder.CreateTexture(FRDGTextureDesc::Create2D(FIntPoint(Num, 1), PF_A32B32G32R32F,
									   FClearValueBinding::None, TexCreate_UAV | TexCreate_ShaderResource),
			TEXT("Calls.Values"));
	const FRDGTextureRef SceneColor = (*Inputs.SceneTextures)->SceneColorTexture;
	FShaderCallsCS::FParameters* const Parameters = GraphBuilder.AllocParameters<FShaderCallsCS::FParameters>();
	Parameters->View = View.ViewUniformBuffer;
	Parameters->SceneTextures = CreateSceneTextureShaderParameters(GraphBuilder, View, ESceneTextureSetupMode::All);
	Parameters->Input = GetScreenPassTextureViewportParameters(FScreenPassTextureViewport(SceneColor));
	Parameters->A = FVector4f(X, Y, Z, W);
	Parameters->B = FVector4f(P, Q, R, S);
	Parameters->I = FIntVector4(7, 2, 5, 1);
	Parameters->Transform = FVector4f(2, 3, 1, 2);
	Parameters->Tex = SceneColor;
	Parameters->TexSampler = TStaticSamplerState<SF_Bilinear, AM_Clamp, AM_Clamp, AM_Clamp>::GetRHI();
	Parameters->OutTexture = GraphBuilder.CreateUAV(Values);
	const TShaderMapRef<FShaderCallsCS> Shader(static_cast<const FViewInfo&>(View).ShaderMap);
	FComputeShaderUtils::AddPass(
		GraphBuilder, RDG_EVENT_NAME("ShaderCalls"), Shader, Parameters, FIntVector(Num, 1, 1));
	GraphBuilder.QueueTextureExtraction(Values, &GValues);
}

std::string WriteShader()
{
	std::string Text = "#include \"/Engine/Private/Common.ush\"\n";
	for (const char* const Include : {"BRDF", "ColorSpace", "DeferredShadingCommon", "GammaCorrectionCommon",
			 "MonteCarlo", "MortonCode", "ParticipatingMediaCommon", "PositionReconstructionCommon", "SHCommon",
			 "SceneTexturesCommon", "ScreenPass", "VelocityCommon"})
	{
		Text += "#include \"/Engine/Private/" + std::string(Include) + ".ush\"\n";
	}
	Text += R"(
float4 A;
float4 B;
int4 I;
FScreenTransform Transform;
SCREEN_PASS_TEXTURE_VIEWPORT(Input)
Texture2D Tex;
SamplerState TexSampler;
RWTexture2D<float4> OutTexture;
static const float Table[3] = {10, 20, 30};
float2 SinCos(float V) { float S, C; sincos(V, S, C); return float2(S, C); }
float2 Modf(float V) { float Whole; float Part = modf(V, Whole); return float2(Whole, Part); }
float4 Swizzle(float4 V) { float4 Out = V.x.xxxx; Out.r = V.z; Out.a = 7; return Out; }
float Loop(int N) { float Sum = 0; for (int i = 0; i < 4; ++i) { switch (i) { case 0: Sum += N; break; default: Sum += 2; break; } } while (Sum < 10) { Sum += 1; } return Sum; }
struct FPair { float First; float Second; };
void Fill(float V, out FPair Pair, inout float Other) { Pair.First = 2 * V; Pair.Second = 0; Other += 1; }
float2 Structs(float4 V) { FPair Pair; float Other = V.y; Fill(V.x, Pair, Other); return float2(Pair.First, Other); }
float2 Dimensions() { float Width, Height; Tex.GetDimensions(Width, Height); return float2(Width, Height); }
float Attributes(float V) { float Sum = 0; UNROLL for (int i = 0; i < 4; ++i) { Sum += V; } LOOP for (int j = 0; j < 4; ++j) { BRANCH if (V > 0) { Sum += V; } } return Sum; }
int sizeof_of_vertex_output() { FScreenVertexOutput Output; Output.UV = 1; Output.Position = 2; return int(Output.UV.x + Output.Position.x); }

[numthreads(1, 1, 1)]
void MainCS(uint2 Id : SV_DispatchThreadID)
{
	float4 V = 0;
	switch (Id.x)
	{
)";
	const char* const Masks[] = {"", "x", "xy", "xyz", "xyzw"};
	for (size_t Index = 0; Index < GetCalls().size(); ++Index)
	{
		const FShaderCall& Call = GetCalls()[Index];
		Text += "\tcase " + std::to_string(Index) + ": V." + Masks[Call.Values.size()] + " = " + Call.Expression +
				"; break;\n";
	}
	return Text + "\tdefault: break;\n\t}\n\tOutTexture[Id] = V;\n}\n";
}

} // namespace

TEST(CallsOfShaders, GiveTheValuesOfPlainDouble)
{
	const std::filesystem::path Folder =
		std::filesystem::temp_directory_path() / ("drydock_shader_calls_" + std::to_string(getpid()));
	std::filesystem::create_directories(Folder);
	std::ofstream(Folder / "ShaderCalls.usf") << WriteShader();
	AddShaderSourceDirectoryMapping(TEXT("/DrydockCalls"), FString(Folder.c_str()));
	Calls::RunInFrame({.Inputs = &RunShader});
	ASSERT_TRUE(GValues.IsValid());
	for (size_t Index = 0; Index < GetCalls().size(); ++Index)
	{
		const FShaderCall& Call = GetCalls()[Index];
		Calls::Record(Area, Calls::EState::There, Call.Name);
		const FLinearColor Value = GValues->GetRHI()->ReadTexel(static_cast<int32>(Index), 0);
		for (size_t Channel = 0; Channel < Call.Values.size(); ++Channel)
		{
			EXPECT_NEAR(Call.Values[Channel], Value.Component(static_cast<int32>(Channel)),
				2e-5 * std::max(1.0, std::abs(Call.Values[Channel])))
				<< Call.Name << ": " << Call.Expression << ", component " << Channel;
		}
	}
	GValues = nullptr;
	std::filesystem::remove_all(Folder);
}
