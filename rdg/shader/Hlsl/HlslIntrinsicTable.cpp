// The table of HLSL's functions. Source: Microsoft's reference of HLSL (intrinsic functions, shader models 5 to 6.7).
#include "HlslIntrinsicTable.h"

#include <algorithm>
#include <unordered_map>

namespace Drydock::Hlsl
{

namespace
{

struct FIntrinsicRow
{
	const char* Signature;
	const char* Names;
	bool bPure = true;
};

constexpr bool ImpureIntrinsic = false;

// A function with several rows has as many overloads; the narrower one stands first. mul's row is for scalars.
// clang-format off
constexpr FIntrinsicRow IntrinsicRows[] = {
	// By components
	{"n*(n*)", "abs"},
	{"s*(n*)", "sign"},
	{"r*(r*)", "acos asin atan cos cosh degrees exp exp2 log log10 log2 radians sin sinh tan tanh"},
	{"d*(d*)", "ceil floor frac rcp round rsqrt saturate sqrt trunc"},
	{"r*(r*, r*)", "atan2 ldexp pow"},
	{"d*(d*, d*)", "fmod step"},
	{"n*(n*, n*)", "max min"},
	{"n*(n*, n*, n*)", "clamp mad"},
	{"d*(d*, d*, d*)", "lerp smoothstep"},
	{"D*(D*, D*, D*)", "fma"},
	{"b*(d*)", "isfinite isinf isnan"},
	{"r*(r*, >s*)", "modf", ImpureIntrinsic},
	{"r*(r*, >r*)", "frexp modf", ImpureIntrinsic},
	{"void(r*, >r*, >r*)", "sincos", ImpureIntrinsic},
	{"void(r*)", "clip", ImpureIntrinsic},
	{"b*(b*, b*)", "and or"},
	{"a*(b*, a*, a*)", "select"},
	{"b(b*)", "all any"},
	{"a*(a*)", "NonUniformResourceIndex"},
	// Bits
	{"f*(x*)", "asfloat"},
	{"s*(x*)", "asint"},
	{"u*(x*)", "asuint"},
	{"void(D*, >u*, >u*)", "asuint"},
	{"D*(u*, u*)", "asdouble"},
	{"H*(y*)", "asfloat16"},
	{"S*(y*)", "asint16"},
	{"W*(y*)", "asuint16"},
	{"f*(u*)", "f16tof32"},
	{"u*(f*)", "f32tof16"},
	{"u*(i*)", "countbits firstbithigh firstbitlow"},
	{"i*(i*)", "reversebits"},
	{"u4(u4, u4)", "AddUint64"},
	{"u2(u2, u2)", "AddUint64"},
	{"u4(u, u2, u4)", "msad4"},
	{"f(h2, h2, f)", "dot2add"},
	{"u(u, u, u)", "dot4add_u8packed"},
	{"s(u, u, s)", "dot4add_i8packed"},
	{"u(W4)", "pack_u8"},
	{"u(S4)", "pack_s8 pack_clamp_s8 pack_clamp_u8"},
	{"u(u4)", "pack_u8"},
	{"u(s4)", "pack_s8 pack_clamp_s8 pack_clamp_u8"},
	{"W4(u)", "unpack_u8u16"},
	{"S4(u)", "unpack_s8s16"},
	{"u4(u)", "unpack_u8u32"},
	{"s4(u)", "unpack_s8s32"},
	{"s4(r4)", "D3DCOLORtoUBYTE4"},
	// Vectors and matrices
	{"n(nv, nv)", "dot"},
	{"d(dv)", "length"},
	{"d(dv, dv)", "distance"},
	{"dv(dv)", "normalize"},
	{"dv(dv, dv)", "reflect"},
	{"rv(rv, rv, r)", "refract"},
	{"rv(rv, rv, rv)", "faceforward"},
	{"d3(d3, d3)", "cross"},
	{"r4(r4, r4)", "dst"},
	{"r4(r, r, r)", "lit"},
	{"r(rq)", "determinant"},
	{"at(am)", "transpose"},
	{"n*(n*, n*)", "mul"},
	// Pixels
	{"r*(r*)", "ddx ddx_coarse ddx_fine ddy ddy_coarse ddy_fine fwidth", ImpureIntrinsic},
	{"n*(n*)", "EvaluateAttributeCentroid", ImpureIntrinsic},
	{"n*(n*, u)", "EvaluateAttributeAtSample", ImpureIntrinsic},
	{"n*(n*, s2)", "EvaluateAttributeSnapped", ImpureIntrinsic},
	{"u()", "GetRenderTargetSampleCount", ImpureIntrinsic},
	{"f2(s)", "GetRenderTargetSamplePosition", ImpureIntrinsic},
	{"b()", "IsHelperLane", ImpureIntrinsic},
	{"b(u)", "CheckAccessFullyMapped"},
	// Groups
	{"void()", "AllMemoryBarrier AllMemoryBarrierWithGroupSync DeviceMemoryBarrier DeviceMemoryBarrierWithGroupSync "
		"GroupMemoryBarrier GroupMemoryBarrierWithGroupSync", ImpureIntrinsic},
	{"void(&i, i, ?>i)", "InterlockedAdd InterlockedAnd InterlockedMax InterlockedMin InterlockedOr InterlockedXor", ImpureIntrinsic},
	{"void(&e, e, >e)", "InterlockedExchange", ImpureIntrinsic},
	{"void(&i, i, i)", "InterlockedCompareStore", ImpureIntrinsic},
	{"void(&i, i, i, >i)", "InterlockedCompareExchange", ImpureIntrinsic},
	{"void(&f, f, f)", "InterlockedCompareStoreFloatBitwise", ImpureIntrinsic},
	{"void(&f, f, f, >f)", "InterlockedCompareExchangeFloatBitwise", ImpureIntrinsic},
	// Waves
	{"b()", "WaveIsFirstLane", ImpureIntrinsic},
	{"u()", "WaveGetLaneCount WaveGetLaneIndex", ImpureIntrinsic},
	{"b(b)", "QuadAll QuadAny WaveActiveAllTrue WaveActiveAnyTrue", ImpureIntrinsic},
	{"b*(a*)", "WaveActiveAllEqual", ImpureIntrinsic},
	{"u4(b)", "WaveActiveBallot", ImpureIntrinsic},
	{"u(b)", "WaveActiveCountBits WavePrefixCountBits", ImpureIntrinsic},
	{"n*(n*)", "WaveActiveMax WaveActiveMin WaveActiveProduct WaveActiveSum WavePrefixProduct WavePrefixSum", ImpureIntrinsic},
	{"i*(i*)", "WaveActiveBitAnd WaveActiveBitOr WaveActiveBitXor", ImpureIntrinsic},
	{"u4(a*)", "WaveMatch", ImpureIntrinsic},
	{"n*(n*, u4)", "WaveMultiPrefixProduct WaveMultiPrefixSum", ImpureIntrinsic},
	{"i*(i*, u4)", "WaveMultiPrefixBitAnd WaveMultiPrefixBitOr WaveMultiPrefixBitXor", ImpureIntrinsic},
	{"u(b, u4)", "WaveMultiPrefixCountBits", ImpureIntrinsic},
	{"a*(a*)", "QuadReadAcrossDiagonal QuadReadAcrossX QuadReadAcrossY WaveReadLaneFirst", ImpureIntrinsic},
	{"a*(a*, u)", "QuadReadLaneAt WaveReadLaneAt", ImpureIntrinsic},
};

struct FRefusedRow
{
	const char* Names;
	const char* Why;
};

constexpr FRefusedRow RefusedRows[] = {
	{"AcceptHitAndEndSearch AllocateRayQuery CallShader DispatchRaysDimensions DispatchRaysIndex GeometryIndex "
		"GetRemainingRecursionLevels HitKind IgnoreHit InstanceID InstanceIndex ObjectRayDirection ObjectRayOrigin "
		"ObjectToWorld ObjectToWorld3x4 ObjectToWorld4x3 PrimitiveIndex RayFlags RayTCurrent RayTMin ReportHit TraceRay "
		"WorldRayDirection WorldRayOrigin WorldToObject WorldToObject3x4 WorldToObject4x3",
		"ray tracing does not run on the CPU tier; march through the depth texture, or read what the G-buffer has"},
	{"DispatchMesh SetMeshOutputCounts", "mesh shaders do not run on the CPU tier; use a compute shader"},
	{"Process2DQuadTessFactorsAvg Process2DQuadTessFactorsMax Process2DQuadTessFactorsMin ProcessIsolineTessFactors "
		"ProcessQuadTessFactorsAvg ProcessQuadTessFactorsMax ProcessQuadTessFactorsMin ProcessTriTessFactorsAvg "
		"ProcessTriTessFactorsMax ProcessTriTessFactorsMin", "tessellation does not run on the CPU tier; use a compute shader"},
	{"abort errorf printf", "messages of shaders are not kept here; use ShaderPrint.ush, which run --print shows"},
	{"noise", "it is of texture shaders (tx_1_0); use the noise of Random.ush"},
	{"GetAttributeAtVertex", "a pixel shader here has no vertices; take the interpolated value"},
	{"tex1D tex2D tex3D texCUBE", "it is of Direct3D 9; write Texture.Sample(Sampler, UV)"},
	{"tex1Dbias tex2Dbias tex3Dbias texCUBEbias", "it is of Direct3D 9; write Texture.SampleBias(Sampler, UV, Bias)"},
	{"tex1Dgrad tex2Dgrad tex3Dgrad texCUBEgrad", "it is of Direct3D 9; write Texture.SampleGrad(Sampler, UV, DDX, DDY)"},
	{"tex1Dlod tex2Dlod tex3Dlod texCUBElod", "it is of Direct3D 9; write Texture.SampleLevel(Sampler, UV, Level)"},
	{"tex1Dproj tex2Dproj tex3Dproj texCUBEproj", "it is of Direct3D 9; write Texture.Sample(Sampler, UV / W)"},
};
// clang-format on

struct FIntrinsicTable
{
	std::vector<FIntrinsic> Functions;
	std::unordered_map<std::string_view, size_t> ByName;

