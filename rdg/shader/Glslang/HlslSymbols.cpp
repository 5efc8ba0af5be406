// Reads the declarations of a shader.
#include "HlslSymbols.h"

#include <algorithm>
#include <cctype>
#include <unordered_set>

namespace Drydock
{

namespace
{

const std::unordered_set<std::string> Modifiers = {"const", "static", "in", "out", "inout", "uniform", "precise",
	"row_major", "column_major", "nointerpolation", "noperspective", "linear", "centroid", "sample", "groupshared",
	"volatile", "extern", "shared", "globallycoherent", "inline", "typedef", "snorm", "unorm"};

const std::unordered_set<std::string> NoTypes = {"return", "else", "do", "case", "struct", "class", "interface",
	"cbuffer", "tbuffer", "namespace", "goto", "if", "for", "while", "switch", "default", "break", "continue",
	"discard", "enum", "template", "typename", "using", "operator", "true", "false", "register", "packoffset"};

bool IsModifier(const FHlslToken& Token)
{
	return Token.IsWord() && Modifiers.count(Token.Text);
}

/** Whether Name is a type of HLSL's own that is written with <...>. */
bool TakesList(const std::string& Name)
{
	static const char* const Kinds[] = {"Texture", "RWTexture", "Buffer", "RWBuffer", "StructuredBuffer",
		"RWStructuredBuffer", "AppendStructuredBuffer", "ConsumeStructuredBuffer", "ConstantBuffer",
		"RasterizerOrdered", "vector", "matrix", "InputPatch", "OutputPatch", "PointStream", "LineStream",
		"TriangleStream"};
	return std::any_of(std::begin(Kinds), std::end(Kinds), [&](const char* Kind) { return Name.rfind(Kind, 0) == 0; });
}

} // namespace

std::optional<FHlslNumeric> ParseHlslNumeric(const std::string& Type)
{
	static const std::pair<const char*, const char*> Scalars[] = {{"float16_t", "float16_t"}, {"float32_t", "float"},
		{"float64_t", "double"}, {"int16_t", "int16_t"}, {"uint16_t", "uint16_t"}, {"int32_t", "int"},
		{"uint32_t", "uint"}, {"int64_t", "int64_t"}, {"uint64_t", "uint64_t"}, {"min16float", "float"},
		{"min10float", "float"}, {"min16int", "int"}, {"min12int", "int"}, {"min16uint", "uint"}, {"float", "float"},
		{"half", "float"}, {"double", "double"}, {"int", "int"}, {"uint", "uint"}, {"dword", "uint"}, {"bool", "bool"}};
	for (const auto& [Name, Scalar] : Scalars)
	{
		const size_t Length = std::char_traits<char>::length(Name);
		if (Type.compare(0, Length, Name) != 0)
		{
			continue;
		}
		const std::string Rest = Type.substr(Length);
		const auto IsSize = [](char c)
		{
			return c >= '1' && c <= '4';
		};
		if (Rest.empty())
		{
			return FHlslNumeric{Scalar, 0, 0};
		}
		if (Rest.size() == 1 && IsSize(Rest[0]))
		{
			return FHlslNumeric{Scalar, 0, Rest[0] - '0'};
		}
		if (Rest.size() == 3 && IsSize(Rest[0]) && Rest[1] == 'x' && IsSize(Rest[2]))
		{
			return FHlslNumeric{Scalar, Rest[0] - '0', Rest[2] - '0'};
		}
	}
	return {};
}

std::string GetHlslElementType(const std::string& Resource)
{
	static const char* const Kinds[] = {"Texture", "RWTexture", "Buffer", "RWBuffer", "StructuredBuffer",
		"RWStructuredBuffer", "AppendStructuredBuffer", "ConsumeStructuredBuffer", "RasterizerOrderedTexture"};
	const bool bResource =
		std::any_of(std::begin(Kinds), std::end(Kinds), [&](const char* Kind) { return Resource.rfind(Kind, 0) == 0; });
	const size_t Open = Resource.find('<');
	if (!bResource)
	{
		return {};
	}
	if (Open == std::string::npos)
	{
		return "float4";
	}
	std::string Element = Resource.substr(Open + 1, Resource.rfind('>') - Open - 1);
	Element = Element.substr(0, Element.find(',')); // of a Texture2DMS<float4, 4>
	const std::optional<FHlslNumeric> Numeric = ParseHlslNumeric(Element);
	return Numeric ? Numeric->GetName() : Element;
}

FHlslSymbols::FHlslSymbols(const FHlslText& InText)
	: Text(InText)
{
	Read();
}

std::string FHlslSymbols::ReadType(size_t First, size_t& End) const
{
	End = First;
	if (!Text.IsWord(First) || NoTypes.count(Text[First].Text) || Modifiers.count(Text[First].Text))
	{
		return {};
	}
	const std::string& Name = Text[First].Text;
	End = First + 1;
	if (Name == "unsigned" && Text.Is(End, "int"))
	{
		++End;
		return "uint";
	}
	if (Text.Is(End, "<") && (TakesList(Name) || Templates.count(Name)))
	{
		const size_t ListEnd = Text.FindListEnd(End);
		if (ListEnd)
		{
			std::string List;
			for (size_t At = End + 1; At + 1 < ListEnd; ++At)
			{
				List += IsModifier(Text[At]) ? std::string() : Text[At].Text; // unorm float4
			}
			End = ListEnd;
			if (Name == "vector" || Name == "matrix")
			{
				std::replace(List.begin(), List.end(), ',', 'x');
				const size_t Size = List.find('x');
				return List.substr(0, Size) +
					   (Size == std::string::npos ? (Name == "vector" ? "4" : "4x4") : List.substr(Size + 1));
			}
			return Name + "<" + List + ">";
		}
	}
	const auto Alias = Aliases.find(Name);
	return Alias == Aliases.end() ? Name : Alias->second;
}

void FHlslSymbols::Read()
{
	for (size_t At = 0; At + 1 < Text.Size(); ++At)
	{
		const size_t ListEnd = Text.Is(At, "template") && Text.Is(At + 1, "<") ? Text.FindListEnd(At + 1) : 0;
		if (ListEnd && (Text.Is(ListEnd, "struct") || Text.Is(ListEnd, "class")) && Text.IsWord(ListEnd + 1))
		{
			Templates.insert(Text[ListEnd + 1].Text);
		}
	}
	for (size_t At = 0; At < Text.Size(); ++At)
	{
		while (!Scopes.empty() && At >= Scopes.back().End)
		{
			Scopes.pop_back();
		}
		const FHlslToken& Token = Text[At];
		if (Token.Is("{"))
		{
			const bool bInside = !Scopes.empty() && Scopes.back().bFunction;
			const bool bBody = bInside || Text.FindClose(At) + 1 == BodyEnd;
			Scopes.push_back({Text.FindClose(At), {}, bBody});
			continue;
		}
		if (!Token.IsWord() || (At > 0 && (Text.Is(At - 1, ".") || Text.Is(At - 1, "::"))))
		{
			continue;
		}
		if (Token.Is("struct") || Token.Is("class") || Token.Is("cbuffer") || Token.Is("tbuffer"))
		{
			ReadStruct(At);
			size_t Open = At;
			while (Open < Text.Size() && !Text.Is(Open, "{") && !Text.Is(Open, ";"))
			{
				++Open;
			}
			if (Text.Is(Open, "{"))
			{
				const bool bStruct = Token.Is("struct") || Token.Is("class");
				Scopes.push_back({bStruct ? Text.FindClose(Open) : Open, bStruct ? Text[At + 1].Text : "", false});
				BlockEnd = bStruct ? BlockEnd : Text.FindClose(Open);
				At = Open;
			}
			continue;
		}
		size_t NameAt = 0;
		const std::string Type = ReadType(At, NameAt);
		const bool bName = !Type.empty() && Text.IsWord(NameAt) && !NoTypes.count(Text[NameAt].Text) &&
						   !Modifiers.count(Text[NameAt].Text);
		if (!bName)
		{
			continue;
		}
		if (Text.Is(NameAt + 1, "("))
		{
			ReadFunction(Type, NameAt);
			At = NameAt + 1;
		}
		else
		{
			At = ReadVariables(At, Type, NameAt);
		}
	}
}

void FHlslSymbols::ReadStruct(size_t At)
{
	const bool bStruct = Text.Is(At, "struct") || Text.Is(At, "class");
	if (!bStruct || !Text.IsWord(At + 1))
	{
		return;
	}
	std::vector<FHlslVariable>& Members = Structs[Text[At + 1].Text];
	if (Text.Is(At + 2, ":") && Text.IsWord(At + 3) && Structs.count(Text[At + 3].Text))
	{
		Members = std::vector<FHlslVariable>(Structs[Text[At + 3].Text]);
	}
}

void FHlslSymbols::ReadFunction(const std::string& Type, size_t At)
{
	const size_t Close = Text.FindClose(At + 1);
	size_t Open = Close + 1;
	while (Text.Is(Open, ":") || Text.IsWord(Open)) // a semantic
	{
		++Open;
	}
	FHlslFunction Function{Type, {}, At};
	ParametersEnd = Close;
	BodyEnd = Text.Is(Open, "{") ? Text.FindClose(Open) + 1 : Close + 1;
	for (size_t i = At + 2; i < Close; ++i)
	{
		size_t NameAt = 0;
		const std::string ParameterType = ReadType(i, NameAt);
		if (ParameterType.empty())
		{
			continue;
		}
		FHlslVariable Parameter;
		Parameter.Type = ParameterType;
		Parameter.TypeAt = i;
		Parameter.At = NameAt;
		Parameter.bArray = Text.Is(NameAt + 1, "[");
		Function.Parameters.push_back(Parameter);
		while (i < Close && !Text.Is(i, ","))
		{
			i = Text.Is(i, "(") || Text.Is(i, "[") || Text.Is(i, "{") ? Text.FindClose(i) + 1
				: Text.Is(i, "<") && Text.FindListEnd(i)              ? Text.FindListEnd(i)
																	  : i + 1;
		}
	}
	Functions[Text[At].Text].push_back(std::move(Function));
}

size_t FHlslSymbols::ReadVariables(size_t TypeAt, const std::string& Type, size_t At)
{
	FHlslVariable Variable;
	Variable.Type = Type;
	Variable.TypeAt = TypeAt;
	bool bConst = false;
	for (size_t i = TypeAt; i > 0 && IsModifier(Text[i - 1]); --i)
	{
		Variable.bStatic = Variable.bStatic || Text.Is(i - 1, "static") || Text.Is(i - 1, "groupshared");
		bConst = bConst || Text.Is(i - 1, "const");
		if (Text.Is(i - 1, "typedef"))
		{
			Aliases[Text[At].Text] = Type;
		}
	}
	Variable.bConstant = Variable.bStatic && bConst;
	Variable.bParameter = At < ParametersEnd;
	Variable.At = At;
	Variable.bArray = Text.Is(At + 1, "[");
	Declare(At, Variable);
	if (Variable.bParameter)
	{
		return At;
	}
	// float A = F(1, 2), B[3];
	size_t i = At + 1;
	while (i < Text.Size() && !Text.Is(i, ";") && !Text.Is(i, ")") && !Text.Is(i, "}"))
	{
		if (Text.Is(i, ",") && Text.IsWord(i + 1))
		{
			Variable.At = i + 1;
			Variable.bArray = Text.Is(i + 2, "[");
			Declare(i + 1, Variable);
		}
		i = Text.Is(i, "(") || Text.Is(i, "[") || Text.Is(i, "{") ? Text.FindClose(i) + 1 : i + 1;
	}
	return At;
}

void FHlslSymbols::Declare(size_t At, FHlslVariable Variable)
{
	Variable.bBlock = At < BlockEnd;
	Variable.bGlobal = Scopes.empty() && !Variable.bParameter;
	Variable.ScopeEnd = Variable.bParameter ? BodyEnd : Scopes.empty() ? Text.Size() : Scopes.back().End;
	if (!Scopes.empty() && !Scopes.back().Struct.empty() && !Variable.bParameter)
	{
		Structs[Scopes.back().Struct].push_back(Variable);
	}
	Variables[Text[At].Text].push_back(std::move(Variable));
}

const FHlslVariable* FHlslSymbols::FindVariable(const std::string& Name, size_t At) const
{
	const auto Found = Variables.find(Name);
	if (Found == Variables.end())
	{
		return nullptr;
	}
	const auto Visible = std::find_if(Found->second.rbegin(), Found->second.rend(),
		[At](const FHlslVariable& Variable) { return Variable.At <= At && At < Variable.ScopeEnd; });
	return Visible == Found->second.rend() ? nullptr : &*Visible;
}

const std::vector<FHlslFunction>* FHlslSymbols::FindFunctions(const std::string& Name) const
{
	const auto Found = Functions.find(Name);
	return Found == Functions.end() ? nullptr : &Found->second;
}

const std::vector<FHlslVariable>* FHlslSymbols::GetMembers(const std::string& Struct) const
{
	const auto Found = Structs.find(Struct);
	return Found == Structs.end() ? nullptr : &Found->second;
}

const FHlslVariable* FHlslSymbols::FindMember(const std::string& Struct, const std::string& Member) const
{
	const std::vector<FHlslVariable>* Members = GetMembers(Struct);
	if (!Members)
	{
		return nullptr;
	}
	const auto Found = std::find_if(Members->begin(), Members->end(),
		[&](const FHlslVariable& Candidate) { return Text[Candidate.At].Text == Member; });
	return Found == Members->end() ? nullptr : &*Found;
}

size_t FHlslSymbols::FindChainStart(size_t Last) const
{
	size_t At = Last;
	for (;;)
	{
		// At is the last token of a name, of (...) or of [...]
		if (Text.Is(At, ")") || Text.Is(At, "]"))
		{
			int Depth = 0;
			size_t Open = At;
			for (;; --Open)
			{
				Depth += Text.Is(Open, ")") || Text.Is(Open, "]")   ? 1
						 : Text.Is(Open, "(") || Text.Is(Open, "[") ? -1
																	: 0;
				if (Depth == 0 || Open == 0)
				{
					break;
				}
			}
			const bool bBehind =
				Open > 0 && (Text.IsWord(Open - 1) || Text.Is(Open - 1, "]") || Text.Is(Open - 1, ")"));
			if (!bBehind || (Text.IsWord(Open - 1) && NoTypes.count(Text[Open - 1].Text)))
			{
				return Open;
			}
			At = Open - 1;
			continue;
		}
		if (At >= 2 && Text.Is(At - 1, "."))
		{
			At -= 2;
			continue;
		}
		return At;
	}
}

} // namespace Drydock
