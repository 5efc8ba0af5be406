// The numbers of SPIR-V 1.0 that shaders of this library meet: opcodes, the GLSL.std.450 instructions, decorations,
// storage classes. Source: Khronos, SPIR-V specification and its extended instruction set for GLSL.
#pragma once

#include <cstddef>
#include <cstdint>

namespace Drydock::Spirv
{

// clang-format off
enum EOp : uint16_t
{
	OpNop = 0, OpUndef = 1, OpSourceContinued = 2, OpSource = 3, OpSourceExtension = 4, OpName = 5, OpMemberName = 6,
	OpString = 7, OpLine = 8, OpExtension = 10, OpExtInstImport = 11, OpExtInst = 12, OpMemoryModel = 14,
	OpEntryPoint = 15, OpExecutionMode = 16, OpCapability = 17,
	OpTypeVoid = 19, OpTypeBool = 20, OpTypeInt = 21, OpTypeFloat = 22, OpTypeVector = 23, OpTypeMatrix = 24,
	OpTypeImage = 25, OpTypeSampler = 26, OpTypeSampledImage = 27, OpTypeArray = 28, OpTypeRuntimeArray = 29,
	OpTypeStruct = 30, OpTypePointer = 32, OpTypeFunction = 33,
	OpConstantTrue = 41, OpConstantFalse = 42, OpConstant = 43, OpConstantComposite = 44, OpConstantNull = 46,
	OpFunction = 54, OpFunctionParameter = 55, OpFunctionEnd = 56, OpFunctionCall = 57,
	OpVariable = 59, OpImageTexelPointer = 60, OpLoad = 61, OpStore = 62, OpAccessChain = 65, OpInBoundsAccessChain = 66,
	OpArrayLength = 68, OpDecorate = 71, OpMemberDecorate = 72,
	OpVectorExtractDynamic = 77, OpVectorInsertDynamic = 78, OpVectorShuffle = 79, OpCompositeConstruct = 80,
	OpCompositeExtract = 81, OpCompositeInsert = 82, OpCopyObject = 83, OpTranspose = 84,
	OpSampledImage = 86, OpImageSampleImplicitLod = 87, OpImageSampleExplicitLod = 88,
	OpImageSampleDrefImplicitLod = 89, OpImageSampleDrefExplicitLod = 90, OpImageFetch = 95, OpImageGather = 96,
	OpImageDrefGather = 97, OpImageRead = 98, OpImageWrite = 99, OpImage = 100, OpImageQuerySizeLod = 103,
	OpImageQuerySize = 104, OpImageQueryLod = 105, OpImageQueryLevels = 106, OpImageQuerySamples = 107,
	OpConvertFToU = 109, OpConvertFToS = 110, OpConvertSToF = 111, OpConvertUToF = 112, OpUConvert = 113,
	OpSConvert = 114, OpFConvert = 115, OpBitcast = 124,
	OpSNegate = 126, OpFNegate = 127, OpIAdd = 128, OpFAdd = 129, OpISub = 130, OpFSub = 131, OpIMul = 132, OpFMul = 133,
	OpUDiv = 134, OpSDiv = 135, OpFDiv = 136, OpUMod = 137, OpSRem = 138, OpSMod = 139, OpFRem = 140, OpFMod = 141,
	OpVectorTimesScalar = 142, OpMatrixTimesScalar = 143, OpVectorTimesMatrix = 144, OpMatrixTimesVector = 145,
	OpMatrixTimesMatrix = 146, OpOuterProduct = 147, OpDot = 148, OpIAddCarry = 149, OpISubBorrow = 150,
	OpAny = 154, OpAll = 155, OpIsNan = 156, OpIsInf = 157, OpLogicalEqual = 164, OpLogicalNotEqual = 165,
	OpLogicalOr = 166, OpLogicalAnd = 167, OpLogicalNot = 168, OpSelect = 169, OpIEqual = 170, OpINotEqual = 171,
	OpUGreaterThan = 172, OpSGreaterThan = 173, OpUGreaterThanEqual = 174, OpSGreaterThanEqual = 175, OpULessThan = 176,
	OpSLessThan = 177, OpULessThanEqual = 178, OpSLessThanEqual = 179, OpFOrdEqual = 180, OpFUnordEqual = 181,
	OpFOrdNotEqual = 182, OpFUnordNotEqual = 183, OpFOrdLessThan = 184, OpFUnordLessThan = 185,
	OpFOrdGreaterThan = 186, OpFUnordGreaterThan = 187, OpFOrdLessThanEqual = 188, OpFUnordLessThanEqual = 189,
	OpFOrdGreaterThanEqual = 190, OpFUnordGreaterThanEqual = 191,
	OpShiftRightLogical = 194, OpShiftRightArithmetic = 195, OpShiftLeftLogical = 196, OpBitwiseOr = 197,
	OpBitwiseXor = 198, OpBitwiseAnd = 199, OpNot = 200, OpBitFieldInsert = 201, OpBitFieldSExtract = 202,
	OpBitFieldUExtract = 203, OpBitReverse = 204, OpBitCount = 205,
	OpDPdx = 207, OpDPdy = 208, OpFwidth = 209, OpDPdxFine = 210, OpDPdyFine = 211, OpFwidthFine = 212,
	OpDPdxCoarse = 213, OpDPdyCoarse = 214, OpFwidthCoarse = 215,
	OpControlBarrier = 224, OpMemoryBarrier = 225, OpAtomicLoad = 227, OpAtomicStore = 228, OpAtomicExchange = 229,
	OpAtomicCompareExchange = 230, OpAtomicIIncrement = 232, OpAtomicIDecrement = 233, OpAtomicIAdd = 234,
	OpAtomicISub = 235, OpAtomicSMin = 236, OpAtomicUMin = 237, OpAtomicSMax = 238, OpAtomicUMax = 239,
	OpAtomicAnd = 240, OpAtomicOr = 241, OpAtomicXor = 242,
	OpPhi = 245, OpLoopMerge = 246, OpSelectionMerge = 247, OpLabel = 248, OpBranch = 249, OpBranchConditional = 250,
	OpSwitch = 251, OpKill = 252, OpReturn = 253, OpReturnValue = 254, OpUnreachable = 255,
	OpNoLine = 317, OpModuleProcessed = 330, OpDecorateId = 332,
	OpGroupNonUniformElect = 333, OpGroupNonUniformAll = 334, OpGroupNonUniformAny = 335, OpGroupNonUniformAllEqual = 336,
	OpGroupNonUniformBroadcast = 337, OpGroupNonUniformBroadcastFirst = 338, OpGroupNonUniformBallot = 339,
	OpGroupNonUniformBallotBitCount = 342, OpGroupNonUniformShuffle = 345, OpGroupNonUniformIAdd = 349,
	OpGroupNonUniformFAdd = 350, OpGroupNonUniformIMul = 351, OpGroupNonUniformFMul = 352, OpGroupNonUniformSMin = 353,
	OpGroupNonUniformUMin = 354, OpGroupNonUniformFMin = 355, OpGroupNonUniformSMax = 356, OpGroupNonUniformUMax = 357,
	OpGroupNonUniformFMax = 358, OpGroupNonUniformBitwiseAnd = 359, OpGroupNonUniformBitwiseOr = 360,
	OpGroupNonUniformBitwiseXor = 361, OpGroupNonUniformQuadBroadcast = 365, OpGroupNonUniformQuadSwap = 366,
	OpDemote = 5380, // OpDemoteToHelperInvocation
	OpDecorateString = 5632, OpMemberDecorateString = 5633
};

/** GLSL.std.450. */
enum EExtInst : uint32_t
{
	ExtRound = 1, ExtRoundEven = 2, ExtTrunc = 3, ExtFAbs = 4, ExtSAbs = 5, ExtFSign = 6, ExtSSign = 7, ExtFloor = 8,
	ExtCeil = 9, ExtFract = 10, ExtRadians = 11, ExtDegrees = 12, ExtSin = 13, ExtCos = 14, ExtTan = 15, ExtAsin = 16,
	ExtAcos = 17, ExtAtan = 18, ExtSinh = 19, ExtCosh = 20, ExtTanh = 21, ExtAsinh = 22, ExtAcosh = 23, ExtAtanh = 24, ExtAtan2 = 25, ExtPow = 26, ExtExp = 27,
	ExtLog = 28, ExtExp2 = 29, ExtLog2 = 30, ExtSqrt = 31, ExtInverseSqrt = 32, ExtDeterminant = 33, ExtModf = 35, ExtModfStruct = 36,
	ExtFMin = 37, ExtUMin = 38, ExtSMin = 39, ExtFMax = 40, ExtUMax = 41, ExtSMax = 42,
	ExtFClamp = 43, ExtUClamp = 44, ExtSClamp = 45, ExtFMix = 46, ExtStep = 48, ExtSmoothStep = 49, ExtFma = 50,
	ExtFrexpStruct = 52, ExtLdexp = 53, ExtPackSnorm4x8 = 54, ExtPackUnorm4x8 = 55, ExtPackSnorm2x16 = 56,
	ExtPackUnorm2x16 = 57, ExtPackHalf2x16 = 58, ExtPackDouble2x32 = 59, ExtUnpackSnorm2x16 = 60,
	ExtUnpackUnorm2x16 = 61, ExtUnpackHalf2x16 = 62, ExtUnpackSnorm4x8 = 63, ExtUnpackUnorm4x8 = 64,
	ExtUnpackDouble2x32 = 65, ExtLength = 66, ExtDistance = 67, ExtCross = 68, ExtNormalize = 69, ExtFaceForward = 70, ExtReflect = 71, ExtRefract = 72,
	ExtFindILsb = 73, ExtFindSMsb = 74, ExtFindUMsb = 75, ExtNMin = 79, ExtNMax = 80, ExtNClamp = 81
};

enum EDecoration : uint32_t
{
	DecorationBlock = 2, DecorationBufferBlock = 3, DecorationRowMajor = 4, DecorationArrayStride = 6,
	DecorationMatrixStride = 7, DecorationBuiltIn = 11, DecorationNonWritable = 24, DecorationLocation = 30,
	DecorationBinding = 33, DecorationOffset = 35, DecorationCounterBuffer = 5634, DecorationUserSemantic = 5635
};

enum EBuiltIn : uint32_t
{
	BuiltInPosition = 0, BuiltInFragCoord = 15, BuiltInFrontFacing = 17, BuiltInFragDepth = 22, BuiltInWorkgroupId = 26,
	BuiltInLocalInvocationId = 27, BuiltInGlobalInvocationId = 28, BuiltInLocalInvocationIndex = 29,
	BuiltInSubgroupSize = 36, BuiltInSubgroupLocalInvocationId = 41,
	BuiltInVertexIndex = 42, BuiltInInstanceIndex = 43, BuiltInNone = ~0u
};

enum EStorage : uint32_t
{
	StorageUniformConstant = 0, StorageInput = 1, StorageUniform = 2, StorageOutput = 3, StorageWorkgroup = 4,
	StoragePrivate = 6, StorageFunction = 7, StorageImage = 11, StorageStorageBuffer = 12
};

enum EDim : uint32_t { Dim1D = 0, Dim2D = 1, Dim3D = 2, DimCube = 3, DimBuffer = 5 };

enum EImageOperand : uint32_t
{
	ImageBias = 1, ImageLod = 2, ImageGrad = 4, ImageConstOffset = 8, ImageOffset = 16, ImageConstOffsets = 32,
	ImageSample = 64, ImageMinLod = 128
};
// clang-format on

constexpr uint32_t Magic = 0x07230203;
constexpr size_t HeaderWords = 5;
constexpr uint32_t ExecutionModeLocalSize = 17;
constexpr uint32_t ExecutionModelVertex = 0;
constexpr uint32_t ExecutionModelFragment = 4;
constexpr uint32_t ExecutionModelCompute = 5;

} // namespace Drydock::Spirv
