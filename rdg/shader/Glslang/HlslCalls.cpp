// Calls that become calls of functions written before the text: intrinsics that the front end lacks or gets wrong for
// some types.
#include "HlslRewrites.h"

#include <algorithm>
#include <map>

namespace Drydock
{

namespace
{

/** Their definitions by HLSL's specification, for the types that it has. */
const std::map<std::string, const char*> ReplacedIntrinsics = {
	{"AddUint64", "uint2 DrydockAddUint64(uint2 A, uint2 B) { uint Low = A.x + B.x; "
				  "return uint2(Low, A.y + B.y + (Low < A.x ? 1u : 0u)); } "
				  "uint4 DrydockAddUint64(uint4 A, uint4 B) { return uint4(DrydockAddUint64(A.xy, B.xy), "
				  "DrydockAddUint64(A.zw, B.zw)); }"},
	{"dot2add", "float DrydockDot2Add(float2 A, float2 B, float C) { return C + A.x * B.x + A.y * B.y; }"},
	{"dot4add_u8packed",
		"uint DrydockDot4AddU8(uint A, uint B, uint C) { return C + (A & 255u) * (B & 255u) + "
		"(A >> 8 & 255u) * (B >> 8 & 255u) + (A >> 16 & 255u) * (B >> 16 & 255u) + (A >> 24) * (B >> 24); }"},
	{"dot4add_i8packed",
		"int DrydockDot4AddI8(uint A, uint B, int C) { int4 X = int4(A << 24, A << 16, A << 8, A) >> 24; "
		"int4 Y = int4(B << 24, B << 16, B << 8, B) >> 24; return C + X.x * Y.x + X.y * Y.y + X.z * Y.z + X.w * Y.w; "
		"}"},
	{"msad4", "uint DrydockSad(uint A, uint B, uint Shift) { uint X = A >> Shift & 255u; uint Y = B >> Shift & 255u; "
			  "return X == 0u ? 0u : max(X, Y) - min(X, Y); } "
			  "uint DrydockSad(uint A, uint B) { return DrydockSad(A, B, 0u) + DrydockSad(A, B, 8u) + "
			  "DrydockSad(A, B, 16u) + DrydockSad(A, B, 24u); } "
			  "uint4 DrydockMsad4(uint A, uint2 B, uint4 C) { return C + uint4(DrydockSad(A, B.x), "
			  "DrydockSad(A, B.x >> 8 | B.y << 24), DrydockSad(A, B.x >> 16 | B.y << 16), "
			  "DrydockSad(A, B.x >> 24 | B.y << 8)); }"}};

const std::map<std::string, const char*> IntrinsicNames = {{"AddUint64", "DrydockAddUint64"},
	{"dot2add", "DrydockDot2Add"}, {"dot4add_u8packed", "DrydockDot4AddU8"}, {"dot4add_i8packed", "DrydockDot4AddI8"},
	{"msad4", "DrydockMsad4"}};

class FCallRewriter
{
public:
	FCallRewriter(FHlslText& InText, const FHlslSymbols& InSymbols)
		: Text(InText)
		, Symbols(InSymbols)
	{
	}

	bool Run()
	{
		for (size_t At = 0; At < Text.Size(); ++At)
		{
			if (!Text.IsWord(At) || Text.FindClose(At + 1) >= Text.Size())
			{
				continue;
			}
			const bool bMember = At > 0 && Text.Is(At - 1, ".");
			if (Text.Is(At + 1, "(") && (Text.Is(At, "InterlockedCompareStore") || !bMember) &&
				!Symbols.FindFunctions(Text[At].Text))
			{
				RewriteCall(At);
			}
		}
		return Edits.Apply(Text, Functions);
	}

private:
	void RewriteCall(size_t At)
	{
		const std::string& Name = Text[At].Text;
		if (const auto Intrinsic = IntrinsicNames.find(Name); Intrinsic != IntrinsicNames.end())
		{
			Functions[Name] = ReplacedIntrinsics.at(Name);
			Edits.Replace(At, At + 1, Intrinsic->second);
		}
		else if (Name == "NonUniformResourceIndex")
		{
			Edits.Replace(At, At + 1, "");
		}
		else if (Name == "InterlockedCompareStore")
		{
			CompareAndStore(At);
		}
		else if (Name == "WaveActiveAllEqual")
		{
			CompareParts(At);
		}
		else if (Name == "normalize")
		{
			const std::optional<FHlslNumeric> Type = ParseHlslNumeric(Symbols.GetType(At + 2, Text.FindClose(At + 1)));
			if (Type && Type->Columns == 0)
			{
				Functions[Name] = "float DrydockNormalize(float A) { return A * rsqrt(A * A); }";
				Edits.Replace(At, At + 1, "DrydockNormalize");
			}
		}
	}

	/** The front end drops it: an exchange whose result nobody reads. */
	void CompareAndStore(size_t At)
	{
		const size_t Close = Text.FindClose(At + 1);
		const bool bMethod = At > 1 && Text.Is(At - 1, ".");
		const size_t First = bMethod ? Symbols.FindChainStart(At - 2) : At;
		size_t Comma = At + 2;
		while (Comma < Close && !Text.Is(Comma, ","))
		{
			Comma = std::max(Comma, Text.FindClose(Comma)) + 1;
		}
		const std::string Type = bMethod ? "uint" : Symbols.GetType(At + 2, Comma);
		Edits.Insert(First, "{ " + (Type.empty() ? "uint" : Type) + " DrydockOld;");
		Edits.Replace(At, At + 1, "InterlockedCompareExchange");
		Edits.Insert(Close, ", DrydockOld");
		Edits.Insert(Close + 2, "}");
	}

	/** Rewrites WaveActiveAllEqual of a vector or matrix, which compares each part by itself. */
	void CompareParts(size_t At)
	{
		const std::optional<FHlslNumeric> Of = ParseHlslNumeric(Symbols.GetType(At + 2, Text.FindClose(At + 1)));
		const bool bKnownToTree = Of && (Of->Scalar.find("16_t") != std::string::npos ||
											Of->Scalar.find("64_t") != std::string::npos || Of->Scalar == "double");
		if (bKnownToTree)
		{
			return; // FrontEndCalls.cpp
		}
		std::string Overloads;
		for (const char* const Scalar : {"float", "int", "uint", "bool"})
		{
			Overloads += std::string("bool DrydockAllEqual(") + Scalar + " A) { return WaveActiveAllEqual(A); } ";
			for (int Size = 2; Size <= 4; ++Size)
			{
				const FHlslNumeric Type{Scalar, 0, Size};
				Overloads += "bool" + std::to_string(Size) + " DrydockAllEqual(" + Type.GetName() +
							 " A) { return bool" + std::to_string(Size) + "(";
				for (int i = 0; i < Size; ++i)
				{
					Overloads += (i ? ", " : "") + ("WaveActiveAllEqual(" + GetHlslElement("A", Type, i)) + ")";
				}
				Overloads += "); } ";
			}
		}
		Functions["WaveActiveAllEqual"] = Overloads;
		Edits.Replace(At, At + 1, "DrydockAllEqual");
	}

	FHlslText& Text;
	const FHlslSymbols& Symbols;
	std::map<std::string, std::string> Functions; // that stand before the text
	FHlslEdits Edits;
};

} // namespace

bool RewriteCalls(FHlslText& Text, const FHlslSymbols& Symbols)
{
	return FCallRewriter(Text, Symbols).Run();
}

} // namespace Drydock
