// The schema names what the program's registries hold, and the configs that ship, and those that verbs write, follow
// it.
#include "../ProgramTestUtils.h"
#include "SchemaRules.h"

#include "EngineProfile.h"
#include "Extensions/EngineHooks.h"
#include "ExtensionFactory.h"
#include "HAL/ConsoleVariableTools.h"
#include "PassFactory.h"
#include "Picture/ImageMetrics.h"
#include "PostProcessSettingsReflection.h"

#include <gmock/gmock.h>

#include <set>
#include <sstream>

using namespace ProgramTest;
using namespace SchemaTest;
using namespace Drydock;
using testing::IsEmpty;

namespace
{

const Files::path Root = DRYDOCK_TEST_SOURCE_DIR;

std::string ReadFile(const Files::path& Path)
{
	std::ifstream Stream(Path, std::ios::binary);
	return std::string(std::istreambuf_iterator<char>(Stream), {});
}

FJson ReadConfig(const Files::path& Path)
{
	return FJson::parse(ReadFile(Path), nullptr, true, true); // with comments
}

class PublishedSchema : public testing::Test
{
protected:
	/** The lines of `drydock list THINGS --names`: of the program, which loaded nothing else. */
	std::set<std::string> List(const std::string& Things) const
	{
		std::istringstream Lines(Folder.Call("list " + Things + " --names").Printed);
		std::set<std::string> Names;
		for (std::string Line; std::getline(Lines, Line);)
		{
			Names.insert(Line);
		}
		return Names;
	}

	std::set<std::string> GetKeys(const char* Pointer) const
	{
		std::set<std::string> Keys;
		for (const auto& [Name, Value] : Schema.at(FJson::json_pointer(Pointer)).items())
		{
			Keys.insert(Name);
		}
		return Keys;
	}

	std::set<std::string> GetTexts(const char* Pointer) const
	{
		std::set<std::string> Texts;
		for (const FJson& Text : Schema.at(FJson::json_pointer(Pointer)))
		{
			Texts.insert(Text.get<std::string>());
		}
		return Texts;
	}

	const FJson Schema = FJson::parse(ReadFile(Root / "configs/schema/drydock.schema.json"));
	const FProgramFolder Folder{"schema"};
};

} // namespace

TEST_F(PublishedSchema, IsWhatTheProgramPrints)
{
	const std::string Printed = Folder.Call("schema").Printed;
	const Files::path Path = Root / "configs/schema/drydock.schema.json";
	if (std::getenv("DRYDOCK_BLESS") != nullptr)
	{
		std::ofstream(Path, std::ios::binary) << Printed;
	}
	EXPECT_TRUE(ReadFile(Path) == Printed) << "run with DRYDOCK_BLESS=1 and commit";
}

TEST_F(PublishedSchema, NamesAreThoseOfTheRegistries)
{
	EXPECT_EQ(List("cvars"), GetKeys("/definitions/variables/properties"));
	EXPECT_EQ(List("passes"), GetTexts("/definitions/pass/properties/type/anyOf/0/enum"));
	std::set<std::string> Extensions = List("extensions"); // lists passes too
	for (const std::string& Pass : List("passes"))
	{
		Extensions.erase(Pass);
	}
	for (const std::string& Type : GetTexts("/definitions/extension/properties/type/anyOf/0/enum"))
	{
		EXPECT_EQ(1u, Extensions.erase(Type) + List("passes").count(Type)) << Type;
	}
	EXPECT_THAT(Extensions, IsEmpty());
	std::set<std::string> Hooks = {PrePostProcessPassName};
	for (const std::string& Name : GetPassNames())
	{
		Hooks.insert(Name);
	}
	EXPECT_EQ(Hooks, GetTexts("/definitions/pass/properties/at/enum"));
	EXPECT_EQ(Hooks, GetTexts("/definitions/extension/properties/pass/enum"));
	const std::vector<std::string> Metrics = GetMetricNames();
	EXPECT_EQ(
		std::set<std::string>(Metrics.begin(), Metrics.end()), GetTexts("/definitions/budget/properties/metric/enum"));
	EXPECT_EQ(std::set<std::string>(Metrics.begin(), Metrics.end()),
		GetTexts("/definitions/study/properties/metrics/items/enum"));
	std::set<std::string> Engines;
	for (const FEngineProfile& Profile : GetEngineProfiles())
	{
		Engines.insert(Profile.GetVersion());
	}
	EXPECT_EQ(Engines, GetTexts("/properties/engine/enum"));
}

