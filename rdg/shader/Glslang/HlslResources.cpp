// Resources in arrays, local variables and structs, of which the front end knows none or loses what is written: there
// they are numbers of the resources that the shader declares, and functions read and write by number.
#include "HlslRewrites.h"

#include "HlslResources.h"
#include "SpirvModule.h"

#include <algorithm>

namespace Drydock
{

namespace
{

class FResourceRewriter
{
public:
	FResourceRewriter(FHlslText& InText, const FHlslSymbols& InSymbols, std::vector<FDiagnostic>& OutErrors)
		: Text(InText)
		, Errors(OutErrors)
		, Numbers(InText, InSymbols, OutErrors)
	{
	}

	bool Run()
	{
		if (Numbers.IsEmpty() || !Errors.empty())
		{
			return false;
		}
		Numbers.Declare(Edits);
		for (size_t At = 0; At < Text.Size(); ++At)
		{
			if (Text.IsWord(At) && !(At > 0 && (Text.Is(At - 1, ".") || Text.Is(At - 1, "::"))))
			{
				if (const std::optional<FHlslResourceUse> Use = Numbers.FindUse(At))
				{
					At = std::max(At, Rewrite(*Use));
				}
			}
		}
		if (!Accessors.empty())
		{
			Edits.Insert(FirstUse, Accessors.GetPrototypes());
			Text.Files.push_back(GSpirvFileOfCallers);
			Edits.Move(
				Text.Size(), MakeHlslTokens(Accessors.GetFunctions(Numbers), {{}, uint32_t(Text.Files.size() - 1), 1}));
		}
		const bool bChanged = !Edits.IsEmpty();
		Edits.Apply(Text);
		return bChanged;
	}

private:
	void Error(size_t At, const std::string& Message) { Errors.push_back(Text.MakeError(At, Message)); }

	/** Returns the last token that was looked at. */
	size_t Rewrite(const FHlslResourceUse& Use)
	{
		for (size_t At = Use.First + 1; At < Use.End; ++At)
		{
			if (Text.IsWord(At) && !Text.Is(At - 1, ".") && Numbers.FindUse(At))
			{
				Error(At, "a resource inside the index of another: take the index out into a variable");
				return Use.End - 1;
			}
		}
		if (Use.Type.starts_with("ConstantBuffer"))
		{
			const std::string Words = Use.Name.empty() ? Accessors.Read(Use.Type, Use.Number) : Use.Name;
			Edits.Replace(Use.First, Use.End, Words);
			NoteUse(Use.First);
			return Use.End - 1;
		}
		const bool bElement = Text.Is(Use.End, "[");
		const bool bMethod = Text.Is(Use.End, ".") && Text.Is(Use.End + 2, "(");
		if (!Use.Name.empty() && (bElement || bMethod)) // known here
		{
			if (Use.Name != Text.GetText(Use.First, Use.End))
			{
				Edits.Replace(Use.First, Use.End, Use.Name);
			}
			return Use.End - 1;
		}
		if (Use.bArray)
		{
			PassArray(Use);
		}
		else if (bElement)
		{
			RewriteElement(Use);
		}
		else if (bMethod)
		{
			CallMethod(Use);
		}
		else
		{
			Edits.Replace(Use.First, Use.End, Use.Number);
		}
		return Use.End - 1;
	}

	/** The declaration around the first use, before which the functions are declared. */
	void NoteUse(size_t At) { FirstUse = std::min(FirstUse, Text.FindDeclaration(At)); }

	/** A part of an array of the shader as an argument: an array of numbers. */
	void PassArray(const FHlslResourceUse& Use)
	{
		size_t Start = Use.First;
		while (Start > 0 && !Text.Is(Start - 1, ";") && !Text.Is(Start - 1, "{") && !Text.Is(Start - 1, "}"))
		{
			--Start;
		}
		if (Use.PartNumbers.empty())
		{
			return; // of a local variable, which is one already
		}
		const std::string Name = "DrydockPart" + std::to_string(NumParts++);
		std::string List;
		for (const std::string& Number : Use.PartNumbers)
		{
			List += (List.empty() ? "" : ", ") + Number;
		}
		Edits.Insert(Start, "uint " + Name + "[" + std::to_string(Use.PartNumbers.size()) + "] = { " + List + " };");
		Edits.Replace(Use.First, Use.End, Name);
	}

