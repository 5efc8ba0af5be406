// Templates of functions and structs: each use with other arguments gets a copy of the declaration, before the
// declaration of what uses it. The lines of a copy are those of the template.
#include "HlslTemplates.h"

#include "HlslRewrites.h"

#include <algorithm>

namespace Drydock
{

namespace
{

constexpr int MaxUses = 2000;
constexpr size_t MaxInstances = 500;

std::string JoinList(const std::vector<std::string>& Arguments)
{
	std::string Result;
	for (const std::string& Argument : Arguments)
	{
		Result += (Result.empty() ? "" : ",") + Argument;
	}
	return Result;
}

class FTemplateRewriter
{
public:
	FTemplateRewriter(FHlslText& InText, std::vector<FDiagnostic>& OutErrors)
		: Text(InText)
		, Errors(OutErrors)
	{
	}

	bool Run()
	{
		Templates = TakeHlslTemplates(Text, Instances, Errors);
		if (Templates.empty() && Instances.empty())
		{
			return false;
		}
		int NumUses = 0;
		for (size_t At = 0; At < Text.Size() && Errors.empty(); ++At)
		{
			const bool bMember = At > 0 && (Text.Is(At - 1, ".") || Text.Is(At - 1, "::"));
			if (Text.IsWord(At) && !bMember && Templates.count(Text[At].Text))
			{
				At = ReplaceUse(At);
				if (++NumUses > MaxUses || Instances.size() > MaxInstances)
				{
					Error(At, "this shader makes more than " + std::to_string(MaxInstances) + " copies of templates");
				}
			}
		}
		return true;
	}

private:
	void Error(size_t At, const std::string& Message) { Errors.push_back(Text.MakeError(At, Message)); }

	/** Replaces a use of a template. The result is the token at which the scan goes on. */
	size_t ReplaceUse(size_t At)
	{
		const std::string Name = Text[At].Text;
		const size_t ListEnd = Text.Is(At + 1, "<") ? Text.FindListEnd(At + 1) : 0;
		const size_t NameEnd = ListEnd ? ListEnd : At + 1;
		const std::vector<std::string> Given =
			ListEnd ? SplitHlslList(Text, At + 1, ListEnd) : std::vector<std::string>();
		const bool bCall = Text.Is(NameEnd, "(");
		const FHlslTemplate* Chosen = nullptr;
		std::vector<std::string> Arguments;
		std::string Missing;
		const FHlslSymbols Symbols(Text);
		if (!ListEnd && (!bCall || IsDeclared(Symbols, At) || HasExactOverload(Symbols, Name, NameEnd)))
		{
			return At; // a name of something else, or a function that is not a template
		}
		for (const FHlslTemplate& Template : Templates[Name])
		{
			Arguments = Given;
			if (!Chosen && (Template.bStruct || bCall) && Complete(Template, Symbols, NameEnd, Arguments, Missing))
			{
				Chosen = &Template;
				break;
			}
		}
		if (!Chosen)
		{
			Error(At, Missing.empty() ? "no template '" + Name + "' takes these arguments"
									  : "the template argument '" + Missing + "' of '" + Name +
											"' cannot be found from this call: write " + Name + "<...>(...)");
			return At;
		}
		const std::string Mangled = MangleHlslName(Name, Arguments);
		const auto First = Text.Tokens.begin() + std::ptrdiff_t(At);
		Text.Tokens.erase(First + 1, First + std::ptrdiff_t(NameEnd - At));
		Text.Tokens[At].Text = Mangled;
		Originals[Mangled] = Name + "<" + JoinList(Arguments) + ">";
		const bool bSpecialized = Instances.count(Mangled) > 0;
		if (!bSpecialized && Instances.insert(Mangled + GetSignature(*Chosen)).second)
		{
			FHlslTokens Instance = MakeInstance(*Chosen, Arguments, Mangled);
			const size_t Before = FindDeclarationStart(At);
			Text.Tokens.insert(Text.Tokens.begin() + std::ptrdiff_t(Before), std::make_move_iterator(Instance.begin()),
				std::make_move_iterator(Instance.end()));
			At = Before - 1; // the copy may use templates as well; 0 - 1 is followed by ++
		}
		Text.Match();
		return At;
	}

	/** Tells overloads of one name apart. */
	static std::string GetSignature(const FHlslTemplate& Template)
	{
		const FHlslToken& First = Template.Declaration.front();
		std::string Result;
		for (const int Part : {int(First.File), First.Line, First.Column})
		{
			Result += ':';
			Result += std::to_string(Part);
		}
		return Result;
	}

