// Reads the config's extensions and passes against the factories that exist.
#include "Extensions/ConfigExtensions.h"

#include "Config/ConfigReader.h"
#include "Extensions/EngineHooks.h"
#include "Extensions/ExtensionErrors.h"
#include "Extensions/FactoryTypes.h"
#include "RangeTools.h"
#include "SceneViewState.h"
#include "TextTools.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>

namespace Drydock
{

namespace
{

constexpr const char* ExtensionKeys[] = {"type", "pass"};

/** [r, g, b], [r, g, b, a] or {R, G, B, A}, alpha 1 where it is not given; false when it is none of these. */
bool ReadColor(const FJsonValue& Value, FLinearColor& OutColor)
{
	float Components[4] = {0.0f, 0.0f, 0.0f, 1.0f};
	const auto Take = [&](const FJsonValue& Component, size_t Index)
	{
		Components[Index] = static_cast<float>(Component.Number);
		return Component.Type == EJsonType::Number;
	};
	if (Value.Type == EJsonType::Array && (Value.Elements.size() == 3 || Value.Elements.size() == 4))
	{
		for (size_t Index = 0; Index < Value.Elements.size(); ++Index)
		{
			if (!Take(Value.Elements[Index], Index))
			{
				return false;
			}
		}
	}
	else if (Value.Type == EJsonType::Object)
	{
		constexpr const char* Names = "RGBA";
		for (const auto& [Name, Component] : Value.Members)
		{
			const size_t Index = Name.size() == 1 ? std::string(Names).find(Name) : std::string::npos;
			if (Index == std::string::npos || !Take(Component, Index))
			{
				return false;
			}
		}
	}
	else
	{
		return false;
	}
	OutColor = FLinearColor(Components[0], Components[1], Components[2], Components[3]);
	return true;
}

/** One value of a parameter's type and range; a mistake is reported and leaves the default. */
void ReadParameter(
	const FJsonValue& Value, const FParameterSpec& Spec, FParameterValues& Values, FConfigMessages& Messages)
{
	const auto WrongType = [&](const char* Expected)
	{
		if (Value.Type != EJsonType::Invalid)
		{
			Messages.Error(ErrorWrongType, Value,
				Spec.Name + ": expected " + Expected + ", found " + std::string(Value.Describe()));
		}
	};
	switch (Spec.Kind)
	{
	case EParameterKind::Number:
	case EParameterKind::Integer:
		if (Value.Type != EJsonType::Number ||
			(Spec.Kind == EParameterKind::Integer && Value.Number != std::floor(Value.Number)))
		{
			WrongType(Spec.Kind == EParameterKind::Integer ? "a whole number" : "a number");
		}
		else if (Value.Number < Spec.Min || Value.Number > Spec.Max)
		{
			Messages.Error(ErrorBadValue, Value, Spec.Name + " must be in " + GetRangeText(Spec));
		}
		else
		{
			Values.Set(Spec.Name, Value.Number);
		}
		break;
	case EParameterKind::Bool:
		if (Value.Type != EJsonType::Bool)
		{
			WrongType("true or false");
			break;
		}
		Values.Set(Spec.Name, Value.Bool);
		break;
	case EParameterKind::Text:
		if (Value.Type != EJsonType::String)
		{
			WrongType("a string");
		}
		else if (!Spec.Choices.empty() && !Contains(Spec.Choices, Value.String))
		{
			Messages.Error(ErrorUnknownValue, Value,
				Spec.Name + ": \"" + Value.String + "\" is not one of " + JoinText(Spec.Choices) +
					Messages.Suggest(Value.String, Spec.Choices));
		}
		else
		{
			Values.Set(Spec.Name, Value.String);
		}
		break;
	case EParameterKind::Color:
	{
		FLinearColor Color;
		if (!ReadColor(Value, Color))
		{
			WrongType("a colour: [r, g, b], [r, g, b, a] or {\"R\": r, \"G\": g, \"B\": b, \"A\": a}");
			break;
		}
		Values.Set(Spec.Name, Color);
		break;
	}
	}
}

/** Members of an object as parameters; Others: keys that mean something else and are passed over. */
FParameterValues ReadParameters(const FJsonValue& Object, const std::vector<FParameterSpec>& Specs,
	const std::vector<std::string>& Others, const std::string& Type, FConfigMessages& Messages)
{
	FParameterValues Values(Specs);
	std::vector<std::string> Names = Others;
	for (const FParameterSpec& Spec : Specs)
	{
		Names.push_back(Spec.Name);
	}
	for (const auto& [Name, Member] : Object.Members)
	{
		if (const FParameterSpec* Spec = FindItem(Specs, Name, &FParameterSpec::Name))
		{
			ReadParameter(Member, *Spec, Values, Messages);
		}
		else if (!Contains(Others, Name))
		{
			Messages.ErrorAtKey(
				ErrorUnknownKey, Member, Type + " has no parameter \"" + Name + "\"" + Messages.Suggest(Name, Names));
		}
	}
	return Values;
}

/** Whether the run's engine version has that hook; else it is reported. */
bool CheckHook(const FConfig& Config, const FJsonValue& Value, const std::string& Hook,
	const std::vector<std::string>& Allowed, const std::string& Type, FConfigMessages& Messages)
{
	if (!Contains(Allowed, Hook))
	{
		Messages.Error(ErrorUnknownValue, Value,
			"\"" + Hook + "\" is not a hook of " + Type + ": " + JoinText(Allowed) + Messages.Suggest(Hook, Allowed));
		return false;
	}
	const auto Pass = FindPassByName(Hook);
	const FEngineProfile* const Engine = FindEngineProfile(Config.Engine.Value);
	if (Pass && Engine != nullptr && !HasInsertionPoint(*Pass, Engine->Minor))
	{
		Messages.Error(ErrorUnknownValue, Value,
			"engine " + Config.Engine.Value + " has no hook " + Hook + ": it is there from " +
				GetEngineVersionText(GetInsertionPoint(*Pass).First));
		return false;
	}
	return true;
}

const FJsonValue* FindString(const FJsonValue& Object, const char* Key)
{
	const FJsonValue* Value = Object.Find(Key);
	return Value != nullptr && Value->Type == EJsonType::String ? Value : nullptr;
}

std::vector<std::string> GetInsertionHooks()
{
	std::vector<std::string> Hooks = {PrePostProcessPassName};
	for (const std::string& Name : GetPassNames())
	{
		Hooks.push_back(Name);
	}
	return Hooks;
}

/** The name of a pass without a type. */
const std::string NamelessPass = "pass";

/** Names of the results of passes: those that stand before a pass in the config. */
class FPassNames
{
public:
	void Add(const std::string& Name)
	{
		InOrder.push_back(Name);
		Known.insert(Name);
	}
	bool Contains(const std::string& Name) const { return Known.count(Name) != 0; }

