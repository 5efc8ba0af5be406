// The parser's tokens, its faults, and what it knows of names.
#include "HlslParserImpl.h"

#include <algorithm>
#include <string>

namespace Drydock::Hlsl
{

namespace
{

/** A template's arguments have no more tokens where the parser has to look for their end. */
constexpr size_t ParserMaxAngles = 4096;

/** A scope sees into so many namespaces and bases. */
constexpr size_t ParserMaxUsings = 64;

using FParserWords = std::unordered_map<std::string_view, FWord>;

/** Words with a blank between them. */
void AddParserWords(FParserWords& Words, EWord Kind, std::string_view Names)
{
	for (size_t Start = 0, End = 0; End < Names.size(); Start = End + 1)
	{
		End = std::min(Names.find(' ', Start), Names.size());
		Words[Names.substr(Start, End - Start)] = {Kind};
	}
}

void AddParserTypes(FParserWords& Words)
{
	static std::deque<std::string> Names; // that the keys point into
	for (const char* Base : {"bool", "int", "uint", "dword", "half", "float", "double", "min16float", "min10float",
			 "min16int", "min12int", "min16uint", "int16_t", "uint16_t", "int32_t", "uint32_t", "int64_t", "uint64_t",
			 "float16_t", "float32_t", "float64_t"})
	{
		Words[Base] = {EWord::Numeric};
		for (char Row = '1'; Row <= '4'; ++Row)
		{
			const std::string& Vector = Names.emplace_back(std::string(Base) + Row);
			Words[Vector] = {EWord::Numeric};
			for (char Column = '1'; Column <= '4'; ++Column)
			{
				Words[Names.emplace_back(Vector + 'x' + Column)] = {EWord::Matrix};
			}
		}
	}
	AddParserWords(Words, EWord::Numeric, "void vector int8_t4_packed uint8_t4_packed");
	AddParserWords(Words, EWord::Matrix, "matrix");
	AddParserWords(Words, EWord::Object,
		"string String texture Texture texture1D texture2D texture3D textureCUBE Texture1D Texture1DArray Texture2D "
		"Texture2DArray Texture2DMS Texture2DMSArray Texture3D TextureCube TextureCubeArray TextureCUBE RWTexture1D "
		"RWTexture1DArray RWTexture2D RWTexture2DArray RWTexture2DMS RWTexture2DMSArray RWTexture3D Buffer RWBuffer "
		"StructuredBuffer RWStructuredBuffer AppendStructuredBuffer ConsumeStructuredBuffer ByteAddressBuffer "
		"RWByteAddressBuffer ConstantBuffer TextureBuffer RasterizerOrderedTexture1D RasterizerOrderedTexture1DArray "
		"RasterizerOrderedTexture2D RasterizerOrderedTexture2DArray RasterizerOrderedTexture3D RasterizerOrderedBuffer "
		"RasterizerOrderedStructuredBuffer RasterizerOrderedByteAddressBuffer FeedbackTexture2D FeedbackTexture2DArray "
		"sampler sampler1D sampler2D sampler3D samplerCUBE SamplerState SamplerComparisonState BlendState "
		"DepthStencilState RasterizerState RenderTargetView DepthStencilView InputPatch OutputPatch PointStream "
		"LineStream TriangleStream RayDesc RayQuery RaytracingAccelerationStructure "
		"BuiltInTriangleIntersectionAttributes StateObjectConfig GlobalRootSignature LocalRootSignature "
		"SubobjectToExportsAssociation RaytracingShaderConfig RaytracingPipelineConfig RaytracingPipelineConfig1 "
		"TriangleHitGroup ProceduralPrimitiveHitGroup SubpassInput SubpassInputMS DispatchNodeInputRecord "
		"RWDispatchNodeInputRecord GroupNodeInputRecords RWGroupNodeInputRecords ThreadNodeInputRecord "
		"RWThreadNodeInputRecord EmptyNodeInput NodeOutput EmptyNodeOutput ThreadNodeOutputRecords "
		"GroupNodeOutputRecords");
}

FParserWords MakeParserWords()
{
	FParserWords Words;
	AddParserTypes(Words);
	AddParserWords(Words, EWord::Keyword,
		"if else for while do switch case default break continue return discard struct class enum union interface "
		"namespace cbuffer tbuffer template typename typedef using static_assert _Static_assert operator sizeof this "
		"true "
		"false unsigned signed long short char auto goto try catch throw virtual friend explicit mutable new delete "
		"public "
		"private protected static_cast dynamic_cast const_cast reinterpret_cast asm typeid alignas alignof constexpr "
		"decltype noexcept");
	AddParserWords(Words, EWord::SoftModifier,
		"reordercoherent shared point line triangle lineadj triangleadj indices vertices primitives payload");
	const std::pair<const char*, uint32_t> Soft[] = {{"precise", ModifierPrecise}, {"linear", ModifierLinear},
		{"center", ModifierLinear}, {"centroid", ModifierCentroid}, {"sample", ModifierSample},
		{"globallycoherent", ModifierGloballyCoherent}};
	for (const auto& [Name, Mask] : Soft)
	{
		Words[Name] = {EWord::SoftModifier, Mask};
	}
	const std::pair<const char*, uint32_t> Hard[] = {{"static", ModifierStatic}, {"const", ModifierConst},
		{"uniform", ModifierUniform}, {"extern", ModifierExtern}, {"groupshared", ModifierGroupshared},
		{"in", ModifierIn}, {"out", ModifierOut}, {"inout", ModifierIn | ModifierOut}, {"row_major", ModifierRowMajor},
		{"column_major", ModifierColumnMajor}, {"inline", ModifierInline}, {"volatile", ModifierVolatile},
		{"unorm", ModifierUnorm}, {"snorm", ModifierSnorm}, {"nointerpolation", ModifierNoInterpolation},
		{"export", ModifierExport}, {"noperspective", ModifierNoPerspective}};
	for (const auto& [Name, Mask] : Hard)
	{
		Words[Name] = {EWord::Modifier, Mask};
	}
	return Words;
}

/** row_major or column_major of `#pragma pack_matrix(...)`; 0: another #pragma. */
uint32_t ReadParserPack(std::string_view Line)
{
	const size_t Name = Line.find("pack_matrix");
	if (Name == std::string_view::npos)
	{
		return 0;
	}
	if (Line.find("row_major", Name) != std::string_view::npos)
	{
		return ModifierRowMajor;
	}
	return Line.find("column_major", Name) != std::string_view::npos ? uint32_t(ModifierColumnMajor) : 0;
}

} // namespace

const FWord& FindWord(std::string_view Text)
{
	static const FParserWords Words = MakeParserWords();
	static const FWord Name;
	const auto Found = Words.find(Text);
	return Found == Words.end() ? Name : Found->second;
}

FParser::FParser(FTree& InTree, const std::vector<FToken>& AllTokens, std::vector<FDiagnostic>& InErrors)
	: Tree(InTree)
	, Errors(InErrors)
{
	static const FWord NoWord;
	Tokens.reserve(AllTokens.size());
	Words.reserve(AllTokens.size());
	for (const FToken& Token : AllTokens)
	{
		if (Token.Kind != EToken::Pragma)
		{
			Tokens.push_back(Token);
			Words.push_back(Token.Kind == EToken::Word ? &FindWord(Token.Text) : &NoWord);
		}
		else if (const uint32_t Order = ReadParserPack(Token.Text))
		{
			Packs.emplace_back(Tokens.size(), Order);
		}
	}
	Scopes.push_back(MakeScope());
}

FParser::FLevel::FLevel(FParser& InParser)
	: Parser(InParser)
{
	if (Parser.Depth >= MaxDepth)
	{
		Parser.Fail(Parser.At().Place, "the text is nested too deep: more than " + std::to_string(MaxDepth) +
										   " levels of parentheses, blocks, types and operators");
	}
	++Parser.Depth;
}

FToken FParser::Next()
{
	const FToken Token = At();
	Pos += Token.Kind != EToken::End;
	for (; NextPack < Packs.size() && Packs[NextPack].first <= Pos; ++NextPack)
	{
		Pack = Packs[NextPack].second;
	}
	return Token;
}

bool FParser::Take(std::string_view Text)
{
	if (!Is(Text))
	{
		return false;
	}
	Next();
	return true;
}

/** Behind: "of the block", for the message. */
void FParser::Expect(std::string_view Text, const std::string& Behind)
{
	if (!Take(Text))
	{
		Unexpected("'" + std::string(Text) + "'" + (Behind.empty() ? "" : " " + Behind));
	}
}

void FParser::Unexpected(const std::string& Expected)
{
	const std::string_view Text = At().Text.substr(0, At().Text.find('\n'));
	const std::string Token = "token '" + std::string(Text.substr(0, 40)) + (Text.size() > 40 ? "..." : "") + "'";
	Fail(At().Place, "X3000: syntax error: unexpected " + (IsEnd() ? "end of file" : Token) + "; expected " + Expected);
}

void FParser::Fail(const FPlace& Place, const std::string& Message)
{
	if (Pos != LastFault) // else it follows from the one before
	{
		LastFault = Pos;
		Errors.push_back(MakeError(Tree.Files, Place, Message));
		if (Errors.size() >= MaxErrors)
		{
			throw FParserStop();
		}
	}
	throw FParserFault();
}

/** Goes behind the bracket that closes the one here. */
void FParser::SkipBalanced()
{
	size_t Open = 0;
	do
	{
		Open += Is("{") || Is("(") || Is("[");
		Open -= (Is("}") || Is(")") || Is("]")) && Open > 0;
		Next();
	} while (Open > 0 && !IsEnd());
}

/** Goes behind the `;` or the block that ends what has a fault and began at Start, or to the brace that closes what is
 * around it. */
void FParser::Recover(size_t Start)
{
	bTemplateHead = false;
	int Braces = 0; // that opened since Start
	for (size_t Index = Start; Index < Pos; ++Index)
	{
		Braces += Tokens[Index].Is("{") - Tokens[Index].Is("}");
	}
	for (int Parentheses = 0; !IsEnd() && (Braces > 0 || !Is("}")); Next())
	{
		const bool bBrace = Is("{") || Is("}");
		Braces += Is("{") - Is("}");
		Parentheses = bBrace ? 0 : std::max(0, Parentheses + Is("(") - Is(")"));
		const bool bClosed = Is("}") && !Is(";", 1);
		if (Braces <= 0 && Parentheses == 0 && (bClosed || Is(";")) && !Is("else", 1)) // which belongs to the fault
		{
			Next();
			break;
		}
	}
	Pos += Pos == Start && !IsEnd(); // a brace that closes nothing
}

/** Goes from what has a fault within the parentheses that open there to behind them. */
void FParser::RecoverBehind(size_t Open)
{
	int Levels = 0;
	for (Pos = Open; !IsEnd() && !Is("{") && !Is("}");)
	{
		Levels += Is("(") - Is(")");
		Next();
		if (Levels == 0)
		{
			return;
		}
	}
}

/** A name that a variable may have. */
bool FParser::IsName(size_t Offset) const
{
	const EWord Kind = WordAt(Pos + Offset).Kind;
	return IsWord(Offset) && (Kind == EWord::Name || Kind == EWord::SoftModifier || Kind == EWord::Object);
}

FScope* FParser::MakeScope()
{
	return &OwnScopes.emplace_back();
}

/** The scope in which a name is declared. */
FScope& FParser::GetScope()
{
	size_t Index = Scopes.size() - 1;
	while (Index > 0 && Scopes[Index]->bTemplate)
	{
		--Index;
	}
	return *Scopes[Index];
}

void FParser::Declare(std::string_view Name, FNamed Named)
{
	GetScope().Names[Name] = Named;
}

/** A variable or function. It is kept only where it hides a type: most scopes stay empty. */
void FParser::DeclareOther(std::string_view Name)
{
	const FNamed Known = FindDeclared(Name);
	if (Known.Kind == EName::Unknown ? FindWord(Name).Kind == EWord::Object : Known.Kind != EName::Other)
	{
		FScope& Scope = GetScope();
		const auto Here = Scope.Names.find(Name);
		if (Here == Scope.Names.end() || Here->second.IsType()) // a function may have a template's name
		{
			Scope.Names[Name] = {EName::Other};
		}
	}
}

FNamed FParser::FindIn(const FScope& Scope, std::string_view Name) const
{
	size_t Steps = 0;
	for (const FScope* Each = &Scope; Each != nullptr && Steps < ParserMaxUsings; Each = Each->Base, ++Steps)
	{
		if (const auto Found = Each->Names.find(Name); Found != Each->Names.end())
		{
			return Found->second;
		}
	}
	for (size_t Index = 0; Index < std::min(Scope.Usings.size(), ParserMaxUsings); ++Index)
	{
		const FScope& Used = *Scope.Usings[Index];
		if (const auto Found = Used.Names.find(Name); Found != Used.Names.end())
		{
			return Found->second;
		}
	}
	return {};
}

FNamed FParser::FindDeclared(std::string_view Name) const
{
	for (size_t Index = Scopes.size(); Index-- > 0;)
	{
		if (const FNamed Found = FindIn(*Scopes[Index], Name); Found.Kind != EName::Unknown)
		{
			return Found;
		}
	}
	return {};
}

/** The thing that the word there names. */
FNamed FParser::Find(size_t Where) const
{
	const EWord Kind = WordAt(Where).Kind;
	if (Kind == EWord::Numeric || Kind == EWord::Matrix)
	{
		const std::string_view Name = Tokens[Where].Text;
		return {Name == "vector" || Name == "matrix" ? EName::TypeTemplate : EName::Type};
	}
	const FNamed Found = FindDeclared(Tokens[Where].Text);
	return Found.Kind == EName::Unknown && Kind == EWord::Object ? FNamed{EName::TypeTemplate} : Found;
}

/** The token behind the > that closes the < there; 0 where none does. */
size_t FParser::FindAngleEnd(size_t Where) const
{
	size_t Angles = 0;
	size_t Brackets = 0;
	const size_t Last = std::min(Tokens.size(), Where + ParserMaxAngles);
	for (; Where < Last; ++Where)
	{
		const FToken& Token = Tokens[Where];
		if (Token.Kind != EToken::Sign || Token.Text.size() != 1)
		{
			continue;
		}
		const char c = Token.Text[0];
		if (c == '{' || c == '}' || c == ';' || ((c == ')' || c == ']') && Brackets == 0))
		{
			return 0;
		}
		Brackets += c == '(' || c == '[';
		Brackets -= c == ')' || c == ']';
		Angles += Brackets == 0 && c == '<';
		if (Brackets == 0 && c == '>' && --Angles == 0)
		{
			return Where + 1;
		}
	}
	return 0;
}

/** Whether the < there, behind a name, opens a template's arguments. A name that is not known is a template where a
 * type stands behind the <. */
bool FParser::TakesArguments(const FNamed& Named, size_t Where, bool bGuess) const
{
	if (!Tokens[Where].Is("<"))
	{
		return false;
	}
	return Named.IsTemplate() ||
		   (bGuess && Named.Kind == EName::Unknown && IsTypeAt(Where + 1, false) && FindAngleEnd(Where) != 0);
}

/** The thing that the name beginning there stands for, without reading it; Unknown if none begins. End: behind it. */
FNamed FParser::LookAtName(size_t Where, size_t& End, bool bGuess) const
{
	FNamed Named;
	End = Where;
	const FScope* Inside = nullptr;
	bool bInside = Tokens[Where].Is("::");
	if (bInside)
	{
		Inside = Scopes[0];
		++Where;
	}
	for (;; ++Where)
	{
		if (Tokens[Where].Kind != EToken::Word)
		{
			return {};
		}
		Named = !bInside ? Find(Where) : Inside != nullptr ? FindIn(*Inside, Tokens[Where].Text) : FNamed{};
		End = ++Where;
		if (TakesArguments(Named, Where, bGuess))
		{
			End = Where = std::max(Where, FindAngleEnd(Where));
		}
		if (!Tokens[Where].Is("::"))
		{
			return Named;
		}
		Inside = Named.Scope;
		bInside = true;
	}
}

} // namespace Drydock::Hlsl
