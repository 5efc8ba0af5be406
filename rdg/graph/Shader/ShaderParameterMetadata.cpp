// Flattens the metadata of parameter structs to the members that HLSL sees, and looks them up. The names are the
// engine's.
#include "ShaderParameterMetadata.h"

#include "RangeTools.h"
#include "UniformBufferStructs.h"

#include <algorithm>
#include <atomic>
#include <cstring>
#include <map>
#include <mutex>

namespace Drydock
{

namespace
{

struct FUniformBufferRegistry
{
	std::mutex Mutex;
	std::vector<const FUniformBufferStructRegistrar*> Entries;

	static FUniformBufferRegistry& Get()
	{
		static FUniformBufferRegistry* Registry =
			new FUniformBufferRegistry; // outlives registrars of any shared object
		return *Registry;
	}
};

} // namespace

FUniformBufferStructRegistrar::FUniformBufferStructRegistrar(const char* InHlslName, FGetMetadata InGetMetadata)
	: HlslName(InHlslName)
	, GetMetadata(InGetMetadata)
{
	FUniformBufferRegistry& Registry = FUniformBufferRegistry::Get();
	std::lock_guard Lock(Registry.Mutex);
	Registry.Entries.push_back(this);
}

FUniformBufferStructRegistrar::~FUniformBufferStructRegistrar()
{
	FUniformBufferRegistry& Registry = FUniformBufferRegistry::Get();
	std::lock_guard Lock(Registry.Mutex);
	std::erase(Registry.Entries, this);
}

const FShaderParametersMetadata* FindUniformBufferStruct(const std::string& HlslName)
{
	FUniformBufferRegistry& Registry = FUniformBufferRegistry::Get();
	std::lock_guard Lock(Registry.Mutex);
	for (const FUniformBufferStructRegistrar* Entry : Registry.Entries)
	{
		if (HlslName == Entry->HlslName)
		{
			return &Entry->GetMetadata();
		}
	}
	return nullptr;
}

namespace
{

std::atomic<const FShaderParametersMetadata*> GFrameStruct{nullptr};
std::atomic<const void*> GFrameContents{nullptr};

} // namespace

FFrameUniformBufferScope::FFrameUniformBufferScope(const FShaderParametersMetadata* Struct, const void* Contents)
{
	GFrameStruct = Struct;
	GFrameContents = Contents;
}

FFrameUniformBufferScope::~FFrameUniformBufferScope()
{
	GFrameStruct = nullptr;
	GFrameContents = nullptr;
}

const FShaderParametersMetadata* GetFrameUniformBufferStruct()
{
	return GFrameStruct;
}

const void* GetFrameUniformBufferContents()
{
	return GFrameContents;
}

std::vector<const FShaderParametersMetadata*> GetUniformBufferStructs()
{
	FUniformBufferRegistry& Registry = FUniformBufferRegistry::Get();
	std::lock_guard Lock(Registry.Mutex);
	std::map<std::string, const FShaderParametersMetadata*> ByName; // the first of a name, as when it is looked up
	for (const FUniformBufferStructRegistrar* Entry : Registry.Entries)
	{
		if (!ByName.count(Entry->HlslName))
		{
			ByName[Entry->HlslName] = &Entry->GetMetadata();
		}
	}
	return ToVector<const FShaderParametersMetadata*>(ByName, [](const auto& Each) { return Each.second; });
}

std::string GetHlslTypeName(EUniformBufferBaseType BaseType, uint32 NumRows, uint32 NumColumns)
{
	std::string Name = BaseType == UBMT_INT32 ? "int" : BaseType == UBMT_UINT32 ? "uint" : "float";
	if (NumRows > 1)
	{
		Name += std::to_string(NumRows) + "x" + std::to_string(NumColumns);
	}
	else if (NumColumns > 1)
	{
		Name += std::to_string(NumColumns);
	}
	return Name;
}

const TCHAR* GetBaseTypeName(EUniformBufferBaseType BaseType)
{
	static constexpr const TCHAR* Names[] = {TEXT("UBMT_INVALID"), TEXT("UBMT_BOOL"), TEXT("UBMT_INT32"),
		TEXT("UBMT_UINT32"), TEXT("UBMT_FLOAT32"), TEXT("UBMT_TEXTURE"), TEXT("UBMT_SRV"), TEXT("UBMT_UAV"),
		TEXT("UBMT_SAMPLER"), TEXT("UBMT_RDG_TEXTURE"), TEXT("UBMT_RDG_TEXTURE_ACCESS"),
		TEXT("UBMT_RDG_TEXTURE_ACCESS_ARRAY"), TEXT("UBMT_RDG_TEXTURE_SRV"), TEXT("UBMT_RDG_TEXTURE_UAV"),
		TEXT("UBMT_RDG_BUFFER_ACCESS"), TEXT("UBMT_RDG_BUFFER_ACCESS_ARRAY"), TEXT("UBMT_RDG_BUFFER_SRV"),
		TEXT("UBMT_RDG_BUFFER_UAV"), TEXT("UBMT_RDG_UNIFORM_BUFFER"), TEXT("UBMT_NESTED_STRUCT"),
		TEXT("UBMT_INCLUDED_STRUCT"), TEXT("UBMT_REFERENCED_STRUCT"), TEXT("UBMT_RENDER_TARGET_BINDING_SLOTS")};
	static_assert(std::size(Names) == EUniformBufferBaseType_Num);
	return Names[BaseType < EUniformBufferBaseType_Num ? BaseType : UBMT_INVALID];
}

} // namespace Drydock

