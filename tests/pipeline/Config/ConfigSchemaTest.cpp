// The schema of configs: it is what the lists say, it is JSON, and it names every key that the reader knows.
// PublishedSchemaTest.cpp is about the file that is published, and about names.
#include <gtest/gtest.h>

#include "Config/ConfigKeys.h"
#include "Config/ConfigSchema.h"
#include "PostProcessSettingsReflection.h"
#include "ShowFlags.h"
#include "Text/Json.h"

#include <map>
#include <set>

using namespace Drydock;

namespace
{

FJsonValue ParseSchema()
{
	std::vector<FDiagnostic> Diagnostics;
	bool bSyntaxError = false;
	const FJsonValue Root = ParseJson(MakeConfigSchema(), "schema", Diagnostics, bSyntaxError);
	EXPECT_TRUE(Diagnostics.empty());
	return Root;
}

/** Keys that the schema gives an object: the root, or a definition. */
std::set<std::string> SchemaKeys(const FJsonValue& Root, const std::string& Object)
{
	const FJsonValue* Definition = Object.empty() ? &Root : Root.Find("definitions")->Find(Object);
	std::set<std::string> Keys;
	for (const auto& [Name, Value] : Definition->Find("properties")->Members)
	{
		Keys.insert(Name);
	}
	return Keys;
}

/** Follows every "$ref" below a value. */
void CollectReferences(const FJsonValue& Value, std::set<std::string>& References)
{
	for (const FJsonValue& Element : Value.Elements)
	{
		CollectReferences(Element, References);
	}
	for (const auto& [Name, Member] : Value.Members)
	{
		if (Name == "$ref")
		{
			References.insert(Member.String);
		}
		CollectReferences(Member, References);
	}
}

} // namespace

TEST(ConfigSchema, EveryObjectHasTheReadersKeys)
{
	std::map<std::string, std::set<std::string>> ReaderKeys;
	for (const FConfigKey& Key : GetConfigKeys())
	{
		ReaderKeys[Key.Object];
		if (std::string(Key.Name) != "*")
		{
			ReaderKeys[Key.Object].insert(Key.Name);
		}
	}
	const FJsonValue Root = ParseSchema();
	for (const auto& [Object, Keys] : ReaderKeys)
	{
		EXPECT_EQ(Keys, SchemaKeys(Root, Object)) << Object;
	}
}

TEST(ConfigSchema, SettingsAreTheTableAndTheBlendables)
{
	std::set<std::string> Expected = {"WeightedBlendables"};
	for (const FSettingField& Field : GetSettingFields())
	{
		if (Field.AddedId == 0)
		{
			Expected.insert(Field.Name);
			Expected.insert(Field.OverrideName);
		}
	}
	EXPECT_EQ(Expected, SchemaKeys(ParseSchema(), "Settings"));
}

TEST(ConfigSchema, ShowFlagsAreTheList)
{
	EXPECT_EQ(static_cast<size_t>(GetShowFlagInfos().Num()), SchemaKeys(ParseSchema(), "showFlags").size());
}

TEST(ConfigSchema, EveryReferenceLeadsToADefinition)
{
	const FJsonValue Root = ParseSchema();
	std::set<std::string> References;
	CollectReferences(Root, References);
	EXPECT_GT(References.size(), 10u);
	for (const std::string& Reference : References)
	{
		const std::string Prefix = "#/definitions/";
		ASSERT_EQ(0u, Reference.find(Prefix));
		EXPECT_NE(nullptr, Root.Find("definitions")->Find(Reference.substr(Prefix.size()))) << Reference;
	}
}

TEST(ConfigSchema, ClosedObjectsRefuseOtherKeys)
{
	const FJsonValue Root = ParseSchema();
	EXPECT_FALSE(Root.Find("additionalProperties")->Bool);
	EXPECT_FALSE(Root.Find("definitions")->Find("volume")->Find("additionalProperties")->Bool);
	EXPECT_TRUE(Root.Find("definitions")->Find("extension")->Find("additionalProperties")->Bool);
}

TEST(ConfigSchema, SettingsCarryTheirDefaults)
{
	const FJsonValue Root = ParseSchema();
	const FJsonValue* Properties = Root.Find("definitions")->Find("Settings")->Find("properties");
	EXPECT_EQ(0.675, Properties->Find("BloomIntensity")->Find("default")->Number);
	EXPECT_EQ("BM_SOG", Properties->Find("BloomMethod")->Find("default")->String);
	EXPECT_EQ(4u, Properties->Find("Bloom1Tint")->Find("default")->Elements.size());
}
