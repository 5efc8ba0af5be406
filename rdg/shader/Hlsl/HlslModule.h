// Builds the words of a SPIR-V module: ids, types and constants that are made once each, and its sections in their
// order. Source: Khronos, SPIR-V specification 1.0, section 2.4 (logical layout of a module).
#pragma once

#include "SpirvOps.h"

#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace Drydock::Hlsl
{

using FWords = std::vector<uint32_t>;

/** Numbers of SPIR-V that the tier behind does not know. */
enum ESpirvNumber : uint32_t
{
	CapabilityShader = 1,
	CapabilityFloat16 = 9,
	CapabilityFloat64 = 10,
	CapabilityInt64 = 11,
	CapabilityInt64Atomics = 12,
	CapabilityInt16 = 22,
	CapabilityImageGatherExtended = 25,
	CapabilitySampleRateShading = 35,
	CapabilityMinLod = 42,
	CapabilitySampled1D = 43,
	CapabilityImage1D = 44,
	CapabilitySampledCubeArray = 45,
	CapabilitySampledBuffer = 46,
	CapabilityImageBuffer = 47,
	CapabilityStorageImageExtendedFormats = 49,
	CapabilityImageQuery = 50,
	CapabilityDerivativeControl = 51,
	CapabilityGroupNonUniform = 61,
	CapabilityGroupNonUniformVote = 62,
	CapabilityGroupNonUniformArithmetic = 63,
	CapabilityGroupNonUniformBallot = 64,
	CapabilityGroupNonUniformShuffle = 65,
	CapabilityGroupNonUniformQuad = 68,
	CapabilityStorageBuffer16 = 4433,
	CapabilityUniform16 = 4434,
	CapabilityRoundingModeRTE = 4467,
	DecorationColMajor = 5,
	DecorationFlat = 14,
	DecorationDescriptorSet = 34,
	ExtFrexp = 51,
};

/** Appends one instruction. */
/** Thrown where an instruction has more words than there can be. */
struct FModuleFault
{
};

void AddWords(FWords& To, uint16_t Op, const FWords& Operands);
/** Appends a string, padded to words. */
void AddString(FWords& To, std::string_view Text);

/** The blocks of a function while they are made. */
struct FBody
{
	FWords Head;      // OpFunction, its parameters and the first label
	FWords Variables; // of its first block
	FWords Prologue;  // stores that come before all code
	FWords Code;
	uint32_t File = ~0u; // of the latest OpLine in this block
	int32_t Line = -1;
	bool bOpen = true;          // the block has no end yet; nothing is added to one that has
	std::set<uint32_t> Reached; // labels that some branch goes to
};

class FModule
{
public:
	uint32_t NewId() { return Bound++; }

	/** A type or constant: the id of the one with these operands. The type of a constant stands first. */
	uint32_t Intern(uint16_t Op, const FWords& Operands);
	/** A type of its own, which is decorated. */
	uint32_t MakeType(uint16_t Op, const FWords& Operands);

	uint32_t Pointer(uint32_t Storage, uint32_t Type) { return Intern(Spirv::OpTypePointer, {Storage, Type}); }
	uint32_t Uint() { return Intern(Spirv::OpTypeInt, {32, 0}); }
	uint32_t Int() { return Intern(Spirv::OpTypeInt, {32, 1}); }
	uint32_t Bool() { return Intern(Spirv::OpTypeBool, {}); }
	uint32_t Vector(uint32_t Scalar, uint32_t Count)
	{
		return Count == 1 ? Scalar : Intern(Spirv::OpTypeVector, {Scalar, Count});
	}
	uint32_t Uint(uint32_t Value) { return Intern(Spirv::OpConstant, {Uint(), Value}); }
	uint32_t Int(int32_t Value) { return Intern(Spirv::OpConstant, {Int(), uint32_t(Value)}); }
	uint32_t Null(uint32_t Type) { return Intern(Spirv::OpConstantNull, {Type}); }
	bool IsConstant(uint32_t Id) const { return Constants.count(Id) > 0; }
	/** A constant of one word. */
	bool FindNumber(uint32_t Id, uint32_t& Value) const;

	uint32_t Global(uint32_t Type, uint32_t Storage, const std::string& Name, uint32_t Initializer = 0);
	void Name(uint32_t Id, std::string_view Text);
	void MemberName(uint32_t Type, uint32_t Member, std::string_view Text);
	void Decorate(uint32_t Id, uint32_t Decoration, const FWords& Operands = {});
	void DecorateMember(uint32_t Type, uint32_t Member, uint32_t Decoration, const FWords& Operands = {});
	void DecorateSemantic(uint32_t Id, std::string_view Semantic);
	void DecorateCounter(uint32_t Buffer, uint32_t Counter);
	void Capability(uint32_t Number) { Capabilities.insert(Number); }
	void Extension(std::string_view Text) { Extensions.insert(std::string(Text)); }
	uint32_t String(const std::string& Text);
	uint32_t GetExtended() const { return Extended; }

	void AddFunction(const FBody& Body);
	/** Model and modes of the entry point. Words of each mode: the mode, its literals. */
	FWords Finish(uint32_t Model, uint32_t Entry, std::string_view EntryName, const FWords& Interface,
		const std::vector<FWords>& Modes, bool bWaves);

private:
	uint32_t Bound = 2;
	const uint32_t Extended = 1; // the import of GLSL.std.450
	std::set<uint32_t> Capabilities = {CapabilityShader};
	std::set<std::string> Extensions = {"SPV_GOOGLE_hlsl_functionality1"};
	std::map<FWords, uint32_t> Interned;
	std::set<uint32_t> Constants;
	std::map<uint32_t, uint32_t> Numbers;
	std::map<std::string, uint32_t> StringIds;
	FWords Strings;
	FWords Names;
	FWords Decorations;
	FWords Globals;
	FWords Functions;
};

} // namespace Drydock::Hlsl
