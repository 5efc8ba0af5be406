// Runs the rewrites in their order, and has those of names and globals.
#include "HlslRewrites.h"

#include "TextTools.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>

namespace Drydock
{

namespace
{

/** "uint3" of "uint32_t3", "double" of "float64_t"; with real 16-bit types "float16_t3" of "half3"; empty for other
 * names. */
std::string GetOlderName(const std::string& Name, bool bRealHalf)
{
	if (bRealHalf && Name.starts_with("half") && ParseHlslNumeric(Name))
	{
		return "float16_t" + Name.substr(4);
	}
	if (Name.starts_with("float64_t") && ParseHlslNumeric("double" + Name.substr(9)))
	{
		return "double" + Name.substr(9);
	}
	const bool bSized = Name.find("32_t") != std::string::npos;
	const std::optional<FHlslNumeric> Numeric = bSized ? ParseHlslNumeric(Name) : std::nullopt;
	return Numeric ? Numeric->GetName() : std::string();
}

/** vector<int64_t, 3> at At as int64_t3, for the front end takes its own types there; empty: something else. */
std::string GetVectorName(const FHlslText& Text, size_t At, bool bRealHalf)
{
	const bool bVector = Text.Is(At, "vector");
	const size_t Size = bVector ? 1 : 2;
	const bool bList = (bVector || Text.Is(At, "matrix")) && Text.Is(At + 1, "<") && Text.IsWord(At + 2) &&
					   Text.Is(At + 3, ",") && Text.Is(At + 3 + 2 * Size, ">") && (bVector || Text.Is(At + 5, ","));
	if (!bList)
	{
		return {};
	}
	const std::string Older = GetOlderName(Text[At + 2].Text, bRealHalf);
	const std::string Scalar = Older.empty() ? Text[At + 2].Text : Older;
	const bool bSized = Scalar.find("16_t") != std::string::npos || Scalar.find("64_t") != std::string::npos;
	const std::string Name = Scalar + Text[At + 4].Text + (bVector ? std::string() : "x" + Text[At + 6].Text);
	return bSized && ParseHlslNumeric(Name) ? Name : std::string();
}

/** A literal that the front end does not read as it is meant: of 64 bits, or of 16. bLongs: the text has integers of 64
 * bits. Empty: it does. */
std::string GetLiteral(const std::string& Number, bool bRealHalf, bool bLongs)
{
	const bool bHexadecimal = Number.size() > 1 && (Number[1] | 0x20) == 'x';
	const size_t Digits = Number.find_first_not_of(bHexadecimal ? "0123456789abcdefABCDEFxX" : "0123456789");
	if (!bHexadecimal && (Number.back() | 0x20) == 'h')
	{
		const std::string Value = Number.substr(0, Number.size() - 1);
		return bRealHalf ? "float16_t(" + Value + ")" : Value;
	}
	const std::string Suffix = Digits == std::string::npos ? std::string() : ToLowerCase(Number.substr(Digits));
	const bool bKnown = Suffix.empty() || Suffix == "u" || Suffix == "l" || Suffix == "ll" || Suffix == "ul" ||
						Suffix == "ull" || Suffix == "lu" || Suffix == "llu";
	if (!bKnown)
	{
		return {};
	}
	const bool bOctal = !bHexadecimal && Number.size() > 1 && Number[0] == '0';
	const uint64_t Value = std::strtoull(Number.c_str(), nullptr, bHexadecimal ? 16 : bOctal ? 8 : 10);
	const bool bUnsigned = Suffix.find('u') != std::string::npos;
	const bool bWraps = Value > 0x7FFFFFFFu && !bUnsigned && bLongs; // the front end's is below 0, which 64 bits show
	if (bWraps && bHexadecimal && Value <= 0xFFFFFFFFu)
	{
		return std::to_string(Value) + "u";
	}
	if (Value <= 0xFFFFFFFFu && Suffix.find("ll") == std::string::npos && !bWraps)
	{
		return {};
	}
	const std::string Type = bUnsigned ? "uint64_t" : "int64_t";
	const std::string Low = Type + "(" + std::to_string(uint32_t(Value)) + "u)";
	return Value <= 0xFFFFFFFFu ? Low : "(" + Type + "(" + std::to_string(Value >> 32) + "u) << 32 | " + Low + ")";
}

/** A literal without the L of doubles as the float that it is: the front end gives all its digits to a double. Empty:
 * it is one with them. */
std::string GetFloatLiteral(const std::string& Number)
{
	const bool bReal = Number.find_first_of(".eE") != std::string::npos && (Number.size() < 2 || Number[1] != 'x');
	char* End = nullptr;
	const double Value = std::strtod(Number.c_str(), &End);
	const bool bFloat = *End == 0 || (ToLowerCase(End) == "f");
	if (!bReal || !bFloat || double(float(Value)) == Value || !std::isfinite(float(Value)))
	{
		return {};
	}
	char Text[40];
	std::snprintf(Text, sizeof(Text), "%.17e", double(float(Value)));
	return Text;
}

bool IsWritingSign(const FHlslToken& Token)
{
	static const std::set<std::string> Signs = {
		"=", "+=", "-=", "*=", "/=", "%=", "&=", "|=", "^=", "<<=", ">>=", "++", "--"};
	return Token.Kind == EShaderToken::Sign && Signs.count(Token.Text);
}

/** Whether the name at At is written to: "A.x[2] = 1", "++A". */
bool IsWritten(const FHlslText& Text, size_t At)
{
	size_t End = At + 1;
	while (Text.Is(End, "[") || (Text.Is(End, ".") && Text.IsWord(End + 1)))
	{
		End = Text.Is(End, "[") ? Text.FindClose(End) + 1 : End + 2;
	}
	const bool bBefore = At > 0 && (Text.Is(At - 1, "++") || Text.Is(At - 1, "--"));
	return bBefore || (End < Text.Size() && IsWritingSign(Text[End]));
}

} // namespace

bool RewriteNames(FHlslText& Text, bool bRealHalf)
{
	static const std::set<std::string> Attributes = {"numthreads", "unroll", "loop", "branch", "flatten", "fastopt",
		"allow_uav_condition", "earlydepthstencil", "call", "forcecase"};
	std::set<std::string> Own; // names that the text gives to something else
	for (size_t At = 1; At < Text.Size(); ++At)
	{
		const bool bTypedef = Text.IsWord(At - 1) && (Text.Is(At + 1, ";") || Text.Is(At + 1, "{"));
		if (bTypedef && Text.IsWord(At) && !GetOlderName(Text[At].Text, bRealHalf).empty())
		{
			Own.insert(Text[At].Text);
		}
	}
	const auto Has = [&Text](const char* Type)
	{
		return std::any_of(Text.Tokens.begin(), Text.Tokens.end(),
			[Type](const FHlslToken& Token) { return Token.Text.starts_with(Type); });
	};
	const bool bDoubles = Has("double") || Has("float64_t");
	const bool bLongs = Has("int64_t") || Has("uint64_t");
	FHlslEdits Edits;
	bool bChanged = false;
	for (size_t At = 0; At < Text.Size(); ++At)
	{
		const bool bNumber = Text[At].Kind == EShaderToken::Number;
		std::string Literal = bNumber ? GetLiteral(Text[At].Text, bRealHalf, bLongs) : std::string();
		if (bNumber && bDoubles && Literal.empty())
		{
			Literal = GetFloatLiteral(Text[At].Text);
		}
		const std::string Vector = GetVectorName(Text, At, bRealHalf);
		if (!Literal.empty() || !Vector.empty())
		{
			Edits.Replace(At, At + (bNumber ? 1 : Text.Is(At, "vector") ? 6 : 8), bNumber ? Literal : Vector);
			continue;
		}
		if (!Text.IsWord(At))
		{
			continue;
		}
		FHlslToken& Token = Text.Tokens[At];
		if (Token.Is("unsigned"))
		{
			Token.Text = "uint";
			bChanged = true;
			if (Text.Is(At + 1, "int"))
			{
				Edits.Replace(At + 1, At + 2, "");
			}
			continue;
		}
		const std::string Older = Own.count(Token.Text) ? std::string() : GetOlderName(Token.Text, bRealHalf);
		if (!Older.empty())
		{
			Token.Text = Older;
			bChanged = true;
		}
		const bool bAttribute = At > 0 && Text.Is(At - 1, "[") && (Text.Is(At + 1, "(") || Text.Is(At + 1, "]"));
		if (bAttribute && Attributes.count(ToLowerCase(Token.Text)))
		{
			bChanged = bChanged || Token.Text != ToLowerCase(Token.Text);
			Token.Text = ToLowerCase(Token.Text);
		}
		if (Token.Is("using") && Text.IsWord(At + 1) && Text.Is(At + 2, "="))
		{
			size_t End = At + 3;
			while (End < Text.Size() && !Text.Is(End, ";"))
			{
				++End;
			}
			Edits.Replace(At, At + 3, "typedef");
			Edits.Insert(End, Text[At + 1].Text);
		}
	}
	bChanged = bChanged || !Edits.IsEmpty();
	Edits.Apply(Text);
	return bChanged;
}

bool RewriteBases(FHlslText& Text)
{
	bool bChanged = false;
	for (size_t At = 0; At + 4 < Text.Size(); ++At)
	{
		const bool bDerived = (Text.Is(At, "struct") || Text.Is(At, "class")) && Text.Is(At + 2, ":") &&
							  Text.IsWord(At + 3) && Text.Is(At + 4, "{");
		if (!bDerived)
		{
			continue;
		}
		for (size_t Base = 0; Base < At; ++Base)
		{
			const bool bBase = (Text.Is(Base, "struct") || Text.Is(Base, "class")) &&
							   Text.Is(Base + 1, Text[At + 3].Text.c_str()) && Text.Is(Base + 2, "{");
			if (bBase)
			{
				FHlslEdits Edits;
				Edits.Replace(At + 2, At + 4, "");
				Edits.Insert(At + 5, Text.GetText(Base + 3, Text.FindClose(Base + 2)));
				Edits.Apply(Text);
				bChanged = true;
				break;
			}
		}
	}
	return bChanged;
}

bool RewriteGlobals(FHlslText& Text, const FHlslSymbols& Symbols)
{
	const auto FindGlobal = [&](size_t At) -> const FHlslVariable*
	{
		const bool bMember = At > 0 && (Text.Is(At - 1, ".") || Text.Is(At - 1, "::"));
		const FHlslVariable* Variable = bMember ? nullptr : Symbols.FindVariable(Text[At].Text, At);
		const bool bParameter = Variable && Variable->bGlobal && !Variable->bStatic && !Variable->bBlock &&
								!(Variable->TypeAt > 0 && Text.Is(Variable->TypeAt - 1, "const")) &&
								(ParseHlslNumeric(Variable->Type) || Symbols.IsStruct(Variable->Type));
		return bParameter ? Variable : nullptr;
	};
	std::set<size_t> Written; // where they are declared
	for (size_t At = 0; At < Text.Size(); ++At)
	{
		const FHlslVariable* Global = Text.IsWord(At) ? FindGlobal(At) : nullptr;
		if (Global && Global->At != At && IsWritten(Text, At))
		{
			Written.insert(Global->At);
		}
	}
	if (Written.empty())
	{
		return false;
	}
	FHlslEdits Edits;
	for (size_t At = 0; At < Text.Size(); ++At)
	{
		const FHlslVariable* Global = Text.IsWord(At) ? FindGlobal(At) : nullptr;
		if (!Global || !Written.count(Global->At))
		{
			continue;
		}
		const std::string Name = Text[At].Text;
		if (Global->At != At)
		{
			Edits.Replace(At, At + 1, Name + "_Written");
			continue;
		}
		size_t End = At;
		while (End < Text.Size() && !Text.Is(End, ";"))
		{
			End = Text.FindClose(End) + 1;
		}
		const size_t ArrayEnd = Text.Is(At + 1, "[") ? Text.FindClose(At + 1) + 1 : At + 1;
		Edits.Insert(End + 1, "static " + Global->Type + " " + Name + "_Written" +
								  Text.GetText(At + 1, std::min(ArrayEnd, Text.Size())) + " = " + Name + ";");
	}
	Edits.Apply(Text);
	return true;
}

std::vector<std::string> SplitMatrixSwizzle(const std::string& Swizzle)
{
	std::vector<std::string> Elements;
	for (size_t At = 0; At < Swizzle.size();)
	{
		const bool bZeroBased = Swizzle.compare(At, 2, "_m") == 0;
		const size_t Digits = At + (bZeroBased ? 2 : 1);
		const char First = bZeroBased ? '0' : '1';
		const bool bElement = Swizzle[At] == '_' && Digits + 1 < Swizzle.size() && Swizzle[Digits] >= First &&
							  Swizzle[Digits] < First + 4 && Swizzle[Digits + 1] >= First &&
							  Swizzle[Digits + 1] < First + 4;
		if (!bElement)
		{
			return {};
		}
		Elements.push_back(Swizzle.substr(At, Digits + 2 - At));
		At = Digits + 2;
	}
	return Elements.size() > 1 && Elements.size() <= 4 ? Elements : std::vector<std::string>();
}

std::string RewriteHlsl(
	const std::string& Text, const std::string& VirtualPath, std::vector<FDiagnostic>& Errors, bool bRealHalf)
{
	FHlslText Tokens(Text, VirtualPath);
	bool bChanged = RewriteNames(Tokens, bRealHalf);
	bChanged = RewriteTemplates(Tokens, Errors) || bChanged;
	bChanged = RewriteBases(Tokens) || bChanged;
	if (!Errors.empty())
	{
		return Text;
	}
	std::optional<FHlslSymbols> Symbols(std::in_place, Tokens);
	const auto Rewrite = [&](auto Run)
	{
		if (Run())
		{
			bChanged = true;
			Symbols.emplace(Tokens);
		}
	};
	Rewrite([&] { return RewriteGlobals(Tokens, *Symbols); });
	Rewrite([&] { return RewriteResources(Tokens, *Symbols, Errors); });
	Rewrite([&] { return RewriteChoices(Tokens, Errors); });
	Rewrite([&] { return RewriteBuffers(Tokens, *Symbols, Errors); });
	Rewrite([&] { return RewriteMatrices(Tokens, *Symbols, Errors); });
	Rewrite([&] { return RewriteCalls(Tokens, *Symbols); });
	Rewrite([&] { return RewriteStatements(Tokens, *Symbols, Errors); });
	bChanged = RewriteExpressions(Tokens, *Symbols, Errors) || bChanged;
	return bChanged ? Tokens.Join() : Text;
}

} // namespace Drydock
