// `C ? A : B`, `A && B` and `A || B` whose second part has a wave operation or an atomic one: HLSL 2021 reaches it with
// the threads for which it counts, the front end with all of them. As statements they mean the first.
#include "HlslRewrites.h"

#include <algorithm>

namespace Drydock
{

namespace
{

bool StartsAsWave(const std::string& Name)
{
	return Name.rfind("Wave", 0) == 0 || Name.rfind("QuadRead", 0) == 0 || Name.rfind("Interlocked", 0) == 0;
}

bool IsAssignment(const FHlslToken& Token)
{
	static const std::set<std::string> Signs = {"=", "+=", "-=", "*=", "/=", "%=", "&=", "|=", "^="};
	return Token.Kind == EShaderToken::Sign && Signs.count(Token.Text);
}

class FChoiceRewriter
{
public:
	FChoiceRewriter(FHlslText& InText, const FHlslSymbols& InSymbols, std::vector<FDiagnostic>& OutErrors)
		: Text(InText)
		, Symbols(InSymbols)
		, Errors(OutErrors)
	{
		FindWaveFunctions();
	}

	/** One round: the outermost of each statement. */
	bool Run()
	{
		size_t Behind = 0; // the last statement that was rewritten
		for (size_t At = 0; At < Text.Size(); ++At)
		{
			const size_t Start = IsWave(At) ? FindLazyStart(At) : Text.Size();
			if (Start < Text.Size() && Start >= Behind)
			{
				Behind = RewriteStatement(Start, At);
			}
		}
		const bool bChanged = !Edits.IsEmpty();
		Edits.Apply(Text);
		return bChanged;
	}

private:
	/** An operator at the level of an expression: the one that binds least. */
	struct FSplit
	{
		size_t At = 0;
		size_t Colon = 0; // of ?
	};

	/** Functions of the text that call wave operations, also through others. */
	void FindWaveFunctions()
	{
		for (bool bMore = true; bMore;)
		{
			bMore = false;
			for (size_t At = 0; At < Text.Size(); ++At)
			{
				const bool bHead = Text.IsWord(At) && Text.Is(At + 1, "(") && Symbols.FindFunctions(Text[At].Text);
				size_t Open = bHead ? Text.FindClose(At + 1) + 1 : Text.Size();
				while (Text.Is(Open, ":") || Text.IsWord(Open)) // a semantic
				{
					++Open;
				}
				const size_t Close = Text.Is(Open, "{") && bHead ? Text.FindClose(Open) : 0;
				for (size_t i = Open; i < Close && !Waves.count(Text[At].Text); ++i)
				{
					bMore = (IsWave(i) && Waves.insert(Text[At].Text).second) || bMore;
				}
			}
		}
	}

	bool IsWave(size_t At) const
	{
		if (!Text.IsWord(At) || !Text.Is(At + 1, "("))
		{
			return false;
		}
		const std::string& Name = Text[At].Text;
		const bool bOwn = Symbols.FindFunctions(Name) != nullptr;
		const bool bName = StartsAsWave(Name);
		const bool bPlain = Name == "WaveGetLaneCount" || Name == "WaveGetLaneIndex"; // the same for whoever asks
		const bool bHead =
			bOwn && At > 0 && Text.IsWord(At - 1) && !Text.Is(At - 1, "return") && !Text.Is(At - 1, "else");
		return bOwn ? Waves.count(Name) && !bHead : bName && !bPlain;
	}

	bool HasWave(size_t First, size_t End) const
	{
		for (size_t At = First; At < End; ++At)
		{
			if (IsWave(At))
			{
				return true;
			}
		}
		return false;
	}

	static bool IsLazy(const FHlslToken& Token) { return Token.Is("?") || Token.Is("&&") || Token.Is("||"); }

	/** The statement of a wave operation that stands behind ?, && or ||; Text.Size() where it stands behind none. */
	size_t FindLazyStart(size_t At) const
	{
		bool bLazy = false;
		bool bOther = false; // in another argument of the call around this one
		int Depth = 0;
		for (size_t i = At; i-- > 0;)
		{
			if (Text.Is(i, ")") || Text.Is(i, "]"))
			{
				++Depth;
			}
			else if (Text.Is(i, "(") || Text.Is(i, "["))
			{
				bOther = bOther && Depth > 0;
				Depth = std::max(Depth - 1, 0); // 0: an expression around this one
			}
			else if (Text.Is(i, ";") || Text.Is(i, "{") || Text.Is(i, "}"))
			{
				return bLazy ? i + 1 : Text.Size();
			}
			bOther = bOther || (Depth == 0 && Text.Is(i, ","));
			bLazy = bLazy || (Depth == 0 && !bOther && IsLazy(Text[i]));
		}
		return Text.Size();
	}

	FSplit FindSplit(size_t First, size_t End) const
	{
		FSplit Result;
		const auto GetRank = [](const FHlslToken& Token)
		{
			return Token.Is("?") ? 3 : Token.Is("||") ? 2 : Token.Is("&&") ? 1 : 0;
		};
		for (size_t At = First; At < End; ++At)
		{
			const size_t Close = Text.FindClose(At);
			if (Close != At)
			{
				At = Close;
				continue;
			}
			const int Rank = GetRank(Text[At]);
			const int Best = Result.At ? GetRank(Text[Result.At]) : 0;
			if (Rank > Best || (Rank == Best && Rank > 0 && Rank < 3)) // ?: groups to the right, the others to the left
			{
				Result.At = At;
			}
		}
		if (Result.At && Text.Is(Result.At, "?"))
		{
			int Open = 0;
			for (size_t At = Result.At; At < End && !Result.Colon; ++At)
			{
				Open += Text.Is(At, "?") ? 1 : Text.Is(At, ":") ? -1 : 0;
				Result.Colon = Open == 0 ? At : 0;
				At = std::max(At, Text.FindClose(At));
			}
		}
		return Result;
	}

