// Statements that become several: stores to a part of a texel or of a matrix, and loops with a bound.
#include "HlslRewrites.h"

#include <algorithm>
#include <cstdlib>
#include <map>

namespace Drydock
{

namespace
{

bool IsCompound(const FHlslText& Text, size_t At)
{
	static const std::set<std::string> Signs = {"+=", "-=", "*=", "/=", "%=", "&=", "|=", "^=", "<<=", ">>="};
	return At < Text.Size() && Text[At].Kind == EShaderToken::Sign && Signs.count(Text[At].Text);
}

bool IsStep(const FHlslText& Text, size_t At)
{
	return Text.Is(At, "++") || Text.Is(At, "--");
}

/** Whether a statement begins at At. */
bool BeginsStatement(const FHlslText& Text, size_t At)
{
	return At == 0 || Text.Is(At - 1, ";") || Text.Is(At - 1, "{") || Text.Is(At - 1, "}") || Text.Is(At - 1, ")") ||
		   Text.Is(At - 1, "else") || Text.Is(At - 1, "do") || Text.Is(At - 1, ":");
}

size_t FindSemicolon(const FHlslText& Text, size_t At)
{
	while (At < Text.Size() && !Text.Is(At, ";"))
	{
		if (Text.Is(At, ")") || Text.Is(At, "}"))
		{
			return Text.Size();
		}
		At = Text.FindClose(At) + 1;
	}
	return At;
}

/** "uint2" of an RWTexture2D; empty for what has no texels that can be written. */
std::string GetPositionType(const std::string& Type)
{
	const std::string Kind = Type.substr(0, Type.find('<'));
	return Kind == "RWBuffer" || Kind == "RWTexture1D"           ? "uint"
		   : Kind == "RWTexture2D" || Kind == "RWTexture1DArray" ? "uint2"
		   : Kind == "RWTexture3D" || Kind == "RWTexture2DArray" ? "uint3"
																 : std::string();
}

class FStatementRewriter
{
public:
	FStatementRewriter(FHlslText& InText, const FHlslSymbols& InSymbols, std::vector<FDiagnostic>& OutErrors)
		: Text(InText)
		, Symbols(InSymbols)
		, Errors(OutErrors)
	{
	}

	bool Run()
	{
		for (size_t At = 0; At < Text.Size(); ++At)
		{
			if (Text.Is(At, "[") && Text.Is(At + 1, "unroll") && Text.Is(At + 2, "("))
			{
				BoundLoop(At);
			}
			else if (Text.Is(At, "GetDimensions") && At > 1 && Text.Is(At - 1, ".") && Text.Is(At + 1, "("))
			{
				CountBytes(At);
			}
			else if (Text.IsWord(At) && Text.Is(At + 1, "["))
			{
				CheckElement(At);
				StoreTexel(At);
			}
			else if (Text.IsWord(At) && At > 1 && Text.Is(At - 1, ".") && Text.Is(At + 1, "("))
			{
				CheckMethod(At);
			}
			else if (Text.IsWord(At) && At > 1 && Text.Is(At - 1, ".") && Text[At].Text[0] == '_')
			{
				StoreElements(At);
			}
		}
		const bool bChanged = !Edits.IsEmpty();
		Edits.Apply(Text);
		return bChanged;
	}

private:
	void Error(size_t At, const std::string& Message) { Errors.push_back(Text.MakeError(At, Message)); }

	/** Buffer.GetDimensions(Size); of a ByteAddressBuffer, whose size the front end gives in words. */
	void CountBytes(size_t At)
	{
		const FHlslVariable* Variable = Symbols.FindVariable(Text[At - 2].Text, At);
		const bool bBytes =
			Variable && (Variable->Type == "ByteAddressBuffer" || Variable->Type == "RWByteAddressBuffer");
		if (!bBytes || (At > 2 && Text.Is(At - 3, ".")))
		{
			return;
		}
		const size_t Close = Text.FindClose(At + 1);
		if (!BeginsStatement(Text, At - 2) || !Text.Is(Close + 1, ";"))
		{
			Error(At, "GetDimensions of a buffer of bytes has to be a statement of its own");
			return;
		}
		Edits.Insert(At - 2, "{ uint DrydockWords;");
		Edits.Replace(At + 2, Close, "DrydockWords");
		Edits.Replace(Close + 1, Close + 2, "; " + Text.GetText(At + 2, Close) + " = DrydockWords * 4u; }");
	}

	/** "RWStructuredBuffer" of the variable at At; empty where it is an array, a member or no buffer. */
	std::string FindBufferKind(size_t At) const
	{
		const FHlslVariable* const Variable =
			At > 0 && Text.Is(At - 1, ".") ? nullptr : Symbols.FindVariable(Text[At].Text, At);
		const std::string Kind =
			Variable && !Variable->bArray ? Variable->Type.substr(0, Variable->Type.find('<')) : "";
		static const std::set<std::string> Buffers = {"Buffer", "RWBuffer", "StructuredBuffer", "RWStructuredBuffer",
			"AppendStructuredBuffer", "ConsumeStructuredBuffer", "ByteAddressBuffer", "RWByteAddressBuffer"};
		return Buffers.count(Kind) ? Kind : std::string();
	}

