// Samples with a clamp of their level: glslang's tree has them from GLSL, its HLSL knows no such form. The call without
// the clamp is made by glslang, and its node then gets the clamp. Source: Direct3D 11.3 functional
// specification, 22.4.17 (the clamp is behind the offset, a status of tiled resources behind the clamp).
#include "FrontEndSamples.h"

namespace Drydock
{

namespace
{

struct FMethod
{
	std::string_view Name;
	size_t NumArguments; // with the texture, without offset, clamp and status
	bool bClamps = false;
	bool bFourOffsets = false;
};

constexpr std::string_view MethodPrefix = "__BI_"; // glslang's
constexpr FMethod Methods[] = {{"Sample", 3, true}, {"SampleBias", 4, true}, {"SampleGrad", 5, true},
	{"SampleCmp", 4, true}, {"SampleLevel", 4}, {"SampleCmpLevelZero", 4}, {"Load", 2}, {"Gather", 3},
	{"GatherRed", 3, false, true}, {"GatherGreen", 3, false, true}, {"GatherBlue", 3, false, true},
	{"GatherAlpha", 3, false, true}, {"GatherCmp", 4}, {"GatherCmpRed", 4, false, true}};

/** The sample among the nodes that glslang made of the call: what a texture gives may be converted or picked from. */
class FSampleFinder final : public TIntermTraverser
{
public:
	bool visitAggregate(TVisit, TIntermAggregate* Node) override
	{
		const TOperator Operator = Node->getOp();
		const bool bSample = Operator == EOpTexture || Operator == EOpTextureOffset || Operator == EOpTextureGrad ||
							 Operator == EOpTextureGradOffset;
		Found = !Found && bSample ? Node : Found;
		return !Found;
	}

	TIntermAggregate* Found = nullptr;
};

TOperator GetClamped(TOperator Operator)
{
	return Operator == EOpTexture         ? EOpTextureClamp
		   : Operator == EOpTextureOffset ? EOpTextureOffsetClamp
		   : Operator == EOpTextureGrad   ? EOpTextureGradClamp
										  : EOpTextureGradOffsetClamp;
}

} // namespace

const char* GetMethodName(const TFunction& Function)
{
	const std::string_view Name = Function.getName().c_str();
	return Name.data() + (Name.starts_with(MethodPrefix) ? MethodPrefix.size() : 0);
}

ESampleForm FindSampleForm(const TFunction& Function, const FNodes& Nodes)
{
	const std::string_view Name = GetMethodName(Function);
	const bool bMethod = Name.size() < Function.getName().size() && !Nodes.empty() && Nodes[0]->getType().isTexture() &&
						 !Nodes[0]->getType().getSampler().isMultiSample();
	for (const FMethod& Method : Methods)
	{
		if (!bMethod || Name != Method.Name)
		{
			continue;
		}
		const TSamplerDim Dim = Nodes[0]->getType().getSampler().dim;
		const size_t NumOffsets = Dim != EsdCube && Dim != EsdBuffer ? 1 : 0;
		const size_t NumWithClamp = Method.NumArguments + NumOffsets + Method.bClamps;
		const bool bFour = Method.bFourOffsets && Nodes.size() == Method.NumArguments + 4;
		return Nodes.size() > NumWithClamp && !bFour            ? ESampleForm::Status
			   : Nodes.size() == NumWithClamp && Method.bClamps ? ESampleForm::Clamp
																: ESampleForm::Known;
	}
	return ESampleForm::Known;
}

TFunction* MakeWithoutLast(TFunction& Function)
{
	TFunction* const Made = new TFunction(&Function.getName(), Function.getType(), Function.getBuiltInOp());
	for (int i = 0; i + 1 < Function.getParamCount(); ++i)
	{
		TParameter Parameter = {Function[i].name, new TType, nullptr};
		Parameter.type->shallowCopy(*Function[i].type);
		Made->addParameter(Parameter);
	}
	return Made;
}

bool AddClamp(const FBuilder& Build, TIntermTyped* Sample, TIntermTyped* Clamp)
{
	FSampleFinder Finder;
	Sample->traverse(&Finder);
	TIntermTyped* const Level = Build.Construct(TType(EbtFloat), {Clamp});
	if (!Finder.Found || !Level)
	{
		return false;
	}
	TIntermSequence& Arguments = Finder.Found->getSequence();
	const bool bGrad = Finder.Found->getOp() == EOpTextureGrad || Finder.Found->getOp() == EOpTextureGradOffset;
	const TSampler& Sampler = Arguments[0]->getAsTyped()->getType().getSampler();
	// The reference of cube arrays has no place left among the coordinates; a bias is behind the clamp.
	const bool bOwnReference = Sampler.shadow && Sampler.arrayed && Sampler.dim == EsdCube;
	const size_t NumBeforeBias = Finder.Found->getOp() == EOpTextureOffset || bOwnReference ? 3 : 2;
	const size_t At = bGrad ? Arguments.size() : NumBeforeBias;
	Arguments.insert(Arguments.begin() + std::ptrdiff_t(At), Level);
	Finder.Found->setOperator(GetClamped(Finder.Found->getOp()));
	return true;
}

} // namespace Drydock
