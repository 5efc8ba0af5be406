// Calls and operands that the front end lacks or folds wrongly.
#include "HlslRewrites.h"

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <functional>
#include <map>

namespace Drydock
{

namespace
{

/** A one that the front end does not know to be one, so that it leaves the folding to those who do it right. */
const char* const One = "DrydockOne";

class FExpressionRewriter
{
public:
	FExpressionRewriter(FHlslText& InText, const FHlslSymbols& InSymbols, std::vector<FDiagnostic>& OutErrors)
		: Text(InText)
		, Symbols(InSymbols)
		, Errors(OutErrors)
	{
	}

	bool Run()
	{
		std::vector<size_t> Open; // brackets around
		for (size_t At = 0; At < Text.Size(); ++At)
		{
			if (Text.Is(At, "(") || Text.Is(At, "[") || Text.Is(At, "{"))
			{
				RewriteList(At, Open.empty() ? Text.Size() : Open.back());
				Open.push_back(At);
			}
			else if ((Text.Is(At, ")") || Text.Is(At, "]") || Text.Is(At, "}")) && !Open.empty())
			{
				Open.pop_back();
			}
			else if (Text.Is(At, "/"))
			{
				RewriteDivision(At);
			}
			else if (Text.IsWord(At) && At > 1 && Text.Is(At - 1, "."))
			{
				RewriteSwizzle(At);
			}
			else if (Text.IsWord(At) && Text.Is(At + 1, "(") && !Symbols.FindFunctions(Text[At].Text))
			{
				RewriteCall(At);
			}
		}
		if (bNeedsOne)
		{
			Edits.Insert(0, std::string("static int ") + One + " = 1;");
		}
		const bool bChanged = !Edits.IsEmpty();
		Edits.Apply(Text);
		return bChanged;
	}

private:
	void Error(size_t At, const std::string& Message) { Errors.push_back(Text.MakeError(At, Message)); }

	/** The commas of a call whose parenthesis opens at Open, between that and the closing one. */
	std::vector<size_t> FindSeparators(size_t Open) const
	{
		std::vector<size_t> Result = {Open};
		const size_t Close = Text.FindClose(Open);
		for (size_t At = Open + 1; At < Close; ++At)
		{
			if (Text.Is(At, ","))
			{
				Result.push_back(At);
			}
			At = std::max(At, Text.FindClose(At));
		}
		Result.push_back(Close);
		return Result;
	}

	void RewriteCall(size_t At)
	{
		using FRewrite = void (FExpressionRewriter::*)(size_t, const std::vector<size_t>&);
		static const std::map<std::string, FRewrite> Rewrites = {{"select", &FExpressionRewriter::RewriteSelect},
			{"and", &FExpressionRewriter::RewriteLogic}, {"or", &FExpressionRewriter::RewriteLogic},
			{"abs", &FExpressionRewriter::RewriteUnsigned}, {"sign", &FExpressionRewriter::RewriteUnsigned},
			{"dot", &FExpressionRewriter::KeepUnfolded}, {"atan2", &FExpressionRewriter::KeepUnfolded},
			{"asfloat", &FExpressionRewriter::KeepUnfolded}, {"sqrt", &FExpressionRewriter::KeepUnfolded},
			{"log", &FExpressionRewriter::KeepUnfolded}, {"log2", &FExpressionRewriter::KeepUnfolded},
			{"step", &FExpressionRewriter::KeepUnfolded}, {"pow", &FExpressionRewriter::KeepUnfolded},
			{"any", &FExpressionRewriter::KeepUnfolded}, {"all", &FExpressionRewriter::KeepUnfolded},
			{"mad", &FExpressionRewriter::RewriteMad}};
		const auto Rewrite = Rewrites.find(Text[At].Text);
		if (Rewrite != Rewrites.end() && Text.FindClose(At + 1) < Text.Size())
		{
			(this->*Rewrite->second)(At, FindSeparators(At + 1));
		}
	}

