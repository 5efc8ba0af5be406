// Finds the buffer of each resource by its register, its Vulkan binding or its name.
#include "ConformanceBinding.h"

#include "HlslTokens.h"

#include <algorithm>
#include <cstdlib>
#include <cstring>

namespace Drydock::Conformance
{

namespace
{

constexpr size_t Margin = 64; // bytes that kernels may read before and behind a texture

bool IsCounter(const FShaderResource& Resource)
{
	return !Resource.CounterOf.empty();
}

/** How values of a buffer lie in memory; throws FNotRead for what kernels do not read. */
ETexelStorage GetStorage(EFormat Format, uint32_t Channels)
{
	static const ETexelStorage Floats[4] = {
		ETexelStorage::R32_FLOAT, ETexelStorage::RG32_FLOAT, ETexelStorage::RGB32_FLOAT, ETexelStorage::RGBA32_FLOAT};
	static const ETexelStorage Halves[4] = {
		ETexelStorage::R16_FLOAT, ETexelStorage::RG16_FLOAT, ETexelStorage::Count, ETexelStorage::RGBA16_FLOAT};
	static const ETexelStorage Words[4] = {
		ETexelStorage::R32_UINT, ETexelStorage::RG32_UINT, ETexelStorage::Count, ETexelStorage::RGBA32_UINT};
	static const ETexelStorage Shorts[4] = {
		ETexelStorage::R16_UINT, ETexelStorage::RG16_UINT, ETexelStorage::Count, ETexelStorage::RGBA16_UINT};
	const uint32_t Size = GetSize(Format);
	const ETexelStorage* const List = Format == EFormat::Float32   ? Floats
									  : Format == EFormat::Float16 ? Halves
									  : Size == 4                  ? Words
									  : Size == 2                  ? Shorts
																   : nullptr;
	if (!List || Channels < 1 || Channels > 4 || List[Channels - 1] == ETexelStorage::Count)
	{
		throw FNotRead("texels of " + std::to_string(Channels) + " values of " + std::to_string(Size * 8) + " bits");
	}
	return List[Channels - 1];
}

/** Resources that are not used have no register. "A_2" is an element of A. */
bool IsUsed(const FShaderReflection& Reflection, const std::string& Name)
{
	const auto IsIn = [&Name](const std::vector<FShaderResource>& List)
	{
		return std::any_of(List.begin(), List.end(),
			[&Name](const FShaderResource& R) { return R.Name == Name || R.Name.starts_with(Name + "_"); });
	};
	return IsIn(Reflection.Textures) || IsIn(Reflection.Buffers) || IsIn(Reflection.RWTextures) ||
		   IsIn(Reflection.RWBuffers);
}

} // namespace

FBinding::FBinding(const FPipeline& InPipeline, const FShaderReflection& Reflection, const std::string& Text)
	: Pipeline(InPipeline)
{
	ReadPlaces(Text);
	PlaceTheRest(Reflection);
	for (const FShaderConstantBuffer& Constants : Reflection.ConstantBuffers)
	{
		AddConstants(Constants);
	}
	for (const std::vector<uint8_t>& Memory : ConstantMemory)
	{
		ConstantPointers.push_back(Memory.data());
	}
	for (const FShaderResource& Resource : Reflection.Textures)
	{
		Textures.push_back(MakeTexture(Resource));
	}
	for (const FShaderResource& Resource : Reflection.RWTextures)
	{
		RWTextures.push_back(MakeTexture(Resource));
	}
	for (const FShaderResource& Resource : Reflection.Samplers)
	{
		Samplers.push_back(MakeSampler(Resource));
	}
	for (const FShaderResource& Resource : Reflection.Buffers)
	{
		Buffers.push_back(MakeBuffer(Resource));
	}
	for (const FShaderResource& Resource : Reflection.RWBuffers)
	{
		RWBuffers.push_back(MakeBuffer(Resource));
	}
	CheckPushed(Reflection, Text);
	Args = {ConstantPointers.data(), Textures.data(), RWTextures.data(), Samplers.data(), Buffers.data(),
		RWBuffers.data(), nullptr, nullptr, 0, nullptr, nullptr};
}

void FBinding::ReadPlaces(const std::string& Text)
{
	const FHlslText Tokens(Text, "");
	FPlace Attributes; // of the declaration that is being read
	for (size_t At = 0; At < Tokens.Size(); ++At)
	{
		if (Tokens.Is(At, ";") || Tokens.Is(At, "{") || Tokens.Is(At, "}"))
		{
			const bool bBlock = Tokens.Is(At, "{") && Attributes.Class == 'b';
			if (!bBlock && !Attributes.Name.empty() &&
				(Attributes.Class || Attributes.Binding >= 0 || Attributes.bPush))
			{
				Places.push_back(Attributes);
			}
			if (bBlock)
			{
				Places.push_back(Attributes);
			}
			Attributes = {};
		}
		const auto GetNumber = [&](size_t Index)
		{
			return std::atoi(Tokens[std::min(Index, Tokens.Size() - 1)].Text.c_str());
		};
		if (Tokens.Is(At, "binding") && Tokens.Is(At + 1, "("))
		{
			Attributes.Binding = GetNumber(At + 2);
			Attributes.Set = Tokens.Is(At + 3, ",") ? GetNumber(At + 4) : 0;
		}
		Attributes.bPush = Attributes.bPush || Tokens.Is(At, "push_constant");
		const bool bName = Tokens.IsWord(At) && (Tokens.Is(At + 1, ";") || Tokens.Is(At + 1, ":") ||
													Tokens.Is(At + 1, "[") || Tokens.Is(At + 1, "{"));
		if (bName && Attributes.Name.empty())
		{
			Attributes.Name = Tokens[At].Text;
			Attributes.bArray = Tokens.Is(At + 1, "[");
			Declared.try_emplace(Attributes.Name, At);
		}
		if (Tokens.Is(At, "register") && Tokens.Is(At + 1, "(") && Tokens.IsWord(At + 2))
		{
			if (Attributes.Class) // a struct with resources of several classes
			{
				Places.push_back(Attributes);
			}
			const std::string& Register = Tokens[At + 2].Text;
			Attributes.Class = Register[0];
			Attributes.Register = std::atoi(Register.c_str() + 1);
			Attributes.Space = Tokens.Is(At + 3, ",") ? std::atoi(Tokens[At + 4].Text.c_str() + 5) : 0;
		}
	}
}

/** Of "A_2", the resource with the index 2 of the array A: A, and the index in Index. */
std::string FBinding::FindArray(const std::string& Name, int32_t& Index) const
{
	const size_t Digits = Name.find_last_not_of("0123456789") + 1;
	const std::string Array = Name.substr(0, Digits < 1 ? 0 : Digits - 1);
	if (Digits == Name.size() || Digits == 0 || Name[Digits - 1] != '_' || !Declared.count(Array))
	{
		return {};
	}
	Index = std::atoi(Name.c_str() + Digits);
	return Array;
}

/** The buffers in a struct of the text, "A_Name" of A, get the registers from that of A on, and "A_2_Name" of an array
 * the one of its index. */
void FBinding::AddMembers(const std::vector<FShaderResource>& List, char Class)
{
	std::map<std::string, int32_t> Counts;
	for (const FShaderResource& Resource : List)
	{
		const auto Struct = std::ranges::find_if(Places,
			[&](const FPlace& Place) { return Place.Class == Class && Resource.Name.starts_with(Place.Name + "_"); });
		if (!FindPlace(Resource.Name) && Struct != Places.end())
		{
			FPlace Member = *Struct;
			Member.Register +=
				Struct->bArray ? std::atoi(Resource.Name.c_str() + Struct->Name.size() + 1) : Counts[Struct->Name]++;
			Member.Name = Resource.Name;
			Member.bArray = false;
			Places.push_back(Member);
		}
	}
}

/** Elements of arrays get places of their own. Registers of what names none: the first that are free, in the order of
 * the text. */
void FBinding::PlaceTheRest(const FShaderReflection& Reflection)
{
	const auto AddElements = [&](const auto& List)
	{
		for (const auto& Resource : List)
		{
			int32_t Index = 0;
			const FPlace* const Array = FindPlace(FindArray(Resource.Name, Index));
			if (!FindPlace(Resource.Name) && Array && Array->bArray)
			{
				FPlace Element = *Array;
				Element.Name = Resource.Name;
				Element.Register += Index;
				Places.push_back(Element);
			}
		}
	};
	AddElements(Reflection.Textures);
	AddElements(Reflection.Buffers);
	AddElements(Reflection.RWTextures);
	AddElements(Reflection.RWBuffers);
	AddElements(Reflection.ConstantBuffers);
	AddMembers(Reflection.Buffers, 't');
	AddMembers(Reflection.RWBuffers, 'u');
	std::vector<std::pair<size_t, FPlace>> Rest; // by where they stand
	const auto Add = [&](const auto& List, char Class)
	{
		for (const auto& Resource : List)
		{
			if (!FindPlace(Resource.Name) && !IsCounter(Resource))
			{
				FPlace Place;
				Place.Name = Resource.Name;
				Place.Class = Class;
				int32_t Index = 0;
				const std::string Array = FindArray(Resource.Name, Index);
				const auto Found = Declared.find(Declared.count(Resource.Name) ? Resource.Name : Array);
				Rest.emplace_back(Found == Declared.end() ? SIZE_MAX : Found->second, Place);
			}
		}
	};
	Add(Reflection.Textures, 't');
	Add(Reflection.Buffers, 't');
	Add(Reflection.RWTextures, 'u');
	Add(Reflection.RWBuffers, 'u');
	std::stable_sort(Rest.begin(), Rest.end(), [](const auto& A, const auto& B) { return A.first < B.first; });
	for (auto& [At, Place] : Rest)
	{
		const bool bNamed = std::any_of(Pipeline.Resources.begin(), Pipeline.Resources.end(),
			[&, Name = Place.Name](const FResource& Resource) { return Resource.Name == Name; });
		const auto IsTaken = [&, Class = Place.Class](int32_t Register)
		{
			return std::any_of(Places.begin(), Places.end(),
				[&](const FPlace& Other) {
					return Other.Class == Class && Other.Space == 0 && Other.Register == Register &&
						   IsUsed(Reflection, Other.Name);
				});
		};
		Place.Register = 0;
		while (IsTaken(Place.Register))
		{
			++Place.Register;
		}
		if (!bNamed)
		{
			Places.push_back(Place);
		}
	}
}

const FBinding::FPlace* FBinding::FindPlace(const std::string& Name) const
{
	const auto Place =
		std::find_if(Places.begin(), Places.end(), [&](const FPlace& Candidate) { return Candidate.Name == Name; });
	return Place == Places.end() ? nullptr : &*Place;
}

const FResource* FBinding::FindResource(const std::string& Name) const
{
	const FPlace* const Place = FindPlace(Name);
	for (const FResource& Resource : Pipeline.Resources)
	{
		int32_t Count = 1;
		for (const FBuffer& Buffer : Pipeline.Buffers)
		{
			Count = Buffer.Name == Resource.Name ? int32_t(Buffer.Members.size()) : Count;
		}
		const bool bRegister = Place && Place->Class == Resource.GetRegisterClass() &&
							   Place->Register >= Resource.Register && Place->Register < Resource.Register + Count &&
							   Place->Space == Resource.Space;
		const bool bBinding =
			Place && Place->Class == 0 && Place->Binding == Resource.Binding && Place->Set == Resource.Set;
		if (bRegister || bBinding || (!Place && Resource.Name == Name))
		{
			return &Resource;
		}
	}
	return nullptr;
}

FBinding::FElement FBinding::FindBuffer(const std::string& Name) const
{
	const FResource* const Resource = FindResource(Name);
	const FPlace* const Place = FindPlace(Name);
	for (const FBuffer& Buffer : Pipeline.Buffers)
	{
		if (Resource && Buffer.Name == Resource->Name)
		{
			return {&Buffer, Place && Place->Class ? size_t(Place->Register - Resource->Register) : 0};
		}
	}
	return {};
}

FBinding::FMemory& FBinding::GetMemory(const FElement& Element)
{
	for (const std::unique_ptr<FMemory>& Memory : Memories)
	{
		if (Memory->Of.Buffer == Element.Buffer && Memory->Of.Member == Element.Member)
		{
			return *Memory;
		}
	}
	Memories.push_back(std::make_unique<FMemory>());
	FMemory& Memory = *Memories.back();
	Memory.Of = Element;
	const std::vector<uint8_t> Bytes =
		Element.Buffer ? Element.Buffer->Members.at(Element.Member) : std::vector<uint8_t>();
	Memory.Bytes.resize(Bytes.size() + 2 * Margin);
	std::copy(Bytes.begin(), Bytes.end(), Memory.Bytes.begin() + Margin);
	return Memory;
}

FKernelTexture FBinding::MakeTexture(const FShaderResource& Resource)
{
	const FElement Element = FindBuffer(Resource.Name);
	if (!Element.Buffer)
	{
		throw FNotRead("nothing is bound to '" + Resource.Name + "'");
	}
	const FBuffer& Buffer = *Element.Buffer;
	FMemory& Memory = GetMemory(Element);
	const int32_t TexelSize = int32_t(Buffer.GetElementSize());
	uint8_t* Data = Memory.Bytes.data() + Margin;
	std::array<int32_t, 3> Size = Buffer.Size;
	Memory.Mips.clear();
	for (int32_t Mip = 0; Mip < Buffer.MipLevels; ++Mip)
	{
		const int32_t Pitch = Size[0] * TexelSize;
		const int64_t Slice = int64_t(Pitch) * Size[1];
		Memory.Mips.push_back({Data, Size[0], Size[1], Size[2], Pitch, Slice});
		Data += Slice * Size[2];
		for (int32_t& Extent : Size)
		{
			Extent = std::max(1, Extent / 2);
		}
	}
	if (Data != Memory.Bytes.data() + Memory.Bytes.size() - Margin)
	{
		throw FNotRead("a texture whose size is not that of its buffer");
	}
	return {Memory.Mips.data(), Buffer.MipLevels, GetStorage(Buffer.Format, Buffer.Channels),
		uint8_t(Resource.Dimension == EShaderDimension::Texture3D), 0};
}

FKernelBuffer FBinding::MakeBuffer(const FShaderResource& Resource)
{
	FElement Element = FindBuffer(IsCounter(Resource) ? Resource.CounterOf : Resource.Name);
	if (IsCounter(Resource))
	{
		Element.Buffer = Element.Buffer ? Pipeline.FindBuffer(Element.Buffer->Name + CounterSuffix) : nullptr;
		if (!Element.Buffer)
		{
			throw FNotRead("'" + Resource.CounterOf + "' has no counter");
		}
	}
	FMemory& Memory = GetMemory(Element);
	if (!Element.Buffer) // as a null descriptor: reads are 0, writes are lost
	{
		return {Memory.Bytes.data() + Margin, 0, Resource.Stride ? Resource.Stride : 4, ETexelStorage::R32_UINT};
	}
	const FBuffer& Buffer = *Element.Buffer;
	const bool bTyped = Resource.Dimension == EShaderDimension::TypedBuffer;
	return {Memory.Bytes.data() + Margin, uint32_t(Buffer.Members[Element.Member].size()),
		bTyped ? Buffer.GetElementSize() : Resource.Stride,
		bTyped ? GetStorage(Buffer.Format, Buffer.Channels) : ETexelStorage::R32_UINT};
}

bool FBinding::IsPushed(const std::string& Constants) const
{
	return !Pipeline.PushConstants.empty() &&
		   std::any_of(Places.begin(), Places.end(),
			   [&](const FPlace& Place) { return Place.bPush && (Place.Name == Constants || Constants == "$Global"); });
}

/** Vulkan lays arrays and matrices without gaps, and members where the text says. */
void FBinding::CheckPushed(const FShaderReflection& Reflection, const std::string& Text) const
{
	for (const FShaderConstant& Constant : Reflection.Constants)
	{
		const bool bOthers =
			Constant.NumElements > 0 || Constant.Rows > 1 || Text.find("vk::offset") != std::string::npos;
		if (bOthers && IsPushed(Reflection.ConstantBuffers[Constant.Buffer].Name))
		{
			throw FNotRead("push constants that do not lie as Direct3D lays constants");
		}
	}
}

void FBinding::AddConstants(const FShaderConstantBuffer& Constants)
{
	const FElement Element = FindBuffer(Constants.Name);
	const bool bFromPush = IsPushed(Constants.Name);
	if (!bFromPush && !Element.Buffer)
	{
		throw FNotRead("nothing is bound to '" + Constants.Name + "'");
	}
	const std::vector<uint8_t>& Bytes = bFromPush ? Pipeline.PushConstants : Element.Buffer->Members.at(Element.Member);
	std::vector<uint8_t>& Memory = ConstantMemory.emplace_back(Bytes);
	Memory.resize(std::max<size_t>(Memory.size(), Constants.Size));
}

FKernelSampler FBinding::MakeSampler(const FShaderResource& Resource) const
{
	const FResource* const Bound = FindResource(Resource.Name);
	const FSampler* const Sampler = Bound ? Pipeline.FindSampler(Bound->Name) : nullptr;
	if (!Sampler)
	{
		throw FNotRead("no sampler '" + Resource.Name + "'");
	}
	const EKernelAddress Address = Sampler->Address == "Repeat"   ? EKernelAddress::Wrap
								   : Sampler->Address == "Mirror" ? EKernelAddress::Mirror
								   : Sampler->Address == "Border" ? EKernelAddress::Border
																  : EKernelAddress::Clamp;
	return {Sampler->bLinear ? EKernelFilter::Bilinear : EKernelFilter::Point, Address, Address, Address, 8, 0, {}};
}

void FBinding::ReadBack(FPipeline& Target) const
{
	for (const std::unique_ptr<FMemory>& Memory : Memories)
	{
		if (!Memory->Of.Buffer)
		{
			continue;
		}
		std::vector<uint8_t>& Bytes = Target.FindBuffer(Memory->Of.Buffer->Name)->Members[Memory->Of.Member];
		std::copy(Memory->Bytes.begin() + Margin, Memory->Bytes.end() - Margin, Bytes.begin());
	}
}

} // namespace Drydock::Conformance
