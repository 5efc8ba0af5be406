// Keys and types of a config against the list of keys.
#include "Config/ConfigReader.h"

#include "Config/ConfigKeys.h"
#include "HAL/IConsoleManager.h"
#include "PostProcessSettingsReflection.h"
#include "RangeTools.h"
#include "TextTools.h"

#include <algorithm>

namespace Drydock
{

namespace
{

class FShapeValidator
{
public:
	explicit FShapeValidator(FConfigMessages& InMessages)
		: Messages(InMessages)
	{
	}

	void ValidateObject(const FJsonValue& Value, const std::string& Object)
	{
		for (const auto& [Name, Member] : Value.Members)
		{
			const FConfigKey* Key = FindConfigKey(Object, Name);
			if (Key == nullptr)
			{
				Messages.ErrorAtKey(ErrorUnknownKey, Member, "unknown key \"" + Name + "\"" + FindPlace(Name, Object));
				continue;
			}
			ValidateMember(Member, *Key);
		}
		for (const FConfigKey& Key : GetConfigKeys())
		{
			if (Object == Key.Object && Key.bRequired && Value.Find(Key.Name) == nullptr)
			{
				Messages.Error(ErrorMissingKey, Value, std::string("\"") + Key.Name + "\" is missing: " + Key.Doc);
			}
		}
	}

private:
	/** The nearest key of the object; for a name that belongs elsewhere, where it belongs. */
	std::string FindPlace(const std::string& Name, const std::string& Object) const
	{
		const std::string Key = Messages.SuggestFrom(Name, [&] { return NamesOf(Object); });
		const char* const Settings = FindConfigKey(Object, "Settings") != nullptr
										 ? "\"Settings\" beside it"
										 : "the \"Settings\" of \"camera\" or of a volume";
		if (FindSettingField(Name) != nullptr || FindSettingFieldByOverride(Name) != nullptr)
		{
			return std::string("; this is a setting, and belongs in ") + Settings;
		}
		if (IConsoleManager::Get().FindConsoleVariable(Name.c_str()) != nullptr)
		{
			return "; this is a console variable, and belongs in \"cvars\" of the config";
		}
		const std::string Setting = Key.empty() ? Messages.SuggestSetting(Name) : "";
		return Setting.empty() ? Key : Setting + " That is a setting, and belongs in " + Settings;
	}

	static std::vector<std::string> NamesOf(const std::string& Object)
	{
		std::vector<std::string> Names;
		for (const FConfigKey& Key : GetConfigKeys())
		{
			if (Object == Key.Object)
			{
				Names.emplace_back(Key.Name);
			}
		}
		return Names;
	}

	void WrongType(const FJsonValue& Value, const FConfigKey& Key)
	{
		std::string Expected = GetExpected(Key.Kind);
		if (Key.Of.find('=') != std::string::npos)
		{
			Expected += " or \"" + AlternativeOf(Key) + "\"";
		}
		Messages.Error(ErrorWrongType, Value, "expected " + Expected + ", found " + Value.Describe());
	}

	/** The text that may stand in place of the value, or empty. */
	static std::string AlternativeOf(const FConfigKey& Key)
	{
		const size_t Equals = Key.Of.find('=');
		return Equals == std::string::npos ? "" : Key.Of.substr(Equals + 1);
	}

	/** False when Value has another type, which is reported unless the number was reported already. */
	bool Expect(const FJsonValue& Value, EJsonType Type, const FConfigKey& Key)
	{
		if (Value.Type == Type)
		{
			return true;
		}
		if (Value.Type != EJsonType::Invalid)
		{
			WrongType(Value, Key);
		}
		return false;
	}

	void ValidateMember(const FJsonValue& Value, const FConfigKey& Key)
	{
		const std::string Alternative = AlternativeOf(Key);
		if (!Alternative.empty() && Value.Type == EJsonType::String)
		{
			if (Value.String != Alternative)
			{
				WrongType(Value, Key);
			}
			return;
		}
		switch (Key.Kind)
		{
		case EConfigKind::String:
			ValidateString(Value, Key);
			break;
		case EConfigKind::Number:
			Expect(Value, EJsonType::Number, Key);
			break;
		case EConfigKind::Bool:
			Expect(Value, EJsonType::Bool, Key);
			break;
		case EConfigKind::Vector3:
		case EConfigKind::Rotator:
			ValidateVector(Value, Key);
			break;
		case EConfigKind::NumberArray:
			ValidateNumberArray(Value, Key);
			break;
		case EConfigKind::StringArray:
			ValidateElements(Value, Key,
				[&](const FJsonValue& Element)
				{
					if (ExpectElement(Element, EJsonType::String, "a string"))
					{
						RequireAllowed(Element, Key);
					}
				});
			break;
		case EConfigKind::Vector3Array:
			ValidateElements(Value, Key, [&](const FJsonValue& Element) { ValidateVector(Element, Key); });
			break;
		case EConfigKind::Object:
			if (Expect(Value, EJsonType::Object, Key))
			{
				ValidateObject(Value, Key.Of);
			}
			break;
		case EConfigKind::ObjectArray:
			ValidateElements(Value, Key,
				[&](const FJsonValue& Element)
				{
					if (ExpectElement(Element, EJsonType::Object, "an object"))
					{
						const std::string Of = Key.Of;
						ValidateObject(Element, Of.substr(0, Of.find('=')));
					}
				});
			break;
		case EConfigKind::StringMap:
			ValidateMap(Value, Key, EJsonType::String, "a string");
			break;
		case EConfigKind::NumberMap:
			ValidateMap(Value, Key, EJsonType::Number, "a number");
			break;
		case EConfigKind::Padding:
			ValidatePadding(Value, Key);
			break;
		case EConfigKind::Folders:
			ValidateFolders(Value, Key, true);
			break;
		case EConfigKind::Settings:
		case EConfigKind::Variables:
		case EConfigKind::ShowFlags:
			Expect(Value, EJsonType::Object, Key); // members: their own readers
			break;
		case EConfigKind::Anything:
			break;
		}
	}

