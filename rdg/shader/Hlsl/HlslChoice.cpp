// Which function of a name a call means: prototypes with their definitions, templates, and the message where none
// fits.
#include "HlslAnalysisImpl.h"

#include <algorithm>

namespace Drydock::Hlsl
{

namespace
{

constexpr size_t MaxListedCandidates = 4;

bool IsFunctionTemplate(const FOverload& Overload)
{
	return Overload.Declaration->bTemplate && !Overload.Declaration->Template.empty() && !Overload.Template &&
		   !Overload.bOutside;
}

/** min10float and min16float, which are one type here. */
bool IsOtherWidth(const FDeclaration& A, const FDeclaration& B)
{
	for (size_t i = 0; i < A.Parameters.size() && i < B.Parameters.size(); ++i)
	{
		const FName& First = A.Parameters[i]->Type->Name;
		const FName& Second = B.Parameters[i]->Type->Name;
		const bool bNamed = !First.Parts.empty() && !Second.Parts.empty();
		const bool bSmall = bNamed && (First.Last().starts_with("min") || Second.Last().starts_with("min"));
		if (bSmall && First.Last() != Second.Last())
		{
			return true;
		}
	}
	return false;
}

} // namespace

/** Its parameters and result. */
bool FAnalyser::Sign(FOverload& Overload, bool bReport)
{
	if (Overload.bSigned || !bReport)
	{
		return Overload.bSigned && !Overload.bBad;
	}
	Overload.bSigned = true;
	FPosition Position;
	Position.Scope = Overload.Scope;
	Position.Order = std::max(Overload.BodyOrder, Overload.Struct ? Overload.Struct->Order : 0u);
	const FPositionGuard Guard(*this, Position);
	const FDeclaration& Declaration = *Overload.Declaration;
	Overload.Result =
		AddDimensions(FindType(*Declaration.Type, Declaration.Modifiers), Declaration.Dimensions, Declaration.Place);
	Overload.bBad = Overload.Result->Kind == EType::Error || !IsUsable(Overload.Result, Declaration.Place);
	for (const FDeclaration* Each : Declaration.Parameters)
	{
		FParameterType Parameter;
		Parameter.Type = FindDeclaredType(*Each, true);
		Parameter.bOut = (Each->Modifiers & ModifierOut) != 0;
		Parameter.bIn = !Parameter.bOut || (Each->Modifiers & ModifierIn) != 0;
		Parameter.bDefault = Each->Value != nullptr;
		Overload.bBad = Overload.bBad || Parameter.Type->Kind == EType::Error;
		Overload.Parameters.push_back(Parameter);
		Overload.Declared.push_back(Each);
		Overload.Defaults.push_back(Each->Value ? Each : nullptr);
	}
	return !Overload.bBad;
}

/** Signs all overloads, and makes one of a prototype and its definition. */
void FAnalyser::PrepareOverloads(FSymbol& Symbol)
{
	if (Symbol.bPrepared)
	{
		return;
	}
	Symbol.bPrepared = true;
	const auto IsEqual = [](const FParameterType& A, const FParameterType& B)
	{
		return IsSame(A.Type, B.Type) && A.bIn == B.bIn && A.bOut == B.bOut;
	};
	std::vector<FOverload*>& All = Symbol.Overloads;
	for (size_t i = 0; i < All.size(); ++i)
	{
		const bool bTemplate = IsFunctionTemplate(*All[i]);
		if (!bTemplate)
		{
			Sign(*All[i]);
		}
		for (size_t j = 0; j < i && !All[i]->bBad; ++j)
		{
			FOverload& Old = *All[j];
			const FDeclaration& A = *Old.Declaration;
			const FDeclaration& B = *All[i]->Declaration;
			if (Old.bMerged || Old.bBad || IsFunctionTemplate(Old) != bTemplate)
			{
				continue;
			}
			const bool bSame = bTemplate ? A.Template.size() == B.Template.size() &&
											   A.Parameters.size() == B.Parameters.size() && (!A.Body || !B.Body)
										 : std::ranges::equal(Old.Parameters, All[i]->Parameters, IsEqual);
			if (!bSame)
			{
				continue;
			}
			if (A.Body && B.Body && !IsOtherWidth(A, B))
			{
				Error(B.Place, "X3003: redefinition of '" + Describe(*All[i], Symbol.Name) + "', which line " +
								   std::to_string(A.Place.Line) + " defines");
			}
			FOverload& Kept = B.Body ? *All[i] : Old;
			FOverload& Merged = B.Body ? Old : *All[i];
			Merged.bMerged = true;
			Kept.Order = std::min(Kept.Order, Merged.Order);
			for (size_t p = 0; p < Kept.Defaults.size() && p < Merged.Defaults.size(); ++p)
			{
				if (Kept.Defaults[p] && Merged.Defaults[p])
				{
					Error(Kept.Defaults[p]->Place, "X3003: '" + std::string(Kept.Defaults[p]->Name.Last()) +
													   "' has its default value already, in line " +
													   std::to_string(Merged.Defaults[p]->Place.Line));
				}
				Kept.Defaults[p] = Kept.Defaults[p] ? Kept.Defaults[p] : Merged.Defaults[p];
				Kept.Parameters[p].bDefault = Kept.Defaults[p] != nullptr;
			}
			break;
		}
	}
}

/** "float F(float3, inout int)". */
std::string FAnalyser::Describe(const FOverload& Overload, std::string_view Name) const
{
	std::string Text =
		(Overload.Result ? GetName(Overload.Result) + " " : "") + std::string(Name) + Overload.Arguments + "(";
	for (size_t i = 0; i < Overload.Parameters.size(); ++i)
	{
		const FParameterType& Each = Overload.Parameters[i];
		Text += (i ? ", " : "") + std::string(Each.bOut ? (Each.bIn ? "inout " : "out ") : "") + GetName(Each.Type);
	}
	return Text + ")";
}

std::vector<FOverload*> FAnalyser::ListCandidates(
	FSymbol& Symbol, const FNamePart& Part, const std::vector<const FType*>& Arguments, std::vector<std::string>& Why)
{
	std::vector<FOverload*> Candidates;
	for (FOverload* Overload : Symbol.Overloads)
	{
		if (Overload->bMerged || Overload->Order > Here.Order)
		{
			continue;
		}
		if (!IsFunctionTemplate(*Overload))
		{
			if (!Part.bArguments)
			{
				Candidates.push_back(Overload);
			}
			continue;
		}
		std::string Reason;
		FOverload* const Instance = InstantiateFunction(Symbol, *Overload, Part, Arguments, Reason);
		if (Instance)
		{
			Sign(*Instance);
			Candidates.push_back(Instance);
		}
		else
		{
			Why.push_back("template in line " + std::to_string(Overload->Declaration->Place.Line) + ": " + Reason);
		}
	}
	return Candidates;
}

/** A ConstantBuffer is also what is in it. */
FOverload* FAnalyser::ChooseOpened(FSymbol& Symbol, const FNamePart& Part, FArguments& Arguments, std::string& Why)
{
	FOverload* const Overload = Choose(Symbol, Part, Arguments, Why);
	if (Overload || Why.empty())
	{
		return Overload;
	}
	FArguments Opened = Arguments;
	for (FValue*& Each : Opened.Values)
	{
		Each = Each ? OpenConstantBuffer(Each) : nullptr;
	}
	std::string Ignored;
	FOverload* const Second = Opened.Values == Arguments.Values ? nullptr : Choose(Symbol, Part, Opened, Ignored);
	Arguments = Second ? Opened : Arguments;
	return Second;
}

/** Null: none, or several, and Why; an empty Why: it was reported. */
FOverload* FAnalyser::Choose(FSymbol& Symbol, const FNamePart& Part, const FArguments& Arguments, std::string& Why)
{
	PrepareOverloads(Symbol);
	std::vector<const FType*> Given;
	std::vector<FArgumentType> Passed;
	std::string Call = std::string(Symbol.Name) + "(";
	for (const FValue* Each : Arguments.Values)
	{
		Given.push_back(Each ? Each->Type : Types->Error());
		Passed.push_back({Given.back(), Each && Each->bPlace && !Each->bConst});
		Call += (Call.back() == '(' ? "" : ", ") + (Each ? GetName(Each->Type) : "{...}");
	}
	Call += ")";
	const bool bWasFailed = bFailed;
	std::vector<std::string> Reasons;
	const std::vector<FOverload*> Candidates = ListCandidates(Symbol, Part, Given, Reasons);
	std::vector<std::vector<FParameterType>> Overloaded;
	for (const FOverload* Each : Candidates)
	{
		if (Each->bBad)
		{
			return nullptr; // reported with its declaration
		}
		Overloaded.push_back(Each->Parameters);
	}
	const FOverloadChoice Choice = ChooseOverload(*Types, Overloaded, Passed);
	if (Choice.Best && Choice.Ambiguous.empty())
	{
		return Candidates[*Choice.Best];
	}
	for (FArgumentType& Each : Passed)
	{
		Each.bPlace = true;
	}
	const FOverloadChoice Unplaced = Choice.Ambiguous.empty() ? ChooseOverload(*Types, Overloaded, Passed) : Choice;
	if (Unplaced.Best && Unplaced.Ambiguous.empty())
	{
		return Candidates[*Unplaced.Best]; // the argument has a message of its own
	}
	if (FOverload* const Special = ChooseMoreSpecial(Candidates, Choice.Ambiguous))
	{
		return Special;
	}
	if (Candidates.empty() && bFailed && !bWasFailed)
	{
		return nullptr;
	}
	std::string List;
	const bool bAmbiguous = !Choice.Ambiguous.empty();
	const size_t Count = bAmbiguous ? Choice.Ambiguous.size() : Candidates.size();
	for (size_t i = 0; i < Count && i < MaxListedCandidates; ++i)
	{
		const FOverload& Each = *Candidates[bAmbiguous ? Choice.Ambiguous[i] : i];
		List += (List.empty() ? "" : "; ") + Describe(Each, Symbol.Name) + " (line " +
				std::to_string(Each.Declaration->Place.Line) + ")";
	}
	List += Count > MaxListedCandidates ? "; ..." : "";
	for (const std::string& Reason : Reasons)
	{
		List += (List.empty() ? "" : "; ") + Reason;
	}
	Why = bAmbiguous ? "X3067: ambiguous call of " + Call + "; cast the argument to one of: " + List
					 : "X3013: no matching function " + Call +
						   (Candidates.size() == 1 && !Choice.Why.empty() ? ": " + Choice.Why : "") + "; there is " +
						   (List.empty() ? "none for it" : List);
	return nullptr;
}

/** Chooses among equally good ones: a function that is not a template, then the template with the narrower parameters.
 */
FOverload* FAnalyser::ChooseMoreSpecial(const std::vector<FOverload*>& Candidates, const std::vector<size_t>& Equal)
{
	const auto Rank = [&](size_t Index) // the fewer the more special
	{
		const FOverload& Overload = *Candidates[Index];
		size_t NumBare = 0;
		for (const FDeclaration* Each :
			Overload.Template ? Overload.Template->Declaration->Parameters : std::vector<FDeclaration*>())
		{
			const FName& Name = Each->Type->Name;
			const bool bBare = Name.Parts.size() == 1 && !Name.Parts[0].bArguments && Each->Dimensions.empty();
			const auto& Parameters = Overload.Template->Declaration->Template;
			NumBare += bBare && std::ranges::any_of(
									Parameters, [&](const FTemplateParameter& P) { return P.Name == Name.Last(); })
						   ? 1
						   : 0;
		}
		return Overload.Template ? 1 + NumBare : 0;
	};
	size_t Least = SIZE_MAX;
	FOverload* Best = nullptr;
	for (const size_t Index : Equal)
	{
		const size_t Own = Rank(Index);
		Best = Own < Least ? Candidates[Index] : Own == Least ? nullptr : Best;
		Least = std::min(Least, Own);
	}
	return Best;
}

} // namespace Drydock::Hlsl
