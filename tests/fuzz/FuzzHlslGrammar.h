// Writes random HLSL by a grammar: what the parser takes nearly always, and the analysis often.
#pragma once

#include <map>
#include <random>
#include <sstream>
#include <string>
#include <vector>

namespace Drydock
{

/** `Known` declares what `Short` and `Good` use, so that most of these texts compile. A row is a name and its forms,
 * between them `@`. `$Name` stands for a form of that name; the first form of a row ends soon, and is taken where the
 * text is deep. */
inline constexpr const char* FuzzGrammar = R"(
Unit @ $Main @ $Known $Short @ $Known $Short @ $Known $Main @ $Declaration $Unit @ $Declaration $Declaration $Unit
Known @ RWTexture2D<float4> Out; Texture2D<float4> Tex; RWBuffer<uint> Buf; StructuredBuffer<float4> In; RWByteAddressBuffer Bytes; SamplerState Sam; RWBuffer<uint> Many[3]; static float4 V0 = 1; static $Scalar V1; groupshared float3x3 V2; static float2 V3[4]; static int V4[2][3]; struct S { float A; int2 B; float Get() { return A; } }; struct R : S { float C; }; typedef float3 T; using U = uint2; enum E { E0, E1 = 4 }; enum class F : uint { F0 = 3 }; template<typename X> X G(X A) { return A; } template<typename X, int M = 2> struct W { X V[M]; }; static S S0; namespace N { float F0(float A) { return A * 2; } } float F0(float A, inout float4 B) { B += A; return A; } int F1(int A, out float4 B) { B = A; return A; } float Get(float A) { return A; }
Short @ [numthreads(8, 8, 1)] void Main(uint2 P : SV_DispatchThreadID, uint I : SV_GroupIndex) { $Simple $Simple Out[P] = V0 + V1 + V2[0].x; }
Simple @ V0 = $Good; @ V0.xy += $Good; @ if ($Good) { $Simple } else { $Simple } @ $Hint for (int i = 0; i < 4; ++i) { $Simple } @ V1 = $Good; @ V2[1] = $Good; @ switch (I) { case 1: $Simple break; default: $Simple break; } @ Buf[I] = $Good; @ V3[I & 3] = $Good; @ { float V0 = $Good; V1 = V0; } @ InterlockedAdd(Buf[I], $Good);
Good @ V1 @ V0.x @ $Number @ ($Good $Operator $Good) @ ($Good $Operator $Good) @ ($Good > 0 ? $Good : $Good) @ float($Good) @ int($Good) @ (bool)($Good) @ V2[I % 3].y @ V4[1][I % 3] @ S0.A @ S0.Get() @ G<float>($Good) @ N::F0($Good) @ F0($Good, V0) @ F1($Good, V0) @ In[I].w @ Tex[P].x @ Tex.SampleLevel(Sam, $Good, 0).z @ Bytes.Load(I * 4) @ Many[2][I] @ Many[I % 3][0] @ dot(V0, $Good) @ mul(V2, V0.xyz).y @ abs($Good) @ min($Good, $Good) @ fmod($Good, $Good) @ pow($Good, $Good) @ asuint(float($Good)) @ f16tof32(uint($Good)) @ countbits(uint($Good)) @ (half)($Good) @ (double)($Good) @ WaveActiveSum($Good) @ all(V0 > $Good) @ select($Good > 0, $Good, $Good) @ int(E::E1) @ V1++ @ (V1 = $Good) @ transpose(V2)[1].x @ sizeof(S) @ lit($Good, $Good, $Good).z @ frac($Good) @ round($Good)
Scalar @ float @ int @ uint @ half @ double
Main @ [numthreads(8, 8, 1)] void Main(uint2 P : SV_DispatchThreadID, uint I : SV_GroupIndex) { $Statements }
Declaration @ $Type $Variable; @ static $Type $Variable = $Value; @ static const $Type $Variable = $Value; @ groupshared $Type $Variable[8]; @ $Function @ $Struct @ $Resource @ $Template @ namespace N { $Declaration } @ enum E { E0, E1 = $Value }; @ enum class F : uint { F0 = 3 }; @ typedef $Type T; @ using U = $Type; @ cbuffer C { $Type $Variable : packoffset(c1.y); }
Function @ $Type $Callee($Type A, inout $Type B) { return A; } @ void $Callee(out $Type A, $Type B = $Value) { $Statements } @ $Type $Callee($Type A) { $Statements return $Value; }
Struct @ struct S { $Type A; $Type B; }; @ struct R : S { $Type C; $Type Get() { return A; } static $Type K; }; @ struct O { $Type A; O operator+(O B) { O C; C.A = A + B.A; return C; } };
Resource @ RWTexture2D<$Type> Out; @ Texture2D<$Type> Tex; @ RWBuffer<$Type> Buf; @ StructuredBuffer<$Type> In; @ RWStructuredBuffer<$Type> Structures; @ RWByteAddressBuffer Bytes; @ SamplerState Sam; @ RWBuffer<uint> Many[3]; @ Texture2DArray<float4> Layers; @ TextureCube Cube;
Template @ template<typename X> X G(X A) { return A; } @ template<typename X, int M = 2> struct W { X V[M]; }; @ template<> float G<float>(float A) { return $Value; }
Type @ float @ float4 @ int @ uint @ bool @ half @ double @ float2 @ float3 @ int2 @ uint3 @ bool4 @ float3x3 @ row_major float2x4 @ int3x2 @ min16float2 @ uint64_t @ int16_t @ vector<float, 3> @ matrix<int, 2, 2> @ S @ R @ T @ U @ E @ W<float> @ void
Variable @ V0 @ V1 @ V2 @ V3[4] @ V4[2][3]
Callee @ F0 @ F1 @ G @ Get
Statements @ $Statement @ $Statement $Statements @ $Statement $Statement $Statements
Statement @ ; @ $Place = $Value; @ $Place += $Value; @ $Type $Variable = $Value; @ $Type $Variable = { $Value, { $Value } }; @ if ($Value) { $Statements } @ if ($Value) $Statement else $Statement @ $Hint for (int i = 0; i < $Number; ++i) { $Statements } @ while ($Value) { $Statements break; } @ do { $Statements } while ($Value); @ switch ($Value) { case 1: $Statements break; default: break; } @ break; @ continue; @ return; @ return $Value; @ discard; @ { $Statements } @ $Value; @ $Place++; @ GroupMemoryBarrierWithGroupSync(); @ Out[P] = $Value; @ Buf[I] = $Value; @ Bytes.Store($Value, $Value); @ InterlockedAdd(Buf[I], $Value);
Hint @ [unroll] @ [loop] @ [unroll(4)] @ [branch] @ [flatten]
Place @ $Variable @ V0.$Parts @ V1[$Value] @ V2._m01 @ V2._11_22 @ V3[$Number].x @ Out[P] @ Buf[0] @ S0.A
Parts @ x @ xy @ rgba @ zyx @ xx @ www
Number @ 0 @ 1 @ 3 @ 255u @ 0.5 @ 1e30 @ -2 @ 1.5h @ 3.0L @ 0x7FFFFFFF @ 2147483648 @ 1.#INF @ true @ 010
Value @ $Number @ $Variable @ V0.$Parts @ $Place @ ($Value) @ -$Value @ !$Value @ ~$Value @ $Value $Operator $Value @ $Value $Operator $Value @ $Value ? $Value : $Value @ ($Type)$Value @ $Type($Value, $Value) @ $Type($Value) @ $Call @ $Call @ $Callee($Value, V0) @ G<$Type>($Value) @ N::F0($Value) @ E::E1 @ F::F0 @ sizeof($Type) @ $Number.xxx @ (float2x2)$Value @ ++V0 @ V1-- @ (V0 = $Value) @ Tex.Load(int3(P, 0)) @ Tex.SampleLevel(Sam, $Value, 0) @ In[$Value] @ Bytes.Load<$Type>($Value) @ Many[$Value][I] @ S0.Get() @ View.Time
Operator @ + @ - @ * @ / @ % @ & @ ^ @ << @ >> @ < @ >= @ == @ != @ && @ , @ =
Call @ abs($Value) @ dot($Value, $Value) @ mul($Value, $Value) @ lerp($Value, $Value, $Value) @ select($Value, $Value, $Value) @ and($Value, $Value) @ clamp($Value, $Value, $Value) @ fmod($Value, $Value) @ asuint($Value) @ asfloat($Value) @ f16tof32($Value) @ countbits($Value) @ any($Value) @ transpose($Value) @ determinant($Value) @ WaveActiveSum($Value) @ QuadReadAcrossX($Value) @ ddx($Value) @ normalize($Value) @ pow($Value, $Value) @ frexp($Value, V0) @ sincos($Value, V0, V1) @ lit($Value, $Value, $Value) @ msad4($Value, $Value, $Value)
)";

