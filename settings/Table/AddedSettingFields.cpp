// Makes fields of the settings that plugins add.
#include "AddedSettingFields.h"

#include "PostProcessSettingErrors.h"
#include "PostProcessSettingsBlending.h"
#include "PostProcessSettingsReflection.h"
#include "RunningCode.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <map>
#include <memory>
#include <strings.h>

namespace Drydock
{

namespace
{

/** Texts of a field, which outlive the plugin's own. */
struct FOwnedTexts
{
	FAddedSetting Setting;
	std::string OverrideName;
	std::vector<const char*> EnumNames;
	std::string Plugin;
};

/** Never destroyed: libraries unregister at the very end of the program. */
struct FAddedState
{
	std::map<uint32, std::unique_ptr<FOwnedTexts>> Owned;
	std::vector<FDiagnostic> Problems;
	uint32 LastId = 0;
};

FAddedState& GetState()
{
	static auto* const State = new FAddedState;
	return *State;
}

/** Calls Function with a value of the type that an added setting of this kind has; of an enum its number. */
template<typename TFunction>
auto WithType(ESettingType Type, const TFunction& Function)
{
	switch (Type)
	{
	case ESettingType::Bool:
		return Function(bool());
	case ESettingType::Int:
	case ESettingType::Enum:
		return Function(int32());
	case ESettingType::Color:
		return Function(FLinearColor());
	case ESettingType::Vector2:
		return Function(FVector2D(0.0, 0.0));
	case ESettingType::Vector4:
		return Function(FVector4(0.0, 0.0, 0.0, 0.0));
	case ESettingType::Float:
	case ESettingType::Object:
	case ESettingType::ColorArray:
		break;
	}
	return Function(float());
}

/** As its C++ type holds it: a float, a whole number. */
FSettingValue Normalize(ESettingType Type, const FSettingValue& Value)
{
	return WithType(Type,
		[&]<typename T>(T Typed)
		{
			TSettingTraits<T>::Store(Typed, Value);
			FSettingValue Packed = TSettingTraits<T>::Pack(Typed);
			Packed.Type = Type;
			return Packed;
		});
}

FSettingValue Blend(const FSettingValue& From, const FSettingValue& To, float Weight, ESettingBlend Rule)
{
	return WithType(From.Type,
		[&]<typename T>(T Target)
		{
			T Source = Target;
			TSettingTraits<T>::Store(Target, From);
			TSettingTraits<T>::Store(Source, To);
			BlendValue(Target, Source, Weight, Rule);
			FSettingValue Packed = TSettingTraits<T>::Pack(Target);
			Packed.Type = From.Type;
			return Packed;
		});
}

bool Interpolates(ESettingType Type)
{
	return WithType(Type, []<typename T>(T) { return TIsInterpolable<T>; });
}

int32 CountComponents(ESettingType Type)
{
	return Type == ESettingType::Vector2 ? 2 : Type == ESettingType::Vector4 || Type == ESettingType::Color ? 4 : 1;
}

FSettingField MakeAddedField(uint32 Id, const FOwnedTexts& Texts)
{
	const FAddedSetting& Setting = Texts.Setting;
	const FSettingValue Default = Normalize(Setting.Type, Setting.Default);
	const auto Get = [Id, Default](const FPostProcessSettings& Settings)
	{
		const FAddedSettings::FEntry* const Entry = Settings.AddedSettings.Find(Id);
		return Entry != nullptr ? Entry->Value : Default;
	};
	const auto Set = [Id, Default, Get](FPostProcessSettings& Settings, const FSettingValue& Value)
	{
		const FSettingValue Wanted = Normalize(Default.Type, Value);
		if (!(Get(Settings) == Wanted))
		{
			Settings.AddedSettings.Edit(Id, Default).Value = Wanted;
		}
	};
	const auto BlendBy = [Get, Set](ESettingBlend Rule)
	{
		return [Get, Set, Rule](FPostProcessSettings& Settings, const FPostProcessSettings& Source, float Weight)
		{
			Set(Settings, Blend(Get(Settings), Get(Source), Weight, Rule));
		};
	};
	return {
		.Name = Setting.Name.c_str(),
		.Type = Setting.Type,
		.Range = {Setting.Min, Setting.Max, Setting.Min, Setting.Max},
		.Unit = Setting.Unit.c_str(),
		.Category = Setting.Category.c_str(),
		.Blend = Setting.Blend,
		.Doc = Setting.Doc.c_str(),
		.Default = Default,
		.EnumNames = TConstArrayView<const char*>(Texts.EnumNames.data(), static_cast<int32>(Texts.EnumNames.size())),
		.OverrideName = Texts.OverrideName.c_str(),
		.ObjectClass = "",
		.bInterpolates = Interpolates(Setting.Type),
		.Get = Get,
		.Set = Set,
		.IsOverridden =
			[Id](const FPostProcessSettings& Settings)
		{
			const FAddedSettings::FEntry* const Entry = Settings.AddedSettings.Find(Id);
			return Entry != nullptr && Entry->bOverridden;
		},
		.SetOverridden =
			[Id, Default](FPostProcessSettings& Settings, bool bOverridden)
		{
			if (bOverridden || Settings.AddedSettings.Find(Id) != nullptr)
			{
				Settings.AddedSettings.Edit(Id, Default).bOverridden = bOverridden;
			}
		},
		.BlendFrom = BlendBy(Setting.Blend),
		.LerpFrom = BlendBy(ESettingBlend::Lerp),
		.FindOrAddObject = nullptr,
		.AddedId = Id,
	};
}

/** The mistake in the setting itself; empty if there is none. */
std::string FindFault(const FAddedSetting& Setting)
{
	const std::string& Name = Setting.Name;
	const bool bName = !Name.empty() && std::isdigit(static_cast<unsigned char>(Name[0])) == 0 &&
					   std::all_of(Name.begin(), Name.end(),
						   [](unsigned char Character) { return std::isalnum(Character) != 0 || Character == '_'; });
	if (!bName || strncasecmp(Name.c_str(), "bOverride_", 10) == 0)
	{
		return "its name must be letters, digits and _, not begin with a digit, nor with bOverride_";
	}
	if (!(Setting.Min <= Setting.Max))
	{
		return "its range is empty: the least value is above the greatest, or one of them is not a number";
	}
	for (int32 Index = 0; Index < CountComponents(Setting.Type); ++Index)
	{
		const double Component = Setting.Default.Components[Index];
		if (!std::isfinite(Component) || Component < Setting.Min || Component > Setting.Max)
		{
			return "its default is outside its range, or not finite";
		}
	}
	const double Number = Setting.Default.Components[0];
	if (Setting.Type == ESettingType::Enum &&
		!(Number >= 0.0 && Number < static_cast<double>(Setting.EnumNames.size())))
	{
		return "it is an enum, whose EnumNames name the values from 0 on, and its default is none of them";
	}
	if (Setting.Blend == ESettingBlend::Accumulate || Setting.Blend == ESettingBlend::LUT)
	{
		return std::string("the blend rule ") + ToString(Setting.Blend) +
			   " belongs to cubemaps and lookup tables; expected Lerp, Set, SetIfNonZero or FocalDistance";
	}
	if (!Interpolates(Setting.Type) &&
		(Setting.Blend == ESettingBlend::Lerp || Setting.Blend == ESettingBlend::FocalDistance))
	{
		return std::string("there is nothing between two values of a ") + ToString(Setting.Type) +
			   "; expected the blend rule Set or SetIfNonZero";
	}
	return "";
}

/** Who has a setting of that name, ignoring case, as engine text does; empty: nobody. */
std::string FindOwner(const std::string& Name)
{
	if (strcasecmp(Name.c_str(), "WeightedBlendables") == 0)
	{
		return "FPostProcessSettings";
	}
	for (const FSettingField& Field : GetSettingFields())
	{
		if (strcasecmp(Field.Name, Name.c_str()) == 0 || strcasecmp(Field.OverrideName, Name.c_str()) == 0)
		{
			return Field.AddedId == 0 ? "FPostProcessSettings" : GetState().Owned[Field.AddedId]->Plugin;
		}
	}
	return "";
}

} // namespace

uint32 AddSettingField(const FAddedSetting& Setting)
{
	const FCodeOwner* const Running = GetRunningCode();
	const std::string Plugin = Running != nullptr && Running->IsForeign() ? "plugin " + Running->Plugin : "the program";
	const std::string Fault = FindFault(Setting);
	const std::string Owner = FindOwner(Setting.Name);
	if (!Fault.empty() || !Owner.empty())
	{
		GetState().Problems.push_back({ESeverity::Error, Fault.empty() ? ErrorSettingTaken : ErrorSettingInvalid,
			"the setting " + Setting.Name + " of " + Plugin +
				(Fault.empty() ? " cannot be added: " + Owner + " has one of that name"
							   : " cannot be added: " + Fault)});
		return 0;
	}
	const uint32 Id = ++GetState().LastId;
	auto Texts = std::make_unique<FOwnedTexts>(FOwnedTexts{Setting, "bOverride_" + Setting.Name, {}, Plugin});
	for (const std::string& Name : Texts->Setting.EnumNames)
	{
		Texts->EnumNames.push_back(Name.c_str());
	}
	GetMutableSettingFields().push_back(MakeAddedField(Id, *Texts));
	GetState().Owned.emplace(Id, std::move(Texts));
	return Id;
}

void RemoveSettingField(uint32 Id)
{
	if (Id != 0)
	{
		std::erase_if(GetMutableSettingFields(), [Id](const FSettingField& Field) { return Field.AddedId == Id; });
		GetState().Owned.erase(Id);
	}
}

std::vector<FDiagnostic> TakeSettingProblems()
{
	return std::exchange(GetState().Problems, {});
}

} // namespace Drydock
