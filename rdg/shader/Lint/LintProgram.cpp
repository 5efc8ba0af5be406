// Walks the statements and values of a program.
#include "LintProgram.h"

#include <algorithm>
#include <array>

namespace Drydock
{

namespace
{

using namespace Hlsl;

class FProgramLinter
{
public:
	explicit FProgramLinter(const FProgram& InProgram)
		: Program(InProgram)
	{
	}

	std::vector<FProgramFinding> Run()
	{
		for (const FVariable* const Static : Program.Statics)
		{
			Look(Static->Initializer);
		}
		for (const FFunction* const Function : Program.Functions)
		{
			Look(Function->Body);
		}
		return std::move(Findings);
	}

private:
	void Look(const FCode* Code)
	{
		if (!Code)
		{
			return;
		}
		Look(Code->Value);
		Look(Code->Next);
		Look(Code->Variable && Code->Kind == EStep::Variable ? Code->Variable->Initializer : nullptr);
		for (const FCode* const Step : Code->Body)
		{
			Look(Step);
		}
		for (const FCase& Case : Code->Cases)
		{
			for (const FCode* const Step : Case.Body)
			{
				Look(Step);
			}
		}
	}

	void Look(const FValue* Value)
	{
		if (!Value)
		{
			return;
		}
		switch (Value->Kind)
		{
		case EValue::Assign:
		case EValue::Modify:
		case EValue::Step:
			LookAtTarget(Value->Operands[0]);
			break;
		case EValue::Call:
			LookAtArguments(*Value);
			break;
		case EValue::Intrinsic:
			LookAtName(*Value, std::array{"ddx", "ddy", "ddx_coarse", "ddy_coarse", "ddx_fine", "ddy_fine", "fwidth"});
			break;
		case EValue::Method:
			LookAtName(*Value, std::array{"Sample", "SampleBias", "SampleCmp", "CalculateLevelOfDetail"});
			break;
		default:
			break;
		}
		for (const FValue* const Operand : Value->Operands)
		{
			Look(Operand);
		}
	}

	void LookAtArguments(const FValue& Call)
	{
		const std::vector<FVariable*>& Parameters = Call.Function->Parameters;
		for (size_t i = 0; i < std::min(Parameters.size(), Call.Operands.size()); ++i)
		{
			if (Parameters[i]->Modifiers & ModifierOut)
			{
				LookAtTarget(Call.Operands[i]);
			}
		}
	}

	/** Whether what is written is a part of a texel. */
	void LookAtTarget(const FValue* Target)
	{
		bool bPart = false;
		while (Target->Kind == EValue::Swizzle || Target->Kind == EValue::Index || Target->Kind == EValue::Member)
		{
			const FType& Whole = *Target->Operands[0]->Type;
			bPart = bPart || Target->Kind != EValue::Swizzle || Target->Parts.size() < Whole.NumComponents();
			Target = Target->Operands[0];
		}
		const FType* const Resource = Target->Kind == EValue::Element ? Target->Operands[0]->Type : nullptr;
		if (bPart && Resource && Resource->IsObject() &&
			(IsTexture(Resource->Object) || Resource->Object == EObject::RWBuffer))
		{
			Findings.push_back({"partial-uav-store", Target->Place, {}});
		}
	}

	template<size_t Count>
	void LookAtName(const FValue& Value, const std::array<const char*, Count>& Names)
	{
		if (Program.Stage == EStage::Compute && std::ranges::find(Names, Value.Name) != Names.end())
		{
			Findings.push_back({"derivative-compute", Value.Place, Value.Name});
		}
	}

	const FProgram& Program;
	std::vector<FProgramFinding> Findings;
};

} // namespace

std::vector<FProgramFinding> LookAtProgram(const FProgram& Program)
{
	return FProgramLinter(Program).Run();
}

} // namespace Drydock