class FFuzzGrammar
{
public:
	FFuzzGrammar()
	{
		std::istringstream Rows(FuzzGrammar);
		for (std::string Row; std::getline(Rows, Row);)
		{
			size_t At = Row.find(" @ ");
			std::vector<std::string>& List = Forms[Row.substr(0, At)];
			while (At != std::string::npos)
			{
				const size_t Next = Row.find(" @ ", At + 3);
				List.push_back(Row.substr(At + 3, Next - At - 3));
				At = Next;
			}
		}
		Forms.erase("");
	}

	/** A text of Name, a row of the grammar. */
	std::string Write(const std::string& Name, std::mt19937& Random, int Depth = 8) const
	{
		const std::vector<std::string>& List = Forms.at(Name);
		const std::string& Form = List[Depth > 0 ? Random() % List.size() : 0];
		std::string Text;
		for (size_t At = 0; At < Form.size();)
		{
			const size_t Part = std::min(Form.find('$', At), Form.size());
			Text += Form.substr(At, Part - At);
			At = Part + 1;
			while (At < Form.size() && std::isalpha(static_cast<unsigned char>(Form[At])))
			{
				++At;
			}
			Text += Part < Form.size() ? Write(Form.substr(Part + 1, At - Part - 1), Random, Depth - 1) : "";
		}
		return Text;
	}

	/** A text of any row. */
	std::string WriteAny(std::mt19937& Random) const
	{
		return Write(std::next(Forms.begin(), std::ptrdiff_t(Random() % Forms.size()))->first, Random, 4);
	}

private:
	std::map<std::string, std::vector<std::string>> Forms;
};

} // namespace Drydock
