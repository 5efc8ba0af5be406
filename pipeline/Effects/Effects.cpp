// Holds the table of effects and walks it: every question to all effects is a loop over it.
#include "Effects/Effects.h"

#include "PostProcessSettingsReflection.h"
#include "SceneRendering.h"

#include <algorithm>
#include <array>

namespace Drydock
{

namespace
{

constexpr std::array<const FEffect*, static_cast<size_t>(EEffect::Num)> Table = {
#define DRYDOCK_EFFECT(Name) &G##Name##Effect,
#include "Effects/EffectList.inl"
#undef DRYDOCK_EFFECT
};

struct FClaimed
{
	const FEffect* Effect = nullptr;
	const FSettingClaim* Claim = nullptr;
};

FClaimed FindClaim(std::string_view Setting)
{
	FClaimed Found;
	for (const FEffect* const Effect : Table)
	{
		for (const FSettingClaim& Claim : *Effect->Settings)
		{
			const bool bLonger = Found.Claim == nullptr || Claim.Beginning.size() > Found.Claim->Beginning.size();
			if (Setting.starts_with(Claim.Beginning) && bLonger)
			{
				Found = {Effect, &Claim};
			}
		}
	}
	return Found;
}

FContentQuestions AskOf(const FGateInputs& Gate, const FEffectDecision& Decision)
{
	const auto Ask = Decision.Effect->Content->Ask;
	return Decision.bActive && Ask != nullptr ? Ask(Gate, Decision) : FContentQuestions();
}

} // namespace

FEffectTable GetEffects()
{
	return Table;
}

const FEffect* FindEffectByName(std::string_view Name)
{
	const auto Found = std::ranges::find_if(Table, [&](const FEffect* Effect) { return *Effect->Name == Name; });
	return Found == Table.end() ? nullptr : *Found;
}

std::string FEffectDecision::GetName() const
{
	return *Effect->Name;
}

EEffect FEffectDecision::GetId() const
{
	return Effect->Id;
}

const FEffectDecision* FindEffect(const std::vector<FEffectDecision>& Effects, EEffect Id)
{
	const auto Found =
		std::ranges::find_if(Effects, [Id](const FEffectDecision& Effect) { return Effect.GetId() == Id; });
	return Found == Effects.end() ? nullptr : &*Found;
}

bool IsEffectActive(const std::vector<FEffectDecision>& Effects, EEffect Id)
{
	const FEffectDecision* const Effect = FindEffect(Effects, Id);
	return Effect != nullptr && Effect->bActive;
}

bool FEffectInputs::IsNamed(std::string_view Beginning) const
{
	return std::ranges::any_of(
		Conditions.NamedSettings, [&](const std::string& Setting) { return Setting.starts_with(Beginning); });
}

std::string FEffectInputs::DescribeGate(std::string_view Beginning) const
{
	const auto Found = std::ranges::find_if(
		Conditions.Gates, [&](const FSettingGate& Gate) { return Gate.Setting.starts_with(Beginning); });
	return Found == Conditions.Gates.end() ? "" : ": " + Found->Reason;
}

std::string FEffectInputs::FindShowFlagOff(bool bFlag, const char* Flag) const
{
	const char* const Off = !Conditions.ShowFlags.PostProcessing ? "PostProcessing" : bFlag ? nullptr : Flag;
	return Off == nullptr ? "" : std::string("ShowFlag.") + Off + " is off";
}

std::optional<FIntRect> FEffectPassInputs::GetRegion() const
{
	return SceneColor.ViewRect.Size() == View.ViewRect.Size() ? Decision.Region : std::nullopt;
}

std::vector<FEffectDecision> DecideBySettings(const FEffectInputs& Inputs, FEffectTable Effects)
{
	std::vector<FEffectDecision> Decided;
	for (const FEffect* const Effect : Effects)
	{
		Decided.push_back((*Effect->Decide)(*Effect, Inputs));
		Decided.back().Effect = Effect;
	}
	return Decided;
}

FContentQuestions AskContent(const FEffectInputs& Inputs, const std::vector<FEffectDecision>& Decided)
{
	FContentQuestions Questions;
	if (Inputs.Conditions.bNoSkip || Inputs.Conditions.bOverlaid)
	{
		return Questions;
	}
	const FViewContent Unknown;
	for (const FEffectDecision& Decision : Decided)
	{
		const FContentQuestions Asked = AskOf({Inputs, Unknown, Decided, Decided}, Decision);
		Questions.bToon |= Asked.bToon;
		Questions.bGlowMask |= Asked.bGlowMask;
		Questions.bStill |= Asked.bStill;
		Questions.bBrightest |= Asked.bBrightest;
	}
	return Questions;
}

std::vector<FEffectDecision> GateByContent(
	const FEffectInputs& Inputs, const FViewContent& Content, const std::vector<FEffectDecision>& Decided)
{
	std::vector<FEffectDecision> Gated = Decided;
	for (FEffectDecision& Decision : Gated)
	{
		if (const auto Gate = Decision.Effect->Content->Gate; Gate != nullptr && Decision.bActive)
		{
			Gate({Inputs, Content, Decided, Gated}, Decision);
		}
	}
	return Gated;
}

std::vector<FEffectDecision> NoteContentUnseen(
	const FEffectInputs& Inputs, const std::vector<FEffectDecision>& Decided, const std::string& Why)
{
	const FViewContent Unknown;
	std::vector<FEffectDecision> Noted = Decided;
	for (FEffectDecision& Decision : Noted)
	{
		if (AskOf({Inputs, Unknown, Decided, Decided}, Decision).Any())
		{
			Decision.Reason += "; " + Why;
		}
	}
	return Noted;
}

std::vector<FEffectDecision> CompleteReasons(const FEffectInputs& Inputs, std::vector<FEffectDecision> Effects)
{
	const std::vector<FEffectDecision> Outcome = Effects;
	for (FEffectDecision& Decision : Effects)
	{
		if (const auto Complete = *Decision.Effect->Complete; Complete != nullptr && Decision.bActive)
		{
			Decision.Reason += Complete(Inputs, Outcome);
		}
	}
	return Effects;
}

std::vector<FEffectDecision> DecideEffects(const FEffectInputs& Inputs, const FViewContent& Content)
{
	return CompleteReasons(Inputs, GateByContent(Inputs, Content, DecideBySettings(Inputs)));
}

double GetScreenPercentage(const FViewConditions& Conditions)
{
	return Conditions.ShowFlags.ScreenPercentage ? Conditions.ScreenPercentage : 100.0;
}

FFiguresByEffect MeasureEffects(const std::vector<FEffectDecision>& Effects, const FMeasureInputs& Inputs)
{
	FFiguresByEffect Figures;
	for (const FEffectDecision& Decision : Effects)
	{
		const auto Measure = Decision.Effect->Measurement->Measure;
		const std::span<const char* const> Names = Decision.Effect->Measurement->Textures;
		const bool bKept =
			std::ranges::all_of(Names, [&](const char* Name) { return Inputs.Textures.count(Name) != 0; });
		if (Decision.bActive && Measure != nullptr && bKept)
		{
			Figures[Decision.GetId()] = Measure(Inputs);
		}
	}
	return Figures;
}

const FEffect* FindSettingOwner(std::string_view Setting)
{
	return FindClaim(Setting).Effect;
}

std::string GetSettingNotBuiltReason(std::string_view Setting)
{
	const FSettingField* const Field = FindSettingField(std::string(Setting));
	if (Field != nullptr && Field->AddedId != 0)
	{
		return ""; // who added it reads it
	}
	const FClaimed Found = FindClaim(Setting);
	return Found.Claim == nullptr ? NoPassReadsIt : Found.Claim->NotBuilt;
}

std::vector<const FEffectDecision*> FindEffectsAt(EChainPlace Place, const std::vector<FEffectDecision>& Effects)
{
	std::vector<const FEffectDecision*> Found;
	for (const FEffectDecision& Decision : Effects)
	{
		if ((Decision.bActive || Decision.bNothingToDo) && (*Decision.Effect->GetPlace)().Place == Place)
		{
			Found.push_back(&Decision);
		}
	}
	std::ranges::stable_sort(Found, [](const FEffectDecision* A, const FEffectDecision* B)
		{ return (*A->Effect->GetPlace)().Turn < (*B->Effect->GetPlace)().Turn; });
	return Found;
}

} // namespace Drydock