	void ValidateString(const FJsonValue& Value, const FConfigKey& Key)
	{
		if (Expect(Value, EJsonType::String, Key))
		{
			RequireAllowed(Value, Key);
		}
	}

	/** A text that is one of those that the key allows, where it names them. */
	void RequireAllowed(const FJsonValue& Value, const FConfigKey& Key)
	{
		if (Key.Of.empty())
		{
			return;
		}
		const std::vector<std::string> Allowed = SplitText(Key.Of, '|');
		if (!Contains(Allowed, Value.String))
		{
			Messages.Error(ErrorUnknownValue, Value,
				"\"" + Value.String + "\" is not one of " + JoinText(Allowed) +
					Messages.Suggest(Value.String, Allowed));
		}
	}

	void ValidateVector(const FJsonValue& Value, const FConfigKey& Key)
	{
		FConfigVector Vector;
		const auto GetType = [](const FJsonMember& Member)
		{
			return Member.Value.Type;
		};
		if (Contains(Value.Elements, EJsonType::Invalid, &FJsonValue::Type) ||
			Contains(Value.Members, EJsonType::Invalid, GetType))
		{
			return;
		}
		if (Value.Type == EJsonType::Array && Value.Elements.size() != 3)
		{
			Messages.Error(
				ErrorWrongLength, Value, "expected three numbers, found " + std::to_string(Value.Elements.size()));
		}
		else if (!(Key.Kind == EConfigKind::Rotator ? ReadConfigRotator : ReadConfigVector)(Value, Vector))
		{
			ReportVector(Value, Key);
		}
	}

	/** At a member that a rotator does not have, else at the value. */
	void ReportVector(const FJsonValue& Value, const FConfigKey& Key)
	{
		static const std::vector<std::string> Angles = {"Pitch", "Yaw", "Roll"};
		const auto Unknown = std::find_if(Value.Members.begin(), Value.Members.end(),
			[](const FJsonMember& Member) { return !Contains(Angles, Member.Key); });
		if (Key.Kind == EConfigKind::Rotator && Unknown != Value.Members.end() && Value.Find("X") == nullptr)
		{
			Messages.ErrorAtKey(ErrorUnknownKey, Unknown->Value,
				"a rotation has only Pitch, Yaw and Roll, not \"" + Unknown->Key + "\"" +
					Messages.Suggest(Unknown->Key, Angles));
			return;
		}
		WrongType(Value, Key);
	}

	void ValidatePadding(const FJsonValue& Value, const FConfigKey& Key)
	{
		if (Value.Type == EJsonType::Array)
		{
			FConfigKey Sides = Key;
			Sides.Kind = EConfigKind::NumberArray;
			Sides.Length = 4;
			ValidateNumberArray(Value, Sides);
		}
		else if (Value.Type == EJsonType::Object)
		{
			ValidateObject(Value, Key.Of);
		}
		else
		{
			Expect(Value, EJsonType::Number, Key);
		}
	}

	void ValidateFolders(const FJsonValue& Value, const FConfigKey& Key, bool bOrArray)
	{
		if (Value.Type == EJsonType::Array && bOrArray)
		{
			std::for_each(Value.Elements.begin(), Value.Elements.end(),
				[&](const FJsonValue& Element) { ValidateFolders(Element, Key, false); });
		}
		else if (Value.Type == EJsonType::Object && !Key.Of.empty())
		{
			ValidateObject(Value, Key.Of);
		}
		else
		{
			Expect(Value, EJsonType::String, Key);
		}
	}

	void ValidateNumberArray(const FJsonValue& Value, const FConfigKey& Key)
	{
		ValidateElements(
			Value, Key, [&](const FJsonValue& Element) { ExpectElement(Element, EJsonType::Number, "a number"); });
		if (Value.Type == EJsonType::Array && Value.Elements.size() != static_cast<size_t>(Key.Length))
		{
			Messages.Error(ErrorWrongLength, Value,
				"expected " + std::to_string(Key.Length) + " numbers, found " + std::to_string(Value.Elements.size()));
		}
	}

	bool ExpectElement(const FJsonValue& Value, EJsonType Type, const char* Expected)
	{
		if (Value.Type != Type && Value.Type != EJsonType::Invalid)
		{
			Messages.Error(ErrorWrongType, Value, std::string("expected ") + Expected + ", found " + Value.Describe());
		}
		return Value.Type == Type;
	}

	template<typename TFunction>
	void ValidateElements(const FJsonValue& Value, const FConfigKey& Key, const TFunction& Function)
	{
		if (Expect(Value, EJsonType::Array, Key))
		{
			std::for_each(Value.Elements.begin(), Value.Elements.end(), Function);
		}
	}

	void ValidateMap(const FJsonValue& Value, const FConfigKey& Key, EJsonType Type, const char* Expected)
	{
		if (Expect(Value, EJsonType::Object, Key))
		{
			for (const auto& [Name, Member] : Value.Members)
			{
				ExpectElement(Member, Type, Expected);
			}
		}
	}

	FConfigMessages& Messages;
};

} // namespace

void ValidateConfigShape(const FJsonValue& Root, FConfigMessages& Messages)
{
	if (Root.Type != EJsonType::Object)
	{
		Messages.Error(ErrorWrongType, Root, std::string("expected an object, found ") + Root.Describe());
		return;
	}
	FShapeValidator(Messages).ValidateObject(Root, "");
}

} // namespace Drydock