	/** select(C, A, B) -> ((C) ? (A) : (B)), which the front end takes by component and without a branch. */
	void RewriteSelect(size_t At, const std::vector<size_t>& Separators)
	{
		if (Separators.size() != 4)
		{
			return;
		}
		// The front end does not convert numbers of 16 and 64 bits to conditions by itself.
		const std::optional<FHlslNumeric> Type = ParseHlslNumeric(Symbols.GetType(At + 2, Separators[1]));
		const bool bConverts = Type && !Type->IsMatrix() &&
							   (Type->Scalar.find("16_t") != std::string::npos ||
								   Type->Scalar.find("64_t") != std::string::npos || Type->Scalar == "double");
		const std::string Bools = bConverts ? FHlslNumeric{"bool", 0, Type->Columns}.GetName() : std::string();
		Edits.Replace(At, At + 2, "((" + Bools + (bConverts ? "(" : ""));
		Edits.Replace(Separators[1], Separators[1] + 1, bConverts ? ")) ? (" : ") ? (");
		Edits.Replace(Separators[2], Separators[2] + 1, ") : (");
		Edits.Replace(Separators[3], Separators[3] + 1, "))");
	}

	void RewriteLogic(size_t At, const std::vector<size_t>& Separators)
	{
		if (Separators.size() != 3)
		{
			return;
		}
		Edits.Replace(At, At + 2, "((");
		Edits.Replace(Separators[1], Separators[1] + 1, Text.Is(At, "and") ? ") && (" : ") || (");
		Edits.Replace(Separators[2], Separators[2] + 1, "))");
	}

	/** abs(U) -> (U), sign(U) -> int(min(U, 1u)). */
	void RewriteUnsigned(size_t At, const std::vector<size_t>& Separators)
	{
		const std::optional<FHlslNumeric> Type = ParseHlslNumeric(Symbols.GetType(At + 2, Separators.back()));
		if (!Type || Type->Scalar != "uint" || Separators.size() != 2)
		{
			return;
		}
		if (Text.Is(At, "abs"))
		{
			Edits.Replace(At, At + 1, "");
			return;
		}
		FHlslNumeric Signed = *Type;
		Signed.Scalar = "int";
		Edits.Replace(At, At + 1, "((" + Signed.GetName() + ")min");
		Edits.Replace(Separators[1], Separators[1] + 1, ", 1u))");
	}

	/** mad(A, B, C) of integers -> ((A) * (B) + (C)): SPIR-V has it for floats only. */
	void RewriteMad(size_t At, const std::vector<size_t>& Separators)
	{
		const std::optional<FHlslNumeric> Type = ParseHlslNumeric(Symbols.GetType(At, Separators.back() + 1));
		if (!Type || !Type->IsInteger() || Separators.size() != 4)
		{
			return;
		}
		Edits.Replace(At, At + 2, "((");
		Edits.Replace(Separators[1], Separators[1] + 1, ") * (");
		Edits.Replace(Separators[2], Separators[2] + 1, ") + (");
		Edits.Replace(Separators[3], Separators[3] + 1, "))");
	}

	bool IsConstant(size_t First, size_t End) const
	{
		for (size_t At = First; At < End; ++At)
		{
			const FHlslVariable* Variable = Text.IsWord(At) ? Symbols.FindVariable(Text[At].Text, At) : nullptr;
			const bool bType = Text.IsWord(At) && !Variable && ParseHlslNumeric(Text[At].Text);
			const bool bSwizzle = At > First && Text.Is(At - 1, ".");
			if (Text.IsWord(At) && !bType && !bSwizzle && !(Variable && Variable->bConstant))
			{
				return false;
			}
		}
		return First < End;
	}

	/** dot of integers, functions of two matrices, any and all, and what gives a constant that is not a number. */
	void KeepUnfolded(size_t At, const std::vector<size_t>& Separators)
	{
		const std::string Type = Symbols.GetType(At + 2, Separators[1]);
		const std::optional<FHlslNumeric> Numeric = ParseHlslNumeric(Type);
		const bool bNegative = Text.Is(At + 2, "-");
		const bool bAlways = Text.Is(At, "asfloat") || Text.Is(At, "any") || Text.Is(At, "all");
		const bool bIntegers = Text.Is(At, "dot") && Numeric && Numeric->IsInteger();
		const bool bWrong = bAlways || bIntegers || bNegative || (Numeric && Numeric->IsMatrix());
		if (bWrong && IsConstant(At + 2, Separators.back()))
		{
			MultiplyByOne(At + 2, Separators[1]);
		}
	}

	void MultiplyByOne(size_t First, size_t End)
	{
		Edits.Insert(First, std::string("(") + One + " * (");
		Edits.Insert(End, "))");
		bNeedsOne = true;
	}