TEST_F(PublishedSchema, EveryTypeHasItsParameters)
{
	size_t NumRules = 0;
	for (const char* const Object : {"extension", "pass"})
	{
		const FJson Properties = Schema.at("definitions").at(Object);
		for (const FJson& Rule : Properties.at("allOf"))
		{
			++NumRules;
			const std::string Type = Rule.at("if").at("properties").at("type").at("const").get<std::string>();
			const FJson Then = Rule.at("then").at("properties");
			const bool bPass = Object == std::string("pass");
			const std::vector<FParameterSpec> Specs =
				bPass ? FindPassFactory(Type)->Parameters : FindExtensionFactory(Type)->Parameters;
			const FJson Given = bPass ? Then.at("parameters").at("properties") : Then;
			for (const FParameterSpec& Spec : Specs)
			{
				EXPECT_EQ(Spec.Doc, Given.at(Spec.Name).at("description").get<std::string>()) << Type;
			}
			EXPECT_EQ(Specs.size(), Given.size() - Given.count("pass")) << Type;
		}
	}
	EXPECT_LT(10u, NumRules);
}

TEST_F(PublishedSchema, ShippedConfigsFollowIt)
{
	const FSchemaRules Rules(Schema);
	size_t NumConfigs = 0;
	for (const char* const Place : {"configs", "templates/MyPatch/configs", "tests/recipes/Posterize/configs"})
	{
		for (const Files::directory_entry& Entry : Files::directory_iterator(Root / Place))
		{
			if (Entry.path().extension() == ".json")
			{
				++NumConfigs;
				const FJson Config = ReadConfig(Entry.path());
				EXPECT_THAT(Rules.Check(Config), IsEmpty()) << Entry.path();
				const std::string Named = Config.value("$schema", "");
				const Files::path Written = Root / "configs/schema/drydock.schema.json";
				const bool bTemplate =
					Place != std::string("configs"); // the schema is made beside it, or lies in the tree
				EXPECT_TRUE(bTemplate ? !Named.empty() : Files::equivalent(Entry.path().parent_path() / Named, Written))
					<< Entry.path();
			}
		}
	}
	EXPECT_LE(30u, NumConfigs);
}

TEST_F(PublishedSchema, ScaffoldedConfigsFollowItAndHaveItBesideThem)
{
	EXPECT_EQ(0, Folder.Call("new Rain").ExitCode);
	Folder.WriteFrame("unused.json", "");
	EXPECT_EQ(0, Folder.Call("import scene.exr --out imported/shot.exr").ExitCode);
	for (const char* const Name : {"Rain/configs/Rain.json", "imported/shot.json"})
	{
		const Files::path Path = Folder.Path / Name;
		const FJson Config = ReadConfig(Path);
		const FJson Beside = ReadConfig(Path.parent_path() / Config.at("$schema").get<std::string>());
		EXPECT_EQ(Schema, Beside) << Name;
		EXPECT_THAT(FSchemaRules(Beside).Check(Config), IsEmpty()) << Name;
	}
}

TEST_F(PublishedSchema, MistakesAreFound)
{
	const FSchemaRules Rules(Schema);
	const auto Faults = [&Rules](const char* Config)
	{
		return Rules.Check(FJson::parse(Config)).size();
	};
	EXPECT_EQ(0u, Faults(R"({"scene": {"file": "a.exr"}, "cvars": {"r.BloomQuality": 4, "r.OfAPlugin": 1}})"));
	EXPECT_EQ(0u,
		Faults(
			R"({"extensions": [{"type": "OfAPlugin", "Any": 1}, {"type": "Tint", "pass": "Tonemap", "Left": 0.5}]})"));
	EXPECT_LT(0u, Faults(R"({"scne": {}})"));
	EXPECT_LT(0u, Faults(R"({"engine": "4.27"})"));
	EXPECT_LT(0u, Faults(R"({"extensions": [{"type": "Tint", "Left": 2}]})"));
	EXPECT_LT(0u, Faults(R"({"extensions": [{"type": "Tint", "pass": "Tonmap"}]})"));
	EXPECT_LT(0u, Faults(R"({"passes": [{"type": "BloomSetup", "at": "MotionBlr"}]})"));
	EXPECT_LT(0u, Faults(R"({"passes": [{"type": "BloomSetup", "at": "MotionBlur", "parameters": {"Treshold": 1}}]})"));
	EXPECT_LT(0u, Faults(R"({"budget": {"metric": "rsm"}})"));
	EXPECT_LT(0u, Faults(R"({"cvars": {"r.BloomQuality": [1]}})"));
}