	/** Use[Index], read or written. */
	void RewriteElement(const FHlslResourceUse& Use)
	{
		NoteUse(Use.First);
		const size_t Close = Text.FindClose(Use.End);
		size_t Behind = Close + 1; // behind the members of the element
		while (Text.Is(Behind, "[") || (Text.Is(Behind, ".") && Text.IsWord(Behind + 1)))
		{
			Behind = Text.Is(Behind, "[") ? Text.FindClose(Behind) + 1 : Behind + 2;
		}
		const bool bStep = Text.Is(Behind, "++") || Text.Is(Behind, "--");
		const std::string Sign = Behind < Text.Size() ? Text[Behind].Text : std::string();
		const bool bCompound =
			Sign.size() > 1 && Sign.back() == '=' && Sign != "==" && Sign != "<=" && Sign != ">=" && Sign != "!=";
		if (Sign != "=" && !bCompound && !bStep)
		{
			Edits.Replace(Use.First, Use.End + 1, Accessors.Get(Use.Type) + "(" + Use.Number + ", ");
			Edits.Replace(Close, Close + 1, ")");
			return;
		}
		size_t End = Behind;
		while (End < Text.Size() && !Text.Is(End, ";") && !Text.Is(End, ")") && !Text.Is(End, "}"))
		{
			End = Text.FindClose(End) + 1;
		}
		const bool bStarts = Use.First > 0 && (Text.Is(Use.First - 1, ";") || Text.Is(Use.First - 1, "{") ||
												  Text.Is(Use.First - 1, "}") || Text.Is(Use.First - 1, ")") ||
												  Text.Is(Use.First - 1, "else"));
		if (!bStarts || !Text.Is(End, ";") || !Use.Type.starts_with("RW"))
		{
			Error(Use.First,
				"a store to a resource of an array, a variable or a struct has to be a statement of its own");
			return;
		}
		const std::string Index = Text.GetText(Use.End + 1, Close);
		if (Sign == "=" && Behind == Close + 1)
		{
			Edits.Replace(Use.First, Use.End + 1, Accessors.Set(Use.Type) + "(" + Use.Number + ", ");
			Edits.Replace(Close, Behind + 1, ", ");
			Edits.Insert(End, ")");
			return;
		}
		const std::string Place = "(" + Use.Number + ", " + Index;
		const bool bPart = Behind != Close + 1 && !Use.Type.starts_with("RWStructuredBuffer");
		const std::string Name = bPart ? GPartOfTexel : "DrydockElement";
		Edits.Replace(Use.First, Close + 1,
			"{ " + GetHlslElementType(Use.Type) + " " + Name + " = " + Accessors.Get(Use.Type) + Place + "); " + Name);
		Edits.Insert(End + 1, Accessors.Set(Use.Type) + Place + ", " + Name + "); }");
	}

	/** Use.Method(...) */
	void CallMethod(const FHlslResourceUse& Use)
	{
		NoteUse(Use.First);
		const std::string& Method = Text[Use.End + 1].Text;
		const std::string Name = Accessors.Call(Use.Type, Method);
		if (Name.empty())
		{
			Error(Use.End + 1,
				Method + " of a " + Use.Type +
					" in an array, a variable or a struct is not supported: call it of a resource by name");
			return;
		}
		const bool bArguments = !Text.Is(Use.End + 3, ")");
		Edits.Replace(Use.First, Use.End + 3, Name + "(" + Use.Number + (bArguments ? ", " : ""));
	}

	FHlslText& Text;
	std::vector<FDiagnostic>& Errors;
	FHlslResourceNumbers Numbers;
	FHlslResourceAccessors Accessors;
	size_t FirstUse = ~size_t(0);
	int NumParts = 0;
	FHlslEdits Edits;
};

} // namespace

bool RewriteResources(FHlslText& Text, const FHlslSymbols& Symbols, std::vector<FDiagnostic>& Errors)
{
	return FResourceRewriter(Text, Symbols, Errors).Run();
}

} // namespace Drydock
