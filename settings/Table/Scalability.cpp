// The presets of sg.PostProcessQuality. Source: engine Scalability.cpp (a group's variable sets the others),
// BaseScalability (values, as documented).
#include "Scalability.h"

#include "HAL/IConsoleManager.h"
#include "RangeTools.h"
#include "TextTools.h"

#include <algorithm>

namespace Drydock
{

namespace
{

constexpr const char* ScalabilityText =
#include "Scalability.txt"
	;

/** Runs when sg.PostProcessQuality was set; not when it is put back to "nobody has set it". */
void OnPostProcessQualityChanged(IConsoleVariable* Variable)
{
	if ((Variable->GetFlags() & ECVF_SetByMask) != ECVF_SetByConstructor)
	{
		ApplyPostProcessQuality(Variable->GetInt());
	}
}

TAutoConsoleVariable<int32> CVarPostProcessQuality(TEXT("sg.PostProcessQuality"), 3,
	TEXT("Sets the console variables of post processing together, as scalability does: who sets one of them by\n"
		 "config, command line or console beats it.\n")
		TEXT("0: low. 1: medium. 2: high. 3: epic. 4: cinematic. Until it is set, every variable has its own default."),
	FConsoleVariableDelegate::CreateStatic(&OnPostProcessQualityChanged), ECVF_ScalabilityGroup);

} // namespace

const std::vector<FScalabilityRow>& GetPostProcessQualityRows()
{
	static const std::vector<std::vector<std::string>> Cells = SplitRows(ScalabilityText);
	static const std::vector<FScalabilityRow> Rows = ToVector<FScalabilityRow>(Cells,
		[](const std::vector<std::string>& Columns)
		{
			FScalabilityRow Row{Columns[0].c_str(), {}};
			for (size_t Level = 0; Level < Row.Values.size(); ++Level)
			{
				const std::string& Value = Columns[Level + 1];
				Row.Values[Level] = Value == "-" ? nullptr : Value.c_str();
			}
			return Row;
		});
	return Rows;
}

void ApplyPostProcessQuality(int32 Level)
{
	const size_t Index = static_cast<size_t>(std::clamp(Level, 0, NumScalabilityLevels - 1));
	for (const FScalabilityRow& Row : GetPostProcessQualityRows())
	{
		IConsoleVariable* Variable = IConsoleManager::Get().FindConsoleVariable(Row.Variable);
		if (Variable != nullptr && Row.Values[Index] != nullptr)
		{
			Variable->Set(Row.Values[Index], ECVF_SetByScalability);
		}
	}
}

} // namespace Drydock
