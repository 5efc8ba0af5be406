// Reads and writes lists of engine versions.
#include "Matrix/MatrixVersions.h"

#include "Diagnostics.h"
#include "EngineProfile.h"
#include "Matrix/MatrixErrors.h"
#include "TextTools.h"

#include <set>

namespace Drydock
{

namespace
{

[[noreturn]] void FailVersions(const std::string& Message)
{
	throw FError({.Code = ErrorMatrixVersions, .Message = Message, .Where = "--versions"}, ExitUsage);
}

int ParseVersion(const std::string& Text)
{
	const FEngineProfile* const Known = FindEngineProfile(Text);
	if (Known == nullptr)
	{
		FailVersions(
			"\"" + Text + "\" is not an engine version that drydock knows: these are " + ListEngineVersions(", "));
	}
	return Known->Minor;
}

} // namespace

std::vector<int> ParseMatrixVersions(const std::string& Text)
{
	std::set<int> Minors;
	if (Text.empty())
	{
		for (const FEngineProfile& Row : GetEngineProfiles())
		{
			Minors.insert(Row.Minor);
		}
	}
	for (const std::string& Part : SplitText(Text, ','))
	{
		const size_t Dash = Part.find('-');
		const int First = ParseVersion(Trim(Part.substr(0, Dash)));
		const int Last = Dash == std::string::npos ? First : ParseVersion(Trim(Part.substr(Dash + 1)));
		if (First > Last)
		{
			FailVersions("\"" + Trim(Part) + "\" ends before it begins: the older version comes first");
		}
		for (int Minor = First; Minor <= Last; ++Minor)
		{
			Minors.insert(Minor);
		}
	}
	return {Minors.begin(), Minors.end()};
}

std::string DescribeVersions(const std::vector<int>& Minors)
{
	std::vector<std::string> Parts;
	for (size_t First = 0; First < Minors.size();)
	{
		size_t Last = First;
		while (Last + 1 < Minors.size() && Minors[Last + 1] == Minors[Last] + 1)
		{
			++Last;
		}
		if (Last - First >= 2)
		{
			Parts.push_back(DescribeVersion(Minors[First]) + " to " + DescribeVersion(Minors[Last]));
		}
		for (size_t Index = First; Last - First < 2 && Index <= Last; ++Index)
		{
			Parts.push_back(DescribeVersion(Minors[Index]));
		}
		First = Last + 1;
	}
	return JoinWords(Parts);
}

std::string DescribeVersion(int Minor)
{
	return FEngineProfile{.Minor = Minor}.GetVersion();
}

} // namespace Drydock