	/** The types of a call's arguments, empty where not known. */
	std::vector<std::string> GetArgumentTypes(const FHlslSymbols& Symbols, size_t Open) const
	{
		std::vector<std::string> Types;
		const size_t Close = Text.FindClose(Open);
		size_t Begin = Open + 1;
		for (size_t At = Open + 1; At <= Close && Open + 1 < Close; ++At)
		{
			if (At == Close || Text.Is(At, ","))
			{
				Types.push_back(Symbols.GetType(Begin, At));
				Begin = At + 1;
			}
			else
			{
				At = Text.FindClose(At);
			}
		}
		return Types;
	}

	/** Whether the name at At is that of a function's declaration. */
	bool IsDeclared(const FHlslSymbols& Symbols, size_t At) const
	{
		const std::vector<FHlslFunction>* Functions = Symbols.FindFunctions(Text[At].Text);
		return Functions && std::any_of(Functions->begin(), Functions->end(),
								[At](const FHlslFunction& Function) { return Function.At == At; });
	}

	bool HasExactOverload(const FHlslSymbols& Symbols, const std::string& Name, size_t Open) const
	{
		const std::vector<FHlslFunction>* Functions = Symbols.FindFunctions(Name);
		if (!Functions)
		{
			return false;
		}
		const std::vector<std::string> Types = GetArgumentTypes(Symbols, Open);
		return std::any_of(Functions->begin(), Functions->end(),
			[&](const FHlslFunction& Function)
			{
				return std::equal(Function.Parameters.begin(), Function.Parameters.end(), Types.begin(), Types.end(),
					[](const FHlslVariable& Parameter, const std::string& Type) { return Parameter.Type == Type; });
			});
	}

	/** Finds the arguments that are not given. Missing: the first that is not to be found. */
	bool Complete(const FHlslTemplate& Template, const FHlslSymbols& Symbols, size_t Open,
		std::vector<std::string>& Arguments, std::string& Missing) const
	{
		const size_t NumGiven = Arguments.size();
		if (NumGiven > Template.Parameters.size())
		{
			return false;
		}
		Arguments.resize(Template.Parameters.size());
		if (!Template.bStruct && !Deduce(Template, Symbols, Open, Arguments, NumGiven))
		{
			return false;
		}
		for (size_t i = 0; i < Arguments.size(); ++i)
		{
			Arguments[i] = Arguments[i].empty() ? Template.Parameters[i].Default : Arguments[i];
			if (Arguments[i].empty())
			{
				Missing = Template.Parameters[i].Name;
				return false;
			}
		}
		return true;
	}

	/** False where the call has another number of arguments. */
	bool Deduce(const FHlslTemplate& Template, const FHlslSymbols& Symbols, size_t Open,
		std::vector<std::string>& Arguments, size_t NumGiven) const
	{
		const std::vector<std::string> Types = GetArgumentTypes(Symbols, Open);
		const FHlslTokens& Tokens = Template.Declaration;
		size_t At = Template.NameAt + 2;
		size_t Index = 0;
		bool bDefault = false;
		int Depth = 1;
		for (size_t Begin = At; At < Tokens.size() && Depth > 0; ++At)
		{
			Depth += Tokens[At].Is("(") || Tokens[At].Is("<") ? 1 : Tokens[At].Is(")") || Tokens[At].Is(">") ? -1 : 0;
			bDefault = bDefault || Tokens[At].Is("=");
			const bool bEnds = Depth == 0 || (Depth == 1 && Tokens[At].Is(","));
			if (!bEnds || At == Begin)
			{
				continue;
			}
			if (Index < Types.size())
			{
				const auto Original = Originals.find(Types[Index]);
				DeduceFrom(Template, Begin, At, Original == Originals.end() ? Types[Index] : Original->second,
					Arguments, NumGiven);
			}
			else if (!bDefault)
			{
				return false;
			}
			++Index;
			bDefault = false;
			Begin = At + 1;
		}
		return Types.size() <= Index;
	}