	/** "Name = C ? A : B;" and its like as an if. */
	std::string WriteChoice(const std::string& Target, size_t First, const FSplit& Split, size_t End) const
	{
		const std::string Left = Text.GetText(First, Split.At);
		if (Text.Is(Split.At, "?"))
		{
			return "if (" + Left + ") { " + Target + Text.GetText(Split.At + 1, Split.Colon) + "; } else { " + Target +
				   Text.GetText(Split.Colon + 1, End) + "; }";
		}
		const std::string Test = Text.Is(Split.At, "&&") ? "if (DrydockTest) " : "if (!DrydockTest) ";
		return "bool DrydockTest = " + Left + "; " + Test + "{ DrydockTest = " + Text.GetText(Split.At + 1, End) +
			   "; } ";
	}

	/** Returns where its end is. Wave: the operation that is asked about. */
	size_t RewriteStatement(size_t Start, size_t Wave)
	{
		while (Text.Is(Start, "else") || Text.Is(Start, "do") || Text.Is(Start, "["))
		{
			Start = Text.FindClose(Start) + 1;
		}
		size_t End = Start;
		size_t Equal = 0;
		while (End < Text.Size() && !Text.Is(End, ";") && !Text.Is(End, "{") && !Text.Is(End, ")"))
		{
			Equal = !Equal && IsAssignment(Text[End]) ? End : Equal;
			End = Text.FindClose(End) + 1;
		}
		const bool bIf = Text.Is(Start, "if") && Text.Is(Start + 1, "(");
		const bool bReturn = Text.Is(Start, "return");
		if (bIf && Wave > Text.FindClose(Start + 1)) // in its only statement, which has no braces
		{
			return RewriteStatement(Text.FindClose(Start + 1) + 1, Wave);
		}
		const size_t First = bIf ? Start + 2 : bReturn ? Start + 1 : Equal + 1;
		const size_t Last = bIf ? Text.FindClose(Start + 1) : End;
		const FSplit Split = FindSplit(First, Last);
		const bool bPlace = bIf || ((bReturn || Equal) && Text.Is(End, ";"));
		const bool bChoice = Split.At && Text.Is(Split.At, "?");
		const bool bHere = Split.At && (!bChoice || Split.Colon) && HasWave(Split.At, Last);
		const bool bCompound = Equal && !Text.Is(Equal, "=") && !bChoice;
		if (!bPlace || !bHere || (bIf && bChoice) || bCompound || HasComma(First, Last))
		{
			Errors.push_back(Text.MakeError(Wave,
				Text[Wave].Text + " behind ?, && or || is for the threads that come to it: write an if statement"));
			return End;
		}
		if (bIf)
		{
			const size_t Whole = Text.FindStatementEnd(Start);
			Edits.Insert(Start, "{ " + WriteChoice({}, First, Split, Last));
			Edits.Replace(First, Last, "DrydockTest");
			Edits.Insert(Whole, "}");
			return Last;
		}
		const bool bDeclares = !bReturn && Equal > Start + 1 && Text.IsWord(Equal - 1) && !Text.Is(Equal - 2, ".");
		const std::string Target = bReturn ? "return " : Text.GetText(bDeclares ? Equal - 1 : Start, Equal + 1) + " ";
		std::string Words;
		if (bDeclares)
		{
			const size_t Type = Text.Is(Start, "const") ? Start + 1 : Start;
			Words = Text.GetText(Type, Equal) + "; ";
		}
		Words += bChoice ? WriteChoice(Target, First, Split, Last)
						 : "{ " + WriteChoice({}, First, Split, Last) + Target + "DrydockTest; }";
		Edits.Replace(Start, End + 1, Words);
		return End;
	}

	bool HasComma(size_t First, size_t End) const
	{
		for (size_t At = First; At < End; ++At)
		{
			if (Text.Is(At, ","))
			{
				return true;
			}
			At = std::max(At, Text.FindClose(At));
		}
		return false;
	}

	FHlslText& Text;
	const FHlslSymbols& Symbols;
	std::vector<FDiagnostic>& Errors;
	std::set<std::string> Waves; // functions
	FHlslEdits Edits;
};

} // namespace

bool RewriteChoices(FHlslText& Text, std::vector<FDiagnostic>& Errors)
{
	constexpr int MaxRounds = 64; // levels of choices inside each other
	const bool bAny = std::any_of(Text.Tokens.begin(), Text.Tokens.end(),
		[](const FHlslToken& Token) { return Token.IsWord() && StartsAsWave(Token.Text); });
	bool bChanged = false;
	for (int Round = 0; bAny && Round < MaxRounds && Errors.empty(); ++Round)
	{
		const FHlslSymbols Symbols(Text);
		if (!FChoiceRewriter(Text, Symbols, Errors).Run())
		{
			break;
		}
		bChanged = true;
	}
	return bChanged;
}

} // namespace Drydock