FShaderParametersMetadata::FShaderParametersMetadata(EUseCase InUseCase, const TCHAR* InStructTypeName,
	const TCHAR* InShaderVariableName, const TCHAR* InStaticSlotName, const ANSICHAR* InFileName, int32 InFileLine,
	uint32 InSize, TArray<FMember> InMembers)
	: UseCase(InUseCase)
	, StructTypeName(InStructTypeName)
	, ShaderVariableName(InShaderVariableName)
	, StaticSlotName(InStaticSlotName)
	, FileName(InFileName)
	, FileLine(InFileLine)
	, Size(InSize)
	, Members(std::move(InMembers))
{
	AppendHlslMembers(HlslMembers, "", "", 0);
}

uint32 FShaderParametersMetadata::FMember::GetMemberSize() const
{
	constexpr uint32 ArrayStride = 16;
	constexpr uint32 PointerSize = 8;
	if (IsVariableNativeType())
	{
		const uint32 ElementSize = NumRows * NumColumns * 4;
		return NumElements ? NumElements * ((ElementSize + ArrayStride - 1) / ArrayStride * ArrayStride) : ElementSize;
	}
	if (BaseType == UBMT_NESTED_STRUCT || BaseType == UBMT_INCLUDED_STRUCT)
	{
		return Struct->GetSize() * (NumElements ? NumElements : 1);
	}
	return PointerSize * (NumElements ? NumElements : 1);
}

void FShaderParametersMetadata::FMember::GenerateShaderParameterType(FString& Result) const
{
	std::string Text =
		IsVariableNativeType() ? Drydock::GetHlslTypeName(BaseType, NumRows, NumColumns) : std::string(ShaderType);
	if (NumElements)
	{
		Text += "[" + std::to_string(NumElements) + "]";
	}
	Result = FString(Text.c_str());
}

const FShaderParametersMetadata::FMember* FShaderParametersMetadata::FindMemberByName(const TCHAR* Name) const
{
	for (const FMember& Member : Members)
	{
		if (std::strcmp(Member.GetName(), Name) == 0)
		{
			return &Member;
		}
	}
	return nullptr;
}

FString FShaderParametersMetadata::GetFullMemberCodeName(uint32 MemberOffset) const
{
	for (const Drydock::FHlslMember& Member : HlslMembers)
	{
		if (Member.Offset == MemberOffset)
		{
			return FString(Member.CodeName.c_str());
		}
	}
	return FString();
}

void FShaderParametersMetadata::AppendHlslMembers(std::vector<Drydock::FHlslMember>& Result, const std::string& Prefix,
	const std::string& CodePrefix, uint32 BaseOffset) const
{
	for (const FMember& Member : Members)
	{
		const std::string Name = Member.GetName();
		const EUniformBufferBaseType BaseType = Member.GetBaseType();
		const uint32 Offset = BaseOffset + Member.GetOffset();
		const uint32 NumElements = Member.GetNumElements();
		if (BaseType == UBMT_INCLUDED_STRUCT)
		{
			Member.GetStructMetadata()->AppendHlslMembers(Result, Prefix, CodePrefix + Name + ".", Offset);
			continue;
		}
		if (BaseType == UBMT_NESTED_STRUCT)
		{
			for (uint32 Index = 0; Index < std::max(NumElements, 1u); ++Index)
			{
				const std::string HlslIndex = NumElements ? "_" + std::to_string(Index) : "";
				const std::string CodeIndex = NumElements ? "[" + std::to_string(Index) + "]" : "";
				Member.GetStructMetadata()->AppendHlslMembers(Result, Prefix + Name + HlslIndex + "_",
					CodePrefix + Name + CodeIndex + ".", Offset + Index * Member.GetStructMetadata()->GetSize());
			}
			continue;
		}

		Drydock::FHlslMember Flat;
		Flat.Name = Prefix + Name;
		Flat.CodeName = CodePrefix + Name;
		Flat.Type = Member.IsVariableNativeType()
						? Drydock::GetHlslTypeName(BaseType, Member.GetNumRows(), Member.GetNumColumns())
						: Member.GetShaderType();
		Flat.BaseType = BaseType;
		Flat.Offset = Offset;
		Flat.NumRows = Member.GetNumRows();
		Flat.NumColumns = Member.GetNumColumns();
		Flat.NumElements = NumElements;
		Flat.Struct = Member.GetStructMetadata();
		Flat.DeclaredIn = this;
		Flat.FileLine = Member.GetFileLine();
		if (Member.IsVariableNativeType() || NumElements == 0)
		{
			Result.push_back(std::move(Flat));
			continue;
		}
		// HLSL compilers treat arrays of resources unevenly, so the engine binds each element by its own name.
		for (uint32 Index = 0; Index < NumElements; ++Index)
		{
			Drydock::FHlslMember Element = Flat;
			Element.Name += "_" + std::to_string(Index);
			Element.CodeName += "[" + std::to_string(Index) + "]";
			Element.Offset += Index * 8;
			Element.NumElements = 0;
			Result.push_back(std::move(Element));
		}
	}
}