	/** From one parameter of the function, the tokens [Begin, End) of the declaration. */
	static void DeduceFrom(const FHlslTemplate& Template, size_t Begin, size_t End, const std::string& Type,
		std::vector<std::string>& Arguments, size_t NumGiven)
	{
		const FHlslTokens& Tokens = Template.Declaration;
		while (Begin + 2 < End && (Tokens[Begin].Is("in") || Tokens[Begin].Is("out") || Tokens[Begin].Is("inout") ||
									  Tokens[Begin].Is("const")))
		{
			++Begin;
		}
		const auto Set = [&](const FHlslToken& Name, const std::string& Value)
		{
			for (size_t i = NumGiven; i < Arguments.size() && !Value.empty(); ++i)
			{
				const bool bSame = Template.Parameters[i].Name == Name.Text;
				Arguments[i] = bSame && Arguments[i].empty() ? Value : Arguments[i];
			}
		};
		Set(Tokens[Begin], Type);
		if (!Tokens[Begin + 1].Is("<"))
		{
			return;
		}
		const std::optional<FHlslNumeric> Numeric = ParseHlslNumeric(Type);
		const bool bVector = Tokens[Begin].Is("vector") && Numeric && Numeric->Columns && !Numeric->IsMatrix();
		const bool bMatrix = Tokens[Begin].Is("matrix") && Numeric && Numeric->IsMatrix();
		if (bVector || bMatrix)
		{
			Set(Tokens[Begin + 2], Numeric->Scalar);
			Set(Tokens[Begin + 4], std::to_string(bMatrix ? Numeric->Rows : Numeric->Columns));
			Set(Tokens[std::min(Begin + 6, End)], bMatrix ? std::to_string(Numeric->Columns) : std::string());
		}
		else if (Type.rfind(Tokens[Begin].Text + "<", 0) == 0)
		{
			Set(Tokens[Begin + 2],
				Type.substr(Tokens[Begin].Text.size() + 1, Type.size() - Tokens[Begin].Text.size() - 2));
		}
	}

	static FHlslTokens MakeInstance(
		const FHlslTemplate& Template, const std::vector<std::string>& Arguments, const std::string& Mangled)
	{
		FHlslTokens Result;
		for (size_t i = 0; i < Template.Declaration.size(); ++i)
		{
			const FHlslToken& Token = Template.Declaration[i];
			const bool bMember = i > 0 && Template.Declaration[i - 1].Is(".");
			const auto Parameter = std::find_if(Template.Parameters.begin(), Template.Parameters.end(),
				[&Token](const FHlslTemplateParameter& Each) { return Token.IsWord() && Each.Name == Token.Text; });
			if (Token.Is("typename"))
			{
				continue;
			}
			if (Parameter != Template.Parameters.end() && !bMember)
			{
				const std::string& Value = Arguments[size_t(Parameter - Template.Parameters.begin())];
				for (FHlslToken& New : MakeHlslTokens(Value, Token))
				{
					Result.push_back(std::move(New));
				}
				continue;
			}
			const bool bList = i + 1 < Template.Declaration.size() && Template.Declaration[i + 1].Is("<");
			const bool bOwnName =
				i == Template.NameAt || (Template.bStruct && Token.Is(Template.Name.c_str()) && !bList);
			Result.push_back(Token);
			Result.back().Text = bOwnName ? Mangled : Token.Text;
		}
		return Result;
	}

	/** The first token of the declaration that At is in: the outermost one within namespaces. */
	size_t FindDeclarationStart(size_t At) const
	{
		size_t Start = 0;
		for (size_t i = 0; i < At; ++i)
		{
			const bool bNamespace = Text.Is(i, "{") && i >= 2 && Text.Is(i - 2, "namespace");
			const size_t Close = bNamespace ? i : Text.FindClose(i);
			if (Close >= At && !bNamespace)
			{
				break;
			}
			const bool bDeclares = Text.Is(Close, "}") && (Text.Is(Close + 1, ";") || Text.IsWord(Close + 1));
			const bool bFunction = Text.Is(i, "{") && Text.Is(Close, "}") && !Text.Is(Close + 1, ";");
			const bool bEnds = bNamespace || Text.Is(Close, ";") || bFunction || (Text.Is(Close, "}") && !bDeclares);
			Start = bEnds || Text[i].Text[0] == '#' ? Close + 1 : Start;
			i = Close;
		}
		return Start;
	}

	FHlslText& Text;
	std::vector<FDiagnostic>& Errors;
	FHlslTemplates Templates;
	std::set<std::string> Instances;
	std::map<std::string, std::string> Originals; // "TPair_float", "TPair<float>"
};

} // namespace

bool RewriteTemplates(FHlslText& Text, std::vector<FDiagnostic>& Errors)
{
	return FTemplateRewriter(Text, Errors).Run();
}

} // namespace Drydock
