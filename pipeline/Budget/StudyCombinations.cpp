// Combines the values of a study's axes into jobs and choices.
#include "Budget/StudyConfig.h"

namespace Drydock
{

namespace
{

/** Every combination of the axes that are (or are not) another job. */
template<typename T>
std::vector<T> Combine(const std::vector<FStudyAxis>& Axes, bool bEach)
{
	std::vector<T> Combinations(1);
	for (const FStudyAxis& Axis : Axes)
	{
		if (Axis.bEach != bEach)
		{
			for (T& Combination : Combinations)
			{
				Combination.Values.emplace_back();
			}
			continue;
		}
		std::vector<T> Longer;
		for (const T& Combination : Combinations)
		{
			for (const FStudyValue& Value : Axis.Values)
			{
				T Next = Combination;
				const bool bNamed = Value.Set.size() == 1 && Value.Set[0].Value == Value.Label;
				// A number alone says nothing.
				const bool bNumber = bNamed && Value.Label.find_first_not_of("0123456789.-+e") == std::string::npos;
				const size_t Begin =
					Axis.Name.starts_with("r.") ? 2 : Axis.Name.rfind('/') + 1; // without a place's path
				const std::string Name = Axis.Name.substr(Begin);
				Next.Label += (Next.Label.empty() ? "" : ", ") + (bNumber ? Name + " " + Value.Label : Value.Label);
				Next.Set.insert(Next.Set.end(), Value.Set.begin(), Value.Set.end());
				Next.Values.push_back(Value.Label);
				Longer.push_back(std::move(Next));
			}
		}
		Combinations = std::move(Longer);
	}
	return Combinations;
}

} // namespace

std::vector<FStudyCase> FStudy::GetCases() const
{
	return Combine<FStudyCase>(Axes, true);
}

std::vector<FStudyChoice> FStudy::GetChoices() const
{
	return Combine<FStudyChoice>(Axes, false);
}

std::string GetAssigned(const std::vector<FStudyAssignment>& Set, const std::string& Name, const std::string& Otherwise)
{
	std::string Value = Otherwise;
	for (const FStudyAssignment& Assignment : Set)
	{
		Value = Assignment.Name == Name ? Assignment.Value : Value;
	}
	return Value;
}

} // namespace Drydock