	static bool IsStream(const std::string& Kind)
	{
		return Kind == "AppendStructuredBuffer" || Kind == "ConsumeStructuredBuffer";
	}

	void RefuseMember(size_t At, const std::string& Kind, const std::string& Member, const std::string& Other)
	{
		const auto WithArticle = [](const std::string& Name)
		{
			return (Name[0] == 'A' ? "an " : "a ") + Name;
		};
		Error(At, WithArticle(Kind) + " has no " + Member + ": use " + WithArticle(Other));
	}

	/** The front end appends to whatever is a structured buffer, and to a few that are none. */
	void CheckMethod(size_t At)
	{
		static const std::map<std::string, std::string> Owners = {{"Append", "AppendStructuredBuffer"},
			{"Consume", "ConsumeStructuredBuffer"}, {"IncrementCounter", "RWStructuredBuffer"},
			{"DecrementCounter", "RWStructuredBuffer"}};
		const std::string Kind = FindBufferKind(At - 2);
		const auto Owner = Owners.find(Text[At].Text);
		const bool bCounts = Owner != Owners.end();
		if (!Kind.empty() && (bCounts ? Owner->second != Kind : IsStream(Kind)))
		{
			RefuseMember(At, Kind, Text[At].Text, bCounts ? Owner->second : "RWStructuredBuffer");
		}
	}

	/** Kept[Index] */
	void CheckElement(size_t At)
	{
		if (const std::string Kind = FindBufferKind(At); IsStream(Kind))
		{
			RefuseMember(At, Kind, "elements by number", "RWStructuredBuffer");
		}
	}

	/** Out[P].rgb = V; */
	void StoreTexel(size_t At)
	{
		const FHlslVariable* Variable =
			At > 0 && Text.Is(At - 1, ".") ? nullptr : Symbols.FindVariable(Text[At].Text, At);
		const std::string Position = Variable && !Variable->bArray ? GetPositionType(Variable->Type) : std::string();
		const size_t Close = Text.FindClose(At + 1);
		const size_t Part = Close + 1;
		if (Position.empty() || !(Text.Is(Part, ".") || Text.Is(Part, "[")))
		{
			return;
		}
		const size_t Behind = Text.Is(Part, ".") ? Part + 2 : Text.FindClose(Part) + 1;
		const bool bPrefix = At > 0 && IsStep(Text, At - 1);
		if (!bPrefix && !Text.Is(Behind, "=") && !IsCompound(Text, Behind) && !IsStep(Text, Behind))
		{
			return;
		}
		const size_t First = bPrefix ? At - 1 : At;
		const size_t End = FindSemicolon(Text, Behind);
		if (!BeginsStatement(Text, First) || End >= Text.Size())
		{
			Error(At,
				"a part of a texel of '" + Text[At].Text +
					"' can only be written by a statement of its own: read the texel, change it, and write it whole");
			return;
		}
		const std::string& Name = Text[At].Text;
		Edits.Replace(First, At + 2, "{ " + Position + " DrydockAt =");
		Edits.Replace(Close, Close + 1,
			"; " + GetHlslElementType(Variable->Type) + " " + GPartOfTexel + " = " + Name + "[DrydockAt]; " +
				(bPrefix ? Text[First].Text : std::string()) + GPartOfTexel);
		Edits.Replace(End, End + 1, "; " + Name + "[DrydockAt] = " + GPartOfTexel + "; }");
	}

	/** M._m00_m11 = V; */
	void StoreElements(size_t At)
	{
		const std::vector<std::string> Elements = SplitMatrixSwizzle(Text[At].Text);
		const bool bStore = Text.Is(At + 1, "=") || IsCompound(Text, At + 1);
		if (Elements.empty() || !bStore)
		{
			return;
		}
		const size_t First = Symbols.FindChainStart(At - 2);
		const std::string Matrix = Text.GetText(First, At - 1);
		const std::optional<FHlslNumeric> Type = ParseHlslNumeric(Symbols.GetType(First, At - 1));
		const size_t End = FindSemicolon(Text, At + 1);
		const bool bSimple = Matrix.find('(') == std::string::npos && Matrix.find("++") == std::string::npos &&
							 Matrix.find("--") == std::string::npos;
		if (!Type || !bSimple || !BeginsStatement(Text, First) || End >= Text.Size())
		{
			Error(At, "elements of a matrix can only be written together (" + Text[At].Text +
						  ") by a statement of its own, to a matrix that is a variable: write them one by one");
			return;
		}
		const std::string Vector = Type->Scalar + std::to_string(Elements.size());
		std::string Before;
		std::string Stores;
		for (size_t i = 0; i < Elements.size(); ++i)
		{
			Before += (i ? ", " : Vector + "(") + Matrix + "." + Elements[i];
			Stores += " " + Matrix + "." + Elements[i] + " = DrydockElements." + "xyzw"[i] + ";";
		}
		const bool bCompound = !Text.Is(At + 1, "=");
		const std::string Sign = Text[At + 1].Text.substr(0, Text[At + 1].Text.size() - 1);
		Edits.Replace(First, At + 2,
			"{ " + Vector + " DrydockElements = " + (bCompound ? Before + ") " + Sign + " (" : std::string("(")));
		Edits.Replace(End, End + 1, ");" + Stores + " }");
	}

