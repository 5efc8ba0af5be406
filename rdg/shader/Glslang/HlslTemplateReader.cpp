// Finds templates and takes them apart.
#include "HlslTemplates.h"

#include <cctype>

namespace Drydock
{

namespace
{

class FTemplateReader
{
public:
	FTemplateReader(FHlslText& InText, std::set<std::string>& OutSpecializations, std::vector<FDiagnostic>& OutErrors)
		: Text(InText)
		, Specializations(OutSpecializations)
		, Errors(OutErrors)
	{
	}

	FHlslTemplates Run()
	{
		FHlslEdits Edits;
		for (size_t At = 0; At < Text.Size() && Errors.empty(); ++At)
		{
			if (!Text.Is(At, "template") || !Text.Is(At + 1, "<"))
			{
				continue;
			}
			const size_t ListEnd = FindParametersEnd(At + 1);
			const size_t End = ListEnd ? FindDeclarationEnd(ListEnd) : 0;
			if (!End)
			{
				Error(At, "this template is not one of a function or a struct");
				break;
			}
			if (IsInStruct(At))
			{
				Error(At, "a template inside a struct is not supported: declare it outside");
				break;
			}
			if (ListEnd == At + 3) // template<> float F<int>(...)
			{
				TakeSpecialization(At, ListEnd, End, Edits);
			}
			else
			{
				TakeTemplate(At, ListEnd, End);
				Edits.Replace(At, End, "");
			}
			At = End - 1;
		}
		Edits.Apply(Text);
		return std::move(Templates);
	}

private:
	void Error(size_t At, const std::string& Message) { Errors.push_back(Text.MakeError(At, Message)); }

	bool IsInStruct(size_t At) const
	{
		for (size_t i = 0; i < At; ++i)
		{
			if (!Text.Is(i, "{") || Text.FindClose(i) < At)
			{
				i = Text.Is(i, "{") ? Text.FindClose(i) : i;
			}
			else if (!(i >= 1 && (Text.Is(i - 1, "namespace") || (i >= 2 && Text.Is(i - 2, "namespace")))))
			{
				return true;
			}
		}
		return false;
	}

	/** Behind the > of `<typename T, int N = (1 << 2)>`. */
	size_t FindParametersEnd(size_t Open) const
	{
		int Depth = 0;
		for (size_t At = Open; At < Text.Size(); ++At)
		{
			At = Text.Is(At, "(") ? Text.FindClose(At) : At;
			Depth += Text.Is(At, "<") ? 1 : Text.Is(At, ">") ? -1 : Text.Is(At, ">>") ? -2 : 0;
			if (Depth <= 0)
			{
				return At + 1;
			}
			if (Text.Is(At, ";") || Text.Is(At, "{"))
			{
				return 0;
			}
		}
		return 0;
	}

	size_t FindDeclarationEnd(size_t At) const
	{
		for (; At < Text.Size(); ++At)
		{
			if (Text.Is(At, ";"))
			{
				return At + 1;
			}
			if (Text.Is(At, "{"))
			{
				const size_t Close = Text.FindClose(At) + 1;
				return Close > Text.Size() ? 0 : Text.Is(Close, ";") ? Close + 1 : Close;
			}
			At = Text.Is(At, "(") ? Text.FindClose(At) : At;
		}
		return 0;
	}

	/** The name in a declaration that begins at First: the struct's, or the word before the first parenthesis. */
	size_t FindName(size_t First, size_t End) const
	{
		if (Text.Is(First, "struct") || Text.Is(First, "class"))
		{
			return First + 1;
		}
		size_t At = First;
		while (At < End && !Text.Is(At, "("))
		{
			At = Text.Is(At, "[") ? Text.FindClose(At) + 1 : At + 1;
		}
		if (At > First && Text.Is(At - 1, ">")) // F<int>(
		{
			while (At > First && !Text.Is(At, "<"))
			{
				--At;
			}
		}
		return At > First ? At - 1 : First;
	}

	void TakeSpecialization(size_t At, size_t First, size_t End, FHlslEdits& Edits)
	{
		const size_t NameAt = FindName(First, End);
		const size_t ListEnd = Text.Is(NameAt + 1, "<") ? Text.FindListEnd(NameAt + 1) : 0;
		if (!ListEnd)
		{
			Error(NameAt, "a specialization needs its arguments: " + Text[NameAt].Text + "<...>");
			return;
		}
		const std::string Mangled = MangleHlslName(Text[NameAt].Text, SplitHlslList(Text, NameAt + 1, ListEnd));
		Specializations.insert(Mangled);
		Edits.Replace(At, First, "");
		Edits.Replace(NameAt, ListEnd, Mangled);
	}

	void TakeTemplate(size_t At, size_t First, size_t End)
	{
		FHlslTemplate Template;
		Template.bStruct = Text.Is(First, "struct") || Text.Is(First, "class");
		const size_t NameAt = FindName(First, End);
		Template.Name = Text[NameAt].Text;
		Template.NameAt = NameAt - First;
		Template.Declaration.assign(
			Text.Tokens.begin() + std::ptrdiff_t(First), Text.Tokens.begin() + std::ptrdiff_t(End));
		size_t Begin = At + 2;
		int Depth = 0;
		for (size_t i = Begin; i < First; ++i)
		{
			Depth += Text.Is(i, "(") || Text.Is(i, "<") ? 1 : Text.Is(i, ")") || Text.Is(i, ">") ? -1 : 0;
			if (i + 1 == First || (Text.Is(i, ",") && Depth == 0))
			{
				size_t Equal = Begin;
				while (Equal < i && !Text.Is(Equal, "="))
				{
					++Equal;
				}
				Template.Parameters.push_back(
					{Text[Equal - 1].Text, Equal < i ? Text.GetText(Equal + 1, i) : std::string()});
				Begin = i + 1;
			}
		}
		const bool bForward = Text.Is(End - 1, ";") && !Text.Is(End - 2, "}");
		if (!bForward)
		{
			Templates[Template.Name].push_back(std::move(Template));
		}
		else
		{
			Templates[Template.Name];
		}
	}

	FHlslText& Text;
	std::set<std::string>& Specializations;
	std::vector<FDiagnostic>& Errors;
	FHlslTemplates Templates;
};

} // namespace

FHlslTemplates TakeHlslTemplates(
	FHlslText& Text, std::set<std::string>& Specializations, std::vector<FDiagnostic>& Errors)
{
	return FTemplateReader(Text, Specializations, Errors).Run();
}

std::string MangleHlslName(const std::string& Name, const std::vector<std::string>& Arguments)
{
	std::string Result = Name;
	for (const std::string& Argument : Arguments)
	{
		Result += '_';
		for (const char c : Argument)
		{
			Result += std::isalnum(static_cast<unsigned char>(c)) ? c : '_';
		}
	}
	return Result;
}

std::vector<std::string> SplitHlslList(const FHlslText& Text, size_t Open, size_t End)
{
	std::vector<std::string> Result;
	size_t Begin = Open + 1;
	int Depth = 0;
	for (size_t At = Open + 1; At < End; ++At)
	{
		const bool bLast = At + 1 == End;
		if (bLast || (Text.Is(At, ",") && Depth == 0))
		{
			// ">>" closes the list of an argument and this one
			Result.push_back(Text.GetText(Begin, At) + (bLast && Text.Is(At, ">>") ? ">" : ""));
			Begin = At + 1;
		}
		Depth += Text.Is(At, "<") ? 1 : Text.Is(At, ">") ? -1 : 0;
	}
	return Result;
}

} // namespace Drydock