	/** 0.0 / 0.0, of which the front end thinks that it equals everything. */
	void RewriteDivision(size_t At)
	{
		const auto IsZero = [this](size_t Number)
		{
			const bool bNumber = Number < Text.Size() && Text[Number].Kind == EShaderToken::Number;
			const std::string Digits = bNumber ? Text[Number].Text : "1";
			return Digits.find_first_not_of("0.fFhH") == std::string::npos && Digits.find('.') != std::string::npos;
		};
		if (At > 0 && IsZero(At + 1) && Text[At - 1].Kind == EShaderToken::Number)
		{
			MultiplyByOne(At + 1, At + 2);
		}
	}

	/** M._m00_m11 -> float2(M._m00, M._m11) */
	void RewriteSwizzle(size_t At)
	{
		const std::vector<std::string> Elements = SplitMatrixSwizzle(Text[At].Text);
		if (Elements.empty())
		{
			return;
		}
		const size_t First = Symbols.FindChainStart(At - 2);
		const std::optional<FHlslNumeric> Type = ParseHlslNumeric(Symbols.GetType(First, At - 1));
		const std::string Matrix = Text.GetText(First, At - 1);
		const bool bChanges = Matrix.find("++") != std::string::npos || Matrix.find("--") != std::string::npos;
		if (!Type || bChanges || First < Edits.GetEnd())
		{
			Error(At, "several elements of a matrix (" + Text[At].Text +
						  ") can only be taken of a variable whose type is seen here: take them one by one");
			return;
		}
		if (!Type->IsMatrix())
		{
			return;
		}
		std::string Words = Type->Scalar + std::to_string(Elements.size()) + "(";
		for (size_t i = 0; i < Elements.size(); ++i)
		{
			Words += (i ? ", " : "") + Matrix + "." + Elements[i];
		}
		Edits.Replace(First, At + 1, Words + ")");
	}

	/** F({A, B}) -> F(float2(A, B)) where F's parameter is a vector. */
	void RewriteList(size_t At, size_t Outer)
	{
		const bool bArgument = Text.Is(At, "{") && Outer < Text.Size() && Text.Is(Outer, "(") && Outer > 0 &&
							   Text.IsWord(Outer - 1) && (Text.Is(At - 1, "(") || Text.Is(At - 1, ","));
		const size_t Close = Text.FindClose(At);
		if (!bArgument || Close >= Text.Size())
		{
			return;
		}
		const std::string& Name = Text[Outer - 1].Text;
		const std::vector<size_t> Separators = FindSeparators(Outer);
		const size_t Index = size_t(std::find(Separators.begin(), Separators.end(), At - 1) - Separators.begin());
		std::string Type;
		bool bArray = false;
		if (const std::vector<FHlslFunction>* Functions = Symbols.FindFunctions(Name))
		{
			for (const FHlslFunction& Function : *Functions)
			{
				const bool bFits = Index < Function.Parameters.size() &&
								   Function.Parameters.size() + 1 >= Separators.size() && !bArray;
				const std::string Found = bFits ? Function.Parameters[Index].Type : std::string();
				bArray = bArray || (bFits && Function.Parameters[Index].bArray) ||
						 (!Type.empty() && !Found.empty() && Type != Found); // overloads differ
				Type = Found.empty() ? Type : Found;
			}
		}
		const bool bNested = std::any_of(Text.Tokens.begin() + std::ptrdiff_t(At) + 1,
			Text.Tokens.begin() + std::ptrdiff_t(Close), [](const FHlslToken& Token) { return Token.Is("{"); });
		const std::optional<FHlslNumeric> Numeric = ParseHlslNumeric(Type);
		if (!Numeric || bArray || bNested)
		{
			Error(At, "an initializer list as an argument of '" + Name + "': declare a variable" +
						  (Type.empty() || bArray ? std::string() : " of type " + Type) + ", and pass that");
			return;
		}
		Edits.Replace(At, At + 1, Numeric->GetName() + "(");
		Edits.Replace(Close, Close + 1, ")");
	}

	FHlslText& Text;
	const FHlslSymbols& Symbols;
	std::vector<FDiagnostic>& Errors;
	FHlslEdits Edits;
	bool bNeedsOne = false;
};

} // namespace

bool RewriteExpressions(FHlslText& Text, const FHlslSymbols& Symbols, std::vector<FDiagnostic>& Errors)
{
	return FExpressionRewriter(Text, Symbols, Errors).Run();
}

} // namespace Drydock
