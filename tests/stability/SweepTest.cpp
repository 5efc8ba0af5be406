// Every setting and every console variable, with values from far outside of what they are for: each run ends with a
// finite picture or with a message, in little time and memory. A sample of the cases runs with all tests;
// DRYDOCK_SWEEP=all runs the whole of it (the nightly set), DRYDOCK_SWEEP=TEXT the cases whose name holds the text.
#include <gtest/gtest.h>

#include "SweepScene.h"

#include "HAL/ConsoleVariableTools.h"
#include "PostProcessSettingsReflection.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>

#include <sys/resource.h>

using namespace Drydock;

namespace Stability
{

namespace
{

struct FSweepCase
{
	ESweepFrame Frame;
	bool bVariable;
	std::string Assignment; // "BloomIntensity=1e+38"

	std::string GetName() const { return std::string(Stability::ToString(Frame)) + ": " + Assignment; }
};

const char* const Numbers[] = {"0", "-1", "1", "1e9", "-1e9", "1e20", "1e38", "-1e38", "1e-40", "NaN", "inf", "-inf"};
const char* const WholeNumbers[] = {
	"0", "-1", "1", "1000000000", "-1000000000", "2147483647", "-2147483648", "1e20", "1e-40", "NaN", "inf"};

/** As text; the bounds of its range among them. */
std::vector<std::string> GetValues(const FSettingField& Field)
{
	std::vector<std::string> Values;
	const bool bWhole = Field.Type == ESettingType::Int || Field.Type == ESettingType::Enum;
	const auto Add = [&](const std::string& Number)
	{
		std::string Text = Number;
		for (int32 Component = 1; Component < Field.GetNumComponents(); ++Component)
		{
			Text += ", " + Number;
		}
		Text = Field.GetNumComponents() > 1 ? "[" + Text + "]" : Text;
		if (std::find(Values.begin(), Values.end(), Text) == Values.end())
		{
			Values.push_back(Text);
		}
	};
	for (const char* Number : bWhole ? std::vector<const char*>(std::begin(WholeNumbers), std::end(WholeNumbers))
									 : std::vector<const char*>(std::begin(Numbers), std::end(Numbers)))
	{
		Add(Number);
	}
	for (const double Bound : {Field.Range.ClampMin, Field.Range.ClampMax, Field.Range.UIMin, Field.Range.UIMax})
	{
		if (std::isfinite(Bound))
		{
			Add(std::to_string(Bound));
		}
	}
	for (int32 Index = 0; Index < Field.EnumNames.Num(); ++Index)
	{
		Values.push_back(Field.EnumNames[Index]);
	}
	return Values;
}

/** A run whose shaders may take no time ends this very process, as it should: KernelWatchTest. */
bool MayRun(const FString& Variable)
{
	return Variable != "r.Drydock.ShaderSeconds";
}

std::vector<FSweepCase> MakeCases()
{
	std::vector<FSweepCase> Cases;
	for (const ESweepFrame Frame : {ESweepFrame::Corrected, ESweepFrame::Printed, ESweepFrame::Manual})
	{
		for (const FSettingField& Field : GetSettingFields())
		{
			for (const std::string& Value : GetValues(Field))
			{
				Cases.push_back({Frame, false, std::string(Field.Name) + "=" + Value});
			}
		}
		for (const FConsoleVariableInfo& Variable : ListConsoleVariables())
		{
			const bool bWhole = Variable.Type == "int32";
			for (const char* Value : bWhole ? std::vector<const char*>(std::begin(WholeNumbers), std::end(WholeNumbers))
											: std::vector<const char*>(std::begin(Numbers), std::end(Numbers)))
			{
				if (MayRun(Variable.Name) && Frame != ESweepFrame::Manual)
				{
					Cases.push_back({Frame, true, std::string(*Variable.Name) + "=" + Value});
				}
			}
		}
	}
	return Cases;
}

/** By DRYDOCK_SWEEP; without it one case in so many, chosen by the name, so that they stay the same ones. */
bool IsChosen(const FSweepCase& Case)
{
	constexpr uint64_t OneIn = 50;
	const char* const Wanted = std::getenv("DRYDOCK_SWEEP");
	if (Wanted == nullptr)
	{
		uint64_t Hash = 0xCBF29CE484222325u; // FNV-1a
		for (const char Letter : Case.GetName())
		{
			Hash = (Hash ^ static_cast<unsigned char>(Letter)) * 0x100000001B3u;
		}
		return (Hash >> 32) % OneIn == 0;
	}
	return std::string(Wanted) == "all" || Case.GetName().find(Wanted) != std::string::npos;
}

bool IsFinite(const FImage& Image)
{
	for (const double Value : Image.Values)
	{
		if (!std::isfinite(Value))
		{
			return false;
		}
	}
	return true;
}

/** Empty where the case ends as it should. */
std::string FindFault(const FSweepScene& Scene, const FSweepCase& Case, bool& bOutRefused)
{
	const std::vector<std::string> Assignments = {Case.Assignment};
	try
	{
		const FRunResult Result =
			Case.bVariable ? Scene.Run(Case.Frame, {}, Assignments) : Scene.Run(Case.Frame, Assignments);
		bOutRefused = false;
		// The linear one is infinite where a half does not hold what was asked for.
		return IsFinite(Result.Final.ToImage()) ? "" : "the final picture is not finite";
	}
	catch (const FError& Error)
	{
		bOutRefused = true;
		return Error.GetExitCode() != ExitUsage ? "ends with exit code " + std::to_string(Error.GetExitCode())
			   : Error.GetDiagnostics().empty() ? "ends without a message"
												: "";
	}
	catch (const std::exception& Exception)
	{
		return std::string("throws ") + Exception.what();
	}
}

double GetProcessSeconds()
{
	return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

long GetPeakMegabytes()
{
	rusage Usage{};
	getrusage(RUSAGE_SELF, &Usage);
	return Usage.ru_maxrss / 1024;
}

} // namespace

TEST(Sweep, EverySettingAndConsoleVariableEndsWell)
{
	constexpr double MostSeconds = 20.0; // of this process: what compiles shaders is another one
	constexpr long MostMegabytes = 4096;
	const bool bTell = std::getenv("DRYDOCK_SWEEP") != nullptr;
	const FSweepScene Scene;
	const double Begin = GetProcessSeconds();
	int NumRun = 0, NumRefused = 0;
	for (const FSweepCase& Case : MakeCases())
	{
		if (!IsChosen(Case))
		{
			continue;
		}
		if (bTell)
		{
			std::fprintf(stderr, "sweep %s\n", Case.GetName().c_str());
		}
		const double CaseBegin = GetProcessSeconds();
		bool bRefused = false;
		EXPECT_EQ("", FindFault(Scene, Case, bRefused)) << Case.GetName();
		EXPECT_GT(MostSeconds, GetProcessSeconds() - CaseBegin) << Case.GetName();
		++NumRun;
		NumRefused += bRefused ? 1 : 0;
	}
	EXPECT_LT(GetPeakMegabytes(), MostMegabytes);
	std::printf("sweep: %d cases, %d of them refused with a message, %.1f s, %ld MB\n", NumRun, NumRefused,
		GetProcessSeconds() - Begin, GetPeakMegabytes());
}

} // namespace Stability
