// Makes the text of an overlay's connections.
#include "Overlay/OverlaySource.h"

#include "PostProcessSettings.h"
#include "TextTools.h"

#include <initializer_list>
#include <set>

namespace Drydock
{

namespace
{

/** The pattern with Values[0] in place of $0, and so on. */
std::string Fill(std::string_view Pattern, std::initializer_list<std::string> Values)
{
	std::string Text;
	for (size_t At = 0; At < Pattern.size(); ++At)
	{
		if (Pattern[At] == '$')
		{
			Text += Values.begin()[Pattern[++At] - '0'];
		}
		else
		{
			Text += Pattern[At];
		}
	}
	return Text;
}

/** A name for C++ from that of a pass function. */
std::string MakeIdentifier(std::string_view Name)
{
	std::string Identifier;
	for (const char Character : Name)
	{
		Identifier += IsWordCharacter(Character) ? Character : '_';
	}
	return Identifier;
}

std::string Register(std::string_view Name, const std::string& Function)
{
	return Fill("const Drydock::FPassReplacement GReplaced_$0($1,\n"
				"\treinterpret_cast<Drydock::FAnyFunction>($2));\n\n",
		{MakeIdentifier(Name), QuoteForCpp(std::string(Name)), Function});
}

/** A function that fills the overlay's own struct from the members that it still has, and calls the overlay's pass. */
std::string WritePassWithInputs(const FPassFunction& Pass)
{
	std::string Members;
	for (size_t Index = 0; Index < Pass.Members.size(); ++Index)
	{
		Members += Fill("\t\tif constexpr (requires { Given.$0; })\n\t\t{\n"
						"\t\t\tGiven.$0 = *static_cast<const decltype(Given.$0)*>(Members[$1]);\n\t\t}\n",
			{Pass.Members[Index], std::to_string(Index)});
	}
	return Fill("$0 Call$1(FRDGBuilder& GraphBuilder, const FViewInfo& View, const void* const* Members)\n"
				"{\n\t$2 Inputs;\n\t[&](auto& Given)\n\t{\n$3\t}(Inputs);\n"
				"\treturn $1(GraphBuilder, View, Inputs);\n}\n\n",
			   {Pass.Result, Pass.Name, Pass.Inputs, Members}) +
		   Register(Pass.Name, Fill("&Call$0", {Pass.Name}));
}

std::string WritePass(const FPassFunction& Pass)
{
	return *Pass.Inputs != '\0'
			   ? WritePassWithInputs(Pass)
			   : Register(Pass.Name, Fill("static_cast<$0 (*)$1>(&$2)", {Pass.Result, Pass.Parameters, Pass.Name}));
}

/** The block with the place's variables around it. Messages of the compiler name the overlay's file. */
std::string WritePlace(const FOverlayPlace& Place)
{
	const std::string Struct = Place.Place->Struct;
	return Fill("struct F$0 : Drydock::$0\n{\n\tvoid AddPasses()\n\t{\n#line $1 $2\n$3\n\t}\n};\n\n"
				"void Call$0(Drydock::$0& Place)\n{\n\tF$0{Place}.AddPasses();\n}\n\n",
			   {Struct, std::to_string(Place.Line), QuoteForCpp(Place.File), Place.Text}) +
		   Register(Place.Place->Name, "&Call" + Struct);
}

std::vector<const char*> GetComponents(const std::string& Type)
{
	if (Type == "FLinearColor")
	{
		return {"R", "G", "B", "A"};
	}
	if (Type == "FVector2D")
	{
		return {"X", "Y"};
	}
	return Type == "FVector4" ? std::vector<const char*>{"X", "Y", "Z", "W"} : std::vector<const char*>{};
}

/** An empty member that gives the setting's value under the engine's name; it adds nothing to the struct's size. */
std::string WriteMember(const FOverlaySetting& Setting)
{
	std::string Components;
	for (const char* const Component : GetComponents(Setting.Type))
	{
		Components += Fill("\tstruct F$1\n\t{\n\t\toperator auto() const\n\t\t{\n"
						   "\t\t\treturn reinterpret_cast<const FAdded$0*>(this)->Get().$1;\n\t\t}\n\t};\n"
						   "\t[[no_unique_address]] F$1 $1;\n",
			{Setting.Name, Component});
	}
	return Fill(
		"struct FAdded$0\n{\n\tstatic $1 Get(const FPostProcessSettings& Settings);\n"
		"\tstatic bool IsOverridden(const FPostProcessSettings& Settings);\n"
		"\tstatic void Set(FPostProcessSettings& Settings, const $1& Value);\n"
		"\tconst FPostProcessSettings& GetSettings() const\n\t{\n"
		"\t\treturn *reinterpret_cast<const FPostProcessSettings*>(\n"
		"\t\t\treinterpret_cast<const uint8*>(this) - __builtin_offsetof(FPostProcessSettings, $0));\n\t}\n"
		"\t$1 Get() const { return Get(GetSettings()); }\n"
		"\toperator $1() const { return Get(); }\n"
		"\tFAdded$0& operator=(const $1& Value)\n\t{\n"
		"\t\tSet(const_cast<FPostProcessSettings&>(GetSettings()), Value);\n\t\treturn *this;\n\t}\n"
		"$2};\n[[no_unique_address]] FAdded$0 $0;\n"
		"struct FAddedOverride$0\n{\n\toperator bool() const\n\t{\n"
		"\t\treturn FAdded$0::IsOverridden(*reinterpret_cast<const FPostProcessSettings*>(\n"
		"\t\t\treinterpret_cast<const uint8*>(this) - __builtin_offsetof(FPostProcessSettings, bOverride_$0)));\n"
		"\t}\n};\n[[no_unique_address]] FAddedOverride$0 bOverride_$0;\n",
		{Setting.Name, Setting.Type, Components});
}

std::string WriteSetting(const FOverlaySetting& Setting)
{
	std::string Info;
	const auto Add = [&](const char* Member, const std::string& Value)
	{
		if (!Value.empty())
		{
			Info += Fill("$0.$1 = $2", {Info.empty() ? "" : ", ", Member, Value});
		}
	};
	const auto Quote = [](const std::string& Text)
	{
		return Text.empty() ? Text : "TEXT(" + QuoteForCpp(Text) + ")";
	};
	Add("Min", Setting.Min);
	Add("Max", Setting.Max);
	Add("Doc", Quote(Setting.Doc));
	Add("Category", Quote(Setting.Category));
	Add("Blend", Setting.Blend.empty() ? "" : "Drydock::ESettingBlend::" + Setting.Blend);
	std::string Names;
	for (const std::string& Name : Setting.EnumNames)
	{
		Names += (Names.empty() ? "{TEXT(" : ", TEXT(") + QuoteForCpp(Name) + ")";
	}
	Add("EnumNames", Names.empty() ? Names : Names + "}");
	const std::string Zero = GetComponents(Setting.Type).size() == 4 && Setting.Type == "FLinearColor"
								 ? "FLinearColor(0.0f, 0.0f, 0.0f, 0.0f)"
								 : Setting.Type + "{}";
	return Fill("const Drydock::TPostProcessSetting<$1> G$0(\n\tTEXT(\"$0\"), $1($2), {$3});\n\n",
		{Setting.Name, Setting.Type, Setting.Default.empty() ? Zero : Setting.Default, Info});
}

std::string WriteAccess(const FOverlaySetting& Setting)
{
	return Fill("$1 FPostProcessSettings::FAdded$0::Get(const FPostProcessSettings& Settings)\n{\n"
				"\treturn G$0.Get(Settings);\n}\n\n"
				"bool FPostProcessSettings::FAdded$0::IsOverridden(const FPostProcessSettings& Settings)\n{\n"
				"\treturn G$0.IsOverridden(Settings);\n}\n\n"
				"void FPostProcessSettings::FAdded$0::Set(FPostProcessSettings& Settings, const $1& Value)\n{\n"
				"\tG$0.Set(Settings, Value);\n}\n\n",
		{Setting.Name, Setting.Type});
}

} // namespace

FOverlaySource WriteOverlaySource(const FOverlayFolder& Folder)
{
	std::set<std::string> Headers;
	for (const FPassFunction* const Pass : Folder.Passes)
	{
		Headers.insert(Pass->Header);
	}
	for (const FOverlayPlace& Place : Folder.Places)
	{
		for (const FPassFunction& Pass : GetPassFunctions())
		{
			if (std::string_view(Pass.Name) == Place.Place->Call)
			{
				Headers.insert(Pass.Header);
			}
		}
	}
	FOverlaySource Source;
	std::string& Text = Source.Connections;
	Text = "// Made by drydock: connects the overlay with the table of passes and the settings.\n";
	for (const std::string& Header : Headers)
	{
		Text += "#include \"" + Header + "\"\n";
	}
	Text += "\n#include \"Overlay/ChainPlaces.h\"\n#include \"PassFunctions.h\"\n#include \"PostProcessSetting.h\"\n"
			"#include \"PostProcess/PostProcessing.h\"\n\nnamespace\n{\n\n";
	Text += "static_assert(sizeof(FFinalPostProcessSettings) == " + std::to_string(sizeof(FFinalPostProcessSettings)) +
			");\n\n";
	std::string Access;
	for (const FOverlaySetting& Setting : Folder.Settings)
	{
		Source.Members += WriteMember(Setting);
		Text += WriteSetting(Setting);
		Access += WriteAccess(Setting);
	}
	for (const FPassFunction* const Pass : Folder.Passes)
	{
		Text += WritePass(*Pass);
	}
	for (const FOverlayPlace& Place : Folder.Places)
	{
		Text += WritePlace(Place);
	}
	Text += "} // namespace\n\n" + Access;
	for (const std::string& Enum : Folder.EnumTexts)
	{
		Source.Types += Enum + "\n";
	}
	return Source;
}

} // namespace Drydock