	/** [unroll(N)] for (...) ...; */
	void BoundLoop(size_t At)
	{
		const size_t ListClose = Text.FindClose(At + 2);
		const std::string Bound = Text.GetText(At + 3, std::min(ListClose, Text.Size()));
		size_t Loop = Text.FindClose(At) + 1;
		while (Text.Is(Loop, "["))
		{
			Loop = Text.FindClose(Loop) + 1;
		}
		const size_t End = Text.FindStatementEnd(Loop);
		const std::string Test = "DrydockSteps++ < uint(" + Bound + ")";
		Edits.Replace(At + 2, ListClose + 1, "");
		size_t First = Loop + 2; // of the condition
		size_t Last = Text.FindClose(Loop + 1);
		if (Text.Is(Loop, "for"))
		{
			First = FindSemicolon(Text, Loop + 2) + 1;
			Last = FindSemicolon(Text, First);
			if (Last >= Text.Size() || StaysBelow(Loop, First, Last, End, Bound))
			{
				return;
			}
		}
		else if (Text.Is(Loop, "do"))
		{
			Last = End - 2; // ) ;
			First = Last;
			while (First > Loop && !(Text.Is(First, "(") && Text.FindClose(First) == Last))
			{
				--First;
			}
			++First;
		}
		else if (!Text.Is(Loop, "while"))
		{
			return;
		}
		if (!Text.Is(Last, ";") && !Text.Is(Last, ")"))
		{
			return;
		}
		const std::string Start = Text.Is(Loop, "do") ? "1u" : "0u"; // its first step is not asked for
		Edits.Insert(At, "{ uint DrydockSteps = " + Start + ";");
		if (First < Last)
		{
			Edits.Insert(First, Test + " && (");
			Edits.Insert(Last, ")");
		}
		else
		{
			Edits.Insert(First, Test);
		}
		Edits.Insert(End, "}");
	}

	/** Whether `for (int i = 0; i < 4; ++i)` is that, with a count that needs no bound, and i is not changed inside. */
	bool StaysBelow(size_t Loop, size_t First, size_t Last, size_t End, const std::string& Bound) const
	{
		const size_t Equal = First - 3; // int i = 0 ; i < 4 ; ++i
		const bool bHead = First >= Loop + 7 && Text.Is(Equal, "=") && Text.IsWord(Equal - 1) && Last == First + 3 &&
						   (Text.Is(First + 1, "<") || Text.Is(First + 1, "<=")) &&
						   Text.Is(First, Text[Equal - 1].Text.c_str());
		if (!bHead)
		{
			return false;
		}
		const std::string& Name = Text[Equal - 1].Text;
		const bool bStep = (Text.Is(Last + 1, "++") && Text.Is(Last + 2, Name.c_str())) ||
						   (Text.Is(Last + 2, "++") && Text.Is(Last + 1, Name.c_str()));
		const auto GetNumber = [](const std::string& Number)
		{
			char* Stop = nullptr;
			const long Value = std::strtol(Number.c_str(), &Stop, 0);
			const bool bWhole = Stop != Number.c_str() && (*Stop == '\0' || ((*Stop | 0x20) == 'u' && Stop[1] == '\0'));
			return bWhole ? Value : -1L;
		};
		const long From = GetNumber(Text[Equal + 1].Text);
		const long To = GetNumber(Text[First + 2].Text);
		const long Most = GetNumber(Bound);
		if (!bStep || !Text.Is(Last + 3, ")") || From < 0 || To < 0 || Most < 0)
		{
			return false;
		}
		for (size_t At = Last + 4; At < End; ++At)
		{
			const bool bChanged =
				Text.Is(At, Name.c_str()) &&
				(Text.Is(At + 1, "=") || IsCompound(Text, At + 1) || IsStep(Text, At + 1) || IsStep(Text, At - 1) ||
					(Text.Is(At + 1, ",") ||
						(Text.Is(At + 1, ")") && !Text.Is(At - 1, "(")))); // may be an out argument
			if (bChanged)
			{
				return false;
			}
		}
		return To - From + (Text.Is(First + 1, "<=") ? 1 : 0) <= Most;
	}

	FHlslText& Text;
	const FHlslSymbols& Symbols;
	std::vector<FDiagnostic>& Errors;
	FHlslEdits Edits;
};

} // namespace

bool RewriteStatements(FHlslText& Text, const FHlslSymbols& Symbols, std::vector<FDiagnostic>& Errors)
{
	return FStatementRewriter(Text, Symbols, Errors).Run();
}

} // namespace Drydock
