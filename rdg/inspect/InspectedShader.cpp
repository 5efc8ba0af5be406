// Compiles a shader for looking inside, and finds its resources among a kernel's.
#include "InspectedShader.h"

#include "Diagnostics.h"
#include "RegularFile.h"
#include "ShaderDirectories.h"
#include "ShaderFrontEnd.h"
#include "SpirvQuads.h"
#include "TextTools.h"

#include <algorithm>

namespace Drydock
{

using namespace Spirv;

namespace
{

template<typename T>
int32_t FindNamed(const std::vector<T>& List, const std::string& Name)
{
	for (size_t Slot = 0; Slot < List.size(); ++Slot)
	{
		if (List[Slot].Name == Name)
		{
			return int32_t(Slot);
		}
	}
	return -1; // the optimised shader does not read it
}

int32_t FindSlot(const FSpirvModule& Module, const FSpirvVariable& Variable, const FShaderReflection& Kernel)
{
	const FSpirvType& Type = Module.GetType(Variable.Type);
	switch (Type.Kind)
	{
	case ESpirvType::Sampler:
		return FindNamed(Kernel.Samplers, Variable.Name);
	case ESpirvType::Image:
		return Type.Dim == DimBuffer
				   ? FindNamed(Type.bStorageImage ? Kernel.RWBuffers : Kernel.Buffers, Variable.Name)
				   : FindNamed(Type.bStorageImage ? Kernel.RWTextures : Kernel.Textures, Variable.Name);
	case ESpirvType::Struct:
		break;
	default:
		return -1;
	}
	if (Type.bBufferBlock)
	{
		const bool bReadOnly = !Type.Members.empty() && Type.Members[0].bNonWritable;
		return FindNamed(bReadOnly ? Kernel.Buffers : Kernel.RWBuffers, Variable.Name);
	}
	return FindNamed(Kernel.ConstantBuffers, Type.Name == "$Globals" ? std::string("$Global") : Type.Name);
}

FSpirvModule ReadForInspection(
	const FShaderCompileRequest& Request, bool bKeepFunctions, std::vector<std::string>& Strings)
{
	FShaderCompileRequest Asked = Request;
	Asked.bKeepFunctions = bKeepFunctions;
	const FShaderSource Source = FlattenShader(Asked);
	const std::vector<uint32_t> Words = CompileToSpirv(Source, Asked);
	Strings = Source.Strings;
	return bKeepFunctions ? ReadWholeSpirv(Words) : ReadSpirv(Words);
}

} // namespace

FSpirvSlotTable FindKernelSlots(const FSpirvModule& Module, const FShaderReflection& Kernel)
{
	FSpirvSlotTable Table;
	for (const FSpirvVariable& Variable : Module.Variables)
	{
		Table.Slots.push_back(FindSlot(Module, Variable, Kernel));
	}
	return Table;
}

void FInspectedShader::Read(const FShaderCompileRequest& Request, const FShaderReflection& Kernel)
{
	Module = ReadForInspection(Request, bVariables, Strings);
	if (Kernel.bQuads)
	{
		RunByQuads(Module);
	}
	Program = std::make_unique<FSpirvProgram>(Module);
	Order = HasGroups() ? FindOrder(Module) : FSpirvOrder();
	WaveSize = Module.bQuads ? GQuadSize : uint32_t(Request.Lanes.WaveSize);
}

FInspectedShader::FInspectedShader(
	const FShaderCompileRequest& Request, const FShaderReflection& Kernel, bool bAsKernel)
	: bVariables(!bAsKernel)
{
	try
	{
		if (bVariables)
		{
			Read(Request, Kernel);
		}
	}
	catch (const FSpirvError&)
	{
		// Textures inside structs and the like, which only inlining takes apart.
		bVariables = false;
	}
	try
	{
		if (!bVariables)
		{
			Read(Request, Kernel);
		}
		Slots = FindKernelSlots(Module, Kernel);
	}
	catch (const FSpirvError& Error)
	{
		throw FError(
			{ESeverity::Error, 6020, Error.what(), Error.File, Error.Line, 0, "entry point " + Request.EntryPoint},
			ExitUsage);
	}
	for (const std::string& File : Module.Files)
	{
		FilesOnDisk.emplace(File, FindShaderFile(File));
	}
}

std::string FInspectedShader::GetLine(const std::string& File, int Line) const
{
	const auto [Found, bNew] = Texts.try_emplace(File);
	if (bNew)
	{
		const auto Known = FilesOnDisk.find(File);
		FRegularFile OnDisk(Known != FilesOnDisk.end() ? Known->second : FindShaderFile(File));
		std::string Bytes(OnDisk.GetProblem().empty() ? std::min<size_t>(OnDisk.GetSize(), MaxTextBytes) : 0, '\0');
		Bytes.resize(OnDisk.Read(Bytes.data(), Bytes.size()));
		Found->second = SplitText(NormalizeShaderText(Bytes));
	}
	return Line >= 1 && size_t(Line) <= Found->second.size() ? Found->second[size_t(Line) - 1] : std::string();
}

std::string FInspectedShader::GetTrimmedLine(const std::string& File, int Line) const
{
	return Trim(GetLine(File, Line));
}

} // namespace Drydock