	FIntrinsic& Get(std::string_view Name)
	{
		const auto [Found, bNew] = ByName.try_emplace(Name, Functions.size());
		if (bNew)
		{
			Functions.emplace_back().Name = Name;
		}
		return Functions[Found->second];
	}

	FIntrinsicTable()
	{
		for (const FIntrinsicRow& Row : IntrinsicRows)
		{
			std::string_view Names = Row.Names;
			for (std::string_view Name = TakeName(Names); !Name.empty(); Name = TakeName(Names))
			{
				FIntrinsic& Function = Get(Name);
				Function.Signatures.push_back(ReadSignature(Row.Signature));
				Function.bPure = Row.bPure;
			}
		}
		for (const FRefusedRow& Row : RefusedRows)
		{
			std::string_view Names = Row.Names;
			for (std::string_view Name = TakeName(Names); !Name.empty(); Name = TakeName(Names))
			{
				FIntrinsic& Function = Get(Name);
				Function.Refused = Row.Why;
				Function.bPure = false;
			}
		}
	}
};

const FIntrinsicTable& GetIntrinsicTable()
{
	static const FIntrinsicTable Table;
	return Table;
}

FPattern ReadPattern(std::string_view Word)
{
	FPattern Pattern;
	if (Word == "void")
	{
		return Pattern;
	}
	for (const char Letter : Word)
	{
		Pattern.bOptional = Pattern.bOptional || Letter == '?';
		Pattern.bOut = Pattern.bOut || Letter == '>';
		Pattern.bPlace = Pattern.bPlace || Letter == '&';
		if (Letter != '?' && Letter != '>' && Letter != '&')
		{
			(Pattern.Scalar ? Pattern.Shape : Pattern.Scalar) = Letter;
		}
	}
	return Pattern;
}

} // namespace

std::string_view TakeName(std::string_view& Names)
{
	const size_t End = std::min(Names.find(' '), Names.size());
	const std::string_view Name = Names.substr(0, End);
	Names.remove_prefix(std::min(End + 1, Names.size()));
	return Name;
}

FSignature ReadSignature(std::string_view Text)
{
	FSignature Signature;
	const size_t Open = Text.find('(');
	Signature.Result = ReadPattern(Text.substr(0, Open));
	std::string_view Rest = Text.substr(Open + 1);
	while (!Rest.empty() && Rest.front() != ')')
	{
		const size_t End = Rest.find_first_of(",)");
		Signature.Parameters.push_back(ReadPattern(Rest.substr(0, End)));
		Rest.remove_prefix(Rest[End] == ',' ? End + 2 : End);
	}
	return Signature;
}

const FIntrinsic* FindIntrinsic(std::string_view Name)
{
	const FIntrinsicTable& Table = GetIntrinsicTable();
	const auto Found = Table.ByName.find(Name);
	return Found == Table.ByName.end() ? nullptr : &Table.Functions[Found->second];
}

std::span<const FIntrinsic> GetIntrinsics()
{
	return GetIntrinsicTable().Functions;
}

} // namespace Drydock::Hlsl
