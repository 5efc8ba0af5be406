// The types of expressions. Source of the rules: HLSL's usual arithmetic conversions; a scalar spreads over a vector.
#include "HlslSymbols.h"

#include <algorithm>
#include <cctype>
#include <map>
#include <set>

namespace Drydock
{

namespace
{

constexpr int MaxExpressionDepth = 64;

int GetRank(const std::string& Scalar)
{
	static const char* const Ranks[] = {"bool", "int", "uint", "float", "double"};
	return int(std::find(std::begin(Ranks), std::end(Ranks), Scalar) - std::begin(Ranks));
}

/** The type of A + B. */
std::string Unite(const std::string& A, const std::string& B)
{
	const std::optional<FHlslNumeric> Left = ParseHlslNumeric(A);
	const std::optional<FHlslNumeric> Right = ParseHlslNumeric(B);
	if (!Left || !Right)
	{
		return A == B ? A : std::string();
	}
	FHlslNumeric Result = Left->Columns >= Right->Columns ? *Left : *Right;
	Result = Left->IsMatrix() ? *Left : Right->IsMatrix() ? *Right : Result;
	const bool bSmaller = Left->Columns && Right->Columns && !Left->IsMatrix() && !Right->IsMatrix();
	Result.Columns = bSmaller ? std::min(Left->Columns, Right->Columns) : Result.Columns;
	Result.Scalar = GetRank(Left->Scalar) >= GetRank(Right->Scalar) ? Left->Scalar : Right->Scalar;
	return Result.GetName();
}

std::string WithScalar(const std::string& Type, const char* Scalar)
{
	std::optional<FHlslNumeric> Numeric = ParseHlslNumeric(Type);
	if (!Numeric)
	{
		return {};
	}
	Numeric->Scalar = Scalar;
	return Numeric->GetName();
}

/** "xyz" of a float4 -> float3, "_m00_m11" of a matrix -> float2; empty if it is not a swizzle. */
std::string GetSwizzleType(const FHlslNumeric& Of, const std::string& Swizzle)
{
	FHlslNumeric Result{Of.Scalar, 0, 0};
	if (Of.IsMatrix())
	{
		const long NumElements = std::count(Swizzle.begin(), Swizzle.end(), '_');
		Result.Columns = NumElements > 1 ? int(NumElements) : 0;
		return Swizzle[0] == '_' && NumElements <= 4 ? Result.GetName() : std::string();
	}
	const bool bSwizzle = Swizzle.size() <= 4 && Swizzle.find_first_not_of("xyzwrgba") == std::string::npos;
	Result.Columns = Swizzle.size() > 1 ? int(Swizzle.size()) : 0;
	return bSwizzle ? Result.GetName() : std::string();
}

int GetPrecedence(const FHlslToken& Token)
{
	static const std::map<std::string, int> Precedences = {{",", 1}, {"=", 2}, {"+=", 2}, {"-=", 2}, {"*=", 2},
		{"/=", 2}, {"%=", 2}, {"&=", 2}, {"|=", 2}, {"^=", 2}, {"<<=", 2}, {">>=", 2}, {"?", 3}, {"||", 4}, {"&&", 5},
		{"|", 6}, {"^", 7}, {"&", 8}, {"==", 9}, {"!=", 9}, {"<", 10}, {">", 10}, {"<=", 10}, {">=", 10}, {"<<", 11},
		{">>", 11}, {"+", 12}, {"-", 12}, {"*", 13}, {"/", 13}, {"%", 13}};
	const auto Found = Token.Kind == EShaderToken::Sign ? Precedences.find(Token.Text) : Precedences.end();
	return Found == Precedences.end() ? 0 : Found->second;
}

std::string GetNumberType(const std::string& Number)
{
	const size_t Point = Number.find('.');
	const size_t Swizzle = Number.find_first_of("xyzwr", Point == std::string::npos ? 0 : Point);
	const bool bHexadecimal = Number.size() > 1 && (Number[1] | 0x20) == 'x';
	const bool bUnsigned =
		(Number.back() | 0x20) == 'u' || (Number.size() > 1 && (Number[Number.size() - 2] | 0x20) == 'u');
	if (bHexadecimal || Point == std::string::npos)
	{
		const bool bReal = !bHexadecimal && Number.find_first_of("eEfFhH") != std::string::npos;
		return bReal ? "float" : bUnsigned ? "uint" : "int";
	}
	if (Swizzle != std::string::npos) // 1.xxx, 0.5.xx
	{
		const size_t Count = Number.size() - Swizzle;
		const bool bReal = Number.find('.') + 1 != Swizzle;
		return std::string(bReal ? "float" : "int") + (Count > 1 ? std::to_string(Count) : std::string());
	}
	return Number.back() == 'l' || Number.back() == 'L' ? "double" : "float";
}

} // namespace

std::string FHlslSymbols::GetType(size_t First, size_t End, int Depth) const
{
	if (First >= End || End > Text.Size() || Depth > MaxExpressionDepth)
	{
		return {};
	}
	// The operator that binds least: the last one of those, or the first of assignments and choices.
	size_t Split = 0;
	int Least = 100;
	for (size_t At = First; At < End; ++At)
	{
		if (Text.Is(At, "(") || Text.Is(At, "[") || Text.Is(At, "{"))
		{
			At = Text.FindClose(At);
			continue;
		}
		const FHlslToken& Token = Text[At];
		if (Token.Is("<") && At > First && Text.IsWord(At - 1) && Text.FindListEnd(At) &&
			Text.Is(Text.FindListEnd(At), "(")) // f<int>(x)
		{
			At = Text.FindListEnd(At) - 1;
			continue;
		}
		const int Precedence = GetPrecedence(Token);
		const bool bBinary = Precedence && At > First && GetPrecedence(Text[At - 1]) == 0 && !Text.Is(At - 1, ":") &&
							 !Text.Is(At - 1, "!") && !Text.Is(At - 1, "~");
		if (bBinary && (Precedence < Least || (Precedence == Least && Precedence > 3)))
		{
			Least = Precedence;
			Split = At;
		}
	}
	if (!Split)
	{
		return GetPostfixType(First, End, Depth);
	}
	if (Least == 1)
	{
		return GetType(Split + 1, End, Depth + 1);
	}
	if (Least == 2)
	{
		return GetType(First, Split, Depth + 1);
	}
	if (Least == 3)
	{
		size_t Colon = Split;
		int Open = 0;
		for (; Colon < End; ++Colon)
		{
			Open += Text.Is(Colon, "?") ? 1 : Text.Is(Colon, ":") ? -1 : 0;
			if (Open == 0)
			{
				break;
			}
			Colon = Text.Is(Colon, "(") || Text.Is(Colon, "[") || Text.Is(Colon, "{") ? Text.FindClose(Colon) : Colon;
		}
		return Unite(GetType(Split + 1, Colon, Depth + 1), GetType(Colon + 1, End, Depth + 1));
	}
	std::string Left = GetType(First, Split, Depth + 1);
	if (Least == 11)
	{
		return Left;
	}
	const std::string Type = Unite(Left, GetType(Split + 1, End, Depth + 1));
	const bool bLogic = Least == 4 || Least == 5 || Least == 9 || Least == 10;
	return bLogic ? WithScalar(Type, "bool") : Type.rfind("bool", 0) == 0 ? WithScalar(Type, "int") : Type;
}

std::string FHlslSymbols::GetPostfixType(size_t First, size_t End, int Depth) const
{
	if (First >= End)
	{
		return {};
	}
	if (Text.Is(First, "!"))
	{
		return WithScalar(GetType(First + 1, End, Depth + 1), "bool");
	}
	if (Text.Is(First, "-") || Text.Is(First, "+") || Text.Is(First, "~") || Text.Is(First, "++") ||
		Text.Is(First, "--"))
	{
		return GetType(First + 1, End, Depth + 1);
	}
	if (Text.Is(End - 1, "++") || Text.Is(End - 1, "--"))
	{
		return GetType(First, End - 1, Depth + 1);
	}
	std::string Type;
	bool bArray = false;
	size_t At = First;
	if (Text[First].Kind == EShaderToken::Number)
	{
		Type = GetNumberType(Text[First].Text);
		++At;
	}
	else if (Text.Is(First, "("))
	{
		const size_t Close = Text.FindClose(First);
		size_t TypeEnd = 0;
		const std::string Cast = ReadType(First + 1, TypeEnd);
		const bool bCast = TypeEnd == Close && Close + 1 < End && !Text.Is(Close + 1, ".") &&
						   !Text.Is(Close + 1, "[") && (ParseHlslNumeric(Cast) || IsStruct(Cast));
		if (bCast)
		{
			const std::optional<FHlslNumeric> Numeric = ParseHlslNumeric(Cast);
			return Numeric ? Numeric->GetName() : Cast;
		}
		Type = GetType(First + 1, Close, Depth + 1);
		At = Close + 1;
	}
	else if (Text.IsWord(First))
	{
		size_t TypeEnd = 0;
		const std::string Name = ReadType(First, TypeEnd);
		if (Text.Is(TypeEnd, "("))
		{
			const size_t Close = Text.FindClose(TypeEnd);
			const std::optional<FHlslNumeric> Numeric = ParseHlslNumeric(Name);
			Type = Numeric ? Numeric->GetName() : GetCallType(First, Close, Depth);
			At = Close + 1;
		}
		else if (Text.Is(First, "true") || Text.Is(First, "false"))
		{
			Type = "bool";
			++At;
		}
		else if (const FHlslVariable* Variable = FindVariable(Text[First].Text, First))
		{
			Type = Variable->Type;
			bArray = Variable->bArray;
			++At;
		}
	}
	for (; At < End && !Type.empty();)
	{
		const std::optional<FHlslNumeric> Numeric = ParseHlslNumeric(Type);
		if (Text.Is(At, "["))
		{
			const std::string Element = GetHlslElementType(Type);
			Type = bArray                           ? Type
				   : Numeric && Numeric->IsMatrix() ? Numeric->Scalar + std::to_string(Numeric->Columns)
				   : Numeric && Numeric->Columns    ? Numeric->Scalar
				   : Numeric                        ? std::string()
													: Element;
			At = Text.FindClose(At) + 1;
			bArray = bArray && Text.Is(At, "["); // of several dimensions
		}
		else if (Text.Is(At, ".") && Text.IsWord(At + 1))
		{
			const std::string& Member = Text[At + 1].Text;
			const size_t ListEnd = Text.Is(At + 2, "<") ? Text.FindListEnd(At + 2) : 0;
			if (ListEnd && Text.Is(ListEnd, "(") && Text.Is(At + 1, "Load")) // Bytes.Load<float2>(P)
			{
				size_t TypeEnd = 0;
				Type = ReadType(At + 3, TypeEnd);
				At = Text.FindClose(ListEnd) + 1;
				continue;
			}
			if (Text.Is(At + 2, "(")) // Texture.Load(P)
			{
				const std::string Element = GetHlslElementType(Type);
				const bool bReads = Member.rfind("Load", 0) == 0 || Member.rfind("Sample", 0) == 0;
				const bool bBytes = Type.find("ByteAddressBuffer") != std::string::npos && Member.rfind("Load", 0) == 0;
				Type = bBytes ? "uint" + Member.substr(4) : bReads ? Element : std::string();
				At = Text.FindClose(At + 2) + 1;
				continue;
			}
			const FHlslVariable* Found = FindMember(Type, Member);
			Type = Numeric ? GetSwizzleType(*Numeric, Member) : Found ? Found->Type : std::string();
			bArray = Found && Found->bArray;
			At += 2;
		}
		else
		{
			return {};
		}
	}
	const std::optional<FHlslNumeric> Numeric = ParseHlslNumeric(Type);
	return bArray ? std::string() : Numeric ? Numeric->GetName() : Type;
}

std::string FHlslSymbols::GetCallType(size_t At, size_t Close, int Depth) const
{
	const std::string& Name = Text[At].Text;
	if (const std::vector<FHlslFunction>* Own = FindFunctions(Name))
	{
		const bool bSame = std::all_of(
			Own->begin(), Own->end(), [&](const FHlslFunction& Each) { return Each.Type == Own->front().Type; });
		const std::optional<FHlslNumeric> Numeric = ParseHlslNumeric(Own->front().Type);
		return !bSame ? std::string() : Numeric ? Numeric->GetName() : Own->front().Type;
	}
	static const std::set<std::string> OfFirst = {"saturate", "sin", "cos", "tan", "asin", "acos", "atan", "exp",
		"exp2", "log", "log2", "log10", "sqrt", "rsqrt", "rcp", "floor", "ceil", "round", "trunc", "frac", "normalize",
		"radians", "degrees", "ddx", "ddy", "fwidth", "pow", "fmod", "atan2", "step", "smoothstep", "lerp", "reflect",
		"sinh", "cosh", "tanh"};
	static const std::set<std::string> Alike = {"abs", "min", "max", "clamp", "mad", "reversebits"};
	std::string First;
	std::string All;
	size_t Begin = At + 2;
	int NumArguments = 0;
	for (size_t i = At + 2; i <= Close; ++i)
	{
		if (i == Close || Text.Is(i, ","))
		{
			const std::string Type = GetType(Begin, i, Depth + 1);
			First = NumArguments == 0 ? Type : First;
			All = NumArguments == 0 ? Type : Unite(All, Type);
			++NumArguments;
			Begin = i + 1;
		}
		else if (Text.Is(i, "(") || Text.Is(i, "[") || Text.Is(i, "{"))
		{
			i = Text.FindClose(i);
		}
	}
	const std::optional<FHlslNumeric> Numeric = ParseHlslNumeric(First);
	if (!Numeric)
	{
		return {};
	}
	return OfFirst.count(Name)                                               ? WithScalar(All, "float")
		   : Alike.count(Name)                                               ? All
		   : Name == "dot"                                                   ? All.substr(0, All.find_first_of("1234"))
		   : Name == "length" || Name == "distance" || Name == "determinant" ? "float"
		   : Name == "any" || Name == "all"                                  ? "bool"
		   : Name == "isnan" || Name == "isinf" || Name == "isfinite"        ? WithScalar(First, "bool")
		   : Name == "asfloat"                                               ? WithScalar(First, "float")
		   : Name == "asuint" || Name == "countbits" || Name == "firstbithigh" ? WithScalar(First, "uint")
		   : Name == "asint" || Name == "sign"                                 ? WithScalar(First, "int")
		   : Name == "cross"                                                   ? "float3"
		   : Name == "transpose" ? FHlslNumeric{Numeric->Scalar, Numeric->Columns, Numeric->Rows}.GetName()
								 : std::string();
}

} // namespace Drydock
