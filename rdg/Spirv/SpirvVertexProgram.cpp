// Vertex shaders through the interpreter: attributes in, clip position and TEXCOORDs out.
#include "SpirvInterpreterImpl.h"

#include "Diagnostics.h"
#include "Math/ToInteger.h"

#include <utility>

namespace Drydock
{

using namespace Spirv;

FSpirvInterpreterImpl::FScalars FSpirvInterpreterImpl::LoadAttribute(const FSpirvVariable& Variable) const
{
	const double(&Attribute)[4] = Vertex->Attributes[GetSemanticIndex(Variable.Semantic, "ATTRIBUTE")];
	const ESpirvType Kind = Module.GetScalarKind(Variable.Type, 0);
	FScalars Result;
	for (uint32_t i = 0; i < Module.GetType(Variable.Type).NumScalars; ++i)
	{
		Result.push_back(Kind == ESpirvType::Float ? ToBits(float(Attribute[i]))
						 : Kind == ESpirvType::Int ? uint32_t(ToInteger<int32_t>(Attribute[i]))
												   : ToInteger<uint32_t>(Attribute[i]));
	}
	return Result;
}

FVertexOutput FSpirvInterpreterImpl::RunVertex(const FKernelArgs& InArgs, const FVertexInput& Input, uint64_t MaxSteps)
{
	if (Module.ExecutionModel != ExecutionModelVertex)
	{
		Module.Fail("this is no vertex shader");
	}
	Args = &InArgs;
	Vertex = &Input;
	RunThread(MaxSteps);
	FVertexOutput Output;
	for (const FSpirvVariable& Variable : Module.Variables)
	{
		const int32_t TexCoord = GetTexCoordIndex(Variable.Semantic);
		const bool bPosition = Variable.BuiltIn == BuiltInPosition;
		if (Variable.Storage != StorageOutput || (!bPosition && TexCoord < 0))
		{
			continue;
		}
		const FScalars& Scalars = Memory[Variable.Id];
		const FSpirvType& Type = Module.GetType(Variable.Type);
		const size_t Size = Type.Kind == ESpirvType::Array ? Module.GetType(Type.Element).NumScalars : Scalars.size();
		for (size_t i = 0; i < Scalars.size(); ++i)
		{
			const size_t Index = size_t(std::max(0, TexCoord)) + i / Size;
			if (bPosition ? i < 4 : Index < size_t(GMaxTexCoords) && i % Size < 4)
			{
				(bPosition ? Output.Position[i] : Output.TexCoords[Index][i % Size]) = ToFloat(Scalars[i]);
			}
		}
	}
	return Output;
}

FVertexOutput FSpirvInterpreter::RunVertex(const FKernelArgs& Args, const FVertexInput& Input, uint64_t MaxSteps)
{
	return Impl->RunVertex(Args, Input, MaxSteps);
}

namespace
{

class FSpirvVertexProgram final : public FVertexProgram
{
public:
	FSpirvVertexProgram(FSpirvModule&& InModule, FSpirvReflection&& InReflection)
		: Module(std::move(InModule))
		, Reflection(std::move(InReflection))
	{
	}

	FVertexOutput Run(const FKernelArgs& Args, const FVertexInput& Input) const override
	{
		try
		{
			return FSpirvInterpreter(Module, Reflection).RunVertex(Args, Input);
		}
		catch (const FSpirvError& Error)
		{
			throw FError(
				{ESeverity::Error, 6020, Error.what(), Error.File, Error.Line, 0, "a vertex shader"}, ExitUsage);
		}
	}
	uint32_t GetAttributesRead() const override { return Reflection.AttributesRead; }
	uint32_t GetTexCoordsWritten() const override { return Reflection.TexCoordsWritten; }

private:
	FSpirvModule Module;
	FSpirvReflection Reflection;
};

} // namespace

std::shared_ptr<const FVertexProgram> MakeVertexProgram(FSpirvModule Module, FSpirvReflection Reflection)
{
	return std::make_shared<FSpirvVertexProgram>(std::move(Module), std::move(Reflection));
}

} // namespace Drydock
