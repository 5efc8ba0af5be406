// `drydock settings plan`. Source: drydock.
#include "NewSettingSheet.h"
#include "Program/Verbs.h"
#include "Text/ConfigErrors.h"
#include "Text/JsonWriter.h"

#include <cstdio>

namespace Drydock
{

namespace
{

[[noreturn]] void Refuse(const std::string& Message)
{
	FDiagnostic Diagnostic;
	Diagnostic.Code = ErrorBadArgument;
	Diagnostic.Message = Message;
	throw FError(Diagnostic, ExitUsage);
}

/** From the table, or from the arguments where the table does not have it. */
FNewSetting FindSetting(const FSettingsPlanOptions& Options)
{
	if (const FSettingField* Field = FindSettingField(Options.Name))
	{
		return DescribeNewSetting(*Field);
	}
	if (Options.Type.empty())
	{
		const std::string Nearest = FindNearestName(Options.Name, GetSettingNames());
		Refuse("there is no setting " + Options.Name + (Nearest.empty() ? "" : "; did you mean " + Nearest + "?") +
			   " For a new one give its type, such as --type float --default 0");
	}
	std::string Error;
	std::optional<FNewSetting> Setting = MakeNewSetting(Options.Name, Options.Type, Options.Default, Error);
	if (!Setting)
	{
		Refuse(Error);
	}
	Setting->Category = Options.Category.empty() ? Setting->Category : Options.Category;
	Setting->Doc = Options.Doc.empty() ? Setting->Doc : Options.Doc;
	return *Setting;
}

std::string MakePlanJson(const std::vector<FSettingPlace>& Places)
{
	FJsonWriter Writer;
	Writer.BeginArray();
	for (const FSettingPlace& Place : Places)
	{
		Writer.BeginObject();
		Writer.Member("file", Place.File);
		Writer.Member("where", Place.Where);
		Writer.Member("text", Place.Text);
		Writer.Member("why", Place.Why);
		Writer.EndObject();
	}
	Writer.EndArray();
	return Writer.GetText();
}

} // namespace

int SettingsPlanVerb(const FSettingsPlanOptions& Options)
{
	const FNewSetting Setting = FindSetting(Options);
	const std::string Text = Options.bJson ? MakePlanJson(MakeSettingPlan(Setting)) : FormatSettingPlan(Setting);
	std::fputs(Text.c_str(), stdout);
	return ExitDone;
}

} // namespace Drydock
