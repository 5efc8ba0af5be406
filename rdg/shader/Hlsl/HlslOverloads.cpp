// Chooses among functions of one name by the types of the arguments.
#include "HlslConversions.h"

#include <algorithm>
#include <functional>

namespace Drydock::Hlsl
{

namespace
{

/** The ranks of all arguments; nothing where one does not fit, with the reason. */
std::optional<std::vector<uint32_t>> RankCall(FTypes& Types, const std::vector<FParameterType>& Parameters,
	const std::vector<FArgumentType>& Arguments, std::string& Why)
{
	const size_t Needed = size_t(std::count_if(
		Parameters.begin(), Parameters.end(), [](const FParameterType& Parameter) { return !Parameter.bDefault; }));
	if (Arguments.size() > Parameters.size() || Arguments.size() < Needed)
	{
		const std::string Least = Needed < Parameters.size() ? "from " + std::to_string(Needed) + " to " : "";
		Why = "it takes " + Least + std::to_string(Parameters.size()) +
			  (Parameters.size() == 1 ? " argument, not " : " arguments, not ") + std::to_string(Arguments.size());
		return std::nullopt;
	}
	std::vector<uint32_t> Ranks;
	for (size_t i = 0; i < Arguments.size(); ++i)
	{
		const FParameterType& Parameter = Parameters[i];
		const FConversion In = FindConversion(Types, Arguments[i].Type, Parameter.Type);
		const bool bBase = In.bPossible && Parameter.Type->IsStruct() && Arguments[i].Type->IsStruct();
		const FConversion Out =
			bBase ? In : FindConversion(Types, Parameter.Type, Arguments[i].Type); // a base is copied back
		const std::string Number = "argument " + std::to_string(i + 1);
		if (Parameter.bOut && !Arguments[i].bPlace)
		{
			Why = Number + " is written to (" + (Parameter.bIn ? "inout" : "out") +
				  "): a variable is expected, not a value";
			return std::nullopt;
		}
		if ((Parameter.bIn && !In.bPossible) || (Parameter.bOut && !Out.bPossible))
		{
			const bool bBack = !Parameter.bIn || In.bPossible;
			Why = bBack ? Number + ", " + GetName(Arguments[i].Type) + ", cannot take back " + GetName(Parameter.Type)
						: Number + " is " + GetName(Arguments[i].Type) + ", which does not become " +
							  GetName(Parameter.Type);
			return std::nullopt;
		}
		Ranks.push_back(std::max(Parameter.bIn ? In.Rank : 0, Parameter.bOut ? Out.Rank : 0));
	}
	return Ranks;
}

/** No worse in any argument, and better in one. */
bool IsBetterCall(const std::vector<uint32_t>& A, const std::vector<uint32_t>& B)
{
	bool bBetter = false;
	for (size_t i = 0; i < A.size(); ++i)
	{
		if (A[i] > B[i])
		{
			return false;
		}
		bBetter = bBetter || A[i] < B[i];
	}
	return bBetter;
}

/** The worst conversions first. */
std::vector<uint32_t> SortRanks(std::vector<uint32_t> Ranks)
{
	std::sort(Ranks.begin(), Ranks.end(), std::greater<>());
	return Ranks;
}

} // namespace

FOverloadChoice ChooseOverload(FTypes& Types, const std::vector<std::vector<FParameterType>>& Overloads,
	const std::vector<FArgumentType>& Arguments)
{
	FOverloadChoice Choice;
	std::vector<std::pair<size_t, std::vector<uint32_t>>> Fitting;
	for (size_t i = 0; i < Overloads.size(); ++i)
	{
		std::string Why;
		if (std::optional<std::vector<uint32_t>> Ranks = RankCall(Types, Overloads[i], Arguments, Why))
		{
			Fitting.emplace_back(i, std::move(*Ranks));
		}
		Choice.Why = Overloads.size() == 1 ? Why : "";
	}
	// As many as there are may be compared: the best so far, and then against all.
	const auto FindBest = [&Fitting](auto&& IsBetter) -> std::optional<size_t>
	{
		size_t Best = 0;
		for (size_t i = 1; i < Fitting.size(); ++i)
		{
			Best = IsBetter(Fitting[Best].second, Fitting[i].second) ? Best : i;
		}
		for (size_t i = 0; i < Fitting.size(); ++i)
		{
			if (i != Best && !IsBetter(Fitting[Best].second, Fitting[i].second))
			{
				return std::nullopt;
			}
		}
		return Best;
	};
	if (Fitting.empty())
	{
		return Choice;
	}
	std::optional<size_t> Best = FindBest(IsBetterCall);
	// DXC adds up what the arguments cost, with steps so wide that the worst one decides.
	const auto IsCheaper = [](const std::vector<uint32_t>& A, const std::vector<uint32_t>& B)
	{
		return SortRanks(A) < SortRanks(B);
	};
	Best = Best ? Best : FindBest(IsCheaper);
	if (Best)
	{
		Choice.Best = Fitting[*Best].first;
		return Choice;
	}
	for (const auto& [Index, Ranks] : Fitting)
	{
		const bool bBeaten = std::any_of(Fitting.begin(), Fitting.end(),
			[&IsCheaper, &Ranks = Ranks](const auto& Other) { return IsCheaper(Other.second, Ranks); });
		if (!bBeaten)
		{
			Choice.Ambiguous.push_back(Index);
		}
	}
	return Choice;
}

} // namespace Drydock::Hlsl
