// Turns assignments of a study into options of a run, and hashes what was studied.
#include "Budget/StudyRequest.h"

#include "Config/ConfigPlaces.h"
#include "ContentHash.h"
#include "PostProcessSettingsReflection.h"
#include "Text/Json.h"
#include "Text/TextFile.h"

namespace Drydock
{

namespace
{

/** Keys and values without blanks and comments. */
void AddToHash(const FJsonValue& Value, FContentHash& Hash)
{
	Hash.Add(Value.Describe());
	Hash.Add(Value.String);
	Hash.Add(Value.Bool ? "1" : "0");
	Hash.AddBytes(&Value.Number, sizeof(Value.Number));
	Hash.Add(std::to_string(Value.Elements.size()));
	for (const FJsonValue& Element : Value.Elements)
	{
		AddToHash(Element, Hash);
	}
	for (const FJsonMember& Member : Value.Members)
	{
		Hash.Add(Member.Key);
		AddToHash(Member.Value, Hash);
	}
}

} // namespace

void ApplyToRun(const std::vector<FStudyAssignment>& Set, FRunOptions& Options)
{
	for (const FStudyAssignment& Assignment : Set)
	{
		if (Assignment.Name == "precision")
		{
			Options.bDouble = Assignment.Value == "double";
		}
		else if (Assignment.Name == "storage")
		{
			Options.Storage = Assignment.Value == "float64"   ? ERunStorage::Float64
							  : Assignment.Value == "float32" ? ERunStorage::Float32
															  : ERunStorage::Native;
		}
		else if (IsConfigPlace(Assignment.Name))
		{
			Options.ConfigPlaces.push_back(Assignment.Name + "=" + Assignment.Value);
		}
		else
		{
			const bool bSetting = FindSettingField(Assignment.Name) != nullptr;
			(bSetting ? Options.Settings : Options.Variables).push_back(Assignment.Name + "=" + Assignment.Value);
		}
	}
}

std::string GetConfigText(const FRunOptions& Options)
{
	return Options.ConfigText ? *Options.ConfigText : TryReadTextFile(Options.ConfigFile).value_or("");
}

std::string GetStudyFingerprint(const std::string& ConfigText)
{
	std::vector<FDiagnostic> Ignored;
	bool bSyntaxError = false;
	const FJsonValue Root = ParseJson(ConfigText, "", Ignored, bSyntaxError);
	FContentHash Hash;
	for (const FJsonMember& Member : Root.Members)
	{
		if (Member.Key != "budget" && Member.Key != "outputs" && Member.Key != "$schema" && Member.Key != "sweep")
		{
			Hash.Add(Member.Key);
			AddToHash(Member.Value, Hash);
		}
	}
	return Hash.Finish();
}

} // namespace Drydock
