// Emits what a shader gets from the pipeline and gives to it: positions, interpolants, render targets.
#include "SpirvEmitter.h"

#include "SpirvLimits.h"

namespace Drydock
{

using namespace Spirv;

std::vector<FEmitScalar> FSpirvEmitter::LoadInput(const FSpirvVariable& Variable)
{
	if (bGroups)
	{
		return LoadGroupInput(Variable);
	}
	if (Module.bQuads)
	{
		return LoadQuadInput(Variable);
	}
	const int32_t* const Group = Reflection.Reflection.GroupSize;
	const auto GroupX = [&](bool bRemainder)
	{
		return std::string(bRemainder ? "IntRemainder" : "IntDivide") + "(AsUint(X), " + Number(uint32_t(Group[0])) +
			   "u)";
	};
	const auto Uniform = [&](const char* Name, int Axis, const char* Operator) -> FEmitScalar
	{
		return {std::string("uint32_t(") + Name + ") " + Operator + " " + std::to_string(Group[Axis]) + "u", Uint,
			false, -1, EEmitLevel::Row};
	};
	switch (Variable.BuiltIn)
	{
	case BuiltInGlobalInvocationId:
		return {{"AsUint(X)", Uint, true, -1}, {"uint32_t(Y)", Uint, false, -1, EEmitLevel::Row},
			{"uint32_t(Z)", Uint, false, -1, EEmitLevel::Row}};
	case BuiltInWorkgroupId:
		return {{GroupX(false), Uint, true, -1}, Uniform("Y", 1, "/"), Uniform("Z", 2, "/")};
	case BuiltInLocalInvocationId:
		return {{GroupX(true), Uint, true, -1}, Uniform("Y", 1, "%"), Uniform("Z", 2, "%")};
	case BuiltInLocalInvocationIndex:
	{
		const std::string Rows =
			"(" + Uniform("Z", 2, "%").Text + ") * " + std::to_string(Group[1]) + "u + " + Uniform("Y", 1, "%").Text;
		return {{GroupX(true) + " + U((" + Rows + ") * " + std::to_string(Group[0]) + "u)", Uint, true, -1}};
	}
	case BuiltInFragCoord:
		return {{"ToReal<Real>(X) + R(Real(0.5f))", Float, true, -1},
			{"Real(Y) + Real(0.5f)", Float, false, -1, EEmitLevel::Row}, {"Real(0.0f)", Float, false, -1},
			{"Real(1.0f)", Float, false, -1}};
	case BuiltInFrontFacing:
		return {{"true", ESpirvType::Bool, false, -1}};
	default:
	{
		return LoadInterpolant(Variable, "Interpolate<Real>(", ", X, Y)");
	}
	}
}

std::vector<FEmitScalar> FSpirvEmitter::LoadInterpolant(
	const FSpirvVariable& Variable, const std::string& Before, const std::string& Behind) const
{
	std::vector<FEmitScalar> Result;
	const ESpirvType Kind = Module.GetScalarKind(Variable.Type, 0);
	const std::string Interpolant = "Args.Interpolants[" + std::to_string(GetInterpolantIndex(Variable)) + "]";
	for (uint32_t i = 0; i < Module.GetType(Variable.Type).NumScalars; ++i)
	{
		// Integers are the same everywhere.
		const std::string Base = Interpolant + ".Base[" + Number(i) + "]";
		Result.push_back(Kind == Float  ? FEmitScalar{Before + Interpolant + ", " + Number(i) + Behind, Float, true, -1}
						 : Kind == Uint ? FEmitScalar{"uint32_t(" + Base + ")", Uint, false, -1}
										: FEmitScalar{"int32_t(" + Base + ")", Kind, false, -1});
	}
	return Result;
}

void FSpirvEmitter::EmitOutputs()
{
	for (const FSpirvVariable& Variable : Module.Variables)
	{
		if (Variable.Storage != StorageOutput)
		{
			continue;
		}
		if (DynamicVariables.count(Variable.Id))
		{
			Module.Fail("shader output '" + Variable.Name + "' cannot be indexed at run time on the CPU tier");
		}
		std::string Value;
		const ESpirvType Kind = Module.GetScalarKind(Variable.Type, 0);
		const bool bInteger = Kind != Float;
		for (uint32_t i = 0; i < 4; ++i)
		{
			const bool bWritten = i < Module.GetType(Variable.Type).NumScalars;
			const FEmitScalar Part =
				bWritten ? FEmitScalar{"l" + Number(Variable.Id) + "_" + Number(i), Kind, true, -1} : Literal(Kind, 0);
			const std::string Text = UseAs(Part, bInteger ? Uint : Float, true);
			Value += ", " + (Variable.BuiltIn == BuiltInFragDepth ? "Saturate(" + Text + ")" : Text);
		}
		const std::string Target = Number(Variable.Location);
		if (Module.bQuads)
		{
			Line("if (" + Target + " < Args.NumTargets)");
			Line("{");
			Line("\tStoreTargetQuads<Real, N>(e & Live, Args.Targets[" + Target + "], X0, Y0" + Value + ");");
			Line("\tCountLanesOf(Args, &FKernelCounters::Stores, e & Live);");
			Line("}");
			continue;
		}
		const std::string Whole = "h" + Target;
		if (!bInteger && Declared.insert(Whole).second)
		{
			Handles += "\tconst EWholeTexels " + Whole + " = " + Target +
					   " < Args.NumTargets ? GetWholeTexels<Real, N>(Args.Targets[" + Target +
					   "]) : EWholeTexels::None;\n";
		}
		Line("if (" + Target + " < Args.NumTargets)");
		Line("{");
		Line(bInteger ? "\tStoreTarget<Real, N>(e, Args.Targets[" + Target + "], X0, Y, TVec<TUint<N>, 4>(" +
							Value.substr(2) + "));"
					  : "\tStoreTarget<Real, N>(e, " + Whole + ", Args.Targets[" + Target + "], X0, Y" + Value + ");");
		Line("\tCountLanesOf(Args, &FKernelCounters::Stores, e);");
		Line("}");
	}
}

} // namespace Drydock