	/** The last of them, for messages. */
	std::vector<std::string> GetLast() const
	{
		constexpr size_t MaxListed = 100;
		return {InOrder.end() - static_cast<std::ptrdiff_t>(std::min(InOrder.size(), MaxListed)), InOrder.end()};
	}

private:
	std::vector<std::string> InOrder;
	std::set<std::string> Known;
};

void ReadPassInputs(const FJsonValue& Value, const FPassFactory& Factory, const FPassNames& Earlier,
	FPassRequest& Request, FConfigMessages& Messages)
{
	std::vector<std::string> Names;
	for (const FPassInputSpec& Spec : Factory.Inputs)
	{
		Names.push_back(Spec.Name);
		Request.Resources[Spec.Name] = Spec.Default;
	}
	std::vector<std::string> Resources = GetPassResources();
	const std::vector<std::string> LastEarlier = Earlier.GetLast();
	Resources.insert(Resources.end(), LastEarlier.begin(), LastEarlier.end());
	std::set<std::string> Given;
	const FJsonValue* Inputs = Value.Find("inputs");
	if (Inputs != nullptr && Inputs->Type == EJsonType::Object)
	{
		for (const auto& [Name, Resource] : Inputs->Members)
		{
			Given.insert(Name);
			if (Resource.Type != EJsonType::String)
			{
				continue; // reported with the config's shape
			}
			if (!Contains(Names, Name))
			{
				Messages.ErrorAtKey(ErrorPassInput, Resource,
					Factory.Type + " has no input \"" + Name + "\"" + Messages.Suggest(Name, Names) + "; there is " +
						JoinText(Names));
			}
			else if (!Earlier.Contains(Resource.String) && !Contains(Resources, Resource.String))
			{
				Messages.Error(ErrorPassInput, Resource,
					"there is no resource \"" + Resource.String + "\" here" +
						Messages.Suggest(Resource.String, Resources) + "; there is " + JoinText(Resources));
			}
			else
			{
				Request.Resources[Name] = Resource.String;
			}
		}
	}
	for (const auto& [Name, Resource] : Request.Resources)
	{
		if (Resource.empty() && Given.count(Name) == 0)
		{
			Messages.Error(ErrorPassInput, Value, "the input \"" + Name + "\" of " + Factory.Type + " must be given");
		}
	}
}

} // namespace

std::vector<FExtensionRequest> ReadExtensionRequests(const FConfig& Config, std::vector<FDiagnostic>& Diagnostics)
{
	FConfigMessages Messages(Config.File, Diagnostics);
	std::vector<FExtensionRequest> Requests;
	for (const FJsonValue& Value : Config.Extensions)
	{
		const FJsonValue* Type = FindString(Value, "type");
		if (Type == nullptr)
		{
			continue; // reported with the config's shape
		}
		const FExtensionFactory* Factory = FindExtensionFactory(Type->String);
		if (Factory == nullptr)
		{
			const std::vector<std::string> Types = GetFactoryTypes(GetExtensionFactories());
			Messages.Error(ErrorUnknownExtension, *Type,
				"there is no extension \"" + Type->String + "\"" + Messages.Suggest(Type->String, Types) +
					"; there is " + JoinText(Types));
			continue;
		}
		FExtensionRequest Request;
		Request.Type = Factory->Type;
		Request.Arguments.Pass = Factory->Passes.empty() ? "" : Factory->Passes[0];
		if (const FJsonValue* Pass = FindString(Value, "pass"))
		{
			if (Factory->Passes.empty())
			{
				Messages.ErrorAtKey(
					ErrorUnknownKey, *Pass, Factory->Type + " chooses its own hooks: it takes no \"pass\"");
			}
			else if (CheckHook(Config, *Pass, Pass->String, Factory->Passes, Factory->Type, Messages))
			{
				Request.Arguments.Pass = Pass->String;
			}
		}
		Request.Arguments.Values = ReadParameters(
			Value, Factory->Parameters, {std::begin(ExtensionKeys), std::end(ExtensionKeys)}, Factory->Type, Messages);
		Requests.push_back(std::move(Request));
	}
	return Requests;
}

namespace
{

/** Empty where there is no such pass, which is reported. */
std::optional<FPassRequest> ReadPassRequest(const FConfig& Config, const FJsonValue& Value, const std::string& Name,
	const FPassNames& Earlier, FConfigMessages& Messages)
{
	const FJsonValue* Type = FindString(Value, "type");
	const FJsonValue* At = FindString(Value, "at");
	if (At != nullptr)
	{
		CheckHook(
			Config, *At, At->String, GetInsertionHooks(), Type != nullptr ? Type->String : NamelessPass, Messages);
	}
	if (Type == nullptr)
	{
		return std::nullopt; // reported with the config's shape
	}
	const FPassFactory* Factory = FindPassFactory(Type->String);
	if (Factory == nullptr)
	{
		const std::vector<std::string> Types = GetFactoryTypes(GetPassFactories());
		Messages.Error(ErrorUnknownPass, *Type,
			"there is no pass \"" + Type->String + "\"" + Messages.Suggest(Type->String, Types) + "; there is " +
				JoinText(Types));
		return std::nullopt;
	}
	FPassRequest Request;
	Request.Type = Factory->Type;
	Request.Hook = At != nullptr ? At->String : "";
	Request.Name = Name;
	if (const FJsonValue* Replace = Value.Find("replace"))
	{
		Request.bReplace = Replace->Type != EJsonType::Bool || Replace->Bool;
	}
	ReadPassInputs(Value, *Factory, Earlier, Request, Messages);
	const FJsonValue* Parameters = Value.Find("parameters");
	Request.Values = ReadParameters(
		Parameters != nullptr ? *Parameters : FJsonValue(), Factory->Parameters, {}, Factory->Type, Messages);
	return Request;
}

} // namespace

std::vector<FPassRequest> ReadPassRequests(const FConfig& Config, std::vector<FDiagnostic>& Diagnostics)
{
	FConfigMessages Messages(Config.File, Diagnostics);
	std::vector<FPassRequest> Requests;
	FPassNames Earlier;
	for (const auto& [Texture, Channels] : Config.Scene.Textures)
	{
		Earlier.Add(Texture);
	}
	for (const FJsonValue& Value : Config.Passes)
	{
		const FJsonValue* Type = FindString(Value, "type");
		const FJsonValue* Given = FindString(Value, "name");
		const std::string Name = Given != nullptr ? Given->String : Type != nullptr ? Type->String : NamelessPass;
		if (std::optional<FPassRequest> Request = ReadPassRequest(Config, Value, Name, Earlier, Messages))
		{
			Requests.push_back(std::move(*Request));
		}
		Earlier.Add(Name); // later passes may read its result even where it has a mistake
	}
	return Requests;
}

std::vector<std::string> GetPassResources()
{
	return {PictureResource, "SceneDepth", "Velocity", "GBufferA", "GBufferB", "GBufferC", "GBufferD", "CustomDepth",
		"ToonShadow", CustomSSRInputName};
}

} // namespace Drydock
