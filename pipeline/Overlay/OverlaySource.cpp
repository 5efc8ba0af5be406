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

/** The block of that name. */
std::string_view FindBlock(std::string_view Name)
{
	constexpr std::string_view Blocks =
#include "OverlaySource.txt"
		;
	const std::string Head = "=== " + std::string(Name) + "\n";
	const size_t Begin = Blocks.find(Head) + Head.size();
	return Blocks.substr(Begin, Blocks.find("=== ", Begin) - Begin);
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

std::string Register(std::string_view Name, const std::string& Function, const std::string& Own)
{
	return Fill(FindBlock("Registration"), {MakeIdentifier(Name), QuoteForCpp(std::string(Name)), Function, Own});
}

/** A function that fills the overlay's own struct from the members that it still has, and calls the overlay's pass. */
std::string WritePassWithInputs(const FPassFunction& Pass, const std::string& Own)
{
	std::string Members;
	for (size_t Index = 0; Index < Pass.Members.size(); ++Index)
	{
		Members += Fill(FindBlock("Member of inputs"), {Pass.Members[Index], std::to_string(Index)});
	}
	return Fill(FindBlock("Pass with inputs"), {Pass.Result, Pass.Name, Pass.Inputs, Members, Own}) +
		   Register(Pass.Name, Fill("&Call$0", {Pass.Name}), Own + "()");
}

std::string WritePass(const FPassFunction& Pass)
{
	const std::string Parameters =
		*Pass.Inputs != '\0' ? Fill("(FRDGBuilder&, const FViewInfo&, const $0&)", {Pass.Inputs}) : Pass.Parameters;
	const std::string Own = "Find" + MakeIdentifier(Pass.Name);
	const std::string Find =
		Fill(FindBlock("Own function"), {Own, Pass.Name, Fill("$0 (*)$1", {Pass.Result, Parameters})});
	return *Pass.Inputs != '\0' ? Find + WritePassWithInputs(Pass, Own)
								: Find + Register(Pass.Name, Own + "()", Own + "()");
}

/** The block with the place's variables around it. Messages of the compiler name the overlay's file. */
std::string WritePlace(const FOverlayPlace& Place)
{
	const std::string Struct = Place.Place->Struct;
	const std::string File = QuoteForCpp(Place.File);
	const std::string Condition =
		Place.Condition.empty()
			? ""
			: Fill("#line $0 $1\n$2\n", {std::to_string(Place.ConditionLine), File, Place.Condition});
	return Fill(FindBlock("Place"), {Struct, std::to_string(Place.Line), File, Place.Text, Condition}) +
		   Register(Place.Place->Name, "&Call" + Struct, "&Call" + Struct);
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
		Components += Fill(FindBlock("Component"), {Setting.Name, Component});
	}
	return Fill(FindBlock("Member of settings"), {Setting.Name, Setting.Type, Components});
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
	return Fill(
		FindBlock("Setting"), {Setting.Name, Setting.Type, Setting.Default.empty() ? Zero : Setting.Default, Info});
}

std::string WriteDefault(const FOverlayDefault& Default)
{
	const std::string Set = "SetDefaultOf" + Default.Name;
	return Fill(FindBlock("Default"),
			   {Set, std::to_string(Default.Line), QuoteForCpp(Default.File), Default.Name, Default.Value}) +
		   Register(Default.GetPlace(), "&" + Set, "&" + Set);
}

std::string WriteAccess(const FOverlaySetting& Setting)
{
	return Fill(FindBlock("Access"), {Setting.Name, Setting.Type});
}

} // namespace

FOverlaySource WriteOverlaySource(const FOverlayFolder& Folder)
{
	std::set<std::string> Headers;
	for (const FOverlayPass& Pass : Folder.Passes)
	{
		Headers.insert(Pass.Function->Header);
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
	for (const FOverlayPass& Pass : Folder.Passes)
	{
		Text += WritePass(*Pass.Function);
	}
	for (const FOverlayPlace& Place : Folder.Places)
	{
		Text += WritePlace(Place);
	}
	for (const FOverlayDefault& Default : Folder.Defaults)
	{
		Text += WriteDefault(Default);
	}
	Text += "} // namespace\n\n" + Access;
	for (const std::string& Enum : Folder.EnumTexts)
	{
		Source.Types += Enum + "\n";
	}
	return Source;
}

} // namespace Drydock
